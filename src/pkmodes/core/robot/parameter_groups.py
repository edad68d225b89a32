"""Parameter groups: several numbers that one path changes together.

A ``span`` moves the two ends of every pair symmetrically apart, a ``radius`` scales every vector along its direction.
The value of a group is that of the first pair or vector, and the others change by the same amount.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot.declaration import Declaration
from pkmodes.core.robot.layout import Item, Slot, items
from pkmodes_description import ParameterGroup

Array = NDArray[np.float64]


def groups_by_path(mechanism: Mechanism) -> dict[str, ParameterGroup]:
    """Return the parameter groups of a mechanism by path."""
    return {group.path: group for group in mechanism.parameter_groups}


def group_items(mechanism: Mechanism, group: ParameterGroup) -> list[Item]:
    """Return the pairs or vectors that a group changes."""
    return [item for item in items(mechanism) if item.key.field == group.field]


def group_value(robot: Declaration, group: ParameterGroup) -> float:
    """Return the value of a group in SI units."""
    first_vector = _vectors(robot, group)[0]
    if group.kind == "span":
        return float(first_vector[1] - first_vector[0])
    return float(np.linalg.norm(first_vector))


def group_weights(robot: Declaration, group: ParameterGroup) -> dict[Slot, float]:
    """Return the derivative of each number with respect to the group's value.

    It is empty if a vector is zero and has no direction.
    """
    vectors = _vectors(robot, group)
    if group.kind == "span":
        weights = np.tile([-0.5, 0.5], (len(vectors), 1))
    else:
        norms = np.linalg.norm(vectors, axis=1, keepdims=True)
        if not norms.all():
            return {}
        weights = vectors / norms
    return {
        number.slot: weight
        for item, row in zip(group_items(robot.mechanism, group), weights.tolist(), strict=True)
        for number, weight in zip(item.numbers, row, strict=True)
        if weight != 0.0 and number.slot is not None
    }


def elements_at_value(robot: Declaration, group: ParameterGroup, value: float) -> dict[str, float]:
    """Return the elements, keyed by path, at which the group takes the given value.

    Raises PkmodesError if a vector is zero and has no direction, or its length would become zero or negative.
    """
    vectors = _vectors(robot, group).tolist()
    elements: dict[str, float] = {}
    for item, vector in zip(group_items(robot.mechanism, group), vectors, strict=True):
        if group.kind == "span":
            (low, high), change = vector, value - (vectors[0][1] - vectors[0][0])
            ends = low - change / 2.0, high + change / 2.0
            # Rounding must not turn a limit of 0 into 1e-17 m.
            changed = [0.0 if abs(end) < 1e-12 * (high - low) else end for end in ends]
        else:
            length, change = math.hypot(*vector), value - math.hypot(*vectors[0])
            if length == 0.0 or length + change <= 0.0:
                name, unit = item.key.name, item.numbers[0].unit
                reason = "it is 0" if length == 0.0 else f"it would become {length + change:g} {unit}"
                raise PkmodesError(
                    f"the radius of {name} {(item.entry or 0) + 1} cannot be changed along its direction: "
                    f"{reason}",
                    f"{robot.source}: {item.path}",
                    f"correct the elements of the {name} instead",
                )
            changed = [element * ((length + change) / length) for element in vector]
        for number, before, after in zip(item.numbers, vector, changed, strict=True):
            if group.kind == "span" or before != 0.0:
                elements[number.path] = after
    return elements


def _vectors(robot: Declaration, group: ParameterGroup) -> Array:
    """Return one row for each pair or vector."""
    field = np.asarray(getattr(robot.parameters, group.field))
    return np.array([field[item.index] for item in group_items(robot.mechanism, group)])
