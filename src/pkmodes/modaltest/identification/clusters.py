"""Choice of physical modes by clusters of poles over model orders.

Reynders, Houbrechts and De Roeck, Mechanical Systems and Signal Processing 29, 2012: certainly spurious poles are
removed by hard criteria (negative or very high damping), the others are clustered hierarchically with average
linkage by the distance of their eigenvalues plus 1 - MAC, and large clusters are physical.  Two things differ.  The
distance of eigenvalues is relative to the bandwidth of the modes and not to their frequency: two modes 1 % apart are
close at 3 % damping and well separated at 0.3 %, and the limit needs no tuning to the measurement.  And large means a
fixed share of the orders, not the larger of two groups: with k-means, a measurement without spurious poles would lose
modes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform

from pkmodes.modaltest.identification.lscf import OrderPoles

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Highest damping ratio of an identifiable vibration mode of a machine: beyond it there is no peak.
HIGHEST_DAMPING = 0.2
#: Largest average distance between the poles of one mode: |difference| / sum of |Re|, plus 1 - MAC.  Two equal shapes
#: reach it half a bandwidth apart, where two peaks are not resolved.
MAX_CLUSTER_DISTANCE = 0.5
#: Minimum share of the orders in which a mode must be found.  Low orders have no poles to spare for weak modes;
#: whether a mode exceeds the noise is decided after the fit, so this need not be strict.
MIN_ORDER_SHARE = 0.3


@dataclass(frozen=True, eq=False)
class PoleCluster:
    """A cluster of poles.

    - pole: median of the cluster [1/s]
    - shape: shape of the pole nearest to the median, at any scale, (S,)
    - participation: likewise, (R,)
    - order_count: number of orders in which it was found
    """

    pole: complex
    shape: Complex
    participation: Complex
    order_count: int


def pole_clusters(poles_by_order: Sequence[OrderPoles], low: float, high: float) -> list[PoleCluster]:
    """Return the clusters that are large enough, by ascending frequency.

    - low, high: only poles between these frequencies are used [Hz]

    References
    ----------
    Reynders et al. 2012, sections 4 and 5.
    """
    usable = [usable_poles(model.poles, low, high) for model in poles_by_order]
    poles = np.concatenate([model.poles[mask] for model, mask in zip(poles_by_order, usable, strict=True)])
    shapes = np.concatenate([model.shapes[mask] for model, mask in zip(poles_by_order, usable, strict=True)])
    participations = np.concatenate(
        [model.participation[mask] for model, mask in zip(poles_by_order, usable, strict=True)]
    )
    order_indices = np.repeat(np.arange(len(poles_by_order)), [int(mask.sum()) for mask in usable])
    if not len(poles):
        return []
    labels = np.ones(1, np.int32)
    if len(poles) > 1:
        half_widths = np.abs(poles.real)
        relative_distance = np.abs(poles[:, None] - poles) / (half_widths[:, None] + half_widths)
        distance = relative_distance + 1.0 - _mac_matrix(shapes) * _mac_matrix(participations)
        np.fill_diagonal(distance, 0.0)
        tree = linkage(squareform(0.5 * (distance + distance.T), checks=False), "average")
        labels = np.asarray(fcluster(tree, MAX_CLUSTER_DISTANCE, "distance"), dtype=np.int32)
    clusters = []
    for label in range(1, int(labels.max()) + 1):
        members = np.flatnonzero(labels == label)
        count = len(np.unique(order_indices[members]))
        if count >= math.ceil(MIN_ORDER_SHARE * len(poles_by_order)):
            median = complex(np.median(poles[members].real), np.median(poles[members].imag))
            nearest = members[np.argmin(np.abs(poles[members] - median))]
            clusters.append(PoleCluster(median, shapes[nearest], participations[nearest], count))
    return sorted(clusters, key=lambda cluster: abs(cluster.pole))


def usable_poles(poles: Complex, low: float, high: float) -> NDArray[np.bool_]:
    """Return which poles may be modes between two frequencies: positive damping below the highest."""
    magnitude = np.abs(poles)
    frequency, damping = magnitude / (2.0 * math.pi), -poles.real / np.where(magnitude > 0.0, magnitude, 1.0)
    in_band = (poles.imag > 0.0) & (frequency >= low) & (frequency <= high)
    return np.asarray(in_band & (damping > 0.0) & (damping < HIGHEST_DAMPING))


def count_orders(poles_by_order: Sequence[OrderPoles], pole: complex) -> int:
    """Return the number of orders that have a pole within the half bandwidth of a mode."""
    return sum(bool((np.abs(model.poles - pole) < abs(pole.real)).any()) for model in poles_by_order)


def _mac_matrix(vectors: Complex) -> Array:
    """Return the MAC of each pair of vectors."""
    sizes = np.linalg.norm(vectors, axis=1, keepdims=True)
    unit_vectors = vectors / np.where(sizes > 0.0, sizes, 1.0)
    return np.asarray(np.abs(unit_vectors.conj() @ unit_vectors.T) ** 2)
