"""Unmeasured modes of a model between the measured ones.

Not every mode is measured at every pose, and the rate of misses is unknown, so a single missing mode means little.
But if a cause adds modes between measured ones and none of them was measured, their absence needs an explanation:
given the numbers of modes and of missed modes there, the added modes should be missed no more often than by chance
(hypergeometric distribution; Fisher's exact test).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit


class ModeCounts(NamedTuple):
    """Number of modes of a model between the measured ones, and of unmeasured ones among them."""

    modes: int
    unmeasured: int


def count_modes(fitter: Fitter, fit: Fit) -> ModeCounts:
    """Count the modes of a fit between the lowest and highest measured ones of each setup."""
    margin, log_frequencies = fitter.criteria.gate.margin, fit.prediction.log_frequencies
    used_row_mask, is_visible = fitter.used_row_mask(fit.hypothesis), _visible_modes(fitter, fit)
    observations, paired_count, unmeasured = fitter.observations, int((fit.pairing.partner >= 0).sum()), 0
    for setup, rows in enumerate(observations.noise.rows):
        if not len(rows):
            continue
        # A test may have stopped after the highest mode, whatever its band: modes above it carry no information.
        low = observations.log_frequencies[rows].min() + margin
        high = observations.log_frequencies[rows].max() - margin
        modes_between = np.flatnonzero(
            (log_frequencies[setup] > low) & (log_frequencies[setup] < high) & is_visible[setup]
        )
        modes_between = modes_between[modes_between >= fit.prediction.rigid]
        unpaired_modes = modes_between[~np.isin(modes_between, fit.pairing.partner[rows])]
        # An excluded row may have measured one of them.
        unmeasured += max(len(unpaired_modes) - int((~used_row_mask[rows]).sum()), 0)
    return ModeCounts(paired_count + unmeasured, unmeasured)


def _visible_modes(fitter: Fitter, fit: Fit) -> NDArray[np.bool_]:
    """Return a mask of the modes that move the sensors enough; all if no sensor is known."""
    pairer = fitter.observations.pairer
    shapes, moves = fit.prediction.shapes[..., pairer.columns], pairer.motion
    if not shapes.shape[-1]:
        return np.ones(shapes.shape[:2], dtype=bool)
    peaks = np.sqrt(np.mean((shapes / np.where(moves > 0.0, moves, np.inf)[:, None]) ** 2, axis=-1))
    median_peaks = np.median(peaks[:, fit.prediction.rigid :], axis=1)
    return np.asarray(peaks >= fitter.criteria.gate.visible * median_peaks[:, None])


def p_unmeasured(fitter: Fitter, declared: Fit, fit: Fit) -> float:
    """Return the p-value of the number of missed modes among those that a fit adds to the declared model.

    It is 1 if at least half of the added modes were measured.  If no sensor is known, modes may be missed because
    they move no sensor, and their absence counts half as much.
    """
    declared_counts, counts = count_modes(fitter, declared), count_modes(fitter, fit)
    missed = max(counts.unmeasured - declared_counts.unmeasured, 0)
    measured = max(counts.modes - counts.unmeasured - declared_counts.modes + declared_counts.unmeasured, 0)
    if missed <= measured:
        return 1.0
    total = counts.modes + 1  # with one more that might exist
    p = float(stats.hypergeom.sf(missed - 1, total, counts.unmeasured, min(missed + measured, total)))
    return p if len(fitter.observations.pairer.columns) else float(np.sqrt(p))


class NeverMeasured(NamedTuple):
    """A mode that was never measured: lowest and highest frequency [Hz], number of setups, and the drives there."""

    low: float
    high: float
    setups: int
    drives: str


def never_measured(fitter: Fitter, fit: Fit) -> list[NeverMeasured]:
    """Return the modes that should have been measured at half of the setups or more, but never were.

    Modes with free motors differ from those with held motors, even if they have the same number.
    """
    margin, log_frequencies = fitter.criteria.gate.margin, fit.prediction.log_frequencies
    is_visible, missing_modes = _visible_modes(fitter, fit), []
    is_measured = np.zeros(log_frequencies.shape, dtype=bool)
    is_paired = fit.pairing.partner >= 0
    is_measured[fitter.data.pose[is_paired], fit.pairing.partner[is_paired]] = True
    low, high = (np.full(len(log_frequencies), value) for value in (np.inf, -np.inf))
    if fitter.data.band is None:
        np.minimum.at(low, fitter.data.pose, fitter.observations.log_frequencies)
        np.maximum.at(high, fitter.data.pose, fitter.observations.log_frequencies)
    else:
        low[:], high[:] = np.log(fitter.data.band)
    is_inside = (
        (log_frequencies > low[:, None] + margin) & (log_frequencies < high[:, None] - margin) & is_visible
    )
    for drives in dict.fromkeys(fitter.data.drives):
        same_drives = np.array(fitter.data.drives) == drives
        for k in range(fit.prediction.rigid, log_frequencies.shape[1]):
            is_expected = is_inside[:, k] & same_drives
            count = int(is_expected.sum())
            if count >= max(2, same_drives.sum() / 2) and not is_measured[same_drives, k].any():
                frequencies = np.exp(log_frequencies[is_expected, k])
                missing_modes.append(
                    NeverMeasured(float(frequencies.min()), float(frequencies.max()), count, drives)
                )
    return missing_modes
