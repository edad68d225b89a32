"""What the user asks of an identification: modes that are none, and frequencies from which a mode is fitted.

A mode that is asked for needs no proof among all lines of a measurement, as one that a search finds, but only among
those that it may be fitted to.  Its fit must still be a mode's: it stays near the frequency, and is more than noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

#: A frequency means the mode within this of it, relative; and an added mode replaces one within this.
NEAR = 0.01
#: A mode is added if its fit stays within this of the frequency asked for, relative.
REACH = 0.03


@dataclass(frozen=True)
class Asked:
    """Frequencies that the user names [Hz].

    Attributes
    ----------
    strike : tuple of float
        Where there is no mode: no other mode is fitted beside it when one is added.
    add : tuple of float
        From which a mode is fitted.
    """

    strike: tuple[float, ...] = ()
    add: tuple[float, ...] = ()


#: Nothing is asked for.
NOTHING = Asked()


def nearest(frequencies: Sequence[float] | NDArray[np.float64], target: float) -> int | None:
    """Return the index of the frequency nearest to a wanted one, None if none is within `NEAR`."""
    away = np.abs(np.asarray(frequencies, float) / target - 1.0)
    return int(away.argmin()) if away.size and away.min() <= NEAR else None


def struck(frequencies: NDArray[np.float64], edits: Asked) -> NDArray[np.bool_]:
    """Return which of the frequencies (N,) are struck out."""
    dropped = np.zeros(len(frequencies), bool)
    for target in edits.strike:
        i = nearest(np.where(dropped, np.inf, frequencies), target)
        if i is not None:
            dropped[i] = True
    return dropped


def replaced(frequencies: Sequence[float] | NDArray[np.float64], edits: Asked, added: float) -> int | None:
    """Return which of the frequencies an added mode replaces, None for none; those struck out stay what they are."""
    candidates = np.asarray(frequencies, float)
    return nearest(np.where(struck(candidates, edits), np.inf, candidates), added)


def within_reach(frequency: float, target: float) -> bool:
    """Return whether a fit that ended at a frequency is of the mode asked for."""
    return abs(frequency / target - 1.0) <= REACH
