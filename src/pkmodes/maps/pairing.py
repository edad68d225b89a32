"""Pair the modes of neighbouring poses of a map by their shapes, and mark crossings and veerings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from pkmodes.dataset.variables import EVENTS
from pkmodes.support.mac import mass_weighted_mac

Array = NDArray[Any]
Index = NDArray[np.intp]
#: A pair below this MAC is uncertain; a mode that keeps less than this of its shape, but not alone, veers.
CLEAR, SAME = 0.5, 0.9
#: Steps compared together.
CHUNK = 8192

Masses = Callable[[Index], Array]


@dataclass(frozen=True, eq=False)
class Steps:
    """Pairs of valid neighbours, and how their modes are paired.

    Attributes
    ----------
    first, second : ndarray of int, shape (steps,)
        Rows.
    order : ndarray of int8, shape (steps, modes)
        Rank at the second row of the mode that continues each mode of the first.
    signs : ndarray of int8, shape (steps, modes)
        Sign of the product of the two shapes.
    quality : ndarray, shape (steps,)
        Smallest MAC of a pair.
    marks : ndarray of int8, shape (steps, modes)
        Events of each mode of the first row.
    """

    first: Index
    second: Index
    order: Array
    signs: Array
    quality: Array
    marks: Array


def compared(shapes: Array, first: Index, second: Index, masses: Masses) -> Steps:
    """Pair the modes of neighbours.

    Parameters
    ----------
    shapes : ndarray or zarr.Array, shape (rows, modes, coordinates)
        Mass-normalised.
    first, second : ndarray of int, shape (steps,)
        Rows.
    masses : callable
        From rows, their mass matrices, (N, n, n).
    """
    count, modes = len(first), shapes.shape[1]
    steps = Steps(
        first,
        second,
        order=np.empty((count, modes), dtype=np.int8),
        signs=np.empty((count, modes), dtype=np.int8),
        quality=np.empty(count),
        marks=np.zeros((count, modes), dtype=np.int8),
    )
    # Along one axis at a time, from row to row: shapes that are stored are read in blocks of consecutive rows.
    along_axes = np.lexsort((first, second - first))
    for start in range(0, count, CHUNK):
        part = along_axes[start : start + CHUNK]
        phi, psi = shapes[first[part]], shapes[second[part]]
        M = masses(first[part])
        product = phi @ M @ np.swapaxes(psi, 1, 2)
        mac = mass_weighted_mac(product, psi, M)
        order = _paired(mac)
        along = np.take_along_axis(mac, order[..., None], axis=2)[..., 0]
        negative = np.take_along_axis(product, order[..., None], axis=2)[..., 0] < 0.0
        steps.order[part] = order
        steps.signs[part] = np.where(negative, -1, 1)
        steps.quality[part] = along.min(axis=1)
        steps.marks[part] = _events(mac, order, along)
    return steps


def _paired(mac: Array) -> Index:
    """Return the one-to-one assignment with the largest sum of MAC, (steps, modes)."""
    order: Index = mac.argmax(axis=2)
    modes = mac.shape[1]
    clear = (np.sort(order, axis=1) == np.arange(modes)).all(axis=1)
    for place in np.flatnonzero(~clear):
        order[place] = linear_sum_assignment(mac[place], maximize=True)[1]
    return order


def _events(mac: Array, order: Index, along: Array) -> Array:
    """Return the events of each mode of the first row of a step."""
    marks = np.zeros(order.shape, dtype=np.int8)
    lower, higher = np.triu_indices(order.shape[1], 1)
    clear = (along[:, lower] >= CLEAR) & (along[:, higher] >= CLEAR)
    swapped = clear & (order[:, lower] > order[:, higher])
    for modes in (lower, higher):
        for column, mode in enumerate(modes):
            marks[:, mode] |= np.where(swapped[:, column], EVENTS["crossing"], 0).astype(np.int8)
    # Together with one more mode the shape is kept: the two exchange their shapes.
    two = np.sort(mac, axis=2)[..., -2:].sum(axis=2)
    veering = (along < SAME) & (two >= SAME)
    marks |= np.where(veering, EVENTS["veering"], 0).astype(np.int8)
    marks |= np.where(along < CLEAR, EVENTS["uncertain"], 0).astype(np.int8)
    return marks
