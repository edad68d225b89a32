"""Files of NumPy: ``.npz`` with arrays under their names, ``.npy`` with a single one, which is called ``data``.

Fields of structured arrays go by their own names.
"""

from __future__ import annotations

import io
import math
import zipfile
from collections.abc import Callable, Iterator
from functools import partial, reduce
from operator import getitem
from os import fspath
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import format as npy

from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.arrays import find_functions
from pkmodes.modaltest.signals.functions import SignalFile, SignalRequest
from pkmodes.modaltest.signals.variables import FileVariable, collect_variables, load_or_refuse
from pkmodes.modaltest.signals.zip_files import open_zip

NPY, NPZ = b"\x93NUMPY", b"PK\x03\x04"
FILE_KIND, SINGLE_ARRAY = "NumPy", "data"
#: Bytes at the beginning of an array, in which its header is.
HEADER_SIZE = 1 << 14
#: Maximum size in bytes of an array with fields, which is read as a whole.
MAX_FIELDS_SIZE = 2_000_000_000


def read_numpy(path: Path, request: SignalRequest) -> SignalFile:
    """Read a file of NumPy.

    Raises MeasurementError if it is damaged, has objects, or its arrays do not belong together.
    """
    source = fspath(path)
    with path.open("rb") as file:
        single = file.read(len(NPY)) == NPY
    if single:
        array: Any = load_or_refuse(
            lambda: np.load(path, mmap_mode="r", allow_pickle=False), source, FILE_KIND
        )
        variables = []
        for field, kind in _fields(array.dtype):
            part: Any = reduce(getitem, field, array)
            variables.append(
                _variable(".".join(field) or SINGLE_ARRAY, part.shape, kind.base, partial(np.asarray, part))
            )
        return find_functions(variables, source, request, FILE_KIND)
    with load_or_refuse(lambda: open_zip(path), source, FILE_KIND) as archive:
        names = archive.namelist()
        variables = load_or_refuse(
            lambda: collect_variables(
                variable for name in names for variable in _member_variables(archive, name)
            ),
            source,
            FILE_KIND,
        )
        return find_functions(variables, source, request, FILE_KIND, path.stat().st_size)


def _member_variables(archive: zipfile.ZipFile, name: str) -> list[FileVariable]:
    """Return an array of an archive, or those that are its fields; only its header is read."""
    with archive.open(name) as file:
        beginning = io.BytesIO(file.read(HEADER_SIZE))
    version = npy.read_magic(beginning)
    header = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
    shape, _, dtype = header(beginning)

    def load(field: tuple[str, ...]) -> Any:
        if math.prod(shape) * dtype.itemsize > MAX_FIELDS_SIZE:
            raise ValueError(f"the array {name} has more than {MAX_FIELDS_SIZE / 1e9:g} GB")
        with archive.open(name) as file:
            array: Any = npy.read_array(file, allow_pickle=False)
        return reduce(getitem, field, array)

    return [
        _variable(
            ".".join([name.removesuffix(".npy"), *field]),
            (*shape, *kind.shape),
            kind.base,
            partial(load, field),
        )
        for field, kind in _fields(dtype)
    ]


def _fields(dtype: np.dtype[Any]) -> Iterator[tuple[tuple[str, ...], np.dtype[Any]]]:
    """Yield the fields of a type, by their nested names, and their types; the type itself if it has none."""
    if dtype.names is None:
        yield (), dtype
    for name in dtype.names or ():
        for inner, kind in _fields(dtype[name]):
            yield (name, *inner), kind


def _variable(name: str, shape: tuple[int, ...], dtype: Any, load: Callable[[], Any]) -> FileVariable:
    numeric = dtype.kind in "iufc"
    description = f"an array of {' x '.join(map(str, shape))} values" if numeric else str(dtype)
    return FileVariable(
        name,
        description,
        (shape or (1,)) if numeric else None,
        lambda: np.ravel(load(), order="F"),
        dtype.itemsize,
    )


def is_numpy(head: bytes) -> bool:
    """Return whether a file is a NumPy file: an archive is one if its first member is an array."""
    return head.startswith(NPY) or (head.startswith(NPZ) and b".npy" in head[:256])


NUMPY = Format("NumPy", (".npy", ".npz"), is_numpy, read_numpy)
