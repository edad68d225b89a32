"""``pkmodes modes``: frequencies, shapes, end-effector directions and static torques at a pose."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import click
import numpy as np

from pkmodes.cli.output import check_target, deliver, json_option, to_file, write_json
from pkmodes.errors import PoseError
from pkmodes.loading import load
from pkmodes.model import Model
from pkmodes.results import Modes, Statics


@click.command(epilog="\b\nExample:\n  pkmodes modes robots/linear-delta-2022.toml --pose 0.6,0,-0.245")
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.option("--pose", metavar="X,Y,Z", required=True, help="Platform centre, in metres or with units.")
@json_option
def modes(robot: Path, pose: str, json_file: str | None) -> None:
    """Frequencies, shapes, end-effector directions and static torques at a pose.

    Shapes are mass-normalised; the table shows them scaled to their largest component, carriages divided by
    the pulley radius, as the paper prints them.
    """
    check_target(json_file, robot)
    point = parse_pose(pose)
    model = load(robot)
    check_metres(model, pose, point)
    result, statics = model.modes(point), model.statics(point)
    content = as_json(model, result, statics)
    with deliver(to_file(json_file, content)):
        if json_file == "-":
            write_json(json_file, content)
        else:
            _print(model, result, statics)


def parse_pose(text: str) -> list[float]:
    """Read ``X,Y,Z``: bare numbers in metres, or quantities with a unit of length.

    Raises
    ------
    PoseError
        If there are not three lengths.
    """
    from pkmodes.robot.units import QuantityError, parse

    parts = text.split(",")
    if len(parts) != 3:
        raise PoseError(
            f"expected three coordinates X,Y,Z, found {len(parts)}", "--pose", "write --pose 0.6,0,-0.245"
        )
    point = []
    for part in parts:
        try:
            if "_" in part:  # Python's float() would read 1_0 as 10
                raise ValueError
            point.append(float(part))
        except ValueError:
            try:
                point.append(parse(part, "length"))
            except QuantityError as error:
                raise PoseError(str(error), "--pose", "write metres, or a number with its unit") from None
    return point


def check_metres(model: Model, text: str, point: list[float]) -> None:
    """Refuse a pose that would be reached if its bare numbers were millimetres.

    Raises
    ------
    PoseError
        Any other pose that cannot be reached is the model's to refuse.
    """
    bare = not any(c.isalpha() for c in re.sub(r"\d[eE]", "", text))
    if bare and not model.check(point).valid and model.check([c / 1e3 for c in point]).valid:
        lengths = ",".join(f"{part.strip()} mm" for part in text.split(","))
        remedy = f'the numbers look like millimetres: write --pose "{lengths}"'
        raise PoseError(str(model.check(point).sentences).partition(";")[0], "--pose", remedy)


def as_json(model: Model, result: Modes, statics: Statics) -> dict[str, Any]:
    """The result of one pose with the keys that scripts rely on."""
    return {
        "robot": model.robot.name,
        "pose": result.poses.tolist(),
        "coordinates": list(result.coordinates),
        "frequencies_hz": result.frequencies.tolist(),
        "shapes": result.shapes.tolist(),
        "platform_shapes": result.platform_shapes.tolist(),
        "carriage_positions": result.carriage_positions.tolist(),
        "mass_matrix": result.mass_matrix.tolist(),
        "stiffness_matrix": result.stiffness_matrix.tolist(),
        "static_torques": statics.torques.tolist(),
        "rigid_modes": result.rigid_modes,
    }


def _print(model: Model, result: Modes, statics: Statics) -> None:
    """One column for each mode, one row for each component: nine modes fit a terminal that way."""
    from rich.console import Console
    from rich.table import Table

    console = Console(highlight=False)
    console.width = max(console.width, 80, 10 + 8 * len(result.frequencies))
    position = ", ".join(f"{c:g}" for c in result.poses)
    console.print(f"{model.robot.name} at [{position}] m\n", markup=False)
    numbers = range(1 - result.rigid_modes, len(result.frequencies) - result.rigid_modes + 1)
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
    table.add_column("mode", no_wrap=True)
    for number in numbers:
        table.add_column(str(number) if number > 0 else "rigid", justify="right", no_wrap=True)
    table.add_row("f [Hz]", *map(_frequency, result.frequencies))
    scaled = result.shapes.copy()
    scaled[:, :3] /= model.robot.parameters.pulley_radius
    scaled /= np.abs(scaled).max(axis=1, keepdims=True)
    for k, name in enumerate(result.coordinates):
        table.add_row(f"{name}/R_p" if name.startswith("x_") else name, *map(_component, scaled[:, k]))
    size = np.linalg.norm(result.platform_shapes, axis=1, keepdims=True)
    directions = result.platform_shapes / np.where(size > 0.0, size, 1.0)
    for k, name in enumerate(("p_x", "p_y", "p_z")):
        table.add_row(name, *map(_component, directions[:, k]))
    console.print(table)
    console.print(
        "\np: direction of the platform's motion in each mode, a unit vector in the base frame", markup=False
    )
    for label, values, unit in (
        ("carriage positions", result.carriage_positions, "m"),
        ("static torques", statics.torques, "N m"),
    ):
        console.print(f"{label} [{unit}]: {', '.join(f'{v:.4f}' for v in values)}", markup=False)


def _frequency(value: float) -> str:
    """Five digits where they fit; a number is never cut."""
    text = f"{value:.3f}" if abs(value) < 99.9995 else f"{value:.2f}"
    return f"{value:.1e}" if len(text) > 7 else text.replace("-0.000", "0.000")


def _component(value: float) -> str:
    # Components that rounding alone makes different from zero are shown as zero.
    return "0" if abs(value) < 1e-9 else f"{value:.0e}" if abs(value) < 1e-3 else f"{value:.3f}"
