"""Text and numbers as a report shows them."""

from __future__ import annotations

import math

from pkmodes.plots.labels import TIMES, typeset, visible
from pkmodes.report.blocks import Cell

#: Labels and names longer than this are shortened; the JSON has them whole.
LONGEST = 100
#: The same for sentences, which may contain names.
SENTENCE = 1500
#: Shown where there is no number.
NOTHING = "\u2013"


def clean(text: object, longest: int | None = LONGEST) -> str:
    """Return text on one line, without characters that are not visible, such as those that turn the direction.

    Parameters
    ----------
    longest : int or None
        Longer text is shortened; None for any length.
    """
    return visible(text, longest)


def number(
    value: float | None, form: str = ".6g", at: str = "", *, scale: float = 1.0, strong: bool = False
) -> Cell:
    """Return a number as a cell.

    Parameters
    ----------
    value : float or None
        None or NaN: there is none.
    form : str
        Format of the text.
    at : str
        Its place in the JSON.
    scale : float
        The text shows this multiple of it, such as per cent.
    strong : bool
        Whether it is emphasised.
    """
    if value is None or math.isnan(value):
        return Cell(NOTHING, None, at)
    return Cell(typeset(format(scale * value, form)), float(value), at, strong)


def hertz(value: float | None, at: str = "") -> Cell:
    """Return a frequency with three decimals, or with two digits below 0.01 Hz."""
    return number(value, ".3f" if value is None or value >= 0.01 else ".2g", at)


def p_value(value: float | None, at: str = "") -> Cell:
    """Return a p-value, which is never zero."""
    if value == 0.0:
        return Cell(f"< {typeset('1e-300').removeprefix('1' + TIMES)}", 0.0, at)
    return number(value, ".2g", at)


def unit(name: str) -> str:
    """Return a unit as it is shown after a number; nothing for a number without one."""
    return (
        ""
        if name == "1"
        else clean(name).replace("*", "\u00b7").replace("^2", "\u00b2").replace("^3", "\u00b3")
    )


def pointer(*parts: object) -> str:
    """Return a JSON pointer (RFC 6901); characters that are not visible are escaped."""
    return "".join("/" + visible(part).replace("~", "~0").replace("/", "~1") for part in parts)


def plural(count: int, noun: str) -> str:
    """Return a number with its noun."""
    return f"{count:,} {noun}{'' if count == 1 else 's'}".replace(",", "\u2009")
