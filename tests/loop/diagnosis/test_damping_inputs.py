"""Damping columns as they come: zeros, one row, per cent, no errors or hostile ones, thousands of rows."""

from __future__ import annotations

import re
import time
from collections.abc import Mapping

import numpy as np
import pytest

from helpers.diagnoses.damped_cases import columns, made, measured
from pkmodes import updating
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Measurements
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from studies.specimens import MACHINES, robot_of

ROBOT = robot_of("published")
RAILS: Mapping[str, np.ndarray] = columns({"rails": 50.0})
COUNT = len(RAILS["pose"])


def with_damping(damping: np.ndarray, sigma: np.ndarray | None = None) -> Measurements:
    return made({**RAILS, "damping": damping}, sigma=sigma)


def rails_named(found: Diagnosis) -> None:
    assert found.verdict == "adequate", found.reason
    assert found.damping.verdict == "effect_found", found.damping.reason
    assert [cause.name for cause in found.damping.effects] == ["rail_friction"]
    (value,) = found.damping.effects[0].parameters
    assert abs(value.value - 50.0) < 3.0 * value.sigma


def silent(found: Diagnosis) -> None:
    """Nothing is claimed, and the reason says why."""
    assert found.verdict == "adequate", found.reason
    assert found.damping.verdict == "insufficient_data"
    assert not found.damping.effects
    assert "not diagnosed" in found.damping.reason


def test_zeros_without_a_sigma_in_some_rows_are_left_out_and_said() -> None:
    zeros = np.arange(COUNT) % 7 == 0
    found = updating.diagnose(ROBOT, with_damping(np.where(zeros, 0.0, RAILS["damping"])))
    rails_named(found)
    assert not any(row.damping_used for row, zero in zip(found.rows, zeros, strict=True) if zero)
    assert any("lines 1, 8, 15, 22, 29, 36, 43 is not used" in note for note in found.damping.notes)


@pytest.mark.parametrize("sigma", [None, 1e-3])
def test_zeros_in_all_rows_say_nothing(sigma: float | None) -> None:
    stated = None if sigma is None else np.full(COUNT, sigma)
    silent(updating.diagnose(ROBOT, with_damping(np.zeros(COUNT), stated)))


def test_a_zero_that_is_known_contradicts_a_loss() -> None:
    """0 +- 0.0002 where rails would give a ratio of 0.3 %."""
    largest = RAILS["damping"] > np.median(RAILS["damping"])
    damping = np.where(largest, 0.0, RAILS["damping"])
    found = updating.diagnose(ROBOT, with_damping(damping, np.where(largest, 2e-4, 0.05 * damping)))
    assert not any(cause.name == "rail_friction" for cause in found.damping.effects)


def test_one_row_says_nothing() -> None:
    alone = np.full(COUNT, np.nan)
    alone[8] = 0.01
    found = updating.diagnose(ROBOT, with_damping(alone))
    silent(found)
    assert "1 resolved damping ratio is too few" in found.damping.reason
    assert [row.damping for row in found.rows].count(None) == COUNT - 1


def test_one_mode_that_is_hardly_a_vibration_is_set_aside() -> None:
    damping = RAILS["damping"].copy()
    damping[4] = 0.9
    found = updating.diagnose(ROBOT, with_damping(damping))
    rails_named(found)
    assert any(
        note.startswith("the damping of line 5 (P1, 90 %) is set aside") for note in found.damping.notes
    )
    assert found.rows[4].damping_used is False
    assert found.rows[4].damping_remark == "set aside"


def test_a_machine_that_hardly_vibrates_is_not_diagnosed() -> None:
    found = updating.diagnose(ROBOT, with_damping(np.full(COUNT, 0.9)))
    silent(found)
    assert found.damping.fitted == 0


def test_ratios_that_are_all_equal_are_a_common_ratio() -> None:
    found = updating.diagnose(ROBOT, with_damping(np.full(COUNT, 0.01)))
    (cause,) = found.damping.effects
    assert "parameter:damping.ratio" in cause.members
    assert cause.alternatives["parameter:damping.ratio"][0].value == pytest.approx(0.01, rel=1e-3)


@pytest.mark.parametrize("sigma", [0.0, 1e-12, 1e-300])
def test_no_error_is_taken_as_smaller_than_any_test_resolves(sigma: float) -> None:
    rails_named(updating.diagnose(ROBOT, with_damping(RAILS["damping"], np.full(COUNT, sigma))))


