"""Files that hold several records, one of which is named after the file: ``belts.stdata/A_20250214_101010``.

Shake&Tune, an extension of Klipper, writes its measurements into ``.stdata`` files: lines of JSON, each with a name
and samples of a time and three accelerations, compressed by Zstandard
(https://github.com/Frix-x/klippain-shaketune).  Its older versions put Klipper's tables into an archive.
"""

from __future__ import annotations

import re
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from itertools import islice
from os import fspath
from pathlib import Path, PurePosixPath
from typing import TypeVar

import msgspec
import numpy as np

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.support.ordering import listed
from pkmodes.loop.measured.csv_format import WORKBOOKS
from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.arrays import find_functions
from pkmodes.modaltest.signals.functions import Array, SignalFile, SignalRequest
from pkmodes.modaltest.signals.sampling import restore_even_times
from pkmodes.modaltest.signals.table import TABLE, parse_table
from pkmodes.modaltest.signals.table_text import check_text
from pkmodes.modaltest.signals.tar_files import tar_files
from pkmodes.modaltest.signals.variables import FileVariable
from pkmodes.modaltest.signals.zip_files import open_zip

T = TypeVar("T")
#: A time and three accelerations.
Row = tuple[float, float, float, float]
#: Maximum size of an unpacked record in bytes: a base, plus this multiple of its file's size; and of all together.  A
#: table of measured numbers compresses to no less than a tenth of its size.
BASE_SIZE, MAX_EXPANSION, MAX_UNPACKED_SIZE = 16_000_000, 20, 500_000_000
#: Bytes unpacked at a time, each of which may become 32,000; and the window to which a file may refer back.
BLOCK_SIZE, MAX_WINDOW = 128, 1 << 23
#: Maximum number of files in an archive, and measurements in a file.
MAX_FILES = 20_000
#: Bytes of samples read at once, and what separates two samples.
PART_SIZE, ROW_END = 1 << 16, re.compile(rb"(\])\s*,\s*(?=\[)")
ZSTANDARD, GZIP, ZIP = b"\x28\xb5\x2f\xfd", b"\x1f\x8b", WORKBOOKS[0]
#: The first byte of files from Shake&Tune before version 5.1: pickles, which run code when they are read.
PICKLE = b"\x80"
#: The columns of samples, and the unit in which Klipper measures accelerations.
COLUMNS, UNIT = ("time", "accel_x", "accel_y", "accel_z"), "mm/s^2"
#: A file found only in workbooks, which are archives too.
WORKBOOK_MEMBER = "[Content_Types].xml"
INCOMPLETE = "the file is damaged or incomplete: copy it again"
UNPACK = "unpack it, and name its files in the record"


class NamedMeasurement(msgspec.Struct):
    """The name of a measurement."""

    name: str


class Measurement(NamedMeasurement):
    """A measurement: times [s] and accelerations, as they are written."""

    samples: msgspec.Raw


def read_shake_and_tune(path: Path, request: SignalRequest) -> SignalFile:
    """Read one measurement of Shake&Tune.

    Raises MeasurementError if zstandard is not installed, the file is damaged or of an old version, or has no such
    measurement.
    """
    source = fspath(path)
    names: dict[str, None] = {}
    requested_line = bytearray()
    for number, line in enumerate(_split_lines(_unpack_zstandard(path, source)), start=1):
        if number == 1 and line.startswith(PICKLE):
            problem = "expected measurements in JSON, found a Python pickle, as Shake&Tune wrote it "
            problem += "before version 5.1"
            remedy = f"write each as a table {','.join(COLUMNS)}, or measure again with a newer version"
            raise MeasurementError(problem, source, remedy)
        name = _decode(line, NamedMeasurement, f"{source}: line {number}").name
        if len(names) == MAX_FILES:
            raise MeasurementError(
                f"expected at most {MAX_FILES:,} measurements, found more", source, INCOMPLETE
            )
        if name == request.member or names.keys() <= {name}:
            requested_line = line
        names[name] = None
        del line
    selected = _select_name(names, request.member, source, "measurement")
    where = f"{source}/{selected}"
    parts = list(_sample_parts(_decode(requested_line, Measurement, where).samples, where))
    del requested_line
    samples = np.concatenate([np.empty((0, len(COLUMNS))), *parts])

    def variable(name: str, values: Array) -> FileVariable:
        return FileVariable(name, "an array", values.shape, lambda: values)

    variables = [variable(name, values) for name, values in zip(COLUMNS, samples.T, strict=True)]
    variables[0] = variable(COLUMNS[0], restore_even_times(samples[:, 0]))
    file = find_functions(variables, where, replace(request, member=""), "Shake&Tune")
    return replace(file, functions=tuple(replace(function, unit=UNIT) for function in file.functions))


