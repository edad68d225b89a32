r"""Specificity: whether few data suffice to tell a cause from something outside the candidates.

The residual of a cause outside the candidates may look like a candidate by chance, especially with few data.  The
probability is estimated by simulation: residuals as large as the measured one, drawn from changes of the structure
that are not candidates, are compared with the linear signature of every candidate.  There are two kinds of draws.

*Arbitrary changes*, with independent relative changes :math:`\xi_{ij} = \xi_{ji}` of the modal stiffnesses and
:math:`\eta_{ij} = \eta_{ji}` of the modal masses, give

.. math:: d \ln f_i = \tfrac12 (\xi_{ii} - \eta_{ii}), \qquad
    d\phi_i = \sum_{j \ne i} \phi_j \frac{\sqrt{\lambda_i \lambda_j} \, \xi_{ij} - \lambda_i \eta_{ij}}
    {\lambda_i - \lambda_j} :

each shape changes mostly by the shapes of neighbouring modes, and the shapes of two neighbours change together, so
twelve shape values carry less information than twelve independent ones.  *Many small changes* are changes of all
candidates at once, each with the same weight.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis, orthonormal
from pkmodes.diagnosis.problem import Array, Prediction
from pkmodes.diagnosis.search.search import Search

#: Number of draws of each kind, and their seed.
DRAWS, SEED = 2_000, 20_221_107
#: Modes beyond the highest measured one whose shapes are mixed into it.
ABOVE = 3


def p_coincidence(search: Search, final: Fit) -> float:
    """Return the probability that as many candidates explain a residual of this size that none of them caused.

    It is taken as zero for more than `Criteria.few_rows` rows.
    """
    store, fitter, c = search.store, search.store.fitter, search.criteria
    h = final.hypothesis
    plain = store.fit(Hypothesis(excluded=h.excluded, scatter=h.scatter))
    used = fitter.used(h)
    if plain is None or not final.causes or used.sum() > c.few_rows:
        return 0.0
    free = sum(len(cause.parameters) for cause in final.causes)
    data = slice(0, fitter.prior_rows.start)
    degrees = float(used.sum() + fitter.shapes.count[used].sum() - plain.leverage[data].sum())
    left = degrees - free
    excess = max(plain.chi2 - degrees, plain.chi2 - final.chi2)
    clear = float(stats.chi2.isf(c.claimed / max(len(search.candidates), 1), free))
    if left <= 0.0 or excess <= clear:
        return 1.0
    most = max(final.chi2 - left, 0.0) + c.spread * float(np.sqrt(2.0 * left))
    directions = search.gate(plain).scores.directions
    rng = np.random.default_rng(SEED)
    probabilities, kinds = [], [arbitrary(fitter, plain)]
    if len(directions) >= c.many * len(final.causes):
        kinds.append(np.hstack([axes for axes, _ in directions]))
    for changes in kinds:
        drawn = changes @ rng.standard_normal((changes.shape[1], DRAWS))
        drawn *= np.sqrt(excess) / np.maximum(np.linalg.norm(drawn, axis=0), 1e-300)
        probabilities.append(_explained(drawn, directions, len(final.causes), max(clear, excess - most)))
    return max(probabilities)


def _explained(drawn: Array, directions: tuple[tuple[Array, int], ...], causes: int, needed: float) -> float:
    """Return the fraction of the residuals (D, n) that some combination of causes reduces by as much as needed."""
    reached = np.zeros(drawn.shape[1], dtype=bool)
    for some in combinations(directions, causes):
        signs = [sign for _, sign in some]
        if causes == 1 and signs[0]:
            along = some[0][0][:, 0] @ drawn
            gain = np.where(along > 0.0, along**2, 0.0)
        else:
            basis = some[0][0] if causes == 1 else orthonormal(np.hstack([axes for axes, _ in some]))
            gain = ((basis.T @ drawn) ** 2).sum(axis=0)
        reached |= gain >= needed
    return float(reached.mean())


def arbitrary(fitter: Fitter, plain: Fit) -> Array:
    """Return the effect of arbitrary structural changes on the whitened data beside a fit, (D, T).

    The changes in different setups are independent, as if the structure differed between them.
    """
    used, data = fitter.used(plain.hypothesis), fitter.prior_rows.start
    # Modes far above the measured ones do not contribute to their shapes.
    modes = int(plain.pairing.partner.max(initial=0)) + 1 + ABOVE
    changed = _changed(plain.prediction, modes, fitter.criteria.mixed)
    changes = fitter.rows.rates(changed, plain.pairing, used) / fitter.noise.stated[:, None]
    parts = []
    for place in fitter.places():
        if len(place):
            own = np.zeros((len(plain.white), changes.shape[1]))
            own[place] = changes[place]
            parts.append(own - plain.basis @ (plain.basis[:data].T @ own[:data]))
    return np.hstack(parts)


def _changed(prediction: Prediction, modes: int, least: float) -> Prediction:
    """Return the lowest modes with their derivatives with respect to relative changes of modal stiffness and mass."""
    eigenvalues, shapes = prediction.eigenvalues[:, :modes], prediction.shapes[:, :modes]
    m = eigenvalues.shape[1]
    i, j = np.triu_indices(m)
    size = np.abs(eigenvalues)
    gap = eigenvalues[:, i] - eigenvalues[:, j]
    # Nearly coincident modes rotate into each other under any change; they are compared as one subspace.
    smallest = 2.0 * least * np.maximum(size[:, i], size[:, j])
    gap = np.where(gap >= 0.0, 1.0, -1.0) * np.maximum(np.abs(gap), np.maximum(smallest, 1e-300))
    mean = np.sqrt(size[:, i] * size[:, j])
    rates = np.zeros((len(eigenvalues), m, 2, len(i)))
    along = np.zeros((*shapes.shape, 2, len(i)))
    for t in np.flatnonzero(i == j):
        rates[:, i[t], 0, t], rates[:, i[t], 1, t] = eigenvalues[:, i[t]], -eigenvalues[:, i[t]]
    for t in np.flatnonzero(i != j):
        for a, b, sign in ((i[t], j[t], 1.0), (j[t], i[t], -1.0)):
            along[:, a, :, 0, t] = sign * (mean / gap)[:, t, None] * shapes[:, b]
            along[:, a, :, 1, t] = -sign * (size[:, a] / gap[:, t])[:, None] * shapes[:, b]
    return Prediction(
        eigenvalues,
        rates.reshape(len(eigenvalues), m, -1),
        shapes,
        prediction.rigid,
        along.reshape(*shapes.shape, -1),
    )
