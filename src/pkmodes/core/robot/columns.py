"""Headings of columns of numbers: a name, with or without a unit in brackets."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.units import RADIANS_PER_CYCLE, QuantityError, base_units, likely_unit

#: A name, and a unit in square brackets, or in parentheses as many programs write it.
IN_BRACKETS = re.compile(r"(.*?)\s*\[([^\[\]]*)\]")
IN_PARENTHESES = re.compile(r"(.*?)\s*\(([^()]*)\)")
#: Units that a message suggests, by SI unit.
UNIT_EXAMPLES = {"Hz": '"Hz" or "rad/s"', "1": '"%"', "m": '"mm"', "rad": '"deg"'}


def parse_heading(cell: str, where: str, units: Mapping[str, str]) -> tuple[str, Decimal | None]:
    """Return the name of a column and the factor of its unit to SI; None without a unit, or for an unknown name.

    - cell: of the header
    - where: for messages
    - units: SI units of the columns that are read

    Raises MeasurementError if the unit is not one of that kind.
    """
    name, unit = split_heading(cell, list(units))
    if unit is None or name not in units:
        return name, None
    return name, factor_to_si(name, unit, where, (units[name],), unit_remedy(units[name]))


def split_heading(cell: str, names: Sequence[str]) -> tuple[str, str | None]:
    """Split a cell into name and unit; both brackets may also be part of a name.

    Case is ignored if exactly one known name then matches.  Parentheses hold a unit only after a
    known name.
    """
    name_without_unit = _known_name(cell, names)
    if name_without_unit in names:
        return name_without_unit, None
    if (match := IN_BRACKETS.fullmatch(cell)) is not None:
        return _known_name(match[1], names), match[2].strip()
    if (match := IN_PARENTHESES.fullmatch(cell)) is not None and (
        name := _known_name(match[1], names)
    ) in names:
        return name, match[2].strip()
    return cell, None


def _known_name(name: str, names: Sequence[str]) -> str:
    """Return the known name that matches, else the name itself."""
    if name in names:
        return name
    matches = {candidate for candidate in names if candidate.casefold() == name.casefold()}
    return matches.pop() if len(matches) == 1 else name


def frequency_factor(unit: str) -> Decimal:
    """Return the factor that converts a frequency in this unit to Hz.

    Raises QuantityError if it is not a unit of frequency.
    """
    factor, powers = base_units(unit)
    if powers == {"second": -1}:
        return factor
    if powers == {"radian": 1, "second": -1}:
        return factor / RADIANS_PER_CYCLE
    raise QuantityError(f"{shown(unit)} is not a unit of frequency")


def unit_remedy(si_unit: str) -> str:
    """Return the remedy for a unit of the wrong kind in a column whose numbers are in this unit by default."""
    return f"write a unit of that kind, or none for {'a plain ratio' if si_unit == '1' else si_unit}"


def factor_to_si(name: str, unit: str, where: str, allowed: Sequence[str], remedy: str) -> Decimal:
    """Return the factor that converts the numbers of a column to SI units.

    - allowed: SI units, one of which its unit has to be a multiple of

    Raises MeasurementError if it is none.
    """
    expected = " or ".join(UNIT_EXAMPLES.get(si_unit, f'"{si_unit}"') for si_unit in allowed)
    try:
        if allowed == ("Hz",):
            return frequency_factor(unit)
        factor, powers = base_units(unit)
        for si_factor, si_powers in map(base_units, allowed):
            if powers == si_powers:
                return factor / si_factor
        problem = f"{shown(unit)} is another kind of unit"
    except QuantityError as error:
        problem = str(error)
    intended = next(
        (spelling for si_unit in allowed if (spelling := likely_unit(unit, si_unit)) is not None), None
    )
    remedy = remedy if intended is None else f"write [{intended}]"
    raise MeasurementError(f"expected a unit such as {expected} for {name}: {problem}", where, remedy)
