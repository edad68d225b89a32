"""The motion that a sensor measures: a linear or angular displacement, velocity or acceleration, in a unit."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.units import QuantityError, base_units, check_plain_number, likely_unit
from pkmodes.modaltest.signals.units import unit_text

#: Standard gravity in pint's notation.  A bare "g" is standard gravity, as in data sheets: no sensor measures grams.
GRAVITY = re.compile(r"(?<![A-Za-z])(m?)g0?(?![A-Za-z0-9])")
EXAMPLE = 'give an acceleration, velocity or displacement, such as "m/s^2", "g0", "mm/s", "um" or "rad/s^2"'
NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3})?)\s*(.+?)\s*", re.DOTALL)


@dataclass(frozen=True)
class Motion:
    """The quantity that a sensor's numbers represent.

    - factor: to SI units
    - derivative: 0 for a displacement, 1 for a velocity, 2 for an acceleration
    - unit: as stated
    - from_volts: whether the numbers are volts, and `unit` is a sensitivity
    """

    factor: float
    derivative: int
    angular: bool
    unit: str
    from_volts: bool = False


def parse_motion(unit: str, where: str) -> Motion:
    """Return the motion that a unit measures.

    Raises MeasurementError if it is not a unit of displacement, velocity or acceleration.
    """
    try:
        factor, powers = base_factor(unit, where)
        return _motion_from_powers(factor, powers, unit, where)
    except MeasurementError as error:
        if (suggested_unit := likely_unit(unit, "m/s^2")) is None:
            raise
        raise MeasurementError(error.what, where, f'write "{suggested_unit}"') from None


def motion_or_none(unit: str) -> Motion | None:
    """Return the motion that a unit measures, None if it measures none."""
    try:
        return parse_motion(unit, "")
    except MeasurementError:
        return None


def motion_of_voltage(sensitivity: str, where: str) -> Motion:
    """Return the motion that one volt represents for a sensitivity such as ``"100 mV/g"``.

    Raises MeasurementError if it is not a voltage per displacement, velocity or acceleration.
    """
    try:
        check_plain_number(sensitivity, "a sensitivity")
    except QuantityError as error:
        raise MeasurementError(str(error), where, error.remedy) from None
    match = NUMBER.fullmatch(sensitivity)
    value = float(match[1]) if match else 0.0
    if match is None or value == 0.0:
        problem = f'expected a sensitivity such as "100 mV/g0", found {shown(sensitivity)}'
        raise MeasurementError(problem, where, "give the volts per unit of the motion")
    factor, powers = base_factor(match[2], where)
    volt, of_volt = base_units("V")
    remaining = {name: float(str(power)) for name, power in of_volt.items()}
    for name, power in powers.items():
        remaining[name] = remaining.get(name, 0.0) - power
    measured = _motion_from_powers(
        float(volt) / (value * factor), {n: p for n, p in remaining.items() if p}, sensitivity, where
    )
    return replace(measured, from_volts=True)


def base_factor(unit: str, where: str) -> tuple[float, dict[str, float]]:
    """Return a unit's factor to base units (gram for mass), and their powers; ``g`` is standard gravity.

    Raises MeasurementError if it is unknown.
    """
    try:
        factor, powers = base_units(GRAVITY.sub(r"\1gravity", unit_text(unit) or unit))
    except QuantityError as error:
        problem = str(error).replace(GRAVITY.sub(r"\1gravity", unit), unit)
        remedy = 'give unit = "V", and this as sensitivity' if "V/" in unit else EXAMPLE
        raise MeasurementError(problem, where, remedy) from None
    return float(factor), {name: float(str(power)) for name, power in powers.items()}


def _motion_from_powers(factor: float, powers: dict[str, float], text: str, where: str) -> Motion:
    kind = next((name for name in ("meter", "radian") if powers.get(name) == 1.0), None)
    derivative = -powers.get("second", 0.0)
    if kind is None or derivative not in (0.0, 1.0, 2.0) or not powers.keys() <= {kind, "second"}:
        problem = f"expected the unit of a motion, found {shown(text)}"
        remedy = 'give unit = "V", and this as sensitivity' if "V/" in text else EXAMPLE
        raise MeasurementError(problem, where, remedy)
    return Motion(factor, int(derivative), kind == "radian", text)
