"""How well a fit predicts setups that take no part in it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array


def left_out(fit: Fit, setups: Sequence[NDArray[np.intp]]) -> tuple[Array, Array]:
    """Predict each setup by a fit to the others, to first order.

    With H the projection on the derivatives, the residual of a setup that takes no part is
    (1 - H_ii)^-1 r_i: nothing has to be fitted again.

    Parameters
    ----------
    fit : Fit
    setups : sequence of ndarray of int
        Places of the data of each setup.

    Returns
    -------
    squares : ndarray, shape (S,)
        Sum of squares of each setup.
    leverage : ndarray, shape (S,)
        Largest eigenvalue of H_ii: near 1 the setup alone determines something, and nothing predicts it.
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
