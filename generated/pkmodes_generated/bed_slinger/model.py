# Generated from the derivation of bed_slinger.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism bed_slinger, for a robot given by its parameters.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: belt j; run s of a belt.  t1, t2, ... are subexpressions shared by several
values.

* tau_st_j [N m]: static torque on motor pulley j
* I_j [kg m^2]: moment of inertia of motor pulley j, including the motor
* l_f_j_s [m]: free length of run s of belt j
* k_j_s [N/m]: stiffness of run s of belt j
* G_j [N]: gradient of the gravitational potential energy with respect to independent coordinate j
* theta_j_st [rad]: static rotation of motor pulley j, relative to the unstrained transmissions
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
    "elastic_gradient",
    "elastic_hessian",
    "elastic_potential",
    "gravity_gradient",
    "gravity_hessian",
    "gravity_potential",
    "inverse_kinematics",
    "kinetic_energy",
    "mass_matrix",
    "modal_matrices",
    "platform_jacobian",
    "platform_jacobian_rate",
    "platform_second_derivatives",
    "run_margin",
    "static_equilibrium",
    "stiffness_matrix",
    "travel_margin",
    "velocity_forces",
]

#: Generalised coordinates, in the order of M and K, and their units.
COORDINATES = (
    "x",
    "y",
    "theta_1",
    "theta_2",
)
COORDINATE_UNITS = (
    "m",
    "m",
    "rad",
    "rad",
)

#: Number of rigid-body modes: motions that strain no elastic part, at any pose and for any parameters.
RIGID_MODES = 2


class Parameters(NamedTuple):
    """Parameters of a robot; every field may have its own leading batch axes.

    Attributes
    ----------
    toolhead_mass : float or array, shape (...) [kg]
        Mass of the tool head.
    bed_mass : float or array, shape (...) [kg]
        Mass of the bed.
    gravity : array, shape (..., 3) [m/s^2]
        Gravitational acceleration g, base frame.
    axis_lengths : array, shape (..., 2, 2) [m]
        Free length of run k of belt j with its slide at 0.
    belt_specific_stiffness : array, shape (..., 2) [N/m]
        Specific stiffness of belt j: k = w_b k_sp / free length.
    belt_width : array, shape (..., 2) [m]
        Width of belt j.
    pulley_radius : array, shape (..., 2) [m]
        Radius of motor pulley j.
    pulley_inertia : array, shape (..., 2) [kg m^2]
        Moment of inertia of motor pulley j.
    motor_inertia : array, shape (..., 2) [kg m^2]
        Moment of inertia of motor j at its shaft.
    gear_ratio : array, shape (..., 2) [1]
        Gear ratio of motor j, motor over pulley.
    workspace : array, shape (..., 2, 2) [m]
        Travel of the tool head along x and of the bed along y.
    """

    toolhead_mass: float
    bed_mass: float
    gravity: np.ndarray
    axis_lengths: np.ndarray
    belt_specific_stiffness: np.ndarray
    belt_width: np.ndarray
    pulley_radius: np.ndarray
    pulley_inertia: np.ndarray
    motor_inertia: np.ndarray
    gear_ratio: np.ndarray
    workspace: np.ndarray


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
    """Positions at a pose.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    xy : array, shape (..., 2) [m]
        Positions x, y.

    Notes
    -----
    The pose itself.
    0 operations; 0 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    batch, dtype = _batch(x)
    xy_out = np.empty((*batch, 2), dtype)
    xy_out[..., 0] = x
    xy_out[..., 1] = y
    return xy_out


def travel_margin(p, parameters):
    """Distance of tool head and bed from the ends of their travel.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 2, 2) [m]
        For x and y: above the lower end and below the upper end.

    Notes
    -----
    Both ends of the workspace.
    4 operations; 4 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    travel_min_x, travel_max_x, travel_min_y, travel_max_y = _entries(parameters.workspace, (2, 2))
    batch, dtype = _batch(x, travel_min_x)
    margin_out = np.empty((*batch, 2, 2), dtype)
    margin_out[..., 0, 0] = -travel_min_x + x
    margin_out[..., 0, 1] = travel_max_x - x
    margin_out[..., 1, 0] = -travel_min_y + y
    margin_out[..., 1, 1] = travel_max_y - y
    return margin_out


