r"""Damping of modes, for a batch of poses: in modal coordinates, and ratios for light damping.

In modal coordinates, :math:`q = \Phi \eta` with :math:`\Phi^T M \Phi = 1`,

.. math:: \ddot\eta + D \dot\eta + \Lambda \eta = \Phi^T B u, \qquad
    D = \Phi^T C_v \Phi + \mathrm{diag}(2 \zeta \omega_i + \phi_i^T K'' \phi_i / \omega_i),

with viscous damping C_v, the imaginary part K'' of the stiffness as the viscous damping that it is at the frequency
of each mode, and a ratio zeta of every vibration mode.  The ratio of a lightly damped mode is
:math:`D_{ii} / (2 \omega_i)`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: Modes whose eigenvalues differ by less than this fraction form a group; the damping decides which basis of it is
#: used.
EQUAL_TOLERANCE = 1e-9


class ModalDamping(NamedTuple):
    """Damping of N poses in modal coordinates.

    - eigenvalues: ascending, the rigid ones first, (N, m) [1/s^2]
    - matrix: D, (N, m, m) [1/s]
    - rigid: number of rigid modes
    """

    eigenvalues: Array
    matrix: Array
    rigid: int


def modal_damping(
    eigenvalues: Array, shapes: Array, viscous: Array, loss: Array, ratio: float, rigid: int
) -> ModalDamping:
    """Return damping in modal coordinates.

    - eigenvalues, shapes: mass-normalised modes, the rigid ones first, (N, m) and (N, m, n)
    - viscous, loss: C_v and K'', in the coordinates of the shapes, (N, n, n)
    - ratio: of every vibration mode, in addition
    - rigid: number of rigid modes: they have viscous damping only
    """
    D = shapes @ viscous @ np.swapaxes(shapes, -1, -2)
    omega = np.sqrt(np.abs(eigenvalues[:, rigid:]))
    loss_terms = np.einsum("Nia,Nab,Nib->Ni", shapes[:, rigid:], loss, shapes[:, rigid:])
    diagonal = modal_rates_of_ratio(eigenvalues, ratio, rigid)[:, rigid:]
    with np.errstate(divide="ignore", invalid="ignore"):
        diagonal += np.where(loss_terms == 0.0, 0.0, loss_terms / omega)
    vibrations = np.arange(rigid, eigenvalues.shape[1])
    D[:, vibrations, vibrations] += diagonal
    if loss.any():
        for pose, group in _repeated_groups(eigenvalues, rigid):
            phi = shapes[pose, group]
            coupling = phi @ loss[pose] @ phi.T / omega[pose, group.start - rigid : group.stop - rigid].mean()
            D[pose, group, group] += coupling - np.diag(np.diag(coupling))
    return ModalDamping(eigenvalues, D, rigid)


def modal_rates_of_ratio(eigenvalues: Array, ratio: float, rigid: int) -> Array:
    """Return the diagonal damping 2 zeta omega_i of a ratio of every vibration mode [1/s], (..., m)."""
    rates = 2.0 * ratio * np.sqrt(np.abs(eigenvalues))
    rates[..., :rigid] = 0.0
    return np.asarray(rates)


def damping_ratios(
    eigenvalues: Array, shapes: Array, viscous: Array, loss: Array, ratio: float, rigid: int
) -> Array:
    """Return the damping ratios of light damping, (N, m); NaN for rigid modes.

    In a group of equal frequencies, the modes are those that C_v + K''/omega does not couple, by ascending ratio.
    The arguments are those of `modal_damping`.
    """
    damping = modal_damping(eigenvalues, shapes, viscous, loss, ratio, rigid)
    omega = np.sqrt(np.abs(eigenvalues))
    ratios = np.full(eigenvalues.shape, np.nan)
    diagonal = np.diagonal(damping.matrix, axis1=-2, axis2=-1)
    ratios[:, rigid:] = diagonal[:, rigid:] / (2.0 * omega[:, rigid:])
    for pose, group in _repeated_groups(eigenvalues, rigid):
        ratios[pose, group] = np.linalg.eigvalsh(damping.matrix[pose, group, group]) / (
            2.0 * omega[pose, group].mean()
        )
    return ratios


def _repeated_groups(eigenvalues: Array, rigid: int) -> Iterator[tuple[int, slice]]:
    """Yield the groups of vibration modes with equal eigenvalues, with their poses."""
    close = np.diff(eigenvalues, axis=1) <= EQUAL_TOLERANCE * np.abs(eigenvalues[:, 1:])
    close[:, :rigid] = False
    for pose in np.flatnonzero(close.any(axis=1)):
        # Runs of modes that are close to the next one.
        edges = np.flatnonzero(np.diff(np.concatenate([[False], close[pose], [False]]).astype(int)))
        for first, last in edges.reshape(-1, 2):
            yield int(pose), slice(int(first), int(last) + 1)
