"""Modes tracked by their shapes from pose to pose, instead of by their rank.

Neighbouring poses are compared by the mass-weighted modal assurance criterion (MAC)

    C_ij = (phi_i^T M psi_j)^2 / ((phi_i^T M phi_i) (psi_j^T M psi_j))

of shapes phi at one pose and psi at the other, with M of the first (R. J. Allemang, "The modal assurance criterion:
twenty years of use and abuse", Sound and Vibration 37(8), 2003), and paired one to one by the largest sum.  Modes are
followed from one reference pose along the spanning tree of the map whose pairs are clearest, so that a doubtful step
is taken only where there is no way around it.

Near a pose at which two frequencies coincide there may be no consistent numbering: a path through it exchanges the
two modes, a path around it does not.  Neighbours that are numbered differently from how they are paired are marked as
uncertain.  Once around such a pose, both shapes change their sign, so that signs cannot be continuous either.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, connected_components, minimum_spanning_tree

from pkmodes.core.support.mac import mass_weighted_mac
from pkmodes.machine.dataset.variables import EVENTS

Array = NDArray[Any]
Index = NDArray[np.intp]
#: A pair with a MAC below the first is uncertain; a mode whose own MAC is below the second, but reaches it together
#: with another mode, veers.
CLEAR, SAME = 0.5, 0.9
#: Steps compared at once.
CHUNK = 8192

Masses = Callable[[Index], Array]


@dataclass(frozen=True, eq=False)
class Tracked:
    """A numbering of the modes of a map by shape.

    - order: rank of each tracked mode among the vibration modes, from 0, (rows, modes)
    - signs: factor of each tracked shape, (rows, modes), 1 or -1
    - events: bits of `EVENTS` at each tracked mode, (rows, modes)
    """

    order: Array
    signs: Array
    events: Array


@dataclass(frozen=True, eq=False)
class Steps:
    """Pairs of valid neighbours, and how their modes are paired.

    - first, second: rows, (steps,)
    - order: rank at the second row of the mode that continues each mode of the first, (steps, modes)
    - signs: sign of the product of the two shapes, (steps, modes)
    - quality: smallest MAC of a pair, (steps,)
    - marks: events of each mode of the first row, (steps, modes)
    """

    first: Index
    second: Index
    order: Array
    signs: Array
    quality: Array
    marks: Array


def track(
    arrays: Mapping[str, Any], shape: tuple[int, ...], linked: tuple[bool, ...], masses: Masses
) -> Tracked:
    """Track modes by shape.

    - arrays: of a map, ``shape`` with the same number of modes everywhere, mass-normalised, and ``code``, each
      (rows, ...)
    - shape: of the map; rows are in C order
    - linked: whether rows next to each other along an axis are neighbours; otherwise all of them are neighbours of
      the first
    - masses: from rows, their mass matrices, (N, n, n)

    Modes are numbered by rank at the valid pose nearest to the middle of each connected part of the map; shapes keep
    their sign from there.
    """
    good = arrays["code"][:] == 0
    steps = _compared(arrays["shape"], *_neighbours(shape, linked, good), masses)
    order, signs = _followed(steps, good, shape)
    # Events of a step belong to the tracked modes at both rows; a step that contradicts the numbering is uncertain.
    events = np.zeros_like(order)
    mode_of = np.argsort(order, axis=1).astype(np.int8)  # tracked mode of each rank
    for mode in range(order.shape[1]):
        event = steps.marks[:, mode].copy()
        here, there = mode_of[steps.first, mode], mode_of[steps.second, steps.order[:, mode]]
        event |= np.where(here != there, EVENTS["uncertain"], 0).astype(np.int8)
        np.bitwise_or.at(events, (steps.first, here), event)
        np.bitwise_or.at(events, (steps.second, there), event)
    return Tracked(order, signs, events)


def _neighbours(shape: tuple[int, ...], linked: tuple[bool, ...], good: Array) -> tuple[Index, Index]:
    """Return the rows of all pairs of valid neighbours."""
    rows = np.arange(good.size).reshape(shape)
    pairs = []
    for axis, along in enumerate(linked):
        aligned = np.moveaxis(rows, axis, 0)
        later = aligned[1:]
        pairs.append(
            (np.broadcast_to(aligned[:-1] if along else aligned[:1], later.shape).ravel(), later.ravel())
        )
    first, second = (np.concatenate(part) for part in zip(*pairs, strict=True))
    kept = good[first] & good[second]
    return first[kept], second[kept]


def _compared(shapes: Array, first: Index, second: Index, masses: Masses) -> Steps:
    """Pair the modes of neighbours.

    - shapes: mass-normalised, (rows, modes, coordinates)
    - first, second: rows, (steps,)
    - masses: from rows, their mass matrices, (N, n, n)
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


