"""MATLAB files: versions 4 to 7 are read here, version 7.3, which is HDF5, with h5py."""

from __future__ import annotations

from functools import partial
from os import fspath
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from pkmodes.measured.formats import Format
from pkmodes.signals.arrays import Variable, functions_of, loaded
from pkmodes.signals.functions import Array, Asked, Complex, SignalFile
from pkmodes.signals.hdf5_arrays import hdf5_variables
from pkmodes.signals.matlab_arrays import variables

HDF5 = b"\x89HDF\r\n\x1a\n"
#: Classes of variables of version 4 that are not arrays of numbers, in words.
TEXTS = {"char": "text", "sparse": "a sparse matrix"}
WHAT = "MATLAB"


def read(path: Path, asked: Asked) -> SignalFile:
    """Read a MATLAB file.

    Raises
    ------
    MeasurementError
        If it is damaged, its arrays do not belong together, or it is of version 7.3 and h5py is not installed.
    """
    source = fspath(path)
    with path.open("rb") as file:
        head = file.read(1024)
    if HDF5 in head or head.startswith(b"MATLAB 7.3"):
        with hdf5_variables(path, source) as found:
            return functions_of(found, source, asked, WHAT)
    with path.open("rb") as file:
        return functions_of(_variables(file, path, head, source), source, asked, WHAT)


def _variables(file: BinaryIO, path: Path, head: bytes, source: str) -> list[Variable]:
    """Return all variables of a file; their values are read later."""
    if b"\0" in head[:4]:  # version 4 has no text at its beginning
        return loaded(lambda: _of_version_4(path), source, WHAT)
    return loaded(lambda: list(variables(file, path.stat().st_size)), source, WHAT)


def _of_version_4(path: Path) -> list[Variable]:
    """Return the variables of a file of version 4, which has matrices only."""
    from scipy.io import loadmat, whosmat

    def values(name: str) -> Array | Complex:
        found: Any = loadmat(path, appendmat=False, variable_names=[name])[name].ravel(order="F")
        if found.dtype.kind == "c":
            return np.asarray(found, np.complex128)
        return np.asarray(found, np.float64)

    found = []
    for name, shape, of in whosmat(path, appendmat=False):
        numeric = of not in TEXTS
        what = f"an array of {' x '.join(map(str, shape))} values" if numeric else TEXTS[of]
        found.append(Variable(name, what, tuple(shape) if numeric else None, partial(values, name)))
    return found


def recognises(head: bytes) -> bool:
    """Return whether a file is one of MATLAB from version 5 on."""
    return head.startswith((b"MATLAB 5.0 MAT-file", b"MATLAB 7.3 MAT-file", HDF5))


MATLAB = Format("MATLAB", (".mat",), recognises, read)
