"""Lines that a record of responses shows as narrow peaks: orders of a motor whose speed wanders, and tones.

A tone that wanders by a small part of its frequency has a bandwidth, and one that wanders less has what the length of
the record leaves of it: fits to the spectrum take both for modes of light damping.  The amplitude tells them apart.
That of a tone is constant; that of the response of a mode to noise is Rayleigh distributed.  The mean of the fourth
power of the amplitude over the square of the mean power is 1 for a tone and 2 for a response (the kurtosis of
Jacobsen, Andersen and Brincker, Proceedings of IOMAC 2007, for the analytic signal).  In a record of a few times of
decay it scatters: `QUANTILES` are those of simulated responses.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.level import along_shape
from pkmodes.modaltest.identification.ssi_bands import SpectralLines
from pkmodes.modaltest.identification.ssi_selection import Refined
from pkmodes.modaltest.identification.tones import Tone

Array = NDArray[np.float64]
#: Half width of the band that is followed: in half bandwidths, and the least in lines.
WIDE, LEAST_LINES = 3.0, 3.0
#: Samples of the amplitude for each line of the band.
FINE = 4
#: Decay rates times record length, and quantiles of the statistic for responses.
DECAYS = np.array([1.5, 3.0, 6.0, 12.0, 25.0, 50.0, 100.0, 200.0, 400.0, 800.0])
QUANTILES = {
    0.01: np.array([1.05, 1.08, 1.14, 1.27, 1.41, 1.54, 1.64, 1.72, 1.82, 1.84]),
    0.05: np.array([1.09, 1.17, 1.25, 1.36, 1.50, 1.63, 1.71, 1.80, 1.85, 1.89]),
    0.2: np.array([1.22, 1.30, 1.38, 1.51, 1.64, 1.74, 1.82, 1.87, 1.92, 1.94]),
    0.5: np.array([1.42, 1.51, 1.60, 1.73, 1.84, 1.90, 1.95, 1.97, 1.99, 1.99]),
    0.99: np.array([2.63, 2.75, 2.74, 2.96, 2.99, 2.79, 2.58, 2.38, 2.25, 2.19]),
}
#: Statistic above which no amplitude is constant, however long the record: half way from a tone to a response.
CONSTANT = 1.5
#: Decay rate times record length below which a peak is narrower than a line under Hann's window, 1.44 / length.
NARROWEST = 4.5
#: Standard deviation of the logarithm of a rate above which two standard deviations of the damping reach 0.
UNCERTAIN = 0.36
#: Damping ratio below which a peak is more likely a tone than a mode of a machine.
LIGHTEST = 5e-4
#: A narrow peak at a multiple of half a line's frequency is an order of it: largest damping ratio, largest relative
#: distance (plus a line), and most halves.
NARROW, OFF_ORDER, MOST_HALVES = 0.003, 0.001, 12


@dataclass(frozen=True)
class Followed:
    """The amplitude at a peak.

    - statistic: mean of the fourth power of the amplitude over the square of the mean power
    - off: distance of the mean frequency of the power from the peak, in half bandwidths or lines, whichever are wider
    """

    statistic: float
    off: float


def lines_among(
    pieces: Sequence[SpectralLines], modes: Sequence[Refined], tones: Sequence[Tone]
) -> dict[int, Tone]:
    """Return which modes are lines, or cannot be told from one, by index, with a message about each.

    - pieces: of the record, without padding
    - tones: those that were found before
    """
    seconds = sum(1.0 / lines.step for lines in pieces)
    amplitudes = [followed(pieces, mode) for mode in modes]
    line_tones: dict[int, Tone] = {}
    for i, (mode, amplitude) in enumerate(zip(modes, amplitudes, strict=True)):
        if amplitude.off < 1.0 and amplitude.statistic < min(quantile(0.01, mode.rate * seconds), CONSTANT):
            constant = "its amplitude is as constant as that of a tone, unlike that of a mode"
            line_tones[i] = Tone(mode.frequency, f"{mode.undamped:.4g} Hz is a line: {constant}")
    known_lines, searching = [*tones, *line_tones.values()], True
    while searching:  # each order found may lead to others
        orders = {
            i: _as_order(mode, amplitude, known_lines, seconds)
            for i, (mode, amplitude) in enumerate(zip(modes, amplitudes, strict=True))
            if i not in line_tones
        }
        added = {i: Tone(modes[i].frequency, sentence) for i, sentence in orders.items() if sentence}
        line_tones, known_lines, searching = line_tones | added, [*known_lines, *added.values()], bool(added)
    for i, (mode, amplitude) in enumerate(zip(modes, amplitudes, strict=True)):
        if i not in line_tones and (sentence := _not_told(mode, amplitude, seconds, bool(known_lines))):
            line_tones[i] = Tone(mode.frequency, sentence)
    return line_tones


def followed(pieces: Sequence[SpectralLines], mode: Refined) -> Followed:
    """Return the statistics of a response's amplitude at a peak, over the pieces of a record."""
    width, along = mode.rate / (2.0 * math.pi), along_shape(mode.shape)
    powers, of_lines, away = [], [], []
    for lines in pieces:
        half = max(WIDE * width, LEAST_LINES * lines.step)
        inside = slice(*np.searchsorted(lines.frequencies, [mode.frequency - half, mode.frequency + half]))
        values = lines.values[inside] @ along * lines.step
        samples = FINE * len(values)
        powers.append(np.abs(np.fft.ifft(values, samples) * samples) ** 2)
        of_lines.append(np.abs(values) ** 2 / lines.step)
        away.append(lines.frequencies[inside] - mode.frequency)
    power, weights = np.concatenate(powers), np.concatenate(of_lines)
    centre = float(weights @ np.concatenate(away) / max(float(weights.sum()), 1e-300))
    statistic = float(np.mean(power**2) / max(float(np.mean(power)) ** 2, 1e-300))
    return Followed(statistic, abs(centre) / max(width, min(lines.step for lines in pieces)))


