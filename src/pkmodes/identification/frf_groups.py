"""Groups of modes that overlap, and the lines around them that tell their parameters."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Modes nearer than this many half bandwidths of both together are fitted together.
OVERLAP = 4.0
#: Lines up to this many half bandwidths from a mode are used: 94 % of what is known of its pole is within 10.
REACH = 10.0
#: but at least so many lines on each side, so that noise can be told from what is smooth,
FEWEST = 24
#: and at most so many in a window: a mode over more lines is determined by every second or third as well.
MOST = 400


def groups(poles: Complex) -> list[NDArray[np.int64]]:
    """Return the indices of modes to be fitted together, each group by ascending frequency."""
    order = np.argsort(poles.imag)
    found: list[list[int]] = []
    for i in order:
        if found and any(_near(poles[i], poles[k]) for k in found[-1]):
            found[-1].append(int(i))
        else:
            found.append([int(i)])
    return [np.array(group) for group in found]


def lines_around(frequencies: Array, poles: Complex) -> NDArray[np.int64]:
    """Return the indices of the lines (F,) [Hz] for a group of modes."""
    centres, halves = poles.imag / (2.0 * math.pi), np.abs(poles.real) / (2.0 * math.pi)
    near = np.zeros(len(frequencies), bool)
    for centre, half in zip(centres, halves, strict=True):
        middle = int(np.searchsorted(frequencies, centre))
        near[max(middle - FEWEST, 0) : middle + FEWEST] = True
        near |= np.abs(frequencies - centre) <= REACH * half
    chosen = np.flatnonzero(near)
    chosen = np.arange(chosen[0], chosen[-1] + 1)
    short = 2 * FEWEST - len(chosen)
    if short > 0:  # at an end of the band
        first = max(int(chosen[0]) - short, 0)
        chosen = np.arange(first, min(first + 2 * FEWEST, len(frequencies)))
    return chosen[:: max(1, len(chosen) // MOST)]


def _near(one: complex, other: complex) -> bool:
    return abs(one.imag - other.imag) < OVERLAP * (abs(one.real) + abs(other.real))
