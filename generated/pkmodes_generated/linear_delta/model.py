# Generated from the derivation of linear_delta.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism linear_delta, for a robot given by its parameters.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; coordinate l of a second
derivative; belt span s; component i = x, y, z.  t1, t2, ... are subexpressions shared by several values.

* x_j [m]: position of carriage j along its rail
* r_j_i [m]: platform joint j relative to the origin of rail j, component i
* s_j_i [m]: linkage vector j, from carriage to platform joint, component i
* a_j [m]: coordinate of platform joint j along rail j
* w_j_i [m]: vector from rail j to platform joint j, perpendicular to it, component i
* w2_j [m^2]: squared distance of platform joint j from rail j
* tau_st_j [N m]: static torque on the driven pulley of axis j
* I_j_k [kg m^2]: moment of inertia of pulley k of axis j, including the motor if it is driven
* l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* S_j_i [m]: centre of sphere j, on which the platform centre lies, component i
* alpha_i [m]: vector from sphere centre 1 to sphere centre 2, component i
* beta_i [m]: vector from sphere centre 1 to sphere centre 3, component i
* nu_i [m^2]: normal to the plane of the sphere centres, component i
* nu2 [m^4]: squared length of nu
* h_j [m^2]: scalar product of p - S_1 with the vector from sphere centre 1 to sphere centre j
* q_i [m]: projection of p onto the plane of the sphere centres, relative to S_1, component i
* v_p_i [m/s]: velocity of the platform, component i
* D_r_j [m]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [1]: platform Jacobian, dp_i/dx_k
* U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
* f_j_kl [1]: right-hand side of closure j, differentiated with respect to x_k and x_l
* P_i_kl [1/m]: second derivative of p_i with respect to x_k and x_l
* s_dot_j_i [m/s]: rate of change of linkage vector j, component i
* D_p_dot_i_k [1/s]: time derivative of dp_i/dx_k
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* G_j [N]: gradient of the gravitational potential energy with respect to x_j
* det_j [N^2 m]: determinant of the equilibrium equations of axis j
* theta_j_k_st [rad]: static rotation of pulley k of axis j, relative to the unstrained transmissions
"""

from math import prod
from typing import NamedTuple

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "Parameters",
    "RIGID_MODES",
    "belt_spans",
    "belt_stiffness",
    "constraint_jacobians",
    "direct_kinematics",
    "elastic_gradient",
    "elastic_hessian",
    "elastic_potential",
    "gravity_gradient",
    "gravity_hessian",
    "gravity_potential",
    "inverse_kinematics",
    "jacobian_condition",
    "kinetic_energy",
    "link_jacobians",
    "mass_matrix",
    "modal_matrices",
    "platform_jacobian",
    "platform_jacobian_rate",
    "platform_second_derivatives",
    "reach_margin",
    "static_equilibrium",
    "stiffness_matrix",
    "travel_margin",
    "velocity_forces",
]

#: Generalised coordinates, in the order of M and K, and their units.
COORDINATES = (
    "x_1",
    "x_2",
    "x_3",
    "theta_1_1",
    "theta_2_1",
    "theta_3_1",
    "theta_1_2",
    "theta_2_2",
    "theta_3_2",
)
COORDINATE_UNITS = (
    "m",
    "m",
    "m",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
)

#: Number of rigid-body modes: motions that strain no elastic part, at any pose and for any parameters.
RIGID_MODES = 3


class Parameters(NamedTuple):
    """Parameters of a robot; every field may have its own leading batch axes.

    Attributes
    ----------
    platform_mass : float or array, shape (...) [kg]
        Platform mass.
    gravity : array, shape (..., 3) [m/s^2]
        Gravitational acceleration g, base frame.
    origin : array, shape (..., 3, 3) [m]
        Point of rail j where x_j = 0.
    direction : array, shape (..., 3, 3) [1]
        Unit vector along rail j.
    joint : array, shape (..., 3, 3) [m]
        Platform joint j relative to the platform centre.
    link_length : array, shape (..., 3) [m]
        Length of linkage j.
    link_mass : array, shape (..., 3) [kg]
        Mass of linkage j, both rods together.
    carriage_mass : array, shape (..., 3) [kg]
        Mass of carriage j.
    carriage_length : array, shape (..., 3) [m]
        Length of carriage j along its rail.
    belt_specific_stiffness : array, shape (..., 3) [N/m]
        Specific stiffness of belt j: k = w_b k_sp / free length.
    belt_width : array, shape (..., 3) [m]
        Width of belt j.
    pulley_radius : array, shape (..., 3) [m]
        Radius of the pulleys of axis j.
    pulley_inertia : array, shape (..., 3) [kg m^2]
        Moment of inertia of each pulley of axis j.
    motor_inertia : array, shape (..., 3) [kg m^2]
        Moment of inertia of motor j at the motor shaft.
    gear_ratio : array, shape (..., 3) [1]
        Gear ratio of axis j, motor over driven pulley.
    drive : array, shape (..., 3, 2) [1]
        1 if the motor drives pulley k of axis j, else 0.
    limits : array, shape (..., 3, 2) [m]
        min(x_j), max(x_j): pulley 2 is at min, pulley 1 at max.
    branch : array, shape (..., 3) [1]
        Branch of axis j: +1 if the carriage is ahead of the platform joint along the rail, -1 if behind.
    """

    platform_mass: float
    gravity: np.ndarray
    origin: np.ndarray
    direction: np.ndarray
    joint: np.ndarray
    link_length: np.ndarray
    link_mass: np.ndarray
    carriage_mass: np.ndarray
    carriage_length: np.ndarray
    belt_specific_stiffness: np.ndarray
    belt_width: np.ndarray
    pulley_radius: np.ndarray
    pulley_inertia: np.ndarray
    motor_inertia: np.ndarray
    gear_ratio: np.ndarray
    drive: np.ndarray
    limits: np.ndarray
    branch: np.ndarray


def _entries(array, shape):
    """Return the entries of an array of shape (..., *shape), row by row; numbers if there is no batch."""
    array = np.asarray(array)
    array = array.astype(np.result_type(float, array), copy=False)
    batch = array.ndim - len(shape)
    if batch < 0 or array.shape[batch:] != shape:
        expected = ", ".join(map(str, ("...", *shape)))
        raise ValueError(f"expected an array of shape ({expected}), found shape {array.shape}")
    count = prod(shape)
    flat = array.reshape(*array.shape[:batch], count)
    return tuple(flat[..., i][()] for i in range(count))


def _batch(*arrays):
    """Return the common batch shape and type of the arguments."""
    return np.broadcast_shapes(*map(np.shape, arrays)), np.result_type(float, *arrays)


def inverse_kinematics(p, parameters):
    """Carriage positions at a pose.

    NaN if the pose is out of reach (see `reach_margin`).

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    x : array, shape (..., 3) [m]
        Carriage positions x_1, x_2, x_3.

    Notes
    -----
    Equations 1 to 3.
    84 operations; 201 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    x_out = np.empty((*batch, 3), dtype)
    x_out[..., 0] = x_1
    x_out[..., 1] = x_2
    x_out[..., 2] = x_3
    return x_out


def reach_margin(p, parameters):
    """Distance by which each platform joint could be farther from its rail.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 3) [m]
        Link length minus distance of the platform joint from its rail, for each axis.

    Notes
    -----
    Closure of equation 2; a pose is reachable if every margin is at least zero.
    75 operations; 159 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    margin_out = np.empty((*batch, 3), dtype)
    margin_out[..., 0] = l_d_1 - np.sqrt(w2_1)
    margin_out[..., 1] = l_d_2 - np.sqrt(w2_2)
    margin_out[..., 2] = l_d_3 - np.sqrt(w2_3)
    return margin_out


def travel_margin(parameters):
    """Sum of the lengths of the two belt spans at each carriage, the same at every pose.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 3) [m]
        Max - min - l_t for each axis; positive for a robot that can move.

    Notes
    -----
    Sum of equations 36 and 37.
    6 operations; 6 with every named value expanded.
    """
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    batch, dtype = _batch(l_t_1, x_min_1)
    margin_out = np.empty((*batch, 3), dtype)
    margin_out[..., 0] = -l_t_1 + x_max_1 - x_min_1
    margin_out[..., 1] = -l_t_2 + x_max_2 - x_min_2
    margin_out[..., 2] = -l_t_3 + x_max_3 - x_min_3
    return margin_out


def direct_kinematics(x, assembly, parameters):
    """Platform centre in the base frame for given carriage positions.

    NaN if the three spheres do not intersect.

    Parameters
    ----------
    x : array, shape (..., 3) [m]
        Carriage positions x_1, x_2, x_3.
    assembly : array, shape (...) [1]
        Assembly branch, +1 or -1: the sign of det D_l at the desired platform centre.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.

    Notes
    -----
    Equation 3: intersection of three spheres.
    123 operations; 4398 with every named value expanded.
    """
    x_1, x_2, x_3 = _entries(x, (3,))
    (assembly,) = _entries(assembly, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    batch, dtype = _batch(x_1, assembly, o_1_x, n_1_x, b_1_x, l_d_1)
    S_1_x = -b_1_x + n_1_x*x_1 + o_1_x
    S_1_y = -b_1_y + n_1_y*x_1 + o_1_y
    S_1_z = -b_1_z + n_1_z*x_1 + o_1_z
    S_2_x = -b_2_x + n_2_x*x_2 + o_2_x
    S_2_y = -b_2_y + n_2_y*x_2 + o_2_y
    S_2_z = -b_2_z + n_2_z*x_2 + o_2_z
    S_3_x = -b_3_x + n_3_x*x_3 + o_3_x
    S_3_y = -b_3_y + n_3_y*x_3 + o_3_y
    S_3_z = -b_3_z + n_3_z*x_3 + o_3_z
    alpha_x = -S_1_x + S_2_x
    alpha_y = -S_1_y + S_2_y
    alpha_z = -S_1_z + S_2_z
    beta_x = -S_1_x + S_3_x
    beta_y = -S_1_y + S_3_y
    beta_z = -S_1_z + S_3_z
    nu_x = alpha_y*beta_z - alpha_z*beta_y
    nu_y = -alpha_x*beta_z + alpha_z*beta_x
    nu_z = alpha_x*beta_y - alpha_y*beta_x
    nu2 = nu_x**2 + nu_y**2 + nu_z**2
    t1 = l_d_1**2
    t2 = (1/2)*t1
    h_2 = (1/2)*alpha_x**2 + (1/2)*alpha_y**2 + (1/2)*alpha_z**2 - 1/2*l_d_2**2 + t2
    h_3 = (1/2)*beta_x**2 + (1/2)*beta_y**2 + (1/2)*beta_z**2 - 1/2*l_d_3**2 + t2
    t3 = 1.0/nu2
    q_x = t3*(h_2*(beta_y*nu_z - beta_z*nu_y) + h_3*(-alpha_y*nu_z + alpha_z*nu_y))
    q_y = t3*(h_2*(-beta_x*nu_z + beta_z*nu_x) + h_3*(alpha_x*nu_z - alpha_z*nu_x))
    q_z = t3*(h_2*(beta_x*nu_y - beta_y*nu_x) + h_3*(-alpha_x*nu_y + alpha_y*nu_x))
    t4 = assembly*np.sqrt(t3*(-q_x**2 - q_y**2 - q_z**2 + t1))
    p_out = np.empty((*batch, 3), dtype)
    p_out[..., 0] = S_1_x + nu_x*t4 + q_x
    p_out[..., 1] = S_1_y + nu_y*t4 + q_y
    p_out[..., 2] = S_1_z + nu_z*t4 + q_z
    return p_out


def belt_spans(p, parameters):
    """Free lengths of the belt spans.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    l_f : array, shape (..., 3, 3) [m]
        Free length l_f[j-1, s-1] of span s of belt j.

    Notes
    -----
    Equations 35 to 37; a pose is within the limits if all are positive.
    102 operations; 423 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, x_min_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    l_f_1_1 = x_max_1 - x_min_1
    t1 = (1/2)*l_t_1
    l_f_1_2 = -t1 + x_1 - x_min_1
    l_f_1_3 = -t1 - x_1 + x_max_1
    l_f_2_1 = x_max_2 - x_min_2
    t2 = (1/2)*l_t_2
    l_f_2_2 = -t2 + x_2 - x_min_2
    l_f_2_3 = -t2 - x_2 + x_max_2
    l_f_3_1 = x_max_3 - x_min_3
    t3 = (1/2)*l_t_3
    l_f_3_2 = -t3 + x_3 - x_min_3
    l_f_3_3 = -t3 - x_3 + x_max_3
    l_f_out = np.empty((*batch, 3, 3), dtype)
    l_f_out[..., 0, 0] = l_f_1_1
    l_f_out[..., 0, 1] = l_f_1_2
    l_f_out[..., 0, 2] = l_f_1_3
    l_f_out[..., 1, 0] = l_f_2_1
    l_f_out[..., 1, 1] = l_f_2_2
    l_f_out[..., 1, 2] = l_f_2_3
    l_f_out[..., 2, 0] = l_f_3_1
    l_f_out[..., 2, 1] = l_f_3_2
    l_f_out[..., 2, 2] = l_f_3_3
    return l_f_out


