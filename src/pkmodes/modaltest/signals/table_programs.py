"""Text that programs write around a table: a preamble, a row of units, a last line with the rate.

Each of `PROGRAMS` takes the content of a file and returns the table in it.  Removed lines become blank lines, so that
line numbers stay those of the file.
"""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from dataclasses import dataclass

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.modaltest.signals.scanning import decode_line
from pkmodes.modaltest.signals.table_parts import change_parts

LABVIEW, END_OF_HEADER = b"LabVIEW Measurement", b"***End_of_Header***"
#: Columns of LabVIEW that are no signals: times, and a comment in few rows.
X_VALUE, COMMENT = b"X_Value", b"Comment"
NAMES, LINE_ENDS = (
    re.compile(rb"^[ \t]*X_Value[^\n]*", re.MULTILINE),
    re.compile(rb"(?<![\t \r])[\t \r]+(?=\n|\Z)"),
)
#: Entries of its header that state the number of time columns.
X_COLUMN_ENTRIES = (b"X_Columns", b"Multi_Headings")
#: The last line of a file of RepRapFirmware, such as ``Rate 1344, overflows 0``.
REPRAP = re.compile(rb"\n[ \t]*Rate[ \t]+([0-9.]+),[ \t]*overflows[ \t]+([0-9]+)[ \t\r]*(?=\n|\Z)")
RATE = re.compile(rb"[0-9]+\.?[0-9]*|\.[0-9]+")


@dataclass(frozen=True)
class FramedTable:
    """A table without the text that a program wrote around it.

    - rate: sampling rate that the file states [Hz]
    - losses: its statements on lost samples
    """

    content: bytes
    rate: float | None = None
    losses: tuple[str, ...] = ()


def _labview(content: bytes, source: str) -> FramedTable | None:
    """Remove the two headers of a LabVIEW measurement file (.lvm, version 2).

    https://www.ni.com/en/support/documentation/supplemental/06/specification-for-the-labview-measurement-file---lvm-.html
    """
    if not content.lstrip().startswith(LABVIEW):
        return None
    end = content.rfind(END_OF_HEADER)
    if end < 0:
        problem = "expected a LabVIEW measurement file, found no end of its header"
        raise MeasurementError(problem, source, "export the file again")
    entries = {}
    for line in io.BytesIO(content[:end]):
        key, *value = re.split(rb"[\t,;]", line.strip(), maxsplit=1)
        if key in X_COLUMN_ENTRIES and value:
            entries[key] = decode_line(value[0]).strip()
    columns = entries.get(X_COLUMN_ENTRIES[0], "One")
    if columns != "One" or entries.get(X_COLUMN_ENTRIES[1], "No") != "No":
        problem = f"expected one column of times, found X_Columns {shown(columns)}"
        raise MeasurementError(problem, source, "write the file with one X column and one header")
    if content.count(END_OF_HEADER) > 2:
        problem = "expected one measurement, found several in the file"
        raise MeasurementError(problem, source, "write each measurement into a file of its own")
    start = end + len(END_OF_HEADER)
    return FramedTable(
        change_parts(content, _clean_rows, start, prefix=b"\n" * content.count(b"\n", 0, start))
    )


def _clean_rows(part: bytes) -> bytes:
    """Return rows of LabVIEW without blanks at their ends, where comments would be, and with X_Value renamed time."""

    def names(line: re.Match[bytes]) -> bytes:
        signals = line[0].rstrip().removesuffix(COMMENT).rstrip(b"\t,; ")
        return b"time" + signals.lstrip().removeprefix(X_VALUE)

    return LINE_ENDS.sub(b"", NAMES.sub(names, part) if X_VALUE in part else part)


def _reprap(content: bytes, source: str) -> FramedTable | None:
    """Remove the last line of RepRapFirmware's accelerometer files: the rate, and overflows of its buffer."""
    last_line = REPRAP.search(content[-200:])
    if last_line is None:
        return None
    start = max(len(content) - 200, 0) + last_line.start()
    if RATE.fullmatch(last_line[1]) is None:
        number = content.count(b"\n", 0, start + 1) + 1
        where = f"{source}: line {number}"
        remedy = "correct it; or remove the line, and give the rate in the record"
        raise MeasurementError(
            f"expected a sampling rate, found {shown(decode_line(last_line[1]))}", where, remedy
        )
    rate, overflows = float(last_line[1]), int(last_line[2])
    table = content[: start + 1] + content[start + len(last_line[0]) :]
    losses = (f"the file states: {decode_line(last_line[0]).strip()}",) if overflows else ()
    return FramedTable(table, rate or None, losses)


PROGRAMS: tuple[Callable[[bytes, str], FramedTable | None], ...] = (_labview, _reprap)


def remove_frame(content: bytes, source: str) -> FramedTable:
    """Return a table without the text that the program wrote around it.

    Raises MeasurementError if the program is known, but its file is not a single table.
    """
    frames = (program(content, source) for program in PROGRAMS)
    return next((frame for frame in frames if frame is not None), FramedTable(content))
