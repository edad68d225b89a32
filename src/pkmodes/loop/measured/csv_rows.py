"""Convert the text of a measurement file to rows of cells, and the cells to numbers in SI units."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from pkmodes.core.base.drives import DRIVES, FREE
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.loop.measured.cells import QUOTED, SEPARATORS, TableNotation, separator_of
from pkmodes.loop.measured.columns import Stated
from pkmodes.loop.measured.header import SPREAD_PREFIX, TEXT_COLUMNS, HeaderColumn
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import LEVEL, number_columns, required_columns
from pkmodes.loop.measured.rules import (
    SET,
    SHAPE,
    BrokenRuleError,
    Problem,
    QuotedNumber,
    message,
    refuse,
)
from pkmodes.loop.measured.statements import STATEMENT_PATTERN, STATEMENTS, WORD_SYNONYMS

#: Name of the column with the state of the machine.
STATE = "state"
#: A line that names the separator of the cells for spreadsheet programs.
SEPARATOR = re.compile(r"\"?sep\s*=\s*(.)\"?[,;\t]*", re.IGNORECASE)
#: A comment that contains a comma, as spreadsheet programs write it.
QUOTED_COMMENT = re.compile(r"\"(#[^\"]*)\"[,;\t ]*")


class CsvLines(NamedTuple):
    """Lines of cells with their line numbers, their notation, and what comments state for all of them."""

    records: list[tuple[int, str]]
    notation: TableNotation
    band: tuple[float, float] | None
    drives: str | None
    state: str
    priors: dict[str, Stated]
    usable: dict[str, Stated]

    def header(self, source: str, remedy: str) -> tuple[str, list[str]]:
        """Return the place and the cells of the header.

        Raises MeasurementError if there is none, or it is not CSV.
        """
        if not self.records:
            raise MeasurementError("expected a header and rows, found none", source, remedy)
        number, line = self.records[0]
        where = f"{source}: line {number}"
        return where, self.notation.cells(line, where)

    def rows(self, source: str, count: int) -> Iterator[tuple[str, list[str]]]:
        """Yield the place and the cells of each row.

        - count: cells of the header

        Raises MeasurementError if a row has another number of cells, or is not CSV.
        """
        for number, line in self.records[1:]:
            where = f"{source}: line {number}"
            cells = self.notation.cells(line, where)
            if len(cells) != count:
                problem = f"expected {count} cells, found {len(cells)}"
                raise MeasurementError(problem, where, "give each row as many cells as the header")
            yield where, cells


def read_lines(text: str, source: str) -> CsvLines:
    """Split a file into its records, and the statements of its comments about the whole test.

    Raises MeasurementError if such a comment is invalid or differs from a previous one.
    """
    records: list[tuple[int, str]] = []
    statements: dict[str, dict[str, Stated]] = {name: {} for name in STATEMENTS}
    for number, line in enumerate(io.StringIO(text, newline=None), start=1):
        line, where = line.strip(" \n"), f"{source}: line {number}"  # a tab may end an empty cell
        comment = QUOTED_COMMENT.fullmatch(line)
        text = line.strip() if comment is None else comment[1]
        if (match := STATEMENT_PATTERN.fullmatch(text.rstrip(",; \t"))) is not None:
            word = match[1].lower()
            name = WORD_SYNONYMS.get(word, word)
            statement = STATEMENTS[name]
            if match[2] != ":":
                problem = f'expected a colon after "{word}", found {shown(text)}'
                raise MeasurementError(problem, where, statement.remedy)
            value = statement.read(match[3], where)
            key, value = value if statement.repeatable else ("", value)
            previous = statements[name].setdefault(key, Stated(value, where))
            if value != previous.value:
                problem = f"this {word} differs from that in {previous.where.removeprefix(f'{source}: ')}"
                raise MeasurementError(problem, where, "remove one of them")
        elif not records and SEPARATOR.fullmatch(text) is not None:
            continue  # the header shows what it states
        elif text.strip(",; \t") and not text.startswith("#"):  # spreadsheet programs fill blank lines
            records.append((number, line))
    notation = TableNotation(separator_of(records[0][1])) if records else TableNotation()
    records = _without_trailing_separators(records, notation.separator)
    band, drives, state = (
        next((entry.value for entry in statements[name].values()), None)
        for name in ("band", "drives", "state")
    )
    return CsvLines(records, notation, band, drives, state or "", statements["prior"], statements["usable"])


def states_of(lines: CsvLines, cells: Sequence[str], source: str) -> list[str]:
    """Return the state of each row, from its column or a comment; empty if neither names one.

    - cells: cells of the header

    Raises MeasurementError if a row is not CSV, or names another state than a comment.
    """
    state_column = next((i for i, cell in enumerate(cells) if cell.strip().lower() == STATE), None)
    states = []
    for number, line in lines.records[1:]:
        where = f"{source}: line {number}"
        row = lines.notation.cells(line, where) if state_column is not None else []
        state = row[state_column].strip() if state_column is not None and state_column < len(row) else ""
        if state and lines.state and state != lines.state:
            problem = f"expected {shown(lines.state)}, as stated for all rows, found {shown(state)}"
            raise MeasurementError(problem, f"{where}, column {STATE}", "correct the row, or the statement")
        states.append(state or lines.state)
    return states


def lines_of_state(lines: CsvLines, cells: Sequence[str], source: str, state: str | None) -> CsvLines:
    """Return the lines of one state of the machine, with this state for all of them.

    - cells: cells of the header
    - state: name of the state; by default the only one

    Raises MeasurementError if there are several states and none is chosen, some rows name none, or no row has it.
    """
    states = states_of(lines, cells, source)
    distinct_states = list(dict.fromkeys(states))
    if state is None:
        if len(distinct_states) < 2:
            return lines._replace(state=next(iter(distinct_states), lines.state))
        if "" in distinct_states:
            number = lines.records[1 + states.index("")][0]
            problem = f"expected a state in every row or in none, found nothing beside {shown(max(distinct_states))}"
            raise MeasurementError(problem, f"{source}: line {number}, column {STATE}", "name the state")
        problem = f"expected rows of one state of the machine, found {', '.join(map(shown, distinct_states))}"
        raise MeasurementError(problem, f"{source}: column {STATE}", "compare states with pkmodes changed")
    records_of_state = [
        record for record, row_state in zip(lines.records[1:], states, strict=True) if row_state == state
    ]
    if not records_of_state:
        raise MeasurementError(f"no row is of the state {shown(state)}", source, "check the name")
    return lines._replace(records=[lines.records[0], *records_of_state], state=state)


def _without_trailing_separators(records: list[tuple[int, str]], separator: str) -> list[tuple[int, str]]:
    """Return lines without the separator that some programs write after the last cell of every row."""
    lines = [line.rstrip(" ") for _, line in records]
    if len(lines) < 2 or not all(line.endswith(separator) for line in lines[1:]):
        return records
    header_count, *row_counts = (QUOTED.sub("", line).count(separator) for line in lines)
    if any(count != header_count + (not lines[0].endswith(separator)) for count in row_counts):
        return records  # the last cells of the rows are blank, or some rows have too many
    return [(number, line.removesuffix(separator)) for (number, _), line in zip(records, lines, strict=True)]


def read_table(
    columns: Sequence[HeaderColumn],
    lines: CsvLines,
    source: str,
    components: Mapping[str, str],
    drives: str | None = None,
    usual_drives: str = FREE,
) -> Measurements:
    """Convert the cells below the header; each invalid cell counts as a problem.

    - source: the file
    - components: pose components and their units
    - drives: what the motors did, if the user states it
    - usual_drives: what they did if neither the user nor the file states it

    Raises MeasurementError with the first problem.
    """
    records, notation = lines.records[1:], lines.notation
    if drives is not None and lines.drives not in (None, drives):
        problem = f"the file states that the motors were {lines.drives}, not {drives}"
        raise MeasurementError(problem, source, "leave drives out, or correct the file")
    stated_drives = drives or lines.drives
    if not records:
        problem = "expected a row for each identified mode, found only a header"
        raise MeasurementError(problem, source, "add the rows")
    blank_values = {f"{SPREAD_PREFIX}{name}": 0.0 for name in components}  # the pose is exact
    required_names = {"pose", *required_columns(), *components}
    numbers_of_lines = np.array([line for line, _ in records])
    texts: dict[str, list[str]] = {name: [] for name in TEXT_COLUMNS}
    numbers: dict[str, list[float]] = {
        column.name: [] for column in columns if column.name not in TEXT_COLUMNS
    }
    problems: list[Problem] = []
    for row, (number, line) in enumerate(records):
        cells = notation.cells(line, f"{source}: line {number}")
        if len(cells) != len(columns):
            is_too_short = len(cells) < len(columns)
            column_name = columns[len(cells)].text if is_too_short else str(len(columns) + 1)
            problem = f"expected {len(columns)} cells, found {len(cells)}"
            separators = SEPARATORS[notation.separator]
            remedy = f"leave the cells of optional columns blank, but keep their {separators}"
            if len(cells) == 1:
                remedy = f"separate the cells by {separators}, as in the header"
            if not is_too_short:
                remedy = "remove the extra cells"
            if not is_too_short and notation.separator == ",":
                remedy = (
                    "if numbers have decimal commas, export the table with semicolons between the cells, or "
                )
                remedy += "with decimal points; else remove the extra cells"
            problems.append(Problem(row, column_name, problem, remedy))
            continue
        for column, cell in zip(columns, cells, strict=True):
            if column.name == "drives":
                word = cell.lower() or stated_drives or usual_drives
                if word in DRIVES and stated_drives not in (None, word):
                    problem = f"expected {stated_drives}, as stated for all rows, found {shown(cell)}"
                    problems.append(Problem(row, column.text, problem, "correct the row, or the statement"))
                texts[column.name].append(word)
            elif column.name in TEXT_COLUMNS:
                texts[column.name].append(cell)
            elif not cell and column.name not in required_names:
                numbers[column.name].append(blank_values.get(column.name, math.nan))
            elif (value := notation.number(cell, column.factor)) is not None:
                numbers[column.name].append(value)
            else:
                problem = f"expected a finite number, found {shown(cell) if cell else 'nothing'}"
                unit = column.unit or column.si
                remedy = f"write a plain number{f' in {unit}' if unit else ''}, with {notation.decimal}"
                problems.append(Problem(row, column.text, problem, remedy))
    if not problems:
        problems = list(_rotations_in_degrees(columns, numbers, components))
    refuse(problems, source, numbers_of_lines)
    units = {column.name: column.unit for column in columns}
    try:
        motors: str | list[str] = texts["drives"] or stated_drives or usual_drives
        return _measurements(texts, numbers, lines, source, units, components, motors)
    except BrokenRuleError as error:
        problem = message(error.problem, lambda quoted: _format_as_in_file(quoted, columns, lines))
        raise MeasurementError(problem, error.where, error.remedy) from None


def _rotations_in_degrees(
    columns: Sequence[HeaderColumn], numbers: Mapping[str, Sequence[float]], components: Mapping[str, str]
) -> Iterator[Problem]:
    """Yield the first value of each pose rotation that cannot be in rad, if its column gives no unit."""
    for column in columns:
        if components.get(column.name) != "rad" or column.factor is not None:
            continue
        for row, value in enumerate(numbers[column.name]):
            if abs(value) > math.pi:
                problem = (
                    f"expected a rotation in rad, of at most pi, found {value:g}: these look like degrees"
                )
                remedy = f"write the unit into the header: {column.name} [deg], or {column.name} [rad] if it is that"
                yield Problem(row, column.text, problem, remedy)
                break


def _format_as_in_file(quoted: QuotedNumber, columns: Sequence[HeaderColumn], lines: CsvLines) -> str:
    """Format a number as in its cell, with the header's unit; also in SI units if these differ."""
    number = format(quoted.value, quoted.digits)
    index = [column.name for column in columns].index(quoted.column)
    column = columns[index]
    if column.factor is None:
        return number
    cell = lines.notation.cells(lines.records[1 + quoted.row][1], "")[index]
    if column.si == column.unit:
        return f"{cell} {column.unit}"
    return f"{cell} {column.unit} ({f'{number} {column.si}'.strip()})"


