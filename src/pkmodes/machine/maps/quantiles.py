"""Quantiles of values that are read part by part, exact, without all of them in memory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
#: Bits dropped to find the bin of a number: the width of a bin is 2^-10 of the number.
DROPPED = 42
MAGNITUDE = np.int64(2**63 - 1)


def quantiles(parts: Callable[[], Iterable[Array]], shares: Sequence[float]) -> Array:
    """Return the quantiles of each column, as `numpy.quantile` does for all rows at once.

    A first pass counts the values in bins that are narrow relative to the values; a second one collects the values
    of the few bins in which the quantiles lie.

    - parts: returns the parts of a table anew, each of shape (rows, columns); NaN stands for no value
    - shares: from 0 to 1

    Returns (columns, shares); NaN for a column without values.
    """
    counts: list[Counter[int]] = []
    for part in parts():
        counts = counts or [Counter() for _ in range(part.shape[1])]
        for column, counter in zip(part.T, counts, strict=True):
            bins, numbers = np.unique(_bins(column[~np.isnan(column)]), return_counts=True)
            counter.update(dict(zip(bins.tolist(), numbers.tolist(), strict=True)))
    places = [_places(counter, shares) for counter in counts]
    needed = [np.array(sorted({key for key, _ in ranks.values()}), dtype=np.int64) for ranks in places]
    collected: list[list[Array]] = [[] for _ in counts]
    for part in parts():
        for column, keys, kept in zip(part.T, needed, collected, strict=True):
            values = column[~np.isnan(column)]
            kept.append(values[np.isin(_bins(values), keys)])
    results = np.full((len(counts), len(shares)), np.nan)
    for i, counter in enumerate(counts):
        if counter:
            values = np.sort(np.concatenate(collected[i]))
            results[i] = [_between(values, places[i], share * (counter.total() - 1)) for share in shares]
    return results


def _bins(values: Array) -> Integers:
    """Return the bin of each value; larger values have larger bins."""
    bits = np.ascontiguousarray(values, dtype=np.float64).view(np.int64)
    # The bits of a positive number, read as an integer, grow with it; those of a negative number fall.
    ordered: Integers = (bits ^ ((bits >> 63) & MAGNITUDE)) >> DROPPED
    return ordered


def _places(counter: Counter[int], shares: Sequence[float]) -> dict[int, tuple[int, int]]:
    """Return, for each rank that the quantiles need, its bin and its rank among the values that are collected."""
    if not counter:
        return {}
    last = counter.total() - 1
    ranks = sorted({int(end) for share in shares for end in (np.floor(share * last), np.ceil(share * last))})
    keys = sorted(counter)
    below = np.concatenate([[0], np.cumsum([counter[key] for key in keys])])
    bins = [int(np.searchsorted(below, rank, "right")) - 1 for rank in ranks]
    skipped, used, positions = 0, -1, {}
    for rank, place in zip(ranks, bins, strict=True):
        if place != used:  # values between the bin before and this one are not collected
            skipped += int(below[place] - below[used + 1])
            used = place
        positions[rank] = keys[place], rank - skipped
    return positions


def _between(values: Array, places: dict[int, tuple[int, int]], rank: float) -> float:
    """Return the value at a rank, interpolated between the two next to it."""
    low, high = (float(values[places[int(end)][1]]) for end in (np.floor(rank), np.ceil(rank)))
    share = rank - float(np.floor(rank))
    # From the nearer end, as NumPy: the result then never lies beyond the two.
    return low + (high - low) * share if share < 0.5 else high - (high - low) * (1.0 - share)
