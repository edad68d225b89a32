"""Predictions for the measured modes: the partner of each, and how well frequency and shape agree."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.loop.diagnosis.problem import Array, Prediction
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import FREQUENCY

#: Modes above this multiple of the highest measured frequency are padding of a setup with fewer modes than others.
PADDING_MULTIPLE = 1e6


@dataclass(frozen=True, eq=False)
class Predicted:
    """Predictions of one model for all R measured modes at S setups, with m elastic modes each.

    - frequency: frequency of the partner, (R,) [Hz], NaN if the mode is unmatched
    - mode: number of the partner among the elastic modes of its setup, from 1, (R,); 0 if unmatched
    - sigmas: ln(f_model / f_measured) in standard deviations of the measurement, including its position error, (R,);
      NaN if unmatched
    - mac: MAC with the partner, or with the subspace of the partners of close modes, (R,); NaN without shape or
      partner
    - macs: MAC with each elastic mode of the setup, (R, m); NaN without shape
    - spectrum: frequencies of the elastic modes of each setup, (S, m) [Hz], ascending; modes that pad a setup are NaN
    """

    frequency: Array
    mode: NDArray[np.intp]
    sigmas: Array
    mac: Array
    macs: Array
    spectrum: Array

    @classmethod
    def of(
        cls, pairer: Pairer, data: Measurements, prediction: Prediction, pairing: Pairing, sigma: Array
    ) -> Predicted:
        """Return the predictions for paired measurements.

        - pairing: of all rows
        - sigma: standard deviations of ln f, (R,)
        """
        paired = pairing.partner >= 0
        logs = prediction.log_frequencies
        partner_logs = np.where(paired, logs[data.pose, np.maximum(pairing.partner, 0)], np.nan)
        return cls(
            frequency=np.exp(partner_logs),
            mode=np.where(paired, pairing.partner - prediction.rigid + 1, 0),
            sigmas=(partner_logs - FREQUENCY.transformed(data)) / sigma,
            mac=pairing.mac,
            macs=pairer.macs(prediction),
            spectrum=spectrum_of(prediction, data),
        )


def spectrum_of(prediction: Prediction, data: Measurements) -> Array:
    """Return the frequencies of the elastic modes of each setup [Hz], (S, m), see `Predicted`."""
    with np.errstate(over="ignore"):
        spectrum = np.exp(prediction.log_frequencies[:, prediction.rigid :])
    return np.where(spectrum < PADDING_MULTIPLE * data.frequency.max(), spectrum, np.nan)
