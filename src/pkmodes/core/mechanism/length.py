"""The characteristic length of a platform that turns: it makes rotations comparable with displacements.

It is the root mean square distance of the platform's joints from its origin: a rotation times this length is about
how far they move.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.rotations import about, matrix_of
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.regular import sample

Array = NDArray[np.float64]
#: A pose from which to see which points move with the platform: displacement [m] and rotation [rad].
MOVED, TURNED = (0.011, -0.017, 0.013), (0.13, -0.19, 0.11)
#: Points that move with the platform do so to this part of their distance from it.
SAME = 1e-9


def characteristic_length(mechanism: Mechanism, parameters: Any) -> float:
    """Return the characteristic length of a robot [m]; 1 for a platform that does not turn."""
    if not mechanism.rotations:
        return 1.0
    return float(Generated(mechanism.model, parameters).characteristic_length())


def platform_points(mechanism: Mechanism, parameters: Any) -> Array:
    """Return the drawn points of a platform that turns, from its origin in platform axes, (k, 3) [m]."""
    places = list(_of_platform(mechanism))
    return (
        _drawn(mechanism, parameters, np.zeros(len(mechanism.pose)))[places] if places else np.empty((0, 3))
    )


def lengths_of(mechanism: Mechanism, parameters: Any) -> Array:
    """Return what turns each component of the platform's motion into a length: 1, or the characteristic length."""
    length = characteristic_length(mechanism, parameters)
    return np.array([1.0] * len(mechanism.directions) + [length] * len(mechanism.rotations))


def headings(mechanism: Mechanism) -> list[str]:
    """Return the headings of `unit_vectors` in tables: L is the characteristic length."""
    return [f"{one.name}*L" if one.unit == "rad" else one.name for one in mechanism.platform]


def unit_vectors(motions: Array, lengths: Array) -> Array:
    """Return motions of the platform, (..., components), as unit vectors, rotations times the characteristic length.

    Parameters
    ----------
    lengths : ndarray, shape (components,)
        From `lengths_of`.

    Returns
    -------
    ndarray
        0 where the platform does not move.
    """
    moved = motions * lengths
    size = np.linalg.norm(moved, axis=-1, keepdims=True)
    return np.asarray(moved / np.where(size > 0.0, size, 1.0))


@cache
def _of_platform(mechanism: Mechanism) -> tuple[int, ...]:
    """Return the drawn points that move with the platform, except those at its origin."""
    if not mechanism.rotations:
        return ()
    names = [component.name for component in mechanism.pose]
    size = len(mechanism.directions)
    pose, offset = np.zeros(len(names)), np.zeros(3)
    offset[["xyz".index(axis) for axis in mechanism.directions]] = MOVED[:size]
    angles = np.array(TURNED[: len(mechanism.rotations)])
    pose[[names.index(name) for name in mechanism.components]] = [*MOVED[:size], *angles]
    plain = sample(mechanism)
    first = _drawn(mechanism, plain, np.zeros(len(names)))
    turned = first @ matrix_of(about(mechanism.rotations, angles)).T + offset
    distance = np.linalg.norm(first, axis=-1)
    away = np.linalg.norm(turned - _drawn(mechanism, plain, pose), axis=-1)
    size_of_all = float(np.nanmax(distance))
    return tuple(np.flatnonzero((away <= SAME * size_of_all) & (distance > SAME * size_of_all)).tolist())


def _drawn(mechanism: Mechanism, parameters: Any, pose: Array) -> Array:
    """Return the drawn points at a pose, (points, 3); NaN where the machine cannot be there."""
    uprights = mechanism.drawing.uprights
    up = (np.tile([0.0, 0.0, 1.0], uprights),) if uprights else ()
    with np.errstate(all="ignore"):
        return np.asarray(Generated(mechanism.drawn, parameters).drawing_points(pose, *up), dtype=float)
