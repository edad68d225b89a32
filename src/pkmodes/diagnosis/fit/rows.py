"""Measured rows held against predictions: what is left of frequencies and shapes, and how it changes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.fit.shapes import ShapeRows
from pkmodes.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.diagnosis.problem import Array, Prediction

#: Close eigenvalues: below this relative gap the derivatives of single modes are not defined.
REPEATED = 1e-7


@dataclass(frozen=True)
class Rows:
    """R measured rows with C shape components each.

    Attributes
    ----------
    pairer : Pairer
    shapes : ShapeRows
    copies : int
        How many times the measurements are among the rows.
    """

    pairer: Pairer
    shapes: ShapeRows
    copies: int = 1

    def tiled(self, count: int) -> Rows:
        """So many copies, for predictions of so many times the setups, those of the first copy first."""
        return Rows(self.pairer.tiled(count), self.shapes.tiled(count), count)

    def of_each(self, values: Array) -> Array:
        """Data of all copies, (B R + B R C, ...), as those of each, (B, R + R C, ...)."""
        rows = len(self.pairer.pose)
        parts = [part.reshape(self.copies, -1, *values.shape[1:]) for part in (values[:rows], values[rows:])]
        return np.concatenate(parts, axis=1)

    def residual(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Measured minus model: frequencies and shapes, (R + R C,)."""
        frequencies = np.where(used, self.pairer.differences(prediction, pairing), 0.0)
        if not self.shapes.size:
            return frequencies
        return np.concatenate([frequencies, self.shapes.residual(prediction, pairing, used).ravel()])

    def rates(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Derivatives of what the partners predict with respect to the parameters asked for, (R + R C, T)."""
        rates = _averaged(prediction)
        found = rates[self.pairer.pose, np.maximum(pairing.partner, 0)]
        found = np.where(((pairing.partner >= 0) & used)[:, None], found, 0.0)
        if self.shapes.size:
            shapes = self.shapes.rates(prediction, pairing, used)
            found = np.vstack([found, -shapes.reshape(self.shapes.size, found.shape[1])])
        # A step may have led to a mode at 0 Hz, whose logarithm has no derivative.
        return np.asarray(np.where(np.isfinite(found), found, 0.0))


def _averaged(prediction: Prediction) -> Array:
    """Derivatives of ln f; those of repeated modes, which have none of their own, are the group's mean."""
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
