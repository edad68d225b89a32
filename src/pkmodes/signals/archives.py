"""Files that hold several records, one of which is named after the file: ``belts.stdata/A_20250214_101010``.

Shake&Tune, an extension of Klipper, writes its measurements into ``.stdata`` files: lines of JSON, each with a name
and samples of a time and three accelerations, compressed by Zstandard
(https://github.com/Frix-x/klippain-shaketune).  Its older versions put Klipper's tables into an archive.
"""

from __future__ import annotations

import tarfile
import zipfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from os import fspath
from pathlib import Path, PurePosixPath
from typing import TypeVar

import msgspec
import numpy as np

from pkmodes.core.base.errors import MeasurementError, nearest, shown
from pkmodes.measured.csv_format import WORKBOOKS
from pkmodes.measured.formats import Format
from pkmodes.signals.arrays import Variable, functions_of
from pkmodes.signals.functions import Array, Asked, SignalFile
from pkmodes.signals.sampling import as_sampled
from pkmodes.signals.table import TABLE, tabulated
from pkmodes.signals.table_text import check_text
from pkmodes.support.ordering import listed

T = TypeVar("T")
#: Bytes that are unpacked at most, and of a compressed file at a time: these may become many times as many.
LARGEST, BLOCK = 500_000_000, 4096
ZSTANDARD, GZIP, ZIP = b"\x28\xb5\x2f\xfd", b"\x1f\x8b", WORKBOOKS[0]
#: The first byte of what Shake&Tune wrote before version 5.1, which runs code where it is read.
PICKLE = b"\x80"
#: What the columns of samples are, and the unit in which Klipper measures accelerations.
COLUMNS, UNIT = ("time", "accel_x", "accel_y", "accel_z"), "mm/s^2"
#: What only a workbook has, which is an archive too.
OF_WORKBOOKS = "[Content_Types].xml"
INCOMPLETE = "the file is damaged or incomplete: copy it again"
UNPACK = "unpack it, and name its files in the record"
LARGE = f"expected at most {LARGEST / 1e6:g} MB, found more"


class Named(msgspec.Struct):
    """The name of a measurement."""

    name: str


class Measurement(Named):
    """A measurement: times [s] and accelerations."""

    samples: list[tuple[float, float, float, float]]


def read_shake_and_tune(path: Path, asked: Asked) -> SignalFile:
    """Read one measurement of Shake&Tune.

    Raises
    ------
    MeasurementError
        If zstandard is not installed, the file is damaged or of an old version, or has no such measurement.
    """
    source = fspath(path)
    content = _unpacked(path, source)
    if content.startswith(PICKLE):
        what = (
            "expected measurements in JSON, found a Python pickle, as Shake&Tune wrote it before version 5.1"
        )
        remedy = f"write each as a table {','.join(COLUMNS)}, or measure again with a newer version"
        raise MeasurementError(what, source, remedy)
    lines = [line for line in content.splitlines() if line.strip()]
    names: dict[str, int] = {}
    for number, line in enumerate(lines, start=1):
        names[_decoded(line, Named, f"{source}: line {number}").name] = number
    chosen = _chosen(names, asked.member, source, "measurement")
    where = f"{source}/{chosen}"
    samples = np.array(_decoded(lines[names[chosen] - 1], Measurement, where).samples).reshape(
        -1, len(COLUMNS)
    )

    def variable(name: str, values: Array) -> Variable:
        return Variable(name, "an array", values.shape, lambda: values)

    found = [variable(name, values) for name, values in zip(COLUMNS, samples.T, strict=True)]
    found[0] = variable(COLUMNS[0], as_sampled(samples[:, 0]))
    read = functions_of(found, where, replace(asked, member=""), "Shake&Tune")
    return replace(read, functions=tuple(replace(one, unit=UNIT) for one in read.functions))


def _decoded(line: bytes, kind: type[T], where: str) -> T:
    try:
        return msgspec.json.decode(line, type=kind)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise MeasurementError(f"expected a measurement of Shake&Tune: {error}", where, INCOMPLETE) from None


