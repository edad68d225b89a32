"""Priors of candidates, log-normal and correlated ones, against textbook formulas and Bayes' rule."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.robot_structures import declared
from helpers.robots.robot_text import published
from helpers.robots.small_structures import (
    SIGMA,
    LogLinear,
    log_linear,
    logs_measured,
    of_signatures,
    with_changes,
)
from pkmodes import read_robot
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Candidate, Measurements, Parameter, diagnose
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.damping.fit import LossFitter
from pkmodes.loop.diagnosis.damping.observations import DampingObservations
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.priors import Priors
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Loss
from pkmodes.loop.updating.measured_robot import MeasuredRobot


def structure(sigma: tuple[float, ...] | None, *, seed: int = 3, log: bool = False) -> LogLinear:
    parameters = [Parameter("n", 0.0, sigma=2.0), Parameter("c", 1.0, lower=0.01, log=log)]
    found = log_linear(np.random.default_rng(seed), 4, 4, parameters, [Candidate("c", ("c",), sigma=sigma)])
    found.G *= SIGMA
    return found


def test_a_prior_of_a_candidate_pulls_its_value_as_in_bayes_rule() -> None:
    model = structure((1.5,))
    y = model.base + model.G @ [0.5, 4.0]
    fitter = Fitter(model, logs_measured(y, SIGMA))
    fit = fitter.fit(Hypothesis(model.candidates))
    assert fit is not None
    J = np.vstack([model.G.reshape(-1, 2) / SIGMA, np.diag([1 / 2.0, 1 / 1.5])])
    right = np.concatenate([((y - model.base) / SIGMA).ravel(), [0.0, 1.0 / 1.5]])
    expected, squares, *_ = np.linalg.lstsq(J, right, rcond=None)
    assert fit.values == pytest.approx(expected, rel=1e-6)
    assert fit.chi2 == pytest.approx(float(squares[0]), rel=1e-6)
    assert fit.covariance == pytest.approx(np.linalg.inv(J.T @ J), rel=1e-6)


def test_its_penalty_is_the_narrowing_by_the_data() -> None:
    """Laplace's approximation of the evidence: the prior's volume over the posterior's."""
    for sigma in (0.01, 1.5, 100.0):
        model = structure((sigma,))
        fitter = Fitter(model, logs_measured(model.base, SIGMA))
        store = FitStore(fitter)
        fit = store.fit(Hypothesis(model.candidates))
        assert fit is not None
        J = np.vstack([model.G.reshape(-1, 2) / SIGMA, np.diag([1 / 2.0, 1 / sigma])])
        posterior = np.linalg.inv(J.T @ J)[1, 1]
        assert store.criterion(fit) - fit.deviance == pytest.approx(np.log(sigma**2 / posterior), rel=1e-4)


def test_a_narrow_prior_ranks_a_cause_behind_one_that_may_be_as_large() -> None:
    """Two candidates with nearly the same signature: the one whose prior allows the size is preferred."""
    rng = np.random.default_rng(5)
    g = rng.standard_normal((4, 4))
    other = g + 0.15 * rng.standard_normal((4, 4))

    def best(**sigmas: float) -> str:
        roles = {name: {"sigma": (sigma,)} for name, sigma in sigmas.items()}
        model = of_signatures({"wide": g, "narrow": other}, 4, 4, roles=roles)
        found = diagnose(model, with_changes(model, 6.0 * (g + other)), holdout=())
        return found.effects[0].name if found.effects else found.survivors[0][0]

    assert best(wide=10.0, narrow=1.0) == "wide"
    assert best(wide=1.0, narrow=10.0) == "narrow"


def test_a_log_normal_prior_counts_ratios() -> None:
    parameters = [Parameter("k", 4.0, sigma=0.1, lower=0.0, log=True)]
    priors = Priors(parameters, ())
    assert priors.residual(np.array([4.0])) == pytest.approx([0.0])
    assert priors.residual(np.array([8.0])) == pytest.approx([np.log(2.0) / 0.1])
    assert priors.residual(np.array([2.0])) == pytest.approx([-np.log(2.0) / 0.1])
    step = 1e-6
    difference = (priors.residual(np.array([8.0 + step])) - priors.residual(np.array([8.0 - step]))) / (
        2 * step
    )
    assert priors.rates(np.array([8.0]), (0,))[:, 0] == pytest.approx(difference, rel=1e-6)


