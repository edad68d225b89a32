# Generated from the derivation of rotary_delta.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism rotary_delta, for a robot given by its parameters.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: axis j; coordinate k of a derivative; coordinate l of a second derivative;
component i = x, y, z.  t1, t2, ... are subexpressions shared by several values.

* theta_j [rad]: angle of arm j
* y_j_i [1]: direction of arm j at theta_j = 90 deg: a_j times z_j, component i
* c_j [1]: cosine of theta_j
* sn_j [1]: sine of theta_j
* d_j_i [1]: direction of arm j, component i
* t_j_i [1]: direction in which the end of arm j moves, component i
* r_j_i [m]: platform joint j relative to the origin of arm j, component i
* s_j_i [m]: linkage vector j, from arm to platform joint, component i
* A_j [m]: component of r_j along z_j
* B_j [m]: component of r_j along y_j
* C_j [m]: component of r_j along the arm when the loop is closed
* rho2_j [m^2]: squared length of the part of r_j in the plane of the arm
* S_j [m]: component of r_j in that plane, perpendicular to the arm
* tau_st_j [N m]: static torque on motor j, seen at the arm
* I_j [kg m^2]: moment of inertia of motor j, seen at the arm
* S_j_i [m]: centre of sphere j, on which the platform centre lies, component i
* alpha_i [m]: vector from sphere centre 1 to sphere centre 2, component i
* beta_i [m]: vector from sphere centre 1 to sphere centre 3, component i
* nu_i [m^2]: normal to the plane of the sphere centres, component i
* nu2 [m^4]: squared length of nu
* h_j [m^2]: scalar product of p - S_1 with the vector from sphere centre 1 to sphere centre j
* q_i [m]: projection of p onto the plane of the sphere centres, relative to S_1, component i
* v_p_i [m/s]: velocity of the platform, component i
* D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
* U_j_i_k [m]: derivative of linkage vector j, component i, with respect to theta_k
* f_j_kl [m^2]: right-hand side of closure j, differentiated with respect to theta_k and theta_l
* P_i_kl [m]: second derivative of p_i with respect to theta_k and theta_l
* s_dot_j_i [m/s]: rate of change of linkage vector j, component i
* D_p_dot_i_k [m/s]: time derivative of dp_i/dtheta_k
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* G_j [N m]: gradient of the gravitational potential energy with respect to theta_j
* phi_j_st [rad]: static angle of motor j divided by the gear ratio, relative to the unstrained transmissions
"""

from math import prod
from typing import NamedTuple

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "Parameters",
    "RIGID_MODES",
    "constraint_jacobians",
    "direct_kinematics",
    "elastic_gradient",
    "elastic_hessian",
    "elastic_potential",
    "gravity_gradient",
    "gravity_hessian",
    "gravity_potential",
    "inertia_margin",
    "inverse_kinematics",
    "jacobian_condition",
    "kinetic_energy",
    "limit_margin",
    "link_jacobians",
    "mass_matrix",
    "modal_matrices",
    "perpendicular_margin",
    "platform_jacobian",
    "platform_jacobian_rate",
    "platform_second_derivatives",
    "reach_margin",
    "static_equilibrium",
    "stiffness_matrix",
    "velocity_forces",
]

#: Generalised coordinates, in the order of M and K, and their units.
COORDINATES = (
    "theta_1",
    "theta_2",
    "theta_3",
    "phi_1",
    "phi_2",
    "phi_3",
)
COORDINATE_UNITS = (
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
        Point of the axis of arm j where the arm starts.
    axis : array, shape (..., 3, 3) [1]
        Unit vector of rotation of arm j.
    zero : array, shape (..., 3, 3) [1]
        Direction of arm j at theta_j = 0.
    joint : array, shape (..., 3, 3) [m]
        Platform joint j relative to the platform centre.
    arm_length : array, shape (..., 3) [m]
        Length of arm j, to the joint of the linkage.
    arm_mass : array, shape (..., 3) [kg]
        Mass of arm j.
    arm_center : array, shape (..., 3) [m]
        Distance of the centre of mass of arm j from its axis, along the arm.
    arm_inertia : array, shape (..., 3) [kg m^2]
        Moment of inertia of arm j about its axis.
    link_length : array, shape (..., 3) [m]
        Length of linkage j.
    link_mass : array, shape (..., 3) [kg]
        Mass of linkage j, both rods together.
    reducer_stiffness : array, shape (..., 3) [N m/rad]
        Torsional stiffness of reducer j, seen at the arm.
    motor_inertia : array, shape (..., 3) [kg m^2]
        Moment of inertia of motor j at its shaft.
    gear_ratio : array, shape (..., 3) [1]
        Gear ratio of axis j, motor over arm.
    limits : array, shape (..., 3, 2) [rad]
        min(theta_j), max(theta_j).
    branch : array, shape (..., 3) [1]
        Branch of axis j: +1 or -1, the side to which the arm bends.
    """

    platform_mass: float
    gravity: np.ndarray
    origin: np.ndarray
    axis: np.ndarray
    zero: np.ndarray
    joint: np.ndarray
    arm_length: np.ndarray
    arm_mass: np.ndarray
    arm_center: np.ndarray
    arm_inertia: np.ndarray
    link_length: np.ndarray
    link_mass: np.ndarray
    reducer_stiffness: np.ndarray
    motor_inertia: np.ndarray
    gear_ratio: np.ndarray
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


def _arctan2(y, x):
    """Return np.arctan2; for complex arguments, to first order in their imaginary parts, for complex steps."""
    angle = np.arctan2(np.real(y), np.real(x))
    if not (np.iscomplexobj(y) or np.iscomplexobj(x)):
        return angle
    rate = np.real(x) * np.imag(y) - np.real(y) * np.imag(x)
    return angle + 1j * rate / (np.real(x) ** 2 + np.real(y) ** 2)


def inverse_kinematics(p, parameters):
    """Arm angles at a pose.

    NaN if the pose is out of reach (see `reach_margin`).

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    theta : array, shape (..., 3) [rad]
        Arm angles theta_1, theta_2, theta_3.

    Notes
    -----
    Equations 1 to 3.
    162 operations; 855 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    theta_1 = _arctan2(sn_1, c_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    theta_2 = _arctan2(sn_2, c_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    theta_3 = _arctan2(sn_3, c_3)
    theta_out = np.empty((*batch, 3), dtype)
    theta_out[..., 0] = theta_1
    theta_out[..., 1] = theta_2
    theta_out[..., 2] = theta_3
    return theta_out


def reach_margin(p, parameters):
    """Margins of the length of each linkage above its minimum and below its maximum.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 3, 2) [m]
        For each axis; at least zero if satisfied.

    Notes
    -----
    Distance of the platform joint from the nearest and the farthest point of the arm's circle.
    141 operations; 330 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t1 = 2*L_a_1*np.sqrt(rho2_1)
    t2 = L_a_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2
    t3 = 2*L_a_2*np.sqrt(rho2_2)
    t4 = L_a_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2
    t5 = 2*L_a_3*np.sqrt(rho2_3)
    t6 = L_a_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2
    margin_out = np.empty((*batch, 3, 2), dtype)
    margin_out[..., 0, 0] = l_d_1 - np.sqrt(-t1 + t2)
    margin_out[..., 0, 1] = -l_d_1 + np.sqrt(t1 + t2)
    margin_out[..., 1, 0] = l_d_2 - np.sqrt(-t3 + t4)
    margin_out[..., 1, 1] = -l_d_2 + np.sqrt(t3 + t4)
    margin_out[..., 2, 0] = l_d_3 - np.sqrt(-t5 + t6)
    margin_out[..., 2, 1] = -l_d_3 + np.sqrt(t5 + t6)
    return margin_out


