"""How well a fit predicts setups that take no part in it."""

from __future__ import annotations

import numpy as np

from pkmodes.diagnosis.fitting import Fit
from pkmodes.diagnosis.noise import Noise
from pkmodes.diagnosis.problem import Array


def left_out(fit: Fit, noise: Noise) -> tuple[Array, Array]:
    """Predict each setup by a fit to the others, to first order.

    With H the projection on the derivatives, the residual of a setup that takes no part is
    (1 - H_ii)^-1 r_i: nothing has to be fitted again.

    Parameters
    ----------
    fit : Fit
    noise : Noise
        Of the measurements that were fitted.

    Returns
    -------
    squares : ndarray, shape (S,)
        Sum of squares of each setup.
    leverage : ndarray, shape (S,)
        Largest eigenvalue of H_ii: near 1 the setup alone determines something, and nothing predicts it.
    """
    size = np.linalg.norm(fit.jacobian, axis=0)
    u, s, _ = np.linalg.svd(fit.jacobian / np.where(size > 0.0, size, 1.0), full_matrices=False)
    basis, squares, leverage = u[:, s > 1e-9], [], []
    for rows in noise.rows:
        block = basis[rows] @ basis[rows].T
        predicted = np.linalg.lstsq(np.eye(len(rows)) - block, fit.white[rows], rcond=1e-9)[0]
        squares.append(float(predicted @ predicted))
        leverage.append(float(np.linalg.eigvalsh(block)[-1]) if len(rows) else 0.0)
    return np.array(squares), np.array(leverage)
