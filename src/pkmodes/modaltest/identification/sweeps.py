"""Where the line of a sweep begins, ends, turns back or stands still: no mode can be identified there.

While a motor changes its speed, orders of it, also those of its steps and bearings, pass through the band, and excite
modes as they pass.  Where an order begins or ends, the spectrum has an edge or a peak as well, which nothing in it
tells from a mode.  Time does: around the moment of most power, the frequency of the response, in a band a few times
wider than the peak, passes from one side of a mode to the other, or stays and decays as the mode rings.  At an end of
an order it does neither: the line comes from one side and is gone at once, or stays, or turns back.  Random responses
do neither as well, but not in one short part of a record.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.level import along_shape, followed
from pkmodes.modaltest.identification.ssi_bands import SpectralLines
from pkmodes.modaltest.identification.ssi_selection import Refined

#: Half width of the band-pass: in half bandwidths of the peak, and the least relative to the frequency.
WIDE, LEAST_WIDE = 3.0, 0.015
#: Distance at which a line has passed a peak: in half bandwidths, and the least relative to the half width of the
#: band-pass, within which noise shifts a frequency.
PASSED, LEAST_PASSED = 1.75, 0.25
#: Power, relative to the highest, below which a line is gone.
LEFT = 1e-3
#: The same if the first mode has faded into another mode; a moving line stays as strong.
FADED = 0.1
#: Fraction of the time in which a mode rings down to `LEFT`: a line that is gone earlier is gone at once.
AT_ONCE = 0.5
#: Least share of the power near a frequency that is in one pass, and longest pass as a fraction of the record.
ONE_PASS, SHORT = 0.6, 0.25
#: Standard deviations of the kernel of the band-pass over which a frequency is averaged.
AVERAGED = 2.0


def at_end_of_line(lines: SpectralLines, t_step: float, mode: Refined) -> bool:
    """Return whether the line of a sweep begins, ends, turns back or stands still at a mode.

    - lines: of the longest piece, without padding
    - t_step: between samples [s]
    """
    width = mode.rate / (2.0 * math.pi)
    half = max(WIDE * width, LEAST_WIDE * mode.frequency)
    length = round(1.0 / (lines.step * t_step))
    z, step = followed(lines.values @ along_shape(mode.shape), length, t_step, mode.pole, half)
    power = np.abs(z[:-1]) ** 2
    near = max(round(AVERAGED / (2.0 * math.pi * half * step)), 1)
    turns = np.convolve(z[1:] * z[:-1].conj(), np.ones(near), "same")
    away = np.angle(turns) / (2.0 * math.pi * step)  # of the frequency of the response from the mode's [Hz]
    reach = max(PASSED * width, LEAST_PASSED * half)
    ringing = AT_ONCE * -math.log(LEFT) / (2.0 * mode.rate * step)
    while_it_rings = np.ones(max(min(round(1.0 / (mode.rate * step)), len(power)), 1))
    top = int(np.argmax(np.convolve(power / (1.0 + (away / width) ** 2), while_it_rings, "same")))
    moved, samples = [], []
    for side in (slice(top, None, -1), slice(top, None)):
        passed = _first(np.abs(away[side]) > reach, near)
        gone = _first(power[side] < LEFT * power[top], near)
        faded = passed < min(gone, len(away[side])) and power[side][passed] < FADED * power[top]
        if ringing < gone < passed or faded:
            return False
        moved.append(float(np.sign(away[side][passed])) if passed < min(gone, len(away[side])) else 0.0)
        samples.append(min(passed, gone))
    one_pass = power[max(top - samples[0], 0) : top + samples[1] + 1].sum()
    all_power = power[np.abs(away) < reach].sum()
    comes = any(moved) and moved[0] * moved[1] >= 0.0  # a line that moves, and does not pass
    return bool(comes and one_pass > ONE_PASS * all_power > 0.0 and sum(samples) < SHORT * len(away))


def _first(held: NDArray[np.bool_], count: int) -> int:
    """Return the first index from which a condition holds for `count` samples; the length if it never does."""
    starts = np.flatnonzero(np.convolve(held, np.ones(count))[count - 1 : len(held)] >= count)
    return int(starts[0]) if starts.size else len(held)
