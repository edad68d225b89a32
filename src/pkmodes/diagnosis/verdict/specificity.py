"""Specificity: whether the data suffice to tell a cause from something outside the candidates.

The residual of a cause outside the candidates may look like a candidate by chance, especially with few data.  The
probability is estimated by simulation: residuals as large as the measured one, drawn from changes of the structure
that are not candidates, are compared with the linear signature of every candidate.  There are two kinds of draws:
`arbitrary` changes, independent in all setups, and `plausible` ones, combinations of the candidates.  A draw has the
size of what the claim explains and leaves, and of what noise would hide; it looks like a candidate that explains as
much of it as the claim does of the residual.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis, orthonormal
from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.search.score import Directions, score
from pkmodes.diagnosis.search.search import Search
from pkmodes.diagnosis.verdict import arbitrary
from pkmodes.diagnosis.verdict.plausible import Plausible

#: Number of draws of each kind, and their seed.
DRAWS, SEED = 2_000, 20_221_107


def p_coincidence(search: Search, final: Fit) -> float:
    """Return the probability that as many candidates explain a residual of this size that none of them caused."""
    store, fitter, h = search.store, search.store.fitter, final.hypothesis
    plain = store.fit(Hypothesis(excluded=h.excluded, scatter=h.scatter))
    if plain is None or not final.causes:
        return 0.0
    rng = np.random.default_rng(SEED)
    gain, directions = plain.chi2 - final.chi2, search.gate(plain).scores.directions
    used, data = fitter.used(h), slice(0, fitter.prior_rows.start)
    degrees = float(used.sum() + fitter.shapes.count[used].sum() - plain.leverage[data].sum())
    drawn = arbitrary.draws(fitter, plain, DRAWS, rng)
    p_value = _coincidence(search, final, gain, drawn, directions, degrees, final.chi2)
    # A few candidates do not represent what else may be wrong: a combination of them says nothing.
    every = (*directions, *score(fitter, plain, search.remote).directions)
    many = search.criteria.many * len(final.causes)
    if gain <= 0.0 or len(every) < many:
        return p_value
    plausible = Plausible.of(every, float(np.sqrt(gain)))
    if plausible.different >= min(many, len(plausible.axes)):
        along = [(plausible.axes.T @ axes, sign) for axes, sign in directions]
        drawn, left = plausible.draws(DRAWS, rng), plausible.squares(final.white)
        p_value = max(p_value, _coincidence(search, final, gain, drawn, along, plausible.resolved, left))
    return p_value


def _coincidence(
    search: Search,
    final: Fit,
    gain: float,
    drawn: Array,
    directions: Directions,
    degrees: float,
    squares: float,
) -> float:
    """Return the fraction of changes that some candidates explain as well as the claimed causes do the residual.

    Parameters
    ----------
    gain : float
        Decrease of chi2 by the claimed causes.
    drawn : ndarray, shape (D, n)
        Effects of changes on the data, of any size.
    directions : sequence of (ndarray, int)
        Those of the candidates, in the same D coordinates.
    degrees : float
        Number of directions in which the changes differ.
    squares : float
        Sum of squares that the claimed causes leave in these directions.
    """
    left = degrees - sum(len(cause.parameters) for cause in final.causes)
    if left <= 0.0:
        return 1.0
    # What the claim leaves beyond noise, another cause may leave too, and noise hides as much again.
    size = gain + max(squares - left, 0.0) + search.criteria.spread * float(np.sqrt(2.0 * left))
    sized = drawn * (np.sqrt(size) / np.maximum(np.linalg.norm(drawn, axis=0), 1e-300))
    reached = np.zeros(drawn.shape[1], dtype=bool)
    for some in combinations(directions, len(final.causes)):
        reached |= _gain(sized, some) >= gain
    return float(reached.mean())


def _gain(residuals: Array, causes: Directions) -> Array:
    """Return the squares that causes remove from residuals (D, n), at best."""
    (axes, sign), *others = causes
    if not others and sign:
        along = axes[:, 0] @ residuals
        return np.where(along > 0.0, along**2, 0.0)
    basis = axes if not others else orthonormal(np.hstack([axes for axes, _ in causes]))
    gain: Array = ((basis.T @ residuals) ** 2).sum(axis=0)
    return gain
