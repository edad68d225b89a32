"""Rough fits in lockstep converge as single ones do; robots evaluated together give the same modes."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import lsq_linear

from helpers.diagnoses.robot_structures import declared, index, suspected
from helpers.robots.small_structures import SIGMA, LogLinear, each, log_linear, logs_measured
from pkmodes.loop.diagnosis import Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.solver import bounded_least_squares
from pkmodes_rig.robots import POSES, ROBOTS, read

SETUPS, MODES = 8, 5


def test_a_descent_converges_to_bounded_least_squares_of_a_linear_model() -> None:
    """Against SciPy's solver of the linear problem, with active bounds."""
    rng = np.random.default_rng(1)
    candidates = each(f"c{i}" for i in range(6))
    parameters = [Parameter("n0", 0.0, sigma=0.5), Parameter("n1", 0.0, sigma=0.5)]
    parameters += [Parameter(f"c{i}", 0.0, lower=0.0 if i % 2 else -np.inf) for i in range(6)]
    model: LogLinear = log_linear(rng, SETUPS, MODES, parameters, candidates)
    logs = model.base + model.G @ np.array([0.02, -0.01, 0.0, -0.004, 0.006, 0.0, 0.0, 0.002])
    data = logs_measured(logs + SIGMA * rng.standard_normal(logs.shape), SIGMA)
    fitter = Fitter(model, data)
    descents = fitter.rough_descents([(Hypothesis((c,)), fitter.declared) for c in candidates])
    for i, descent in enumerate(descents):
        columns = [0, 1, 2 + i]
        design = np.vstack([model.G.reshape(-1, 8)[:, columns] / SIGMA, np.diag([2.0, 2.0, 0.0])[:2]])
        target = np.concatenate([(np.log(data.frequency) - model.base.ravel()) / SIGMA, [0.0, 0.0]])
        lower = [-np.inf, -np.inf, parameters[2 + i].lower]
        expected = lsq_linear(design, target, (lower, [np.inf] * 3), tol=1e-12)
        assert descent.converged
        # It has arrived where a step promises less than 0.05 or a thousandth.
        assert descent.chi2 == pytest.approx(2.0 * expected.cost, abs=0.1, rel=2e-3)
        assert descent.values[2 + i] == pytest.approx(expected.x[2], abs=1e-4)


@pytest.mark.parametrize("name", sorted(ROBOTS))
def test_robots_evaluated_together_are_those_evaluated_alone(name: str) -> None:
    """Values in every candidate's direction, geometry and measurement frame included, with their derivatives."""
    robot, points = read(name), POSES[name]["scattered"][:3]
    structure = suspected(robot, points)
    values, by = [], []
    for candidate in structure.candidates:
        some, one = [index(structure, parameter) for parameter in candidate.parameters], declared(structure)
        one[some] += 0.01 * np.maximum(np.abs(one[some]), 1e-4)
        values.append(one)
        by.append(some)
    batches = structure.predict_many(np.array(values), by, shape_rates=True)
    assert sorted(int(k) for batch in batches for k in batch.sets) == list(range(len(values)))
    assert max(len(batch.sets) for batch in batches) > 10
    for batch in batches:
        for place, k in enumerate(batch.sets):
            alone = suspected(robot, points).predict(values[k], by[k], shape_rates=True)
            part = slice(place * len(points), (place + 1) * len(points))
            together, width = batch.prediction, len(by[k])
            # The same operations on other batches: rounding, and for shapes rounding over the gaps of eigenvalues.
            np.testing.assert_allclose(together.eigenvalues[part], alone.eigenvalues, rtol=1e-10, atol=1e-3)
            np.testing.assert_allclose(together.shapes[part], alone.shapes, rtol=0, atol=1e-7)
            size = np.abs(alone.rates).max()
            np.testing.assert_allclose(together.rates[part][..., :width], alone.rates, atol=1e-7 * size)
            assert not together.rates[part][..., width:].any()
            assert alone.shape_rates is not None
            assert together.shape_rates is not None
            size = np.abs(alone.shape_rates).max()
            np.testing.assert_allclose(
                together.shape_rates[part][..., :width], alone.shape_rates, atol=1e-5 * size
            )


def test_a_parameter_that_the_data_hardly_see_stays_within_its_bounds() -> None:
    """Its standard deviation is so many times its range that in units of it both bounds are one number."""
    tiny = 1e-25
    values, _ = bounded_least_squares(
        lambda v: np.array([v[0] - 1.0, tiny * v[1]]),
        lambda v: np.diag([1.0, tiny]),
        np.array([0.0, 0.5]),
        (0, 1),
        (np.array([-np.inf, 0.0]), np.array([np.inf, 1.0])),
        100,
    )
    assert values[0] == pytest.approx(1.0, abs=1e-2)
    assert 0.0 <= values[1] <= 1.0


def test_a_small_value_that_the_data_do_not_see_is_not_rounded_to_nothing() -> None:
    """Such as the mass of a resonator far above all modes: with none there is no model."""

    def residual(v: np.ndarray) -> np.ndarray:
        there = 0.0 < v[1] < 1e6
        return np.array([v[0] - 1.0, 0.0 if there else np.nan])

    values, converged = bounded_least_squares(
        residual,
        lambda v: np.diag([1.0, 1e-25]),
        np.array([0.0, 1e-7]),
        (0, 1),
        (np.array([-np.inf, 0.0]), np.array([np.inf, np.inf])),
        100,
    )
    assert converged
    assert values[0] == pytest.approx(1.0, abs=1e-2)
