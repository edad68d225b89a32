"""Sensors and forces on a turning platform: how a sensor reads its motion, and how a force acts on it.

At a pose with the rotation R, a sensor at the point b of the platform and along the unit vector d of the base reads

    d . (v + omega x R b) = d . v + (R b x d) . omega

of the velocity v of the platform's origin and of its angular velocity omega, both along base axes.  By reciprocity
these numbers, (d, R b x d), are also the generalised force of a force along d at b.  A gyroscope reads d . omega
wherever it sits.

Sensors screwed to the platform turn with it: `direction` and `at` of a campaign are along the platform's axes, so
that one line describes a sensor at all poses.  The channels ``p_x`` and ``r_x`` are along base axes, as their columns
are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.rotations import AXES, matrices_of_vectors, vectors_about

Array = NDArray[np.float64]
Vector = tuple[float, float, float]
#: Prefixes of the names of the platform's displacements and rotations.
DISPLACEMENT, ROTATION = "p_", "r_"
ORIGIN = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Platform:
    """The axes along which and about which a robot's platform moves; empty for a structure without a platform."""

    directions: tuple[str, ...] = ()
    rotations: tuple[str, ...] = ()

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the components of its motion."""
        prefixes_and_axes = (DISPLACEMENT, self.directions), (ROTATION, self.rotations)
        return tuple(f"{prefix}{axis}" for prefix, axes in prefixes_and_axes for axis in axes)

    def rotation(self, pose: Mapping[str, float]) -> Array:
        """Return the rotation, (3, 3), at a pose whose components ``r`` + axis are a rotation vector [rad]."""
        return matrices_of_vectors(
            vectors_about(self.rotations, np.array([pose[f"r{axis}"] for axis in self.rotations]))
        )


@dataclass(frozen=True)
class Mount:
    """How something is fixed to a platform that turns.

    - direction: unit vector
    - turns_with_platform: whether the direction is along the platform's axes, which turn, or along those of the base
    - position: in platform axes from the platform's origin [m]
    - angular: whether it measures a rotation about its direction, or applies a torque
    """

    direction: Vector
    turns_with_platform: bool
    position: Vector
    angular: bool
    platform: Platform

    @property
    def sensed_components(self) -> tuple[str, ...]:
        """Names of the platform's displacement components, or of its rotation components if angular."""
        prefix = ROTATION if self.angular else DISPLACEMENT
        return tuple(name for name in self.platform.components if name.startswith(prefix))

    def motion_weights(self, R: Array) -> dict[str, float]:
        """Return the reading per unit of each motion component of a platform with the rotation R, (3, 3)."""
        direction = np.array(self.direction)
        direction = R @ direction if self.turns_with_platform else direction
        if self.angular:
            linear, rotational = np.zeros(3), direction
        else:
            linear, rotational = direction, np.cross(R @ np.array(self.position), direction)
        vectors = {DISPLACEMENT: linear, ROTATION: rotational}
        return {name: float(vectors[name[:2]][AXES.index(name[2:])]) for name in self.platform.components}


def vector_along(axes: Sequence[str], numbers: Sequence[float]) -> Vector:
    """Return the vector with these components along these axes, and 0 along the others."""
    x, y, z = vectors_about(axes, np.asarray(numbers, dtype=float)).tolist()
    return x, y, z


def rms_distance(mounts: Sequence[Mount]) -> float:
    """Return the rms distance of sensors from their centre [m], 1 m if they all sit at one point.

    The distance makes rotations comparable with displacements.
    """
    positions = np.array([mount.position for mount in mounts if not mount.angular] or [ORIGIN])
    distance = float(np.sqrt(((positions - positions.mean(axis=0)) ** 2).sum(axis=1).mean()))
    return distance if distance > 0.0 else 1.0
