"""Reasons to doubt an explanation of damping: a trend in its residual, and laws that would look like it.

An explanation is specific if few laws outside the candidates look like it.  In such a law the damping ratio of each
mode differs from that of the explanation by a random factor, the same at all setups, and the measurements scatter as
stated.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.damping.fit import START_FRACTIONS, LossFit, LossFitter
from pkmodes.loop.diagnosis.problem import Array

#: A trend is invisible if the fitted losses reproduce it but for less than this whitened sum of squares.
MIN_VISIBLE_TREND = 1.0
#: Number of laws drawn, and their seed.
DRAWS, SEED = 200, 5
#: Number of Gauss-Newton steps, and the largest change of a logarithm in one step.
STEPS, MAX_STEP = 20, 1.0
#: Curvature added for each logarithm, since the curvature of a vanishing loss is 0.
ADDED_CURVATURE = 1e-3


def p_of_trend(fitter: LossFitter, fit: LossFit) -> float:
    """Return the p-value of a trend of the residuals with the logarithm of the frequency."""
    rows = fitter.observations
    used_mask = rows.resolved_mask & (np.arange(fit.count) != (-1 if fit.outlier is None else fit.outlier))
    ratio = rows.ratios(fit.values) + rows.ratio_floor
    fitted = (
        rows.coefficients[:, list(fit.free)]
        * fit.values[list(fit.free)]
        / ratio[:, None]
        / rows.sigma[:, None]
    )[used_mask]
    trend = ((np.log(rows.frequency) - np.log(rows.frequency).mean()) / rows.sigma)[used_mask]
    trend = trend - fitted @ np.linalg.lstsq(fitted, trend)[0]
    size = float(trend @ trend)
    if size < MIN_VISIBLE_TREND:
        return 1.0
    return float(stats.chi2.sf((trend @ fit.white[: fit.count][used_mask]) ** 2 / size, 1))


def p_coincidence(fitter: LossFitter, fit: LossFit) -> float:
    """Return the fraction of laws outside the candidates that are explained by as many candidates as were found."""
    c, rows = fitter.criteria, fitter.observations.select(fitter.observations.resolved_mask)
    fitter = fitter.with_observations(rows)
    rng = np.random.default_rng(SEED)
    mode_numbers, mode = np.unique(rows.mode, return_inverse=True)
    log_factors = c.damping.spread * rng.standard_normal((DRAWS, len(mode_numbers)))
    noise = rows.sigma * rng.standard_normal((DRAWS, len(mode)))
    draws = rows.predicted_logarithms(fit.values) + log_factors[:, mode] + noise
    least_squares = np.min(
        [
            _least_squares_of_draws(fitter, fit, causes, draws, start)
            for causes in combinations(fitter.candidates, len(fit.causes))
            for start in range(len(causes))
        ],
        axis=0,
    )
    return float(np.mean(least_squares < stats.chi2.isf(c.gate.level, max(len(mode) - len(fit.causes), 1))))


def _least_squares_of_draws(
    fitter: LossFitter, fit: LossFit, causes: tuple[int, ...], draws: Array, largest_cause: int
) -> Array:
    """Return the least sum of squares of each draw over the values of some losses, (draws,)."""
    rows, columns = fitter.observations, list(causes)
    weight = 1.0 / rows.sigma
    other_values = np.where(np.isin(np.arange(len(fitter.losses)), fit.causes), fitter.declared, fit.values)
    other_values[columns] = 0.0
    fixed_ratios = rows.ratios(other_values) + rows.ratio_floor
    by_unit = rows.coefficients[:, columns] * fitter.typical_values[columns]
    parts = np.where(np.arange(len(causes)) == largest_cause, START_FRACTIONS[0], START_FRACTIONS[1])
    log_values = np.tile(np.log(parts), (len(draws), 1))
    for _ in range(STEPS):
        contributions = np.exp(log_values)[:, None, :] * by_unit
        ratio = contributions.sum(axis=-1) + fixed_ratios
        residual = weight * (draws - np.log(ratio))
        rates = weight[:, None] * contributions / ratio[..., None]
        normal_matrix = np.swapaxes(rates, 1, 2) @ rates + ADDED_CURVATURE * np.eye(len(causes))
        step = np.linalg.solve(normal_matrix, np.swapaxes(rates, 1, 2) @ residual[..., None])[..., 0]
        log_values = log_values + np.clip(step, -MAX_STEP, MAX_STEP)
    residual = weight * (
        draws - np.log((np.exp(log_values)[:, None, :] * by_unit).sum(axis=-1) + fixed_ratios)
    )
    return np.asarray(np.einsum("dr,dr->d", residual, residual))
