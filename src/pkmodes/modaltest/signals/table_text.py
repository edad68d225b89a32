"""The text of a table: its header, its comments, and its columns of numbers.

Separators of cells and decimal commas are as in every other table (`pkmodes.loop.measured.cells`).
"""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.loop.measured.cells import NUMBER, number_in, separator_of
from pkmodes.loop.measured.csv_format import WORKBOOKS
from pkmodes.modaltest.signals.clock import is_clock
from pkmodes.modaltest.signals.functions import Array
from pkmodes.modaltest.signals.scanning import decode_line
from pkmodes.modaltest.signals.table_parts import (
    change_parts,
    check_lines,
    join_parts,
    split_parts,
    to_smallest_type,
)
from pkmodes.modaltest.signals.table_rows import is_row, remove_trailing_separators
from pkmodes.modaltest.signals.units import unit_text

#: Separator of cells if there is no other; such a table is read as one with tabs.
BLANKS = re.compile(rb"[ \t]+")
AROUND_LINES = re.compile(rb"^[ \t]+|(?<![ \t])[ \t]+(?=\r?$)", re.MULTILINE)
#: Carriage returns inside a line; a reader of numbers would take them for line ends.
INSIDE_LINES = re.compile(rb"\r(?![\r\n]|\Z)")
#: A possible missing value in the rows: no number, or nothing between two separators or at an end.
GAP = re.compile(rb"[nN][aA][nN]|[iI][nN][fF]|[;,\t] *[;,\t\r\n]|^ *[;,\t]|[;,\t] *\Z", re.MULTILINE)
MISSING = re.compile(r"[+-]?(?:nan|inf|infinity)|", re.IGNORECASE)
REMEDY = "start with a row of names: time and the sensors, or frequency with re: and im: columns, or psd_x"
#: Maximum number of columns of a table, and of letters of a column's name.
MAX_COLUMNS, MAX_NAME_LENGTH = 10_000, 1000
#: Characters of the empty lines of separators that spreadsheet programs leave at the end.
EMPTY_CHARACTERS = b" \t,;\r\n"
COMMENT_LINES = re.compile(rb"^[ \t]*#.*\n?", re.MULTILINE)
BLANK_LINES = re.compile(rb"^[ \t\r]*\n", re.MULTILINE)