def _followed(steps: Steps, good: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Follow the modes from the reference of each part along the spanning tree.

    Returns order and signs, (rows, modes).
    """
    rows, modes = good.size, steps.order.shape[1]
    order = np.tile(np.arange(modes, dtype=np.int8), (rows, 1))
    signs = np.ones((rows, modes), dtype=np.int8)
    parents, taken, forward = _tree(steps, good, shape)
    children = np.flatnonzero(taken >= 0)
    step, onward = taken[children], forward[children, None]
    back = np.argsort(steps.order[step], axis=1)
    order[children] = np.where(onward, steps.order[step], back)
    signs[children] = np.where(onward, steps.signs[step], np.take_along_axis(steps.signs[step], back, axis=1))
    # Pointer doubling: `order` and `signs` lead from the row `above` to each row, which doubles its distance in each
    # round, so that a path of n steps needs log2(n) rounds.
    above = parents
    while (above[above] != above).any():
        for_each = order[above]
        signs = signs[above] * np.take_along_axis(signs, for_each, axis=1)
        order = np.take_along_axis(order, for_each, axis=1)
        above = above[above]
    return order, signs


def _tree(steps: Steps, good: Array, shape: tuple[int, ...]) -> tuple[Index, Index, Array]:
    """Return the spanning tree with the clearest pairs, rooted at the reference of each part.

    Returns, in this order:
    - parents: a reference, or a row without neighbours, is its own parent, (rows,)
    - taken: the step between a row and its parent, -1 where there is none, (rows,)
    - forward: whether that step leads from the parent to the row, (rows,)
    """
    rows = good.size
    tree = minimum_spanning_tree(_graph(2.0 - steps.quality, steps.first, steps.second, rows)).tocoo()
    _, part = connected_components(tree, directed=False)
    # One search for all parts, from an additional row that leads to every reference.
    references = _references(part.astype(np.intp), good, shape)
    first, second = np.r_[tree.row, np.full(len(references), rows)], np.r_[tree.col, references]
    joined = _graph(np.ones(len(first)), first, second, rows + 1)
    # SciPy numbers nodes with 32 bits, which `key` exceeds.
    reached, before = (nodes.astype(np.intp) for nodes in breadth_first_order(joined, rows, directed=False))
    parents = np.arange(rows)
    inner = reached[1:][before[reached[1:]] != rows]
    parents[inner] = before[inner]
    taken = np.full(rows, -1)
    forward = np.zeros(rows, dtype=bool)
    key = steps.first * rows + steps.second
    sorted_steps = np.argsort(key)
    for onward in (True, False):
        edge_keys = parents[inner] * rows + inner if onward else inner * rows + parents[inner]
        place = np.minimum(np.searchsorted(key, edge_keys, sorter=sorted_steps), len(key) - 1)
        step = sorted_steps[place]
        there = key[step] == edge_keys
        taken[inner[there]], forward[inner[there]] = step[there], onward
    return parents, taken, forward


def _graph(weights: Array, first: Index, second: Index, nodes: int) -> Any:
    """Return a graph for SciPy, which takes only 32-bit numbers of nodes before version 1.17."""
    ends = first.astype(np.int32), second.astype(np.int32)
    return coo_array((weights, ends), shape=(nodes, nodes)).tocsr()


def _references(part: Index, good: Array, shape: tuple[int, ...]) -> Index:
    """Return the valid row nearest to the middle of each part."""
    rows = np.flatnonzero(good)
    of = part[rows]
    at = np.stack(np.unravel_index(rows, shape), axis=1).astype(float)
    count = np.maximum(np.bincount(of), 1)
    middle = np.stack([np.bincount(of, weights=along) / count for along in at.T], axis=1)
    distance = ((at - middle[of]) ** 2).sum(axis=1)
    nearest_first = np.lexsort((distance, of))
    _, first = np.unique(of[nearest_first], return_index=True)
    references: Index = rows[nearest_first[first]]
    return references
