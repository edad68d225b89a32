"""``pkmodes compare`` of two robot files: their values, and their frequencies over the poses that both reach."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import rename_arguments_in_errors
from pkmodes.cli.poses import selected_poses
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.support.progress import report_progress

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.maps.poses import MapPoses

#: Approximate number of poses by default, and maximum number of poses compared: all are held in memory at once.
DEFAULT_POSE_COUNT, MAX_POSES = 20_000, 1_000_000
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
    pose_selection = selected_poses(first, grid, poses)
    with rename_arguments_in_errors("grid", "drives", poses="--poses" if poses else "--grid"):
        document = compare_robots(first, second, _compared_poses(first, second, pose_selection), drives)
    content = document.as_json()

    def page() -> str:
        from pkmodes.machine.maps.poses import PoseGrid
        from pkmodes.pages.report.robots import robots_report

        report_progress("drawing the differences over the working plane")
        plane = (
            pose_selection
            if isinstance(pose_selection, PoseGrid) and sum(n > 1 for n in pose_selection.shape) == 2
            else None
        )
        return robots_report(first, second, content, sources, plane)

    def show() -> None:
        from pkmodes.cli.terminal import Terminal
        from pkmodes.pages.report.robot_values import (
            different_value_blocks,
            frequency_difference_blocks,
            robots_summary,
        )

        terminal, limit = Terminal(), None if everything else MAX_VALUES_PRINTED
        terminal.heading(f"first:  {content['first']} ({files[0]})")
        terminal.heading(f"second: {content['second']} ({files[1]})")
        terminal.line()
        blocks = [*different_value_blocks(first, content, limit), *frequency_difference_blocks(content)]
        terminal.result(robots_summary(first, second, content), *blocks)

    deliver(json_file, content, show, report_file(report_to, page))


def _compared_poses(first: Model, second: Model, pose_selection: MapPoses | None) -> np.ndarray:
    """Return the selected poses, by default those of both workspaces that one of the robots can use."""
    from pkmodes.machine.maps.poses import PoseGrid
    from pkmodes.machine.maps.workspace import grid_over_workspaces, limits_test

    if pose_selection is None:
        pose_selection = grid_over_workspaces([first, second], DEFAULT_POSE_COUNT)
    count = math.prod(pose_selection.shape)
    if count > MAX_POSES:
        raise PkmodesError(f"expected at most {MAX_POSES:,} poses, found {count:,}", "poses", "give fewer")
    compared_poses = np.asarray(pose_selection.points(np.arange(count)))
    if isinstance(pose_selection, PoseGrid) and pose_selection.usable_only:
        compared_poses = compared_poses[
            limits_test(first)(compared_poses) | limits_test(second)(compared_poses)
        ]
    return compared_poses
