"""``pkmodes shaper``: input shapers for a machine in use, at poses and payloads or for measured modes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click
import numpy as np

from pkmodes.api import load
from pkmodes.cli.delivery import ResultFile, deliver
from pkmodes.cli.options import (
    FILE,
    comma_list,
    json_option,
    mechanism_option,
    named_as_options,
    quantity_option,
    report_option,
)
from pkmodes.cli.poses import grid_option, places_given, poses_option
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.cli.settings import height_given, height_option, settings_given, settings_option
from pkmodes.cli.targets import Target, check_targets, report_target
from pkmodes.core.base.drives import DRIVES
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.extras import require

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from pkmodes.cli.layout import Shown
    from pkmodes.core.model import Model
    from pkmodes.machine.shaping.measured_spectrum import MeasuredSpectrum
    from pkmodes.machine.shaping.results import Choice
    from pkmodes.pages.report.blocks import Summary
    from pkmodes.pages.report.sources import Source

#: Most measured modes printed.
MOST = 10
#: Most poses compared: all are held in memory at once.
POSES = 1_000_000
#: Arguments of `pkmodes.Model.shapers` that have the names of their options.
ARGUMENTS = ("modes", "left", "length", "tick", "firmware", "grid", "damping", "height", "drives")


@dataclass(frozen=True)
class _Result:
    """A choice as JSON, and what makes its page, and the head and blocks that are printed."""

    content: dict[str, Any]
    page: Callable[[], str]
    blocks: Callable[[], tuple[Summary, Sequence[Shown]]]


@click.command(
    epilog="\b\nExamples:\n  pkmodes shaper robots/linear-delta-2022-identified.toml \\\n"
    "    --grid x=0.32:0.82:26,y=-0.1:0.1:11,z=-0.24:-0.16:9\n"
    "  pkmodes shaper robots/clavel-delta.toml --set effects.payload.mass=0:400g:3\n"
    "  pkmodes shaper --measured modes.csv --spectrum psd_x.csv --figure left.png"
)
@click.argument("robot", metavar="[ROBOT.toml]", type=FILE, required=False)
@click.option(
    "--measured",
    metavar="MODES.csv",
    type=FILE,
    help="Measured modes instead of a robot file, such as identify writes: shapers for these, within their errors.",
)
@click.option(
    "--spectrum",
    metavar="FILE",
    type=FILE,
    help="Measured power spectrum over which the report and the figure draw the shapers, such as Klipper's "
    "resonances_x.csv.",
)
@grid_option
@poses_option
@settings_option(
    "A parameter that takes several values in use, such as effects.payload.mass=0:1.2kg:7: a schedule with the "
    "shaper of each, beside those for all; repeat it for several, all of whose combinations count."
)
@height_option
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
    help="How many modes count, the lowest ones at each pose; by default 3, or all that are measured.",
)
@quantity_option(
    "--damping",
    "1",
    "5 %",
    metavar="RATIO",
    help="Damping ratio of measured modes without one; by default anything from 0 to 10 %.",
)
@quantity_option(
    "--left",
    "1",
    "10 %",
    metavar="SHARE",
    default="10 %",
    show_default=True,
    help="What the recommended shaper may leave of the vibration at the worst pose, or of the worst measured mode.",
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
    help="klipper, marlin or reprapfirmware: compare shapers as its current version makes them, and recommend one "
    "that it has; versions before are klipper-2025-09, klipper-2025-08, marlin-2025-09 and reprapfirmware-3.5.",
)
@click.option(
    "--drives",
    type=click.Choice(DRIVES),
    help="What the motors do: turn against the springs that [effects.servo_stiffness] gives them, or be held by "
    "position loops far stiffer than the machine; by default as the robot file has them.  With --measured, what they "
    "did in the test, if the file does not say it; default free.",
)
@mechanism_option
@click.option(
    "--out",
    metavar="FILE.csv",
    type=FILE,
    help="Table to write: what each fixed shaper leaves of a mode, over frequency, and the spectrum if given.",
)
@click.option(
    "--figure",
    metavar="FILE.svg",
    type=FILE,
    help="Picture of it to write; .svg, .png or .pdf.",
)
@report_option
@json_option
def shaper(
    robot: Path | None,
    measured: Path | None,
    spectrum: Path | None,
    grid: str | None,
    poses: Path | None,
    settings: tuple[str, ...],
    height: str | None,
    kinds: str | None,
    modes: int | None,
    damping: float | None,
    left: float,
    length: float | None,
    tick: float,
    firmware: str | None,
    drives: str | None,
    out: Path | None,
    figure: Path | None,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Choose an input shaper: the best fixed one of each kind, beside those that follow the pose.

    Motors give way on their springs where the robot file has [effects.servo_stiffness], and are held where it has
    none.  Prints what each leaves of the vibration, and lines for the firmware of printers.

    With --set, as of a payload that grows, also a schedule: the best fixed shaper for each value.

    With --measured there is no model: the best fixed shapers for the modes in the table, with what each leaves of
    them within two standard deviations.
    """
    targets = (
        Target("--out", out, "the table", (".csv",)),
        Target("--figure", figure, "the picture", (".svg", ".png", ".pdf")),
        report_target(report_to),
    )
    check_targets(json_file, [robot, measured, spectrum, poses], *targets)
    of_robot = {"--grid": grid, "--poses": poses, "--set": settings or None, "--height": height}
    foreign = of_robot if measured else {"--damping": damping}
    _check_source(robot, measured, foreign)
    sources = sources_of(
        report_to, {"robot file": robot, "measurement file": measured, "measured spectrum": spectrum}
    )
    measured_spectrum = None
    if spectrum is not None:
        from pkmodes.machine.shaping.measured_spectrum import read_spectrum

        measured_spectrum = read_spectrum(spectrum)
    names = None if kinds is None else comma_list(kinds, "--shapers", "--shapers zv,mzv,zv*zv")
    criteria: dict[str, Any] = {
        "modes": modes,
        "left": left,
        "length": length,
        "tick": tick,
        "firmware": firmware,
    }
    with named_as_options(
        *ARGUMENTS,
        kind="--shapers",
        kinds="--shapers",
        poses="--poses" if poses else "--grid",
        settings="--set",
    ):
        if measured is not None:
            from pkmodes.loop.updating.reading import read_any
            from pkmodes.machine.shaping.measured_modes import measured_shapers

            choice = measured_shapers(read_any(measured, drives=drives), names, damping=damping, **criteria)
            result = _of_measured(choice, measured_spectrum, sources)
        else:
            model = load(cast("Path", robot))
            swept = settings_given(model, settings)
            layers = height_given(model, height, swept)
            points = _points(model, grid, poses, swept)
            choice = model.shapers(points, names, settings=swept, height=layers, drives=drives, **criteria)
            result = _of_robot(model, choice, measured_spectrum, sources)
    from pkmodes.pages.report.shaper_curves import curves_csv

    picture = b"" if figure is None else _picture(choice, measured_spectrum, figure)
    files = [
        ResultFile(out, lambda: curves_csv(choice, measured_spectrum)),
        ResultFile(figure, lambda: picture),
        report_file(report_to, result.page),
    ]
    deliver(json_file, result.content, lambda: _print(result), *files)


