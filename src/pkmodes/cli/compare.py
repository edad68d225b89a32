"""``pkmodes compare``: a robot with its measurements, paired and with their significance, or with another robot."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import click
from msgspec import Meta, field

from pkmodes.cli.compare_robots import compare_robots
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
from pkmodes.cli.poses import grid_option, poses_option
from pkmodes.cli.reporting import page_of, report_file, sources_of
from pkmodes.cli.targets import check_targets, report_target
from pkmodes.core.base.drives import Drives
from pkmodes.core.robot.reading import read_robot
from pkmodes.support.documents import Count, Document, Number, Probability, Settings, Size


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
    epilog="\b\nExamples:\n"
    "  pkmodes compare examples/closed_loop/robot.toml \\\n    examples/closed_loop/measured.csv\n"
    "  pkmodes compare robots/linear-delta-2022.toml \\\n    robots/linear-delta-2022-identified.toml"
)
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.argument("modes", metavar="MODES.csv|ROBOT.toml", type=click.Path(path_type=Path))
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
    """Compare predicted and measured modes without fitting anything, or two robots.

    Measured modes are paired with predicted modes by frequency and, if measured, by shape.  The exit code is 0
    however much they differ; scripts can use p_value in the JSON, or diagnose --fail-on.

    Two robot files are compared by what they declare and by their frequencies at the poses that both can reach: of
    --grid or --poses, by default of their workspaces.  Modes are paired by their shapes.
    """
    check_order(robot, modes, "pkmodes compare")
    check_targets(json_file, [robot, modes, *([poses] if poses else [])], report_target(report_to))
    if modes.suffix.lower() == ".toml":
        _refuse(band, "--band", "is of measurements, and two robots are compared")
        compare_robots((robot, modes), grid, poses, drives, everything, report_to, json_file)
        return
    _refuse(grid, "--grid", "is for two robots; measurements have their own poses")
    _refuse(poses, "--poses", "is for two robots; measurements have their own poses")
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


def _refuse(value: object, option: str, why: str) -> None:
    """Refuse an option that does not belong to what is compared."""
    if value is not None:
        raise click.UsageError(f"{option} {why}", click.get_current_context())
