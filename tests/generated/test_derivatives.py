"""Every generated function against derivatives of the generated functions from which it follows.

Each relation below says "the derivative of this along that equals ...", and is tried with two operators that
share nothing with the derivation: central differences, which treat the functions as black boxes, and the
complex step, which has no truncation or cancellation and so shows errors down to rounding.  Both differentiate
along the motion of the robot: the platform comes from `direct_kinematics`, never from a Jacobian.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cache
from typing import Any

import numpy as np
import pytest

from helpers.generated.generated_functions import FUNCTIONS
from helpers.robots.sample_robots import SAMPLES, sample
from pkmodes_generated.linear_delta import model

Derivative = Callable[[Callable[[Any], Any], Any, Any], Any]
#: Found, expected, and the scale of the error if it is not the largest expected entry.
Pairs = Iterable[tuple[Any, Any] | tuple[Any, Any, Any]]

# Complex step: rounding only, about 200 units in the last place for each unit of the Frobenius condition number
# of D_l.  That is four times the bound of the values themselves (test_generated_oracle), because the motion
# comes from the intersection of three spheres, which has a condition of its own.  Measured over 60 random
# robots: at most 1.4e-14 (velocity_forces), 2e-16 in the median.
COMPLEX_STEP_ERROR = 4e-14
# Central differences of sixth order, with carriages and platform within 0.2 mm for each step.  The functions
# change over lengths of l / condition, 25 mm and more here, so the truncation is 36 (0.2 / 25)^6 = 1e-11, with a
# factor of ten or so for each derivative already in the function; rounding over the step is 1e-12 times the
# condition.  Measured: at most 2e-9 (velocity_forces), 1e-12 in the median.
CENTRAL_DIFFERENCE_ERROR = 1e-8
STEP = 2e-4
GAUSS = ((0.5 - np.sqrt(0.15), 5 / 18), (0.5, 8 / 18), (0.5 + np.sqrt(0.15), 5 / 18))


def complex_step(function: Callable[[Any], Any], at: Any, along: Any) -> Any:
    # the square of the step is below the smallest double, so nothing of second order is left
    return np.imag(function(at + 1e-200j * along)) / 1e-200


def central_difference(function: Callable[[Any], Any], at: Any, along: Any) -> Any:
    total = 0.0
    for weight, steps in ((45, 1), (-9, 2), (1, 3)):
        total += weight * (function(at + steps * STEP * along) - function(at - steps * STEP * along))
    return total / (60 * STEP)


class Case:
    """A sample with the values that the relations use, and random directions and rates."""

    def __init__(self, name: str) -> None:
        self.robot, self.p = sample(name)
        rng = np.random.default_rng(11)
        self.x = model.inverse_kinematics(self.p, self.robot)
        determinant, self.condition = model.jacobian_condition(self.p, self.robot)
        self.assembly = np.sign(determinant)
        self.delta_q = rng.normal(size=9) * np.repeat([1e-3, 3e-2], [3, 6])
        self.q_dot, self.along = (self._motion(rng) for _ in range(2))
        self.x_dot = self.along[:3]

    def _motion(self, rng: np.random.Generator) -> Any:
        """Random rates of all coordinates; neither carriages nor platform are faster than 1 m/s."""
        rates = rng.normal(size=9)
        x_dot = rates[:3]
        # so that the step of a difference is a length; how long exactly does not matter
        p_dot = model.platform_jacobian(self.p, self.robot) @ x_dot
        x_dot /= max(np.max(np.abs(x_dot)), np.linalg.norm(p_dot))
        rates[3:] *= 30.0
        return rates

    def platform(self, x: Any) -> Any:
        return model.direct_kinematics(x, self.assembly, self.robot)

    def linkages(self, p: Any, x: Any) -> Any:
        return p + self.robot.joint - self.carriages(x)

    def carriages(self, x: Any) -> Any:
        return self.robot.origin + x[:, None] * self.robot.direction

    def total_energy(self, q_dot: Any) -> Any:
        return sum(model.kinetic_energy(self.p, q_dot, self.robot))

    def belt_elongations(self, delta_q: Any) -> Any:
        x, theta_1, theta_2 = delta_q.reshape(3, 3)
        R = self.robot.pulley_radius
        return np.stack([R * (theta_2 - theta_1), x - R * theta_2, R * theta_1 - x], axis=-1)

    def potential(self, delta_q: Any) -> Any:
        """Gravity and belts, for displacements of all coordinates from the pose with unstrained belts."""
        platform = self.platform(self.x + delta_q[:3])
        return model.gravity_potential(platform, self.robot) + model.elastic_potential(
            self.p, delta_q, self.robot
        )

    def potential_gradient(self, delta_q: Any) -> Any:
        gradient = model.elastic_gradient(self.p, delta_q, self.robot)
        gradient[:3] += model.gravity_gradient(self.platform(self.x + delta_q[:3]), self.robot)
        return gradient


def inverse_kinematics(c: Case, d: Derivative) -> Pairs:
    yield d(lambda x: model.inverse_kinematics(c.platform(x), c.robot), c.x, c.x_dot), c.x_dot


def direct_kinematics(c: Case, d: Derivative) -> Pairs:
    # rigid linkages: both ends have the same velocity along the linkage
    s = c.linkages(c.p, c.x)
    p_dot = d(c.platform, c.x, c.x_dot)
    yield s @ p_dot, np.sum(s * c.robot.direction, axis=-1) * c.x_dot


def reach_margin(c: Case, d: Derivative) -> Pairs:
    r, n = c.p + c.robot.joint - c.robot.origin, c.robot.direction
    away = r - np.sum(r * n, axis=-1, keepdims=True) * n
    away /= np.linalg.norm(away, axis=-1, keepdims=True)
    yield d(lambda p: model.reach_margin(p, c.robot), c.p, c.x_dot), -away @ c.x_dot


def belt_spans(c: Case, d: Derivative) -> Pairs:
    found = d(lambda x: model.belt_spans(c.platform(x), c.robot), c.x, c.x_dot)
    yield found, np.stack([0 * c.x_dot, c.x_dot, -c.x_dot], axis=-1)


def belt_stiffness(c: Case, d: Derivative) -> Pairs:
    # k l_f is constant
    k, l_f = model.belt_stiffness(c.p, c.robot), model.belt_spans(c.p, c.robot)
    found = d(lambda x: model.belt_stiffness(c.platform(x), c.robot), c.x, c.x_dot)
    yield found, -k / l_f * np.stack([0 * c.x_dot, c.x_dot, -c.x_dot], axis=-1)


def constraint_jacobians(c: Case, d: Derivative) -> Pairs:
    D_l, D_r = model.constraint_jacobians(c.p, c.robot)

    def closures(p: Any, x: Any) -> Any:
        return np.sum(c.linkages(p, x) ** 2, axis=-1) / 2

    yield D_l @ c.x_dot, d(lambda p: closures(p, c.x), c.p, c.x_dot)
    yield D_r @ c.x_dot, -d(lambda x: closures(c.p, x), c.x, c.x_dot)


def jacobian_condition(c: Case, d: Derivative) -> Pairs:
    A = model.constraint_jacobians(c.p, c.robot)[0]
    dA = d(lambda x: model.constraint_jacobians(c.platform(x), c.robot)[0], c.x, c.x_dot)
    B = np.linalg.inv(A)
    dB = -B @ dA @ B
    determinant, condition = model.jacobian_condition(c.p, c.robot)
    found = [
        d(lambda x, i=i: model.jacobian_condition(c.platform(x), c.robot)[i], c.x, c.x_dot) for i in (0, 1)
    ]
    growth = np.sum(A * dA) / np.sum(A * A) + np.sum(B * dB) / np.sum(B * B)
    # both are at an extreme in a symmetric pose: measured by their change over a linkage length
    length = np.min(c.robot.link_length)
    yield found[0], determinant * np.trace(B @ dA), determinant / length
    yield found[1], condition * growth, condition / length


def platform_jacobian(c: Case, d: Derivative) -> Pairs:
    yield model.platform_jacobian(c.p, c.robot) @ c.x_dot, d(c.platform, c.x, c.x_dot)


def platform_jacobian_rate(c: Case, d: Derivative) -> Pairs:
    expected = d(lambda x: model.platform_jacobian(c.platform(x), c.robot), c.x, c.x_dot)
    yield model.platform_jacobian_rate(c.p, c.x_dot, c.robot), expected


def platform_second_derivatives(c: Case, d: Derivative) -> Pairs:
    P = model.platform_second_derivatives(c.p, c.robot)
    yield P @ c.x_dot, d(lambda x: model.platform_jacobian(c.platform(x), c.robot), c.x, c.x_dot)
    yield P, P.swapaxes(1, 2)


def link_jacobians(c: Case, d: Derivative) -> Pairs:
    D_d, D_omega = model.link_jacobians(c.p, c.robot)

    def centres(x: Any) -> Any:
        return c.carriages(x) + c.linkages(c.platform(x), x) / 2

    s = c.linkages(c.p, c.x)
    turning = D_omega @ c.x_dot
    yield D_d @ c.x_dot, d(centres, c.x, c.x_dot)
    yield np.cross(turning, s), d(lambda x: c.linkages(c.platform(x), x), c.x, c.x_dot)
    yield np.sum(turning * s, axis=-1), np.zeros(3), np.linalg.norm(c.x_dot)


def gravity_potential(c: Case, d: Derivative) -> Pairs:
    # the power of the weights, with opposite sign
    q = c.robot
    moment = q.platform_mass * (model.platform_jacobian(c.p, q) @ c.x_dot)
    moment += q.link_mass @ (model.link_jacobians(c.p, q)[0] @ c.x_dot)
    moment += (q.carriage_mass * c.x_dot) @ q.direction
    found = d(lambda x: model.gravity_potential(c.platform(x), q), c.x, c.x_dot)
    yield found, -q.gravity @ moment, _weights(c)


def gravity_gradient(c: Case, d: Derivative) -> Pairs:
    expected = d(lambda x: model.gravity_potential(c.platform(x), c.robot), c.x, c.x_dot)
    yield model.gravity_gradient(c.p, c.robot) @ c.x_dot, expected, _weights(c)


def _weights(c: Case) -> Any:
    """Size of the power of the weights, whose sum may cancel."""
    return np.linalg.norm(model.gravity_gradient(c.p, c.robot)) * np.linalg.norm(c.x_dot)


def gravity_hessian(c: Case, d: Derivative) -> Pairs:
    H = model.gravity_hessian(c.p, c.robot)
    yield H @ c.x_dot, d(lambda x: model.gravity_gradient(c.platform(x), c.robot), c.x, c.x_dot)
    yield H, H.T


def kinetic_energy(c: Case, d: Derivative) -> Pairs:
    q, rates = c.robot, c.q_dot[:3]

    def rod_points(x: Any, fraction: float) -> Any:
        return c.carriages(x) + fraction * c.linkages(c.platform(x), x)

    structure = q.platform_mass * np.sum(d(c.platform, c.x, rates) ** 2) + q.carriage_mass @ rates**2
    for fraction, weight in GAUSS:
        speeds = d(lambda x, fraction=fraction: rod_points(x, fraction), c.x, rates)
        structure += weight * q.link_mass @ np.sum(speeds**2, axis=-1)
    pulleys = c.q_dot[3:].reshape(2, 3).T
    motors = q.gear_ratio * np.sum(q.drive * pulleys, axis=-1)
    transmission = q.pulley_inertia @ np.sum(pulleys**2, axis=-1) + q.motor_inertia @ motors**2
    yield model.kinetic_energy(c.p, c.q_dot, q), (structure / 2, transmission / 2)


def mass_matrix(c: Case, d: Derivative) -> Pairs:
    M = model.mass_matrix(c.p, c.robot)
    yield c.along @ M @ c.q_dot, d(c.total_energy, c.q_dot, c.along), _energies(c)
    yield M, M.T


def _energies(c: Case) -> Any:
    """Size of a product of two motions, which may be nearly orthogonal."""
    return np.sqrt(c.total_energy(c.q_dot) * c.total_energy(c.along))


def velocity_forces(c: Case, d: Derivative) -> Pairs:
    # Lagrange's equations without acceleration: d/dt (M_ss x_dot) - dT/dx
    rest = np.zeros(6)

    def momentum(x: Any) -> Any:
        return model.mass_matrix(c.platform(x), c.robot)[:3, :3] @ c.x_dot

    def energy(x: Any) -> Any:
        return model.kinetic_energy(c.platform(x), np.concatenate([c.x_dot, rest]), c.robot)[0]

    rise = np.array([d(energy, c.x, unit) for unit in np.eye(3)])
    yield model.velocity_forces(c.p, c.x_dot, c.robot), d(momentum, c.x, c.x_dot) - rise


def elastic_potential(c: Case, d: Derivative) -> Pairs:
    forces = model.belt_stiffness(c.p, c.robot) * c.belt_elongations(c.delta_q)
    found = d(lambda dq: model.elastic_potential(c.p, dq, c.robot), c.delta_q, c.along)
    yield found, np.sum(forces * c.belt_elongations(c.along))


def elastic_gradient(c: Case, d: Derivative) -> Pairs:
    expected = d(lambda dq: model.elastic_potential(c.p, dq, c.robot), c.delta_q, c.along)
    yield model.elastic_gradient(c.p, c.delta_q, c.robot) @ c.along, expected


def elastic_hessian(c: Case, d: Derivative) -> Pairs:
    H = model.elastic_hessian(c.p, c.robot)
    yield H @ c.along, d(lambda dq: model.elastic_gradient(c.p, dq, c.robot), c.delta_q, c.along)
    yield H, H.T


def stiffness_matrix(c: Case, d: Derivative) -> Pairs:
    K = model.stiffness_matrix(c.p, c.robot)
    yield K @ c.along, d(c.potential_gradient, np.zeros(9), c.along)
    yield K, K.T


def modal_matrices(c: Case, d: Derivative) -> Pairs:
    M, K = model.modal_matrices(c.p, c.robot)
    yield c.along @ M @ c.q_dot, d(c.total_energy, c.q_dot, c.along), _energies(c)
    yield K @ c.along, d(c.potential_gradient, np.zeros(9), c.along)
    yield M, model.mass_matrix(c.p, c.robot)
    yield K, model.stiffness_matrix(c.p, c.robot)


def static_equilibrium(c: Case, d: Derivative) -> Pairs:
    # carriages at the pose, pulleys turned: the work of the torques is what the potential energy gains
    torques, theta = model.static_equilibrium(c.p, c.robot)
    torques_on_pulleys = (torques[:, None] * c.robot.drive).T.ravel()
    held = np.concatenate([np.zeros(3), theta])
    gains = [d(c.potential, held, unit) for unit in np.eye(9)]
    # what is left in a balance is measured by the forces that balance
    weights = model.gravity_gradient(c.p, c.robot)
    size = np.repeat([np.linalg.norm(weights), np.linalg.norm(weights * c.robot.pulley_radius)], [3, 6])
    yield gains, np.concatenate([np.zeros(3), torques_on_pulleys]), size


RELATIONS: dict[str, Callable[[Case, Derivative], Pairs]] = {
    relation.__name__: relation
    for relation in (
        inverse_kinematics,
        direct_kinematics,
        reach_margin,
        belt_spans,
        belt_stiffness,
        constraint_jacobians,
        jacobian_condition,
        platform_jacobian,
        platform_jacobian_rate,
        platform_second_derivatives,
        link_jacobians,
        gravity_potential,
        gravity_gradient,
        gravity_hessian,
        kinetic_energy,
        mass_matrix,
        velocity_forces,
        elastic_potential,
        elastic_gradient,
        elastic_hessian,
        stiffness_matrix,
        modal_matrices,
        static_equilibrium,
    )
}


def test_every_public_function_has_a_relation() -> None:
    assert set(RELATIONS) == set(FUNCTIONS)


def _error(found: Any, expected: Any, size: Any = None) -> float:
    found, expected = np.asarray(found), np.asarray(expected)
    size = np.max(np.abs(expected)) if size is None else np.abs(size)
    return float(np.max(np.abs(found - expected) / size))


@cache
def case(robot_name: str) -> Case:
    return Case(robot_name)


@pytest.mark.parametrize("name", RELATIONS)
def test_relation_holds_by_complex_step(name: str) -> None:
    wrong = []
    for robot_name in SAMPLES:
        one = case(robot_name)
        for found, expected, *size in RELATIONS[name](one, complex_step):
            if not _error(found, expected, *size) < COMPLEX_STEP_ERROR * one.condition:
                wrong.append(f"{robot_name}: {found} instead of {expected}")
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("name", RELATIONS)
def test_relation_holds_by_central_differences(name: str) -> None:
    wrong = []
    for robot_name in SAMPLES:
        for found, expected, *size in RELATIONS[name](case(robot_name), central_difference):
            if not _error(found, expected, *size) < CENTRAL_DIFFERENCE_ERROR:
                wrong.append(f"{robot_name}: {found} instead of {expected}")
    assert not wrong, "\n".join(wrong)
