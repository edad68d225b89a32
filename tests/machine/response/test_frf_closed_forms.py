"""Frequency responses against closed forms: two masses, one mass shaken through its belt, and statics."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from helpers.references.motors_by_hand import followers
from helpers.references.response_in_40_digits import ports, size_of
from helpers.robots.damped_robots import DAMPED, DAMPING
from helpers.robots.one_of_each import FILES, POSES, load_free, model_of


def two_masses(**values: float) -> tuple[pkmodes.Model, np.ndarray]:
    """A CoreXY whose belts are alike at a pose, where motions along x and y are apart."""
    model = load_free(FILES["corexy"])
    lengths = {"belt_path.1.lengths.1": 0.45, "belt_path.1.lengths.2": 0.75}
    alike = {"belt_path.2.lengths.1": 0.65, "belt_path.2.lengths.2": 0.55}
    given = {path.replace("__", "."): value for path, value in values.items()}
    return model.with_values({**lengths, **alike, **given}), np.array([0.1, 0.04])


@pytest.mark.parametrize("zeta", [0.0, 0.02, 0.5])
@pytest.mark.parametrize("direction", ["x", "y"])
def test_free_motors_are_one_mass_and_the_tool_head_another(direction: str, zeta: float) -> None:
    """Along x both motors turn alike, but in opposite directions: 2 J/R^2 on a spring 2 k with loss to the head.

    With run 1 of belt i of length l, k = sum of w k_sp / l over both runs.  A ratio damps the only vibration like a
    dashpot 2 zeta omega mu in the belt, mu the reduced mass.
    """
    eta, b, b_motor = 0.04, 9.0, 3e-4
    model, p = two_masses(
        effects__belt_loss__loss_factor=eta,
        effects__rail_friction__viscous=b,
        effects__drive_friction__viscous=b_motor,
        damping__ratio=zeta,
    )
    q = model.robot.parameters
    # Belt 1: 450 mm + x - y and 750 mm - x + y; belt 2: 650 mm - x - y and 550 mm + x + y.
    runs = np.array([0.51, 0.69])
    R, modulus = q.pulley_radius[0], q.belt_width[0] * q.belt_specific_stiffness[0]
    k, J = 2 * (modulus / runs).sum(), (q.pulley_inertia + q.gear_ratio**2 * q.motor_inertia)[0]
    m1, m2 = q.toolhead_mass + (q.gantry_mass if direction == "y" else 0.0), 2 * J / R**2
    f = np.array([0.5, 20.0, 80.0, 100.0, 110.0, 119.0, 300.0, 2000.0])
    w = 2 * np.pi * f
    omega = np.sqrt(k * (1 / m1 + 1 / m2))
    spring = k * (1 + 1j * eta) + 1j * w * 2 * zeta * omega / (1 / m1 + 1 / m2)
    one = spring - m1 * w**2 + 1j * w * b
    two = spring - m2 * w**2 + 1j * w * 2 * b_motor / R**2
    both = one * two - spring**2
    inputs = [f"force_{direction}", "torque_1", "torque_2"]
    found = model.frf(p, f, inputs, [f"p_{direction}", "motor_1", "motor_2"]).values
    close = {"rtol": 0.0, "atol": 1e-10 * np.abs(two / both).max()}
    np.testing.assert_allclose(found[:, 0, 0], two / both, **close)
    # g_1 = (1, -1), g_2 = (-1, -1): a motor that pulls run 1 in moves the head along -g.
    signs = [-1.0, 1.0] if direction == "x" else [1.0, 1.0]
    for j, sign in enumerate(signs):
        expected = sign * spring / both / R
        close["atol"] = 1e-10 * np.abs(expected).max()
        np.testing.assert_allclose(found[:, 0, 1 + j], expected, **close)
        np.testing.assert_allclose(found[:, 1 + j, 0], expected, **close)


@pytest.mark.parametrize("zeta", [0.0, 0.02, 0.5])
def test_a_held_motor_shakes_the_tool_head_through_its_belt(zeta: float) -> None:
    """One mass on 2 k: x per angle of motor 1 is -+(R/2) of what follows the belt, -(M C_m) of x alone beside it.

    C_m takes hold of the tool head's own motion: 2 zeta omega m x'.
    """
    eta, b = 0.04, 9.0
    model, p = two_masses(
        effects__belt_loss__loss_factor=eta, effects__rail_friction__viscous=b, damping__ratio=zeta
    )
    q, runs = model.robot.parameters, np.array([0.51, 0.69])
    R, modulus = q.pulley_radius[0], q.belt_width[0] * q.belt_specific_stiffness[0]
    k, m = 2 * (modulus / runs).sum(), q.toolhead_mass
    f = np.array([0.0, 5.0, 40.0, 60.0, 70.0, 75.0, 300.0])
    w = 2 * np.pi * f
    spring = k * (1 + 1j * eta)
    dynamic = spring - m * w**2 + 1j * w * (b + 2 * zeta * np.sqrt(k / m) * m)
    found = model.frf(p, f, ["force_x", "motor_1", "motor_2"], ["p_x", "x"], drives="held")
    assert found.units == (("m/N", "m/rad", "m/rad"),) * 2
    for expected, values in zip(
        (1 / dynamic, -R / 2 * spring / dynamic, R / 2 * spring / dynamic),
        np.moveaxis(found.values, -1, 0),
        strict=True,
    ):
        for each in values.T:
            np.testing.assert_allclose(each, expected, atol=1e-12 * np.abs(expected).max(), rtol=0.0)


@pytest.mark.parametrize("mechanism", FILES)
def test_at_rest_held_motors_give_the_static_solution(mechanism: str) -> None:
    """Forces on the stiffness of all coordinates; moved motors take the platform along."""
    model, p = model_of(mechanism, DAMPED["many"][0], ratio=0.05), POSES[mechanism]
    plain = model.with_values(
        {f"effects.{path}": 0.0 for path in DAMPING if path.split(".")[0] in model.mechanism.effects}
    )
    _, K = model.matrices(p)
    inputs, outputs, B, U, L = ports(model, "held", p)
    T, S = followers(model, "held")
    for robot, loss in ((model, model.dissipation.matrices(p[None])[1][0]), (plain, 0.0 * K)):
        whole = K + 1j * loss
        y = np.linalg.solve(T.T @ whole @ T, T.T @ (B - whole @ S @ U))
        expected = L @ (T @ y + S @ U)
        found = robot.frf(p, [0.0], inputs, outputs, drives="held")
        sizes = size_of(expected[None], found.units)
        error = np.abs(found.values[0] - expected) / np.where(sizes == 0.0, 1.0, sizes)
        assert error.max() < 1e-10
    assert np.abs(found.values.imag).max() == 0.0
