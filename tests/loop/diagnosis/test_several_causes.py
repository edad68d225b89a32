"""Two causes at once, and candidates that the data cannot tell apart."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from helpers.diagnoses.frame_diagnoses import CANDIDATES, SIX, TWO, causes, checked, drawn
from helpers.robots.small_structures import altered, each, frame, frame_derivatives, frame_matrices
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Parameter


def test_two_causes_are_found_together() -> None:
    found = checked(frame(SIX), drawn(SIX, 6, {"brace 2": 6.0e4, "first floor": 3.0}))
    assert found.verdict == "effect_found"
    assert causes(found) == ["brace 2", "first floor"]
    for effect, true in zip(sorted(found.effects, key=lambda e: e.name), (6.0e4, 3.0), strict=True):
        (value,) = effect.parameters
        assert value.value == pytest.approx(true, abs=4 * value.sigma)
        assert value.sigma < 0.3 * true
    assert found.after.chi2_per_dof < 2.0


def twins(loads: dict[str, float], order: Sequence[str]) -> MatrixStructure:
    """The frame with a second candidate with three times the effect of brace 2."""
    plain = frame(loads)
    matrices, derivatives = frame_matrices(4, loads), frame_derivatives(4)

    def more(values, setup):
        M, K = matrices(values, setup)
        return M, K + 3.0 * values["twin"] * derivatives(values, setup, "brace 2")[1]

    def rates(values, setup, name):
        dM, dK = derivatives(values, setup, "brace 2" if name == "twin" else name)
        return dM, (3.0 if name == "twin" else 1.0) * dK

    parameters = [*plain.parameters, Parameter("twin", 0.0, lower=0.0)]
    return altered(plain, more, derivatives=rates, parameters=parameters, candidates=each(order))


def test_equivalent_candidates_are_one_class_in_any_order() -> None:
    for order in ([*CANDIDATES, "twin"], ["twin", *CANDIDATES[::-1]]):
        found = checked(twins(TWO, order), drawn(TWO, 7, {"brace 2": 1.0e5}))
        assert found.verdict == "effect_found"
        (effect,) = found.effects
        assert set(effect.members) == {"brace 2", "twin"}
        (brace,), (twin,) = effect.alternatives["brace 2"], effect.alternatives["twin"]
        assert twin.value == pytest.approx(brace.value / 3.0, rel=1e-3)
        assert twin.sigma == pytest.approx(brace.sigma / 3.0, rel=1e-3)


def test_equivalent_candidates_are_one_class_beside_a_second_cause() -> None:
    truth = {"brace 2": 6.0e4, "first floor": 3.0}
    found = checked(twins(SIX, ["first floor", "twin", "brace 2", "brace 4"]), drawn(SIX, 6, truth))
    assert found.verdict == "effect_found"
    assert sorted(sorted(effect.members) for effect in found.effects) == [
        ["brace 2", "twin"],
        ["first floor"],
    ]


def test_a_cause_of_several_parameters_is_found_as_one() -> None:
    plain = frame(TWO)
    causes = [Candidate("braces", ("brace 1", "brace 2", "brace 3")), *each(["first floor"])]
    whole = altered(plain, frame_matrices(4, TWO), candidates=causes)
    truth = {"brace 1": 5.0e4, "brace 2": 1.0e5, "brace 3": 2.0e4}
    found = checked(whole, drawn(TWO, 8, truth))
    assert found.verdict == "effect_found"
    (effect,) = found.effects
    assert effect.name == "braces"
    for value in effect.parameters:
        assert value.value == pytest.approx(truth[value.name], abs=4 * value.sigma)
