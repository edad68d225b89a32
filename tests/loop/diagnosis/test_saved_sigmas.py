"""What the data do not show is in the standard deviations of a saved robot, on the virtual test rig.

A tower printer measured in its lowest three modes: stiffer clamps or stiffer motors look the same there.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.diagnose_command import call
from pkmodes import updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes_rig import POSES, ROBOTS, identified, written
from studies.specimens import Specimen

#: True stiffness of the motors [N m/rad], and compliances of the clamps that the three modes do not show [m/N].
MOTORS, CLAMPS = 16.5, (5e-7, 1e-6, 2e-6)
STIFFNESS = "effects.servo_stiffness.stiffness"
DECLARED = f'\n[effects.servo_stiffness]\nstiffness = {{ value = "{MOTORS} N*m/rad", sigma = "20 %" }}\n'


def files(folder: Path, clamp: float) -> tuple[Path, Path]:
    robot, modes = folder / "tower.toml", folder / "modes.csv"
    robot.write_text(ROBOTS["tower"] + DECLARED, encoding="utf-8")
    points = list(POSES["tower"]["scattered"])
    truth = Specimen("tower", {"servo_stiffness.stiffness": MOTORS, "clamp_compliance.compliance": clamp})
    rows = identified(
        truth.modes(points), rng=np.random.default_rng(1), sigma=0.002, modes=3, band=(5.0, 100.0)
    )
    assert len(rows) == 3 * len(points)
    modes.write_text(written(rows, points, ()), encoding="utf-8")
    return robot, modes


@pytest.fixture(scope="module", params=CLAMPS)
def hidden(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[float, Robot, Diagnosis]:
    robot, modes = files(tmp_path_factory.mktemp("tower"), request.param)
    declared = pkmodes.read_robot(robot)
    return request.param, declared, updating.diagnose(declared, updating.read(modes))


def test_a_saved_interval_contains_the_truth_whatever_was_not_seen(
    hidden: tuple[float, Robot, Diagnosis], tmp_path: Path
) -> None:
    clamp, robot, found = hidden
    assert found.verdict == "adequate"
    (motors,) = (value for value in found.refitted if value.name == STIFFNESS)
    if clamp > CLAMPS[0]:  # what the fit says of itself is wrong
        assert abs(motors.after - MOTORS) > 2.0 * motors.sigma
    assert abs(motors.after - MOTORS) < 2.0 * motors.saved_sigma
    saved = tmp_path / "saved.toml"
    updating.save_robot(robot, found, saved)
    quantity = pkmodes.read_robot(saved).quantities[STIFFNESS]
    assert quantity.value == pytest.approx(motors.after, rel=1e-5)
    assert quantity.sigma == pytest.approx(motors.saved_sigma, rel=1e-2)
    (line,) = (
        line for line in saved.read_text(encoding="utf-8").splitlines() if line.startswith("stiffness")
    )
    assert "sigma allows for an undetected " in line
    assert f" (fit alone: {motors.sigma:.2g} N*m/rad)" in line


def test_the_limit_of_a_hidden_clamp_is_above_it(hidden: tuple[float, Robot, Diagnosis]) -> None:
    clamp, _, found = hidden
    limit = found.limits["clamp_compliance.compliance"]
    assert limit.unit == "m/N"
    assert limit.value is not None
    assert clamp < limit.value < 10.0 * clamp


def test_all_candidates_that_are_not_claimed_have_limits_and_none_is_detectable_without(
    hidden: tuple[float, Robot, Diagnosis],
) -> None:
    _, _, found = hidden
    assert {limit.candidate for limit in found.limits.values()} == {one.name for one in found.candidates}
    unbounded = {limit.candidate for limit in found.limits.values() if limit.value is None}
    detectable = {one.name for one in found.candidates if one.detectable}
    assert not unbounded & detectable
    assert set(found.undetectable) == {one.name for one in found.candidates} - detectable
    # No gravity other than that of the Earth is plausible, nor one that only another planet's would show.
    assert found.limits["gravity.z"].value is None
    assert next(one for one in found.candidates if one.name == "parameter:gravity.z").visible_from == ()
    factors = [f"axis_belt_stiffness.factor_{k}" for k in (1, 2, 3)]
    assert all(found.limits[name].value is not None for name in factors)


def test_the_command_says_what_is_not_excluded_and_what_widened_the_file(tmp_path: Path) -> None:
    robot, modes = files(tmp_path, CLAMPS[1])
    code, out, err = call(robot, modes, "--save-robot", tmp_path / "saved.toml")
    assert (code, err) == (0, "")
    assert max(len(line) for line in out.splitlines() if not line.startswith("wrote ")) <= 80
    text = " ".join(out.split())
    assert "not excluded at 95 %: " in text
    assert "all limits: --json or --report" in text
    assert "the sigmas in it allow for candidates that these data do not show: " in text
    assert "servo_stiffness.stiffness" in text.partition("the sigmas in it")[2]
