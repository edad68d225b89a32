"""Coordinates, and motions, without mass."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import linalg, sparse

from helpers.robots.small_structures import mixture
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import MatrixStructure, Parameter
from pkmodes.loop.diagnosis.matrices import at_measured_setups


def test_a_coordinate_without_mass_follows_the_others() -> None:
    # Two masses, and between them a joint without mass: springs in a row.
    def matrices(values, setup) -> tuple[np.ndarray, np.ndarray]:
        k1, k2 = 300.0, values["k"]
        return np.diag([2.0, 0.0, 1.0]), np.array(
            [[100.0 + k1, -k1, 0.0], [-k1, k1 + k2, -k2], [0.0, -k2, k2]]
        )

    structure = MatrixStructure([Parameter("k", 600.0, lower=1.0)], [], matrices, channels=["a", "j", "b"])
    found = structure.predict(np.array([600.0]), (0,))
    k = 300.0 * 600.0 / 900.0  # in series
    M, K = np.diag([2.0, 1.0]), np.array([[100.0 + k, -k], [-k, k]])
    expected, shapes = linalg.eigh(K, M)
    assert found.eigenvalues[0] == pytest.approx(expected, rel=1e-12)
    signs = np.sign(found.shapes[0, :, 0] * shapes[0])
    joint = (300.0 * shapes[0] + 600.0 * shapes[1]) / 900.0  # where the forces of the springs are equal
    assert found.shapes[0] == pytest.approx(np.column_stack([shapes[0], joint, shapes[1]]) * signs[:, None])
    # dk/dk2 = (k1 / (k1 + k2))^2
    assert found.rates[0, :, 0] == pytest.approx((shapes[0] - shapes[1]) ** 2 / 9.0, rel=1e-8)


@pytest.mark.parametrize(("n", "still"), [(6, 1), (6, 4), (40, 15)])
def test_motions_without_mass_need_not_be_coordinates(n: int, still: int) -> None:
    M, K, directions = mixture(n, still, n)
    structure = MatrixStructure([], [], lambda *_: (M, K), channels=[str(i) for i in range(n)])
    found = structure.predict(np.zeros(0), ())
    # M phi = mu K phi has these as mu = 0.
    mu = linalg.eigh(M, K, eigvals_only=True)[still:][::-1]
    assert found.eigenvalues[0] == pytest.approx(1.0 / mu, rel=1e-9)
    phi = found.shapes[0]
    assert phi @ M @ phi.T == pytest.approx(np.eye(n - still), abs=1e-9)
    assert phi @ K @ directions == pytest.approx(0.0, abs=1e-9)  # no force on what has no mass


def test_a_mass_where_there_was_none_adds_a_mode() -> None:
    def matrices(values, setup) -> tuple[np.ndarray, np.ndarray]:
        return np.diag([1.0, values["m"]]), np.array([[300.0, -100.0], [-100.0, 100.0]])

    structure = MatrixStructure([Parameter("m", 0.0, lower=0.0)], [], matrices, channels=["a", "b"])
    found = structure.predict(np.zeros(1), (0,), shape_rates=True)
    assert found.eigenvalues == pytest.approx(np.array([[200.0]]))
    # b moves with a, so that a mass there is a mass on a: d lambda / dm = -lambda.
    assert found.rates[0] == pytest.approx(np.array([[-200.0]]))
    # phi_a = (1 + m)^-1/2, and b runs ahead by lambda m / 100 of it.
    assert np.asarray(found.shape_rates)[0, 0, :, 0] == pytest.approx(
        np.sign(found.shapes[0, 0, 0]) * np.array([-0.5, 1.5])
    )
    heavier = structure.predict(np.array([0.1]), ())
    assert heavier.eigenvalues[0] == pytest.approx(linalg.eigvalsh(*matrices({"m": 0.1}, "")[::-1]))


@pytest.mark.parametrize(
    ("M", "K", "message"),
    [
        (np.diag([1.0, 0.0]), np.diag([1.0, 0.0]), "expected stiffness for every coordinate without mass"),
        (np.diag([1.0, 0.0]), np.diag([1.0, -1.0]), "expected stiffness for every coordinate without mass"),
        (
            np.diag([1.0, 0.0, 0.0]),
            [[1, 0, 0], [0, 1, -1], [0, -1, 1]],
            "expected stiffness for every coordinate without mass",
        ),
        (np.ones((2, 2)), [[1.0, 1.0], [1.0, 1.0]], "expected stiffness for every coordinate without mass"),
        ([[1.0, 0.5], [0.5, 0.0]], np.eye(2), "expected M positive definite except for motions without mass"),
        (np.eye(2), -np.eye(2), "expected a stable structure, found the eigenvalue -1 1/s"),
        (np.eye(2), np.diag([1.0, -1.0]), "expected a stable structure"),
    ],
)
@pytest.mark.parametrize("copies", [1, 20])
def test_matrices_without_modes_are_refused(M: Any, K: Any, message: str, copies: int) -> None:
    # As it is, and in many copies; given as sparse matrices.
    M, K = (sparse.kron(sparse.eye_array(copies), np.asarray(matrix, dtype=float)) for matrix in (M, K))
    channels = [str(i) for i in range(M.shape[0])]
    with pytest.raises(
        PkmodesError, match=f"cannot be evaluated with its declared values: {message}"
    ) as error:
        at_measured_setups(
            MatrixStructure([], [], lambda *_: (M, K), channels=channels, setups=["rig"], modes=2), ["rig"]
        )
    assert 'for setup "rig"' in error.value.where
