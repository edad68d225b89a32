"""What a result says of values, classes and rows beside the verdict: bounds, names, errors of positions, MAC."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eigh

from helpers.robots.small_structures import (
    LOADS,
    MASS,
    SIGMA,
    STIFFNESS,
    directions,
    errors,
    frame,
    frame_matrices,
    frame_measured,
    log_linear,
    logs_measured,
    of_signatures,
    with_changes,
)
from pkmodes.loop.diagnosis import Candidate, Diagnosis, Measurements, Parameter, diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Structure
from pkmodes.loop.diagnosis.verdict import limits
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.builder import DiagnosisBuilder

SETUPS, MODES = 10, 5
DIRECTIONS = directions(SETUPS * MODES, 2)


def all_setups(model: Structure, data: Measurements) -> AllSetups:
    return AllSetups(model, data, Fitter(model, data), [])


@pytest.mark.parametrize(
    ("parameter", "value", "reached"),
    [
        (Parameter("u", 0.0, lower=0.0), 0.0, False),  # its absence
        (Parameter("u", 0.0, lower=0.0, upper=0.3), 0.3, True),
        (Parameter("u", 0.0, lower=-0.3, upper=0.3), -0.3, True),
        (Parameter("u", 0.0, lower=0.0, upper=0.3), 0.29, False),
        (Parameter("u", 0.5, lower=0.1), 0.1, True),
        (Parameter("u", 0.5, lower=0.5), 0.5, False),
        # A thousandth of its prior is nothing beside it.
        (Parameter("u", 0.02, sigma=5.0, lower=0.0), 0.004, True),
        (Parameter("u", 0.02, sigma=1.0, lower=0.0), 0.004, False),
    ],
)
def test_a_corrected_value_is_at_a_bound_only_where_it_was_not_declared_there(
    parameter: Parameter, value: float, reached: bool
) -> None:
    model = log_linear(np.random.default_rng(1), 4, 3, [parameter], [Candidate("u", ("u",))])
    setups = all_setups(model, logs_measured(model.base, SIGMA))
    nuisance = parameter.sigma is not None
    fit = setups.fitter.fit(Hypothesis(() if nuisance else model.candidates))
    assert fit is not None
    (corrected,) = DiagnosisBuilder(setups).corrected_values(
        replace(fit, values=np.array([value])),
        limits.unknown_limits(FitStore(setups.fitter), model.candidates),
    )
    assert (corrected.value, corrected.declared) == (value, parameter.value)
    assert corrected.at_bound is reached


#: Two causes of nearly the same effect, and one without any.
ALIKE = {
    "a": DIRECTIONS[0],
    "like a": (DIRECTIONS[0] + 0.02 * DIRECTIONS[1]) / np.hypot(1.0, 0.02),
    "nothing": 0.0 * DIRECTIONS[0],
}


def found(remote: str, cause: str) -> Diagnosis:
    """The diagnosis of a change of 30 standard deviations by one of them."""
    model = of_signatures(ALIKE, SETUPS, MODES, roles={remote: {"remote": True}})
    changes = 30.0 * ALIKE[cause] + errors(SETUPS * MODES, DIRECTIONS)
    return diagnose(model, with_changes(model, changes), holdout=())


def test_a_class_begins_with_its_cause() -> None:
    """The residual is exactly what a remote cause does, but the plain one is claimed."""
    (effect,) = found("like a", "like a").effects
    assert effect.name == "a"
    assert effect.members == ("a", "like a")
    assert list(effect.alternatives) == ["a", "like a"]


def test_what_is_listed_in_the_class_of_a_cause_is_not_called_undetectable() -> None:
    """Beside the one, no change by its double could be seen."""
    diagnosis = found("", "a")
    (effect,) = diagnosis.effects
    assert set(effect.members) == {"a", "like a"}
    assert diagnosis.undetectable == ("nothing",)


def test_errors_of_positions_add_to_those_of_the_frequencies() -> None:
    """Independent errors: their variances add, those of the components too."""
    model = log_linear(np.random.default_rng(4), 3, 2, [Parameter("u", 0.0)], positions=True)
    assert model.B is not None
    spread = np.array([[0.0, 0.0, 0.0], [0.001, 0.0, 0.002], [0.003, 0.001, 0.0]])
    data = logs_measured(model.base, SIGMA, spread)
    sigma = all_setups(model, data).stage(np.zeros(1)).sigma.reshape(3, 2)
    for i in range(3):
        for k in range(2):
            parts = [SIGMA, *(model.B[i, k] * spread[i])]
            assert sigma[i, k] == pytest.approx(np.sqrt(np.sum(np.square(parts))), rel=1e-12)


def test_the_mac_of_a_row_is_that_of_the_last_stage() -> None:
    truth = {"brace 2": 0.8 * STIFFNESS}
    data = frame_measured(LOADS, truth, np.random.default_rng(5), shapes=0.01)
    model = frame(LOADS)
    setups = all_setups(model, data)
    values = {p.name: p.value for p in model.parameters}
    changes = ({}, {"storey": 1.1 * STIFFNESS, "mass": 0.9 * MASS}, truth)
    stages = [setups.stage(np.array([*(values | change).values()])) for change in changes]

    def mac(change: Mapping[str, float]) -> list[float]:
        """Of each measured shape with the shape of the same number, by SciPy's solver.

        Channels count in units of their motion in the declared model: with a diagonal M, the root of their mass.
        """
        found = []
        for i, setup in enumerate(LOADS):
            matrices = frame_matrices(4, LOADS)
            weights = np.sqrt(np.diag(matrices(values, setup)[0]))
            M, K = matrices(values | change, setup)
            for row, mode in zip(
                data.shapes[data.pose == i] * weights, eigh(K, M)[1].T * weights, strict=True
            ):
                found.append((row @ mode) ** 2 / (row @ row) / (mode @ mode))
        return found

    outlying = np.zeros(len(data.lines), dtype=bool)
    assert max(abs(np.subtract(mac(changes[0]), mac(changes[2])))) > 0.01
    for count in (1, 2, 3):
        given = [*stages[:count], None, None][:3]
        declared, refit, after = given
        assert declared is not None
        rows = setups.rows(declared, refit, after, outlying)
        assert [row.mac for row in rows] == pytest.approx(mac(changes[count - 1]), abs=1e-9), count
