"""What comments of a measurement file say of the whole test: ``# band: 10 Hz, 400 Hz`` and ``# drives: held``.

Another statement is an entry of `STATEMENTS`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from pkmodes.core.base.drives import DRIVES
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import frequency_factor
from pkmodes.core.robot.units import QuantityError
from pkmodes.measured.cells import NUMBER, number_in
from pkmodes.measured.rules import checked_band

BAND_HELP = 'write "# band: 10 Hz, 400 Hz", or start the comment with another word'
DRIVES_HELP = 'write "# drives: free" or "# drives: held", or start the comment with another word'


def parse_band(text: str, where: str, remedy: str = BAND_HELP) -> tuple[float, float]:
    """Read a band such as ``10 Hz, 400 Hz`` or ``10,5 Hz; 400 Hz``; numbers without a unit are in Hz.

    Parameters
    ----------
    where, remedy : str
        Place and remedy, for messages.

    Returns
    -------
    low, high : float
        [Hz].

    Raises
    ------
    MeasurementError
        If the text is not two frequencies above 0, the lower one first.
    """
    limits: list[float] = []
    separator = ";" if ";" in text else ","
    parts = text.split(separator)
    for part in parts if len(parts) == 2 else ():
        if separator == ";":
            part = part.replace(",", ".")
        number, *unit = part.split(maxsplit=1) or [""]
        glued = NUMBER.match(number)  # also "10Hz"
        if glued is not None and glued.end() < len(number):
            number, unit = glued[0], [" ".join([number[glued.end() :], *unit])]
        try:
            factor = frequency_factor(unit[0]) if unit else None
        except QuantityError as error:
            raise MeasurementError(f"expected a band in Hz: {error}", where, remedy) from None
        value = number_in(number, factor)
        if value is not None:
            limits.append(value)
    if len(limits) != 2:
        what = f"expected a lower and a higher frequency, found {shown(text.strip())}"
        raise MeasurementError(what, where, remedy)
    return checked_band(limits, where)


def parse_drives(text: str, where: str) -> str:
    """Read what the motors did: "free" or "held".

    Raises
    ------
    MeasurementError
        If the text is neither.
    """
    word = text.strip().lower()
    if word not in DRIVES:
        raise MeasurementError(f'expected "free" or "held", found {shown(text.strip())}', where, DRIVES_HELP)
    return word


#: What a comment may say of the whole test: how it is read, and the remedy if it cannot be.
STATEMENTS: dict[str, tuple[Callable[[str, str], Any], str]] = {
    "band": (parse_band, BAND_HELP),
    "drives": (parse_drives, DRIVES_HELP),
}
#: Such a comment.  Also matches without the colon, a mistake that would otherwise go unnoticed.
STATEMENT = re.compile(r"#\s*(band|drives)\s*(:|=|(?=\s(?:[0-9.]|free\b|held\b)))(.*)", re.IGNORECASE)
