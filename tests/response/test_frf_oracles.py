"""Frequency responses against linear systems of all coordinates in 40 digits, closed forms, and motion in time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import pkmodes
from helpers.references.high_precision import mp as digits
from helpers.references.high_precision import solved
from helpers.robots.one_of_each import FILES, POSES, ROBOTS
from pkmodes.base.errors import PkmodesError

mp = digits.clone()
mp.dps = 40
LOSSES = {"belt_loss.loss_factor": 0.03, "reducer_loss.loss_factor": 0.05}
FRICTION = {"rail_friction.viscous": 7.0, "drive_friction.viscous": 2e-3}
DAMPING = LOSSES | FRICTION
#: Every one with all kinds of damping, and the ratio.
CASES: dict[str, tuple[Mapping[str, float], float]] = {
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


def model_of(mechanism: str, effects: Mapping[str, float], ratio: float = 0.0) -> pkmodes.Model:
    """The supplied robot with effects, without those that do not apply to its mechanism."""
    plain = pkmodes.load(ROBOTS / FILES[mechanism])
    known = plain.mechanism.effects
    values = {f"effects.{path}": value for path, value in effects.items() if path.split(".")[0] in known}
    return plain.with_values({**values, "damping.ratio": ratio} if ratio else values)


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


class Oracle:
    """The equations of docs/response.md at one pose, in 40 digits: modes, damping of a ratio, and responses."""

    def __init__(self, model: pkmodes.Model, p: np.ndarray, drives: str) -> None:
        self.model = model
        M, K = model.matrices(p)
        viscous, loss = (matrix[0] for matrix in model.dynamics.dissipation.matrices(p[None]))
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
    platform = model.dynamics.system.platform_motion(p[None])[0]
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


# Against all coordinates in 40 digits -------------------------------------------------------------------------


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("mechanism", FILES)
def test_every_channel_is_that_of_a_direct_solution(mechanism: str, case: str, drives: str) -> None:
    effects, ratio = CASES[case]
    assert_exact(model_of(mechanism, effects, ratio), POSES[mechanism], drives)


@pytest.mark.parametrize("ratio", [1.0 - 1e-3, 1.0, 1.0 + 1e-12, 1.0 + 1e-9, 1.0 + 1e-5])
def test_near_critical_damping_of_coupled_motions(ratio: float) -> None:
    """Where two poles begin to be real they are equal, and their vectors, too: no residues exist."""
    model, p = model_of("corexy", {}), POSES["corexy"]
    M, K = (matrix[:2, :2] for matrix in model.matrices(p))  # motors held: x and y
    none, one = np.zeros((2, 2)), np.eye(2)
    below, above = 600.0, 800.0  # with and without oscillation
    for _ in range(80):
        middle = (below + above) / 2
        poles = np.linalg.eigvals(
            np.block([[none, one], [-np.linalg.solve(M, K), -middle * np.linalg.inv(M)]])
        )
        below, above = (middle, above) if poles.imag.any() else (below, middle)
    assert 650.0 < below < 750.0
    damped = model_of("corexy", {"rail_friction.viscous": below * ratio})
    assert_exact(damped, p, "held", np.array([0.0, 1.0, 40.0, 100.0, 1000.0]))


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("compliance", [1e-6, 1e-9, 1e-12, 1e-20, 1e-30])
@pytest.mark.parametrize("joint", ["gearbox", "link", "clamp", "frame"])
def test_stiff_joints_take_no_digits_from_soft_motions(joint: str, compliance: float, drives: str) -> None:
    """A direct solution in double precision has errors below 1e-12 with free motors.

    With held ones a wind-up of less than 1e-15 rad/(N m) costs it digits, but not modal coordinates.
    """
    effects = {**DAMPING, f"{joint}_compliance.compliance": compliance}
    model, p = model_of("linear_delta", effects, 0.01), POSES["linear_delta"]
    first = 1 if drives == "held" else 4
    soft = np.abs(model.frequencies(p, drives=drives)[first - 1 : first + 2])
    assert_exact(model, p, drives, np.array([5.0, *soft, 300.0]))


@pytest.mark.parametrize(
    "values",
    [
        {"motor.inertia": 3.0, "motor.gear_ratio": 7.0},
        {"effects.servo_stiffness.stiffness": 1e10},
        {"effects.drive_friction.viscous": 1e2},
    ],
)
@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_what_acts_on_a_held_motor_has_no_influence(mechanism: str, values: Mapping[str, float]) -> None:
    """With a gearbox that winds up, too: inertia, servo and friction of the motor are behind it."""
    effects = {**DAMPING, "gearbox_compliance.compliance": 2e-3}
    model, p = model_of(mechanism, effects, 0.01), POSES[mechanism]
    inputs, outputs, *_ = ports(model, "held", p)
    at = frequencies_of(model, p, "held")
    plain = model.frf(p, at, inputs, outputs, drives="held")
    other = model.with_values(values).frf(p, at, inputs, outputs, drives="held")
    sizes = size_of(plain.values, plain.units)
    error = np.abs(other.values - plain.values) / np.where(sizes == 0.0, 1.0, sizes)
    assert error.max() < 1e-10


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("mechanism", FILES)
def test_a_batch_has_the_responses_of_its_poses_with_both_back_ends(mechanism: str, drives: str) -> None:
    effects, ratio = CASES["many"]
    model, p = model_of(mechanism, effects, ratio), POSES[mechanism]
    poses = np.stack([[p, p + 0.01], [p - 0.02, p + 9.0]])
    inputs, outputs, *_ = ports(model, drives, p)
    at = frequencies_of(model, p, drives)
    found = [
        model.frf(poses, at, inputs, outputs, drives=drives, on_error="nan", backend=backend).values
        for backend in ("numpy", "auto")
    ]
    alone = model.frf(poses[0, 1], at, inputs, outputs, drives=drives)
    sizes = size_of(alone.values, alone.units)
    scale = np.where(sizes == 0.0, 1.0, sizes)
    for values in found:
        assert values.shape == (2, 2, len(at), len(outputs), len(inputs))
        assert values.dtype == np.complex128
        assert np.abs((values[0, 1] - alone.values) / scale).max() < 1e-10
        assert np.isfinite(values[1, 0]).all()
    assert np.abs((found[0] - found[1])[0] / scale).max() < 1e-10


def test_a_pose_that_cannot_be_evaluated_is_nan_in_both_parts() -> None:
    """Its imaginary part is no response of 0 either."""
    found = model_of("corexy", {}, 0.02).frf(
        [[0.1, 0.05], [9, 9]], [10.0], ["force_x"], ["p_x"], on_error="nan"
    )
    assert found.valid.tolist() == [True, False]
    assert np.isnan(found.values[1].real).all()
    assert np.isnan(found.values[1].imag).all()


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("mechanism", FILES)
def test_forces_and_displacements_may_be_exchanged(mechanism: str, case: str, drives: str) -> None:
    """Motion a per force b is motion b per force a, of platform and free motors, to 1e-12 of the largest."""
    effects, ratio = CASES[case]
    model, p = model_of(mechanism, effects, ratio), POSES[mechanism]
    directions = model.mechanism.directions
    inputs, outputs = [f"force_{d}" for d in directions], [f"p_{d}" for d in directions]
    if drives == "free":
        for drive in model.mechanism.drives:
            inputs.append(f"torque_{drive.name}")
            outputs.append(f"motor_{drive.name}")
    H = model.frf(p, frequencies_of(model, p, drives), inputs, outputs, drives=drives).values
    own = np.sqrt(np.abs(np.einsum("fii->fi", H)))
    size = (own[:, :, None] * own[:, None, :]).max(axis=0)
    assert (np.abs(H - np.swapaxes(H, 1, 2)).max(axis=0) / size).max() < 1e-12


# Closed forms -------------------------------------------------------------------------------------------------


def two_masses(**values: float) -> tuple[pkmodes.Model, np.ndarray]:
    """A CoreXY whose belts are alike at a pose, where motions along x and y are apart."""
    model = pkmodes.load(ROBOTS / FILES["corexy"])
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
    model, p = model_of(mechanism, CASES["many"][0], 0.05), POSES[mechanism]
    plain = model.with_values(
        {f"effects.{path}": 0.0 for path in DAMPING if path.split(".")[0] in model.mechanism.effects}
    )
    _, K = model.matrices(p)
    inputs, outputs, B, U, L = ports(model, "held", p)
    T, S = followers(model, "held")
    for robot, loss in ((model, model.dynamics.dissipation.matrices(p[None])[1][0]), (plain, 0.0 * K)):
        whole = K + 1j * loss
        y = np.linalg.solve(T.T @ whole @ T, T.T @ (B - whole @ S @ U))
        expected = L @ (T @ y + S @ U)
        found = robot.frf(p, [0.0], inputs, outputs, drives="held")
        sizes = size_of(expected[None], found.units)
        error = np.abs(found.values[0] - expected) / np.where(sizes == 0.0, 1.0, sizes)
        assert error.max() < 1e-10
    assert np.abs(found.values.imag).max() == 0.0


@pytest.mark.parametrize("drives", DRIVES)
def test_velocities_and_accelerations_are_derivatives_of_displacements(drives: str) -> None:
    model, p = model_of("linear_delta", *CASES["gearbox"]), POSES["linear_delta"]
    f = np.array([3.0, 27.0, 200.0])
    inputs, outputs, *_ = ports(model, drives, p)
    x, v, a = (
        model.frf(p, f, inputs, outputs, drives=drives, quantity=quantity)
        for quantity in ("displacement", "velocity", "acceleration")
    )
    s = 2j * np.pi * f[:, None, None]
    np.testing.assert_allclose(v.values, s * x.values, rtol=1e-14)
    np.testing.assert_allclose(a.values, s**2 * x.values, rtol=1e-14)
    assert (x.units[0][0], v.units[0][0], a.units[0][0]) == ("m/N", "m/s/N", "m/s^2/N")
    assert a.quantity == "acceleration"
    assert a.drives == drives


def test_a_direction_is_the_projection_of_the_platform() -> None:
    """Normalised, and absolute: with the frame that moves, which the coordinates are relative to."""
    model, p = model_of("corexy", {"frame_compliance.compliance": 1e-5}, 0.02), POSES["corexy"]
    outputs = ["p_x", "p_y", {"oblique": [3.0, 4.0]}, "x", "y", "u_x", "u_y"]
    values = model.frf(p, [5.0, 20.0, 90.0], ["force_x", "force_y"], outputs, drives="held").values
    p_x, p_y, oblique, x, y, u_x, u_y = np.moveaxis(values, 1, 0)
    np.testing.assert_allclose(oblique, 0.6 * p_x + 0.8 * p_y, rtol=1e-12, atol=1e-20)
    np.testing.assert_allclose(p_x, x + u_x, rtol=1e-10, atol=1e-12 * np.abs(p_x).max())
    np.testing.assert_allclose(p_y, y + u_y, rtol=1e-10, atol=1e-12 * np.abs(p_y).max())


# In time ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("driven", ["force", "motor", "torque"])
@pytest.mark.parametrize("mechanism", FILES)
def test_a_sine_in_time_has_the_amplitude_and_the_phase_of_the_response(mechanism: str, driven: str) -> None:
    """M q'' + C q' + K q = B u from rest, until the transient is below the tolerance, 0.1 %.

    With a prescribed angle u, damping and inertia act on the whole motion.  Losses, which no equation in time has,
    are left out; with free motors, a servo holds the machine in its place.
    """
    friction = {"rail_friction.viscous": 25.0, "drive_friction.viscous": 5e-3}
    servo = {"servo_stiffness.stiffness": 30.0} if driven == "torque" else {}
    drives = "held" if driven != "torque" else "free"
    model, p = model_of(mechanism, {**friction, **servo}, 0.08), POSES[mechanism]
    M, K = model.matrices(p)
    C, none = (matrix[0] for matrix in model.dynamics.dissipation.matrices(p[None]))
    assert not none.any()
    T, S = followers(model, drives)
    modes = model.modes(p, drives=drives)
    momenta = M @ modes.shapes.T
    C = C + momenta @ np.diag(2 * 0.08 * 2 * np.pi * modes.frequencies) @ momenta.T
    name = {"force": f"force_{model.mechanism.directions[0]}", "motor": "motor_2", "torque": "torque_2"}[
        driven
    ]
    inputs, outputs, B, U, L = ports(model, drives, p)
    b, u = B[:, inputs.index(name)], S @ U[:, inputs.index(name)]
    f = 1.05 * modes.frequencies[0]
    w = 2 * np.pi * f
    m = len(T.T)
    inverse = np.linalg.inv(T.T @ M @ T)
    back, resist = -inverse @ T.T @ K @ T, -inverse @ T.T @ C @ T
    of_sine, of_cosine = inverse @ T.T @ (b - K @ u + w**2 * M @ u), -inverse @ T.T @ (w * C @ u)

    def rates(t: float, state: np.ndarray) -> np.ndarray:
        y, v = state[:m], state[m:]
        push = of_sine * np.sin(w * t) + of_cosine * np.cos(w * t)
        return np.concatenate([v, back @ y + resist @ v + push])

    decay = -np.linalg.eigvals(np.block([[np.zeros((m, m)), np.eye(m)], [back, resist]])).real.max()
    start = np.ceil(10.0 / decay * f) / f
    times = start + np.arange(16) / 16 / f
    found = solve_ivp(
        rates,
        (0.0, times[-1]),
        np.zeros(2 * m),
        "DOP853",
        times,
        rtol=1e-10,
        atol=1e-10 * np.abs(u).max() + 1e-14,
    )
    assert found.success
    motion = L @ (T @ found.y[:m] + np.outer(u, np.sin(w * times)))
    phasors = 2j / 16 * (motion @ np.exp(-1j * w * times))  # of q = Im(H exp(i w t))
    H = model.frf(p, [f], [name], outputs, drives=drives)
    sizes = size_of(H.values, H.units)[:, 0]
    platform = len(model.mechanism.directions)
    for true, response, size in zip(phasors, H.values[0, :, 0], sizes, strict=True):
        assert abs(response - true) <= 1e-3 * size
    first = int(np.abs(phasors[:platform]).argmax())
    ratio = H.values[0, first, 0] / phasors[first]
    assert abs(abs(ratio) - 1.0) < 1e-3
    assert abs(np.angle(ratio)) < 1e-3


# Refusals -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("mechanism", FILES)
def test_0_hz_is_refused_where_the_machine_moves_without_end(mechanism: str) -> None:
    model, p = model_of(mechanism, {}, 0.02), POSES[mechanism]
    with pytest.raises(PkmodesError, match=r'0 Hz.*motors free.*rigid modes.*drives="held"'):
        model.frf(p, [10.0, 0.0], ["force_x"], ["p_x"])
    assert np.isfinite(model.frf(p, [10.0, 0.0], ["force_x"], ["p_x"], drives="held").values).all()
    servo = model.with_values({"effects.servo_stiffness.stiffness": 50.0})
    assert np.isfinite(servo.frf(p, [0.0], ["force_x", "torque_1"], ["p_x"]).values).all()


@pytest.mark.parametrize(
    "frequencies", [-1.0, [10.0, -2.0], [np.nan], [10.0, np.inf], [], None, "fast", [[1.0, 2.0]], [1j], {}]
)
def test_frequencies_that_are_none_are_refused(frequencies: Any) -> None:
    with pytest.raises(PkmodesError, match=r"expected (a list of )?frequencies.*\(frequencies\)"):
        model_of("corexy", {}, 0.02).frf(POSES["corexy"], frequencies, ["force_x"], ["p_x"], drives="held")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"inputs": ["forcex"]}, r'unknown name "forcex" \(inputs\); did you mean "force_x"'),
        ({"inputs": ["torque_3"]}, r'unknown name "torque_3" \(inputs\); did you mean "torque_'),
        ({"inputs": ["p_x"]}, r'unknown name "p_x" \(inputs\)'),
        ({"inputs": [3]}, r"unknown name 3 \(inputs\); known: torque_1"),
        ({"inputs": []}, "at least one of the inputs"),
        ({"inputs": ["force_x", "force_x"]}, '"force_x" is given twice'),
        (
            {"inputs": ["motor_1"]},
            r'prescribed angle, but the motors are free .*use torque_1, or drives="held"',
        ),
        (
            {"inputs": ["torque_1"], "drives": "held"},
            r'torque of a motor, but the motors are held .*use motor_1, or drives="free"',
        ),
        ({"outputs": ["p_z"]}, r'unknown name "p_z" \(outputs\); did you mean "p_[xy]"'),
        ({"outputs": ["psi_1"]}, r'unknown name "psi_1" \(outputs\)'),
        ({"outputs": ["force_x"]}, r'unknown name "force_x" \(outputs\)'),
        ({"outputs": []}, "at least one of the outputs"),
        ({"outputs": [{}]}, "at least one of the outputs"),
        ({"outputs": ["p_x", "p_x"]}, '"p_x" is given twice'),
        ({"outputs": {"oblique": [0.0, 0.0]}}, r"expected a direction along x, y.*\(outputs: oblique\)"),
        ({"outputs": {"oblique": [1.0, 0.0, 0.0]}}, "expected a direction along x, y"),
        ({"outputs": {"oblique": [np.nan, 1.0]}}, "expected a direction along x, y"),
        ({"outputs": {"oblique": "up"}}, 'expected a direction along x, y, found "up"'),
        ({"quantity": "speed"}, 'expected displacement, velocity or acceleration, found "speed"'),
        ({"quantity": None}, "expected displacement, velocity or acceleration"),
        ({"drives": "locked"}, 'expected "free" or "held", found "locked"'),
        ({"on_error": "skip"}, 'expected on_error "raise" or "nan"'),
    ],
)
def test_wrong_arguments_are_refused_with_what_to_do(arguments: Mapping[str, Any], message: str) -> None:
    given: dict[str, Any] = {"frequencies": [10.0], "inputs": ["force_x"], "outputs": ["p_x"]}
    with pytest.raises(PkmodesError, match=message):
        model_of("corexy", {}, 0.02).frf(POSES["corexy"], **(given | dict(arguments)))


@pytest.mark.parametrize("names", [None, 5, [["p_x"]]])
@pytest.mark.parametrize("argument", ["inputs", "outputs"])
def test_what_is_no_list_of_names_is_refused(argument: str, names: Any) -> None:
    given: dict[str, Any] = {"frequencies": [10.0], "inputs": ["force_x"], "outputs": ["p_x"]}
    with pytest.raises(PkmodesError, match=argument):
        model_of("corexy", {}, 0.02).frf(POSES["corexy"], **(given | {argument: names}))


@pytest.mark.parametrize("name", ["p_x", "y", "motor_1"])
def test_a_direction_does_not_take_the_name_of_another_output(name: str) -> None:
    """Otherwise a table's `p_x` would be motion along y."""
    with pytest.raises(PkmodesError, match=name):
        model_of("corexy", {}, 0.02).frf(POSES["corexy"], [10.0], ["force_x"], {name: [0.0, 1.0]})


def test_a_pose_outside_is_refused() -> None:
    with pytest.raises(pkmodes.PoseError):
        model_of("corexy", {}, 0.02).frf([9.0, 9.0], [10.0], ["force_x"], ["p_x"])
