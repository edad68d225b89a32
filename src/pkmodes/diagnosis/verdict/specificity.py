"""Whether data are enough to tell a cause from something that nobody has thought of.

What a cause outside the candidates leaves points anywhere.  One of many candidates explains it all the same if its
signature is close enough to that direction by chance: in d dimensions the part of a squared length that is left
beside k given directions has a beta distribution, Beta((d - k) / 2, k / 2), and the fewer the data, the likelier it
is that what is left passes for noise.
"""

from __future__ import annotations

from math import comb

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.search.search import Search


def p_coincidence(search: Search, final: Fit) -> float:
    """Probability that some hypothesis with as many causes explains an arbitrary residual of this size.

    Frequencies and shapes count separately: a residual in one of them says nothing about the other.
    """
    store, fitter = search.store, search.store.fitter
    h = final.hypothesis
    plain = store.fit(Hypothesis(excluded=h.excluded, scatter=h.scatter))
    if plain is None or not final.causes:
        return 0.0
    used, c = fitter.used(h), search.criteria
    free = sum(len(cause.parameters) for cause in final.causes)
    frequencies = float((1.0 - plain.leverage[fitter.frequency_rows])[used].sum())
    shapes = float(fitter.shapes.count[used].sum() - plain.leverage[fitter.shape_rows].sum())
    squares = store.frequency_misfit(plain)[0], float((plain.white[fitter.shape_rows] ** 2).sum())
    after = store.frequency_misfit(final)[0], float((final.white[fitter.shape_rows] ** 2).sum())
    gains = squares[0] - after[0], squares[1] - after[1]
    tried = comb(len(search.candidates), len(final.causes))
    clear = float(stats.chi2.isf(c.claimed / max(tried, 1), free))
    one = min(
        _explains(max(squares[0] - frequencies, gains[0]), frequencies, free, c.surely, clear)
        * _explains(max(squares[1] - shapes, gains[1]), shapes, free, c.surely, clear),
        1.0 - 1e-16,
    )
    return float(-np.expm1(tried * np.log1p(-one)))


def _explains(excess: float, dimensions: float, free: int, level: float, clear: float) -> float:
    """Probability that k directions explain a residual in d dimensions so well that it would be claimed.

    Parameters
    ----------
    excess : float
        Squared length of the residual beyond noise.
    dimensions : float
    free : int
        Number of directions.
    level : float
        What is left has to pass for noise with more than this probability.
    clear : float
        Gain below which nothing is claimed.
    """
    rest = dimensions - free
    if rest <= 0.0 or excess <= clear:  # too small to be claimed for: it says nothing for or against
        return 1.0
    noise = float(stats.chi2.isf(level, rest)) - rest
    most = min(noise / excess, 1.0 - clear / excess)
    return float(stats.beta.cdf(most, 0.5 * rest, 0.5 * free))
