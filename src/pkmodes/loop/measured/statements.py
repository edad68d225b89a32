"""Statements about the whole test in comments of a measurement file: ``# band: 10 Hz, 400 Hz`` or ``# motors: held``.

Another statement is an entry of `STATEMENTS`.  Those that may occur several times have a name each, as in
``# prior: measurement:offset.z = 2 mm``; the diagnosis of a robot defines what the names mean.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, NamedTuple

from pkmodes.core.base.drives import DRIVES
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import frequency_factor
from pkmodes.core.robot.units import QuantityError
from pkmodes.loop.measured.cells import NUMBER, number_in
from pkmodes.loop.measured.rules import checked_band

BAND_HELP = 'write "# band: 10 Hz, 400 Hz", or start the comment with another word'
DRIVES_HELP = 'write "# drives: free" or "# drives: held", or start the comment with another word'
PRIOR_HELP = 'write "# prior: measurement:offset.z = 2 mm", or start the comment with another word'
STATE_HELP = 'write "# state: before", or start the comment with another word'
USABLE_HELP = 'write "# usable: z = 40 mm, 300 mm", or start the comment with another word'
#: Value of a statement: text with a unit, a number in SI units, or several of these.
Value = str | float


def parse_band(text: str, where: str, remedy: str = BAND_HELP) -> tuple[float, float]:
    """Read a band such as ``10 Hz, 400 Hz`` or ``10,5 Hz; 400 Hz``; numbers without a unit are in Hz.

    - where, remedy: place and remedy, for messages

    Returns low and high [Hz].
    Raises MeasurementError if the text is not two frequencies above 0, the lower one first.
    """
    limits: list[float] = []
    parts = _split_list(text)
    for part in parts if len(parts) == 2 else ():
        number, *unit = part.split(maxsplit=1) or [""]
        number_prefix = NUMBER.match(number)  # also "10Hz"
        if number_prefix is not None and number_prefix.end() < len(number):
            number, unit = number_prefix[0], [" ".join([number[number_prefix.end() :], *unit])]
        try:
            factor = frequency_factor(unit[0]) if unit else None
        except QuantityError as error:
            raise MeasurementError(f"expected a band in Hz: {error}", where, remedy) from None
        value = number_in(number, factor)
        if value is not None:
            limits.append(value)
    if len(limits) != 2:
        problem = f"expected a lower and a higher frequency, found {shown(text.strip())}"
        raise MeasurementError(problem, where, remedy)
    return checked_band(limits, where)


def parse_drives(text: str, where: str) -> str:
    """Read what the motors did: "free" or "held".

    Raises MeasurementError if the text is neither.
    """
    word = text.strip().lower()
    if word not in DRIVES:
        raise MeasurementError(f'expected "free" or "held", found {shown(text.strip())}', where, DRIVES_HELP)
    return word


def parse_state(text: str, where: str) -> str:
    """Read the state of the machine, such as "before".

    Raises MeasurementError if there is none.
    """
    if not (name := text.strip()):
        raise MeasurementError("expected the name of a state, found nothing", where, STATE_HELP)
    return name


def parse_prior(text: str, where: str, remedy: str = PRIOR_HELP) -> tuple[str, Value]:
    """Read the prior of a candidate: its name, and the standard deviation of its value.

    Raises MeasurementError if the text is not a name and a value.
    """
    name, value = _split_name(text, where, remedy)
    return name, _value(value.replace(",", "."))


def parse_usable(text: str, where: str, remedy: str = USABLE_HELP) -> tuple[str, Value | list[Value]]:
    """Read a limit of ``[usable]``: its name, and one value or two; brackets and quotes may be as in a robot file.

    Raises MeasurementError if the text is not a name and values.
    """
    name, stated = _split_name(text, where, remedy)
    values = [_value(part) for part in _split_list(stated.translate(str.maketrans("", "", '[]"')))]
    return name, values if len(values) > 1 else values[0]


def _split_name(text: str, where: str, remedy: str) -> tuple[str, str]:
    name, _, value = (part.strip() for part in text.partition("="))
    if not name or not value:
        raise MeasurementError(f"expected a name = a value, found {shown(text.strip())}", where, remedy)
    return name, value


def _split_list(text: str) -> list[str]:
    """Return what commas separate, or semicolons, with decimal commas as points."""
    separator = ";" if ";" in text else ","
    return [
        part.strip() if separator == "," else part.strip().replace(",", ".") for part in text.split(separator)
    ]


def _value(text: str) -> Value:
    number = number_in(text, None)
    return text if number is None else number


class Statement(NamedTuple):
    """A comment on the whole test.

    - read: returns its value from its text and its place; of a repeatable one, its name and its value
    - remedy: for the error if it cannot be read
    - beginning: beginning of its text, as a regular expression, by which a missing colon is noticed
    - repeatable: whether there may be several, each with a name
    """

    read: Callable[[str, str], Any]
    remedy: str
    beginning: str
    repeatable: bool = False


#: Statements about the whole test by their first word; then synonyms of these words.
STATEMENTS = {
    "band": Statement(parse_band, BAND_HELP, "[0-9.]"),
    "drives": Statement(parse_drives, DRIVES_HELP, r"(?:free|held)\b"),
    "state": Statement(parse_state, STATE_HELP, r"(?!)"),  # without a colon it is an ordinary comment
    "prior": Statement(parse_prior, PRIOR_HELP, r"[\w.:]+\s*=", repeatable=True),
    "usable": Statement(parse_usable, USABLE_HELP, r"\w+\s*[:=]", repeatable=True),
}
WORD_SYNONYMS = {"motors": "drives"}
#: A comment with a statement.  Also matches without the colon, a mistake that would otherwise go unnoticed.
STATEMENT_PATTERN = re.compile(
    r"#\s*({})\s*([:=]|(?=\s))(.*)".format(
        "|".join(
            rf"{word}(?=\s*[:=]|\s+{STATEMENTS[WORD_SYNONYMS.get(word, word)].beginning})"
            for word in (*STATEMENTS, *WORD_SYNONYMS)
        )
    ),
    re.IGNORECASE,
)
