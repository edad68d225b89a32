"""Which mode at one state of a grid continues which mode at another: the numbering that the page interpolates along.

Ranks cannot be interpolated along: where two frequencies cross, the shapes exchange their ranks.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.machine.maps.tracking import track

Array = NDArray[np.float64]
Index = NDArray[np.intp]


def paired_modes(shapes: Array, masses: Array, places: Index, rigid: int) -> Index:
    """Follow the vibration modes over a grid by the mass-weighted modal assurance criterion.

    - shapes: mass-normalised, the rigid-body modes first, (N, m, n)
    - masses: (N, n, n)
    - places: index of the state at each place of the grid, -1 where there is none
    - rigid: number of rigid-body modes

    Returns (N, m): index of the mode that carries each number at each state; modes with one number continue each
    other.  A rigid-body mode keeps its rank: these modes are an arbitrary basis.
    """
    count, modes, _ = shapes.shape
    order = np.tile(np.arange(modes), (count, 1))
    if modes == rigid or not count:
        return order
    states, has_state = np.maximum(places.ravel(), 0), places.ravel() >= 0
    arrays = {"shape": shapes[states, rigid:], "code": np.where(has_state, 0, 1)}
    tracked = track(arrays, places.shape, (True,) * places.ndim, lambda rows: masses[states[rows]])
    order[states[has_state], rigid:] = rigid + tracked.order[has_state]
    return order
