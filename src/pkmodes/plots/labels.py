"""Text from files, and numbers, as figures and pages show them."""

from __future__ import annotations

from pkmodes.base.errors import printable

#: Longest label of an axis.
LONGEST = 18
MINUS, TIMES = "\u2212", "\u2009\u00d7\u2009"
RAISED = str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079")


def visible(text: object, longest: int | None = None) -> str:
    """Return text on one line, without characters that are not visible, such as those that turn the direction.

    Parameters
    ----------
    longest : int or None
        Longer text is shortened.
    """
    line = printable(str(text))
    return line if longest is None or len(line) <= longest else f"{line[: longest - 1]}\u2026"


def short(text: object, longest: int = LONGEST) -> str:
    """Return a label for an axis."""
    return visible(text, longest)


def typeset(text: str) -> str:
    """Write a formatted number as in print: a minus sign, and a power of ten."""
    digits, _, power = text.partition("e")
    if not any(c in "123456789" for c in digits):
        digits = digits.replace("-", "").replace("+", "")  # no sign of a zero
    digits = digits.replace("-", MINUS)
    return digits if not power else f"{digits}{TIMES}10{str(int(power)).translate(RAISED)}"