def _measurements(
    texts: dict[str, list[str]],
    numbers: dict[str, list[float]],
    lines: CsvLines,
    source: str,
    units: Mapping[str, str],
    components: Mapping[str, str],
    drives: str | list[str],
) -> Measurements:
    """Build measurements from a file's columns by name; `units` are those of the header."""
    rows = len(lines.records) - 1
    zeros = [0.0] * rows
    columns: dict[str, Any] = {spec.argument: numbers.get(spec.column) for spec in number_columns()}
    return Measurements.from_rows(
        texts["pose"],
        **columns,
        points=np.array([numbers.get(name, zeros) for name in components]).T,
        point_sigma=np.array([numbers.get(f"{SPREAD_PREFIX}{name}", zeros) for name in components]).T,
        components=components,
        mode=texts["mode"] or None,
        shapes={
            name.removeprefix(SHAPE): column for name, column in numbers.items() if name.startswith(SHAPE)
        },
        band=lines.band,
        priors=lines.priors,
        usable=lines.usable,
        state=lines.state,
        drives=drives,
        source=source,
        lines=np.array([line for line, _ in lines.records[1:]]),
        unit=units["frequency"],
        settings={name.removeprefix(SET): column for name, column in numbers.items() if name.startswith(SET)},
        level=numbers.get(LEVEL.column),
        level_unit=units.get(LEVEL.column, ""),
    )
