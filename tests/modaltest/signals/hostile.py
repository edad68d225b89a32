"""Files that would fill the memory of a careless reader, and sound ones of the same kinds; what reading takes."""

from __future__ import annotations

import gzip
import io
import json
import struct
import subprocess
import sys
import tarfile
import zipfile
import zlib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from scipy.io import savemat

#: Reads files in a process of its own, which may take 3 GB, and says of each what came of it and how much memory it
#: took besides what the interpreter and its libraries take.
CHILD = """
import json, os, resource, signal, sys
from pathlib import Path
resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
import scipy.io, scipy.interpolate
try:
    import h5py, zstandard
except ImportError:
    pass
from pkmodes.modaltest.campaign.description import read_description
from pkmodes.core.base.errors import PkmodesError
from pkmodes.modaltest.signals.functions import SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

def memory(name):
    lines = Path("/proc/self/status").read_text().splitlines()
    return 1024 * int(next(line for line in lines if line.startswith(name)).split()[1])

def read(path, rate, sensors, band):
    Path("/proc/self/clear_refs").write_text("5")  # forget what was taken at most before
    before, outcome = memory("VmRSS"), ""
    try:
        if path.endswith(".toml"):
            read_description(Path(path))
        else:
            read_signals(path, SignalRequest(rate, sensors and frozenset(sensors), (), band and tuple(band)))
    except PkmodesError as error:
        outcome = str(error)
    print(json.dumps([outcome, memory("VmHWM") - before]), flush=True)

for each in json.loads(sys.argv[1]):
    if not (child := os.fork()):  # each file in a process whose memory has nothing left of others
        resource.setrlimit(resource.RLIMIT_CPU, (60, 60))  # what computes without end
        signal.alarm(240)  # what waits without end; other programs may use the processor meanwhile
        read(*each)
        os._exit(0)
    if os.waitpid(child, 0)[1]:
        print(json.dumps(["neither read nor refused", 3 << 30]), flush=True)
"""
CAN_MEASURE = Path("/proc/self/clear_refs").exists()


class Case(NamedTuple):
    """A kind of file: what writes one of about so many bytes, its suffix, and what is asked of it.

    Attributes
    ----------
    refused : str
        What the refusal says; "" of files that are read.
    times : float
        Memory that reading may take, in sizes of the file.
    constant : float
        And besides: of parts that are looked at together, and of what unpacks to no more than that [bytes].
    """

    write: Callable[[Path, int], None]
    suffix: str
    refused: str = ""
    times: float = 4.0
    constant: float = 4e6
    rate: float | None = None
    sensors: list[str] | None = None
    band: list[float] | None = None

    @property
    def sound(self) -> bool:
        """Whether it is a measurement of the size of its file."""
        return not self.refused and self.sensors is None


class Taken(NamedTuple):
    """What came of a file: the refusal, "" without one, and the memory that reading took [bytes]."""

    outcome: str
    memory: int


def taken(cases: Mapping[Path, Case], limit: float = 900.0) -> list[Taken]:
    """Read files in a process of its own, one after the other."""
    asked = json.dumps([(str(path), one.rate, one.sensors, one.band) for path, one in cases.items()])
    command = [sys.executable, "-c", CHILD, asked]
    done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
    assert not done.returncode, done.stderr[-2000:]
    return [Taken(*json.loads(line)) for line in done.stdout.splitlines()]


def numbers(rows: int, columns: int, seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=(rows, columns))


def table(
    path: Path, size: int, header: str, row: str, sample: Callable[[int], tuple[Any, ...]], end: str = ""
) -> None:
    """Write a table of about so many bytes: `row` is the format of what `sample` gives for each number."""
    parts, length, i = [header], 0, 0
    while length < size:
        parts.append(row.format(*sample(i)))
        length, i = length + len(parts[-1]), i + 1
    path.write_text("".join([*parts, end]))


