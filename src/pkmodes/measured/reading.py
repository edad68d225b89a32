"""Read modal measurements from CSV with a header, or report the first problem with its line and column."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from types import MappingProxyType
from typing import NoReturn

from pkmodes.base.errors import MeasurementError
from pkmodes.measured.columns import POSITION
from pkmodes.measured.header import components_of, read_header
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.table import cells_of, read_lines, read_table

LARGEST_FILE = 50_000_000
#: First bytes of spreadsheet files: a zip archive, and the older Excel format.
WORKBOOKS = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")


def read_measurements(
    path: str | PathLike[str],
    channels: Collection[str] | Mapping[str, str],
    *,
    positions: bool = True,
    components: Sequence[Mapping[str, str]] = (POSITION,),
    settings: Mapping[str, str] = MappingProxyType({}),
) -> Measurements:
    """Read modal measurements of a machine whose setups are poses.

    Parameters
    ----------
    path : path-like
        A CSV file in UTF-8 with one row for each identified mode: the columns ``pose``, one for each component of a
        pose, ``frequency``, ``sigma`` [Hz], and where known ``sigma_<component>``, ``damping``, ``sigma_damping``,
        ``mode``, ``shape:<coordinate>``, ``sigma_shape`` and ``set:<path>``.  A column name may carry a unit,
        ``frequency [rad/s]``.  A comment line ``# band: 10 Hz, 400 Hz`` gives the band in which modes were
        identified; other lines that begin with ``#`` are ignored, as are blank lines.
    channels : collection of str, or mapping of str to str
        Coordinates that a shape column may name.  A mapping gives their SI units; otherwise the unit of a shape
        column may be a length or an angle.
    positions : bool
        Whether the pose components are required.  If not, either all or none of them must be present.
    components : sequence of mapping of str to str
        Possible sets of pose components, each with SI units; if there are several, the header decides.
    settings : mapping of str to str, optional
        Paths that a column ``set:<path>`` may name, with their SI units.

    Returns
    -------
    Measurements
        The rows in the order of the file, in SI units.

    Raises
    ------
    MeasurementError
        If the file cannot be read or is invalid, with line, column, what was expected and what was found.
    """
    source = fspath(path)
    lines = read_lines(read_text(Path(path), source), source)
    if not lines.records:
        remedy = "start with the names of the columns"
        raise MeasurementError("expected a header and rows, found none", source, remedy)
    number, line = lines.records[0]
    where = f"{source}: line {number}"
    cells = cells_of(line, where)
    chosen = components_of(cells, components, channels)
    columns = read_header(cells, where, channels, positions, chosen, settings)
    return read_table(columns, lines, source, chosen)


def read_modes(path: str | PathLike[str], channels: Collection[str] | Mapping[str, str]) -> Measurements:
    """Read modal measurements of any structure.

    Parameters
    ----------
    path : path-like
        A CSV file in UTF-8 with one row for each identified mode: the columns ``pose`` (the label of a setup),
        ``frequency``, ``sigma`` [Hz], and where known ``damping``, ``sigma_damping``, ``mode``,
        ``shape:<channel>`` and ``sigma_shape``.  A column name may carry a unit, ``frequency [rad/s]``.  A comment
        line ``# band: 10 Hz, 400 Hz`` gives the band in which modes were identified.
    channels : collection of str, or mapping of str to str
        Channels of the structure, which the shape columns name.  A mapping gives their SI units; otherwise the unit
        of a shape column may be a length or an angle.

    Returns
    -------
    Measurements
        The rows in the order of the file, in SI units.

    Raises
    ------
    MeasurementError
        If the file cannot be read or is invalid, with line, column, what was expected and what was found.
    """
    return read_measurements(path, channels, positions=False)


def _refuse(what: str, where: str, remedy: str) -> NoReturn:
    raise MeasurementError(what, where, remedy) from None


def read_text(
    path: Path,
    source: str,
    what: str = "the measurements",
    remedy: str = "give a CSV file of modal measurements",
) -> str:
    """Return the text of a CSV file.

    Parameters
    ----------
    path : Path
    source : str
        The file, for messages.
    what, remedy : str
        What it should contain, and what to give instead of another file.

    Raises
    ------
    MeasurementError
        If it cannot be read, or is not UTF-8 text.
    """
    try:
        if path.exists() and not path.is_file():
            kind = "a folder" if path.is_dir() else "not a regular file"
            _refuse(f"cannot read {what}: it is {kind}", source, remedy)
        if path.stat().st_size > LARGEST_FILE:
            _refuse(f"cannot read {what}: it is larger than 50 MB", source, remedy)
        content = path.read_bytes()
        if content.startswith(WORKBOOKS):
            remedy = "open it in a spreadsheet program and save it as CSV UTF-8"
            _refuse("expected CSV text, found an Excel workbook or another archive", source, remedy)
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        found = f"expected UTF-8 text, found the byte 0x{error.object[error.start]:02x}"
        _refuse(found, f"{source}: line {line}", "save the file as UTF-8")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = getattr(error, "strerror", None) or str(error)
        remedy = "check its permissions" if isinstance(error, PermissionError) else "check the path"
        _refuse(f"cannot read {what}: {reason.lower()}", source, remedy)
