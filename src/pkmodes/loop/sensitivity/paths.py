"""Parameter paths: each names a quantity and corresponds to a direction in the generated model's parameters.

A shared value changes every entry that does not override it, and a parameter group changes many numbers at once:
pairs symmetrically apart, or vectors along their directions.  Each path is a straight line in the space of the
generated parameters, so values and derivatives along it follow from the same weights.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.robot.layout import (
    EFFECTS,
    Item,
    Slot,
    effect_parameters,
    items,
    items_by_path,
    overrides_by_path,
    table_sources,
)
from pkmodes.core.robot.parameter_groups import group_items, group_value, group_weights, groups_by_path
from pkmodes.core.robot.robot import Robot

#: The unit of a path, and the weight with which each number changes along it.
UnitAndWeights = tuple[str, Mapping[Slot, float]]


@dataclass(frozen=True)
class ParameterPath:
    """A quantity that can vary.

    - path: dotted path, such as ``platform.mass``, ``axis.span`` or ``effects.payload.mass``
    - value: the declared value in SI units
    - unit: SI unit, ``"1"`` if dimensionless
    - weights: change of each number of the generated model when the quantity changes by one unit
    """

    path: str
    value: float
    unit: str
    weights: Mapping[Slot, float]


def paths(robot: Robot) -> tuple[str, ...]:
    """Return every path that `resolve` accepts for this robot: shared quantities, those of each entry, effects."""
    return tuple(_variable_quantities(robot))


def resolve(robot: Robot, path: str) -> ParameterPath:
    """Resolve a path.

    - robot: its declared values are the starting point of the path's line
    - path: dotted path, see docs/reference/parameter-paths.md

    Raises PkmodesError if there is no such quantity, it cannot vary, or no mode depends on it.
    """
    return resolve_all(robot, [path])[0]


def resolve_all(robot: Robot, requested: Iterable[str | ParameterPath]) -> list[ParameterPath]:
    """Resolve several paths, as `resolve` does; those that are resolved already stay as they are."""
    available = _variable_quantities(robot)
    return [
        path if isinstance(path, ParameterPath) else _resolve_one(robot, path, available)
        for path in requested
    ]


def _resolve_one(robot: Robot, path: str, available: Mapping[str, UnitAndWeights]) -> ParameterPath:
    if not isinstance(path, str):
        raise PkmodesError(f"expected a parameter path, found {shown(path)}", "parameters", "give strings")
    if path not in available and path in changeable_units(robot):
        problem = f"no frequency and no mode shape depends on {path}"
        alternatives = [
            candidate for candidate in available if candidate.endswith(f".{path}")
        ]  # of every axis, in place of the shared value
        remedy = nearest_name(path, alternatives, "choose a quantity that changes masses or stiffnesses")
        raise PkmodesError(problem, robot.source, remedy)
    if path not in available:
        remedy = nearest_name(path, available, "see docs/reference/parameter-paths.md for the paths")
        raise PkmodesError(f"unknown parameter path {shown(path)}", robot.source, remedy)
    unit, weights = available[path]
    group = groups_by_path(robot.mechanism).get(path)
    if group is not None and not weights:
        item = group_items(robot.mechanism, group)[0]
        problem = f"{path} cannot vary: a {item.key.name} that is zero has no direction"
        raise PkmodesError(problem, robot.source, f"use elements such as {item.numbers[0].path}")
    if group is not None:
        value = group_value(robot, group)
    else:
        field, index = next(iter(weights))
        if field in robot.parameters._fields:
            value = float(np.asarray(getattr(robot.parameters, field))[index])
        else:
            value = robot.effects.get(field, robot.constants.get(field, 0.0))
    return ParameterPath(path, value, unit, weights)


def change_quantities(robot: Robot, changes: Iterable[tuple[ParameterPath, float]]) -> Robot:
    """Return the robot with quantities changed by (not to) these amounts."""
    steps: dict[Slot, float] = {}
    for path, amount in changes:
        for slot, weight in path.weights.items():
            steps[slot] = steps.get(slot, 0.0) + weight * amount
    arrays: dict[str, np.ndarray] = {}
    effects = dict(robot.effects)
    for (field, index), step in steps.items():
        if field in robot.parameters._fields:
            if field not in arrays:
                arrays[field] = np.array(getattr(robot.parameters, field), dtype=float)
            arrays[field][index] += step
        else:
            effects[field] = effects.get(field, robot.constants.get(field, 0.0)) + step
            effect = field.split(".")[0]
            for constant, value in robot.constants.items():
                if constant.split(".")[0] == effect and constant != field:
                    effects.setdefault(constant, value)
    values = {field: array if array.shape else float(array) for field, array in arrays.items()}
    return replace(robot, parameters=robot.parameters._replace(**values), effects=effects)


def _variable_quantities(robot: Robot) -> dict[str, UnitAndWeights]:
    """Return all quantities that can vary: of the robot as a whole and shared ones, groups, entries, and effects."""
    mechanism, available = robot.mechanism, dict[str, UnitAndWeights]()
    item_at, shared = items_by_path(mechanism), overrides_by_path(mechanism)
    for item in items(mechanism):
        if item.path in shared:
            items_without_own_value = [
                taker for taker in shared[item.path] if taker.path not in robot.quantities
            ]
            slots = [number.slot for taker in items_without_own_value for number in taker.numbers]
            if slots and (item.path in robot.quantities or item.key.default is not None):
                weights = {slot: 1.0 for slot in slots if slot is not None}
                available[item.path] = item.numbers[0].unit, weights
        elif item.entry is None:
            available |= _paths_of_item(item)
    # The ends of a pair whose middle is the value of a key that the file does not give: it moves with them.
    for effect_path, table_path in table_sources(mechanism).items():
        pair = item_at[table_path].key.middle_of
        if pair and not {table_path, effect_path} & robot.quantities.keys():
            for end in item_at[pair].numbers:
                unit, weights_of_end = available[end.path]
                middle = (effect_path.removeprefix(f"{EFFECTS}."), ())
                available[end.path] = unit, {**weights_of_end, middle: 0.5}
    available |= {
        group.path: (group.unit, group_weights(robot, group)) for group in mechanism.parameter_groups
    }
    # The quantities of single entries, whether they override the shared value or take it.
    entries = [item for item in items(mechanism) if item.entry is not None]
    for item in sorted(entries, key=lambda item: (item.entry, not item.shared)):
        available |= _paths_of_item(item)
    for path, unit in effect_parameters(mechanism).items():
        available[path] = unit, {(path.removeprefix(f"{EFFECTS}."), ()): 1.0}
    return available


def _paths_of_item(item: Item) -> dict[str, UnitAndWeights]:
    return {
        number.path: (number.unit, {number.slot: 1.0}) for number in item.numbers if number.slot is not None
    }
