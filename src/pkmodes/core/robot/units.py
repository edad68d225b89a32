"""Quantities with units, converted once on reading; everything else uses SI units.

Conversion uses decimal arithmetic, so ``"35 mm"`` is the double nearest to 0.035.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from pkmodes.core.base.errors import shown
from pkmodes_description import UNITS

if TYPE_CHECKING:
    from pint import Unit, UnitRegistry

NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL)
# A unit consists of names, products, quotients and small powers: nothing that pint could evaluate as a computation.
UNIT = re.compile(r"(?:[A-Za-zµμ°Ω%]+(?:(?:\^|\*\*)-?\d|[²³])?|1(?=\s*/)|[\s*/·()])+")
LONGEST = 60
#: Magnitudes outside these limits are mistakes, and their products would overflow.
SMALLEST, LARGEST = 1e-30, 1e30
#: No robot is larger [m]: a longer length is one in another unit, and rigid-body modes would lose their digits.
LARGEST_LENGTH = 1000.0

#: An example of each dimension for error messages.
EXAMPLES = {
    "length": "400 mm",
    "mass": "1.5 kg",
    "moment of inertia": "130e-6 kg*m^2",
    "acceleration": "-9.81 m/s^2",
    "specific stiffness": "2.42e6 N/m",
    "stiffness": "1e6 N/m",
    "torsional stiffness": "500 N*m/rad",
    "compliance": "1e-7 m/N",
    "torsional compliance": "1e-4 rad/(N*m)",
    "linear density": "0.06 kg/m",
    "angle": "30 deg",
    "force": "50 N",
    "reciprocal force": "1e-3 1/N",
    "viscous friction": "20 N*s/m",
    "torsional viscous friction": "1e-3 N*m*s/rad",
    "number": "10",
}
#: Dimensions by name, with the SI unit and an example; the last one is of commands, not of robots.
DIMENSIONS = {name: (unit, EXAMPLES[name]) for name, unit in UNITS.items()} | {"time": ("s", "60 ms")}


#: Units of lengths and angles of a pose as people read them, with the factor from SI.
SHOWN = {"m": ("mm", 1e3), "rad": ("deg", 180.0 / math.pi)}


@dataclass(frozen=True)
class Quantity:
    """A declared value.

    Attributes
    ----------
    value : float
        In SI units.
    unit : str
        The SI unit, ``"1"`` if dimensionless.
    sigma : float or None
        One standard deviation in SI units: None if the file gives none, 0 if the value is known exactly.
    """

    value: float
    unit: str
    sigma: float | None = None


class QuantityError(ValueError):
    """Text that is not the expected quantity; the message says what was expected and found."""


@cache
def _registry() -> UnitRegistry[Decimal]:
    # Imported here because it takes longer than the rest of a model evaluation.
    import pint

    return pint.UnitRegistry(non_int_type=Decimal)


# A robot is often read again with one value changed.
@lru_cache(maxsize=4096)
def parse(text: str, dimension: str) -> float:
    """Convert a number with its unit to SI.

    Parameters
    ----------
    text : str
        For example ``"400 mm"``; a number without a unit is accepted only for the dimension "number".
    dimension : str
        A key of `DIMENSIONS`.

    Raises
    ------
    QuantityError
        If the number or unit is missing, or the unit is unknown or of another dimension.
    """
    si_unit, example = DIMENSIONS[dimension]
    expected = f'expected {article(dimension)} such as "{example}"'
    if len(text) > LONGEST:
        raise QuantityError(f"{expected}, found {shown(text)}, which is longer than {LONGEST} characters")
    match = NUMBER.fullmatch(text)
    if match is None:
        raise QuantityError(f"{expected}, found {shown(text)}, which does not begin with a number")
    number, unit = Decimal(match[1]), match[2]
    if not unit:
        if dimension != "number":
            raise QuantityError(f"{expected}, found {shown(text)}, which has no unit")
        return _in_range(float(number), expected, text)
    if unit == "%" and dimension == "number":
        return _in_range(float(number / 100), expected, text)
    if UNIT.fullmatch(unit) is None:
        raise QuantityError(f"{expected}, found {shown(text)}, whose unit {shown(unit)} is not a unit")
    return _in_range(_convert(number, unit, si_unit, expected, text), expected, text)


def parse_number_or_quantity(text: str, unit: str) -> float:
    """Read a bare number in SI units, or a number with its unit; also infinity and NaN.

    Parameters
    ----------
    unit : str
        The SI unit.

    Raises
    ------
    QuantityError
        If it is neither.
    """
    try:
        if "_" in text:  # Python's float() would read 1_0 as 10
            raise ValueError
        return float(text)
    except ValueError:
        return parse(text, dimension_of(unit))


def dimension_of(unit: str) -> str:
    """Return the first dimension with a known SI unit."""
    return next(name for name, (si_unit, _) in DIMENSIONS.items() if si_unit == unit)


def _convert(number: Decimal, unit: str, si_unit: str, expected: str, text: str) -> float:
    import pint

    registry = _registry()
    try:
        given = registry.Unit(unit)
    except Exception as error:  # pint and its tokenizer raise many kinds of errors on malformed units
        raise QuantityError(
            f"{expected}, found {shown(text)}, whose unit {shown(unit)} is unknown"
        ) from error
    target = registry.Unit("dimensionless" if si_unit == "1" else si_unit)
    # Degrees and percent have no dimension, so a dimensional check alone would accept them as scale factors.
    scaling = [name for name in given._units if registry.Unit(name).dimensionless and name != "radian"]
    angles = all(_radians(registry.Unit(name)) == 1 for name in scaling)
    if angles and _radians(given) == _radians(target):
        scaling = []
    if scaling or (si_unit == "1" and str(given) != "dimensionless"):
        raise QuantityError(
            f"{expected}, found {shown(text)}, whose unit {shown(unit)} does not belong there"
        )
    try:
        return float(registry.Quantity(number, given).to(target).magnitude)
    except pint.DimensionalityError as error:
        kind = _dimension_name(given)
        raise QuantityError(f"{expected}, found {shown(text)}, which is {article(kind)}") from error
    except (TypeError, ArithmeticError) as error:  # logarithmic units, offsets
        raise QuantityError(f"{expected}, found {shown(text)}, whose unit is not proportional") from error


def base_units(unit: str) -> tuple[Decimal, Mapping[str, object]]:
    """Return a unit in base units: its factor and their powers, such as (0.001, {"meter": 1}) for ``"mm"``.

    An angle counts as a base unit, which distinguishes rad/s from Hz; ``"1"`` has no base units.

    Raises
    ------
    QuantityError
        If it is not a unit, unknown, or not proportional to a base unit.
    """
    if unit == "1":
        return Decimal(1), {}
    if len(unit) > LONGEST or UNIT.fullmatch(unit) is None:
        raise QuantityError(f"{shown(unit)} is not a unit")
    registry = _registry()
    try:
        once, twice = (
            registry.Quantity(Decimal(number), registry.Unit(unit)).to_root_units() for number in (1, 2)
        )
    except Exception as error:  # pint and its tokenizer raise many kinds of errors on malformed units
        raise QuantityError(f"the unit {shown(unit)} is unknown") from error
    if twice.magnitude != 2 * once.magnitude:  # an offset unit such as degC
        raise QuantityError(f"the unit {shown(unit)} is not proportional")
    return once.magnitude, dict(once._units)


def _radians(unit: Unit) -> object:
    """Return the power of the angle in a unit, which is not part of its dimension."""
    return _registry().get_root_units(unit)[1]._units.get("radian", 0)


def _dimension_name(unit: Unit) -> str:
    registry = _registry()
    if unit.dimensionless:
        return "angle" if _radians(unit) == 1 else "number"
    for name in ("length", "mass", "moment of inertia", "acceleration", "stiffness", "force"):
        if registry.Unit(DIMENSIONS[name][0]).dimensionality == unit.dimensionality:
            return name
    return f"quantity of dimension {unit.dimensionality}"


def article(noun: str) -> str:
    """Return a noun with its indefinite article."""
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def with_unit(value: float, unit: str) -> str:
    """Return a number in an SI unit as text, such as ``0.4 m``; the unit ``"1"`` is not written."""
    return f"{value:g}" + ("" if unit == "1" else f" {unit}")


def in_range(value: float) -> bool:
    """Return whether a value is zero or within the limits of magnitude; False for NaN."""
    return value == 0.0 or SMALLEST <= abs(value) <= LARGEST


def _in_range(value: float, expected: str, text: str) -> float:
    if not in_range(value):
        limits = f"{SMALLEST:g} and {LARGEST:g} in SI units"
        raise QuantityError(f"{expected}, found {shown(text)}, whose magnitude is not between {limits}")
    return value
