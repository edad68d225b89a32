"""Records that hold nothing but tones and the rounding of their numbers.

A record of an instrument is a multiple of a step.  The rounding of a tone is not noise: it repeats with the tone, and
its power, that of an even distribution over a step (Widrow and Kollar, Quantization Noise, 2008), lies in lines and
bands that look like modes.  Sensor noise, or modes, add power of their own.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.identification.tones import Tone, around

Array = NDArray[np.float64]
#: Largest distance from a multiple of the step, in steps, that the arithmetic of a conversion of units leaves.
OFF_STEP = 0.01
#: Differences relative to the range that are arithmetic, too.
ARITHMETIC = 1e-9
#: Power besides strong tones relative to that of the rounding, up to which there is nothing but rounding.
ALONE = 1.25
#: Rounding of any arithmetic, relative to the mean square of the record: no instrument has a range of 140 dB.
RANGE = 1e-14
#: A tone is strong if a line at it has this many times the power of the rounding; lines that it may reach on either
#: side, and the largest share of all lines that strong tones may reach.
STRONG, REACH, SHARE = 100.0, 40, 0.25


def step_of(signal: Array) -> float:
    """Return the step that all values of a signal, (N,), are multiples of apart; 0 if there is none."""
    levels = np.unique(signal)
    apart = np.diff(levels)
    apart = apart[apart > ARITHMETIC * (levels[-1] - levels[0])]
    if not apart.size:
        return 0.0
    step = float(apart.min())
    steps = (levels - levels[0]) / step
    return step if np.abs(steps - np.rint(steps)).max() < OFF_STEP else 0.0


def tones_alone(
    t_step: float,
    pieces: Sequence[Array],
    without_tones: Sequence[Array],
    tones: Sequence[Tone],
    band: tuple[float, float],
) -> list[Tone] | None:
    """Return the strong tones of a record that without them is the rounding of its numbers; None for any other.

    Parameters
    ----------
    t_step : float
        In s.
    pieces, without_tones : sequence of ndarray, shape (N, S)
        The record, and what is left of it without its tones.
    tones : sequence of Tone
        Those that were found in and near the band.
    band : tuple of float
        In Hz.
    """
    longest = max(range(len(pieces)), key=lambda i: len(pieces[i]))
    live = pieces[longest].std(axis=0) > 0.0
    whole = pieces[longest][:, live]
    before, after = _powers(whole), _powers(without_tones[longest][:, live])
    f = np.arange(len(after)) / (t_step * len(whole))
    of_steps = np.array([step_of(column) ** 2 / 12.0 for column in whole.T])
    # That of the arithmetic is so small that nothing else is below it in the band; of the whole rounding of steps the
    # band has a share that nobody knows.
    low, high = around(band)
    inside = (f > low) & (f < high)
    for floor, counted in ((of_steps, np.full(len(f), True)), (RANGE * whole.var(axis=0), inside)):
        strong, far = [], counted.copy()
        for tone in tones:
            k = int(np.argmin(np.abs(f - tone.frequency)))
            if (before[max(k - 1, 0) : k + 2] > STRONG * floor).any():
                strong.append(tone)
                far[max(k - REACH, 0) : k + REACH + 1] = False
        few = far.sum() >= (1.0 - SHARE) * counted.sum()
        if strong and few and (floor > 0.0).all() and (after[far].sum(axis=0) <= ALONE * floor).all():
            return strong
    return None


def _powers(signal: Array) -> Array:
    """Return the mean squares of a signal (N, S) by lines, (F, S)."""
    window = np.hanning(len(signal))
    spectrum = np.fft.rfft((signal - signal.mean(axis=0)) * window[:, None], axis=0)
    return np.asarray(2.0 * np.abs(spectrum) ** 2 / (len(signal) * (window**2).sum()))
