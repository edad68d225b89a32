"""Residuals of measured frequencies, and the derivatives of the model's."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.loop.diagnosis.problem import Array, Prediction

#: Relative gap of eigenvalues below which the derivatives of single modes are not defined.
REPEATED_GAP = 1e-7


@dataclass(frozen=True)
class FrequencyRows:
    """The logarithms of R measured frequencies as data of a fit, a `ComparedQuantity`.

    - sigma: standard deviations of the logarithms, (R, 1)
    """

    pairer: Pairer
    sigma: Array
    shape_rates = False

    @property
    def known(self) -> NDArray[np.bool_]:
        """Every row has a frequency, (R,)."""
        return np.ones(len(self.sigma), dtype=bool)

    @property
    def stated(self) -> NDArray[np.bool_]:
        """Every frequency has a stated standard deviation, (R,)."""
        return self.known

    @property
    def count(self) -> NDArray[np.int_]:
        """One degree of freedom each, (R,)."""
        return np.ones(len(self.sigma), dtype=int)

    def tiled(self, count: int) -> FrequencyRows:
        """Return the same for predictions of `count` times the setups."""
        return FrequencyRows(self.pairer.tiled(count), np.tile(self.sigma, (count, 1)))

    def residual(self, prediction: Prediction, pairing: Pairing, used_row_mask: NDArray[np.bool_]) -> Array:
        """Return measured minus model in ln f, (R, 1); 0 for rows that are not used."""
        return np.where(used_row_mask, self.pairer.differences(prediction, pairing), 0.0)[:, None]

    def rates(self, prediction: Prediction, pairing: Pairing, used_row_mask: NDArray[np.bool_]) -> Array:
        """Return the derivatives of ln f with respect to the requested parameters, (R, 1, T).

        Repeated modes, whose derivatives are not defined, have the mean of their group.
        """
        rates_of_modes, eigenvalues = np.array(prediction.log_rates), prediction.eigenvalues
        is_repeated = np.diff(eigenvalues, axis=1) <= REPEATED_GAP * np.abs(eigenvalues[:, 1:])
        for setup in np.flatnonzero(is_repeated.any(axis=1)):
            group = np.concatenate([[0], np.cumsum(~is_repeated[setup])])
            for k in np.flatnonzero(np.bincount(group) > 1):
                members = group == k
                if np.isfinite(rates_of_modes[setup, members]).all():  # rigid modes have none at 0 Hz
                    rates_of_modes[setup, members] = rates_of_modes[setup, members].mean(axis=0)
        rates = rates_of_modes[self.pairer.pose, np.maximum(pairing.partner, 0)]
        return np.where(((pairing.partner >= 0) & used_row_mask)[:, None], rates, 0.0)[:, None]
