"""A singular value decomposition where LAPACK's divide and conquer gives up."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.core.linalg.decomposition import thin_svd


def low_rank(shape: tuple[int, int]) -> np.ndarray:
    rng = np.random.default_rng(4)
    return rng.standard_normal((shape[0], 5)) @ rng.standard_normal((5, shape[1]))


@pytest.mark.parametrize("shape", [(30, 80), (80, 30)])
def test_another_algorithm_decomposes_what_the_first_gives_up(
    monkeypatch: pytest.MonkeyPatch, shape: tuple[int, int]
) -> None:
    matrix = low_rank(shape)
    expected = np.linalg.svd(matrix, compute_uv=False)

    def gives_up(*arguments: object, **options: object) -> None:
        raise np.linalg.LinAlgError("SVD did not converge")

    monkeypatch.setattr(np.linalg, "svd", gives_up)
    U, s, Vh = thin_svd(matrix)
    assert (U.shape, s.shape, Vh.shape) == ((shape[0], 30), (30,), (30, shape[1]))
    np.testing.assert_allclose(U * s @ Vh, matrix, rtol=0, atol=1e-12)
    np.testing.assert_allclose(U.T @ U, np.eye(30), rtol=0, atol=1e-12)
    np.testing.assert_allclose(s, expected, rtol=0, atol=1e-12)


def test_what_is_not_finite_stays_an_error() -> None:
    matrix = low_rank((6, 4))
    matrix[2, 1] = np.nan
    with pytest.raises(np.linalg.LinAlgError):
        thin_svd(matrix)
