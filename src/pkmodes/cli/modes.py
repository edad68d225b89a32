"""``pkmodes modes``: frequencies, shapes, the end effector's motion and static torques at a pose."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, cast

import click
import msgspec
import numpy as np
from msgspec import UNSET, Meta, UnsetType
from numpy.typing import NDArray

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import drives_option, json_option, mechanism_option, robot_argument
from pkmodes.cli.poses import parse_pose_option, pose_option
from pkmodes.cli.targets import check_targets
from pkmodes.core.base.drives import DRIVES, FREE, HELD, other_drives
from pkmodes.core.mechanism.length import lengths_of, unit_vector_headings, unit_vectors
from pkmodes.core.mechanism.poses import format_pose
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO, SOLVERS
from pkmodes.core.solve.fields import FIELDS, INDEPENDENT, mode_fields
from pkmodes.core.solve.results import Modes, Statics
from pkmodes.core.support.documents import Count, Document
from pkmodes.core.support.motors import motors_give_way, motors_in_words
from pkmodes.loop.sensitivity.spread import spread_of
from pkmodes.machine.response.linearised import LinearisedRobot
from pkmodes.machine.response.poles import notes_on_damping, poles

if TYPE_CHECKING:
    from pkmodes.pages.report.blocks import Table

Array = NDArray[np.float64]
#: Components below the first are zero to rounding; so are frequencies, which are computed from their squares, below
#: the second times the largest.
ZERO_TOLERANCE, ZERO_FREQUENCY_TOLERANCE = 1e-9, 1e-6
#: Standard deviations below this would be rounded to zero [Hz].
SMALLEST_SIGMA = 0.0005
#: First frequencies that differ by less than this fraction are reported as the same.
SAME_FREQUENCY_TOLERANCE = 1e-3
#: Numbers of at least this size are written with an exponent.
MIN_EXPONENT_VALUE = 99_999.9995


class _PoseDocument(Document, frozen=True):
    robot: Annotated[str, Meta(description="Name of the robot.")]
    pose: Annotated[
        list[float],
        Meta(
            description="The components of the mechanism's pose: the platform centre [m] and, where the platform "
            "turns, its rotation vector [rad]."
        ),
    ]
    coordinates: Annotated[
        list[str],
        Meta(
            description="Names of the n generalised coordinates, in the order of the matrices; x in m, theta in rad "
            "(docs/model.md)."
        ),
    ]


_literal: Any = Literal
#: Keys of the document after the fields of `pkmodes.Modes`.
_FURTHER_KEYS: tuple[tuple[str, Any, str], ...] = (
    (
        "static_torques",
        list[float],
        "Torque of each drive that holds the pose against gravity, positive with its coordinate [N m]; its "
        "force [N] where that is a length.",
    ),
    (
        "poles",
        list[tuple[float, float]],
        "Real and imaginary part of every pole [1/s], by ascending magnitude; of a pair, the one with "
        "positive imaginary part first.",
    ),
    (
        "rigid_modes",
        Count,
        "Number of motions that strain no elastic element; the first modes count as these.",
    ),
    ("drives", _literal[DRIVES], "What the motors do: turn freely, or are held."),
    ("backend", _literal[tuple(SOLVERS)], "What evaluated the modes."),
    ("notes", list[str], "What to know of these numbers."),
)


def modes_document() -> type[Document]:
    """Return the class of the JSON document: its keys are fields of the modes (`pkmodes.core.solve.fields`)."""
    fields = [FIELDS[name] for name in mode_fields() if FIELDS[name].key]
    keys: list[tuple[str, Any, str]] = []
    optional_fields: list[Any] = []
    for field in fields:
        if field.same_as:  # of some mechanisms only
            kind: Any = Annotated[list[float] | UnsetType, Meta(description=field.key_text)]
            optional_fields.append((field.key, kind, UNSET))
            continue
        kind = float | None if field.nullable else float
        for _ in field.dims:
            kind = list[kind]
        if field.dims == (INDEPENDENT,):
            kind = dict[str, float]
        elif field.only == HELD:
            kind = kind | None
        keys.append((field.key, kind, field.key_text))
    declared: list[Any] = [
        (name, Annotated[kind, Meta(description=description)])
        for name, kind, description in (*keys, *_FURTHER_KEYS)
    ]
    description = "The modes at a pose: n coordinates, m modes, the rigid-body ones first."
    document = msgspec.defstruct(
        "ModesDocument",
        [*declared, *optional_fields],
        bases=(_PoseDocument,),
        namespace={"__doc__": description},
    )
    return cast("type[Document]", document)


@click.command(epilog="\b\nExample:\n  pkmodes modes robots/linear-delta-2022.toml --pose 0.6,0,-0.245")
@robot_argument
@pose_option
@drives_option
@mechanism_option
@json_option
def modes(robot: Path, pose: str, drives: str, json_file: str | None) -> None:
    """Compute frequencies, mode shapes, the end effector's motion and static torques at a pose.

    Mode shapes are mass-normalised.  The table scales them to their largest component and, if the other coordinates
    are angles, divides lengths by a radius, as in the paper.  The end effector's motion is a unit vector, in which
    rotations are multiplied by its characteristic length.
    """
    check_targets(json_file, [robot])
    model = load(robot)
    pose_components = parse_pose_option(model, pose)
    result, statics = model.modes(pose_components, drives=drives), model.statics(pose_components)
    content = as_json(model, result, statics)
    document = modes_document()(**content)

    def show() -> None:
        from pkmodes.cli.terminal import Terminal

        terminal, pose_text = Terminal(), format_pose(model.mechanism, result.poses, "g")
        terminal.heading(f"{model.robot.name} at {pose_text}, {motors_in_words(model.robot, result.drives)}")
        terminal.line()
        sigmas = spread_of(model, result.poses, result.drives)
        terminal.block(_table(model, result, sigmas))
        terminal.line()
        for sentence in (*_sentences(model, result, statics, sigmas is not None), *content["notes"]):
            terminal.line(sentence)

    deliver(json_file, document.as_json(), show)


def as_json(model: Model, result: Modes, statics: Statics) -> dict[str, Any]:
    """Return the result of one pose with the documented JSON keys."""
    # Both the poles and the notes need it.
    linearised = LinearisedRobot(model, result.poses[None], result.drives, AUTO)
    fields = [FIELDS[name] for name in Modes.fields_of(model.mechanism) if FIELDS[name].key]
    values: dict[str, Any] = {}
    for field in fields:
        value = getattr(result, field.name).tolist()
        if field.only == HELD and result.drives != HELD and not motors_give_way(result.robot):
            value = None
        elif field.dims == (INDEPENDENT,) and not field.same_as:
            value = dict(zip(model.mechanism.independent, value, strict=True))
        values[field.key] = value
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


def _table(model: Model, result: Modes, sigmas: Array | None) -> Table:
    """Return the table: one column per mode and one row per component.

    - sigmas: standard deviations of the frequencies, (m,) [Hz]; None if the robot file states none
    """
    from pkmodes.pages.report.blocks import Cell, Column, Table

    rigid_count = result.rigid_modes
    numbers = [
        str(i + 1 - rigid_count) if i >= rigid_count else "rigid" for i in range(len(result.frequencies))
    ]
    rounding = _rounding_level(result.frequencies)
    rows = [["f [Hz]", *(_format_fixed(f, rounding) for f in result.frequencies)]]
    if sigmas is not None:
        rows.append(["+- [Hz]", *map(_format_sigma, sigmas)])
    if model.robot.dissipates:
        ratios = ("" if np.isnan(ratio) else _format_fixed(100.0 * ratio) for ratio in result.damping_ratios)
        rows.append(["damping [%]", *ratios])
    scaled_shapes, symbols = result.shapes.copy(), {}
    for scale in model.mechanism.scales:
        column = result.coordinates.index(scale.coordinate)
        scaled_shapes[:, column] /= np.asarray(getattr(model.robot.parameters, scale.field))[scale.index]
        symbols[scale.coordinate] = f"/{scale.symbol}"
    scaled_shapes /= np.abs(scaled_shapes).max(axis=1, keepdims=True)
    platform_vectors = unit_vectors(
        result.platform_shapes, lengths_of(model.mechanism, model.robot.parameters)
    )
    names = [f"{name}{symbols.get(name, '')}" for name in result.coordinates]
    names += unit_vector_headings(model.mechanism)
    components = np.concatenate([scaled_shapes, platform_vectors], axis=1).T
    rows += [[name, *map(_format_fixed, row)] for name, row in zip(names, components, strict=True)]
    columns = [Column("mode", numeric=False), *map(Column, numbers)]
    return Table("", columns, [list(map(Cell, row)) for row in rows])


def _sentences(model: Model, result: Modes, statics: Statics, with_sigmas: bool) -> Iterator[str]:
    """Yield the state of the motors, the meaning of rows, the joint positions and the forces that hold the pose."""
    yield from _motor_sentences(model, result)
    if model.mechanism.rotations:
        yield (
            f"p, r*L: how the {model.mechanism.moving_body()} moves and turns about base axes, a unit vector; "
            f"L = {model.characteristic_length:.4g} m, the rms distance of its joints from its origin"
        )
    else:
        yield f"p: direction in which the {model.mechanism.body_moves()}, a unit vector in the base frame"
    if with_sigmas:
        yield "+-: one standard deviation, from those that the robot file states"
    rigid_frequencies = result.frequencies[: result.rigid_modes]
    if not (np.abs(rigid_frequencies) < _rounding_level(result.frequencies)).all():
        grounded_count = model.solved(result.drives).held_motions
        reason = "only gravity acts"
        if grounded_count:
            reason = (
                f"the {len(rigid_frequencies)} lowest modes, as many as there are motions that no spring holds; "
                f"gravity acts on these, and mixes them with the {grounded_count} that springs to ground hold"
            )
        yield f"rigid: {reason}; f = sqrt(|lambda|)/(2 pi) with the sign of lambda"
    units = {q.name: q.unit for q in model.mechanism.coordinates}
    drive_unit = model.mechanism.drives[0].unit
    for label, values, unit in (
        (model.mechanism.independent_are, result.joint_positions, units[model.mechanism.independent[0]]),
        ("static forces" if drive_unit == "N" else "static torques", statics.torques, drive_unit),
    ):
        yield f"{label} [{unit}]: {', '.join(f'{round(v, 4) + 0.0:.4f}' for v in values)}"


def _motor_sentences(model: Model, result: Modes) -> Iterator[str]:
    """Yield the state of the motors with the first frequency in the other state; nothing if it is the same."""
    drives = other_drives(result.drives)
    frequencies_otherwise = model.frequencies(result.poses, "nan", drives=drives)
    first_frequencies = []
    for frequencies in (
        result.frequencies[result.rigid_modes :],
        frequencies_otherwise[model.solved(drives).rigid_modes :],
    ):
        nonzero = frequencies[np.abs(frequencies) > _rounding_level(frequencies)]
        if not len(nonzero):
            return
        first_frequencies.append(float(nonzero[0]))
    first_frequency, first_otherwise = first_frequencies
    if abs(first_otherwise - first_frequency) <= SAME_FREQUENCY_TOLERANCE * abs(first_frequency):
        return
    motor_state = motors_in_words(model.robot, drives).removeprefix("motors ")
    motor_state = {FREE: "turning freely", HELD: "with their shafts held"}.get(motor_state, motor_state)
    yield (
        f"{motors_in_words(model.robot, result.drives)}; {motor_state} the first mode of vibration is at "
        f"{first_otherwise:.4g} Hz"
    )


def _rounding_level(frequencies: Array) -> float:
    """Return the size below which frequencies are rounding [Hz]."""
    return ZERO_FREQUENCY_TOLERANCE * float(np.abs(frequencies).max(initial=0.0))


def _format_sigma(value: float) -> str:
    """Format a standard deviation with two digits, but no decimals that the frequency above it does not have."""
    if np.isnan(value):
        return ""
    if value < SMALLEST_SIGMA:
        return "<0.001"
    rounded = float(f"{value:.2g}")
    decimals = int(np.clip(1 - np.floor(np.log10(rounded)), 0, 3))
    return f"{rounded:.{decimals}f}" + (3 - decimals + (decimals == 0)) * " "  # aligns the decimal points


def _format_fixed(value: float, tolerance: float = ZERO_TOLERANCE) -> str:
    """Format with three decimals, and with an exponent where these would not fit: numbers are never cut.

    - tolerance: below it a value differs from zero only by rounding, and is shown as 0
    """
    if abs(value) < tolerance:
        return "0    "  # aligned with the ones digit of the other numbers
    return f"{round(value, 3) + 0.0:.3f}" if abs(value) < MIN_EXPONENT_VALUE else f"{value:.2e}"
