"""The score test against a linear model's exact gain, and its p-values against draws of the hypothesis."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from helpers.robots.small_structures import LogLinear, log_linear, logs_measured
from pkmodes.loop.diagnosis import Candidate, Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.search.score import Scores, score

SIGMA = 0.002
#: Steps of candidates that change frequencies by a few standard deviations.
SIZE = 0.002


def structure(
    seed: int, candidates: dict[str, tuple[int, float]], setups: int = 6, modes: int = 5
) -> LogLinear:
    """Two nuisances, and candidates by name with their number of parameters and their lower bound."""
    parameters = [Parameter("n1", 0.0, sigma=5.0), Parameter("n2", 1.0, sigma=0.5)]
    found = []
    for name, (count, lower) in candidates.items():
        names = tuple(f"{name}{k}" for k in range(count))
        parameters += [Parameter(n, 0.0, lower=lower) for n in names]
        found.append(Candidate(name, names))
    model = log_linear(np.random.default_rng(seed), setups, modes, parameters, found)
    model.G *= SIZE
    return model


def data(model: LogLinear, values: dict[str, float], seed: int):
    rng = np.random.default_rng([seed, 3])
    theta = np.array([values.get(p.name, p.value) for p in model.parameters])
    y = model.base + model.G @ theta
    return logs_measured(y + SIGMA * rng.standard_normal(y.shape), SIGMA)


def fit(model: LogLinear, measured, hypothesis: Hypothesis | None = None) -> tuple[Fitter, Fit]:
    fitter = Fitter(model, measured)
    found = fitter.fit(hypothesis or Hypothesis())
    assert found is not None
    return fitter, found


TWO_SIDED = {"a": (1, -np.inf), "b": (1, -np.inf), "three": (3, -np.inf)}


@pytest.mark.parametrize("name", list(TWO_SIDED))
@pytest.mark.parametrize("hypothesis", [Hypothesis(), Hypothesis(excluded_rows=frozenset({4, 17}))])
def test_the_gain_is_the_drop_of_the_sum_of_squares_in_a_linear_model(
    name: str, hypothesis: Hypothesis
) -> None:
    model = structure(0, TWO_SIDED)
    measured = data(model, {"n1": 3.0, "a0": 1.5, "three1": -1.0}, 0)
    fitter, before = fit(model, measured, hypothesis)
    (candidate,) = (c for c in model.candidates if c.name == name)
    one = score(fitter, before, [candidate]).by_candidate[0]
    after = fitter.fit(hypothesis.with_cause(candidate))
    assert after is not None
    assert one.gain == pytest.approx(before.chi2 - after.chi2, rel=1e-4)
    index = list(fitter.parameter_indices(candidate))
    added = [after.free.index(i) for i in index]
    errors = np.sqrt(np.diagonal(after.covariance)[added])
    assert one.step == pytest.approx(after.values[index], abs=1e-3 * errors.min())
    assert one.sigma == pytest.approx(errors, rel=1e-4)
    assert one.p_value == pytest.approx(stats.chi2.sf(before.chi2 - after.chi2, len(index)), rel=1e-3)
    assert one.largest_rates == pytest.approx(np.abs(model.G[..., index]).reshape(-1, len(index)).max(axis=0))


def test_the_gain_is_the_drop_with_a_shared_error_and_uncertain_positions() -> None:
    rng = np.random.default_rng(1)
    model = structure(1, {"a": (1, -np.inf)})
    model.B = rng.standard_normal((6, 5, 3))
    y = model.base + model.G @ [1.0, 1.0, 2.0] + 0.01 * rng.standard_normal((6, 1))
    y += SIGMA * rng.standard_normal(y.shape)
    fitter, before = fit(
        model, logs_measured(y, SIGMA, np.full((6, 3), 5e-4)), Hypothesis(has_shared_error=True)
    )
    one = score(fitter, before, model.candidates).by_candidate[0]
    # By hand: V is what the fit found, and the priors of the nuisances are further data.
    motion = [SIGMA**2 * np.eye(5) + before.shared_error**2 + 25e-8 * B @ B.T for B in model.B]
    G = np.vstack([np.linalg.solve(np.linalg.cholesky(V), g) for V, g in zip(motion, model.G, strict=True)])
    r = np.concatenate(
        [np.linalg.solve(np.linalg.cholesky(V), left) for V, left in zip(motion, y - model.base, strict=True)]
    )
    G = np.vstack([G, [[0.2, 0.0, 0.0], [0.0, 2.0, 0.0]]])
    r = np.concatenate([r, [0.0, 2.0]])
    chi2 = [np.sum((r - G[:, :k] @ np.linalg.lstsq(G[:, :k], r, rcond=None)[0]) ** 2) for k in (2, 3)]
    assert one.gain == pytest.approx(chi2[0] - chi2[1], rel=1e-3)
    assert one.largest_rates == pytest.approx(np.abs(model.G[..., 2]).max())


def test_a_candidate_gets_no_credit_for_what_the_nuisances_explain() -> None:
    model = structure(2, {"like n1": (1, -np.inf), "nearly": (1, -np.inf), "nothing": (1, -np.inf)})
    free = [Parameter("n1", 0.0, sigma=1e9), *model.parameters[1:]]
    model.G[..., 2] = 3.0 * model.G[..., 0]
    model.G[..., 3] += 5.0 * model.G[..., 0]
    model.G[..., 4] = 0.0
    model = LogLinear(model.base, model.G, free, model.candidates)
    fitter, before = fit(model, data(model, {"n1": 8.0, "nearly0": 2.0}, 2))
    like, nearly, nothing = score(fitter, before, model.candidates).by_candidate
    for one in (like, nothing):
        assert (one.is_visible, one.gain, one.p_value) == (False, 0.0, 1.0)
        assert one.step.tolist() == [0.0]
    assert nothing.largest_rates.tolist() == [0.0]
    after = fitter.fit(Hypothesis((nearly.candidate,)))
    assert after is not None
    assert nearly.gain == pytest.approx(before.chi2 - after.chi2, rel=1e-3)


@pytest.mark.parametrize("true", [-2.0, 2.0])
@pytest.mark.parametrize("lower", [-np.inf, 0.0])
def test_a_cause_that_cannot_be_negative_counts_in_one_direction_only(true: float, lower: float) -> None:
    model = structure(3, {"a": (1, lower), "b": (1, -np.inf)})
    fitter, before = fit(model, data(model, {"a0": true}, 3))
    one = score(fitter, before, model.candidates).by_candidate[0]
    free, cut = structure(3, {"a": (1, -np.inf), "b": (1, -np.inf)}), lower == 0.0
    after = Fitter(free, fitter.data).fit(Hypothesis((free.candidates[0],)))
    assert after is not None
    z = np.sign(true) * np.sqrt(before.chi2 - after.chi2)
    assert one.p_value == pytest.approx(stats.norm.sf(z) if cut else 2 * stats.norm.sf(abs(z)), rel=1e-3)
    if cut and true < 0.0:
        assert one.p_value > 0.99
        assert (one.gain, one.step[0]) == (0.0, 0.0)
    else:
        assert one.gain == pytest.approx(z**2, rel=1e-3)
        assert one.step[0] == pytest.approx(after.values[2], rel=1e-3)


def test_a_cause_that_cannot_be_positive_counts_in_the_other() -> None:
    model = structure(4, {"a": (1, -np.inf)})
    parameters = [*model.parameters[:2], Parameter("a0", 0.0, upper=0.0)]
    model = LogLinear(model.base, model.G, parameters, model.candidates)
    p_values = [
        score(*fit(model, data(model, {"a0": true}, 4)), model.candidates).by_candidate[0].p_value
        for true in (-2.0, 2.0)
    ]
    assert p_values[0] < 1e-4
    assert p_values[1] > 0.99


def test_parameters_with_the_same_effect_count_once() -> None:
    model = structure(5, {"one": (1, -np.inf), "twins": (2, -np.inf), "half blind": (2, -np.inf)})
    model.G[..., 3] = model.G[..., 4] = model.G[..., 5] = model.G[..., 2]
    model.G[..., 6] = 0.0
    fitter, before = fit(model, data(model, {"one0": 1.0}, 5))
    one, twins, blind = score(fitter, before, model.candidates).by_candidate
    assert twins.gain == pytest.approx(one.gain)
    assert twins.p_value == pytest.approx(one.p_value)
    assert twins.step == pytest.approx([one.step[0] / 2] * 2)
    assert blind.is_visible
    assert blind.gain == pytest.approx(one.gain)
    assert blind.p_value == pytest.approx(one.p_value)
    assert blind.step == pytest.approx([one.step[0], 0.0])
    assert np.isinf(twins.sigma).all()
    assert blind.sigma == pytest.approx([one.sigma[0], np.inf])


def test_without_candidates_the_p_value_is_one() -> None:
    model = structure(6, {})
    nothing = score(*fit(model, data(model, {}, 6)), ())
    assert nothing == Scores((), ())
    assert nothing.p_value == 1.0


def test_one_candidate_alone_has_its_own_p_value() -> None:
    for seed in range(6):
        model = structure(7, {"a": (1, 0.0 if seed % 2 else -np.inf)})
        found = score(*fit(model, data(model, {}, seed)), model.candidates)
        # 20000 draws scatter by 0.0035 at most: four of these.
        assert found.p_value == pytest.approx(found.by_candidate[0].p_value, abs=0.014)


def test_many_copies_of_a_candidate_are_as_one_and_independent_ones_are_many() -> None:
    names = {f"c{i}": (1, -np.inf) for i in range(12)}
    model = structure(8, names, setups=8)
    measured = data(model, {}, 8)
    independent = score(*fit(model, measured), model.candidates)
    smallest = min(one.p_value for one in independent.by_candidate)
    # Nearly orthogonal signatures: Sidak's formula.
    assert independent.p_value == pytest.approx(1 - (1 - smallest) ** 12, rel=0.15)
    model.G[..., 3:] = model.G[..., 2:3]
    copies = score(*fit(model, measured), model.candidates)
    assert copies.p_value == pytest.approx(copies.by_candidate[0].p_value, abs=0.014)


@pytest.mark.parametrize("negative", [False, True])
@pytest.mark.parametrize("factor", [3.0, -3.0])
def test_causes_of_one_sign_are_one_if_they_do_the_same_and_two_if_the_opposite(
    factor: float, negative: bool
) -> None:
    model = structure(11, {"a": (1, 0.0), "b": (1, 0.0)})
    b = Parameter("b0", 0.0, upper=0.0) if negative else model.parameters[3]
    model.G[..., 3] = factor * model.G[..., 2]
    model = LogLinear(model.base, model.G, [*model.parameters[:3], b], model.candidates)
    count = 1 if negative == (factor < 0.0) else 2
    for seed in range(6):
        found = score(*fit(model, data(model, {}, seed)), model.candidates)
        smallest = min(one.p_value for one in found.by_candidate)
        # Opposites: one of z and -z is as large with twice the probability.
        assert found.p_value == pytest.approx(min(count * smallest, 1.0), abs=0.014)


def test_p_values_that_no_draw_reaches_are_small_but_not_zero() -> None:
    model = structure(9, {f"c{i}": (1, -np.inf) for i in range(5)})
    for size in (2.0, 3.0, 5.0):
        found = score(*fit(model, data(model, {"c00": size}, 9)), model.candidates)
        smallest = min(one.p_value for one in found.by_candidate)
        assert 0.0 < smallest <= found.p_value <= max(5 * smallest, 1e-4)


def calibrated(monkeypatch: pytest.MonkeyPatch, draws: int) -> tuple[np.ndarray, np.ndarray]:
    """p-values of the best candidate among 14 correlated ones, and the smallest alone, under the hypothesis."""
    monkeypatch.setattr("pkmodes.loop.diagnosis.search.score.DRAWS", 4000)
    names = {f"one{i}": (1, 0.0) for i in range(7)} | {f"two{i}": (1, -np.inf) for i in range(6)}
    model = structure(10, names | {"three": (3, -np.inf)})
    # A part that all have in common correlates them by a third, two by nine tenths.
    model.G[..., 2:] += 0.7 * model.G[..., 2:3]
    model.G[..., 4] = model.G[..., 5] + 0.3 * model.G[..., 4]
    found, smallest = [], []
    for seed in range(draws):
        rng = np.random.default_rng([seed, 4])
        true = {"n1": 5.0 * rng.standard_normal(), "n2": 1.0 + 0.5 * rng.standard_normal()}
        scores = score(*fit(model, data(model, true, seed)), model.candidates)
        found.append(scores.p_value)
        smallest.append(min(one.p_value for one in scores.by_candidate))
    return np.array(found), np.array(smallest)


def test_the_p_value_of_the_best_of_many_is_uniform_under_the_hypothesis(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    draws = 300
    found, smallest = calibrated(monkeypatch, draws)
    # Kolmogorov's limit for p < 0.001, set beforehand, and the binomial's for 5 % and 1 % of the draws.
    assert stats.kstest(found, "uniform").statistic < 1.95 / np.sqrt(draws)
    for level in (0.05, 0.01):
        assert np.sum(found <= level) <= stats.binom.isf(0.001, draws, level)
    # Without correction, the best candidate would raise an alarm in far more than 5 %.
    assert np.mean(smallest <= 0.05) > 0.25
