"""Frequency responses from linear systems of all coordinates in 40 digits, and errors relative to each channel."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

import pkmodes
from helpers.references.high_precision import mp as digits
from helpers.references.high_precision import solved
from helpers.references.motors_by_hand import followers, motor_angles

mp = digits.clone()
mp.dps = 40


class Oracle:
    """The equations of docs/how-to/response.md at one pose, in 40 digits: modes, damping ratios and responses."""

    def __init__(self, model: pkmodes.Model, p: np.ndarray, drives: str) -> None:
        self.model = model
        M, K = model.matrices(p)
        viscous, loss = (matrix[0] for matrix in model.dissipation.matrices(p[None]))
        T, S = followers(model, drives)
        self.M, self.K, self.C, self.loss, self.T, self.S = (
            mp.matrix(np.asarray(a).tolist()) for a in (M, K, viscous, loss, T, S)
        )
        ratio, rigid = model.robot.damping_ratio, model.modes(p, drives=drives).rigid_modes
        if ratio:
            mass, stiffness = (_rounded(T.T @ a @ T) for a in (M, K))
            exact = solved(digits.matrix(mass.tolist()), digits.matrix(stiffness.tolist()))
            for i in range(rigid, len(exact.eigenvalues)):
                momentum = self.M * self.T * mp.matrix(exact.shapes[:, i].tolist())
                self.C += 2 * mp.mpf(ratio) * mp.sqrt(abs(exact.eigenvalues[i])) * momentum * momentum.T

    def values(
        self, omega: Sequence[float], forces: np.ndarray, motors: np.ndarray, outputs: np.ndarray
    ) -> np.ndarray:
        """Responses of outputs to generalised forces and prescribed motor angles, (F, outputs, inputs)."""
        B, U, L = (mp.matrix(a.tolist()) for a in (forces, motors, outputs))
        found = []
        for w in omega:
            s = mp.mpc(0, w)
            Z = self.K + mp.mpc(0, 1) * self.loss + s * self.C + s * s * self.M
            free = self.T.T * Z * self.T
            right = self.T.T * (B - Z * (self.S * U))
            d = [1 / mp.sqrt(abs(free[i, i])) for i in range(free.rows)]
            scale = mp.diag(d)
            y = scale * (mp.inverse(scale * free * scale) * (scale * right))
            H = L * (self.T * y + self.S * U)
            found.append([[complex(H[o, i]) for i in range(H.cols)] for o in range(H.rows)])
        return np.array(found)


def _rounded(matrix: np.ndarray) -> np.ndarray:
    """Without what cancels to rounding: a coordinate without inertia has none."""
    size = np.sqrt(np.outer(np.abs(np.diag(matrix)), np.abs(np.diag(matrix))))
    return np.where(np.abs(matrix) <= 1e-13 * np.maximum(size, 1e-300), 0.0, matrix)


def ports(
    model: pkmodes.Model, drives: str, p: np.ndarray
) -> tuple[list[str], list[Any], np.ndarray, np.ndarray, np.ndarray]:
    """All inputs and outputs by name, with forces, motor angles and outputs as matrices."""
    n, angles = len(model.coordinates), motor_angles(model)
    directions = model.mechanism.directions
    platform = model.system.platform_motion(p[None])[0]
    motors = [f"{'torque' if drives == 'free' else 'motor'}_{j}" for j in range(1, len(angles) + 1)]
    inputs = [f"force_{d}" for d in directions] + motors
    oblique = np.arange(1.0, len(directions) + 1)
    outputs = [f"p_{d}" for d in directions] + [{"oblique": oblique.tolist()}]
    outputs += [f"motor_{j}" for j in range(1, len(angles) + 1)] + list(model.coordinates)
    L = np.vstack([platform, oblique @ platform / np.linalg.norm(oblique), angles, np.eye(n)])
    count = len(directions)
    B, U = np.zeros((n, len(inputs))), np.zeros((len(angles), len(inputs)))
    B[:, :count] = platform.T
    if drives == "free":
        B[:, count:] = angles.T
    else:
        U[:, count:] = np.eye(len(angles))
    return inputs, outputs, B, U, L


def frequencies_of(model: pkmodes.Model, p: np.ndarray, drives: str) -> np.ndarray:
    """Below, at and beside the first and the highest vibration, and between; 0 Hz where nothing is rigid."""
    modes = model.modes(p, drives=drives)
    found = np.abs(modes.frequencies[modes.rigid_modes :])
    least = 2.0 if modes.rigid_modes else 0.0
    between = np.sqrt(found[0] * found[-1])
    return np.array([least, found[0], 1.02 * found[1], between, found[-1], 1.5 * found[-1]])


def size_of(true: np.ndarray, units: Sequence[Sequence[str]]) -> np.ndarray:
    """The peak of each channel, or a thousandth of the largest of another output of its unit."""
    peak = np.abs(true).max(axis=0)
    of_unit = np.array([[unit == other for other in units] for unit in units])
    return np.maximum(peak, 1e-3 * np.array([peak[same].max(axis=0) for same in of_unit]))


def assert_exact(
    model: pkmodes.Model,
    p: np.ndarray,
    drives: str,
    frequencies: np.ndarray | None = None,
    tolerance: float = 1e-10,
) -> None:
    """Every output to every input, to a part of the size of the channel."""
    at = frequencies_of(model, p, drives) if frequencies is None else frequencies
    inputs, outputs, B, U, L = ports(model, drives, p)
    true = Oracle(model, p, drives).values(2 * np.pi * at, B, U, L)
    found = model.frf(p, at, inputs, outputs, drives=drives)
    assert found.values.shape == true.shape
    assert found.inputs == tuple(inputs)
    sizes = size_of(true, found.units)
    errors = np.abs(found.values - true).max(axis=0) / np.where(sizes == 0.0, 1.0, sizes)
    worst = np.unravel_index(errors.argmax(), errors.shape)
    assert errors.max() < tolerance, f"{found.outputs[worst[0]]}/{found.inputs[worst[1]]}"
