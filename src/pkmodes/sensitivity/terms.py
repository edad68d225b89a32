"""Parameter paths as the compiled evaluator takes them: weighted entries of the gradient of an eigenvalue."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from pkmodes.compiled.lanes import Terms, flat
from pkmodes.robot.layout import Slot
from pkmodes.robot.paths import ParameterPath
from pkmodes.sensitivity.matrices import POSE, effect_fields, joints_of
from pkmodes.system.evaluation import ExtendedSystem

#: The compiled evaluator's names of the fields of `pkmodes.Sensitivities` that it evaluates.
RATES = {"eigenvalues": "eigenvalue_rates", "frequencies": "frequency_rates"}


def terms_of(system: ExtendedSystem, paths: Sequence[ParameterPath]) -> Terms:
    """Return the terms of parameter paths.

    Parameters
    ----------
    system : ExtendedSystem
        Of the robot, with or without effects.
    paths : sequence of ParameterPath
    """
    values = _values(system)
    parameters, pose = flat(system.parameters).size, len(values)
    joints = pose + len(system.mechanism.pose)
    terms_of_paths = [list(_terms(system, path, values)) for path in paths]
    places = np.array([place for terms in terms_of_paths for place, _ in terms], dtype=np.int32)
    weights = np.array([weight for terms in terms_of_paths for _, weight in terms], dtype=float)
    locked = np.setdiff1d(np.arange(len(system.mechanism.extended.COORDINATES)), system.free)
    of_effects = ((places >= parameters) & (places < pose)) | (places >= joints)
    return Terms(
        first=np.cumsum([0, *map(len, terms_of_paths)], dtype=np.int32),
        places=places,
        weights=weights,
        effects=flat(system.effects),
        all_coordinates=bool(of_effects.any()),
        locked_joints=bool(np.isin(places - joints, locked).any()),
    )


def _terms(
    system: ExtendedSystem, path: ParameterPath, values: Mapping[Slot, int]
) -> Iterator[tuple[int, float]]:
    """Yield place and weight of the terms of a path."""
    pose = len(values)
    joints, free = pose + len(system.mechanism.pose), set(system.free.tolist())
    for slot, weight in path.weights.items():
        if slot in joints_of(system.mechanism):
            for joint in joints_of(system.mechanism)[slot]:
                rate = float(system.joint_rates[joint]) if joint in free else 1.0
                yield joints + joint, weight * rate
        elif slot[0] == POSE:
            yield pose + slot[1][0], weight
        else:
            yield values[slot], weight


def _values(system: ExtendedSystem) -> dict[Slot, int]:
    """Return the place of each number of the robot in a gradient."""
    dotted = effect_fields(system.mechanism)
    slots = [
        (dotted.get(name, name), index)
        for numbers in (system.parameters, system.effects)
        for name, value in zip(numbers._fields, numbers, strict=True)
        for index in np.ndindex(np.shape(value))
    ]
    return {slot: place for place, slot in enumerate(slots)}
