"""Frequencies between the states of a grid, and how far they are off: what the page interpolates is checked here.

Compliances add, so 1/f^2 of paired modes is interpolated linearly along each axis: near the ends of a workspace,
where a belt becomes short, that is closer than f itself.  In the middle of every cell of the grid the frequencies are
also computed; the page tells the difference there.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]


def mean_frequency(frequencies: Array) -> Array:
    """Return the frequency in the middle between states, (..., m), from those at the corners.

    Parameters
    ----------
    frequencies : ndarray, shape (..., corners, m)
        Of paired modes [Hz]; where one is not positive, the mean of the frequencies themselves is taken.
    """
    positive = np.all(frequencies > 0.0, axis=-2, keepdims=True)
    compliances = np.where(positive, frequencies, 1.0) ** -2.0
    means: Array = np.where(positive[..., 0, :], compliances.mean(axis=-2) ** -0.5, frequencies.mean(axis=-2))
    return means


def deviations(
    frequencies: Array,
    order: Index,
    places: Index,
    levels: tuple[Array, ...],
    exact: Callable[[Array], Array],
) -> Array:
    """Return how far interpolated frequencies are off in the middle of each cell of a grid.

    Parameters
    ----------
    frequencies : ndarray, shape (N, m)
        Of the vibration modes at the states [Hz].
    order : ndarray of int, shape (N, m)
        Index of the mode of each number, as from `pkmodes.view.pairing.paired_modes`, of vibration modes only.
    places : ndarray of int
        Index of the state at each place, -1 where there is none.
    levels : tuple of ndarray
        Values along each axis.
    exact : callable
        From values of the axes, (C, axes), the frequencies there, (C, m); NaN where there are none.

    Returns
    -------
    ndarray, shape (cells, m)
        Interpolated over computed frequency - 1 by rank, cells in C order; NaN where a corner is missing.
    """
    cells = tuple(size - 1 for size in places.shape)
    corners = np.stack(
        [
            places[tuple(slice(k, k + size) for k, size in zip(shift, cells, strict=True))].ravel()
            for shift in product((0, 1), repeat=places.ndim)
        ],
        axis=1,
    )
    found = np.full((len(corners), frequencies.shape[1]), np.nan)
    whole = (corners >= 0).all(axis=1)
    if not whole.any():
        return found
    middles = np.stack(np.meshgrid(*(0.5 * (v[1:] + v[:-1]) for v in levels), indexing="ij"), axis=-1)
    computed = exact(middles.reshape(-1, places.ndim)[whole])
    numbered = np.take_along_axis(frequencies, order, axis=1)
    between = np.sort(mean_frequency(numbered[corners[whole]]), axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = between / computed - 1.0
    found[whole] = np.where(np.isfinite(ratio), ratio, np.nan)
    return found
