"""Belt and reducer losses, rail and drive friction: matrices, ratios and poles against oracles written here.

The oracles are the definitions, span by span and rail by rail; differences of the stiffness matrix; inverse
kinematics from a drawing; and eigenvalues of all coordinates together, where `pkmodes` works in modal coordinates.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eig, eigh

import pkmodes
from helpers.robots.one_of_each import FILES, POSES, ROBOTS
from pkmodes.base.errors import PkmodesError
from pkmodes.response.poles import notes_on_damping

LOSSES = {"belt_loss.loss_factor": 0.03, "reducer_loss.loss_factor": 0.05}
FRICTION = {"rail_friction.viscous": 7.0, "drive_friction.viscous": 2e-3}
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
CASES = [
    (mechanism, name)
    for mechanism in FILES
    for name in EFFECTS
    if mechanism != "rotary_delta" or name in ("plain", "uneven", "everything")
]
DRIVES = ("free", "held")
BACKENDS = ("numpy", pytest.param("compiled", marks=pytest.mark.compiler))


def model_of(mechanism: str, *effects: Mapping[str, float], ratio: float = 0.0) -> pkmodes.Model:
    """The supplied robot with effects, without those that do not apply to its mechanism."""
    plain = pkmodes.load(ROBOTS / FILES[mechanism])
    known = plain.mechanism.effects
    values = {
        f"effects.{path}": value
        for some in effects
        for path, value in some.items()
        if path.split(".")[0] in known
        and path.split(".")[1] in {p.name for p in known[path.split(".")[0]].parameters}
    }
    return plain.with_values({**values, "damping.ratio": ratio} if ratio else values)


def matrices(model: pkmodes.Model, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """C_v and K'' at one pose."""
    viscous, loss = model.dynamics.dissipation.matrices(np.atleast_2d(p))
    return viscous[0], loss[0]


def effect(model: pkmodes.Model, path: str) -> float:
    return model.robot.effects.get(path, 0.0)


# Oracles ------------------------------------------------------------------------------------------------------


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
    names, kind, q = model.coordinates, model.robot.mechanism_name, model.robot.parameters
    rails = {"linear_delta": ("x_1", "x_2", "x_3"), "corexy": ("x", "y"), "rotary_delta": ()}[kind]
    rotors = {
        "linear_delta": lambda j: f"theta_{j}_{1 if q.drive[j - 1][0] else 2}",
        "corexy": lambda j: f"theta_{j}",
        "rotary_delta": lambda j: f"phi_{j}",
    }[kind]
    R = [(effect(model, "rail_friction.viscous"), {name: 1.0}) for name in rails]
    R += [
        (effect(model, "drive_friction.viscous"), {rotors(j): 1.0, f"psi_{j}": 1.0})
        for j in range(1, len(model.mechanism.drives) + 1)
    ]
    return quadratic(names, R)


def quadratic(names: tuple[str, ...], terms: list[tuple[float, dict[str, float]]]) -> np.ndarray:
    """Hessian of the sum of weight/2 (form)^2; locked coordinates are left out."""
    total = np.zeros((len(names), len(names)))
    for weight, form in terms:
        row = np.array([form.get(name, 0.0) for name in names])
        total += weight * np.outer(row, row)
    return total


def motor_angles(model: pkmodes.Model) -> np.ndarray:
    """The angle of each motor per unit of each coordinate, (drives, n)."""
    of_friction = model.with_values(
        {"effects.drive_friction.viscous": 1.0, "effects.rail_friction.viscous": 0.0}
        if "rail_friction" in model.mechanism.effects
        else {"effects.drive_friction.viscous": 1.0}
    )
    C = friction_by_hand(of_friction)
    heads = [i for i, name in enumerate(model.coordinates) if C[i, i] and not name.startswith("psi_")]
    return C[heads]


def kept(model: pkmodes.Model, drives: str) -> np.ndarray:
    """Every coordinate per unit of those that remain: with held motors theta = -psi."""
    n = len(model.coordinates)
    if drives == "free":
        return np.eye(n)
    angles, T = motor_angles(model), np.eye(n)
    heads = [int(np.flatnonzero(row)[0]) for row in angles]
    for head, row in zip(heads, angles, strict=True):
        T[head] -= row
    return np.delete(T, heads, axis=1)


def whole_modes(
    M: np.ndarray, K: np.ndarray, T: np.ndarray, rigid: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Omega and shapes of the vibrations in all coordinates, and all coordinates per unit of those with inertia."""
    M, K = T.T @ M @ T, T.T @ K @ T
    heavy = np.diag(M) > 1e-12 * np.median(np.diag(M))
    follow = np.zeros((len(M), heavy.sum()))
    follow[heavy] = np.eye(heavy.sum())
    if not heavy.all():
        follow[~heavy] = -np.linalg.solve(K[np.ix_(~heavy, ~heavy)], K[np.ix_(~heavy, heavy)])
    values, vectors = eigh(follow.T @ K @ follow, follow.T @ M @ follow)
    T = T @ follow
    return np.sqrt(np.abs(values[rigid:])), T @ vectors[:, rigid:], T


