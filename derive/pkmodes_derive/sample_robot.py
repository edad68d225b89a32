"""The directions of a mechanism's sample robot, read as those of a robot file: rounded ones are normalised."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot
from typing import cast

from sympy import Expr, sympify

from pkmodes_derive.definition import DefinitionError
from pkmodes_derive.machine import Machine

#: Lengths between which a direction is a rounded unit vector.
MIN_LENGTH, MAX_LENGTH = 0.5, 2.0
#: A direction within rounding of unit length is kept as it is.
ROUNDING = 1e-15
#: Tolerance for the length of a declared unit vector.
UNIT_TOLERANCE = 1e-12


def sampled_directions(machine: Machine) -> dict[str, list[Sequence[float]]]:
    """Return the directions of the sample robot as they are declared, by field."""
    tables = machine.tables.described()
    directions = [key.field for table in tables for key in table.keys if key.kind == "direction"]
    return {field: list(cast("Sequence[Sequence[float]]", machine.sample[field])) for field in directions}


def normalised_sample(machine: Machine) -> dict[str, object]:
    """Return the sample robot with directions of unit length."""
    normalised: dict[str, object] = dict(machine.sample)
    for field, directions in sampled_directions(machine).items():
        lengths = [hypot(*direction) for direction in directions]
        normalised[field] = [
            list(direction) if abs(length - 1.0) <= ROUNDING else [c / length for c in direction]
            for direction, length in zip(directions, lengths, strict=True)
        ]
    return normalised


def check_directions(machine: Machine) -> None:
    """Check that directions of the sample robot are nearly unit vectors, and that declared unit vectors are.

    Of the latter only those that no motion changes.

    Raises
    ------
    DefinitionError
    """
    for field, directions in sampled_directions(machine).items():
        for j, direction in enumerate(directions):
            length = hypot(*direction)
            if not MIN_LENGTH < length < MAX_LENGTH:
                raise DefinitionError(
                    f"{field}[{j}] is a direction: expected a unit vector, found one of length {length:g}",
                    "m.sample",
                    "divide it by its length; only rounded unit vectors are normalised",
                )
    sample = normalised_sample(machine)
    values: dict[Expr, object] = {}
    for parameters in machine.tables.fields:
        values |= dict(zip(parameters.symbols, _numbers(sample[parameters.name]), strict=True))
    for vector in machine.units:
        if values.keys() >= set().union(*(sympify(component).free_symbols for component in vector)):
            length = hypot(*(float(sympify(component).subs(values)) for component in vector))
            if abs(length - 1.0) > UNIT_TOLERANCE:
                raise DefinitionError(
                    f"({', '.join(map(str, vector))}) is no unit vector: its length in m.sample is {length:g}",
                    "m.unit_vector",
                    "leave this out, or declare a direction, whose values are normalised",
                )


def _numbers(value: object) -> Iterator[object]:
    """Yield the numbers of nested lists."""
    if isinstance(value, list | tuple):
        for entry in value:
            yield from _numbers(entry)
    else:
        yield value
