"""Rotary deltas with symmetries, or with loops so simple that their matrices follow by hand."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from helpers.robots.sample_mechanisms import Sample, sample
from pkmodes_generated.rotary_delta import Parameters

GRAVITY = 9.81
#: A third of a turn about the vertical, which takes each arm to where the next one is.
THIRD = Rotation.from_euler("z", 120, degrees=True).as_matrix()


def clavel(pose: tuple[float, float, float]) -> Sample:
    """The robot of the contract's example with its arm repeated after each third of a turn."""
    turns = np.array([np.linalg.matrix_power(THIRD, j) for j in range(3)])

    def around(vector: list[float]) -> np.ndarray:
        return turns @ np.array(vector)

    parameters = Parameters(
        platform_mass=0.25,
        gravity=np.array([0.0, 0.0, -GRAVITY]),
        origin=around([0.11, 0.0, 0.0]),
        axis=around([0.0, -1.0, 0.0]),
        zero=around([1.0, 0.0, 0.0]),
        joint=around([0.04, 0.0, 0.0]),
        arm_length=np.full(3, 0.24),
        arm_mass=np.full(3, 0.35),
        arm_center=np.full(3, 0.09),
        arm_inertia=np.full(3, 8e-3),
        link_length=np.full(3, 0.6),
        link_mass=np.full(3, 0.16),
        reducer_stiffness=np.full(3, 4000.0),
        motor_inertia=np.full(3, 6e-5),
        gear_ratio=np.full(3, 33.0),
        limits=np.tile(np.radians([-95.0, 40.0]), (3, 1)),
        branch=np.ones(3),
    )
    return Sample(parameters, np.array(pose))


def orthogonal(gravity: np.ndarray, theta: np.ndarray) -> Sample:
    """Platform at 0, link j along base axis j, as the end of arm j moves; arm j along the next base axis.

    So the platform moves by L_j along base axis j for each radian of arm j.  It is ahead of the ends of arms 1 and
    3, and behind that of arm 2.
    """
    q = sample("rotary_delta", 0).parameters
    along, ahead = np.eye(3), np.array([1.0, -1.0, 1.0])
    arm = along[[1, 2, 0]]
    # the arm at theta: cos z + sin u = arm and -sin z + cos u = along, so that z = cos arm - sin along
    c, s = np.cos(theta)[:, None], np.sin(theta)[:, None]
    ends = -(ahead * q.link_length)[:, None] * along
    parameters = q._replace(
        gravity=gravity,
        origin=ends - q.arm_length[:, None] * arm,
        axis=np.cross(arm, along),
        zero=c * arm - s * along,
        joint=np.zeros((3, 3)),
        # seen from the axis, a joint ahead of the arm has the larger angle: the arm is at that angle less acos
        branch=-ahead,
    )
    return Sample(parameters, np.zeros(3))


def turned(robot: Sample, turn: np.ndarray, shift: np.ndarray) -> Sample:
    """The same robot described in another base frame."""
    q = robot.parameters
    parameters = q._replace(
        gravity=turn @ q.gravity,
        origin=q.origin @ turn.T + shift,
        axis=q.axis @ turn.T,
        zero=q.zero @ turn.T,
        joint=q.joint @ turn.T,
    )
    return Sample(parameters, turn @ robot.pose + shift)


def reordered(parameters: Parameters, order: np.ndarray) -> Parameters:
    """The same robot with its axes in another order."""
    per_axis = {
        field: np.asarray(value)[order]
        for field, value in parameters._asdict().items()
        if field not in ("platform_mass", "gravity")
    }
    return parameters._replace(**per_axis)
