"""Numbers in the text of universal files, which Fortran may have written without blanks between them."""

from __future__ import annotations

import re
import warnings

import numpy as np

from pkmodes.core.base.errors import shown
from pkmodes.signals.functions import Array
from pkmodes.signals.scanning import Scanner, is_delimiter, text_of

#: A number; Fortran leaves out the E of an exponent with three digits, and writes D for double precision.
NUMBER = re.compile(rb"[+-]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][+-]?\d+|[+-]\d{3}(?![\d.]))?")
EXPONENT = re.compile(rb"(?<=[\d.])[Dd](?=[+-]?\d)|(?<=[\d.])(?=[+-]\d{3}$)")
#: Lines that are converted at once.
CHUNK = 20_000


def numbers_in(text: bytes) -> Array | None:
    """Return the numbers in some text, None if it contains anything else.

    Parameters
    ----------
    text : bytes
        Numbers, with blanks between them or in columns that touch.
    """
    if text.translate(None, b"0123456789+-.eEdD \t\r\n"):  # also keeps out "nan" and "inf"
        return None
    if not text.strip():
        return np.empty(0)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter(
                "error", DeprecationWarning
            )  # what NumPy before 2.3 does instead of an error
            return np.fromstring(text, sep=" ")
    except (ValueError, DeprecationWarning):
        pass
    if NUMBER.sub(b"", text).strip():
        return None
    return np.array([float(EXPONENT.sub(b"E", number)) for number in NUMBER.findall(text)])


def read_numbers(scanner: Scanner, count: int) -> Array:
    """Read numbers, and the line that closes their dataset.

    Parameters
    ----------
    scanner : Scanner
        At the first line of the numbers.
    count : int
        How many the dataset declares.

    Returns
    -------
    ndarray, shape (count,)

    Raises
    ------
    MeasurementError
        If there are more or fewer, or anything else is between them, or the dataset is not closed.
    """
    # Checked before the memory is taken: a damaged header may declare any number.
    if 2 * count > scanner.left:
        scanner.refuse(f"expected {count} values, found {scanner.left} bytes to the end of the file")
    values, filled, closed = np.empty(count), 0, False
    while not closed:
        lines: list[bytes] = []
        while len(lines) < CHUNK and not closed:
            line = scanner.line("more values, or a line -1 that closes the dataset")
            closed = is_delimiter(line)
            if not closed:
                lines.append(line)
        numbers = numbers_in(b"".join(lines))
        if numbers is None:
            bad = next((line for line in lines if numbers_in(line) is None), lines[0])
            scanner.refuse(f"expected numbers, found {shown(text_of(bad).strip())}")
        if filled + numbers.size > count:
            scanner.refuse(f"expected {count} values as declared, found more")
        values[filled : filled + numbers.size] = numbers
        filled += numbers.size
    if filled < count:
        scanner.refuse(f"expected {count} values as declared, found {filled}")
    return values
