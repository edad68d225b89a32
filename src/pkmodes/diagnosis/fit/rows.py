"""Residuals of measured rows, frequencies and shapes, and their derivatives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.fit.shapes import ShapeRows
from pkmodes.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.diagnosis.problem import Array, Prediction

#: Relative gap of eigenvalues below which the derivatives of single modes are not defined.
REPEATED = 1e-7


@dataclass(frozen=True)
class Rows:
    """R measured rows with C shape components each.

    Attributes
    ----------
    shapes : ShapeRows
    copies : int
        Number of copies of the measurements among the rows.
    """

    pairer: Pairer
    shapes: ShapeRows
    copies: int = 1

    def tiled(self, count: int) -> Rows:
        """Return `count` copies, for predictions of `count` times the setups, the first copy first."""
        return Rows(self.pairer.tiled(count), self.shapes.tiled(count), count)

    def of_each(self, values: Array) -> Array:
        """Reshape the data of all copies, (B R + B R C, ...), to (B, R + R C, ...)."""
        rows = len(self.pairer.pose)
        parts = [part.reshape(self.copies, -1, *values.shape[1:]) for part in (values[:rows], values[rows:])]
        return np.concatenate(parts, axis=1)

    def residual(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Return measured minus model for frequencies and shapes, (R + R C,)."""
        frequencies = np.where(used, self.pairer.differences(prediction, pairing), 0.0)
        if not self.shapes.size:
            return frequencies
        return np.concatenate([frequencies, self.shapes.residual(prediction, pairing, used).ravel()])

    def rates(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Return the derivatives of the predictions with respect to the requested parameters, (R + R C, T)."""
        rates = _averaged(prediction)
        derivatives = rates[self.pairer.pose, np.maximum(pairing.partner, 0)]
        derivatives = np.where(((pairing.partner >= 0) & used)[:, None], derivatives, 0.0)
        if self.shapes.size:
            shapes = self.shapes.rates(prediction, pairing, used)
            derivatives = np.vstack([derivatives, -shapes.reshape(self.shapes.size, derivatives.shape[1])])
        # A step may lead to a mode at 0 Hz, whose logarithm has no derivative.
        return np.asarray(np.where(np.isfinite(derivatives), derivatives, 0.0))


def _averaged(prediction: Prediction) -> Array:
    """Return the derivatives of ln f; repeated modes, whose derivatives are not defined, get the group's mean."""
    rates = np.array(prediction.log_rates)
    eigenvalues = prediction.eigenvalues
    gap = np.diff(eigenvalues, axis=1) <= REPEATED * np.abs(eigenvalues[:, 1:])
    for setup in np.flatnonzero(gap.any(axis=1)):
        number = np.concatenate([[0], np.cumsum(~gap[setup])])
        for k in np.flatnonzero(np.bincount(number) > 1):
            members = number == k
            if np.isfinite(rates[setup, members]).all():  # rigid modes have none at 0 Hz
                rates[setup, members] = rates[setup, members].mean(axis=0)
    return rates
