"""Rotation vectors against another library, from no rotation to nearly half a turn."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pkmodes.core.linalg.rotations import (
    left_jacobian,
    matrices_of_vectors,
    vectors_about,
    vectors_of_matrices,
)


@pytest.mark.parametrize("size", [0.0, 1e-9, 5e-4, 2e-3, 0.3, 1.5])
def test_matrices_vectors_and_rates_are_those_of_another_library(size: float) -> None:
    rng = np.random.default_rng(3)
    r, change = rng.normal(size=(2, 6, 3))
    r *= size / np.linalg.norm(r, axis=1, keepdims=True)
    expected = Rotation.from_rotvec(r)
    np.testing.assert_allclose(matrices_of_vectors(r), expected.as_matrix(), rtol=0.0, atol=4e-16)
    np.testing.assert_allclose(vectors_of_matrices(expected.as_matrix()), r, rtol=1e-14, atol=1e-16)
    # The small rotation from one side of r to the other, about base axes: central differences.
    h = 1e-5
    apart = Rotation.from_rotvec(r + h * change) * Rotation.from_rotvec(r - h * change).inv()
    turned = np.einsum("nij,nj->ni", left_jacobian(r), change)
    np.testing.assert_allclose(turned, apart.as_rotvec() / (2.0 * h), rtol=0.0, atol=1e-9)


def test_components_about_some_axes_are_those_of_a_vector() -> None:
    np.testing.assert_array_equal(
        vectors_about(("z",), np.array([[0.3], [0.1]])), [[0.0, 0.0, 0.3], [0.0, 0.0, 0.1]]
    )
