# Generated from the derivation of linear_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Terms of the mechanism linear_delta: motion of its bodies, and what holds them yielding.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; belt span s; component i = x, y,
z.  t1, t2, ... are subexpressions shared by several values.

* x_j [m]: position of carriage j along its rail
* r_j_i [m]: platform joint j relative to the origin of rail j, component i
* s_j_i [m]: linkage vector j, from carriage to platform joint, component i
* a_j [m]: coordinate of platform joint j along rail j
* w_j_i [m]: vector from rail j to platform joint j, perpendicular to it, component i
* w2_j [m^2]: squared distance of platform joint j from rail j
* l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* D_r_j [m]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [1]: platform Jacobian, dp_i/dx_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
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
    "x_1",
    "x_2",
    "x_3",
    "theta_1_1",
    "theta_2_1",
    "theta_3_1",
    "theta_1_2",
    "theta_2_2",
    "theta_3_2",
    "psi_1",
    "psi_2",
    "psi_3",
    "delta_1",
    "delta_2",
    "delta_3",
    "eps_1",
    "eps_2",
    "eps_3",
    "u_x",
    "u_y",
    "u_z",
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
    "rad",
    "rad",
    "rad",
    "m",
    "m",
    "m",
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
    J : array, shape (..., 33, 21) [1, m]
        One row for each displacement.

    Notes
    -----
    The velocities of the bodies that the mechanism declares, without the mounts of terms.
    213 operations; 106416 with every named value expanded.
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
    t2 = A_x_1*t1
    D_p_x_1 = D_r_1*t2
    t3 = A_x_2*t1
    D_p_x_2 = D_r_2*t3
    t4 = A_x_3*t1
    D_p_x_3 = D_r_3*t4
    D_delta_x_1 = l_d_1*t2
    D_delta_x_2 = l_d_2*t3
    D_delta_x_3 = l_d_3*t4
    t5 = A_y_1*t1
    D_p_y_1 = D_r_1*t5
    t6 = A_y_2*t1
    D_p_y_2 = D_r_2*t6
    t7 = A_y_3*t1
    D_p_y_3 = D_r_3*t7
    D_delta_y_1 = l_d_1*t5
    D_delta_y_2 = l_d_2*t6
    D_delta_y_3 = l_d_3*t7
    t8 = A_z_1*t1
    D_p_z_1 = D_r_1*t8
    t9 = A_z_2*t1
    D_p_z_2 = D_r_2*t9
    t10 = A_z_3*t1
    D_p_z_3 = D_r_3*t10
    D_delta_z_1 = l_d_1*t8
    D_delta_z_2 = l_d_2*t9
    D_delta_z_3 = l_d_3*t10
    t11 = (1/2)*D_p_x_1
    t12 = (1/2)*D_p_x_2
    t13 = (1/2)*D_p_x_3
    t14 = (1/2)*D_delta_x_1
    t15 = (1/2)*D_delta_x_2
    t16 = (1/2)*D_delta_x_3
    t17 = (1/2)*D_p_y_1
    t18 = (1/2)*D_p_y_2
    t19 = (1/2)*D_p_y_3
    t20 = (1/2)*D_delta_y_1
    t21 = (1/2)*D_delta_y_2
    t22 = (1/2)*D_delta_y_3
    t23 = (1/2)*D_p_z_1
    t24 = (1/2)*D_p_z_2
    t25 = (1/2)*D_p_z_3
    t26 = (1/2)*D_delta_z_1
    t27 = (1/2)*D_delta_z_2
    t28 = (1/2)*D_delta_z_3
    J_out = np.zeros((*batch, 33, 21), dtype)
    J_out[..., 0, 0] = D_p_x_1
    J_out[..., 0, 1] = D_p_x_2
    J_out[..., 0, 2] = D_p_x_3
    J_out[..., 0, 12] = D_delta_x_1
    J_out[..., 0, 13] = D_delta_x_2
    J_out[..., 0, 14] = D_delta_x_3
    J_out[..., 0, 18] = 1
    J_out[..., 1, 0] = D_p_y_1
    J_out[..., 1, 1] = D_p_y_2
    J_out[..., 1, 2] = D_p_y_3
    J_out[..., 1, 12] = D_delta_y_1
    J_out[..., 1, 13] = D_delta_y_2
    J_out[..., 1, 14] = D_delta_y_3
    J_out[..., 1, 19] = 1
    J_out[..., 2, 0] = D_p_z_1
    J_out[..., 2, 1] = D_p_z_2
    J_out[..., 2, 2] = D_p_z_3
    J_out[..., 2, 12] = D_delta_z_1
    J_out[..., 2, 13] = D_delta_z_2
    J_out[..., 2, 14] = D_delta_z_3
    J_out[..., 2, 20] = 1
    J_out[..., 3, 0] = n_1_x
    J_out[..., 3, 18] = 1
    J_out[..., 4, 0] = n_1_y
    J_out[..., 4, 19] = 1
    J_out[..., 5, 0] = n_1_z
    J_out[..., 5, 20] = 1
    J_out[..., 6, 1] = n_2_x
    J_out[..., 6, 18] = 1
    J_out[..., 7, 1] = n_2_y
    J_out[..., 7, 19] = 1
    J_out[..., 8, 1] = n_2_z
    J_out[..., 8, 20] = 1
    J_out[..., 9, 2] = n_3_x
    J_out[..., 9, 18] = 1
    J_out[..., 10, 2] = n_3_y
    J_out[..., 10, 19] = 1
    J_out[..., 11, 2] = n_3_z
    J_out[..., 11, 20] = 1
    J_out[..., 12, 3] = 1
    J_out[..., 13, 6] = 1
    J_out[..., 14, 4] = 1
    J_out[..., 15, 7] = 1
    J_out[..., 16, 5] = 1
    J_out[..., 17, 8] = 1
    J_out[..., 18, 18] = 1
    J_out[..., 19, 19] = 1
    J_out[..., 20, 20] = 1
    J_out[..., 21, 0] = 1
    J_out[..., 21, 18] = n_1_x
    J_out[..., 21, 19] = n_1_y
    J_out[..., 21, 20] = n_1_z
    J_out[..., 22, 1] = 1
    J_out[..., 22, 18] = n_2_x
    J_out[..., 22, 19] = n_2_y
    J_out[..., 22, 20] = n_2_z
    J_out[..., 23, 2] = 1
    J_out[..., 23, 18] = n_3_x
    J_out[..., 23, 19] = n_3_y
    J_out[..., 23, 20] = n_3_z
    J_out[..., 24, 0] = (1/2)*n_1_x + t11
    J_out[..., 24, 1] = t12
    J_out[..., 24, 2] = t13
    J_out[..., 24, 12] = t14
    J_out[..., 24, 13] = t15
    J_out[..., 24, 14] = t16
    J_out[..., 24, 18] = 1
    J_out[..., 25, 0] = (1/2)*n_1_y + t17
    J_out[..., 25, 1] = t18
    J_out[..., 25, 2] = t19
    J_out[..., 25, 12] = t20
    J_out[..., 25, 13] = t21
    J_out[..., 25, 14] = t22
    J_out[..., 25, 19] = 1
    J_out[..., 26, 0] = (1/2)*n_1_z + t23
    J_out[..., 26, 1] = t24
    J_out[..., 26, 2] = t25
    J_out[..., 26, 12] = t26
    J_out[..., 26, 13] = t27
    J_out[..., 26, 14] = t28
    J_out[..., 26, 20] = 1
    J_out[..., 27, 0] = t11
    J_out[..., 27, 1] = (1/2)*n_2_x + t12
    J_out[..., 27, 2] = t13
    J_out[..., 27, 12] = t14
    J_out[..., 27, 13] = t15
    J_out[..., 27, 14] = t16
    J_out[..., 27, 18] = 1
    J_out[..., 28, 0] = t17
    J_out[..., 28, 1] = (1/2)*n_2_y + t18
    J_out[..., 28, 2] = t19
    J_out[..., 28, 12] = t20
    J_out[..., 28, 13] = t21
    J_out[..., 28, 14] = t22
    J_out[..., 28, 19] = 1
    J_out[..., 29, 0] = t23
    J_out[..., 29, 1] = (1/2)*n_2_z + t24
    J_out[..., 29, 2] = t25
    J_out[..., 29, 12] = t26
    J_out[..., 29, 13] = t27
    J_out[..., 29, 14] = t28
    J_out[..., 29, 20] = 1
    J_out[..., 30, 0] = t11
    J_out[..., 30, 1] = t12
    J_out[..., 30, 2] = (1/2)*n_3_x + t13
    J_out[..., 30, 12] = t14
    J_out[..., 30, 13] = t15
    J_out[..., 30, 14] = t16
    J_out[..., 30, 18] = 1
    J_out[..., 31, 0] = t17
    J_out[..., 31, 1] = t18
    J_out[..., 31, 2] = (1/2)*n_3_y + t19
    J_out[..., 31, 12] = t20
    J_out[..., 31, 13] = t21
    J_out[..., 31, 14] = t22
    J_out[..., 31, 19] = 1
    J_out[..., 32, 0] = t23
    J_out[..., 32, 1] = t24
    J_out[..., 32, 2] = (1/2)*n_3_z + t25
    J_out[..., 32, 12] = t26
    J_out[..., 32, 13] = t27
    J_out[..., 32, 14] = t28
    J_out[..., 32, 20] = 1
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
    M_wq : array, shape (..., 15, 21) [kg, kg m]
        Entries of M between each mount and every coordinate.
    M_ww : array, shape (..., 15) [kg, kg m]
        Diagonal entry of M of each mount.
    K_wq : array, shape (..., 15, 21) [N/m, N]
        Entries of K between each mount and every coordinate.
    K_ww : array, shape (..., 15) [N/m, N]
        Diagonal entry of K of each mount.
    J_p : array, shape (..., 15, 3) [1, 1/m]
        Motion of the platform per unit of each mount.

    Notes
    -----
    Equations 24 to 48 with these displacements released; without the springs of the mounts.
    3018 operations; 3916785 with every named value expanded.
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
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (a_B_3,) = _entries(effects.axis_belt_stiffness_factor_3, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, c_T, F_T, k_C, m_L)
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
    t1 = A_y_1*s_1_y
    t2 = A_z_1*s_1_z
    t3 = A_x_1*s_1_x
    det_D_l = t1 + t2 + t3
    t4 = 1.0/det_D_l
    t5 = A_x_1*t4
    D_p_x_1 = D_r_1*t5
    t6 = A_x_2*t4
    D_p_x_2 = D_r_2*t6
    t7 = A_x_3*t4
    D_p_x_3 = D_r_3*t7
    D_delta_x_1 = l_d_1*t5
    D_delta_x_2 = l_d_2*t6
    D_delta_x_3 = l_d_3*t7
    D_delta_x_4 = t3*t4
    D_delta_x_5 = s_1_y*t5
    D_delta_x_6 = s_1_z*t5
    D_delta_x_7 = s_2_x*t6
    D_delta_x_8 = s_2_y*t6
    D_delta_x_9 = s_2_z*t6
    D_delta_x_10 = s_3_x*t7
    D_delta_x_11 = s_3_y*t7
    D_delta_x_12 = s_3_z*t7
    t8 = A_y_1*t4
    D_p_y_1 = D_r_1*t8
    t9 = A_y_2*t4
    D_p_y_2 = D_r_2*t9
    t10 = A_y_3*t4
    D_p_y_3 = D_r_3*t10
    D_delta_y_1 = l_d_1*t8
    D_delta_y_2 = l_d_2*t9
    D_delta_y_3 = l_d_3*t10
    D_delta_y_4 = s_1_x*t8
    D_delta_y_5 = t1*t4
    D_delta_y_6 = s_1_z*t8
    D_delta_y_7 = s_2_x*t9
    D_delta_y_8 = s_2_y*t9
    D_delta_y_9 = s_2_z*t9
    D_delta_y_10 = s_3_x*t10
    D_delta_y_11 = s_3_y*t10
    D_delta_y_12 = s_3_z*t10
    t11 = A_z_1*t4
    D_p_z_1 = D_r_1*t11
    t12 = A_z_2*t4
    D_p_z_2 = D_r_2*t12
    t13 = A_z_3*t4
    D_p_z_3 = D_r_3*t13
    D_delta_z_1 = l_d_1*t11
    D_delta_z_2 = l_d_2*t12
    D_delta_z_3 = l_d_3*t13
    D_delta_z_4 = s_1_x*t11
    D_delta_z_5 = s_1_y*t11
    D_delta_z_6 = t2*t4
    D_delta_z_7 = s_2_x*t12
    D_delta_z_8 = s_2_y*t12
    D_delta_z_9 = s_2_z*t12
    D_delta_z_10 = s_3_x*t13
    D_delta_z_11 = s_3_y*t13
    D_delta_z_12 = s_3_z*t13
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
    t14 = F_T*c_T + 1
    t15 = c_E*t14
    t16 = k_sp_1*w_b_1*(a_B_1 + 1)
    t17 = t15*t16
    t18 = t14*t16
    k_1_1 = t18/(l_f_1_1 + t17)
    t19 = (1/2)*l_t_1
    l_f_1_2 = -t19 + x_1 - x_min_1
    k_1_2 = t18/(l_f_1_2 + t17)
    l_f_1_3 = -t19 - x_1 + x_max_1
    k_1_3 = t18/(l_f_1_3 + t17)
    l_f_2_1 = x_max_2 - x_min_2
    t20 = k_sp_2*w_b_2*(a_B_2 + 1)
    t21 = t15*t20
    t22 = t14*t20
    k_2_1 = t22/(l_f_2_1 + t21)
    t23 = (1/2)*l_t_2
    l_f_2_2 = -t23 + x_2 - x_min_2
    k_2_2 = t22/(l_f_2_2 + t21)
    l_f_2_3 = -t23 - x_2 + x_max_2
    k_2_3 = t22/(l_f_2_3 + t21)
    l_f_3_1 = x_max_3 - x_min_3
    t24 = k_sp_3*w_b_3*(a_B_3 + 1)
    t25 = t15*t24
    t26 = t14*t24
    k_3_1 = t26/(l_f_3_1 + t25)
    t27 = (1/2)*l_t_3
    l_f_3_2 = -t27 + x_3 - x_min_3
    k_3_2 = t26/(l_f_3_2 + t25)
    l_f_3_3 = -t27 - x_3 + x_max_3
    k_3_3 = t26/(l_f_3_3 + t25)
    t28 = (1/2)*m_d_1
    t29 = (1/2)*m_d_2
    t30 = (1/2)*m_d_3
    t31 = m_L + m_p
    t32 = t28 + t29 + t30 + t31
    t33 = g_x*t32
    t34 = g_y*t32
    t35 = g_z*t32
    mu_1 = t4*(-A_x_1*t33 - A_y_1*t34 - A_z_1*t35)
    mu_2 = t4*(-A_x_2*t33 - A_y_2*t34 - A_z_2*t35)
    mu_3 = t4*(-A_x_3*t33 - A_y_3*t34 - A_z_3*t35)
    t36 = (1/6)*m_d_1
    t37 = (1/3)*m_d_1
    t38 = (1/3)*m_d_2
    t39 = (1/3)*m_d_3
    t40 = t31 + t37 + t38 + t39
    t41 = D_p_x_1*t40 + n_1_x*t36
    t42 = D_p_y_1*t40 + n_1_y*t36
    t43 = D_p_z_1*t40 + n_1_z*t36
    t44 = (1/3)*rho_b
    t45 = l_f_1_2*t44
    t46 = l_f_1_3*t44
    t47 = n_1_x*t45 + n_1_x*t46
    t48 = (1/6)*m_d_2
    t49 = D_p_x_2*t40 + n_2_x*t48
    t50 = D_p_y_2*t40 + n_2_y*t48
    t51 = D_p_z_2*t40 + n_2_z*t48
    t52 = (1/6)*m_d_3
    t53 = D_p_x_3*t40 + n_3_x*t52
    t54 = D_p_y_3*t40 + n_3_y*t52
    t55 = D_p_z_3*t40 + n_3_z*t52
    t56 = (1/6)*rho_b
    t57 = l_f_1_3*t56
    t58 = R_p_1*n_1_x
    t59 = l_f_1_2*t56
    t60 = D_delta_x_4*t40
    t61 = D_delta_y_4*t40
    t62 = D_delta_z_4*t40
    t63 = m_t_1 + t28
    t64 = n_1_y*t45 + n_1_y*t46
    t65 = R_p_1*n_1_y
    t66 = D_delta_x_5*t40
    t67 = D_delta_y_5*t40
    t68 = D_delta_z_5*t40
    t69 = n_1_z*t45 + n_1_z*t46
    t70 = R_p_1*n_1_z
    t71 = D_delta_x_6*t40
    t72 = D_delta_y_6*t40
    t73 = D_delta_z_6*t40
    t74 = l_f_2_2*t44
    t75 = l_f_2_3*t44
    t76 = n_2_x*t74 + n_2_x*t75
    t77 = l_f_2_3*t56
    t78 = R_p_2*n_2_x
    t79 = l_f_2_2*t56
    t80 = D_delta_x_7*t40
    t81 = D_delta_y_7*t40
    t82 = D_delta_z_7*t40
    t83 = m_t_2 + t29
    t84 = n_2_y*t74 + n_2_y*t75
    t85 = R_p_2*n_2_y
    t86 = D_delta_x_8*t40
    t87 = D_delta_y_8*t40
    t88 = D_delta_z_8*t40
    t89 = n_2_z*t74 + n_2_z*t75
    t90 = R_p_2*n_2_z
    t91 = D_delta_y_9*t40
    t92 = D_delta_z_9*t40
    t93 = D_delta_x_9*t40
    t94 = l_f_3_2*t44
    t95 = l_f_3_3*t44
    t96 = n_3_x*t94 + n_3_x*t95
    t97 = l_f_3_3*t56
    t98 = R_p_3*n_3_x
    t99 = l_f_3_2*t56
    t100 = D_delta_x_10*t40
    t101 = D_delta_y_10*t40
    t102 = D_delta_z_10*t40
    t103 = m_t_3 + t30
    t104 = n_3_y*t94 + n_3_y*t95
    t105 = R_p_3*n_3_y
    t106 = D_delta_x_11*t40
    t107 = D_delta_y_11*t40
    t108 = D_delta_z_11*t40
    t109 = n_3_z*t94 + n_3_z*t95
    t110 = R_p_3*n_3_z
    t111 = D_delta_x_12*t40
    t112 = D_delta_y_12*t40
    t113 = D_delta_z_12*t40
    t114 = l_f_1_1*t44
    t115 = R_p_1*t114
    t116 = -R_p_1*l_f_1_1*t56
    t117 = l_f_2_1*t44
    t118 = R_p_2*t117
    t119 = -R_p_2*l_f_2_1*t56
    t120 = l_f_3_1*t44
    t121 = R_p_3*t120
    t122 = -R_p_3*l_f_3_1*t56
    t123 = D_delta_y_4**2
    t124 = D_delta_z_4**2
    t125 = n_1_x**2
    t126 = m_t_1 + t37
    t127 = D_delta_x_5**2
    t128 = D_delta_z_5**2
    t129 = n_1_y**2
    t130 = D_delta_x_6**2
    t131 = D_delta_y_6**2
    t132 = n_1_z**2
    t133 = D_delta_y_7**2
    t134 = D_delta_z_7**2
    t135 = n_2_x**2
    t136 = m_t_2 + t38
    t137 = D_delta_x_8**2
    t138 = D_delta_z_8**2
    t139 = n_2_y**2
    t140 = D_delta_x_9**2
    t141 = D_delta_y_9**2
    t142 = n_2_z**2
    t143 = D_delta_y_10**2
    t144 = D_delta_z_10**2
    t145 = n_3_x**2
    t146 = m_t_3 + t39
    t147 = D_delta_x_11**2
    t148 = D_delta_z_11**2
    t149 = n_3_y**2
    t150 = D_delta_x_12**2
    t151 = D_delta_y_12**2
    t152 = n_3_z**2
    t153 = D_delta_x_4*D_p_x_1
    t154 = D_delta_y_4*D_p_y_1
    t155 = D_delta_y_4*mu_1
    t156 = D_delta_z_4*D_p_z_1
    t157 = D_delta_z_4*mu_1
    t158 = D_delta_x_4 - 1
    t159 = mu_1*t158
    t160 = D_delta_x_4*mu_3
    t161 = D_delta_x_4*mu_2
    t162 = D_delta_y_4*mu_3
    t163 = D_delta_y_4*mu_2
    t164 = D_delta_z_4*mu_3
    t165 = D_delta_z_4*mu_2
    t166 = k_1_3*n_1_x
    t167 = k_1_2*n_1_x
    t168 = D_delta_x_5*D_p_x_1
    t169 = D_delta_x_5*mu_1
    t170 = D_delta_y_5*D_p_y_1
    t171 = D_delta_z_5*D_p_z_1
    t172 = D_delta_z_5*mu_1
    t173 = D_delta_y_5 - 1
    t174 = mu_1*t173
    t175 = D_delta_x_5*mu_3
    t176 = D_delta_x_5*mu_2
    t177 = D_delta_y_5*mu_3
    t178 = D_delta_y_5*mu_2
    t179 = D_delta_z_5*mu_3
    t180 = D_delta_z_5*mu_2
    t181 = k_1_3*n_1_y
    t182 = k_1_2*n_1_y
    t183 = D_delta_x_6*D_p_x_1
    t184 = D_delta_x_6*mu_1
    t185 = D_delta_y_6*D_p_y_1
    t186 = D_delta_y_6*mu_1
    t187 = D_delta_z_6*D_p_z_1
    t188 = D_delta_z_6 - 1
    t189 = mu_1*t188
    t190 = D_delta_x_6*mu_3
    t191 = D_delta_x_6*mu_2
    t192 = D_delta_y_6*mu_3
    t193 = D_delta_y_6*mu_2
    t194 = D_delta_z_6*mu_3
    t195 = D_delta_z_6*mu_2
    t196 = k_1_3*n_1_z
    t197 = k_1_2*n_1_z
    t198 = D_delta_x_7*mu_3
    t199 = D_delta_x_7*mu_1
    t200 = D_delta_y_7*D_p_y_1
    t201 = D_delta_y_7*mu_1
    t202 = D_delta_z_7*D_p_z_1
    t203 = D_delta_z_7*mu_1
    t204 = D_delta_x_7 - 1
    t205 = mu_2*t204
    t206 = D_delta_y_7*mu_3
    t207 = D_delta_y_7*mu_2
    t208 = D_delta_z_7*mu_3
    t209 = D_delta_z_7*mu_2
    t210 = k_2_3*n_2_x
    t211 = k_2_2*n_2_x
    t212 = D_delta_x_8*D_p_x_1
    t213 = D_delta_x_8*mu_1
    t214 = D_delta_y_8*mu_3
    t215 = D_delta_y_8*mu_1
    t216 = D_delta_z_8*D_p_z_1
    t217 = D_delta_z_8*mu_1
    t218 = D_delta_y_8 - 1
    t219 = mu_2*t218
    t220 = D_delta_x_8*mu_3
    t221 = D_delta_x_8*mu_2
    t222 = D_delta_z_8*mu_3
    t223 = D_delta_z_8*mu_2
    t224 = k_2_3*n_2_y
    t225 = k_2_2*n_2_y
    t226 = D_delta_x_9*D_p_x_1
    t227 = D_delta_x_9*mu_1
    t228 = D_delta_y_9*D_p_y_1
    t229 = D_delta_y_9*mu_1
    t230 = D_delta_z_9*mu_3
    t231 = D_delta_z_9*mu_1
    t232 = D_delta_z_9 - 1
    t233 = mu_2*t232
    t234 = D_delta_x_9*mu_3
    t235 = D_delta_x_9*mu_2
    t236 = D_delta_y_9*mu_3
    t237 = D_delta_y_9*mu_2
    t238 = k_2_3*n_2_z
    t239 = k_2_2*n_2_z
    t240 = D_delta_x_10*mu_2
    t241 = D_delta_x_10*mu_1
    t242 = D_delta_y_10*D_p_y_1
    t243 = D_delta_y_10*mu_1
    t244 = D_delta_z_10*D_p_z_1
    t245 = D_delta_z_10*mu_1
    t246 = D_delta_x_10 - 1
    t247 = mu_3*t246
    t248 = D_delta_y_10*mu_3
    t249 = D_delta_y_10*mu_2
    t250 = D_delta_z_10*mu_3
    t251 = D_delta_z_10*mu_2
    t252 = k_3_3*n_3_x
    t253 = k_3_2*n_3_x
    t254 = D_delta_x_11*D_p_x_1
    t255 = D_delta_x_11*mu_1
    t256 = D_delta_y_11*mu_2
    t257 = D_delta_y_11*mu_1
    t258 = D_delta_z_11*D_p_z_1
    t259 = D_delta_z_11*mu_1
    t260 = D_delta_y_11 - 1
    t261 = mu_3*t260
    t262 = D_delta_x_11*mu_3
    t263 = D_delta_x_11*mu_2
    t264 = D_delta_z_11*mu_3
    t265 = D_delta_z_11*mu_2
    t266 = k_3_3*n_3_y
    t267 = k_3_2*n_3_y
    t268 = D_delta_x_12*D_p_x_1
    t269 = D_delta_x_12*mu_1
    t270 = D_delta_y_12*D_p_y_1
    t271 = D_delta_y_12*mu_1
    t272 = D_delta_z_12*mu_2
    t273 = D_delta_z_12*mu_1
    t274 = D_delta_z_12 - 1
    t275 = mu_3*t274
    t276 = D_delta_x_12*mu_3
    t277 = D_delta_x_12*mu_2
    t278 = D_delta_y_12*mu_3
    t279 = D_delta_y_12*mu_2
    t280 = k_3_3*n_3_z
    t281 = k_3_2*n_3_z
    t282 = R_p_1*k_1_1
    t283 = R_p_2*k_2_1
    t284 = R_p_3*k_3_1
    t285 = D_delta_x_4**2
    t286 = D_delta_y_5**2
    t287 = D_delta_z_6**2
    t288 = D_delta_x_7**2
    t289 = D_delta_y_8**2
    t290 = D_delta_z_9**2
    t291 = D_delta_x_10**2
    t292 = D_delta_y_11**2
    t293 = D_delta_z_12**2
    M_wq_out = np.zeros((*batch, 15, 21), dtype)
    M_wq_out[..., 0, 0] = (
        D_delta_x_4*t41 + D_delta_y_4*t42 + D_delta_z_4*t43 + D_p_x_1*t36 + m_t_1*n_1_x + n_1_x*t37 + t47
    )
    M_wq_out[..., 0, 1] = D_delta_x_4*t49 + D_delta_y_4*t50 + D_delta_z_4*t51 + D_p_x_2*t36
    M_wq_out[..., 0, 2] = D_delta_x_4*t53 + D_delta_y_4*t54 + D_delta_z_4*t55 + D_p_x_3*t36
    M_wq_out[..., 0, 3] = t57*t58
    M_wq_out[..., 0, 6] = t58*t59
    M_wq_out[..., 0, 12] = D_delta_x_1*t36 + D_delta_x_1*t60 + D_delta_y_1*t61 + D_delta_z_1*t62
    M_wq_out[..., 0, 13] = D_delta_x_2*t36 + D_delta_x_2*t60 + D_delta_y_2*t61 + D_delta_z_2*t62
    M_wq_out[..., 0, 14] = D_delta_x_3*t36 + D_delta_x_3*t60 + D_delta_y_3*t61 + D_delta_z_3*t62
    M_wq_out[..., 0, 15] = t47
    M_wq_out[..., 0, 18] = D_delta_x_4*t32 + t63
    M_wq_out[..., 0, 19] = D_delta_y_4*t32
    M_wq_out[..., 0, 20] = D_delta_z_4*t32
    M_wq_out[..., 1, 0] = (
        D_delta_x_5*t41 + D_delta_y_5*t42 + D_delta_z_5*t43 + D_p_y_1*t36 + m_t_1*n_1_y + n_1_y*t37 + t64
    )
    M_wq_out[..., 1, 1] = D_delta_x_5*t49 + D_delta_y_5*t50 + D_delta_z_5*t51 + D_p_y_2*t36
    M_wq_out[..., 1, 2] = D_delta_x_5*t53 + D_delta_y_5*t54 + D_delta_z_5*t55 + D_p_y_3*t36
    M_wq_out[..., 1, 3] = t57*t65
    M_wq_out[..., 1, 6] = t59*t65
    M_wq_out[..., 1, 12] = D_delta_x_1*t66 + D_delta_y_1*t36 + D_delta_y_1*t67 + D_delta_z_1*t68
    M_wq_out[..., 1, 13] = D_delta_x_2*t66 + D_delta_y_2*t36 + D_delta_y_2*t67 + D_delta_z_2*t68
    M_wq_out[..., 1, 14] = D_delta_x_3*t66 + D_delta_y_3*t36 + D_delta_y_3*t67 + D_delta_z_3*t68
    M_wq_out[..., 1, 15] = t64
    M_wq_out[..., 1, 18] = D_delta_x_5*t32
    M_wq_out[..., 1, 19] = D_delta_y_5*t32 + t63
    M_wq_out[..., 1, 20] = D_delta_z_5*t32
    M_wq_out[..., 2, 0] = (
        D_delta_x_6*t41 + D_delta_y_6*t42 + D_delta_z_6*t43 + D_p_z_1*t36 + m_t_1*n_1_z + n_1_z*t37 + t69
    )
    M_wq_out[..., 2, 1] = D_delta_x_6*t49 + D_delta_y_6*t50 + D_delta_z_6*t51 + D_p_z_2*t36
    M_wq_out[..., 2, 2] = D_delta_x_6*t53 + D_delta_y_6*t54 + D_delta_z_6*t55 + D_p_z_3*t36
    M_wq_out[..., 2, 3] = t57*t70
    M_wq_out[..., 2, 6] = t59*t70
    M_wq_out[..., 2, 12] = D_delta_x_1*t71 + D_delta_y_1*t72 + D_delta_z_1*t36 + D_delta_z_1*t73
    M_wq_out[..., 2, 13] = D_delta_x_2*t71 + D_delta_y_2*t72 + D_delta_z_2*t36 + D_delta_z_2*t73
    M_wq_out[..., 2, 14] = D_delta_x_3*t71 + D_delta_y_3*t72 + D_delta_z_3*t36 + D_delta_z_3*t73
    M_wq_out[..., 2, 15] = t69
    M_wq_out[..., 2, 18] = D_delta_x_6*t32
    M_wq_out[..., 2, 19] = D_delta_y_6*t32
    M_wq_out[..., 2, 20] = D_delta_z_6*t32 + t63
    M_wq_out[..., 3, 0] = D_delta_x_7*t41 + D_delta_y_7*t42 + D_delta_z_7*t43 + D_p_x_1*t48
    M_wq_out[..., 3, 1] = (
        D_delta_x_7*t49 + D_delta_y_7*t50 + D_delta_z_7*t51 + D_p_x_2*t48 + m_t_2*n_2_x + n_2_x*t38 + t76
    )
    M_wq_out[..., 3, 2] = D_delta_x_7*t53 + D_delta_y_7*t54 + D_delta_z_7*t55 + D_p_x_3*t48
    M_wq_out[..., 3, 4] = t77*t78
    M_wq_out[..., 3, 7] = t78*t79
    M_wq_out[..., 3, 12] = D_delta_x_1*t48 + D_delta_x_1*t80 + D_delta_y_1*t81 + D_delta_z_1*t82
    M_wq_out[..., 3, 13] = D_delta_x_2*t48 + D_delta_x_2*t80 + D_delta_y_2*t81 + D_delta_z_2*t82
    M_wq_out[..., 3, 14] = D_delta_x_3*t48 + D_delta_x_3*t80 + D_delta_y_3*t81 + D_delta_z_3*t82
    M_wq_out[..., 3, 16] = t76
    M_wq_out[..., 3, 18] = D_delta_x_7*t32 + t83
    M_wq_out[..., 3, 19] = D_delta_y_7*t32
    M_wq_out[..., 3, 20] = D_delta_z_7*t32
    M_wq_out[..., 4, 0] = D_delta_x_8*t41 + D_delta_y_8*t42 + D_delta_z_8*t43 + D_p_y_1*t48
    M_wq_out[..., 4, 1] = (
        D_delta_x_8*t49 + D_delta_y_8*t50 + D_delta_z_8*t51 + D_p_y_2*t48 + m_t_2*n_2_y + n_2_y*t38 + t84
    )
    M_wq_out[..., 4, 2] = D_delta_x_8*t53 + D_delta_y_8*t54 + D_delta_z_8*t55 + D_p_y_3*t48
    M_wq_out[..., 4, 4] = t77*t85
    M_wq_out[..., 4, 7] = t79*t85
    M_wq_out[..., 4, 12] = D_delta_x_1*t86 + D_delta_y_1*t48 + D_delta_y_1*t87 + D_delta_z_1*t88
    M_wq_out[..., 4, 13] = D_delta_x_2*t86 + D_delta_y_2*t48 + D_delta_y_2*t87 + D_delta_z_2*t88
    M_wq_out[..., 4, 14] = D_delta_x_3*t86 + D_delta_y_3*t48 + D_delta_y_3*t87 + D_delta_z_3*t88
    M_wq_out[..., 4, 16] = t84
    M_wq_out[..., 4, 18] = D_delta_x_8*t32
    M_wq_out[..., 4, 19] = D_delta_y_8*t32 + t83
    M_wq_out[..., 4, 20] = D_delta_z_8*t32
    M_wq_out[..., 5, 0] = D_delta_x_9*t41 + D_delta_y_9*t42 + D_delta_z_9*t43 + D_p_z_1*t48
    M_wq_out[..., 5, 1] = (
        D_delta_x_9*t49 + D_delta_y_9*t50 + D_delta_z_9*t51 + D_p_z_2*t48 + m_t_2*n_2_z + n_2_z*t38 + t89
    )
    M_wq_out[..., 5, 2] = D_delta_x_9*t53 + D_delta_y_9*t54 + D_delta_z_9*t55 + D_p_z_3*t48
    M_wq_out[..., 5, 4] = t77*t90
    M_wq_out[..., 5, 7] = t79*t90
    M_wq_out[..., 5, 12] = D_delta_x_1*t93 + D_delta_y_1*t91 + D_delta_z_1*t48 + D_delta_z_1*t92
    M_wq_out[..., 5, 13] = D_delta_x_2*t93 + D_delta_y_2*t91 + D_delta_z_2*t48 + D_delta_z_2*t92
    M_wq_out[..., 5, 14] = D_delta_x_3*t93 + D_delta_y_3*t91 + D_delta_z_3*t48 + D_delta_z_3*t92
    M_wq_out[..., 5, 16] = t89
    M_wq_out[..., 5, 18] = D_delta_x_9*t32
    M_wq_out[..., 5, 19] = D_delta_y_9*t32
    M_wq_out[..., 5, 20] = D_delta_z_9*t32 + t83
    M_wq_out[..., 6, 0] = D_delta_x_10*t41 + D_delta_y_10*t42 + D_delta_z_10*t43 + D_p_x_1*t52
    M_wq_out[..., 6, 1] = D_delta_x_10*t49 + D_delta_y_10*t50 + D_delta_z_10*t51 + D_p_x_2*t52
    M_wq_out[..., 6, 2] = (
        D_delta_x_10*t53 + D_delta_y_10*t54 + D_delta_z_10*t55 + D_p_x_3*t52 + m_t_3*n_3_x + n_3_x*t39 + t96
    )
    M_wq_out[..., 6, 5] = t97*t98
    M_wq_out[..., 6, 8] = t98*t99
    M_wq_out[..., 6, 12] = D_delta_x_1*t100 + D_delta_x_1*t52 + D_delta_y_1*t101 + D_delta_z_1*t102
    M_wq_out[..., 6, 13] = D_delta_x_2*t100 + D_delta_x_2*t52 + D_delta_y_2*t101 + D_delta_z_2*t102
    M_wq_out[..., 6, 14] = D_delta_x_3*t100 + D_delta_x_3*t52 + D_delta_y_3*t101 + D_delta_z_3*t102
    M_wq_out[..., 6, 17] = t96
    M_wq_out[..., 6, 18] = D_delta_x_10*t32 + t103
    M_wq_out[..., 6, 19] = D_delta_y_10*t32
    M_wq_out[..., 6, 20] = D_delta_z_10*t32
    M_wq_out[..., 7, 0] = D_delta_x_11*t41 + D_delta_y_11*t42 + D_delta_z_11*t43 + D_p_y_1*t52
    M_wq_out[..., 7, 1] = D_delta_x_11*t49 + D_delta_y_11*t50 + D_delta_z_11*t51 + D_p_y_2*t52
    M_wq_out[..., 7, 2] = (
        D_delta_x_11*t53 + D_delta_y_11*t54 + D_delta_z_11*t55 + D_p_y_3*t52 + m_t_3*n_3_y + n_3_y*t39 + t104
    )
    M_wq_out[..., 7, 5] = t105*t97
    M_wq_out[..., 7, 8] = t105*t99
    M_wq_out[..., 7, 12] = D_delta_x_1*t106 + D_delta_y_1*t107 + D_delta_y_1*t52 + D_delta_z_1*t108
    M_wq_out[..., 7, 13] = D_delta_x_2*t106 + D_delta_y_2*t107 + D_delta_y_2*t52 + D_delta_z_2*t108
    M_wq_out[..., 7, 14] = D_delta_x_3*t106 + D_delta_y_3*t107 + D_delta_y_3*t52 + D_delta_z_3*t108
    M_wq_out[..., 7, 17] = t104
    M_wq_out[..., 7, 18] = D_delta_x_11*t32
    M_wq_out[..., 7, 19] = D_delta_y_11*t32 + t103
    M_wq_out[..., 7, 20] = D_delta_z_11*t32
    M_wq_out[..., 8, 0] = D_delta_x_12*t41 + D_delta_y_12*t42 + D_delta_z_12*t43 + D_p_z_1*t52
    M_wq_out[..., 8, 1] = D_delta_x_12*t49 + D_delta_y_12*t50 + D_delta_z_12*t51 + D_p_z_2*t52
    M_wq_out[..., 8, 2] = (
        D_delta_x_12*t53 + D_delta_y_12*t54 + D_delta_z_12*t55 + D_p_z_3*t52 + m_t_3*n_3_z + n_3_z*t39 + t109
    )
    M_wq_out[..., 8, 5] = t110*t97
    M_wq_out[..., 8, 8] = t110*t99
    M_wq_out[..., 8, 12] = D_delta_x_1*t111 + D_delta_y_1*t112 + D_delta_z_1*t113 + D_delta_z_1*t52
    M_wq_out[..., 8, 13] = D_delta_x_2*t111 + D_delta_y_2*t112 + D_delta_z_2*t113 + D_delta_z_2*t52
    M_wq_out[..., 8, 14] = D_delta_x_3*t111 + D_delta_y_3*t112 + D_delta_z_3*t113 + D_delta_z_3*t52
    M_wq_out[..., 8, 17] = t109
    M_wq_out[..., 8, 18] = D_delta_x_12*t32
    M_wq_out[..., 8, 19] = D_delta_y_12*t32
    M_wq_out[..., 8, 20] = D_delta_z_12*t32 + t103
    M_wq_out[..., 9, 0] = t57
    M_wq_out[..., 9, 3] = (1/3)*R_p_1*l_f_1_3*rho_b - t115
    M_wq_out[..., 9, 6] = t116
    M_wq_out[..., 9, 15] = t57
    M_wq_out[..., 10, 0] = t59
    M_wq_out[..., 10, 3] = t116
    M_wq_out[..., 10, 6] = (1/3)*R_p_1*l_f_1_2*rho_b - t115
    M_wq_out[..., 10, 15] = t59
    M_wq_out[..., 11, 1] = t77
    M_wq_out[..., 11, 4] = (1/3)*R_p_2*l_f_2_3*rho_b - t118
    M_wq_out[..., 11, 7] = t119
    M_wq_out[..., 11, 16] = t77
    M_wq_out[..., 12, 1] = t79
    M_wq_out[..., 12, 4] = t119
    M_wq_out[..., 12, 7] = (1/3)*R_p_2*l_f_2_2*rho_b - t118
    M_wq_out[..., 12, 16] = t79
    M_wq_out[..., 13, 2] = t97
    M_wq_out[..., 13, 5] = (1/3)*R_p_3*l_f_3_3*rho_b - t121
    M_wq_out[..., 13, 8] = t122
    M_wq_out[..., 13, 17] = t97
    M_wq_out[..., 14, 2] = t99
    M_wq_out[..., 14, 5] = t122
    M_wq_out[..., 14, 8] = (1/3)*R_p_3*l_f_3_2*rho_b - t121
    M_wq_out[..., 14, 17] = t99
    M_ww_out = np.empty((*batch, 15), dtype)
    M_ww_out[..., 0] = (
        D_delta_x_4*t36 + D_delta_x_4*(t36 + t60) + t123*t40 + t124*t40 + t125*t45 + t125*t46 + t126
    )
    M_ww_out[..., 1] = (
        D_delta_y_5*t36 + D_delta_y_5*(t36 + t67) + t126 + t127*t40 + t128*t40 + t129*t45 + t129*t46
    )
    M_ww_out[..., 2] = (
        D_delta_z_6*t36 + D_delta_z_6*(t36 + t73) + t126 + t130*t40 + t131*t40 + t132*t45 + t132*t46
    )
    M_ww_out[..., 3] = (
        D_delta_x_7*t48 + D_delta_x_7*(t48 + t80) + t133*t40 + t134*t40 + t135*t74 + t135*t75 + t136
    )
    M_ww_out[..., 4] = (
        D_delta_y_8*t48 + D_delta_y_8*(t48 + t87) + t136 + t137*t40 + t138*t40 + t139*t74 + t139*t75
    )
    M_ww_out[..., 5] = (
        D_delta_z_9*t48 + D_delta_z_9*(t48 + t92) + t136 + t140*t40 + t141*t40 + t142*t74 + t142*t75
    )
    M_ww_out[..., 6] = (
        D_delta_x_10*t52 + D_delta_x_10*(t100 + t52) + t143*t40 + t144*t40 + t145*t94 + t145*t95 + t146
    )
    M_ww_out[..., 7] = (
        D_delta_y_11*t52 + D_delta_y_11*(t107 + t52) + t146 + t147*t40 + t148*t40 + t149*t94 + t149*t95
    )
    M_ww_out[..., 8] = (
        D_delta_z_12*t52 + D_delta_z_12*(t113 + t52) + t146 + t150*t40 + t151*t40 + t152*t94 + t152*t95
    )
    M_ww_out[..., 9] = t114 + t46
    M_ww_out[..., 10] = t114 + t45
    M_ww_out[..., 11] = t117 + t75
    M_ww_out[..., 12] = t117 + t74
    M_ww_out[..., 13] = t120 + t95
    M_ww_out[..., 14] = t120 + t94
    K_wq_out = np.zeros((*batch, 15, 21), dtype)
    K_wq_out[..., 0, 0] = (
        D_delta_x_4*D_p_x_1*k_C + D_delta_y_4*D_p_y_1*k_C + D_delta_z_4*D_p_z_1*k_C - U_1_x_1*t159
        - U_1_y_1*t155 - U_1_z_1*t157 + k_1_2*n_1_x + k_1_3*n_1_x - mu_2*t153 - mu_2*t154 - mu_2*t156
        - mu_3*t153 - mu_3*t154 - mu_3*t156
    )
    K_wq_out[..., 0, 1] = (
        D_delta_x_4*D_p_x_2*k_C + D_delta_y_4*D_p_y_2*k_C + D_delta_z_4*D_p_z_2*k_C - D_p_x_2*t159
        - D_p_x_2*t160 - D_p_y_2*t155 - D_p_y_2*t162 - D_p_z_2*t157 - D_p_z_2*t164 - U_2_x_2*t161
        - U_2_y_2*t163 - U_2_z_2*t165
    )
    K_wq_out[..., 0, 2] = (
        D_delta_x_4*D_p_x_3*k_C + D_delta_y_4*D_p_y_3*k_C + D_delta_z_4*D_p_z_3*k_C - D_p_x_3*t159
        - D_p_x_3*t161 - D_p_y_3*t155 - D_p_y_3*t163 - D_p_z_3*t157 - D_p_z_3*t165 - U_3_x_3*t160
        - U_3_y_3*t162 - U_3_z_3*t164
    )
    K_wq_out[..., 0, 3] = -R_p_1*t166
    K_wq_out[..., 0, 6] = -R_p_1*t167
    K_wq_out[..., 0, 12] = (
        D_delta_x_1*D_delta_x_4*k_C - D_delta_x_1*t159 - D_delta_x_1*t160 - D_delta_x_1*t161
        + D_delta_y_1*D_delta_y_4*k_C - D_delta_y_1*t155 - D_delta_y_1*t162 - D_delta_y_1*t163
        + D_delta_z_1*D_delta_z_4*k_C - D_delta_z_1*t157 - D_delta_z_1*t164 - D_delta_z_1*t165
    )
    K_wq_out[..., 0, 13] = (
        D_delta_x_2*D_delta_x_4*k_C - D_delta_x_2*t159 - D_delta_x_2*t160 - D_delta_x_2*t161
        + D_delta_y_2*D_delta_y_4*k_C - D_delta_y_2*t155 - D_delta_y_2*t162 - D_delta_y_2*t163
        + D_delta_z_2*D_delta_z_4*k_C - D_delta_z_2*t157 - D_delta_z_2*t164 - D_delta_z_2*t165
    )
    K_wq_out[..., 0, 14] = (
        D_delta_x_3*D_delta_x_4*k_C - D_delta_x_3*t159 - D_delta_x_3*t160 - D_delta_x_3*t161
        + D_delta_y_3*D_delta_y_4*k_C - D_delta_y_3*t155 - D_delta_y_3*t162 - D_delta_y_3*t163
        + D_delta_z_3*D_delta_z_4*k_C - D_delta_z_3*t157 - D_delta_z_3*t164 - D_delta_z_3*t165
    )
    K_wq_out[..., 0, 15] = t166 + t167
    K_wq_out[..., 0, 18] = D_delta_x_4*k_C
    K_wq_out[..., 0, 19] = D_delta_y_4*k_C
    K_wq_out[..., 0, 20] = D_delta_z_4*k_C
    K_wq_out[..., 1, 0] = (
        D_delta_x_5*D_p_x_1*k_C + D_delta_y_5*D_p_y_1*k_C + D_delta_z_5*D_p_z_1*k_C - U_1_x_1*t169
        - U_1_y_1*t174 - U_1_z_1*t172 + k_1_2*n_1_y + k_1_3*n_1_y - mu_2*t168 - mu_2*t170 - mu_2*t171
        - mu_3*t168 - mu_3*t170 - mu_3*t171
    )
    K_wq_out[..., 1, 1] = (
        D_delta_x_5*D_p_x_2*k_C + D_delta_y_5*D_p_y_2*k_C + D_delta_z_5*D_p_z_2*k_C - D_p_x_2*t169
        - D_p_x_2*t175 - D_p_y_2*t174 - D_p_y_2*t177 - D_p_z_2*t172 - D_p_z_2*t179 - U_2_x_2*t176
        - U_2_y_2*t178 - U_2_z_2*t180
    )
    K_wq_out[..., 1, 2] = (
        D_delta_x_5*D_p_x_3*k_C + D_delta_y_5*D_p_y_3*k_C + D_delta_z_5*D_p_z_3*k_C - D_p_x_3*t169
        - D_p_x_3*t176 - D_p_y_3*t174 - D_p_y_3*t178 - D_p_z_3*t172 - D_p_z_3*t180 - U_3_x_3*t175
        - U_3_y_3*t177 - U_3_z_3*t179
    )
    K_wq_out[..., 1, 3] = -R_p_1*t181
    K_wq_out[..., 1, 6] = -R_p_1*t182
    K_wq_out[..., 1, 12] = (
        D_delta_x_1*D_delta_x_5*k_C - D_delta_x_1*t169 - D_delta_x_1*t175 - D_delta_x_1*t176
        + D_delta_y_1*D_delta_y_5*k_C - D_delta_y_1*t174 - D_delta_y_1*t177 - D_delta_y_1*t178
        + D_delta_z_1*D_delta_z_5*k_C - D_delta_z_1*t172 - D_delta_z_1*t179 - D_delta_z_1*t180
    )
    K_wq_out[..., 1, 13] = (
        D_delta_x_2*D_delta_x_5*k_C - D_delta_x_2*t169 - D_delta_x_2*t175 - D_delta_x_2*t176
        + D_delta_y_2*D_delta_y_5*k_C - D_delta_y_2*t174 - D_delta_y_2*t177 - D_delta_y_2*t178
        + D_delta_z_2*D_delta_z_5*k_C - D_delta_z_2*t172 - D_delta_z_2*t179 - D_delta_z_2*t180
    )
    K_wq_out[..., 1, 14] = (
        D_delta_x_3*D_delta_x_5*k_C - D_delta_x_3*t169 - D_delta_x_3*t175 - D_delta_x_3*t176
        + D_delta_y_3*D_delta_y_5*k_C - D_delta_y_3*t174 - D_delta_y_3*t177 - D_delta_y_3*t178
        + D_delta_z_3*D_delta_z_5*k_C - D_delta_z_3*t172 - D_delta_z_3*t179 - D_delta_z_3*t180
    )
    K_wq_out[..., 1, 15] = t181 + t182
    K_wq_out[..., 1, 18] = D_delta_x_5*k_C
    K_wq_out[..., 1, 19] = D_delta_y_5*k_C
    K_wq_out[..., 1, 20] = D_delta_z_5*k_C
    K_wq_out[..., 2, 0] = (
        D_delta_x_6*D_p_x_1*k_C + D_delta_y_6*D_p_y_1*k_C + D_delta_z_6*D_p_z_1*k_C - U_1_x_1*t184
        - U_1_y_1*t186 - U_1_z_1*t189 + k_1_2*n_1_z + k_1_3*n_1_z - mu_2*t183 - mu_2*t185 - mu_2*t187
        - mu_3*t183 - mu_3*t185 - mu_3*t187
    )
    K_wq_out[..., 2, 1] = (
        D_delta_x_6*D_p_x_2*k_C + D_delta_y_6*D_p_y_2*k_C + D_delta_z_6*D_p_z_2*k_C - D_p_x_2*t184
        - D_p_x_2*t190 - D_p_y_2*t186 - D_p_y_2*t192 - D_p_z_2*t189 - D_p_z_2*t194 - U_2_x_2*t191
        - U_2_y_2*t193 - U_2_z_2*t195
    )
    K_wq_out[..., 2, 2] = (
        D_delta_x_6*D_p_x_3*k_C + D_delta_y_6*D_p_y_3*k_C + D_delta_z_6*D_p_z_3*k_C - D_p_x_3*t184
        - D_p_x_3*t191 - D_p_y_3*t186 - D_p_y_3*t193 - D_p_z_3*t189 - D_p_z_3*t195 - U_3_x_3*t190
        - U_3_y_3*t192 - U_3_z_3*t194
    )
    K_wq_out[..., 2, 3] = -R_p_1*t196
    K_wq_out[..., 2, 6] = -R_p_1*t197
    K_wq_out[..., 2, 12] = (
        D_delta_x_1*D_delta_x_6*k_C - D_delta_x_1*t184 - D_delta_x_1*t190 - D_delta_x_1*t191
        + D_delta_y_1*D_delta_y_6*k_C - D_delta_y_1*t186 - D_delta_y_1*t192 - D_delta_y_1*t193
        + D_delta_z_1*D_delta_z_6*k_C - D_delta_z_1*t189 - D_delta_z_1*t194 - D_delta_z_1*t195
    )
    K_wq_out[..., 2, 13] = (
        D_delta_x_2*D_delta_x_6*k_C - D_delta_x_2*t184 - D_delta_x_2*t190 - D_delta_x_2*t191
        + D_delta_y_2*D_delta_y_6*k_C - D_delta_y_2*t186 - D_delta_y_2*t192 - D_delta_y_2*t193
        + D_delta_z_2*D_delta_z_6*k_C - D_delta_z_2*t189 - D_delta_z_2*t194 - D_delta_z_2*t195
    )
    K_wq_out[..., 2, 14] = (
        D_delta_x_3*D_delta_x_6*k_C - D_delta_x_3*t184 - D_delta_x_3*t190 - D_delta_x_3*t191
        + D_delta_y_3*D_delta_y_6*k_C - D_delta_y_3*t186 - D_delta_y_3*t192 - D_delta_y_3*t193
        + D_delta_z_3*D_delta_z_6*k_C - D_delta_z_3*t189 - D_delta_z_3*t194 - D_delta_z_3*t195
    )
    K_wq_out[..., 2, 15] = t196 + t197
    K_wq_out[..., 2, 18] = D_delta_x_6*k_C
    K_wq_out[..., 2, 19] = D_delta_y_6*k_C
    K_wq_out[..., 2, 20] = D_delta_z_6*k_C
    K_wq_out[..., 3, 0] = (
        D_delta_x_7*D_p_x_1*k_C + D_delta_y_7*D_p_y_1*k_C + D_delta_z_7*D_p_z_1*k_C - D_p_x_1*t198
        - D_p_x_1*t205 - U_1_x_1*t199 - U_1_y_1*t201 - U_1_z_1*t203 - mu_2*t200 - mu_2*t202 - mu_3*t200
        - mu_3*t202
    )
    K_wq_out[..., 3, 1] = (
        D_delta_x_7*D_p_x_2*k_C + D_delta_y_7*D_p_y_2*k_C + D_delta_z_7*D_p_z_2*k_C - D_p_x_2*t198
        - D_p_x_2*t199 - D_p_y_2*t201 - D_p_y_2*t206 - D_p_z_2*t203 - D_p_z_2*t208 - U_2_x_2*t205
        - U_2_y_2*t207 - U_2_z_2*t209 + k_2_2*n_2_x + k_2_3*n_2_x
    )
    K_wq_out[..., 3, 2] = (
        D_delta_x_7*D_p_x_3*k_C + D_delta_y_7*D_p_y_3*k_C + D_delta_z_7*D_p_z_3*k_C - D_p_x_3*t199
        - D_p_x_3*t205 - D_p_y_3*t201 - D_p_y_3*t207 - D_p_z_3*t203 - D_p_z_3*t209 - U_3_x_3*t198
        - U_3_y_3*t206 - U_3_z_3*t208
    )
    K_wq_out[..., 3, 4] = -R_p_2*t210
    K_wq_out[..., 3, 7] = -R_p_2*t211
    K_wq_out[..., 3, 12] = (
        D_delta_x_1*D_delta_x_7*k_C - D_delta_x_1*t198 - D_delta_x_1*t199 - D_delta_x_1*t205
        + D_delta_y_1*D_delta_y_7*k_C - D_delta_y_1*t201 - D_delta_y_1*t206 - D_delta_y_1*t207
        + D_delta_z_1*D_delta_z_7*k_C - D_delta_z_1*t203 - D_delta_z_1*t208 - D_delta_z_1*t209
    )
    K_wq_out[..., 3, 13] = (
        D_delta_x_2*D_delta_x_7*k_C - D_delta_x_2*t198 - D_delta_x_2*t199 - D_delta_x_2*t205
        + D_delta_y_2*D_delta_y_7*k_C - D_delta_y_2*t201 - D_delta_y_2*t206 - D_delta_y_2*t207
        + D_delta_z_2*D_delta_z_7*k_C - D_delta_z_2*t203 - D_delta_z_2*t208 - D_delta_z_2*t209
    )
    K_wq_out[..., 3, 14] = (
        D_delta_x_3*D_delta_x_7*k_C - D_delta_x_3*t198 - D_delta_x_3*t199 - D_delta_x_3*t205
        + D_delta_y_3*D_delta_y_7*k_C - D_delta_y_3*t201 - D_delta_y_3*t206 - D_delta_y_3*t207
        + D_delta_z_3*D_delta_z_7*k_C - D_delta_z_3*t203 - D_delta_z_3*t208 - D_delta_z_3*t209
    )
    K_wq_out[..., 3, 16] = t210 + t211
    K_wq_out[..., 3, 18] = D_delta_x_7*k_C
    K_wq_out[..., 3, 19] = D_delta_y_7*k_C
    K_wq_out[..., 3, 20] = D_delta_z_7*k_C
    K_wq_out[..., 4, 0] = (
        D_delta_x_8*D_p_x_1*k_C + D_delta_y_8*D_p_y_1*k_C + D_delta_z_8*D_p_z_1*k_C - D_p_y_1*t214
        - D_p_y_1*t219 - U_1_x_1*t213 - U_1_y_1*t215 - U_1_z_1*t217 - mu_2*t212 - mu_2*t216 - mu_3*t212
        - mu_3*t216
    )
    K_wq_out[..., 4, 1] = (
        D_delta_x_8*D_p_x_2*k_C + D_delta_y_8*D_p_y_2*k_C + D_delta_z_8*D_p_z_2*k_C - D_p_x_2*t213
        - D_p_x_2*t220 - D_p_y_2*t214 - D_p_y_2*t215 - D_p_z_2*t217 - D_p_z_2*t222 - U_2_x_2*t221
        - U_2_y_2*t219 - U_2_z_2*t223 + k_2_2*n_2_y + k_2_3*n_2_y
    )
    K_wq_out[..., 4, 2] = (
        D_delta_x_8*D_p_x_3*k_C + D_delta_y_8*D_p_y_3*k_C + D_delta_z_8*D_p_z_3*k_C - D_p_x_3*t213
        - D_p_x_3*t221 - D_p_y_3*t215 - D_p_y_3*t219 - D_p_z_3*t217 - D_p_z_3*t223 - U_3_x_3*t220
        - U_3_y_3*t214 - U_3_z_3*t222
    )
    K_wq_out[..., 4, 4] = -R_p_2*t224
    K_wq_out[..., 4, 7] = -R_p_2*t225
    K_wq_out[..., 4, 12] = (
        D_delta_x_1*D_delta_x_8*k_C - D_delta_x_1*t213 - D_delta_x_1*t220 - D_delta_x_1*t221
        + D_delta_y_1*D_delta_y_8*k_C - D_delta_y_1*t214 - D_delta_y_1*t215 - D_delta_y_1*t219
        + D_delta_z_1*D_delta_z_8*k_C - D_delta_z_1*t217 - D_delta_z_1*t222 - D_delta_z_1*t223
    )
    K_wq_out[..., 4, 13] = (
        D_delta_x_2*D_delta_x_8*k_C - D_delta_x_2*t213 - D_delta_x_2*t220 - D_delta_x_2*t221
        + D_delta_y_2*D_delta_y_8*k_C - D_delta_y_2*t214 - D_delta_y_2*t215 - D_delta_y_2*t219
        + D_delta_z_2*D_delta_z_8*k_C - D_delta_z_2*t217 - D_delta_z_2*t222 - D_delta_z_2*t223
    )
    K_wq_out[..., 4, 14] = (
        D_delta_x_3*D_delta_x_8*k_C - D_delta_x_3*t213 - D_delta_x_3*t220 - D_delta_x_3*t221
        + D_delta_y_3*D_delta_y_8*k_C - D_delta_y_3*t214 - D_delta_y_3*t215 - D_delta_y_3*t219
        + D_delta_z_3*D_delta_z_8*k_C - D_delta_z_3*t217 - D_delta_z_3*t222 - D_delta_z_3*t223
    )
    K_wq_out[..., 4, 16] = t224 + t225
    K_wq_out[..., 4, 18] = D_delta_x_8*k_C
    K_wq_out[..., 4, 19] = D_delta_y_8*k_C
    K_wq_out[..., 4, 20] = D_delta_z_8*k_C
    K_wq_out[..., 5, 0] = (
        D_delta_x_9*D_p_x_1*k_C + D_delta_y_9*D_p_y_1*k_C + D_delta_z_9*D_p_z_1*k_C - D_p_z_1*t230
        - D_p_z_1*t233 - U_1_x_1*t227 - U_1_y_1*t229 - U_1_z_1*t231 - mu_2*t226 - mu_2*t228 - mu_3*t226
        - mu_3*t228
    )
    K_wq_out[..., 5, 1] = (
        D_delta_x_9*D_p_x_2*k_C + D_delta_y_9*D_p_y_2*k_C + D_delta_z_9*D_p_z_2*k_C - D_p_x_2*t227
        - D_p_x_2*t234 - D_p_y_2*t229 - D_p_y_2*t236 - D_p_z_2*t230 - D_p_z_2*t231 - U_2_x_2*t235
        - U_2_y_2*t237 - U_2_z_2*t233 + k_2_2*n_2_z + k_2_3*n_2_z
    )
    K_wq_out[..., 5, 2] = (
        D_delta_x_9*D_p_x_3*k_C + D_delta_y_9*D_p_y_3*k_C + D_delta_z_9*D_p_z_3*k_C - D_p_x_3*t227
        - D_p_x_3*t235 - D_p_y_3*t229 - D_p_y_3*t237 - D_p_z_3*t231 - D_p_z_3*t233 - U_3_x_3*t234
        - U_3_y_3*t236 - U_3_z_3*t230
    )
    K_wq_out[..., 5, 4] = -R_p_2*t238
    K_wq_out[..., 5, 7] = -R_p_2*t239
    K_wq_out[..., 5, 12] = (
        D_delta_x_1*D_delta_x_9*k_C - D_delta_x_1*t227 - D_delta_x_1*t234 - D_delta_x_1*t235
        + D_delta_y_1*D_delta_y_9*k_C - D_delta_y_1*t229 - D_delta_y_1*t236 - D_delta_y_1*t237
        + D_delta_z_1*D_delta_z_9*k_C - D_delta_z_1*t230 - D_delta_z_1*t231 - D_delta_z_1*t233
    )
    K_wq_out[..., 5, 13] = (
        D_delta_x_2*D_delta_x_9*k_C - D_delta_x_2*t227 - D_delta_x_2*t234 - D_delta_x_2*t235
        + D_delta_y_2*D_delta_y_9*k_C - D_delta_y_2*t229 - D_delta_y_2*t236 - D_delta_y_2*t237
        + D_delta_z_2*D_delta_z_9*k_C - D_delta_z_2*t230 - D_delta_z_2*t231 - D_delta_z_2*t233
    )
    K_wq_out[..., 5, 14] = (
        D_delta_x_3*D_delta_x_9*k_C - D_delta_x_3*t227 - D_delta_x_3*t234 - D_delta_x_3*t235
        + D_delta_y_3*D_delta_y_9*k_C - D_delta_y_3*t229 - D_delta_y_3*t236 - D_delta_y_3*t237
        + D_delta_z_3*D_delta_z_9*k_C - D_delta_z_3*t230 - D_delta_z_3*t231 - D_delta_z_3*t233
    )
    K_wq_out[..., 5, 16] = t238 + t239
    K_wq_out[..., 5, 18] = D_delta_x_9*k_C
    K_wq_out[..., 5, 19] = D_delta_y_9*k_C
    K_wq_out[..., 5, 20] = D_delta_z_9*k_C
    K_wq_out[..., 6, 0] = (
        D_delta_x_10*D_p_x_1*k_C + D_delta_y_10*D_p_y_1*k_C + D_delta_z_10*D_p_z_1*k_C - D_p_x_1*t240
        - D_p_x_1*t247 - U_1_x_1*t241 - U_1_y_1*t243 - U_1_z_1*t245 - mu_2*t242 - mu_2*t244 - mu_3*t242
        - mu_3*t244
    )
    K_wq_out[..., 6, 1] = (
        D_delta_x_10*D_p_x_2*k_C + D_delta_y_10*D_p_y_2*k_C + D_delta_z_10*D_p_z_2*k_C - D_p_x_2*t241
        - D_p_x_2*t247 - D_p_y_2*t243 - D_p_y_2*t248 - D_p_z_2*t245 - D_p_z_2*t250 - U_2_x_2*t240
        - U_2_y_2*t249 - U_2_z_2*t251
    )
    K_wq_out[..., 6, 2] = (
        D_delta_x_10*D_p_x_3*k_C + D_delta_y_10*D_p_y_3*k_C + D_delta_z_10*D_p_z_3*k_C - D_p_x_3*t240
        - D_p_x_3*t241 - D_p_y_3*t243 - D_p_y_3*t249 - D_p_z_3*t245 - D_p_z_3*t251 - U_3_x_3*t247
        - U_3_y_3*t248 - U_3_z_3*t250 + k_3_2*n_3_x + k_3_3*n_3_x
    )
    K_wq_out[..., 6, 5] = -R_p_3*t252
    K_wq_out[..., 6, 8] = -R_p_3*t253
    K_wq_out[..., 6, 12] = (
        D_delta_x_1*D_delta_x_10*k_C - D_delta_x_1*t240 - D_delta_x_1*t241 - D_delta_x_1*t247
        + D_delta_y_1*D_delta_y_10*k_C - D_delta_y_1*t243 - D_delta_y_1*t248 - D_delta_y_1*t249
        + D_delta_z_1*D_delta_z_10*k_C - D_delta_z_1*t245 - D_delta_z_1*t250 - D_delta_z_1*t251
    )
    K_wq_out[..., 6, 13] = (
        D_delta_x_10*D_delta_x_2*k_C - D_delta_x_2*t240 - D_delta_x_2*t241 - D_delta_x_2*t247
        + D_delta_y_10*D_delta_y_2*k_C - D_delta_y_2*t243 - D_delta_y_2*t248 - D_delta_y_2*t249
        + D_delta_z_10*D_delta_z_2*k_C - D_delta_z_2*t245 - D_delta_z_2*t250 - D_delta_z_2*t251
    )
    K_wq_out[..., 6, 14] = (
        D_delta_x_10*D_delta_x_3*k_C - D_delta_x_3*t240 - D_delta_x_3*t241 - D_delta_x_3*t247
        + D_delta_y_10*D_delta_y_3*k_C - D_delta_y_3*t243 - D_delta_y_3*t248 - D_delta_y_3*t249
        + D_delta_z_10*D_delta_z_3*k_C - D_delta_z_3*t245 - D_delta_z_3*t250 - D_delta_z_3*t251
    )
    K_wq_out[..., 6, 17] = t252 + t253
    K_wq_out[..., 6, 18] = D_delta_x_10*k_C
    K_wq_out[..., 6, 19] = D_delta_y_10*k_C
    K_wq_out[..., 6, 20] = D_delta_z_10*k_C
    K_wq_out[..., 7, 0] = (
        D_delta_x_11*D_p_x_1*k_C + D_delta_y_11*D_p_y_1*k_C + D_delta_z_11*D_p_z_1*k_C - D_p_y_1*t256
        - D_p_y_1*t261 - U_1_x_1*t255 - U_1_y_1*t257 - U_1_z_1*t259 - mu_2*t254 - mu_2*t258 - mu_3*t254
        - mu_3*t258
    )
    K_wq_out[..., 7, 1] = (
        D_delta_x_11*D_p_x_2*k_C + D_delta_y_11*D_p_y_2*k_C + D_delta_z_11*D_p_z_2*k_C - D_p_x_2*t255
        - D_p_x_2*t262 - D_p_y_2*t257 - D_p_y_2*t261 - D_p_z_2*t259 - D_p_z_2*t264 - U_2_x_2*t263
        - U_2_y_2*t256 - U_2_z_2*t265
    )
    K_wq_out[..., 7, 2] = (
        D_delta_x_11*D_p_x_3*k_C + D_delta_y_11*D_p_y_3*k_C + D_delta_z_11*D_p_z_3*k_C - D_p_x_3*t255
        - D_p_x_3*t263 - D_p_y_3*t256 - D_p_y_3*t257 - D_p_z_3*t259 - D_p_z_3*t265 - U_3_x_3*t262
        - U_3_y_3*t261 - U_3_z_3*t264 + k_3_2*n_3_y + k_3_3*n_3_y
    )
    K_wq_out[..., 7, 5] = -R_p_3*t266
    K_wq_out[..., 7, 8] = -R_p_3*t267
    K_wq_out[..., 7, 12] = (
        D_delta_x_1*D_delta_x_11*k_C - D_delta_x_1*t255 - D_delta_x_1*t262 - D_delta_x_1*t263
        + D_delta_y_1*D_delta_y_11*k_C - D_delta_y_1*t256 - D_delta_y_1*t257 - D_delta_y_1*t261
        + D_delta_z_1*D_delta_z_11*k_C - D_delta_z_1*t259 - D_delta_z_1*t264 - D_delta_z_1*t265
    )
    K_wq_out[..., 7, 13] = (
        D_delta_x_11*D_delta_x_2*k_C - D_delta_x_2*t255 - D_delta_x_2*t262 - D_delta_x_2*t263
        + D_delta_y_11*D_delta_y_2*k_C - D_delta_y_2*t256 - D_delta_y_2*t257 - D_delta_y_2*t261
        + D_delta_z_11*D_delta_z_2*k_C - D_delta_z_2*t259 - D_delta_z_2*t264 - D_delta_z_2*t265
    )
    K_wq_out[..., 7, 14] = (
        D_delta_x_11*D_delta_x_3*k_C - D_delta_x_3*t255 - D_delta_x_3*t262 - D_delta_x_3*t263
        + D_delta_y_11*D_delta_y_3*k_C - D_delta_y_3*t256 - D_delta_y_3*t257 - D_delta_y_3*t261
        + D_delta_z_11*D_delta_z_3*k_C - D_delta_z_3*t259 - D_delta_z_3*t264 - D_delta_z_3*t265
    )
    K_wq_out[..., 7, 17] = t266 + t267
    K_wq_out[..., 7, 18] = D_delta_x_11*k_C
    K_wq_out[..., 7, 19] = D_delta_y_11*k_C
    K_wq_out[..., 7, 20] = D_delta_z_11*k_C
    K_wq_out[..., 8, 0] = (
        D_delta_x_12*D_p_x_1*k_C + D_delta_y_12*D_p_y_1*k_C + D_delta_z_12*D_p_z_1*k_C - D_p_z_1*t272
        - D_p_z_1*t275 - U_1_x_1*t269 - U_1_y_1*t271 - U_1_z_1*t273 - mu_2*t268 - mu_2*t270 - mu_3*t268
        - mu_3*t270
    )
    K_wq_out[..., 8, 1] = (
        D_delta_x_12*D_p_x_2*k_C + D_delta_y_12*D_p_y_2*k_C + D_delta_z_12*D_p_z_2*k_C - D_p_x_2*t269
        - D_p_x_2*t276 - D_p_y_2*t271 - D_p_y_2*t278 - D_p_z_2*t273 - D_p_z_2*t275 - U_2_x_2*t277
        - U_2_y_2*t279 - U_2_z_2*t272
    )
    K_wq_out[..., 8, 2] = (
        D_delta_x_12*D_p_x_3*k_C + D_delta_y_12*D_p_y_3*k_C + D_delta_z_12*D_p_z_3*k_C - D_p_x_3*t269
        - D_p_x_3*t277 - D_p_y_3*t271 - D_p_y_3*t279 - D_p_z_3*t272 - D_p_z_3*t273 - U_3_x_3*t276
        - U_3_y_3*t278 - U_3_z_3*t275 + k_3_2*n_3_z + k_3_3*n_3_z
    )
    K_wq_out[..., 8, 5] = -R_p_3*t280
    K_wq_out[..., 8, 8] = -R_p_3*t281
    K_wq_out[..., 8, 12] = (
        D_delta_x_1*D_delta_x_12*k_C - D_delta_x_1*t269 - D_delta_x_1*t276 - D_delta_x_1*t277
        + D_delta_y_1*D_delta_y_12*k_C - D_delta_y_1*t271 - D_delta_y_1*t278 - D_delta_y_1*t279
        + D_delta_z_1*D_delta_z_12*k_C - D_delta_z_1*t272 - D_delta_z_1*t273 - D_delta_z_1*t275
    )
    K_wq_out[..., 8, 13] = (
        D_delta_x_12*D_delta_x_2*k_C - D_delta_x_2*t269 - D_delta_x_2*t276 - D_delta_x_2*t277
        + D_delta_y_12*D_delta_y_2*k_C - D_delta_y_2*t271 - D_delta_y_2*t278 - D_delta_y_2*t279
        + D_delta_z_12*D_delta_z_2*k_C - D_delta_z_2*t272 - D_delta_z_2*t273 - D_delta_z_2*t275
    )
    K_wq_out[..., 8, 14] = (
        D_delta_x_12*D_delta_x_3*k_C - D_delta_x_3*t269 - D_delta_x_3*t276 - D_delta_x_3*t277
        + D_delta_y_12*D_delta_y_3*k_C - D_delta_y_3*t271 - D_delta_y_3*t278 - D_delta_y_3*t279
        + D_delta_z_12*D_delta_z_3*k_C - D_delta_z_3*t272 - D_delta_z_3*t273 - D_delta_z_3*t275
    )
    K_wq_out[..., 8, 17] = t280 + t281
    K_wq_out[..., 8, 18] = D_delta_x_12*k_C
    K_wq_out[..., 8, 19] = D_delta_y_12*k_C
    K_wq_out[..., 8, 20] = D_delta_z_12*k_C
    K_wq_out[..., 9, 0] = -k_1_3
    K_wq_out[..., 9, 3] = R_p_1*k_1_3 - t282
    K_wq_out[..., 9, 6] = t282
    K_wq_out[..., 9, 15] = -k_1_3
    K_wq_out[..., 10, 0] = -k_1_2
    K_wq_out[..., 10, 3] = t282
    K_wq_out[..., 10, 6] = R_p_1*k_1_2 - t282
    K_wq_out[..., 10, 15] = -k_1_2
    K_wq_out[..., 11, 1] = -k_2_3
    K_wq_out[..., 11, 4] = R_p_2*k_2_3 - t283
    K_wq_out[..., 11, 7] = t283
    K_wq_out[..., 11, 16] = -k_2_3
    K_wq_out[..., 12, 1] = -k_2_2
    K_wq_out[..., 12, 4] = t283
    K_wq_out[..., 12, 7] = R_p_2*k_2_2 - t283
    K_wq_out[..., 12, 16] = -k_2_2
    K_wq_out[..., 13, 2] = -k_3_3
    K_wq_out[..., 13, 5] = R_p_3*k_3_3 - t284
    K_wq_out[..., 13, 8] = t284
    K_wq_out[..., 13, 17] = -k_3_3
    K_wq_out[..., 14, 2] = -k_3_2
    K_wq_out[..., 14, 5] = t284
    K_wq_out[..., 14, 8] = R_p_3*k_3_2 - t284
    K_wq_out[..., 14, 17] = -k_3_2
    K_ww_out = np.empty((*batch, 15), dtype)
    K_ww_out[..., 0] = (
        k_1_2*t125 + k_1_3*t125 + k_C*t123 + k_C*t124 + k_C*t285 - mu_1*t123 - mu_1*t124 - mu_1*t158**2
        - mu_2*t123 - mu_2*t124 - mu_2*t285 - mu_3*t123 - mu_3*t124 - mu_3*t285
    )
    K_ww_out[..., 1] = (
        k_1_2*t129 + k_1_3*t129 + k_C*t127 + k_C*t128 + k_C*t286 - mu_1*t127 - mu_1*t128 - mu_1*t173**2
        - mu_2*t127 - mu_2*t128 - mu_2*t286 - mu_3*t127 - mu_3*t128 - mu_3*t286
    )
    K_ww_out[..., 2] = (
        k_1_2*t132 + k_1_3*t132 + k_C*t130 + k_C*t131 + k_C*t287 - mu_1*t130 - mu_1*t131 - mu_1*t188**2
        - mu_2*t130 - mu_2*t131 - mu_2*t287 - mu_3*t130 - mu_3*t131 - mu_3*t287
    )
    K_ww_out[..., 3] = (
        k_2_2*t135 + k_2_3*t135 + k_C*t133 + k_C*t134 + k_C*t288 - mu_1*t133 - mu_1*t134 - mu_1*t288
        - mu_2*t133 - mu_2*t134 - mu_2*t204**2 - mu_3*t133 - mu_3*t134 - mu_3*t288
    )
    K_ww_out[..., 4] = (
        k_2_2*t139 + k_2_3*t139 + k_C*t137 + k_C*t138 + k_C*t289 - mu_1*t137 - mu_1*t138 - mu_1*t289
        - mu_2*t137 - mu_2*t138 - mu_2*t218**2 - mu_3*t137 - mu_3*t138 - mu_3*t289
    )
    K_ww_out[..., 5] = (
        k_2_2*t142 + k_2_3*t142 + k_C*t140 + k_C*t141 + k_C*t290 - mu_1*t140 - mu_1*t141 - mu_1*t290
        - mu_2*t140 - mu_2*t141 - mu_2*t232**2 - mu_3*t140 - mu_3*t141 - mu_3*t290
    )
    K_ww_out[..., 6] = (
        k_3_2*t145 + k_3_3*t145 + k_C*t143 + k_C*t144 + k_C*t291 - mu_1*t143 - mu_1*t144 - mu_1*t291
        - mu_2*t143 - mu_2*t144 - mu_2*t291 - mu_3*t143 - mu_3*t144 - mu_3*t246**2
    )
    K_ww_out[..., 7] = (
        k_3_2*t149 + k_3_3*t149 + k_C*t147 + k_C*t148 + k_C*t292 - mu_1*t147 - mu_1*t148 - mu_1*t292
        - mu_2*t147 - mu_2*t148 - mu_2*t292 - mu_3*t147 - mu_3*t148 - mu_3*t260**2
    )
    K_ww_out[..., 8] = (
        k_3_2*t152 + k_3_3*t152 + k_C*t150 + k_C*t151 + k_C*t293 - mu_1*t150 - mu_1*t151 - mu_1*t293
        - mu_2*t150 - mu_2*t151 - mu_2*t293 - mu_3*t150 - mu_3*t151 - mu_3*t274**2
    )
    K_ww_out[..., 9] = k_1_1 + k_1_3
    K_ww_out[..., 10] = k_1_1 + k_1_2
    K_ww_out[..., 11] = k_2_1 + k_2_3
    K_ww_out[..., 12] = k_2_1 + k_2_2
    K_ww_out[..., 13] = k_3_1 + k_3_3
    K_ww_out[..., 14] = k_3_1 + k_3_2
    J_p_out = np.zeros((*batch, 15, 3), dtype)
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


