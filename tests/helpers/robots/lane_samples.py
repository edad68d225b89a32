"""Robots of every mechanism for the tests of the compiled evaluator, some of them hard to solve."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np

from helpers.robots import sample_mechanisms, sample_robots, six_legged
from helpers.robots.one_of_each import EVERY, ROBOTS
from pkmodes import read_robot
from pkmodes.core.compiled.evaluator import Evaluator
from pkmodes.core.compiled.lanes import FIELDS, RATE_FIELDS, Terms
from pkmodes.core.compiled.loader import load
from pkmodes.core.mechanism import registry
from pkmodes.core.mechanism.poses import MAX_CONDITION
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve import fields
from pkmodes.core.system.evaluation import Evaluation, ExtendedSystem
from pkmodes.loop.sensitivity.compiled import terms_of
from pkmodes.loop.sensitivity.paths import ParameterPath, paths, resolve_all

ROOT = Path(__file__).parents[3]
NAMES = ("linear_delta", "rotary_delta", "corexy", "cartesian", "bed_slinger")
#: Their platforms turn, with twelve and eighteen coordinates: large programs, of which few cases are tried.
SIX_LEGGED = ("hexapod", "hexaglide")
#: Names of effects by which combination is on.
EFFECTS = {
    "none": (),
    "massless clamps": ("clamp_compliance",),
    "massless clamps and more": ("clamp_compliance", "gearbox_compliance", "frame_compliance"),
    **sample_mechanisms.TOGETHER,
}
#: Values by field, each of which makes an eigenproblem of its own kind: factors of the parameters of these names.
EXTREMES = {
    "as it is": {},
    "no gravity": {"gravity": 0.0},
    "hundredfold gravity": {"gravity": 100.0},
    "soft belts": {"belt_specific_stiffness": 1 / 30, "reducer_stiffness": 1 / 30},
    "heavy motors": {"motor_inertia": 1e3},
    "light platform": {"platform_mass": 1e-3, "toolhead_mass": 1e-3},
}


class Case(NamedTuple):
    """A robot with effects of some values, and poses around a regular one."""

    mechanism: Mechanism
    parameters: Any
    evaluation: Evaluation
    poses: np.ndarray
    values: dict[str, float]


@cache
def robot(name: str, seed: int) -> tuple[Any, np.ndarray]:
    """Parameters and a pose; of the linear delta the first two robots are symmetric."""
    if name in SIX_LEGGED:
        machine, place = six_legged.MACHINES[name](seed)
        with TemporaryDirectory() as folder:
            file = Path(folder) / "robot.toml"
            file.write_text(six_legged.toml_text(machine), encoding="utf-8")
            return read_robot(file).parameters, np.array(place)
    if name == "linear_delta":
        rng = np.random.default_rng(seed)
        made = (sample_robots.published, sample_robots.tower_printer)
        found = made[seed]() if seed < len(made) else sample_robots.random_robot(rng)
        return found.parameters, found.pose
    found = sample_mechanisms.sample(name, seed)
    if name == "rotary_delta":  # the samples turn their axes anywhere
        limits = np.tile([-np.pi, np.pi], (3, 1))
        return found.parameters._replace(limits=limits), found.pose
    return found.parameters, found.pose


def case(name: str, seed: int, effects: str = "none", extreme: str = "as it is", count: int = 60) -> Case:
    mechanism = registry.mechanism(name)
    parameters, pose = robot(name, seed)
    factors = {k: v for k, v in EXTREMES[extreme].items() if k in parameters._fields}
    parameters = parameters._replace(
        **{k: np.asarray(getattr(parameters, k)) * v for k, v in factors.items()}
    )
    rng = np.random.default_rng(seed + 1000)
    poses = pose + 0.02 * rng.uniform(-1, 1, (count, len(pose)))
    poses[: count // 10] = pose  # symmetric where the robot is
    values = chosen(mechanism, EFFECTS[effects], typical(name, seed))
    evaluation = (
        ExtendedSystem(mechanism, parameters, values) if values else Evaluation(mechanism, parameters)
    )
    return Case(mechanism, parameters, evaluation, poses, values)


def typical(name: str, seed: int) -> dict[str, float]:
    """Values of effects that matter beside those of a robot."""
    if name not in SIX_LEGGED:
        return sample_mechanisms.TYPICAL
    found = six_legged.effects(
        six_legged.MACHINES[name](seed)
    )  # machines of any size have effects of their size
    return {f"{effect}_{key}": value for effect, table in found.items() for key, value in table.items()}


def chosen(mechanism: Mechanism, names: tuple[str, ...], values: dict[str, float]) -> dict[str, float]:
    """Values of the effects whose names are given, those that apply; an empty name means all."""
    return {
        f"{effect.name}.{parameter.name}": values[f"{effect.name}_{parameter.name}"]
        for effect in mechanism.effects.values()
        if effect.name in names or "" in names
        for parameter in effect.parameters
        if f"{effect.name}_{parameter.name}" in values
    }


def evaluator(given: Case) -> Evaluator:
    found, system = load(given.mechanism.package, given.mechanism.name), given.evaluation
    rigid = system.rigid_modes
    return Evaluator(found, system.lanes(), len(system.coordinates), MAX_CONDITION, rigid_modes=rigid)


def robot_of(given: Case) -> Robot:
    """The shipped robot of the mechanism with the parameters of a case, and no effects."""
    return replace(shipped(given.mechanism.name), parameters=given.parameters)


@cache
def shipped(name: str) -> Robot:
    return read_robot(ROBOTS / EVERY[name])


def directions(given: Case, names: Sequence[str] = ()) -> tuple[list[ParameterPath], Terms]:
    """All quantities that can vary, or those whose names are given."""
    robot = robot_of(given)
    system = given.evaluation
    if not isinstance(system, ExtendedSystem):
        system = ExtendedSystem(given.mechanism, given.parameters, {})
    found = resolve_all(robot, names or [path for path in paths(robot) if path != "axis.joint_radius"])
    return found, terms_of(system, found)


def results(
    given: Case, poses: np.ndarray, width: int | None = None
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    run = evaluator(given)
    varied, terms = directions(given)
    sizes = fields.axis_lengths(given.mechanism, run.modes, run.coordinates)
    tails = {name: fields.pose_shape(fields.FIELDS[name], sizes) for name in FIELDS if name != "eigenvalues"}
    tails |= {"eigenvalues": (run.modes,), **dict.fromkeys(RATE_FIELDS, (len(varied), run.modes))}
    # Poisoned, so that an entry that is not written shows.
    arrays = {name: np.full((len(poses), *tails[name]), 12345.0) for name in (*FIELDS, *RATE_FIELDS)}
    return run.run(np.ascontiguousarray(poses), arrays, width=width, terms=terms), arrays