@pytest.mark.parametrize(
    ("parameters", "candidates", "what"),
    [
        ([Parameter("a", 1.0)], [Candidate("a", ("a",), sigma=(1.0, 2.0))], "expected 1 standard deviations"),
        ([Parameter("a", 1.0)], [Candidate("a", ("a",), sigma=(0.0,))], "above 0, found 0"),
        (
            [Parameter("a", 1.0)],
            [Candidate("a", ("a",), sigma=(1.0,)), Candidate("b", ("a",), sigma=(2.0,))],
            "two priors: 1 and 2",
        ),
        ([Parameter("a", 0.0, sigma=1.0, log=True)], [], "expected a positive value for a log-normal prior"),
    ],
)
def test_priors_that_contradict_themselves_are_refused(
    parameters: list[Parameter], candidates: list[Candidate], what: str
) -> None:
    with pytest.raises(PkmodesError, match=what):
        Priors(parameters, candidates)


NAMES, SIGMAS = ("a", "b", "c"), np.array([0.5, 2.0, 1.0])
TRUTH = np.array([0.4, -1.0, 0.7])


def two_together(rate: float) -> list[Parameter]:
    """Return three parameters, of which the first two are correlated."""
    rates = {"a": (("b", rate),), "b": (("a", rate),), "c": ()}
    return [Parameter(n, 0.0, sigma=s, correlated=rates[n]) for n, s in zip(NAMES, SIGMAS, strict=True)]


def correlated(rate: float) -> LogLinear:
    found = log_linear(np.random.default_rng(11), 3, 4, two_together(rate), [])
    found.G *= SIGMA
    return found


def fitted(model: LogLinear, y: np.ndarray) -> Fit:
    fit = Fitter(model, logs_measured(y, SIGMA)).fit(Hypothesis())
    assert fit is not None
    return fit


def covariance(rate: float) -> np.ndarray:
    rates = np.eye(3)
    rates[0, 1] = rates[1, 0] = rate
    return rates * np.outer(SIGMAS, SIGMAS)


@pytest.mark.parametrize("rate", [-0.95, 0.0, 0.6])
def test_correlated_priors_pull_values_as_in_bayes_rule(rate: float) -> None:
    model = correlated(rate)
    y = model.base + model.G @ TRUTH
    fit = fitted(model, y)
    J, d = model.G.reshape(-1, 3) / SIGMA, ((y - model.base) / SIGMA).ravel()
    precision = np.linalg.inv(covariance(rate))
    posterior = np.linalg.inv(J.T @ J + precision)
    values = posterior @ J.T @ d
    assert fit.values == pytest.approx(values, rel=1e-6)
    assert fit.covariance == pytest.approx(posterior, rel=1e-6, abs=1e-12)
    left = d - J @ values
    assert fit.chi2 == pytest.approx(float(left @ left + values @ precision @ values), rel=1e-6)


@pytest.mark.parametrize("rate", [-1.0, 1.0])
def test_exactly_proportional_values_stay_so(rate: float) -> None:
    """Two values are one number u of variance 1: a = 0.5 u, b = 2 u or -2 u; to a ten-thousandth of a sigma."""
    model = correlated(rate)
    y = model.base + model.G @ TRUTH
    fit = fitted(model, y)
    along = np.array([[SIGMAS[0], 0.0], [rate * SIGMAS[1], 0.0], [0.0, SIGMAS[2]]])
    J, d = model.G.reshape(-1, 3) @ along / SIGMA, ((y - model.base) / SIGMA).ravel()
    posterior = np.linalg.inv(J.T @ J + np.eye(2))
    u = posterior @ J.T @ d
    assert fit.values == pytest.approx(along @ u, abs=1e-3)
    assert fit.covariance == pytest.approx(along @ posterior @ along.T, abs=1e-3)
    assert abs(fit.values[1] / SIGMAS[1] - rate * fit.values[0] / SIGMAS[0]) < 1e-3


