"""Arrays of numbers in MATLAB files of versions 5 to 7, whose structure is checked; those in structs as well.

An element has a tag with its type and size.  A variable is an element with parts: flags, dimensions, name, values,
and imaginary values if it is complex; it may be compressed as a whole ("MAT-File Format", The MathWorks).  SciPy's
reader cannot be used for files that may be damaged: with wrong sizes it reads memory that is not the file's.

Of each array only the first parts are read, or unpacked, until its values are asked for: a few compressed bytes may
be gigabytes.  A struct is unpacked as a whole.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Iterator
from functools import partial
from typing import BinaryIO, NamedTuple

import numpy as np

from pkmodes.signals.arrays import Variable
from pkmodes.signals.functions import Array, Complex

HEADER = 128
MATRIX, COMPRESSED = 14, 15
#: Types of stored numbers, and classes of variables that are arrays of numbers.
TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
NUMERIC = range(6, 16)
STRUCT = 2
CLASSES = {1: "a cell array", STRUCT: "a struct", 3: "an object", 4: "text", 5: "a sparse matrix"}
COMPLEX = 0x0800
#: Bytes of a tag, and at most of the flags, dimensions and name of a variable.
TAG, HEAD = 8, 1 << 16
#: Bytes of a struct at most, and structs in one another.
LARGEST_STRUCT, DEEPEST = 1 << 28, 8
#: Compressed bytes that are unpacked at once.
BLOCK = 1 << 20


class DamagedError(ValueError):
    """The structure of a file is not that of a MATLAB file."""


class _Element(NamedTuple):
    type: int
    data: memoryview


class _Place(NamedTuple):
    """Where the data of an element are in the file."""

    offset: int
    size: int


def variables(file: BinaryIO, length: int) -> Iterator[Variable]:
    """Yield the variables of a MATLAB file.

    Parameters
    ----------
    file : binary file
        Open for reading.
    length : int
        Of the file [bytes].

    Raises
    ------
    DamagedError
        If its structure is not that of such a file.
    """
    file.seek(0)
    mark = file.read(HEADER)[HEADER - 2 :]
    if mark not in (b"IM", b"MI"):
        raise DamagedError("expected the header of a MATLAB file")
    order = "<" if mark == b"IM" else ">"
    at = HEADER
    while at < length:
        kind, size, start = _tag(_bytes(file, at, min(TAG, length - at)), order, 0)
        start += at
        if start + size > length:
            raise DamagedError(f"expected {size} bytes of an element, found {length - start}")
        place = _Place(start, size)
        if kind == COMPRESSED:
            head = _unpacked(file, place, HEAD + TAG)
            kind, whole, inner = _tag(memoryview(head), order, 0)
            data = partial(_whole, file, place, inner + whole, inner)
            head, size = head[inner : inner + whole], whole
            at = start + place.size  # without padding
        else:
            head = bytearray(_bytes(file, start, min(size, HEAD)))
            data = partial(_bytes, file, start, size)
            at = start + (4 if start == at + 4 else -(-size // 8) * 8)
        if kind != MATRIX:
            raise DamagedError(f"expected a variable, found an element of type {kind}")
        for variable in _variables(head, size, order, data):
            if variable.name:  # what MATLAB stores for itself has none
                yield variable


def _variables(
    head: bytearray | memoryview,
    size: int,
    order: str,
    data: Callable[[], memoryview],
    name_in: str = "",
    depth: int = 0,
) -> Iterator[Variable]:
    """Yield a variable from the beginning of its parts, which have `size` bytes in all, or the fields of a struct.

    Parameters
    ----------
    name_in : str
        Of a field in a struct, whose parts have none.
    """
    parts = _elements(memoryview(head), order)
    try:
        flags, dimensions, name = (next(parts) for _ in range(3))
    except StopIteration:
        raise DamagedError("expected the flags, dimensions and name of a variable") from None
    if flags.type != 6 or len(flags.data) != 8 or dimensions.type != 5 or name.type not in (1, 2, 16):
        raise DamagedError("expected the flags, dimensions and name of a variable")
    (bits,) = struct.unpack(f"{order}I", flags.data[:4])
    sizes = np.frombuffer(dimensions.data, f"{order}i4") if len(dimensions.data) % 4 == 0 else np.array([-1])
    text = name_in or bytes(name.data).decode("utf-8", "replace")
    kind = bits & 0xFF
    if kind == STRUCT and sizes.tolist() == [1, 1] and size <= LARGEST_STRUCT and depth < DEEPEST and text:
        yield from _fields(data(), order, text, depth)
        return
    if kind not in NUMERIC:
        what = CLASSES.get(kind, "another kind of variable")
        yield Variable(text, what, None, partial(_none, text))
        return
    what = f"an array of {' x '.join(map(str, sizes))} values"
    count = float(np.prod(sizes, dtype=np.float64)) if np.all(sizes >= 0) else np.inf
    if not count <= size <= 16.0 * count + len(head):  # a byte for each number at least, two of eight at most
        raise DamagedError(f"expected the values of {text}")
    shape = tuple(map(int, sizes))
    load = partial(_values, data, order, int(count), bool(bits & COMPLEX), text)
    yield Variable(text, what, shape, load)


def _fields(parts: memoryview, order: str, struct_name: str, depth: int) -> Iterator[Variable]:
    """Yield the variables that are the fields of a struct."""
    _, _, _, length, names, *values = _elements(parts, order)
    width = int(np.frombuffer(length.data, f"{order}i4")[0]) if len(length.data) == 4 else 0
    text = bytes(names.data)
    fields = [
        text[i : i + width].split(b"\0")[0].decode("utf-8", "replace")
        for i in range(0, len(text), max(width, 1))
    ]
    if width < 1 or len(fields) != len(values) or any(one.type != MATRIX for one in values):
        raise DamagedError("expected the fields of a struct")
    for field, value in zip(fields, values, strict=True):
        if value.data:
            yield from _variables(
                value.data,
                len(value.data),
                order,
                partial(_same, value.data),
                f"{struct_name}.{field}",
                depth + 1,
            )


def _same(data: memoryview) -> memoryview:
    return data


def _values(
    data: Callable[[], memoryview], order: str, count: int, is_complex: bool, name: str
) -> Array | Complex:
    """Return the values of a vector."""
    parts = list(_elements(data(), order))[3:]
    if len(parts) != (2 if is_complex else 1):
        raise DamagedError(f"expected the values of {name}")
    if not is_complex:
        return _numbers(parts[0], order, count, name)
    values = np.empty(count, np.complex128)
    values.real, values.imag = (_numbers(part, order, count, name) for part in parts)
    return values


def _none(name: str) -> Array:
    raise DamagedError(f"{name} is not a vector of numbers")


def _numbers(part: _Element, order: str, count: int, name: str) -> Array:
    kind = TYPES.get(part.type)
    if kind is None or len(part.data) != count * int(kind[1]):
        raise DamagedError(f"expected {count} values of {name}")
    return np.asarray(np.frombuffer(part.data, f"{order}{kind}"), np.float64)


def _tag(data: memoryview, order: str, at: int) -> tuple[int, int, int]:
    """Return the type of an element, the size of its data and where these begin."""
    if at + TAG > len(data):
        raise DamagedError("expected an element, found the end of the file")
    kind, size = struct.unpack(f"{order}II", data[at : at + TAG])
    if not kind >> 16:
        return kind, size, at + TAG
    # a small element: its type and size in four bytes, its data in the next four
    if kind >> 16 > 4:
        raise DamagedError(f"expected at most 4 bytes of a small element, found {kind >> 16}")
    return kind & 0xFFFF, kind >> 16, at + 4


def _elements(data: memoryview, order: str) -> Iterator[_Element]:
    """Yield the elements that fill some data."""
    at = 0
    while at < len(data):
        kind, size, start = _tag(data, order, at)
        if start + size > len(data):
            raise DamagedError(f"expected {size} bytes of an element, found {len(data) - start}")
        yield _Element(kind, data[start : start + size])
        at = start + (4 if start == at + 4 else -(-size // 8) * 8)


def _bytes(file: BinaryIO, offset: int, size: int) -> memoryview:
    file.seek(offset)
    found = file.read(size)
    if len(found) < size:
        raise DamagedError(f"expected {size} bytes, found {len(found)}")
    return memoryview(found)


def _whole(file: BinaryIO, place: _Place, size: int, start: int) -> memoryview:
    """Return the data of the only element, of `size` bytes with its tag, in a compressed one."""
    padded = start + -(-(size - start) // 8) * 8  # which not every program writes
    content = _unpacked(file, place, padded + 1, end=True)
    if not size <= len(content) <= padded:
        raise DamagedError(f"expected one variable of {size} bytes in a compressed element")
    return memoryview(content)[start:size]


def _unpacked(file: BinaryIO, place: _Place, most: int, *, end: bool = False) -> bytearray:
    """Return the first bytes of a compressed element, at most so many; perhaps to its end."""
    unpacking, content = zlib.decompressobj(), bytearray()
    left, packed = place.size, b""
    file.seek(place.offset)
    try:
        while len(content) < most and not unpacking.eof:
            if not packed:
                packed = file.read(min(left, BLOCK))
                left -= len(packed)
            more = unpacking.decompress(packed, most - len(content))
            if not packed and not more:
                break
            content += more
            packed = unpacking.unconsumed_tail
    except zlib.error as error:
        raise DamagedError(f"cannot unpack a compressed variable: {error}") from None
    if end and not unpacking.eof and len(content) < most:
        raise DamagedError("expected the end of a compressed variable")
    return content
