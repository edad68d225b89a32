"""Derivatives of shapes: against differences and closed forms."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
from scipy import sparse

from helpers.robots.small_structures import mixture
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Measurements, Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis


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


@pytest.mark.parametrize("still", [False, True])
def test_derivatives_of_shapes_at_some_coordinates(still: bool) -> None:
    n = 60

    def matrices(values, setup) -> tuple[Any, Any]:
        k = 1e4 * np.ones(n)
        k[18:23] *= 1 + values["stiffer"]
        m = np.ones(n)
        if still:
            m[1::2] = 0.0
        m[27 if still else 26] += values["tip"]
        K = sparse.diags_array([k + np.append(k[1:], 0.0), -k[1:], -k[1:]], offsets=[0, 1, -1])
        return sparse.diags_array(m), K

    channels = [f"x{i}" for i in range(0, n, 7)]
    structure = MatrixStructure(
        [Parameter("stiffer", 0.0, lower=-0.9), Parameter("tip", 0.0, lower=-1.0)],
        [],
        matrices,
        channels=channels,
        coordinates=[f"x{i}" for i in range(n)],
        modes=6,
    )
    values = np.array([0.1, 0.3])
    found = every(structure, values, (0, 1))
    expected = differences(structure, values, np.array([1e-4, 1e-4]))
    assert found == pytest.approx(expected, abs=1e-6 * np.abs(expected).max())


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


def test_a_mode_that_coincides_with_the_first_one_left_out_rotates_as_fast() -> None:
    n = 30
    level = np.concatenate([[1.0, 4.0, 4.0 + 1e-9], 10.0 + np.arange(n - 3)])

    def matrices(values, setup) -> tuple[Any, Any]:
        c = np.zeros(n - 1)
        c[1] = values["c"]
        return sparse.eye_array(n), sparse.diags_array([level, c, c], offsets=[0, 1, -1])

    structure = MatrixStructure(
        [Parameter("c", 0.0)], [], matrices, channels=[str(i) for i in range(n)], modes=2
    )
    found = every(structure, np.zeros(1), (0,))
    # Which combination of the two counts as the second mode is open; only a turn of one by the other is left.
    assert np.abs(found[0, 1, :, 0]).max() <= 1.01 / 4e-6
    assert found[0, 1, [0, *range(3, n)], 0] == pytest.approx(0.0, abs=1e-9)


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


def row(n: int, *, free: bool = False, still: bool = False) -> Callable:
    """N masses in a row, of which the first may be free and every second one may have no mass."""

    def matrices(values, setup) -> tuple[Any, Any]:
        k = 1e4 * np.ones(n)
        k[n // 3 : n // 2] *= 1 + values["stiffer"]
        k[0] *= not free
        m = np.ones(n)
        m[1::2] *= not still
        m[n // 2 - n // 2 % 2] += values["heavier"]
        K = sparse.diags_array([k + np.append(k[1:], 0.0), -k[1:], -k[1:]], offsets=[0, 1, -1])
        return sparse.diags_array(m), K

    return matrices


def in_a_row(n: int, modes: int | None = None, **options: bool) -> MatrixStructure:
    return MatrixStructure(
        [Parameter("stiffer", 0.0, lower=-0.9), Parameter("heavier", 0.0, lower=0.0)],
        [Candidate("stiffer", ("stiffer",)), Candidate("heavier", ("heavier",))],
        row(n, **options),
        channels=[str(i) for i in range(n)],
        rigid=int(options.get("free", False)),
        modes=modes,
    )


@pytest.mark.parametrize("options", [{}, {"free": True}, {"still": True}, {"free": True, "still": True}])
def test_derivatives_of_shapes_where_motions_are_free_or_without_mass(options: dict[str, bool]) -> None:
    structure, values = in_a_row(60, 24, **options), np.array([0.3, 0.5])
    found = every(structure, values, (0, 1))
    expected = differences(structure, values, np.array([1e-5, 1e-5]))
    # Rounding of the shapes, some 1e-13 in 1e-5 steps, and the third derivatives of the uppermost modes.
    assert found == pytest.approx(expected, abs=2e-6 * np.abs(expected).max())


def test_a_fit_finds_a_value_by_shapes_and_keeps_no_derivatives() -> None:
    structure = in_a_row(60)
    found = structure.predict(np.array([0.5, 0.0]), ())
    f = np.exp(found.log_frequencies[0, [1, 3, 4]])
    seen = [5, 19, 25, 35]
    data = Measurements.from_rows(
        ["a"] * 3, f, 1e-3 * f, shapes={str(i): found.shapes[0, [1, 3, 4], i] for i in seen}
    )
    fit = Fitter(structure, data).fit(Hypothesis(structure.candidates[:1]))
    assert fit is not None
    assert fit.values[0] == pytest.approx(0.5, rel=1e-6)
    assert fit.prediction.shape_rates is None  # those of all fits together are large
