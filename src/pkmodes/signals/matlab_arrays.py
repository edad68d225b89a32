"""Vectors of numbers in MATLAB files of versions 5 to 7, whose structure is checked.

An element has a tag with its type and size.  A variable is an element with parts: flags, dimensions, name, values,
and imaginary values if it is complex; it may be compressed as a whole ("MAT-File Format", The MathWorks).  SciPy's
reader cannot be used for files that may be damaged: with wrong sizes it reads memory that is not the file's.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from pkmodes.signals.functions import Array, Complex

HEADER = 128
MATRIX, COMPRESSED = 14, 15
#: Types of stored numbers, and classes of variables that are arrays of numbers.
TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
NUMERIC = range(6, 16)
CLASSES = {1: "a cell array", 2: "a struct", 3: "an object", 4: "text", 5: "a sparse matrix"}
COMPLEX = 0x0800
#: Sizes above this are not those of a vector that was measured.
LARGEST = 2_000_000_000


class DamagedError(ValueError):
    """The structure of a file is not that of a MATLAB file."""


class Variable(NamedTuple):
    """A variable: its name, what it is, and its values if it is a vector of numbers."""

    name: str
    what: str
    values: Array | Complex | None


class _Element(NamedTuple):
    type: int
    data: memoryview


def variables(content: bytes) -> Iterator[Variable]:
    """Yield the variables of a MATLAB file.

    Parameters
    ----------
    content : bytes
        The whole file.

    Raises
    ------
    DamagedError
        If its structure is not that of such a file.
    """
    mark = content[HEADER - 2 : HEADER]
    if mark not in (b"IM", b"MI"):
        raise DamagedError("expected the header of a MATLAB file")
    order = "<" if mark == b"IM" else ">"
    for element in _elements(memoryview(content)[HEADER:], order):
        found = element
        if element.type == COMPRESSED:
            (found,) = _only(_unpacked(element.data), order)
        if found.type != MATRIX:
            raise DamagedError(f"expected a variable, found an element of type {found.type}")
        variable = _variable(found.data, order)
        if variable.name:  # what MATLAB stores for itself has none
            yield variable


def _variable(data: memoryview, order: str) -> Variable:
    """Return a variable from its parts."""
    parts = _elements(data, order)
    try:
        flags, dimensions, name = (next(parts) for _ in range(3))
    except StopIteration:
        raise DamagedError("expected the flags, dimensions and name of a variable") from None
    if flags.type != 6 or len(flags.data) != 8 or dimensions.type != 5 or name.type not in (1, 2, 16):
        raise DamagedError("expected the flags, dimensions and name of a variable")
    (bits,) = struct.unpack(f"{order}I", flags.data[:4])
    sizes = np.frombuffer(dimensions.data, f"{order}i4") if len(dimensions.data) % 4 == 0 else np.array([-1])
    text = bytes(name.data).decode("utf-8", "replace")
    kind = bits & 0xFF
    if kind not in NUMERIC:
        return Variable(text, CLASSES.get(kind, "another kind of variable"), None)
    what = f"an array of {' x '.join(map(str, sizes))} values"
    count = int(np.prod(sizes, dtype=np.float64)) if np.all(sizes >= 0) else LARGEST
    values = [_numbers(part, order, count, text) for part in parts]
    if len(values) != (2 if bits & COMPLEX else 1):
        raise DamagedError(f"expected the values of {text}")
    if sizes.size != 2 or sizes.min() != 1:
        return Variable(text, what, None)
    return Variable(text, what, values[0] + 1j * values[1] if bits & COMPLEX else values[0])


def _numbers(part: _Element, order: str, count: int, name: str) -> Array:
    kind = TYPES.get(part.type)
    if kind is None or len(part.data) != count * int(kind[1]):
        raise DamagedError(f"expected {count} values of {name}")
    return np.frombuffer(part.data, f"{order}{kind}").astype(np.float64)


def _elements(data: memoryview, order: str) -> Iterator[_Element]:
    """Yield the elements that fill some data."""
    at = 0
    while at < len(data):
        if at + 8 > len(data):
            raise DamagedError("expected an element, found the end of the file")
        kind, size = struct.unpack(f"{order}II", data[at : at + 8])
        start = at + 8
        if kind >> 16:  # a small element: its type and size in four bytes, its data in the next four
            kind, size, start = kind & 0xFFFF, kind >> 16, at + 4
            if size > 4:
                raise DamagedError(f"expected at most 4 bytes of a small element, found {size}")
        if start + size > len(data):
            raise DamagedError(f"expected {size} bytes of an element, found {len(data) - start}")
        yield _Element(kind, data[start : start + size])
        at = start + size if kind == COMPRESSED else start + (4 if start == at + 4 else -(-size // 8) * 8)


def _only(data: bytes, order: str) -> list[_Element]:
    found = list(_elements(memoryview(data), order))
    if len(found) != 1:
        raise DamagedError(f"expected one variable in a compressed element, found {len(found)}")
    return found


def _unpacked(data: memoryview) -> bytes:
    unpacking = zlib.decompressobj()
    try:
        content = unpacking.decompress(data, LARGEST)
    except zlib.error as error:
        raise DamagedError(f"cannot unpack a compressed variable: {error}") from None
    if not unpacking.eof:
        raise DamagedError("expected the end of a compressed variable")
    return content
