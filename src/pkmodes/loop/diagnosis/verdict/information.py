r"""Information that a measurement is expected to give about which explanation is true: their mutual information.

Explanation i has the probability p and predicts a normal distribution of what would be measured.  The information of
such a mixture has no closed form.  It is at least

.. math:: -\sum_i p_i \ln \sum_j p_j e^{-B_{ij}}

with the Bhattacharyya distances B (Kolchinsky and Tracey, Estimating Mixture Entropy with Pairwise Distances, Entropy
19, 2017, 361), with equality if the distributions are equal or far apart: nothing, or all that is unknown.
"""

from __future__ import annotations

import numpy as np

from pkmodes.loop.diagnosis.problem import Array


def pairs(count: int) -> list[tuple[int, int]]:
    """Return all pairs of n indices."""
    return [(i, j) for i in range(count) for j in range(i + 1, count)]


def separations(means: Array, covariances: Array) -> tuple[Array, Array, Array]:
    """Return how far normal distributions are apart at S places, for each of their `pairs`.

    - means, covariances: of n distributions, (n, S, m) and (n, S, m, m); not finite where there is none

    Returns distances, certain and overlaps, (P, S): distances of their means; the same in standard deviations of the
    mean of both covariances; and Bhattacharyya coefficients.  Distances are 0 and overlaps 1 where either is missing,
    so that there is no information.
    """
    finite = np.isfinite(means.sum(axis=-1)) & np.isfinite(covariances.sum(axis=(-2, -1)))
    m = np.where(finite[..., None], means, 0.0)
    V = np.where(finite[..., None, None], covariances, np.eye(means.shape[-1]))
    i, j = np.array(pairs(len(m))).T
    both, apart = 0.5 * (V[i] + V[j]), m[i] - m[j]
    squares = (apart * np.linalg.solve(both, apart[..., None])[..., 0]).sum(axis=-1)
    size = np.linalg.slogdet(V)[1]
    overlaps = np.exp(-squares / 8.0 - 0.5 * (np.linalg.slogdet(both)[1] - 0.5 * (size[i] + size[j])))
    compared = finite[i] & finite[j]
    certain = np.sqrt(np.where(compared, squares, 0.0))
    return np.linalg.norm(apart, axis=-1) * compared, certain, np.where(compared, overlaps, 1.0)


def information(probabilities: Array, overlaps: Array) -> Array:
    """Return a lower bound of the expected information at S places [nat], (S,).

    - probabilities: of the explanations, with the sum 1, (n,)
    - overlaps: of their predictions, see `separations`, (P, S)
    """
    count = len(probabilities)
    like, (i, j) = np.ones((count, count, overlaps.shape[1])), np.array(pairs(count)).T
    like[i, j] = like[j, i] = overlaps
    return np.asarray(-probabilities @ np.log(np.einsum("j,ijs->is", probabilities, like)))
