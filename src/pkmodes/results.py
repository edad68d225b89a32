"""What an evaluation gives: modes and statics, in the shape of the caller's poses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Modes:
    """Small vibrations about the static equilibrium at each pose.

    The leading axes are those of the poses: none for a single pose of shape (3,), (N,) for poses of shape
    (N, 3).  n is the number of coordinates, 9 for the base model; m, the number of modes, is n less the
    coordinates without inertia.  Modes are sorted by eigenvalue, the rigid-body ones first.  Entries of poses
    that could not be evaluated are NaN.

    Attributes
    ----------
    poses : ndarray, shape (..., 3)
        Platform centres [m], base frame.
    coordinates : tuple of str, length n
        Names of the generalised coordinates, in the order of the matrices.
    frequencies : ndarray, shape (..., m)
        sqrt(abs(lambda)) / (2 pi) with the sign of lambda [Hz].
    shapes : ndarray, shape (..., m, n)
        ``shapes[..., i, :]`` is mode i, mass-normalised (phi^T M phi = 1) with a deterministic sign.
    platform_shapes : ndarray, shape (..., m, 3)
        Absolute motion of the platform centre in each mode, base frame: D_p times the carriage components, and
        what released joints and the frame add.
    carriage_positions : ndarray, shape (..., 3)
        x_1, x_2, x_3 [m].
    mass_matrix, stiffness_matrix : ndarray, shape (..., n, n)
        M and K in SI units.
    rigid_modes : int
        Number of modes that strain nothing elastic: they come first.
    valid : ndarray of bool, shape (...)
        Which poses could be evaluated.
    """

    poses: Array
    coordinates: tuple[str, ...]
    frequencies: Array
    shapes: Array
    platform_shapes: Array
    carriage_positions: Array
    mass_matrix: Array
    stiffness_matrix: Array
    rigid_modes: int
    valid: NDArray[np.bool_]


@dataclass(frozen=True)
class Statics:
    """Static equilibrium at each pose (equation 44): what holds the platform against gravity.

    Attributes
    ----------
    torques : ndarray, shape (..., 3)
        Torques on the driven pulleys of axes 1 to 3 [N m], positive with theta.
    pulley_rotations : ndarray, shape (..., 6)
        Rotations from the unstrained belts [rad], in the order of the coordinates theta.
    valid : ndarray of bool, shape (...)
        Which poses could be evaluated.
    """

    torques: Array
    pulley_rotations: Array
    valid: NDArray[np.bool_]
