"""The compiled evaluator agrees with generated NumPy and LAPACK, and solves its eigenproblem, for every mechanism."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from helpers.references.lane_agreement import assert_agrees
from helpers.references.numpy_modes import solve
from helpers.robots.lane_samples import EFFECTS, EXTREMES, NAMES, SIX_LEGGED, case, results

pytestmark = pytest.mark.compiler


@pytest.mark.parametrize("name", NAMES)
def test_modes_agree_with_numpy(subtests: pytest.Subtests, name: str) -> None:
    for effects, seed in product(EFFECTS, range(4)):
        with subtests.test(f"{effects}, {seed}"):
            assert_agrees(case(name, seed, effects))


@pytest.mark.parametrize("name", SIX_LEGGED)
def test_modes_of_platforms_that_turn_agree_with_numpy(name: str) -> None:
    """Twelve and eighteen coordinates, with all effects more; `test_hexapod_oracle` has many machines."""
    assert_agrees(case(name, 0, count=25))
    assert_agrees(case(name, 1, "everything", count=25))
    assert_agrees(case(name, 2, "none", "hundredfold gravity", count=25))


@pytest.mark.parametrize("name", NAMES)
def test_hard_eigenproblems_agree_with_numpy(subtests: pytest.Subtests, name: str) -> None:
    for extreme, effects in product(EXTREMES, ["none", "everything"]):
        with subtests.test(f"{extreme}, {effects}"):
            for seed in range(4):
                assert_agrees(case(name, seed, effects, extreme))


@pytest.mark.parametrize("name", NAMES)
def test_signs_are_those_of_the_eigensolver(name: str) -> None:
    """Where no two components are nearly as large, the sign of a shape is decided and the same."""
    given = case(name, 3)
    codes, found = results(given, given.poses)
    expected = solve(given.evaluation, given.poses[codes == 0])
    scaled = np.abs(expected.shapes) * np.sqrt(np.diagonal(expected.M, axis1=1, axis2=2))[:, None]
    two = np.sort(scaled, axis=-1)[..., -2:]
    decided = two[..., 0] < 0.99 * two[..., 1]
    decided[:, : given.evaluation.rigid_modes] = False
    assert decided.sum() > 20
    products = (found["shapes"][codes == 0] * expected.shapes).sum(axis=-1)
    assert (products[decided] > 0).all()
