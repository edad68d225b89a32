# Generated from the derivation of hexaglide.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism hexaglide, for a robot given by its parameters.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; coordinate l of a second
derivative; belt span s; component i = x, y, z; rows r of a minor; columns c of a minor; axis a of the
platform.  t1, t2, ... are subexpressions shared by several values.

* w_p_i [rad/s]: angular velocity of the platform, component i
* half_angle [rad]: half the angle of rotation
* s_half [1]: sine of half the angle over half the angle
* c_half [1]: cosine of half the angle
* R_i_a [1]: rotation matrix of the platform: component i of its axis a
* x_j [m]: position of carriage j along its rail
* B_j_i [m]: platform joint j from the platform's origin, base frame, component i
* r_j_i [m]: platform joint j relative to the origin of rail j, component i
* s_j_i [m]: linkage vector j, from carriage to platform joint, component i
* a_j [m]: coordinate of platform joint j along rail j
* w_j_i [m]: vector from rail j to platform joint j, perpendicular to it, component i
* w2_j [m^2]: squared distance of platform joint j from rail j
* c_i [m]: centre of mass of the platform from its origin, component i
* J_i_a [kg m^2]: inertia tensor of the platform about its centre of mass, base frame, entry ia
* tau_st_j [N m]: static torque on the driven pulley of axis j
* I_j_k [kg m^2]: moment of inertia of pulley k of axis j, including the motor if it is driven
* l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* v_p_i [m/s]: velocity of the platform, component i
* D_l_j_i [m^2]: moment of linkage vector j about the platform's origin, component i
* D_r_j [m]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^8]: adjugate of D_l, entry i, j
* minor_r_c [m^2]: minor of D_l, rows r and columns c
* minor_r_c [m^4]: minor of D_l, rows r and columns c
* minor_r_c [m^6]: minor of D_l, rows r and columns c
* minor_r_c [m^3]: minor of D_l, rows r and columns c
* minor_r_c [m^5]: minor of D_l, rows r and columns c
* A_i_j [m^7]: adjugate of D_l, entry i, j
* det_D_l [m^9]: determinant of D_l
* D_p_i_k [1]: platform Jacobian, dp_i/dx_k
* D_p_i_k [1/m]: platform Jacobian, dp_i/dx_k
* U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
* f_j_kl [1]: right-hand side of closure j, differentiated with respect to x_k and x_l
* P_i_kl [1/m]: second derivative of p_i with respect to x_k and x_l
* P_i_kl [1/m^2]: second derivative of p_i with respect to x_k and x_l
* s_dot_j_i [m/s]: rate of change of linkage vector j, component i
* D_p_dot_i_k [1/s]: time derivative of dp_i/dx_k
* D_p_dot_i_k [1/(m s)]: time derivative of dp_i/dx_k
* D_l_dot_j_i [m^2/s]: rate of change of the moment of linkage vector j, component i
* G_p_i [N]: gradient of the gravitational potential energy with respect to the platform, component i
* G_p_i [N m]: gradient of the gravitational potential energy with respect to the platform, component i
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* g_j_i [N]: derivative of gravity and closures with respect to vector j that turns, component i
* L_i_a [N/m]: second derivative of gravity and closures with respect to the platform, entry i, a
* L_i_a [N]: second derivative of gravity and closures with respect to the platform, entry i, a
* L_i_a [N m]: second derivative of gravity and closures with respect to the platform, entry i, a
* f_i_k [N/m]: force on the platform along i per unit of coordinate k
* f_i_k [N]: force on the platform along i per unit of coordinate k
* G_j [N]: gradient of the gravitational potential energy with respect to x_j
* det_j [N^2 m]: determinant of the equilibrium equations of axis j
* theta_j_k_st [rad]: static rotation of pulley k of axis j, relative to the unstrained transmissions
* M_p_i_a [kg]: apparent mass of the platform, entry i, a
* M_p_i_a [kg m]: apparent mass of the platform, entry i, a
* M_p_i_a [kg m^2]: apparent mass of the platform, entry i, a
* h_i_k [kg]: momentum of the platform along i per unit rate of coordinate k
* h_i_k [kg m]: momentum of the platform along i per unit rate of coordinate k
* a_p_i [m/s^2]: acceleration of the platform at constant rates of the coordinates, component i
* a_p_i [rad/s^2]: acceleration of the platform at constant rates of the coordinates, component i
* pi_i [kg m^2/s]: momentum of the moving bodies, component i
* z_i [N]: force of the moving bodies, component i
* z_i [N m]: force of the moving bodies, component i
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
    "elastic_gradient",
    "elastic_hessian",
    "elastic_potential",
    "gravity_gradient",
    "gravity_hessian",
    "gravity_potential",
    "inertia_margin",
    "inverse_kinematics",
    "jacobian_condition",
    "joint_line_margin",
    "kinetic_energy",
    "leg_margin",
    "link_jacobians",
    "mass_matrix",
    "modal_matrices",
    "platform_jacobian",
    "platform_jacobian_rate",
    "platform_joints",
    "platform_second_derivatives",
    "reach_margin",
    "rotation_margin",
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
    "x_4",
    "x_5",
    "x_6",
    "theta_1_1",
    "theta_2_1",
    "theta_3_1",
    "theta_4_1",
    "theta_5_1",
    "theta_6_1",
    "theta_1_2",
    "theta_2_2",
    "theta_3_2",
    "theta_4_2",
    "theta_5_2",
    "theta_6_2",
)
COORDINATE_UNITS = (
    "m",
    "m",
    "m",
    "m",
    "m",
    "m",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
)

#: Number of rigid-body modes: motions that strain no elastic part, at any pose and for any parameters.
RIGID_MODES = 6


class Parameters(NamedTuple):
    """Parameters of a robot; every field may have its own leading batch axes.

    Attributes
    ----------
    platform_mass : float or array, shape (...) [kg]
        Platform mass.
    platform_center : array, shape (..., 3) [m]
        Centre of mass of the platform from its origin in platform axes.
    platform_inertia : array, shape (..., 3) [kg m^2]
        Moment of inertia of the platform about its centre of mass in platform axes.
    platform_products : array, shape (..., 3) [kg m^2]
        Entry of the platform's inertia tensor about its centre of mass in platform axes.
    gravity : array, shape (..., 3) [m/s^2]
        Gravitational acceleration g, base frame.
    origin : array, shape (..., 6, 3) [m]
        Point of rail j where x_j = 0.
    direction : array, shape (..., 6, 3) [1]
        Unit vector along rail j.
    joint : array, shape (..., 6, 3) [m]
        Platform joint j from the platform's origin in platform axes.
    link_length : array, shape (..., 6) [m]
        Length of rod j.
    link_mass : array, shape (..., 6) [kg]
        Mass of rod j.
    carriage_mass : array, shape (..., 6) [kg]
        Mass of carriage j.
    carriage_length : array, shape (..., 6) [m]
        Length of carriage j along its rail.
    belt_specific_stiffness : array, shape (..., 6) [N/m]
        Specific stiffness of belt j: k = w_b k_sp / free length.
    belt_width : array, shape (..., 6) [m]
        Width of belt j.
    pulley_radius : array, shape (..., 6) [m]
        Radius of the pulleys of axis j.
    pulley_inertia : array, shape (..., 6) [kg m^2]
        Moment of inertia of each pulley of axis j.
    motor_inertia : array, shape (..., 6) [kg m^2]
        Moment of inertia of motor j at the motor shaft.
    gear_ratio : array, shape (..., 6) [1]
        Gear ratio of axis j, motor over driven pulley.
    drive : array, shape (..., 6, 2) [1]
        1 if the motor drives pulley k of axis j, else 0.
    limits : array, shape (..., 6, 2) [m]
        min(x_j), max(x_j): pulley 2 is at min, pulley 1 at max.
    branch : array, shape (..., 6) [1]
        Branch of axis j: +1 if the carriage is ahead of the platform joint along the rail, -1 if behind.
    """

    platform_mass: float
    platform_center: np.ndarray
    platform_inertia: np.ndarray
    platform_products: np.ndarray
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
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    x : array, shape (..., 6) [m]
        Carriage positions x_1, x_2, x_3, x_4, x_5, x_6.

    Notes
    -----
    Equations 1 to 3.
    306 operations; 13632 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    x_out = np.empty((*batch, 6), dtype)
    x_out[..., 0] = x_1
    x_out[..., 1] = x_2
    x_out[..., 2] = x_3
    x_out[..., 3] = x_4
    x_out[..., 4] = x_5
    x_out[..., 5] = x_6
    return x_out


def inertia_margin(parameters):
    """Whether the platform's inertia is that of a body.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 7) [1]
        None is negative for a body.

    Notes
    -----
    Principal minors of its second moments of mass, divided by powers of the trace.
    96 operations; 162 with every named value expanded.
    """
    I_p_x, I_p_y, I_p_z = _entries(parameters.platform_inertia, (3,))
    I_p_xy, I_p_xz, I_p_yz = _entries(parameters.platform_products, (3,))
    batch, dtype = _batch(I_p_x, I_p_xy)
    t1 = I_p_x + I_p_y + I_p_z
    t2 = 1.0/t1
    t3 = (1/2)*I_p_x
    t4 = (1/2)*I_p_y
    t5 = (1/2)*I_p_z
    t6 = -t3 + t4 + t5
    t7 = t3 - t4 + t5
    t8 = t3 + t4 - t5
    t9 = 1.0/(t1**2)
    t10 = I_p_xy**2
    t11 = I_p_xz**2
    t12 = I_p_yz**2
    t13 = I_p_y**2
    t14 = I_p_z**2
    t15 = I_p_x**2
    margin_out = np.empty((*batch, 7), dtype)
    margin_out[..., 0] = t2*t6 + 1e-09
    margin_out[..., 1] = t2*t7 + 1e-09
    margin_out[..., 2] = t2*t8 + 1e-09
    margin_out[..., 3] = t9*(-t10 + t6*t7) + 1e-09
    margin_out[..., 4] = t9*(-t11 + t6*t8) + 1e-09
    margin_out[..., 5] = t9*(-t12 + t7*t8) + 1e-09
    margin_out[..., 6] = (
        1e-09 + (-1/8*I_p_x**3 - 1/4*I_p_x*I_p_y*I_p_z + (1/2)*I_p_x*t12 + (1/8)*I_p_x*t13 + (1/8)*I_p_x*t14
        - 2*I_p_xy*I_p_xz*I_p_yz - 1/8*I_p_y**3 + (1/2)*I_p_y*t11 + (1/8)*I_p_y*t14 + (1/8)*I_p_y*t15
        - 1/8*I_p_z**3 + (1/2)*I_p_z*t10 + (1/8)*I_p_z*t13 + (1/8)*I_p_z*t15 - t10*t3 - t10*t4 - t11*t3
        - t11*t5 - t12*t4 - t12*t5)/t1**3
    )
    return margin_out


def rotation_margin(p, parameters):
    """By how much the rotation of the platform is less than 90 degrees.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (...) [rad]
        Positive for a rotation below 90 degrees.

    Notes
    -----
    The norm of the rotation vector.
    9 operations; 9 with every named value expanded.
    """
    p_x, _, _, rot_x, rot_y, rot_z = _entries(p, (6,))
    batch, dtype = _batch(p_x)
    margin_out = np.empty(batch, dtype)
    margin_out[...] = -np.sqrt(rot_x**2 + rot_y**2 + rot_z**2) + (1/2)*np.pi
    return margin_out[()]


def joint_line_margin(parameters):
    """Whether the joints on the platform do not lie in a line.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (...) [m^4]
        Positive for points that span a plane.

    Notes
    -----
    Second invariant of their second moments about their mean.
    202 operations; 982 with every named value expanded.
    """
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    batch, dtype = _batch(b_1_x)
    t1 = (1/6)*b_3_x
    t2 = (1/6)*b_5_x
    t3 = (1/6)*b_1_x
    t4 = (1/6)*b_2_x
    t5 = (1/6)*b_6_x
    t6 = t2 + t3 + t4 + t5
    t7 = (5/6)*b_4_x - t1 - t6
    t8 = (1/6)*b_4_x
    t9 = (5/6)*b_3_x - t6 - t8
    t10 = t1 + t2 + t5 + t8
    t11 = (5/6)*b_2_x - t10 - t3
    t12 = (5/6)*b_1_x - t10 - t4
    t13 = t1 + t3 + t4 + t8
    t14 = (5/6)*b_6_x - t13 - t2
    t15 = (5/6)*b_5_x - t13 - t5
    t16 = t11**2 + t12**2 + t14**2 + t15**2 + t7**2 + t9**2
    t17 = (1/6)*b_5_y
    t18 = (1/6)*b_1_y
    t19 = (1/6)*b_2_y
    t20 = (1/6)*b_3_y
    t21 = (1/6)*b_4_y
    t22 = t18 + t19 + t20 + t21
    t23 = (5/6)*b_6_y - t17 - t22
    t24 = (1/6)*b_6_y
    t25 = (5/6)*b_5_y - t22 - t24
    t26 = t17 + t18 + t19 + t24
    t27 = (5/6)*b_4_y - t20 - t26
    t28 = (5/6)*b_3_y - t21 - t26
    t29 = t17 + t20 + t21 + t24
    t30 = (5/6)*b_2_y - t18 - t29
    t31 = (5/6)*b_1_y - t19 - t29
    t32 = t23**2 + t25**2 + t27**2 + t28**2 + t30**2 + t31**2
    t33 = (1/6)*b_5_z
    t34 = (1/6)*b_1_z
    t35 = (1/6)*b_2_z
    t36 = (1/6)*b_3_z
    t37 = (1/6)*b_4_z
    t38 = t34 + t35 + t36 + t37
    t39 = (5/6)*b_6_z - t33 - t38
    t40 = (1/6)*b_6_z
    t41 = (5/6)*b_5_z - t38 - t40
    t42 = t33 + t34 + t35 + t40
    t43 = (5/6)*b_4_z - t36 - t42
    t44 = (5/6)*b_3_z - t37 - t42
    t45 = t33 + t36 + t37 + t40
    t46 = (5/6)*b_2_z - t34 - t45
    t47 = (5/6)*b_1_z - t35 - t45
    t48 = t39**2 + t41**2 + t43**2 + t44**2 + t46**2 + t47**2
    margin_out = np.empty(batch, dtype)
    margin_out[...] = (
        -1/2*t16**2 - 1/2*t32**2 - 1/2*t48**2 + 0.499999*(t16 + t32 + t48)**2 - (t11*t30 + t12*t31 + t14*t23
        + t15*t25 + t27*t7 + t28*t9)**2 - (t11*t46 + t12*t47 + t14*t39 + t15*t41 + t43*t7 + t44*t9)**2
        - (t23*t39 + t25*t41 + t27*t43 + t28*t44 + t30*t46 + t31*t47)**2
    )
    return margin_out[()]


def leg_margin(parameters):
    """Whether no two legs coincide.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 15) [m^2]
        Positive for two legs that differ.

    Notes
    -----
    Sums of squared differences; numbers count times the rms distance of the platform joints.
    733 operations; 2280 with every named value expanded.
    """
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = o_1_z - o_2_z
    t2 = o_1_x - o_2_x
    t3 = o_1_y - o_2_y
    t4 = b_3_y**2
    t5 = b_3_z**2
    t6 = b_4_x**2
    t7 = b_4_y**2
    t8 = b_4_z**2
    t9 = b_5_x**2
    t10 = b_5_y**2
    t11 = b_5_z**2
    t12 = b_6_x**2
    t13 = b_6_y**2
    t14 = b_6_z**2
    t15 = b_1_x**2
    t16 = b_1_y**2
    t17 = b_1_z**2
    t18 = b_2_x**2
    t19 = b_2_y**2
    t20 = b_2_z**2
    t21 = b_3_x**2
    t22 = (
        (1/6)*t10 + (1/6)*t11 + (1/6)*t12 + (1/6)*t13 + (1/6)*t14 + (1/6)*t15 + (1/6)*t16 + (1/6)*t17
        + (1/6)*t18 + (1/6)*t19 + (1/6)*t20 + (1/6)*t21 + (1/6)*t4 + (1/6)*t5 + (1/6)*t6 + (1/6)*t7 + (1/6)*t8
        + (1/6)*t9
    )
    t23 = (
        1.6666666666666667e-11*t10 + 1.6666666666666667e-11*t11 + 1.6666666666666667e-11*t12
        + 1.6666666666666667e-11*t13 + 1.6666666666666667e-11*t14 + 1.6666666666666667e-11*t15
        + 1.6666666666666667e-11*t16 + 1.6666666666666667e-11*t17 + 1.6666666666666667e-11*t18
        + 1.6666666666666667e-11*t19 + 1.6666666666666667e-11*t20 + 1.6666666666666667e-11*t21
        + 1.6666666666666667e-11*t4 + 1.6666666666666667e-11*t5 + 1.6666666666666667e-11*t6
        + 1.6666666666666667e-11*t7 + 1.6666666666666667e-11*t8 + 1.6666666666666667e-11*t9
    )
    t24 = o_1_z - o_3_z
    t25 = o_1_x - o_3_x
    t26 = o_1_y - o_3_y
    t27 = o_1_z - o_4_z
    t28 = o_1_x - o_4_x
    t29 = o_1_y - o_4_y
    t30 = o_1_z - o_5_z
    t31 = o_1_x - o_5_x
    t32 = o_1_y - o_5_y
    t33 = o_1_z - o_6_z
    t34 = o_1_x - o_6_x
    t35 = o_1_y - o_6_y
    t36 = o_2_z - o_3_z
    t37 = o_2_x - o_3_x
    t38 = o_2_y - o_3_y
    t39 = o_2_z - o_4_z
    t40 = o_2_x - o_4_x
    t41 = o_2_y - o_4_y
    t42 = o_2_z - o_5_z
    t43 = o_2_x - o_5_x
    t44 = o_2_y - o_5_y
    t45 = o_2_z - o_6_z
    t46 = o_2_x - o_6_x
    t47 = o_2_y - o_6_y
    t48 = o_3_z - o_4_z
    t49 = o_3_x - o_4_x
    t50 = o_3_y - o_4_y
    t51 = o_3_z - o_5_z
    t52 = o_3_x - o_5_x
    t53 = o_3_y - o_5_y
    t54 = o_3_z - o_6_z
    t55 = o_3_x - o_6_x
    t56 = o_3_y - o_6_y
    t57 = o_4_z - o_5_z
    t58 = o_4_x - o_5_x
    t59 = o_4_y - o_5_y
    t60 = o_4_z - o_6_z
    t61 = o_4_x - o_6_x
    t62 = o_4_y - o_6_y
    t63 = o_5_z - o_6_z
    t64 = o_5_x - o_6_x
    t65 = o_5_y - o_6_y
    margin_out = np.empty((*batch, 15), dtype)
    margin_out[..., 0] = (
        t22*((n_1_x - n_2_x)**2 + (n_1_y - n_2_y)**2 + (n_1_z - n_2_z)**2 + (sigma_1 - sigma_2)**2) - t23
        + (b_1_x - b_2_x)**2 + (b_1_y - b_2_y)**2 + (b_1_z - b_2_z)**2 + (l_d_1 - l_d_2)**2 + (n_1_x*t1
        - n_1_z*t2)**2 + (-n_1_x*t3 + n_1_y*t2)**2 + (-n_1_y*t1 + n_1_z*t3)**2
    )
    margin_out[..., 1] = (
        t22*((n_1_x - n_3_x)**2 + (n_1_y - n_3_y)**2 + (n_1_z - n_3_z)**2 + (sigma_1 - sigma_3)**2) - t23
        + (b_1_x - b_3_x)**2 + (b_1_y - b_3_y)**2 + (b_1_z - b_3_z)**2 + (l_d_1 - l_d_3)**2 + (n_1_x*t24
        - n_1_z*t25)**2 + (-n_1_x*t26 + n_1_y*t25)**2 + (-n_1_y*t24 + n_1_z*t26)**2
    )
    margin_out[..., 2] = (
        t22*((n_1_x - n_4_x)**2 + (n_1_y - n_4_y)**2 + (n_1_z - n_4_z)**2 + (sigma_1 - sigma_4)**2) - t23
        + (b_1_x - b_4_x)**2 + (b_1_y - b_4_y)**2 + (b_1_z - b_4_z)**2 + (l_d_1 - l_d_4)**2 + (n_1_x*t27
        - n_1_z*t28)**2 + (-n_1_x*t29 + n_1_y*t28)**2 + (-n_1_y*t27 + n_1_z*t29)**2
    )
    margin_out[..., 3] = (
        t22*((n_1_x - n_5_x)**2 + (n_1_y - n_5_y)**2 + (n_1_z - n_5_z)**2 + (sigma_1 - sigma_5)**2) - t23
        + (b_1_x - b_5_x)**2 + (b_1_y - b_5_y)**2 + (b_1_z - b_5_z)**2 + (l_d_1 - l_d_5)**2 + (n_1_x*t30
        - n_1_z*t31)**2 + (-n_1_x*t32 + n_1_y*t31)**2 + (-n_1_y*t30 + n_1_z*t32)**2
    )
    margin_out[..., 4] = (
        t22*((n_1_x - n_6_x)**2 + (n_1_y - n_6_y)**2 + (n_1_z - n_6_z)**2 + (sigma_1 - sigma_6)**2) - t23
        + (b_1_x - b_6_x)**2 + (b_1_y - b_6_y)**2 + (b_1_z - b_6_z)**2 + (l_d_1 - l_d_6)**2 + (n_1_x*t33
        - n_1_z*t34)**2 + (-n_1_x*t35 + n_1_y*t34)**2 + (-n_1_y*t33 + n_1_z*t35)**2
    )
    margin_out[..., 5] = (
        t22*((n_2_x - n_3_x)**2 + (n_2_y - n_3_y)**2 + (n_2_z - n_3_z)**2 + (sigma_2 - sigma_3)**2) - t23
        + (b_2_x - b_3_x)**2 + (b_2_y - b_3_y)**2 + (b_2_z - b_3_z)**2 + (l_d_2 - l_d_3)**2 + (n_2_x*t36
        - n_2_z*t37)**2 + (-n_2_x*t38 + n_2_y*t37)**2 + (-n_2_y*t36 + n_2_z*t38)**2
    )
    margin_out[..., 6] = (
        t22*((n_2_x - n_4_x)**2 + (n_2_y - n_4_y)**2 + (n_2_z - n_4_z)**2 + (sigma_2 - sigma_4)**2) - t23
        + (b_2_x - b_4_x)**2 + (b_2_y - b_4_y)**2 + (b_2_z - b_4_z)**2 + (l_d_2 - l_d_4)**2 + (n_2_x*t39
        - n_2_z*t40)**2 + (-n_2_x*t41 + n_2_y*t40)**2 + (-n_2_y*t39 + n_2_z*t41)**2
    )
    margin_out[..., 7] = (
        t22*((n_2_x - n_5_x)**2 + (n_2_y - n_5_y)**2 + (n_2_z - n_5_z)**2 + (sigma_2 - sigma_5)**2) - t23
        + (b_2_x - b_5_x)**2 + (b_2_y - b_5_y)**2 + (b_2_z - b_5_z)**2 + (l_d_2 - l_d_5)**2 + (n_2_x*t42
        - n_2_z*t43)**2 + (-n_2_x*t44 + n_2_y*t43)**2 + (-n_2_y*t42 + n_2_z*t44)**2
    )
    margin_out[..., 8] = (
        t22*((n_2_x - n_6_x)**2 + (n_2_y - n_6_y)**2 + (n_2_z - n_6_z)**2 + (sigma_2 - sigma_6)**2) - t23
        + (b_2_x - b_6_x)**2 + (b_2_y - b_6_y)**2 + (b_2_z - b_6_z)**2 + (l_d_2 - l_d_6)**2 + (n_2_x*t45
        - n_2_z*t46)**2 + (-n_2_x*t47 + n_2_y*t46)**2 + (-n_2_y*t45 + n_2_z*t47)**2
    )
    margin_out[..., 9] = (
        t22*((n_3_x - n_4_x)**2 + (n_3_y - n_4_y)**2 + (n_3_z - n_4_z)**2 + (sigma_3 - sigma_4)**2) - t23
        + (b_3_x - b_4_x)**2 + (b_3_y - b_4_y)**2 + (b_3_z - b_4_z)**2 + (l_d_3 - l_d_4)**2 + (n_3_x*t48
        - n_3_z*t49)**2 + (-n_3_x*t50 + n_3_y*t49)**2 + (-n_3_y*t48 + n_3_z*t50)**2
    )
    margin_out[..., 10] = (
        t22*((n_3_x - n_5_x)**2 + (n_3_y - n_5_y)**2 + (n_3_z - n_5_z)**2 + (sigma_3 - sigma_5)**2) - t23
        + (b_3_x - b_5_x)**2 + (b_3_y - b_5_y)**2 + (b_3_z - b_5_z)**2 + (l_d_3 - l_d_5)**2 + (n_3_x*t51
        - n_3_z*t52)**2 + (-n_3_x*t53 + n_3_y*t52)**2 + (-n_3_y*t51 + n_3_z*t53)**2
    )
    margin_out[..., 11] = (
        t22*((n_3_x - n_6_x)**2 + (n_3_y - n_6_y)**2 + (n_3_z - n_6_z)**2 + (sigma_3 - sigma_6)**2) - t23
        + (b_3_x - b_6_x)**2 + (b_3_y - b_6_y)**2 + (b_3_z - b_6_z)**2 + (l_d_3 - l_d_6)**2 + (n_3_x*t54
        - n_3_z*t55)**2 + (-n_3_x*t56 + n_3_y*t55)**2 + (-n_3_y*t54 + n_3_z*t56)**2
    )
    margin_out[..., 12] = (
        t22*((n_4_x - n_5_x)**2 + (n_4_y - n_5_y)**2 + (n_4_z - n_5_z)**2 + (sigma_4 - sigma_5)**2) - t23
        + (b_4_x - b_5_x)**2 + (b_4_y - b_5_y)**2 + (b_4_z - b_5_z)**2 + (l_d_4 - l_d_5)**2 + (n_4_x*t57
        - n_4_z*t58)**2 + (-n_4_x*t59 + n_4_y*t58)**2 + (-n_4_y*t57 + n_4_z*t59)**2
    )
    margin_out[..., 13] = (
        t22*((n_4_x - n_6_x)**2 + (n_4_y - n_6_y)**2 + (n_4_z - n_6_z)**2 + (sigma_4 - sigma_6)**2) - t23
        + (b_4_x - b_6_x)**2 + (b_4_y - b_6_y)**2 + (b_4_z - b_6_z)**2 + (l_d_4 - l_d_6)**2 + (n_4_x*t60
        - n_4_z*t61)**2 + (-n_4_x*t62 + n_4_y*t61)**2 + (-n_4_y*t60 + n_4_z*t62)**2
    )
    margin_out[..., 14] = (
        t22*((n_5_x - n_6_x)**2 + (n_5_y - n_6_y)**2 + (n_5_z - n_6_z)**2 + (sigma_5 - sigma_6)**2) - t23
        + (b_5_x - b_6_x)**2 + (b_5_y - b_6_y)**2 + (b_5_z - b_6_z)**2 + (l_d_5 - l_d_6)**2 + (n_5_x*t63
        - n_5_z*t64)**2 + (-n_5_x*t65 + n_5_y*t64)**2 + (-n_5_y*t63 + n_5_z*t65)**2
    )
    return margin_out


def reach_margin(p, parameters):
    """Distance by which each platform joint could be farther from its rail.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 6) [m]
        Link length minus distance of the platform joint from its rail, for each axis.

    Notes
    -----
    Closure of equation 2; a pose is reachable if every margin is at least zero.
    288 operations; 10902 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    margin_out = np.empty((*batch, 6), dtype)
    margin_out[..., 0] = l_d_1 - np.sqrt(w2_1)
    margin_out[..., 1] = l_d_2 - np.sqrt(w2_2)
    margin_out[..., 2] = l_d_3 - np.sqrt(w2_3)
    margin_out[..., 3] = l_d_4 - np.sqrt(w2_4)
    margin_out[..., 4] = l_d_5 - np.sqrt(w2_5)
    margin_out[..., 5] = l_d_6 - np.sqrt(w2_6)
    return margin_out


def travel_margin(parameters):
    """Sum of the lengths of the two belt spans at each carriage, the same at every pose.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 6) [m]
        Max - min - l_t for each axis; positive for a robot that can move.

    Notes
    -----
    Sum of equations 36 and 37.
    12 operations; 12 with every named value expanded.
    """
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    batch, dtype = _batch(l_t_1, x_min_1)
    margin_out = np.empty((*batch, 6), dtype)
    margin_out[..., 0] = -l_t_1 + x_max_1 - x_min_1
    margin_out[..., 1] = -l_t_2 + x_max_2 - x_min_2
    margin_out[..., 2] = -l_t_3 + x_max_3 - x_min_3
    margin_out[..., 3] = -l_t_4 + x_max_4 - x_min_4
    margin_out[..., 4] = -l_t_5 + x_max_5 - x_min_5
    margin_out[..., 5] = -l_t_6 + x_max_6 - x_min_6
    return margin_out


def belt_spans(p, parameters):
    """Free lengths of the belt spans.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    l_f : array, shape (..., 6, 3) [m]
        Free length l_f[j-1, s-1] of span s of belt j.

    Notes
    -----
    Equations 35 to 37; a pose is within the limits if all are positive.
    342 operations; 27306 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, x_min_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    l_f_1_1 = x_max_1 - x_min_1
    t12 = (1/2)*l_t_1
    l_f_1_2 = -t12 + x_1 - x_min_1
    l_f_1_3 = -t12 - x_1 + x_max_1
    l_f_2_1 = x_max_2 - x_min_2
    t13 = (1/2)*l_t_2
    l_f_2_2 = -t13 + x_2 - x_min_2
    l_f_2_3 = -t13 - x_2 + x_max_2
    l_f_3_1 = x_max_3 - x_min_3
    t14 = (1/2)*l_t_3
    l_f_3_2 = -t14 + x_3 - x_min_3
    l_f_3_3 = -t14 - x_3 + x_max_3
    l_f_4_1 = x_max_4 - x_min_4
    t15 = (1/2)*l_t_4
    l_f_4_2 = -t15 + x_4 - x_min_4
    l_f_4_3 = -t15 - x_4 + x_max_4
    l_f_5_1 = x_max_5 - x_min_5
    t16 = (1/2)*l_t_5
    l_f_5_2 = -t16 + x_5 - x_min_5
    l_f_5_3 = -t16 - x_5 + x_max_5
    l_f_6_1 = x_max_6 - x_min_6
    t17 = (1/2)*l_t_6
    l_f_6_2 = -t17 + x_6 - x_min_6
    l_f_6_3 = -t17 - x_6 + x_max_6
    l_f_out = np.empty((*batch, 6, 3), dtype)
    l_f_out[..., 0, 0] = l_f_1_1
    l_f_out[..., 0, 1] = l_f_1_2
    l_f_out[..., 0, 2] = l_f_1_3
    l_f_out[..., 1, 0] = l_f_2_1
    l_f_out[..., 1, 1] = l_f_2_2
    l_f_out[..., 1, 2] = l_f_2_3
    l_f_out[..., 2, 0] = l_f_3_1
    l_f_out[..., 2, 1] = l_f_3_2
    l_f_out[..., 2, 2] = l_f_3_3
    l_f_out[..., 3, 0] = l_f_4_1
    l_f_out[..., 3, 1] = l_f_4_2
    l_f_out[..., 3, 2] = l_f_4_3
    l_f_out[..., 4, 0] = l_f_5_1
    l_f_out[..., 4, 1] = l_f_5_2
    l_f_out[..., 4, 2] = l_f_5_3
    l_f_out[..., 5, 0] = l_f_6_1
    l_f_out[..., 5, 1] = l_f_6_2
    l_f_out[..., 5, 2] = l_f_6_3
    return l_f_out


def platform_joints(parameters):
    """How the joints lie on the platform: a characteristic length, and their middle.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    length : array, shape (...) [m]
        Root mean square distance of the platform joints from the platform's origin.
    middle : array, shape (..., 3) [m]
        Middle of the platform joints from that origin, platform axes.

    Notes
    -----
    The condition number of D_l, in which the length makes rotations comparable with displacements.
    88 operations; 88 with every named value expanded.
    """
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    batch, dtype = _batch(b_1_x)
    length_out = np.empty(batch, dtype)
    length_out[...] = (
        np.sqrt((1/6)*b_1_x**2 + (1/6)*b_1_y**2 + (1/6)*b_1_z**2 + (1/6)*b_2_x**2 + (1/6)*b_2_y**2
        + (1/6)*b_2_z**2 + (1/6)*b_3_x**2 + (1/6)*b_3_y**2 + (1/6)*b_3_z**2 + (1/6)*b_4_x**2 + (1/6)*b_4_y**2
        + (1/6)*b_4_z**2 + (1/6)*b_5_x**2 + (1/6)*b_5_y**2 + (1/6)*b_5_z**2 + (1/6)*b_6_x**2 + (1/6)*b_6_y**2
        + (1/6)*b_6_z**2)
    )
    middle_out = np.empty((*batch, 3), dtype)
    middle_out[..., 0] = (1/6)*b_1_x + (1/6)*b_2_x + (1/6)*b_3_x + (1/6)*b_4_x + (1/6)*b_5_x + (1/6)*b_6_x
    middle_out[..., 1] = (1/6)*b_1_y + (1/6)*b_2_y + (1/6)*b_3_y + (1/6)*b_4_y + (1/6)*b_5_y + (1/6)*b_6_y
    middle_out[..., 2] = (1/6)*b_1_z + (1/6)*b_2_z + (1/6)*b_3_z + (1/6)*b_4_z + (1/6)*b_5_z + (1/6)*b_6_z
    return length_out[()], middle_out


def constraint_jacobians(p, parameters):
    """Constraint Jacobians D_l and D_r of D_l p_dot = D_r x_dot.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_l : array, shape (..., 6, 6) [m, m^2]
        Row j: linkage vector c_j - e_j in the base frame, and its moment about the platform's origin.
    D_r : array, shape (..., 6, 6) [m]
        Diagonal: component of linkage vector j along the motion of its joint.

    Notes
    -----
    Equations 14 and 15.
    426 operations; 179832 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    D_l_out = np.empty((*batch, 6, 6), dtype)
    D_l_out[..., 0, 0] = s_1_x
    D_l_out[..., 0, 1] = s_1_y
    D_l_out[..., 0, 2] = s_1_z
    D_l_out[..., 0, 3] = D_l_1_rx
    D_l_out[..., 0, 4] = D_l_1_ry
    D_l_out[..., 0, 5] = D_l_1_rz
    D_l_out[..., 1, 0] = s_2_x
    D_l_out[..., 1, 1] = s_2_y
    D_l_out[..., 1, 2] = s_2_z
    D_l_out[..., 1, 3] = D_l_2_rx
    D_l_out[..., 1, 4] = D_l_2_ry
    D_l_out[..., 1, 5] = D_l_2_rz
    D_l_out[..., 2, 0] = s_3_x
    D_l_out[..., 2, 1] = s_3_y
    D_l_out[..., 2, 2] = s_3_z
    D_l_out[..., 2, 3] = D_l_3_rx
    D_l_out[..., 2, 4] = D_l_3_ry
    D_l_out[..., 2, 5] = D_l_3_rz
    D_l_out[..., 3, 0] = s_4_x
    D_l_out[..., 3, 1] = s_4_y
    D_l_out[..., 3, 2] = s_4_z
    D_l_out[..., 3, 3] = D_l_4_rx
    D_l_out[..., 3, 4] = D_l_4_ry
    D_l_out[..., 3, 5] = D_l_4_rz
    D_l_out[..., 4, 0] = s_5_x
    D_l_out[..., 4, 1] = s_5_y
    D_l_out[..., 4, 2] = s_5_z
    D_l_out[..., 4, 3] = D_l_5_rx
    D_l_out[..., 4, 4] = D_l_5_ry
    D_l_out[..., 4, 5] = D_l_5_rz
    D_l_out[..., 5, 0] = s_6_x
    D_l_out[..., 5, 1] = s_6_y
    D_l_out[..., 5, 2] = s_6_z
    D_l_out[..., 5, 3] = D_l_6_rx
    D_l_out[..., 5, 4] = D_l_6_ry
    D_l_out[..., 5, 5] = D_l_6_rz
    D_r_out = np.zeros((*batch, 6, 6), dtype)
    D_r_out[..., 0, 0] = D_r_1
    D_r_out[..., 1, 1] = D_r_2
    D_r_out[..., 2, 2] = D_r_3
    D_r_out[..., 3, 3] = D_r_4
    D_r_out[..., 4, 4] = D_r_5
    D_r_out[..., 5, 5] = D_r_6
    return D_l_out, D_r_out


def jacobian_condition(p, parameters):
    """Assembly branch and condition number of D_l in the Frobenius norm.

    Moments are divided by a characteristic length, the root mean square distance of the platform joints from
    the platform's origin.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    determinant : array, shape (...) [m^9]
        Det D_l; its sign is the assembly branch.
    condition : array, shape (...) [1]
        Frobenius condition number, at least 6.

    Notes
    -----
    Equation 15; |D_l| |D_l^-1|, one to six times the condition number in the 2-norm.
    1817 operations; 186565260 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = (
        (1/6)*B_1_x**2 + (1/6)*B_1_y**2 + (1/6)*B_1_z**2 + (1/6)*B_2_x**2 + (1/6)*B_2_y**2 + (1/6)*B_2_z**2
        + (1/6)*B_3_x**2 + (1/6)*B_3_y**2 + (1/6)*B_3_z**2 + (1/6)*B_4_x**2 + (1/6)*B_4_y**2 + (1/6)*B_4_z**2
        + (1/6)*B_5_x**2 + (1/6)*B_5_y**2 + (1/6)*B_5_z**2 + (1/6)*B_6_x**2 + (1/6)*B_6_y**2 + (1/6)*B_6_z**2
    )
    t13 = 1.0/t12
    t14 = 1.0/(det_D_l**2)
    t15 = t12*t14
    determinant_out = np.empty(batch, dtype)
    determinant_out[...] = det_D_l
    condition_out = np.empty(batch, dtype)
    condition_out[...] = (
        np.sqrt((A_rx_1**2*t15 + A_rx_2**2*t15 + A_rx_3**2*t15 + A_rx_4**2*t15 + A_rx_5**2*t15 + A_rx_6**2*t15
        + A_ry_1**2*t15 + A_ry_2**2*t15 + A_ry_3**2*t15 + A_ry_4**2*t15 + A_ry_5**2*t15 + A_ry_6**2*t15
        + A_rz_1**2*t15 + A_rz_2**2*t15 + A_rz_3**2*t15 + A_rz_4**2*t15 + A_rz_5**2*t15 + A_rz_6**2*t15
        + A_x_1**2*t14 + A_x_2**2*t14 + A_x_3**2*t14 + A_x_4**2*t14 + A_x_5**2*t14 + A_x_6**2*t14
        + A_y_1**2*t14 + A_y_2**2*t14 + A_y_3**2*t14 + A_y_4**2*t14 + A_y_5**2*t14 + A_y_6**2*t14
        + A_z_1**2*t14 + A_z_2**2*t14 + A_z_3**2*t14 + A_z_4**2*t14 + A_z_5**2*t14
        + A_z_6**2*t14)*(D_l_1_rx**2*t13 + D_l_1_ry**2*t13 + D_l_1_rz**2*t13 + D_l_2_rx**2*t13
        + D_l_2_ry**2*t13 + D_l_2_rz**2*t13 + D_l_3_rx**2*t13 + D_l_3_ry**2*t13 + D_l_3_rz**2*t13
        + D_l_4_rx**2*t13 + D_l_4_ry**2*t13 + D_l_4_rz**2*t13 + D_l_5_rx**2*t13 + D_l_5_ry**2*t13
        + D_l_5_rz**2*t13 + D_l_6_rx**2*t13 + D_l_6_ry**2*t13 + D_l_6_rz**2*t13 + s_1_x**2 + s_1_y**2
        + s_1_z**2 + s_2_x**2 + s_2_y**2 + s_2_z**2 + s_3_x**2 + s_3_y**2 + s_3_z**2 + s_4_x**2 + s_4_y**2
        + s_4_z**2 + s_5_x**2 + s_5_y**2 + s_5_z**2 + s_6_x**2 + s_6_y**2 + s_6_z**2))
    )
    return determinant_out[()], condition_out[()]


def platform_jacobian(p, parameters):
    """Platform Jacobian D_p = D_l^-1 D_r.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_p : array, shape (..., 6, 6) [1, 1/m]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15.
    1634 operations; 182257128 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = 1.0/det_D_l
    t13 = D_r_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = D_r_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = D_r_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = D_r_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = D_r_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = D_r_6*t12
    D_p_x_6 = A_x_6*t18
    D_p_y_1 = A_y_1*t13
    D_p_y_2 = A_y_2*t14
    D_p_y_3 = A_y_3*t15
    D_p_y_4 = A_y_4*t16
    D_p_y_5 = A_y_5*t17
    D_p_y_6 = A_y_6*t18
    D_p_z_1 = A_z_1*t13
    D_p_z_2 = A_z_2*t14
    D_p_z_3 = A_z_3*t15
    D_p_z_4 = A_z_4*t16
    D_p_z_5 = A_z_5*t17
    D_p_z_6 = A_z_6*t18
    D_p_rx_1 = A_rx_1*t13
    D_p_rx_2 = A_rx_2*t14
    D_p_rx_3 = A_rx_3*t15
    D_p_rx_4 = A_rx_4*t16
    D_p_rx_5 = A_rx_5*t17
    D_p_rx_6 = A_rx_6*t18
    D_p_ry_1 = A_ry_1*t13
    D_p_ry_2 = A_ry_2*t14
    D_p_ry_3 = A_ry_3*t15
    D_p_ry_4 = A_ry_4*t16
    D_p_ry_5 = A_ry_5*t17
    D_p_ry_6 = A_ry_6*t18
    D_p_rz_1 = A_rz_1*t13
    D_p_rz_2 = A_rz_2*t14
    D_p_rz_3 = A_rz_3*t15
    D_p_rz_4 = A_rz_4*t16
    D_p_rz_5 = A_rz_5*t17
    D_p_rz_6 = A_rz_6*t18
    D_p_out = np.empty((*batch, 6, 6), dtype)
    D_p_out[..., 0, 0] = D_p_x_1
    D_p_out[..., 0, 1] = D_p_x_2
    D_p_out[..., 0, 2] = D_p_x_3
    D_p_out[..., 0, 3] = D_p_x_4
    D_p_out[..., 0, 4] = D_p_x_5
    D_p_out[..., 0, 5] = D_p_x_6
    D_p_out[..., 1, 0] = D_p_y_1
    D_p_out[..., 1, 1] = D_p_y_2
    D_p_out[..., 1, 2] = D_p_y_3
    D_p_out[..., 1, 3] = D_p_y_4
    D_p_out[..., 1, 4] = D_p_y_5
    D_p_out[..., 1, 5] = D_p_y_6
    D_p_out[..., 2, 0] = D_p_z_1
    D_p_out[..., 2, 1] = D_p_z_2
    D_p_out[..., 2, 2] = D_p_z_3
    D_p_out[..., 2, 3] = D_p_z_4
    D_p_out[..., 2, 4] = D_p_z_5
    D_p_out[..., 2, 5] = D_p_z_6
    D_p_out[..., 3, 0] = D_p_rx_1
    D_p_out[..., 3, 1] = D_p_rx_2
    D_p_out[..., 3, 2] = D_p_rx_3
    D_p_out[..., 3, 3] = D_p_rx_4
    D_p_out[..., 3, 4] = D_p_rx_5
    D_p_out[..., 3, 5] = D_p_rx_6
    D_p_out[..., 4, 0] = D_p_ry_1
    D_p_out[..., 4, 1] = D_p_ry_2
    D_p_out[..., 4, 2] = D_p_ry_3
    D_p_out[..., 4, 3] = D_p_ry_4
    D_p_out[..., 4, 4] = D_p_ry_5
    D_p_out[..., 4, 5] = D_p_ry_6
    D_p_out[..., 5, 0] = D_p_rz_1
    D_p_out[..., 5, 1] = D_p_rz_2
    D_p_out[..., 5, 2] = D_p_rz_3
    D_p_out[..., 5, 3] = D_p_rz_4
    D_p_out[..., 5, 4] = D_p_rz_5
    D_p_out[..., 5, 5] = D_p_rz_6
    return D_p_out


def platform_jacobian_rate(p, x_dot, parameters):
    """Time derivative of the platform Jacobian.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    x_dot : array, shape (..., 6) [m/s]
        Carriage velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_p_dot : array, shape (..., 6, 6) [1/s, 1/(m s)]
        d(D_p)/dt at x_dot.

    Notes
    -----
    Equation 17.
    4250 operations; 271189556208 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    x_1_dot, x_2_dot, x_3_dot, x_4_dot, x_5_dot, x_6_dot = _entries(x_dot, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, x_1_dot, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = 1.0/det_D_l
    t13 = D_r_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = D_r_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = D_r_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = D_r_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = D_r_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = D_r_6*t12
    D_p_x_6 = A_x_6*t18
    D_p_y_1 = A_y_1*t13
    D_p_y_2 = A_y_2*t14
    D_p_y_3 = A_y_3*t15
    D_p_y_4 = A_y_4*t16
    D_p_y_5 = A_y_5*t17
    D_p_y_6 = A_y_6*t18
    D_p_z_1 = A_z_1*t13
    D_p_z_2 = A_z_2*t14
    D_p_z_3 = A_z_3*t15
    D_p_z_4 = A_z_4*t16
    D_p_z_5 = A_z_5*t17
    D_p_z_6 = A_z_6*t18
    D_p_rx_1 = A_rx_1*t13
    D_p_rx_2 = A_rx_2*t14
    D_p_rx_3 = A_rx_3*t15
    D_p_rx_4 = A_rx_4*t16
    D_p_rx_5 = A_rx_5*t17
    D_p_rx_6 = A_rx_6*t18
    D_p_ry_1 = A_ry_1*t13
    D_p_ry_2 = A_ry_2*t14
    D_p_ry_3 = A_ry_3*t15
    D_p_ry_4 = A_ry_4*t16
    D_p_ry_5 = A_ry_5*t17
    D_p_ry_6 = A_ry_6*t18
    D_p_rz_1 = A_rz_1*t13
    D_p_rz_2 = A_rz_2*t14
    D_p_rz_3 = A_rz_3*t15
    D_p_rz_4 = A_rz_4*t16
    D_p_rz_5 = A_rz_5*t17
    D_p_rz_6 = A_rz_6*t18
    t19 = B_1_y*D_p_rz_1 - B_1_z*D_p_ry_1
    U_1_x_1 = D_p_x_1 - n_1_x - t19
    t20 = B_1_y*D_p_rz_2
    U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t20
    t21 = B_1_y*D_p_rz_3
    U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t21
    t22 = B_1_y*D_p_rz_4
    U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t22
    t23 = B_1_y*D_p_rz_5
    U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t23
    t24 = B_1_y*D_p_rz_6
    U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t24
    t25 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1
    U_1_y_1 = D_p_y_1 - n_1_y + t25
    t26 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2
    U_1_y_2 = D_p_y_2 + t26
    t27 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3
    U_1_y_3 = D_p_y_3 + t27
    t28 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4
    U_1_y_4 = D_p_y_4 + t28
    t29 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5
    U_1_y_5 = D_p_y_5 + t29
    t30 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6
    U_1_y_6 = D_p_y_6 + t30
    t31 = B_1_x*D_p_ry_1 - B_1_y*D_p_rx_1
    U_1_z_1 = D_p_z_1 - n_1_z - t31
    t32 = B_1_x*D_p_ry_2
    U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t32
    t33 = B_1_x*D_p_ry_3
    U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t33
    t34 = B_1_x*D_p_ry_4
    U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t34
    t35 = B_1_x*D_p_ry_5
    U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t35
    t36 = B_1_x*D_p_ry_6
    U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t36
    t37 = B_2_y*D_p_rz_1
    U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t37
    t38 = B_2_y*D_p_rz_2 - B_2_z*D_p_ry_2
    U_2_x_2 = D_p_x_2 - n_2_x - t38
    t39 = B_2_y*D_p_rz_3
    U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t39
    t40 = B_2_y*D_p_rz_4
    U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t40
    t41 = B_2_y*D_p_rz_5
    U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t41
    t42 = B_2_y*D_p_rz_6
    U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t42
    t43 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1
    U_2_y_1 = D_p_y_1 + t43
    t44 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2
    U_2_y_2 = D_p_y_2 - n_2_y + t44
    t45 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3
    U_2_y_3 = D_p_y_3 + t45
    t46 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4
    U_2_y_4 = D_p_y_4 + t46
    t47 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5
    U_2_y_5 = D_p_y_5 + t47
    t48 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6
    U_2_y_6 = D_p_y_6 + t48
    t49 = B_2_x*D_p_ry_1
    U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t49
    t50 = B_2_x*D_p_ry_2 - B_2_y*D_p_rx_2
    U_2_z_2 = D_p_z_2 - n_2_z - t50
    t51 = B_2_x*D_p_ry_3
    U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t51
    t52 = B_2_x*D_p_ry_4
    U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t52
    t53 = B_2_x*D_p_ry_5
    U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t53
    t54 = B_2_x*D_p_ry_6
    U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t54
    t55 = B_3_y*D_p_rz_1
    U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t55
    t56 = B_3_y*D_p_rz_2
    U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t56
    t57 = B_3_y*D_p_rz_3 - B_3_z*D_p_ry_3
    U_3_x_3 = D_p_x_3 - n_3_x - t57
    t58 = B_3_y*D_p_rz_4
    U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t58
    t59 = B_3_y*D_p_rz_5
    U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t59
    t60 = B_3_y*D_p_rz_6
    U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t60
    t61 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1
    U_3_y_1 = D_p_y_1 + t61
    t62 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2
    U_3_y_2 = D_p_y_2 + t62
    t63 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3
    U_3_y_3 = D_p_y_3 - n_3_y + t63
    t64 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4
    U_3_y_4 = D_p_y_4 + t64
    t65 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5
    U_3_y_5 = D_p_y_5 + t65
    t66 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6
    U_3_y_6 = D_p_y_6 + t66
    t67 = B_3_x*D_p_ry_1
    U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t67
    t68 = B_3_x*D_p_ry_2
    U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t68
    t69 = B_3_x*D_p_ry_3 - B_3_y*D_p_rx_3
    U_3_z_3 = D_p_z_3 - n_3_z - t69
    t70 = B_3_x*D_p_ry_4
    U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t70
    t71 = B_3_x*D_p_ry_5
    U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t71
    t72 = B_3_x*D_p_ry_6
    U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t72
    t73 = B_4_y*D_p_rz_1
    U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t73
    t74 = B_4_y*D_p_rz_2
    U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t74
    t75 = B_4_y*D_p_rz_3
    U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t75
    t76 = B_4_y*D_p_rz_4 - B_4_z*D_p_ry_4
    U_4_x_4 = D_p_x_4 - n_4_x - t76
    t77 = B_4_y*D_p_rz_5
    U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t77
    t78 = B_4_y*D_p_rz_6
    U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t78
    t79 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1
    U_4_y_1 = D_p_y_1 + t79
    t80 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2
    U_4_y_2 = D_p_y_2 + t80
    t81 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3
    U_4_y_3 = D_p_y_3 + t81
    t82 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4
    U_4_y_4 = D_p_y_4 - n_4_y + t82
    t83 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5
    U_4_y_5 = D_p_y_5 + t83
    t84 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6
    U_4_y_6 = D_p_y_6 + t84
    t85 = B_4_x*D_p_ry_1
    U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t85
    t86 = B_4_x*D_p_ry_2
    U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t86
    t87 = B_4_x*D_p_ry_3
    U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t87
    t88 = B_4_x*D_p_ry_4 - B_4_y*D_p_rx_4
    U_4_z_4 = D_p_z_4 - n_4_z - t88
    t89 = B_4_x*D_p_ry_5
    U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t89
    t90 = B_4_x*D_p_ry_6
    U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t90
    t91 = B_5_y*D_p_rz_1
    U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t91
    t92 = B_5_y*D_p_rz_2
    U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t92
    t93 = B_5_y*D_p_rz_3
    U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t93
    t94 = B_5_y*D_p_rz_4
    U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t94
    t95 = B_5_y*D_p_rz_5 - B_5_z*D_p_ry_5
    U_5_x_5 = D_p_x_5 - n_5_x - t95
    t96 = B_5_y*D_p_rz_6
    U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t96
    t97 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1
    U_5_y_1 = D_p_y_1 + t97
    t98 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2
    U_5_y_2 = D_p_y_2 + t98
    t99 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3
    U_5_y_3 = D_p_y_3 + t99
    t100 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4
    U_5_y_4 = D_p_y_4 + t100
    t101 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5
    U_5_y_5 = D_p_y_5 - n_5_y + t101
    t102 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6
    U_5_y_6 = D_p_y_6 + t102
    t103 = B_5_x*D_p_ry_1
    U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t103
    t104 = B_5_x*D_p_ry_2
    U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t104
    t105 = B_5_x*D_p_ry_3
    U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t105
    t106 = B_5_x*D_p_ry_4
    U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t106
    t107 = B_5_x*D_p_ry_5 - B_5_y*D_p_rx_5
    U_5_z_5 = D_p_z_5 - n_5_z - t107
    t108 = B_5_x*D_p_ry_6
    U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t108
    t109 = B_6_y*D_p_rz_1
    U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t109
    t110 = B_6_y*D_p_rz_2
    U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t110
    t111 = B_6_y*D_p_rz_3
    U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t111
    t112 = B_6_y*D_p_rz_4
    U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t112
    t113 = B_6_y*D_p_rz_5
    U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t113
    t114 = B_6_y*D_p_rz_6 - B_6_z*D_p_ry_6
    U_6_x_6 = D_p_x_6 - n_6_x - t114
    t115 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1
    U_6_y_1 = D_p_y_1 + t115
    t116 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2
    U_6_y_2 = D_p_y_2 + t116
    t117 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3
    U_6_y_3 = D_p_y_3 + t117
    t118 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4
    U_6_y_4 = D_p_y_4 + t118
    t119 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5
    U_6_y_5 = D_p_y_5 + t119
    t120 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6
    U_6_y_6 = D_p_y_6 - n_6_y + t120
    t121 = B_6_x*D_p_ry_1
    U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t121
    t122 = B_6_x*D_p_ry_2
    U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t122
    t123 = B_6_x*D_p_ry_3
    U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t123
    t124 = B_6_x*D_p_ry_4
    U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t124
    t125 = B_6_x*D_p_ry_5
    U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t125
    t126 = B_6_x*D_p_ry_6 - B_6_y*D_p_rx_6
    U_6_z_6 = D_p_z_6 - n_6_z - t126
    s_dot_1_x = (
        U_1_x_1*x_1_dot + U_1_x_2*x_2_dot + U_1_x_3*x_3_dot + U_1_x_4*x_4_dot + U_1_x_5*x_5_dot
        + U_1_x_6*x_6_dot
    )
    s_dot_1_y = (
        U_1_y_1*x_1_dot + U_1_y_2*x_2_dot + U_1_y_3*x_3_dot + U_1_y_4*x_4_dot + U_1_y_5*x_5_dot
        + U_1_y_6*x_6_dot
    )
    s_dot_1_z = (
        U_1_z_1*x_1_dot + U_1_z_2*x_2_dot + U_1_z_3*x_3_dot + U_1_z_4*x_4_dot + U_1_z_5*x_5_dot
        + U_1_z_6*x_6_dot
    )
    s_dot_2_x = (
        U_2_x_1*x_1_dot + U_2_x_2*x_2_dot + U_2_x_3*x_3_dot + U_2_x_4*x_4_dot + U_2_x_5*x_5_dot
        + U_2_x_6*x_6_dot
    )
    s_dot_2_y = (
        U_2_y_1*x_1_dot + U_2_y_2*x_2_dot + U_2_y_3*x_3_dot + U_2_y_4*x_4_dot + U_2_y_5*x_5_dot
        + U_2_y_6*x_6_dot
    )
    s_dot_2_z = (
        U_2_z_1*x_1_dot + U_2_z_2*x_2_dot + U_2_z_3*x_3_dot + U_2_z_4*x_4_dot + U_2_z_5*x_5_dot
        + U_2_z_6*x_6_dot
    )
    s_dot_3_x = (
        U_3_x_1*x_1_dot + U_3_x_2*x_2_dot + U_3_x_3*x_3_dot + U_3_x_4*x_4_dot + U_3_x_5*x_5_dot
        + U_3_x_6*x_6_dot
    )
    s_dot_3_y = (
        U_3_y_1*x_1_dot + U_3_y_2*x_2_dot + U_3_y_3*x_3_dot + U_3_y_4*x_4_dot + U_3_y_5*x_5_dot
        + U_3_y_6*x_6_dot
    )
    s_dot_3_z = (
        U_3_z_1*x_1_dot + U_3_z_2*x_2_dot + U_3_z_3*x_3_dot + U_3_z_4*x_4_dot + U_3_z_5*x_5_dot
        + U_3_z_6*x_6_dot
    )
    s_dot_4_x = (
        U_4_x_1*x_1_dot + U_4_x_2*x_2_dot + U_4_x_3*x_3_dot + U_4_x_4*x_4_dot + U_4_x_5*x_5_dot
        + U_4_x_6*x_6_dot
    )
    s_dot_4_y = (
        U_4_y_1*x_1_dot + U_4_y_2*x_2_dot + U_4_y_3*x_3_dot + U_4_y_4*x_4_dot + U_4_y_5*x_5_dot
        + U_4_y_6*x_6_dot
    )
    s_dot_4_z = (
        U_4_z_1*x_1_dot + U_4_z_2*x_2_dot + U_4_z_3*x_3_dot + U_4_z_4*x_4_dot + U_4_z_5*x_5_dot
        + U_4_z_6*x_6_dot
    )
    s_dot_5_x = (
        U_5_x_1*x_1_dot + U_5_x_2*x_2_dot + U_5_x_3*x_3_dot + U_5_x_4*x_4_dot + U_5_x_5*x_5_dot
        + U_5_x_6*x_6_dot
    )
    s_dot_5_y = (
        U_5_y_1*x_1_dot + U_5_y_2*x_2_dot + U_5_y_3*x_3_dot + U_5_y_4*x_4_dot + U_5_y_5*x_5_dot
        + U_5_y_6*x_6_dot
    )
    s_dot_5_z = (
        U_5_z_1*x_1_dot + U_5_z_2*x_2_dot + U_5_z_3*x_3_dot + U_5_z_4*x_4_dot + U_5_z_5*x_5_dot
        + U_5_z_6*x_6_dot
    )
    s_dot_6_x = (
        U_6_x_1*x_1_dot + U_6_x_2*x_2_dot + U_6_x_3*x_3_dot + U_6_x_4*x_4_dot + U_6_x_5*x_5_dot
        + U_6_x_6*x_6_dot
    )
    s_dot_6_y = (
        U_6_y_1*x_1_dot + U_6_y_2*x_2_dot + U_6_y_3*x_3_dot + U_6_y_4*x_4_dot + U_6_y_5*x_5_dot
        + U_6_y_6*x_6_dot
    )
    s_dot_6_z = (
        U_6_z_1*x_1_dot + U_6_z_2*x_2_dot + U_6_z_3*x_3_dot + U_6_z_4*x_4_dot + U_6_z_5*x_5_dot
        + U_6_z_6*x_6_dot
    )
    t127 = B_1_y*D_p_rx_2 - t32
    t128 = B_1_y*D_p_rx_3 - t33
    t129 = B_1_y*D_p_rx_4 - t34
    t130 = B_1_y*D_p_rx_5 - t35
    t131 = B_1_y*D_p_rx_6 - t36
    D_l_dot_1_rx = (
        x_1_dot*(B_1_y*U_1_z_1 - B_1_z*U_1_y_1 + s_1_y*t31 + s_1_z*t25) + x_2_dot*(B_1_y*U_1_z_2
        - B_1_z*U_1_y_2 - s_1_y*t127 + s_1_z*t26) + x_3_dot*(B_1_y*U_1_z_3 - B_1_z*U_1_y_3 - s_1_y*t128
        + s_1_z*t27) + x_4_dot*(B_1_y*U_1_z_4 - B_1_z*U_1_y_4 - s_1_y*t129 + s_1_z*t28)
        + x_5_dot*(B_1_y*U_1_z_5 - B_1_z*U_1_y_5 - s_1_y*t130 + s_1_z*t29) + x_6_dot*(B_1_y*U_1_z_6
        - B_1_z*U_1_y_6 - s_1_y*t131 + s_1_z*t30)
    )
    t132 = B_1_z*D_p_ry_2 - t20
    t133 = B_1_z*D_p_ry_3 - t21
    t134 = B_1_z*D_p_ry_4 - t22
    t135 = B_1_z*D_p_ry_5 - t23
    t136 = B_1_z*D_p_ry_6 - t24
    D_l_dot_1_ry = (
        x_1_dot*(-B_1_x*U_1_z_1 + B_1_z*U_1_x_1 - s_1_x*t31 + s_1_z*t19) + x_2_dot*(-B_1_x*U_1_z_2
        + B_1_z*U_1_x_2 + s_1_x*t127 - s_1_z*t132) + x_3_dot*(-B_1_x*U_1_z_3 + B_1_z*U_1_x_3 + s_1_x*t128
        - s_1_z*t133) + x_4_dot*(-B_1_x*U_1_z_4 + B_1_z*U_1_x_4 + s_1_x*t129 - s_1_z*t134)
        + x_5_dot*(-B_1_x*U_1_z_5 + B_1_z*U_1_x_5 + s_1_x*t130 - s_1_z*t135) + x_6_dot*(-B_1_x*U_1_z_6
        + B_1_z*U_1_x_6 + s_1_x*t131 - s_1_z*t136)
    )
    D_l_dot_1_rz = (
        x_1_dot*(B_1_x*U_1_y_1 - B_1_y*U_1_x_1 - s_1_x*t25 - s_1_y*t19) + x_2_dot*(B_1_x*U_1_y_2
        - B_1_y*U_1_x_2 - s_1_x*t26 + s_1_y*t132) + x_3_dot*(B_1_x*U_1_y_3 - B_1_y*U_1_x_3 - s_1_x*t27
        + s_1_y*t133) + x_4_dot*(B_1_x*U_1_y_4 - B_1_y*U_1_x_4 - s_1_x*t28 + s_1_y*t134)
        + x_5_dot*(B_1_x*U_1_y_5 - B_1_y*U_1_x_5 - s_1_x*t29 + s_1_y*t135) + x_6_dot*(B_1_x*U_1_y_6
        - B_1_y*U_1_x_6 - s_1_x*t30 + s_1_y*t136)
    )
    t137 = B_2_y*D_p_rx_1 - t49
    t138 = B_2_y*D_p_rx_3 - t51
    t139 = B_2_y*D_p_rx_4 - t52
    t140 = B_2_y*D_p_rx_5 - t53
    t141 = B_2_y*D_p_rx_6 - t54
    D_l_dot_2_rx = (
        x_1_dot*(B_2_y*U_2_z_1 - B_2_z*U_2_y_1 - s_2_y*t137 + s_2_z*t43) + x_2_dot*(B_2_y*U_2_z_2
        - B_2_z*U_2_y_2 + s_2_y*t50 + s_2_z*t44) + x_3_dot*(B_2_y*U_2_z_3 - B_2_z*U_2_y_3 - s_2_y*t138
        + s_2_z*t45) + x_4_dot*(B_2_y*U_2_z_4 - B_2_z*U_2_y_4 - s_2_y*t139 + s_2_z*t46)
        + x_5_dot*(B_2_y*U_2_z_5 - B_2_z*U_2_y_5 - s_2_y*t140 + s_2_z*t47) + x_6_dot*(B_2_y*U_2_z_6
        - B_2_z*U_2_y_6 - s_2_y*t141 + s_2_z*t48)
    )
    t142 = B_2_z*D_p_ry_1 - t37
    t143 = B_2_z*D_p_ry_3 - t39
    t144 = B_2_z*D_p_ry_4 - t40
    t145 = B_2_z*D_p_ry_5 - t41
    t146 = B_2_z*D_p_ry_6 - t42
    D_l_dot_2_ry = (
        x_1_dot*(-B_2_x*U_2_z_1 + B_2_z*U_2_x_1 + s_2_x*t137 - s_2_z*t142) + x_2_dot*(-B_2_x*U_2_z_2
        + B_2_z*U_2_x_2 - s_2_x*t50 + s_2_z*t38) + x_3_dot*(-B_2_x*U_2_z_3 + B_2_z*U_2_x_3 + s_2_x*t138
        - s_2_z*t143) + x_4_dot*(-B_2_x*U_2_z_4 + B_2_z*U_2_x_4 + s_2_x*t139 - s_2_z*t144)
        + x_5_dot*(-B_2_x*U_2_z_5 + B_2_z*U_2_x_5 + s_2_x*t140 - s_2_z*t145) + x_6_dot*(-B_2_x*U_2_z_6
        + B_2_z*U_2_x_6 + s_2_x*t141 - s_2_z*t146)
    )
    D_l_dot_2_rz = (
        x_1_dot*(B_2_x*U_2_y_1 - B_2_y*U_2_x_1 - s_2_x*t43 + s_2_y*t142) + x_2_dot*(B_2_x*U_2_y_2
        - B_2_y*U_2_x_2 - s_2_x*t44 - s_2_y*t38) + x_3_dot*(B_2_x*U_2_y_3 - B_2_y*U_2_x_3 - s_2_x*t45
        + s_2_y*t143) + x_4_dot*(B_2_x*U_2_y_4 - B_2_y*U_2_x_4 - s_2_x*t46 + s_2_y*t144)
        + x_5_dot*(B_2_x*U_2_y_5 - B_2_y*U_2_x_5 - s_2_x*t47 + s_2_y*t145) + x_6_dot*(B_2_x*U_2_y_6
        - B_2_y*U_2_x_6 - s_2_x*t48 + s_2_y*t146)
    )
    t147 = B_3_y*D_p_rx_1 - t67
    t148 = B_3_y*D_p_rx_2 - t68
    t149 = B_3_y*D_p_rx_4 - t70
    t150 = B_3_y*D_p_rx_5 - t71
    t151 = B_3_y*D_p_rx_6 - t72
    D_l_dot_3_rx = (
        x_1_dot*(B_3_y*U_3_z_1 - B_3_z*U_3_y_1 - s_3_y*t147 + s_3_z*t61) + x_2_dot*(B_3_y*U_3_z_2
        - B_3_z*U_3_y_2 - s_3_y*t148 + s_3_z*t62) + x_3_dot*(B_3_y*U_3_z_3 - B_3_z*U_3_y_3 + s_3_y*t69
        + s_3_z*t63) + x_4_dot*(B_3_y*U_3_z_4 - B_3_z*U_3_y_4 - s_3_y*t149 + s_3_z*t64)
        + x_5_dot*(B_3_y*U_3_z_5 - B_3_z*U_3_y_5 - s_3_y*t150 + s_3_z*t65) + x_6_dot*(B_3_y*U_3_z_6
        - B_3_z*U_3_y_6 - s_3_y*t151 + s_3_z*t66)
    )
    t152 = B_3_z*D_p_ry_1 - t55
    t153 = B_3_z*D_p_ry_2 - t56
    t154 = B_3_z*D_p_ry_4 - t58
    t155 = B_3_z*D_p_ry_5 - t59
    t156 = B_3_z*D_p_ry_6 - t60
    D_l_dot_3_ry = (
        x_1_dot*(-B_3_x*U_3_z_1 + B_3_z*U_3_x_1 + s_3_x*t147 - s_3_z*t152) + x_2_dot*(-B_3_x*U_3_z_2
        + B_3_z*U_3_x_2 + s_3_x*t148 - s_3_z*t153) + x_3_dot*(-B_3_x*U_3_z_3 + B_3_z*U_3_x_3 - s_3_x*t69
        + s_3_z*t57) + x_4_dot*(-B_3_x*U_3_z_4 + B_3_z*U_3_x_4 + s_3_x*t149 - s_3_z*t154)
        + x_5_dot*(-B_3_x*U_3_z_5 + B_3_z*U_3_x_5 + s_3_x*t150 - s_3_z*t155) + x_6_dot*(-B_3_x*U_3_z_6
        + B_3_z*U_3_x_6 + s_3_x*t151 - s_3_z*t156)
    )
    D_l_dot_3_rz = (
        x_1_dot*(B_3_x*U_3_y_1 - B_3_y*U_3_x_1 - s_3_x*t61 + s_3_y*t152) + x_2_dot*(B_3_x*U_3_y_2
        - B_3_y*U_3_x_2 - s_3_x*t62 + s_3_y*t153) + x_3_dot*(B_3_x*U_3_y_3 - B_3_y*U_3_x_3 - s_3_x*t63
        - s_3_y*t57) + x_4_dot*(B_3_x*U_3_y_4 - B_3_y*U_3_x_4 - s_3_x*t64 + s_3_y*t154)
        + x_5_dot*(B_3_x*U_3_y_5 - B_3_y*U_3_x_5 - s_3_x*t65 + s_3_y*t155) + x_6_dot*(B_3_x*U_3_y_6
        - B_3_y*U_3_x_6 - s_3_x*t66 + s_3_y*t156)
    )
    t157 = B_4_y*D_p_rx_1 - t85
    t158 = B_4_y*D_p_rx_2 - t86
    t159 = B_4_y*D_p_rx_3 - t87
    t160 = B_4_y*D_p_rx_5 - t89
    t161 = B_4_y*D_p_rx_6 - t90
    D_l_dot_4_rx = (
        x_1_dot*(B_4_y*U_4_z_1 - B_4_z*U_4_y_1 - s_4_y*t157 + s_4_z*t79) + x_2_dot*(B_4_y*U_4_z_2
        - B_4_z*U_4_y_2 - s_4_y*t158 + s_4_z*t80) + x_3_dot*(B_4_y*U_4_z_3 - B_4_z*U_4_y_3 - s_4_y*t159
        + s_4_z*t81) + x_4_dot*(B_4_y*U_4_z_4 - B_4_z*U_4_y_4 + s_4_y*t88 + s_4_z*t82)
        + x_5_dot*(B_4_y*U_4_z_5 - B_4_z*U_4_y_5 - s_4_y*t160 + s_4_z*t83) + x_6_dot*(B_4_y*U_4_z_6
        - B_4_z*U_4_y_6 - s_4_y*t161 + s_4_z*t84)
    )
    t162 = B_4_z*D_p_ry_1 - t73
    t163 = B_4_z*D_p_ry_2 - t74
    t164 = B_4_z*D_p_ry_3 - t75
    t165 = B_4_z*D_p_ry_5 - t77
    t166 = B_4_z*D_p_ry_6 - t78
    D_l_dot_4_ry = (
        x_1_dot*(-B_4_x*U_4_z_1 + B_4_z*U_4_x_1 + s_4_x*t157 - s_4_z*t162) + x_2_dot*(-B_4_x*U_4_z_2
        + B_4_z*U_4_x_2 + s_4_x*t158 - s_4_z*t163) + x_3_dot*(-B_4_x*U_4_z_3 + B_4_z*U_4_x_3 + s_4_x*t159
        - s_4_z*t164) + x_4_dot*(-B_4_x*U_4_z_4 + B_4_z*U_4_x_4 - s_4_x*t88 + s_4_z*t76)
        + x_5_dot*(-B_4_x*U_4_z_5 + B_4_z*U_4_x_5 + s_4_x*t160 - s_4_z*t165) + x_6_dot*(-B_4_x*U_4_z_6
        + B_4_z*U_4_x_6 + s_4_x*t161 - s_4_z*t166)
    )
    D_l_dot_4_rz = (
        x_1_dot*(B_4_x*U_4_y_1 - B_4_y*U_4_x_1 - s_4_x*t79 + s_4_y*t162) + x_2_dot*(B_4_x*U_4_y_2
        - B_4_y*U_4_x_2 - s_4_x*t80 + s_4_y*t163) + x_3_dot*(B_4_x*U_4_y_3 - B_4_y*U_4_x_3 - s_4_x*t81
        + s_4_y*t164) + x_4_dot*(B_4_x*U_4_y_4 - B_4_y*U_4_x_4 - s_4_x*t82 - s_4_y*t76)
        + x_5_dot*(B_4_x*U_4_y_5 - B_4_y*U_4_x_5 - s_4_x*t83 + s_4_y*t165) + x_6_dot*(B_4_x*U_4_y_6
        - B_4_y*U_4_x_6 - s_4_x*t84 + s_4_y*t166)
    )
    t167 = B_5_y*D_p_rx_1 - t103
    t168 = B_5_y*D_p_rx_2 - t104
    t169 = B_5_y*D_p_rx_3 - t105
    t170 = B_5_y*D_p_rx_4 - t106
    t171 = B_5_y*D_p_rx_6 - t108
    D_l_dot_5_rx = (
        x_1_dot*(B_5_y*U_5_z_1 - B_5_z*U_5_y_1 - s_5_y*t167 + s_5_z*t97) + x_2_dot*(B_5_y*U_5_z_2
        - B_5_z*U_5_y_2 - s_5_y*t168 + s_5_z*t98) + x_3_dot*(B_5_y*U_5_z_3 - B_5_z*U_5_y_3 - s_5_y*t169
        + s_5_z*t99) + x_4_dot*(B_5_y*U_5_z_4 - B_5_z*U_5_y_4 - s_5_y*t170 + s_5_z*t100)
        + x_5_dot*(B_5_y*U_5_z_5 - B_5_z*U_5_y_5 + s_5_y*t107 + s_5_z*t101) + x_6_dot*(B_5_y*U_5_z_6
        - B_5_z*U_5_y_6 - s_5_y*t171 + s_5_z*t102)
    )
    t172 = B_5_z*D_p_ry_1 - t91
    t173 = B_5_z*D_p_ry_2 - t92
    t174 = B_5_z*D_p_ry_3 - t93
    t175 = B_5_z*D_p_ry_4 - t94
    t176 = B_5_z*D_p_ry_6 - t96
    D_l_dot_5_ry = (
        x_1_dot*(-B_5_x*U_5_z_1 + B_5_z*U_5_x_1 + s_5_x*t167 - s_5_z*t172) + x_2_dot*(-B_5_x*U_5_z_2
        + B_5_z*U_5_x_2 + s_5_x*t168 - s_5_z*t173) + x_3_dot*(-B_5_x*U_5_z_3 + B_5_z*U_5_x_3 + s_5_x*t169
        - s_5_z*t174) + x_4_dot*(-B_5_x*U_5_z_4 + B_5_z*U_5_x_4 + s_5_x*t170 - s_5_z*t175)
        + x_5_dot*(-B_5_x*U_5_z_5 + B_5_z*U_5_x_5 - s_5_x*t107 + s_5_z*t95) + x_6_dot*(-B_5_x*U_5_z_6
        + B_5_z*U_5_x_6 + s_5_x*t171 - s_5_z*t176)
    )
    D_l_dot_5_rz = (
        x_1_dot*(B_5_x*U_5_y_1 - B_5_y*U_5_x_1 - s_5_x*t97 + s_5_y*t172) + x_2_dot*(B_5_x*U_5_y_2
        - B_5_y*U_5_x_2 - s_5_x*t98 + s_5_y*t173) + x_3_dot*(B_5_x*U_5_y_3 - B_5_y*U_5_x_3 - s_5_x*t99
        + s_5_y*t174) + x_4_dot*(B_5_x*U_5_y_4 - B_5_y*U_5_x_4 - s_5_x*t100 + s_5_y*t175)
        + x_5_dot*(B_5_x*U_5_y_5 - B_5_y*U_5_x_5 - s_5_x*t101 - s_5_y*t95) + x_6_dot*(B_5_x*U_5_y_6
        - B_5_y*U_5_x_6 - s_5_x*t102 + s_5_y*t176)
    )
    t177 = B_6_y*D_p_rx_1 - t121
    t178 = B_6_y*D_p_rx_2 - t122
    t179 = B_6_y*D_p_rx_3 - t123
    t180 = B_6_y*D_p_rx_4 - t124
    t181 = B_6_y*D_p_rx_5 - t125
    D_l_dot_6_rx = (
        x_1_dot*(B_6_y*U_6_z_1 - B_6_z*U_6_y_1 - s_6_y*t177 + s_6_z*t115) + x_2_dot*(B_6_y*U_6_z_2
        - B_6_z*U_6_y_2 - s_6_y*t178 + s_6_z*t116) + x_3_dot*(B_6_y*U_6_z_3 - B_6_z*U_6_y_3 - s_6_y*t179
        + s_6_z*t117) + x_4_dot*(B_6_y*U_6_z_4 - B_6_z*U_6_y_4 - s_6_y*t180 + s_6_z*t118)
        + x_5_dot*(B_6_y*U_6_z_5 - B_6_z*U_6_y_5 - s_6_y*t181 + s_6_z*t119) + x_6_dot*(B_6_y*U_6_z_6
        - B_6_z*U_6_y_6 + s_6_y*t126 + s_6_z*t120)
    )
    t182 = B_6_z*D_p_ry_1 - t109
    t183 = B_6_z*D_p_ry_2 - t110
    t184 = B_6_z*D_p_ry_3 - t111
    t185 = B_6_z*D_p_ry_4 - t112
    t186 = B_6_z*D_p_ry_5 - t113
    D_l_dot_6_ry = (
        x_1_dot*(-B_6_x*U_6_z_1 + B_6_z*U_6_x_1 + s_6_x*t177 - s_6_z*t182) + x_2_dot*(-B_6_x*U_6_z_2
        + B_6_z*U_6_x_2 + s_6_x*t178 - s_6_z*t183) + x_3_dot*(-B_6_x*U_6_z_3 + B_6_z*U_6_x_3 + s_6_x*t179
        - s_6_z*t184) + x_4_dot*(-B_6_x*U_6_z_4 + B_6_z*U_6_x_4 + s_6_x*t180 - s_6_z*t185)
        + x_5_dot*(-B_6_x*U_6_z_5 + B_6_z*U_6_x_5 + s_6_x*t181 - s_6_z*t186) + x_6_dot*(-B_6_x*U_6_z_6
        + B_6_z*U_6_x_6 - s_6_x*t126 + s_6_z*t114)
    )
    D_l_dot_6_rz = (
        x_1_dot*(B_6_x*U_6_y_1 - B_6_y*U_6_x_1 - s_6_x*t115 + s_6_y*t182) + x_2_dot*(B_6_x*U_6_y_2
        - B_6_y*U_6_x_2 - s_6_x*t116 + s_6_y*t183) + x_3_dot*(B_6_x*U_6_y_3 - B_6_y*U_6_x_3 - s_6_x*t117
        + s_6_y*t184) + x_4_dot*(B_6_x*U_6_y_4 - B_6_y*U_6_x_4 - s_6_x*t118 + s_6_y*t185)
        + x_5_dot*(B_6_x*U_6_y_5 - B_6_y*U_6_x_5 - s_6_x*t119 + s_6_y*t186) + x_6_dot*(B_6_x*U_6_y_6
        - B_6_y*U_6_x_6 - s_6_x*t120 - s_6_y*t114)
    )
    t187 = (
        -D_l_dot_2_rx*D_p_rx_1 - D_l_dot_2_ry*D_p_ry_1 - D_l_dot_2_rz*D_p_rz_1 - D_p_x_1*s_dot_2_x
        - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z
    )
    t188 = (
        -D_l_dot_3_rx*D_p_rx_1 - D_l_dot_3_ry*D_p_ry_1 - D_l_dot_3_rz*D_p_rz_1 - D_p_x_1*s_dot_3_x
        - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z
    )
    t189 = (
        -D_l_dot_4_rx*D_p_rx_1 - D_l_dot_4_ry*D_p_ry_1 - D_l_dot_4_rz*D_p_rz_1 - D_p_x_1*s_dot_4_x
        - D_p_y_1*s_dot_4_y - D_p_z_1*s_dot_4_z
    )
    t190 = (
        -D_l_dot_5_rx*D_p_rx_1 - D_l_dot_5_ry*D_p_ry_1 - D_l_dot_5_rz*D_p_rz_1 - D_p_x_1*s_dot_5_x
        - D_p_y_1*s_dot_5_y - D_p_z_1*s_dot_5_z
    )
    t191 = (
        -D_l_dot_6_rx*D_p_rx_1 - D_l_dot_6_ry*D_p_ry_1 - D_l_dot_6_rz*D_p_rz_1 - D_p_x_1*s_dot_6_x
        - D_p_y_1*s_dot_6_y - D_p_z_1*s_dot_6_z
    )
    t192 = (
        -D_l_dot_1_rx*D_p_rx_1 - D_l_dot_1_ry*D_p_ry_1 - D_l_dot_1_rz*D_p_rz_1 - D_p_x_1*s_dot_1_x
        - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y + n_1_z*s_dot_1_z
    )
    D_p_dot_x_1 = t12*(A_x_1*t192 + A_x_2*t187 + A_x_3*t188 + A_x_4*t189 + A_x_5*t190 + A_x_6*t191)
    D_p_dot_y_1 = t12*(A_y_1*t192 + A_y_2*t187 + A_y_3*t188 + A_y_4*t189 + A_y_5*t190 + A_y_6*t191)
    D_p_dot_z_1 = t12*(A_z_1*t192 + A_z_2*t187 + A_z_3*t188 + A_z_4*t189 + A_z_5*t190 + A_z_6*t191)
    D_p_dot_rx_1 = t12*(A_rx_1*t192 + A_rx_2*t187 + A_rx_3*t188 + A_rx_4*t189 + A_rx_5*t190 + A_rx_6*t191)
    D_p_dot_ry_1 = t12*(A_ry_1*t192 + A_ry_2*t187 + A_ry_3*t188 + A_ry_4*t189 + A_ry_5*t190 + A_ry_6*t191)
    D_p_dot_rz_1 = t12*(A_rz_1*t192 + A_rz_2*t187 + A_rz_3*t188 + A_rz_4*t189 + A_rz_5*t190 + A_rz_6*t191)
    t193 = (
        -D_l_dot_1_rx*D_p_rx_2 - D_l_dot_1_ry*D_p_ry_2 - D_l_dot_1_rz*D_p_rz_2 - D_p_x_2*s_dot_1_x
        - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z
    )
    t194 = (
        -D_l_dot_3_rx*D_p_rx_2 - D_l_dot_3_ry*D_p_ry_2 - D_l_dot_3_rz*D_p_rz_2 - D_p_x_2*s_dot_3_x
        - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z
    )
    t195 = (
        -D_l_dot_4_rx*D_p_rx_2 - D_l_dot_4_ry*D_p_ry_2 - D_l_dot_4_rz*D_p_rz_2 - D_p_x_2*s_dot_4_x
        - D_p_y_2*s_dot_4_y - D_p_z_2*s_dot_4_z
    )
    t196 = (
        -D_l_dot_5_rx*D_p_rx_2 - D_l_dot_5_ry*D_p_ry_2 - D_l_dot_5_rz*D_p_rz_2 - D_p_x_2*s_dot_5_x
        - D_p_y_2*s_dot_5_y - D_p_z_2*s_dot_5_z
    )
    t197 = (
        -D_l_dot_6_rx*D_p_rx_2 - D_l_dot_6_ry*D_p_ry_2 - D_l_dot_6_rz*D_p_rz_2 - D_p_x_2*s_dot_6_x
        - D_p_y_2*s_dot_6_y - D_p_z_2*s_dot_6_z
    )
    t198 = (
        -D_l_dot_2_rx*D_p_rx_2 - D_l_dot_2_ry*D_p_ry_2 - D_l_dot_2_rz*D_p_rz_2 - D_p_x_2*s_dot_2_x
        - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y + n_2_z*s_dot_2_z
    )
    D_p_dot_x_2 = t12*(A_x_1*t193 + A_x_2*t198 + A_x_3*t194 + A_x_4*t195 + A_x_5*t196 + A_x_6*t197)
    D_p_dot_y_2 = t12*(A_y_1*t193 + A_y_2*t198 + A_y_3*t194 + A_y_4*t195 + A_y_5*t196 + A_y_6*t197)
    D_p_dot_z_2 = t12*(A_z_1*t193 + A_z_2*t198 + A_z_3*t194 + A_z_4*t195 + A_z_5*t196 + A_z_6*t197)
    D_p_dot_rx_2 = t12*(A_rx_1*t193 + A_rx_2*t198 + A_rx_3*t194 + A_rx_4*t195 + A_rx_5*t196 + A_rx_6*t197)
    D_p_dot_ry_2 = t12*(A_ry_1*t193 + A_ry_2*t198 + A_ry_3*t194 + A_ry_4*t195 + A_ry_5*t196 + A_ry_6*t197)
    D_p_dot_rz_2 = t12*(A_rz_1*t193 + A_rz_2*t198 + A_rz_3*t194 + A_rz_4*t195 + A_rz_5*t196 + A_rz_6*t197)
    t199 = (
        -D_l_dot_1_rx*D_p_rx_3 - D_l_dot_1_ry*D_p_ry_3 - D_l_dot_1_rz*D_p_rz_3 - D_p_x_3*s_dot_1_x
        - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z
    )
    t200 = (
        -D_l_dot_2_rx*D_p_rx_3 - D_l_dot_2_ry*D_p_ry_3 - D_l_dot_2_rz*D_p_rz_3 - D_p_x_3*s_dot_2_x
        - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z
    )
    t201 = (
        -D_l_dot_4_rx*D_p_rx_3 - D_l_dot_4_ry*D_p_ry_3 - D_l_dot_4_rz*D_p_rz_3 - D_p_x_3*s_dot_4_x
        - D_p_y_3*s_dot_4_y - D_p_z_3*s_dot_4_z
    )
    t202 = (
        -D_l_dot_5_rx*D_p_rx_3 - D_l_dot_5_ry*D_p_ry_3 - D_l_dot_5_rz*D_p_rz_3 - D_p_x_3*s_dot_5_x
        - D_p_y_3*s_dot_5_y - D_p_z_3*s_dot_5_z
    )
    t203 = (
        -D_l_dot_6_rx*D_p_rx_3 - D_l_dot_6_ry*D_p_ry_3 - D_l_dot_6_rz*D_p_rz_3 - D_p_x_3*s_dot_6_x
        - D_p_y_3*s_dot_6_y - D_p_z_3*s_dot_6_z
    )
    t204 = (
        -D_l_dot_3_rx*D_p_rx_3 - D_l_dot_3_ry*D_p_ry_3 - D_l_dot_3_rz*D_p_rz_3 - D_p_x_3*s_dot_3_x
        - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y + n_3_z*s_dot_3_z
    )
    D_p_dot_x_3 = t12*(A_x_1*t199 + A_x_2*t200 + A_x_3*t204 + A_x_4*t201 + A_x_5*t202 + A_x_6*t203)
    D_p_dot_y_3 = t12*(A_y_1*t199 + A_y_2*t200 + A_y_3*t204 + A_y_4*t201 + A_y_5*t202 + A_y_6*t203)
    D_p_dot_z_3 = t12*(A_z_1*t199 + A_z_2*t200 + A_z_3*t204 + A_z_4*t201 + A_z_5*t202 + A_z_6*t203)
    D_p_dot_rx_3 = t12*(A_rx_1*t199 + A_rx_2*t200 + A_rx_3*t204 + A_rx_4*t201 + A_rx_5*t202 + A_rx_6*t203)
    D_p_dot_ry_3 = t12*(A_ry_1*t199 + A_ry_2*t200 + A_ry_3*t204 + A_ry_4*t201 + A_ry_5*t202 + A_ry_6*t203)
    D_p_dot_rz_3 = t12*(A_rz_1*t199 + A_rz_2*t200 + A_rz_3*t204 + A_rz_4*t201 + A_rz_5*t202 + A_rz_6*t203)
    t205 = (
        -D_l_dot_1_rx*D_p_rx_4 - D_l_dot_1_ry*D_p_ry_4 - D_l_dot_1_rz*D_p_rz_4 - D_p_x_4*s_dot_1_x
        - D_p_y_4*s_dot_1_y - D_p_z_4*s_dot_1_z
    )
    t206 = (
        -D_l_dot_2_rx*D_p_rx_4 - D_l_dot_2_ry*D_p_ry_4 - D_l_dot_2_rz*D_p_rz_4 - D_p_x_4*s_dot_2_x
        - D_p_y_4*s_dot_2_y - D_p_z_4*s_dot_2_z
    )
    t207 = (
        -D_l_dot_3_rx*D_p_rx_4 - D_l_dot_3_ry*D_p_ry_4 - D_l_dot_3_rz*D_p_rz_4 - D_p_x_4*s_dot_3_x
        - D_p_y_4*s_dot_3_y - D_p_z_4*s_dot_3_z
    )
    t208 = (
        -D_l_dot_5_rx*D_p_rx_4 - D_l_dot_5_ry*D_p_ry_4 - D_l_dot_5_rz*D_p_rz_4 - D_p_x_4*s_dot_5_x
        - D_p_y_4*s_dot_5_y - D_p_z_4*s_dot_5_z
    )
    t209 = (
        -D_l_dot_6_rx*D_p_rx_4 - D_l_dot_6_ry*D_p_ry_4 - D_l_dot_6_rz*D_p_rz_4 - D_p_x_4*s_dot_6_x
        - D_p_y_4*s_dot_6_y - D_p_z_4*s_dot_6_z
    )
    t210 = (
        -D_l_dot_4_rx*D_p_rx_4 - D_l_dot_4_ry*D_p_ry_4 - D_l_dot_4_rz*D_p_rz_4 - D_p_x_4*s_dot_4_x
        - D_p_y_4*s_dot_4_y - D_p_z_4*s_dot_4_z + n_4_x*s_dot_4_x + n_4_y*s_dot_4_y + n_4_z*s_dot_4_z
    )
    D_p_dot_x_4 = t12*(A_x_1*t205 + A_x_2*t206 + A_x_3*t207 + A_x_4*t210 + A_x_5*t208 + A_x_6*t209)
    D_p_dot_y_4 = t12*(A_y_1*t205 + A_y_2*t206 + A_y_3*t207 + A_y_4*t210 + A_y_5*t208 + A_y_6*t209)
    D_p_dot_z_4 = t12*(A_z_1*t205 + A_z_2*t206 + A_z_3*t207 + A_z_4*t210 + A_z_5*t208 + A_z_6*t209)
    D_p_dot_rx_4 = t12*(A_rx_1*t205 + A_rx_2*t206 + A_rx_3*t207 + A_rx_4*t210 + A_rx_5*t208 + A_rx_6*t209)
    D_p_dot_ry_4 = t12*(A_ry_1*t205 + A_ry_2*t206 + A_ry_3*t207 + A_ry_4*t210 + A_ry_5*t208 + A_ry_6*t209)
    D_p_dot_rz_4 = t12*(A_rz_1*t205 + A_rz_2*t206 + A_rz_3*t207 + A_rz_4*t210 + A_rz_5*t208 + A_rz_6*t209)
    t211 = (
        -D_l_dot_1_rx*D_p_rx_5 - D_l_dot_1_ry*D_p_ry_5 - D_l_dot_1_rz*D_p_rz_5 - D_p_x_5*s_dot_1_x
        - D_p_y_5*s_dot_1_y - D_p_z_5*s_dot_1_z
    )
    t212 = (
        -D_l_dot_2_rx*D_p_rx_5 - D_l_dot_2_ry*D_p_ry_5 - D_l_dot_2_rz*D_p_rz_5 - D_p_x_5*s_dot_2_x
        - D_p_y_5*s_dot_2_y - D_p_z_5*s_dot_2_z
    )
    t213 = (
        -D_l_dot_3_rx*D_p_rx_5 - D_l_dot_3_ry*D_p_ry_5 - D_l_dot_3_rz*D_p_rz_5 - D_p_x_5*s_dot_3_x
        - D_p_y_5*s_dot_3_y - D_p_z_5*s_dot_3_z
    )
    t214 = (
        -D_l_dot_4_rx*D_p_rx_5 - D_l_dot_4_ry*D_p_ry_5 - D_l_dot_4_rz*D_p_rz_5 - D_p_x_5*s_dot_4_x
        - D_p_y_5*s_dot_4_y - D_p_z_5*s_dot_4_z
    )
    t215 = (
        -D_l_dot_6_rx*D_p_rx_5 - D_l_dot_6_ry*D_p_ry_5 - D_l_dot_6_rz*D_p_rz_5 - D_p_x_5*s_dot_6_x
        - D_p_y_5*s_dot_6_y - D_p_z_5*s_dot_6_z
    )
    t216 = (
        -D_l_dot_5_rx*D_p_rx_5 - D_l_dot_5_ry*D_p_ry_5 - D_l_dot_5_rz*D_p_rz_5 - D_p_x_5*s_dot_5_x
        - D_p_y_5*s_dot_5_y - D_p_z_5*s_dot_5_z + n_5_x*s_dot_5_x + n_5_y*s_dot_5_y + n_5_z*s_dot_5_z
    )
    D_p_dot_x_5 = t12*(A_x_1*t211 + A_x_2*t212 + A_x_3*t213 + A_x_4*t214 + A_x_5*t216 + A_x_6*t215)
    D_p_dot_y_5 = t12*(A_y_1*t211 + A_y_2*t212 + A_y_3*t213 + A_y_4*t214 + A_y_5*t216 + A_y_6*t215)
    D_p_dot_z_5 = t12*(A_z_1*t211 + A_z_2*t212 + A_z_3*t213 + A_z_4*t214 + A_z_5*t216 + A_z_6*t215)
    D_p_dot_rx_5 = t12*(A_rx_1*t211 + A_rx_2*t212 + A_rx_3*t213 + A_rx_4*t214 + A_rx_5*t216 + A_rx_6*t215)
    D_p_dot_ry_5 = t12*(A_ry_1*t211 + A_ry_2*t212 + A_ry_3*t213 + A_ry_4*t214 + A_ry_5*t216 + A_ry_6*t215)
    D_p_dot_rz_5 = t12*(A_rz_1*t211 + A_rz_2*t212 + A_rz_3*t213 + A_rz_4*t214 + A_rz_5*t216 + A_rz_6*t215)
    t217 = (
        -D_l_dot_1_rx*D_p_rx_6 - D_l_dot_1_ry*D_p_ry_6 - D_l_dot_1_rz*D_p_rz_6 - D_p_x_6*s_dot_1_x
        - D_p_y_6*s_dot_1_y - D_p_z_6*s_dot_1_z
    )
    t218 = (
        -D_l_dot_2_rx*D_p_rx_6 - D_l_dot_2_ry*D_p_ry_6 - D_l_dot_2_rz*D_p_rz_6 - D_p_x_6*s_dot_2_x
        - D_p_y_6*s_dot_2_y - D_p_z_6*s_dot_2_z
    )
    t219 = (
        -D_l_dot_3_rx*D_p_rx_6 - D_l_dot_3_ry*D_p_ry_6 - D_l_dot_3_rz*D_p_rz_6 - D_p_x_6*s_dot_3_x
        - D_p_y_6*s_dot_3_y - D_p_z_6*s_dot_3_z
    )
    t220 = (
        -D_l_dot_4_rx*D_p_rx_6 - D_l_dot_4_ry*D_p_ry_6 - D_l_dot_4_rz*D_p_rz_6 - D_p_x_6*s_dot_4_x
        - D_p_y_6*s_dot_4_y - D_p_z_6*s_dot_4_z
    )
    t221 = (
        -D_l_dot_5_rx*D_p_rx_6 - D_l_dot_5_ry*D_p_ry_6 - D_l_dot_5_rz*D_p_rz_6 - D_p_x_6*s_dot_5_x
        - D_p_y_6*s_dot_5_y - D_p_z_6*s_dot_5_z
    )
    t222 = (
        -D_l_dot_6_rx*D_p_rx_6 - D_l_dot_6_ry*D_p_ry_6 - D_l_dot_6_rz*D_p_rz_6 - D_p_x_6*s_dot_6_x
        - D_p_y_6*s_dot_6_y - D_p_z_6*s_dot_6_z + n_6_x*s_dot_6_x + n_6_y*s_dot_6_y + n_6_z*s_dot_6_z
    )
    D_p_dot_x_6 = t12*(A_x_1*t217 + A_x_2*t218 + A_x_3*t219 + A_x_4*t220 + A_x_5*t221 + A_x_6*t222)
    D_p_dot_y_6 = t12*(A_y_1*t217 + A_y_2*t218 + A_y_3*t219 + A_y_4*t220 + A_y_5*t221 + A_y_6*t222)
    D_p_dot_z_6 = t12*(A_z_1*t217 + A_z_2*t218 + A_z_3*t219 + A_z_4*t220 + A_z_5*t221 + A_z_6*t222)
    D_p_dot_rx_6 = t12*(A_rx_1*t217 + A_rx_2*t218 + A_rx_3*t219 + A_rx_4*t220 + A_rx_5*t221 + A_rx_6*t222)
    D_p_dot_ry_6 = t12*(A_ry_1*t217 + A_ry_2*t218 + A_ry_3*t219 + A_ry_4*t220 + A_ry_5*t221 + A_ry_6*t222)
    D_p_dot_rz_6 = t12*(A_rz_1*t217 + A_rz_2*t218 + A_rz_3*t219 + A_rz_4*t220 + A_rz_5*t221 + A_rz_6*t222)
    D_p_dot_out = np.empty((*batch, 6, 6), dtype)
    D_p_dot_out[..., 0, 0] = D_p_dot_x_1
    D_p_dot_out[..., 0, 1] = D_p_dot_x_2
    D_p_dot_out[..., 0, 2] = D_p_dot_x_3
    D_p_dot_out[..., 0, 3] = D_p_dot_x_4
    D_p_dot_out[..., 0, 4] = D_p_dot_x_5
    D_p_dot_out[..., 0, 5] = D_p_dot_x_6
    D_p_dot_out[..., 1, 0] = D_p_dot_y_1
    D_p_dot_out[..., 1, 1] = D_p_dot_y_2
    D_p_dot_out[..., 1, 2] = D_p_dot_y_3
    D_p_dot_out[..., 1, 3] = D_p_dot_y_4
    D_p_dot_out[..., 1, 4] = D_p_dot_y_5
    D_p_dot_out[..., 1, 5] = D_p_dot_y_6
    D_p_dot_out[..., 2, 0] = D_p_dot_z_1
    D_p_dot_out[..., 2, 1] = D_p_dot_z_2
    D_p_dot_out[..., 2, 2] = D_p_dot_z_3
    D_p_dot_out[..., 2, 3] = D_p_dot_z_4
    D_p_dot_out[..., 2, 4] = D_p_dot_z_5
    D_p_dot_out[..., 2, 5] = D_p_dot_z_6
    D_p_dot_out[..., 3, 0] = D_p_dot_rx_1
    D_p_dot_out[..., 3, 1] = D_p_dot_rx_2
    D_p_dot_out[..., 3, 2] = D_p_dot_rx_3
    D_p_dot_out[..., 3, 3] = D_p_dot_rx_4
    D_p_dot_out[..., 3, 4] = D_p_dot_rx_5
    D_p_dot_out[..., 3, 5] = D_p_dot_rx_6
    D_p_dot_out[..., 4, 0] = D_p_dot_ry_1
    D_p_dot_out[..., 4, 1] = D_p_dot_ry_2
    D_p_dot_out[..., 4, 2] = D_p_dot_ry_3
    D_p_dot_out[..., 4, 3] = D_p_dot_ry_4
    D_p_dot_out[..., 4, 4] = D_p_dot_ry_5
    D_p_dot_out[..., 4, 5] = D_p_dot_ry_6
    D_p_dot_out[..., 5, 0] = D_p_dot_rz_1
    D_p_dot_out[..., 5, 1] = D_p_dot_rz_2
    D_p_dot_out[..., 5, 2] = D_p_dot_rz_3
    D_p_dot_out[..., 5, 3] = D_p_dot_rz_4
    D_p_dot_out[..., 5, 4] = D_p_dot_rz_5
    D_p_dot_out[..., 5, 5] = D_p_dot_rz_6
    return D_p_dot_out


def platform_second_derivatives(p, parameters):
    """Second derivatives of the platform position with respect to the carriage positions.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    P : array, shape (..., 6, 6, 6) [1/m, 1/m^2]
        d2p_i/dq_k dq_l as P[i, k, l], of rotations in the exponential chart at the pose.

    Notes
    -----
    Equation 49, by the implicit function theorem to second order.
    7766 operations; 324095706684 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = 1.0/det_D_l
    t13 = D_r_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = D_r_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = D_r_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = D_r_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = D_r_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = D_r_6*t12
    D_p_x_6 = A_x_6*t18
    D_p_y_1 = A_y_1*t13
    D_p_y_2 = A_y_2*t14
    D_p_y_3 = A_y_3*t15
    D_p_y_4 = A_y_4*t16
    D_p_y_5 = A_y_5*t17
    D_p_y_6 = A_y_6*t18
    D_p_z_1 = A_z_1*t13
    D_p_z_2 = A_z_2*t14
    D_p_z_3 = A_z_3*t15
    D_p_z_4 = A_z_4*t16
    D_p_z_5 = A_z_5*t17
    D_p_z_6 = A_z_6*t18
    D_p_rx_1 = A_rx_1*t13
    D_p_rx_2 = A_rx_2*t14
    D_p_rx_3 = A_rx_3*t15
    D_p_rx_4 = A_rx_4*t16
    D_p_rx_5 = A_rx_5*t17
    D_p_rx_6 = A_rx_6*t18
    D_p_ry_1 = A_ry_1*t13
    D_p_ry_2 = A_ry_2*t14
    D_p_ry_3 = A_ry_3*t15
    D_p_ry_4 = A_ry_4*t16
    D_p_ry_5 = A_ry_5*t17
    D_p_ry_6 = A_ry_6*t18
    D_p_rz_1 = A_rz_1*t13
    D_p_rz_2 = A_rz_2*t14
    D_p_rz_3 = A_rz_3*t15
    D_p_rz_4 = A_rz_4*t16
    D_p_rz_5 = A_rz_5*t17
    D_p_rz_6 = A_rz_6*t18
    t19 = B_1_y*D_p_rz_1 - B_1_z*D_p_ry_1
    U_1_x_1 = D_p_x_1 - n_1_x - t19
    t20 = B_1_y*D_p_rz_2
    U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t20
    t21 = B_1_y*D_p_rz_3
    U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t21
    t22 = B_1_y*D_p_rz_4
    U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t22
    t23 = B_1_y*D_p_rz_5
    U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t23
    t24 = B_1_y*D_p_rz_6
    U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t24
    t25 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1
    U_1_y_1 = D_p_y_1 - n_1_y + t25
    t26 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2
    U_1_y_2 = D_p_y_2 + t26
    t27 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3
    U_1_y_3 = D_p_y_3 + t27
    t28 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4
    U_1_y_4 = D_p_y_4 + t28
    t29 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5
    U_1_y_5 = D_p_y_5 + t29
    t30 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6
    U_1_y_6 = D_p_y_6 + t30
    t31 = B_1_x*D_p_ry_1 - B_1_y*D_p_rx_1
    U_1_z_1 = D_p_z_1 - n_1_z - t31
    t32 = B_1_x*D_p_ry_2
    U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t32
    t33 = B_1_x*D_p_ry_3
    U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t33
    t34 = B_1_x*D_p_ry_4
    U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t34
    t35 = B_1_x*D_p_ry_5
    U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t35
    t36 = B_1_x*D_p_ry_6
    U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t36
    t37 = B_2_y*D_p_rz_1
    U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t37
    t38 = B_2_y*D_p_rz_2 - B_2_z*D_p_ry_2
    U_2_x_2 = D_p_x_2 - n_2_x - t38
    t39 = B_2_y*D_p_rz_3
    U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t39
    t40 = B_2_y*D_p_rz_4
    U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t40
    t41 = B_2_y*D_p_rz_5
    U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t41
    t42 = B_2_y*D_p_rz_6
    U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t42
    t43 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1
    U_2_y_1 = D_p_y_1 + t43
    t44 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2
    U_2_y_2 = D_p_y_2 - n_2_y + t44
    t45 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3
    U_2_y_3 = D_p_y_3 + t45
    t46 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4
    U_2_y_4 = D_p_y_4 + t46
    t47 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5
    U_2_y_5 = D_p_y_5 + t47
    t48 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6
    U_2_y_6 = D_p_y_6 + t48
    t49 = B_2_x*D_p_ry_1
    U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t49
    t50 = B_2_x*D_p_ry_2 - B_2_y*D_p_rx_2
    U_2_z_2 = D_p_z_2 - n_2_z - t50
    t51 = B_2_x*D_p_ry_3
    U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t51
    t52 = B_2_x*D_p_ry_4
    U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t52
    t53 = B_2_x*D_p_ry_5
    U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t53
    t54 = B_2_x*D_p_ry_6
    U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t54
    t55 = B_3_y*D_p_rz_1
    U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t55
    t56 = B_3_y*D_p_rz_2
    U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t56
    t57 = B_3_y*D_p_rz_3 - B_3_z*D_p_ry_3
    U_3_x_3 = D_p_x_3 - n_3_x - t57
    t58 = B_3_y*D_p_rz_4
    U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t58
    t59 = B_3_y*D_p_rz_5
    U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t59
    t60 = B_3_y*D_p_rz_6
    U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t60
    t61 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1
    U_3_y_1 = D_p_y_1 + t61
    t62 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2
    U_3_y_2 = D_p_y_2 + t62
    t63 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3
    U_3_y_3 = D_p_y_3 - n_3_y + t63
    t64 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4
    U_3_y_4 = D_p_y_4 + t64
    t65 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5
    U_3_y_5 = D_p_y_5 + t65
    t66 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6
    U_3_y_6 = D_p_y_6 + t66
    t67 = B_3_x*D_p_ry_1
    U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t67
    t68 = B_3_x*D_p_ry_2
    U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t68
    t69 = B_3_x*D_p_ry_3 - B_3_y*D_p_rx_3
    U_3_z_3 = D_p_z_3 - n_3_z - t69
    t70 = B_3_x*D_p_ry_4
    U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t70
    t71 = B_3_x*D_p_ry_5
    U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t71
    t72 = B_3_x*D_p_ry_6
    U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t72
    t73 = B_4_y*D_p_rz_1
    U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t73
    t74 = B_4_y*D_p_rz_2
    U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t74
    t75 = B_4_y*D_p_rz_3
    U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t75
    t76 = B_4_y*D_p_rz_4 - B_4_z*D_p_ry_4
    U_4_x_4 = D_p_x_4 - n_4_x - t76
    t77 = B_4_y*D_p_rz_5
    U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t77
    t78 = B_4_y*D_p_rz_6
    U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t78
    t79 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1
    U_4_y_1 = D_p_y_1 + t79
    t80 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2
    U_4_y_2 = D_p_y_2 + t80
    t81 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3
    U_4_y_3 = D_p_y_3 + t81
    t82 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4
    U_4_y_4 = D_p_y_4 - n_4_y + t82
    t83 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5
    U_4_y_5 = D_p_y_5 + t83
    t84 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6
    U_4_y_6 = D_p_y_6 + t84
    t85 = B_4_x*D_p_ry_1
    U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t85
    t86 = B_4_x*D_p_ry_2
    U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t86
    t87 = B_4_x*D_p_ry_3
    U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t87
    t88 = B_4_x*D_p_ry_4 - B_4_y*D_p_rx_4
    U_4_z_4 = D_p_z_4 - n_4_z - t88
    t89 = B_4_x*D_p_ry_5
    U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t89
    t90 = B_4_x*D_p_ry_6
    U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t90
    t91 = B_5_y*D_p_rz_1
    U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t91
    t92 = B_5_y*D_p_rz_2
    U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t92
    t93 = B_5_y*D_p_rz_3
    U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t93
    t94 = B_5_y*D_p_rz_4
    U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t94
    t95 = B_5_y*D_p_rz_5 - B_5_z*D_p_ry_5
    U_5_x_5 = D_p_x_5 - n_5_x - t95
    t96 = B_5_y*D_p_rz_6
    U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t96
    t97 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1
    U_5_y_1 = D_p_y_1 + t97
    t98 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2
    U_5_y_2 = D_p_y_2 + t98
    t99 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3
    U_5_y_3 = D_p_y_3 + t99
    t100 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4
    U_5_y_4 = D_p_y_4 + t100
    t101 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5
    U_5_y_5 = D_p_y_5 - n_5_y + t101
    t102 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6
    U_5_y_6 = D_p_y_6 + t102
    t103 = B_5_x*D_p_ry_1
    U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t103
    t104 = B_5_x*D_p_ry_2
    U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t104
    t105 = B_5_x*D_p_ry_3
    U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t105
    t106 = B_5_x*D_p_ry_4
    U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t106
    t107 = B_5_x*D_p_ry_5 - B_5_y*D_p_rx_5
    U_5_z_5 = D_p_z_5 - n_5_z - t107
    t108 = B_5_x*D_p_ry_6
    U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t108
    t109 = B_6_y*D_p_rz_1
    U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t109
    t110 = B_6_y*D_p_rz_2
    U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t110
    t111 = B_6_y*D_p_rz_3
    U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t111
    t112 = B_6_y*D_p_rz_4
    U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t112
    t113 = B_6_y*D_p_rz_5
    U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t113
    t114 = B_6_y*D_p_rz_6 - B_6_z*D_p_ry_6
    U_6_x_6 = D_p_x_6 - n_6_x - t114
    t115 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1
    U_6_y_1 = D_p_y_1 + t115
    t116 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2
    U_6_y_2 = D_p_y_2 + t116
    t117 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3
    U_6_y_3 = D_p_y_3 + t117
    t118 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4
    U_6_y_4 = D_p_y_4 + t118
    t119 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5
    U_6_y_5 = D_p_y_5 + t119
    t120 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6
    U_6_y_6 = D_p_y_6 - n_6_y + t120
    t121 = B_6_x*D_p_ry_1
    U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t121
    t122 = B_6_x*D_p_ry_2
    U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t122
    t123 = B_6_x*D_p_ry_3
    U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t123
    t124 = B_6_x*D_p_ry_4
    U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t124
    t125 = B_6_x*D_p_ry_5
    U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t125
    t126 = B_6_x*D_p_ry_6 - B_6_y*D_p_rx_6
    U_6_z_6 = D_p_z_6 - n_6_z - t126
    f_1_11 = (
        -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2 - s_1_x*(-D_p_ry_1*t31 - D_p_rz_1*t25) - s_1_y*(D_p_rx_1*t31
        - D_p_rz_1*t19) - s_1_z*(D_p_rx_1*t25 + D_p_ry_1*t19)
    )
    t127 = B_2_y*D_p_rx_1 - t49
    t128 = B_2_z*D_p_ry_1 - t37
    f_2_11 = (
        -U_2_x_1**2 - U_2_y_1**2 - U_2_z_1**2 - s_2_x*(D_p_ry_1*t127 - D_p_rz_1*t43) - s_2_y*(-D_p_rx_1*t127
        + D_p_rz_1*t128) - s_2_z*(D_p_rx_1*t43 - D_p_ry_1*t128)
    )
    t129 = B_3_y*D_p_rx_1 - t67
    t130 = B_3_z*D_p_ry_1 - t55
    f_3_11 = (
        -U_3_x_1**2 - U_3_y_1**2 - U_3_z_1**2 - s_3_x*(D_p_ry_1*t129 - D_p_rz_1*t61) - s_3_y*(-D_p_rx_1*t129
        + D_p_rz_1*t130) - s_3_z*(D_p_rx_1*t61 - D_p_ry_1*t130)
    )
    t131 = B_4_y*D_p_rx_1 - t85
    t132 = B_4_z*D_p_ry_1 - t73
    f_4_11 = (
        -U_4_x_1**2 - U_4_y_1**2 - U_4_z_1**2 - s_4_x*(D_p_ry_1*t131 - D_p_rz_1*t79) - s_4_y*(-D_p_rx_1*t131
        + D_p_rz_1*t132) - s_4_z*(D_p_rx_1*t79 - D_p_ry_1*t132)
    )
    t133 = B_5_y*D_p_rx_1 - t103
    t134 = B_5_z*D_p_ry_1 - t91
    f_5_11 = (
        -U_5_x_1**2 - U_5_y_1**2 - U_5_z_1**2 - s_5_x*(D_p_ry_1*t133 - D_p_rz_1*t97) - s_5_y*(-D_p_rx_1*t133
        + D_p_rz_1*t134) - s_5_z*(D_p_rx_1*t97 - D_p_ry_1*t134)
    )
    t135 = B_6_y*D_p_rx_1 - t121
    t136 = B_6_z*D_p_ry_1 - t109
    f_6_11 = (
        -U_6_x_1**2 - U_6_y_1**2 - U_6_z_1**2 - s_6_x*(D_p_ry_1*t135 - D_p_rz_1*t115) - s_6_y*(-D_p_rx_1*t135
        + D_p_rz_1*t136) - s_6_z*(D_p_rx_1*t115 - D_p_ry_1*t136)
    )
    P_x_11 = t12*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_3_11 + A_x_4*f_4_11 + A_x_5*f_5_11 + A_x_6*f_6_11)
    P_y_11 = t12*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_3_11 + A_y_4*f_4_11 + A_y_5*f_5_11 + A_y_6*f_6_11)
    P_z_11 = t12*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_3_11 + A_z_4*f_4_11 + A_z_5*f_5_11 + A_z_6*f_6_11)
    P_rx_11 = (
        t12*(A_rx_1*f_1_11 + A_rx_2*f_2_11 + A_rx_3*f_3_11 + A_rx_4*f_4_11 + A_rx_5*f_5_11 + A_rx_6*f_6_11)
    )
    P_ry_11 = (
        t12*(A_ry_1*f_1_11 + A_ry_2*f_2_11 + A_ry_3*f_3_11 + A_ry_4*f_4_11 + A_ry_5*f_5_11 + A_ry_6*f_6_11)
    )
    P_rz_11 = (
        t12*(A_rz_1*f_1_11 + A_rz_2*f_2_11 + A_rz_3*f_3_11 + A_rz_4*f_4_11 + A_rz_5*f_5_11 + A_rz_6*f_6_11)
    )
    t137 = B_1_y*D_p_rx_2 - t32
    t138 = (1/2)*s_1_x
    t139 = B_1_z*D_p_ry_2 - t20
    t140 = (1/2)*s_1_y
    t141 = (1/2)*s_1_z
    f_1_12 = (
        -U_1_x_1*U_1_x_2 - U_1_y_1*U_1_y_2 - U_1_z_1*U_1_z_2 - t138*(D_p_ry_1*t137 - D_p_rz_1*t26)
        - t138*(-D_p_ry_2*t31 - D_p_rz_2*t25) - t140*(-D_p_rx_1*t137 + D_p_rz_1*t139) - t140*(D_p_rx_2*t31
        - D_p_rz_2*t19) - t141*(D_p_rx_1*t26 - D_p_ry_1*t139) - t141*(D_p_rx_2*t25 + D_p_ry_2*t19)
    )
    t142 = (1/2)*s_2_x
    t143 = (1/2)*s_2_y
    t144 = (1/2)*s_2_z
    f_2_12 = (
        -U_2_x_1*U_2_x_2 - U_2_y_1*U_2_y_2 - U_2_z_1*U_2_z_2 - t142*(-D_p_ry_1*t50 - D_p_rz_1*t44)
        - t142*(D_p_ry_2*t127 - D_p_rz_2*t43) - t143*(D_p_rx_1*t50 - D_p_rz_1*t38) - t143*(-D_p_rx_2*t127
        + D_p_rz_2*t128) - t144*(D_p_rx_1*t44 + D_p_ry_1*t38) - t144*(D_p_rx_2*t43 - D_p_ry_2*t128)
    )
    t145 = B_3_y*D_p_rx_2 - t68
    t146 = (1/2)*s_3_x
    t147 = B_3_z*D_p_ry_2 - t56
    t148 = (1/2)*s_3_y
    t149 = (1/2)*s_3_z
    f_3_12 = (
        -U_3_x_1*U_3_x_2 - U_3_y_1*U_3_y_2 - U_3_z_1*U_3_z_2 - t146*(D_p_ry_1*t145 - D_p_rz_1*t62)
        - t146*(D_p_ry_2*t129 - D_p_rz_2*t61) - t148*(-D_p_rx_1*t145 + D_p_rz_1*t147) - t148*(-D_p_rx_2*t129
        + D_p_rz_2*t130) - t149*(D_p_rx_1*t62 - D_p_ry_1*t147) - t149*(D_p_rx_2*t61 - D_p_ry_2*t130)
    )
    t150 = B_4_y*D_p_rx_2 - t86
    t151 = (1/2)*s_4_x
    t152 = B_4_z*D_p_ry_2 - t74
    t153 = (1/2)*s_4_y
    t154 = (1/2)*s_4_z
    f_4_12 = (
        -U_4_x_1*U_4_x_2 - U_4_y_1*U_4_y_2 - U_4_z_1*U_4_z_2 - t151*(D_p_ry_1*t150 - D_p_rz_1*t80)
        - t151*(D_p_ry_2*t131 - D_p_rz_2*t79) - t153*(-D_p_rx_1*t150 + D_p_rz_1*t152) - t153*(-D_p_rx_2*t131
        + D_p_rz_2*t132) - t154*(D_p_rx_1*t80 - D_p_ry_1*t152) - t154*(D_p_rx_2*t79 - D_p_ry_2*t132)
    )
    t155 = B_5_y*D_p_rx_2 - t104
    t156 = (1/2)*s_5_x
    t157 = B_5_z*D_p_ry_2 - t92
    t158 = (1/2)*s_5_y
    t159 = (1/2)*s_5_z
    f_5_12 = (
        -U_5_x_1*U_5_x_2 - U_5_y_1*U_5_y_2 - U_5_z_1*U_5_z_2 - t156*(D_p_ry_1*t155 - D_p_rz_1*t98)
        - t156*(D_p_ry_2*t133 - D_p_rz_2*t97) - t158*(-D_p_rx_1*t155 + D_p_rz_1*t157) - t158*(-D_p_rx_2*t133
        + D_p_rz_2*t134) - t159*(D_p_rx_1*t98 - D_p_ry_1*t157) - t159*(D_p_rx_2*t97 - D_p_ry_2*t134)
    )
    t160 = B_6_y*D_p_rx_2 - t122
    t161 = (1/2)*s_6_x
    t162 = B_6_z*D_p_ry_2 - t110
    t163 = (1/2)*s_6_y
    t164 = (1/2)*s_6_z
    f_6_12 = (
        -U_6_x_1*U_6_x_2 - U_6_y_1*U_6_y_2 - U_6_z_1*U_6_z_2 - t161*(D_p_ry_1*t160 - D_p_rz_1*t116)
        - t161*(D_p_ry_2*t135 - D_p_rz_2*t115) - t163*(-D_p_rx_1*t160 + D_p_rz_1*t162) - t163*(-D_p_rx_2*t135
        + D_p_rz_2*t136) - t164*(D_p_rx_1*t116 - D_p_ry_1*t162) - t164*(D_p_rx_2*t115 - D_p_ry_2*t136)
    )
    P_x_12 = t12*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12 + A_x_4*f_4_12 + A_x_5*f_5_12 + A_x_6*f_6_12)
    P_y_12 = t12*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12 + A_y_4*f_4_12 + A_y_5*f_5_12 + A_y_6*f_6_12)
    P_z_12 = t12*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12 + A_z_4*f_4_12 + A_z_5*f_5_12 + A_z_6*f_6_12)
    P_rx_12 = (
        t12*(A_rx_1*f_1_12 + A_rx_2*f_2_12 + A_rx_3*f_3_12 + A_rx_4*f_4_12 + A_rx_5*f_5_12 + A_rx_6*f_6_12)
    )
    P_ry_12 = (
        t12*(A_ry_1*f_1_12 + A_ry_2*f_2_12 + A_ry_3*f_3_12 + A_ry_4*f_4_12 + A_ry_5*f_5_12 + A_ry_6*f_6_12)
    )
    P_rz_12 = (
        t12*(A_rz_1*f_1_12 + A_rz_2*f_2_12 + A_rz_3*f_3_12 + A_rz_4*f_4_12 + A_rz_5*f_5_12 + A_rz_6*f_6_12)
    )
    t165 = B_1_y*D_p_rx_3 - t33
    t166 = B_1_z*D_p_ry_3 - t21
    f_1_13 = (
        -U_1_x_1*U_1_x_3 - U_1_y_1*U_1_y_3 - U_1_z_1*U_1_z_3 - t138*(D_p_ry_1*t165 - D_p_rz_1*t27)
        - t138*(-D_p_ry_3*t31 - D_p_rz_3*t25) - t140*(-D_p_rx_1*t165 + D_p_rz_1*t166) - t140*(D_p_rx_3*t31
        - D_p_rz_3*t19) - t141*(D_p_rx_1*t27 - D_p_ry_1*t166) - t141*(D_p_rx_3*t25 + D_p_ry_3*t19)
    )
    t167 = B_2_y*D_p_rx_3 - t51
    t168 = B_2_z*D_p_ry_3 - t39
    f_2_13 = (
        -U_2_x_1*U_2_x_3 - U_2_y_1*U_2_y_3 - U_2_z_1*U_2_z_3 - t142*(D_p_ry_1*t167 - D_p_rz_1*t45)
        - t142*(D_p_ry_3*t127 - D_p_rz_3*t43) - t143*(-D_p_rx_1*t167 + D_p_rz_1*t168) - t143*(-D_p_rx_3*t127
        + D_p_rz_3*t128) - t144*(D_p_rx_1*t45 - D_p_ry_1*t168) - t144*(D_p_rx_3*t43 - D_p_ry_3*t128)
    )
    f_3_13 = (
        -U_3_x_1*U_3_x_3 - U_3_y_1*U_3_y_3 - U_3_z_1*U_3_z_3 - t146*(-D_p_ry_1*t69 - D_p_rz_1*t63)
        - t146*(D_p_ry_3*t129 - D_p_rz_3*t61) - t148*(D_p_rx_1*t69 - D_p_rz_1*t57) - t148*(-D_p_rx_3*t129
        + D_p_rz_3*t130) - t149*(D_p_rx_1*t63 + D_p_ry_1*t57) - t149*(D_p_rx_3*t61 - D_p_ry_3*t130)
    )
    t169 = B_4_y*D_p_rx_3 - t87
    t170 = B_4_z*D_p_ry_3 - t75
    f_4_13 = (
        -U_4_x_1*U_4_x_3 - U_4_y_1*U_4_y_3 - U_4_z_1*U_4_z_3 - t151*(D_p_ry_1*t169 - D_p_rz_1*t81)
        - t151*(D_p_ry_3*t131 - D_p_rz_3*t79) - t153*(-D_p_rx_1*t169 + D_p_rz_1*t170) - t153*(-D_p_rx_3*t131
        + D_p_rz_3*t132) - t154*(D_p_rx_1*t81 - D_p_ry_1*t170) - t154*(D_p_rx_3*t79 - D_p_ry_3*t132)
    )
    t171 = B_5_y*D_p_rx_3 - t105
    t172 = B_5_z*D_p_ry_3 - t93
    f_5_13 = (
        -U_5_x_1*U_5_x_3 - U_5_y_1*U_5_y_3 - U_5_z_1*U_5_z_3 - t156*(D_p_ry_1*t171 - D_p_rz_1*t99)
        - t156*(D_p_ry_3*t133 - D_p_rz_3*t97) - t158*(-D_p_rx_1*t171 + D_p_rz_1*t172) - t158*(-D_p_rx_3*t133
        + D_p_rz_3*t134) - t159*(D_p_rx_1*t99 - D_p_ry_1*t172) - t159*(D_p_rx_3*t97 - D_p_ry_3*t134)
    )
    t173 = B_6_y*D_p_rx_3 - t123
    t174 = B_6_z*D_p_ry_3 - t111
    f_6_13 = (
        -U_6_x_1*U_6_x_3 - U_6_y_1*U_6_y_3 - U_6_z_1*U_6_z_3 - t161*(D_p_ry_1*t173 - D_p_rz_1*t117)
        - t161*(D_p_ry_3*t135 - D_p_rz_3*t115) - t163*(-D_p_rx_1*t173 + D_p_rz_1*t174) - t163*(-D_p_rx_3*t135
        + D_p_rz_3*t136) - t164*(D_p_rx_1*t117 - D_p_ry_1*t174) - t164*(D_p_rx_3*t115 - D_p_ry_3*t136)
    )
    P_x_13 = t12*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13 + A_x_4*f_4_13 + A_x_5*f_5_13 + A_x_6*f_6_13)
    P_y_13 = t12*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13 + A_y_4*f_4_13 + A_y_5*f_5_13 + A_y_6*f_6_13)
    P_z_13 = t12*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13 + A_z_4*f_4_13 + A_z_5*f_5_13 + A_z_6*f_6_13)
    P_rx_13 = (
        t12*(A_rx_1*f_1_13 + A_rx_2*f_2_13 + A_rx_3*f_3_13 + A_rx_4*f_4_13 + A_rx_5*f_5_13 + A_rx_6*f_6_13)
    )
    P_ry_13 = (
        t12*(A_ry_1*f_1_13 + A_ry_2*f_2_13 + A_ry_3*f_3_13 + A_ry_4*f_4_13 + A_ry_5*f_5_13 + A_ry_6*f_6_13)
    )
    P_rz_13 = (
        t12*(A_rz_1*f_1_13 + A_rz_2*f_2_13 + A_rz_3*f_3_13 + A_rz_4*f_4_13 + A_rz_5*f_5_13 + A_rz_6*f_6_13)
    )
    t175 = B_1_y*D_p_rx_4 - t34
    t176 = B_1_z*D_p_ry_4 - t22
    f_1_14 = (
        -U_1_x_1*U_1_x_4 - U_1_y_1*U_1_y_4 - U_1_z_1*U_1_z_4 - t138*(D_p_ry_1*t175 - D_p_rz_1*t28)
        - t138*(-D_p_ry_4*t31 - D_p_rz_4*t25) - t140*(-D_p_rx_1*t175 + D_p_rz_1*t176) - t140*(D_p_rx_4*t31
        - D_p_rz_4*t19) - t141*(D_p_rx_1*t28 - D_p_ry_1*t176) - t141*(D_p_rx_4*t25 + D_p_ry_4*t19)
    )
    t177 = B_2_y*D_p_rx_4 - t52
    t178 = B_2_z*D_p_ry_4 - t40
    f_2_14 = (
        -U_2_x_1*U_2_x_4 - U_2_y_1*U_2_y_4 - U_2_z_1*U_2_z_4 - t142*(D_p_ry_1*t177 - D_p_rz_1*t46)
        - t142*(D_p_ry_4*t127 - D_p_rz_4*t43) - t143*(-D_p_rx_1*t177 + D_p_rz_1*t178) - t143*(-D_p_rx_4*t127
        + D_p_rz_4*t128) - t144*(D_p_rx_1*t46 - D_p_ry_1*t178) - t144*(D_p_rx_4*t43 - D_p_ry_4*t128)
    )
    t179 = B_3_y*D_p_rx_4 - t70
    t180 = B_3_z*D_p_ry_4 - t58
    f_3_14 = (
        -U_3_x_1*U_3_x_4 - U_3_y_1*U_3_y_4 - U_3_z_1*U_3_z_4 - t146*(D_p_ry_1*t179 - D_p_rz_1*t64)
        - t146*(D_p_ry_4*t129 - D_p_rz_4*t61) - t148*(-D_p_rx_1*t179 + D_p_rz_1*t180) - t148*(-D_p_rx_4*t129
        + D_p_rz_4*t130) - t149*(D_p_rx_1*t64 - D_p_ry_1*t180) - t149*(D_p_rx_4*t61 - D_p_ry_4*t130)
    )
    f_4_14 = (
        -U_4_x_1*U_4_x_4 - U_4_y_1*U_4_y_4 - U_4_z_1*U_4_z_4 - t151*(-D_p_ry_1*t88 - D_p_rz_1*t82)
        - t151*(D_p_ry_4*t131 - D_p_rz_4*t79) - t153*(D_p_rx_1*t88 - D_p_rz_1*t76) - t153*(-D_p_rx_4*t131
        + D_p_rz_4*t132) - t154*(D_p_rx_1*t82 + D_p_ry_1*t76) - t154*(D_p_rx_4*t79 - D_p_ry_4*t132)
    )
    t181 = B_5_y*D_p_rx_4 - t106
    t182 = B_5_z*D_p_ry_4 - t94
    f_5_14 = (
        -U_5_x_1*U_5_x_4 - U_5_y_1*U_5_y_4 - U_5_z_1*U_5_z_4 - t156*(D_p_ry_1*t181 - D_p_rz_1*t100)
        - t156*(D_p_ry_4*t133 - D_p_rz_4*t97) - t158*(-D_p_rx_1*t181 + D_p_rz_1*t182) - t158*(-D_p_rx_4*t133
        + D_p_rz_4*t134) - t159*(D_p_rx_1*t100 - D_p_ry_1*t182) - t159*(D_p_rx_4*t97 - D_p_ry_4*t134)
    )
    t183 = B_6_y*D_p_rx_4 - t124
    t184 = B_6_z*D_p_ry_4 - t112
    f_6_14 = (
        -U_6_x_1*U_6_x_4 - U_6_y_1*U_6_y_4 - U_6_z_1*U_6_z_4 - t161*(D_p_ry_1*t183 - D_p_rz_1*t118)
        - t161*(D_p_ry_4*t135 - D_p_rz_4*t115) - t163*(-D_p_rx_1*t183 + D_p_rz_1*t184) - t163*(-D_p_rx_4*t135
        + D_p_rz_4*t136) - t164*(D_p_rx_1*t118 - D_p_ry_1*t184) - t164*(D_p_rx_4*t115 - D_p_ry_4*t136)
    )
    P_x_14 = t12*(A_x_1*f_1_14 + A_x_2*f_2_14 + A_x_3*f_3_14 + A_x_4*f_4_14 + A_x_5*f_5_14 + A_x_6*f_6_14)
    P_y_14 = t12*(A_y_1*f_1_14 + A_y_2*f_2_14 + A_y_3*f_3_14 + A_y_4*f_4_14 + A_y_5*f_5_14 + A_y_6*f_6_14)
    P_z_14 = t12*(A_z_1*f_1_14 + A_z_2*f_2_14 + A_z_3*f_3_14 + A_z_4*f_4_14 + A_z_5*f_5_14 + A_z_6*f_6_14)
    P_rx_14 = (
        t12*(A_rx_1*f_1_14 + A_rx_2*f_2_14 + A_rx_3*f_3_14 + A_rx_4*f_4_14 + A_rx_5*f_5_14 + A_rx_6*f_6_14)
    )
    P_ry_14 = (
        t12*(A_ry_1*f_1_14 + A_ry_2*f_2_14 + A_ry_3*f_3_14 + A_ry_4*f_4_14 + A_ry_5*f_5_14 + A_ry_6*f_6_14)
    )
    P_rz_14 = (
        t12*(A_rz_1*f_1_14 + A_rz_2*f_2_14 + A_rz_3*f_3_14 + A_rz_4*f_4_14 + A_rz_5*f_5_14 + A_rz_6*f_6_14)
    )
    t185 = B_1_y*D_p_rx_5 - t35
    t186 = B_1_z*D_p_ry_5 - t23
    f_1_15 = (
        -U_1_x_1*U_1_x_5 - U_1_y_1*U_1_y_5 - U_1_z_1*U_1_z_5 - t138*(D_p_ry_1*t185 - D_p_rz_1*t29)
        - t138*(-D_p_ry_5*t31 - D_p_rz_5*t25) - t140*(-D_p_rx_1*t185 + D_p_rz_1*t186) - t140*(D_p_rx_5*t31
        - D_p_rz_5*t19) - t141*(D_p_rx_1*t29 - D_p_ry_1*t186) - t141*(D_p_rx_5*t25 + D_p_ry_5*t19)
    )
    t187 = B_2_y*D_p_rx_5 - t53
    t188 = B_2_z*D_p_ry_5 - t41
    f_2_15 = (
        -U_2_x_1*U_2_x_5 - U_2_y_1*U_2_y_5 - U_2_z_1*U_2_z_5 - t142*(D_p_ry_1*t187 - D_p_rz_1*t47)
        - t142*(D_p_ry_5*t127 - D_p_rz_5*t43) - t143*(-D_p_rx_1*t187 + D_p_rz_1*t188) - t143*(-D_p_rx_5*t127
        + D_p_rz_5*t128) - t144*(D_p_rx_1*t47 - D_p_ry_1*t188) - t144*(D_p_rx_5*t43 - D_p_ry_5*t128)
    )
    t189 = B_3_y*D_p_rx_5 - t71
    t190 = B_3_z*D_p_ry_5 - t59
    f_3_15 = (
        -U_3_x_1*U_3_x_5 - U_3_y_1*U_3_y_5 - U_3_z_1*U_3_z_5 - t146*(D_p_ry_1*t189 - D_p_rz_1*t65)
        - t146*(D_p_ry_5*t129 - D_p_rz_5*t61) - t148*(-D_p_rx_1*t189 + D_p_rz_1*t190) - t148*(-D_p_rx_5*t129
        + D_p_rz_5*t130) - t149*(D_p_rx_1*t65 - D_p_ry_1*t190) - t149*(D_p_rx_5*t61 - D_p_ry_5*t130)
    )
    t191 = B_4_y*D_p_rx_5 - t89
    t192 = B_4_z*D_p_ry_5 - t77
    f_4_15 = (
        -U_4_x_1*U_4_x_5 - U_4_y_1*U_4_y_5 - U_4_z_1*U_4_z_5 - t151*(D_p_ry_1*t191 - D_p_rz_1*t83)
        - t151*(D_p_ry_5*t131 - D_p_rz_5*t79) - t153*(-D_p_rx_1*t191 + D_p_rz_1*t192) - t153*(-D_p_rx_5*t131
        + D_p_rz_5*t132) - t154*(D_p_rx_1*t83 - D_p_ry_1*t192) - t154*(D_p_rx_5*t79 - D_p_ry_5*t132)
    )
    f_5_15 = (
        -U_5_x_1*U_5_x_5 - U_5_y_1*U_5_y_5 - U_5_z_1*U_5_z_5 - t156*(-D_p_ry_1*t107 - D_p_rz_1*t101)
        - t156*(D_p_ry_5*t133 - D_p_rz_5*t97) - t158*(D_p_rx_1*t107 - D_p_rz_1*t95) - t158*(-D_p_rx_5*t133
        + D_p_rz_5*t134) - t159*(D_p_rx_1*t101 + D_p_ry_1*t95) - t159*(D_p_rx_5*t97 - D_p_ry_5*t134)
    )
    t193 = B_6_y*D_p_rx_5 - t125
    t194 = B_6_z*D_p_ry_5 - t113
    f_6_15 = (
        -U_6_x_1*U_6_x_5 - U_6_y_1*U_6_y_5 - U_6_z_1*U_6_z_5 - t161*(D_p_ry_1*t193 - D_p_rz_1*t119)
        - t161*(D_p_ry_5*t135 - D_p_rz_5*t115) - t163*(-D_p_rx_1*t193 + D_p_rz_1*t194) - t163*(-D_p_rx_5*t135
        + D_p_rz_5*t136) - t164*(D_p_rx_1*t119 - D_p_ry_1*t194) - t164*(D_p_rx_5*t115 - D_p_ry_5*t136)
    )
    P_x_15 = t12*(A_x_1*f_1_15 + A_x_2*f_2_15 + A_x_3*f_3_15 + A_x_4*f_4_15 + A_x_5*f_5_15 + A_x_6*f_6_15)
    P_y_15 = t12*(A_y_1*f_1_15 + A_y_2*f_2_15 + A_y_3*f_3_15 + A_y_4*f_4_15 + A_y_5*f_5_15 + A_y_6*f_6_15)
    P_z_15 = t12*(A_z_1*f_1_15 + A_z_2*f_2_15 + A_z_3*f_3_15 + A_z_4*f_4_15 + A_z_5*f_5_15 + A_z_6*f_6_15)
    P_rx_15 = (
        t12*(A_rx_1*f_1_15 + A_rx_2*f_2_15 + A_rx_3*f_3_15 + A_rx_4*f_4_15 + A_rx_5*f_5_15 + A_rx_6*f_6_15)
    )
    P_ry_15 = (
        t12*(A_ry_1*f_1_15 + A_ry_2*f_2_15 + A_ry_3*f_3_15 + A_ry_4*f_4_15 + A_ry_5*f_5_15 + A_ry_6*f_6_15)
    )
    P_rz_15 = (
        t12*(A_rz_1*f_1_15 + A_rz_2*f_2_15 + A_rz_3*f_3_15 + A_rz_4*f_4_15 + A_rz_5*f_5_15 + A_rz_6*f_6_15)
    )
    t195 = B_1_y*D_p_rx_6 - t36
    t196 = B_1_z*D_p_ry_6 - t24
    f_1_16 = (
        -U_1_x_1*U_1_x_6 - U_1_y_1*U_1_y_6 - U_1_z_1*U_1_z_6 - t138*(D_p_ry_1*t195 - D_p_rz_1*t30)
        - t138*(-D_p_ry_6*t31 - D_p_rz_6*t25) - t140*(-D_p_rx_1*t195 + D_p_rz_1*t196) - t140*(D_p_rx_6*t31
        - D_p_rz_6*t19) - t141*(D_p_rx_1*t30 - D_p_ry_1*t196) - t141*(D_p_rx_6*t25 + D_p_ry_6*t19)
    )
    t197 = B_2_y*D_p_rx_6 - t54
    t198 = B_2_z*D_p_ry_6 - t42
    f_2_16 = (
        -U_2_x_1*U_2_x_6 - U_2_y_1*U_2_y_6 - U_2_z_1*U_2_z_6 - t142*(D_p_ry_1*t197 - D_p_rz_1*t48)
        - t142*(D_p_ry_6*t127 - D_p_rz_6*t43) - t143*(-D_p_rx_1*t197 + D_p_rz_1*t198) - t143*(-D_p_rx_6*t127
        + D_p_rz_6*t128) - t144*(D_p_rx_1*t48 - D_p_ry_1*t198) - t144*(D_p_rx_6*t43 - D_p_ry_6*t128)
    )
    t199 = B_3_y*D_p_rx_6 - t72
    t200 = B_3_z*D_p_ry_6 - t60
    f_3_16 = (
        -U_3_x_1*U_3_x_6 - U_3_y_1*U_3_y_6 - U_3_z_1*U_3_z_6 - t146*(D_p_ry_1*t199 - D_p_rz_1*t66)
        - t146*(D_p_ry_6*t129 - D_p_rz_6*t61) - t148*(-D_p_rx_1*t199 + D_p_rz_1*t200) - t148*(-D_p_rx_6*t129
        + D_p_rz_6*t130) - t149*(D_p_rx_1*t66 - D_p_ry_1*t200) - t149*(D_p_rx_6*t61 - D_p_ry_6*t130)
    )
    t201 = B_4_y*D_p_rx_6 - t90
    t202 = B_4_z*D_p_ry_6 - t78
    f_4_16 = (
        -U_4_x_1*U_4_x_6 - U_4_y_1*U_4_y_6 - U_4_z_1*U_4_z_6 - t151*(D_p_ry_1*t201 - D_p_rz_1*t84)
        - t151*(D_p_ry_6*t131 - D_p_rz_6*t79) - t153*(-D_p_rx_1*t201 + D_p_rz_1*t202) - t153*(-D_p_rx_6*t131
        + D_p_rz_6*t132) - t154*(D_p_rx_1*t84 - D_p_ry_1*t202) - t154*(D_p_rx_6*t79 - D_p_ry_6*t132)
    )
    t203 = B_5_y*D_p_rx_6 - t108
    t204 = B_5_z*D_p_ry_6 - t96
    f_5_16 = (
        -U_5_x_1*U_5_x_6 - U_5_y_1*U_5_y_6 - U_5_z_1*U_5_z_6 - t156*(D_p_ry_1*t203 - D_p_rz_1*t102)
        - t156*(D_p_ry_6*t133 - D_p_rz_6*t97) - t158*(-D_p_rx_1*t203 + D_p_rz_1*t204) - t158*(-D_p_rx_6*t133
        + D_p_rz_6*t134) - t159*(D_p_rx_1*t102 - D_p_ry_1*t204) - t159*(D_p_rx_6*t97 - D_p_ry_6*t134)
    )
    f_6_16 = (
        -U_6_x_1*U_6_x_6 - U_6_y_1*U_6_y_6 - U_6_z_1*U_6_z_6 - t161*(-D_p_ry_1*t126 - D_p_rz_1*t120)
        - t161*(D_p_ry_6*t135 - D_p_rz_6*t115) - t163*(D_p_rx_1*t126 - D_p_rz_1*t114) - t163*(-D_p_rx_6*t135
        + D_p_rz_6*t136) - t164*(D_p_rx_1*t120 + D_p_ry_1*t114) - t164*(D_p_rx_6*t115 - D_p_ry_6*t136)
    )
    P_x_16 = t12*(A_x_1*f_1_16 + A_x_2*f_2_16 + A_x_3*f_3_16 + A_x_4*f_4_16 + A_x_5*f_5_16 + A_x_6*f_6_16)
    P_y_16 = t12*(A_y_1*f_1_16 + A_y_2*f_2_16 + A_y_3*f_3_16 + A_y_4*f_4_16 + A_y_5*f_5_16 + A_y_6*f_6_16)
    P_z_16 = t12*(A_z_1*f_1_16 + A_z_2*f_2_16 + A_z_3*f_3_16 + A_z_4*f_4_16 + A_z_5*f_5_16 + A_z_6*f_6_16)
    P_rx_16 = (
        t12*(A_rx_1*f_1_16 + A_rx_2*f_2_16 + A_rx_3*f_3_16 + A_rx_4*f_4_16 + A_rx_5*f_5_16 + A_rx_6*f_6_16)
    )
    P_ry_16 = (
        t12*(A_ry_1*f_1_16 + A_ry_2*f_2_16 + A_ry_3*f_3_16 + A_ry_4*f_4_16 + A_ry_5*f_5_16 + A_ry_6*f_6_16)
    )
    P_rz_16 = (
        t12*(A_rz_1*f_1_16 + A_rz_2*f_2_16 + A_rz_3*f_3_16 + A_rz_4*f_4_16 + A_rz_5*f_5_16 + A_rz_6*f_6_16)
    )
    f_1_22 = (
        -U_1_x_2**2 - U_1_y_2**2 - U_1_z_2**2 - s_1_x*(D_p_ry_2*t137 - D_p_rz_2*t26) - s_1_y*(-D_p_rx_2*t137
        + D_p_rz_2*t139) - s_1_z*(D_p_rx_2*t26 - D_p_ry_2*t139)
    )
    f_2_22 = (
        -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2 - s_2_x*(-D_p_ry_2*t50 - D_p_rz_2*t44) - s_2_y*(D_p_rx_2*t50
        - D_p_rz_2*t38) - s_2_z*(D_p_rx_2*t44 + D_p_ry_2*t38)
    )
    f_3_22 = (
        -U_3_x_2**2 - U_3_y_2**2 - U_3_z_2**2 - s_3_x*(D_p_ry_2*t145 - D_p_rz_2*t62) - s_3_y*(-D_p_rx_2*t145
        + D_p_rz_2*t147) - s_3_z*(D_p_rx_2*t62 - D_p_ry_2*t147)
    )
    f_4_22 = (
        -U_4_x_2**2 - U_4_y_2**2 - U_4_z_2**2 - s_4_x*(D_p_ry_2*t150 - D_p_rz_2*t80) - s_4_y*(-D_p_rx_2*t150
        + D_p_rz_2*t152) - s_4_z*(D_p_rx_2*t80 - D_p_ry_2*t152)
    )
    f_5_22 = (
        -U_5_x_2**2 - U_5_y_2**2 - U_5_z_2**2 - s_5_x*(D_p_ry_2*t155 - D_p_rz_2*t98) - s_5_y*(-D_p_rx_2*t155
        + D_p_rz_2*t157) - s_5_z*(D_p_rx_2*t98 - D_p_ry_2*t157)
    )
    f_6_22 = (
        -U_6_x_2**2 - U_6_y_2**2 - U_6_z_2**2 - s_6_x*(D_p_ry_2*t160 - D_p_rz_2*t116) - s_6_y*(-D_p_rx_2*t160
        + D_p_rz_2*t162) - s_6_z*(D_p_rx_2*t116 - D_p_ry_2*t162)
    )
    P_x_22 = t12*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_3_22 + A_x_4*f_4_22 + A_x_5*f_5_22 + A_x_6*f_6_22)
    P_y_22 = t12*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_3_22 + A_y_4*f_4_22 + A_y_5*f_5_22 + A_y_6*f_6_22)
    P_z_22 = t12*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_3_22 + A_z_4*f_4_22 + A_z_5*f_5_22 + A_z_6*f_6_22)
    P_rx_22 = (
        t12*(A_rx_1*f_1_22 + A_rx_2*f_2_22 + A_rx_3*f_3_22 + A_rx_4*f_4_22 + A_rx_5*f_5_22 + A_rx_6*f_6_22)
    )
    P_ry_22 = (
        t12*(A_ry_1*f_1_22 + A_ry_2*f_2_22 + A_ry_3*f_3_22 + A_ry_4*f_4_22 + A_ry_5*f_5_22 + A_ry_6*f_6_22)
    )
    P_rz_22 = (
        t12*(A_rz_1*f_1_22 + A_rz_2*f_2_22 + A_rz_3*f_3_22 + A_rz_4*f_4_22 + A_rz_5*f_5_22 + A_rz_6*f_6_22)
    )
    f_1_23 = (
        -U_1_x_2*U_1_x_3 - U_1_y_2*U_1_y_3 - U_1_z_2*U_1_z_3 - t138*(D_p_ry_2*t165 - D_p_rz_2*t27)
        - t138*(D_p_ry_3*t137 - D_p_rz_3*t26) - t140*(-D_p_rx_2*t165 + D_p_rz_2*t166) - t140*(-D_p_rx_3*t137
        + D_p_rz_3*t139) - t141*(D_p_rx_2*t27 - D_p_ry_2*t166) - t141*(D_p_rx_3*t26 - D_p_ry_3*t139)
    )
    f_2_23 = (
        -U_2_x_2*U_2_x_3 - U_2_y_2*U_2_y_3 - U_2_z_2*U_2_z_3 - t142*(D_p_ry_2*t167 - D_p_rz_2*t45)
        - t142*(-D_p_ry_3*t50 - D_p_rz_3*t44) - t143*(-D_p_rx_2*t167 + D_p_rz_2*t168) - t143*(D_p_rx_3*t50
        - D_p_rz_3*t38) - t144*(D_p_rx_2*t45 - D_p_ry_2*t168) - t144*(D_p_rx_3*t44 + D_p_ry_3*t38)
    )
    f_3_23 = (
        -U_3_x_2*U_3_x_3 - U_3_y_2*U_3_y_3 - U_3_z_2*U_3_z_3 - t146*(-D_p_ry_2*t69 - D_p_rz_2*t63)
        - t146*(D_p_ry_3*t145 - D_p_rz_3*t62) - t148*(D_p_rx_2*t69 - D_p_rz_2*t57) - t148*(-D_p_rx_3*t145
        + D_p_rz_3*t147) - t149*(D_p_rx_2*t63 + D_p_ry_2*t57) - t149*(D_p_rx_3*t62 - D_p_ry_3*t147)
    )
    f_4_23 = (
        -U_4_x_2*U_4_x_3 - U_4_y_2*U_4_y_3 - U_4_z_2*U_4_z_3 - t151*(D_p_ry_2*t169 - D_p_rz_2*t81)
        - t151*(D_p_ry_3*t150 - D_p_rz_3*t80) - t153*(-D_p_rx_2*t169 + D_p_rz_2*t170) - t153*(-D_p_rx_3*t150
        + D_p_rz_3*t152) - t154*(D_p_rx_2*t81 - D_p_ry_2*t170) - t154*(D_p_rx_3*t80 - D_p_ry_3*t152)
    )
    f_5_23 = (
        -U_5_x_2*U_5_x_3 - U_5_y_2*U_5_y_3 - U_5_z_2*U_5_z_3 - t156*(D_p_ry_2*t171 - D_p_rz_2*t99)
        - t156*(D_p_ry_3*t155 - D_p_rz_3*t98) - t158*(-D_p_rx_2*t171 + D_p_rz_2*t172) - t158*(-D_p_rx_3*t155
        + D_p_rz_3*t157) - t159*(D_p_rx_2*t99 - D_p_ry_2*t172) - t159*(D_p_rx_3*t98 - D_p_ry_3*t157)
    )
    f_6_23 = (
        -U_6_x_2*U_6_x_3 - U_6_y_2*U_6_y_3 - U_6_z_2*U_6_z_3 - t161*(D_p_ry_2*t173 - D_p_rz_2*t117)
        - t161*(D_p_ry_3*t160 - D_p_rz_3*t116) - t163*(-D_p_rx_2*t173 + D_p_rz_2*t174) - t163*(-D_p_rx_3*t160
        + D_p_rz_3*t162) - t164*(D_p_rx_2*t117 - D_p_ry_2*t174) - t164*(D_p_rx_3*t116 - D_p_ry_3*t162)
    )
    P_x_23 = t12*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23 + A_x_4*f_4_23 + A_x_5*f_5_23 + A_x_6*f_6_23)
    P_y_23 = t12*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23 + A_y_4*f_4_23 + A_y_5*f_5_23 + A_y_6*f_6_23)
    P_z_23 = t12*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23 + A_z_4*f_4_23 + A_z_5*f_5_23 + A_z_6*f_6_23)
    P_rx_23 = (
        t12*(A_rx_1*f_1_23 + A_rx_2*f_2_23 + A_rx_3*f_3_23 + A_rx_4*f_4_23 + A_rx_5*f_5_23 + A_rx_6*f_6_23)
    )
    P_ry_23 = (
        t12*(A_ry_1*f_1_23 + A_ry_2*f_2_23 + A_ry_3*f_3_23 + A_ry_4*f_4_23 + A_ry_5*f_5_23 + A_ry_6*f_6_23)
    )
    P_rz_23 = (
        t12*(A_rz_1*f_1_23 + A_rz_2*f_2_23 + A_rz_3*f_3_23 + A_rz_4*f_4_23 + A_rz_5*f_5_23 + A_rz_6*f_6_23)
    )
    f_1_24 = (
        -U_1_x_2*U_1_x_4 - U_1_y_2*U_1_y_4 - U_1_z_2*U_1_z_4 - t138*(D_p_ry_2*t175 - D_p_rz_2*t28)
        - t138*(D_p_ry_4*t137 - D_p_rz_4*t26) - t140*(-D_p_rx_2*t175 + D_p_rz_2*t176) - t140*(-D_p_rx_4*t137
        + D_p_rz_4*t139) - t141*(D_p_rx_2*t28 - D_p_ry_2*t176) - t141*(D_p_rx_4*t26 - D_p_ry_4*t139)
    )
    f_2_24 = (
        -U_2_x_2*U_2_x_4 - U_2_y_2*U_2_y_4 - U_2_z_2*U_2_z_4 - t142*(D_p_ry_2*t177 - D_p_rz_2*t46)
        - t142*(-D_p_ry_4*t50 - D_p_rz_4*t44) - t143*(-D_p_rx_2*t177 + D_p_rz_2*t178) - t143*(D_p_rx_4*t50
        - D_p_rz_4*t38) - t144*(D_p_rx_2*t46 - D_p_ry_2*t178) - t144*(D_p_rx_4*t44 + D_p_ry_4*t38)
    )
    f_3_24 = (
        -U_3_x_2*U_3_x_4 - U_3_y_2*U_3_y_4 - U_3_z_2*U_3_z_4 - t146*(D_p_ry_2*t179 - D_p_rz_2*t64)
        - t146*(D_p_ry_4*t145 - D_p_rz_4*t62) - t148*(-D_p_rx_2*t179 + D_p_rz_2*t180) - t148*(-D_p_rx_4*t145
        + D_p_rz_4*t147) - t149*(D_p_rx_2*t64 - D_p_ry_2*t180) - t149*(D_p_rx_4*t62 - D_p_ry_4*t147)
    )
    f_4_24 = (
        -U_4_x_2*U_4_x_4 - U_4_y_2*U_4_y_4 - U_4_z_2*U_4_z_4 - t151*(-D_p_ry_2*t88 - D_p_rz_2*t82)
        - t151*(D_p_ry_4*t150 - D_p_rz_4*t80) - t153*(D_p_rx_2*t88 - D_p_rz_2*t76) - t153*(-D_p_rx_4*t150
        + D_p_rz_4*t152) - t154*(D_p_rx_2*t82 + D_p_ry_2*t76) - t154*(D_p_rx_4*t80 - D_p_ry_4*t152)
    )
    f_5_24 = (
        -U_5_x_2*U_5_x_4 - U_5_y_2*U_5_y_4 - U_5_z_2*U_5_z_4 - t156*(D_p_ry_2*t181 - D_p_rz_2*t100)
        - t156*(D_p_ry_4*t155 - D_p_rz_4*t98) - t158*(-D_p_rx_2*t181 + D_p_rz_2*t182) - t158*(-D_p_rx_4*t155
        + D_p_rz_4*t157) - t159*(D_p_rx_2*t100 - D_p_ry_2*t182) - t159*(D_p_rx_4*t98 - D_p_ry_4*t157)
    )
    f_6_24 = (
        -U_6_x_2*U_6_x_4 - U_6_y_2*U_6_y_4 - U_6_z_2*U_6_z_4 - t161*(D_p_ry_2*t183 - D_p_rz_2*t118)
        - t161*(D_p_ry_4*t160 - D_p_rz_4*t116) - t163*(-D_p_rx_2*t183 + D_p_rz_2*t184) - t163*(-D_p_rx_4*t160
        + D_p_rz_4*t162) - t164*(D_p_rx_2*t118 - D_p_ry_2*t184) - t164*(D_p_rx_4*t116 - D_p_ry_4*t162)
    )
    P_x_24 = t12*(A_x_1*f_1_24 + A_x_2*f_2_24 + A_x_3*f_3_24 + A_x_4*f_4_24 + A_x_5*f_5_24 + A_x_6*f_6_24)
    P_y_24 = t12*(A_y_1*f_1_24 + A_y_2*f_2_24 + A_y_3*f_3_24 + A_y_4*f_4_24 + A_y_5*f_5_24 + A_y_6*f_6_24)
    P_z_24 = t12*(A_z_1*f_1_24 + A_z_2*f_2_24 + A_z_3*f_3_24 + A_z_4*f_4_24 + A_z_5*f_5_24 + A_z_6*f_6_24)
    P_rx_24 = (
        t12*(A_rx_1*f_1_24 + A_rx_2*f_2_24 + A_rx_3*f_3_24 + A_rx_4*f_4_24 + A_rx_5*f_5_24 + A_rx_6*f_6_24)
    )
    P_ry_24 = (
        t12*(A_ry_1*f_1_24 + A_ry_2*f_2_24 + A_ry_3*f_3_24 + A_ry_4*f_4_24 + A_ry_5*f_5_24 + A_ry_6*f_6_24)
    )
    P_rz_24 = (
        t12*(A_rz_1*f_1_24 + A_rz_2*f_2_24 + A_rz_3*f_3_24 + A_rz_4*f_4_24 + A_rz_5*f_5_24 + A_rz_6*f_6_24)
    )
    f_1_25 = (
        -U_1_x_2*U_1_x_5 - U_1_y_2*U_1_y_5 - U_1_z_2*U_1_z_5 - t138*(D_p_ry_2*t185 - D_p_rz_2*t29)
        - t138*(D_p_ry_5*t137 - D_p_rz_5*t26) - t140*(-D_p_rx_2*t185 + D_p_rz_2*t186) - t140*(-D_p_rx_5*t137
        + D_p_rz_5*t139) - t141*(D_p_rx_2*t29 - D_p_ry_2*t186) - t141*(D_p_rx_5*t26 - D_p_ry_5*t139)
    )
    f_2_25 = (
        -U_2_x_2*U_2_x_5 - U_2_y_2*U_2_y_5 - U_2_z_2*U_2_z_5 - t142*(D_p_ry_2*t187 - D_p_rz_2*t47)
        - t142*(-D_p_ry_5*t50 - D_p_rz_5*t44) - t143*(-D_p_rx_2*t187 + D_p_rz_2*t188) - t143*(D_p_rx_5*t50
        - D_p_rz_5*t38) - t144*(D_p_rx_2*t47 - D_p_ry_2*t188) - t144*(D_p_rx_5*t44 + D_p_ry_5*t38)
    )
    f_3_25 = (
        -U_3_x_2*U_3_x_5 - U_3_y_2*U_3_y_5 - U_3_z_2*U_3_z_5 - t146*(D_p_ry_2*t189 - D_p_rz_2*t65)
        - t146*(D_p_ry_5*t145 - D_p_rz_5*t62) - t148*(-D_p_rx_2*t189 + D_p_rz_2*t190) - t148*(-D_p_rx_5*t145
        + D_p_rz_5*t147) - t149*(D_p_rx_2*t65 - D_p_ry_2*t190) - t149*(D_p_rx_5*t62 - D_p_ry_5*t147)
    )
    f_4_25 = (
        -U_4_x_2*U_4_x_5 - U_4_y_2*U_4_y_5 - U_4_z_2*U_4_z_5 - t151*(D_p_ry_2*t191 - D_p_rz_2*t83)
        - t151*(D_p_ry_5*t150 - D_p_rz_5*t80) - t153*(-D_p_rx_2*t191 + D_p_rz_2*t192) - t153*(-D_p_rx_5*t150
        + D_p_rz_5*t152) - t154*(D_p_rx_2*t83 - D_p_ry_2*t192) - t154*(D_p_rx_5*t80 - D_p_ry_5*t152)
    )
    f_5_25 = (
        -U_5_x_2*U_5_x_5 - U_5_y_2*U_5_y_5 - U_5_z_2*U_5_z_5 - t156*(-D_p_ry_2*t107 - D_p_rz_2*t101)
        - t156*(D_p_ry_5*t155 - D_p_rz_5*t98) - t158*(D_p_rx_2*t107 - D_p_rz_2*t95) - t158*(-D_p_rx_5*t155
        + D_p_rz_5*t157) - t159*(D_p_rx_2*t101 + D_p_ry_2*t95) - t159*(D_p_rx_5*t98 - D_p_ry_5*t157)
    )
    f_6_25 = (
        -U_6_x_2*U_6_x_5 - U_6_y_2*U_6_y_5 - U_6_z_2*U_6_z_5 - t161*(D_p_ry_2*t193 - D_p_rz_2*t119)
        - t161*(D_p_ry_5*t160 - D_p_rz_5*t116) - t163*(-D_p_rx_2*t193 + D_p_rz_2*t194) - t163*(-D_p_rx_5*t160
        + D_p_rz_5*t162) - t164*(D_p_rx_2*t119 - D_p_ry_2*t194) - t164*(D_p_rx_5*t116 - D_p_ry_5*t162)
    )
    P_x_25 = t12*(A_x_1*f_1_25 + A_x_2*f_2_25 + A_x_3*f_3_25 + A_x_4*f_4_25 + A_x_5*f_5_25 + A_x_6*f_6_25)
    P_y_25 = t12*(A_y_1*f_1_25 + A_y_2*f_2_25 + A_y_3*f_3_25 + A_y_4*f_4_25 + A_y_5*f_5_25 + A_y_6*f_6_25)
    P_z_25 = t12*(A_z_1*f_1_25 + A_z_2*f_2_25 + A_z_3*f_3_25 + A_z_4*f_4_25 + A_z_5*f_5_25 + A_z_6*f_6_25)
    P_rx_25 = (
        t12*(A_rx_1*f_1_25 + A_rx_2*f_2_25 + A_rx_3*f_3_25 + A_rx_4*f_4_25 + A_rx_5*f_5_25 + A_rx_6*f_6_25)
    )
    P_ry_25 = (
        t12*(A_ry_1*f_1_25 + A_ry_2*f_2_25 + A_ry_3*f_3_25 + A_ry_4*f_4_25 + A_ry_5*f_5_25 + A_ry_6*f_6_25)
    )
    P_rz_25 = (
        t12*(A_rz_1*f_1_25 + A_rz_2*f_2_25 + A_rz_3*f_3_25 + A_rz_4*f_4_25 + A_rz_5*f_5_25 + A_rz_6*f_6_25)
    )
    f_1_26 = (
        -U_1_x_2*U_1_x_6 - U_1_y_2*U_1_y_6 - U_1_z_2*U_1_z_6 - t138*(D_p_ry_2*t195 - D_p_rz_2*t30)
        - t138*(D_p_ry_6*t137 - D_p_rz_6*t26) - t140*(-D_p_rx_2*t195 + D_p_rz_2*t196) - t140*(-D_p_rx_6*t137
        + D_p_rz_6*t139) - t141*(D_p_rx_2*t30 - D_p_ry_2*t196) - t141*(D_p_rx_6*t26 - D_p_ry_6*t139)
    )
    f_2_26 = (
        -U_2_x_2*U_2_x_6 - U_2_y_2*U_2_y_6 - U_2_z_2*U_2_z_6 - t142*(D_p_ry_2*t197 - D_p_rz_2*t48)
        - t142*(-D_p_ry_6*t50 - D_p_rz_6*t44) - t143*(-D_p_rx_2*t197 + D_p_rz_2*t198) - t143*(D_p_rx_6*t50
        - D_p_rz_6*t38) - t144*(D_p_rx_2*t48 - D_p_ry_2*t198) - t144*(D_p_rx_6*t44 + D_p_ry_6*t38)
    )
    f_3_26 = (
        -U_3_x_2*U_3_x_6 - U_3_y_2*U_3_y_6 - U_3_z_2*U_3_z_6 - t146*(D_p_ry_2*t199 - D_p_rz_2*t66)
        - t146*(D_p_ry_6*t145 - D_p_rz_6*t62) - t148*(-D_p_rx_2*t199 + D_p_rz_2*t200) - t148*(-D_p_rx_6*t145
        + D_p_rz_6*t147) - t149*(D_p_rx_2*t66 - D_p_ry_2*t200) - t149*(D_p_rx_6*t62 - D_p_ry_6*t147)
    )
    f_4_26 = (
        -U_4_x_2*U_4_x_6 - U_4_y_2*U_4_y_6 - U_4_z_2*U_4_z_6 - t151*(D_p_ry_2*t201 - D_p_rz_2*t84)
        - t151*(D_p_ry_6*t150 - D_p_rz_6*t80) - t153*(-D_p_rx_2*t201 + D_p_rz_2*t202) - t153*(-D_p_rx_6*t150
        + D_p_rz_6*t152) - t154*(D_p_rx_2*t84 - D_p_ry_2*t202) - t154*(D_p_rx_6*t80 - D_p_ry_6*t152)
    )
    f_5_26 = (
        -U_5_x_2*U_5_x_6 - U_5_y_2*U_5_y_6 - U_5_z_2*U_5_z_6 - t156*(D_p_ry_2*t203 - D_p_rz_2*t102)
        - t156*(D_p_ry_6*t155 - D_p_rz_6*t98) - t158*(-D_p_rx_2*t203 + D_p_rz_2*t204) - t158*(-D_p_rx_6*t155
        + D_p_rz_6*t157) - t159*(D_p_rx_2*t102 - D_p_ry_2*t204) - t159*(D_p_rx_6*t98 - D_p_ry_6*t157)
    )
    f_6_26 = (
        -U_6_x_2*U_6_x_6 - U_6_y_2*U_6_y_6 - U_6_z_2*U_6_z_6 - t161*(-D_p_ry_2*t126 - D_p_rz_2*t120)
        - t161*(D_p_ry_6*t160 - D_p_rz_6*t116) - t163*(D_p_rx_2*t126 - D_p_rz_2*t114) - t163*(-D_p_rx_6*t160
        + D_p_rz_6*t162) - t164*(D_p_rx_2*t120 + D_p_ry_2*t114) - t164*(D_p_rx_6*t116 - D_p_ry_6*t162)
    )
    P_x_26 = t12*(A_x_1*f_1_26 + A_x_2*f_2_26 + A_x_3*f_3_26 + A_x_4*f_4_26 + A_x_5*f_5_26 + A_x_6*f_6_26)
    P_y_26 = t12*(A_y_1*f_1_26 + A_y_2*f_2_26 + A_y_3*f_3_26 + A_y_4*f_4_26 + A_y_5*f_5_26 + A_y_6*f_6_26)
    P_z_26 = t12*(A_z_1*f_1_26 + A_z_2*f_2_26 + A_z_3*f_3_26 + A_z_4*f_4_26 + A_z_5*f_5_26 + A_z_6*f_6_26)
    P_rx_26 = (
        t12*(A_rx_1*f_1_26 + A_rx_2*f_2_26 + A_rx_3*f_3_26 + A_rx_4*f_4_26 + A_rx_5*f_5_26 + A_rx_6*f_6_26)
    )
    P_ry_26 = (
        t12*(A_ry_1*f_1_26 + A_ry_2*f_2_26 + A_ry_3*f_3_26 + A_ry_4*f_4_26 + A_ry_5*f_5_26 + A_ry_6*f_6_26)
    )
    P_rz_26 = (
        t12*(A_rz_1*f_1_26 + A_rz_2*f_2_26 + A_rz_3*f_3_26 + A_rz_4*f_4_26 + A_rz_5*f_5_26 + A_rz_6*f_6_26)
    )
    f_1_33 = (
        -U_1_x_3**2 - U_1_y_3**2 - U_1_z_3**2 - s_1_x*(D_p_ry_3*t165 - D_p_rz_3*t27) - s_1_y*(-D_p_rx_3*t165
        + D_p_rz_3*t166) - s_1_z*(D_p_rx_3*t27 - D_p_ry_3*t166)
    )
    f_2_33 = (
        -U_2_x_3**2 - U_2_y_3**2 - U_2_z_3**2 - s_2_x*(D_p_ry_3*t167 - D_p_rz_3*t45) - s_2_y*(-D_p_rx_3*t167
        + D_p_rz_3*t168) - s_2_z*(D_p_rx_3*t45 - D_p_ry_3*t168)
    )
    f_3_33 = (
        -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2 - s_3_x*(-D_p_ry_3*t69 - D_p_rz_3*t63) - s_3_y*(D_p_rx_3*t69
        - D_p_rz_3*t57) - s_3_z*(D_p_rx_3*t63 + D_p_ry_3*t57)
    )
    f_4_33 = (
        -U_4_x_3**2 - U_4_y_3**2 - U_4_z_3**2 - s_4_x*(D_p_ry_3*t169 - D_p_rz_3*t81) - s_4_y*(-D_p_rx_3*t169
        + D_p_rz_3*t170) - s_4_z*(D_p_rx_3*t81 - D_p_ry_3*t170)
    )
    f_5_33 = (
        -U_5_x_3**2 - U_5_y_3**2 - U_5_z_3**2 - s_5_x*(D_p_ry_3*t171 - D_p_rz_3*t99) - s_5_y*(-D_p_rx_3*t171
        + D_p_rz_3*t172) - s_5_z*(D_p_rx_3*t99 - D_p_ry_3*t172)
    )
    f_6_33 = (
        -U_6_x_3**2 - U_6_y_3**2 - U_6_z_3**2 - s_6_x*(D_p_ry_3*t173 - D_p_rz_3*t117) - s_6_y*(-D_p_rx_3*t173
        + D_p_rz_3*t174) - s_6_z*(D_p_rx_3*t117 - D_p_ry_3*t174)
    )
    P_x_33 = t12*(A_x_1*f_1_33 + A_x_2*f_2_33 + A_x_3*f_3_33 + A_x_4*f_4_33 + A_x_5*f_5_33 + A_x_6*f_6_33)
    P_y_33 = t12*(A_y_1*f_1_33 + A_y_2*f_2_33 + A_y_3*f_3_33 + A_y_4*f_4_33 + A_y_5*f_5_33 + A_y_6*f_6_33)
    P_z_33 = t12*(A_z_1*f_1_33 + A_z_2*f_2_33 + A_z_3*f_3_33 + A_z_4*f_4_33 + A_z_5*f_5_33 + A_z_6*f_6_33)
    P_rx_33 = (
        t12*(A_rx_1*f_1_33 + A_rx_2*f_2_33 + A_rx_3*f_3_33 + A_rx_4*f_4_33 + A_rx_5*f_5_33 + A_rx_6*f_6_33)
    )
    P_ry_33 = (
        t12*(A_ry_1*f_1_33 + A_ry_2*f_2_33 + A_ry_3*f_3_33 + A_ry_4*f_4_33 + A_ry_5*f_5_33 + A_ry_6*f_6_33)
    )
    P_rz_33 = (
        t12*(A_rz_1*f_1_33 + A_rz_2*f_2_33 + A_rz_3*f_3_33 + A_rz_4*f_4_33 + A_rz_5*f_5_33 + A_rz_6*f_6_33)
    )
    f_1_34 = (
        -U_1_x_3*U_1_x_4 - U_1_y_3*U_1_y_4 - U_1_z_3*U_1_z_4 - t138*(D_p_ry_3*t175 - D_p_rz_3*t28)
        - t138*(D_p_ry_4*t165 - D_p_rz_4*t27) - t140*(-D_p_rx_3*t175 + D_p_rz_3*t176) - t140*(-D_p_rx_4*t165
        + D_p_rz_4*t166) - t141*(D_p_rx_3*t28 - D_p_ry_3*t176) - t141*(D_p_rx_4*t27 - D_p_ry_4*t166)
    )
    f_2_34 = (
        -U_2_x_3*U_2_x_4 - U_2_y_3*U_2_y_4 - U_2_z_3*U_2_z_4 - t142*(D_p_ry_3*t177 - D_p_rz_3*t46)
        - t142*(D_p_ry_4*t167 - D_p_rz_4*t45) - t143*(-D_p_rx_3*t177 + D_p_rz_3*t178) - t143*(-D_p_rx_4*t167
        + D_p_rz_4*t168) - t144*(D_p_rx_3*t46 - D_p_ry_3*t178) - t144*(D_p_rx_4*t45 - D_p_ry_4*t168)
    )
    f_3_34 = (
        -U_3_x_3*U_3_x_4 - U_3_y_3*U_3_y_4 - U_3_z_3*U_3_z_4 - t146*(D_p_ry_3*t179 - D_p_rz_3*t64)
        - t146*(-D_p_ry_4*t69 - D_p_rz_4*t63) - t148*(-D_p_rx_3*t179 + D_p_rz_3*t180) - t148*(D_p_rx_4*t69
        - D_p_rz_4*t57) - t149*(D_p_rx_3*t64 - D_p_ry_3*t180) - t149*(D_p_rx_4*t63 + D_p_ry_4*t57)
    )
    f_4_34 = (
        -U_4_x_3*U_4_x_4 - U_4_y_3*U_4_y_4 - U_4_z_3*U_4_z_4 - t151*(-D_p_ry_3*t88 - D_p_rz_3*t82)
        - t151*(D_p_ry_4*t169 - D_p_rz_4*t81) - t153*(D_p_rx_3*t88 - D_p_rz_3*t76) - t153*(-D_p_rx_4*t169
        + D_p_rz_4*t170) - t154*(D_p_rx_3*t82 + D_p_ry_3*t76) - t154*(D_p_rx_4*t81 - D_p_ry_4*t170)
    )
    f_5_34 = (
        -U_5_x_3*U_5_x_4 - U_5_y_3*U_5_y_4 - U_5_z_3*U_5_z_4 - t156*(D_p_ry_3*t181 - D_p_rz_3*t100)
        - t156*(D_p_ry_4*t171 - D_p_rz_4*t99) - t158*(-D_p_rx_3*t181 + D_p_rz_3*t182) - t158*(-D_p_rx_4*t171
        + D_p_rz_4*t172) - t159*(D_p_rx_3*t100 - D_p_ry_3*t182) - t159*(D_p_rx_4*t99 - D_p_ry_4*t172)
    )
    f_6_34 = (
        -U_6_x_3*U_6_x_4 - U_6_y_3*U_6_y_4 - U_6_z_3*U_6_z_4 - t161*(D_p_ry_3*t183 - D_p_rz_3*t118)
        - t161*(D_p_ry_4*t173 - D_p_rz_4*t117) - t163*(-D_p_rx_3*t183 + D_p_rz_3*t184) - t163*(-D_p_rx_4*t173
        + D_p_rz_4*t174) - t164*(D_p_rx_3*t118 - D_p_ry_3*t184) - t164*(D_p_rx_4*t117 - D_p_ry_4*t174)
    )
    P_x_34 = t12*(A_x_1*f_1_34 + A_x_2*f_2_34 + A_x_3*f_3_34 + A_x_4*f_4_34 + A_x_5*f_5_34 + A_x_6*f_6_34)
    P_y_34 = t12*(A_y_1*f_1_34 + A_y_2*f_2_34 + A_y_3*f_3_34 + A_y_4*f_4_34 + A_y_5*f_5_34 + A_y_6*f_6_34)
    P_z_34 = t12*(A_z_1*f_1_34 + A_z_2*f_2_34 + A_z_3*f_3_34 + A_z_4*f_4_34 + A_z_5*f_5_34 + A_z_6*f_6_34)
    P_rx_34 = (
        t12*(A_rx_1*f_1_34 + A_rx_2*f_2_34 + A_rx_3*f_3_34 + A_rx_4*f_4_34 + A_rx_5*f_5_34 + A_rx_6*f_6_34)
    )
    P_ry_34 = (
        t12*(A_ry_1*f_1_34 + A_ry_2*f_2_34 + A_ry_3*f_3_34 + A_ry_4*f_4_34 + A_ry_5*f_5_34 + A_ry_6*f_6_34)
    )
    P_rz_34 = (
        t12*(A_rz_1*f_1_34 + A_rz_2*f_2_34 + A_rz_3*f_3_34 + A_rz_4*f_4_34 + A_rz_5*f_5_34 + A_rz_6*f_6_34)
    )
    f_1_35 = (
        -U_1_x_3*U_1_x_5 - U_1_y_3*U_1_y_5 - U_1_z_3*U_1_z_5 - t138*(D_p_ry_3*t185 - D_p_rz_3*t29)
        - t138*(D_p_ry_5*t165 - D_p_rz_5*t27) - t140*(-D_p_rx_3*t185 + D_p_rz_3*t186) - t140*(-D_p_rx_5*t165
        + D_p_rz_5*t166) - t141*(D_p_rx_3*t29 - D_p_ry_3*t186) - t141*(D_p_rx_5*t27 - D_p_ry_5*t166)
    )
    f_2_35 = (
        -U_2_x_3*U_2_x_5 - U_2_y_3*U_2_y_5 - U_2_z_3*U_2_z_5 - t142*(D_p_ry_3*t187 - D_p_rz_3*t47)
        - t142*(D_p_ry_5*t167 - D_p_rz_5*t45) - t143*(-D_p_rx_3*t187 + D_p_rz_3*t188) - t143*(-D_p_rx_5*t167
        + D_p_rz_5*t168) - t144*(D_p_rx_3*t47 - D_p_ry_3*t188) - t144*(D_p_rx_5*t45 - D_p_ry_5*t168)
    )
    f_3_35 = (
        -U_3_x_3*U_3_x_5 - U_3_y_3*U_3_y_5 - U_3_z_3*U_3_z_5 - t146*(D_p_ry_3*t189 - D_p_rz_3*t65)
        - t146*(-D_p_ry_5*t69 - D_p_rz_5*t63) - t148*(-D_p_rx_3*t189 + D_p_rz_3*t190) - t148*(D_p_rx_5*t69
        - D_p_rz_5*t57) - t149*(D_p_rx_3*t65 - D_p_ry_3*t190) - t149*(D_p_rx_5*t63 + D_p_ry_5*t57)
    )
    f_4_35 = (
        -U_4_x_3*U_4_x_5 - U_4_y_3*U_4_y_5 - U_4_z_3*U_4_z_5 - t151*(D_p_ry_3*t191 - D_p_rz_3*t83)
        - t151*(D_p_ry_5*t169 - D_p_rz_5*t81) - t153*(-D_p_rx_3*t191 + D_p_rz_3*t192) - t153*(-D_p_rx_5*t169
        + D_p_rz_5*t170) - t154*(D_p_rx_3*t83 - D_p_ry_3*t192) - t154*(D_p_rx_5*t81 - D_p_ry_5*t170)
    )
    f_5_35 = (
        -U_5_x_3*U_5_x_5 - U_5_y_3*U_5_y_5 - U_5_z_3*U_5_z_5 - t156*(-D_p_ry_3*t107 - D_p_rz_3*t101)
        - t156*(D_p_ry_5*t171 - D_p_rz_5*t99) - t158*(D_p_rx_3*t107 - D_p_rz_3*t95) - t158*(-D_p_rx_5*t171
        + D_p_rz_5*t172) - t159*(D_p_rx_3*t101 + D_p_ry_3*t95) - t159*(D_p_rx_5*t99 - D_p_ry_5*t172)
    )
    f_6_35 = (
        -U_6_x_3*U_6_x_5 - U_6_y_3*U_6_y_5 - U_6_z_3*U_6_z_5 - t161*(D_p_ry_3*t193 - D_p_rz_3*t119)
        - t161*(D_p_ry_5*t173 - D_p_rz_5*t117) - t163*(-D_p_rx_3*t193 + D_p_rz_3*t194) - t163*(-D_p_rx_5*t173
        + D_p_rz_5*t174) - t164*(D_p_rx_3*t119 - D_p_ry_3*t194) - t164*(D_p_rx_5*t117 - D_p_ry_5*t174)
    )
    P_x_35 = t12*(A_x_1*f_1_35 + A_x_2*f_2_35 + A_x_3*f_3_35 + A_x_4*f_4_35 + A_x_5*f_5_35 + A_x_6*f_6_35)
    P_y_35 = t12*(A_y_1*f_1_35 + A_y_2*f_2_35 + A_y_3*f_3_35 + A_y_4*f_4_35 + A_y_5*f_5_35 + A_y_6*f_6_35)
    P_z_35 = t12*(A_z_1*f_1_35 + A_z_2*f_2_35 + A_z_3*f_3_35 + A_z_4*f_4_35 + A_z_5*f_5_35 + A_z_6*f_6_35)
    P_rx_35 = (
        t12*(A_rx_1*f_1_35 + A_rx_2*f_2_35 + A_rx_3*f_3_35 + A_rx_4*f_4_35 + A_rx_5*f_5_35 + A_rx_6*f_6_35)
    )
    P_ry_35 = (
        t12*(A_ry_1*f_1_35 + A_ry_2*f_2_35 + A_ry_3*f_3_35 + A_ry_4*f_4_35 + A_ry_5*f_5_35 + A_ry_6*f_6_35)
    )
    P_rz_35 = (
        t12*(A_rz_1*f_1_35 + A_rz_2*f_2_35 + A_rz_3*f_3_35 + A_rz_4*f_4_35 + A_rz_5*f_5_35 + A_rz_6*f_6_35)
    )
    f_1_36 = (
        -U_1_x_3*U_1_x_6 - U_1_y_3*U_1_y_6 - U_1_z_3*U_1_z_6 - t138*(D_p_ry_3*t195 - D_p_rz_3*t30)
        - t138*(D_p_ry_6*t165 - D_p_rz_6*t27) - t140*(-D_p_rx_3*t195 + D_p_rz_3*t196) - t140*(-D_p_rx_6*t165
        + D_p_rz_6*t166) - t141*(D_p_rx_3*t30 - D_p_ry_3*t196) - t141*(D_p_rx_6*t27 - D_p_ry_6*t166)
    )
    f_2_36 = (
        -U_2_x_3*U_2_x_6 - U_2_y_3*U_2_y_6 - U_2_z_3*U_2_z_6 - t142*(D_p_ry_3*t197 - D_p_rz_3*t48)
        - t142*(D_p_ry_6*t167 - D_p_rz_6*t45) - t143*(-D_p_rx_3*t197 + D_p_rz_3*t198) - t143*(-D_p_rx_6*t167
        + D_p_rz_6*t168) - t144*(D_p_rx_3*t48 - D_p_ry_3*t198) - t144*(D_p_rx_6*t45 - D_p_ry_6*t168)
    )
    f_3_36 = (
        -U_3_x_3*U_3_x_6 - U_3_y_3*U_3_y_6 - U_3_z_3*U_3_z_6 - t146*(D_p_ry_3*t199 - D_p_rz_3*t66)
        - t146*(-D_p_ry_6*t69 - D_p_rz_6*t63) - t148*(-D_p_rx_3*t199 + D_p_rz_3*t200) - t148*(D_p_rx_6*t69
        - D_p_rz_6*t57) - t149*(D_p_rx_3*t66 - D_p_ry_3*t200) - t149*(D_p_rx_6*t63 + D_p_ry_6*t57)
    )
    f_4_36 = (
        -U_4_x_3*U_4_x_6 - U_4_y_3*U_4_y_6 - U_4_z_3*U_4_z_6 - t151*(D_p_ry_3*t201 - D_p_rz_3*t84)
        - t151*(D_p_ry_6*t169 - D_p_rz_6*t81) - t153*(-D_p_rx_3*t201 + D_p_rz_3*t202) - t153*(-D_p_rx_6*t169
        + D_p_rz_6*t170) - t154*(D_p_rx_3*t84 - D_p_ry_3*t202) - t154*(D_p_rx_6*t81 - D_p_ry_6*t170)
    )
    f_5_36 = (
        -U_5_x_3*U_5_x_6 - U_5_y_3*U_5_y_6 - U_5_z_3*U_5_z_6 - t156*(D_p_ry_3*t203 - D_p_rz_3*t102)
        - t156*(D_p_ry_6*t171 - D_p_rz_6*t99) - t158*(-D_p_rx_3*t203 + D_p_rz_3*t204) - t158*(-D_p_rx_6*t171
        + D_p_rz_6*t172) - t159*(D_p_rx_3*t102 - D_p_ry_3*t204) - t159*(D_p_rx_6*t99 - D_p_ry_6*t172)
    )
    f_6_36 = (
        -U_6_x_3*U_6_x_6 - U_6_y_3*U_6_y_6 - U_6_z_3*U_6_z_6 - t161*(-D_p_ry_3*t126 - D_p_rz_3*t120)
        - t161*(D_p_ry_6*t173 - D_p_rz_6*t117) - t163*(D_p_rx_3*t126 - D_p_rz_3*t114) - t163*(-D_p_rx_6*t173
        + D_p_rz_6*t174) - t164*(D_p_rx_3*t120 + D_p_ry_3*t114) - t164*(D_p_rx_6*t117 - D_p_ry_6*t174)
    )
    P_x_36 = t12*(A_x_1*f_1_36 + A_x_2*f_2_36 + A_x_3*f_3_36 + A_x_4*f_4_36 + A_x_5*f_5_36 + A_x_6*f_6_36)
    P_y_36 = t12*(A_y_1*f_1_36 + A_y_2*f_2_36 + A_y_3*f_3_36 + A_y_4*f_4_36 + A_y_5*f_5_36 + A_y_6*f_6_36)
    P_z_36 = t12*(A_z_1*f_1_36 + A_z_2*f_2_36 + A_z_3*f_3_36 + A_z_4*f_4_36 + A_z_5*f_5_36 + A_z_6*f_6_36)
    P_rx_36 = (
        t12*(A_rx_1*f_1_36 + A_rx_2*f_2_36 + A_rx_3*f_3_36 + A_rx_4*f_4_36 + A_rx_5*f_5_36 + A_rx_6*f_6_36)
    )
    P_ry_36 = (
        t12*(A_ry_1*f_1_36 + A_ry_2*f_2_36 + A_ry_3*f_3_36 + A_ry_4*f_4_36 + A_ry_5*f_5_36 + A_ry_6*f_6_36)
    )
    P_rz_36 = (
        t12*(A_rz_1*f_1_36 + A_rz_2*f_2_36 + A_rz_3*f_3_36 + A_rz_4*f_4_36 + A_rz_5*f_5_36 + A_rz_6*f_6_36)
    )
    f_1_44 = (
        -U_1_x_4**2 - U_1_y_4**2 - U_1_z_4**2 - s_1_x*(D_p_ry_4*t175 - D_p_rz_4*t28) - s_1_y*(-D_p_rx_4*t175
        + D_p_rz_4*t176) - s_1_z*(D_p_rx_4*t28 - D_p_ry_4*t176)
    )
    f_2_44 = (
        -U_2_x_4**2 - U_2_y_4**2 - U_2_z_4**2 - s_2_x*(D_p_ry_4*t177 - D_p_rz_4*t46) - s_2_y*(-D_p_rx_4*t177
        + D_p_rz_4*t178) - s_2_z*(D_p_rx_4*t46 - D_p_ry_4*t178)
    )
    f_3_44 = (
        -U_3_x_4**2 - U_3_y_4**2 - U_3_z_4**2 - s_3_x*(D_p_ry_4*t179 - D_p_rz_4*t64) - s_3_y*(-D_p_rx_4*t179
        + D_p_rz_4*t180) - s_3_z*(D_p_rx_4*t64 - D_p_ry_4*t180)
    )
    f_4_44 = (
        -U_4_x_4**2 - U_4_y_4**2 - U_4_z_4**2 - s_4_x*(-D_p_ry_4*t88 - D_p_rz_4*t82) - s_4_y*(D_p_rx_4*t88
        - D_p_rz_4*t76) - s_4_z*(D_p_rx_4*t82 + D_p_ry_4*t76)
    )
    f_5_44 = (
        -U_5_x_4**2 - U_5_y_4**2 - U_5_z_4**2 - s_5_x*(D_p_ry_4*t181 - D_p_rz_4*t100) - s_5_y*(-D_p_rx_4*t181
        + D_p_rz_4*t182) - s_5_z*(D_p_rx_4*t100 - D_p_ry_4*t182)
    )
    f_6_44 = (
        -U_6_x_4**2 - U_6_y_4**2 - U_6_z_4**2 - s_6_x*(D_p_ry_4*t183 - D_p_rz_4*t118) - s_6_y*(-D_p_rx_4*t183
        + D_p_rz_4*t184) - s_6_z*(D_p_rx_4*t118 - D_p_ry_4*t184)
    )
    P_x_44 = t12*(A_x_1*f_1_44 + A_x_2*f_2_44 + A_x_3*f_3_44 + A_x_4*f_4_44 + A_x_5*f_5_44 + A_x_6*f_6_44)
    P_y_44 = t12*(A_y_1*f_1_44 + A_y_2*f_2_44 + A_y_3*f_3_44 + A_y_4*f_4_44 + A_y_5*f_5_44 + A_y_6*f_6_44)
    P_z_44 = t12*(A_z_1*f_1_44 + A_z_2*f_2_44 + A_z_3*f_3_44 + A_z_4*f_4_44 + A_z_5*f_5_44 + A_z_6*f_6_44)
    P_rx_44 = (
        t12*(A_rx_1*f_1_44 + A_rx_2*f_2_44 + A_rx_3*f_3_44 + A_rx_4*f_4_44 + A_rx_5*f_5_44 + A_rx_6*f_6_44)
    )
    P_ry_44 = (
        t12*(A_ry_1*f_1_44 + A_ry_2*f_2_44 + A_ry_3*f_3_44 + A_ry_4*f_4_44 + A_ry_5*f_5_44 + A_ry_6*f_6_44)
    )
    P_rz_44 = (
        t12*(A_rz_1*f_1_44 + A_rz_2*f_2_44 + A_rz_3*f_3_44 + A_rz_4*f_4_44 + A_rz_5*f_5_44 + A_rz_6*f_6_44)
    )
    f_1_45 = (
        -U_1_x_4*U_1_x_5 - U_1_y_4*U_1_y_5 - U_1_z_4*U_1_z_5 - t138*(D_p_ry_4*t185 - D_p_rz_4*t29)
        - t138*(D_p_ry_5*t175 - D_p_rz_5*t28) - t140*(-D_p_rx_4*t185 + D_p_rz_4*t186) - t140*(-D_p_rx_5*t175
        + D_p_rz_5*t176) - t141*(D_p_rx_4*t29 - D_p_ry_4*t186) - t141*(D_p_rx_5*t28 - D_p_ry_5*t176)
    )
    f_2_45 = (
        -U_2_x_4*U_2_x_5 - U_2_y_4*U_2_y_5 - U_2_z_4*U_2_z_5 - t142*(D_p_ry_4*t187 - D_p_rz_4*t47)
        - t142*(D_p_ry_5*t177 - D_p_rz_5*t46) - t143*(-D_p_rx_4*t187 + D_p_rz_4*t188) - t143*(-D_p_rx_5*t177
        + D_p_rz_5*t178) - t144*(D_p_rx_4*t47 - D_p_ry_4*t188) - t144*(D_p_rx_5*t46 - D_p_ry_5*t178)
    )
    f_3_45 = (
        -U_3_x_4*U_3_x_5 - U_3_y_4*U_3_y_5 - U_3_z_4*U_3_z_5 - t146*(D_p_ry_4*t189 - D_p_rz_4*t65)
        - t146*(D_p_ry_5*t179 - D_p_rz_5*t64) - t148*(-D_p_rx_4*t189 + D_p_rz_4*t190) - t148*(-D_p_rx_5*t179
        + D_p_rz_5*t180) - t149*(D_p_rx_4*t65 - D_p_ry_4*t190) - t149*(D_p_rx_5*t64 - D_p_ry_5*t180)
    )
    f_4_45 = (
        -U_4_x_4*U_4_x_5 - U_4_y_4*U_4_y_5 - U_4_z_4*U_4_z_5 - t151*(D_p_ry_4*t191 - D_p_rz_4*t83)
        - t151*(-D_p_ry_5*t88 - D_p_rz_5*t82) - t153*(-D_p_rx_4*t191 + D_p_rz_4*t192) - t153*(D_p_rx_5*t88
        - D_p_rz_5*t76) - t154*(D_p_rx_4*t83 - D_p_ry_4*t192) - t154*(D_p_rx_5*t82 + D_p_ry_5*t76)
    )
    f_5_45 = (
        -U_5_x_4*U_5_x_5 - U_5_y_4*U_5_y_5 - U_5_z_4*U_5_z_5 - t156*(-D_p_ry_4*t107 - D_p_rz_4*t101)
        - t156*(D_p_ry_5*t181 - D_p_rz_5*t100) - t158*(D_p_rx_4*t107 - D_p_rz_4*t95) - t158*(-D_p_rx_5*t181
        + D_p_rz_5*t182) - t159*(D_p_rx_4*t101 + D_p_ry_4*t95) - t159*(D_p_rx_5*t100 - D_p_ry_5*t182)
    )
    f_6_45 = (
        -U_6_x_4*U_6_x_5 - U_6_y_4*U_6_y_5 - U_6_z_4*U_6_z_5 - t161*(D_p_ry_4*t193 - D_p_rz_4*t119)
        - t161*(D_p_ry_5*t183 - D_p_rz_5*t118) - t163*(-D_p_rx_4*t193 + D_p_rz_4*t194) - t163*(-D_p_rx_5*t183
        + D_p_rz_5*t184) - t164*(D_p_rx_4*t119 - D_p_ry_4*t194) - t164*(D_p_rx_5*t118 - D_p_ry_5*t184)
    )
    P_x_45 = t12*(A_x_1*f_1_45 + A_x_2*f_2_45 + A_x_3*f_3_45 + A_x_4*f_4_45 + A_x_5*f_5_45 + A_x_6*f_6_45)
    P_y_45 = t12*(A_y_1*f_1_45 + A_y_2*f_2_45 + A_y_3*f_3_45 + A_y_4*f_4_45 + A_y_5*f_5_45 + A_y_6*f_6_45)
    P_z_45 = t12*(A_z_1*f_1_45 + A_z_2*f_2_45 + A_z_3*f_3_45 + A_z_4*f_4_45 + A_z_5*f_5_45 + A_z_6*f_6_45)
    P_rx_45 = (
        t12*(A_rx_1*f_1_45 + A_rx_2*f_2_45 + A_rx_3*f_3_45 + A_rx_4*f_4_45 + A_rx_5*f_5_45 + A_rx_6*f_6_45)
    )
    P_ry_45 = (
        t12*(A_ry_1*f_1_45 + A_ry_2*f_2_45 + A_ry_3*f_3_45 + A_ry_4*f_4_45 + A_ry_5*f_5_45 + A_ry_6*f_6_45)
    )
    P_rz_45 = (
        t12*(A_rz_1*f_1_45 + A_rz_2*f_2_45 + A_rz_3*f_3_45 + A_rz_4*f_4_45 + A_rz_5*f_5_45 + A_rz_6*f_6_45)
    )
    f_1_46 = (
        -U_1_x_4*U_1_x_6 - U_1_y_4*U_1_y_6 - U_1_z_4*U_1_z_6 - t138*(D_p_ry_4*t195 - D_p_rz_4*t30)
        - t138*(D_p_ry_6*t175 - D_p_rz_6*t28) - t140*(-D_p_rx_4*t195 + D_p_rz_4*t196) - t140*(-D_p_rx_6*t175
        + D_p_rz_6*t176) - t141*(D_p_rx_4*t30 - D_p_ry_4*t196) - t141*(D_p_rx_6*t28 - D_p_ry_6*t176)
    )
    f_2_46 = (
        -U_2_x_4*U_2_x_6 - U_2_y_4*U_2_y_6 - U_2_z_4*U_2_z_6 - t142*(D_p_ry_4*t197 - D_p_rz_4*t48)
        - t142*(D_p_ry_6*t177 - D_p_rz_6*t46) - t143*(-D_p_rx_4*t197 + D_p_rz_4*t198) - t143*(-D_p_rx_6*t177
        + D_p_rz_6*t178) - t144*(D_p_rx_4*t48 - D_p_ry_4*t198) - t144*(D_p_rx_6*t46 - D_p_ry_6*t178)
    )
    f_3_46 = (
        -U_3_x_4*U_3_x_6 - U_3_y_4*U_3_y_6 - U_3_z_4*U_3_z_6 - t146*(D_p_ry_4*t199 - D_p_rz_4*t66)
        - t146*(D_p_ry_6*t179 - D_p_rz_6*t64) - t148*(-D_p_rx_4*t199 + D_p_rz_4*t200) - t148*(-D_p_rx_6*t179
        + D_p_rz_6*t180) - t149*(D_p_rx_4*t66 - D_p_ry_4*t200) - t149*(D_p_rx_6*t64 - D_p_ry_6*t180)
    )
    f_4_46 = (
        -U_4_x_4*U_4_x_6 - U_4_y_4*U_4_y_6 - U_4_z_4*U_4_z_6 - t151*(D_p_ry_4*t201 - D_p_rz_4*t84)
        - t151*(-D_p_ry_6*t88 - D_p_rz_6*t82) - t153*(-D_p_rx_4*t201 + D_p_rz_4*t202) - t153*(D_p_rx_6*t88
        - D_p_rz_6*t76) - t154*(D_p_rx_4*t84 - D_p_ry_4*t202) - t154*(D_p_rx_6*t82 + D_p_ry_6*t76)
    )
    f_5_46 = (
        -U_5_x_4*U_5_x_6 - U_5_y_4*U_5_y_6 - U_5_z_4*U_5_z_6 - t156*(D_p_ry_4*t203 - D_p_rz_4*t102)
        - t156*(D_p_ry_6*t181 - D_p_rz_6*t100) - t158*(-D_p_rx_4*t203 + D_p_rz_4*t204) - t158*(-D_p_rx_6*t181
        + D_p_rz_6*t182) - t159*(D_p_rx_4*t102 - D_p_ry_4*t204) - t159*(D_p_rx_6*t100 - D_p_ry_6*t182)
    )
    f_6_46 = (
        -U_6_x_4*U_6_x_6 - U_6_y_4*U_6_y_6 - U_6_z_4*U_6_z_6 - t161*(-D_p_ry_4*t126 - D_p_rz_4*t120)
        - t161*(D_p_ry_6*t183 - D_p_rz_6*t118) - t163*(D_p_rx_4*t126 - D_p_rz_4*t114) - t163*(-D_p_rx_6*t183
        + D_p_rz_6*t184) - t164*(D_p_rx_4*t120 + D_p_ry_4*t114) - t164*(D_p_rx_6*t118 - D_p_ry_6*t184)
    )
    P_x_46 = t12*(A_x_1*f_1_46 + A_x_2*f_2_46 + A_x_3*f_3_46 + A_x_4*f_4_46 + A_x_5*f_5_46 + A_x_6*f_6_46)
    P_y_46 = t12*(A_y_1*f_1_46 + A_y_2*f_2_46 + A_y_3*f_3_46 + A_y_4*f_4_46 + A_y_5*f_5_46 + A_y_6*f_6_46)
    P_z_46 = t12*(A_z_1*f_1_46 + A_z_2*f_2_46 + A_z_3*f_3_46 + A_z_4*f_4_46 + A_z_5*f_5_46 + A_z_6*f_6_46)
    P_rx_46 = (
        t12*(A_rx_1*f_1_46 + A_rx_2*f_2_46 + A_rx_3*f_3_46 + A_rx_4*f_4_46 + A_rx_5*f_5_46 + A_rx_6*f_6_46)
    )
    P_ry_46 = (
        t12*(A_ry_1*f_1_46 + A_ry_2*f_2_46 + A_ry_3*f_3_46 + A_ry_4*f_4_46 + A_ry_5*f_5_46 + A_ry_6*f_6_46)
    )
    P_rz_46 = (
        t12*(A_rz_1*f_1_46 + A_rz_2*f_2_46 + A_rz_3*f_3_46 + A_rz_4*f_4_46 + A_rz_5*f_5_46 + A_rz_6*f_6_46)
    )
    f_1_55 = (
        -U_1_x_5**2 - U_1_y_5**2 - U_1_z_5**2 - s_1_x*(D_p_ry_5*t185 - D_p_rz_5*t29) - s_1_y*(-D_p_rx_5*t185
        + D_p_rz_5*t186) - s_1_z*(D_p_rx_5*t29 - D_p_ry_5*t186)
    )
    f_2_55 = (
        -U_2_x_5**2 - U_2_y_5**2 - U_2_z_5**2 - s_2_x*(D_p_ry_5*t187 - D_p_rz_5*t47) - s_2_y*(-D_p_rx_5*t187
        + D_p_rz_5*t188) - s_2_z*(D_p_rx_5*t47 - D_p_ry_5*t188)
    )
    f_3_55 = (
        -U_3_x_5**2 - U_3_y_5**2 - U_3_z_5**2 - s_3_x*(D_p_ry_5*t189 - D_p_rz_5*t65) - s_3_y*(-D_p_rx_5*t189
        + D_p_rz_5*t190) - s_3_z*(D_p_rx_5*t65 - D_p_ry_5*t190)
    )
    f_4_55 = (
        -U_4_x_5**2 - U_4_y_5**2 - U_4_z_5**2 - s_4_x*(D_p_ry_5*t191 - D_p_rz_5*t83) - s_4_y*(-D_p_rx_5*t191
        + D_p_rz_5*t192) - s_4_z*(D_p_rx_5*t83 - D_p_ry_5*t192)
    )
    f_5_55 = (
        -U_5_x_5**2 - U_5_y_5**2 - U_5_z_5**2 - s_5_x*(-D_p_ry_5*t107 - D_p_rz_5*t101) - s_5_y*(D_p_rx_5*t107
        - D_p_rz_5*t95) - s_5_z*(D_p_rx_5*t101 + D_p_ry_5*t95)
    )
    f_6_55 = (
        -U_6_x_5**2 - U_6_y_5**2 - U_6_z_5**2 - s_6_x*(D_p_ry_5*t193 - D_p_rz_5*t119) - s_6_y*(-D_p_rx_5*t193
        + D_p_rz_5*t194) - s_6_z*(D_p_rx_5*t119 - D_p_ry_5*t194)
    )
    P_x_55 = t12*(A_x_1*f_1_55 + A_x_2*f_2_55 + A_x_3*f_3_55 + A_x_4*f_4_55 + A_x_5*f_5_55 + A_x_6*f_6_55)
    P_y_55 = t12*(A_y_1*f_1_55 + A_y_2*f_2_55 + A_y_3*f_3_55 + A_y_4*f_4_55 + A_y_5*f_5_55 + A_y_6*f_6_55)
    P_z_55 = t12*(A_z_1*f_1_55 + A_z_2*f_2_55 + A_z_3*f_3_55 + A_z_4*f_4_55 + A_z_5*f_5_55 + A_z_6*f_6_55)
    P_rx_55 = (
        t12*(A_rx_1*f_1_55 + A_rx_2*f_2_55 + A_rx_3*f_3_55 + A_rx_4*f_4_55 + A_rx_5*f_5_55 + A_rx_6*f_6_55)
    )
    P_ry_55 = (
        t12*(A_ry_1*f_1_55 + A_ry_2*f_2_55 + A_ry_3*f_3_55 + A_ry_4*f_4_55 + A_ry_5*f_5_55 + A_ry_6*f_6_55)
    )
    P_rz_55 = (
        t12*(A_rz_1*f_1_55 + A_rz_2*f_2_55 + A_rz_3*f_3_55 + A_rz_4*f_4_55 + A_rz_5*f_5_55 + A_rz_6*f_6_55)
    )
    f_1_56 = (
        -U_1_x_5*U_1_x_6 - U_1_y_5*U_1_y_6 - U_1_z_5*U_1_z_6 - t138*(D_p_ry_5*t195 - D_p_rz_5*t30)
        - t138*(D_p_ry_6*t185 - D_p_rz_6*t29) - t140*(-D_p_rx_5*t195 + D_p_rz_5*t196) - t140*(-D_p_rx_6*t185
        + D_p_rz_6*t186) - t141*(D_p_rx_5*t30 - D_p_ry_5*t196) - t141*(D_p_rx_6*t29 - D_p_ry_6*t186)
    )
    f_2_56 = (
        -U_2_x_5*U_2_x_6 - U_2_y_5*U_2_y_6 - U_2_z_5*U_2_z_6 - t142*(D_p_ry_5*t197 - D_p_rz_5*t48)
        - t142*(D_p_ry_6*t187 - D_p_rz_6*t47) - t143*(-D_p_rx_5*t197 + D_p_rz_5*t198) - t143*(-D_p_rx_6*t187
        + D_p_rz_6*t188) - t144*(D_p_rx_5*t48 - D_p_ry_5*t198) - t144*(D_p_rx_6*t47 - D_p_ry_6*t188)
    )
    f_3_56 = (
        -U_3_x_5*U_3_x_6 - U_3_y_5*U_3_y_6 - U_3_z_5*U_3_z_6 - t146*(D_p_ry_5*t199 - D_p_rz_5*t66)
        - t146*(D_p_ry_6*t189 - D_p_rz_6*t65) - t148*(-D_p_rx_5*t199 + D_p_rz_5*t200) - t148*(-D_p_rx_6*t189
        + D_p_rz_6*t190) - t149*(D_p_rx_5*t66 - D_p_ry_5*t200) - t149*(D_p_rx_6*t65 - D_p_ry_6*t190)
    )
    f_4_56 = (
        -U_4_x_5*U_4_x_6 - U_4_y_5*U_4_y_6 - U_4_z_5*U_4_z_6 - t151*(D_p_ry_5*t201 - D_p_rz_5*t84)
        - t151*(D_p_ry_6*t191 - D_p_rz_6*t83) - t153*(-D_p_rx_5*t201 + D_p_rz_5*t202) - t153*(-D_p_rx_6*t191
        + D_p_rz_6*t192) - t154*(D_p_rx_5*t84 - D_p_ry_5*t202) - t154*(D_p_rx_6*t83 - D_p_ry_6*t192)
    )
    f_5_56 = (
        -U_5_x_5*U_5_x_6 - U_5_y_5*U_5_y_6 - U_5_z_5*U_5_z_6 - t156*(D_p_ry_5*t203 - D_p_rz_5*t102)
        - t156*(-D_p_ry_6*t107 - D_p_rz_6*t101) - t158*(-D_p_rx_5*t203 + D_p_rz_5*t204) - t158*(D_p_rx_6*t107
        - D_p_rz_6*t95) - t159*(D_p_rx_5*t102 - D_p_ry_5*t204) - t159*(D_p_rx_6*t101 + D_p_ry_6*t95)
    )
    f_6_56 = (
        -U_6_x_5*U_6_x_6 - U_6_y_5*U_6_y_6 - U_6_z_5*U_6_z_6 - t161*(-D_p_ry_5*t126 - D_p_rz_5*t120)
        - t161*(D_p_ry_6*t193 - D_p_rz_6*t119) - t163*(D_p_rx_5*t126 - D_p_rz_5*t114) - t163*(-D_p_rx_6*t193
        + D_p_rz_6*t194) - t164*(D_p_rx_5*t120 + D_p_ry_5*t114) - t164*(D_p_rx_6*t119 - D_p_ry_6*t194)
    )
    P_x_56 = t12*(A_x_1*f_1_56 + A_x_2*f_2_56 + A_x_3*f_3_56 + A_x_4*f_4_56 + A_x_5*f_5_56 + A_x_6*f_6_56)
    P_y_56 = t12*(A_y_1*f_1_56 + A_y_2*f_2_56 + A_y_3*f_3_56 + A_y_4*f_4_56 + A_y_5*f_5_56 + A_y_6*f_6_56)
    P_z_56 = t12*(A_z_1*f_1_56 + A_z_2*f_2_56 + A_z_3*f_3_56 + A_z_4*f_4_56 + A_z_5*f_5_56 + A_z_6*f_6_56)
    P_rx_56 = (
        t12*(A_rx_1*f_1_56 + A_rx_2*f_2_56 + A_rx_3*f_3_56 + A_rx_4*f_4_56 + A_rx_5*f_5_56 + A_rx_6*f_6_56)
    )
    P_ry_56 = (
        t12*(A_ry_1*f_1_56 + A_ry_2*f_2_56 + A_ry_3*f_3_56 + A_ry_4*f_4_56 + A_ry_5*f_5_56 + A_ry_6*f_6_56)
    )
    P_rz_56 = (
        t12*(A_rz_1*f_1_56 + A_rz_2*f_2_56 + A_rz_3*f_3_56 + A_rz_4*f_4_56 + A_rz_5*f_5_56 + A_rz_6*f_6_56)
    )
    f_1_66 = (
        -U_1_x_6**2 - U_1_y_6**2 - U_1_z_6**2 - s_1_x*(D_p_ry_6*t195 - D_p_rz_6*t30) - s_1_y*(-D_p_rx_6*t195
        + D_p_rz_6*t196) - s_1_z*(D_p_rx_6*t30 - D_p_ry_6*t196)
    )
    f_2_66 = (
        -U_2_x_6**2 - U_2_y_6**2 - U_2_z_6**2 - s_2_x*(D_p_ry_6*t197 - D_p_rz_6*t48) - s_2_y*(-D_p_rx_6*t197
        + D_p_rz_6*t198) - s_2_z*(D_p_rx_6*t48 - D_p_ry_6*t198)
    )
    f_3_66 = (
        -U_3_x_6**2 - U_3_y_6**2 - U_3_z_6**2 - s_3_x*(D_p_ry_6*t199 - D_p_rz_6*t66) - s_3_y*(-D_p_rx_6*t199
        + D_p_rz_6*t200) - s_3_z*(D_p_rx_6*t66 - D_p_ry_6*t200)
    )
    f_4_66 = (
        -U_4_x_6**2 - U_4_y_6**2 - U_4_z_6**2 - s_4_x*(D_p_ry_6*t201 - D_p_rz_6*t84) - s_4_y*(-D_p_rx_6*t201
        + D_p_rz_6*t202) - s_4_z*(D_p_rx_6*t84 - D_p_ry_6*t202)
    )
    f_5_66 = (
        -U_5_x_6**2 - U_5_y_6**2 - U_5_z_6**2 - s_5_x*(D_p_ry_6*t203 - D_p_rz_6*t102) - s_5_y*(-D_p_rx_6*t203
        + D_p_rz_6*t204) - s_5_z*(D_p_rx_6*t102 - D_p_ry_6*t204)
    )
    f_6_66 = (
        -U_6_x_6**2 - U_6_y_6**2 - U_6_z_6**2 - s_6_x*(-D_p_ry_6*t126 - D_p_rz_6*t120) - s_6_y*(D_p_rx_6*t126
        - D_p_rz_6*t114) - s_6_z*(D_p_rx_6*t120 + D_p_ry_6*t114)
    )
    P_x_66 = t12*(A_x_1*f_1_66 + A_x_2*f_2_66 + A_x_3*f_3_66 + A_x_4*f_4_66 + A_x_5*f_5_66 + A_x_6*f_6_66)
    P_y_66 = t12*(A_y_1*f_1_66 + A_y_2*f_2_66 + A_y_3*f_3_66 + A_y_4*f_4_66 + A_y_5*f_5_66 + A_y_6*f_6_66)
    P_z_66 = t12*(A_z_1*f_1_66 + A_z_2*f_2_66 + A_z_3*f_3_66 + A_z_4*f_4_66 + A_z_5*f_5_66 + A_z_6*f_6_66)
    P_rx_66 = (
        t12*(A_rx_1*f_1_66 + A_rx_2*f_2_66 + A_rx_3*f_3_66 + A_rx_4*f_4_66 + A_rx_5*f_5_66 + A_rx_6*f_6_66)
    )
    P_ry_66 = (
        t12*(A_ry_1*f_1_66 + A_ry_2*f_2_66 + A_ry_3*f_3_66 + A_ry_4*f_4_66 + A_ry_5*f_5_66 + A_ry_6*f_6_66)
    )
    P_rz_66 = (
        t12*(A_rz_1*f_1_66 + A_rz_2*f_2_66 + A_rz_3*f_3_66 + A_rz_4*f_4_66 + A_rz_5*f_5_66 + A_rz_6*f_6_66)
    )
    P_out = np.empty((*batch, 6, 6, 6), dtype)
    P_out[..., 0, 0, 0] = P_x_11
    P_out[..., 0, 0, 1] = P_out[..., 0, 1, 0] = P_x_12
    P_out[..., 0, 0, 2] = P_out[..., 0, 2, 0] = P_x_13
    P_out[..., 0, 0, 3] = P_out[..., 0, 3, 0] = P_x_14
    P_out[..., 0, 0, 4] = P_out[..., 0, 4, 0] = P_x_15
    P_out[..., 0, 0, 5] = P_out[..., 0, 5, 0] = P_x_16
    P_out[..., 0, 1, 1] = P_x_22
    P_out[..., 0, 1, 2] = P_out[..., 0, 2, 1] = P_x_23
    P_out[..., 0, 1, 3] = P_out[..., 0, 3, 1] = P_x_24
    P_out[..., 0, 1, 4] = P_out[..., 0, 4, 1] = P_x_25
    P_out[..., 0, 1, 5] = P_out[..., 0, 5, 1] = P_x_26
    P_out[..., 0, 2, 2] = P_x_33
    P_out[..., 0, 2, 3] = P_out[..., 0, 3, 2] = P_x_34
    P_out[..., 0, 2, 4] = P_out[..., 0, 4, 2] = P_x_35
    P_out[..., 0, 2, 5] = P_out[..., 0, 5, 2] = P_x_36
    P_out[..., 0, 3, 3] = P_x_44
    P_out[..., 0, 3, 4] = P_out[..., 0, 4, 3] = P_x_45
    P_out[..., 0, 3, 5] = P_out[..., 0, 5, 3] = P_x_46
    P_out[..., 0, 4, 4] = P_x_55
    P_out[..., 0, 4, 5] = P_out[..., 0, 5, 4] = P_x_56
    P_out[..., 0, 5, 5] = P_x_66
    P_out[..., 1, 0, 0] = P_y_11
    P_out[..., 1, 0, 1] = P_out[..., 1, 1, 0] = P_y_12
    P_out[..., 1, 0, 2] = P_out[..., 1, 2, 0] = P_y_13
    P_out[..., 1, 0, 3] = P_out[..., 1, 3, 0] = P_y_14
    P_out[..., 1, 0, 4] = P_out[..., 1, 4, 0] = P_y_15
    P_out[..., 1, 0, 5] = P_out[..., 1, 5, 0] = P_y_16
    P_out[..., 1, 1, 1] = P_y_22
    P_out[..., 1, 1, 2] = P_out[..., 1, 2, 1] = P_y_23
    P_out[..., 1, 1, 3] = P_out[..., 1, 3, 1] = P_y_24
    P_out[..., 1, 1, 4] = P_out[..., 1, 4, 1] = P_y_25
    P_out[..., 1, 1, 5] = P_out[..., 1, 5, 1] = P_y_26
    P_out[..., 1, 2, 2] = P_y_33
    P_out[..., 1, 2, 3] = P_out[..., 1, 3, 2] = P_y_34
    P_out[..., 1, 2, 4] = P_out[..., 1, 4, 2] = P_y_35
    P_out[..., 1, 2, 5] = P_out[..., 1, 5, 2] = P_y_36
    P_out[..., 1, 3, 3] = P_y_44
    P_out[..., 1, 3, 4] = P_out[..., 1, 4, 3] = P_y_45
    P_out[..., 1, 3, 5] = P_out[..., 1, 5, 3] = P_y_46
    P_out[..., 1, 4, 4] = P_y_55
    P_out[..., 1, 4, 5] = P_out[..., 1, 5, 4] = P_y_56
    P_out[..., 1, 5, 5] = P_y_66
    P_out[..., 2, 0, 0] = P_z_11
    P_out[..., 2, 0, 1] = P_out[..., 2, 1, 0] = P_z_12
    P_out[..., 2, 0, 2] = P_out[..., 2, 2, 0] = P_z_13
    P_out[..., 2, 0, 3] = P_out[..., 2, 3, 0] = P_z_14
    P_out[..., 2, 0, 4] = P_out[..., 2, 4, 0] = P_z_15
    P_out[..., 2, 0, 5] = P_out[..., 2, 5, 0] = P_z_16
    P_out[..., 2, 1, 1] = P_z_22
    P_out[..., 2, 1, 2] = P_out[..., 2, 2, 1] = P_z_23
    P_out[..., 2, 1, 3] = P_out[..., 2, 3, 1] = P_z_24
    P_out[..., 2, 1, 4] = P_out[..., 2, 4, 1] = P_z_25
    P_out[..., 2, 1, 5] = P_out[..., 2, 5, 1] = P_z_26
    P_out[..., 2, 2, 2] = P_z_33
    P_out[..., 2, 2, 3] = P_out[..., 2, 3, 2] = P_z_34
    P_out[..., 2, 2, 4] = P_out[..., 2, 4, 2] = P_z_35
    P_out[..., 2, 2, 5] = P_out[..., 2, 5, 2] = P_z_36
    P_out[..., 2, 3, 3] = P_z_44
    P_out[..., 2, 3, 4] = P_out[..., 2, 4, 3] = P_z_45
    P_out[..., 2, 3, 5] = P_out[..., 2, 5, 3] = P_z_46
    P_out[..., 2, 4, 4] = P_z_55
    P_out[..., 2, 4, 5] = P_out[..., 2, 5, 4] = P_z_56
    P_out[..., 2, 5, 5] = P_z_66
    P_out[..., 3, 0, 0] = P_rx_11
    P_out[..., 3, 0, 1] = P_out[..., 3, 1, 0] = P_rx_12
    P_out[..., 3, 0, 2] = P_out[..., 3, 2, 0] = P_rx_13
    P_out[..., 3, 0, 3] = P_out[..., 3, 3, 0] = P_rx_14
    P_out[..., 3, 0, 4] = P_out[..., 3, 4, 0] = P_rx_15
    P_out[..., 3, 0, 5] = P_out[..., 3, 5, 0] = P_rx_16
    P_out[..., 3, 1, 1] = P_rx_22
    P_out[..., 3, 1, 2] = P_out[..., 3, 2, 1] = P_rx_23
    P_out[..., 3, 1, 3] = P_out[..., 3, 3, 1] = P_rx_24
    P_out[..., 3, 1, 4] = P_out[..., 3, 4, 1] = P_rx_25
    P_out[..., 3, 1, 5] = P_out[..., 3, 5, 1] = P_rx_26
    P_out[..., 3, 2, 2] = P_rx_33
    P_out[..., 3, 2, 3] = P_out[..., 3, 3, 2] = P_rx_34
    P_out[..., 3, 2, 4] = P_out[..., 3, 4, 2] = P_rx_35
    P_out[..., 3, 2, 5] = P_out[..., 3, 5, 2] = P_rx_36
    P_out[..., 3, 3, 3] = P_rx_44
    P_out[..., 3, 3, 4] = P_out[..., 3, 4, 3] = P_rx_45
    P_out[..., 3, 3, 5] = P_out[..., 3, 5, 3] = P_rx_46
    P_out[..., 3, 4, 4] = P_rx_55
    P_out[..., 3, 4, 5] = P_out[..., 3, 5, 4] = P_rx_56
    P_out[..., 3, 5, 5] = P_rx_66
    P_out[..., 4, 0, 0] = P_ry_11
    P_out[..., 4, 0, 1] = P_out[..., 4, 1, 0] = P_ry_12
    P_out[..., 4, 0, 2] = P_out[..., 4, 2, 0] = P_ry_13
    P_out[..., 4, 0, 3] = P_out[..., 4, 3, 0] = P_ry_14
    P_out[..., 4, 0, 4] = P_out[..., 4, 4, 0] = P_ry_15
    P_out[..., 4, 0, 5] = P_out[..., 4, 5, 0] = P_ry_16
    P_out[..., 4, 1, 1] = P_ry_22
    P_out[..., 4, 1, 2] = P_out[..., 4, 2, 1] = P_ry_23
    P_out[..., 4, 1, 3] = P_out[..., 4, 3, 1] = P_ry_24
    P_out[..., 4, 1, 4] = P_out[..., 4, 4, 1] = P_ry_25
    P_out[..., 4, 1, 5] = P_out[..., 4, 5, 1] = P_ry_26
    P_out[..., 4, 2, 2] = P_ry_33
    P_out[..., 4, 2, 3] = P_out[..., 4, 3, 2] = P_ry_34
    P_out[..., 4, 2, 4] = P_out[..., 4, 4, 2] = P_ry_35
    P_out[..., 4, 2, 5] = P_out[..., 4, 5, 2] = P_ry_36
    P_out[..., 4, 3, 3] = P_ry_44
    P_out[..., 4, 3, 4] = P_out[..., 4, 4, 3] = P_ry_45
    P_out[..., 4, 3, 5] = P_out[..., 4, 5, 3] = P_ry_46
    P_out[..., 4, 4, 4] = P_ry_55
    P_out[..., 4, 4, 5] = P_out[..., 4, 5, 4] = P_ry_56
    P_out[..., 4, 5, 5] = P_ry_66
    P_out[..., 5, 0, 0] = P_rz_11
    P_out[..., 5, 0, 1] = P_out[..., 5, 1, 0] = P_rz_12
    P_out[..., 5, 0, 2] = P_out[..., 5, 2, 0] = P_rz_13
    P_out[..., 5, 0, 3] = P_out[..., 5, 3, 0] = P_rz_14
    P_out[..., 5, 0, 4] = P_out[..., 5, 4, 0] = P_rz_15
    P_out[..., 5, 0, 5] = P_out[..., 5, 5, 0] = P_rz_16
    P_out[..., 5, 1, 1] = P_rz_22
    P_out[..., 5, 1, 2] = P_out[..., 5, 2, 1] = P_rz_23
    P_out[..., 5, 1, 3] = P_out[..., 5, 3, 1] = P_rz_24
    P_out[..., 5, 1, 4] = P_out[..., 5, 4, 1] = P_rz_25
    P_out[..., 5, 1, 5] = P_out[..., 5, 5, 1] = P_rz_26
    P_out[..., 5, 2, 2] = P_rz_33
    P_out[..., 5, 2, 3] = P_out[..., 5, 3, 2] = P_rz_34
    P_out[..., 5, 2, 4] = P_out[..., 5, 4, 2] = P_rz_35
    P_out[..., 5, 2, 5] = P_out[..., 5, 5, 2] = P_rz_36
    P_out[..., 5, 3, 3] = P_rz_44
    P_out[..., 5, 3, 4] = P_out[..., 5, 4, 3] = P_rz_45
    P_out[..., 5, 3, 5] = P_out[..., 5, 5, 3] = P_rz_46
    P_out[..., 5, 4, 4] = P_rz_55
    P_out[..., 5, 4, 5] = P_out[..., 5, 5, 4] = P_rz_56
    P_out[..., 5, 5, 5] = P_rz_66
    return P_out


def link_jacobians(p, parameters):
    """Jacobians of the linkages: centre of mass and angular velocity.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_d : array, shape (..., 6, 3, 6) [1]
        D_d[j-1] x_dot is the velocity of the centre of mass of linkage j.
    D_omega : array, shape (..., 6, 3, 6) [1/m]
        D_omega[j-1] x_dot is the angular velocity of linkage j.

    Notes
    -----
    Equations 16 and 23; the angular velocity without spin about the rod, which carries no energy.
    3020 operations; 4904818992 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
    a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z
    w_1_x = -a_1*n_1_x + r_1_x
    w_1_y = -a_1*n_1_y + r_1_y
    w_1_z = -a_1*n_1_z + r_1_z
    w2_1 = w_1_x**2 + w_1_y**2 + w_1_z**2
    t12 = l_d_1**2
    x_1 = a_1 + sigma_1*np.sqrt(t12 - w2_1)
    a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z
    w_2_x = -a_2*n_2_x + r_2_x
    w_2_y = -a_2*n_2_y + r_2_y
    w_2_z = -a_2*n_2_z + r_2_z
    w2_2 = w_2_x**2 + w_2_y**2 + w_2_z**2
    t13 = l_d_2**2
    x_2 = a_2 + sigma_2*np.sqrt(t13 - w2_2)
    a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z
    w_3_x = -a_3*n_3_x + r_3_x
    w_3_y = -a_3*n_3_y + r_3_y
    w_3_z = -a_3*n_3_z + r_3_z
    w2_3 = w_3_x**2 + w_3_y**2 + w_3_z**2
    t14 = l_d_3**2
    x_3 = a_3 + sigma_3*np.sqrt(t14 - w2_3)
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    t15 = l_d_4**2
    x_4 = a_4 + sigma_4*np.sqrt(t15 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    t16 = l_d_5**2
    x_5 = a_5 + sigma_5*np.sqrt(t16 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    t17 = l_d_6**2
    x_6 = a_6 + sigma_6*np.sqrt(t17 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t18 = 1.0/det_D_l
    t19 = D_r_1*t18
    D_p_x_1 = A_x_1*t19
    t20 = D_r_2*t18
    D_p_x_2 = A_x_2*t20
    t21 = D_r_3*t18
    D_p_x_3 = A_x_3*t21
    t22 = D_r_4*t18
    D_p_x_4 = A_x_4*t22
    t23 = D_r_5*t18
    D_p_x_5 = A_x_5*t23
    t24 = D_r_6*t18
    D_p_x_6 = A_x_6*t24
    D_p_y_1 = A_y_1*t19
    D_p_y_2 = A_y_2*t20
    D_p_y_3 = A_y_3*t21
    D_p_y_4 = A_y_4*t22
    D_p_y_5 = A_y_5*t23
    D_p_y_6 = A_y_6*t24
    D_p_z_1 = A_z_1*t19
    D_p_z_2 = A_z_2*t20
    D_p_z_3 = A_z_3*t21
    D_p_z_4 = A_z_4*t22
    D_p_z_5 = A_z_5*t23
    D_p_z_6 = A_z_6*t24
    D_p_rx_1 = A_rx_1*t19
    D_p_rx_2 = A_rx_2*t20
    D_p_rx_3 = A_rx_3*t21
    D_p_rx_4 = A_rx_4*t22
    D_p_rx_5 = A_rx_5*t23
    D_p_rx_6 = A_rx_6*t24
    D_p_ry_1 = A_ry_1*t19
    D_p_ry_2 = A_ry_2*t20
    D_p_ry_3 = A_ry_3*t21
    D_p_ry_4 = A_ry_4*t22
    D_p_ry_5 = A_ry_5*t23
    D_p_ry_6 = A_ry_6*t24
    D_p_rz_1 = A_rz_1*t19
    D_p_rz_2 = A_rz_2*t20
    D_p_rz_3 = A_rz_3*t21
    D_p_rz_4 = A_rz_4*t22
    D_p_rz_5 = A_rz_5*t23
    D_p_rz_6 = A_rz_6*t24
    t25 = B_1_y*D_p_rz_1
    U_1_x_1 = B_1_z*D_p_ry_1 + D_p_x_1 - n_1_x - t25
    t26 = B_1_z*D_p_ry_2
    t27 = B_1_y*D_p_rz_2
    U_1_x_2 = D_p_x_2 + t26 - t27
    t28 = B_1_z*D_p_ry_3
    t29 = B_1_y*D_p_rz_3
    U_1_x_3 = D_p_x_3 + t28 - t29
    t30 = B_1_z*D_p_ry_4
    t31 = B_1_y*D_p_rz_4
    U_1_x_4 = D_p_x_4 + t30 - t31
    t32 = B_1_z*D_p_ry_5
    t33 = B_1_y*D_p_rz_5
    U_1_x_5 = D_p_x_5 + t32 - t33
    t34 = B_1_z*D_p_ry_6
    t35 = B_1_y*D_p_rz_6
    U_1_x_6 = D_p_x_6 + t34 - t35
    t36 = B_1_x*D_p_rz_1
    t37 = B_1_z*D_p_rx_1
    U_1_y_1 = D_p_y_1 - n_1_y + t36 - t37
    t38 = B_1_x*D_p_rz_2
    t39 = B_1_z*D_p_rx_2
    U_1_y_2 = D_p_y_2 + t38 - t39
    t40 = B_1_x*D_p_rz_3
    t41 = B_1_z*D_p_rx_3
    U_1_y_3 = D_p_y_3 + t40 - t41
    t42 = B_1_x*D_p_rz_4
    t43 = B_1_z*D_p_rx_4
    U_1_y_4 = D_p_y_4 + t42 - t43
    t44 = B_1_x*D_p_rz_5
    t45 = B_1_z*D_p_rx_5
    U_1_y_5 = D_p_y_5 + t44 - t45
    t46 = B_1_x*D_p_rz_6
    t47 = B_1_z*D_p_rx_6
    U_1_y_6 = D_p_y_6 + t46 - t47
    t48 = B_1_x*D_p_ry_1
    U_1_z_1 = B_1_y*D_p_rx_1 + D_p_z_1 - n_1_z - t48
    t49 = B_1_y*D_p_rx_2
    t50 = B_1_x*D_p_ry_2
    U_1_z_2 = D_p_z_2 + t49 - t50
    t51 = B_1_y*D_p_rx_3
    t52 = B_1_x*D_p_ry_3
    U_1_z_3 = D_p_z_3 + t51 - t52
    t53 = B_1_y*D_p_rx_4
    t54 = B_1_x*D_p_ry_4
    U_1_z_4 = D_p_z_4 + t53 - t54
    t55 = B_1_y*D_p_rx_5
    t56 = B_1_x*D_p_ry_5
    U_1_z_5 = D_p_z_5 + t55 - t56
    t57 = B_1_y*D_p_rx_6
    t58 = B_1_x*D_p_ry_6
    U_1_z_6 = D_p_z_6 + t57 - t58
    t59 = B_2_z*D_p_ry_1
    t60 = B_2_y*D_p_rz_1
    U_2_x_1 = D_p_x_1 + t59 - t60
    t61 = B_2_y*D_p_rz_2
    U_2_x_2 = B_2_z*D_p_ry_2 + D_p_x_2 - n_2_x - t61
    t62 = B_2_z*D_p_ry_3
    t63 = B_2_y*D_p_rz_3
    U_2_x_3 = D_p_x_3 + t62 - t63
    t64 = B_2_z*D_p_ry_4
    t65 = B_2_y*D_p_rz_4
    U_2_x_4 = D_p_x_4 + t64 - t65
    t66 = B_2_z*D_p_ry_5
    t67 = B_2_y*D_p_rz_5
    U_2_x_5 = D_p_x_5 + t66 - t67
    t68 = B_2_z*D_p_ry_6
    t69 = B_2_y*D_p_rz_6
    U_2_x_6 = D_p_x_6 + t68 - t69
    t70 = B_2_x*D_p_rz_1
    t71 = B_2_z*D_p_rx_1
    U_2_y_1 = D_p_y_1 + t70 - t71
    t72 = B_2_x*D_p_rz_2
    t73 = B_2_z*D_p_rx_2
    U_2_y_2 = D_p_y_2 - n_2_y + t72 - t73
    t74 = B_2_x*D_p_rz_3
    t75 = B_2_z*D_p_rx_3
    U_2_y_3 = D_p_y_3 + t74 - t75
    t76 = B_2_x*D_p_rz_4
    t77 = B_2_z*D_p_rx_4
    U_2_y_4 = D_p_y_4 + t76 - t77
    t78 = B_2_x*D_p_rz_5
    t79 = B_2_z*D_p_rx_5
    U_2_y_5 = D_p_y_5 + t78 - t79
    t80 = B_2_x*D_p_rz_6
    t81 = B_2_z*D_p_rx_6
    U_2_y_6 = D_p_y_6 + t80 - t81
    t82 = B_2_x*D_p_ry_1
    t83 = B_2_y*D_p_rx_1
    U_2_z_1 = D_p_z_1 - t82 + t83
    t84 = B_2_x*D_p_ry_2
    U_2_z_2 = B_2_y*D_p_rx_2 + D_p_z_2 - n_2_z - t84
    t85 = B_2_y*D_p_rx_3
    t86 = B_2_x*D_p_ry_3
    U_2_z_3 = D_p_z_3 + t85 - t86
    t87 = B_2_y*D_p_rx_4
    t88 = B_2_x*D_p_ry_4
    U_2_z_4 = D_p_z_4 + t87 - t88
    t89 = B_2_y*D_p_rx_5
    t90 = B_2_x*D_p_ry_5
    U_2_z_5 = D_p_z_5 + t89 - t90
    t91 = B_2_y*D_p_rx_6
    t92 = B_2_x*D_p_ry_6
    U_2_z_6 = D_p_z_6 + t91 - t92
    t93 = B_3_z*D_p_ry_1
    t94 = B_3_y*D_p_rz_1
    U_3_x_1 = D_p_x_1 + t93 - t94
    t95 = B_3_z*D_p_ry_2
    t96 = B_3_y*D_p_rz_2
    U_3_x_2 = D_p_x_2 + t95 - t96
    t97 = B_3_y*D_p_rz_3
    U_3_x_3 = B_3_z*D_p_ry_3 + D_p_x_3 - n_3_x - t97
    t98 = B_3_z*D_p_ry_4
    t99 = B_3_y*D_p_rz_4
    U_3_x_4 = D_p_x_4 + t98 - t99
    t100 = B_3_z*D_p_ry_5
    t101 = B_3_y*D_p_rz_5
    U_3_x_5 = D_p_x_5 + t100 - t101
    t102 = B_3_z*D_p_ry_6
    t103 = B_3_y*D_p_rz_6
    U_3_x_6 = D_p_x_6 + t102 - t103
    t104 = B_3_x*D_p_rz_1
    t105 = B_3_z*D_p_rx_1
    U_3_y_1 = D_p_y_1 + t104 - t105
    t106 = B_3_x*D_p_rz_2
    t107 = B_3_z*D_p_rx_2
    U_3_y_2 = D_p_y_2 + t106 - t107
    t108 = B_3_x*D_p_rz_3
    t109 = B_3_z*D_p_rx_3
    U_3_y_3 = D_p_y_3 - n_3_y + t108 - t109
    t110 = B_3_x*D_p_rz_4
    t111 = B_3_z*D_p_rx_4
    U_3_y_4 = D_p_y_4 + t110 - t111
    t112 = B_3_x*D_p_rz_5
    t113 = B_3_z*D_p_rx_5
    U_3_y_5 = D_p_y_5 + t112 - t113
    t114 = B_3_x*D_p_rz_6
    t115 = B_3_z*D_p_rx_6
    U_3_y_6 = D_p_y_6 + t114 - t115
    t116 = B_3_y*D_p_rx_1
    t117 = B_3_x*D_p_ry_1
    U_3_z_1 = D_p_z_1 + t116 - t117
    t118 = B_3_y*D_p_rx_2
    t119 = B_3_x*D_p_ry_2
    U_3_z_2 = D_p_z_2 + t118 - t119
    t120 = B_3_x*D_p_ry_3
    U_3_z_3 = B_3_y*D_p_rx_3 + D_p_z_3 - n_3_z - t120
    t121 = B_3_y*D_p_rx_4
    t122 = B_3_x*D_p_ry_4
    U_3_z_4 = D_p_z_4 + t121 - t122
    t123 = B_3_y*D_p_rx_5
    t124 = B_3_x*D_p_ry_5
    U_3_z_5 = D_p_z_5 + t123 - t124
    t125 = B_3_y*D_p_rx_6
    t126 = B_3_x*D_p_ry_6
    U_3_z_6 = D_p_z_6 + t125 - t126
    t127 = B_4_z*D_p_ry_1
    t128 = B_4_y*D_p_rz_1
    U_4_x_1 = D_p_x_1 + t127 - t128
    t129 = B_4_z*D_p_ry_2
    t130 = B_4_y*D_p_rz_2
    U_4_x_2 = D_p_x_2 + t129 - t130
    t131 = B_4_z*D_p_ry_3
    t132 = B_4_y*D_p_rz_3
    U_4_x_3 = D_p_x_3 + t131 - t132
    t133 = B_4_y*D_p_rz_4
    U_4_x_4 = B_4_z*D_p_ry_4 + D_p_x_4 - n_4_x - t133
    t134 = B_4_z*D_p_ry_5
    t135 = B_4_y*D_p_rz_5
    U_4_x_5 = D_p_x_5 + t134 - t135
    t136 = B_4_z*D_p_ry_6
    t137 = B_4_y*D_p_rz_6
    U_4_x_6 = D_p_x_6 + t136 - t137
    t138 = B_4_x*D_p_rz_1
    t139 = B_4_z*D_p_rx_1
    U_4_y_1 = D_p_y_1 + t138 - t139
    t140 = B_4_x*D_p_rz_2
    t141 = B_4_z*D_p_rx_2
    U_4_y_2 = D_p_y_2 + t140 - t141
    t142 = B_4_x*D_p_rz_3
    t143 = B_4_z*D_p_rx_3
    U_4_y_3 = D_p_y_3 + t142 - t143
    t144 = B_4_x*D_p_rz_4
    t145 = B_4_z*D_p_rx_4
    U_4_y_4 = D_p_y_4 - n_4_y + t144 - t145
    t146 = B_4_x*D_p_rz_5
    t147 = B_4_z*D_p_rx_5
    U_4_y_5 = D_p_y_5 + t146 - t147
    t148 = B_4_x*D_p_rz_6
    t149 = B_4_z*D_p_rx_6
    U_4_y_6 = D_p_y_6 + t148 - t149
    t150 = B_4_y*D_p_rx_1
    t151 = B_4_x*D_p_ry_1
    U_4_z_1 = D_p_z_1 + t150 - t151
    t152 = B_4_y*D_p_rx_2
    t153 = B_4_x*D_p_ry_2
    U_4_z_2 = D_p_z_2 + t152 - t153
    t154 = B_4_y*D_p_rx_3
    t155 = B_4_x*D_p_ry_3
    U_4_z_3 = D_p_z_3 + t154 - t155
    t156 = B_4_x*D_p_ry_4
    U_4_z_4 = B_4_y*D_p_rx_4 + D_p_z_4 - n_4_z - t156
    t157 = B_4_y*D_p_rx_5
    t158 = B_4_x*D_p_ry_5
    U_4_z_5 = D_p_z_5 + t157 - t158
    t159 = B_4_y*D_p_rx_6
    t160 = B_4_x*D_p_ry_6
    U_4_z_6 = D_p_z_6 + t159 - t160
    t161 = B_5_z*D_p_ry_1
    t162 = B_5_y*D_p_rz_1
    U_5_x_1 = D_p_x_1 + t161 - t162
    t163 = B_5_z*D_p_ry_2
    t164 = B_5_y*D_p_rz_2
    U_5_x_2 = D_p_x_2 + t163 - t164
    t165 = B_5_z*D_p_ry_3
    t166 = B_5_y*D_p_rz_3
    U_5_x_3 = D_p_x_3 + t165 - t166
    t167 = B_5_z*D_p_ry_4
    t168 = B_5_y*D_p_rz_4
    U_5_x_4 = D_p_x_4 + t167 - t168
    t169 = B_5_y*D_p_rz_5
    U_5_x_5 = B_5_z*D_p_ry_5 + D_p_x_5 - n_5_x - t169
    t170 = B_5_z*D_p_ry_6
    t171 = B_5_y*D_p_rz_6
    U_5_x_6 = D_p_x_6 + t170 - t171
    t172 = B_5_x*D_p_rz_1
    t173 = B_5_z*D_p_rx_1
    U_5_y_1 = D_p_y_1 + t172 - t173
    t174 = B_5_x*D_p_rz_2
    t175 = B_5_z*D_p_rx_2
    U_5_y_2 = D_p_y_2 + t174 - t175
    t176 = B_5_x*D_p_rz_3
    t177 = B_5_z*D_p_rx_3
    U_5_y_3 = D_p_y_3 + t176 - t177
    t178 = B_5_x*D_p_rz_4
    t179 = B_5_z*D_p_rx_4
    U_5_y_4 = D_p_y_4 + t178 - t179
    t180 = B_5_x*D_p_rz_5
    t181 = B_5_z*D_p_rx_5
    U_5_y_5 = D_p_y_5 - n_5_y + t180 - t181
    t182 = B_5_x*D_p_rz_6
    t183 = B_5_z*D_p_rx_6
    U_5_y_6 = D_p_y_6 + t182 - t183
    t184 = B_5_y*D_p_rx_1
    t185 = B_5_x*D_p_ry_1
    U_5_z_1 = D_p_z_1 + t184 - t185
    t186 = B_5_y*D_p_rx_2
    t187 = B_5_x*D_p_ry_2
    U_5_z_2 = D_p_z_2 + t186 - t187
    t188 = B_5_y*D_p_rx_3
    t189 = B_5_x*D_p_ry_3
    U_5_z_3 = D_p_z_3 + t188 - t189
    t190 = B_5_y*D_p_rx_4
    t191 = B_5_x*D_p_ry_4
    U_5_z_4 = D_p_z_4 + t190 - t191
    t192 = B_5_x*D_p_ry_5
    U_5_z_5 = B_5_y*D_p_rx_5 + D_p_z_5 - n_5_z - t192
    t193 = B_5_y*D_p_rx_6
    t194 = B_5_x*D_p_ry_6
    U_5_z_6 = D_p_z_6 + t193 - t194
    t195 = B_6_z*D_p_ry_1
    t196 = B_6_y*D_p_rz_1
    U_6_x_1 = D_p_x_1 + t195 - t196
    t197 = B_6_z*D_p_ry_2
    t198 = B_6_y*D_p_rz_2
    U_6_x_2 = D_p_x_2 + t197 - t198
    t199 = B_6_z*D_p_ry_3
    t200 = B_6_y*D_p_rz_3
    U_6_x_3 = D_p_x_3 + t199 - t200
    t201 = B_6_z*D_p_ry_4
    t202 = B_6_y*D_p_rz_4
    U_6_x_4 = D_p_x_4 + t201 - t202
    t203 = B_6_z*D_p_ry_5
    t204 = B_6_y*D_p_rz_5
    U_6_x_5 = D_p_x_5 + t203 - t204
    t205 = B_6_y*D_p_rz_6
    U_6_x_6 = B_6_z*D_p_ry_6 + D_p_x_6 - n_6_x - t205
    t206 = B_6_x*D_p_rz_1
    t207 = B_6_z*D_p_rx_1
    U_6_y_1 = D_p_y_1 + t206 - t207
    t208 = B_6_x*D_p_rz_2
    t209 = B_6_z*D_p_rx_2
    U_6_y_2 = D_p_y_2 + t208 - t209
    t210 = B_6_x*D_p_rz_3
    t211 = B_6_z*D_p_rx_3
    U_6_y_3 = D_p_y_3 + t210 - t211
    t212 = B_6_x*D_p_rz_4
    t213 = B_6_z*D_p_rx_4
    U_6_y_4 = D_p_y_4 + t212 - t213
    t214 = B_6_x*D_p_rz_5
    t215 = B_6_z*D_p_rx_5
    U_6_y_5 = D_p_y_5 + t214 - t215
    t216 = B_6_x*D_p_rz_6
    t217 = B_6_z*D_p_rx_6
    U_6_y_6 = D_p_y_6 - n_6_y + t216 - t217
    t218 = B_6_y*D_p_rx_1
    t219 = B_6_x*D_p_ry_1
    U_6_z_1 = D_p_z_1 + t218 - t219
    t220 = B_6_y*D_p_rx_2
    t221 = B_6_x*D_p_ry_2
    U_6_z_2 = D_p_z_2 + t220 - t221
    t222 = B_6_y*D_p_rx_3
    t223 = B_6_x*D_p_ry_3
    U_6_z_3 = D_p_z_3 + t222 - t223
    t224 = B_6_y*D_p_rx_4
    t225 = B_6_x*D_p_ry_4
    U_6_z_4 = D_p_z_4 + t224 - t225
    t226 = B_6_y*D_p_rx_5
    t227 = B_6_x*D_p_ry_5
    U_6_z_5 = D_p_z_5 + t226 - t227
    t228 = B_6_x*D_p_ry_6
    U_6_z_6 = B_6_y*D_p_rx_6 + D_p_z_6 - n_6_z - t228
    t229 = (1/2)*D_p_x_1
    t230 = (1/2)*D_p_x_2
    t231 = (1/2)*D_p_x_3
    t232 = (1/2)*D_p_x_4
    t233 = (1/2)*D_p_x_5
    t234 = (1/2)*D_p_x_6
    t235 = (1/2)*D_p_y_1
    t236 = (1/2)*D_p_y_2
    t237 = (1/2)*D_p_y_3
    t238 = (1/2)*D_p_y_4
    t239 = (1/2)*D_p_y_5
    t240 = (1/2)*D_p_y_6
    t241 = (1/2)*D_p_z_1
    t242 = (1/2)*D_p_z_2
    t243 = (1/2)*D_p_z_3
    t244 = (1/2)*D_p_z_4
    t245 = (1/2)*D_p_z_5
    t246 = (1/2)*D_p_z_6
    t247 = 1.0/t12
    t248 = 1.0/t13
    t249 = 1.0/t14
    t250 = 1.0/t15
    t251 = 1.0/t16
    t252 = 1.0/t17
    D_d_out = np.empty((*batch, 6, 3, 6), dtype)
    D_d_out[..., 0, 0, 0] = (1/2)*B_1_z*D_p_ry_1 + (1/2)*n_1_x + t229 - 1/2*t25
    D_d_out[..., 0, 0, 1] = t230 + (1/2)*t26 - 1/2*t27
    D_d_out[..., 0, 0, 2] = t231 + (1/2)*t28 - 1/2*t29
    D_d_out[..., 0, 0, 3] = t232 + (1/2)*t30 - 1/2*t31
    D_d_out[..., 0, 0, 4] = t233 + (1/2)*t32 - 1/2*t33
    D_d_out[..., 0, 0, 5] = t234 + (1/2)*t34 - 1/2*t35
    D_d_out[..., 0, 1, 0] = (1/2)*n_1_y + t235 + (1/2)*t36 - 1/2*t37
    D_d_out[..., 0, 1, 1] = t236 + (1/2)*t38 - 1/2*t39
    D_d_out[..., 0, 1, 2] = t237 + (1/2)*t40 - 1/2*t41
    D_d_out[..., 0, 1, 3] = t238 + (1/2)*t42 - 1/2*t43
    D_d_out[..., 0, 1, 4] = t239 + (1/2)*t44 - 1/2*t45
    D_d_out[..., 0, 1, 5] = t240 + (1/2)*t46 - 1/2*t47
    D_d_out[..., 0, 2, 0] = (1/2)*B_1_y*D_p_rx_1 + (1/2)*n_1_z + t241 - 1/2*t48
    D_d_out[..., 0, 2, 1] = t242 + (1/2)*t49 - 1/2*t50
    D_d_out[..., 0, 2, 2] = t243 + (1/2)*t51 - 1/2*t52
    D_d_out[..., 0, 2, 3] = t244 + (1/2)*t53 - 1/2*t54
    D_d_out[..., 0, 2, 4] = t245 + (1/2)*t55 - 1/2*t56
    D_d_out[..., 0, 2, 5] = t246 + (1/2)*t57 - 1/2*t58
    D_d_out[..., 1, 0, 0] = t229 + (1/2)*t59 - 1/2*t60
    D_d_out[..., 1, 0, 1] = (1/2)*B_2_z*D_p_ry_2 + (1/2)*n_2_x + t230 - 1/2*t61
    D_d_out[..., 1, 0, 2] = t231 + (1/2)*t62 - 1/2*t63
    D_d_out[..., 1, 0, 3] = t232 + (1/2)*t64 - 1/2*t65
    D_d_out[..., 1, 0, 4] = t233 + (1/2)*t66 - 1/2*t67
    D_d_out[..., 1, 0, 5] = t234 + (1/2)*t68 - 1/2*t69
    D_d_out[..., 1, 1, 0] = t235 + (1/2)*t70 - 1/2*t71
    D_d_out[..., 1, 1, 1] = (1/2)*n_2_y + t236 + (1/2)*t72 - 1/2*t73
    D_d_out[..., 1, 1, 2] = t237 + (1/2)*t74 - 1/2*t75
    D_d_out[..., 1, 1, 3] = t238 + (1/2)*t76 - 1/2*t77
    D_d_out[..., 1, 1, 4] = t239 + (1/2)*t78 - 1/2*t79
    D_d_out[..., 1, 1, 5] = t240 + (1/2)*t80 - 1/2*t81
    D_d_out[..., 1, 2, 0] = t241 - 1/2*t82 + (1/2)*t83
    D_d_out[..., 1, 2, 1] = (1/2)*B_2_y*D_p_rx_2 + (1/2)*n_2_z + t242 - 1/2*t84
    D_d_out[..., 1, 2, 2] = t243 + (1/2)*t85 - 1/2*t86
    D_d_out[..., 1, 2, 3] = t244 + (1/2)*t87 - 1/2*t88
    D_d_out[..., 1, 2, 4] = t245 + (1/2)*t89 - 1/2*t90
    D_d_out[..., 1, 2, 5] = t246 + (1/2)*t91 - 1/2*t92
    D_d_out[..., 2, 0, 0] = t229 + (1/2)*t93 - 1/2*t94
    D_d_out[..., 2, 0, 1] = t230 + (1/2)*t95 - 1/2*t96
    D_d_out[..., 2, 0, 2] = (1/2)*B_3_z*D_p_ry_3 + (1/2)*n_3_x + t231 - 1/2*t97
    D_d_out[..., 2, 0, 3] = t232 + (1/2)*t98 - 1/2*t99
    D_d_out[..., 2, 0, 4] = (1/2)*t100 - 1/2*t101 + t233
    D_d_out[..., 2, 0, 5] = (1/2)*t102 - 1/2*t103 + t234
    D_d_out[..., 2, 1, 0] = (1/2)*t104 - 1/2*t105 + t235
    D_d_out[..., 2, 1, 1] = (1/2)*t106 - 1/2*t107 + t236
    D_d_out[..., 2, 1, 2] = (1/2)*n_3_y + (1/2)*t108 - 1/2*t109 + t237
    D_d_out[..., 2, 1, 3] = (1/2)*t110 - 1/2*t111 + t238
    D_d_out[..., 2, 1, 4] = (1/2)*t112 - 1/2*t113 + t239
    D_d_out[..., 2, 1, 5] = (1/2)*t114 - 1/2*t115 + t240
    D_d_out[..., 2, 2, 0] = (1/2)*t116 - 1/2*t117 + t241
    D_d_out[..., 2, 2, 1] = (1/2)*t118 - 1/2*t119 + t242
    D_d_out[..., 2, 2, 2] = (1/2)*B_3_y*D_p_rx_3 + (1/2)*n_3_z - 1/2*t120 + t243
    D_d_out[..., 2, 2, 3] = (1/2)*t121 - 1/2*t122 + t244
    D_d_out[..., 2, 2, 4] = (1/2)*t123 - 1/2*t124 + t245
    D_d_out[..., 2, 2, 5] = (1/2)*t125 - 1/2*t126 + t246
    D_d_out[..., 3, 0, 0] = (1/2)*t127 - 1/2*t128 + t229
    D_d_out[..., 3, 0, 1] = (1/2)*t129 - 1/2*t130 + t230
    D_d_out[..., 3, 0, 2] = (1/2)*t131 - 1/2*t132 + t231
    D_d_out[..., 3, 0, 3] = (1/2)*B_4_z*D_p_ry_4 + (1/2)*n_4_x - 1/2*t133 + t232
    D_d_out[..., 3, 0, 4] = (1/2)*t134 - 1/2*t135 + t233
    D_d_out[..., 3, 0, 5] = (1/2)*t136 - 1/2*t137 + t234
    D_d_out[..., 3, 1, 0] = (1/2)*t138 - 1/2*t139 + t235
    D_d_out[..., 3, 1, 1] = (1/2)*t140 - 1/2*t141 + t236
    D_d_out[..., 3, 1, 2] = (1/2)*t142 - 1/2*t143 + t237
    D_d_out[..., 3, 1, 3] = (1/2)*n_4_y + (1/2)*t144 - 1/2*t145 + t238
    D_d_out[..., 3, 1, 4] = (1/2)*t146 - 1/2*t147 + t239
    D_d_out[..., 3, 1, 5] = (1/2)*t148 - 1/2*t149 + t240
    D_d_out[..., 3, 2, 0] = (1/2)*t150 - 1/2*t151 + t241
    D_d_out[..., 3, 2, 1] = (1/2)*t152 - 1/2*t153 + t242
    D_d_out[..., 3, 2, 2] = (1/2)*t154 - 1/2*t155 + t243
    D_d_out[..., 3, 2, 3] = (1/2)*B_4_y*D_p_rx_4 + (1/2)*n_4_z - 1/2*t156 + t244
    D_d_out[..., 3, 2, 4] = (1/2)*t157 - 1/2*t158 + t245
    D_d_out[..., 3, 2, 5] = (1/2)*t159 - 1/2*t160 + t246
    D_d_out[..., 4, 0, 0] = (1/2)*t161 - 1/2*t162 + t229
    D_d_out[..., 4, 0, 1] = (1/2)*t163 - 1/2*t164 + t230
    D_d_out[..., 4, 0, 2] = (1/2)*t165 - 1/2*t166 + t231
    D_d_out[..., 4, 0, 3] = (1/2)*t167 - 1/2*t168 + t232
    D_d_out[..., 4, 0, 4] = (1/2)*B_5_z*D_p_ry_5 + (1/2)*n_5_x - 1/2*t169 + t233
    D_d_out[..., 4, 0, 5] = (1/2)*t170 - 1/2*t171 + t234
    D_d_out[..., 4, 1, 0] = (1/2)*t172 - 1/2*t173 + t235
    D_d_out[..., 4, 1, 1] = (1/2)*t174 - 1/2*t175 + t236
    D_d_out[..., 4, 1, 2] = (1/2)*t176 - 1/2*t177 + t237
    D_d_out[..., 4, 1, 3] = (1/2)*t178 - 1/2*t179 + t238
    D_d_out[..., 4, 1, 4] = (1/2)*n_5_y + (1/2)*t180 - 1/2*t181 + t239
    D_d_out[..., 4, 1, 5] = (1/2)*t182 - 1/2*t183 + t240
    D_d_out[..., 4, 2, 0] = (1/2)*t184 - 1/2*t185 + t241
    D_d_out[..., 4, 2, 1] = (1/2)*t186 - 1/2*t187 + t242
    D_d_out[..., 4, 2, 2] = (1/2)*t188 - 1/2*t189 + t243
    D_d_out[..., 4, 2, 3] = (1/2)*t190 - 1/2*t191 + t244
    D_d_out[..., 4, 2, 4] = (1/2)*B_5_y*D_p_rx_5 + (1/2)*n_5_z - 1/2*t192 + t245
    D_d_out[..., 4, 2, 5] = (1/2)*t193 - 1/2*t194 + t246
    D_d_out[..., 5, 0, 0] = (1/2)*t195 - 1/2*t196 + t229
    D_d_out[..., 5, 0, 1] = (1/2)*t197 - 1/2*t198 + t230
    D_d_out[..., 5, 0, 2] = (1/2)*t199 - 1/2*t200 + t231
    D_d_out[..., 5, 0, 3] = (1/2)*t201 - 1/2*t202 + t232
    D_d_out[..., 5, 0, 4] = (1/2)*t203 - 1/2*t204 + t233
    D_d_out[..., 5, 0, 5] = (1/2)*B_6_z*D_p_ry_6 + (1/2)*n_6_x - 1/2*t205 + t234
    D_d_out[..., 5, 1, 0] = (1/2)*t206 - 1/2*t207 + t235
    D_d_out[..., 5, 1, 1] = (1/2)*t208 - 1/2*t209 + t236
    D_d_out[..., 5, 1, 2] = (1/2)*t210 - 1/2*t211 + t237
    D_d_out[..., 5, 1, 3] = (1/2)*t212 - 1/2*t213 + t238
    D_d_out[..., 5, 1, 4] = (1/2)*t214 - 1/2*t215 + t239
    D_d_out[..., 5, 1, 5] = (1/2)*n_6_y + (1/2)*t216 - 1/2*t217 + t240
    D_d_out[..., 5, 2, 0] = (1/2)*t218 - 1/2*t219 + t241
    D_d_out[..., 5, 2, 1] = (1/2)*t220 - 1/2*t221 + t242
    D_d_out[..., 5, 2, 2] = (1/2)*t222 - 1/2*t223 + t243
    D_d_out[..., 5, 2, 3] = (1/2)*t224 - 1/2*t225 + t244
    D_d_out[..., 5, 2, 4] = (1/2)*t226 - 1/2*t227 + t245
    D_d_out[..., 5, 2, 5] = (1/2)*B_6_y*D_p_rx_6 + (1/2)*n_6_z - 1/2*t228 + t246
    D_omega_out = np.empty((*batch, 6, 3, 6), dtype)
    D_omega_out[..., 0, 0, 0] = t247*(-U_1_y_1*s_1_z + U_1_z_1*s_1_y)
    D_omega_out[..., 0, 0, 1] = t247*(-U_1_y_2*s_1_z + U_1_z_2*s_1_y)
    D_omega_out[..., 0, 0, 2] = t247*(-U_1_y_3*s_1_z + U_1_z_3*s_1_y)
    D_omega_out[..., 0, 0, 3] = t247*(-U_1_y_4*s_1_z + U_1_z_4*s_1_y)
    D_omega_out[..., 0, 0, 4] = t247*(-U_1_y_5*s_1_z + U_1_z_5*s_1_y)
    D_omega_out[..., 0, 0, 5] = t247*(-U_1_y_6*s_1_z + U_1_z_6*s_1_y)
    D_omega_out[..., 0, 1, 0] = t247*(U_1_x_1*s_1_z - U_1_z_1*s_1_x)
    D_omega_out[..., 0, 1, 1] = t247*(U_1_x_2*s_1_z - U_1_z_2*s_1_x)
    D_omega_out[..., 0, 1, 2] = t247*(U_1_x_3*s_1_z - U_1_z_3*s_1_x)
    D_omega_out[..., 0, 1, 3] = t247*(U_1_x_4*s_1_z - U_1_z_4*s_1_x)
    D_omega_out[..., 0, 1, 4] = t247*(U_1_x_5*s_1_z - U_1_z_5*s_1_x)
    D_omega_out[..., 0, 1, 5] = t247*(U_1_x_6*s_1_z - U_1_z_6*s_1_x)
    D_omega_out[..., 0, 2, 0] = t247*(-U_1_x_1*s_1_y + U_1_y_1*s_1_x)
    D_omega_out[..., 0, 2, 1] = t247*(-U_1_x_2*s_1_y + U_1_y_2*s_1_x)
    D_omega_out[..., 0, 2, 2] = t247*(-U_1_x_3*s_1_y + U_1_y_3*s_1_x)
    D_omega_out[..., 0, 2, 3] = t247*(-U_1_x_4*s_1_y + U_1_y_4*s_1_x)
    D_omega_out[..., 0, 2, 4] = t247*(-U_1_x_5*s_1_y + U_1_y_5*s_1_x)
    D_omega_out[..., 0, 2, 5] = t247*(-U_1_x_6*s_1_y + U_1_y_6*s_1_x)
    D_omega_out[..., 1, 0, 0] = t248*(-U_2_y_1*s_2_z + U_2_z_1*s_2_y)
    D_omega_out[..., 1, 0, 1] = t248*(-U_2_y_2*s_2_z + U_2_z_2*s_2_y)
    D_omega_out[..., 1, 0, 2] = t248*(-U_2_y_3*s_2_z + U_2_z_3*s_2_y)
    D_omega_out[..., 1, 0, 3] = t248*(-U_2_y_4*s_2_z + U_2_z_4*s_2_y)
    D_omega_out[..., 1, 0, 4] = t248*(-U_2_y_5*s_2_z + U_2_z_5*s_2_y)
    D_omega_out[..., 1, 0, 5] = t248*(-U_2_y_6*s_2_z + U_2_z_6*s_2_y)
    D_omega_out[..., 1, 1, 0] = t248*(U_2_x_1*s_2_z - U_2_z_1*s_2_x)
    D_omega_out[..., 1, 1, 1] = t248*(U_2_x_2*s_2_z - U_2_z_2*s_2_x)
    D_omega_out[..., 1, 1, 2] = t248*(U_2_x_3*s_2_z - U_2_z_3*s_2_x)
    D_omega_out[..., 1, 1, 3] = t248*(U_2_x_4*s_2_z - U_2_z_4*s_2_x)
    D_omega_out[..., 1, 1, 4] = t248*(U_2_x_5*s_2_z - U_2_z_5*s_2_x)
    D_omega_out[..., 1, 1, 5] = t248*(U_2_x_6*s_2_z - U_2_z_6*s_2_x)
    D_omega_out[..., 1, 2, 0] = t248*(-U_2_x_1*s_2_y + U_2_y_1*s_2_x)
    D_omega_out[..., 1, 2, 1] = t248*(-U_2_x_2*s_2_y + U_2_y_2*s_2_x)
    D_omega_out[..., 1, 2, 2] = t248*(-U_2_x_3*s_2_y + U_2_y_3*s_2_x)
    D_omega_out[..., 1, 2, 3] = t248*(-U_2_x_4*s_2_y + U_2_y_4*s_2_x)
    D_omega_out[..., 1, 2, 4] = t248*(-U_2_x_5*s_2_y + U_2_y_5*s_2_x)
    D_omega_out[..., 1, 2, 5] = t248*(-U_2_x_6*s_2_y + U_2_y_6*s_2_x)
    D_omega_out[..., 2, 0, 0] = t249*(-U_3_y_1*s_3_z + U_3_z_1*s_3_y)
    D_omega_out[..., 2, 0, 1] = t249*(-U_3_y_2*s_3_z + U_3_z_2*s_3_y)
    D_omega_out[..., 2, 0, 2] = t249*(-U_3_y_3*s_3_z + U_3_z_3*s_3_y)
    D_omega_out[..., 2, 0, 3] = t249*(-U_3_y_4*s_3_z + U_3_z_4*s_3_y)
    D_omega_out[..., 2, 0, 4] = t249*(-U_3_y_5*s_3_z + U_3_z_5*s_3_y)
    D_omega_out[..., 2, 0, 5] = t249*(-U_3_y_6*s_3_z + U_3_z_6*s_3_y)
    D_omega_out[..., 2, 1, 0] = t249*(U_3_x_1*s_3_z - U_3_z_1*s_3_x)
    D_omega_out[..., 2, 1, 1] = t249*(U_3_x_2*s_3_z - U_3_z_2*s_3_x)
    D_omega_out[..., 2, 1, 2] = t249*(U_3_x_3*s_3_z - U_3_z_3*s_3_x)
    D_omega_out[..., 2, 1, 3] = t249*(U_3_x_4*s_3_z - U_3_z_4*s_3_x)
    D_omega_out[..., 2, 1, 4] = t249*(U_3_x_5*s_3_z - U_3_z_5*s_3_x)
    D_omega_out[..., 2, 1, 5] = t249*(U_3_x_6*s_3_z - U_3_z_6*s_3_x)
    D_omega_out[..., 2, 2, 0] = t249*(-U_3_x_1*s_3_y + U_3_y_1*s_3_x)
    D_omega_out[..., 2, 2, 1] = t249*(-U_3_x_2*s_3_y + U_3_y_2*s_3_x)
    D_omega_out[..., 2, 2, 2] = t249*(-U_3_x_3*s_3_y + U_3_y_3*s_3_x)
    D_omega_out[..., 2, 2, 3] = t249*(-U_3_x_4*s_3_y + U_3_y_4*s_3_x)
    D_omega_out[..., 2, 2, 4] = t249*(-U_3_x_5*s_3_y + U_3_y_5*s_3_x)
    D_omega_out[..., 2, 2, 5] = t249*(-U_3_x_6*s_3_y + U_3_y_6*s_3_x)
    D_omega_out[..., 3, 0, 0] = t250*(-U_4_y_1*s_4_z + U_4_z_1*s_4_y)
    D_omega_out[..., 3, 0, 1] = t250*(-U_4_y_2*s_4_z + U_4_z_2*s_4_y)
    D_omega_out[..., 3, 0, 2] = t250*(-U_4_y_3*s_4_z + U_4_z_3*s_4_y)
    D_omega_out[..., 3, 0, 3] = t250*(-U_4_y_4*s_4_z + U_4_z_4*s_4_y)
    D_omega_out[..., 3, 0, 4] = t250*(-U_4_y_5*s_4_z + U_4_z_5*s_4_y)
    D_omega_out[..., 3, 0, 5] = t250*(-U_4_y_6*s_4_z + U_4_z_6*s_4_y)
    D_omega_out[..., 3, 1, 0] = t250*(U_4_x_1*s_4_z - U_4_z_1*s_4_x)
    D_omega_out[..., 3, 1, 1] = t250*(U_4_x_2*s_4_z - U_4_z_2*s_4_x)
    D_omega_out[..., 3, 1, 2] = t250*(U_4_x_3*s_4_z - U_4_z_3*s_4_x)
    D_omega_out[..., 3, 1, 3] = t250*(U_4_x_4*s_4_z - U_4_z_4*s_4_x)
    D_omega_out[..., 3, 1, 4] = t250*(U_4_x_5*s_4_z - U_4_z_5*s_4_x)
    D_omega_out[..., 3, 1, 5] = t250*(U_4_x_6*s_4_z - U_4_z_6*s_4_x)
    D_omega_out[..., 3, 2, 0] = t250*(-U_4_x_1*s_4_y + U_4_y_1*s_4_x)
    D_omega_out[..., 3, 2, 1] = t250*(-U_4_x_2*s_4_y + U_4_y_2*s_4_x)
    D_omega_out[..., 3, 2, 2] = t250*(-U_4_x_3*s_4_y + U_4_y_3*s_4_x)
    D_omega_out[..., 3, 2, 3] = t250*(-U_4_x_4*s_4_y + U_4_y_4*s_4_x)
    D_omega_out[..., 3, 2, 4] = t250*(-U_4_x_5*s_4_y + U_4_y_5*s_4_x)
    D_omega_out[..., 3, 2, 5] = t250*(-U_4_x_6*s_4_y + U_4_y_6*s_4_x)
    D_omega_out[..., 4, 0, 0] = t251*(-U_5_y_1*s_5_z + U_5_z_1*s_5_y)
    D_omega_out[..., 4, 0, 1] = t251*(-U_5_y_2*s_5_z + U_5_z_2*s_5_y)
    D_omega_out[..., 4, 0, 2] = t251*(-U_5_y_3*s_5_z + U_5_z_3*s_5_y)
    D_omega_out[..., 4, 0, 3] = t251*(-U_5_y_4*s_5_z + U_5_z_4*s_5_y)
    D_omega_out[..., 4, 0, 4] = t251*(-U_5_y_5*s_5_z + U_5_z_5*s_5_y)
    D_omega_out[..., 4, 0, 5] = t251*(-U_5_y_6*s_5_z + U_5_z_6*s_5_y)
    D_omega_out[..., 4, 1, 0] = t251*(U_5_x_1*s_5_z - U_5_z_1*s_5_x)
    D_omega_out[..., 4, 1, 1] = t251*(U_5_x_2*s_5_z - U_5_z_2*s_5_x)
    D_omega_out[..., 4, 1, 2] = t251*(U_5_x_3*s_5_z - U_5_z_3*s_5_x)
    D_omega_out[..., 4, 1, 3] = t251*(U_5_x_4*s_5_z - U_5_z_4*s_5_x)
    D_omega_out[..., 4, 1, 4] = t251*(U_5_x_5*s_5_z - U_5_z_5*s_5_x)
    D_omega_out[..., 4, 1, 5] = t251*(U_5_x_6*s_5_z - U_5_z_6*s_5_x)
    D_omega_out[..., 4, 2, 0] = t251*(-U_5_x_1*s_5_y + U_5_y_1*s_5_x)
    D_omega_out[..., 4, 2, 1] = t251*(-U_5_x_2*s_5_y + U_5_y_2*s_5_x)
    D_omega_out[..., 4, 2, 2] = t251*(-U_5_x_3*s_5_y + U_5_y_3*s_5_x)
    D_omega_out[..., 4, 2, 3] = t251*(-U_5_x_4*s_5_y + U_5_y_4*s_5_x)
    D_omega_out[..., 4, 2, 4] = t251*(-U_5_x_5*s_5_y + U_5_y_5*s_5_x)
    D_omega_out[..., 4, 2, 5] = t251*(-U_5_x_6*s_5_y + U_5_y_6*s_5_x)
    D_omega_out[..., 5, 0, 0] = t252*(-U_6_y_1*s_6_z + U_6_z_1*s_6_y)
    D_omega_out[..., 5, 0, 1] = t252*(-U_6_y_2*s_6_z + U_6_z_2*s_6_y)
    D_omega_out[..., 5, 0, 2] = t252*(-U_6_y_3*s_6_z + U_6_z_3*s_6_y)
    D_omega_out[..., 5, 0, 3] = t252*(-U_6_y_4*s_6_z + U_6_z_4*s_6_y)
    D_omega_out[..., 5, 0, 4] = t252*(-U_6_y_5*s_6_z + U_6_z_5*s_6_y)
    D_omega_out[..., 5, 0, 5] = t252*(-U_6_y_6*s_6_z + U_6_z_6*s_6_y)
    D_omega_out[..., 5, 1, 0] = t252*(U_6_x_1*s_6_z - U_6_z_1*s_6_x)
    D_omega_out[..., 5, 1, 1] = t252*(U_6_x_2*s_6_z - U_6_z_2*s_6_x)
    D_omega_out[..., 5, 1, 2] = t252*(U_6_x_3*s_6_z - U_6_z_3*s_6_x)
    D_omega_out[..., 5, 1, 3] = t252*(U_6_x_4*s_6_z - U_6_z_4*s_6_x)
    D_omega_out[..., 5, 1, 4] = t252*(U_6_x_5*s_6_z - U_6_z_5*s_6_x)
    D_omega_out[..., 5, 1, 5] = t252*(U_6_x_6*s_6_z - U_6_z_6*s_6_x)
    D_omega_out[..., 5, 2, 0] = t252*(-U_6_x_1*s_6_y + U_6_y_1*s_6_x)
    D_omega_out[..., 5, 2, 1] = t252*(-U_6_x_2*s_6_y + U_6_y_2*s_6_x)
    D_omega_out[..., 5, 2, 2] = t252*(-U_6_x_3*s_6_y + U_6_y_3*s_6_x)
    D_omega_out[..., 5, 2, 3] = t252*(-U_6_x_4*s_6_y + U_6_y_4*s_6_x)
    D_omega_out[..., 5, 2, 4] = t252*(-U_6_x_5*s_6_y + U_6_y_5*s_6_x)
    D_omega_out[..., 5, 2, 5] = t252*(-U_6_x_6*s_6_y + U_6_y_6*s_6_x)
    return D_d_out, D_omega_out


def kinetic_energy(p, q_dot, parameters):
    """Kinetic energies of the structure and of the transmissions.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    q_dot : array, shape (..., 18) [m/s, rad/s]
        Rates of the 18 generalised coordinates.
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
    2411 operations; 6454344861 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        x_1_dot, x_2_dot, x_3_dot, x_4_dot, x_5_dot, x_6_dot, theta_1_1_dot, theta_2_1_dot, theta_3_1_dot,
        theta_4_1_dot, theta_5_1_dot, theta_6_1_dot, theta_1_2_dot, theta_2_2_dot, theta_3_2_dot,
        theta_4_2_dot, theta_5_2_dot, theta_6_2_dot,
    ) = _entries(q_dot, (18,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    I_p_x, I_p_y, I_p_z = _entries(parameters.platform_inertia, (3,))
    I_p_xy, I_p_xz, I_p_yz = _entries(parameters.platform_products, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    m_t_1, m_t_2, m_t_3, m_t_4, m_t_5, m_t_6 = _entries(parameters.carriage_mass, (6,))
    I_p_1, I_p_2, I_p_3, I_p_4, I_p_5, I_p_6 = _entries(parameters.pulley_inertia, (6,))
    I_m_1, I_m_2, I_m_3, I_m_4, I_m_5, I_m_6 = _entries(parameters.motor_inertia, (6,))
    i_g_1, i_g_2, i_g_3, i_g_4, i_g_5, i_g_6 = _entries(parameters.gear_ratio, (6,))
    (
        d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2, d_4_1, d_4_2, d_5_1, d_5_2, d_6_1, d_6_2,
    ) = _entries(parameters.drive, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, x_1_dot, m_p, c_p_x, I_p_x, I_p_xy, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1,
        I_p_1, I_m_1, i_g_1, d_1_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    t12 = I_p_xy*R_x_x
    t13 = I_p_xz*R_x_x
    t14 = 2*R_x_z
    t15 = I_p_yz*R_x_y
    J_x_x = I_p_x*R_x_x**2 + I_p_y*R_x_y**2 + I_p_z*R_x_z**2 + 2*R_x_y*t12 + t13*t14 + t14*t15
    t16 = I_p_x*R_x_x
    t17 = I_p_xy*R_x_y
    t18 = I_p_xz*R_x_z
    t19 = I_p_y*R_x_y
    t20 = I_p_yz*R_x_z
    t21 = I_p_z*R_x_z
    J_x_y = (
        R_y_x*t16 + R_y_x*t17 + R_y_x*t18 + R_y_y*t12 + R_y_y*t19 + R_y_y*t20 + R_y_z*t13 + R_y_z*t15
        + R_y_z*t21
    )
    J_x_z = (
        R_z_x*t16 + R_z_x*t17 + R_z_x*t18 + R_z_y*t12 + R_z_y*t19 + R_z_y*t20 + R_z_z*t13 + R_z_z*t15
        + R_z_z*t21
    )
    t22 = I_p_xy*R_y_x
    t23 = I_p_xz*R_y_x
    t24 = 2*R_y_z
    t25 = I_p_yz*R_y_y
    J_y_y = I_p_x*R_y_x**2 + I_p_y*R_y_y**2 + I_p_z*R_y_z**2 + 2*R_y_y*t22 + t23*t24 + t24*t25
    t26 = I_p_xy*R_z_x
    t27 = I_p_xz*R_z_x
    t28 = I_p_yz*R_z_y
    J_y_z = (
        I_p_x*R_y_x*R_z_x + I_p_y*R_y_y*R_z_y + I_p_z*R_y_z*R_z_z + R_y_y*t26 + R_y_z*t27 + R_y_z*t28
        + R_z_y*t22 + R_z_z*t23 + R_z_z*t25
    )
    t29 = 2*R_z_z
    J_z_z = I_p_x*R_z_x**2 + I_p_y*R_z_y**2 + I_p_z*R_z_z**2 + 2*R_z_y*t26 + t27*t29 + t28*t29
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t30 = 1.0/det_D_l
    t31 = D_r_1*t30
    D_p_x_1 = A_x_1*t31
    t32 = D_r_2*t30
    D_p_x_2 = A_x_2*t32
    t33 = D_r_3*t30
    D_p_x_3 = A_x_3*t33
    t34 = D_r_4*t30
    D_p_x_4 = A_x_4*t34
    t35 = D_r_5*t30
    D_p_x_5 = A_x_5*t35
    t36 = D_r_6*t30
    D_p_x_6 = A_x_6*t36
    D_p_y_1 = A_y_1*t31
    D_p_y_2 = A_y_2*t32
    D_p_y_3 = A_y_3*t33
    D_p_y_4 = A_y_4*t34
    D_p_y_5 = A_y_5*t35
    D_p_y_6 = A_y_6*t36
    D_p_z_1 = A_z_1*t31
    D_p_z_2 = A_z_2*t32
    D_p_z_3 = A_z_3*t33
    D_p_z_4 = A_z_4*t34
    D_p_z_5 = A_z_5*t35
    D_p_z_6 = A_z_6*t36
    D_p_rx_1 = A_rx_1*t31
    D_p_rx_2 = A_rx_2*t32
    D_p_rx_3 = A_rx_3*t33
    D_p_rx_4 = A_rx_4*t34
    D_p_rx_5 = A_rx_5*t35
    D_p_rx_6 = A_rx_6*t36
    D_p_ry_1 = A_ry_1*t31
    D_p_ry_2 = A_ry_2*t32
    D_p_ry_3 = A_ry_3*t33
    D_p_ry_4 = A_ry_4*t34
    D_p_ry_5 = A_ry_5*t35
    D_p_ry_6 = A_ry_6*t36
    D_p_rz_1 = A_rz_1*t31
    D_p_rz_2 = A_rz_2*t32
    D_p_rz_3 = A_rz_3*t33
    D_p_rz_4 = A_rz_4*t34
    D_p_rz_5 = A_rz_5*t35
    D_p_rz_6 = A_rz_6*t36
    t37 = I_m_1*i_g_1**2
    I_1_1 = I_p_1 + d_1_1*t37
    I_1_2 = I_p_1 + d_1_2*t37
    t38 = I_m_2*i_g_2**2
    I_2_1 = I_p_2 + d_2_1*t38
    I_2_2 = I_p_2 + d_2_2*t38
    t39 = I_m_3*i_g_3**2
    I_3_1 = I_p_3 + d_3_1*t39
    I_3_2 = I_p_3 + d_3_2*t39
    t40 = I_m_4*i_g_4**2
    I_4_1 = I_p_4 + d_4_1*t40
    I_4_2 = I_p_4 + d_4_2*t40
    t41 = I_m_5*i_g_5**2
    I_5_1 = I_p_5 + d_5_1*t41
    I_5_2 = I_p_5 + d_5_2*t41
    t42 = I_m_6*i_g_6**2
    I_6_1 = I_p_6 + d_6_1*t42
    I_6_2 = I_p_6 + d_6_2*t42
    v_p_x = (
        D_p_x_1*x_1_dot + D_p_x_2*x_2_dot + D_p_x_3*x_3_dot + D_p_x_4*x_4_dot + D_p_x_5*x_5_dot
        + D_p_x_6*x_6_dot
    )
    v_p_y = (
        D_p_y_1*x_1_dot + D_p_y_2*x_2_dot + D_p_y_3*x_3_dot + D_p_y_4*x_4_dot + D_p_y_5*x_5_dot
        + D_p_y_6*x_6_dot
    )
    v_p_z = (
        D_p_z_1*x_1_dot + D_p_z_2*x_2_dot + D_p_z_3*x_3_dot + D_p_z_4*x_4_dot + D_p_z_5*x_5_dot
        + D_p_z_6*x_6_dot
    )
    w_p_x = (
        D_p_rx_1*x_1_dot + D_p_rx_2*x_2_dot + D_p_rx_3*x_3_dot + D_p_rx_4*x_4_dot + D_p_rx_5*x_5_dot
        + D_p_rx_6*x_6_dot
    )
    w_p_y = (
        D_p_ry_1*x_1_dot + D_p_ry_2*x_2_dot + D_p_ry_3*x_3_dot + D_p_ry_4*x_4_dot + D_p_ry_5*x_5_dot
        + D_p_ry_6*x_6_dot
    )
    w_p_z = (
        D_p_rz_1*x_1_dot + D_p_rz_2*x_2_dot + D_p_rz_3*x_3_dot + D_p_rz_4*x_4_dot + D_p_rz_5*x_5_dot
        + D_p_rz_6*x_6_dot
    )
    t43 = 2*B_3_x
    t44 = 2*B_3_y
    t45 = 2*B_3_z
    t46 = B_4_y**2
    t47 = B_4_z**2
    t48 = B_4_x**2
    t49 = 2*B_4_x
    t50 = 2*B_4_y
    t51 = 2*B_4_z
    t52 = B_5_y**2
    t53 = B_5_z**2
    t54 = B_5_x**2
    t55 = 2*B_5_x
    t56 = 2*B_5_y
    t57 = 2*B_5_z
    t58 = B_6_y**2
    t59 = B_6_z**2
    t60 = B_6_x**2
    t61 = 2*B_6_x
    t62 = 2*B_6_y
    t63 = 2*B_6_z
    t64 = w_p_x*w_p_y
    t65 = w_p_x*w_p_z
    t66 = w_p_y*w_p_z
    t67 = w_p_x**2
    t68 = w_p_y**2
    t69 = w_p_z**2
    t70 = x_1_dot**2
    t71 = x_2_dot**2
    t72 = x_3_dot**2
    t73 = x_4_dot**2
    t74 = x_5_dot**2
    t75 = x_6_dot**2
    t76 = c_y**2
    t77 = c_z**2
    t78 = c_x**2
    t79 = 2*c_x
    t80 = v_p_z*w_p_y
    t81 = 2*c_y
    t82 = v_p_x*w_p_z
    t83 = 2*c_z
    t84 = v_p_y*w_p_x
    t85 = v_p_y*w_p_z
    t86 = v_p_z*w_p_x
    t87 = v_p_x*w_p_y
    t88 = v_p_x**2 + v_p_y**2 + v_p_z**2
    t89 = B_1_y**2
    t90 = B_1_z**2
    t91 = B_1_x**2
    t92 = 2*B_1_x
    t93 = 2*B_1_y
    t94 = 2*B_1_z
    t95 = B_2_y**2
    t96 = B_2_z**2
    t97 = B_2_x**2
    t98 = 2*B_2_x
    t99 = 2*B_2_y
    t100 = 2*B_2_z
    t101 = B_3_y**2
    t102 = B_3_z**2
    t103 = B_3_x**2
    T_ss_out = np.empty(batch, dtype)
    T_ss_out[...] = (
        (1/2)*J_x_x*t67 + J_x_y*t64 + J_x_z*t65 + (1/2)*J_y_y*t68 + J_y_z*t66 + (1/2)*J_z_z*t69
        + (1/6)*m_d_1*(-B_1_y*t64*t92 - B_1_z*t65*t92 - B_1_z*t66*t93 + n_1_x*v_p_x*x_1_dot
        + n_1_y*v_p_y*x_1_dot + n_1_z*v_p_z*x_1_dot + t67*(t89 + t90) + t68*(t90 + t91) + t69*(t89 + t91)
        + t70 - t80*t92 - t82*t93 - t84*t94 + t85*t92 + t86*t93 + t87*t94 + t88 + w_p_x*x_1_dot*(B_1_y*n_1_z
        - B_1_z*n_1_y) + w_p_y*x_1_dot*(-B_1_x*n_1_z + B_1_z*n_1_x) + w_p_z*x_1_dot*(B_1_x*n_1_y
        - B_1_y*n_1_x)) + (1/6)*m_d_2*(-B_2_y*t64*t98 - B_2_z*t65*t98 - B_2_z*t66*t99 + n_2_x*v_p_x*x_2_dot
        + n_2_y*v_p_y*x_2_dot + n_2_z*v_p_z*x_2_dot - t100*t84 + t100*t87 + t67*(t95 + t96) + t68*(t96 + t97)
        + t69*(t95 + t97) + t71 - t80*t98 - t82*t99 + t85*t98 + t86*t99 + t88 + w_p_x*x_2_dot*(B_2_y*n_2_z
        - B_2_z*n_2_y) + w_p_y*x_2_dot*(-B_2_x*n_2_z + B_2_z*n_2_x) + w_p_z*x_2_dot*(B_2_x*n_2_y
        - B_2_y*n_2_x)) + (1/6)*m_d_3*(-B_3_y*t43*t64 - B_3_z*t43*t65 - B_3_z*t44*t66 + n_3_x*v_p_x*x_3_dot
        + n_3_y*v_p_y*x_3_dot + n_3_z*v_p_z*x_3_dot - t43*t80 + t43*t85 - t44*t82 + t44*t86 - t45*t84
        + t45*t87 + t67*(t101 + t102) + t68*(t102 + t103) + t69*(t101 + t103) + t72 + t88
        + w_p_x*x_3_dot*(B_3_y*n_3_z - B_3_z*n_3_y) + w_p_y*x_3_dot*(-B_3_x*n_3_z + B_3_z*n_3_x)
        + w_p_z*x_3_dot*(B_3_x*n_3_y - B_3_y*n_3_x)) + (1/6)*m_d_4*(-B_4_y*t49*t64 - B_4_z*t49*t65
        - B_4_z*t50*t66 + n_4_x*v_p_x*x_4_dot + n_4_y*v_p_y*x_4_dot + n_4_z*v_p_z*x_4_dot - t49*t80 + t49*t85
        - t50*t82 + t50*t86 - t51*t84 + t51*t87 + t67*(t46 + t47) + t68*(t47 + t48) + t69*(t46 + t48) + t73
        + t88 + w_p_x*x_4_dot*(B_4_y*n_4_z - B_4_z*n_4_y) + w_p_y*x_4_dot*(-B_4_x*n_4_z + B_4_z*n_4_x)
        + w_p_z*x_4_dot*(B_4_x*n_4_y - B_4_y*n_4_x)) + (1/6)*m_d_5*(-B_5_y*t55*t64 - B_5_z*t55*t65
        - B_5_z*t56*t66 + n_5_x*v_p_x*x_5_dot + n_5_y*v_p_y*x_5_dot + n_5_z*v_p_z*x_5_dot - t55*t80 + t55*t85
        - t56*t82 + t56*t86 - t57*t84 + t57*t87 + t67*(t52 + t53) + t68*(t53 + t54) + t69*(t52 + t54) + t74
        + t88 + w_p_x*x_5_dot*(B_5_y*n_5_z - B_5_z*n_5_y) + w_p_y*x_5_dot*(-B_5_x*n_5_z + B_5_z*n_5_x)
        + w_p_z*x_5_dot*(B_5_x*n_5_y - B_5_y*n_5_x)) + (1/6)*m_d_6*(-B_6_y*t61*t64 - B_6_z*t61*t65
        - B_6_z*t62*t66 + n_6_x*v_p_x*x_6_dot + n_6_y*v_p_y*x_6_dot + n_6_z*v_p_z*x_6_dot - t61*t80 + t61*t85
        - t62*t82 + t62*t86 - t63*t84 + t63*t87 + t67*(t58 + t59) + t68*(t59 + t60) + t69*(t58 + t60) + t75
        + t88 + w_p_x*x_6_dot*(B_6_y*n_6_z - B_6_z*n_6_y) + w_p_y*x_6_dot*(-B_6_x*n_6_z + B_6_z*n_6_x)
        + w_p_z*x_6_dot*(B_6_x*n_6_y - B_6_y*n_6_x)) + (1/2)*m_p*(-c_y*t64*t79 - c_z*t65*t79 - c_z*t66*t81
        + t67*(t76 + t77) + t68*(t77 + t78) + t69*(t76 + t78) - t79*t80 + t79*t85 - t81*t82 + t81*t86
        - t83*t84 + t83*t87 + t88) + (1/2)*m_t_1*t70 + (1/2)*m_t_2*t71 + (1/2)*m_t_3*t72 + (1/2)*m_t_4*t73
        + (1/2)*m_t_5*t74 + (1/2)*m_t_6*t75
    )
    T_t_out = np.empty(batch, dtype)
    T_t_out[...] = (
        (1/2)*I_1_1*theta_1_1_dot**2 + (1/2)*I_1_2*theta_1_2_dot**2 + (1/2)*I_2_1*theta_2_1_dot**2
        + (1/2)*I_2_2*theta_2_2_dot**2 + (1/2)*I_3_1*theta_3_1_dot**2 + (1/2)*I_3_2*theta_3_2_dot**2
        + (1/2)*I_4_1*theta_4_1_dot**2 + (1/2)*I_4_2*theta_4_2_dot**2 + (1/2)*I_5_1*theta_5_1_dot**2
        + (1/2)*I_5_2*theta_5_2_dot**2 + (1/2)*I_6_1*theta_6_1_dot**2 + (1/2)*I_6_2*theta_6_2_dot**2
    )
    return T_ss_out[()], T_t_out[()]


def mass_matrix(p, parameters):
    """Mass matrix M in the 18 generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M : array, shape (..., 18, 18) [kg, kg m^2]
        Symmetric; block diagonal: M_ss (6 by 6) and the diagonal M_t.

    Notes
    -----
    Equations 24, 30 and 33.
    2883 operations; 6551532102 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    I_p_x, I_p_y, I_p_z = _entries(parameters.platform_inertia, (3,))
    I_p_xy, I_p_xz, I_p_yz = _entries(parameters.platform_products, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    m_t_1, m_t_2, m_t_3, m_t_4, m_t_5, m_t_6 = _entries(parameters.carriage_mass, (6,))
    I_p_1, I_p_2, I_p_3, I_p_4, I_p_5, I_p_6 = _entries(parameters.pulley_inertia, (6,))
    I_m_1, I_m_2, I_m_3, I_m_4, I_m_5, I_m_6 = _entries(parameters.motor_inertia, (6,))
    i_g_1, i_g_2, i_g_3, i_g_4, i_g_5, i_g_6 = _entries(parameters.gear_ratio, (6,))
    (
        d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2, d_4_1, d_4_2, d_5_1, d_5_2, d_6_1, d_6_2,
    ) = _entries(parameters.drive, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, m_p, c_p_x, I_p_x, I_p_xy, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, I_p_1,
        I_m_1, i_g_1, d_1_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    t12 = I_p_xy*R_x_x
    t13 = I_p_xz*R_x_x
    t14 = 2*R_x_z
    t15 = I_p_yz*R_x_y
    J_x_x = I_p_x*R_x_x**2 + I_p_y*R_x_y**2 + I_p_z*R_x_z**2 + 2*R_x_y*t12 + t13*t14 + t14*t15
    t16 = I_p_x*R_x_x
    t17 = I_p_xy*R_x_y
    t18 = I_p_xz*R_x_z
    t19 = I_p_y*R_x_y
    t20 = I_p_yz*R_x_z
    t21 = I_p_z*R_x_z
    J_x_y = (
        R_y_x*t16 + R_y_x*t17 + R_y_x*t18 + R_y_y*t12 + R_y_y*t19 + R_y_y*t20 + R_y_z*t13 + R_y_z*t15
        + R_y_z*t21
    )
    J_x_z = (
        R_z_x*t16 + R_z_x*t17 + R_z_x*t18 + R_z_y*t12 + R_z_y*t19 + R_z_y*t20 + R_z_z*t13 + R_z_z*t15
        + R_z_z*t21
    )
    t22 = I_p_xy*R_y_x
    t23 = I_p_xz*R_y_x
    t24 = 2*R_y_z
    t25 = I_p_yz*R_y_y
    J_y_y = I_p_x*R_y_x**2 + I_p_y*R_y_y**2 + I_p_z*R_y_z**2 + 2*R_y_y*t22 + t23*t24 + t24*t25
    t26 = I_p_xy*R_z_x
    t27 = I_p_xz*R_z_x
    t28 = I_p_yz*R_z_y
    J_y_z = (
        I_p_x*R_y_x*R_z_x + I_p_y*R_y_y*R_z_y + I_p_z*R_y_z*R_z_z + R_y_y*t26 + R_y_z*t27 + R_y_z*t28
        + R_z_y*t22 + R_z_z*t23 + R_z_z*t25
    )
    t29 = 2*R_z_z
    J_z_z = I_p_x*R_z_x**2 + I_p_y*R_z_y**2 + I_p_z*R_z_z**2 + 2*R_z_y*t26 + t27*t29 + t28*t29
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t30 = 1.0/det_D_l
    t31 = D_r_1*t30
    D_p_x_1 = A_x_1*t31
    t32 = D_r_2*t30
    D_p_x_2 = A_x_2*t32
    t33 = D_r_3*t30
    D_p_x_3 = A_x_3*t33
    t34 = D_r_4*t30
    D_p_x_4 = A_x_4*t34
    t35 = D_r_5*t30
    D_p_x_5 = A_x_5*t35
    t36 = D_r_6*t30
    D_p_x_6 = A_x_6*t36
    D_p_y_1 = A_y_1*t31
    D_p_y_2 = A_y_2*t32
    D_p_y_3 = A_y_3*t33
    D_p_y_4 = A_y_4*t34
    D_p_y_5 = A_y_5*t35
    D_p_y_6 = A_y_6*t36
    D_p_z_1 = A_z_1*t31
    D_p_z_2 = A_z_2*t32
    D_p_z_3 = A_z_3*t33
    D_p_z_4 = A_z_4*t34
    D_p_z_5 = A_z_5*t35
    D_p_z_6 = A_z_6*t36
    D_p_rx_1 = A_rx_1*t31
    D_p_rx_2 = A_rx_2*t32
    D_p_rx_3 = A_rx_3*t33
    D_p_rx_4 = A_rx_4*t34
    D_p_rx_5 = A_rx_5*t35
    D_p_rx_6 = A_rx_6*t36
    D_p_ry_1 = A_ry_1*t31
    D_p_ry_2 = A_ry_2*t32
    D_p_ry_3 = A_ry_3*t33
    D_p_ry_4 = A_ry_4*t34
    D_p_ry_5 = A_ry_5*t35
    D_p_ry_6 = A_ry_6*t36
    D_p_rz_1 = A_rz_1*t31
    D_p_rz_2 = A_rz_2*t32
    D_p_rz_3 = A_rz_3*t33
    D_p_rz_4 = A_rz_4*t34
    D_p_rz_5 = A_rz_5*t35
    D_p_rz_6 = A_rz_6*t36
    t37 = I_m_1*i_g_1**2
    I_1_1 = I_p_1 + d_1_1*t37
    I_1_2 = I_p_1 + d_1_2*t37
    t38 = I_m_2*i_g_2**2
    I_2_1 = I_p_2 + d_2_1*t38
    I_2_2 = I_p_2 + d_2_2*t38
    t39 = I_m_3*i_g_3**2
    I_3_1 = I_p_3 + d_3_1*t39
    I_3_2 = I_p_3 + d_3_2*t39
    t40 = I_m_4*i_g_4**2
    I_4_1 = I_p_4 + d_4_1*t40
    I_4_2 = I_p_4 + d_4_2*t40
    t41 = I_m_5*i_g_5**2
    I_5_1 = I_p_5 + d_5_1*t41
    I_5_2 = I_p_5 + d_5_2*t41
    t42 = I_m_6*i_g_6**2
    I_6_1 = I_p_6 + d_6_1*t42
    I_6_2 = I_p_6 + d_6_2*t42
    t43 = (1/3)*m_d_1
    t44 = (1/3)*m_d_2
    t45 = (1/3)*m_d_3
    t46 = (1/3)*m_d_4
    t47 = (1/3)*m_d_5
    t48 = (1/3)*m_d_6
    M_p_x_x = m_p + t43 + t44 + t45 + t46 + t47 + t48
    t49 = c_z*m_p
    t50 = B_1_z*t43
    t51 = B_2_z*t44
    t52 = B_3_z*t45
    t53 = B_4_z*t46
    t54 = B_5_z*t47
    t55 = B_6_z*t48
    M_p_x_ry = t49 + t50 + t51 + t52 + t53 + t54 + t55
    t56 = c_y*m_p
    t57 = B_1_y*t43
    t58 = B_2_y*t44
    t59 = B_3_y*t45
    t60 = B_4_y*t46
    t61 = B_5_y*t47
    t62 = B_6_y*t48
    M_p_z_rx = t56 + t57 + t58 + t59 + t60 + t61 + t62
    M_p_x_rz = -M_p_z_rx
    M_p_y_rx = -M_p_x_ry
    M_p_y_rz = B_1_x*t43 + B_2_x*t44 + B_3_x*t45 + B_4_x*t46 + B_5_x*t47 + B_6_x*t48 + c_x*m_p
    M_p_z_ry = -M_p_y_rz
    t63 = 2*B_6_z**2
    t64 = (1/6)*m_d_6
    t65 = 2*c_y**2
    t66 = 2*c_z**2
    t67 = (1/2)*m_p
    t68 = 2*B_1_y**2
    t69 = 2*B_1_z**2
    t70 = (1/6)*m_d_1
    t71 = 2*B_2_y**2
    t72 = 2*B_2_z**2
    t73 = (1/6)*m_d_2
    t74 = 2*B_3_y**2
    t75 = 2*B_3_z**2
    t76 = (1/6)*m_d_3
    t77 = 2*B_4_y**2
    t78 = 2*B_4_z**2
    t79 = (1/6)*m_d_4
    t80 = 2*B_5_y**2
    t81 = 2*B_5_z**2
    t82 = (1/6)*m_d_5
    t83 = 2*B_6_y**2
    M_p_rx_rx = (
        J_x_x + t64*(t63 + t83) + t67*(t65 + t66) + t70*(t68 + t69) + t73*(t71 + t72) + t76*(t74 + t75)
        + t79*(t77 + t78) + t82*(t80 + t81)
    )
    M_p_rx_ry = -B_1_x*t57 - B_2_x*t58 - B_3_x*t59 - B_4_x*t60 - B_5_x*t61 - B_6_x*t62 + J_x_y - c_x*t56
    M_p_rx_rz = -B_1_x*t50 - B_2_x*t51 - B_3_x*t52 - B_4_x*t53 - B_5_x*t54 - B_6_x*t55 + J_x_z - c_x*t49
    t84 = 2*B_1_x**2
    t85 = 2*B_2_x**2
    t86 = 2*B_3_x**2
    t87 = 2*B_4_x**2
    t88 = 2*B_5_x**2
    t89 = 2*B_6_x**2
    t90 = 2*c_x**2
    M_p_ry_ry = (
        J_y_y + t64*(t63 + t89) + t67*(t66 + t90) + t70*(t69 + t84) + t73*(t72 + t85) + t76*(t75 + t86)
        + t79*(t78 + t87) + t82*(t81 + t88)
    )
    M_p_ry_rz = -B_1_y*t50 - B_2_y*t51 - B_3_y*t52 - B_4_y*t53 - B_5_y*t54 - B_6_y*t55 + J_y_z - c_y*t49
    M_p_rz_rz = (
        J_z_z + t64*(t83 + t89) + t67*(t65 + t90) + t70*(t68 + t84) + t73*(t71 + t85) + t76*(t74 + t86)
        + t79*(t77 + t87) + t82*(t80 + t88)
    )
    t91 = n_1_x*t70
    h_x_x_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x + t91
    t92 = n_2_x*t73
    h_x_x_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x + t92
    t93 = n_3_x*t76
    h_x_x_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x + t93
    t94 = n_4_x*t79
    h_x_x_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x + t94
    t95 = n_5_x*t82
    h_x_x_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x + t95
    t96 = n_6_x*t64
    h_x_x_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x + t96
    t97 = n_1_y*t70
    h_y_x_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x + t97
    t98 = n_2_y*t73
    h_y_x_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x + t98
    t99 = n_3_y*t76
    h_y_x_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x + t99
    t100 = n_4_y*t79
    h_y_x_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x + t100
    t101 = n_5_y*t82
    h_y_x_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x + t101
    t102 = n_6_y*t64
    h_y_x_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x + t102
    t103 = n_1_z*t70
    h_z_x_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x + t103
    t104 = n_2_z*t73
    h_z_x_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x + t104
    t105 = n_3_z*t76
    h_z_x_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x + t105
    t106 = n_4_z*t79
    h_z_x_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x + t106
    t107 = n_5_z*t82
    h_z_x_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x + t107
    t108 = n_6_z*t64
    h_z_x_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x + t108
    t109 = t70*(B_1_y*n_1_z - B_1_z*n_1_y)
    h_rx_x_1 = (
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx
        + t109
    )
    t110 = t73*(B_2_y*n_2_z - B_2_z*n_2_y)
    h_rx_x_2 = (
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx
        + t110
    )
    t111 = t76*(B_3_y*n_3_z - B_3_z*n_3_y)
    h_rx_x_3 = (
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx
        + t111
    )
    t112 = t79*(B_4_y*n_4_z - B_4_z*n_4_y)
    h_rx_x_4 = (
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx
        + t112
    )
    t113 = t82*(B_5_y*n_5_z - B_5_z*n_5_y)
    h_rx_x_5 = (
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx
        + t113
    )
    t114 = t64*(B_6_y*n_6_z - B_6_z*n_6_y)
    h_rx_x_6 = (
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx
        + t114
    )
    t115 = t70*(-B_1_x*n_1_z + B_1_z*n_1_x)
    h_ry_x_1 = (
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry
        + t115
    )
    t116 = t73*(-B_2_x*n_2_z + B_2_z*n_2_x)
    h_ry_x_2 = (
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry
        + t116
    )
    t117 = t76*(-B_3_x*n_3_z + B_3_z*n_3_x)
    h_ry_x_3 = (
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry
        + t117
    )
    t118 = t79*(-B_4_x*n_4_z + B_4_z*n_4_x)
    h_ry_x_4 = (
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry
        + t118
    )
    t119 = t82*(-B_5_x*n_5_z + B_5_z*n_5_x)
    h_ry_x_5 = (
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry
        + t119
    )
    t120 = t64*(-B_6_x*n_6_z + B_6_z*n_6_x)
    h_ry_x_6 = (
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry
        + t120
    )
    t121 = t70*(B_1_x*n_1_y - B_1_y*n_1_x)
    h_rz_x_1 = (
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz
        + t121
    )
    t122 = t73*(B_2_x*n_2_y - B_2_y*n_2_x)
    h_rz_x_2 = (
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz
        + t122
    )
    t123 = t76*(B_3_x*n_3_y - B_3_y*n_3_x)
    h_rz_x_3 = (
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz
        + t123
    )
    t124 = t79*(B_4_x*n_4_y - B_4_y*n_4_x)
    h_rz_x_4 = (
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz
        + t124
    )
    t125 = t82*(B_5_x*n_5_y - B_5_y*n_5_x)
    h_rz_x_5 = (
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz
        + t125
    )
    t126 = t64*(B_6_x*n_6_y - B_6_y*n_6_x)
    h_rz_x_6 = (
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz
        + t126
    )
    M_out = np.zeros((*batch, 18, 18), dtype)
    M_out[..., 0, 0] = (
        D_p_rx_1*h_rx_x_1 + D_p_rx_1*t109 + D_p_ry_1*h_ry_x_1 + D_p_ry_1*t115 + D_p_rz_1*h_rz_x_1
        + D_p_rz_1*t121 + D_p_x_1*h_x_x_1 + D_p_x_1*t91 + D_p_y_1*h_y_x_1 + D_p_y_1*t97 + D_p_z_1*h_z_x_1
        + D_p_z_1*t103 + m_t_1 + t43
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_rx_1*h_rx_x_2 + D_p_rx_2*t109 + D_p_ry_1*h_ry_x_2 + D_p_ry_2*t115 + D_p_rz_1*h_rz_x_2
        + D_p_rz_2*t121 + D_p_x_1*h_x_x_2 + D_p_x_2*t91 + D_p_y_1*h_y_x_2 + D_p_y_2*t97 + D_p_z_1*h_z_x_2
        + D_p_z_2*t103
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_rx_1*h_rx_x_3 + D_p_rx_3*t109 + D_p_ry_1*h_ry_x_3 + D_p_ry_3*t115 + D_p_rz_1*h_rz_x_3
        + D_p_rz_3*t121 + D_p_x_1*h_x_x_3 + D_p_x_3*t91 + D_p_y_1*h_y_x_3 + D_p_y_3*t97 + D_p_z_1*h_z_x_3
        + D_p_z_3*t103
    )
    M_out[..., 0, 3] = M_out[..., 3, 0] = (
        D_p_rx_1*h_rx_x_4 + D_p_rx_4*t109 + D_p_ry_1*h_ry_x_4 + D_p_ry_4*t115 + D_p_rz_1*h_rz_x_4
        + D_p_rz_4*t121 + D_p_x_1*h_x_x_4 + D_p_x_4*t91 + D_p_y_1*h_y_x_4 + D_p_y_4*t97 + D_p_z_1*h_z_x_4
        + D_p_z_4*t103
    )
    M_out[..., 0, 4] = M_out[..., 4, 0] = (
        D_p_rx_1*h_rx_x_5 + D_p_rx_5*t109 + D_p_ry_1*h_ry_x_5 + D_p_ry_5*t115 + D_p_rz_1*h_rz_x_5
        + D_p_rz_5*t121 + D_p_x_1*h_x_x_5 + D_p_x_5*t91 + D_p_y_1*h_y_x_5 + D_p_y_5*t97 + D_p_z_1*h_z_x_5
        + D_p_z_5*t103
    )
    M_out[..., 0, 5] = M_out[..., 5, 0] = (
        D_p_rx_1*h_rx_x_6 + D_p_rx_6*t109 + D_p_ry_1*h_ry_x_6 + D_p_ry_6*t115 + D_p_rz_1*h_rz_x_6
        + D_p_rz_6*t121 + D_p_x_1*h_x_x_6 + D_p_x_6*t91 + D_p_y_1*h_y_x_6 + D_p_y_6*t97 + D_p_z_1*h_z_x_6
        + D_p_z_6*t103
    )
    M_out[..., 1, 1] = (
        D_p_rx_2*h_rx_x_2 + D_p_rx_2*t110 + D_p_ry_2*h_ry_x_2 + D_p_ry_2*t116 + D_p_rz_2*h_rz_x_2
        + D_p_rz_2*t122 + D_p_x_2*h_x_x_2 + D_p_x_2*t92 + D_p_y_2*h_y_x_2 + D_p_y_2*t98 + D_p_z_2*h_z_x_2
        + D_p_z_2*t104 + m_t_2 + t44
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_rx_2*h_rx_x_3 + D_p_rx_3*t110 + D_p_ry_2*h_ry_x_3 + D_p_ry_3*t116 + D_p_rz_2*h_rz_x_3
        + D_p_rz_3*t122 + D_p_x_2*h_x_x_3 + D_p_x_3*t92 + D_p_y_2*h_y_x_3 + D_p_y_3*t98 + D_p_z_2*h_z_x_3
        + D_p_z_3*t104
    )
    M_out[..., 1, 3] = M_out[..., 3, 1] = (
        D_p_rx_2*h_rx_x_4 + D_p_rx_4*t110 + D_p_ry_2*h_ry_x_4 + D_p_ry_4*t116 + D_p_rz_2*h_rz_x_4
        + D_p_rz_4*t122 + D_p_x_2*h_x_x_4 + D_p_x_4*t92 + D_p_y_2*h_y_x_4 + D_p_y_4*t98 + D_p_z_2*h_z_x_4
        + D_p_z_4*t104
    )
    M_out[..., 1, 4] = M_out[..., 4, 1] = (
        D_p_rx_2*h_rx_x_5 + D_p_rx_5*t110 + D_p_ry_2*h_ry_x_5 + D_p_ry_5*t116 + D_p_rz_2*h_rz_x_5
        + D_p_rz_5*t122 + D_p_x_2*h_x_x_5 + D_p_x_5*t92 + D_p_y_2*h_y_x_5 + D_p_y_5*t98 + D_p_z_2*h_z_x_5
        + D_p_z_5*t104
    )
    M_out[..., 1, 5] = M_out[..., 5, 1] = (
        D_p_rx_2*h_rx_x_6 + D_p_rx_6*t110 + D_p_ry_2*h_ry_x_6 + D_p_ry_6*t116 + D_p_rz_2*h_rz_x_6
        + D_p_rz_6*t122 + D_p_x_2*h_x_x_6 + D_p_x_6*t92 + D_p_y_2*h_y_x_6 + D_p_y_6*t98 + D_p_z_2*h_z_x_6
        + D_p_z_6*t104
    )
    M_out[..., 2, 2] = (
        D_p_rx_3*h_rx_x_3 + D_p_rx_3*t111 + D_p_ry_3*h_ry_x_3 + D_p_ry_3*t117 + D_p_rz_3*h_rz_x_3
        + D_p_rz_3*t123 + D_p_x_3*h_x_x_3 + D_p_x_3*t93 + D_p_y_3*h_y_x_3 + D_p_y_3*t99 + D_p_z_3*h_z_x_3
        + D_p_z_3*t105 + m_t_3 + t45
    )
    M_out[..., 2, 3] = M_out[..., 3, 2] = (
        D_p_rx_3*h_rx_x_4 + D_p_rx_4*t111 + D_p_ry_3*h_ry_x_4 + D_p_ry_4*t117 + D_p_rz_3*h_rz_x_4
        + D_p_rz_4*t123 + D_p_x_3*h_x_x_4 + D_p_x_4*t93 + D_p_y_3*h_y_x_4 + D_p_y_4*t99 + D_p_z_3*h_z_x_4
        + D_p_z_4*t105
    )
    M_out[..., 2, 4] = M_out[..., 4, 2] = (
        D_p_rx_3*h_rx_x_5 + D_p_rx_5*t111 + D_p_ry_3*h_ry_x_5 + D_p_ry_5*t117 + D_p_rz_3*h_rz_x_5
        + D_p_rz_5*t123 + D_p_x_3*h_x_x_5 + D_p_x_5*t93 + D_p_y_3*h_y_x_5 + D_p_y_5*t99 + D_p_z_3*h_z_x_5
        + D_p_z_5*t105
    )
    M_out[..., 2, 5] = M_out[..., 5, 2] = (
        D_p_rx_3*h_rx_x_6 + D_p_rx_6*t111 + D_p_ry_3*h_ry_x_6 + D_p_ry_6*t117 + D_p_rz_3*h_rz_x_6
        + D_p_rz_6*t123 + D_p_x_3*h_x_x_6 + D_p_x_6*t93 + D_p_y_3*h_y_x_6 + D_p_y_6*t99 + D_p_z_3*h_z_x_6
        + D_p_z_6*t105
    )
    M_out[..., 3, 3] = (
        D_p_rx_4*h_rx_x_4 + D_p_rx_4*t112 + D_p_ry_4*h_ry_x_4 + D_p_ry_4*t118 + D_p_rz_4*h_rz_x_4
        + D_p_rz_4*t124 + D_p_x_4*h_x_x_4 + D_p_x_4*t94 + D_p_y_4*h_y_x_4 + D_p_y_4*t100 + D_p_z_4*h_z_x_4
        + D_p_z_4*t106 + m_t_4 + t46
    )
    M_out[..., 3, 4] = M_out[..., 4, 3] = (
        D_p_rx_4*h_rx_x_5 + D_p_rx_5*t112 + D_p_ry_4*h_ry_x_5 + D_p_ry_5*t118 + D_p_rz_4*h_rz_x_5
        + D_p_rz_5*t124 + D_p_x_4*h_x_x_5 + D_p_x_5*t94 + D_p_y_4*h_y_x_5 + D_p_y_5*t100 + D_p_z_4*h_z_x_5
        + D_p_z_5*t106
    )
    M_out[..., 3, 5] = M_out[..., 5, 3] = (
        D_p_rx_4*h_rx_x_6 + D_p_rx_6*t112 + D_p_ry_4*h_ry_x_6 + D_p_ry_6*t118 + D_p_rz_4*h_rz_x_6
        + D_p_rz_6*t124 + D_p_x_4*h_x_x_6 + D_p_x_6*t94 + D_p_y_4*h_y_x_6 + D_p_y_6*t100 + D_p_z_4*h_z_x_6
        + D_p_z_6*t106
    )
    M_out[..., 4, 4] = (
        D_p_rx_5*h_rx_x_5 + D_p_rx_5*t113 + D_p_ry_5*h_ry_x_5 + D_p_ry_5*t119 + D_p_rz_5*h_rz_x_5
        + D_p_rz_5*t125 + D_p_x_5*h_x_x_5 + D_p_x_5*t95 + D_p_y_5*h_y_x_5 + D_p_y_5*t101 + D_p_z_5*h_z_x_5
        + D_p_z_5*t107 + m_t_5 + t47
    )
    M_out[..., 4, 5] = M_out[..., 5, 4] = (
        D_p_rx_5*h_rx_x_6 + D_p_rx_6*t113 + D_p_ry_5*h_ry_x_6 + D_p_ry_6*t119 + D_p_rz_5*h_rz_x_6
        + D_p_rz_6*t125 + D_p_x_5*h_x_x_6 + D_p_x_6*t95 + D_p_y_5*h_y_x_6 + D_p_y_6*t101 + D_p_z_5*h_z_x_6
        + D_p_z_6*t107
    )
    M_out[..., 5, 5] = (
        D_p_rx_6*h_rx_x_6 + D_p_rx_6*t114 + D_p_ry_6*h_ry_x_6 + D_p_ry_6*t120 + D_p_rz_6*h_rz_x_6
        + D_p_rz_6*t126 + D_p_x_6*h_x_x_6 + D_p_x_6*t96 + D_p_y_6*h_y_x_6 + D_p_y_6*t102 + D_p_z_6*h_z_x_6
        + D_p_z_6*t108 + m_t_6 + t48
    )
    M_out[..., 6, 6] = I_1_1
    M_out[..., 7, 7] = I_2_1
    M_out[..., 8, 8] = I_3_1
    M_out[..., 9, 9] = I_4_1
    M_out[..., 10, 10] = I_5_1
    M_out[..., 11, 11] = I_6_1
    M_out[..., 12, 12] = I_1_2
    M_out[..., 13, 13] = I_2_2
    M_out[..., 14, 14] = I_3_2
    M_out[..., 15, 15] = I_4_2
    M_out[..., 16, 16] = I_5_2
    M_out[..., 17, 17] = I_6_2
    return M_out


def velocity_forces(p, x_dot, parameters):
    """Coriolis and centrifugal forces h of M_ss x_ddot + h + grad V = Q.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    x_dot : array, shape (..., 6) [m/s]
        Carriage velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    h : array, shape (..., 6) [N]
        Generalised forces conjugate to the carriage positions.

    Notes
    -----
    Lagrange's equations; equation 47 before linearisation.
    6739 operations; 8379579046728 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    x_1_dot, x_2_dot, x_3_dot, x_4_dot, x_5_dot, x_6_dot = _entries(x_dot, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    I_p_x, I_p_y, I_p_z = _entries(parameters.platform_inertia, (3,))
    I_p_xy, I_p_xz, I_p_yz = _entries(parameters.platform_products, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, x_1_dot, m_p, c_p_x, I_p_x, I_p_xy, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    t12 = I_p_xy*R_x_y
    t13 = 2*t12
    t14 = I_p_xz*R_x_z
    t15 = 2*t14
    t16 = I_p_yz*R_x_z
    t17 = 2*t16
    J_x_x = I_p_x*R_x_x**2 + I_p_y*R_x_y**2 + I_p_z*R_x_z**2 + R_x_x*t13 + R_x_x*t15 + R_x_y*t17
    t18 = I_p_x*R_x_x
    t19 = I_p_xy*R_x_x
    t20 = I_p_xz*R_x_x
    t21 = I_p_y*R_x_y
    t22 = I_p_yz*R_x_y
    t23 = I_p_z*R_x_z
    J_x_y = (
        R_y_x*t12 + R_y_x*t14 + R_y_x*t18 + R_y_y*t16 + R_y_y*t19 + R_y_y*t21 + R_y_z*t20 + R_y_z*t22
        + R_y_z*t23
    )
    t24 = I_p_xy*R_z_y
    t25 = I_p_xz*R_z_z
    t26 = I_p_yz*R_z_z
    J_x_z = (
        R_x_x*t24 + R_x_x*t25 + R_x_y*t26 + R_z_x*t12 + R_z_x*t14 + R_z_x*t18 + R_z_y*t16 + R_z_y*t21
        + R_z_z*t23
    )
    t27 = I_p_xy*R_y_y
    t28 = 2*t27
    t29 = I_p_xz*R_y_z
    t30 = 2*t29
    t31 = I_p_yz*R_y_z
    t32 = 2*t31
    J_y_y = I_p_x*R_y_x**2 + I_p_y*R_y_y**2 + I_p_z*R_y_z**2 + R_y_x*t28 + R_y_x*t30 + R_y_y*t32
    t33 = I_p_x*R_z_x
    t34 = I_p_xy*R_z_x
    t35 = I_p_xz*R_z_x
    t36 = I_p_y*R_z_y
    t37 = I_p_yz*R_z_y
    t38 = I_p_z*R_z_z
    J_y_z = (
        R_y_x*t24 + R_y_x*t25 + R_y_x*t33 + R_y_y*t26 + R_y_y*t34 + R_y_y*t36 + R_y_z*t35 + R_y_z*t37
        + R_y_z*t38
    )
    t39 = 2*t24
    t40 = 2*t25
    t41 = 2*t26
    J_z_z = I_p_x*R_z_x**2 + I_p_y*R_z_y**2 + I_p_z*R_z_z**2 + R_z_x*t39 + R_z_x*t40 + R_z_y*t41
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t42 = 1.0/det_D_l
    t43 = D_r_1*t42
    D_p_x_1 = A_x_1*t43
    t44 = D_r_2*t42
    D_p_x_2 = A_x_2*t44
    t45 = D_r_3*t42
    D_p_x_3 = A_x_3*t45
    t46 = D_r_4*t42
    D_p_x_4 = A_x_4*t46
    t47 = D_r_5*t42
    D_p_x_5 = A_x_5*t47
    t48 = D_r_6*t42
    D_p_x_6 = A_x_6*t48
    D_p_y_1 = A_y_1*t43
    D_p_y_2 = A_y_2*t44
    D_p_y_3 = A_y_3*t45
    D_p_y_4 = A_y_4*t46
    D_p_y_5 = A_y_5*t47
    D_p_y_6 = A_y_6*t48
    D_p_z_1 = A_z_1*t43
    D_p_z_2 = A_z_2*t44
    D_p_z_3 = A_z_3*t45
    D_p_z_4 = A_z_4*t46
    D_p_z_5 = A_z_5*t47
    D_p_z_6 = A_z_6*t48
    D_p_rx_1 = A_rx_1*t43
    D_p_rx_2 = A_rx_2*t44
    D_p_rx_3 = A_rx_3*t45
    D_p_rx_4 = A_rx_4*t46
    D_p_rx_5 = A_rx_5*t47
    D_p_rx_6 = A_rx_6*t48
    D_p_ry_1 = A_ry_1*t43
    D_p_ry_2 = A_ry_2*t44
    D_p_ry_3 = A_ry_3*t45
    D_p_ry_4 = A_ry_4*t46
    D_p_ry_5 = A_ry_5*t47
    D_p_ry_6 = A_ry_6*t48
    D_p_rz_1 = A_rz_1*t43
    D_p_rz_2 = A_rz_2*t44
    D_p_rz_3 = A_rz_3*t45
    D_p_rz_4 = A_rz_4*t46
    D_p_rz_5 = A_rz_5*t47
    D_p_rz_6 = A_rz_6*t48
    t49 = B_1_y*D_p_rz_1 - B_1_z*D_p_ry_1
    U_1_x_1 = D_p_x_1 - n_1_x - t49
    t50 = B_1_y*D_p_rz_2
    U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t50
    t51 = B_1_y*D_p_rz_3
    U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t51
    t52 = B_1_y*D_p_rz_4
    U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t52
    t53 = B_1_y*D_p_rz_5
    U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t53
    t54 = B_1_y*D_p_rz_6
    U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t54
    t55 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1
    U_1_y_1 = D_p_y_1 - n_1_y + t55
    t56 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2
    U_1_y_2 = D_p_y_2 + t56
    t57 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3
    U_1_y_3 = D_p_y_3 + t57
    t58 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4
    U_1_y_4 = D_p_y_4 + t58
    t59 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5
    U_1_y_5 = D_p_y_5 + t59
    t60 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6
    U_1_y_6 = D_p_y_6 + t60
    t61 = B_1_x*D_p_ry_1 - B_1_y*D_p_rx_1
    U_1_z_1 = D_p_z_1 - n_1_z - t61
    t62 = B_1_x*D_p_ry_2
    U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t62
    t63 = B_1_x*D_p_ry_3
    U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t63
    t64 = B_1_x*D_p_ry_4
    U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t64
    t65 = B_1_x*D_p_ry_5
    U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t65
    t66 = B_1_x*D_p_ry_6
    U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t66
    t67 = B_2_y*D_p_rz_1
    U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t67
    t68 = B_2_y*D_p_rz_2 - B_2_z*D_p_ry_2
    U_2_x_2 = D_p_x_2 - n_2_x - t68
    t69 = B_2_y*D_p_rz_3
    U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t69
    t70 = B_2_y*D_p_rz_4
    U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t70
    t71 = B_2_y*D_p_rz_5
    U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t71
    t72 = B_2_y*D_p_rz_6
    U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t72
    t73 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1
    U_2_y_1 = D_p_y_1 + t73
    t74 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2
    U_2_y_2 = D_p_y_2 - n_2_y + t74
    t75 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3
    U_2_y_3 = D_p_y_3 + t75
    t76 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4
    U_2_y_4 = D_p_y_4 + t76
    t77 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5
    U_2_y_5 = D_p_y_5 + t77
    t78 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6
    U_2_y_6 = D_p_y_6 + t78
    t79 = B_2_x*D_p_ry_1
    U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t79
    t80 = B_2_x*D_p_ry_2 - B_2_y*D_p_rx_2
    U_2_z_2 = D_p_z_2 - n_2_z - t80
    t81 = B_2_x*D_p_ry_3
    U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t81
    t82 = B_2_x*D_p_ry_4
    U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t82
    t83 = B_2_x*D_p_ry_5
    U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t83
    t84 = B_2_x*D_p_ry_6
    U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t84
    t85 = B_3_y*D_p_rz_1
    U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t85
    t86 = B_3_y*D_p_rz_2
    U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t86
    t87 = B_3_y*D_p_rz_3 - B_3_z*D_p_ry_3
    U_3_x_3 = D_p_x_3 - n_3_x - t87
    t88 = B_3_y*D_p_rz_4
    U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t88
    t89 = B_3_y*D_p_rz_5
    U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t89
    t90 = B_3_y*D_p_rz_6
    U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t90
    t91 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1
    U_3_y_1 = D_p_y_1 + t91
    t92 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2
    U_3_y_2 = D_p_y_2 + t92
    t93 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3
    U_3_y_3 = D_p_y_3 - n_3_y + t93
    t94 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4
    U_3_y_4 = D_p_y_4 + t94
    t95 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5
    U_3_y_5 = D_p_y_5 + t95
    t96 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6
    U_3_y_6 = D_p_y_6 + t96
    t97 = B_3_x*D_p_ry_1
    U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t97
    t98 = B_3_x*D_p_ry_2
    U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t98
    t99 = B_3_x*D_p_ry_3 - B_3_y*D_p_rx_3
    U_3_z_3 = D_p_z_3 - n_3_z - t99
    t100 = B_3_x*D_p_ry_4
    U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t100
    t101 = B_3_x*D_p_ry_5
    U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t101
    t102 = B_3_x*D_p_ry_6
    U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t102
    t103 = B_4_y*D_p_rz_1
    U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t103
    t104 = B_4_y*D_p_rz_2
    U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t104
    t105 = B_4_y*D_p_rz_3
    U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t105
    t106 = B_4_y*D_p_rz_4 - B_4_z*D_p_ry_4
    U_4_x_4 = D_p_x_4 - n_4_x - t106
    t107 = B_4_y*D_p_rz_5
    U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t107
    t108 = B_4_y*D_p_rz_6
    U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t108
    t109 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1
    U_4_y_1 = D_p_y_1 + t109
    t110 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2
    U_4_y_2 = D_p_y_2 + t110
    t111 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3
    U_4_y_3 = D_p_y_3 + t111
    t112 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4
    U_4_y_4 = D_p_y_4 - n_4_y + t112
    t113 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5
    U_4_y_5 = D_p_y_5 + t113
    t114 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6
    U_4_y_6 = D_p_y_6 + t114
    t115 = B_4_x*D_p_ry_1
    U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t115
    t116 = B_4_x*D_p_ry_2
    U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t116
    t117 = B_4_x*D_p_ry_3
    U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t117
    t118 = B_4_x*D_p_ry_4 - B_4_y*D_p_rx_4
    U_4_z_4 = D_p_z_4 - n_4_z - t118
    t119 = B_4_x*D_p_ry_5
    U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t119
    t120 = B_4_x*D_p_ry_6
    U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t120
    t121 = B_5_y*D_p_rz_1
    U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t121
    t122 = B_5_y*D_p_rz_2
    U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t122
    t123 = B_5_y*D_p_rz_3
    U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t123
    t124 = B_5_y*D_p_rz_4
    U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t124
    t125 = B_5_y*D_p_rz_5 - B_5_z*D_p_ry_5
    U_5_x_5 = D_p_x_5 - n_5_x - t125
    t126 = B_5_y*D_p_rz_6
    U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t126
    t127 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1
    U_5_y_1 = D_p_y_1 + t127
    t128 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2
    U_5_y_2 = D_p_y_2 + t128
    t129 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3
    U_5_y_3 = D_p_y_3 + t129
    t130 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4
    U_5_y_4 = D_p_y_4 + t130
    t131 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5
    U_5_y_5 = D_p_y_5 - n_5_y + t131
    t132 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6
    U_5_y_6 = D_p_y_6 + t132
    t133 = B_5_x*D_p_ry_1
    U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t133
    t134 = B_5_x*D_p_ry_2
    U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t134
    t135 = B_5_x*D_p_ry_3
    U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t135
    t136 = B_5_x*D_p_ry_4
    U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t136
    t137 = B_5_x*D_p_ry_5 - B_5_y*D_p_rx_5
    U_5_z_5 = D_p_z_5 - n_5_z - t137
    t138 = B_5_x*D_p_ry_6
    U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t138
    t139 = B_6_y*D_p_rz_1
    U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t139
    t140 = B_6_y*D_p_rz_2
    U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t140
    t141 = B_6_y*D_p_rz_3
    U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t141
    t142 = B_6_y*D_p_rz_4
    U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t142
    t143 = B_6_y*D_p_rz_5
    U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t143
    t144 = B_6_y*D_p_rz_6 - B_6_z*D_p_ry_6
    U_6_x_6 = D_p_x_6 - n_6_x - t144
    t145 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1
    U_6_y_1 = D_p_y_1 + t145
    t146 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2
    U_6_y_2 = D_p_y_2 + t146
    t147 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3
    U_6_y_3 = D_p_y_3 + t147
    t148 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4
    U_6_y_4 = D_p_y_4 + t148
    t149 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5
    U_6_y_5 = D_p_y_5 + t149
    t150 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6
    U_6_y_6 = D_p_y_6 - n_6_y + t150
    t151 = B_6_x*D_p_ry_1
    U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t151
    t152 = B_6_x*D_p_ry_2
    U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t152
    t153 = B_6_x*D_p_ry_3
    U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t153
    t154 = B_6_x*D_p_ry_4
    U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t154
    t155 = B_6_x*D_p_ry_5
    U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t155
    t156 = B_6_x*D_p_ry_6 - B_6_y*D_p_rx_6
    U_6_z_6 = D_p_z_6 - n_6_z - t156
    v_p_x = (
        D_p_x_1*x_1_dot + D_p_x_2*x_2_dot + D_p_x_3*x_3_dot + D_p_x_4*x_4_dot + D_p_x_5*x_5_dot
        + D_p_x_6*x_6_dot
    )
    v_p_y = (
        D_p_y_1*x_1_dot + D_p_y_2*x_2_dot + D_p_y_3*x_3_dot + D_p_y_4*x_4_dot + D_p_y_5*x_5_dot
        + D_p_y_6*x_6_dot
    )
    v_p_z = (
        D_p_z_1*x_1_dot + D_p_z_2*x_2_dot + D_p_z_3*x_3_dot + D_p_z_4*x_4_dot + D_p_z_5*x_5_dot
        + D_p_z_6*x_6_dot
    )
    w_p_x = (
        D_p_rx_1*x_1_dot + D_p_rx_2*x_2_dot + D_p_rx_3*x_3_dot + D_p_rx_4*x_4_dot + D_p_rx_5*x_5_dot
        + D_p_rx_6*x_6_dot
    )
    w_p_y = (
        D_p_ry_1*x_1_dot + D_p_ry_2*x_2_dot + D_p_ry_3*x_3_dot + D_p_ry_4*x_4_dot + D_p_ry_5*x_5_dot
        + D_p_ry_6*x_6_dot
    )
    w_p_z = (
        D_p_rz_1*x_1_dot + D_p_rz_2*x_2_dot + D_p_rz_3*x_3_dot + D_p_rz_4*x_4_dot + D_p_rz_5*x_5_dot
        + D_p_rz_6*x_6_dot
    )
    s_dot_1_x = (
        U_1_x_1*x_1_dot + U_1_x_2*x_2_dot + U_1_x_3*x_3_dot + U_1_x_4*x_4_dot + U_1_x_5*x_5_dot
        + U_1_x_6*x_6_dot
    )
    s_dot_1_y = (
        U_1_y_1*x_1_dot + U_1_y_2*x_2_dot + U_1_y_3*x_3_dot + U_1_y_4*x_4_dot + U_1_y_5*x_5_dot
        + U_1_y_6*x_6_dot
    )
    s_dot_1_z = (
        U_1_z_1*x_1_dot + U_1_z_2*x_2_dot + U_1_z_3*x_3_dot + U_1_z_4*x_4_dot + U_1_z_5*x_5_dot
        + U_1_z_6*x_6_dot
    )
    s_dot_2_x = (
        U_2_x_1*x_1_dot + U_2_x_2*x_2_dot + U_2_x_3*x_3_dot + U_2_x_4*x_4_dot + U_2_x_5*x_5_dot
        + U_2_x_6*x_6_dot
    )
    s_dot_2_y = (
        U_2_y_1*x_1_dot + U_2_y_2*x_2_dot + U_2_y_3*x_3_dot + U_2_y_4*x_4_dot + U_2_y_5*x_5_dot
        + U_2_y_6*x_6_dot
    )
    s_dot_2_z = (
        U_2_z_1*x_1_dot + U_2_z_2*x_2_dot + U_2_z_3*x_3_dot + U_2_z_4*x_4_dot + U_2_z_5*x_5_dot
        + U_2_z_6*x_6_dot
    )
    s_dot_3_x = (
        U_3_x_1*x_1_dot + U_3_x_2*x_2_dot + U_3_x_3*x_3_dot + U_3_x_4*x_4_dot + U_3_x_5*x_5_dot
        + U_3_x_6*x_6_dot
    )
    s_dot_3_y = (
        U_3_y_1*x_1_dot + U_3_y_2*x_2_dot + U_3_y_3*x_3_dot + U_3_y_4*x_4_dot + U_3_y_5*x_5_dot
        + U_3_y_6*x_6_dot
    )
    s_dot_3_z = (
        U_3_z_1*x_1_dot + U_3_z_2*x_2_dot + U_3_z_3*x_3_dot + U_3_z_4*x_4_dot + U_3_z_5*x_5_dot
        + U_3_z_6*x_6_dot
    )
    s_dot_4_x = (
        U_4_x_1*x_1_dot + U_4_x_2*x_2_dot + U_4_x_3*x_3_dot + U_4_x_4*x_4_dot + U_4_x_5*x_5_dot
        + U_4_x_6*x_6_dot
    )
    s_dot_4_y = (
        U_4_y_1*x_1_dot + U_4_y_2*x_2_dot + U_4_y_3*x_3_dot + U_4_y_4*x_4_dot + U_4_y_5*x_5_dot
        + U_4_y_6*x_6_dot
    )
    s_dot_4_z = (
        U_4_z_1*x_1_dot + U_4_z_2*x_2_dot + U_4_z_3*x_3_dot + U_4_z_4*x_4_dot + U_4_z_5*x_5_dot
        + U_4_z_6*x_6_dot
    )
    s_dot_5_x = (
        U_5_x_1*x_1_dot + U_5_x_2*x_2_dot + U_5_x_3*x_3_dot + U_5_x_4*x_4_dot + U_5_x_5*x_5_dot
        + U_5_x_6*x_6_dot
    )
    s_dot_5_y = (
        U_5_y_1*x_1_dot + U_5_y_2*x_2_dot + U_5_y_3*x_3_dot + U_5_y_4*x_4_dot + U_5_y_5*x_5_dot
        + U_5_y_6*x_6_dot
    )
    s_dot_5_z = (
        U_5_z_1*x_1_dot + U_5_z_2*x_2_dot + U_5_z_3*x_3_dot + U_5_z_4*x_4_dot + U_5_z_5*x_5_dot
        + U_5_z_6*x_6_dot
    )
    s_dot_6_x = (
        U_6_x_1*x_1_dot + U_6_x_2*x_2_dot + U_6_x_3*x_3_dot + U_6_x_4*x_4_dot + U_6_x_5*x_5_dot
        + U_6_x_6*x_6_dot
    )
    s_dot_6_y = (
        U_6_y_1*x_1_dot + U_6_y_2*x_2_dot + U_6_y_3*x_3_dot + U_6_y_4*x_4_dot + U_6_y_5*x_5_dot
        + U_6_y_6*x_6_dot
    )
    s_dot_6_z = (
        U_6_z_1*x_1_dot + U_6_z_2*x_2_dot + U_6_z_3*x_3_dot + U_6_z_4*x_4_dot + U_6_z_5*x_5_dot
        + U_6_z_6*x_6_dot
    )
    t157 = B_1_y*D_p_rx_2 - t62
    t158 = B_1_y*D_p_rx_3 - t63
    t159 = B_1_y*D_p_rx_4 - t64
    t160 = B_1_y*D_p_rx_5 - t65
    t161 = B_1_y*D_p_rx_6 - t66
    D_l_dot_1_rx = (
        x_1_dot*(B_1_y*U_1_z_1 - B_1_z*U_1_y_1 + s_1_y*t61 + s_1_z*t55) + x_2_dot*(B_1_y*U_1_z_2
        - B_1_z*U_1_y_2 - s_1_y*t157 + s_1_z*t56) + x_3_dot*(B_1_y*U_1_z_3 - B_1_z*U_1_y_3 - s_1_y*t158
        + s_1_z*t57) + x_4_dot*(B_1_y*U_1_z_4 - B_1_z*U_1_y_4 - s_1_y*t159 + s_1_z*t58)
        + x_5_dot*(B_1_y*U_1_z_5 - B_1_z*U_1_y_5 - s_1_y*t160 + s_1_z*t59) + x_6_dot*(B_1_y*U_1_z_6
        - B_1_z*U_1_y_6 - s_1_y*t161 + s_1_z*t60)
    )
    t162 = B_1_z*D_p_ry_2 - t50
    t163 = B_1_z*D_p_ry_3 - t51
    t164 = B_1_z*D_p_ry_4 - t52
    t165 = B_1_z*D_p_ry_5 - t53
    t166 = B_1_z*D_p_ry_6 - t54
    D_l_dot_1_ry = (
        x_1_dot*(-B_1_x*U_1_z_1 + B_1_z*U_1_x_1 - s_1_x*t61 + s_1_z*t49) + x_2_dot*(-B_1_x*U_1_z_2
        + B_1_z*U_1_x_2 + s_1_x*t157 - s_1_z*t162) + x_3_dot*(-B_1_x*U_1_z_3 + B_1_z*U_1_x_3 + s_1_x*t158
        - s_1_z*t163) + x_4_dot*(-B_1_x*U_1_z_4 + B_1_z*U_1_x_4 + s_1_x*t159 - s_1_z*t164)
        + x_5_dot*(-B_1_x*U_1_z_5 + B_1_z*U_1_x_5 + s_1_x*t160 - s_1_z*t165) + x_6_dot*(-B_1_x*U_1_z_6
        + B_1_z*U_1_x_6 + s_1_x*t161 - s_1_z*t166)
    )
    D_l_dot_1_rz = (
        x_1_dot*(B_1_x*U_1_y_1 - B_1_y*U_1_x_1 - s_1_x*t55 - s_1_y*t49) + x_2_dot*(B_1_x*U_1_y_2
        - B_1_y*U_1_x_2 - s_1_x*t56 + s_1_y*t162) + x_3_dot*(B_1_x*U_1_y_3 - B_1_y*U_1_x_3 - s_1_x*t57
        + s_1_y*t163) + x_4_dot*(B_1_x*U_1_y_4 - B_1_y*U_1_x_4 - s_1_x*t58 + s_1_y*t164)
        + x_5_dot*(B_1_x*U_1_y_5 - B_1_y*U_1_x_5 - s_1_x*t59 + s_1_y*t165) + x_6_dot*(B_1_x*U_1_y_6
        - B_1_y*U_1_x_6 - s_1_x*t60 + s_1_y*t166)
    )
    t167 = B_2_y*D_p_rx_1 - t79
    t168 = B_2_y*D_p_rx_3 - t81
    t169 = B_2_y*D_p_rx_4 - t82
    t170 = B_2_y*D_p_rx_5 - t83
    t171 = B_2_y*D_p_rx_6 - t84
    D_l_dot_2_rx = (
        x_1_dot*(B_2_y*U_2_z_1 - B_2_z*U_2_y_1 - s_2_y*t167 + s_2_z*t73) + x_2_dot*(B_2_y*U_2_z_2
        - B_2_z*U_2_y_2 + s_2_y*t80 + s_2_z*t74) + x_3_dot*(B_2_y*U_2_z_3 - B_2_z*U_2_y_3 - s_2_y*t168
        + s_2_z*t75) + x_4_dot*(B_2_y*U_2_z_4 - B_2_z*U_2_y_4 - s_2_y*t169 + s_2_z*t76)
        + x_5_dot*(B_2_y*U_2_z_5 - B_2_z*U_2_y_5 - s_2_y*t170 + s_2_z*t77) + x_6_dot*(B_2_y*U_2_z_6
        - B_2_z*U_2_y_6 - s_2_y*t171 + s_2_z*t78)
    )
    t172 = B_2_z*D_p_ry_1 - t67
    t173 = B_2_z*D_p_ry_3 - t69
    t174 = B_2_z*D_p_ry_4 - t70
    t175 = B_2_z*D_p_ry_5 - t71
    t176 = B_2_z*D_p_ry_6 - t72
    D_l_dot_2_ry = (
        x_1_dot*(-B_2_x*U_2_z_1 + B_2_z*U_2_x_1 + s_2_x*t167 - s_2_z*t172) + x_2_dot*(-B_2_x*U_2_z_2
        + B_2_z*U_2_x_2 - s_2_x*t80 + s_2_z*t68) + x_3_dot*(-B_2_x*U_2_z_3 + B_2_z*U_2_x_3 + s_2_x*t168
        - s_2_z*t173) + x_4_dot*(-B_2_x*U_2_z_4 + B_2_z*U_2_x_4 + s_2_x*t169 - s_2_z*t174)
        + x_5_dot*(-B_2_x*U_2_z_5 + B_2_z*U_2_x_5 + s_2_x*t170 - s_2_z*t175) + x_6_dot*(-B_2_x*U_2_z_6
        + B_2_z*U_2_x_6 + s_2_x*t171 - s_2_z*t176)
    )
    D_l_dot_2_rz = (
        x_1_dot*(B_2_x*U_2_y_1 - B_2_y*U_2_x_1 - s_2_x*t73 + s_2_y*t172) + x_2_dot*(B_2_x*U_2_y_2
        - B_2_y*U_2_x_2 - s_2_x*t74 - s_2_y*t68) + x_3_dot*(B_2_x*U_2_y_3 - B_2_y*U_2_x_3 - s_2_x*t75
        + s_2_y*t173) + x_4_dot*(B_2_x*U_2_y_4 - B_2_y*U_2_x_4 - s_2_x*t76 + s_2_y*t174)
        + x_5_dot*(B_2_x*U_2_y_5 - B_2_y*U_2_x_5 - s_2_x*t77 + s_2_y*t175) + x_6_dot*(B_2_x*U_2_y_6
        - B_2_y*U_2_x_6 - s_2_x*t78 + s_2_y*t176)
    )
    t177 = B_3_y*D_p_rx_1 - t97
    t178 = B_3_y*D_p_rx_2 - t98
    t179 = B_3_y*D_p_rx_4 - t100
    t180 = B_3_y*D_p_rx_5 - t101
    t181 = B_3_y*D_p_rx_6 - t102
    D_l_dot_3_rx = (
        x_1_dot*(B_3_y*U_3_z_1 - B_3_z*U_3_y_1 - s_3_y*t177 + s_3_z*t91) + x_2_dot*(B_3_y*U_3_z_2
        - B_3_z*U_3_y_2 - s_3_y*t178 + s_3_z*t92) + x_3_dot*(B_3_y*U_3_z_3 - B_3_z*U_3_y_3 + s_3_y*t99
        + s_3_z*t93) + x_4_dot*(B_3_y*U_3_z_4 - B_3_z*U_3_y_4 - s_3_y*t179 + s_3_z*t94)
        + x_5_dot*(B_3_y*U_3_z_5 - B_3_z*U_3_y_5 - s_3_y*t180 + s_3_z*t95) + x_6_dot*(B_3_y*U_3_z_6
        - B_3_z*U_3_y_6 - s_3_y*t181 + s_3_z*t96)
    )
    t182 = B_3_z*D_p_ry_1 - t85
    t183 = B_3_z*D_p_ry_2 - t86
    t184 = B_3_z*D_p_ry_4 - t88
    t185 = B_3_z*D_p_ry_5 - t89
    t186 = B_3_z*D_p_ry_6 - t90
    D_l_dot_3_ry = (
        x_1_dot*(-B_3_x*U_3_z_1 + B_3_z*U_3_x_1 + s_3_x*t177 - s_3_z*t182) + x_2_dot*(-B_3_x*U_3_z_2
        + B_3_z*U_3_x_2 + s_3_x*t178 - s_3_z*t183) + x_3_dot*(-B_3_x*U_3_z_3 + B_3_z*U_3_x_3 - s_3_x*t99
        + s_3_z*t87) + x_4_dot*(-B_3_x*U_3_z_4 + B_3_z*U_3_x_4 + s_3_x*t179 - s_3_z*t184)
        + x_5_dot*(-B_3_x*U_3_z_5 + B_3_z*U_3_x_5 + s_3_x*t180 - s_3_z*t185) + x_6_dot*(-B_3_x*U_3_z_6
        + B_3_z*U_3_x_6 + s_3_x*t181 - s_3_z*t186)
    )
    D_l_dot_3_rz = (
        x_1_dot*(B_3_x*U_3_y_1 - B_3_y*U_3_x_1 - s_3_x*t91 + s_3_y*t182) + x_2_dot*(B_3_x*U_3_y_2
        - B_3_y*U_3_x_2 - s_3_x*t92 + s_3_y*t183) + x_3_dot*(B_3_x*U_3_y_3 - B_3_y*U_3_x_3 - s_3_x*t93
        - s_3_y*t87) + x_4_dot*(B_3_x*U_3_y_4 - B_3_y*U_3_x_4 - s_3_x*t94 + s_3_y*t184)
        + x_5_dot*(B_3_x*U_3_y_5 - B_3_y*U_3_x_5 - s_3_x*t95 + s_3_y*t185) + x_6_dot*(B_3_x*U_3_y_6
        - B_3_y*U_3_x_6 - s_3_x*t96 + s_3_y*t186)
    )
    t187 = B_4_y*D_p_rx_1 - t115
    t188 = B_4_y*D_p_rx_2 - t116
    t189 = B_4_y*D_p_rx_3 - t117
    t190 = B_4_y*D_p_rx_5 - t119
    t191 = B_4_y*D_p_rx_6 - t120
    D_l_dot_4_rx = (
        x_1_dot*(B_4_y*U_4_z_1 - B_4_z*U_4_y_1 - s_4_y*t187 + s_4_z*t109) + x_2_dot*(B_4_y*U_4_z_2
        - B_4_z*U_4_y_2 - s_4_y*t188 + s_4_z*t110) + x_3_dot*(B_4_y*U_4_z_3 - B_4_z*U_4_y_3 - s_4_y*t189
        + s_4_z*t111) + x_4_dot*(B_4_y*U_4_z_4 - B_4_z*U_4_y_4 + s_4_y*t118 + s_4_z*t112)
        + x_5_dot*(B_4_y*U_4_z_5 - B_4_z*U_4_y_5 - s_4_y*t190 + s_4_z*t113) + x_6_dot*(B_4_y*U_4_z_6
        - B_4_z*U_4_y_6 - s_4_y*t191 + s_4_z*t114)
    )
    t192 = B_4_z*D_p_ry_1 - t103
    t193 = B_4_z*D_p_ry_2 - t104
    t194 = B_4_z*D_p_ry_3 - t105
    t195 = B_4_z*D_p_ry_5 - t107
    t196 = B_4_z*D_p_ry_6 - t108
    D_l_dot_4_ry = (
        x_1_dot*(-B_4_x*U_4_z_1 + B_4_z*U_4_x_1 + s_4_x*t187 - s_4_z*t192) + x_2_dot*(-B_4_x*U_4_z_2
        + B_4_z*U_4_x_2 + s_4_x*t188 - s_4_z*t193) + x_3_dot*(-B_4_x*U_4_z_3 + B_4_z*U_4_x_3 + s_4_x*t189
        - s_4_z*t194) + x_4_dot*(-B_4_x*U_4_z_4 + B_4_z*U_4_x_4 - s_4_x*t118 + s_4_z*t106)
        + x_5_dot*(-B_4_x*U_4_z_5 + B_4_z*U_4_x_5 + s_4_x*t190 - s_4_z*t195) + x_6_dot*(-B_4_x*U_4_z_6
        + B_4_z*U_4_x_6 + s_4_x*t191 - s_4_z*t196)
    )
    D_l_dot_4_rz = (
        x_1_dot*(B_4_x*U_4_y_1 - B_4_y*U_4_x_1 - s_4_x*t109 + s_4_y*t192) + x_2_dot*(B_4_x*U_4_y_2
        - B_4_y*U_4_x_2 - s_4_x*t110 + s_4_y*t193) + x_3_dot*(B_4_x*U_4_y_3 - B_4_y*U_4_x_3 - s_4_x*t111
        + s_4_y*t194) + x_4_dot*(B_4_x*U_4_y_4 - B_4_y*U_4_x_4 - s_4_x*t112 - s_4_y*t106)
        + x_5_dot*(B_4_x*U_4_y_5 - B_4_y*U_4_x_5 - s_4_x*t113 + s_4_y*t195) + x_6_dot*(B_4_x*U_4_y_6
        - B_4_y*U_4_x_6 - s_4_x*t114 + s_4_y*t196)
    )
    t197 = B_5_y*D_p_rx_1 - t133
    t198 = B_5_y*D_p_rx_2 - t134
    t199 = B_5_y*D_p_rx_3 - t135
    t200 = B_5_y*D_p_rx_4 - t136
    t201 = B_5_y*D_p_rx_6 - t138
    D_l_dot_5_rx = (
        x_1_dot*(B_5_y*U_5_z_1 - B_5_z*U_5_y_1 - s_5_y*t197 + s_5_z*t127) + x_2_dot*(B_5_y*U_5_z_2
        - B_5_z*U_5_y_2 - s_5_y*t198 + s_5_z*t128) + x_3_dot*(B_5_y*U_5_z_3 - B_5_z*U_5_y_3 - s_5_y*t199
        + s_5_z*t129) + x_4_dot*(B_5_y*U_5_z_4 - B_5_z*U_5_y_4 - s_5_y*t200 + s_5_z*t130)
        + x_5_dot*(B_5_y*U_5_z_5 - B_5_z*U_5_y_5 + s_5_y*t137 + s_5_z*t131) + x_6_dot*(B_5_y*U_5_z_6
        - B_5_z*U_5_y_6 - s_5_y*t201 + s_5_z*t132)
    )
    t202 = B_5_z*D_p_ry_1 - t121
    t203 = B_5_z*D_p_ry_2 - t122
    t204 = B_5_z*D_p_ry_3 - t123
    t205 = B_5_z*D_p_ry_4 - t124
    t206 = B_5_z*D_p_ry_6 - t126
    D_l_dot_5_ry = (
        x_1_dot*(-B_5_x*U_5_z_1 + B_5_z*U_5_x_1 + s_5_x*t197 - s_5_z*t202) + x_2_dot*(-B_5_x*U_5_z_2
        + B_5_z*U_5_x_2 + s_5_x*t198 - s_5_z*t203) + x_3_dot*(-B_5_x*U_5_z_3 + B_5_z*U_5_x_3 + s_5_x*t199
        - s_5_z*t204) + x_4_dot*(-B_5_x*U_5_z_4 + B_5_z*U_5_x_4 + s_5_x*t200 - s_5_z*t205)
        + x_5_dot*(-B_5_x*U_5_z_5 + B_5_z*U_5_x_5 - s_5_x*t137 + s_5_z*t125) + x_6_dot*(-B_5_x*U_5_z_6
        + B_5_z*U_5_x_6 + s_5_x*t201 - s_5_z*t206)
    )
    D_l_dot_5_rz = (
        x_1_dot*(B_5_x*U_5_y_1 - B_5_y*U_5_x_1 - s_5_x*t127 + s_5_y*t202) + x_2_dot*(B_5_x*U_5_y_2
        - B_5_y*U_5_x_2 - s_5_x*t128 + s_5_y*t203) + x_3_dot*(B_5_x*U_5_y_3 - B_5_y*U_5_x_3 - s_5_x*t129
        + s_5_y*t204) + x_4_dot*(B_5_x*U_5_y_4 - B_5_y*U_5_x_4 - s_5_x*t130 + s_5_y*t205)
        + x_5_dot*(B_5_x*U_5_y_5 - B_5_y*U_5_x_5 - s_5_x*t131 - s_5_y*t125) + x_6_dot*(B_5_x*U_5_y_6
        - B_5_y*U_5_x_6 - s_5_x*t132 + s_5_y*t206)
    )
    t207 = B_6_y*D_p_rx_1 - t151
    t208 = B_6_y*D_p_rx_2 - t152
    t209 = B_6_y*D_p_rx_3 - t153
    t210 = B_6_y*D_p_rx_4 - t154
    t211 = B_6_y*D_p_rx_5 - t155
    D_l_dot_6_rx = (
        x_1_dot*(B_6_y*U_6_z_1 - B_6_z*U_6_y_1 - s_6_y*t207 + s_6_z*t145) + x_2_dot*(B_6_y*U_6_z_2
        - B_6_z*U_6_y_2 - s_6_y*t208 + s_6_z*t146) + x_3_dot*(B_6_y*U_6_z_3 - B_6_z*U_6_y_3 - s_6_y*t209
        + s_6_z*t147) + x_4_dot*(B_6_y*U_6_z_4 - B_6_z*U_6_y_4 - s_6_y*t210 + s_6_z*t148)
        + x_5_dot*(B_6_y*U_6_z_5 - B_6_z*U_6_y_5 - s_6_y*t211 + s_6_z*t149) + x_6_dot*(B_6_y*U_6_z_6
        - B_6_z*U_6_y_6 + s_6_y*t156 + s_6_z*t150)
    )
    t212 = B_6_z*D_p_ry_1 - t139
    t213 = B_6_z*D_p_ry_2 - t140
    t214 = B_6_z*D_p_ry_3 - t141
    t215 = B_6_z*D_p_ry_4 - t142
    t216 = B_6_z*D_p_ry_5 - t143
    D_l_dot_6_ry = (
        x_1_dot*(-B_6_x*U_6_z_1 + B_6_z*U_6_x_1 + s_6_x*t207 - s_6_z*t212) + x_2_dot*(-B_6_x*U_6_z_2
        + B_6_z*U_6_x_2 + s_6_x*t208 - s_6_z*t213) + x_3_dot*(-B_6_x*U_6_z_3 + B_6_z*U_6_x_3 + s_6_x*t209
        - s_6_z*t214) + x_4_dot*(-B_6_x*U_6_z_4 + B_6_z*U_6_x_4 + s_6_x*t210 - s_6_z*t215)
        + x_5_dot*(-B_6_x*U_6_z_5 + B_6_z*U_6_x_5 + s_6_x*t211 - s_6_z*t216) + x_6_dot*(-B_6_x*U_6_z_6
        + B_6_z*U_6_x_6 - s_6_x*t156 + s_6_z*t144)
    )
    D_l_dot_6_rz = (
        x_1_dot*(B_6_x*U_6_y_1 - B_6_y*U_6_x_1 - s_6_x*t145 + s_6_y*t212) + x_2_dot*(B_6_x*U_6_y_2
        - B_6_y*U_6_x_2 - s_6_x*t146 + s_6_y*t213) + x_3_dot*(B_6_x*U_6_y_3 - B_6_y*U_6_x_3 - s_6_x*t147
        + s_6_y*t214) + x_4_dot*(B_6_x*U_6_y_4 - B_6_y*U_6_x_4 - s_6_x*t148 + s_6_y*t215)
        + x_5_dot*(B_6_x*U_6_y_5 - B_6_y*U_6_x_5 - s_6_x*t149 + s_6_y*t216) + x_6_dot*(B_6_x*U_6_y_6
        - B_6_y*U_6_x_6 - s_6_x*t150 - s_6_y*t144)
    )
    t217 = (
        -D_l_dot_2_rx*D_p_rx_1 - D_l_dot_2_ry*D_p_ry_1 - D_l_dot_2_rz*D_p_rz_1 - D_p_x_1*s_dot_2_x
        - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z
    )
    t218 = (
        -D_l_dot_3_rx*D_p_rx_1 - D_l_dot_3_ry*D_p_ry_1 - D_l_dot_3_rz*D_p_rz_1 - D_p_x_1*s_dot_3_x
        - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z
    )
    t219 = (
        -D_l_dot_4_rx*D_p_rx_1 - D_l_dot_4_ry*D_p_ry_1 - D_l_dot_4_rz*D_p_rz_1 - D_p_x_1*s_dot_4_x
        - D_p_y_1*s_dot_4_y - D_p_z_1*s_dot_4_z
    )
    t220 = (
        -D_l_dot_5_rx*D_p_rx_1 - D_l_dot_5_ry*D_p_ry_1 - D_l_dot_5_rz*D_p_rz_1 - D_p_x_1*s_dot_5_x
        - D_p_y_1*s_dot_5_y - D_p_z_1*s_dot_5_z
    )
    t221 = (
        -D_l_dot_6_rx*D_p_rx_1 - D_l_dot_6_ry*D_p_ry_1 - D_l_dot_6_rz*D_p_rz_1 - D_p_x_1*s_dot_6_x
        - D_p_y_1*s_dot_6_y - D_p_z_1*s_dot_6_z
    )
    t222 = (
        -D_l_dot_1_rx*D_p_rx_1 - D_l_dot_1_ry*D_p_ry_1 - D_l_dot_1_rz*D_p_rz_1 - D_p_x_1*s_dot_1_x
        - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y + n_1_z*s_dot_1_z
    )
    D_p_dot_x_1 = t42*(A_x_1*t222 + A_x_2*t217 + A_x_3*t218 + A_x_4*t219 + A_x_5*t220 + A_x_6*t221)
    D_p_dot_y_1 = t42*(A_y_1*t222 + A_y_2*t217 + A_y_3*t218 + A_y_4*t219 + A_y_5*t220 + A_y_6*t221)
    D_p_dot_z_1 = t42*(A_z_1*t222 + A_z_2*t217 + A_z_3*t218 + A_z_4*t219 + A_z_5*t220 + A_z_6*t221)
    D_p_dot_rx_1 = t42*(A_rx_1*t222 + A_rx_2*t217 + A_rx_3*t218 + A_rx_4*t219 + A_rx_5*t220 + A_rx_6*t221)
    D_p_dot_ry_1 = t42*(A_ry_1*t222 + A_ry_2*t217 + A_ry_3*t218 + A_ry_4*t219 + A_ry_5*t220 + A_ry_6*t221)
    D_p_dot_rz_1 = t42*(A_rz_1*t222 + A_rz_2*t217 + A_rz_3*t218 + A_rz_4*t219 + A_rz_5*t220 + A_rz_6*t221)
    t223 = (
        -D_l_dot_1_rx*D_p_rx_2 - D_l_dot_1_ry*D_p_ry_2 - D_l_dot_1_rz*D_p_rz_2 - D_p_x_2*s_dot_1_x
        - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z
    )
    t224 = (
        -D_l_dot_3_rx*D_p_rx_2 - D_l_dot_3_ry*D_p_ry_2 - D_l_dot_3_rz*D_p_rz_2 - D_p_x_2*s_dot_3_x
        - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z
    )
    t225 = (
        -D_l_dot_4_rx*D_p_rx_2 - D_l_dot_4_ry*D_p_ry_2 - D_l_dot_4_rz*D_p_rz_2 - D_p_x_2*s_dot_4_x
        - D_p_y_2*s_dot_4_y - D_p_z_2*s_dot_4_z
    )
    t226 = (
        -D_l_dot_5_rx*D_p_rx_2 - D_l_dot_5_ry*D_p_ry_2 - D_l_dot_5_rz*D_p_rz_2 - D_p_x_2*s_dot_5_x
        - D_p_y_2*s_dot_5_y - D_p_z_2*s_dot_5_z
    )
    t227 = (
        -D_l_dot_6_rx*D_p_rx_2 - D_l_dot_6_ry*D_p_ry_2 - D_l_dot_6_rz*D_p_rz_2 - D_p_x_2*s_dot_6_x
        - D_p_y_2*s_dot_6_y - D_p_z_2*s_dot_6_z
    )
    t228 = (
        -D_l_dot_2_rx*D_p_rx_2 - D_l_dot_2_ry*D_p_ry_2 - D_l_dot_2_rz*D_p_rz_2 - D_p_x_2*s_dot_2_x
        - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y + n_2_z*s_dot_2_z
    )
    D_p_dot_x_2 = t42*(A_x_1*t223 + A_x_2*t228 + A_x_3*t224 + A_x_4*t225 + A_x_5*t226 + A_x_6*t227)
    D_p_dot_y_2 = t42*(A_y_1*t223 + A_y_2*t228 + A_y_3*t224 + A_y_4*t225 + A_y_5*t226 + A_y_6*t227)
    D_p_dot_z_2 = t42*(A_z_1*t223 + A_z_2*t228 + A_z_3*t224 + A_z_4*t225 + A_z_5*t226 + A_z_6*t227)
    D_p_dot_rx_2 = t42*(A_rx_1*t223 + A_rx_2*t228 + A_rx_3*t224 + A_rx_4*t225 + A_rx_5*t226 + A_rx_6*t227)
    D_p_dot_ry_2 = t42*(A_ry_1*t223 + A_ry_2*t228 + A_ry_3*t224 + A_ry_4*t225 + A_ry_5*t226 + A_ry_6*t227)
    D_p_dot_rz_2 = t42*(A_rz_1*t223 + A_rz_2*t228 + A_rz_3*t224 + A_rz_4*t225 + A_rz_5*t226 + A_rz_6*t227)
    t229 = (
        -D_l_dot_1_rx*D_p_rx_3 - D_l_dot_1_ry*D_p_ry_3 - D_l_dot_1_rz*D_p_rz_3 - D_p_x_3*s_dot_1_x
        - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z
    )
    t230 = (
        -D_l_dot_2_rx*D_p_rx_3 - D_l_dot_2_ry*D_p_ry_3 - D_l_dot_2_rz*D_p_rz_3 - D_p_x_3*s_dot_2_x
        - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z
    )
    t231 = (
        -D_l_dot_4_rx*D_p_rx_3 - D_l_dot_4_ry*D_p_ry_3 - D_l_dot_4_rz*D_p_rz_3 - D_p_x_3*s_dot_4_x
        - D_p_y_3*s_dot_4_y - D_p_z_3*s_dot_4_z
    )
    t232 = (
        -D_l_dot_5_rx*D_p_rx_3 - D_l_dot_5_ry*D_p_ry_3 - D_l_dot_5_rz*D_p_rz_3 - D_p_x_3*s_dot_5_x
        - D_p_y_3*s_dot_5_y - D_p_z_3*s_dot_5_z
    )
    t233 = (
        -D_l_dot_6_rx*D_p_rx_3 - D_l_dot_6_ry*D_p_ry_3 - D_l_dot_6_rz*D_p_rz_3 - D_p_x_3*s_dot_6_x
        - D_p_y_3*s_dot_6_y - D_p_z_3*s_dot_6_z
    )
    t234 = (
        -D_l_dot_3_rx*D_p_rx_3 - D_l_dot_3_ry*D_p_ry_3 - D_l_dot_3_rz*D_p_rz_3 - D_p_x_3*s_dot_3_x
        - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y + n_3_z*s_dot_3_z
    )
    D_p_dot_x_3 = t42*(A_x_1*t229 + A_x_2*t230 + A_x_3*t234 + A_x_4*t231 + A_x_5*t232 + A_x_6*t233)
    D_p_dot_y_3 = t42*(A_y_1*t229 + A_y_2*t230 + A_y_3*t234 + A_y_4*t231 + A_y_5*t232 + A_y_6*t233)
    D_p_dot_z_3 = t42*(A_z_1*t229 + A_z_2*t230 + A_z_3*t234 + A_z_4*t231 + A_z_5*t232 + A_z_6*t233)
    D_p_dot_rx_3 = t42*(A_rx_1*t229 + A_rx_2*t230 + A_rx_3*t234 + A_rx_4*t231 + A_rx_5*t232 + A_rx_6*t233)
    D_p_dot_ry_3 = t42*(A_ry_1*t229 + A_ry_2*t230 + A_ry_3*t234 + A_ry_4*t231 + A_ry_5*t232 + A_ry_6*t233)
    D_p_dot_rz_3 = t42*(A_rz_1*t229 + A_rz_2*t230 + A_rz_3*t234 + A_rz_4*t231 + A_rz_5*t232 + A_rz_6*t233)
    t235 = (
        -D_l_dot_1_rx*D_p_rx_4 - D_l_dot_1_ry*D_p_ry_4 - D_l_dot_1_rz*D_p_rz_4 - D_p_x_4*s_dot_1_x
        - D_p_y_4*s_dot_1_y - D_p_z_4*s_dot_1_z
    )
    t236 = (
        -D_l_dot_2_rx*D_p_rx_4 - D_l_dot_2_ry*D_p_ry_4 - D_l_dot_2_rz*D_p_rz_4 - D_p_x_4*s_dot_2_x
        - D_p_y_4*s_dot_2_y - D_p_z_4*s_dot_2_z
    )
    t237 = (
        -D_l_dot_3_rx*D_p_rx_4 - D_l_dot_3_ry*D_p_ry_4 - D_l_dot_3_rz*D_p_rz_4 - D_p_x_4*s_dot_3_x
        - D_p_y_4*s_dot_3_y - D_p_z_4*s_dot_3_z
    )
    t238 = (
        -D_l_dot_5_rx*D_p_rx_4 - D_l_dot_5_ry*D_p_ry_4 - D_l_dot_5_rz*D_p_rz_4 - D_p_x_4*s_dot_5_x
        - D_p_y_4*s_dot_5_y - D_p_z_4*s_dot_5_z
    )
    t239 = (
        -D_l_dot_6_rx*D_p_rx_4 - D_l_dot_6_ry*D_p_ry_4 - D_l_dot_6_rz*D_p_rz_4 - D_p_x_4*s_dot_6_x
        - D_p_y_4*s_dot_6_y - D_p_z_4*s_dot_6_z
    )
    t240 = (
        -D_l_dot_4_rx*D_p_rx_4 - D_l_dot_4_ry*D_p_ry_4 - D_l_dot_4_rz*D_p_rz_4 - D_p_x_4*s_dot_4_x
        - D_p_y_4*s_dot_4_y - D_p_z_4*s_dot_4_z + n_4_x*s_dot_4_x + n_4_y*s_dot_4_y + n_4_z*s_dot_4_z
    )
    D_p_dot_x_4 = t42*(A_x_1*t235 + A_x_2*t236 + A_x_3*t237 + A_x_4*t240 + A_x_5*t238 + A_x_6*t239)
    D_p_dot_y_4 = t42*(A_y_1*t235 + A_y_2*t236 + A_y_3*t237 + A_y_4*t240 + A_y_5*t238 + A_y_6*t239)
    D_p_dot_z_4 = t42*(A_z_1*t235 + A_z_2*t236 + A_z_3*t237 + A_z_4*t240 + A_z_5*t238 + A_z_6*t239)
    D_p_dot_rx_4 = t42*(A_rx_1*t235 + A_rx_2*t236 + A_rx_3*t237 + A_rx_4*t240 + A_rx_5*t238 + A_rx_6*t239)
    D_p_dot_ry_4 = t42*(A_ry_1*t235 + A_ry_2*t236 + A_ry_3*t237 + A_ry_4*t240 + A_ry_5*t238 + A_ry_6*t239)
    D_p_dot_rz_4 = t42*(A_rz_1*t235 + A_rz_2*t236 + A_rz_3*t237 + A_rz_4*t240 + A_rz_5*t238 + A_rz_6*t239)
    t241 = (
        -D_l_dot_1_rx*D_p_rx_5 - D_l_dot_1_ry*D_p_ry_5 - D_l_dot_1_rz*D_p_rz_5 - D_p_x_5*s_dot_1_x
        - D_p_y_5*s_dot_1_y - D_p_z_5*s_dot_1_z
    )
    t242 = (
        -D_l_dot_2_rx*D_p_rx_5 - D_l_dot_2_ry*D_p_ry_5 - D_l_dot_2_rz*D_p_rz_5 - D_p_x_5*s_dot_2_x
        - D_p_y_5*s_dot_2_y - D_p_z_5*s_dot_2_z
    )
    t243 = (
        -D_l_dot_3_rx*D_p_rx_5 - D_l_dot_3_ry*D_p_ry_5 - D_l_dot_3_rz*D_p_rz_5 - D_p_x_5*s_dot_3_x
        - D_p_y_5*s_dot_3_y - D_p_z_5*s_dot_3_z
    )
    t244 = (
        -D_l_dot_4_rx*D_p_rx_5 - D_l_dot_4_ry*D_p_ry_5 - D_l_dot_4_rz*D_p_rz_5 - D_p_x_5*s_dot_4_x
        - D_p_y_5*s_dot_4_y - D_p_z_5*s_dot_4_z
    )
    t245 = (
        -D_l_dot_6_rx*D_p_rx_5 - D_l_dot_6_ry*D_p_ry_5 - D_l_dot_6_rz*D_p_rz_5 - D_p_x_5*s_dot_6_x
        - D_p_y_5*s_dot_6_y - D_p_z_5*s_dot_6_z
    )
    t246 = (
        -D_l_dot_5_rx*D_p_rx_5 - D_l_dot_5_ry*D_p_ry_5 - D_l_dot_5_rz*D_p_rz_5 - D_p_x_5*s_dot_5_x
        - D_p_y_5*s_dot_5_y - D_p_z_5*s_dot_5_z + n_5_x*s_dot_5_x + n_5_y*s_dot_5_y + n_5_z*s_dot_5_z
    )
    D_p_dot_x_5 = t42*(A_x_1*t241 + A_x_2*t242 + A_x_3*t243 + A_x_4*t244 + A_x_5*t246 + A_x_6*t245)
    D_p_dot_y_5 = t42*(A_y_1*t241 + A_y_2*t242 + A_y_3*t243 + A_y_4*t244 + A_y_5*t246 + A_y_6*t245)
    D_p_dot_z_5 = t42*(A_z_1*t241 + A_z_2*t242 + A_z_3*t243 + A_z_4*t244 + A_z_5*t246 + A_z_6*t245)
    D_p_dot_rx_5 = t42*(A_rx_1*t241 + A_rx_2*t242 + A_rx_3*t243 + A_rx_4*t244 + A_rx_5*t246 + A_rx_6*t245)
    D_p_dot_ry_5 = t42*(A_ry_1*t241 + A_ry_2*t242 + A_ry_3*t243 + A_ry_4*t244 + A_ry_5*t246 + A_ry_6*t245)
    D_p_dot_rz_5 = t42*(A_rz_1*t241 + A_rz_2*t242 + A_rz_3*t243 + A_rz_4*t244 + A_rz_5*t246 + A_rz_6*t245)
    t247 = (
        -D_l_dot_1_rx*D_p_rx_6 - D_l_dot_1_ry*D_p_ry_6 - D_l_dot_1_rz*D_p_rz_6 - D_p_x_6*s_dot_1_x
        - D_p_y_6*s_dot_1_y - D_p_z_6*s_dot_1_z
    )
    t248 = (
        -D_l_dot_2_rx*D_p_rx_6 - D_l_dot_2_ry*D_p_ry_6 - D_l_dot_2_rz*D_p_rz_6 - D_p_x_6*s_dot_2_x
        - D_p_y_6*s_dot_2_y - D_p_z_6*s_dot_2_z
    )
    t249 = (
        -D_l_dot_3_rx*D_p_rx_6 - D_l_dot_3_ry*D_p_ry_6 - D_l_dot_3_rz*D_p_rz_6 - D_p_x_6*s_dot_3_x
        - D_p_y_6*s_dot_3_y - D_p_z_6*s_dot_3_z
    )
    t250 = (
        -D_l_dot_4_rx*D_p_rx_6 - D_l_dot_4_ry*D_p_ry_6 - D_l_dot_4_rz*D_p_rz_6 - D_p_x_6*s_dot_4_x
        - D_p_y_6*s_dot_4_y - D_p_z_6*s_dot_4_z
    )
    t251 = (
        -D_l_dot_5_rx*D_p_rx_6 - D_l_dot_5_ry*D_p_ry_6 - D_l_dot_5_rz*D_p_rz_6 - D_p_x_6*s_dot_5_x
        - D_p_y_6*s_dot_5_y - D_p_z_6*s_dot_5_z
    )
    t252 = (
        -D_l_dot_6_rx*D_p_rx_6 - D_l_dot_6_ry*D_p_ry_6 - D_l_dot_6_rz*D_p_rz_6 - D_p_x_6*s_dot_6_x
        - D_p_y_6*s_dot_6_y - D_p_z_6*s_dot_6_z + n_6_x*s_dot_6_x + n_6_y*s_dot_6_y + n_6_z*s_dot_6_z
    )
    D_p_dot_x_6 = t42*(A_x_1*t247 + A_x_2*t248 + A_x_3*t249 + A_x_4*t250 + A_x_5*t251 + A_x_6*t252)
    D_p_dot_y_6 = t42*(A_y_1*t247 + A_y_2*t248 + A_y_3*t249 + A_y_4*t250 + A_y_5*t251 + A_y_6*t252)
    D_p_dot_z_6 = t42*(A_z_1*t247 + A_z_2*t248 + A_z_3*t249 + A_z_4*t250 + A_z_5*t251 + A_z_6*t252)
    D_p_dot_rx_6 = t42*(A_rx_1*t247 + A_rx_2*t248 + A_rx_3*t249 + A_rx_4*t250 + A_rx_5*t251 + A_rx_6*t252)
    D_p_dot_ry_6 = t42*(A_ry_1*t247 + A_ry_2*t248 + A_ry_3*t249 + A_ry_4*t250 + A_ry_5*t251 + A_ry_6*t252)
    D_p_dot_rz_6 = t42*(A_rz_1*t247 + A_rz_2*t248 + A_rz_3*t249 + A_rz_4*t250 + A_rz_5*t251 + A_rz_6*t252)
    a_p_x = (
        D_p_dot_x_1*x_1_dot + D_p_dot_x_2*x_2_dot + D_p_dot_x_3*x_3_dot + D_p_dot_x_4*x_4_dot
        + D_p_dot_x_5*x_5_dot + D_p_dot_x_6*x_6_dot
    )
    a_p_y = (
        D_p_dot_y_1*x_1_dot + D_p_dot_y_2*x_2_dot + D_p_dot_y_3*x_3_dot + D_p_dot_y_4*x_4_dot
        + D_p_dot_y_5*x_5_dot + D_p_dot_y_6*x_6_dot
    )
    a_p_z = (
        D_p_dot_z_1*x_1_dot + D_p_dot_z_2*x_2_dot + D_p_dot_z_3*x_3_dot + D_p_dot_z_4*x_4_dot
        + D_p_dot_z_5*x_5_dot + D_p_dot_z_6*x_6_dot
    )
    a_p_rx = (
        D_p_dot_rx_1*x_1_dot + D_p_dot_rx_2*x_2_dot + D_p_dot_rx_3*x_3_dot + D_p_dot_rx_4*x_4_dot
        + D_p_dot_rx_5*x_5_dot + D_p_dot_rx_6*x_6_dot
    )
    a_p_ry = (
        D_p_dot_ry_1*x_1_dot + D_p_dot_ry_2*x_2_dot + D_p_dot_ry_3*x_3_dot + D_p_dot_ry_4*x_4_dot
        + D_p_dot_ry_5*x_5_dot + D_p_dot_ry_6*x_6_dot
    )
    a_p_rz = (
        D_p_dot_rz_1*x_1_dot + D_p_dot_rz_2*x_2_dot + D_p_dot_rz_3*x_3_dot + D_p_dot_rz_4*x_4_dot
        + D_p_dot_rz_5*x_5_dot + D_p_dot_rz_6*x_6_dot
    )
    t253 = 2*v_p_y
    t254 = c_x*w_p_y
    t255 = 2*c_y
    t256 = c_x*w_p_z
    t257 = 2*t256
    t258 = c_y**2
    t259 = c_z**2
    t260 = (1/2)*m_p
    t261 = B_1_x*w_p_y
    t262 = 2*B_1_y
    t263 = B_1_x*w_p_z
    t264 = 2*B_1_z
    t265 = B_1_y**2
    t266 = B_1_z**2
    t267 = B_1_y*n_1_z - B_1_z*n_1_y
    t268 = (1/6)*m_d_1
    t269 = B_2_x*w_p_y
    t270 = 2*B_2_y
    t271 = B_2_x*w_p_z
    t272 = 2*B_2_z
    t273 = B_2_y**2
    t274 = B_2_z**2
    t275 = B_2_y*n_2_z - B_2_z*n_2_y
    t276 = (1/6)*m_d_2
    t277 = B_3_x*w_p_y
    t278 = 2*B_3_y
    t279 = B_3_x*w_p_z
    t280 = 2*B_3_z
    t281 = B_3_y**2
    t282 = B_3_z**2
    t283 = B_3_y*n_3_z - B_3_z*n_3_y
    t284 = (1/6)*m_d_3
    t285 = B_4_x*w_p_y
    t286 = 2*B_4_y
    t287 = B_4_x*w_p_z
    t288 = 2*B_4_z
    t289 = B_4_y**2
    t290 = B_4_z**2
    t291 = B_4_y*n_4_z - B_4_z*n_4_y
    t292 = (1/6)*m_d_4
    t293 = B_5_x*w_p_y
    t294 = 2*B_5_y
    t295 = B_5_x*w_p_z
    t296 = 2*B_5_z
    t297 = B_5_y**2
    t298 = B_5_z**2
    t299 = B_5_y*n_5_z - B_5_z*n_5_y
    t300 = (1/6)*m_d_5
    t301 = B_6_x*w_p_y
    t302 = 2*B_6_y
    t303 = B_6_x*w_p_z
    t304 = 2*B_6_z
    t305 = B_6_y**2
    t306 = B_6_z**2
    t307 = B_6_y*n_6_z - B_6_z*n_6_y
    t308 = (1/6)*m_d_6
    pi_rx = (
        J_x_x*w_p_x + J_x_y*w_p_y + J_x_z*w_p_z + t260*(2*c_y*v_p_z - c_z*t253 - c_z*t257 - t254*t255
        + 2*w_p_x*(t258 + t259)) + t268*(2*B_1_y*v_p_z - B_1_z*t253 - t261*t262 - t263*t264 + t267*x_1_dot
        + 2*w_p_x*(t265 + t266)) + t276*(2*B_2_y*v_p_z - B_2_z*t253 - t269*t270 - t271*t272 + t275*x_2_dot
        + 2*w_p_x*(t273 + t274)) + t284*(2*B_3_y*v_p_z - B_3_z*t253 - t277*t278 - t279*t280 + t283*x_3_dot
        + 2*w_p_x*(t281 + t282)) + t292*(2*B_4_y*v_p_z - B_4_z*t253 - t285*t286 - t287*t288 + t291*x_4_dot
        + 2*w_p_x*(t289 + t290)) + t300*(2*B_5_y*v_p_z - B_5_z*t253 - t293*t294 - t295*t296 + t299*x_5_dot
        + 2*w_p_x*(t297 + t298)) + t308*(2*B_6_y*v_p_z - B_6_z*t253 - t301*t302 - t303*t304 + t307*x_6_dot
        + 2*w_p_x*(t305 + t306))
    )
    t309 = 2*v_p_z
    t310 = c_y*w_p_x
    t311 = 2*t310
    t312 = c_y*w_p_z
    t313 = c_x**2
    t314 = B_1_y*w_p_x
    t315 = 2*B_1_x
    t316 = B_1_y*w_p_z
    t317 = B_1_x**2
    t318 = -B_1_x*n_1_z + B_1_z*n_1_x
    t319 = B_2_y*w_p_x
    t320 = 2*B_2_x
    t321 = B_2_y*w_p_z
    t322 = B_2_x**2
    t323 = -B_2_x*n_2_z + B_2_z*n_2_x
    t324 = B_3_y*w_p_x
    t325 = 2*B_3_x
    t326 = B_3_y*w_p_z
    t327 = B_3_x**2
    t328 = -B_3_x*n_3_z + B_3_z*n_3_x
    t329 = B_4_y*w_p_x
    t330 = 2*B_4_x
    t331 = B_4_y*w_p_z
    t332 = B_4_x**2
    t333 = -B_4_x*n_4_z + B_4_z*n_4_x
    t334 = B_5_y*w_p_x
    t335 = 2*B_5_x
    t336 = B_5_y*w_p_z
    t337 = B_5_x**2
    t338 = -B_5_x*n_5_z + B_5_z*n_5_x
    t339 = B_6_y*w_p_x
    t340 = 2*B_6_x
    t341 = B_6_y*w_p_z
    t342 = B_6_x**2
    t343 = -B_6_x*n_6_z + B_6_z*n_6_x
    pi_ry = (
        J_x_y*w_p_x + J_y_y*w_p_y + J_y_z*w_p_z + t260*(-c_x*t309 - c_x*t311 - 2*c_z*t312 + 2*c_z*v_p_x
        + 2*w_p_y*(t259 + t313)) + t268*(-B_1_x*t309 + 2*B_1_z*v_p_x - t264*t316 - t314*t315 + t318*x_1_dot
        + 2*w_p_y*(t266 + t317)) + t276*(-B_2_x*t309 + 2*B_2_z*v_p_x - t272*t321 - t319*t320 + t323*x_2_dot
        + 2*w_p_y*(t274 + t322)) + t284*(-B_3_x*t309 + 2*B_3_z*v_p_x - t280*t326 - t324*t325 + t328*x_3_dot
        + 2*w_p_y*(t282 + t327)) + t292*(-B_4_x*t309 + 2*B_4_z*v_p_x - t288*t331 - t329*t330 + t333*x_4_dot
        + 2*w_p_y*(t290 + t332)) + t300*(-B_5_x*t309 + 2*B_5_z*v_p_x - t296*t336 - t334*t335 + t338*x_5_dot
        + 2*w_p_y*(t298 + t337)) + t308*(-B_6_x*t309 + 2*B_6_z*v_p_x - t304*t341 - t339*t340 + t343*x_6_dot
        + 2*w_p_y*(t306 + t342))
    )
    t344 = 2*v_p_x
    t345 = c_z*w_p_x
    t346 = 2*c_x
    t347 = c_z*w_p_y
    t348 = B_1_z*w_p_x
    t349 = B_1_z*w_p_y
    t350 = B_1_x*n_1_y - B_1_y*n_1_x
    t351 = B_2_z*w_p_x
    t352 = B_2_z*w_p_y
    t353 = B_2_x*n_2_y - B_2_y*n_2_x
    t354 = B_3_z*w_p_x
    t355 = B_3_z*w_p_y
    t356 = B_3_x*n_3_y - B_3_y*n_3_x
    t357 = B_4_z*w_p_x
    t358 = B_4_z*w_p_y
    t359 = B_4_x*n_4_y - B_4_y*n_4_x
    t360 = B_5_z*w_p_x
    t361 = B_5_z*w_p_y
    t362 = B_5_x*n_5_y - B_5_y*n_5_x
    t363 = B_6_z*w_p_x
    t364 = B_6_z*w_p_y
    t365 = B_6_x*n_6_y - B_6_y*n_6_x
    pi_rz = (
        J_x_z*w_p_x + J_y_z*w_p_y + J_z_z*w_p_z + t260*(2*c_x*v_p_y - c_y*t344 - t255*t347 - t345*t346
        + 2*w_p_z*(t258 + t313)) + t268*(2*B_1_x*v_p_y - B_1_y*t344 - t262*t349 - t315*t348 + t350*x_1_dot
        + 2*w_p_z*(t265 + t317)) + t276*(2*B_2_x*v_p_y - B_2_y*t344 - t270*t352 - t320*t351 + t353*x_2_dot
        + 2*w_p_z*(t273 + t322)) + t284*(2*B_3_x*v_p_y - B_3_y*t344 - t278*t355 - t325*t354 + t356*x_3_dot
        + 2*w_p_z*(t281 + t327)) + t292*(2*B_4_x*v_p_y - B_4_y*t344 - t286*t358 - t330*t357 + t359*x_4_dot
        + 2*w_p_z*(t289 + t332)) + t300*(2*B_5_x*v_p_y - B_5_y*t344 - t294*t361 - t335*t360 + t362*x_5_dot
        + 2*w_p_z*(t297 + t337)) + t308*(2*B_6_x*v_p_y - B_6_y*t344 - t302*t364 - t340*t363 + t365*x_6_dot
        + 2*w_p_z*(t305 + t342))
    )
    t366 = c_y*w_p_x - t254
    t367 = m_p*t366
    t368 = B_1_y*w_p_x - t261
    t369 = (1/3)*m_d_1
    t370 = t368*t369
    t371 = t263 - t348
    t372 = t369*w_p_z
    t373 = B_2_y*w_p_x - t269
    t374 = (1/3)*m_d_2
    t375 = t373*t374
    t376 = t271 - t351
    t377 = t374*w_p_z
    t378 = B_3_y*w_p_x - t277
    t379 = (1/3)*m_d_3
    t380 = t378*t379
    t381 = t279 - t354
    t382 = t379*w_p_z
    t383 = B_4_y*w_p_x - t285
    t384 = (1/3)*m_d_4
    t385 = t383*t384
    t386 = t287 - t357
    t387 = t384*w_p_z
    t388 = B_5_y*w_p_x - t293
    t389 = (1/3)*m_d_5
    t390 = t388*t389
    t391 = t295 - t360
    t392 = t389*w_p_z
    t393 = B_6_y*w_p_x - t301
    t394 = (1/3)*m_d_6
    t395 = t393*t394
    t396 = t303 - t363
    t397 = t394*w_p_z
    t398 = t256 - t345
    t399 = m_p*w_p_z
    t400 = m_p + t369 + t374 + t379 + t384 + t389 + t394
    t401 = c_z*m_p
    t402 = B_1_z*t369
    t403 = B_2_z*t374
    t404 = B_3_z*t379
    t405 = B_4_z*t384
    t406 = B_5_z*t389
    t407 = B_6_z*t394
    t408 = t401 + t402 + t403 + t404 + t405 + t406 + t407
    t409 = c_y*m_p
    t410 = B_1_y*t369
    t411 = B_2_y*t374
    t412 = B_3_y*t379
    t413 = B_4_y*t384
    t414 = B_5_y*t389
    t415 = B_6_y*t394
    t416 = t409 + t410 + t411 + t412 + t413 + t414 + t415
    z_x = (
        a_p_ry*t408 - a_p_rz*t416 + a_p_x*t400 + t367*w_p_y + t370*w_p_y - t371*t372 + t375*w_p_y - t376*t377
        + t380*w_p_y - t381*t382 + t385*w_p_y - t386*t387 + t390*w_p_y - t391*t392 + t395*w_p_y - t396*t397
        - t398*t399
    )
    t417 = c_z*w_p_y - t312
    t418 = B_1_z*w_p_y - t316
    t419 = B_2_z*w_p_y - t321
    t420 = B_3_z*w_p_y - t326
    t421 = B_4_z*w_p_y - t331
    t422 = B_5_z*w_p_y - t336
    t423 = B_6_z*w_p_y - t341
    t424 = c_x*m_p
    t425 = B_1_x*t369 + B_2_x*t374 + B_3_x*t379 + B_4_x*t384 + B_5_x*t389 + B_6_x*t394 + t424
    z_y = (
        -a_p_rx*t408 + a_p_rz*t425 + a_p_y*t400 - t367*w_p_x - t370*w_p_x + t372*t418 - t375*w_p_x + t377*t419
        - t380*w_p_x + t382*t420 - t385*w_p_x + t387*t421 - t390*w_p_x + t392*t422 - t395*w_p_x + t397*t423
        + t399*t417
    )
    z_z = (
        a_p_rx*t416 - a_p_ry*t425 + a_p_z*t400 + m_p*t398*w_p_x - m_p*t417*w_p_y + t369*t371*w_p_x
        - t369*t418*w_p_y + t374*t376*w_p_x - t374*t419*w_p_y + t379*t381*w_p_x - t379*t420*w_p_y
        + t384*t386*w_p_x - t384*t421*w_p_y + t389*t391*w_p_x - t389*t422*w_p_y + t394*t396*w_p_x
        - t394*t423*w_p_y
    )
    t426 = 2*w_p_y
    t427 = B_1_y*t426
    t428 = 2*w_p_z
    t429 = B_1_z*t428
    t430 = t268*t418
    t431 = B_2_y*t426
    t432 = B_2_z*t428
    t433 = t276*t419
    t434 = B_3_y*t426
    t435 = B_3_z*t428
    t436 = t284*t420
    t437 = B_4_y*t426
    t438 = B_4_z*t428
    t439 = t292*t421
    t440 = B_5_y*t426
    t441 = B_5_z*t428
    t442 = t300*t422
    t443 = B_6_y*t426
    t444 = B_6_z*t428
    t445 = t308*t423
    t446 = c_y*t426
    t447 = c_z*t428
    t448 = t260*t417
    t449 = t260*t366
    t450 = t260*t398
    t451 = n_1_z*x_1_dot
    t452 = t309 + t451
    t453 = t268*t371
    t454 = n_2_z*x_2_dot
    t455 = t309 + t454
    t456 = t276*t376
    t457 = n_3_z*x_3_dot
    t458 = t309 + t457
    t459 = t284*t381
    t460 = n_4_z*x_4_dot
    t461 = t309 + t460
    t462 = t292*t386
    t463 = n_5_z*x_5_dot
    t464 = t309 + t463
    t465 = t300*t391
    t466 = n_6_z*x_6_dot
    t467 = t309 + t466
    t468 = t308*t396
    t469 = n_1_y*x_1_dot
    t470 = t253 + t469
    t471 = t268*t368
    t472 = n_2_y*x_2_dot
    t473 = t253 + t472
    t474 = t276*t373
    t475 = n_3_y*x_3_dot
    t476 = t253 + t475
    t477 = t284*t378
    t478 = n_4_y*x_4_dot
    t479 = t253 + t478
    t480 = t292*t383
    t481 = n_5_y*x_5_dot
    t482 = t253 + t481
    t483 = t300*t388
    t484 = n_6_y*x_6_dot
    t485 = t253 + t484
    t486 = t308*t393
    t487 = w_p_x**2
    t488 = w_p_y**2
    t489 = 2*w_p_x
    t490 = t253*w_p_x - 2*v_p_x*w_p_y
    t491 = c_z*t487 + c_z*t488 - 1/2*t256*t489 - 1/2*t312*t426 - 1/2*t490
    t492 = w_p_z**2
    t493 = t344*w_p_z - 2*v_p_z*w_p_x
    t494 = 2*c_y*t487 + 2*c_y*t492 - t254*t489 - t347*t428 - t493
    t495 = (1/2)*t401
    t496 = -B_1_x*t410 - B_2_x*t411 - B_3_x*t412 - B_4_x*t413 - B_5_x*t414 - B_6_x*t415 + J_x_y - c_x*t409
    t497 = -B_1_x*t402 - B_2_x*t403 - B_3_x*t404 - B_4_x*t405 - B_5_x*t406 - B_6_x*t407 + J_x_z - c_x*t401
    t498 = (
        t268*(2*B_1_z*t487 + 2*B_1_z*t488 + n_1_x*w_p_y*x_1_dot - t263*t489 - t316*t426 - t469*w_p_x - t490)
    )
    t499 = n_1_x*x_1_dot
    t500 = 2*B_1_y*t487 + 2*B_1_y*t492 + n_1_z*w_p_x*x_1_dot - t261*t489 - t349*t428 - t493 - t499*w_p_z
    t501 = B_1_z*t268
    t502 = (
        t276*(2*B_2_z*t487 + 2*B_2_z*t488 + n_2_x*w_p_y*x_2_dot - t271*t489 - t321*t426 - t472*w_p_x - t490)
    )
    t503 = n_2_x*x_2_dot
    t504 = 2*B_2_y*t487 + 2*B_2_y*t492 + n_2_z*w_p_x*x_2_dot - t269*t489 - t352*t428 - t493 - t503*w_p_z
    t505 = B_2_z*t276
    t506 = (
        t284*(2*B_3_z*t487 + 2*B_3_z*t488 + n_3_x*w_p_y*x_3_dot - t279*t489 - t326*t426 - t475*w_p_x - t490)
    )
    t507 = n_3_x*x_3_dot
    t508 = 2*B_3_y*t487 + 2*B_3_y*t492 + n_3_z*w_p_x*x_3_dot - t277*t489 - t355*t428 - t493 - t507*w_p_z
    t509 = B_3_z*t284
    t510 = (
        t292*(2*B_4_z*t487 + 2*B_4_z*t488 + n_4_x*w_p_y*x_4_dot - t287*t489 - t331*t426 - t478*w_p_x - t490)
    )
    t511 = n_4_x*x_4_dot
    t512 = 2*B_4_y*t487 + 2*B_4_y*t492 + n_4_z*w_p_x*x_4_dot - t285*t489 - t358*t428 - t493 - t511*w_p_z
    t513 = B_4_z*t292
    t514 = (
        t300*(2*B_5_z*t487 + 2*B_5_z*t488 + n_5_x*w_p_y*x_5_dot - t295*t489 - t336*t426 - t481*w_p_x - t490)
    )
    t515 = n_5_x*x_5_dot
    t516 = 2*B_5_y*t487 + 2*B_5_y*t492 + n_5_z*w_p_x*x_5_dot - t293*t489 - t361*t428 - t493 - t515*w_p_z
    t517 = B_5_z*t300
    t518 = (
        t308*(2*B_6_z*t487 + 2*B_6_z*t488 + n_6_x*w_p_y*x_6_dot - t303*t489 - t341*t426 - t484*w_p_x - t490)
    )
    t519 = n_6_x*x_6_dot
    t520 = 2*B_6_y*t487 + 2*B_6_y*t492 + n_6_z*w_p_x*x_6_dot - t301*t489 - t364*t428 - t493 - t519*w_p_z
    t521 = B_6_z*t308
    t522 = t12 + t14 + t18
    t523 = w_p_x*w_p_y
    t524 = t24 + t25 + t33
    t525 = w_p_y*w_p_z
    t526 = I_p_x*R_y_x
    t527 = t28 + t30 + 2*t526
    t528 = (1/2)*t488
    t529 = t522*t523 + t524*t525 + t527*t528
    t530 = t16 + t19 + t21
    t531 = t26 + t34 + t36
    t532 = I_p_xy*R_y_x
    t533 = I_p_y*R_y_y
    t534 = t32 + 2*t532 + 2*t533
    t535 = t523*t530 + t525*t531 + t528*t534
    t536 = t20 + t22 + t23
    t537 = t35 + t37 + t38
    t538 = I_p_xz*R_y_x
    t539 = I_p_yz*R_y_y
    t540 = I_p_z*R_y_z
    t541 = 2*t538 + 2*t539 + 2*t540
    t542 = t523*t536 + t525*t537 + t528*t541
    t543 = w_p_x*w_p_z
    t544 = t27 + t29 + t526
    t545 = 2*t33 + t39 + t40
    t546 = (1/2)*t492
    t547 = t522*t543 + t525*t544 + t545*t546
    t548 = t31 + t532 + t533
    t549 = 2*t34 + 2*t36 + t41
    t550 = t525*t548 + t530*t543 + t546*t549
    t551 = t538 + t539 + t540
    t552 = 2*t35 + 2*t37 + 2*t38
    t553 = t525*t551 + t536*t543 + t546*t552
    t554 = -R_y_x*w_p_z + R_z_x*w_p_y
    t555 = t13 + t15 + 2*t18
    t556 = -R_y_y*w_p_z + R_z_y*w_p_y
    t557 = t17 + 2*t19 + 2*t21
    t558 = -R_y_z*w_p_z + R_z_z*w_p_y
    t559 = 2*t20 + 2*t22 + 2*t23
    t560 = 2*t265
    t561 = 2*t266
    t562 = 2*t273
    t563 = 2*t274
    t564 = 2*t281
    t565 = 2*t282
    t566 = 2*t289
    t567 = 2*t290
    t568 = 2*t297
    t569 = 2*t298
    t570 = 2*t305
    t571 = 2*t306
    t572 = 2*t258
    t573 = 2*t259
    t574 = R_x_x*w_p_z - R_z_x*w_p_x
    t575 = R_x_y*w_p_z - R_z_y*w_p_x
    t576 = R_x_z*w_p_z - R_z_z*w_p_x
    t577 = t522*t574 + t530*t575 + t536*t576 + t544*t554 + t548*t556 + t551*t558
    t578 = -R_x_x*w_p_y + R_y_x*w_p_x
    t579 = -R_x_y*w_p_y + R_y_y*w_p_x
    t580 = -R_x_z*w_p_y + R_y_z*w_p_x
    t581 = t522*t578 + t524*t554 + t530*t579 + t531*t556 + t536*t580 + t537*t558
    z_rx = (
        -B_1_y*t498 - B_2_y*t502 - B_3_y*t506 - B_4_y*t510 - B_5_y*t514 - B_6_y*t518 - R_y_x*t547 - R_y_y*t550
        - R_y_z*t553 + R_z_x*t529 + R_z_y*t535 + R_z_z*t542 + a_p_rx*(J_x_x + t260*(t572 + t573) + t268*(t560
        + t561) + t276*(t562 + t563) + t284*(t564 + t565) + t292*(t566 + t567) + t300*(t568 + t569)
        + t308*(t570 + t571)) + a_p_ry*t496 + a_p_rz*t497 - a_p_y*t408 + a_p_z*t416 + pi_ry*w_p_z
        - pi_rz*w_p_y - t409*t491 + t430*(-t427 - t429) + t433*(-t431 - t432) + t436*(-t434 - t435)
        + t439*(-t437 - t438) + t442*(-t440 - t441) + t445*(-t443 - t444) + t448*(-t446 - t447)
        + t449*(4*c_z*w_p_x - t253 - t257) + t450*(-2*t254 + t309 + 4*t310) + t453*(-2*t261 + 4*t314 + t452)
        + t456*(-2*t269 + 4*t319 + t455) + t459*(-2*t277 + 4*t324 + t458) + t462*(-2*t285 + 4*t329 + t461)
        + t465*(-2*t293 + 4*t334 + t464) + t468*(-2*t301 + 4*t339 + t467) + t471*(4*B_1_z*w_p_x - 2*t263
        - t470) + t474*(4*B_2_z*w_p_x - 2*t271 - t473) + t477*(4*B_3_z*w_p_x - 2*t279 - t476)
        + t480*(4*B_4_z*w_p_x - 2*t287 - t479) + t483*(4*B_5_z*w_p_x - 2*t295 - t482) + t486*(4*B_6_z*w_p_x
        - 2*t303 - t485) + t494*t495 + t500*t501 + t504*t505 + t508*t509 + t512*t513 + t516*t517 + t520*t521
        + t577*w_p_y + t581*w_p_z + w_p_x*(t554*t555 + t556*t557 + t558*t559)
    )
    t582 = B_1_x*t489
    t583 = B_2_x*t489
    t584 = B_3_x*t489
    t585 = B_4_x*t489
    t586 = B_5_x*t489
    t587 = B_6_x*t489
    t588 = c_x*t489
    t589 = t344 + t499
    t590 = t344 + t503
    t591 = t344 + t507
    t592 = t344 + t511
    t593 = t344 + t515
    t594 = t344 + t519
    t595 = t253*w_p_z - t309*w_p_y
    t596 = -t310*t426 - t345*t428 + t346*t488 + t346*t492 + t595
    t597 = -B_1_y*t402 - B_2_y*t403 - B_3_y*t404 - B_4_y*t405 - B_5_y*t406 - B_6_y*t407 + J_y_z - c_y*t401
    t598 = -t314*t426 + t315*t488 + t315*t492 - t348*t428 - t451*w_p_y + t469*w_p_z + t595
    t599 = -t319*t426 + t320*t488 + t320*t492 - t351*t428 - t454*w_p_y + t472*w_p_z + t595
    t600 = -t324*t426 + t325*t488 + t325*t492 - t354*t428 - t457*w_p_y + t475*w_p_z + t595
    t601 = -t329*t426 + t330*t488 + t330*t492 - t357*t428 - t460*w_p_y + t478*w_p_z + t595
    t602 = -t334*t426 + t335*t488 + t335*t492 - t360*t428 - t463*w_p_y + t481*w_p_z + t595
    t603 = -t339*t426 + t340*t488 + t340*t492 - t363*t428 - t466*w_p_y + t484*w_p_z + t595
    t604 = (1/2)*t487
    t605 = t523*t544 + t524*t543 + t555*t604
    t606 = t523*t548 + t531*t543 + t557*t604
    t607 = t523*t551 + t537*t543 + t559*t604
    t608 = 2*t317
    t609 = 2*t322
    t610 = 2*t327
    t611 = 2*t332
    t612 = 2*t337
    t613 = 2*t342
    t614 = 2*t313
    t615 = t524*t574 + t531*t575 + t537*t576 + t544*t578 + t548*t579 + t551*t580
    z_ry = (
        B_1_x*t498 + B_2_x*t502 + B_3_x*t506 + B_4_x*t510 + B_5_x*t514 + B_6_x*t518 + R_x_x*t547 + R_x_y*t550
        + R_x_z*t553 - R_z_x*t605 - R_z_y*t606 - R_z_z*t607 + a_p_rx*t496 + a_p_ry*(J_y_y + t260*(t573 + t614)
        + t268*(t561 + t608) + t276*(t563 + t609) + t284*(t565 + t610) + t292*(t567 + t611) + t300*(t569
        + t612) + t308*(t571 + t613)) + a_p_rz*t597 + a_p_x*t408 - a_p_z*t425 - pi_rx*w_p_z + pi_rz*w_p_x
        + t424*t491 + t430*(4*B_1_x*w_p_y - 2*t314 - t452) + t433*(4*B_2_x*w_p_y - 2*t319 - t455)
        + t436*(4*B_3_x*w_p_y - 2*t324 - t458) + t439*(4*B_4_x*w_p_y - 2*t329 - t461) + t442*(4*B_5_x*w_p_y
        - 2*t334 - t464) + t445*(4*B_6_x*w_p_y - 2*t339 - t467) + t448*(4*c_x*w_p_y - t309 - t311)
        + t449*(-2*t312 + t344 + 4*t347) + t450*(-t447 - t588) + t453*(-t429 - t582) + t456*(-t432 - t583)
        + t459*(-t435 - t584) + t462*(-t438 - t585) + t465*(-t441 - t586) + t468*(-t444 - t587)
        + t471*(-2*t316 + 4*t349 + t589) + t474*(-2*t321 + 4*t352 + t590) + t477*(-2*t326 + 4*t355 + t591)
        + t480*(-2*t331 + 4*t358 + t592) + t483*(-2*t336 + 4*t361 + t593) + t486*(-2*t341 + 4*t364 + t594)
        - t495*t596 - t501*t598 - t505*t599 - t509*t600 - t513*t601 - t517*t602 - t521*t603 + t577*w_p_x
        + t615*w_p_z + w_p_y*(t527*t574 + t534*t575 + t541*t576)
    )
    z_rz = (
        -B_1_x*t268*t500 + B_1_y*t268*t598 - B_2_x*t276*t504 + B_2_y*t276*t599 - B_3_x*t284*t508
        + B_3_y*t284*t600 - B_4_x*t292*t512 + B_4_y*t292*t601 - B_5_x*t300*t516 + B_5_y*t300*t602
        - B_6_x*t308*t520 + B_6_y*t308*t603 - R_x_x*t529 - R_x_y*t535 - R_x_z*t542 + R_y_x*t605 + R_y_y*t606
        + R_y_z*t607 + a_p_rx*t497 + a_p_ry*t597 + a_p_rz*(J_z_z + t260*(t572 + t614) + t268*(t560 + t608)
        + t276*(t562 + t609) + t284*(t564 + t610) + t292*(t566 + t611) + t300*(t568 + t612) + t308*(t570
        + t613)) - a_p_x*t416 + a_p_y*t425 + pi_rx*w_p_y - pi_ry*w_p_x + (1/2)*t409*t596 - 1/2*t424*t494
        + t430*(4*t263 - 2*t348 + t470) + t433*(4*t271 - 2*t351 + t473) + t436*(4*t279 - 2*t354 + t476)
        + t439*(4*t287 - 2*t357 + t479) + t442*(4*t295 - 2*t360 + t482) + t445*(4*t303 - 2*t363 + t485)
        + t448*(t253 + 4*t256 - 2*t345) + t449*(-t446 - t588) + t450*(4*c_y*w_p_z - t344 - 2*t347)
        + t453*(4*B_1_y*w_p_z - 2*t349 - t589) + t456*(4*B_2_y*w_p_z - 2*t352 - t590) + t459*(4*B_3_y*w_p_z
        - 2*t355 - t591) + t462*(4*B_4_y*w_p_z - 2*t358 - t592) + t465*(4*B_5_y*w_p_z - 2*t361 - t593)
        + t468*(4*B_6_y*w_p_z - 2*t364 - t594) + t471*(-t427 - t582) + t474*(-t431 - t583) + t477*(-t434
        - t584) + t480*(-t437 - t585) + t483*(-t440 - t586) + t486*(-t443 - t587) + t581*w_p_x + t615*w_p_y
        + w_p_z*(t545*t578 + t549*t579 + t552*t580)
    )
    h_out = np.empty((*batch, 6), dtype)
    h_out[..., 0] = (
        D_p_rx_1*z_rx + D_p_ry_1*z_ry + D_p_rz_1*z_rz + D_p_x_1*z_x + D_p_y_1*z_y + D_p_z_1*z_z
        + a_p_rx*t267*t268 + a_p_ry*t268*t318 + a_p_rz*t268*t350 + a_p_x*n_1_x*t268 + a_p_y*n_1_y*t268
        + a_p_z*n_1_z*t268 + t430*(n_1_y*w_p_z - n_1_z*w_p_y) + t453*(-n_1_x*w_p_z + n_1_z*w_p_x)
        + t471*(n_1_x*w_p_y - n_1_y*w_p_x)
    )
    h_out[..., 1] = (
        D_p_rx_2*z_rx + D_p_ry_2*z_ry + D_p_rz_2*z_rz + D_p_x_2*z_x + D_p_y_2*z_y + D_p_z_2*z_z
        + a_p_rx*t275*t276 + a_p_ry*t276*t323 + a_p_rz*t276*t353 + a_p_x*n_2_x*t276 + a_p_y*n_2_y*t276
        + a_p_z*n_2_z*t276 + t433*(n_2_y*w_p_z - n_2_z*w_p_y) + t456*(-n_2_x*w_p_z + n_2_z*w_p_x)
        + t474*(n_2_x*w_p_y - n_2_y*w_p_x)
    )
    h_out[..., 2] = (
        D_p_rx_3*z_rx + D_p_ry_3*z_ry + D_p_rz_3*z_rz + D_p_x_3*z_x + D_p_y_3*z_y + D_p_z_3*z_z
        + a_p_rx*t283*t284 + a_p_ry*t284*t328 + a_p_rz*t284*t356 + a_p_x*n_3_x*t284 + a_p_y*n_3_y*t284
        + a_p_z*n_3_z*t284 + t436*(n_3_y*w_p_z - n_3_z*w_p_y) + t459*(-n_3_x*w_p_z + n_3_z*w_p_x)
        + t477*(n_3_x*w_p_y - n_3_y*w_p_x)
    )
    h_out[..., 3] = (
        D_p_rx_4*z_rx + D_p_ry_4*z_ry + D_p_rz_4*z_rz + D_p_x_4*z_x + D_p_y_4*z_y + D_p_z_4*z_z
        + a_p_rx*t291*t292 + a_p_ry*t292*t333 + a_p_rz*t292*t359 + a_p_x*n_4_x*t292 + a_p_y*n_4_y*t292
        + a_p_z*n_4_z*t292 + t439*(n_4_y*w_p_z - n_4_z*w_p_y) + t462*(-n_4_x*w_p_z + n_4_z*w_p_x)
        + t480*(n_4_x*w_p_y - n_4_y*w_p_x)
    )
    h_out[..., 4] = (
        D_p_rx_5*z_rx + D_p_ry_5*z_ry + D_p_rz_5*z_rz + D_p_x_5*z_x + D_p_y_5*z_y + D_p_z_5*z_z
        + a_p_rx*t299*t300 + a_p_ry*t300*t338 + a_p_rz*t300*t362 + a_p_x*n_5_x*t300 + a_p_y*n_5_y*t300
        + a_p_z*n_5_z*t300 + t442*(n_5_y*w_p_z - n_5_z*w_p_y) + t465*(-n_5_x*w_p_z + n_5_z*w_p_x)
        + t483*(n_5_x*w_p_y - n_5_y*w_p_x)
    )
    h_out[..., 5] = (
        D_p_rx_6*z_rx + D_p_ry_6*z_ry + D_p_rz_6*z_rz + D_p_x_6*z_x + D_p_y_6*z_y + D_p_z_6*z_z
        + a_p_rx*t307*t308 + a_p_ry*t308*t343 + a_p_rz*t308*t365 + a_p_x*n_6_x*t308 + a_p_y*n_6_y*t308
        + a_p_z*n_6_z*t308 + t445*(n_6_y*w_p_z - n_6_z*w_p_y) + t468*(-n_6_x*w_p_z + n_6_z*w_p_x)
        + t486*(n_6_x*w_p_y - n_6_y*w_p_x)
    )
    return h_out


def gravity_potential(p, parameters):
    """Gravitational potential energy V_g = -U_g, with the force function U_g.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    V_g : array, shape (...) [J]
        Zero at the origin of the base frame.

    Notes
    -----
    Equation 26, for gravity in any direction and all moving bodies.
    540 operations; 85200 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    m_t_1, m_t_2, m_t_3, m_t_4, m_t_5, m_t_6 = _entries(parameters.carriage_mass, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, m_p, c_p_x, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    t12 = (1/2)*m_d_1
    t13 = (1/2)*m_d_2
    t14 = (1/2)*m_d_3
    t15 = (1/2)*m_d_4
    t16 = (1/2)*m_d_5
    t17 = (1/2)*m_d_6
    t18 = m_t_1*x_1
    t19 = m_t_2*x_2
    t20 = m_t_3*x_3
    t21 = m_t_4*x_4
    t22 = m_t_5*x_5
    t23 = m_t_6*x_6
    t24 = t12*x_1
    t25 = t13*x_2
    t26 = t14*x_3
    t27 = t15*x_4
    t28 = t16*x_5
    t29 = t17*x_6
    t30 = m_p + t12 + t13 + t14 + t15 + t16 + t17
    V_g_out = np.empty(batch, dtype)
    V_g_out[...] = (
        -g_x*(B_1_x*t12 + B_2_x*t13 + B_3_x*t14 + B_4_x*t15 + B_5_x*t16 + B_6_x*t17 + c_x*m_p + m_t_1*o_1_x
        + m_t_2*o_2_x + m_t_3*o_3_x + m_t_4*o_4_x + m_t_5*o_5_x + m_t_6*o_6_x + n_1_x*t18 + n_1_x*t24
        + n_2_x*t19 + n_2_x*t25 + n_3_x*t20 + n_3_x*t26 + n_4_x*t21 + n_4_x*t27 + n_5_x*t22 + n_5_x*t28
        + n_6_x*t23 + n_6_x*t29 + o_1_x*t12 + o_2_x*t13 + o_3_x*t14 + o_4_x*t15 + o_5_x*t16 + o_6_x*t17
        + p_x*t30) - g_y*(B_1_y*t12 + B_2_y*t13 + B_3_y*t14 + B_4_y*t15 + B_5_y*t16 + B_6_y*t17 + c_y*m_p
        + m_t_1*o_1_y + m_t_2*o_2_y + m_t_3*o_3_y + m_t_4*o_4_y + m_t_5*o_5_y + m_t_6*o_6_y + n_1_y*t18
        + n_1_y*t24 + n_2_y*t19 + n_2_y*t25 + n_3_y*t20 + n_3_y*t26 + n_4_y*t21 + n_4_y*t27 + n_5_y*t22
        + n_5_y*t28 + n_6_y*t23 + n_6_y*t29 + o_1_y*t12 + o_2_y*t13 + o_3_y*t14 + o_4_y*t15 + o_5_y*t16
        + o_6_y*t17 + p_y*t30) - g_z*(B_1_z*t12 + B_2_z*t13 + B_3_z*t14 + B_4_z*t15 + B_5_z*t16 + B_6_z*t17
        + c_z*m_p + m_t_1*o_1_z + m_t_2*o_2_z + m_t_3*o_3_z + m_t_4*o_4_z + m_t_5*o_5_z + m_t_6*o_6_z
        + n_1_z*t18 + n_1_z*t24 + n_2_z*t19 + n_2_z*t25 + n_3_z*t20 + n_3_z*t26 + n_4_z*t21 + n_4_z*t27
        + n_5_z*t22 + n_5_z*t28 + n_6_z*t23 + n_6_z*t29 + o_1_z*t12 + o_2_z*t13 + o_3_z*t14 + o_4_z*t15
        + o_5_z*t16 + o_6_z*t17 + p_z*t30)
    )
    return V_g_out[()]


def gravity_gradient(p, parameters):
    """Gradient of the gravitational potential energy with respect to the carriage positions.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    G : array, shape (..., 6) [N]
        dV_g/dq_k.

    Notes
    -----
    Equation 27.
    1951 operations; 182295552 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    m_t_1, m_t_2, m_t_3, m_t_4, m_t_5, m_t_6 = _entries(parameters.carriage_mass, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, m_p, c_p_x, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = 1.0/det_D_l
    t13 = D_r_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = D_r_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = D_r_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = D_r_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = D_r_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = D_r_6*t12
    D_p_x_6 = A_x_6*t18
    D_p_y_1 = A_y_1*t13
    D_p_y_2 = A_y_2*t14
    D_p_y_3 = A_y_3*t15
    D_p_y_4 = A_y_4*t16
    D_p_y_5 = A_y_5*t17
    D_p_y_6 = A_y_6*t18
    D_p_z_1 = A_z_1*t13
    D_p_z_2 = A_z_2*t14
    D_p_z_3 = A_z_3*t15
    D_p_z_4 = A_z_4*t16
    D_p_z_5 = A_z_5*t17
    D_p_z_6 = A_z_6*t18
    D_p_rx_1 = A_rx_1*t13
    D_p_rx_2 = A_rx_2*t14
    D_p_rx_3 = A_rx_3*t15
    D_p_rx_4 = A_rx_4*t16
    D_p_rx_5 = A_rx_5*t17
    D_p_rx_6 = A_rx_6*t18
    D_p_ry_1 = A_ry_1*t13
    D_p_ry_2 = A_ry_2*t14
    D_p_ry_3 = A_ry_3*t15
    D_p_ry_4 = A_ry_4*t16
    D_p_ry_5 = A_ry_5*t17
    D_p_ry_6 = A_ry_6*t18
    D_p_rz_1 = A_rz_1*t13
    D_p_rz_2 = A_rz_2*t14
    D_p_rz_3 = A_rz_3*t15
    D_p_rz_4 = A_rz_4*t16
    D_p_rz_5 = A_rz_5*t17
    D_p_rz_6 = A_rz_6*t18
    t19 = (1/2)*m_d_1
    t20 = (1/2)*m_d_2
    t21 = (1/2)*m_d_3
    t22 = (1/2)*m_d_4
    t23 = (1/2)*m_d_5
    t24 = (1/2)*m_d_6
    t25 = m_p + t19 + t20 + t21 + t22 + t23 + t24
    G_p_x = -g_x*t25
    G_p_y = -g_y*t25
    G_p_z = -g_z*t25
    t26 = g_z*m_p
    t27 = g_z*t19
    t28 = g_z*t20
    t29 = g_z*t21
    t30 = g_z*t22
    t31 = g_z*t23
    t32 = g_z*t24
    G_p_rx = (
        -B_1_y*t27 + (1/2)*B_1_z*g_y*m_d_1 - B_2_y*t28 + (1/2)*B_2_z*g_y*m_d_2 - B_3_y*t29
        + (1/2)*B_3_z*g_y*m_d_3 - B_4_y*t30 + (1/2)*B_4_z*g_y*m_d_4 - B_5_y*t31 + (1/2)*B_5_z*g_y*m_d_5
        - B_6_y*t32 + (1/2)*B_6_z*g_y*m_d_6 - c_y*t26 + c_z*g_y*m_p
    )
    G_p_ry = (
        B_1_x*t27 - B_1_z*g_x*t19 + B_2_x*t28 - B_2_z*g_x*t20 + B_3_x*t29 - B_3_z*g_x*t21 + B_4_x*t30
        - B_4_z*g_x*t22 + B_5_x*t31 - B_5_z*g_x*t23 + B_6_x*t32 - B_6_z*g_x*t24 + c_x*t26 - c_z*g_x*m_p
    )
    G_p_rz = (
        -B_1_x*g_y*t19 + (1/2)*B_1_y*g_x*m_d_1 - B_2_x*g_y*t20 + (1/2)*B_2_y*g_x*m_d_2 - B_3_x*g_y*t21
        + (1/2)*B_3_y*g_x*m_d_3 - B_4_x*g_y*t22 + (1/2)*B_4_y*g_x*m_d_4 - B_5_x*g_y*t23
        + (1/2)*B_5_y*g_x*m_d_5 - B_6_x*g_y*t24 + (1/2)*B_6_y*g_x*m_d_6 - c_x*g_y*m_p + c_y*g_x*m_p
    )
    G_out = np.empty((*batch, 6), dtype)
    G_out[..., 0] = (
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - g_x*(m_t_1*n_1_x + n_1_x*t19) - g_y*(m_t_1*n_1_y + n_1_y*t19) - g_z*(m_t_1*n_1_z + n_1_z*t19)
    )
    G_out[..., 1] = (
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - g_x*(m_t_2*n_2_x + n_2_x*t20) - g_y*(m_t_2*n_2_y + n_2_y*t20) - g_z*(m_t_2*n_2_z + n_2_z*t20)
    )
    G_out[..., 2] = (
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - g_x*(m_t_3*n_3_x + n_3_x*t21) - g_y*(m_t_3*n_3_y + n_3_y*t21) - g_z*(m_t_3*n_3_z + n_3_z*t21)
    )
    G_out[..., 3] = (
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - g_x*(m_t_4*n_4_x + n_4_x*t22) - g_y*(m_t_4*n_4_y + n_4_y*t22) - g_z*(m_t_4*n_4_z + n_4_z*t22)
    )
    G_out[..., 4] = (
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - g_x*(m_t_5*n_5_x + n_5_x*t23) - g_y*(m_t_5*n_5_y + n_5_y*t23) - g_z*(m_t_5*n_5_z + n_5_z*t23)
    )
    G_out[..., 5] = (
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - g_x*(m_t_6*n_6_x + n_6_x*t24) - g_y*(m_t_6*n_6_y + n_6_y*t24) - g_z*(m_t_6*n_6_z + n_6_z*t24)
    )
    return G_out


def gravity_hessian(p, parameters):
    """Hessian of the gravitational potential energy with respect to the carriage positions.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    H_g : array, shape (..., 6, 6) [N/m]
        d2V_g/dq_k dq_l, symmetric.

    Notes
    -----
    Section 4 and equation 49.
    3125 operations; 96468736266 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, m_p, c_p_x, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = 1.0/det_D_l
    t13 = D_r_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = D_r_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = D_r_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = D_r_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = D_r_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = D_r_6*t12
    D_p_x_6 = A_x_6*t18
    D_p_y_1 = A_y_1*t13
    D_p_y_2 = A_y_2*t14
    D_p_y_3 = A_y_3*t15
    D_p_y_4 = A_y_4*t16
    D_p_y_5 = A_y_5*t17
    D_p_y_6 = A_y_6*t18
    D_p_z_1 = A_z_1*t13
    D_p_z_2 = A_z_2*t14
    D_p_z_3 = A_z_3*t15
    D_p_z_4 = A_z_4*t16
    D_p_z_5 = A_z_5*t17
    D_p_z_6 = A_z_6*t18
    D_p_rx_1 = A_rx_1*t13
    D_p_rx_2 = A_rx_2*t14
    D_p_rx_3 = A_rx_3*t15
    D_p_rx_4 = A_rx_4*t16
    D_p_rx_5 = A_rx_5*t17
    D_p_rx_6 = A_rx_6*t18
    D_p_ry_1 = A_ry_1*t13
    D_p_ry_2 = A_ry_2*t14
    D_p_ry_3 = A_ry_3*t15
    D_p_ry_4 = A_ry_4*t16
    D_p_ry_5 = A_ry_5*t17
    D_p_ry_6 = A_ry_6*t18
    D_p_rz_1 = A_rz_1*t13
    D_p_rz_2 = A_rz_2*t14
    D_p_rz_3 = A_rz_3*t15
    D_p_rz_4 = A_rz_4*t16
    D_p_rz_5 = A_rz_5*t17
    D_p_rz_6 = A_rz_6*t18
    t19 = (1/2)*m_d_1
    t20 = (1/2)*m_d_2
    t21 = (1/2)*m_d_3
    t22 = (1/2)*m_d_4
    t23 = (1/2)*m_d_5
    t24 = (1/2)*m_d_6
    t25 = m_p + t19 + t20 + t21 + t22 + t23 + t24
    G_p_x = -g_x*t25
    G_p_y = -g_y*t25
    G_p_z = -g_z*t25
    t26 = g_z*m_p
    t27 = g_z*t19
    t28 = g_z*t20
    t29 = g_z*t21
    t30 = g_z*t22
    t31 = g_z*t23
    t32 = g_z*t24
    G_p_rx = (
        -B_1_y*t27 + (1/2)*B_1_z*g_y*m_d_1 - B_2_y*t28 + (1/2)*B_2_z*g_y*m_d_2 - B_3_y*t29
        + (1/2)*B_3_z*g_y*m_d_3 - B_4_y*t30 + (1/2)*B_4_z*g_y*m_d_4 - B_5_y*t31 + (1/2)*B_5_z*g_y*m_d_5
        - B_6_y*t32 + (1/2)*B_6_z*g_y*m_d_6 - c_y*t26 + c_z*g_y*m_p
    )
    t33 = g_x*t19
    t34 = g_x*t20
    t35 = g_x*t21
    t36 = g_x*t22
    t37 = g_x*t23
    t38 = g_x*t24
    t39 = g_x*m_p
    G_p_ry = (
        B_1_x*t27 - B_1_z*t33 + B_2_x*t28 - B_2_z*t34 + B_3_x*t29 - B_3_z*t35 + B_4_x*t30 - B_4_z*t36
        + B_5_x*t31 - B_5_z*t37 + B_6_x*t32 - B_6_z*t38 + c_x*t26 - c_z*t39
    )
    t40 = g_y*m_p
    t41 = g_y*t19
    t42 = g_y*t20
    t43 = g_y*t21
    t44 = g_y*t22
    t45 = g_y*t23
    t46 = g_y*t24
    G_p_rz = (
        -B_1_x*t41 + (1/2)*B_1_y*g_x*m_d_1 - B_2_x*t42 + (1/2)*B_2_y*g_x*m_d_2 - B_3_x*t43
        + (1/2)*B_3_y*g_x*m_d_3 - B_4_x*t44 + (1/2)*B_4_y*g_x*m_d_4 - B_5_x*t45 + (1/2)*B_5_y*g_x*m_d_5
        - B_6_x*t46 + (1/2)*B_6_y*g_x*m_d_6 - c_x*t40 + c_y*g_x*m_p
    )
    mu_1 = t12*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z)
    mu_2 = t12*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z)
    mu_3 = t12*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z)
    mu_4 = t12*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z)
    mu_5 = t12*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z)
    mu_6 = t12*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z)
    g_4_x = -mu_1*s_1_x - t33
    g_4_y = -mu_1*s_1_y - t41
    g_4_z = -mu_1*s_1_z - t27
    g_5_x = -mu_2*s_2_x - t34
    g_5_y = -mu_2*s_2_y - t42
    g_5_z = -mu_2*s_2_z - t28
    g_6_x = -mu_3*s_3_x - t35
    g_6_y = -mu_3*s_3_y - t43
    g_6_z = -mu_3*s_3_z - t29
    g_7_x = -mu_4*s_4_x - t36
    g_7_y = -mu_4*s_4_y - t44
    g_7_z = -mu_4*s_4_z - t30
    g_8_x = -mu_5*s_5_x - t37
    g_8_y = -mu_5*s_5_y - t45
    g_8_z = -mu_5*s_5_z - t31
    g_9_x = -mu_6*s_6_x - t38
    g_9_y = -mu_6*s_6_y - t46
    g_9_z = -mu_6*s_6_z - t32
    g_10_x = -t39
    g_10_y = -t40
    g_10_z = -t26
    L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6
    t47 = B_1_z*mu_1
    t48 = B_2_z*mu_2
    t49 = B_3_z*mu_3
    t50 = B_4_z*mu_4
    t51 = B_5_z*mu_5
    t52 = B_6_z*mu_6
    L_y_rx = t47 + t48 + t49 + t50 + t51 + t52
    L_x_ry = -L_y_rx
    t53 = B_1_y*mu_1
    t54 = B_2_y*mu_2
    t55 = B_3_y*mu_3
    t56 = B_4_y*mu_4
    t57 = B_5_y*mu_5
    t58 = B_6_y*mu_6
    L_x_rz = t53 + t54 + t55 + t56 + t57 + t58
    t59 = B_1_x*mu_1
    t60 = B_2_x*mu_2
    t61 = B_3_x*mu_3
    t62 = B_4_x*mu_4
    t63 = B_5_x*mu_5
    t64 = B_6_x*mu_6
    L_z_ry = t59 + t60 + t61 + t62 + t63 + t64
    L_y_rz = -L_z_ry
    L_z_rx = -L_x_rz
    t65 = (
        B_1_z**2*mu_1 + B_1_z*g_4_z + B_2_z**2*mu_2 + B_2_z*g_5_z + B_3_z**2*mu_3 + B_3_z*g_6_z
        + B_4_z**2*mu_4 + B_4_z*g_7_z + B_5_z**2*mu_5 + B_5_z*g_8_z + B_6_z**2*mu_6 + B_6_z*g_9_z + c_z*g_10_z
    )
    t66 = (
        B_1_y**2*mu_1 + B_1_y*g_4_y + B_2_y**2*mu_2 + B_2_y*g_5_y + B_3_y**2*mu_3 + B_3_y*g_6_y
        + B_4_y**2*mu_4 + B_4_y*g_7_y + B_5_y**2*mu_5 + B_5_y*g_8_y + B_6_y**2*mu_6 + B_6_y*g_9_y + c_y*g_10_y
    )
    L_rx_rx = -t65 - t66
    t67 = (1/2)*c_x
    t68 = (1/2)*g_10_x
    t69 = (1/2)*B_1_x
    t70 = (1/2)*g_4_x
    t71 = (1/2)*B_2_x
    t72 = (1/2)*g_5_x
    t73 = (1/2)*B_3_x
    t74 = (1/2)*g_6_x
    t75 = (1/2)*B_4_x
    t76 = (1/2)*g_7_x
    t77 = (1/2)*B_5_x
    t78 = (1/2)*g_8_x
    t79 = (1/2)*B_6_x
    t80 = (1/2)*g_9_x
    L_rx_ry = (
        B_1_x*t53 + B_1_y*t70 + B_2_x*t54 + B_2_y*t72 + B_3_x*t55 + B_3_y*t74 + B_4_x*t56 + B_4_y*t76
        + B_5_x*t57 + B_5_y*t78 + B_6_x*t58 + B_6_y*t80 + c_y*t68 + g_10_y*t67 + g_4_y*t69 + g_5_y*t71
        + g_6_y*t73 + g_7_y*t75 + g_8_y*t77 + g_9_y*t79
    )
    L_rx_rz = (
        B_1_x*t47 + B_1_z*t70 + B_2_x*t48 + B_2_z*t72 + B_3_x*t49 + B_3_z*t74 + B_4_x*t50 + B_4_z*t76
        + B_5_x*t51 + B_5_z*t78 + B_6_x*t52 + B_6_z*t80 + c_z*t68 + g_10_z*t67 + g_4_z*t69 + g_5_z*t71
        + g_6_z*t73 + g_7_z*t75 + g_8_z*t77 + g_9_z*t79
    )
    t81 = (
        B_1_x**2*mu_1 + B_1_x*g_4_x + B_2_x**2*mu_2 + B_2_x*g_5_x + B_3_x**2*mu_3 + B_3_x*g_6_x
        + B_4_x**2*mu_4 + B_4_x*g_7_x + B_5_x**2*mu_5 + B_5_x*g_8_x + B_6_x**2*mu_6 + B_6_x*g_9_x + c_x*g_10_x
    )
    L_ry_ry = -t65 - t81
    L_ry_rz = (
        (1/2)*B_1_y*g_4_z + B_1_y*t47 + (1/2)*B_1_z*g_4_y + (1/2)*B_2_y*g_5_z + B_2_y*t48 + (1/2)*B_2_z*g_5_y
        + (1/2)*B_3_y*g_6_z + B_3_y*t49 + (1/2)*B_3_z*g_6_y + (1/2)*B_4_y*g_7_z + B_4_y*t50
        + (1/2)*B_4_z*g_7_y + (1/2)*B_5_y*g_8_z + B_5_y*t51 + (1/2)*B_5_z*g_8_y + (1/2)*B_6_y*g_9_z
        + B_6_y*t52 + (1/2)*B_6_z*g_9_y + (1/2)*c_y*g_10_z + (1/2)*c_z*g_10_y
    )
    L_rz_rz = -t66 - t81
    t82 = mu_1*n_1_x
    f_x_x_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t82
    t83 = mu_2*n_2_x
    f_x_x_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t83
    t84 = mu_3*n_3_x
    f_x_x_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t84
    t85 = mu_4*n_4_x
    f_x_x_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t85
    t86 = mu_5*n_5_x
    f_x_x_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t86
    t87 = mu_6*n_6_x
    f_x_x_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t87
    t88 = mu_1*n_1_y
    f_y_x_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t88
    t89 = mu_2*n_2_y
    f_y_x_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t89
    t90 = mu_3*n_3_y
    f_y_x_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t90
    t91 = mu_4*n_4_y
    f_y_x_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t91
    t92 = mu_5*n_5_y
    f_y_x_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t92
    t93 = mu_6*n_6_y
    f_y_x_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t93
    t94 = mu_1*n_1_z
    f_z_x_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t94
    t95 = mu_2*n_2_z
    f_z_x_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t95
    t96 = mu_3*n_3_z
    f_z_x_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t96
    t97 = mu_4*n_4_z
    f_z_x_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t97
    t98 = mu_5*n_5_z
    f_z_x_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t98
    t99 = mu_6*n_6_z
    f_z_x_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t99
    t100 = -n_1_y*t47 + n_1_z*t53
    f_rx_x_1 = D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx + t100
    t101 = -n_2_y*t48 + n_2_z*t54
    f_rx_x_2 = D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx + t101
    t102 = -n_3_y*t49 + n_3_z*t55
    f_rx_x_3 = D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx + t102
    t103 = -n_4_y*t50 + n_4_z*t56
    f_rx_x_4 = D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx + t103
    t104 = -n_5_y*t51 + n_5_z*t57
    f_rx_x_5 = D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx + t104
    t105 = -n_6_y*t52 + n_6_z*t58
    f_rx_x_6 = D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx + t105
    t106 = n_1_z*t59
    f_ry_x_1 = (
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry + n_1_x*t47
        - t106
    )
    t107 = n_2_z*t60
    f_ry_x_2 = (
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry + n_2_x*t48
        - t107
    )
    t108 = n_3_z*t61
    f_ry_x_3 = (
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry + n_3_x*t49
        - t108
    )
    t109 = n_4_z*t62
    f_ry_x_4 = (
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry + n_4_x*t50
        - t109
    )
    t110 = n_5_z*t63
    f_ry_x_5 = (
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry + n_5_x*t51
        - t110
    )
    t111 = n_6_z*t64
    f_ry_x_6 = (
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry + n_6_x*t52
        - t111
    )
    t112 = -n_1_x*t53 + n_1_y*t59
    f_rz_x_1 = D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz + t112
    t113 = -n_2_x*t54 + n_2_y*t60
    f_rz_x_2 = D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz + t113
    t114 = -n_3_x*t55 + n_3_y*t61
    f_rz_x_3 = D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz + t114
    t115 = -n_4_x*t56 + n_4_y*t62
    f_rz_x_4 = D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz + t115
    t116 = -n_5_x*t57 + n_5_y*t63
    f_rz_x_5 = D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz + t116
    t117 = -n_6_x*t58 + n_6_y*t64
    f_rz_x_6 = D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz + t117
    t118 = B_1_z*mu_1*n_1_x - t106
    t119 = B_2_z*mu_2*n_2_x - t107
    t120 = B_3_z*mu_3*n_3_x - t108
    t121 = B_4_z*mu_4*n_4_x - t109
    t122 = B_5_z*mu_5*n_5_x - t110
    H_g_out = np.empty((*batch, 6, 6), dtype)
    H_g_out[..., 0, 0] = (
        D_p_rx_1*f_rx_x_1 + D_p_rx_1*t100 + D_p_ry_1*f_ry_x_1 + D_p_ry_1*t118 + D_p_rz_1*f_rz_x_1
        + D_p_rz_1*t112 + D_p_x_1*f_x_x_1 + D_p_x_1*t82 + D_p_y_1*f_y_x_1 + D_p_y_1*t88 + D_p_z_1*f_z_x_1
        + D_p_z_1*t94 - mu_1*n_1_x**2 - mu_1*n_1_y**2 - mu_1*n_1_z**2
    )
    H_g_out[..., 0, 1] = H_g_out[..., 1, 0] = (
        D_p_rx_1*f_rx_x_2 + D_p_rx_2*t100 + D_p_ry_1*f_ry_x_2 + D_p_ry_2*t118 + D_p_rz_1*f_rz_x_2
        + D_p_rz_2*t112 + D_p_x_1*f_x_x_2 + D_p_x_2*t82 + D_p_y_1*f_y_x_2 + D_p_y_2*t88 + D_p_z_1*f_z_x_2
        + D_p_z_2*t94
    )
    H_g_out[..., 0, 2] = H_g_out[..., 2, 0] = (
        D_p_rx_1*f_rx_x_3 + D_p_rx_3*t100 + D_p_ry_1*f_ry_x_3 + D_p_ry_3*t118 + D_p_rz_1*f_rz_x_3
        + D_p_rz_3*t112 + D_p_x_1*f_x_x_3 + D_p_x_3*t82 + D_p_y_1*f_y_x_3 + D_p_y_3*t88 + D_p_z_1*f_z_x_3
        + D_p_z_3*t94
    )
    H_g_out[..., 0, 3] = H_g_out[..., 3, 0] = (
        D_p_rx_1*f_rx_x_4 + D_p_rx_4*t100 + D_p_ry_1*f_ry_x_4 + D_p_ry_4*t118 + D_p_rz_1*f_rz_x_4
        + D_p_rz_4*t112 + D_p_x_1*f_x_x_4 + D_p_x_4*t82 + D_p_y_1*f_y_x_4 + D_p_y_4*t88 + D_p_z_1*f_z_x_4
        + D_p_z_4*t94
    )
    H_g_out[..., 0, 4] = H_g_out[..., 4, 0] = (
        D_p_rx_1*f_rx_x_5 + D_p_rx_5*t100 + D_p_ry_1*f_ry_x_5 + D_p_ry_5*t118 + D_p_rz_1*f_rz_x_5
        + D_p_rz_5*t112 + D_p_x_1*f_x_x_5 + D_p_x_5*t82 + D_p_y_1*f_y_x_5 + D_p_y_5*t88 + D_p_z_1*f_z_x_5
        + D_p_z_5*t94
    )
    H_g_out[..., 0, 5] = H_g_out[..., 5, 0] = (
        D_p_rx_1*f_rx_x_6 + D_p_rx_6*t100 + D_p_ry_1*f_ry_x_6 + D_p_ry_6*t118 + D_p_rz_1*f_rz_x_6
        + D_p_rz_6*t112 + D_p_x_1*f_x_x_6 + D_p_x_6*t82 + D_p_y_1*f_y_x_6 + D_p_y_6*t88 + D_p_z_1*f_z_x_6
        + D_p_z_6*t94
    )
    H_g_out[..., 1, 1] = (
        D_p_rx_2*f_rx_x_2 + D_p_rx_2*t101 + D_p_ry_2*f_ry_x_2 + D_p_ry_2*t119 + D_p_rz_2*f_rz_x_2
        + D_p_rz_2*t113 + D_p_x_2*f_x_x_2 + D_p_x_2*t83 + D_p_y_2*f_y_x_2 + D_p_y_2*t89 + D_p_z_2*f_z_x_2
        + D_p_z_2*t95 - mu_2*n_2_x**2 - mu_2*n_2_y**2 - mu_2*n_2_z**2
    )
    H_g_out[..., 1, 2] = H_g_out[..., 2, 1] = (
        D_p_rx_2*f_rx_x_3 + D_p_rx_3*t101 + D_p_ry_2*f_ry_x_3 + D_p_ry_3*t119 + D_p_rz_2*f_rz_x_3
        + D_p_rz_3*t113 + D_p_x_2*f_x_x_3 + D_p_x_3*t83 + D_p_y_2*f_y_x_3 + D_p_y_3*t89 + D_p_z_2*f_z_x_3
        + D_p_z_3*t95
    )
    H_g_out[..., 1, 3] = H_g_out[..., 3, 1] = (
        D_p_rx_2*f_rx_x_4 + D_p_rx_4*t101 + D_p_ry_2*f_ry_x_4 + D_p_ry_4*t119 + D_p_rz_2*f_rz_x_4
        + D_p_rz_4*t113 + D_p_x_2*f_x_x_4 + D_p_x_4*t83 + D_p_y_2*f_y_x_4 + D_p_y_4*t89 + D_p_z_2*f_z_x_4
        + D_p_z_4*t95
    )
    H_g_out[..., 1, 4] = H_g_out[..., 4, 1] = (
        D_p_rx_2*f_rx_x_5 + D_p_rx_5*t101 + D_p_ry_2*f_ry_x_5 + D_p_ry_5*t119 + D_p_rz_2*f_rz_x_5
        + D_p_rz_5*t113 + D_p_x_2*f_x_x_5 + D_p_x_5*t83 + D_p_y_2*f_y_x_5 + D_p_y_5*t89 + D_p_z_2*f_z_x_5
        + D_p_z_5*t95
    )
    H_g_out[..., 1, 5] = H_g_out[..., 5, 1] = (
        D_p_rx_2*f_rx_x_6 + D_p_rx_6*t101 + D_p_ry_2*f_ry_x_6 + D_p_ry_6*t119 + D_p_rz_2*f_rz_x_6
        + D_p_rz_6*t113 + D_p_x_2*f_x_x_6 + D_p_x_6*t83 + D_p_y_2*f_y_x_6 + D_p_y_6*t89 + D_p_z_2*f_z_x_6
        + D_p_z_6*t95
    )
    H_g_out[..., 2, 2] = (
        D_p_rx_3*f_rx_x_3 + D_p_rx_3*t102 + D_p_ry_3*f_ry_x_3 + D_p_ry_3*t120 + D_p_rz_3*f_rz_x_3
        + D_p_rz_3*t114 + D_p_x_3*f_x_x_3 + D_p_x_3*t84 + D_p_y_3*f_y_x_3 + D_p_y_3*t90 + D_p_z_3*f_z_x_3
        + D_p_z_3*t96 - mu_3*n_3_x**2 - mu_3*n_3_y**2 - mu_3*n_3_z**2
    )
    H_g_out[..., 2, 3] = H_g_out[..., 3, 2] = (
        D_p_rx_3*f_rx_x_4 + D_p_rx_4*t102 + D_p_ry_3*f_ry_x_4 + D_p_ry_4*t120 + D_p_rz_3*f_rz_x_4
        + D_p_rz_4*t114 + D_p_x_3*f_x_x_4 + D_p_x_4*t84 + D_p_y_3*f_y_x_4 + D_p_y_4*t90 + D_p_z_3*f_z_x_4
        + D_p_z_4*t96
    )
    H_g_out[..., 2, 4] = H_g_out[..., 4, 2] = (
        D_p_rx_3*f_rx_x_5 + D_p_rx_5*t102 + D_p_ry_3*f_ry_x_5 + D_p_ry_5*t120 + D_p_rz_3*f_rz_x_5
        + D_p_rz_5*t114 + D_p_x_3*f_x_x_5 + D_p_x_5*t84 + D_p_y_3*f_y_x_5 + D_p_y_5*t90 + D_p_z_3*f_z_x_5
        + D_p_z_5*t96
    )
    H_g_out[..., 2, 5] = H_g_out[..., 5, 2] = (
        D_p_rx_3*f_rx_x_6 + D_p_rx_6*t102 + D_p_ry_3*f_ry_x_6 + D_p_ry_6*t120 + D_p_rz_3*f_rz_x_6
        + D_p_rz_6*t114 + D_p_x_3*f_x_x_6 + D_p_x_6*t84 + D_p_y_3*f_y_x_6 + D_p_y_6*t90 + D_p_z_3*f_z_x_6
        + D_p_z_6*t96
    )
    H_g_out[..., 3, 3] = (
        D_p_rx_4*f_rx_x_4 + D_p_rx_4*t103 + D_p_ry_4*f_ry_x_4 + D_p_ry_4*t121 + D_p_rz_4*f_rz_x_4
        + D_p_rz_4*t115 + D_p_x_4*f_x_x_4 + D_p_x_4*t85 + D_p_y_4*f_y_x_4 + D_p_y_4*t91 + D_p_z_4*f_z_x_4
        + D_p_z_4*t97 - mu_4*n_4_x**2 - mu_4*n_4_y**2 - mu_4*n_4_z**2
    )
    H_g_out[..., 3, 4] = H_g_out[..., 4, 3] = (
        D_p_rx_4*f_rx_x_5 + D_p_rx_5*t103 + D_p_ry_4*f_ry_x_5 + D_p_ry_5*t121 + D_p_rz_4*f_rz_x_5
        + D_p_rz_5*t115 + D_p_x_4*f_x_x_5 + D_p_x_5*t85 + D_p_y_4*f_y_x_5 + D_p_y_5*t91 + D_p_z_4*f_z_x_5
        + D_p_z_5*t97
    )
    H_g_out[..., 3, 5] = H_g_out[..., 5, 3] = (
        D_p_rx_4*f_rx_x_6 + D_p_rx_6*t103 + D_p_ry_4*f_ry_x_6 + D_p_ry_6*t121 + D_p_rz_4*f_rz_x_6
        + D_p_rz_6*t115 + D_p_x_4*f_x_x_6 + D_p_x_6*t85 + D_p_y_4*f_y_x_6 + D_p_y_6*t91 + D_p_z_4*f_z_x_6
        + D_p_z_6*t97
    )
    H_g_out[..., 4, 4] = (
        D_p_rx_5*f_rx_x_5 + D_p_rx_5*t104 + D_p_ry_5*f_ry_x_5 + D_p_ry_5*t122 + D_p_rz_5*f_rz_x_5
        + D_p_rz_5*t116 + D_p_x_5*f_x_x_5 + D_p_x_5*t86 + D_p_y_5*f_y_x_5 + D_p_y_5*t92 + D_p_z_5*f_z_x_5
        + D_p_z_5*t98 - mu_5*n_5_x**2 - mu_5*n_5_y**2 - mu_5*n_5_z**2
    )
    H_g_out[..., 4, 5] = H_g_out[..., 5, 4] = (
        D_p_rx_5*f_rx_x_6 + D_p_rx_6*t104 + D_p_ry_5*f_ry_x_6 + D_p_ry_6*t122 + D_p_rz_5*f_rz_x_6
        + D_p_rz_6*t116 + D_p_x_5*f_x_x_6 + D_p_x_6*t86 + D_p_y_5*f_y_x_6 + D_p_y_6*t92 + D_p_z_5*f_z_x_6
        + D_p_z_6*t98
    )
    H_g_out[..., 5, 5] = (
        D_p_rx_6*f_rx_x_6 + D_p_rx_6*t105 + D_p_ry_6*f_ry_x_6 + D_p_ry_6*(B_6_z*mu_6*n_6_x - t111)
        + D_p_rz_6*f_rz_x_6 + D_p_rz_6*t117 + D_p_x_6*f_x_x_6 + D_p_x_6*t87 + D_p_y_6*f_y_x_6 + D_p_y_6*t93
        + D_p_z_6*f_z_x_6 + D_p_z_6*t99 - mu_6*n_6_x**2 - mu_6*n_6_y**2 - mu_6*n_6_z**2
    )
    return H_g_out


def belt_stiffness(p, parameters):
    """Stiffnesses of the belt spans.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    k : array, shape (..., 6, 3) [N/m]
        k[j-1, s-1] of span s of belt j, as in `belt_spans`.

    Notes
    -----
    Equations 34 to 37.
    366 operations; 27342 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    k_sp_1, k_sp_2, k_sp_3, k_sp_4, k_sp_5, k_sp_6 = _entries(parameters.belt_specific_stiffness, (6,))
    w_b_1, w_b_2, w_b_3, w_b_4, w_b_5, w_b_6 = _entries(parameters.belt_width, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, x_min_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    l_f_1_1 = x_max_1 - x_min_1
    t12 = k_sp_1*w_b_1
    k_1_1 = t12/l_f_1_1
    t13 = (1/2)*l_t_1
    l_f_1_2 = -t13 + x_1 - x_min_1
    k_1_2 = t12/l_f_1_2
    l_f_1_3 = -t13 - x_1 + x_max_1
    k_1_3 = t12/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t14 = k_sp_2*w_b_2
    k_2_1 = t14/l_f_2_1
    t15 = (1/2)*l_t_2
    l_f_2_2 = -t15 + x_2 - x_min_2
    k_2_2 = t14/l_f_2_2
    l_f_2_3 = -t15 - x_2 + x_max_2
    k_2_3 = t14/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t16 = k_sp_3*w_b_3
    k_3_1 = t16/l_f_3_1
    t17 = (1/2)*l_t_3
    l_f_3_2 = -t17 + x_3 - x_min_3
    k_3_2 = t16/l_f_3_2
    l_f_3_3 = -t17 - x_3 + x_max_3
    k_3_3 = t16/l_f_3_3
    l_f_4_1 = x_max_4 - x_min_4
    t18 = k_sp_4*w_b_4
    k_4_1 = t18/l_f_4_1
    t19 = (1/2)*l_t_4
    l_f_4_2 = -t19 + x_4 - x_min_4
    k_4_2 = t18/l_f_4_2
    l_f_4_3 = -t19 - x_4 + x_max_4
    k_4_3 = t18/l_f_4_3
    l_f_5_1 = x_max_5 - x_min_5
    t20 = k_sp_5*w_b_5
    k_5_1 = t20/l_f_5_1
    t21 = (1/2)*l_t_5
    l_f_5_2 = -t21 + x_5 - x_min_5
    k_5_2 = t20/l_f_5_2
    l_f_5_3 = -t21 - x_5 + x_max_5
    k_5_3 = t20/l_f_5_3
    l_f_6_1 = x_max_6 - x_min_6
    t22 = k_sp_6*w_b_6
    k_6_1 = t22/l_f_6_1
    t23 = (1/2)*l_t_6
    l_f_6_2 = -t23 + x_6 - x_min_6
    k_6_2 = t22/l_f_6_2
    l_f_6_3 = -t23 - x_6 + x_max_6
    k_6_3 = t22/l_f_6_3
    k_out = np.empty((*batch, 6, 3), dtype)
    k_out[..., 0, 0] = k_1_1
    k_out[..., 0, 1] = k_1_2
    k_out[..., 0, 2] = k_1_3
    k_out[..., 1, 0] = k_2_1
    k_out[..., 1, 1] = k_2_2
    k_out[..., 1, 2] = k_2_3
    k_out[..., 2, 0] = k_3_1
    k_out[..., 2, 1] = k_3_2
    k_out[..., 2, 2] = k_3_3
    k_out[..., 3, 0] = k_4_1
    k_out[..., 3, 1] = k_4_2
    k_out[..., 3, 2] = k_4_3
    k_out[..., 4, 0] = k_5_1
    k_out[..., 4, 1] = k_5_2
    k_out[..., 4, 2] = k_5_3
    k_out[..., 5, 0] = k_6_1
    k_out[..., 5, 1] = k_6_2
    k_out[..., 5, 2] = k_6_3
    return k_out


def elastic_potential(p, delta_q, parameters):
    """Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    delta_q : array, shape (..., 18) [m, rad]
        Small displacements of the 18 generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    V_el : array, shape (...) [J]
        Zero in the reference configuration.

    Notes
    -----
    Equation 38, summed.
    467 operations; 27455 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        delta_x_1, delta_x_2, delta_x_3, delta_x_4, delta_x_5, delta_x_6, delta_theta_1_1, delta_theta_2_1,
        delta_theta_3_1, delta_theta_4_1, delta_theta_5_1, delta_theta_6_1, delta_theta_1_2, delta_theta_2_2,
        delta_theta_3_2, delta_theta_4_2, delta_theta_5_2, delta_theta_6_2,
    ) = _entries(delta_q, (18,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    k_sp_1, k_sp_2, k_sp_3, k_sp_4, k_sp_5, k_sp_6 = _entries(parameters.belt_specific_stiffness, (6,))
    w_b_1, w_b_2, w_b_3, w_b_4, w_b_5, w_b_6 = _entries(parameters.belt_width, (6,))
    R_p_1, R_p_2, R_p_3, R_p_4, R_p_5, R_p_6 = _entries(parameters.pulley_radius, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, delta_x_1, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, x_min_1,
        sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    l_f_1_1 = x_max_1 - x_min_1
    t12 = k_sp_1*w_b_1
    k_1_1 = t12/l_f_1_1
    t13 = (1/2)*l_t_1
    l_f_1_2 = -t13 + x_1 - x_min_1
    k_1_2 = t12/l_f_1_2
    l_f_1_3 = -t13 - x_1 + x_max_1
    k_1_3 = t12/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t14 = k_sp_2*w_b_2
    k_2_1 = t14/l_f_2_1
    t15 = (1/2)*l_t_2
    l_f_2_2 = -t15 + x_2 - x_min_2
    k_2_2 = t14/l_f_2_2
    l_f_2_3 = -t15 - x_2 + x_max_2
    k_2_3 = t14/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t16 = k_sp_3*w_b_3
    k_3_1 = t16/l_f_3_1
    t17 = (1/2)*l_t_3
    l_f_3_2 = -t17 + x_3 - x_min_3
    k_3_2 = t16/l_f_3_2
    l_f_3_3 = -t17 - x_3 + x_max_3
    k_3_3 = t16/l_f_3_3
    l_f_4_1 = x_max_4 - x_min_4
    t18 = k_sp_4*w_b_4
    k_4_1 = t18/l_f_4_1
    t19 = (1/2)*l_t_4
    l_f_4_2 = -t19 + x_4 - x_min_4
    k_4_2 = t18/l_f_4_2
    l_f_4_3 = -t19 - x_4 + x_max_4
    k_4_3 = t18/l_f_4_3
    l_f_5_1 = x_max_5 - x_min_5
    t20 = k_sp_5*w_b_5
    k_5_1 = t20/l_f_5_1
    t21 = (1/2)*l_t_5
    l_f_5_2 = -t21 + x_5 - x_min_5
    k_5_2 = t20/l_f_5_2
    l_f_5_3 = -t21 - x_5 + x_max_5
    k_5_3 = t20/l_f_5_3
    l_f_6_1 = x_max_6 - x_min_6
    t22 = k_sp_6*w_b_6
    k_6_1 = t22/l_f_6_1
    t23 = (1/2)*l_t_6
    l_f_6_2 = -t23 + x_6 - x_min_6
    k_6_2 = t22/l_f_6_2
    l_f_6_3 = -t23 - x_6 + x_max_6
    k_6_3 = t22/l_f_6_3
    t24 = R_p_1*delta_theta_1_2
    t25 = R_p_2*delta_theta_2_2
    t26 = R_p_3*delta_theta_3_2
    t27 = R_p_4*delta_theta_4_2
    t28 = R_p_5*delta_theta_5_2
    t29 = R_p_6*delta_theta_6_2
    t30 = R_p_1*delta_theta_1_1
    t31 = R_p_2*delta_theta_2_1
    t32 = R_p_3*delta_theta_3_1
    t33 = R_p_4*delta_theta_4_1
    t34 = R_p_5*delta_theta_5_1
    t35 = R_p_6*delta_theta_6_1
    V_el_out = np.empty(batch, dtype)
    V_el_out[...] = (
        (1/2)*k_1_1*(t24 - t30)**2 + (1/2)*k_1_2*(delta_x_1 - t24)**2 + (1/2)*k_1_3*(-delta_x_1 + t30)**2
        + (1/2)*k_2_1*(t25 - t31)**2 + (1/2)*k_2_2*(delta_x_2 - t25)**2 + (1/2)*k_2_3*(-delta_x_2 + t31)**2
        + (1/2)*k_3_1*(t26 - t32)**2 + (1/2)*k_3_2*(delta_x_3 - t26)**2 + (1/2)*k_3_3*(-delta_x_3 + t32)**2
        + (1/2)*k_4_1*(t27 - t33)**2 + (1/2)*k_4_2*(delta_x_4 - t27)**2 + (1/2)*k_4_3*(-delta_x_4 + t33)**2
        + (1/2)*k_5_1*(t28 - t34)**2 + (1/2)*k_5_2*(delta_x_5 - t28)**2 + (1/2)*k_5_3*(-delta_x_5 + t34)**2
        + (1/2)*k_6_1*(t29 - t35)**2 + (1/2)*k_6_2*(delta_x_6 - t29)**2 + (1/2)*k_6_3*(-delta_x_6 + t35)**2
    )
    return V_el_out[()]


def elastic_gradient(p, delta_q, parameters):
    """Gradient of the elastic potential energy.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    delta_q : array, shape (..., 18) [m, rad]
        Small displacements of the 18 generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    E : array, shape (..., 18) [N, N m]
        dV_el/dq.

    Notes
    -----
    Equation 38 differentiated.
    522 operations; 54882 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        delta_x_1, delta_x_2, delta_x_3, delta_x_4, delta_x_5, delta_x_6, delta_theta_1_1, delta_theta_2_1,
        delta_theta_3_1, delta_theta_4_1, delta_theta_5_1, delta_theta_6_1, delta_theta_1_2, delta_theta_2_2,
        delta_theta_3_2, delta_theta_4_2, delta_theta_5_2, delta_theta_6_2,
    ) = _entries(delta_q, (18,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    k_sp_1, k_sp_2, k_sp_3, k_sp_4, k_sp_5, k_sp_6 = _entries(parameters.belt_specific_stiffness, (6,))
    w_b_1, w_b_2, w_b_3, w_b_4, w_b_5, w_b_6 = _entries(parameters.belt_width, (6,))
    R_p_1, R_p_2, R_p_3, R_p_4, R_p_5, R_p_6 = _entries(parameters.pulley_radius, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, delta_x_1, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, x_min_1,
        sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    l_f_1_1 = x_max_1 - x_min_1
    t12 = k_sp_1*w_b_1
    k_1_1 = t12/l_f_1_1
    t13 = (1/2)*l_t_1
    l_f_1_2 = -t13 + x_1 - x_min_1
    k_1_2 = t12/l_f_1_2
    l_f_1_3 = -t13 - x_1 + x_max_1
    k_1_3 = t12/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t14 = k_sp_2*w_b_2
    k_2_1 = t14/l_f_2_1
    t15 = (1/2)*l_t_2
    l_f_2_2 = -t15 + x_2 - x_min_2
    k_2_2 = t14/l_f_2_2
    l_f_2_3 = -t15 - x_2 + x_max_2
    k_2_3 = t14/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t16 = k_sp_3*w_b_3
    k_3_1 = t16/l_f_3_1
    t17 = (1/2)*l_t_3
    l_f_3_2 = -t17 + x_3 - x_min_3
    k_3_2 = t16/l_f_3_2
    l_f_3_3 = -t17 - x_3 + x_max_3
    k_3_3 = t16/l_f_3_3
    l_f_4_1 = x_max_4 - x_min_4
    t18 = k_sp_4*w_b_4
    k_4_1 = t18/l_f_4_1
    t19 = (1/2)*l_t_4
    l_f_4_2 = -t19 + x_4 - x_min_4
    k_4_2 = t18/l_f_4_2
    l_f_4_3 = -t19 - x_4 + x_max_4
    k_4_3 = t18/l_f_4_3
    l_f_5_1 = x_max_5 - x_min_5
    t20 = k_sp_5*w_b_5
    k_5_1 = t20/l_f_5_1
    t21 = (1/2)*l_t_5
    l_f_5_2 = -t21 + x_5 - x_min_5
    k_5_2 = t20/l_f_5_2
    l_f_5_3 = -t21 - x_5 + x_max_5
    k_5_3 = t20/l_f_5_3
    l_f_6_1 = x_max_6 - x_min_6
    t22 = k_sp_6*w_b_6
    k_6_1 = t22/l_f_6_1
    t23 = (1/2)*l_t_6
    l_f_6_2 = -t23 + x_6 - x_min_6
    k_6_2 = t22/l_f_6_2
    l_f_6_3 = -t23 - x_6 + x_max_6
    k_6_3 = t22/l_f_6_3
    t24 = -2*delta_x_1
    t25 = R_p_1*delta_theta_1_2
    t26 = R_p_1*delta_theta_1_1
    t27 = -2*delta_x_2
    t28 = R_p_2*delta_theta_2_2
    t29 = R_p_2*delta_theta_2_1
    t30 = -2*delta_x_3
    t31 = R_p_3*delta_theta_3_2
    t32 = R_p_3*delta_theta_3_1
    t33 = -2*delta_x_4
    t34 = R_p_4*delta_theta_4_2
    t35 = R_p_4*delta_theta_4_1
    t36 = -2*delta_x_5
    t37 = R_p_5*delta_theta_5_2
    t38 = R_p_5*delta_theta_5_1
    t39 = -2*delta_x_6
    t40 = R_p_6*delta_theta_6_2
    t41 = R_p_6*delta_theta_6_1
    t42 = R_p_1*k_1_1*(t25 - t26)
    t43 = R_p_2*k_2_1*(t28 - t29)
    t44 = R_p_3*k_3_1*(t31 - t32)
    t45 = R_p_4*k_4_1*(t34 - t35)
    t46 = R_p_5*k_5_1*(t37 - t38)
    t47 = R_p_6*k_6_1*(t40 - t41)
    E_out = np.empty((*batch, 18), dtype)
    E_out[..., 0] = (1/2)*k_1_2*(-t24 - 2*t25) + (1/2)*k_1_3*(-t24 - 2*t26)
    E_out[..., 1] = (1/2)*k_2_2*(-t27 - 2*t28) + (1/2)*k_2_3*(-t27 - 2*t29)
    E_out[..., 2] = (1/2)*k_3_2*(-t30 - 2*t31) + (1/2)*k_3_3*(-t30 - 2*t32)
    E_out[..., 3] = (1/2)*k_4_2*(-t33 - 2*t34) + (1/2)*k_4_3*(-t33 - 2*t35)
    E_out[..., 4] = (1/2)*k_5_2*(-t36 - 2*t37) + (1/2)*k_5_3*(-t36 - 2*t38)
    E_out[..., 5] = (1/2)*k_6_2*(-t39 - 2*t40) + (1/2)*k_6_3*(-t39 - 2*t41)
    E_out[..., 6] = R_p_1*k_1_3*(-delta_x_1 + t26) - t42
    E_out[..., 7] = R_p_2*k_2_3*(-delta_x_2 + t29) - t43
    E_out[..., 8] = R_p_3*k_3_3*(-delta_x_3 + t32) - t44
    E_out[..., 9] = R_p_4*k_4_3*(-delta_x_4 + t35) - t45
    E_out[..., 10] = R_p_5*k_5_3*(-delta_x_5 + t38) - t46
    E_out[..., 11] = R_p_6*k_6_3*(-delta_x_6 + t41) - t47
    E_out[..., 12] = -R_p_1*k_1_2*(delta_x_1 - t25) + t42
    E_out[..., 13] = -R_p_2*k_2_2*(delta_x_2 - t28) + t43
    E_out[..., 14] = -R_p_3*k_3_2*(delta_x_3 - t31) + t44
    E_out[..., 15] = -R_p_4*k_4_2*(delta_x_4 - t34) + t45
    E_out[..., 16] = -R_p_5*k_5_2*(delta_x_5 - t37) + t46
    E_out[..., 17] = -R_p_6*k_6_2*(delta_x_6 - t40) + t47
    return E_out


def elastic_hessian(p, parameters):
    """Hessian of the elastic potential energy.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    H_el : array, shape (..., 18, 18) [N/m, N, N m]
        d2V_el/dq2, symmetric, with six zero eigenvalues.

    Notes
    -----
    Equation 38 differentiated twice.
    438 operations; 109518 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    k_sp_1, k_sp_2, k_sp_3, k_sp_4, k_sp_5, k_sp_6 = _entries(parameters.belt_specific_stiffness, (6,))
    w_b_1, w_b_2, w_b_3, w_b_4, w_b_5, w_b_6 = _entries(parameters.belt_width, (6,))
    R_p_1, R_p_2, R_p_3, R_p_4, R_p_5, R_p_6 = _entries(parameters.pulley_radius, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, x_min_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    l_f_1_1 = x_max_1 - x_min_1
    t12 = k_sp_1*w_b_1
    k_1_1 = t12/l_f_1_1
    t13 = (1/2)*l_t_1
    l_f_1_2 = -t13 + x_1 - x_min_1
    k_1_2 = t12/l_f_1_2
    l_f_1_3 = -t13 - x_1 + x_max_1
    k_1_3 = t12/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t14 = k_sp_2*w_b_2
    k_2_1 = t14/l_f_2_1
    t15 = (1/2)*l_t_2
    l_f_2_2 = -t15 + x_2 - x_min_2
    k_2_2 = t14/l_f_2_2
    l_f_2_3 = -t15 - x_2 + x_max_2
    k_2_3 = t14/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t16 = k_sp_3*w_b_3
    k_3_1 = t16/l_f_3_1
    t17 = (1/2)*l_t_3
    l_f_3_2 = -t17 + x_3 - x_min_3
    k_3_2 = t16/l_f_3_2
    l_f_3_3 = -t17 - x_3 + x_max_3
    k_3_3 = t16/l_f_3_3
    l_f_4_1 = x_max_4 - x_min_4
    t18 = k_sp_4*w_b_4
    k_4_1 = t18/l_f_4_1
    t19 = (1/2)*l_t_4
    l_f_4_2 = -t19 + x_4 - x_min_4
    k_4_2 = t18/l_f_4_2
    l_f_4_3 = -t19 - x_4 + x_max_4
    k_4_3 = t18/l_f_4_3
    l_f_5_1 = x_max_5 - x_min_5
    t20 = k_sp_5*w_b_5
    k_5_1 = t20/l_f_5_1
    t21 = (1/2)*l_t_5
    l_f_5_2 = -t21 + x_5 - x_min_5
    k_5_2 = t20/l_f_5_2
    l_f_5_3 = -t21 - x_5 + x_max_5
    k_5_3 = t20/l_f_5_3
    l_f_6_1 = x_max_6 - x_min_6
    t22 = k_sp_6*w_b_6
    k_6_1 = t22/l_f_6_1
    t23 = (1/2)*l_t_6
    l_f_6_2 = -t23 + x_6 - x_min_6
    k_6_2 = t22/l_f_6_2
    l_f_6_3 = -t23 - x_6 + x_max_6
    k_6_3 = t22/l_f_6_3
    t24 = R_p_1**2
    t25 = k_1_1*t24
    t26 = R_p_2**2
    t27 = k_2_1*t26
    t28 = R_p_3**2
    t29 = k_3_1*t28
    t30 = R_p_4**2
    t31 = k_4_1*t30
    t32 = R_p_5**2
    t33 = k_5_1*t32
    t34 = R_p_6**2
    t35 = k_6_1*t34
    H_el_out = np.zeros((*batch, 18, 18), dtype)
    H_el_out[..., 0, 0] = k_1_2 + k_1_3
    H_el_out[..., 0, 6] = H_el_out[..., 6, 0] = -R_p_1*k_1_3
    H_el_out[..., 0, 12] = H_el_out[..., 12, 0] = -R_p_1*k_1_2
    H_el_out[..., 1, 1] = k_2_2 + k_2_3
    H_el_out[..., 1, 7] = H_el_out[..., 7, 1] = -R_p_2*k_2_3
    H_el_out[..., 1, 13] = H_el_out[..., 13, 1] = -R_p_2*k_2_2
    H_el_out[..., 2, 2] = k_3_2 + k_3_3
    H_el_out[..., 2, 8] = H_el_out[..., 8, 2] = -R_p_3*k_3_3
    H_el_out[..., 2, 14] = H_el_out[..., 14, 2] = -R_p_3*k_3_2
    H_el_out[..., 3, 3] = k_4_2 + k_4_3
    H_el_out[..., 3, 9] = H_el_out[..., 9, 3] = -R_p_4*k_4_3
    H_el_out[..., 3, 15] = H_el_out[..., 15, 3] = -R_p_4*k_4_2
    H_el_out[..., 4, 4] = k_5_2 + k_5_3
    H_el_out[..., 4, 10] = H_el_out[..., 10, 4] = -R_p_5*k_5_3
    H_el_out[..., 4, 16] = H_el_out[..., 16, 4] = -R_p_5*k_5_2
    H_el_out[..., 5, 5] = k_6_2 + k_6_3
    H_el_out[..., 5, 11] = H_el_out[..., 11, 5] = -R_p_6*k_6_3
    H_el_out[..., 5, 17] = H_el_out[..., 17, 5] = -R_p_6*k_6_2
    H_el_out[..., 6, 6] = k_1_3*t24 + t25
    H_el_out[..., 6, 12] = H_el_out[..., 12, 6] = -t25
    H_el_out[..., 7, 7] = k_2_3*t26 + t27
    H_el_out[..., 7, 13] = H_el_out[..., 13, 7] = -t27
    H_el_out[..., 8, 8] = k_3_3*t28 + t29
    H_el_out[..., 8, 14] = H_el_out[..., 14, 8] = -t29
    H_el_out[..., 9, 9] = k_4_3*t30 + t31
    H_el_out[..., 9, 15] = H_el_out[..., 15, 9] = -t31
    H_el_out[..., 10, 10] = k_5_3*t32 + t33
    H_el_out[..., 10, 16] = H_el_out[..., 16, 10] = -t33
    H_el_out[..., 11, 11] = k_6_3*t34 + t35
    H_el_out[..., 11, 17] = H_el_out[..., 17, 11] = -t35
    H_el_out[..., 12, 12] = k_1_2*t24 + t25
    H_el_out[..., 13, 13] = k_2_2*t26 + t27
    H_el_out[..., 14, 14] = k_3_2*t28 + t29
    H_el_out[..., 15, 15] = k_4_2*t30 + t31
    H_el_out[..., 16, 16] = k_5_2*t32 + t33
    H_el_out[..., 17, 17] = k_6_2*t34 + t35
    return H_el_out


def static_equilibrium(p, parameters):
    """Drive torques that hold the pose, and the corresponding rotations.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    tau_st : array, shape (..., 6) [N m]
        Torques on the driven rotors, positive in the direction of their rotation.
    theta_st : array, shape (..., 12) [rad]
        Rotations relative to the unstrained transmissions, in the order of the coordinates.

    Notes
    -----
    Equation 44, solved at the pose.
    2209 operations; 1458941046 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    m_t_1, m_t_2, m_t_3, m_t_4, m_t_5, m_t_6 = _entries(parameters.carriage_mass, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    k_sp_1, k_sp_2, k_sp_3, k_sp_4, k_sp_5, k_sp_6 = _entries(parameters.belt_specific_stiffness, (6,))
    w_b_1, w_b_2, w_b_3, w_b_4, w_b_5, w_b_6 = _entries(parameters.belt_width, (6,))
    R_p_1, R_p_2, R_p_3, R_p_4, R_p_5, R_p_6 = _entries(parameters.pulley_radius, (6,))
    (
        d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2, d_4_1, d_4_2, d_5_1, d_5_2, d_6_1, d_6_2,
    ) = _entries(parameters.drive, (6, 2))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, m_p, c_p_x, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1,
        w_b_1, R_p_1, d_1_1, x_min_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = 1.0/det_D_l
    t13 = D_r_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = D_r_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = D_r_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = D_r_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = D_r_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = D_r_6*t12
    D_p_x_6 = A_x_6*t18
    D_p_y_1 = A_y_1*t13
    D_p_y_2 = A_y_2*t14
    D_p_y_3 = A_y_3*t15
    D_p_y_4 = A_y_4*t16
    D_p_y_5 = A_y_5*t17
    D_p_y_6 = A_y_6*t18
    D_p_z_1 = A_z_1*t13
    D_p_z_2 = A_z_2*t14
    D_p_z_3 = A_z_3*t15
    D_p_z_4 = A_z_4*t16
    D_p_z_5 = A_z_5*t17
    D_p_z_6 = A_z_6*t18
    D_p_rx_1 = A_rx_1*t13
    D_p_rx_2 = A_rx_2*t14
    D_p_rx_3 = A_rx_3*t15
    D_p_rx_4 = A_rx_4*t16
    D_p_rx_5 = A_rx_5*t17
    D_p_rx_6 = A_rx_6*t18
    D_p_ry_1 = A_ry_1*t13
    D_p_ry_2 = A_ry_2*t14
    D_p_ry_3 = A_ry_3*t15
    D_p_ry_4 = A_ry_4*t16
    D_p_ry_5 = A_ry_5*t17
    D_p_ry_6 = A_ry_6*t18
    D_p_rz_1 = A_rz_1*t13
    D_p_rz_2 = A_rz_2*t14
    D_p_rz_3 = A_rz_3*t15
    D_p_rz_4 = A_rz_4*t16
    D_p_rz_5 = A_rz_5*t17
    D_p_rz_6 = A_rz_6*t18
    l_f_1_1 = x_max_1 - x_min_1
    t19 = k_sp_1*w_b_1
    k_1_1 = t19/l_f_1_1
    t20 = (1/2)*l_t_1
    l_f_1_2 = -t20 + x_1 - x_min_1
    k_1_2 = t19/l_f_1_2
    l_f_1_3 = -t20 - x_1 + x_max_1
    k_1_3 = t19/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t21 = k_sp_2*w_b_2
    k_2_1 = t21/l_f_2_1
    t22 = (1/2)*l_t_2
    l_f_2_2 = -t22 + x_2 - x_min_2
    k_2_2 = t21/l_f_2_2
    l_f_2_3 = -t22 - x_2 + x_max_2
    k_2_3 = t21/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t23 = k_sp_3*w_b_3
    k_3_1 = t23/l_f_3_1
    t24 = (1/2)*l_t_3
    l_f_3_2 = -t24 + x_3 - x_min_3
    k_3_2 = t23/l_f_3_2
    l_f_3_3 = -t24 - x_3 + x_max_3
    k_3_3 = t23/l_f_3_3
    l_f_4_1 = x_max_4 - x_min_4
    t25 = k_sp_4*w_b_4
    k_4_1 = t25/l_f_4_1
    t26 = (1/2)*l_t_4
    l_f_4_2 = -t26 + x_4 - x_min_4
    k_4_2 = t25/l_f_4_2
    l_f_4_3 = -t26 - x_4 + x_max_4
    k_4_3 = t25/l_f_4_3
    l_f_5_1 = x_max_5 - x_min_5
    t27 = k_sp_5*w_b_5
    k_5_1 = t27/l_f_5_1
    t28 = (1/2)*l_t_5
    l_f_5_2 = -t28 + x_5 - x_min_5
    k_5_2 = t27/l_f_5_2
    l_f_5_3 = -t28 - x_5 + x_max_5
    k_5_3 = t27/l_f_5_3
    l_f_6_1 = x_max_6 - x_min_6
    t29 = k_sp_6*w_b_6
    k_6_1 = t29/l_f_6_1
    t30 = (1/2)*l_t_6
    l_f_6_2 = -t30 + x_6 - x_min_6
    k_6_2 = t29/l_f_6_2
    l_f_6_3 = -t30 - x_6 + x_max_6
    k_6_3 = t29/l_f_6_3
    t31 = (1/2)*m_d_1
    t32 = (1/2)*m_d_2
    t33 = (1/2)*m_d_3
    t34 = (1/2)*m_d_4
    t35 = (1/2)*m_d_5
    t36 = (1/2)*m_d_6
    t37 = m_p + t31 + t32 + t33 + t34 + t35 + t36
    G_p_x = -g_x*t37
    G_p_y = -g_y*t37
    G_p_z = -g_z*t37
    t38 = g_z*m_p
    t39 = g_z*t31
    t40 = g_z*t32
    t41 = g_z*t33
    t42 = g_z*t34
    t43 = g_z*t35
    t44 = g_z*t36
    G_p_rx = (
        -B_1_y*t39 + (1/2)*B_1_z*g_y*m_d_1 - B_2_y*t40 + (1/2)*B_2_z*g_y*m_d_2 - B_3_y*t41
        + (1/2)*B_3_z*g_y*m_d_3 - B_4_y*t42 + (1/2)*B_4_z*g_y*m_d_4 - B_5_y*t43 + (1/2)*B_5_z*g_y*m_d_5
        - B_6_y*t44 + (1/2)*B_6_z*g_y*m_d_6 - c_y*t38 + c_z*g_y*m_p
    )
    G_p_ry = (
        B_1_x*t39 - B_1_z*g_x*t31 + B_2_x*t40 - B_2_z*g_x*t32 + B_3_x*t41 - B_3_z*g_x*t33 + B_4_x*t42
        - B_4_z*g_x*t34 + B_5_x*t43 - B_5_z*g_x*t35 + B_6_x*t44 - B_6_z*g_x*t36 + c_x*t38 - c_z*g_x*m_p
    )
    G_p_rz = (
        -B_1_x*g_y*t31 + (1/2)*B_1_y*g_x*m_d_1 - B_2_x*g_y*t32 + (1/2)*B_2_y*g_x*m_d_2 - B_3_x*g_y*t33
        + (1/2)*B_3_y*g_x*m_d_3 - B_4_x*g_y*t34 + (1/2)*B_4_y*g_x*m_d_4 - B_5_x*g_y*t35
        + (1/2)*B_5_y*g_x*m_d_5 - B_6_x*g_y*t36 + (1/2)*B_6_y*g_x*m_d_6 - c_x*g_y*m_p + c_y*g_x*m_p
    )
    G_1 = (
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - g_x*(m_t_1*n_1_x + n_1_x*t31) - g_y*(m_t_1*n_1_y + n_1_y*t31) - g_z*(m_t_1*n_1_z + n_1_z*t31)
    )
    G_2 = (
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - g_x*(m_t_2*n_2_x + n_2_x*t32) - g_y*(m_t_2*n_2_y + n_2_y*t32) - g_z*(m_t_2*n_2_z + n_2_z*t32)
    )
    G_3 = (
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - g_x*(m_t_3*n_3_x + n_3_x*t33) - g_y*(m_t_3*n_3_y + n_3_y*t33) - g_z*(m_t_3*n_3_z + n_3_z*t33)
    )
    G_4 = (
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - g_x*(m_t_4*n_4_x + n_4_x*t34) - g_y*(m_t_4*n_4_y + n_4_y*t34) - g_z*(m_t_4*n_4_z + n_4_z*t34)
    )
    G_5 = (
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - g_x*(m_t_5*n_5_x + n_5_x*t35) - g_y*(m_t_5*n_5_y + n_5_y*t35) - g_z*(m_t_5*n_5_z + n_5_z*t35)
    )
    G_6 = (
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - g_x*(m_t_6*n_6_x + n_6_x*t36) - g_y*(m_t_6*n_6_y + n_6_y*t36) - g_z*(m_t_6*n_6_z + n_6_z*t36)
    )
    t45 = R_p_1**2
    t46 = k_1_1*t45
    t47 = k_1_3*t45
    t48 = -d_1_1*t46 + d_1_2*(t46 + t47)
    t49 = k_1_2*t45
    t50 = d_1_1*(t46 + t49) - d_1_2*t46
    det_1 = R_p_1*k_1_2*t48 - R_p_1*k_1_3*t50
    t51 = G_1/det_1
    theta_1_1_st = -t50*t51
    theta_1_2_st = t48*t51
    t52 = R_p_2**2
    t53 = k_2_1*t52
    t54 = k_2_3*t52
    t55 = -d_2_1*t53 + d_2_2*(t53 + t54)
    t56 = k_2_2*t52
    t57 = d_2_1*(t53 + t56) - d_2_2*t53
    det_2 = R_p_2*k_2_2*t55 - R_p_2*k_2_3*t57
    t58 = G_2/det_2
    theta_2_1_st = -t57*t58
    theta_2_2_st = t55*t58
    t59 = R_p_3**2
    t60 = k_3_1*t59
    t61 = k_3_3*t59
    t62 = -d_3_1*t60 + d_3_2*(t60 + t61)
    t63 = k_3_2*t59
    t64 = d_3_1*(t60 + t63) - d_3_2*t60
    det_3 = R_p_3*k_3_2*t62 - R_p_3*k_3_3*t64
    t65 = G_3/det_3
    theta_3_1_st = -t64*t65
    theta_3_2_st = t62*t65
    t66 = R_p_4**2
    t67 = k_4_1*t66
    t68 = k_4_3*t66
    t69 = -d_4_1*t67 + d_4_2*(t67 + t68)
    t70 = k_4_2*t66
    t71 = d_4_1*(t67 + t70) - d_4_2*t67
    det_4 = R_p_4*k_4_2*t69 - R_p_4*k_4_3*t71
    t72 = G_4/det_4
    theta_4_1_st = -t71*t72
    theta_4_2_st = t69*t72
    t73 = R_p_5**2
    t74 = k_5_1*t73
    t75 = k_5_3*t73
    t76 = -d_5_1*t74 + d_5_2*(t74 + t75)
    t77 = k_5_2*t73
    t78 = d_5_1*(t74 + t77) - d_5_2*t74
    det_5 = R_p_5*k_5_2*t76 - R_p_5*k_5_3*t78
    t79 = G_5/det_5
    theta_5_1_st = -t78*t79
    theta_5_2_st = t76*t79
    t80 = R_p_6**2
    t81 = k_6_1*t80
    t82 = k_6_3*t80
    t83 = -d_6_1*t81 + d_6_2*(t81 + t82)
    t84 = k_6_2*t80
    t85 = d_6_1*(t81 + t84) - d_6_2*t81
    det_6 = R_p_6*k_6_2*t83 - R_p_6*k_6_3*t85
    t86 = G_6/det_6
    theta_6_1_st = -t85*t86
    theta_6_2_st = t83*t86
    t87 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st)
    tau_st_1 = d_1_1*(t47*theta_1_1_st - t87) + d_1_2*(t49*theta_1_2_st + t87)
    t88 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st)
    tau_st_2 = d_2_1*(t54*theta_2_1_st - t88) + d_2_2*(t56*theta_2_2_st + t88)
    t89 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st)
    tau_st_3 = d_3_1*(t61*theta_3_1_st - t89) + d_3_2*(t63*theta_3_2_st + t89)
    t90 = R_p_4*k_4_1*(-R_p_4*theta_4_1_st + R_p_4*theta_4_2_st)
    tau_st_4 = d_4_1*(t68*theta_4_1_st - t90) + d_4_2*(t70*theta_4_2_st + t90)
    t91 = R_p_5*k_5_1*(-R_p_5*theta_5_1_st + R_p_5*theta_5_2_st)
    tau_st_5 = d_5_1*(t75*theta_5_1_st - t91) + d_5_2*(t77*theta_5_2_st + t91)
    t92 = R_p_6*k_6_1*(-R_p_6*theta_6_1_st + R_p_6*theta_6_2_st)
    tau_st_6 = d_6_1*(t82*theta_6_1_st - t92) + d_6_2*(t84*theta_6_2_st + t92)
    tau_st_out = np.empty((*batch, 6), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    tau_st_out[..., 2] = tau_st_3
    tau_st_out[..., 3] = tau_st_4
    tau_st_out[..., 4] = tau_st_5
    tau_st_out[..., 5] = tau_st_6
    theta_st_out = np.empty((*batch, 12), dtype)
    theta_st_out[..., 0] = theta_1_1_st
    theta_st_out[..., 1] = theta_2_1_st
    theta_st_out[..., 2] = theta_3_1_st
    theta_st_out[..., 3] = theta_4_1_st
    theta_st_out[..., 4] = theta_5_1_st
    theta_st_out[..., 5] = theta_6_1_st
    theta_st_out[..., 6] = theta_1_2_st
    theta_st_out[..., 7] = theta_2_2_st
    theta_st_out[..., 8] = theta_3_2_st
    theta_st_out[..., 9] = theta_4_2_st
    theta_st_out[..., 10] = theta_5_2_st
    theta_st_out[..., 11] = theta_6_2_st
    return tau_st_out, theta_st_out


def stiffness_matrix(p, parameters):
    """Stiffness matrix K in the 18 generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    K : array, shape (..., 18, 18) [N/m, N, N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equations 46 and 48: K = -H_U.
    3263 operations; 96468845790 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    k_sp_1, k_sp_2, k_sp_3, k_sp_4, k_sp_5, k_sp_6 = _entries(parameters.belt_specific_stiffness, (6,))
    w_b_1, w_b_2, w_b_3, w_b_4, w_b_5, w_b_6 = _entries(parameters.belt_width, (6,))
    R_p_1, R_p_2, R_p_3, R_p_4, R_p_5, R_p_6 = _entries(parameters.pulley_radius, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, m_p, c_p_x, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, x_min_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t12 = 1.0/det_D_l
    t13 = D_r_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = D_r_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = D_r_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = D_r_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = D_r_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = D_r_6*t12
    D_p_x_6 = A_x_6*t18
    D_p_y_1 = A_y_1*t13
    D_p_y_2 = A_y_2*t14
    D_p_y_3 = A_y_3*t15
    D_p_y_4 = A_y_4*t16
    D_p_y_5 = A_y_5*t17
    D_p_y_6 = A_y_6*t18
    D_p_z_1 = A_z_1*t13
    D_p_z_2 = A_z_2*t14
    D_p_z_3 = A_z_3*t15
    D_p_z_4 = A_z_4*t16
    D_p_z_5 = A_z_5*t17
    D_p_z_6 = A_z_6*t18
    D_p_rx_1 = A_rx_1*t13
    D_p_rx_2 = A_rx_2*t14
    D_p_rx_3 = A_rx_3*t15
    D_p_rx_4 = A_rx_4*t16
    D_p_rx_5 = A_rx_5*t17
    D_p_rx_6 = A_rx_6*t18
    D_p_ry_1 = A_ry_1*t13
    D_p_ry_2 = A_ry_2*t14
    D_p_ry_3 = A_ry_3*t15
    D_p_ry_4 = A_ry_4*t16
    D_p_ry_5 = A_ry_5*t17
    D_p_ry_6 = A_ry_6*t18
    D_p_rz_1 = A_rz_1*t13
    D_p_rz_2 = A_rz_2*t14
    D_p_rz_3 = A_rz_3*t15
    D_p_rz_4 = A_rz_4*t16
    D_p_rz_5 = A_rz_5*t17
    D_p_rz_6 = A_rz_6*t18
    l_f_1_1 = x_max_1 - x_min_1
    t19 = k_sp_1*w_b_1
    k_1_1 = t19/l_f_1_1
    t20 = (1/2)*l_t_1
    l_f_1_2 = -t20 + x_1 - x_min_1
    k_1_2 = t19/l_f_1_2
    l_f_1_3 = -t20 - x_1 + x_max_1
    k_1_3 = t19/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t21 = k_sp_2*w_b_2
    k_2_1 = t21/l_f_2_1
    t22 = (1/2)*l_t_2
    l_f_2_2 = -t22 + x_2 - x_min_2
    k_2_2 = t21/l_f_2_2
    l_f_2_3 = -t22 - x_2 + x_max_2
    k_2_3 = t21/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t23 = k_sp_3*w_b_3
    k_3_1 = t23/l_f_3_1
    t24 = (1/2)*l_t_3
    l_f_3_2 = -t24 + x_3 - x_min_3
    k_3_2 = t23/l_f_3_2
    l_f_3_3 = -t24 - x_3 + x_max_3
    k_3_3 = t23/l_f_3_3
    l_f_4_1 = x_max_4 - x_min_4
    t25 = k_sp_4*w_b_4
    k_4_1 = t25/l_f_4_1
    t26 = (1/2)*l_t_4
    l_f_4_2 = -t26 + x_4 - x_min_4
    k_4_2 = t25/l_f_4_2
    l_f_4_3 = -t26 - x_4 + x_max_4
    k_4_3 = t25/l_f_4_3
    l_f_5_1 = x_max_5 - x_min_5
    t27 = k_sp_5*w_b_5
    k_5_1 = t27/l_f_5_1
    t28 = (1/2)*l_t_5
    l_f_5_2 = -t28 + x_5 - x_min_5
    k_5_2 = t27/l_f_5_2
    l_f_5_3 = -t28 - x_5 + x_max_5
    k_5_3 = t27/l_f_5_3
    l_f_6_1 = x_max_6 - x_min_6
    t29 = k_sp_6*w_b_6
    k_6_1 = t29/l_f_6_1
    t30 = (1/2)*l_t_6
    l_f_6_2 = -t30 + x_6 - x_min_6
    k_6_2 = t29/l_f_6_2
    l_f_6_3 = -t30 - x_6 + x_max_6
    k_6_3 = t29/l_f_6_3
    t31 = (1/2)*m_d_1
    t32 = (1/2)*m_d_2
    t33 = (1/2)*m_d_3
    t34 = (1/2)*m_d_4
    t35 = (1/2)*m_d_5
    t36 = (1/2)*m_d_6
    t37 = m_p + t31 + t32 + t33 + t34 + t35 + t36
    G_p_x = -g_x*t37
    G_p_y = -g_y*t37
    G_p_z = -g_z*t37
    t38 = g_z*m_p
    t39 = g_z*t31
    t40 = g_z*t32
    t41 = g_z*t33
    t42 = g_z*t34
    t43 = g_z*t35
    t44 = g_z*t36
    G_p_rx = (
        -B_1_y*t39 + (1/2)*B_1_z*g_y*m_d_1 - B_2_y*t40 + (1/2)*B_2_z*g_y*m_d_2 - B_3_y*t41
        + (1/2)*B_3_z*g_y*m_d_3 - B_4_y*t42 + (1/2)*B_4_z*g_y*m_d_4 - B_5_y*t43 + (1/2)*B_5_z*g_y*m_d_5
        - B_6_y*t44 + (1/2)*B_6_z*g_y*m_d_6 - c_y*t38 + c_z*g_y*m_p
    )
    t45 = g_x*t31
    t46 = g_x*t32
    t47 = g_x*t33
    t48 = g_x*t34
    t49 = g_x*t35
    t50 = g_x*t36
    t51 = g_x*m_p
    G_p_ry = (
        B_1_x*t39 - B_1_z*t45 + B_2_x*t40 - B_2_z*t46 + B_3_x*t41 - B_3_z*t47 + B_4_x*t42 - B_4_z*t48
        + B_5_x*t43 - B_5_z*t49 + B_6_x*t44 - B_6_z*t50 + c_x*t38 - c_z*t51
    )
    t52 = g_y*m_p
    t53 = g_y*t31
    t54 = g_y*t32
    t55 = g_y*t33
    t56 = g_y*t34
    t57 = g_y*t35
    t58 = g_y*t36
    G_p_rz = (
        -B_1_x*t53 + (1/2)*B_1_y*g_x*m_d_1 - B_2_x*t54 + (1/2)*B_2_y*g_x*m_d_2 - B_3_x*t55
        + (1/2)*B_3_y*g_x*m_d_3 - B_4_x*t56 + (1/2)*B_4_y*g_x*m_d_4 - B_5_x*t57 + (1/2)*B_5_y*g_x*m_d_5
        - B_6_x*t58 + (1/2)*B_6_y*g_x*m_d_6 - c_x*t52 + c_y*g_x*m_p
    )
    mu_1 = t12*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z)
    mu_2 = t12*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z)
    mu_3 = t12*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z)
    mu_4 = t12*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z)
    mu_5 = t12*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z)
    mu_6 = t12*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z)
    g_4_x = -mu_1*s_1_x - t45
    g_4_y = -mu_1*s_1_y - t53
    g_4_z = -mu_1*s_1_z - t39
    g_5_x = -mu_2*s_2_x - t46
    g_5_y = -mu_2*s_2_y - t54
    g_5_z = -mu_2*s_2_z - t40
    g_6_x = -mu_3*s_3_x - t47
    g_6_y = -mu_3*s_3_y - t55
    g_6_z = -mu_3*s_3_z - t41
    g_7_x = -mu_4*s_4_x - t48
    g_7_y = -mu_4*s_4_y - t56
    g_7_z = -mu_4*s_4_z - t42
    g_8_x = -mu_5*s_5_x - t49
    g_8_y = -mu_5*s_5_y - t57
    g_8_z = -mu_5*s_5_z - t43
    g_9_x = -mu_6*s_6_x - t50
    g_9_y = -mu_6*s_6_y - t58
    g_9_z = -mu_6*s_6_z - t44
    g_10_x = -t51
    g_10_y = -t52
    g_10_z = -t38
    L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6
    t59 = B_1_z*mu_1
    t60 = B_2_z*mu_2
    t61 = B_3_z*mu_3
    t62 = B_4_z*mu_4
    t63 = B_5_z*mu_5
    t64 = B_6_z*mu_6
    L_y_rx = t59 + t60 + t61 + t62 + t63 + t64
    L_x_ry = -L_y_rx
    t65 = B_1_y*mu_1
    t66 = B_2_y*mu_2
    t67 = B_3_y*mu_3
    t68 = B_4_y*mu_4
    t69 = B_5_y*mu_5
    t70 = B_6_y*mu_6
    L_x_rz = t65 + t66 + t67 + t68 + t69 + t70
    t71 = B_1_x*mu_1
    t72 = B_2_x*mu_2
    t73 = B_3_x*mu_3
    t74 = B_4_x*mu_4
    t75 = B_5_x*mu_5
    t76 = B_6_x*mu_6
    L_z_ry = t71 + t72 + t73 + t74 + t75 + t76
    L_y_rz = -L_z_ry
    L_z_rx = -L_x_rz
    t77 = (
        B_1_z**2*mu_1 + B_1_z*g_4_z + B_2_z**2*mu_2 + B_2_z*g_5_z + B_3_z**2*mu_3 + B_3_z*g_6_z
        + B_4_z**2*mu_4 + B_4_z*g_7_z + B_5_z**2*mu_5 + B_5_z*g_8_z + B_6_z**2*mu_6 + B_6_z*g_9_z + c_z*g_10_z
    )
    t78 = (
        B_1_y**2*mu_1 + B_1_y*g_4_y + B_2_y**2*mu_2 + B_2_y*g_5_y + B_3_y**2*mu_3 + B_3_y*g_6_y
        + B_4_y**2*mu_4 + B_4_y*g_7_y + B_5_y**2*mu_5 + B_5_y*g_8_y + B_6_y**2*mu_6 + B_6_y*g_9_y + c_y*g_10_y
    )
    L_rx_rx = -t77 - t78
    t79 = (1/2)*B_1_x
    t80 = (1/2)*g_4_x
    t81 = (1/2)*B_2_x
    t82 = (1/2)*g_5_x
    t83 = (1/2)*B_3_x
    t84 = (1/2)*g_6_x
    t85 = (1/2)*B_4_x
    t86 = (1/2)*g_7_x
    t87 = (1/2)*B_5_x
    t88 = (1/2)*g_8_x
    t89 = (1/2)*B_6_x
    t90 = (1/2)*g_9_x
    t91 = (1/2)*c_x
    t92 = (1/2)*g_10_x
    L_rx_ry = (
        B_1_x*t65 + B_1_y*t80 + B_2_x*t66 + B_2_y*t82 + B_3_x*t67 + B_3_y*t84 + B_4_x*t68 + B_4_y*t86
        + B_5_x*t69 + B_5_y*t88 + B_6_x*t70 + B_6_y*t90 + c_y*t92 + g_10_y*t91 + g_4_y*t79 + g_5_y*t81
        + g_6_y*t83 + g_7_y*t85 + g_8_y*t87 + g_9_y*t89
    )
    L_rx_rz = (
        B_1_x*t59 + B_1_z*t80 + B_2_x*t60 + B_2_z*t82 + B_3_x*t61 + B_3_z*t84 + B_4_x*t62 + B_4_z*t86
        + B_5_x*t63 + B_5_z*t88 + B_6_x*t64 + B_6_z*t90 + c_z*t92 + g_10_z*t91 + g_4_z*t79 + g_5_z*t81
        + g_6_z*t83 + g_7_z*t85 + g_8_z*t87 + g_9_z*t89
    )
    t93 = (
        B_1_x**2*mu_1 + B_1_x*g_4_x + B_2_x**2*mu_2 + B_2_x*g_5_x + B_3_x**2*mu_3 + B_3_x*g_6_x
        + B_4_x**2*mu_4 + B_4_x*g_7_x + B_5_x**2*mu_5 + B_5_x*g_8_x + B_6_x**2*mu_6 + B_6_x*g_9_x + c_x*g_10_x
    )
    L_ry_ry = -t77 - t93
    L_ry_rz = (
        (1/2)*B_1_y*g_4_z + B_1_y*t59 + (1/2)*B_1_z*g_4_y + (1/2)*B_2_y*g_5_z + B_2_y*t60 + (1/2)*B_2_z*g_5_y
        + (1/2)*B_3_y*g_6_z + B_3_y*t61 + (1/2)*B_3_z*g_6_y + (1/2)*B_4_y*g_7_z + B_4_y*t62
        + (1/2)*B_4_z*g_7_y + (1/2)*B_5_y*g_8_z + B_5_y*t63 + (1/2)*B_5_z*g_8_y + (1/2)*B_6_y*g_9_z
        + B_6_y*t64 + (1/2)*B_6_z*g_9_y + (1/2)*c_y*g_10_z + (1/2)*c_z*g_10_y
    )
    L_rz_rz = -t78 - t93
    t94 = mu_1*n_1_x
    f_x_x_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t94
    t95 = mu_2*n_2_x
    f_x_x_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t95
    t96 = mu_3*n_3_x
    f_x_x_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t96
    t97 = mu_4*n_4_x
    f_x_x_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t97
    t98 = mu_5*n_5_x
    f_x_x_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t98
    t99 = mu_6*n_6_x
    f_x_x_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t99
    t100 = mu_1*n_1_y
    f_y_x_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t100
    t101 = mu_2*n_2_y
    f_y_x_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t101
    t102 = mu_3*n_3_y
    f_y_x_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t102
    t103 = mu_4*n_4_y
    f_y_x_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t103
    t104 = mu_5*n_5_y
    f_y_x_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t104
    t105 = mu_6*n_6_y
    f_y_x_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t105
    t106 = mu_1*n_1_z
    f_z_x_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t106
    t107 = mu_2*n_2_z
    f_z_x_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t107
    t108 = mu_3*n_3_z
    f_z_x_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t108
    t109 = mu_4*n_4_z
    f_z_x_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t109
    t110 = mu_5*n_5_z
    f_z_x_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t110
    t111 = mu_6*n_6_z
    f_z_x_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t111
    t112 = -n_1_y*t59 + n_1_z*t65
    f_rx_x_1 = D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx + t112
    t113 = -n_2_y*t60 + n_2_z*t66
    f_rx_x_2 = D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx + t113
    t114 = -n_3_y*t61 + n_3_z*t67
    f_rx_x_3 = D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx + t114
    t115 = -n_4_y*t62 + n_4_z*t68
    f_rx_x_4 = D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx + t115
    t116 = -n_5_y*t63 + n_5_z*t69
    f_rx_x_5 = D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx + t116
    t117 = -n_6_y*t64 + n_6_z*t70
    f_rx_x_6 = D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx + t117
    t118 = n_1_z*t71
    f_ry_x_1 = (
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry + n_1_x*t59
        - t118
    )
    t119 = n_2_z*t72
    f_ry_x_2 = (
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry + n_2_x*t60
        - t119
    )
    t120 = n_3_z*t73
    f_ry_x_3 = (
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry + n_3_x*t61
        - t120
    )
    t121 = n_4_z*t74
    f_ry_x_4 = (
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry + n_4_x*t62
        - t121
    )
    t122 = n_5_z*t75
    f_ry_x_5 = (
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry + n_5_x*t63
        - t122
    )
    t123 = n_6_z*t76
    f_ry_x_6 = (
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry + n_6_x*t64
        - t123
    )
    t124 = -n_1_x*t65 + n_1_y*t71
    f_rz_x_1 = D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz + t124
    t125 = -n_2_x*t66 + n_2_y*t72
    f_rz_x_2 = D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz + t125
    t126 = -n_3_x*t67 + n_3_y*t73
    f_rz_x_3 = D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz + t126
    t127 = -n_4_x*t68 + n_4_y*t74
    f_rz_x_4 = D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz + t127
    t128 = -n_5_x*t69 + n_5_y*t75
    f_rz_x_5 = D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz + t128
    t129 = -n_6_x*t70 + n_6_y*t76
    f_rz_x_6 = D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz + t129
    t130 = B_1_z*mu_1*n_1_x - t118
    t131 = B_2_z*mu_2*n_2_x - t119
    t132 = B_3_z*mu_3*n_3_x - t120
    t133 = B_4_z*mu_4*n_4_x - t121
    t134 = B_5_z*mu_5*n_5_x - t122
    t135 = R_p_1**2
    t136 = k_1_1*t135
    t137 = R_p_2**2
    t138 = k_2_1*t137
    t139 = R_p_3**2
    t140 = k_3_1*t139
    t141 = R_p_4**2
    t142 = k_4_1*t141
    t143 = R_p_5**2
    t144 = k_5_1*t143
    t145 = R_p_6**2
    t146 = k_6_1*t145
    K_out = np.zeros((*batch, 18, 18), dtype)
    K_out[..., 0, 0] = (
        D_p_rx_1*f_rx_x_1 + D_p_rx_1*t112 + D_p_ry_1*f_ry_x_1 + D_p_ry_1*t130 + D_p_rz_1*f_rz_x_1
        + D_p_rz_1*t124 + D_p_x_1*f_x_x_1 + D_p_x_1*t94 + D_p_y_1*f_y_x_1 + D_p_y_1*t100 + D_p_z_1*f_z_x_1
        + D_p_z_1*t106 + k_1_2 + k_1_3 - mu_1*n_1_x**2 - mu_1*n_1_y**2 - mu_1*n_1_z**2
    )
    K_out[..., 0, 1] = K_out[..., 1, 0] = (
        D_p_rx_1*f_rx_x_2 + D_p_rx_2*t112 + D_p_ry_1*f_ry_x_2 + D_p_ry_2*t130 + D_p_rz_1*f_rz_x_2
        + D_p_rz_2*t124 + D_p_x_1*f_x_x_2 + D_p_x_2*t94 + D_p_y_1*f_y_x_2 + D_p_y_2*t100 + D_p_z_1*f_z_x_2
        + D_p_z_2*t106
    )
    K_out[..., 0, 2] = K_out[..., 2, 0] = (
        D_p_rx_1*f_rx_x_3 + D_p_rx_3*t112 + D_p_ry_1*f_ry_x_3 + D_p_ry_3*t130 + D_p_rz_1*f_rz_x_3
        + D_p_rz_3*t124 + D_p_x_1*f_x_x_3 + D_p_x_3*t94 + D_p_y_1*f_y_x_3 + D_p_y_3*t100 + D_p_z_1*f_z_x_3
        + D_p_z_3*t106
    )
    K_out[..., 0, 3] = K_out[..., 3, 0] = (
        D_p_rx_1*f_rx_x_4 + D_p_rx_4*t112 + D_p_ry_1*f_ry_x_4 + D_p_ry_4*t130 + D_p_rz_1*f_rz_x_4
        + D_p_rz_4*t124 + D_p_x_1*f_x_x_4 + D_p_x_4*t94 + D_p_y_1*f_y_x_4 + D_p_y_4*t100 + D_p_z_1*f_z_x_4
        + D_p_z_4*t106
    )
    K_out[..., 0, 4] = K_out[..., 4, 0] = (
        D_p_rx_1*f_rx_x_5 + D_p_rx_5*t112 + D_p_ry_1*f_ry_x_5 + D_p_ry_5*t130 + D_p_rz_1*f_rz_x_5
        + D_p_rz_5*t124 + D_p_x_1*f_x_x_5 + D_p_x_5*t94 + D_p_y_1*f_y_x_5 + D_p_y_5*t100 + D_p_z_1*f_z_x_5
        + D_p_z_5*t106
    )
    K_out[..., 0, 5] = K_out[..., 5, 0] = (
        D_p_rx_1*f_rx_x_6 + D_p_rx_6*t112 + D_p_ry_1*f_ry_x_6 + D_p_ry_6*t130 + D_p_rz_1*f_rz_x_6
        + D_p_rz_6*t124 + D_p_x_1*f_x_x_6 + D_p_x_6*t94 + D_p_y_1*f_y_x_6 + D_p_y_6*t100 + D_p_z_1*f_z_x_6
        + D_p_z_6*t106
    )
    K_out[..., 0, 6] = K_out[..., 6, 0] = -R_p_1*k_1_3
    K_out[..., 0, 12] = K_out[..., 12, 0] = -R_p_1*k_1_2
    K_out[..., 1, 1] = (
        D_p_rx_2*f_rx_x_2 + D_p_rx_2*t113 + D_p_ry_2*f_ry_x_2 + D_p_ry_2*t131 + D_p_rz_2*f_rz_x_2
        + D_p_rz_2*t125 + D_p_x_2*f_x_x_2 + D_p_x_2*t95 + D_p_y_2*f_y_x_2 + D_p_y_2*t101 + D_p_z_2*f_z_x_2
        + D_p_z_2*t107 + k_2_2 + k_2_3 - mu_2*n_2_x**2 - mu_2*n_2_y**2 - mu_2*n_2_z**2
    )
    K_out[..., 1, 2] = K_out[..., 2, 1] = (
        D_p_rx_2*f_rx_x_3 + D_p_rx_3*t113 + D_p_ry_2*f_ry_x_3 + D_p_ry_3*t131 + D_p_rz_2*f_rz_x_3
        + D_p_rz_3*t125 + D_p_x_2*f_x_x_3 + D_p_x_3*t95 + D_p_y_2*f_y_x_3 + D_p_y_3*t101 + D_p_z_2*f_z_x_3
        + D_p_z_3*t107
    )
    K_out[..., 1, 3] = K_out[..., 3, 1] = (
        D_p_rx_2*f_rx_x_4 + D_p_rx_4*t113 + D_p_ry_2*f_ry_x_4 + D_p_ry_4*t131 + D_p_rz_2*f_rz_x_4
        + D_p_rz_4*t125 + D_p_x_2*f_x_x_4 + D_p_x_4*t95 + D_p_y_2*f_y_x_4 + D_p_y_4*t101 + D_p_z_2*f_z_x_4
        + D_p_z_4*t107
    )
    K_out[..., 1, 4] = K_out[..., 4, 1] = (
        D_p_rx_2*f_rx_x_5 + D_p_rx_5*t113 + D_p_ry_2*f_ry_x_5 + D_p_ry_5*t131 + D_p_rz_2*f_rz_x_5
        + D_p_rz_5*t125 + D_p_x_2*f_x_x_5 + D_p_x_5*t95 + D_p_y_2*f_y_x_5 + D_p_y_5*t101 + D_p_z_2*f_z_x_5
        + D_p_z_5*t107
    )
    K_out[..., 1, 5] = K_out[..., 5, 1] = (
        D_p_rx_2*f_rx_x_6 + D_p_rx_6*t113 + D_p_ry_2*f_ry_x_6 + D_p_ry_6*t131 + D_p_rz_2*f_rz_x_6
        + D_p_rz_6*t125 + D_p_x_2*f_x_x_6 + D_p_x_6*t95 + D_p_y_2*f_y_x_6 + D_p_y_6*t101 + D_p_z_2*f_z_x_6
        + D_p_z_6*t107
    )
    K_out[..., 1, 7] = K_out[..., 7, 1] = -R_p_2*k_2_3
    K_out[..., 1, 13] = K_out[..., 13, 1] = -R_p_2*k_2_2
    K_out[..., 2, 2] = (
        D_p_rx_3*f_rx_x_3 + D_p_rx_3*t114 + D_p_ry_3*f_ry_x_3 + D_p_ry_3*t132 + D_p_rz_3*f_rz_x_3
        + D_p_rz_3*t126 + D_p_x_3*f_x_x_3 + D_p_x_3*t96 + D_p_y_3*f_y_x_3 + D_p_y_3*t102 + D_p_z_3*f_z_x_3
        + D_p_z_3*t108 + k_3_2 + k_3_3 - mu_3*n_3_x**2 - mu_3*n_3_y**2 - mu_3*n_3_z**2
    )
    K_out[..., 2, 3] = K_out[..., 3, 2] = (
        D_p_rx_3*f_rx_x_4 + D_p_rx_4*t114 + D_p_ry_3*f_ry_x_4 + D_p_ry_4*t132 + D_p_rz_3*f_rz_x_4
        + D_p_rz_4*t126 + D_p_x_3*f_x_x_4 + D_p_x_4*t96 + D_p_y_3*f_y_x_4 + D_p_y_4*t102 + D_p_z_3*f_z_x_4
        + D_p_z_4*t108
    )
    K_out[..., 2, 4] = K_out[..., 4, 2] = (
        D_p_rx_3*f_rx_x_5 + D_p_rx_5*t114 + D_p_ry_3*f_ry_x_5 + D_p_ry_5*t132 + D_p_rz_3*f_rz_x_5
        + D_p_rz_5*t126 + D_p_x_3*f_x_x_5 + D_p_x_5*t96 + D_p_y_3*f_y_x_5 + D_p_y_5*t102 + D_p_z_3*f_z_x_5
        + D_p_z_5*t108
    )
    K_out[..., 2, 5] = K_out[..., 5, 2] = (
        D_p_rx_3*f_rx_x_6 + D_p_rx_6*t114 + D_p_ry_3*f_ry_x_6 + D_p_ry_6*t132 + D_p_rz_3*f_rz_x_6
        + D_p_rz_6*t126 + D_p_x_3*f_x_x_6 + D_p_x_6*t96 + D_p_y_3*f_y_x_6 + D_p_y_6*t102 + D_p_z_3*f_z_x_6
        + D_p_z_6*t108
    )
    K_out[..., 2, 8] = K_out[..., 8, 2] = -R_p_3*k_3_3
    K_out[..., 2, 14] = K_out[..., 14, 2] = -R_p_3*k_3_2
    K_out[..., 3, 3] = (
        D_p_rx_4*f_rx_x_4 + D_p_rx_4*t115 + D_p_ry_4*f_ry_x_4 + D_p_ry_4*t133 + D_p_rz_4*f_rz_x_4
        + D_p_rz_4*t127 + D_p_x_4*f_x_x_4 + D_p_x_4*t97 + D_p_y_4*f_y_x_4 + D_p_y_4*t103 + D_p_z_4*f_z_x_4
        + D_p_z_4*t109 + k_4_2 + k_4_3 - mu_4*n_4_x**2 - mu_4*n_4_y**2 - mu_4*n_4_z**2
    )
    K_out[..., 3, 4] = K_out[..., 4, 3] = (
        D_p_rx_4*f_rx_x_5 + D_p_rx_5*t115 + D_p_ry_4*f_ry_x_5 + D_p_ry_5*t133 + D_p_rz_4*f_rz_x_5
        + D_p_rz_5*t127 + D_p_x_4*f_x_x_5 + D_p_x_5*t97 + D_p_y_4*f_y_x_5 + D_p_y_5*t103 + D_p_z_4*f_z_x_5
        + D_p_z_5*t109
    )
    K_out[..., 3, 5] = K_out[..., 5, 3] = (
        D_p_rx_4*f_rx_x_6 + D_p_rx_6*t115 + D_p_ry_4*f_ry_x_6 + D_p_ry_6*t133 + D_p_rz_4*f_rz_x_6
        + D_p_rz_6*t127 + D_p_x_4*f_x_x_6 + D_p_x_6*t97 + D_p_y_4*f_y_x_6 + D_p_y_6*t103 + D_p_z_4*f_z_x_6
        + D_p_z_6*t109
    )
    K_out[..., 3, 9] = K_out[..., 9, 3] = -R_p_4*k_4_3
    K_out[..., 3, 15] = K_out[..., 15, 3] = -R_p_4*k_4_2
    K_out[..., 4, 4] = (
        D_p_rx_5*f_rx_x_5 + D_p_rx_5*t116 + D_p_ry_5*f_ry_x_5 + D_p_ry_5*t134 + D_p_rz_5*f_rz_x_5
        + D_p_rz_5*t128 + D_p_x_5*f_x_x_5 + D_p_x_5*t98 + D_p_y_5*f_y_x_5 + D_p_y_5*t104 + D_p_z_5*f_z_x_5
        + D_p_z_5*t110 + k_5_2 + k_5_3 - mu_5*n_5_x**2 - mu_5*n_5_y**2 - mu_5*n_5_z**2
    )
    K_out[..., 4, 5] = K_out[..., 5, 4] = (
        D_p_rx_5*f_rx_x_6 + D_p_rx_6*t116 + D_p_ry_5*f_ry_x_6 + D_p_ry_6*t134 + D_p_rz_5*f_rz_x_6
        + D_p_rz_6*t128 + D_p_x_5*f_x_x_6 + D_p_x_6*t98 + D_p_y_5*f_y_x_6 + D_p_y_6*t104 + D_p_z_5*f_z_x_6
        + D_p_z_6*t110
    )
    K_out[..., 4, 10] = K_out[..., 10, 4] = -R_p_5*k_5_3
    K_out[..., 4, 16] = K_out[..., 16, 4] = -R_p_5*k_5_2
    K_out[..., 5, 5] = (
        D_p_rx_6*f_rx_x_6 + D_p_rx_6*t117 + D_p_ry_6*f_ry_x_6 + D_p_ry_6*(B_6_z*mu_6*n_6_x - t123)
        + D_p_rz_6*f_rz_x_6 + D_p_rz_6*t129 + D_p_x_6*f_x_x_6 + D_p_x_6*t99 + D_p_y_6*f_y_x_6 + D_p_y_6*t105
        + D_p_z_6*f_z_x_6 + D_p_z_6*t111 + k_6_2 + k_6_3 - mu_6*n_6_x**2 - mu_6*n_6_y**2 - mu_6*n_6_z**2
    )
    K_out[..., 5, 11] = K_out[..., 11, 5] = -R_p_6*k_6_3
    K_out[..., 5, 17] = K_out[..., 17, 5] = -R_p_6*k_6_2
    K_out[..., 6, 6] = k_1_3*t135 + t136
    K_out[..., 6, 12] = K_out[..., 12, 6] = -t136
    K_out[..., 7, 7] = k_2_3*t137 + t138
    K_out[..., 7, 13] = K_out[..., 13, 7] = -t138
    K_out[..., 8, 8] = k_3_3*t139 + t140
    K_out[..., 8, 14] = K_out[..., 14, 8] = -t140
    K_out[..., 9, 9] = k_4_3*t141 + t142
    K_out[..., 9, 15] = K_out[..., 15, 9] = -t142
    K_out[..., 10, 10] = k_5_3*t143 + t144
    K_out[..., 10, 16] = K_out[..., 16, 10] = -t144
    K_out[..., 11, 11] = k_6_3*t145 + t146
    K_out[..., 11, 17] = K_out[..., 17, 11] = -t146
    K_out[..., 12, 12] = k_1_2*t135 + t136
    K_out[..., 13, 13] = k_2_2*t137 + t138
    K_out[..., 14, 14] = k_3_2*t139 + t140
    K_out[..., 15, 15] = k_4_2*t141 + t142
    K_out[..., 16, 16] = k_5_2*t143 + t144
    K_out[..., 17, 17] = k_6_2*t145 + t146
    return K_out


def modal_matrices(p, parameters):
    """Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.

    Common intermediate values are evaluated once: call this function for an eigenproblem.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M : array, shape (..., 18, 18) [kg, kg m^2]
        Mass matrix.
    K : array, shape (..., 18, 18) [N/m, N, N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equation 48.
    4479 operations; 103020377892 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    I_p_x, I_p_y, I_p_z = _entries(parameters.platform_inertia, (3,))
    I_p_xy, I_p_xz, I_p_yz = _entries(parameters.platform_products, (3,))
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    l_d_1, l_d_2, l_d_3, l_d_4, l_d_5, l_d_6 = _entries(parameters.link_length, (6,))
    m_d_1, m_d_2, m_d_3, m_d_4, m_d_5, m_d_6 = _entries(parameters.link_mass, (6,))
    m_t_1, m_t_2, m_t_3, m_t_4, m_t_5, m_t_6 = _entries(parameters.carriage_mass, (6,))
    l_t_1, l_t_2, l_t_3, l_t_4, l_t_5, l_t_6 = _entries(parameters.carriage_length, (6,))
    k_sp_1, k_sp_2, k_sp_3, k_sp_4, k_sp_5, k_sp_6 = _entries(parameters.belt_specific_stiffness, (6,))
    w_b_1, w_b_2, w_b_3, w_b_4, w_b_5, w_b_6 = _entries(parameters.belt_width, (6,))
    R_p_1, R_p_2, R_p_3, R_p_4, R_p_5, R_p_6 = _entries(parameters.pulley_radius, (6,))
    I_p_1, I_p_2, I_p_3, I_p_4, I_p_5, I_p_6 = _entries(parameters.pulley_inertia, (6,))
    I_m_1, I_m_2, I_m_3, I_m_4, I_m_5, I_m_6 = _entries(parameters.motor_inertia, (6,))
    i_g_1, i_g_2, i_g_3, i_g_4, i_g_5, i_g_6 = _entries(parameters.gear_ratio, (6,))
    (
        d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2, d_4_1, d_4_2, d_5_1, d_5_2, d_6_1, d_6_2,
    ) = _entries(parameters.drive, (6, 2))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, m_p, c_p_x, I_p_x, I_p_xy, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1,
        l_t_1, k_sp_1, w_b_1, R_p_1, I_p_1, I_m_1, i_g_1, d_1_1, x_min_1, sigma_1)
    t1 = rot_x**2
    t2 = rot_y**2
    t3 = rot_z**2
    t4 = t2 + t3
    half_angle = (1/2)*np.sqrt(t1 + t4 + 1e-30)
    s_half = np.sin(half_angle)/half_angle
    t5 = s_half**2
    t6 = (1/2)*t5
    R_x_x = -t4*t6 + 1
    c_half = np.cos(half_angle)
    t7 = c_half*s_half
    t8 = rot_z*t7
    R_x_y = (1/2)*rot_x*rot_y*t5 - t8
    t9 = rot_y*t7
    t10 = rot_x*t6
    R_x_z = rot_z*t10 + t9
    B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z
    r_1_x = B_1_x - o_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    r_1_y = B_1_y - o_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    r_1_z = B_1_z - o_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    r_2_x = B_2_x - o_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    r_2_y = B_2_y - o_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    r_2_z = B_2_z - o_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    r_3_x = B_3_x - o_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    r_3_y = B_3_y - o_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    r_3_z = B_3_z - o_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    r_4_x = B_4_x - o_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    r_4_y = B_4_y - o_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    r_4_z = B_4_z - o_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    r_5_x = B_5_x - o_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    r_5_y = B_5_y - o_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    r_5_z = B_5_z - o_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    r_6_x = B_6_x - o_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    r_6_y = B_6_y - o_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    r_6_z = B_6_z - o_6_z + p_z
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
    a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z
    w_4_x = -a_4*n_4_x + r_4_x
    w_4_y = -a_4*n_4_y + r_4_y
    w_4_z = -a_4*n_4_z + r_4_z
    w2_4 = w_4_x**2 + w_4_y**2 + w_4_z**2
    x_4 = a_4 + sigma_4*np.sqrt(l_d_4**2 - w2_4)
    a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z
    w_5_x = -a_5*n_5_x + r_5_x
    w_5_y = -a_5*n_5_y + r_5_y
    w_5_z = -a_5*n_5_z + r_5_z
    w2_5 = w_5_x**2 + w_5_y**2 + w_5_z**2
    x_5 = a_5 + sigma_5*np.sqrt(l_d_5**2 - w2_5)
    a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z
    w_6_x = -a_6*n_6_x + r_6_x
    w_6_y = -a_6*n_6_y + r_6_y
    w_6_z = -a_6*n_6_z + r_6_z
    w2_6 = w_6_x**2 + w_6_y**2 + w_6_z**2
    x_6 = a_6 + sigma_6*np.sqrt(l_d_6**2 - w2_6)
    s_1_x = -n_1_x*x_1 + r_1_x
    s_1_y = -n_1_y*x_1 + r_1_y
    s_1_z = -n_1_z*x_1 + r_1_z
    s_2_x = -n_2_x*x_2 + r_2_x
    s_2_y = -n_2_y*x_2 + r_2_y
    s_2_z = -n_2_z*x_2 + r_2_z
    s_3_x = -n_3_x*x_3 + r_3_x
    s_3_y = -n_3_y*x_3 + r_3_y
    s_3_z = -n_3_z*x_3 + r_3_z
    s_4_x = -n_4_x*x_4 + r_4_x
    s_4_y = -n_4_y*x_4 + r_4_y
    s_4_z = -n_4_z*x_4 + r_4_z
    s_5_x = -n_5_x*x_5 + r_5_x
    s_5_y = -n_5_y*x_5 + r_5_y
    s_5_z = -n_5_z*x_5 + r_5_z
    s_6_x = -n_6_x*x_6 + r_6_x
    s_6_y = -n_6_y*x_6 + r_6_y
    s_6_z = -n_6_z*x_6 + r_6_z
    c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z
    c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z
    c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z
    t12 = I_p_xy*R_x_x
    t13 = I_p_xz*R_x_x
    t14 = 2*R_x_z
    t15 = I_p_yz*R_x_y
    J_x_x = I_p_x*R_x_x**2 + I_p_y*R_x_y**2 + I_p_z*R_x_z**2 + 2*R_x_y*t12 + t13*t14 + t14*t15
    t16 = I_p_x*R_x_x
    t17 = I_p_xy*R_x_y
    t18 = I_p_xz*R_x_z
    t19 = I_p_y*R_x_y
    t20 = I_p_yz*R_x_z
    t21 = I_p_z*R_x_z
    J_x_y = (
        R_y_x*t16 + R_y_x*t17 + R_y_x*t18 + R_y_y*t12 + R_y_y*t19 + R_y_y*t20 + R_y_z*t13 + R_y_z*t15
        + R_y_z*t21
    )
    J_x_z = (
        R_z_x*t16 + R_z_x*t17 + R_z_x*t18 + R_z_y*t12 + R_z_y*t19 + R_z_y*t20 + R_z_z*t13 + R_z_z*t15
        + R_z_z*t21
    )
    t22 = I_p_xy*R_y_x
    t23 = I_p_xz*R_y_x
    t24 = 2*R_y_z
    t25 = I_p_yz*R_y_y
    J_y_y = I_p_x*R_y_x**2 + I_p_y*R_y_y**2 + I_p_z*R_y_z**2 + 2*R_y_y*t22 + t23*t24 + t24*t25
    t26 = I_p_xy*R_z_x
    t27 = I_p_xz*R_z_x
    t28 = I_p_yz*R_z_y
    J_y_z = (
        I_p_x*R_y_x*R_z_x + I_p_y*R_y_y*R_z_y + I_p_z*R_y_z*R_z_z + R_y_y*t26 + R_y_z*t27 + R_y_z*t28
        + R_z_y*t22 + R_z_z*t23 + R_z_z*t25
    )
    t29 = 2*R_z_z
    J_z_z = I_p_x*R_z_x**2 + I_p_y*R_z_y**2 + I_p_z*R_z_z**2 + 2*R_z_y*t26 + t27*t29 + t28*t29
    D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y
    D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x
    D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x
    D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y
    D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x
    D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x
    D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y
    D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x
    D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x
    D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y
    D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x
    D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x
    D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y
    D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x
    D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x
    D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y
    D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x
    D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x
    D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z
    D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z
    D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z
    D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z
    D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z
    D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z
    minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y
    minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z
    minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z
    minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y
    minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z
    minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z
    minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z
    minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y
    minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y
    minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z
    minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y
    minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x
    minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x
    minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x
    minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x
    minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x
    minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x
    minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x
    minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x
    minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x
    minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x
    minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x
    minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x
    minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x
    A_rx_1 = (
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123
    )
    A_ry_1 = (
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123
    )
    A_rz_1 = (
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123
    )
    minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y
    minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y
    minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y
    minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y
    minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z
    minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z
    minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x
    minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x
    minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x
    minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x
    A_z_2 = (
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124
    )
    A_rx_2 = (
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123
    )
    A_ry_2 = (
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123
    )
    A_rz_2 = (
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123
    )
    minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y
    minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y
    minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y
    minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y
    minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z
    minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z
    minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x
    minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x
    minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x
    minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x
    A_z_3 = (
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124
    )
    A_rx_3 = (
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123
    )
    A_ry_3 = (
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123
    )
    A_rz_3 = (
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123
    )
    minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y
    minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y
    minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x
    minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x
    minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x
    minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x
    minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x
    A_rx_4 = (
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12
    )
    A_ry_4 = (
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12
    )
    A_rz_4 = (
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12
    )
    minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry
    minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx
    minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx
    minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z
    minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z
    minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z
    minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y
    minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y
    minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y
    minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x
    minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x
    minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x
    minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x
    A_z_5 = (
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12
    )
    A_rx_5 = (
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12
    )
    A_ry_5 = (
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12
    )
    A_rz_5 = (
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12
    )
    minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry
    minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx
    minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx
    minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z
    minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z
    minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z
    minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y
    minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y
    minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y
    minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x
    minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x
    minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x
    minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x
    A_z_6 = (
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12
    )
    A_rx_6 = (
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12
    )
    A_ry_6 = (
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12
    )
    A_rz_6 = (
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12
    )
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z
    t30 = 1.0/det_D_l
    t31 = D_r_1*t30
    D_p_x_1 = A_x_1*t31
    t32 = D_r_2*t30
    D_p_x_2 = A_x_2*t32
    t33 = D_r_3*t30
    D_p_x_3 = A_x_3*t33
    t34 = D_r_4*t30
    D_p_x_4 = A_x_4*t34
    t35 = D_r_5*t30
    D_p_x_5 = A_x_5*t35
    t36 = D_r_6*t30
    D_p_x_6 = A_x_6*t36
    D_p_y_1 = A_y_1*t31
    D_p_y_2 = A_y_2*t32
    D_p_y_3 = A_y_3*t33
    D_p_y_4 = A_y_4*t34
    D_p_y_5 = A_y_5*t35
    D_p_y_6 = A_y_6*t36
    D_p_z_1 = A_z_1*t31
    D_p_z_2 = A_z_2*t32
    D_p_z_3 = A_z_3*t33
    D_p_z_4 = A_z_4*t34
    D_p_z_5 = A_z_5*t35
    D_p_z_6 = A_z_6*t36
    D_p_rx_1 = A_rx_1*t31
    D_p_rx_2 = A_rx_2*t32
    D_p_rx_3 = A_rx_3*t33
    D_p_rx_4 = A_rx_4*t34
    D_p_rx_5 = A_rx_5*t35
    D_p_rx_6 = A_rx_6*t36
    D_p_ry_1 = A_ry_1*t31
    D_p_ry_2 = A_ry_2*t32
    D_p_ry_3 = A_ry_3*t33
    D_p_ry_4 = A_ry_4*t34
    D_p_ry_5 = A_ry_5*t35
    D_p_ry_6 = A_ry_6*t36
    D_p_rz_1 = A_rz_1*t31
    D_p_rz_2 = A_rz_2*t32
    D_p_rz_3 = A_rz_3*t33
    D_p_rz_4 = A_rz_4*t34
    D_p_rz_5 = A_rz_5*t35
    D_p_rz_6 = A_rz_6*t36
    t37 = I_m_1*i_g_1**2
    I_1_1 = I_p_1 + d_1_1*t37
    I_1_2 = I_p_1 + d_1_2*t37
    t38 = I_m_2*i_g_2**2
    I_2_1 = I_p_2 + d_2_1*t38
    I_2_2 = I_p_2 + d_2_2*t38
    t39 = I_m_3*i_g_3**2
    I_3_1 = I_p_3 + d_3_1*t39
    I_3_2 = I_p_3 + d_3_2*t39
    t40 = I_m_4*i_g_4**2
    I_4_1 = I_p_4 + d_4_1*t40
    I_4_2 = I_p_4 + d_4_2*t40
    t41 = I_m_5*i_g_5**2
    I_5_1 = I_p_5 + d_5_1*t41
    I_5_2 = I_p_5 + d_5_2*t41
    t42 = I_m_6*i_g_6**2
    I_6_1 = I_p_6 + d_6_1*t42
    I_6_2 = I_p_6 + d_6_2*t42
    l_f_1_1 = x_max_1 - x_min_1
    t43 = k_sp_1*w_b_1
    k_1_1 = t43/l_f_1_1
    t44 = (1/2)*l_t_1
    l_f_1_2 = -t44 + x_1 - x_min_1
    k_1_2 = t43/l_f_1_2
    l_f_1_3 = -t44 - x_1 + x_max_1
    k_1_3 = t43/l_f_1_3
    l_f_2_1 = x_max_2 - x_min_2
    t45 = k_sp_2*w_b_2
    k_2_1 = t45/l_f_2_1
    t46 = (1/2)*l_t_2
    l_f_2_2 = -t46 + x_2 - x_min_2
    k_2_2 = t45/l_f_2_2
    l_f_2_3 = -t46 - x_2 + x_max_2
    k_2_3 = t45/l_f_2_3
    l_f_3_1 = x_max_3 - x_min_3
    t47 = k_sp_3*w_b_3
    k_3_1 = t47/l_f_3_1
    t48 = (1/2)*l_t_3
    l_f_3_2 = -t48 + x_3 - x_min_3
    k_3_2 = t47/l_f_3_2
    l_f_3_3 = -t48 - x_3 + x_max_3
    k_3_3 = t47/l_f_3_3
    l_f_4_1 = x_max_4 - x_min_4
    t49 = k_sp_4*w_b_4
    k_4_1 = t49/l_f_4_1
    t50 = (1/2)*l_t_4
    l_f_4_2 = -t50 + x_4 - x_min_4
    k_4_2 = t49/l_f_4_2
    l_f_4_3 = -t50 - x_4 + x_max_4
    k_4_3 = t49/l_f_4_3
    l_f_5_1 = x_max_5 - x_min_5
    t51 = k_sp_5*w_b_5
    k_5_1 = t51/l_f_5_1
    t52 = (1/2)*l_t_5
    l_f_5_2 = -t52 + x_5 - x_min_5
    k_5_2 = t51/l_f_5_2
    l_f_5_3 = -t52 - x_5 + x_max_5
    k_5_3 = t51/l_f_5_3
    l_f_6_1 = x_max_6 - x_min_6
    t53 = k_sp_6*w_b_6
    k_6_1 = t53/l_f_6_1
    t54 = (1/2)*l_t_6
    l_f_6_2 = -t54 + x_6 - x_min_6
    k_6_2 = t53/l_f_6_2
    l_f_6_3 = -t54 - x_6 + x_max_6
    k_6_3 = t53/l_f_6_3
    t55 = (1/2)*m_d_1
    t56 = (1/2)*m_d_2
    t57 = (1/2)*m_d_3
    t58 = (1/2)*m_d_4
    t59 = (1/2)*m_d_5
    t60 = (1/2)*m_d_6
    t61 = m_p + t55 + t56 + t57 + t58 + t59 + t60
    G_p_x = -g_x*t61
    G_p_y = -g_y*t61
    G_p_z = -g_z*t61
    t62 = g_z*m_p
    t63 = g_z*t55
    t64 = g_z*t56
    t65 = g_z*t57
    t66 = g_z*t58
    t67 = g_z*t59
    t68 = g_z*t60
    G_p_rx = (
        -B_1_y*t63 + (1/2)*B_1_z*g_y*m_d_1 - B_2_y*t64 + (1/2)*B_2_z*g_y*m_d_2 - B_3_y*t65
        + (1/2)*B_3_z*g_y*m_d_3 - B_4_y*t66 + (1/2)*B_4_z*g_y*m_d_4 - B_5_y*t67 + (1/2)*B_5_z*g_y*m_d_5
        - B_6_y*t68 + (1/2)*B_6_z*g_y*m_d_6 - c_y*t62 + c_z*g_y*m_p
    )
    t69 = g_x*t55
    t70 = g_x*t56
    t71 = g_x*t57
    t72 = g_x*t58
    t73 = g_x*t59
    t74 = g_x*t60
    t75 = g_x*m_p
    G_p_ry = (
        B_1_x*t63 - B_1_z*t69 + B_2_x*t64 - B_2_z*t70 + B_3_x*t65 - B_3_z*t71 + B_4_x*t66 - B_4_z*t72
        + B_5_x*t67 - B_5_z*t73 + B_6_x*t68 - B_6_z*t74 + c_x*t62 - c_z*t75
    )
    t76 = g_y*m_p
    t77 = g_y*t55
    t78 = g_y*t56
    t79 = g_y*t57
    t80 = g_y*t58
    t81 = g_y*t59
    t82 = g_y*t60
    G_p_rz = (
        -B_1_x*t77 + (1/2)*B_1_y*g_x*m_d_1 - B_2_x*t78 + (1/2)*B_2_y*g_x*m_d_2 - B_3_x*t79
        + (1/2)*B_3_y*g_x*m_d_3 - B_4_x*t80 + (1/2)*B_4_y*g_x*m_d_4 - B_5_x*t81 + (1/2)*B_5_y*g_x*m_d_5
        - B_6_x*t82 + (1/2)*B_6_y*g_x*m_d_6 - c_x*t76 + c_y*g_x*m_p
    )
    mu_1 = t30*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z)
    mu_2 = t30*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z)
    mu_3 = t30*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z)
    mu_4 = t30*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z)
    mu_5 = t30*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z)
    mu_6 = t30*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z)
    g_4_x = -mu_1*s_1_x - t69
    g_4_y = -mu_1*s_1_y - t77
    g_4_z = -mu_1*s_1_z - t63
    g_5_x = -mu_2*s_2_x - t70
    g_5_y = -mu_2*s_2_y - t78
    g_5_z = -mu_2*s_2_z - t64
    g_6_x = -mu_3*s_3_x - t71
    g_6_y = -mu_3*s_3_y - t79
    g_6_z = -mu_3*s_3_z - t65
    g_7_x = -mu_4*s_4_x - t72
    g_7_y = -mu_4*s_4_y - t80
    g_7_z = -mu_4*s_4_z - t66
    g_8_x = -mu_5*s_5_x - t73
    g_8_y = -mu_5*s_5_y - t81
    g_8_z = -mu_5*s_5_z - t67
    g_9_x = -mu_6*s_6_x - t74
    g_9_y = -mu_6*s_6_y - t82
    g_9_z = -mu_6*s_6_z - t68
    g_10_x = -t75
    g_10_y = -t76
    g_10_z = -t62
    L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6
    t83 = B_1_z*mu_1
    t84 = B_2_z*mu_2
    t85 = B_3_z*mu_3
    t86 = B_4_z*mu_4
    t87 = B_5_z*mu_5
    t88 = B_6_z*mu_6
    L_y_rx = t83 + t84 + t85 + t86 + t87 + t88
    L_x_ry = -L_y_rx
    t89 = B_1_y*mu_1
    t90 = B_2_y*mu_2
    t91 = B_3_y*mu_3
    t92 = B_4_y*mu_4
    t93 = B_5_y*mu_5
    t94 = B_6_y*mu_6
    L_x_rz = t89 + t90 + t91 + t92 + t93 + t94
    t95 = B_1_x*mu_1
    t96 = B_2_x*mu_2
    t97 = B_3_x*mu_3
    t98 = B_4_x*mu_4
    t99 = B_5_x*mu_5
    t100 = B_6_x*mu_6
    L_z_ry = t100 + t95 + t96 + t97 + t98 + t99
    L_y_rz = -L_z_ry
    L_z_rx = -L_x_rz
    t101 = B_1_z**2
    t102 = B_2_z**2
    t103 = B_3_z**2
    t104 = B_4_z**2
    t105 = B_5_z**2
    t106 = B_6_z**2
    t107 = (
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + mu_1*t101 + mu_2*t102 + mu_3*t103 + mu_4*t104 + mu_5*t105 + mu_6*t106
    )
    t108 = B_1_y**2
    t109 = B_2_y**2
    t110 = B_3_y**2
    t111 = B_4_y**2
    t112 = B_5_y**2
    t113 = B_6_y**2
    t114 = (
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + mu_1*t108 + mu_2*t109 + mu_3*t110 + mu_4*t111 + mu_5*t112 + mu_6*t113
    )
    L_rx_rx = -t107 - t114
    t115 = (1/2)*B_1_x
    t116 = (1/2)*g_4_x
    t117 = (1/2)*B_2_x
    t118 = (1/2)*g_5_x
    t119 = (1/2)*B_3_x
    t120 = (1/2)*g_6_x
    t121 = (1/2)*B_4_x
    t122 = (1/2)*g_7_x
    t123 = (1/2)*B_5_x
    t124 = (1/2)*g_8_x
    t125 = (1/2)*B_6_x
    t126 = (1/2)*g_9_x
    t127 = (1/2)*c_x
    t128 = (1/2)*g_10_x
    L_rx_ry = (
        B_1_x*t89 + B_1_y*t116 + B_2_x*t90 + B_2_y*t118 + B_3_x*t91 + B_3_y*t120 + B_4_x*t92 + B_4_y*t122
        + B_5_x*t93 + B_5_y*t124 + B_6_x*t94 + B_6_y*t126 + c_y*t128 + g_10_y*t127 + g_4_y*t115 + g_5_y*t117
        + g_6_y*t119 + g_7_y*t121 + g_8_y*t123 + g_9_y*t125
    )
    L_rx_rz = (
        B_1_x*t83 + B_1_z*t116 + B_2_x*t84 + B_2_z*t118 + B_3_x*t85 + B_3_z*t120 + B_4_x*t86 + B_4_z*t122
        + B_5_x*t87 + B_5_z*t124 + B_6_x*t88 + B_6_z*t126 + c_z*t128 + g_10_z*t127 + g_4_z*t115 + g_5_z*t117
        + g_6_z*t119 + g_7_z*t121 + g_8_z*t123 + g_9_z*t125
    )
    t129 = B_1_x**2
    t130 = B_2_x**2
    t131 = B_3_x**2
    t132 = B_4_x**2
    t133 = B_5_x**2
    t134 = B_6_x**2
    t135 = (
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + mu_1*t129 + mu_2*t130 + mu_3*t131 + mu_4*t132 + mu_5*t133 + mu_6*t134
    )
    L_ry_ry = -t107 - t135
    L_ry_rz = (
        (1/2)*B_1_y*g_4_z + B_1_y*t83 + (1/2)*B_1_z*g_4_y + (1/2)*B_2_y*g_5_z + B_2_y*t84 + (1/2)*B_2_z*g_5_y
        + (1/2)*B_3_y*g_6_z + B_3_y*t85 + (1/2)*B_3_z*g_6_y + (1/2)*B_4_y*g_7_z + B_4_y*t86
        + (1/2)*B_4_z*g_7_y + (1/2)*B_5_y*g_8_z + B_5_y*t87 + (1/2)*B_5_z*g_8_y + (1/2)*B_6_y*g_9_z
        + B_6_y*t88 + (1/2)*B_6_z*g_9_y + (1/2)*c_y*g_10_z + (1/2)*c_z*g_10_y
    )
    L_rz_rz = -t114 - t135
    t136 = mu_1*n_1_x
    f_x_x_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t136
    t137 = mu_2*n_2_x
    f_x_x_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t137
    t138 = mu_3*n_3_x
    f_x_x_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t138
    t139 = mu_4*n_4_x
    f_x_x_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t139
    t140 = mu_5*n_5_x
    f_x_x_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t140
    t141 = mu_6*n_6_x
    f_x_x_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t141
    t142 = mu_1*n_1_y
    f_y_x_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t142
    t143 = mu_2*n_2_y
    f_y_x_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t143
    t144 = mu_3*n_3_y
    f_y_x_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t144
    t145 = mu_4*n_4_y
    f_y_x_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t145
    t146 = mu_5*n_5_y
    f_y_x_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t146
    t147 = mu_6*n_6_y
    f_y_x_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t147
    t148 = mu_1*n_1_z
    f_z_x_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t148
    t149 = mu_2*n_2_z
    f_z_x_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t149
    t150 = mu_3*n_3_z
    f_z_x_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t150
    t151 = mu_4*n_4_z
    f_z_x_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t151
    t152 = mu_5*n_5_z
    f_z_x_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t152
    t153 = mu_6*n_6_z
    f_z_x_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t153
    t154 = -n_1_y*t83 + n_1_z*t89
    f_rx_x_1 = D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx + t154
    t155 = -n_2_y*t84 + n_2_z*t90
    f_rx_x_2 = D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx + t155
    t156 = -n_3_y*t85 + n_3_z*t91
    f_rx_x_3 = D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx + t156
    t157 = -n_4_y*t86 + n_4_z*t92
    f_rx_x_4 = D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx + t157
    t158 = -n_5_y*t87 + n_5_z*t93
    f_rx_x_5 = D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx + t158
    t159 = -n_6_y*t88 + n_6_z*t94
    f_rx_x_6 = D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx + t159
    t160 = n_1_z*t95
    f_ry_x_1 = (
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry + n_1_x*t83
        - t160
    )
    t161 = n_2_z*t96
    f_ry_x_2 = (
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry + n_2_x*t84
        - t161
    )
    t162 = n_3_z*t97
    f_ry_x_3 = (
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry + n_3_x*t85
        - t162
    )
    t163 = n_4_z*t98
    f_ry_x_4 = (
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry + n_4_x*t86
        - t163
    )
    t164 = n_5_z*t99
    f_ry_x_5 = (
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry + n_5_x*t87
        - t164
    )
    t165 = n_6_z*t100
    f_ry_x_6 = (
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry + n_6_x*t88
        - t165
    )
    t166 = -n_1_x*t89 + n_1_y*t95
    f_rz_x_1 = D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz + t166
    t167 = -n_2_x*t90 + n_2_y*t96
    f_rz_x_2 = D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz + t167
    t168 = -n_3_x*t91 + n_3_y*t97
    f_rz_x_3 = D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz + t168
    t169 = -n_4_x*t92 + n_4_y*t98
    f_rz_x_4 = D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz + t169
    t170 = -n_5_x*t93 + n_5_y*t99
    f_rz_x_5 = D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz + t170
    t171 = -n_6_x*t94 + n_6_y*t100
    f_rz_x_6 = D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz + t171
    t172 = (1/3)*m_d_1
    t173 = (1/3)*m_d_2
    t174 = (1/3)*m_d_3
    t175 = (1/3)*m_d_4
    t176 = (1/3)*m_d_5
    t177 = (1/3)*m_d_6
    M_p_x_x = m_p + t172 + t173 + t174 + t175 + t176 + t177
    t178 = c_z*m_p
    t179 = B_1_z*t172
    t180 = B_2_z*t173
    t181 = B_3_z*t174
    t182 = B_4_z*t175
    t183 = B_5_z*t176
    t184 = B_6_z*t177
    M_p_x_ry = t178 + t179 + t180 + t181 + t182 + t183 + t184
    t185 = c_y*m_p
    t186 = B_1_y*t172
    t187 = B_2_y*t173
    t188 = B_3_y*t174
    t189 = B_4_y*t175
    t190 = B_5_y*t176
    t191 = B_6_y*t177
    M_p_z_rx = t185 + t186 + t187 + t188 + t189 + t190 + t191
    M_p_x_rz = -M_p_z_rx
    M_p_y_rx = -M_p_x_ry
    M_p_y_rz = B_1_x*t172 + B_2_x*t173 + B_3_x*t174 + B_4_x*t175 + B_5_x*t176 + B_6_x*t177 + c_x*m_p
    M_p_z_ry = -M_p_y_rz
    t192 = 2*t108
    t193 = 2*t101
    t194 = (1/6)*m_d_1
    t195 = 2*t109
    t196 = 2*t102
    t197 = (1/6)*m_d_2
    t198 = 2*t110
    t199 = 2*t103
    t200 = (1/6)*m_d_3
    t201 = 2*t111
    t202 = 2*t104
    t203 = (1/6)*m_d_4
    t204 = 2*t112
    t205 = 2*t105
    t206 = (1/6)*m_d_5
    t207 = 2*t113
    t208 = 2*t106
    t209 = (1/6)*m_d_6
    t210 = 2*c_y**2
    t211 = 2*c_z**2
    t212 = (1/2)*m_p
    M_p_rx_rx = (
        J_x_x + t194*(t192 + t193) + t197*(t195 + t196) + t200*(t198 + t199) + t203*(t201 + t202) + t206*(t204
        + t205) + t209*(t207 + t208) + t212*(t210 + t211)
    )
    M_p_rx_ry = (
        -B_1_x*t186 - B_2_x*t187 - B_3_x*t188 - B_4_x*t189 - B_5_x*t190 - B_6_x*t191 + J_x_y - c_x*t185
    )
    M_p_rx_rz = (
        -B_1_x*t179 - B_2_x*t180 - B_3_x*t181 - B_4_x*t182 - B_5_x*t183 - B_6_x*t184 + J_x_z - c_x*t178
    )
    t213 = 2*t129
    t214 = 2*t130
    t215 = 2*t131
    t216 = 2*t132
    t217 = 2*t133
    t218 = 2*t134
    t219 = 2*c_x**2
    M_p_ry_ry = (
        J_y_y + t194*(t193 + t213) + t197*(t196 + t214) + t200*(t199 + t215) + t203*(t202 + t216) + t206*(t205
        + t217) + t209*(t208 + t218) + t212*(t211 + t219)
    )
    M_p_ry_rz = (
        -B_1_y*t179 - B_2_y*t180 - B_3_y*t181 - B_4_y*t182 - B_5_y*t183 - B_6_y*t184 + J_y_z - c_y*t178
    )
    M_p_rz_rz = (
        J_z_z + t194*(t192 + t213) + t197*(t195 + t214) + t200*(t198 + t215) + t203*(t201 + t216) + t206*(t204
        + t217) + t209*(t207 + t218) + t212*(t210 + t219)
    )
    t220 = n_1_x*t194
    h_x_x_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x + t220
    t221 = n_2_x*t197
    h_x_x_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x + t221
    t222 = n_3_x*t200
    h_x_x_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x + t222
    t223 = n_4_x*t203
    h_x_x_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x + t223
    t224 = n_5_x*t206
    h_x_x_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x + t224
    t225 = n_6_x*t209
    h_x_x_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x + t225
    t226 = n_1_y*t194
    h_y_x_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x + t226
    t227 = n_2_y*t197
    h_y_x_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x + t227
    t228 = n_3_y*t200
    h_y_x_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x + t228
    t229 = n_4_y*t203
    h_y_x_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x + t229
    t230 = n_5_y*t206
    h_y_x_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x + t230
    t231 = n_6_y*t209
    h_y_x_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x + t231
    t232 = n_1_z*t194
    h_z_x_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x + t232
    t233 = n_2_z*t197
    h_z_x_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x + t233
    t234 = n_3_z*t200
    h_z_x_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x + t234
    t235 = n_4_z*t203
    h_z_x_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x + t235
    t236 = n_5_z*t206
    h_z_x_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x + t236
    t237 = n_6_z*t209
    h_z_x_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x + t237
    t238 = t194*(B_1_y*n_1_z - B_1_z*n_1_y)
    h_rx_x_1 = (
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx
        + t238
    )
    t239 = t197*(B_2_y*n_2_z - B_2_z*n_2_y)
    h_rx_x_2 = (
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx
        + t239
    )
    t240 = t200*(B_3_y*n_3_z - B_3_z*n_3_y)
    h_rx_x_3 = (
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx
        + t240
    )
    t241 = t203*(B_4_y*n_4_z - B_4_z*n_4_y)
    h_rx_x_4 = (
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx
        + t241
    )
    t242 = t206*(B_5_y*n_5_z - B_5_z*n_5_y)
    h_rx_x_5 = (
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx
        + t242
    )
    t243 = t209*(B_6_y*n_6_z - B_6_z*n_6_y)
    h_rx_x_6 = (
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx
        + t243
    )
    t244 = t194*(-B_1_x*n_1_z + B_1_z*n_1_x)
    h_ry_x_1 = (
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry
        + t244
    )
    t245 = t197*(-B_2_x*n_2_z + B_2_z*n_2_x)
    h_ry_x_2 = (
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry
        + t245
    )
    t246 = t200*(-B_3_x*n_3_z + B_3_z*n_3_x)
    h_ry_x_3 = (
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry
        + t246
    )
    t247 = t203*(-B_4_x*n_4_z + B_4_z*n_4_x)
    h_ry_x_4 = (
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry
        + t247
    )
    t248 = t206*(-B_5_x*n_5_z + B_5_z*n_5_x)
    h_ry_x_5 = (
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry
        + t248
    )
    t249 = t209*(-B_6_x*n_6_z + B_6_z*n_6_x)
    h_ry_x_6 = (
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry
        + t249
    )
    t250 = t194*(B_1_x*n_1_y - B_1_y*n_1_x)
    h_rz_x_1 = (
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz
        + t250
    )
    t251 = t197*(B_2_x*n_2_y - B_2_y*n_2_x)
    h_rz_x_2 = (
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz
        + t251
    )
    t252 = t200*(B_3_x*n_3_y - B_3_y*n_3_x)
    h_rz_x_3 = (
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz
        + t252
    )
    t253 = t203*(B_4_x*n_4_y - B_4_y*n_4_x)
    h_rz_x_4 = (
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz
        + t253
    )
    t254 = t206*(B_5_x*n_5_y - B_5_y*n_5_x)
    h_rz_x_5 = (
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz
        + t254
    )
    t255 = t209*(B_6_x*n_6_y - B_6_y*n_6_x)
    h_rz_x_6 = (
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz
        + t255
    )
    t256 = B_1_z*mu_1*n_1_x - t160
    t257 = B_2_z*mu_2*n_2_x - t161
    t258 = B_3_z*mu_3*n_3_x - t162
    t259 = B_4_z*mu_4*n_4_x - t163
    t260 = B_5_z*mu_5*n_5_x - t164
    t261 = R_p_1**2
    t262 = k_1_1*t261
    t263 = R_p_2**2
    t264 = k_2_1*t263
    t265 = R_p_3**2
    t266 = k_3_1*t265
    t267 = R_p_4**2
    t268 = k_4_1*t267
    t269 = R_p_5**2
    t270 = k_5_1*t269
    t271 = R_p_6**2
    t272 = k_6_1*t271
    M_out = np.zeros((*batch, 18, 18), dtype)
    M_out[..., 0, 0] = (
        D_p_rx_1*h_rx_x_1 + D_p_rx_1*t238 + D_p_ry_1*h_ry_x_1 + D_p_ry_1*t244 + D_p_rz_1*h_rz_x_1
        + D_p_rz_1*t250 + D_p_x_1*h_x_x_1 + D_p_x_1*t220 + D_p_y_1*h_y_x_1 + D_p_y_1*t226 + D_p_z_1*h_z_x_1
        + D_p_z_1*t232 + m_t_1 + t172
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_rx_1*h_rx_x_2 + D_p_rx_2*t238 + D_p_ry_1*h_ry_x_2 + D_p_ry_2*t244 + D_p_rz_1*h_rz_x_2
        + D_p_rz_2*t250 + D_p_x_1*h_x_x_2 + D_p_x_2*t220 + D_p_y_1*h_y_x_2 + D_p_y_2*t226 + D_p_z_1*h_z_x_2
        + D_p_z_2*t232
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_rx_1*h_rx_x_3 + D_p_rx_3*t238 + D_p_ry_1*h_ry_x_3 + D_p_ry_3*t244 + D_p_rz_1*h_rz_x_3
        + D_p_rz_3*t250 + D_p_x_1*h_x_x_3 + D_p_x_3*t220 + D_p_y_1*h_y_x_3 + D_p_y_3*t226 + D_p_z_1*h_z_x_3
        + D_p_z_3*t232
    )
    M_out[..., 0, 3] = M_out[..., 3, 0] = (
        D_p_rx_1*h_rx_x_4 + D_p_rx_4*t238 + D_p_ry_1*h_ry_x_4 + D_p_ry_4*t244 + D_p_rz_1*h_rz_x_4
        + D_p_rz_4*t250 + D_p_x_1*h_x_x_4 + D_p_x_4*t220 + D_p_y_1*h_y_x_4 + D_p_y_4*t226 + D_p_z_1*h_z_x_4
        + D_p_z_4*t232
    )
    M_out[..., 0, 4] = M_out[..., 4, 0] = (
        D_p_rx_1*h_rx_x_5 + D_p_rx_5*t238 + D_p_ry_1*h_ry_x_5 + D_p_ry_5*t244 + D_p_rz_1*h_rz_x_5
        + D_p_rz_5*t250 + D_p_x_1*h_x_x_5 + D_p_x_5*t220 + D_p_y_1*h_y_x_5 + D_p_y_5*t226 + D_p_z_1*h_z_x_5
        + D_p_z_5*t232
    )
    M_out[..., 0, 5] = M_out[..., 5, 0] = (
        D_p_rx_1*h_rx_x_6 + D_p_rx_6*t238 + D_p_ry_1*h_ry_x_6 + D_p_ry_6*t244 + D_p_rz_1*h_rz_x_6
        + D_p_rz_6*t250 + D_p_x_1*h_x_x_6 + D_p_x_6*t220 + D_p_y_1*h_y_x_6 + D_p_y_6*t226 + D_p_z_1*h_z_x_6
        + D_p_z_6*t232
    )
    M_out[..., 1, 1] = (
        D_p_rx_2*h_rx_x_2 + D_p_rx_2*t239 + D_p_ry_2*h_ry_x_2 + D_p_ry_2*t245 + D_p_rz_2*h_rz_x_2
        + D_p_rz_2*t251 + D_p_x_2*h_x_x_2 + D_p_x_2*t221 + D_p_y_2*h_y_x_2 + D_p_y_2*t227 + D_p_z_2*h_z_x_2
        + D_p_z_2*t233 + m_t_2 + t173
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_rx_2*h_rx_x_3 + D_p_rx_3*t239 + D_p_ry_2*h_ry_x_3 + D_p_ry_3*t245 + D_p_rz_2*h_rz_x_3
        + D_p_rz_3*t251 + D_p_x_2*h_x_x_3 + D_p_x_3*t221 + D_p_y_2*h_y_x_3 + D_p_y_3*t227 + D_p_z_2*h_z_x_3
        + D_p_z_3*t233
    )
    M_out[..., 1, 3] = M_out[..., 3, 1] = (
        D_p_rx_2*h_rx_x_4 + D_p_rx_4*t239 + D_p_ry_2*h_ry_x_4 + D_p_ry_4*t245 + D_p_rz_2*h_rz_x_4
        + D_p_rz_4*t251 + D_p_x_2*h_x_x_4 + D_p_x_4*t221 + D_p_y_2*h_y_x_4 + D_p_y_4*t227 + D_p_z_2*h_z_x_4
        + D_p_z_4*t233
    )
    M_out[..., 1, 4] = M_out[..., 4, 1] = (
        D_p_rx_2*h_rx_x_5 + D_p_rx_5*t239 + D_p_ry_2*h_ry_x_5 + D_p_ry_5*t245 + D_p_rz_2*h_rz_x_5
        + D_p_rz_5*t251 + D_p_x_2*h_x_x_5 + D_p_x_5*t221 + D_p_y_2*h_y_x_5 + D_p_y_5*t227 + D_p_z_2*h_z_x_5
        + D_p_z_5*t233
    )
    M_out[..., 1, 5] = M_out[..., 5, 1] = (
        D_p_rx_2*h_rx_x_6 + D_p_rx_6*t239 + D_p_ry_2*h_ry_x_6 + D_p_ry_6*t245 + D_p_rz_2*h_rz_x_6
        + D_p_rz_6*t251 + D_p_x_2*h_x_x_6 + D_p_x_6*t221 + D_p_y_2*h_y_x_6 + D_p_y_6*t227 + D_p_z_2*h_z_x_6
        + D_p_z_6*t233
    )
    M_out[..., 2, 2] = (
        D_p_rx_3*h_rx_x_3 + D_p_rx_3*t240 + D_p_ry_3*h_ry_x_3 + D_p_ry_3*t246 + D_p_rz_3*h_rz_x_3
        + D_p_rz_3*t252 + D_p_x_3*h_x_x_3 + D_p_x_3*t222 + D_p_y_3*h_y_x_3 + D_p_y_3*t228 + D_p_z_3*h_z_x_3
        + D_p_z_3*t234 + m_t_3 + t174
    )
    M_out[..., 2, 3] = M_out[..., 3, 2] = (
        D_p_rx_3*h_rx_x_4 + D_p_rx_4*t240 + D_p_ry_3*h_ry_x_4 + D_p_ry_4*t246 + D_p_rz_3*h_rz_x_4
        + D_p_rz_4*t252 + D_p_x_3*h_x_x_4 + D_p_x_4*t222 + D_p_y_3*h_y_x_4 + D_p_y_4*t228 + D_p_z_3*h_z_x_4
        + D_p_z_4*t234
    )
    M_out[..., 2, 4] = M_out[..., 4, 2] = (
        D_p_rx_3*h_rx_x_5 + D_p_rx_5*t240 + D_p_ry_3*h_ry_x_5 + D_p_ry_5*t246 + D_p_rz_3*h_rz_x_5
        + D_p_rz_5*t252 + D_p_x_3*h_x_x_5 + D_p_x_5*t222 + D_p_y_3*h_y_x_5 + D_p_y_5*t228 + D_p_z_3*h_z_x_5
        + D_p_z_5*t234
    )
    M_out[..., 2, 5] = M_out[..., 5, 2] = (
        D_p_rx_3*h_rx_x_6 + D_p_rx_6*t240 + D_p_ry_3*h_ry_x_6 + D_p_ry_6*t246 + D_p_rz_3*h_rz_x_6
        + D_p_rz_6*t252 + D_p_x_3*h_x_x_6 + D_p_x_6*t222 + D_p_y_3*h_y_x_6 + D_p_y_6*t228 + D_p_z_3*h_z_x_6
        + D_p_z_6*t234
    )
    M_out[..., 3, 3] = (
        D_p_rx_4*h_rx_x_4 + D_p_rx_4*t241 + D_p_ry_4*h_ry_x_4 + D_p_ry_4*t247 + D_p_rz_4*h_rz_x_4
        + D_p_rz_4*t253 + D_p_x_4*h_x_x_4 + D_p_x_4*t223 + D_p_y_4*h_y_x_4 + D_p_y_4*t229 + D_p_z_4*h_z_x_4
        + D_p_z_4*t235 + m_t_4 + t175
    )
    M_out[..., 3, 4] = M_out[..., 4, 3] = (
        D_p_rx_4*h_rx_x_5 + D_p_rx_5*t241 + D_p_ry_4*h_ry_x_5 + D_p_ry_5*t247 + D_p_rz_4*h_rz_x_5
        + D_p_rz_5*t253 + D_p_x_4*h_x_x_5 + D_p_x_5*t223 + D_p_y_4*h_y_x_5 + D_p_y_5*t229 + D_p_z_4*h_z_x_5
        + D_p_z_5*t235
    )
    M_out[..., 3, 5] = M_out[..., 5, 3] = (
        D_p_rx_4*h_rx_x_6 + D_p_rx_6*t241 + D_p_ry_4*h_ry_x_6 + D_p_ry_6*t247 + D_p_rz_4*h_rz_x_6
        + D_p_rz_6*t253 + D_p_x_4*h_x_x_6 + D_p_x_6*t223 + D_p_y_4*h_y_x_6 + D_p_y_6*t229 + D_p_z_4*h_z_x_6
        + D_p_z_6*t235
    )
    M_out[..., 4, 4] = (
        D_p_rx_5*h_rx_x_5 + D_p_rx_5*t242 + D_p_ry_5*h_ry_x_5 + D_p_ry_5*t248 + D_p_rz_5*h_rz_x_5
        + D_p_rz_5*t254 + D_p_x_5*h_x_x_5 + D_p_x_5*t224 + D_p_y_5*h_y_x_5 + D_p_y_5*t230 + D_p_z_5*h_z_x_5
        + D_p_z_5*t236 + m_t_5 + t176
    )
    M_out[..., 4, 5] = M_out[..., 5, 4] = (
        D_p_rx_5*h_rx_x_6 + D_p_rx_6*t242 + D_p_ry_5*h_ry_x_6 + D_p_ry_6*t248 + D_p_rz_5*h_rz_x_6
        + D_p_rz_6*t254 + D_p_x_5*h_x_x_6 + D_p_x_6*t224 + D_p_y_5*h_y_x_6 + D_p_y_6*t230 + D_p_z_5*h_z_x_6
        + D_p_z_6*t236
    )
    M_out[..., 5, 5] = (
        D_p_rx_6*h_rx_x_6 + D_p_rx_6*t243 + D_p_ry_6*h_ry_x_6 + D_p_ry_6*t249 + D_p_rz_6*h_rz_x_6
        + D_p_rz_6*t255 + D_p_x_6*h_x_x_6 + D_p_x_6*t225 + D_p_y_6*h_y_x_6 + D_p_y_6*t231 + D_p_z_6*h_z_x_6
        + D_p_z_6*t237 + m_t_6 + t177
    )
    M_out[..., 6, 6] = I_1_1
    M_out[..., 7, 7] = I_2_1
    M_out[..., 8, 8] = I_3_1
    M_out[..., 9, 9] = I_4_1
    M_out[..., 10, 10] = I_5_1
    M_out[..., 11, 11] = I_6_1
    M_out[..., 12, 12] = I_1_2
    M_out[..., 13, 13] = I_2_2
    M_out[..., 14, 14] = I_3_2
    M_out[..., 15, 15] = I_4_2
    M_out[..., 16, 16] = I_5_2
    M_out[..., 17, 17] = I_6_2
    K_out = np.zeros((*batch, 18, 18), dtype)
    K_out[..., 0, 0] = (
        D_p_rx_1*f_rx_x_1 + D_p_rx_1*t154 + D_p_ry_1*f_ry_x_1 + D_p_ry_1*t256 + D_p_rz_1*f_rz_x_1
        + D_p_rz_1*t166 + D_p_x_1*f_x_x_1 + D_p_x_1*t136 + D_p_y_1*f_y_x_1 + D_p_y_1*t142 + D_p_z_1*f_z_x_1
        + D_p_z_1*t148 + k_1_2 + k_1_3 - mu_1*n_1_x**2 - mu_1*n_1_y**2 - mu_1*n_1_z**2
    )
    K_out[..., 0, 1] = K_out[..., 1, 0] = (
        D_p_rx_1*f_rx_x_2 + D_p_rx_2*t154 + D_p_ry_1*f_ry_x_2 + D_p_ry_2*t256 + D_p_rz_1*f_rz_x_2
        + D_p_rz_2*t166 + D_p_x_1*f_x_x_2 + D_p_x_2*t136 + D_p_y_1*f_y_x_2 + D_p_y_2*t142 + D_p_z_1*f_z_x_2
        + D_p_z_2*t148
    )
    K_out[..., 0, 2] = K_out[..., 2, 0] = (
        D_p_rx_1*f_rx_x_3 + D_p_rx_3*t154 + D_p_ry_1*f_ry_x_3 + D_p_ry_3*t256 + D_p_rz_1*f_rz_x_3
        + D_p_rz_3*t166 + D_p_x_1*f_x_x_3 + D_p_x_3*t136 + D_p_y_1*f_y_x_3 + D_p_y_3*t142 + D_p_z_1*f_z_x_3
        + D_p_z_3*t148
    )
    K_out[..., 0, 3] = K_out[..., 3, 0] = (
        D_p_rx_1*f_rx_x_4 + D_p_rx_4*t154 + D_p_ry_1*f_ry_x_4 + D_p_ry_4*t256 + D_p_rz_1*f_rz_x_4
        + D_p_rz_4*t166 + D_p_x_1*f_x_x_4 + D_p_x_4*t136 + D_p_y_1*f_y_x_4 + D_p_y_4*t142 + D_p_z_1*f_z_x_4
        + D_p_z_4*t148
    )
    K_out[..., 0, 4] = K_out[..., 4, 0] = (
        D_p_rx_1*f_rx_x_5 + D_p_rx_5*t154 + D_p_ry_1*f_ry_x_5 + D_p_ry_5*t256 + D_p_rz_1*f_rz_x_5
        + D_p_rz_5*t166 + D_p_x_1*f_x_x_5 + D_p_x_5*t136 + D_p_y_1*f_y_x_5 + D_p_y_5*t142 + D_p_z_1*f_z_x_5
        + D_p_z_5*t148
    )
    K_out[..., 0, 5] = K_out[..., 5, 0] = (
        D_p_rx_1*f_rx_x_6 + D_p_rx_6*t154 + D_p_ry_1*f_ry_x_6 + D_p_ry_6*t256 + D_p_rz_1*f_rz_x_6
        + D_p_rz_6*t166 + D_p_x_1*f_x_x_6 + D_p_x_6*t136 + D_p_y_1*f_y_x_6 + D_p_y_6*t142 + D_p_z_1*f_z_x_6
        + D_p_z_6*t148
    )
    K_out[..., 0, 6] = K_out[..., 6, 0] = -R_p_1*k_1_3
    K_out[..., 0, 12] = K_out[..., 12, 0] = -R_p_1*k_1_2
    K_out[..., 1, 1] = (
        D_p_rx_2*f_rx_x_2 + D_p_rx_2*t155 + D_p_ry_2*f_ry_x_2 + D_p_ry_2*t257 + D_p_rz_2*f_rz_x_2
        + D_p_rz_2*t167 + D_p_x_2*f_x_x_2 + D_p_x_2*t137 + D_p_y_2*f_y_x_2 + D_p_y_2*t143 + D_p_z_2*f_z_x_2
        + D_p_z_2*t149 + k_2_2 + k_2_3 - mu_2*n_2_x**2 - mu_2*n_2_y**2 - mu_2*n_2_z**2
    )
    K_out[..., 1, 2] = K_out[..., 2, 1] = (
        D_p_rx_2*f_rx_x_3 + D_p_rx_3*t155 + D_p_ry_2*f_ry_x_3 + D_p_ry_3*t257 + D_p_rz_2*f_rz_x_3
        + D_p_rz_3*t167 + D_p_x_2*f_x_x_3 + D_p_x_3*t137 + D_p_y_2*f_y_x_3 + D_p_y_3*t143 + D_p_z_2*f_z_x_3
        + D_p_z_3*t149
    )
    K_out[..., 1, 3] = K_out[..., 3, 1] = (
        D_p_rx_2*f_rx_x_4 + D_p_rx_4*t155 + D_p_ry_2*f_ry_x_4 + D_p_ry_4*t257 + D_p_rz_2*f_rz_x_4
        + D_p_rz_4*t167 + D_p_x_2*f_x_x_4 + D_p_x_4*t137 + D_p_y_2*f_y_x_4 + D_p_y_4*t143 + D_p_z_2*f_z_x_4
        + D_p_z_4*t149
    )
    K_out[..., 1, 4] = K_out[..., 4, 1] = (
        D_p_rx_2*f_rx_x_5 + D_p_rx_5*t155 + D_p_ry_2*f_ry_x_5 + D_p_ry_5*t257 + D_p_rz_2*f_rz_x_5
        + D_p_rz_5*t167 + D_p_x_2*f_x_x_5 + D_p_x_5*t137 + D_p_y_2*f_y_x_5 + D_p_y_5*t143 + D_p_z_2*f_z_x_5
        + D_p_z_5*t149
    )
    K_out[..., 1, 5] = K_out[..., 5, 1] = (
        D_p_rx_2*f_rx_x_6 + D_p_rx_6*t155 + D_p_ry_2*f_ry_x_6 + D_p_ry_6*t257 + D_p_rz_2*f_rz_x_6
        + D_p_rz_6*t167 + D_p_x_2*f_x_x_6 + D_p_x_6*t137 + D_p_y_2*f_y_x_6 + D_p_y_6*t143 + D_p_z_2*f_z_x_6
        + D_p_z_6*t149
    )
    K_out[..., 1, 7] = K_out[..., 7, 1] = -R_p_2*k_2_3
    K_out[..., 1, 13] = K_out[..., 13, 1] = -R_p_2*k_2_2
    K_out[..., 2, 2] = (
        D_p_rx_3*f_rx_x_3 + D_p_rx_3*t156 + D_p_ry_3*f_ry_x_3 + D_p_ry_3*t258 + D_p_rz_3*f_rz_x_3
        + D_p_rz_3*t168 + D_p_x_3*f_x_x_3 + D_p_x_3*t138 + D_p_y_3*f_y_x_3 + D_p_y_3*t144 + D_p_z_3*f_z_x_3
        + D_p_z_3*t150 + k_3_2 + k_3_3 - mu_3*n_3_x**2 - mu_3*n_3_y**2 - mu_3*n_3_z**2
    )
    K_out[..., 2, 3] = K_out[..., 3, 2] = (
        D_p_rx_3*f_rx_x_4 + D_p_rx_4*t156 + D_p_ry_3*f_ry_x_4 + D_p_ry_4*t258 + D_p_rz_3*f_rz_x_4
        + D_p_rz_4*t168 + D_p_x_3*f_x_x_4 + D_p_x_4*t138 + D_p_y_3*f_y_x_4 + D_p_y_4*t144 + D_p_z_3*f_z_x_4
        + D_p_z_4*t150
    )
    K_out[..., 2, 4] = K_out[..., 4, 2] = (
        D_p_rx_3*f_rx_x_5 + D_p_rx_5*t156 + D_p_ry_3*f_ry_x_5 + D_p_ry_5*t258 + D_p_rz_3*f_rz_x_5
        + D_p_rz_5*t168 + D_p_x_3*f_x_x_5 + D_p_x_5*t138 + D_p_y_3*f_y_x_5 + D_p_y_5*t144 + D_p_z_3*f_z_x_5
        + D_p_z_5*t150
    )
    K_out[..., 2, 5] = K_out[..., 5, 2] = (
        D_p_rx_3*f_rx_x_6 + D_p_rx_6*t156 + D_p_ry_3*f_ry_x_6 + D_p_ry_6*t258 + D_p_rz_3*f_rz_x_6
        + D_p_rz_6*t168 + D_p_x_3*f_x_x_6 + D_p_x_6*t138 + D_p_y_3*f_y_x_6 + D_p_y_6*t144 + D_p_z_3*f_z_x_6
        + D_p_z_6*t150
    )
    K_out[..., 2, 8] = K_out[..., 8, 2] = -R_p_3*k_3_3
    K_out[..., 2, 14] = K_out[..., 14, 2] = -R_p_3*k_3_2
    K_out[..., 3, 3] = (
        D_p_rx_4*f_rx_x_4 + D_p_rx_4*t157 + D_p_ry_4*f_ry_x_4 + D_p_ry_4*t259 + D_p_rz_4*f_rz_x_4
        + D_p_rz_4*t169 + D_p_x_4*f_x_x_4 + D_p_x_4*t139 + D_p_y_4*f_y_x_4 + D_p_y_4*t145 + D_p_z_4*f_z_x_4
        + D_p_z_4*t151 + k_4_2 + k_4_3 - mu_4*n_4_x**2 - mu_4*n_4_y**2 - mu_4*n_4_z**2
    )
    K_out[..., 3, 4] = K_out[..., 4, 3] = (
        D_p_rx_4*f_rx_x_5 + D_p_rx_5*t157 + D_p_ry_4*f_ry_x_5 + D_p_ry_5*t259 + D_p_rz_4*f_rz_x_5
        + D_p_rz_5*t169 + D_p_x_4*f_x_x_5 + D_p_x_5*t139 + D_p_y_4*f_y_x_5 + D_p_y_5*t145 + D_p_z_4*f_z_x_5
        + D_p_z_5*t151
    )
    K_out[..., 3, 5] = K_out[..., 5, 3] = (
        D_p_rx_4*f_rx_x_6 + D_p_rx_6*t157 + D_p_ry_4*f_ry_x_6 + D_p_ry_6*t259 + D_p_rz_4*f_rz_x_6
        + D_p_rz_6*t169 + D_p_x_4*f_x_x_6 + D_p_x_6*t139 + D_p_y_4*f_y_x_6 + D_p_y_6*t145 + D_p_z_4*f_z_x_6
        + D_p_z_6*t151
    )
    K_out[..., 3, 9] = K_out[..., 9, 3] = -R_p_4*k_4_3
    K_out[..., 3, 15] = K_out[..., 15, 3] = -R_p_4*k_4_2
    K_out[..., 4, 4] = (
        D_p_rx_5*f_rx_x_5 + D_p_rx_5*t158 + D_p_ry_5*f_ry_x_5 + D_p_ry_5*t260 + D_p_rz_5*f_rz_x_5
        + D_p_rz_5*t170 + D_p_x_5*f_x_x_5 + D_p_x_5*t140 + D_p_y_5*f_y_x_5 + D_p_y_5*t146 + D_p_z_5*f_z_x_5
        + D_p_z_5*t152 + k_5_2 + k_5_3 - mu_5*n_5_x**2 - mu_5*n_5_y**2 - mu_5*n_5_z**2
    )
    K_out[..., 4, 5] = K_out[..., 5, 4] = (
        D_p_rx_5*f_rx_x_6 + D_p_rx_6*t158 + D_p_ry_5*f_ry_x_6 + D_p_ry_6*t260 + D_p_rz_5*f_rz_x_6
        + D_p_rz_6*t170 + D_p_x_5*f_x_x_6 + D_p_x_6*t140 + D_p_y_5*f_y_x_6 + D_p_y_6*t146 + D_p_z_5*f_z_x_6
        + D_p_z_6*t152
    )
    K_out[..., 4, 10] = K_out[..., 10, 4] = -R_p_5*k_5_3
    K_out[..., 4, 16] = K_out[..., 16, 4] = -R_p_5*k_5_2
    K_out[..., 5, 5] = (
        D_p_rx_6*f_rx_x_6 + D_p_rx_6*t159 + D_p_ry_6*f_ry_x_6 + D_p_ry_6*(B_6_z*mu_6*n_6_x - t165)
        + D_p_rz_6*f_rz_x_6 + D_p_rz_6*t171 + D_p_x_6*f_x_x_6 + D_p_x_6*t141 + D_p_y_6*f_y_x_6 + D_p_y_6*t147
        + D_p_z_6*f_z_x_6 + D_p_z_6*t153 + k_6_2 + k_6_3 - mu_6*n_6_x**2 - mu_6*n_6_y**2 - mu_6*n_6_z**2
    )
    K_out[..., 5, 11] = K_out[..., 11, 5] = -R_p_6*k_6_3
    K_out[..., 5, 17] = K_out[..., 17, 5] = -R_p_6*k_6_2
    K_out[..., 6, 6] = k_1_3*t261 + t262
    K_out[..., 6, 12] = K_out[..., 12, 6] = -t262
    K_out[..., 7, 7] = k_2_3*t263 + t264
    K_out[..., 7, 13] = K_out[..., 13, 7] = -t264
    K_out[..., 8, 8] = k_3_3*t265 + t266
    K_out[..., 8, 14] = K_out[..., 14, 8] = -t266
    K_out[..., 9, 9] = k_4_3*t267 + t268
    K_out[..., 9, 15] = K_out[..., 15, 9] = -t268
    K_out[..., 10, 10] = k_5_3*t269 + t270
    K_out[..., 10, 16] = K_out[..., 16, 10] = -t270
    K_out[..., 11, 11] = k_6_3*t271 + t272
    K_out[..., 11, 17] = K_out[..., 17, 11] = -t272
    K_out[..., 12, 12] = k_1_2*t261 + t262
    K_out[..., 13, 13] = k_2_2*t263 + t264
    K_out[..., 14, 14] = k_3_2*t265 + t266
    K_out[..., 15, 15] = k_4_2*t267 + t268
    K_out[..., 16, 16] = k_5_2*t269 + t270
    K_out[..., 17, 17] = k_6_2*t271 + t272
    return M_out, K_out
