"""Frequencies between the states of a grid, and the error of the interpolation on the page.

Compliances add, so 1/f^2 of paired modes is interpolated linearly along each axis: near the ends of a workspace,
where a belt becomes short, that is more accurate than interpolating f.  The
frequencies are also computed at some points of every edge, face and cell of the grid, and the page states the largest
difference nearby.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Slider steps between two evaluated states: the same constant in states.js.
SLIDER_STEPS = 10


def mean_frequency(frequencies: Array, weights: Array | None = None) -> Array:
    """Return the frequency between states, (..., m), from those at the corners.

    - frequencies: of paired modes, (..., corners, m) [Hz]; if one of them is not positive, the frequencies themselves
      are averaged
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
    compute_frequencies: Callable[[Array], Array],
    checked_fractions: tuple[float, ...] = (0.5,),
) -> Array:
    """Return how far interpolated frequencies are off on each edge, face and cell of a grid.

    - frequencies: of the vibration modes at the states, (N, m) [Hz]
    - order: index of the vibration mode with each number, (N, m), as from
      `pkmodes.pages.view.pairing.paired_modes`
    - places: index of the state at each place, -1 where there is none
    - levels: values along each axis
    - compute_frequencies: from values of the axes, (C, axes), the frequencies there, (C, m); NaN where there are none
    - checked_fractions: where along each axis the frequencies are computed, from 0 at one level to 1 at the next

    Returns (2 size - 1 along each axis, m): interpolated over computed frequency - 1 by rank, of those checked the
    largest in size.  There is an entry at each level and one between each two levels: NaN at the states
    themselves and where a corner is missing.
    """
    errors = np.full((*(2 * size - 1 for size in places.shape), frequencies.shape[1]), np.nan)
    paired_frequencies = np.take_along_axis(frequencies, order, axis=1)
    # `is_between` is 1 along the axes on which an edge, face or cell lies between two levels, else 0.
    for is_between in product((0, 1), repeat=places.ndim):
        shifts = np.array(list(product(*(range(k + 1) for k in is_between))))
        corners = np.stack([_corner_states(places, is_between, shift) for shift in shifts.tolist()], axis=-1)
        complete_cells = np.argwhere((corners >= 0).all(axis=-1))
        if not any(is_between) or not len(complete_cells):
            continue
        corner_frequencies = paired_frequencies[corners[tuple(complete_cells.T)]]
        error_index = tuple((2 * complete_cells + np.array(is_between)).T)
        for fractions in product(*(checked_fractions if k else (0.0,) for k in is_between)):
            fraction_array = np.array(fractions)
            weights = np.where(shifts, fraction_array, np.where(is_between, 1.0 - fraction_array, 1.0)).prod(
                axis=1
            )
            end_levels = [
                (v[i], v[i + k], fraction)
                for v, i, k, fraction in zip(levels, complete_cells.T, is_between, fractions, strict=True)
            ]
            exact_frequencies = compute_frequencies(
                np.stack([low + fraction * (high - low) for low, high, fraction in end_levels], axis=-1)
            )
            with np.errstate(divide="ignore", invalid="ignore"):
                interpolated = np.sort(mean_frequency(corner_frequencies, weights), axis=1)
                ratios = interpolated / exact_frequencies - 1.0
            larger = np.isfinite(ratios) & ~(np.abs(ratios) <= np.abs(errors[error_index]))
            errors[error_index] = np.where(larger, ratios, errors[error_index])
    return errors


def largest_around(deviations: Array) -> Array:
    """Return the largest size of `deviations` over modes at and next to each place; NaN where none is known.

    A place on an edge holds the error of this edge, one inside a face also those of its four edges, and so on.
    """
    sizes: Array = np.fmax.reduce(np.abs(deviations), axis=-1, initial=np.nan)
    for axis in range(sizes.ndim):
        axis_view = np.moveaxis(sizes, axis, 0)
        axis_view[1::2] = np.fmax(axis_view[1::2], np.fmax(axis_view[:-1:2], axis_view[2::2]))
    return sizes


def _corner_states(places: Index, is_between: tuple[int, ...], shift: Sequence[int]) -> Index:
    """Return the states at one corner of each edge, face or cell along the axes on which `is_between` is 1."""
    return places[tuple(slice(s, n - k + s) for n, k, s in zip(places.shape, is_between, shift, strict=True))]
