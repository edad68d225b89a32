"""``pkmodes modes``: frequencies, shapes, end-effector directions and static torques at a pose."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Literal, cast

import click
import msgspec
import numpy as np
from msgspec import UNSET, Meta, UnsetType

from pkmodes.base.documents import Count, Document
from pkmodes.base.drives import DRIVES, HELD
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import drives_option, json_option, mechanism_option
from pkmodes.cli.poses import check_metres, parse_pose, pose_option
from pkmodes.cli.targets import check_targets
from pkmodes.dataset.fields import FIELDS, INDEPENDENT, Field, of_modes
from pkmodes.linalg.damping import poles
from pkmodes.mechanism.poses import placed
from pkmodes.model.loading import load
from pkmodes.model.model import Model
from pkmodes.response.linearised import LinearisedRobot
from pkmodes.response.poles import notes_on_damping
from pkmodes.sensitivity.spread import spread_of
from pkmodes.solve.backends import AUTO, SOLVERS
from pkmodes.solve.results import Modes, Statics


class _AtPose(Document):
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


_literal: Any = Literal
#: What follows the fields of `pkmodes.Modes`.
_AFTER: tuple[tuple[str, Any, str], ...] = (
    (
        "static_torques",
        list[float],
        "Torque of each drive that holds the pose against gravity, positive with its coordinate [N m].",
    ),
    (
        "poles",
        list[tuple[float, float]],
        "Real and imaginary part of every pole [1/s], by ascending magnitude; of a pair, the one with positive "
        "imaginary part first.",
    ),
    ("rigid_modes", Count, "Number of modes that strain no elastic element; they come first."),
    ("drives", _literal[DRIVES], "What the motors do: turn freely, or are held."),
    ("backend", _literal[tuple(SOLVERS)], "What evaluated the modes."),
    ("notes", list[str], "What to know of these numbers."),
)


def modes_document() -> type[Document]:
    """Return the class of the JSON document, whose keys are fields of `pkmodes.Modes` (`pkmodes.dataset.fields`)."""
    fields = [FIELDS[name] for name in of_modes() if FIELDS[name].key]
    keys = [(field.key, _type_of(field), field.key_text) for field in fields if not field.same_as]
    declared: list[Any] = [
        (name, Annotated[kind, Meta(description=text)]) for name, kind, text in (*keys, *_AFTER)
    ]
    for field in fields:
        if field.same_as:  # of some mechanisms only
            kind = Annotated[list[float] | UnsetType, Meta(description=field.key_text)]
            declared.append((field.key, kind, UNSET))
    text = "The modes at a pose: n coordinates, m modes, the rigid-body ones first."
    document = msgspec.defstruct("ModesDocument", declared, bases=(_AtPose,), namespace={"__doc__": text})
    return cast("type[Document]", document)


def _type_of(field: Field) -> Any:
    """Return the type of a field in JSON: by name along the independent coordinates, lists along other axes."""
    if field.dims == (INDEPENDENT,):
        return dict[str, float]
    kind: Any = float | None if field.nullable else float
    for _ in field.dims:
        kind = list[kind]
    return kind | None if field.only == HELD else kind


@click.command(epilog="\b\nExample:\n  pkmodes modes robots/linear-delta-2022.toml --pose 0.6,0,-0.245")
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@pose_option
@drives_option
@mechanism_option
@json_option
def modes(robot: Path, pose: str, drives: str, json_file: str | None) -> None:
    """Compute frequencies, mode shapes, end-effector directions and static torques at a pose.

    Mode shapes are mass-normalised.  The table scales them to their largest component and, if the other coordinates
    are angles, divides lengths by a radius, as in the paper.
    """
    check_targets(json_file, [robot])
    model = load(robot)
    point = parse_pose(pose, model.mechanism)
    check_metres(model, pose, point)
    result, statics = model.modes(point, drives=drives), model.statics(point)
    content = as_json(model, result, statics)
    document = modes_document()(**content)
    deliver(json_file, document.as_json(), lambda: _print(model, result, statics, content["notes"]))


def as_json(model: Model, result: Modes, statics: Statics) -> dict[str, Any]:
    """Return the result of one pose with the documented JSON keys."""
    # Both poles and notes need it.
    linearised = LinearisedRobot(model.dynamics, result.poses[None], result.drives, AUTO)
    fields = [FIELDS[name] for name in Modes.fields_of(model.mechanism) if FIELDS[name].key]
    values = {field.key: _in_json(field, result, model) for field in fields}
    return {
        "robot": model.robot.name,
        "pose": result.poses.tolist(),
        "coordinates": list(result.coordinates),
        **{field.key: values[field.key] for field in fields if not field.same_as},
        "static_torques": statics.torques.tolist(),
        "poles": [(s.real, s.imag) for s in poles(linearised.damping)[0].tolist()],
        "rigid_modes": result.rigid_modes,
        "drives": result.drives,
        "backend": result.backend,
        "notes": notes_on_damping(linearised, result.damping_ratios),
        **{field.key: values[field.key] for field in fields if field.same_as},
    }


def _in_json(field: Field, result: Modes, model: Model) -> Any:
    """Return the value of a field: by name along the independent coordinates, except under another name of these."""
    if field.only == HELD and result.drives != HELD:
        return None
    value = getattr(result, field.name).tolist()
    if field.dims == (INDEPENDENT,) and not field.same_as:
        return dict(zip(model.mechanism.independent, value, strict=True))
    return value


def _print(model: Model, result: Modes, statics: Statics, notes: Sequence[str]) -> None:
    """Print one column per mode and one row per component, so that nine modes fit a terminal."""
    from rich.console import Console
    from rich.table import Table

    console = Console(highlight=False)
    console.width = max(console.width, 80, 10 + 8 * len(result.frequencies))
    at = placed(model.mechanism, result.poses, "g")
    console.print(f"{model.robot.name} at {at}, motors {result.drives}\n", markup=False)
    numbers = range(1 - result.rigid_modes, len(result.frequencies) - result.rigid_modes + 1)
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
    table.add_column("mode", no_wrap=True)
    for number in numbers:
        table.add_column(str(number) if number > 0 else "rigid", justify="right", no_wrap=True)
    table.add_row("f [Hz]", *map(_frequency, result.frequencies))
    sigmas = spread_of(model.dynamics, result.poses, result.drives)
    if sigmas is not None:
        table.add_row("+- [Hz]", *("" if np.isnan(sigma) else f"{sigma:.2g}" for sigma in sigmas))
    if model.robot.dissipates:
        table.add_row("damping [%]", *map(_per_cent, result.damping_ratios))
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
    for note in notes:
        console.print(note, markup=False)


def _per_cent(ratio: float) -> str:
    return "" if np.isnan(ratio) else f"{100.0 * ratio:.3g}"


def _frequency(value: float) -> str:
    """Format with five digits if they fit; a number is never truncated."""
    text = f"{value:.3f}" if abs(value) < 99.9995 else f"{value:.2f}"
    return f"{value:.1e}" if len(text) > 7 else text.replace("-0.000", "0.000")


def _component(value: float) -> str:
    # Components that differ from zero only by rounding are shown as zero.
    return "0" if abs(value) < 1e-9 else f"{value:.0e}" if abs(value) < 1e-3 else f"{value:.3f}"
