"""Relations between generated functions that hold for every mechanism whose module has these functions.

Everything is differentiated with respect to the independent coordinates.  If the module has the direct kinematics,
the pose is computed from it, never from a Jacobian; otherwise derivatives with respect to the pose are multiplied by
the inverse of the derivatives of the inverse kinematics.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.rotations import AXES, left_jacobian, vectors_about
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.length import lengths_of
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import reach_bound, travel_limits

Array = NDArray[np.float64]
Derivative = Callable[[Callable[[Array], Array], Array, float], Array]
#: A name, a generated value, the same value computed otherwise, and the minimum scale of the error: the size of terms
#: that may cancel, so that a quantity that vanishes by symmetry is not compared to more digits than it can have.
Relation = tuple[str, Array, Array, float]

SEED = 20220102
#: Step of differences relative to the distance over which the platform Jacobian changes.
RELATIVE_STEP = 5e-5


class State:
    """A robot at a pose, with numerical derivatives there.

    - generated: the functions under test
    - parameters: the robot's parameters
    - pose: (d,)
    - derivative: differentiates a function of an array at an array with a step; the last axis of the result is that
      of the derivative
    - effects: whether the model has effects; some relations of the base model do not hold with effects

    Its attributes:
    - independent: indices of the independent coordinates, length k
    - base_count: number of coordinates without effects
    - positions: independent coordinates at the pose, (k,)
    """

    def __init__(
        self,
        generated: Generated,
        mechanism: Mechanism,
        parameters: Any,
        pose: Array,
        derivative: Derivative,
        effects: bool,
    ) -> None:
        self.generated, self.mechanism, self.parameters = generated, mechanism, parameters
        self.pose, self.derivative, self.effects = pose, derivative, effects
        names = [q.name for q in mechanism.coordinates]
        self.independent, self.base_count = [names.index(name) for name in mechanism.independent], len(names)
        self.positions: Array = generated.inverse_kinematics(pose)

    @cached_property
    def travel(self) -> float:
        """Smallest travel of an independent coordinate; without limits 1, or the size of the robot if smaller."""
        default = min(1.0, reach_bound(self.mechanism, self.parameters))
        limits = travel_limits(self.mechanism, self.parameters)
        return float(np.ptp(limits, axis=-1).min()) if len(limits) else default

    @cached_property
    def step(self) -> float:
        """Step in the independent coordinates, small relative to their travel and to the curvature of the motion."""
        distance = self.travel
        if self.generated.has("platform_second_derivatives"):
            curvature = float(np.abs(self.generated.platform_second_derivatives(self.pose)).max())
            slope = float(np.abs(self.generated.platform_jacobian(self.pose)).max())
            if curvature > 0.0 and np.isfinite(curvature):
                distance = min(distance, slope / curvature)
        return RELATIVE_STEP * distance

    def differentiate(self, function: Callable[[Array], Any]) -> Array:
        """Differentiate a function of the pose numerically with respect to the independent coordinates."""
        if self.generated.has("direct_kinematics"):
            return self.derivative(lambda q: function(self.direct_pose(q)), self.positions, self.step)
        return self.derivative(function, self.pose, self.step) @ self.pose_derivative

    def direct_pose(self, positions: Array) -> Array:
        """Compute the pose from the independent coordinates, on the assembly branch of this pose."""
        determinant, _ = self.generated.jacobian_condition(self.pose)
        pose: Array = self.generated.direct_kinematics(positions, np.sign(determinant))
        return pose

    @cached_property
    def pose_derivative(self) -> Array:
        """Numerical derivative of the pose with respect to the independent coordinates, (d, k)."""
        if self.generated.has("direct_kinematics"):
            return self.derivative(self.direct_pose, self.positions, self.step)
        return np.asarray(
            np.linalg.inv(self.derivative(self.generated.inverse_kinematics, self.pose, self.step))
        )

    @cached_property
    def rotation_rates(self) -> Array:
        """Motion of the platform per change of the pose, (d, d): rotations about base axes per rotation vector."""
        mechanism = self.mechanism
        rates, first = np.eye(len(self.pose)), len(mechanism.directions)
        if mechanism.rotations:
            axes = [AXES.index(axis) for axis in mechanism.rotations]
            rates[first:, first:] = left_jacobian(vectors_about(mechanism.rotations, self.pose[first:]))[
                np.ix_(axes, axes)
            ]
        return rates

    def unstrained_motion(self, pose: Array) -> Array:
        """Return the motion of all coordinates with the independent ones in unstrained motion, (n, k)."""
        dependent = [i for i in range(self.base_count) if i not in self.independent]
        H = Generated(self.mechanism.model, self.parameters).elastic_hessian(pose)
        motion = np.zeros((self.generated.coordinates, len(self.independent)), dtype=H.dtype)
        motion[self.independent] = np.eye(len(self.independent))
        motion[dependent] = -np.linalg.solve(
            H[np.ix_(dependent, dependent)], H[np.ix_(dependent, self.independent)]
        )
        return motion


def relations(state: State) -> Iterator[Relation]:
    """Yield every relation at one pose."""
    for group in (_closures, _motion, _gravity, _elastic, _matrices, _inertia, _statics):
        yield from group(state)


def _closures(state: State) -> Iterator[Relation]:
    g, p = state.generated, state.pose
    if not g.has("constraint_jacobians"):
        return
    D_l, D_r = g.constraint_jacobians(p)
    length = float(np.abs(D_l).max())
    if g.has("direct_kinematics"):
        yield "direct of inverse kinematics", state.direct_pose(state.positions), p, length
    if g.has("jacobian_condition"):
        determinant, condition = g.jacobian_condition(p)
        yield "determinant", determinant, np.linalg.det(D_l), length ** len(D_l)
        scaled = D_l / lengths_of(state.mechanism, state.parameters)
        frobenius = np.asarray(np.linalg.norm(scaled) * np.linalg.norm(np.linalg.inv(scaled)))
        yield "condition", condition, frobenius, 0.0
    yield "constraint Jacobians", D_l @ g.platform_jacobian(p), D_r, length


def _motion(state: State) -> Iterator[Relation]:
    g, p = state.generated, state.pose
    yield "platform Jacobian", g.platform_jacobian(p), state.rotation_rates @ state.pose_derivative, 0.0
    if g.has("platform_second_derivatives"):
        P, curvature = g.platform_second_derivatives(p), state.differentiate(g.platform_jacobian)
        rates, size = _velocities(state), float(np.abs(P).max())
        if state.mechanism.rotations:
            # In the exponential chart at the pose, of which angular velocities have the symmetric part.
            yield "platform second derivatives", P, 0.5 * (curvature + np.swapaxes(curvature, -1, -2)), 0.0
        else:
            yield "platform second derivatives", P, curvature, 0.0
            curvature = P
        if g.has("platform_jacobian_rate"):
            yield "platform Jacobian rate", g.platform_jacobian_rate(p, rates), curvature @ rates, size


def _gravity(state: State) -> Iterator[Relation]:
    g, p = state.generated, state.pose
    if not g.has("gravity_potential", "gravity_gradient", "gravity_hessian"):
        return
    gradient = g.gravity_gradient(p)
    weight = float(np.abs(gradient).max())
    curvature = float(np.abs(state.differentiate(g.platform_jacobian)).max())
    yield "gravity gradient", gradient, state.differentiate(g.gravity_potential), weight
    yield "gravity Hessian", g.gravity_hessian(p), state.differentiate(g.gravity_gradient), weight * curvature


def _elastic(state: State) -> Iterator[Relation]:
    g, p, derivative = state.generated, state.pose, state.derivative
    if not g.has("elastic_potential", "elastic_gradient", "elastic_hessian"):
        return
    displacement = 1e-3 * np.random.default_rng(SEED).normal(size=g.coordinates)
    gradient = derivative(lambda d: g.elastic_potential(p, d), displacement, state.step)
    yield "elastic gradient", g.elastic_gradient(p, displacement), gradient, 0.0
    hessian = derivative(lambda d: g.elastic_gradient(p, d), displacement, state.step)
    yield "elastic Hessian", g.elastic_hessian(p), hessian, 0.0


def _matrices(state: State) -> Iterator[Relation]:
    g, p = state.generated, state.pose
    M, K = g.modal_matrices(p)
    if g.has("mass_matrix"):
        yield "modal mass matrix", M, g.mass_matrix(p), 0.0
    if g.has("kinetic_energy"):
        energy = lambda rate: np.sum(g.kinetic_energy(p, rate))  # noqa: E731 - in parts, or in one
        yield "mass matrix", M, _quadratic_form(energy, g.coordinates), 0.0
    if g.has("stiffness_matrix"):
        stiffness = g.stiffness_matrix(p)
        yield "modal stiffness matrix", K, stiffness, 0.0
        if g.has("elastic_hessian", "gravity_hessian"):
            # Gravity also acts on the coordinates of effects, which are not part of its Hessian.
            total = g.elastic_hessian(p)[: state.base_count, : state.base_count].copy()
            total[np.ix_(state.independent, state.independent)] += g.gravity_hessian(p)
            yield "stiffness matrix", stiffness[: state.base_count, : state.base_count], total, 0.0


def _inertia(state: State) -> Iterator[Relation]:
    """Yield the inertia forces: the inertia that effects add to the drives changes as the robot moves."""
    g, p = state.generated, state.pose
    if not g.has("velocity_forces", "mass_matrix") or not hasattr(state.mechanism.model, "elastic_hessian"):
        return

    def reduced_inertia(pose: Array) -> Array:
        motion = state.unstrained_motion(pose)
        return np.asarray(motion.T @ g.mass_matrix(pose) @ motion)

    dM, rates = state.differentiate(reduced_inertia), _velocities(state)
    forces = (dM @ rates) @ rates - 0.5 * np.einsum("klm,k,l->m", dM, rates, rates)
    # A constant inertia leaves only rounding, of the size of the inertia divided by the travel.
    weight = max(float(np.abs(dM).max()), float(np.abs(reduced_inertia(p)).max()) / state.travel)
    yield "velocity forces", g.velocity_forces(p, rates), forces, weight


def _statics(state: State) -> Iterator[Relation]:
    g, p = state.generated, state.pose
    # Springs of effects are relaxed at the pose, so the gradient of all springs is not the torque.
    if state.effects or not g.has("static_equilibrium", "elastic_gradient", "gravity_gradient"):
        return
    torques, values = g.static_equilibrium(p)
    dependent = [i for i in range(state.base_count) if i not in state.independent]
    displacement = np.zeros(state.base_count)
    displacement[dependent] = values
    spring_forces, gradient = g.elastic_gradient(p, displacement), g.gravity_gradient(p)
    yield "static equilibrium", spring_forces[state.independent], -gradient, float(np.abs(gradient).max())
    # Only the drives carry torques.
    largest = float(np.abs(torques).max())
    order = np.argsort(-np.abs(spring_forces[dependent]))
    driven, free = order[: len(torques)], order[len(torques) :]
    yield "static torques", np.sort(torques), np.sort(spring_forces[dependent][driven]), largest
    if len(free):
        yield "torques of the drives only", spring_forces[dependent][free], np.zeros(len(free)), largest


def _velocities(state: State) -> Array:
    """Return arbitrary velocities of the independent coordinates."""
    return np.random.default_rng(SEED).normal(size=len(state.independent))


def _quadratic_form(energy: Callable[[Array], Any], n: int) -> Array:
    """Compute the matrix of a quadratic form by polarisation, which is exact up to rounding."""
    basis = np.eye(n)
    matrix = np.empty((n, n))
    for k, m in product(range(n), repeat=2):
        matrix[k, m] = (energy(basis[k] + basis[m]) - energy(basis[k] - basis[m])) / 2.0
    return matrix


def drawing_relations(state: State) -> Iterator[Relation]:
    """Yield the relations between a drawing and the model, at a pose of a robot without effects."""
    drawing = state.mechanism.drawing
    drawn = Generated(state.mechanism.drawn, state.parameters, state.mechanism.extended.Effects())
    # Arbitrary constant vectors for the directions that do not follow from the robot.
    upright_vectors = (np.tile([0.6, -0.48, 0.64], drawing.uprights),) if drawing.uprights else ()
    motion = drawn.drawing_motion(state.pose, *upright_vectors)[list(drawing.motions)]
    rates = state.differentiate(lambda p: drawn.drawing_points(p, *upright_vectors))
    yield "motion of drawn points", motion[..., state.independent], rates, 0.0
    if state.generated.has("elastic_hessian"):
        stiffness, strain = drawn.springs(state.pose)
        strain = strain[:, : state.base_count]
        hessian = state.generated.elastic_hessian(state.pose)
        yield "springs", strain.T @ (stiffness[:, None] * strain), hessian, 0.0
