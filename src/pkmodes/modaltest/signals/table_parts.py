"""Long texts, part by part: only the text and its numbers are in memory as a whole."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError

#: Bytes of a part, whose cells take thirty times as much while a pattern is replaced; and of the longest line.
PART_SIZE, MAX_LINE_LENGTH = 1 << 16, 1 << 18
#: Types of whole numbers, the smallest first.
INTEGER_TYPES = ("i1", "i2", "i4")


def split_parts(text: bytes, start: int = 0) -> Iterator[tuple[int, int]]:
    """Yield the start and end of parts of whole lines; a line longer than a part is a part by itself."""
    while start < len(text):
        end = text.rfind(b"\n", start, start + PART_SIZE) + 1 if len(text) - start > PART_SIZE else len(text)
        end = end or text.find(b"\n", start) + 1 or len(text)
        yield start, end
        start = end


def change_parts(text: bytes, change: Callable[[bytes], bytes], start: int = 0, prefix: bytes = b"") -> bytes:
    """Return a text from an offset, changed part by part, as replacing a pattern takes many times its memory.

    - change: function that changes a part, which has whole lines
    - prefix: text put before it
    """
    return b"".join([prefix, *(change(text[low:high]) for low, high in split_parts(text, start))])


def check_lines(text: bytes, source: str) -> None:
    """Refuse a text with a line that is longer than any row of numbers.

    Raises MeasurementError with the number of the line.
    """
    for start, end in split_parts(text):
        if end - start > MAX_LINE_LENGTH:
            problem = f"expected lines of at most {MAX_LINE_LENGTH:,} bytes, found one of {end - start:,}"
            number = text.count(b"\n", 0, start) + 1
            raise MeasurementError(
                problem, f"{source}: line {number}", "write each sample into a line of its own"
            )


def to_smallest_type(values: NDArray[np.float64]) -> NDArray[Any]:
    """Return whole numbers in the smallest type that holds them all, others unchanged.

    A cell of one digit and a separator has two bytes, a number of double precision eight.
    """
    if values.size and np.array_equal(values, np.rint(values)):
        low, high = values.min(), values.max()
        for kind in INTEGER_TYPES:
            if np.iinfo(kind).min <= low and high <= np.iinfo(kind).max:
                return values.astype(kind)
    return values


def join_parts(parts: Sequence[NDArray[Any]]) -> NDArray[Any]:
    """Return parts of a column as one array, of the smallest type that holds the numbers of all."""
    return parts[0].copy() if len(parts) == 1 else np.concatenate(parts)
