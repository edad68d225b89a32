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
from pkmodes.cli.option_table import OptionTable, entry, option
from pkmodes.cli.options import PATH, comma_list, forwarded_mechanism_option, quantity_parser
from pkmodes.cli.poses import grid_option, poses_option, selected_poses
from pkmodes.cli.reporting import report_file
from pkmodes.cli.settings import height_option, parse_height_option, parse_settings_option, settings_option
from pkmodes.core.base.drives import DRIVES
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.extras import require

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from pkmodes.cli.layout import TerminalBlock
    from pkmodes.core.model import Model
    from pkmodes.machine.shaping.measured_spectrum import MeasuredSpectrum
    from pkmodes.machine.shaping.results import Choice
    from pkmodes.pages.report.blocks import Summary
    from pkmodes.pages.report.sources import Source

#: Maximum number of measured modes printed.
MAX_PRINTED_MODES = 10
#: Maximum number of poses compared: all are held in memory at once.
MAX_POSES = 1_000_000
#: Sources of the modes; some options apply to only one.
ROBOT, MEASURED = "a robot file", "measured modes"


@dataclass(frozen=True)
class ShaperOptions(OptionTable):
    """Arguments and options of the command; those marked `passed` are arguments of `pkmodes.Model.shapers`."""

    robot: Path | None = entry(
        click.argument("robot", metavar="[ROBOT.toml]", type=PATH, required=False), reads="robot file"
    )
    measured: Path | None = option(
        "--measured",
        metavar="MODES.csv",
        type=PATH,
        reads="measurement file",
        help="Measured modes instead of a robot file, as identify writes them: shapers for these modes, within "
        "their errors.",
    )
    spectrum: Path | None = option(
        "--spectrum",
        metavar="FILE",
        type=PATH,
        reads="measured spectrum",
        help="Measured power spectrum over which the report and the figure draw the shapers, such as Klipper's "
        "resonances_x.csv.",
    )
    grid: str | None = entry(grid_option, only=ROBOT)
    poses: Path | None = entry(poses_option, only=ROBOT, reads="")
    settings: tuple[str, ...] = entry(
        settings_option(
            "Parameter that takes several values in use, such as effects.payload.mass=0:1.2kg:7: a schedule "
            "with a shaper for each value, beside the shapers for all values; repeat for several parameters, "
            "all of whose combinations count."
        ),
        only=ROBOT,
    )
    height: str | None = entry(height_option, only=ROBOT)
    kinds: str | None = option(
        "--shapers",
        "kinds",
        metavar="KIND,...",
        help="Kinds to compare: zv, zvd, zvdd, mzv, ei, 2hump_ei, 3hump_ei, or products such as zv*zv, with one "
        "factor for each mode; by default all of these.",
    )
    modes: int | None = option(
        "--modes",
        metavar="N",
        type=click.IntRange(1),
        passed=True,
        help="Number of modes that count, the lowest at each pose; by default 3, or all that are measured.",
    )
    damping: float | None = option(
        "--damping",
        metavar="RATIO",
        callback=quantity_parser("1", "5 %"),
        passed=True,
        only=MEASURED,
        help="Damping ratio of measured modes that have none in the table; by default anything from 0 to 10 %.",
    )
    left: float = option(
        "--left",
        metavar="SHARE",
        callback=quantity_parser("1", "10 %"),
        default="10 %",
        show_default=True,
        passed=True,
        help="Largest share of the largest vibration that the recommended shaper may leave, or of the worst "
        "measured mode.",
    )
    length: float | None = option(
        "--length",
        metavar="TIME",
        callback=quantity_parser("s", "60 ms"),
        passed=True,
        help='Longest duration of the recommended shaper: "60 ms", or a number in s.',
    )
    tick: float = option(
        "--tick",
        metavar="TIME",
        callback=quantity_parser("s", "1 ms"),
        default="1 ms",
        show_default=True,
        passed=True,
        help="Time between two commands of the controller; shapers shorter than two ticks are left out.",
    )
    firmware: str | None = option(
        "--firmware",
        metavar="NAME",
        passed=True,
        help="klipper, marlin or reprapfirmware: compare shapers as the current version of this firmware makes "
        "them, and recommend one that it has; earlier versions are klipper-2025-09, klipper-2025-08, "
        "marlin-2025-09 and reprapfirmware-3.5.",
    )
    drives: str | None = option(
        "--drives",
        type=click.Choice(DRIVES),
        help="Motors: free to turn against the springs of [effects.servo_stiffness], or held by position loops "
        "far stiffer than the machine; by default as the robot file has them.  With --measured: motors in "
        "the test, if the file does not state it; by default free.",
    )
    mechanism: Path | None = entry(forwarded_mechanism_option)
    out: Path | None = option(
        "--out",
        metavar="FILE.csv",
        type=PATH,
        writes="the table",
        endings=(".csv",),
        help="Table to write: what each fixed shaper leaves of a mode, over the frequency of the mode, and the "
        "spectrum if given.",
    )
    figure: Path | None = option(
        "--figure",
        metavar="FILE.svg",
        type=PATH,
        writes="the picture",
        endings=(".svg", ".png", ".pdf"),
        help="Picture to write, of the same curves as in --out; .svg, .png or .pdf.",
    )

    @property
    def kind_names(self) -> list[str] | None:
        """Names of the shapers; None for all."""
        return None if self.kinds is None else comma_list(self.kinds, "--shapers", "--shapers zv,mzv,zv*zv")


