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
from pkmodes.core.robot.spellings import ambiguous_name, likely_spellings, number_readings
from pkmodes_description import UNITS

if TYPE_CHECKING:
    from pint import Unit, UnitRegistry

NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3})?)\s*(.*?)\s*", re.DOTALL)
# A unit consists of names, products, quotients and small powers: nothing that pint could evaluate as a computation.
UNIT = re.compile(r"(?:[A-Za-zµμ°Ω%]+(?:(?:\^|\*\*)-?\d|[²³])?|1(?=\s*/)|[\s*/·()])+")
MAX_LENGTH_OF_TEXT = 60
#: Magnitudes outside these limits are mistakes, and their products would overflow.
MIN_MAGNITUDE, MAX_MAGNITUDE = 1e-30, 1e30
#: Longest accepted length [m]: a longer one was meant in another unit, and rigid-body modes would lose their digits.
MAX_LENGTH = 1000.0

#: An example of each dimension for error messages.
QUANTITY_EXAMPLES = {
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
    "frequency": "50 Hz",
    "number": "10",
}
#: Dimensions by name, with the SI unit and an example; the last one occurs in commands, not in robot files.
DIMENSIONS = {name: (unit, QUANTITY_EXAMPLES[name]) for name, unit in UNITS.items()} | {
    "time": ("s", "60 ms")
}


#: Radians per cycle, to convert an angular frequency to a frequency.
RADIANS_PER_CYCLE = Decimal("6.28318530717958647692528676656")

#: Dimensions that have a name in messages, with their SI unit.
NAMED_DIMENSIONS = {
    **{
        name: UNITS[name]
        for name in ("length", "mass", "moment of inertia", "acceleration", "stiffness", "force")
    },
    **{"torque": "N*m", "time": "s"},
}

#: Factors to SI of the units in most robot files; pint, which takes longer to load than a model to evaluate, converts
#: the others.
COMMON_FACTORS = {
    si_unit: {unit: Decimal(factor) for unit, factor in units.items()}
    for si_unit, units in {
        "m": {"m": "1", "cm": "1e-2", "mm": "1e-3", "um": "1e-6"},
        "kg": {"kg": "1", "g": "1e-3"},
        "kg m^2": {
            **{"kg*m^2": "1", "kg m^2": "1", "kg*cm^2": "1e-4", "kg*mm^2": "1e-6"},
            **{"g*cm^2": "1e-7", "g*mm^2": "1e-9"},
        },
        "m/s^2": {"m/s^2": "1", "mm/s^2": "1e-3"},
        "N/m": {"N/m": "1", "N/mm": "1e3", "kN/m": "1e3", "kN/mm": "1e6", "N/um": "1e6"},
        "N m/rad": {"N*m/rad": "1", "N m/rad": "1", "kN*m/rad": "1e3"},
        "m/N": {"m/N": "1", "mm/N": "1e-3", "um/N": "1e-6"},
        "rad/(N m)": {"rad/(N*m)": "1", "rad/(N m)": "1"},
        "kg/m": {"kg/m": "1", "g/m": "1e-3"},
        "rad": {"rad": "1", "mrad": "1e-3", "deg": "0.01745329251994329576923690768488612713"},
        "N": {"N": "1", "kN": "1e3"},
        "N s/m": {"N*s/m": "1", "N s/m": "1"},
        "N m s/rad": {"N*m*s/rad": "1", "N m s/rad": "1"},
        "Hz": {"Hz": "1", "kHz": "1e3"},
        "s": {"s": "1", "ms": "1e-3"},
    }.items()
}

#: Units of lengths and angles of a pose as people read them, with the factor from SI.
DISPLAY_UNITS = {"m": ("mm", 1e3), "rad": ("deg", 180.0 / math.pi)}


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
    """Text that is not the expected quantity; the message says what was expected and found.

    - remedy: how to write what was probably meant; empty if unknown
    """

    def __init__(self, what: str, remedy: str = "") -> None:
        super().__init__(what)
        self.remedy = remedy


@cache
def _registry() -> UnitRegistry[Decimal]:
    # Imported here because it takes longer than the rest of a model evaluation.
    import pint

    return pint.UnitRegistry(non_int_type=Decimal)


