"""``pkmodes compare``: predicted and measured modes, paired, with residuals and their significance."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import click
from msgspec import Meta, field

from pkmodes.base.documents import Count, Document, Number, Probability, Settings, Size
from pkmodes.base.drives import Drives
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
@click.option(
    "--all",
    "everything",
    is_flag=True,
    help="Print every measured mode, not only those that differ most.",
)
@report_option
@json_option
def compare(
    robot: Path,
    modes: Path,
    band: str | None,
    drives: str | None,
    everything: bool,
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
    from pkmodes.cli.comparison_tables import show

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
    deliver(json_file, document.as_json(), lambda: show(declared, modes, result, everything), report)
