"""Files of NumPy: ``.npz`` with arrays under their names, ``.npy`` with a single one, which is called ``data``."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable
from functools import partial
from os import fspath
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import format as npy

from pkmodes.measured.formats import Format
from pkmodes.signals.arrays import Variable, at_most, functions_of, loaded
from pkmodes.signals.functions import Asked, SignalFile
from pkmodes.signals.zip_files import opened_zip

NPY, NPZ = b"\x93NUMPY", b"PK\x03\x04"
WHAT, DATA = "NumPy", "data"
#: Bytes at the beginning of an array, in which its header is.
HEADER = 1 << 14


def read(path: Path, asked: Asked) -> SignalFile:
    """Read a file of NumPy.

    Raises
    ------
    MeasurementError
        If it is damaged, has objects, or its arrays do not belong together.
    """
    source = fspath(path)
    with path.open("rb") as file:
        single = file.read(len(NPY)) == NPY
    if single:
        found: Any = loaded(lambda: np.load(path, mmap_mode="r", allow_pickle=False), source, WHAT)
        fields = found.dtype.names
        arrays = {name: found[name] for name in fields} if fields else {DATA: found}
        every = [
            _variable(name, one.shape, one.dtype, partial(np.asarray, one)) for name, one in arrays.items()
        ]
        return functions_of(every, source, asked, WHAT)
    with loaded(lambda: opened_zip(path), source, WHAT) as archive:
        names = archive.namelist()
        every = loaded(lambda: at_most(_member(archive, name) for name in names), source, WHAT)
        return functions_of(every, source, asked, WHAT, path.stat().st_size)


def _member(archive: zipfile.ZipFile, name: str) -> Variable:
    """Return an array of an archive, of which only the header is read."""
    with archive.open(name) as file:
        beginning = io.BytesIO(file.read(HEADER))
    version = npy.read_magic(beginning)
    header = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
    shape, _, dtype = header(beginning)

    def load() -> Any:
        with archive.open(name) as file:
            return npy.read_array(file, allow_pickle=False)

    return _variable(name.removesuffix(".npy"), shape, dtype, load)


def _variable(name: str, shape: tuple[int, ...], dtype: Any, load: Callable[[], Any]) -> Variable:
    numeric = dtype.kind in "iufc"
    what = f"an array of {' x '.join(map(str, shape))} values" if numeric else str(dtype)
    return Variable(name, what, (shape or (1,)) if numeric else None, partial(_values, load), dtype.itemsize)


def _values(load: Callable[[], Any]) -> Any:
    return np.ravel(load(), order="F")


def recognises(head: bytes) -> bool:
    """Return whether a file is one of NumPy: an archive is one if its first member is an array."""
    return head.startswith(NPY) or (head.startswith(NPZ) and b".npy" in head[:256])


NUMPY = Format("NumPy", (".npy", ".npz"), recognises, read)
