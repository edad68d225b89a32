"""The table of readings: another reading of the data costs an entry and a function."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helpers.diagnoses.diagnose_command import measured
from pkmodes import updating
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.readings import table
from pkmodes.loop.diagnosis.readings.comparison import ModelDistances, frequency_differences
from pkmodes.loop.diagnosis.readings.table import READINGS, Reading
from pkmodes.loop.diagnosis.verdict import rules
from pkmodes.loop.measured.measurements import Measurements
from pkmodes_rig.robots import read
from studies.specimens import measurements


def times(data: Measurements, factor: float) -> Measurements:
    """Measurements with all frequencies multiplied."""
    changed = {name: factor * data.numbers[name] for name in ("frequency", "sigma")}
    return replace(data, numbers={**data.numbers, **changed})


def half_waves(fitter: Fitter) -> str:
    """The frequencies fit far better when doubled: somebody counted half waves as whole ones."""
    declared = fitter.structure.predict(fitter.declared, ())
    here, there = (
        float(np.abs(frequency_differences(fitter, declared, data)[0]).mean())
        for data in (fitter.data, times(fitter.data, 2.0))
    )
    return "half waves were counted: double them" if ModelDistances(here, there).far_better(4.0, 0.1) else ""


def test_an_added_reading_decides_and_is_a_note_of_a_comparison(monkeypatch: pytest.MonkeyPatch) -> None:
    """An entry and a function: how the data are read, how far that is from the model, and what to do."""
    robot, right = read("published"), measurements(measured(poses=7))
    wrong = times(right, 0.5)
    assert "half waves" not in updating.diagnose(robot, wrong).reason
    monkeypatch.setattr(table, "READINGS", (*READINGS, Reading("half_waves", declared=half_waves)))
    found = updating.diagnose(robot, wrong)
    said = "half waves were counted: double them"
    assert (found.verdict, found.reason, found.rule) == ("unexplained", said, "before.half_waves")
    assert found.notes == updating.compare(robot, wrong).notes == (said,)
    assert updating.diagnose(robot, right).rule == "adequacy.adequate"
    (rule,) = [rule for rule in rules.rules_before_search() if rule.name == "before.half_waves"]
    assert rule.applies_when.startswith("The frequencies fit far better when doubled")


def test_every_reading_has_a_name_and_a_question() -> None:
    assert len({reading.name for reading in READINGS}) == len(READINGS)
    for reading in READINGS:
        assert any((reading.declared, reading.refitted, reading.explained, reading.remarks)), reading.name


def test_another_reading_is_far_better_if_it_is_nearer_by_a_factor_and_near() -> None:
    assert ModelDistances(0.4, 0.1).far_better(4.0, 0.1)
    assert not ModelDistances(0.39, 0.1).far_better(4.0)
    assert not ModelDistances(0.8, 0.2).far_better(4.0, 0.1)
    assert not ModelDistances(np.inf, np.inf).far_better(4.0, 0.1)


def test_the_rule_that_decided_is_an_attribute_and_not_in_the_json() -> None:
    found = updating.diagnose(read("published"), measurements(measured(poses=4)), candidates=("payload",))
    assert found.rule == "adequacy.adequate"
    assert "rule" not in found.as_json()
