"""The poses within the usable limits of a robot."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.rods import singular_angles
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import (
    RADIUS_COMPONENTS,
    Bound,
    Limits,
    Radius,
    SingularAngle,
    is_component_limit,
)

Array = NDArray[np.float64]


def bounding_box(mechanism: Mechanism, usable: Mapping[str, Bound]) -> tuple[Array, Array]:
    """Return the lower and upper ends, (d,) each, of a box around the usable poses; infinite without a limit."""
    limits = {name: Limits(*bound) for name, bound in usable.items() if is_component_limit(bound)}
    for bound in usable.values():
        if isinstance(bound, Radius):
            for name, centre in zip(RADIUS_COMPONENTS, bound.about, strict=True):
                low, high = limits.get(name, (-np.inf, np.inf))
                limits[name] = Limits(max(low, centre - bound.value), min(high, centre + bound.value))
    bounds = [limits.get(component.name, (-np.inf, np.inf)) for component in mechanism.pose]
    return np.array([low for low, _ in bounds]), np.array([high for _, high in bounds])


def within_limits(robot: Robot, points: Array) -> NDArray[np.bool_]:
    """Return which poses, (..., d), are within all usable limits of a robot."""
    mechanism, names = robot.mechanism, [component.name for component in robot.mechanism.pose]
    usable = np.ones(points.shape[:-1], dtype=bool)
    for name, bound in robot.usable.items():
        if isinstance(bound, Radius):
            offsets = points[..., [names.index(component) for component in RADIUS_COMPONENTS]] - bound.about
            usable &= np.hypot(offsets[..., 0], offsets[..., 1]) <= bound.value
        elif isinstance(bound, SingularAngle):
            angles = singular_angles(mechanism, robot.parameters, points[usable])
            usable[usable] = (angles >= bound.value).all(axis=-1)
        else:
            low, high = bound
            value = points[..., names.index(name)]
            usable &= (value >= low) & (value <= high)
    return usable
