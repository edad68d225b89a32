"""The motion of the platform in a plane and perpendicular to it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def in_plane(motion: Array, directions: Sequence[str], normal: str | None) -> Array:
    """Return the magnitudes of motions of the platform, (..., directions), in the plane with a normal, (...)."""
    plane = [i for i, name in enumerate(directions) if name != normal]
    return np.asarray(np.sqrt((motion[..., plane] ** 2).sum(axis=-1)))


def out_of_plane(motion: Array, directions: Sequence[str], normal: str | None) -> Array:
    """Return the magnitudes along the normal; zero for a mechanism that moves in a plane."""
    if normal is None:
        return 0.0 * in_plane(motion, directions, normal)
    return np.abs(motion[..., list(directions).index(normal)])
