"""The batched generalised eigenproblem against SciPy's, with the scale and sign of shapes."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from scipy.linalg import eigh

from pkmodes.core.linalg.eigen import generalised_eigh, natural_frequencies


def random_pair(rng: np.random.Generator, n: int, spread: float) -> tuple[np.ndarray, np.ndarray]:
    """Symmetric K, positive definite M whose diagonal spans `spread` orders of magnitude."""
    scale = 10.0 ** rng.uniform(-spread, 0, n)
    A, B = rng.normal(size=(n, n)), rng.normal(size=(n, n))
    M = np.outer(scale, scale) * (A @ A.T + n * np.eye(n))
    K = np.outer(scale, scale) * (B + B.T) * 1e4
    return M, K


@pytest.mark.parametrize("seed", range(5))
def test_eigenvalues_and_shapes_equal_scipy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pairs = [random_pair(rng, 9, 2.0) for _ in range(20)]
    M, K = (np.array(m) for m in zip(*pairs, strict=True))
    eigenvalues, shapes = generalised_eigh(M, K)
    for i in range(len(M)):
        expected, vectors = eigh(K[i], M[i])
        # Backward stable solvers: errors of a few rounding units of the largest eigenvalue.
        np.testing.assert_allclose(eigenvalues[i], expected, rtol=0, atol=1e-13 * np.abs(expected).max())
        overlap = np.abs(np.sum(shapes[i] * (M[i] @ vectors).T, axis=1))
        np.testing.assert_allclose(overlap, 1.0, rtol=0, atol=1e-9)  # gaps of random spectra are not small
        np.testing.assert_allclose(shapes[i] @ M[i] @ shapes[i].T, np.eye(9), rtol=0, atol=1e-12)
        residual = K[i] @ shapes[i].T - M[i] @ shapes[i].T * eigenvalues[i]
        assert np.abs(residual).max() < 1e-11 * np.abs(K[i]).max() * np.abs(shapes[i]).max()


def test_eigenvalues_equal_fifty_digit_evaluation() -> None:
    M, K = random_pair(np.random.default_rng(5), 6, 1.0)
    with mpmath.workdps(50):
        L_inverse = mpmath.cholesky(mpmath.matrix(M.tolist())) ** -1
        exact = mpmath.eigsy(L_inverse * mpmath.matrix(K.tolist()) * L_inverse.T, eigvals_only=True)
    expected = np.sort([float(value) for value in exact])
    found, _ = generalised_eigh(M[None], K[None])
    np.testing.assert_allclose(found[0], expected, rtol=0, atol=2e-14 * np.abs(expected).max())


def test_sign_is_that_of_the_first_of_the_largest_components() -> None:
    M = np.eye(2)
    K = np.array([[2.0, -1.0], [-1.0, 2.0]])  # shapes (1, 1) and (1, -1): components of equal size
    for noise in (0.0, 1e-15, -1e-15):
        _, shapes = generalised_eigh(M[None], (K + noise * np.array([[1, 0], [0, -1]]))[None])
        assert shapes[0, 0] == pytest.approx([0.5**0.5, 0.5**0.5])
        assert shapes[0, 1] == pytest.approx([0.5**0.5, -(0.5**0.5)])


def test_frequencies_keep_the_sign_of_the_eigenvalue() -> None:
    found = natural_frequencies(np.array([-((2 * np.pi) ** 2), 0.0, (4 * np.pi) ** 2]))
    np.testing.assert_allclose(found, [-1.0, 0.0, 2.0], rtol=1e-15)


def test_an_indefinite_mass_matrix_is_an_error() -> None:
    with pytest.raises(np.linalg.LinAlgError):
        generalised_eigh(np.diag([1.0, 1.0, 2.0])[None] - 1.5 * np.ones((3, 3)) / 3 * 2, np.eye(3)[None])