def companion_poles(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Roots of det(K + s C + s^2 M) from a pencil of twice the size, scaled to even sizes."""
    n, d = len(M), 1 / np.sqrt(np.diag(M))
    M, C, K = (a * np.outer(d, d) for a in (M, C, K))
    scale = np.sqrt(np.abs(np.diag(K)).max())
    one, none = np.eye(n), np.zeros((n, n))
    A = np.block([[none, one], [-K / scale**2, -C / scale]])
    return eig(A, np.block([[one, none], [none, M]]), right=False) * scale


def full_damping(model: pkmodes.Model, p: np.ndarray, drives: str) -> tuple[np.ndarray, ...]:
    """M, C, K of those coordinates that have inertia, with C_m, and with K'' as the viscous ratio of its mode."""
    M, K = model.matrices(p)
    omega, phi, T = whole_modes(M, K, kept(model, drives), model.modes(p, drives=drives).rigid_modes)
    of_loss = np.einsum("ai,ab,bi->i", phi, loss_by_hand(model, p), phi)
    rates = 2 * model.robot.damping_ratio * omega + of_loss / omega
    C = friction_by_hand(model) + M @ phi @ np.diag(rates) @ phi.T @ M
    return tuple(T.T @ a @ T for a in (M, C, K))


# Matrices -----------------------------------------------------------------------------------------------------


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
    viscous, loss = model.dynamics.dissipation.matrices(poses)
    n = len(model.coordinates)
    assert viscous.shape == loss.shape == (3, n, n)
    for i, at in enumerate(poses):
        np.testing.assert_allclose(loss[i], loss_by_hand(model, at), rtol=1e-12, atol=1e-7)
        np.testing.assert_allclose(viscous[i], friction_by_hand(model), rtol=1e-14)
    again = model.dynamics.dissipation.matrices(poses)
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
    T = kept(model, "held")
    assert not (T.T @ viscous @ T).any()


def test_rails_do_not_feel_the_frame_that_carries_them() -> None:
    """The speed along a rail is that relative to the frame."""
    for mechanism in ("linear_delta", "corexy"):
        model = model_of(mechanism, {"frame_compliance.compliance": 1e-7}, FRICTION)
        frame = [i for i, name in enumerate(model.coordinates) if name.startswith("u_")]
        assert len(frame) == len(model.mechanism.directions)
        assert not matrices(model, POSES[mechanism])[0][frame].any()


@pytest.mark.parametrize(
    "path", ["belt_loss.loss_factor", "rail_friction.viscous", "gearbox_compliance.compliance"]
)
def test_effects_of_parts_that_a_mechanism_does_not_have_are_refused(path: str) -> None:
    with pytest.raises(PkmodesError, match=path.split(".")[0]):
        pkmodes.load(ROBOTS / FILES["rotary_delta"]).with_values({f"effects.{path}": 0.01})


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("effects.belt_loss.loss_factor", 1.0),
        ("effects.belt_loss.loss_factor", -0.1),
        ("effects.reducer_loss.loss_factor", 1.5),
        ("effects.rail_friction.viscous", -1.0),
        ("effects.drive_friction.viscous", -1e-3),
        ("damping.ratio", 1.0),
        ("damping.ratio", -0.01),
    ],
)
def test_values_outside_their_bounds_are_refused(path: str, value: float) -> None:
    with pytest.raises(PkmodesError, match=r"expected .*(less than 1|greater than|at least)"):
        pkmodes.load(ROBOTS / FILES["corexy"]).with_values({path: value})


# Modes --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("case", ["plain", "everything"])
@pytest.mark.parametrize("mechanism", FILES)
def test_modes_and_matrices_are_to_the_bit_those_without_dissipation(
    mechanism: str, case: str, backend: str, drives: str
) -> None:
    p = np.stack([POSES[mechanism], POSES[mechanism] + 0.01])
    plain = model_of(mechanism, EFFECTS[case])
    damped = model_of(mechanism, EFFECTS[case], LOSSES, FRICTION, ratio=0.1)
    assert damped.coordinates == plain.coordinates
    one, other = (model.modes(p, drives=drives, backend=backend) for model in (plain, damped))
    assert one.rigid_modes == other.rigid_modes
    for field in ("frequencies", "shapes", "platform_shapes", "mass_matrix", "stiffness_matrix"):
        np.testing.assert_array_equal(getattr(one, field), getattr(other, field))
    np.testing.assert_array_equal(damped.matrices(p), plain.matrices(p))
    alone = (model.frequencies(p, drives=drives, backend=backend) for model in (plain, damped))
    np.testing.assert_array_equal(*alone)
    vibrating = other.damping_ratios[:, other.rigid_modes :]
    assert (vibrating > 0.1).all()
    assert np.isnan(other.damping_ratios[:, : other.rigid_modes]).all()


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize(("mechanism", "case"), CASES)
def test_light_ratios_are_those_of_the_complex_eigenproblem(mechanism: str, case: str, drives: str) -> None:
    """-Re(s)/|s| of (K + i K'' + s C + s^2 M) q = 0 in all coordinates, for positive imaginary parts.

    The damping is a thousandth: what is left is of second order in it.
    """
    light = {path: 1e-4 * value for path, value in (LOSSES | FRICTION).items()}
    model, p = model_of(mechanism, EFFECTS[case], light, ratio=1e-5), POSES[mechanism]
    modes = model.modes(p, drives=drives)
    M, K = model.matrices(p)
    omega, phi, T = whole_modes(M, K, kept(model, drives), modes.rigid_modes)
    C = friction_by_hand(model) + M @ phi @ np.diag(2e-5 * omega) @ phi.T @ M
    M, C, K, loss = (T.T @ a @ T for a in (M, C, K, loss_by_hand(model, p)))
    n, d = len(M), 1 / np.sqrt(np.diag(M))
    scale = omega.max()
    M, C, K, loss = (a * np.outer(d, d) for a in (M, C / scale, K / scale**2, loss / scale**2))
    one, none = np.eye(n), np.zeros((n, n))
    A = np.block([[none, one], [-K - 1j * loss, -C]])
    s = scale * eig(A, np.block([[one, none], [none, M]]), right=False)
    upper = s[s.imag > 0.5 * omega.min()]
    upper = upper[np.argsort(upper.imag)]
    ratios = modes.damping_ratios[modes.rigid_modes :]
    assert len(upper) == len(ratios)
    np.testing.assert_allclose(ratios, -upper.real / np.abs(upper), rtol=1e-4)


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


@pytest.mark.parametrize("backend", BACKENDS)
def test_ratios_of_repeated_modes_are_those_of_the_motions_that_damping_does_not_couple(backend: str) -> None:
    """Each belt alone is such a motion; x and y, an equally good basis of the undamped modes, are not."""
    model, p, expected = repeated()
    modes = model.modes(p, drives="held", backend=backend)
    assert modes.frequencies[1] / modes.frequencies[0] == pytest.approx(1.0, abs=1e-12)
    assert expected[1] > 1.01 * expected[0]
    assert modes.damping_ratios == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("backend", BACKENDS)
def test_poles_of_repeated_modes_have_the_ratios_of_these_motions(backend: str) -> None:
    """K'' enters them as the viscous ratio of its mode, which within a group is one that damping does not couple."""
    model, p, expected = repeated()
    poles = model.poles(p, drives="held", backend=backend)
    ratios = np.sort((-poles.real / np.abs(poles))[poles.imag > 0.0])
    assert ratios == pytest.approx(expected, rel=1e-9)


# Poles --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("strength", [1.0, 30.0])
@pytest.mark.parametrize(("mechanism", "case"), CASES)
def test_poles_are_those_of_the_whole_first_order_system(
    mechanism: str, case: str, strength: float, drives: str
) -> None:
    """With all coordinates at once; the stronger damping has ratios up to 60 % and poles without oscillation."""
    friction = {path: strength * value for path, value in FRICTION.items()}
    losses = {path: min(strength * value, 0.9) for path, value in LOSSES.items()}
    ratio = min(0.02 * strength, 0.6)
    model, p = model_of(mechanism, EFFECTS[case], friction, losses, ratio=ratio), POSES[mechanism]
    found = model.poles(p, drives=drives)
    expected = companion_poles(*full_damping(model, p, drives))
    assert len(found) == len(expected)
    assert_same_poles(found, expected)


def assert_same_poles(found: np.ndarray, expected: np.ndarray, tolerance: float = 1e-11) -> None:
    """Each is the nearest left of the other, to a part of its own size, or near zero of the largest."""
    left = list(expected)
    for pole in found:
        nearest = int(np.argmin(np.abs(np.array(left) - pole)))
        error = abs(left.pop(nearest) - pole)
        assert error < tolerance * abs(pole) + 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("ratio", [0.02, 0.6])
def test_poles_of_a_ratio_alone_follow_from_the_frequencies(ratio: float, backend: str) -> None:
    """s = omega (-zeta +- i sqrt(1 - zeta^2)), ascending, the one with positive imaginary part first."""
    model, p = model_of("linear_delta", {}, ratio=ratio), POSES["linear_delta"]
    omega = 2 * np.pi * model.frequencies(p, drives="held", backend=backend)
    pair = np.array([-ratio + 1j * np.sqrt(1 - ratio**2), -ratio - 1j * np.sqrt(1 - ratio**2)])
    found = model.poles(p, drives="held", backend=backend)
    np.testing.assert_allclose(found, np.outer(omega, pair).ravel(), rtol=1e-11)


@pytest.mark.parametrize("mechanism", ["corexy"])
def test_rigid_modes_have_poles_of_friction_alone(mechanism: str) -> None:
    """A level CoreXY of equal belts: along x and y it creeps to a stop, 0 and -C/M of the rigid motion."""
    model = model_of(
        mechanism, {}, {"rail_friction.viscous": 7.0, "drive_friction.viscous": 1e-4}, ratio=0.05
    )
    model = model.with_values({"belt.specific_stiffness": 2.6e12})
    q, p = model.robot.parameters, POSES[mechanism]
    R, inertia = q.pulley_radius[0], (q.pulley_inertia + q.gear_ratio**2 * q.motor_inertia)[0]
    friction = 7.0 + 2 * 1e-4 / R**2
    mass = np.array([q.toolhead_mass, q.toolhead_mass + q.gantry_mass]) + 2 * inertia / R**2
    found = model.poles(p)
    largest = np.abs(found).max()
    assert (np.abs(found[:2]) < 1e-7 * largest).all()
    np.testing.assert_allclose(np.sort(found[2:4].real), np.sort(-friction / mass), rtol=1e-4)


@pytest.mark.parametrize("compliance", [1e-16, 1e-20, 1e-30])
@pytest.mark.parametrize("joint", ["gearbox", "link", "clamp", "frame"])
def test_poles_of_stiff_joints_are_those_of_locked_ones(joint: str, compliance: float) -> None:
    """Soft motions keep nine digits, like frequencies: what the joint gives way is a part of 1e-11."""
    locked, p = model_of("linear_delta", LOSSES, FRICTION, ratio=0.01), POSES["linear_delta"]
    effects = {f"{joint}_compliance.compliance": compliance}
    stiff = model_of("linear_delta", LOSSES, FRICTION, effects, ratio=0.01)
    expected = locked.poles(p, drives="held")
    found = stiff.poles(p, drives="held")
    assert len(found) == len(expected) + (0 if joint == "clamp" else 6)
    for pole in expected:
        assert np.abs(found - pole).min() < 1e-9 * abs(pole)


def test_poles_of_poses_that_cannot_be_evaluated() -> None:
    model = model_of("corexy", FRICTION, ratio=0.01)
    poles = model.poles([[0.1, 0.05], [9.0, 0.0]], "nan")
    assert poles.shape == (2, 8)
    np.testing.assert_array_equal(poles[0], model.poles([0.1, 0.05]))
    assert np.isnan(poles[1]).all()
    with pytest.raises(pkmodes.PoseError):
        model.poles([9.0, 0.0])
    with pytest.raises(PkmodesError, match='"free" or "held"'):
        model.poles([0.1, 0.05], drives="locked")


def test_modes_whose_ratio_is_not_that_of_their_pole_are_named() -> None:
    """Beyond critical damping the pole of a body alone has the ratio 1; below, both ratios are the same."""
    model, p, _ = repeated()
    model = model.with_values({"effects.belt_loss.loss_factor": 0.0})
    omega, mass = 2 * np.pi * model.frequencies(p, drives="held"), model.robot.parameters.toolhead_mass
    for ratio in (0.5, 1.5):
        damped = model.with_values({"effects.rail_friction.viscous": 2 * ratio * mass * omega[0]})
        ratios = damped.modes(p, drives="held").damping_ratios
        assert ratios == pytest.approx([ratio, ratio], rel=1e-9)
        notes = notes_on_damping(damped.dynamics, p, ratios, "held")
        assert [note.split(":")[0] for note in notes] == (["mode 1", "mode 2"] if ratio > 1.0 else [])
        assert all("1.5" in note and "that of the pole is 1:" in note for note in notes)
