"""Read measured signals from a file of any of the known formats."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from os import PathLike, fspath
from pathlib import Path

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.loop.measured.csv_format import check_regular, unreadable
from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.archives import ARCHIVE, SHAKE_AND_TUNE
from pkmodes.modaltest.signals.functions import SignalFile, SignalRequest
from pkmodes.modaltest.signals.matlab import MATLAB
from pkmodes.modaltest.signals.numpy_arrays import NUMPY
from pkmodes.modaltest.signals.table import TABLE
from pkmodes.modaltest.signals.universal_file import UNIVERSAL_FILE
from pkmodes.modaltest.signals.wav import WAV

Reader = Callable[[Path, SignalRequest], SignalFile]
#: Formats by name, in the order in which they are tried.
FORMATS: dict[str, Format[Reader]] = {
    file_format.name: file_format
    for file_format in (UNIVERSAL_FILE, MATLAB, NUMPY, WAV, SHAKE_AND_TUNE, ARCHIVE, TABLE)
}
#: Formats that hold several records, each with a name.
MULTI_RECORD_FORMATS = (SHAKE_AND_TUNE, ARCHIVE, MATLAB, NUMPY)
#: Number of first bytes by which a format is recognised.
HEAD_SIZE = 4096
EVERYTHING = SignalRequest()
CONTENT, REMEDY = "the signals", "give a universal file, a MATLAB, NumPy or WAV file, or a table in text"


def format_of(path: Path, head: bytes) -> Format[Reader] | None:
    """Return the format of a file: by its first bytes, then by its suffix; None if neither is known.

    Any text may be a table, so for text the suffix decides first: a universal file without its beginning is no table.
    """
    by_content = [file_format for file_format in FORMATS.values() if file_format.recognises(head)]
    by_suffix = [
        file_format for file_format in FORMATS.values() if path.suffix.lower() in file_format.suffixes
    ]
    certain = [file_format for file_format in by_content if file_format is not TABLE]
    return next(iter([*certain, *by_suffix, *by_content]), None)


def read_signals(path: str | PathLike[str], request: SignalRequest = EVERYTHING) -> SignalFile:
    """Read the measured signals or identified modes in a file.

    - path: a universal file with datasets 58, 58b, 55 or 2414; a MATLAB, NumPy or WAV file; a table in text; or one
      of several records in a file of Shake&Tune, an archive or an array, ``belts.zip/raw_data_a.csv``
    - request: the request for its content; everything by default

    Raises MeasurementError if the file cannot be read, is incomplete or invalid, with the place in it.
    """
    file_path, member = Path(path), ""
    try:
        parents = () if file_path.exists() else file_path.parents
        container = next((parent for parent in parents if parent.is_file()), None)
    except OSError:  # such as a name that is too long; opening it reports the reason
        container = None
    if container is not None:  # the rest of the path names a record in it
        file_path, member = container, file_path.relative_to(container).as_posix()
    source = fspath(file_path)
    try:
        check_regular(file_path, source, CONTENT, REMEDY)
        with file_path.open("rb") as file:
            head = file.read(HEAD_SIZE)
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        raise unreadable(error, source, CONTENT) from None
    if not head:
        raise MeasurementError("expected measured signals, found an empty file", source, REMEDY)
    file_format = format_of(file_path, head)
    if file_format is None:
        problem = "expected a file of measured signals, found another kind of content"
        raise MeasurementError(problem, source, REMEDY)
    if member and file_format not in MULTI_RECORD_FORMATS:
        problem = "expected an archive or a file of Shake&Tune, MATLAB or NumPy, "
        problem += f"found another file ({file_format.name})"
        raise MeasurementError(problem, source, f"leave {shown(member)} out of its name")
    if request.names and file_format is UNIVERSAL_FILE:
        problem = "expected names of columns, variables or channels in the record, found a universal file"
        raise MeasurementError(
            problem, source, "leave names out: a universal file says which signal is the force"
        )
    try:
        return file_format.read(file_path, replace(request, member=member))
    except OSError as error:
        raise unreadable(error, source, CONTENT) from None
