r"""The eigenproblem of a system whose eigenvalues differ by many orders of magnitude, each to its own precision.

A joint of compliance c has the stiffness 1/c, and as c goes to zero its modes go to infinity.  A symmetric solver
errs by rounding of the largest eigenvalue, which then is more than the others are.  But the large numbers stand on
the diagonal of K only, so the matrix :math:`H = L^{-1} K L^{-T} + \sigma I`, with the coordinates in the order of
their stiffness, is graded: :math:`H = D B D` with a diagonal D that spans all orders and a well conditioned B.  Its
Cholesky factor is computed with small relative errors in every row, and one-sided Jacobi rotations (LAPACK's
``gejsv``) find the singular values of such a factor to an error relative to each of them, not to the largest.  The
shift makes H positive definite where rigid-body motions and gravity leave K indefinite; it is no larger than the
eigenvalues of the coordinates that are not stiff.

References: Demmel and Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13(4), 1992;
Drmac and Veselic, New fast and accurate Jacobi SVD algorithm, ibid. 29(4), 2008.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular
from scipy.linalg.lapack import dgejsv

Array = NDArray[np.float64]

#: A coordinate this much stiffer than a mode yields to its forces as a spring does, but for a small correction.
STIFF = 1e4


def graded_eigh(M: Array, K: Array, soft: int) -> tuple[Array, Array]:
    """Solve K phi = lambda M phi for one system with some very stiff coordinates.

    Parameters
    ----------
    M, K : ndarray, shape (n, n)
        Symmetric; M positive definite, and of a unit diagonal.  K as large as may be on the diagonal.
    soft : int
        At least so many coordinates are not stiff.

    Returns
    -------
    eigenvalues : ndarray, shape (n,)
        Ascending; their errors are relative to the larger of the eigenvalue and those of the soft coordinates.
    shapes : ndarray, shape (n, n)
        ``shapes[i]`` is mode i, with phi^T M phi = 1; what stiff coordinates yield in a soft mode is small, and
        right to its own size.

    Raises
    ------
    numpy.linalg.LinAlgError
        If M is not positive definite, or K is not finite.
    """
    order = np.argsort(np.diagonal(K), kind="stable")
    M, K = M[np.ix_(order, order)], K[np.ix_(order, order)]
    # Exactly triangular, so that no large number of a later row gets into an earlier one.
    inverse = solve_triangular(np.linalg.cholesky(M), np.eye(len(M)), lower=True)
    H = inverse @ K @ inverse.T
    H = 0.5 * (H + H.T)
    shift = 2.0 * float(np.linalg.norm(H[:soft, :soft]))
    H[np.diag_indices_from(H)] += shift
    # Scaled columns are what gejsv is made for.  U is not needed, but without it gejsv takes a route that may fail.
    sigma, _, V, scaled, _, info = dgejsv(np.linalg.cholesky(H).T, joba=0, jobu=0, jobv=1, jobt=1)
    if info != 0:
        raise np.linalg.LinAlgError("the singular value decomposition did not converge")
    sigma = sigma * (scaled[0] / scaled[1])
    eigenvalues = (sigma * sigma - shift)[::-1]
    sorted_shapes = (inverse.T @ V).T[::-1]
    _follow(M, K, eigenvalues, sorted_shapes, shift)
    shapes = np.empty_like(sorted_shapes)
    shapes[:, order] = sorted_shapes
    return eigenvalues, shapes


def _follow(M: Array, K: Array, eigenvalues: Array, shapes: Array, shift: float) -> None:
    """Correct in place what stiff coordinates yield in softer modes: by their rows of (K - lambda M) phi = 0."""
    size = np.sqrt(np.abs(np.diagonal(K)))
    for i, value in enumerate(eigenvalues):
        first = int(np.searchsorted(np.diagonal(K), STIFF * max(abs(value), shift)))
        if first == len(size):
            continue
        rows = K[first:] - value * M[first:]
        scale = size[first:]
        forces = rows[:, :first] @ shapes[i, :first]
        scaled = rows[:, first:] / (scale[:, None] * scale)
        shapes[i, first:] = -np.linalg.solve(scaled, forces / scale) / scale
