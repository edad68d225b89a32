"""The suites of clear causes: what they ask for, how causes are sized, and what their page says of outcomes."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import pytest

from pkmodes_rig.robots import ROBOTS
from pkmodes_rig.suites import clear_cases, clear_suites
from pkmodes_rig.suites.clear_cases import ClearCase, ClearOutcome, measured
from pkmodes_rig.suites.clear_suites import cases, split_cases
from pkmodes_rig.suites.specimens import MACHINES
from pkmodes_rig.suites.strengths import signal

PLAIN = ClearCase("one effect", 0, "corexy", ("payload",), (9.0, 14.0))


def outcome(state: str, verdict: str, *classes: tuple[str, ...], case: ClearCase = PLAIN) -> ClearOutcome:
    return ClearOutcome(case, state, verdict, classes)


def page(*outcomes: ClearOutcome, split: tuple[tuple[ClearOutcome, ...], ...] = ()) -> list[str]:
    return clear_suites._page(outcomes, split, 60.0, 2)


def test_each_mechanism_has_forty_cases_of_each_suite_and_meets_all_effects() -> None:
    count = Counter((c.mechanism, c.suite) for c in cases())
    assert set(count.values()) == {40}
    assert len(count) == 9
    assert {c.machine for c in cases()} == {*ROBOTS, "rotary_delta", "corexy"}
    for mechanism in ("linear_delta", "rotary_delta", "corexy"):
        alone = {c.kinds[0] for c in cases() if (c.mechanism, c.suite) == (mechanism, "one effect")}
        paired = {k for c in cases() if (c.mechanism, c.suite) == (mechanism, "two effects") for k in c.kinds}
        assert alone == paired
    assert len(list(split_cases())) == 36


@pytest.mark.parametrize(
    ("kind", "least"), [("payload", 0), ("cable_stiffness", 2), ("directional_cable", 2)]
)
def test_a_cause_is_as_clear_as_was_asked_for(kind: str, least: int) -> None:
    """By the modes that were found, without those that only a tied robot has."""
    case = ClearCase("one effect", 3, "corexy", (kind,), (9.0, 14.0), outside=kind == "directional_cable")
    specimen, rows, text = measured(case)
    assert len(text.splitlines()) > len(rows) >= 12
    some = [row for row in rows if row.mode >= least]
    assert 9.0 / 1.05 <= signal(specimen, MACHINES["corexy"].points, rows=some) <= 14.0 * 1.05


def test_a_laboratory_that_cannot_see_a_cause_is_left_for_another_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    real = clear_cases._measured

    def blind(case: ClearCase) -> object:
        if case.laboratory < 2:
            raise clear_cases.UnseenError(case.label)
        return real(case)

    monkeypatch.setattr(clear_cases, "_measured", blind)
    assert measured(PLAIN)[2] == real(replace(PLAIN, laboratory=2))[2]
    assert measured(PLAIN)[2] != real(PLAIN)[2]
    monkeypatch.setattr(clear_cases, "LABORATORIES", 2)
    with pytest.raises(clear_cases.UnseenError):
        measured(PLAIN)


def test_a_wrong_claim_and_two_splits_that_contradict_each_other_break_the_requirements() -> None:
    right = outcome("named", "effect_found", ("payload", "parameter:platform.mass"))
    other = outcome("wrong", "effect_found", ("belt_mass",))
    lines = page(right, other, split=((right, right), (right, other)))
    (wrong,) = (line for line in lines if line.startswith("| corexy, all | confident and wrong"))
    assert "| 1 of 2: 50.0 % |" in wrong
    assert "NOT MET" in wrong
    (contradicting,) = (line for line in lines if "two splits claim different causes" in line)
    assert "| 1 of 2: 50.0 % |" in contradicting
    assert "NOT MET" in contradicting


def test_splits_that_claim_members_of_one_class_do_not_contradict_each_other() -> None:
    one = outcome("named", "effect_found", ("payload", "parameter:platform.mass"))
    other = outcome("named", "effect_found", ("parameter:platform.mass",))
    lines = page(one, split=((one, other, outcome("abstained", "unexplained")),))
    (line,) = (line for line in lines if "two splits claim different causes" in line)
    assert line.endswith("| 0 of 1: 0.0 % | 0.0-97.5 % | met |")


def test_the_page_says_where_the_truth_is_among_the_explanations_that_remain() -> None:
    two = replace(PLAIN, suite="two effects", kinds=("payload", "belt_mass"))
    lines = page(
        outcome("named", "effect_found", ("payload",)),
        outcome("abstained", "ambiguous", ("payload",), ("belt_mass",)),
        outcome("abstained", "ambiguous", ("frame_compliance",), ("belt_mass",)),
        outcome("abstained", "ambiguous", ("belt_mass + payload", "payload"), case=two),
        outcome("abstained", "ambiguous", ("payload",), ("belt_mass",), case=two),
        outcome("abstained", "unexplained"),
    )
    text = "In 2 of these 5 cases, the true explanation is among several that remain."
    assert text in lines
