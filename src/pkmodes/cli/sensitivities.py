"""``pkmodes sensitivities``: how much each quantity of the robot file and each effect changes the frequencies."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.base.documents import Count, Document, Matrix
from pkmodes.base.drives import Drives
from pkmodes.base.progress import say
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import comma_list, drives_option, json_option, mechanism_option
from pkmodes.cli.poses import check_metres, parse_pose, pose_option
from pkmodes.cli.targets import check_targets
from pkmodes.mechanism.poses import placed
from pkmodes.model.loading import load

if TYPE_CHECKING:
    from pkmodes.model.model import Model
    from pkmodes.sensitivity.sensitivities import Sensitivities
    from pkmodes.solve.results import Modes

Array = NDArray[np.float64]
#: Of --parameters, for messages.
EXAMPLE = "--parameters platform.mass,axis.span; or omit the option"
#: Derivatives below these bounds are rounding and shown as 0: relative change of the frequency per relative change of
#: the value, or per SI unit if the value is 0.
NOTHING, NOTHING_BY_UNIT = 1e-9, 1e-15


class SensitivitiesDocument(Document):
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
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@pose_option
@click.option(
    "--parameters",
    metavar="PATHS",
    help="Quantities such as platform.mass, link.length or effects.payload.mass, separated by commas; by default all "
    "that can vary.",
)
@drives_option
@mechanism_option
@json_option
def sensitivities(robot: Path, pose: str, parameters: str | None, drives: str, json_file: str | None) -> None:
    """Compute exact derivatives of the frequencies at a pose with respect to the robot's quantities and to effects.

    Absent effects are included.  Quantities are sorted by how much a change of one percent changes a frequency.  The
    platform pose and all other quantities are held constant; docs/sensitivities.md lists the paths.
    """
    check_targets(json_file, [robot])
    paths = None if parameters is None else comma_list(parameters, "--parameters", EXAMPLE, "parameter paths")
    model = load(robot)
    point = parse_pose(pose, model.mechanism)
    check_metres(model, pose, point)
    modes = model.modes(point, drives=drives)
    say("differentiating the modes")
    derivatives = model.sensitivities(point, paths, drives=drives)
    relative = _relative(derivatives, modes.frequencies)
    document = SensitivitiesDocument.of(
        derivatives,
        robot=model.robot.name,
        pose=modes.poses.tolist(),
        frequencies_hz=modes.frequencies.tolist(),
        rigid_modes=modes.rigid_modes,
        groups=derivatives.groups.tolist(),
        values=derivatives.values.tolist(),
        frequency_derivatives=derivatives.frequencies.tolist(),
        relative_derivatives=relative.tolist(),
        eigenvalue_derivatives=derivatives.eigenvalues.tolist(),
    )
    deliver(json_file, document.as_json(), lambda: _print(model, modes, derivatives, relative))


def _relative(derivatives: Sensitivities, frequencies: Array) -> Array:
    """Return the percent change of the frequency per percent of the value; NaN if either is 0."""
    values = np.where(derivatives.values == 0.0, np.nan, derivatives.values)
    sizes = np.where(frequencies == 0.0, np.nan, frequencies)
    relative: Array = derivatives.frequencies * values[:, None] / sizes
    return relative


@dataclass(frozen=True)
class _Line:
    """A quantity in the tables, with its derivatives for the vibration modes."""

    path: str
    unit: str
    value: float
    rates: Array
    relative: Array

    @property
    def weight(self) -> float:
        """Sort key of the line, to six digits; 0 for a quantity that is 0, of which a percent is 0."""
        return float(f"{np.nanmax(np.abs(self.relative), initial=0.0):.6g}") if self.value else 0.0


def _print(model: Model, modes: Modes, derivatives: Sensitivities, relative: Array) -> None:
    from pkmodes.cli.terminal import Terminal

    terminal = Terminal()
    rigid = modes.rigid_modes
    values = derivatives.values.tolist()
    floor = np.array([NOTHING / abs(value) if value else NOTHING_BY_UNIT for value in values])
    small = np.abs(derivatives.frequencies) <= floor[:, None] * np.abs(modes.frequencies)
    rates = np.where(small, 0.0, derivatives.frequencies)[:, rigid:]
    every = list(map(_Line, derivatives.parameters, derivatives.units, values, rates, relative[:, rigid:]))
    lines = sorted((line for line in every if line.rates.any()), key=lambda line: -line.weight)
    at = placed(model.mechanism, modes.poses, "g")
    terminal.heading(f"{model.robot.name} at {at}, motors {modes.drives}")
    numbers = [str(number) for number in range(1, len(modes.frequencies) - rigid + 1)]
    frequencies = [f"{f:.3f}" for f in modes.frequencies[rigid:]]
    present = [line for line in lines if line.value != 0.0]
    if present:
        terminal.line()
        terminal.line("percent of the frequency per percent of the value:")
        rows = [["f [Hz]", *frequencies], *([line.path, *map(_share, line.relative)] for line in present)]
        terminal.table(["mode", *numbers], rows, left=("mode",))
    if lines:
        terminal.line()
        terminal.line("Hz per unit of the value:")
        rows = [
            [line.path, f"{line.value:.6g}", "" if line.unit == "1" else line.unit, *map(_rate, line.rates)]
            for line in lines
        ]
        terminal.table(["mode", "value", "unit", *numbers], rows, left=("mode", "unit"))
    still = [line.path for line in every if not line.rates.any()]
    if still:
        terminal.line()
        terminal.line(f"no frequency depends on: {', '.join(still)}")
    for members in _repeated(derivatives.groups.tolist(), rigid):
        terminal.line()
        terminal.line(
            f"modes {', '.join(map(str, members))} coincide: the derivatives are those of the branches into which "
            "they split, in ascending order"
        )


def _repeated(groups: list[int], rigid: int) -> list[list[int]]:
    """Return the groups of coincident vibration modes, counted from 1."""
    together: dict[int, list[int]] = {}
    for number, group in enumerate(groups[rigid:], start=1):
        together.setdefault(group, []).append(number)
    return [members for members in together.values() if len(members) > 1]


def _share(value: float) -> str:
    return "" if np.isnan(value) else "0" if abs(value) < 5e-5 else f"{value:.4f}"


def _rate(value: float) -> str:
    return "" if np.isnan(value) else f"{value:.4g}"
