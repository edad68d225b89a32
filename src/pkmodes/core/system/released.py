"""The joints that the effects of a robot release, and their stiffnesses; nothing else of the robot matters."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.system.rigid_motions import RigidMotions, rigid_motions

Array = NDArray[np.float64]


class ReleasedJoints(NamedTuple):
    """The released joints and the springs to ground: see `pkmodes.core.system.evaluation.ExtendedSystem`."""

    effects: Any
    free: NDArray[np.intp]
    joints: Array
    joint_rates: Array
    coordinates: tuple[str, ...]
    rigid_motions: RigidMotions
    springs_to_ground: Mapping[str, float]


@lru_cache(maxsize=256)
def released_joints(mechanism: Mechanism, effects: tuple[tuple[str, float], ...]) -> ReleasedJoints:
    """Return what effects release and hold; kept, because a fit evaluates many robots with the same effects."""
    shared, _ = _split_effects(dict(effects))
    releasing = tuple(
        (path, value) for path, value in effects if path.split(".")[0] in _releasing_effects(mechanism)
    )
    grounding = [name for name in active_effects(mechanism, dict(effects)) if mechanism.effects[name].grounds]
    springs = {path: value for path, value in effects if path.split(".")[0] in grounding and value != 0.0}
    free, joints, rates, coordinates = _joints(mechanism, releasing)
    motions = RigidMotions(mechanism.rigid_modes, 0)
    if springs:
        motions = rigid_motions(mechanism, spring_fields(springs))
    values = mechanism.extended.Effects(**shared)
    return ReleasedJoints(values, free, joints, rates, coordinates, motions, springs)


def spring_fields(springs: Mapping[str, float]) -> tuple[str, ...]:
    """Return the generated fields of springs to ground by path."""
    return tuple(path.replace(".", "_") for path in springs)


@lru_cache(maxsize=256)
def _joints(
    mechanism: Mechanism, effects: tuple[tuple[str, float], ...]
) -> tuple[NDArray[np.intp], Array, Array, tuple[str, ...]]:
    """Return the free coordinates, the joints' stiffnesses and their rates, and the names of the coordinates."""
    extended, base_count = mechanism.extended, len(mechanism.coordinates)
    shared, single = _split_effects(dict(effects))
    with np.errstate(divide="ignore"):
        stiffness, rates = extended.joint_stiffness(extended.Effects(**shared))
        for coordinate, name, value in single:
            joint = extended.COORDINATES.index(coordinate) - base_count
            effects_of_joint = extended.Effects(**{**shared, name: shared.get(name, 0.0) + value})
            stiffness[joint], rates[joint] = (
                values[joint] for values in extended.joint_stiffness(effects_of_joint)
            )
    # A joint of stiffness 0 is released by an effect that is present: its first parameter is not zero.
    effect_values = dict(effects)
    present = {
        coordinate.name
        for effect in mechanism.effects.values()
        if effect_values.get(f"{effect.name}.{effect.parameters[0].name}", 0.0) != 0.0
        for coordinate in effect.coordinates
    }
    is_present = np.array([name in present for name in extended.COORDINATES[base_count:]], dtype=bool)
    is_released = np.isfinite(stiffness)  # a joint without compliance is infinitely stiff: locked
    is_released &= (stiffness != 0.0) | is_present
    free = np.concatenate([np.arange(base_count), base_count + np.flatnonzero(is_released)])
    joints = np.concatenate([np.zeros(base_count), np.where(is_released, stiffness, 0.0)])
    joint_rates = np.concatenate([np.zeros(base_count), np.where(is_released, rates, 0.0)])
    for array in (free, joints, joint_rates):
        array.flags.writeable = False
    return free, joints, joint_rates, tuple(extended.COORDINATES[i] for i in free)


@cache
def _releasing_effects(mechanism: Mechanism) -> frozenset[str]:
    """Return the names of the effects that release joints, whose stiffnesses depend on nothing else."""
    return frozenset(effect.name for effect in mechanism.effects.values() if effect.coordinates)


def active_effects(mechanism: Mechanism, effects: Mapping[str, float]) -> tuple[str, ...]:
    """Return the names of effects that are not null; constants such as a frame mass do not activate an effect."""
    present = {".".join(path.split(".")[:2]) for path, value in effects.items() if value != 0.0}
    return tuple(
        effect.name
        for effect in mechanism.effects.values()
        if any(f"{effect.name}.{parameter.name}" in present for parameter in effect.fitted)
    )


def _split_effects(effects: Mapping[str, float]) -> tuple[dict[str, float], list[tuple[str, str, float]]]:
    """Split parameters into those of whole effects and (coordinate, parameter, value) of single joints."""
    shared: dict[str, float] = {}
    single = []
    for path, value in effects.items():
        effect, parameter, *coordinate = path.split(".")
        if coordinate:
            single.append((coordinate[0], f"{effect}_{parameter}", value))
        else:
            shared[f"{effect}_{parameter}"] = value
    return shared, single
