"""What an explanation predicts where a structure could be measured next, and how uncertain that is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helpers.robots.small_structures import SIGMA, LogLinear, each, log_linear, logs_measured
from pkmodes.loop.diagnosis import Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.verdict.elsewhere import (
    MeasuringCondition,
    PredictionElsewhere,
    explanation_distances,
    predict_elsewhere,
)

SETUPS, MODES = 6, 4
#: Standard deviations of the components of a position.
POSITION = np.array([0.5, 1.0, 2.0]) * SIGMA


def fitted(*, positions: bool = False) -> tuple[Fitter, Fit, LogLinear]:
    """A cause a and an uncertain value n, fitted to data with normal errors, and the structure elsewhere."""
    rng = np.random.default_rng(7)
    parameters = [Parameter("a", 0.0), Parameter("n", 0.0, sigma=0.01)]
    model = log_linear(rng, SETUPS, MODES, parameters, each("a"), positions=positions)
    there = log_linear(rng, 3, MODES, parameters, each("a"), positions=positions)
    y = model.base + model.G @ [0.03, 0.005] + SIGMA * rng.standard_normal(model.base.shape)
    point_sigma = np.tile(POSITION, (SETUPS, 1)) if positions else None
    fitter = Fitter(model, logs_measured(y, SIGMA, point_sigma))
    fit = fitter.fit(Hypothesis((model.candidates[0],)))
    assert fit is not None
    return fitter, fit, there


def linear(there: LogLinear, fit: Fit) -> np.ndarray:
    """Derivatives by the fitted values in standard deviations of a frequency."""
    return there.G[..., list(fit.free)] / SIGMA


def test_the_mean_is_of_the_fit_and_what_is_uncertain_is_known_in_part() -> None:
    fitter, fit, there = fitted()
    found = predict_elsewhere(fitter, MeasuringCondition(there, None, {}), fit)
    assert found.mean * SIGMA == pytest.approx(there.base + there.G @ fit.values)
    G, C = linear(there, fit), np.linalg.inv(fit.jacobian.T @ fit.jacobian)
    rest = found.covariance() - G @ C @ G.swapaxes(1, 2)
    assert rest == pytest.approx(rest[0, 0, 0] * np.broadcast_to(np.eye(MODES), rest.shape), abs=1e-9)
    # The data have errors as stated: the factor is near 1, and less is uncertain of it than the data alone say.
    assert 0.7 < rest[0, 0, 0] < 1.3
    k = fit.free.index(1)
    g, exact = np.delete(G, k, axis=2), 1.0 / np.linalg.inv(C)[1 - k, 1 - k]
    known = found.covariance(1) - exact * g @ g.swapaxes(1, 2)
    assert known == pytest.approx(rest, abs=1e-9)


def test_uncertain_positions_and_shared_errors_add_to_it() -> None:
    fitter, fit, there = fitted(positions=True)
    one = predict_elsewhere(fitter, MeasuringCondition(there, None, {}), fit)
    plain = predict_elsewhere(
        fitter, MeasuringCondition(LogLinear(there.base, there.G, there.parameters), None, {}), fit
    )
    assert there.B is not None
    B = there.B * POSITION / SIGMA
    assert one.errors - plain.errors == pytest.approx(B @ B.swapaxes(1, 2))
    shared = predict_elsewhere(
        fitter, MeasuringCondition(there, None, {}), replace(fit, shared_error=3.0 * SIGMA)
    )
    assert shared.errors - one.errors == pytest.approx(np.full(one.errors.shape, 9.0))


def test_a_load_that_an_explanation_is_about_leaves_it_without_a_prediction() -> None:
    fitter, fit, there = fitted()
    overridden, other = (
        predict_elsewhere(fitter, MeasuringCondition(there, None, {name: 0.1}), fit) for name in ("a", "load")
    )
    assert np.isnan(overridden.mean).all()
    assert np.isfinite(other.mean).all()
    distances, _, overlaps = explanation_distances([overridden, other], range(3))
    assert not distances.any()
    assert (overlaps == 1.0).all()


def test_explanations_are_compared_in_the_modes_that_both_have() -> None:
    fitter, fit, there = fitted()
    one = predict_elsewhere(fitter, MeasuringCondition(there, None, {}), fit)
    fewer = PredictionElsewhere(fit, one.mean[:, :2] + 3.0, one.rates[:, :2], one.errors[:, :2, :2])
    both = PredictionElsewhere(fit, one.mean[:, :2], one.rates[:, :2], one.errors[:, :2, :2])
    assert np.array_equal(
        explanation_distances([one, fewer], [1])[0], explanation_distances([both, fewer], [1])[0]
    )
