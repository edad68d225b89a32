r"""Covariance of the measurements: stated errors, an error that a setup's modes share, uncertain positions.

In each setup the log frequencies and the shapes have the covariance

.. math:: V = \mathrm{diag}(\sigma^2) + \tau^2 \, 1 1^T + J_x \Sigma_x J_x^T ,

where the shared error concerns only the frequencies.  An additional error absorbs the residual of an excluded row;
its stated error stays in the likelihood.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular
from scipy.optimize import minimize_scalar

from pkmodes.loop.diagnosis.fit.quantity import ComparedQuantity
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.measured.measurements import Measurements


@dataclass(frozen=True)
class Whitening:
    """Square root of V.

    - sigma: standard deviations of the uncorrelated data, (D,)
    - blocks: for each setup with correlated errors, the indices of its data and the Cholesky factor of its block of V
    - log_determinant: log determinant of V, up to a constant for the shapes' stated errors
    """

    sigma: Array
    blocks: tuple[tuple[NDArray[np.intp], Array], ...]
    log_determinant: float

    def whitened(self, values: Array) -> Array:
        """Divide by the square root of V: (D,) or (D, T)."""
        white: Array = (values.T / self.sigma).T
        for indices, factor in self.blocks:
            white[indices] = solve_triangular(factor, values[indices], lower=True, check_finite=False)
        return white


class Noise:
    """Errors of one set of measurements.

    - quantities: the frequencies first
    - most_shared: largest error that the modes of a setup may share

    Its attributes:
    - sigma: stated standard deviations of ln f, (R,)
    - stated_sigma: standard deviations of all data, without correlated errors, (D,)
    - rows: rows of each setup
    - uncertain: whether positions of setups are uncertain
    """

    def __init__(
        self, data: Measurements, quantities: Sequence[ComparedQuantity], most_shared: float
    ) -> None:
        self.stated_sigma = np.concatenate([quantity.sigma.ravel() for quantity in quantities])
        self.sigma: Array = self.stated_sigma[: len(data.pose)]
        order = np.argsort(data.pose, kind="stable")
        self.rows = np.split(order, np.searchsorted(data.pose[order], np.arange(1, len(data.labels))))
        self.uncertain = bool((data.point_sigma > 0.0).any())
        self._setup = data.pose
        self._position_sigma, self._most_shared = data.point_sigma, most_shared
        index_lists, start = [list[NDArray[np.intp]]() for _ in self.rows], 0
        for quantity in quantities:
            components = start + np.arange(quantity.sigma.size).reshape(quantity.sigma.shape)
            start += quantity.sigma.size
            for index_list, rows in zip(index_lists, self.rows, strict=True):
                index_list.append(components[rows[quantity.known[rows]]].ravel())
        self._data_of_setups = [np.concatenate(index_list) for index_list in index_lists]

    def whitening(
        self, position_rates: Array | None, used_row_mask: NDArray[np.bool_], tau: float
    ) -> Whitening:
        """Return the square root of V.

        - position_rates: derivatives of the data with respect to the d components of their setup's position, (D, d);
          None if no position is uncertain
        - used_row_mask: rows that are not excluded, (R,)
        - tau: standard deviation of the shared error
        """
        log_variances = 2.0 * np.log(self.sigma)
        if position_rates is None and tau == 0.0:
            return Whitening(self.stated_sigma, (), float(log_variances.sum()))
        blocks, log_determinant = [], 0.0
        for setup, rows in enumerate(self.rows):
            indices = rows if position_rates is None else self._data_of_setups[setup]
            V: Array = np.diag(self.stated_sigma[indices] ** 2)
            if position_rates is not None:
                V += (position_rates[indices] * self._position_sigma[setup] ** 2) @ position_rates[indices].T
            frequencies = np.arange(len(rows))
            V[np.ix_(frequencies, frequencies)] += tau**2
            excluded_rows = np.flatnonzero(~used_row_mask[rows])
            V[excluded_rows] = V[:, excluded_rows] = 0.0
            V[excluded_rows, excluded_rows] = self.sigma[rows][excluded_rows] ** 2
            factor = np.linalg.cholesky(V).astype(float)
            blocks.append((indices, factor))
            log_determinant += float(
                2.0 * np.log(np.diagonal(factor)).sum()
                - 2.0 * np.log(self.stated_sigma[indices[len(rows) :]]).sum()
            )
        return Whitening(self.stated_sigma, tuple(blocks), log_determinant)

    def standard_deviations(self, position_rates: Array | None) -> Array:
        """Return the standard deviations of ln f, (R,), including uncertain positions."""
        if position_rates is None:
            return self.sigma
        by_position = np.empty_like(self.sigma)
        for setup, rows in enumerate(self.rows):
            by_position[rows] = ((position_rates[rows] * self._position_sigma[setup]) ** 2).sum(axis=1)
        return np.asarray(np.sqrt(self.sigma**2 + by_position))

    def shared_error(
        self, residual: Array, position_rates: Array | None, used_row_mask: NDArray[np.bool_]
    ) -> float:
        """Return the most likely standard deviation of the error that the modes of a setup share."""

        def deviance(log_tau: float) -> float:
            if position_rates is None:
                return self._deviance(residual, used_row_mask, float(np.exp(log_tau)))
            whitening = self.whitening(position_rates, used_row_mask, float(np.exp(log_tau)))
            white = whitening.whitened(residual)
            return float(white @ white) + whitening.log_determinant

        min_log_tau = np.log(0.01 * np.median(self.sigma))
        minimum = minimize_scalar(deviance, bounds=(min_log_tau, np.log(self._most_shared)), method="bounded")
        return float(np.exp(minimum.x))

    def _deviance(self, residual: Array, used_row_mask: NDArray[np.bool_], tau: float) -> float:
        """Return the deviance if tau is the only correlation, by the matrix determinant lemma."""
        weights = np.where(used_row_mask, self.sigma**-2, 0.0)
        r = residual[: len(self.sigma)]
        weight_sums = np.bincount(self._setup, weights, len(self.rows))
        weighted_sums = np.bincount(self._setup, weights * r, len(self.rows))
        determinants = 1.0 + tau**2 * weight_sums
        squares = (weights * r**2).sum() - (tau**2 * weighted_sums**2 / determinants).sum()
        return float(squares + np.log(determinants).sum() + 2.0 * np.log(self.sigma).sum())