@dataclass(frozen=True)
class TableText:
    """The parts of a table.

    - source: the file, for messages
    - separator: separator of its cells
    - names: cells of the header
    - header_line: number of its line
    - head: the lines before the body
    - body: the lines from `first_line` on
    - first_line: number of the first line of the body
    """

    source: str
    separator: str
    names: tuple[str, ...]
    header_line: int
    head: bytes
    body: bytes
    first_line: int

    @property
    def comments(self) -> Iterator[str]:
        """The lines that begin with ``#`` other than the header, in the whole file."""
        for number, text in _comments(self.head):
            if number != self.header_line:
                yield text
        for match in COMMENT_LINES.finditer(self.body) if b"#" in self.body else ():
            yield decode_line(match[0]).strip()

    def columns(self, indices: Sequence[int]) -> list[NDArray[Any]]:
        """Read some columns.

        Returns arrays, each (rows,), in double precision, or in a smaller type that holds the same whole numbers.
        Raises MeasurementError if a cell is not a finite number or a row has too few or too many cells, with line and
        column.
        """
        columns: list[list[NDArray[Any]]] = [[] for _ in indices]
        for start, end in split_parts(self.body):
            part = self.body[start:end]
            if (carriage_return := INSIDE_LINES.search(part)) is not None:
                line = self.first_line + self.body.count(b"\n", 0, start + carriage_return.start())
                problem = "expected the end of the line, found a carriage return inside it"
                raise MeasurementError(problem, f"{self.source}: line {line}", "export the table again")
            numbers = self._numbers(part, indices)
            if numbers is None:
                raise self._first_problem(indices)
            for column, values in zip(columns, numbers, strict=True):
                column.append(to_smallest_type(values))
            del numbers
        if not columns or not sum(part.size for part in columns[0]):
            raise MeasurementError("expected rows, found only a header", self.source, "add the rows")
        return [join_parts(columns.pop(0)) for _ in indices]

    def _numbers(self, part: bytes, indices: Sequence[int]) -> Array | None:
        """Return columns of some of the lines, (columns, rows); None if a cell or a row is invalid."""
        if b"#" in part:
            part = COMMENT_LINES.sub(b"", part)
        rows = BLANK_LINES.sub(b"", part).replace(b'"', b"")
        if not rows.strip():
            return np.empty((len(indices), 0))
        characters = np.frombuffer(rows if rows.endswith(b"\n") else rows + b"\n", np.uint8)
        separators = np.flatnonzero(characters == ord(self.separator))
        separators_before = np.searchsorted(separators, np.flatnonzero(characters == ord("\n")))
        if not np.all(np.diff(separators_before, prepend=0) == len(self.names) - 1):
            return None  # a row has more or fewer cells than the header
        if self.separator != ",":
            rows = rows.replace(b",", b".")
        lines = io.TextIOWrapper(io.BytesIO(rows), "latin-1")
        try:
            numbers = np.loadtxt(lines, delimiter=self.separator, comments=None, usecols=indices, ndmin=2).T
        except ValueError:
            return None
        return np.ascontiguousarray(numbers) if np.all(np.isfinite(numbers)) else None

    def cell(self, column: int) -> str:
        """Return the text of a cell of the first row, "" without rows."""
        return next((self._cells(line)[column : column + 1] for _, line in self._rows()), [""])[0]

    def texts(self, column: int) -> Iterator[str]:
        """Yield the cells of a column, whose rows are even."""
        return (self._cells(line)[column] for _, line in self._rows())

    @property
    def may_have_gaps(self) -> bool:
        """Whether a cell may be empty or no finite number: a quick check, which may give false alarms."""
        return GAP.search(self.body) is not None

    def without_gaps(
        self, abscissa: int, indices: Sequence[int], needs_values: Callable[[float], bool]
    ) -> TableText:
        """Return the table without the rows that lack a requested value and need none.

        - needs_values: whether a row must have all values, by the number in the column `abscissa`
        """

        def remove_rows(part: bytes) -> bytes:
            if GAP.search(part) is None:
                return part
            # Blank lines keep the line numbers.
            return b"".join(line if is_kept(line) else b"\n" for line in io.BytesIO(part))

        def is_kept(line: bytes) -> bool:
            cells = self._cells(self._row(line)) if is_row(line) else []
            if len(cells) != len(self.names) or not any(MISSING.fullmatch(cells[i]) for i in indices):
                return True
            value = number_in(cells[abscissa].replace(",", "."), None)
            return value is None or needs_values(value)

        return replace(self, body=change_parts(self.body, remove_rows))

    def without_first_row(self) -> TableText:
        """Return the table without its first row."""
        number, _ = next(self._rows())
        start = 0
        for _ in range(number - self.first_line + 1):
            start = self.body.find(b"\n", start) + 1 or len(self.body)
        return replace(self, body=self.body[start:], first_line=number + 1)

    def line_of(self, row: int) -> int:
        """Return the line number of a row."""
        for index, (number, _) in enumerate(self._rows()):
            if index == row:
                return number
        raise IndexError(row)

    def _rows(self) -> Iterator[tuple[int, str]]:
        """Yield the rows with the numbers of their lines."""
        for number, line in enumerate(io.BytesIO(self.body), start=self.first_line):
            if is_row(line):
                yield number, self._row(line)

    def _row(self, line: bytes) -> str:
        """Return a row without its line end and quotes."""
        return decode_line(line.removesuffix(b"\n")).replace('"', "")

    def _cells(self, line: str) -> list[str]:
        return [cell.strip() for cell in line.split(self.separator)]

    def _first_problem(self, indices: Sequence[int]) -> MeasurementError:
        """Return the error for the first row that cannot be read."""
        for number, line in self._rows():
            cells = self._cells(line)
            if len(cells) == 1 < len(self.names) and any(map(str.isalpha, line)):
                problem = f"expected a row of numbers, found the text {shown(line.strip())}"
                remedy = "measure again if it says that something failed; otherwise remove the line"
                return MeasurementError(problem, f"{self.source}: line {number}", remedy)
            if len(cells) != len(self.names):
                problem = f"expected {len(self.names)} cells, found {len(cells)}"
                remedy = "give each row as many cells as the header; do not separate decimals by commas there"
                return MeasurementError(problem, f"{self.source}: line {number}", remedy)
            for column in indices:
                cell = cells[column] if self.separator == "," else cells[column].replace(",", ".")
                if NUMBER.fullmatch(cell) is None or not np.isfinite(float(cell)):
                    problem = f"expected a finite number, found {shown(cells[column]) if cell else 'nothing'}"
                    where = f"{self.source}: line {number}, column {self.names[column]}"
                    return MeasurementError(problem, where, "write a plain number, or leave the row out")
        return MeasurementError("expected rows of numbers", self.source, REMEDY)


