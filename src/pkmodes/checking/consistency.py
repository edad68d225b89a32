"""Consistency of generated code: every derivative against differences of the function that it derives.

The lowest link of the chain is the direct kinematics, which is checked by the closures themselves: the
inverse kinematics of its result must give the carriages back.  Differences are taken twice: by complex step,
which has no cancellation and so a bound near rounding, and centrally, which needs no analytic function.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import product as cartesian
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes_generated.linear_delta import Parameters

Array = NDArray[np.float64]
Derivative = Callable[[Callable[[Array], Array], Array, float], Array]

#: Complex step: rounding only, some 1e-14 for each unit of the condition number of D_l.
COMPLEX_STEP_BOUND = 1e-10
#: Central differences of fourth order with a step of 5e-5 link lengths: truncation grows with the fifth
#: derivative, that is with the condition number; measured at most 4e-7 over some hundred robots.
CENTRAL_BOUND, STEP = 1e-5, 5e-5
#: Frobenius condition number of D_l at the poses where the check is made.
MAX_CONDITION = 15.0
SEED = 20220101


@dataclass(frozen=True)
class Check:
    """Result of one check: the largest error relative to the size of the quantity, and whether it holds."""

    name: str
    error: float
    bound: float

    @property
    def holds(self) -> bool:
        """Whether the error is within the bound; NaN is not."""
        return bool(self.error <= self.bound)


class Generated:
    """The functions of a generated module, with the robot's parameters supplied where it takes them."""

    def __init__(self, module: Any, parameters: Parameters | None = None) -> None:
        self._module, self._arguments = module, () if parameters is None else (parameters,)

    @property
    def coordinates(self) -> int:
        """How many generalised coordinates it has."""
        return len(self._module.COORDINATES)

    def __getattr__(self, name: str) -> Callable[..., Any]:
        function = getattr(self._module, name)
        return lambda *arguments: function(*arguments, *self._arguments)


def check_consistency(generated: Generated, parameters: Parameters, effects: bool = False) -> list[Check]:
    """Check the derivatives of a generated model at a few of its poses.

    Parameters
    ----------
    generated : Generated
        The functions.
    parameters : Parameters
        The robot that they are for: it says where poses may be found.
    effects : bool
        Whether the model has effects, which make some relations of the base model untrue.

    Returns
    -------
    list of Check
        One for each relation and kind of difference; a single failed one when no regular pose is found.
    """
    poses = regular_poses(generated, parameters)
    if not len(poses):
        return [Check("a regular pose within the limits", np.inf, 0.0)]
    step = STEP * float(np.min(parameters.link_length))
    checks = []
    kinds: tuple[tuple[str, Derivative, float], ...] = (
        ("complex step", _complex_step, COMPLEX_STEP_BOUND),
        ("central differences", _central_differences, CENTRAL_BOUND),
    )
    with np.errstate(all="ignore"):  # a broken function may give NaN: it fails the check, it does not warn
        for kind, derivative, bound in kinds:
            errors: dict[str, float] = {}
            for p in poses:
                for name, found, expected, weight in _relations(
                    generated, parameters, p, derivative, step, effects
                ):
                    scale = max(float(np.max(np.abs(expected))), weight)
                    error = float(np.max(np.abs(found - expected))) / scale if scale > 0.0 else 0.0
                    errors[name] = max(errors.get(name, 0.0), error if np.isfinite(error) else np.inf)
            checks += [Check(f"{name} ({kind})", error, bound) for name, error in errors.items()]
    return checks


def regular_poses(generated: Generated, parameters: Parameters, wanted: int = 4) -> Array:
    """Find poses well inside the workspace, in the box around the rails that the links can reach."""
    rng = np.random.default_rng(SEED)
    ends = parameters.origin[:, None, :] + parameters.limits[:, :, None] * parameters.direction[:, None, :]
    reach = float(np.max(parameters.link_length) + np.abs(parameters.joint).max())
    low, high = ends.min(axis=(0, 1)) - reach, ends.max(axis=(0, 1)) + reach
    travel = float((parameters.limits[:, 1] - parameters.limits[:, 0]).min())
    found: list[Array] = []
    with np.errstate(all="ignore"):
        for _ in range(20):  # a narrow workspace in a large box takes more than one draw
            p = rng.uniform(low, high, size=(20_000, 3))
            _, condition = generated.jacobian_condition(p)
            good = condition < MAX_CONDITION
            good &= (generated.belt_spans(p) > 0.02 * travel).all(axis=(-1, -2))
            good &= (generated.reach_margin(p) > 0.02 * parameters.link_length).all(axis=-1)
            found.append(p[good])
            if sum(map(len, found)) >= wanted:
                break
    return np.concatenate(found)[:wanted]


