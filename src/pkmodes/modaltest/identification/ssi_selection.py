"""Choice of modes among the clusters of poles, by whether a peak of their own exceeds the background.

A cluster over model orders (see `pkmodes.modaltest.identification.clusters`) may also be a bump of the noise or a
second description of a strong mode.  The shapes of modes accepted so far are removed from a candidate's by a modal
filter, the row of the pseudo-inverse of the shapes: what is left of a second description is noise.  The candidate is
accepted if a peak explains the power that passes its filter better than a smooth background, by a ratio of
likelihoods (`pkmodes.modaltest.identification.ssi_likelihood`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.estimates import complex_mac
from pkmodes.modaltest.identification.ssi_bands import SpectralLines
from pkmodes.modaltest.identification.ssi_likelihood import PeakFit, Powers, fit_peaks

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Log-likelihood ratio above which a peak is more than a bump of noise: three parameters, tried at about a hundred
#: places.
SIGNIFICANT = 12.0
#: Half range of a fit: in half bandwidths, and the minimum in lines.
HALF_WIDTHS, MIN_LINES = 10.0, 24.0
#: Largest factor by which a modal filter may reduce a mode relative to noise; neighbours beyond it are fitted in the
#: power.
MAX_AMPLIFICATION = 4.0
#: Modes farther away, up to this ratio of frequencies, are removed too if that costs no more than this factor: what
#: they add around a peak is coherent with it and shifts it.
MAX_FAR_AMPLIFICATION, MAX_FREQUENCY_RATIO = 1.5, 3.0
#: Decay rate times record length below which a line has no visible bandwidth.
MIN_RESOLVED_DECAYS = 1.5
#: Largest shift of a candidate by a fit, in sums of both half bandwidths, and largest factor on its bandwidth.
MAX_SHIFT, MAX_WIDENING = 0.75, 4.0
#: Half bandwidths of a peak that must be visible on either side.
VISIBLE_HALF_WIDTHS = 1.2
#: Highest damping ratio of a mode with a peak.
HIGHEST_DAMPING = 0.2


@dataclass(frozen=True, eq=False)
class RefinedMode:
    """A mode.

    - frequency, rate: frequency of the damped vibration [Hz], rate of decay [1/s]
    - covariance: covariance of frequency and logarithm of the rate, (2, 2)
    - shape: in the scale of the lines, (S,)
    - log_likelihood_ratio: logarithm of the ratio of likelihoods
    """

    frequency: float
    rate: float
    covariance: Array
    shape: Complex
    log_likelihood_ratio: float

    @property
    def pole(self) -> complex:
        """In 1/s."""
        return complex(-self.rate, 2.0 * math.pi * self.frequency)

    @property
    def undamped(self) -> float:
        """Undamped natural frequency [Hz]."""
        return abs(self.pole) / (2.0 * math.pi)


def starting_mode(pole: complex, shape: Complex) -> RefinedMode:
    """Return a candidate at a pole, before any fit."""
    return RefinedMode(pole.imag / (2.0 * math.pi), -pole.real, np.zeros((2, 2)), shape, math.inf)


def refine(
    mode: RefinedMode,
    neighbours: Sequence[RefinedMode],
    lines: Sequence[SpectralLines],
    ends: tuple[float, float],
    min_ratio: float = SIGNIFICANT,
) -> RefinedMode | None:
    """Return a mode refined beside its neighbours, None if no peak of its own remains.

    - lines: lines of pieces without padding
    - ends: ends of the range of lines that may be used [Hz]
    - min_ratio: least log-likelihood ratio
    """
    seconds = max(1.0 / piece.step for piece in lines)
    half_range = max(HALF_WIDTHS * mode.rate / (2.0 * math.pi), MIN_LINES / seconds)
    low, high = max(mode.frequency - half_range, ends[0]), min(mode.frequency + half_range, ends[1])
    nearby = [
        neighbour
        for neighbour in neighbours
        if low - 0.5 * half_range < neighbour.frequency < high + 0.5 * half_range
    ]
    far = [
        neighbour
        for neighbour in neighbours
        if neighbour not in nearby
        and 1 / MAX_FREQUENCY_RATIO < neighbour.frequency / mode.frequency < MAX_FREQUENCY_RATIO
    ]
    row, not_filtered = _modal_filter(mode, nearby, far)
    not_filtered = [neighbour for neighbour in not_filtered if low < neighbour.frequency < high]
    powers = _powers(lines, row, low, high)
    if len(powers.values) < 12:
        return None
    neighbour_starts = (
        [neighbour.frequency for neighbour in not_filtered],
        [max(neighbour.rate, 0.5 / seconds) for neighbour in not_filtered],
    )
    background = fit_peaks(powers, *neighbour_starts)
    fit = fit_peaks(
        powers, [mode.frequency, *neighbour_starts[0]], [max(mode.rate, 0.5 / seconds), *neighbour_starts[1]]
    )
    log_likelihood_ratio = fit.likelihood - background.likelihood
    return (
        _accept(mode, fit, log_likelihood_ratio, nearby, seconds, (low, high))
        if log_likelihood_ratio >= min_ratio
        else None
    )


def _accept(
    mode: RefinedMode,
    fit: PeakFit,
    log_likelihood_ratio: float,
    nearby: Sequence[RefinedMode],
    seconds: float,
    ends: tuple[float, float],
) -> RefinedMode | None:
    f, rate = float(fit.frequencies[0]), float(fit.rates[0])
    in_range = ends[0] < f < ends[1] and rate < HIGHEST_DAMPING * 2.0 * math.pi * f
    if rate * seconds < MIN_RESOLVED_DECAYS or not in_range:
        return None
    # a fit that moved to another peak than the candidate's has the wrong shape
    if abs(f - mode.frequency) > MAX_SHIFT * (rate + mode.rate) / (2.0 * math.pi) + 1.0 / seconds:
        return None
    width = rate / (2.0 * math.pi)
    visible = ends[0] < f - VISIBLE_HALF_WIDTHS * width and f + VISIBLE_HALF_WIDTHS * width < ends[1]
    if rate > MAX_WIDENING * (mode.rate + 5.0 / seconds) or not visible:
        return None
    for neighbour in nearby:
        distance = 2.0 * math.pi * abs(f - neighbour.frequency) / (rate + neighbour.rate)
        if distance < 0.5 and complex_mac(mode.shape, neighbour.shape) > 0.9:
            return None
    return RefinedMode(f, rate, fit.covariance[0], mode.shape, log_likelihood_ratio)


def _modal_filter(
    mode: RefinedMode, nearby: Sequence[RefinedMode], far: Sequence[RefinedMode]
) -> tuple[Complex, list[RefinedMode]]:
    """Return the filter of a mode (S,), and the neighbours that it does not remove."""
    removed: list[RefinedMode] = []
    remaining: list[RefinedMode] = []
    row = mode.shape.conj() / np.vdot(mode.shape, mode.shape).real
    for group, limit in ((nearby, MAX_AMPLIFICATION), (far, MAX_FAR_AMPLIFICATION)):
        for neighbour in sorted(group, key=lambda neighbour: abs(neighbour.frequency - mode.frequency)):
            shapes = [mode.shape, *(removed_mode.shape for removed_mode in removed), neighbour.shape]
            inverse = np.linalg.pinv(np.column_stack(shapes))[0]
            amplification = float(np.linalg.norm(inverse) * np.linalg.norm(mode.shape))
            if len(shapes) <= len(mode.shape) and amplification < limit:
                removed.append(neighbour)
                row = inverse
            else:
                remaining.append(neighbour)
    return row, remaining


def _powers(lines: Sequence[SpectralLines], row: Complex, low: float, high: float) -> Powers:
    """Return the power that passes a filter, between two frequencies."""
    frequencies, values, seconds = [], [], []
    for piece in lines:
        line_range = slice(*np.searchsorted(piece.frequencies, [max(low, 0.5 * piece.step), high]))
        frequencies.append(piece.frequencies[line_range])
        values.append(np.abs(piece.values[line_range] @ row) ** 2 * piece.step)
        seconds.append(np.full(len(frequencies[-1]), 1.0 / piece.step))
    return Powers(np.concatenate(frequencies), np.concatenate(values), np.concatenate(seconds))
