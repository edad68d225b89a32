"""How probable explanations that a verdict refuses are counted, and what is claimed without the rule that refuses."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from pkmodes.loop.diagnosis.posterior import probabilities
from pkmodes.loop.diagnosis.posterior.document import ClassProbability, PairProbability, Probabilities
from pkmodes.loop.diagnosis.verdict import rules
from studies import hard_suites, judging, refused
from studies.cases import Case
from studies.refused import Members
from studies.running import Outcome
from studies.specimens import Specimen

PAIR = ("belt_mass", "payload")
OTHER_PAIR = ("belt_mass", "gearbox_inertia")


def case(*names: str, outside: bool = False, number: int = 0) -> Case:
    truth = Specimen("tower", outside={"tuned_absorber": 0.1} if outside else {})
    return Case("one effect", number, "middle", truth, names)


@pytest.mark.parametrize(
    ("truth", "members", "it_is"),
    [
        (case("payload"), ("belt_mass", "payload"), "right"),
        (case("payload"), ("belt_mass",), "wrong"),
        (case(), ("payload",), "wrong"),
        (case(outside=True), ("payload",), "wrong"),
        (case("gearbox_inertia"), ("parameter:motor.gear_ratio",), "right"),
        (case(*PAIR), ("payload",), "one of two"),
        (case(*PAIR), ("clamp_compliance",), "wrong"),
        (case(*PAIR), (OTHER_PAIR, PAIR[::-1]), "right"),
        (case(*PAIR), (OTHER_PAIR,), "wrong"),
        (case("payload"), (PAIR,), "wrong"),
    ],
)
def test_a_class_or_pair_is_held_against_the_truth(truth: Case, members: Members, it_is: str) -> None:
    assert refused.held(truth, members) == it_is


@pytest.mark.parametrize(
    ("members", "verdict", "classes", "claimed"),
    [
        (("payload", "belt_mass"), "effect_found", (("belt_mass", "link_compliance"),), True),
        (("payload",), "effect_found", (("belt_mass",),), False),
        (("payload",), "ambiguous", (("payload",),), False),
        (("payload",), "effect_found", (("payload",), ("belt_mass",)), False),
        ((OTHER_PAIR, PAIR), "effect_found", (("payload",), ("belt_mass",)), True),
        ((PAIR,), "effect_found", (("payload",),), False),
        ((PAIR,), "effect_found", (("payload", "belt_mass"), ("gearbox_inertia",)), False),
    ],
)
def test_a_verdict_claims_what_a_class_or_pair_says(
    members: Members, verdict: str, classes: tuple[tuple[str, ...], ...], claimed: bool
) -> None:
    outcome = Outcome(case(), "named", verdict, classes=classes)
    assert refused.claimed(members, outcome) is claimed


def test_the_best_is_a_class_or_a_pair_even_where_something_outside_is_more_probable() -> None:
    one, two = ClassProbability(("payload",), 0.2), PairProbability((PAIR,), 0.3)
    assert refused.best(Probabilities(0.0, 0.5, (one,), (two,))) == ((PAIR,), 0.3)
    assert refused.best(Probabilities(0.5, 0.3, (one,), ())) == (("payload",), 0.2)
    assert refused.best(Probabilities(0.5, 0.5, (), ())) is None


@pytest.fixture(scope="module")
def undecided() -> Case:
    """A machine some of whose modes were missed, of which a rule says that the data are too few."""
    return list(hard_suites.modes_missed())[4]


def test_a_probability_as_if_accepted_is_that_with_the_doubt_of_an_accepted_one(
    undecided: Case, monkeypatch: pytest.MonkeyPatch
) -> None:
    doubted = judging.run(undecided)
    monkeypatch.setattr(probabilities, "DOUBT_IF_REFUSED", probabilities.DOUBT_IF_ACCEPTED)
    accepted = judging.run(undecided)
    assert doubted.verdict == accepted.verdict == "unexplained"
    assert doubted.probabilities is not None
    assert accepted.probabilities is not None
    members, stated = refused.best(doubted.probabilities) or ((), 0.0)
    same, wanted = refused.best(accepted.probabilities) or ((), 0.0)
    assert members == same
    assert stated < 0.75 < 0.95 < wanted
    assert refused.as_accepted(stated, doubted.verdict, doubted.rule) == pytest.approx(wanted, abs=0.003)


def test_the_doubt_is_that_of_the_rule() -> None:
    assert refused.as_accepted(0.97, "ambiguous", "claims.several") == pytest.approx(0.97)
    assert refused.as_accepted(0.75, "unexplained", "claims.errors") == pytest.approx(0.97)
    assert refused.as_accepted(0.45, "unexplained", "open.real") == pytest.approx(0.97)
    assert refused.as_accepted(0.75, "unexplained", "adequacy.shapes") == pytest.approx(0.97)


def test_a_refused_case_runs_again_without_the_rule_that_refused(undecided: Case) -> None:
    before = rules.CLAIM_RULES
    line = refused.line_of(undecided, judging.run)
    assert rules.CLAIM_RULES is before
    assert (line["rule"], line["held"], line["claimed"]) == ("claims.not_specific", "right", False)
    assert line["without"] == ["right", "claims.found"]


def test_cases_run_in_turns_of_one_of_each_suite_and_more_of_them_in_the_same_order() -> None:
    def run(one: Any) -> Outcome[Any]:
        return Outcome(one, "adequate")

    every = [(suite, case(number=k), run) for suite, count in (("a", 5), ("b", 2)) for k in range(count)]
    some = refused.in_turn(every, 3)
    assert [suite for suite, _, _ in some] == ["a", "b", "a", "b", "a"]
    more = refused.in_turn(every, 5)
    assert more[:5] == some
    assert len({(suite, one.number) for suite, one, _ in more}) == 7


def test_clear_causes_are_drawn_from_all_machines_together() -> None:
    machines = ("tower, clear, one effect", "corexy, clear, one effect")
    every = [
        (suite, case(number=k), judging.run) for suite in (*machines, "corexy, one effect") for k in range(9)
    ]
    assert [suite == "corexy, one effect" for suite, _, _ in refused.in_turn(every, 4)] == [False, True] * 4
    assert {suite for suite, _, _ in refused.in_turn(every, 18)} > {*machines}


def test_every_case_has_a_name_of_its_own() -> None:
    every = [(suite, one.label) for suite, one, _ in refused.cases()]
    assert len(every) == len({*every})
    assert {"linear delta, units and wiring", "hexapod, clear, one effect"} <= {suite for suite, _ in every}


def line(
    rule: str, probability: float, held: str, *, claimed: bool = False, again: str = ""
) -> dict[str, Any]:
    verdict = "effect_found" if claimed else "ambiguous" if rule == "claims.several" else "unexplained"
    return {
        **{"case": f"suite: {rule} {probability}, seed 1", "suite": "suite", "names": ["payload"]},
        **{"outside": False, "rule": rule, "verdict": verdict, "members": ["payload", "belt_mass"]},
        **{"probability": probability, "accepted": refused.as_accepted(probability, verdict, rule)},
        **{"held": held, "claimed": claimed},
        **({"without": [again, "claims.found" if again != "refused" else "claims.errors"]} if again else {}),
    }


def test_the_tables_count_claimed_and_refused_cases_by_rule() -> None:
    found = [
        line("claims.found", 0.97, "right", claimed=True),
        line("claims.found", 0.96, "wrong", claimed=True),
        line("claims.found", 0.9, "wrong", claimed=True),
        line("claims.several", 0.96, "right", again="right"),
        line("claims.one_row", 0.74, "right", again="right"),
        line("claims.one_row", 0.741, "wrong", again="refused"),
        line("claims.one_row", 0.5, "right", again="wrong"),
        line("open.real", 0.445, "one of two"),
        {
            "case": "suite: no search, seed 1",
            "suite": "suite",
            "rule": "before.unit",
            "verdict": "unexplained",
        },
        {"case": "suite: failed, seed 1", "suite": "suite", "rule": "", "verdict": "failed"},
    ]
    tables = refused.tables(found, found[4:6], 1)
    facts = tables["summary"].values()
    assert [facts[name] for name in ("cases drawn", "suites", "with a class or pair")] == ["10", "1", "8"]
    assert (facts["cases with few rows"], facts["failed"]) == ("2", "1")
    shares, rules = (
        {tuple(row[:2]): " ".join(row[2:]).strip() for row in tables[name].rows}
        for name in ("shares", "rules")
    )
    assert shares["as stated", "claimed"] == "2 1 0 1 0.50"
    assert shares["as stated", "refused"] == "1 1 0 0 1.00"
    assert shares["as stated", "all"] == "3 2 0 1 0.67"
    assert shares["as if accepted", "refused"] == "4 2 1 1 0.50"
    assert rules["drawn", "claims.one_row"] == "3 2 1 0 1 0.50 0"
    assert rules["few rows", "claims.one_row"] == "2 2 1 0 1 0.50 0"
    assert rules["drawn", "claims.several"] == "1 1 1 0 0 1.00 1"
    assert rules["drawn", "open.real"] == "1 1 0 1 0 0.00 0"
    assert ("claims.one_row", "3", "1", "0", "1", "1", "claims.errors") in tables["without"].rows
    assert sum(row[2:4] == ("payload", "payload or belt_mass") for row in tables["cases"].rows) == 4


def test_a_run_that_was_stopped_goes_on_and_only_what_was_asked_for_is_counted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    tried = []

    def run(one: Any) -> Outcome[Any]:
        tried.append(one.number)
        if one.number == 3:
            raise ValueError("no such mode")
        return Outcome(one, "adequate", "adequate", rule="adequacy.adequate")

    monkeypatch.setattr(refused, "cases", lambda: iter([("suite", case(number=k), run) for k in range(6)]))
    for limit in ("4", "6", "2"):
        monkeypatch.setattr("sys.argv", ["refused", "--kept", str(tmp_path / "kept.jsonl"), "--limit", limit])
        refused.main()
    assert sorted(tried) == list(range(6))
    printed = capsys.readouterr()
    counted = [f"|cases drawn|{count}|" in printed.out for count in range(8)]
    assert counted == [count in (2, 4, 6) for count in range(8)]
    assert "|failed|1|" in printed.out
    assert "no such mode" in printed.err