def _complex_step(function: Callable[[Array], Array], at: Array, step: float) -> Array:
    """Derivatives by complex step; the derivative's index is the last one of the result."""
    h = 1e-30
    columns = [np.imag(function(at + 1j * h * e)) / h for e in np.eye(len(at))]
    return np.stack(columns, axis=-1)


def _central_differences(function: Callable[[Array], Array], at: Array, step: float) -> Array:
    """Central differences of fourth order; the derivative's index is the last one of the result."""
    columns = []
    for e in step * np.eye(len(at)):
        near = function(at + e) - function(at - e)
        far = function(at + 2 * e) - function(at - 2 * e)
        columns.append((8.0 * near - far) / (12.0 * step))
    return np.stack(columns, axis=-1)


def _relations(
    g: Generated, parameters: Parameters, p: Array, derivative: Derivative, step: float, effects: bool
) -> Iterator[tuple[str, Array, Array, float]]:
    """Yield (name, generated value, value by other means, least scale) at one pose.

    The least scale is the size of the terms that may cancel in a value, so that a quantity that vanishes by
    symmetry is not held to digits that it does not have.
    """
    x = g.inverse_kinematics(p)
    determinant, condition = g.jacobian_condition(p)
    branch = np.sign(determinant)

    def pose(carriages: Array) -> Array:
        position: Array = g.direct_kinematics(carriages, branch)
        return position

    rng = np.random.default_rng(SEED + 1)
    n = g.coordinates
    x_dot, delta_q = rng.normal(size=3), 1e-3 * rng.normal(size=n)
    D_p, P = g.platform_jacobian(p), g.platform_second_derivatives(p)
    D_l, D_r = g.constraint_jacobians(p)
    spans, k = g.belt_spans(p), g.belt_stiffness(p)
    length = float(np.abs(D_l).max())

    yield "direct of inverse kinematics", pose(x), p, length
    yield "determinant", determinant, np.linalg.det(D_l), length**3
    frobenius = np.asarray(np.linalg.norm(D_l) * np.linalg.norm(np.linalg.inv(D_l)))
    yield "condition", condition, frobenius, 0.0
    yield "constraint Jacobians", D_l @ D_p, D_r, length
    yield "platform Jacobian", D_p, derivative(pose, x, step), 0.0
    yield "platform second derivatives", P, derivative(lambda c: g.platform_jacobian(pose(c)), x, step), 0.0
    yield "platform Jacobian rate", g.platform_jacobian_rate(p, x_dot), P @ x_dot, float(np.abs(P).max())
    moved = derivative(lambda c: g.belt_spans(pose(c)), x, step)
    yield "belt spans", moved, np.eye(3)[:, None, :] * np.array([0.0, 1.0, -1.0])[None, :, None], 1.0
    if effects:  # what a span has in series does not grow with its length
        (short, middle, long), (a, b, c) = np.sort(spans, axis=1).T, -np.sort(-k, axis=1).T
        yield "belt stiffness", (1 / b - 1 / a) * (long - short), (1 / c - 1 / a) * (middle - short), 0.0
    else:
        yield "belt stiffness", k * spans, np.repeat((k * spans)[:, :1], 3, axis=1), 0.0
        # Both spans of a carriage pull at it.
        yield "belt stiffness at the carriages", k[:, 1] + k[:, 2], np.diag(g.elastic_hessian(p))[:3], 0.0
    # A link, its distance from the rail and its component along the rail: Pythagoras.
    links = np.linalg.norm(D_l, axis=1)
    yield "reach margin", (links - g.reach_margin(p)) ** 2, links**2 - np.diag(D_r) ** 2, length**2

    gradient, hessian = g.gravity_gradient(p), g.gravity_hessian(p)
    weight = float(np.abs(gradient).max())
    yield "gravity gradient", gradient, derivative(lambda c: g.gravity_potential(pose(c)), x, step), weight
    curvature = derivative(lambda c: g.gravity_gradient(pose(c)), x, step)
    yield "gravity Hessian", hessian, curvature, weight * float(np.abs(P).max())
    elastic = g.elastic_hessian(p)
    pull = derivative(lambda d: g.elastic_potential(p, d), delta_q, step)
    yield "elastic gradient", g.elastic_gradient(p, delta_q), pull, 0.0
    yield "elastic Hessian", elastic, derivative(lambda d: g.elastic_gradient(p, d), delta_q, step), 0.0
    whole = elastic[:9, :9].copy()  # gravity acts on elongations too, of which its Hessian says nothing
    whole[:3, :3] += hessian
    M, K = g.modal_matrices(p)
    stiffness = g.stiffness_matrix(p)
    yield "stiffness matrix", stiffness[:9, :9], whole, 0.0
    yield "modal stiffness matrix", K, stiffness, 0.0
    yield "modal mass matrix", M, g.mass_matrix(p), 0.0
    yield "mass matrix", M, _quadratic_form(lambda rate: sum(g.kinetic_energy(p, rate)), n), 0.0
    # Pulleys turn with the carriages: what effects add to their inertia changes as those move.
    rigid = np.vstack([np.eye(3), *2 * [np.diag(1.0 / parameters.pulley_radius)], np.zeros((n - 9, 3))])
    dM = derivative(lambda c: rigid.T @ g.mass_matrix(pose(c)) @ rigid, x, step)
    forces = (dM @ x_dot) @ x_dot - 0.5 * np.einsum("klm,k,l->m", dM, x_dot, x_dot)
    yield "velocity forces", g.velocity_forces(p, x_dot), forces, float(np.abs(dM).max())
    yield "link Jacobians", *_platform_end(g, p), 1.0

    if (
        effects
    ):  # springs that they add are relaxed at the pose, so the gradient of all springs is not the torque
        return
    torques, rotations = g.static_equilibrium(p)
    strained = g.elastic_gradient(p, np.concatenate([np.zeros(3), rotations]))
    pulleys = strained[3:].reshape(2, 3)
    torque = float(np.abs(torques).max())
    yield "static equilibrium", strained[:3], -gradient, weight
    yield "static torques", torques, pulleys.sum(axis=0), torque
    # With the line before: of the two pulleys of an axis one carries the torque and the other none.
    yield "torque on one pulley only", np.abs(torques), np.abs(pulleys).max(axis=0), torque


