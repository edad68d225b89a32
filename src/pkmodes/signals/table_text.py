"""The text of a table: its header, its comments, and its columns of numbers.

What separates the cells, and where numbers may have decimal commas, is as in every table (`pkmodes.measured.cells`).
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.measured.cells import NUMBER, separator_of
from pkmodes.measured.csv_format import WORKBOOKS
from pkmodes.signals.functions import Array
from pkmodes.signals.scanning import text_of

REMEDY = "start with a row of names: time and the sensors, or frequency with re: and im: columns, or psd_x"
#: Lines at the end in which spreadsheet programs leave nothing but separators.
EMPTY_END = re.compile(rb"(?:\n[ \t,;\r]*)+\Z")
COMMENT_LINES = re.compile(rb"^[ \t]*#.*\n?", re.MULTILINE)
BLANK_LINES = re.compile(rb"^[ \t\r]*\n", re.MULTILINE)


@dataclass(frozen=True)
class TableText:
    """The parts of a table.

    Attributes
    ----------
    source : str
        The file, for messages.
    separator : str
        Of its cells.
    names : tuple of str
        Cells of the header.
    header_line : int
        Number of its line.
    comments : tuple of str
        Lines that begin with ``#`` other than the header, in the whole file.
    body : bytes
        The lines from `first_line` on.
    first_line : int
        Number of the first line of the body.
    """

    source: str
    separator: str
    names: tuple[str, ...]
    header_line: int
    comments: tuple[str, ...]
    body: bytes
    first_line: int

    def columns(self, wanted: Sequence[int]) -> Array:
        """Read some columns.

        Returns
        -------
        ndarray, shape (columns, rows)

        Raises
        ------
        MeasurementError
            If a cell is not a finite number or a row has too few or too many cells, with line and column.
        """
        body = BLANK_LINES.sub(b"", COMMENT_LINES.sub(b"", self.body) if b"#" in self.body else self.body)
        body = body.replace(b'"', b"")
        if not body.strip():
            raise MeasurementError("expected rows, found only a header", self.source, "add the rows")
        if not self._has_even_rows(body):
            raise self._first_problem(wanted)
        if self.separator != ",":
            body = body.replace(b",", b".")
        try:
            table = np.loadtxt(
                io.TextIOWrapper(io.BytesIO(body), "latin-1"),
                delimiter=self.separator,
                comments=None,
                usecols=wanted,
                ndmin=2,
            )
        except ValueError:
            raise self._first_problem(wanted) from None
        if not np.all(np.isfinite(table)):
            raise self._first_problem(wanted)
        return np.ascontiguousarray(table.T)

    def line_of(self, row: int) -> int:
        """Return the number of the line of a row, both of which count from the header."""
        for index, (number, _) in enumerate(self._rows()):
            if index == row:
                return number
        raise IndexError(row)

    def _has_even_rows(self, body: bytes) -> bool:
        """Return whether each row has as many cells as the header."""
        characters = np.frombuffer(body if body.endswith(b"\n") else body + b"\n", np.uint8)
        ends = np.flatnonzero(characters == ord("\n"))
        separators = np.flatnonzero(characters == ord(self.separator))
        before = np.searchsorted(separators, ends)
        return bool(np.all(np.diff(before, prepend=0) == len(self.names) - 1))

    def _rows(self) -> Iterator[tuple[int, str]]:
        """Yield the rows with the numbers of their lines."""
        for number, line in enumerate(self.body.split(b"\n"), start=self.first_line):
            if line.strip() and not line.lstrip().startswith(b"#"):
                yield number, text_of(line).replace('"', "")

    def _first_problem(self, wanted: Sequence[int]) -> MeasurementError:
        """Return the error for the first row that cannot be read."""
        for number, line in self._rows():
            cells = [cell.strip() for cell in line.split(self.separator)]
            if len(cells) != len(self.names):
                what = f"expected {len(self.names)} cells, found {len(cells)}"
                remedy = "give each row as many cells as the header; do not separate decimals by commas there"
                return MeasurementError(what, f"{self.source}: line {number}", remedy)
            for column in wanted:
                cell = cells[column] if self.separator == "," else cells[column].replace(",", ".")
                if NUMBER.fullmatch(cell) is None or not np.isfinite(float(cell)):
                    what = f"expected a finite number, found {shown(cells[column]) if cell else 'nothing'}"
                    where = f"{self.source}: line {number}, column {self.names[column]}"
                    return MeasurementError(what, where, "write a plain number, or leave the row out")
        return MeasurementError("expected rows of numbers", self.source, REMEDY)


def check_text(content: bytes, source: str) -> None:
    """Refuse what is not text.

    Raises
    ------
    MeasurementError
    """
    if content.startswith(WORKBOOKS):
        remedy = "open it in a spreadsheet program and save it as CSV UTF-8"
        raise MeasurementError("expected a table in text, found an Excel workbook", source, remedy)
    if b"\0" in content:
        remedy = "save a table as CSV UTF-8"
        raise MeasurementError("expected a table in text, found binary data", source, remedy)


def split_table(content: bytes, source: str) -> TableText:
    """Find the header of a table: the first line that is not a comment, or a comment right above the numbers.

    Raises
    ------
    MeasurementError
        If the content is not text, or has no header.
    """
    check_text(content, source)
    content = content.removeprefix(b"\xef\xbb\xbf")
    if b"\n" not in content:
        content = content.replace(b"\r", b"\n")
    content = EMPTY_END.sub(b"\n", content)
    comments: list[tuple[int, str]] = []
    start, number = 0, 0
    while start < len(content):
        end = content.find(b"\n", start) + 1 or len(content)
        number += 1
        line = text_of(content[start:end]).strip("\r\n")
        if line.lstrip().startswith("#"):
            comments.append((number, line.strip()))
        elif line.strip():
            break
        start = end
    else:
        raise MeasurementError("expected a header and rows, found none", source, REMEDY)
    if not _is_numbers(line):
        header, names_line, first = line, number, number + 1
        body = content[end:]
    else:
        names_line, header = _header_among(comments, line, source, number)
        comments = [one for one in comments if one[0] != names_line]
        first, body = number, content[start:]
    separator = separator_of(header)
    names = tuple(cell.strip().strip('"').strip() for cell in header.split(separator))
    texts = [text for _, text in comments]
    if b"#" in body:
        texts += [text_of(match).strip() for match in COMMENT_LINES.findall(body)]
    return TableText(source, separator, names, names_line, tuple(texts), body, first)


def _header_among(comments: Sequence[tuple[int, str]], row: str, source: str, number: int) -> tuple[int, str]:
    """Return the last comment that has as many cells as the first row, without its ``#``."""
    for line, text in reversed(comments):
        names = text.lstrip("# \t")
        separator = separator_of(names)
        if not text.startswith("##") and len(names.split(separator)) == len(row.split(separator)):
            return line, names
    what = f"expected the names of the columns, found {shown(row)}"
    raise MeasurementError(what, f"{source}: line {number}", REMEDY)


def _is_numbers(line: str) -> bool:
    """Return whether a line begins with a number."""
    cells = line.split(separator_of(line))
    return NUMBER.fullmatch(cells[0].strip().strip('"').replace(",", ".")) is not None
