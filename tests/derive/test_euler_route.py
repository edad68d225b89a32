"""Two routes to the rods' rotational energy: direct, and through the paper's Euler angles."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from sympy import Matrix, lambdify

from helpers.robots.sample_robots import random_robot
from pkmodes_derive import mechanisms
from pkmodes_derive.assembly import kinematics
from pkmodes_derive.mechanisms.linear_delta.euler_route import EulerRoute, euler_route
from pkmodes_generated import linear_delta

MACHINE = mechanisms.machine("linear_delta")
KIN = kinematics.derive(MACHINE)


@cache
def route_of(j: int) -> EulerRoute:
    return euler_route(MACHINE, KIN, j)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("j", range(3))
def test_both_routes_give_the_same_kinetic_energy_of_a_linkage(seed: int, j: int) -> None:
    """Compare the emitted energy, from the velocities of the rod ends, with the paper's, from Euler angles."""
    rng = np.random.default_rng(700 + seed)
    parameters, pose = random_robot(rng)
    x_dot, phi = rng.normal(size=3), rng.uniform(-np.pi, np.pi)
    only_j = np.where(np.arange(3) == j, parameters.link_mass, 0.0)
    bare = parameters._replace(platform_mass=0.0, carriage_mass=np.zeros(3), link_mass=only_j)
    emitted, _ = linear_delta.kinetic_energy(pose, np.concatenate([x_dot, np.zeros(6)]), bare)

    D_l, _ = linear_delta.constraint_jacobians(pose, parameters)
    D_d, D_omega = linear_delta.link_jacobians(pose, parameters)
    by_angles, inertia = evaluate(j, D_l[j], pose, parameters, phi)
    centre, omega = D_d[j] @ x_dot, by_angles @ x_dot
    paper = 0.5 * parameters.link_mass[j] * centre @ centre + 0.5 * omega @ inertia @ omega
    # The angles lose digits as the rod nears their singularity.
    np.testing.assert_allclose(
        paper, emitted, rtol=1e-12 * amplification(D_l[j], phi, parameters.link_length[j])
    )

    # The two angular velocities differ only by a spin about the rod.
    rod = D_l[j] / np.linalg.norm(D_l[j])
    difference = by_angles - D_omega[j]
    spin = np.outer(rod, rod @ difference)
    np.testing.assert_allclose(difference, spin, rtol=0, atol=1e-11 * np.abs(by_angles).max())


def evaluate(
    j: int, s: np.ndarray, pose: np.ndarray, parameters: linear_delta.Parameters, phi: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return D_omega and inertia of linkage j by the paper's route, with s_j and U_j from the closures."""
    route, link, mass = route_of(j), MACHINE.links[j], MACHINE.rods[j].mass
    U = linear_delta.platform_jacobian(pose, parameters) - np.outer(parameters.direction[j], np.eye(3)[j])
    arguments = [*link.vector, *KIN.U[j], link.length, mass, route.phi]
    function = lambdify(arguments, [route.D_omega, route.inertia])
    values = function(*s, *U.ravel(), parameters.link_length[j], parameters.link_mass[j], phi)
    by_angles, inertia = (np.array(m, dtype=float) for m in values)
    return by_angles, inertia


def amplification(s: np.ndarray, phi: float, length: float) -> float:
    """Return the inverse square of cos(beta), which grows towards the singularity of the Euler angles."""
    u_1 = -(s[0] * np.cos(phi) + s[1] * np.sin(phi)) / length
    return float(1.0 / (1.0 - u_1**2))


def test_angles_reproduce_the_direction_of_the_rod() -> None:
    """The rod is the third axis of the frame turned by alpha about x, then by beta about y'."""
    route = route_of(0)
    direction = Matrix([route.Psi[0, 2], route.Psi[1, 2], route.Psi[2, 2]])
    evaluate = lambdify(route.u, list(direction))
    rng = np.random.default_rng(7)
    for _ in range(20):
        u = rng.normal(size=3)
        np.testing.assert_allclose(evaluate(*u), u / np.linalg.norm(u), rtol=0, atol=1e-14)


def test_angular_velocity_is_perpendicular_to_the_rod_and_moves_its_end() -> None:
    parameters, pose = random_robot(np.random.default_rng(71))
    D_l, _ = linear_delta.constraint_jacobians(pose, parameters)
    _, D_omega = linear_delta.link_jacobians(pose, parameters)
    D_p = linear_delta.platform_jacobian(pose, parameters)
    for j in range(3):
        np.testing.assert_allclose(D_l[j] @ D_omega[j], 0.0, rtol=0, atol=1e-13 * np.abs(D_omega[j]).max())
        end = np.outer(parameters.direction[j], np.eye(3)[j]) + np.cross(D_omega[j].T, D_l[j]).T
        np.testing.assert_allclose(end, D_p, rtol=0, atol=1e-13 * np.abs(D_p).max())
