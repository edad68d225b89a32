r"""Frequency response functions of impacts, from force and responses in time.

The H1 estimate over the impacts of a file and its coherence (Bendat and Piersol, Random Data, 4th edition, 2010,
sections 6.1 and 9.1), with the force outside of its pulses set to zero, where it is noise only (Fladung and Rost,
Mechanical Systems and Signal Processing 11, 1997).

The responses get no window.  A decay that the record cuts off at T has, at the lines k/T, the same form as a complete
one, times 1 - exp(lambda T), if the record begins with the impact: its poles are exact, and a window would only add
damping and noise.  One that an analyser has multiplied with exp(-t/tau) has its poles shifted by -1/tau.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.base.numbers import plain

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Minimum peak force of an impact, relative to the highest of the file; weaker pulses in between are bounces.
MIN_IMPACT_FORCE = 0.3
#: A second pulse above this fraction of the impact is a double hit; the hammer's own ringing stays below it.
MAX_SECOND_PULSE = 0.05
#: Number of standard deviations of its noise above which the force is a signal.
NOISE_SIGMAS = 8.0
#: Samples kept before the force begins.
LEAD_SAMPLES = 4
#: Largest gap between pulses of one contact [s].
MAX_CONTACT_GAP = 0.003


@dataclass(frozen=True, eq=False)
class ImpactEstimate:
    """Functions of one file of impacts.

    - frequencies: lines from 0 Hz, (F,) [Hz]
    - H: response per force, (F, S, 1)
    - coherence: (F, S, 1); None for a single impact
    - averages: number of impacts
    - messages: messages about double hits
    - sigma_scale: relative standard deviation of the scale of all functions, from the noise of the force in contact
    """

    frequencies: Array
    H: Complex
    coherence: Array | None
    averages: int
    messages: tuple[str, ...]
    sigma_scale: float


def impact_estimate(
    step: float,
    force: Array,
    responses: Array,
    *,
    hits: int = 1,
    window_time_constant: float | None = None,
    max_length: int | None = None,
) -> ImpactEstimate:
    """Return the functions of the impacts in a file.

    - step: sampling interval [s]
    - force: (N,)
    - responses: (N, S)
    - hits: number of impacts
    - window_time_constant: time constant of a window applied to the responses, from the first sample [s]
    - max_length: maximum number of samples used after each impact, so that the functions of several files have the
      same lines

    Raises MeasurementError if there are fewer impacts.

    References
    ----------
    Bendat and Piersol 2010, section 9.1.
    """
    pulses, sign = _pulses(force)
    starts = _impact_starts(pulses, step, hits)
    length = min(_shortest_interval(starts, len(force)), max_length or len(force))
    messages: list[str] = []
    X = np.empty((len(starts), length // 2 + 1), complex)
    Y = np.empty((*X.shape, responses.shape[1]), complex)
    impulse = variance = 0.0
    for i, start in enumerate(starts):
        piece = pulses[start : start + length]
        sigma = 1.4826 * float(np.median(np.abs(piece[len(piece) // 2 :])))  # of the noise of the force
        strong = np.abs(piece) > max(0.01 * piece.max(), NOISE_SIGMAS * sigma)
        width = max(round(0.3 * MAX_CONTACT_GAP / step), 2)
        contact = np.convolve(strong, np.ones(2 * width + 1), "same") > 0.5  # with the flanks of the pulse
        peak_samples = np.flatnonzero(piece > max(MAX_SECOND_PULSE * piece.max(), NOISE_SIGMAS * sigma))
        if (np.diff(peak_samples) > max(round(MAX_CONTACT_GAP / step), 2)).any():  # the force comes back
            messages.append(f"blow {i + 1} at {plain(start * step, 3)} s is a double hit")
        impulse += float(piece[contact].sum())
        variance += sigma**2 * float(contact.sum())
        X[i] = np.fft.rfft(sign * np.where(contact, piece, 0.0))
        window_gain = np.exp(start * step / window_time_constant) if window_time_constant else 1.0
        Y[i] = np.fft.rfft(responses[start : start + length], axis=0) * window_gain
    lines = np.asarray(np.fft.rfftfreq(length, step), dtype=float)
    return ImpactEstimate(lines, *h1(X, Y), len(starts), tuple(messages), float(np.sqrt(variance) / impulse))


def shortest_decay_length(step: float, force: Array, hits: int = 1) -> int:
    """Return the smallest number of samples in a file from an impact to the next one, or to the end.

    Raises MeasurementError if there are fewer impacts.
    """
    return _shortest_interval(_impact_starts(_pulses(force)[0], step, hits), len(force))


def _pulses(force: Array) -> tuple[Array, float]:
    """Return a force relative to its rest, with positive impacts, and their original sign, which is a convention."""
    pulses = force - float(np.median(force))
    sign = 1.0 if pulses[int(np.argmax(np.abs(pulses)))] >= 0.0 else -1.0
    return sign * pulses, sign


def _shortest_interval(starts: Sequence[int], end: int) -> int:
    return min(following - start for start, following in pairwise([*starts, end]))


def h1(X: Complex, Y: Complex) -> tuple[Complex, Array | None]:
    """Return the H1 estimate (F, S, 1) and its coherence, None for one average, from spectra (B, F) and (B, F, S)."""
    force = (np.abs(X) ** 2).sum(axis=0)[:, None]
    cross = (X.conj()[..., None] * Y).sum(axis=0)
    H = cross / np.where(force > 0.0, force, np.inf)
    if len(X) == 1:
        return H[..., None], None
    power = force * (np.abs(Y) ** 2).sum(axis=0)
    return H[..., None], (np.abs(cross) ** 2 / np.where(power > 0.0, power, np.inf))[..., None]


def remove_window_damping(poles: Complex, time_constant: float | None) -> Complex:
    """Return poles without the damping of an exponential window, None for no window."""
    return np.asarray(poles + 1.0 / time_constant if time_constant else poles, dtype=complex)


def _impact_starts(pulses: Array, step: float, hits: int) -> list[int]:
    """Return the first sample of each of the strongest impacts."""
    order = np.argsort(-pulses, kind="stable")
    min_distance = max(len(pulses) // (4 * hits), round(MAX_CONTACT_GAP / step), 1)
    peaks: list[int] = []
    for i in order:
        if len(peaks) == hits or pulses[i] < MIN_IMPACT_FORCE * pulses[order[0]]:
            break
        if all(abs(int(i) - peak) > min_distance for peak in peaks):
            peaks.append(int(i))
    if len(peaks) < hits or pulses[order[0]] <= 0.0:
        remedy = "state the number of blows in each file as hits"
        raise MeasurementError(f"expected {hits} blows, found {len(peaks)}", "the force", remedy)
    starts = []
    for peak in sorted(peaks):
        quiet = np.flatnonzero(pulses[:peak] < 0.02 * pulses[peak])
        starts.append(max((int(quiet[-1]) if quiet.size else 0) - LEAD_SAMPLES, 0))
    return starts
