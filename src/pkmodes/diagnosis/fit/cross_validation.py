"""Leave-one-out cross-validation of a fit over setups."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array


def left_out(fit: Fit, setups: Sequence[NDArray[np.intp]]) -> tuple[Array, Array]:
    """Predict each setup from a fit to the others, to first order.

    With H the projection onto the derivatives, the residual of a left-out setup is (1 - H_ii)^-1 r_i: no refit is
    needed.

    Parameters
    ----------
    setups : sequence of ndarray of int
        Indices of the data of each setup.

    Returns
    -------
    squares : ndarray, shape (S,)
        Sum of squares of each setup.
    leverage : ndarray, shape (S,)
        Largest eigenvalue of H_ii: near 1 the setup alone determines some parameter, and no other one predicts it.
    """
    squares, leverage = [], []
    for rows in setups:
        # (1 - B B^T)^-1 r = r + B (1 - B^T B)^-1 B^T r: as many equations as parameters, not as data.
        basis = fit.basis[rows]
        inside = basis.T @ basis
        predicted = fit.white[rows]
        if inside.size:
            left = np.eye(len(inside)) - inside
            predicted = predicted + basis @ np.linalg.lstsq(left, basis.T @ predicted, rcond=1e-9)[0]
        squares.append(float(predicted @ predicted))
        leverage.append(float(np.linalg.eigvalsh(inside)[-1]) if inside.size and len(rows) else 0.0)
    return np.array(squares), np.array(leverage)
