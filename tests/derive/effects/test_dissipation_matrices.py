"""Belt and reducer losses, rail and drive friction: C_v and K'' against oracles written here.

The oracles are the definitions, span by span and rail by rail; differences of the stiffness matrix; and inverse
kinematics from a drawing.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pkmodes
from helpers.references.damping_by_hand import arms, friction_by_hand, loss_by_hand, quadratic
from helpers.references.motors_by_hand import followers, motor_angles
from helpers.robots.damped_robots import CASES, DRIVES, EFFECTS, FRICTION, LOSSES
from helpers.robots.one_of_each import FILES, POSES, model_of


def matrices(model: pkmodes.Model, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """C_v and K'' at one pose."""
    viscous, loss = model.dissipation.matrices(np.atleast_2d(p))
    return viscous[0], loss[0]


def rates_of_arms(model: pkmodes.Model, p: np.ndarray) -> np.ndarray:
    """Their rates per velocity of the platform, by differences of the fourth order."""
    h = 1e-3 * np.eye(len(p))
    return np.stack(
        [
            (8 * (arms(model, p + d) - arms(model, p - d)) - arms(model, p + 2 * d) + arms(model, p - 2 * d))
            / 12e-3
            for d in h
        ],
        axis=1,
    )


@pytest.mark.parametrize(("mechanism", "case"), CASES)
def test_both_matrices_are_those_of_the_definition(mechanism: str, case: str) -> None:
    model, p = model_of(mechanism, EFFECTS[case], LOSSES, FRICTION), POSES[mechanism]
    viscous, loss = matrices(model, p)
    expected = loss_by_hand(model, p)
    assert np.abs(expected).max() > 0.0
    np.testing.assert_allclose(loss, expected, rtol=1e-12, atol=1e-13 * np.abs(expected).max())
    np.testing.assert_allclose(viscous, friction_by_hand(model), rtol=1e-14)


@pytest.mark.parametrize("mechanism", FILES)
def test_a_batch_of_poses_has_the_matrices_of_each(mechanism: str) -> None:
    model, p = model_of(mechanism, EFFECTS["everything"], LOSSES, FRICTION), POSES[mechanism]
    poses = np.stack([p, p + 0.01, p - 0.02])
    viscous, loss = model.dissipation.matrices(poses)
    n = len(model.coordinates)
    assert viscous.shape == loss.shape == (3, n, n)
    for i, at in enumerate(poses):
        np.testing.assert_allclose(loss[i], loss_by_hand(model, at), rtol=1e-12, atol=1e-7)
        np.testing.assert_allclose(viscous[i], friction_by_hand(model), rtol=1e-14)
    again = model.dissipation.matrices(poses)
    np.testing.assert_array_equal(again, (viscous, loss))


@pytest.mark.parametrize("case", ["plain", "uneven", "tension", "gearbox", "massless"])
@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_belt_loss_is_a_part_of_the_stiffness_of_belts(mechanism: str, case: str) -> None:
    """K is linear in the stiffness of belts without anything in series: gravity and other springs drop out."""
    springs = {"cable_stiffness.stiffness": 3e3, "servo_stiffness.stiffness": 40.0}
    model, p = model_of(mechanism, EFFECTS[case], springs, {"belt_loss.loss_factor": 0.03}), POSES[mechanism]
    twice = model.with_values(
        {"belt.specific_stiffness": 2 * model.robot.parameters.belt_specific_stiffness[0]}
    )
    difference = twice.matrices(p)[1] - model.matrices(p)[1]
    loss = matrices(model, p)[1]
    np.testing.assert_allclose(loss, 0.03 * difference, atol=1e-13 * np.abs(difference).max())


@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_belt_loss_beside_a_compliance_in_series_is_a_rate_of_the_stiffness(mechanism: str) -> None:
    """Eta dK/d ln k_sp, by extrapolated differences: the compliance in series is lossless."""
    model = model_of(mechanism, EFFECTS["everything"], {"belt_loss.loss_factor": 0.03})
    p, k = POSES[mechanism], model.robot.parameters.belt_specific_stiffness[0]

    def rate(h: float) -> np.ndarray:
        up, down = (
            model.with_values({"belt.specific_stiffness": k * np.exp(step)}).matrices(p)[1]
            for step in (h, -h)
        )
        return (up - down) / (2 * h)

    coarse, middle, fine = (rate(h) for h in (0.08, 0.04, 0.02))
    better, best = (4 * middle - coarse) / 3, (4 * fine - middle) / 3
    expected = 0.03 * (16 * best - better) / 15
    np.testing.assert_allclose(matrices(model, p)[1], expected, atol=1e-9 * np.abs(expected).max())


@pytest.mark.parametrize(
    ("mechanism", "path"),
    [
        ("rotary_delta", "reducer.stiffness"),
        ("linear_delta", "effects.gearbox_compliance.compliance"),
        ("corexy", "effects.gearbox_compliance.compliance"),
    ],
)
def test_reducer_loss_is_a_part_of_the_stiffness_of_reducers(mechanism: str, path: str) -> None:
    effects = EFFECTS["gearbox"] | EFFECTS["uneven"] | {"frame_compliance.compliance": 1e-7}
    model, p = model_of(mechanism, effects, {"reducer_loss.loss_factor": 0.05}), POSES[mechanism]
    stiffer = {path: 8e3} if mechanism == "rotary_delta" else {path: 1e-3}
    difference = model.with_values(stiffer).matrices(p)[1] - model.matrices(p)[1]
    assert np.abs(difference).max() > 0.0
    np.testing.assert_allclose(
        matrices(model, p)[1], 0.05 * difference, atol=1e-13 * np.abs(model.matrices(p)[1]).max()
    )


def test_reducer_loss_of_a_single_gearbox_that_winds_up() -> None:
    model, p = model_of("linear_delta", {"reducer_loss.loss_factor": 0.05}), POSES["linear_delta"]
    effects = {**model.robot.effects, "gearbox_compliance.compliance.psi_2": 4e-3}
    model = pkmodes.Model(replace(model.robot, effects=effects))
    expected = quadratic(model.coordinates, [(0.05 / 4e-3, {"psi_2": 1.0})])
    np.testing.assert_allclose(matrices(model, p)[1], expected, rtol=1e-14)


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_reducer_loss_where_nothing_gives_way_has_no_effect(mechanism: str, drives: str) -> None:
    model, p = model_of(mechanism, {"reducer_loss.loss_factor": 0.5}), POSES[mechanism]
    assert not matrices(model, p)[1].any()
    modes = model.modes(p, drives=drives)
    assert np.isnan(modes.damping_ratios[: modes.rigid_modes]).all()
    assert (modes.damping_ratios[modes.rigid_modes :] == 0.0).all()


@pytest.mark.parametrize("mechanism", FILES)
def test_the_power_of_a_rigid_motion_is_that_of_rails_and_motors(mechanism: str) -> None:
    """2 R for a velocity of the platform, with speeds of rails and motors from inverse kinematics."""
    model, p = model_of(mechanism, FRICTION), POSES[mechanism]
    q, names = model.robot.parameters, list(model.coordinates)
    speeds = rates_of_arms(model, p) @ np.linspace(0.3, -0.5, len(p))
    motion = np.zeros(len(names))
    motion[[names.index(name) for name in model.mechanism.independent]] = speeds
    if mechanism == "corexy":
        motors = -(q.belt_path_direction @ speeds) / q.pulley_radius
        motion[[names.index("theta_1"), names.index("theta_2")]] = motors
    elif mechanism == "linear_delta":
        motors = speeds / q.pulley_radius
        motion[3:6] = motion[6:9] = motors
    else:
        motors = motion[3:6] = speeds
    rails = 0.0 if mechanism == "rotary_delta" else 7.0 * speeds @ speeds
    viscous, _ = matrices(model, p)
    assert motion @ viscous @ motion == pytest.approx(rails + 2e-3 * motors @ motors, rel=1e-9)


@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_drive_friction_acts_on_the_motor_behind_the_gearbox(mechanism: str) -> None:
    """A rotor that turns with the motor at rest, theta = -psi, has no friction; the motor alone, psi, has."""
    model, p = model_of(mechanism, EFFECTS["gearbox"], {"drive_friction.viscous": 2e-3}), POSES[mechanism]
    viscous, _ = matrices(model, p)
    names = list(model.coordinates)
    for angle in motor_angles(model):
        rotor, psi = (names.index(name) for name in np.array(names)[angle != 0.0])
        motion = np.zeros(len(names))
        motion[rotor], motion[psi] = 1.0, -1.0
        assert not (viscous @ motion).any()
        assert viscous[psi, psi] == viscous[rotor, rotor] == viscous[rotor, psi] == 2e-3
    T, _ = followers(model, "held")
    assert not (T.T @ viscous @ T).any()


def test_rails_do_not_feel_the_frame_that_carries_them() -> None:
    """The speed along a rail is that relative to the frame."""
    for mechanism in ("linear_delta", "corexy"):
        model = model_of(mechanism, {"frame_compliance.compliance": 1e-7}, FRICTION)
        frame = [i for i, name in enumerate(model.coordinates) if name.startswith("u_")]
        assert len(frame) == len(model.mechanism.directions)
        assert not matrices(model, POSES[mechanism])[0][frame].any()
