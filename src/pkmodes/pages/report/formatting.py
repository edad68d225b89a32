"""Text and numbers as a report shows them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping

from pkmodes.core.base import numbers
from pkmodes.core.base.numbers import p_text, plain, round_to_sigma, without_zero_sign
from pkmodes.pages.plots.labels import MINUS, RAISED, TIMES, typeset, visible
from pkmodes.pages.report.blocks import Cell, Spread

#: Longer labels and file names are shortened; the JSON has them in full.
LONGEST = 100
#: Lengths below this are shown in mm [m].
SHORT = 0.1
#: Shown in place of a missing number.
NOTHING = "\u2013"
#: A number with a power of ten within a sentence.
POWER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?e[+-]?\d+(?!\w|\.\d)")
#: A number with its standard deviation within a sentence, with or without a power of ten.
UNCERTAIN = re.compile(r"\(?-?\d+(?:\.\d+)? \+- \d+(?:\.\d+)?(?:\)e[+-]?\d+)?")
#: A product of units after a number within a sentence.
PRODUCT = re.compile(r"(?<=[\d)] )(?:rad/\()?(?:N|kg)\*[\w*^/()]*\w\)?")


def clean(text: object) -> str:
    """Return text on one line, without invisible characters, such as those that reverse the direction.

    However long, it is never shortened: users read it as a sentence, or may type it.
    """
    return visible(text)


def shortened(label: object, longest: int = LONGEST) -> str:
    """Return a label or name from a file on one line, as `clean` does, shortened to at most `longest` characters."""
    return visible(label, longest)


def prose(text: object) -> str:
    """Return sentences on one line, with their powers of ten, standard deviations and units set as in print."""
    line = PRODUCT.sub(lambda match: unit(match[0]), clean(text))
    return POWER.sub(lambda match: typeset(match[0]), UNCERTAIN.sub(lambda match: typeset(match[0]), line))


def sentence(text: str) -> str:
    """Capitalise the first letter, unless of a name with dots or underscores, and end with a full stop."""
    first = text.partition(" ")[0].rstrip(".,;:")
    begun = text if "." in first or "_" in first else f"{text[:1].upper()}{text[1:]}"
    return begun + ("" if text.endswith((".", "?", "!")) else ".")


def figures(value: float | None, digits: int = 6, at: str = "", *, scale: float = 1.0) -> Cell:
    """Return a number as a cell with at most `digits` significant digits; `NOTHING` if there is none.

    - scale: the text shows this multiple of it
    """
    return _cell(value, lambda finite: plain(scale * finite, digits), at)


def read_in(unit_name: str, *values: float) -> tuple[str, float]:
    """Return the unit in which lengths of a row are read, and its factor: mm where all are below 0.1 m."""
    if unit_name == "m" and 0.0 < max(map(abs, values), default=0.0) < SHORT:
        return "mm", 1e3
    return unit_name, 1.0


def number(
    value: float | None, form: str = ".6g", at: str = "", *, scale: float = 1.0, strong: bool = False
) -> Cell:
    """Return a number as a cell.

    - value: None or NaN: there is none
    - form: format of the text
    - at: its place in the JSON
    - scale: the text shows this multiple of it, such as per cent
    - strong: whether it is emphasised
    """
    return _cell(value, lambda finite: format(scale * finite, form), at, strong)


def three_digits(value: float | None, at: str = "", *, scale: float = 1.0, strong: bool = False) -> Cell:
    """Return a number with three significant digits, zeros among them: 5.30 beside 12.7."""
    shown = 0.0 if value is None or math.isnan(value) else abs(scale * value)
    return number(value, "#.3g" if 0.0 < shown < 99.95 else ".0f", at, scale=scale, strong=strong)


def hertz(value: float | None, at: str = "") -> Cell:
    """Return a frequency as a cell."""
    return _cell(value, numbers.format_frequency, at)


def p_value(value: float | None, at: str = "") -> Cell:
    """Return a p-value, which is never zero."""
    return _cell(value, p_text, at)


def _cell(value: float | None, write: Callable[[float], str], at: str, strong: bool = False) -> Cell:
    if value is None or math.isnan(value):
        return Cell(NOTHING, None, at, plain="-")
    text = write(value)
    return Cell(typeset(text), float(value), at, strong, plain=without_zero_sign(text))


def uncertain_cell(
    value: float,
    sigma: float,
    at: str = "",
    at_sigma: str = "",
    *,
    scale: float = 1.0,
    fit: float | None = None,
) -> Cell:
    """Return a value with its standard deviation, both rounded according to the latter.

    - at, at_sigma: their places in the JSON
    - scale: the text shows this multiple of both
    - fit: a smaller standard deviation by the fit alone: the value keeps its digits
    """
    rounding = round_to_sigma(scale * value, scale * sigma, None if fit is None else scale * fit)
    power = f"{TIMES}10{str(rounding.exponent).translate(RAISED)}" if rounding.exponent else ""
    digits, of_sigma = typeset(rounding.value), typeset(rounding.sigma)
    spread = Spread(float(sigma), at_sigma, digits, of_sigma, power)
    return Cell(typeset(str(rounding)), float(value), at, spread=spread, plain=str(rounding))


def label(text: str) -> Cell:
    """Return a label of a file as a cell; a page shortens it."""
    return Cell(shortened(text), plain=text)


def minus(text: str) -> Cell:
    """Return text of numbers and units as a cell, with minus signs as in print on a page."""
    return Cell(text.replace("-", MINUS), plain=text)


def named(explanation: str, sentences: Mapping[str, str]) -> str:
    """Return an explanation of one or two causes in words, with their names."""
    names = explanation.split(" + ")
    return " + ".join(
        f"{clean(sentences[name])} ({clean(name)})" if sentences.get(name) else clean(name) for name in names
    )


def unit(name: str) -> str:
    """Return a unit as it is shown after a number; nothing for a number without one."""
    product = re.sub(r"[* ]+", "\u00b7", clean(name))
    return "" if name == "1" else product.replace("^2", "\u00b2").replace("^3", "\u00b3")


def quantity_cell(value: float, name: str, digits: int = 6) -> Cell:
    """Return a number with its unit as a cell."""
    read, scale = read_in(name, value)
    text, symbol = plain(scale * value, digits), "" if read == "1" else f" {clean(read)}"
    return Cell(f"{typeset(text)} {unit(read)}".rstrip(), value, plain=text + symbol)


def unit_cell(name: str) -> Cell:
    """Return a unit as a cell."""
    return Cell(unit(name), plain="" if name == "1" else clean(name))


def thousands(count: int) -> str:
    """Return a count with narrow spaces between its thousands, at which no line breaks."""
    return f"{count:,}".replace(",", "\u202f")


def per_cent(share: float) -> str:
    """Return a share in per cent with two digits, as sentences give it."""
    return f"{plain(100.0 * share, 2)} %"


def file_name(path: str) -> str:
    """Return the name of a file from its path, with slashes of either kind."""
    return path.replace("\\", "/").rpartition("/")[2]


def pointer(*parts: object) -> str:
    """Return a JSON pointer (RFC 6901); characters that are not visible are escaped."""
    return "".join("/" + visible(part).replace("~", "~0").replace("/", "~1") for part in parts)


def plural(count: int, noun: str) -> str:
    """Return a number with its noun."""
    return f"{thousands(count)} {noun}{'' if count == 1 else 's'}"
