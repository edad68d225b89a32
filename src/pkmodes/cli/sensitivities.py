"""``pkmodes sensitivities``: how much each quantity of the robot file and each effect changes the frequencies."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import click
import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.option_table import OptionTable, entry, option
from pkmodes.cli.options import comma_list, drives_option, forwarded_mechanism_option, robot_argument
from pkmodes.cli.poses import parse_pose_option, pose_option
from pkmodes.cli.reporting import report_file
from pkmodes.core.base.drives import Drives
from pkmodes.core.support.documents import Count, Document, Matrix
from pkmodes.core.support.progress import report_progress
from pkmodes.loop.sensitivity.relative import relative_of
from pkmodes.loop.sensitivity.spread import stated_sigmas
from pkmodes.pages.report.blocks import Paragraph

if TYPE_CHECKING:
    from pkmodes.core.model import Model

Array = NDArray[np.float64]
#: An example of --parameters, for messages.
PARAMETERS_EXAMPLE = "--parameters platform.mass,axis.span; or omit the option"
#: Maximum number of quantities printed by default, and a note on the rest.
MAX_PRINTED = 10
ALL_NOTE = (
    "--all prints everything, including coordinates, for which one per cent depends on where the origin lies, "
    "effects that the file does not have, and Hz per unit of the value."
)


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
        Meta(
            description="Paths of the T quantities (docs/reference/parameter-paths.md), in the order asked for."
        ),
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


@dataclass(frozen=True)
class SensitivitiesOptions(OptionTable):
    """Arguments and options of the command."""

    robot: Path = entry(robot_argument, reads="robot file")
    pose: str = entry(pose_option)
    parameters: str | None = option(
        "--parameters",
        metavar="PATHS",
        help="Quantities such as platform.mass, link.length or effects.payload.mass, separated by commas; by default "
        "all that can vary.",
    )
    everything: bool = option(
        "--all",
        "everything",
        is_flag=True,
        help="Print every quantity, including coordinates and absent effects, and derivatives in Hz per unit; "
        "without it, the ten with the largest relative effect.",
    )
    drives: str = entry(drives_option)
    mechanism: Path | None = entry(forwarded_mechanism_option)


@click.command(
    epilog="\b\nExample:\n  pkmodes sensitivities robots/linear-delta-2022.toml --pose 0.6,0,-0.245 \\\n"
    "    --parameters platform.mass,axis.span,effects.gearbox_compliance.compliance"
)
@SensitivitiesOptions.add_to
def sensitivities(options: SensitivitiesOptions) -> None:
    """Compute exact derivatives of the frequencies at a pose with respect to the robot's quantities and to effects.

    Prints the ten largest, by the change of any frequency per one per cent of the value; the JSON always has
    all.  The platform pose and all other quantities are held constant; docs/reference/parameter-paths.md lists the
    paths.
    """
    drives, parameters = options.drives, options.parameters
    if options.everything and parameters is not None:
        raise click.UsageError("--all and --parameters exclude each other", click.get_current_context())
    options.check_files()
    sources = options.sources()
    paths = (
        None
        if parameters is None
        else comma_list(parameters, "--parameters", PARAMETERS_EXAMPLE, "parameter paths")
    )
    model = load(options.robot)
    pose_components = parse_pose_option(model, options.pose)
    modes = model.modes(pose_components, drives=drives)
    report_progress("differentiating the modes")
    derivatives = model.sensitivities(pose_components, paths, drives=drives)
    relative = relative_of(derivatives.frequencies, derivatives.values, modes.frequencies)
    content = SensitivitiesDocument.of(
        derivatives,
        robot=model.robot.name,
        pose=modes.poses.tolist(),
        frequencies_hz=modes.frequencies.tolist(),
        rigid_modes=modes.rigid_modes,
        frequency_derivatives=derivatives.frequencies.tolist(),
        relative_derivatives=relative.tolist(),
        eigenvalue_derivatives=derivatives.eigenvalues.tolist(),
    ).as_json()

    def page() -> str:
        from pkmodes.pages.report.sensitivities import sensitivities_report

        return sensitivities_report(model, content, sources)

    parameters_given = paths is not None
    report = report_file(options.report_to, page)
    deliver(
        options.json_file,
        content,
        lambda: _print(model, content, parameters_given, options.everything),
        report,
    )


def _print(model: Model, content: dict[str, Any], parameters_given: bool, print_all: bool) -> None:
    """Print the derivatives: the largest, or all that were requested.

    - parameters_given: whether --parameters names them
    - print_all: whether --all is given
    """
    from pkmodes.cli.terminal import Terminal
    from pkmodes.loop.sensitivity.changes import PERCENT, SIGMA, changes_at
    from pkmodes.pages.report.sensitivity_tables import (
        influential_quantities,
        per_cent_table,
        per_sigma_table,
        per_unit_table,
        sensitivities_summary,
    )

    terminal, pose, drives = Terminal(), content["pose"], content["drives"]
    influential, paths = influential_quantities(content), content["parameters"]
    all_printed = parameters_given or print_all
    chosen = [paths[t] for t in influential if content["values"][t]] if all_printed else None
    percent = changes_at(model, pose, drives, PERCENT, chosen or None)
    sigma = changes_at(model, pose, drives, SIGMA) if stated_sigmas(model.robot) else None
    summary = sensitivities_summary(
        model, percent, sigma, content, chosen_only=parameters_given and bool(chosen)
    )
    terminal.summary(summary)
    if percent.largest_of_all() and (chosen or not all_printed):
        terminal.show(per_cent_table(model, percent, content, None if all_printed else MAX_PRINTED))
    if sigma is not None and not parameters_given:
        terminal.show(per_sigma_table(model, sigma))
    if influential and all_printed:
        terminal.show(per_unit_table(model, content))
    if all_printed and len(influential) < len(paths):
        without_influence = [path for t, path in enumerate(paths) if t not in influential]
        terminal.show(Paragraph(f"No frequency depends on {', '.join(without_influence)}."))
    if not all_printed:
        terminal.show(Paragraph(ALL_NOTE))
    terminal.notes(summary)
