"""The user's edits of an identification: modes that are not real, and frequencies at which a mode is to be fitted.

A mode found by a search must stand out among all lines of a measurement, a requested mode only among those to which
it may be fitted.  Its fit must still be that of a mode: near the frequency, and above the noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

#: Largest relative distance of a frequency from the mode that it refers to, and of an added mode from the one that it
#: replaces.
SAME_MODE_TOLERANCE = 0.01
#: Largest relative distance of a fitted mode from the requested frequency.
MAX_SHIFT = 0.03


@dataclass(frozen=True)
class RequestedModes:
    """Frequencies that the user names [Hz].

    - strike: frequencies of modes that are not real: they are not fitted together with an added mode
    - add: frequencies at which a mode is fitted
    """

    strike: tuple[float, ...] = ()
    add: tuple[float, ...] = ()


#: No edits.
NO_EDITS = RequestedModes()


def nearest_frequency(frequencies: Sequence[float] | NDArray[np.float64], target: float) -> int | None:
    """Return the index of the frequency nearest to a target, None if none is within `SAME_MODE_TOLERANCE`."""
    distance = np.abs(np.asarray(frequencies, float) / target - 1.0)
    return int(distance.argmin()) if distance.size and distance.min() <= SAME_MODE_TOLERANCE else None


def struck_mask(frequencies: NDArray[np.float64], edits: RequestedModes) -> NDArray[np.bool_]:
    """Return which of the frequencies (N,) are struck out."""
    mask = np.zeros(len(frequencies), bool)
    for target in edits.strike:
        i = nearest_frequency(np.where(mask, np.inf, frequencies), target)
        if i is not None:
            mask[i] = True
    return mask


def index_to_replace(
    frequencies: Sequence[float] | NDArray[np.float64], edits: RequestedModes, added: float
) -> int | None:
    """Return which of the frequencies an added mode replaces, None for none; those struck out are not replaced."""
    candidates = np.asarray(frequencies, float)
    return nearest_frequency(np.where(struck_mask(candidates, edits), np.inf, candidates), added)


def near_request(frequency: float, target: float) -> bool:
    """Return whether a fit that ended at a frequency is the requested mode."""
    return abs(frequency / target - 1.0) <= MAX_SHIFT
