"""What the structure of matrices is read from is drawn once: six dimensions have few regular poses, found slowly."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from helpers.references.oracle_six_legged import modes, result
from helpers.references.six_legs_compared import load
from helpers.robots.one_of_each import ROBOTS
from helpers.robots.six_legged import MACHINES
from pkmodes import read_robot
from pkmodes.core.mechanism import regular
from pkmodes.loop.sensitivity.matrices import geometry_of


def test_a_machine_is_not_searched_for_a_regular_pose_again(monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism = read_robot(ROBOTS / "hexapod.toml").mechanism
    geometry = geometry_of(mechanism)
    monkeypatch.setattr(regular, "draw_poses", None)  # cannot be called
    assert geometry_of(mechanism) == geometry
    pose = regular.sample_pose(mechanism)
    with pytest.raises(ValueError, match="read-only"):
        pose += 1.0


@pytest.mark.parametrize("name", MACHINES)
def test_machines_with_six_legs_have_modes_with_held_motors(name: str, tmp_path: Path) -> None:
    """Which of their coordinates have inertia is read at a regular pose, of which the hexaglide has few."""
    case = MACHINES[name](3)
    expected = result(*case)
    held = modes(expected.M, expected.K, expected.motors).frequencies
    found = load(case.machine, tmp_path).frequencies(case.pose, drives="held")
    np.testing.assert_allclose(found, held, rtol=1e-9)
