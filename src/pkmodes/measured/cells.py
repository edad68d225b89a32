"""The cells of a line of CSV, and the numbers in them."""

from __future__ import annotations

import csv
import math
import re
from decimal import Decimal

from pkmodes.base.errors import MeasurementError

# Stricter than float(): no "nan", no "1_000", no digits of other scripts.
NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")


def cells_of(line: str, where: str) -> list[str]:
    """Split one line into cells; cells that span lines are not supported, since they are usually unclosed quotes.

    Raises
    ------
    MeasurementError
        If it is not CSV.
    """
    try:
        (cells,) = csv.reader([line], strict=True, skipinitialspace=True)
    except csv.Error as error:
        remedy = "close every quote on its line, and put a comma right after it"
        raise MeasurementError(f"not valid CSV: {error}", where, remedy) from None
    return [cell.strip() for cell in cells]


def number_in(text: str, factor: Decimal | None) -> float | None:
    """Return the number in a cell in SI units, None if the cell is not a number."""
    value = float(text) if NUMBER.fullmatch(text) else math.nan
    if factor is not None and value and math.isfinite(value):
        value = float(Decimal(text) * factor)  # in decimal, so that 35 mm is the double nearest to 0.035
    return value if math.isfinite(value) else None
