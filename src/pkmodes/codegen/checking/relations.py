"""Relations between generated functions that hold for every mechanism whose module has these functions.

Everything is differentiated with respect to the independent coordinates.  If the module has the direct kinematics,
the pose is computed from it, never from a Jacobian; otherwise derivatives with respect to the pose are multiplied by
the inverse of the derivatives of the inverse kinematics.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from itertools import product as every
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
#: A name, a generated value, the value by other means, and the smallest scale of the error: the size of terms that
#: may cancel, so that a quantity that vanishes by symmetry is not required to have digits that it cannot have.
Relation = tuple[str, Array, Array, float]

SEED = 20220102
#: Step of differences relative to the distance over which the platform Jacobian changes.
STEP = 5e-5


class State:
    """A robot at a pose, with numerical derivatives there.

    - generated: the functions under test
    - parameters: the robot's parameters
    - pose: (d,)
    - derivative: differentiates a function of an array at an array with a step; the last axis of the result is that
      of the derivative
    - effects: whether the model has effects; some relations of the base model do not hold with effects

    Its attributes:
    - places: indices of the independent coordinates, length k
    - base: number of coordinates without effects
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
        self.places, self.base = [names.index(name) for name in mechanism.independent], len(names)
        self.positions: Array = generated.inverse_kinematics(pose)

    @cached_property
    def travel(self) -> float:
        """Smallest travel of an independent coordinate; without limits 1, or the size of the robot if smaller."""
        without = min(1.0, reach_bound(self.mechanism, self.parameters))
        ends = travel_limits(self.mechanism, self.parameters)
        return float(np.ptp(ends, axis=-1).min()) if len(ends) else without

    @cached_property
    def step(self) -> float:
        """Step in the independent coordinates, small relative to their travel and to the curvature of the motion."""
        size = self.travel
        if self.generated.has("platform_second_derivatives"):
            bend = float(np.abs(self.generated.platform_second_derivatives(self.pose)).max())
            straight = float(np.abs(self.generated.platform_jacobian(self.pose)).max())
            if bend > 0.0 and np.isfinite(bend):
                size = min(size, straight / bend)
        return STEP * size

    def rate(self, function: Callable[[Array], Any]) -> Array:
        """Differentiate a function of the pose numerically with respect to the independent coordinates."""
        if self.generated.has("direct_kinematics"):
            return self.derivative(lambda q: function(self.assembled(q)), self.positions, self.step)
        return self.derivative(function, self.pose, self.step) @ self.motion

    def assembled(self, positions: Array) -> Array:
        """Compute the pose from the independent coordinates, on the assembly branch of this pose."""
        determinant, _ = self.generated.jacobian_condition(self.pose)
        pose: Array = self.generated.direct_kinematics(positions, np.sign(determinant))
        return pose

    @cached_property
    def motion(self) -> Array:
        """Numerical derivative of the pose with respect to the independent coordinates, (d, k)."""
        if self.generated.has("direct_kinematics"):
            return self.derivative(self.assembled, self.positions, self.step)
        return np.asarray(
            np.linalg.inv(self.derivative(self.generated.inverse_kinematics, self.pose, self.step))
        )

    @cached_property
    def turning(self) -> Array:
        """How the platform moves per change of the pose, (d, d): rotations about base axes per rotation vector."""
        mechanism = self.mechanism
        turning, first = np.eye(len(self.pose)), len(mechanism.directions)
        if mechanism.rotations:
            axes = [AXES.index(axis) for axis in mechanism.rotations]
            turning[first:, first:] = left_jacobian(vectors_about(mechanism.rotations, self.pose[first:]))[
                np.ix_(axes, axes)
            ]
        return turning

    def unstrained(self, pose: Array) -> Array:
        """Return the motion of all coordinates with the independent ones in unstrained motion, (n, k)."""
        dependent = [i for i in range(self.base) if i not in self.places]
        H = Generated(self.mechanism.model, self.parameters).elastic_hessian(pose)
        motion = np.zeros((self.generated.coordinates, len(self.places)), dtype=H.dtype)
        motion[self.places] = np.eye(len(self.places))
        motion[dependent] = -np.linalg.solve(
            H[np.ix_(dependent, dependent)], H[np.ix_(dependent, self.places)]
        )
        return motion


def relations(at: State) -> Iterator[Relation]:
    """Yield every relation at one pose."""
    for group in (_closures, _motion, _gravity, _elastic, _matrices, _inertia, _statics):
        yield from group(at)


def _closures(at: State) -> Iterator[Relation]:
    g, p = at.generated, at.pose
    if not g.has("constraint_jacobians"):
        return
    D_l, D_r = g.constraint_jacobians(p)
    length = float(np.abs(D_l).max())
    if g.has("direct_kinematics"):
        yield "direct of inverse kinematics", at.assembled(at.positions), p, length
    if g.has("jacobian_condition"):
        determinant, condition = g.jacobian_condition(p)
        yield "determinant", determinant, np.linalg.det(D_l), length ** len(D_l)
        alike = D_l / lengths_of(at.mechanism, at.parameters)
        frobenius = np.asarray(np.linalg.norm(alike) * np.linalg.norm(np.linalg.inv(alike)))
        yield "condition", condition, frobenius, 0.0
    yield "constraint Jacobians", D_l @ g.platform_jacobian(p), D_r, length


