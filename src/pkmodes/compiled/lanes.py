"""A robot as the compiled evaluator takes it: its numbers in a row."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Lanes(NamedTuple):
    """A robot as the kernel takes it.

    Attributes
    ----------
    parameters, effects : ndarray
        Flat, in the order of the generated fields.
    joints : ndarray, shape (e,)
        Stiffnesses of the released joints, zero elsewhere.
    free : ndarray of int32, shape (n,)
        Which of all coordinates are not locked; none without effects.
    massless : ndarray of int8, shape (n,)
        Which of these have no inertia.
    """

    parameters: Array
    effects: Array
    joints: Array
    free: NDArray[np.int32]
    massless: NDArray[np.int8]


def flat(values: Any) -> Array:
    """The fields of a named tuple, one after the other."""
    return np.concatenate([np.ravel(np.asarray(value, dtype=float)) for value in values])
