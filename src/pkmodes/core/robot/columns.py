"""A column of numbers by the text at its head: a name, followed by a unit in brackets or without one."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.units import CYCLE, QuantityError, base_units, meant_as

#: A name, and a unit in square brackets, or in parentheses as many programs write it.
IN_BRACKETS = re.compile(r"(.*?)\s*\[([^\[\]]*)\]")
IN_PARENTHESES = re.compile(r"(.*?)\s*\(([^()]*)\)")
#: Units that a message suggests, by SI unit.
EXAMPLES = {"Hz": '"Hz" or "rad/s"', "1": '"%"', "m": '"mm"', "rad": '"deg"'}


def column_of(cell: str, where: str, units: Mapping[str, str]) -> tuple[str, Decimal | None]:
    """Return the name of a column and the factor of its unit to SI, None without a unit; other columns have none.

    - cell: of the header
    - where: for messages
    - units: SI units of the columns that are read

    Raises MeasurementError if the unit is not one of that kind.
    """
    name, unit = parted(cell, list(units))
    if unit is None or name not in units:
        return name, None
    return name, factor_of(name, unit, where, (units[name],), unit_remedy(units[name]))


def parted(cell: str, names: Sequence[str]) -> tuple[str, str | None]:
    """Split a cell into name and unit; both brackets may also be part of a name.

    Case is ignored where exactly one known name matches that way.  Parentheses hold a unit only after a
    known name.
    """
    whole = _listed_name(cell, names)
    if whole in names:
        return whole, None
    if (match := IN_BRACKETS.fullmatch(cell)) is not None:
        return _listed_name(match[1], names), match[2].strip()
    if (match := IN_PARENTHESES.fullmatch(cell)) is not None and (
        name := _listed_name(match[1], names)
    ) in names:
        return name, match[2].strip()
    return cell, None


def _listed_name(name: str, names: Sequence[str]) -> str:
    """Return the known name that matches, else the name itself."""
    if name in names:
        return name
    alike = {candidate for candidate in names if candidate.casefold() == name.casefold()}
    return alike.pop() if len(alike) == 1 else name


def frequency_factor(unit: str) -> Decimal:
    """Return the factor that converts a frequency in this unit to Hz.

    Raises QuantityError if it is not a unit of frequency.
    """
    factor, powers = base_units(unit)
    if powers == {"second": -1}:
        return factor
    if powers == {"radian": 1, "second": -1}:
        return factor / CYCLE
    raise QuantityError(f"{shown(unit)} is not a unit of frequency")


def unit_remedy(si: str) -> str:
    """Return the remedy for a unit of another kind in a column that is in this unit where it names none."""
    return f"write a unit of that kind, or none for {'a plain ratio' if si == '1' else si}"


def factor_of(name: str, unit: str, place: str, allowed: Sequence[str], remedy: str) -> Decimal:
    """Return the factor that converts the numbers of a column to SI units.

    - allowed: SI units, one of which its unit has to be a multiple of

    Raises MeasurementError if it is none.
    """
    expected = " or ".join(EXAMPLES.get(si, f'"{si}"') for si in allowed)
    try:
        if allowed == ("Hz",):
            return frequency_factor(unit)
        factor, powers = base_units(unit)
        for si, same in map(base_units, allowed):
            if powers == same:
                return factor / si
        problem = f"{shown(unit)} is another kind of unit"
    except QuantityError as error:
        problem = str(error)
    meant = next((spelling for si in allowed if (spelling := meant_as(unit, si)) is not None), None)
    remedy = remedy if meant is None else f"write [{meant}]"
    raise MeasurementError(f"expected a unit such as {expected} for {name}: {problem}", place, remedy)
