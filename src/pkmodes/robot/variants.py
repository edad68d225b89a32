"""A robot with other values: the document that declares it, changed, and read as a robot file is.

So there is one set of rules, and what a file would be refused for is refused here too.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError

from pkmodes.errors import PkmodesError, nearest, shown
from pkmodes.robot import schema
from pkmodes.robot.corrections import EFFECTS, FRAME_MASS, changeable
from pkmodes.robot.reading import SHARED, robot_from_document
from pkmodes.robot.robot import Robot
from pkmodes.robot.units import Quantity
from pkmodes.robot.wholes import joints_of_radius, limits_of_span

FRAME_COMPLIANCE = f"{EFFECTS}.frame_compliance.compliance"
FRAME_OF_EFFECT = f"{EFFECTS}.frame_compliance.mass"
#: Names of the elements of a vector, in their order.
ELEMENTS = (("x", "y", "z"), ("min", "max"))
OTHER_VALUES = " with other values"


def with_values(robot: Robot, values: Mapping[str, Any]) -> Robot:
    """Return the robot that a file with these values would declare: see `pkmodes.Robot.with_values`."""
    if not isinstance(values, Mapping):
        raise PkmodesError(
            f"expected values by path, found {shown(values)}",
            "values",
            'write such as {"platform.mass": "2 kg"}',
        )
    source = robot.source.removesuffix(OTHER_VALUES) + OTHER_VALUES
    changes = _changes(robot, values, source)
    declared = _raw_values(robot)
    if _read(robot, declared, source) != robot:
        raise PkmodesError(
            "the robot's parameters are not those that it declares",
            robot.source,
            "begin with one that was read",
        )
    if FRAME_MASS in changes:  # the effect takes it from the frame
        declared.pop(FRAME_OF_EFFECT, None)
    return _read(robot, {**declared, **changes}, source)


def _read(robot: Robot, values: Mapping[str, Any], source: str) -> Robot:
    """The robot that a file with these values alone would declare."""
    found = robot_from_document(_document(robot, values), source)
    # A direction was normalised already, and doing it again could change its last digit.
    return replace(found, parameters=found.parameters._replace(direction=robot.parameters.direction))


def _changes(robot: Robot, values: Mapping[str, Any], source: str) -> dict[str, Any]:
    """The values of the file that change, by path, as a robot file could have them."""
    framed = FRAME_MASS in robot.quantities or not {*robot.quantities, *values} & {FRAME_COMPLIANCE}
    found: dict[str, Any] = {}
    for path, raw in values.items():
        if not isinstance(path, str):
            what = f"expected a parameter path, found {shown(path)}"
            raise PkmodesError(what, "values", 'write such as {"platform.mass": "2 kg"}')
        if raw is None or (isinstance(raw, Mapping) and raw.get("value", raw) is None):
            remedy = "give a number or text with a unit; 0 is no effect"
            raise PkmodesError("expected a value, found None", f"{source}: {path}", remedy)
        shared = path == FRAME_OF_EFFECT and framed  # one mass, which is declared with the frame
        for element, value in _elements(robot, FRAME_MASS if shared else path, raw, source).items():
            if element in found or {element, *found} >= {FRAME_MASS, FRAME_OF_EFFECT}:
                what = "the value would be changed twice"
                raise PkmodesError(what, f"{source}: {element}", "change it once")
            found[element] = value
    before = {FRAME_MASS: robot.quantities.get(FRAME_OF_EFFECT), **robot.quantities}
    return {path: _with_sigma(raw, before.get(path)) for path, raw in found.items()}


def _elements(robot: Robot, path: str, raw: Any, source: str) -> dict[str, Any]:
    """The values of the file that a value by path changes."""
    known = changeable(robot)
    raw = _plain(raw, known.get(path), f"{source}: {path}")
    if path == "axis.span":
        return dict(limits_of_span(robot.parameters.limits, _length(raw, path, source)))
    if path == "axis.joint_radius":
        return dict(joints_of_radius(robot.parameters.joint, _length(raw, path, source), source))
    if path in known:
        _check_taken(robot, path)
        return {path: raw}
    names = next((n for n in ELEMENTS if f"{path}.{n[0]}" in known), None)
    if names is None:
        if path in robot.declared:
            what = f"{path} is no quantity: it cannot be changed here"
            raise PkmodesError(what, robot.source, "change the robot file")
        vectors = {p.rpartition(".")[0] for p in known if p.rpartition(".")[2] in ("x", "min")}
        remedy = nearest(path, [*known, *sorted(vectors)], "see docs/sensitivities.md for the paths")
        raise PkmodesError(f"unknown parameter path {shown(path)}", robot.source, remedy)
    if not isinstance(raw, list | tuple) or len(raw) != len(names):
        found = f"{len(raw)}" if isinstance(raw, list | tuple) else shown(raw)
        what = f"expected a list of {len(names)} values, found {found}"
        raise PkmodesError(what, f"{source}: {path}", f"give {', '.join(names)}")
    units = [known[f"{path}.{name}"] for name in names]
    where = [f"{path}.{name}" for name in names]
    return {
        place: _plain(one, unit, f"{source}: {place}")
        for place, one, unit in zip(where, raw, units, strict=True)
    }


def _plain(raw: Any, unit: str | None, where: str) -> Any:
    """A value as a robot file could have it: no arrays and numbers of NumPy, no `Quantity`."""
    if isinstance(raw, np.ndarray | np.generic):
        return raw.tolist()
    if isinstance(raw, Quantity):
        if raw.unit != unit:
            what = f"expected a quantity in {unit}, found one in {raw.unit}"
            raise PkmodesError(what, where, "give one of the same unit")
        return {"value": raw.value, "sigma": raw.sigma}
    if isinstance(raw, Mapping):
        return {key: _plain(value, unit, where) for key, value in raw.items()}
    return raw


def _length(raw: Any, path: str, source: str) -> float:
    """The value of a whole, which has no standard deviation of its own."""
    where = f"{source}: {path}"
    if isinstance(raw, Mapping) and raw.get("sigma") is not None:
        what = f"{path} has no standard deviation: its elements have"
        raise PkmodesError(what, where, "give a value alone, and sigma to elements")
    if isinstance(raw, Mapping):
        raw = {key: value for key, value in raw.items() if key != "sigma"}
    try:
        return schema.quantity(raw, "length", above=0.0).value
    except PydanticCustomError as error:
        raise PkmodesError(error.message(), where, (error.context or {})["remedy"]) from None


def _check_taken(robot: Robot, path: str) -> None:
    """A shared value in whose place every axis has its own would change nothing."""
    table, _, key = path.partition(".")
    if key in SHARED.get(table, ()) and all(f"axis.{j}.{path}" in robot.quantities for j in (1, 2, 3)):
        raise PkmodesError(
            f"no axis takes the shared value {path}: each has its own",
            robot.source,
            f"change axis.1.{path}, axis.2.{path} and axis.3.{path}",
        )


def _with_sigma(raw: Any, before: Quantity | None) -> Any:
    """A changed value with the standard deviation that it had, unless a table says otherwise."""
    table = dict(raw) if isinstance(raw, Mapping) else {"value": raw}
    if before is not None:
        table = {"value": before.value, "sigma": before.sigma, **table}
    if table.get("sigma", 0) is None:
        del table["sigma"]
    return table if set(table) != {"value"} else table["value"]


def _raw_values(robot: Robot) -> dict[str, Any]:
    """What the robot declares, by path, as a robot file could have it."""
    values = {
        path: _with_sigma({}, robot.quantities[path]) if path in robot.quantities else value
        for path, value in robot.declared.items()
    }
    if FRAME_MASS in values:  # the effect takes it from the frame
        values.pop(FRAME_OF_EFFECT, None)
    return values


def _document(robot: Robot, values: Mapping[str, Any]) -> dict[str, Any]:
    """The robot file, parsed, that declares these values."""
    document: dict[str, Any] = {"format": 1, "name": robot.name, "mechanism": robot.mechanism}
    for path, raw in values.items():
        *tables, key = path.split(".")
        table = document
        for name in tables:
            table = table.setdefault(name, {})
        table[key] = raw
    axes = [document["axis"][j] for j in sorted(document["axis"], key=int)]
    document["axis"] = axes
    for table in (document, *axes):
        for key, value in table.items():
            names = next((n for n in ELEMENTS if isinstance(value, dict) and set(value) == set(n)), None)
            if names is not None:
                table[key] = [value[name] for name in names]
    return document
