"""Structures whose channels are not their coordinates, and coordinates without mass; derivatives of shapes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import linalg, sparse

from pkmodes.diagnosis import MatrixStructure, Parameter
from pkmodes.diagnosis.matrices import at_measured
from pkmodes.errors import PkmodesError

FOUR = ["a", "b", "c", "d"]


def springs(values, setup=None) -> tuple[np.ndarray, np.ndarray]:
    """Four masses of 1, 2, 3 and 4 kg in a row on the ground, with a soft second spring."""
    k = np.array([4e3, 1e3 * (1.0 + values["stiffer"]), 3e3, 2e3])
    M = np.diag([1.0, 2.0, 3.0, 4.0 + values["tip"]])
    return M, np.diag(k + np.append(k[1:], 0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)


CHANGES = [Parameter("stiffer", 0.0, lower=-0.9), Parameter("tip", 0.0, lower=-1.0)]
VALUES = np.array([0.2, 0.5])


def four(**options: Any) -> MatrixStructure:
    return MatrixStructure(CHANGES, [], springs, **{"channels": FOUR, **options})


# Sensors ---------------------------------------------------------------------------------------------------


def test_channels_are_some_of_the_coordinates_in_any_order() -> None:
    whole, part = four(), four(channels=["d", "b"], coordinates=FOUR)
    every, some = (one.predict(VALUES, (0, 1), shape_rates=True) for one in (whole, part))
    assert (some.shapes == every.shapes[..., [3, 1]]).all()
    assert (some.shape_rates == every.shape_rates[:, :, [3, 1]]).all()
    assert (some.eigenvalues == every.eigenvalues).all()
    assert part.subset([0]).channels == ("d", "b")


@pytest.mark.parametrize("form", [np.asarray, sparse.csr_array, sparse.csc_matrix, np.ndarray.tolist])
def test_sensors_measure_any_combination_of_coordinates(form: Any) -> None:
    # Midway between two masses, and the stretch of the last spring.
    sensors = np.array([[0.5, 0.5, 0, 0], [0, 0, -1, 1]])
    found = four(channels=["mid", "stretch"], sensors=form(sensors)).predict(VALUES, (0, 1), shape_rates=True)
    every = four().predict(VALUES, (0, 1), shape_rates=True)
    assert found.shapes == pytest.approx(every.shapes @ sensors.T)
    assert found.shape_rates == pytest.approx(np.einsum("cn,smnt->smct", sensors, every.shape_rates))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            {"channels": ["a", "e"], "coordinates": FOUR},
            r'channel "e" is not one of the 4 coordinates.*a, b, c, d',
        ),
        ({"channels": ["a"], "coordinates": ["a", "b"]}, r"shape \(2, 2\) for 2 coordinates, found \(4, 4\)"),
        ({"channels": ["a"], "coordinates": ["a", "b", "b", "c"]}, 'two coordinates are called "b"'),
        ({"channels": ["a"], "sensors": np.eye(4)}, "expected 1 rows for as many channels"),
        (
            {"channels": ["a"], "sensors": [[1, 0, 0]]},
            r"shape \(3, 3\) for 3 columns of sensors, found \(4, 4\)",
        ),
        ({"channels": ["a"], "sensors": [1, 0, 0, 0]}, "expected 1 rows"),
        ({"channels": ["a"], "sensors": [[1, 0, np.nan, 0]]}, "expected finite real numbers"),
        ({"channels": ["a"], "sensors": [[1, 0, 1j, 0]]}, "expected finite real numbers"),
        ({"channels": ["a"], "sensors": [["x", "y", "z", "q"]]}, "sensors"),
        ({"channels": ["a"], "sensors": [[1, 0], [0]]}, "expected a matrix"),
        ({"channels": ["a", "b"], "sensors": [[1, 0, 0, 0], [0] * 4]}, 'channel "b" measures nothing'),
        ({"channels": FOUR, "sensors": np.eye(4), "coordinates": FOUR}, "found both"),
        ({"channels": ["a", "b"]}, "give one channel for each coordinate, or coordinates= or sensors="),
        ({"modes": 0}, "expected more modes than the rigid ones"),
        ({"modes": 2, "rigid": 2}, "expected more modes than the rigid ones"),
        ({"modes": 2.5}, "in whole numbers, found 2.5"),
    ],
)
def test_sensors_that_do_not_fit_are_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(PkmodesError, match=message):
        four(**options)


# Coordinates without mass ----------------------------------------------------------------------------------


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


def mixture(n: int, still: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """M of rank n - still with directions of its own, K, and the motions without mass."""
    rng = np.random.default_rng(seed)
    A, B = rng.standard_normal((2, n, n))
    directions = np.linalg.qr(B)[0]
    M = (directions[:, still:] * rng.uniform(1.0, 3.0, n - still)) @ directions[:, still:].T
    return 0.5 * (M + M.T), A @ A.T + n * np.eye(n), directions[:, :still]


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
    assert found.shape_rates[0, 0, :, 0] == pytest.approx(
        np.sign(found.shapes[0, 0, 0]) * np.array([-0.5, 1.5])
    )
    heavier = structure.predict(np.array([0.1]), ())
    assert heavier.eigenvalues[0] == pytest.approx(linalg.eigvalsh(*matrices({"m": 0.1}, "")[::-1]))


@pytest.mark.parametrize(
    ("M", "K", "message"),
    [
        (np.diag([1.0, 0.0]), np.diag([1.0, 0.0]), "expected K to hold every coordinate without mass"),
        (np.diag([1.0, 0.0]), np.diag([1.0, -1.0]), "expected K to hold every coordinate without mass"),
        (
            np.diag([1.0, 0.0, 0.0]),
            [[1, 0, 0], [0, 1, -1], [0, -1, 1]],
            "expected K to hold every coordinate without mass",
        ),
        (np.ones((2, 2)), [[1.0, 1.0], [1.0, 1.0]], "expected K to hold every coordinate without mass"),
        ([[1.0, 0.5], [0.5, 0.0]], np.eye(2), "expected M positive definite, but for motions without mass"),
        (np.eye(2), -np.eye(2), "expected a stable structure, found the eigenvalue -1 1/s"),
        (np.eye(2), np.diag([1.0, -1.0]), "expected a stable structure"),
    ],
)
@pytest.mark.parametrize("copies", [1, 120])
def test_what_has_no_modes_is_refused(M: Any, K: Any, message: str, copies: int) -> None:
    # Small as it is, and in many sparse copies.
    M, K = (sparse.kron(sparse.eye_array(copies), np.asarray(matrix, dtype=float)) for matrix in (M, K))
    channels = [str(i) for i in range(M.shape[0])]
    with pytest.raises(
        PkmodesError, match=f"cannot be evaluated with its declared values: {message}"
    ) as error:
        at_measured(
            MatrixStructure([], [], lambda *_: (M, K), channels=channels, setups=["rig"], modes=2), ["rig"]
        )
    assert 'for setup "rig"' in error.value.where


# Derivatives of shapes -------------------------------------------------------------------------------------


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
    """A structure with motions without mass, of which all modes are asked for, or few."""
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
def test_derivatives_of_shapes_are_those_of_differences(n: int, still: int, few: bool) -> None:
    structure = parametric(n, still, few)
    values = np.array([0.2, 0.05])
    found = structure.predict(values, (0, 1), shape_rates=True)
    assert found.shape_rates is not None
    expected = differences(structure, values, np.array([1e-5, 1e-5]))
    assert found.shape_rates == pytest.approx(expected, abs=2e-6 * np.abs(expected).max())
    assert structure.predict(values, (1,), shape_rates=True).shape_rates == pytest.approx(
        found.shape_rates[..., 1:]
    )
    assert structure.predict(values, (0, 1)).shape_rates is None


def test_few_modes_have_the_derivatives_that_all_have() -> None:
    every, few = (
        parametric(40, 0, few).predict(np.zeros(2), (0, 1), shape_rates=True) for few in (False, True)
    )
    assert every.shape_rates is not None
    signs = np.sign((every.shapes[:, :4] * few.shapes).sum(axis=-1))[..., None, None]
    assert few.shape_rates == pytest.approx(every.shape_rates[:, :4] * signs, abs=1e-10)


@pytest.mark.parametrize("still", [False, True])
def test_derivatives_of_shapes_of_a_large_structure(still: bool) -> None:
    n = 240

    def matrices(values, setup) -> tuple[Any, Any]:
        k = 1e4 * np.ones(n)
        k[70:90] *= 1 + values["stiffer"]
        m = np.ones(n)
        if still:
            m[1::2] = 0.0
        m[101 if still else 100] += values["tip"]
        K = sparse.diags_array([k + np.append(k[1:], 0.0), -k[1:], -k[1:]], offsets=[0, 1, -1])
        return sparse.diags_array(m), K

    channels = [f"x{i}" for i in range(0, n, 7)]
    structure = MatrixStructure(
        CHANGES, [], matrices, channels=channels, coordinates=[f"x{i}" for i in range(n)], modes=6
    )
    values = np.array([0.1, 0.3])
    found = structure.predict(values, (0, 1), shape_rates=True).shape_rates
    expected = differences(structure, values, np.array([1e-4, 1e-4]))
    assert found == pytest.approx(expected, abs=1e-6 * np.abs(expected).max())


def test_shapes_of_coinciding_modes_turn_as_fast_as_the_limit_says() -> None:
    # Two equal masses on equal springs: a coupling c splits them, and turns their shapes at once.
    structure = MatrixStructure(
        [Parameter("c", 0.0)],
        [],
        lambda v, _: (np.eye(3), np.array([[4.0, v["c"], 0], [v["c"], 4.0 + 1e-9, 0], [0, 0, 9.0]])),
        channels=["a", "b", "c"],
    )
    found = structure.predict(np.zeros(1), (0,), shape_rates=True).shape_rates
    assert found is not None
    # phi_1 turns towards phi_2 by 1 / (lambda_1 - lambda_2), where the gap counts as 4e-6 instead of 1e-9.
    assert found[0, 0, :, 0] == pytest.approx([0.0, -1 / 4e-6, 0.0], rel=1e-6)
    assert found[0, 1, :, 0] == pytest.approx([1 / 4e-6, 0.0, 0.0], rel=1e-6)
    exact = MatrixStructure(
        [Parameter("c", 0.0)],
        [],
        lambda v, _: (np.eye(2), np.diag([v["c"], 0.0])),
        channels=["a", "b"],
        rigid=2,
    )
    assert np.isfinite(exact.predict(np.zeros(1), (0,), shape_rates=True).shape_rates).all()


@pytest.mark.parametrize("n", [30, 240])
def test_a_mode_that_coincides_with_the_first_one_left_out_turns_as_fast(n: int) -> None:
    level = np.concatenate([[1.0, 4.0, 4.0 + 1e-9], 10.0 + np.arange(n - 3)])

    def matrices(values, setup) -> tuple[Any, Any]:
        c = np.zeros(n - 1)
        c[1] = values["c"]
        return sparse.eye_array(n), sparse.diags_array([level, c, c], offsets=[0, 1, -1])

    structure = MatrixStructure(
        [Parameter("c", 0.0)], [], matrices, channels=[str(i) for i in range(n)], modes=2
    )
    found = structure.predict(np.zeros(1), (0,), shape_rates=True)
    assert found.shape_rates is not None
    # Which combination of the two counts as the second mode is open; only a turn of one by the other is left.
    assert np.abs(found.shape_rates[0, 1, :, 0]).max() <= 1.01 / 4e-6
    assert found.shape_rates[0, 1, [0, *range(3, n)], 0] == pytest.approx(0.0, abs=1e-9)


# What a callable may do wrong ------------------------------------------------------------------------------


def built(matrices: Any, **options: Any) -> MatrixStructure:
    return MatrixStructure(
        [Parameter("k", 1.0, upper=10.0), Parameter("m", 1.0)],
        [],
        matrices,
        **{"channels": ["a", "b"], "setups": ["rig"], **options},
    )


class Unusual:
    pass


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        (None, r"expected a pair \(M, K\), found NoneType"),
        (np.eye(2), r"expected a pair \(M, K\), found ndarray"),
        ((np.eye(2),), r"expected a pair \(M, K\), found tuple"),
        ((np.eye(2), np.eye(2), np.eye(2)), r"expected a pair \(M, K\), found tuple"),
        ((np.eye(2), Unusual()), "expected K of real numbers, found values of type object"),
        ((np.eye(2), [[1, 2], [3]]), "expected K as an array"),
        ((np.eye(2), [["a", "b"], ["c", "d"]]), "expected K of real numbers"),
        ((np.eye(2), np.eye(2) * (1 + 0.02j)), "expected K of real numbers, found complex numbers"),
        (
            (sparse.eye_array(2, dtype=complex), np.eye(2)),
            "expected M of real numbers, found complex numbers",
        ),
        ((np.eye(2), np.eye(3)), r"expected K of shape \(2, 2\) for 2 channels, found \(3, 3\)"),
        ((np.ones(2), np.eye(2)), r"expected M of shape \(2, 2\)"),
        ((sparse.eye_array(3), np.eye(2)), r"expected M of shape \(2, 2\)"),
        ((np.eye(2), np.eye(2, dtype=np.float32)), "expected K in double precision, found float32"),
        ((np.eye(2), np.array([[1.0, 0.2], [0.1, 1.0]])), "expected K finite and symmetric"),
        ((np.eye(2), sparse.csr_array([[1.0, 0.2], [0.1, 1.0]])), "expected K finite and symmetric"),
    ],
)
def test_a_wrong_answer_is_refused_with_setup_and_values_at_once_and_during_a_fit(
    returned: Any, message: str
) -> None:
    with pytest.raises(PkmodesError, match=message) as error:
        built(lambda *_: returned)
    assert error.value.where == 'matrices for setup "rig" at the declared values'
    later = built(lambda values, _: (np.eye(2), np.eye(2)) if values["k"] < 2 else returned)
    with pytest.raises(PkmodesError, match=message) as error:
        later.predict(np.array([3.0, 1.0]), (0,))
    assert error.value.where == 'matrices for setup "rig" at k = 3'


def test_an_exception_of_a_callable_is_an_error_that_names_the_values() -> None:
    def matrices(values, setup) -> tuple[Any, Any]:
        if values["k"] > 2.0:
            raise ValueError("beyond the table")
        return np.eye(2) * values["m"], np.eye(2)

    with pytest.raises(PkmodesError, match="failed: ValueError: beyond the table") as error:
        built(matrices).predict(np.array([2.5, 3.0]), ())
    assert error.value.where == 'matrices for setup "rig" at k = 2.5, m = 3'
    assert "narrow the bounds" in error.value.remedy
    assert isinstance(error.value.__cause__, ValueError)
    with pytest.raises(PkmodesError, match="ZeroDivisionError"):
        built(lambda values, _: 1 / 0)


def test_a_parameter_without_the_bounds_that_it_needs_is_no_parameter_without_effect() -> None:
    def matrices(values, setup) -> tuple[Any, Any]:
        with np.errstate(invalid="ignore"):
            return np.eye(2), np.diag([1.0, 2.0]) * (1.0 + np.sqrt(values["k"] - 1.0))

    structure = built(matrices)
    assert np.isfinite(structure.predict(np.array([1.5, 1.0]), (0,)).rates).all()
    with pytest.raises(PkmodesError, match="finite on both sides of k = 1") as error:
        structure.predict(np.array([1.0, 1.0]), (0,))
    assert "bounds" in error.value.remedy


@pytest.mark.parametrize("n", [3, 250])
def test_a_callable_may_use_its_arrays_again(n: int) -> None:
    M, K = np.eye(n), np.zeros((n, n))

    def matrices(values, setup) -> tuple[Any, Any]:
        K[np.diag_indices(n)] = values["k"] * np.arange(1, n + 1)
        return M, K

    found = built(matrices, channels=[str(i) for i in range(n)], modes=2).predict(np.array([3.0, 1.0]), (0,))
    assert found.rates[0, :, 0] == pytest.approx([1.0, 2.0])


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        ((np.eye(2), np.eye(3)), r"expected dK of shape \(2, 2\)"),
        (None, r"expected a pair \(dM, dK\)"),
        ((np.eye(2), np.full((2, 2), np.nan)), "expected dK finite and symmetric"),
        ((np.array([[0, 1], [0, 0]]), np.eye(2)), "expected dM finite and symmetric"),
        ((np.eye(2), 1j * np.eye(2)), "expected dK of real numbers"),
    ],
)
def test_wrong_derivatives_are_refused(returned: Any, message: str) -> None:
    structure = built(lambda *_: (np.eye(2), np.eye(2)), derivatives=lambda *_: returned)
    with pytest.raises(PkmodesError, match=message) as error:
        structure.predict(np.array([3.0, 1.0]), (0,))
    assert error.value.where == 'derivatives by "k", matrices for setup "rig" at k = 3'


def test_an_exception_of_the_derivatives_names_the_values() -> None:
    structure = built(lambda *_: (np.eye(2), np.eye(2)), derivatives=lambda v, s, name: {}[name])
    with pytest.raises(PkmodesError, match="dM and dK failed: KeyError") as error:
        structure.predict(np.array([1.0, 1.0]), (1,))
    assert 'derivatives by "m"' in error.value.where
