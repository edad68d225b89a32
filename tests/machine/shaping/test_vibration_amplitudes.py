"""How a platform rings after a step of acceleration: against motion in time, closed forms and inverse kinematics."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

import pkmodes
from helpers.robots.one_of_each import FILES, POSES, ROBOTS, model_of
from pkmodes.cli import run
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.system.strain_free import strain_free_motions

#: Effects that change modes, those with springs to ground apart.
EFFECTS = {
    "none": {},
    "joints": {
        "payload.mass": 0.2,
        "belt_end_compliance.compliance": 2e-6,
        "gearbox_inertia.inertia": 2e-5,
        "gearbox_compliance.compliance": 2e-3,
        "link_compliance.compliance": 1e-7,
        "frame_compliance.compliance": 1e-7,
    },
    "massless": {"clamp_compliance.compliance": 1e-6, "gearbox_compliance.compliance": 2e-3},
    "stiff": {"clamp_compliance.compliance": 1e-16, "frame_compliance.compliance": 1e-20},
}
GROUNDED = {"cable_stiffness.stiffness": 3e3, "servo_stiffness.stiffness": 40.0}


def rigid_motion(model: pkmodes.Model, p: np.ndarray) -> np.ndarray:
    """All coordinates per unit of each pose component, from neighbouring poses and docs/model.md, (n, d)."""
    step = 1e-6
    ahead, behind = (model.modes(p + s * step * np.eye(len(p))).joint_positions for s in (1, -1))
    independent = (ahead - behind).T / (2.0 * step)
    q, names = model.robot.parameters, model.coordinates
    motion = np.zeros((len(names), len(p)))
    motion[[names.index(name) for name in model.mechanism.independent]] = independent
    if model.robot.mechanism_name == "linear_delta":
        for j in range(3):
            for pulley in (1, 2):
                motion[names.index(f"theta_{j + 1}_{pulley}")] = independent[j] / q.pulley_radius[j]
    elif model.robot.mechanism_name == "rotary_delta":
        for j in range(3):
            motion[names.index(f"phi_{j + 1}")] = independent[j]
    else:
        for i in range(2):
            motion[names.index(f"theta_{i + 1}")] = -q.belt_path_direction[i] / q.pulley_radius[i]
    return motion


@pytest.mark.parametrize("mechanism", FILES)
def test_the_motion_without_strain_has_the_same_digits_from_either_model(
    mechanism: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The elastic Hessian of the model without effects is a shorter way to K, which not every mechanism has."""
    model = model_of(mechanism, GROUNDED)
    points = POSES[mechanism] + 1e-3 * np.random.default_rng(5).normal(size=(50, len(POSES[mechanism])))
    motions = strain_free_motions(model.system, points)
    monkeypatch.setattr(Generated, "has", lambda self, *names: False)
    np.testing.assert_array_equal(strain_free_motions(model.system, points), motions)


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("mechanism", FILES)
def test_the_motion_without_strain_is_that_of_the_inverse_kinematics(mechanism: str, effects: str) -> None:
    p = POSES[mechanism]
    for more in ({}, GROUNDED):
        model = model_of(mechanism, EFFECTS[effects] | more)
        (found,) = strain_free_motions(model.system, p[None])
        wanted = rigid_motion(model, p)
        np.testing.assert_allclose(found, wanted, rtol=1e-7, atol=1e-8 * np.abs(wanted).max())
    weightless = model_of(mechanism, EFFECTS[effects]).with_values({"gravity": [0.0, 0.0, 0.0]})
    K = weightless.matrices(p)[1]
    assert (np.abs(K @ found) <= 1e-11 * (np.abs(K) @ np.abs(found)) + 1e-30).all()


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("mechanism", FILES)
def test_the_amplitudes_are_those_of_the_definition(mechanism: str, effects: str) -> None:
    for more in ({}, GROUNDED):
        model, p = model_of(mechanism, EFFECTS[effects] | more), POSES[mechanism]
        modes = model.modes(p, drives="held")
        moved = np.linalg.norm(modes.platform_shapes, axis=1)
        momentum = modes.shapes @ modes.mass_matrix @ rigid_motion(model, p)
        wanted = moved[:, None] * np.abs(momentum) / (2.0 * np.pi * modes.frequencies[:, None]) ** 2
        assert modes.vibration_amplitudes.shape == wanted.shape
        np.testing.assert_allclose(
            modes.vibration_amplitudes, wanted, rtol=1e-6, atol=1e-8 * wanted.max(), err_msg=mechanism
        )


