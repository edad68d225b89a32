"""Arguments of structures given by callables that contradict each other are refused; rounding is not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Parameter


def build(**changes: Any) -> MatrixStructure:
    given: dict[str, Any] = {
        "parameters": [Parameter("k", 1.0, sigma=0.1), Parameter("c", 0.0, lower=0.0)],
        "candidates": [Candidate("c", ("c",))],
        "matrices": lambda values, setup: (np.eye(2), np.eye(2)),
        "channels": ["a", "b"],
        "setups": ["A", "B"],
    } | changes
    return MatrixStructure(**given)


def constant(M: Any, K: Any) -> Callable:
    return lambda values, setup: (M, K)


CONTRADICTORY = [
    (
        {"matrices": constant(np.eye(3), np.eye(3))},
        r"expected M of shape \(2, 2\) for 2 channels, found \(3, 3\)",
    ),
    (
        {"matrices": constant(np.eye(2), np.ones(2))},
        r"expected K of shape \(2, 2\) for 2 channels, found \(2,\)",
    ),
    ({"channels": ["a"]}, r"expected M of shape \(1, 1\) for 1 channels"),
    ({"matrices": constant(np.eye(2), [[1.0, 0.1], [0.2, 1.0]])}, "expected K finite and symmetric"),
    ({"matrices": constant([[1.0, 0.1], [-0.1, 1.0]], np.eye(2))}, "expected M finite and symmetric"),
    ({"matrices": constant(np.eye(2), [[np.nan, 0.0], [0.0, 1.0]])}, "expected K finite"),
    ({"matrices": constant([[np.inf, 0.0], [0.0, 1.0]], np.eye(2))}, "expected M finite"),
    ({"matrices": constant(np.zeros((2, 2)), np.eye(2))}, "expected some mass"),
    ({"matrices": constant(np.diag([1.0, -1.0]), np.eye(2))}, "expected M positive definite"),
    ({"matrices": constant([[1.0, 2.0], [2.0, 1.0]], np.eye(2))}, "expected M positive definite"),
    (
        {"candidates": [Candidate("c", ("d",))]},
        r'its parameter "d" does not exist.*parameters are: k, c',
    ),
    ({"candidates": [Candidate("c", ())]}, "expected different parameters"),
    ({"candidates": [Candidate("c", ("c", "c"))]}, "expected different parameters"),
    ({"candidates": [Candidate("k", ("k",))]}, "refitted under every hypothesis"),
    ({"candidates": [Candidate("c", ("c",)), Candidate("c", ("c",))]}, 'two candidates are called "c"'),
    (
        {"parameters": [Parameter("k", 1.0), Parameter("c", 0.0), Parameter("c", 1.0)]},
        'two parameters .* "c"',
    ),
    ({"channels": ["a", "a"]}, 'two channels are called "a"'),
    ({"setups": ["A", "A"]}, 'two setups are called "A"'),
    (
        {"parameters": [Parameter("c", -1.0, lower=0.0)]},
        "expected lower <= value <= upper, found 0, -1, inf",
    ),
    ({"parameters": [Parameter("c", np.nan)]}, "expected lower <= value <= upper"),
    ({"parameters": [Parameter("c", 0.0, lower=0.0, upper=0.0)]}, "expected lower <= value <= upper"),
    ({"parameters": [Parameter("c", 0.0, sigma=-1.0)]}, "expected a standard deviation of at least 0"),
    ({"parameters": [Parameter("c", 0.0, sigma="1 mm")]}, "expected a number"),
]


def test_contradictory_arguments_are_refused(subtests: pytest.Subtests) -> None:
    for changes, message in CONTRADICTORY:
        with subtests.test(message=message):
            with pytest.raises(PkmodesError, match=message) as error:
                build(**changes)
            assert "; " in str(error.value)  # what to do about it


def test_a_value_known_exactly_is_not_a_suspect() -> None:
    with pytest.raises(PkmodesError, match="known exactly"):
        build(parameters=[Parameter("c", 0.0, sigma=0.0)])


def test_rounding_does_not_make_matrices_unsymmetric_or_masses_negative() -> None:
    K = np.array([[1e6, 1e-11], [0.0, 2e6]])  # two terms that cancel in one triangle only
    assert build(matrices=constant(np.eye(2), K)).channels == ("a", "b")
    M = np.array([[1e3, 0.5e-7], [0.5e-7, 1e-17]])  # a mass and a small inertia, coupled by a half
    assert build(matrices=constant(M, np.eye(2))).channels == ("a", "b")
