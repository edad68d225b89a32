"""The motion of the platform in a plane and perpendicular to it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def parts_of(motion: Array, directions: Sequence[str], normal: str | None) -> tuple[Array, Array]:
    """Split motions of the platform into magnitudes in the plane of the grid and perpendicular to it.

    Parameters
    ----------
    motion : ndarray, shape (..., directions)
    directions : sequence of str
    normal : str or None

    Returns
    -------
    in_plane, out_of_plane : ndarray, shape (...)
        The second is zero for a mechanism that moves in a plane.
    """
    plane = [i for i, name in enumerate(directions) if name != normal]
    within = np.sqrt((motion[..., plane] ** 2).sum(axis=-1))
    return within, 0.0 * within if normal is None else np.abs(motion[..., directions.index(normal)])
