"""Lines without bandwidth: mains, fans and motors.

A tone is a sinusoid of constant amplitude and phase over the record; the response of a mode to noise loses its phase
in the time of its decay, and its amplitude is Rayleigh distributed.  A line that stands out of its surroundings is
followed over the record by complex demodulation: a tone has nearly the same complex amplitude in all segments, that
of a mode has a mean near zero.  This is the distinction by statistics of the amplitude (Jacobsen, Andersen and
Brincker, Proceedings of IOMAC 2007, who use the kurtosis) but needs no long record.  Tones are fitted by least
squares and subtracted, which leaves modes beside them.

A record may hold nothing but tones and the rounding of its numbers, which instruments give as multiples of a step.
The rounding of a tone is not noise: it repeats with the tone, and its power, that of an even distribution over a step
(Widrow and Kollar, Quantization Noise, 2008), lies in lines and bands that look like modes.  Sensor noise, or modes,
add power of their own.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Minimum power of a line relative to the median of its surroundings, and the half width of these in lines.
MIN_PEAK_RATIO, SURROUNDING_LINES = 40.0, 40
#: Segments, and minimum share of a tone's power that has constant complex amplitude.
SEGMENTS, MIN_CONSTANT_SHARE = 12, 0.85
#: A stated tone is searched within this fraction of its frequency, plus this many lines.
SEARCH_SHARE, SEARCH_LINES = 0.003, 2.0
#: Number of times that a tone is fitted and subtracted, as the first leaves a remainder if its frequency drifts; and
#: that each line is tried.
PASSES = 2
#: Largest distance from a multiple of the step, in steps, that the arithmetic of unit conversion leaves.
STEP_TOLERANCE = 0.01
#: Differences, relative to the range, that are arithmetic too.
ARITHMETIC_TOLERANCE = 1e-9
#: Largest power besides strong tones, relative to that of the rounding, for which there is nothing but rounding.
MAX_POWER_RATIO = 1.25
#: Rounding of any arithmetic, relative to the mean square of the record: no instrument has a range of 140 dB.
ARITHMETIC_ROUNDING = 1e-14
#: Minimum power of a line at a strong tone, relative to that of the rounding; lines that it may affect on either
#: side; and largest share of all lines that strong tones may affect.
STRONG_TONE_POWER, AFFECTED_LINES, MAX_AFFECTED_SHARE = 100.0, 40, 0.25


@dataclass(frozen=True)
class Tone:
    """A line without bandwidth.

    - frequency: in Hz
    - message: message about it
    """

    frequency: float
    message: str


def tone_message(frequency: float) -> str:
    """Return a message about a tone that was found."""
    return f"{frequency:.4g} Hz is a line without bandwidth: a tone, not a mode"


def search_band(band: tuple[float, float]) -> tuple[float, float]:
    """Return where tones are looked for: the band and a little more [Hz]."""
    return 0.9 * band[0], 1.05 * band[1]


def find_tones(
    t_step: float, pieces: Sequence[Array], band: tuple[float, float], stated_tones: Sequence[float] = ()
) -> list[Tone]:
    """Return the tones of a record in and near the band, by frequency.

    - t_step: in s
    - pieces: each (N, S)
    - band: in Hz
    - stated_tones: frequencies that, with their multiples, are tones whatever they look like [Hz]
    """
    piece = max(pieces, key=len)
    signal = (piece - piece.mean(axis=0)) / np.where(piece.std(axis=0) > 0.0, piece.std(axis=0), np.inf)
    seconds = len(signal) * t_step
    power = (np.abs(np.fft.rfft(signal * np.hanning(len(signal))[:, None], axis=0)) ** 2).sum(axis=1)
    f = np.asarray(np.fft.rfftfreq(len(signal), t_step), float)
    tones: list[Tone] = []
    for tone in stated_tones:
        for multiple in range(1, int(1.05 * band[1] / tone) + 1):
            frequency = multiple * tone
            reach = min(SEARCH_SHARE * frequency, 0.5) + SEARCH_LINES / seconds
            line_range = slice(*np.searchsorted(f, [frequency - reach, frequency + reach]))
            if frequency > 0.9 * band[0] and power[line_range].size:
                frequency = float(f[line_range][np.argmax(power[line_range])])
                text = f"{frequency:.4g} Hz is given as a tone or is a multiple of one: not a mode"
                tones.append(Tone(frequency, text))
    low, high = np.searchsorted(f, search_band(band)).tolist()
    peaks: list[int] = []  # lines that stand out of their surroundings
    for k in range(max(low, 2), min(high, len(power) - 2)):
        if power[k] == power[k - 2 : k + 3].max():
            background = np.median(power[max(k - SURROUNDING_LINES, 0) : k + SURROUNDING_LINES + 1])
            if power[k] > MIN_PEAK_RATIO * background:
                peaks.append(k)
    strongest_first = sorted(peaks, key=lambda k: -power[k])
    for k in PASSES * strongest_first:  # again, as a tone found later may have hidden this one
        if any(abs(f[k] - tone.frequency) * seconds < 4.0 for tone in tones):
            continue
        frequency = _refine_frequency(signal, t_step, float(f[k]))
        if _constant_share(signal, t_step, frequency) > MIN_CONSTANT_SHARE:
            signal = signal - _sinusoid(signal, t_step, frequency)
            tones.append(Tone(frequency, tone_message(frequency)))
    return sorted(tones, key=lambda tone: tone.frequency)


def subtract_tones(
    t_step: float, pieces: Sequence[Array], tones: Sequence[Tone], band: tuple[float, float]
) -> list[Array]:
    """Return the pieces of a record (N, S) without tones [Hz]."""
    cleaned = [np.array(piece, float) for piece in pieces]
    nearby_tones = [tone for tone in tones if 0.5 * band[0] < tone.frequency < 2.0 * band[1]]
    for piece in cleaned:
        for tone in nearby_tones:
            for _ in range(PASSES):
                frequency = _refine_frequency(piece, t_step, tone.frequency)
                piece -= _sinusoid(piece, t_step, frequency)
    return cleaned


def _refine_frequency(signal: Array, t_step: float, start: float) -> float:
    """Return the frequency within a line whose sinusoid has the most power, by a search around its maximum."""
    t = (np.arange(len(signal)) - 0.5 * (len(signal) - 1)) * t_step
    seconds = len(signal) * t_step
    window = np.hanning(len(signal))
    # lines of a narrow band: the signal is averaged in blocks after a shift to zero frequency
    shifted = signal * (window * np.exp(-2j * math.pi * start * t))[:, None]
    block = max(len(signal) // 256, 1)
    rows = len(signal) // block * block
    block_sums = shifted[:rows].reshape(-1, block, signal.shape[1]).sum(axis=1)
    block_times = t[:rows].reshape(-1, block).mean(axis=1)
    offsets = np.linspace(-1.5, 1.5, 121) / seconds
    power = (np.abs(np.exp(-2j * math.pi * np.outer(offsets, block_times)) @ block_sums) ** 2).sum(axis=1)
    return start + float(offsets[np.argmax(power)])


def _sinusoid(signal: Array, t_step: float, frequency: float) -> Array:
    """Return the sinusoid of a frequency in the signal, by least squares."""
    turns = np.exp(2j * math.pi * frequency * t_step * np.arange(len(signal)))
    window = np.hanning(len(signal))
    amplitude = 2.0 * (window * turns.conj()) @ signal / window.sum()
    return np.asarray((turns[:, None] * amplitude).real)


def _constant_share(signal: Array, t_step: float, frequency: float) -> float:
    """Return the share of the power around a line whose complex amplitude is the same over the record."""
    turns = np.exp(-2j * math.pi * frequency * t_step * np.arange(len(signal)))
    length = len(signal) // SEGMENTS
    shifted = (signal * turns[:, None])[: SEGMENTS * length].reshape(SEGMENTS, length, -1)
    amplitudes = np.einsum("snc,n->sc", shifted, np.hanning(length))
    return float((np.abs(amplitudes.mean(axis=0)) ** 2).sum() / (np.abs(amplitudes) ** 2).mean(axis=0).sum())


def quantization_step(signal: Array) -> float:
    """Return the step of which all differences in a signal, (N,), are multiples; 0 if there is none."""
    levels = np.unique(signal)
    differences = np.diff(levels)
    differences = differences[differences > ARITHMETIC_TOLERANCE * (levels[-1] - levels[0])]
    if not differences.size:
        return 0.0
    step = float(differences.min())
    steps = (levels - levels[0]) / step
    return step if np.abs(steps - np.rint(steps)).max() < STEP_TOLERANCE else 0.0


def find_only_tones(
    t_step: float,
    pieces: Sequence[Array],
    remainders: Sequence[Array],
    tones: Sequence[Tone],
    band: tuple[float, float],
) -> list[Tone] | None:
    """Return the strong tones of a record that is otherwise only the rounding of its numbers; None for any other.

    - t_step: in s
    - pieces, remainders: the record, and its remainder without its tones, each (N, S)
    - tones: tones that were found in and near the band
    - band: in Hz
    """
    piece_index = max(range(len(pieces)), key=lambda i: len(pieces[i]))
    live = pieces[piece_index].std(axis=0) > 0.0
    signals = pieces[piece_index][:, live]
    power, remaining_power = _powers(signals), _powers(remainders[piece_index][:, live])
    f = np.arange(len(remaining_power)) / (t_step * len(signals))
    step_rounding = np.array([quantization_step(column) ** 2 / 12.0 for column in signals.T])
    # The rounding of the arithmetic is so small that nothing else is below it in the band; the share of the rounding
    # of steps that lies in the band is unknown.
    low, high = search_band(band)
    in_band = (f > low) & (f < high)
    for floor, counted in (
        (step_rounding, np.full(len(f), True)),
        (ARITHMETIC_ROUNDING * signals.var(axis=0), in_band),
    ):
        strong, unaffected = [], counted.copy()
        for tone in tones:
            k = int(np.argmin(np.abs(f - tone.frequency)))
            if (power[max(k - 1, 0) : k + 2] > STRONG_TONE_POWER * floor).any():
                strong.append(tone)
                unaffected[max(k - AFFECTED_LINES, 0) : k + AFFECTED_LINES + 1] = False
        few_affected = unaffected.sum() >= (1.0 - MAX_AFFECTED_SHARE) * counted.sum()
        if (
            strong
            and few_affected
            and (floor > 0.0).all()
            and (remaining_power[unaffected].sum(axis=0) <= MAX_POWER_RATIO * floor).all()
        ):
            return strong
    return None


def _powers(signal: Array) -> Array:
    """Return the mean squares of a signal (N, S) by lines, (F, S)."""
    window = np.hanning(len(signal))
    spectrum = np.fft.rfft((signal - signal.mean(axis=0)) * window[:, None], axis=0)
    return np.asarray(2.0 * np.abs(spectrum) ** 2 / (len(signal) * (window**2).sum()))