def check_text(content: bytes, source: str) -> None:
    """Refuse what is not text.

    Raises MeasurementError.
    """
    if content.startswith(WORKBOOKS):
        remedy = "open it in a spreadsheet program and save it as CSV UTF-8"
        raise MeasurementError("expected a table in text, found an Excel workbook", source, remedy)
    if b"\0" in content:
        remedy = "save a table as CSV UTF-8"
        raise MeasurementError("expected a table in text, found binary data", source, remedy)


def split_table(content: bytes, source: str, columns: Sequence[str] = ()) -> TableText:
    """Find the header of a table: the first line that is not a comment, or a comment right above the numbers.

    - columns: names of the columns, if not those of the header, or there is none

    Raises MeasurementError if the content is not text, or has no header.
    """
    check_text(content, source)
    content = content.removeprefix(b"\xef\xbb\xbf")
    if b"\n" not in content:
        content = content.replace(b"\r", b"\n")
    last = content.find(b"\n", len(content.rstrip(EMPTY_CHARACTERS)))
    content = content if last < 0 else content[: last + 1]
    check_lines(content, source)
    start, number, line = _first_line(content)
    if not line:
        raise MeasurementError("expected a header and rows, found none", source, REMEDY)
    if not _is_numbers(line):
        header, names_line = line, number
        start, number = content.find(b"\n", start) + 1 or len(content), number + 1
    else:
        comments = _comments(content[:start])
        names_line, header = _find_header(comments, line, source, number, columns)
    separator, names = _split_header(header, _first_row(content, start))
    if len(names) > MAX_COLUMNS or max(map(len, names)) > MAX_NAME_LENGTH:
        problem = f"expected the names of at most {MAX_COLUMNS:,} columns, each of at most {MAX_NAME_LENGTH} letters"
        found_names = f"{len(names):,} names, the longest of {max(map(len, names)):,}"
        raise MeasurementError(f"{problem}, found {found_names}", f"{source}: line {names_line}", REMEDY)
    head = content[:start]
    if separator == " ":
        separator = "\t"
        body = change_parts(content, lambda part: BLANKS.sub(b"\t", AROUND_LINES.sub(b"", part)), start)
    else:
        body = content[start:]
    names, body = remove_trailing_separators(names, body, separator, len(columns))
    if columns:
        if len(columns) != len(names):
            problem = f"expected the names of {len(names)} columns, found {len(columns)}"
            raise MeasurementError(
                problem, f"{source}: line {names_line}", "name each column of the table, in order"
            )
        names = tuple(columns)
    return _add_units(TableText(source, separator, names, names_line, head, body, number))


