"""The eigensolver of the lanes on matrices with known eigenvalues, or that are known to be hard."""

from __future__ import annotations

import ctypes
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import mpmath
import numpy as np
import pytest

from pkmodes.core.compiled import build
from pkmodes.core.linalg.eigen import TIE_TOLERANCE

pytestmark = pytest.mark.compiler

HARNESS = Path(__file__).parent / "eigen_harness.c"
WIDTH = 4
EPS = np.finfo(float).eps

Solver = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray, np.ndarray]]


@pytest.fixture(scope="module")
def solve(tmp_path_factory: pytest.TempPathFactory) -> Solver:
    """Portable code, four problems at a time."""
    target = tmp_path_factory.mktemp("eigen") / "eigen.so"
    cc = build.compiler()
    assert cc is not None
    command = [
        *cc,
        *build.FLAGS,
        f"-DLANES_WIDTH={WIDTH}",
        "-I",
        str(build.FOLDER),
        "-Wall",
        "-Wextra",
        "-Werror",
    ]
    command += ["-Wno-psabi", "-fvisibility=default", "-shared", str(HARNESS), "-o", str(target), "-lm"]
    subprocess.run(command, check=True)
    function = ctypes.CDLL(str(target)).solve

    def call(M: np.ndarray, K: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        n = M.shape[-1]
        M, K = (np.ascontiguousarray(np.broadcast_to(a, (WIDTH, n, n)), dtype=float) for a in (M, K))
        values, shapes, bad = np.empty((WIDTH, n)), np.empty((WIDTH, n, n)), np.empty(WIDTH, dtype=np.int32)
        arrays = (M, K, values, shapes, bad)
        function(n, *(ctypes.c_void_p(a.ctypes.data) for a in arrays))
        order = np.argsort(values, axis=1)
        return np.take_along_axis(values, order, 1), np.take_along_axis(shapes, order[..., None], 1), bad

    return call


def assert_solved(solve: Solver, M: np.ndarray, K: np.ndarray, expected: np.ndarray) -> None:
    values, shapes, bad = solve(M, K)
    n = K.shape[-1]
    size = max(np.abs(expected).max(), np.finfo(float).tiny)
    assert not bad.any()
    assert np.abs(values - expected).max() <= 10 * n * EPS * size
    product = shapes @ M @ np.swapaxes(shapes, -1, -2)
    assert np.abs(product - np.eye(n)).max() <= 20 * n * EPS
    scale = 1 / np.sqrt(np.diagonal(M))
    residual = (shapes @ K - values[..., None] * (shapes @ M)) * scale
    assert np.abs(residual).max() <= 20 * n * EPS * size


def second_difference(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Its eigenvalues are known: 2 - 2 cos(k pi / (n + 1))."""
    K = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    return K, 2 - 2 * np.cos(np.arange(1, n + 1) * np.pi / (n + 1))


@pytest.mark.parametrize("n", [1, 2, 3, 4, 9, 16, 24])
def test_a_chain_of_springs_has_its_closed_form(solve: Solver, n: int) -> None:
    K, expected = second_difference(n)
    assert_solved(solve, np.eye(n), K, expected)
    assert_solved(solve, 4.0 * np.eye(n), K, expected / 4)


def test_a_diagonal_matrix_is_its_own_solution(solve: Solver) -> None:
    values = np.array([3.0, -1.0, 0.0, 3.0, 1e-200, 7.0, 0.0])
    assert_solved(solve, np.eye(7), np.diag(values), np.sort(values))


@pytest.mark.parametrize("n", [2, 9, 21])
def test_zero_has_eigenvalues_zero(solve: Solver, n: int) -> None:
    assert_solved(solve, np.eye(n), np.zeros((n, n)), np.zeros(n))


def test_a_matrix_of_ones_has_one_eigenvalue_beside_zero(solve: Solver) -> None:
    assert_solved(solve, np.eye(9), np.ones((9, 9)), np.array([0.0] * 8 + [9.0]))


def test_blocks_that_do_not_touch_are_solved_apart(solve: Solver) -> None:
    K = np.zeros((9, 9))
    K[:4, :4], a = second_difference(4)
    K[4:, 4:], b = second_difference(5)
    assert_solved(solve, np.eye(9), K, np.sort(np.concatenate([a, b])))


def test_pairs_that_agree_to_the_last_digits_stay_orthogonal(solve: Solver) -> None:
    """Wilkinson's matrix: its largest two eigenvalues differ by 7e-14."""
    n = 21
    K = np.diag(np.abs(np.arange(n) - n // 2)).astype(float) + np.eye(n, k=1) + np.eye(n, k=-1)
    with mpmath.workdps(40):
        expected = np.array(
            sorted(float(v) for v in mpmath.eigsy(mpmath.matrix(K.tolist()), eigvals_only=True))
        )
    assert expected[-1] - expected[-2] < 1e-13
    assert_solved(solve, np.eye(n), K, expected)


@pytest.mark.parametrize("n", [3, 9, 21])
@pytest.mark.parametrize("spread", [0, 6, 12])
def test_any_symmetric_pair_agrees_with_forty_digits(solve: Solver, n: int, spread: int) -> None:
    """Eigenvalues from 1 to 10^spread with any vectors, masses from 1e-4 to 1e4."""
    rng = np.random.default_rng(100 * n + spread)
    Q, _ = np.linalg.qr(rng.normal(size=(n, n)))
    A = Q * 10.0 ** rng.uniform(0, spread, n) @ Q.T
    masses = 10.0 ** rng.uniform(-4, 4, n)
    root = np.sqrt(masses)
    L = np.tril(rng.normal(size=(n, n)) * 0.3, -1) + np.eye(n)
    M = (root[:, None] * L) @ (root[:, None] * L).T
    K = root[:, None] * (A + A.T) / 2 * root
    with mpmath.workdps(40):
        X = mpmath.cholesky(mpmath.matrix(M.tolist())) ** -1
        B = X * mpmath.matrix(((K + K.T) / 2).tolist()) * X.T
        expected = np.array(sorted(float(v) for v in mpmath.eigsy(B, eigvals_only=True)))
    values, shapes, bad = solve(M, (K + K.T) / 2)
    condition = np.linalg.cond(M / root[:, None] / root)
    assert not bad.any()
    assert np.abs(values - expected).max() <= 20 * n * EPS * condition * np.abs(expected).max()
    assert np.abs(shapes @ M @ np.swapaxes(shapes, -1, -2) - np.eye(n)).max() <= 20 * n * EPS * condition


def test_a_lane_whose_rotations_underflow_is_handed_back_and_the_others_are_not(solve: Solver) -> None:
    """Off-diagonal elements of 1e-200 beside zeros are not negligible, and their squares are zero."""
    K, _ = second_difference(9)
    tiny = 1e-200 * (np.eye(9, k=1) + np.eye(9, k=-1))
    alone = solve(np.eye(9), K)
    values, shapes, bad = solve(np.eye(9), np.stack([tiny, K, K, tiny]))
    assert bad.tolist() == [1, 0, 0, 1]
    assert values[1].tobytes() == alone[0][1].tobytes()
    assert shapes[1].tobytes() == alone[1][1].tobytes()


def test_each_lane_is_a_problem_of_its_own(solve: Solver) -> None:
    """One that is singular, one with NaN, one with infinity: the fourth has the bits that it has alone."""
    K, _ = second_difference(9)
    rng = np.random.default_rng(1)
    good = K + 0.1 * np.diag(rng.uniform(size=9))
    alone = solve(np.eye(9), good)
    M = np.stack([np.eye(9)] * WIDTH)
    both = np.stack([good] * WIDTH)
    M[0, 3, 3], both[1, 2, 2], both[2, 0, 1] = -1.0, np.nan, np.inf
    both[2, 1, 0] = np.inf
    values, shapes, bad = solve(M, both)
    assert bad[0] == 1
    assert bad[3] == 0
    assert not np.isfinite(values[1]).all()
    assert not np.isfinite(values[2]).all()
    assert values[3].tobytes() == alone[0][3].tobytes()
    assert shapes[3].tobytes() == alone[1][3].tobytes()


@pytest.mark.parametrize("scale", [1e-150, 1e-30, 1e30, 1e140])
def test_units_do_not_matter(solve: Solver, scale: float) -> None:
    K, expected = second_difference(9)
    assert_solved(solve, np.eye(9), K * scale, expected * scale)


def test_ties_are_those_of_the_reference() -> None:
    text = (build.FOLDER / "eigen.h").read_text(encoding="utf-8")
    assert re.findall(r"#define EIGEN_TIE (\S+)", text) == ["1e-6"]
    assert float("1e-6") == TIE_TOLERANCE