def run_margin(parameters):
    """Shortest free length of each run in the whole workspace.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 2, 2) [m]
        For runs 1 and 2 of each belt; must be positive.

    Notes
    -----
    The lengths are linear in x and y, so the shortest is at a corner.
    4 operations; 4 with every named value expanded.
    """
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    travel_min_x, travel_max_x, travel_min_y, travel_max_y = _entries(parameters.workspace, (2, 2))
    batch, dtype = _batch(l_0_1_1, travel_min_x)
    margin_out = np.empty((*batch, 2, 2), dtype)
    margin_out[..., 0, 0] = l_0_1_1 + travel_min_x
    margin_out[..., 0, 1] = l_0_1_2 - travel_max_x
    margin_out[..., 1, 0] = l_0_2_1 + travel_min_y
    margin_out[..., 1, 1] = l_0_2_2 - travel_max_y
    return margin_out


def belt_spans(p, parameters):
    """Free lengths of the belt spans.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    l_f : array, shape (..., 2, 2) [m]
        Free length l_f[j-1, s-1] of span s of belt j.

    Notes
    -----
    Equations 35 to 37; a pose is within the limits if all are positive.
    4 operations; 4 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    batch, dtype = _batch(x, l_0_1_1)
    l_f_1_1 = l_0_1_1 + x
    l_f_1_2 = l_0_1_2 - x
    l_f_2_1 = l_0_2_1 + y
    l_f_2_2 = l_0_2_2 - y
    l_f_out = np.empty((*batch, 2, 2), dtype)
    l_f_out[..., 0, 0] = l_f_1_1
    l_f_out[..., 0, 1] = l_f_1_2
    l_f_out[..., 1, 0] = l_f_2_1
    l_f_out[..., 1, 1] = l_f_2_2
    return l_f_out


def platform_jacobian(p, parameters):
    """Platform Jacobian D_p.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_p : array, shape (..., 2, 2) [1]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15.
    0 operations; 0 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    batch, dtype = _batch(x)
    D_p_out = np.zeros((*batch, 2, 2), dtype)
    D_p_out[..., 0, 0] = 1
    D_p_out[..., 1, 1] = 1
    return D_p_out


def platform_jacobian_rate(p, xy_dot, parameters):
    """Time derivative of the platform Jacobian.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    xy_dot : array, shape (..., 2) [m/s]
        Velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_p_dot : array, shape (..., 2, 2) [1/s]
        d(D_p)/dt at xy_dot.

    Notes
    -----
    Equation 17.
    0 operations; 0 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    x_dot, _ = _entries(xy_dot, (2,))
    batch, dtype = _batch(x, x_dot)
    D_p_dot_out = np.zeros((*batch, 2, 2), dtype)
    return D_p_dot_out


def platform_second_derivatives(p, parameters):
    """Second derivatives of the platform position with respect to the positions.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    P : array, shape (..., 2, 2, 2) [1/m]
        d2p_i/dq_k dq_l as P[i, k, l].

    Notes
    -----
    Equation 49, by the implicit function theorem to second order.
    0 operations; 0 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    batch, dtype = _batch(x)
    P_out = np.zeros((*batch, 2, 2, 2), dtype)
    return P_out


def kinetic_energy(p, q_dot, parameters):
    """Kinetic energies of the structure and of the transmissions.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    q_dot : array, shape (..., 4) [m/s, rad/s]
        Rates of the four generalised coordinates.
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
    20 operations; 20 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    x_dot, y_dot, theta_1_dot, theta_2_dot = _entries(q_dot, (4,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.bed_mass, ())
    I_p_1, I_p_2 = _entries(parameters.pulley_inertia, (2,))
    I_m_1, I_m_2 = _entries(parameters.motor_inertia, (2,))
    i_g_1, i_g_2 = _entries(parameters.gear_ratio, (2,))
    batch, dtype = _batch(x, x_dot, m_h, m_b, I_p_1, I_m_1, i_g_1)
    I_1 = I_m_1*i_g_1**2 + I_p_1
    I_2 = I_m_2*i_g_2**2 + I_p_2
    T_ss_out = np.empty(batch, dtype)
    T_ss_out[...] = (1/2)*m_b*y_dot**2 + (1/2)*m_h*x_dot**2
    T_t_out = np.empty(batch, dtype)
    T_t_out[...] = (1/2)*I_1*theta_1_dot**2 + (1/2)*I_2*theta_2_dot**2
    return T_ss_out[()], T_t_out[()]


def mass_matrix(p, parameters):
    """Mass matrix M in the four generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M : array, shape (..., 4, 4) [kg, kg m^2]
        Symmetric.

    Notes
    -----
    Equations 24, 30 and 33.
    6 operations; 6 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.bed_mass, ())
    I_p_1, I_p_2 = _entries(parameters.pulley_inertia, (2,))
    I_m_1, I_m_2 = _entries(parameters.motor_inertia, (2,))
    i_g_1, i_g_2 = _entries(parameters.gear_ratio, (2,))
    batch, dtype = _batch(x, m_h, m_b, I_p_1, I_m_1, i_g_1)
    I_1 = I_m_1*i_g_1**2 + I_p_1
    I_2 = I_m_2*i_g_2**2 + I_p_2
    M_out = np.zeros((*batch, 4, 4), dtype)
    M_out[..., 0, 0] = m_h
    M_out[..., 1, 1] = m_b
    M_out[..., 2, 2] = I_1
    M_out[..., 3, 3] = I_2
    return M_out


