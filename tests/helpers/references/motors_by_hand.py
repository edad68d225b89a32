"""Motors as docs/model.md has them: their angles, and the coordinates that are left where they are held."""

from __future__ import annotations

import numpy as np

import pkmodes


def motor_angles(model: pkmodes.Model) -> np.ndarray:
    """The angle of each motor per unit of each coordinate, as docs/model.md says, (drives, n)."""
    names, q = model.coordinates, model.robot.parameters
    if model.robot.mechanism_name == "linear_delta":
        driven = [f"theta_{j}_{np.argmax(drive) + 1}" for j, drive in enumerate(q.drive, 1)]
    else:
        driven = [name for name in names if name.startswith("phi_" if "phi_1" in names else "theta_")]
    return np.array(
        [[name in (rotor, f"psi_{j}") for name in names] for j, rotor in enumerate(driven, 1)], float
    )


def followers(model: pkmodes.Model, drives: str) -> tuple[np.ndarray, np.ndarray]:
    """All coordinates per unit of those that are left, T, and of the motors, S, where these are prescribed."""
    n, angles = len(model.coordinates), motor_angles(model)
    if drives == "free":
        return np.eye(n), np.zeros((n, len(angles)))
    T, S = np.eye(n), np.zeros((n, len(angles)))
    heads = [int(np.flatnonzero(row)[0]) for row in angles]
    for j, (head, row) in enumerate(zip(heads, angles, strict=True)):
        T[head] -= row
        S[head, j] = 1.0
    return np.delete(T, heads, axis=1), S
