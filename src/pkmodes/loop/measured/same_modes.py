"""The same mode in two measurements of one machine: pairs by frequency and shape, close modes by their order.

Two states of a machine are alike: its frequencies change by little, and its shapes hardly.  Shapes of close modes
alone do not tell which is which, because any change rotates them into each other: these are paired by the order of
their frequencies.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Largest difference of the logarithms of the frequencies of one mode in two states, and the difference that counts
#: as much as shapes that have nothing in common.
MAX_LOG_DIFFERENCE, UNIT_LOG_DIFFERENCE = 0.3, 0.1
#: Modes are close if the logarithms of their frequencies differ by less than this, or by less than this many standard
#: deviations of their difference, up to a limit.
CLOSE, MIXED_SIGMAS, MAX_MIXED = 0.01, 3.0, 0.1


def pair_same_modes(
    log_difference: Array, macs: Array, groups: Index, min_mac: float = 0.0
) -> list[tuple[int, int, float | None]]:
    """Return pairs of modes of two states, so that frequencies and shapes agree best overall, with the MAC of each.

    A shape is compared with those of the whole group of close modes, and agrees as well as with the best of them.

    - log_difference: between the logarithms of the frequencies of both states, as its magnitude, (m, n)
    - macs: of their shapes, NaN where unknown, (m, n)
    - groups: group of close modes of each mode of the first state, (m,), from `close_groups`
    - min_mac: shapes with a smaller MAC are not of one mode
    """
    grouped_macs = macs.copy()
    for group in np.unique(groups):
        in_group = groups == group
        best = np.where(np.isnan(macs[in_group]), -np.inf, macs[in_group]).max(axis=0)
        grouped_macs[in_group] = np.where(np.isfinite(best), best, np.nan)
    cost = (log_difference / UNIT_LOG_DIFFERENCE) ** 2 + np.nan_to_num(1.0 - grouped_macs)
    is_too_far = (log_difference > MAX_LOG_DIFFERENCE) | (grouped_macs < min_mac)
    index_pairs = zip(*linear_sum_assignment(np.where(is_too_far, 1e6, cost)), strict=True)
    return [
        (int(i), int(k), float(grouped_macs[i, k]) if np.isfinite(grouped_macs[i, k]) else None)
        for i, k in index_pairs
        if not is_too_far[i, k]
    ]


def close_groups(log: Array, sigma: Array) -> Index:
    """Return the group of each mode of a setup: one for all modes that are close to the next.

    - log, sigma: logarithms of the frequencies, and their standard deviations, (m,)
    """
    order = np.argsort(log)
    gap, sigma_of_gap = np.diff(log[order]), np.hypot(sigma[order][1:], sigma[order][:-1])
    is_near = (gap < CLOSE) | (gap < np.minimum(MIXED_SIGMAS * sigma_of_gap, MAX_MIXED))
    groups = np.empty(len(log), dtype=np.intp)
    groups[order] = np.concatenate([[0], np.cumsum(~is_near)])[: len(log)]
    return groups
