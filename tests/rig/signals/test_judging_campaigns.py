"""How the suite of campaigns judges: which modes count, which row is which mode, and what the table makes of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from pkmodes.campaign.campaign import Record
from pkmodes.campaign.results import IdentifiedMode, Parts, RecordResult
from pkmodes_rig.engine import TrueModes
from pkmodes_rig.signals.campaigns import Made
from pkmodes_rig.signals.modal_tests import Flaws, ModalTest, Recorded
from pkmodes_rig.signals.sensors import Room, Sensor
from pkmodes_rig.signals.small_motion import Losses, SmallMotion, small_motion
from studies.campaign_cases import CampaignOutcome
from studies.campaign_judging import counting, judge
from studies.campaign_machines import bench, cases
from studies.campaign_table import table

BAND = (10.0, 100.0)


def machine(frequencies: Sequence[float], shapes: dict[str, list[float]], ratio: float = 0.01) -> SmallMotion:
    n = len(frequencies)
    of = {name: np.array(row) for name, row in shapes.items()}
    modes = TrueModes(np.array(frequencies), 0, of, np.eye(n), np.eye(n), tuple(f"q_{i}" for i in range(n)))
    return small_motion(modes, Losses(ratio))


def in_room(noise: float, sensors: Sequence[str] = ("a", "b"), flaws: Flaws | None = None) -> ModalTest:
    each = tuple(Sensor(name) for name in sensors)
    return ModalTest("frf", each, Room(noise), ({"a": 1.0},), 1.0, 20.0, flaws=flaws or Flaws())


def recorded(power: float = 1.0) -> Recorded:
    return Recorded(None, None, None, np.array([0.0, 200.0]), np.full((2, 1), power))


def test_a_mode_counts_while_its_peak_is_ten_decibels_above_the_noise() -> None:
    """One mode, accelerance at the peak phi^2 / (2 zeta) = 1 / 0.02; its power against that of the noise."""
    one = machine([40.0], {"a": [1.0], "b": [0.1]})
    peak = (1.0 / 0.02) ** 2
    assert counting(one, recorded(), in_room(peak / 9.0)) == []
    assert counting(one, recorded(), in_room(peak / 11.0)) == [0]
    assert counting(one, recorded(0.5), in_room(peak / 11.0)) == []
    dead = Flaws(dead=0)  # the best sensor: the other one shows a tenth
    assert counting(one, recorded(), in_room(peak / 11.0, flaws=dead)) == []
    assert counting(one, recorded(), in_room(peak / 1100.0, flaws=dead)) == [0]


def test_a_mode_that_its_neighbour_can_imitate_does_not_count() -> None:
    alike = machine([40.0, 40.01], {"a": [1.0, 1.0], "b": [1.0, 1.0]})
    assert counting(alike, recorded(), in_room(1e-1)) == []
    unlike = machine([40.0, 40.4], {"a": [1.0, 1.0], "b": [1.0, -1.0]})
    assert counting(unlike, recorded(), in_room(1e-1)) == [0, 1]


def result(modes: Sequence[IdentifiedMode]) -> RecordResult:
    record = Record(1, "P1", {}, {}, {}, "frf", {}, BAND, "free", None, 1, None, None, {})  # type: ignore[call-arg]
    return RecordResult(record, tuple(modes), (), (), ())


def row(frequency: float, shape: dict[str, float], damping: float = 0.01) -> IdentifiedMode:
    return IdentifiedMode(frequency, Parts(0.003, 0.004, 0.08), damping, 2e-4, shape, 0.01, 1.0, (10, 10), 2)


def made(one: SmallMotion) -> Made:
    return Made(np.zeros((1, 1)), [one], {(0, 0): one}, {(0, 0): recorded()})


def test_rows_are_paired_with_modes_by_frequency_and_shape() -> None:
    one = machine([40.0, 40.2, 70.0], {"a": [1.0, 0.6, 1.0], "b": [0.5, -1.0, 1.0]})
    rows = [
        row(40.15, {"a": 1.0, "b": 0.5}),  # nearer to the second mode, with the shape of the first
        row(40.1, {"a": -0.6, "b": 1.0}),
        row(50.0, {"a": 1.0, "b": 1.0}),  # mains
    ]
    judged = judge([result(rows)], made(one), in_room(1e-3), BAND)
    assert [each.mode for each in judged.rows] == [0, 1, -1]
    assert [place[1] for place in judged.counted] == [0, 1, 2]
    assert judged.missed == ((0, pytest.approx(70.0)),)
    assert judged.rows[0].mac == pytest.approx(1.0)
    assert judged.rows[0].of_fit == pytest.approx(0.005)


def test_the_table_says_what_is_met() -> None:
    one = machine([40.0, 70.0], {"a": [1.0, 1.0], "b": [0.5, -1.0]})
    rows = [row(40.004, {"a": 1.0, "b": 0.5}), row(50.0, {"a": 1.0, "b": 0.0})]
    judged = judge([result(rows)], made(one), in_room(1e-3), BAND)
    (case,) = [each for each in cases(1) if each.number == 0]
    case = type(case)(1, 0, 60, "corexy", "frf", False, "payload", False)
    lines = {
        what: (found, met)
        for what, _, found, met in table([CampaignOutcome(case, "wrong", "", judged=judged)])
    }
    assert lines["modes found"] == ("1 of 2: 50.0 %", False)
    assert lines["rows that are no mode"] == ("1 of 2: 50.0 %", False)
    assert lines["frequency against the record's own truth, rms: frf"] == ("0.010 %", True)
    assert lines["within 2 sigma: damping"] == (
        "1 of 1: 100.0 %",
        False,
    )  # no standard deviation is that large
    assert lines["confident and wrong"] == ("1 of 1", False)


def test_the_machines_of_a_seed_are_always_the_same() -> None:
    chosen = cases(5)
    assert chosen == cases(5)
    assert {case.robot for case in chosen} == {"published", "tower", "asymmetric", "rotary_delta", "corexy"}
    assert [case.cause for case in chosen].count("") == 5
    assert sum(case.outside for case in chosen) == 7
    assert sum(case.held for case in chosen) == 30
    a, b = (bench(chosen[3], np.random.default_rng(3)) for _ in range(2))
    assert a.paper == b.paper
    np.testing.assert_array_equal(a.poses, b.poses)
