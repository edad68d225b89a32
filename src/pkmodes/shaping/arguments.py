"""Frequencies and damping ratios from the caller."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.arguments import real_numbers
from pkmodes.base.errors import PkmodesError

Array = NDArray[np.float64]
#: What to do about arguments that are no numbers.
GIVE = "give a number, or an array of numbers"


def checked_modes(frequencies: ArrayLike, damping_ratios: ArrayLike) -> tuple[Array, Array]:
    """Return frequencies [Hz] and damping ratios [-] as arrays of one shape.

    Raises
    ------
    PkmodesError
        If a frequency is not a positive finite number, a ratio is not in [0, 1), or the shapes do not go together.
    """
    f = real_numbers(frequencies, "frequencies in Hz", "frequencies", GIVE)
    zeta = real_numbers(damping_ratios, "damping ratios", "damping_ratios", GIVE)
    _refuse(
        f,
        ~(np.isfinite(f) & (f > 0.0)),
        "frequencies",
        "positive frequencies in Hz",
        "leave out rigid modes and poses without modes",
    )
    _refuse(
        zeta,
        ~((zeta >= 0.0) & (zeta < 1.0)),
        "damping_ratios",
        "damping ratios from 0 to below 1",
        "a mode with a ratio of 1 or more does not oscillate; 2 % is 0.02",
    )
    try:
        f, zeta = np.broadcast_arrays(f, zeta)
    except ValueError:
        what = f"expected one ratio, or one for each of the frequencies {f.shape}, found {zeta.shape}"
        raise PkmodesError(what, "damping_ratios", "give arrays of the same shape") from None
    return f, zeta


def _refuse(values: Array, bad: NDArray[np.bool_], where: str, expected: str, remedy: str) -> None:
    """Raise the error of the first bad value, if there is one."""
    if bad.any():
        index = tuple(int(i) for i in np.unravel_index(int(np.argmax(bad)), bad.shape))
        place = f"{where}[{', '.join(map(str, index))}]" if index else where
        raise PkmodesError(f"expected {expected}, found {values[index]:g}", place, remedy)
