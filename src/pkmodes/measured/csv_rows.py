"""Convert the text of a measurement file to rows of cells, and the cells to numbers in SI units."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any, NamedTuple

import numpy as np

from pkmodes.base.errors import MeasurementError, shown
from pkmodes.measured.header import SPREAD, TEXT, Column, frequency_factor
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.quantities import required_columns, row_numbers
from pkmodes.measured.rules import (
    SET,
    SHAPE,
    BrokenRuleError,
    Problem,
    Quoted,
    checked_band,
    message,
    refuse,
)
from pkmodes.robot.units import QuantityError

#: A line that tells spreadsheet programs the separator of the cells.
SEPARATOR = re.compile(r"\"?sep\s*=\s*(.)\"?[,;\t]*", re.IGNORECASE)

# Stricter than float(): no "nan", no "1_000", no digits of other scripts.
NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
#: A comment that gives the band.  Also matches without the colon, a mistake that would otherwise go unnoticed.
BAND = re.compile(r"#\s*band\s*(:|=|(?=\s[0-9.]))(.*)", re.IGNORECASE)
BAND_HELP = 'write "# band: 10 Hz, 400 Hz", or start the comment with another word'


class Lines(NamedTuple):
    """Lines of cells with their line numbers, and the band if a comment gives one."""

    records: list[tuple[int, str]]
    band: tuple[float, float] | None


def read_lines(text: str, source: str) -> Lines:
    """Split a file into its records and the band from its comments.

    Raises
    ------
    MeasurementError
        If a band is invalid or differs from a previous one.
    """
    records: list[tuple[int, str]] = []
    band: tuple[float, float] | None = None
    stated = 0
    for number, line in enumerate(io.StringIO(text, newline=None), start=1):
        line, where = line.strip(), f"{source}: line {number}"
        if (match := BAND.fullmatch(line.rstrip(",; \t"))) is not None:
            if match[1] != ":":
                raise MeasurementError(
                    f'expected a colon after "band", found {shown(line)}', where, BAND_HELP
                )
            limits = parse_band(match[2], where)
            if band not in (None, limits):
                what = f"this band differs from that in line {stated}"
                raise MeasurementError(what, where, "remove one of them")
            band, stated = limits, number
        elif not records and SEPARATOR.fullmatch(line) is not None:
            what = f"expected the names of the columns, found {shown(line)}, a line for spreadsheet programs"
            raise MeasurementError(what, where, "remove this line")
        elif line.strip(", \t") and not line.startswith(
            "#"
        ):  # spreadsheet programs fill blank lines with commas
            records.append((number, line))
    return Lines(records, band)


def cells_of(line: str, where: str) -> list[str]:
    """Split one line into cells; cells that span lines are not supported, since they are usually unclosed quotes.

    Raises
    ------
    MeasurementError
        If it is not CSV.
    """
    try:
        (cells,) = csv.reader([line], strict=True, skipinitialspace=True)
    except csv.Error as error:
        remedy = "close every quote on its line, and put a comma right after it"
        raise MeasurementError(f"not valid CSV: {error}", where, remedy) from None
    return [cell.strip() for cell in cells]


def parse_band(text: str, where: str, remedy: str = BAND_HELP) -> tuple[float, float]:
    """Read a band such as ``10 Hz, 400 Hz``; numbers without a unit are in Hz.

    Parameters
    ----------
    where, remedy : str
        Place and remedy, for messages.

    Returns
    -------
    low, high : float
        [Hz].

    Raises
    ------
    MeasurementError
        If the text is not two frequencies above 0, the lower one first.
    """
    limits: list[float] = []
    parts = text.split(",")
    for part in parts if len(parts) == 2 else ():
        number, *unit = part.split(maxsplit=1) or [""]
        glued = NUMBER.match(number)  # also "10Hz"
        if glued is not None and glued.end() < len(number):
            number, unit = glued[0], [" ".join([number[glued.end() :], *unit])]
        try:
            factor = frequency_factor(unit[0]) if unit else None
        except QuantityError as error:
            raise MeasurementError(f"expected a band in Hz: {error}", where, remedy) from None
        value = number_in(number, factor)
        if value is not None:
            limits.append(value)
    if len(limits) != 2:
        what = f"expected a lower and a higher frequency, found {shown(text.strip())}"
        raise MeasurementError(what, where, remedy)
    return checked_band(limits, where)


def read_table(
    columns: Sequence[Column], lines: Lines, source: str, components: Mapping[str, str]
) -> Measurements:
    """Convert the cells below the header; each invalid cell counts as a problem.

    Parameters
    ----------
    source : str
        The file.
    components : mapping of str to str
        Pose components and their units.

    Raises
    ------
    MeasurementError
        With the first problem.
    """
    records = lines.records[1:]
    if not records:
        what = "expected a row for each identified mode, found only a header"
        raise MeasurementError(what, source, "add the rows")
    blank = {f"{SPREAD}{name}": 0.0 for name in components}  # the pose is exact
    filled = {"pose", *required_columns(), *components}
    numbers_of_lines = np.array([line for line, _ in records])
    texts: dict[str, list[str]] = {name: [] for name in TEXT}
    numbers: dict[str, list[float]] = {column.name: [] for column in columns if column.name not in TEXT}
    problems: list[Problem] = []
    for row, (number, line) in enumerate(records):
        cells = cells_of(line, f"{source}: line {number}")
        if len(cells) != len(columns):
            short = len(cells) < len(columns)
            place = columns[len(cells)].text if short else str(len(columns) + 1)
            what = f"expected {len(columns)} cells, found {len(cells)}"
            remedy = "leave the cells of optional columns blank, but keep their commas"
            if not short:
                remedy = "remove the extra cells; if numbers have decimal commas, write points"
            problems.append(Problem(row, place, what, remedy))
            continue
        for column, cell in zip(columns, cells, strict=True):
            if column.name in TEXT:
                texts[column.name].append(cell)
            elif not cell and column.name not in filled:
                numbers[column.name].append(blank.get(column.name, math.nan))
            elif (value := number_in(cell, column.factor)) is not None:
                numbers[column.name].append(value)
            else:
                what = f"expected a finite number, found {shown(cell) if cell else 'nothing'}"
                unit = column.unit or column.si
                remedy = f"write a plain number{f' in {unit}' if unit else ''}, with a decimal point"
                problems.append(Problem(row, column.text, what, remedy))
    refuse(problems, source, numbers_of_lines)
    units = {column.name: column.unit for column in columns}
    try:
        return _measurements(texts, numbers, lines, source, units["frequency"], components)
    except BrokenRuleError as error:
        what = message(error.problem, lambda quoted: _as_written(quoted, columns, records))
        raise MeasurementError(what, error.where, error.remedy) from None


def _as_written(quoted: Quoted, columns: Sequence[Column], records: Sequence[tuple[int, str]]) -> str:
    """Format a number as in its cell, with the header's unit; also in SI units if that is another unit."""
    number = format(quoted.value, quoted.digits)
    place = [column.name for column in columns].index(quoted.column)
    column = columns[place]
    if column.factor is None:
        return number
    cell = cells_of(records[quoted.row][1], "")[place]
    if column.si == column.unit:
        return f"{cell} {column.unit}"
    return f"{cell} {column.unit} ({f'{number} {column.si}'.strip()})"


