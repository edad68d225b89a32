r"""Rotations as rotation vectors r, with :math:`R = \exp([r]_\times)`.

A small rotation :math:`\omega` about base axes turns R into :math:`\exp([\omega]_\times) R`, and changes the rotation
vector by :math:`J(r)^{-1} \omega`, where

.. math:: J(r) = I + \frac{1 - \cos\vartheta}{\vartheta^2} [r]_\times
    + \frac{\vartheta - \sin\vartheta}{\vartheta^3} [r]_\times^2 , \qquad \vartheta = |r| .

Chirikjian, *Stochastic Models, Information Theory, and Lie Groups*, vol. 2 (2012), section 10.8.6.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
AXES = ("x", "y", "z")
#: Angles below which the series of the coefficients are exact to rounding [rad].
SMALL_ANGLE = 1e-3


def vectors_about(axes: Sequence[str], angles: Array) -> Array:
    """Return rotation vectors, (..., 3), from their components about some axes, (..., k)."""
    vectors = np.zeros((*angles.shape[:-1], 3))
    vectors[..., [AXES.index(axis) for axis in axes]] = angles
    return vectors


def matrices_of_vectors(vectors: Array) -> Array:
    """Return the rotation matrices of rotation vectors, (..., 3) to (..., 3, 3)."""
    flat = _rotation_class().from_rotvec(vectors.reshape(-1, 3)).as_matrix()
    return np.asarray(flat.reshape(*vectors.shape, 3))


def vectors_of_matrices(matrices: Array) -> Array:
    """Return the rotation vectors of rotations of less than half a turn, (..., 3, 3) to (..., 3)."""
    flat = _rotation_class().from_matrix(matrices.reshape(-1, 3, 3)).as_rotvec()
    return np.asarray(flat.reshape(matrices.shape[:-1]))


def _rotation_class() -> Any:
    # Imported here: it takes longer than the rest of the core.
    from scipy.spatial.transform import Rotation

    return Rotation


def left_jacobian(vectors: Array) -> Array:
    """Return J(r), the small rotation about base axes per change of the rotation vector, (..., 3, 3)."""
    angle = np.linalg.norm(vectors, axis=-1)[..., None, None]
    small = angle < SMALL_ANGLE
    safe_angle = np.where(small, 1.0, angle)
    coefficient_1 = np.where(small, 0.5 - angle**2 / 24.0, 2.0 * (np.sin(0.5 * safe_angle) / safe_angle) ** 2)
    coefficient_2 = np.where(
        small, 1.0 / 6.0 - angle**2 / 120.0, (safe_angle - np.sin(safe_angle)) / safe_angle**3
    )
    cross = np.cross(np.eye(3), vectors[..., None, :])
    return np.asarray(np.eye(3) + coefficient_1 * cross + coefficient_2 * (cross @ cross))
