"""Poses of the rows: carriage positions from the pulleys' rows, and the grid that contains them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from printed import Row
from pulley_rows import AXES, Belt, carriage_position

#: Grid steps that are tried, in descending order [m].
STEPS = np.arange(0.3, 0.005, -1e-6)
#: Steps closer together than this count as the same [m].
SAME_STEP = 5e-4


@dataclass(frozen=True)
class Interval:
    """A number between two bounds."""

    low: float
    high: float

    @property
    def middle(self) -> float:
        """Midpoint."""
        return 0.5 * (self.low + self.high)

    @property
    def half(self) -> float:
        """Half the width."""
        return 0.5 * (self.high - self.low)

    def less(self, other: Interval) -> Interval:
        """Return the difference of two such numbers."""
        return Interval(self.low - other.high, self.high - other.low)


def carriages(row: Row, reading: str, belts: Mapping[int, Belt], span: float) -> dict[int, Interval]:
    """Return the distances of the moving carriages from the start of their rails [m]."""
    return {
        axis: Interval(*carriage_position(row, reading, belts[axis], axis, span))
        for axis in AXES
        if row.moves(axis)
    }


def carriage_1_ahead(positions: Sequence[Mapping[int, Interval]]) -> Interval:
    """Return the x_1 - x_2 [m] that all rows allow: on parallel rails it is constant along the centre line."""
    both = [x[0].less(x[1]) for x in positions if len(x) == len(AXES)]
    return Interval(max(one.low for one in both), min(one.high for one in both))


def position_2(x: Mapping[int, Interval], ahead: Interval) -> Interval:
    """Return x_2 [m] from the axis that determines it better."""
    estimates = [x[1], x[0].less(ahead)] if 0 in x else [x[1]]
    return min(estimates, key=lambda one: one.half)


def grid_step(positions: Sequence[Interval]) -> Interval:
    """Return the largest step such that all positions differ by multiples of it [m], with its bounds."""
    middle, half = (np.array([getattr(x, name) for x in positions]) for name in ("middle", "half"))
    best = int(np.argmin(half))
    distance = middle - middle[best]
    off = np.abs(distance - np.round(distance / STEPS[:, None]) * STEPS[:, None])
    fitting = STEPS[(off <= half + half[best]).all(axis=1)]
    run = fitting[fitting > fitting[0] - SAME_STEP]
    return Interval(float(run.min()), float(run.max()))
