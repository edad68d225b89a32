r"""Whether data are enough to tell a cause from something that nobody has thought of.

What a cause outside the candidates leaves points anywhere.  One of many candidates explains it all the same if its
signature is close enough to that direction by chance: in d dimensions the part of a squared length that is left
beside k given directions has a beta distribution, Beta((d - k) / 2, k / 2).  The fewer the dimensions, the likelier
it is that what is left passes for noise.

The data have fewer dimensions than numbers.  An arbitrary small change of a structure, with independent relative
changes :math:`\xi_{ij} = \xi_{ji}` of its modal stiffnesses and :math:`\eta_{ij} = \eta_{ji}` of its modal
masses, gives

.. math:: d \ln f_i = \tfrac12 (\xi_{ii} - \eta_{ii}), \qquad
    d\phi_i = \sum_{j \ne i} \phi_j \frac{\sqrt{\lambda_i \lambda_j} \, \xi_{ij} - \lambda_i \eta_{ij}}
    {\lambda_i - \lambda_j} ,

so that shapes change mostly by those of neighbouring modes, and those of two neighbours together.  The effective
number of dimensions is the participation ratio of such changes in the whitened data,
:math:`(\sum s^2)^2 / \sum s^4` over their singular values, beside what the nuisances explain.
"""

from __future__ import annotations

from math import comb

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.problem import Prediction
from pkmodes.diagnosis.search.search import Search

#: With more rows than this the number of dimensions is large anyhow.
ROWS = 60
#: Modes beyond the highest measured one whose shapes are mixed into it.
ABOVE = 3


def p_coincidence(search: Search, final: Fit) -> float:
    """Probability that some hypothesis with as many causes explains an arbitrary residual of this size."""
    store, fitter = search.store, search.store.fitter
    h = final.hypothesis
    plain = store.fit(Hypothesis(excluded=h.excluded, scatter=h.scatter))
    if plain is None or not final.causes:
        return 0.0
    c, used = search.criteria, fitter.used(h)
    free = sum(len(cause.parameters) for cause in final.causes)
    count = float(used.sum() + fitter.shapes.count[used].sum())
    data = slice(0, fitter.prior_rows.start)
    degrees = count - float(plain.leverage[data].sum())
    tried = comb(len(search.candidates), len(final.causes))
    one = _explains(
        max(plain.chi2 - degrees, plain.chi2 - final.chi2),
        min(dimensions(fitter, plain), degrees),
        degrees - free,
        free,
        level=c.surely,
        clear=float(stats.chi2.isf(c.claimed / max(tried, 1), free)),
    )
    return float(-np.expm1(tried * np.log1p(-min(one, 1.0 - 1e-16))))


def dimensions(fitter: Fitter, plain: Fit) -> float:
    """Effective number of dimensions of what arbitrary changes of the structure do to the data beside a fit.

    Setups count as independent of each other, as where a structure differs from one to the next.  Infinite where
    there are more than `ROWS` rows.
    """
    square, fourth, used = 0.0, 0.0, fitter.used(plain.hypothesis)
    data = fitter.prior_rows.start
    if len(used) > ROWS:
        return np.inf
    # Modes far above the measured ones take no part in their shapes.
    modes = int(plain.pairing.partner.max(initial=0)) + 1 + ABOVE
    changed = _changed(plain.prediction, modes, fitter.criteria.mixed)
    changes = fitter.rows.rates(changed, plain.pairing, used) / fitter.noise.stated[:, None]
    for place in fitter.places():
        own = np.zeros((len(plain.white), changes.shape[1]))
        own[place] = changes[place]
        own -= plain.basis @ (plain.basis[:data].T @ own[:data])
        s = np.linalg.svd(own, compute_uv=False)
        square, fourth = square + float((s**2).sum()), fourth + float((s**4).sum())
    return square**2 / fourth if fourth > 0.0 else 0.0


def _changed(prediction: Prediction, modes: int, least: float) -> Prediction:
    """The lowest modes, with derivatives with respect to all relative changes of modal stiffnesses and masses."""
    found, shapes = prediction.eigenvalues[:, :modes], prediction.shapes[:, :modes]
    m = found.shape[1]
    i, j = np.triu_indices(m)
    size = np.abs(found)
    gap = found[:, i] - found[:, j]
    # Modes that nearly coincide turn into each other with any change; they are compared as one space.
    smallest = 2.0 * least * np.maximum(size[:, i], size[:, j])
    gap = np.where(gap >= 0.0, 1.0, -1.0) * np.maximum(np.abs(gap), np.maximum(smallest, 1e-300))
    mean = np.sqrt(size[:, i] * size[:, j])
    rates = np.zeros((len(found), m, 2, len(i)))
    along = np.zeros((*shapes.shape, 2, len(i)))
    for t in np.flatnonzero(i == j):
        rates[:, i[t], 0, t], rates[:, i[t], 1, t] = found[:, i[t]], -found[:, i[t]]
    for t in np.flatnonzero(i != j):
        for a, b, sign in ((i[t], j[t], 1.0), (j[t], i[t], -1.0)):
            along[:, a, :, 0, t] = sign * (mean / gap)[:, t, None] * shapes[:, b]
            along[:, a, :, 1, t] = -sign * (size[:, a] / gap[:, t])[:, None] * shapes[:, b]
    return Prediction(
        found,
        rates.reshape(len(found), m, -1),
        shapes,
        prediction.rigid,
        along.reshape(*shapes.shape, -1),
    )


def _explains(
    excess: float, dimensions: float, degrees: float, free: int, *, level: float, clear: float
) -> float:
    """Probability that k directions explain a residual in d dimensions so well that it would be claimed.

    Parameters
    ----------
    excess : float
        Squared length of the residual beyond noise.
    dimensions : float
    degrees : float
        Of freedom of what is left.
    free : int
        Number of directions.
    level : float
        What is left has to pass for noise with more than this probability.
    clear : float
        Gain below which nothing is claimed.
    """
    rest = dimensions - free
    if rest <= 0.0 or degrees <= 0.0 or excess <= clear:  # too small to be claimed for: it says nothing
        return 1.0
    noise = float(stats.chi2.isf(level, degrees)) - degrees
    most = min(noise / excess, 1.0 - clear / excess)
    return float(stats.beta.cdf(most, 0.5 * rest, 0.5 * free))