# A robot is often read again with one value changed.
@lru_cache(maxsize=4096)
def parse(text: str, dimension: str, unit_optional: bool = False) -> float:
    """Convert a number with its unit to SI.

    - text: for example ``"400 mm"``
    - dimension: a key of `DIMENSIONS`
    - unit_optional: whether a number without a unit is accepted, in SI units; for the dimension "number" it always is

    Raises QuantityError if the number or unit is missing, or the unit is unknown or of another dimension.
    """
    si_unit, example = DIMENSIONS[dimension]
    expected = f'expected {article(dimension)} such as "{example}"'
    if len(text) > MAX_LENGTH_OF_TEXT:
        raise QuantityError(
            f"{expected}, found {shown(text)}, which is longer than {MAX_LENGTH_OF_TEXT} characters"
        )
    readings, peculiarity = number_readings(text)
    if readings:
        remedy = _remedy_for_readings(readings, dimension, unit_optional)
        raise QuantityError(f"{expected}, found {shown(text)}, {peculiarity}", remedy)
    match = NUMBER.fullmatch(text)
    if match is None:
        raise QuantityError(f"{expected}, found {shown(text)}, which does not begin with a number")
    number, unit = Decimal(match[1]), match[2]
    if not unit:
        if dimension != "number" and not unit_optional:
            raise QuantityError(f"{expected}, found {shown(text)}, which has no unit")
        return _in_range(float(number), expected, text)
    if unit == "%" and dimension == "number":
        return _in_range(float(number / 100), expected, text)
    try:
        return _in_range(_convert(number, unit, si_unit), expected, text)
    except _UnitError as error:
        reason, remedy = str(error), ""
        if (likely := likely_unit(unit, si_unit)) is not None:
            reason = f"whose unit {shown(unit)} is not understood" if error.vague else reason
            remedy = f'write "{match[1]} {likely}"'
        elif error.vague and (kind := _unit_of_another_kind(unit)) is not None:
            reason = f"whose unit {shown(unit)} is {kind}"
        elif dimension == "number" and re.fullmatch(r":\s*1", unit):
            remedy = f'write "{match[1]}"'
        raise QuantityError(f"{expected}, found {shown(text)}, {reason}", remedy) from error


def _remedy_for_readings(readings: list[tuple[str, str]], dimension: str, unit_optional: bool) -> str:
    """Return the remedy for a number with other separators than a decimal point."""
    written, remedy = [], ""
    for number, unit in readings:
        plain = f"{number} {unit}".rstrip()
        try:
            parse(plain, dimension, unit_optional)
        except QuantityError as error:
            remedy = error.remedy or f"write the number as {number}, with a unit of {article(dimension)}"
        else:
            written.append(f'"{plain}"')
    return f"write {' or '.join(written)}" if written else remedy


def parse_number_or_quantity(text: str, unit: str) -> float:
    """Read a bare number in SI units, or a number with its unit; also infinity and NaN.

    - unit: the SI unit

    Raises QuantityError if it is neither.
    """
    try:
        if "_" in text:  # Python's float() would read 1_0 as 10
            raise ValueError
        return float(text)
    except ValueError:
        return parse(text, dimension_of(unit), unit_optional=True)


def check_plain_number(text: str, expected: str) -> None:
    """Reject a number, perhaps with a unit, whose digits are separated by anything but one decimal point.

    - expected: what was expected, with its article, for the message

    Raises QuantityError with the number as it is to be written.
    """
    readings, peculiarity = number_readings(text)
    if readings:
        written = " or ".join(f'"{f"{number} {unit}".rstrip()}"' for number, unit in readings)
        raise QuantityError(f"expected {expected}, found {shown(text)}, {peculiarity}", f"write {written}")


def dimension_of(unit: str) -> str:
    """Return the first dimension with a known SI unit."""
    return next(name for name, (si_unit, _) in DIMENSIONS.items() if si_unit == unit)


class _UnitError(ValueError):
    """A unit that is not one of the expected kind; `vague` if the reason does not help the reader."""

    def __init__(self, reason: str, vague: bool = False) -> None:
        super().__init__(reason)
        self.vague = vague


