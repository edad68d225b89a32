"""Wholes of the three axes, taken apart into the elements that their change moves.

`axis.span` moves both ends of every axis evenly, `axis.joint_radius` every joint along its own direction.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pkmodes.errors import PkmodesError

Array = NDArray[np.float64]


def limits_of_span(limits: Array, span: float) -> dict[str, float]:
    """Limits by path that give the first axis a span (max - min), and change those of the others as much.

    Parameters
    ----------
    limits : ndarray, shape (3, 2)
        As they are [m].
    span : float
        As it shall be [m].
    """
    half = (span - float(limits[0, 1] - limits[0, 0])) / 2.0
    found = {}
    for j, (low, high) in enumerate(limits.tolist(), start=1):
        for name, value in (("min", low - half), ("max", high + half)):
            # Rounding must not leave a limit of 1e-17 m where 0 is meant.
            found[f"axis.{j}.limits.{name}"] = 0.0 if abs(value) < 1e-12 * (high - low) else value
    return found


def joints_of_radius(joints: Array, radius: float, source: str) -> dict[str, float]:
    """Elements of the joints by path that put the first at a distance from the centre, and move the others as much.

    Parameters
    ----------
    joints : ndarray, shape (3, 3)
        As they are [m].
    radius : float
        As that of the first shall be [m].
    source : str
        The robot file, for messages.

    Raises
    ------
    PkmodesError
        If a joint has no direction in which it could move, or would reach the centre.
    """
    radii = [math.hypot(*joint) for joint in joints.tolist()]
    change = radius - radii[0]
    found = {}
    for j, (joint, before) in enumerate(zip(joints.tolist(), radii, strict=True), start=1):
        if before == 0.0 or before + change <= 0.0:
            reason = "it is 0" if before == 0.0 else f"it would become {before + change:g} m"
            raise PkmodesError(
                f"the radius of joint {j} cannot be changed along its direction: {reason}",
                f"{source}: axis.{j}.joint",
                "correct the elements of the joint instead",
            )
        for name, element in zip("xyz", joint, strict=True):
            if element != 0.0:
                found[f"axis.{j}.joint.{name}"] = element * ((before + change) / before)
    return found
