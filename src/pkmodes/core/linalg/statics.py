"""Small vibration problems: compliance, stiffness in the softest direction, and amplitudes after a step."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def compliance(stiffness: Array, motion: Array) -> Array:
    """Return the displacement of some outputs per force on them, L K^-1 L^T, symmetric, (N, d, d).

    - stiffness: K, (N, r, r)
    - motion: L, the outputs per unit of the coordinates, (N, d, r)
    """
    flexibility = motion @ np.linalg.solve(stiffness, np.swapaxes(motion, -1, -2))
    return np.asarray(0.5 * (flexibility + np.swapaxes(flexibility, -1, -2)))


def softest_stiffness(stiffness: Array, motion: Array) -> Array:
    """Return the smallest eigenvalue of the stiffness against forces on some outputs, (N,).

    It is that of the inverse of the `compliance`, negative where the system is not stable.  Arguments are the same.
    """
    compliances = np.linalg.eigvalsh(compliance(stiffness, motion))
    with np.errstate(divide="ignore"):
        return np.asarray((1.0 / compliances).min(axis=-1))


def step_amplitudes(eigenvalues: Array, shapes: Array, outputs: Array, momenta: Array) -> Array:
    r"""Return the amplitude with which each mode rings after a step of acceleration, (N, m, j).

    .. math:: |l \phi_i| \, |\phi_i^T M r_j| \, / \, \omega_i^2

    - eigenvalues: omega_i^2, (N, m) [1/s^2]
    - shapes: phi_i, mass-normalised, (N, m, n)
    - outputs: l phi_i, (N, m, d): the norm over the d outputs counts
    - momenta: M r_j, with the motion r_j that is accelerated by 1, (N, n, j)
    """
    output_sizes = np.linalg.norm(outputs, axis=-1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(output_sizes * np.abs(shapes @ momenta) / np.abs(eigenvalues)[..., None])
