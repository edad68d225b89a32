"""Copied shapes and wrongly labelled poses, in all measurements including held-out ones."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.mac import mac, rotation_weights
from pkmodes.loop.diagnosis.criteria import ReadingCriteria
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.measured.amplitude import DIFFER
from pkmodes.loop.measured.measurements import Measurements

#: Positions nearer than this are the same [m].
NEAR = 1e-6


def copied_shapes(stage: MatchStage, c: ReadingCriteria) -> Iterator[str]:
    """Yield a sentence for each pair of rows with identical shapes, which never occur in real measurements."""
    data, first = stage.data, dict[bytes, int]()
    if all_alike(data, c.same_shape):  # reported separately
        return
    for row, shape in enumerate(data.shapes):
        if np.count_nonzero(np.nan_to_num(shape)) < 2:
            continue
        before = first.setdefault(shape.tobytes(), row)
        if before != row:
            lines = f"lines {data.lines[before]} and {data.lines[row]}"
            yield f"the shapes in {lines} are identical: was one copied?"


def same_place(stage: MatchStage, c: ReadingCriteria) -> Iterator[str]:
    """Yield a sentence for each pair of poses, measured alike at one position, whose common modes mostly differ."""
    data = stage.data
    if not data.points.any():  # setups without positions
        return
    order = np.argsort(data.points[:, 0], kind="stable")
    along = data.points[order, 0]
    ends = np.searchsorted(along, along + NEAR, side="right")
    conditions = data.conditions  # held motors and another load change the frequencies
    for place, (i, end) in enumerate(zip(order, ends, strict=True)):
        rest = order[place + 1 : end]
        rest = rest[conditions[rest] == conditions[i]]
        rest = rest[~(np.abs(np.log(data.level[rest] / data.level[i])) > np.log(DIFFER))]  # reported apart
        apart = np.linalg.norm(data.points[rest] - data.points[i], axis=1)
        for k in rest[apart <= NEAR]:
            first, second = sorted((int(i), int(k)))
            largest = _difference(stage, c.same_place, first, second)
            if largest:
                yield (
                    f"poses {data.labels[first]} and {data.labels[second]} are at the same position, but their "
                    f"frequencies differ by up to {plain(100 * largest, 2)} %: is one of them somewhere else?"
                )


def _difference(stage: MatchStage, clearly: tuple[float, float], first: int, second: int) -> float:
    """Return the largest relative difference of the modes that two poses have in common; 0 if most agree."""
    data, sigma, (sigmas, least) = stage.data, stage.sigma, clearly
    partner = stage.pairing.partner
    rows = [{int(partner[r]): r for r in np.flatnonzero(data.pose == p)} for p in (first, second)]
    common = sorted({mode for mode in rows[0] if mode >= 0} & set(rows[1]))
    if not common:
        return 0.0
    a, b = (np.array([by_mode[mode] for mode in common]) for by_mode in rows)
    apart = np.abs(np.log(data.frequency[a] / data.frequency[b]))
    clear = (apart > sigmas * np.hypot(sigma[a], sigma[b])) & (apart > least)
    return float(np.expm1(apart.max())) if clear.mean() >= 0.5 else 0.0


def all_alike(data: Measurements, same: float) -> tuple[str, ...]:
    """Return the labels of setups with three or more shapes whose mutual MAC is always above a limit."""
    labels = []
    for setup, label in enumerate(data.labels):
        shapes = data.shapes[data.pose == setup]
        common = np.isfinite(shapes).all(axis=0)
        shared: Array = shapes[:, common]
        if len(shared) < 3 or common.sum() < 2:
            continue
        largest = np.abs(shared).max(axis=1, keepdims=True)  # shapes have any scale
        shared = shared / np.where(largest > 0.0, largest, 1.0)
        shared *= rotation_weights([data.channels[k] for k in np.flatnonzero(common)], shared)
        if mac(shared, shared, np.ones(shared.shape, dtype=bool)).min() > same:
            labels.append(label)
    return tuple(labels)
