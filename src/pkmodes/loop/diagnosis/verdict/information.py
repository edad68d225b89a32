r"""Information that a measurement is expected to give about which explanation is true: their mutual information.

Explanation i has the probability p and predicts a normal distribution of what would be measured.  The information of
such a mixture has no closed form.  It is at least

.. math:: -\sum_i p_i \ln \sum_j p_j e^{-B_{ij}}

with the Bhattacharyya distances B (Kolchinsky and Tracey, Estimating Mixture Entropy with Pairwise Distances, Entropy
19, 2017, 361), with equality if the distributions are equal (no information) or far apart (all that is unknown).
"""

from __future__ import annotations

import numpy as np

from pkmodes.loop.diagnosis.problem import Array


def pairs(count: int) -> list[tuple[int, int]]:
    """Return all pairs of n indices."""
    return [(i, j) for i in range(count) for j in range(i + 1, count)]


def separations(means: Array, covariances: Array) -> tuple[Array, Array, Array]:
    """Return how far normal distributions are apart at S places, for each of their `pairs`.

    - means, covariances: those of n distributions, (n, S, m) and (n, S, m, m); not finite where there is none

    Returns distances, certain and overlaps, (P, S): distances of their means; the same in standard deviations of the
    mean of both covariances; and Bhattacharyya coefficients.  Distances are 0 and overlaps 1 where either is missing,
    so that there is no information.
    """
    finite = np.isfinite(means.sum(axis=-1)) & np.isfinite(covariances.sum(axis=(-2, -1)))
    m = np.where(finite[..., None], means, 0.0)
    V = np.where(finite[..., None, None], covariances, np.eye(means.shape[-1]))
    i, j = np.array(pairs(len(m))).T
    mean_covariances, differences = 0.5 * (V[i] + V[j]), m[i] - m[j]
    squares = (differences * np.linalg.solve(mean_covariances, differences[..., None])[..., 0]).sum(axis=-1)
    log_determinants = np.linalg.slogdet(V)[1]
    overlaps = np.exp(
        -squares / 8.0
        - 0.5 * (np.linalg.slogdet(mean_covariances)[1] - 0.5 * (log_determinants[i] + log_determinants[j]))
    )
    is_compared = finite[i] & finite[j]
    sigma_distances = np.sqrt(np.where(is_compared, squares, 0.0))
    return (
        np.linalg.norm(differences, axis=-1) * is_compared,
        sigma_distances,
        np.where(is_compared, overlaps, 1.0),
    )


def information(probabilities: Array, overlaps: Array) -> Array:
    """Return a lower bound of the expected information at S places [nat], (S,).

    - probabilities: probabilities of the explanations, which add up to 1, (n,)
    - overlaps: overlaps of the predictions of each pair of explanations, see `separations`, (P, S)
    """
    count = len(probabilities)
    similarities, (i, j) = np.ones((count, count, overlaps.shape[1])), np.array(pairs(count)).T
    similarities[i, j] = similarities[j, i] = overlaps
    return np.asarray(-probabilities @ np.log(np.einsum("j,ijs->is", probabilities, similarities)))
