"""Arrays of numbers in MATLAB files of version 7.3, which are HDF5: read by h5py, an extra."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.signals.arrays import Variable, loaded
from pkmodes.signals.functions import Array, Complex

#: Structs in one another at most.
DEEPEST = 8


@contextmanager
def hdf5_variables(path: Path, source: str) -> Iterator[Sequence[Variable]]:
    """Open a file and return its variables, whose values can be read while it is open.

    Raises
    ------
    MeasurementError
        If h5py is not installed, or the file is damaged.
    """
    try:
        import h5py
    except ImportError:
        what = "expected a MATLAB file of version 7 or older, found version 7.3, which needs h5py"
        remedy = "install it with pip install 'pkmodes[hdf5]', or save the file with save -v7"
        raise MeasurementError(what, source, remedy) from None
    with loaded(lambda: h5py.File(path, "r"), source, "MATLAB") as file:
        yield loaded(lambda: list(_variables(file, "", 0)), source, "MATLAB")


def _variables(group: Any, prefix: str, depth: int) -> Iterator[Variable]:
    """Yield the arrays of a group; those of a struct, which is a group in it, under the names of its fields."""
    for name, item in group.items():
        if name.startswith("#"):  # what MATLAB stores for itself
            continue
        kind = item.attrs.get("MATLAB_class", b"double")
        text = kind.decode() if isinstance(kind, bytes) else str(kind)
        if not hasattr(item, "dtype"):
            if depth < DEEPEST:
                yield from _variables(item, f"{prefix}{name}.", depth + 1)
            continue
        parts = item.dtype.names
        numeric = text not in ("char", "cell", "logical") and (
            item.dtype.kind in "iuf" or parts == ("real", "imag")
        )
        shape = tuple(map(int, item.shape[::-1]))  # MATLAB stores columns one after the other
        what = f"an array of {' x '.join(map(str, shape))} values" if numeric else f"a {text}"
        yield Variable(prefix + name, what, shape if numeric else None, partial(_values, item))


def _values(item: Any) -> Array | Complex:
    values = np.asarray(item[()]).ravel()
    if values.dtype.names:
        return np.asarray(values["real"] + 1j * values["imag"], np.complex128)
    return np.asarray(values, np.float64)
