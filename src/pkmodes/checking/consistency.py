"""Finite-difference consistency of generated code: every derivative against the function that it derives.

The lowest link of the chain is the direct kinematics, which is checked by the closures themselves: the
inverse kinematics of its result must give the carriages back.  The differences are central, of fourth order;
the bounds leave room for their truncation and rounding and none for a wrong sign or a missing term.
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

#: Step of the differences: 1 mm of carriage travel, small against links and spans; the fourth-order
#: truncation error and the rounding error (1e-16/step for each order) then stay below the bound.
STEP = 1e-3
BOUND = 1e-6
MAX_CONDITION = 30.0
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

    def __getattr__(self, name: str) -> Callable[..., Any]:
        function = getattr(self._module, name)
        return lambda *arguments: function(*arguments, *self._arguments)


def check_consistency(generated: Generated, limits: Array, links: Array) -> list[Check]:
    """Check the derivatives of a generated model at a few of its poses.

    Parameters
    ----------
    generated : Generated
        The functions.
    limits : ndarray, shape (3, 2)
        Limits of the carriages [m].
    links : ndarray, shape (3,)
        Link lengths [m]; the step is scaled with the shortest.

    Returns
    -------
    list of Check
        One for each relation; a single failed one when the robot has no regular pose within its limits.
    """
    x, assembly = regular_configurations(generated, limits)
    if not len(x):
        return [Check("a regular pose within the limits", np.inf, BOUND)]
    step = STEP * float(np.min(links)) / 0.4
    errors: dict[str, float] = {}
    with np.errstate(all="ignore"):  # a broken function may give NaN: it fails the check, it does not warn
        for one, branch in zip(x, assembly, strict=True):
            for name, found, expected in _relations(generated, one, branch, step):
                scale = max(float(np.max(np.abs(expected))), 1e-9)
                error = float(np.max(np.abs(found - expected))) / scale
                errors[name] = max(errors.get(name, 0.0), error if np.isfinite(error) else np.inf)
    return [Check(name, error, BOUND) for name, error in errors.items()]


def regular_configurations(generated: Generated, limits: Array, wanted: int = 4) -> tuple[Array, Array]:
    """Find carriage positions, and their assembly branches, that are well inside the workspace."""
    rng = np.random.default_rng(SEED)
    low, high = limits[:, 0], limits[:, 1]
    margin = 0.05 * (high - low)
    x = rng.uniform(low + margin, high - margin, size=(4000, 3))
    found_x, found_branch = [], []
    with np.errstate(all="ignore"):
        for branch in (1.0, -1.0):
            p = generated.direct_kinematics(x, branch)
            back = generated.inverse_kinematics(p)
            determinant, condition = generated.jacobian_condition(p)
            good = (
                (np.abs(back - x).max(axis=-1) < 1e-9)
                & (condition < MAX_CONDITION)
                & (determinant * branch > 0)
            )
            good &= (generated.belt_spans(p) > 0.02 * (high - low).min()).all(axis=(-1, -2))
            good &= (generated.reach_margin(p) > 0.01).all(axis=-1)
            found_x.append(x[good][:wanted])
            found_branch.append(np.full(len(found_x[-1]), branch))
    return np.concatenate(found_x)[:wanted], np.concatenate(found_branch)[:wanted]


def _difference(function: Callable[[Array], Array], at: Array, step: float) -> Array:
    """Central differences of fourth order; the derivative's index is the last one of the result."""
    columns = []
    for k in range(len(at)):
        e = np.zeros(len(at))
        e[k] = step
        near = function(at + e) - function(at - e)
        far = function(at + 2 * e) - function(at - 2 * e)
        columns.append((8.0 * near - far) / (12.0 * step))
    return np.stack(columns, axis=-1)


def _relations(g: Generated, x: Array, branch: float, step: float) -> Iterator[tuple[str, Array, Array]]:
    """Yield (name, generated value, value by other means) at one configuration."""

    def pose(carriages: Array) -> Array:
        position: Array = g.direct_kinematics(carriages, branch)
        return position

    p = pose(x)
    rng = np.random.default_rng(SEED + 1)
    x_dot, delta_q = rng.normal(size=3), 1e-3 * rng.normal(size=9)
    D_p, P = g.platform_jacobian(p), g.platform_second_derivatives(p)
    D_l, D_r = g.constraint_jacobians(p)

    yield "inverse of direct kinematics", g.inverse_kinematics(p), x
    yield "constraint Jacobians", D_l @ D_p, D_r
    yield "platform Jacobian", D_p, _difference(pose, x, step)
    yield "platform second derivatives", P, _difference(lambda c: g.platform_jacobian(pose(c)), x, step)
    yield "platform Jacobian rate", g.platform_jacobian_rate(p, x_dot), P @ x_dot
    yield (
        "gravity gradient",
        g.gravity_gradient(p),
        _difference(lambda c: g.gravity_potential(pose(c)), x, step),
    )
    hessian = g.gravity_hessian(p)
    yield "gravity Hessian", hessian, _difference(lambda c: g.gravity_gradient(pose(c)), x, step)

    gradient = g.elastic_gradient(p, delta_q)
    elastic = g.elastic_hessian(p)
    yield "elastic gradient", gradient, _difference(lambda d: g.elastic_potential(p, d), delta_q, 1e-4)
    yield "elastic Hessian", elastic, _difference(lambda d: g.elastic_gradient(p, d), delta_q, 1e-4)
    whole = elastic.copy()
    whole[:3, :3] += hessian
    M, K = g.modal_matrices(p)
    yield "stiffness matrix", g.stiffness_matrix(p), whole
    yield "modal stiffness matrix", K, whole
    yield "modal mass matrix", M, g.mass_matrix(p)
    yield "mass matrix", M, _quadratic_form(lambda rate: sum(g.kinetic_energy(p, rate)), 9)
    yield "velocity forces", g.velocity_forces(p, x_dot), _lagrange_forces(g, pose, x, x_dot, step)
    yield "link Jacobians", *_platform_end(g, p)

    torques, rotations = g.static_equilibrium(p)
    strained = g.elastic_gradient(p, np.concatenate([np.zeros(3), rotations]))
    pulleys = strained[3:].reshape(2, 3)
    yield "static equilibrium", strained[:3], -g.gravity_gradient(p)
    yield "static torques", torques, pulleys.sum(axis=0)
    # With the line before: of the two pulleys of an axis one carries the torque and the other none.
    yield "torque on one pulley only", np.abs(torques), np.abs(pulleys).max(axis=0)


def _quadratic_form(energy: Callable[[Array], Array], n: int) -> Array:
    """Matrix of a quadratic form by polarisation: exact but for rounding."""
    basis = np.eye(n)
    matrix = np.empty((n, n))
    for k, m in cartesian(range(n), repeat=2):
        matrix[k, m] = (energy(basis[k] + basis[m]) - energy(basis[k] - basis[m])) / 2.0
    return matrix


def _lagrange_forces(
    g: Generated, pose: Callable[[Array], Array], x: Array, x_dot: Array, step: float
) -> Array:
    """Coriolis forces from differences of M_ss: dM/dt x_dot - grad(x_dot^T M x_dot) / 2."""
    dM = _difference(lambda c: g.mass_matrix(pose(c))[:3, :3], x, step)
    forces: Array = (dM @ x_dot) @ x_dot - 0.5 * np.einsum("klm,k,l->m", dM, x_dot, x_dot)
    return forces


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
