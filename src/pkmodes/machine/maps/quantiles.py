"""Quantiles of values that are read part by part, exact, without all of them in memory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
#: Bits dropped to find the bin of a number, which is 2^-10 of the number wide; and the bits other than the sign.
DROPPED_BITS = 42
MAGNITUDE_MASK = np.int64(2**63 - 1)


def quantiles(parts: Callable[[], Iterable[Array]], probabilities: Sequence[float]) -> Array:
    """Return the quantiles of each column, as `numpy.quantile` does for all rows at once.

    A first pass counts the values in bins that are narrow relative to the values; a second one collects the values
    of the few bins in which the quantiles lie.

    - parts: called for each pass; returns the parts of a table, each (rows, columns), with NaN for missing values
    - probabilities: probabilities from 0 to 1

    Returns (columns, shares); NaN for a column without values.
    """
    counts: list[Counter[int]] = []
    for part in parts():
        counts = counts or [Counter() for _ in range(part.shape[1])]
        for column, counter in zip(part.T, counts, strict=True):
            bins, numbers = np.unique(_bins(column[~np.isnan(column)]), return_counts=True)
            counter.update(dict(zip(bins.tolist(), numbers.tolist(), strict=True)))
    positions = [_rank_positions(counter, probabilities) for counter in counts]
    needed_bins = [
        np.array(sorted({key for key, _ in ranks.values()}), dtype=np.int64) for ranks in positions
    ]
    collected: list[list[Array]] = [[] for _ in counts]
    for part in parts():
        for column, keys, column_values in zip(part.T, needed_bins, collected, strict=True):
            values = column[~np.isnan(column)]
            column_values.append(values[np.isin(_bins(values), keys)])
    results = np.full((len(counts), len(probabilities)), np.nan)
    for i, counter in enumerate(counts):
        if counter:
            values = np.sort(np.concatenate(collected[i]))
            results[i] = [
                _value_at_rank(values, positions[i], probability * (counter.total() - 1))
                for probability in probabilities
            ]
    return results


def _bins(values: Array) -> Integers:
    """Return the bin of each value; larger values have larger bins."""
    bits = np.ascontiguousarray(values, dtype=np.float64).view(np.int64)
    # The bits of a positive number, read as an integer, grow with it; those of a negative number fall.
    ordered: Integers = (bits ^ ((bits >> 63) & MAGNITUDE_MASK)) >> DROPPED_BITS
    return ordered


def _rank_positions(counter: Counter[int], probabilities: Sequence[float]) -> dict[int, tuple[int, int]]:
    """Return, for each rank that the quantiles need, its bin and its rank among the values that are collected."""
    if not counter:
        return {}
    last = counter.total() - 1
    ranks = sorted(
        {
            int(end)
            for probability in probabilities
            for end in (np.floor(probability * last), np.ceil(probability * last))
        }
    )
    bin_keys = sorted(counter)
    counts_below = np.concatenate([[0], np.cumsum([counter[key] for key in bin_keys])])
    bins = [int(np.searchsorted(counts_below, rank, "right")) - 1 for rank in ranks]
    skipped_count, last_bin, positions = 0, -1, {}
    for rank, bin_index in zip(ranks, bins, strict=True):
        if bin_index != last_bin:  # values between the bin before and this one are not collected
            skipped_count += int(counts_below[bin_index] - counts_below[last_bin + 1])
            last_bin = bin_index
        positions[rank] = bin_keys[bin_index], rank - skipped_count
    return positions


def _value_at_rank(values: Array, positions: dict[int, tuple[int, int]], rank: float) -> float:
    """Return the value at a rank, interpolated between its two neighbours."""
    low, high = (float(values[positions[int(end)][1]]) for end in (np.floor(rank), np.ceil(rank)))
    fraction = rank - float(np.floor(rank))
    # From the nearer end, as NumPy does: the result then never lies outside the two values.
    return low + (high - low) * fraction if fraction < 0.5 else high - (high - low) * (1.0 - fraction)