def constraint_jacobians(p, parameters):
    """Constraint Jacobians D_l and D_r of D_l p_dot = D_r x_dot.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_l : array, shape (..., 3, 3) [m]
        Row j: linkage vector c_j - e_j in the base frame.
    D_r : array, shape (..., 3, 3) [m]
        Diagonal: component of linkage vector j along the motion of its joint.

    Notes
    -----
    Equations 14 and 15.
    117 operations; 1293 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_l_out = np.empty((*batch, 3, 3), dtype)
    D_l_out[..., 0, 0] = s_1_x
    D_l_out[..., 0, 1] = s_1_y
    D_l_out[..., 0, 2] = s_1_z
    D_l_out[..., 1, 0] = s_2_x
    D_l_out[..., 1, 1] = s_2_y
    D_l_out[..., 1, 2] = s_2_z
    D_l_out[..., 2, 0] = s_3_x
    D_l_out[..., 2, 1] = s_3_y
    D_l_out[..., 2, 2] = s_3_z
    D_r_out = np.zeros((*batch, 3, 3), dtype)
    D_r_out[..., 0, 0] = D_r_1
    D_r_out[..., 1, 1] = D_r_2
    D_r_out[..., 2, 2] = D_r_3
    return D_l_out, D_r_out


def jacobian_condition(p, parameters):
    """Assembly branch and condition number of D_l in the Frobenius norm.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    determinant : array, shape (...) [m^3]
        Det D_l; its sign is the assembly branch.
    condition : array, shape (...) [1]
        Frobenius condition number, at least 3.

    Notes
    -----
    Equation 15; |D_l| |D_l^-1|, one to three times the condition number in the 2-norm.
    184 operations; 14069 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/(det_D_l**2)
    determinant_out = np.empty(batch, dtype)
    determinant_out[...] = det_D_l
    condition_out = np.empty(batch, dtype)
    condition_out[...] = (
        np.sqrt(s_1_x**2 + s_1_y**2 + s_1_z**2 + s_2_x**2 + s_2_y**2 + s_2_z**2 + s_3_x**2 + s_3_y**2
        + s_3_z**2)*np.sqrt(A_x_1**2*t1 + A_x_2**2*t1 + A_x_3**2*t1 + A_y_1**2*t1 + A_y_2**2*t1 + A_y_3**2*t1
        + A_z_1**2*t1 + A_z_2**2*t1 + A_z_3**2*t1)
    )
    return determinant_out[()], condition_out[()]


