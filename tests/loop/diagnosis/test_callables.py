"""Errors of a callable for matrices, and how often it is called."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy import sparse

from helpers.robots.small_structures import altered, frame, frame_matrices, frame_measured
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import MatrixStructure, Parameter, diagnose
from pkmodes.loop.diagnosis.structure.cache import ResultCache


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


def test_a_parameter_without_the_bounds_that_it_needs_is_not_taken_for_one_without_effect() -> None:
    def matrices(values, setup) -> tuple[Any, Any]:
        with np.errstate(invalid="ignore"):
            return np.eye(2), np.diag([1.0, 2.0]) * (1.0 + np.sqrt(values["k"] - 1.0))

    structure = built(matrices)
    assert np.isfinite(structure.predict(np.array([1.5, 1.0]), (0,)).rates).all()
    with pytest.raises(PkmodesError, match="finite on both sides of k = 1") as error:
        structure.predict(np.array([1.0, 1.0]), (0,))
    assert "bounds" in error.value.remedy


@pytest.mark.parametrize("n", [3, 60])
def test_a_callable_may_reuse_its_arrays(n: int) -> None:
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
    assert error.value.where == 'derivatives with respect to "k", matrices for setup "rig" at k = 3'


def test_an_exception_of_the_derivatives_names_the_values() -> None:
    structure = built(lambda *_: (np.eye(2), np.eye(2)), derivatives=lambda v, s, name: {}[name])
    with pytest.raises(PkmodesError, match="dM and dK failed: KeyError") as error:
        structure.predict(np.array([1.0, 1.0]), (1,))
    assert 'derivatives with respect to "m"' in error.value.where


# Number of calls -------------------------------------------------------------------------------------------


def counted(calls: list[tuple[Any, ...]]) -> Callable:
    """The matrices of a frame, with every call recorded."""
    matrices = frame_matrices(4, {"a": 0.0, "b": 3.0})

    def asked(values: Any, setup: str) -> Any:
        calls.append((*values.values(), setup))
        return matrices(values, setup)

    return asked


def test_a_diagnosis_evaluates_the_same_values_once() -> None:
    loads, calls = {"a": 0.0, "b": 3.0}, list[tuple[Any, ...]]()
    structure = altered(frame(loads), counted(calls))
    data = frame_measured(loads, {"brace 2": 9e4}, np.random.default_rng(0), shapes=0.01)
    result = diagnose(structure, data)
    assert result.verdict == "effect_found"
    assert len(calls) == len(set(calls)) + 1  # the declared values once more: are they repeatable?


@pytest.mark.parametrize(("power", "expected"), [(1, 1 + 2), (3, 1 + 3)])
@pytest.mark.parametrize("declared", [1.0, 0.5])
def test_one_call_is_enough_for_the_derivative_if_the_matrices_are_linear_in_a_parameter(
    power: int, expected: int, declared: float
) -> None:
    calls = list[float]()

    def matrices(values: Any, setup: str) -> tuple[np.ndarray, np.ndarray]:
        assert values["k"] >= 0.5
        calls.append(values["k"])
        return values["m"] * np.eye(1), np.array([[1.0 + values["k"] ** power]])

    structure = MatrixStructure(
        [Parameter("k", declared, lower=0.5), Parameter("m", 1.0)], [], matrices, channels=["a"]
    )
    structure.predict(np.array([declared, 1.0]), (0, 1))
    calls.clear()
    found = structure.predict(np.array([3.0, 2.0]), (0, 1))
    assert len(calls) == expected
    K = 1.0 + 3.0**power
    assert found.rates[0, 0] == pytest.approx([power * 3.0 ** (power - 1) / 2, -K / 4], rel=1e-8)


@pytest.mark.parametrize("slow", [False, True])
def test_progress_says_when_the_callable_dominates_the_time(
    slow: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = itertools.count(0.0, 0.25 if slow else 1e-4)
    monkeypatch.setattr("pkmodes.loop.diagnosis.structure.supplied.time.perf_counter", lambda: next(clock))
    loads, said = {"empty": 0.0, "loaded": 5.0}, list[str]()
    diagnose(frame(loads), frame_measured(loads, {}, np.random.default_rng(0)), progress=said.append)
    text = "each call for the matrices takes 0.25 s: a few hundred calls dominate the computing time"
    assert (said[0] == text) == slow
    assert len(said) == 1 + slow


def test_derivatives_are_evaluated_once_too() -> None:
    calls = list[str]()

    def derivatives(values: Any, setup: str, name: str) -> tuple[np.ndarray, np.ndarray]:
        calls.append(name)
        return np.zeros((2, 2)), np.eye(2)

    structure = built(lambda v, _: (np.eye(2), (2.0 + v["k"]) * np.eye(2)), derivatives=derivatives)
    for values in ([1.0, 1.0], [2.0, 1.0], [1.0, 1.0]):
        assert (structure.predict(np.array(values), (0,)).rates == 1.0).all()
    assert calls == ["k", "k"]


def test_the_least_recently_used_value_is_dropped() -> None:
    kept = ResultCache[str](max_memory=10)
    for key in "abc":
        assert kept.keep(key, key.upper(), 4) == key.upper()
        assert kept["a" if key < "c" else "c"]
    assert [key in kept for key in "abc"] == [True, False, True]
    kept.keep("a", "again", 6)
    assert kept["a"] == "again"
    assert "c" in kept  # 10 in all
    kept.keep("large", "LARGE", 100)
    assert [key in kept for key in ("a", "c", "large")] == [False, False, True]
    kept.keep("small", "SMALL", 1)
    assert [key in kept for key in ("large", "small")] == [False, True]


# Reproducibility -------------------------------------------------------------------------------------------


def noisy(noise: float, exact: bool) -> MatrixStructure:
    """K with an error of this size; with or without derivatives."""
    rng = np.random.default_rng(3)

    def matrices(values: Any, setup: str) -> tuple[np.ndarray, np.ndarray]:
        return np.eye(2), np.diag([values["k"], 2.0]) * (1.0 + noise * rng.uniform())

    derivatives = (lambda *_: (np.zeros((2, 2)), np.diag([1.0, 0.0]))) if exact else None
    return built(matrices, derivatives=derivatives)


@pytest.mark.parametrize(("noise", "exact"), [(1e-6, False), (1e-7, False), (1e-4, True)])
def test_a_callable_that_is_not_repeatable_is_refused(noise: float, exact: bool) -> None:
    with pytest.raises(PkmodesError, match=r"differ by .* between two calls with the same values") as error:
        noisy(noise, exact)
    assert error.value.where == 'matrices for setup "rig" at the declared values'
    assert error.value.remedy == "fix the seed or tighten the solver behind them"


@pytest.mark.parametrize(("noise", "exact"), [(1e-10, False), (1e-7, True)])
def test_negligible_differences_between_calls_are_accepted(noise: float, exact: bool) -> None:
    found = noisy(noise, exact).predict(np.array([1.0, 1.0]), (0,))
    assert found.rates[0, :, 0] == pytest.approx([1.0, 0.0], abs=1e-3)