@dataclass(frozen=True)
class _Result:
    """A choice, its JSON, and functions that render its page and its terminal output."""

    choice: Choice
    content: dict[str, Any]
    page: Callable[[], str]
    blocks: Callable[[], tuple[Summary, Sequence[TerminalBlock]]]


@click.command(
    epilog="\b\nExamples:\n  pkmodes shaper robots/linear-delta-2022-identified.toml \\\n    --grid "
    "x=0.32:0.82:26,y=-0.1:0.1:11,z=-0.24:-0.16:9\n  pkmodes shaper robots/clavel-delta.toml --set "
    "effects.payload.mass=0:400g:3\n  pkmodes shaper --measured modes.csv --spectrum psd_x.csv --figure "
    "left.png"
)
@ShaperOptions.add_to
def shaper(options: ShaperOptions) -> None:
    """Choose an input shaper: the best fixed shaper of each kind, beside those that follow the pose.

    Motors yield on their springs where the robot file has [effects.servo_stiffness], and are held where it has
    none.  Prints the vibration that each shaper leaves, and lines for the firmware of printers.

    With --set, such as for a payload that grows, prints a schedule, too: the best fixed shaper for each value.

    With --measured there is no model: prints the best fixed shapers for the modes in the table, with what each leaves
    of these modes within two standard deviations.
    """
    options.check_files()
    robot, measured, context = options.robot, options.measured, click.get_current_context()
    if (robot is None) == (measured is None):
        problem = "--measured takes the place of ROBOT.toml: give one of them"
        raise click.UsageError(problem if robot else "give ROBOT.toml, or --measured MODES.csv", context)
    if robot is not None and robot.suffix.lower() == ".csv":
        problem = f"expected ROBOT.toml, found {shown(str(robot))}: measured modes are given by --measured"
        raise click.UsageError(problem, context)
    options.check_only(ROBOT if measured is None else MEASURED)
    sources = options.sources()
    spectrum = None
    if options.spectrum is not None:
        from pkmodes.machine.shaping.measured_spectrum import read_spectrum

        spectrum = read_spectrum(options.spectrum)
    with options.name_in_errors(kind="--shapers", poses="--poses" if options.poses else "--grid"):
        choose = _shapers_for_robot if measured is None else _shapers_for_measured
        result = choose(options, spectrum, sources)
    from pkmodes.pages.report.shaper_curves import curves_csv, frequency_figure

    picture = b""
    if options.figure is not None:
        require("pictures of shapers", "plot", "matplotlib")
        from pkmodes.pages.figures.files import image_bytes
        from pkmodes.pages.figures.pictures import Picture

        drawing, caption = frequency_figure(result.choice, spectrum)
        image_format = options.figure.suffix[1:].lower()
        picture = image_bytes(Picture("shapers", "Input shapers", caption, drawing), image_format)

    def show() -> None:
        from pkmodes.cli.terminal import Terminal

        head, blocks = result.blocks()
        Terminal().result(head, *blocks)

    files = [
        ResultFile(options.out, lambda: curves_csv(result.choice, spectrum)),
        ResultFile(options.figure, lambda: picture),
        report_file(options.report_to, result.page),
    ]
    deliver(options.json_file, result.content, show, *files)