def platform_jacobian(p, parameters):
    """Platform Jacobian D_p = D_l^-1 D_r.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_p : array, shape (..., 3, 3) [1]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15.
    162 operations; 14274 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    D_p_out = np.empty((*batch, 3, 3), dtype)
    D_p_out[..., 0, 0] = D_p_x_1
    D_p_out[..., 0, 1] = D_p_x_2
    D_p_out[..., 0, 2] = D_p_x_3
    D_p_out[..., 1, 0] = D_p_y_1
    D_p_out[..., 1, 1] = D_p_y_2
    D_p_out[..., 1, 2] = D_p_y_3
    D_p_out[..., 2, 0] = D_p_z_1
    D_p_out[..., 2, 1] = D_p_z_2
    D_p_out[..., 2, 2] = D_p_z_3
    return D_p_out


def platform_jacobian_rate(p, x_dot, parameters):
    """Time derivative of the platform Jacobian.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    x_dot : array, shape (..., 3) [m/s]
        Carriage velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_p_dot : array, shape (..., 3, 3) [1/s]
        d(D_p)/dt at x_dot.

    Notes
    -----
    Equation 17.
    330 operations; 660699 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    x_1_dot, x_2_dot, x_3_dot = _entries(x_dot, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, x_1_dot, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    t5 = D_p_x_2*x_2_dot
    t6 = D_p_x_3*x_3_dot
    s_dot_1_x = U_1_x_1*x_1_dot + t5 + t6
    t7 = D_p_y_2*x_2_dot
    t8 = D_p_y_3*x_3_dot
    s_dot_1_y = U_1_y_1*x_1_dot + t7 + t8
    t9 = D_p_z_2*x_2_dot
    t10 = D_p_z_3*x_3_dot
    s_dot_1_z = U_1_z_1*x_1_dot + t10 + t9
    t11 = D_p_x_1*x_1_dot
    s_dot_2_x = U_2_x_2*x_2_dot + t11 + t6
    t12 = D_p_y_1*x_1_dot
    s_dot_2_y = U_2_y_2*x_2_dot + t12 + t8
    t13 = D_p_z_1*x_1_dot
    s_dot_2_z = U_2_z_2*x_2_dot + t10 + t13
    s_dot_3_x = U_3_x_3*x_3_dot + t11 + t5
    s_dot_3_y = U_3_y_3*x_3_dot + t12 + t7
    s_dot_3_z = U_3_z_3*x_3_dot + t13 + t9
    t14 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z
    t15 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z
    t16 = (
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y
        + n_1_z*s_dot_1_z
    )
    D_p_dot_x_1 = t1*(A_x_1*t16 + A_x_2*t14 + A_x_3*t15)
    D_p_dot_y_1 = t1*(A_y_1*t16 + A_y_2*t14 + A_y_3*t15)
    D_p_dot_z_1 = t1*(A_z_1*t16 + A_z_2*t14 + A_z_3*t15)
    t17 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z
    t18 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z
    t19 = (
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y
        + n_2_z*s_dot_2_z
    )
    D_p_dot_x_2 = t1*(A_x_1*t17 + A_x_2*t19 + A_x_3*t18)
    D_p_dot_y_2 = t1*(A_y_1*t17 + A_y_2*t19 + A_y_3*t18)
    D_p_dot_z_2 = t1*(A_z_1*t17 + A_z_2*t19 + A_z_3*t18)
    t20 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z
    t21 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z
    t22 = (
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y
        + n_3_z*s_dot_3_z
    )
    D_p_dot_x_3 = t1*(A_x_1*t20 + A_x_2*t21 + A_x_3*t22)
    D_p_dot_y_3 = t1*(A_y_1*t20 + A_y_2*t21 + A_y_3*t22)
    D_p_dot_z_3 = t1*(A_z_1*t20 + A_z_2*t21 + A_z_3*t22)
    D_p_dot_out = np.empty((*batch, 3, 3), dtype)
    D_p_dot_out[..., 0, 0] = D_p_dot_x_1
    D_p_dot_out[..., 0, 1] = D_p_dot_x_2
    D_p_dot_out[..., 0, 2] = D_p_dot_x_3
    D_p_dot_out[..., 1, 0] = D_p_dot_y_1
    D_p_dot_out[..., 1, 1] = D_p_dot_y_2
    D_p_dot_out[..., 1, 2] = D_p_dot_y_3
    D_p_dot_out[..., 2, 0] = D_p_dot_z_1
    D_p_dot_out[..., 2, 1] = D_p_dot_z_2
    D_p_dot_out[..., 2, 2] = D_p_dot_z_3
    return D_p_dot_out


def platform_second_derivatives(p, parameters):
    """Second derivatives of the platform position with respect to the carriage positions.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    P : array, shape (..., 3, 3, 3) [1/m]
        d2p_i/dq_k dq_l as P[i, k, l].

    Notes
    -----
    Equation 49, by the implicit function theorem to second order.
    369 operations; 695493 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    f_1_11 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    f_2_11 = -D_p_x_1**2 - D_p_y_1**2 - D_p_z_1**2
    P_x_11 = t1*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11)
    P_y_11 = t1*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11)
    P_z_11 = t1*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11)
    f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2
    P_x_12 = t1*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12)
    P_y_12 = t1*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12)
    P_z_12 = t1*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12)
    f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3
    f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    P_x_13 = t1*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13)
    P_y_13 = t1*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13)
    P_z_13 = t1*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13)
    f_1_22 = -D_p_x_2**2 - D_p_y_2**2 - D_p_z_2**2
    f_2_22 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    P_x_22 = t1*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22)
    P_y_22 = t1*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22)
    P_z_22 = t1*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22)
    f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3
    f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    P_x_23 = t1*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23)
    P_y_23 = t1*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23)
    P_z_23 = t1*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23)
    f_1_33 = -D_p_x_3**2 - D_p_y_3**2 - D_p_z_3**2
    f_3_33 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    P_x_33 = t1*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33)
    P_y_33 = t1*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33)
    P_z_33 = t1*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33)
    P_out = np.empty((*batch, 3, 3, 3), dtype)
    P_out[..., 0, 0, 0] = P_x_11
    P_out[..., 0, 0, 1] = P_out[..., 0, 1, 0] = P_x_12
    P_out[..., 0, 0, 2] = P_out[..., 0, 2, 0] = P_x_13
    P_out[..., 0, 1, 1] = P_x_22
    P_out[..., 0, 1, 2] = P_out[..., 0, 2, 1] = P_x_23
    P_out[..., 0, 2, 2] = P_x_33
    P_out[..., 1, 0, 0] = P_y_11
    P_out[..., 1, 0, 1] = P_out[..., 1, 1, 0] = P_y_12
    P_out[..., 1, 0, 2] = P_out[..., 1, 2, 0] = P_y_13
    P_out[..., 1, 1, 1] = P_y_22
    P_out[..., 1, 1, 2] = P_out[..., 1, 2, 1] = P_y_23
    P_out[..., 1, 2, 2] = P_y_33
    P_out[..., 2, 0, 0] = P_z_11
    P_out[..., 2, 0, 1] = P_out[..., 2, 1, 0] = P_z_12
    P_out[..., 2, 0, 2] = P_out[..., 2, 2, 0] = P_z_13
    P_out[..., 2, 1, 1] = P_z_22
    P_out[..., 2, 1, 2] = P_out[..., 2, 2, 1] = P_z_23
    P_out[..., 2, 2, 2] = P_z_33
    return P_out


def link_jacobians(p, parameters):
    """Jacobians of the linkages: centre of mass and angular velocity.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_d : array, shape (..., 3, 3, 3) [1]
        D_d[j-1] x_dot is the velocity of the centre of mass of linkage j.
    D_omega : array, shape (..., 3, 3, 3) [1/m]
        D_omega[j-1] x_dot is the angular velocity of linkage j.

    Notes
    -----
    Equations 16 and 23; the angular velocity without spin about the rod, which carries no energy.
    309 operations; 132498 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    t1 = l_d_1**2
    x_1 = a_1 + sigma_1*np.sqrt(t1 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    t2 = l_d_2**2
    x_2 = a_2 + sigma_2*np.sqrt(t2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    t3 = l_d_3**2
    x_3 = a_3 + sigma_3*np.sqrt(t3 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t4 = 1.0/det_D_l
    t5 = D_r_1*t4
    D_p_x_1 = A_x_1*t5
    t6 = D_r_2*t4
    D_p_x_2 = A_x_2*t6
    t7 = D_r_3*t4
    D_p_x_3 = A_x_3*t7
    D_p_y_1 = A_y_1*t5
    D_p_y_2 = A_y_2*t6
    D_p_y_3 = A_y_3*t7
    D_p_z_1 = A_z_1*t5
    D_p_z_2 = A_z_2*t6
    D_p_z_3 = A_z_3*t7
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    t8 = (1/2)*D_p_x_1
    t9 = (1/2)*D_p_x_2
    t10 = (1/2)*D_p_x_3
    t11 = (1/2)*D_p_y_1
    t12 = (1/2)*D_p_y_2
    t13 = (1/2)*D_p_y_3
    t14 = (1/2)*D_p_z_1
    t15 = (1/2)*D_p_z_2
    t16 = (1/2)*D_p_z_3
    t17 = 1.0/t1
    t18 = 1.0/t2
    t19 = 1.0/t3
    D_d_out = np.empty((*batch, 3, 3, 3), dtype)
    D_d_out[..., 0, 0, 0] = (1/2)*n_1_x + t8
    D_d_out[..., 0, 0, 1] = t9
    D_d_out[..., 0, 0, 2] = t10
    D_d_out[..., 0, 1, 0] = (1/2)*n_1_y + t11
    D_d_out[..., 0, 1, 1] = t12
    D_d_out[..., 0, 1, 2] = t13
    D_d_out[..., 0, 2, 0] = (1/2)*n_1_z + t14
    D_d_out[..., 0, 2, 1] = t15
    D_d_out[..., 0, 2, 2] = t16
    D_d_out[..., 1, 0, 0] = t8
    D_d_out[..., 1, 0, 1] = (1/2)*n_2_x + t9
    D_d_out[..., 1, 0, 2] = t10
    D_d_out[..., 1, 1, 0] = t11
    D_d_out[..., 1, 1, 1] = (1/2)*n_2_y + t12
    D_d_out[..., 1, 1, 2] = t13
    D_d_out[..., 1, 2, 0] = t14
    D_d_out[..., 1, 2, 1] = (1/2)*n_2_z + t15
    D_d_out[..., 1, 2, 2] = t16
    D_d_out[..., 2, 0, 0] = t8
    D_d_out[..., 2, 0, 1] = t9
    D_d_out[..., 2, 0, 2] = (1/2)*n_3_x + t10
    D_d_out[..., 2, 1, 0] = t11
    D_d_out[..., 2, 1, 1] = t12
    D_d_out[..., 2, 1, 2] = (1/2)*n_3_y + t13
    D_d_out[..., 2, 2, 0] = t14
    D_d_out[..., 2, 2, 1] = t15
    D_d_out[..., 2, 2, 2] = (1/2)*n_3_z + t16
    D_omega_out = np.empty((*batch, 3, 3, 3), dtype)
    D_omega_out[..., 0, 0, 0] = t17*(-U_1_y_1*s_1_z + U_1_z_1*s_1_y)
    D_omega_out[..., 0, 0, 1] = t17*(-D_p_y_2*s_1_z + D_p_z_2*s_1_y)
    D_omega_out[..., 0, 0, 2] = t17*(-D_p_y_3*s_1_z + D_p_z_3*s_1_y)
    D_omega_out[..., 0, 1, 0] = t17*(U_1_x_1*s_1_z - U_1_z_1*s_1_x)
    D_omega_out[..., 0, 1, 1] = t17*(D_p_x_2*s_1_z - D_p_z_2*s_1_x)
    D_omega_out[..., 0, 1, 2] = t17*(D_p_x_3*s_1_z - D_p_z_3*s_1_x)
    D_omega_out[..., 0, 2, 0] = t17*(-U_1_x_1*s_1_y + U_1_y_1*s_1_x)
    D_omega_out[..., 0, 2, 1] = t17*(-D_p_x_2*s_1_y + D_p_y_2*s_1_x)
    D_omega_out[..., 0, 2, 2] = t17*(-D_p_x_3*s_1_y + D_p_y_3*s_1_x)
    D_omega_out[..., 1, 0, 0] = t18*(-D_p_y_1*s_2_z + D_p_z_1*s_2_y)
    D_omega_out[..., 1, 0, 1] = t18*(-U_2_y_2*s_2_z + U_2_z_2*s_2_y)
    D_omega_out[..., 1, 0, 2] = t18*(-D_p_y_3*s_2_z + D_p_z_3*s_2_y)
    D_omega_out[..., 1, 1, 0] = t18*(D_p_x_1*s_2_z - D_p_z_1*s_2_x)
    D_omega_out[..., 1, 1, 1] = t18*(U_2_x_2*s_2_z - U_2_z_2*s_2_x)
    D_omega_out[..., 1, 1, 2] = t18*(D_p_x_3*s_2_z - D_p_z_3*s_2_x)
    D_omega_out[..., 1, 2, 0] = t18*(-D_p_x_1*s_2_y + D_p_y_1*s_2_x)
    D_omega_out[..., 1, 2, 1] = t18*(-U_2_x_2*s_2_y + U_2_y_2*s_2_x)
    D_omega_out[..., 1, 2, 2] = t18*(-D_p_x_3*s_2_y + D_p_y_3*s_2_x)
    D_omega_out[..., 2, 0, 0] = t19*(-D_p_y_1*s_3_z + D_p_z_1*s_3_y)
    D_omega_out[..., 2, 0, 1] = t19*(-D_p_y_2*s_3_z + D_p_z_2*s_3_y)
    D_omega_out[..., 2, 0, 2] = t19*(-U_3_y_3*s_3_z + U_3_z_3*s_3_y)
    D_omega_out[..., 2, 1, 0] = t19*(D_p_x_1*s_3_z - D_p_z_1*s_3_x)
    D_omega_out[..., 2, 1, 1] = t19*(D_p_x_2*s_3_z - D_p_z_2*s_3_x)
    D_omega_out[..., 2, 1, 2] = t19*(U_3_x_3*s_3_z - U_3_z_3*s_3_x)
    D_omega_out[..., 2, 2, 0] = t19*(-D_p_x_1*s_3_y + D_p_y_1*s_3_x)
    D_omega_out[..., 2, 2, 1] = t19*(-D_p_x_2*s_3_y + D_p_y_2*s_3_x)
    D_omega_out[..., 2, 2, 2] = t19*(-U_3_x_3*s_3_y + U_3_y_3*s_3_x)
    return D_d_out, D_omega_out


def kinetic_energy(p, q_dot, parameters):
    """Kinetic energies of the structure and of the transmissions.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    q_dot : array, shape (..., 9) [m/s, rad/s]
        Rates of the nine generalised coordinates.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    T_ss : array, shape (...) [J]
        Platform and the bodies that move it.
    T_t : array, shape (...) [J]
        Rotors and motors.

    Notes
    -----
    Equations 24 and 28.
    275 operations; 28717 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (
        x_1_dot, x_2_dot, x_3_dot, theta_1_1_dot, theta_2_1_dot, theta_3_1_dot, theta_1_2_dot, theta_2_2_dot,
        theta_3_2_dot,
    ) = _entries(q_dot, (9,))
    (m_p,) = _entries(parameters.platform_mass, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
    I_p_1, I_p_2, I_p_3 = _entries(parameters.pulley_inertia, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, x_1_dot, m_p, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, I_p_1, I_m_1, i_g_1,
        d_1_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    t5 = I_m_1*i_g_1**2
    I_1_1 = I_p_1 + d_1_1*t5
    I_1_2 = I_p_1 + d_1_2*t5
    t6 = I_m_2*i_g_2**2
    I_2_1 = I_p_2 + d_2_1*t6
    I_2_2 = I_p_2 + d_2_2*t6
    t7 = I_m_3*i_g_3**2
    I_3_1 = I_p_3 + d_3_1*t7
    I_3_2 = I_p_3 + d_3_2*t7
    v_p_x = D_p_x_1*x_1_dot + D_p_x_2*x_2_dot + D_p_x_3*x_3_dot
    v_p_y = D_p_y_1*x_1_dot + D_p_y_2*x_2_dot + D_p_y_3*x_3_dot
    v_p_z = D_p_z_1*x_1_dot + D_p_z_2*x_2_dot + D_p_z_3*x_3_dot
    t8 = x_1_dot**2
    t9 = (1/6)*m_d_1
    t10 = x_2_dot**2
    t11 = (1/6)*m_d_2
    t12 = x_3_dot**2
    t13 = (1/6)*m_d_3
    t14 = (1/2)*m_p + t11 + t13 + t9
    t15 = t9*x_1_dot
    t16 = t11*x_2_dot
    t17 = t13*x_3_dot
    T_ss_out = np.empty(batch, dtype)
    T_ss_out[...] = (
        (1/2)*m_t_1*t8 + (1/2)*m_t_2*t10 + (1/2)*m_t_3*t12 + t10*t11 + t12*t13 + t14*v_p_x**2 + t14*v_p_y**2
        + t14*v_p_z**2 + t8*t9 + v_p_x*(n_1_x*t15 + n_2_x*t16 + n_3_x*t17) + v_p_y*(n_1_y*t15 + n_2_y*t16
        + n_3_y*t17) + v_p_z*(n_1_z*t15 + n_2_z*t16 + n_3_z*t17)
    )
    T_t_out = np.empty(batch, dtype)
    T_t_out[...] = (
        (1/2)*I_1_1*theta_1_1_dot**2 + (1/2)*I_1_2*theta_1_2_dot**2 + (1/2)*I_2_1*theta_2_1_dot**2
        + (1/2)*I_2_2*theta_2_2_dot**2 + (1/2)*I_3_1*theta_3_1_dot**2 + (1/2)*I_3_2*theta_3_2_dot**2
    )
    return T_ss_out[()], T_t_out[()]


def mass_matrix(p, parameters):
    """Mass matrix M in the nine generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M : array, shape (..., 9, 9) [kg, kg m^2]
        Symmetric; block diagonal: M_ss (3 by 3) and the diagonal M_t.

    Notes
    -----
    Equations 24, 30 and 33.
    288 operations; 128922 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
    I_p_1, I_p_2, I_p_3 = _entries(parameters.pulley_inertia, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, I_p_1, I_m_1, i_g_1, d_1_1,
        sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    t5 = I_m_1*i_g_1**2
    I_1_1 = I_p_1 + d_1_1*t5
    I_1_2 = I_p_1 + d_1_2*t5
    t6 = I_m_2*i_g_2**2
    I_2_1 = I_p_2 + d_2_1*t6
    I_2_2 = I_p_2 + d_2_2*t6
    t7 = I_m_3*i_g_3**2
    I_3_1 = I_p_3 + d_3_1*t7
    I_3_2 = I_p_3 + d_3_2*t7
    t8 = (1/3)*m_d_1
    t9 = (1/6)*m_d_1
    t10 = n_1_x*t9
    t11 = n_1_y*t9
    t12 = n_1_z*t9
    t13 = (1/3)*m_d_2
    t14 = (1/3)*m_d_3
    t15 = m_p + t13 + t14 + t8
    t16 = D_p_x_1*t15 + t10
    t17 = D_p_y_1*t15 + t11
    t18 = D_p_z_1*t15 + t12
    t19 = (1/6)*m_d_2
    t20 = n_2_x*t19
    t21 = n_2_y*t19
    t22 = n_2_z*t19
    t23 = (1/6)*m_d_3
    t24 = n_3_x*t23
    t25 = n_3_y*t23
    t26 = n_3_z*t23
    t27 = D_p_x_2*t15 + t20
    t28 = D_p_y_2*t15 + t21
    t29 = D_p_z_2*t15 + t22
    M_out = np.zeros((*batch, 9, 9), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t10 + D_p_x_1*t16 + D_p_y_1*t11 + D_p_y_1*t17 + D_p_z_1*t12 + D_p_z_1*t18 + m_t_1 + t8
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_x_1*t20 + D_p_x_2*t16 + D_p_y_1*t21 + D_p_y_2*t17 + D_p_z_1*t22 + D_p_z_2*t18
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_x_1*t24 + D_p_x_3*t16 + D_p_y_1*t25 + D_p_y_3*t17 + D_p_z_1*t26 + D_p_z_3*t18
    )
    M_out[..., 1, 1] = (
        D_p_x_2*t20 + D_p_x_2*t27 + D_p_y_2*t21 + D_p_y_2*t28 + D_p_z_2*t22 + D_p_z_2*t29 + m_t_2 + t13
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_x_2*t24 + D_p_x_3*t27 + D_p_y_2*t25 + D_p_y_3*t28 + D_p_z_2*t26 + D_p_z_3*t29
    )
    M_out[..., 2, 2] = (
        D_p_x_3*t24 + D_p_x_3*(D_p_x_3*t15 + t24) + D_p_y_3*t25 + D_p_y_3*(D_p_y_3*t15 + t25) + D_p_z_3*t26
        + D_p_z_3*(D_p_z_3*t15 + t26) + m_t_3 + t14
    )
    M_out[..., 3, 3] = I_1_1
    M_out[..., 4, 4] = I_2_1
    M_out[..., 5, 5] = I_3_1
    M_out[..., 6, 6] = I_1_2
    M_out[..., 7, 7] = I_2_2
    M_out[..., 8, 8] = I_3_2
    return M_out


def velocity_forces(p, x_dot, parameters):
    """Coriolis and centrifugal forces h of M_ss x_ddot + h + grad V = Q.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    x_dot : array, shape (..., 3) [m/s]
        Carriage velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    h : array, shape (..., 3) [N]
        Generalised forces conjugate to the carriage positions.

    Notes
    -----
    Lagrange's equations; equation 47 before linearisation.
    711 operations; 3553737 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    x_1_dot, x_2_dot, x_3_dot = _entries(x_dot, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, x_1_dot, m_p, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    f_1_11 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    f_2_11 = -D_p_x_1**2 - D_p_y_1**2 - D_p_z_1**2
    P_x_11 = t1*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11)
    P_y_11 = t1*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11)
    P_z_11 = t1*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11)
    f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2
    P_x_12 = t1*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12)
    P_y_12 = t1*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12)
    P_z_12 = t1*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12)
    f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3
    f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    P_x_13 = t1*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13)
    P_y_13 = t1*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13)
    P_z_13 = t1*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13)
    f_1_22 = -D_p_x_2**2 - D_p_y_2**2 - D_p_z_2**2
    f_2_22 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    P_x_22 = t1*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22)
    P_y_22 = t1*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22)
    P_z_22 = t1*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22)
    f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3
    f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    P_x_23 = t1*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23)
    P_y_23 = t1*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23)
    P_z_23 = t1*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23)
    f_1_33 = -D_p_x_3**2 - D_p_y_3**2 - D_p_z_3**2
    f_3_33 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    P_x_33 = t1*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33)
    P_y_33 = t1*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33)
    P_z_33 = t1*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33)
    t5 = D_p_x_1*x_1_dot
    t6 = D_p_x_2*x_2_dot
    t7 = D_p_x_3*x_3_dot
    t8 = t6 + t7
    v_p_x = t5 + t8
    t9 = D_p_y_1*x_1_dot
    t10 = D_p_y_2*x_2_dot
    t11 = D_p_y_3*x_3_dot
    t12 = t10 + t11
    v_p_y = t12 + t9
    t13 = D_p_z_1*x_1_dot
    t14 = D_p_z_2*x_2_dot
    t15 = D_p_z_3*x_3_dot
    t16 = t14 + t15
    v_p_z = t13 + t16
    s_dot_1_x = U_1_x_1*x_1_dot + t8
    s_dot_1_y = U_1_y_1*x_1_dot + t12
    s_dot_1_z = U_1_z_1*x_1_dot + t16
    s_dot_2_x = U_2_x_2*x_2_dot + t5 + t7
    s_dot_2_y = U_2_y_2*x_2_dot + t11 + t9
    s_dot_2_z = U_2_z_2*x_2_dot + t13 + t15
    s_dot_3_x = U_3_x_3*x_3_dot + t5 + t6
    s_dot_3_y = U_3_y_3*x_3_dot + t10 + t9
    s_dot_3_z = U_3_z_3*x_3_dot + t13 + t14
    t17 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z
    t18 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z
    t19 = (
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y
        + n_1_z*s_dot_1_z
    )
    D_p_dot_x_1 = t1*(A_x_1*t19 + A_x_2*t17 + A_x_3*t18)
    D_p_dot_y_1 = t1*(A_y_1*t19 + A_y_2*t17 + A_y_3*t18)
    D_p_dot_z_1 = t1*(A_z_1*t19 + A_z_2*t17 + A_z_3*t18)
    t20 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z
    t21 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z
    t22 = (
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y
        + n_2_z*s_dot_2_z
    )
    D_p_dot_x_2 = t1*(A_x_1*t20 + A_x_2*t22 + A_x_3*t21)
    D_p_dot_y_2 = t1*(A_y_1*t20 + A_y_2*t22 + A_y_3*t21)
    D_p_dot_z_2 = t1*(A_z_1*t20 + A_z_2*t22 + A_z_3*t21)
    t23 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z
    t24 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z
    t25 = (
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y
        + n_3_z*s_dot_3_z
    )
    D_p_dot_x_3 = t1*(A_x_1*t23 + A_x_2*t24 + A_x_3*t25)
    D_p_dot_y_3 = t1*(A_y_1*t23 + A_y_2*t24 + A_y_3*t25)
    D_p_dot_z_3 = t1*(A_z_1*t23 + A_z_2*t24 + A_z_3*t25)
    t26 = (1/6)*m_d_1
    t27 = n_1_x*t26
    t28 = (1/6)*m_d_2
    t29 = n_2_x*t28
    t30 = (1/6)*m_d_3
    t31 = n_3_x*t30
    t32 = m_p + 2*t26 + 2*t28 + 2*t30
    t33 = t27*x_1_dot + t29*x_2_dot + t31*x_3_dot + t32*v_p_x
    t34 = n_1_y*t26
    t35 = n_2_y*t28
    t36 = n_3_y*t30
    t37 = t32*v_p_y + t34*x_1_dot + t35*x_2_dot + t36*x_3_dot
    t38 = n_1_z*t26
    t39 = n_2_z*t28
    t40 = n_3_z*t30
    t41 = t32*v_p_z + t38*x_1_dot + t39*x_2_dot + t40*x_3_dot
    t42 = (1/3)*m_d_1 + (1/3)*m_d_2 + (1/3)*m_d_3 + m_p
    t43 = D_p_x_1*t42 + t27
    t44 = D_p_y_1*t42 + t34
    t45 = D_p_z_1*t42 + t38
    t46 = P_x_12*t33 + P_y_12*t37 + P_z_12*t41
    t47 = P_x_13*t33 + P_y_13*t37 + P_z_13*t41
    t48 = D_p_x_2*t42 + t29
    t49 = D_p_y_2*t42 + t35
    t50 = D_p_z_2*t42 + t39
    t51 = P_x_23*t33 + P_y_23*t37 + P_z_23*t41
    t52 = D_p_x_3*t42 + t31
    t53 = D_p_y_3*t42 + t36
    t54 = D_p_z_3*t42 + t40
    h_out = np.empty((*batch, 3), dtype)
    h_out[..., 0] = (
        -D_p_dot_x_1*t33 - D_p_dot_y_1*t37 - D_p_dot_z_1*t41 + x_1_dot*(D_p_dot_x_1*t43 + D_p_dot_y_1*t44
        + D_p_dot_z_1*t45 + P_x_11*t33 + P_y_11*t37 + P_z_11*t41) + x_2_dot*(D_p_dot_x_2*t43 + D_p_dot_y_2*t44
        + D_p_dot_z_2*t45 + t46) + x_3_dot*(D_p_dot_x_3*t43 + D_p_dot_y_3*t44 + D_p_dot_z_3*t45 + t47)
    )
    h_out[..., 1] = (
        -D_p_dot_x_2*t33 - D_p_dot_y_2*t37 - D_p_dot_z_2*t41 + x_1_dot*(D_p_dot_x_1*t48 + D_p_dot_y_1*t49
        + D_p_dot_z_1*t50 + t46) + x_2_dot*(D_p_dot_x_2*t48 + D_p_dot_y_2*t49 + D_p_dot_z_2*t50 + P_x_22*t33
        + P_y_22*t37 + P_z_22*t41) + x_3_dot*(D_p_dot_x_3*t48 + D_p_dot_y_3*t49 + D_p_dot_z_3*t50 + t51)
    )
    h_out[..., 2] = (
        -D_p_dot_x_3*t33 - D_p_dot_y_3*t37 - D_p_dot_z_3*t41 + x_1_dot*(D_p_dot_x_1*t52 + D_p_dot_y_1*t53
        + D_p_dot_z_1*t54 + t47) + x_2_dot*(D_p_dot_x_2*t52 + D_p_dot_y_2*t53 + D_p_dot_z_2*t54 + t51)
        + x_3_dot*(D_p_dot_x_3*t52 + D_p_dot_y_3*t53 + D_p_dot_z_3*t54 + P_x_33*t33 + P_y_33*t37 + P_z_33*t41)
    )
    return h_out


def gravity_potential(p, parameters):
    """Gravitational potential energy V_g = -U_g, with the force function U_g.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    V_g : array, shape (...) [J]
        Zero at the origin of the base frame.

    Notes
    -----
    Equation 26, for gravity in any direction and all moving bodies.
    195 operations; 1368 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    t1 = (1/2)*m_d_1
    t2 = (1/2)*m_d_2
    t3 = (1/2)*m_d_3
    t4 = m_t_1*x_1
    t5 = m_t_2*x_2
    t6 = m_t_3*x_3
    t7 = t1*x_1
    t8 = t2*x_2
    t9 = t3*x_3
    t10 = m_p + t1 + t2 + t3
    V_g_out = np.empty(batch, dtype)
    V_g_out[...] = (
        -g_x*(b_1_x*t1 + b_2_x*t2 + b_3_x*t3 + m_t_1*o_1_x + m_t_2*o_2_x + m_t_3*o_3_x + n_1_x*t4 + n_1_x*t7
        + n_2_x*t5 + n_2_x*t8 + n_3_x*t6 + n_3_x*t9 + o_1_x*t1 + o_2_x*t2 + o_3_x*t3 + p_x*t10)
        - g_y*(b_1_y*t1 + b_2_y*t2 + b_3_y*t3 + m_t_1*o_1_y + m_t_2*o_2_y + m_t_3*o_3_y + n_1_y*t4 + n_1_y*t7
        + n_2_y*t5 + n_2_y*t8 + n_3_y*t6 + n_3_y*t9 + o_1_y*t1 + o_2_y*t2 + o_3_y*t3 + p_y*t10)
        - g_z*(b_1_z*t1 + b_2_z*t2 + b_3_z*t3 + m_t_1*o_1_z + m_t_2*o_2_z + m_t_3*o_3_z + n_1_z*t4 + n_1_z*t7
        + n_2_z*t5 + n_2_z*t8 + n_3_z*t6 + n_3_z*t9 + o_1_z*t1 + o_2_z*t2 + o_3_z*t3 + p_z*t10)
    )
    return V_g_out[()]


def gravity_gradient(p, parameters):
    """Gradient of the gravitational potential energy with respect to the carriage positions.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    G : array, shape (..., 3) [N]
        dV_g/dq_k.

    Notes
    -----
    Equation 27.
    234 operations; 14409 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    t5 = (1/2)*m_d_1
    t6 = (1/2)*m_d_2
    t7 = (1/2)*m_d_3
    t8 = m_p + t5 + t6 + t7
    t9 = g_x*t8
    t10 = g_y*t8
    t11 = g_z*t8
    G_out = np.empty((*batch, 3), dtype)
    G_out[..., 0] = (
        -D_p_x_1*t9 - D_p_y_1*t10 - D_p_z_1*t11 - g_x*(m_t_1*n_1_x + n_1_x*t5) - g_y*(m_t_1*n_1_y + n_1_y*t5)
        - g_z*(m_t_1*n_1_z + n_1_z*t5)
    )
    G_out[..., 1] = (
        -D_p_x_2*t9 - D_p_y_2*t10 - D_p_z_2*t11 - g_x*(m_t_2*n_2_x + n_2_x*t6) - g_y*(m_t_2*n_2_y + n_2_y*t6)
        - g_z*(m_t_2*n_2_z + n_2_z*t6)
    )
    G_out[..., 2] = (
        -D_p_x_3*t9 - D_p_y_3*t10 - D_p_z_3*t11 - g_x*(m_t_3*n_3_x + n_3_x*t7) - g_y*(m_t_3*n_3_y + n_3_y*t7)
        - g_z*(m_t_3*n_3_z + n_3_z*t7)
    )
    return G_out


def gravity_hessian(p, parameters):
    """Hessian of the gravitational potential energy with respect to the carriage positions.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    H_g : array, shape (..., 3, 3) [N/m]
        d2V_g/dq_k dq_l, symmetric.

    Notes
    -----
    Section 4 and equation 49.
    345 operations; 373806 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    t5 = (1/2)*m_d_1 + (1/2)*m_d_2 + (1/2)*m_d_3 + m_p
    t6 = g_x*t5
    t7 = g_y*t5
    t8 = g_z*t5
    mu_1 = t1*(-A_x_1*t6 - A_y_1*t7 - A_z_1*t8)
    mu_2 = t1*(-A_x_2*t6 - A_y_2*t7 - A_z_2*t8)
    mu_3 = t1*(-A_x_3*t6 - A_y_3*t7 - A_z_3*t8)
    t9 = D_p_x_1**2
    t10 = D_p_y_1**2
    t11 = D_p_z_1**2
    t12 = D_p_x_1*mu_3
    t13 = D_p_x_1*mu_2
    t14 = U_1_x_1*mu_1
    t15 = D_p_y_1*mu_3
    t16 = D_p_y_1*mu_2
    t17 = U_1_y_1*mu_1
    t18 = D_p_z_1*mu_3
    t19 = D_p_z_1*mu_2
    t20 = U_1_z_1*mu_1
    t21 = D_p_x_2**2
    t22 = D_p_y_2**2
    t23 = D_p_z_2**2
    t24 = D_p_x_3**2
    t25 = D_p_y_3**2
    t26 = D_p_z_3**2
    H_g_out = np.empty((*batch, 3, 3), dtype)
    H_g_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 - mu_2*t10 - mu_2*t11 - mu_2*t9 - mu_3*t10
        - mu_3*t11 - mu_3*t9
    )
    H_g_out[..., 0, 1] = H_g_out[..., 1, 0] = (
        -D_p_x_2*t12 - D_p_x_2*t14 - D_p_y_2*t15 - D_p_y_2*t17 - D_p_z_2*t18 - D_p_z_2*t20 - U_2_x_2*t13
        - U_2_y_2*t16 - U_2_z_2*t19
    )
    H_g_out[..., 0, 2] = H_g_out[..., 2, 0] = (
        -D_p_x_3*t13 - D_p_x_3*t14 - D_p_y_3*t16 - D_p_y_3*t17 - D_p_z_3*t19 - D_p_z_3*t20 - U_3_x_3*t12
        - U_3_y_3*t15 - U_3_z_3*t18
    )
    H_g_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 - mu_1*t21 - mu_1*t22 - mu_1*t23 - mu_3*t21
        - mu_3*t22 - mu_3*t23
    )
    H_g_out[..., 1, 2] = H_g_out[..., 2, 1] = (
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2
    )
    H_g_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 - mu_1*t24 - mu_1*t25 - mu_1*t26 - mu_2*t24
        - mu_2*t25 - mu_2*t26
    )
    return H_g_out


def belt_stiffness(p, parameters):
    """Stiffnesses of the belt spans.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    k : array, shape (..., 3, 3) [N/m]
        k[j-1, s-1] of span s of belt j, as in `belt_spans`.

    Notes
    -----
    Equations 34 to 37.
    114 operations; 441 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, x_min_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    l_f_1_1 = x_max_1 - x_min_1
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    t2 = (1/2)*l_t_1
    l_f_1_2 = -t2 + x_1 - x_min_1
    k_1_2 = t1/l_f_1_2
    l_f_1_3 = -t2 - x_1 + x_max_1
    k_1_3 = t1/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t3 = k_sp_2*w_b_2
    k_2_1 = t3/l_f_2_1
    t4 = (1/2)*l_t_2
    l_f_2_2 = -t4 + x_2 - x_min_2
    k_2_2 = t3/l_f_2_2
    l_f_2_3 = -t4 - x_2 + x_max_2
    k_2_3 = t3/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t5 = k_sp_3*w_b_3
    k_3_1 = t5/l_f_3_1
    t6 = (1/2)*l_t_3
    l_f_3_2 = -t6 + x_3 - x_min_3
    k_3_2 = t5/l_f_3_2
    l_f_3_3 = -t6 - x_3 + x_max_3
    k_3_3 = t5/l_f_3_3
    k_out = np.empty((*batch, 3, 3), dtype)
    k_out[..., 0, 0] = k_1_1
    k_out[..., 0, 1] = k_1_2
    k_out[..., 0, 2] = k_1_3
    k_out[..., 1, 0] = k_2_1
    k_out[..., 1, 1] = k_2_2
    k_out[..., 1, 2] = k_2_3
    k_out[..., 2, 0] = k_3_1
    k_out[..., 2, 1] = k_3_2
    k_out[..., 2, 2] = k_3_3
    return k_out


def elastic_potential(p, delta_q, parameters):
    """Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    delta_q : array, shape (..., 9) [m, rad]
        Small displacements of the nine generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    V_el : array, shape (...) [J]
        Zero in the reference configuration.

    Notes
    -----
    Equation 38, summed.
    164 operations; 497 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (
        delta_x_1, delta_x_2, delta_x_3, delta_theta_1_1, delta_theta_2_1, delta_theta_3_1, delta_theta_1_2,
        delta_theta_2_2, delta_theta_3_2,
    ) = _entries(delta_q, (9,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, delta_x_1, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, x_min_1,
        sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    l_f_1_1 = x_max_1 - x_min_1
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    t2 = (1/2)*l_t_1
    l_f_1_2 = -t2 + x_1 - x_min_1
    k_1_2 = t1/l_f_1_2
    l_f_1_3 = -t2 - x_1 + x_max_1
    k_1_3 = t1/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t3 = k_sp_2*w_b_2
    k_2_1 = t3/l_f_2_1
    t4 = (1/2)*l_t_2
    l_f_2_2 = -t4 + x_2 - x_min_2
    k_2_2 = t3/l_f_2_2
    l_f_2_3 = -t4 - x_2 + x_max_2
    k_2_3 = t3/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t5 = k_sp_3*w_b_3
    k_3_1 = t5/l_f_3_1
    t6 = (1/2)*l_t_3
    l_f_3_2 = -t6 + x_3 - x_min_3
    k_3_2 = t5/l_f_3_2
    l_f_3_3 = -t6 - x_3 + x_max_3
    k_3_3 = t5/l_f_3_3
    t7 = R_p_3*delta_theta_3_2
    t8 = R_p_1*delta_theta_1_1
    t9 = R_p_2*delta_theta_2_1
    t10 = R_p_3*delta_theta_3_1
    t11 = R_p_1*delta_theta_1_2
    t12 = R_p_2*delta_theta_2_2
    V_el_out = np.empty(batch, dtype)
    V_el_out[...] = (
        (1/2)*k_1_1*(t11 - t8)**2 + (1/2)*k_1_2*(delta_x_1 - t11)**2 + (1/2)*k_1_3*(-delta_x_1 + t8)**2
        + (1/2)*k_2_1*(t12 - t9)**2 + (1/2)*k_2_2*(delta_x_2 - t12)**2 + (1/2)*k_2_3*(-delta_x_2 + t9)**2
        + (1/2)*k_3_1*(-t10 + t7)**2 + (1/2)*k_3_2*(delta_x_3 - t7)**2 + (1/2)*k_3_3*(-delta_x_3 + t10)**2
    )
    return V_el_out[()]


def elastic_gradient(p, delta_q, parameters):
    """Gradient of the elastic potential energy.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    delta_q : array, shape (..., 9) [m, rad]
        Small displacements of the nine generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    E : array, shape (..., 9) [N, N m]
        dV_el/dq.

    Notes
    -----
    Equation 38 differentiated.
    192 operations; 981 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (
        delta_x_1, delta_x_2, delta_x_3, delta_theta_1_1, delta_theta_2_1, delta_theta_3_1, delta_theta_1_2,
        delta_theta_2_2, delta_theta_3_2,
    ) = _entries(delta_q, (9,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, delta_x_1, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, x_min_1,
        sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    l_f_1_1 = x_max_1 - x_min_1
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    t2 = (1/2)*l_t_1
    l_f_1_2 = -t2 + x_1 - x_min_1
    k_1_2 = t1/l_f_1_2
    l_f_1_3 = -t2 - x_1 + x_max_1
    k_1_3 = t1/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t3 = k_sp_2*w_b_2
    k_2_1 = t3/l_f_2_1
    t4 = (1/2)*l_t_2
    l_f_2_2 = -t4 + x_2 - x_min_2
    k_2_2 = t3/l_f_2_2
    l_f_2_3 = -t4 - x_2 + x_max_2
    k_2_3 = t3/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t5 = k_sp_3*w_b_3
    k_3_1 = t5/l_f_3_1
    t6 = (1/2)*l_t_3
    l_f_3_2 = -t6 + x_3 - x_min_3
    k_3_2 = t5/l_f_3_2
    l_f_3_3 = -t6 - x_3 + x_max_3
    k_3_3 = t5/l_f_3_3
    t7 = -2*delta_x_1
    t8 = R_p_1*delta_theta_1_2
    t9 = R_p_1*delta_theta_1_1
    t10 = R_p_2*delta_theta_2_2
    t11 = R_p_2*delta_theta_2_1
    t12 = -2*delta_x_2
    t13 = -2*delta_x_3
    t14 = R_p_3*delta_theta_3_2
    t15 = R_p_3*delta_theta_3_1
    t16 = R_p_1*k_1_1*(t8 - t9)
    t17 = R_p_2*k_2_1*(t10 - t11)
    t18 = R_p_3*k_3_1*(t14 - t15)
    E_out = np.empty((*batch, 9), dtype)
    E_out[..., 0] = (1/2)*k_1_2*(-t7 - 2*t8) + (1/2)*k_1_3*(-t7 - 2*t9)
    E_out[..., 1] = (1/2)*k_2_2*(-2*t10 - t12) + (1/2)*k_2_3*(-2*t11 - t12)
    E_out[..., 2] = (1/2)*k_3_2*(-t13 - 2*t14) + (1/2)*k_3_3*(-t13 - 2*t15)
    E_out[..., 3] = R_p_1*k_1_3*(-delta_x_1 + t9) - t16
    E_out[..., 4] = R_p_2*k_2_3*(-delta_x_2 + t11) - t17
    E_out[..., 5] = R_p_3*k_3_3*(-delta_x_3 + t15) - t18
    E_out[..., 6] = -R_p_1*k_1_2*(delta_x_1 - t8) + t16
    E_out[..., 7] = -R_p_2*k_2_2*(delta_x_2 - t10) + t17
    E_out[..., 8] = -R_p_3*k_3_2*(delta_x_3 - t14) + t18
    return E_out


def elastic_hessian(p, parameters):
    """Hessian of the elastic potential energy.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    H_el : array, shape (..., 9, 9) [N/m, N, N m]
        d2V_el/dq2, symmetric, with three zero eigenvalues.

    Notes
    -----
    Equation 38 differentiated twice.
    150 operations; 1839 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, x_min_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    l_f_1_1 = x_max_1 - x_min_1
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    t2 = (1/2)*l_t_1
    l_f_1_2 = -t2 + x_1 - x_min_1
    k_1_2 = t1/l_f_1_2
    l_f_1_3 = -t2 - x_1 + x_max_1
    k_1_3 = t1/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t3 = k_sp_2*w_b_2
    k_2_1 = t3/l_f_2_1
    t4 = (1/2)*l_t_2
    l_f_2_2 = -t4 + x_2 - x_min_2
    k_2_2 = t3/l_f_2_2
    l_f_2_3 = -t4 - x_2 + x_max_2
    k_2_3 = t3/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t5 = k_sp_3*w_b_3
    k_3_1 = t5/l_f_3_1
    t6 = (1/2)*l_t_3
    l_f_3_2 = -t6 + x_3 - x_min_3
    k_3_2 = t5/l_f_3_2
    l_f_3_3 = -t6 - x_3 + x_max_3
    k_3_3 = t5/l_f_3_3
    t7 = R_p_1**2
    t8 = k_1_1*t7
    t9 = R_p_2**2
    t10 = k_2_1*t9
    t11 = R_p_3**2
    t12 = k_3_1*t11
    H_el_out = np.zeros((*batch, 9, 9), dtype)
    H_el_out[..., 0, 0] = k_1_2 + k_1_3
    H_el_out[..., 0, 3] = H_el_out[..., 3, 0] = -R_p_1*k_1_3
    H_el_out[..., 0, 6] = H_el_out[..., 6, 0] = -R_p_1*k_1_2
    H_el_out[..., 1, 1] = k_2_2 + k_2_3
    H_el_out[..., 1, 4] = H_el_out[..., 4, 1] = -R_p_2*k_2_3
    H_el_out[..., 1, 7] = H_el_out[..., 7, 1] = -R_p_2*k_2_2
    H_el_out[..., 2, 2] = k_3_2 + k_3_3
    H_el_out[..., 2, 5] = H_el_out[..., 5, 2] = -R_p_3*k_3_3
    H_el_out[..., 2, 8] = H_el_out[..., 8, 2] = -R_p_3*k_3_2
    H_el_out[..., 3, 3] = k_1_3*t7 + t8
    H_el_out[..., 3, 6] = H_el_out[..., 6, 3] = -t8
    H_el_out[..., 4, 4] = k_2_3*t9 + t10
    H_el_out[..., 4, 7] = H_el_out[..., 7, 4] = -t10
    H_el_out[..., 5, 5] = k_3_3*t11 + t12
    H_el_out[..., 5, 8] = H_el_out[..., 8, 5] = -t12
    H_el_out[..., 6, 6] = k_1_2*t7 + t8
    H_el_out[..., 7, 7] = k_2_2*t9 + t10
    H_el_out[..., 8, 8] = k_3_2*t11 + t12
    return H_el_out


def static_equilibrium(p, parameters):
    """Drive torques that hold the pose, and the corresponding rotations.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    tau_st : array, shape (..., 3) [N m]
        Torques on the driven rotors, positive in the direction of their rotation.
    theta_st : array, shape (..., 6) [rad]
        Rotations relative to the unstrained transmissions, in the order of the coordinates.

    Notes
    -----
    Equation 44, solved at the pose.
    363 operations; 125757 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, d_1_1, x_min_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    l_f_1_1 = x_max_1 - x_min_1
    t5 = k_sp_1*w_b_1
    k_1_1 = t5/l_f_1_1
    t6 = (1/2)*l_t_1
    l_f_1_2 = -t6 + x_1 - x_min_1
    k_1_2 = t5/l_f_1_2
    l_f_1_3 = -t6 - x_1 + x_max_1
    k_1_3 = t5/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t7 = k_sp_2*w_b_2
    k_2_1 = t7/l_f_2_1
    t8 = (1/2)*l_t_2
    l_f_2_2 = -t8 + x_2 - x_min_2
    k_2_2 = t7/l_f_2_2
    l_f_2_3 = -t8 - x_2 + x_max_2
    k_2_3 = t7/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t9 = k_sp_3*w_b_3
    k_3_1 = t9/l_f_3_1
    t10 = (1/2)*l_t_3
    l_f_3_2 = -t10 + x_3 - x_min_3
    k_3_2 = t9/l_f_3_2
    l_f_3_3 = -t10 - x_3 + x_max_3
    k_3_3 = t9/l_f_3_3
    t11 = (1/2)*m_d_1
    t12 = (1/2)*m_d_2
    t13 = (1/2)*m_d_3
    t14 = m_p + t11 + t12 + t13
    t15 = g_x*t14
    t16 = g_y*t14
    t17 = g_z*t14
    G_1 = (
        -D_p_x_1*t15 - D_p_y_1*t16 - D_p_z_1*t17 - g_x*(m_t_1*n_1_x + n_1_x*t11) - g_y*(m_t_1*n_1_y
        + n_1_y*t11) - g_z*(m_t_1*n_1_z + n_1_z*t11)
    )
    G_2 = (
        -D_p_x_2*t15 - D_p_y_2*t16 - D_p_z_2*t17 - g_x*(m_t_2*n_2_x + n_2_x*t12) - g_y*(m_t_2*n_2_y
        + n_2_y*t12) - g_z*(m_t_2*n_2_z + n_2_z*t12)
    )
    G_3 = (
        -D_p_x_3*t15 - D_p_y_3*t16 - D_p_z_3*t17 - g_x*(m_t_3*n_3_x + n_3_x*t13) - g_y*(m_t_3*n_3_y
        + n_3_y*t13) - g_z*(m_t_3*n_3_z + n_3_z*t13)
    )
    t18 = R_p_1**2
    t19 = k_1_1*t18
    t20 = k_1_3*t18
    t21 = -d_1_1*t19 + d_1_2*(t19 + t20)
    t22 = k_1_2*t18
    t23 = d_1_1*(t19 + t22) - d_1_2*t19
    det_1 = R_p_1*k_1_2*t21 - R_p_1*k_1_3*t23
    t24 = G_1/det_1
    theta_1_1_st = -t23*t24
    theta_1_2_st = t21*t24
    t25 = R_p_2**2
    t26 = k_2_1*t25
    t27 = k_2_3*t25
    t28 = -d_2_1*t26 + d_2_2*(t26 + t27)
    t29 = k_2_2*t25
    t30 = d_2_1*(t26 + t29) - d_2_2*t26
    det_2 = R_p_2*k_2_2*t28 - R_p_2*k_2_3*t30
    t31 = G_2/det_2
    theta_2_1_st = -t30*t31
    theta_2_2_st = t28*t31
    t32 = R_p_3**2
    t33 = k_3_1*t32
    t34 = k_3_3*t32
    t35 = -d_3_1*t33 + d_3_2*(t33 + t34)
    t36 = k_3_2*t32
    t37 = d_3_1*(t33 + t36) - d_3_2*t33
    det_3 = R_p_3*k_3_2*t35 - R_p_3*k_3_3*t37
    t38 = G_3/det_3
    theta_3_1_st = -t37*t38
    theta_3_2_st = t35*t38
    t39 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st)
    tau_st_1 = d_1_1*(t20*theta_1_1_st - t39) + d_1_2*(t22*theta_1_2_st + t39)
    t40 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st)
    tau_st_2 = d_2_1*(t27*theta_2_1_st - t40) + d_2_2*(t29*theta_2_2_st + t40)
    t41 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st)
    tau_st_3 = d_3_1*(t34*theta_3_1_st - t41) + d_3_2*(t36*theta_3_2_st + t41)
    tau_st_out = np.empty((*batch, 3), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    tau_st_out[..., 2] = tau_st_3
    theta_st_out = np.empty((*batch, 6), dtype)
    theta_st_out[..., 0] = theta_1_1_st
    theta_st_out[..., 1] = theta_2_1_st
    theta_st_out[..., 2] = theta_3_1_st
    theta_st_out[..., 3] = theta_1_2_st
    theta_st_out[..., 4] = theta_2_2_st
    theta_st_out[..., 5] = theta_3_2_st
    return tau_st_out, theta_st_out


def stiffness_matrix(p, parameters):
    """Stiffness matrix K in the nine generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    K : array, shape (..., 9, 9) [N/m, N, N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equations 46 and 48: K = -H_U.
    411 operations; 375645 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, l_t_1, k_sp_1, w_b_1, R_p_1,
        x_min_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    l_f_1_1 = x_max_1 - x_min_1
    t5 = k_sp_1*w_b_1
    k_1_1 = t5/l_f_1_1
    t6 = (1/2)*l_t_1
    l_f_1_2 = -t6 + x_1 - x_min_1
    k_1_2 = t5/l_f_1_2
    l_f_1_3 = -t6 - x_1 + x_max_1
    k_1_3 = t5/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t7 = k_sp_2*w_b_2
    k_2_1 = t7/l_f_2_1
    t8 = (1/2)*l_t_2
    l_f_2_2 = -t8 + x_2 - x_min_2
    k_2_2 = t7/l_f_2_2
    l_f_2_3 = -t8 - x_2 + x_max_2
    k_2_3 = t7/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t9 = k_sp_3*w_b_3
    k_3_1 = t9/l_f_3_1
    t10 = (1/2)*l_t_3
    l_f_3_2 = -t10 + x_3 - x_min_3
    k_3_2 = t9/l_f_3_2
    l_f_3_3 = -t10 - x_3 + x_max_3
    k_3_3 = t9/l_f_3_3
    t11 = (1/2)*m_d_1 + (1/2)*m_d_2 + (1/2)*m_d_3 + m_p
    t12 = g_x*t11
    t13 = g_y*t11
    t14 = g_z*t11
    mu_1 = t1*(-A_x_1*t12 - A_y_1*t13 - A_z_1*t14)
    mu_2 = t1*(-A_x_2*t12 - A_y_2*t13 - A_z_2*t14)
    mu_3 = t1*(-A_x_3*t12 - A_y_3*t13 - A_z_3*t14)
    t15 = D_p_x_1**2
    t16 = D_p_y_1**2
    t17 = D_p_z_1**2
    t18 = D_p_x_1*mu_3
    t19 = D_p_x_1*mu_2
    t20 = U_1_x_1*mu_1
    t21 = D_p_y_1*mu_3
    t22 = D_p_y_1*mu_2
    t23 = U_1_y_1*mu_1
    t24 = D_p_z_1*mu_3
    t25 = D_p_z_1*mu_2
    t26 = U_1_z_1*mu_1
    t27 = D_p_x_2**2
    t28 = D_p_y_2**2
    t29 = D_p_z_2**2
    t30 = D_p_x_3**2
    t31 = D_p_y_3**2
    t32 = D_p_z_3**2
    t33 = R_p_1**2
    t34 = k_1_1*t33
    t35 = R_p_2**2
    t36 = k_2_1*t35
    t37 = R_p_3**2
    t38 = k_3_1*t37
    K_out = np.zeros((*batch, 9, 9), dtype)
    K_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 + k_1_2 + k_1_3 - mu_2*t15 - mu_2*t16 - mu_2*t17
        - mu_3*t15 - mu_3*t16 - mu_3*t17
    )
    K_out[..., 0, 1] = K_out[..., 1, 0] = (
        -D_p_x_2*t18 - D_p_x_2*t20 - D_p_y_2*t21 - D_p_y_2*t23 - D_p_z_2*t24 - D_p_z_2*t26 - U_2_x_2*t19
        - U_2_y_2*t22 - U_2_z_2*t25
    )
    K_out[..., 0, 2] = K_out[..., 2, 0] = (
        -D_p_x_3*t19 - D_p_x_3*t20 - D_p_y_3*t22 - D_p_y_3*t23 - D_p_z_3*t25 - D_p_z_3*t26 - U_3_x_3*t18
        - U_3_y_3*t21 - U_3_z_3*t24
    )
    K_out[..., 0, 3] = K_out[..., 3, 0] = -R_p_1*k_1_3
    K_out[..., 0, 6] = K_out[..., 6, 0] = -R_p_1*k_1_2
    K_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 + k_2_2 + k_2_3 - mu_1*t27 - mu_1*t28 - mu_1*t29
        - mu_3*t27 - mu_3*t28 - mu_3*t29
    )
    K_out[..., 1, 2] = K_out[..., 2, 1] = (
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2
    )
    K_out[..., 1, 4] = K_out[..., 4, 1] = -R_p_2*k_2_3
    K_out[..., 1, 7] = K_out[..., 7, 1] = -R_p_2*k_2_2
    K_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 + k_3_2 + k_3_3 - mu_1*t30 - mu_1*t31 - mu_1*t32
        - mu_2*t30 - mu_2*t31 - mu_2*t32
    )
    K_out[..., 2, 5] = K_out[..., 5, 2] = -R_p_3*k_3_3
    K_out[..., 2, 8] = K_out[..., 8, 2] = -R_p_3*k_3_2
    K_out[..., 3, 3] = k_1_3*t33 + t34
    K_out[..., 3, 6] = K_out[..., 6, 3] = -t34
    K_out[..., 4, 4] = k_2_3*t35 + t36
    K_out[..., 4, 7] = K_out[..., 7, 4] = -t36
    K_out[..., 5, 5] = k_3_3*t37 + t38
    K_out[..., 5, 8] = K_out[..., 8, 5] = -t38
    K_out[..., 6, 6] = k_1_2*t33 + t34
    K_out[..., 7, 7] = k_2_2*t35 + t36
    K_out[..., 8, 8] = k_3_2*t37 + t38
    return K_out


def modal_matrices(p, parameters):
    """Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.

    Common intermediate values are evaluated once: call this function for an eigenproblem.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M : array, shape (..., 9, 9) [kg, kg m^2]
        Mass matrix.
    K : array, shape (..., 9, 9) [N/m, N, N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equation 48.
    537 operations; 504567 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    I_p_1, I_p_2, I_p_3 = _entries(parameters.pulley_inertia, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, I_p_1, I_m_1, i_g_1, d_1_1, x_min_1, sigma_1)
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    x_1 = a_1 + sigma_1*np.sqrt(l_d_1**2 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    x_2 = a_2 + sigma_2*np.sqrt(l_d_2**2 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    x_3 = a_3 + sigma_3*np.sqrt(l_d_3**2 - w2_3)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t1 = 1.0/det_D_l
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    t5 = I_m_1*i_g_1**2
    I_1_1 = I_p_1 + d_1_1*t5
    I_1_2 = I_p_1 + d_1_2*t5
    t6 = I_m_2*i_g_2**2
    I_2_1 = I_p_2 + d_2_1*t6
    I_2_2 = I_p_2 + d_2_2*t6
    t7 = I_m_3*i_g_3**2
    I_3_1 = I_p_3 + d_3_1*t7
    I_3_2 = I_p_3 + d_3_2*t7
    l_f_1_1 = x_max_1 - x_min_1
    t8 = k_sp_1*w_b_1
    k_1_1 = t8/l_f_1_1
    t9 = (1/2)*l_t_1
    l_f_1_2 = -t9 + x_1 - x_min_1
    k_1_2 = t8/l_f_1_2
    l_f_1_3 = -t9 - x_1 + x_max_1
    k_1_3 = t8/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t10 = k_sp_2*w_b_2
    k_2_1 = t10/l_f_2_1
    t11 = (1/2)*l_t_2
    l_f_2_2 = -t11 + x_2 - x_min_2
    k_2_2 = t10/l_f_2_2
    l_f_2_3 = -t11 - x_2 + x_max_2
    k_2_3 = t10/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t12 = k_sp_3*w_b_3
    k_3_1 = t12/l_f_3_1
    t13 = (1/2)*l_t_3
    l_f_3_2 = -t13 + x_3 - x_min_3
    k_3_2 = t12/l_f_3_2
    l_f_3_3 = -t13 - x_3 + x_max_3
    k_3_3 = t12/l_f_3_3
    t14 = (1/2)*m_d_1 + (1/2)*m_d_2 + (1/2)*m_d_3 + m_p
    t15 = g_x*t14
    t16 = g_y*t14
    t17 = g_z*t14
    mu_1 = t1*(-A_x_1*t15 - A_y_1*t16 - A_z_1*t17)
    mu_2 = t1*(-A_x_2*t15 - A_y_2*t16 - A_z_2*t17)
    mu_3 = t1*(-A_x_3*t15 - A_y_3*t16 - A_z_3*t17)
    t18 = (1/3)*m_d_1
    t19 = (1/6)*m_d_1
    t20 = n_1_x*t19
    t21 = n_1_y*t19
    t22 = n_1_z*t19
    t23 = (1/3)*m_d_2
    t24 = (1/3)*m_d_3
    t25 = m_p + t18 + t23 + t24
    t26 = D_p_x_1*t25 + t20
    t27 = D_p_y_1*t25 + t21
    t28 = D_p_z_1*t25 + t22
    t29 = (1/6)*m_d_2
    t30 = n_2_x*t29
    t31 = n_2_y*t29
    t32 = n_2_z*t29
    t33 = (1/6)*m_d_3
    t34 = n_3_x*t33
    t35 = n_3_y*t33
    t36 = n_3_z*t33
    t37 = D_p_x_2*t25 + t30
    t38 = D_p_y_2*t25 + t31
    t39 = D_p_z_2*t25 + t32
    t40 = D_p_x_1**2
    t41 = D_p_y_1**2
    t42 = D_p_z_1**2
    t43 = D_p_x_1*mu_3
    t44 = D_p_x_1*mu_2
    t45 = U_1_x_1*mu_1
    t46 = D_p_y_1*mu_3
    t47 = D_p_y_1*mu_2
    t48 = U_1_y_1*mu_1
    t49 = D_p_z_1*mu_3
    t50 = D_p_z_1*mu_2
    t51 = U_1_z_1*mu_1
    t52 = D_p_x_2**2
    t53 = D_p_y_2**2
    t54 = D_p_z_2**2
    t55 = D_p_x_3**2
    t56 = D_p_y_3**2
    t57 = D_p_z_3**2
    t58 = R_p_1**2
    t59 = k_1_1*t58
    t60 = R_p_2**2
    t61 = k_2_1*t60
    t62 = R_p_3**2
    t63 = k_3_1*t62
    M_out = np.zeros((*batch, 9, 9), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t20 + D_p_x_1*t26 + D_p_y_1*t21 + D_p_y_1*t27 + D_p_z_1*t22 + D_p_z_1*t28 + m_t_1 + t18
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_x_1*t30 + D_p_x_2*t26 + D_p_y_1*t31 + D_p_y_2*t27 + D_p_z_1*t32 + D_p_z_2*t28
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_x_1*t34 + D_p_x_3*t26 + D_p_y_1*t35 + D_p_y_3*t27 + D_p_z_1*t36 + D_p_z_3*t28
    )
    M_out[..., 1, 1] = (
        D_p_x_2*t30 + D_p_x_2*t37 + D_p_y_2*t31 + D_p_y_2*t38 + D_p_z_2*t32 + D_p_z_2*t39 + m_t_2 + t23
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_x_2*t34 + D_p_x_3*t37 + D_p_y_2*t35 + D_p_y_3*t38 + D_p_z_2*t36 + D_p_z_3*t39
    )
    M_out[..., 2, 2] = (
        D_p_x_3*t34 + D_p_x_3*(D_p_x_3*t25 + t34) + D_p_y_3*t35 + D_p_y_3*(D_p_y_3*t25 + t35) + D_p_z_3*t36
        + D_p_z_3*(D_p_z_3*t25 + t36) + m_t_3 + t24
    )
    M_out[..., 3, 3] = I_1_1
    M_out[..., 4, 4] = I_2_1
    M_out[..., 5, 5] = I_3_1
    M_out[..., 6, 6] = I_1_2
    M_out[..., 7, 7] = I_2_2
    M_out[..., 8, 8] = I_3_2
    K_out = np.zeros((*batch, 9, 9), dtype)
    K_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 + k_1_2 + k_1_3 - mu_2*t40 - mu_2*t41 - mu_2*t42
        - mu_3*t40 - mu_3*t41 - mu_3*t42
    )
    K_out[..., 0, 1] = K_out[..., 1, 0] = (
        -D_p_x_2*t43 - D_p_x_2*t45 - D_p_y_2*t46 - D_p_y_2*t48 - D_p_z_2*t49 - D_p_z_2*t51 - U_2_x_2*t44
        - U_2_y_2*t47 - U_2_z_2*t50
    )
    K_out[..., 0, 2] = K_out[..., 2, 0] = (
        -D_p_x_3*t44 - D_p_x_3*t45 - D_p_y_3*t47 - D_p_y_3*t48 - D_p_z_3*t50 - D_p_z_3*t51 - U_3_x_3*t43
        - U_3_y_3*t46 - U_3_z_3*t49
    )
    K_out[..., 0, 3] = K_out[..., 3, 0] = -R_p_1*k_1_3
    K_out[..., 0, 6] = K_out[..., 6, 0] = -R_p_1*k_1_2
    K_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 + k_2_2 + k_2_3 - mu_1*t52 - mu_1*t53 - mu_1*t54
        - mu_3*t52 - mu_3*t53 - mu_3*t54
    )
    K_out[..., 1, 2] = K_out[..., 2, 1] = (
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2
    )
    K_out[..., 1, 4] = K_out[..., 4, 1] = -R_p_2*k_2_3
    K_out[..., 1, 7] = K_out[..., 7, 1] = -R_p_2*k_2_2
    K_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 + k_3_2 + k_3_3 - mu_1*t55 - mu_1*t56 - mu_1*t57
        - mu_2*t55 - mu_2*t56 - mu_2*t57
    )
    K_out[..., 2, 5] = K_out[..., 5, 2] = -R_p_3*k_3_3
    K_out[..., 2, 8] = K_out[..., 8, 2] = -R_p_3*k_3_2
    K_out[..., 3, 3] = k_1_3*t58 + t59
    K_out[..., 3, 6] = K_out[..., 6, 3] = -t59
    K_out[..., 4, 4] = k_2_3*t60 + t61
    K_out[..., 4, 7] = K_out[..., 7, 4] = -t61
    K_out[..., 5, 5] = k_3_3*t62 + t63
    K_out[..., 5, 8] = K_out[..., 8, 5] = -t63
    K_out[..., 6, 6] = k_1_2*t58 + t59
    K_out[..., 7, 7] = k_2_2*t60 + t61
    K_out[..., 8, 8] = k_3_2*t62 + t63
    return M_out, K_out
