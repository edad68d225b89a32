"""The lines of frequency responses that a fit uses, relative to each sensor's size, with their noise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.identification.frf_noise import (
    MAX_LAG,
    coherence_variance,
    difference_variance,
    exponential_correlation,
)

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Minimum number of lines in which a mode can be distinguished from noise.
MIN_LINES = 24
#: Lines this close to a multiple of a tone are left out, in line spacings: a tone between two lines shows in both.
TONE_REACH = 1.01
#: Lines closer to a tone than this, in line spacings, contain all of it that a spectral window (Hann's) spreads.
TONE_SPREAD = 2.1


@dataclass(frozen=True, eq=False)
class FrequencyLines:
    """Functions to be fitted.

    - frequencies: (F,) [Hz]
    - grid_index: indices on the grid of lines, (F,)
    - H: (F, S, R); NaN where not measured
    - variance: variance of the noise, (F, S, R), as far as known beforehand
    - correlation: correlation of the noise at lags of lines, if known
    - has_absolute_variance: whether the variance is absolute, and not only right in its relative size
    """

    frequencies: Array
    grid_index: NDArray[np.int64]
    H: Complex
    variance: Array
    correlation: Complex | None
    has_absolute_variance: bool

    @property
    def measured(self) -> NDArray[np.bool_]:
        """Which functions were measured, (S, R)."""
        return np.asarray(np.isfinite(self.H).all(axis=0))

    @property
    def step(self) -> float:
        """Distance of the lines [Hz]."""
        return float(np.median(np.diff(self.frequencies)))

    def weights(self) -> Array:
        """Return the inverse standard deviation of each sensor's lines, (F, S), 0 for dead sensors."""
        finite = np.isfinite(self.variance)
        mean = np.where(finite, self.variance, 0.0).sum(axis=2) / np.maximum(finite.sum(axis=2), 1)
        return np.where(mean > 0.0, 1.0 / np.sqrt(np.where(mean > 0.0, mean, 1.0)), 0.0)


def select_lines(
    f: Array,
    H: Complex,
    coherence: Array | None,
    averages: int | None,
    window_time_constant: float | None,
    tones: Sequence[float],
    found_tones: Sequence[float] = (),
) -> tuple[FrequencyLines, Array]:
    """Return the lines that are used, relative to the rms of each sensor, and these rms values.

    Lines at a multiple of a stated tone and around a tone that was found are left out.
    """
    measured = np.isfinite(H).all(axis=0)
    alive = measured & (np.abs(np.where(measured, H, 0.0)).max(axis=0, initial=0.0) > 0.0)
    if len(f) < MIN_LINES:
        problem = f"expected at least {MIN_LINES} lines, found {len(f)}"
        raise MeasurementError(problem, "the band", "measure with a finer line spacing, or use a wider band")
    if not alive.any():
        raise MeasurementError("expected a function without gaps, found none", "the band", "check the files")
    mean_squares: Array = np.where(alive, (np.abs(np.where(alive, H, 0.0)) ** 2).mean(axis=0), np.nan)
    scale = np.sqrt(np.array([np.nanmean(row) if np.isfinite(row).any() else 1.0 for row in mean_squares]))
    step = float(np.median(np.diff(f)))
    used = ~tone_mask(f, tones, step)
    for tone in found_tones:
        used &= np.abs(f - tone) > TONE_SPREAD * step
    if used.sum() < MIN_LINES:
        problem = f"expected at least {MIN_LINES} lines beside the tones, found {int(used.sum())}"
        raise MeasurementError(problem, "tones", "state only tones that the signals have")
    values = np.where(alive, H, np.nan)[used] / scale[:, None]
    variance = difference_variance(values)
    absolute = coherence is not None and averages is not None
    if coherence is not None:
        coherence_based = coherence_variance(values, coherence[used], averages or 2)
        if not absolute:  # the coherence shows how the variance changes over the lines, not its size
            coherence_based = coherence_based * np.median(
                variance / np.maximum(coherence_based, 1e-300), axis=0
            )
        variance = coherence_based
        variance = _moving_average(np.maximum(variance, 1e-3 * difference_variance(values)))
    correlation = (
        None
        if window_time_constant is None
        else exponential_correlation(step, window_time_constant, MAX_LAG * 4)
    )
    grid_index = np.round((f[used] - f[0]) / step).astype(np.int64)
    return FrequencyLines(f[used], grid_index, values, variance, correlation, absolute), scale


def tone_mask(f: Array, tones: Sequence[float], step: float) -> NDArray[np.bool_]:
    """Return which lines are at a multiple of a tone."""
    mask = np.zeros(len(f), bool)
    for tone in tones:
        multiple = np.maximum(np.round(f / tone), 1.0)
        mask |= np.abs(f - multiple * tone) < TONE_REACH * step
    return mask


def _moving_average(variance: Array, width: int = 9) -> Array:
    """Return a moving average over the lines: the coherence of few averages scatters."""
    kernel = np.ones(width)
    count = np.convolve(np.ones(len(variance)), kernel, "same")
    flat = variance.reshape(len(variance), -1)
    smooth = np.stack([np.convolve(column, kernel, "same") / count for column in flat.T], axis=1)
    return np.asarray(smooth.reshape(variance.shape))
