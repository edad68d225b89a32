"""Text from files, and numbers, as figures and pages show them."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from pkmodes.core.base.errors import printable

if TYPE_CHECKING:
    from matplotlib.axis import Axis

#: Length of the longest axis label.
LONGEST = 18
#: An axis that spans fewer decades than this has labels between them.
FEW = 2.0
MINUS, TIMES, PLUS_MINUS = "\u2212", "\u2009\u00d7\u2009", "\u00b1"
RAISED = str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079")


def visible(text: object, longest: int | None = None) -> str:
    """Return text on one line, without invisible characters, such as those that reverse the direction.

    - longest: longer text is shortened
    """
    line = printable(str(text))
    return line if longest is None or len(line) <= longest else f"{line[: longest - 1]}\u2026"


def short(text: object, longest: int = LONGEST) -> str:
    """Return a label for an axis."""
    return visible(text, longest)


def typeset(text: str) -> str:
    """Write a formatted number as in print: a minus sign, a power of ten, and ± before a standard deviation."""
    digits, _, power = text.replace("+-", PLUS_MINUS).partition("e")
    if not any(c in "123456789" for c in digits):
        digits = digits.replace("-", "").replace("+", "")  # no sign of a zero
    digits = digits.replace("-", MINUS)
    if power and digits in ("1", "< 1"):
        return f"{digits[:-1]}10{str(int(power)).translate(RAISED)}"
    return digits if not power else f"{digits}{TIMES}10{str(int(power)).translate(RAISED)}"


def broken(name: str) -> str:
    """Return a name of several parameters with each on a line of its own."""
    return name.replace(", ", ",\n")


def decades(axis: Axis, write: Callable[[float], str] = lambda value: typeset(f"{value:.0e}")) -> None:
    """Label a logarithmic axis at its decades, and also between them if they are few.

    Matplotlib's own labels of such axes are formulas, which figures of pkmodes do not parse.

    - write: returns the label of a value; by default one digit and a power of ten
    """
    from matplotlib.ticker import LogLocator, NullFormatter

    low, high = sorted(axis.get_view_interval())
    few = low <= 0.0 or math.log10(high / low) < FEW
    subs = (1.0, 2.0, 5.0) if few else (1.0,)
    axis.set_major_locator(LogLocator(subs=subs, numticks=8))
    axis.set_major_formatter(lambda value, _: write(value))
    axis.set_minor_formatter(NullFormatter())
