"""Dataset 58 of universal files, a function at a degree of freedom, in text or binary.

Its header has eleven lines in fixed columns.  Its text has even and uneven spacing, real and complex values, single
and double precision (https://www.ceas3.uc.edu/sdrluff/files/58.asc).  The abscissa of binary data with uneven spacing
and double precision is of single precision by the letter of the format, and of double precision in many files: the
number of bytes that the dataset declares decides.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.modaltest.signals.checks import check_abscissa, check_finite
from pkmodes.modaltest.signals.functions import Array, Complex
from pkmodes.modaltest.signals.scanning import INCOMPLETE, BinaryLayout, Scanner, decode_line, read_numbers

#: Minimum number of lines of the header.
MIN_HEADER_LINES = 11
#: Suffixes of the names of degrees of freedom by the number of their direction.
DIRECTIONS = {
    factor * number: f":{sign}{name}"
    for number, name in enumerate(("X", "Y", "Z", "RX", "RY", "RZ"), start=1)
    for factor, sign in ((1, "+"), (-1, "-"))
}
#: Ordinate data types: whether the values are complex, and of double precision.
ORDINATES = {2: (False, False), 4: (False, True), 5: (True, False), 6: (True, True)}
#: Columns in which the fields of a line begin and end.
DOF_COLUMNS = ((0, 5), (20, 30), (41, 51), (51, 55), (66, 76), (76, 80))
FORM_COLUMNS = ((0, 10), (10, 20), (20, 30), (30, 43), (43, 56))
#: Points converted at once.
CHUNK_POINTS = 1_000_000

T = TypeVar("T")


@dataclass(frozen=True)
class Axis:
    """An axis in a header: its specific data type, and the label of its unit."""

    data_type: int
    label: str


@dataclass(frozen=True)
class Header:
    """The header of a dataset 58.

    - function: type of the function
    - response, reference: node and direction
    - complex, double, even: whether the values are complex, in double precision, and at even abscissas
    - count: number of points
    - start, step: start and step of an even abscissa
    - abscissa, ordinate, denominator: their quantities and units
    """

    function: int
    response: tuple[int, int]
    reference: tuple[int, int]
    complex: bool
    double: bool
    even: bool
    count: int
    start: float
    step: float
    abscissa: Axis
    ordinate: Axis
    denominator: Axis


def read_header(scanner: Scanner, lines: int = MIN_HEADER_LINES) -> Header:
    """Read the header of a dataset 58.

    - scanner: at the line after the number of the dataset
    - lines: number that the dataset declares

    Raises MeasurementError if a required field is missing or wrong.
    """
    if not MIN_HEADER_LINES <= lines <= 100:
        scanner.refuse(f"expected {MIN_HEADER_LINES} header lines, found {lines} declared")
    header = [scanner.line(f"line {number + 1} of the header") for number in range(lines)]
    function, _, *dofs = _fields(scanner, header[5], "the degrees of freedom", DOF_COLUMNS, int)
    form = _fields(scanner, header[6], "the form of the data", FORM_COLUMNS, float, split=True)
    ordinate, count, spacing = (int(number) if number.is_integer() else -1 for number in form[:3])
    start, step = form[3:]
    if ordinate not in ORDINATES:
        scanner.refuse(f"expected ordinate data type 2, 4, 5 or 6, found {form[0]:g}")
    if count < 1:
        scanner.refuse(f"expected the number of points, found {form[1]:g}")
    if spacing not in (0, 1):
        scanner.refuse(f"expected abscissa spacing 0 (uneven) or 1 (even), found {form[2]:g}")
    if spacing == 1 and not (math.isfinite(start) and math.isfinite(step) and step > 0.0):
        scanner.refuse(f"expected the increment of the abscissa above 0, found {step:g}")
    for _, direction in (dofs[:2], dofs[2:]):
        if direction and direction not in DIRECTIONS:
            scanner.refuse(f"expected a direction from -6 to 6, found {direction}")
    is_complex, double = ORDINATES[ordinate]
    axes = []
    for line in header[7:10]:
        (data_type,) = _fields(scanner, line, "the data type of an axis", ((0, 10),), int)
        axes.append(Axis(data_type, decode_line(line)[47:].strip()))
    response, reference = (dofs[0], dofs[1]), (dofs[2], dofs[3])
    return Header(function, response, reference, is_complex, double, spacing == 1, count, start, step, *axes)


def dof_name(dof: tuple[int, int]) -> str:
    """Return the name of a degree of freedom: ``12:+X``, or ``12`` without a direction."""
    node, direction = dof
    return f"{node}{DIRECTIONS.get(direction, '')}"


def is_rotation(dof: tuple[int, int]) -> bool:
    """Return whether a degree of freedom is an angle."""
    return abs(dof[1]) > 3


def _fields(
    scanner: Scanner,
    line: bytes,
    subject: str,
    columns: Sequence[tuple[int, int]],
    parse: Callable[[str], T],
    split: bool = False,
) -> list[T]:
    """Return the fields in given columns of a line, or between blanks if it is not in columns.

    A non-ASCII letter takes one column in some files, and one for each of its bytes in others.
    """
    texts = [line.decode("utf-8", "replace"), line.decode("latin-1")]
    cells = [[text[low:high].replace("D", "E") for low, high in columns] for text in texts]
    if split:
        cells.append(texts[1].replace("D", "E").split()[: len(columns)])
    fields: list[T] = []
    for row_cells in cells:
        try:
            fields = [parse(cell) for cell in row_cells]
        except ValueError:
            continue
        if len(fields) == len(columns):
            break
    if len(fields) != len(columns):
        scanner.refuse(f"expected {subject} in the header, found {shown(texts[1].strip())}")
    return fields


@dataclass(frozen=True)
class StoredPoints:
    """Points of a binary dataset in its file: their place, and their type with a field ``y`` and perhaps ``x``."""

    path: Path
    offset: int
    count: int
    dtype: np.dtype[Any]
    where: str

    def read(self, part: str) -> Array | Complex:
        """Return the field `part` of all points in double precision.

        Raises MeasurementError if the file has changed.
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
        """Yield the field `part` of chunks of points, in the precision of the file.

        Raises MeasurementError if the file has changed.
        """
        for first in range(0, self.count, CHUNK_POINTS):
            count, offset = min(CHUNK_POINTS, self.count - first), self.offset + first * self.dtype.itemsize
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

    - header: describes the data
    - where: the dataset, for messages
    - abscissa: None for an even abscissa
    - values: float64 or complex128
    """

    header: Header
    where: str
    abscissa: Array | None
    values: Array | Complex | StoredPoints

    def check_finite(self, points: slice) -> None:
        """Refuse non-finite values in a range of points.

        Raises MeasurementError with the number of the first one.
        """
        chunks = self.values.chunks("y") if isinstance(self.values, StoredPoints) else [self.values]
        start = 0
        for chunk in chunks:
            first = max(points.start - start, 0)
            part = chunk[first : max(points.stop - start, 0)]
            check_finite(part, f"{self.where}, in the data", start + first)
            start += chunk.size


def read_points(scanner: Scanner, binary: BinaryLayout | None, path: Path) -> Points:
    """Read a dataset 58 to its end, and check its structure and abscissa.

    - scanner: at the line after the number of the dataset
    - binary: storage of its data, if not as text
    - path: the file

    Raises MeasurementError if it does not match what it declares.
    """
    if binary is None:
        header = read_header(scanner)
        numbers_per_point = (0 if header.even else 1) + (2 if header.complex else 1)
        values = read_numbers(scanner, header.count * numbers_per_point)
        abscissa: Array | None = None
        if not header.even:
            table = values.reshape(header.count, numbers_per_point)
            abscissa, values = table[:, 0].copy(), table[:, 1:].ravel()
            check_abscissa(abscissa, scanner.where)
        numbers = values.view(np.complex128) if header.complex else values
        return Points(header, scanner.where, abscissa, numbers)
    header = read_header(scanner, binary.lines)
    size = 8 if header.double else 4
    numbers_type = ("y", f"{binary.order}{f'c{2 * size}' if header.complex else f'f{size}'}")
    types = [np.dtype([numbers_type])]
    if not header.even:
        types = [np.dtype([("x", f"{binary.order}f{x_size}"), numbers_type]) for x_size in (size, 4)]
    matching = [candidate for candidate in types if header.count * candidate.itemsize == binary.bytes]
    # pyuff always declares the bytes of one number for each point.  Such a dataset has the length that its header
    # implies, which is valid if it is closed there.
    if not matching and binary.bytes != header.count * size:
        problem = f"expected {header.count * types[0].itemsize} bytes for {header.count} points"
        scanner.refuse(f"{problem}, found {binary.bytes} declared")
    point_type = (matching or types)[0]
    offset = scanner.skip_bytes(header.count * point_type.itemsize)
    scanner.close()
    stored = StoredPoints(path, offset, header.count, point_type, f"{scanner.where}, in the data")
    abscissa = None if header.even else np.real(stored.read("x"))
    if abscissa is not None:
        check_abscissa(abscissa, scanner.where)
    return Points(header, scanner.where, abscissa, stored)