@pytest.mark.parametrize("effects", ["none", "joints"])
@pytest.mark.parametrize("mechanism", FILES)
def test_the_platform_rings_so_after_its_motors_follow_a_step(mechanism: str, effects: str) -> None:
    """Motion in time of a machine without weight: motors follow t^2/2, the platform lags and rings."""
    p = POSES[mechanism]
    model = model_of(mechanism, EFFECTS[effects]).with_values({"gravity": [0.0, 0.0, 0.0]})
    names, modes = model.coordinates, model.modes(p, drives="held")
    M, K = model.matrices(p)
    rigid = rigid_motion(model, p)
    # The angle of a motor is that of its rotor, plus the wind-up of its gearbox.
    if mechanism == "linear_delta":
        pulleys = [int(np.argmax(drive)) + 1 for drive in model.robot.parameters.drive]
        rotors = [names.index(f"theta_{j}_{pulley}") for j, pulley in enumerate(pulleys, 1)]
    else:
        letter = "phi" if mechanism == "rotary_delta" else "theta"
        rotors = [names.index(f"{letter}_{j}") for j in range(1, len(p) + 1)]
    T, S = np.eye(len(names)), np.eye(len(names))[:, rotors]
    for j, rotor in enumerate(rotors, 1):
        if f"psi_{j}" in names:
            T[rotor, names.index(f"psi_{j}")] = -1.0
    T = np.delete(T, rotors, axis=1)
    platform = model.system.platform_motion(p[None])[0]
    mass, stiffness = T.T @ M @ T, T.T @ K @ T
    heavy = np.diag(mass) > 0.0
    assert heavy.sum() == len(modes.frequencies)
    light = ~heavy
    for d in range(len(p)):
        angles = rigid[rotors, d]
        by_acceleration, by_angle = T.T @ M @ S @ angles, T.T @ K @ S @ angles

        def whole(y: np.ndarray, t: float, by_angle: np.ndarray = by_angle) -> np.ndarray:
            """All that is left, with what has no inertia in equilibrium."""
            r = np.zeros(len(mass))
            r[heavy] = y
            if light.any():
                force = -by_angle[light] * t**2 / 2.0 - stiffness[np.ix_(light, heavy)] @ y
                r[light] = np.linalg.solve(stiffness[np.ix_(light, light)], force)
            return r

        def rate(
            t: float, state: np.ndarray, push: np.ndarray = by_acceleration, by_angle: np.ndarray = by_angle
        ) -> np.ndarray:
            y, velocity = np.split(state, 2)
            force = -push - by_angle * t**2 / 2.0 - stiffness @ whole(y, t)
            return np.concatenate([velocity, np.linalg.solve(mass[np.ix_(heavy, heavy)], force[heavy])])

        times = np.linspace(0.0, 0.1, 1200)
        start = np.zeros(2 * int(heavy.sum()))
        motion = solve_ivp(rate, (0.0, times[-1]), start, "DOP853", times, rtol=1e-10, atol=1e-14)
        left = np.array([T @ whole(y, t) for y, t in zip(motion.y[: heavy.sum()].T, times, strict=True)])
        q = left + np.outer(times**2 / 2.0, S @ angles)
        deviation = q @ platform.T - np.outer(times**2 / 2.0, np.eye(len(p))[d])
        phases = np.outer(times, 2.0 * np.pi * modes.frequencies)
        parts = np.hstack([np.ones((len(times), 1)), np.cos(phases), np.sin(phases)])
        fit, _, rank, _ = np.linalg.lstsq(parts, deviation, rcond=None)
        assert rank == parts.shape[1]
        cosines = np.linalg.norm(fit[1 : 1 + len(modes.frequencies)], axis=1)
        wanted = modes.vibration_amplitudes[:, d]
        np.testing.assert_allclose(parts @ fit, deviation, atol=1e-5 * wanted.max())
        np.testing.assert_allclose(cosines, wanted, rtol=1e-4, atol=1e-5 * wanted.max())