def _convert(number: Decimal, unit: str, si_unit: str) -> float:
    """Convert a number to an SI unit.

    Raises _UnitError with the reason as a relative clause.
    """
    if (factor := COMMON_FACTORS.get(si_unit, {}).get(unit)) is not None:
        return float(number * factor)
    import pint

    if (ambiguity := ambiguous_name(unit)) is not None:
        raise _UnitError(f"whose unit {shown(ambiguity[0])} may be {ambiguity[1]}")
    if UNIT.fullmatch(unit) is None:
        raise _UnitError(f"whose unit {shown(unit)} is not a unit")
    registry = _registry()
    try:
        parsed = registry.Unit(unit)
    except Exception as error:  # pint and its tokenizer raise many kinds of errors on malformed units
        raise _UnitError(f"whose unit {shown(unit)} is unknown") from error
    target = registry.Unit("dimensionless" if si_unit == "1" else si_unit)
    if si_unit == "Hz" and _power_of_angle(parsed) == 1:
        number, target = number / RADIANS_PER_CYCLE, registry.Unit("rad/s")
    # Degrees and percent have no dimension, so a dimensional check alone would accept them as scale factors.
    dimensionless_units = [
        name for name in parsed._units if registry.Unit(name).dimensionless and name != "radian"
    ]
    are_angles = all(_power_of_angle(registry.Unit(name)) == 1 for name in dimensionless_units)
    if are_angles and _power_of_angle(parsed) == _power_of_angle(target):
        dimensionless_units = []
    if dimensionless_units or (si_unit == "1" and str(parsed) != "dimensionless"):
        raise _UnitError(f"whose unit {shown(unit)} does not belong there", vague=True)
    try:
        return float(registry.Quantity(number, parsed).to(target).magnitude)
    except pint.DimensionalityError as error:
        kind = _dimension_name(parsed)
        raise _UnitError(
            f"which is {article(kind)}", vague=kind not in (*NAMED_DIMENSIONS, "angle", "number")
        ) from error
    except (TypeError, ArithmeticError) as error:  # logarithmic units, offsets
        raise _UnitError(f"whose unit {shown(unit)} is not proportional") from error


@lru_cache(maxsize=256)
def likely_unit(unit: str, si_unit: str) -> str | None:
    """Return the spelling of the unit that was probably meant, such as ``N*m`` for ``Nm``; None if unknown.

    - si_unit: the SI unit of the expected dimension
    """
    for spelling in likely_spellings(unit) if len(unit) <= MAX_LENGTH_OF_TEXT else ():
        if spelling == "%" and si_unit == "1":
            return spelling
        if spelling == unit:
            continue
        try:
            _convert(Decimal(1), spelling, si_unit)
        except _UnitError:
            continue
        return spelling
    return None


def base_units(unit: str) -> tuple[Decimal, Mapping[str, object]]:
    """Return a unit in base units: its factor and their powers, such as (0.001, {"meter": 1}) for ``"mm"``.

    An angle counts as a base unit, which distinguishes rad/s from Hz; ``"1"`` has no base units.

    Raises QuantityError if it is not a unit, unknown, one that is often confused, or not proportional to a base unit.
    """
    if unit == "1":
        return Decimal(1), {}
    if (ambiguity := ambiguous_name(unit)) is not None:
        raise QuantityError(
            f"{shown(ambiguity[0])} may be {ambiguity[1]}", f'write "{next(likely_spellings(unit))}"'
        )
    if len(unit) > MAX_LENGTH_OF_TEXT or UNIT.fullmatch(unit) is None:
        raise QuantityError(f"{shown(unit)} is not a unit")
    registry = _registry()
    try:
        one, two = (
            registry.Quantity(Decimal(number), registry.Unit(unit)).to_root_units() for number in (1, 2)
        )
    except Exception as error:  # pint and its tokenizer raise many kinds of errors on malformed units
        raise QuantityError(f"the unit {shown(unit)} is unknown") from error
    if two.magnitude != 2 * one.magnitude:  # an offset unit such as degC
        raise QuantityError(f"the unit {shown(unit)} is not proportional")
    return one.magnitude, dict(one._units)


def _unit_of_another_kind(unit: str) -> str | None:
    """Return what a unit is in another spelling, such as ``N*m, a torque`` for ``Nm``; None if that does not help."""
    for spelling in likely_spellings(unit) if "/" not in unit else ():  # a quotient may be regrouped
        if spelling != unit and UNIT.fullmatch(spelling) is not None:
            try:
                kind = _dimension_name(_registry().Unit(spelling))
            except Exception:  # as in `_convert`
                continue
            if kind in NAMED_DIMENSIONS:
                return f"{spelling}, {article(kind)}"
    return None


def _power_of_angle(unit: Unit) -> object:
    """Return the power of the angle in a unit, which is not part of its dimension."""
    return _registry().get_root_units(unit)[1]._units.get("radian", 0)


def _dimension_name(unit: Unit) -> str:
    registry = _registry()
    if unit.dimensionless:
        return "angle" if _power_of_angle(unit) == 1 else "number"
    for name, si_unit in NAMED_DIMENSIONS.items():
        if registry.Unit(si_unit).dimensionality == unit.dimensionality:
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
    return value == 0.0 or MIN_MAGNITUDE <= abs(value) <= MAX_MAGNITUDE


def _in_range(value: float, expected: str, text: str) -> float:
    if not in_range(value):
        limits = f"{MIN_MAGNITUDE:g} and {MAX_MAGNITUDE:g} in SI units"
        raise QuantityError(f"{expected}, found {shown(text)}, whose magnitude is not between {limits}")
    return value
