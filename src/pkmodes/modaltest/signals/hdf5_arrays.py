"""Arrays of numbers in MATLAB files of version 7.3, which are HDF5: read by h5py, an extra.

An HDF5 file may refer to itself and to others: links may lead back to their own group, or to another file, and values
may be stored elsewhere.  Only content of the file itself is opened.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.variables import (
    BASE_SIZE,
    MAX_EXPANSION,
    MAX_NAME_LENGTH,
    FileVariable,
    Values,
    collect_variables,
    load_or_refuse,
    refuse_values,
)

#: Maximum depth of nested structs, and maximum number of links that are followed to an object.
MAX_DEPTH, MAX_LINKS = 8, 64
#: Maximum number of bytes in the name of a class.
MAX_CLASS_LENGTH = 64
#: Number of the HDF5 filter that expands each byte to a thousand at most.
DEFLATE = 1
#: The parts of complex numbers, and classes that are not numeric.
COMPLEX_PARTS, NON_NUMERIC = ("real", "imag"), ("char", "cell", "logical", "variable of another type")


@contextmanager
def hdf5_variables(path: Path, source: str) -> Iterator[Sequence[FileVariable]]:
    """Open a file and return its variables, whose values can be read while it is open.

    Raises MeasurementError if h5py is not installed, or the file is damaged.
    """
    try:
        import h5py
    except ImportError:
        problem = "expected a MATLAB file of version 7 or older, found version 7.3, which needs h5py"
        remedy = "install it with pip install 'pkmodes[hdf5]', or save the file with save -v7"
        raise MeasurementError(problem, source, remedy) from None
    limit = BASE_SIZE + MAX_EXPANSION * path.stat().st_size
    with load_or_refuse(lambda: h5py.File(path, "r"), source, "MATLAB") as file:
        yield load_or_refuse(
            lambda: collect_variables(_variables(file, "", limit, {_address(file)})), source, "MATLAB"
        )


def _address(item: Any) -> int:
    """Return the address of an object in the file: several links may lead to it."""
    from h5py import h5o

    return int(h5o.get_info(item.id).addr)


def _variables(group: Any, prefix: str, limit: int, visited: set[int]) -> Iterator[FileVariable]:
    """Yield the arrays of a group; those of a struct, which is a group in it, under the names of its fields.

    - limit: most bytes of a part of an array
    - visited: addresses of the groups already visited; extended here
    """
    from h5py import Dataset, Group

    for name in group:
        if name.startswith("#"):  # variables that MATLAB stores for itself
            continue
        full_name = f"{prefix}{name}"
        if len(full_name) > MAX_NAME_LENGTH:
            raise ValueError(
                f"expected names of at most {MAX_NAME_LENGTH} letters, found one of {len(full_name):,}"
            )
        item = _follow_link(group, name, [MAX_LINKS])
        if isinstance(item, Group):
            address = _address(item)
            if prefix.count(".") < MAX_DEPTH and address not in visited:
                visited.add(address)
                yield from _variables(item, f"{full_name}.", limit, visited)
        elif isinstance(item, Dataset):
            yield _variable(item, full_name, limit)
        else:
            description = "a link that leads to nothing in the file" if item is None else "a type of numbers"
            yield FileVariable(full_name, description, None, partial(refuse_values, full_name))


def _follow_link(group: Any, name: str, remaining_links: list[int]) -> Any:
    """Return the target of a link; None if it has none, or leads to another file.

    - remaining_links: number of links that may still be followed
    """
    from h5py import Group, HardLink, SoftLink

    remaining_links[0] -= 1
    try:
        link = group.get(name, getlink=True)
    except (KeyError, TypeError):  # no such link, or one of a user-defined kind
        return None
    if isinstance(link, HardLink):
        return group[name]
    if not isinstance(link, SoftLink):
        return None
    item = group.file["/"] if link.path.startswith("/") else group
    for part in (part for part in link.path.split("/") if part not in ("", ".")):
        if remaining_links[0] <= 0 or not isinstance(item, Group):
            return None
        item = _follow_link(item, part, remaining_links)
    return item


def _variable(item: Any, name: str, limit: int) -> FileVariable:
    """Return the variable of a dataset."""
    class_name = "double"
    attribute = item.attrs.get_id("MATLAB_class") if "MATLAB_class" in item.attrs else None
    if (
        attribute is not None
        and attribute.shape == ()
        and attribute.dtype.kind in "SO"
        and attribute.dtype.itemsize <= MAX_CLASS_LENGTH
    ):
        text = item.attrs["MATLAB_class"]
        class_name = text.decode("utf-8", "replace") if isinstance(text, bytes) else str(text)
        class_name = class_name[:MAX_CLASS_LENGTH]
    try:
        dtype = item.dtype
    except TypeError:  # a type unknown to NumPy
        class_name, dtype = "variable of another type", np.dtype("V")
    if item.is_virtual or item.external:
        description = "an array whose values are in another file"
        return FileVariable(name, description, None, partial(refuse_values, name))
    # Real numbers, or complex ones as MATLAB stores them.
    parts = [dtype[part] for part in COMPLEX_PARTS] if dtype.names == COMPLEX_PARTS else [dtype]
    if class_name in NON_NUMERIC or item.shape is None or not all(part.kind in "iuf" for part in parts):
        return FileVariable(name, f"a {class_name}", None, partial(refuse_values, name))
    shape = tuple(map(int, item.shape[::-1]))  # MATLAB stores columns one after the other
    description = f"an array of {' x '.join(map(str, shape))} values"
    size = 16 if dtype.names else dtype.itemsize
    return FileVariable(name, description, shape, partial(_values, item, limit), size)


def _values(item: Any, limit: int) -> Values:
    """Return the values of an array, in the type in which they are stored."""
    _check_parts(item, limit)
    if not item.dtype.names:
        return np.asarray(item[()]).ravel()
    values = np.empty(item.shape, np.complex128)
    stored = item[()]
    values.real, values.imag = stored["real"], stored["imag"]
    return values.ravel()


def _check_parts(item: Any, limit: int) -> None:
    """Refuse an array whose parts are larger than an array may be, as stated or when unpacked.

    HDF5 unpacks a part to its end, whatever its size.
    """
    if item.chunks is None:
        return
    size = int(np.prod(item.chunks, dtype=np.float64)) * item.dtype.itemsize
    if size > limit:
        raise ValueError(f"expected parts of at most {limit:,} bytes, found parts of {size:,}")
    pipeline = item.id.get_create_plist()
    filters = [pipeline.get_filter(number)[0] for number in range(pipeline.get_nfilters())]
    if filters.count(DEFLATE) > 1:
        raise ValueError("expected an array that is compressed once, found it compressed again")
    for number in range(item.id.get_num_chunks() if DEFLATE in filters else 0):
        stored = item.id.get_chunk_info(number)
        if stored.size > limit:
            raise ValueError(f"expected a part of at most {limit:,} bytes, found {stored.size:,}")
        _, packed = item.id.read_direct_chunk(stored.chunk_offset)
        try:
            unpacked = b"" if stored.filter_mask else zlib.decompressobj().decompress(packed, size + 1)
        except zlib.error as error:
            raise ValueError(f"cannot unpack a part of an array: {error}") from None
        if len(unpacked) > size:
            raise ValueError(f"expected a part of {size:,} bytes, found more")
