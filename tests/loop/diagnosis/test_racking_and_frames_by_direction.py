"""Diagnoses of a CoreXY on the rig: a beam that racks, a frame that yields in one direction, what is suspected."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes import updating
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.updating.candidates import suspects
from pkmodes_rig import corexy, drawn_values, identified, written
from pkmodes_rig.robots import with_free_motors
from studies.clear_cases import ClearCase, run
from studies.specimens import KINDS, ROBOTS, SIGMA, measurements_of

POINTS, SHAPES = KINDS["corexy"].points, KINDS["corexy"].shapes
BAND = (2.0, 202.0)


def printer(folder: Path, tables: str = "") -> Robot:
    """Return the printer whose file gives the moment of inertia of the beam."""
    text = with_free_motors(ROBOTS / "corexy-printer.toml")
    text = text.replace("[gantry] ", "[gantry]\ninertia = 0.0093\n#") + tables
    (folder / "robot.toml").write_text(text, encoding="utf-8")
    return pkmodes.read_robot(folder / "robot.toml")


def diagnosed(robot: Robot, effects: Mapping[str, float], drives: str) -> updating.Diagnosis:
    """Diagnose modes of a machine with these effects and other values within their priors."""
    rng = np.random.default_rng([1, 14, 0])
    true = robot.with_values(drawn_values(robot, rng)).parameters
    every = {**robot.constants, **effects}
    modes = [corexy(true, p, every, held=drives == "held") for p in POINTS]
    rows = identified(modes, rng=rng, sigma=SIGMA, band=BAND, shapes=SHAPES, shape_noise=0.02, base_rigid=2)
    text = written(rows, list(POINTS), SHAPES, components=("x", "y"), drives=[drives] * len(POINTS))
    return updating.diagnose(robot, measurements_of(text, robot))


def test_a_racking_beam_is_named_with_its_compliance(tmp_path: Path) -> None:
    found = diagnosed(printer(tmp_path), {"gantry_racking.compliance": 1e-4}, "held")
    assert [effect.members for effect in found.effects] == [("gantry_racking",)]
    (value,) = found.effects[0].parameters
    assert value.value == pytest.approx(1e-4, abs=4.0 * value.sigma)


def test_a_frame_that_yields_along_y_is_not_called_one_that_yields_everywhere(tmp_path: Path) -> None:
    found = diagnosed(printer(tmp_path), {"frame_compliance.compliance_y": 1.5e-7}, "free")
    names = {name for effect in found.effects for name in effect.members}
    names |= {name for group in found.survivors for name in group}
    assert "frame_compliance.compliance_y" in names


def test_a_frame_that_yields_everywhere_is_named_although_one_direction_leaves_noise_in_the_frequencies() -> (
    None
):
    # The direction along x explains the frequencies to noise, no better, and the shapes far worse.
    outcome = run(ClearCase("frames", 4, "published", ("frame_compliance",), (9.0, 14.0), seed=77))
    assert (outcome.state, outcome.classes) == ("named", (("frame_compliance",),))


def suspected(robot: Robot) -> set[str]:
    return {c.name for c in suspects(robot)[1] if c.claimable}


def test_what_is_suspected_of_a_frame_and_a_beam(tmp_path: Path) -> None:
    by_direction = {"frame_compliance.compliance_x", "frame_compliance.compliance_y"}
    plain = suspected(printer(tmp_path))
    assert plain >= {"frame_compliance", "gantry_racking", *by_direction}
    without = suspected(pkmodes.read_robot(ROBOTS / "corexy-printer.toml"))
    assert plain - without == {"gantry_racking"}
    one = printer(tmp_path, "\n[effects.frame_compliance]\ncompliance_y = 1e-7\n")
    assert plain - suspected(one) == {"frame_compliance"}
    with pytest.raises(PkmodesError, match="frame_compliance is not suspected: the robot file declares"):
        suspects(one, ["frame_compliance"])
    isotropic = printer(tmp_path, "\n[effects.frame_compliance]\ncompliance = 1e-7\n")
    assert plain - suspected(isotropic) == by_direction
    exact = "\n[effects.frame_compliance]\ncompliance_y = { value = 1e-7, sigma = 0 }\n"
    assert plain - suspected(printer(tmp_path, exact)) == {
        "frame_compliance",
        "frame_compliance.compliance_y",
    }
