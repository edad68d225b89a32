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

A mode with a neighbour so near that the filter cannot separate them within a decay is left alone, as is a vibration
that does not decay: forced, or random.
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
OF_FREQUENCY, OF_DISTANCE = 0.2, 0.22
#: Reach of the band-pass in half widths.
REACH = 5.0
#: Distance between samples of z, whose noise is then nearly independent, in standard deviations of the kernel; and
#: the time left out after the highest level, which comes about two of them after a blow.
APART, AFTER = 2.5, 2.5
#: Factor by which z is sampled more finely to find the highest level.
FINE = 4
#: Fewest samples of a segment; fewest and most segments of a decay.
SAMPLES, FEWEST, MOST = 2, 6, 24
#: Least factor by which the amplitude falls; it is followed while it stays above the noise by the second factor, and
#: until it has fallen by the third, when 99 % of the energy is gone.
FALL, ABOVE, FALLEN = 2.5, 6.0, 10.0
#: A free decay: its logarithmic amplitude deviates from a parabola over time by no more than this (rms), and it
#: decays at the mode's rate within this factor.
SMOOTH, RATE = 0.1, 2.0
#: Factor by which another blow raises the level.
RISE = 2.0
#: Most decays looked for in a record.
DECAYS = 12
#: Probability that the scatter of a linear mode is mistaken for a change.
FALSE_ALARM = 1e-4
#: The change must continue, to this probability, after the first part of the fall of the logarithmic level: what a
#: blow or the force of a sweep adds at the beginning of a decay shifts the frequency only there.
FIRST, LATER = 0.3, 0.01
#: Least relative change of a frequency that is reported: less is below the effect of neighbours in a band-pass.
LEAST = 1e-4
#: Least relative noise of the frequency of a segment.
ROUNDING = 1e-9


@dataclass(frozen=True)
class Level:
    """The level of a mode in a record.

    - amplitude: of the vibration along its shape, where most of its energy is; in the unit of the responses
    - shift: how its frequency changes while it decays; None for no detectable change
    """

    amplitude: float
    shift: LevelShift | None


def levels(
    t_step: float,
    pieces: Sequence[Array],
    poles: Complex,
    shapes: Complex,
    exponential: float | None = None,
) -> list[Level]:
    """Return the level of each mode, and how its frequency changes with it.

    - t_step: in s
    - pieces: responses, each (n_i, S); a gap begins another piece
    - poles: of all identified modes, without the damping of a window, (N,) [1/s]
    - shapes: in the scale of the responses, (N, S); NaN where undetermined
    - exponential: time constant of a window that the responses have had [s]

    References
    ----------
    Feldman 1994.
    """
    lost = 1.0 / exponential if exponential else 0.0
    spectra = [np.fft.rfft(piece - piece.mean(axis=0), axis=0) for piece in pieces]
    f = poles.imag / (2.0 * math.pi)
    mode_levels = []
    for m, pole in enumerate(poles):
        away = np.abs(np.delete(f, m) - f[m])
        half = float(min(OF_FREQUENCY * f[m], OF_DISTANCE * away.min(initial=np.inf)))
        along = along_shape(shapes[m])
        decays: list[Segments] = []
        second = fourth = 0.0
        for piece, spectrum in zip(pieces, spectra, strict=True):
            z, step = followed(spectrum @ along, len(piece), t_step, pole, half)
            decays += [
                _segments(part, FINE * step, noise, lost)
                for part, noise in _decays(z, step, lost - pole.real)
            ]
            second, fourth = (
                total + step * float((np.abs(z) ** power).sum())
                for total, power in ((second, 2), (fourth, 4))
            )
        amplitude = math.sqrt(fourth / second) if second > 0.0 else 0.0
        mode_levels.append(Level(amplitude, shift_over(pole.imag / (2.0 * math.pi), decays)))
    return mode_levels


def along_shape(shape: Complex) -> Complex:
    """Return the coefficients of the responses (S,) that follow a shape, of unit length."""
    components = np.nan_to_num(shape)
    return np.asarray(components.conj() / max(float(np.linalg.norm(components)), 1e-300))


def followed(
    spectrum: Complex, length: int, t_step: float, pole: complex, half: float
) -> tuple[Complex, float]:
    """Return z, finely sampled, and its step [s]."""
    seconds, f0 = length * t_step, pole.imag / (2.0 * math.pi)
    first = max(math.ceil((f0 - REACH * half) * seconds), 0)
    lines = np.arange(first, min(math.floor((f0 + REACH * half) * seconds) + 1, len(spectrum)))
    band = spectrum[lines] * np.exp(-0.5 * ((lines / seconds - f0) / half) ** 2)
    samples = max(round(seconds * 2.0 * math.pi * half * FINE / APART), len(lines), 1)
    turn = np.exp(2j * math.pi * (first - f0 * seconds) * np.arange(samples) / samples)
    z = np.fft.ifft(band, samples) * turn * (2.0 * samples / length)
    # the spectrum is that of a periodic signal: its beginning wraps into its end
    return np.asarray(z[: max(samples - 2 * FINE, 0)]), seconds / samples


