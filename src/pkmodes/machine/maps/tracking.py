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
from pkmodes.machine.dataset.variables import EVENT_FLAGS

Array = NDArray[Any]
Index = NDArray[np.intp]
#: A pair with a MAC below the first is uncertain; a mode veers if its own MAC is below the second, but not the sum of
#: it and that of another mode.
MIN_CLEAR_MAC, MIN_SAME_MAC = 0.5, 0.9
#: Steps compared at once.
CHUNK_STEPS = 8192

Masses = Callable[[Index], Array]


@dataclass(frozen=True, eq=False)
class Tracked:
    """A numbering of the modes of a map by shape.

    - order: rank of each tracked mode among the vibration modes, from 0, (rows, modes)
    - signs: factor of each tracked shape, (rows, modes), 1 or -1
    - events: bits of `EVENT_FLAGS` at each tracked mode, (rows, modes)
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
    - events: bits of `EVENT_FLAGS` for each mode of the first row, (steps, modes)
    """

    first: Index
    second: Index
    order: Array
    signs: Array
    quality: Array
    events: Array


def track(
    arrays: Mapping[str, Any], shape: tuple[int, ...], linked: tuple[bool, ...], masses: Masses
) -> Tracked:
    """Track modes by shape.

    - arrays: arrays of a map, ``shape`` with the same number of modes everywhere, mass-normalised, and ``code``, each
      (rows, ...)
    - shape: shape of the map; rows are in C order
    - linked: for each axis, whether consecutive rows are neighbours; otherwise all rows along it are neighbours of
      the first
    - masses: function from rows to their mass matrices, (N, n, n)

    Modes are numbered by rank at the valid pose nearest to the middle of each connected part of the map; shapes keep
    their sign from there.
    """
    valid = arrays["code"][:] == 0
    rows = np.arange(valid.size).reshape(shape)
    firsts, seconds = [], []
    for axis, is_linked in enumerate(linked):
        aligned = np.moveaxis(rows, axis, 0)
        following = aligned[1:]
        preceding = aligned[:-1] if is_linked else aligned[:1]
        firsts.append(np.broadcast_to(preceding, following.shape).ravel())
        seconds.append(following.ravel())
    first, second = np.concatenate(firsts), np.concatenate(seconds)
    both_valid = valid[first] & valid[second]
    steps = _compare_neighbours(arrays["shape"], first[both_valid], second[both_valid], masses)
    order, signs = _follow_modes(steps, valid, shape)
    # Events of a step belong to the tracked modes at both rows; a step that contradicts the numbering is uncertain.
    events = np.zeros_like(order)
    mode_of = np.argsort(order, axis=1).astype(np.int8)  # tracked mode of each rank
    for mode in range(order.shape[1]):
        event = steps.events[:, mode].copy()
        first_number, second_number = mode_of[steps.first, mode], mode_of[steps.second, steps.order[:, mode]]
        event |= np.where(first_number != second_number, EVENT_FLAGS["uncertain"], 0).astype(np.int8)
        np.bitwise_or.at(events, (steps.first, first_number), event)
        np.bitwise_or.at(events, (steps.second, second_number), event)
    return Tracked(order, signs, events)


def _compare_neighbours(shapes: Array, first: Index, second: Index, masses: Masses) -> Steps:
    """Pair the modes of neighbours.

    - shapes: mass-normalised, (rows, modes, coordinates)
    - first, second: rows, (steps,)
    - masses: function from rows to their mass matrices, (N, n, n)
    """
    count, modes = len(first), shapes.shape[1]
    steps = Steps(
        first,
        second,
        order=np.empty((count, modes), dtype=np.int8),
        signs=np.empty((count, modes), dtype=np.int8),
        quality=np.empty(count),
        events=np.zeros((count, modes), dtype=np.int8),
    )
    # Axis by axis, in the order of the rows: stored shapes are read in blocks of consecutive rows.
    reading_order = np.lexsort((first, second - first))
    for start in range(0, count, CHUNK_STEPS):
        chunk = reading_order[start : start + CHUNK_STEPS]
        phi, psi = shapes[first[chunk]], shapes[second[chunk]]
        M = masses(first[chunk])
        product = phi @ M @ np.swapaxes(psi, 1, 2)
        mac = mass_weighted_mac(product, psi, M)
        # One to one, with the largest sum of MAC.
        order: Index = mac.argmax(axis=2)
        one_to_one = (np.sort(order, axis=1) == np.arange(modes)).all(axis=1)
        for step in np.flatnonzero(~one_to_one):
            order[step] = linear_sum_assignment(mac[step], maximize=True)[1]
        pair_mac = np.take_along_axis(mac, order[..., None], axis=2)[..., 0]
        negative = np.take_along_axis(product, order[..., None], axis=2)[..., 0] < 0.0
        steps.order[chunk] = order
        steps.signs[chunk] = np.where(negative, -1, 1)
        steps.quality[chunk] = pair_mac.min(axis=1)
        steps.events[chunk] = _step_events(mac, order, pair_mac)
    return steps


