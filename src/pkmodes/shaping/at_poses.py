"""Shapers that follow the pose: designed for the modes of held motors at each pose."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.errors import PkmodesError
from pkmodes.shaping.kinds import factors
from pkmodes.shaping.ringing import Ringing, ringing
from pkmodes.shaping.shapers import Shaper, shaper
from pkmodes.solve.dynamics import Dynamics

Array = NDArray[np.float64]


def shaper_at(dynamics: Dynamics, kind: str, poses: ArrayLike, modes: int | None) -> Shaper:
    """Design shapers for poses: see `pkmodes.Model.shaper`."""
    count = len(factors(kind))
    checked = dynamics.kinematics.checked(poses, "raise")
    at = ringing(dynamics, checked.points, count if modes is None and count > 1 else modes)
    if at.left_out:
        what = f"at {at.left_out} of the poses a mode does not oscillate"
        raise PkmodesError(what, "poses", "pkmodes modes --drives held shows its frequency and damping ratio")
    found = own_shapers(kind, at)
    return Shaper(*(part.reshape(*checked.batch, -1) for part in found))


def own_shapers(kind: str, at: Ringing) -> Shaper:
    """Return the shaper of each pose, (N, n).

    Factor k of a product is for mode k.  A shaper without factors is for the mean frequency, weighted by the squared
    amplitudes: it has no jump where modes cross.

    Raises
    ------
    PkmodesError
        If a product has more factors than the machine has modes that count.
    """
    count = len(factors(kind))
    if count > at.frequencies.shape[1]:
        what = f"{kind} is for {count} modes, and {at.frequencies.shape[1]} count"
        raise PkmodesError(what, "kind", "leave out a factor, or count more modes")
    if count == 1:
        share = at.weights**2
        f, zeta = (np.average(each, axis=-1, weights=share) for each in (at.frequencies, at.damping_ratios))
        return shaper(kind, f, zeta)
    return shaper(kind, at.frequencies[:, :count], at.damping_ratios[:, :count])
