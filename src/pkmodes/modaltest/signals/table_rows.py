"""Rows of a table, and the separators that programs write after their last cells."""

from __future__ import annotations

import io
import re
from itertools import islice

from pkmodes.modaltest.signals.scanning import decode_line
from pkmodes.modaltest.signals.table_parts import change_parts

#: First lines by which it is decided whether rows end with a separator.
EXAMINED_ROWS = 20


def is_row(line: bytes) -> bool:
    """Return whether a line is neither blank nor a comment."""
    return bool(line.strip()) and not line.lstrip().startswith(b"#")


def remove_trailing_separators(
    names: tuple[str, ...], body: bytes, separator: str, count: int
) -> tuple[tuple[str, ...], bytes]:
    """Return the names and the rows of a table without separators after the last cell.

    - count: of the columns, 0 if only the names and the rows show it
    """
    rows = [
        decode_line(line).split(separator) for line in islice(io.BytesIO(body), EXAMINED_ROWS) if is_row(line)
    ]
    width = count or max((len(row) for row in rows), default=len(names))
    while len(names) > width and not names[-1]:
        names = names[:-1]
    if all(len(row) <= len(names) or "".join(row[len(names) :]).strip(' \t\r\n"') for row in rows):
        return names, body
    cell = rf"[^{separator}\r\n]*"
    longer = re.compile(
        rf"^((?:{cell}{separator}){{{len(names) - 1}}}{cell})(?:{separator}[ \t]*)+(?=\r?$)".encode(),
        re.MULTILINE,
    )
    return names, change_parts(body, lambda part: longer.sub(rb"\1", part))
