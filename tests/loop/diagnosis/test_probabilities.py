"""Probabilities of explanations: evidence against independent quadrature, and what known structures must give."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from msgspec import structs
from scipy import integrate, special, stats

from helpers.references.textbook_fits import least_squares
from helpers.robots.small_structures import (
    SIGMA,
    LogLinear,
    directions,
    errors,
    ladder,
    logs_measured,
    of_signatures,
    with_changes,
)
from pkmodes.loop.diagnosis import Candidate, Diagnosis, Measurements, Parameter, diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.posterior import marginal, outside
from pkmodes.loop.diagnosis.posterior import probabilities as posterior
from pkmodes.loop.diagnosis.posterior.document import ClassProbability, PairProbability, Probabilities
from pkmodes.loop.diagnosis.posterior.linearised import LinearisedFit, linearise
from pkmodes.loop.diagnosis.posterior.probabilities import (
    DOUBT_IF_ACCEPTED,
    DOUBT_IF_REFUSED,
    DOUBT_IF_UNEXPLAINED,
    _linear_explanations,
)
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.verdict import builder

SETUPS, MODES = 10, 5
ROWS = SETUPS * MODES
DIRECTIONS = directions(ROWS, 30)


@pytest.fixture
def exact_errors(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stated errors that are certainly right, so that a linear structure has an evidence in closed form."""
    monkeypatch.setattr(marginal, "NARROW_SIGMA", 1e-4)
    monkeypatch.setattr(marginal, "WIDE_WEIGHT", 0.0)


# The evidence against quadrature ----------------------------------------------------------------------------------


@pytest.mark.usefixtures("exact_errors")
@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("strength", [1.5, 4.0, 9.0])
def test_the_evidence_of_a_cause_is_the_integral_over_its_size_and_the_uncertain_value(
    one_sided: bool, strength: float
) -> None:
    rng, sigma_n, largest = np.random.default_rng(5), 0.004, 60.0
    parameters = (
        Parameter("n", 0.0, sigma=sigma_n),
        Parameter("u", 0.0, lower=0.0 if one_sided else -np.inf),
    )
    cause = Candidate("u", ("u",))
    model = LogLinear(ladder(4, 3), rng.standard_normal((4, 3, 2)), parameters, (cause,))
    G = model.G.reshape(-1, 2)
    V = SIGMA**2 * np.eye(len(G))
    size = float(np.sqrt(least_squares(G, np.zeros(len(G)), V, np.zeros(2), [sigma_n, None])[1][1, 1]))
    y = G @ [0.7 * sigma_n, strength * size] + SIGMA * rng.standard_normal(len(G))
    fitter = Fitter(model, logs_measured(model.base + y.reshape(4, 3), SIGMA))
    plain, with_cause = (_left(fitter, causes, {1: largest * size}) for causes in ((), (cause,)))

    def likelihood(n: float, u: float) -> float:
        return float(np.exp(-0.5 * ((y - G @ [n, u]) ** 2).sum() / SIGMA**2 + 0.5 * (y**2).sum() / SIGMA**2))

    def of_n(u: float) -> float:
        best = G[:, 0] @ (y - G[:, 1] * u) / (G[:, 0] @ G[:, 0] + (SIGMA / sigma_n) ** 2)
        reach = 8.0 * SIGMA / np.linalg.norm(G[:, 0])
        density = stats.norm(0.0, sigma_n).pdf
        return integrate.quad(lambda n: likelihood(n, u) * density(n), best - reach, best + reach)[0]

    def of_u(log: float) -> float:
        u = size * np.exp(log)
        both = of_n(u) if one_sided else 0.5 * (of_n(u) + of_n(-u))
        return both / np.log(largest)

    whole = integrate.quad(of_u, 0.0, np.log(largest), limit=400, epsrel=1e-7)[0]
    assert with_cause.log_evidence - plain.log_evidence == pytest.approx(np.log(whole / of_n(0.0)), abs=0.02)