def _step_events(mac: Array, order: Index, pair_mac: Array) -> Array:
    """Return the events of each mode of the first row of a step."""
    events = np.zeros(order.shape, dtype=np.int8)
    lower, higher = np.triu_indices(order.shape[1], 1)
    both_clear = (pair_mac[:, lower] >= MIN_CLEAR_MAC) & (pair_mac[:, higher] >= MIN_CLEAR_MAC)
    swapped = both_clear & (order[:, lower] > order[:, higher])
    for modes in (lower, higher):
        for column, mode in enumerate(modes):
            events[:, mode] |= np.where(swapped[:, column], EVENT_FLAGS["crossing"], 0).astype(np.int8)
    # Two modes that exchange their shapes: the shape lies in the span of both.
    best_two = np.sort(mac, axis=2)[..., -2:].sum(axis=2)
    veering = (pair_mac < MIN_SAME_MAC) & (best_two >= MIN_SAME_MAC)
    events |= np.where(veering, EVENT_FLAGS["veering"], 0).astype(np.int8)
    events |= np.where(pair_mac < MIN_CLEAR_MAC, EVENT_FLAGS["uncertain"], 0).astype(np.int8)
    return events


def _follow_modes(steps: Steps, valid: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Follow the modes from the reference of each part along the spanning tree.

    Returns order and signs, (rows, modes).
    """
    rows, modes = valid.size, steps.order.shape[1]
    order = np.tile(np.arange(modes, dtype=np.int8), (rows, 1))
    signs = np.ones((rows, modes), dtype=np.int8)
    parents, parent_step, forward = _spanning_tree(steps, valid, shape)
    children = np.flatnonzero(parent_step >= 0)
    step, is_forward = parent_step[children], forward[children, None]
    inverse = np.argsort(steps.order[step], axis=1)
    order[children] = np.where(is_forward, steps.order[step], inverse)
    signs[children] = np.where(
        is_forward, steps.signs[step], np.take_along_axis(steps.signs[step], inverse, axis=1)
    )
    # Pointer doubling: `order` and `signs` lead from each row's ancestor to the row; their distance doubles
    # in each round, so that a path of n steps needs log2(n) rounds.
    ancestors = parents
    while (ancestors[ancestors] != ancestors).any():
        ancestor_order = order[ancestors]
        signs = signs[ancestors] * np.take_along_axis(signs, ancestor_order, axis=1)
        order = np.take_along_axis(order, ancestor_order, axis=1)
        ancestors = ancestors[ancestors]
    return order, signs


def _spanning_tree(steps: Steps, valid: Array, shape: tuple[int, ...]) -> tuple[Index, Index, Array]:
    """Return the spanning tree with the clearest pairs, rooted at the reference of each part.

    Returns, in this order:
    - parents: a reference, or a row without neighbours, is its own parent, (rows,)
    - parent_step: the step between a row and its parent, -1 where there is none, (rows,)
    - forward: whether that step leads from the parent to the row, (rows,)
    """
    rows = valid.size
    tree = minimum_spanning_tree(_graph(2.0 - steps.quality, steps.first, steps.second, rows)).tocoo()
    _, component = connected_components(tree, directed=False)
    # One search for all parts, from an additional row that leads to every reference.
    references = _references(component.astype(np.intp), valid, shape)
    first, second = np.r_[tree.row, np.full(len(references), rows)], np.r_[tree.col, references]
    search_graph = _graph(np.ones(len(first)), first, second, rows + 1)
    # SciPy numbers nodes with 32 bits, which `step_keys` exceeds.
    visited, predecessors = (
        nodes.astype(np.intp) for nodes in breadth_first_order(search_graph, rows, directed=False)
    )
    parents = np.arange(rows)
    inner = visited[1:][predecessors[visited[1:]] != rows]
    parents[inner] = predecessors[inner]
    parent_step = np.full(rows, -1)
    forward = np.zeros(rows, dtype=bool)
    step_keys = steps.first * rows + steps.second
    sorted_steps = np.argsort(step_keys)
    for is_forward in (True, False):
        edge_keys = parents[inner] * rows + inner if is_forward else inner * rows + parents[inner]
        position = np.minimum(np.searchsorted(step_keys, edge_keys, sorter=sorted_steps), len(step_keys) - 1)
        step = sorted_steps[position]
        matches = step_keys[step] == edge_keys
        parent_step[inner[matches]], forward[inner[matches]] = step[matches], is_forward
    return parents, parent_step, forward


def _graph(weights: Array, first: Index, second: Index, nodes: int) -> Any:
    """Return a graph for SciPy, which takes only 32-bit numbers of nodes before version 1.17."""
    ends = first.astype(np.int32), second.astype(np.int32)
    return coo_array((weights, ends), shape=(nodes, nodes)).tocsr()


def _references(component: Index, valid: Array, shape: tuple[int, ...]) -> Index:
    """Return the valid row nearest to the middle of each part."""
    rows = np.flatnonzero(valid)
    component_of = component[rows]
    grid_indices = np.stack(np.unravel_index(rows, shape), axis=1).astype(float)
    count = np.maximum(np.bincount(component_of), 1)
    centres = np.stack(
        [np.bincount(component_of, weights=axis_indices) / count for axis_indices in grid_indices.T], axis=1
    )
    distance = ((grid_indices - centres[component_of]) ** 2).sum(axis=1)
    nearest_first = np.lexsort((distance, component_of))
    _, first = np.unique(component_of[nearest_first], return_index=True)
    references: Index = rows[nearest_first[first]]
    return references
