"""Lines that a record of responses shows as narrow peaks: orders of a motor whose speed wanders, and tones.

A tone that wanders by a small part of its frequency has a bandwidth, and one that wanders less has that of a
line of the record: fits to the spectrum take both for modes of light damping.  The amplitude distinguishes them.
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

from pkmodes.modaltest.identification.level import shape_filter
from pkmodes.modaltest.identification.ssi_bands import SpectralLines
from pkmodes.modaltest.identification.ssi_selection import RefinedMode
from pkmodes.modaltest.identification.tones import Tone

Array = NDArray[np.float64]
#: Half width of the band that is followed: in half bandwidths, and the minimum in lines.
BAND_HALF_WIDTHS, MIN_BAND_LINES = 3.0, 3.0
#: Samples of the amplitude for each line of the band.
OVERSAMPLING = 4
#: Decay rates times record length, and quantiles of the statistic for responses.
DECAY_COUNTS = np.array([1.5, 3.0, 6.0, 12.0, 25.0, 50.0, 100.0, 200.0, 400.0, 800.0])
QUANTILES = {
    0.01: np.array([1.05, 1.08, 1.14, 1.27, 1.41, 1.54, 1.64, 1.72, 1.82, 1.84]),
    0.05: np.array([1.09, 1.17, 1.25, 1.36, 1.50, 1.63, 1.71, 1.80, 1.85, 1.89]),
    0.2: np.array([1.22, 1.30, 1.38, 1.51, 1.64, 1.74, 1.82, 1.87, 1.92, 1.94]),
    0.5: np.array([1.42, 1.51, 1.60, 1.73, 1.84, 1.90, 1.95, 1.97, 1.99, 1.99]),
    0.99: np.array([2.63, 2.75, 2.74, 2.96, 2.99, 2.79, 2.58, 2.38, 2.25, 2.19]),
}
#: Statistic above which no amplitude is constant, however long the record: half way from a tone to a response.
MAX_CONSTANT_STATISTIC = 1.5
#: Decay rate times record length below which a peak is narrower than a line under Hann's window, 1.44 / length.
MIN_RESOLVED_DECAYS = 4.5
#: Standard deviation of the logarithm of a rate above which two standard deviations of the damping reach 0.
MAX_LOG_RATE_SIGMA = 0.36
#: Damping ratio below which a peak is more likely a tone than a mode of a machine.
MIN_DAMPING_RATIO = 5e-4
#: A narrow peak at a multiple of half a line's frequency is an order of it: largest damping ratio, largest relative
#: distance (plus a line), and maximum number of halves.
MAX_ORDER_DAMPING, ORDER_TOLERANCE, MAX_HALF_ORDERS = 0.003, 0.001, 12


@dataclass(frozen=True)
class AmplitudeStatistics:
    """The amplitude at a peak.

    - statistic: mean of the fourth power of the amplitude over the square of the mean power
    - offset: distance of the mean frequency of the power from the peak, in half bandwidths or lines, whichever are
      wider
    """

    statistic: float
    offset: float


def find_line_modes(
    pieces: Sequence[SpectralLines], modes: Sequence[RefinedMode], tones: Sequence[Tone]
) -> dict[int, Tone]:
    """Return which modes are lines, or cannot be told from one, by index, with a message about each.

    - pieces: pieces of the record, without padding
    - tones: tones that were found before
    """
    seconds = sum(1.0 / lines.step for lines in pieces)
    amplitudes = [amplitude_statistics(pieces, mode) for mode in modes]
    line_tones: dict[int, Tone] = {}
    for i, (mode, amplitude) in enumerate(zip(modes, amplitudes, strict=True)):
        if amplitude.offset < 1.0 and amplitude.statistic < min(
            quantile(0.01, mode.rate * seconds), MAX_CONSTANT_STATISTIC
        ):
            constant = "its amplitude is as constant as that of a tone, unlike that of a mode"
            line_tones[i] = Tone(mode.frequency, f"{mode.undamped:.4g} Hz is a line: {constant}")
    known_lines, searching = [*tones, *line_tones.values()], True
    while searching:  # each order found may lead to others
        orders = {
            i: _order_message(mode, amplitude, known_lines, seconds)
            for i, (mode, amplitude) in enumerate(zip(modes, amplitudes, strict=True))
            if i not in line_tones
        }
        added = {i: Tone(modes[i].frequency, sentence) for i, sentence in orders.items() if sentence}
        line_tones, known_lines, searching = line_tones | added, [*known_lines, *added.values()], bool(added)
    for i, (mode, amplitude) in enumerate(zip(modes, amplitudes, strict=True)):
        if i not in line_tones and (
            sentence := _ambiguity_message(mode, amplitude, seconds, bool(known_lines))
        ):
            line_tones[i] = Tone(mode.frequency, sentence)
    return line_tones


def amplitude_statistics(pieces: Sequence[SpectralLines], mode: RefinedMode) -> AmplitudeStatistics:
    """Return the statistics of a response's amplitude at a peak, over the pieces of a record."""
    width, weights = mode.rate / (2.0 * math.pi), shape_filter(mode.shape)
    powers, line_powers, offsets = [], [], []
    for lines in pieces:
        half_width = max(BAND_HALF_WIDTHS * width, MIN_BAND_LINES * lines.step)
        line_range = slice(
            *np.searchsorted(lines.frequencies, [mode.frequency - half_width, mode.frequency + half_width])
        )
        values = lines.values[line_range] @ weights * lines.step
        samples = OVERSAMPLING * len(values)
        powers.append(np.abs(np.fft.ifft(values, samples) * samples) ** 2)
        line_powers.append(np.abs(values) ** 2 / lines.step)
        offsets.append(lines.frequencies[line_range] - mode.frequency)
    power, power_weights = np.concatenate(powers), np.concatenate(line_powers)
    centre = float(power_weights @ np.concatenate(offsets) / max(float(power_weights.sum()), 1e-300))
    statistic = float(np.mean(power**2) / max(float(np.mean(power)) ** 2, 1e-300))
    return AmplitudeStatistics(statistic, abs(centre) / max(width, min(lines.step for lines in pieces)))


