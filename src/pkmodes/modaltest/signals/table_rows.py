"""Rows of a table, and the separators that programs write after their last cells."""

from __future__ import annotations

import io
import re
from itertools import islice

from pkmodes.modaltest.signals.scanning import decode_line
from pkmodes.modaltest.signals.table_parts import change_parts

#: Number of leading lines examined to decide whether rows end with a separator.
EXAMINED_ROWS = 20


def is_row(line: bytes) -> bool:
    """Return whether a line is neither blank nor a comment."""
    return bool(line.strip()) and not line.lstrip().startswith(b"#")


def remove_trailing_separators(
    names: tuple[str, ...], body: bytes, separator: str, column_count: int
) -> tuple[tuple[str, ...], bytes]:
    """Return the names and the rows of a table without separators after the last cell.

    - column_count: number of columns; 0 if unknown, when the longest examined row gives it
    """
    rows = [
        decode_line(line).split(separator) for line in islice(io.BytesIO(body), EXAMINED_ROWS) if is_row(line)
    ]
    width = column_count or max((len(row) for row in rows), default=len(names))
    while len(names) > width and not names[-1]:
        names = names[:-1]
    if not any(_has_surplus_empty_cells(row, len(names)) for row in rows):
        return names, body
    cell_pattern = rf"[^{separator}\r\n]*"
    surplus_separators = re.compile(
        rf"^((?:{cell_pattern}{separator}){{{len(names) - 1}}}{cell_pattern})(?:{separator}[ \t]*)+(?=\r?$)".encode(),
        re.MULTILINE,
    )
    return names, change_parts(body, lambda part: surplus_separators.sub(rb"\1", part))


def _has_surplus_empty_cells(row: list[str], column_count: int) -> bool:
    """Return whether a row has more cells than the table has columns, and these are all empty."""
    return len(row) > column_count and not "".join(row[column_count:]).strip(' \t\r\n"')