def test_errors_may_be_blank_in_some_rows_or_in_all() -> None:
    some = np.where(np.arange(COUNT) % 2, np.nan, 0.05 * RAILS["damping"])
    rails_named(updating.diagnose(ROBOT, with_damping(RAILS["damping"], some)))
    blank = updating.diagnose(ROBOT, made(RAILS, stated=False))
    assert blank.damping.verdict in ("effect_found", "unexplained")
    assert {cause.name for cause in blank.damping.effects} <= {"rail_friction"}
    assert blank.rows[0].sigma_damping == pytest.approx(0.3 * RAILS["damping"][0])


@pytest.mark.parametrize("factor", [1e-9, 1e-300])
def test_ratios_below_what_any_test_resolves_say_nothing(factor: float) -> None:
    silent(updating.diagnose(ROBOT, with_damping(factor * RAILS["damping"])))


def test_errors_larger_than_any_ratio_say_nothing() -> None:
    silent(updating.diagnose(ROBOT, with_damping(RAILS["damping"], np.full(COUNT, 0.99))))


def test_ratios_in_per_cent_are_not_diagnosed_and_the_remedy_is_named() -> None:
    found = updating.diagnose(ROBOT, with_damping(np.minimum(100 * RAILS["damping"], 0.99)))
    silent(found)
    assert "write the column as damping [%]" in found.damping.reason


@pytest.mark.parametrize(("factor", "words"), [(100.0, "a hundred times"), (0.01, "a hundredth of")])
def test_a_factor_of_a_hundred_is_noted(factor: float, words: str) -> None:
    declared = 2e-4 if factor > 1.0 else 0.5
    rows = columns({"ratio": declared * factor})
    found = updating.diagnose(ROBOT.with_values({"damping.ratio": declared}), made(rows))
    (note,) = (note for note in found.damping.notes if "check the unit" in note)
    assert words in note


def test_thousands_of_rows_take_seconds() -> None:
    """2400 of 400 poses; on a busy machine the damping may add as much as the frequencies take, and 5 s."""
    times = 50
    rows = {name: np.tile(column, times) for name, column in RAILS.items()}
    rng = np.random.default_rng(2)
    damping = rows["damping"] * np.exp(rng.normal(0.0, 0.05, times * COUNT))
    frequency = rows["frequency"] * np.exp(rng.normal(0.0, 0.002, times * COUNT))
    labels = [f"P{k}" for k in rows["pose"] + 8 * np.repeat(np.arange(times), COUNT)]
    points = MACHINES["published"].points[rows["pose"]]
    seconds = []
    for column, candidates in ((None, ["payload"]), (damping, ["payload", "rail_friction"])):
        data = Measurements.from_rows(labels, frequency, 0.02 * frequency, points=points, damping=column)
        start = time.perf_counter()
        found = updating.diagnose(ROBOT, data, candidates=candidates)
        seconds.append(time.perf_counter() - start)
    assert [cause.name for cause in found.damping.effects] == ["rail_friction"]
    assert seconds[1] < 2.0 * seconds[0] + 5.0, seconds


def test_a_chosen_loss_is_the_only_candidate() -> None:
    found = updating.diagnose(ROBOT, made(RAILS), candidates=["rail_friction"])
    rails_named(found)
    assert [one.name for one in found.damping.candidates] == ["rail_friction"]
    other = updating.diagnose(ROBOT, made(RAILS), candidates=["belt_loss"])
    assert other.damping.verdict == "unexplained"
    assert not other.damping.effects


def test_reducers_of_a_rotary_delta_dissipate_like_a_common_ratio_and_it_has_no_rails() -> None:
    """Its reducers are its only springs: a loss factor eta is a ratio of eta / 2 of every mode."""
    robot, data = robot_of("rotary_delta"), measured({"springs": 0.03}, machine="rotary_delta")
    found = updating.diagnose(robot, data)
    assert {name for cause in found.damping.effects for name in cause.members} <= {
        "reducer_loss",
        "parameter:damping.ratio",
    }
    assert "rail_friction" not in {one.name for one in found.damping.candidates}
    if not found.damping.effects:
        told = re.search(r"agrees with a damping ratio of (\S+) \+- (\S+) %", found.damping.reason)
        assert told is not None
        assert "within the 10 % by which tests of one machine differ at least" in found.damping.reason
        ratio, sigma = map(float, told.groups())
        assert abs(ratio - 1.5) < 3.0 * sigma < 0.3
    with pytest.raises(PkmodesError, match='unknown candidate "rail_friction"'):
        updating.diagnose(robot, data, candidates=["rail_friction"])
