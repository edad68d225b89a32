"""Priors of candidates and log-normal priors, against their textbook formulas."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.robots.small_structures import (
    SIGMA,
    LogLinear,
    log_linear,
    logs_measured,
    of_signatures,
    with_changes,
)
from pkmodes.core.base.errors import PkmodesError
from pkmodes.diagnosis import Candidate, Parameter, diagnose
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.diagnosis.fit.priors import Priors
from pkmodes.diagnosis.fit.store import FitStore


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