def test_the_distance_of_a_single_value_is_in_its_own_sigma() -> None:
    priors = Priors(two_together(-0.9), ())
    values = np.array([0.5, 2.0, 3.0])
    assert priors.distances(values) == pytest.approx([1.0, 1.0, 3.0])
    assert priors.residual(values) @ priors.residual(values) == pytest.approx(
        values @ np.linalg.inv(covariance(-0.9)) @ values
    )
    wide = Priors(two_together(-0.9), (), prior_factor=2.0).residual(values)
    assert wide @ wide == pytest.approx(values @ np.linalg.inv(4.0 * covariance(-0.9)) @ values)


def test_correlations_that_cannot_be_are_refused() -> None:
    alone = [Parameter("a", 0.0, sigma=1.0, correlated=(("b", 0.5),)), Parameter("b", 0.0, sigma=1.0)]
    with pytest.raises(PkmodesError, match="expected a symmetric, positive semidefinite matrix") as caught:
        Priors(alone, ())
    assert caught.value.where == "parameters a, b"


def test_correlations_of_a_robot_file_are_those_of_the_priors_of_its_diagnosis(tmp_path: Path) -> None:
    """The variances are those of the values' sigmas, the covariances those of the table."""
    text = published().replace('"1.5 kg"', '{ value = "1.5 kg", sigma = "0.1 kg" }', 1)
    text = text.replace('"15 mm"', '{ value = "15 mm", sigma = "1 mm" }', 1)
    path = tmp_path / "robot.toml"
    path.write_text(
        text + "\n[damping]\nratio = { value = 0.02, sigma = 0.01 }\n\n[[covariance]]\n"
        'paths = ["belt.width", "platform.mass", "damping.ratio"]\nsigma = ["0.5 mm", "50 g", 0.005]\n'
        "correlation = [[1, 0.8, 0], [0.8, 1, 0], [0, 0, 1]]\n",
        encoding="utf-8",
    )
    data = Measurements.from_rows(
        ["P"] * 3,
        np.array([54.0, 59.0, 60.0]),
        np.full(3, 0.1),
        points=np.tile([0.6, 0.0, -0.245], (3, 1)),
        components={"x": "m", "y": "m", "z": "m"},
    )
    built = MeasuredRobot.of(read_robot(path), data).structure()
    priors = Priors(built.parameters, ())
    names = [built.parameters[i].name for i in priors.index]
    assert names == ["platform.mass", "belt.width"]
    values = declared(built)
    values[priors.index] += [0.07, 0.0003]
    both = 0.8 * 0.05 * 0.0005
    expected = np.array([0.07, 0.0003]) @ np.linalg.solve([[0.1**2, both], [both, 0.001**2]], [0.07, 0.0003])
    assert priors.residual(values) @ priors.residual(values) == pytest.approx(expected)


def test_losses_have_correlated_priors_too() -> None:
    """Two proportional losses move together; two independent ones would each move by their share."""
    count, rng = 8, np.random.default_rng(4)
    rates = 1.0 + rng.random((count, 2))
    declared, sigmas = np.array([0.02, 0.03]), np.array([0.004, 0.003])
    rows = DampingObservations(
        index=np.arange(count),
        mode=np.arange(count),
        ratio=rates @ declared * 1.15,
        stated_sigma=np.full(count, 0.1),
        unstated_sigma=np.full(count, 0.1),
        resolved_mask=np.ones(count, dtype=bool),
        frequency=10.0 + np.arange(count),
        ratio_floor=np.zeros(count),
        coefficients=rates,
    )

    def moved(rate: float) -> np.ndarray:
        """Return the changes of both in standard deviations."""
        names = ("ratio", "loss")
        losses = tuple(
            Loss(
                Parameter(name, value, sigma=sigma, lower=0.0, upper=1.0, correlated=((names[1 - k], rate),)),
                "",
                "",
                True,
            )
            for k, (name, value, sigma) in enumerate(zip(names, declared, sigmas, strict=True))
        )
        fitter = LossFitter(rows, losses, Criteria())
        found = fitter.fit()
        away = (found.values - declared) / sigmas
        priors = float(away @ np.linalg.pinv([[1.0, rate], [rate, 1.0]], hermitian=True) @ away)
        white = rows.residual(found.values)
        assert found.chi2 == pytest.approx(float(white @ white) + priors, rel=1e-6)
        return away

    together, apart = moved(1.0), moved(-0.5)
    assert together[0] > 0.5
    assert together[1] == pytest.approx(together[0], abs=1e-3)
    assert abs(apart[1] - apart[0]) > 0.01
