"""The poses within the usable limits of a robot."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.rods import singular_angles
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import ACROSS, Bound, Limits, Radius, SingularAngle, of_component

Array = NDArray[np.float64]


def limits_of(mechanism: Mechanism, usable: Mapping[str, Bound]) -> tuple[Array, Array]:
    """Return a box around what is usable: its lower and upper ends, (d,) each, infinite where there are none."""
    ends = {name: Limits(*bound) for name, bound in usable.items() if of_component(bound)}
    for bound in usable.values():
        if isinstance(bound, Radius):
            for name, middle in zip(ACROSS, bound.about, strict=True):
                low, high = ends.get(name, (-np.inf, np.inf))
                ends[name] = Limits(max(low, middle - bound.value), min(high, middle + bound.value))
    bounds = [ends.get(component.name, (-np.inf, np.inf)) for component in mechanism.pose]
    return np.array([low for low, _ in bounds]), np.array([high for _, high in bounds])


def inside(robot: Robot, points: Array) -> NDArray[np.bool_]:
    """Return which poses, (..., d), are within all usable limits of a robot."""
    mechanism, names = robot.mechanism, [component.name for component in robot.mechanism.pose]
    good = np.ones(points.shape[:-1], dtype=bool)
    for name, bound in robot.usable.items():
        if isinstance(bound, Radius):
            across = points[..., [names.index(component) for component in ACROSS]] - bound.about
            good &= np.hypot(across[..., 0], across[..., 1]) <= bound.value
        elif isinstance(bound, SingularAngle):
            angles = singular_angles(mechanism, robot.parameters, points[good])
            good[good] = (angles >= bound.value).all(axis=-1)
        else:
            low, high = bound
            value = points[..., names.index(name)]
            good &= (value >= low) & (value <= high)
    return good
