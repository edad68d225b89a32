"""Validate a parsed robot file: return its declarations, or report every problem with its place.

Shared values are merged only if the tables have no problems, because a misspelled key would otherwise also be
reported as missing.  Conditions on the robot as a whole are checked only if nothing is missing.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot import schema
from pkmodes.core.robot.covariance import Problem, read_covariance
from pkmodes.core.robot.declaration import Declaration, Parameters
from pkmodes.core.robot.layout import (
    EFFECTS,
    Item,
    dependents,
    effect_parameters,
    items,
    items_by_path,
    overrides_by_path,
    table_sources,
)
from pkmodes.core.robot.tables import (
    FORMAT_HELP,
    Tables,
    default_of,
    read_effect_parameter,
    read_effect_parameters,
    values_from_tables,
)
from pkmodes.core.robot.units import DIMENSIONS, Quantity, article, with_unit
from pkmodes_description import Key, Requirement

Values = Mapping[str, schema.Value]
#: Key of `Declaration.kept`: the `Content`.
CONTENT = "content"


class Content(NamedTuple):
    """The values in the tables of a valid robot file, by path: a change of some of them begins with these.

    - given: as in the file, without merging and without defaults
    - merged: of all keys: those given, else the shared values, else the defaults
    - effects: parameters of effects, including those taken from tables and those that are zero by default
    """

    given: Values
    merged: Values
    effects: Mapping[str, Quantity]


def declaration(document: Mapping[str, Any], source: str) -> Declaration:
    """Validate a parsed robot file.

    - source: name of the file, for messages

    Raises RobotFileError with one problem for each thing to fix.
    """
    tables = Tables(document, source)
    tables.raise_problems()
    mechanism = tables.mechanism
    merged = _merged_values(tables.values, items(mechanism))
    for shared, overrides in overrides_by_path(mechanism).items():
        if any(item.path not in merged for item in overrides):
            key = overrides[0].key
            example = f'expected {article(key.dimension)} such as "{DIMENSIONS[key.dimension][1]}"'
            tables.problem(shared, f"{example}, found nothing", f"add the key {key.name}; {FORMAT_HELP}")
    tables.raise_problems()
    parameters = _parameters(mechanism, merged)
    numbers = _quantities(mechanism, merged)
    for requirement in mechanism.requirements:
        margins = getattr(mechanism.model, requirement.function)(parameters)
        _check(requirement, margins, numbers, tables.problem)
    _check_effects(mechanism, tables.effects, tables.problem)
    tables.raise_problems()
    quantities = {**_quantities(mechanism, tables.values), **tables.effects}
    covariance = read_covariance(tables.covariance, mechanism, quantities, tables.problem)
    tables.raise_problems()
    effects, constants = _effect_values(mechanism, tables.effects, merged)
    robot = Declaration(
        name=tables.name,
        mechanism_name=mechanism.name,
        source=source,
        parameters=parameters,
        quantities=quantities,
        effects=effects,
        constants=constants,
        usable=tables.usable,
        report=tables.report,
        covariance=covariance,
        drives=tables.drives,
    )
    robot.kept[CONTENT] = Content(tables.values, merged, tables.effects)
    return robot


def with_changes(robot: Declaration, changes: Mapping[str, Any], source: str) -> Declaration | None:
    """Return a robot with other values, without its correlations.

    The values are read by the rules of their keys, and the rules that concern several tables are checked again.

    - robot: with its `Content`
    - changes: as a robot file could contain them, by path of a number in a table or of a parameter of an effect
    - source: name of the robot, for messages

    Returns None if a file with these values would be rejected; reading such a file reports why.
    """
    mechanism, content = robot.mechanism, robot.kept[CONTENT]
    keys = {item.path: item for path in changes if (item := items_by_path(mechanism).get(path)) is not None}
    try:
        quantities = {path: _number_at(mechanism, path, raw) for path, raw in changes.items()}
        given = {**content.given, **_changed_values(keys.values(), quantities, content.given)}
    except schema.RefusedError:
        return None
    affected = {item.path: item for path in keys for item in dependents(mechanism, path)}.values()
    merged = {**content.merged, **_merged_values(given, affected)}
    changed_items = [item for item in affected if merged.get(item.path) is not content.merged.get(item.path)]
    parameters = _with_changed_fields(robot.parameters, changed_items, merged)
    for requirement in mechanism.requirements if changed_items else ():
        if violated(requirement, getattr(mechanism.model, requirement.function)(parameters)):
            return None
    effects = content.effects
    effect_changes = {
        path: quantity for path, quantity in quantities.items() if path in effect_parameters(mechanism)
    }
    if effect_changes or not keys.keys().isdisjoint(table_sources(mechanism).values()):
        problems: list[str] = []
        effects = _effects(
            mechanism, {**effects, **effect_changes}, given, lambda path, *_: problems.append(path)
        )
        _check_effects(mechanism, effects, lambda path, *_: problems.append(path))
        if problems:
            return None
    if quantities.keys() <= robot.quantities.keys() and effects.keys() == content.effects.keys():
        quantities = {**robot.quantities, **quantities, **effects}
    else:
        quantities = {**_quantities(mechanism, given), **effects}
    effect_values, constants = _effect_values(mechanism, effects, merged)
    result = replace(
        robot,
        source=source,
        parameters=parameters,
        quantities=quantities,
        effects=effect_values,
        constants=constants,
        covariance=(),
    )
    result.kept[CONTENT] = Content(given, merged, effects)
    return result


def _number_at(mechanism: Mechanism, path: str, raw: Any) -> Quantity:
    """Read a number in a table, or a parameter of an effect.  Raises RefusedError if it does not accept the value."""
    item = items_by_path(mechanism).get(path)
    if item is not None:
        return schema.read_quantity(raw, item.key)
    _, effect, name = path.split(".")
    parameter = next(p for p in mechanism.effects[effect].parameters if p.name == name)
    return read_effect_parameter(raw, parameter)


def _changed_values(
    changed_items: Iterable[Item], quantities: Mapping[str, Quantity], given: Values
) -> dict[str, schema.Value]:
    """Return the values of keys with other numbers, by path.

    - quantities: the numbers, by path; a vector has its other elements from `given`

    Raises RefusedError if the limits of a pair are not in order.
    """
    values: dict[str, schema.Value] = {}
    for item in changed_items:
        if item.key.kind == "quantity":
            values[item.path] = quantities[item.path]
        else:
            before: Any = given.get(item.path)  # None for a vector whose elements all change
            vector = tuple(
                quantities[number.path] if number.path in quantities else before[position]
                for position, number in enumerate(item.numbers)
            )
            schema.check_limit_order(vector, item.key)
            values[item.path] = vector
    return values


def _merged_values(given: Values, wanted_items: Collection[Item]) -> dict[str, schema.Value]:
    """Return the values of keys: those given, else the shared values, else the defaults."""
    merged: dict[str, schema.Value] = {}
    for item in wanted_items:
        value = given.get(item.path, given.get(item.shared))
        if value is None:
            value = default_of(item.key)
        if value is not None:
            merged[item.path] = value
    for item in wanted_items:
        pair = merged.get(item.key.middle_of)
        if item.path not in merged and isinstance(pair, tuple):
            low, high = (_number(end) for end in pair)
            merged[item.path] = Quantity((low + high) / 2.0, DIMENSIONS[item.key.dimension][0])
    return merged


def _parameters(mechanism: Mechanism, values: Values) -> Parameters:
    """Return the parameters of the generated model, with every number in its field."""
    fields: dict[str, dict[tuple[int, ...], float]] = {
        field: {} for field in mechanism.model.Parameters._fields
    }
    for item in items(mechanism):
        if item.key.field and item.index is not None:
            for element, number in _numbers(item.key, values[item.path]).items():
                fields[item.key.field][(*item.index, *element)] = number
    field_values: dict[str, float | np.ndarray] = {}
    for field, numbers in fields.items():
        if () in numbers:
            field_values[field] = numbers[()]
            continue
        array = np.full(np.max(list(numbers), axis=0) + 1, np.nan)
        for index, number in numbers.items():
            array[index] = number
        array.flags.writeable = False
        field_values[field] = array
    return mechanism.model.Parameters(**field_values)


def _with_changed_fields(parameters: Parameters, changed_items: Iterable[Item], values: Values) -> Parameters:
    """Return the parameters of the generated model with the numbers of some keys in their fields."""
    fields: dict[str, NDArray[np.float64]] = {}
    for item in changed_items:
        if item.key.field and item.index is not None:
            field = fields.setdefault(
                item.key.field, np.array(getattr(parameters, item.key.field), dtype=float)
            )
            for element, number in _numbers(item.key, values[item.path]).items():
                field[(*item.index, *element)] = number
    for field in fields.values():
        field.flags.writeable = False
    return parameters._replace(
        **{name: field if field.shape else float(field) for name, field in fields.items()}
    )


def _numbers(key: Key, value: schema.Value) -> dict[tuple[int, ...], float]:
    """Return the numbers of one value by index."""
    if key.kind == "one_of":
        return {(i,): float(choice == value) for i, choice in enumerate(key.choices)}
    if isinstance(value, tuple):
        return {(i,): _number(element) for i, element in enumerate(value)}
    return {(): _number(value)}


def _number(value: schema.Value | float) -> float:
    """Return the number of a value that is not a vector."""
    assert not isinstance(value, tuple)
    return value.value if isinstance(value, Quantity) else float(value)


def _quantities(mechanism: Mechanism, values: Values) -> dict[str, Quantity]:
    """Return every quantity by path, in the order of the format."""
    quantities: dict[str, Quantity] = {}
    for item in items(mechanism):
        value = values.get(item.path)
        elements = value if isinstance(value, tuple) else (value,)
        item_quantities = [element for element in elements if isinstance(element, Quantity)]
        if item_quantities:
            quantities.update(zip((number.path for number in item.numbers), item_quantities, strict=True))
    return quantities


def _effects(
    mechanism: Mechanism, values: Mapping[str, Quantity], given: Values, problem: Problem
) -> dict[str, Quantity]:
    """Return the parameters of effects by path, including those taken from tables and those that are zero.

    - values: the parameters before, by path; those taken from tables are read again
    - given: values of the tables
    """
    names: dict[str, list[str]] = {}
    for path in values:
        if table_sources(mechanism).get(path) not in given:
            _, effect, name = path.split(".")
            names.setdefault(effect, []).append(name)
    declared = values_from_tables(mechanism, given) if names else {}
    effects: dict[str, Quantity] = {}
    for effect, parameter_names in names.items():
        effects |= read_effect_parameters(
            mechanism.effects[effect], parameter_names, lambda _, path: values[path], declared, problem
        )
    return effects


def _effect_values(
    mechanism: Mechanism, effects: Mapping[str, Quantity], merged: Values
) -> tuple[dict[str, float], dict[str, float]]:
    """Return the parameters of the declared effects, and those that any effect takes from tables, by name."""
    constants = {
        path: effects.get(path, merged[table_path]) for path, table_path in table_sources(mechanism).items()
    }
    declared_effects = {path.rpartition(".")[0] for path in effects}
    from_tables = {
        path: value for path, value in constants.items() if path.rpartition(".")[0] in declared_effects
    }
    return _values_by_name({**effects, **from_tables}), _values_by_name(constants)


def _values_by_name(values: Values) -> dict[str, float]:
    return {path.removeprefix(f"{EFFECTS}."): _number(value) for path, value in values.items()}


def _check_effects(mechanism: Mechanism, effects: Mapping[str, Quantity], problem: Problem) -> None:
    """Check the conditions of the declared effects on their parameters."""
    declared = {path.split(".")[1] for path in effects}
    for name in [name for name in declared if mechanism.effects[name].requirements]:
        effect_quantities = {path: q for path, q in effects.items() if path.split(".")[1] == name}
        effect_values = {
            path.removeprefix(f"{EFFECTS}.").replace(".", "_"): q.value
            for path, q in effect_quantities.items()
        }
        for requirement in mechanism.effects[name].requirements:
            margin = getattr(mechanism.extended, requirement.function)(
                mechanism.extended.Effects(**effect_values)
            )
            _check(requirement, margin, effect_quantities, problem)


def _check(
    requirement: Requirement,
    margins: Any,
    numbers: Mapping[str, Quantity],
    problem: Problem,
) -> None:
    """Add a problem for each place where a requirement is violated.

    In its sentence ``{limits.min}`` is the value at that path in the table of the place.
    """
    for place, margin in violated(requirement, margins).items():
        values = {
            "missing": Quantity(0.0 - margin, requirement.unit),
            "value": Quantity(margin, requirement.unit),
            **{path.removeprefix(f"{place.rpartition('.')[0]}."): number for path, number in numbers.items()},
        }
        sentence = requirement.sentence
        for name, quantity in values.items():
            sentence = sentence.replace(f"{{{name}}}", with_unit(quantity.value, quantity.unit))
        problem(place, sentence, requirement.remedy)


def violated(requirement: Requirement, margins: Any) -> dict[str, float]:
    """Return the margins of a requirement that violate it, by place."""
    return {
        place: margin
        for place, margin in zip(requirement.places, np.ravel(margins).tolist(), strict=True)
        if not (margin > 0.0 or (margin == 0.0 and requirement.rule == "at_least_zero"))
    }
