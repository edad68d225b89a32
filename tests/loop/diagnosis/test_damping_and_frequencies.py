"""The two stages of a diagnosis together: the verdict is that of the frequencies, and the damping has its own."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from helpers.diagnoses.damped_cases import bare, columns, made, measured, of_frequencies, strange
from pkmodes import updating
from pkmodes.loop.diagnosis.damping.words import NO_LOSSES_REASON, UNSETTLED_REASON
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from studies.specimens import robot_of

ROBOT = robot_of("published")
DECLARED = ROBOT.with_values({"damping.ratio": 0.01})
PAYLOAD = {"payload.mass": 1.0}
LOSSES = {"belt_loss", "reducer_loss", "rail_friction", "drive_friction"}
#: Keys of a row that only a diagnosis of damping writes.
ROW_KEYS = {
    *("damping", "sigma_damping", "damping_before", "damping_after", "damping_used"),
    *("sigma_damping_used", "damping_remark"),
}
#: What is said without measured damping.
SILENT = {
    "verdict": "not_measured",
    "reason": "no damping was measured",
    **{key: [] for key in ("effects", "survivors", "undetectable", "candidates", "notes", "stability")},
    **{key: {} for key in ("limits", "refitted")},
    "fitted": 0,
    "scatter": 0.0,
    "factor": dict.fromkeys(("before", "after", "held_out")),
}


def names(found: Diagnosis) -> list[str]:
    return [cause.name for cause in found.effects]


@pytest.mark.parametrize("declared", [False, True])
def test_a_cause_of_the_frequencies_stands_though_the_damping_is_unexplained(declared: bool) -> None:
    data = made(strange(columns({"ratio": 0.01}, effects=PAYLOAD)))
    found = updating.diagnose(DECLARED if declared else ROBOT, data)
    assert found.verdict == "effect_found", found.reason
    assert names(found) == ["payload"]
    assert found.damping.verdict == "unexplained"
    assert "damping" not in found.reason


def test_losses_are_found_beside_the_cause_of_the_frequencies() -> None:
    found = updating.diagnose(ROBOT, measured({"rails": 50.0}, effects=PAYLOAD))
    assert found.verdict == found.damping.verdict == "effect_found"
    assert names(found) == ["payload"]
    assert [cause.name for cause in found.every_cause] == ["payload", "rail_friction"]
    payload, rails = (cause.parameters[0] for cause in found.every_cause)
    assert abs(payload.value - 1.0) < 3.0 * payload.sigma
    assert abs(rails.value - 50.0) < 3.0 * rails.sigma


def test_a_loss_beside_a_declared_one_is_found() -> None:
    found = updating.diagnose(DECLARED, measured({"ratio": 0.01, "rails": 150.0}))
    assert (found.verdict, names(found)) == ("adequate", [])
    assert found.damping.verdict == "effect_found", found.damping.reason
    assert [cause.name for cause in found.damping.effects] == ["rail_friction"]


def test_unexplained_damping_leaves_the_verdict_on_an_adequate_model() -> None:
    found = updating.diagnose(DECLARED, measured({"ratio": 0.01}, coulomb=5.0))
    assert found.verdict == "adequate"
    assert found.damping.verdict == "unexplained"
    assert found.damping.reason.startswith("the damping is not that of the model")
    assert "damping" not in found.reason


def test_declared_damping_that_was_measured_is_adequate() -> None:
    found = updating.diagnose(DECLARED, measured({"ratio": 0.01}))
    assert found.damping.verdict == "adequate", found.damping.reason
    assert found.damping.before == pytest.approx(1.05, abs=0.01)  # errors of 5 % are all that is left
    assert found.damping.after == found.damping.before
    assert found.damping.scatter == 0.0


def test_an_uncertain_declared_ratio_is_refitted_within_its_sigma() -> None:
    robot = ROBOT.with_values({"damping.ratio": {"value": 0.01, "sigma": 0.003}})
    found = updating.diagnose(robot, measured({"ratio": 0.013}))
    assert found.damping.verdict == "adequate", found.damping.reason
    assert not any(value.name == "damping.ratio" for value in found.refitted)
    (ratio,) = found.damping.refitted
    assert ratio.name == "damping.ratio"
    # 42 ratios, each to 11 %: the stated 5 % and the floor of 10 %
    assert ratio.after == pytest.approx(0.013, abs=3 * 0.11 / 42**0.5 * 0.013)


@cache
def unsettled() -> Diagnosis:
    rows = columns({"rails": 50.0})
    spread = np.exp(np.random.default_rng(1).normal(0.0, 0.03, len(rows["pose"])))
    data = made({**rows, "frequency": rows["frequency"] * spread})
    return updating.diagnose(ROBOT, data, candidates=["payload", *sorted(LOSSES)])


def test_damping_is_not_diagnosed_where_the_frequencies_do_not_settle() -> None:
    found = unsettled()
    assert found.verdict == "unexplained"
    assert (found.damping.verdict, found.damping.reason) == ("insufficient_data", UNSETTLED_REASON)
    assert set(found.damping.undetectable) == LOSSES
    assert found.damping.limits["belt_loss.loss_factor"].value is None
    assert all(row.damping is None for row in found.rows)


def test_damping_is_not_diagnosed_without_a_loss_among_the_candidates() -> None:
    found = updating.diagnose(ROBOT, measured({"rails": 50.0}), candidates=["payload"])
    assert found.verdict == "adequate"
    assert (found.damping.verdict, found.damping.reason) == ("insufficient_data", NO_LOSSES_REASON)


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
    one, both = (updating.diagnose(ROBOT, made(given), candidates=candidates) for given in (bare(rows), rows))
    assert both.damping.verdict == ("unexplained" if coulomb else "effect_found")
    assert one.as_json()["damping"] == SILENT
    assert not any("damping" in key for row in one.as_json()["rows"] for key in row)
    assert of_frequencies(one) == of_frequencies(both)
