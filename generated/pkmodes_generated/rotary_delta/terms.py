# Generated from the derivation of rotary_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Terms of the mechanism rotary_delta: motion of its bodies, and what holds them yielding.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: axis j; coordinate k of a derivative; component i = x, y, z.  t1, t2, ... are
subexpressions shared by several values.

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
* D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* U_j_i_k [m]: derivative of linkage vector j, component i, with respect to theta_k
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
"""

from math import prod

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "mount_inertia",
    "mount_matrices",
    "place_motion",
]

#: Generalised coordinates, in the order of M and K, and their units.
COORDINATES = (
    "theta_1",
    "theta_2",
    "theta_3",
    "phi_1",
    "phi_2",
    "phi_3",
    "delta_1",
    "delta_2",
    "delta_3",
    "u_x",
    "u_y",
    "u_z",
)
COORDINATE_UNITS = (
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "rad",
    "m",
    "m",
    "m",
    "m",
    "m",
    "m",
)


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


def place_motion(p, parameters):
    """Displacements of the places of terms per unit of every coordinate.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J : array, shape (..., 21, 12) [1, m]
        One row for each displacement.

    Notes
    -----
    The velocities of the bodies that the mechanism declares, without the mounts of terms.
    351 operations; 469611 with every named value expanded.
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
    t4 = L_a_1*t_1_x
    t5 = L_a_1*t_1_y
    t6 = L_a_1*t_1_z
    D_r_1 = s_1_x*t4 + s_1_y*t5 + s_1_z*t6
    t7 = L_a_2*t_2_x
    t8 = L_a_2*t_2_y
    t9 = L_a_2*t_2_z
    D_r_2 = s_2_x*t7 + s_2_y*t8 + s_2_z*t9
    t10 = L_a_3*t_3_y
    t11 = L_a_3*t_3_z
    t12 = L_a_3*t_3_x
    D_r_3 = s_3_x*t12 + s_3_y*t10 + s_3_z*t11
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
    t13 = 1.0/det_D_l
    t14 = A_x_1*t13
    D_p_x_1 = D_r_1*t14
    t15 = A_x_2*t13
    D_p_x_2 = D_r_2*t15
    t16 = A_x_3*t13
    D_p_x_3 = D_r_3*t16
    D_delta_x_1 = l_d_1*t14
    D_delta_x_2 = l_d_2*t15
    D_delta_x_3 = l_d_3*t16
    t17 = A_y_1*t13
    D_p_y_1 = D_r_1*t17
    t18 = A_y_2*t13
    D_p_y_2 = D_r_2*t18
    t19 = A_y_3*t13
    D_p_y_3 = D_r_3*t19
    D_delta_y_1 = l_d_1*t17
    D_delta_y_2 = l_d_2*t18
    D_delta_y_3 = l_d_3*t19
    t20 = A_z_1*t13
    D_p_z_1 = D_r_1*t20
    t21 = A_z_2*t13
    D_p_z_2 = D_r_2*t21
    t22 = A_z_3*t13
    D_p_z_3 = D_r_3*t22
    D_delta_z_1 = l_d_1*t20
    D_delta_z_2 = l_d_2*t21
    D_delta_z_3 = l_d_3*t22
    t23 = (1/2)*D_p_x_1
    t24 = (1/2)*D_p_x_2
    t25 = (1/2)*D_p_x_3
    t26 = (1/2)*D_delta_x_1
    t27 = (1/2)*D_delta_x_2
    t28 = (1/2)*D_delta_x_3
    t29 = (1/2)*D_p_y_1
    t30 = (1/2)*D_p_y_2
    t31 = (1/2)*D_p_y_3
    t32 = (1/2)*D_delta_y_1
    t33 = (1/2)*D_delta_y_2
    t34 = (1/2)*D_delta_y_3
    t35 = (1/2)*D_p_z_1
    t36 = (1/2)*D_p_z_2
    t37 = (1/2)*D_p_z_3
    t38 = (1/2)*D_delta_z_1
    t39 = (1/2)*D_delta_z_2
    t40 = (1/2)*D_delta_z_3
    J_out = np.zeros((*batch, 21, 12), dtype)
    J_out[..., 0, 0] = D_p_x_1
    J_out[..., 0, 1] = D_p_x_2
    J_out[..., 0, 2] = D_p_x_3
    J_out[..., 0, 6] = D_delta_x_1
    J_out[..., 0, 7] = D_delta_x_2
    J_out[..., 0, 8] = D_delta_x_3
    J_out[..., 0, 9] = 1
    J_out[..., 1, 0] = D_p_y_1
    J_out[..., 1, 1] = D_p_y_2
    J_out[..., 1, 2] = D_p_y_3
    J_out[..., 1, 6] = D_delta_y_1
    J_out[..., 1, 7] = D_delta_y_2
    J_out[..., 1, 8] = D_delta_y_3
    J_out[..., 1, 10] = 1
    J_out[..., 2, 0] = D_p_z_1
    J_out[..., 2, 1] = D_p_z_2
    J_out[..., 2, 2] = D_p_z_3
    J_out[..., 2, 6] = D_delta_z_1
    J_out[..., 2, 7] = D_delta_z_2
    J_out[..., 2, 8] = D_delta_z_3
    J_out[..., 2, 11] = 1
    J_out[..., 3, 0] = 1
    J_out[..., 4, 1] = 1
    J_out[..., 5, 2] = 1
    J_out[..., 6, 3] = 1
    J_out[..., 7, 4] = 1
    J_out[..., 8, 5] = 1
    J_out[..., 9, 9] = 1
    J_out[..., 10, 10] = 1
    J_out[..., 11, 11] = 1
    J_out[..., 12, 0] = t23 + (1/2)*t4
    J_out[..., 12, 1] = t24
    J_out[..., 12, 2] = t25
    J_out[..., 12, 6] = t26
    J_out[..., 12, 7] = t27
    J_out[..., 12, 8] = t28
    J_out[..., 12, 9] = 1
    J_out[..., 13, 0] = t29 + (1/2)*t5
    J_out[..., 13, 1] = t30
    J_out[..., 13, 2] = t31
    J_out[..., 13, 6] = t32
    J_out[..., 13, 7] = t33
    J_out[..., 13, 8] = t34
    J_out[..., 13, 10] = 1
    J_out[..., 14, 0] = t35 + (1/2)*t6
    J_out[..., 14, 1] = t36
    J_out[..., 14, 2] = t37
    J_out[..., 14, 6] = t38
    J_out[..., 14, 7] = t39
    J_out[..., 14, 8] = t40
    J_out[..., 14, 11] = 1
    J_out[..., 15, 0] = t23
    J_out[..., 15, 1] = t24 + (1/2)*t7
    J_out[..., 15, 2] = t25
    J_out[..., 15, 6] = t26
    J_out[..., 15, 7] = t27
    J_out[..., 15, 8] = t28
    J_out[..., 15, 9] = 1
    J_out[..., 16, 0] = t29
    J_out[..., 16, 1] = t30 + (1/2)*t8
    J_out[..., 16, 2] = t31
    J_out[..., 16, 6] = t32
    J_out[..., 16, 7] = t33
    J_out[..., 16, 8] = t34
    J_out[..., 16, 10] = 1
    J_out[..., 17, 0] = t35
    J_out[..., 17, 1] = t36 + (1/2)*t9
    J_out[..., 17, 2] = t37
    J_out[..., 17, 6] = t38
    J_out[..., 17, 7] = t39
    J_out[..., 17, 8] = t40
    J_out[..., 17, 11] = 1
    J_out[..., 18, 0] = t23
    J_out[..., 18, 1] = t24
    J_out[..., 18, 2] = (1/2)*t12 + t25
    J_out[..., 18, 6] = t26
    J_out[..., 18, 7] = t27
    J_out[..., 18, 8] = t28
    J_out[..., 18, 9] = 1
    J_out[..., 19, 0] = t29
    J_out[..., 19, 1] = t30
    J_out[..., 19, 2] = (1/2)*t10 + t31
    J_out[..., 19, 6] = t32
    J_out[..., 19, 7] = t33
    J_out[..., 19, 8] = t34
    J_out[..., 19, 10] = 1
    J_out[..., 20, 0] = t35
    J_out[..., 20, 1] = t36
    J_out[..., 20, 2] = (1/2)*t11 + t37
    J_out[..., 20, 6] = t38
    J_out[..., 20, 7] = t39
    J_out[..., 20, 8] = t40
    J_out[..., 20, 11] = 1
    return J_out


