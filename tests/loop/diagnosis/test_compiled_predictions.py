"""Predictions of robots from the compiled evaluator: those of NumPy, values and all derivatives."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.robot_structures import declared, index, suspected
from pkmodes import read_robot
from pkmodes.loop.diagnosis import Prediction
from pkmodes.loop.updating.robot_structure import RobotStructure

pytestmark = pytest.mark.compiler

ROBOTS = Path(__file__).parents[3] / "robots"
#: Poses, and an effect that releases joints, which the second set of values has.
CASES = {
    "linear-delta-2022": (
        [[0.6, 0.02, -0.245], [0.5, 0.05, -0.245], [0.71, -0.04, -0.24]],
        "clamp_compliance",
    ),
    "clavel-delta": ([[0.01, 0.05, -0.7], [0.02, -0.03, -0.65], [0.1, 0.02, -0.6]], "link_compliance"),
    "corexy-printer": ([[0.1, 0.2], [0.15, 0.05], [0.22, 0.11]], "belt_end_compliance"),
}
#: Of the largest: both solvers err by rounding of the largest eigenvalue, and close modes lose digits of shapes.
EIGENVALUE, RATE, SHAPE, CANCELLED = 1e-9, 1e-8, 1e-6, 1e-9


def structure_of(name: str) -> RobotStructure:
    return suspected(read_robot(ROBOTS / f"{name}.toml"), np.array(CASES[name][0]))


def sets_of(one: RobotStructure, name: str) -> tuple[np.ndarray, list[list[int]]]:
    """Declared values, and with slightly other masses and released joints; some of the paths, and all."""
    values = np.tile(declared(one), (4, 1))
    values[1] *= 1.001
    values[2:, index(one, f"effects.{CASES[name][1]}.compliance")] = 1e-6, 2e-6
    # The compliances of locked joints are differentiated robot by robot.
    some = [i for i, p in enumerate(one.parameters) if not p.name.endswith("compliance")][:6]
    return values, [some, some, some[:3], some]


def assert_same(found: Prediction, expected: Prediction) -> None:
    rigid = expected.rigid
    assert found.rigid == rigid
    for one, other, limit in (
        (found.eigenvalues, expected.eigenvalues, EIGENVALUE),
        (found.rates, expected.rates, RATE),
        (np.abs(found.shapes), np.abs(expected.shapes), SHAPE),
        (np.abs(np.asarray(found.shape_rates)), np.abs(np.asarray(expected.shape_rates)), SHAPE),
    ):
        one, other = one[:, rigid:], other[:, rigid:]
        # Of each path; some change nothing but a common factor, and leave the rounding of terms that cancel.
        over = tuple(range(max(other.ndim - 1, 1)))
        largest = np.abs(other).max(axis=over, keepdims=True)
        assert (np.abs(one - other) <= limit * largest + CANCELLED).all()


@pytest.mark.parametrize("name", CASES)
def test_values_and_derivatives_are_those_of_numpy(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    predictions = []
    for backend in ("numpy", "compiled"):
        monkeypatch.setenv("PKMODES_BACKEND", backend)
        one = structure_of(name)
        values, by = sets_of(one, name)
        every = list(range(len(one.parameters)))
        batches = one.predict_many(values, by, shape_rates=True)
        assert sorted(k for batch in batches for k in batch.sets.tolist()) == [0, 1, 2, 3]
        single = [one.predict(v, every, shape_rates=True) for v in values]
        predictions.append([*single, *(batch.prediction for batch in batches)])
    for found, expected in zip(*predictions[::-1], strict=True):
        assert_same(found, expected)


def test_values_out_of_reach_are_evaluated_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    names = []
    for backend in ("numpy", "compiled"):
        monkeypatch.setenv("PKMODES_BACKEND", backend)
        one = structure_of("linear-delta-2022")
        values = np.tile(declared(one), (3, 1))
        values[1, index(one, "link.length")] = 0.05
        batches = one.predict_many(values, [()] * 3)
        finite = {k: np.isfinite(b.prediction.eigenvalues).all() for b in batches for k in b.sets.tolist()}
        names.append((sorted(len(batch.sets) for batch in batches), finite))
    assert names[0] == names[1] == ([1, 2], {0: True, 1: False, 2: True})


def test_a_structure_that_has_predicted_is_pickled() -> None:
    one = structure_of("corexy-printer")
    values = declared(one)
    first = one.predict(values, [0])
    again = pickle.loads(pickle.dumps(one)).predict(values, [0])
    np.testing.assert_array_equal(again.rates, first.rates)
