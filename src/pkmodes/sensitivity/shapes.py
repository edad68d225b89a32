r"""Derivatives of mode shapes by modal expansion, for fits that need them many times.

With :math:`z_i = (dK - \lambda_i dM) \phi_i` and mass-normalised modes,

.. math:: d\phi_i = \sum_{j \ne i} \phi_j \frac{\phi_j^T z_i}{\lambda_i - \lambda_j}
    - \tfrac12 \phi_i \, \phi_i^T dM \, \phi_i

(Fox and Kapoor, AIAA Journal 6(12), 1968), which is exact with all modes.  Coordinates without inertia follow the
others statically, and a locked joint with a compliance deflects under its force.  `sensitivity.modes` computes the
same from one linear system for each mode: slower, but accurate to the last digit even for nearly coincident modes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.sensitivity.matrices import MatrixDerivatives

Array = NDArray[np.float64]
#: Lower bound of the difference between two eigenvalues in the denominator, relative to the larger of the two.
SMALLEST_GAP = 1e-6
#: The same relative to the largest eigenvalue: smaller differences, as between rigid-body modes, are rounding.
ROUNDING = float(np.finfo(float).eps)


def shape_derivatives(derivatives: MatrixDerivatives, eigenvalues: Array, shapes: Array) -> Array:
    """Compute derivatives of all mode shapes along parameter paths.

    Parameters
    ----------
    derivatives : MatrixDerivatives
        For N poses and T paths.
    eigenvalues : ndarray, shape (N, m)
    shapes : ndarray, shape (N, m, n)
        In the free coordinates, mass-normalised.

    Returns
    -------
    ndarray, shape (N, T, m, e)
        In all coordinates, including those of locked joints, which deflect.
    """
    dM, dK = derivatives.dense()
    modes = np.swapaxes(shapes, -1, -2)[:, None]
    inertia = dM @ modes
    change = np.swapaxes(dK @ modes - inertia * eigenvalues[:, None, None], -1, -2)
    norm = np.einsum("nia,ntai->nti", shapes, inertia)
    for t in derivatives.locked:
        change[:, t], norm[:, t] = derivatives.locked_change(t, eigenvalues, shapes)
    gap = eigenvalues[:, :, None] - eigenvalues[:, None, :]
    least = SMALLEST_GAP * np.maximum(np.abs(eigenvalues[:, :, None]), np.abs(eigenvalues[:, None, :]))
    least = np.maximum(least, ROUNDING * np.abs(eigenvalues).max(axis=1)[:, None, None])
    gap = np.where(gap >= 0.0, 1.0, -1.0) * np.maximum(np.abs(gap), np.maximum(least, 1e-300))
    share = change @ np.swapaxes(shapes, -1, -2)[:, None] / gap[:, None]  # (N, T, i, j)
    diagonal = np.arange(shapes.shape[1])
    share[..., diagonal, diagonal] = -0.5 * norm
    free = derivatives.free
    rates = np.zeros((*share.shape[:3], derivatives.size))
    rates[..., free] = share @ shapes[:, None]
    r = np.flatnonzero(derivatives.massless)
    if len(r):
        K = derivatives.stiffness[:, free[r][:, None], free[r]]
        rates[..., free[r]] -= np.swapaxes(
            np.linalg.solve(K[:, None], np.swapaxes(change[..., r], -1, -2)), -1, -2
        )
    for t in derivatives.locked:
        rates[:, t] += derivatives.locked_motion(t, eigenvalues, shapes)
    return rates
