"""A small sine through the nonlinear generated equations of motion: the frequency response, in time.

The motion starts as the frequency response says.  If that is right, it goes on as the same sine; if amplitude or
phase of any coordinate were wrong, the difference would ring.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import pkmodes
from pkmodes_generated.linear_delta import model as generated

ROBOT = Path(__file__).parents[3] / "robots/linear-delta-2022-identified.toml"
POSE, FRICTION, PERIODS = np.array([0.55, 0.04, -0.23]), 30.0, 4
COORDINATES = (*(f"x_{j}" for j in (1, 2, 3)), *(f"theta_{j}_{k}" for k in (1, 2) for j in (1, 2, 3)))


@pytest.mark.parametrize("frequency", [8.0, 24.0, 31.0, 60.0])
@pytest.mark.parametrize("into", ["force_x", "motor_2"])
def test_a_small_sine_stays_the_one_that_the_response_says(into: str, frequency: float) -> None:
    robot = pkmodes.load(ROBOT).with_values({"effects.rail_friction.viscous": FRICTION})
    q = robot.robot.parameters
    found = robot.frf(POSE, [frequency], [into], [*COORDINATES, "p_x", "p_y", "p_z"], drives="held")
    size, omega = {"force_x": 1e-2, "motor_2": 1e-5}[into], 2.0 * np.pi * frequency
    response = size * found.values[0, :, 0]
    driven = [3 + j + (0 if q.drive[j][0] else 3) for j in range(3)]
    free = [i for i in range(9) if i not in driven]
    start = generated.inverse_kinematics(POSE, q)
    assembly = np.sign(generated.jacobian_condition(POSE, q)[0])
    weight = generated.gravity_gradient(POSE, q)
    motor = driven[1] if into == "motor_2" else None

    def rates(time: float, state: np.ndarray) -> np.ndarray:
        moved, speed = np.zeros((2, 9))
        moved[free], speed[free] = np.split(state, 2)
        force = np.zeros(9)
        if motor is not None:
            moved[motor] = size * np.cos(omega * time)
        p = generated.direct_kinematics(start + moved[:3], assembly, q)
        if motor is None:
            force[:3] = generated.platform_jacobian(p, q).T @ np.array(
                [size * np.cos(omega * time), 0.0, 0.0]
            )
        force -= generated.elastic_gradient(POSE, moved, q)
        force[:3] += weight - generated.gravity_gradient(p, q) - generated.velocity_forces(p, speed[:3], q)
        force[:3] -= FRICTION * speed[:3]
        M = generated.mass_matrix(p, q)[np.ix_(free, free)]
        return np.concatenate([speed[free], np.linalg.solve(M, force[free])])

    begin = np.concatenate([response[free].real, (1j * omega * response[free]).real])
    time = np.linspace(0.0, PERIODS / frequency, 200)
    states = solve_ivp(rates, (0.0, time[-1]), begin, method="DOP853", t_eval=time, rtol=1e-9, atol=1e-15)
    assert states.success
    expected = (response[free][:, None] * np.exp(1j * omega * time)).real
    largest = np.abs(response[free]).max()
    assert np.abs(states.y[:6] - expected).max() < 1e-3 * largest
    for x, p in zip(
        states.y[:3].T[::20], (response[9:, None] * np.exp(1j * omega * time[::20])).real.T, strict=True
    ):
        moved = generated.direct_kinematics(start + x, assembly, q) - POSE
        assert np.abs(moved - p).max() < 1e-3 * np.abs(response[9:]).max()