def _motion(at: State) -> Iterator[Relation]:
    g, p = at.generated, at.pose
    yield "platform Jacobian", g.platform_jacobian(p), at.turning @ at.motion, 0.0
    if g.has("platform_second_derivatives"):
        P, bend = g.platform_second_derivatives(p), at.rate(g.platform_jacobian)
        rates, size = _velocities(at), float(np.abs(P).max())
        if at.mechanism.rotations:
            # In the exponential chart at the pose, of which angular velocities have the symmetric part.
            yield "platform second derivatives", P, 0.5 * (bend + np.swapaxes(bend, -1, -2)), 0.0
        else:
            yield "platform second derivatives", P, bend, 0.0
            bend = P
        if g.has("platform_jacobian_rate"):
            yield "platform Jacobian rate", g.platform_jacobian_rate(p, rates), bend @ rates, size


def _gravity(at: State) -> Iterator[Relation]:
    g, p = at.generated, at.pose
    if not g.has("gravity_potential", "gravity_gradient", "gravity_hessian"):
        return
    gradient = g.gravity_gradient(p)
    weight = float(np.abs(gradient).max())
    bend = float(np.abs(at.rate(g.platform_jacobian)).max())
    yield "gravity gradient", gradient, at.rate(g.gravity_potential), weight
    yield "gravity Hessian", g.gravity_hessian(p), at.rate(g.gravity_gradient), weight * bend


def _elastic(at: State) -> Iterator[Relation]:
    g, p, derivative = at.generated, at.pose, at.derivative
    if not g.has("elastic_potential", "elastic_gradient", "elastic_hessian"):
        return
    moved = 1e-3 * np.random.default_rng(SEED).normal(size=g.coordinates)
    pull = derivative(lambda d: g.elastic_potential(p, d), moved, at.step)
    yield "elastic gradient", g.elastic_gradient(p, moved), pull, 0.0
    bend = derivative(lambda d: g.elastic_gradient(p, d), moved, at.step)
    yield "elastic Hessian", g.elastic_hessian(p), bend, 0.0


def _matrices(at: State) -> Iterator[Relation]:
    g, p = at.generated, at.pose
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
            whole = g.elastic_hessian(p)[: at.base, : at.base].copy()
            whole[np.ix_(at.places, at.places)] += g.gravity_hessian(p)
            yield "stiffness matrix", stiffness[: at.base, : at.base], whole, 0.0


def _inertia(at: State) -> Iterator[Relation]:
    """Yield the inertia forces: the inertia that effects add to the drives changes as the robot moves."""
    g, p = at.generated, at.pose
    if not g.has("velocity_forces", "mass_matrix") or not hasattr(at.mechanism.model, "elastic_hessian"):
        return

    def reduced(pose: Array) -> Array:
        follow = at.unstrained(pose)
        return np.asarray(follow.T @ g.mass_matrix(pose) @ follow)

    dM, rates = at.rate(reduced), _velocities(at)
    forces = (dM @ rates) @ rates - 0.5 * np.einsum("klm,k,l->m", dM, rates, rates)
    # A constant inertia leaves only rounding, of the size of the inertia divided by the travel.
    weight = max(float(np.abs(dM).max()), float(np.abs(reduced(p)).max()) / at.travel)
    yield "velocity forces", g.velocity_forces(p, rates), forces, weight


def _statics(at: State) -> Iterator[Relation]:
    g, p = at.generated, at.pose
    # Springs of effects are relaxed at the pose, so the gradient of all springs is not the torque.
    if at.effects or not g.has("static_equilibrium", "elastic_gradient", "gravity_gradient"):
        return
    torques, values = g.static_equilibrium(p)
    dependent = [i for i in range(at.base) if i not in at.places]
    displaced = np.zeros(at.base)
    displaced[dependent] = values
    carried, gradient = g.elastic_gradient(p, displaced), g.gravity_gradient(p)
    yield "static equilibrium", carried[at.places], -gradient, float(np.abs(gradient).max())
    # Only the drives carry torques.
    size = float(np.abs(torques).max())
    order = np.argsort(-np.abs(carried[dependent]))
    driven, free = order[: len(torques)], order[len(torques) :]
    yield "static torques", np.sort(torques), np.sort(carried[dependent][driven]), size
    if len(free):
        yield "torques of the drives only", carried[dependent][free], np.zeros(len(free)), size


def _velocities(at: State) -> Array:
    """Return arbitrary velocities of the independent coordinates."""
    return np.random.default_rng(SEED).normal(size=len(at.places))


def _quadratic_form(energy: Callable[[Array], Any], n: int) -> Array:
    """Compute the matrix of a quadratic form by polarisation, which is exact up to rounding."""
    basis = np.eye(n)
    matrix = np.empty((n, n))
    for k, m in every(range(n), repeat=2):
        matrix[k, m] = (energy(basis[k] + basis[m]) - energy(basis[k] - basis[m])) / 2.0
    return matrix


def drawing_relations(at: State) -> Iterator[Relation]:
    """Yield the relations between a drawing and the model, at a pose of a robot without effects."""
    drawing = at.mechanism.drawing
    drawn = Generated(at.mechanism.drawn, at.parameters, at.mechanism.extended.Effects())
    # Any constant vectors will do for those that the robot leaves open.
    up = (np.tile([0.6, -0.48, 0.64], drawing.uprights),) if drawing.uprights else ()
    motion = drawn.drawing_motion(at.pose, *up)[list(drawing.motions)]
    moved = at.rate(lambda p: drawn.drawing_points(p, *up))
    yield "motion of drawn points", motion[..., at.places], moved, 0.0
    if at.generated.has("elastic_hessian"):
        stiffness, strain = drawn.springs(at.pose)
        strain = strain[:, : at.base]
        hessian = at.generated.elastic_hessian(at.pose)
        yield "springs", strain.T @ (stiffness[:, None] * strain), hessian, 0.0
