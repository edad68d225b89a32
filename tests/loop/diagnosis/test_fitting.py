"""Fits of hypotheses against textbook least squares and chi-square."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.linalg import block_diag
from scipy.optimize import minimize_scalar

from helpers.references.textbook_fits import (
    BOTH,
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
from helpers.robots.small_structures import LogLinear, logs_measured, some_rows
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Measurements, Parameter
from pkmodes.loop.diagnosis.fit.cross_validation import predict_left_out
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis


@pytest.mark.parametrize(
    ("causes", "columns"), [((), [0, 1]), (CAUSES, [0, 1, 2, 3]), (CAUSES[1:], [0, 1, 3])]
)
def test_estimates_covariance_and_sum_of_squares_are_those_of_least_squares_with_priors(
    causes: tuple[Candidate, ...], columns: list[int]
) -> None:
    model = structure(0)
    rng = np.random.default_rng(100)
    sigma = SIGMA * np.exp(rng.uniform(-1.0, 1.0, model.base.shape))
    y = simulated(model, TRUE, 0)
    found = fitted(model, logs_measured(y, sigma), Hypothesis(causes))
    G = model.G.reshape(-1, 4)
    fixed = np.where(np.isin(range(4), columns), 0.0, DECLARED)
    values, covariance, chi2 = least_squares(
        G[:, columns],
        (y - model.base).ravel() - G @ fixed,
        np.diag(sigma.ravel() ** 2),
        DECLARED[columns],
        [[0.05, 0.002, None, None][i] for i in columns],
    )
    assert list(found.free) == columns
    assert found.values[columns] == pytest.approx(values, abs=1e-3 * np.sqrt(np.diagonal(covariance).min()))
    assert found.values[fixed != 0.0].tolist() == fixed[fixed != 0.0].tolist()
    assert found.covariance == pytest.approx(covariance, rel=1e-6)
    assert found.chi2 == pytest.approx(chi2, rel=1e-6)


def test_the_least_sum_of_squares_is_chi_square_with_rows_less_parameters_without_prior() -> None:
    # The truth is drawn from the priors each time.  An error of one degree of freedom in 18 would be 2.7 standard
    # errors of the mean here; Kolmogorov's limit for p < 0.001 is 1.95 / sqrt(n).
    model, draws = structure(1, 4, 5), 240
    p_values, pulls = [], []
    for seed in range(draws):
        rng = np.random.default_rng([seed, 2])
        true = np.array([*(DECLARED[:2] + PRIORS * rng.standard_normal(2)), 0.7, -0.2])
        found = fitted(model, logs_measured(simulated(model, true, seed), SIGMA), BOTH)
        p_values.append(stats.chi2.sf(found.chi2, 20 - 2))
        pulls.append((found.values - true) / np.sqrt(np.diagonal(found.covariance)))
    assert stats.kstest(p_values, "uniform").statistic < 1.95 / np.sqrt(draws)
    # Standard deviations of n pulls scatter by 1 / sqrt(2 n), their means by 1 / sqrt(n): four of these.
    assert np.std(pulls, axis=0) == pytest.approx(1.0, abs=4.0 / np.sqrt(2 * draws))
    assert np.mean(pulls, axis=0) == pytest.approx(0.0, abs=4.0 / np.sqrt(draws))


def test_excluded_rows_are_not_used() -> None:
    model = structure(2)
    y = simulated(model, TRUE, 2)
    y[1, 2] += 0.1
    y[3, 0] -= 0.05
    data = logs_measured(y, SIGMA)
    found = fitted(model, data, Hypothesis(CAUSES, excluded_rows=frozenset({6, 12})))
    kept = np.setdiff1d(np.arange(20), [6, 12])
    values, covariance, chi2 = least_squares(
        model.G.reshape(-1, 4)[kept],
        (y - model.base).ravel()[kept],
        SIGMA**2 * np.eye(18),
        DECLARED,
        [0.05, 0.002, None, None],
    )
    assert found.values == pytest.approx(values, abs=1e-3 * np.sqrt(np.diagonal(covariance).min()))
    assert found.covariance == pytest.approx(covariance, rel=1e-6)
    assert found.chi2 == pytest.approx(chi2, rel=1e-6)
    assert found.residual[[6, 12]].tolist() == [0.0, 0.0]


@pytest.mark.parametrize("unit", [1.0, 2.1e11, 1e15, 1e-12])
def test_the_fit_is_the_same_in_any_unit(unit: float) -> None:
    # ln f = ... + ln(E) / 2, with E = 210 GPa in Pa: derivatives of 1e-12 are not small, and 1e15 is not large.
    K = 4.0e5 * np.array([[2.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 1.0]])
    shared = MatrixStructure(
        [Parameter("E", unit, "Pa", sigma=0.1 * unit)],
        [],
        lambda values, _: (20.0 * np.eye(3), values["E"] / unit * K),
        derivatives=lambda values, _, name: (np.zeros((3, 3)), K / unit),
        channels=["a", "b", "c"],
    )
    f = np.sqrt(1.1 * np.linalg.eigvalsh(K / 20.0)) / (2 * np.pi)
    found = Fitter(shared, Measurements.from_rows(["A"] * 3, f, 0.01 * f)).fit(Hypothesis())
    assert found is not None
    # By hand: the sum of squares is (3 / 0.01^2) (ln(1.1 / e) / 2)^2 + ((e - 1) / 0.1)^2.
    best = minimize_scalar(
        lambda e: 3e4 / 4 * np.log(1.1 / e) ** 2 + 100 * (e - 1) ** 2, bounds=(1.0, 1.2), method="bounded"
    )
    assert found.values[0] / unit == pytest.approx(best.x, abs=1e-5)
    assert found.chi2 == pytest.approx(best.fun, rel=1e-5)
    assert np.sqrt(found.covariance[0, 0]) / unit == pytest.approx(
        (3e4 / 4 / best.x**2 + 100) ** -0.5, rel=1e-4
    )


def test_two_causes_may_share_a_parameter() -> None:
    shared = (CAUSES[0], Candidate("both", ("u", "v")))
    model = structure(9)
    model = LogLinear(model.base, model.G, PARAMETERS, shared)
    data = logs_measured(simulated(model, TRUE, 9), SIGMA)
    twice = fitted(model, data, Hypothesis(shared))
    once = fitted(model, data, Hypothesis(shared[1:]))
    assert twice.free == (0, 1, 2, 3)
    assert twice.chi2 == pytest.approx(once.chi2)
    assert twice.covariance == pytest.approx(once.covariance)


def test_a_parameter_that_the_data_do_not_determine_has_a_large_but_finite_error() -> None:
    model = structure(10)
    model.G[..., 2] = 0.0
    found = fitted(model, logs_measured(simulated(model, TRUE, 10), SIGMA), BOTH)
    assert np.isfinite(found.covariance).all()
    assert abs(found.values[2]) < 1e-3 * np.sqrt(found.covariance[2, 2])
    known = fitted(model, logs_measured(simulated(model, TRUE, 10), SIGMA), Hypothesis(CAUSES[1:]))
    assert found.chi2 == pytest.approx(known.chi2)
    assert found.covariance[2, 2] > 1e6


def test_the_order_of_rows_and_setups_does_not_matter() -> None:
    model = structure(11)
    data = logs_measured(simulated(model, TRUE, 11, 0.01), SIGMA)
    plain = fitted(model, data, Hypothesis(CAUSES, frozenset({7}), has_shared_error=True))
    order = np.random.default_rng(0).permutation(20)
    shuffled = some_rows(data, order)
    moved = model.subset([data.labels.index(label) for label in shuffled.labels])
    excluded = frozenset({int(np.flatnonzero(order == 7)[0])})
    found = fitted(moved, shuffled, Hypothesis(CAUSES, excluded, has_shared_error=True))
    assert found.values == pytest.approx(plain.values, rel=1e-6)
    assert found.deviance == pytest.approx(plain.deviance, rel=1e-9)


def test_a_repeated_frequency_moves_by_the_mean_of_its_two_modes() -> None:
    # Two equal masses on equal springs beside each other: one spring changes one of two equal modes.
    def matrices(values, _):
        return np.eye(2), np.diag([100.0 + values["s"] + values["t"], 100.0 + values["s"]])

    parameters = [Parameter("s", 0.0, sigma=1.0), Parameter("t", 0.0)]
    pair = MatrixStructure(parameters, [Candidate("t", ("t",))], matrices, channels=["a", "b"])
    data = Measurements.from_rows(["A", "A"], [10.1 / 2 / np.pi, 10.0 / 2 / np.pi], [0.001, 0.001])
    fitter = Fitter(pair, data)
    prediction = pair.predict(np.zeros(2), (0, 1))
    pairing = fitter.observations.pairer.pair(prediction, np.ones(2, dtype=bool))
    assert fitter.observations.rates(prediction, pairing, np.ones(2, dtype=bool)) == pytest.approx(
        np.array([[0.5, 0.25], [0.5, 0.25]]) / 100.0
    )
    found = fitter.fit(Hypothesis((pair.candidates[0],)), np.array([0.0, 0.1]))
    assert found is not None
    assert found.chi2 == pytest.approx(0.0, abs=1e-6)  # 10.1^2 = 100 + 2.01 for one of them
    assert found.values == pytest.approx([0.0, 2.01], abs=1e-3)


def test_the_prediction_of_a_left_out_setup_is_that_of_a_fit_without_it() -> None:
    model = structure(12)
    y = simulated(model, TRUE, 12)
    found = fitted(model, logs_measured(y, SIGMA), BOTH)
    expected = []
    for i in range(5):
        others = [k for k in range(5) if k != i]
        values, _, _ = least_squares(
            model.G[others].reshape(-1, 4),
            (y - model.base)[others].ravel(),
            SIGMA**2 * np.eye(16),
            DECLARED,
            [0.05, 0.002, None, None],
        )
        expected.append(float(np.sum((y[i] - model.base[i] - model.G[i] @ values) ** 2)) / SIGMA**2)
    squares, leverage = predict_left_out(
        found, Fitter(model, logs_measured(y, SIGMA)).observations.data_indices_by_setup()
    )
    assert squares == pytest.approx(expected, rel=1e-3)
    # A setup's largest leverage: the largest part of a combination of its residuals that the fit takes up.
    J = np.vstack([model.G.reshape(-1, 4) / SIGMA, np.eye(4)[:2] / PRIORS[:, None]])
    H = J @ np.linalg.inv(J.T @ J) @ J.T
    blocks = [np.linalg.eigvalsh(H[4 * i : 4 * i + 4, 4 * i : 4 * i + 4])[-1] for i in range(5)]
    assert leverage == pytest.approx(blocks, rel=1e-6)


def test_fits_differ_by_the_distance_of_their_predictions_in_the_metric_of_the_errors() -> None:
    model = structure(13, 6, 4)
    y = simulated(model, TRUE, 13, 0.01)
    fitter = Fitter(model, logs_measured(y, SIGMA))
    a, b = (fitter.fit(Hypothesis((cause,), frozenset({3}), has_shared_error=True)) for cause in CAUSES)
    assert a is not None
    assert b is not None
    between = (model.G @ (b.values - a.values)).ravel()
    kept = np.setdiff1d(np.arange(24), [3])
    V = block_diag(*[SIGMA**2 * np.eye(4) + a.shared_error**2] * 6)[np.ix_(kept, kept)]
    moved = (b.values - a.values)[:2] / PRIORS
    expected = between[kept] @ np.linalg.solve(V, between[kept]) + moved @ moved
    assert fitter.squared_difference(a, b) == pytest.approx(expected, rel=1e-9)
