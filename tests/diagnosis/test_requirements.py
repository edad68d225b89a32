"""The published table of requirements: counts, and which requirements hold."""

from __future__ import annotations

from dataclasses import replace

from pkmodes_rig.suites.cases import Case
from pkmodes_rig.suites.judging import CaseOutcome
from pkmodes_rig.suites.requirements import requirements
from pkmodes_rig.suites.specimens import Specimen
from pkmodes_rig.suites.suites import SUITES


def outcomes(suite: str, *states: str, **changes: object) -> list[CaseOutcome]:
    case = Case(suite, 0, "grid", Specimen("published"))
    return [replace(CaseOutcome(case, state, "", ()), **changes) for state in states]


def lines(*groups: list[CaseOutcome]) -> list[str]:
    by_suite = {suite: [o for group in groups for o in group if o.case.suite == suite] for suite in SUITES}
    return requirements(by_suite)


def test_one_wrong_answer_from_few_rows_is_one_too_many() -> None:
    (held,) = lines(outcomes("few rows", *["abstained"] * 99, "named"))
    assert held == "| few rows | confident and wrong: none | 0 of 100: 0.0 % | 0.0-3.6 % | met |"
    (broken,) = lines(outcomes("few rows", *["abstained"] * 99, "wrong"))
    assert broken.endswith("1 of 100: 1.0 % | 0.0-5.4 % | **NOT MET** |")


def test_only_clear_causes_have_to_be_named() -> None:
    suite = "one effect, realistic"
    clear = outcomes(suite, "named", "abstained", signal=6.1, values=(("a", 1.0, 0.1, 1.25),))
    hidden = outcomes(suite, "abstained", "adequate", signal=5.9)
    named, right, wrong, cover = lines(clear, hidden)
    assert "named >= 95 % | 1 of 2" in named
    assert "3 sigma >= 95 % | 1 of 1" in right
    assert "confident and wrong <= 2 % | 0 of 4" in wrong
    assert "0 of 2" in cover  # 2.5 standard deviations off, in both


def test_a_claim_that_contradicts_the_shapes_counts_where_the_truth_fits_them() -> None:
    suite = "shapes decide"
    _, against = lines(
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
    claimed, unit, channels, sigma, *_ = lines(made)
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
    *_, named, other, right = lines(made)
    assert "named >= 90 % | 1 of 2: 50.0 % |" in named
    assert "another order named: none | 1 of 2: 50.0 % |" in other
    assert "right wiring called wrong <= 1 % | 1 of 2: 50.0 % |" in right
    undecided = [replace(o, case=replace(o.case, kind="signed order, undecided")) for o in made[:2]]
    *_, named, other, _ = lines([*undecided, *made[2:]])
    assert "named >= 90 % | no cases |" in named
    assert "another order named: none | 1 of 2: 50.0 % |" in other
