r"""The generalised symmetric eigenproblem K phi = lambda M phi, for a batch of small matrices.

M is scaled to a unit diagonal, which removes the mixture of units (kg and kg m^2) before its Cholesky
factor is taken; the problem then becomes a standard one, :math:`L^{-1} K L^{-T} y = \lambda y`, for LAPACK's
symmetric solver.  Reference: Golub and Van Loan, Matrix Computations, section 8.7.

That solver errs by rounding of the largest eigenvalue.  Where a released joint is so stiff that this would show
in the modes of vibration, `pkmodes.graded` solves the system again.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: Components that differ by less than this from the largest one count as equal to it: symmetric poses have
#: shapes with components of equal size, and rounding must not decide which of them sets the sign.
TIE = 1e-6

#: A largest eigenvalue beyond so many times the lowest one of vibration leaves it ten digits: 1e-15 of the largest
#: is what the symmetric solver errs by.
GRADED = 1e5
#: A stiff joint is what makes it so if the largest eigenvalue is so many times those of the other coordinates.
STIFFER = 10.0


def generalised_eigh(M: Array, K: Array) -> tuple[Array, Array]:
    """Solve K phi = lambda M phi.

    Parameters
    ----------
    M, K : ndarray, shape (N, n, n)
        Symmetric; M positive definite.

    Returns
    -------
    eigenvalues : ndarray, shape (N, n)
        Ascending [1/s^2].
    shapes : ndarray, shape (N, n, n)
        ``shapes[:, i]`` is mode i, with phi^T M phi = 1; in units of M scaled by its diagonal, the first of
        its largest components is positive.

    Raises
    ------
    numpy.linalg.LinAlgError
        If some M is not positive definite.
    """
    diagonal = np.diagonal(M, axis1=-2, axis2=-1)
    if not (diagonal > 0.0).all():
        raise np.linalg.LinAlgError("the diagonal of M is not positive")
    scale = 1.0 / np.sqrt(diagonal)
    both = scale[..., :, None] * scale[..., None, :]
    inverse = np.linalg.inv(np.linalg.cholesky(M * both))
    transposed = np.swapaxes(inverse, -1, -2)
    standard = inverse @ (K * both) @ transposed
    eigenvalues, y = np.linalg.eigh(0.5 * (standard + np.swapaxes(standard, -1, -2)))
    scaled = np.swapaxes(transposed @ y, -1, -2)
    scaled *= _sign(scaled)[..., None]
    return eigenvalues, scaled * scale[..., None, :]


def condensed_eigh(
    M: Array, K: Array, first: int, rigid: int = 0, massless: NDArray[np.bool_] | None = None
) -> tuple[Array, Array]:
    r"""Solve K phi = lambda M phi where released joints may have no inertia, or hardly any compliance.

    A massless coordinate r follows the others without delay, :math:`K_{rr} x_r + K_{rq} x_q = 0`, which is
    exact; it adds no mode, and the shapes still list it.  The same coordinates must be massless in the whole
    batch.  Stiff joints may have any size of stiffness on the diagonal of K: where it takes digits from the
    modes of vibration, the system is solved in its graded form (`pkmodes.graded`).

    Parameters
    ----------
    M, K : ndarray, shape (N, n, n)
        Symmetric; M positive definite but for rows and columns of zeros, where K must be regular.
    first : int
        The first of the released joints, which may be massless or stiff.
    rigid : int
        So many modes are rigid-body motions, whose eigenvalues are zero but for gravity.
    massless : ndarray of bool, shape (n,), optional
        Which coordinates have no inertia; by default those of which M has none.  An empty batch cannot tell.

    Returns
    -------
    eigenvalues : ndarray, shape (N, m)
        Ascending [1/s^2]; m is the number of coordinates with inertia.
    shapes : ndarray, shape (N, m, n)
        As `generalised_eigh` gives them, in all coordinates.

    Raises
    ------
    numpy.linalg.LinAlgError
        If M is not positive definite, or K singular, where they must not be.
    """
    if massless is None:
        none = (M == 0.0).all(axis=(0, 1)) if len(M) else np.zeros(M.shape[-1], dtype=bool)
        massless = none & (np.arange(M.shape[-1]) >= first)
    if not massless.any():
        return _all_sizes(M, K, first, rigid)
    q, r = np.flatnonzero(~massless), np.flatnonzero(massless)
    follow = -np.linalg.solve(K[:, r[:, None], r], K[:, r[:, None], q])
    eigenvalues, kept = _all_sizes(
        M[:, q[:, None], q], K[:, q[:, None], q] + K[:, q[:, None], r] @ follow, first, rigid
    )
    shapes = np.empty((len(M), len(q), M.shape[-1]))
    shapes[:, :, q] = kept
    shapes[:, :, r] = kept @ np.swapaxes(follow, -1, -2)
    return eigenvalues, shapes


def _all_sizes(M: Array, K: Array, first: int, rigid: int) -> tuple[Array, Array]:
    """Solve the eigenproblem, again and one by one where a stiff joint has taken digits from the others."""
    eigenvalues, shapes = generalised_eigh(M, K)
    stiff = np.flatnonzero(has_stiff_joint(eigenvalues, first, rigid))
    if len(stiff):
        from pkmodes.graded import graded_eigh  # SciPy's linear algebra takes a while to import
    for i in stiff:
        scale = 1.0 / np.sqrt(np.diagonal(M[i]))
        both = scale[:, None] * scale
        eigenvalues[i], scaled = graded_eigh(M[i] * both, K[i] * both, first)
        shapes[i] = scaled * _sign(scaled)[:, None] * scale
    return eigenvalues, shapes


def has_stiff_joint(eigenvalues: Array, first: int, rigid: int) -> NDArray[np.bool_]:
    """Where the largest eigenvalues are those of a stiff joint, and too large for the symmetric solver.

    Parameters
    ----------
    eigenvalues : ndarray, shape (N, m)
        Ascending, right to rounding of the largest or better.
    first : int
        The first of the released joints.
    rigid : int
        So many modes are rigid-body motions.

    Returns
    -------
    ndarray of bool, shape (N,)
    """
    if eigenvalues.shape[-1] <= first:
        return np.zeros(len(eigenvalues), dtype=bool)
    largest = eigenvalues[:, -1]
    found: NDArray[np.bool_] = (largest > GRADED * np.abs(eigenvalues[:, rigid])) & (
        largest > STIFFER * np.abs(eigenvalues[:, first - 1])
    )
    return found


def magnitude(eigenvalues: Array, first: int, rigid: int) -> Array:
    """The eigenvalue that each one's rounding is relative to, of those that `condensed_eigh` gives.

    The largest of all; where a joint is stiff, the larger of itself and those of the coordinates that are not.

    Parameters
    ----------
    eigenvalues : ndarray, shape (N, m)
    first, rigid : int
        As for `condensed_eigh`.

    Returns
    -------
    ndarray, shape (N, m)
        Not negative.
    """
    size = np.abs(eigenvalues)
    found = np.repeat(size.max(axis=-1, keepdims=True), size.shape[-1], axis=-1)
    stiff = has_stiff_joint(eigenvalues, first, rigid)
    found[stiff] = np.maximum(size[stiff], size[stiff, first - 1 : first])
    return found


def _sign(shapes: Array) -> Array:
    size = np.abs(shapes)
    largest = np.argmax(size >= (1.0 - TIE) * size.max(axis=-1, keepdims=True), axis=-1)
    return np.sign(np.take_along_axis(shapes, largest[..., None], axis=-1))[..., 0]


def natural_frequencies(eigenvalues: Array) -> Array:
    """sqrt(|lambda|) / (2 pi) with the sign of lambda [Hz]: gravity may make a rigid mode unstable."""
    frequencies: Array = np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2.0 * np.pi)
    return frequencies
