"""Sensor faults that show in a signal: the sensor's range was exceeded, or it stopped."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.modaltest.signals.functions import Array

#: Minimum number of samples at an extreme value for it to be examined; minimum ratio of these to the samples at any
#: of the next values if the range was exceeded, and the number of next values.  A sine has a ratio of at most 2.4,
#: noise less.
MIN_EXTREME_SAMPLES, MIN_COUNT_RATIO, NEXT_VALUES = 10, 4.0, 3
#: Values that differ by less than this fraction of the range are the same: files round them.
VALUE_TOLERANCE = 1e-6
#: An extreme value within this fraction of the range from the median is where the signal rests.
MAX_REST_DISTANCE = 0.05
#: Minimum fraction of a record for which a stopped sensor keeps its value, and minimum ratio to any other constant
#: run.
MIN_STOPPED_SHARE, MIN_RUN_RATIO = 0.1, 10.0

#: Samples examined at once.
PART_SIZE = 1_000_000


def find_clipping(values: Array, min_samples: int = MIN_EXTREME_SAMPLES) -> tuple[tuple[float, ...], float]:
    """Return the extreme values at which a signal (N,) is cut off, and the share of its samples there.

    Many samples, at least `min_samples`, are at such a value, and few at the next ones.
    """
    rest = float(np.median(values[:: 1 + len(values) // PART_SIZE]))
    size = float(np.ptp(values))
    tolerance, levels, count = VALUE_TOLERANCE * size, list[float](), 0

    def count_at(level: float) -> int:
        return sum(int((np.abs(part - level) <= tolerance).sum()) for part in _parts(values))

    for sign in (1.0, -1.0):
        level = next_level = sign * max(float((sign * part).max()) for part in _parts(values))
        extreme_count = count_at(level)
        if extreme_count < min_samples or abs(level - rest) <= MAX_REST_DISTANCE * size:
            continue
        densest = 0
        for _ in range(NEXT_VALUES):
            bound = sign * next_level - tolerance
            maxima = (
                np.max(sign * part, where=sign * part < bound, initial=-np.inf) for part in _parts(values)
            )
            next_level = sign * float(max(maxima))
            densest = max(densest, count_at(next_level))
        if extreme_count >= MIN_COUNT_RATIO * densest:
            levels.append(level)
            count += extreme_count
    return tuple(levels), count / len(values)


def find_stop(values: Array) -> slice | None:
    """Return the part of a signal (N,) in which it keeps one value, far longer than anywhere else; None for none."""
    runs: list[tuple[int, int]] = []
    run_start = 0
    for low in range(0, len(values), PART_SIZE):
        part = values[low : low + PART_SIZE + 1]  # with the first sample of the next
        edges = np.concatenate([[run_start], low + 1 + np.flatnonzero(part[1:] != part[:-1])])
        lengths = np.diff(edges)
        runs += [(int(lengths[k]), int(edges[k])) for k in np.argsort(lengths)[-2:]]
        run_start = int(edges[-1])
    runs.append((len(values) - run_start, run_start))
    (longest, start), *other_runs = sorted(runs, reverse=True)
    if longest < MIN_STOPPED_SHARE * len(values) or longest < MIN_RUN_RATIO * (
        other_runs[0][0] if other_runs else 1
    ):
        return None
    return slice(start, start + longest)


def _parts(values: Array) -> Iterator[Array]:
    """Yield parts of a signal, as a long one fills much of the memory."""
    for low in range(0, len(values), PART_SIZE):
        yield values[low : low + PART_SIZE]
