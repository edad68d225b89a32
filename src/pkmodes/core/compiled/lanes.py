"""A robot as the compiled evaluator takes it: its numbers in a row, and the paths along which they can change."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: The fields that the kernel writes.
FIELDS = (
    "frequencies",
    "eigenvalues",
    "shapes",
    "platform_shapes",
    "vibration_amplitudes",
    "joint_positions",
    "platform_motion",
    "platform_jacobian",
    "static_torque",
    "static_rotation",
    "elastic_stiffness",
    "mass_matrix",
    "stiffness_matrix",
)
#: Further fields that it writes if paths are given.
RATE_FIELDS = ("eigenvalue_rates", "frequency_rates")
#: Fields of m given modes that it writes at N poses along T paths: (dK - lambda dM) phi, (N, T, m, n), without terms
#: of locked joints; phi^T (dK - lambda dM) phi and phi^T dM phi, (N, T, m); dJ phi, (N, T, m, components), J the
#: motion of the platform.
MODE_RATE_FIELDS = ("changes", "mode_rates", "norms", "motions")
#: Further results along paths: dM and dK, (N, T, n, n), without terms of locked joints.
MATRIX_RATE_FIELDS = ("mass_rates", "stiffness_rates")
#: Further results: M and K in all coordinates, (N, e, e), without the springs of released joints.
FULL_MATRIX_FIELDS = ("mass_of_all", "stiffness_of_all")
#: The code of a pose whose eigenproblem needs another solver.
UNSOLVED = -1


class Fold(NamedTuple):
    """Coordinates that follow others: each of the former is a weight times one of the latter.

    - leading, following: among all coordinates, (f,)
    - weights: (f,)
    """

    leading: NDArray[np.int32]
    following: NDArray[np.int32]
    weights: Array


#: No coordinate follows another.
NO_FOLD = Fold(np.empty(0, dtype=np.int32), np.empty(0, dtype=np.int32), np.empty(0))


class Lanes(NamedTuple):
    """A robot as the kernel takes it, or several that differ only in numbers.

    - parameters, effects: flat, in the order of the generated fields; a row for each of several robots
    - joints: stiffnesses of the released joints, zero elsewhere, (e,); (B, e) for several robots
    - free: which of all coordinates are not locked, (n,); none without effects
    - massless: which of these have no inertia, (n,)
    - fold: coordinates that are not free and follow these
    """

    parameters: Array
    effects: Array
    joints: Array
    free: NDArray[np.int32]
    massless: NDArray[np.int8]
    fold: Fold = NO_FOLD

    @property
    def robots(self) -> int:
        """Number of robots."""
        return len(self.parameters) if self.parameters.ndim > 1 else 1


class Terms(NamedTuple):
    """T parameter paths, along each of which the derivative is a weighted sum of entries of the gradient.

    The gradient has an entry for each parameter, effect, component of the pose and coordinate, in this order.  That
    of a coordinate is the derivative with respect to the stiffness of its joint or, where the joint is locked, its
    compliance.

    - first: where the terms of each path begin, and where the last ones end, (T + 1,); (B, T + 1) for several robots
    - places: entry of each term
    - weights: weight of each term
    - effects: those of the robot, flat, also where all are null
    - all_coordinates: whether there are terms of effects, so that the model with effects is differentiated also for a
      robot that has none
    - locked_joints: whether there are terms of locked joints
    """

    first: NDArray[np.int32]
    places: NDArray[np.int32]
    weights: Array
    effects: Array
    all_coordinates: bool
    locked_joints: bool


def no_paths(effects: Array) -> Terms:
    """Return the terms of no path of a robot with effects."""
    empty = np.empty(0)
    return Terms(np.zeros(1, dtype=np.int32), empty.astype(np.int32), empty, effects, False, False)


def flattened(values: Any) -> Array:
    """The fields of a named tuple, one after the other."""
    return np.concatenate(values, axis=None, dtype=float)