@pytest.mark.usefixtures("exact_errors")
def test_a_row_set_aside_leaves_more_room_to_the_uncertain_value() -> None:
    rng, sigma_n, row = np.random.default_rng(6), 0.004, 3
    model = LogLinear(ladder(4, 3), rng.standard_normal((4, 3, 1)), (Parameter("n", 0.0, sigma=sigma_n),))
    model.G[1, 0] = 4.0  # what the row that is set aside would say of it
    G = model.G.reshape(-1, 1)
    y = SIGMA * rng.standard_normal(len(G))
    fitter = Fitter(model, logs_measured(model.base + y.reshape(4, 3), SIGMA))
    every, fewer = (fitter.fit(Hypothesis(excluded_rows=frozenset(rows))) for rows in ((), (row,)))
    assert every is not None
    assert fewer is not None

    def whole(kept: np.ndarray) -> float:
        V = SIGMA**2 * np.eye(len(y)) + sigma_n**2 * G @ G.T
        return float(stats.multivariate_normal(cov=V[np.ix_(kept, kept)]).logpdf(y[kept]))

    density = stats.norm(0.0, SIGMA).logpdf(0.0)
    expected = whole(np.delete(np.arange(len(y)), row)) + density - whole(np.arange(len(y)))
    price = np.log(1.2 / (np.sqrt(2.0 * np.pi) * SIGMA)) - np.log(0.01)
    found = linearise(fitter, fewer, {}).log_evidence - linearise(fitter, every, {}).log_evidence
    assert found == pytest.approx(expected - price, abs=0.01)


@pytest.mark.parametrize("sigma", [None, (8.0,)])
@pytest.mark.parametrize("strength", [3.0, 7.0])
def test_a_cause_that_was_not_fitted_has_the_evidence_of_its_fit_where_the_model_is_linear(
    sigma: tuple[float, ...] | None, strength: float
) -> None:
    signatures = {"n": DIRECTIONS[0], "a": 0.8 * DIRECTIONS[1] + 0.6 * DIRECTIONS[0], "b": DIRECTIONS[2]}
    model = of_signatures(
        signatures, SETUPS, MODES, known={"n": {"sigma": 3.0}}, roles={"a": {"sigma": sigma}}
    )
    data = with_changes(model, strength * DIRECTIONS[1] + errors(ROWS))
    store = FitStore(Fitter(model, data))
    search, plausible = Search(store, model.candidates), {1: 100.0, 2: 100.0}
    plain = _left(store.fitter, (), {})
    assert not plain.set_aside
    linear = {one.causes: one.log_weight for one in _linear_explanations(search, plausible, plain, 0.0)}
    for cause in model.candidates:
        assert linear[cause.name,] == pytest.approx(
            _left(store.fitter, (cause,), plausible).log_evidence, abs=0.05
        )


@pytest.mark.parametrize("dimensions", [2, 3, 5])
@pytest.mark.parametrize("signal", [0.3, 4.0, 25.0])
def test_the_price_of_several_parameters_is_the_integral_over_all_directions(
    dimensions: int, signal: float
) -> None:
    largest, power = 200.0, 0.5 * (dimensions - 3)
    whole = special.beta(0.5, power + 1.0)

    def of_direction(angle: float, r: float) -> float:
        cosine = np.cos(angle)
        squares = r**2 + signal**2 - 2.0 * r * signal * cosine
        return np.exp(-0.5 * squares) * np.sin(angle) ** (dimensions - 2) / whole / r / np.log(largest)

    low, high = max(1.0, signal - 7.0), min(largest, signal + 7.0)
    expected = integrate.dblquad(of_direction, low, high, 0.0, np.pi, epsabs=0.0, epsrel=1e-6)[0]
    found = marginal.log_occam_factor(*(np.array([one]) for one in (signal, dimensions, largest, False)))
    assert found[0] == pytest.approx(np.log(expected), abs=0.01)


def test_misstated_errors_are_integrated_out() -> None:
    narrow, wide = (stats.norm(0.0, s).pdf for s in (marginal.NARROW_SIGMA, marginal.WIDE_SIGMA))
    for squares, degrees in ((40.0, 40.0), (160.0, 40.0), (2000.0, 40.0), (3.0, 12.0)):

        def density(log: float, q: float = squares, nu: float = degrees) -> float:
            prior = (1.0 - marginal.WIDE_WEIGHT) * narrow(log) + marginal.WIDE_WEIGHT * wide(log)
            return float(prior * np.exp(-nu * log - 0.5 * q * np.exp(-2.0 * log) + 0.5 * nu))

        low, high = marginal.LOG_ERROR_FACTORS[[0, -1]]
        expected = (
            np.log(
                integrate.quad(density, low, high, points=[0.0, 0.5 * np.log(squares / degrees)], limit=300)[
                    0
                ]
            )
            - 0.5 * degrees
        )
        arrays = np.array([squares]), np.array([degrees])
        found = marginal.marginal_log_likelihood(*arrays, marginal.prior_of_error_factor())
        assert found[0] == pytest.approx(expected, abs=0.02)


