r"""Derivatives of mode shapes by modal expansion, for fits that need them many times.

With :math:`z_i = (dK - \lambda_i dM) \phi_i` and mass-normalised modes,

.. math:: d\phi_i = \sum_{j \ne i} \phi_j \frac{\phi_j^T z_i}{\lambda_i - \lambda_j}
    - \tfrac12 \phi_i \, \phi_i^T dM \, \phi_i

(Fox and Kapoor, AIAA Journal 6(12), 1968), which is exact with all modes.  Coordinates without inertia follow the
others statically, and a locked joint with a compliance deflects under its force.  `sensitivity.modes` computes the
same from one linear system for each mode: slower, but accurate to the last digit even for nearly coincident modes.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from pkmodes.sensitivity.matrices import MatrixDerivatives

Array = NDArray[np.float64]
#: Lower bound of the difference between two eigenvalues in the denominator, relative to the larger of the two.
SMALLEST_GAP = 1e-6
#: The same relative to the largest eigenvalue: smaller differences, as between rigid-body modes, are rounding.
ROUNDING = float(np.finfo(float).eps)


def shape_derivatives(
    derivatives: MatrixDerivatives,
    eigenvalues: Array,
    shapes: Array,
    motions: Array | None = None,
    motion: Callable[[], Array] | None = None,
) -> Array:
    """Compute derivatives of all mode shapes along parameter paths.

    Parameters
    ----------
    derivatives : MatrixDerivatives
        For N poses and T paths.
    eigenvalues : ndarray, shape (N, m)
    shapes : ndarray, shape (N, m, n)
        In the free coordinates, mass-normalised.
    motions : ndarray, shape (N, m, d), optional
        Motions in each mode that are linear in the coordinates, such as those of the platform.
    motion : callable, optional
        Returns these motions per unit of all coordinates, (N, d, e); called only if there are coordinates without
        inertia, or locked joints.

    Returns
    -------
    ndarray, shape (N, T, m, e + d)
        In all coordinates of the generated model, including those of locked joints, which deflect; then the motions,
        per unit of the coordinates as they are.
    """
    change, norm = derivatives.changes(eigenvalues, shapes)
    gap = eigenvalues[:, :, None] - eigenvalues[:, None, :]
    least = SMALLEST_GAP * np.maximum(np.abs(eigenvalues[:, :, None]), np.abs(eigenvalues[:, None, :]))
    least = np.maximum(least, ROUNDING * np.abs(eigenvalues).max(axis=1)[:, None, None])
    gap = np.where(gap >= 0.0, 1.0, -1.0) * np.maximum(np.abs(gap), np.maximum(least, 1e-300))
    share = change @ np.swapaxes(shapes, -1, -2)[:, None] / gap[:, None]  # (N, T, i, j)
    diagonal = np.arange(shapes.shape[1])
    share[..., diagonal, diagonal] = -0.5 * norm
    free, size = derivatives.free, derivatives.size
    channels = np.zeros((*shapes.shape[:2], size + (0 if motions is None else motions.shape[-1])))
    channels[..., free] = shapes
    if motions is not None:
        channels[..., size:] = motions
    rates: Array = share @ channels[:, None]
    r = np.flatnonzero(derivatives.massless)
    if not (len(r) or derivatives.locked):
        rates[..., :size] = derivatives.of_model(rates[..., :size])
        return rates
    beyond = np.zeros((*share.shape[:3], size))
    if len(r):
        K = derivatives.stiffness[:, free[r][:, None], free[r]]
        beyond[..., free[r]] -= np.swapaxes(
            np.linalg.solve(K[:, None], np.swapaxes(change[..., r], -1, -2)), -1, -2
        )
    for t in derivatives.locked:
        beyond[:, t] += derivatives.locked_motion(t, eigenvalues, shapes)
    rates[..., :size] = derivatives.of_model(rates[..., :size] + beyond)
    if motion is not None:
        rates[..., size:] += beyond @ np.swapaxes(motion(), -1, -2)[:, None]
    return rates
