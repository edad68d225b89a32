"""The angles of rods to their singular directions, against the constraint Jacobians and by hand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.regular import regular_poses
from pkmodes.core.mechanism.rods import rods_of, singular_angles

ROBOTS = Path(__file__).parents[2] / "robots"


@pytest.mark.parametrize("name", ["linear-delta-2022", "clavel-delta"])
def test_they_are_those_of_the_constraint_jacobians(name: str) -> None:
    """Rows of D_l are the rods' vectors, and the diagonal of D_r their components along the motions of their joints.

    So |D_r| = l |t| sin(angle), with |t| = 1 on a rail and the length of an arm.
    """
    robot = pkmodes.read_robot(ROBOTS / f"{name}.toml")
    generated = Generated(robot.mechanism.model, robot.parameters)
    poses = regular_poses(generated, robot.mechanism, robot.parameters, 20)
    D_l, D_r = generated.constraint_jacobians(poses)
    size = np.linalg.norm(D_l, axis=-1) * np.broadcast_to(getattr(robot.parameters, "arm_length", 1.0), (3,))
    expected = np.arcsin(np.abs(np.diagonal(D_r, axis1=1, axis2=2)) / size)
    angles = singular_angles(robot.mechanism, robot.parameters, poses)
    assert len(poses) == 20
    np.testing.assert_allclose(angles, np.repeat(expected, 2, axis=1), rtol=1e-9)  # two rods a linkage


def test_a_rod_perpendicular_to_its_rail_has_none() -> None:
    """On a rail along x the first rod of the published robot is as long as its joint is far from the rail."""
    robot = pkmodes.read_robot(ROBOTS / "linear-delta-2022.toml")
    first = np.asarray(robot.parameters.origin)[0] - np.asarray(robot.parameters.joint)[0]
    length = np.asarray(robot.parameters.link_length)[0]
    for angle in (0.3, 0.02):
        away = length * np.cos(angle)
        pose = first + [0.6, 0.6 * away, -0.8 * away]
        found = singular_angles(robot.mechanism, robot.parameters, pose[None])
        assert found[0, :2] == pytest.approx(angle, rel=1e-9)
    beyond = first + [0.6, 0.0, -1.01 * length]
    assert np.isnan(singular_angles(robot.mechanism, robot.parameters, beyond[None])[0, 0])


def test_arms_are_no_rods_and_a_gantry_has_none() -> None:
    clavel, printer = (
        pkmodes.read_robot(ROBOTS / f"{name}.toml").mechanism for name in ("clavel-delta", "corexy-printer")
    )
    assert [rod.coordinate for rod in rods_of(clavel)] == [0, 0, 1, 1, 2, 2]
    assert rods_of(printer) == ()