def velocity_forces(p, xy_dot, parameters):
    """Coriolis and centrifugal forces h of M_ss xy_ddot + h + grad V = Q.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    xy_dot : array, shape (..., 2) [m/s]
        Velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    h : array, shape (..., 2) [N]
        Generalised forces conjugate to the positions.

    Notes
    -----
    Lagrange's equations; equation 47 before linearisation.
    0 operations; 0 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    x_dot, _ = _entries(xy_dot, (2,))
    batch, dtype = _batch(x, x_dot)
    h_out = np.zeros((*batch, 2), dtype)
    return h_out


def gravity_potential(p, parameters):
    """Gravitational potential energy V_g = -U_g, with the force function U_g.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    V_g : array, shape (...) [J]
        Zero at the origin of the base frame.

    Notes
    -----
    Equation 26, for gravity in any direction and all moving bodies.
    6 operations; 6 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.bed_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
    batch, dtype = _batch(x, m_h, m_b, g_x)
    V_g_out = np.empty(batch, dtype)
    V_g_out[...] = -g_x*m_h*x - g_y*m_b*y
    return V_g_out[()]


def gravity_gradient(p, parameters):
    """Gradient of the gravitational potential energy with respect to the positions.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    G : array, shape (..., 2) [N]
        dV_g/dq_k.

    Notes
    -----
    Equation 27.
    4 operations; 4 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.bed_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
    batch, dtype = _batch(x, m_h, m_b, g_x)
    G_out = np.empty((*batch, 2), dtype)
    G_out[..., 0] = -g_x*m_h
    G_out[..., 1] = -g_y*m_b
    return G_out


def gravity_hessian(p, parameters):
    """Hessian of the gravitational potential energy with respect to the positions.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    H_g : array, shape (..., 2, 2) [N/m]
        d2V_g/dq_k dq_l, symmetric.

    Notes
    -----
    Section 4 and equation 49.
    0 operations; 0 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    batch, dtype = _batch(x)
    H_g_out = np.zeros((*batch, 2, 2), dtype)
    return H_g_out


