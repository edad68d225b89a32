"""Times of day as loggers write them, as seconds."""

from __future__ import annotations

from array import array
from collections.abc import Iterable
from datetime import datetime, time, timedelta

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.signals.functions import Array

EPOCH = datetime(1970, 1, 1)
#: Length of a day [us].
DAY = 86_400_000_000


def is_clock(text: str) -> bool:
    """Return whether a text is a date with a time, or a time of day, in the notation of ISO 8601."""
    return _microseconds(text) is not None


def parse_times(texts: Iterable[str]) -> tuple[Array, int | None]:
    """Return times since the first one.

    - texts: such as ``2024-05-03 10:00:00.005`` or ``10:00:00.005``; a time of day may pass midnight

    Returns, in this order:
    - seconds: (n,) [s]
    - bad: index of the first text that is no time
    """
    moments = array("q")
    for i, text in enumerate(texts):
        value = _microseconds(text)
        if value is None:
            return np.zeros(0), i
        moments.append(value)
    microseconds: NDArray[np.int64] = np.frombuffer(moments, np.int64) if moments else np.zeros(0, np.int64)
    first = microseconds[:1].copy()
    if microseconds.size and first[0] < DAY:  # without dates: a step back by most of a day is midnight
        days = np.cumsum(microseconds[1:] - microseconds[:-1] < -DAY // 2, dtype=np.int64)
        days *= DAY
        microseconds[1:] += days
        del days
    microseconds -= first
    seconds = microseconds.astype(np.float64)
    seconds *= 1e-6
    return seconds, None


def _microseconds(text: str) -> int | None:
    """Return the microseconds since 1970, or of the day; None if the text is neither."""
    if ":" not in text:
        return None
    try:
        of_day = time.fromisoformat(text)
        since = datetime.combine(EPOCH, of_day.replace(tzinfo=None)) - EPOCH
    except ValueError:
        try:
            moment = datetime.fromisoformat(text)
        except ValueError:
            return None
        since = moment.replace(tzinfo=None) - EPOCH - (moment.utcoffset() or timedelta())
    return since // timedelta(microseconds=1)
