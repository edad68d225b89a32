"""Bounded nonlinear least squares in whitened residuals, and the covariance at its solution."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import least_squares

from pkmodes.core.linalg.decomposition import thin_svd
from pkmodes.loop.diagnosis.problem import Array

#: Largest unit of a variable, in widths of its range: in larger units both bounds would be the same number.
MAX_UNIT_RANGES = 1e6
#: Largest unit of a variable, in multiples of its start value: in larger units that value would be lost to rounding.
MAX_UNIT_MULTIPLE = 1e9
#: Smallest length of the first step, in standard deviations.
MIN_FIRST_STEP = 10.0


def bounded_least_squares(
    residual: Callable[[Array], Array],
    rates: Callable[[Array], Array],
    values: Array,
    free: Sequence[int],
    bounds: tuple[Array, Array],
    steps: int,
) -> tuple[Array, bool]:
    """Minimise the sum of squares over some of the values.

    - residual: whitened residual (D,) for all values
    - rates: derivatives of the residual with respect to the free values, (D, k)
    - values: start values, (P,)
    - free: indices of the k free values
    - bounds: lower and upper bounds of the free values, each (k,)
    - steps: largest number of evaluations of the residual

    Returns, in this order:
    - values: (P,)
    - converged
    """
    if not free:
        return values, True
    index, (lower, upper) = list(free), bounds
    start_values = np.clip(values[index], lower, upper)

    # The variables are in standard deviations, so the solver's tolerances are independent of units; and they start
    # away from 0, because the first step is as long as the start vector: an absent cause would stay absent.
    start = values.copy()
    start[index] = start_values
    column_norms = np.linalg.norm(rates(start), axis=0)
    # A variable that hardly affects the data has an enormous standard deviation.
    unit = np.minimum(
        1.0 / np.where(column_norms > 0.0, column_norms, 1.0), MAX_UNIT_RANGES * (upper - lower)
    )
    unit = np.where(start_values != 0.0, np.minimum(unit, MAX_UNIT_MULTIPLE * np.abs(start_values)), unit)
    origin = start_values - np.maximum(np.abs(start_values), MIN_FIRST_STEP * unit)

    def values_at(u: Array) -> Array:
        all_values = values.copy()
        all_values[index] = np.clip(origin + u * unit, lower, upper)
        return all_values

    def residual_at(u: Array) -> Array:
        return residual(values_at(u))

    def jacobian(u: Array) -> Array:
        return np.asarray(rates(values_at(u)) * unit)

    with np.errstate(over="ignore", invalid="ignore"):  # a fit may try impossible values
        solution = least_squares(
            residual_at,
            (start_values - origin) / unit,
            jacobian,
            ((lower - origin) / unit, (upper - origin) / unit),
            ftol=1e-6,
            xtol=1e-8,
            gtol=1e-8,
            max_nfev=steps,
        )
    return values_at(solution.x), bool(solution.status > 0)


def correlation(covariance: Array) -> Array:
    """Return the correlation matrix of a covariance, 1 on its diagonal."""
    size = np.sqrt(np.diagonal(covariance))
    scaled = covariance / np.outer(size, size)
    np.fill_diagonal(scaled, 1.0)
    return np.asarray(scaled)


def inverse_of_square(jacobian: Array) -> Array:
    """Return the inverse of J^T J with scaled columns; undetermined parameters get a very large variance."""
    if not jacobian.shape[1]:
        return np.zeros((0, 0))
    size = np.linalg.norm(jacobian, axis=0)
    scale = np.where(size > 0.0, 1.0 / np.where(size > 0.0, size, 1.0), 1.0)
    _, s, vt = thin_svd(jacobian * scale)
    weights = 1.0 / np.maximum(s, 1e-8) ** 2
    inverse: Array = (vt.T * weights) @ vt * scale[:, None] * scale
    return inverse
