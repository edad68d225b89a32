r"""The generalised symmetric eigenproblem K phi = lambda M phi, for a batch of small matrices.

M is scaled to a unit diagonal, which removes the mixture of units (kg and kg m^2) before its Cholesky
factor is taken; the problem then becomes a standard one, :math:`L^{-1} K L^{-T} y = \lambda y`, for LAPACK's
symmetric solver.  Reference: Golub and Van Loan, Matrix Computations, section 8.7.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: Components that differ by less than this from the largest one count as equal to it: symmetric poses have
#: shapes with components of equal size, and rounding must not decide which of them sets the sign.
TIE = 1e-6


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


def condensed_eigh(M: Array, K: Array, first: int) -> tuple[Array, Array]:
    r"""Solve K phi = lambda M phi where some coordinates may have no inertia.

    A massless coordinate r follows the others without delay, :math:`K_{rr} x_r + K_{rq} x_q = 0`, which is
    exact; it adds no mode, and the shapes still list it.  The same coordinates must be massless in the whole
    batch.

    Parameters
    ----------
    M, K : ndarray, shape (N, n, n)
        Symmetric; M positive definite but for rows and columns of zeros, where K must be regular.
    first : int
        First coordinate that may have no inertia.

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
    massless = (M == 0.0).all(axis=(0, 1)) & (np.arange(M.shape[-1]) >= first)
    if not len(M) or not massless.any():
        return generalised_eigh(M, K)
    q, r = np.flatnonzero(~massless), np.flatnonzero(massless)
    follow = -np.linalg.solve(K[:, r[:, None], r], K[:, r[:, None], q])
    eigenvalues, kept = generalised_eigh(
        M[:, q[:, None], q], K[:, q[:, None], q] + K[:, q[:, None], r] @ follow
    )
    shapes = np.empty((len(M), len(q), M.shape[-1]))
    shapes[:, :, q] = kept
    shapes[:, :, r] = kept @ np.swapaxes(follow, -1, -2)
    return eigenvalues, shapes


def _sign(shapes: Array) -> Array:
    size = np.abs(shapes)
    largest = np.argmax(size >= (1.0 - TIE) * size.max(axis=-1, keepdims=True), axis=-1)
    return np.sign(np.take_along_axis(shapes, largest[..., None], axis=-1))[..., 0]


def natural_frequencies(eigenvalues: Array) -> Array:
    """sqrt(|lambda|) / (2 pi) with the sign of lambda [Hz]: gravity may make a rigid mode unstable."""
    frequencies: Array = np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2.0 * np.pi)
    return frequencies
