"""Damping as data: which joint dissipates, on ratios made by the virtual rig's own description of the joints."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from pkmodes import read_robot, updating
from pkmodes.core.base.errors import PkmodesError
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.measured.measurements import Measurements
from pkmodes_rig import POSES, TrueModes, read, true_modes
from pkmodes_rig.dissipation import coulomb_ratios, damping_ratios

ROBOT = Path(__file__).parents[2] / "robots" / "linear-delta-2022.toml"
POINTS, MODES = POSES["published"]["scattered"][:8], 6


@cache
def modes() -> tuple[TrueModes, ...]:
    parameters = read("published").parameters
    return tuple(true_modes(parameters, p) for p in POINTS)


def measured(losses: Mapping[str, float], coulomb: float = 0.0, scatter: float = 0.05) -> Measurements:
    """Ratios of the lowest six vibration modes at eight poses, with errors of 5 %."""
    rng, q = np.random.default_rng(11), read("published").parameters
    pose, frequency, ratio = [], [], []
    for k, (p, at) in enumerate(zip(POINTS, modes(), strict=True)):
        some = slice(at.rigid, at.rigid + MODES)
        each = damping_ratios("linear_delta", q, p, at, losses)
        if coulomb:  # one amplitude of the platform in all modes
            moved = np.abs([at.shapes[name] for name in ("p_x", "p_y", "p_z")]).max(axis=0)
            each = each + coulomb_ratios("linear_delta", at, coulomb, 1e-4 / moved)
        pose += [k] * MODES
        frequency += list(at.frequencies[some])
        ratio += list(each[some])
    f = np.array(frequency) * np.exp(rng.normal(0.0, 0.002, len(frequency)))
    zeta = np.array(ratio) * np.exp(rng.normal(0.0, scatter, len(ratio)))
    return Measurements.from_rows(
        pose, f, 0.002 * f, points=[POINTS[k] for k in pose], damping=zeta, damping_sigma=0.05 * zeta
    )


def diagnosed(data: Measurements, **options: list[str]) -> Diagnosis:
    return updating.diagnose(read_robot(ROBOT), data, **options)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("loss", "size", "name"),
    [("springs", 0.03, "belt_loss"), ("rails", 50.0, "rail_friction"), ("drives", 0.04, "drive_friction")],
)
def test_what_dissipates_is_named_with_its_size(loss: str, size: float, name: str) -> None:
    found = diagnosed(measured({loss: size}))
    assert (found.verdict, found.effects) == ("adequate", ())
    assert found.damping.verdict == "effect_found", found.damping.reason
    (cause,) = found.damping.effects
    assert cause.name == name
    (value,) = cause.parameters
    assert abs(value.value - size) < 3.0 * value.sigma


def test_losses_of_all_springs_are_one_class_with_a_common_ratio() -> None:
    """With free motors belts are the only springs: a loss factor eta is a ratio of eta / 2 of every mode."""
    (cause,) = diagnosed(measured({"springs": 0.03})).damping.effects
    assert cause.members == ("belt_loss", "parameter:damping.ratio")
    assert cause.alternatives["parameter:damping.ratio"][0].value == pytest.approx(0.015, rel=0.05)


def test_coulomb_friction_ends_in_abstention() -> None:
    found = diagnosed(measured({}, coulomb=5.0)).damping
    assert found.verdict == "unexplained"
    assert not found.effects
    assert "the damping" in found.reason


def test_without_damping_the_result_is_that_of_the_frequencies() -> None:
    data = measured({"rails": 50.0})
    without = Measurements.from_rows(
        data.pose.tolist(), data.frequency, data.sigma, points=[POINTS[k] for k in data.pose]
    )
    first, both = diagnosed(without), diagnosed(data)
    assert first.verdict == both.verdict == "adequate"
    assert first.damping.verdict == "not_measured"
    assert both.damping.verdict == "effect_found"
    assert (first.before, first.refit) == (both.before, both.refit)


def test_the_corrected_robot_is_adequate(tmp_path: Path) -> None:
    robot, data = read_robot(ROBOT), measured({"rails": 50.0})
    updating.save_robot(robot, updating.diagnose(robot, data), tmp_path / "corrected.toml")
    again = updating.diagnose(read_robot(tmp_path / "corrected.toml"), data)
    assert (again.verdict, again.damping.verdict) == ("adequate", "adequate"), again.damping.reason


def test_a_loss_without_measured_damping_is_refused() -> None:
    data = measured({"rails": 50.0})
    without = Measurements.from_rows(
        data.pose.tolist(), data.frequency, data.sigma, points=[POINTS[k] for k in data.pose]
    )
    with pytest.raises(PkmodesError, match="no damping was measured"):
        diagnosed(without, candidates=["belt_loss"])