def test_changes_of_low_rank_have_the_evidence_of_their_covariance() -> None:
    rng, rows = np.random.default_rng(2), 14
    root, white = rng.standard_normal((rows, 4)), 3.0 * rng.standard_normal(rows)
    g, axes = np.linalg.eigh(root.T @ root)
    c = (axes.T @ (root.T @ white)) ** 2 / g
    prior, largest = marginal.prior_of_error_factor(), 80.0
    sizes = np.geomspace(outside.MIN_SIGNAL, largest, outside.SIZE_COUNT)
    weights = prior[::2] / prior[::2].sum() / outside.SIZE_COUNT
    each = [
        np.log(weight)
        + stats.multivariate_normal(cov=np.exp(2 * log) * np.eye(rows) + a**2 * root @ root.T).logpdf(white)
        for log, weight in zip(marginal.LOG_ERROR_FACTORS[::2], weights, strict=True)
        for a in sizes
    ]
    expected = special.logsumexp(each) + 0.5 * rows * np.log(2.0 * np.pi)
    found = outside.log_evidence_of_frequencies(g, c, float(white @ white), rows, largest, prior)
    assert found == pytest.approx(expected, abs=1e-6)


def test_changes_are_seen_beside_what_is_fitted_only() -> None:
    rng = np.random.default_rng(4)
    model = LogLinear(ladder(4, 3), rng.standard_normal((4, 3, 1)), (Parameter("n", 0.0, sigma=0.004),))
    fitter = Fitter(model, logs_measured(model.base + SIGMA * rng.standard_normal((4, 3)), SIGMA))
    plain = _left(fitter, (), {})
    # Each mode moves one coordinate, so of the products of two components all but the squares vanish: a mass there
    # changes that mode alone, at all setups alike, and a spring in proportion to 1 / lambda.
    places = np.tile(np.eye(3), (4, 1))
    changes = np.hstack([places, places / plain.fit.prediction.eigenvalues.reshape(-1, 1)])
    root = np.vstack([changes / np.linalg.norm(changes, axis=0) / np.sqrt(6.0), np.zeros((1, 6))])
    signature = np.append(-model.G.ravel() / SIGMA, 1.0 / 0.004)[:, None]
    root -= signature @ np.linalg.lstsq(signature, root, rcond=None)[0]
    expected, axes = np.linalg.eigh(root.T @ root)
    g, c = outside.spectrum(fitter, plain)
    assert g == pytest.approx(expected, rel=1e-6)
    assert c == pytest.approx((axes.T @ (root.T @ plain.white)) ** 2 / expected, rel=1e-2)


def test_a_mass_at_one_coordinate_lies_in_the_family_of_changes() -> None:
    model = of_signatures({"a": DIRECTIONS[0]}, SETUPS, MODES)
    data = with_changes(model, errors(ROWS))
    fitter = Fitter(model, data)
    plain = _left(fitter, (), {})
    # Each mode of this structure moves one coordinate: a mass there changes that mode alone, at all setups alike.
    white = np.tile(12.0 * np.eye(MODES)[1], SETUPS) + errors(ROWS)
    marked = replace(plain, white=white)
    scattered = replace(plain, white=np.random.default_rng(1).permutation(white))
    assert (
        outside.log_evidence_outside(fitter, marked) > outside.log_evidence_outside(fitter, scattered) + 10.0
    )


