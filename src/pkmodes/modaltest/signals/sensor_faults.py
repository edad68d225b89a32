"""Sensor faults that show in a signal: the sensor's range was exceeded, or it stopped."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.modaltest.signals.functions import Array

#: Fewest samples at an extreme value for it to be examined; least ratio of these to the samples at any of the next
#: values if the range was exceeded, and the number of next values.  A sine has a ratio of at most 2.4, noise less.
FEWEST, MORE, NEXT = 10, 4.0, 3
#: Values that differ by less than this fraction of the range are the same: files round them.
ALIKE = 1e-6
#: An extreme value within this fraction of the range from the median is where the signal rests.
RESTING = 0.05
#: Least fraction of a record for which a stopped sensor keeps its value, and least ratio to any other constant run.
STOPPED, LONGER = 0.1, 10.0

#: Samples examined at once.
PART = 1_000_000


def clipped(values: Array, fewest: int = FEWEST) -> tuple[tuple[float, ...], float]:
    """Return the extreme values at which a signal (N,) is cut off, and the share of its samples there.

    Many samples, at least `fewest`, are at such a value, and few at the next ones.
    """
    rest = float(np.median(values[:: 1 + len(values) // PART]))
    size = float(np.ptp(values))
    alike, cut, count = ALIKE * size, list[float](), 0

    def at(level: float) -> int:
        return sum(int((np.abs(part - level) <= alike).sum()) for part in _parts(values))

    for sign in (1.0, -1.0):
        level = beside = sign * max(float((sign * part).max()) for part in _parts(values))
        there = at(level)
        if there < fewest or abs(level - rest) <= RESTING * size:
            continue
        densest = 0
        for _ in range(NEXT):
            within = sign * beside - alike
            tops = (
                np.max(sign * part, where=sign * part < within, initial=-np.inf) for part in _parts(values)
            )
            beside = sign * float(max(tops))
            densest = max(densest, at(beside))
        if there >= MORE * densest:
            cut.append(level)
            count += there
    return tuple(cut), count / len(values)


def stopped(values: Array) -> slice | None:
    """Return the part of a signal (N,) in which it keeps one value, far longer than anywhere else; None for none."""
    runs: list[tuple[int, int]] = []
    begin = 0
    for low in range(0, len(values), PART):
        part = values[low : low + PART + 1]  # with the first sample of the next
        edges = np.concatenate([[begin], low + 1 + np.flatnonzero(part[1:] != part[:-1])])
        lengths = np.diff(edges)
        runs += [(int(lengths[k]), int(edges[k])) for k in np.argsort(lengths)[-2:]]
        begin = int(edges[-1])
    runs.append((len(values) - begin, begin))
    (longest, start), *other_runs = sorted(runs, reverse=True)
    if longest < STOPPED * len(values) or longest < LONGER * (other_runs[0][0] if other_runs else 1):
        return None
    return slice(start, start + longest)


def _parts(values: Array) -> Iterator[Array]:
    """Yield parts of a signal, as a long one fills much of the memory."""
    for low in range(0, len(values), PART):
        yield values[low : low + PART]
