"""Verdicts on machines with six legs: a few measurements as those of `tests/studies/six_legged_suites.py`.

How often each verdict is right is measured by the whole suites, in docs/reference/results.md.  Here the causes have a
fixed size, because the search for one takes longer than a diagnosis.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from pkmodes import updating
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from studies import clear_cases, six_legged_suites
from studies.clear_cases import ClearCase
from studies.judging import judged, same_of
from studies.motors import shows
from studies.specimens import (
    PLATFORM,
    SIX_LEGGED,
    Specimen,
    effects_of,
    measurements_of,
    robot_of,
    with_effect,
)

SEED = 2


def diagnosed(case: ClearCase, specimen: Specimen) -> Diagnosis:
    robot = robot_of(case.machine)
    _, text = clear_cases.found(replace(case, seed=SEED), replace(specimen, drives=case.drives))
    return updating.diagnose(robot, measurements_of(text, robot))


@pytest.mark.parametrize(
    ("machine", "number", "drives", "effect", "size"),
    [
        ("hexapod", 1, "held", "payload", 0.7),  # sensors on the platform
        ("hexaglide", 2, "held", "link_compliance", 2e-7),  # sensors on the carriages
    ],
)
def test_an_effect_is_named_with_its_value(
    machine: str, number: int, drives: str, effect: str, size: float
) -> None:
    case = ClearCase("one effect", number, machine, (effect,), (9.0, 14.0), drives=drives)
    found = diagnosed(case, with_effect(machine, effect, size))
    assert judged((effect,), found, same_of(machine)) == "named", found.reason
    (value,) = found.effects[0].alternatives[effect]
    assert abs(value.value - size) < 3.0 * value.sigma


def test_a_hexapod_that_lacks_nothing_is_adequate() -> None:
    case = ClearCase("nothing missing", 0, "hexapod", (), (0.0, 0.0))
    assert diagnosed(case, Specimen("hexapod")).verdict == "adequate"


@pytest.mark.parametrize("machine", SIX_LEGGED)
def test_the_suites_have_forty_cases_of_one_effect_with_all_drives_and_sensors(machine: str) -> None:
    every = [case for case in six_legged_suites.cases() if case.machine == machine]
    some = [case for case in every if case.suite == "one effect"]
    assert len(some) == 40
    assert {kind for case in some for kind in case.kinds} == set(effects_of(machine))
    held = {kind for case in some if case.drives == "held" for kind in case.kinds}
    assert held == {kind for kind in effects_of(machine) if shows("held", (kind,))}
    assert {case.sensors == PLATFORM for case in some} == {True, False}
    first, second = some[0].points, some[1].points
    assert first.shape == (12, 6)
    assert (first != second).any(axis=0).all()
