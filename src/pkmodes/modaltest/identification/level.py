r"""Frequencies that change with the level, from free decays within a record.

Joints and rails make a frequency depend on the amplitude: while a mode rings down, its frequency drifts.  The
responses are combined along the shape of a mode, and followed over time by a Gaussian band-pass,

.. math:: z(t) = \int Y(f)\, e^{-(f - f_0)^2 / 2 h^2}\, e^{2 \pi j (f - f_0) t}\, df ,

whose kernel in time is a Gaussian of standard deviation 1/(2 pi h): a few of these after a blow, nothing is left of
another mode but what the filter passes, exp(-d^2 / 2 h^2) at a distance d.  The phase of z, a straight line for a
linear mode, gives the frequency of each segment of a decay, and |z| its amplitude (Feldman, Mechanical Systems and
Signal Processing 8(2), 1994, with the Hilbert transform).  The frequency is regressed on the amplitude,

.. math:: f = c_0 + c_1 \ln a + c_2 a^2 ,

which holds for joints, which slip over a wide range of amplitudes (the logarithm), and for stiffening or softening
springs (the square: the backbone curve of Duffing's equation).  Segments scatter by their noise, which is known, and
by what neighbours and the excitation add, which is estimated (Paule and Mandel, Journal of Research of the National
Bureau of Standards 87, 1982).  The frequency changes if the last two terms reduce the sum of squares by more than
scatter does, by an F test.  Probabilities are those of one mode.

A mode with a neighbour so near that the filter cannot separate them within a decay is not examined, nor is a
vibration that does not decay: forced, or random.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import f as fisher

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Half width h of the band-pass: this fraction of the frequency, or of the distance to the next mode.
HALF_WIDTH_OF_FREQUENCY, HALF_WIDTH_OF_DISTANCE = 0.2, 0.22
#: Reach of the band-pass in half widths.
BAND_REACH = 5.0
#: Distance between samples of z, whose noise is then nearly independent, in standard deviations of the kernel; and
#: the time left out after the highest level, which comes about two of them after a blow.
SAMPLE_SPACING, SETTLING_TIME = 2.5, 2.5
#: Factor by which z is sampled more finely to find the highest level.
OVERSAMPLING = 4
#: Minimum number of samples of a segment; minimum and maximum number of segments of a decay.
MIN_SAMPLES, MIN_SEGMENTS, MAX_SEGMENTS = 2, 6, 24
#: Minimum factor by which the amplitude falls; it is followed while it stays above the noise by the second factor,
#: and until it has fallen by the third, when 99 % of the energy is gone.
MIN_FALL, MIN_NOISE_RATIO, MAX_FALL = 2.5, 6.0, 10.0
#: A free decay: its logarithmic amplitude deviates from a parabola over time by no more than this (rms), and it
#: decays at the mode's rate within this factor.
MAX_DEVIATION, MAX_RATE_RATIO = 0.1, 2.0
#: Factor by which another blow raises the level.
BLOW_RISE = 2.0
#: Maximum number of decays looked for in a record.
MAX_DECAYS = 12
#: Probability that the scatter of a linear mode is mistaken for a change.
FALSE_ALARM = 1e-4
#: The change must continue, to this probability, after the first part of the fall of the logarithmic level: what a
#: blow or the force of a sweep adds at the beginning of a decay shifts the frequency only there.
FIRST_SHARE, LATER_FALSE_ALARM = 0.3, 0.01
#: Minimum relative change of a frequency that is reported: less is below the effect of neighbours in a band-pass.
MIN_CHANGE = 1e-4
#: Minimum relative noise of the frequency of a segment.
ROUNDING = 1e-9


@dataclass(frozen=True)
class Level:
    """The level of a mode in a record.

    - amplitude: amplitude of the vibration along its shape, where most of its energy is; in the unit of the responses
    - shift: how its frequency changes while it decays; None for no detectable change
    """

    amplitude: float
    shift: LevelShift | None


def levels(
    t_step: float,
    pieces: Sequence[Array],
    poles: Complex,
    shapes: Complex,
    window_time_constant: float | None = None,
) -> list[Level]:
    """Return the level of each mode, and how its frequency changes with it.

    - t_step: in s
    - pieces: responses, each (n_i, S); a gap begins another piece
    - poles: poles of all identified modes, without the damping of a window, (N,) [1/s]
    - shapes: in the scale of the responses, (N, S); NaN where undetermined
    - window_time_constant: time constant of a window that the responses have had [s]

    References
    ----------
    Feldman 1994.
    """
    window_rate = 1.0 / window_time_constant if window_time_constant else 0.0
    spectra = [np.fft.rfft(piece - piece.mean(axis=0), axis=0) for piece in pieces]
    f = poles.imag / (2.0 * math.pi)
    mode_levels = []
    for m, pole in enumerate(poles):
        distance = np.abs(np.delete(f, m) - f[m])
        half_width = float(
            min(HALF_WIDTH_OF_FREQUENCY * f[m], HALF_WIDTH_OF_DISTANCE * distance.min(initial=np.inf))
        )
        weights = shape_filter(shapes[m])
        decays: list[Segments] = []
        second_moment = fourth_moment = 0.0
        for piece, spectrum in zip(pieces, spectra, strict=True):
            z, step = demodulate(spectrum @ weights, len(piece), t_step, pole, half_width)
            decays += [
                _segments(decay, OVERSAMPLING * step, noise, window_rate)
                for decay, noise in _free_decays(z, step, window_rate - pole.real)
            ]
            second_moment, fourth_moment = (
                total + step * float((np.abs(z) ** power).sum())
                for total, power in ((second_moment, 2), (fourth_moment, 4))
            )
        amplitude = math.sqrt(fourth_moment / second_moment) if second_moment > 0.0 else 0.0
        mode_levels.append(Level(amplitude, estimate_shift(pole.imag / (2.0 * math.pi), decays)))
    return mode_levels


def shape_filter(shape: Complex) -> Complex:
    """Return the coefficients of the responses (S,) that follow a shape, of unit length."""
    components = np.nan_to_num(shape)
    return np.asarray(components.conj() / max(float(np.linalg.norm(components)), 1e-300))


def demodulate(
    spectrum: Complex, length: int, t_step: float, pole: complex, half_width: float
) -> tuple[Complex, float]:
    """Return z, finely sampled, and its step [s]."""
    seconds, f0 = length * t_step, pole.imag / (2.0 * math.pi)
    first = max(math.ceil((f0 - BAND_REACH * half_width) * seconds), 0)
    lines = np.arange(first, min(math.floor((f0 + BAND_REACH * half_width) * seconds) + 1, len(spectrum)))
    band = spectrum[lines] * np.exp(-0.5 * ((lines / seconds - f0) / half_width) ** 2)
    samples = max(round(seconds * 2.0 * math.pi * half_width * OVERSAMPLING / SAMPLE_SPACING), len(lines), 1)
    rotation = np.exp(2j * math.pi * (first - f0 * seconds) * np.arange(samples) / samples)
    z = np.fft.ifft(band, samples) * rotation * (2.0 * samples / length)
    # the spectrum is that of a periodic signal: its beginning wraps into its end
    return np.asarray(z[: max(samples - 2 * OVERSAMPLING, 0)]), seconds / samples


def _free_decays(z: Complex, step: float, rate: float) -> Iterator[tuple[Complex, float]]:
    """Yield independent samples of the free decays in z, of about this rate [1/s], with the sigma of their noise."""
    settling_samples = math.ceil(OVERSAMPLING * SETTLING_TIME / SAMPLE_SPACING)
    if len(z) < OVERSAMPLING * MIN_SEGMENTS * MIN_SAMPLES + settling_samples:
        return
    noise, level = _noise_sigma(z[::OVERSAMPLING], OVERSAMPLING * step, rate), np.abs(z)
    free_mask = np.ones(len(z), bool)
    for _ in range(MAX_DECAYS):
        highest = int(np.argmax(np.where(free_mask, level, 0.0)))
        first = end = min(highest + settling_samples, len(z) - 1)
        lowest = max(MIN_NOISE_RATIO * noise, level[first] / MAX_FALL)
        while end < len(z) and free_mask[end] and level[end] > lowest:
            end += 1
        last = max(end - 1, highest)
        rises = np.flatnonzero(level[last:] > BLOW_RISE * np.minimum.accumulate(level[last:]))
        free_mask[highest : last + int(rises[0]) if rises.size else len(level)] = False
        decay = z[first:end:OVERSAMPLING]
        if len(decay) >= MIN_SEGMENTS * MIN_SAMPLES and _is_free_decay(decay, OVERSAMPLING * step, rate):
            yield decay, noise


def _noise_sigma(z: Complex, step: float, rate: float) -> float:
    """Return the standard deviation of the noise, from the last part of z without a decay."""
    last_part = z[-max(len(z) // 8, 6) :]
    decay = np.exp(-rate * step * np.arange(len(last_part)))
    basis = np.stack([decay, decay * np.arange(len(last_part))], axis=1)
    remainder = last_part - basis @ np.linalg.lstsq(basis, last_part, rcond=None)[0]
    return float(np.sqrt((np.abs(remainder) ** 2).sum() / max(len(last_part) - 2, 1)))


def _is_free_decay(decay: Complex, step: float, rate: float) -> bool:
    t, level = step * np.arange(len(decay)), np.log(np.abs(decay))
    fit = np.polynomial.Polynomial.fit(t, level, 2)
    is_smooth = float(np.sqrt(np.mean((level - fit(t)) ** 2))) < MAX_DEVIATION
    matches_rate = rate / MAX_RATE_RATIO < (level[0] - level[-1]) / t[-1] < rate * MAX_RATE_RATIO
    return bool(is_smooth and matches_rate and fit(t[0]) - fit(t[-1]) > math.log(MIN_FALL))


def _segments(decay: Complex, step: float, noise: float, window_rate: float) -> Segments:
    """Return the frequency and amplitude of each segment of a decay, neighbours without common samples."""
    count = min(len(decay) // MIN_SAMPLES, MAX_SEGMENTS)
    phase = np.unwrap(np.angle(decay))
    level = np.log(np.abs(decay)) + window_rate * step * np.arange(len(decay))  # without the window
    frequencies, variances, means = [], [], []
    for indices in np.array_split(np.arange(len(decay)), count):
        t = step * (indices - indices.mean())
        slope = t / (t @ t) / (2.0 * math.pi)
        frequencies.append(float(slope @ phase[indices]))
        variances.append(0.5 * noise**2 * float((slope**2 / np.abs(decay[indices]) ** 2).sum()))
        means.append(float(level[indices].mean()))
    return Segments(np.array(frequencies), np.array(variances), np.array(means))


@dataclass(frozen=True)
class LevelShift:
    """A frequency that changes with the level.

    - high, low: frequency at the highest and at the lowest level [Hz]
    - fall: ratio of these levels
    """

    high: float
    low: float
    fall: float

    @property
    def spread(self) -> float:
        """Range of the frequency [Hz]."""
        return abs(self.high - self.low)


@dataclass(frozen=True, eq=False)
class Segments:
    """Segments of a decay, (n,).

    - frequency: relative to that of the mode [Hz]
    - variance: variance from the noise [Hz^2]
    - level: logarithm of the amplitude
    """

    frequency: Array
    variance: Array
    level: Array


def estimate_shift(f0: float, decays: Sequence[Segments]) -> LevelShift | None:
    """Return the change of a frequency f0 [Hz] over all decays, None if their scatter explains it."""
    if not decays:
        return None
    level, frequency, variance = (
        np.concatenate([getattr(decay, name) for decay in decays])
        for name in ("level", "frequency", "variance")
    )
    variance = np.maximum(variance, (ROUNDING * f0) ** 2)  # signals without noise
    highest, lowest = float(level.max()), float(level.min())
    probability, coefficients = _regression(level, frequency, variance, highest)
    is_later = level < highest - FIRST_SHARE * (highest - lowest)
    later_probability, later_coefficients = _regression(
        level[is_later], frequency[is_later], variance[is_later], highest
    )
    end_regressors = _regressors(
        np.array([highest, highest - FIRST_SHARE * (highest - lowest), lowest]), highest
    )
    high, middle, low = f0 + end_regressors @ coefficients
    shift = LevelShift(float(high), float(low), math.exp(highest - lowest))
    continues = (middle - low) * float(np.diff(end_regressors[[2, 1]] @ later_coefficients)[0]) > 0.0
    significant = probability < FALSE_ALARM and later_probability < LATER_FALSE_ALARM and continues
    return shift if significant and shift.spread > MIN_CHANGE * f0 else None


def _regression(level: Array, frequency: Array, variance: Array, highest: float) -> tuple[float, Array]:
    """Return the probability that scatter explains the regression, and its coefficients."""
    regressors = _regressors(level, highest)
    terms, freedom = regressors.shape[1] - 1, len(level) - regressors.shape[1]
    if freedom < 1:
        return 1.0, np.zeros(regressors.shape[1])
    variance = variance + _excess_variance(regressors, frequency, variance)
    constant_sum = _weighted_fit(regressors[:, :1], frequency, variance)[0]
    residual_sum, coefficients = _weighted_fit(regressors, frequency, variance)
    return float(
        fisher.sf((constant_sum - residual_sum) / terms / max(residual_sum / freedom, 1e-300), terms, freedom)
    ), coefficients


def _regressors(level: Array, highest: float) -> Array:
    """Return 1, ln a and a^2 relative to the highest level, (n, 3)."""
    log_ratio = level - highest
    return np.stack([np.ones(len(level)), log_ratio, np.exp(2.0 * log_ratio)], axis=1)


def _weighted_fit(A: Array, b: Array, variance: Array) -> tuple[float, Array]:
    """Return the weighted sum of squares that a fit leaves, and its coefficients."""
    scale = 1.0 / np.sqrt(variance)
    coefficients = np.linalg.lstsq(A * scale[:, None], b * scale, rcond=None)[0]
    return float((((b - A @ coefficients) * scale) ** 2).sum()), np.asarray(coefficients)


def _excess_variance(A: Array, b: Array, variance: Array) -> float:
    """Return the variance of segments beyond that of their noise.

    References
    ----------
    Paule and Mandel 1982.
    """
    freedom = len(b) - A.shape[1]
    if _weighted_fit(A, b, variance)[0] <= freedom:
        return 0.0
    low, high = 0.0, float(np.ptp(b) ** 2)
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _weighted_fit(A, b, variance + middle)[0] > freedom else (low, middle)
    return high