def _shapers_for_robot(
    options: ShaperOptions, spectrum: MeasuredSpectrum | None, sources: Sequence[Source]
) -> _Result:
    """Choose shapers for the modes of a robot file."""
    from pkmodes.cli.shaper_contents import shaper_document

    kinds = options.kind_names  # refused before a file is read
    model = load(cast("Path", options.robot))
    settings = parse_settings_option(model, options.settings)
    heights = parse_height_option(model, options.height, settings)
    poses = _poses(model, options.grid, options.poses, settings)
    choice = model.shapers(
        poses,
        kinds,
        settings=settings,
        height=heights,
        drives=options.drives,
        **options.call_arguments(ROBOT),
    )
    content = shaper_document(model, choice, spectrum).as_json()

    def page() -> str:
        from pkmodes.pages.report.shaper import shaper_report

        return shaper_report(model, choice, content, sources, spectrum)

    def blocks() -> tuple[Summary, Sequence[TerminalBlock]]:
        from pkmodes.pages.report.firmware_lines import firmware_lines, schedule_lines
        from pkmodes.pages.report.shaper import machine_facts, shaper_summary, shapers_tables
        from pkmodes.pages.report.shaper_schedule import schedule_blocks

        printed: list[TerminalBlock] = [
            machine_facts(model, choice, content),
            *shapers_tables(choice),
            *schedule_blocks(choice),
            *firmware_lines(content),
            *schedule_lines(content),
        ]
        return shaper_summary(model, choice, content), printed

    return _Result(choice, content, page, blocks)


def _poses(
    model: Model, grid: str | None, poses: Path | None, settings: Mapping[str, Any] | None
) -> NDArray[np.float64]:
    """Return the selected poses, by default the usable ones of the workspace."""
    from pkmodes.machine.maps.workspace import grid_over_workspace, limits_test

    pose_selection = selected_poses(model, grid, poses)
    combinations = math.prod(len(values) for values in (settings or {}).values())
    count = 0 if pose_selection is None else math.prod(pose_selection.shape) * combinations
    if count > MAX_POSES:
        noun = "poses" if combinations == 1 else "poses times values"
        problem = f"expected at most {MAX_POSES:,} {noun}, found {count:,}"
        raise PkmodesError(
            problem, "--grid" if grid else "--poses", "give fewer: shapers differ little between neighbours"
        )
    if pose_selection is not None:
        return np.asarray(pose_selection.points(np.arange(int(np.prod(pose_selection.shape)))))
    workspace_grid = grid_over_workspace(model)
    workspace_poses = workspace_grid.points(np.arange(int(np.prod(workspace_grid.shape))))
    return np.asarray(
        workspace_poses[model.check(workspace_poses).valid & limits_test(model)(workspace_poses)]
    )


def _shapers_for_measured(
    options: ShaperOptions, spectrum: MeasuredSpectrum | None, sources: Sequence[Source]
) -> _Result:
    """Choose shapers for measured modes."""
    from pkmodes.cli.shaper_contents import measured_document
    from pkmodes.loop.updating.reading import read_any
    from pkmodes.machine.shaping.measured_modes import measured_shapers

    kinds = options.kind_names  # refused before a file is read
    data = read_any(cast("Path", options.measured), drives=options.drives)
    choice = measured_shapers(data, kinds, **options.call_arguments(MEASURED))
    content = measured_document(choice, spectrum).as_json()

    def page() -> str:
        from pkmodes.pages.report.shaper_measured import measured_shaper_report

        return measured_shaper_report(choice, content, sources, spectrum)

    def blocks() -> tuple[Summary, Sequence[TerminalBlock]]:
        from pkmodes.pages.report.firmware_lines import firmware_lines
        from pkmodes.pages.report.shaper_measured import measured_shaper_summary, modes_table, shapers_table

        printed: list[TerminalBlock] = [
            shapers_table(choice),
            modes_table(content, MAX_PRINTED_MODES),
            *firmware_lines(content),
        ]
        return measured_shaper_summary(choice, content), printed

    return _Result(choice, content, page, blocks)
