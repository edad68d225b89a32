"""Ranges as text: ``0.3:0.8:51`` (both ends included), ``300 mm:800 mm:51``, one value, or several with commas."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.units import NUMBER, QuantityError, parse_number_or_quantity

Array = NDArray[np.float64]
#: Maximum number of values along one axis: more are a mistake.
MAX_COUNT = 1_000_000
#: A comma between two integers of which only the second has a unit: two values, or a decimal comma.
AMBIGUOUS_COMMA = re.compile(r"(?<![^\s,:])(-?\d+),(\d+)\s*(?![eE][+-]?\d)([A-Za-zµ%°][^,:]*)")


def parse_range(text: str, unit: str, where: str) -> Array:
    """Read a range or a value.

    - text: ``start:stop:count`` with both ends included, or one value; bare numbers in SI units, or with units
    - unit: SI unit of the values
    - where: place of the text, for messages

    Returns (count,), in SI units, ascending.
    Raises PkmodesError if it is not a range, the ends coincide or are reversed, or the count is not a positive
    integer.
    """
    parts = text.split(":")
    if len(parts) not in (1, 3):
        problem = f"expected start:stop:count or one value, found {shown(text)}"
        raise PkmodesError(problem, where, f"for example: {f'{text}:7' if len(parts) == 2 else '0.3:0.8:51'}")
    ends = [parse_value(part, unit, where) for part in parts[:2]]
    if len(parts) == 1:
        return np.array(ends)
    (start, stop), number = ends, parts[2].strip()
    if not number.isascii() or not number.isdigit() or not 1 <= int(number) <= MAX_COUNT:
        problem = f"expected a count from 1 to {MAX_COUNT:,}, found {shown(number)}"
        raise PkmodesError(problem, where, "for example: 0.3:0.8:51 has 51 values, both ends included")
    count = int(number)
    if stop < start:
        remedy = _missing_unit_remedy(parts, unit) or f"write {parts[1].strip()}:{parts[0].strip()}:{number}"
        raise PkmodesError(
            f"the range is reversed: it ends below its start, found {shown(text)}", where, remedy
        )
    if (start == stop) != (count == 1):
        expected = "one value" if count > 1 else "several values"
        problem = f"expected {expected} from {start:g} to {stop:g}, found {count}"
        remedy = (
            f"write {parts[0].strip()} alone for one value, or two different ends and a count of at least 2"
        )
        raise PkmodesError(problem, where, remedy)
    return np.linspace(start, stop, count)


def _missing_unit_remedy(parts: Sequence[str], unit: str) -> str:
    """Return the remedy for a range of which only one end has a unit; empty for other ranges."""
    low, high, count = (part.strip() for part in parts)
    ends = [NUMBER.fullmatch(end) for end in (low, high)]
    units = [end[2] for end in ends if end is not None]
    if len(units) < 2 or all(units) or not any(units):
        return ""
    symbol = "".join(units)
    range_with_units = ":".join(f"{end[1]}{symbol}" for end in ends if end is not None)
    return f"a number without a unit is in {unit}: write {range_with_units}:{count}"


def parse_value(text: str, unit: str, where: str) -> float:
    """Read a value: a bare number in SI units, or a number with its unit.

    Raises PkmodesError.
    """
    try:
        value = parse_number_or_quantity(text, unit)
    except QuantityError as error:
        remedy = f"write a number{'' if unit == '1' else f' in {unit}, or a number with its unit'}"
        raise PkmodesError(str(error), where, error.remedy or remedy) from None
    if not np.isfinite(value):
        raise PkmodesError(f"expected a finite number, found {shown(text)}", where, "give a finite number")
    return value


def parse_grid(text: str, mechanism: Mechanism, where: str) -> dict[str, Array]:
    """Read a grid such as ``x=0.3:0.8:51,y=-0.1:0.1:41,z=-0.245``.

    - mechanism: defines the components of a pose and their units
    - where: place of the text, for messages

    Returns values of each component, in the order of the mechanism; a rotation of the platform may be left out.
    Raises PkmodesError if another component is missing, unknown or repeated, or a range is invalid.
    """
    units = {component.name: component.unit for component in mechanism.pose}
    needed = [name for name in units if name not in mechanism.components[len(mechanism.directions) :]]
    example = f"write {where} {','.join(f'{name}=0.1:0.2:11' for name in needed)}"
    axes: dict[str, Array] = {}
    for part in text.split(","):
        name, equals, values = (piece.strip() for piece in part.partition("="))
        if not equals or name not in units:
            problem = f"expected {', '.join(f'{component}=...' for component in units)}, found {shown(part.strip())}"
            raise PkmodesError(problem, where, f"{example}{'' if equals else '; decimals with a point'}")
        if name in axes:
            raise PkmodesError(f"{name} is given twice", where, "give each component once")
        axes[name] = parse_range(values, units[name], f"{where} {name}={values}")
    missing = [name for name in needed if name not in axes]
    if missing:
        raise PkmodesError(
            f"the grid gives no values of {' and '.join(missing)}", where, f"give every component: {example}"
        )
    return {name: axes[name] for name in units if name in axes}


def parse_settings(texts: tuple[str, ...], units: Mapping[str, str], where: str) -> dict[str, Any]:
    """Read settings such as ``platform.mass=1:2:5`` or ``platform.mass=1 kg,1.5 kg``.

    - units: SI units of the values that can be changed, by path
    - where: place of the text, for messages

    Returns values by path, in the order given.
    Raises PkmodesError if a path is repeated, or values are invalid.  An unknown path is left to
    `pkmodes.Robot.with_values`.
    """
    settings: dict[str, Any] = {}
    for text in texts:
        path, equals, values = (piece.strip() for piece in text.partition("="))
        if not equals or not path or not values:
            raise PkmodesError(
                f"expected PATH=VALUES, found {shown(text)}",
                where,
                f"for example: {where} platform.mass=1:2:5",
            )
        if path in settings:
            raise PkmodesError(f"{path} is given twice", where, "give all its values at once")
        location = f"{where} {path}"
        unit = units.get(path, "")
        if not unit:
            settings[path] = np.zeros(1)  # `with_values` of the robot reports what is wrong with the path
            continue
        if (comma := AMBIGUOUS_COMMA.search(values)) is not None:
            problem = (
                f"expected values separated by commas, found {shown(comma[0])}, of which only one has a unit"
            )
            low, high, symbol = comma.groups()
            remedy = f"write {low} {symbol},{high} {symbol} for two values, {low}.{high} {symbol} for one"
            raise PkmodesError(problem, location, remedy)
        ranges = [parse_range(part, unit, location) for part in values.split(",")]
        settings[path] = np.concatenate(ranges)
    return settings
