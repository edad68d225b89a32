"""Verdicts on the virtual test rig: a few cases of the suites of `tests/studies`, run as a user would run them.

The rig is MuJoCo's physics, and the true values of the uncertain parameters are drawn from their priors.  How often
each verdict is right is measured by the whole suites, in docs/reference/results.md; here each behaviour is held.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import pytest

from helpers.golden.case_book import frozen
from pkmodes import updating
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes_rig.robots import read
from studies.cases import Case, measured
from studies.judging import CaseOutcome, run
from studies.requirements import CLEAR, MAC_CLAIMED, MAC_OTHER
from studies.specimens import measurements, with_wrong
from studies.suites import SUITES

#: Standard deviations within which a value is right.
RIGHT = 3.0

PLAIN = [
    ("published", "gearbox_compliance"),
    ("published", "belt_mass"),
    ("tower", "clamp_compliance"),
    ("tower", "cable_stiffness"),
    ("asymmetric", "servo_stiffness"),
    ("asymmetric", "link_compliance"),
]
WRONG = [("published", "link.mass"), ("tower", "pulley.radius"), ("asymmetric", "axis.3.link.length")]

#: Cases of the hard suites, robots and buildings, all kinds.
FEW_ROWS = [*range(2, 60, 9), *range(60, 120, 7)]
OUTLIERS = [0, 4, 12, 20, 24, 28, *range(30, 60, 4)]
#: Seed of published cases that showed a mistake of the diagnosis.
PUBLISHED = 20261201
MISTAKEN = ["rad/s for Hz", "rpm for Hz", "all shapes equal", "sigma far too large"]


@pytest.fixture(autouse=True)
def _frozen(monkeypatch: pytest.MonkeyPatch, pytestconfig: pytest.Config) -> None:
    """Every outcome is compared with the golden one, too (tests/golden)."""
    monkeypatch.setitem(globals(), "run", frozen(run, "on_the_rig", pytestconfig))


def case(suite: str, kind: str, robot: str = "", place: int = -1) -> Case:
    """One of the cases of a kind; if there are several strengths, the last is the largest."""
    found = [c for c in SUITES[suite]() if c.kind == kind and robot in ("", c.truth.machine)]
    return found[place]


def numbered(suite: str, number: int) -> Case:
    return next(c for c in SUITES[suite]() if c.number == number)


def assert_named(outcome: CaseOutcome) -> None:
    assert outcome.state == "named", outcome.reason
    assert outcome.values
    for name, found, sigma, true in outcome.values:
        assert abs(found - true) < RIGHT * sigma, name


def diagnosed(text: str, robot: str, candidates: Sequence[str] | None = None) -> Diagnosis:
    return updating.diagnose(read(robot), measurements(text), candidates=candidates, terms=False)


@pytest.mark.parametrize("number", range(12))
def test_a_robot_that_lacks_nothing_is_adequate(number: int) -> None:
    outcome = run(case("nothing missing", "nothing", place=number))
    assert outcome.verdict == "adequate", outcome.reason


@pytest.mark.parametrize(("robot", "effect"), PLAIN)
def test_an_effect_is_found_with_its_value(robot: str, effect: str) -> None:
    assert_named(run(case("one effect", effect, robot)))


@pytest.mark.parametrize(("robot", "path"), WRONG)
def test_a_wrong_declared_value_is_found_with_the_true_one(robot: str, path: str) -> None:
    assert_named(run(case("wrong parameter", f"parameter:{path}", robot)))


def test_two_effects_are_told_apart() -> None:
    assert_named(run(case("two effects", "servo_stiffness + belt_mass")))


@pytest.mark.parametrize(
    ("kind", "robot"),
    [("worn_belt", "asymmetric"), ("pulley_mount", "published"), ("one_span", "tower"), ("hose", "tower")],
)
def test_a_cause_outside_the_catalogue_is_not_given_a_name_from_it(kind: str, robot: str) -> None:
    outcome = run(case("outside the catalogue", kind, robot))
    assert outcome.verdict in ("ambiguous", "unexplained"), outcome.reason


@pytest.mark.parametrize("robot", ["published", "asymmetric"])
def test_one_soft_gearbox_of_three_is_not_claimed_but_named(robot: str) -> None:
    outcome = run(case("outside the catalogue", "one_gearbox", robot))
    assert outcome.verdict == "unexplained"
    assert "gearbox_compliance of psi_2 alone" in outcome.reason


def test_a_frame_that_yields_in_one_oblique_direction_is_not_taken_for_one_that_yields_equally_in_all() -> (
    None
):
    outcome = run(replace(numbered("outside the catalogue", 43), seed=PUBLISHED))
    assert outcome.verdict == "unexplained"
    assert "what it leaves still points to a candidate, frame_compliance.compliance_" in outcome.reason


def test_a_wrong_belt_is_named_though_unequal_belts_would_do_as_well() -> None:
    outcome = run(replace(numbered("wrong parameter", 20), seed=PUBLISHED))
    assert_named(outcome)
    ((name, *others),) = outcome.classes
    assert name == "parameter:axis.2.belt.width"
    assert "axis_belt_stiffness" in others


def test_a_moving_frame_is_found_where_its_first_fit_paired_a_mode_wrongly() -> None:
    assert_named(run(replace(numbered("modes missed", 32), seed=PUBLISHED)))


def test_one_heavy_carriage_of_three_is_named_and_found_when_it_is_a_candidate() -> None:
    truth = with_wrong("published", "axis.2.carriage.mass", 0.3)
    path = "parameter:axis.2.carriage.mass"
    text = measured(Case("special", 1000, "scattered", truth, (path,)))
    found = diagnosed(text, "published")
    assert found.verdict == "unexplained"
    assert f"but {path} would" in found.reason
    (effect,) = diagnosed(text, "published", ["effects", path]).effects
    assert effect.members == (path,)
    (value,) = effect.parameters
    assert abs(value.value - truth.values["axis.2.carriage.mass"]) < RIGHT * value.sigma


def test_a_belt_of_one_axis_is_in_the_class_of_unequal_belts() -> None:
    truth = with_wrong("published", "axis.1.belt.width", 0.0008)
    found = diagnosed(measured(Case("special", 1001, "grid", truth)), "published")
    (effect,) = found.effects
    assert effect.name == "axis_belt_stiffness"
    assert "parameter:axis.1.belt.width" in effect.members


def test_an_outlier_is_set_aside_and_named() -> None:
    disturbed = case("special", "one gross outlier", place=0)
    before, after = measured(replace(disturbed, edit="")), measured(disturbed)
    (line,) = (
        number
        for number, (a, b) in enumerate(zip(before.splitlines(), after.splitlines(), strict=True), start=1)
        if a != b
    )
    found = diagnosed(after, disturbed.truth.machine)
    assert found.verdict == "adequate", found.reason
    assert [row.line for row in found.outliers] == [line]
    assert f"line {line}" in found.reason


def test_the_experimenters_numbers_of_modes_do_not_matter() -> None:
    numbered = case("special", "modes numbered anew", place=0)
    machine = numbered.truth.machine
    one, other = (diagnosed(text, machine, ["effects"]).as_json() for text in both(numbered))
    for result in (one, other):
        result["rows"] = [{k: v for k, v in row.items() if k != "mode"} for row in result["rows"]]
    assert one == other
    assert one["verdict"] == "effect_found"


def both(numbered: Case) -> tuple[str, str]:
    before, after = measured(replace(numbered, edit="")), measured(numbered)
    assert before != after
    return before, after


def test_errors_stated_too_small_are_not_taken_for_a_cause() -> None:
    outcome = run(case("special", "sigma stated as half", place=0))
    assert outcome.verdict in ("unexplained", "ambiguous"), outcome.reason
    assert "sigma" in outcome.reason


def test_an_error_that_the_modes_of_a_pose_share_is_recognised() -> None:
    shared = case("special", "error common to a pose", place=0)
    outcome = run(shared)
    assert outcome.verdict == "unexplained", outcome.reason
    error = re.search(r"only with an error of ([\d.]+) % that the modes of a pose share", outcome.reason)
    assert error is not None, outcome.reason
    assert 0.01 * float(error[1]) == pytest.approx(shared.options["common"], rel=0.6)


MISSED = [
    ("asymmetric", "cable_stiffness"),
    ("tower", "servo_stiffness"),
    ("published", "frame_compliance"),
    ("tower", "payload"),
]


@pytest.mark.parametrize(("robot", "effect"), MISSED)
def test_an_effect_is_found_although_modes_were_missed(robot: str, effect: str) -> None:
    outcome = run(case("modes missed", effect, robot))
    assert outcome.signal > CLEAR
    assert outcome.state == "named", outcome.reason


@pytest.mark.parametrize("place", range(0, 105, 15))
def test_a_robot_that_lacks_nothing_is_adequate_in_any_laboratory(place: int) -> None:
    outcome = run(case("nothing missing, realistic", "nothing", place=place))
    assert outcome.verdict == "adequate", outcome.reason


@pytest.mark.parametrize("number", FEW_ROWS)
def test_few_rows_do_not_give_a_confident_wrong_answer(number: int) -> None:
    outcome = run(numbered("few rows", number))
    assert outcome.rows <= 8
    assert outcome.state != "wrong", outcome.reason


@pytest.mark.parametrize("number", range(0, 54, 6))
def test_the_cause_that_the_shapes_show_is_claimed_or_none(number: int) -> None:
    outcome = run(numbered("shapes decide", number))
    assert outcome.state != "wrong", outcome.reason
    assert outcome.mac is None or outcome.mac[0] > MAC_CLAIMED or outcome.mac[1] < MAC_OTHER


@pytest.mark.parametrize("number", OUTLIERS)
def test_a_row_is_not_set_aside_where_any_of_them_could_be_wrong(number: int) -> None:
    outcome = run(numbered("outliers among few", number))
    assert outcome.state != "wrong", outcome.reason


@pytest.mark.parametrize("mistake", MISTAKEN)
def test_no_cause_is_claimed_for_a_mistake_of_the_experimenter(mistake: str) -> None:
    outcome = run(case("units and wiring", mistake, place=0))
    assert not outcome.physical, outcome.reason


@pytest.mark.parametrize("number", [52, 59])
def test_a_fit_with_wrong_mode_pairing_leaves_its_local_minimum(number: int) -> None:
    """A frame with modes missed: the fit had stopped at a chi2 of 10 or 140 per degree of freedom, near the truth."""
    outcome = run(replace(numbered("modes missed", number), seed=20261202))
    assert outcome.case.names == ("frame_compliance",)
    assert_named(outcome)
    assert outcome.classes == (("frame_compliance",),)


@pytest.mark.slow
def test_a_narrow_valley_between_two_sizes_that_are_tried_is_found() -> None:
    """A frame beside unequal belts: no size of the grid fits better than no frame at all, one between them does."""
    outcome = run(replace(numbered("two effects", 13), seed=20261201))
    assert_named(outcome)
    assert set(outcome.classes) == {("frame_compliance",), ("axis_belt_stiffness",)}