def belt_stiffness(p, parameters):
    """Stiffnesses of the belt spans.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    k : array, shape (..., 2, 2) [N/m]
        k[j-1, s-1] of span s of belt j, as in `belt_spans`.

    Notes
    -----
    Equations 34 to 37.
    10 operations; 12 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    batch, dtype = _batch(x, l_0_1_1, k_sp_1, w_b_1)
    l_f_1_1 = l_0_1_1 + x
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t1/l_f_1_2
    l_f_2_1 = l_0_2_1 + y
    t2 = k_sp_2*w_b_2
    k_2_1 = t2/l_f_2_1
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t2/l_f_2_2
    k_out = np.empty((*batch, 2, 2), dtype)
    k_out[..., 0, 0] = k_1_1
    k_out[..., 0, 1] = k_1_2
    k_out[..., 1, 0] = k_2_1
    k_out[..., 1, 1] = k_2_2
    return k_out


def elastic_potential(p, delta_q, parameters):
    """Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    delta_q : array, shape (..., 4) [m, rad]
        Small displacements of the four generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    V_el : array, shape (...) [J]
        Zero in the reference configuration.

    Notes
    -----
    Equation 38, summed.
    25 operations; 35 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    delta_x, delta_y, delta_theta_1, delta_theta_2 = _entries(delta_q, (4,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    batch, dtype = _batch(x, delta_x, l_0_1_1, k_sp_1, w_b_1, R_p_1)
    l_f_1_1 = l_0_1_1 + x
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t1/l_f_1_2
    l_f_2_1 = l_0_2_1 + y
    t2 = k_sp_2*w_b_2
    k_2_1 = t2/l_f_2_1
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t2/l_f_2_2
    t3 = (1/2)*(R_p_1*delta_theta_1 + delta_x)**2
    t4 = (1/2)*(R_p_2*delta_theta_2 + delta_y)**2
    V_el_out = np.empty(batch, dtype)
    V_el_out[...] = k_1_1*t3 + k_1_2*t3 + k_2_1*t4 + k_2_2*t4
    return V_el_out[()]


def elastic_gradient(p, delta_q, parameters):
    """Gradient of the elastic potential energy.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    delta_q : array, shape (..., 4) [m, rad]
        Small displacements of the four generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    E : array, shape (..., 4) [N, N m]
        dV_el/dq.

    Notes
    -----
    Equation 38 differentiated.
    30 operations; 68 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    delta_x, delta_y, delta_theta_1, delta_theta_2 = _entries(delta_q, (4,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    batch, dtype = _batch(x, delta_x, l_0_1_1, k_sp_1, w_b_1, R_p_1)
    l_f_1_1 = l_0_1_1 + x
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t1/l_f_1_2
    l_f_2_1 = l_0_2_1 + y
    t2 = k_sp_2*w_b_2
    k_2_1 = t2/l_f_2_1
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t2/l_f_2_2
    t3 = R_p_1*delta_theta_1
    t4 = delta_x + t3
    t5 = R_p_2*delta_theta_2
    t6 = delta_y + t5
    t7 = R_p_1*(delta_x + t3)
    t8 = R_p_2*(delta_y + t5)
    E_out = np.empty((*batch, 4), dtype)
    E_out[..., 0] = k_1_1*t4 + k_1_2*t4
    E_out[..., 1] = k_2_1*t6 + k_2_2*t6
    E_out[..., 2] = k_1_1*t7 + k_1_2*t7
    E_out[..., 3] = k_2_1*t8 + k_2_2*t8
    return E_out


def elastic_hessian(p, parameters):
    """Hessian of the elastic potential energy.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    H_el : array, shape (..., 4, 4) [N/m, N, N m]
        d2V_el/dq2, symmetric, with two zero eigenvalues.

    Notes
    -----
    Equation 38 differentiated twice.
    26 operations; 72 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    batch, dtype = _batch(x, l_0_1_1, k_sp_1, w_b_1, R_p_1)
    l_f_1_1 = l_0_1_1 + x
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t1/l_f_1_2
    l_f_2_1 = l_0_2_1 + y
    t2 = k_sp_2*w_b_2
    k_2_1 = t2/l_f_2_1
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t2/l_f_2_2
    t3 = R_p_1**2
    t4 = R_p_2**2
    H_el_out = np.zeros((*batch, 4, 4), dtype)
    H_el_out[..., 0, 0] = k_1_1 + k_1_2
    H_el_out[..., 0, 2] = H_el_out[..., 2, 0] = R_p_1*k_1_1 + R_p_1*k_1_2
    H_el_out[..., 1, 1] = k_2_1 + k_2_2
    H_el_out[..., 1, 3] = H_el_out[..., 3, 1] = R_p_2*k_2_1 + R_p_2*k_2_2
    H_el_out[..., 2, 2] = k_1_1*t3 + k_1_2*t3
    H_el_out[..., 3, 3] = k_2_1*t4 + k_2_2*t4
    return H_el_out


def static_equilibrium(p, parameters):
    """Drive torques that hold the pose, and the corresponding rotations.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    tau_st : array, shape (..., 2) [N m]
        Torques on the driven rotors, positive in the direction of their rotation.
    theta_st : array, shape (..., 2) [rad]
        Rotations relative to the unstrained transmissions, in the order of the coordinates.

    Notes
    -----
    Equation 44, solved at the pose.
    34 operations; 104 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.bed_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    batch, dtype = _batch(x, m_h, m_b, g_x, l_0_1_1, k_sp_1, w_b_1, R_p_1)
    l_f_1_1 = l_0_1_1 + x
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t1/l_f_1_2
    l_f_2_1 = l_0_2_1 + y
    t2 = k_sp_2*w_b_2
    k_2_1 = t2/l_f_2_1
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t2/l_f_2_2
    G_1 = -g_x*m_h
    G_2 = -g_y*m_b
    theta_1_st = -G_1/(R_p_1*k_1_1 + R_p_1*k_1_2)
    theta_2_st = -G_2/(R_p_2*k_2_1 + R_p_2*k_2_2)
    t3 = R_p_1**2*theta_1_st
    tau_st_1 = k_1_1*t3 + k_1_2*t3
    t4 = R_p_2**2*theta_2_st
    tau_st_2 = k_2_1*t4 + k_2_2*t4
    tau_st_out = np.empty((*batch, 2), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    theta_st_out = np.empty((*batch, 2), dtype)
    theta_st_out[..., 0] = theta_1_st
    theta_st_out[..., 1] = theta_2_st
    return tau_st_out, theta_st_out


def stiffness_matrix(p, parameters):
    """Stiffness matrix K in the four generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    K : array, shape (..., 4, 4) [N/m, N, N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equations 46 and 48: K = -H_U.
    26 operations; 72 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    batch, dtype = _batch(x, l_0_1_1, k_sp_1, w_b_1, R_p_1)
    l_f_1_1 = l_0_1_1 + x
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t1/l_f_1_2
    l_f_2_1 = l_0_2_1 + y
    t2 = k_sp_2*w_b_2
    k_2_1 = t2/l_f_2_1
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t2/l_f_2_2
    t3 = R_p_1**2
    t4 = R_p_2**2
    K_out = np.zeros((*batch, 4, 4), dtype)
    K_out[..., 0, 0] = k_1_1 + k_1_2
    K_out[..., 0, 2] = K_out[..., 2, 0] = R_p_1*k_1_1 + R_p_1*k_1_2
    K_out[..., 1, 1] = k_2_1 + k_2_2
    K_out[..., 1, 3] = K_out[..., 3, 1] = R_p_2*k_2_1 + R_p_2*k_2_2
    K_out[..., 2, 2] = k_1_1*t3 + k_1_2*t3
    K_out[..., 3, 3] = k_2_1*t4 + k_2_2*t4
    return K_out


def modal_matrices(p, parameters):
    """Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.

    Common intermediate values are evaluated once: call this function for an eigenproblem.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head (x) and bed (y) in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M : array, shape (..., 4, 4) [kg, kg m^2]
        Mass matrix.
    K : array, shape (..., 4, 4) [N/m, N, N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equation 48.
    32 operations; 78 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.bed_mass, ())
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    I_p_1, I_p_2 = _entries(parameters.pulley_inertia, (2,))
    I_m_1, I_m_2 = _entries(parameters.motor_inertia, (2,))
    i_g_1, i_g_2 = _entries(parameters.gear_ratio, (2,))
    batch, dtype = _batch(x, m_h, m_b, l_0_1_1, k_sp_1, w_b_1, R_p_1, I_p_1, I_m_1, i_g_1)
    I_1 = I_m_1*i_g_1**2 + I_p_1
    I_2 = I_m_2*i_g_2**2 + I_p_2
    l_f_1_1 = l_0_1_1 + x
    t1 = k_sp_1*w_b_1
    k_1_1 = t1/l_f_1_1
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t1/l_f_1_2
    l_f_2_1 = l_0_2_1 + y
    t2 = k_sp_2*w_b_2
    k_2_1 = t2/l_f_2_1
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t2/l_f_2_2
    t3 = R_p_1**2
    t4 = R_p_2**2
    M_out = np.zeros((*batch, 4, 4), dtype)
    M_out[..., 0, 0] = m_h
    M_out[..., 1, 1] = m_b
    M_out[..., 2, 2] = I_1
    M_out[..., 3, 3] = I_2
    K_out = np.zeros((*batch, 4, 4), dtype)
    K_out[..., 0, 0] = k_1_1 + k_1_2
    K_out[..., 0, 2] = K_out[..., 2, 0] = R_p_1*k_1_1 + R_p_1*k_1_2
    K_out[..., 1, 1] = k_2_1 + k_2_2
    K_out[..., 1, 3] = K_out[..., 3, 1] = R_p_2*k_2_1 + R_p_2*k_2_2
    K_out[..., 2, 2] = k_1_1*t3 + k_1_2*t3
    K_out[..., 3, 3] = k_2_1*t4 + k_2_2*t4
    return M_out, K_out
