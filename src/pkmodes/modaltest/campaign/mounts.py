"""Sensors and blows on a turning platform: how each responds to the platform's motion.

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
    """The axes along which and about which a robot's platform moves; none of another structure."""

    directions: tuple[str, ...] = ()
    rotations: tuple[str, ...] = ()

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the components of its motion."""
        axes_by_prefix = (DISPLACEMENT, self.directions), (ROTATION, self.rotations)
        return tuple(f"{kind}{axis}" for kind, axes in axes_by_prefix for axis in axes)

    def rotation(self, point: Mapping[str, float]) -> Array:
        """Return its rotation, (3, 3), at a pose whose components ``r`` + axis are a rotation vector [rad]."""
        return matrices_of_vectors(
            vectors_about(self.rotations, np.array([point[f"r{axis}"] for axis in self.rotations]))
        )


@dataclass(frozen=True)
class Mount:
    """How something is fixed to a platform that turns.

    - direction: unit vector
    - turns: whether the direction is along the platform's axes, which turn, or along those of the base
    - at: its position in platform axes from the platform's origin [m]
    - angular: whether it measures a rotation about its direction, or is a torque
    """

    direction: Vector
    turns: bool
    at: Vector
    angular: bool
    platform: Platform

    @property
    def sensed_components(self) -> tuple[str, ...]:
        """The components of the platform's motion that have its unit."""
        kind = ROTATION if self.angular else DISPLACEMENT
        return tuple(name for name in self.platform.components if name.startswith(kind))

    def weights(self, R: Array) -> dict[str, float]:
        """Return its reading per unit of each motion component of a platform with the rotation R, (3, 3)."""
        d = np.array(self.direction)
        d = R @ d if self.turns else d
        linear, rotational = (np.zeros(3), d) if self.angular else (d, np.cross(R @ np.array(self.at), d))
        vectors = {DISPLACEMENT: linear, ROTATION: rotational}
        return {name: float(vectors[name[:2]][AXES.index(name[2:])]) for name in self.platform.components}


def vector_along(axes: Sequence[str], numbers: Sequence[float]) -> Vector:
    """Return the vector with these components along these axes, and 0 along the others."""
    x, y, z = vectors_about(axes, np.asarray(numbers, dtype=float)).tolist()
    return x, y, z


def rms_distance(mounts: Sequence[Mount]) -> float:
    """Return the rms distance of sensors from their centre [m], 1 m if they all sit at one point.

    It makes rotations comparable with displacements.
    """
    positions = np.array([mount.at for mount in mounts if not mount.angular] or [ORIGIN])
    distance = float(np.sqrt(((positions - positions.mean(axis=0)) ** 2).sum(axis=1).mean()))
    return distance if distance > 0.0 else 1.0
