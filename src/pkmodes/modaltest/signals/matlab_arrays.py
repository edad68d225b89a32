"""Arrays of numbers in MATLAB files of versions 5 to 7, whose structure is checked; those in structs as well.

An element has a tag with its type and size.  A variable is an element with parts: flags, dimensions, name, values,
and imaginary values if it is complex; it may be compressed as a whole ("MAT-File Format", The MathWorks).  SciPy's
reader cannot be used for files that may be damaged: with wrong sizes it reads memory that is not the file's.

Only the first parts of each array are kept until its values are requested: a few compressed bytes may become
gigabytes.  Data before them in a compressed struct are unpacked again, piece by piece, and discarded.
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
from pkmodes.modaltest.signals.variables import MAX_NAME_LENGTH, MAX_VARIABLES, FileVariable, refuse_values

HEADER_SIZE = 128
MATRIX, COMPRESSED = 14, 15
#: Types of stored numbers, and classes of variables that are arrays of numbers.
TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
NUMERIC_CLASSES = range(6, 16)
STRUCT = 2
CLASSES = {1: "a cell array", STRUCT: "a struct", 3: "an object", 4: "text", 5: "a sparse matrix"}
COMPLEX = 0x0800
#: Bytes of a tag; maximum size in bytes of the dimensions or the name of a variable, and of the field names of a
#: struct.
TAG_SIZE, MAX_PART_SIZE, MAX_FIELD_NAMES_SIZE = 8, MAX_NAME_LENGTH, 64 * MAX_VARIABLES
#: Maximum depth of nested structs.
MAX_DEPTH = 8
#: Bytes unpacked at once.
BLOCK_SIZE = 1 << 16


class DamagedError(ValueError):
    """The structure of a file is not that of a MATLAB file."""


class _StoredBytes:
    """Bytes of a file from an offset.

    - file: open for reading
    - start, size: where they are
    """

    def __init__(self, file: BinaryIO, start: int, size: int) -> None:
        self._file, self._start, self._size, self.position = file, start, size, 0

    def read(self, size: int) -> bytes:
        """Return the next bytes, fewer only at the end."""
        self._file.seek(self._start + self.position)
        content = self._file.read(max(0, min(size, self._size - self.position)))
        self.position += len(content)
        return content

    def skip_to(self, position: int) -> None:
        """Go to a later place."""
        self.position = position


class _UnpackedBytes:
    """The content of compressed bytes of a file, unpacked block by block.

    - file: open for reading
    - start, size: where the compressed bytes are
    """

    def __init__(self, file: BinaryIO, start: int, size: int) -> None:
        self._packed, self._left = _StoredBytes(file, start, size), b""
        self._unpacking, self.position = zlib.decompressobj(), 0

    def read(self, size: int) -> bytes:
        """Return the next bytes, fewer only at the end."""
        content = bytearray()
        while len(content) < size and (part := self._next_block(size - len(content))):
            content += part
        return bytes(content)

    def skip_to(self, position: int) -> None:
        """Go to a later place by unpacking everything before it."""
        while self.position < position and self._next_block(position - self.position):
            pass

    def _next_block(self, limit: int) -> bytes:
        """Return up to `limit` of the next bytes, none at the end."""
        part = b""
        try:
            while not part and not self._unpacking.eof:
                packed = self._left or self._packed.read(BLOCK_SIZE)
                part = self._unpacking.decompress(packed, min(limit, BLOCK_SIZE))
                self._left = self._unpacking.unconsumed_tail
                if not packed and not part:
                    break
        except zlib.error as error:
            raise DamagedError(f"cannot unpack a compressed variable: {error}") from None
        self.position += len(part)
        return part

    def ends_between(self, low: int, high: int) -> bool:
        """Return whether the bytes end at a place between two."""
        self.skip_to(high + 1)
        return low <= self.position <= high and self._unpacking.eof


class _Reader:
    """The state of reading a file: the bytes of one element at a time, as unpacked ones take memory.

    - file: open for reading
    """

    def __init__(self, file: BinaryIO) -> None:
        self.file = file
        self._element: _Element | None = None
        self._data: _StoredBytes | _UnpackedBytes | None = None

    def bytes_from(self, element: _Element, position: int) -> _StoredBytes | _UnpackedBytes:
        """Return the bytes of an element from a place on, continuing from the current one if that is before it."""
        if self._data is None or self._element is not element or self._data.position > position:
            kind = _UnpackedBytes if element.compressed else _StoredBytes
            self._element, self._data = element, kind(self.file, element.start, element.size)
        self._data.skip_to(position)
        return self._data


@dataclass(frozen=True, eq=False)
class _Element:
    """Where the bytes of an element are in the file, and whether they are compressed."""

    reading: _Reader
    start: int
    size: int
    compressed: bool = False

    def data(self, position: int) -> _StoredBytes | _UnpackedBytes:
        """Return its bytes, unpacked, from a place on."""
        return self.reading.bytes_from(self, position)

    def check_end(self, end: int) -> None:
        """Refuse a compressed element that does not end here or after a padding, which not every program writes."""
        data = self.data(end) if self.compressed else None
        if isinstance(data, _UnpackedBytes) and not data.ends_between(end, -(-end // 8) * 8):
            raise DamagedError("expected one whole variable in a compressed element")


class _Tag(NamedTuple):
    """The type of an element, the size of its data, where these begin, and where the next element does."""

    type: int
    size: int
    start: int
    next: int


def read_variables(file: BinaryIO, length: int) -> Iterator[FileVariable]:
    """Yield the variables of a MATLAB file.

    - file: open for reading
    - length: length of the file [bytes]

    Raises DamagedError if its structure is not that of such a file.
    """
    file.seek(0)
    byte_order_mark = file.read(HEADER_SIZE)[HEADER_SIZE - 2 :]
    if byte_order_mark not in (b"IM", b"MI"):
        raise DamagedError("expected the header of a MATLAB file")
    order = "<" if byte_order_mark == b"IM" else ">"
    offset, reading = HEADER_SIZE, _Reader(file)
    while offset < length:
        outer = _read_tag(_Element(reading, offset, length - offset), 0, order, length - offset)
        compressed = outer.type == COMPRESSED
        element = _Element(reading, offset + outer.start, outer.size, compressed)
        inner = _read_tag(element, 0, order) if compressed else outer._replace(start=0)
        if inner.type != MATRIX:
            raise DamagedError(f"expected a variable, found an element of type {inner.type}")
        for variable in _read_variable(element, inner.start, inner.start + inner.size, order):
            if variable.name:  # variables that MATLAB stores for itself have none
                yield variable
        # Compressed elements have no padding.
        offset += outer.start + outer.size if compressed else outer.next


def _read_variable(
    element: _Element, position: int, end: int, order: str, field_name: str = "", depth: int = 0
) -> Iterator[FileVariable]:
    """Yield a variable from its parts between two places, or the fields of a struct.

    - field_name: name of a field in a struct, whose parts have none
    """
    parts = []
    for _ in range(3):
        tag = _read_tag(element, position, order, end)
        parts.append((tag.type, _read_data(element, tag, MAX_PART_SIZE)))
        position = tag.next
    (flags_type, flag_bytes), (dimensions_type, sizes_bytes), (name_type, name_bytes) = parts
    if flags_type != 6 or len(flag_bytes) != 8 or dimensions_type != 5 or name_type not in (1, 2, 16):
        raise DamagedError("expected the flags, dimensions and name of a variable")
    (bits,) = struct.unpack(f"{order}I", flag_bytes[:4])
    sizes = np.frombuffer(sizes_bytes, f"{order}i4") if len(sizes_bytes) % 4 == 0 else np.array([-1])
    text = field_name or name_bytes.decode("utf-8", "replace")
    kind = bits & 0xFF
    if kind == STRUCT and sizes.tolist() == [1, 1] and depth < MAX_DEPTH and text:
        yield from _read_fields(element, position, end, order, text, depth)
        if not depth:
            element.check_end(end)
        return
    if kind not in NUMERIC_CLASSES:
        description = CLASSES.get(kind, "another kind of variable")
        yield FileVariable(text, description, None, partial(refuse_values, text))
        return
    description = f"an array of {' x '.join(map(str, sizes))} values"
    count = float(np.prod(sizes, dtype=np.float64)) if np.all(sizes >= 0) else np.inf
    remaining = end - position
    # Each number has at least one byte, and at most two parts of eight.
    if not count <= remaining <= 16.0 * count + MAX_PART_SIZE:
        raise DamagedError(f"expected the values of {text}")
    is_complex, shape = bool(bits & COMPLEX), tuple(map(int, sizes))
    load = partial(_read_values, element, position, end, order, int(count), is_complex, text, whole=not depth)
    reload = None
    if not element.compressed and not is_complex and count:
        tag = _read_tag(element, position, order, end)
        if (stored := TYPES.get(tag.type, "f8"))[0] in "iu" and tag.size == count * int(stored[1]):
            offset = element.start + tag.start
            reload = partial(_reload, element.reading.file.name, f"{order}{stored}", int(count), offset)
    yield FileVariable(text, description, shape, load, int(remaining // count) if count else 8, reload)


def _read_fields(
    element: _Element, position: int, end: int, order: str, struct_name: str, depth: int
) -> Iterator[FileVariable]:
    """Yield the variables that are the fields of a struct."""
    length = _read_tag(element, position, order, end)
    width_bytes = _read_data(element, length, TAG_SIZE)
    width = int(np.frombuffer(width_bytes, f"{order}i4")[0]) if len(width_bytes) == 4 else 0
    if width > MAX_NAME_LENGTH:
        raise DamagedError(f"expected names of at most {MAX_NAME_LENGTH} bytes, found {width:,}")
    names = _read_tag(element, length.next, order, end)
    text = _read_data(element, names, MAX_FIELD_NAMES_SIZE)
    fields = [
        text[i : i + width].split(b"\0")[0].decode("utf-8", "replace")
        for i in range(0, len(text), max(width, 1))
    ]
    if len(fields) > MAX_VARIABLES:
        raise DamagedError(f"expected at most {MAX_VARIABLES:,} fields of a struct, found {len(fields):,}")
    position = names.next
    for field in fields:
        tag = _read_tag(element, position, order, end)
        if tag.type != MATRIX:
            raise DamagedError("expected the fields of a struct")
        if tag.size:
            yield from _read_variable(
                element, tag.start, tag.start + tag.size, order, f"{struct_name}.{field}", depth + 1
            )
        position = tag.next
    if position < end:
        raise DamagedError("expected the fields of a struct")


def _read_values(
    element: _Element,
    position: int,
    end: int,
    order: str,
    count: int,
    is_complex: bool,
    name: str,
    *,
    whole: bool,
) -> NDArray[Any]:
    """Return the values of a vector, in the type in which they are stored.

    - whole: whether it is all of its element
    """
    tag = _read_tag(element, position, order, end)
    values = _read_numbers(element, tag, order, count, name)
    if is_complex:
        tag = _read_tag(element, tag.next, order, end)
        complex_values = np.empty(count, np.complex128)
        complex_values.real, complex_values.imag = values, _read_numbers(element, tag, order, count, name)
        values = complex_values
    if tag.next < end:
        raise DamagedError(f"expected the values of {name}")
    if whole:
        element.check_end(end)
    return values


def _reload(path: str, dtype: str, count: int, offset: int) -> NDArray[Any]:
    """Return whole numbers that are still in their file."""
    values = np.fromfile(path, dtype, count, offset=offset)
    if values.size < count:
        raise MeasurementError("expected the file as it was, found it changed", path, "read it again")
    return values


def _read_numbers(element: _Element, tag: _Tag, order: str, count: int, name: str) -> NDArray[Any]:
    kind = TYPES.get(tag.type)
    if kind is None or tag.size != count * int(kind[1]):
        raise DamagedError(f"expected {count} values of {name}")
    return np.frombuffer(_read_data(element, tag, tag.size), f"{order}{kind}")


def _read_data(element: _Element, tag: _Tag, limit: int) -> bytes:
    """Return the data of an element, at most `limit` bytes."""
    if tag.size > limit:
        raise DamagedError(f"expected at most {limit:,} bytes of an element, found {tag.size:,}")
    content = element.data(tag.start).read(tag.size)
    if len(content) < tag.size:
        raise DamagedError(f"expected {tag.size} bytes of an element, found {len(content)}")
    return content


def _read_tag(element: _Element, position: int, order: str, end: int | None = None) -> _Tag:
    """Return the tag of an element at a place, which lies within others that end at `end`."""
    data = element.data(position).read(TAG_SIZE)
    if len(data) < TAG_SIZE or (end is not None and position + TAG_SIZE > end):
        raise DamagedError("expected an element, found the end of the file")
    kind, size = struct.unpack(f"{order}II", data)
    if not kind >> 16:
        tag = _Tag(kind, size, position + TAG_SIZE, position + TAG_SIZE + -(-size // 8) * 8)
    elif kind >> 16 > 4:
        raise DamagedError(f"expected at most 4 bytes of a small element, found {kind >> 16}")
    else:  # a small element: its type and size in four bytes, its data in the next four
        tag = _Tag(kind & 0xFFFF, kind >> 16, position + 4, position + TAG_SIZE)
    if end is not None and tag.start + tag.size > end:
        raise DamagedError(f"expected {tag.size} bytes of an element, found {end - tag.start}")
    return tag
