"""Causes with bounds: fits stay within them, reach them, and start from the absence of a cause."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.references.textbook_fits import (
    CAUSES,
    DECLARED,
    PARAMETERS,
    PRIORS,
    SIGMA,
    fitted,
    least_squares,
    simulated,
    structure,
)
from helpers.robots.small_structures import LogLinear, logs_measured
from pkmodes.loop.diagnosis import Parameter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.updating.candidates import suspects

ROBOT = Path(__file__).parents[3] / "robots/clavel-delta.toml"


def bounded(lower: float, upper: float, value: float) -> tuple[LogLinear, Hypothesis]:
    parameters = (*PARAMETERS[:2], Parameter("u", value, lower=lower, upper=upper), PARAMETERS[3])
    model = structure(7)
    return LogLinear(model.base, model.G, parameters, CAUSES), Hypothesis(CAUSES[:1])


@pytest.mark.parametrize(
    ("lower", "upper", "value", "true", "reached", "named"),
    [
        (0.0, np.inf, 0.0, -0.5, 0.0, ()),  # stays absent, which is no sign of a wrong cause
        (0.0, 0.3, 0.0, 0.8, 0.3, ("u",)),
        (-0.3, 0.0, 0.0, 0.8, 0.0, ()),
        (-0.3, 0.3, 0.0, -0.8, -0.3, ("u",)),
        (0.1, 3.0, 0.5, -0.8, 0.1, ("u",)),
        (0.5, 3.0, 0.5, -0.8, 0.5, ()),
        (0.0, 3.0, 0.5, 1.2, None, ()),
    ],
)
def test_bounds_hold_and_are_named_unless_the_cause_is_absent_there(
    lower: float, upper: float, value: float, true: float, reached: float | None, named: tuple[str, ...]
) -> None:
    model, hypothesis = bounded(lower, upper, value)
    y = simulated(model, np.array([0.3, -1.0, true, 0.5]), 7)
    found = fitted(model, logs_measured(y, SIGMA), hypothesis)
    assert lower <= found.values[2] <= upper
    assert found.values[2] == pytest.approx(
        true if reached is None else reached, abs=0.1 if named == () else 1e-3
    )
    assert found.at_bound == named
    if reached is not None:  # what remains is a fit of the others with u held there
        G, left = model.G.reshape(-1, 4), (y - model.base).ravel()
        held = G[:, 2] * reached + G[:, 3] * 0.5
        expected = least_squares(G[:, :2], left - held, SIGMA**2 * np.eye(20), DECLARED[:2], PRIORS)
        assert found.values[:2] == pytest.approx(expected[0], rel=1e-3)
        assert found.chi2 == pytest.approx(expected[2], rel=1e-3)


def test_a_single_cause_is_found_starting_from_its_absence() -> None:
    parameters = (
        *(Parameter(p.name, p.value) for p in PARAMETERS[:2]),
        Parameter("u", 0.0, lower=0.0),
        PARAMETERS[3],
    )
    model = structure(8)
    model = LogLinear(model.base, model.G, parameters, CAUSES)
    y = simulated(model, np.array([0.3, -1.0, 0.8, 0.5]), 8)
    found = fitted(model, logs_measured(y, SIGMA), Hypothesis(CAUSES[:1]))
    G, left = model.G.reshape(-1, 4), (y - model.base).ravel()
    held = G[:, [0, 1, 3]] @ [0.3, -1.0, 0.5]
    values, covariance, _ = least_squares(G[:, [2]], left - held, SIGMA**2 * np.eye(20), np.zeros(1), [None])
    assert found.values[2] == pytest.approx(values[0], abs=1e-3 * np.sqrt(covariance[0, 0]))


def test_a_declared_value_is_sought_within_a_factor_of_three_and_an_element_of_a_vector_as_far() -> None:
    """A cause at its bound is not claimed: gravity far from that of the Earth never is."""
    robot = pkmodes.read_robot(ROBOT)
    by_name = {p.name: p for p in suspects(robot)[0]}
    gravity, mass = by_name["gravity.z"], by_name["link.mass"]
    assert (gravity.lower, gravity.upper) == pytest.approx((-3.0 * 9.81, 9.81), rel=1e-3)
    assert (mass.lower, mass.upper) == pytest.approx((mass.value / 3.0, 3.0 * mass.value))
    middle = by_name["axis.1.origin.y"]
    assert middle.upper - middle.value == pytest.approx(2.0 * 0.11)
