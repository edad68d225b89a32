"""Limits of candidates that are not claimed, against profiles computed by SciPy from the matrices."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy import optimize, stats

from helpers.diagnoses.frame_diagnoses import SIX, TWO, checked, drawn
from helpers.robots.small_structures import SIGMA, each, frame, of_signatures, with_changes
from pkmodes.loop.diagnosis import MatrixStructure, Measurements, Parameter, diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.search.limits import bounds

#: Rise of chi2 at a one-sided limit at 95 %.
RISE = stats.norm.ppf(0.95) ** 2
LOADS = {"empty": 0.0, "4 kg": 4.0, "9 kg": 9.0}


def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
    """Two storeys; the brace of the lower one acts through a compliance, so that its influence saturates."""
    k = values["k"]
    lower = k + 1.0 / (values["joint"] + 1.0 / 3e5)
    masses = [values["m"], 20.0 + LOADS[setup]]
    return np.diag(masses), np.array([[lower + k, -k], [-k, k]])


def frequencies(values: dict[str, float]) -> np.ndarray:
    """ln f of both modes in all setups."""
    found = []
    for setup in LOADS:
        M, K = matrices(values, setup)
        root = np.diag(M) ** -0.5
        found.append(0.5 * np.log(np.linalg.eigvalsh(root[:, None] * K * root)) - np.log(2 * np.pi))
    return np.concatenate(found)


def structure(k_sigma: float) -> MatrixStructure:
    return MatrixStructure(
        [
            Parameter("k", 4e5, "N/m", sigma=k_sigma),
            Parameter("m", 20.0, "kg", lower=10.0, upper=40.0),
            Parameter("joint", 0.0, "m/N", lower=0.0),
        ],
        each(["m", "joint"]),
        matrices,
        channels=["1", "2"],
        setups=list(LOADS),
    )


def measured(seed: int, truth: dict[str, float]) -> Measurements:
    rng = np.random.default_rng([seed, 31])
    logs = frequencies(truth) + SIGMA * rng.standard_normal(6)
    return Measurements.from_rows(np.repeat(list(LOADS), 2).tolist(), np.exp(logs), SIGMA * np.exp(logs))


def profile(data: Measurements, k_sigma: float, name: str, value: float) -> float:
    """The least sum of squares with one parameter at a value."""

    def chi2(k: float) -> float:
        values = {"k": 4e5, "m": 20.0, "joint": 0.0} | {name: value, "k": k}
        white = (np.log(data.frequency) - frequencies(values)) / SIGMA
        return float(white @ white + ((k - 4e5) / k_sigma) ** 2)

    return float(
        optimize.minimize_scalar(chi2, bounds=(1e5, 1e6), method="bounded", options={"xatol": 1.0}).fun
    )


def expected(data: Measurements, k_sigma: float, name: str, declared: float, sign: int, most: float) -> float:
    """The end of the profile on one side, by bisection; infinite if it does not rise enough."""

    def rise(size: float) -> float:
        return profile(data, k_sigma, name, declared + sign * size)

    sizes = np.linspace(0.0, most, 100)
    heights = [rise(size) for size in sizes]
    least = min(*heights, *(profile(data, k_sigma, name, declared - sign * s) for s in sizes if name == "m"))
    if heights[-1] < least + RISE:
        return np.inf
    inside = max(k for k, height in enumerate(heights) if height < least + RISE)
    return float(
        optimize.brentq(lambda s: rise(s) - least - RISE, sizes[inside], sizes[inside + 1], xtol=1e-12)
    )


@pytest.mark.parametrize("seed", range(6))
def test_limits_are_the_ends_of_profiles(seed: int) -> None:
    """A compliance of either small or large influence, and a mass that may be too large or too small."""
    k_sigma = (2e3, 2e4)[seed % 2]
    data = measured(seed, {"k": 4e5 + k_sigma * (-1.0) ** seed, "m": 20.02, "joint": 1e-8})
    found = diagnose(structure(k_sigma), data, holdout=[])
    assert found.verdict == "adequate"
    joint = expected(data, k_sigma, "joint", 0.0, 1, 1e-6)
    sides = [expected(data, k_sigma, "m", 20.0, sign, 1.0) for sign in (1, -1)]
    # A tenth of the rise is left open, which is a twentieth of the size.
    assert found.limits["joint"].value == pytest.approx(joint, rel=0.06)
    assert found.limits["m"].value == pytest.approx(max(sides), rel=0.06)
    assert (found.limits["joint"].unit, found.limits["m"].unit) == ("m/N", "kg")


def test_an_influence_that_saturates_is_not_extrapolated() -> None:
    """A joint as compliant as the brace itself: the linear model makes the limit a fifth too small."""
    k_sigma = 1.2e5  # so wide that k makes up for most of a lost brace
    data = measured(3, {"k": 4e5, "m": 20.0, "joint": 0.0})
    data = dataclasses.replace(data, sigma=10.0 * data.sigma)
    fitter = Fitter(structure(k_sigma), data)
    store = FitStore(fitter)
    fit = store.fit(Hypothesis())
    assert fit is not None
    joint = fitter.structure.candidates[1:]
    (linear,), (found,) = bounds(store, fit, joint, linear=True), bounds(store, fit, joint)

    def wide(name: str, value: float) -> float:
        def chi2(k: float) -> float:
            white = (np.log(data.frequency) - frequencies({"k": k, "m": 20.0, name: value})) / (10.0 * SIGMA)
            return float(white @ white + ((k - 4e5) / k_sigma) ** 2)

        return float(optimize.minimize_scalar(chi2, bounds=(1e5, 2e6), method="bounded").fun)

    sizes = np.geomspace(1e-8, 1e-5, 600)
    heights = np.array([wide("joint", size) for size in sizes])
    end = sizes[np.flatnonzero(heights < min(heights.min(), wide("joint", 0.0)) + RISE)[-1]]
    assert found.size == pytest.approx(end, rel=0.06)
    assert linear.size is not None
    assert linear.size < 0.85 * end


def test_what_the_data_do_not_bound_has_no_limit() -> None:
    """A parameter that changes nothing, and one that does what an uncertain one does within a plausible range."""
    rng = np.random.default_rng(5)
    along = 5.0 * rng.standard_normal((4, 3, 3))[..., 0]
    known = {"a": {"sigma": 10.0}, "same": {"lower": -5.0, "upper": 5.0}}
    model = of_signatures({"a": along, "same": along, "paint": 0.0 * along}, 4, 3, known=known)
    found = diagnose(model, with_changes(model, rng.standard_normal((4, 3))), holdout=[])
    assert {name: limit.value for name, limit in found.limits.items()} == {"same": None, "paint": None}
    assert found.as_json()["limits"] == {"same": None, "paint": None}
    assert found.undetectable == ("same", "paint")
    assert all(one.visible_from == () for one in found.candidates)


def test_a_prior_of_a_candidate_takes_no_part_in_its_limit() -> None:
    rng = np.random.default_rng(6)
    along, changes = rng.standard_normal((2, 4, 3))
    limits = []
    for sigma in (None, (0.3,)):
        model = of_signatures({"a": 5.0 * along}, 4, 3, roles={"a": {"sigma": sigma}})
        found = diagnose(model, with_changes(model, changes), holdout=[])
        limits.append(found.limits["a"].value)
    assert limits[0] is not None
    assert limits[0] < 0.9  # within three standard deviations of the prior, beyond which nothing is plausible
    assert limits[1] == pytest.approx(limits[0], rel=1e-3)


def test_limits_are_beside_the_claim_and_leave_out_its_class() -> None:
    found = checked(frame(SIX), drawn(SIX, 14, {"brace 2": 6e4}))
    assert found.verdict == "effect_found"
    claimed = {name for effect in found.effects for name in effect.members}
    assert set(found.limits) == {one.name for one in found.candidates} - claimed
    assert all(limit.candidate == name for name, limit in found.limits.items())


def test_an_obvious_mistake_and_too_few_data_have_limits_too() -> None:
    """Frequencies in another unit say nothing about any candidate; a single row says little."""
    plain = drawn(TWO, 12)
    speeds = dataclasses.replace(plain, frequency=2 * np.pi * plain.frequency, sigma=2 * np.pi * plain.sigma)
    wrong = checked(frame(TWO), speeds)
    assert wrong.verdict == "unexplained"
    assert [limit.value for limit in wrong.limits.values()] == [None] * len(
        wrong.candidates or wrong.undetectable
    )
    row = dataclasses.replace(plain.at([0]))
    few = Measurements.from_rows(["empty"], row.frequency[:1], row.sigma[:1])
    scarce = checked(frame(TWO).subset([0]), few)
    assert scarce.verdict == "insufficient_data"
    assert set(scarce.limits) == set(wrong.limits)
    assert set(scarce.undetectable) == {name for name, limit in scarce.limits.items() if limit.value is None}


def test_a_larger_error_gives_larger_limits() -> None:
    data = drawn(SIX, 15)
    limits = [
        checked(frame(SIX), dataclasses.replace(data, sigma=factor * data.sigma)).limits
        for factor in (1.0, 2.0)
    ]
    assert all(
        (limits[1][name].value or np.inf) > 1.2 * limit.value
        for name, limit in limits[0].items()
        if limit.value is not None
    )
