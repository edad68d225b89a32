r"""The generalised symmetric eigenproblem K phi = lambda M phi, for a batch of small matrices.

M is scaled to a unit diagonal, which removes the mixture of units (kg and kg m^2) before the Cholesky factorisation;
the problem then becomes the standard one :math:`L^{-1} K L^{-T} y = \lambda y` for LAPACK's symmetric solver.
Reference: Golub and Van Loan, Matrix Computations, section 8.7.

The solver's error is rounding of the largest eigenvalue.  If a released joint is so stiff that this would affect the
vibration modes, `pkmodes.core.linalg.graded` solves the system again.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: Components that differ from the largest by less than this fraction count as equal to it: symmetric poses have
#: shapes with components of equal size, and rounding must not decide which of them sets the sign.
TIE_TOLERANCE = 1e-6

#: Maximum ratio of the largest eigenvalue to the lowest vibration eigenvalue at which the latter has eleven correct
#: digits: the symmetric solver's error is 1e-15 of the largest.
MAX_EIGENVALUE_RATIO = 1e4
#: Minimum ratio of the lowest to the largest eigenvalue: below it, motions that springs hold to ground have barely
#: nine digits: random robots with frames and links have errors of up to 2e-15 of the largest.  Their springs are
#: solved separately (`pkmodes.core.solve.held_motions`).
MIN_EIGENVALUE_RATIO = 3e-6
#: The ratio is attributed to a stiff joint if the largest eigenvalue exceeds this multiple of the base coordinates'.
STIFF_JOINT_RATIO = 10.0


def generalised_eigh(M: Array, K: Array) -> tuple[Array, Array]:
    """Solve K phi = lambda M phi.

    - M, K: symmetric, (N, n, n); M positive definite

    Returns, in this order:
    - eigenvalues: ascending, (N, n) [1/s^2]
    - shapes: ``shapes[:, i]`` is mode i, with phi^T M phi = 1, (N, n, n); in coordinates scaled to a unit diagonal of
      M, the first of its largest components is positive

    Raises numpy.linalg.LinAlgError if some M is not positive definite.
    """
    diagonal = np.diagonal(M, axis1=-2, axis2=-1)
    if not (diagonal > 0.0).all():
        raise np.linalg.LinAlgError("the diagonal of M is not positive")
    scale = 1.0 / np.sqrt(diagonal)
    scaling = scale[..., :, None] * scale[..., None, :]
    inverse = np.linalg.inv(np.linalg.cholesky(M * scaling))
    transposed = np.swapaxes(inverse, -1, -2)
    standard = inverse @ (K * scaling) @ transposed
    eigenvalues, y = np.linalg.eigh(0.5 * (standard + np.swapaxes(standard, -1, -2)))
    scaled = np.swapaxes(transposed @ y, -1, -2)
    scaled *= _signs(scaled)[..., None]
    return eigenvalues, scaled * scale[..., None, :]


def condensed_eigh(
    M: Array, K: Array, first_joint: int, rigid_count: int = 0, massless: NDArray[np.bool_] | None = None
) -> tuple[Array, Array]:
    r"""Solve K phi = lambda M phi where released joints may have no inertia or hardly any compliance.

    A massless coordinate r follows the others statically, :math:`K_{rr} x_r + K_{rq} x_q = 0`; this condensation is
    exact.  The coordinate adds no mode but is included in the shapes.  The same coordinates must be massless in the
    whole batch.  The stiffness of stiff joints on the diagonal of K may be arbitrarily large: where it costs the
    vibration modes digits, the system is solved in its graded form (`pkmodes.core.linalg.graded`).

    - M, K: symmetric, (N, n, n); M positive definite except for rows and columns of zeros, where K must be regular
    - first_joint: index of the first released joint; released joints may be massless or stiff
    - rigid_count: number of rigid-body modes, whose eigenvalues are zero except for gravity
    - massless: which coordinates have no inertia, (n,); by default those whose rows of M are zero.  Needed for an
      empty batch.

    Returns, in this order:
    - eigenvalues: ascending, (N, m) [1/s^2]; m is the number of coordinates with inertia
    - shapes: as returned by `generalised_eigh`, in all coordinates, (N, m, n)

    Raises numpy.linalg.LinAlgError if M is not positive definite on the coordinates with inertia, or K is singular on
    the massless ones.
    """
    if massless is None:
        massless = without_inertia(M, first_joint)
    if not massless.any():
        return _eigh_with_stiff_joints(M, K, first_joint, rigid_count)
    q, r = np.flatnonzero(~massless), np.flatnonzero(massless)
    condensation = -np.linalg.solve(K[:, r[:, None], r], K[:, r[:, None], q])
    eigenvalues, q_shapes = _eigh_with_stiff_joints(
        M[:, q[:, None], q],
        K[:, q[:, None], q] + K[:, q[:, None], r] @ condensation,
        first_joint,
        rigid_count,
    )
    shapes = np.empty((len(M), len(q), M.shape[-1]))
    shapes[:, :, q] = q_shapes
    shapes[:, :, r] = q_shapes @ np.swapaxes(condensation, -1, -2)
    return eigenvalues, shapes


def without_inertia(M: Array, first_joint: int) -> NDArray[np.bool_]:
    """Return which coordinates of released joints have rows of zeros in M, (n,); none for an empty batch."""
    zero_rows = (M == 0.0).all(axis=(0, 1)) if len(M) else np.zeros(M.shape[-1], dtype=bool)
    return np.asarray(zero_rows & (np.arange(M.shape[-1]) >= first_joint))


def _eigh_with_stiff_joints(M: Array, K: Array, first_joint: int, rigid_count: int) -> tuple[Array, Array]:
    """Solve the eigenproblem; solve again, one by one, the systems whose modes lost digits to a stiff joint."""
    eigenvalues, shapes = generalised_eigh(M, K)
    stiff_indices = np.flatnonzero(has_stiff_joint(eigenvalues, first_joint, rigid_count))
    if len(stiff_indices):
        from pkmodes.core.linalg.graded import graded_eigh  # SciPy's linear algebra takes a while to import
    for i in stiff_indices:
        scale = 1.0 / np.sqrt(np.diagonal(M[i]))
        scaling = scale[:, None] * scale
        eigenvalues[i], scaled = graded_eigh(M[i] * scaling, K[i] * scaling, first_joint)
        shapes[i] = scaled * _signs(scaled)[:, None] * scale
    return eigenvalues, shapes


def has_stiff_joint(eigenvalues: Array, first_joint: int, rigid_count: int) -> NDArray[np.bool_]:
    """Return for which systems a stiff joint has an eigenvalue too large for the symmetric solver.

    It is then the largest eigenvalue.

    - eigenvalues: ascending, accurate to rounding of the largest or better, (N, m) or (m,)
    - first_joint: index of the first released joint
    - rigid_count: number of rigid-body modes

    Returns (N,) or ().
    """
    if eigenvalues.shape[-1] <= first_joint:
        return np.zeros(eigenvalues.shape[:-1], dtype=bool)
    by_mode = eigenvalues.T  # scalars if there is no batch
    largest_eigenvalue = by_mode[-1]
    is_stiff: NDArray[np.bool_] = (largest_eigenvalue > MAX_EIGENVALUE_RATIO * abs(by_mode[rigid_count])) & (
        largest_eigenvalue > STIFF_JOINT_RATIO * abs(by_mode[first_joint - 1])
    )
    return is_stiff


def has_soft_ground_springs(eigenvalues: Array, loose_motions: int) -> NDArray[np.bool_]:
    """Return for which systems springs to ground are too soft for the symmetric solver, (N,) or ().

    - eigenvalues: ascending, accurate to rounding of the largest or better, (N, m) or (m,)
    - loose_motions: number of motions that nothing else holds, whether or not the springs hold all of them; 0 for a
      system that is not held
    """
    if not loose_motions:
        return np.zeros(eigenvalues.shape[:-1], dtype=bool)
    magnitudes = np.abs(eigenvalues)
    is_soft: NDArray[np.bool_] = (
        magnitudes[..., :loose_motions].min(axis=-1) < MIN_EIGENVALUE_RATIO * magnitudes[..., -1]
    )
    return is_soft


def rounding_scale(eigenvalues: Array, first_joint: int, rigid_count: int, loose_motions: int = 0) -> Array:
    """Return the magnitude to which the rounding of each eigenvalue of a robot is relative.

    This is the largest eigenvalue; where a joint is stiff, the larger of the eigenvalue itself and those of the
    coordinates that are not stiff; where springs to ground are soft, for the motions that they hold the largest
    of these.

    - eigenvalues: (N, m)
    - first_joint, rigid_count: as for `condensed_eigh`
    - loose_motions: as for `has_soft_ground_springs`

    Returns (N, m): not negative.
    """
    magnitudes = np.abs(eigenvalues)
    scales = np.repeat(magnitudes.max(axis=-1, keepdims=True), magnitudes.shape[-1], axis=-1)
    is_stiff = has_stiff_joint(eigenvalues, first_joint, rigid_count)
    scales[is_stiff] = np.maximum(magnitudes[is_stiff], magnitudes[is_stiff, first_joint - 1 : first_joint])
    is_soft = has_soft_ground_springs(eigenvalues, loose_motions)
    scales[is_soft, :loose_motions] = magnitudes[is_soft, :loose_motions].max(
        axis=-1, keepdims=True, initial=0.0
    )
    return scales


def base_eigenvalue_scale(M: Array, K: Array, first_joint: int) -> Array:
    """Return the largest K_ii / M_ii of the base coordinates, (N,): the order of their largest eigenvalue."""
    max_ratio: Array = np.max(
        np.diagonal(K, axis1=-2, axis2=-1)[:, :first_joint]
        / np.diagonal(M, axis1=-2, axis2=-1)[:, :first_joint],
        axis=1,
    )
    return max_ratio


def with_sign_convention(shapes: Array, M: Array) -> Array:
    """Return shapes, (N, m, n), with the signs of `generalised_eigh`."""
    scale = np.sqrt(np.diagonal(M, axis1=-2, axis2=-1))[:, None, :]
    return np.asarray(shapes * _signs(shapes * scale)[..., None])


def _signs(shapes: Array) -> Array:
    magnitudes = np.abs(shapes)
    index = np.argmax(magnitudes >= (1.0 - TIE_TOLERANCE) * magnitudes.max(axis=-1, keepdims=True), axis=-1)
    return np.sign(np.take_along_axis(shapes, index[..., None], axis=-1))[..., 0]


def natural_frequencies(eigenvalues: Array) -> Array:
    """Return sqrt(|lambda|) / (2 pi) with the sign of lambda [Hz]: gravity may make a rigid-body mode unstable."""
    frequencies: Array = np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2.0 * np.pi)
    return frequencies