def _unpacked(path: Path, source: str) -> bytes:
    """Return what a file of one or several frames of Zstandard holds."""
    try:
        import zstandard
    except ImportError:
        what = "expected signals, found a file compressed by Zstandard, which needs the library zstandard"
        raise MeasurementError(what, source, "install it with pip install 'pkmodes[zstd]'") from None
    parts, total = [], 0
    frame = zstandard.ZstdDecompressor().decompressobj()
    with path.open("rb") as file:
        left = b""
        while left or (left := file.read(BLOCK)):
            if frame.eof:
                frame = zstandard.ZstdDecompressor().decompressobj()
            try:
                parts.append(frame.decompress(left))
            except zstandard.ZstdError as error:
                raise MeasurementError(f"cannot unpack the file: {error}", source, INCOMPLETE) from None
            left = frame.unused_data
            total += len(parts[-1])
            if total > LARGEST:
                raise MeasurementError(LARGE, source, "record less in one file")
    if not frame.eof:
        raise MeasurementError("expected a complete file, found its beginning", source, INCOMPLETE)
    return b"".join(parts)


def read_archive(path: Path, asked: Asked) -> SignalFile:
    """Read one table of a zip or tar archive.

    Raises
    ------
    MeasurementError
        If it is damaged, or has no such table.
    """
    source = fspath(path)
    try:
        with path.open("rb") as file:
            zipped = file.read(len(ZIP)) == ZIP
        with zipfile.ZipFile(path) if zipped else tarfile.open(path) as archive:
            files = dict(_of_zip(archive) if isinstance(archive, zipfile.ZipFile) else _of_tar(archive))
            if OF_WORKBOOKS in files:
                check_text(ZIP, source)
            tables = {name: load for name, load in files.items() if _is_table(name)}
            if not tables:
                what = f"expected an archive of tables, found {listed([*map(shown, files)], 4) or 'nothing'} in it"
                raise MeasurementError(what, source, UNPACK)
            chosen = _chosen(tables, asked.member, source, "table")
            content = tables[chosen]()
    except MeasurementError:
        raise
    except Exception as error:  # damage and passwords make readers raise errors of many types
        if isinstance(error, OSError) and error.errno is not None:
            raise
        reason = (str(error) or type(error).__name__).splitlines()[0].rstrip(":")
        raise MeasurementError(f"cannot read the archive: {reason}", source, UNPACK) from None
    return tabulated(content, f"{source}/{chosen}", asked)


def _is_table(name: str) -> bool:
    """Return whether a file of an archive is a table, and not one that macOS puts beside each."""
    place = PurePosixPath(name)
    return place.suffix.lower() in TABLE.suffixes and not place.name.startswith(".")


def _of_zip(archive: zipfile.ZipFile) -> Iterator[tuple[str, Callable[[], bytes]]]:
    """Yield the files of an archive, and how each is read."""
    for one in archive.infolist():
        if not one.is_dir():
            _check_size(one.file_size, str(archive.filename))
            yield one.filename, partial(archive.read, one)


def _of_tar(archive: tarfile.TarFile) -> Iterator[tuple[str, Callable[[], bytes]]]:
    """Yield the files of an archive, and how each is read."""
    total = 0
    for one in archive:
        total += one.size
        _check_size(total, str(archive.name))  # before the next one is looked for, which unpacks this one
        if (content := archive.extractfile(one) if one.isreg() else None) is not None:
            yield one.name, content.read


def _check_size(size: int, source: str) -> None:
    if size > LARGEST:
        raise MeasurementError(LARGE, source, UNPACK)


def _chosen(names: Mapping[str, object], asked: str, source: str, what: str) -> str:
    """Return the name that is asked for; the only one where none is."""
    if asked in names:
        return asked
    every = listed([*map(shown, names)], 6)
    if asked:
        remedy = nearest(asked, names, f"it has {every}")
        raise MeasurementError(f"expected a {what} {shown(asked)}, found none", source, remedy)
    if len(names) != 1:
        found = f"expected one {what}, found {len(names) or 'none'}"
        example = shown(f"{Path(source).name}/{next(iter(names), 'NAME')}")
        raise MeasurementError(found, source, f"name the one that is meant, files = [{example}]: {every}")
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
