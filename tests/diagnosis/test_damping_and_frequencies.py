"""The two stages of a diagnosis together: what the frequencies say stands, and the damping adds to it."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from helpers.diagnoses.damped_cases import columns, made, measured
from pkmodes import updating
from pkmodes.diagnosis.damping.combined import UNSETTLED, combined
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
    Verdict,
)
from pkmodes_rig.suites.mechanism_cases import robot_of

ROBOT = robot_of("published")
DECLARED = ROBOT.with_values({"damping.ratio": 0.01})
PAYLOAD = {"payload.mass": 1.0}
LOSSES = {"belt_loss", "reducer_loss", "rail_friction", "drive_friction"}
#: Keys of a row that only a diagnosis of damping writes.
ROW_KEYS = {"damping", "sigma_damping", "damping_before", "damping_after", "damping_used"}


def names(found: Diagnosis) -> list[str]:
    return [cause.name for cause in found.effects]


@pytest.mark.parametrize(
    ("first", "damping", "both"),
    [
        (ADEQUATE, ADEQUATE, ADEQUATE),
        (ADEQUATE, EFFECT_FOUND, EFFECT_FOUND),
        (ADEQUATE, AMBIGUOUS, AMBIGUOUS),
        (ADEQUATE, UNEXPLAINED, UNEXPLAINED),
        (ADEQUATE, INSUFFICIENT_DATA, ADEQUATE),
        *((EFFECT_FOUND, one, EFFECT_FOUND) for one in (ADEQUATE, EFFECT_FOUND, AMBIGUOUS, UNEXPLAINED)),
        *((one, EFFECT_FOUND, one) for one in (AMBIGUOUS, UNEXPLAINED, INSUFFICIENT_DATA)),
    ],
)
def test_the_verdict_on_both(first: Verdict, damping: Verdict, both: Verdict) -> None:
    assert combined(first, damping) is both


@pytest.mark.parametrize("declared", [False, True])
def test_a_cause_of_the_frequencies_stands_though_the_damping_is_unexplained(declared: bool) -> None:
    rows = columns({"ratio": 0.01}, effects=PAYLOAD)
    own = np.array([1.0, 6.0, 0.3, 4.0, 0.2, 2.0])  # of each mode, like no joint's
    data = made({**rows, "damping": rows["damping"] * np.resize(own, len(rows["pose"]))})
    found = updating.diagnose(DECLARED if declared else ROBOT, data)
    assert found.verdict == "effect_found", found.reason
    assert names(found) == ["payload"]
    assert found.damping is not None
    assert found.damping.verdict == "unexplained"
    assert found.damping.sentence in found.notes
    assert "damping" not in found.reason


def test_losses_are_listed_after_the_cause_of_the_frequencies() -> None:
    found = updating.diagnose(ROBOT, measured({"rails": 50.0}, effects=PAYLOAD))
    assert found.verdict == "effect_found", found.reason
    assert names(found) == ["payload", "rail_friction"]
    payload, rails = (cause.parameters[0] for cause in found.effects)
    assert abs(payload.value - 1.0) < 3.0 * payload.sigma
    assert abs(rails.value - 50.0) < 3.0 * rails.sigma


def test_nothing_missing_and_a_loss_found_is_an_effect() -> None:
    found = updating.diagnose(DECLARED, measured({"ratio": 0.01, "rails": 150.0}))
    assert found.verdict == "effect_found", found.reason
    assert names(found) == ["rail_friction"]
    assert found.reason.startswith("the residual of the declared model is noise")


def test_nothing_missing_and_unexplained_damping_is_unexplained() -> None:
    found = updating.diagnose(DECLARED, measured({"ratio": 0.01}, coulomb=5.0))
    assert found.verdict == "unexplained"
    assert not found.effects
    assert found.reason.startswith("frequencies and shapes agree with the model, but the damping")


def test_nothing_missing_and_declared_damping_is_adequate() -> None:
    found = updating.diagnose(DECLARED, measured({"ratio": 0.01}))
    assert found.verdict == "adequate", found.reason
    assert found.damping is not None
    assert found.damping.verdict == "adequate"
    assert found.damping.before == pytest.approx(1.05, abs=0.01)  # errors of 5 % are all that is left
    assert found.damping.after == found.damping.before


def test_an_uncertain_declared_ratio_is_refitted_within_its_sigma() -> None:
    robot = ROBOT.with_values({"damping.ratio": {"value": 0.01, "sigma": 0.003}})
    found = updating.diagnose(robot, measured({"ratio": 0.013}))
    assert found.verdict == "adequate", found.reason
    (ratio,) = (value for value in found.refitted if value.name == "damping.ratio")
    # 42 ratios, each to 11 %: the stated 5 % and the floor of 10 %
    assert ratio.after == pytest.approx(0.013, abs=3 * 0.11 / 42**0.5 * 0.013)


@cache
def unsettled() -> Diagnosis:
    rows = columns({"rails": 50.0})
    spread = np.exp(np.random.default_rng(1).normal(0.0, 0.03, len(rows["pose"])))
    return updating.diagnose(ROBOT, made({**rows, "frequency": rows["frequency"] * spread}))


def test_damping_is_not_diagnosed_where_the_frequencies_do_not_settle() -> None:
    found = unsettled()
    assert found.verdict == "unexplained"
    assert found.damping is None
    assert UNSETTLED in found.notes
    assert set(found.undetectable) >= LOSSES
    assert found.limits["belt_loss.loss_factor"].value is None
    assert all(row.damping is None for row in found.rows)


def test_without_a_diagnosis_of_damping_no_row_has_its_keys() -> None:
    content: Any = unsettled().as_json()
    assert not any(ROW_KEYS & row.keys() for row in content["rows"])


@pytest.mark.parametrize(
    ("effects", "coulomb", "candidates"),
    [({}, 0.0, None), (PAYLOAD, 0.0, None), ({}, 5.0, None), ({}, 0.0, ["effects"])],
)
def test_what_is_said_of_the_frequencies_does_not_depend_on_the_damping(
    effects: dict[str, float], coulomb: float, candidates: list[str] | None
) -> None:
    """To the last digit: the JSON without what only damping writes is that of the file without the column."""
    rows = columns({"rails": 50.0}, effects=effects, coulomb=coulomb)
    bare = {name: column for name, column in rows.items() if name != "damping"}
    one: Any = updating.diagnose(ROBOT, made(bare), candidates=candidates).as_json()
    both: Any = updating.diagnose(ROBOT, made(rows), candidates=candidates).as_json()
    for key in ("refitted", "held_out_poses", "outliers", "unpaired", "pose_scatter", "shape_scatter"):
        assert one[key] == both[key], key
    assert one["next_measurement"] == both["next_measurement"] or both["verdict"] == "ambiguous"
    for key in ("effects", "candidates"):
        assert one[key] == both[key][: len(one[key])], key
        assert {entry["name"] for entry in both[key][len(one[key]) :]} <= LOSSES
    assert one["limits"] == {name: limit for name, limit in both["limits"].items() if name in one["limits"]}
    assert {name.split(".")[0] for name in both["limits"].keys() - one["limits"].keys()} <= LOSSES
    assert one["undetectable"] == [name for name in both["undetectable"] if name not in LOSSES]
    assert one["notes"] == both["notes"][: len(one["notes"])]
    stages = ["before", "refit", *(["after"] if effects else [])]
    assert [one["error"][stage] for stage in stages] == [both["error"][stage] for stage in stages]
    for old, new in zip(one["rows"], both["rows"], strict=True):
        assert new.keys() - old.keys() == ROW_KEYS
        same = {key: value for key, value in new.items() if key not in ROW_KEYS}
        if not effects and both["verdict"] == "effect_found":  # losses change no frequency
            assert same.pop("after_hz") == same["refit_hz"]
            assert old.pop("after_hz") is None
        assert same == old
    for old, new in zip(one["stability"], both["stability"], strict=True):
        assert old["effects"] == new["effects"][: len(old["effects"])]
