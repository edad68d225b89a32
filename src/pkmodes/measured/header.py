"""The header of a measurement file: the names and units of the columns.

A name may be followed by a unit, ``frequency [rad/s]`` or ``frequency (rad/s)``.  Columns without a unit are in SI
units, frequencies in Hz.
"""

from __future__ import annotations

import difflib
from collections.abc import Collection, Mapping, Sequence
from decimal import Decimal
from typing import NamedTuple, NoReturn

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import factor_of, parted, unit_remedy
from pkmodes.measured.formats import Machine
from pkmodes.measured.quantities import (
    QUANTITIES,
    SHAPE_SIGMA,
    quantity_numbers,
    required_columns,
    row_numbers,
)
from pkmodes.measured.rules import SET, SHAPE
from pkmodes.measured.statements import ALSO
from pkmodes.support.ordering import joined

#: Columns of text.
TEXT = ("pose", "mode", "drives")
#: Prefix of the standard deviations of pose components.
SPREAD = "sigma_"
#: Separates the columns of tables that are no CSV.
BAR = "|"
#: Units of a shape component of unknown kind: a displacement or a rotation.
MOTIONS = ("m", "rad")
#: What to do about measurements of another machine.
OTHER_MACHINE = "give the robot file of that machine, or measurements of this one"


class Column(NamedTuple):
    """A column: name without the unit, text of the header, unit, and factor to SI (None without a unit).

    ``si`` is the unit assumed for a column without one, for messages; empty for ratios.
    """

    name: str
    text: str
    unit: str
    factor: Decimal | None
    si: str


def components_of(
    cells: Sequence[str], known: Sequence[Mapping[str, str]], channels: Collection[str]
) -> Mapping[str, str]:
    """Choose the pose components of a header from several sets: the largest complete set, else the best match."""
    names_of = [*(f"{SHAPE}{name}" for name in channels), *(name for each in known for name in each)]
    names = {parted(cell, names_of)[0] for cell in cells}
    return max(known, key=lambda each: (names >= each.keys(), len(names & each.keys())))


def read_header(
    cells: Sequence[str], where: str, machine: Machine, components: Mapping[str, str]
) -> list[Column]:
    """Read the columns of a header; each must be known and occur only once.

    Parameters
    ----------
    where : str
        File and line.
    machine : Machine
        Whose columns it may have.
    components : mapping of str to str
        Names and SI units of the pose components: one of the machine's sets.

    Raises
    ------
    MeasurementError
    """
    channels, positions, settings = machine.channels, machine.positions, machine.settings
    needed = required_columns()
    required = ("pose", *(components if positions else ()), *needed)
    spreads = {f"{SPREAD}{name}": unit for name, unit in components.items()}
    units = {number.column: number.unit for number in row_numbers()} | dict(components) | spreads
    units |= {f"{SET}{name}": unit for name, unit in settings.items()}
    known = ["pose", *components, *needed, *spreads]
    known += [number.column for number in quantity_numbers() if not number.required]
    known += ["mode", "drives"] if positions else ["mode"]
    known += [SHAPE_SIGMA.column, *(f"{SHAPE}{name}" for name in channels)]
    known += [f"{SET}{name}" for name in settings]
    help_text = f"start with a header such as {','.join(required)}"
    text = ",".join(cells)
    if BAR in text and (len(cells) == 1 or {part.strip() for part in text.split(BAR)} >= {"pose"}):
        what = f"expected columns separated by commas, semicolons or tabs, found {shown(text)}"
        remedy = (
            f"the file uses bars: replace them, by semicolons if numbers have decimal commas; {help_text}"
        )
        _refuse(what, where, remedy)
    parts = [(ALSO.get(name, name), unit) for name, unit in (parted(cell, [*known, *ALSO]) for cell in cells)]
    names = [name for name, _ in parts]
    if not set(names) & set(required):
        _refuse(f"expected the names of the columns, found {shown(','.join(cells))}", where, help_text)
    columns: list[Column] = []
    for i, (cell, (name, unit)) in enumerate(zip(cells, parts, strict=True)):
        place = f"{where}, column {i + 1}"
        if name not in known:
            unknown = [one for one in names if one not in known]
            if whose := owners(unknown, machine.others()):
                _refuse(f"{shown(name)} is a column of another machine: {whose}", place, OTHER_MACHINE)
            _refuse_unknown(name, place, known)
        if name in names[:i]:
            what = f"the column {shown(name)} is repeated, first as column {names.index(name) + 1}"
            _refuse(what, place, "remove one of them")
        factor = None if unit is None else _factor(name, unit, place, channels, units)
        columns.append(Column(name, cell, unit or "", factor, _plain(name, units)))
    for name in required:
        if name not in names:
            _refuse(f'the column "{name}" is missing', where, help_text)
    placed = [name for name in components if name in names]
    for name in names:
        if name in (*components, *spreads) and len(placed) < len(components):
            missing = next(other for other in components if other not in placed)
            what = f'found the column "{name}" without "{missing}"'
            _refuse(what, where, f"give {joined(components)}, or no position column at all")
    return columns


