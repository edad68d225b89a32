"""Two recorders with separate clocks: the delay to add to the times of one to get those of the other.

All parts of a lightly damped structure move in phase or in antiphase, at resonances and, nearly everywhere, between
them.  So the phase of a cross spectrum, doubled, is that of the delay alone, whatever the signs of the shapes: the
delay is where the squares of all cross spectra are most nearly real and positive.  Lines count by what noise leaves
of their phases (Hannan and Thomson, Biometrika 60, 1973), and by `REAL`, because shapes are not quite real.  Clocks
that also drift turn the phases over the record: the drift is sought with the delay.

A tenth of the lines, by weight, is left out at a time: the resulting changes of the delay give its standard
deviation (a jackknife).  A different delay that is not clearly worse by these tenths widens it to that delay.
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
REAL = 0.05
#: Length of a segment, in periods of the upper end of the band; the fewest segments.
PERIODS, FEWEST = 100.0, 8
#: Length of a segment in multiples of the largest delay searched: desired, and least.
DELAYS, LEAST_DELAYS = 8.0, 4.0
#: Shortest record in periods of the lower end of the band, and least ratio of the ends of the band.
LEAST_PERIODS, WIDE = 12.0, 1.5
TOO_SHORT = "the time that both recorded is too short, or the band too narrow"
#: Effective number of independent segments for each of several that overlap by half.
INDEPENDENT = 0.6
#: Parts of the lines, and by how many of their standard deviations another delay must be worse to be ruled out.
PARTS, WORSE = 10, 2.0
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
    def turns(self) -> Array:
        """Phase by which one standard deviation turns a vibration of each frequency (F,) [rad]."""
        return 2.0 * np.pi * self.frequencies * self.sigmas

    def turn(self, frequency: float) -> float:
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
    alike = correlate(_swell(step, first, band), _swell(step, second, band), method="fft")
    return float((np.argmax(alike) - (len(second) - 1)) * step)


def _check_length(seconds: float, band: tuple[float, float]) -> None:
    """Refuse records that are too short, and bands that are too narrow to tell a delay from a turned sign."""
    if seconds * band[0] < LEAST_PERIODS or band[1] < WIDE * band[0]:
        raise MeasurementError(TOO_SHORT, "clocks", "measure longer, or in a wider band")


def _swell(step: float, signals: Array, band: tuple[float, float]) -> Array:
    """Return the envelope of a vibration over time, without its mean."""
    passed = sosfiltfilt(butter(4, band, "bandpass", fs=1.0 / step, output="sos"), signals, axis=0)
    size = np.where(passed.any(axis=0), passed.std(axis=0), 1.0)
    smooth = sosfiltfilt(
        butter(2, 0.5 * band[0], fs=1.0 / step, output="sos"), ((passed / size) ** 2).sum(axis=1)
    )
    swell = np.sqrt(np.maximum(smooth, 0.0))
    return np.asarray(swell - swell.mean())


def delay(
    step: float,
    pieces: Sequence[tuple[float, Array, Array]],
    band: tuple[float, float],
    *,
    within: float,
    drift: float,
) -> Delay:
    """Return the delay to add to the times of a recorder to get those of another.

    - step: between samples [s]
    - pieces: time of the first sample [s], and the signals of both from there, (n, S) and (n, R), each by its own
      clock
    - band: frequencies that are used [Hz]
    - within, drift: the largest delay [s] and drift [-] that are searched, of either sign

    Raises MeasurementError if the pieces are too short, or have nothing in common.
    """
    seconds = sum(len(signals) for _, signals, _ in pieces) * step
    length = min(max(PERIODS / band[1], DELAYS * within), 2.0 * seconds / (FEWEST + 2))
    _check_length(seconds, band)
    f, times, crossed, coherent = _spectra(step, pieces, band, length)
    span = float(np.ptp(times)) if times.size else 0.0
    if times.size < FEWEST or length < LEAST_DELAYS * within:
        raise MeasurementError(TOO_SHORT, "clocks", "measure longer")
    power = np.abs(crossed).sum(axis=2)
    middle = float(times @ power.sum(axis=1) / max(power.sum(), np.finfo(float).tiny))
    times = times - middle
    at = times @ power / np.maximum(power.sum(axis=0), np.finfo(float).tiny)
    steps = math.ceil(drift * span * band[1] / DRIFT_STEP)
    drifts = np.asarray(
        np.arange(-steps, steps + 1) * (DRIFT_STEP / (band[1] * max(span, step))), dtype=float
    )
    weighted = [_squares(f, times, crossed, coherent, trial) for trial in drifts]
    best = max(weighted, key=lambda pair: float(pair[1].sum()))[1]
    if not best.any():
        raise MeasurementError(
            "the two files have no coherent signals", "clocks", "measure a hit, or a sweep"
        )
    delays = np.arange(-within, within + DELAY_STEP / band[1], DELAY_STEP / band[1])
    turned = np.exp(-4j * np.pi * f[:, None] * delays)
    cuts = np.searchsorted(np.cumsum(best), best.sum() * np.arange(1, PARTS) / PARTS)
    edges = np.concatenate([[0], cuts, [f.size]])
    squares = np.array([square for square, _ in weighted])
    # (PARTS, drifts, delays)
    parts = np.array([(squares[:, a:b] @ turned[a:b]).real for a, b in pairwise(edges)])
    whole = parts.sum(axis=0)
    best_delay, of_drift, where = _peak(whole, delays, drifts)
    at_lines = best_delay + of_drift * at
    without = [_peak(whole - part, delays, drifts) for part in parts]
    jackknifed = np.array([offset + slope * at for offset, slope, _ in without])
    variance = (PARTS - 1) / PARTS * ((jackknifed - jackknifed.mean(axis=0)) ** 2).sum(axis=0)
    sigmas = np.sqrt(variance + (REAL / (2.0 * np.pi * f)) ** 2)
    for i, k in np.argwhere(whole == maximum_filter(whole, size=3, mode="nearest")):
        worse = parts[(slice(None), *where)] - parts[:, i, k]
        if (i, k) != where and worse.sum() < WORSE * math.sqrt(PARTS) * worse.std(ddof=1):
            sigmas = np.maximum(sigmas, np.abs(delays[k] + drifts[i] * at - at_lines))
    return Delay(best_delay, of_drift, middle, f, sigmas)


def _spectra(
    step: float, pieces: Sequence[tuple[float, Array, Array]], band: tuple[float, float], length: float
) -> tuple[Array, Array, Complex, Array]:
    """Return lines, middles of segments, cross spectra (segments, F, S R), and products of mean powers (F, S R)."""
    count = max(round(length / step), 2)
    rate, usable = 1.0 / step, [piece for piece in pieces if len(piece[1]) >= count]
    f = np.asarray(np.fft.rfftfreq(count, step), dtype=float)
    inside = (f >= band[0]) & (f <= band[1])
    times, transforms = [np.zeros(0)], list[list[Complex]]([[], []])
    for start, *signals in usable:
        for of, signal in zip(transforms, signals, strict=True):
            _, middles, parts = spectrogram(
                signal, rate, "hann", count, count // 2, detrend="constant", mode="complex", axis=0
            )
            of.append(np.moveaxis(parts[inside], -1, 0))  # (segments, F, S)
        times.append(start + middles)
    if not usable:
        return (
            f[inside],
            times[0],
            np.zeros((0, int(inside.sum()), 1), complex),
            np.zeros((int(inside.sum()), 1)),
        )
    A, B = (np.concatenate(of) for of in transforms)
    pairs = (*A.shape[:2], -1)
    crossed = (A.conj()[:, :, :, None] * B[:, :, None, :]).reshape(pairs)
    powers = [np.mean(np.abs(transform) ** 2, axis=0) for transform in (A, B)]
    return (
        f[inside],
        np.concatenate(times),
        crossed,
        (powers[0][:, :, None] * powers[1][:, None, :]).reshape(pairs[1:]),
    )


def _squares(f: Array, times: Array, crossed: Complex, powers: Array, drift: float) -> tuple[Complex, Array]:
    """Return the weighted squares of the phases of cross spectra, and the weights, summed over pairs (F,)."""
    turned = np.exp(-2j * np.pi * drift * times[:, None] * f)
    mean = np.einsum("sfp,sf->fp", crossed, turned) / len(times)
    n = INDEPENDENT * len(times)
    size = np.abs(mean)
    coherence = np.divide(size**2, powers, out=np.zeros_like(size), where=powers > 0.0)
    coherence = np.clip((coherence - 1.0 / n) / (1.0 - 1.0 / n), 0.0, 1.0)
    above_noise = coherence > 1.0 / n
    noise = np.divide(1.0 - coherence, 2.0 * n * coherence, out=np.ones_like(size), where=above_noise)
    weights = np.where(above_noise, 1.0 / (noise + REAL**2), 0.0)
    phases = np.divide(mean, size, out=np.zeros_like(mean), where=size > 0.0)
    return (weights * phases**2).sum(axis=1), weights.sum(axis=1)


def _peak(heights: Array, delays: Array, drifts: Array) -> tuple[float, float, tuple[int, int]]:
    """Return the delay, by a parabola, and the drift at the highest point (drifts, delays), and its place."""
    i, k = (int(index) for index in np.unravel_index(int(heights.argmax()), heights.shape))
    moved = 0.0
    if 0 < k < len(delays) - 1:
        before, top, after = heights[i, k - 1 : k + 2]
        moved = (
            0.5 * float((before - after) / (before - 2.0 * top + after))
            if before + after < 2.0 * top
            else 0.0
        )
    return float(delays[k] + moved * (delays[1] - delays[0])), float(drifts[i]), (i, k)
