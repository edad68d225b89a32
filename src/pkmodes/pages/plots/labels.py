"""Text from files, and numbers, as figures and pages show them."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from pkmodes.core.base.errors import printable

if TYPE_CHECKING:
    from matplotlib.axis import Axis

#: Maximum length of an axis label.
MAX_LABEL_LENGTH = 18
#: An axis that spans fewer decades than this also has labels between the decades.
FEW_DECADES = 2.0
MINUS, TIMES, PLUS_MINUS = "\u2212", "\u2009\u00d7\u2009", "\u00b1"
SUPERSCRIPTS = str.maketrans(
    "-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"
)


def visible_text(text: object, max_length: int | None = None) -> str:
    """Return text on one line without invisible characters, such as those that reverse the writing direction.

    - max_length: longer text is shortened
    """
    line = printable(str(text))
    return line if max_length is None or len(line) <= max_length else f"{line[: max_length - 1]}\u2026"


def short_label(text: object, max_length: int = MAX_LABEL_LENGTH) -> str:
    """Return a label for an axis."""
    return visible_text(text, max_length)


def typeset(text: str) -> str:
    """Write a formatted number as in print: a minus sign, a power of ten, and ± before a standard deviation."""
    digits, _, power = text.replace("+-", PLUS_MINUS).partition("e")
    if not any(c in "123456789" for c in digits):
        digits = digits.replace("-", "").replace("+", "")  # no sign of a zero
    digits = digits.replace("-", MINUS)
    if power and digits in ("1", "< 1"):
        return f"{digits[:-1]}10{str(int(power)).translate(SUPERSCRIPTS)}"
    return digits if not power else f"{digits}{TIMES}10{str(int(power)).translate(SUPERSCRIPTS)}"


def one_name_per_line(name: str) -> str:
    """Return the joint name of several parameters with each on a line of its own."""
    return name.replace(", ", ",\n")


def label_decades(
    axis: Axis, format_value: Callable[[float], str] = lambda value: typeset(f"{value:.0e}")
) -> None:
    """Label a logarithmic axis at its decades, and also between them if they are few.

    Matplotlib's own labels of such axes are formulas, which figures of pkmodes do not parse.

    - format_value: function that returns the label of a value; by default one digit and a power of ten
    """
    from matplotlib.ticker import LogLocator, NullFormatter

    low, high = sorted(axis.get_view_interval())
    spans_few_decades = low <= 0.0 or math.log10(high / low) < FEW_DECADES
    subs = (1.0, 2.0, 5.0) if spans_few_decades else (1.0,)
    axis.set_major_locator(LogLocator(subs=subs, numticks=8))
    axis.set_major_formatter(lambda value, _: format_value(value))
    axis.set_minor_formatter(NullFormatter())
