"""Robots without any symmetry of other mechanisms than the linear delta, and effects that change every mode.

They start from the sample of each mechanism's description, with every number and direction changed at random.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from functools import cache
from importlib import import_module
from importlib.resources import files
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from helpers.references.high_precision_mechanisms import Compared, HighPrecision, Reference, exact_values
from helpers.references.oracle_corexy import CoreXY
from helpers.references.oracle_rotary_delta import RotaryDelta
from pkmodes.core.mechanism.registry import supplied_names

ORACLES: dict[str, type[HighPrecision]] = {"rotary_delta": RotaryDelta, "corexy": CoreXY}
NAMES = tuple(ORACLES)
SEEDS = range(4)

#: Of all effects with their parameters, values that matter beside the samples.
TYPICAL = {
    "axis_belt_stiffness_factor_1": 0.05,
    "axis_belt_stiffness_factor_2": -0.1,
    "axis_reducer_stiffness_factor_1": 0.06,
    "axis_reducer_stiffness_factor_2": -0.09,
    "axis_reducer_stiffness_factor_3": 0.13,
    "belt_end_compliance_compliance": 3e-6,
    "belt_mass_linear_density": 0.07,
    "belt_tension_stiffness_coefficient": 2e-3,
    "belt_tension_stiffness_tension": 45.0,
    "cable_stiffness_stiffness": 700.0,
    "gearbox_inertia_inertia": 3e-3,
    "payload_mass": 0.35,
    "servo_stiffness_stiffness": 900.0,
    "gearbox_compliance_compliance": 2e-2,
    "clamp_compliance_compliance": 4e-6,
    "link_compliance_compliance": 3e-7,
    "frame_compliance_compliance": 2e-6,
    "frame_compliance_mass": 40.0,
    "frame_compliance_compliance_x": 5e-7,
    "frame_compliance_compliance_y": 3e-6,
    "frame_compliance_compliance_z": 8e-7,
    "gantry_racking_compliance": 2e-4,
    "gantry_racking_inertia": 0.013,
    "gantry_racking_center": 0.11,
    "belt_loss_loss_factor": 0.02,
    "reducer_loss_loss_factor": 0.03,
    "rail_friction_viscous": 20.0,
    "drive_friction_viscous": 1e-3,
}
#: Effects that are tried together, by their names; one that does not apply is left out.
TOGETHER = {
    "nothing": (),
    "clamps with belt mass": ("clamp_compliance", "belt_mass"),
    "belts": ("belt_tension_stiffness", "belt_end_compliance", "axis_belt_stiffness"),
    "wind-up of a heavy gear box": ("gearbox_compliance", "gearbox_inertia", "servo_stiffness"),
    "long links on a frame": ("link_compliance", "frame_compliance", "payload"),
    "a beam that turns, on a frame by direction": (
        *("gantry_racking", "frame_compliance_mass", "frame_compliance_compliance_y", "payload", "belt_mass"),
    ),
    "held to ground": ("cable_stiffness", "servo_stiffness", "frame_compliance"),
    "everything": ("",),
}


class Sample(NamedTuple):
    """Parameters of the generated model, and a pose."""

    parameters: Any
    pose: np.ndarray


def model(name: str) -> ModuleType:
    return import_module(f"pkmodes_generated.{name}.model")


def extended(name: str) -> ModuleType:
    return import_module(f"pkmodes_generated.{name}.extended")


@cache
def description(name: str) -> dict[str, Any]:
    text = (files("pkmodes_generated") / name / "description.json").read_text(encoding="utf-8")
    return dict(json.loads(text))


def effect_names(name: str) -> list[str]:
    return [effect["name"] for effect in description(name)["effects"]]


def effects(name: str, chosen: Iterable[str] = ()) -> Any:
    """Effects of typical values: those whose names begin as one of the chosen ones."""
    fields = extended(name).Effects._fields
    return extended(name).Effects(**{f: TYPICAL[f] for f in fields if any(f.startswith(c) for c in chosen)})


def sampled() -> tuple[str, ...]:
    """Mechanisms of which there are samples: those with a function here, and all that move in a workspace."""
    return tuple(
        name for name in supplied_names() if name in NAMES or "workspace" in description(name)["sample"]
    )


@cache
def sample(name: str, seed: int) -> Sample:
    """A robot and a pose of it."""
    rng = np.random.default_rng([seed, len(name)])
    own = {"rotary_delta": _rotary_delta, "corexy": _corexy}
    return own[name](rng) if name in own else _in_workspace(_varied(name, rng), rng)


def oracle(name: str, robot: Sample, chosen: Any) -> HighPrecision:
    values, active = (exact_values(group._asdict()) for group in (robot.parameters, chosen))
    return ORACLES[name](values, active, robot.pose)


@cache
def reference(name: str, seed: int, chosen: Any) -> Reference:
    """What the oracle has for a sample with these effects."""
    return Compared(oracle(name, sample(name, seed), chosen)).reference


def _varied(name: str, rng: np.random.Generator) -> Any:
    """The description's sample with every number changed by up to a fifth."""
    values = {field: np.asarray(value) for field, value in description(name)["sample"].items()}
    values = {field: value * rng.uniform(0.8, 1.2, value.shape) for field, value in values.items()}
    return model(name).Parameters(**values)


def _unit(vectors: np.ndarray) -> np.ndarray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def _rotary_delta(rng: np.random.Generator) -> Sample:
    """Axes tilted, either branch of each arm, a platform above or below that the loops reach in good condition."""
    generated = model("rotary_delta")
    below = rng.choice([-1.0, 1.0])
    while True:
        robot = _varied("rotary_delta", rng)
        axis = _unit(robot.axis + rng.normal(scale=0.15, size=(3, 3)))
        zero = robot.zero + rng.normal(scale=0.3, size=(3, 3))
        zero = _unit(zero - np.sum(zero * axis, axis=-1, keepdims=True) * axis)
        zero = _unit(zero - np.sum(zero * axis, axis=-1, keepdims=True) * axis)  # square to rounding
        robot = robot._replace(
            axis=axis,
            zero=zero,
            gravity=9.81 * _unit(rng.normal(size=3)),
            branch=rng.choice([-1.0, 1.0], 3),
        )
        pose = np.array([*rng.uniform(-0.15, 0.15, 2), below * rng.uniform(0.3, 0.6)])
        if np.min(generated.reach_margin(pose, robot)) < 0.03:
            continue
        if generated.jacobian_condition(pose, robot)[1] < 12:
            return Sample(robot, pose)


def _corexy(rng: np.random.Generator) -> Sample:
    """Any two directions that cross, runs that keep a length, a tool head anywhere in the workspace."""
    robot = _varied("corexy", rng)
    first = rng.choice([-1.0, 1.0], 2)
    other = rng.choice([-1.0, 1.0]) * first * [1.0, -1.0]
    lengths = rng.uniform(0.7, 1.1, (2, 2))
    robot = robot._replace(belt_path_direction=np.array([first, other]), belt_path_lengths=lengths)
    return _in_workspace(robot, rng)


def _in_workspace(robot: Any, rng: np.random.Generator) -> Sample:
    """Gravity in any direction, a pose anywhere in the workspace."""
    robot = robot._replace(gravity=9.81 * _unit(rng.normal(size=3)))
    low, high = robot.workspace.T
    return Sample(robot, low + (high - low) * rng.uniform(0.1, 0.9, 2))
