"""Comparison of two readings of the data: the distance of each from the model, and which is far better."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.match.pairing import Pairer
from pkmodes.loop.diagnosis.problem import Array, Prediction
from pkmodes.loop.measured.measurements import Measurements


class ModelDistances(NamedTuple):
    """Distances of the data from a model, as in the file and with another reading."""

    as_filed: float
    other_reading: float

    def far_better(self, gain: float, limit: float = np.inf) -> bool:
        """Return whether the other reading is nearer by a factor, and near enough."""
        return self.other_reading <= limit and self.other_reading * gain <= self.as_filed


def frequency_differences(
    fitter: Fitter, prediction: Prediction, data: Measurements
) -> tuple[Array, NDArray[np.bool_]]:
    """Return the differences of the logarithms of the frequencies, nothing fitted, and which rows have a partner.

    The differences are infinite where the model cannot be evaluated.
    """
    all_rows = np.ones(len(data.frequency), dtype=bool)
    if not np.isfinite(prediction.eigenvalues).all():
        return np.full(len(all_rows), np.inf), ~all_rows
    pairer = Pairer(data, fitter.structure.channels, prediction, fitter.criteria)
    pairing = pairer.pair(prediction, all_rows, compare=False)
    return pairer.differences(prediction, pairing), pairing.partner >= 0
