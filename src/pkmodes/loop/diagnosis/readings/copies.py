"""Copied shapes and wrongly labelled poses, in all measurements including held-out ones."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.mac import mac, rotation_weights
from pkmodes.loop.diagnosis.criteria import ReadingCriteria
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.measured.amplitude import MIN_LEVEL_RATIO
from pkmodes.loop.measured.measurements import Measurements

#: Positions nearer than this are the same [m].
POSITION_TOLERANCE = 1e-6


def copied_shapes(stage: MatchStage, criteria: ReadingCriteria) -> Iterator[str]:
    """Yield a sentence for each pair of rows with identical shapes, which never occur in real measurements."""
    data, first_row_by_shape = stage.data, dict[bytes, int]()
    if setups_with_equal_shapes(data, criteria.same_shape):  # reported separately
        return
    for row, shape in enumerate(data.shapes):
        if np.count_nonzero(np.nan_to_num(shape)) < 2:
            continue
        earlier_row = first_row_by_shape.setdefault(shape.tobytes(), row)
        if earlier_row != row:
            lines = f"lines {data.lines[earlier_row]} and {data.lines[row]}"
            yield f"the shapes in {lines} are identical: was one copied?"


def poses_at_one_position(stage: MatchStage, criteria: ReadingCriteria) -> Iterator[str]:
    """Yield a sentence for each pair of poses, at one position under equal conditions, whose modes mostly differ."""
    data = stage.data
    if not data.points.any():  # setups without positions
        return
    order = np.argsort(data.points[:, 0], kind="stable")
    sorted_x = data.points[order, 0]
    ends = np.searchsorted(sorted_x, sorted_x + POSITION_TOLERANCE, side="right")
    conditions = data.conditions  # held motors and another load change the frequencies
    for rank, (i, end) in enumerate(zip(order, ends, strict=True)):
        neighbours = order[rank + 1 : end]
        neighbours = neighbours[conditions[neighbours] == conditions[i]]
        at_other_level = np.abs(np.log(data.level[neighbours] / data.level[i])) > np.log(MIN_LEVEL_RATIO)
        neighbours = neighbours[~at_other_level]  # the others are reported separately
        distances = np.linalg.norm(data.points[neighbours] - data.points[i], axis=1)
        for k in neighbours[distances <= POSITION_TOLERANCE]:
            first, second = sorted((int(i), int(k)))
            max_difference = _largest_difference(stage, criteria.same_place, first, second)
            if max_difference:
                yield (
                    f"poses {data.labels[first]} and {data.labels[second]} are at the same position, but "
                    f"their frequencies differ by up to {plain(100 * max_difference, 2)} %: is one of them somewhere "
                    "else?"
                )


def _largest_difference(stage: MatchStage, limits: tuple[float, float], first: int, second: int) -> float:
    """Return the largest relative difference of the modes that two poses have in common; 0 if most agree."""
    data, sigma, (min_sigmas, min_difference) = stage.data, stage.sigma, limits
    partner = stage.pairing.partner
    rows_by_mode = [{int(partner[r]): r for r in np.flatnonzero(data.pose == p)} for p in (first, second)]
    common_modes = sorted({mode for mode in rows_by_mode[0] if mode >= 0} & set(rows_by_mode[1]))
    if not common_modes:
        return 0.0
    a, b = (np.array([by_mode[mode] for mode in common_modes]) for by_mode in rows_by_mode)
    difference = np.abs(np.log(data.frequency[a] / data.frequency[b]))
    is_clear = (difference > min_sigmas * np.hypot(sigma[a], sigma[b])) & (difference > min_difference)
    return float(np.expm1(difference.max())) if is_clear.mean() >= 0.5 else 0.0


def setups_with_equal_shapes(data: Measurements, min_mac: float) -> tuple[str, ...]:
    """Return the labels of setups with three or more shapes whose mutual MAC is always above a limit."""
    labels = []
    for setup, label in enumerate(data.labels):
        shapes = data.shapes[data.pose == setup]
        is_common = np.isfinite(shapes).all(axis=0)
        compared_shapes: Array = shapes[:, is_common]
        if len(compared_shapes) < 3 or is_common.sum() < 2:
            continue
        max_components = np.abs(compared_shapes).max(axis=1, keepdims=True)  # shapes have any scale
        compared_shapes = compared_shapes / np.where(max_components > 0.0, max_components, 1.0)
        compared_shapes *= rotation_weights(
            [data.channels[k] for k in np.flatnonzero(is_common)], compared_shapes
        )
        if mac(compared_shapes, compared_shapes, np.ones(compared_shapes.shape, dtype=bool)).min() > min_mac:
            labels.append(label)
    return tuple(labels)
