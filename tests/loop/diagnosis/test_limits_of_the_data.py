"""Causes that the data hardly show."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from helpers.diagnoses.frame_diagnoses import SIX, TWO, causes, checked, drawn
from helpers.robots.small_structures import altered, frame, frame_matrices
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Parameter


def test_one_setup_is_enough_for_a_large_cause() -> None:
    one = {"empty": 0.0}
    found = checked(frame(one, only=["brace 1", "brace 4"]), drawn(one, 11, {"brace 4": 2.0e5}))
    assert found.verdict == "effect_found"
    assert causes(found) == ["brace 4"]
    assert found.held_out_poses == ()


def blind(candidates: Sequence[str]) -> MatrixStructure:
    """The frame with parameters that change nothing."""
    plain = frame(TWO)
    parameters = [*plain.parameters, Parameter("paint.colour", 0.0), Parameter("door.colour", 0.0)]
    names = {
        "paint": ("paint.colour",),
        "colours": ("paint.colour", "door.colour"),
        "both": ("brace 2", "door.colour"),
    }
    causes = [Candidate(name, names.get(name, (name,))) for name in candidates]
    return altered(plain, frame_matrices(4, TWO), parameters=parameters, candidates=causes)


@pytest.mark.parametrize("candidates", [[], ["paint"], ["paint", "colours"]])
def test_an_undetectable_cause_is_neither_claimed_nor_excluded(candidates: list[str]) -> None:
    plain = checked(blind(candidates), drawn(TWO, 12))
    assert plain.verdict == "adequate"
    assert plain.undetectable == tuple(candidates)
    assert all(c.visible_from == () for c in plain.candidates)
    real = checked(blind(candidates), drawn(TWO, 12, {"brace 2": 6.0e4}))
    assert real.verdict == "unexplained"
    assert real.undetectable == tuple(candidates)


def test_a_parameter_that_changes_nothing_does_not_hide_the_others_of_its_candidate() -> None:
    found = checked(blind(["paint", "both"]), drawn(TWO, 12, {"brace 2": 6.0e4}))
    assert found.verdict == "effect_found"
    assert causes(found) == ["both"]


def test_the_smallest_visible_size_is_detected_and_a_tenth_of_it_is_not() -> None:
    examined = {c.name: c for c in checked(frame(SIX), drawn(SIX, 14)).candidates}
    size = examined["brace 2"].visible_from[0].value
    assert examined["brace 2"].detectable
    for factor, verdict in ((1.5, "effect_found"), (0.1, "adequate")):
        found = checked(frame(SIX), drawn(SIX, 14, {"brace 2": factor * size}))
        assert found.verdict == verdict
