"""Read modal measurements from files of any of the known formats."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from os import PathLike
from pathlib import Path
from types import MappingProxyType

from pkmodes.core.base.drives import FREE
from pkmodes.loop.measured.columns import POSITION
from pkmodes.loop.measured.csv_format import CSV
from pkmodes.loop.measured.formats import Format, Machine, Reader
from pkmodes.loop.measured.measurements import Measurements

#: Formats by name.  The first one also reads files of unknown format, since its errors say what is expected.
FORMATS: dict[str, Format[Reader]] = {file_format.name: file_format for file_format in (CSV,)}
#: Number of bytes from which a format is recognised.
HEAD_BYTES = 4096


def format_of(path: str | PathLike[str]) -> Format[Reader]:
    """Return the format of a file, by its content, else by its suffix."""
    file_path, head = Path(path), b""
    try:
        if file_path.is_file():
            with file_path.open("rb") as file:
                head = file.read(HEAD_BYTES)
    except (OSError, ValueError):  # the reader of the format reports the error
        pass
    by_content = (file_format for file_format in FORMATS.values() if file_format.recognises(head))
    by_suffix = (
        file_format for file_format in FORMATS.values() if file_path.suffix.lower() in file_format.suffixes
    )
    return next(by_content, None) or next(by_suffix, None) or next(iter(FORMATS.values()))


def read_measurements(
    path: str | PathLike[str],
    channels: Collection[str] | Mapping[str, str],
    *,
    positions: bool = True,
    components: Sequence[Mapping[str, str]] = (POSITION,),
    settings: Mapping[str, str] = MappingProxyType({}),
    drives: str | None = None,
    state: str | None = None,
    others: Callable[[], Mapping[str, Collection[str]]] = dict,
    usual_drives: str = FREE,
) -> Measurements:
    """Read modal measurements of a machine whose setups are poses.

    - path: a table in UTF-8, separated by commas, semicolons or tabs, with decimal commas where commas do not
      separate.  It has one row for each identified mode: the columns ``pose``, one for each component of a pose,
      ``frequency``, ``sigma`` [Hz], and where known ``sigma_<component>``, ``damping``, ``sigma_damping``, ``mode``,
      ``drives``, ``state``, ``level`` (of excitation, in any unit), ``shape:<coordinate>``, ``sigma_shape`` and
      ``set:<path>``.  A column name may carry a unit, ``frequency [rad/s]``.  A comment line
      ``# band: 10 Hz, 400 Hz`` gives the band in which modes were identified, ``# drives: held`` says what the motors
      did in all rows, and ``# state: before`` in which state the machine was; other lines that begin with ``#`` are
      ignored, as are blank lines.
    - channels: coordinates that a shape column may name.  A mapping gives their SI units; otherwise the unit of a
      shape column may be a length or an angle.
    - positions: whether the pose components are required.  If not, either all or none of them must be present.
    - components: possible sets of pose components, each with SI units; if there are several, the header decides
    - settings: paths that a column ``set:<path>`` may name, with their SI units
    - drives: what the motors did, "free" or "held", if the file does not say it; otherwise `usual_drives`
    - state: the state of the machine whose rows are read, of a file with rows of several
    - others: returns the columns of other machines, by what such a machine is called: an error says whose columns a
      file has

    Returns the rows in the order of the file, in SI units.
    Raises MeasurementError if the file cannot be read or is invalid, with line, column, what was expected and what
    was found.
    """
    return format_of(path).read(
        path, Machine(channels, positions, components, settings, drives, state, others, usual_drives)
    )


def read_modes(path: str | PathLike[str], channels: Collection[str] | Mapping[str, str]) -> Measurements:
    """Read modal measurements of any structure.

    Parameters
    ----------
    path : path-like
        A table in UTF-8, separated by commas, semicolons or tabs, with decimal commas where commas do not separate.
        It has one row for each identified mode: the columns ``pose`` (the label of a setup),
        ``frequency``, ``sigma`` [Hz], and where known ``damping``, ``sigma_damping``, ``mode``, ``level``,
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
