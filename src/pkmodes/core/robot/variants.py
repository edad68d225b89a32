"""A robot with other values: the document that declares it is changed and then read like a robot file.

This way one set of rules applies, and values that a file could not have are rejected here too.  Numbers that only
replace others are checked by the same rules, but the rest of the document is not read again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot import schema
from pkmodes.core.robot.covariance import COVARIANCE, Covariance, with_sigmas
from pkmodes.core.robot.declaration import Declaration, changeable
from pkmodes.core.robot.layout import EFFECTS, Slot, by_path, items, lent, takers
from pkmodes.core.robot.parameter_groups import elements_of, groups_by_path, items_of
from pkmodes.core.robot.report_fields import REPORT
from pkmodes.core.robot.tables import FORMAT, of_effect
from pkmodes.core.robot.units import Quantity
from pkmodes.core.robot.usable import USABLE, Bound, raw_of
from pkmodes.core.robot.validation import declaration, violated
from pkmodes_description import ParameterGroup

OTHER_VALUES = " with other values"
#: Key of `Declaration.kept`: the parameters are known to match the declared values.
CONSISTENT = "consistent"


def with_values(robot: Declaration, values: Mapping[str, Any]) -> Declaration:
    """Return the declaration of a file with these values: see `pkmodes.Robot.with_values`."""
    if not isinstance(values, Mapping):
        raise PkmodesError(
            f"expected values by path, found {shown(values)}",
            "values",
            'for example: {"frame.mass": "60 kg"}',
        )
    source = robot.source.removesuffix(OTHER_VALUES) + OTHER_VALUES
    changes = _changes(robot, values, source)
    if not robot.kept.get(CONSISTENT):
        if _read(robot, raw_values(robot), source, robot.covariance) != robot:
            raise PkmodesError(
                "the robot's parameters differ from those that it declares",
                robot.source,
                "start from a robot that was read from a file",
            )
        robot.kept[CONSISTENT] = True
    changed = _with_replaced(robot, changes, source)
    if changed is None:
        changed = _read(robot, {**raw_values(robot), **changes}, source)
    return replace(changed, covariance=_covariance(robot, changed)) if robot.covariance else changed


def _with_replaced(robot: Declaration, changes: Mapping[str, Any], source: str) -> Declaration | None:
    """Return the declaration with numbers that replace others, without reading the rest of the document.

    None if further rules apply than those of each number and of the machine as a whole, or if one of these is
    violated: reading the document reports what is wrong.
    """
    mechanism = robot.mechanism
    quantities, effects = dict(robot.quantities), dict(robot.effects)
    arrays: dict[str, NDArray[np.float64]] = {}
    for path, raw in changes.items():
        number = _replaceable(mechanism, path) if path in quantities else None
        if number is None:
            return None
        try:
            quantities[path] = number.read(raw)
        except schema.RefusedError:
            return None
        for field, index in (
            slot for slot_path, slot in number.slots if slot_path == path or slot_path not in quantities
        ):
            if field in effects:
                effects[field] = quantities[path].value
                continue
            if field not in arrays:
                arrays[field] = np.array(getattr(robot.parameters, field), dtype=float)
            arrays[field][index] = quantities[path].value
    for array in arrays.values():
        array.flags.writeable = False
    parameters = robot.parameters._replace(
        **{field: array if array.shape else float(array) for field, array in arrays.items()}
    )
    for requirement in mechanism.requirements:
        if violated(requirement, getattr(mechanism.model, requirement.function)(parameters)):
            return None
    changed = replace(
        robot, source=source, parameters=parameters, quantities=quantities, effects=effects, covariance=()
    )
    changed.kept[CONSISTENT] = True
    return changed


class _Replaceable(NamedTuple):
    """A number that another one may replace: how that is read, and where it goes.

    - read: from what a robot file may contain
    - slots: in the generated parameters or effects, each with the path that would give it another value
    """

    read: Callable[[Any], Quantity]
    slots: list[tuple[str, Slot]]


@cache
def _replaceable(mechanism: Mechanism, path: str) -> _Replaceable | None:
    """Return how the number at a path is replaced; None if other values depend on it."""
    item = by_path(mechanism).get(path)
    if item is None:
        _, effect, name = path.split(".") if path.startswith(f"{EFFECTS}.") else ("", "", "")
        if (
            effect not in mechanism.effects
            or path in lent(mechanism)
            or mechanism.effects[effect].requirements
        ):
            return None
        (parameter,) = (
            parameter for parameter in mechanism.effects[effect].parameters if parameter.name == name
        )
        return _Replaceable(partial(of_effect, parameter=parameter), [(path, (f"{effect}.{name}", ()))])
    key = item.key
    if key.kind not in ("quantity", "vector") or key.effect or key.middle_of:
        return None
    place = [number.path for number in item.numbers].index(path)
    numbers = [taker.numbers[place] for taker in (item, *takers(mechanism).get(item.path, ()))]
    slots = [(number.path, number.slot) for number in numbers if number.slot is not None]
    return _Replaceable(partial(schema.number_of, key=key), slots)


def document_of(
    mechanism: Mechanism,
    name: str,
    values: Mapping[str, Any],
    usable: Mapping[str, Bound] | None = None,
    report: Mapping[str, str] | None = None,
    covariance: Sequence[Covariance] = (),
) -> dict[str, Any]:
    """Return the document of a robot file with only these values.

    - name: the robot's name
    - values: by path, as a file could contain them; a vector by all of its elements
    - usable: where the machine is used
    - report: fields of the head of reports
    - covariance: values whose errors belong together

    Raises KeyError if an element of a vector is missing.
    """
    document: dict[str, Any] = {"format": FORMAT, "name": name, "mechanism": mechanism.name}
    for table in mechanism.tables:
        if table.count:
            document[table.name] = [{} for _ in range(table.count)]
    for item in items(mechanism):
        elements = [number.path for number in item.numbers if number.path != item.path]
        if item.path in values:
            _put(document, item.place, values[item.path])
        elif any(path in values for path in elements):
            _put(document, item.place, [values[path] for path in elements])
    for path, raw in values.items():
        # A value that an effect takes from a table is declared in the table; the effect only repeats it.
        if path.startswith(f"{EFFECTS}.") and lent(mechanism).get(path) not in values:
            _put(document, tuple(path.split(".")), raw)
    if usable:
        document[USABLE] = {name: raw_of(bound) for name, bound in usable.items()}
    if report:
        document[REPORT] = dict(report)
    if covariance:
        document[COVARIANCE] = [table.raw() for table in covariance]
    return document


def _put(document: dict[str, Any], place: tuple[str | int, ...], raw: Any) -> None:
    node: Any = document
    for key in place[:-1]:
        node = node[key] if isinstance(key, int) else node.setdefault(key, {})
    node[place[-1]] = raw


def _read(
    robot: Declaration, values: Mapping[str, Any], source: str, covariance: Sequence[Covariance] = ()
) -> Declaration:
    """Return the declaration of a file with only these values."""
    document = document_of(robot.mechanism, robot.name, values, robot.usable, robot.report, covariance)
    return declaration(document, source)


def _covariance(robot: Declaration, changed: Declaration) -> tuple[Covariance, ...]:
    """Return the correlations of a robot with other values: a value without a standard deviation has none."""
    sigmas = {path: quantity.sigma for path, quantity in changed.quantities.items()}
    changed_sigmas = {
        path: sigmas.get(path)
        for table in robot.covariance
        for path in table.paths
        if sigmas.get(path) != robot.quantities[path].sigma
    }
    return with_sigmas(robot.covariance, changed_sigmas)


def _changes(robot: Declaration, values: Mapping[str, Any], source: str) -> dict[str, Any]:
    """Return the changed values of the file by path, as a robot file could contain them."""
    owners = {
        path: table_path
        for path, table_path in lent(robot.mechanism).items()
        if _lent_now(robot, values, path, table_path)
    }
    changes: dict[str, Any] = {}
    for path, raw in values.items():
        if not isinstance(path, str):
            problem = f"expected a parameter path, found {shown(path)}"
            raise PkmodesError(problem, "values", 'for example: {"frame.mass": "60 kg"}')
        if raw is None or (isinstance(raw, Mapping) and raw.get("value", raw) is None):
            remedy = "give a number or text with a unit; 0 means no effect"
            raise PkmodesError("expected a value, found None", f"{source}: {path}", remedy)
        for element, value in _elements(robot, owners.get(path, path), raw, source).items():
            borrowers = [
                effect for effect, table_path in lent(robot.mechanism).items() if table_path == element
            ]
            if {element, lent(robot.mechanism).get(element), *borrowers} & changes.keys():
                problem = "the value would be changed twice"
                raise PkmodesError(problem, f"{source}: {element}", "change it only once")
            changes[element] = value
    before = {table_path: robot.quantities.get(path) for path, table_path in lent(robot.mechanism).items()}
    return {path: _with_sigma(raw, {**before, **robot.quantities}.get(path)) for path, raw in changes.items()}


def _lent_now(robot: Declaration, values: Mapping[str, Any], path: str, table_path: str) -> bool:
    """Return whether an effect parameter takes its value from a table instead of declaring it."""
    effect = path.rpartition(".")[0]
    other_names = {name for name in (*robot.quantities, *values) if isinstance(name, str)} - {path}
    return table_path in robot.quantities or not any(name.startswith(f"{effect}.") for name in other_names)


def _elements(robot: Declaration, path: str, raw: Any, source: str) -> dict[str, Any]:
    """Return the values of the file that a value by path changes."""
    units = changeable(robot)
    raw = _plain(raw, units.get(path), f"{source}: {path}")
    if path in (of_mechanism := groups_by_path(robot.mechanism)):
        group = of_mechanism[path]
        return dict(elements_of(robot, group, _value_of_group(robot, group, raw, source)))
    if path in units:
        _check_taken(robot, path)
        return {path: raw}
    item = by_path(robot.mechanism).get(path)
    if item is None:
        vectors = [
            candidate.path
            for candidate in by_path(robot.mechanism).values()
            if candidate.path not in units and candidate.numbers
        ]
        remedy = nearest_name(path, [*units, *vectors], "see docs/reference/parameter-paths.md for the paths")
        raise PkmodesError(f"unknown parameter path {shown(path)}", robot.source, remedy)
    if not item.numbers:
        problem = f"{path} is not a quantity: it cannot be changed here"
        raise PkmodesError(problem, robot.source, "change the robot file")
    if not isinstance(raw, list | tuple) or len(raw) != len(item.numbers):
        actual = f"{len(raw)}" if isinstance(raw, list | tuple) else shown(raw)
        problem = f"expected a list of {len(item.numbers)} values, found {actual}"
        raise PkmodesError(problem, f"{source}: {path}", f"give {', '.join(item.key.elements)}")
    return {
        number.path: _plain(element, number.unit, f"{source}: {number.path}")
        for number, element in zip(item.numbers, raw, strict=True)
    }


def _plain(raw: Any, unit: str | None, where: str) -> Any:
    """Return a value as a robot file could contain it, without NumPy types and `Quantity`."""
    if isinstance(raw, np.ndarray | np.generic):
        return raw.tolist()
    if isinstance(raw, Quantity):
        if raw.unit != unit:
            problem = f"expected a quantity in {unit}, found one in {raw.unit}"
            raise PkmodesError(problem, where, "give a quantity with that unit")
        return {"value": raw.value, "sigma": raw.sigma}
    if isinstance(raw, Mapping):
        return {key: _plain(value, unit, where) for key, value in raw.items()}
    return raw


def _value_of_group(robot: Declaration, group: ParameterGroup, raw: Any, source: str) -> float:
    """Read the value of a group, which cannot have a standard deviation."""
    where = f"{source}: {group.path}"
    if isinstance(raw, Mapping) and raw.get("sigma") is not None:
        problem = f"{group.path} has no standard deviation: only its elements have one"
        raise PkmodesError(problem, where, "give the value only, and give sigma for the elements")
    if isinstance(raw, Mapping):
        raw = {key: value for key, value in raw.items() if key != "sigma"}
    try:
        return schema.quantity(raw, items_of(robot.mechanism, group)[0].key.dimension, above=0.0).value
    except schema.RefusedError as error:
        raise PkmodesError(error.what, where, error.remedy) from None


def _check_taken(robot: Declaration, path: str) -> None:
    """Reject a change of a shared value that every entry overrides: it would have no effect."""
    overrides = [item.path for item in takers(robot.mechanism).get(path, ())]
    if overrides and all(taker in robot.quantities for taker in overrides):
        raise PkmodesError(
            f"no {overrides[0].partition('.')[0]} takes the shared value {path}: each overrides it",
            robot.source,
            f"change {', '.join(overrides[:-1])} and {overrides[-1]}",
        )


def _with_sigma(raw: Any, before: Quantity | None) -> Any:
    """Return a changed value with its previous standard deviation, unless a table gives another."""
    table = dict(raw) if isinstance(raw, Mapping) else {"value": raw}
    if before is not None:
        table = {"value": before.value, "sigma": before.sigma, **table}
    if table.get("sigma", 0) is None:
        del table["sigma"]
    return table if set(table) != {"value"} else table["value"]


def raw_values(robot: Declaration) -> dict[str, Any]:
    """Return the robot's declared values by path, as a robot file could contain them."""
    return {
        path: _with_sigma({}, robot.quantities[path]) if path in robot.quantities else value
        for path, value in robot.declared.items()
    }
