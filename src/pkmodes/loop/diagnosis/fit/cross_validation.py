"""Deletion of data from a linearised fit, and leave-one-out cross-validation over setups with it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Array


def predict_left_out(fit: Fit, setups: Sequence[NDArray[np.intp]]) -> tuple[Array, Array]:
    """Predict each setup from a fit to the others, to first order.

    - setups: indices of the data of each setup

    Returns, in this order:
    - squares: sum of squares of each setup, (S,)
    - leverage: largest eigenvalue of H_ii, (S,): near 1 the setup alone determines some parameter, which no other
      predicts
    """
    squares, leverage = [], []
    for rows in setups:
        basis = fit.basis[rows]
        gram = basis.T @ basis
        residual = deleted_residual(basis, fit.white[rows])
        squares.append(float(residual @ residual))
        leverage.append(float(np.linalg.eigvalsh(gram)[-1]) if gram.size and len(rows) else 0.0)
    return np.array(squares), np.array(leverage)


def deleted_residual(basis: Array, white: Array) -> Array:
    """Return the residual of n data of a linear fit from which they are deleted, (n,).

    With H the projection onto the derivatives, it is (1 - H_ii)^-1 r_i: no refit is needed (Cook and Weisberg,
    Residuals and Influence in Regression, 1982).

    - basis: rows of these data in an orthonormal basis of the derivatives, (n, k)
    - white: whitened residual r_i of these data, (n,)
    """
    # (1 - B B^T)^-1 r = r + B (1 - B^T B)^-1 B^T r: as many equations as parameters, not as data.
    gram = basis.T @ basis
    if not gram.size:
        return white
    complement = np.eye(len(gram)) - gram
    return np.asarray(white + basis @ np.linalg.lstsq(complement, basis.T @ white, rcond=1e-9)[0])
