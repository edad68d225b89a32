"""Bounded nonlinear least squares in whitened residuals, and the covariance at its solution."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import least_squares

from pkmodes.diagnosis.problem import Array

#: Length of the first step, at least, in standard deviations.
FIRST_STEP = 10.0


def bounded_least_squares(
    residual: Callable[[Array], Array],
    rates: Callable[[Array], Array],
    values: Array,
    free: Sequence[int],
    bounds: tuple[Array, Array],
    steps: int,
) -> tuple[Array, bool]:
    """Minimise the sum of squares over some of the values.

    Parameters
    ----------
    residual : callable
        Whitened residual (D,) for all values.
    rates : callable
        Its derivatives (D, k) with respect to the free ones.
    values : ndarray, shape (P,)
        Where to begin.
    free : sequence of int
        The k values that may change.
    bounds : tuple of two ndarrays, shape (k,)
    steps : int
        Evaluations of the residual, at most.

    Returns
    -------
    values : ndarray, shape (P,)
    converged : bool
        Whether the steps were enough.
    """
    if not free:
        return values, True
    index, (lower, upper) = list(free), bounds
    first = np.clip(values[index], lower, upper)

    # Solved in units of one standard deviation each, the solver's limits then mean the same in kg and in Pa; and
    # away from 0, because its first step is as long as its start: a cause that is absent would stay so.
    start = values.copy()
    start[index] = first
    size = np.linalg.norm(rates(start), axis=0)
    unit = 1.0 / np.where(size > 0.0, size, 1.0)
    origin = first - np.maximum(np.abs(first), FIRST_STEP * unit)

    def at(u: Array) -> Array:
        full = values.copy()
        full[index] = np.clip(origin + u * unit, lower, upper)
        return full

    def scaled(u: Array) -> Array:
        return residual(at(u))

    def jacobian(u: Array) -> Array:
        return np.asarray(rates(at(u)) * unit)

    found = least_squares(
        scaled,
        (first - origin) / unit,
        jacobian,
        ((lower - origin) / unit, (upper - origin) / unit),
        ftol=1e-6,
        xtol=1e-8,
        gtol=1e-8,
        max_nfev=steps,
    )
    return at(found.x), bool(found.status > 0)


def inverse_of_square(jacobian: Array) -> Array:
    """Inverse of J^T J, columns scaled; what the data do not determine gets a very large variance."""
    if not jacobian.shape[1]:
        return np.zeros((0, 0))
    size = np.linalg.norm(jacobian, axis=0)
    scale = np.where(size > 0.0, 1.0 / np.where(size > 0.0, size, 1.0), 1.0)
    _, s, vt = np.linalg.svd(jacobian * scale, full_matrices=False)
    weights = 1.0 / np.maximum(s, 1e-8) ** 2
    found: Array = (vt.T * weights) @ vt * scale[:, None] * scale
    return found
