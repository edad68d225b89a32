"""Robots with effects of every size, and the poses at which their sensitivities are tested.

Every robot of `CASES` is tested at generic poses, and one of each kind with repeated modes, nearly equal modes, or a
coordinate without inertia.
"""

from __future__ import annotations

from functools import cache

import numpy as np

import pkmodes
from helpers.references.sensitivity_references import at_poses, robot_of, size
from helpers.robots.dissipating import dissipating
from helpers.robots.sample_robots import published, random_robot, tower_printer
from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.sensitivity.paths import paths, resolve
from pkmodes.loop.sensitivity.sensitivities import Sensitivities

Array = np.ndarray

#: All effects, with sizes that change every frequency and make no two of them equal by chance.
LARGE = {
    "payload.mass": 0.35,
    "belt_mass.linear_density": 0.06,
    "gearbox_inertia.inertia": 2e-4,
    "servo_stiffness.stiffness": 500.0,
    "belt_end_compliance.compliance": 1e-6,
    "axis_belt_stiffness.factor_1": 0.05,
    "axis_belt_stiffness.factor_2": -0.1,
    "axis_belt_stiffness.factor_3": 0.02,
    "belt_tension_stiffness.coefficient": 0.005,
    "belt_tension_stiffness.tension": 30.0,
    "cable_stiffness.stiffness": 1e3,
    "gearbox_compliance.compliance": 1e-3,
    "link_compliance.compliance": 1e-7,
    "clamp_compliance.compliance": 1e-6,
    "frame_compliance.compliance": 1e-7,
    "frame_compliance.mass": 40.0,
    "frame_compliance.compliance_x": 2e-8,
    "frame_compliance.compliance_y": 7e-8,
    "frame_compliance.compliance_z": 5e-8,
}
#: The same for the small printer, whose axes stay identical: at its centre it keeps its repeated eigenvalues.
SMALL = {
    "payload.mass": 0.1,
    "belt_mass.linear_density": 0.02,
    "gearbox_inertia.inertia": 3e-6,
    "servo_stiffness.stiffness": 1.0,
    "belt_end_compliance.compliance": 1e-5,
    "axis_belt_stiffness.factor_1": 0.05,
    "axis_belt_stiffness.factor_2": 0.05,
    "axis_belt_stiffness.factor_3": 0.05,
    "belt_tension_stiffness.coefficient": 0.005,
    "belt_tension_stiffness.tension": 20.0,
    "cable_stiffness.stiffness": 1e3,
    "gearbox_compliance.compliance": 0.5,
    "link_compliance.compliance": 1e-6,
    "clamp_compliance.compliance": 1e-5,
    "frame_compliance.compliance": 1e-5,
    "frame_compliance.mass": 4.0,
    "frame_compliance.compliance_x": 2e-6,
    "frame_compliance.compliance_y": 2e-6,
    "frame_compliance.compliance_z": 5e-6,
}
CLAMP = "clamp_compliance.compliance"
GENERIC, MIRROR, CENTRE, ASIDE = (
    [0.6, 0.03, -0.245],
    [0.62, 0.0, -0.245],
    [0.0, 0.0, 0.1],
    [0.05, -0.03, 0.17],
)
#: Found by search: two frequencies within a few parts in ten thousand of each other.
CROSSING = {"published": [0.579, 0.047, -0.279], "published-active": [0.635, 0.059, -0.236]}
CASES = [f"{robot}{kind}" for robot in ("published", "tower", "random") for kind in ("", "-active", "-clamp")]


def moving(robot: Robot) -> list[str]:
    """Return the paths that frequencies may depend on."""
    without = dissipating(robot.mechanism_name)
    return [path for path in paths(robot) if path.split(".")[1] not in without]


class Case:
    """A robot with its poses, its sensitivities and its modes."""

    def __init__(self, name: str) -> None:
        kind, _, detail = name.partition("-")
        if kind == "random":
            parameters, pose = random_robot(np.random.default_rng(12))
            poses = [pose]
        elif kind == "tower":
            parameters, poses = tower_printer().parameters, [CENTRE, ASIDE]
        else:
            parameters, poses = published().parameters, [GENERIC, MIRROR]
            poses += [CROSSING[name]] if name in CROSSING else []
        self.typical = SMALL if kind == "tower" else LARGE
        # A file has a frame by direction only in place of the isotropic one.
        active = {path: value for path, value in self.typical.items() if ".compliance_" not in path}
        effects = {"": {}, "active": active, "clamp": {CLAMP: self.typical[CLAMP]}}[detail]
        self.robot, self.poses = robot_of(parameters, effects), np.array(poses)
        self.names = [p for p in moving(self.robot) if p != "axis.joint_radius" or parameters.joint.any()]
        self.moves = [resolve(self.robot, path) for path in self.names]
        self.sizes = np.array([size(self.robot, move, self.typical) for move in self.moves])
        self.found: Sensitivities = pkmodes.Model(self.robot).sensitivities(self.poses, self.names)
        self.here = at_poses(self.robot, self.poses, self.found.groups)


@cache
def case(name: str) -> Case:
    return Case(name)


def system_of(robot: Robot) -> ExtendedSystem:
    return ExtendedSystem.of(robot)


def assert_small(error: Array, bound: Array, what: str, rows: list[str] | None = None) -> None:
    bad = np.argwhere(~(error <= bound))
    assert not len(bad), (
        what,
        bad,
        [rows[i[0]] for i in bad if rows],
        error[tuple(bad[0])],
        bound[tuple(bad[0])],
    )
