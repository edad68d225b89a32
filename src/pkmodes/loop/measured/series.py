"""Channels that are numbered in a series, such as ``x_1``, ``x_2``, ``x_3`` or ``floor 1`` to ``floor 5``.

A measurement file has no coordinates of sensors.  The numbers are taken as their order along a line, at equal
distances.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

#: A name with a number: the text before and after its last number identifies the series.
NUMBERED = re.compile(r"(.*?)(\d+)(\D*)")
#: Smallest number of channels of a series: two have no curvature, and only one relative motion.
MIN_SERIES_LENGTH = 3


def series_of(channels: Sequence[str]) -> list[list[int]]:
    """Return the series of three or more channels that are numbered without a gap.

    Returns indices into `channels`, in the order of the numbers.
    """
    numbered: dict[tuple[str, str], list[tuple[int, int]]] = {}
    for k, name in enumerate(channels):
        if parts := NUMBERED.fullmatch(name):
            before, number, after = parts.groups()
            numbered.setdefault((before, after), []).append((int(number), k))
    runs: list[list[int]] = []
    for members in numbered.values():
        last = None
        for number, k in sorted(members):
            if last is None or number != last + 1:
                runs.append([])
            runs[-1].append(k)
            last = number
    return [run for run in runs if len(run) >= MIN_SERIES_LENGTH]
