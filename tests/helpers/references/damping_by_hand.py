"""C_v and K'' from the definitions of the catalogue of effects: span by span, rail by rail and motor by motor."""

from __future__ import annotations

import numpy as np

import pkmodes
from helpers.references.motors_by_hand import motor_angles


def arms(model: pkmodes.Model, p: np.ndarray) -> np.ndarray:
    """Positions of carriages, angles of arms, or the tool head: inverse kinematics of docs/model.md."""
    q = model.robot.parameters
    if model.robot.mechanism_name == "corexy":
        return np.array(p)
    r = p + q.joint - q.origin
    if model.robot.mechanism_name == "linear_delta":
        along = (r * q.direction).sum(axis=1)
        return along + q.branch * np.sqrt(q.link_length**2 - (r**2).sum(axis=1) + along**2)
    A, B = (r * q.zero).sum(axis=1), (r * np.cross(q.axis, q.zero)).sum(axis=1)
    C = ((r**2).sum(axis=1) + q.arm_length**2 - q.link_length**2) / (2 * q.arm_length)
    return np.arctan2(B, A) + q.branch * np.arccos(C / np.hypot(A, B))


def spans(model: pkmodes.Model, p: np.ndarray) -> list[tuple[int, float, dict[str, float]]]:
    """Axis, free length, and strain per unit of the coordinates of every belt span."""
    q, name = model.robot.parameters, model.robot.mechanism_name
    found: list[tuple[int, float, dict[str, float]]] = []
    if name == "corexy":
        for i, (g, R, runs) in enumerate(
            zip(q.belt_path_direction, q.pulley_radius, q.belt_path_lengths, strict=True)
        ):
            strain = {"x": g[0], "y": g[1], f"theta_{i + 1}": R, f"eps_{i + 1}": 1.0}
            found += [(i, runs[0] + g @ p, strain), (i, runs[1] - g @ p, strain)]
    elif name == "linear_delta":
        for i, (x, R) in enumerate(zip(arms(model, p), q.pulley_radius, strict=True)):
            (least, most), half = q.limits[i], q.carriage_length[i] / 2
            first, second = f"theta_{i + 1}_1", f"theta_{i + 1}_2"
            clamp = {f"x_{i + 1}": 1.0, f"eps_{i + 1}": 1.0}
            found += [
                (i, most - least, {first: R, second: -R}),
                (i, x - least - half, {**clamp, second: -R}),
                (i, most - x - half, {**clamp, first: -R}),
            ]
    return found


def loss_by_hand(model: pkmodes.Model, p: np.ndarray) -> np.ndarray:
    """K'' from the definition in the catalogue of effects."""
    q, names = model.robot.parameters, model.coordinates
    V: list[tuple[float, dict[str, float]]] = []
    for i, length, strain in spans(model, p):
        modulus = q.belt_width[i] * q.belt_specific_stiffness[i]
        modulus *= 1 + effect(model, f"axis_belt_stiffness.factor_{i + 1}")
        modulus *= 1 + effect(model, "belt_tension_stiffness.coefficient") * effect(
            model, "belt_tension_stiffness.tension"
        )
        k = 1 / (length / modulus + effect(model, "belt_end_compliance.compliance"))
        V.append((effect(model, "belt_loss.loss_factor") * k**2 * length / modulus, strain))
    eta = effect(model, "reducer_loss.loss_factor")
    if model.robot.mechanism_name == "rotary_delta":
        for j, k in enumerate(q.reducer_stiffness, 1):
            change = 1 + effect(model, f"axis_reducer_stiffness.factor_{j}")
            V.append((eta * k * change, {f"theta_{j}": 1.0, f"phi_{j}": -1.0}))
    c = effect(model, "gearbox_compliance.compliance")
    V += [(eta / c, {name: 1.0}) for name in names if name.startswith("psi_")]
    return quadratic(names, V)


def friction_by_hand(model: pkmodes.Model) -> np.ndarray:
    """C_v from the definition in the catalogue of effects: the motor turns by theta + psi."""
    names, kind = model.coordinates, model.robot.mechanism_name
    rails = {"linear_delta": ("x_1", "x_2", "x_3"), "corexy": ("x", "y"), "rotary_delta": ()}[kind]
    R = [(effect(model, "rail_friction.viscous"), {name: 1.0}) for name in rails]
    R += [
        (effect(model, "drive_friction.viscous"), dict(zip(names, angle, strict=True)))
        for angle in motor_angles(model)
    ]
    return quadratic(names, R)


def effect(model: pkmodes.Model, path: str) -> float:
    return model.robot.effects.get(path, 0.0)


def quadratic(names: tuple[str, ...], terms: list[tuple[float, dict[str, float]]]) -> np.ndarray:
    """Hessian of the sum of weight/2 (form)^2; locked coordinates are left out."""
    total = np.zeros((len(names), len(names)))
    for weight, form in terms:
        row = np.array([form.get(name, 0.0) for name in names])
        total += weight * np.outer(row, row)
    return total
