"""A mechanism that was not derived: a tool in a plane, x and y, each pulled by a pulley through a belt of its own.

What a generated model has, written by hand and small enough to be right at a glance.  With k_i = s_i / (l_i + p_i):
V = sum of k_i / 2 (p_i - r_i theta_i)^2 - m g . p, and T of the mass m and the inertias I_i.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

COORDINATES = ("x", "y", "theta_1", "theta_2")
COORDINATE_UNITS = ("m", "m", "rad", "rad")
RIGID_MODES = 2


class Parameters(NamedTuple):
    """Mass [kg], gravity [m/s^2]; of each pulley radius [m] and inertia, of each belt s [N] and l [m]; limits [m]."""

    mass: Any
    gravity: Any
    radius: Any
    inertia: Any
    stiffness: Any
    length: Any
    limits: Any


def belts(p, parameters):
    """k_i, (..., 2)."""
    return parameters.stiffness / (parameters.length + np.asarray(p))


def filled(batch, entries):
    """A constant array for each pose."""
    return np.broadcast_to(entries, (*batch, *np.shape(entries))).copy()


def inverse_kinematics(p, parameters):
    return np.array(p, dtype=np.result_type(float, np.asarray(p)))


def platform_jacobian(p, parameters):
    return filled(np.shape(p)[:-1], np.eye(2))


def inside(p, parameters):
    """How far a pose is from the lower and the upper limits, (..., 2, 2)."""
    p = np.asarray(p)
    return np.stack([p - parameters.limits[:, 0], parameters.limits[:, 1] - p], axis=-1)


def kinetic_energy(p, q_dot, parameters):
    tool = 0.5 * parameters.mass * (q_dot[..., :2] ** 2).sum(axis=-1)
    return tool, 0.5 * (parameters.inertia * q_dot[..., 2:] ** 2).sum(axis=-1)


def mass_matrix(p, parameters):
    return filled(np.shape(p)[:-1], np.diag([parameters.mass, parameters.mass, *parameters.inertia]))


def gravity_potential(p, parameters):
    return -parameters.mass * (parameters.gravity[:2] * np.asarray(p)).sum(axis=-1)


def gravity_gradient(p, parameters):
    return filled(np.shape(p)[:-1], -parameters.mass * parameters.gravity[:2])


def gravity_hessian(p, parameters):
    return filled(np.shape(p)[:-1], np.zeros((2, 2)))


def strain(parameters):
    """How each belt is strained by the coordinates, (2, 4)."""
    return np.hstack([np.eye(2), -np.diag(parameters.radius)])


def elastic_potential(p, delta_q, parameters):
    return 0.5 * (belts(p, parameters) * (strain(parameters) @ delta_q) ** 2).sum(axis=-1)


def elastic_gradient(p, delta_q, parameters):
    return elastic_hessian(p, parameters) @ delta_q


def elastic_hessian(p, parameters):
    B = strain(parameters)
    return B.T @ (belts(p, parameters)[..., None] * B)


def stiffness_matrix(p, parameters):
    return elastic_hessian(p, parameters)


def modal_matrices(p, parameters):
    return mass_matrix(p, parameters), stiffness_matrix(p, parameters)


def static_equilibrium(p, parameters):
    gradient = gravity_gradient(p, parameters)
    return parameters.radius * gradient, gradient / (parameters.radius * belts(p, parameters))
