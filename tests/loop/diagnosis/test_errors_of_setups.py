"""Errors that all modes of a setup share, and uncertain positions, against textbook likelihoods."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.linalg import block_diag
from scipy.optimize import minimize_scalar

from helpers.references.textbook_fits import (
    CAUSES,
    DECLARED,
    PARAMETERS,
    PRIORS,
    SIGMA,
    TRUE,
    fitted,
    least_squares,
    simulated,
    structure,
)
from helpers.robots.small_structures import LogLinear, frame, frame_measured, logs_measured
from pkmodes.loop.diagnosis import Measurements, Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis


def shared(y: np.ndarray, tau: float) -> np.ndarray:
    setups, modes = y.shape
    return block_diag(*[SIGMA**2 * np.eye(modes) + tau**2] * setups)


@pytest.mark.parametrize("tau", [0.001, 0.004, 0.02])
def test_the_shared_error_is_the_one_of_greatest_likelihood(tau: float) -> None:
    model = structure(3, 12, 4)
    y = simulated(model, TRUE, 3, tau)
    found = fitted(model, logs_measured(y, SIGMA), Hypothesis(CAUSES, has_shared_error=True))
    G, left = model.G.reshape(-1, 4), (y - model.base).ravel()

    def deviance(log_tau: float) -> float:
        V = shared(y, np.exp(log_tau))
        chi2 = least_squares(G, left, V, DECLARED, [0.05, 0.002, None, None])[2]
        return chi2 + np.linalg.slogdet(V)[1]

    best = minimize_scalar(deviance, bounds=(np.log(1e-5), np.log(0.5)), method="bounded")
    # Its standard deviation is about tau / sqrt(2 S), a fifth of it: the estimates agree far better than that.
    assert found.shared_error == pytest.approx(np.exp(best.x), rel=0.01)
    assert found.shared_error == pytest.approx(tau, rel=0.7)
    assert found.deviance == pytest.approx(best.fun, abs=1e-3)
    V = shared(y, found.shared_error)
    values, covariance, _ = least_squares(G, left, V, DECLARED, [0.05, 0.002, None, None])
    assert found.values == pytest.approx(values, abs=0.02 * np.sqrt(np.diagonal(covariance).min()))
    assert found.covariance == pytest.approx(covariance, rel=1e-6)


@pytest.mark.parametrize("excluded", [[], [5]])
def test_the_deviance_is_twice_the_negative_logarithm_of_the_likelihood(excluded: list[int]) -> None:
    model = structure(4, 6, 4)
    y = simulated(model, TRUE, 4, 0.01)
    data = logs_measured(y, SIGMA)
    deviances, likelihoods = [], []
    for scatter in (False, True):
        found = fitted(model, data, Hypothesis(CAUSES, frozenset(excluded), scatter))
        left = y - model.base - model.G @ found.values
        total = -2 * stats.norm.logpdf(found.values[:2], DECLARED[:2], PRIORS).sum()
        for i, row in enumerate(left):
            V = SIGMA**2 * np.eye(4) + found.shared_error**2
            kept = np.setdiff1d(np.arange(4), [k - 4 * i for k in excluded])
            total -= 2 * stats.multivariate_normal.logpdf(row[kept], None, V[np.ix_(kept, kept)])
        # An additional error absorbs the residual of an outlier; its stated error stays in the likelihood.
        total -= len(excluded) * 2 * stats.norm.logpdf(0.0, 0.0, SIGMA)
        deviances.append(found.deviance)
        likelihoods.append(total)
    constant = 24 * np.log(2 * np.pi) + np.sum(np.log(2 * np.pi * PRIORS**2))
    assert np.array(deviances) + constant == pytest.approx(likelihoods, abs=1e-6)


def test_without_a_shared_error_its_estimate_changes_nothing() -> None:
    model = structure(5, 6, 4)
    y = model.base + model.G @ TRUE  # no error at all
    data = logs_measured(y, SIGMA)
    with_it = fitted(model, data, Hypothesis(CAUSES, frozenset({3}), has_shared_error=True))
    without = fitted(model, data, Hypothesis(CAUSES, frozenset({3})))
    assert with_it.shared_error < 0.02 * SIGMA
    assert with_it.deviance == pytest.approx(without.deviance, abs=1e-2)
    assert with_it.covariance == pytest.approx(without.covariance, rel=1e-2)


@pytest.mark.parametrize("scatter", [False, True])
def test_an_uncertain_position_is_a_nuisance_of_its_setup(scatter: bool) -> None:
    model = structure(6, 5, 4, positions=True)
    rng = np.random.default_rng(600)
    spread = np.array([[1e-3, 2e-3, 0.0]] * 4 + [[0.0] * 3])
    offsets = spread * rng.standard_normal((5, 3))
    y = simulated(model, TRUE, 6) + np.einsum("smk,sk->sm", model.B, offsets)
    data = logs_measured(y, SIGMA, spread)
    found = fitted(model, data, Hypothesis(CAUSES, frozenset({2}), scatter))
    # The same with the position of each setup as parameters that have priors.
    extra = [Parameter(f"{k} of {s}", 0.0, sigma=spread[s, k]) for s in range(4) for k in range(2)]
    G = np.zeros((5, 4, 8))
    for i, (s, k) in enumerate((s, k) for s in range(4) for k in range(2)):
        G[s, :, i] = model.B[s, :, k]
    explicit = LogLinear(model.base, np.concatenate([model.G, G], -1), [*PARAMETERS, *extra], CAUSES)
    same = fitted(explicit, logs_measured(y, SIGMA), Hypothesis(CAUSES, frozenset({2}), scatter))
    error = np.sqrt(np.diagonal(found.covariance))
    assert found.values == pytest.approx(same.values[:4], abs=(0.05 if scatter else 1e-3) * error.min())
    shown = [same.free.index(i) for i in range(4)]
    if (
        not scatter
    ):  # a shared error competes with free positions for the same residual, and is estimated otherwise
        assert found.chi2 == pytest.approx(same.chi2, rel=1e-6)
        assert found.covariance == pytest.approx(same.covariance[np.ix_(shown, shown)], rel=1e-6)


def test_an_uncertain_position_of_a_structure_without_positions_is_ignored() -> None:
    data = frame_measured({"A": 0.0}, {}, np.random.default_rng(0))
    uncertain = Measurements.from_rows(["A"] * 4, data.frequency, data.sigma, point_sigma=np.ones((4, 3)))
    plain, other = (Fitter(frame({"A": 0.0}), d).fit(Hypothesis()) for d in (data, uncertain))
    assert plain is not None
    assert other is not None
    assert other.chi2 == pytest.approx(plain.chi2)