def _points(
    model: Model, grid: str | None, poses: Path | None, swept: Mapping[str, Any] | None
) -> NDArray[np.float64]:
    """Return the poses, by default those of the workspace that can be evaluated."""
    from pkmodes.machine.maps.workspace import reachable, within

    places = places_given(model, grid, poses)
    times = math.prod(len(values) for values in (swept or {}).values())
    count = 0 if places is None else math.prod(places.shape) * times
    if count > POSES:
        of = "poses" if times == 1 else "poses times values"
        problem = f"expected at most {POSES:,} {of}, found {count:,}"
        raise PkmodesError(
            problem, "--grid" if grid else "--poses", "give fewer: shapers differ little between neighbours"
        )
    if places is not None:
        return np.asarray(places.points(np.arange(int(np.prod(places.shape)))))
    whole = reachable(model)
    points = whole.points(np.arange(int(np.prod(whole.shape))))
    return np.asarray(points[model.check(points).valid & within(model)(points)])


def _check_source(robot: Path | None, measured: Path | None, foreign: Mapping[str, object]) -> None:
    """Refuse two sources of modes or none, and options that are of the other one."""
    context = click.get_current_context()
    if (robot is None) == (measured is None):
        problem = "--measured takes the place of ROBOT.toml: give one of them"
        raise click.UsageError(problem if robot else "give ROBOT.toml, or --measured MODES.csv", context)
    if robot is not None and robot.suffix.lower() == ".csv":
        problem = f"expected ROBOT.toml, found {shown(str(robot))}: measured modes are given by --measured"
        raise click.UsageError(problem, context)
    of = "measured modes" if measured is None else "a robot file"
    for option in (name for name, value in foreign.items() if value is not None):
        raise click.UsageError(f"{option} is for {of}", context)


