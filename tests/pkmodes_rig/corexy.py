"""The CoreXY on the virtual test rig: true modes with any effects of the catalogue and with causes outside it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.rows import Rows, completed, frame_compliance, without

#: Length of the yawing beam [m], and position of its middle.
BEAM, MIDDLE = 0.4, 0.15
BELTS = (0, 1)


def corexy(
    q: Any,
    p: np.ndarray,
    effects: Mapping[str, float] = {},
    outside: Mapping[str, float] = {},
    *,
    held: bool = False,
) -> TrueModes:
    """Compute the modes of a CoreXY at one pose.

    Parameters
    ----------
    q : Parameters
        One robot, without batch axes.
    p : array, shape (2)
    effects : mapping
        Parameters of effects in SI units, by ``"<effect>.<parameter>"``.
    outside : mapping
        Strengths of causes in `rows.OUTSIDE`.
    held : bool
        Whether the rotors of the motors are locked.
    """
    released = {
        "psi": effects.get("gearbox_compliance.compliance", 0.0),
        "eps": effects.get("clamp_compliance.compliance", 0.0),
    }
    names = ["x", "y", "theta_1", "theta_2", "psi_1", "psi_2", "eps_1", "eps_2", "u_x", "u_y"]
    names += ["absorber", "rack"]
    lever = p[0] - effects.get("gantry_racking.center", MIDDLE)
    head = np.zeros((2, len(names)))
    head[0, [0, 8]], head[1, [1, 9, 11]] = 1.0, (1.0, 1.0, lever)
    rows = Rows(names, head)
    beam = [rows.row(u_x=1.0), rows.row(y=1.0, u_y=1.0)]
    rows.inertia(head, q.toolhead_mass + effects.get("payload.mass", 0.0))
    rows.inertia(np.array(beam), q.gantry_mass)
    for i in BELTS:
        theta, psi, eps = (rows.row(**{f"{name}_{i + 1}": 1.0}) for name in ("theta", "psi", "eps"))
        rows.inertia(theta, q.pulley_inertia[i])
        rows.inertia(theta + psi, q.gear_ratio[i] ** 2 * q.motor_inertia[i])
        g = q.belt_path_direction[i]
        at_head = rows.row(x=g[0], y=g[1], rack=g[1] * lever) + eps
        at_pulley = -q.pulley_radius[i] * theta
        lengths = q.belt_path_lengths[i] + np.array([1.0, -1.0]) * (g @ p)
        unit = q.belt_width[i] * q.belt_specific_stiffness[i]
        unit *= 1.0 + effects.get(f"axis_belt_stiffness.factor_{i + 1}", 0.0)
        for run, length in enumerate(lengths):
            soft = effects.get("belt_end_compliance.compliance", 0.0)
            soft += outside.get("one_run", 0.0) if (i, run) == (0, 0) else 0.0
            rows.spring(at_head - at_pulley, 1.0 / (length / unit + soft))
            mass = effects.get("belt_mass.linear_density", 0.0) * length
            rows.inertia(at_head, mass / 6)  # linear between the ends: [[2, 1], [1, 2]] / 6
            rows.inertia(at_pulley, mass / 6)
            rows.inertia(at_head + at_pulley, mass / 6)
        for name, compliance in released.items():
            own = compliance + (outside.get("one_gearbox", 0.0) if (name, i) == ("psi", 0) else 0.0)
            if own:
                rows.spring(rows.row(**{f"{name}_{i + 1}": 1.0}), 1.0 / own)
    locked = [f"{name}_{i + 1}" for name, compliance in released.items() if not compliance for i in BELTS]
    if outside.get("one_gearbox"):
        locked.remove("psi_1")
    if racking := outside.get("racking_gantry") or effects.get("gantry_racking.compliance"):
        rows.inertia(
            rows.row(rack=1.0), effects.get("gantry_racking.inertia") or q.gantry_mass * BEAM**2 / 12
        )
        rows.spring(rows.row(rack=1.0), 1.0 / racking)
    else:
        locked.append("rack")
    locked += [name for name in ("u_x", "u_y") if not frame_compliance(name, effects)]
    completed(rows, "theta", effects, outside)
    return rows.modes([*locked, *without(outside)], rows.motors("theta") if held else ())
