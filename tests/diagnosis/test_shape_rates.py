"""Derivatives of shapes: against differences and closed forms."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from helpers.robots.small_structures import mixture
from pkmodes.diagnosis import MatrixStructure, Parameter


def every(structure: MatrixStructure, values: np.ndarray, by: Sequence[int]) -> np.ndarray:
    """Derivatives of the shapes of all modes."""
    return np.asarray(structure.predict(values, by, shape_rates=True).shape_rates)


def differences(structure: MatrixStructure, values: np.ndarray, steps: np.ndarray) -> np.ndarray:
    """Central differences of the shapes, with their signs aligned."""
    centre, columns = structure.predict(values, ()).shapes, []
    for i, step in enumerate(steps):
        both = []
        for sign in (1, -1):
            moved = values.copy()
            moved[i] += sign * step
            shapes = structure.predict(moved, ()).shapes
            both.append(shapes * np.sign((shapes * centre).sum(axis=-1, keepdims=True)))
        columns.append((both[0] - both[1]) / (2 * step))
    return np.stack(columns, axis=-1)


def parametric(n: int, still: int, few: bool) -> MatrixStructure:
    """A structure with massless motions, with all or few modes."""
    M, K, _ = mixture(n, still, 3)
    rng = np.random.default_rng(n)
    A, B = rng.standard_normal((2, n, n))
    dK, dM = A @ A.T / 3, M @ (B @ B.T) @ M / n
    return MatrixStructure(
        [Parameter("k", 0.0), Parameter("m", 0.0)],
        [],
        lambda v, _: (M + v["m"] * dM, K + (v["k"] + v["k"] ** 2) * dK),
        derivatives=lambda v, _, name: (0 * dM, (1 + 2 * v["k"]) * dK) if name == "k" else (dM, 0 * dK),
        channels=[str(i) for i in range(n)],
        modes=4 if few else None,
    )


@pytest.mark.parametrize("few", [False, True])
@pytest.mark.parametrize(("n", "still"), [(5, 0), (7, 2), (40, 0), (40, 12)])
def test_derivatives_of_shapes_agree_with_differences(n: int, still: int, few: bool) -> None:
    structure = parametric(n, still, few)
    values = np.array([0.2, 0.05])
    found = every(structure, values, (0, 1))
    expected = differences(structure, values, np.array([1e-5, 1e-5]))
    assert found == pytest.approx(expected, abs=2e-6 * np.abs(expected).max())
    assert every(structure, values, (1,)) == pytest.approx(found[..., 1:])
    assert structure.predict(values, (0, 1)).shape_rates is None


def test_few_modes_have_the_same_derivatives_as_all() -> None:
    one, other = (parametric(40, 0, few) for few in (False, True))
    whole, part = (structure.predict(np.zeros(2), (0, 1), shape_rates=True) for structure in (one, other))
    signs = np.sign((whole.shapes[:, :4] * part.shapes).sum(axis=-1))[..., None, None]
    assert np.asarray(part.shape_rates) == pytest.approx(
        np.asarray(whole.shape_rates)[:, :4] * signs, abs=1e-10
    )


def test_shapes_of_coincident_modes_rotate_as_fast_as_the_limit() -> None:
    # Two equal masses on equal springs: a coupling c splits them, and rotates their shapes immediately.
    structure = MatrixStructure(
        [Parameter("c", 0.0)],
        [],
        lambda v, _: (np.eye(3), np.array([[4.0, v["c"], 0], [v["c"], 4.0 + 1e-9, 0], [0, 0, 9.0]])),
        channels=["a", "b", "c"],
    )
    found = every(structure, np.zeros(1), (0,))
    # phi_1 rotates towards phi_2 by 1 / (lambda_1 - lambda_2), where the gap counts as 4e-6 instead of 1e-9.
    assert found[0, 0, :, 0] == pytest.approx([0.0, -1 / 4e-6, 0.0], rel=1e-6)
    assert found[0, 1, :, 0] == pytest.approx([1 / 4e-6, 0.0, 0.0], rel=1e-6)
    exact = MatrixStructure(
        [Parameter("c", 0.0)],
        [],
        lambda v, _: (np.eye(2), np.diag([v["c"], 0.0])),
        channels=["a", "b"],
        rigid=2,
    )
    assert np.isfinite(every(exact, np.zeros(1), (0,))).all()


def test_a_setup_without_modes_has_no_derivatives() -> None:
    structure = MatrixStructure(
        [Parameter("m", 0.0, upper=4.0)],
        [],
        lambda v, setup: (
            np.diag([1.0, 2.0]) if setup == "A" else np.diag([1.0, 3.0 - v["m"]]),
            np.array([[3.0, -1.0], [-1.0, 2.0]]),
        ),
        channels=["a", "b"],
        setups=["A", "B"],
    )
    assert every(structure, np.zeros(1), ()).shape == (2, 2, 2, 0)
    # More mass than B has is removed: there are no modes.
    part = every(structure, np.array([3.5]), (0,))
    assert np.isnan(part).all(axis=(1, 2, 3)).tolist() == [False, True]
