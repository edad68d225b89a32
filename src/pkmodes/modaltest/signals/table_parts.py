"""Long texts, part by part: only the text and its numbers are in memory as a whole."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError

#: Bytes of a part, whose cells take thirty times as much while a pattern is replaced; and of the longest line.
PART, LONGEST_LINE = 1 << 16, 1 << 18
#: Types of whole numbers, the smallest first.
WHOLE = ("i1", "i2", "i4")


def parts_of(text: bytes, start: int = 0) -> Iterator[tuple[int, int]]:
    """Yield the start and end of parts of whole lines; a line longer than a part is a part by itself."""
    while start < len(text):
        end = text.rfind(b"\n", start, start + PART) + 1 if len(text) - start > PART else len(text)
        end = end or text.find(b"\n", start) + 1 or len(text)
        yield start, end
        start = end


def in_parts(text: bytes, change: Callable[[bytes], bytes], start: int = 0, before: bytes = b"") -> bytes:
    """Return a text from an offset, changed part by part, as replacing a pattern takes many times its memory.

    - change: of a part, which has whole lines
    - before: text put before it
    """
    return b"".join([before, *(change(text[low:high]) for low, high in parts_of(text, start))])


def check_lines(text: bytes, source: str) -> None:
    """Refuse a text with a line that is longer than any row of numbers.

    Raises MeasurementError with the number of the line.
    """
    for start, end in parts_of(text):
        if end - start > LONGEST_LINE:
            problem = f"expected lines of at most {LONGEST_LINE:,} bytes, found one of {end - start:,}"
            number = text.count(b"\n", 0, start) + 1
            raise MeasurementError(
                problem, f"{source}: line {number}", "write each sample into a line of its own"
            )


def narrow(values: NDArray[np.float64]) -> NDArray[Any]:
    """Return whole numbers in the smallest type that holds them all, others unchanged.

    A cell of one digit and a separator has two bytes, a number of double precision eight.
    """
    if values.size and np.array_equal(values, np.rint(values)):
        low, high = values.min(), values.max()
        for kind in WHOLE:
            if np.iinfo(kind).min <= low and high <= np.iinfo(kind).max:
                return values.astype(kind)
    return values


def joined_parts(parts: Sequence[NDArray[Any]]) -> NDArray[Any]:
    """Return parts of a column as one array, of the smallest type that holds the numbers of all."""
    return parts[0].copy() if len(parts) == 1 else np.concatenate(parts)
