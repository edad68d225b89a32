r"""Damping of modes, for a batch of poses: in modal coordinates, and ratios for light damping.

In modal coordinates, :math:`q = \Phi \eta` with :math:`\Phi^T M \Phi = 1`,

.. math:: \ddot\eta + D \dot\eta + \Lambda \eta = \Phi^T B u, \qquad
    D = \Phi^T C_v \Phi + \mathrm{diag}(2 \zeta \omega_i + \phi_i^T K'' \phi_i / \omega_i),

C_v is the viscous damping matrix.  K'', the imaginary part of the stiffness, is replaced by the viscous damping
equivalent to it at each mode's frequency.  zeta is a damping ratio added to every vibration mode.  The ratio of a
lightly damped mode is :math:`D_{ii} / (2 \omega_i)`.  Terms of K'' between two modes matter only if their frequencies
are equal, because such modes may be any basis of their subspace: only there has D these terms.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: Modes whose eigenvalues differ by less than this fraction form a group; within a group, the damping determines the
#: mode shapes.
REPEATED_MODE_TOLERANCE = 1e-9


class ModalDamping(NamedTuple):
    """Damping of N poses in modal coordinates.

    - eigenvalues: ascending, the rigid ones first, (N, m) [1/s^2]
    - matrix: D, (N, m, m) [1/s]
    - rigid_count: number of rigid modes
    """

    eigenvalues: Array
    matrix: Array
    rigid_count: int


def modal_damping(
    eigenvalues: Array,
    shapes: Array,
    viscous_matrix: Array,
    loss_stiffness: Array,
    uniform_ratio: float,
    rigid_count: int,
) -> ModalDamping:
    """Return damping in modal coordinates.

    - eigenvalues, shapes: mass-normalised modes, the rigid ones first, (N, m) and (N, m, n)
    - viscous_matrix, loss_stiffness: C_v and K'', in the coordinates of the shapes, (N, n, n)
    - uniform_ratio: damping ratio added to every vibration mode
    - rigid_count: number of rigid modes: they have viscous damping only
    """
    D = shapes @ viscous_matrix @ np.swapaxes(shapes, -1, -2)
    omega = np.sqrt(np.abs(eigenvalues[:, rigid_count:]))
    loss_terms = np.einsum(
        "Nia,Nab,Nib->Ni", shapes[:, rigid_count:], loss_stiffness, shapes[:, rigid_count:]
    )
    diagonal = uniform_ratio_diagonal(eigenvalues, uniform_ratio, rigid_count)[:, rigid_count:]
    with np.errstate(divide="ignore", invalid="ignore"):
        diagonal += np.where(loss_terms == 0.0, 0.0, loss_terms / omega)
    vibration_indices = np.arange(rigid_count, eigenvalues.shape[1])
    D[:, vibration_indices, vibration_indices] += diagonal
    if loss_stiffness.any():
        for pose, group in _repeated_groups(eigenvalues, rigid_count):
            phi = shapes[pose, group]
            group_omega = omega[pose, group.start - rigid_count : group.stop - rigid_count].mean()
            coupling = phi @ loss_stiffness[pose] @ phi.T / group_omega
            D[pose, group, group] += coupling - np.diag(np.diag(coupling))
    return ModalDamping(eigenvalues, D, rigid_count)


def uniform_ratio_diagonal(eigenvalues: Array, uniform_ratio: float, rigid_count: int) -> Array:
    """Return 2 zeta omega_i, the diagonal of D for a damping ratio zeta of every vibration mode, (..., m) [1/s]."""
    diagonal = 2.0 * uniform_ratio * np.sqrt(np.abs(eigenvalues))
    diagonal[..., :rigid_count] = 0.0
    return np.asarray(diagonal)


def damping_ratios(
    eigenvalues: Array,
    shapes: Array,
    viscous_matrix: Array,
    loss_stiffness: Array,
    uniform_ratio: float,
    rigid_count: int,
) -> Array:
    """Return the damping ratios, approximated for light damping, (N, m); NaN for rigid modes.

    In a group of equal frequencies, take the modes that C_v + K''/omega leaves uncoupled, in ascending order of
    ratio.  The arguments are those of `modal_damping`.
    """
    damping = modal_damping(eigenvalues, shapes, viscous_matrix, loss_stiffness, uniform_ratio, rigid_count)
    omega = np.sqrt(np.abs(eigenvalues))
    ratios = np.full(eigenvalues.shape, np.nan)
    diagonal = np.diagonal(damping.matrix, axis1=-2, axis2=-1)
    ratios[:, rigid_count:] = diagonal[:, rigid_count:] / (2.0 * omega[:, rigid_count:])
    for pose, group in _repeated_groups(eigenvalues, rigid_count):
        ratios[pose, group] = np.linalg.eigvalsh(damping.matrix[pose, group, group]) / (
            2.0 * omega[pose, group].mean()
        )
    return ratios


def _repeated_groups(eigenvalues: Array, rigid_count: int) -> Iterator[tuple[int, slice]]:
    """Yield the groups of vibration modes with equal eigenvalues, with their poses."""
    is_close_to_next = np.diff(eigenvalues, axis=1) <= REPEATED_MODE_TOLERANCE * np.abs(eigenvalues[:, 1:])
    is_close_to_next[:, :rigid_count] = False
    for pose in np.flatnonzero(is_close_to_next.any(axis=1)):
        # Where runs of such modes begin and end.
        edges = np.flatnonzero(
            np.diff(np.concatenate([[False], is_close_to_next[pose], [False]]).astype(int))
        )
        for first, last in edges.reshape(-1, 2):
            yield int(pose), slice(int(first), int(last) + 1)