def _sample_parts(raw_samples: msgspec.Raw, where: str) -> Iterator[Array]:
    """Yield parts of the samples, (n, 4): as Python objects, all of them would take five times the text's memory."""
    text = memoryview(raw_samples)
    if bytes(text[:1]) != b"[":
        raise MeasurementError("expected a measurement of Shake&Tune: no list of samples", where, INCOMPLETE)
    start, end = 1, len(text) - 1
    while start < end:
        separator = ROW_END.search(text, min(start + PART_SIZE, end), end)
        stop = separator.end(1) if separator else end
        rows = _decode(b"[%b]" % bytes(text[start:stop]), list[Row], where)
        yield np.array(rows, np.float64).reshape(-1, len(COLUMNS))
        start = separator.end() if separator else end


def _decode(line: bytes | bytearray, kind: type[T], where: str) -> T:
    try:
        return msgspec.json.decode(line, type=kind)
    except RecursionError:
        problem = "expected a measurement of Shake&Tune, found lists in very many lists"
        raise MeasurementError(problem, where, INCOMPLETE) from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise MeasurementError(f"expected a measurement of Shake&Tune: {error}", where, INCOMPLETE) from None


def _split_lines(parts: Iterable[bytes]) -> Iterator[bytearray]:
    """Yield the lines of a text that are not blank."""
    line = bytearray()
    for part in parts:
        *ends, rest = part.split(b"\n")
        for end in ends:
            line += end
            if line.strip():
                yield line
            line = bytearray()
        line += rest
    if line.strip():
        yield line


def _unpack_zstandard(path: Path, source: str) -> Iterator[bytes]:
    """Yield the content of a file of one or several Zstandard frames, part by part."""
    try:
        import zstandard
    except ImportError:
        problem = "expected signals, found a file compressed by Zstandard, which needs the library zstandard"
        raise MeasurementError(problem, source, "install it with pip install 'pkmodes[zstd]'") from None
    unpacking, total, limit = zstandard.ZstdDecompressor(max_window_size=MAX_WINDOW), 0, _max_unpacked(path)
    frame = unpacking.decompressobj()
    with path.open("rb") as file:
        unread = b""
        while unread or (unread := file.read(BLOCK_SIZE)):
            if frame.eof:
                frame = unpacking.decompressobj()
            try:
                part = frame.decompress(unread)
            except zstandard.ZstdError as error:
                raise MeasurementError(f"cannot unpack the file: {error}", source, INCOMPLETE) from None
            unread = frame.unused_data
            total += len(part)
            _check_size(total, limit, source, "record less in one file")
            yield part
    if not frame.eof:
        raise MeasurementError("expected a complete file, found its beginning", source, INCOMPLETE)