def _plain(name: str, units: Mapping[str, str]) -> str:
    """Return the unit of a column whose header gives none, for messages; empty for ratios."""
    unit = units.get(name, "SI units")
    return "" if unit == "1" else unit


def _refuse(what: str, where: str, remedy: str) -> NoReturn:
    raise MeasurementError(what, where, remedy)


def owners(names: Sequence[str], others: Mapping[str, Collection[str]]) -> str:
    """Return, as a clause, whose columns the unknown ones of a file are; empty if no other machine has all."""
    having = [machine for machine, columns in others.items() if set(names) <= set(columns)]
    *some, last = having or [""]
    machines = f"{', '.join(some)} or {last}" if some else last
    return f"the columns of the file are those of {machines}" if last else ""


def _refuse_unknown(name: str, place: str, known: Sequence[str]) -> NoReturn:
    if not name:
        _refuse("expected the name of a column, found nothing", place, "name the column or remove it")
    what = f"{shown(name)} is not a coordinate" if name.startswith(SHAPE) else f"unknown column {shown(name)}"
    if f"{SHAPE}{name}" in known:
        _refuse(what, place, f"for the component of a mode shape, write {SHAPE}{name}; otherwise remove it")
    # There are very many settable values: suggest them only for names that start with their prefix or lack only it.
    others = [one for one in known if not one.startswith(SET)]
    some = [f"{SET}{name}"] if f"{SET}{name}" in known else others
    otherwise = f"known: {', '.join(others)}"
    if name.startswith(SET) and len(others) < len(known):
        what = f"{shown(name)} is not a value that can be set"
        some = [one for one in known if one.startswith(SET)]
        otherwise = "see docs/sensitivities.md for the paths"
    nearest = difflib.get_close_matches(name, some, n=1, cutoff=0.5)
    remedy = "remove it or correct the name: "
    remedy += f'did you mean "{nearest[0]}"?' if nearest else otherwise
    _refuse(what, place, remedy)


def _factor(
    name: str,
    unit: str,
    place: str,
    channels: Collection[str] | Mapping[str, str],
    units: Mapping[str, str],
) -> Decimal | None:
    """Return the factor that converts the numbers of a column to SI units."""
    if name in TEXT:
        what = f"the column {shown(name)} has the unit {shown(unit)} but is not a quantity"
        _refuse(what, place, f'write only "{name}"')
    if name in units:
        allowed: tuple[str, ...] = (units[name],)
    elif isinstance(channels, Mapping):
        allowed = (channels[name.removeprefix(SHAPE)],)
    else:
        allowed = MOTIONS
    remedy = unit_remedy(units.get(name, "SI units"))
    for quantity in QUANTITIES.values():
        if name == quantity.sigma.column and unit == "%":
            remedy = f"multiply by the {quantity.value.column}, and write the result in its unit"
    return factor_of(name, unit, place, allowed, remedy)
