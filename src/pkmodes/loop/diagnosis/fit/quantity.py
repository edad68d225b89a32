"""A quantity of measured modes, such as their frequencies or shapes, as data of a fit."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.match.pairing import Pairing
from pkmodes.loop.diagnosis.problem import Array, Prediction

Mask = NDArray[np.bool_]


class ComparedQuantity(Protocol):
    """A quantity of R measured modes, with n components each."""

    @property
    def sigma(self) -> Array:
        """Standard deviations, (R, n)."""

    @property
    def known(self) -> Mask:
        """Rows that have the quantity, (R,)."""

    @property
    def stated(self) -> Mask:
        """Rows whose standard deviation the measurements state, (R,)."""

    @property
    def count(self) -> NDArray[np.int_]:
        """Degrees of freedom of each row, (R,); 0 for rows without the quantity."""

    @property
    def shape_rates(self) -> bool:
        """Whether its derivatives need those of the shapes of the model."""

    def tiled(self, count: int) -> ComparedQuantity:
        """Return the same for predictions of `count` times the setups, the first copy first."""

    def residual(self, prediction: Prediction, pairing: Pairing, used_row_mask: Mask) -> Array:
        """Return measured minus model, (R, n); 0 for rows that are not used."""

    def rates(self, prediction: Prediction, pairing: Pairing, used_row_mask: Mask) -> Array:
        """Return the derivatives of what the model predicts with respect to the requested parameters, (R, n, T)."""
