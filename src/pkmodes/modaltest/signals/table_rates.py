"""The sampling rate of a table without times: stated in comments, or with counted samples.

Comments such as ``# Sample rate: 3200 Hz``, ``# data_rate = 2000.0 Hz, filter = 488 Hz`` or ``# rate 1344`` state a
rate.  Numbers of samples, in a column ``sample`` or ``count``, are no times, but show which samples are missing.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.support.ordering import joined
from pkmodes.modaltest.signals.functions import Array

#: A rate by its name, its unit and its number; the bare word only at the start of a statement.
STATEMENT = re.compile(
    r"(?:(?:(?<![a-z])(?:sampl(?:e|ing)|(?:output[ _-]?)?data|acquisition|scan|logging)[ _-]?(?:rate|freq(?:uency)?)"
    r"|(?<![a-z0-9_])(?:fs|f_s|odr))|(?:^|[,;|])[ \t]*rate)(?![a-z])"
    r"[ \t]*(?:[\[(](?P<before>[^\])]*)[\])])?[ \t]*[:=,;]?[ \t]*"
    r"(?P<number>\d+(?:\.\d+)?(?:e[+-]?\d+)?)(?![\d.]|,\d)[ \t]*[\[(]?(?P<after>[^\])\s,;|]*(?: per s(?:econd)?)?)",
    re.IGNORECASE,
)
#: Units of rates, in lower case, in Hz.
HERTZ = {
    "": 1.0,
    "hz": 1.0,
    "khz": 1e3,
    "mhz": 1e6,
    "sps": 1.0,
    "ksps": 1e3,
    "s/s": 1.0,
    "ks/s": 1e3,
    "1/s": 1.0,
}
HERTZ |= {"samples/s": 1.0, "samples/sec": 1.0, "samples per s": 1.0, "samples per second": 1.0}
#: Words before a rate that is not that of the file.
LIMIT = re.compile(r"\b(?:max|maximum|min|minimum)\W*$", re.IGNORECASE)
#: Rates that differ by less, relative, are the same.
RATE_TOLERANCE = 1e-6
#: Maximum number of statements that are read.
MAX_STATEMENTS = 20
#: Names of columns that count samples, in lower case.
COUNTERS = frozenset(
    {"sample", "samples", "count", "counter", "index", "n", "no", "no.", "nr", "nr.", "number"}
)
COUNTERS |= {"sample number", "sample_number", "sample no", "sample_no", "sample index", "sample_index"}
#: Minimum share of the steps of a counter that are one sample.
MIN_UNIT_STEP_SHARE = 0.9


def find_rates(comments: Iterable[str]) -> list[tuple[float, str]]:
    """Return the sampling rates [Hz] stated in comments, each with its wording."""
    rates = []
    for comment in comments:
        text = comment.lstrip("# \t")
        for match in STATEMENT.finditer(text):
            unit = (match["after"] or match["before"] or "").strip().lower()
            rate = float(match["number"]) * HERTZ.get(unit, math.nan)
            if rate > 0.0 and not LIMIT.search(text[: match.start()]):
                rates.append((rate, match[0].strip(" \t,;|([")))
        if len(rates) >= MAX_STATEMENTS:
            break
    return rates


def stated_rate(comments: Iterable[str], source: str) -> tuple[float | None, list[str]]:
    """Return the sampling rate [Hz] stated in comments, None if there is none, and messages about it.

    Raises MeasurementError if they contradict each other.
    """
    rates = find_rates(comments)
    if not rates:
        return None, []
    rate, comment = rates[0]
    if not all(same_rate(candidate, rate) for candidate, _ in rates):
        listing = joined(
            [f"{candidate:g} Hz" for candidate in dict.fromkeys(candidate for candidate, _ in rates)]
        )
        problem = f"expected one sampling rate in the comments of a table without times, found {listing}"
        raise MeasurementError(problem, source, f'give the right one in the record: rate = "{rate:g} Hz"')
    return rate, [f"it has no times: its rate, {rate:g} Hz, is that of its comment {shown(comment)}"]


def same_rate(first: float, second: float) -> bool:
    """Return whether two rates are the same but for rounding."""
    return math.isclose(first, second, rel_tol=RATE_TOLERANCE)


def find_counter(names: Sequence[str], used: Sequence[int]) -> int | None:
    """Return the column that counts samples by its name, None unless there is exactly one besides those taken."""
    counters = [i for i, name in enumerate(names) if i not in used and name.strip().lower() in COUNTERS]
    return counters[0] if len(counters) == 1 else None


def sample_positions(numbers: Array) -> Array | None:
    """Return the position of each sample after the first, from its number; None if the numbers are something else.

    - numbers: numbers of samples, ascending, (n,); some may be missing
    """
    steps = np.diff(numbers)
    usual_step = float(np.median(steps)) if steps.size else 0.0
    if not usual_step > 0.0 or float(np.mean(steps == usual_step)) < MIN_UNIT_STEP_SHARE:
        return None
    positions = (numbers - numbers[0]) / usual_step
    return positions if np.all(steps > 0.0) and np.array_equal(positions, np.round(positions)) else None
