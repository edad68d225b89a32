"""``pkmodes compare``: a robot with its measurements, paired and with their significance, or with another robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from pkmodes.cli.compare_robots import compare_robot_files
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import (
    PATH,
    band_option,
    check_file_order,
    json_option,
    measured_drives_option,
    mechanism_option,
    parse_band_option,
    report_option,
    robot_argument,
)
from pkmodes.cli.poses import grid_option, poses_option
from pkmodes.cli.reporting import page_of, report_file, sources_of
from pkmodes.cli.targets import check_targets, report_target
from pkmodes.core.robot.reading import read_robot

if TYPE_CHECKING:
    from pkmodes.core.robot.robot import Robot
    from pkmodes.loop.diagnosis import Comparison, Measurements


#: Maximum number of rows printed without ``--all``: of a robot and its measurements, and of two measurement files.
MAX_MEASURED_ROWS, MAX_PAIRED_ROWS = 5, 10


@click.command(
    epilog="\b\nExamples:\n"
    "  pkmodes compare examples/closed_loop/robot.toml \\\n    examples/closed_loop/measured.csv\n"
    "  pkmodes compare robots/linear-delta-2022.toml \\\n    robots/linear-delta-2022-identified.toml"
)
@robot_argument
@click.argument("modes", metavar="MODES.csv|ROBOT.toml", type=PATH)
@grid_option
@poses_option
@band_option
@measured_drives_option
@mechanism_option
@click.option(
    "--all",
    "everything",
    is_flag=True,
    help="Print every measured mode, or every value of two robots, not only those that differ most.",
)
@report_option
@json_option
def compare(
    robot: Path,
    modes: Path,
    grid: str | None,
    poses: Path | None,
    band: str | None,
    drives: str | None,
    everything: bool,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Compare predicted and measured modes without fitting anything, or two measurements, or two robots.

    Measured modes are paired with predicted modes by frequency and, if measured, by shape.  The exit code is 0
    however much they differ; scripts can use p_value in the JSON, or diagnose --fail-on.

    Two measurement files, such as before and after a repair, are compared pose by pose: which modes changed, and
    whether by more than their stated errors.

    Two robot files are compared by what they declare and by their frequencies at the poses that both can reach: those
    of --grid or --poses, by default those of their workspaces.  Modes are paired by their shapes.
    """
    if robot.suffix.lower() == modes.suffix.lower() == ".csv":
        check_targets(json_file, [robot, modes, poses], report_target(report_to))
        for option, value in {"--grid": grid, "--poses": poses}.items():
            _refuse(value, option, "does not apply to two measurement files")
        _compare_measurements(
            (robot, modes), parse_band_option(band), drives, everything, report_to, json_file
        )
        return
    check_file_order(robot, modes, "pkmodes compare")
    check_targets(json_file, [robot, modes, poses], report_target(report_to))
    if modes.suffix.lower() == ".toml":
        _refuse(band, "--band", "is for measurements, but two robots are compared")
        compare_robot_files((robot, modes), grid, poses, drives, everything, report_to, json_file)
        return
    _refuse(grid, "--grid", "is for two robots; measurements have their own poses")
    _refuse(poses, "--poses", "is for two robots; measurements have their own poses")
    from pkmodes.loop import updating  # SciPy is loaded only where it is used

    declared = read_robot(robot)
    data = updating.read(modes, parse_band_option(band), declared, drives=drives)
    sources = sources_of(report_to, {"robot file": robot, "measurement file": modes})
    result = updating.compare(declared, data)
    report = report_file(report_to, lambda: page_of(result, declared, data, sources))
    content, limit = result.as_json(declared.name), len(result.rows) if everything else MAX_MEASURED_ROWS
    deliver(json_file, content, lambda: show_comparison(declared, data, result, limit), report)


def show_comparison(robot: Robot, data: Measurements, result: Comparison, limit: int) -> None:
    """Print a comparison, with the measured modes that differ most, or all in the order of the poses."""
    from pkmodes.cli.measured_rows import rows_in_words, settings_in_words
    from pkmodes.cli.terminal import Terminal
    from pkmodes.pages.plots.evidence import PlottedEvidence
    from pkmodes.pages.report.comparison import by_mode, comparison_summary
    from pkmodes.pages.report.mode_table import mode_table
    from pkmodes.pages.report.setting import ReportSetting

    terminal, setting = Terminal(), ReportSetting(robot.name, robot, data, (), None)
    head = comparison_summary(result, setting)
    terminal.summary(head)
    terminal.show(*by_mode(result))
    if result.unpaired and limit < len(result.rows):
        terminal.line()
        terminal.line(f"unmatched measured modes: {rows_in_words(result.unpaired)}")
    terminal.show(mode_table(result, PlottedEvidence.of(result, data), setting, limit, paired=True))
    if limit < len(result.rows):
        terminal.line("--all prints every row.")
    if settings := settings_in_words(setting, result.rows):
        terminal.line()
        terminal.line(settings)
    for note in result.notes:  # verbatim: it may name what the file names
        terminal.line()
        terminal.line(f"note: {note}")


def _compare_measurements(
    files: tuple[Path, Path],
    band: tuple[float, float] | None,
    drives: str | None,
    everything: bool,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Compare two measurement files: which modes changed, and whether by more than their errors."""
    from pkmodes.loop.measured.compared import compare_measurements
    from pkmodes.loop.updating.reading import read_any

    sources = sources_of(
        report_to, dict(zip(("first measurement", "second measurement"), files, strict=True))
    )
    first, second = (read_any(file, band, drives=drives) for file in files)
    result = compare_measurements(first, second)

    def page() -> str:
        from pkmodes.pages.report.measurements_page import measurements_report

        return measurements_report(result, sources)

    def show() -> None:
        from pkmodes.cli.terminal import Terminal
        from pkmodes.pages.report.measured_shapes import shape_tables
        from pkmodes.pages.report.measurements import changes, measurements_summary

        limit = None if everything else MAX_PAIRED_ROWS
        blocks = [*changes(result, limit), *shape_tables(result, limit)]
        Terminal().result(measurements_summary(result), *blocks)

    deliver(json_file, result.as_json(), show, report_file(report_to, page))


def _refuse(value: object, option: str, why: str) -> None:
    """Refuse an option that does not belong to what is compared."""
    if value is not None:
        raise click.UsageError(f"{option} {why}", click.get_current_context())
