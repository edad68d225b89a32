"""A robot with other values: the robot that a file with these values would declare.

One set of rules applies: each value is read by those of its key, and those that concern several tables are checked
again.  Where one is violated, the document with these values is read like a robot file, which reports all problems.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot import schema
from pkmodes.core.robot.covariance import COVARIANCE, Covariance, with_sigmas
from pkmodes.core.robot.declaration import Declaration, changeable_units, unit_of
from pkmodes.core.robot.layout import EFFECTS, Number, items, items_by_path, overrides_by_path, table_sources
from pkmodes.core.robot.parameter_groups import elements_at_value, group_items, groups_by_path
from pkmodes.core.robot.report_fields import REPORT
from pkmodes.core.robot.tables import FORMAT, STATE_OF_MOTORS
from pkmodes.core.robot.units import Quantity
from pkmodes.core.robot.usable import USABLE, Bound, limit_in_file
from pkmodes.core.robot.validation import CONTENT, declaration, with_changes
from pkmodes_description import Key, ParameterGroup

SOURCE_SUFFIX = " with other values"


def with_values(robot: Declaration, values: Mapping[str, Any]) -> Declaration:
    """Return the declaration of a file with these values: see `pkmodes.Robot.with_values`."""
    if not isinstance(values, Mapping):
        raise PkmodesError(
            f"expected values by path, found {shown(values)}",
            "values",
            'for example: {"frame.mass": "60 kg"}',
        )
    source = robot.source.removesuffix(SOURCE_SUFFIX) + SOURCE_SUFFIX
    changes = _file_changes(robot, values, source)
    if CONTENT not in robot.kept:
        declared = _read(robot, raw_values(robot), source, robot.covariance)
        if declared != robot:
            raise PkmodesError(
                "the robot's parameters differ from those that it declares",
                robot.source,
                "start from a robot that was read from a file",
            )
        robot.kept[CONTENT] = declared.kept[CONTENT]
    variant = with_changes(robot, changes, source)
    if variant is None:
        variant = _read(robot, {**raw_values(robot), **changes}, source)
    if robot.covariance:  # a value without a standard deviation has no correlations
        paths = {path for table in robot.covariance for path in table.paths}
        sigmas = {path: quantity.sigma for path, quantity in variant.quantities.items() if path in paths}
        new_sigmas = {
            path: sigmas.get(path) for path in paths if sigmas.get(path) != robot.quantities[path].sigma
        }
        content = variant.kept[CONTENT]
        variant = replace(variant, covariance=with_sigmas(robot.covariance, new_sigmas))
        variant.kept[CONTENT] = content
    return variant


def document_of(
    mechanism: Mechanism,
    name: str,
    values: Mapping[str, Any],
    usable: Mapping[str, Bound] | None = None,
    report: Mapping[str, str] | None = None,
    covariance: Sequence[Covariance] = (),
    drives: str = FREE,
) -> dict[str, Any]:
    """Return the document of a robot file with only these values.

    - name: the robot's name
    - values: by path, as a file could contain them; a vector by all of its elements
    - usable: where the machine is used
    - report: fields for the header of reports
    - covariance: tables of values with correlated errors
    - drives: what the motors do where the machine is used

    Raises KeyError if an element of a vector is missing.
    """
    document: dict[str, Any] = {"format": FORMAT, "name": name, "mechanism": mechanism.name}
    if drives != FREE:
        document[STATE_OF_MOTORS] = drives
    for table in mechanism.tables:
        if table.count:
            document[table.name] = [{} for _ in range(table.count)]
    for item in items(mechanism):
        elements = [number.path for number in item.numbers if number.path != item.path]
        if item.path in values:
            _set_at(document, item.key_path, values[item.path])
        elif any(path in values for path in elements):
            _set_at(document, item.key_path, [values[path] for path in elements])
    for path, raw in values.items():
        # A value that an effect takes from a table is declared in the table; the effect only repeats it.
        if path.startswith(f"{EFFECTS}.") and table_sources(mechanism).get(path) not in values:
            _set_at(document, tuple(path.split(".")), raw)
    if usable:
        document[USABLE] = {name: limit_in_file(bound) for name, bound in usable.items()}
    if report:
        document[REPORT] = dict(report)
    if covariance:
        document[COVARIANCE] = [table.raw() for table in covariance]
    return document


def _set_at(document: dict[str, Any], key_path: tuple[str | int, ...], raw: Any) -> None:
    node: Any = document
    for key in key_path[:-1]:
        node = node[key] if isinstance(key, int) else node.setdefault(key, {})
    node[key_path[-1]] = raw


def _read(
    robot: Declaration, values: Mapping[str, Any], source: str, covariance: Sequence[Covariance] = ()
) -> Declaration:
    """Return the declaration of a file with only these values."""
    document = document_of(
        robot.mechanism, robot.name, values, robot.usable, robot.report, covariance, robot.drives
    )
    return declaration(document, source)


def _file_changes(robot: Declaration, values: Mapping[str, Any], source: str) -> dict[str, Any]:
    """Return the changed values of the file by path, as a robot file could contain them."""
    table_path_of = table_sources(robot.mechanism)
    changes: dict[str, Any] = {}
    for path, raw in values.items():
        if not isinstance(path, str):
            problem = f"expected a parameter path, found {shown(path)}"
            raise PkmodesError(problem, "values", 'for example: {"frame.mass": "60 kg"}')
        if raw is None or (isinstance(raw, Mapping) and raw.get("value", raw) is None):
            remedy = "give a number or text with a unit; 0 means no effect"
            raise PkmodesError("expected a value, found None", f"{source}: {path}", remedy)
        target = (
            table_path_of[path] if path in table_path_of and _takes_table_value(robot, values, path) else path
        )
        for element, value in _element_values(robot, target, raw, source).items():
            effect_paths = [effect for effect, table_path in table_path_of.items() if table_path == element]
            if {element, table_path_of.get(element), *effect_paths} & changes.keys():
                problem = "the value would be changed twice"
                raise PkmodesError(problem, f"{source}: {element}", "change it only once")
            changes[element] = value
    for path in list(changes):
        item = items_by_path(robot.mechanism).get(path)
        if item is not None and path != item.path and path not in robot.quantities:
            # The file does not give this vector: with one element changed, it has to give the others, too.
            for number in item.numbers:
                changes.setdefault(number.path, _current_number(robot, item.key, number))
    table_quantities = {table_path: robot.quantities.get(path) for path, table_path in table_path_of.items()}
    return {
        path: _with_sigma(raw, robot.quantities.get(path, table_quantities.get(path)))
        for path, raw in changes.items()
    }


def _current_number(robot: Declaration, key: Key, number: Number) -> float | None:
    """Return a number that the file does not give: that of the generated parameters, or else its default."""
    if number.slot is None:
        return key.default
    field, index = number.slot
    return float(np.asarray(getattr(robot.parameters, field))[index])


def _takes_table_value(robot: Declaration, values: Mapping[str, Any], path: str) -> bool:
    """Return whether an effect parameter takes its value from a table instead of declaring it."""
    effect = path.split(".")[1]
    paths = {f"{EFFECTS}.{effect}.{p.name}" for p in robot.mechanism.effects[effect].parameters} - {path}
    in_table = table_sources(robot.mechanism)[path] in robot.quantities
    return in_table or (paths.isdisjoint(robot.quantities) and paths.isdisjoint(values))


def _element_values(robot: Declaration, path: str, raw: Any, source: str) -> dict[str, Any]:
    """Return the values of the file that a value by path changes."""
    unit = unit_of(robot, path)
    raw = _plain(raw, unit, f"{source}: {path}")
    if path in (of_mechanism := groups_by_path(robot.mechanism)):
        group = of_mechanism[path]
        return dict(elements_at_value(robot, group, _value_of_group(robot, group, raw, source)))
    if unit is not None:
        overrides = [item.path for item in overrides_by_path(robot.mechanism).get(path, ())]
        if overrides and all(taker in robot.quantities for taker in overrides):  # it would have no effect
            raise PkmodesError(
                f"no {overrides[0].partition('.')[0]} takes the shared value {path}: each overrides it",
                robot.source,
                f"change {', '.join(overrides[:-1])} and {overrides[-1]}",
            )
        return {path: raw}
    item = items_by_path(robot.mechanism).get(path)
    if item is None:
        units = changeable_units(robot)
        vectors = [
            candidate.path
            for candidate in items_by_path(robot.mechanism).values()
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
        return schema.parse_quantity(
            raw, group_items(robot.mechanism, group)[0].key.dimension, above=0.0
        ).value
    except schema.RefusedError as error:
        raise PkmodesError(error.what, where, error.remedy) from None


def _with_sigma(raw: Any, previous: Quantity | None) -> Any:
    """Return a changed value with its previous standard deviation, unless a table gives another."""
    table = dict(raw) if isinstance(raw, Mapping) else {"value": raw}
    if previous is not None:
        table = {"value": previous.value, "sigma": previous.sigma, **table}
    if table.get("sigma", 0) is None:
        del table["sigma"]
    return table if set(table) != {"value"} else table["value"]


def raw_values(robot: Declaration) -> dict[str, Any]:
    """Return the robot's declared values by path, as a robot file could contain them."""
    return {
        path: _with_sigma({}, robot.quantities[path]) if path in robot.quantities else value
        for path, value in robot.declared.items()
    }
