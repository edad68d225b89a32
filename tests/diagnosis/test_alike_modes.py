"""Modes that are alike at the sensors: a subspace of them counts only directions that differ measurably."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.support.mac import ALIKE, space


@pytest.mark.parametrize(("apart", "dimension"), [(1e-4, 2), (3e-6, 2), (3e-7, 1), (0.0, 1)])
def test_modes_span_two_directions_if_they_differ_by_a_millionth(apart: float, dimension: int) -> None:
    """By the components, not by their squares."""
    basis, _ = space(np.array([[[1.0, 0.0], [0.0, apart]]]))
    assert np.linalg.matrix_rank(basis[0]) == dimension


def test_a_difference_of_exactly_the_limit_does_not_count() -> None:
    basis, back = space(np.array([[[1.0, 0.0], [0.0, ALIKE]]]))
    assert basis.shape == back.shape == (1, 2, 2)
    np.testing.assert_array_equal(basis[0, 0], 0.0)
    np.testing.assert_array_equal(np.abs(basis[0, 1]), [1.0, 0.0])