def mount_inertia(parameters):
    """Derivatives of the rows of M of the mounts with respect to the mass that moves with each.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M_wq : array, shape (..., 15, 21) [1]
        Of M_wq.
    M_ww : array, shape (..., 15) [1]
        Of M_ww.

    Notes
    -----
    The kinetic energy of a bearing that yields, of which the frame has the rest.
    0 operations; 0 with every named value expanded.
    """
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    batch, dtype = _batch(n_1_x)
    M_wq_out = np.zeros((*batch, 15, 21), dtype)
    M_wq_out[..., 9, 18] = n_1_x
    M_wq_out[..., 9, 19] = n_1_y
    M_wq_out[..., 9, 20] = n_1_z
    M_wq_out[..., 10, 18] = n_1_x
    M_wq_out[..., 10, 19] = n_1_y
    M_wq_out[..., 10, 20] = n_1_z
    M_wq_out[..., 11, 18] = n_2_x
    M_wq_out[..., 11, 19] = n_2_y
    M_wq_out[..., 11, 20] = n_2_z
    M_wq_out[..., 12, 18] = n_2_x
    M_wq_out[..., 12, 19] = n_2_y
    M_wq_out[..., 12, 20] = n_2_z
    M_wq_out[..., 13, 18] = n_3_x
    M_wq_out[..., 13, 19] = n_3_y
    M_wq_out[..., 13, 20] = n_3_z
    M_wq_out[..., 14, 18] = n_3_x
    M_wq_out[..., 14, 19] = n_3_y
    M_wq_out[..., 14, 20] = n_3_z
    M_ww_out = np.zeros((*batch, 15), dtype)
    M_ww_out[..., 9] = 1
    M_ww_out[..., 10] = 1
    M_ww_out[..., 11] = 1
    M_ww_out[..., 12] = 1
    M_ww_out[..., 13] = 1
    M_ww_out[..., 14] = 1
    return M_wq_out, M_ww_out
