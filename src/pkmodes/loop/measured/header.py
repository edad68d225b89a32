"""The header of a measurement file: the names and units of the columns.

A name may be followed by a unit, ``frequency [rad/s]`` or ``frequency (rad/s)``.  Columns without a unit are in SI
units, frequencies in Hz.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from decimal import Decimal
from typing import NamedTuple, NoReturn

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import factor_to_si, split_heading, unit_remedy
from pkmodes.core.support.ordering import joined
from pkmodes.loop.measured.formats import Machine
from pkmodes.loop.measured.meanings import likely_meaning, split_unit
from pkmodes.loop.measured.quantities import (
    LEVEL,
    QUANTITIES,
    SHAPE_SIGMA,
    number_columns,
    quantity_number_columns,
    required_columns,
)
from pkmodes.loop.measured.rules import SET, SHAPE, checked_level_unit
from pkmodes.loop.measured.statements import WORD_SYNONYMS

#: Columns of text.
TEXT_COLUMNS = ("pose", "mode", "drives", "state")
#: Prefix of the standard deviations of pose components.
SPREAD_PREFIX = "sigma_"
#: Column separator of tables that are not CSV.
BAR_SEPARATOR = "|"
#: Units of a shape component of unknown kind: a displacement or a rotation.
MOTION_UNITS = ("m", "rad")
#: Remedy for measurements of another machine.
OTHER_MACHINE_REMEDY = "give the robot file of that machine, or measurements of this one"


class HeaderColumn(NamedTuple):
    """A column: name without the unit, text of the header, unit, and factor to SI (None without a unit).

    ``si`` is the unit assumed for a column without one, for messages; empty for ratios.
    """

    name: str
    text: str
    unit: str
    factor: Decimal | None
    si: str


def components_of(
    cells: Sequence[str], component_sets: Sequence[Mapping[str, str]], channels: Collection[str]
) -> Mapping[str, str]:
    """Choose the pose components of a header from several sets: the largest complete set, else the best match."""
    names_of = [
        *(f"{SHAPE}{name}" for name in channels),
        *(name for component_set in component_sets for name in component_set),
    ]
    names = {split_heading(cell, names_of)[0] for cell in cells}
    return max(
        component_sets,
        key=lambda component_set: (names >= component_set.keys(), len(names & component_set.keys())),
    )


def read_header(
    cells: Sequence[str], where: str, machine: Machine, components: Mapping[str, str]
) -> list[HeaderColumn]:
    """Read the columns of a header; each must be known and occur only once.

    - where: file and line
    - machine: whose columns it may have
    - components: names and SI units of the pose components: one of the machine's sets

    Raises MeasurementError.
    """
    channels, positions, settings = machine.channels, machine.positions, machine.settings
    required_numbers = required_columns()
    required = ("pose", *(components if positions else ()), *required_numbers)
    spreads = {f"{SPREAD_PREFIX}{name}": unit for name, unit in components.items()}
    units = {spec.column: spec.unit for spec in number_columns()} | dict(components) | spreads
    units |= {f"{SET}{name}": unit for name, unit in settings.items()} | {LEVEL.column: LEVEL.unit}
    known_columns = ["pose", *components, *required_numbers, *spreads]
    known_columns += [spec.column for spec in quantity_number_columns() if not spec.required]
    known_columns += ["mode", "state", LEVEL.column, *(["drives"] if positions else [])]
    known_columns += [SHAPE_SIGMA.column, *(f"{SHAPE}{name}" for name in channels)]
    known_columns += [f"{SET}{name}" for name in settings]
    help_text = f"start with a header such as {','.join(required)}"
    text = ",".join(cells)
    if BAR_SEPARATOR in text and (
        len(cells) == 1 or {part.strip() for part in text.split(BAR_SEPARATOR)} >= {"pose"}
    ):
        problem = f"expected columns separated by commas, semicolons or tabs, found {shown(text)}"
        remedy = (
            f"the file uses bars: replace them, by semicolons if numbers have decimal commas; {help_text}"
        )
        _refuse(problem, where, remedy)
    parts = [
        (WORD_SYNONYMS.get(name, name), unit)
        for name, unit in (split_heading(cell, [*known_columns, *WORD_SYNONYMS]) for cell in cells)
    ]
    names = [name for name, _ in parts]
    if not set(names) & set(required):
        _refuse(f"expected the names of the columns, found {shown(','.join(cells))}", where, help_text)
    columns: list[HeaderColumn] = []
    unknown = [i for i, name in enumerate(names) if name not in known_columns]
    if len(unknown) > 1 and not owners([names[i] for i in unknown], machine.others()):
        _refuse_all_unknown({i: cells[i] for i in unknown}, where, known_columns, names)
    for i, (cell, (name, unit)) in enumerate(zip(cells, parts, strict=True)):
        place = f"{where}, column {i + 1}"
        if name not in known_columns:
            if whose := owners([names[k] for k in unknown], machine.others()):
                _refuse(f"{shown(name)} is a column of another machine: {whose}", place, OTHER_MACHINE_REMEDY)
            _refuse_unknown(name, place, known_columns, names)
        if name in names[:i]:
            problem = f"the column {shown(name)} is repeated, first as column {names.index(name) + 1}"
            _refuse(problem, place, "remove one of them")
        factor = None if unit is None else _factor(name, unit, place, channels, units)
        default_unit = units.get(name, "SI units")  # the unit where the header gives none, for messages
        columns.append(
            HeaderColumn(name, cell, unit or "", factor, "" if default_unit == "1" else default_unit)
        )
    for name in required:
        if name not in names:
            _refuse(f'the column "{name}" is missing', where, help_text)
    present_components = [name for name in components if name in names]
    for name in names:
        if name in (*components, *spreads) and len(present_components) < len(components):
            missing_component = next(
                component for component in components if component not in present_components
            )
            problem = f'found the column "{name}" without "{missing_component}"'
            _refuse(problem, where, f"give {joined(components)}, or no position column at all")
    return columns


def _refuse(problem: str, where: str, remedy: str) -> NoReturn:
    raise MeasurementError(problem, where, remedy)


def owners(names: Sequence[str], by_machine: Mapping[str, Collection[str]]) -> str:
    """Return a clause that names the machines which have all unknown columns of a file; empty if there are none."""
    owning_machines = [machine for machine, columns in by_machine.items() if set(names) <= set(columns)]
    *preceding, last = owning_machines or [""]
    machines = f"{', '.join(preceding)} or {last}" if preceding else last
    return f"the columns of the file are those of {machines}" if last else ""


def _refuse_all_unknown(
    cells: Mapping[int, str], where: str, known_columns: Sequence[str], taken: Collection[str]
) -> NoReturn:
    """Refuse several unknown columns, first those that probably mean a known one."""
    meant: dict[int, str] = {}
    for i, cell in cells.items():
        earlier_names = {split_unit(meaning)[0] for meaning in meant.values()}
        if meaning := likely_meaning(cell, known_columns, {*taken, *earlier_names}):
            meant[i] = meaning
    unexplained = [i for i in cells if i not in meant]
    listing = [shown(cells[i]) if cells[i] else "one without a name" for i in (*meant, *unexplained)]
    column_numbers = joined([str(i + 1) for i in cells])
    likely_meanings = ", ".join(f'{shown(cells[i])} -> "{meaning}"' for i, meaning in meant.items())
    remedy = (
        f"likely meanings: {likely_meanings}; rename these"
        if meant
        else "remove them, or correct their names"
    )
    remedy += ", and remove the others" if meant and unexplained else ""
    _refuse(f"unknown columns {', '.join(listing)}", f"{where}, columns {column_numbers}", remedy)


def _refuse_unknown(name: str, place: str, known_columns: Sequence[str], taken: Collection[str]) -> NoReturn:
    if not name:
        _refuse("expected the name of a column, found nothing", place, "name the column or remove it")
    problem = (
        f"{shown(name)} is not a coordinate" if name.startswith(SHAPE) else f"unknown column {shown(name)}"
    )
    if f"{SHAPE}{name}" in known_columns:
        _refuse(
            problem, place, f"for the component of a mode shape, write {SHAPE}{name}; otherwise remove it"
        )
    # There are very many settable values: they are listed nowhere.
    fixed_columns = [column for column in known_columns if not column.startswith(SET)]
    known_names = f"known: {', '.join(fixed_columns)}"
    if name.startswith(SET) and len(fixed_columns) < len(known_columns):
        problem = f"{shown(name)} is not a value that can be set"
        known_names = "see docs/reference/parameter-paths.md for the paths"
    meaning = likely_meaning(name, known_columns, taken)
    meant, unit = split_unit(meaning)
    in_unit = f' With its unit: "{meaning}"' if unit else ""
    _refuse(
        problem,
        place,
        "remove it or correct the name: " + (f'did you mean "{meant}"?{in_unit}' if meaning else known_names),
    )


def _factor(
    name: str, unit: str, place: str, channels: Collection[str] | Mapping[str, str], units: Mapping[str, str]
) -> Decimal | None:
    """Return the factor that converts the numbers of a column to SI units; None for a level, of any unit."""
    if name in TEXT_COLUMNS:
        problem = f"the column {shown(name)} has the unit {shown(unit)} but is not a quantity"
        _refuse(problem, place, f'write only "{name}"')
    if name == LEVEL.column:
        checked_level_unit(unit, place)
        return None
    if name in units:
        allowed: tuple[str, ...] = (units[name],)
    elif isinstance(channels, Mapping):
        allowed = (channels[name.removeprefix(SHAPE)],)
    else:
        allowed = MOTION_UNITS
    remedy = unit_remedy(units.get(name, "SI units"))
    for quantity in QUANTITIES.values():
        if name == quantity.sigma.column and unit == "%":
            remedy = f"multiply by the {quantity.value.column}, and write the result in its unit"
    return factor_to_si(name, unit, place, allowed, remedy)
