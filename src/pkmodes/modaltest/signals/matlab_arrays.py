"""Arrays of numbers in MATLAB files of versions 5 to 7, whose structure is checked; those in structs as well.

An element has a tag with its type and size.  A variable is an element with parts: flags, dimensions, name, values,
and imaginary values if it is complex; it may be compressed as a whole ("MAT-File Format", The MathWorks).  SciPy's
reader cannot be used for files that may be damaged: with wrong sizes it reads memory that is not the file's.

Only the first parts of each array are kept until its values are requested: a few compressed bytes may become
gigabytes.  What precedes them in a compressed struct is unpacked again, piece by piece, and discarded.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.variables import LONGEST_NAME, MOST_VARIABLES, FileVariable, no_numbers

HEADER = 128
MATRIX, COMPRESSED = 14, 15
#: Types of stored numbers, and classes of variables that are arrays of numbers.
TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
NUMERIC = range(6, 16)
STRUCT = 2
CLASSES = {1: "a cell array", STRUCT: "a struct", 3: "an object", 4: "text", 5: "a sparse matrix"}
COMPLEX = 0x0800
#: Bytes of a tag; and most bytes of the dimensions or name of a variable, and of the field names of a struct.
TAG, HEAD, NAMES = 8, LONGEST_NAME, 64 * MOST_VARIABLES
#: Deepest nesting of structs.
DEEPEST = 8
#: Bytes unpacked at once.
BLOCK = 1 << 16


class DamagedError(ValueError):
    """The structure of a file is not that of a MATLAB file."""


class _Stored:
    """Bytes of a file from an offset.

    - file: open for reading
    - start, size: where they are
    """

    def __init__(self, file: BinaryIO, start: int, size: int) -> None:
        self._file, self._start, self._size, self.at = file, start, size, 0

    def read(self, size: int) -> bytes:
        """Return the next bytes, fewer only at the end."""
        self._file.seek(self._start + self.at)
        content = self._file.read(max(0, min(size, self._size - self.at)))
        self.at += len(content)
        return content

    def skip_to(self, at: int) -> None:
        """Go to a later place."""
        self.at = at


class _Unpacked:
    """What compressed bytes of a file unpack to, block by block.

    - file: open for reading
    - start, size: where the compressed bytes are
    """

    def __init__(self, file: BinaryIO, start: int, size: int) -> None:
        self._packed, self._left = _Stored(file, start, size), b""
        self._unpacking, self.at = zlib.decompressobj(), 0

    def read(self, size: int) -> bytes:
        """Return the next bytes, fewer only at the end."""
        content = bytearray()
        while len(content) < size and (part := self._more(size - len(content))):
            content += part
        return bytes(content)

    def skip_to(self, at: int) -> None:
        """Go to a later place by unpacking everything before it."""
        while self.at < at and self._more(at - self.at):
            pass

    def _more(self, limit: int) -> bytes:
        """Return up to `limit` of the next bytes, none at the end."""
        part = b""
        try:
            while not part and not self._unpacking.eof:
                packed = self._left or self._packed.read(BLOCK)
                part = self._unpacking.decompress(packed, min(limit, BLOCK))
                self._left = self._unpacking.unconsumed_tail
                if not packed and not part:
                    break
        except zlib.error as error:
            raise DamagedError(f"cannot unpack a compressed variable: {error}") from None
        self.at += len(part)
        return part

    def ends(self, least: int, highest: int) -> bool:
        """Return whether the bytes end at a place between two."""
        self.skip_to(highest + 1)
        return least <= self.at <= highest and self._unpacking.eof


class _Reading:
    """The state of reading a file: the bytes of one element at a time, as unpacked ones take memory.

    - file: open for reading
    """

    def __init__(self, file: BinaryIO) -> None:
        self.file = file
        self._element: _Element | None = None
        self._data: _Stored | _Unpacked | None = None

    def from_place(self, element: _Element, at: int) -> _Stored | _Unpacked:
        """Return the bytes of an element from a place on, continuing from the current one if that is before it."""
        if self._data is None or self._element is not element or self._data.at > at:
            kind = _Unpacked if element.compressed else _Stored
            self._element, self._data = element, kind(self.file, element.start, element.size)
        self._data.skip_to(at)
        return self._data


@dataclass(frozen=True, eq=False)
class _Element:
    """Where the bytes of an element are in the file, and whether they are compressed."""

    reading: _Reading
    start: int
    size: int
    compressed: bool = False

    def data(self, at: int) -> _Stored | _Unpacked:
        """Return its bytes, unpacked, from a place on."""
        return self.reading.from_place(self, at)

    def check_end(self, end: int) -> None:
        """Refuse a compressed element that does not end here or after a padding, which not every program writes."""
        data = self.data(end) if self.compressed else None
        if isinstance(data, _Unpacked) and not data.ends(end, -(-end // 8) * 8):
            raise DamagedError("expected one whole variable in a compressed element")


class _Tag(NamedTuple):
    """The type of an element, the size of its data, where these begin, and where the next element does."""

    type: int
    size: int
    start: int
    next: int


def variables(file: BinaryIO, length: int) -> Iterator[FileVariable]:
    """Yield the variables of a MATLAB file.

    - file: open for reading
    - length: of the file [bytes]

    Raises DamagedError if its structure is not that of such a file.
    """
    file.seek(0)
    mark = file.read(HEADER)[HEADER - 2 :]
    if mark not in (b"IM", b"MI"):
        raise DamagedError("expected the header of a MATLAB file")
    order = "<" if mark == b"IM" else ">"
    at, reading = HEADER, _Reading(file)
    while at < length:
        outer = _tag(_Element(reading, at, length - at), 0, order, length - at)
        compressed = outer.type == COMPRESSED
        element = _Element(reading, at + outer.start, outer.size, compressed)
        inner = _tag(element, 0, order) if compressed else outer._replace(start=0)
        if inner.type != MATRIX:
            raise DamagedError(f"expected a variable, found an element of type {inner.type}")
        for variable in _variables(element, inner.start, inner.start + inner.size, order):
            if variable.name:  # what MATLAB stores for itself has none
                yield variable
        at += outer.start + outer.size if compressed else outer.next  # compressed elements have no padding


def _variables(
    element: _Element, at: int, end: int, order: str, name_in: str = "", depth: int = 0
) -> Iterator[FileVariable]:
    """Yield a variable from its parts between two places, or the fields of a struct.

    - name_in: of a field in a struct, whose parts have none
    """
    parts = []
    for _ in range(3):
        tag = _tag(element, at, order, end)
        parts.append((tag.type, _part(element, tag, HEAD)))
        at = tag.next
    (of_flags, flag_bytes), (of_dimensions, sizes_bytes), (of_name, name_bytes) = parts
    if of_flags != 6 or len(flag_bytes) != 8 or of_dimensions != 5 or of_name not in (1, 2, 16):
        raise DamagedError("expected the flags, dimensions and name of a variable")
    (bits,) = struct.unpack(f"{order}I", flag_bytes[:4])
    sizes = np.frombuffer(sizes_bytes, f"{order}i4") if len(sizes_bytes) % 4 == 0 else np.array([-1])
    text = name_in or name_bytes.decode("utf-8", "replace")
    kind = bits & 0xFF
    if kind == STRUCT and sizes.tolist() == [1, 1] and depth < DEEPEST and text:
        yield from _fields(element, at, end, order, text, depth)
        if not depth:
            element.check_end(end)
        return
    if kind not in NUMERIC:
        description = CLASSES.get(kind, "another kind of variable")
        yield FileVariable(text, description, None, partial(no_numbers, text))
        return
    description = f"an array of {' x '.join(map(str, sizes))} values"
    count = float(np.prod(sizes, dtype=np.float64)) if np.all(sizes >= 0) else np.inf
    remaining = end - at
    if not count <= remaining <= 16.0 * count + HEAD:  # a byte for each number at least, two of eight at most
        raise DamagedError(f"expected the values of {text}")
    is_complex, shape = bool(bits & COMPLEX), tuple(map(int, sizes))
    load = partial(_values, element, at, end, order, int(count), is_complex, text, whole=not depth)
    again = None
    if not element.compressed and not is_complex and count:
        tag = _tag(element, at, order, end)
        if (stored := TYPES.get(tag.type, "f8"))[0] in "iu" and tag.size == count * int(stored[1]):
            place = element.start + tag.start
            again = partial(_again, element.reading.file.name, f"{order}{stored}", int(count), place)
    yield FileVariable(text, description, shape, load, int(remaining // count) if count else 8, again)


def _fields(
    element: _Element, at: int, end: int, order: str, struct_name: str, depth: int
) -> Iterator[FileVariable]:
    """Yield the variables that are the fields of a struct."""
    length = _tag(element, at, order, end)
    width_bytes = _part(element, length, TAG)
    width = int(np.frombuffer(width_bytes, f"{order}i4")[0]) if len(width_bytes) == 4 else 0
    if width > LONGEST_NAME:
        raise DamagedError(f"expected names of at most {LONGEST_NAME} bytes, found {width:,}")
    names = _tag(element, length.next, order, end)
    text = _part(element, names, NAMES)
    fields = [
        text[i : i + width].split(b"\0")[0].decode("utf-8", "replace")
        for i in range(0, len(text), max(width, 1))
    ]
    if len(fields) > MOST_VARIABLES:
        raise DamagedError(f"expected at most {MOST_VARIABLES:,} fields of a struct, found {len(fields):,}")
    at = names.next
    for field in fields:
        tag = _tag(element, at, order, end)
        if tag.type != MATRIX:
            raise DamagedError("expected the fields of a struct")
        if tag.size:
            yield from _variables(
                element, tag.start, tag.start + tag.size, order, f"{struct_name}.{field}", depth + 1
            )
        at = tag.next
    if at < end:
        raise DamagedError("expected the fields of a struct")


def _values(
    element: _Element, at: int, end: int, order: str, count: int, is_complex: bool, name: str, *, whole: bool
) -> NDArray[Any]:
    """Return the values of a vector, in the type in which they are stored.

    - whole: whether it is all of its element
    """
    last = _tag(element, at, order, end)
    values = _numbers(element, last, order, count, name)
    if is_complex:
        last = _tag(element, last.next, order, end)
        both = np.empty(count, np.complex128)
        both.real, both.imag = values, _numbers(element, last, order, count, name)
        values = both
    if last.next < end:
        raise DamagedError(f"expected the values of {name}")
    if whole:
        element.check_end(end)
    return values


def _again(path: str, dtype: str, count: int, offset: int) -> NDArray[Any]:
    """Return whole numbers that are still in their file."""
    values = np.fromfile(path, dtype, count, offset=offset)
    if values.size < count:
        raise MeasurementError("expected the file as it was, found it changed", path, "read it again")
    return values


def _numbers(element: _Element, tag: _Tag, order: str, count: int, name: str) -> NDArray[Any]:
    kind = TYPES.get(tag.type)
    if kind is None or tag.size != count * int(kind[1]):
        raise DamagedError(f"expected {count} values of {name}")
    return np.frombuffer(_part(element, tag, tag.size), f"{order}{kind}")


def _part(element: _Element, tag: _Tag, limit: int) -> bytes:
    """Return the data of an element, at most `limit` bytes."""
    if tag.size > limit:
        raise DamagedError(f"expected at most {limit:,} bytes of an element, found {tag.size:,}")
    content = element.data(tag.start).read(tag.size)
    if len(content) < tag.size:
        raise DamagedError(f"expected {tag.size} bytes of an element, found {len(content)}")
    return content


def _tag(element: _Element, at: int, order: str, end: int | None = None) -> _Tag:
    """Return the tag of an element at a place, which lies within others that end at `end`."""
    data = element.data(at).read(TAG)
    if len(data) < TAG or (end is not None and at + TAG > end):
        raise DamagedError("expected an element, found the end of the file")
    kind, size = struct.unpack(f"{order}II", data)
    if not kind >> 16:
        tag = _Tag(kind, size, at + TAG, at + TAG + -(-size // 8) * 8)
    elif kind >> 16 > 4:
        raise DamagedError(f"expected at most 4 bytes of a small element, found {kind >> 16}")
    else:  # a small element: its type and size in four bytes, its data in the next four
        tag = _Tag(kind & 0xFFFF, kind >> 16, at + 4, at + TAG)
    if end is not None and tag.start + tag.size > end:
        raise DamagedError(f"expected {tag.size} bytes of an element, found {end - tag.start}")
    return tag
