"""``pkmodes modes``: frequencies, shapes, end-effector directions and static torques at a pose."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

import click
import numpy as np
from msgspec import UNSET, Meta, UnsetType

from pkmodes.base.documents import Count, Document, Matrix
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import json_option, mechanism_option
from pkmodes.cli.poses import check_metres, parse_pose, pose_option
from pkmodes.cli.targets import check_targets
from pkmodes.mechanism.poses import placed
from pkmodes.model.loading import load
from pkmodes.model.model import Model
from pkmodes.solve.results import CARRIAGES, Modes, Statics


class ModesDocument(Document):
    """The modes at a pose: n coordinates, m modes, the rigid-body ones first."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    pose: Annotated[
        list[float],
        Meta(description="The components of the mechanism's pose: the platform centre [m]."),
    ]
    coordinates: Annotated[
        list[str],
        Meta(
            description="Names of the n generalised coordinates, in the order of the matrices; x in m, theta in rad "
            "(docs/model.md)."
        ),
    ]
    frequencies_hz: Annotated[
        list[float],
        Meta(
            description="sqrt(|lambda|) / (2 pi) with the sign of lambda [Hz], ascending, the rigid-body ones first; "
            "m of them."
        ),
    ]
    shapes: Annotated[
        Matrix,
        Meta(
            description="One list of n components for each mode, mass-normalised: phi^T M phi = 1 in SI units."
        ),
    ]
    platform_shapes: Annotated[
        Matrix,
        Meta(
            description="For each mode the motion of the platform centre along the linear components of the pose, "
            "with the scale of the shape."
        ),
    ]
    joint_positions: Annotated[
        dict[str, float],
        Meta(description="The independent coordinates at the pose, by name, in SI units."),
    ]
    mass_matrix: Annotated[Matrix, Meta(description="n by n, SI units.")]
    stiffness_matrix: Annotated[Matrix, Meta(description="n by n, SI units.")]
    static_torques: Annotated[
        list[float],
        Meta(
            description="Torque of each drive that holds the pose against gravity, positive with its coordinate "
            "[N m]."
        ),
    ]
    rigid_modes: Annotated[
        Count, Meta(description="Number of modes that strain no elastic element; they come first.")
    ]
    backend: Annotated[Literal["numpy", "compiled"], Meta(description="What evaluated the modes.")]
    carriage_positions: Annotated[
        list[float] | UnsetType,
        Meta(description="The same as joint_positions in a list, for a robot with carriages [m]."),
    ] = UNSET


@click.command(epilog="\b\nExample:\n  pkmodes modes robots/linear-delta-2022.toml --pose 0.6,0,-0.245")
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@pose_option
@mechanism_option
@json_option
def modes(robot: Path, pose: str, json_file: str | None) -> None:
    """Compute frequencies, mode shapes, end-effector directions and static torques at a pose.

    Mode shapes are mass-normalised.  The table scales them to their largest component and, if the other coordinates
    are angles, divides lengths by a radius, as in the paper.
    """
    check_targets(json_file, [robot])
    model = load(robot)
    point = parse_pose(pose, model.mechanism)
    check_metres(model, pose, point)
    result, statics = model.modes(point), model.statics(point)
    document = ModesDocument(**as_json(model, result, statics))
    deliver(json_file, document.as_json(), lambda: _print(model, result, statics))


def as_json(model: Model, result: Modes, statics: Statics) -> dict[str, Any]:
    """Return the result of one pose with the documented JSON keys."""
    found = {
        "robot": model.robot.name,
        "pose": result.poses.tolist(),
        "coordinates": list(result.coordinates),
        "frequencies_hz": result.frequencies.tolist(),
        "shapes": result.shapes.tolist(),
        "platform_shapes": result.platform_shapes.tolist(),
        "joint_positions": dict(
            zip(model.mechanism.independent, result.joint_positions.tolist(), strict=True)
        ),
        "mass_matrix": result.mass_matrix.tolist(),
        "stiffness_matrix": result.stiffness_matrix.tolist(),
        "static_torques": statics.torques.tolist(),
        "rigid_modes": result.rigid_modes,
        "backend": result.backend,
    }
    if CARRIAGES in Modes.fields_of(model.mechanism):
        found[CARRIAGES] = result.carriage_positions.tolist()
    return found


def _print(model: Model, result: Modes, statics: Statics) -> None:
    """Print one column per mode and one row per component, so that nine modes fit a terminal."""
    from rich.console import Console
    from rich.table import Table

    console = Console(highlight=False)
    console.width = max(console.width, 80, 10 + 8 * len(result.frequencies))
    console.print(f"{model.robot.name} at {placed(model.mechanism, result.poses, 'g')}\n", markup=False)
    numbers = range(1 - result.rigid_modes, len(result.frequencies) - result.rigid_modes + 1)
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
    table.add_column("mode", no_wrap=True)
    for number in numbers:
        table.add_column(str(number) if number > 0 else "rigid", justify="right", no_wrap=True)
    table.add_row("f [Hz]", *map(_frequency, result.frequencies))
    scaled, symbols = result.shapes.copy(), {}
    for scale in model.mechanism.scales:
        k = result.coordinates.index(scale.coordinate)
        scaled[:, k] /= np.asarray(getattr(model.robot.parameters, scale.field))[scale.index]
        symbols[scale.coordinate] = f"/{scale.symbol}"
    scaled /= np.abs(scaled).max(axis=1, keepdims=True)
    for k, name in enumerate(result.coordinates):
        table.add_row(f"{name}{symbols.get(name, '')}", *map(_component, scaled[:, k]))
    size = np.linalg.norm(result.platform_shapes, axis=1, keepdims=True)
    directions = result.platform_shapes / np.where(size > 0.0, size, 1.0)
    for k, name in enumerate(model.mechanism.directions):
        table.add_row(f"p_{name}", *map(_component, directions[:, k]))
    console.print(table)
    console.print(
        "\np: direction of the platform's motion in each mode, a unit vector in the base frame", markup=False
    )
    units = {q.name: q.unit for q in model.mechanism.coordinates}
    drive = model.mechanism.drives[0].unit
    for label, values, unit in (
        (model.mechanism.independent_are, result.joint_positions, units[model.mechanism.independent[0]]),
        ("static torques", statics.torques, drive),
    ):
        console.print(
            f"{label} [{unit}]: {', '.join(f'{round(v, 4) + 0.0:.4f}' for v in values)}", markup=False
        )


def _frequency(value: float) -> str:
    """Format with five digits if they fit; a number is never truncated."""
    text = f"{value:.3f}" if abs(value) < 99.9995 else f"{value:.2f}"
    return f"{value:.1e}" if len(text) > 7 else text.replace("-0.000", "0.000")


def _component(value: float) -> str:
    # Components that differ from zero only by rounding are shown as zero.
    return "0" if abs(value) < 1e-9 else f"{value:.0e}" if abs(value) < 1e-3 else f"{value:.3f}"