def _quadratic_form(energy: Callable[[Array], Array], n: int) -> Array:
    """Matrix of a quadratic form by polarisation: exact but for rounding."""
    basis = np.eye(n)
    matrix = np.empty((n, n))
    for k, m in cartesian(range(n), repeat=2):
        matrix[k, m] = (energy(basis[k] + basis[m]) - energy(basis[k] - basis[m])) / 2.0
    return matrix


def _platform_end(g: Generated, p: Array) -> tuple[Array, Array]:
    """Velocity of each linkage's platform end, from its centre and rotation, and from the platform."""
    D_d, D_omega = g.link_jacobians(p)
    D_l, _ = g.constraint_jacobians(p)
    turning = np.cross(D_omega, 0.5 * D_l[:, :, None], axisa=1, axisb=1, axisc=1)
    return D_d + turning, np.broadcast_to(g.platform_jacobian(p), D_d.shape)


def oblique_robot() -> Parameters:
    """A robot without any symmetry: oblique rails, everything different on each axis, tilted gravity.

    Terms that vanish or cancel in a real robot do not do so in this one.
    """
    direction = np.array([[0.9, 0.2, 0.3], [-0.1, 0.8, 0.5], [0.3, -0.4, 0.9]])
    return Parameters(
        platform_mass=1.3,
        gravity=np.array([1.1, -2.3, -9.2]),
        origin=np.array([[-0.7, 0.1, 0.2], [0.1, -0.6, -0.1], [-0.2, 0.3, -0.8]]),
        direction=direction / np.linalg.norm(direction, axis=1, keepdims=True),
        joint=np.array([[0.03, -0.02, 0.01], [-0.04, 0.03, -0.02], [0.02, 0.01, 0.05]]),
        link_length=np.array([0.45, 0.5, 0.55]),
        link_mass=np.array([0.4, 0.5, 0.6]),
        carriage_mass=np.array([0.9, 1.0, 1.2]),
        carriage_length=np.array([0.05, 0.06, 0.07]),
        belt_specific_stiffness=np.array([2.2e6, 2.4e6, 2.6e6]),
        belt_width=np.array([0.015, 0.02, 0.025]),
        pulley_radius=np.array([0.03, 0.035, 0.04]),
        pulley_inertia=np.array([1.1e-4, 1.3e-4, 1.5e-4]),
        motor_inertia=np.array([1.5e-5, 1.7e-5, 1.9e-5]),
        gear_ratio=np.array([8.0, 10.0, 12.0]),
        drive=np.array([[1.0, 0.0], [0.0, 1.0], [0.0, 1.0]]),
        limits=np.array([[0.0, 1.4], [0.1, 1.5], [-0.1, 1.3]]),
        branch=np.array([-1.0, -1.0, -1.0]),
    )
