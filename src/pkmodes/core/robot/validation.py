"""Validate a parsed robot file: return its declarations, or report every problem with its place.

Shared values are merged only if the tables have no problems, because a misspelled key would otherwise also be
reported as missing.  Conditions on the robot as a whole are checked only if nothing is missing.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot import schema
from pkmodes.core.robot.covariance import read_covariance
from pkmodes.core.robot.declaration import Declaration, Parameters
from pkmodes.core.robot.layout import EFFECTS, items, lent, takers
from pkmodes.core.robot.tables import FORMAT_HELP, Tables, default_of
from pkmodes.core.robot.units import DIMENSIONS, Quantity, article, with_unit
from pkmodes_description import Key, Requirement

Values = Mapping[str, schema.Value]


def declaration(document: Mapping[str, Any], source: str) -> Declaration:
    """Validate a parsed robot file.

    - source: name of the file, for messages

    Raises RobotFileError with one problem for each thing to fix.
    """
    tables = Tables(document, source)
    tables.raise_problems()
    mechanism = tables.mechanism
    values = _merged(tables)
    tables.raise_problems()
    parameters = _parameters(mechanism, values)
    numbers = _quantities(mechanism, values)
    for requirement in mechanism.requirements:
        _check(requirement, getattr(mechanism.model, requirement.function)(parameters), numbers, tables)
    _check_effects(mechanism, tables)
    tables.raise_problems()
    quantities = {**_quantities(mechanism, tables.values), **tables.effects}
    covariance = read_covariance(tables.covariance, mechanism, quantities, tables.problem)
    tables.raise_problems()
    constants = {
        path: tables.effects.get(path) or numbers[table_path] for path, table_path in lent(mechanism).items()
    }
    present = {path.rpartition(".")[0] for path in tables.effects}
    lending = {path: value for path, value in constants.items() if path.rpartition(".")[0] in present}
    return Declaration(
        name=tables.name,
        mechanism_name=mechanism.name,
        source=source,
        parameters=parameters,
        quantities=quantities,
        effects=_by_effect({**tables.effects, **lending}),
        constants=_by_effect(constants),
        usable=tables.usable,
        report=tables.report,
        covariance=covariance,
    )


def _merged(tables: Tables) -> dict[str, schema.Value]:
    """Return the values of all keys: those given, else the shared values, else the defaults."""
    merged: dict[str, schema.Value] = {}
    for item in items(tables.mechanism):
        declared = tables.values.get(item.path, tables.values.get(item.shared))
        value = declared if declared is not None else default_of(item.key)
        if value is not None:
            merged[item.path] = value
    for item in items(tables.mechanism):
        pair = merged.get(item.key.middle_of)
        if item.path not in merged and isinstance(pair, tuple):
            low, high = (_number(end) for end in pair)
            merged[item.path] = Quantity((low + high) / 2.0, DIMENSIONS[item.key.dimension][0])
    for shared, overrides in takers(tables.mechanism).items():
        if any(item.path not in merged for item in overrides):
            key = overrides[0].key
            example = f'expected {article(key.dimension)} such as "{DIMENSIONS[key.dimension][1]}"'
            tables.problem(shared, f"{example}, found nothing", f"add the key {key.name}; {FORMAT_HELP}")
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
    return mechanism.model.Parameters(**{field: _filled(numbers) for field, numbers in fields.items()})


def _numbers(key: Key, value: schema.Value) -> dict[tuple[int, ...], float]:
    """Return the numbers of one value by index."""
    if key.kind == "one_of":
        return {(i,): float(choice == value) for i, choice in enumerate(key.choices)}
    if isinstance(value, tuple):
        return {(i,): _number(element) for i, element in enumerate(value)}
    return {(): _number(value)}


def _number(value: Quantity | float) -> float:
    return value.value if isinstance(value, Quantity) else float(value)


def _filled(numbers: Mapping[tuple[int, ...], float]) -> float | np.ndarray:
    if () in numbers:
        return numbers[()]
    array = np.full(np.max(list(numbers), axis=0) + 1, np.nan)
    for index, number in numbers.items():
        array[index] = number
    array.flags.writeable = False
    return array


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


def _by_effect(quantities: Mapping[str, Quantity]) -> dict[str, float]:
    return {path.removeprefix(f"{EFFECTS}."): quantity.value for path, quantity in quantities.items()}


def _check_effects(mechanism: Mechanism, tables: Tables) -> None:
    """Check the conditions of the declared effects on their parameters."""
    declared = {path.split(".")[1] for path in tables.effects}
    for name in [name for name in declared if mechanism.effects[name].requirements]:
        effect_quantities = {path: q for path, q in tables.effects.items() if path.split(".")[1] == name}
        effect_values = {
            path.removeprefix(f"{EFFECTS}.").replace(".", "_"): q.value
            for path, q in effect_quantities.items()
        }
        for requirement in mechanism.effects[name].requirements:
            margin = getattr(mechanism.extended, requirement.function)(
                mechanism.extended.Effects(**effect_values)
            )
            _check(requirement, margin, effect_quantities, tables)


def _check(
    requirement: Requirement,
    margins: Any,
    numbers: Mapping[str, Quantity],
    tables: Tables,
) -> None:
    """Add a problem for each place where a requirement is violated."""
    for place, margin in violated(requirement, margins).items():
        tables.problem(place, _sentence(requirement, place, margin, numbers), requirement.remedy)


def violated(requirement: Requirement, margins: Any) -> dict[str, float]:
    """Return the margins of a requirement that violate it, by place."""
    return {
        place: margin
        for place, margin in zip(requirement.places, np.ravel(margins).tolist(), strict=True)
        if not (margin > 0.0 or (margin == 0.0 and requirement.rule == "at_least_zero"))
    }


def _sentence(requirement: Requirement, place: str, margin: float, numbers: Mapping[str, Quantity]) -> str:
    """Format a requirement's sentence; ``{limits.min}`` is the value at that path in the table of the place."""
    values = {
        "missing": Quantity(0.0 - margin, requirement.unit),
        "value": Quantity(margin, requirement.unit),
        **{path.removeprefix(f"{place.rpartition('.')[0]}."): number for path, number in numbers.items()},
    }

    def written(match: re.Match[str]) -> str:
        return with_unit(values[match[1]].value, values[match[1]].unit)

    return re.sub(r"\{([\w.]+)\}", written, requirement.sentence)
