"""The supplied robots with losses, friction, a damping ratio and other effects."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import FILES, ROBOTS

LOSSES = {"belt_loss.loss_factor": 0.03, "reducer_loss.loss_factor": 0.05}
FRICTION = {"rail_friction.viscous": 7.0, "drive_friction.viscous": 2e-3}
DAMPING = LOSSES | FRICTION
#: Effects to be tried together with losses and friction.
EFFECTS: dict[str, Mapping[str, float]] = {
    "plain": {},
    "series": {"belt_end_compliance.compliance": 2e-6},
    "gearbox": {"gearbox_compliance.compliance": 2e-3},
    "uneven": {"axis_belt_stiffness.factor_2": 0.3, "axis_reducer_stiffness.factor_2": -0.2},
    "tension": {"belt_tension_stiffness.coefficient": 4e-3, "belt_tension_stiffness.tension": 50.0},
    "massless": {"clamp_compliance.compliance": 1e-6},
    "everything": {
        "payload.mass": 0.2,
        "cable_stiffness.stiffness": 3e3,
        "belt_end_compliance.compliance": 2e-6,
        "axis_belt_stiffness.factor_1": -0.2,
        "axis_reducer_stiffness.factor_3": 0.1,
        "belt_tension_stiffness.coefficient": 4e-3,
        "belt_tension_stiffness.tension": 50.0,
        "gearbox_inertia.inertia": 2e-5,
        "gearbox_compliance.compliance": 2e-3,
        "link_compliance.compliance": 1e-7,
        "clamp_compliance.compliance": 1e-6,
        "frame_compliance.compliance": 1e-7,
    },
}
#: Mechanisms with effects that change something: the rotary delta has no belts.
CASES = [
    (mechanism, name)
    for mechanism in FILES
    for name in EFFECTS
    if mechanism != "rotary_delta" or name in ("plain", "uneven", "everything")
]
#: Effects, and the damping ratio; all but one with every kind of damping.
DAMPED: dict[str, tuple[Mapping[str, float], float]] = {
    "plain": (DAMPING, 0.02),
    "ratio": ({}, 0.02),
    "light": ({path: 0.01 * value for path, value in DAMPING.items()}, 1e-4),
    "strong": ({path: 15.0 * value for path, value in DAMPING.items()}, 0.6),
    "gearbox": ({**DAMPING, "gearbox_compliance.compliance": 2e-3}, 0.01),
    "massless": ({**DAMPING, "clamp_compliance.compliance": 1e-6}, 0.01),
    "many": (
        {
            **DAMPING,
            "payload.mass": 0.2,
            "belt_end_compliance.compliance": 2e-6,
            "gearbox_inertia.inertia": 2e-5,
            "gearbox_compliance.compliance": 2e-3,
            "link_compliance.compliance": 1e-7,
            "clamp_compliance.compliance": 1e-6,
            "frame_compliance.compliance": 1e-7,
        },
        0.01,
    ),
    "springs": ({**DAMPING, "cable_stiffness.stiffness": 3e3, "servo_stiffness.stiffness": 40.0}, 0.01),
}
DRIVES = ("free", "held")
BACKENDS = ("numpy", pytest.param("compiled", marks=pytest.mark.compiler))


def repeated() -> tuple[pkmodes.Model, np.ndarray, np.ndarray]:
    """A robot with two equal held modes, a pose, and the ratios of its two belts.

    Compliances in series make losses of equally stiff belts differ.  Belt i alone moves its mass by |g_i|^2 = 2.
    """
    p, c, eta = np.array([0.1, 0.05]), 2e-5, 0.02
    plain = pkmodes.load(ROBOTS / FILES["corexy"]).with_values({"belt_path.1.lengths.1": 0.31})
    q = plain.robot.parameters
    lengths = np.array(
        [
            [runs[0] + g @ p, runs[1] - g @ p]
            for g, runs in zip(q.belt_path_direction, q.belt_path_lengths, strict=True)
        ]
    )

    def stiffness(modulus: float, i: int) -> tuple[float, float]:
        k = 1 / (lengths[i] / modulus + c)
        return float(k.sum()), float((k**2 * lengths[i] / modulus).sum())

    modulus = q.belt_specific_stiffness[0] * q.belt_width[0]
    aim, lossy = stiffness(modulus, 0)
    low, high = 0.2 * modulus, 5 * modulus
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if stiffness(middle, 1)[0] < aim else (low, middle)
    other = stiffness(low, 1)[1]
    model = plain.with_values(
        {
            "gantry.mass": 0.0,
            "belt_path.2.belt.width": low / q.belt_specific_stiffness[0],
            "effects.belt_end_compliance.compliance": c,
            "effects.belt_loss.loss_factor": eta,
        }
    )
    return model, p, eta / 2 * np.sort([lossy, other]) / aim
