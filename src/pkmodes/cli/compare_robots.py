"""``pkmodes compare`` of two robot files: their values, and their frequencies over the poses that both reach."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import errors_name_options
from pkmodes.cli.poses import places_given
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.support.progress import say

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.maps.poses import MapPoses

#: Approximate number of poses in a workspace, and maximum number of poses compared: all are held in memory at once.
DEFAULT_POSES, MAX_POSES = 20_000, 1_000_000
#: Maximum number of values printed without ``--all``.
MAX_VALUES_PRINTED = 10


def compare_robot_files(
    files: tuple[Path, Path],
    grid: str | None,
    poses: Path | None,
    drives: str | None,
    everything: bool,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Compare two robot files, and print, write and draw what differs."""
    from pkmodes.loop.robot_files.differences import check_one_mechanism
    from pkmodes.machine.maps.robots_compared import compare_robots

    sources = sources_of(report_to, dict(zip(("first robot file", "second robot file"), files, strict=True)))
    first, second = map(load, files)
    check_one_mechanism(first.robot, second.robot)
    map_poses = places_given(first, grid, poses)
    with errors_name_options("grid", "drives", poses="--poses" if poses else "--grid"):
        document = compare_robots(first, second, _points(first, second, map_poses), drives)
    content = document.as_json()

    def page() -> str:
        from pkmodes.machine.maps.poses import PoseGrid
        from pkmodes.pages.report.robots import robots_report

        say("drawing the differences over the working plane")
        plane = (
            map_poses
            if isinstance(map_poses, PoseGrid) and sum(n > 1 for n in map_poses.shape) == 2
            else None
        )
        return robots_report(first, second, content, sources, plane)

    def show() -> None:
        from pkmodes.cli.terminal import Terminal
        from pkmodes.pages.report.robot_values import different_values, frequencies, robots_summary

        terminal, limit = Terminal(), None if everything else MAX_VALUES_PRINTED
        terminal.heading(f"first:  {content['first']} ({files[0]})")
        terminal.heading(f"second: {content['second']} ({files[1]})")
        terminal.line()
        blocks = [*different_values(first, content, limit), *frequencies(content)]
        terminal.result(robots_summary(first, second, content), *blocks)

    deliver(json_file, content, show, report_file(report_to, page))


def _points(first: Model, second: Model, map_poses: MapPoses | None) -> np.ndarray:
    """Return the poses, by default those of the workspaces that one of the robots uses."""
    from pkmodes.machine.maps.poses import PoseGrid
    from pkmodes.machine.maps.workspace import grid_over_workspaces, limits_test

    if map_poses is None:
        map_poses = grid_over_workspaces([first, second], DEFAULT_POSES)
    count = math.prod(map_poses.shape)
    if count > MAX_POSES:
        raise PkmodesError(f"expected at most {MAX_POSES:,} poses, found {count:,}", "poses", "give fewer")
    points = np.asarray(map_poses.points(np.arange(count)))
    if isinstance(map_poses, PoseGrid) and map_poses.usable_only:
        points = points[limits_test(first)(points) | limits_test(second)(points)]
    return points
