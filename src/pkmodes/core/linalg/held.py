r"""The eigenproblem of a machine that soft springs hold to ground, with the digits of its slowest motions.

Without springs to ground, the stiffness :math:`K_s` of belts and reducers leaves some motions free: it has as many
eigenvalues that are zero.  A spring to ground, and gravity, add a part :math:`K_w` that may be many orders smaller.
In the sum it would be lost, first in the entries of the matrix and then in the solver, whose errors are rounding of
the largest eigenvalue.  So the parts are kept apart: with the modes :math:`\Phi` of :math:`K_s`, whose zeros are
known and not computed, the problem becomes

.. math:: H = \operatorname{diag}(0, \ldots, 0, \lambda_s) + \Phi^T K_w \Phi ,

which is graded, and `pkmodes.core.linalg.graded` solves it.
"""

from __future__ import annotations

import numpy as np

from pkmodes.core.linalg.eigen import Array, condensed_eigh, positive_components, without_inertia
from pkmodes.core.linalg.graded import graded_eigh


def held_eigh(M: Array, stiff: Array, soft: Array, first: int, motions: int) -> tuple[Array, Array]:
    """Solve (stiff + soft) phi = lambda M phi where `stiff` leaves some motions free.

    Parameters
    ----------
    M, stiff, soft : ndarray, shape (N, n, n)
        Symmetric; `stiff` has `motions` eigenvalues that are zero, the others positive.
    first : int
        Index of the first released joint.
    motions : int
        Number of free motions.

    Returns
    -------
    eigenvalues : ndarray, shape (N, m)
        Ascending; errors of the lowest ones are relative to the soft part.
    shapes : ndarray, shape (N, m, n)
        As returned by `condensed_eigh`.

    Raises
    ------
    numpy.linalg.LinAlgError
        If M is not positive definite, or the soft part is too small to be represented.
    """
    levels, modes = condensed_eigh(M, stiff, first, motions)
    H = modes @ soft @ np.swapaxes(modes, -1, -2)
    r = np.flatnonzero(without_inertia(M, first))
    yields = None
    if len(r):  # they followed the stiff part alone
        forces = (soft @ np.swapaxes(modes, -1, -2))[:, r]
        yields = -np.linalg.solve((stiff + soft)[:, r[:, None], r], forces)
        H += np.swapaxes(forces, -1, -2) @ yields
    levels[:, :motions] = 0.0
    H += levels[:, :, None] * np.eye(H.shape[-1])
    eigenvalues, shapes = np.empty_like(levels), np.empty_like(modes)
    for i, matrix in enumerate(H):
        across = matrix[:motions, motions:]
        elastic = levels[i, motions:]
        bent = np.linalg.norm(
            np.divide(across, elastic, out=np.zeros_like(across), where=elastic > 0.0) @ across.T
        )
        shift = 2.0 * float(np.linalg.norm(matrix[:motions, :motions]) + bent)
        eigenvalues[i], turned = graded_eigh(np.eye(len(matrix)), matrix, motions, shift)
        shapes[i] = turned @ modes[i]
        if yields is not None:
            shapes[i][:, r] += turned @ yields[i].T
    return eigenvalues, positive_components(shapes, M)
