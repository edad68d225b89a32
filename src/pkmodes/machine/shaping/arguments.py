"""Frequencies, damping ratios and shapers from the caller."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import real_numbers
from pkmodes.core.base.errors import PkmodesError, shown

Array = NDArray[np.float64]
#: Remedy for arguments that are not numbers.
NUMBERS_REMEDY = "give a number, or an array of numbers"
DESIGN_REMEDY = "design it with pkmodes.machine.shaping.shaper or Model.shaper"
#: Tolerance of the sum of a shaper's amplitudes, for rounding and values with few decimals.
SUM_TOLERANCE = 1e-3


def checked_modes(frequencies: ArrayLike, damping_ratios: ArrayLike) -> tuple[Array, Array]:
    """Return frequencies [Hz] and damping ratios [-] as arrays of one shape.

    Raises PkmodesError if a frequency is not a positive finite number, a ratio is not in [0, 1), or the shapes do not
    go together.
    """
    f = real_numbers(frequencies, "frequencies in Hz", "frequencies", NUMBERS_REMEDY)
    zeta = real_numbers(damping_ratios, "damping ratios", "damping_ratios", NUMBERS_REMEDY)
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
        problem = f"expected one ratio, or one for each of the frequencies {f.shape}, found {zeta.shape}"
        raise PkmodesError(problem, "damping_ratios", "give arrays of the same shape") from None
    return f, zeta


def checked_impulses(shaper: Any) -> tuple[Array, Array]:
    """Return the amplitudes and delays of a shaper as arrays of one shape (..., n).

    Raises PkmodesError if it is not a shaper, an amplitude is negative, their sum is not 1, or the delays do not
    ascend from 0.
    """
    try:
        parts = [np.asarray(part, dtype=float) for part in (shaper.amplitudes, shaper.delays)]
        if parts[0].shape[-1:] != parts[1].shape[-1:]:
            raise ValueError
        amplitudes, delays = np.broadcast_arrays(*parts)
    except (AttributeError, TypeError, ValueError):
        problem = f"expected a shaper with as many amplitudes as delays, found {shown(shaper)}"
        raise PkmodesError(problem, "shaper", DESIGN_REMEDY) from None
    if not delays.ndim or not delays.shape[-1]:
        raise PkmodesError("expected a shaper with impulses, found none", "shaper", DESIGN_REMEDY)
    sums = amplitudes.sum(axis=-1)
    if not (amplitudes >= 0.0).all() or not (np.abs(sums - 1.0) <= SUM_TOLERANCE).all():
        worst = np.unravel_index(np.argmax(np.abs(sums - 1.0)), sums.shape)
        shown_amplitudes = ", ".join(f"{amplitude:.4g}" for amplitude in amplitudes[worst])
        problem = f"expected amplitudes that are not negative, with the sum 1, found {shown_amplitudes}"
        raise PkmodesError(problem, "shaper", DESIGN_REMEDY)
    if not (np.isfinite(delays).all() and (delays[..., 0] == 0.0).all() and (np.diff(delays) >= 0.0).all()):
        raise PkmodesError("expected delays in s that ascend from 0", "shaper", DESIGN_REMEDY)
    return amplitudes, delays


def _refuse(values: Array, invalid_mask: NDArray[np.bool_], where: str, expected: str, remedy: str) -> None:
    """Raise the error of the first bad value, if there is one."""
    if invalid_mask.any():
        index = tuple(int(i) for i in np.unravel_index(int(np.argmax(invalid_mask)), invalid_mask.shape))
        place = f"{where}[{', '.join(map(str, index))}]" if index else where
        raise PkmodesError(f"expected {expected}, found {values[index]:g}", place, remedy)
