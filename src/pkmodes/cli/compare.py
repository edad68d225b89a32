"""``pkmodes compare``: predicted and measured modes, paired, with residuals and their significance."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pkmodes.cli.output import (
    band_of,
    band_option,
    check_order,
    check_other_targets,
    check_target,
    deliver,
    json_option,
    mechanism_option,
    report_option,
    to_file,
    write_json,
)
from pkmodes.cli.reporting import measured_reporting, page_of
from pkmodes.model.loading import read_robot

if TYPE_CHECKING:
    from pkmodes.diagnosis import Comparison
    from pkmodes.diagnosis.compare import ComparedRow
    from pkmodes.robot.robot import Robot


@click.command(
    epilog="\b\nExample:\n  pkmodes compare examples/closed_loop/robot.toml examples/closed_loop/measured.csv"
)
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.argument("modes", metavar="MODES.csv", type=click.Path(path_type=Path))
@band_option
@mechanism_option
@report_option
@json_option
def compare(
    robot: Path, modes: Path, band: str | None, report_to: Path | None, json_file: str | None
) -> None:
    """Compare predicted and measured modes without fitting anything.

    Measured modes are paired with predicted modes by frequency and, if measured, by shape.  The exit code is 0
    however much they differ; scripts can use p_value in the JSON, or diagnose --fail-on.
    """
    check_order(robot, modes, "pkmodes compare")
    check_target(json_file, robot, modes)
    check_other_targets({"--report": (report_to, "the report")}, json_file, robot, modes)
    from pkmodes import updating  # SciPy is loaded only where it is used

    declared = read_robot(robot)
    data = updating.read(modes, band_of(band), declared)
    reporting = measured_reporting(report_to, robot, modes)
    result = updating.compare(declared, data)
    content = {
        "robot": declared.name,
        "rms_relative": result.rms_relative,
        "chi2_per_dof": result.chi2_per_dof,
        "p_value": result.p_value,
        "unpaired": len(result.unpaired),
        "rows": [_as_json(row) for row in result.rows],
    }
    files = to_file(json_file, content)
    if reporting is not None:
        files.append(lambda: reporting.write(page_of(result, declared, data)))
    with deliver(files):
        if json_file == "-":
            write_json(json_file, content)
        else:
            _print(declared, modes, result)
        if reporting is not None:
            reporting.announce(json_file)


def _as_json(row: ComparedRow) -> dict[str, object]:
    """Return a row as JSON; the key ``set`` is present only if a load case sets something."""
    content = asdict(row)
    load = content.pop("load")
    return {**content, **({"set": load} if load else {})}


def _print(robot: Robot, modes: Path, result: Comparison) -> None:
    from pkmodes.cli.diagnosis_tables import p_value, setting
    from pkmodes.cli.terminal import Terminal

    terminal = Terminal()
    terminal.heading(f"{robot.name} compared with {modes}, frequencies in Hz")
    terminal.line()
    shapes = any(row.mac is not None for row in result.rows)
    numbered = any(row.mode for row in result.rows)
    titles = ["pose", "line", *(["own"] if numbered else []), "mode", "measured", "sigma", "predicted"]
    loads = any(row.load for row in result.rows)
    titles += ["diff [%]", "sigmas", *(["MAC"] if shapes else []), *(["set"] if loads else [])]
    poses = {pose: i for i, pose in enumerate(dict.fromkeys(row.pose for row in result.rows))}
    rows, previous = [], None
    for row in sorted(result.rows, key=lambda row: (poses[row.pose], row.measured)):
        cells = [row.pose if row.pose != previous else "", str(row.line), *([row.mode] if numbered else [])]
        cells += [*_numbers(row, result.rigid), *([_or_blank(row.mac, ".3f")] if shapes else [])]
        cells += [setting(robot.mechanism, row.load) if row.pose != previous else ""] if loads else []
        rows.append(cells)
        previous = row.pose
    terminal.table(titles, rows, left=("pose", "own", "set"))
    terminal.line()
    count = len(result.rows)
    terminal.line(
        f"{count} measured mode{'' if count == 1 else 's'}"
        + (f", {len(result.unpaired)} of them unmatched" if result.unpaired else "")
    )
    rms, chi2, p = result.rms_relative, result.chi2_per_dof, result.p_value
    if rms is not None and chi2 is not None and p is not None:
        terminal.line(
            f"rms of the differences {100 * rms:.3g} %, chi2 per degree of freedom {chi2:.3g} ({p_value(p)})"
        )
    for note in result.notes:
        terminal.line(note)
    terminal.line()
    own = "own: mode number in the file; " if numbered else ""
    terminal.line(
        f"{own}mode: number of the model's mode as in pkmodes modes; diff: prediction minus measurement; "
        "sigmas: diff in standard deviations"
    )


def _numbers(row: ComparedRow, rigid: int) -> list[str]:
    return [
        "none" if row.partner is None else str(row.partner - rigid),
        _hertz(row.measured),
        _hertz(row.sigma),
        "" if row.predicted is None else _hertz(row.predicted),
        _or_blank(None if row.residual is None else 100.0 * row.residual, "+.2f"),
        _or_blank(row.sigmas, "+.1f"),
    ]


def _hertz(value: float) -> str:
    """Format with three decimals, or with two digits below 0.01."""
    return f"{value:.3f}" if value >= 0.01 else f"{value:.2g}"


def _or_blank(value: float | None, form: str) -> str:
    return "" if value is None else format(value, form)
