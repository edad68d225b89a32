"""The generated model against MuJoCo, which multiplies bodies, joints and springs without derived formulas.

The engine is described in `mujoco_engine` without any formula of the generated model.  Both sides are exact
up to rounding, except where the engine's quantities are differenced, so the tolerances are those of double
precision: a relative error of a millionth in any term would be found.

The robots are the published one, a printer with three towers, and asymmetric ones on which nothing is equal,
parallel, centred or in the direction of a base axis.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

import pkmodes_generated.linear_delta as generated
from pkmodes.core.robot.reading import read_robot
from pkmodes_generated.linear_delta import Parameters
from pkmodes_rig.mujoco_engine import Engine

ROBOTS = Path(__file__).parents[2] / "robots"

#: Quantities that the engine computes without differences.  Worst case: 3e-14 of the largest entry, on the robot
#: whose platform Jacobian is largest; a few dozen roundings amplified by the condition of the constraints.
EXACT = 3e-13

#: The same for second derivatives, in which that condition number enters twice.  Worst case: 1.1e-13.
EXACT_TWICE = 1e-12


@dataclass(frozen=True)
class Case:
    """A robot at a pose."""

    parameters: Parameters
    p: np.ndarray

    @property
    def belt(self) -> np.ndarray:
        """Change of each coordinate per metre of belt, which scales M and K to kg and N/m."""
        return np.concatenate([np.ones(3), np.tile(1 / self.parameters.pulley_radius, 2)])

    def velocities(self) -> np.ndarray:
        """Random rates of the nine coordinates."""
        return np.array([1.0, -0.7, 0.4, 0.9, 0.3, -0.6, 0.2, -1.1, 0.5]) * self.belt


#: Steps of the eighth-order differences, as parts of `Engine.length_scale`.  Over all cases the error of the
#: gravitational stiffness is 1e-12 of its largest entry here and grows as the eighth power of the step above,
#: as rounding over step below; from energies, twice differenced, 5e-10 at a step twice as long.
FORCE_STEP = 0.007
ENERGY_STEP = 0.015


@cache
def published() -> Parameters:
    return read_robot(ROBOTS / "linear-delta-2022.toml").parameters


@cache
def towers() -> Parameters:
    """A printer: vertical rails on a circle, effector joints towards them, each motor at the top."""
    angles = np.radians([90.0, 210.0, 330.0])
    outward = np.stack([np.cos(angles), np.sin(angles), np.zeros(3)], axis=1)
    return published()._replace(
        platform_mass=0.3,
        origin=0.19 * outward,
        direction=np.tile([0.0, 0.0, 1.0], (3, 1)),
        joint=0.035 * outward + [0.0, 0.0, 0.01],
        link_length=np.full(3, 0.33),
        link_mass=np.full(3, 0.06),
        carriage_mass=np.full(3, 0.15),
        carriage_length=np.full(3, 0.04),
        belt_specific_stiffness=np.full(3, 1e6),
        belt_width=np.full(3, 0.006),
        pulley_radius=np.full(3, 0.0064),
        pulley_inertia=np.full(3, 4e-7),
        motor_inertia=np.full(3, 5.4e-6),
        gear_ratio=np.ones(3),
        drive=np.tile([1.0, 0.0], (3, 1)),
        limits=np.tile([0.0, 0.9], (3, 1)),
        branch=np.ones(3),
    )


@cache
def asymmetric(seed: int) -> tuple[Parameters, tuple[np.ndarray, ...]]:
    """An asymmetric robot, and well-conditioned poses that it can reach.

    The rods are drawn around a platform, then the rails through their far ends: any position, any direction,
    either branch.
    """
    rng = np.random.default_rng(seed)
    p = rng.uniform(-0.5, 0.5, 3)
    joint = rng.uniform(-0.08, 0.08, (3, 3))
    length = rng.uniform(0.25, 0.6, 3)
    while True:
        rods, direction = (_unit(rng.normal(size=(3, 3))) for _ in range(2))  # rods: from joint to carriage
        cosine = np.sum(rods * direction, axis=1)
        if np.linalg.cond(rods) < 5 and np.abs(cosine).min() > 0.35:
            break
    x = rng.uniform(-0.4, 0.4, 3)
    margin = rng.uniform(0.3, 0.6, (3, 2))  # rail beyond the carriage on either side
    driven = rng.permutation([1, 2, rng.integers(1, 3)])  # both kinds on every robot
    parameters = Parameters(
        platform_mass=rng.uniform(0.3, 3),
        gravity=9.81 * _unit(rng.normal(size=(1, 3)))[0],
        origin=p + joint + length[:, None] * rods - x[:, None] * direction,
        direction=direction,
        joint=joint,
        link_length=length,
        link_mass=rng.uniform(0.2, 1.5, 3),
        carriage_mass=rng.uniform(0.3, 2, 3),
        carriage_length=rng.uniform(0.02, 0.2, 3),
        belt_specific_stiffness=rng.uniform(0.5e6, 4e6, 3),
        belt_width=rng.uniform(0.006, 0.03, 3),
        pulley_radius=rng.uniform(0.01, 0.06, 3),
        pulley_inertia=rng.uniform(2e-5, 3e-4, 3),
        motor_inertia=rng.uniform(0.5e-5, 5e-5, 3),
        gear_ratio=rng.uniform(1, 12, 3),
        drive=np.stack([driven == 1, driven == 2], axis=1).astype(float),
        limits=np.stack([x - margin[:, 0], x + margin[:, 1]], axis=1),
        branch=np.sign(cosine),
    )
    shift = _unit(rng.normal(size=(1, 3)))[0] * 0.12 * length.min()
    return parameters, (p, p + shift)


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def _cases() -> dict[str, Callable[[], Case]]:
    def of(parameters: Callable[[], Parameters], p: tuple[float, float, float]) -> Callable[[], Case]:
        return lambda: Case(parameters(), np.array(p))

    def of_seed(seed: int, pose: int) -> Callable[[], Case]:
        return lambda: Case(asymmetric(seed)[0], asymmetric(seed)[1][pose])

    cases = {
        "published-symmetric": of(published, (0.6, 0.0, -0.245)),
        "published-generic": of(published, (0.47, 0.08, -0.245)),
        "published-edge": of(published, (0.72, -0.09, -0.25)),
        "towers-centre": of(towers, (0.0, 0.0, 0.1)),
        "towers-generic": of(towers, (0.05, -0.07, 0.16)),
    }
    for seed in range(4):
        for pose in range(2):
            cases[f"asymmetric-{seed}-{pose}"] = of_seed(seed, pose)
    return cases


CASES = _cases()


@cache
def assembled(name: str) -> tuple[Case, Engine]:
    case = CASES[name]()
    return case, Engine(case.parameters, case.p)


@pytest.fixture(params=CASES)
def case(request: pytest.FixtureRequest) -> Case:
    return assembled(request.param)[0]


@pytest.fixture
def engine(request: pytest.FixtureRequest, case: Case) -> Engine:
    """The engine at the pose of the case, at rest, belts unstrained."""
    found = assembled(request.node.callspec.params["case"])[1]
    found.move(np.zeros(9))
    return found


def assert_equal(found: np.ndarray | float, expected: np.ndarray | float, tolerance: float) -> None:
    """Check that entries differ by at most `tolerance` of the largest entry."""
    found, expected = np.asarray(found), np.asarray(expected)
    assert found.shape == expected.shape
    scale = np.abs(expected).max()
    assert np.isfinite(found).all()
    assert scale > 0
    error = np.abs(found - expected).max() / scale
    assert error <= tolerance, f"{error:.1e} of the largest entry {scale:.3g}; {tolerance:.0e} is allowed"


def steps(case: Case, engine: Engine) -> np.ndarray:
    """Steps along the nine coordinates that move the belt at each pulley as far as a carriage."""
    return FORCE_STEP * engine.length_scale() * case.belt


def test_carriages_that_the_engine_can_connect_to_the_platform(case: Case, engine: Engine) -> None:
    # Lengths of some decimetres, a few roundings each.
    assert engine.closure() < 2e-15
    assert engine.platform() == pytest.approx(case.p, rel=0, abs=1e-14)
    assert_equal(generated.inverse_kinematics(case.p, case.parameters), engine.x, 1e-14)
    assert np.linalg.cond(engine.links()) < 8  # the tolerances of this module are for such poses


def test_platform_follows_the_carriages_as_in_the_engine(case: Case, engine: Engine) -> None:
    assembly = np.sign(generated.jacobian_condition(case.p, case.parameters)[0])
    for displacement in ([0.02, -0.015, 0.01], [-0.03, -0.02, -0.025]):
        engine.move(np.concatenate([displacement, np.zeros(6)]))
        p = generated.direct_kinematics(engine.x + displacement, assembly, case.parameters)
        assert_equal(p, engine.platform(), 1e-13)  # worst: 3e-15


def test_velocities_of_platform_and_links(case: Case, engine: Engine) -> None:
    D_d, D_omega = engine.link_jacobians()
    found_d, found_omega = generated.link_jacobians(case.p, case.parameters)
    assert_equal(generated.platform_jacobian(case.p, case.parameters), engine.platform_jacobian(), EXACT)
    assert_equal(found_d, D_d, EXACT)
    assert_equal(found_omega, D_omega, EXACT)


def test_constraints_on_the_velocities(case: Case, engine: Engine) -> None:
    D_l, D_r = generated.constraint_jacobians(case.p, case.parameters)
    determinant, condition = generated.jacobian_condition(case.p, case.parameters)
    links = engine.links()
    assert_equal(D_l, links, EXACT)
    assert_equal(D_r, links @ engine.platform_jacobian(), EXACT)
    assert_equal(determinant, np.linalg.det(links), EXACT)
    assert_equal(condition, np.linalg.cond(links, "fro"), EXACT)


def test_mass_matrix(case: Case, engine: Engine) -> None:
    M = engine.mass_matrix()
    found = generated.mass_matrix(case.p, case.parameters)
    assert_equal(found[:3, :3], M[:3, :3], EXACT)
    # Pulleys and motors: relative to each entry, because they differ by orders of magnitude.
    assert np.diag(found)[3:] == pytest.approx(np.diag(M)[3:], rel=EXACT)
    assert_equal(found * np.outer(case.belt, case.belt), M * np.outer(case.belt, case.belt), EXACT)


def test_kinetic_energy(case: Case, engine: Engine) -> None:
    q_dot = case.velocities()
    T_ss, T_t = generated.kinetic_energy(case.p, q_dot, case.parameters)
    structure = q_dot * np.repeat([1.0, 0.0], [3, 6])
    assert_equal(T_ss, engine.kinetic_energy(structure), EXACT)
    assert_equal(T_t, engine.kinetic_energy(q_dot - structure), EXACT)
    assert_equal(T_ss + T_t, engine.kinetic_energy(q_dot), EXACT)


def test_gravitational_potential_and_its_gradient(case: Case, engine: Engine) -> None:
    V = generated.gravity_potential(case.p, case.parameters)
    G = generated.gravity_gradient(case.p, case.parameters)
    # A sum of positive and negative terms: rounding is relative to the size of a single term.
    weight = 9.81 * (case.parameters.platform_mass + case.parameters.link_mass.sum())
    assert pytest.approx(engine.potential(), rel=EXACT, abs=EXACT * weight) == V
    assert_equal(G, engine.gradient()[:3], EXACT)  # from its forces
    h = ENERGY_STEP * engine.length_scale()
    by_energy = [engine.energy_along(unit, h)[0] for unit in np.eye(9)[:3]]
    assert_equal(G, np.array(by_energy), 5e-11)  # worst: 5e-12, of truncation


def test_gravitational_stiffness(case: Case, engine: Engine) -> None:
    H = generated.gravity_hessian(case.p, case.parameters)
    with engine.without_belts():
        found = engine.hessian(steps(case, engine))
    # Differences of forces: worst 1e-12, of rounding over step.
    assert_equal(H, found[:3, :3], 1e-11)
    found[:3, :3] = 0
    assert np.abs(found).max() < 1e-11 * np.abs(H).max()  # the pulleys have no weight


def test_gravitational_stiffness_from_energy_alone(case: Case, engine: Engine) -> None:
    # The definition itself, without the engine's forces.  Worst: 5e-10, of rounding over the step squared.
    H = generated.gravity_hessian(case.p, case.parameters)
    directions = np.concatenate([np.eye(3), [[0.6, -0.8, 0.0], [0.0, 0.8, 0.6], [-0.8, 0.0, 0.6]]])
    h = ENERGY_STEP * engine.length_scale()
    with engine.without_belts():
        curvature = [engine.energy_along(np.concatenate([d, np.zeros(6)]), h)[1] for d in directions]
    assert_equal(np.einsum("ni,ij,nj->n", directions, H, directions), np.array(curvature), 5e-9)


def test_stiffness_matrix(case: Case, engine: Engine) -> None:
    # Relative to belts of 1e5 N/m, compared with which gravity is small: it is tested separately.
    scale = np.outer(case.belt, case.belt)
    K = engine.hessian(steps(case, engine))
    assert_equal(generated.stiffness_matrix(case.p, case.parameters) * scale, K * scale, EXACT)
    with engine.without_belts():
        K -= engine.hessian(steps(case, engine))
    assert_equal(generated.elastic_hessian(case.p, case.parameters) * scale, K * scale, EXACT)


def test_strained_belts(case: Case, engine: Engine) -> None:
    # By belts and weight together less weight alone; a millimetre of strain makes the belts' part the larger.
    delta = 1e-3 * case.velocities()
    engine.move(delta)
    V, E = engine.potential(), engine.gradient()
    with engine.without_belts():
        engine.move(delta)
        V, E = V - engine.potential(), E - engine.gradient()
    assert_equal(generated.elastic_potential(case.p, delta, case.parameters), V, 1e-11)
    assert_equal(generated.elastic_gradient(case.p, delta, case.parameters) / case.belt, E / case.belt, EXACT)


def test_modes(case: Case, engine: Engine) -> None:
    # Eigenvalues are sharp to rounding of the largest one, 1e7 /s^2; the rigid ones are gravity's, 10 /s^2.
    scale = np.outer(case.belt, case.belt)
    M, K = generated.modal_matrices(case.p, case.parameters)
    stiffness, mass = engine.hessian(steps(case, engine)), engine.mass_matrix()
    expected = eigh(stiffness * scale, mass * scale, eigvals_only=True)
    found = eigh(K * scale, M * scale, eigvals_only=True)
    assert np.sum(np.abs(expected) < 1e-2 * expected[3]) == 3
    assert found[3:] == pytest.approx(expected[3:], rel=1e-11)
    assert_equal(found[:3], expected[:3], 2e-9)


def test_torques_and_pulleys_that_hold_the_pose(case: Case, engine: Engine) -> None:
    torques, theta = generated.static_equilibrium(case.p, case.parameters)
    weight = np.abs(engine.gradient()).max()
    engine.move(np.concatenate([np.zeros(3), theta]))
    # As forces at the belt: the residual vanishes at all nine coordinates.
    left = engine.out_of_balance(torques) * case.belt
    assert np.abs(left).max() < EXACT * weight
    assert engine.platform() == pytest.approx(case.p, rel=0, abs=1e-14)


def test_coriolis_and_centrifugal_forces(case: Case, engine: Engine) -> None:
    for x_dot in ([1.0, -0.7, 0.4], [0.0, 0.9, 0.0], [-0.5, -0.6, -0.55]):
        h, acceleration = engine.velocity_forces(np.array(x_dot))
        arguments = case.p, np.array(x_dot), case.parameters
        assert_equal(generated.velocity_forces(*arguments), h, EXACT_TWICE)
        assert_equal(generated.platform_jacobian_rate(*arguments) @ x_dot, acceleration, EXACT_TWICE)
        P = generated.platform_second_derivatives(case.p, case.parameters)
        assert_equal(np.einsum("ikl,k,l->i", P, x_dot, x_dot), acceleration, EXACT_TWICE)


def test_spin_of_the_rods_about_themselves_is_no_part_of_the_model(case: Case, engine: Engine) -> None:
    # The engine's rods may spin on their ball joints and must have some inertia about themselves.  Given a
    # million times what they have elsewhere, spin has just that much, and nothing of it is the coordinates'.
    other = Engine(case.parameters, case.p, axial_inertia=1e-3)
    motions, x_dot = other.motions(), np.array([1.0, -0.7, 0.4])
    scale = np.concatenate([np.ones(3), case.belt])
    M = motions.T @ other.inertia() @ motions * np.outer(scale, scale)
    assert np.abs(M[:3, :3] - 1e-3 * np.eye(3)).max() < EXACT * 1e-3
    assert np.abs(M[:3, 3:]).max() < EXACT * np.abs(M).max()
    assert_equal(M[3:, 3:], engine.mass_matrix() * np.outer(case.belt, case.belt), EXACT)
    assert_equal(other.velocity_forces(x_dot)[0], engine.velocity_forces(x_dot)[0], EXACT_TWICE)


def test_links_are_uniform_slender_rods(case: Case) -> None:
    # The inertia is the engine's own, of a cylinder: the generated mass matrix is the limit of no radius,
    # approached with the square of the radius.
    slender = generated.mass_matrix(case.p, case.parameters)[:3, :3]

    def excess(rod_radius: float) -> np.ndarray:
        return Engine(case.parameters, case.p, rod_radius=rod_radius).mass_matrix()[:3, :3] - slender

    thick, thin = excess(1e-2), excess(1e-3)
    assert np.trace(thick) > 0
    assert_equal(100 * thin, thick, EXACT / 1e-6)  # the radius squared is what is left of the mass matrix