def read_archive(path: Path, request: SignalRequest) -> SignalFile:
    """Read one table of a zip or tar archive.

    Raises MeasurementError if it is damaged, or has no such table.
    """
    source, limit = fspath(path), _max_unpacked(path)
    try:
        with path.open("rb") as file:
            is_zip = file.read(len(ZIP)) == ZIP
        with open_zip(path) if is_zip else nullcontext() as archive:
            files = _zip_loaders(archive, limit, source) if archive else _tar_loaders(path, limit, source)
            if WORKBOOK_MEMBER in files:
                check_text(ZIP, source)
            paths = {name: PurePosixPath(name) for name in files}
            tables = {
                name: load
                for name, load in files.items()
                # macOS adds a file of the same name with a dot before it.
                if paths[name].suffix.lower() in TABLE.suffixes and not paths[name].name.startswith(".")
            }
            if not tables:
                problem = f"expected an archive of tables, found {listed([*map(shown, files)], 4) or 'nothing'} in it"
                raise MeasurementError(problem, source, UNPACK)
            selected = _select_name(tables, request.member, source, "table")
            content = [tables[selected]()]
    except MeasurementError:
        raise
    except Exception as error:  # damage and passwords make readers raise errors of many types
        if isinstance(error, OSError) and error.errno is not None:
            raise
        reason = (str(error) or type(error).__name__).splitlines()[0].rstrip(":")
        raise MeasurementError(f"cannot read the archive: {reason}", source, UNPACK) from None
    return parse_table(content.pop(), f"{source}/{selected}", request)  # which may then release it


def _zip_loaders(archive: zipfile.ZipFile, limit: int, source: str) -> dict[str, Callable[[], bytes]]:
    """Return a function for each file of an archive, by name, that reads it if it has at most `limit` bytes."""

    def load(entry: zipfile.ZipInfo) -> bytes:
        _check_size(entry.file_size, limit, source)
        with archive.open(entry) as file:
            return file.read(limit)

    return {entry.filename: partial(load, entry) for entry in archive.infolist() if not entry.is_dir()}


def _tar_loaders(path: Path, limit: int, source: str) -> dict[str, Callable[[], bytes]]:
    """Return a function for each file of an archive, by name, that reads it if it has at most `limit` bytes."""

    def load(number: int) -> bytes:
        files = tar_files(path)  # closes the archive when it is released
        entry = next(islice(files, number, None))
        _check_size(entry.size, limit, source)
        return entry.read(limit)

    loaders: dict[str, Callable[[], bytes]] = {}
    total = 0
    for number, entry in enumerate(tar_files(path)):
        total += entry.size
        # Checked before the next file is looked for, which unpacks this one.
        _check_size(total, MAX_UNPACKED_SIZE, source)
        loaders[entry.name] = partial(load, number)
        if number == MAX_FILES:
            problem = f"expected an archive of at most {MAX_FILES:,} files, found more"
            raise MeasurementError(problem, source, UNPACK)
    return loaders


def _max_unpacked(path: Path) -> int:
    """Return the largest allowed size of an unpacked record in a file [bytes]."""
    return min(MAX_UNPACKED_SIZE, BASE_SIZE + MAX_EXPANSION * path.stat().st_size)


def _check_size(size: int, limit: int, source: str, remedy: str = UNPACK) -> None:
    if size > limit:
        problem = f"expected at most {limit / 1e6:.4g} MB when unpacked, found more"
        raise MeasurementError(problem, source, remedy)


def _select_name(names: Mapping[str, object], requested_name: str, source: str, record_kind: str) -> str:
    """Return the requested name; the only one if none is requested."""
    if requested_name in names:
        return requested_name
    listing = listed([*map(shown, names)], 6)
    if requested_name:
        remedy = nearest_name(requested_name, names, f"it has {listing}")
        raise MeasurementError(
            f"expected a {record_kind} {shown(requested_name)}, found none", source, remedy
        )
    if len(names) != 1:
        problem = f"expected one {record_kind}, found {len(names) or 'none'}"
        example = shown(f"{Path(source).name}/{next(iter(names), 'NAME')}")
        raise MeasurementError(problem, source, f"name the one that is meant, files = [{example}]: {listing}")
    return next(iter(names))


SHAKE_AND_TUNE = Format(
    "Shake&Tune", (".stdata",), lambda head: head.startswith(ZSTANDARD), read_shake_and_tune
)
ARCHIVE = Format(
    "archive",
    (".zip", ".tar", ".tgz", ".gz"),
    lambda head: head.startswith((GZIP, ZIP)) or head[257:262] == b"ustar",
    read_archive,
)
