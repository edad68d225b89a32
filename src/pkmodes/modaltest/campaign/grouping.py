"""Modes of several files that are the same mode: groups with at most one mode of each file.

Pairs of groups merge in the order of their distance, which combines the differences of frequency and of shape.  It
is the mean distance of their members (average linkage), so that a chain of neighbours is not a group.

Between setups, or visits, a machine warms and its belts settle, which moves its modes farther than that, most of them
by about the same fraction of their frequencies.  Such a common shift is removed first if more modes then pair.  A
mode that moved by itself is matched if it is nearer than half the distance to the next mode, and the shapes agree.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from heapq import heapify, heappop, heappush

import numpy as np

from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate, mac

#: Largest relative difference of one mode's frequency between two files: between files of a campaign, settling joints
#: and temperature change frequencies by a few parts in a thousand.
MAX_FREQUENCY_DIFFERENCE = 0.01
#: The same between setups or visits, over which a machine runs longer.
MAX_VISIT_DIFFERENCE = 0.03
#: Minimum number of modes that shift together; maximum number of pairs of modes among which such a shift is looked
#: for.
MIN_SHIFTED_MODES, MAX_PAIRS = 2, 1_000_000
#: Smallest MAC between two shapes of one mode.
MIN_MAC = 0.5
#: Factor on widths, so that rounding excludes no pair.
ROUNDING_FACTOR = 1.0 + 1e-9


def group_modes(files: Sequence[Sequence[ModeEstimate]]) -> list[dict[int, ModeEstimate]]:
    """Return the modes of several files, each with the files in which it was found; ascending in frequency."""
    ordered = sorted(
        ((mode.frequency, i, mode) for i, modes in enumerate(files) for mode in modes),
        key=lambda entry: entry[:2],
    )
    groups: list[dict[int, ModeEstimate]] = []
    cluster: list[dict[int, ModeEstimate]] = []
    for k, (frequency, i, mode) in enumerate(ordered):
        # Modes on either side of a gap cannot match.
        if k and np.log(frequency / ordered[k - 1][0]) > max(_width(mode), _width(ordered[k - 1][2])):
            groups += _merge(cluster)
            cluster = []
        cluster.append({i: mode})
    groups += _merge(cluster) if cluster else []
    return sorted(groups, key=lambda group: float(np.mean([mode.frequency for mode in group.values()])))


def match_visits(visits: Sequence[Sequence[ModeEstimate]]) -> list[dict[int, int]]:
    """Return the modes of several setups or visits, as indices in their lists; ascending in frequency."""
    base = max(visits, key=len)
    factors = [_common_shift(modes, base) for modes in visits]
    unshifted = [
        [replace(mode, frequency=mode.frequency * factor) for mode in modes]
        for modes, factor in zip(visits, factors, strict=True)
    ]
    groups = group_modes(visits)
    unshifted_groups = group_modes(unshifted) if set(factors) != {1.0} else groups
    if len(unshifted_groups) < len(groups):
        groups, visits = unshifted_groups, unshifted
    indices = {mode: k for modes in visits for k, mode in enumerate(modes)}
    logs = [float(np.mean([np.log(mode.frequency) for mode in group.values()])) for group in groups]
    gaps = [np.inf, *np.diff(logs), np.inf]
    united: list[dict[int, ModeEstimate]] = []
    for i, group in enumerate(groups):
        if (
            i
            and gaps[i] < min(MAX_VISIT_DIFFERENCE, 0.5 * gaps[i - 1], 0.5 * gaps[i + 1])
            and _may_be_same(united[-1], group)
        ):
            united[-1] |= group
        else:
            united.append(group)
    return [{i: indices[mode] for i, mode in group.items()} for group in united]


def _common_shift(modes: Sequence[ModeEstimate], base: Sequence[ModeEstimate]) -> float:
    """Return the factor that maps most frequencies of a visit onto those of another one."""
    logs, base_logs = (np.sort(np.log([mode.frequency for mode in visit])) for visit in (modes, base))
    first, last = (np.searchsorted(base_logs, logs + side * MAX_VISIT_DIFFERENCE) for side in (-1, 1))
    if not MIN_SHIFTED_MODES <= (last - first).sum() <= MAX_PAIRS:
        return 1.0
    differences = np.sort(
        np.concatenate([base_logs[i:j] - log for i, j, log in zip(first, last, logs, strict=True)])
    )
    starts, ends = (
        np.searchsorted(differences, differences + side * 0.5 * MAX_FREQUENCY_DIFFERENCE) for side in (-1, 1)
    )
    candidates = np.flatnonzero(ends - starts == (ends - starts).max())
    best = candidates[np.argmin(np.abs(differences[candidates]))]
    if ends[best] - starts[best] < MIN_SHIFTED_MODES:
        return 1.0
    return float(np.exp(np.median(differences[starts[best] : ends[best]])))


def _may_be_same(first: Mapping[int, ModeEstimate], second: Mapping[int, ModeEstimate]) -> bool:
    """Return whether groups of different visits share sensors or references, and their shapes agree."""
    return not first.keys() & second.keys() and all(
        (a.shape.keys() & b.shape.keys() or a.participation.keys() & b.participation.keys())
        and mac(a.shape, b.shape, a.lengths) >= MIN_MAC
        for a in first.values()
        for b in second.values()
    )


def _merge(modes: list[dict[int, ModeEstimate]]) -> list[dict[int, ModeEstimate]]:
    """Merge groups, of one mode each and in the order of their frequencies, in the order of their distance.

    Groups can only match where members do: after a merge, the neighbours of both parts are compared again.
    """
    groups = dict(enumerate(modes))
    neighbours_of = _neighbours(modes)
    queue = [
        (_distance(groups[i], groups[k]), i, k, 1, 1)
        for i, neighbours in neighbours_of.items()
        for k in neighbours
        if i < k
    ]
    heapify(queue)
    while queue:
        distance, i, k, *sizes = heappop(queue)
        if distance > 1.0:
            break
        if i not in groups or k not in groups or sizes != [len(groups[i]), len(groups[k])]:
            continue  # one of them has merged since
        groups[i] |= groups.pop(k)
        for neighbour in neighbours_of.pop(k):
            neighbours_of[neighbour].discard(k)
            if neighbour != i:
                neighbours_of[neighbour].add(i)
                neighbours_of[i].add(neighbour)
        for neighbour in neighbours_of[i]:
            first, second = min(i, neighbour), max(i, neighbour)
            lower, upper = groups[first], groups[second]
            if not lower.keys() & upper.keys():
                heappush(queue, (_distance(lower, upper), first, second, len(lower), len(upper)))
    return list(groups.values())


def _neighbours(modes: Sequence[dict[int, ModeEstimate]]) -> dict[int, set[int]]:
    """Return, for each mode, which modes of other files may be the same, by their frequencies."""
    (files, members) = zip(*((i, mode) for group in modes for i, mode in group.items()), strict=True)
    logs = np.log([mode.frequency for mode in members])
    ends = np.searchsorted(logs, logs + ROUNDING_FACTOR * max(map(_width, members)), side="right").tolist()
    neighbours: dict[int, set[int]] = {i: set() for i in range(len(modes))}
    for i, end in enumerate(ends):
        for k in range(i + 1, end):
            if files[i] != files[k]:
                neighbours[i].add(k)
                neighbours[k].add(i)
    return neighbours


def _distance(first: dict[int, ModeEstimate], second: dict[int, ModeEstimate]) -> float:
    """Return the mean distance of two groups: 1 where their modes just match."""
    return float(np.mean([_mode_distance(a, b) for a in first.values() for b in second.values()]))


def _width(mode: ModeEstimate) -> float:
    """Return the relative difference of frequencies within which two modes may be the same."""
    return max(MAX_FREQUENCY_DIFFERENCE, mode.resolution / mode.frequency)


def _mode_distance(first: ModeEstimate, second: ModeEstimate) -> float:
    frequency_difference = abs(np.log(first.frequency / second.frequency)) / max(
        _width(first), _width(second)
    )
    shape_difference = (1.0 - mac(first.shape, second.shape, first.lengths)) / (1.0 - MIN_MAC)
    return float(
        max(
            frequency_difference,
            shape_difference,
            np.hypot(frequency_difference, shape_difference) / np.sqrt(2.0),
        )
    )
