"""MATLAB files: versions 4 to 7 are read here, version 7.3, which is HDF5, with h5py."""

from __future__ import annotations

import struct
from functools import partial
from os import fspath
from pathlib import Path
from typing import Any, BinaryIO

from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.arrays import find_functions
from pkmodes.modaltest.signals.functions import SignalFile, SignalRequest
from pkmodes.modaltest.signals.hdf5_arrays import hdf5_variables
from pkmodes.modaltest.signals.matlab_arrays import DamagedError, read_variables
from pkmodes.modaltest.signals.variables import MAX_VARIABLES, FileVariable, collect_variables, load_or_refuse

HDF5 = b"\x89HDF\r\n\x1a\n"
#: Non-numeric classes of variables in version 4, in words.
NON_NUMERIC = {"char": "text", "sparse": "a sparse matrix"}
#: Variables of version 4: bytes of the header; upper bound of the type; and bytes of a value by the tens of the type.
HEADER_SIZE_4, TYPE_LIMIT_4, VALUE_SIZES_4 = 20, 10_000, {0: 8, 1: 4, 2: 4, 3: 2, 4: 2, 5: 1}
FILE_KIND = "MATLAB"


def read_matlab(path: Path, request: SignalRequest) -> SignalFile:
    """Read a MATLAB file.

    Raises MeasurementError if it is damaged, its arrays do not belong together, or it is of version 7.3 and h5py is
    not installed.
    """
    source = fspath(path)
    with path.open("rb") as file:
        head = file.read(1024)
    if HDF5 in head or head.startswith(b"MATLAB 7.3"):
        with hdf5_variables(path, source) as variables:
            return find_functions(variables, source, request, FILE_KIND, path.stat().st_size)
    length = path.stat().st_size
    with path.open("rb") as file:
        if b"\0" in head[:4]:  # version 4 has no text at its beginning
            variables = load_or_refuse(lambda: _variables_of_version_4(file, path), source, FILE_KIND)
        else:
            variables = load_or_refuse(
                lambda: collect_variables(read_variables(file, length)), source, FILE_KIND
            )
        return find_functions(variables, source, request, FILE_KIND, length)


def _variables_of_version_4(file: BinaryIO, path: Path) -> list[FileVariable]:
    """Return the variables of a file of version 4, which has matrices only."""
    from scipy.io import loadmat, whosmat

    _check_sizes(file, path.stat().st_size)

    def values(name: str) -> Any:
        return loadmat(path, appendmat=False, variable_names=[name])[name].ravel(order="F")

    matrices = []
    for name, shape, class_name in whosmat(path, appendmat=False):
        numeric = class_name not in NON_NUMERIC
        description = (
            f"an array of {' x '.join(map(str, shape))} values" if numeric else NON_NUMERIC[class_name]
        )
        matrices.append(
            FileVariable(name, description, tuple(shape) if numeric else None, partial(values, name))
        )
    return matrices


def _check_sizes(file: BinaryIO, length: int) -> None:
    """Refuse a file of version 4 that ends before its variables: SciPy would allocate the sizes that they state."""
    offset, count = 0, 0
    while offset < length:
        count += 1
        if count > MAX_VARIABLES:
            raise DamagedError(f"expected at most {MAX_VARIABLES:,} variables, found more")
        file.seek(offset)
        head = file.read(HEADER_SIZE_4)
        order = "<" if int.from_bytes(head[:4], "little") < TYPE_LIMIT_4 else ">"
        if len(head) < HEADER_SIZE_4:
            raise DamagedError("expected the header of a variable")
        kind, rows, columns, is_complex, name = struct.unpack(f"{order}5i", head)
        bytes_per_value = VALUE_SIZES_4.get(kind // 10 % 10)
        if not 0 <= kind < TYPE_LIMIT_4 or bytes_per_value is None or min(rows, columns, name) < 0:
            raise DamagedError("expected the header of a variable")
        offset += HEADER_SIZE_4 + name + rows * columns * bytes_per_value * (2 if is_complex else 1)
        if offset > length:
            raise DamagedError(f"expected a variable of {rows} x {columns} values, found the end of the file")


def is_matlab(head: bytes) -> bool:
    """Return whether a file is a MATLAB file of version 5 or later."""
    return head.startswith((b"MATLAB 5.0 MAT-file", b"MATLAB 7.3 MAT-file", HDF5))


MATLAB = Format("MATLAB", (".mat",), is_matlab, read_matlab)
