"""Modes tracked by their shapes from pose to pose, instead of by their rank.

Neighbouring poses are compared by the mass-weighted modal assurance criterion (MAC)

    C_ij = (phi_i^T M psi_j)^2 / ((phi_i^T M phi_i) (psi_j^T M psi_j))

of shapes phi at one pose and psi at the other, with M of the first (R. J. Allemang, "The modal assurance criterion:
twenty years of use and abuse", Sound and Vibration 37(8), 2003), and paired one to one by the largest sum.  Pairs are
followed along the spanning tree of the map with the clearest pairs, from one reference pose, so that doubtful steps
are avoided where there is a way around them.  Around a pose at which two frequencies coincide there is no consistent
numbering: such steps are marked as uncertain.
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

Array = NDArray[Any]
Index = NDArray[np.intp]
#: Marks of a mode at a pose, for any step to a neighbour, as bits.
EVENTS = {"crossing": 1, "veering": 2, "uncertain": 4}
#: A pair below this MAC is uncertain; a mode that keeps less than this of its shape, but not alone, veers.
CLEAR, SAME = 0.5, 0.9
#: Steps compared together.
CHUNK = 2048

Masses = Callable[[Index], Array]


@dataclass(frozen=True, eq=False)
class Tracked:
    """A map whose modes are tracked.

    Attributes
    ----------
    arrays : dict of str to ndarray, shape (rows, ...)
        As in the map, with the modes in another order, and ``rank`` and ``tracking``.
    """

    arrays: Mapping[str, Array]


def track(
    arrays: Mapping[str, Array], shape: tuple[int, ...], linked: tuple[bool, ...], masses: Masses
) -> Tracked:
    """Track modes by shape.

    Parameters
    ----------
    arrays : mapping of str to ndarray, shape (rows, ...)
        Fields of a map, with ``shape`` of the same number of modes everywhere.
    shape : tuple of int
        Of the map; rows are in C order.
    linked : tuple of bool
        Whether rows next to each other along an axis are neighbours; otherwise all of them are neighbours of the
        first.
    masses : callable
        From rows, their mass matrices, (N, n, n).

    Returns
    -------
    Tracked
        Modes are numbered by rank at the valid pose nearest to the middle of each connected part of the map; shapes
        keep their sign from there.
    """
    shapes = arrays["shape"]
    rows, modes = shapes.shape[:2]
    good = arrays["code"] == 0
    first, second = _neighbours(shape, linked, good)
    order, sign, quality, marks = _compared(shapes, first, second, masses)
    following = np.tile(np.arange(modes), (rows, 1))
    signs = np.ones((rows, modes))
    events = np.zeros((rows, modes), dtype=np.int8)
    if len(first):
        levels = _levels(first, second, quality, good, shape)
        for steps, parents, children, forward in levels:
            # order[s, i] is the mode at `second` that continues mode i at `first`
            step, by = order[steps], sign[steps]
            inverse = np.argsort(step, axis=1)
            go = np.where(forward[:, None], step, inverse)
            by = np.where(forward[:, None], by, np.take_along_axis(by, inverse, axis=1))
            following[children] = np.take_along_axis(go, following[parents], axis=1)
            signs[children] = signs[parents] * np.take_along_axis(by, following[parents], axis=1)
        _mark(events, marks, first, second, order, following)
    found = dict(arrays)
    for name in ("frequency", "platform_shape", "shape"):
        values = arrays[name]
        places = following.reshape(rows, modes, *[1] * (values.ndim - 2))
        found[name] = np.take_along_axis(values, places, axis=1)
        if values.ndim > 2:
            found[name] *= signs[..., None]
    found["rank"] = np.where(good[:, None], following + 1, 0).astype(np.int16)
    found["tracking"] = np.where(good[:, None], events, 0).astype(np.int8)
    return Tracked(found)


def _neighbours(shape: tuple[int, ...], linked: tuple[bool, ...], good: Array) -> tuple[Index, Index]:
    """Return the rows of all pairs of valid neighbours."""
    rows = np.arange(good.size).reshape(shape)
    pairs = []
    for axis, along in enumerate(linked):
        each = np.moveaxis(rows, axis, 0)
        others = each[1:]
        pairs.append(
            (np.broadcast_to(each[:-1] if along else each[:1], others.shape).ravel(), others.ravel())
        )
    first, second = (np.concatenate(part) for part in zip(*pairs, strict=True))
    kept = good[first] & good[second]
    return first[kept], second[kept]


def _compared(
    shapes: Array, first: Index, second: Index, masses: Masses
) -> tuple[Index, Array, Array, Array]:
    """Pair the modes of neighbours.

    Returns
    -------
    order : ndarray of int, shape (pairs, modes)
        The mode of the second pose that continues each mode of the first.
    sign : ndarray, shape (pairs, modes)
        Sign of their product.
    quality : ndarray, shape (pairs,)
        Smallest MAC of a pair.
    marks : ndarray of int8, shape (pairs, modes)
        Events of each mode of the first pose.
    """
    count, modes = len(first), shapes.shape[1]
    order = np.empty((count, modes), dtype=np.intp)
    sign = np.empty((count, modes))
    quality = np.empty(count)
    marks = np.zeros((count, modes), dtype=np.int8)
    for start in range(0, count, CHUNK):
        part = slice(start, start + CHUNK)
        phi, psi = shapes[first[part]], shapes[second[part]]
        M = masses(first[part])
        product = phi @ M @ np.swapaxes(psi, 1, 2)
        size = np.einsum("pjn,pnm,pjm->pj", psi, M, psi)
        mac = product**2 / size[:, None, :]  # phi is mass-normalised
        order[part] = _paired(mac)
        along = np.take_along_axis(mac, order[part][..., None], axis=2)[..., 0]
        sign[part] = np.sign(np.take_along_axis(product, order[part][..., None], axis=2)[..., 0])
        quality[part] = along.min(axis=1)
        marks[part] = _events(mac, order[part], along)
    sign[sign == 0.0] = 1.0
    return order, sign, quality, marks


def _paired(mac: Array) -> Index:
    """Return the one-to-one assignment with the largest sum of MAC, (pairs, modes)."""
    order: Index = mac.argmax(axis=2)
    modes = mac.shape[1]
    clear = (np.sort(order, axis=1) == np.arange(modes)).all(axis=1)
    for place in np.flatnonzero(~clear):
        order[place] = linear_sum_assignment(mac[place], maximize=True)[1]
    return order


def _events(mac: Array, order: Index, along: Array) -> Array:
    """Return the events of each mode of the first pose of a pair."""
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


def _levels(
    first: Index, second: Index, quality: Array, good: Array, shape: tuple[int, ...]
) -> list[tuple[Index, Index, Index, Array]]:
    """Order the steps of the spanning tree by their distance from the reference poses.

    Returns
    -------
    list of (steps, parents, children, forward)
        For each distance: indices of pairs, rows from which and to which they lead, and whether from the first to the
        second row of the pair.
    """
    rows = good.size
    cost = 2.0 - quality  # positive: zeros are no edges
    graph = coo_array((cost, (first, second)), shape=(rows, rows)).tocsr()
    tree = minimum_spanning_tree(graph).tocoo()
    step = {(a, b): s for s, (a, b) in enumerate(zip(first.tolist(), second.tolist(), strict=True))}
    undirected = coo_array(
        (np.ones(2 * tree.nnz), (np.r_[tree.row, tree.col], np.r_[tree.col, tree.row])), shape=(rows, rows)
    ).tocsr()
    _, part = connected_components(undirected, directed=False)
    depth = np.full(rows, -1)
    found: dict[int, list[tuple[int, int, int, bool]]] = {}
    for reference in _references(part.astype(np.intp), good, shape):
        order, parents = breadth_first_order(undirected, reference, directed=False)
        depth[reference] = 0
        for row in order[1:].tolist():
            parent = int(parents[row])
            depth[row] = depth[parent] + 1
            forward = (parent, row) in step
            pair = (parent, row) if forward else (row, parent)
            found.setdefault(int(depth[row]), []).append((step[pair], parent, row, forward))
    return [
        tuple(np.array(column) for column in zip(*found[level], strict=True))  # type: ignore[misc]
        for level in sorted(found)
    ]


def _references(part: Index, good: Array, shape: tuple[int, ...]) -> list[int]:
    """Return, for each connected part with several valid rows, the one nearest to its middle."""
    rows = np.flatnonzero(good)
    at = np.stack(np.unravel_index(rows, shape), axis=1).astype(float)
    found = []
    for label, count in zip(*np.unique(part[rows], return_counts=True), strict=True):
        if count > 1:
            mine = part[rows] == label
            distance = ((at[mine] - at[mine].mean(axis=0)) ** 2).sum(axis=1)
            found.append(int(rows[mine][np.argmin(distance)]))
    return found


def _mark(events: Array, marks: Array, first: Index, second: Index, order: Index, following: Index) -> None:
    """Transfer the events of steps to the tracked modes at both poses, and mark contradictory steps."""
    mode_of = np.argsort(following, axis=1)  # tracked mode of each rank
    for mode in range(order.shape[1]):
        event = marks[:, mode].copy()
        here, there = mode_of[first, mode], mode_of[second, order[:, mode]]
        event |= np.where(here != there, EVENTS["uncertain"], 0).astype(np.int8)
        np.bitwise_or.at(events, (first, here), event)
        np.bitwise_or.at(events, (second, there), event)
