r"""The eigenproblem of a system whose eigenvalues differ by many orders of magnitude, solved to relative precision.

A joint of compliance c has the stiffness 1/c, and as c goes to zero the eigenvalues of its modes go to infinity.  The
error of a symmetric solver is rounding of the largest eigenvalue, which can then exceed the other eigenvalues.  But
the large numbers are on the diagonal of K only, so the matrix :math:`H = L^{-1} K L^{-T} + \sigma I`, with the
coordinates ordered by stiffness, is graded: :math:`H = D B D` with a diagonal D that spans all orders of magnitude
and a well-conditioned B.  Its Cholesky factor is computed with small relative errors in every row, and one-sided
Jacobi rotations (LAPACK's ``gejsv``) find the singular values of such a factor with an error relative to each of
them, not to the largest.  The shift makes H positive definite where rigid-body motions and gravity make K indefinite;
it is of the order of the eigenvalues of the coordinates that are not stiff.

References: Demmel and Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13(4), 1992;
Drmac and Veselic, New fast and accurate Jacobi SVD algorithm, ibid. 29(4), 2008.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular
from scipy.linalg.lapack import dgejsv

Array = NDArray[np.float64]

#: A coordinate this much stiffer than a mode follows its forces quasi-statically, up to a small correction.
QUASI_STATIC_RATIO = 1e4


def graded_eigh(M: Array, K: Array, soft_count: int, shift: float = 0.0) -> tuple[Array, Array]:
    """Solve K phi = lambda M phi for one system with some very stiff coordinates.

    - M, K: symmetric, (n, n); M positive definite with a unit diagonal.  The diagonal of K may be arbitrarily large.
    - soft_count: at least this many coordinates are not stiff
    - shift: a larger shift, if that of the soft coordinates does not make K + shift M positive definite

    Returns, in this order:
    - eigenvalues: ascending, (n,); errors are relative to the larger of the eigenvalue itself and those of the soft
      coordinates
    - shapes: ``shapes[i]`` is mode i, with phi^T M phi = 1, (n, n); the small components of stiff coordinates in a
      soft mode are accurate relative to their own size

    Raises numpy.linalg.LinAlgError if M is not positive definite, or K is not finite.
    """
    order = np.argsort(np.diagonal(K), kind="stable")
    M, K = M[np.ix_(order, order)], K[np.ix_(order, order)]
    # Exactly triangular, so that large numbers of later rows do not enter earlier ones.
    identity = np.eye(len(M))
    inverse_factor = (
        identity
        if np.array_equal(M, identity)
        else solve_triangular(np.linalg.cholesky(M), identity, lower=True)
    )
    H = inverse_factor @ K @ inverse_factor.T
    H = 0.5 * (H + H.T)
    shift = max(shift, 2.0 * float(np.linalg.norm(H[:soft_count, :soft_count])))
    H[np.diag_indices_from(H)] += shift
    # gejsv is designed for scaled columns.  U is not needed, but without it gejsv takes a path that may fail.
    sigma, _, V, scaled, _, info = dgejsv(np.linalg.cholesky(H).T, joba=0, jobu=0, jobv=1, jobt=1)
    if info != 0:
        raise np.linalg.LinAlgError("the singular value decomposition did not converge")
    sigma = sigma * (scaled[0] / scaled[1])
    eigenvalues = (sigma * sigma - shift)[::-1]
    sorted_shapes = (inverse_factor.T @ V).T[::-1]
    _correct_stiff_coordinates(M, K, eigenvalues, sorted_shapes, shift)
    shapes = np.empty_like(sorted_shapes)
    shapes[:, order] = sorted_shapes
    return eigenvalues, shapes


def _correct_stiff_coordinates(M: Array, K: Array, eigenvalues: Array, shapes: Array, shift: float) -> None:
    """Correct the stiff coordinates of softer modes in place, from their rows of (K - lambda M) phi = 0."""
    scales = np.sqrt(np.abs(np.diagonal(K)))
    for i, eigenvalue in enumerate(eigenvalues):
        first_stiff = int(np.searchsorted(np.diagonal(K), QUASI_STATIC_RATIO * max(abs(eigenvalue), shift)))
        if first_stiff == len(scales):
            continue
        rows = K[first_stiff:] - eigenvalue * M[first_stiff:]
        stiff_scales = scales[first_stiff:]
        forces = rows[:, :first_stiff] @ shapes[i, :first_stiff]
        scaled = rows[:, first_stiff:] / (stiff_scales[:, None] * stiff_scales)
        shapes[i, first_stiff:] = -np.linalg.solve(scaled, forces / stiff_scales) / stiff_scales