def test_a_gross_row_counts_as_much_as_its_price_and_no_more() -> None:
    model = of_signatures({"a": DIRECTIONS[0]}, SETUPS, MODES)
    plain = errors(ROWS)
    away = {size: plain + size * np.eye(ROWS)[7] for size in (40.0, 90.0)}
    found = {size: _left(Fitter(model, with_changes(model, change)), (), {}) for size, change in away.items()}
    assert all(one.set_aside == {7} for one in found.values())
    assert found[40.0].log_evidence == pytest.approx(found[90.0].log_evidence, abs=1e-6)
    # A large row drags a fit along; the others then say where it belongs.
    cause = Fitter(model, with_changes(model, 20.0 * DIRECTIONS[0] + away[90.0]))
    with_cause = _left(cause, model.candidates, {})
    assert with_cause.set_aside == {7}
    assert with_cause.log_evidence > _left(cause, (), {}).log_evidence + 50.0


def _left(fitter: Fitter, causes: tuple[Candidate, ...], plausible: dict[int, float]) -> LinearisedFit:
    fit = fitter.fit(Hypothesis(causes))
    assert fit is not None
    return linearise(fitter, fit, plausible)


# What known structures must give ----------------------------------------------------------------------------------


def structure(**more: np.ndarray) -> LogLinear:
    """Eight causes with different signatures, and others that are given."""
    signatures = {f"cause {k}": DIRECTIONS[k] for k in range(8)} | more
    return of_signatures(signatures, SETUPS, MODES)


@cache
def found(kind: str) -> Diagnosis:
    return diagnosed(kind)


def diagnosed(kind: str) -> Diagnosis:
    change, more = {
        "noise": (np.zeros(ROWS), {}),
        "one": (20.0 * DIRECTIONS[2], {}),
        "two": (20.0 * DIRECTIONS[2] + 25.0 * DIRECTIONS[5], {}),
        "outside": (np.tile([30.0, -20.0, 0.0, 0.0, 15.0], SETUPS) / np.sqrt(SETUPS), {}),
        "anything": (15.0 * np.random.default_rng(9).standard_normal(ROWS), {}),
        "copies": (20.0 * DIRECTIONS[2], {"copy": DIRECTIONS[2] + 0.05 * DIRECTIONS[20]}),
        "more": (40.0 * DIRECTIONS[2] + 0.9 * errors(ROWS), {}),
        "gross": (20.0 * DIRECTIONS[2] + 80.0 * np.eye(ROWS)[31], {}),
    }[kind]
    model = structure(**more)
    return diagnose(model, with_changes(model, change + errors(ROWS)), holdout=())


def probabilities(kind: str) -> Probabilities:
    said = found(kind).probabilities
    assert said is not None
    return said


KINDS = ("noise", "one", "two", "outside", "anything", "copies", "more", "gross")


@pytest.mark.parametrize("kind", KINDS)
def test_probabilities_sum_to_one_with_what_is_listed(kind: str) -> None:
    said = probabilities(kind)
    listed = [one.probability for one in (*said.classes, *said.pairs)]
    assert said.nothing_missing + said.outside + sum(listed) == pytest.approx(1.0, abs=1e-12)
    assert all(0.0 < one <= 1.0 for one in listed)
    assert listed == [*sorted(listed[: len(said.classes)])[::-1], *sorted(listed[len(said.classes) :])[::-1]]


@pytest.mark.parametrize(
    ("kind", "statement"),
    [
        ("noise", "nothing_missing"),
        ("one", ("cause 2",)),
        ("two", (("cause 2", "cause 5"),)),
        ("outside", "outside"),
        ("anything", "outside"),
        ("gross", ("cause 2",)),
    ],
)
def test_the_most_probable_statement_is_true(kind: str, statement: object) -> None:
    top, probability = probabilities(kind).top
    assert top == statement
    assert probability > 0.8


def test_candidates_that_the_data_cannot_tell_apart_share_a_probability() -> None:
    said = probabilities("copies")
    top, probability = said.top
    assert set(top) == {"cause 2", "copy"}
    assert probability > 0.9
    assert all("copy" not in one.members for one in said.classes[1:])


