r"""Derivatives of mode shapes by their expansion in all modes, for fits that need them at many values.

With :math:`z_i = (dK - \lambda_i dM) \phi_i` and mass-normalised modes,

.. math:: d\phi_i = \sum_{j \ne i} \phi_j \frac{\phi_j^T z_i}{\lambda_i - \lambda_j}
    - \tfrac12 \phi_i \, \phi_i^T dM \, \phi_i

(Fox and Kapoor, AIAA Journal 6(12), 1968), which is exact with all modes.  Coordinates without inertia follow the
others, and a locked joint with a compliance yields by what it carries.  `sensitivity.modes` has the same from one
linear system for each mode, for a few poses and to the last digit where modes nearly coincide.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.sensitivity.matrices import MatrixDerivatives

Array = NDArray[np.float64]
#: Smallest difference of two eigenvalues, relative to the larger one, that is divided by.
SMALLEST_GAP = 1e-6
#: The same relative to the largest of all, below which it is rounding: between rigid modes that nothing holds.
ROUNDING = float(np.finfo(float).eps)


def shape_derivatives(derivatives: MatrixDerivatives, eigenvalues: Array, shapes: Array, first: int) -> Array:
    """Derivatives of all modes with respect to the paths of some matrices.

    Parameters
    ----------
    derivatives : MatrixDerivatives
        At N poses, along T paths.
    eigenvalues : ndarray, shape (N, m)
    shapes : ndarray, shape (N, m, n)
        In the free coordinates, mass-normalised.
    first : int
        First coordinate that may have no inertia.

    Returns
    -------
    ndarray, shape (N, T, m, e)
        In all coordinates, locked ones included: these yield.
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
    found = np.zeros((*share.shape[:3], derivatives.M.shape[-1]))
    found[..., free] = share @ shapes[:, None]
    M = derivatives.M[:, free[:, None], free]
    massless = (M == 0.0).all(axis=(0, 1)) & (np.arange(len(free)) >= first)
    if massless.any():
        r = np.flatnonzero(massless)
        K = derivatives.K[:, free[r][:, None], free[r]]
        found[..., free[r]] -= np.swapaxes(
            np.linalg.solve(K[:, None], np.swapaxes(change[..., r], -1, -2)), -1, -2
        )
    for t in derivatives.locked:
        found[:, t] += derivatives.locked_motion(t, eigenvalues, shapes)
    return found
