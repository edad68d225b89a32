"""Dataset 58 of universal files, a function at a degree of freedom, in text or binary.

Its text has even and uneven spacing, real and complex values, single and double precision
(https://www.ceas3.uc.edu/sdrluff/files/58.asc).  The abscissa of binary data with uneven spacing and double precision
is of single precision by the letter of the format, and of double precision in many files: the number of bytes that
the dataset declares decides.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.signals.ascii_numbers import read_numbers
from pkmodes.signals.checks import check_abscissa, check_finite
from pkmodes.signals.functions import Array, Complex
from pkmodes.signals.header58 import Header, read_header
from pkmodes.signals.scanning import INCOMPLETE, Binary, Scanner

#: Points that are converted at once.
CHUNK = 1_000_000


@dataclass(frozen=True)
class Stored:
    """Points of a binary dataset in its file: their place, and their type with the fields ``y`` and perhaps ``x``."""

    path: Path
    offset: int
    count: int
    dtype: np.dtype[Any]
    where: str

    def read(self, part: str) -> Array | Complex:
        """Return the field `part` of all points in double precision.

        Raises
        ------
        MeasurementError
            If the file has changed.
        """
        values: Array | Complex = np.empty(self.count)
        if self.dtype[part].kind == "c":
            values = np.empty(self.count, np.complex128)
        filled = 0
        for chunk in self.chunks(part):
            values[filled : filled + chunk.size] = chunk
            filled += chunk.size
        return values

    def chunks(self, part: str) -> Iterator[NDArray[Any]]:
        """Yield the field `part` of some points after the other, in the precision of the file.

        Raises
        ------
        MeasurementError
            If the file has changed.
        """
        for first in range(0, self.count, CHUNK):
            count, offset = min(CHUNK, self.count - first), self.offset + first * self.dtype.itemsize
            try:
                points = np.fromfile(self.path, self.dtype, count, offset=offset)
            except OSError as error:
                raise MeasurementError(f"cannot read the signals: {error}", self.where, INCOMPLETE) from None
            if points.size < count:
                raise MeasurementError(
                    "expected the file as it was, found it changed", self.where, "read it again"
                )
            yield points[part]


@dataclass(frozen=True)
class Points:
    """The header of a dataset 58 and its data, in memory or in the file.

    Attributes
    ----------
    header : Header
        What the dataset says of its data.
    where : str
        The dataset, for messages.
    abscissa : ndarray or None
        None for an even abscissa.
    values : ndarray or Stored
        float64 or complex128.
    """

    header: Header
    where: str
    abscissa: Array | None
    values: Array | Complex | Stored


def read_points(scanner: Scanner, binary: Binary | None, path: Path) -> Points:
    """Read a dataset 58 to its end, and check all of its numbers.

    Parameters
    ----------
    scanner : Scanner
        At the line after the number of the dataset.
    binary : Binary, optional
        How its data are stored, if not as text.
    path : path
        The file.

    Raises
    ------
    MeasurementError
        If it is not what it declares to be.
    """
    if binary is None:
        return _from_text(scanner)
    header = read_header(scanner, binary.lines)
    point = _type(header, binary, scanner)
    offset = scanner.skip_bytes(header.count * point.itemsize)
    scanner.close()
    stored = Stored(path, offset, header.count, point, f"{scanner.where}, in the data")
    for number, chunk in enumerate(stored.chunks("y")):
        check_finite(chunk, stored.where, number * CHUNK)
    abscissa = None if header.even else np.real(stored.read("x"))
    if abscissa is not None:
        check_abscissa(abscissa, scanner.where)
    return Points(header, scanner.where, abscissa, stored)


def _from_text(scanner: Scanner) -> Points:
    """Read a dataset 58 of text."""
    header = read_header(scanner)
    numbers_each = (0 if header.even else 1) + (2 if header.complex else 1)
    numbers = read_numbers(scanner, header.count * numbers_each)
    check_finite(numbers, f"{scanner.where}, in the data")
    abscissa: Array | None = None
    values = numbers
    if not header.even:
        table = numbers.reshape(header.count, numbers_each)
        abscissa, values = table[:, 0].copy(), table[:, 1:].ravel()
        check_abscissa(abscissa, scanner.where)
    return Points(header, scanner.where, abscissa, values.view(np.complex128) if header.complex else values)


def _type(header: Header, binary: Binary, scanner: Scanner) -> np.dtype[Any]:
    """Return the type of a point, which must fill the bytes that the dataset declares.

    pyuff declares those of one number for each point, whatever a point is.  Such a dataset is as long as its header
    says, which is sound if it is closed there.
    """
    size = 8 if header.double else 4
    values = ("y", f"{binary.order}{f'c{2 * size}' if header.complex else f'f{size}'}")
    types = [np.dtype([values])]
    if not header.even:
        types = [np.dtype([("x", f"{binary.order}f{each}"), values]) for each in (size, 4)]
    fitting = [one for one in types if header.count * one.itemsize == binary.bytes]
    if not fitting and binary.bytes != header.count * size:
        what = f"expected {header.count * types[0].itemsize} bytes for {header.count} points"
        scanner.refuse(f"{what}, found {binary.bytes} declared")
    return (fitting or types)[0]
