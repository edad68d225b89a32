"""Two routes to the rods' rotational energy: directly, and by the paper's Euler angles."""

from __future__ import annotations

import numpy as np
import pytest
from sympy import Matrix, lambdify

from pkmodes_derive.linear_delta import kinematics, rotation
from pkmodes_derive.linear_delta.symbols import Symbols
from pkmodes_generated import linear_delta
from sample_robots import random_robot

sy = Symbols()
KIN = kinematics.derive(sy)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("j", range(3))
def test_both_routes_give_the_same_rotational_energy(seed: int, j: int) -> None:
    rng = np.random.default_rng(700 + seed)
    parameters, pose = random_robot(rng)
    D_l, _ = linear_delta.constraint_jacobians(pose, parameters)
    _, D_omega = linear_delta.link_jacobians(pose, parameters)
    route = rotation.euler_route(sy, KIN, j)
    # s_j and U_j from the closures: row j of D_l, and velocity of the platform less that of the carriage.
    U = linear_delta.platform_jacobian(pose, parameters) - np.outer(parameters.direction[j], np.eye(3)[j])
    arguments = [*KIN.s[j], *KIN.U[j], sy.l_d[j], sy.m_d[j], sy.phi[j]]
    evaluate = lambdify(arguments, [route.D_omega, route.inertia])
    phi = rng.uniform(-np.pi, np.pi)
    values = (*D_l[j], *U.ravel(), parameters.link_length[j], parameters.link_mass[j], phi)
    by_angles, inertia = (np.array(m, dtype=float) for m in evaluate(*values))

    direct_energy = D_omega[j].T @ inertia @ D_omega[j]
    euler_energy = by_angles.T @ inertia @ by_angles
    # 1e-12 relative to the energy; the angles lose digits as the rod nears their singularity.
    np.testing.assert_allclose(
        euler_energy,
        direct_energy,
        atol=1e-12 * np.abs(direct_energy).max() * amplification(D_l[j], phi, parameters.link_length[j]),
    )
    # The two angular velocities differ by a spin about the rod and by nothing else.
    rod = D_l[j] / np.linalg.norm(D_l[j])
    difference = by_angles - D_omega[j]
    np.testing.assert_allclose(
        difference, np.outer(rod, rod @ difference), atol=1e-11 * np.abs(by_angles).max()
    )


def amplification(s: np.ndarray, phi: float, length: float) -> float:
    """Inverse square of cos(beta): how near the Euler angles are to their singularity."""
    u_1 = -(s[0] * np.cos(phi) + s[1] * np.sin(phi)) / length
    return float(1.0 / (1.0 - u_1**2))


def test_angles_reproduce_the_direction_of_the_rod() -> None:
    """The rod is the third axis of the frame turned by alpha about x, then by beta about y'."""
    route = rotation.euler_route(sy, KIN, 0)
    direction = Matrix([route.Psi[0, 2], route.Psi[1, 2], route.Psi[2, 2]])
    evaluate = lambdify(route.u, list(direction))
    rng = np.random.default_rng(7)
    for _ in range(20):
        u = rng.normal(size=3)
        np.testing.assert_allclose(evaluate(*u), u / np.linalg.norm(u), atol=1e-14)


def test_angular_velocity_is_square_to_the_rod_and_moves_its_end() -> None:
    parameters, pose = random_robot(np.random.default_rng(71))
    D_l, _ = linear_delta.constraint_jacobians(pose, parameters)
    _, D_omega = linear_delta.link_jacobians(pose, parameters)
    D_p = linear_delta.platform_jacobian(pose, parameters)
    for j in range(3):
        np.testing.assert_allclose(D_l[j] @ D_omega[j], 0.0, atol=1e-13 * np.abs(D_omega[j]).max())
        end = np.outer(parameters.direction[j], np.eye(3)[j]) + np.cross(D_omega[j].T, D_l[j]).T
        np.testing.assert_allclose(end, D_p, atol=1e-13 * np.abs(D_p).max())
