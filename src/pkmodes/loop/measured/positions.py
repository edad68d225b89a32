"""Whether poses of two measurements are at the same position."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.measured.measurements import Measurements

#: Positions are the same if no component differs by more than this fraction of the range of the first measurement's
#: positions, or by more than this [m or rad].
MAX_RANGE_FRACTION, MAX_DISTANCE = 0.02, 5e-4


def is_same_position(first: Measurements, second: Measurements) -> NDArray[np.bool_]:
    """Return which poses of the second measurement are at the positions of those of the first, (S_2, S_1)."""
    tolerance = np.maximum(MAX_RANGE_FRACTION * np.ptp(first.points, axis=0), MAX_DISTANCE)
    return np.asarray((np.abs(second.points[:, None] - first.points[None]) <= tolerance).all(axis=-1))