def limit_margin(p, parameters):
    """Distance of each arm from its limits.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 3, 2) [rad]
        For each axis; at least zero if satisfied.

    Notes
    -----
    Both ends of the limits.
    168 operations; 1716 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    (
        theta_min_1, theta_max_1, theta_min_2, theta_max_2, theta_min_3, theta_max_3,
    ) = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, theta_min_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    theta_1 = _arctan2(sn_1, c_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    theta_2 = _arctan2(sn_2, c_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    theta_3 = _arctan2(sn_3, c_3)
    margin_out = np.empty((*batch, 3, 2), dtype)
    margin_out[..., 0, 0] = theta_1 - theta_min_1
    margin_out[..., 0, 1] = -theta_1 + theta_max_1
    margin_out[..., 1, 0] = theta_2 - theta_min_2
    margin_out[..., 1, 1] = -theta_2 + theta_max_2
    margin_out[..., 2, 0] = theta_3 - theta_min_3
    margin_out[..., 2, 1] = -theta_3 + theta_max_3
    return margin_out


def perpendicular_margin(parameters):
    """Margin for the zero direction of each arm to be perpendicular to its axis.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 3) [1]
        At least zero for perpendicular directions.

    Notes
    -----
    |a_j . z_j| is at most 1e-6: (1e-6)^2 - (a_j . z_j)^2.
    24 operations; 24 with every named value expanded.
    """
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    batch, dtype = _batch(a_1_x, z_1_x)
    margin_out = np.empty((*batch, 3), dtype)
    margin_out[..., 0] = 1/1000000000000 - (a_1_x*z_1_x + a_1_y*z_1_y + a_1_z*z_1_z)**2
    margin_out[..., 1] = 1/1000000000000 - (a_2_x*z_2_x + a_2_y*z_2_y + a_2_z*z_2_z)**2
    margin_out[..., 2] = 1/1000000000000 - (a_3_x*z_3_x + a_3_y*z_3_y + a_3_z*z_3_z)**2
    return margin_out


def inertia_margin(parameters):
    """Moment of inertia of each arm minus that of a point mass at its centre of mass.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    margin : array, shape (..., 3) [kg m^2]
        At least zero for a physical body.

    Notes
    -----
    The parallel axis theorem.
    9 operations; 9 with every named value expanded.
    """
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    I_a_1, I_a_2, I_a_3 = _entries(parameters.arm_inertia, (3,))
    batch, dtype = _batch(m_a_1, r_a_1, I_a_1)
    margin_out = np.empty((*batch, 3), dtype)
    margin_out[..., 0] = I_a_1 - m_a_1*r_a_1**2
    margin_out[..., 1] = I_a_2 - m_a_2*r_a_2**2
    margin_out[..., 2] = I_a_3 - m_a_3*r_a_3**2
    return margin_out


def direct_kinematics(theta, assembly, parameters):
    """Platform centre in the base frame for given arm angles.

    NaN if the three spheres do not intersect.

    Parameters
    ----------
    theta : array, shape (..., 3) [rad]
        Arm angles theta_1, theta_2, theta_3.
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
    183 operations; 12486 with every named value expanded.
    """
    theta_1, theta_2, theta_3 = _entries(theta, (3,))
    (assembly,) = _entries(assembly, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    batch, dtype = _batch(theta_1, assembly, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1)
    t1 = np.cos(theta_1)
    t2 = np.sin(theta_1)
    S_1_x = L_a_1*(t1*z_1_x + t2*(a_1_y*z_1_z - a_1_z*z_1_y)) - b_1_x + o_1_x
    S_1_y = L_a_1*(t1*z_1_y + t2*(-a_1_x*z_1_z + a_1_z*z_1_x)) - b_1_y + o_1_y
    S_1_z = L_a_1*(t1*z_1_z + t2*(a_1_x*z_1_y - a_1_y*z_1_x)) - b_1_z + o_1_z
    t3 = np.cos(theta_2)
    t4 = np.sin(theta_2)
    S_2_x = L_a_2*(t3*z_2_x + t4*(a_2_y*z_2_z - a_2_z*z_2_y)) - b_2_x + o_2_x
    S_2_y = L_a_2*(t3*z_2_y + t4*(-a_2_x*z_2_z + a_2_z*z_2_x)) - b_2_y + o_2_y
    S_2_z = L_a_2*(t3*z_2_z + t4*(a_2_x*z_2_y - a_2_y*z_2_x)) - b_2_z + o_2_z
    t5 = np.cos(theta_3)
    t6 = np.sin(theta_3)
    S_3_x = L_a_3*(t5*z_3_x + t6*(a_3_y*z_3_z - a_3_z*z_3_y)) - b_3_x + o_3_x
    S_3_y = L_a_3*(t5*z_3_y + t6*(-a_3_x*z_3_z + a_3_z*z_3_x)) - b_3_y + o_3_y
    S_3_z = L_a_3*(t5*z_3_z + t6*(a_3_x*z_3_y - a_3_y*z_3_x)) - b_3_z + o_3_z
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
    t7 = l_d_1**2
    t8 = (1/2)*t7
    h_2 = (1/2)*alpha_x**2 + (1/2)*alpha_y**2 + (1/2)*alpha_z**2 - 1/2*l_d_2**2 + t8
    h_3 = (1/2)*beta_x**2 + (1/2)*beta_y**2 + (1/2)*beta_z**2 - 1/2*l_d_3**2 + t8
    t9 = 1.0/nu2
    q_x = t9*(h_2*(beta_y*nu_z - beta_z*nu_y) + h_3*(-alpha_y*nu_z + alpha_z*nu_y))
    q_y = t9*(h_2*(-beta_x*nu_z + beta_z*nu_x) + h_3*(alpha_x*nu_z - alpha_z*nu_x))
    q_z = t9*(h_2*(beta_x*nu_y - beta_y*nu_x) + h_3*(-alpha_x*nu_y + alpha_y*nu_x))
    t10 = assembly*np.sqrt(t9*(-q_x**2 - q_y**2 - q_z**2 + t7))
    p_out = np.empty((*batch, 3), dtype)
    p_out[..., 0] = S_1_x + nu_x*t10 + q_x
    p_out[..., 1] = S_1_y + nu_y*t10 + q_y
    p_out[..., 2] = S_1_z + nu_z*t10 + q_z
    return p_out


def constraint_jacobians(p, parameters):
    """Constraint Jacobians D_l and D_r of D_l p_dot = D_r theta_dot.

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
    D_r : array, shape (..., 3, 3) [m^2]
        Diagonal: component of linkage vector j along the motion of its joint.

    Notes
    -----
    Equations 14 and 15.
    255 operations; 7926 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
    D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z
    D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z
    D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z
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
    286 operations; 57554 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
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
    t4 = 1.0/(det_D_l**2)
    determinant_out = np.empty(batch, dtype)
    determinant_out[...] = det_D_l
    condition_out = np.empty(batch, dtype)
    condition_out[...] = (
        np.sqrt(s_1_x**2 + s_1_y**2 + s_1_z**2 + s_2_x**2 + s_2_y**2 + s_2_z**2 + s_3_x**2 + s_3_y**2
        + s_3_z**2)*np.sqrt(A_x_1**2*t4 + A_x_2**2*t4 + A_x_3**2*t4 + A_y_1**2*t4 + A_y_2**2*t4 + A_y_3**2*t4
        + A_z_1**2*t4 + A_z_2**2*t4 + A_z_3**2*t4)
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
    D_p : array, shape (..., 3, 3) [m]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15.
    300 operations; 66285 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
    D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z
    D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z
    D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z
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


def platform_jacobian_rate(p, theta_dot, parameters):
    """Time derivative of the platform Jacobian.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    theta_dot : array, shape (..., 3) [rad/s]
        Arm velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    D_p_dot : array, shape (..., 3, 3) [m/s]
        d(D_p)/dt at theta_dot.

    Notes
    -----
    Equation 17.
    492 operations; 3110535 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    theta_1_dot, theta_2_dot, theta_3_dot = _entries(theta_dot, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, theta_1_dot, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    t4 = L_a_1*d_1_x
    s_1_x = r_1_x - t4
    t5 = L_a_1*d_1_y
    s_1_y = r_1_y - t5
    t6 = L_a_1*d_1_z
    s_1_z = r_1_z - t6
    t7 = L_a_2*d_2_x
    s_2_x = r_2_x - t7
    t8 = L_a_2*d_2_y
    s_2_y = r_2_y - t8
    t9 = L_a_2*d_2_z
    s_2_z = r_2_z - t9
    t10 = L_a_3*d_3_x
    s_3_x = r_3_x - t10
    t11 = L_a_3*d_3_y
    s_3_y = r_3_y - t11
    t12 = L_a_3*d_3_z
    s_3_z = r_3_z - t12
    t13 = L_a_1*t_1_x
    t14 = L_a_1*t_1_y
    t15 = L_a_1*t_1_z
    D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15
    t16 = L_a_2*t_2_x
    t17 = L_a_2*t_2_y
    t18 = L_a_2*t_2_z
    D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18
    t19 = L_a_3*t_3_x
    t20 = L_a_3*t_3_y
    t21 = L_a_3*t_3_z
    D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21
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
    t22 = 1.0/det_D_l
    t23 = D_r_1*t22
    D_p_x_1 = A_x_1*t23
    t24 = D_r_2*t22
    D_p_x_2 = A_x_2*t24
    t25 = D_r_3*t22
    D_p_x_3 = A_x_3*t25
    D_p_y_1 = A_y_1*t23
    D_p_y_2 = A_y_2*t24
    D_p_y_3 = A_y_3*t25
    D_p_z_1 = A_z_1*t23
    D_p_z_2 = A_z_2*t24
    D_p_z_3 = A_z_3*t25
    U_1_x_1 = D_p_x_1 - t13
    U_1_y_1 = D_p_y_1 - t14
    U_1_z_1 = D_p_z_1 - t15
    U_2_x_2 = D_p_x_2 - t16
    U_2_y_2 = D_p_y_2 - t17
    U_2_z_2 = D_p_z_2 - t18
    U_3_x_3 = D_p_x_3 - t19
    U_3_y_3 = D_p_y_3 - t20
    U_3_z_3 = D_p_z_3 - t21
    t26 = D_p_x_2*theta_2_dot
    t27 = D_p_x_3*theta_3_dot
    s_dot_1_x = U_1_x_1*theta_1_dot + t26 + t27
    t28 = D_p_y_2*theta_2_dot
    t29 = D_p_y_3*theta_3_dot
    s_dot_1_y = U_1_y_1*theta_1_dot + t28 + t29
    t30 = D_p_z_2*theta_2_dot
    t31 = D_p_z_3*theta_3_dot
    s_dot_1_z = U_1_z_1*theta_1_dot + t30 + t31
    t32 = D_p_x_1*theta_1_dot
    s_dot_2_x = U_2_x_2*theta_2_dot + t27 + t32
    t33 = D_p_y_1*theta_1_dot
    s_dot_2_y = U_2_y_2*theta_2_dot + t29 + t33
    t34 = D_p_z_1*theta_1_dot
    s_dot_2_z = U_2_z_2*theta_2_dot + t31 + t34
    s_dot_3_x = U_3_x_3*theta_3_dot + t26 + t32
    s_dot_3_y = U_3_y_3*theta_3_dot + t28 + t33
    s_dot_3_z = U_3_z_3*theta_3_dot + t30 + t34
    t35 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z
    t36 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z
    t37 = (
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + s_dot_1_x*t13 + s_dot_1_y*t14
        + s_dot_1_z*t15 + theta_1_dot*(-s_1_x*t4 - s_1_y*t5 - s_1_z*t6)
    )
    D_p_dot_x_1 = t22*(A_x_1*t37 + A_x_2*t35 + A_x_3*t36)
    D_p_dot_y_1 = t22*(A_y_1*t37 + A_y_2*t35 + A_y_3*t36)
    D_p_dot_z_1 = t22*(A_z_1*t37 + A_z_2*t35 + A_z_3*t36)
    t38 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z
    t39 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z
    t40 = (
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + s_dot_2_x*t16 + s_dot_2_y*t17
        + s_dot_2_z*t18 + theta_2_dot*(-s_2_x*t7 - s_2_y*t8 - s_2_z*t9)
    )
    D_p_dot_x_2 = t22*(A_x_1*t38 + A_x_2*t40 + A_x_3*t39)
    D_p_dot_y_2 = t22*(A_y_1*t38 + A_y_2*t40 + A_y_3*t39)
    D_p_dot_z_2 = t22*(A_z_1*t38 + A_z_2*t40 + A_z_3*t39)
    t41 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z
    t42 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z
    t43 = (
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + s_dot_3_x*t19 + s_dot_3_y*t20
        + s_dot_3_z*t21 + theta_3_dot*(-s_3_x*t10 - s_3_y*t11 - s_3_z*t12)
    )
    D_p_dot_x_3 = t22*(A_x_1*t41 + A_x_2*t42 + A_x_3*t43)
    D_p_dot_y_3 = t22*(A_y_1*t41 + A_y_2*t42 + A_y_3*t43)
    D_p_dot_z_3 = t22*(A_z_1*t41 + A_z_2*t42 + A_z_3*t43)
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
    """Second derivatives of the platform position with respect to the arm angles.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    P : array, shape (..., 3, 3, 3) [m]
        d2p_i/dq_k dq_l as P[i, k, l].

    Notes
    -----
    Equation 49, by the implicit function theorem to second order.
    525 operations; 3253689 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    t4 = L_a_1*d_1_x
    s_1_x = r_1_x - t4
    t5 = L_a_1*d_1_y
    s_1_y = r_1_y - t5
    t6 = L_a_1*d_1_z
    s_1_z = r_1_z - t6
    t7 = L_a_2*d_2_x
    s_2_x = r_2_x - t7
    t8 = L_a_2*d_2_y
    s_2_y = r_2_y - t8
    t9 = L_a_2*d_2_z
    s_2_z = r_2_z - t9
    t10 = L_a_3*d_3_x
    s_3_x = r_3_x - t10
    t11 = L_a_3*d_3_y
    s_3_y = r_3_y - t11
    t12 = L_a_3*d_3_z
    s_3_z = r_3_z - t12
    t13 = L_a_1*t_1_x
    t14 = L_a_1*t_1_y
    t15 = L_a_1*t_1_z
    D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15
    t16 = L_a_2*t_2_x
    t17 = L_a_2*t_2_y
    t18 = L_a_2*t_2_z
    D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18
    t19 = L_a_3*t_3_x
    t20 = L_a_3*t_3_y
    t21 = L_a_3*t_3_z
    D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21
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
    t22 = 1.0/det_D_l
    t23 = D_r_1*t22
    D_p_x_1 = A_x_1*t23
    t24 = D_r_2*t22
    D_p_x_2 = A_x_2*t24
    t25 = D_r_3*t22
    D_p_x_3 = A_x_3*t25
    D_p_y_1 = A_y_1*t23
    D_p_y_2 = A_y_2*t24
    D_p_y_3 = A_y_3*t25
    D_p_z_1 = A_z_1*t23
    D_p_z_2 = A_z_2*t24
    D_p_z_3 = A_z_3*t25
    U_1_x_1 = D_p_x_1 - t13
    U_1_y_1 = D_p_y_1 - t14
    U_1_z_1 = D_p_z_1 - t15
    U_2_x_2 = D_p_x_2 - t16
    U_2_y_2 = D_p_y_2 - t17
    U_2_z_2 = D_p_z_2 - t18
    U_3_x_3 = D_p_x_3 - t19
    U_3_y_3 = D_p_y_3 - t20
    U_3_z_3 = D_p_z_3 - t21
    f_1_11 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2 - s_1_x*t4 - s_1_y*t5 - s_1_z*t6
    f_2_11 = -D_p_x_1**2 - D_p_y_1**2 - D_p_z_1**2
    P_x_11 = t22*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11)
    P_y_11 = t22*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11)
    P_z_11 = t22*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11)
    f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2
    P_x_12 = t22*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12)
    P_y_12 = t22*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12)
    P_z_12 = t22*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12)
    f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3
    f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    P_x_13 = t22*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13)
    P_y_13 = t22*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13)
    P_z_13 = t22*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13)
    f_1_22 = -D_p_x_2**2 - D_p_y_2**2 - D_p_z_2**2
    f_2_22 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2 - s_2_x*t7 - s_2_y*t8 - s_2_z*t9
    P_x_22 = t22*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22)
    P_y_22 = t22*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22)
    P_z_22 = t22*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22)
    f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3
    f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    P_x_23 = t22*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23)
    P_y_23 = t22*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23)
    P_z_23 = t22*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23)
    f_1_33 = -D_p_x_3**2 - D_p_y_3**2 - D_p_z_3**2
    f_3_33 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2 - s_3_x*t10 - s_3_y*t11 - s_3_z*t12
    P_x_33 = t22*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33)
    P_y_33 = t22*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33)
    P_z_33 = t22*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33)
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
    D_d : array, shape (..., 3, 3, 3) [m]
        D_d[j-1] theta_dot is the velocity of the centre of mass of linkage j.
    D_omega : array, shape (..., 3, 3, 3) [1]
        D_omega[j-1] theta_dot is the angular velocity of linkage j.

    Notes
    -----
    Equations 16 and 23; the angular velocity without spin about the rod, which carries no energy.
    447 operations; 620496 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    t1 = l_d_1**2
    C_1 = (1/2)*(L_a_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2 - t1)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t2 = 1.0/rho2_1
    c_1 = t2*(A_1*C_1 - B_1*S_1)
    sn_1 = t2*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    t3 = l_d_2**2
    C_2 = (1/2)*(L_a_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2 - t3)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t4 = 1.0/rho2_2
    c_2 = t4*(A_2*C_2 - B_2*S_2)
    sn_2 = t4*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t5 = l_d_3**2
    C_3 = (1/2)*(L_a_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2 - t5)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t6 = 1.0/rho2_3
    c_3 = t6*(A_3*C_3 - B_3*S_3)
    sn_3 = t6*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
    t7 = L_a_1*t_1_x
    t8 = L_a_1*t_1_y
    t9 = L_a_1*t_1_z
    D_r_1 = s_1_x*t7 + s_1_y*t8 + s_1_z*t9
    t10 = L_a_2*t_2_y
    t11 = L_a_2*t_2_z
    t12 = L_a_2*t_2_x
    D_r_2 = s_2_x*t12 + s_2_y*t10 + s_2_z*t11
    t13 = L_a_3*t_3_x
    t14 = L_a_3*t_3_y
    t15 = L_a_3*t_3_z
    D_r_3 = s_3_x*t13 + s_3_y*t14 + s_3_z*t15
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
    t16 = 1.0/det_D_l
    t17 = D_r_1*t16
    D_p_x_1 = A_x_1*t17
    t18 = D_r_2*t16
    D_p_x_2 = A_x_2*t18
    t19 = D_r_3*t16
    D_p_x_3 = A_x_3*t19
    D_p_y_1 = A_y_1*t17
    D_p_y_2 = A_y_2*t18
    D_p_y_3 = A_y_3*t19
    D_p_z_1 = A_z_1*t17
    D_p_z_2 = A_z_2*t18
    D_p_z_3 = A_z_3*t19
    U_1_x_1 = D_p_x_1 - t7
    U_1_y_1 = D_p_y_1 - t8
    U_1_z_1 = D_p_z_1 - t9
    U_2_x_2 = D_p_x_2 - t12
    U_2_y_2 = D_p_y_2 - t10
    U_2_z_2 = D_p_z_2 - t11
    U_3_x_3 = D_p_x_3 - t13
    U_3_y_3 = D_p_y_3 - t14
    U_3_z_3 = D_p_z_3 - t15
    t20 = (1/2)*D_p_x_1
    t21 = (1/2)*D_p_x_2
    t22 = (1/2)*D_p_x_3
    t23 = (1/2)*D_p_y_1
    t24 = (1/2)*D_p_y_2
    t25 = (1/2)*D_p_y_3
    t26 = (1/2)*D_p_z_1
    t27 = (1/2)*D_p_z_2
    t28 = (1/2)*D_p_z_3
    t29 = 1.0/t1
    t30 = 1.0/t3
    t31 = 1.0/t5
    D_d_out = np.empty((*batch, 3, 3, 3), dtype)
    D_d_out[..., 0, 0, 0] = t20 + (1/2)*t7
    D_d_out[..., 0, 0, 1] = t21
    D_d_out[..., 0, 0, 2] = t22
    D_d_out[..., 0, 1, 0] = t23 + (1/2)*t8
    D_d_out[..., 0, 1, 1] = t24
    D_d_out[..., 0, 1, 2] = t25
    D_d_out[..., 0, 2, 0] = t26 + (1/2)*t9
    D_d_out[..., 0, 2, 1] = t27
    D_d_out[..., 0, 2, 2] = t28
    D_d_out[..., 1, 0, 0] = t20
    D_d_out[..., 1, 0, 1] = (1/2)*t12 + t21
    D_d_out[..., 1, 0, 2] = t22
    D_d_out[..., 1, 1, 0] = t23
    D_d_out[..., 1, 1, 1] = (1/2)*t10 + t24
    D_d_out[..., 1, 1, 2] = t25
    D_d_out[..., 1, 2, 0] = t26
    D_d_out[..., 1, 2, 1] = (1/2)*t11 + t27
    D_d_out[..., 1, 2, 2] = t28
    D_d_out[..., 2, 0, 0] = t20
    D_d_out[..., 2, 0, 1] = t21
    D_d_out[..., 2, 0, 2] = (1/2)*t13 + t22
    D_d_out[..., 2, 1, 0] = t23
    D_d_out[..., 2, 1, 1] = t24
    D_d_out[..., 2, 1, 2] = (1/2)*t14 + t25
    D_d_out[..., 2, 2, 0] = t26
    D_d_out[..., 2, 2, 1] = t27
    D_d_out[..., 2, 2, 2] = (1/2)*t15 + t28
    D_omega_out = np.empty((*batch, 3, 3, 3), dtype)
    D_omega_out[..., 0, 0, 0] = t29*(-U_1_y_1*s_1_z + U_1_z_1*s_1_y)
    D_omega_out[..., 0, 0, 1] = t29*(-D_p_y_2*s_1_z + D_p_z_2*s_1_y)
    D_omega_out[..., 0, 0, 2] = t29*(-D_p_y_3*s_1_z + D_p_z_3*s_1_y)
    D_omega_out[..., 0, 1, 0] = t29*(U_1_x_1*s_1_z - U_1_z_1*s_1_x)
    D_omega_out[..., 0, 1, 1] = t29*(D_p_x_2*s_1_z - D_p_z_2*s_1_x)
    D_omega_out[..., 0, 1, 2] = t29*(D_p_x_3*s_1_z - D_p_z_3*s_1_x)
    D_omega_out[..., 0, 2, 0] = t29*(-U_1_x_1*s_1_y + U_1_y_1*s_1_x)
    D_omega_out[..., 0, 2, 1] = t29*(-D_p_x_2*s_1_y + D_p_y_2*s_1_x)
    D_omega_out[..., 0, 2, 2] = t29*(-D_p_x_3*s_1_y + D_p_y_3*s_1_x)
    D_omega_out[..., 1, 0, 0] = t30*(-D_p_y_1*s_2_z + D_p_z_1*s_2_y)
    D_omega_out[..., 1, 0, 1] = t30*(-U_2_y_2*s_2_z + U_2_z_2*s_2_y)
    D_omega_out[..., 1, 0, 2] = t30*(-D_p_y_3*s_2_z + D_p_z_3*s_2_y)
    D_omega_out[..., 1, 1, 0] = t30*(D_p_x_1*s_2_z - D_p_z_1*s_2_x)
    D_omega_out[..., 1, 1, 1] = t30*(U_2_x_2*s_2_z - U_2_z_2*s_2_x)
    D_omega_out[..., 1, 1, 2] = t30*(D_p_x_3*s_2_z - D_p_z_3*s_2_x)
    D_omega_out[..., 1, 2, 0] = t30*(-D_p_x_1*s_2_y + D_p_y_1*s_2_x)
    D_omega_out[..., 1, 2, 1] = t30*(-U_2_x_2*s_2_y + U_2_y_2*s_2_x)
    D_omega_out[..., 1, 2, 2] = t30*(-D_p_x_3*s_2_y + D_p_y_3*s_2_x)
    D_omega_out[..., 2, 0, 0] = t31*(-D_p_y_1*s_3_z + D_p_z_1*s_3_y)
    D_omega_out[..., 2, 0, 1] = t31*(-D_p_y_2*s_3_z + D_p_z_2*s_3_y)
    D_omega_out[..., 2, 0, 2] = t31*(-U_3_y_3*s_3_z + U_3_z_3*s_3_y)
    D_omega_out[..., 2, 1, 0] = t31*(D_p_x_1*s_3_z - D_p_z_1*s_3_x)
    D_omega_out[..., 2, 1, 1] = t31*(D_p_x_2*s_3_z - D_p_z_2*s_3_x)
    D_omega_out[..., 2, 1, 2] = t31*(U_3_x_3*s_3_z - U_3_z_3*s_3_x)
    D_omega_out[..., 2, 2, 0] = t31*(-D_p_x_1*s_3_y + D_p_y_1*s_3_x)
    D_omega_out[..., 2, 2, 1] = t31*(-D_p_x_2*s_3_y + D_p_y_2*s_3_x)
    D_omega_out[..., 2, 2, 2] = t31*(-U_3_x_3*s_3_y + U_3_y_3*s_3_x)
    return D_d_out, D_omega_out


