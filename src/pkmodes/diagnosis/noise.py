r"""Covariance of measured frequencies: stated errors, an error that a setup's modes share, uncertain positions.

In each setup the logarithms of the frequencies have the covariance

.. math:: V = \mathrm{diag}(\sigma^2) + \tau^2 \, 1 1^T + J_x \Sigma_x J_x^T .

An excluded row is an error of its own beside the stated one, which stays in the likelihood.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from pkmodes.diagnosis.problem import Array
from pkmodes.measured.measurements import Measurements

#: Largest error that the modes of a setup may share: a larger one is no error of measuring.
LARGEST_SHARED = 0.05
Whitening = list[Array]


class Noise:
    """Errors of one set of measurements.

    Parameters
    ----------
    data : Measurements

    Attributes
    ----------
    sigma : ndarray, shape (R,)
        Standard deviations of ln f, as stated.
    rows : list of ndarray
        Rows of each setup.
    uncertain : bool
        Whether positions of setups are uncertain.
    """

    def __init__(self, data: Measurements) -> None:
        self.sigma = data.sigma / data.frequency
        self.rows = [np.flatnonzero(data.pose == i) for i in range(len(data.labels))]
        self.uncertain = bool((data.point_sigma > 0.0).any())
        self._position_sigma = data.point_sigma

    def whitening(self, motion: Array | None, used: NDArray[np.bool_], tau: float) -> Whitening:
        """Cholesky factors of V, one for each setup; vectors of standard deviations where V is diagonal.

        Parameters
        ----------
        motion : ndarray, shape (R, 3), or None
            Derivatives of ln f by the position of the setup, where it is uncertain.
        used : ndarray of bool, shape (R,)
            Rows that are not excluded.
        tau : float
            Standard deviation of the shared error.
        """
        if motion is None and tau == 0.0:
            return [self.sigma[rows] for rows in self.rows]
        factors: Whitening = []
        for setup, rows in enumerate(self.rows):
            V: Array = np.diag(self.sigma[rows] ** 2) + tau**2
            if motion is not None:
                V += (motion[rows] * self._position_sigma[setup] ** 2) @ motion[rows].T
            out = np.flatnonzero(~used[rows])
            V[out] = V[:, out] = 0.0
            V[out, out] = self.sigma[rows][out] ** 2
            factors.append(np.linalg.cholesky(V).astype(float))
        return factors

    def standard_deviations(self, motion: Array | None) -> Array:
        """Of ln f of each row, with the position's part where it is uncertain, (R,)."""
        if motion is None:
            return self.sigma
        by_position = np.empty_like(self.sigma)
        for setup, rows in enumerate(self.rows):
            by_position[rows] = ((motion[rows] * self._position_sigma[setup]) ** 2).sum(axis=1)
        return np.sqrt(self.sigma**2 + by_position)

    def whitened(self, values: Array, whitening: Whitening) -> Array:
        """Divide rows by the factors of V: (R,) or (R, T)."""
        found = np.empty_like(values)
        for index, factor in zip(self.rows, whitening, strict=True):
            if factor.ndim == 1:
                found[index] = (values[index].T / factor).T
            else:
                found[index] = np.linalg.solve(factor, values[index])
        return found

    def shared_error(self, residual: Array, motion: Array | None, used: NDArray[np.bool_]) -> float:
        """Most likely standard deviation of the error that the modes of a setup share."""

        def deviance(log_tau: float) -> float:
            factors = self.whitening(motion, used, float(np.exp(log_tau)))
            white = self.whitened(residual, factors)
            return float(white @ white) + log_determinant(factors)

        smallest = np.log(0.01 * np.median(self.sigma))
        found = minimize_scalar(deviance, bounds=(smallest, np.log(LARGEST_SHARED)), method="bounded")
        return float(np.exp(found.x))


def log_determinant(whitening: Whitening) -> float:
    """Logarithm of the determinant of V over all setups."""
    return float(sum(2.0 * np.log(f if f.ndim == 1 else np.diagonal(f)).sum() for f in whitening))
