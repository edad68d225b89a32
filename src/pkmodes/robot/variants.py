"""A robot with other values: the document that declares it, changed, and read as a robot file is.

So there is one set of rules, and what a file would be refused for is refused here too.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pkmodes.errors import PkmodesError, nearest, shown
from pkmodes.mechanism import Whole
from pkmodes.robot import schema
from pkmodes.robot.corrections import changeable
from pkmodes.robot.declaration import Declaration
from pkmodes.robot.documents import document_of
from pkmodes.robot.layout import by_path, lent, takers
from pkmodes.robot.units import Quantity
from pkmodes.robot.validation import declaration
from pkmodes.robot.wholes import elements_of, items_of, wholes

OTHER_VALUES = " with other values"


def with_values(robot: Declaration, values: Mapping[str, Any]) -> Declaration:
    """Return what a file with these values would declare: see `pkmodes.Robot.with_values`."""
    if not isinstance(values, Mapping):
        raise PkmodesError(
            f"expected values by path, found {shown(values)}",
            "values",
            'write such as {"frame.mass": "60 kg"}',
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
    return _read(robot, {**declared, **changes}, source)


def _read(robot: Declaration, values: Mapping[str, Any], source: str) -> Declaration:
    """What a file with these values alone would declare."""
    return declaration(document_of(robot.kind, robot.name, values), source)


def _changes(robot: Declaration, values: Mapping[str, Any], source: str) -> dict[str, Any]:
    """The values of the file that change, by path, as a robot file could have them."""
    owners = {path: own for path, own in lent(robot.kind).items() if _lent_now(robot, values, path, own)}
    found: dict[str, Any] = {}
    for path, raw in values.items():
        if not isinstance(path, str):
            what = f"expected a parameter path, found {shown(path)}"
            raise PkmodesError(what, "values", 'write such as {"frame.mass": "60 kg"}')
        if raw is None or (isinstance(raw, Mapping) and raw.get("value", raw) is None):
            remedy = "give a number or text with a unit; 0 is no effect"
            raise PkmodesError("expected a value, found None", f"{source}: {path}", remedy)
        for element, value in _elements(robot, owners.get(path, path), raw, source).items():
            others = {element, lent(robot.kind).get(element), *_borrowers(robot, element)}
            if others & found.keys():
                what = "the value would be changed twice"
                raise PkmodesError(what, f"{source}: {element}", "change it once")
            found[element] = value
    before = {own: robot.quantities.get(path) for path, own in lent(robot.kind).items()}
    return {path: _with_sigma(raw, {**before, **robot.quantities}.get(path)) for path, raw in found.items()}


def _lent_now(robot: Declaration, values: Mapping[str, Any], path: str, own: str) -> bool:
    """Whether the value of an effect's parameter is that of a table: not where the effect declares its own."""
    effect = path.rpartition(".")[0]
    others = [name for name in (*robot.quantities, *values) if name != path and _begins(name, effect)]
    return own in robot.quantities or not others


def _begins(name: object, table: str) -> bool:
    return isinstance(name, str) and name.startswith(f"{table}.")


def _borrowers(robot: Declaration, own: str) -> list[str]:
    return [path for path, owner in lent(robot.kind).items() if owner == own]


def _elements(robot: Declaration, path: str, raw: Any, source: str) -> dict[str, Any]:
    """The values of the file that a value by path changes."""
    known = changeable(robot)
    raw = _plain(raw, known.get(path), f"{source}: {path}")
    if path in (of_mechanism := wholes(robot.kind)):
        whole = of_mechanism[path]
        return dict(elements_of(robot, whole, _value_of_whole(robot, whole, raw, source)))
    if path in known:
        _check_taken(robot, path)
        return {path: raw}
    item = by_path(robot.kind).get(path)
    if item is None:
        vectors = [one.path for one in by_path(robot.kind).values() if one.path not in known and one.numbers]
        remedy = nearest(path, [*known, *vectors], "see docs/sensitivities.md for the paths")
        raise PkmodesError(f"unknown parameter path {shown(path)}", robot.source, remedy)
    if not item.numbers:
        what = f"{path} is no quantity: it cannot be changed here"
        raise PkmodesError(what, robot.source, "change the robot file")
    if not isinstance(raw, list | tuple) or len(raw) != len(item.numbers):
        found = f"{len(raw)}" if isinstance(raw, list | tuple) else shown(raw)
        what = f"expected a list of {len(item.numbers)} values, found {found}"
        raise PkmodesError(what, f"{source}: {path}", f"give {', '.join(item.key.elements)}")
    return {
        number.path: _plain(one, number.unit, f"{source}: {number.path}")
        for number, one in zip(item.numbers, raw, strict=True)
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


def _value_of_whole(robot: Declaration, whole: Whole, raw: Any, source: str) -> float:
    """The value of a whole, which has no standard deviation of its own."""
    where = f"{source}: {whole.path}"
    if isinstance(raw, Mapping) and raw.get("sigma") is not None:
        what = f"{whole.path} has no standard deviation: its elements have"
        raise PkmodesError(what, where, "give a value alone, and sigma to elements")
    if isinstance(raw, Mapping):
        raw = {key: value for key, value in raw.items() if key != "sigma"}
    try:
        return schema.quantity(raw, items_of(robot.kind, whole)[0].key.dimension, above=0.0).value
    except schema.RefusedError as error:
        raise PkmodesError(error.what, where, error.remedy) from None


def _check_taken(robot: Declaration, path: str) -> None:
    """A shared value in whose place every entry has its own would change nothing."""
    own = [item.path for item in takers(robot.kind).get(path, ())]
    if own and all(taker in robot.quantities for taker in own):
        raise PkmodesError(
            f"no {own[0].partition('.')[0]} takes the shared value {path}: each has its own",
            robot.source,
            f"change {', '.join(own[:-1])} and {own[-1]}",
        )


def _with_sigma(raw: Any, before: Quantity | None) -> Any:
    """A changed value with the standard deviation that it had, unless a table says otherwise."""
    table = dict(raw) if isinstance(raw, Mapping) else {"value": raw}
    if before is not None:
        table = {"value": before.value, "sigma": before.sigma, **table}
    if table.get("sigma", 0) is None:
        del table["sigma"]
    return table if set(table) != {"value"} else table["value"]


def _raw_values(robot: Declaration) -> dict[str, Any]:
    """What the robot declares, by path, as a robot file could have it."""
    return {
        path: _with_sigma({}, robot.quantities[path]) if path in robot.quantities else value
        for path, value in robot.declared.items()
    }