def quantile(share: float, decays: float) -> float:
    """Return the `share` quantile of the statistic of responses, for a decay rate times record length."""
    return float(np.interp(math.log(max(decays, 1e-300)), np.log(DECAYS), QUANTILES[share]))


def _as_order(mode: Refined, amplitude: Followed, tones: Sequence[Tone], seconds: float) -> str:
    """Return a message about a narrow peak at an order of a line; "" if it is none, or clearly a mode."""
    decays = mode.rate * seconds
    like_a_mode = quantile(0.5, decays) < amplitude.statistic < quantile(0.99, decays)
    damped = mode.covariance[1, 1] < UNCERTAIN**2
    if mode.rate > NARROW * 2.0 * math.pi * mode.frequency or (like_a_mode and damped):
        return ""
    for tone in tones:
        for order in (Fraction(n, 2) for n in range(1, MOST_HALVES + 1)):
            for times in (order, 1 / order):
                place = float(times) * tone.frequency
                if abs(mode.frequency - place) < OFF_ORDER * place + 1.0 / seconds:
                    ratio = f"{float(times):g}" if times >= 1 else str(times)
                    return (
                        f"{mode.undamped:.4g} Hz is a narrow line at {ratio} times the one at "
                        f"{tone.frequency:.4g} Hz: an order of the same motor, not a mode"
                    )
    return ""


def _not_told(mode: Refined, amplitude: Followed, seconds: float, lines: bool) -> str:
    """Return a message about a peak that may be a tone as well as a mode, likelier beside other lines, or ""."""
    decays = mode.rate * seconds
    uncertain = mode.covariance[1, 1] > UNCERTAIN**2
    light = mode.rate < LIGHTEST * 2.0 * math.pi * mode.frequency
    if light or decays < NARROWEST:
        like_a_mode = amplitude.statistic > quantile(0.5, decays)
    else:
        like_a_mode = not uncertain or amplitude.statistic > quantile(0.2 if lines else 0.05, decays)
    beats = lines and uncertain and amplitude.statistic > quantile(0.99, decays)
    if like_a_mode and not beats:
        return ""
    return (
        f"{mode.undamped:.4g} Hz is a line or a lightly damped mode, and the record does not tell which: left out; "
        "record for longer, or add it"
    )
