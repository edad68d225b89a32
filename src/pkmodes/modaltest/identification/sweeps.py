"""Where the line of a sweep begins, ends, turns back or stands still: no mode can be identified there.

While a motor changes its speed, orders of it, also those of its steps and bearings, pass through the band, and excite
modes as they pass.  Where an order begins or ends, the spectrum has an edge or a peak as well, which the
spectrum alone cannot distinguish from a mode.  The course over time can: around the moment of most power, the
frequency of the response, in a band a few times wider than the peak, passes from one side of a mode to the other, or
stays and decays as the mode rings.  At an end of an order it does neither: the line comes from one side and is gone
at once, or stays, or turns back.  Neither do random responses, but these are not confined to one short part of a
record.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.level import demodulate, shape_filter
from pkmodes.modaltest.identification.ssi_bands import SpectralLines
from pkmodes.modaltest.identification.ssi_selection import RefinedMode

#: Half width of the band-pass: in half bandwidths of the peak, and the minimum relative to the frequency.
BAND_HALF_WIDTHS, MIN_BAND_WIDTH = 3.0, 0.015
#: Distance at which a line has passed a peak: in half bandwidths, and the minimum relative to the half width of the
#: band-pass, within which noise shifts a frequency.
PASSED_HALF_WIDTHS, MIN_PASSED_DISTANCE = 1.75, 0.25
#: Power, relative to the highest, below which a line is gone.
GONE_POWER = 1e-3
#: The same if the first mode has faded into another mode; a moving line stays as strong.
FADED_POWER = 0.1
#: Fraction of the time in which a mode rings down to `GONE_POWER`: a line that is gone earlier is gone at once.
SUDDEN_SHARE = 0.5
#: Minimum share of the power near a frequency that is in one pass, and longest pass as a fraction of the record.
MIN_PASS_SHARE, MAX_PASS_LENGTH = 0.6, 0.25
#: Standard deviations of the kernel of the band-pass over which a frequency is averaged.
AVERAGING_TIME = 2.0


def is_at_line_end(lines: SpectralLines, t_step: float, mode: RefinedMode) -> bool:
    """Return whether the line of a sweep begins, ends, turns back or stands still at a mode.

    - lines: lines of the longest piece, without padding
    - t_step: between samples [s]
    """
    width = mode.rate / (2.0 * math.pi)
    half_width = max(BAND_HALF_WIDTHS * width, MIN_BAND_WIDTH * mode.frequency)
    length = round(1.0 / (lines.step * t_step))
    z, step = demodulate(lines.values @ shape_filter(mode.shape), length, t_step, mode.pole, half_width)
    power = np.abs(z[:-1]) ** 2
    averaged_samples = max(round(AVERAGING_TIME / (2.0 * math.pi * half_width * step)), 1)
    turns = np.convolve(z[1:] * z[:-1].conj(), np.ones(averaged_samples), "same")
    # Of the frequency of the response from that of the mode [Hz].
    detuning = np.angle(turns) / (2.0 * math.pi * step)
    reach = max(PASSED_HALF_WIDTHS * width, MIN_PASSED_DISTANCE * half_width)
    ringing_samples = SUDDEN_SHARE * -math.log(GONE_POWER) / (2.0 * mode.rate * step)
    ringing_window = np.ones(max(min(round(1.0 / (mode.rate * step)), len(power)), 1))
    top = int(np.argmax(np.convolve(power / (1.0 + (detuning / width) ** 2), ringing_window, "same")))
    directions, samples = [], []
    for side in (slice(top, None, -1), slice(top, None)):
        passed_index = _first_run(np.abs(detuning[side]) > reach, averaged_samples)
        gone_index = _first_run(power[side] < GONE_POWER * power[top], averaged_samples)
        faded = (
            passed_index < min(gone_index, len(detuning[side]))
            and power[side][passed_index] < FADED_POWER * power[top]
        )
        if ringing_samples < gone_index < passed_index or faded:
            return False
        directions.append(
            float(np.sign(detuning[side][passed_index]))
            if passed_index < min(gone_index, len(detuning[side]))
            else 0.0
        )
        samples.append(min(passed_index, gone_index))
    pass_power = power[max(top - samples[0], 0) : top + samples[1] + 1].sum()
    near_power = power[np.abs(detuning) < reach].sum()
    # A line that moves, and does not pass.
    moves_without_passing = any(directions) and directions[0] * directions[1] >= 0.0
    return bool(
        moves_without_passing
        and pass_power > MIN_PASS_SHARE * near_power > 0.0
        and sum(samples) < MAX_PASS_LENGTH * len(detuning)
    )


def _first_run(mask: NDArray[np.bool_], count: int) -> int:
    """Return the first index from which a condition holds for `count` samples; the length if it never does."""
    starts = np.flatnonzero(np.convolve(mask, np.ones(count))[count - 1 : len(mask)] >= count)
    return int(starts[0]) if starts.size else len(mask)