def test_a_value_for_each_joint_is_less_probable_than_a_common_one_that_explains_as_much() -> None:
    common = DIRECTIONS[10:13].sum(axis=0) / np.sqrt(3.0)
    names = ("joint 1", "joint 2", "joint 3")
    signatures = {
        "common": common,
        **dict(zip(names, DIRECTIONS[10:13], strict=True)),
        "other": DIRECTIONS[0],
    }
    plain = of_signatures(signatures, SETUPS, MODES)
    some = [Candidate("common", ("common",)), Candidate("each", names), Candidate("other", ("other",))]
    model = LogLinear(plain.base, plain.G, plain.parameters, some)
    fitter = Fitter(model, with_changes(model, 20.0 * common + errors(ROWS)))
    of_common, of_each = (_left(fitter, (cause,), {}) for cause in some[:2])
    assert of_each.squares[0] <= of_common.squares[0]
    assert of_common.log_evidence > of_each.log_evidence + 2.0
    unequal = Fitter(model, with_changes(model, 20.0 * DIRECTIONS[10] + errors(ROWS)))
    of_common, of_each = (_left(unequal, (cause,), {}) for cause in some[:2])
    assert of_each.log_evidence > of_common.log_evidence + 20.0


def test_explanations_are_doubted_more_where_none_is_accepted_and_most_where_none_leaves_noise() -> None:
    model = structure()
    search = Search(
        FitStore(Fitter(model, with_changes(model, 20.0 * DIRECTIONS[2] + errors(ROWS)))), model.candidates
    )
    outcome = search.run()
    assert outcome is not None
    for accepted, doubt in ((True, DOUBT_IF_ACCEPTED), (False, DOUBT_IF_REFUSED)):
        said = posterior.probabilities(search, {}, outcome, accepted=accepted)
        assert said is not None
        assert said.outside == pytest.approx(doubt, abs=0.01)
    assert probabilities("one").outside == pytest.approx(DOUBT_IF_ACCEPTED, abs=0.01)
    more = probabilities("more")
    assert found("more").verdict == "unexplained"
    assert more.outside == pytest.approx(DOUBT_IF_UNEXPLAINED, abs=0.01)
    assert more.classes[0].members == ("cause 2",)


@pytest.mark.parametrize("missed", [1.0, 1e-9])
@pytest.mark.parametrize(("kind", "statement"), [("one", ("cause 2",)), ("two", (("cause 2", "cause 5"),))])
def test_something_outside_that_the_data_cannot_show_is_as_probable_as_before(
    monkeypatch: pytest.MonkeyPatch, kind: str, statement: object, missed: float
) -> None:
    """Beside one cause or two, and if these add modes that were not measured."""
    monkeypatch.setattr(posterior, "DOUBT_IF_ACCEPTED", 0.0)
    monkeypatch.setattr(posterior, "log_evidence_outside", lambda _, model: model.log_evidence)
    monkeypatch.setattr(posterior, "p_unmeasured", lambda *_: missed)
    said = diagnosed(kind).probabilities
    assert said is not None
    assert said.top[0] == statement
    # There are no single joints here: of the prior of 0.16 this is what is left.
    assert said.outside == pytest.approx(0.9 * 0.16 / (0.9 * 0.16 + 0.84), abs=0.01)


def test_no_verdict_depends_on_probabilities(monkeypatch: pytest.MonkeyPatch) -> None:
    model = structure()
    data = with_changes(model, 20.0 * DIRECTIONS[2] + errors(ROWS))
    monkeypatch.setattr(builder, "probabilities", lambda *_, **__: None)
    assert diagnose(model, data, holdout=()) == replace(found("one"), probabilities=None)


def test_nothing_is_probable_where_nothing_was_searched_for() -> None:
    model = structure()
    one = Measurements.from_rows(["P0"], [float(np.exp(model.base[0, 0]))], [0.02])
    few = diagnose(
        LogLinear(model.base[:1], model.G[:1], model.parameters, model.candidates), one, holdout=()
    )
    assert few.verdict == "insufficient_data"
    assert few.probabilities is None
    assert few.as_json()["probabilities"] is None


def test_the_json_has_them() -> None:
    said = found("two").as_json()["probabilities"]
    assert isinstance(said, dict)
    assert list(said) == ["nothing_missing", "outside", "classes", "pairs"]
    assert said["pairs"][0]["members"] == [["cause 2", "cause 5"]]


def test_the_top_is_the_largest() -> None:
    said = Probabilities(
        0.1, 0.2, (ClassProbability(("a", "b"), 0.3),), (PairProbability((("a", "c"),), 0.4),)
    )
    assert said.top == ((("a", "c"),), 0.4)
    assert structs.replace(said, outside=0.5).top == ("outside", 0.5)
