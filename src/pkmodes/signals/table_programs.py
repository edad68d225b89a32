"""What programs write around a table: a preamble, a row of units, a last line with the rate.

Each of `PROGRAMS` takes the lines of a file and returns what is a table of them, with blank lines for what it takes
out, so that the numbers of lines stay those of the file.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.signals.scanning import text_of

LABVIEW, END_OF_HEADER = b"LabVIEW Measurement", b"***End_of_Header***"
#: Columns of LabVIEW that are no signals: times, and a text that few rows have.
X_VALUE, COMMENT = b"X_Value", b"Comment"
#: The last line of a file of RepRapFirmware, such as ``Rate 1344, overflows 0``.
REPRAP = re.compile(rb"\n[ \t]*Rate[ \t]+([0-9.]+),[ \t]*overflows[ \t]+([0-9]+)[ \t\r]*(?=\n|\Z)")


@dataclass(frozen=True)
class Framed:
    """A table without what a program wrote around it.

    Attributes
    ----------
    content : bytes
    rate : float, optional
        Sampling rate that the file states [Hz].
    losses : tuple of str
        What it states of lost samples.
    """

    content: bytes
    rate: float | None = None
    losses: tuple[str, ...] = ()


def _labview(content: bytes, source: str) -> Framed | None:
    """Take the two headers of a LabVIEW measurement file (.lvm, version 2) away.

    https://www.ni.com/en/support/documentation/supplemental/06/specification-for-the-labview-measurement-file---lvm-.html
    """
    if not content.lstrip().startswith(LABVIEW):
        return None
    head, end, body = content.rpartition(END_OF_HEADER)
    entries = dict(
        re.split(r"[\t,;]", line.strip(), maxsplit=1)
        for line in text_of(head).splitlines()
        if re.search(r"[\t,;]", line.strip())
    )
    if not end:
        what = "expected a LabVIEW measurement file, found no end of its header"
        raise MeasurementError(what, source, "export the file again")
    if (
        entries.get("X_Columns", "One").strip() != "One"
        or entries.get("Multi_Headings", "No").strip() != "No"
    ):
        what = f"expected one column of times, found X_Columns {shown(entries.get('X_Columns', ''))}"
        raise MeasurementError(what, source, "write the file with one X column and one header")
    if content.count(END_OF_HEADER) > 2:
        what = "expected one measurement, found several in the file"
        raise MeasurementError(what, source, "write each measurement into a file of its own")
    lines = body.split(b"\n")
    for i, line in enumerate(lines):
        if line.lstrip().startswith(X_VALUE):
            names = line.rstrip().removesuffix(COMMENT).rstrip(b"\t,; ")
            lines[i] = b"time" + names.lstrip().removeprefix(X_VALUE)
        else:
            lines[i] = line.rstrip(b"\t \r")
    return Framed(b"\n" * (head + end).count(b"\n") + b"\n".join(lines))


def _reprap(content: bytes, source: str) -> Framed | None:
    """Take the last line of RepRapFirmware's accelerometer files away: rate, and overflows of its buffer."""
    found = REPRAP.search(content[-200:])
    if found is None:
        return None
    rate, overflows = float(found[1]), int(found[2])
    start = max(len(content) - 200, 0) + found.start()
    rest = content[: start + 1] + content[start + len(found[0]) :]
    lost = (f"the file states: {text_of(found[0]).strip()}",) if overflows else ()
    return Framed(rest, rate or None, lost)


PROGRAMS: tuple[Callable[[bytes, str], Framed | None], ...] = (_labview, _reprap)


def framed(content: bytes, source: str) -> Framed:
    """Return a table without what the program that wrote it has put around it.

    Raises
    ------
    MeasurementError
        If the program is known, and what it wrote is not one table.
    """
    found = (program(content, source) for program in PROGRAMS)
    return next((one for one in found if one is not None), Framed(content))
