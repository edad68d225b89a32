"""Text and numbers as a report shows them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from pkmodes.core.base import numbers
from pkmodes.core.base.numbers import p_text, plain, round_to_sigma, without_zero_sign
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.pages.plots.labels import MINUS, SUPERSCRIPTS, TIMES, typeset, visible_text
from pkmodes.pages.report.blocks import Cell, Spread

if TYPE_CHECKING:
    from pkmodes.core.mechanism.registry import Mechanism

#: Longer labels and file names are shortened; the JSON has them in full.
MAX_LABEL_LENGTH = 100
#: Lengths below this are shown in mm [m].
MAX_LENGTH_IN_MM = 0.1
#: Shown in place of a missing number.
MISSING = "\u2013"
#: A number with a power of ten within a sentence.
POWER_OF_TEN = re.compile(r"(?<![\w.])\d+(?:\.\d+)?e[+-]?\d+(?!\w|\.\d)")

#: A number with its standard deviation within a sentence, with or without a power of ten.
UNCERTAIN_NUMBER = re.compile(r"\(?-?\d+(?:\.\d+)? \+- \d+(?:\.\d+)?(?:\)e[+-]?\d+)?")
#: The sign of a number after a space or a bracket; that after a letter or a digit is a hyphen.
MINUS_SIGN = re.compile(r"(?<=[\s(])-(?=\.?\d)")
#: The unit of an angle after its number.
DEGREES = re.compile(r"(?<=\d) deg\b")
#: A product of units after a number within a sentence.
UNIT_PRODUCT = re.compile(r"(?<=[\d)] )(?:rad/\()?(?:N|kg)\*[\w*^/()]*\w\)?")


def clean(text: object) -> str:
    """Return text on one line, without invisible characters, such as those that reverse the direction.

    However long, it is never shortened: users read it as a sentence, or may type it.
    """
    return visible_text(text)


def shorten(label: object, max_length: int = MAX_LABEL_LENGTH) -> str:
    """Return a label or name from a file on one line, as `clean` does, and of at most `max_length` characters."""
    return visible_text(label, max_length)


def typeset_sentences(text: object) -> str:
    """Return sentences on one line, with powers, standard deviations, units and minus signs set as in print."""
    line = UNIT_PRODUCT.sub(lambda match: unit_text(match[0]), clean(text)).replace("chi2", "chi\u00b2")
    for pattern in (UNCERTAIN_NUMBER, POWER_OF_TEN):
        line = pattern.sub(lambda match: typeset(match[0]), line)
    return DEGREES.sub("\u00b0", MINUS_SIGN.sub(MINUS, line))


def sentence_cell(text: str) -> Cell:
    """Return sentences as a cell, set as in print on a page."""
    return Cell(typeset_sentences(text), plain_text=clean(text))


def to_sentence(text: str) -> str:
    """Capitalise the first letter, unless of a name with dots or underscores, and end with a full stop."""
    first_word = text.partition(" ")[0].rstrip(".,;:")
    capitalised = text if "." in first_word or "_" in first_word else f"{text[:1].upper()}{text[1:]}"
    return capitalised + ("" if text.endswith((".", "?", "!")) else ".")


def rounded_cell(value: float | None, digits: int = 6, json_pointer: str = "", *, scale: float = 1.0) -> Cell:
    """Return a number as a cell with at most `digits` significant digits; `MISSING` if there is none.

    - scale: the text shows this multiple of it
    """
    return _format_cell(value, lambda finite: plain(scale * finite, digits), json_pointer)


def display_unit(unit_name: str, *values: float) -> tuple[str, float]:
    """Return the unit in which lengths of a row are read, and its factor: mm where all are below 0.1 m."""
    if unit_name == "m" and 0.0 < max(map(abs, values), default=0.0) < MAX_LENGTH_IN_MM:
        return "mm", 1e3
    return unit_name, 1.0


def number_cell(
    value: float | None,
    form: str = ".6g",
    json_pointer: str = "",
    *,
    scale: float = 1.0,
    strong: bool = False,
) -> Cell:
    """Return a number as a cell.

    - value: None or NaN: there is none
    - form: format of the text
    - json_pointer: its place in the JSON
    - scale: the text shows this multiple of it, such as per cent
    - strong: whether it is emphasised
    """
    return _format_cell(value, lambda finite: format(scale * finite, form), json_pointer, strong)


def three_digit_cell(
    value: float | None, json_pointer: str = "", *, scale: float = 1.0, strong: bool = False
) -> Cell:
    """Return a number with three significant digits, zeros among them: 5.30 beside 12.7."""
    return _format_cell(value, lambda finite: numbers.three_digits(scale * finite), json_pointer, strong)


def frequency_cell(value: float | None, json_pointer: str = "") -> Cell:
    """Return a frequency as a cell."""
    return _format_cell(value, numbers.format_frequency, json_pointer)


def p_value_cell(value: float | None, json_pointer: str = "") -> Cell:
    """Return a p-value, which is never zero."""
    return _format_cell(value, p_text, json_pointer)


def _format_cell(
    value: float | None, format_value: Callable[[float], str], json_pointer: str, strong: bool = False
) -> Cell:
    if value is None or math.isnan(value):
        return Cell(MISSING, None, json_pointer, plain_text="-")
    text = format_value(value)
    return Cell(typeset(text), float(value), json_pointer, strong, plain_text=without_zero_sign(text))


def uncertain_cell(
    value: float,
    sigma: float,
    json_pointer: str = "",
    sigma_pointer: str = "",
    *,
    scale: float = 1.0,
    fit_sigma: float | None = None,
) -> Cell:
    """Return a value with its standard deviation, both rounded according to the latter.

    - json_pointer, sigma_pointer: their places in the JSON
    - scale: the text shows this multiple of both
    - fit_sigma: a smaller standard deviation by the fit alone: the value keeps its digits
    """
    rounding = round_to_sigma(scale * value, scale * sigma, None if fit_sigma is None else scale * fit_sigma)
    power = f"{TIMES}10{str(rounding.exponent).translate(SUPERSCRIPTS)}" if rounding.exponent else ""
    value_digits, sigma_digits = typeset(rounding.value), typeset(rounding.sigma)
    spread = Spread(float(sigma), sigma_pointer, value_digits, sigma_digits, power)
    return Cell(typeset(str(rounding)), float(value), json_pointer, spread=spread, plain_text=str(rounding))


def label_cell(text: str) -> Cell:
    """Return a label of a file as a cell; a page shortens it."""
    return Cell(shorten(text), plain_text=text)


def signed_cell(text: str) -> Cell:
    """Return text of numbers and units as a cell, with minus signs as in print on a page."""
    return Cell(text.replace("-", MINUS), plain_text=text)


def explanation_with_names(explanation: str, sentences: Mapping[str, str]) -> str:
    """Return an explanation of one or two causes in words, with their names."""
    names = explanation.split(" + ")
    return " + ".join(
        f"{clean(sentences[name])} ({clean(name)})" if sentences.get(name) else clean(name) for name in names
    )


def unit_text(unit: str) -> str:
    """Return a unit as it is shown after a number; nothing for a number without one."""
    product = re.sub(r"[* ]+", "\u00b7", clean(unit))
    return "" if unit == "1" else product.replace("^2", "\u00b2").replace("^3", "\u00b3")


def quantity_cell(value: float, unit: str, digits: int = 6) -> Cell:
    """Return a number with its unit as a cell."""
    shown_unit, scale = display_unit(unit, value)
    text, symbol = plain(scale * value, digits), "" if shown_unit == "1" else f" {clean(shown_unit)}"
    return Cell(f"{typeset(text)} {unit_text(shown_unit)}".rstrip(), value, plain_text=text + symbol)


def unit_cell(unit: str) -> Cell:
    """Return a unit as a cell."""
    return Cell(unit_text(unit), plain_text="" if unit == "1" else clean(unit))


def group_thousands(count: int) -> str:
    """Return a count with narrow spaces between its thousands, at which no line breaks."""
    return f"{count:,}".replace(",", "\u202f")


def percent_text(share: float) -> str:
    """Return a share in per cent with two digits, as sentences give it."""
    return f"{plain(100.0 * share, 2)} %"


def file_name(path: str) -> str:
    """Return the name of a file from its path, with slashes of either kind."""
    return path.replace("\\", "/").rpartition("/")[2]


def pointer(*parts: object) -> str:
    """Return a JSON pointer (RFC 6901); characters that are not visible are escaped."""
    return "".join("/" + visible_text(part).replace("~", "~0").replace("/", "~1") for part in parts)


def pose_in_words(mechanism: Mechanism, point: Sequence[float]) -> str:
    """Return a pose in the units of pages: "x = 600 mm, rz = 0 deg"."""
    parts = []
    for component, value in zip(mechanism.pose, point, strict=True):
        unit, factor = DISPLAY_UNITS[component.unit]
        parts.append(f"{component.name} = {plain(value * factor + 0.0, 5)} {unit}")
    return ", ".join(parts).replace("-", MINUS)


def plural(count: int, noun: str) -> str:
    """Return a number with its noun."""
    return f"{group_thousands(count)} {noun}{'' if count == 1 else 's'}"
