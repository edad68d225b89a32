"""The cells of a line of a table, and the numbers in them.

Commas, semicolons or tabs separate the cells.  Numbers may have decimal commas where commas do not separate.
"""

from __future__ import annotations

import csv
import math
import re
from decimal import Decimal
from typing import NamedTuple

from pkmodes.core.base.errors import MeasurementError

#: Cell separators, in words.  If a header has several equally often, the first one counts; tabs come last, since they
#: may only align.
SEPARATORS = {";": "semicolons", ",": "commas", "\t": "tabs"}
QUOTED = re.compile(r'"[^"]*"')
# Stricter than float(): no "nan", no "1_000", no digits of other scripts.
NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")


def separator_of(header: str) -> str:
    """Return what separates the cells of a header, outside of quotes; a comma if there is a single one."""
    text = QUOTED.sub("", header)
    most_frequent = max(SEPARATORS, key=text.count)
    return most_frequent if most_frequent in text else ","


class TableNotation(NamedTuple):
    """How a table is written.

    - separator: character between two cells
    """

    separator: str = ","

    @property
    def decimal(self) -> str:
        """Decimal marks that numbers may have, for messages."""
        return "a decimal point" if self.separator == "," else "a decimal point or comma"

    def cells(self, line: str, where: str) -> list[str]:
        """Split one line into cells; none spans lines, since that is usually an unclosed quote.

        Raises MeasurementError if it is not CSV.
        """
        try:
            (cells,) = csv.reader([line], strict=True, skipinitialspace=True, delimiter=self.separator)
        except csv.Error as error:
            separator_name = SEPARATORS[self.separator].removesuffix("s")
            remedy = f"close every quote on its line, and put a {separator_name} right after it"
            raise MeasurementError(f"not valid CSV: {error}", where, remedy) from None
        return [cell.strip() for cell in cells]

    def number(self, cell: str, factor: Decimal | None) -> float | None:
        """Return the number in a cell in SI units, None if the cell is not a number."""
        return number_in(cell if self.separator == "," else cell.replace(",", "."), factor)


def number_in(text: str, factor: Decimal | None) -> float | None:
    """Return the number in a text, with a decimal point, in SI units; None if it is not a number."""
    value = float(text) if NUMBER.fullmatch(text) else math.nan
    if factor is not None and value and math.isfinite(value):
        value = float(Decimal(text) * factor)  # in decimal, so that 35 mm is the double nearest to 0.035
    return value if math.isfinite(value) else None
