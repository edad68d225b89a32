"""``pkmodes shaper``: input shapers for a machine with held motors, compared over the workspace."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import click
import numpy as np
from msgspec import Meta

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import (
    comma_list,
    json_option,
    mechanism_option,
    named_as_options,
    quantity_option,
    report_option,
    robot_argument,
)
from pkmodes.cli.poses import grid_option, places_given, poses_option
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.cli.targets import check_targets, report_target
from pkmodes.core.base.drives import Drives
from pkmodes.core.base.errors import PkmodesError
from pkmodes.support.documents import Count, Document, Size

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from pkmodes.core.model import Model
    from pkmodes.shaping.choice import Candidate, Choice

#: Poses that are compared at most: all of them are held at once.
POSES = 1_000_000
#: Arguments of `pkmodes.Model.shapers` that have the names of their options.
ARGUMENTS = ("modes", "left", "length", "tick", "firmware", "grid")


class UnshapedDocument(Document, frozen=True):
    """Vibration of the platform without a shaper, for a step of its acceleration by 1 m/s^2."""

    rms: Annotated[Size, Meta(description="Root mean square over the poses [s^2].")]
    worst: Annotated[Size, Meta(description="Largest value [s^2].")]
    pose: Annotated[list[float], Meta(description="Where it is largest, in SI units.")]


class LeftDocument(Document, frozen=True):
    """Vibration that a shaper leaves, relative to none."""

    rms: Annotated[Size, Meta(description="Root mean square over that without a shaper.")]
    worst: Annotated[Size, Meta(description="Largest value over the largest without a shaper.")]
    pose: Annotated[list[float], Meta(description="Where most is left, in SI units.")]
    rms_uncertain: Annotated[
        Size | None,
        Meta(
            description="rms with frequencies spread by the standard deviations of the robot file; null without any."
        ),
    ]


class CandidateDocument(Document, frozen=True):
    """A shaper."""

    kind: Annotated[str, Meta(description="Such as zv, or zv*zv for two modes.")]
    follows_pose: Annotated[bool, Meta(description="Whether it is designed anew for the modes of each pose.")]
    frequencies_hz: Annotated[
        list[float] | None,
        Meta(
            description="Of the design, one for each factor [Hz]; null if it follows the pose, as the next three."
        ),
    ]
    damping_ratios: Annotated[list[float] | None, Meta(description="Of the design, likewise.")]
    amplitudes: Annotated[list[float] | None, Meta(description="Of the impulses; their sum is 1.")]
    delays_s: Annotated[list[float] | None, Meta(description="Of the impulses [s].")]
    duration_s: Annotated[Size, Meta(description="Delay of the last impulse [s]; the longest of all poses.")]
    left: Annotated[LeftDocument, Meta(description="Vibration that it leaves.")]


class ShaperDocument(Document, frozen=True):
    """Shapers for the modes of held motors, compared over poses."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    drives: Drives
    poses: Annotated[Count, Meta(description="Number of poses that count.")]
    modes: Annotated[Count, Meta(description="Number of modes that count, the lowest.")]
    unshaped: Annotated[UnshapedDocument, Meta(description="Without a shaper.")]
    shapers: Annotated[
        list[CandidateDocument],
        Meta(description="The best fixed one of each kind, then those that follow the pose."),
    ]
    recommended: Annotated[Count, Meta(description="Index of the recommended one, which is fixed.")]
    firmware: Annotated[
        dict[str, str | None],
        Meta(description="Lines for klipper, marlin and reprapfirmware; null where it has no such shaper."),
    ]
    notes: Annotated[list[str], Meta(description="What the reader should know.")]


