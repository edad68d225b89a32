r"""The score test: whether the residual points to a candidate.

At a fit, the whitened residual r is orthogonal to the derivatives with respect to the fitted parameters.  A candidate
with whitened signature g, with these derivatives projected out, has the score

.. math:: z = g^T r / |g| ,

which is standard normal if the hypothesis is true; a linear model gains Delta chi^2 = z^2.  The statistic of a
candidate with several parameters is chi-square distributed.  One-sided candidates count only in the direction that
physics allows.  With many candidates, the smallest p-value is judged by its own distribution, simulated with the
correlations of the signatures: a level of 5 % for each would give far more than 5 % false alarms.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import stats

from pkmodes.core.linalg.decomposition import thin_svd
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Array, Candidate

#: Orthonormal directions of candidates' signatures (D, k), and the sign that physics allows, 0 for both.
Directions = Sequence[tuple[Array, int]]
#: Number of draws of the smallest p-value under the hypothesis, and their seed.
DRAWS = 20_000
SEED = 20_221_107
#: Largest number of directions drawn by their correlations; for more, the eigenvectors would take longer.
MAX_DIRECTIONS_CORRELATED = 200
#: Smallest fraction of a signature that must remain after the projection for it to have a direction.
MIN_REMAINDER = 1e-4


@dataclass(frozen=True)
class Score:
    """Score of one candidate at a fit.

    - p_value: p-value of this candidate alone
    - gain: decrease of chi2 that the linear model promises
    - step: corresponding change of the candidate's parameters, within their signs, (k,)
    - sigma: standard deviations of the parameters from these data, (k,); infinite if the data do not determine them
    - largest_rates: largest relative change of a measured frequency per unit of each parameter, (k,)
    - is_visible: whether any signature remains after the projection
    """

    candidate: Candidate
    p_value: float
    gain: float
    step: Array
    sigma: Array
    largest_rates: Array
    is_visible: bool


@dataclass(frozen=True)
class Scores:
    """Scores of all candidates at a fit.

    - directions: orthonormal directions of the candidates' signatures, and the sign that physics allows, 0 for both
    """

    by_candidate: tuple[Score, ...]
    directions: tuple[tuple[Array, int], ...]

    @property
    def bound(self) -> float:
        """An upper bound of the p-value of the best candidate, by Bonferroni's inequality."""
        return min(
            1.0, min((s.p_value for s in self.by_candidate), default=1.0) * max(len(self.directions), 1)
        )

    @cached_property
    def p_value(self) -> float:
        """The p-value of the best candidate, corrected for their number; evaluated on demand, as it takes time."""
        return p_of_smallest(self.directions, min((s.p_value for s in self.by_candidate), default=1.0))


def score(fitter: Fitter, fit: Fit, candidates: Sequence[Candidate]) -> Scores:
    """Test candidates that the hypothesis does not have yet."""
    indices = [i for candidate in candidates for i in fitter.parameter_indices(candidate)]
    if not indices:
        return Scores((), ())
    rates, signatures = fitter.signatures(fit, indices)
    basis = fit.basis
    remainder = signatures - basis @ (basis.T @ signatures)
    rate_magnitudes = np.abs(rates)
    scores, directions, first_column = [], [], 0
    for candidate in candidates:
        columns = slice(first_column, first_column + len(candidate.parameters))
        first_column = columns.stop
        candidate_score, axes = _score_of(
            fitter, fit, candidate, signatures[:, columns], remainder[:, columns], rate_magnitudes[:, columns]
        )
        scores.append(candidate_score)
        if candidate_score.is_visible:
            directions.append((axes, allowed_sign(fitter, candidate)))
    return Scores(tuple(scores), tuple(directions))


def _score_of(
    fitter: Fitter,
    fit: Fit,
    candidate: Candidate,
    signatures: Array,
    remainder: Array,
    rate_magnitudes: Array,
) -> tuple[Score, Array]:
    remainder_norms, data = np.linalg.norm(remainder, axis=0), slice(0, fitter.prior_slice.start)
    norms = np.linalg.norm(signatures[data], axis=0)
    is_visible = np.linalg.norm(remainder[data], axis=0) > MIN_REMAINDER * np.maximum(norms, 1e-300)
    largest_rates = rate_magnitudes.max(axis=0, initial=0.0)
    step = np.zeros(remainder.shape[1])
    if not is_visible.any():
        return Score(candidate, 1.0, 0.0, step, np.full(len(step), np.inf), largest_rates, False), remainder
    # Parameters may have the same effect, or none: the degrees of freedom are the directions that they span.
    u, s, vt = thin_svd(remainder[:, is_visible] / remainder_norms[is_visible])
    axes, s, vt = u[:, s > MIN_REMAINDER], s[s > MIN_REMAINDER], vt[s > MIN_REMAINDER]
    sigma = np.full(len(step), np.inf)
    if len(s) == is_visible.sum():
        sigma[is_visible] = np.linalg.norm(vt / s[:, None], axis=0) / remainder_norms[is_visible]
    projection = axes.T @ fit.white
    step[is_visible] = (vt.T @ (projection / s)) / remainder_norms[is_visible]
    sign = allowed_sign(fitter, candidate)
    gain = float(projection @ projection)
    if sign:
        z = float(np.sign(step[0]) * sign * np.sqrt(gain))
        p_value = float(stats.norm.sf(z))
        if z <= 0.0:
            gain, step = 0.0, np.zeros_like(step)
        axes = axes * (np.sign(vt[0, 0]) * sign)
    else:
        p_value = float(stats.chi2.sf(gain, axes.shape[1]))
    return Score(candidate, p_value, gain, step, sigma, largest_rates, True), axes


def allowed_sign(fitter: Fitter, candidate: Candidate) -> int:
    """Return the sign that physics allows, 0 for both: a single parameter whose declared value is its bound."""
    if len(candidate.parameters) != 1:
        return 0
    p = fitter.parameters[fitter.parameter_indices(candidate)[0]]
    return 1 if p.value <= p.lower else -1 if p.value >= p.upper else 0


def p_of_smallest(directions: Sequence[tuple[Array, int]], observed: float) -> float:
    """Return the probability under the hypothesis that the smallest p-value is at most the observed one.

    - directions: directions of all candidates that were tried, see `Scores`
    """
    if not directions:
        return 1.0
    count = len(directions)
    if observed * count < 1.0 / DRAWS:  # beyond the resolution of the draws; the bound is tight there
        return observed * count
    stacked, rng = np.hstack([axes for axes, _ in directions]), np.random.default_rng(SEED)
    if stacked.shape[1] > MAX_DIRECTIONS_CORRELATED:  # fewer data than directions: draw noise in all data
        draws = rng.standard_normal((DRAWS, len(stacked))) @ stacked
    else:
        values, vectors = np.linalg.eigh(stacked.T @ stacked)
        draws = rng.standard_normal((DRAWS, len(values))) * np.sqrt(np.maximum(values, 0.0)) @ vectors.T
    is_reached, first_column = np.zeros(DRAWS, dtype=bool), 0
    for axes, sign in directions:  # compare statistics, which is equivalent to comparing p-values
        coordinates = draws[:, first_column : first_column + axes.shape[1]]
        first_column += axes.shape[1]
        if sign:
            is_reached |= coordinates[:, 0] >= stats.norm.isf(observed)
        else:
            is_reached |= (coordinates**2).sum(axis=1) >= stats.chi2.isf(observed, axes.shape[1])
    return float(np.clip(is_reached.mean(), 1.0 / DRAWS, 1.0))
