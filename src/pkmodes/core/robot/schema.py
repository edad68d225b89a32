"""Values of a robot file: the accepted values of each kind of key, and the reasons for rejection."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from operator import ge, gt, le, lt
from typing import Any

from pkmodes.core.base.drives import DRIVES
from pkmodes.core.base.errors import shown
from pkmodes.core.robot.layout import XYZ
from pkmodes.core.robot.units import (
    DIMENSIONS,
    MAX_LENGTH,
    MAX_MAGNITUDE,
    MIN_MAGNITUDE,
    Quantity,
    QuantityError,
    article,
    in_range,
    parse,
    with_unit,
)
from pkmodes_description import Key

MIN_DIRECTION, MAX_DIRECTION = 0.5, 2.0
#: A vector within rounding of unit length is kept as it is, so that reading it again does not change it.
ROUNDING = 1e-15
MAX_NAME_LENGTH = 80
SI_REMEDY = "write a value with its unit, or a number in SI units"

#: The value of a key: quantities, or a choice.
Value = Quantity | tuple[Quantity | float, ...] | int


class RefusedError(ValueError):
    """A rejected value; the caller adds its place in the file.

    - element: name of the element in a vector, empty otherwise
    """

    def __init__(self, what: str, remedy: str = SI_REMEDY, element: str = "") -> None:
        super().__init__(what, remedy, element)
        self.what, self.remedy, self.element = what, remedy, element


def read_value(raw: Any, key: Key) -> Value:
    """Read the value of a key.

    Returns a quantity; a vector or pair of quantities; a direction or signs; a choice.
    Raises RefusedError if the key does not accept the value.
    """
    if key.kind == "quantity":
        return read_quantity(raw, key)
    if key.kind == "direction":
        return _parse_direction(raw, key.elements or XYZ)
    if key.kind == "signs":
        return _parse_signs(raw, len(key.elements))
    if key.kind in ("choice", "one_of"):
        return read_choice(raw, key.choices)
    elements = _parse_vector(raw, key.elements, key.dimension, *_bounds_of(key))
    check_limit_order(elements, key)
    return elements


def check_limit_order(elements: Sequence[Quantity], key: Key) -> None:
    """Check that the lower limit of a pair comes first; any other vector passes.

    Raises RefusedError if it does not.
    """
    if key.kind == "pair" and elements[0].value >= elements[1].value:
        low, high = (with_unit(element.value, element.unit) for element in elements)
        problem = f"expected the lower limit first, found {low} before {high}"
        raise RefusedError(problem, f"write {key.name} = [{', '.join(key.elements)}]")


def read_quantity(raw: Any, key: Key) -> Quantity:
    """Read the quantity of a key, or one element of a vector of them.

    Raises RefusedError if the key does not accept it.
    """
    return parse_quantity(raw, key.dimension, *_bounds_of(key))


def _bounds_of(key: Key) -> tuple[float | None, ...]:
    return key.at_least, key.above, key.at_most, key.below


def parse_quantity(
    raw: Any,
    dimension: str,
    at_least: float | None = None,
    above: float | None = None,
    at_most: float | None = None,
    below: float | None = None,
) -> Quantity:
    """Read a bare number, text with a unit, or a table with a standard deviation; bounds are in SI units."""
    sigma_raw = None
    if isinstance(raw, dict):
        unknown = [key for key in raw if key not in ("value", "sigma")]
        if unknown or "value" not in raw:
            keys = ", ".join(map(shown, raw)) or "an empty table"
            raise RefusedError(
                f'expected a table with "value" and, if known, "sigma"; found {keys}',
                "write { value = ..., sigma = ... }",
            )
        raw, sigma_raw = raw["value"], raw.get("sigma")
    value = _parse_number(raw, dimension)
    if dimension == "length" and abs(value) > MAX_LENGTH:
        raise RefusedError(
            f"expected a length of at most {MAX_LENGTH:g} m, found {shown(raw)}",
            "check the number and its unit: a number without a unit is in metres",
        )
    unit = DIMENSIONS[dimension][0]
    for holds, bound, words in (
        (ge, at_least, "of at least"),
        (gt, above, "greater than"),
        (le, at_most, "of at most"),
        (lt, below, "less than"),
    ):
        if bound is not None and not holds(value, bound):
            problem = f"expected {article(dimension)} {words} {with_unit(bound, unit)}, found {shown(raw)}"
            raise RefusedError(problem, "check the sign and the number")
    sigma = None if sigma_raw is None else parse_sigma(sigma_raw, value, dimension)
    return Quantity(value, unit, sigma)


def read_choice(raw: Any, allowed: tuple[int, ...]) -> int:
    """Read one of the allowed numbers."""
    if isinstance(raw, bool) or not isinstance(raw, int) or raw not in allowed:
        choices = " or ".join(map(str, allowed))
        raise RefusedError(f"expected {choices}, found {shown(raw)}", f"write {choices}")
    return raw


def read_drives(raw: Any) -> str:
    """Read what the motors do: "free" or "held"."""
    if raw not in DRIVES:
        raise RefusedError(
            f'expected "free" or "held", found {shown(raw)}',
            'write drives = "held" if position loops far stiffer than the machine hold the motors, else "free"',
        )
    return str(raw)


def is_bare_key(key: str) -> bool:
    """Return whether TOML allows a key without quotes, and it is short."""
    return re.fullmatch(r"[A-Za-z0-9_-]{1,60}", key) is not None


def read_name(raw: Any) -> str:
    """Read a name: plain text on one line, because it goes into comments and docstrings of generated code."""
    plain = isinstance(raw, str) and raw.isprintable() and raw.strip() and len(raw) <= MAX_NAME_LENGTH
    if not plain or any(mark in raw for mark in ('"', "\\", "`", "/*", "*/")):
        raise RefusedError(
            f"expected a name in plain text, found {shown(raw)}",
            f"use at most {MAX_NAME_LENGTH} printable characters, without quotes, backslashes or comment marks",
        )
    return str(raw)


def _parse_number(raw: Any, dimension: str) -> float:
    """Read a bare number in SI units, or text with a unit."""
    expected = f'expected {article(dimension)} such as "{DIMENSIONS[dimension][1]}"'
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        raise RefusedError(f"{expected}, found {shown(raw)}")
    try:
        value = parse(raw, dimension) if isinstance(raw, str) else float(raw)
    except QuantityError as error:
        raise RefusedError(str(error), error.remedy or SI_REMEDY) from error
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise RefusedError(f"expected a finite {dimension}, found {shown(raw)}")
    if not in_range(value):
        raise RefusedError(
            f"expected {article(dimension)} with a magnitude between {MIN_MAGNITUDE:g} and {MAX_MAGNITUDE:g} "
            f"in SI units, found {shown(raw)}",
            "check the number and its unit",
        )
    return value


def parse_sigma(raw: Any, value: float, dimension: str) -> float:
    """Read one standard deviation, absolute or relative to the value."""
    remedy = 'write an absolute standard deviation with its unit, or a relative one such as "2 %"'
    if isinstance(raw, str) and raw.strip().endswith("%"):
        try:
            relative = parse(raw, "number")
        except QuantityError as error:
            problem = f'sigma: expected a percentage such as "2 %", found {shown(raw)}'
            raise RefusedError(problem, error.remedy or remedy) from error
        if value == 0.0:
            raise RefusedError(f"sigma: {shown(raw)} of a value of 0 is undefined", remedy)
        sigma = relative * abs(value)
    else:
        try:
            sigma = _parse_number(raw, dimension)
        except RefusedError as error:
            remedy_given = error.remedy if error.remedy != SI_REMEDY else remedy
            raise RefusedError(f"sigma: {error.what}", remedy_given) from error
    if sigma < 0:
        raise RefusedError(f"sigma: expected a standard deviation of at least 0, found {shown(raw)}", remedy)
    return sigma


def _parse_vector(
    raw: Any, names: tuple[str, ...], dimension: str, *bounds: float | None
) -> tuple[Quantity, ...]:
    """Read the named elements of a vector, each of which may have a standard deviation."""
    if not isinstance(raw, list) or len(raw) != len(names):
        actual = f"{len(raw)} elements" if isinstance(raw, list) else shown(raw)
        raise RefusedError(
            f"expected a list of {len(names)} {dimension} values, found {actual}",
            f"give {len(names)} elements",
        )
    elements = []
    for name, element in zip(names, raw, strict=True):
        try:
            elements.append(parse_quantity(element, dimension, *bounds))
        except RefusedError as error:
            raise RefusedError(error.what, error.remedy, name) from error
    return tuple(elements)


def _parse_direction(raw: Any, names: tuple[str, ...]) -> tuple[float, ...]:
    remedy = "write the components of a unit vector as numbers, such as [1, 0, 0]"
    if isinstance(raw, list) and any(isinstance(element, dict) for element in raw):
        raise RefusedError("expected numbers, found a table: a direction has no standard deviation", remedy)
    elements = [element.value for element in _parse_vector(raw, names, "number")]
    norm = math.hypot(*elements)
    if norm == 0.0:
        raise RefusedError("expected a unit vector, found a zero direction", remedy)
    if not MIN_DIRECTION < norm < MAX_DIRECTION:
        # Rounded components are normalised; a vector of another length is probably a position or a length.
        raise RefusedError(f"expected a unit vector, found one of length {norm:g}", remedy)
    return tuple(elements) if abs(norm - 1.0) <= ROUNDING else tuple(element / norm for element in elements)


def _parse_signs(raw: Any, length: int) -> tuple[float, ...]:
    remedy = f"for example: [{', '.join(['1', '-1', *['1'] * length][:length])}]"
    if not isinstance(raw, list) or len(raw) != length:
        actual = f"{len(raw)}" if isinstance(raw, list) else shown(raw)
        raise RefusedError(f"expected a list of {length} numbers, each 1 or -1, found {actual}", remedy)
    for element in raw:
        if isinstance(element, bool) or element not in (1, -1):
            raise RefusedError(f"expected numbers that are each 1 or -1, found {shown(element)}", remedy)
    return tuple(float(element) for element in raw)
