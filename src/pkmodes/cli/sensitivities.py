"""``pkmodes sensitivities``: how much each quantity of the robot file and each effect changes the frequencies."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import click
import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import (
    comma_list,
    drives_option,
    json_option,
    mechanism_option,
    report_option,
    robot_argument,
)
from pkmodes.cli.poses import pose_of, pose_option
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.cli.targets import check_targets, report_target
from pkmodes.core.base.drives import Drives
from pkmodes.sensitivity.relative import relative_of
from pkmodes.support.documents import Count, Document, Matrix
from pkmodes.support.progress import say

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.core.solve.results import Modes
    from pkmodes.report.sources import Source
    from pkmodes.sensitivity.sensitivities import Sensitivities

Array = NDArray[np.float64]
#: Of --parameters, for messages.
EXAMPLE = "--parameters platform.mass,axis.span; or omit the option"
#: Quantities that are printed without a choice.
MOST = 10


class SensitivitiesDocument(Document, frozen=True):
    """The derivatives at a pose: T quantities, m modes, the rigid-body ones first."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    pose: Annotated[list[float], Meta(description="Platform centre [m].")]
    frequencies_hz: Annotated[
        list[float],
        Meta(
            description="Frequencies of the m modes, as in `pkmodes modes` [Hz], the rigid-body modes first."
        ),
    ]
    rigid_modes: Annotated[
        Count, Meta(description="Number of modes that strain no elastic element; they come first.")
    ]
    drives: Drives
    groups: Annotated[
        list[int],
        Meta(
            description="A number for each mode; repeated modes have the same number, and their derivatives are "
            "those of the branches into which the group splits, ascending."
        ),
    ]
    parameters: Annotated[
        list[str],
        Meta(description="Paths of the T quantities (docs/sensitivities.md), in the order asked for."),
    ]
    units: Annotated[list[str], Meta(description="SI unit of each quantity; 1 if dimensionless.")]
    values: Annotated[
        list[float], Meta(description="Value of each quantity in its unit, 0 for an absent effect.")
    ]
    frequency_derivatives: Annotated[
        list[list[float | None]],
        Meta(
            description="T lists of m: Hz per unit of the quantity; null where the frequency is 0 to rounding, where "
            "a square root has no derivative."
        ),
    ]
    relative_derivatives: Annotated[
        list[list[float | None]],
        Meta(
            description="T lists of m: per cent of the frequency per per cent of the value; null where either is 0, "
            "and where the derivative is null."
        ),
    ]
    eigenvalue_derivatives: Annotated[
        Matrix, Meta(description="T lists of m: 1/s^2 per unit of the quantity.")
    ]


@click.command(
    epilog="\b\nExample:\n  pkmodes sensitivities robots/linear-delta-2022.toml --pose 0.6,0,-0.245 \\\n"
    "    --parameters platform.mass,axis.span,effects.gearbox_compliance.compliance"
)
@robot_argument
@pose_option
@click.option(
    "--parameters",
    metavar="PATHS",
    help="Quantities such as platform.mass, link.length or effects.payload.mass, separated by commas; by default all "
    "that can vary.",
)
@click.option(
    "--all",
    "everything",
    is_flag=True,
    help="Print every quantity, also coordinates and absent effects, and derivatives in Hz per unit; without it the "
    "ten with the largest relative effect.",
)
@drives_option
@mechanism_option
@report_option
@json_option
def sensitivities(
    robot: Path,
    pose: str,
    parameters: str | None,
    everything: bool,
    drives: str,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Compute exact derivatives of the frequencies at a pose with respect to the robot's quantities and to effects.

    Prints the ten largest, by what one percent of the value does to any frequency; the JSON always has all.  The
    platform pose and all other quantities are held constant; docs/sensitivities.md lists the paths.
    """
    if everything and parameters is not None:
        raise click.UsageError("--all and --parameters exclude each other", click.get_current_context())
    check_targets(json_file, [robot], report_target(report_to))
    sources = sources_of(report_to, {"robot file": robot})
    paths = None if parameters is None else comma_list(parameters, "--parameters", EXAMPLE, "parameter paths")
    model = load(robot)
    point = pose_of(model, pose)
    modes = model.modes(point, drives=drives)
    say("differentiating the modes")
    derivatives = model.sensitivities(point, paths, drives=drives)
    relative = relative_of(derivatives.frequencies, derivatives.values, modes.frequencies)
    document = SensitivitiesDocument.of(
        derivatives,
        robot=model.robot.name,
        pose=modes.poses.tolist(),
        frequencies_hz=modes.frequencies.tolist(),
        rigid_modes=modes.rigid_modes,
        frequency_derivatives=derivatives.frequencies.tolist(),
        relative_derivatives=relative.tolist(),
        eigenvalue_derivatives=derivatives.eigenvalues.tolist(),
    )
    asked = paths is not None
    deliver(
        json_file,
        document.as_json(),
        lambda: _print(model, modes, derivatives, relative, asked, everything),
        report_file(report_to, lambda: _page(model, document.as_json(), sources)),
    )


def _page(model: Model, content: dict[str, Any], sources: Sequence[Source]) -> str:
    from pkmodes.report.sensitivities import sensitivities_report

    return sensitivities_report(model, content, sources)


def _print(
    model: Model, modes: Modes, derivatives: Sensitivities, relative: Array, asked: bool, everything: bool
) -> None:
    from pkmodes.cli.sensitivity_tables import print_tables

    print_tables(model, modes, derivatives, relative, most=None if asked or everything else MOST, asked=asked)
