"""Quantities of a campaign file: text with a unit, in SI units and Hz."""

from __future__ import annotations

from pkmodes.campaign.description import Uncertain
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import frequency_factor
from pkmodes.core.robot.units import NUMBER, QuantityError, dimension_of, parse
from pkmodes.measured.cells import number_in

Given = str | int | float


def frequency(text: str, where: str, example: str = "50 Hz") -> float:
    """Return a frequency above 0 [Hz]; one in rad/s is converted.

    Raises
    ------
    MeasurementError
        If the text is not a frequency above 0 with its unit.
    """
    remedy = f'for example: "{example}"'
    match = NUMBER.fullmatch(text)
    if match is None or not match[2]:
        raise MeasurementError(f"expected a frequency with its unit, found {shown(text)}", where, remedy)
    try:
        value = number_in(match[1], frequency_factor(match[2]))
    except QuantityError as error:
        raise MeasurementError(str(error), where, remedy) from None
    if value is None or value <= 0.0:
        raise MeasurementError(f"expected a frequency above 0, found {shown(text)}", where, remedy)
    return value


def band_of(given: list[str], where: str) -> tuple[float, float]:
    """Return a band [Hz].

    Raises
    ------
    MeasurementError
        If it is not two frequencies, the lower one first.
    """
    remedy = 'for example: band = ["10 Hz", "400 Hz"]'
    if len(given) != 2:
        raise MeasurementError(f"expected two frequencies, found {len(given)}", where, remedy)
    low, high = (frequency(text, where) for text in given)
    if low >= high:
        raise MeasurementError(
            f"expected the lower frequency first, found {low:g} Hz, {high:g} Hz", where, remedy
        )
    return low, high


def share(text: str, where: str) -> float:
    """Return a ratio of at least 0 and below 1, such as ``"0.2 %"``.

    Raises
    ------
    MeasurementError
        If it is not one.
    """
    value = quantity(text, "1", where)
    if not 0.0 <= value < 1.0:
        what = f"expected a share of at least 0 and below 100 %, found {shown(text)}"
        raise MeasurementError(what, where, 'for example: "0.2 %"')
    return value


def quantity(given: Given, unit: str, where: str) -> float:
    """Return a quantity in SI units; a bare number only where the unit is 1.

    Raises
    ------
    MeasurementError
        If it is not a quantity of this unit.
    """
    try:
        return parse(given if isinstance(given, str) else repr(given), dimension_of(unit))
    except QuantityError as error:
        raise MeasurementError(str(error), where, "write the number with its unit, as text") from None


def uncertain(given: Given | Uncertain, unit: str, where: str) -> tuple[float, float]:
    """Return a quantity in SI units and its standard deviation, 0 where none is given.

    Raises
    ------
    MeasurementError
        If one of them is not a quantity of this unit, or the standard deviation is negative.
    """
    if not isinstance(given, Uncertain):
        return quantity(given, unit, where), 0.0
    sigma = 0.0 if given.sigma == 0 else quantity(given.sigma, unit, f"{where}.sigma")
    if sigma < 0.0:
        what = f"expected a standard deviation of at least 0, found {shown(given.sigma)}"
        raise MeasurementError(what, f"{where}.sigma", "give its size")
    return quantity(given.value, unit, f"{where}.value"), sigma
