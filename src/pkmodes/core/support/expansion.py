r"""Derivatives of mode shapes as combinations of all mode shapes.

With :math:`z_i = (dK - \lambda_i dM) \phi_i` and mass-normalised modes,

.. math:: d\phi_i = \sum_{j \ne i} \phi_j \frac{\phi_j^T z_i}{\lambda_i - \lambda_j}
    - \tfrac12 \phi_i \, \phi_i^T dM \, \phi_i

(Fox and Kapoor, AIAA Journal 6(12), 1968), which is exact with all modes, except for motions without inertia.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: Lower bound of the difference between two eigenvalues in the denominator, relative to the larger of the two.
MIN_RELATIVE_GAP = 1e-6
#: The same relative to the largest eigenvalue: smaller differences, as between rigid-body modes, are rounding.
ROUNDING = float(np.finfo(float).eps)


def modal_expansion(change: Array, norm: Array, eigenvalues: Array, shapes: Array) -> Array:
    """Return the coefficients of all shapes j in the derivative of each shape i.

    - change: z_i at N poses along T parameters, (N, T, m, n)
    - norm: phi_i^T dM phi_i, (N, T, m)
    - eigenvalues: (N, m)
    - shapes: mass-normalised, (N, m, n)

    Returns (N, T, m, m), with axes i and j.
    """
    gap = eigenvalues[:, :, None] - eigenvalues[:, None, :]
    min_gap = MIN_RELATIVE_GAP * np.maximum(np.abs(eigenvalues[:, :, None]), np.abs(eigenvalues[:, None, :]))
    min_gap = np.maximum(min_gap, ROUNDING * np.abs(eigenvalues).max(axis=1)[:, None, None])
    gap = np.where(gap >= 0.0, 1.0, -1.0) * np.maximum(np.abs(gap), np.maximum(min_gap, 1e-300))
    coefficients: Array = change @ np.swapaxes(shapes, -1, -2)[:, None] / gap[:, None]
    diagonal = np.arange(shapes.shape[1])
    coefficients[..., diagonal, diagonal] = -0.5 * norm
    return coefficients
