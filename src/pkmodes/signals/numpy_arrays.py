"""Files of NumPy: ``.npz`` with arrays under their names, ``.npy`` with a single one, which is called ``data``."""

from __future__ import annotations

import zipfile
from collections.abc import Callable
from functools import partial
from os import fspath
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import format as npy

from pkmodes.measured.formats import Format
from pkmodes.signals.arrays import Variable, functions_of, loaded
from pkmodes.signals.functions import Array, Asked, Complex, SignalFile

NPY, NPZ = b"\x93NUMPY", b"PK\x03\x04"
WHAT, DATA = "NumPy", "data"


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
    with loaded(lambda: zipfile.ZipFile(path), source, WHAT) as archive:
        every = loaded(lambda: [_member(archive, name) for name in archive.namelist()], source, WHAT)
        return functions_of(every, source, asked, WHAT)


def _member(archive: zipfile.ZipFile, name: str) -> Variable:
    """Return an array of an archive, of which only the header is read."""
    with archive.open(name) as file:
        version = npy.read_magic(file)
        header = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
        shape, _, dtype = header(file)

    def load() -> Any:
        with archive.open(name) as file:
            return npy.read_array(file, allow_pickle=False)

    return _variable(name.removesuffix(".npy"), shape, dtype, load)


def _variable(name: str, shape: tuple[int, ...], dtype: Any, load: Callable[[], Any]) -> Variable:
    numeric = dtype.kind in "iufc"
    what = f"an array of {' x '.join(map(str, shape))} values" if numeric else str(dtype)
    return Variable(name, what, (shape or (1,)) if numeric else None, partial(_values, load))


def _values(load: Callable[[], Any]) -> Array | Complex:
    flat = np.ravel(load(), order="F")
    if flat.dtype.kind == "c":
        return np.asarray(flat, np.complex128)
    return np.asarray(flat, np.float64)


def recognises(head: bytes) -> bool:
    """Return whether a file is one of NumPy: an archive is one if its first member is an array."""
    return head.startswith(NPY) or (head.startswith(NPZ) and b".npy" in head[:256])


NUMPY = Format("NumPy", (".npy", ".npz"), recognises, read)