def kinetic_energy(p, q_dot, parameters):
    """Kinetic energies of the structure and of the transmissions.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    q_dot : array, shape (..., 6) [rad/s]
        Rates of the six generalised coordinates.
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
    392 operations; 135334 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    theta_1_dot, theta_2_dot, theta_3_dot, phi_1_dot, phi_2_dot, phi_3_dot = _entries(q_dot, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    I_a_1, I_a_2, I_a_3 = _entries(parameters.arm_inertia, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, theta_1_dot, m_p, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, I_a_1, l_d_1, m_d_1,
        I_m_1, i_g_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    t1 = L_a_1**2
    C_1 = (1/2)*(-l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2 + t1)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t2 = 1.0/rho2_1
    c_1 = t2*(A_1*C_1 - B_1*S_1)
    sn_1 = t2*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    t3 = L_a_2**2
    C_2 = (1/2)*(-l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2 + t3)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t4 = 1.0/rho2_2
    c_2 = t4*(A_2*C_2 - B_2*S_2)
    sn_2 = t4*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t5 = L_a_3**2
    C_3 = (1/2)*(-l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2 + t5)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t6 = 1.0/rho2_3
    c_3 = t6*(A_3*C_3 - B_3*S_3)
    sn_3 = t6*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
    t7 = L_a_1*t_1_x
    t8 = L_a_1*t_1_y
    t9 = L_a_1*t_1_z
    D_r_1 = s_1_x*t7 + s_1_y*t8 + s_1_z*t9
    t10 = L_a_2*t_2_y
    t11 = L_a_2*t_2_z
    t12 = L_a_2*t_2_x
    D_r_2 = s_2_x*t12 + s_2_y*t10 + s_2_z*t11
    t13 = L_a_3*t_3_x
    t14 = L_a_3*t_3_y
    t15 = L_a_3*t_3_z
    D_r_3 = s_3_x*t13 + s_3_y*t14 + s_3_z*t15
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
    t16 = 1.0/det_D_l
    t17 = D_r_1*t16
    D_p_x_1 = A_x_1*t17
    t18 = D_r_2*t16
    D_p_x_2 = A_x_2*t18
    t19 = D_r_3*t16
    D_p_x_3 = A_x_3*t19
    D_p_y_1 = A_y_1*t17
    D_p_y_2 = A_y_2*t18
    D_p_y_3 = A_y_3*t19
    D_p_z_1 = A_z_1*t17
    D_p_z_2 = A_z_2*t18
    D_p_z_3 = A_z_3*t19
    I_1 = I_m_1*i_g_1**2
    I_2 = I_m_2*i_g_2**2
    I_3 = I_m_3*i_g_3**2
    v_p_x = D_p_x_1*theta_1_dot + D_p_x_2*theta_2_dot + D_p_x_3*theta_3_dot
    v_p_y = D_p_y_1*theta_1_dot + D_p_y_2*theta_2_dot + D_p_y_3*theta_3_dot
    v_p_z = D_p_z_1*theta_1_dot + D_p_z_2*theta_2_dot + D_p_z_3*theta_3_dot
    t20 = theta_1_dot**2
    t21 = theta_2_dot**2
    t22 = theta_3_dot**2
    t23 = (1/6)*m_d_1
    t24 = (1/6)*m_d_2
    t25 = (1/6)*m_d_3
    t26 = (1/2)*m_p + t23 + t24 + t25
    t27 = t23*theta_1_dot
    t28 = t24*theta_2_dot
    t29 = t25*theta_3_dot
    T_ss_out = np.empty(batch, dtype)
    T_ss_out[...] = (
        (1/2)*I_a_1*t20 + (1/2)*I_a_2*t21 + (1/2)*I_a_3*t22 + t1*t20*t23 + t21*t24*t3 + t22*t25*t5
        + t26*v_p_x**2 + t26*v_p_y**2 + t26*v_p_z**2 + v_p_x*(t12*t28 + t13*t29 + t27*t7) + v_p_y*(t10*t28
        + t14*t29 + t27*t8) + v_p_z*(t11*t28 + t15*t29 + t27*t9)
    )
    T_t_out = np.empty(batch, dtype)
    T_t_out[...] = (1/2)*I_1*phi_1_dot**2 + (1/2)*I_2*phi_2_dot**2 + (1/2)*I_3*phi_3_dot**2
    return T_ss_out[()], T_t_out[()]


def mass_matrix(p, parameters):
    """Mass matrix M in the six generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M : array, shape (..., 6, 6) [kg m^2]
        Symmetric.

    Notes
    -----
    Equations 24, 30 and 33.
    417 operations; 612723 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    I_a_1, I_a_2, I_a_3 = _entries(parameters.arm_inertia, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, I_a_1, l_d_1, m_d_1, I_m_1, i_g_1,
        sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    t1 = L_a_1**2
    C_1 = (1/2)*(-l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2 + t1)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t2 = 1.0/rho2_1
    c_1 = t2*(A_1*C_1 - B_1*S_1)
    sn_1 = t2*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    t3 = L_a_2**2
    C_2 = (1/2)*(-l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2 + t3)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t4 = 1.0/rho2_2
    c_2 = t4*(A_2*C_2 - B_2*S_2)
    sn_2 = t4*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t5 = L_a_3**2
    C_3 = (1/2)*(-l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2 + t5)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t6 = 1.0/rho2_3
    c_3 = t6*(A_3*C_3 - B_3*S_3)
    sn_3 = t6*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
    t7 = L_a_1*t_1_x
    t8 = L_a_1*t_1_y
    t9 = L_a_1*t_1_z
    D_r_1 = s_1_x*t7 + s_1_y*t8 + s_1_z*t9
    t10 = L_a_2*t_2_y
    t11 = L_a_2*t_2_z
    t12 = L_a_2*t_2_x
    D_r_2 = s_2_x*t12 + s_2_y*t10 + s_2_z*t11
    t13 = L_a_3*t_3_x
    t14 = L_a_3*t_3_y
    t15 = L_a_3*t_3_z
    D_r_3 = s_3_x*t13 + s_3_y*t14 + s_3_z*t15
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
    t16 = 1.0/det_D_l
    t17 = D_r_1*t16
    D_p_x_1 = A_x_1*t17
    t18 = D_r_2*t16
    D_p_x_2 = A_x_2*t18
    t19 = D_r_3*t16
    D_p_x_3 = A_x_3*t19
    D_p_y_1 = A_y_1*t17
    D_p_y_2 = A_y_2*t18
    D_p_y_3 = A_y_3*t19
    D_p_z_1 = A_z_1*t17
    D_p_z_2 = A_z_2*t18
    D_p_z_3 = A_z_3*t19
    I_1 = I_m_1*i_g_1**2
    I_2 = I_m_2*i_g_2**2
    I_3 = I_m_3*i_g_3**2
    t20 = (1/3)*m_d_1
    t21 = (1/6)*m_d_1
    t22 = t21*t7
    t23 = t21*t8
    t24 = t21*t9
    t25 = (1/3)*m_d_2
    t26 = (1/3)*m_d_3
    t27 = m_p + t20 + t25 + t26
    t28 = D_p_x_1*t27 + t22
    t29 = D_p_y_1*t27 + t23
    t30 = D_p_z_1*t27 + t24
    t31 = (1/6)*m_d_2
    t32 = t12*t31
    t33 = t10*t31
    t34 = t11*t31
    t35 = (1/6)*m_d_3
    t36 = t13*t35
    t37 = t14*t35
    t38 = t15*t35
    t39 = D_p_x_2*t27 + t32
    t40 = D_p_y_2*t27 + t33
    t41 = D_p_z_2*t27 + t34
    M_out = np.zeros((*batch, 6, 6), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t22 + D_p_x_1*t28 + D_p_y_1*t23 + D_p_y_1*t29 + D_p_z_1*t24 + D_p_z_1*t30 + I_a_1 + t1*t20
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_x_1*t32 + D_p_x_2*t28 + D_p_y_1*t33 + D_p_y_2*t29 + D_p_z_1*t34 + D_p_z_2*t30
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_x_1*t36 + D_p_x_3*t28 + D_p_y_1*t37 + D_p_y_3*t29 + D_p_z_1*t38 + D_p_z_3*t30
    )
    M_out[..., 1, 1] = (
        D_p_x_2*t32 + D_p_x_2*t39 + D_p_y_2*t33 + D_p_y_2*t40 + D_p_z_2*t34 + D_p_z_2*t41 + I_a_2 + t25*t3
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_x_2*t36 + D_p_x_3*t39 + D_p_y_2*t37 + D_p_y_3*t40 + D_p_z_2*t38 + D_p_z_3*t41
    )
    M_out[..., 2, 2] = (
        D_p_x_3*t36 + D_p_x_3*(D_p_x_3*t27 + t36) + D_p_y_3*t37 + D_p_y_3*(D_p_y_3*t27 + t37) + D_p_z_3*t38
        + D_p_z_3*(D_p_z_3*t27 + t38) + I_a_3 + t26*t5
    )
    M_out[..., 3, 3] = I_1
    M_out[..., 4, 4] = I_2
    M_out[..., 5, 5] = I_3
    return M_out


def velocity_forces(p, theta_dot, parameters):
    """Coriolis and centrifugal forces h of M_ss theta_ddot + h + grad V = Q.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    theta_dot : array, shape (..., 3) [rad/s]
        Arm velocities.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    h : array, shape (..., 3) [N m]
        Generalised forces conjugate to the arm angles.

    Notes
    -----
    Lagrange's equations; equation 47 before linearisation.
    987 operations; 17338074 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    theta_1_dot, theta_2_dot, theta_3_dot = _entries(theta_dot, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, theta_1_dot, m_p, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, m_d_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    t4 = L_a_1*d_1_x
    s_1_x = r_1_x - t4
    t5 = L_a_1*d_1_y
    s_1_y = r_1_y - t5
    t6 = L_a_1*d_1_z
    s_1_z = r_1_z - t6
    t7 = L_a_2*d_2_x
    s_2_x = r_2_x - t7
    t8 = L_a_2*d_2_y
    s_2_y = r_2_y - t8
    t9 = L_a_2*d_2_z
    s_2_z = r_2_z - t9
    t10 = L_a_3*d_3_x
    s_3_x = r_3_x - t10
    t11 = L_a_3*d_3_y
    s_3_y = r_3_y - t11
    t12 = L_a_3*d_3_z
    s_3_z = r_3_z - t12
    t13 = L_a_1*t_1_x
    t14 = L_a_1*t_1_y
    t15 = L_a_1*t_1_z
    D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15
    t16 = L_a_2*t_2_x
    t17 = L_a_2*t_2_y
    t18 = L_a_2*t_2_z
    D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18
    t19 = L_a_3*t_3_x
    t20 = L_a_3*t_3_y
    t21 = L_a_3*t_3_z
    D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21
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
    t22 = 1.0/det_D_l
    t23 = D_r_1*t22
    D_p_x_1 = A_x_1*t23
    t24 = D_r_2*t22
    D_p_x_2 = A_x_2*t24
    t25 = D_r_3*t22
    D_p_x_3 = A_x_3*t25
    D_p_y_1 = A_y_1*t23
    D_p_y_2 = A_y_2*t24
    D_p_y_3 = A_y_3*t25
    D_p_z_1 = A_z_1*t23
    D_p_z_2 = A_z_2*t24
    D_p_z_3 = A_z_3*t25
    U_1_x_1 = D_p_x_1 - t13
    U_1_y_1 = D_p_y_1 - t14
    U_1_z_1 = D_p_z_1 - t15
    U_2_x_2 = D_p_x_2 - t16
    U_2_y_2 = D_p_y_2 - t17
    U_2_z_2 = D_p_z_2 - t18
    U_3_x_3 = D_p_x_3 - t19
    U_3_y_3 = D_p_y_3 - t20
    U_3_z_3 = D_p_z_3 - t21
    t26 = s_1_x*t4 + s_1_y*t5 + s_1_z*t6
    f_1_11 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2 - t26
    f_2_11 = -D_p_x_1**2 - D_p_y_1**2 - D_p_z_1**2
    P_x_11 = t22*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11)
    P_y_11 = t22*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11)
    P_z_11 = t22*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11)
    f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2
    P_x_12 = t22*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12)
    P_y_12 = t22*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12)
    P_z_12 = t22*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12)
    f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3
    f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    P_x_13 = t22*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13)
    P_y_13 = t22*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13)
    P_z_13 = t22*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13)
    f_1_22 = -D_p_x_2**2 - D_p_y_2**2 - D_p_z_2**2
    t27 = s_2_x*t7 + s_2_y*t8 + s_2_z*t9
    f_2_22 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2 - t27
    P_x_22 = t22*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22)
    P_y_22 = t22*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22)
    P_z_22 = t22*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22)
    f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3
    f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    P_x_23 = t22*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23)
    P_y_23 = t22*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23)
    P_z_23 = t22*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23)
    f_1_33 = -D_p_x_3**2 - D_p_y_3**2 - D_p_z_3**2
    t28 = s_3_x*t10 + s_3_y*t11 + s_3_z*t12
    f_3_33 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2 - t28
    P_x_33 = t22*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33)
    P_y_33 = t22*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33)
    P_z_33 = t22*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33)
    t29 = D_p_x_1*theta_1_dot
    t30 = D_p_x_2*theta_2_dot
    t31 = D_p_x_3*theta_3_dot
    t32 = t30 + t31
    v_p_x = t29 + t32
    t33 = D_p_y_1*theta_1_dot
    t34 = D_p_y_2*theta_2_dot
    t35 = D_p_y_3*theta_3_dot
    t36 = t34 + t35
    v_p_y = t33 + t36
    t37 = D_p_z_1*theta_1_dot
    t38 = D_p_z_2*theta_2_dot
    t39 = D_p_z_3*theta_3_dot
    t40 = t38 + t39
    v_p_z = t37 + t40
    s_dot_1_x = U_1_x_1*theta_1_dot + t32
    s_dot_1_y = U_1_y_1*theta_1_dot + t36
    s_dot_1_z = U_1_z_1*theta_1_dot + t40
    s_dot_2_x = U_2_x_2*theta_2_dot + t29 + t31
    s_dot_2_y = U_2_y_2*theta_2_dot + t33 + t35
    s_dot_2_z = U_2_z_2*theta_2_dot + t37 + t39
    s_dot_3_x = U_3_x_3*theta_3_dot + t29 + t30
    s_dot_3_y = U_3_y_3*theta_3_dot + t33 + t34
    s_dot_3_z = U_3_z_3*theta_3_dot + t37 + t38
    t41 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z
    t42 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z
    t43 = (
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + s_dot_1_x*t13 + s_dot_1_y*t14
        + s_dot_1_z*t15 - t26*theta_1_dot
    )
    D_p_dot_x_1 = t22*(A_x_1*t43 + A_x_2*t41 + A_x_3*t42)
    D_p_dot_y_1 = t22*(A_y_1*t43 + A_y_2*t41 + A_y_3*t42)
    D_p_dot_z_1 = t22*(A_z_1*t43 + A_z_2*t41 + A_z_3*t42)
    t44 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z
    t45 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z
    t46 = (
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + s_dot_2_x*t16 + s_dot_2_y*t17
        + s_dot_2_z*t18 - t27*theta_2_dot
    )
    D_p_dot_x_2 = t22*(A_x_1*t44 + A_x_2*t46 + A_x_3*t45)
    D_p_dot_y_2 = t22*(A_y_1*t44 + A_y_2*t46 + A_y_3*t45)
    D_p_dot_z_2 = t22*(A_z_1*t44 + A_z_2*t46 + A_z_3*t45)
    t47 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z
    t48 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z
    t49 = (
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + s_dot_3_x*t19 + s_dot_3_y*t20
        + s_dot_3_z*t21 - t28*theta_3_dot
    )
    D_p_dot_x_3 = t22*(A_x_1*t47 + A_x_2*t48 + A_x_3*t49)
    D_p_dot_y_3 = t22*(A_y_1*t47 + A_y_2*t48 + A_y_3*t49)
    D_p_dot_z_3 = t22*(A_z_1*t47 + A_z_2*t48 + A_z_3*t49)
    t50 = (1/6)*m_d_1
    t51 = t50*theta_1_dot
    t52 = t4*t51
    t53 = t5*t51
    t54 = t51*t6
    t55 = t13*t50
    t56 = (1/6)*m_d_2
    t57 = t16*t56
    t58 = (1/6)*m_d_3
    t59 = t19*t58
    t60 = m_p + 2*t50 + 2*t56 + 2*t58
    t61 = t55*theta_1_dot + t57*theta_2_dot + t59*theta_3_dot + t60*v_p_x
    t62 = t14*t50
    t63 = t17*t56
    t64 = t20*t58
    t65 = t60*v_p_y + t62*theta_1_dot + t63*theta_2_dot + t64*theta_3_dot
    t66 = t15*t50
    t67 = t18*t56
    t68 = t21*t58
    t69 = t60*v_p_z + t66*theta_1_dot + t67*theta_2_dot + t68*theta_3_dot
    t70 = (1/3)*m_d_1 + (1/3)*m_d_2 + (1/3)*m_d_3 + m_p
    t71 = D_p_x_1*t70 + t55
    t72 = D_p_y_1*t70 + t62
    t73 = D_p_z_1*t70 + t66
    t74 = t56*theta_2_dot
    t75 = t7*t74
    t76 = t74*t8
    t77 = t74*t9
    t78 = P_x_12*t61 + P_y_12*t65 + P_z_12*t69
    t79 = t58*theta_3_dot
    t80 = t10*t79
    t81 = t11*t79
    t82 = t12*t79
    t83 = P_x_13*t61 + P_y_13*t65 + P_z_13*t69
    t84 = L_a_1*t50
    t85 = D_p_x_2*t70 + t57
    t86 = D_p_y_2*t70 + t63
    t87 = D_p_z_2*t70 + t67
    t88 = P_x_23*t61 + P_y_23*t65 + P_z_23*t69
    t89 = L_a_2*t56
    t90 = D_p_x_3*t70 + t59
    t91 = D_p_y_3*t70 + t64
    t92 = D_p_z_3*t70 + t68
    t93 = L_a_3*t58
    h_out = np.empty((*batch, 3), dtype)
    h_out[..., 0] = (
        -D_p_dot_x_1*t61 - D_p_dot_y_1*t65 - D_p_dot_z_1*t69 + t52*v_p_x + t53*v_p_y + t54*v_p_z
        + theta_1_dot*(D_p_dot_x_1*t71 + D_p_dot_y_1*t72 + D_p_dot_z_1*t73 + P_x_11*t61 + P_y_11*t65
        + P_z_11*t69 - d_1_x*(t29*t84 + t84*v_p_x) - d_1_y*(t33*t84 + t84*v_p_y) - d_1_z*(t37*t84
        + t84*v_p_z)) + theta_2_dot*(D_p_dot_x_2*t71 + D_p_dot_y_2*t72 + D_p_dot_z_2*t73 - D_p_x_1*t75
        - D_p_y_1*t76 - D_p_z_1*t77 + t78) + theta_3_dot*(D_p_dot_x_3*t71 + D_p_dot_y_3*t72 + D_p_dot_z_3*t73
        - D_p_x_1*t80 - D_p_y_1*t81 - D_p_z_1*t82 + t83)
    )
    h_out[..., 1] = (
        -D_p_dot_x_2*t61 - D_p_dot_y_2*t65 - D_p_dot_z_2*t69 + t75*v_p_x + t76*v_p_y + t77*v_p_z
        + theta_1_dot*(D_p_dot_x_1*t85 + D_p_dot_y_1*t86 + D_p_dot_z_1*t87 - D_p_x_2*t52 - D_p_y_2*t53
        - D_p_z_2*t54 + t78) + theta_2_dot*(D_p_dot_x_2*t85 + D_p_dot_y_2*t86 + D_p_dot_z_2*t87 + P_x_22*t61
        + P_y_22*t65 + P_z_22*t69 - d_2_x*(t30*t89 + t89*v_p_x) - d_2_y*(t34*t89 + t89*v_p_y) - d_2_z*(t38*t89
        + t89*v_p_z)) + theta_3_dot*(D_p_dot_x_3*t85 + D_p_dot_y_3*t86 + D_p_dot_z_3*t87 - D_p_x_2*t80
        - D_p_y_2*t81 - D_p_z_2*t82 + t88)
    )
    h_out[..., 2] = (
        -D_p_dot_x_3*t61 - D_p_dot_y_3*t65 - D_p_dot_z_3*t69 + t80*v_p_x + t81*v_p_y + t82*v_p_z
        + theta_1_dot*(D_p_dot_x_1*t90 + D_p_dot_y_1*t91 + D_p_dot_z_1*t92 - D_p_x_3*t52 - D_p_y_3*t53
        - D_p_z_3*t54 + t83) + theta_2_dot*(D_p_dot_x_2*t90 + D_p_dot_y_2*t91 + D_p_dot_z_2*t92 - D_p_x_3*t75
        - D_p_y_3*t76 - D_p_z_3*t77 + t88) + theta_3_dot*(D_p_dot_x_3*t90 + D_p_dot_y_3*t91 + D_p_dot_z_3*t92
        + P_x_33*t61 + P_y_33*t65 + P_z_33*t69 - d_3_x*(t31*t93 + t93*v_p_x) - d_3_y*(t35*t93 + t93*v_p_y)
        - d_3_z*(t39*t93 + t93*v_p_z))
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
    297 operations; 5382 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1,
        sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t4 = (1/2)*m_d_2
    t5 = L_a_2*t4
    t6 = (1/2)*m_d_3
    t7 = L_a_3*t6
    t8 = (1/2)*m_d_1
    t9 = m_p + t4 + t6 + t8
    t10 = m_a_1*r_a_1
    t11 = m_a_2*r_a_2
    t12 = m_a_3*r_a_3
    t13 = L_a_1*t8
    V_g_out = np.empty(batch, dtype)
    V_g_out[...] = (
        -g_x*(b_1_x*t8 + b_2_x*t4 + b_3_x*t6 + d_1_x*t10 + d_1_x*t13 + d_2_x*t11 + d_2_x*t5 + d_3_x*t12
        + d_3_x*t7 + m_a_1*o_1_x + m_a_2*o_2_x + m_a_3*o_3_x + o_1_x*t8 + o_2_x*t4 + o_3_x*t6 + p_x*t9)
        - g_y*(b_1_y*t8 + b_2_y*t4 + b_3_y*t6 + d_1_y*t10 + d_1_y*t13 + d_2_y*t11 + d_2_y*t5 + d_3_y*t12
        + d_3_y*t7 + m_a_1*o_1_y + m_a_2*o_2_y + m_a_3*o_3_y + o_1_y*t8 + o_2_y*t4 + o_3_y*t6 + p_y*t9)
        - g_z*(b_1_z*t8 + b_2_z*t4 + b_3_z*t6 + d_1_z*t10 + d_1_z*t13 + d_2_z*t11 + d_2_z*t5 + d_3_z*t12
        + d_3_z*t7 + m_a_1*o_1_z + m_a_2*o_2_z + m_a_3*o_3_z + o_1_z*t8 + o_2_z*t4 + o_3_z*t6 + p_z*t9)
    )
    return V_g_out[()]


def gravity_gradient(p, parameters):
    """Gradient of the gravitational potential energy with respect to the arm angles.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    G : array, shape (..., 3) [N m]
        dV_g/dq_k.

    Notes
    -----
    Equation 27.
    363 operations; 69039 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1,
        sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
    D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z
    D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z
    D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z
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
    t8 = (1/2)*m_d_3
    t9 = (1/2)*m_d_1
    t10 = (1/2)*m_d_2
    t11 = m_p + t10 + t8 + t9
    t12 = g_x*t11
    t13 = g_y*t11
    t14 = g_z*t11
    t15 = L_a_1*t9 + m_a_1*r_a_1
    t16 = L_a_2*t10 + m_a_2*r_a_2
    t17 = L_a_3*t8 + m_a_3*r_a_3
    G_out = np.empty((*batch, 3), dtype)
    G_out[..., 0] = -D_p_x_1*t12 - D_p_y_1*t13 - D_p_z_1*t14 - g_x*t15*t_1_x - g_y*t15*t_1_y - g_z*t15*t_1_z
    G_out[..., 1] = -D_p_x_2*t12 - D_p_y_2*t13 - D_p_z_2*t14 - g_x*t16*t_2_x - g_y*t16*t_2_y - g_z*t16*t_2_z
    G_out[..., 2] = -D_p_x_3*t12 - D_p_y_3*t13 - D_p_z_3*t14 - g_x*t17*t_3_x - g_y*t17*t_3_y - g_z*t17*t_3_z
    return G_out


def gravity_hessian(p, parameters):
    """Hessian of the gravitational potential energy with respect to the arm angles.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    H_g : array, shape (..., 3, 3) [N m]
        d2V_g/dq_k dq_l, symmetric.

    Notes
    -----
    Section 4 and equation 49.
    543 operations; 1734630 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1,
        sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    t4 = L_a_1*d_1_x
    s_1_x = r_1_x - t4
    t5 = L_a_1*d_1_y
    s_1_y = r_1_y - t5
    t6 = L_a_1*d_1_z
    s_1_z = r_1_z - t6
    t7 = L_a_2*d_2_x
    s_2_x = r_2_x - t7
    t8 = L_a_2*d_2_y
    s_2_y = r_2_y - t8
    t9 = L_a_2*d_2_z
    s_2_z = r_2_z - t9
    t10 = L_a_3*d_3_x
    s_3_x = r_3_x - t10
    t11 = L_a_3*d_3_y
    s_3_y = r_3_y - t11
    t12 = L_a_3*d_3_z
    s_3_z = r_3_z - t12
    t13 = L_a_1*t_1_x
    t14 = L_a_1*t_1_y
    t15 = L_a_1*t_1_z
    D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15
    t16 = L_a_2*t_2_x
    t17 = L_a_2*t_2_y
    t18 = L_a_2*t_2_z
    D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18
    t19 = L_a_3*t_3_x
    t20 = L_a_3*t_3_y
    t21 = L_a_3*t_3_z
    D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21
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
    t22 = 1.0/det_D_l
    t23 = D_r_1*t22
    D_p_x_1 = A_x_1*t23
    t24 = D_r_2*t22
    D_p_x_2 = A_x_2*t24
    t25 = D_r_3*t22
    D_p_x_3 = A_x_3*t25
    D_p_y_1 = A_y_1*t23
    D_p_y_2 = A_y_2*t24
    D_p_y_3 = A_y_3*t25
    D_p_z_1 = A_z_1*t23
    D_p_z_2 = A_z_2*t24
    D_p_z_3 = A_z_3*t25
    U_1_x_1 = D_p_x_1 - t13
    U_1_y_1 = D_p_y_1 - t14
    U_1_z_1 = D_p_z_1 - t15
    U_2_x_2 = D_p_x_2 - t16
    U_2_y_2 = D_p_y_2 - t17
    U_2_z_2 = D_p_z_2 - t18
    U_3_x_3 = D_p_x_3 - t19
    U_3_y_3 = D_p_y_3 - t20
    U_3_z_3 = D_p_z_3 - t21
    t26 = (1/2)*m_d_1
    t27 = (1/2)*m_d_2
    t28 = (1/2)*m_d_3
    t29 = m_p + t26 + t27 + t28
    t30 = g_x*t29
    t31 = g_y*t29
    t32 = g_z*t29
    mu_1 = t22*(-A_x_1*t30 - A_y_1*t31 - A_z_1*t32)
    mu_2 = t22*(-A_x_2*t30 - A_y_2*t31 - A_z_2*t32)
    mu_3 = t22*(-A_x_3*t30 - A_y_3*t31 - A_z_3*t32)
    t33 = D_p_x_1**2
    t34 = D_p_y_1**2
    t35 = D_p_z_1**2
    t36 = L_a_1*t26 + m_a_1*r_a_1
    t37 = D_p_x_1*mu_3
    t38 = D_p_x_1*mu_2
    t39 = U_1_x_1*mu_1
    t40 = D_p_y_1*mu_3
    t41 = D_p_y_1*mu_2
    t42 = U_1_y_1*mu_1
    t43 = D_p_z_1*mu_3
    t44 = D_p_z_1*mu_2
    t45 = U_1_z_1*mu_1
    t46 = D_p_x_2**2
    t47 = D_p_y_2**2
    t48 = D_p_z_2**2
    t49 = L_a_2*t27 + m_a_2*r_a_2
    t50 = D_p_x_3**2
    t51 = D_p_y_3**2
    t52 = D_p_z_3**2
    t53 = L_a_3*t28 + m_a_3*r_a_3
    H_g_out = np.empty((*batch, 3, 3), dtype)
    H_g_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 + d_1_x*g_x*t36 + d_1_y*g_y*t36 + d_1_z*g_z*t36
        - mu_1*s_1_x*t4 - mu_1*s_1_y*t5 - mu_1*s_1_z*t6 - mu_2*t33 - mu_2*t34 - mu_2*t35 - mu_3*t33 - mu_3*t34
        - mu_3*t35
    )
    H_g_out[..., 0, 1] = H_g_out[..., 1, 0] = (
        -D_p_x_2*t37 - D_p_x_2*t39 - D_p_y_2*t40 - D_p_y_2*t42 - D_p_z_2*t43 - D_p_z_2*t45 - U_2_x_2*t38
        - U_2_y_2*t41 - U_2_z_2*t44
    )
    H_g_out[..., 0, 2] = H_g_out[..., 2, 0] = (
        -D_p_x_3*t38 - D_p_x_3*t39 - D_p_y_3*t41 - D_p_y_3*t42 - D_p_z_3*t44 - D_p_z_3*t45 - U_3_x_3*t37
        - U_3_y_3*t40 - U_3_z_3*t43
    )
    H_g_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 + d_2_x*g_x*t49 + d_2_y*g_y*t49 + d_2_z*g_z*t49
        - mu_1*t46 - mu_1*t47 - mu_1*t48 - mu_2*s_2_x*t7 - mu_2*s_2_y*t8 - mu_2*s_2_z*t9 - mu_3*t46 - mu_3*t47
        - mu_3*t48
    )
    H_g_out[..., 1, 2] = H_g_out[..., 2, 1] = (
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2
    )
    H_g_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 + d_3_x*g_x*t53 + d_3_y*g_y*t53 + d_3_z*g_z*t53
        - mu_1*t50 - mu_1*t51 - mu_1*t52 - mu_2*t50 - mu_2*t51 - mu_2*t52 - mu_3*s_3_x*t10 - mu_3*s_3_y*t11
        - mu_3*s_3_z*t12
    )
    return H_g_out


def elastic_potential(p, delta_q, parameters):
    """Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    delta_q : array, shape (..., 6) [rad]
        Small displacements of the six generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    V_el : array, shape (...) [J]
        Zero in the reference configuration.

    Notes
    -----
    Equation 38, summed.
    14 operations; 14 with every named value expanded.
    """
    p_x, _, _ = _entries(p, (3,))
    (
        delta_theta_1, delta_theta_2, delta_theta_3, delta_phi_1, delta_phi_2, delta_phi_3,
    ) = _entries(delta_q, (6,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    batch, dtype = _batch(p_x, delta_theta_1, k_r_1)
    V_el_out = np.empty(batch, dtype)
    V_el_out[...] = (
        (1/2)*k_r_1*(-delta_phi_1 + delta_theta_1)**2 + (1/2)*k_r_2*(-delta_phi_2 + delta_theta_2)**2
        + (1/2)*k_r_3*(-delta_phi_3 + delta_theta_3)**2
    )
    return V_el_out[()]


def elastic_gradient(p, delta_q, parameters):
    """Gradient of the elastic potential energy.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    delta_q : array, shape (..., 6) [rad]
        Small displacements of the six generalised coordinates from the reference configuration at p.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    E : array, shape (..., 6) [N m]
        dV_el/dq.

    Notes
    -----
    Equation 38 differentiated.
    21 operations; 30 with every named value expanded.
    """
    p_x, _, _ = _entries(p, (3,))
    (
        delta_theta_1, delta_theta_2, delta_theta_3, delta_phi_1, delta_phi_2, delta_phi_3,
    ) = _entries(delta_q, (6,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    batch, dtype = _batch(p_x, delta_theta_1, k_r_1)
    t1 = 2*delta_phi_1 - 2*delta_theta_1
    t2 = (1/2)*k_r_1
    t3 = 2*delta_phi_2 - 2*delta_theta_2
    t4 = (1/2)*k_r_2
    t5 = 2*delta_phi_3 - 2*delta_theta_3
    t6 = (1/2)*k_r_3
    E_out = np.empty((*batch, 6), dtype)
    E_out[..., 0] = -t1*t2
    E_out[..., 1] = -t3*t4
    E_out[..., 2] = -t5*t6
    E_out[..., 3] = t1*t2
    E_out[..., 4] = t3*t4
    E_out[..., 5] = t5*t6
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
    H_el : array, shape (..., 6, 6) [N m]
        d2V_el/dq2, symmetric, with three zero eigenvalues.

    Notes
    -----
    Equation 38 differentiated twice.
    3 operations; 6 with every named value expanded.
    """
    p_x, _, _ = _entries(p, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    batch, dtype = _batch(p_x, k_r_1)
    H_el_out = np.zeros((*batch, 6, 6), dtype)
    H_el_out[..., 0, 0] = k_r_1
    H_el_out[..., 0, 3] = H_el_out[..., 3, 0] = -k_r_1
    H_el_out[..., 1, 1] = k_r_2
    H_el_out[..., 1, 4] = H_el_out[..., 4, 1] = -k_r_2
    H_el_out[..., 2, 2] = k_r_3
    H_el_out[..., 2, 5] = H_el_out[..., 5, 2] = -k_r_3
    H_el_out[..., 3, 3] = k_r_1
    H_el_out[..., 4, 4] = k_r_2
    H_el_out[..., 5, 5] = k_r_3
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
    theta_st : array, shape (..., 3) [rad]
        Rotations relative to the unstrained transmissions, in the order of the coordinates.

    Notes
    -----
    Equation 44, solved at the pose.
    369 operations; 138087 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1, k_r_1,
        sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    s_1_x = -L_a_1*d_1_x + r_1_x
    s_1_y = -L_a_1*d_1_y + r_1_y
    s_1_z = -L_a_1*d_1_z + r_1_z
    s_2_x = -L_a_2*d_2_x + r_2_x
    s_2_y = -L_a_2*d_2_y + r_2_y
    s_2_z = -L_a_2*d_2_z + r_2_z
    s_3_x = -L_a_3*d_3_x + r_3_x
    s_3_y = -L_a_3*d_3_y + r_3_y
    s_3_z = -L_a_3*d_3_z + r_3_z
    D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z
    D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z
    D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z
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
    t8 = (1/2)*m_d_3
    t9 = (1/2)*m_d_1
    t10 = (1/2)*m_d_2
    t11 = m_p + t10 + t8 + t9
    t12 = g_x*t11
    t13 = g_y*t11
    t14 = g_z*t11
    t15 = L_a_1*t9 + m_a_1*r_a_1
    G_1 = -D_p_x_1*t12 - D_p_y_1*t13 - D_p_z_1*t14 - g_x*t15*t_1_x - g_y*t15*t_1_y - g_z*t15*t_1_z
    t16 = L_a_2*t10 + m_a_2*r_a_2
    G_2 = -D_p_x_2*t12 - D_p_y_2*t13 - D_p_z_2*t14 - g_x*t16*t_2_x - g_y*t16*t_2_y - g_z*t16*t_2_z
    t17 = L_a_3*t8 + m_a_3*r_a_3
    G_3 = -D_p_x_3*t12 - D_p_y_3*t13 - D_p_z_3*t14 - g_x*t17*t_3_x - g_y*t17*t_3_y - g_z*t17*t_3_z
    phi_1_st = G_1/k_r_1
    phi_2_st = G_2/k_r_2
    phi_3_st = G_3/k_r_3
    tau_st_1 = k_r_1*phi_1_st
    tau_st_2 = k_r_2*phi_2_st
    tau_st_3 = k_r_3*phi_3_st
    tau_st_out = np.empty((*batch, 3), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    tau_st_out[..., 2] = tau_st_3
    theta_st_out = np.empty((*batch, 3), dtype)
    theta_st_out[..., 0] = phi_1_st
    theta_st_out[..., 1] = phi_2_st
    theta_st_out[..., 2] = phi_3_st
    return tau_st_out, theta_st_out


def stiffness_matrix(p, parameters):
    """Stiffness matrix K in the six generalised coordinates.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    K : array, shape (..., 6, 6) [N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equations 46 and 48: K = -H_U.
    549 operations; 1734639 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1, k_r_1,
        sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t1 = 1.0/rho2_1
    c_1 = t1*(A_1*C_1 - B_1*S_1)
    sn_1 = t1*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t2 = 1.0/rho2_2
    c_2 = t2*(A_2*C_2 - B_2*S_2)
    sn_2 = t2*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t3 = 1.0/rho2_3
    c_3 = t3*(A_3*C_3 - B_3*S_3)
    sn_3 = t3*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    t4 = L_a_1*d_1_x
    s_1_x = r_1_x - t4
    t5 = L_a_1*d_1_y
    s_1_y = r_1_y - t5
    t6 = L_a_1*d_1_z
    s_1_z = r_1_z - t6
    t7 = L_a_2*d_2_x
    s_2_x = r_2_x - t7
    t8 = L_a_2*d_2_y
    s_2_y = r_2_y - t8
    t9 = L_a_2*d_2_z
    s_2_z = r_2_z - t9
    t10 = L_a_3*d_3_x
    s_3_x = r_3_x - t10
    t11 = L_a_3*d_3_y
    s_3_y = r_3_y - t11
    t12 = L_a_3*d_3_z
    s_3_z = r_3_z - t12
    t13 = L_a_1*t_1_x
    t14 = L_a_1*t_1_y
    t15 = L_a_1*t_1_z
    D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15
    t16 = L_a_2*t_2_x
    t17 = L_a_2*t_2_y
    t18 = L_a_2*t_2_z
    D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18
    t19 = L_a_3*t_3_x
    t20 = L_a_3*t_3_y
    t21 = L_a_3*t_3_z
    D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21
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
    t22 = 1.0/det_D_l
    t23 = D_r_1*t22
    D_p_x_1 = A_x_1*t23
    t24 = D_r_2*t22
    D_p_x_2 = A_x_2*t24
    t25 = D_r_3*t22
    D_p_x_3 = A_x_3*t25
    D_p_y_1 = A_y_1*t23
    D_p_y_2 = A_y_2*t24
    D_p_y_3 = A_y_3*t25
    D_p_z_1 = A_z_1*t23
    D_p_z_2 = A_z_2*t24
    D_p_z_3 = A_z_3*t25
    U_1_x_1 = D_p_x_1 - t13
    U_1_y_1 = D_p_y_1 - t14
    U_1_z_1 = D_p_z_1 - t15
    U_2_x_2 = D_p_x_2 - t16
    U_2_y_2 = D_p_y_2 - t17
    U_2_z_2 = D_p_z_2 - t18
    U_3_x_3 = D_p_x_3 - t19
    U_3_y_3 = D_p_y_3 - t20
    U_3_z_3 = D_p_z_3 - t21
    t26 = (1/2)*m_d_1
    t27 = (1/2)*m_d_2
    t28 = (1/2)*m_d_3
    t29 = m_p + t26 + t27 + t28
    t30 = g_x*t29
    t31 = g_y*t29
    t32 = g_z*t29
    mu_1 = t22*(-A_x_1*t30 - A_y_1*t31 - A_z_1*t32)
    mu_2 = t22*(-A_x_2*t30 - A_y_2*t31 - A_z_2*t32)
    mu_3 = t22*(-A_x_3*t30 - A_y_3*t31 - A_z_3*t32)
    t33 = D_p_x_1**2
    t34 = D_p_y_1**2
    t35 = D_p_z_1**2
    t36 = L_a_1*t26 + m_a_1*r_a_1
    t37 = D_p_x_1*mu_3
    t38 = D_p_x_1*mu_2
    t39 = U_1_x_1*mu_1
    t40 = D_p_y_1*mu_3
    t41 = D_p_y_1*mu_2
    t42 = U_1_y_1*mu_1
    t43 = D_p_z_1*mu_3
    t44 = D_p_z_1*mu_2
    t45 = U_1_z_1*mu_1
    t46 = D_p_x_2**2
    t47 = D_p_y_2**2
    t48 = D_p_z_2**2
    t49 = L_a_2*t27 + m_a_2*r_a_2
    t50 = D_p_x_3**2
    t51 = D_p_y_3**2
    t52 = D_p_z_3**2
    t53 = L_a_3*t28 + m_a_3*r_a_3
    K_out = np.zeros((*batch, 6, 6), dtype)
    K_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 + d_1_x*g_x*t36 + d_1_y*g_y*t36 + d_1_z*g_z*t36
        + k_r_1 - mu_1*s_1_x*t4 - mu_1*s_1_y*t5 - mu_1*s_1_z*t6 - mu_2*t33 - mu_2*t34 - mu_2*t35 - mu_3*t33
        - mu_3*t34 - mu_3*t35
    )
    K_out[..., 0, 1] = K_out[..., 1, 0] = (
        -D_p_x_2*t37 - D_p_x_2*t39 - D_p_y_2*t40 - D_p_y_2*t42 - D_p_z_2*t43 - D_p_z_2*t45 - U_2_x_2*t38
        - U_2_y_2*t41 - U_2_z_2*t44
    )
    K_out[..., 0, 2] = K_out[..., 2, 0] = (
        -D_p_x_3*t38 - D_p_x_3*t39 - D_p_y_3*t41 - D_p_y_3*t42 - D_p_z_3*t44 - D_p_z_3*t45 - U_3_x_3*t37
        - U_3_y_3*t40 - U_3_z_3*t43
    )
    K_out[..., 0, 3] = K_out[..., 3, 0] = -k_r_1
    K_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 + d_2_x*g_x*t49 + d_2_y*g_y*t49 + d_2_z*g_z*t49
        + k_r_2 - mu_1*t46 - mu_1*t47 - mu_1*t48 - mu_2*s_2_x*t7 - mu_2*s_2_y*t8 - mu_2*s_2_z*t9 - mu_3*t46
        - mu_3*t47 - mu_3*t48
    )
    K_out[..., 1, 2] = K_out[..., 2, 1] = (
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2
    )
    K_out[..., 1, 4] = K_out[..., 4, 1] = -k_r_2
    K_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 + d_3_x*g_x*t53 + d_3_y*g_y*t53 + d_3_z*g_z*t53
        + k_r_3 - mu_1*t50 - mu_1*t51 - mu_1*t52 - mu_2*t50 - mu_2*t51 - mu_2*t52 - mu_3*s_3_x*t10
        - mu_3*s_3_y*t11 - mu_3*s_3_z*t12
    )
    K_out[..., 2, 5] = K_out[..., 5, 2] = -k_r_3
    K_out[..., 3, 3] = k_r_1
    K_out[..., 4, 4] = k_r_2
    K_out[..., 5, 5] = k_r_3
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
    M : array, shape (..., 6, 6) [kg m^2]
        Mass matrix.
    K : array, shape (..., 6, 6) [N m]
        Symmetric; Hessian of V_el + V_g, positive for a restoring force.

    Notes
    -----
    Equation 48.
    666 operations; 2347362 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    I_a_1, I_a_2, I_a_3 = _entries(parameters.arm_inertia, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, I_a_1, l_d_1, m_d_1,
        k_r_1, I_m_1, i_g_1, sigma_1)
    y_1_x = a_1_y*z_1_z - a_1_z*z_1_y
    y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x
    y_1_z = a_1_x*z_1_y - a_1_y*z_1_x
    y_2_x = a_2_y*z_2_z - a_2_z*z_2_y
    y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x
    y_2_z = a_2_x*z_2_y - a_2_y*z_2_x
    y_3_x = a_3_y*z_3_z - a_3_z*z_3_y
    y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x
    y_3_z = a_3_x*z_3_y - a_3_y*z_3_x
    r_1_x = b_1_x - o_1_x + p_x
    r_1_y = b_1_y - o_1_y + p_y
    r_1_z = b_1_z - o_1_z + p_z
    r_2_x = b_2_x - o_2_x + p_x
    r_2_y = b_2_y - o_2_y + p_y
    r_2_z = b_2_z - o_2_z + p_z
    r_3_x = b_3_x - o_3_x + p_x
    r_3_y = b_3_y - o_3_y + p_y
    r_3_z = b_3_z - o_3_z + p_z
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    t1 = L_a_1**2
    C_1 = (1/2)*(-l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2 + t1)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t2 = 1.0/rho2_1
    c_1 = t2*(A_1*C_1 - B_1*S_1)
    sn_1 = t2*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    t3 = L_a_2**2
    C_2 = (1/2)*(-l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2 + t3)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t4 = 1.0/rho2_2
    c_2 = t4*(A_2*C_2 - B_2*S_2)
    sn_2 = t4*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t5 = L_a_3**2
    C_3 = (1/2)*(-l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2 + t5)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t6 = 1.0/rho2_3
    c_3 = t6*(A_3*C_3 - B_3*S_3)
    sn_3 = t6*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    t_1_x = c_1*y_1_x - sn_1*z_1_x
    t_1_y = c_1*y_1_y - sn_1*z_1_y
    t_1_z = c_1*y_1_z - sn_1*z_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    t_2_x = c_2*y_2_x - sn_2*z_2_x
    t_2_y = c_2*y_2_y - sn_2*z_2_y
    t_2_z = c_2*y_2_z - sn_2*z_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t_3_x = c_3*y_3_x - sn_3*z_3_x
    t_3_y = c_3*y_3_y - sn_3*z_3_y
    t_3_z = c_3*y_3_z - sn_3*z_3_z
    t7 = L_a_1*d_1_x
    s_1_x = r_1_x - t7
    t8 = L_a_1*d_1_y
    s_1_y = r_1_y - t8
    t9 = L_a_1*d_1_z
    s_1_z = r_1_z - t9
    t10 = L_a_2*d_2_x
    s_2_x = r_2_x - t10
    t11 = L_a_2*d_2_y
    s_2_y = r_2_y - t11
    t12 = L_a_2*d_2_z
    s_2_z = r_2_z - t12
    t13 = L_a_3*d_3_x
    s_3_x = r_3_x - t13
    t14 = L_a_3*d_3_y
    s_3_y = r_3_y - t14
    t15 = L_a_3*d_3_z
    s_3_z = r_3_z - t15
    t16 = L_a_1*t_1_x
    t17 = L_a_1*t_1_y
    t18 = L_a_1*t_1_z
    D_r_1 = s_1_x*t16 + s_1_y*t17 + s_1_z*t18
    t19 = L_a_2*t_2_x
    t20 = L_a_2*t_2_y
    t21 = L_a_2*t_2_z
    D_r_2 = s_2_x*t19 + s_2_y*t20 + s_2_z*t21
    t22 = L_a_3*t_3_x
    t23 = L_a_3*t_3_y
    t24 = L_a_3*t_3_z
    D_r_3 = s_3_x*t22 + s_3_y*t23 + s_3_z*t24
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
    t25 = 1.0/det_D_l
    t26 = D_r_1*t25
    D_p_x_1 = A_x_1*t26
    t27 = D_r_2*t25
    D_p_x_2 = A_x_2*t27
    t28 = D_r_3*t25
    D_p_x_3 = A_x_3*t28
    D_p_y_1 = A_y_1*t26
    D_p_y_2 = A_y_2*t27
    D_p_y_3 = A_y_3*t28
    D_p_z_1 = A_z_1*t26
    D_p_z_2 = A_z_2*t27
    D_p_z_3 = A_z_3*t28
    U_1_x_1 = D_p_x_1 - t16
    U_1_y_1 = D_p_y_1 - t17
    U_1_z_1 = D_p_z_1 - t18
    U_2_x_2 = D_p_x_2 - t19
    U_2_y_2 = D_p_y_2 - t20
    U_2_z_2 = D_p_z_2 - t21
    U_3_x_3 = D_p_x_3 - t22
    U_3_y_3 = D_p_y_3 - t23
    U_3_z_3 = D_p_z_3 - t24
    I_1 = I_m_1*i_g_1**2
    I_2 = I_m_2*i_g_2**2
    I_3 = I_m_3*i_g_3**2
    t29 = (1/2)*m_d_1
    t30 = (1/2)*m_d_2
    t31 = (1/2)*m_d_3
    t32 = m_p + t29 + t30 + t31
    t33 = g_x*t32
    t34 = g_y*t32
    t35 = g_z*t32
    mu_1 = t25*(-A_x_1*t33 - A_y_1*t34 - A_z_1*t35)
    mu_2 = t25*(-A_x_2*t33 - A_y_2*t34 - A_z_2*t35)
    mu_3 = t25*(-A_x_3*t33 - A_y_3*t34 - A_z_3*t35)
    t36 = (1/3)*m_d_1
    t37 = (1/6)*m_d_1
    t38 = t16*t37
    t39 = t17*t37
    t40 = t18*t37
    t41 = (1/3)*m_d_2
    t42 = (1/3)*m_d_3
    t43 = m_p + t36 + t41 + t42
    t44 = D_p_x_1*t43 + t38
    t45 = D_p_y_1*t43 + t39
    t46 = D_p_z_1*t43 + t40
    t47 = (1/6)*m_d_2
    t48 = t19*t47
    t49 = t20*t47
    t50 = t21*t47
    t51 = (1/6)*m_d_3
    t52 = t22*t51
    t53 = t23*t51
    t54 = t24*t51
    t55 = D_p_x_2*t43 + t48
    t56 = D_p_y_2*t43 + t49
    t57 = D_p_z_2*t43 + t50
    t58 = D_p_x_1**2
    t59 = D_p_y_1**2
    t60 = D_p_z_1**2
    t61 = L_a_1*t29 + m_a_1*r_a_1
    t62 = D_p_x_1*mu_3
    t63 = D_p_x_1*mu_2
    t64 = U_1_x_1*mu_1
    t65 = D_p_y_1*mu_3
    t66 = D_p_y_1*mu_2
    t67 = U_1_y_1*mu_1
    t68 = D_p_z_1*mu_3
    t69 = D_p_z_1*mu_2
    t70 = U_1_z_1*mu_1
    t71 = D_p_x_2**2
    t72 = D_p_y_2**2
    t73 = D_p_z_2**2
    t74 = L_a_2*t30 + m_a_2*r_a_2
    t75 = D_p_x_3**2
    t76 = D_p_y_3**2
    t77 = D_p_z_3**2
    t78 = L_a_3*t31 + m_a_3*r_a_3
    M_out = np.zeros((*batch, 6, 6), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t38 + D_p_x_1*t44 + D_p_y_1*t39 + D_p_y_1*t45 + D_p_z_1*t40 + D_p_z_1*t46 + I_a_1 + t1*t36
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_x_1*t48 + D_p_x_2*t44 + D_p_y_1*t49 + D_p_y_2*t45 + D_p_z_1*t50 + D_p_z_2*t46
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_x_1*t52 + D_p_x_3*t44 + D_p_y_1*t53 + D_p_y_3*t45 + D_p_z_1*t54 + D_p_z_3*t46
    )
    M_out[..., 1, 1] = (
        D_p_x_2*t48 + D_p_x_2*t55 + D_p_y_2*t49 + D_p_y_2*t56 + D_p_z_2*t50 + D_p_z_2*t57 + I_a_2 + t3*t41
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_x_2*t52 + D_p_x_3*t55 + D_p_y_2*t53 + D_p_y_3*t56 + D_p_z_2*t54 + D_p_z_3*t57
    )
    M_out[..., 2, 2] = (
        D_p_x_3*t52 + D_p_x_3*(D_p_x_3*t43 + t52) + D_p_y_3*t53 + D_p_y_3*(D_p_y_3*t43 + t53) + D_p_z_3*t54
        + D_p_z_3*(D_p_z_3*t43 + t54) + I_a_3 + t42*t5
    )
    M_out[..., 3, 3] = I_1
    M_out[..., 4, 4] = I_2
    M_out[..., 5, 5] = I_3
    K_out = np.zeros((*batch, 6, 6), dtype)
    K_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 + d_1_x*g_x*t61 + d_1_y*g_y*t61 + d_1_z*g_z*t61
        + k_r_1 - mu_1*s_1_x*t7 - mu_1*s_1_y*t8 - mu_1*s_1_z*t9 - mu_2*t58 - mu_2*t59 - mu_2*t60 - mu_3*t58
        - mu_3*t59 - mu_3*t60
    )
    K_out[..., 0, 1] = K_out[..., 1, 0] = (
        -D_p_x_2*t62 - D_p_x_2*t64 - D_p_y_2*t65 - D_p_y_2*t67 - D_p_z_2*t68 - D_p_z_2*t70 - U_2_x_2*t63
        - U_2_y_2*t66 - U_2_z_2*t69
    )
    K_out[..., 0, 2] = K_out[..., 2, 0] = (
        -D_p_x_3*t63 - D_p_x_3*t64 - D_p_y_3*t66 - D_p_y_3*t67 - D_p_z_3*t69 - D_p_z_3*t70 - U_3_x_3*t62
        - U_3_y_3*t65 - U_3_z_3*t68
    )
    K_out[..., 0, 3] = K_out[..., 3, 0] = -k_r_1
    K_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 + d_2_x*g_x*t74 + d_2_y*g_y*t74 + d_2_z*g_z*t74
        + k_r_2 - mu_1*t71 - mu_1*t72 - mu_1*t73 - mu_2*s_2_x*t10 - mu_2*s_2_y*t11 - mu_2*s_2_z*t12 - mu_3*t71
        - mu_3*t72 - mu_3*t73
    )
    K_out[..., 1, 2] = K_out[..., 2, 1] = (
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2
    )
    K_out[..., 1, 4] = K_out[..., 4, 1] = -k_r_2
    K_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 + d_3_x*g_x*t78 + d_3_y*g_y*t78 + d_3_z*g_z*t78
        + k_r_3 - mu_1*t75 - mu_1*t76 - mu_1*t77 - mu_2*t75 - mu_2*t76 - mu_2*t77 - mu_3*s_3_x*t13
        - mu_3*s_3_y*t14 - mu_3*s_3_z*t15
    )
    K_out[..., 2, 5] = K_out[..., 5, 2] = -k_r_3
    K_out[..., 3, 3] = k_r_1
    K_out[..., 4, 4] = k_r_2
    K_out[..., 5, 5] = k_r_3
    return M_out, K_out
