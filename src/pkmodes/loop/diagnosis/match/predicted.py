"""Predictions for the measured modes: the partner of each, and how well frequency and shape agree."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.loop.diagnosis.problem import Array, Prediction
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import FREQUENCY

#: A setup with fewer modes than others is padded with modes above this multiple of the highest measured frequency.
PADDING_MULTIPLE = 1e6


@dataclass(frozen=True, eq=False)
class PartnerPredictions:
    """Predictions of one model for all R measured modes at S setups, with m elastic modes each.

    A partner of another shape is none (`Pairer.told`), though it is the one with which a fit compares the mode.

    - frequency: frequency of the partner, (R,) [Hz], NaN if the mode is unmatched
    - partner_mode: number of the partner among the elastic modes of its setup, from 1, (R,); 0 if unmatched
    - normalised_differences: ln(f_model / f_measured) in standard deviations of the measurement, including its
      position error, (R,); NaN if unmatched
    - partner_mac: MAC with the partner, or with a subspace of it and modes close to it, (R,); NaN without shape or
      partner
    - fitted_mac: MAC as a fit has it, whose subspace is that of the partners of close rows, (R,); NaN likewise
    - mac_by_mode: MAC with each elastic mode of the setup, (R, m); NaN without shape
    - elastic_frequencies: those of each setup, (S, m) [Hz], ascending; modes that pad a setup are NaN
    - nearest_frequency, nearest_mac: frequency [Hz] and MAC of the nearest mode of the model if that has another
      shape, so that the row is unmatched, (R,); NaN elsewhere
    """

    frequency: Array
    partner_mode: NDArray[np.intp]
    normalised_differences: Array
    partner_mac: Array
    fitted_mac: Array
    mac_by_mode: Array
    elastic_frequencies: Array
    nearest_frequency: Array
    nearest_mac: Array

    @classmethod
    def from_pairing(
        cls, pairer: Pairer, data: Measurements, prediction: Prediction, pairing: Pairing, sigma: Array
    ) -> PartnerPredictions:
        """Return the predictions for paired measurements.

        - pairing: pairing of all rows
        - sigma: standard deviations of ln f, (R,)
        """
        mac, has_other_shape = pairer.told(prediction, pairing)
        is_paired = (pairing.partner >= 0) & ~has_other_shape
        nearest_logs = prediction.log_frequencies[data.pose, np.maximum(pairing.partner, 0)]
        partner_logs = np.where(is_paired, nearest_logs, np.nan)
        return cls(
            frequency=np.exp(partner_logs),
            partner_mode=np.where(is_paired, pairing.partner - prediction.rigid + 1, 0),
            normalised_differences=(partner_logs - FREQUENCY.transformed(data)) / sigma,
            partner_mac=np.where(is_paired, mac, np.nan),
            fitted_mac=np.where(is_paired, pairing.mac, np.nan),
            mac_by_mode=pairer.macs(prediction),
            elastic_frequencies=elastic_frequencies_of(prediction, data),
            nearest_frequency=np.exp(np.where(has_other_shape, nearest_logs, np.nan)),
            nearest_mac=np.where(has_other_shape, mac, np.nan),
        )


def elastic_frequencies_of(prediction: Prediction, data: Measurements) -> Array:
    """Return the frequencies of the elastic modes of each setup [Hz], (S, m), see `PartnerPredictions`."""
    with np.errstate(over="ignore"):
        elastic_frequencies = np.exp(prediction.log_frequencies[:, prediction.rigid :])
    return np.where(
        elastic_frequencies < PADDING_MULTIPLE * data.frequency.max(), elastic_frequencies, np.nan
    )