def _of_robot(
    model: Model, choice: Choice, spectrum: MeasuredSpectrum | None, sources: Sequence[Source]
) -> _Result:
    from pkmodes.cli.shaper_documents import shaper_document

    content = shaper_document(model, choice, spectrum).as_json()

    def page() -> str:
        from pkmodes.pages.report.shaper import shaper_report

        return shaper_report(model, choice, content, sources, spectrum)

    def blocks() -> tuple[Summary, Sequence[Shown]]:
        from pkmodes.pages.report.firmware_lines import firmware_lines, schedule_lines
        from pkmodes.pages.report.shaper import machine, shaper_summary, shapers_table
        from pkmodes.pages.report.shaper_schedule import schedule_blocks

        printed: list[Shown] = [
            machine(model, choice, content),
            shapers_table(choice),
            *schedule_blocks(choice),
            *firmware_lines(content),
            *schedule_lines(content),
        ]
        return shaper_summary(model, choice, content), printed

    return _Result(content, page, blocks)


def _of_measured(choice: Choice, spectrum: MeasuredSpectrum | None, sources: Sequence[Source]) -> _Result:
    from pkmodes.cli.shaper_documents import measured_document

    content = measured_document(choice, spectrum).as_json()

    def page() -> str:
        from pkmodes.pages.report.shaper_measured import measured_shaper_report

        return measured_shaper_report(choice, content, sources, spectrum)

    def blocks() -> tuple[Summary, Sequence[Shown]]:
        from pkmodes.pages.report.firmware_lines import firmware_lines
        from pkmodes.pages.report.shaper_measured import measured_shaper_summary, modes_table, shapers_table

        printed: list[Shown] = [shapers_table(choice), modes_table(content, MOST), *firmware_lines(content)]
        return measured_shaper_summary(choice, content), printed

    return _Result(content, page, blocks)


def _picture(choice: Choice, spectrum: MeasuredSpectrum | None, figure: Path) -> bytes:
    """Return the picture as a file."""
    require("pictures of shapers", "plot", "matplotlib")
    from pkmodes.pages.figures.files import rendered
    from pkmodes.pages.figures.pictures import Picture
    from pkmodes.pages.report.shaper_curves import over_frequency

    drawing, caption = over_frequency(choice, spectrum)
    picture = Picture("shapers", "Input shapers", caption, drawing)
    return rendered(picture, figure.suffix[1:].lower())


def _print(result: _Result) -> None:
    from pkmodes.cli.terminal import Terminal

    terminal = Terminal()
    head, blocks = result.blocks()
    terminal.summary(head)
    terminal.show(*blocks)
    terminal.notes(head)
