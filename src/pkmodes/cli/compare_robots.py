"""``pkmodes compare`` of two robot files: their values, and their frequencies over the poses that both reach."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import named_as_options
from pkmodes.cli.poses import places_given
from pkmodes.cli.printing import signed
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import PkmodesError
from pkmodes.support.motors import motors_of_both
from pkmodes.support.ordering import listed
from pkmodes.support.progress import say

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.maps.poses import Grid, Places
    from pkmodes.maps.robots_compared import ModeChange, RobotsCompared
    from pkmodes.report.sources import Source
    from pkmodes.robot_files.differences import ValueDifference

#: Poses of the workspace, about, and poses at most: all of them are held at once.
POSES, MOST = 20_000, 1_000_000
#: Values that are printed without ``--all``.
LARGEST = 10


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
    from pkmodes.maps.robots_compared import compare_robots, headline
    from pkmodes.robot_files.differences import check_one_mechanism

    sources = sources_of(report_to, dict(zip(("first robot file", "second robot file"), files, strict=True)))
    first, second = map(load, files)
    check_one_mechanism(first.robot, second.robot)
    places = places_given(first, grid, poses)
    with named_as_options("grid", poses="--poses" if poses else "--grid"):
        document = compare_robots(first, second, _points(first, second, places), drives or FREE)
    doing = motors_of_both(first.robot, second.robot, document.drives)
    report = report_file(report_to, lambda: _page(first, second, document, sources, _plane(places)))
    deliver(
        json_file,
        document.as_json(),
        lambda: _print(files, document, everything, headline(document.modes), doing),
        report,
    )


def _points(first: Model, second: Model, places: Places | None) -> np.ndarray:
    from pkmodes.maps.poses import Grid
    from pkmodes.maps.workspace import reachable_by, within

    if places is None:
        places = reachable_by([first, second], POSES)
    count = math.prod(places.shape)
    if count > MOST:
        raise PkmodesError(f"expected at most {MOST:,} poses, found {count:,}", "poses", "give fewer")
    points = np.asarray(places.points(np.arange(count)))
    if isinstance(places, Grid) and places.used:
        points = points[within(first)(points) | within(second)(points)]
    return points


def _plane(places: Places | None) -> Grid | None:
    """Return the given grid if it is a plane."""
    from pkmodes.maps.poses import Grid

    return places if isinstance(places, Grid) and sum(n > 1 for n in places.shape) == 2 else None


def _page(
    first: Model, second: Model, document: RobotsCompared, sources: Sequence[Source], plane: Grid | None
) -> str:
    from pkmodes.report.robots import robots_report

    say("drawing the differences over the working plane")
    return robots_report(first, second, document.as_json(), sources, plane)


def _print(
    files: tuple[Path, Path], document: RobotsCompared, everything: bool, headline: str, doing: str
) -> None:
    from pkmodes.cli.terminal import Terminal

    terminal = Terminal()
    terminal.heading(f"first:  {document.first} ({files[0]})")
    terminal.heading(f"second: {document.second} ({files[1]})")
    terminal.line()
    values = document.values
    differ = "differs:" if len(values) == 1 else "differ:" if values else "differ"
    terminal.line(f"{len(values)} of {document.compared} declared values {differ}")
    shown = values if everything else sorted(values, key=_size)[:LARGEST]
    rows = [
        [
            value.path.removeprefix("effects."),
            _value(value.first),
            _value(value.second),
            "" if value.relative is None else signed(100.0 * value.relative),
            "" if value.unit == "1" else value.unit,
        ]
        for value in shown
    ]
    if rows:
        terminal.table(["value", "first", "second", "diff [%]", "unit"], rows, ("value", "unit"))
    if len(shown) < len(values):
        terminal.line(f"and {len(values) - len(shown)} more: --all, --json or --report")
    spread = [value.path for value in values if _other_sigma(value)]
    if spread:
        most = len(spread) if everything else LARGEST
        terminal.line(f"other standard deviations: {listed(spread, most)}")
    for choice in document.choices:
        terminal.line(f"{choice.path}: {choice.first}, then {choice.second}")
    for what, names in (("added", document.effects_added), ("removed", document.effects_removed)):
        if names:
            terminal.line(f"effects {what}: {', '.join(names)}")
    terminal.line()
    terminal.line(headline)
    poses = document.poses
    terminal.line(
        f"frequencies at {_places(poses.both)} that both reach (the first only: {poses.first_only:,}, the second "
        f"only: {poses.second_only:,}), {doing}, second minus first in per cent of the first:"
    )
    terminal.table(
        ["mode", "partner", "2 %", "median", "98 %", "exchanged", "MAC"],
        [_mode(mode) for mode in document.modes],
    )
    for note in document.notes:
        terminal.line()
        terminal.line(f"note: {note}")
    terminal.line()
    terminal.line(
        "mode: by frequency in the first robot, paired at each pose with a mode of the second by shape (MAC: median "
        "of the pairs); 2 %, 98 %: below it lies that share of the poses; partner: its most frequent number; "
        "exchanged: per cent of the poses at which it has another"
    )


def _places(count: int) -> str:
    return "the one pose" if count == 1 else f"the {count:,} poses"


def _other_sigma(value: ValueDifference) -> bool:
    """Return whether the standard deviations differ, also relative to the values, which a file may state."""
    ours, theirs = value.first_sigma, value.second_sigma
    if ours is None or theirs is None:
        return ours is not theirs
    same = math.isclose(ours * (value.second or 0.0), theirs * (value.first or 0.0), rel_tol=1e-9)
    return ours != theirs and not (same and value.first is not None)


def _size(value: ValueDifference) -> tuple[int, float]:
    """Return the key by which values are sorted: those without a relative difference first, then the largest ones."""
    return (0, 0.0) if value.relative is None else (1, -abs(value.relative))


def _value(value: float | None) -> str:
    return "-" if value is None else f"{value:.6g}"


def _mode(mode: ModeChange) -> list[str]:
    ends = ["-" if value is None else signed(100.0 * value) for value in (mode.low, mode.median, mode.high)]
    partner = "-" if mode.partner is None else str(mode.partner)
    exchanged = "-" if mode.exchanged is None else f"{100.0 * mode.exchanged:.1f}"
    return [str(mode.mode), partner, *ends, exchanged, "-" if mode.mac is None else f"{mode.mac:.3f}"]
