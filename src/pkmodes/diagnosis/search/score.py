r"""The score test: whether what is left points in the direction of a candidate.

At a fit, the whitened residual r is orthogonal to the derivatives by everything that was fitted.  A candidate
with whitened signature g, projected off those, has the score

.. math:: z = g^T r / |g| ,

a standard normal number where the hypothesis is true, and Delta chi^2 = z^2 to be gained; a candidate with several
parameters has a chi-square number.  One-sided candidates count only in the direction that physics allows.
Looking at many candidates at once, the smallest of their p-values is judged by its own distribution, which is
simulated with the correlations that the signatures have: a limit of 5 % for each would give far more than 5 %.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array, Candidate

#: Draws of the smallest p-value under the hypothesis, and their seed.
DRAWS = 20_000
SEED = 20_221_107
#: A signature of which less than this fraction is left after the projection has no direction.
LEFT = 1e-4


@dataclass(frozen=True)
class Score:
    """Score of one candidate at a fit.

    Attributes
    ----------
    candidate : Candidate
    p_value : float
        Of this candidate alone.
    gain : float
        chi2 that a linear model would gain.
    step : ndarray, shape (k,)
        Change of the candidate's parameters that would gain it, within their signs.
    sigma : ndarray, shape (k,)
        Standard deviations that the data would give the parameters; infinite where they do not tell.
    largest : ndarray, shape (k,)
        Largest relative change of a measured frequency by one unit of each parameter.
    visible : bool
        Whether anything of the signatures is left after the projection.
    """

    candidate: Candidate
    p_value: float
    gain: float
    step: Array
    sigma: Array
    largest: Array
    visible: bool


@dataclass(frozen=True)
class Scores:
    """Scores of all candidates at a fit.

    Attributes
    ----------
    each : tuple of Score
    directions : tuple of (ndarray, int)
        Orthonormal directions of the candidates' signatures, and the sign that physics allows, 0 for both.
    """

    each: tuple[Score, ...]
    directions: tuple[tuple[Array, int], ...]

    @property
    def bound(self) -> float:
        """A p-value that the best candidate among so many cannot exceed."""
        return min(1.0, min((s.p_value for s in self.each), default=1.0) * max(len(self.directions), 1))

    @cached_property
    def p_value(self) -> float:
        """Of the best candidate among so many; it takes some time, and is evaluated when it is asked for."""
        return _smallest(self.directions, min((s.p_value for s in self.each), default=1.0))


def score(fitter: Fitter, fit: Fit, candidates: Sequence[Candidate]) -> Scores:
    """Test every candidate that the hypothesis does not have yet.

    Parameters
    ----------
    fitter : Fitter
    fit : Fit
    candidates : sequence of Candidate
    """
    by = [i for candidate in candidates for i in fitter.indices(candidate)]
    if not by:
        return Scores((), ())
    rates, raw = fitter.signatures(fit, by)
    basis = fit.basis
    left = raw - basis @ (basis.T @ raw)
    unit = np.abs(rates)
    found, directions, start = [], [], 0
    for candidate in candidates:
        columns = slice(start, start + len(candidate.parameters))
        start = columns.stop
        result, axes = _one(fitter, fit, candidate, raw[:, columns], left[:, columns], unit[:, columns])
        found.append(result)
        if result.visible:
            directions.append((axes, one_sided(fitter, candidate)))
    return Scores(tuple(found), tuple(directions))


def _one(
    fitter: Fitter, fit: Fit, candidate: Candidate, raw: Array, left: Array, unit: Array
) -> tuple[Score, Array]:
    size, data = np.linalg.norm(left, axis=0), slice(0, fitter.prior_rows.start)
    whole = np.linalg.norm(raw[data], axis=0)
    seen = np.linalg.norm(left[data], axis=0) > LEFT * np.maximum(whole, 1e-300)
    largest = unit.max(axis=0, initial=0.0)
    step = np.zeros(left.shape[1])
    if not seen.any():
        return Score(candidate, 1.0, 0.0, step, np.full(len(step), np.inf), largest, False), left
    # Several parameters may do the same, or one of them nothing: they count by the directions that they span.
    u, s, vt = np.linalg.svd(left[:, seen] / size[seen], full_matrices=False)
    axes, s, vt = u[:, s > LEFT], s[s > LEFT], vt[s > LEFT]
    sigma = np.full(len(step), np.inf)
    if len(s) == seen.sum():
        sigma[seen] = np.linalg.norm(vt / s[:, None], axis=0) / size[seen]
    projection = axes.T @ fit.white
    step[seen] = (vt.T @ (projection / s)) / size[seen]
    sign = one_sided(fitter, candidate)
    gain = float(projection @ projection)
    if sign:
        z = float(np.sign(step[0]) * sign * np.sqrt(gain))
        p_value = float(stats.norm.sf(z))
        if z <= 0.0:
            gain, step = 0.0, np.zeros_like(step)
        axes = axes * (np.sign(vt[0, 0]) * sign)
    else:
        p_value = float(stats.chi2.sf(gain, axes.shape[1]))
    return Score(candidate, p_value, gain, step, sigma, largest, True), axes


def one_sided(fitter: Fitter, candidate: Candidate) -> int:
    """Sign that physics allows, 0 for both: a single parameter whose declared value is its bound."""
    if len(candidate.parameters) != 1:
        return 0
    p = fitter.parameters[fitter.indices(candidate)[0]]
    return 1 if p.value <= p.lower else -1 if p.value >= p.upper else 0


def _smallest(directions: Sequence[tuple[Array, int]], observed: float) -> float:
    """Probability of a p-value as small as the one observed, under the hypothesis."""
    if not directions:
        return 1.0
    count = len(directions)
    if observed * count < 1.0 / DRAWS:  # beyond what draws resolve; the bound is close there
        return observed * count
    stacked = np.hstack([axes for axes, _ in directions])
    correlation = stacked.T @ stacked
    values, vectors = np.linalg.eigh(correlation)
    rng = np.random.default_rng(SEED)
    normal = rng.standard_normal((DRAWS, len(values))) * np.sqrt(np.maximum(values, 0.0)) @ vectors.T
    reached, start = np.zeros(DRAWS, dtype=bool), 0
    for axes, sign in directions:  # a p-value is as small where its statistic is as large
        part = normal[:, start : start + axes.shape[1]]
        start += axes.shape[1]
        if sign:
            reached |= part[:, 0] >= stats.norm.isf(observed)
        else:
            reached |= (part**2).sum(axis=1) >= stats.chi2.isf(observed, axes.shape[1])
    return float(np.clip(reached.mean(), 1.0 / DRAWS, 1.0))
