"""Two recorders with separate clocks: the delay to add to the times of one to get those of the other.

All parts of a lightly damped structure move in phase or in antiphase, at resonances and, nearly everywhere, between
them.  So the phase of a cross spectrum, doubled, is that of the delay alone, whatever the signs of the shapes: the
delay is where the squares of all cross spectra are most nearly real and positive.  Lines are weighted by the
noise of their phases (Hannan and Thomson, Biometrika 60, 1973), and by `SHAPE_PHASE_SIGMA`, because shapes are not
quite real.  Clocks that also drift turn the phases over the record: the drift is searched with the delay.

A tenth of the lines, by weight, is left out at a time: the resulting changes of the delay give its standard
deviation (a jackknife).  If another delay is not clearly worse over these tenths, the standard deviation is widened
to include it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter
from scipy.signal import butter, correlate, sosfiltfilt, spectrogram

from pkmodes.core.base.errors import MeasurementError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Standard deviation of the phase of a real shape [rad]: damping turns shapes by a few degrees.
SHAPE_PHASE_SIGMA = 0.05
#: Length of a segment, in periods of the upper end of the band; minimum number of segments.
SEGMENT_PERIODS, MIN_SEGMENTS = 100.0, 8
#: Length of a segment in multiples of the largest delay searched: desired, and minimum.
SEGMENT_DELAYS, MIN_SEGMENT_DELAYS = 8.0, 4.0
#: Shortest record in periods of the lower end of the band, and minimum ratio of the ends of the band.
MIN_PERIODS, MIN_BAND_RATIO = 12.0, 1.5
TOO_SHORT = "the time that both recorded is too short, or the band too narrow"
#: Effective number of independent segments for each of several that overlap by half.
INDEPENDENT_SHARE = 0.6
#: Parts of the lines, and by how many of their standard deviations another delay must be worse to be ruled out.
JACKKNIFE_PARTS, RULED_OUT_SIGMAS = 10, 2.0
#: Steps of the delay and of the drift over the record, in periods of the upper end of the band.
DELAY_STEP, DRIFT_STEP = 0.05, 0.1


@dataclass(frozen=True, eq=False)
class Delay:
    """The delay to add to the times of a recorder.

    - seconds, drift, middle: at the time t of the recorder: seconds + drift (t - middle)
    - frequencies, sigmas: standard deviation at each frequency, for the times at which it has power, (F,) [Hz, s]
    """

    seconds: float
    drift: float
    middle: float
    frequencies: Array
    sigmas: Array

    @property
    def phase_sigmas(self) -> Array:
        """Phase by which one standard deviation turns a vibration of each frequency (F,) [rad]."""
        return 2.0 * np.pi * self.frequencies * self.sigmas

    def phase_sigma(self, frequency: float) -> float:
        """Return the phase by which one standard deviation turns a vibration of a frequency [rad]."""
        return 2.0 * math.pi * frequency * float(np.interp(frequency, self.frequencies, self.sigmas))


def rough_delay(step: float, first: Array, second: Array, band: tuple[float, float]) -> float:
    """Return the delay between two records from the times at which their vibration swells and fades [s].

    - step: between samples [s]
    - first, second: (n, S) and (m, R)
    - band: [Hz]

    Raises MeasurementError if a record is too short, or the band too narrow.
    """
    _check_length(step * min(len(first), len(second)), band)
    correlation = correlate(_envelope(step, first, band), _envelope(step, second, band), method="fft")
    return float((np.argmax(correlation) - (len(second) - 1)) * step)


def _check_length(seconds: float, band: tuple[float, float]) -> None:
    """Refuse records that are too short, and bands that are too narrow to tell a delay from a turned sign."""
    if seconds * band[0] < MIN_PERIODS or band[1] < MIN_BAND_RATIO * band[0]:
        raise MeasurementError(TOO_SHORT, "clocks", "measure longer, or in a wider band")


def _envelope(step: float, signals: Array, band: tuple[float, float]) -> Array:
    """Return the envelope of a vibration over time, without its mean."""
    filtered = sosfiltfilt(butter(4, band, "bandpass", fs=1.0 / step, output="sos"), signals, axis=0)
    scale = np.where(filtered.any(axis=0), filtered.std(axis=0), 1.0)
    mean_square = sosfiltfilt(
        butter(2, 0.5 * band[0], fs=1.0 / step, output="sos"), ((filtered / scale) ** 2).sum(axis=1)
    )
    envelope = np.sqrt(np.maximum(mean_square, 0.0))
    return np.asarray(envelope - envelope.mean())


def delay(
    step: float,
    pieces: Sequence[tuple[float, Array, Array]],
    band: tuple[float, float],
    *,
    max_delay: float,
    max_drift: float,
) -> Delay:
    """Return the delay to add to the times of a recorder to get those of another.

    - step: between samples [s]
    - pieces: time of the first sample [s], and the signals of both from there, (n, S) and (n, R), each by its own
      clock
    - band: frequencies that are used [Hz]
    - max_delay, max_drift: the largest delay [s] and drift [-] that are searched, of either sign

    Raises MeasurementError if the pieces are too short, or have nothing in common.
    """
    seconds = sum(len(signals) for _, signals, _ in pieces) * step
    length = min(
        max(SEGMENT_PERIODS / band[1], SEGMENT_DELAYS * max_delay), 2.0 * seconds / (MIN_SEGMENTS + 2)
    )
    _check_length(seconds, band)
    f, times, cross_spectra, power_products = _spectra(step, pieces, band, length)
    span = float(np.ptp(times)) if times.size else 0.0
    if times.size < MIN_SEGMENTS or length < MIN_SEGMENT_DELAYS * max_delay:
        raise MeasurementError(TOO_SHORT, "clocks", "measure longer")
    power = np.abs(cross_spectra).sum(axis=2)
    middle = float(times @ power.sum(axis=1) / max(power.sum(), np.finfo(float).tiny))
    times = times - middle
    mean_times = times @ power / np.maximum(power.sum(axis=0), np.finfo(float).tiny)
    steps = math.ceil(max_drift * span * band[1] / DRIFT_STEP)
    drifts = np.asarray(
        np.arange(-steps, steps + 1) * (DRIFT_STEP / (band[1] * max(span, step))), dtype=float
    )
    squares_by_drift = [_phase_squares(f, times, cross_spectra, power_products, trial) for trial in drifts]
    best_weights = max(squares_by_drift, key=lambda pair: float(pair[1].sum()))[1]
    if not best_weights.any():
        raise MeasurementError(
            "the two files have no coherent signals", "clocks", "measure a hit, or a sweep"
        )
    delays = np.arange(-max_delay, max_delay + DELAY_STEP / band[1], DELAY_STEP / band[1])
    rotations = np.exp(-4j * np.pi * f[:, None] * delays)
    cuts = np.searchsorted(
        np.cumsum(best_weights), best_weights.sum() * np.arange(1, JACKKNIFE_PARTS) / JACKKNIFE_PARTS
    )
    edges = np.concatenate([[0], cuts, [f.size]])
    squares = np.array([square for square, _ in squares_by_drift])
    # (PARTS, drifts, delays)
    part_sums = np.array([(squares[:, a:b] @ rotations[a:b]).real for a, b in pairwise(edges)])
    total = part_sums.sum(axis=0)
    best_delay, best_drift, best_index = _peak(total, delays, drifts)
    delays_at_lines = best_delay + best_drift * mean_times
    leave_out_peaks = [_peak(total - part_sum, delays, drifts) for part_sum in part_sums]
    leave_out_delays = np.array([offset + slope * mean_times for offset, slope, _ in leave_out_peaks])
    variance = (
        (JACKKNIFE_PARTS - 1)
        / JACKKNIFE_PARTS
        * ((leave_out_delays - leave_out_delays.mean(axis=0)) ** 2).sum(axis=0)
    )
    sigmas = np.sqrt(variance + (SHAPE_PHASE_SIGMA / (2.0 * np.pi * f)) ** 2)
    for i, k in np.argwhere(total == maximum_filter(total, size=3, mode="nearest")):
        deficits = part_sums[(slice(None), *best_index)] - part_sums[:, i, k]
        if (i, k) != best_index and deficits.sum() < RULED_OUT_SIGMAS * math.sqrt(
            JACKKNIFE_PARTS
        ) * deficits.std(ddof=1):
            sigmas = np.maximum(sigmas, np.abs(delays[k] + drifts[i] * mean_times - delays_at_lines))
    return Delay(best_delay, best_drift, middle, f, sigmas)


def _spectra(
    step: float, pieces: Sequence[tuple[float, Array, Array]], band: tuple[float, float], length: float
) -> tuple[Array, Array, Complex, Array]:
    """Return lines, middles of segments, cross spectra (segments, F, S R), and products of mean powers (F, S R)."""
    count = max(round(length / step), 2)
    rate, usable = 1.0 / step, [piece for piece in pieces if len(piece[1]) >= count]
    f = np.asarray(np.fft.rfftfreq(count, step), dtype=float)
    in_band = (f >= band[0]) & (f <= band[1])
    times, transforms = [np.zeros(0)], list[list[Complex]]([[], []])
    for start, *signals in usable:
        for transform_list, signal in zip(transforms, signals, strict=True):
            _, middles, segments = spectrogram(
                signal, rate, "hann", count, count // 2, detrend="constant", mode="complex", axis=0
            )
            transform_list.append(np.moveaxis(segments[in_band], -1, 0))  # (segments, F, S)
        times.append(start + middles)
    if not usable:
        return (
            f[in_band],
            times[0],
            np.zeros((0, int(in_band.sum()), 1), complex),
            np.zeros((int(in_band.sum()), 1)),
        )
    A, B = (np.concatenate(transform_list) for transform_list in transforms)
    pair_shape = (*A.shape[:2], -1)
    cross_spectra = (A.conj()[:, :, :, None] * B[:, :, None, :]).reshape(pair_shape)
    powers = [np.mean(np.abs(transform) ** 2, axis=0) for transform in (A, B)]
    return (
        f[in_band],
        np.concatenate(times),
        cross_spectra,
        (powers[0][:, :, None] * powers[1][:, None, :]).reshape(pair_shape[1:]),
    )


def _phase_squares(
    f: Array, times: Array, cross_spectra: Complex, powers: Array, drift: float
) -> tuple[Complex, Array]:
    """Return the weighted squares of the phases of cross spectra, and the weights, summed over pairs (F,)."""
    rotations = np.exp(-2j * np.pi * drift * times[:, None] * f)
    mean = np.einsum("sfp,sf->fp", cross_spectra, rotations) / len(times)
    n = INDEPENDENT_SHARE * len(times)
    magnitude = np.abs(mean)
    coherence = np.divide(magnitude**2, powers, out=np.zeros_like(magnitude), where=powers > 0.0)
    coherence = np.clip((coherence - 1.0 / n) / (1.0 - 1.0 / n), 0.0, 1.0)
    above_noise = coherence > 1.0 / n
    noise = np.divide(1.0 - coherence, 2.0 * n * coherence, out=np.ones_like(magnitude), where=above_noise)
    weights = np.where(above_noise, 1.0 / (noise + SHAPE_PHASE_SIGMA**2), 0.0)
    phases = np.divide(mean, magnitude, out=np.zeros_like(mean), where=magnitude > 0.0)
    return (weights * phases**2).sum(axis=1), weights.sum(axis=1)


def _peak(heights: Array, delays: Array, drifts: Array) -> tuple[float, float, tuple[int, int]]:
    """Return the delay, by a parabola, and the drift at the highest point (drifts, delays), and its indices."""
    i, k = (int(index) for index in np.unravel_index(int(heights.argmax()), heights.shape))
    shift = 0.0
    if 0 < k < len(delays) - 1:
        value_before, value_at_peak, value_after = heights[i, k - 1 : k + 2]
        shift = (
            0.5 * float((value_before - value_after) / (value_before - 2.0 * value_at_peak + value_after))
            if value_before + value_after < 2.0 * value_at_peak
            else 0.0
        )
    return float(delays[k] + shift * (delays[1] - delays[0])), float(drifts[i]), (i, k)
