"""Verdicts on the rotary delta and the CoreXY: a few cases of `tests/studies/mechanism_suites.py`.

How often each verdict is right is measured by the whole suites, in docs/reference/results.md.
"""

from __future__ import annotations

import pytest

from helpers.golden.case_book import frozen
from pkmodes.loop.updating.candidates import suspects
from studies.mechanism_cases import MechanismCase, MechanismOutcome, run
from studies.mechanism_sizes import SIZES
from studies.mechanism_suites import OUTSIDE, SUITES, WRONG, cases
from studies.specimens import KINDS, robot_of

RIGHT = 3.0


@pytest.fixture(autouse=True)
def _frozen(monkeypatch: pytest.MonkeyPatch, pytestconfig: pytest.Config) -> None:
    """Every outcome is compared with the golden one, too (tests/golden)."""
    monkeypatch.setitem(globals(), "run", frozen(run, "other_mechanisms_on_the_rig", pytestconfig))


def case(mechanism: str, suite: str, kind: str, place: int = -1) -> MechanismCase:
    """One of the cases of a kind, with free motors; if there are several strengths, the last is the largest."""
    kinds = (mechanism, "free", suite, kind)
    return [c for c in cases() if (c.specimen.machine, c.specimen.drives, c.suite, c.kind) == kinds][place]


def assert_named(outcome: MechanismOutcome) -> None:
    assert outcome.state == "named", outcome.reason
    for name, found, sigma, true in outcome.values:
        assert abs(found - true) < RIGHT * sigma, name


@pytest.mark.parametrize("mechanism", KINDS)
@pytest.mark.parametrize("number", [0, 1, 4])
def test_a_robot_that_lacks_nothing_is_adequate(mechanism: str, number: int) -> None:
    outcome = run(case(mechanism, "nothing missing", "nothing", number))
    assert outcome.verdict == "adequate", outcome.reason


@pytest.mark.parametrize(
    ("mechanism", "effect"),
    [
        ("rotary_delta", "axis_reducer_stiffness"),
        ("rotary_delta", "link_compliance"),
        ("rotary_delta", "payload"),
        ("corexy", "belt_end_compliance"),
        ("corexy", "cable_stiffness"),
        ("corexy", "frame_compliance"),
    ],
)
def test_an_effect_is_found_with_its_value(mechanism: str, effect: str) -> None:
    assert_named(run(case(mechanism, "one effect", effect)))


@pytest.mark.parametrize(
    ("mechanism", "path"), [("rotary_delta", "motor.gear_ratio"), ("corexy", "belt_path.1.lengths.1")]
)
def test_a_wrong_value_is_found(mechanism: str, path: str) -> None:
    assert_named(run(case(mechanism, "wrong parameter", path)))


@pytest.mark.parametrize(
    ("mechanism", "kind"), [("rotary_delta", "rocking_frame"), ("corexy", "tuned_absorber")]
)
def test_what_is_outside_the_catalogue_is_not_named(mechanism: str, kind: str) -> None:
    outcome = run(case(mechanism, "outside the catalogue", kind, 0))
    assert outcome.state == "abstained", outcome.classes


@pytest.mark.parametrize("mechanism", KINDS)
def test_the_suites_have_every_effect_that_is_suspected(mechanism: str) -> None:
    names = {c.name for c in suspects(robot_of(mechanism))[1]}
    effects = {e for e in robot_of(mechanism).mechanism.effects if e in names}
    assert {
        c.names[0] for c in cases() if c.specimen.machine == mechanism and c.suite == SUITES[1]
    } == effects
    assert {f"parameter:{path}" for path in WRONG[mechanism]} <= names
    assert list(SIZES[mechanism][SUITES[2]]) == list(WRONG[mechanism])
    assert list(SIZES[mechanism][SUITES[3]]) == list(OUTSIDE[mechanism])
