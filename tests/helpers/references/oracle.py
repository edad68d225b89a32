"""Independent model of the linear delta in 60 decimal digits, against which the generated code is measured.

Everything here starts from definitions: positions solve the closures by Newton's method, velocities and every
other derivative are central differences of positions or of energies, the kinetic energy of a rod is an
integral over its length, the mass matrix comes from energies by polarisation, stiffnesses from belt elongations.
Nothing is taken from the derivation or from the generated formulas, so that an error shared by this file and
the generated code would have to be made twice.

The methods of `Oracle` have the names of the generated functions; each returns mpf numbers, or arrays of them.

Accuracy.  With 60 digits and a step of 1e-15, a first difference errs by 1e-30 (truncation, step squared) and
1e-45 (rounding over step), a second difference by 1e-30 twice: all far below the 1e-16 of a double.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import mpmath
import numpy as np

from pkmodes_generated.linear_delta import Parameters

DIGITS = 60
# A context of its own: the precision of mpmath.mp belongs to whoever else uses it.
mp = mpmath.mp.clone()
mp.dps = DIGITS
STEP = mp.mpf(10) ** -15
# The last Newton step, three orders above the rounding of 60 digits; convergence is quadratic there.
CONVERGED = mp.mpf(10) ** -55

Number = Any  # mpmath publishes no types
Vector = list[Number]

# Gauss-Legendre on [0, 1] with three points: exact to degree 5, and the energy density of a rod has degree 2.
_REACH = mp.sqrt(mp.mpf(3) / 5) / 2
ROD_FRACTIONS = (mp.mpf(1) / 2 - _REACH, mp.mpf(1) / 2, mp.mpf(1) / 2 + _REACH)
ROD_WEIGHTS = (mp.mpf(5) / 18, mp.mpf(8) / 18, mp.mpf(5) / 18)


class Points(NamedTuple):
    """Where the parts of the robot are."""

    platform: Vector
    carriages: list[Vector]
    joints: list[Vector]


def _exact(values: Any) -> Any:
    """Doubles to mpf without rounding, nested lists for arrays."""
    array = np.asarray(values, dtype=float)
    return mp.mpf(float(array)) if array.ndim == 0 else [_exact(row) for row in array]


def _dot(a: Vector, b: Vector) -> Number:
    return sum((x * y for x, y in zip(a, b, strict=True)), mp.mpf(0))


def _cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _combine(a: Vector, factor: Number, b: Vector) -> Vector:
    """Vector a + factor b."""
    return [x + factor * y for x, y in zip(a, b, strict=True)]


def _unit(k: int, size: int) -> Vector:
    return [mp.mpf(i == k) for i in range(size)]


def _solve(rows: Sequence[Vector], right: Vector) -> Vector:
    """Three linear equations by Cramer's rule: at 60 digits its cancellation does not matter."""
    first, second, third = rows
    planes = [_cross(second, third), _cross(third, first), _cross(first, second)]
    determinant = _dot(first, planes[0])
    return [sum(right[j] * planes[j][i] for j in range(3)) / determinant for i in range(3)]


