"""What speaks against an explanation of damping: a trend in its residual, and laws that would look like it.

An explanation is specific if few laws outside the candidates look like it.  In such a law the damping ratio of each
mode differs from that of the explanation by a random factor, the same at all setups, and the measurements scatter as
stated.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.damping.fit import PARTS, LossFit, LossFitter
from pkmodes.loop.diagnosis.problem import Array

#: A trend that the fitted losses reproduce up to this sum of squares, in standard deviations, cannot be seen.
UNSEEN = 1.0
#: Number of laws drawn, and their seed.
DRAWS, SEED = 200, 5
#: Number of Gauss-Newton steps, and the largest change of a logarithm in one step.
STEPS, LARGEST = 20, 1.0
#: Curvature added for each logarithm, since that of a vanishing loss is 0.
FLAT = 1e-3


def p_of_trend(fitter: LossFitter, fit: LossFit) -> float:
    """Return the p-value of a trend of the residuals with the logarithm of the frequency."""
    rows = fitter.observations
    used = rows.above & (np.arange(fit.count) != (-1 if fit.outlier is None else fit.outlier))
    ratio = rows.ratios(fit.values) + rows.least
    fitted = (
        rows.by_loss[:, list(fit.free)] * fit.values[list(fit.free)] / ratio[:, None] / rows.sigma[:, None]
    )[used]
    trend = ((np.log(rows.frequency) - np.log(rows.frequency).mean()) / rows.sigma)[used]
    trend = trend - fitted @ np.linalg.lstsq(fitted, trend)[0]
    size = float(trend @ trend)
    if size < UNSEEN:
        return 1.0
    return float(stats.chi2.sf((trend @ fit.white[: fit.count][used]) ** 2 / size, 1))


def p_coincidence(fitter: LossFitter, fit: LossFit) -> float:
    """Return the fraction of laws outside the candidates that are explained by as many candidates as were found."""
    c, rows = fitter.criteria, fitter.observations.some(fitter.observations.above)
    fitter = fitter.of(rows)
    rng = np.random.default_rng(SEED)
    numbers, mode = np.unique(rows.mode, return_inverse=True)
    levels = c.damping.spread * rng.standard_normal((DRAWS, len(numbers)))
    noise = rows.sigma * rng.standard_normal((DRAWS, len(mode)))
    drawn = rows.predicted(fit.values) + levels[:, mode] + noise
    least = np.min(
        [
            _squares(fitter, fit, causes, drawn, start)
            for causes in combinations(fitter.candidates, len(fit.causes))
            for start in range(len(causes))
        ],
        axis=0,
    )
    return float(np.mean(least < stats.chi2.isf(c.gate.level, max(len(mode) - len(fit.causes), 1))))


def _squares(fitter: LossFitter, fit: LossFit, causes: tuple[int, ...], drawn: Array, largest: int) -> Array:
    """Return the least sum of squares of each draw over the values of some losses, (draws,)."""
    rows, index = fitter.observations, list(causes)
    weight = 1.0 / rows.sigma
    of_others = np.where(np.isin(np.arange(len(fitter.losses)), fit.causes), fitter.declared, fit.values)
    of_others[index] = 0.0
    rest = rows.ratios(of_others) + rows.least
    by_unit = rows.by_loss[:, index] * fitter.typical[index]
    parts = np.where(np.arange(len(causes)) == largest, PARTS[0], PARTS[1])
    x = np.tile(np.log(parts), (len(drawn), 1))
    for _ in range(STEPS):
        contributions = np.exp(x)[:, None, :] * by_unit
        ratio = contributions.sum(axis=-1) + rest
        residual = weight * (drawn - np.log(ratio))
        rates = weight[:, None] * contributions / ratio[..., None]
        square = np.swapaxes(rates, 1, 2) @ rates + FLAT * np.eye(len(causes))
        step = np.linalg.solve(square, np.swapaxes(rates, 1, 2) @ residual[..., None])[..., 0]
        x = x + np.clip(step, -LARGEST, LARGEST)
    residual = weight * (drawn - np.log((np.exp(x)[:, None, :] * by_unit).sum(axis=-1) + rest))
    return np.asarray(np.einsum("dr,dr->d", residual, residual))