@click.command(
    epilog="\b\nExample:\n  pkmodes shaper robots/linear-delta-2022-identified.toml \\\n"
    "    --grid x=0.32:0.82:26,y=-0.1:0.1:11,z=-0.24:-0.16:9"
)
@robot_argument
@grid_option
@poses_option
@click.option(
    "--shapers",
    "kinds",
    metavar="KIND,...",
    help="zv, zvd, zvdd, mzv, ei, 2hump_ei, 3hump_ei, or products such as zv*zv for as many modes; by default all "
    "of these.",
)
@click.option(
    "--modes",
    metavar="N",
    type=click.IntRange(1),
    help="How many modes count, the lowest ones; by default 3.",
)
@quantity_option(
    "--left",
    "1",
    "10 %",
    metavar="SHARE",
    default="10 %",
    show_default=True,
    help="What the recommended shaper may leave of the vibration at the worst pose.",
)
@quantity_option(
    "--length",
    "s",
    "60 ms",
    metavar="TIME",
    help='How long the recommended shaper may last: "60 ms", or a number in s.',
)
@quantity_option(
    "--tick",
    "s",
    "1 ms",
    metavar="TIME",
    default="1 ms",
    show_default=True,
    help="Time between two commands of the controller; shapers shorter than two are left out.",
)
@click.option(
    "--firmware",
    metavar="NAME",
    help="klipper, marlin or reprapfirmware: recommend only a shaper that it has.",
)
@mechanism_option
@report_option
@json_option
def shaper(
    robot: Path,
    grid: str | None,
    poses: Path | None,
    kinds: str | None,
    modes: int | None,
    left: float,
    length: float | None,
    tick: float,
    firmware: str | None,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Choose an input shaper: the best fixed one of each kind, beside those that follow the pose.

    Motors are held.  Prints what each leaves of the vibration, and lines for the firmware of printers.
    """
    check_targets(json_file, [robot, poses], report_target(report_to))
    sources = sources_of(report_to, {"robot file": robot})
    model = load(robot)
    with named_as_options(
        *ARGUMENTS, kind="--shapers", kinds="--shapers", poses="--poses" if poses else "--grid"
    ):
        points = _points(model, grid, poses)
        names = None if kinds is None else comma_list(kinds, "--shapers", "--shapers zv,mzv,zv*zv")
        choice = model.shapers(
            points, names, modes=modes, left=left, length=length, tick=tick, firmware=firmware
        )
    content = _document(model, choice).as_json()
    report = report_file(report_to, lambda: _page(model, choice, content, sources))
    deliver(json_file, content, lambda: _print(model, choice, content), report)


def _points(model: Model, grid: str | None, poses: Path | None) -> NDArray[np.float64]:
    """Return the poses, by default those of the workspace that can be evaluated."""
    from pkmodes.maps.workspace import reachable, within

    places = places_given(model, grid, poses)
    count = 0 if places is None else math.prod(places.shape)
    if count > POSES:
        what = f"expected at most {POSES:,} poses, found {count:,}"
        raise PkmodesError(
            what, "--grid" if grid else "--poses", "give fewer: shapers differ little between neighbours"
        )
    if places is not None:
        return np.asarray(places.points(np.arange(int(np.prod(places.shape)))))
    whole = reachable(model)
    points = whole.points(np.arange(int(np.prod(whole.shape))))
    return np.asarray(points[model.check(points).valid & within(model)(points)])


def _document(model: Model, choice: Choice) -> ShaperDocument:
    from pkmodes.shaping.choice import lines_of
    from pkmodes.shaping.remarks import remarks

    best = choice.candidates[choice.recommended]
    return ShaperDocument(
        robot=model.robot.name,
        drives="held",
        poses=len(choice.ringing.poses),
        modes=choice.ringing.frequencies.shape[1],
        unshaped=UnshapedDocument.of(choice.unshaped),
        shapers=[_candidate(one) for one in choice.candidates],
        recommended=choice.recommended,
        firmware=lines_of(best),
        notes=[*choice.notes, *remarks(choice)],
    )


def _candidate(one: Candidate) -> CandidateDocument:
    fixed = not one.follows_pose
    return CandidateDocument.of(
        one,
        frequencies_hz=list(one.frequencies) if fixed else None,
        damping_ratios=[one.damping_ratio] * len(one.frequencies) if fixed else None,
        amplitudes=one.shaper.amplitudes.tolist() if fixed else None,
        delays_s=one.shaper.delays.tolist() if fixed else None,
        duration_s=one.duration,
        left=LeftDocument.of(one.left),
    )


def _page(model: Model, choice: Choice, content: dict[str, Any], sources: Any) -> str:
    from pkmodes.report.shaper import shaper_report

    return shaper_report(model, choice, content, sources)


def _print(model: Model, choice: Choice, content: dict[str, Any]) -> None:
    from pkmodes.cli.terminal import Terminal
    from pkmodes.report.shaper import firmware_lines, machine, shapers_table, summary

    terminal, head = Terminal(), summary(model, choice, content)
    terminal.summary(head)
    terminal.show(machine(model, choice, content), shapers_table(choice), *firmware_lines(content))
    terminal.notes(head)
