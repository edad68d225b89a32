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
#: Half range of a fit: in half bandwidths, and the least in lines.
HALF_WIDTHS, LEAST_LINES = 10.0, 24.0
#: Largest factor by which a modal filter may reduce a mode relative to noise; neighbours beyond it are fitted in the
#: power.
AMPLIFIED = 4.0
#: Modes farther away, up to this ratio of frequencies, are removed too if that costs no more than this factor: what
#: they add around a peak is coherent with it and shifts it.
AMPLIFIED_FAR, FAR = 1.5, 3.0
#: Decay rate times record length below which a line has no visible bandwidth.
UNRESOLVED = 1.5
#: Largest shift of a candidate by a fit, in sums of both half bandwidths, and largest factor on its bandwidth.
SHIFT, WIDENED = 0.75, 4.0
#: Half bandwidths of a peak that must be visible on either side.
SEEN = 1.2
#: Highest damping ratio of a mode with a peak.
HIGHEST_DAMPING = 0.2


@dataclass(frozen=True, eq=False)
class Refined:
    """A mode.

    - frequency, rate: of the damped vibration [Hz], rate of decay [1/s]
    - covariance: of frequency and logarithm of the rate, (2, 2)
    - shape: in the scale of the lines, (S,)
    - gain: logarithm of the ratio of likelihoods
    """

    frequency: float
    rate: float
    covariance: Array
    shape: Complex
    gain: float

    @property
    def pole(self) -> complex:
        """In 1/s."""
        return complex(-self.rate, 2.0 * math.pi * self.frequency)

    @property
    def undamped(self) -> float:
        """Undamped natural frequency [Hz]."""
        return abs(self.pole) / (2.0 * math.pi)


def start(pole: complex, shape: Complex) -> Refined:
    """Return a candidate at a pole, before any fit."""
    return Refined(pole.imag / (2.0 * math.pi), -pole.real, np.zeros((2, 2)), shape, math.inf)


def refined(
    mode: Refined,
    neighbours: Sequence[Refined],
    lines: Sequence[SpectralLines],
    ends: tuple[float, float],
    least: float = SIGNIFICANT,
) -> Refined | None:
    """Return a mode refined beside its neighbours, None if no peak of its own remains.

    - lines: of pieces without padding
    - ends: of the lines that may be used [Hz]
    - least: least log-likelihood ratio
    """
    seconds = max(1.0 / piece.step for piece in lines)
    half = max(HALF_WIDTHS * mode.rate / (2.0 * math.pi), LEAST_LINES / seconds)
    low, high = max(mode.frequency - half, ends[0]), min(mode.frequency + half, ends[1])
    reach = [
        neighbour for neighbour in neighbours if low - 0.5 * half < neighbour.frequency < high + 0.5 * half
    ]
    far = [
        neighbour
        for neighbour in neighbours
        if neighbour not in reach and 1 / FAR < neighbour.frequency / mode.frequency < FAR
    ]
    row, beside = _filter(mode, reach, far)
    beside = [neighbour for neighbour in beside if low < neighbour.frequency < high]
    powers = _powers(lines, row, low, high)
    if len(powers.values) < 12:
        return None
    near = (
        [neighbour.frequency for neighbour in beside],
        [max(neighbour.rate, 0.5 / seconds) for neighbour in beside],
    )
    without = fit_peaks(powers, *near)
    fit = fit_peaks(powers, [mode.frequency, *near[0]], [max(mode.rate, 0.5 / seconds), *near[1]])
    gain = fit.likelihood - without.likelihood
    return _accepted(mode, fit, gain, reach, seconds, (low, high)) if gain >= least else None


def _accepted(
    mode: Refined,
    fit: PeakFit,
    gain: float,
    reach: Sequence[Refined],
    seconds: float,
    ends: tuple[float, float],
) -> Refined | None:
    f, rate = float(fit.frequencies[0]), float(fit.rates[0])
    inside = ends[0] < f < ends[1] and rate < HIGHEST_DAMPING * 2.0 * math.pi * f
    if rate * seconds < UNRESOLVED or not inside:
        return None
    # a fit that moved to another peak than the candidate's has the wrong shape
    if abs(f - mode.frequency) > SHIFT * (rate + mode.rate) / (2.0 * math.pi) + 1.0 / seconds:
        return None
    width = rate / (2.0 * math.pi)
    visible = ends[0] < f - SEEN * width and f + SEEN * width < ends[1]
    if rate > WIDENED * (mode.rate + 5.0 / seconds) or not visible:
        return None
    for neighbour in reach:
        apart = 2.0 * math.pi * abs(f - neighbour.frequency) / (rate + neighbour.rate)
        if apart < 0.5 and complex_mac(mode.shape, neighbour.shape) > 0.9:
            return None
    return Refined(f, rate, fit.covariance[0], mode.shape, gain)


def _filter(mode: Refined, reach: Sequence[Refined], far: Sequence[Refined]) -> tuple[Complex, list[Refined]]:
    """Return the filter of a mode (S,), and the neighbours that it does not remove."""
    removed: list[Refined] = []
    remaining: list[Refined] = []
    row = mode.shape.conj() / np.vdot(mode.shape, mode.shape).real
    for group, limit in ((reach, AMPLIFIED), (far, AMPLIFIED_FAR)):
        for neighbour in sorted(group, key=lambda neighbour: abs(neighbour.frequency - mode.frequency)):
            tried = [mode.shape, *(removed_mode.shape for removed_mode in removed), neighbour.shape]
            inverse = np.linalg.pinv(np.column_stack(tried))[0]
            amplified = float(np.linalg.norm(inverse) * np.linalg.norm(mode.shape))
            if len(tried) <= len(mode.shape) and amplified < limit:
                removed.append(neighbour)
                row = inverse
            else:
                remaining.append(neighbour)
    return row, remaining


def _powers(lines: Sequence[SpectralLines], row: Complex, low: float, high: float) -> Powers:
    """Return the power that passes a filter, between two frequencies."""
    frequencies, values, seconds = [], [], []
    for piece in lines:
        inside = slice(*np.searchsorted(piece.frequencies, [max(low, 0.5 * piece.step), high]))
        frequencies.append(piece.frequencies[inside])
        values.append(np.abs(piece.values[inside] @ row) ** 2 * piece.step)
        seconds.append(np.full(len(frequencies[-1]), 1.0 / piece.step))
    return Powers(np.concatenate(frequencies), np.concatenate(values), np.concatenate(seconds))
