"""Deletion of data from a linearised fit, and leave-one-out cross-validation over setups with it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array


def left_out(fit: Fit, setups: Sequence[NDArray[np.intp]]) -> tuple[Array, Array]:
    """Predict each setup from a fit to the others, to first order.

    Parameters
    ----------
    setups : sequence of ndarray of int
        Indices of the data of each setup.

    Returns
    -------
    squares : ndarray, shape (S,)
        Sum of squares of each setup.
    leverage : ndarray, shape (S,)
        Largest eigenvalue of H_ii: near 1 the setup alone determines some parameter, which no other predicts.
    """
    squares, leverage = [], []
    for rows in setups:
        basis = fit.basis[rows]
        inside = basis.T @ basis
        predicted = deleted(basis, fit.white[rows])
        squares.append(float(predicted @ predicted))
        leverage.append(float(np.linalg.eigvalsh(inside)[-1]) if inside.size and len(rows) else 0.0)
    return np.array(squares), np.array(leverage)


def deleted(basis: Array, white: Array) -> Array:
    """Return the residual of n data of a linear fit if they are deleted from it, (n,).

    With H the projection onto the derivatives, it is (1 - H_ii)^-1 r_i: no refit is needed (Cook and Weisberg,
    Residuals and Influence in Regression, 1982).

    Parameters
    ----------
    basis : ndarray, shape (n, k)
        Their rows of an orthonormal basis of the derivatives.
    white : ndarray, shape (n,)
        Their whitened residual r_i.
    """
    # (1 - B B^T)^-1 r = r + B (1 - B^T B)^-1 B^T r: as many equations as parameters, not as data.
    inside = basis.T @ basis
    if not inside.size:
        return white
    complement = np.eye(len(inside)) - inside
    return np.asarray(white + basis @ np.linalg.lstsq(complement, basis.T @ white, rcond=1e-9)[0])