def _decays(z: Complex, step: float, rate: float) -> Iterator[tuple[Complex, float]]:
    """Yield independent samples of the free decays in z, of about this rate [1/s], with the sigma of their noise."""
    after = math.ceil(FINE * AFTER / APART)
    if len(z) < FINE * FEWEST * SAMPLES + after:
        return
    noise, level = _noise(z[::FINE], FINE * step, rate), np.abs(z)
    free = np.ones(len(z), bool)
    for _ in range(DECAYS):
        top = int(np.argmax(np.where(free, level, 0.0)))
        first = end = min(top + after, len(z) - 1)
        lowest = max(ABOVE * noise, level[first] / FALLEN)
        while end < len(z) and free[end] and level[end] > lowest:
            end += 1
        last = max(end - 1, top)
        risen = np.flatnonzero(level[last:] > RISE * np.minimum.accumulate(level[last:]))
        free[top : last + int(risen[0]) if risen.size else len(level)] = False
        part = z[first:end:FINE]
        if len(part) >= FEWEST * SAMPLES and _decays_freely(part, FINE * step, rate):
            yield part, noise


def _noise(z: Complex, step: float, rate: float) -> float:
    """Return the standard deviation of the noise, from the last part of z without a decay."""
    tail = z[-max(len(z) // 8, 6) :]
    decay = np.exp(-rate * step * np.arange(len(tail)))
    basis = np.stack([decay, decay * np.arange(len(tail))], axis=1)
    remainder = tail - basis @ np.linalg.lstsq(basis, tail, rcond=None)[0]
    return float(np.sqrt((np.abs(remainder) ** 2).sum() / max(len(tail) - 2, 1)))


def _decays_freely(part: Complex, step: float, rate: float) -> bool:
    t, level = step * np.arange(len(part)), np.log(np.abs(part))
    fit = np.polynomial.Polynomial.fit(t, level, 2)
    smooth = float(np.sqrt(np.mean((level - fit(t)) ** 2))) < SMOOTH
    like = rate / RATE < (level[0] - level[-1]) / t[-1] < rate * RATE
    return bool(smooth and like and fit(t[0]) - fit(t[-1]) > math.log(FALL))


def _segments(part: Complex, step: float, noise: float, lost: float) -> Segments:
    """Return the frequency and amplitude of each segment of a decay, neighbours without common samples."""
    count = min(len(part) // SAMPLES, MOST)
    phase = np.unwrap(np.angle(part))
    level = np.log(np.abs(part)) + lost * step * np.arange(len(part))  # without the window
    frequencies, variances, means = [], [], []
    for indices in np.array_split(np.arange(len(part)), count):
        t = step * (indices - indices.mean())
        slope = t / (t @ t) / (2.0 * math.pi)
        frequencies.append(float(slope @ phase[indices]))
        variances.append(0.5 * noise**2 * float((slope**2 / np.abs(part[indices]) ** 2).sum()))
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
    - variance: from the noise [Hz^2]
    - level: logarithm of the amplitude
    """

    frequency: Array
    variance: Array
    level: Array


def shift_over(f0: float, decays: Sequence[Segments]) -> LevelShift | None:
    """Return the change of a frequency f0 [Hz] over all decays, None if their scatter explains it."""
    if not decays:
        return None
    level, frequency, variance = (
        np.concatenate([getattr(decay, name) for decay in decays])
        for name in ("level", "frequency", "variance")
    )
    variance = np.maximum(variance, (ROUNDING * f0) ** 2)  # signals without noise
    highest, lowest = float(level.max()), float(level.min())
    chance, coefficients = _regression(level, frequency, variance, highest)
    later = level < highest - FIRST * (highest - lowest)
    again, of_later = _regression(level[later], frequency[later], variance[later], highest)
    ends = _laws(np.array([highest, highest - FIRST * (highest - lowest), lowest]), highest)
    high, middle, low = f0 + ends @ coefficients
    shift = LevelShift(float(high), float(low), math.exp(highest - lowest))
    same = (middle - low) * float(np.diff(ends[[2, 1]] @ of_later)[0]) > 0.0
    sure = chance < FALSE_ALARM and again < LATER and same
    return shift if sure and shift.spread > LEAST * f0 else None


def _regression(level: Array, frequency: Array, variance: Array, highest: float) -> tuple[float, Array]:
    """Return the probability that scatter explains the regression, and its coefficients."""
    laws = _laws(level, highest)
    terms, freedom = laws.shape[1] - 1, len(level) - laws.shape[1]
    if freedom < 1:
        return 1.0, np.zeros(laws.shape[1])
    variance = variance + _excess(laws, frequency, variance)
    constant = _squares(laws[:, :1], frequency, variance)[0]
    residual_sum, coefficients = _squares(laws, frequency, variance)
    return float(
        fisher.sf((constant - residual_sum) / terms / max(residual_sum / freedom, 1e-300), terms, freedom)
    ), coefficients


def _laws(level: Array, highest: float) -> Array:
    """Return 1, ln a and a^2 relative to the highest level, (n, 3)."""
    above = level - highest
    return np.stack([np.ones(len(level)), above, np.exp(2.0 * above)], axis=1)


def _squares(A: Array, b: Array, variance: Array) -> tuple[float, Array]:
    """Return the weighted sum of squares that a fit leaves, and its coefficients."""
    scale = 1.0 / np.sqrt(variance)
    coefficients = np.linalg.lstsq(A * scale[:, None], b * scale, rcond=None)[0]
    return float((((b - A @ coefficients) * scale) ** 2).sum()), np.asarray(coefficients)


def _excess(A: Array, b: Array, variance: Array) -> float:
    """Return the variance of segments beyond that of their noise.

    References
    ----------
    Paule and Mandel 1982.
    """
    freedom = len(b) - A.shape[1]
    if _squares(A, b, variance)[0] <= freedom:
        return 0.0
    low, high = 0.0, float(np.ptp(b) ** 2)
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _squares(A, b, variance + middle)[0] > freedom else (low, middle)
    return high
