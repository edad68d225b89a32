"""Verdicts on structures that are not robots, with their reasons."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from helpers.diagnoses.frame_diagnoses import CANDIDATES, TWO, causes, checked, drawn
from helpers.robots.small_structures import (
    SIGMA,
    STIFFNESS,
    LogLinear,
    errors,
    frame,
    frame_measured,
    of_signatures,
    uncertain,
    with_changes,
)
from pkmodes.loop.diagnosis import Measurements


def test_nothing_is_missing() -> None:
    found = checked(frame(TWO), drawn(TWO, 0))
    assert found.verdict == "adequate"
    assert "is noise" in found.reason
    assert found.corrected
    assert {r.name for r in found.refitted} == {"mass", "storey"}
    assert found.outliers == found.unpaired == ()


def test_a_brace_is_found_with_its_stiffness() -> None:
    rng = np.random.default_rng(1)
    true = uncertain(rng)
    found = checked(frame(TWO), frame_measured(TWO, true | {"brace 2": 6.0e4}, rng))
    assert found.verdict == "effect_found"
    (effect,) = found.effects
    assert effect.members == ("brace 2",)
    (value,) = effect.parameters
    assert value.value == pytest.approx(6.0e4, abs=4 * value.sigma)
    assert value.sigma < 1.0e4
    assert effect.p_value < 1e-6
    assert "there is a brace 2" in found.reason
    assert found.before.chi2_per_dof > found.refit.chi2_per_dof > 5.0 > 3.0 > found.after.chi2_per_dof
    assert found.before.rms_relative > found.refit.rms_relative > found.after.rms_relative
    assert {v.name for v in found.corrected} == {"mass", "storey", "brace 2"}
    for r in found.corrected:
        if r.name in true:
            assert r.value == pytest.approx(true[r.name], abs=4 * r.sigma)


def test_values_come_with_what_was_declared_and_what_can_be_seen() -> None:
    """A mass of 20 kg +- 0.1 kg and storeys of 4e5 N/m +- 3 %; a change is seen from five standard deviations."""
    rng = np.random.default_rng(1)
    found = checked(frame(TWO), frame_measured(TWO, uncertain(rng) | {"brace 2": 6.0e4}, rng))
    assert [(r.name, r.before) for r in found.refitted] == [("mass", 20.0), ("storey", 4e5)]
    assert [(r.name, r.declared, r.prior_sigma) for r in found.corrected] == [
        ("mass", 20.0, 0.1),
        ("storey", 4e5, pytest.approx(12e3)),
        ("brace 2", 0.0, None),
    ]
    ((fitted,),) = (effect.parameters for effect in found.effects)
    (brace,) = (one for one in found.candidates if one.name == "brace 2")
    (visible,) = brace.visible_from
    assert visible.sigma == pytest.approx(fitted.sigma, rel=0.1)
    assert visible.value == pytest.approx(5.0 * visible.sigma)


@pytest.mark.parametrize("seed", [20, 37, 57])
@pytest.mark.parametrize("times", [2.5, 9.0])
def test_a_brace_far_stiffer_than_its_storey_is_found_though_the_nuisances_absorb_it_at_first(
    seed: int, times: float
) -> None:
    loads, rng = {f"{load:g} kg": load for load in (0.0, 5.0, 10.0, 15.0, 20.0)}, np.random.default_rng(seed)
    truth = {**uncertain(rng), "brace 6": times * STIFFNESS}
    data = frame_measured(loads, truth, rng, storeys=6, stated=SIGMA)
    found = checked(frame(loads, storeys=6), data)
    assert causes(found) == ["brace 6"]
    (value,) = found.effects[0].parameters
    assert value.value == pytest.approx(times * STIFFNESS, abs=4 * value.sigma)


def between(position: float, apart: float = 5.6, third: float = 0.0) -> tuple[LogLinear, Measurements]:
    """Two candidates a and b that differ by so many standard deviations, and data between their best fits.

    In whitened data, u along their mean and v across: a fits at v = apart / 2, b at -apart / 2; the data are
    there at v = position, and have no other error.  A third cause w may be there, across both.
    """
    strong = 12.0
    u = np.full((3, 4), 12**-0.5)
    v = u * np.where(np.indices(u.shape).sum(axis=0) % 2, 1.0, -1.0)
    w = u * [1.0, 1.0, -1.0, -1.0]
    slope = apart / 2 / strong
    model = of_signatures({"a": u + slope * v, "b": u - slope * v, "w": w}, 3, 4)
    return model, with_changes(model, strong * u + position * v + third * w)


def test_two_different_causes_that_both_explain_the_data_are_ambiguous() -> None:
    found = checked(*between(0.6))
    assert found.verdict == "ambiguous"
    assert found.survivors == (("a",), ("b",))  # the better one first
    assert "2 different explanations remain: a; b" in found.reason
    assert checked(*between(-0.6)).survivors == (("b",), ("a",))


def test_the_nearer_of_two_causes_is_found_where_the_other_is_out_of_reach() -> None:
    for position, name in ((2.5, "a"), (-2.5, "b")):
        found = checked(*between(position))
        assert found.verdict == "effect_found"
        assert [effect.members for effect in found.effects] == [(name,)]


@pytest.mark.parametrize("third", [9.0, 30.0])
def test_with_a_second_cause_the_first_may_be_ambiguous(third: float) -> None:
    found = checked(*between(0.6, third=third))  # the second cause is found after the first, or before it
    assert found.verdict == "ambiguous"
    assert found.survivors == (("a",), ("b",))


@pytest.mark.parametrize("third", [9.0, 30.0])
def test_a_second_cause_has_a_class_of_its_own(third: float) -> None:
    found = checked(*between(0.3, apart=2.0, third=third))
    assert found.verdict == "effect_found"
    assert sorted(effect.members for effect in found.effects) == [("a", "b"), ("w",)]
    values = {v.name: v.value for effect in found.effects for v in effect.parameters}
    assert values == pytest.approx({"a": 12.0 / (1 + 1 / 144) + 0.025 / (1 + 1 / 144), "w": third}, rel=1e-3)


@pytest.mark.parametrize(
    ("name", "loaded", "by"),
    [
        ("payload", 0.35, {"payload": 0.5}),  # tells far more than any pose without it
        ("payload", 0.1, {}),  # hardly more: not worth the work
        ("a", 0.35, {}),  # an explanation says that it is there anyhow, and by how much is unknown
    ],
)
def test_a_load_is_proposed_where_it_tells_far_more(name: str, loaded: float, by: dict[str, float]) -> None:
    model, clean = between(0.3, apart=2.0)
    beside = errors(12, np.linalg.qr(model.G.reshape(12, -1))[0].T)
    data = replace(clean, frequency=clean.frequency * np.exp(SIGMA * beside))

    def with_first(times: float) -> LogLinear:
        G = 0.1 * model.G
        G[1, 2] = SIGMA * np.array([3.0 * times, 1.0 * times, 0.0])  # three times as much by a as by b
        return LogLinear(model.base, G, model.parameters, model.candidates)

    class Movable(LogLinear):
        def elsewhere(self, count: int) -> tuple[np.ndarray, LogLinear]:
            there = Movable(model.base, with_first(0.09).G, model.parameters, model.candidates)
            return np.eye(3), there

        def subset(self, setups: Sequence[int]) -> LogLinear:
            return self

        def loaded(self) -> list[tuple[dict[str, float], LogLinear]]:
            return [({name: 0.1}, with_first(0.05)), ({name: 0.5}, with_first(loaded))]

    found = checked(Movable(model.base, model.G, model.parameters, model.candidates), data)
    proposed = found.next_measurement
    assert proposed is not None
    assert proposed.pose == (0.0, 1.0, 0.0)
    assert proposed.load == by
    assert proposed.separates == ("a", "b")
    content = found.as_json()["next_measurement"]
    assert isinstance(content, dict)
    assert content.get("set", {}) == by
    assert list(content) == ["pose", "separates", "sigmas", "drives", *(["set"] if by else [])]
    assert content["drives"] is None


def test_causes_that_differ_by_less_than_the_data_show_are_one_class() -> None:
    found = checked(*between(0.3, apart=2.0))
    assert found.verdict == "effect_found"
    assert found.effects[0].members == ("a", "b")


def grounded(M: np.ndarray, K: np.ndarray) -> None:
    """The third floor leans on the neighbouring house, which is not among the candidates."""
    K[2, 2] += 2.0e5


def test_a_cause_outside_the_candidates_is_not_claimed() -> None:
    for seed in range(6):
        loads = {"empty": 0.0, "2 kg": 2.0, "5 kg": 5.0}
        found = checked(
            frame(loads, only=["first floor", "brace 1", "brace 4"]), drawn(loads, seed, change=grounded)
        )
        assert found.verdict == "unexplained"
        assert "residual is significant" in found.reason or "points to no candidate" in found.reason
        assert found.refit.chi2_per_dof > 10.0


def test_too_few_measurements_say_so() -> None:
    data = drawn({"empty": 0.0}, 4)
    few = Measurements.from_rows(["empty"] * 2, data.frequency[:2], data.sigma[:2])
    found = checked(frame({"empty": 0.0}), few)
    assert found.verdict == "insufficient_data"
    assert "2 measured modes" in found.reason
    assert "mass" in found.reason
    assert "storey" in found.reason
    assert found.undetectable == tuple(name for name in CANDIDATES if found.limits[name].value is None)
    # The frequencies determine the ratio of both values, and their priors the rest: 3 are enough.
    three = Measurements.from_rows(["empty"] * 3, data.frequency[:3], data.sigma[:3])
    assert checked(frame({"empty": 0.0}), three).verdict == "adequate"