def mount_matrices(p, parameters, effects):
    """Rows of M and K of what holds a body, where it yields alone.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.
    effects : Effects
        The robot's effects.

    Returns
    -------
    M_wq : array, shape (..., 9, 12) [kg, kg m]
        Entries of M between each mount and every coordinate.
    M_ww : array, shape (..., 9) [kg, kg m]
        Diagonal entry of M of each mount.
    K_wq : array, shape (..., 9, 12) [N/m, N]
        Entries of K between each mount and every coordinate.
    K_ww : array, shape (..., 9) [N/m, N]
        Diagonal entry of K of each mount.
    J_p : array, shape (..., 9, 3) [1, 1/m]
        Motion of the platform per unit of each mount.

    Notes
    -----
    Equations 24 to 48 with these displacements released; without the springs of the mounts.
    2770 operations; 16350408 with every named value expanded.
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
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1,
        sigma_1, k_C, m_L)
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
    t4 = L_a_1*t_1_x
    t5 = L_a_1*t_1_y
    t6 = L_a_1*t_1_z
    D_r_1 = s_1_x*t4 + s_1_y*t5 + s_1_z*t6
    t7 = L_a_2*t_2_x
    t8 = L_a_2*t_2_y
    t9 = L_a_2*t_2_z
    D_r_2 = s_2_x*t7 + s_2_y*t8 + s_2_z*t9
    t10 = L_a_3*t_3_y
    t11 = L_a_3*t_3_z
    t12 = L_a_3*t_3_x
    D_r_3 = s_3_x*t12 + s_3_y*t10 + s_3_z*t11
    A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y
    A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x
    A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x
    A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y
    A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x
    A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x
    A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y
    A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x
    A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x
    t13 = A_x_1*s_1_x
    t14 = A_y_1*s_1_y
    t15 = A_z_1*s_1_z
    det_D_l = t13 + t14 + t15
    t16 = 1.0/det_D_l
    t17 = A_x_1*t16
    D_p_x_1 = D_r_1*t17
    t18 = A_x_2*t16
    D_p_x_2 = D_r_2*t18
    t19 = A_x_3*t16
    D_p_x_3 = D_r_3*t19
    D_delta_x_1 = l_d_1*t17
    D_delta_x_2 = l_d_2*t18
    D_delta_x_3 = l_d_3*t19
    D_delta_x_4 = t13*t16
    D_delta_x_5 = s_1_y*t17
    D_delta_x_6 = s_1_z*t17
    D_delta_x_7 = s_2_x*t18
    D_delta_x_8 = s_2_y*t18
    D_delta_x_9 = s_2_z*t18
    D_delta_x_10 = s_3_x*t19
    D_delta_x_11 = s_3_y*t19
    D_delta_x_12 = s_3_z*t19
    t20 = A_y_1*t16
    D_p_y_1 = D_r_1*t20
    t21 = A_y_2*t16
    D_p_y_2 = D_r_2*t21
    t22 = A_y_3*t16
    D_p_y_3 = D_r_3*t22
    D_delta_y_1 = l_d_1*t20
    D_delta_y_2 = l_d_2*t21
    D_delta_y_3 = l_d_3*t22
    D_delta_y_4 = s_1_x*t20
    D_delta_y_5 = t14*t16
    D_delta_y_6 = s_1_z*t20
    D_delta_y_7 = s_2_x*t21
    D_delta_y_8 = s_2_y*t21
    D_delta_y_9 = s_2_z*t21
    D_delta_y_10 = s_3_x*t22
    D_delta_y_11 = s_3_y*t22
    D_delta_y_12 = s_3_z*t22
    t23 = A_z_1*t16
    D_p_z_1 = D_r_1*t23
    t24 = A_z_2*t16
    D_p_z_2 = D_r_2*t24
    t25 = A_z_3*t16
    D_p_z_3 = D_r_3*t25
    D_delta_z_1 = l_d_1*t23
    D_delta_z_2 = l_d_2*t24
    D_delta_z_3 = l_d_3*t25
    D_delta_z_4 = s_1_x*t23
    D_delta_z_5 = s_1_y*t23
    D_delta_z_6 = t15*t16
    D_delta_z_7 = s_2_x*t24
    D_delta_z_8 = s_2_y*t24
    D_delta_z_9 = s_2_z*t24
    D_delta_z_10 = s_3_x*t25
    D_delta_z_11 = s_3_y*t25
    D_delta_z_12 = s_3_z*t25
    U_1_x_1 = D_p_x_1 - t4
    U_1_y_1 = D_p_y_1 - t5
    U_1_z_1 = D_p_z_1 - t6
    U_2_x_2 = D_p_x_2 - t7
    U_2_y_2 = D_p_y_2 - t8
    U_2_z_2 = D_p_z_2 - t9
    U_3_x_3 = D_p_x_3 - t12
    U_3_y_3 = D_p_y_3 - t10
    U_3_z_3 = D_p_z_3 - t11
    t26 = (1/2)*m_d_1
    t27 = (1/2)*m_d_2
    t28 = (1/2)*m_d_3
    t29 = m_L + m_p
    t30 = t26 + t27 + t28 + t29
    t31 = g_x*t30
    t32 = g_y*t30
    t33 = g_z*t30
    mu_1 = t16*(-A_x_1*t31 - A_y_1*t32 - A_z_1*t33)
    mu_2 = t16*(-A_x_2*t31 - A_y_2*t32 - A_z_2*t33)
    mu_3 = t16*(-A_x_3*t31 - A_y_3*t32 - A_z_3*t33)
    t34 = (1/6)*m_d_1
    t35 = m_a_1*r_a_1
    t36 = (1/3)*m_d_1
    t37 = (1/3)*m_d_2
    t38 = (1/3)*m_d_3
    t39 = t29 + t36 + t37 + t38
    t40 = D_p_x_1*t39 + t34*t4
    t41 = D_p_y_1*t39 + t34*t5
    t42 = D_p_z_1*t39 + t34*t6
    t43 = (1/6)*m_d_2
    t44 = D_p_x_2*t39 + t43*t7
    t45 = D_p_y_2*t39 + t43*t8
    t46 = D_p_z_2*t39 + t43*t9
    t47 = (1/6)*m_d_3
    t48 = D_p_x_3*t39 + t12*t47
    t49 = D_p_y_3*t39 + t10*t47
    t50 = D_p_z_3*t39 + t11*t47
    t51 = D_delta_x_4*t39
    t52 = D_delta_y_4*t39
    t53 = D_delta_z_4*t39
    t54 = m_a_1 + t26
    t55 = D_delta_x_5*t39
    t56 = D_delta_y_5*t39
    t57 = D_delta_z_5*t39
    t58 = D_delta_x_6*t39
    t59 = D_delta_y_6*t39
    t60 = D_delta_z_6*t39
    t61 = m_a_2*r_a_2
    t62 = D_delta_x_7*t39
    t63 = D_delta_y_7*t39
    t64 = D_delta_z_7*t39
    t65 = m_a_2 + t27
    t66 = D_delta_x_8*t39
    t67 = D_delta_y_8*t39
    t68 = D_delta_z_8*t39
    t69 = D_delta_x_9*t39
    t70 = D_delta_y_9*t39
    t71 = D_delta_z_9*t39
    t72 = m_a_3*r_a_3
    t73 = D_delta_x_10*t39
    t74 = D_delta_y_10*t39
    t75 = D_delta_z_10*t39
    t76 = m_a_3 + t28
    t77 = D_delta_x_11*t39
    t78 = D_delta_y_11*t39
    t79 = D_delta_z_11*t39
    t80 = D_delta_x_12*t39
    t81 = D_delta_y_12*t39
    t82 = D_delta_z_12*t39
    t83 = D_delta_y_4**2
    t84 = D_delta_z_4**2
    t85 = m_a_1 + t36
    t86 = D_delta_x_5**2
    t87 = D_delta_z_5**2
    t88 = D_delta_x_6**2
    t89 = D_delta_y_6**2
    t90 = D_delta_y_7**2
    t91 = D_delta_z_7**2
    t92 = m_a_2 + t37
    t93 = D_delta_x_8**2
    t94 = D_delta_z_8**2
    t95 = D_delta_x_9**2
    t96 = D_delta_y_9**2
    t97 = D_delta_y_10**2
    t98 = D_delta_z_10**2
    t99 = m_a_3 + t38
    t100 = D_delta_z_11**2
    t101 = D_delta_x_11**2
    t102 = D_delta_x_12**2
    t103 = D_delta_y_12**2
    t104 = D_delta_x_4*D_p_x_1
    t105 = D_delta_y_4*D_p_y_1
    t106 = D_delta_y_4*mu_1
    t107 = D_delta_z_4*D_p_z_1
    t108 = D_delta_z_4*mu_1
    t109 = D_delta_x_4 - 1
    t110 = mu_1*t109
    t111 = D_delta_x_4*mu_3
    t112 = D_delta_x_4*mu_2
    t113 = D_delta_y_4*mu_3
    t114 = D_delta_y_4*mu_2
    t115 = D_delta_z_4*mu_3
    t116 = D_delta_z_4*mu_2
    t117 = D_delta_x_5*D_p_x_1
    t118 = D_delta_x_5*mu_1
    t119 = D_delta_y_5*D_p_y_1
    t120 = D_delta_z_5*D_p_z_1
    t121 = D_delta_z_5*mu_1
    t122 = D_delta_y_5 - 1
    t123 = mu_1*t122
    t124 = D_delta_x_5*mu_3
    t125 = D_delta_x_5*mu_2
    t126 = D_delta_y_5*mu_3
    t127 = D_delta_y_5*mu_2
    t128 = D_delta_z_5*mu_3
    t129 = D_delta_z_5*mu_2
    t130 = D_delta_x_6*D_p_x_1
    t131 = D_delta_x_6*mu_1
    t132 = D_delta_y_6*D_p_y_1
    t133 = D_delta_y_6*mu_1
    t134 = D_delta_z_6*D_p_z_1
    t135 = D_delta_z_6 - 1
    t136 = mu_1*t135
    t137 = D_delta_x_6*mu_3
    t138 = D_delta_x_6*mu_2
    t139 = D_delta_y_6*mu_3
    t140 = D_delta_y_6*mu_2
    t141 = D_delta_z_6*mu_3
    t142 = D_delta_z_6*mu_2
    t143 = D_delta_x_7*mu_3
    t144 = D_delta_x_7*mu_1
    t145 = D_delta_y_7*D_p_y_1
    t146 = D_delta_y_7*mu_1
    t147 = D_delta_z_7*D_p_z_1
    t148 = D_delta_z_7*mu_1
    t149 = D_delta_x_7 - 1
    t150 = mu_2*t149
    t151 = D_delta_y_7*mu_3
    t152 = D_delta_y_7*mu_2
    t153 = D_delta_z_7*mu_3
    t154 = D_delta_z_7*mu_2
    t155 = D_delta_x_8*D_p_x_1
    t156 = D_delta_x_8*mu_1
    t157 = D_delta_y_8*mu_3
    t158 = D_delta_y_8*mu_1
    t159 = D_delta_z_8*D_p_z_1
    t160 = D_delta_z_8*mu_1
    t161 = D_delta_y_8 - 1
    t162 = mu_2*t161
    t163 = D_delta_x_8*mu_3
    t164 = D_delta_x_8*mu_2
    t165 = D_delta_z_8*mu_3
    t166 = D_delta_z_8*mu_2
    t167 = D_delta_x_9*D_p_x_1
    t168 = D_delta_x_9*mu_1
    t169 = D_delta_y_9*D_p_y_1
    t170 = D_delta_y_9*mu_1
    t171 = D_delta_z_9*mu_3
    t172 = D_delta_z_9*mu_1
    t173 = D_delta_z_9 - 1
    t174 = mu_2*t173
    t175 = D_delta_x_9*mu_3
    t176 = D_delta_x_9*mu_2
    t177 = D_delta_y_9*mu_3
    t178 = D_delta_y_9*mu_2
    t179 = D_delta_x_10*mu_2
    t180 = D_delta_x_10*mu_1
    t181 = D_delta_y_10*D_p_y_1
    t182 = D_delta_y_10*mu_1
    t183 = D_delta_z_10*D_p_z_1
    t184 = D_delta_z_10*mu_1
    t185 = D_delta_x_10 - 1
    t186 = mu_3*t185
    t187 = D_delta_y_10*mu_3
    t188 = D_delta_y_10*mu_2
    t189 = D_delta_z_10*mu_3
    t190 = D_delta_z_10*mu_2
    t191 = D_delta_x_11*D_p_x_1
    t192 = D_delta_x_11*mu_1
    t193 = D_delta_y_11*mu_2
    t194 = D_delta_y_11*mu_1
    t195 = D_delta_z_11*D_p_z_1
    t196 = D_delta_z_11*mu_1
    t197 = D_delta_y_11 - 1
    t198 = mu_3*t197
    t199 = D_delta_x_11*mu_3
    t200 = D_delta_x_11*mu_2
    t201 = D_delta_z_11*mu_3
    t202 = D_delta_z_11*mu_2
    t203 = D_delta_x_12*D_p_x_1
    t204 = D_delta_x_12*mu_1
    t205 = D_delta_y_12*D_p_y_1
    t206 = D_delta_y_12*mu_1
    t207 = D_delta_z_12*mu_2
    t208 = D_delta_z_12*mu_1
    t209 = D_delta_z_12 - 1
    t210 = mu_3*t209
    t211 = D_delta_x_12*mu_3
    t212 = D_delta_x_12*mu_2
    t213 = D_delta_y_12*mu_3
    t214 = D_delta_y_12*mu_2
    t215 = D_delta_x_4**2
    t216 = D_delta_y_5**2
    t217 = D_delta_z_6**2
    t218 = D_delta_x_7**2
    t219 = D_delta_y_8**2
    t220 = D_delta_z_9**2
    t221 = D_delta_x_10**2
    t222 = D_delta_y_11**2
    t223 = D_delta_z_12**2
    M_wq_out = np.zeros((*batch, 9, 12), dtype)
    M_wq_out[..., 0, 0] = (
        D_delta_x_4*t40 + D_delta_y_4*t41 + D_delta_z_4*t42 + D_p_x_1*t34 + t35*t_1_x + t36*t4
    )
    M_wq_out[..., 0, 1] = D_delta_x_4*t44 + D_delta_y_4*t45 + D_delta_z_4*t46 + D_p_x_2*t34
    M_wq_out[..., 0, 2] = D_delta_x_4*t48 + D_delta_y_4*t49 + D_delta_z_4*t50 + D_p_x_3*t34
    M_wq_out[..., 0, 6] = D_delta_x_1*t34 + D_delta_x_1*t51 + D_delta_y_1*t52 + D_delta_z_1*t53
    M_wq_out[..., 0, 7] = D_delta_x_2*t34 + D_delta_x_2*t51 + D_delta_y_2*t52 + D_delta_z_2*t53
    M_wq_out[..., 0, 8] = D_delta_x_3*t34 + D_delta_x_3*t51 + D_delta_y_3*t52 + D_delta_z_3*t53
    M_wq_out[..., 0, 9] = D_delta_x_4*t30 + t54
    M_wq_out[..., 0, 10] = D_delta_y_4*t30
    M_wq_out[..., 0, 11] = D_delta_z_4*t30
    M_wq_out[..., 1, 0] = (
        D_delta_x_5*t40 + D_delta_y_5*t41 + D_delta_z_5*t42 + D_p_y_1*t34 + t35*t_1_y + t36*t5
    )
    M_wq_out[..., 1, 1] = D_delta_x_5*t44 + D_delta_y_5*t45 + D_delta_z_5*t46 + D_p_y_2*t34
    M_wq_out[..., 1, 2] = D_delta_x_5*t48 + D_delta_y_5*t49 + D_delta_z_5*t50 + D_p_y_3*t34
    M_wq_out[..., 1, 6] = D_delta_x_1*t55 + D_delta_y_1*t34 + D_delta_y_1*t56 + D_delta_z_1*t57
    M_wq_out[..., 1, 7] = D_delta_x_2*t55 + D_delta_y_2*t34 + D_delta_y_2*t56 + D_delta_z_2*t57
    M_wq_out[..., 1, 8] = D_delta_x_3*t55 + D_delta_y_3*t34 + D_delta_y_3*t56 + D_delta_z_3*t57
    M_wq_out[..., 1, 9] = D_delta_x_5*t30
    M_wq_out[..., 1, 10] = D_delta_y_5*t30 + t54
    M_wq_out[..., 1, 11] = D_delta_z_5*t30
    M_wq_out[..., 2, 0] = (
        D_delta_x_6*t40 + D_delta_y_6*t41 + D_delta_z_6*t42 + D_p_z_1*t34 + t35*t_1_z + t36*t6
    )
    M_wq_out[..., 2, 1] = D_delta_x_6*t44 + D_delta_y_6*t45 + D_delta_z_6*t46 + D_p_z_2*t34
    M_wq_out[..., 2, 2] = D_delta_x_6*t48 + D_delta_y_6*t49 + D_delta_z_6*t50 + D_p_z_3*t34
    M_wq_out[..., 2, 6] = D_delta_x_1*t58 + D_delta_y_1*t59 + D_delta_z_1*t34 + D_delta_z_1*t60
    M_wq_out[..., 2, 7] = D_delta_x_2*t58 + D_delta_y_2*t59 + D_delta_z_2*t34 + D_delta_z_2*t60
    M_wq_out[..., 2, 8] = D_delta_x_3*t58 + D_delta_y_3*t59 + D_delta_z_3*t34 + D_delta_z_3*t60
    M_wq_out[..., 2, 9] = D_delta_x_6*t30
    M_wq_out[..., 2, 10] = D_delta_y_6*t30
    M_wq_out[..., 2, 11] = D_delta_z_6*t30 + t54
    M_wq_out[..., 3, 0] = D_delta_x_7*t40 + D_delta_y_7*t41 + D_delta_z_7*t42 + D_p_x_1*t43
    M_wq_out[..., 3, 1] = (
        D_delta_x_7*t44 + D_delta_y_7*t45 + D_delta_z_7*t46 + D_p_x_2*t43 + t37*t7 + t61*t_2_x
    )
    M_wq_out[..., 3, 2] = D_delta_x_7*t48 + D_delta_y_7*t49 + D_delta_z_7*t50 + D_p_x_3*t43
    M_wq_out[..., 3, 6] = D_delta_x_1*t43 + D_delta_x_1*t62 + D_delta_y_1*t63 + D_delta_z_1*t64
    M_wq_out[..., 3, 7] = D_delta_x_2*t43 + D_delta_x_2*t62 + D_delta_y_2*t63 + D_delta_z_2*t64
    M_wq_out[..., 3, 8] = D_delta_x_3*t43 + D_delta_x_3*t62 + D_delta_y_3*t63 + D_delta_z_3*t64
    M_wq_out[..., 3, 9] = D_delta_x_7*t30 + t65
    M_wq_out[..., 3, 10] = D_delta_y_7*t30
    M_wq_out[..., 3, 11] = D_delta_z_7*t30
    M_wq_out[..., 4, 0] = D_delta_x_8*t40 + D_delta_y_8*t41 + D_delta_z_8*t42 + D_p_y_1*t43
    M_wq_out[..., 4, 1] = (
        D_delta_x_8*t44 + D_delta_y_8*t45 + D_delta_z_8*t46 + D_p_y_2*t43 + t37*t8 + t61*t_2_y
    )
    M_wq_out[..., 4, 2] = D_delta_x_8*t48 + D_delta_y_8*t49 + D_delta_z_8*t50 + D_p_y_3*t43
    M_wq_out[..., 4, 6] = D_delta_x_1*t66 + D_delta_y_1*t43 + D_delta_y_1*t67 + D_delta_z_1*t68
    M_wq_out[..., 4, 7] = D_delta_x_2*t66 + D_delta_y_2*t43 + D_delta_y_2*t67 + D_delta_z_2*t68
    M_wq_out[..., 4, 8] = D_delta_x_3*t66 + D_delta_y_3*t43 + D_delta_y_3*t67 + D_delta_z_3*t68
    M_wq_out[..., 4, 9] = D_delta_x_8*t30
    M_wq_out[..., 4, 10] = D_delta_y_8*t30 + t65
    M_wq_out[..., 4, 11] = D_delta_z_8*t30
    M_wq_out[..., 5, 0] = D_delta_x_9*t40 + D_delta_y_9*t41 + D_delta_z_9*t42 + D_p_z_1*t43
    M_wq_out[..., 5, 1] = (
        D_delta_x_9*t44 + D_delta_y_9*t45 + D_delta_z_9*t46 + D_p_z_2*t43 + t37*t9 + t61*t_2_z
    )
    M_wq_out[..., 5, 2] = D_delta_x_9*t48 + D_delta_y_9*t49 + D_delta_z_9*t50 + D_p_z_3*t43
    M_wq_out[..., 5, 6] = D_delta_x_1*t69 + D_delta_y_1*t70 + D_delta_z_1*t43 + D_delta_z_1*t71
    M_wq_out[..., 5, 7] = D_delta_x_2*t69 + D_delta_y_2*t70 + D_delta_z_2*t43 + D_delta_z_2*t71
    M_wq_out[..., 5, 8] = D_delta_x_3*t69 + D_delta_y_3*t70 + D_delta_z_3*t43 + D_delta_z_3*t71
    M_wq_out[..., 5, 9] = D_delta_x_9*t30
    M_wq_out[..., 5, 10] = D_delta_y_9*t30
    M_wq_out[..., 5, 11] = D_delta_z_9*t30 + t65
    M_wq_out[..., 6, 0] = D_delta_x_10*t40 + D_delta_y_10*t41 + D_delta_z_10*t42 + D_p_x_1*t47
    M_wq_out[..., 6, 1] = D_delta_x_10*t44 + D_delta_y_10*t45 + D_delta_z_10*t46 + D_p_x_2*t47
    M_wq_out[..., 6, 2] = (
        D_delta_x_10*t48 + D_delta_y_10*t49 + D_delta_z_10*t50 + D_p_x_3*t47 + t12*t38 + t72*t_3_x
    )
    M_wq_out[..., 6, 6] = D_delta_x_1*t47 + D_delta_x_1*t73 + D_delta_y_1*t74 + D_delta_z_1*t75
    M_wq_out[..., 6, 7] = D_delta_x_2*t47 + D_delta_x_2*t73 + D_delta_y_2*t74 + D_delta_z_2*t75
    M_wq_out[..., 6, 8] = D_delta_x_3*t47 + D_delta_x_3*t73 + D_delta_y_3*t74 + D_delta_z_3*t75
    M_wq_out[..., 6, 9] = D_delta_x_10*t30 + t76
    M_wq_out[..., 6, 10] = D_delta_y_10*t30
    M_wq_out[..., 6, 11] = D_delta_z_10*t30
    M_wq_out[..., 7, 0] = D_delta_x_11*t40 + D_delta_y_11*t41 + D_delta_z_11*t42 + D_p_y_1*t47
    M_wq_out[..., 7, 1] = D_delta_x_11*t44 + D_delta_y_11*t45 + D_delta_z_11*t46 + D_p_y_2*t47
    M_wq_out[..., 7, 2] = (
        D_delta_x_11*t48 + D_delta_y_11*t49 + D_delta_z_11*t50 + D_p_y_3*t47 + t10*t38 + t72*t_3_y
    )
    M_wq_out[..., 7, 6] = D_delta_x_1*t77 + D_delta_y_1*t47 + D_delta_y_1*t78 + D_delta_z_1*t79
    M_wq_out[..., 7, 7] = D_delta_x_2*t77 + D_delta_y_2*t47 + D_delta_y_2*t78 + D_delta_z_2*t79
    M_wq_out[..., 7, 8] = D_delta_x_3*t77 + D_delta_y_3*t47 + D_delta_y_3*t78 + D_delta_z_3*t79
    M_wq_out[..., 7, 9] = D_delta_x_11*t30
    M_wq_out[..., 7, 10] = D_delta_y_11*t30 + t76
    M_wq_out[..., 7, 11] = D_delta_z_11*t30
    M_wq_out[..., 8, 0] = D_delta_x_12*t40 + D_delta_y_12*t41 + D_delta_z_12*t42 + D_p_z_1*t47
    M_wq_out[..., 8, 1] = D_delta_x_12*t44 + D_delta_y_12*t45 + D_delta_z_12*t46 + D_p_z_2*t47
    M_wq_out[..., 8, 2] = (
        D_delta_x_12*t48 + D_delta_y_12*t49 + D_delta_z_12*t50 + D_p_z_3*t47 + t11*t38 + t72*t_3_z
    )
    M_wq_out[..., 8, 6] = D_delta_x_1*t80 + D_delta_y_1*t81 + D_delta_z_1*t47 + D_delta_z_1*t82
    M_wq_out[..., 8, 7] = D_delta_x_2*t80 + D_delta_y_2*t81 + D_delta_z_2*t47 + D_delta_z_2*t82
    M_wq_out[..., 8, 8] = D_delta_x_3*t80 + D_delta_y_3*t81 + D_delta_z_3*t47 + D_delta_z_3*t82
    M_wq_out[..., 8, 9] = D_delta_x_12*t30
    M_wq_out[..., 8, 10] = D_delta_y_12*t30
    M_wq_out[..., 8, 11] = D_delta_z_12*t30 + t76
    M_ww_out = np.empty((*batch, 9), dtype)
    M_ww_out[..., 0] = D_delta_x_4*t34 + D_delta_x_4*(t34 + t51) + t39*t83 + t39*t84 + t85
    M_ww_out[..., 1] = D_delta_y_5*t34 + D_delta_y_5*(t34 + t56) + t39*t86 + t39*t87 + t85
    M_ww_out[..., 2] = D_delta_z_6*t34 + D_delta_z_6*(t34 + t60) + t39*t88 + t39*t89 + t85
    M_ww_out[..., 3] = D_delta_x_7*t43 + D_delta_x_7*(t43 + t62) + t39*t90 + t39*t91 + t92
    M_ww_out[..., 4] = D_delta_y_8*t43 + D_delta_y_8*(t43 + t67) + t39*t93 + t39*t94 + t92
    M_ww_out[..., 5] = D_delta_z_9*t43 + D_delta_z_9*(t43 + t71) + t39*t95 + t39*t96 + t92
    M_ww_out[..., 6] = D_delta_x_10*t47 + D_delta_x_10*(t47 + t73) + t39*t97 + t39*t98 + t99
    M_ww_out[..., 7] = D_delta_y_11*t47 + D_delta_y_11*(t47 + t78) + t100*t39 + t101*t39 + t99
    M_ww_out[..., 8] = D_delta_z_12*t47 + D_delta_z_12*(t47 + t82) + t102*t39 + t103*t39 + t99
    K_wq_out = np.zeros((*batch, 9, 12), dtype)
    K_wq_out[..., 0, 0] = (
        D_delta_x_4*D_p_x_1*k_C + D_delta_y_4*D_p_y_1*k_C + D_delta_z_4*D_p_z_1*k_C - U_1_x_1*t110
        - U_1_y_1*t106 - U_1_z_1*t108 - mu_2*t104 - mu_2*t105 - mu_2*t107 - mu_3*t104 - mu_3*t105 - mu_3*t107
    )
    K_wq_out[..., 0, 1] = (
        D_delta_x_4*D_p_x_2*k_C + D_delta_y_4*D_p_y_2*k_C + D_delta_z_4*D_p_z_2*k_C - D_p_x_2*t110
        - D_p_x_2*t111 - D_p_y_2*t106 - D_p_y_2*t113 - D_p_z_2*t108 - D_p_z_2*t115 - U_2_x_2*t112
        - U_2_y_2*t114 - U_2_z_2*t116
    )
    K_wq_out[..., 0, 2] = (
        D_delta_x_4*D_p_x_3*k_C + D_delta_y_4*D_p_y_3*k_C + D_delta_z_4*D_p_z_3*k_C - D_p_x_3*t110
        - D_p_x_3*t112 - D_p_y_3*t106 - D_p_y_3*t114 - D_p_z_3*t108 - D_p_z_3*t116 - U_3_x_3*t111
        - U_3_y_3*t113 - U_3_z_3*t115
    )
    K_wq_out[..., 0, 6] = (
        D_delta_x_1*D_delta_x_4*k_C - D_delta_x_1*t110 - D_delta_x_1*t111 - D_delta_x_1*t112
        + D_delta_y_1*D_delta_y_4*k_C - D_delta_y_1*t106 - D_delta_y_1*t113 - D_delta_y_1*t114
        + D_delta_z_1*D_delta_z_4*k_C - D_delta_z_1*t108 - D_delta_z_1*t115 - D_delta_z_1*t116
    )
    K_wq_out[..., 0, 7] = (
        D_delta_x_2*D_delta_x_4*k_C - D_delta_x_2*t110 - D_delta_x_2*t111 - D_delta_x_2*t112
        + D_delta_y_2*D_delta_y_4*k_C - D_delta_y_2*t106 - D_delta_y_2*t113 - D_delta_y_2*t114
        + D_delta_z_2*D_delta_z_4*k_C - D_delta_z_2*t108 - D_delta_z_2*t115 - D_delta_z_2*t116
    )
    K_wq_out[..., 0, 8] = (
        D_delta_x_3*D_delta_x_4*k_C - D_delta_x_3*t110 - D_delta_x_3*t111 - D_delta_x_3*t112
        + D_delta_y_3*D_delta_y_4*k_C - D_delta_y_3*t106 - D_delta_y_3*t113 - D_delta_y_3*t114
        + D_delta_z_3*D_delta_z_4*k_C - D_delta_z_3*t108 - D_delta_z_3*t115 - D_delta_z_3*t116
    )
    K_wq_out[..., 0, 9] = D_delta_x_4*k_C
    K_wq_out[..., 0, 10] = D_delta_y_4*k_C
    K_wq_out[..., 0, 11] = D_delta_z_4*k_C
    K_wq_out[..., 1, 0] = (
        D_delta_x_5*D_p_x_1*k_C + D_delta_y_5*D_p_y_1*k_C + D_delta_z_5*D_p_z_1*k_C - U_1_x_1*t118
        - U_1_y_1*t123 - U_1_z_1*t121 - mu_2*t117 - mu_2*t119 - mu_2*t120 - mu_3*t117 - mu_3*t119 - mu_3*t120
    )
    K_wq_out[..., 1, 1] = (
        D_delta_x_5*D_p_x_2*k_C + D_delta_y_5*D_p_y_2*k_C + D_delta_z_5*D_p_z_2*k_C - D_p_x_2*t118
        - D_p_x_2*t124 - D_p_y_2*t123 - D_p_y_2*t126 - D_p_z_2*t121 - D_p_z_2*t128 - U_2_x_2*t125
        - U_2_y_2*t127 - U_2_z_2*t129
    )
    K_wq_out[..., 1, 2] = (
        D_delta_x_5*D_p_x_3*k_C + D_delta_y_5*D_p_y_3*k_C + D_delta_z_5*D_p_z_3*k_C - D_p_x_3*t118
        - D_p_x_3*t125 - D_p_y_3*t123 - D_p_y_3*t127 - D_p_z_3*t121 - D_p_z_3*t129 - U_3_x_3*t124
        - U_3_y_3*t126 - U_3_z_3*t128
    )
    K_wq_out[..., 1, 6] = (
        D_delta_x_1*D_delta_x_5*k_C - D_delta_x_1*t118 - D_delta_x_1*t124 - D_delta_x_1*t125
        + D_delta_y_1*D_delta_y_5*k_C - D_delta_y_1*t123 - D_delta_y_1*t126 - D_delta_y_1*t127
        + D_delta_z_1*D_delta_z_5*k_C - D_delta_z_1*t121 - D_delta_z_1*t128 - D_delta_z_1*t129
    )
    K_wq_out[..., 1, 7] = (
        D_delta_x_2*D_delta_x_5*k_C - D_delta_x_2*t118 - D_delta_x_2*t124 - D_delta_x_2*t125
        + D_delta_y_2*D_delta_y_5*k_C - D_delta_y_2*t123 - D_delta_y_2*t126 - D_delta_y_2*t127
        + D_delta_z_2*D_delta_z_5*k_C - D_delta_z_2*t121 - D_delta_z_2*t128 - D_delta_z_2*t129
    )
    K_wq_out[..., 1, 8] = (
        D_delta_x_3*D_delta_x_5*k_C - D_delta_x_3*t118 - D_delta_x_3*t124 - D_delta_x_3*t125
        + D_delta_y_3*D_delta_y_5*k_C - D_delta_y_3*t123 - D_delta_y_3*t126 - D_delta_y_3*t127
        + D_delta_z_3*D_delta_z_5*k_C - D_delta_z_3*t121 - D_delta_z_3*t128 - D_delta_z_3*t129
    )
    K_wq_out[..., 1, 9] = D_delta_x_5*k_C
    K_wq_out[..., 1, 10] = D_delta_y_5*k_C
    K_wq_out[..., 1, 11] = D_delta_z_5*k_C
    K_wq_out[..., 2, 0] = (
        D_delta_x_6*D_p_x_1*k_C + D_delta_y_6*D_p_y_1*k_C + D_delta_z_6*D_p_z_1*k_C - U_1_x_1*t131
        - U_1_y_1*t133 - U_1_z_1*t136 - mu_2*t130 - mu_2*t132 - mu_2*t134 - mu_3*t130 - mu_3*t132 - mu_3*t134
    )
    K_wq_out[..., 2, 1] = (
        D_delta_x_6*D_p_x_2*k_C + D_delta_y_6*D_p_y_2*k_C + D_delta_z_6*D_p_z_2*k_C - D_p_x_2*t131
        - D_p_x_2*t137 - D_p_y_2*t133 - D_p_y_2*t139 - D_p_z_2*t136 - D_p_z_2*t141 - U_2_x_2*t138
        - U_2_y_2*t140 - U_2_z_2*t142
    )
    K_wq_out[..., 2, 2] = (
        D_delta_x_6*D_p_x_3*k_C + D_delta_y_6*D_p_y_3*k_C + D_delta_z_6*D_p_z_3*k_C - D_p_x_3*t131
        - D_p_x_3*t138 - D_p_y_3*t133 - D_p_y_3*t140 - D_p_z_3*t136 - D_p_z_3*t142 - U_3_x_3*t137
        - U_3_y_3*t139 - U_3_z_3*t141
    )
    K_wq_out[..., 2, 6] = (
        D_delta_x_1*D_delta_x_6*k_C - D_delta_x_1*t131 - D_delta_x_1*t137 - D_delta_x_1*t138
        + D_delta_y_1*D_delta_y_6*k_C - D_delta_y_1*t133 - D_delta_y_1*t139 - D_delta_y_1*t140
        + D_delta_z_1*D_delta_z_6*k_C - D_delta_z_1*t136 - D_delta_z_1*t141 - D_delta_z_1*t142
    )
    K_wq_out[..., 2, 7] = (
        D_delta_x_2*D_delta_x_6*k_C - D_delta_x_2*t131 - D_delta_x_2*t137 - D_delta_x_2*t138
        + D_delta_y_2*D_delta_y_6*k_C - D_delta_y_2*t133 - D_delta_y_2*t139 - D_delta_y_2*t140
        + D_delta_z_2*D_delta_z_6*k_C - D_delta_z_2*t136 - D_delta_z_2*t141 - D_delta_z_2*t142
    )
    K_wq_out[..., 2, 8] = (
        D_delta_x_3*D_delta_x_6*k_C - D_delta_x_3*t131 - D_delta_x_3*t137 - D_delta_x_3*t138
        + D_delta_y_3*D_delta_y_6*k_C - D_delta_y_3*t133 - D_delta_y_3*t139 - D_delta_y_3*t140
        + D_delta_z_3*D_delta_z_6*k_C - D_delta_z_3*t136 - D_delta_z_3*t141 - D_delta_z_3*t142
    )
    K_wq_out[..., 2, 9] = D_delta_x_6*k_C
    K_wq_out[..., 2, 10] = D_delta_y_6*k_C
    K_wq_out[..., 2, 11] = D_delta_z_6*k_C
    K_wq_out[..., 3, 0] = (
        D_delta_x_7*D_p_x_1*k_C + D_delta_y_7*D_p_y_1*k_C + D_delta_z_7*D_p_z_1*k_C - D_p_x_1*t143
        - D_p_x_1*t150 - U_1_x_1*t144 - U_1_y_1*t146 - U_1_z_1*t148 - mu_2*t145 - mu_2*t147 - mu_3*t145
        - mu_3*t147
    )
    K_wq_out[..., 3, 1] = (
        D_delta_x_7*D_p_x_2*k_C + D_delta_y_7*D_p_y_2*k_C + D_delta_z_7*D_p_z_2*k_C - D_p_x_2*t143
        - D_p_x_2*t144 - D_p_y_2*t146 - D_p_y_2*t151 - D_p_z_2*t148 - D_p_z_2*t153 - U_2_x_2*t150
        - U_2_y_2*t152 - U_2_z_2*t154
    )
    K_wq_out[..., 3, 2] = (
        D_delta_x_7*D_p_x_3*k_C + D_delta_y_7*D_p_y_3*k_C + D_delta_z_7*D_p_z_3*k_C - D_p_x_3*t144
        - D_p_x_3*t150 - D_p_y_3*t146 - D_p_y_3*t152 - D_p_z_3*t148 - D_p_z_3*t154 - U_3_x_3*t143
        - U_3_y_3*t151 - U_3_z_3*t153
    )
    K_wq_out[..., 3, 6] = (
        D_delta_x_1*D_delta_x_7*k_C - D_delta_x_1*t143 - D_delta_x_1*t144 - D_delta_x_1*t150
        + D_delta_y_1*D_delta_y_7*k_C - D_delta_y_1*t146 - D_delta_y_1*t151 - D_delta_y_1*t152
        + D_delta_z_1*D_delta_z_7*k_C - D_delta_z_1*t148 - D_delta_z_1*t153 - D_delta_z_1*t154
    )
    K_wq_out[..., 3, 7] = (
        D_delta_x_2*D_delta_x_7*k_C - D_delta_x_2*t143 - D_delta_x_2*t144 - D_delta_x_2*t150
        + D_delta_y_2*D_delta_y_7*k_C - D_delta_y_2*t146 - D_delta_y_2*t151 - D_delta_y_2*t152
        + D_delta_z_2*D_delta_z_7*k_C - D_delta_z_2*t148 - D_delta_z_2*t153 - D_delta_z_2*t154
    )
    K_wq_out[..., 3, 8] = (
        D_delta_x_3*D_delta_x_7*k_C - D_delta_x_3*t143 - D_delta_x_3*t144 - D_delta_x_3*t150
        + D_delta_y_3*D_delta_y_7*k_C - D_delta_y_3*t146 - D_delta_y_3*t151 - D_delta_y_3*t152
        + D_delta_z_3*D_delta_z_7*k_C - D_delta_z_3*t148 - D_delta_z_3*t153 - D_delta_z_3*t154
    )
    K_wq_out[..., 3, 9] = D_delta_x_7*k_C
    K_wq_out[..., 3, 10] = D_delta_y_7*k_C
    K_wq_out[..., 3, 11] = D_delta_z_7*k_C
    K_wq_out[..., 4, 0] = (
        D_delta_x_8*D_p_x_1*k_C + D_delta_y_8*D_p_y_1*k_C + D_delta_z_8*D_p_z_1*k_C - D_p_y_1*t157
        - D_p_y_1*t162 - U_1_x_1*t156 - U_1_y_1*t158 - U_1_z_1*t160 - mu_2*t155 - mu_2*t159 - mu_3*t155
        - mu_3*t159
    )
    K_wq_out[..., 4, 1] = (
        D_delta_x_8*D_p_x_2*k_C + D_delta_y_8*D_p_y_2*k_C + D_delta_z_8*D_p_z_2*k_C - D_p_x_2*t156
        - D_p_x_2*t163 - D_p_y_2*t157 - D_p_y_2*t158 - D_p_z_2*t160 - D_p_z_2*t165 - U_2_x_2*t164
        - U_2_y_2*t162 - U_2_z_2*t166
    )
    K_wq_out[..., 4, 2] = (
        D_delta_x_8*D_p_x_3*k_C + D_delta_y_8*D_p_y_3*k_C + D_delta_z_8*D_p_z_3*k_C - D_p_x_3*t156
        - D_p_x_3*t164 - D_p_y_3*t158 - D_p_y_3*t162 - D_p_z_3*t160 - D_p_z_3*t166 - U_3_x_3*t163
        - U_3_y_3*t157 - U_3_z_3*t165
    )
    K_wq_out[..., 4, 6] = (
        D_delta_x_1*D_delta_x_8*k_C - D_delta_x_1*t156 - D_delta_x_1*t163 - D_delta_x_1*t164
        + D_delta_y_1*D_delta_y_8*k_C - D_delta_y_1*t157 - D_delta_y_1*t158 - D_delta_y_1*t162
        + D_delta_z_1*D_delta_z_8*k_C - D_delta_z_1*t160 - D_delta_z_1*t165 - D_delta_z_1*t166
    )
    K_wq_out[..., 4, 7] = (
        D_delta_x_2*D_delta_x_8*k_C - D_delta_x_2*t156 - D_delta_x_2*t163 - D_delta_x_2*t164
        + D_delta_y_2*D_delta_y_8*k_C - D_delta_y_2*t157 - D_delta_y_2*t158 - D_delta_y_2*t162
        + D_delta_z_2*D_delta_z_8*k_C - D_delta_z_2*t160 - D_delta_z_2*t165 - D_delta_z_2*t166
    )
    K_wq_out[..., 4, 8] = (
        D_delta_x_3*D_delta_x_8*k_C - D_delta_x_3*t156 - D_delta_x_3*t163 - D_delta_x_3*t164
        + D_delta_y_3*D_delta_y_8*k_C - D_delta_y_3*t157 - D_delta_y_3*t158 - D_delta_y_3*t162
        + D_delta_z_3*D_delta_z_8*k_C - D_delta_z_3*t160 - D_delta_z_3*t165 - D_delta_z_3*t166
    )
    K_wq_out[..., 4, 9] = D_delta_x_8*k_C
    K_wq_out[..., 4, 10] = D_delta_y_8*k_C
    K_wq_out[..., 4, 11] = D_delta_z_8*k_C
    K_wq_out[..., 5, 0] = (
        D_delta_x_9*D_p_x_1*k_C + D_delta_y_9*D_p_y_1*k_C + D_delta_z_9*D_p_z_1*k_C - D_p_z_1*t171
        - D_p_z_1*t174 - U_1_x_1*t168 - U_1_y_1*t170 - U_1_z_1*t172 - mu_2*t167 - mu_2*t169 - mu_3*t167
        - mu_3*t169
    )
    K_wq_out[..., 5, 1] = (
        D_delta_x_9*D_p_x_2*k_C + D_delta_y_9*D_p_y_2*k_C + D_delta_z_9*D_p_z_2*k_C - D_p_x_2*t168
        - D_p_x_2*t175 - D_p_y_2*t170 - D_p_y_2*t177 - D_p_z_2*t171 - D_p_z_2*t172 - U_2_x_2*t176
        - U_2_y_2*t178 - U_2_z_2*t174
    )
    K_wq_out[..., 5, 2] = (
        D_delta_x_9*D_p_x_3*k_C + D_delta_y_9*D_p_y_3*k_C + D_delta_z_9*D_p_z_3*k_C - D_p_x_3*t168
        - D_p_x_3*t176 - D_p_y_3*t170 - D_p_y_3*t178 - D_p_z_3*t172 - D_p_z_3*t174 - U_3_x_3*t175
        - U_3_y_3*t177 - U_3_z_3*t171
    )
    K_wq_out[..., 5, 6] = (
        D_delta_x_1*D_delta_x_9*k_C - D_delta_x_1*t168 - D_delta_x_1*t175 - D_delta_x_1*t176
        + D_delta_y_1*D_delta_y_9*k_C - D_delta_y_1*t170 - D_delta_y_1*t177 - D_delta_y_1*t178
        + D_delta_z_1*D_delta_z_9*k_C - D_delta_z_1*t171 - D_delta_z_1*t172 - D_delta_z_1*t174
    )
    K_wq_out[..., 5, 7] = (
        D_delta_x_2*D_delta_x_9*k_C - D_delta_x_2*t168 - D_delta_x_2*t175 - D_delta_x_2*t176
        + D_delta_y_2*D_delta_y_9*k_C - D_delta_y_2*t170 - D_delta_y_2*t177 - D_delta_y_2*t178
        + D_delta_z_2*D_delta_z_9*k_C - D_delta_z_2*t171 - D_delta_z_2*t172 - D_delta_z_2*t174
    )
    K_wq_out[..., 5, 8] = (
        D_delta_x_3*D_delta_x_9*k_C - D_delta_x_3*t168 - D_delta_x_3*t175 - D_delta_x_3*t176
        + D_delta_y_3*D_delta_y_9*k_C - D_delta_y_3*t170 - D_delta_y_3*t177 - D_delta_y_3*t178
        + D_delta_z_3*D_delta_z_9*k_C - D_delta_z_3*t171 - D_delta_z_3*t172 - D_delta_z_3*t174
    )
    K_wq_out[..., 5, 9] = D_delta_x_9*k_C
    K_wq_out[..., 5, 10] = D_delta_y_9*k_C
    K_wq_out[..., 5, 11] = D_delta_z_9*k_C
    K_wq_out[..., 6, 0] = (
        D_delta_x_10*D_p_x_1*k_C + D_delta_y_10*D_p_y_1*k_C + D_delta_z_10*D_p_z_1*k_C - D_p_x_1*t179
        - D_p_x_1*t186 - U_1_x_1*t180 - U_1_y_1*t182 - U_1_z_1*t184 - mu_2*t181 - mu_2*t183 - mu_3*t181
        - mu_3*t183
    )
    K_wq_out[..., 6, 1] = (
        D_delta_x_10*D_p_x_2*k_C + D_delta_y_10*D_p_y_2*k_C + D_delta_z_10*D_p_z_2*k_C - D_p_x_2*t180
        - D_p_x_2*t186 - D_p_y_2*t182 - D_p_y_2*t187 - D_p_z_2*t184 - D_p_z_2*t189 - U_2_x_2*t179
        - U_2_y_2*t188 - U_2_z_2*t190
    )
    K_wq_out[..., 6, 2] = (
        D_delta_x_10*D_p_x_3*k_C + D_delta_y_10*D_p_y_3*k_C + D_delta_z_10*D_p_z_3*k_C - D_p_x_3*t179
        - D_p_x_3*t180 - D_p_y_3*t182 - D_p_y_3*t188 - D_p_z_3*t184 - D_p_z_3*t190 - U_3_x_3*t186
        - U_3_y_3*t187 - U_3_z_3*t189
    )
    K_wq_out[..., 6, 6] = (
        D_delta_x_1*D_delta_x_10*k_C - D_delta_x_1*t179 - D_delta_x_1*t180 - D_delta_x_1*t186
        + D_delta_y_1*D_delta_y_10*k_C - D_delta_y_1*t182 - D_delta_y_1*t187 - D_delta_y_1*t188
        + D_delta_z_1*D_delta_z_10*k_C - D_delta_z_1*t184 - D_delta_z_1*t189 - D_delta_z_1*t190
    )
    K_wq_out[..., 6, 7] = (
        D_delta_x_10*D_delta_x_2*k_C - D_delta_x_2*t179 - D_delta_x_2*t180 - D_delta_x_2*t186
        + D_delta_y_10*D_delta_y_2*k_C - D_delta_y_2*t182 - D_delta_y_2*t187 - D_delta_y_2*t188
        + D_delta_z_10*D_delta_z_2*k_C - D_delta_z_2*t184 - D_delta_z_2*t189 - D_delta_z_2*t190
    )
    K_wq_out[..., 6, 8] = (
        D_delta_x_10*D_delta_x_3*k_C - D_delta_x_3*t179 - D_delta_x_3*t180 - D_delta_x_3*t186
        + D_delta_y_10*D_delta_y_3*k_C - D_delta_y_3*t182 - D_delta_y_3*t187 - D_delta_y_3*t188
        + D_delta_z_10*D_delta_z_3*k_C - D_delta_z_3*t184 - D_delta_z_3*t189 - D_delta_z_3*t190
    )
    K_wq_out[..., 6, 9] = D_delta_x_10*k_C
    K_wq_out[..., 6, 10] = D_delta_y_10*k_C
    K_wq_out[..., 6, 11] = D_delta_z_10*k_C
    K_wq_out[..., 7, 0] = (
        D_delta_x_11*D_p_x_1*k_C + D_delta_y_11*D_p_y_1*k_C + D_delta_z_11*D_p_z_1*k_C - D_p_y_1*t193
        - D_p_y_1*t198 - U_1_x_1*t192 - U_1_y_1*t194 - U_1_z_1*t196 - mu_2*t191 - mu_2*t195 - mu_3*t191
        - mu_3*t195
    )
    K_wq_out[..., 7, 1] = (
        D_delta_x_11*D_p_x_2*k_C + D_delta_y_11*D_p_y_2*k_C + D_delta_z_11*D_p_z_2*k_C - D_p_x_2*t192
        - D_p_x_2*t199 - D_p_y_2*t194 - D_p_y_2*t198 - D_p_z_2*t196 - D_p_z_2*t201 - U_2_x_2*t200
        - U_2_y_2*t193 - U_2_z_2*t202
    )
    K_wq_out[..., 7, 2] = (
        D_delta_x_11*D_p_x_3*k_C + D_delta_y_11*D_p_y_3*k_C + D_delta_z_11*D_p_z_3*k_C - D_p_x_3*t192
        - D_p_x_3*t200 - D_p_y_3*t193 - D_p_y_3*t194 - D_p_z_3*t196 - D_p_z_3*t202 - U_3_x_3*t199
        - U_3_y_3*t198 - U_3_z_3*t201
    )
    K_wq_out[..., 7, 6] = (
        D_delta_x_1*D_delta_x_11*k_C - D_delta_x_1*t192 - D_delta_x_1*t199 - D_delta_x_1*t200
        + D_delta_y_1*D_delta_y_11*k_C - D_delta_y_1*t193 - D_delta_y_1*t194 - D_delta_y_1*t198
        + D_delta_z_1*D_delta_z_11*k_C - D_delta_z_1*t196 - D_delta_z_1*t201 - D_delta_z_1*t202
    )
    K_wq_out[..., 7, 7] = (
        D_delta_x_11*D_delta_x_2*k_C - D_delta_x_2*t192 - D_delta_x_2*t199 - D_delta_x_2*t200
        + D_delta_y_11*D_delta_y_2*k_C - D_delta_y_2*t193 - D_delta_y_2*t194 - D_delta_y_2*t198
        + D_delta_z_11*D_delta_z_2*k_C - D_delta_z_2*t196 - D_delta_z_2*t201 - D_delta_z_2*t202
    )
    K_wq_out[..., 7, 8] = (
        D_delta_x_11*D_delta_x_3*k_C - D_delta_x_3*t192 - D_delta_x_3*t199 - D_delta_x_3*t200
        + D_delta_y_11*D_delta_y_3*k_C - D_delta_y_3*t193 - D_delta_y_3*t194 - D_delta_y_3*t198
        + D_delta_z_11*D_delta_z_3*k_C - D_delta_z_3*t196 - D_delta_z_3*t201 - D_delta_z_3*t202
    )
    K_wq_out[..., 7, 9] = D_delta_x_11*k_C
    K_wq_out[..., 7, 10] = D_delta_y_11*k_C
    K_wq_out[..., 7, 11] = D_delta_z_11*k_C
    K_wq_out[..., 8, 0] = (
        D_delta_x_12*D_p_x_1*k_C + D_delta_y_12*D_p_y_1*k_C + D_delta_z_12*D_p_z_1*k_C - D_p_z_1*t207
        - D_p_z_1*t210 - U_1_x_1*t204 - U_1_y_1*t206 - U_1_z_1*t208 - mu_2*t203 - mu_2*t205 - mu_3*t203
        - mu_3*t205
    )
    K_wq_out[..., 8, 1] = (
        D_delta_x_12*D_p_x_2*k_C + D_delta_y_12*D_p_y_2*k_C + D_delta_z_12*D_p_z_2*k_C - D_p_x_2*t204
        - D_p_x_2*t211 - D_p_y_2*t206 - D_p_y_2*t213 - D_p_z_2*t208 - D_p_z_2*t210 - U_2_x_2*t212
        - U_2_y_2*t214 - U_2_z_2*t207
    )
    K_wq_out[..., 8, 2] = (
        D_delta_x_12*D_p_x_3*k_C + D_delta_y_12*D_p_y_3*k_C + D_delta_z_12*D_p_z_3*k_C - D_p_x_3*t204
        - D_p_x_3*t212 - D_p_y_3*t206 - D_p_y_3*t214 - D_p_z_3*t207 - D_p_z_3*t208 - U_3_x_3*t211
        - U_3_y_3*t213 - U_3_z_3*t210
    )
    K_wq_out[..., 8, 6] = (
        D_delta_x_1*D_delta_x_12*k_C - D_delta_x_1*t204 - D_delta_x_1*t211 - D_delta_x_1*t212
        + D_delta_y_1*D_delta_y_12*k_C - D_delta_y_1*t206 - D_delta_y_1*t213 - D_delta_y_1*t214
        + D_delta_z_1*D_delta_z_12*k_C - D_delta_z_1*t207 - D_delta_z_1*t208 - D_delta_z_1*t210
    )
    K_wq_out[..., 8, 7] = (
        D_delta_x_12*D_delta_x_2*k_C - D_delta_x_2*t204 - D_delta_x_2*t211 - D_delta_x_2*t212
        + D_delta_y_12*D_delta_y_2*k_C - D_delta_y_2*t206 - D_delta_y_2*t213 - D_delta_y_2*t214
        + D_delta_z_12*D_delta_z_2*k_C - D_delta_z_2*t207 - D_delta_z_2*t208 - D_delta_z_2*t210
    )
    K_wq_out[..., 8, 8] = (
        D_delta_x_12*D_delta_x_3*k_C - D_delta_x_3*t204 - D_delta_x_3*t211 - D_delta_x_3*t212
        + D_delta_y_12*D_delta_y_3*k_C - D_delta_y_3*t206 - D_delta_y_3*t213 - D_delta_y_3*t214
        + D_delta_z_12*D_delta_z_3*k_C - D_delta_z_3*t207 - D_delta_z_3*t208 - D_delta_z_3*t210
    )
    K_wq_out[..., 8, 9] = D_delta_x_12*k_C
    K_wq_out[..., 8, 10] = D_delta_y_12*k_C
    K_wq_out[..., 8, 11] = D_delta_z_12*k_C
    K_ww_out = np.empty((*batch, 9), dtype)
    K_ww_out[..., 0] = (
        k_C*t215 + k_C*t83 + k_C*t84 - mu_1*t109**2 - mu_1*t83 - mu_1*t84 - mu_2*t215 - mu_2*t83 - mu_2*t84
        - mu_3*t215 - mu_3*t83 - mu_3*t84
    )
    K_ww_out[..., 1] = (
        k_C*t216 + k_C*t86 + k_C*t87 - mu_1*t122**2 - mu_1*t86 - mu_1*t87 - mu_2*t216 - mu_2*t86 - mu_2*t87
        - mu_3*t216 - mu_3*t86 - mu_3*t87
    )
    K_ww_out[..., 2] = (
        k_C*t217 + k_C*t88 + k_C*t89 - mu_1*t135**2 - mu_1*t88 - mu_1*t89 - mu_2*t217 - mu_2*t88 - mu_2*t89
        - mu_3*t217 - mu_3*t88 - mu_3*t89
    )
    K_ww_out[..., 3] = (
        k_C*t218 + k_C*t90 + k_C*t91 - mu_1*t218 - mu_1*t90 - mu_1*t91 - mu_2*t149**2 - mu_2*t90 - mu_2*t91
        - mu_3*t218 - mu_3*t90 - mu_3*t91
    )
    K_ww_out[..., 4] = (
        k_C*t219 + k_C*t93 + k_C*t94 - mu_1*t219 - mu_1*t93 - mu_1*t94 - mu_2*t161**2 - mu_2*t93 - mu_2*t94
        - mu_3*t219 - mu_3*t93 - mu_3*t94
    )
    K_ww_out[..., 5] = (
        k_C*t220 + k_C*t95 + k_C*t96 - mu_1*t220 - mu_1*t95 - mu_1*t96 - mu_2*t173**2 - mu_2*t95 - mu_2*t96
        - mu_3*t220 - mu_3*t95 - mu_3*t96
    )
    K_ww_out[..., 6] = (
        k_C*t221 + k_C*t97 + k_C*t98 - mu_1*t221 - mu_1*t97 - mu_1*t98 - mu_2*t221 - mu_2*t97 - mu_2*t98
        - mu_3*t185**2 - mu_3*t97 - mu_3*t98
    )
    K_ww_out[..., 7] = (
        k_C*t100 + k_C*t101 + k_C*t222 - mu_1*t100 - mu_1*t101 - mu_1*t222 - mu_2*t100 - mu_2*t101 - mu_2*t222
        - mu_3*t100 - mu_3*t101 - mu_3*t197**2
    )
    K_ww_out[..., 8] = (
        k_C*t102 + k_C*t103 + k_C*t223 - mu_1*t102 - mu_1*t103 - mu_1*t223 - mu_2*t102 - mu_2*t103 - mu_2*t223
        - mu_3*t102 - mu_3*t103 - mu_3*t209**2
    )
    J_p_out = np.empty((*batch, 9, 3), dtype)
    J_p_out[..., 0, 0] = D_delta_x_4
    J_p_out[..., 0, 1] = D_delta_y_4
    J_p_out[..., 0, 2] = D_delta_z_4
    J_p_out[..., 1, 0] = D_delta_x_5
    J_p_out[..., 1, 1] = D_delta_y_5
    J_p_out[..., 1, 2] = D_delta_z_5
    J_p_out[..., 2, 0] = D_delta_x_6
    J_p_out[..., 2, 1] = D_delta_y_6
    J_p_out[..., 2, 2] = D_delta_z_6
    J_p_out[..., 3, 0] = D_delta_x_7
    J_p_out[..., 3, 1] = D_delta_y_7
    J_p_out[..., 3, 2] = D_delta_z_7
    J_p_out[..., 4, 0] = D_delta_x_8
    J_p_out[..., 4, 1] = D_delta_y_8
    J_p_out[..., 4, 2] = D_delta_z_8
    J_p_out[..., 5, 0] = D_delta_x_9
    J_p_out[..., 5, 1] = D_delta_y_9
    J_p_out[..., 5, 2] = D_delta_z_9
    J_p_out[..., 6, 0] = D_delta_x_10
    J_p_out[..., 6, 1] = D_delta_y_10
    J_p_out[..., 6, 2] = D_delta_z_10
    J_p_out[..., 7, 0] = D_delta_x_11
    J_p_out[..., 7, 1] = D_delta_y_11
    J_p_out[..., 7, 2] = D_delta_z_11
    J_p_out[..., 8, 0] = D_delta_x_12
    J_p_out[..., 8, 1] = D_delta_y_12
    J_p_out[..., 8, 2] = D_delta_z_12
    return M_wq_out, M_ww_out, K_wq_out, K_ww_out, J_p_out


def mount_inertia():
    """Derivatives of the rows of M of the mounts with respect to the mass that moves with each.

    Parameters
    ----------

    Returns
    -------
    M_wq : array, shape (..., 9, 12) [1]
        Of M_wq.
    M_ww : array, shape (..., 9) [1]
        Of M_ww.

    Notes
    -----
    The kinetic energy of a bearing that yields, of which the frame has the rest.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    M_wq_out = np.zeros((*batch, 9, 12), dtype)
    M_ww_out = np.zeros((*batch, 9), dtype)
    return M_wq_out, M_ww_out
