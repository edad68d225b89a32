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
    by_path,
    dependents,
    effect_parameters,
    items,
    lent,
    takers,
)
from pkmodes.core.robot.tables import (
    FORMAT_HELP,
    Tables,
    default_of,
    of_effect,
    parameters_of,
    values_lent,
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
    - effects: parameters of effects, also those that tables lend or that are zero because the file does not give them
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
    merged = _merged(tables.values, items(mechanism))
    for shared, overrides in takers(mechanism).items():
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
    effects, constants = _by_effect(mechanism, tables.effects, merged)
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


def changed(robot: Declaration, changes: Mapping[str, Any], source: str) -> Declaration | None:
    """Return a robot with other values, without its correlations.

    The values are read by the rules of their keys, and the rules that concern several tables are checked again.

    - robot: with its `Content`
    - changes: as a robot file could contain them, by path of a number in a table or of a parameter of an effect
    - source: name of the robot, for messages

    None if a file with these values would be rejected: reading it reports why.
    """
    mechanism, content = robot.mechanism, robot.kept[CONTENT]
    keys = {item.path: item for path in changes if (item := by_path(mechanism).get(path)) is not None}
    try:
        quantities = {path: _number_at(mechanism, path, raw) for path, raw in changes.items()}
        given = {**content.given, **_values_of(keys.values(), quantities, content.given)}
    except schema.RefusedError:
        return None
    affected = {item.path: item for path in keys for item in dependents(mechanism, path)}.values()
    merged = {**content.merged, **_merged(given, affected)}
    moved = [item for item in affected if merged.get(item.path) is not content.merged.get(item.path)]
    parameters = _with_numbers(robot.parameters, moved, merged)
    for requirement in mechanism.requirements if moved else ():
        if violated(requirement, getattr(mechanism.model, requirement.function)(parameters)):
            return None
    effects = content.effects
    of_file = {
        path: quantity for path, quantity in quantities.items() if path in effect_parameters(mechanism)
    }
    if of_file or not keys.keys().isdisjoint(lent(mechanism).values()):
        problems: list[str] = []
        effects = _effects(mechanism, {**effects, **of_file}, given, lambda path, *_: problems.append(path))
        _check_effects(mechanism, effects, lambda path, *_: problems.append(path))
        if problems:
            return None
    if quantities.keys() <= robot.quantities.keys() and effects.keys() == content.effects.keys():
        quantities = {**robot.quantities, **quantities, **effects}
    else:
        quantities = {**_quantities(mechanism, given), **effects}
    numbers, constants = _by_effect(mechanism, effects, merged)
    other = replace(
        robot,
        source=source,
        parameters=parameters,
        quantities=quantities,
        effects=numbers,
        constants=constants,
        covariance=(),
    )
    other.kept[CONTENT] = Content(given, merged, effects)
    return other


def _number_at(mechanism: Mechanism, path: str, raw: Any) -> Quantity:
    """Read a number in a table, or a parameter of an effect.  Raises RefusedError if it does not accept the value."""
    item = by_path(mechanism).get(path)
    if item is not None:
        return schema.number_of(raw, item.key)
    _, effect, name = path.split(".")
    parameter = next(p for p in mechanism.effects[effect].parameters if p.name == name)
    return of_effect(raw, parameter)


def _values_of(
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
                quantities[number.path] if number.path in quantities else before[place]
                for place, number in enumerate(item.numbers)
            )
            schema.check_order(vector, item.key)
            values[item.path] = vector
    return values


def _merged(given: Values, of: Collection[Item]) -> dict[str, schema.Value]:
    """Return the values of keys: those given, else the shared values, else the defaults."""
    merged: dict[str, schema.Value] = {}
    for item in of:
        value = given.get(item.path, given.get(item.shared))
        if value is None:
            value = default_of(item.key)
        if value is not None:
            merged[item.path] = value
    for item in of:
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
    filled: dict[str, float | np.ndarray] = {}
    for field, numbers in fields.items():
        if () in numbers:
            filled[field] = numbers[()]
            continue
        array = np.full(np.max(list(numbers), axis=0) + 1, np.nan)
        for index, number in numbers.items():
            array[index] = number
        array.flags.writeable = False
        filled[field] = array
    return mechanism.model.Parameters(**filled)


def _with_numbers(parameters: Parameters, changed_items: Iterable[Item], values: Values) -> Parameters:
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
        of_item = [element for element in elements if isinstance(element, Quantity)]
        if of_item:
            quantities.update(zip((number.path for number in item.numbers), of_item, strict=True))
    return quantities


def _effects(
    mechanism: Mechanism, values: Mapping[str, Quantity], given: Values, problem: Problem
) -> dict[str, Quantity]:
    """Return the parameters of effects by path, with those that tables lend or that are zero.

    - values: those that the file gives, by path; what tables give they lend
    - given: values of the tables
    """
    names: dict[str, list[str]] = {}
    for path in values:
        if lent(mechanism).get(path) not in given:
            _, effect, name = path.split(".")
            names.setdefault(effect, []).append(name)
    declared = values_lent(mechanism, given) if names else {}
    effects: dict[str, Quantity] = {}
    for effect, of_file in names.items():
        effects |= parameters_of(
            mechanism.effects[effect], of_file, lambda _, path: values[path], declared, problem
        )
    return effects


def _by_effect(
    mechanism: Mechanism, effects: Mapping[str, Quantity], merged: Values
) -> tuple[dict[str, float], dict[str, float]]:
    """Return the parameters of the declared effects, and those that tables lend to any effect, by name."""
    constants = {path: effects.get(path, merged[table_path]) for path, table_path in lent(mechanism).items()}
    present = {path.rpartition(".")[0] for path in effects}
    lending = {path: value for path, value in constants.items() if path.rpartition(".")[0] in present}
    return _by_name({**effects, **lending}), _by_name(constants)


def _by_name(values: Values) -> dict[str, float]:
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
