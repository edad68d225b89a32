r"""Derivatives of mass-normalised mode shapes.

With :math:`f_i = (dK - \lambda_i dM) \phi_i`, the derivative of shape i has three parts: modes j that are known,
:math:`\phi_j \phi_j^T f_i / (\lambda_i - \lambda_j)`; all other motions x, which solve
:math:`(K - \lambda_i M) x = -f_i` free of the known modes; and the norm, :math:`-\phi_i \phi_i^T dM \phi_i / 2`.
Where all modes are known, the others are motions without inertia, :math:`x = -N (N^T K N)^{-1} N^T f_i`.  Otherwise
the system is solved bordered by those known modes that are near, which makes it regular: R. B. Nelson, Simplified
calculation of eigenvector derivatives, AIAA Journal 14 (1976), 1201-1205, for several of them at once.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy import linalg, sparse
from scipy.sparse import linalg as iterative

from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.structure.forms import is_sparse
from pkmodes.diagnosis.structure.modes import STABLE, Modes
from pkmodes.diagnosis.structure.supplied import Pair

#: Relative gap of two eigenvalues below which it counts as this large: what one of them does is not defined there.
GAP = 1e-6
#: Modes within this relative distance are handled by the sum.
NEAR = 1e-2


def shape_rates(pair: Pair, modes: Modes, count: int, forces: Array, inertial: Array) -> Array:
    """Differentiate the shapes.

    Parameters
    ----------
    pair : Pair
        M and K.
    modes : Modes
        At least `count` of them.
    count : int
        How many shapes are differentiated: the lowest.
    forces : ndarray, shape (T, m, n)
        (dK - lambda_i dM) phi_i for each parameter and at least `count` modes.
    inertial : ndarray, shape (T, m)
        phi_i^T dM phi_i.

    Returns
    -------
    ndarray, shape (count, n, T)
    """
    forces = forces[:, :count]
    coupling = np.einsum("tin,jn->tij", forces, modes.shapes, optimize=True)
    eigenvalues = modes.eigenvalues
    factors = coupling / _gaps(eigenvalues[:count], eigenvalues, modes.scale)
    if modes.complete:
        factors[:, np.arange(count), np.arange(count)] = 0.0
        found = factors @ modes.shapes
        if modes.massless is not None:
            N = modes.massless
            found -= (
                linalg.solve(N.T @ (pair.K @ N), N.T @ forces.reshape(-1, len(N)).T).T.reshape(
                    forces.shape[:2] + (-1,)
                )
                @ N.T
            )
    else:
        found = np.empty_like(forces)
        inertia = (pair.M @ modes.shapes.T).T
        for i in range(count):
            near = np.abs(eigenvalues - eigenvalues[i]) <= NEAR * np.abs(eigenvalues[i])
            near |= np.abs(eigenvalues - eigenvalues[i]) <= STABLE * modes.scale
            rest = _others(
                pair, eigenvalues[i], inertia[near], forces[:, i] - coupling[:, i, near] @ inertia[near]
            )
            near[i] = False
            found[:, i] = rest + factors[:, i, near] @ modes.shapes[near]
    found -= 0.5 * inertial[:, :count, None] * modes.shapes[:count]
    return np.moveaxis(found, 0, -1)


def _gaps(of: Array, to: Array, scale: float) -> Array:
    """lambda_i - lambda_j, kept from zero with its sign; that of equal ones is the sign of their order."""
    gaps = of[:, None] - to
    least = np.maximum(GAP * np.maximum(np.abs(of)[:, None], np.abs(to)), STABLE * GAP * (scale or 1.0))
    order = np.sign(np.arange(len(of))[:, None] - np.arange(len(to)))
    sign = np.where(gaps == 0.0, order, np.sign(gaps))
    return np.where(np.abs(gaps) < least, np.where(sign == 0.0, 1.0, sign) * least, gaps)


def _others(pair: Pair, eigenvalue: float, border: Array, right: Array) -> Array:
    """Solve (K - lambda M) x = -right for x that is M-orthogonal to some modes, whose M phi is the border."""
    A = pair.K - eigenvalue * pair.M
    n, size = A.shape[0], np.abs(A.diagonal())
    scale = 1.0 / np.sqrt(np.where(size > 0.0, size, size.max()))
    border = border * scale
    border = border / np.linalg.norm(border, axis=1)[:, None]
    b = np.zeros((n + len(border), len(right)))
    b[:n] = -(right * scale).T
    if is_sparse(A):
        scaling = sparse.diags_array(scale)
        edge: Any = sparse.csc_array(border)
        whole: Any = sparse.block_array([[scaling @ A @ scaling, edge.T], [edge, None]], format="csc")
        x = iterative.splu(whole).solve(b)
    else:
        whole = np.zeros((len(b), len(b)))
        whole[:n, :n], whole[:n, n:], whole[n:, :n] = A * (scale[:, None] * scale), border.T, border
        x = linalg.solve(whole, b, assume_a="sym")
    found: Array = (x[:n] * scale[:, None]).T
    return found
