"""``pkmodes compare``: predicted and measured modes, paired, with residuals and their significance."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
from msgspec import Meta, field

from pkmodes.base.documents import Count, Document, Number, Probability, Settings, Size
from pkmodes.base.drives import Drives, motors
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import (
    band_of,
    band_option,
    check_order,
    json_option,
    measured_drives_option,
    mechanism_option,
    report_option,
)
from pkmodes.cli.reporting import page_of, report_file, sources_of
from pkmodes.cli.targets import check_targets, report_target
from pkmodes.model.loading import read_robot

if TYPE_CHECKING:
    from pkmodes.diagnosis import Comparison
    from pkmodes.diagnosis.compare import ComparedRow
    from pkmodes.robot.robot import Robot

#: Headings of the measured damping ratio, its standard deviation and the ratio of the model, all in per cent.
DAMPING = ("damping [%]", "sigma", "model")


class RowDocument(Document, omit_defaults=True):
    """A measured mode and its partner in the model."""

    pose: Annotated[str, Meta(description="Label of the pose.")]
    line: Annotated[Number, Meta(description="Line of the measurement file.")]
    mode: Annotated[str, Meta(description="The experimenter's mode number; may be empty.")]
    measured: Annotated[float, Meta(description="Frequency [Hz].")]
    sigma: Annotated[float, Meta(description="Its standard deviation [Hz].")]
    drives: Drives
    predicted: Annotated[
        float | None,
        Meta(
            description="Frequency of the paired mode [Hz]; null for an unmatched row, like the next three."
        ),
    ]
    partner: Annotated[
        Number | None,
        Meta(description="Number of the paired mode in the model, from 1, counting the rigid ones."),
    ]
    residual: Annotated[float | None, Meta(description="predicted / measured - 1.")]
    sigmas: Annotated[
        float | None,
        Meta(
            description="Difference of the logarithms in standard deviations, including the uncertainty of the "
            "position."
        ),
    ]
    mac: Annotated[
        Size | None, Meta(description="Modal assurance criterion; null where no shape was measured.")
    ]
    load: Settings = field(name="set", default_factory=dict)
    damping: Annotated[
        float | None,
        Meta(description="Measured damping ratio; present only where it was measured, like the next two."),
    ] = None
    sigma_damping: Annotated[float | None, Meta(description="Its standard deviation.")] = None
    predicted_damping: Annotated[float | None, Meta(description="Damping ratio of the paired mode.")] = None


class CompareDocument(Document):
    """The residuals of a robot."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    rms_relative: Annotated[
        Size | None,
        Meta(description="Root mean square of the residuals of the paired rows; null where none is paired."),
    ]
    chi2_per_dof: Annotated[
        Size | None,
        Meta(
            description="For the paired rows with their stated errors, nothing fitted; null where none is paired."
        ),
    ]
    p_value: Annotated[
        Probability | None,
        Meta(
            description="Probability of a larger chi-square if the model is right; null where none is paired."
        ),
    ]
    unpaired: Annotated[Count, Meta(description="Number of unmatched measured modes.")]
    rows: Annotated[
        list[RowDocument], Meta(description="One for each measured mode, in the order of the file.")
    ]


@click.command(
    epilog="\b\nExample:\n  pkmodes compare examples/closed_loop/robot.toml examples/closed_loop/measured.csv"
)
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.argument("modes", metavar="MODES.csv", type=click.Path(path_type=Path))
@band_option
@measured_drives_option
@mechanism_option
@report_option
@json_option
def compare(
    robot: Path,
    modes: Path,
    band: str | None,
    drives: str | None,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Compare predicted and measured modes without fitting anything.

    Measured modes are paired with predicted modes by frequency and, if measured, by shape.  The exit code is 0
    however much they differ; scripts can use p_value in the JSON, or diagnose --fail-on.
    """
    check_order(robot, modes, "pkmodes compare")
    check_targets(json_file, [robot, modes], report_target(report_to))
    from pkmodes import updating  # SciPy is loaded only where it is used

    declared = read_robot(robot)
    data = updating.read(modes, band_of(band), declared, drives=drives)
    sources = sources_of(report_to, {"robot file": robot, "measurement file": modes})
    result = updating.compare(declared, data)
    document = CompareDocument.of(
        result,
        robot=declared.name,
        unpaired=len(result.unpaired),
        rows=list(map(RowDocument.of, result.rows)),
    )
    report = report_file(report_to, lambda: page_of(result, declared, data, sources))
    deliver(json_file, document.as_json(), lambda: _print(declared, modes, result), report)


def _print(robot: Robot, modes: Path, result: Comparison) -> None:
    from pkmodes.base.numbers import p_in_words
    from pkmodes.base.ordering import sorted_labels
    from pkmodes.cli.diagnosis_tables import setting
    from pkmodes.cli.terminal import Terminal

    terminal = Terminal()
    did = motors(row.drives for row in result.rows)
    terminal.heading(f"{robot.name} compared with {modes}, {did}, frequencies in Hz")
    terminal.line()
    shapes = any(row.mac is not None for row in result.rows)
    numbered = any(row.mode for row in result.rows)
    mixed = len({row.drives for row in result.rows}) > 1
    titles = ["pose", *(["motors"] if mixed else []), "line", *(["own"] if numbered else [])]
    titles += ["mode", "measured", "sigma", "predicted"]
    loads = any(row.load for row in result.rows)
    damped = any(row.damping is not None for row in result.rows)
    titles += [
        "diff [%]",
        "sigmas",
        *(DAMPING if damped else []),
        *(["MAC"] if shapes else []),
        *(["set"] if loads else []),
    ]
    poses = {pose: i for i, pose in enumerate(sorted_labels(dict.fromkeys(row.pose for row in result.rows)))}
    rows, previous = [], None
    for row in sorted(result.rows, key=lambda row: (poses[row.pose], row.measured)):
        new = row.pose != previous
        cells = [row.pose if new else "", *([row.drives or "" if new else ""] if mixed else [])]
        cells += [str(row.line), *([row.mode] if numbered else [])]
        cells += [*_numbers(row, result.rigid), *(_damping(row) if damped else [])]
        cells += [*([_or_blank(row.mac, ".3f")] if shapes else [])]
        cells += [setting(robot.mechanism, row.load) if new else ""] if loads else []
        rows.append(cells)
        previous = row.pose
    terminal.table(titles, rows, left=("pose", "motors", "own", "set"))
    terminal.line()
    count = len(result.rows)
    terminal.line(
        f"{count} measured mode{'' if count == 1 else 's'}"
        + (f", {len(result.unpaired)} of them unmatched" if result.unpaired else "")
    )
    rms, chi2, p = result.rms_relative, result.chi2_per_dof, result.p_value
    if rms is not None and chi2 is not None and p is not None:
        terminal.line(
            f"rms of the differences {100 * rms:.3g} %, chi2 per degree of freedom {chi2:.3g} ({p_in_words(p)})"
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


def _damping(row: ComparedRow) -> list[str]:
    """Return the ratios in per cent, under the headings `DAMPING`."""
    return [
        "" if ratio is None else f"{100.0 * ratio:.3g}"
        for ratio in (row.damping, row.sigma_damping, row.predicted_damping)
    ]


def _hertz(value: float) -> str:
    """Format with three decimals, or with two digits below 0.01."""
    return f"{value:.3f}" if value >= 0.01 else f"{value:.2g}"


def _or_blank(value: float | None, form: str) -> str:
    return "" if value is None else format(value, form)