class Oracle:
    """The robot of some parameters (no batch) at one pose of its platform.

    The pose is taken as exact, and the carriage positions follow from it; direction vectors are taken as the
    doubles they are, a unit vector to about 1e-16, which is why the generated code may differ by that much.
    """

    def __init__(self, parameters: Parameters, pose: Any) -> None:
        values = {name: _exact(value) for name, value in parameters._asdict().items()}
        self.q = Parameters(**values)
        self.pose: Vector = _exact(pose)
        self.x: Vector = list(self.inverse_kinematics())

    # Positions

    def carriage(self, j: int, x: Number) -> Vector:
        return _combine(self.q.origin[j], x, self.q.direction[j])

    def closures(self, platform: Vector, x: Vector) -> Vector:
        """Half the excess of each squared link length, from joint and carriage."""
        excess = []
        for j in range(3):
            joint = _combine(platform, 1, self.q.joint[j])
            link = _combine(joint, -1, self.carriage(j, x[j]))
            excess.append((_dot(link, link) - self.q.link_length[j] ** 2) / 2)
        return excess

    def newton(self, start: Vector, x: Vector) -> Vector:
        """Platform centre that satisfies the closures for carriages at x, near `start`."""
        platform = start
        for _ in range(30):
            links = [
                _combine(_combine(platform, 1, self.q.joint[j]), -1, self.carriage(j, x[j])) for j in range(3)
            ]
            move = _solve(links, self.closures(platform, x))
            platform = _combine(platform, -1, move)
            if max(map(abs, move)) < CONVERGED:
                return platform
        raise ArithmeticError("Newton's method did not converge")

    def points(self, x: Vector) -> Points:
        platform = self.newton(self.pose, x)
        carriages = [self.carriage(j, x[j]) for j in range(3)]
        return Points(platform, carriages, [_combine(platform, 1, b) for b in self.q.joint])

    # Differences

    def slope(self, value: Callable[[Vector], Any], x: Vector, along: Vector) -> Any:
        """Derivative of an array or number by the carriage positions, in one direction."""
        ahead, behind = value(_combine(x, STEP, along)), value(_combine(x, -STEP, along))
        return (ahead - behind) / (2 * STEP)

    def columns(self, value: Callable[[Vector], Any], x: Vector) -> np.ndarray:
        """Derivatives by each carriage position, as the last axis."""
        return np.stack([self.slope(value, x, _unit(k, 3)) for k in range(3)], axis=-1)

    def platform(self, x: Vector) -> np.ndarray:
        return np.array(self.newton(self.pose, x), dtype=object)

    def platform_columns(self, x: Vector) -> np.ndarray:
        return self.columns(self.platform, x)

    # Kinematics

    def inverse_kinematics(self) -> np.ndarray:
        """Rail line meets sphere around the platform joint: the root of a quadratic that `branch` names."""
        found = []
        for j in range(3):
            n = self.q.direction[j]
            r = _combine(_combine(self.pose, 1, self.q.joint[j]), -1, self.q.origin[j])
            a, b, c = _dot(n, n), _dot(n, r), _dot(r, r) - self.q.link_length[j] ** 2
            if b * b < a * c:
                raise ArithmeticError(f"the linkage of axis {j + 1} does not reach its rail")
            found.append((b + self.q.branch[j] * mp.sqrt(b * b - a * c)) / a)
        return np.array(found, dtype=object)

    def direct_kinematics(self, x: Any, assembly: float) -> np.ndarray:
        """Newton's method from the pose, or from its mirror image in the plane of the sphere centres."""
        exact = _exact(x)
        centres = [_combine(self.carriage(j, exact[j]), -1, self.q.joint[j]) for j in range(3)]
        normal = _cross(_combine(centres[1], -1, centres[0]), _combine(centres[2], -1, centres[0]))
        height = _dot(_combine(self.pose, -1, centres[0]), normal) / _dot(normal, normal)
        mirrored = _combine(self.pose, -2 * height, normal)
        candidates = [self.newton(start, exact) for start in (self.pose, mirrored)]
        for candidate in candidates:
            links = [_combine(candidate, -1, centre) for centre in centres]
            if _dot(links[0], _cross(links[1], links[2])) * mp.mpf(assembly) > 0:
                return np.array(candidate, dtype=object)
        raise ArithmeticError("both solutions have the same sign of det D_l")

    def reach_margin(self) -> np.ndarray:
        margins = []
        for j in range(3):
            n = self.q.direction[j]
            r = _combine(_combine(self.pose, 1, self.q.joint[j]), -1, self.q.origin[j])
            across = _cross(r, n)
            margins.append(self.q.link_length[j] - mp.sqrt(_dot(across, across) / _dot(n, n)))
        return np.array(margins, dtype=object)

    def constraint_jacobians(self) -> tuple[np.ndarray, np.ndarray]:
        """Differences of the closures by the platform centre, and by the carriages with opposite sign."""

        def by_platform(platform: Vector) -> np.ndarray:
            return np.array(self.closures(platform, self.x), dtype=object)

        def by_carriages(x: Vector) -> np.ndarray:
            return np.array(self.closures(self.pose, x), dtype=object)

        return self.columns(by_platform, self.pose), -self.columns(by_carriages, self.x)

    def jacobian_condition(self) -> tuple[Number, Number]:
        D_l = mp.matrix(self.constraint_jacobians()[0].tolist())
        return mp.det(D_l), mp.mnorm(D_l, "f") * mp.mnorm(mp.inverse(D_l), "f")

    def platform_jacobian(self) -> np.ndarray:
        return self.platform_columns(self.x)

    def platform_jacobian_rate(self, x_dot: Any) -> np.ndarray:
        return self.slope(self.platform_columns, self.x, _exact(x_dot))

    def platform_second_derivatives(self) -> np.ndarray:
        return self.columns(self.platform_columns, self.x)

    def link_jacobians(self) -> tuple[np.ndarray, np.ndarray]:
        """Velocity of each rod's middle, and s x s_dot / l^2 of the rod vector s, for unit carriage rates."""

        def middles(x: Vector) -> np.ndarray:
            at = self.points(x)
            return (np.array(at.carriages, dtype=object) + np.array(at.joints, dtype=object)) / 2

        def rods(x: Vector) -> np.ndarray:
            at = self.points(x)
            return np.array(at.joints, dtype=object) - np.array(at.carriages, dtype=object)

        s, s_dot = rods(self.x), self.columns(rods, self.x)
        D_omega = np.empty((3, 3, 3), dtype=object)
        for j in range(3):
            for k in range(3):
                turn = _cross(list(s[j]), list(s_dot[j, :, k]))
                D_omega[j, :, k] = [component / self.q.link_length[j] ** 2 for component in turn]
        return self.columns(middles, self.x), D_omega

    # Energies

    def structure_energy(self, x: Vector, x_dot: Vector) -> Number:
        """Kinetic energy of platform, carriages and rods, from differences of positions along the motion.

        The platform only translates, so both rods of a linkage and the line between them move alike.
        """
        ahead, behind = self.points(_combine(x, STEP, x_dot)), self.points(_combine(x, -STEP, x_dot))

        def velocity(a: Vector, b: Vector) -> Vector:
            return [(u - v) / (2 * STEP) for u, v in zip(a, b, strict=True)]

        platform = velocity(ahead.platform, behind.platform)
        twice = self.q.platform_mass * _dot(platform, platform)
        for j in range(3):
            carriage = velocity(ahead.carriages[j], behind.carriages[j])
            joint = velocity(ahead.joints[j], behind.joints[j])
            twice += self.q.carriage_mass[j] * _dot(carriage, carriage)
            for fraction, weight in zip(ROD_FRACTIONS, ROD_WEIGHTS, strict=True):
                element = _combine(carriage, fraction, _combine(joint, -1, carriage))
                twice += self.q.link_mass[j] * weight * _dot(element, element)
        return twice / 2

    def transmission_energy(self, theta_dot: Vector) -> Number:
        """Two pulleys for each axis; the motor turns gear_ratio times as fast as the pulley that it drives."""
        twice = mp.mpf(0)
        for j in range(3):
            for k in range(2):
                rate = theta_dot[3 * k + j]
                motor_rate = self.q.gear_ratio[j] * rate
                twice += self.q.pulley_inertia[j] * rate**2
                if self.q.drive[j][k] == 1:
                    twice += self.q.motor_inertia[j] * motor_rate**2
        return twice / 2

    def kinetic_energy(self, q_dot: Any) -> tuple[Number, Number]:
        rates = _exact(q_dot)
        return self.structure_energy(self.x, rates[:3]), self.transmission_energy(rates[3:])

    def mass_matrix(self) -> np.ndarray:
        """Polarisation: T(a + b) - T(a) - T(b) for unit velocities a and b."""

        def energy(q_dot: Vector) -> Number:
            return self.structure_energy(self.x, q_dot[:3]) + self.transmission_energy(q_dot[3:])

        units = [_unit(k, 9) for k in range(9)]
        single = [energy(unit) for unit in units]
        M = np.empty((9, 9), dtype=object)
        for k in range(9):
            for m in range(k, 9):
                M[k, m] = energy(_combine(units[k], 1, units[m])) - single[k] - single[m]
                M[m, k] = M[k, m]
        return M

    def velocity_forces(self, x_dot: Any) -> np.ndarray:
        """Left side of Lagrange's equations, d/dt dT/dx_dot - dT/dx, for carriages that do not accelerate."""
        rates: Vector = _exact(x_dot)
        forces = []
        for k in range(3):
            unit = _unit(k, 3)
            faster, slower = _combine(rates, 1, unit), _combine(rates, -1, unit)

            def momentum(x: Vector, faster: Vector = faster, slower: Vector = slower) -> Number:
                # T is quadratic in the rates, so that this difference with a unit step has no truncation
                return (self.structure_energy(x, faster) - self.structure_energy(x, slower)) / 2

            rise = self.slope(lambda x: self.structure_energy(x, rates), self.x, unit)
            forces.append(self.slope(momentum, self.x, rates) - rise)
        return np.array(forces, dtype=object)

    def weight_energy(self, x: Vector) -> Number:
        """Potential energy -g . (m r) of every part that has mass."""
        at = self.points(x)
        moment = [self.q.platform_mass * component for component in at.platform]
        for j in range(3):
            middle = _combine(at.carriages[j], mp.mpf(1) / 2, _combine(at.joints[j], -1, at.carriages[j]))
            moment = _combine(moment, self.q.link_mass[j], middle)
            moment = _combine(moment, self.q.carriage_mass[j], at.carriages[j])
        return -_dot(self.q.gravity, moment)

    def weight_gradient(self, x: Vector) -> np.ndarray:
        return self.columns(self.weight_energy, x)

    def gravity_potential(self) -> Number:
        return self.weight_energy(self.x)

    def gravity_gradient(self) -> np.ndarray:
        return self.weight_gradient(self.x)

    def gravity_hessian(self) -> np.ndarray:
        return self.columns(self.weight_gradient, self.x)

    # Belts

    def belt_spans(self) -> np.ndarray:
        """Distances between the ends of each span: pulleys at the limits, carriage ends at x -/+ l_t / 2."""
        spans = []
        for j in range(3):
            pulley_2, pulley_1 = self.q.limits[j]
            low = self.x[j] - self.q.carriage_length[j] / 2
            high = self.x[j] + self.q.carriage_length[j] / 2
            spans.append([pulley_1 - pulley_2, low - pulley_2, pulley_1 - high])
        return np.array(spans, dtype=object)

    def belt_stiffness(self) -> np.ndarray:
        spans = self.belt_spans()
        for j in range(3):
            spans[j] = self.q.belt_width[j] * self.q.belt_specific_stiffness[j] / spans[j]
        return spans

    def strain_energy(self, delta_q: Vector) -> Number:
        k = self.belt_stiffness()
        twice = mp.mpf(0)
        for j in range(3):
            x, theta_1, theta_2 = delta_q[j], delta_q[3 + j], delta_q[6 + j]
            R = self.q.pulley_radius[j]
            for stiffness, elongation in zip(
                k[j], (R * (theta_2 - theta_1), x - R * theta_2, R * theta_1 - x), strict=True
            ):
                twice += stiffness * elongation**2
        return twice / 2

    def strain_gradient(self, delta_q: Vector) -> Vector:
        """Differences with a unit step, which is exact: the energy is quadratic."""
        units = [_unit(k, 9) for k in range(9)]
        return [
            (self.strain_energy(_combine(delta_q, 1, u)) - self.strain_energy(_combine(delta_q, -1, u))) / 2
            for u in units
        ]

    def elastic_potential(self, delta_q: Any) -> Number:
        return self.strain_energy(_exact(delta_q))

    def elastic_gradient(self, delta_q: Any) -> np.ndarray:
        return np.array(self.strain_gradient(_exact(delta_q)), dtype=object)

    def elastic_hessian(self) -> np.ndarray:
        return np.array([self.strain_gradient(_unit(k, 9)) for k in range(9)], dtype=object)

    def stiffness_matrix(self) -> np.ndarray:
        K = self.elastic_hessian()
        K[:3, :3] += self.gravity_hessian()
        return K

    def modal_matrices(self) -> tuple[np.ndarray, np.ndarray]:
        return self.mass_matrix(), self.stiffness_matrix()

    def static_equilibrium(self) -> tuple[np.ndarray, np.ndarray]:
        """Nine force balances, linear in three torques and six rotations, with the carriages held at the pose."""
        weight = list(self.gravity_gradient()) + [mp.mpf(0)] * 6

        def imbalance(unknowns: Vector) -> Vector:
            torques, theta = unknowns[:3], unknowns[3:]
            force = _combine(self.strain_gradient([mp.mpf(0)] * 3 + theta), 1, weight)
            for j in range(3):
                for k in range(2):
                    force[3 + 3 * k + j] -= self.q.drive[j][k] * torques[j]
            return force

        rest = imbalance([mp.mpf(0)] * 9)
        responses = [_combine(imbalance(_unit(k, 9)), -1, rest) for k in range(9)]
        solution = mp.lu_solve(mp.matrix(responses).T, -mp.matrix(rest))
        return np.array(solution[:3], dtype=object), np.array(solution[3:], dtype=object)
