"""Frequencies between the states of a grid, and how far they are off: what the page interpolates is checked here.

Compliances add, so 1/f^2 of paired modes is interpolated linearly along each axis: near the ends of a workspace,
where a belt becomes short, that is closer than f itself.  At some points of every edge, face and cell of the grid the
frequencies are also computed; the page tells the largest difference around.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Slider steps between two evaluated states, as in states.js.
FINE = 10


def mean_frequency(frequencies: Array, weights: Array | None = None) -> Array:
    """Return the frequency between states, (..., m), from those at the corners.

    - frequencies: of paired modes, (..., corners, m) [Hz]; where one is not positive, the mean of the frequencies
      themselves is taken
    - weights: their sum is 1, (corners,); by default all are equal: in the middle
    """
    positive = np.all(frequencies > 0.0, axis=-2)
    compliances = np.where(positive[..., None, :], frequencies, 1.0) ** -2.0
    mean = np.average(compliances, axis=-2, weights=weights) ** -0.5
    interpolated: Array = np.where(positive, mean, np.average(frequencies, axis=-2, weights=weights))
    return interpolated


def interpolation_errors(
    frequencies: Array,
    order: Index,
    places: Index,
    levels: tuple[Array, ...],
    exact: Callable[[Array], Array],
    checked: tuple[float, ...] = (0.5,),
) -> Array:
    """Return how far interpolated frequencies are off on each edge, face and cell of a grid.

    - frequencies: of the vibration modes at the states, (N, m) [Hz]
    - order: index of the mode of each number, (N, m), as from `pkmodes.pages.view.pairing.paired_modes`, of vibration
    modes
      only
    - places: index of the state at each place, -1 where there is none
    - levels: values along each axis
    - exact: from values of the axes, (C, axes), the frequencies there, (C, m); NaN where there are none
    - checked: where along each axis the frequencies are computed, from 0 at one level to 1 at the next

    Returns (2 size - 1 along each axis, m): interpolated over computed frequency - 1 by rank, the largest of those
    checked, on the grid with a place between each two levels; NaN at the states themselves and where one of those
    around is missing.
    """
    errors = np.full((*(2 * size - 1 for size in places.shape), frequencies.shape[1]), np.nan)
    numbered = np.take_along_axis(frequencies, order, axis=1)
    for kind in product((0, 1), repeat=places.ndim):  # 1 along the axes on which the place is between levels
        shifts = np.array(list(product(*(range(k + 1) for k in kind))))
        corners = np.stack([_shifted(places, kind, shift) for shift in shifts.tolist()], axis=-1)
        whole = np.argwhere((corners >= 0).all(axis=-1))
        if not any(kind) or not len(whole):
            continue
        around, here = numbered[corners[tuple(whole.T)]], tuple((2 * whole + np.array(kind)).T)
        for parts in product(*(checked if k else (0.0,) for k in kind)):
            part = np.array(parts)
            weights = np.where(shifts, part, np.where(kind, 1.0 - part, 1.0)).prod(axis=1)
            ends = [(v[i], v[i + k], t) for v, i, k, t in zip(levels, whole.T, kind, parts, strict=True)]
            computed = exact(np.stack([low + t * (high - low) for low, high, t in ends], axis=-1))
            with np.errstate(divide="ignore", invalid="ignore"):
                ratios = np.sort(mean_frequency(around, weights), axis=1) / computed - 1.0
            larger = np.isfinite(ratios) & ~(np.abs(ratios) <= np.abs(errors[here]))
            errors[here] = np.where(larger, ratios, errors[here])
    return errors


def largest_around(deviations: Array) -> Array:
    """Return the largest size of `deviations` over modes at each place and on its sides; NaN where none is known.

    A place on an edge holds the error of this edge, one inside a face also those of its four edges, and so on.
    """
    sizes: Array = np.fmax.reduce(np.abs(deviations), axis=-1, initial=np.nan)
    for axis in range(sizes.ndim):
        along = np.moveaxis(sizes, axis, 0)
        along[1::2] = np.fmax(along[1::2], np.fmax(along[:-1:2], along[2::2]))
    return sizes


def _shifted(places: Index, kind: tuple[int, ...], shift: Sequence[int]) -> Index:
    """Return the states at one corner of every place of a kind."""
    return places[tuple(slice(s, n - k + s) for n, k, s in zip(places.shape, kind, shift, strict=True))]
