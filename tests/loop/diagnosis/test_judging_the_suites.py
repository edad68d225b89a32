"""The suites on the virtual rig: how outcomes are judged, what is required of them, and what their tables say.

How often each verdict is right is measured by the whole suites, in docs/reference/results.md.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from typing import Any

import pytest
from msgspec import structs

from pkmodes import updating
from pkmodes.loop.diagnosis.verdict.findings import Finding
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes_rig.laboratory import Laboratory
from pkmodes_rig.measurements import Identified
from pkmodes_rig.robots import ROBOTS, read
from studies import campaign_machines, clear_cases, clear_suites, damping_cases, diagnosis
from studies.campaign_cases import CampaignOutcome
from studies.campaign_table import table
from studies.cases import Case, measured, tried
from studies.clear_cases import ClearCase, ClearOutcome
from studies.clear_suites import ClearCauses
from studies.damping_cases import DampingOutcome
from studies.deciding import Line, counts, rightly
from studies.judging import MENTIONS, CaseOutcome, judged, physical, set_aside_blindly
from studies.requirements import requirements
from studies.running import _attempt
from studies.specimens import MACHINES, Specimen, measurements
from studies.strengths import signal
from studies.suites import SUITES


def of_kind(suite: str, kind: str) -> list[Case]:
    """Cases of a robot, the last of which has the largest cause."""
    return [c for c in SUITES[suite]() if (c.kind, c.truth.machine) == (kind, "published")]


@pytest.fixture(scope="module")
def template() -> Diagnosis:
    """A verdict for the judge of the suites, from which others are invented."""
    text = measured(of_kind("nothing missing", "nothing")[0])
    return updating.diagnose(read("published"), measurements(text))


def test_a_rule_decides_rightly_by_the_truth_of_the_case() -> None:
    (nothing, *_), (*_, lacking) = of_kind("nothing missing", "nothing"), of_kind("one effect", "payload")
    outside = next(case for case in SUITES["outside the catalogue"]() if case.truth.outside)
    drives = next(case for case in SUITES["wrong drives"]() if not case.names)

    def right(case: Case, verdict: str, rule: str = "", **rest: Any) -> bool:
        state = {"effect_found": "named", "adequate": "adequate"}.get(verdict, "abstained")
        return rightly(case, CaseOutcome(case, **{"state": state, "verdict": verdict, "rule": rule} | rest))

    assert right(nothing, "adequate")
    assert not right(lacking, "adequate")
    assert not right(drives, "adequate")
    assert not right(nothing, "adequate", state="wrong")  # rows set aside blindly
    assert right(lacking, "effect_found")
    assert not right(lacking, "effect_found", state="wrong")
    assert right(lacking, "ambiguous", classes=(("belt_mass + payload",), ("frame_compliance",)))
    assert not right(lacking, "ambiguous", classes=(("belt_mass",), ("frame_compliance",)))
    assert right(lacking, "unexplained", signal=5.0)
    assert not right(lacking, "unexplained", signal=7.0)
    assert right(outside, "unexplained", signal=50.0)
    assert not right(nothing, "unexplained")
    assert right(nothing, "insufficient_data")
    assert right(drives, "unexplained", "before.drives")
    assert not right(outside, "unexplained", "before.drives")
    assert not right(drives, "unexplained", "before.wiring")
    loaded = damping_cases.Case("rails", "published", "free", 103, 1)
    for signal_of_payload, expected in ((5.0, True), (7.0, False)):
        said = DampingOutcome(loaded, "adequate", "unexplained", signal=signal_of_payload)
        assert rightly(loaded, said) is expected


def test_verdicts_are_counted_by_their_rules() -> None:
    lines = [Line("clear", str(n), rule, n == 0) for n, rule in enumerate(("a.b", "a.b", "a.c"))]
    assert counts(lines) == {"a.b": (2, 1), "a.c": (1, 0)}


def test_a_class_with_none_of_the_causes_is_wrong_whatever_else_is_found(template: Diagnosis) -> None:
    """The judge of the suites, on invented verdicts."""
    finding = Finding("payload", ("payload",), (), {}, 0.0, "")
    assert judged(("payload",), template) == "adequate"
    assert judged(("payload",), replace(template, verdict="ambiguous")) == "abstained"

    def state(truths: tuple[str, ...], *classes: tuple[str, ...]) -> str:
        found = tuple(replace(finding, name=members[0], members=members) for members in classes)
        return judged(truths, replace(template, verdict="effect_found", effects=found))

    assert state(("payload",), ("belt_mass", "payload")) == "named"
    assert state(("payload",), ("belt_mass",)) == "wrong"
    assert state((), ("belt_mass",)) == "wrong"
    assert state(("payload",), ("payload",), ("belt_mass",)) == "wrong"
    assert state(("payload", "belt_mass"), ("payload",)) == "partly"
    assert state(("payload", "belt_mass"), ("payload", "belt_mass")) == "partly"
    assert state(("payload", "belt_mass"), ("belt_mass", "payload"), ("payload",)) == "named"
    assert state(("gearbox_inertia",), ("parameter:motor.gear_ratio",)) == "named"


def test_a_correction_of_the_measurement_is_right_where_poses_are_not_where_the_file_says(
    template: Diagnosis,
) -> None:
    finding = Finding("measurement:yaw", ("measurement:yaw",), (), {}, 0.0, "")
    turned = replace(template, verdict="effect_found", effects=(finding,))
    assert judged(("measurement:offset.z",), turned) == "named"
    assert judged((), turned) == judged(("payload",), turned) == "wrong"
    assert not physical((), turned)
    both = replace(finding, members=("measurement:yaw", "payload"))
    assert physical((), replace(turned, effects=(both,)))
    assert not physical(("payload",), replace(turned, effects=(both,)))


def test_a_row_is_set_aside_blindly_where_the_others_could_not_tell(template: Diagnosis) -> None:
    few = next(c for c in SUITES["few rows"]() if c.number == 60)
    row = structs.replace(template.rows[0], held_out=False, outlier=False)
    outlier = structs.replace(row, outlier=True)
    for rows, blind in (
        ((row,) * 4, False),
        ((row,) * 3 + (outlier,), True),
        ((row,) * 4 + (outlier,), False),
    ):
        assert (
            set_aside_blindly(few, replace(template, rows=rows)) is blind
        )  # two uncertain values, two to spare


@pytest.mark.parametrize(
    ("kind", "note"),
    [
        ("unit", "all frequencies are 6.28 times the predicted ones: is the unit rad/s?"),
        ("channels", "shapes fit no explanation unless x_1 and x_2 are exchanged"),
        ("sigma", "the stated standard deviations are far too large"),
    ],
)
def test_notes_are_recognised(kind: str, note: str) -> None:
    assert [name for name, mention in MENTIONS.items() if mention.search(note)] == [kind]


def test_the_predicted_signal_is_that_of_the_modes_that_were_found() -> None:
    plain = of_kind("one effect", "gearbox_compliance")[-1]
    trial = tried(replace(plain, laboratory=Laboratory()))

    def given(rows: list[Identified] | None) -> float:
        return signal(plain.truth, plain.points, holdout=["P3", "P9"], rows=rows)

    everything = given(None)
    assert given(trial.rows) == pytest.approx(everything, rel=1e-6)
    lower, upper = ([row for row in trial.rows if (row.mode < 6) is low] for low in (True, False))
    assert 0.0 < given(lower) < everything
    assert 0.0 < given(upper) < 0.7 * everything  # the lower ones show a soft gearbox
    assert given([replace(row, sigma=2.0 * row.sigma) for row in trial.rows]) < 0.7 * everything


def outcomes(suite: str, *states: str, **changes: object) -> list[CaseOutcome]:
    case = Case(suite, 0, "grid", Specimen("published"))
    return [replace(CaseOutcome(case, state, "", ()), **changes) for state in states]


def required(*groups: list[CaseOutcome]) -> list[str]:
    by_suite = {suite: [o for group in groups for o in group if o.case.suite == suite] for suite in SUITES}
    return [in_words(row) for row in requirements(by_suite)]


def in_words(row: tuple[str, ...]) -> str:
    group, what, number, of, rate, low, high, met = row
    measured = f"{number} of {of}: {rate} % | {low}-{high} %" if of != "0" else "no cases"
    return f"| {group} | {what} | {measured} | {met} |"


def test_one_wrong_answer_from_few_rows_is_one_too_many() -> None:
    (held,) = required(outcomes("few rows", *["abstained"] * 99, "named"))
    assert held == "| few rows | confident and wrong: none | 0 of 100: 0.0 % | 0.0-3.6 % | met |"
    (broken,) = required(outcomes("few rows", *["abstained"] * 99, "wrong"))
    assert broken.endswith("1 of 100: 1.0 % | 0.0-5.4 % | NOT MET |")


def test_only_clear_causes_have_to_be_named() -> None:
    suite = "one effect, realistic"
    clear = outcomes(suite, "named", "abstained", signal=6.1, values=(("a", 1.0, 0.1, 1.25),))
    hidden = outcomes(suite, "abstained", "adequate", signal=5.9)
    named, right, wrong, cover = required(clear, hidden)
    assert "named >= 95 % | 1 of 2" in named
    assert "3 sigma >= 95 % | 1 of 1" in right
    assert "confident and wrong <= 2 % | 0 of 4" in wrong
    assert "0 of 2" in cover  # 2.5 standard deviations off, in both


def test_an_exception_counts_as_a_clear_cause_that_was_not_named() -> None:
    """In the requirements, and in the table of the power."""

    def broken(case: object) -> Any:
        raise RuntimeError("no")

    failed = _attempt(broken, CaseOutcome, of_kind("one effect", "payload")[0])
    assert (failed.state, failed.signal) == ("failed", math.inf)
    assert failed.reason.strip().endswith("RuntimeError: no")
    named, *_ = required([failed])
    assert "named >= 95 % | 0 of 1" in named
    assert diagnosis._power([failed]).rows[-1] == ("over 20", "1", "0", "0", "0", "0")
    machine = next(case for case in campaign_machines.cases(1, 6) if case.names)
    asked = {what: found for what, _, found, _ in table([_attempt(broken, CampaignOutcome, machine)])}
    assert asked["cause named, signal > 8 sigma, at least 40 machines"].startswith("0 of 1")
    with pytest.raises(RuntimeError, match="no"):
        _attempt(broken, None, machine)


def test_a_claim_that_contradicts_the_shapes_counts_where_the_truth_fits_them() -> None:
    suite = "shapes decide"
    _, against = required(
        outcomes(suite, "named", mac=(0.89, 0.985)),
        outcomes(suite, "named", mac=(0.95, 0.985)),
        outcomes(suite, "named", mac=(0.5, 0.97)),
        outcomes(suite, "abstained"),
    )
    assert "| 1 of 4: 25.0 % |" in against
    assert "NOT MET" in against


def test_mistakes_have_to_be_noted_and_no_cause_claimed() -> None:
    suite = "units and wiring"
    made = []
    for mistake, noted in (("rad/s for Hz", True), ("rpm for Hz", False), ("sign of one channel", None)):
        (o,) = outcomes(suite, "abstained", noted=noted)
        made.append(replace(o, case=replace(o.case, mistake=mistake)))
    made += outcomes(suite, "wrong", physical=True)
    claimed, unit, channels, sigma, *_ = required(made)
    assert "| 1 of 4: 25.0 % |" in claimed
    assert "NOT MET" in claimed
    assert "| 1 of 2: 50.0 % |" in unit
    assert "no cases" in channels
    assert "no cases" in sigma


def test_signed_orders_have_to_be_named_and_right_wirings_left_alone() -> None:
    suite = "units and wiring"
    made = []
    for mistake, rewired, misnamed in (
        ("p_y, -p_x, p_z", True, False),
        ("p_y, p_x, p_z", False, True),
        ("rad/s for Hz", False, False),
        ("rpm for Hz", True, False),
        ("p_y and p_z exchanged", None, False),
    ):
        (o,) = outcomes(suite, "abstained", rewired=rewired, misnamed=misnamed)
        made.append(replace(o, case=replace(o.case, mistake=mistake)))
    *_, named, other, right = required(made)
    assert "named >= 90 % | 1 of 2: 50.0 % |" in named
    assert "another order named: none | 1 of 2: 50.0 % |" in other
    assert "right wiring called wrong <= 1 % | 1 of 2: 50.0 % |" in right
    undecided = [replace(o, case=replace(o.case, kind="signed order, undecided")) for o in made[:2]]
    *_, named, other, _ = required([*undecided, *made[2:]])
    assert "named >= 90 % | no cases |" in named
    assert "another order named: none | 1 of 2: 50.0 % |" in other


PAYLOAD = ClearCase("one effect", 0, "corexy", ("payload",), (9.0, 14.0))


def outcome(state: str, verdict: str, *classes: tuple[str, ...], case: ClearCase = PAYLOAD) -> ClearOutcome:
    return ClearOutcome(case, state, verdict, classes)


def of_clear(*outcomes: ClearOutcome, split: tuple[tuple[ClearOutcome, ...], ...] = ()) -> list[str]:
    return [in_words(row) for row in ClearCauses(split).tables(outcomes)["requirements"].rows]


def test_each_mechanism_has_forty_clear_cases_of_each_suite_and_meets_all_effects() -> None:
    every = list(clear_suites.cases())
    count = Counter((c.mechanism, c.suite) for c in every)
    assert set(count.values()) == {40}
    assert len(count) == 9
    assert {c.machine for c in every} == {*ROBOTS, "rotary_delta", "corexy"}
    for mechanism in ("linear_delta", "rotary_delta", "corexy"):
        alone = {c.kinds[0] for c in every if (c.mechanism, c.suite) == (mechanism, "one effect")}
        paired = {k for c in every if (c.mechanism, c.suite) == (mechanism, "two effects") for k in c.kinds}
        assert alone == paired
    assert len(list(clear_suites.split_cases())) == 36


@pytest.mark.parametrize(
    ("kind", "least"), [("payload", 0), ("cable_stiffness", 2), ("directional_cable", 2)]
)
def test_a_cause_is_as_clear_as_was_asked_for(kind: str, least: int) -> None:
    """By the modes that were found, without those that only a tied robot has."""
    case = ClearCase("one effect", 3, "corexy", (kind,), (9.0, 14.0), outside=kind == "directional_cable")
    specimen, rows, text = clear_cases.measured(case)
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
    assert clear_cases.measured(PAYLOAD)[2] == real(replace(PAYLOAD, laboratory=2))[2]
    assert clear_cases.measured(PAYLOAD)[2] != real(PAYLOAD)[2]
    monkeypatch.setattr(clear_cases, "LABORATORIES", 2)
    with pytest.raises(clear_cases.UnseenError):
        clear_cases.measured(PAYLOAD)


def test_a_wrong_claim_and_two_splits_that_contradict_each_other_break_the_requirements() -> None:
    right = outcome("named", "effect_found", ("payload", "parameter:platform.mass"))
    other = outcome("wrong", "effect_found", ("belt_mass",))
    lines = of_clear(right, other, split=((right, right), (right, other)))
    (wrong,) = (line for line in lines if line.startswith("| corexy, all | confident and wrong"))
    assert "| 1 of 2: 50.0 % |" in wrong
    assert "NOT MET" in wrong
    (contradicting,) = (line for line in lines if "two splits claim different causes" in line)
    assert "| 1 of 2: 50.0 % |" in contradicting
    assert "NOT MET" in contradicting


def test_splits_that_claim_members_of_one_class_do_not_contradict_each_other() -> None:
    one = outcome("named", "effect_found", ("payload", "parameter:platform.mass"))
    other = outcome("named", "effect_found", ("parameter:platform.mass",))
    lines = of_clear(one, split=((one, other, outcome("abstained", "unexplained")),))
    (line,) = (line for line in lines if "two splits claim different causes" in line)
    assert line.endswith("| 0 of 1: 0.0 % | 0.0-97.5 % | met |")


def test_the_summary_says_where_the_truth_is_among_the_explanations_that_remain() -> None:
    two = replace(PAYLOAD, suite="two effects", kinds=("payload", "belt_mass"))
    some = [
        outcome("named", "effect_found", ("payload",)),
        outcome("abstained", "ambiguous", ("payload",), ("belt_mass",)),
        outcome("abstained", "ambiguous", ("frame_compliance",), ("belt_mass",)),
        outcome("abstained", "ambiguous", ("belt_mass + payload", "payload"), case=two),
        outcome("abstained", "ambiguous", ("payload",), ("belt_mass",), case=two),
        outcome("abstained", "unexplained"),
    ]
    facts = ClearCauses().facts(some)
    assert (facts["not named"], facts["not named, but among several that remain"]) == (5, 2)