def test_a_corexy_with_equal_belts_lags_by_its_mass_over_its_stiffness() -> None:
    """By hand: with k of each run and g = (1, -1), (-1, -1), K = 4 k along x and y, which do not couple."""
    length = {f"belt_path.{i}.lengths.{r}": 0.75 for i in (1, 2) for r in (1, 2)}
    model = pkmodes.load(ROBOTS / "corexy-printer.toml").with_values(length)
    modes = model.modes([0.0, 0.0], drives="held")
    k = 6e-3 * 2.6e6 / 0.75
    np.testing.assert_allclose(
        modes.vibration_amplitudes, [[0.0, 1.2 / (4.0 * k)], [0.5 / (4.0 * k), 0.0]], rtol=1e-12, atol=1e-19
    )


def test_a_corexy_is_two_masses_on_the_springs_of_its_belts() -> None:
    model, (x, y) = pkmodes.load(ROBOTS / "corexy-printer.toml"), (0.1, 0.05)
    runs = [[0.45 + x - y, 0.75 - x + y], [0.75 - x - y, 0.75 + x + y]]
    directions = np.array([[1.0, -1.0], [-1.0, -1.0]])
    K = sum(
        6e-3 * 2.6e6 * (1.0 / first + 1.0 / second) * np.outer(g, g)
        for (first, second), g in zip(runs, directions, strict=True)
    )
    M = np.diag([0.5, 1.2])
    eigenvalues, phi = eigh(K, M)
    wanted = np.linalg.norm(phi.T, axis=1)[:, None] * np.abs(phi.T @ M) / eigenvalues[:, None]
    found = model.modes([x, y], drives="held").vibration_amplitudes
    np.testing.assert_allclose(found, wanted, rtol=1e-10)


@pytest.mark.parametrize("backend", ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)])
@pytest.mark.parametrize("mechanism", FILES)
def test_a_batch_has_the_amplitudes_of_its_poses(mechanism: str, backend: str) -> None:
    model, p = model_of(mechanism, EFFECTS["joints"]), POSES[mechanism]
    poses = np.array([p, p + 0.01, p + 9.0, p - 0.02])
    batch = model.modes(poses, "nan", drives="held", fields=["vibration_amplitudes"], backend=backend)
    amplitudes = batch.vibration_amplitudes
    assert np.isnan(amplitudes[2]).all()
    for i in (0, 1, 3):
        single = model.modes(poses[i], drives="held", backend="numpy").vibration_amplitudes
        np.testing.assert_allclose(amplitudes[i], single, rtol=1e-7, atol=1e-9 * single.max())


def test_free_motors_ring_nothing(tmp_path: Path) -> None:
    model, p = model_of("linear_delta", {}), POSES["linear_delta"]
    free = model.modes([p, p + 0.01])
    assert free.vibration_amplitudes.shape == (2, 9, 3)
    assert np.isnan(free.vibration_amplitudes).all()
    pose, out = ",".join(map(str, p)), tmp_path / "modes.json"
    robot = str(ROBOTS / FILES["linear_delta"])
    assert run(["modes", robot, "--pose", pose, "--json", str(out)]) == 0
    assert json.loads(out.read_text(encoding="utf-8"))["vibration_amplitudes"] is None
    assert run(["modes", robot, "--pose", pose, "--drives", "held", "--json", str(out)]) == 0
    amplitudes = json.loads(out.read_text(encoding="utf-8"))["vibration_amplitudes"]
    assert amplitudes == model.modes(p, drives="held").vibration_amplitudes.tolist()
    assert np.shape(amplitudes) == (6, 3)