def _first_line(content: bytes) -> tuple[int, int, str]:
    """Return the start of the first line that is not a comment, its number, and its text, "" if there is none."""
    start, number = 0, 1
    while start < len(content):
        end = content.find(b"\n", start) + 1 or len(content)
        if is_row(content[start:end]):
            return start, number, decode_line(content[start:end]).strip("\r\n")
        start, number = end, number + 1
    return start, number, ""


def _comments(head: bytes) -> Iterator[tuple[int, str]]:
    """Yield the comments before a table, with the numbers of their lines."""
    for number, line in enumerate(io.BytesIO(head), start=1):
        if line.lstrip().startswith(b"#"):
            yield number, decode_line(line).strip()


def _add_units(table: TableText) -> TableText:
    """Return a table with the units from the row below its names added to them, if there is such a row."""
    row = _first_row(table.body)
    cells = [cell.strip().strip('"').strip() for cell in row.split(table.separator)]
    units = [cell[1:-1].strip() if cell[:1] + cell[-1:] in ("[]", "()") else cell for cell in cells]
    if not any(units) or max(map(len, units)) > MAX_NAME_LENGTH or len(units) != len(table.names):
        return table
    if not all(not unit or unit == "-" or unit_text(unit) for unit in units):
        return table  # numbers, or anything else
    names = tuple(
        f"{name} [{unit}]" if unit not in ("", "-") else name
        for name, unit in zip(table.names, units, strict=True)
    )
    return replace(table.without_first_row(), names=names)


def _first_row(content: bytes, start: int = 0) -> str:
    """Return the first line from an offset that is not a comment, "" if there is none among a thousand."""
    for _ in range(1000):
        end = content.find(b"\n", start) + 1 or len(content)
        if is_row(content[start:end]):
            return decode_line(content[start:end]).strip("\r\n")
        start = end
    return ""


def _split_header(header: str, row: str) -> tuple[str, tuple[str, ...]]:
    """Return the separator of the cells, a blank if there is no other, and the cells of the header."""
    separator = separator_of(header)
    words = header.split()
    if (separator not in header or _are_numbers(words)) and len(words) == len(row.split()) > 1:
        return " ", tuple(words)
    return separator, tuple(cell.strip().strip('"').strip() for cell in header.split(separator))


def _find_header(
    comments: Iterable[tuple[int, str]], row: str, source: str, number: int, columns: Sequence[str]
) -> tuple[int, str]:
    """Return the last comment that has as many cells as the first row, without its ``#``; else the row itself."""
    header = None
    for line, text in comments:
        names = text.lstrip("# \t")
        separator = separator_of(names)
        matches_by_blanks = separator not in names and len(names.split()) == len(row.split()) > 1
        cells, row_cells = names.split(separator), row.split(separator)
        matches = matches_by_blanks or len(cells) == len(row_cells)
        # The row may end with a separator.
        matches |= len(cells) == len(row.rstrip(f"{separator} \t").split(separator)) > 1
        if not text.startswith("##") and matches:
            header = line, names
    if header is not None:
        return header
    if columns:
        return number, row
    problem = f"expected the names of the columns, found {shown(row)}"
    remedy = f'{REMEDY}; or name them in the record: columns = ["time", "acc_1"]'
    raise MeasurementError(problem, f"{source}: line {number}", remedy)


def _is_numbers(line: str) -> bool:
    """Return whether a line begins with a number, or with a time of day."""
    first = line.split(separator_of(line))[0].strip().strip('"')
    return is_clock(first) or _are_numbers([first]) or _are_numbers(line.split())


def _are_numbers(words: Sequence[str]) -> bool:
    """Return whether all words are numbers, perhaps with decimal commas."""
    return all(NUMBER.fullmatch(word.replace(",", ".")) and not word.endswith(",") for word in words)
