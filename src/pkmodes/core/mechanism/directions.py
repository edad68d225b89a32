"""Directions along the linear components of a pose."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, shown


def unit_direction(
    direction: Any, directions: Collection[str], where: str, error: type[PkmodesError] = PkmodesError
) -> NDArray[np.float64]:
    """Return a unit vector, (d,).

    - direction: from the user: a number for each of the directions, not all of them 0
    - directions: linear components of the pose
    - where: for messages
    - error: class of the error

    Raises PkmodesError if it is not a direction.
    """
    try:
        vector = np.array(direction, dtype=float)
    except (TypeError, ValueError):
        vector = np.empty(0)
    if vector.shape != (len(directions),) or not np.isfinite(vector).all() or not vector.any():
        text = str(direction)
        if not isinstance(direction, list | tuple | np.ndarray) or len(text) >= 60:
            text = shown(direction)
        problem = f"expected a direction along {', '.join(directions)}, found {text}"
        raise error(problem, where, f"give {len(directions)} numbers, not all of them 0")
    vector = vector / np.abs(vector).max()  # the squares of tiny and huge numbers leave the range of floats
    return np.asarray(vector / np.linalg.norm(vector))
