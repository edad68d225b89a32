"""Measurements in CSV with a header, one row for each mode, and the text of any CSV file."""

from __future__ import annotations

import codecs
from os import PathLike, fspath
from pathlib import Path
from typing import NoReturn

from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.cells import separator_of
from pkmodes.loop.measured.csv_rows import lines_of_state, read_lines, read_table, states_of
from pkmodes.loop.measured.formats import Format, Machine
from pkmodes.loop.measured.header import components_of, read_header
from pkmodes.loop.measured.measurements import Measurements

MAX_FILE_SIZE = 50_000_000
#: First bytes of UTF-16 text, in either byte order.
UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
#: First bytes of spreadsheet files: a zip archive, and the older Excel format.
WORKBOOKS = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")


def read_csv(path: str | PathLike[str], machine: Machine) -> Measurements:
    """Read measurements, or raise an error for the first problem with its line and column."""
    source = fspath(path)
    lines = read_lines(read_text(Path(path), source), source)
    where, cells = lines.header(source, "start with the names of the columns")
    components = components_of(cells, machine.components, machine.channels)
    columns = read_header(cells, where, machine, components)
    lines = lines_of_state(lines, cells, source, machine.state)
    return read_table(columns, lines, source, components, machine.drives, machine.usual_drives)


def states_in(path: str | PathLike[str]) -> tuple[str, ...]:
    """Return the states of the machine of which a file has rows, in their order; an empty text where it names none.

    Raises MeasurementError if it cannot be read, has no header, or some rows name no state.
    """
    source = fspath(path)
    lines = read_lines(read_text(Path(path), source), source)
    _, cells = lines.header(source, "start with the names of the columns")
    states = states_of(lines, cells, source)
    if "" in states and any(states):
        lines_of_state(lines, cells, source, None)  # the error names the row
    return tuple(dict.fromkeys(states))


def begins_with_header(head: bytes) -> bool:
    """Return whether the first line that is not a comment names the column of the poses."""
    lines = (line.strip() for line in decode(head, "replace").splitlines())
    header = next((line for line in lines if line and not line.startswith("#")), "")
    return "pose" in [cell.strip(' "').lower() for cell in header.split(separator_of(header))]


CSV = Format("CSV", (".csv",), begins_with_header, read_csv)


def decode(content: bytes, errors: str = "strict") -> str:
    """Return text in UTF-8, or in UTF-16 if its first bytes are those of UTF-16, as in Excel's Unicode text.

    Raises UnicodeDecodeError if it is neither, and errors are not replaced.
    """
    return content.decode("utf-16" if content.startswith(UTF_16) else "utf-8-sig", errors)


def _refuse(problem: str, where: str, remedy: str) -> NoReturn:
    raise MeasurementError(problem, where, remedy) from None


def read_text(
    path: Path,
    source: str,
    subject: str = "the measurements",
    remedy: str = "give a CSV file of modal measurements",
    max_size: int = MAX_FILE_SIZE,
) -> str:
    """Return the text of a file.

    - source: the file, for messages
    - subject, remedy: what it should contain, and what to give instead of another file
    - max_size: bytes

    Raises MeasurementError if it cannot be read, or is not UTF-8 text.
    """
    try:
        check_regular(path, source, subject, remedy)
        if path.stat().st_size > max_size:
            _refuse(f"cannot read {subject}: it is larger than {max_size / 1e6:g} MB", source, remedy)
        content = path.read_bytes()
        if content.startswith(WORKBOOKS):
            remedy = "open it in a spreadsheet program and save it as CSV UTF-8"
            _refuse("expected CSV text, found an Excel workbook or another archive", source, remedy)
        return decode(content)
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        problem = f"expected UTF-8 text, found the byte 0x{error.object[error.start]:02x}"
        _refuse(problem, f"{source}: line {line}", "save the file as UTF-8")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        raise unreadable(error, source, subject) from None


def check_regular(path: Path, source: str, subject: str, remedy: str) -> None:
    """Refuse a path that exists but is not a regular file.

    - source: the path, for messages
    - subject, remedy: what it should contain, and what to give instead

    Raises MeasurementError if it is a folder, a device or the like.
    """
    if path.exists() and not path.is_file():
        kind = "a folder" if path.is_dir() else "not a regular file"
        _refuse(f"cannot read {subject}: it is {kind}", source, remedy)


def unreadable(error: Exception, source: str, subject: str) -> MeasurementError:
    """Return the error of a file that cannot be read."""
    reason = getattr(error, "strerror", None) or str(error)
    remedy = "check its permissions" if isinstance(error, PermissionError) else "check the path"
    return MeasurementError(f"cannot read {subject}: {reason.lower()}", source, remedy)
