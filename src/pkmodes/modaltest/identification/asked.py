"""The user's edits of an identification: modes that are not real, and frequencies at which a mode is to be fitted.

A requested mode needs no evidence against all lines of a measurement, as one found by a search does, but only against
those that it may be fitted to.  Its fit must still be that of a mode: near the frequency, and above the noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

#: A frequency refers to the mode within this distance, relative; and an added mode replaces one within it.
NEAR = 0.01
#: A mode is added if its fit stays within this distance of the requested frequency, relative.
REACH = 0.03


@dataclass(frozen=True)
class RequestedModes:
    """Frequencies that the user names [Hz].

    - strike: where there is no mode: what was found there is not fitted along with an added mode
    - add: where a mode is fitted
    """

    strike: tuple[float, ...] = ()
    add: tuple[float, ...] = ()


#: No edits.
NOTHING = RequestedModes()


def nearest_frequency(frequencies: Sequence[float] | NDArray[np.float64], target: float) -> int | None:
    """Return the index of the frequency nearest to a target, None if none is within `NEAR`."""
    away = np.abs(np.asarray(frequencies, float) / target - 1.0)
    return int(away.argmin()) if away.size and away.min() <= NEAR else None


def struck(frequencies: NDArray[np.float64], edits: RequestedModes) -> NDArray[np.bool_]:
    """Return which of the frequencies (N,) are struck out."""
    dropped = np.zeros(len(frequencies), bool)
    for target in edits.strike:
        i = nearest_frequency(np.where(dropped, np.inf, frequencies), target)
        if i is not None:
            dropped[i] = True
    return dropped


def replaced(
    frequencies: Sequence[float] | NDArray[np.float64], edits: RequestedModes, added: float
) -> int | None:
    """Return which of the frequencies an added mode replaces, None for none; those struck out are not replaced."""
    candidates = np.asarray(frequencies, float)
    return nearest_frequency(np.where(struck(candidates, edits), np.inf, candidates), added)


def within_reach(frequency: float, target: float) -> bool:
    """Return whether a fit that ended at a frequency is the requested mode."""
    return abs(frequency / target - 1.0) <= REACH
