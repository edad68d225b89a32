"""Modes of several files that are the same mode: groups with at most one mode of each file.

Pairs of groups merge in the order of their distance, differences of frequency and of shape together; the mean
distance of their members counts (average linkage), so that a chain of neighbours is no group.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from pkmodes.campaign.found import Found, mac

#: Relative difference of frequencies of one mode in two files at most: between files of a campaign joints settle and
#: temperatures change by some parts in a thousand.
APART = 0.01
#: MAC of two shapes of one mode at least.
ALIKE = 0.5


def grouped(files: Sequence[Sequence[Found]]) -> list[dict[int, Found]]:
    """Return the modes of several files, each with the files in which it was found; ascending in frequency."""
    every = sorted(
        ((mode.frequency, i, mode) for i, modes in enumerate(files) for mode in modes),
        key=lambda one: one[:2],
    )
    groups: list[dict[int, Found]] = []
    near: list[dict[int, Found]] = []
    for k, (frequency, i, mode) in enumerate(every):
        # Nothing on both sides of a gap is alike.
        if k and np.log(frequency / every[k - 1][0]) > max(_width(mode), _width(every[k - 1][2])):
            groups += _merged(near)
            near = []
        near.append({i: mode})
    groups += _merged(near)
    return sorted(groups, key=lambda group: float(np.mean([mode.frequency for mode in group.values()])))


def _merged(groups: list[dict[int, Found]]) -> list[dict[int, Found]]:
    """Merge groups of modes in the order of their distance."""
    while len(groups) > 1:
        pairs = [
            (_distance(one, other), i, k)
            for (i, one), (k, other) in combinations(enumerate(groups), 2)
            if not one.keys() & other.keys()
        ]
        least, i, k = min(pairs, default=(2.0, 0, 0))
        if least > 1.0:
            break
        groups[i] = {**groups[i], **groups.pop(k)}
    return groups


def _distance(one: dict[int, Found], other: dict[int, Found]) -> float:
    """Return the mean distance of two groups: 1 where their modes are barely alike."""
    return float(np.mean([_apart(a, b) for a in one.values() for b in other.values()]))


def _width(mode: Found) -> float:
    """Return within which relative difference of frequencies a mode may be another one."""
    return max(APART, mode.resolution / mode.frequency)


def _apart(one: Found, other: Found) -> float:
    difference = abs(np.log(one.frequency / other.frequency)) / max(_width(one), _width(other))
    unlike = (1.0 - mac(one.shape, other.shape)) / (1.0 - ALIKE)
    return float(max(difference, unlike, np.hypot(difference, unlike) / np.sqrt(2.0)))