def quantile(probability: float, decays: float) -> float:
    """Return the `probability` quantile of the statistic of responses, for a decay rate times record length."""
    return float(np.interp(math.log(max(decays, 1e-300)), np.log(DECAY_COUNTS), QUANTILES[probability]))


def _order_message(
    mode: RefinedMode, amplitude: AmplitudeStatistics, tones: Sequence[Tone], seconds: float
) -> str:
    """Return a message about a narrow peak at an order of a line; "" if it is none, or clearly a mode."""
    decays = mode.rate * seconds
    like_a_mode = quantile(0.5, decays) < amplitude.statistic < quantile(0.99, decays)
    damped = mode.covariance[1, 1] < MAX_LOG_RATE_SIGMA**2
    if mode.rate > MAX_ORDER_DAMPING * 2.0 * math.pi * mode.frequency or (like_a_mode and damped):
        return ""
    for tone in tones:
        for order in (Fraction(n, 2) for n in range(1, MAX_HALF_ORDERS + 1)):
            for factor in (order, 1 / order):
                expected = float(factor) * tone.frequency
                if abs(mode.frequency - expected) < ORDER_TOLERANCE * expected + 1.0 / seconds:
                    factor_text = f"{float(factor):g}" if factor >= 1 else str(factor)
                    return (
                        f"{mode.undamped:.4g} Hz is a narrow line at {factor_text} times the one at "
                        f"{tone.frequency:.4g} Hz: an order of the same motor, not a mode"
                    )
    return ""


def _ambiguity_message(mode: RefinedMode, amplitude: AmplitudeStatistics, seconds: float, lines: bool) -> str:
    """Return a message about a peak that may be a tone as well as a mode, likelier beside other lines, or ""."""
    decays = mode.rate * seconds
    uncertain = mode.covariance[1, 1] > MAX_LOG_RATE_SIGMA**2
    light = mode.rate < MIN_DAMPING_RATIO * 2.0 * math.pi * mode.frequency
    if light or decays < MIN_RESOLVED_DECAYS:
        like_a_mode = amplitude.statistic > quantile(0.5, decays)
    else:
        like_a_mode = not uncertain or amplitude.statistic > quantile(0.2 if lines else 0.05, decays)
    fluctuates = lines and uncertain and amplitude.statistic > quantile(0.99, decays)
    if like_a_mode and not fluctuates:
        return ""
    return (
        f"{mode.undamped:.4g} Hz is a line or a lightly damped mode, and the record does not tell which: left out; "
        "record for longer, or add it"
    )
