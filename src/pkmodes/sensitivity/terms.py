"""Parameter paths as the compiled evaluator takes them: weighted entries of the gradient of an eigenvalue."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache

import numpy as np

from pkmodes.core.compiled.lanes import Terms, flat
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import sample
from pkmodes.core.robot.layout import Slot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.sensitivity.matrices import POSE, effect_fields, joints_of
from pkmodes.sensitivity.paths import ParameterPath

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
    terms = terms_of_all([system], [paths])
    return terms._replace(first=terms.first[0], effects=terms.effects[0])


def terms_of_all(systems: Sequence[ExtendedSystem], paths: Sequence[Sequence[ParameterPath]]) -> Terms:
    """Return the terms of several robots with the same free coordinates, each with equally many paths."""
    system = systems[0]
    values, parameters = _places(system.mechanism)
    pose = len(values)
    joints, free = pose + len(system.mechanism.pose), frozenset(system.free.tolist())
    of_paths = [
        list(_terms(one, path, values, free))
        for one, some in zip(systems, paths, strict=True)
        for path in some
    ]
    given = [place for terms in of_paths for place, _ in terms]
    count, ends = len(paths[0]), np.cumsum([0, *map(len, of_paths)], dtype=np.int32)
    return Terms(
        first=ends[np.arange(len(systems))[:, None] * count + np.arange(count + 1)],
        places=np.array(given, dtype=np.int32),
        weights=np.array([weight for terms in of_paths for _, weight in terms], dtype=float),
        effects=np.array([flat(one.effects) for one in systems]),
        all_coordinates=any(parameters <= place < pose or place >= joints for place in given),
        locked_joints=any(place >= joints and place - joints not in free for place in given),
    )


def _terms(
    system: ExtendedSystem, path: ParameterPath, values: Mapping[Slot, int], free: frozenset[int]
) -> Iterator[tuple[int, float]]:
    """Yield place and weight of the terms of a path."""
    pose = len(values)
    joints, of_slot = pose + len(system.mechanism.pose), joints_of(system.mechanism)
    for slot, weight in path.weights.items():
        if slot in of_slot:
            for joint in of_slot[slot]:
                rate = float(system.joint_rates[joint]) if joint in free else 1.0
                yield joints + joint, weight * rate
        elif slot[0] == POSE:
            yield pose + slot[1][0], weight
        else:
            yield values[slot], weight


@cache
def _places(mechanism: Mechanism) -> tuple[dict[Slot, int], int]:
    """Return the place of each number of a robot in a gradient, and how many of them are parameters."""
    dotted, parameters = effect_fields(mechanism), 0
    slots: list[Slot] = []
    for numbers in (sample(mechanism), mechanism.extended.Effects()):
        parameters = len(slots)
        slots += [
            (dotted.get(name, name), index)
            for name, value in zip(numbers._fields, numbers, strict=True)
            for index in np.ndindex(np.shape(value))
        ]
    return {slot: place for place, slot in enumerate(slots)}, parameters
