"""Parameter paths: what a person calls a quantity, as a direction in the parameters of the generated model.

``link.length`` is the length of every linkage that has none of its own, ``axis.span`` moves six limits evenly,
``axis.joint_radius`` moves three joints along their own directions: each path is a straight line in the space
of the generated parameters, so that values and derivatives along it follow from the same weights.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from pkmodes.errors import PkmodesError, shown
from pkmodes.robot.robot import Robot
from pkmodes_generated.linear_delta import Parameters

#: A number among the generated parameters or effects: its field, and its index in the field.
Slot = tuple[str, tuple[int, ...]]

AXES = (0, 1, 2)
VECTORS = {
    "origin": (("x", "y", "z"), "m"),
    "joint": (("x", "y", "z"), "m"),
    "limits": (("min", "max"), "m"),
}


@dataclass(frozen=True)
class ParameterPath:
    """A quantity that can vary.

    Attributes
    ----------
    path : str
        Dotted path, such as ``platform.mass``, ``axis.span`` or ``effects.payload.mass``.
    value : float
        As declared, SI units.
    unit : str
        SI unit, ``"1"`` when dimensionless.
    weights : mapping of slot to float
        How far each number of the generated model moves when the quantity moves by one unit.
    """

    path: str
    value: float
    unit: str
    weights: Mapping[Slot, float]


def paths(robot: Robot) -> tuple[str, ...]:
    """Every path that `resolve` knows for this robot: shared and axis-wise quantities, effects."""
    return tuple(_known(robot))


def resolve(robot: Robot, path: str) -> ParameterPath:
    """Find what a path stands for.

    Parameters
    ----------
    robot : Robot
        Its declared values are where the path's line begins.
    path : str
        Dotted path, see docs/sensitivities.md.

    Raises
    ------
    PkmodesError
        If there is no such quantity, or none that can vary.
    """
    return resolve_all(robot, [path])[0]


def resolve_all(robot: Robot, wanted: Iterable[str]) -> list[ParameterPath]:
    """Find what several paths stand for, as `resolve` does."""
    known = _known(robot)
    return [_resolved(robot, path, known) for path in wanted]


def _resolved(
    robot: Robot, path: str, known: Mapping[str, tuple[str, Mapping[Slot, float]]]
) -> ParameterPath:
    if not isinstance(path, str):
        raise PkmodesError(f"expected a parameter path, found {shown(path)}", "parameters", "give strings")
    if path not in known:
        nearest = difflib.get_close_matches(path, known, n=1, cutoff=0.5)
        remedy = f'did you mean "{nearest[0]}"?' if nearest else "see docs/sensitivities.md for the paths"
        raise PkmodesError(f"unknown parameter path {shown(path)}", robot.source, remedy)
    unit, weights = known[path]
    if not weights:
        what = f"{path} cannot vary: a joint at the platform's centre is in no direction from it"
        raise PkmodesError(what, robot.source, "use elements such as axis.1.joint.x")
    return ParameterPath(path, _value(robot, path, weights), unit, weights)


def moved(robot: Robot, changes: Iterable[tuple[ParameterPath, float]]) -> Robot:
    """Return the robot with quantities changed by these amounts (not: to these values)."""
    steps: dict[Slot, float] = {}
    for path, amount in changes:
        for slot, weight in path.weights.items():
            steps[slot] = steps.get(slot, 0.0) + weight * amount
    arrays: dict[str, np.ndarray] = {}
    effects = dict(robot.effects)
    for (field, index), step in steps.items():
        if field in Parameters._fields:
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


def _value(robot: Robot, path: str, weights: Mapping[Slot, float]) -> float:
    if path == "axis.span":
        low, high = robot.parameters.limits[0]
        return float(high - low)
    if path == "axis.joint_radius":
        return float(np.linalg.norm(robot.parameters.joint[0]))
    field, index = next(iter(weights))
    if field not in Parameters._fields:
        return robot.effects.get(field, robot.constants.get(field, 0.0))
    return float(np.asarray(getattr(robot.parameters, field))[index])


def _known(robot: Robot) -> dict[str, tuple[str, Mapping[Slot, float]]]:
    return {**_shared(robot), **_axis_wise(robot), **_effects()}


def _shared(robot: Robot) -> dict[str, tuple[str, Mapping[Slot, float]]]:
    """Quantities of the robot as a whole, and those that several axes share."""
    found: dict[str, tuple[str, Mapping[Slot, float]]] = {}
    for i, name in enumerate(("x", "y", "z")):
        found[f"gravity.{name}"] = ("m/s^2", {("gravity", (i,)): 1.0})
    for path, unit, field in _tables(robot):
        if not np.ndim(getattr(robot.parameters, field)):
            found[path] = (unit, {(field, ()): 1.0})
            continue
        following = [j for j in AXES if f"axis.{j + 1}.{path}" not in robot.quantities]
        if following and path in robot.quantities:
            found[path] = (unit, {(field, (j,)): 1.0 for j in following})
    ends: dict[Slot, float] = {
        ("limits", (j, end)): side for j in AXES for end, side in ((0, -0.5), (1, 0.5))
    }
    found["frame.mass"] = ("kg", {("frame_compliance.mass", ()): 1.0})
    found["axis.span"] = ("m", ends)
    norms = np.linalg.norm(robot.parameters.joint, axis=1)
    outward: dict[Slot, float] = {
        ("joint", (j, i)): float(robot.parameters.joint[j, i] / norms[j])
        for j in AXES
        for i in range(3)
        if norms[j] > 0.0 and robot.parameters.joint[j, i] != 0.0
    }
    found["axis.joint_radius"] = ("m", outward if (norms > 0.0).all() else {})
    return found


def _axis_wise(robot: Robot) -> dict[str, tuple[str, Mapping[Slot, float]]]:
    """Quantities of one axis, whether it has a value of its own or takes the shared one."""
    found: dict[str, tuple[str, Mapping[Slot, float]]] = {}
    for j in AXES:
        for path, unit, field in _tables(robot):
            if np.ndim(getattr(robot.parameters, field)):
                found[f"axis.{j + 1}.{path}"] = (unit, {(field, (j,)): 1.0})
        for field, (names, unit) in VECTORS.items():
            for i, name in enumerate(names):
                found[f"axis.{j + 1}.{field}.{name}"] = (unit, {(field, (j, i)): 1.0})
    return found


def _tables(robot: Robot) -> list[tuple[str, str, str]]:
    """Quantities of the tables [platform], [link] ... : path, unit and field of the generated model."""
    found: dict[str, tuple[str, str, str]] = {}
    for path, quantity in robot.quantities.items():
        parts = path.split(".")
        table, key = parts[-2:]
        field = f"{table}_{key}" if f"{table}_{key}" in Parameters._fields else key
        shared = len(parts) == 2 or (len(parts) == 4 and parts[0] == "axis")
        if shared and field in Parameters._fields:
            found[f"{table}.{key}"] = (f"{table}.{key}", quantity.unit, field)
    return list(found.values())


def _effects() -> dict[str, tuple[str, Mapping[Slot, float]]]:
    from pkmodes.robot.effects import CATALOGUE

    return {
        f"effects.{effect.name}.{parameter.name}": (
            parameter.unit,
            {(f"{effect.name}.{parameter.name}", ()): 1.0},
        )
        for effect in CATALOGUE.values()
        for parameter in effect.parameters
    }