def blanks(path: Path, size: int) -> None:
    a = numbers(1000, 3)
    table(
        path, size, "time x y z\n", "{:.3f}  {: .3f}  {: .3f}  {: .3f}\n", lambda i: (i / 1000, *a[i % 1000])
    )


def short_blanks(path: Path, size: int) -> None:
    table(path, size, "time x y z\n", "{} {} {} {}\n", lambda i: (i, i % 3, i % 5, i % 7))


def logger(path: Path, size: int) -> None:
    a = numbers(1000, 3)
    table(path, size, "time,x,y,z\n", "{:.4f},{:.4f},{:.4f},{:.4f}\n", lambda i: (i / 1000, *a[i % 1000]))


def short_cells(path: Path, size: int) -> None:
    table(path, size, "x,y,z\n", "{},{},{}\n", lambda i: (i % 3, i % 5, i % 7))


def comments_between(path: Path, size: int) -> None:
    table(path, size, "time,x\n", "#\n# {}\n{:.3f},{}\n", lambda i: (i % 10, i / 1000, i % 7))


def comments_before(path: Path, size: int) -> None:
    path.write_text("#\n" * (size // 2) + "time,x\n0,1\n1,2\n2,1\n")


def losses(path: Path, size: int) -> None:
    path.write_text("time,x\n" + "##gap 1\n" * (size // 8) + "0,1\n1,2\n2,1\n")


def units_stated(path: Path, size: int) -> None:
    table(path, size, "time,x\n0,1\n1,2\n2,1\n", "#unit {}=g\n", lambda i: (i,))


def labview(path: Path, size: int) -> None:
    head = (
        "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nMulti_Headings\tNo\nX_Columns\tOne\n"
        "***End_of_Header***\t\n\t\nChannels\t2\t\t\nDelta_X\t0.25\t0.25\t\n***End_of_Header***\t\t\n"
        "X_Value\tx\ty\tComment\n"
    )
    a = numbers(1000, 2)
    table(path, size, head, "{:.4f}\t{:.4f}\t{:.4f}\t\n", lambda i: (i / 1000, *a[i % 1000]))


def short_labview(path: Path, size: int) -> None:
    head = "LabVIEW Measurement\nSeparator\tTab\n***End_of_Header***\n\n***End_of_Header***\nX_Value\tx\tComment\n"
    table(path, size, head, "{}\t{}\t\n", lambda i: (i, i % 7))


def gaps(path: Path, size: int) -> None:
    a = numbers(1000, 2)
    table(
        path,
        size,
        "frequency,re:x,im:x,re:y,im:y\n0,nan,nan,nan,nan\n",
        "{:.2f},{:.3f},{:.3f},{:.3f},{:.3f}\n",
        lambda i: ((i + 1) / 100, *a[i % 1000], *a[(i + 7) % 1000]),
    )


def gaps_everywhere(path: Path, size: int) -> None:
    table(
        path,
        size,
        "frequency,re:x,im:x\n1,2,3\n2,3,4\n",
        "{},nan,\n",
        lambda i: (i + 3,),
    )


def one_line(path: Path, size: int) -> None:
    path.write_text("time,x\n" + "1 " * (size // 2))


def wide_header(path: Path, size: int) -> None:
    path.write_text("time" + ",x" * (size // 4) + "\n" + "1" + ",1" * (size // 4) + "\n")


def blank_header(path: Path, size: int) -> None:
    path.write_text("time,x" + " " * size + "y (\n0,1\n1,2\n")


def bad_rate(path: Path, size: int) -> None:
    table(path, size, "Sample,x\n", "{},{}\n", lambda i: (i, i % 7), "Rate 1.2.3, overflows 0\n")


def firmware(path: Path, size: int) -> None:
    a = numbers(1000, 3)
    table(
        path, size, "Sample,x,y,z\n", "{},{:.3f},{:.3f},{:.3f}\n",
        lambda i: (i, *a[i % 1000]), "Rate 1344, overflows 0\n",
    )  # fmt: skip


def clock(path: Path, size: int) -> None:
    table(
        path, size, "time,x\n", "10:{:02}:{:02}.{:03},{}\n",
        lambda i: (i // 60000 % 60, i // 1000 % 60, i % 1000, i % 7),
    )  # fmt: skip


# Arrays ---------------------------------------------------------------------------------------------------------


def element(kind: int, data: bytes) -> bytes:
    return struct.pack("<II", kind, len(data)) + data + bytes(-len(data) % 8)


def matrix(name: str, kind: int, dimensions: tuple[int, ...], rest: bytes) -> bytes:
    flags = struct.pack("<II", kind, 0)
    head = element(6, flags) + element(5, np.array(dimensions, "<i4").tobytes()) + element(1, name.encode())
    return element(14, head + rest)


def struct_of(name: str, fields: dict[str, bytes]) -> bytes:
    names = b"".join(field.encode().ljust(32, b"\0") for field in fields)
    rest = element(5, struct.pack("<i", 32)) + element(1, names)
    return matrix(name, 2, (1, 1), rest + b"".join(fields.values()))


def mat(path: Path, elements: list[bytes], compress: bool = True) -> None:
    header = b"MATLAB 5.0 MAT-file".ljust(124) + b"\0\1IM"
    if compress:
        packed = [zlib.compress(one, 9) for one in elements]
        elements = [struct.pack("<II", 15, len(one)) + one for one in packed]
    path.write_bytes(header + b"".join(elements))


def vector(name: str, values: np.ndarray) -> bytes:
    kinds = {"f8": (6, 9), "f4": (7, 7), "i2": (10, 3), "i1": (8, 1)}
    of, kind = kinds[values.dtype.str[1:]]
    return matrix(name, of, (len(values), 1), element(kind, values.tobytes()))


TIME = np.arange(1000) / 1000.0
#: Values that fill more memory than a small file may: 120 MB.
ZEROS = 15_000_000


def small_signals() -> list[bytes]:
    return [vector("time", TIME), vector("x", numbers(1000, 1)[:, 0])]


def structs(path: Path, size: int) -> None:
    """Compressed structs of zeros, a thousand times as large as the file; no sensor is called as their fields."""
    each = [
        *small_signals(),
        *(struct_of(f"s{i}", {"a": vector("", np.zeros(ZEROS // 20))}) for i in range(12)),
    ]
    mat(path, each)
    assert path.stat().st_size < size


def struct_fields(path: Path, size: int) -> None:
    """A compressed struct of very many small fields."""
    count = min(size * 2, 400_000)
    field = matrix("", 6, (1, 1), element(9, bytes(8)))
    rest = element(5, struct.pack("<i", 4)) + element(1, b"a\0\0\0" * count) + field * count
    mat(path, [*small_signals(), matrix("s", 2, (1, 1), rest)])


def named_zeros(path: Path, size: int) -> None:
    """A compressed sensor of zeros."""
    mat(path, [vector("time", TIME), vector("x", np.zeros(min(120 * size, ZEROS)))])


def integers(path: Path, size: int) -> None:
    a = np.random.default_rng(1).integers(-3000, 3000, (3, size // 6)).astype(np.int16)
    savemat(path, {"fs": 1000.0, "x": a[0], "y": a[1], "z": a[2]})


def integer_matrix(path: Path, size: int) -> None:
    a = np.random.default_rng(1).integers(-3000, 3000, (size // 6, 3)).astype(np.int16)
    savemat(path, {"fs": 1000.0, "data": a})


def one_integer_vector(path: Path, size: int) -> None:
    a = np.random.default_rng(1).integers(-3000, 3000, size // 2).astype(np.int16)
    savemat(path, {"fs": 1000.0, "x": a})


def doubles(path: Path, size: int) -> None:
    a = numbers(size // 32, 3)
    savemat(path, {"time": np.arange(len(a)) / 1000.0, "x": a[:, 0], "y": a[:, 1], "z": a[:, 2]})


def compressed_integers(path: Path, size: int) -> None:
    a = np.random.default_rng(1).integers(-3000, 3000, (3, size // 5)).astype(np.int16)
    savemat(path, {"fs": 1000.0, "x": a[0], "y": a[1], "z": a[2]}, do_compression=True)


def responses(path: Path, size: int) -> None:
    a = numbers(size // 40, 4).astype(float)
    f = np.arange(len(a)) / 100.0
    savemat(path, {"frequency": f, "x": a[:, 0] + 1j * a[:, 1], "y": a[:, 2] + 1j * a[:, 3]})


def npz(path: Path, size: int) -> None:
    a = np.random.default_rng(1).integers(-3000, 3000, (size // 6, 3)).astype(np.int16)
    np.savez(path, fs=1000.0, data=a)


def npy(path: Path, size: int) -> None:
    a = np.zeros(size // 24, dtype=[("time", "f8"), ("x", "f8"), ("y", "f8")])
    a["time"] = np.arange(len(a)) / 1000
    a["x"] = numbers(len(a), 1)[:, 0]
    np.save(path, a)


def zipped_zeros(path: Path, size: int) -> None:
    np.savez_compressed(path, time=TIME, x=np.zeros(min(120 * size, ZEROS)))


def npz_entries(path: Path, size: int) -> None:
    buffer = io.BytesIO()
    np.save(buffer, np.zeros(1))
    with zipfile.ZipFile(path, "w") as archive:
        for i in range(6000):
            archive.writestr(f"{i:0200}.npy", buffer.getvalue())


# Archives -------------------------------------------------------------------------------------------------------


def rows_of_text(size: int) -> bytes:
    a = numbers(1000, 3)
    line = "".join(f"{i / 1000:.3f},{a[i][0]:.3f},{a[i][1]:.3f},{a[i][2]:.3f}\n" for i in range(1000))
    return ("time,x,y,z\n" + line).encode()[:size]


def bloated_tar(path: Path, kind: bytes, size: int) -> None:
    """An archive whose long name, or pax header, is a thousand times as large as the file."""
    info = tarfile.TarInfo("././@LongLink")
    info.type, info.size = kind, min(size * 900, 300_000_000)
    with gzip.open(path, "wb") as file:
        file.write(info.tobuf(tarfile.GNU_FORMAT))
        left = info.size
        while left > 0:
            file.write(b"a" * min(left, 1 << 20))
            left -= 1 << 20
        file.write(bytes(-info.size % 512))
        table_info = tarfile.TarInfo("a.csv")
        content = rows_of_text(1000)
        table_info.size = len(content)
        file.write(table_info.tobuf() + content + bytes(-len(content) % 512) + bytes(1024))


def long_name(path: Path, size: int) -> None:
    bloated_tar(path, tarfile.GNUTYPE_LONGNAME, size)


def pax(path: Path, size: int) -> None:
    bloated_tar(path, tarfile.XHDTYPE, size)


def tar_members(path: Path, size: int) -> None:
    """An archive of very many empty files."""
    block = b"".join(tarfile.TarInfo(f"{i}.csv").tobuf() for i in range(1000))
    with gzip.open(path, "wb", compresslevel=1) as file:
        for _ in range(21):
            file.write(block)


def zip_entries(path: Path, size: int) -> None:
    with zipfile.ZipFile(path, "w") as archive:
        for i in range(6000):
            archive.writestr(f"{i:0200}", b"")


def zip_zeros(path: Path, size: int) -> None:
    with (
        zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive,
        archive.open("a.csv", "w") as file,
    ):
        file.write(b"x,y\n")
        for _ in range(min(max(1, size // 1000), 120)):
            file.write(b"0,0\n" * 250_000)


def zip_table(path: Path, size: int) -> None:
    a = numbers(size // 25, 3)
    text = "".join(f"{i / 1000:.3f},{x:.3f},{y:.3f},{z:.3f}\n" for i, (x, y, z) in enumerate(a))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.csv", "time,x,y,z\n" + text)


def tgz_table(path: Path, size: int) -> None:
    a = numbers(size // 25, 3)
    text = "".join(f"{i / 1000:.3f},{x:.3f},{y:.3f},{z:.3f}\n" for i, (x, y, z) in enumerate(a))
    content = ("time,x,y,z\n" + text).encode()
    with tarfile.open(path, "w:gz") as archive:
        info = tarfile.TarInfo("a.csv")
        info.size = len(content)
        archive.addfile(info, io.BytesIO(content))


def zstandard_of(path: Path, parts: list[bytes]) -> None:
    zstandard = pytest.importorskip("zstandard")

    with path.open("wb") as file, zstandard.ZstdCompressor(level=3).stream_writer(file) as writer:
        for part in parts:
            writer.write(part)


def stdata_zeros(path: Path, size: int) -> None:
    """Samples of zeros: ten thousand times as many bytes as the file."""
    rows = b"[0,0,0,0]," * 100_000
    size = min(size, 27_000)
    zstandard_of(path, [b'{"name": "a", "samples": [', *[rows] * max(1, size // 65), b"[1,0,0,0]]}\n"])


def stdata_nested(path: Path, size: int) -> None:
    zstandard_of(path, [b'{"name": "a", "x": ' + b"[" * 100_000 + b"]" * 100_000 + b', "samples": []}\n'])


def stdata(path: Path, size: int) -> None:
    def lines() -> Iterator[bytes]:
        yield b'{"name": "a", "samples": ['
        a = numbers(size // 16, 3).round(6) * 1000
        for i, (x, y, z) in enumerate(a):
            yield f"{',' if i else ''}[{i / 3200:.6f}, {x:.6f}, {y:.6f}, {z:.6f}]".encode()
        yield b"]}\n"

    zstandard_of(path, [b"".join(lines())])


# Campaigns ------------------------------------------------------------------------------------------------------


def dotted_key(path: Path, size: int) -> None:
    path.write_text(".".join(["a"] * min(size // 2, 400_000)) + " = 1\n")


# HDF5 -----------------------------------------------------------------------------------------------------------


def hdf5(path: Path, change: Callable[[Any], None]) -> None:
    """Write a sound file of version 7.3 with a second and three thousandths of a sensor, and change it."""
    import h5py

    with h5py.File(path, "w", userblock_size=512) as file:
        for name, values in (("time", TIME), ("x", numbers(1000, 1)[:, 0])):
            file[name] = values[None, :]
            file[name].attrs["MATLAB_class"] = np.bytes_("double")
        change(file)
    with path.open("r+b") as raw:
        raw.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(512))


def hdf5_integers(path: Path, size: int) -> None:
    a = np.random.default_rng(1).integers(-3000, 3000, (3, size // 6)).astype(np.int16)
    import h5py

    with h5py.File(path, "w") as file:
        file["fs"] = [[1000.0]]
        for name, values in zip("xyz", a, strict=True):
            file[name] = values


def hdf5_zeros(path: Path, size: int) -> None:
    """A compressed sensor of zeros."""
    hdf5(
        path, lambda file: file.create_dataset("y", data=np.zeros(min(120 * size, ZEROS)), compression="gzip")
    )


def hdf5_chunk(path: Path, _: int) -> None:
    """A sensor whose compressed part becomes a thousand times as large as it may be."""

    def change(file: Any) -> None:
        data = file.create_dataset("y", (1000,), "f8", chunks=(1000,), compression="gzip")
        data.id.write_direct_chunk((0,), zlib.compress(bytes(100_000_000), 9))

    hdf5(path, change)


#: Kinds of files by name.
CASES = {
    "table, columns aligned by blanks": Case(blanks, ".csv"),
    "table, cells of one digit between blanks": Case(short_blanks, ".csv"),
    "table, four decimals": Case(logger, ".csv"),
    "table, cells of one digit": Case(short_cells, ".csv", rate=1000.0),
    "table, comments between the rows": Case(comments_between, ".csv"),
    "comments before a table": Case(comments_before, ".csv"),
    "comments of lost samples": Case(losses, ".csv"),
    "comments of units": Case(units_stated, ".csv"),
    "table, times of day": Case(clock, ".csv"),
    "table of LabVIEW (`.lvm`)": Case(labview, ".lvm"),
    "table of LabVIEW, cells of one digit": Case(short_labview, ".lvm"),
    "table of functions, NaN at 0 Hz": Case(gaps, ".csv", band=[1.0, 2.0]),
    "table of functions, NaN outside the band": Case(gaps_everywhere, ".csv", band=[1.0, 2.0]),
    "table of RepRapFirmware": Case(firmware, ".csv"),
    "`.mat`, three vectors of 16 bits": Case(integers, ".mat"),
    "`.mat`, a matrix of 16 bits": Case(integer_matrix, ".mat"),
    "`.mat`, one vector of 16 bits": Case(one_integer_vector, ".mat"),
    "`.mat`, double precision": Case(doubles, ".mat"),
    "`.mat`, compressed vectors of 16 bits": Case(compressed_integers, ".mat"),
    "`.mat`, frequency responses": Case(responses, ".mat"),
    "`.mat`, compressed structs of zeros": Case(structs, ".mat", sensors=["x"]),
    "`.mat` 7.3, three vectors of 16 bits": Case(hdf5_integers, ".mat", constant=12e6),
    "`.npz`, a matrix of 16 bits": Case(npz, ".npz"),
    "`.npy`, double precision": Case(npy, ".npy"),
    "table in a zip archive": Case(zip_table, ".zip", times=12.0),
    "table in a `.tar.gz`": Case(tgz_table, ".tgz", times=12.0),
    "`.stdata`": Case(stdata, ".stdata", times=8.0),
    "a line without an end": Case(one_line, ".csv", "expected lines of at most 262,144 bytes"),
    "very many columns": Case(wide_header, ".csv", "expected lines of at most 262,144 bytes"),
    "a rate that is no number": Case(bad_rate, ".csv", 'expected a sampling rate, found "1.2.3"'),
    "`.mat`, a struct of very many fields": Case(
        struct_fields, ".mat", "expected at most 1,280,000 bytes of an element"
    ),
    "`.mat`, a compressed sensor of zeros": Case(named_zeros, ".mat", "cannot read the arrays: they have"),
    "`.mat` 7.3, a compressed sensor of zeros": Case(
        hdf5_zeros, ".mat", "cannot read the arrays: they have", constant=12e6
    ),
    "`.mat` 7.3, a part that unpacks to more": Case(
        hdf5_chunk, ".mat", "expected a part of 8,000 bytes, found more", constant=12e6
    ),
    "`.npz`, a compressed sensor of zeros": Case(zipped_zeros, ".npz", "cannot read the arrays: they have"),
    "`.npz`, very many arrays": Case(npz_entries, ".npz", "expected an archive of a few files"),
    "tar, a name of gigabytes": Case(
        long_name, ".tgz", "expected names and attributes of at most 65,536 bytes"
    ),
    "tar, attributes of gigabytes": Case(
        pax, ".tgz", "expected names and attributes of at most 65,536 bytes"
    ),
    "tar, very many empty files": Case(tar_members, ".tgz", "expected an archive of at most 20,000 files"),
    "zip, very many empty files": Case(zip_entries, ".zip", "expected an archive of a few files"),
    "zip, a table of zeros": Case(zip_zeros, ".zip", "when unpacked, found more"),
    "`.stdata`, samples of zeros": Case(stdata_zeros, ".stdata", "when unpacked, found more", constant=30e6),
    "`.stdata`, lists in lists": Case(stdata_nested, ".stdata", "found lists in very many lists"),
    "campaign, a key of very many parts": Case(dotted_key, ".toml", "expected a key of at most 100 parts"),
}
