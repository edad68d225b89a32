"""Damping as data: which joint dissipates, on ratios made by the virtual rig's own description of the joints."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from helpers.diagnoses.damped_cases import bare, columns, made, measured
from pkmodes import read_robot, updating
from pkmodes.core.base.errors import PkmodesError
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.measured.measurements import Measurements

ROBOT = read_robot(Path(__file__).parents[2] / "robots" / "linear-delta-2022.toml")


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
