"""Damping as data: which joint dissipates, on ratios made by the virtual rig's own description of the joints.

Losses are checked on the damping of poses that took no part in the fit, and a corrected robot has them.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.damped_cases import bare, columns, made, measured
from pkmodes import read_robot, updating
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements

ROBOT = read_robot(Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml")


@cache
def diagnosed(coulomb: float = 0.0, **losses: float) -> Diagnosis:
    """Ratios of the lowest six vibration modes at eight poses, with errors of 5 %."""
    return updating.diagnose(ROBOT, measured(losses, coulomb=coulomb))


def without_damping() -> Measurements:
    return made(bare(columns({"rails": 50.0})))


@pytest.mark.parametrize(
    ("loss", "size", "name"),
    [("springs", 0.03, "belt_loss"), ("rails", 50.0, "rail_friction"), ("drives", 0.04, "drive_friction")],
)
def test_what_dissipates_is_named_with_its_size(loss: str, size: float, name: str) -> None:
    found = diagnosed(**{loss: size})
    assert (found.verdict, found.effects) == ("adequate", ())
    assert found.damping.verdict == "effect_found", found.damping.reason
    (cause,) = found.damping.effects
    assert cause.name == name
    (value,) = cause.parameters
    assert abs(value.value - size) < 3.0 * value.sigma


def test_losses_of_all_springs_are_one_class_with_a_common_ratio() -> None:
    """With free motors belts are the only springs: a loss factor eta is a ratio of eta / 2 of every mode."""
    (cause,) = diagnosed(springs=0.03).damping.effects
    assert cause.members == ("belt_loss", "parameter:damping.ratio")
    assert cause.alternatives["parameter:damping.ratio"][0].value == pytest.approx(0.015, rel=0.05)


def test_coulomb_friction_ends_in_abstention() -> None:
    found = diagnosed(coulomb=5.0).damping
    assert found.verdict == "unexplained"
    assert not found.effects
    assert "the damping" in found.reason


def test_without_damping_the_result_is_that_of_the_frequencies() -> None:
    first, both = updating.diagnose(ROBOT, without_damping()), diagnosed(rails=50.0)
    assert first.verdict == both.verdict == "adequate"
    assert first.damping.verdict == "not_measured"
    assert both.damping.verdict == "effect_found"
    assert (first.before, first.refit) == (both.before, both.refit)


def test_a_loss_without_measured_damping_is_refused() -> None:
    with pytest.raises(PkmodesError, match="no damping was measured"):
        updating.diagnose(ROBOT, without_damping(), candidates=["belt_loss"])


DECLARED = ROBOT.with_values({"damping.ratio": 0.01})


def at_one_pose(losses: dict[str, float], factors: list[float]) -> dict[str, np.ndarray]:
    """Rows whose damping at the third pose alone differs, mode by mode."""
    rows = columns(losses)
    there = rows["pose"] == 2
    return {**rows, "damping": rows["damping"] * np.where(there, np.resize(factors, len(there)), 1.0)}


def test_losses_that_do_not_predict_the_held_out_damping_are_not_claimed() -> None:
    data = made(at_one_pose({"rails": 50.0}, [4.0, 0.2, 3.0, 0.3, 5.0, 0.25]))
    whole = updating.diagnose(ROBOT, data, holdout=["P3"])
    assert whole.verdict == "adequate"
    found = whole.damping
    assert found.verdict == "unexplained"
    assert not found.effects
    assert (
        "rail_friction would explain that of the fitted poses, but not that of the held-out ones"
        in found.reason
    )
    assert {trial.effects for trial in found.stability} == {()}
    assert not found.corrected


def test_losses_that_predict_the_held_out_damping_are_claimed() -> None:
    found = updating.diagnose(ROBOT, measured({"rails": 50.0}), holdout=["P3"])
    assert [cause.name for cause in found.damping.effects] == ["rail_friction"]
    assert found.damping.held_out is not None
    assert found.damping.held_out < 1.15  # errors of 5 %, in six ratios
    held = [row for row in found.rows if row.held_out]
    assert held
    assert not any(row.damping_used for row in held)


def test_declared_damping_that_does_not_predict_that_of_held_out_poses_is_noted() -> None:
    found = updating.diagnose(DECLARED, made(at_one_pose({"ratio": 0.01}, [4.0])), holdout=["P3"])
    assert found.damping.verdict == "adequate"
    (note,) = (note for note in found.damping.notes if "the held-out poses is not predicted" in note)
    assert "a factor of 4 " in note


@pytest.mark.parametrize(
    ("drives", "losses"),
    [
        ("free", {"rails": 50.0}),
        ("held", {"rails": 50.0}),
        ("mixed", {"rails": 50.0}),
        ("free", {"drives": 0.04}),
    ],
)
def test_a_corrected_robot_has_the_damping(tmp_path: Path, drives: str, losses: dict[str, float]) -> None:
    data = measured(losses, drives=drives)
    found = updating.diagnose(ROBOT, data)
    assert found.verdict == "adequate", found.reason
    updating.save_robot(ROBOT, found, tmp_path / "corrected.toml")
    corrected = read_robot(tmp_path / "corrected.toml")
    (cause,) = found.damping.effects
    assert corrected.effects[f"{cause.name}.viscous"] == pytest.approx(cause.parameters[0].value, rel=1e-4)
    again = updating.diagnose(corrected, data)
    assert again.verdict == "adequate", again.reason
    assert again.damping.verdict == "adequate"


def test_a_loss_beside_a_cause_of_the_frequencies_is_saved_too(tmp_path: Path) -> None:
    data = measured({"rails": 50.0}, effects={"payload.mass": 1.0})
    found = updating.diagnose(ROBOT, data)
    updating.save_robot(ROBOT, found, tmp_path / "corrected.toml")
    corrected = read_robot(tmp_path / "corrected.toml")
    assert found.effects[0].members == ("parameter:platform.mass", "payload")
    assert corrected.parameters.platform_mass > 2.0  # 1.5 kg and the payload
    assert corrected.effects["rail_friction.viscous"] == pytest.approx(50.0, rel=0.1)
    again = updating.diagnose(corrected, data)
    assert again.verdict == "adequate", again.reason