def _measurements(
    texts: dict[str, list[str]],
    numbers: dict[str, list[float]],
    lines: Lines,
    source: str,
    unit: str,
    components: Mapping[str, str],
) -> Measurements:
    """Build measurements from a file's columns by name; `unit` is the header's unit of the frequencies."""
    rows = len(lines.records) - 1
    blank = [0.0] * rows
    columns: dict[str, Any] = {number.argument: numbers.get(number.column) for number in row_numbers()}
    return Measurements.from_rows(
        texts["pose"],
        **columns,
        points=np.array([numbers.get(name, blank) for name in components]).T,
        point_sigma=np.array([numbers.get(f"{SPREAD}{name}", blank) for name in components]).T,
        components=components,
        mode=texts["mode"] or None,
        shapes={
            name.removeprefix(SHAPE): column for name, column in numbers.items() if name.startswith(SHAPE)
        },
        band=lines.band,
        source=source,
        lines=np.array([line for line, _ in lines.records[1:]]),
        unit=unit,
        settings={name.removeprefix(SET): column for name, column in numbers.items() if name.startswith(SET)},
    )


def number_in(text: str, factor: Decimal | None) -> float | None:
    """Return the number in a cell in SI units, None if the cell is not a number."""
    value = float(text) if NUMBER.fullmatch(text) else math.nan
    if factor is not None and value and math.isfinite(value):
        value = float(Decimal(text) * factor)  # in decimal, so that 35 mm is the double nearest to 0.035
    return value if math.isfinite(value) else None
