"""The header of dataset 58, eleven lines in fixed columns (https://www.ceas3.uc.edu/sdrluff/files/58.asc)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from pkmodes.core.base.errors import shown
from pkmodes.signals.scanning import Scanner

LINES = 11
DIRECTIONS = {
    one * number: f":{sign}{name}"
    for number, name in enumerate(("X", "Y", "Z", "RX", "RY", "RZ"), start=1)
    for one, sign in ((1, "+"), (-1, "-"))
}
#: Ordinate data types: whether the values are complex, and of double precision.
ORDINATES = {2: (False, False), 4: (False, True), 5: (True, False), 6: (True, True)}
#: Columns in which the fields of a line begin and end.
DOFS = ((0, 5), (20, 30), (41, 51), (51, 55), (66, 76), (76, 80))
FORM = ((0, 10), (10, 20), (20, 30), (30, 43), (43, 56))

T = TypeVar("T")


@dataclass(frozen=True)
class Axis:
    """What a header says of an axis: its specific data type, and the label of its unit."""

    data_type: int
    label: str


@dataclass(frozen=True)
class Header:
    """The header of a dataset 58.

    Attributes
    ----------
    function : int
        Type of the function.
    response, reference : tuple of int
        Node and direction.
    complex, double, even : bool
        Of the values, their precision, and the spacing of the abscissa.
    count : int
        Number of points.
    start, step : float
        Of an even abscissa.
    abscissa, ordinate, denominator : Axis
        Their quantities and units.
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


def read_header(scanner: Scanner, lines: int = LINES) -> Header:
    """Read the header of a dataset 58.

    Parameters
    ----------
    scanner : Scanner
        At the line after the number of the dataset.
    lines : int
        How many the dataset declares.

    Raises
    ------
    MeasurementError
        If a field that is needed is missing or wrong.
    """
    if not LINES <= lines <= 100:
        scanner.refuse(f"expected {LINES} header lines, found {lines} declared")
    header = [scanner.line(f"line {number + 1} of the header") for number in range(lines)]
    function, _, *dofs = _fields(scanner, header[5], "the degrees of freedom", DOFS, int)
    form = _fields(scanner, header[6], "the form of the data", FORM, float, split=True)
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
    axes = [_axis(scanner, line) for line in header[7:10]]
    response, reference = (dofs[0], dofs[1]), (dofs[2], dofs[3])
    return Header(function, response, reference, is_complex, double, spacing == 1, count, start, step, *axes)


def name_of(dof: tuple[int, int]) -> str:
    """Return the name of a degree of freedom: ``12:+X``, or ``12`` without a direction."""
    node, direction = dof
    return f"{node}{DIRECTIONS.get(direction, '')}"


def rotates(dof: tuple[int, int]) -> bool:
    """Return whether a degree of freedom is an angle."""
    return abs(dof[1]) > 3


def _fields(
    scanner: Scanner,
    line: bytes,
    what: str,
    columns: Sequence[tuple[int, int]],
    read: Callable[[str], T],
    split: bool = False,
) -> list[T]:
    """Return the fields in some columns of a line, or between blanks if it is not in columns.

    Letters outside ASCII take one column in some files, and one for each of their bytes in others.
    """
    texts = [line.decode("utf-8", "replace"), line.decode("latin-1")]
    cells = [[text[low:high].replace("D", "E") for low, high in columns] for text in texts]
    if split:
        cells.append(texts[1].replace("D", "E").split()[: len(columns)])
    found: list[T] = []
    for each in cells:
        try:
            found = [read(cell) for cell in each]
        except ValueError:
            continue
        if len(found) == len(columns):
            break
    if len(found) != len(columns):
        scanner.refuse(f"expected {what} in the header, found {shown(texts[1].strip())}")
    return found


def _axis(scanner: Scanner, line: bytes) -> Axis:
    (data_type,) = _fields(scanner, line, "the data type of an axis", ((0, 10),), int)
    try:
        text = line.decode("utf-8")
    except UnicodeDecodeError:
        text = line.decode("latin-1")
    return Axis(data_type, text[47:].strip())
