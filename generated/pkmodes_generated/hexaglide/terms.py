# Generated from the derivation of hexaglide and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Terms of the mechanism hexaglide: motion of its bodies, and what holds them yielding.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; belt span s; component i = x, y,
z; rows r of a minor; columns c of a minor; axis a of the platform.  t1, t2, ... are subexpressions shared by
several values.

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
* l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* o_L_i [m]: payload from the platform's origin, base frame, component i
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
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* D_p_i_k [1/m]: platform Jacobian, dp_i/dx_k
* D_delta_i_k [1/m]: platform Jacobian, dp_i/ddelta_k
* G_p_i [N]: gradient of the gravitational potential energy with respect to the platform, component i
* G_p_i [N m]: gradient of the gravitational potential energy with respect to the platform, component i
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* g_j_i [N]: derivative of gravity and closures with respect to vector j that turns, component i
* L_i_a [N/m]: second derivative of gravity and closures with respect to the platform, entry i, a
* L_i_a [N]: second derivative of gravity and closures with respect to the platform, entry i, a
* L_i_a [N m]: second derivative of gravity and closures with respect to the platform, entry i, a
* f_i_k [N/m]: force on the platform along i per unit of coordinate k
* f_i_k [N]: force on the platform along i per unit of coordinate k
* M_p_i_a [kg]: apparent mass of the platform, entry i, a
* M_p_i_a [kg m]: apparent mass of the platform, entry i, a
* M_p_i_a [kg m^2]: apparent mass of the platform, entry i, a
* h_i_k [kg]: momentum of the platform along i per unit rate of coordinate k
* h_i_k [kg m]: momentum of the platform along i per unit rate of coordinate k
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
    "psi_1",
    "psi_2",
    "psi_3",
    "psi_4",
    "psi_5",
    "psi_6",
    "delta_1",
    "delta_2",
    "delta_3",
    "delta_4",
    "delta_5",
    "delta_6",
    "eps_1",
    "eps_2",
    "eps_3",
    "eps_4",
    "eps_5",
    "eps_6",
    "u_x",
    "u_y",
    "u_z",
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
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J : array, shape (..., 63, 39) [1, m]
        One row for each displacement.

    Notes
    -----
    The velocities of the bodies that the mechanism declares, without the mounts of terms.
    2654 operations; 3631426092 with every named value expanded.
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
    t13 = A_x_1*t12
    D_p_x_1 = D_r_1*t13
    t14 = A_x_2*t12
    D_p_x_2 = D_r_2*t14
    t15 = A_x_3*t12
    D_p_x_3 = D_r_3*t15
    t16 = A_x_4*t12
    D_p_x_4 = D_r_4*t16
    t17 = A_x_5*t12
    D_p_x_5 = D_r_5*t17
    t18 = A_x_6*t12
    D_p_x_6 = D_r_6*t18
    D_delta_x_1 = l_d_1*t13
    D_delta_x_2 = l_d_2*t14
    D_delta_x_3 = l_d_3*t15
    D_delta_x_4 = l_d_4*t16
    D_delta_x_5 = l_d_5*t17
    D_delta_x_6 = l_d_6*t18
    t19 = A_y_1*t12
    D_p_y_1 = D_r_1*t19
    t20 = A_y_2*t12
    D_p_y_2 = D_r_2*t20
    t21 = A_y_3*t12
    D_p_y_3 = D_r_3*t21
    t22 = A_y_4*t12
    D_p_y_4 = D_r_4*t22
    t23 = A_y_5*t12
    D_p_y_5 = D_r_5*t23
    t24 = A_y_6*t12
    D_p_y_6 = D_r_6*t24
    D_delta_y_1 = l_d_1*t19
    D_delta_y_2 = l_d_2*t20
    D_delta_y_3 = l_d_3*t21
    D_delta_y_4 = l_d_4*t22
    D_delta_y_5 = l_d_5*t23
    D_delta_y_6 = l_d_6*t24
    t25 = A_z_1*t12
    D_p_z_1 = D_r_1*t25
    t26 = A_z_2*t12
    D_p_z_2 = D_r_2*t26
    t27 = A_z_3*t12
    D_p_z_3 = D_r_3*t27
    t28 = A_z_4*t12
    D_p_z_4 = D_r_4*t28
    t29 = A_z_5*t12
    D_p_z_5 = D_r_5*t29
    t30 = A_z_6*t12
    D_p_z_6 = D_r_6*t30
    D_delta_z_1 = l_d_1*t25
    D_delta_z_2 = l_d_2*t26
    D_delta_z_3 = l_d_3*t27
    D_delta_z_4 = l_d_4*t28
    D_delta_z_5 = l_d_5*t29
    D_delta_z_6 = l_d_6*t30
    t31 = A_rx_1*t12
    D_p_rx_1 = D_r_1*t31
    t32 = A_rx_2*t12
    D_p_rx_2 = D_r_2*t32
    t33 = A_rx_3*t12
    D_p_rx_3 = D_r_3*t33
    t34 = A_rx_4*t12
    D_p_rx_4 = D_r_4*t34
    t35 = A_rx_5*t12
    D_p_rx_5 = D_r_5*t35
    t36 = A_rx_6*t12
    D_p_rx_6 = D_r_6*t36
    D_delta_rx_1 = l_d_1*t31
    D_delta_rx_2 = l_d_2*t32
    D_delta_rx_3 = l_d_3*t33
    D_delta_rx_4 = l_d_4*t34
    D_delta_rx_5 = l_d_5*t35
    D_delta_rx_6 = l_d_6*t36
    t37 = A_ry_1*t12
    D_p_ry_1 = D_r_1*t37
    t38 = A_ry_2*t12
    D_p_ry_2 = D_r_2*t38
    t39 = A_ry_3*t12
    D_p_ry_3 = D_r_3*t39
    t40 = A_ry_4*t12
    D_p_ry_4 = D_r_4*t40
    t41 = A_ry_5*t12
    D_p_ry_5 = D_r_5*t41
    t42 = A_ry_6*t12
    D_p_ry_6 = D_r_6*t42
    D_delta_ry_1 = l_d_1*t37
    D_delta_ry_2 = l_d_2*t38
    D_delta_ry_3 = l_d_3*t39
    D_delta_ry_4 = l_d_4*t40
    D_delta_ry_5 = l_d_5*t41
    D_delta_ry_6 = l_d_6*t42
    t43 = A_rz_1*t12
    D_p_rz_1 = D_r_1*t43
    t44 = A_rz_2*t12
    D_p_rz_2 = D_r_2*t44
    t45 = A_rz_3*t12
    D_p_rz_3 = D_r_3*t45
    t46 = A_rz_4*t12
    D_p_rz_4 = D_r_4*t46
    t47 = A_rz_5*t12
    D_p_rz_5 = D_r_5*t47
    t48 = A_rz_6*t12
    D_p_rz_6 = D_r_6*t48
    D_delta_rz_1 = l_d_1*t43
    D_delta_rz_2 = l_d_2*t44
    D_delta_rz_3 = l_d_3*t45
    D_delta_rz_4 = l_d_4*t46
    D_delta_rz_5 = l_d_5*t47
    D_delta_rz_6 = l_d_6*t48
    t49 = (1/2)*D_p_x_1
    t50 = (1/2)*B_1_y
    t51 = (1/2)*B_1_z
    t52 = (1/2)*D_p_x_2
    t53 = (1/2)*D_p_x_3
    t54 = (1/2)*D_p_x_4
    t55 = (1/2)*D_p_x_5
    t56 = (1/2)*D_p_x_6
    t57 = (1/2)*D_delta_x_1
    t58 = (1/2)*D_delta_x_2
    t59 = (1/2)*D_delta_x_3
    t60 = (1/2)*D_delta_x_4
    t61 = (1/2)*D_delta_x_5
    t62 = (1/2)*D_delta_x_6
    t63 = (1/2)*D_p_y_1
    t64 = (1/2)*B_1_x
    t65 = (1/2)*D_p_y_2
    t66 = (1/2)*D_p_y_3
    t67 = (1/2)*D_p_y_4
    t68 = (1/2)*D_p_y_5
    t69 = (1/2)*D_p_y_6
    t70 = (1/2)*D_delta_y_1
    t71 = (1/2)*D_delta_y_2
    t72 = (1/2)*D_delta_y_3
    t73 = (1/2)*D_delta_y_4
    t74 = (1/2)*D_delta_y_5
    t75 = (1/2)*D_delta_y_6
    t76 = (1/2)*D_p_z_1
    t77 = (1/2)*D_p_z_2
    t78 = (1/2)*D_p_z_3
    t79 = (1/2)*D_p_z_4
    t80 = (1/2)*D_p_z_5
    t81 = (1/2)*D_p_z_6
    t82 = (1/2)*D_delta_z_1
    t83 = (1/2)*D_delta_z_2
    t84 = (1/2)*D_delta_z_3
    t85 = (1/2)*D_delta_z_4
    t86 = (1/2)*D_delta_z_5
    t87 = (1/2)*D_delta_z_6
    t88 = (1/2)*B_2_y
    t89 = (1/2)*B_2_z
    t90 = (1/2)*B_2_x
    t91 = (1/2)*B_3_y
    t92 = (1/2)*B_3_z
    t93 = (1/2)*B_3_x
    t94 = (1/2)*B_4_y
    t95 = (1/2)*B_4_z
    t96 = (1/2)*B_4_x
    t97 = (1/2)*B_5_y
    t98 = (1/2)*B_5_z
    t99 = (1/2)*B_5_x
    t100 = (1/2)*B_6_y
    t101 = (1/2)*B_6_z
    t102 = (1/2)*B_6_x
    J_out = np.zeros((*batch, 63, 39), dtype)
    J_out[..., 0, 0] = D_p_x_1
    J_out[..., 0, 1] = D_p_x_2
    J_out[..., 0, 2] = D_p_x_3
    J_out[..., 0, 3] = D_p_x_4
    J_out[..., 0, 4] = D_p_x_5
    J_out[..., 0, 5] = D_p_x_6
    J_out[..., 0, 24] = D_delta_x_1
    J_out[..., 0, 25] = D_delta_x_2
    J_out[..., 0, 26] = D_delta_x_3
    J_out[..., 0, 27] = D_delta_x_4
    J_out[..., 0, 28] = D_delta_x_5
    J_out[..., 0, 29] = D_delta_x_6
    J_out[..., 0, 36] = 1
    J_out[..., 1, 0] = D_p_y_1
    J_out[..., 1, 1] = D_p_y_2
    J_out[..., 1, 2] = D_p_y_3
    J_out[..., 1, 3] = D_p_y_4
    J_out[..., 1, 4] = D_p_y_5
    J_out[..., 1, 5] = D_p_y_6
    J_out[..., 1, 24] = D_delta_y_1
    J_out[..., 1, 25] = D_delta_y_2
    J_out[..., 1, 26] = D_delta_y_3
    J_out[..., 1, 27] = D_delta_y_4
    J_out[..., 1, 28] = D_delta_y_5
    J_out[..., 1, 29] = D_delta_y_6
    J_out[..., 1, 37] = 1
    J_out[..., 2, 0] = D_p_z_1
    J_out[..., 2, 1] = D_p_z_2
    J_out[..., 2, 2] = D_p_z_3
    J_out[..., 2, 3] = D_p_z_4
    J_out[..., 2, 4] = D_p_z_5
    J_out[..., 2, 5] = D_p_z_6
    J_out[..., 2, 24] = D_delta_z_1
    J_out[..., 2, 25] = D_delta_z_2
    J_out[..., 2, 26] = D_delta_z_3
    J_out[..., 2, 27] = D_delta_z_4
    J_out[..., 2, 28] = D_delta_z_5
    J_out[..., 2, 29] = D_delta_z_6
    J_out[..., 2, 38] = 1
    J_out[..., 3, 0] = n_1_x
    J_out[..., 3, 36] = 1
    J_out[..., 4, 0] = n_1_y
    J_out[..., 4, 37] = 1
    J_out[..., 5, 0] = n_1_z
    J_out[..., 5, 38] = 1
    J_out[..., 6, 1] = n_2_x
    J_out[..., 6, 36] = 1
    J_out[..., 7, 1] = n_2_y
    J_out[..., 7, 37] = 1
    J_out[..., 8, 1] = n_2_z
    J_out[..., 8, 38] = 1
    J_out[..., 9, 2] = n_3_x
    J_out[..., 9, 36] = 1
    J_out[..., 10, 2] = n_3_y
    J_out[..., 10, 37] = 1
    J_out[..., 11, 2] = n_3_z
    J_out[..., 11, 38] = 1
    J_out[..., 12, 3] = n_4_x
    J_out[..., 12, 36] = 1
    J_out[..., 13, 3] = n_4_y
    J_out[..., 13, 37] = 1
    J_out[..., 14, 3] = n_4_z
    J_out[..., 14, 38] = 1
    J_out[..., 15, 4] = n_5_x
    J_out[..., 15, 36] = 1
    J_out[..., 16, 4] = n_5_y
    J_out[..., 16, 37] = 1
    J_out[..., 17, 4] = n_5_z
    J_out[..., 17, 38] = 1
    J_out[..., 18, 5] = n_6_x
    J_out[..., 18, 36] = 1
    J_out[..., 19, 5] = n_6_y
    J_out[..., 19, 37] = 1
    J_out[..., 20, 5] = n_6_z
    J_out[..., 20, 38] = 1
    J_out[..., 21, 6] = 1
    J_out[..., 22, 12] = 1
    J_out[..., 23, 7] = 1
    J_out[..., 24, 13] = 1
    J_out[..., 25, 8] = 1
    J_out[..., 26, 14] = 1
    J_out[..., 27, 9] = 1
    J_out[..., 28, 15] = 1
    J_out[..., 29, 10] = 1
    J_out[..., 30, 16] = 1
    J_out[..., 31, 11] = 1
    J_out[..., 32, 17] = 1
    J_out[..., 33, 36] = 1
    J_out[..., 34, 37] = 1
    J_out[..., 35, 38] = 1
    J_out[..., 36, 0] = D_p_rx_1
    J_out[..., 36, 1] = D_p_rx_2
    J_out[..., 36, 2] = D_p_rx_3
    J_out[..., 36, 3] = D_p_rx_4
    J_out[..., 36, 4] = D_p_rx_5
    J_out[..., 36, 5] = D_p_rx_6
    J_out[..., 36, 24] = D_delta_rx_1
    J_out[..., 36, 25] = D_delta_rx_2
    J_out[..., 36, 26] = D_delta_rx_3
    J_out[..., 36, 27] = D_delta_rx_4
    J_out[..., 36, 28] = D_delta_rx_5
    J_out[..., 36, 29] = D_delta_rx_6
    J_out[..., 37, 0] = D_p_ry_1
    J_out[..., 37, 1] = D_p_ry_2
    J_out[..., 37, 2] = D_p_ry_3
    J_out[..., 37, 3] = D_p_ry_4
    J_out[..., 37, 4] = D_p_ry_5
    J_out[..., 37, 5] = D_p_ry_6
    J_out[..., 37, 24] = D_delta_ry_1
    J_out[..., 37, 25] = D_delta_ry_2
    J_out[..., 37, 26] = D_delta_ry_3
    J_out[..., 37, 27] = D_delta_ry_4
    J_out[..., 37, 28] = D_delta_ry_5
    J_out[..., 37, 29] = D_delta_ry_6
    J_out[..., 38, 0] = D_p_rz_1
    J_out[..., 38, 1] = D_p_rz_2
    J_out[..., 38, 2] = D_p_rz_3
    J_out[..., 38, 3] = D_p_rz_4
    J_out[..., 38, 4] = D_p_rz_5
    J_out[..., 38, 5] = D_p_rz_6
    J_out[..., 38, 24] = D_delta_rz_1
    J_out[..., 38, 25] = D_delta_rz_2
    J_out[..., 38, 26] = D_delta_rz_3
    J_out[..., 38, 27] = D_delta_rz_4
    J_out[..., 38, 28] = D_delta_rz_5
    J_out[..., 38, 29] = D_delta_rz_6
    J_out[..., 39, 0] = 1
    J_out[..., 39, 36] = n_1_x
    J_out[..., 39, 37] = n_1_y
    J_out[..., 39, 38] = n_1_z
    J_out[..., 40, 1] = 1
    J_out[..., 40, 36] = n_2_x
    J_out[..., 40, 37] = n_2_y
    J_out[..., 40, 38] = n_2_z
    J_out[..., 41, 2] = 1
    J_out[..., 41, 36] = n_3_x
    J_out[..., 41, 37] = n_3_y
    J_out[..., 41, 38] = n_3_z
    J_out[..., 42, 3] = 1
    J_out[..., 42, 36] = n_4_x
    J_out[..., 42, 37] = n_4_y
    J_out[..., 42, 38] = n_4_z
    J_out[..., 43, 4] = 1
    J_out[..., 43, 36] = n_5_x
    J_out[..., 43, 37] = n_5_y
    J_out[..., 43, 38] = n_5_z
    J_out[..., 44, 5] = 1
    J_out[..., 44, 36] = n_6_x
    J_out[..., 44, 37] = n_6_y
    J_out[..., 44, 38] = n_6_z
    J_out[..., 45, 0] = D_p_ry_1*t51 - D_p_rz_1*t50 + (1/2)*n_1_x + t49
    J_out[..., 45, 1] = D_p_ry_2*t51 - D_p_rz_2*t50 + t52
    J_out[..., 45, 2] = D_p_ry_3*t51 - D_p_rz_3*t50 + t53
    J_out[..., 45, 3] = D_p_ry_4*t51 - D_p_rz_4*t50 + t54
    J_out[..., 45, 4] = D_p_ry_5*t51 - D_p_rz_5*t50 + t55
    J_out[..., 45, 5] = D_p_ry_6*t51 - D_p_rz_6*t50 + t56
    J_out[..., 45, 24] = D_delta_ry_1*t51 - D_delta_rz_1*t50 + t57
    J_out[..., 45, 25] = D_delta_ry_2*t51 - D_delta_rz_2*t50 + t58
    J_out[..., 45, 26] = D_delta_ry_3*t51 - D_delta_rz_3*t50 + t59
    J_out[..., 45, 27] = D_delta_ry_4*t51 - D_delta_rz_4*t50 + t60
    J_out[..., 45, 28] = D_delta_ry_5*t51 - D_delta_rz_5*t50 + t61
    J_out[..., 45, 29] = D_delta_ry_6*t51 - D_delta_rz_6*t50 + t62
    J_out[..., 45, 36] = 1
    J_out[..., 46, 0] = -D_p_rx_1*t51 + D_p_rz_1*t64 + (1/2)*n_1_y + t63
    J_out[..., 46, 1] = -D_p_rx_2*t51 + D_p_rz_2*t64 + t65
    J_out[..., 46, 2] = -D_p_rx_3*t51 + D_p_rz_3*t64 + t66
    J_out[..., 46, 3] = -D_p_rx_4*t51 + D_p_rz_4*t64 + t67
    J_out[..., 46, 4] = -D_p_rx_5*t51 + D_p_rz_5*t64 + t68
    J_out[..., 46, 5] = -D_p_rx_6*t51 + D_p_rz_6*t64 + t69
    J_out[..., 46, 24] = -D_delta_rx_1*t51 + D_delta_rz_1*t64 + t70
    J_out[..., 46, 25] = -D_delta_rx_2*t51 + D_delta_rz_2*t64 + t71
    J_out[..., 46, 26] = -D_delta_rx_3*t51 + D_delta_rz_3*t64 + t72
    J_out[..., 46, 27] = -D_delta_rx_4*t51 + D_delta_rz_4*t64 + t73
    J_out[..., 46, 28] = -D_delta_rx_5*t51 + D_delta_rz_5*t64 + t74
    J_out[..., 46, 29] = -D_delta_rx_6*t51 + D_delta_rz_6*t64 + t75
    J_out[..., 46, 37] = 1
    J_out[..., 47, 0] = D_p_rx_1*t50 - D_p_ry_1*t64 + (1/2)*n_1_z + t76
    J_out[..., 47, 1] = D_p_rx_2*t50 - D_p_ry_2*t64 + t77
    J_out[..., 47, 2] = D_p_rx_3*t50 - D_p_ry_3*t64 + t78
    J_out[..., 47, 3] = D_p_rx_4*t50 - D_p_ry_4*t64 + t79
    J_out[..., 47, 4] = D_p_rx_5*t50 - D_p_ry_5*t64 + t80
    J_out[..., 47, 5] = D_p_rx_6*t50 - D_p_ry_6*t64 + t81
    J_out[..., 47, 24] = D_delta_rx_1*t50 - D_delta_ry_1*t64 + t82
    J_out[..., 47, 25] = D_delta_rx_2*t50 - D_delta_ry_2*t64 + t83
    J_out[..., 47, 26] = D_delta_rx_3*t50 - D_delta_ry_3*t64 + t84
    J_out[..., 47, 27] = D_delta_rx_4*t50 - D_delta_ry_4*t64 + t85
    J_out[..., 47, 28] = D_delta_rx_5*t50 - D_delta_ry_5*t64 + t86
    J_out[..., 47, 29] = D_delta_rx_6*t50 - D_delta_ry_6*t64 + t87
    J_out[..., 47, 38] = 1
    J_out[..., 48, 0] = D_p_ry_1*t89 - D_p_rz_1*t88 + t49
    J_out[..., 48, 1] = D_p_ry_2*t89 - D_p_rz_2*t88 + (1/2)*n_2_x + t52
    J_out[..., 48, 2] = D_p_ry_3*t89 - D_p_rz_3*t88 + t53
    J_out[..., 48, 3] = D_p_ry_4*t89 - D_p_rz_4*t88 + t54
    J_out[..., 48, 4] = D_p_ry_5*t89 - D_p_rz_5*t88 + t55
    J_out[..., 48, 5] = D_p_ry_6*t89 - D_p_rz_6*t88 + t56
    J_out[..., 48, 24] = D_delta_ry_1*t89 - D_delta_rz_1*t88 + t57
    J_out[..., 48, 25] = D_delta_ry_2*t89 - D_delta_rz_2*t88 + t58
    J_out[..., 48, 26] = D_delta_ry_3*t89 - D_delta_rz_3*t88 + t59
    J_out[..., 48, 27] = D_delta_ry_4*t89 - D_delta_rz_4*t88 + t60
    J_out[..., 48, 28] = D_delta_ry_5*t89 - D_delta_rz_5*t88 + t61
    J_out[..., 48, 29] = D_delta_ry_6*t89 - D_delta_rz_6*t88 + t62
    J_out[..., 48, 36] = 1
    J_out[..., 49, 0] = -D_p_rx_1*t89 + D_p_rz_1*t90 + t63
    J_out[..., 49, 1] = -D_p_rx_2*t89 + D_p_rz_2*t90 + (1/2)*n_2_y + t65
    J_out[..., 49, 2] = -D_p_rx_3*t89 + D_p_rz_3*t90 + t66
    J_out[..., 49, 3] = -D_p_rx_4*t89 + D_p_rz_4*t90 + t67
    J_out[..., 49, 4] = -D_p_rx_5*t89 + D_p_rz_5*t90 + t68
    J_out[..., 49, 5] = -D_p_rx_6*t89 + D_p_rz_6*t90 + t69
    J_out[..., 49, 24] = -D_delta_rx_1*t89 + D_delta_rz_1*t90 + t70
    J_out[..., 49, 25] = -D_delta_rx_2*t89 + D_delta_rz_2*t90 + t71
    J_out[..., 49, 26] = -D_delta_rx_3*t89 + D_delta_rz_3*t90 + t72
    J_out[..., 49, 27] = -D_delta_rx_4*t89 + D_delta_rz_4*t90 + t73
    J_out[..., 49, 28] = -D_delta_rx_5*t89 + D_delta_rz_5*t90 + t74
    J_out[..., 49, 29] = -D_delta_rx_6*t89 + D_delta_rz_6*t90 + t75
    J_out[..., 49, 37] = 1
    J_out[..., 50, 0] = D_p_rx_1*t88 - D_p_ry_1*t90 + t76
    J_out[..., 50, 1] = D_p_rx_2*t88 - D_p_ry_2*t90 + (1/2)*n_2_z + t77
    J_out[..., 50, 2] = D_p_rx_3*t88 - D_p_ry_3*t90 + t78
    J_out[..., 50, 3] = D_p_rx_4*t88 - D_p_ry_4*t90 + t79
    J_out[..., 50, 4] = D_p_rx_5*t88 - D_p_ry_5*t90 + t80
    J_out[..., 50, 5] = D_p_rx_6*t88 - D_p_ry_6*t90 + t81
    J_out[..., 50, 24] = D_delta_rx_1*t88 - D_delta_ry_1*t90 + t82
    J_out[..., 50, 25] = D_delta_rx_2*t88 - D_delta_ry_2*t90 + t83
    J_out[..., 50, 26] = D_delta_rx_3*t88 - D_delta_ry_3*t90 + t84
    J_out[..., 50, 27] = D_delta_rx_4*t88 - D_delta_ry_4*t90 + t85
    J_out[..., 50, 28] = D_delta_rx_5*t88 - D_delta_ry_5*t90 + t86
    J_out[..., 50, 29] = D_delta_rx_6*t88 - D_delta_ry_6*t90 + t87
    J_out[..., 50, 38] = 1
    J_out[..., 51, 0] = D_p_ry_1*t92 - D_p_rz_1*t91 + t49
    J_out[..., 51, 1] = D_p_ry_2*t92 - D_p_rz_2*t91 + t52
    J_out[..., 51, 2] = D_p_ry_3*t92 - D_p_rz_3*t91 + (1/2)*n_3_x + t53
    J_out[..., 51, 3] = D_p_ry_4*t92 - D_p_rz_4*t91 + t54
    J_out[..., 51, 4] = D_p_ry_5*t92 - D_p_rz_5*t91 + t55
    J_out[..., 51, 5] = D_p_ry_6*t92 - D_p_rz_6*t91 + t56
    J_out[..., 51, 24] = D_delta_ry_1*t92 - D_delta_rz_1*t91 + t57
    J_out[..., 51, 25] = D_delta_ry_2*t92 - D_delta_rz_2*t91 + t58
    J_out[..., 51, 26] = D_delta_ry_3*t92 - D_delta_rz_3*t91 + t59
    J_out[..., 51, 27] = D_delta_ry_4*t92 - D_delta_rz_4*t91 + t60
    J_out[..., 51, 28] = D_delta_ry_5*t92 - D_delta_rz_5*t91 + t61
    J_out[..., 51, 29] = D_delta_ry_6*t92 - D_delta_rz_6*t91 + t62
    J_out[..., 51, 36] = 1
    J_out[..., 52, 0] = -D_p_rx_1*t92 + D_p_rz_1*t93 + t63
    J_out[..., 52, 1] = -D_p_rx_2*t92 + D_p_rz_2*t93 + t65
    J_out[..., 52, 2] = -D_p_rx_3*t92 + D_p_rz_3*t93 + (1/2)*n_3_y + t66
    J_out[..., 52, 3] = -D_p_rx_4*t92 + D_p_rz_4*t93 + t67
    J_out[..., 52, 4] = -D_p_rx_5*t92 + D_p_rz_5*t93 + t68
    J_out[..., 52, 5] = -D_p_rx_6*t92 + D_p_rz_6*t93 + t69
    J_out[..., 52, 24] = -D_delta_rx_1*t92 + D_delta_rz_1*t93 + t70
    J_out[..., 52, 25] = -D_delta_rx_2*t92 + D_delta_rz_2*t93 + t71
    J_out[..., 52, 26] = -D_delta_rx_3*t92 + D_delta_rz_3*t93 + t72
    J_out[..., 52, 27] = -D_delta_rx_4*t92 + D_delta_rz_4*t93 + t73
    J_out[..., 52, 28] = -D_delta_rx_5*t92 + D_delta_rz_5*t93 + t74
    J_out[..., 52, 29] = -D_delta_rx_6*t92 + D_delta_rz_6*t93 + t75
    J_out[..., 52, 37] = 1
    J_out[..., 53, 0] = D_p_rx_1*t91 - D_p_ry_1*t93 + t76
    J_out[..., 53, 1] = D_p_rx_2*t91 - D_p_ry_2*t93 + t77
    J_out[..., 53, 2] = D_p_rx_3*t91 - D_p_ry_3*t93 + (1/2)*n_3_z + t78
    J_out[..., 53, 3] = D_p_rx_4*t91 - D_p_ry_4*t93 + t79
    J_out[..., 53, 4] = D_p_rx_5*t91 - D_p_ry_5*t93 + t80
    J_out[..., 53, 5] = D_p_rx_6*t91 - D_p_ry_6*t93 + t81
    J_out[..., 53, 24] = D_delta_rx_1*t91 - D_delta_ry_1*t93 + t82
    J_out[..., 53, 25] = D_delta_rx_2*t91 - D_delta_ry_2*t93 + t83
    J_out[..., 53, 26] = D_delta_rx_3*t91 - D_delta_ry_3*t93 + t84
    J_out[..., 53, 27] = D_delta_rx_4*t91 - D_delta_ry_4*t93 + t85
    J_out[..., 53, 28] = D_delta_rx_5*t91 - D_delta_ry_5*t93 + t86
    J_out[..., 53, 29] = D_delta_rx_6*t91 - D_delta_ry_6*t93 + t87
    J_out[..., 53, 38] = 1
    J_out[..., 54, 0] = D_p_ry_1*t95 - D_p_rz_1*t94 + t49
    J_out[..., 54, 1] = D_p_ry_2*t95 - D_p_rz_2*t94 + t52
    J_out[..., 54, 2] = D_p_ry_3*t95 - D_p_rz_3*t94 + t53
    J_out[..., 54, 3] = D_p_ry_4*t95 - D_p_rz_4*t94 + (1/2)*n_4_x + t54
    J_out[..., 54, 4] = D_p_ry_5*t95 - D_p_rz_5*t94 + t55
    J_out[..., 54, 5] = D_p_ry_6*t95 - D_p_rz_6*t94 + t56
    J_out[..., 54, 24] = D_delta_ry_1*t95 - D_delta_rz_1*t94 + t57
    J_out[..., 54, 25] = D_delta_ry_2*t95 - D_delta_rz_2*t94 + t58
    J_out[..., 54, 26] = D_delta_ry_3*t95 - D_delta_rz_3*t94 + t59
    J_out[..., 54, 27] = D_delta_ry_4*t95 - D_delta_rz_4*t94 + t60
    J_out[..., 54, 28] = D_delta_ry_5*t95 - D_delta_rz_5*t94 + t61
    J_out[..., 54, 29] = D_delta_ry_6*t95 - D_delta_rz_6*t94 + t62
    J_out[..., 54, 36] = 1
    J_out[..., 55, 0] = -D_p_rx_1*t95 + D_p_rz_1*t96 + t63
    J_out[..., 55, 1] = -D_p_rx_2*t95 + D_p_rz_2*t96 + t65
    J_out[..., 55, 2] = -D_p_rx_3*t95 + D_p_rz_3*t96 + t66
    J_out[..., 55, 3] = -D_p_rx_4*t95 + D_p_rz_4*t96 + (1/2)*n_4_y + t67
    J_out[..., 55, 4] = -D_p_rx_5*t95 + D_p_rz_5*t96 + t68
    J_out[..., 55, 5] = -D_p_rx_6*t95 + D_p_rz_6*t96 + t69
    J_out[..., 55, 24] = -D_delta_rx_1*t95 + D_delta_rz_1*t96 + t70
    J_out[..., 55, 25] = -D_delta_rx_2*t95 + D_delta_rz_2*t96 + t71
    J_out[..., 55, 26] = -D_delta_rx_3*t95 + D_delta_rz_3*t96 + t72
    J_out[..., 55, 27] = -D_delta_rx_4*t95 + D_delta_rz_4*t96 + t73
    J_out[..., 55, 28] = -D_delta_rx_5*t95 + D_delta_rz_5*t96 + t74
    J_out[..., 55, 29] = -D_delta_rx_6*t95 + D_delta_rz_6*t96 + t75
    J_out[..., 55, 37] = 1
    J_out[..., 56, 0] = D_p_rx_1*t94 - D_p_ry_1*t96 + t76
    J_out[..., 56, 1] = D_p_rx_2*t94 - D_p_ry_2*t96 + t77
    J_out[..., 56, 2] = D_p_rx_3*t94 - D_p_ry_3*t96 + t78
    J_out[..., 56, 3] = D_p_rx_4*t94 - D_p_ry_4*t96 + (1/2)*n_4_z + t79
    J_out[..., 56, 4] = D_p_rx_5*t94 - D_p_ry_5*t96 + t80
    J_out[..., 56, 5] = D_p_rx_6*t94 - D_p_ry_6*t96 + t81
    J_out[..., 56, 24] = D_delta_rx_1*t94 - D_delta_ry_1*t96 + t82
    J_out[..., 56, 25] = D_delta_rx_2*t94 - D_delta_ry_2*t96 + t83
    J_out[..., 56, 26] = D_delta_rx_3*t94 - D_delta_ry_3*t96 + t84
    J_out[..., 56, 27] = D_delta_rx_4*t94 - D_delta_ry_4*t96 + t85
    J_out[..., 56, 28] = D_delta_rx_5*t94 - D_delta_ry_5*t96 + t86
    J_out[..., 56, 29] = D_delta_rx_6*t94 - D_delta_ry_6*t96 + t87
    J_out[..., 56, 38] = 1
    J_out[..., 57, 0] = D_p_ry_1*t98 - D_p_rz_1*t97 + t49
    J_out[..., 57, 1] = D_p_ry_2*t98 - D_p_rz_2*t97 + t52
    J_out[..., 57, 2] = D_p_ry_3*t98 - D_p_rz_3*t97 + t53
    J_out[..., 57, 3] = D_p_ry_4*t98 - D_p_rz_4*t97 + t54
    J_out[..., 57, 4] = D_p_ry_5*t98 - D_p_rz_5*t97 + (1/2)*n_5_x + t55
    J_out[..., 57, 5] = D_p_ry_6*t98 - D_p_rz_6*t97 + t56
    J_out[..., 57, 24] = D_delta_ry_1*t98 - D_delta_rz_1*t97 + t57
    J_out[..., 57, 25] = D_delta_ry_2*t98 - D_delta_rz_2*t97 + t58
    J_out[..., 57, 26] = D_delta_ry_3*t98 - D_delta_rz_3*t97 + t59
    J_out[..., 57, 27] = D_delta_ry_4*t98 - D_delta_rz_4*t97 + t60
    J_out[..., 57, 28] = D_delta_ry_5*t98 - D_delta_rz_5*t97 + t61
    J_out[..., 57, 29] = D_delta_ry_6*t98 - D_delta_rz_6*t97 + t62
    J_out[..., 57, 36] = 1
    J_out[..., 58, 0] = -D_p_rx_1*t98 + D_p_rz_1*t99 + t63
    J_out[..., 58, 1] = -D_p_rx_2*t98 + D_p_rz_2*t99 + t65
    J_out[..., 58, 2] = -D_p_rx_3*t98 + D_p_rz_3*t99 + t66
    J_out[..., 58, 3] = -D_p_rx_4*t98 + D_p_rz_4*t99 + t67
    J_out[..., 58, 4] = -D_p_rx_5*t98 + D_p_rz_5*t99 + (1/2)*n_5_y + t68
    J_out[..., 58, 5] = -D_p_rx_6*t98 + D_p_rz_6*t99 + t69
    J_out[..., 58, 24] = -D_delta_rx_1*t98 + D_delta_rz_1*t99 + t70
    J_out[..., 58, 25] = -D_delta_rx_2*t98 + D_delta_rz_2*t99 + t71
    J_out[..., 58, 26] = -D_delta_rx_3*t98 + D_delta_rz_3*t99 + t72
    J_out[..., 58, 27] = -D_delta_rx_4*t98 + D_delta_rz_4*t99 + t73
    J_out[..., 58, 28] = -D_delta_rx_5*t98 + D_delta_rz_5*t99 + t74
    J_out[..., 58, 29] = -D_delta_rx_6*t98 + D_delta_rz_6*t99 + t75
    J_out[..., 58, 37] = 1
    J_out[..., 59, 0] = D_p_rx_1*t97 - D_p_ry_1*t99 + t76
    J_out[..., 59, 1] = D_p_rx_2*t97 - D_p_ry_2*t99 + t77
    J_out[..., 59, 2] = D_p_rx_3*t97 - D_p_ry_3*t99 + t78
    J_out[..., 59, 3] = D_p_rx_4*t97 - D_p_ry_4*t99 + t79
    J_out[..., 59, 4] = D_p_rx_5*t97 - D_p_ry_5*t99 + (1/2)*n_5_z + t80
    J_out[..., 59, 5] = D_p_rx_6*t97 - D_p_ry_6*t99 + t81
    J_out[..., 59, 24] = D_delta_rx_1*t97 - D_delta_ry_1*t99 + t82
    J_out[..., 59, 25] = D_delta_rx_2*t97 - D_delta_ry_2*t99 + t83
    J_out[..., 59, 26] = D_delta_rx_3*t97 - D_delta_ry_3*t99 + t84
    J_out[..., 59, 27] = D_delta_rx_4*t97 - D_delta_ry_4*t99 + t85
    J_out[..., 59, 28] = D_delta_rx_5*t97 - D_delta_ry_5*t99 + t86
    J_out[..., 59, 29] = D_delta_rx_6*t97 - D_delta_ry_6*t99 + t87
    J_out[..., 59, 38] = 1
    J_out[..., 60, 0] = D_p_ry_1*t101 - D_p_rz_1*t100 + t49
    J_out[..., 60, 1] = D_p_ry_2*t101 - D_p_rz_2*t100 + t52
    J_out[..., 60, 2] = D_p_ry_3*t101 - D_p_rz_3*t100 + t53
    J_out[..., 60, 3] = D_p_ry_4*t101 - D_p_rz_4*t100 + t54
    J_out[..., 60, 4] = D_p_ry_5*t101 - D_p_rz_5*t100 + t55
    J_out[..., 60, 5] = D_p_ry_6*t101 - D_p_rz_6*t100 + (1/2)*n_6_x + t56
    J_out[..., 60, 24] = D_delta_ry_1*t101 - D_delta_rz_1*t100 + t57
    J_out[..., 60, 25] = D_delta_ry_2*t101 - D_delta_rz_2*t100 + t58
    J_out[..., 60, 26] = D_delta_ry_3*t101 - D_delta_rz_3*t100 + t59
    J_out[..., 60, 27] = D_delta_ry_4*t101 - D_delta_rz_4*t100 + t60
    J_out[..., 60, 28] = D_delta_ry_5*t101 - D_delta_rz_5*t100 + t61
    J_out[..., 60, 29] = D_delta_ry_6*t101 - D_delta_rz_6*t100 + t62
    J_out[..., 60, 36] = 1
    J_out[..., 61, 0] = -D_p_rx_1*t101 + D_p_rz_1*t102 + t63
    J_out[..., 61, 1] = -D_p_rx_2*t101 + D_p_rz_2*t102 + t65
    J_out[..., 61, 2] = -D_p_rx_3*t101 + D_p_rz_3*t102 + t66
    J_out[..., 61, 3] = -D_p_rx_4*t101 + D_p_rz_4*t102 + t67
    J_out[..., 61, 4] = -D_p_rx_5*t101 + D_p_rz_5*t102 + t68
    J_out[..., 61, 5] = -D_p_rx_6*t101 + D_p_rz_6*t102 + (1/2)*n_6_y + t69
    J_out[..., 61, 24] = -D_delta_rx_1*t101 + D_delta_rz_1*t102 + t70
    J_out[..., 61, 25] = -D_delta_rx_2*t101 + D_delta_rz_2*t102 + t71
    J_out[..., 61, 26] = -D_delta_rx_3*t101 + D_delta_rz_3*t102 + t72
    J_out[..., 61, 27] = -D_delta_rx_4*t101 + D_delta_rz_4*t102 + t73
    J_out[..., 61, 28] = -D_delta_rx_5*t101 + D_delta_rz_5*t102 + t74
    J_out[..., 61, 29] = -D_delta_rx_6*t101 + D_delta_rz_6*t102 + t75
    J_out[..., 61, 37] = 1
    J_out[..., 62, 0] = D_p_rx_1*t100 - D_p_ry_1*t102 + t76
    J_out[..., 62, 1] = D_p_rx_2*t100 - D_p_ry_2*t102 + t77
    J_out[..., 62, 2] = D_p_rx_3*t100 - D_p_ry_3*t102 + t78
    J_out[..., 62, 3] = D_p_rx_4*t100 - D_p_ry_4*t102 + t79
    J_out[..., 62, 4] = D_p_rx_5*t100 - D_p_ry_5*t102 + t80
    J_out[..., 62, 5] = D_p_rx_6*t100 - D_p_ry_6*t102 + (1/2)*n_6_z + t81
    J_out[..., 62, 24] = D_delta_rx_1*t100 - D_delta_ry_1*t102 + t82
    J_out[..., 62, 25] = D_delta_rx_2*t100 - D_delta_ry_2*t102 + t83
    J_out[..., 62, 26] = D_delta_rx_3*t100 - D_delta_ry_3*t102 + t84
    J_out[..., 62, 27] = D_delta_rx_4*t100 - D_delta_ry_4*t102 + t85
    J_out[..., 62, 28] = D_delta_rx_5*t100 - D_delta_ry_5*t102 + t86
    J_out[..., 62, 29] = D_delta_rx_6*t100 - D_delta_ry_6*t102 + t87
    J_out[..., 62, 38] = 1
    return J_out


def mount_matrices(p, parameters, effects):
    """Rows of M and K of what holds a body, where it yields alone.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.
    effects : Effects
        The robot's effects.

    Returns
    -------
    M_wq : array, shape (..., 30, 39) [kg, kg m]
        Entries of M between each mount and every coordinate.
    M_ww : array, shape (..., 30) [kg, kg m]
        Diagonal entry of M of each mount.
    K_wq : array, shape (..., 30, 39) [N/m, N]
        Entries of K between each mount and every coordinate.
    K_ww : array, shape (..., 30) [N/m, N]
        Diagonal entry of K of each mount.
    J_p : array, shape (..., 30, 6) [1, 1/m]
        Motion of the platform per unit of each mount.

    Notes
    -----
    Equations 24 to 48 with these displacements released; without the springs of the mounts.
    15264 operations; 649660801920 with every named value expanded.
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
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (a_B_3,) = _entries(effects.axis_belt_stiffness_factor_3, ())
    (a_B_4,) = _entries(effects.axis_belt_stiffness_factor_4, ())
    (a_B_5,) = _entries(effects.axis_belt_stiffness_factor_5, ())
    (a_B_6,) = _entries(effects.axis_belt_stiffness_factor_6, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    (b_L_x,) = _entries(effects.payload_offset_x, ())
    (b_L_y,) = _entries(effects.payload_offset_y, ())
    (b_L_z,) = _entries(effects.payload_offset_z, ())
    batch, dtype = _batch(p_x, m_p, c_p_x, I_p_x, I_p_xy, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1,
        l_t_1, k_sp_1, w_b_1, R_p_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, a_B_4, a_B_5, a_B_6, c_E, rho_b,
        c_T, F_T, k_C, m_L, b_L_x, b_L_y, b_L_z)
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
    o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z
    o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z
    o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z
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
    t30 = A_x_1*s_1_x
    t31 = A_y_1*s_1_y
    t32 = A_z_1*s_1_z
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + t30 + t31 + t32
    t33 = 1.0/det_D_l
    t34 = A_x_1*t33
    D_p_x_1 = D_r_1*t34
    t35 = A_x_2*t33
    D_p_x_2 = D_r_2*t35
    t36 = A_x_3*t33
    D_p_x_3 = D_r_3*t36
    t37 = A_x_4*t33
    D_p_x_4 = D_r_4*t37
    t38 = A_x_5*t33
    D_p_x_5 = D_r_5*t38
    t39 = A_x_6*t33
    D_p_x_6 = D_r_6*t39
    D_delta_x_1 = l_d_1*t34
    D_delta_x_2 = l_d_2*t35
    D_delta_x_3 = l_d_3*t36
    D_delta_x_4 = l_d_4*t37
    D_delta_x_5 = l_d_5*t38
    D_delta_x_6 = l_d_6*t39
    D_delta_x_7 = t30*t33
    D_delta_x_8 = s_1_y*t34
    D_delta_x_9 = s_1_z*t34
    D_delta_x_10 = s_2_x*t35
    D_delta_x_11 = s_2_y*t35
    D_delta_x_12 = s_2_z*t35
    D_delta_x_13 = s_3_x*t36
    D_delta_x_14 = s_3_y*t36
    D_delta_x_15 = s_3_z*t36
    D_delta_x_16 = s_4_x*t37
    D_delta_x_17 = s_4_y*t37
    D_delta_x_18 = s_4_z*t37
    D_delta_x_19 = s_5_x*t38
    D_delta_x_20 = s_5_y*t38
    D_delta_x_21 = s_5_z*t38
    D_delta_x_22 = s_6_x*t39
    D_delta_x_23 = s_6_y*t39
    D_delta_x_24 = s_6_z*t39
    t40 = A_y_1*t33
    D_p_y_1 = D_r_1*t40
    t41 = A_y_2*t33
    D_p_y_2 = D_r_2*t41
    t42 = A_y_3*t33
    D_p_y_3 = D_r_3*t42
    t43 = A_y_4*t33
    D_p_y_4 = D_r_4*t43
    t44 = A_y_5*t33
    D_p_y_5 = D_r_5*t44
    t45 = A_y_6*t33
    D_p_y_6 = D_r_6*t45
    D_delta_y_1 = l_d_1*t40
    D_delta_y_2 = l_d_2*t41
    D_delta_y_3 = l_d_3*t42
    D_delta_y_4 = l_d_4*t43
    D_delta_y_5 = l_d_5*t44
    D_delta_y_6 = l_d_6*t45
    D_delta_y_7 = s_1_x*t40
    D_delta_y_8 = t31*t33
    D_delta_y_9 = s_1_z*t40
    D_delta_y_10 = s_2_x*t41
    D_delta_y_11 = s_2_y*t41
    D_delta_y_12 = s_2_z*t41
    D_delta_y_13 = s_3_x*t42
    D_delta_y_14 = s_3_y*t42
    D_delta_y_15 = s_3_z*t42
    D_delta_y_16 = s_4_x*t43
    D_delta_y_17 = s_4_y*t43
    D_delta_y_18 = s_4_z*t43
    D_delta_y_19 = s_5_x*t44
    D_delta_y_20 = s_5_y*t44
    D_delta_y_21 = s_5_z*t44
    D_delta_y_22 = s_6_x*t45
    D_delta_y_23 = s_6_y*t45
    D_delta_y_24 = s_6_z*t45
    t46 = A_z_1*t33
    D_p_z_1 = D_r_1*t46
    t47 = A_z_2*t33
    D_p_z_2 = D_r_2*t47
    t48 = A_z_3*t33
    D_p_z_3 = D_r_3*t48
    t49 = A_z_4*t33
    D_p_z_4 = D_r_4*t49
    t50 = A_z_5*t33
    D_p_z_5 = D_r_5*t50
    t51 = A_z_6*t33
    D_p_z_6 = D_r_6*t51
    D_delta_z_1 = l_d_1*t46
    D_delta_z_2 = l_d_2*t47
    D_delta_z_3 = l_d_3*t48
    D_delta_z_4 = l_d_4*t49
    D_delta_z_5 = l_d_5*t50
    D_delta_z_6 = l_d_6*t51
    D_delta_z_7 = s_1_x*t46
    D_delta_z_8 = s_1_y*t46
    D_delta_z_9 = t32*t33
    D_delta_z_10 = s_2_x*t47
    D_delta_z_11 = s_2_y*t47
    D_delta_z_12 = s_2_z*t47
    D_delta_z_13 = s_3_x*t48
    D_delta_z_14 = s_3_y*t48
    D_delta_z_15 = s_3_z*t48
    D_delta_z_16 = s_4_x*t49
    D_delta_z_17 = s_4_y*t49
    D_delta_z_18 = s_4_z*t49
    D_delta_z_19 = s_5_x*t50
    D_delta_z_20 = s_5_y*t50
    D_delta_z_21 = s_5_z*t50
    D_delta_z_22 = s_6_x*t51
    D_delta_z_23 = s_6_y*t51
    D_delta_z_24 = s_6_z*t51
    t52 = A_rx_1*t33
    D_p_rx_1 = D_r_1*t52
    t53 = A_rx_2*t33
    D_p_rx_2 = D_r_2*t53
    t54 = A_rx_3*t33
    D_p_rx_3 = D_r_3*t54
    t55 = A_rx_4*t33
    D_p_rx_4 = D_r_4*t55
    t56 = A_rx_5*t33
    D_p_rx_5 = D_r_5*t56
    t57 = A_rx_6*t33
    D_p_rx_6 = D_r_6*t57
    D_delta_rx_1 = l_d_1*t52
    D_delta_rx_2 = l_d_2*t53
    D_delta_rx_3 = l_d_3*t54
    D_delta_rx_4 = l_d_4*t55
    D_delta_rx_5 = l_d_5*t56
    D_delta_rx_6 = l_d_6*t57
    D_delta_rx_7 = s_1_x*t52
    D_delta_rx_8 = s_1_y*t52
    D_delta_rx_9 = s_1_z*t52
    D_delta_rx_10 = s_2_x*t53
    D_delta_rx_11 = s_2_y*t53
    D_delta_rx_12 = s_2_z*t53
    D_delta_rx_13 = s_3_x*t54
    D_delta_rx_14 = s_3_y*t54
    D_delta_rx_15 = s_3_z*t54
    D_delta_rx_16 = s_4_x*t55
    D_delta_rx_17 = s_4_y*t55
    D_delta_rx_18 = s_4_z*t55
    D_delta_rx_19 = s_5_x*t56
    D_delta_rx_20 = s_5_y*t56
    D_delta_rx_21 = s_5_z*t56
    D_delta_rx_22 = s_6_x*t57
    D_delta_rx_23 = s_6_y*t57
    D_delta_rx_24 = s_6_z*t57
    t58 = A_ry_1*t33
    D_p_ry_1 = D_r_1*t58
    t59 = A_ry_2*t33
    D_p_ry_2 = D_r_2*t59
    t60 = A_ry_3*t33
    D_p_ry_3 = D_r_3*t60
    t61 = A_ry_4*t33
    D_p_ry_4 = D_r_4*t61
    t62 = A_ry_5*t33
    D_p_ry_5 = D_r_5*t62
    t63 = A_ry_6*t33
    D_p_ry_6 = D_r_6*t63
    D_delta_ry_1 = l_d_1*t58
    D_delta_ry_2 = l_d_2*t59
    D_delta_ry_3 = l_d_3*t60
    D_delta_ry_4 = l_d_4*t61
    D_delta_ry_5 = l_d_5*t62
    D_delta_ry_6 = l_d_6*t63
    D_delta_ry_7 = s_1_x*t58
    D_delta_ry_8 = s_1_y*t58
    D_delta_ry_9 = s_1_z*t58
    D_delta_ry_10 = s_2_x*t59
    D_delta_ry_11 = s_2_y*t59
    D_delta_ry_12 = s_2_z*t59
    D_delta_ry_13 = s_3_x*t60
    D_delta_ry_14 = s_3_y*t60
    D_delta_ry_15 = s_3_z*t60
    D_delta_ry_16 = s_4_x*t61
    D_delta_ry_17 = s_4_y*t61
    D_delta_ry_18 = s_4_z*t61
    D_delta_ry_19 = s_5_x*t62
    D_delta_ry_20 = s_5_y*t62
    D_delta_ry_21 = s_5_z*t62
    D_delta_ry_22 = s_6_x*t63
    D_delta_ry_23 = s_6_y*t63
    D_delta_ry_24 = s_6_z*t63
    t64 = A_rz_1*t33
    D_p_rz_1 = D_r_1*t64
    t65 = A_rz_2*t33
    D_p_rz_2 = D_r_2*t65
    t66 = A_rz_3*t33
    D_p_rz_3 = D_r_3*t66
    t67 = A_rz_4*t33
    D_p_rz_4 = D_r_4*t67
    t68 = A_rz_5*t33
    D_p_rz_5 = D_r_5*t68
    t69 = A_rz_6*t33
    D_p_rz_6 = D_r_6*t69
    D_delta_rz_1 = l_d_1*t64
    D_delta_rz_2 = l_d_2*t65
    D_delta_rz_3 = l_d_3*t66
    D_delta_rz_4 = l_d_4*t67
    D_delta_rz_5 = l_d_5*t68
    D_delta_rz_6 = l_d_6*t69
    D_delta_rz_7 = s_1_x*t64
    D_delta_rz_8 = s_1_y*t64
    D_delta_rz_9 = s_1_z*t64
    D_delta_rz_10 = s_2_x*t65
    D_delta_rz_11 = s_2_y*t65
    D_delta_rz_12 = s_2_z*t65
    D_delta_rz_13 = s_3_x*t66
    D_delta_rz_14 = s_3_y*t66
    D_delta_rz_15 = s_3_z*t66
    D_delta_rz_16 = s_4_x*t67
    D_delta_rz_17 = s_4_y*t67
    D_delta_rz_18 = s_4_z*t67
    D_delta_rz_19 = s_5_x*t68
    D_delta_rz_20 = s_5_y*t68
    D_delta_rz_21 = s_5_z*t68
    D_delta_rz_22 = s_6_x*t69
    D_delta_rz_23 = s_6_y*t69
    D_delta_rz_24 = s_6_z*t69
    l_f_1_1 = x_max_1 - x_min_1
    t70 = F_T*c_T + 1
    t71 = c_E*t70
    t72 = k_sp_1*w_b_1*(a_B_1 + 1)
    t73 = t71*t72
    t74 = t70*t72
    k_1_1 = t74/(l_f_1_1 + t73)
    t75 = (1/2)*l_t_1
    l_f_1_2 = -t75 + x_1 - x_min_1
    k_1_2 = t74/(l_f_1_2 + t73)
    l_f_1_3 = -t75 - x_1 + x_max_1
    k_1_3 = t74/(l_f_1_3 + t73)
    l_f_2_1 = x_max_2 - x_min_2
    t76 = k_sp_2*w_b_2*(a_B_2 + 1)
    t77 = t71*t76
    t78 = t70*t76
    k_2_1 = t78/(l_f_2_1 + t77)
    t79 = (1/2)*l_t_2
    l_f_2_2 = -t79 + x_2 - x_min_2
    k_2_2 = t78/(l_f_2_2 + t77)
    l_f_2_3 = -t79 - x_2 + x_max_2
    k_2_3 = t78/(l_f_2_3 + t77)
    l_f_3_1 = x_max_3 - x_min_3
    t80 = k_sp_3*w_b_3*(a_B_3 + 1)
    t81 = t71*t80
    t82 = t70*t80
    k_3_1 = t82/(l_f_3_1 + t81)
    t83 = (1/2)*l_t_3
    l_f_3_2 = -t83 + x_3 - x_min_3
    k_3_2 = t82/(l_f_3_2 + t81)
    l_f_3_3 = -t83 - x_3 + x_max_3
    k_3_3 = t82/(l_f_3_3 + t81)
    l_f_4_1 = x_max_4 - x_min_4
    t84 = k_sp_4*w_b_4*(a_B_4 + 1)
    t85 = t71*t84
    t86 = t70*t84
    k_4_1 = t86/(l_f_4_1 + t85)
    t87 = (1/2)*l_t_4
    l_f_4_2 = -t87 + x_4 - x_min_4
    k_4_2 = t86/(l_f_4_2 + t85)
    l_f_4_3 = -t87 - x_4 + x_max_4
    k_4_3 = t86/(l_f_4_3 + t85)
    l_f_5_1 = x_max_5 - x_min_5
    t88 = k_sp_5*w_b_5*(a_B_5 + 1)
    t89 = t71*t88
    t90 = t70*t88
    k_5_1 = t90/(l_f_5_1 + t89)
    t91 = (1/2)*l_t_5
    l_f_5_2 = -t91 + x_5 - x_min_5
    k_5_2 = t90/(l_f_5_2 + t89)
    l_f_5_3 = -t91 - x_5 + x_max_5
    k_5_3 = t90/(l_f_5_3 + t89)
    l_f_6_1 = x_max_6 - x_min_6
    t92 = k_sp_6*w_b_6*(a_B_6 + 1)
    t93 = t71*t92
    t94 = t70*t92
    k_6_1 = t94/(l_f_6_1 + t93)
    t95 = (1/2)*l_t_6
    l_f_6_2 = -t95 + x_6 - x_min_6
    k_6_2 = t94/(l_f_6_2 + t93)
    l_f_6_3 = -t95 - x_6 + x_max_6
    k_6_3 = t94/(l_f_6_3 + t93)
    t96 = (1/2)*m_d_1
    t97 = (1/2)*m_d_2
    t98 = (1/2)*m_d_3
    t99 = (1/2)*m_d_4
    t100 = (1/2)*m_d_5
    t101 = (1/2)*m_d_6
    t102 = m_L + m_p
    t103 = t100 + t101 + t102 + t96 + t97 + t98 + t99
    G_p_x = -g_x*t103
    G_p_y = -g_y*t103
    G_p_z = -g_z*t103
    t104 = g_z*m_p
    t105 = g_z*m_L
    t106 = g_z*t96
    t107 = g_z*t97
    t108 = g_z*t98
    t109 = g_z*t99
    t110 = g_z*t100
    t111 = g_z*t101
    G_p_rx = (
        -B_1_y*t106 + (1/2)*B_1_z*g_y*m_d_1 - B_2_y*t107 + (1/2)*B_2_z*g_y*m_d_2 - B_3_y*t108
        + (1/2)*B_3_z*g_y*m_d_3 - B_4_y*t109 + (1/2)*B_4_z*g_y*m_d_4 - B_5_y*t110 + (1/2)*B_5_z*g_y*m_d_5
        - B_6_y*t111 + (1/2)*B_6_z*g_y*m_d_6 - c_y*t104 + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t105
    )
    t112 = g_x*t96
    t113 = g_x*t97
    t114 = g_x*t98
    t115 = g_x*t99
    t116 = g_x*t100
    t117 = g_x*t101
    t118 = g_x*m_p
    t119 = g_x*m_L
    G_p_ry = (
        B_1_x*t106 - B_1_z*t112 + B_2_x*t107 - B_2_z*t113 + B_3_x*t108 - B_3_z*t114 + B_4_x*t109 - B_4_z*t115
        + B_5_x*t110 - B_5_z*t116 + B_6_x*t111 - B_6_z*t117 + c_x*t104 - c_z*t118 + o_L_x*t105 - o_L_z*t119
    )
    t120 = g_y*m_p
    t121 = g_y*m_L
    t122 = g_y*t96
    t123 = g_y*t97
    t124 = g_y*t98
    t125 = g_y*t99
    t126 = g_y*t100
    t127 = g_y*t101
    G_p_rz = (
        -B_1_x*t122 + (1/2)*B_1_y*g_x*m_d_1 - B_2_x*t123 + (1/2)*B_2_y*g_x*m_d_2 - B_3_x*t124
        + (1/2)*B_3_y*g_x*m_d_3 - B_4_x*t125 + (1/2)*B_4_y*g_x*m_d_4 - B_5_x*t126 + (1/2)*B_5_y*g_x*m_d_5
        - B_6_x*t127 + (1/2)*B_6_y*g_x*m_d_6 - c_x*t120 + c_y*g_x*m_p + g_x*m_L*o_L_y - o_L_x*t121
    )
    mu_1 = t33*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z)
    mu_2 = t33*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z)
    mu_3 = t33*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z)
    mu_4 = t33*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z)
    mu_5 = t33*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z)
    mu_6 = t33*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z)
    g_4_x = -mu_1*s_1_x - t112
    g_4_y = -mu_1*s_1_y - t122
    g_4_z = -mu_1*s_1_z - t106
    g_5_x = -mu_2*s_2_x - t113
    g_5_y = -mu_2*s_2_y - t123
    g_5_z = -mu_2*s_2_z - t107
    g_6_x = -mu_3*s_3_x - t114
    g_6_y = -mu_3*s_3_y - t124
    g_6_z = -mu_3*s_3_z - t108
    g_7_x = -mu_4*s_4_x - t115
    g_7_y = -mu_4*s_4_y - t125
    g_7_z = -mu_4*s_4_z - t109
    g_8_x = -mu_5*s_5_x - t116
    g_8_y = -mu_5*s_5_y - t126
    g_8_z = -mu_5*s_5_z - t110
    g_9_x = -mu_6*s_6_x - t117
    g_9_y = -mu_6*s_6_y - t127
    g_9_z = -mu_6*s_6_z - t111
    g_10_x = -t118
    g_10_y = -t120
    g_10_z = -t104
    g_11_x = -t119
    g_11_y = -t121
    g_11_z = -t105
    L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6
    t128 = B_1_z*mu_1
    t129 = B_2_z*mu_2
    t130 = B_3_z*mu_3
    t131 = B_4_z*mu_4
    t132 = B_5_z*mu_5
    t133 = B_6_z*mu_6
    L_y_rx = t128 + t129 + t130 + t131 + t132 + t133
    L_x_ry = -L_y_rx
    t134 = B_1_y*mu_1
    t135 = B_2_y*mu_2
    t136 = B_3_y*mu_3
    t137 = B_4_y*mu_4
    t138 = B_5_y*mu_5
    t139 = B_6_y*mu_6
    L_x_rz = t134 + t135 + t136 + t137 + t138 + t139
    t140 = B_1_x*mu_1
    t141 = B_2_x*mu_2
    t142 = B_3_x*mu_3
    t143 = B_4_x*mu_4
    t144 = B_5_x*mu_5
    t145 = B_6_x*mu_6
    L_z_ry = t140 + t141 + t142 + t143 + t144 + t145
    L_y_rz = -L_z_ry
    L_z_rx = -L_x_rz
    t146 = B_1_z**2
    t147 = B_2_z**2
    t148 = B_3_z**2
    t149 = B_4_z**2
    t150 = B_5_z**2
    t151 = B_6_z**2
    t152 = (
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + g_11_z*o_L_z + mu_1*t146 + mu_2*t147 + mu_3*t148 + mu_4*t149 + mu_5*t150 + mu_6*t151
    )
    t153 = B_1_y**2
    t154 = B_2_y**2
    t155 = B_3_y**2
    t156 = B_4_y**2
    t157 = B_5_y**2
    t158 = B_6_y**2
    t159 = (
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + g_11_y*o_L_y + mu_1*t153 + mu_2*t154 + mu_3*t155 + mu_4*t156 + mu_5*t157 + mu_6*t158
    )
    L_rx_rx = -t152 - t159
    t160 = (1/2)*B_1_x
    t161 = (1/2)*g_4_x
    t162 = (1/2)*B_2_x
    t163 = (1/2)*g_5_x
    t164 = (1/2)*B_3_x
    t165 = (1/2)*g_6_x
    t166 = (1/2)*B_4_x
    t167 = (1/2)*g_7_x
    t168 = (1/2)*B_5_x
    t169 = (1/2)*g_8_x
    t170 = (1/2)*B_6_x
    t171 = (1/2)*g_9_x
    t172 = (1/2)*c_x
    t173 = (1/2)*g_10_x
    t174 = (1/2)*g_11_x
    t175 = (1/2)*o_L_x
    L_rx_ry = (
        B_1_x*t134 + B_1_y*t161 + B_2_x*t135 + B_2_y*t163 + B_3_x*t136 + B_3_y*t165 + B_4_x*t137 + B_4_y*t167
        + B_5_x*t138 + B_5_y*t169 + B_6_x*t139 + B_6_y*t171 + c_y*t173 + g_10_y*t172 + g_11_y*t175
        + g_4_y*t160 + g_5_y*t162 + g_6_y*t164 + g_7_y*t166 + g_8_y*t168 + g_9_y*t170 + o_L_y*t174
    )
    L_rx_rz = (
        B_1_x*t128 + B_1_z*t161 + B_2_x*t129 + B_2_z*t163 + B_3_x*t130 + B_3_z*t165 + B_4_x*t131 + B_4_z*t167
        + B_5_x*t132 + B_5_z*t169 + B_6_x*t133 + B_6_z*t171 + c_z*t173 + g_10_z*t172 + g_11_z*t175
        + g_4_z*t160 + g_5_z*t162 + g_6_z*t164 + g_7_z*t166 + g_8_z*t168 + g_9_z*t170 + o_L_z*t174
    )
    t176 = B_1_x**2
    t177 = B_2_x**2
    t178 = B_3_x**2
    t179 = B_4_x**2
    t180 = B_5_x**2
    t181 = B_6_x**2
    t182 = (
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + g_11_x*o_L_x + mu_1*t176 + mu_2*t177 + mu_3*t178 + mu_4*t179 + mu_5*t180 + mu_6*t181
    )
    L_ry_ry = -t152 - t182
    L_ry_rz = (
        (1/2)*B_1_y*g_4_z + B_1_y*t128 + (1/2)*B_1_z*g_4_y + (1/2)*B_2_y*g_5_z + B_2_y*t129
        + (1/2)*B_2_z*g_5_y + (1/2)*B_3_y*g_6_z + B_3_y*t130 + (1/2)*B_3_z*g_6_y + (1/2)*B_4_y*g_7_z
        + B_4_y*t131 + (1/2)*B_4_z*g_7_y + (1/2)*B_5_y*g_8_z + B_5_y*t132 + (1/2)*B_5_z*g_8_y
        + (1/2)*B_6_y*g_9_z + B_6_y*t133 + (1/2)*B_6_z*g_9_y + (1/2)*c_y*g_10_z + (1/2)*c_z*g_10_y
        + (1/2)*g_11_y*o_L_z + (1/2)*g_11_z*o_L_y
    )
    L_rz_rz = -t159 - t182
    f_x_w_carriage_1x = D_delta_ry_7*L_x_ry + D_delta_rz_7*L_x_rz + D_delta_x_7*L_x_x + mu_1
    f_x_w_carriage_1y = D_delta_ry_8*L_x_ry + D_delta_rz_8*L_x_rz + D_delta_x_8*L_x_x
    f_x_w_carriage_1z = D_delta_ry_9*L_x_ry + D_delta_rz_9*L_x_rz + D_delta_x_9*L_x_x
    f_x_w_carriage_2x = D_delta_ry_10*L_x_ry + D_delta_rz_10*L_x_rz + D_delta_x_10*L_x_x + mu_2
    f_x_w_carriage_2y = D_delta_ry_11*L_x_ry + D_delta_rz_11*L_x_rz + D_delta_x_11*L_x_x
    f_x_w_carriage_2z = D_delta_ry_12*L_x_ry + D_delta_rz_12*L_x_rz + D_delta_x_12*L_x_x
    f_x_w_carriage_3x = D_delta_ry_13*L_x_ry + D_delta_rz_13*L_x_rz + D_delta_x_13*L_x_x + mu_3
    f_x_w_carriage_3y = D_delta_ry_14*L_x_ry + D_delta_rz_14*L_x_rz + D_delta_x_14*L_x_x
    f_x_w_carriage_3z = D_delta_ry_15*L_x_ry + D_delta_rz_15*L_x_rz + D_delta_x_15*L_x_x
    f_x_w_carriage_4x = D_delta_ry_16*L_x_ry + D_delta_rz_16*L_x_rz + D_delta_x_16*L_x_x + mu_4
    f_x_w_carriage_4y = D_delta_ry_17*L_x_ry + D_delta_rz_17*L_x_rz + D_delta_x_17*L_x_x
    f_x_w_carriage_4z = D_delta_ry_18*L_x_ry + D_delta_rz_18*L_x_rz + D_delta_x_18*L_x_x
    f_x_w_carriage_5x = D_delta_ry_19*L_x_ry + D_delta_rz_19*L_x_rz + D_delta_x_19*L_x_x + mu_5
    f_x_w_carriage_5y = D_delta_ry_20*L_x_ry + D_delta_rz_20*L_x_rz + D_delta_x_20*L_x_x
    f_x_w_carriage_5z = D_delta_ry_21*L_x_ry + D_delta_rz_21*L_x_rz + D_delta_x_21*L_x_x
    f_x_w_carriage_6x = D_delta_ry_22*L_x_ry + D_delta_rz_22*L_x_rz + D_delta_x_22*L_x_x + mu_6
    f_x_w_carriage_6y = D_delta_ry_23*L_x_ry + D_delta_rz_23*L_x_rz + D_delta_x_23*L_x_x
    f_x_w_carriage_6z = D_delta_ry_24*L_x_ry + D_delta_rz_24*L_x_rz + D_delta_x_24*L_x_x
    f_y_w_carriage_1x = D_delta_rx_7*L_y_rx + D_delta_rz_7*L_y_rz + D_delta_y_7*L_x_x
    f_y_w_carriage_1y = D_delta_rx_8*L_y_rx + D_delta_rz_8*L_y_rz + D_delta_y_8*L_x_x + mu_1
    f_y_w_carriage_1z = D_delta_rx_9*L_y_rx + D_delta_rz_9*L_y_rz + D_delta_y_9*L_x_x
    f_y_w_carriage_2x = D_delta_rx_10*L_y_rx + D_delta_rz_10*L_y_rz + D_delta_y_10*L_x_x
    f_y_w_carriage_2y = D_delta_rx_11*L_y_rx + D_delta_rz_11*L_y_rz + D_delta_y_11*L_x_x + mu_2
    f_y_w_carriage_2z = D_delta_rx_12*L_y_rx + D_delta_rz_12*L_y_rz + D_delta_y_12*L_x_x
    f_y_w_carriage_3x = D_delta_rx_13*L_y_rx + D_delta_rz_13*L_y_rz + D_delta_y_13*L_x_x
    f_y_w_carriage_3y = D_delta_rx_14*L_y_rx + D_delta_rz_14*L_y_rz + D_delta_y_14*L_x_x + mu_3
    f_y_w_carriage_3z = D_delta_rx_15*L_y_rx + D_delta_rz_15*L_y_rz + D_delta_y_15*L_x_x
    f_y_w_carriage_4x = D_delta_rx_16*L_y_rx + D_delta_rz_16*L_y_rz + D_delta_y_16*L_x_x
    f_y_w_carriage_4y = D_delta_rx_17*L_y_rx + D_delta_rz_17*L_y_rz + D_delta_y_17*L_x_x + mu_4
    f_y_w_carriage_4z = D_delta_rx_18*L_y_rx + D_delta_rz_18*L_y_rz + D_delta_y_18*L_x_x
    f_y_w_carriage_5x = D_delta_rx_19*L_y_rx + D_delta_rz_19*L_y_rz + D_delta_y_19*L_x_x
    f_y_w_carriage_5y = D_delta_rx_20*L_y_rx + D_delta_rz_20*L_y_rz + D_delta_y_20*L_x_x + mu_5
    f_y_w_carriage_5z = D_delta_rx_21*L_y_rx + D_delta_rz_21*L_y_rz + D_delta_y_21*L_x_x
    f_y_w_carriage_6x = D_delta_rx_22*L_y_rx + D_delta_rz_22*L_y_rz + D_delta_y_22*L_x_x
    f_y_w_carriage_6y = D_delta_rx_23*L_y_rx + D_delta_rz_23*L_y_rz + D_delta_y_23*L_x_x + mu_6
    f_y_w_carriage_6z = D_delta_rx_24*L_y_rx + D_delta_rz_24*L_y_rz + D_delta_y_24*L_x_x
    f_z_w_carriage_1x = D_delta_rx_7*L_z_rx + D_delta_ry_7*L_z_ry + D_delta_z_7*L_x_x
    f_z_w_carriage_1y = D_delta_rx_8*L_z_rx + D_delta_ry_8*L_z_ry + D_delta_z_8*L_x_x
    f_z_w_carriage_1z = D_delta_rx_9*L_z_rx + D_delta_ry_9*L_z_ry + D_delta_z_9*L_x_x + mu_1
    f_z_w_carriage_2x = D_delta_rx_10*L_z_rx + D_delta_ry_10*L_z_ry + D_delta_z_10*L_x_x
    f_z_w_carriage_2y = D_delta_rx_11*L_z_rx + D_delta_ry_11*L_z_ry + D_delta_z_11*L_x_x
    f_z_w_carriage_2z = D_delta_rx_12*L_z_rx + D_delta_ry_12*L_z_ry + D_delta_z_12*L_x_x + mu_2
    f_z_w_carriage_3x = D_delta_rx_13*L_z_rx + D_delta_ry_13*L_z_ry + D_delta_z_13*L_x_x
    f_z_w_carriage_3y = D_delta_rx_14*L_z_rx + D_delta_ry_14*L_z_ry + D_delta_z_14*L_x_x
    f_z_w_carriage_3z = D_delta_rx_15*L_z_rx + D_delta_ry_15*L_z_ry + D_delta_z_15*L_x_x + mu_3
    f_z_w_carriage_4x = D_delta_rx_16*L_z_rx + D_delta_ry_16*L_z_ry + D_delta_z_16*L_x_x
    f_z_w_carriage_4y = D_delta_rx_17*L_z_rx + D_delta_ry_17*L_z_ry + D_delta_z_17*L_x_x
    f_z_w_carriage_4z = D_delta_rx_18*L_z_rx + D_delta_ry_18*L_z_ry + D_delta_z_18*L_x_x + mu_4
    f_z_w_carriage_5x = D_delta_rx_19*L_z_rx + D_delta_ry_19*L_z_ry + D_delta_z_19*L_x_x
    f_z_w_carriage_5y = D_delta_rx_20*L_z_rx + D_delta_ry_20*L_z_ry + D_delta_z_20*L_x_x
    f_z_w_carriage_5z = D_delta_rx_21*L_z_rx + D_delta_ry_21*L_z_ry + D_delta_z_21*L_x_x + mu_5
    f_z_w_carriage_6x = D_delta_rx_22*L_z_rx + D_delta_ry_22*L_z_ry + D_delta_z_22*L_x_x
    f_z_w_carriage_6y = D_delta_rx_23*L_z_rx + D_delta_ry_23*L_z_ry + D_delta_z_23*L_x_x
    f_z_w_carriage_6z = D_delta_rx_24*L_z_rx + D_delta_ry_24*L_z_ry + D_delta_z_24*L_x_x + mu_6
    f_rx_w_carriage_1x = (
        D_delta_rx_7*L_rx_rx + D_delta_ry_7*L_rx_ry + D_delta_rz_7*L_rx_rz + D_delta_y_7*L_y_rx
        + D_delta_z_7*L_z_rx
    )
    f_rx_w_carriage_1y = (
        D_delta_rx_8*L_rx_rx + D_delta_ry_8*L_rx_ry + D_delta_rz_8*L_rx_rz + D_delta_y_8*L_y_rx
        + D_delta_z_8*L_z_rx - t128
    )
    f_rx_w_carriage_1z = (
        D_delta_rx_9*L_rx_rx + D_delta_ry_9*L_rx_ry + D_delta_rz_9*L_rx_rz + D_delta_y_9*L_y_rx
        + D_delta_z_9*L_z_rx + t134
    )
    f_rx_w_carriage_2x = (
        D_delta_rx_10*L_rx_rx + D_delta_ry_10*L_rx_ry + D_delta_rz_10*L_rx_rz + D_delta_y_10*L_y_rx
        + D_delta_z_10*L_z_rx
    )
    f_rx_w_carriage_2y = (
        D_delta_rx_11*L_rx_rx + D_delta_ry_11*L_rx_ry + D_delta_rz_11*L_rx_rz + D_delta_y_11*L_y_rx
        + D_delta_z_11*L_z_rx - t129
    )
    f_rx_w_carriage_2z = (
        D_delta_rx_12*L_rx_rx + D_delta_ry_12*L_rx_ry + D_delta_rz_12*L_rx_rz + D_delta_y_12*L_y_rx
        + D_delta_z_12*L_z_rx + t135
    )
    f_rx_w_carriage_3x = (
        D_delta_rx_13*L_rx_rx + D_delta_ry_13*L_rx_ry + D_delta_rz_13*L_rx_rz + D_delta_y_13*L_y_rx
        + D_delta_z_13*L_z_rx
    )
    f_rx_w_carriage_3y = (
        D_delta_rx_14*L_rx_rx + D_delta_ry_14*L_rx_ry + D_delta_rz_14*L_rx_rz + D_delta_y_14*L_y_rx
        + D_delta_z_14*L_z_rx - t130
    )
    f_rx_w_carriage_3z = (
        D_delta_rx_15*L_rx_rx + D_delta_ry_15*L_rx_ry + D_delta_rz_15*L_rx_rz + D_delta_y_15*L_y_rx
        + D_delta_z_15*L_z_rx + t136
    )
    f_rx_w_carriage_4x = (
        D_delta_rx_16*L_rx_rx + D_delta_ry_16*L_rx_ry + D_delta_rz_16*L_rx_rz + D_delta_y_16*L_y_rx
        + D_delta_z_16*L_z_rx
    )
    f_rx_w_carriage_4y = (
        D_delta_rx_17*L_rx_rx + D_delta_ry_17*L_rx_ry + D_delta_rz_17*L_rx_rz + D_delta_y_17*L_y_rx
        + D_delta_z_17*L_z_rx - t131
    )
    f_rx_w_carriage_4z = (
        D_delta_rx_18*L_rx_rx + D_delta_ry_18*L_rx_ry + D_delta_rz_18*L_rx_rz + D_delta_y_18*L_y_rx
        + D_delta_z_18*L_z_rx + t137
    )
    f_rx_w_carriage_5x = (
        D_delta_rx_19*L_rx_rx + D_delta_ry_19*L_rx_ry + D_delta_rz_19*L_rx_rz + D_delta_y_19*L_y_rx
        + D_delta_z_19*L_z_rx
    )
    f_rx_w_carriage_5y = (
        D_delta_rx_20*L_rx_rx + D_delta_ry_20*L_rx_ry + D_delta_rz_20*L_rx_rz + D_delta_y_20*L_y_rx
        + D_delta_z_20*L_z_rx - t132
    )
    f_rx_w_carriage_5z = (
        D_delta_rx_21*L_rx_rx + D_delta_ry_21*L_rx_ry + D_delta_rz_21*L_rx_rz + D_delta_y_21*L_y_rx
        + D_delta_z_21*L_z_rx + t138
    )
    f_rx_w_carriage_6x = (
        D_delta_rx_22*L_rx_rx + D_delta_ry_22*L_rx_ry + D_delta_rz_22*L_rx_rz + D_delta_y_22*L_y_rx
        + D_delta_z_22*L_z_rx
    )
    f_rx_w_carriage_6y = (
        D_delta_rx_23*L_rx_rx + D_delta_ry_23*L_rx_ry + D_delta_rz_23*L_rx_rz + D_delta_y_23*L_y_rx
        + D_delta_z_23*L_z_rx - t133
    )
    f_rx_w_carriage_6z = (
        D_delta_rx_24*L_rx_rx + D_delta_ry_24*L_rx_ry + D_delta_rz_24*L_rx_rz + D_delta_y_24*L_y_rx
        + D_delta_z_24*L_z_rx + t139
    )
    f_ry_w_carriage_1x = (
        D_delta_rx_7*L_rx_ry + D_delta_ry_7*L_ry_ry + D_delta_rz_7*L_ry_rz + D_delta_x_7*L_x_ry
        + D_delta_z_7*L_z_ry + t128
    )
    f_ry_w_carriage_1y = (
        D_delta_rx_8*L_rx_ry + D_delta_ry_8*L_ry_ry + D_delta_rz_8*L_ry_rz + D_delta_x_8*L_x_ry
        + D_delta_z_8*L_z_ry
    )
    f_ry_w_carriage_1z = (
        D_delta_rx_9*L_rx_ry + D_delta_ry_9*L_ry_ry + D_delta_rz_9*L_ry_rz + D_delta_x_9*L_x_ry
        + D_delta_z_9*L_z_ry - t140
    )
    f_ry_w_carriage_2x = (
        D_delta_rx_10*L_rx_ry + D_delta_ry_10*L_ry_ry + D_delta_rz_10*L_ry_rz + D_delta_x_10*L_x_ry
        + D_delta_z_10*L_z_ry + t129
    )
    f_ry_w_carriage_2y = (
        D_delta_rx_11*L_rx_ry + D_delta_ry_11*L_ry_ry + D_delta_rz_11*L_ry_rz + D_delta_x_11*L_x_ry
        + D_delta_z_11*L_z_ry
    )
    f_ry_w_carriage_2z = (
        D_delta_rx_12*L_rx_ry + D_delta_ry_12*L_ry_ry + D_delta_rz_12*L_ry_rz + D_delta_x_12*L_x_ry
        + D_delta_z_12*L_z_ry - t141
    )
    f_ry_w_carriage_3x = (
        D_delta_rx_13*L_rx_ry + D_delta_ry_13*L_ry_ry + D_delta_rz_13*L_ry_rz + D_delta_x_13*L_x_ry
        + D_delta_z_13*L_z_ry + t130
    )
    f_ry_w_carriage_3y = (
        D_delta_rx_14*L_rx_ry + D_delta_ry_14*L_ry_ry + D_delta_rz_14*L_ry_rz + D_delta_x_14*L_x_ry
        + D_delta_z_14*L_z_ry
    )
    f_ry_w_carriage_3z = (
        D_delta_rx_15*L_rx_ry + D_delta_ry_15*L_ry_ry + D_delta_rz_15*L_ry_rz + D_delta_x_15*L_x_ry
        + D_delta_z_15*L_z_ry - t142
    )
    f_ry_w_carriage_4x = (
        D_delta_rx_16*L_rx_ry + D_delta_ry_16*L_ry_ry + D_delta_rz_16*L_ry_rz + D_delta_x_16*L_x_ry
        + D_delta_z_16*L_z_ry + t131
    )
    f_ry_w_carriage_4y = (
        D_delta_rx_17*L_rx_ry + D_delta_ry_17*L_ry_ry + D_delta_rz_17*L_ry_rz + D_delta_x_17*L_x_ry
        + D_delta_z_17*L_z_ry
    )
    f_ry_w_carriage_4z = (
        D_delta_rx_18*L_rx_ry + D_delta_ry_18*L_ry_ry + D_delta_rz_18*L_ry_rz + D_delta_x_18*L_x_ry
        + D_delta_z_18*L_z_ry - t143
    )
    f_ry_w_carriage_5x = (
        D_delta_rx_19*L_rx_ry + D_delta_ry_19*L_ry_ry + D_delta_rz_19*L_ry_rz + D_delta_x_19*L_x_ry
        + D_delta_z_19*L_z_ry + t132
    )
    f_ry_w_carriage_5y = (
        D_delta_rx_20*L_rx_ry + D_delta_ry_20*L_ry_ry + D_delta_rz_20*L_ry_rz + D_delta_x_20*L_x_ry
        + D_delta_z_20*L_z_ry
    )
    f_ry_w_carriage_5z = (
        D_delta_rx_21*L_rx_ry + D_delta_ry_21*L_ry_ry + D_delta_rz_21*L_ry_rz + D_delta_x_21*L_x_ry
        + D_delta_z_21*L_z_ry - t144
    )
    f_ry_w_carriage_6x = (
        D_delta_rx_22*L_rx_ry + D_delta_ry_22*L_ry_ry + D_delta_rz_22*L_ry_rz + D_delta_x_22*L_x_ry
        + D_delta_z_22*L_z_ry + t133
    )
    f_ry_w_carriage_6y = (
        D_delta_rx_23*L_rx_ry + D_delta_ry_23*L_ry_ry + D_delta_rz_23*L_ry_rz + D_delta_x_23*L_x_ry
        + D_delta_z_23*L_z_ry
    )
    f_ry_w_carriage_6z = (
        D_delta_rx_24*L_rx_ry + D_delta_ry_24*L_ry_ry + D_delta_rz_24*L_ry_rz + D_delta_x_24*L_x_ry
        + D_delta_z_24*L_z_ry - t145
    )
    f_rz_w_carriage_1x = (
        D_delta_rx_7*L_rx_rz + D_delta_ry_7*L_ry_rz + D_delta_rz_7*L_rz_rz + D_delta_x_7*L_x_rz
        + D_delta_y_7*L_y_rz - t134
    )
    f_rz_w_carriage_1y = (
        D_delta_rx_8*L_rx_rz + D_delta_ry_8*L_ry_rz + D_delta_rz_8*L_rz_rz + D_delta_x_8*L_x_rz
        + D_delta_y_8*L_y_rz + t140
    )
    f_rz_w_carriage_1z = (
        D_delta_rx_9*L_rx_rz + D_delta_ry_9*L_ry_rz + D_delta_rz_9*L_rz_rz + D_delta_x_9*L_x_rz
        + D_delta_y_9*L_y_rz
    )
    f_rz_w_carriage_2x = (
        D_delta_rx_10*L_rx_rz + D_delta_ry_10*L_ry_rz + D_delta_rz_10*L_rz_rz + D_delta_x_10*L_x_rz
        + D_delta_y_10*L_y_rz - t135
    )
    f_rz_w_carriage_2y = (
        D_delta_rx_11*L_rx_rz + D_delta_ry_11*L_ry_rz + D_delta_rz_11*L_rz_rz + D_delta_x_11*L_x_rz
        + D_delta_y_11*L_y_rz + t141
    )
    f_rz_w_carriage_2z = (
        D_delta_rx_12*L_rx_rz + D_delta_ry_12*L_ry_rz + D_delta_rz_12*L_rz_rz + D_delta_x_12*L_x_rz
        + D_delta_y_12*L_y_rz
    )
    f_rz_w_carriage_3x = (
        D_delta_rx_13*L_rx_rz + D_delta_ry_13*L_ry_rz + D_delta_rz_13*L_rz_rz + D_delta_x_13*L_x_rz
        + D_delta_y_13*L_y_rz - t136
    )
    f_rz_w_carriage_3y = (
        D_delta_rx_14*L_rx_rz + D_delta_ry_14*L_ry_rz + D_delta_rz_14*L_rz_rz + D_delta_x_14*L_x_rz
        + D_delta_y_14*L_y_rz + t142
    )
    f_rz_w_carriage_3z = (
        D_delta_rx_15*L_rx_rz + D_delta_ry_15*L_ry_rz + D_delta_rz_15*L_rz_rz + D_delta_x_15*L_x_rz
        + D_delta_y_15*L_y_rz
    )
    f_rz_w_carriage_4x = (
        D_delta_rx_16*L_rx_rz + D_delta_ry_16*L_ry_rz + D_delta_rz_16*L_rz_rz + D_delta_x_16*L_x_rz
        + D_delta_y_16*L_y_rz - t137
    )
    f_rz_w_carriage_4y = (
        D_delta_rx_17*L_rx_rz + D_delta_ry_17*L_ry_rz + D_delta_rz_17*L_rz_rz + D_delta_x_17*L_x_rz
        + D_delta_y_17*L_y_rz + t143
    )
    f_rz_w_carriage_4z = (
        D_delta_rx_18*L_rx_rz + D_delta_ry_18*L_ry_rz + D_delta_rz_18*L_rz_rz + D_delta_x_18*L_x_rz
        + D_delta_y_18*L_y_rz
    )
    f_rz_w_carriage_5x = (
        D_delta_rx_19*L_rx_rz + D_delta_ry_19*L_ry_rz + D_delta_rz_19*L_rz_rz + D_delta_x_19*L_x_rz
        + D_delta_y_19*L_y_rz - t138
    )
    f_rz_w_carriage_5y = (
        D_delta_rx_20*L_rx_rz + D_delta_ry_20*L_ry_rz + D_delta_rz_20*L_rz_rz + D_delta_x_20*L_x_rz
        + D_delta_y_20*L_y_rz + t144
    )
    f_rz_w_carriage_5z = (
        D_delta_rx_21*L_rx_rz + D_delta_ry_21*L_ry_rz + D_delta_rz_21*L_rz_rz + D_delta_x_21*L_x_rz
        + D_delta_y_21*L_y_rz
    )
    f_rz_w_carriage_6x = (
        D_delta_rx_22*L_rx_rz + D_delta_ry_22*L_ry_rz + D_delta_rz_22*L_rz_rz + D_delta_x_22*L_x_rz
        + D_delta_y_22*L_y_rz - t139
    )
    f_rz_w_carriage_6y = (
        D_delta_rx_23*L_rx_rz + D_delta_ry_23*L_ry_rz + D_delta_rz_23*L_rz_rz + D_delta_x_23*L_x_rz
        + D_delta_y_23*L_y_rz + t145
    )
    f_rz_w_carriage_6z = (
        D_delta_rx_24*L_rx_rz + D_delta_ry_24*L_ry_rz + D_delta_rz_24*L_rz_rz + D_delta_x_24*L_x_rz
        + D_delta_y_24*L_y_rz
    )
    t183 = (1/3)*m_d_1
    t184 = (1/3)*m_d_2
    t185 = (1/3)*m_d_3
    t186 = (1/3)*m_d_4
    t187 = (1/3)*m_d_5
    t188 = (1/3)*m_d_6
    M_p_x_x = t102 + t183 + t184 + t185 + t186 + t187 + t188
    t189 = c_z*m_p
    t190 = m_L*o_L_z
    t191 = B_1_z*t183
    t192 = B_2_z*t184
    t193 = B_3_z*t185
    t194 = B_4_z*t186
    t195 = B_5_z*t187
    t196 = B_6_z*t188
    M_p_x_ry = t189 + t190 + t191 + t192 + t193 + t194 + t195 + t196
    t197 = c_y*m_p
    t198 = m_L*o_L_y
    t199 = B_1_y*t183
    t200 = B_2_y*t184
    t201 = B_3_y*t185
    t202 = B_4_y*t186
    t203 = B_5_y*t187
    t204 = B_6_y*t188
    M_p_z_rx = t197 + t198 + t199 + t200 + t201 + t202 + t203 + t204
    M_p_x_rz = -M_p_z_rx
    M_p_y_rx = -M_p_x_ry
    M_p_y_rz = (
        B_1_x*t183 + B_2_x*t184 + B_3_x*t185 + B_4_x*t186 + B_5_x*t187 + B_6_x*t188 + c_x*m_p + m_L*o_L_x
    )
    M_p_z_ry = -M_p_y_rz
    t205 = 2*o_L_y**2
    t206 = 2*o_L_z**2
    t207 = (1/2)*m_L
    t208 = 2*t153
    t209 = 2*t146
    t210 = (1/6)*m_d_1
    t211 = 2*t154
    t212 = 2*t147
    t213 = (1/6)*m_d_2
    t214 = 2*t155
    t215 = 2*t148
    t216 = (1/6)*m_d_3
    t217 = 2*t156
    t218 = 2*t149
    t219 = (1/6)*m_d_4
    t220 = 2*t157
    t221 = 2*t150
    t222 = (1/6)*m_d_5
    t223 = 2*t158
    t224 = 2*t151
    t225 = (1/6)*m_d_6
    t226 = 2*c_y**2
    t227 = 2*c_z**2
    t228 = (1/2)*m_p
    M_p_rx_rx = (
        J_x_x + t207*(t205 + t206) + t210*(t208 + t209) + t213*(t211 + t212) + t216*(t214 + t215) + t219*(t217
        + t218) + t222*(t220 + t221) + t225*(t223 + t224) + t228*(t226 + t227)
    )
    M_p_rx_ry = (
        -B_1_x*t199 - B_2_x*t200 - B_3_x*t201 - B_4_x*t202 - B_5_x*t203 - B_6_x*t204 + J_x_y - c_x*t197
        - o_L_x*t198
    )
    M_p_rx_rz = (
        -B_1_x*t191 - B_2_x*t192 - B_3_x*t193 - B_4_x*t194 - B_5_x*t195 - B_6_x*t196 + J_x_z - c_x*t189
        - o_L_x*t190
    )
    t229 = 2*o_L_x**2
    t230 = 2*t176
    t231 = 2*t177
    t232 = 2*t178
    t233 = 2*t179
    t234 = 2*t180
    t235 = 2*t181
    t236 = 2*c_x**2
    M_p_ry_ry = (
        J_y_y + t207*(t206 + t229) + t210*(t209 + t230) + t213*(t212 + t231) + t216*(t215 + t232) + t219*(t218
        + t233) + t222*(t221 + t234) + t225*(t224 + t235) + t228*(t227 + t236)
    )
    M_p_ry_rz = (
        -B_1_y*t191 - B_2_y*t192 - B_3_y*t193 - B_4_y*t194 - B_5_y*t195 - B_6_y*t196 + J_y_z - c_y*t189
        - o_L_y*t190
    )
    M_p_rz_rz = (
        J_z_z + t207*(t205 + t229) + t210*(t208 + t230) + t213*(t211 + t231) + t216*(t214 + t232) + t219*(t217
        + t233) + t222*(t220 + t234) + t225*(t223 + t235) + t228*(t226 + t236)
    )
    h_x_w_carriage_1x = D_delta_ry_7*M_p_x_ry + D_delta_rz_7*M_p_x_rz + D_delta_x_7*M_p_x_x + t210
    h_x_w_carriage_1y = D_delta_ry_8*M_p_x_ry + D_delta_rz_8*M_p_x_rz + D_delta_x_8*M_p_x_x
    h_x_w_carriage_1z = D_delta_ry_9*M_p_x_ry + D_delta_rz_9*M_p_x_rz + D_delta_x_9*M_p_x_x
    h_x_w_carriage_2x = D_delta_ry_10*M_p_x_ry + D_delta_rz_10*M_p_x_rz + D_delta_x_10*M_p_x_x + t213
    h_x_w_carriage_2y = D_delta_ry_11*M_p_x_ry + D_delta_rz_11*M_p_x_rz + D_delta_x_11*M_p_x_x
    h_x_w_carriage_2z = D_delta_ry_12*M_p_x_ry + D_delta_rz_12*M_p_x_rz + D_delta_x_12*M_p_x_x
    h_x_w_carriage_3x = D_delta_ry_13*M_p_x_ry + D_delta_rz_13*M_p_x_rz + D_delta_x_13*M_p_x_x + t216
    h_x_w_carriage_3y = D_delta_ry_14*M_p_x_ry + D_delta_rz_14*M_p_x_rz + D_delta_x_14*M_p_x_x
    h_x_w_carriage_3z = D_delta_ry_15*M_p_x_ry + D_delta_rz_15*M_p_x_rz + D_delta_x_15*M_p_x_x
    h_x_w_carriage_4x = D_delta_ry_16*M_p_x_ry + D_delta_rz_16*M_p_x_rz + D_delta_x_16*M_p_x_x + t219
    h_x_w_carriage_4y = D_delta_ry_17*M_p_x_ry + D_delta_rz_17*M_p_x_rz + D_delta_x_17*M_p_x_x
    h_x_w_carriage_4z = D_delta_ry_18*M_p_x_ry + D_delta_rz_18*M_p_x_rz + D_delta_x_18*M_p_x_x
    h_x_w_carriage_5x = D_delta_ry_19*M_p_x_ry + D_delta_rz_19*M_p_x_rz + D_delta_x_19*M_p_x_x + t222
    h_x_w_carriage_5y = D_delta_ry_20*M_p_x_ry + D_delta_rz_20*M_p_x_rz + D_delta_x_20*M_p_x_x
    h_x_w_carriage_5z = D_delta_ry_21*M_p_x_ry + D_delta_rz_21*M_p_x_rz + D_delta_x_21*M_p_x_x
    h_x_w_carriage_6x = D_delta_ry_22*M_p_x_ry + D_delta_rz_22*M_p_x_rz + D_delta_x_22*M_p_x_x + t225
    h_x_w_carriage_6y = D_delta_ry_23*M_p_x_ry + D_delta_rz_23*M_p_x_rz + D_delta_x_23*M_p_x_x
    h_x_w_carriage_6z = D_delta_ry_24*M_p_x_ry + D_delta_rz_24*M_p_x_rz + D_delta_x_24*M_p_x_x
    h_y_w_carriage_1x = D_delta_rx_7*M_p_y_rx + D_delta_rz_7*M_p_y_rz + D_delta_y_7*M_p_x_x
    h_y_w_carriage_1y = D_delta_rx_8*M_p_y_rx + D_delta_rz_8*M_p_y_rz + D_delta_y_8*M_p_x_x + t210
    h_y_w_carriage_1z = D_delta_rx_9*M_p_y_rx + D_delta_rz_9*M_p_y_rz + D_delta_y_9*M_p_x_x
    h_y_w_carriage_2x = D_delta_rx_10*M_p_y_rx + D_delta_rz_10*M_p_y_rz + D_delta_y_10*M_p_x_x
    h_y_w_carriage_2y = D_delta_rx_11*M_p_y_rx + D_delta_rz_11*M_p_y_rz + D_delta_y_11*M_p_x_x + t213
    h_y_w_carriage_2z = D_delta_rx_12*M_p_y_rx + D_delta_rz_12*M_p_y_rz + D_delta_y_12*M_p_x_x
    h_y_w_carriage_3x = D_delta_rx_13*M_p_y_rx + D_delta_rz_13*M_p_y_rz + D_delta_y_13*M_p_x_x
    h_y_w_carriage_3y = D_delta_rx_14*M_p_y_rx + D_delta_rz_14*M_p_y_rz + D_delta_y_14*M_p_x_x + t216
    h_y_w_carriage_3z = D_delta_rx_15*M_p_y_rx + D_delta_rz_15*M_p_y_rz + D_delta_y_15*M_p_x_x
    h_y_w_carriage_4x = D_delta_rx_16*M_p_y_rx + D_delta_rz_16*M_p_y_rz + D_delta_y_16*M_p_x_x
    h_y_w_carriage_4y = D_delta_rx_17*M_p_y_rx + D_delta_rz_17*M_p_y_rz + D_delta_y_17*M_p_x_x + t219
    h_y_w_carriage_4z = D_delta_rx_18*M_p_y_rx + D_delta_rz_18*M_p_y_rz + D_delta_y_18*M_p_x_x
    h_y_w_carriage_5x = D_delta_rx_19*M_p_y_rx + D_delta_rz_19*M_p_y_rz + D_delta_y_19*M_p_x_x
    h_y_w_carriage_5y = D_delta_rx_20*M_p_y_rx + D_delta_rz_20*M_p_y_rz + D_delta_y_20*M_p_x_x + t222
    h_y_w_carriage_5z = D_delta_rx_21*M_p_y_rx + D_delta_rz_21*M_p_y_rz + D_delta_y_21*M_p_x_x
    h_y_w_carriage_6x = D_delta_rx_22*M_p_y_rx + D_delta_rz_22*M_p_y_rz + D_delta_y_22*M_p_x_x
    h_y_w_carriage_6y = D_delta_rx_23*M_p_y_rx + D_delta_rz_23*M_p_y_rz + D_delta_y_23*M_p_x_x + t225
    h_y_w_carriage_6z = D_delta_rx_24*M_p_y_rx + D_delta_rz_24*M_p_y_rz + D_delta_y_24*M_p_x_x
    h_z_w_carriage_1x = D_delta_rx_7*M_p_z_rx + D_delta_ry_7*M_p_z_ry + D_delta_z_7*M_p_x_x
    h_z_w_carriage_1y = D_delta_rx_8*M_p_z_rx + D_delta_ry_8*M_p_z_ry + D_delta_z_8*M_p_x_x
    h_z_w_carriage_1z = D_delta_rx_9*M_p_z_rx + D_delta_ry_9*M_p_z_ry + D_delta_z_9*M_p_x_x + t210
    h_z_w_carriage_2x = D_delta_rx_10*M_p_z_rx + D_delta_ry_10*M_p_z_ry + D_delta_z_10*M_p_x_x
    h_z_w_carriage_2y = D_delta_rx_11*M_p_z_rx + D_delta_ry_11*M_p_z_ry + D_delta_z_11*M_p_x_x
    h_z_w_carriage_2z = D_delta_rx_12*M_p_z_rx + D_delta_ry_12*M_p_z_ry + D_delta_z_12*M_p_x_x + t213
    h_z_w_carriage_3x = D_delta_rx_13*M_p_z_rx + D_delta_ry_13*M_p_z_ry + D_delta_z_13*M_p_x_x
    h_z_w_carriage_3y = D_delta_rx_14*M_p_z_rx + D_delta_ry_14*M_p_z_ry + D_delta_z_14*M_p_x_x
    h_z_w_carriage_3z = D_delta_rx_15*M_p_z_rx + D_delta_ry_15*M_p_z_ry + D_delta_z_15*M_p_x_x + t216
    h_z_w_carriage_4x = D_delta_rx_16*M_p_z_rx + D_delta_ry_16*M_p_z_ry + D_delta_z_16*M_p_x_x
    h_z_w_carriage_4y = D_delta_rx_17*M_p_z_rx + D_delta_ry_17*M_p_z_ry + D_delta_z_17*M_p_x_x
    h_z_w_carriage_4z = D_delta_rx_18*M_p_z_rx + D_delta_ry_18*M_p_z_ry + D_delta_z_18*M_p_x_x + t219
    h_z_w_carriage_5x = D_delta_rx_19*M_p_z_rx + D_delta_ry_19*M_p_z_ry + D_delta_z_19*M_p_x_x
    h_z_w_carriage_5y = D_delta_rx_20*M_p_z_rx + D_delta_ry_20*M_p_z_ry + D_delta_z_20*M_p_x_x
    h_z_w_carriage_5z = D_delta_rx_21*M_p_z_rx + D_delta_ry_21*M_p_z_ry + D_delta_z_21*M_p_x_x + t222
    h_z_w_carriage_6x = D_delta_rx_22*M_p_z_rx + D_delta_ry_22*M_p_z_ry + D_delta_z_22*M_p_x_x
    h_z_w_carriage_6y = D_delta_rx_23*M_p_z_rx + D_delta_ry_23*M_p_z_ry + D_delta_z_23*M_p_x_x
    h_z_w_carriage_6z = D_delta_rx_24*M_p_z_rx + D_delta_ry_24*M_p_z_ry + D_delta_z_24*M_p_x_x + t225
    h_rx_w_carriage_1x = (
        D_delta_rx_7*M_p_rx_rx + D_delta_ry_7*M_p_rx_ry + D_delta_rz_7*M_p_rx_rz + D_delta_y_7*M_p_y_rx
        + D_delta_z_7*M_p_z_rx
    )
    t237 = B_1_z*t210
    h_rx_w_carriage_1y = (
        D_delta_rx_8*M_p_rx_rx + D_delta_ry_8*M_p_rx_ry + D_delta_rz_8*M_p_rx_rz + D_delta_y_8*M_p_y_rx
        + D_delta_z_8*M_p_z_rx - t237
    )
    t238 = B_1_y*t210
    h_rx_w_carriage_1z = (
        D_delta_rx_9*M_p_rx_rx + D_delta_ry_9*M_p_rx_ry + D_delta_rz_9*M_p_rx_rz + D_delta_y_9*M_p_y_rx
        + D_delta_z_9*M_p_z_rx + t238
    )
    h_rx_w_carriage_2x = (
        D_delta_rx_10*M_p_rx_rx + D_delta_ry_10*M_p_rx_ry + D_delta_rz_10*M_p_rx_rz + D_delta_y_10*M_p_y_rx
        + D_delta_z_10*M_p_z_rx
    )
    t239 = B_2_z*t213
    h_rx_w_carriage_2y = (
        D_delta_rx_11*M_p_rx_rx + D_delta_ry_11*M_p_rx_ry + D_delta_rz_11*M_p_rx_rz + D_delta_y_11*M_p_y_rx
        + D_delta_z_11*M_p_z_rx - t239
    )
    t240 = B_2_y*t213
    h_rx_w_carriage_2z = (
        D_delta_rx_12*M_p_rx_rx + D_delta_ry_12*M_p_rx_ry + D_delta_rz_12*M_p_rx_rz + D_delta_y_12*M_p_y_rx
        + D_delta_z_12*M_p_z_rx + t240
    )
    h_rx_w_carriage_3x = (
        D_delta_rx_13*M_p_rx_rx + D_delta_ry_13*M_p_rx_ry + D_delta_rz_13*M_p_rx_rz + D_delta_y_13*M_p_y_rx
        + D_delta_z_13*M_p_z_rx
    )
    t241 = B_3_z*t216
    h_rx_w_carriage_3y = (
        D_delta_rx_14*M_p_rx_rx + D_delta_ry_14*M_p_rx_ry + D_delta_rz_14*M_p_rx_rz + D_delta_y_14*M_p_y_rx
        + D_delta_z_14*M_p_z_rx - t241
    )
    t242 = B_3_y*t216
    h_rx_w_carriage_3z = (
        D_delta_rx_15*M_p_rx_rx + D_delta_ry_15*M_p_rx_ry + D_delta_rz_15*M_p_rx_rz + D_delta_y_15*M_p_y_rx
        + D_delta_z_15*M_p_z_rx + t242
    )
    h_rx_w_carriage_4x = (
        D_delta_rx_16*M_p_rx_rx + D_delta_ry_16*M_p_rx_ry + D_delta_rz_16*M_p_rx_rz + D_delta_y_16*M_p_y_rx
        + D_delta_z_16*M_p_z_rx
    )
    t243 = B_4_z*t219
    h_rx_w_carriage_4y = (
        D_delta_rx_17*M_p_rx_rx + D_delta_ry_17*M_p_rx_ry + D_delta_rz_17*M_p_rx_rz + D_delta_y_17*M_p_y_rx
        + D_delta_z_17*M_p_z_rx - t243
    )
    t244 = B_4_y*t219
    h_rx_w_carriage_4z = (
        D_delta_rx_18*M_p_rx_rx + D_delta_ry_18*M_p_rx_ry + D_delta_rz_18*M_p_rx_rz + D_delta_y_18*M_p_y_rx
        + D_delta_z_18*M_p_z_rx + t244
    )
    h_rx_w_carriage_5x = (
        D_delta_rx_19*M_p_rx_rx + D_delta_ry_19*M_p_rx_ry + D_delta_rz_19*M_p_rx_rz + D_delta_y_19*M_p_y_rx
        + D_delta_z_19*M_p_z_rx
    )
    t245 = B_5_z*t222
    h_rx_w_carriage_5y = (
        D_delta_rx_20*M_p_rx_rx + D_delta_ry_20*M_p_rx_ry + D_delta_rz_20*M_p_rx_rz + D_delta_y_20*M_p_y_rx
        + D_delta_z_20*M_p_z_rx - t245
    )
    t246 = B_5_y*t222
    h_rx_w_carriage_5z = (
        D_delta_rx_21*M_p_rx_rx + D_delta_ry_21*M_p_rx_ry + D_delta_rz_21*M_p_rx_rz + D_delta_y_21*M_p_y_rx
        + D_delta_z_21*M_p_z_rx + t246
    )
    h_rx_w_carriage_6x = (
        D_delta_rx_22*M_p_rx_rx + D_delta_ry_22*M_p_rx_ry + D_delta_rz_22*M_p_rx_rz + D_delta_y_22*M_p_y_rx
        + D_delta_z_22*M_p_z_rx
    )
    t247 = B_6_z*t225
    h_rx_w_carriage_6y = (
        D_delta_rx_23*M_p_rx_rx + D_delta_ry_23*M_p_rx_ry + D_delta_rz_23*M_p_rx_rz + D_delta_y_23*M_p_y_rx
        + D_delta_z_23*M_p_z_rx - t247
    )
    t248 = B_6_y*t225
    h_rx_w_carriage_6z = (
        D_delta_rx_24*M_p_rx_rx + D_delta_ry_24*M_p_rx_ry + D_delta_rz_24*M_p_rx_rz + D_delta_y_24*M_p_y_rx
        + D_delta_z_24*M_p_z_rx + t248
    )
    h_ry_w_carriage_1x = (
        D_delta_rx_7*M_p_rx_ry + D_delta_ry_7*M_p_ry_ry + D_delta_rz_7*M_p_ry_rz + D_delta_x_7*M_p_x_ry
        + D_delta_z_7*M_p_z_ry + t237
    )
    h_ry_w_carriage_1y = (
        D_delta_rx_8*M_p_rx_ry + D_delta_ry_8*M_p_ry_ry + D_delta_rz_8*M_p_ry_rz + D_delta_x_8*M_p_x_ry
        + D_delta_z_8*M_p_z_ry
    )
    t249 = B_1_x*t210
    h_ry_w_carriage_1z = (
        D_delta_rx_9*M_p_rx_ry + D_delta_ry_9*M_p_ry_ry + D_delta_rz_9*M_p_ry_rz + D_delta_x_9*M_p_x_ry
        + D_delta_z_9*M_p_z_ry - t249
    )
    h_ry_w_carriage_2x = (
        D_delta_rx_10*M_p_rx_ry + D_delta_ry_10*M_p_ry_ry + D_delta_rz_10*M_p_ry_rz + D_delta_x_10*M_p_x_ry
        + D_delta_z_10*M_p_z_ry + t239
    )
    h_ry_w_carriage_2y = (
        D_delta_rx_11*M_p_rx_ry + D_delta_ry_11*M_p_ry_ry + D_delta_rz_11*M_p_ry_rz + D_delta_x_11*M_p_x_ry
        + D_delta_z_11*M_p_z_ry
    )
    t250 = B_2_x*t213
    h_ry_w_carriage_2z = (
        D_delta_rx_12*M_p_rx_ry + D_delta_ry_12*M_p_ry_ry + D_delta_rz_12*M_p_ry_rz + D_delta_x_12*M_p_x_ry
        + D_delta_z_12*M_p_z_ry - t250
    )
    h_ry_w_carriage_3x = (
        D_delta_rx_13*M_p_rx_ry + D_delta_ry_13*M_p_ry_ry + D_delta_rz_13*M_p_ry_rz + D_delta_x_13*M_p_x_ry
        + D_delta_z_13*M_p_z_ry + t241
    )
    h_ry_w_carriage_3y = (
        D_delta_rx_14*M_p_rx_ry + D_delta_ry_14*M_p_ry_ry + D_delta_rz_14*M_p_ry_rz + D_delta_x_14*M_p_x_ry
        + D_delta_z_14*M_p_z_ry
    )
    t251 = B_3_x*t216
    h_ry_w_carriage_3z = (
        D_delta_rx_15*M_p_rx_ry + D_delta_ry_15*M_p_ry_ry + D_delta_rz_15*M_p_ry_rz + D_delta_x_15*M_p_x_ry
        + D_delta_z_15*M_p_z_ry - t251
    )
    h_ry_w_carriage_4x = (
        D_delta_rx_16*M_p_rx_ry + D_delta_ry_16*M_p_ry_ry + D_delta_rz_16*M_p_ry_rz + D_delta_x_16*M_p_x_ry
        + D_delta_z_16*M_p_z_ry + t243
    )
    h_ry_w_carriage_4y = (
        D_delta_rx_17*M_p_rx_ry + D_delta_ry_17*M_p_ry_ry + D_delta_rz_17*M_p_ry_rz + D_delta_x_17*M_p_x_ry
        + D_delta_z_17*M_p_z_ry
    )
    t252 = B_4_x*t219
    h_ry_w_carriage_4z = (
        D_delta_rx_18*M_p_rx_ry + D_delta_ry_18*M_p_ry_ry + D_delta_rz_18*M_p_ry_rz + D_delta_x_18*M_p_x_ry
        + D_delta_z_18*M_p_z_ry - t252
    )
    h_ry_w_carriage_5x = (
        D_delta_rx_19*M_p_rx_ry + D_delta_ry_19*M_p_ry_ry + D_delta_rz_19*M_p_ry_rz + D_delta_x_19*M_p_x_ry
        + D_delta_z_19*M_p_z_ry + t245
    )
    h_ry_w_carriage_5y = (
        D_delta_rx_20*M_p_rx_ry + D_delta_ry_20*M_p_ry_ry + D_delta_rz_20*M_p_ry_rz + D_delta_x_20*M_p_x_ry
        + D_delta_z_20*M_p_z_ry
    )
    t253 = B_5_x*t222
    h_ry_w_carriage_5z = (
        D_delta_rx_21*M_p_rx_ry + D_delta_ry_21*M_p_ry_ry + D_delta_rz_21*M_p_ry_rz + D_delta_x_21*M_p_x_ry
        + D_delta_z_21*M_p_z_ry - t253
    )
    h_ry_w_carriage_6x = (
        D_delta_rx_22*M_p_rx_ry + D_delta_ry_22*M_p_ry_ry + D_delta_rz_22*M_p_ry_rz + D_delta_x_22*M_p_x_ry
        + D_delta_z_22*M_p_z_ry + t247
    )
    h_ry_w_carriage_6y = (
        D_delta_rx_23*M_p_rx_ry + D_delta_ry_23*M_p_ry_ry + D_delta_rz_23*M_p_ry_rz + D_delta_x_23*M_p_x_ry
        + D_delta_z_23*M_p_z_ry
    )
    t254 = B_6_x*t225
    h_ry_w_carriage_6z = (
        D_delta_rx_24*M_p_rx_ry + D_delta_ry_24*M_p_ry_ry + D_delta_rz_24*M_p_ry_rz + D_delta_x_24*M_p_x_ry
        + D_delta_z_24*M_p_z_ry - t254
    )
    h_rz_w_carriage_1x = (
        D_delta_rx_7*M_p_rx_rz + D_delta_ry_7*M_p_ry_rz + D_delta_rz_7*M_p_rz_rz + D_delta_x_7*M_p_x_rz
        + D_delta_y_7*M_p_y_rz - t238
    )
    h_rz_w_carriage_1y = (
        D_delta_rx_8*M_p_rx_rz + D_delta_ry_8*M_p_ry_rz + D_delta_rz_8*M_p_rz_rz + D_delta_x_8*M_p_x_rz
        + D_delta_y_8*M_p_y_rz + t249
    )
    h_rz_w_carriage_1z = (
        D_delta_rx_9*M_p_rx_rz + D_delta_ry_9*M_p_ry_rz + D_delta_rz_9*M_p_rz_rz + D_delta_x_9*M_p_x_rz
        + D_delta_y_9*M_p_y_rz
    )
    h_rz_w_carriage_2x = (
        D_delta_rx_10*M_p_rx_rz + D_delta_ry_10*M_p_ry_rz + D_delta_rz_10*M_p_rz_rz + D_delta_x_10*M_p_x_rz
        + D_delta_y_10*M_p_y_rz - t240
    )
    h_rz_w_carriage_2y = (
        D_delta_rx_11*M_p_rx_rz + D_delta_ry_11*M_p_ry_rz + D_delta_rz_11*M_p_rz_rz + D_delta_x_11*M_p_x_rz
        + D_delta_y_11*M_p_y_rz + t250
    )
    h_rz_w_carriage_2z = (
        D_delta_rx_12*M_p_rx_rz + D_delta_ry_12*M_p_ry_rz + D_delta_rz_12*M_p_rz_rz + D_delta_x_12*M_p_x_rz
        + D_delta_y_12*M_p_y_rz
    )
    h_rz_w_carriage_3x = (
        D_delta_rx_13*M_p_rx_rz + D_delta_ry_13*M_p_ry_rz + D_delta_rz_13*M_p_rz_rz + D_delta_x_13*M_p_x_rz
        + D_delta_y_13*M_p_y_rz - t242
    )
    h_rz_w_carriage_3y = (
        D_delta_rx_14*M_p_rx_rz + D_delta_ry_14*M_p_ry_rz + D_delta_rz_14*M_p_rz_rz + D_delta_x_14*M_p_x_rz
        + D_delta_y_14*M_p_y_rz + t251
    )
    h_rz_w_carriage_3z = (
        D_delta_rx_15*M_p_rx_rz + D_delta_ry_15*M_p_ry_rz + D_delta_rz_15*M_p_rz_rz + D_delta_x_15*M_p_x_rz
        + D_delta_y_15*M_p_y_rz
    )
    h_rz_w_carriage_4x = (
        D_delta_rx_16*M_p_rx_rz + D_delta_ry_16*M_p_ry_rz + D_delta_rz_16*M_p_rz_rz + D_delta_x_16*M_p_x_rz
        + D_delta_y_16*M_p_y_rz - t244
    )
    h_rz_w_carriage_4y = (
        D_delta_rx_17*M_p_rx_rz + D_delta_ry_17*M_p_ry_rz + D_delta_rz_17*M_p_rz_rz + D_delta_x_17*M_p_x_rz
        + D_delta_y_17*M_p_y_rz + t252
    )
    h_rz_w_carriage_4z = (
        D_delta_rx_18*M_p_rx_rz + D_delta_ry_18*M_p_ry_rz + D_delta_rz_18*M_p_rz_rz + D_delta_x_18*M_p_x_rz
        + D_delta_y_18*M_p_y_rz
    )
    h_rz_w_carriage_5x = (
        D_delta_rx_19*M_p_rx_rz + D_delta_ry_19*M_p_ry_rz + D_delta_rz_19*M_p_rz_rz + D_delta_x_19*M_p_x_rz
        + D_delta_y_19*M_p_y_rz - t246
    )
    h_rz_w_carriage_5y = (
        D_delta_rx_20*M_p_rx_rz + D_delta_ry_20*M_p_ry_rz + D_delta_rz_20*M_p_rz_rz + D_delta_x_20*M_p_x_rz
        + D_delta_y_20*M_p_y_rz + t253
    )
    h_rz_w_carriage_5z = (
        D_delta_rx_21*M_p_rx_rz + D_delta_ry_21*M_p_ry_rz + D_delta_rz_21*M_p_rz_rz + D_delta_x_21*M_p_x_rz
        + D_delta_y_21*M_p_y_rz
    )
    h_rz_w_carriage_6x = (
        D_delta_rx_22*M_p_rx_rz + D_delta_ry_22*M_p_ry_rz + D_delta_rz_22*M_p_rz_rz + D_delta_x_22*M_p_x_rz
        + D_delta_y_22*M_p_y_rz - t248
    )
    h_rz_w_carriage_6y = (
        D_delta_rx_23*M_p_rx_rz + D_delta_ry_23*M_p_ry_rz + D_delta_rz_23*M_p_rz_rz + D_delta_x_23*M_p_x_rz
        + D_delta_y_23*M_p_y_rz + t254
    )
    h_rz_w_carriage_6z = (
        D_delta_rx_24*M_p_rx_rz + D_delta_ry_24*M_p_ry_rz + D_delta_rz_24*M_p_rz_rz + D_delta_x_24*M_p_x_rz
        + D_delta_y_24*M_p_y_rz
    )
    t255 = t210*(B_1_y*n_1_z - B_1_z*n_1_y)
    t256 = t210*(-B_1_x*n_1_z + B_1_z*n_1_x)
    t257 = t210*(B_1_x*n_1_y - B_1_y*n_1_x)
    t258 = D_delta_x_7*t210
    t259 = n_1_y*t210
    t260 = n_1_z*t210
    t261 = (1/3)*rho_b
    t262 = l_f_1_2*t261
    t263 = l_f_1_3*t261
    t264 = n_1_x*t262 + n_1_x*t263
    t265 = n_2_x*t213
    t266 = n_2_y*t213
    t267 = n_2_z*t213
    t268 = t213*(B_2_y*n_2_z - B_2_z*n_2_y)
    t269 = t213*(-B_2_x*n_2_z + B_2_z*n_2_x)
    t270 = t213*(B_2_x*n_2_y - B_2_y*n_2_x)
    t271 = n_3_x*t216
    t272 = n_3_y*t216
    t273 = n_3_z*t216
    t274 = t216*(B_3_y*n_3_z - B_3_z*n_3_y)
    t275 = t216*(-B_3_x*n_3_z + B_3_z*n_3_x)
    t276 = t216*(B_3_x*n_3_y - B_3_y*n_3_x)
    t277 = n_4_x*t219
    t278 = n_4_y*t219
    t279 = n_4_z*t219
    t280 = t219*(B_4_y*n_4_z - B_4_z*n_4_y)
    t281 = t219*(-B_4_x*n_4_z + B_4_z*n_4_x)
    t282 = t219*(B_4_x*n_4_y - B_4_y*n_4_x)
    t283 = n_5_x*t222
    t284 = n_5_y*t222
    t285 = n_5_z*t222
    t286 = t222*(B_5_y*n_5_z - B_5_z*n_5_y)
    t287 = t222*(-B_5_x*n_5_z + B_5_z*n_5_x)
    t288 = t222*(B_5_x*n_5_y - B_5_y*n_5_x)
    t289 = n_6_x*t225
    t290 = n_6_y*t225
    t291 = n_6_z*t225
    t292 = t225*(B_6_y*n_6_z - B_6_z*n_6_y)
    t293 = t225*(-B_6_x*n_6_z + B_6_z*n_6_x)
    t294 = t225*(B_6_x*n_6_y - B_6_y*n_6_x)
    t295 = (1/6)*rho_b
    t296 = l_f_1_3*t295
    t297 = R_p_1*n_1_x
    t298 = l_f_1_2*t295
    t299 = t237 + t239 + t241 + t243 + t245 + t247
    t300 = t238 + t240 + t242 + t244 + t246 + t248
    t301 = t210 + t213 + t216 + t219 + t222 + t225
    t302 = m_t_1 + t183
    t303 = t249 + t250 + t251 + t252 + t253 + t254
    t304 = n_1_x*t210
    t305 = D_delta_y_8*t210
    t306 = n_1_y*t262 + n_1_y*t263
    t307 = R_p_1*n_1_y
    t308 = D_delta_z_9*t210
    t309 = n_1_z*t262 + n_1_z*t263
    t310 = R_p_1*n_1_z
    t311 = D_delta_x_10*t213
    t312 = l_f_2_2*t261
    t313 = l_f_2_3*t261
    t314 = n_2_x*t312 + n_2_x*t313
    t315 = l_f_2_3*t295
    t316 = R_p_2*n_2_x
    t317 = l_f_2_2*t295
    t318 = m_t_2 + t184
    t319 = D_delta_y_11*t213
    t320 = n_2_y*t312 + n_2_y*t313
    t321 = R_p_2*n_2_y
    t322 = D_delta_z_12*t213
    t323 = n_2_z*t312 + n_2_z*t313
    t324 = R_p_2*n_2_z
    t325 = D_delta_x_13*t216
    t326 = l_f_3_2*t261
    t327 = l_f_3_3*t261
    t328 = n_3_x*t326 + n_3_x*t327
    t329 = l_f_3_3*t295
    t330 = R_p_3*n_3_x
    t331 = l_f_3_2*t295
    t332 = m_t_3 + t185
    t333 = D_delta_y_14*t216
    t334 = n_3_y*t326 + n_3_y*t327
    t335 = R_p_3*n_3_y
    t336 = D_delta_z_15*t216
    t337 = n_3_z*t326 + n_3_z*t327
    t338 = R_p_3*n_3_z
    t339 = D_delta_x_16*t219
    t340 = l_f_4_2*t261
    t341 = l_f_4_3*t261
    t342 = n_4_x*t340 + n_4_x*t341
    t343 = l_f_4_3*t295
    t344 = R_p_4*n_4_x
    t345 = l_f_4_2*t295
    t346 = m_t_4 + t186
    t347 = D_delta_y_17*t219
    t348 = n_4_y*t340 + n_4_y*t341
    t349 = R_p_4*n_4_y
    t350 = D_delta_z_18*t219
    t351 = n_4_z*t340 + n_4_z*t341
    t352 = R_p_4*n_4_z
    t353 = D_delta_x_19*t222
    t354 = l_f_5_2*t261
    t355 = l_f_5_3*t261
    t356 = n_5_x*t354 + n_5_x*t355
    t357 = l_f_5_3*t295
    t358 = R_p_5*n_5_x
    t359 = l_f_5_2*t295
    t360 = m_t_5 + t187
    t361 = D_delta_y_20*t222
    t362 = n_5_y*t354 + n_5_y*t355
    t363 = R_p_5*n_5_y
    t364 = D_delta_z_21*t222
    t365 = n_5_z*t354 + n_5_z*t355
    t366 = R_p_5*n_5_z
    t367 = D_delta_x_22*t225
    t368 = l_f_6_2*t261
    t369 = l_f_6_3*t261
    t370 = n_6_x*t368 + n_6_x*t369
    t371 = l_f_6_3*t295
    t372 = R_p_6*n_6_x
    t373 = l_f_6_2*t295
    t374 = m_t_6 + t188
    t375 = D_delta_y_23*t225
    t376 = n_6_y*t368 + n_6_y*t369
    t377 = R_p_6*n_6_y
    t378 = D_delta_z_24*t225
    t379 = n_6_z*t368 + n_6_z*t369
    t380 = R_p_6*n_6_z
    t381 = l_f_1_1*t261
    t382 = R_p_1*t381
    t383 = -R_p_1*l_f_1_1*t295
    t384 = l_f_2_1*t261
    t385 = R_p_2*t384
    t386 = -R_p_2*l_f_2_1*t295
    t387 = l_f_3_1*t261
    t388 = R_p_3*t387
    t389 = -R_p_3*l_f_3_1*t295
    t390 = l_f_4_1*t261
    t391 = R_p_4*t390
    t392 = -R_p_4*l_f_4_1*t295
    t393 = l_f_5_1*t261
    t394 = R_p_5*t393
    t395 = -R_p_5*l_f_5_1*t295
    t396 = l_f_6_1*t261
    t397 = R_p_6*t396
    t398 = -R_p_6*l_f_6_1*t295
    t399 = n_1_x**2
    t400 = n_1_y**2
    t401 = n_1_z**2
    t402 = n_2_x**2
    t403 = n_2_y**2
    t404 = n_2_z**2
    t405 = n_3_x**2
    t406 = n_3_y**2
    t407 = n_3_z**2
    t408 = n_4_x**2
    t409 = n_4_y**2
    t410 = n_4_z**2
    t411 = n_5_x**2
    t412 = n_5_y**2
    t413 = n_5_z**2
    t414 = n_6_x**2
    t415 = n_6_y**2
    t416 = n_6_z**2
    t417 = -n_1_y*t128 + n_1_z*t134
    t418 = B_1_z*mu_1*n_1_x - n_1_z*t140
    t419 = -n_1_x*t134 + n_1_y*t140
    t420 = mu_1*n_1_x
    t421 = D_delta_x_7*k_C
    t422 = D_delta_y_7*k_C
    t423 = mu_1*n_1_y
    t424 = D_delta_z_7*k_C
    t425 = mu_1*n_1_z
    t426 = k_1_2*n_1_x
    t427 = k_1_3*n_1_x
    t428 = t426 + t427
    t429 = mu_2*n_2_x
    t430 = mu_2*n_2_y
    t431 = mu_2*n_2_z
    t432 = -n_2_y*t129 + n_2_z*t135
    t433 = B_2_z*mu_2*n_2_x - n_2_z*t141
    t434 = -n_2_x*t135 + n_2_y*t141
    t435 = mu_3*n_3_x
    t436 = mu_3*n_3_y
    t437 = mu_3*n_3_z
    t438 = -n_3_y*t130 + n_3_z*t136
    t439 = B_3_z*mu_3*n_3_x - n_3_z*t142
    t440 = -n_3_x*t136 + n_3_y*t142
    t441 = mu_4*n_4_x
    t442 = mu_4*n_4_y
    t443 = mu_4*n_4_z
    t444 = -n_4_y*t131 + n_4_z*t137
    t445 = B_4_z*mu_4*n_4_x - n_4_z*t143
    t446 = -n_4_x*t137 + n_4_y*t143
    t447 = mu_5*n_5_x
    t448 = mu_5*n_5_y
    t449 = mu_5*n_5_z
    t450 = -n_5_y*t132 + n_5_z*t138
    t451 = B_5_z*mu_5*n_5_x - n_5_z*t144
    t452 = -n_5_x*t138 + n_5_y*t144
    t453 = mu_6*n_6_x
    t454 = mu_6*n_6_y
    t455 = mu_6*n_6_z
    t456 = -n_6_y*t133 + n_6_z*t139
    t457 = B_6_z*mu_6*n_6_x - n_6_z*t145
    t458 = -n_6_x*t139 + n_6_y*t145
    t459 = D_delta_x_8*k_C
    t460 = D_delta_y_8*k_C
    t461 = D_delta_z_8*k_C
    t462 = k_1_2*n_1_y
    t463 = k_1_3*n_1_y
    t464 = t462 + t463
    t465 = D_delta_x_9*k_C
    t466 = D_delta_y_9*k_C
    t467 = D_delta_z_9*k_C
    t468 = k_1_2*n_1_z
    t469 = k_1_3*n_1_z
    t470 = t468 + t469
    t471 = D_delta_x_10*k_C
    t472 = D_delta_y_10*k_C
    t473 = D_delta_z_10*k_C
    t474 = k_2_2*n_2_x
    t475 = k_2_3*n_2_x
    t476 = t474 + t475
    t477 = D_delta_x_11*k_C
    t478 = D_delta_y_11*k_C
    t479 = D_delta_z_11*k_C
    t480 = k_2_2*n_2_y
    t481 = k_2_3*n_2_y
    t482 = t480 + t481
    t483 = D_delta_x_12*k_C
    t484 = D_delta_y_12*k_C
    t485 = D_delta_z_12*k_C
    t486 = k_2_2*n_2_z
    t487 = k_2_3*n_2_z
    t488 = t486 + t487
    t489 = D_delta_x_13*k_C
    t490 = D_delta_y_13*k_C
    t491 = D_delta_z_13*k_C
    t492 = k_3_2*n_3_x
    t493 = k_3_3*n_3_x
    t494 = t492 + t493
    t495 = D_delta_x_14*k_C
    t496 = D_delta_y_14*k_C
    t497 = D_delta_z_14*k_C
    t498 = k_3_2*n_3_y
    t499 = k_3_3*n_3_y
    t500 = t498 + t499
    t501 = D_delta_x_15*k_C
    t502 = D_delta_y_15*k_C
    t503 = D_delta_z_15*k_C
    t504 = k_3_2*n_3_z
    t505 = k_3_3*n_3_z
    t506 = t504 + t505
    t507 = D_delta_x_16*k_C
    t508 = D_delta_y_16*k_C
    t509 = D_delta_z_16*k_C
    t510 = k_4_2*n_4_x
    t511 = k_4_3*n_4_x
    t512 = t510 + t511
    t513 = D_delta_x_17*k_C
    t514 = D_delta_y_17*k_C
    t515 = D_delta_z_17*k_C
    t516 = k_4_2*n_4_y
    t517 = k_4_3*n_4_y
    t518 = t516 + t517
    t519 = D_delta_x_18*k_C
    t520 = D_delta_y_18*k_C
    t521 = D_delta_z_18*k_C
    t522 = k_4_2*n_4_z
    t523 = k_4_3*n_4_z
    t524 = t522 + t523
    t525 = D_delta_x_19*k_C
    t526 = D_delta_y_19*k_C
    t527 = D_delta_z_19*k_C
    t528 = k_5_2*n_5_x
    t529 = k_5_3*n_5_x
    t530 = t528 + t529
    t531 = D_delta_x_20*k_C
    t532 = D_delta_y_20*k_C
    t533 = D_delta_z_20*k_C
    t534 = k_5_2*n_5_y
    t535 = k_5_3*n_5_y
    t536 = t534 + t535
    t537 = D_delta_x_21*k_C
    t538 = D_delta_y_21*k_C
    t539 = D_delta_z_21*k_C
    t540 = k_5_2*n_5_z
    t541 = k_5_3*n_5_z
    t542 = t540 + t541
    t543 = D_delta_x_22*k_C
    t544 = D_delta_y_22*k_C
    t545 = D_delta_z_22*k_C
    t546 = k_6_2*n_6_x
    t547 = k_6_3*n_6_x
    t548 = t546 + t547
    t549 = D_delta_x_23*k_C
    t550 = D_delta_y_23*k_C
    t551 = D_delta_z_23*k_C
    t552 = k_6_2*n_6_y
    t553 = k_6_3*n_6_y
    t554 = t552 + t553
    t555 = D_delta_x_24*k_C
    t556 = D_delta_y_24*k_C
    t557 = D_delta_z_24*k_C
    t558 = k_6_2*n_6_z
    t559 = k_6_3*n_6_z
    t560 = t558 + t559
    t561 = R_p_1*k_1_1
    t562 = R_p_2*k_2_1
    t563 = R_p_3*k_3_1
    t564 = R_p_4*k_4_1
    t565 = R_p_5*k_5_1
    t566 = R_p_6*k_6_1
    M_wq_out = np.zeros((*batch, 30, 39), dtype)
    M_wq_out[..., 0, 0] = (
        D_delta_rx_7*t255 + D_delta_ry_7*t256 + D_delta_rz_7*t257 + D_delta_y_7*t259 + D_delta_z_7*t260
        + D_p_rx_1*h_rx_w_carriage_1x + D_p_ry_1*h_ry_w_carriage_1x + D_p_rz_1*h_rz_w_carriage_1x
        + D_p_x_1*h_x_w_carriage_1x + D_p_y_1*h_y_w_carriage_1x + D_p_z_1*h_z_w_carriage_1x + m_t_1*n_1_x
        + n_1_x*t183 + n_1_x*t258 + t264
    )
    M_wq_out[..., 0, 1] = (
        D_delta_rx_7*t268 + D_delta_ry_7*t269 + D_delta_rz_7*t270 + D_delta_x_7*t265 + D_delta_y_7*t266
        + D_delta_z_7*t267 + D_p_rx_2*h_rx_w_carriage_1x + D_p_ry_2*h_ry_w_carriage_1x
        + D_p_rz_2*h_rz_w_carriage_1x + D_p_x_2*h_x_w_carriage_1x + D_p_y_2*h_y_w_carriage_1x
        + D_p_z_2*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 2] = (
        D_delta_rx_7*t274 + D_delta_ry_7*t275 + D_delta_rz_7*t276 + D_delta_x_7*t271 + D_delta_y_7*t272
        + D_delta_z_7*t273 + D_p_rx_3*h_rx_w_carriage_1x + D_p_ry_3*h_ry_w_carriage_1x
        + D_p_rz_3*h_rz_w_carriage_1x + D_p_x_3*h_x_w_carriage_1x + D_p_y_3*h_y_w_carriage_1x
        + D_p_z_3*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 3] = (
        D_delta_rx_7*t280 + D_delta_ry_7*t281 + D_delta_rz_7*t282 + D_delta_x_7*t277 + D_delta_y_7*t278
        + D_delta_z_7*t279 + D_p_rx_4*h_rx_w_carriage_1x + D_p_ry_4*h_ry_w_carriage_1x
        + D_p_rz_4*h_rz_w_carriage_1x + D_p_x_4*h_x_w_carriage_1x + D_p_y_4*h_y_w_carriage_1x
        + D_p_z_4*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 4] = (
        D_delta_rx_7*t286 + D_delta_ry_7*t287 + D_delta_rz_7*t288 + D_delta_x_7*t283 + D_delta_y_7*t284
        + D_delta_z_7*t285 + D_p_rx_5*h_rx_w_carriage_1x + D_p_ry_5*h_ry_w_carriage_1x
        + D_p_rz_5*h_rz_w_carriage_1x + D_p_x_5*h_x_w_carriage_1x + D_p_y_5*h_y_w_carriage_1x
        + D_p_z_5*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 5] = (
        D_delta_rx_7*t292 + D_delta_ry_7*t293 + D_delta_rz_7*t294 + D_delta_x_7*t289 + D_delta_y_7*t290
        + D_delta_z_7*t291 + D_p_rx_6*h_rx_w_carriage_1x + D_p_ry_6*h_ry_w_carriage_1x
        + D_p_rz_6*h_rz_w_carriage_1x + D_p_x_6*h_x_w_carriage_1x + D_p_y_6*h_y_w_carriage_1x
        + D_p_z_6*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 6] = t296*t297
    M_wq_out[..., 0, 12] = t297*t298
    M_wq_out[..., 0, 24] = (
        D_delta_rx_1*h_rx_w_carriage_1x + D_delta_ry_1*h_ry_w_carriage_1x + D_delta_rz_1*h_rz_w_carriage_1x
        + D_delta_x_1*h_x_w_carriage_1x + D_delta_y_1*h_y_w_carriage_1x + D_delta_z_1*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 25] = (
        D_delta_rx_2*h_rx_w_carriage_1x + D_delta_ry_2*h_ry_w_carriage_1x + D_delta_rz_2*h_rz_w_carriage_1x
        + D_delta_x_2*h_x_w_carriage_1x + D_delta_y_2*h_y_w_carriage_1x + D_delta_z_2*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 26] = (
        D_delta_rx_3*h_rx_w_carriage_1x + D_delta_ry_3*h_ry_w_carriage_1x + D_delta_rz_3*h_rz_w_carriage_1x
        + D_delta_x_3*h_x_w_carriage_1x + D_delta_y_3*h_y_w_carriage_1x + D_delta_z_3*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 27] = (
        D_delta_rx_4*h_rx_w_carriage_1x + D_delta_ry_4*h_ry_w_carriage_1x + D_delta_rz_4*h_rz_w_carriage_1x
        + D_delta_x_4*h_x_w_carriage_1x + D_delta_y_4*h_y_w_carriage_1x + D_delta_z_4*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 28] = (
        D_delta_rx_5*h_rx_w_carriage_1x + D_delta_ry_5*h_ry_w_carriage_1x + D_delta_rz_5*h_rz_w_carriage_1x
        + D_delta_x_5*h_x_w_carriage_1x + D_delta_y_5*h_y_w_carriage_1x + D_delta_z_5*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 29] = (
        D_delta_rx_6*h_rx_w_carriage_1x + D_delta_ry_6*h_ry_w_carriage_1x + D_delta_rz_6*h_rz_w_carriage_1x
        + D_delta_x_6*h_x_w_carriage_1x + D_delta_y_6*h_y_w_carriage_1x + D_delta_z_6*h_z_w_carriage_1x
    )
    M_wq_out[..., 0, 30] = t264
    M_wq_out[..., 0, 36] = D_delta_ry_7*t299 - D_delta_rz_7*t300 + D_delta_x_7*t301 + h_x_w_carriage_1x + t302
    M_wq_out[..., 0, 37] = -D_delta_rx_7*t299 + D_delta_rz_7*t303 + D_delta_y_7*t301 + h_y_w_carriage_1x
    M_wq_out[..., 0, 38] = D_delta_rx_7*t300 - D_delta_ry_7*t303 + D_delta_z_7*t301 + h_z_w_carriage_1x
    M_wq_out[..., 1, 0] = (
        D_delta_rx_8*t255 + D_delta_ry_8*t256 + D_delta_rz_8*t257 + D_delta_x_8*t304 + D_delta_z_8*t260
        + D_p_rx_1*h_rx_w_carriage_1y + D_p_ry_1*h_ry_w_carriage_1y + D_p_rz_1*h_rz_w_carriage_1y
        + D_p_x_1*h_x_w_carriage_1y + D_p_y_1*h_y_w_carriage_1y + D_p_z_1*h_z_w_carriage_1y + m_t_1*n_1_y
        + n_1_y*t183 + n_1_y*t305 + t306
    )
    M_wq_out[..., 1, 1] = (
        D_delta_rx_8*t268 + D_delta_ry_8*t269 + D_delta_rz_8*t270 + D_delta_x_8*t265 + D_delta_y_8*t266
        + D_delta_z_8*t267 + D_p_rx_2*h_rx_w_carriage_1y + D_p_ry_2*h_ry_w_carriage_1y
        + D_p_rz_2*h_rz_w_carriage_1y + D_p_x_2*h_x_w_carriage_1y + D_p_y_2*h_y_w_carriage_1y
        + D_p_z_2*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 2] = (
        D_delta_rx_8*t274 + D_delta_ry_8*t275 + D_delta_rz_8*t276 + D_delta_x_8*t271 + D_delta_y_8*t272
        + D_delta_z_8*t273 + D_p_rx_3*h_rx_w_carriage_1y + D_p_ry_3*h_ry_w_carriage_1y
        + D_p_rz_3*h_rz_w_carriage_1y + D_p_x_3*h_x_w_carriage_1y + D_p_y_3*h_y_w_carriage_1y
        + D_p_z_3*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 3] = (
        D_delta_rx_8*t280 + D_delta_ry_8*t281 + D_delta_rz_8*t282 + D_delta_x_8*t277 + D_delta_y_8*t278
        + D_delta_z_8*t279 + D_p_rx_4*h_rx_w_carriage_1y + D_p_ry_4*h_ry_w_carriage_1y
        + D_p_rz_4*h_rz_w_carriage_1y + D_p_x_4*h_x_w_carriage_1y + D_p_y_4*h_y_w_carriage_1y
        + D_p_z_4*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 4] = (
        D_delta_rx_8*t286 + D_delta_ry_8*t287 + D_delta_rz_8*t288 + D_delta_x_8*t283 + D_delta_y_8*t284
        + D_delta_z_8*t285 + D_p_rx_5*h_rx_w_carriage_1y + D_p_ry_5*h_ry_w_carriage_1y
        + D_p_rz_5*h_rz_w_carriage_1y + D_p_x_5*h_x_w_carriage_1y + D_p_y_5*h_y_w_carriage_1y
        + D_p_z_5*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 5] = (
        D_delta_rx_8*t292 + D_delta_ry_8*t293 + D_delta_rz_8*t294 + D_delta_x_8*t289 + D_delta_y_8*t290
        + D_delta_z_8*t291 + D_p_rx_6*h_rx_w_carriage_1y + D_p_ry_6*h_ry_w_carriage_1y
        + D_p_rz_6*h_rz_w_carriage_1y + D_p_x_6*h_x_w_carriage_1y + D_p_y_6*h_y_w_carriage_1y
        + D_p_z_6*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 6] = t296*t307
    M_wq_out[..., 1, 12] = t298*t307
    M_wq_out[..., 1, 24] = (
        D_delta_rx_1*h_rx_w_carriage_1y + D_delta_ry_1*h_ry_w_carriage_1y + D_delta_rz_1*h_rz_w_carriage_1y
        + D_delta_x_1*h_x_w_carriage_1y + D_delta_y_1*h_y_w_carriage_1y + D_delta_z_1*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 25] = (
        D_delta_rx_2*h_rx_w_carriage_1y + D_delta_ry_2*h_ry_w_carriage_1y + D_delta_rz_2*h_rz_w_carriage_1y
        + D_delta_x_2*h_x_w_carriage_1y + D_delta_y_2*h_y_w_carriage_1y + D_delta_z_2*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 26] = (
        D_delta_rx_3*h_rx_w_carriage_1y + D_delta_ry_3*h_ry_w_carriage_1y + D_delta_rz_3*h_rz_w_carriage_1y
        + D_delta_x_3*h_x_w_carriage_1y + D_delta_y_3*h_y_w_carriage_1y + D_delta_z_3*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 27] = (
        D_delta_rx_4*h_rx_w_carriage_1y + D_delta_ry_4*h_ry_w_carriage_1y + D_delta_rz_4*h_rz_w_carriage_1y
        + D_delta_x_4*h_x_w_carriage_1y + D_delta_y_4*h_y_w_carriage_1y + D_delta_z_4*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 28] = (
        D_delta_rx_5*h_rx_w_carriage_1y + D_delta_ry_5*h_ry_w_carriage_1y + D_delta_rz_5*h_rz_w_carriage_1y
        + D_delta_x_5*h_x_w_carriage_1y + D_delta_y_5*h_y_w_carriage_1y + D_delta_z_5*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 29] = (
        D_delta_rx_6*h_rx_w_carriage_1y + D_delta_ry_6*h_ry_w_carriage_1y + D_delta_rz_6*h_rz_w_carriage_1y
        + D_delta_x_6*h_x_w_carriage_1y + D_delta_y_6*h_y_w_carriage_1y + D_delta_z_6*h_z_w_carriage_1y
    )
    M_wq_out[..., 1, 30] = t306
    M_wq_out[..., 1, 36] = D_delta_ry_8*t299 - D_delta_rz_8*t300 + D_delta_x_8*t301 + h_x_w_carriage_1y
    M_wq_out[..., 1, 37] = (
        -D_delta_rx_8*t299 + D_delta_rz_8*t303 + D_delta_y_8*t301 + h_y_w_carriage_1y + t302
    )
    M_wq_out[..., 1, 38] = D_delta_rx_8*t300 - D_delta_ry_8*t303 + D_delta_z_8*t301 + h_z_w_carriage_1y
    M_wq_out[..., 2, 0] = (
        D_delta_rx_9*t255 + D_delta_ry_9*t256 + D_delta_rz_9*t257 + D_delta_x_9*t304 + D_delta_y_9*t259
        + D_p_rx_1*h_rx_w_carriage_1z + D_p_ry_1*h_ry_w_carriage_1z + D_p_rz_1*h_rz_w_carriage_1z
        + D_p_x_1*h_x_w_carriage_1z + D_p_y_1*h_y_w_carriage_1z + D_p_z_1*h_z_w_carriage_1z + m_t_1*n_1_z
        + n_1_z*t183 + n_1_z*t308 + t309
    )
    M_wq_out[..., 2, 1] = (
        D_delta_rx_9*t268 + D_delta_ry_9*t269 + D_delta_rz_9*t270 + D_delta_x_9*t265 + D_delta_y_9*t266
        + D_delta_z_9*t267 + D_p_rx_2*h_rx_w_carriage_1z + D_p_ry_2*h_ry_w_carriage_1z
        + D_p_rz_2*h_rz_w_carriage_1z + D_p_x_2*h_x_w_carriage_1z + D_p_y_2*h_y_w_carriage_1z
        + D_p_z_2*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 2] = (
        D_delta_rx_9*t274 + D_delta_ry_9*t275 + D_delta_rz_9*t276 + D_delta_x_9*t271 + D_delta_y_9*t272
        + D_delta_z_9*t273 + D_p_rx_3*h_rx_w_carriage_1z + D_p_ry_3*h_ry_w_carriage_1z
        + D_p_rz_3*h_rz_w_carriage_1z + D_p_x_3*h_x_w_carriage_1z + D_p_y_3*h_y_w_carriage_1z
        + D_p_z_3*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 3] = (
        D_delta_rx_9*t280 + D_delta_ry_9*t281 + D_delta_rz_9*t282 + D_delta_x_9*t277 + D_delta_y_9*t278
        + D_delta_z_9*t279 + D_p_rx_4*h_rx_w_carriage_1z + D_p_ry_4*h_ry_w_carriage_1z
        + D_p_rz_4*h_rz_w_carriage_1z + D_p_x_4*h_x_w_carriage_1z + D_p_y_4*h_y_w_carriage_1z
        + D_p_z_4*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 4] = (
        D_delta_rx_9*t286 + D_delta_ry_9*t287 + D_delta_rz_9*t288 + D_delta_x_9*t283 + D_delta_y_9*t284
        + D_delta_z_9*t285 + D_p_rx_5*h_rx_w_carriage_1z + D_p_ry_5*h_ry_w_carriage_1z
        + D_p_rz_5*h_rz_w_carriage_1z + D_p_x_5*h_x_w_carriage_1z + D_p_y_5*h_y_w_carriage_1z
        + D_p_z_5*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 5] = (
        D_delta_rx_9*t292 + D_delta_ry_9*t293 + D_delta_rz_9*t294 + D_delta_x_9*t289 + D_delta_y_9*t290
        + D_delta_z_9*t291 + D_p_rx_6*h_rx_w_carriage_1z + D_p_ry_6*h_ry_w_carriage_1z
        + D_p_rz_6*h_rz_w_carriage_1z + D_p_x_6*h_x_w_carriage_1z + D_p_y_6*h_y_w_carriage_1z
        + D_p_z_6*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 6] = t296*t310
    M_wq_out[..., 2, 12] = t298*t310
    M_wq_out[..., 2, 24] = (
        D_delta_rx_1*h_rx_w_carriage_1z + D_delta_ry_1*h_ry_w_carriage_1z + D_delta_rz_1*h_rz_w_carriage_1z
        + D_delta_x_1*h_x_w_carriage_1z + D_delta_y_1*h_y_w_carriage_1z + D_delta_z_1*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 25] = (
        D_delta_rx_2*h_rx_w_carriage_1z + D_delta_ry_2*h_ry_w_carriage_1z + D_delta_rz_2*h_rz_w_carriage_1z
        + D_delta_x_2*h_x_w_carriage_1z + D_delta_y_2*h_y_w_carriage_1z + D_delta_z_2*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 26] = (
        D_delta_rx_3*h_rx_w_carriage_1z + D_delta_ry_3*h_ry_w_carriage_1z + D_delta_rz_3*h_rz_w_carriage_1z
        + D_delta_x_3*h_x_w_carriage_1z + D_delta_y_3*h_y_w_carriage_1z + D_delta_z_3*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 27] = (
        D_delta_rx_4*h_rx_w_carriage_1z + D_delta_ry_4*h_ry_w_carriage_1z + D_delta_rz_4*h_rz_w_carriage_1z
        + D_delta_x_4*h_x_w_carriage_1z + D_delta_y_4*h_y_w_carriage_1z + D_delta_z_4*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 28] = (
        D_delta_rx_5*h_rx_w_carriage_1z + D_delta_ry_5*h_ry_w_carriage_1z + D_delta_rz_5*h_rz_w_carriage_1z
        + D_delta_x_5*h_x_w_carriage_1z + D_delta_y_5*h_y_w_carriage_1z + D_delta_z_5*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 29] = (
        D_delta_rx_6*h_rx_w_carriage_1z + D_delta_ry_6*h_ry_w_carriage_1z + D_delta_rz_6*h_rz_w_carriage_1z
        + D_delta_x_6*h_x_w_carriage_1z + D_delta_y_6*h_y_w_carriage_1z + D_delta_z_6*h_z_w_carriage_1z
    )
    M_wq_out[..., 2, 30] = t309
    M_wq_out[..., 2, 36] = D_delta_ry_9*t299 - D_delta_rz_9*t300 + D_delta_x_9*t301 + h_x_w_carriage_1z
    M_wq_out[..., 2, 37] = -D_delta_rx_9*t299 + D_delta_rz_9*t303 + D_delta_y_9*t301 + h_y_w_carriage_1z
    M_wq_out[..., 2, 38] = D_delta_rx_9*t300 - D_delta_ry_9*t303 + D_delta_z_9*t301 + h_z_w_carriage_1z + t302
    M_wq_out[..., 3, 0] = (
        D_delta_rx_10*t255 + D_delta_ry_10*t256 + D_delta_rz_10*t257 + D_delta_x_10*t304 + D_delta_y_10*t259
        + D_delta_z_10*t260 + D_p_rx_1*h_rx_w_carriage_2x + D_p_ry_1*h_ry_w_carriage_2x
        + D_p_rz_1*h_rz_w_carriage_2x + D_p_x_1*h_x_w_carriage_2x + D_p_y_1*h_y_w_carriage_2x
        + D_p_z_1*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 1] = (
        D_delta_rx_10*t268 + D_delta_ry_10*t269 + D_delta_rz_10*t270 + D_delta_y_10*t266 + D_delta_z_10*t267
        + D_p_rx_2*h_rx_w_carriage_2x + D_p_ry_2*h_ry_w_carriage_2x + D_p_rz_2*h_rz_w_carriage_2x
        + D_p_x_2*h_x_w_carriage_2x + D_p_y_2*h_y_w_carriage_2x + D_p_z_2*h_z_w_carriage_2x + m_t_2*n_2_x
        + n_2_x*t184 + n_2_x*t311 + t314
    )
    M_wq_out[..., 3, 2] = (
        D_delta_rx_10*t274 + D_delta_ry_10*t275 + D_delta_rz_10*t276 + D_delta_x_10*t271 + D_delta_y_10*t272
        + D_delta_z_10*t273 + D_p_rx_3*h_rx_w_carriage_2x + D_p_ry_3*h_ry_w_carriage_2x
        + D_p_rz_3*h_rz_w_carriage_2x + D_p_x_3*h_x_w_carriage_2x + D_p_y_3*h_y_w_carriage_2x
        + D_p_z_3*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 3] = (
        D_delta_rx_10*t280 + D_delta_ry_10*t281 + D_delta_rz_10*t282 + D_delta_x_10*t277 + D_delta_y_10*t278
        + D_delta_z_10*t279 + D_p_rx_4*h_rx_w_carriage_2x + D_p_ry_4*h_ry_w_carriage_2x
        + D_p_rz_4*h_rz_w_carriage_2x + D_p_x_4*h_x_w_carriage_2x + D_p_y_4*h_y_w_carriage_2x
        + D_p_z_4*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 4] = (
        D_delta_rx_10*t286 + D_delta_ry_10*t287 + D_delta_rz_10*t288 + D_delta_x_10*t283 + D_delta_y_10*t284
        + D_delta_z_10*t285 + D_p_rx_5*h_rx_w_carriage_2x + D_p_ry_5*h_ry_w_carriage_2x
        + D_p_rz_5*h_rz_w_carriage_2x + D_p_x_5*h_x_w_carriage_2x + D_p_y_5*h_y_w_carriage_2x
        + D_p_z_5*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 5] = (
        D_delta_rx_10*t292 + D_delta_ry_10*t293 + D_delta_rz_10*t294 + D_delta_x_10*t289 + D_delta_y_10*t290
        + D_delta_z_10*t291 + D_p_rx_6*h_rx_w_carriage_2x + D_p_ry_6*h_ry_w_carriage_2x
        + D_p_rz_6*h_rz_w_carriage_2x + D_p_x_6*h_x_w_carriage_2x + D_p_y_6*h_y_w_carriage_2x
        + D_p_z_6*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 7] = t315*t316
    M_wq_out[..., 3, 13] = t316*t317
    M_wq_out[..., 3, 24] = (
        D_delta_rx_1*h_rx_w_carriage_2x + D_delta_ry_1*h_ry_w_carriage_2x + D_delta_rz_1*h_rz_w_carriage_2x
        + D_delta_x_1*h_x_w_carriage_2x + D_delta_y_1*h_y_w_carriage_2x + D_delta_z_1*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 25] = (
        D_delta_rx_2*h_rx_w_carriage_2x + D_delta_ry_2*h_ry_w_carriage_2x + D_delta_rz_2*h_rz_w_carriage_2x
        + D_delta_x_2*h_x_w_carriage_2x + D_delta_y_2*h_y_w_carriage_2x + D_delta_z_2*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 26] = (
        D_delta_rx_3*h_rx_w_carriage_2x + D_delta_ry_3*h_ry_w_carriage_2x + D_delta_rz_3*h_rz_w_carriage_2x
        + D_delta_x_3*h_x_w_carriage_2x + D_delta_y_3*h_y_w_carriage_2x + D_delta_z_3*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 27] = (
        D_delta_rx_4*h_rx_w_carriage_2x + D_delta_ry_4*h_ry_w_carriage_2x + D_delta_rz_4*h_rz_w_carriage_2x
        + D_delta_x_4*h_x_w_carriage_2x + D_delta_y_4*h_y_w_carriage_2x + D_delta_z_4*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 28] = (
        D_delta_rx_5*h_rx_w_carriage_2x + D_delta_ry_5*h_ry_w_carriage_2x + D_delta_rz_5*h_rz_w_carriage_2x
        + D_delta_x_5*h_x_w_carriage_2x + D_delta_y_5*h_y_w_carriage_2x + D_delta_z_5*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 29] = (
        D_delta_rx_6*h_rx_w_carriage_2x + D_delta_ry_6*h_ry_w_carriage_2x + D_delta_rz_6*h_rz_w_carriage_2x
        + D_delta_x_6*h_x_w_carriage_2x + D_delta_y_6*h_y_w_carriage_2x + D_delta_z_6*h_z_w_carriage_2x
    )
    M_wq_out[..., 3, 31] = t314
    M_wq_out[..., 3, 36] = (
        D_delta_ry_10*t299 - D_delta_rz_10*t300 + D_delta_x_10*t301 + h_x_w_carriage_2x + t318
    )
    M_wq_out[..., 3, 37] = -D_delta_rx_10*t299 + D_delta_rz_10*t303 + D_delta_y_10*t301 + h_y_w_carriage_2x
    M_wq_out[..., 3, 38] = D_delta_rx_10*t300 - D_delta_ry_10*t303 + D_delta_z_10*t301 + h_z_w_carriage_2x
    M_wq_out[..., 4, 0] = (
        D_delta_rx_11*t255 + D_delta_ry_11*t256 + D_delta_rz_11*t257 + D_delta_x_11*t304 + D_delta_y_11*t259
        + D_delta_z_11*t260 + D_p_rx_1*h_rx_w_carriage_2y + D_p_ry_1*h_ry_w_carriage_2y
        + D_p_rz_1*h_rz_w_carriage_2y + D_p_x_1*h_x_w_carriage_2y + D_p_y_1*h_y_w_carriage_2y
        + D_p_z_1*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 1] = (
        D_delta_rx_11*t268 + D_delta_ry_11*t269 + D_delta_rz_11*t270 + D_delta_x_11*t265 + D_delta_z_11*t267
        + D_p_rx_2*h_rx_w_carriage_2y + D_p_ry_2*h_ry_w_carriage_2y + D_p_rz_2*h_rz_w_carriage_2y
        + D_p_x_2*h_x_w_carriage_2y + D_p_y_2*h_y_w_carriage_2y + D_p_z_2*h_z_w_carriage_2y + m_t_2*n_2_y
        + n_2_y*t184 + n_2_y*t319 + t320
    )
    M_wq_out[..., 4, 2] = (
        D_delta_rx_11*t274 + D_delta_ry_11*t275 + D_delta_rz_11*t276 + D_delta_x_11*t271 + D_delta_y_11*t272
        + D_delta_z_11*t273 + D_p_rx_3*h_rx_w_carriage_2y + D_p_ry_3*h_ry_w_carriage_2y
        + D_p_rz_3*h_rz_w_carriage_2y + D_p_x_3*h_x_w_carriage_2y + D_p_y_3*h_y_w_carriage_2y
        + D_p_z_3*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 3] = (
        D_delta_rx_11*t280 + D_delta_ry_11*t281 + D_delta_rz_11*t282 + D_delta_x_11*t277 + D_delta_y_11*t278
        + D_delta_z_11*t279 + D_p_rx_4*h_rx_w_carriage_2y + D_p_ry_4*h_ry_w_carriage_2y
        + D_p_rz_4*h_rz_w_carriage_2y + D_p_x_4*h_x_w_carriage_2y + D_p_y_4*h_y_w_carriage_2y
        + D_p_z_4*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 4] = (
        D_delta_rx_11*t286 + D_delta_ry_11*t287 + D_delta_rz_11*t288 + D_delta_x_11*t283 + D_delta_y_11*t284
        + D_delta_z_11*t285 + D_p_rx_5*h_rx_w_carriage_2y + D_p_ry_5*h_ry_w_carriage_2y
        + D_p_rz_5*h_rz_w_carriage_2y + D_p_x_5*h_x_w_carriage_2y + D_p_y_5*h_y_w_carriage_2y
        + D_p_z_5*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 5] = (
        D_delta_rx_11*t292 + D_delta_ry_11*t293 + D_delta_rz_11*t294 + D_delta_x_11*t289 + D_delta_y_11*t290
        + D_delta_z_11*t291 + D_p_rx_6*h_rx_w_carriage_2y + D_p_ry_6*h_ry_w_carriage_2y
        + D_p_rz_6*h_rz_w_carriage_2y + D_p_x_6*h_x_w_carriage_2y + D_p_y_6*h_y_w_carriage_2y
        + D_p_z_6*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 7] = t315*t321
    M_wq_out[..., 4, 13] = t317*t321
    M_wq_out[..., 4, 24] = (
        D_delta_rx_1*h_rx_w_carriage_2y + D_delta_ry_1*h_ry_w_carriage_2y + D_delta_rz_1*h_rz_w_carriage_2y
        + D_delta_x_1*h_x_w_carriage_2y + D_delta_y_1*h_y_w_carriage_2y + D_delta_z_1*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 25] = (
        D_delta_rx_2*h_rx_w_carriage_2y + D_delta_ry_2*h_ry_w_carriage_2y + D_delta_rz_2*h_rz_w_carriage_2y
        + D_delta_x_2*h_x_w_carriage_2y + D_delta_y_2*h_y_w_carriage_2y + D_delta_z_2*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 26] = (
        D_delta_rx_3*h_rx_w_carriage_2y + D_delta_ry_3*h_ry_w_carriage_2y + D_delta_rz_3*h_rz_w_carriage_2y
        + D_delta_x_3*h_x_w_carriage_2y + D_delta_y_3*h_y_w_carriage_2y + D_delta_z_3*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 27] = (
        D_delta_rx_4*h_rx_w_carriage_2y + D_delta_ry_4*h_ry_w_carriage_2y + D_delta_rz_4*h_rz_w_carriage_2y
        + D_delta_x_4*h_x_w_carriage_2y + D_delta_y_4*h_y_w_carriage_2y + D_delta_z_4*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 28] = (
        D_delta_rx_5*h_rx_w_carriage_2y + D_delta_ry_5*h_ry_w_carriage_2y + D_delta_rz_5*h_rz_w_carriage_2y
        + D_delta_x_5*h_x_w_carriage_2y + D_delta_y_5*h_y_w_carriage_2y + D_delta_z_5*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 29] = (
        D_delta_rx_6*h_rx_w_carriage_2y + D_delta_ry_6*h_ry_w_carriage_2y + D_delta_rz_6*h_rz_w_carriage_2y
        + D_delta_x_6*h_x_w_carriage_2y + D_delta_y_6*h_y_w_carriage_2y + D_delta_z_6*h_z_w_carriage_2y
    )
    M_wq_out[..., 4, 31] = t320
    M_wq_out[..., 4, 36] = D_delta_ry_11*t299 - D_delta_rz_11*t300 + D_delta_x_11*t301 + h_x_w_carriage_2y
    M_wq_out[..., 4, 37] = (
        -D_delta_rx_11*t299 + D_delta_rz_11*t303 + D_delta_y_11*t301 + h_y_w_carriage_2y + t318
    )
    M_wq_out[..., 4, 38] = D_delta_rx_11*t300 - D_delta_ry_11*t303 + D_delta_z_11*t301 + h_z_w_carriage_2y
    M_wq_out[..., 5, 0] = (
        D_delta_rx_12*t255 + D_delta_ry_12*t256 + D_delta_rz_12*t257 + D_delta_x_12*t304 + D_delta_y_12*t259
        + D_delta_z_12*t260 + D_p_rx_1*h_rx_w_carriage_2z + D_p_ry_1*h_ry_w_carriage_2z
        + D_p_rz_1*h_rz_w_carriage_2z + D_p_x_1*h_x_w_carriage_2z + D_p_y_1*h_y_w_carriage_2z
        + D_p_z_1*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 1] = (
        D_delta_rx_12*t268 + D_delta_ry_12*t269 + D_delta_rz_12*t270 + D_delta_x_12*t265 + D_delta_y_12*t266
        + D_p_rx_2*h_rx_w_carriage_2z + D_p_ry_2*h_ry_w_carriage_2z + D_p_rz_2*h_rz_w_carriage_2z
        + D_p_x_2*h_x_w_carriage_2z + D_p_y_2*h_y_w_carriage_2z + D_p_z_2*h_z_w_carriage_2z + m_t_2*n_2_z
        + n_2_z*t184 + n_2_z*t322 + t323
    )
    M_wq_out[..., 5, 2] = (
        D_delta_rx_12*t274 + D_delta_ry_12*t275 + D_delta_rz_12*t276 + D_delta_x_12*t271 + D_delta_y_12*t272
        + D_delta_z_12*t273 + D_p_rx_3*h_rx_w_carriage_2z + D_p_ry_3*h_ry_w_carriage_2z
        + D_p_rz_3*h_rz_w_carriage_2z + D_p_x_3*h_x_w_carriage_2z + D_p_y_3*h_y_w_carriage_2z
        + D_p_z_3*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 3] = (
        D_delta_rx_12*t280 + D_delta_ry_12*t281 + D_delta_rz_12*t282 + D_delta_x_12*t277 + D_delta_y_12*t278
        + D_delta_z_12*t279 + D_p_rx_4*h_rx_w_carriage_2z + D_p_ry_4*h_ry_w_carriage_2z
        + D_p_rz_4*h_rz_w_carriage_2z + D_p_x_4*h_x_w_carriage_2z + D_p_y_4*h_y_w_carriage_2z
        + D_p_z_4*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 4] = (
        D_delta_rx_12*t286 + D_delta_ry_12*t287 + D_delta_rz_12*t288 + D_delta_x_12*t283 + D_delta_y_12*t284
        + D_delta_z_12*t285 + D_p_rx_5*h_rx_w_carriage_2z + D_p_ry_5*h_ry_w_carriage_2z
        + D_p_rz_5*h_rz_w_carriage_2z + D_p_x_5*h_x_w_carriage_2z + D_p_y_5*h_y_w_carriage_2z
        + D_p_z_5*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 5] = (
        D_delta_rx_12*t292 + D_delta_ry_12*t293 + D_delta_rz_12*t294 + D_delta_x_12*t289 + D_delta_y_12*t290
        + D_delta_z_12*t291 + D_p_rx_6*h_rx_w_carriage_2z + D_p_ry_6*h_ry_w_carriage_2z
        + D_p_rz_6*h_rz_w_carriage_2z + D_p_x_6*h_x_w_carriage_2z + D_p_y_6*h_y_w_carriage_2z
        + D_p_z_6*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 7] = t315*t324
    M_wq_out[..., 5, 13] = t317*t324
    M_wq_out[..., 5, 24] = (
        D_delta_rx_1*h_rx_w_carriage_2z + D_delta_ry_1*h_ry_w_carriage_2z + D_delta_rz_1*h_rz_w_carriage_2z
        + D_delta_x_1*h_x_w_carriage_2z + D_delta_y_1*h_y_w_carriage_2z + D_delta_z_1*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 25] = (
        D_delta_rx_2*h_rx_w_carriage_2z + D_delta_ry_2*h_ry_w_carriage_2z + D_delta_rz_2*h_rz_w_carriage_2z
        + D_delta_x_2*h_x_w_carriage_2z + D_delta_y_2*h_y_w_carriage_2z + D_delta_z_2*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 26] = (
        D_delta_rx_3*h_rx_w_carriage_2z + D_delta_ry_3*h_ry_w_carriage_2z + D_delta_rz_3*h_rz_w_carriage_2z
        + D_delta_x_3*h_x_w_carriage_2z + D_delta_y_3*h_y_w_carriage_2z + D_delta_z_3*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 27] = (
        D_delta_rx_4*h_rx_w_carriage_2z + D_delta_ry_4*h_ry_w_carriage_2z + D_delta_rz_4*h_rz_w_carriage_2z
        + D_delta_x_4*h_x_w_carriage_2z + D_delta_y_4*h_y_w_carriage_2z + D_delta_z_4*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 28] = (
        D_delta_rx_5*h_rx_w_carriage_2z + D_delta_ry_5*h_ry_w_carriage_2z + D_delta_rz_5*h_rz_w_carriage_2z
        + D_delta_x_5*h_x_w_carriage_2z + D_delta_y_5*h_y_w_carriage_2z + D_delta_z_5*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 29] = (
        D_delta_rx_6*h_rx_w_carriage_2z + D_delta_ry_6*h_ry_w_carriage_2z + D_delta_rz_6*h_rz_w_carriage_2z
        + D_delta_x_6*h_x_w_carriage_2z + D_delta_y_6*h_y_w_carriage_2z + D_delta_z_6*h_z_w_carriage_2z
    )
    M_wq_out[..., 5, 31] = t323
    M_wq_out[..., 5, 36] = D_delta_ry_12*t299 - D_delta_rz_12*t300 + D_delta_x_12*t301 + h_x_w_carriage_2z
    M_wq_out[..., 5, 37] = -D_delta_rx_12*t299 + D_delta_rz_12*t303 + D_delta_y_12*t301 + h_y_w_carriage_2z
    M_wq_out[..., 5, 38] = (
        D_delta_rx_12*t300 - D_delta_ry_12*t303 + D_delta_z_12*t301 + h_z_w_carriage_2z + t318
    )
    M_wq_out[..., 6, 0] = (
        D_delta_rx_13*t255 + D_delta_ry_13*t256 + D_delta_rz_13*t257 + D_delta_x_13*t304 + D_delta_y_13*t259
        + D_delta_z_13*t260 + D_p_rx_1*h_rx_w_carriage_3x + D_p_ry_1*h_ry_w_carriage_3x
        + D_p_rz_1*h_rz_w_carriage_3x + D_p_x_1*h_x_w_carriage_3x + D_p_y_1*h_y_w_carriage_3x
        + D_p_z_1*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 1] = (
        D_delta_rx_13*t268 + D_delta_ry_13*t269 + D_delta_rz_13*t270 + D_delta_x_13*t265 + D_delta_y_13*t266
        + D_delta_z_13*t267 + D_p_rx_2*h_rx_w_carriage_3x + D_p_ry_2*h_ry_w_carriage_3x
        + D_p_rz_2*h_rz_w_carriage_3x + D_p_x_2*h_x_w_carriage_3x + D_p_y_2*h_y_w_carriage_3x
        + D_p_z_2*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 2] = (
        D_delta_rx_13*t274 + D_delta_ry_13*t275 + D_delta_rz_13*t276 + D_delta_y_13*t272 + D_delta_z_13*t273
        + D_p_rx_3*h_rx_w_carriage_3x + D_p_ry_3*h_ry_w_carriage_3x + D_p_rz_3*h_rz_w_carriage_3x
        + D_p_x_3*h_x_w_carriage_3x + D_p_y_3*h_y_w_carriage_3x + D_p_z_3*h_z_w_carriage_3x + m_t_3*n_3_x
        + n_3_x*t185 + n_3_x*t325 + t328
    )
    M_wq_out[..., 6, 3] = (
        D_delta_rx_13*t280 + D_delta_ry_13*t281 + D_delta_rz_13*t282 + D_delta_x_13*t277 + D_delta_y_13*t278
        + D_delta_z_13*t279 + D_p_rx_4*h_rx_w_carriage_3x + D_p_ry_4*h_ry_w_carriage_3x
        + D_p_rz_4*h_rz_w_carriage_3x + D_p_x_4*h_x_w_carriage_3x + D_p_y_4*h_y_w_carriage_3x
        + D_p_z_4*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 4] = (
        D_delta_rx_13*t286 + D_delta_ry_13*t287 + D_delta_rz_13*t288 + D_delta_x_13*t283 + D_delta_y_13*t284
        + D_delta_z_13*t285 + D_p_rx_5*h_rx_w_carriage_3x + D_p_ry_5*h_ry_w_carriage_3x
        + D_p_rz_5*h_rz_w_carriage_3x + D_p_x_5*h_x_w_carriage_3x + D_p_y_5*h_y_w_carriage_3x
        + D_p_z_5*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 5] = (
        D_delta_rx_13*t292 + D_delta_ry_13*t293 + D_delta_rz_13*t294 + D_delta_x_13*t289 + D_delta_y_13*t290
        + D_delta_z_13*t291 + D_p_rx_6*h_rx_w_carriage_3x + D_p_ry_6*h_ry_w_carriage_3x
        + D_p_rz_6*h_rz_w_carriage_3x + D_p_x_6*h_x_w_carriage_3x + D_p_y_6*h_y_w_carriage_3x
        + D_p_z_6*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 8] = t329*t330
    M_wq_out[..., 6, 14] = t330*t331
    M_wq_out[..., 6, 24] = (
        D_delta_rx_1*h_rx_w_carriage_3x + D_delta_ry_1*h_ry_w_carriage_3x + D_delta_rz_1*h_rz_w_carriage_3x
        + D_delta_x_1*h_x_w_carriage_3x + D_delta_y_1*h_y_w_carriage_3x + D_delta_z_1*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 25] = (
        D_delta_rx_2*h_rx_w_carriage_3x + D_delta_ry_2*h_ry_w_carriage_3x + D_delta_rz_2*h_rz_w_carriage_3x
        + D_delta_x_2*h_x_w_carriage_3x + D_delta_y_2*h_y_w_carriage_3x + D_delta_z_2*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 26] = (
        D_delta_rx_3*h_rx_w_carriage_3x + D_delta_ry_3*h_ry_w_carriage_3x + D_delta_rz_3*h_rz_w_carriage_3x
        + D_delta_x_3*h_x_w_carriage_3x + D_delta_y_3*h_y_w_carriage_3x + D_delta_z_3*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 27] = (
        D_delta_rx_4*h_rx_w_carriage_3x + D_delta_ry_4*h_ry_w_carriage_3x + D_delta_rz_4*h_rz_w_carriage_3x
        + D_delta_x_4*h_x_w_carriage_3x + D_delta_y_4*h_y_w_carriage_3x + D_delta_z_4*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 28] = (
        D_delta_rx_5*h_rx_w_carriage_3x + D_delta_ry_5*h_ry_w_carriage_3x + D_delta_rz_5*h_rz_w_carriage_3x
        + D_delta_x_5*h_x_w_carriage_3x + D_delta_y_5*h_y_w_carriage_3x + D_delta_z_5*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 29] = (
        D_delta_rx_6*h_rx_w_carriage_3x + D_delta_ry_6*h_ry_w_carriage_3x + D_delta_rz_6*h_rz_w_carriage_3x
        + D_delta_x_6*h_x_w_carriage_3x + D_delta_y_6*h_y_w_carriage_3x + D_delta_z_6*h_z_w_carriage_3x
    )
    M_wq_out[..., 6, 32] = t328
    M_wq_out[..., 6, 36] = (
        D_delta_ry_13*t299 - D_delta_rz_13*t300 + D_delta_x_13*t301 + h_x_w_carriage_3x + t332
    )
    M_wq_out[..., 6, 37] = -D_delta_rx_13*t299 + D_delta_rz_13*t303 + D_delta_y_13*t301 + h_y_w_carriage_3x
    M_wq_out[..., 6, 38] = D_delta_rx_13*t300 - D_delta_ry_13*t303 + D_delta_z_13*t301 + h_z_w_carriage_3x
    M_wq_out[..., 7, 0] = (
        D_delta_rx_14*t255 + D_delta_ry_14*t256 + D_delta_rz_14*t257 + D_delta_x_14*t304 + D_delta_y_14*t259
        + D_delta_z_14*t260 + D_p_rx_1*h_rx_w_carriage_3y + D_p_ry_1*h_ry_w_carriage_3y
        + D_p_rz_1*h_rz_w_carriage_3y + D_p_x_1*h_x_w_carriage_3y + D_p_y_1*h_y_w_carriage_3y
        + D_p_z_1*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 1] = (
        D_delta_rx_14*t268 + D_delta_ry_14*t269 + D_delta_rz_14*t270 + D_delta_x_14*t265 + D_delta_y_14*t266
        + D_delta_z_14*t267 + D_p_rx_2*h_rx_w_carriage_3y + D_p_ry_2*h_ry_w_carriage_3y
        + D_p_rz_2*h_rz_w_carriage_3y + D_p_x_2*h_x_w_carriage_3y + D_p_y_2*h_y_w_carriage_3y
        + D_p_z_2*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 2] = (
        D_delta_rx_14*t274 + D_delta_ry_14*t275 + D_delta_rz_14*t276 + D_delta_x_14*t271 + D_delta_z_14*t273
        + D_p_rx_3*h_rx_w_carriage_3y + D_p_ry_3*h_ry_w_carriage_3y + D_p_rz_3*h_rz_w_carriage_3y
        + D_p_x_3*h_x_w_carriage_3y + D_p_y_3*h_y_w_carriage_3y + D_p_z_3*h_z_w_carriage_3y + m_t_3*n_3_y
        + n_3_y*t185 + n_3_y*t333 + t334
    )
    M_wq_out[..., 7, 3] = (
        D_delta_rx_14*t280 + D_delta_ry_14*t281 + D_delta_rz_14*t282 + D_delta_x_14*t277 + D_delta_y_14*t278
        + D_delta_z_14*t279 + D_p_rx_4*h_rx_w_carriage_3y + D_p_ry_4*h_ry_w_carriage_3y
        + D_p_rz_4*h_rz_w_carriage_3y + D_p_x_4*h_x_w_carriage_3y + D_p_y_4*h_y_w_carriage_3y
        + D_p_z_4*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 4] = (
        D_delta_rx_14*t286 + D_delta_ry_14*t287 + D_delta_rz_14*t288 + D_delta_x_14*t283 + D_delta_y_14*t284
        + D_delta_z_14*t285 + D_p_rx_5*h_rx_w_carriage_3y + D_p_ry_5*h_ry_w_carriage_3y
        + D_p_rz_5*h_rz_w_carriage_3y + D_p_x_5*h_x_w_carriage_3y + D_p_y_5*h_y_w_carriage_3y
        + D_p_z_5*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 5] = (
        D_delta_rx_14*t292 + D_delta_ry_14*t293 + D_delta_rz_14*t294 + D_delta_x_14*t289 + D_delta_y_14*t290
        + D_delta_z_14*t291 + D_p_rx_6*h_rx_w_carriage_3y + D_p_ry_6*h_ry_w_carriage_3y
        + D_p_rz_6*h_rz_w_carriage_3y + D_p_x_6*h_x_w_carriage_3y + D_p_y_6*h_y_w_carriage_3y
        + D_p_z_6*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 8] = t329*t335
    M_wq_out[..., 7, 14] = t331*t335
    M_wq_out[..., 7, 24] = (
        D_delta_rx_1*h_rx_w_carriage_3y + D_delta_ry_1*h_ry_w_carriage_3y + D_delta_rz_1*h_rz_w_carriage_3y
        + D_delta_x_1*h_x_w_carriage_3y + D_delta_y_1*h_y_w_carriage_3y + D_delta_z_1*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 25] = (
        D_delta_rx_2*h_rx_w_carriage_3y + D_delta_ry_2*h_ry_w_carriage_3y + D_delta_rz_2*h_rz_w_carriage_3y
        + D_delta_x_2*h_x_w_carriage_3y + D_delta_y_2*h_y_w_carriage_3y + D_delta_z_2*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 26] = (
        D_delta_rx_3*h_rx_w_carriage_3y + D_delta_ry_3*h_ry_w_carriage_3y + D_delta_rz_3*h_rz_w_carriage_3y
        + D_delta_x_3*h_x_w_carriage_3y + D_delta_y_3*h_y_w_carriage_3y + D_delta_z_3*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 27] = (
        D_delta_rx_4*h_rx_w_carriage_3y + D_delta_ry_4*h_ry_w_carriage_3y + D_delta_rz_4*h_rz_w_carriage_3y
        + D_delta_x_4*h_x_w_carriage_3y + D_delta_y_4*h_y_w_carriage_3y + D_delta_z_4*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 28] = (
        D_delta_rx_5*h_rx_w_carriage_3y + D_delta_ry_5*h_ry_w_carriage_3y + D_delta_rz_5*h_rz_w_carriage_3y
        + D_delta_x_5*h_x_w_carriage_3y + D_delta_y_5*h_y_w_carriage_3y + D_delta_z_5*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 29] = (
        D_delta_rx_6*h_rx_w_carriage_3y + D_delta_ry_6*h_ry_w_carriage_3y + D_delta_rz_6*h_rz_w_carriage_3y
        + D_delta_x_6*h_x_w_carriage_3y + D_delta_y_6*h_y_w_carriage_3y + D_delta_z_6*h_z_w_carriage_3y
    )
    M_wq_out[..., 7, 32] = t334
    M_wq_out[..., 7, 36] = D_delta_ry_14*t299 - D_delta_rz_14*t300 + D_delta_x_14*t301 + h_x_w_carriage_3y
    M_wq_out[..., 7, 37] = (
        -D_delta_rx_14*t299 + D_delta_rz_14*t303 + D_delta_y_14*t301 + h_y_w_carriage_3y + t332
    )
    M_wq_out[..., 7, 38] = D_delta_rx_14*t300 - D_delta_ry_14*t303 + D_delta_z_14*t301 + h_z_w_carriage_3y
    M_wq_out[..., 8, 0] = (
        D_delta_rx_15*t255 + D_delta_ry_15*t256 + D_delta_rz_15*t257 + D_delta_x_15*t304 + D_delta_y_15*t259
        + D_delta_z_15*t260 + D_p_rx_1*h_rx_w_carriage_3z + D_p_ry_1*h_ry_w_carriage_3z
        + D_p_rz_1*h_rz_w_carriage_3z + D_p_x_1*h_x_w_carriage_3z + D_p_y_1*h_y_w_carriage_3z
        + D_p_z_1*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 1] = (
        D_delta_rx_15*t268 + D_delta_ry_15*t269 + D_delta_rz_15*t270 + D_delta_x_15*t265 + D_delta_y_15*t266
        + D_delta_z_15*t267 + D_p_rx_2*h_rx_w_carriage_3z + D_p_ry_2*h_ry_w_carriage_3z
        + D_p_rz_2*h_rz_w_carriage_3z + D_p_x_2*h_x_w_carriage_3z + D_p_y_2*h_y_w_carriage_3z
        + D_p_z_2*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 2] = (
        D_delta_rx_15*t274 + D_delta_ry_15*t275 + D_delta_rz_15*t276 + D_delta_x_15*t271 + D_delta_y_15*t272
        + D_p_rx_3*h_rx_w_carriage_3z + D_p_ry_3*h_ry_w_carriage_3z + D_p_rz_3*h_rz_w_carriage_3z
        + D_p_x_3*h_x_w_carriage_3z + D_p_y_3*h_y_w_carriage_3z + D_p_z_3*h_z_w_carriage_3z + m_t_3*n_3_z
        + n_3_z*t185 + n_3_z*t336 + t337
    )
    M_wq_out[..., 8, 3] = (
        D_delta_rx_15*t280 + D_delta_ry_15*t281 + D_delta_rz_15*t282 + D_delta_x_15*t277 + D_delta_y_15*t278
        + D_delta_z_15*t279 + D_p_rx_4*h_rx_w_carriage_3z + D_p_ry_4*h_ry_w_carriage_3z
        + D_p_rz_4*h_rz_w_carriage_3z + D_p_x_4*h_x_w_carriage_3z + D_p_y_4*h_y_w_carriage_3z
        + D_p_z_4*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 4] = (
        D_delta_rx_15*t286 + D_delta_ry_15*t287 + D_delta_rz_15*t288 + D_delta_x_15*t283 + D_delta_y_15*t284
        + D_delta_z_15*t285 + D_p_rx_5*h_rx_w_carriage_3z + D_p_ry_5*h_ry_w_carriage_3z
        + D_p_rz_5*h_rz_w_carriage_3z + D_p_x_5*h_x_w_carriage_3z + D_p_y_5*h_y_w_carriage_3z
        + D_p_z_5*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 5] = (
        D_delta_rx_15*t292 + D_delta_ry_15*t293 + D_delta_rz_15*t294 + D_delta_x_15*t289 + D_delta_y_15*t290
        + D_delta_z_15*t291 + D_p_rx_6*h_rx_w_carriage_3z + D_p_ry_6*h_ry_w_carriage_3z
        + D_p_rz_6*h_rz_w_carriage_3z + D_p_x_6*h_x_w_carriage_3z + D_p_y_6*h_y_w_carriage_3z
        + D_p_z_6*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 8] = t329*t338
    M_wq_out[..., 8, 14] = t331*t338
    M_wq_out[..., 8, 24] = (
        D_delta_rx_1*h_rx_w_carriage_3z + D_delta_ry_1*h_ry_w_carriage_3z + D_delta_rz_1*h_rz_w_carriage_3z
        + D_delta_x_1*h_x_w_carriage_3z + D_delta_y_1*h_y_w_carriage_3z + D_delta_z_1*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 25] = (
        D_delta_rx_2*h_rx_w_carriage_3z + D_delta_ry_2*h_ry_w_carriage_3z + D_delta_rz_2*h_rz_w_carriage_3z
        + D_delta_x_2*h_x_w_carriage_3z + D_delta_y_2*h_y_w_carriage_3z + D_delta_z_2*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 26] = (
        D_delta_rx_3*h_rx_w_carriage_3z + D_delta_ry_3*h_ry_w_carriage_3z + D_delta_rz_3*h_rz_w_carriage_3z
        + D_delta_x_3*h_x_w_carriage_3z + D_delta_y_3*h_y_w_carriage_3z + D_delta_z_3*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 27] = (
        D_delta_rx_4*h_rx_w_carriage_3z + D_delta_ry_4*h_ry_w_carriage_3z + D_delta_rz_4*h_rz_w_carriage_3z
        + D_delta_x_4*h_x_w_carriage_3z + D_delta_y_4*h_y_w_carriage_3z + D_delta_z_4*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 28] = (
        D_delta_rx_5*h_rx_w_carriage_3z + D_delta_ry_5*h_ry_w_carriage_3z + D_delta_rz_5*h_rz_w_carriage_3z
        + D_delta_x_5*h_x_w_carriage_3z + D_delta_y_5*h_y_w_carriage_3z + D_delta_z_5*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 29] = (
        D_delta_rx_6*h_rx_w_carriage_3z + D_delta_ry_6*h_ry_w_carriage_3z + D_delta_rz_6*h_rz_w_carriage_3z
        + D_delta_x_6*h_x_w_carriage_3z + D_delta_y_6*h_y_w_carriage_3z + D_delta_z_6*h_z_w_carriage_3z
    )
    M_wq_out[..., 8, 32] = t337
    M_wq_out[..., 8, 36] = D_delta_ry_15*t299 - D_delta_rz_15*t300 + D_delta_x_15*t301 + h_x_w_carriage_3z
    M_wq_out[..., 8, 37] = -D_delta_rx_15*t299 + D_delta_rz_15*t303 + D_delta_y_15*t301 + h_y_w_carriage_3z
    M_wq_out[..., 8, 38] = (
        D_delta_rx_15*t300 - D_delta_ry_15*t303 + D_delta_z_15*t301 + h_z_w_carriage_3z + t332
    )
    M_wq_out[..., 9, 0] = (
        D_delta_rx_16*t255 + D_delta_ry_16*t256 + D_delta_rz_16*t257 + D_delta_x_16*t304 + D_delta_y_16*t259
        + D_delta_z_16*t260 + D_p_rx_1*h_rx_w_carriage_4x + D_p_ry_1*h_ry_w_carriage_4x
        + D_p_rz_1*h_rz_w_carriage_4x + D_p_x_1*h_x_w_carriage_4x + D_p_y_1*h_y_w_carriage_4x
        + D_p_z_1*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 1] = (
        D_delta_rx_16*t268 + D_delta_ry_16*t269 + D_delta_rz_16*t270 + D_delta_x_16*t265 + D_delta_y_16*t266
        + D_delta_z_16*t267 + D_p_rx_2*h_rx_w_carriage_4x + D_p_ry_2*h_ry_w_carriage_4x
        + D_p_rz_2*h_rz_w_carriage_4x + D_p_x_2*h_x_w_carriage_4x + D_p_y_2*h_y_w_carriage_4x
        + D_p_z_2*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 2] = (
        D_delta_rx_16*t274 + D_delta_ry_16*t275 + D_delta_rz_16*t276 + D_delta_x_16*t271 + D_delta_y_16*t272
        + D_delta_z_16*t273 + D_p_rx_3*h_rx_w_carriage_4x + D_p_ry_3*h_ry_w_carriage_4x
        + D_p_rz_3*h_rz_w_carriage_4x + D_p_x_3*h_x_w_carriage_4x + D_p_y_3*h_y_w_carriage_4x
        + D_p_z_3*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 3] = (
        D_delta_rx_16*t280 + D_delta_ry_16*t281 + D_delta_rz_16*t282 + D_delta_y_16*t278 + D_delta_z_16*t279
        + D_p_rx_4*h_rx_w_carriage_4x + D_p_ry_4*h_ry_w_carriage_4x + D_p_rz_4*h_rz_w_carriage_4x
        + D_p_x_4*h_x_w_carriage_4x + D_p_y_4*h_y_w_carriage_4x + D_p_z_4*h_z_w_carriage_4x + m_t_4*n_4_x
        + n_4_x*t186 + n_4_x*t339 + t342
    )
    M_wq_out[..., 9, 4] = (
        D_delta_rx_16*t286 + D_delta_ry_16*t287 + D_delta_rz_16*t288 + D_delta_x_16*t283 + D_delta_y_16*t284
        + D_delta_z_16*t285 + D_p_rx_5*h_rx_w_carriage_4x + D_p_ry_5*h_ry_w_carriage_4x
        + D_p_rz_5*h_rz_w_carriage_4x + D_p_x_5*h_x_w_carriage_4x + D_p_y_5*h_y_w_carriage_4x
        + D_p_z_5*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 5] = (
        D_delta_rx_16*t292 + D_delta_ry_16*t293 + D_delta_rz_16*t294 + D_delta_x_16*t289 + D_delta_y_16*t290
        + D_delta_z_16*t291 + D_p_rx_6*h_rx_w_carriage_4x + D_p_ry_6*h_ry_w_carriage_4x
        + D_p_rz_6*h_rz_w_carriage_4x + D_p_x_6*h_x_w_carriage_4x + D_p_y_6*h_y_w_carriage_4x
        + D_p_z_6*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 9] = t343*t344
    M_wq_out[..., 9, 15] = t344*t345
    M_wq_out[..., 9, 24] = (
        D_delta_rx_1*h_rx_w_carriage_4x + D_delta_ry_1*h_ry_w_carriage_4x + D_delta_rz_1*h_rz_w_carriage_4x
        + D_delta_x_1*h_x_w_carriage_4x + D_delta_y_1*h_y_w_carriage_4x + D_delta_z_1*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 25] = (
        D_delta_rx_2*h_rx_w_carriage_4x + D_delta_ry_2*h_ry_w_carriage_4x + D_delta_rz_2*h_rz_w_carriage_4x
        + D_delta_x_2*h_x_w_carriage_4x + D_delta_y_2*h_y_w_carriage_4x + D_delta_z_2*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 26] = (
        D_delta_rx_3*h_rx_w_carriage_4x + D_delta_ry_3*h_ry_w_carriage_4x + D_delta_rz_3*h_rz_w_carriage_4x
        + D_delta_x_3*h_x_w_carriage_4x + D_delta_y_3*h_y_w_carriage_4x + D_delta_z_3*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 27] = (
        D_delta_rx_4*h_rx_w_carriage_4x + D_delta_ry_4*h_ry_w_carriage_4x + D_delta_rz_4*h_rz_w_carriage_4x
        + D_delta_x_4*h_x_w_carriage_4x + D_delta_y_4*h_y_w_carriage_4x + D_delta_z_4*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 28] = (
        D_delta_rx_5*h_rx_w_carriage_4x + D_delta_ry_5*h_ry_w_carriage_4x + D_delta_rz_5*h_rz_w_carriage_4x
        + D_delta_x_5*h_x_w_carriage_4x + D_delta_y_5*h_y_w_carriage_4x + D_delta_z_5*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 29] = (
        D_delta_rx_6*h_rx_w_carriage_4x + D_delta_ry_6*h_ry_w_carriage_4x + D_delta_rz_6*h_rz_w_carriage_4x
        + D_delta_x_6*h_x_w_carriage_4x + D_delta_y_6*h_y_w_carriage_4x + D_delta_z_6*h_z_w_carriage_4x
    )
    M_wq_out[..., 9, 33] = t342
    M_wq_out[..., 9, 36] = (
        D_delta_ry_16*t299 - D_delta_rz_16*t300 + D_delta_x_16*t301 + h_x_w_carriage_4x + t346
    )
    M_wq_out[..., 9, 37] = -D_delta_rx_16*t299 + D_delta_rz_16*t303 + D_delta_y_16*t301 + h_y_w_carriage_4x
    M_wq_out[..., 9, 38] = D_delta_rx_16*t300 - D_delta_ry_16*t303 + D_delta_z_16*t301 + h_z_w_carriage_4x
    M_wq_out[..., 10, 0] = (
        D_delta_rx_17*t255 + D_delta_ry_17*t256 + D_delta_rz_17*t257 + D_delta_x_17*t304 + D_delta_y_17*t259
        + D_delta_z_17*t260 + D_p_rx_1*h_rx_w_carriage_4y + D_p_ry_1*h_ry_w_carriage_4y
        + D_p_rz_1*h_rz_w_carriage_4y + D_p_x_1*h_x_w_carriage_4y + D_p_y_1*h_y_w_carriage_4y
        + D_p_z_1*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 1] = (
        D_delta_rx_17*t268 + D_delta_ry_17*t269 + D_delta_rz_17*t270 + D_delta_x_17*t265 + D_delta_y_17*t266
        + D_delta_z_17*t267 + D_p_rx_2*h_rx_w_carriage_4y + D_p_ry_2*h_ry_w_carriage_4y
        + D_p_rz_2*h_rz_w_carriage_4y + D_p_x_2*h_x_w_carriage_4y + D_p_y_2*h_y_w_carriage_4y
        + D_p_z_2*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 2] = (
        D_delta_rx_17*t274 + D_delta_ry_17*t275 + D_delta_rz_17*t276 + D_delta_x_17*t271 + D_delta_y_17*t272
        + D_delta_z_17*t273 + D_p_rx_3*h_rx_w_carriage_4y + D_p_ry_3*h_ry_w_carriage_4y
        + D_p_rz_3*h_rz_w_carriage_4y + D_p_x_3*h_x_w_carriage_4y + D_p_y_3*h_y_w_carriage_4y
        + D_p_z_3*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 3] = (
        D_delta_rx_17*t280 + D_delta_ry_17*t281 + D_delta_rz_17*t282 + D_delta_x_17*t277 + D_delta_z_17*t279
        + D_p_rx_4*h_rx_w_carriage_4y + D_p_ry_4*h_ry_w_carriage_4y + D_p_rz_4*h_rz_w_carriage_4y
        + D_p_x_4*h_x_w_carriage_4y + D_p_y_4*h_y_w_carriage_4y + D_p_z_4*h_z_w_carriage_4y + m_t_4*n_4_y
        + n_4_y*t186 + n_4_y*t347 + t348
    )
    M_wq_out[..., 10, 4] = (
        D_delta_rx_17*t286 + D_delta_ry_17*t287 + D_delta_rz_17*t288 + D_delta_x_17*t283 + D_delta_y_17*t284
        + D_delta_z_17*t285 + D_p_rx_5*h_rx_w_carriage_4y + D_p_ry_5*h_ry_w_carriage_4y
        + D_p_rz_5*h_rz_w_carriage_4y + D_p_x_5*h_x_w_carriage_4y + D_p_y_5*h_y_w_carriage_4y
        + D_p_z_5*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 5] = (
        D_delta_rx_17*t292 + D_delta_ry_17*t293 + D_delta_rz_17*t294 + D_delta_x_17*t289 + D_delta_y_17*t290
        + D_delta_z_17*t291 + D_p_rx_6*h_rx_w_carriage_4y + D_p_ry_6*h_ry_w_carriage_4y
        + D_p_rz_6*h_rz_w_carriage_4y + D_p_x_6*h_x_w_carriage_4y + D_p_y_6*h_y_w_carriage_4y
        + D_p_z_6*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 9] = t343*t349
    M_wq_out[..., 10, 15] = t345*t349
    M_wq_out[..., 10, 24] = (
        D_delta_rx_1*h_rx_w_carriage_4y + D_delta_ry_1*h_ry_w_carriage_4y + D_delta_rz_1*h_rz_w_carriage_4y
        + D_delta_x_1*h_x_w_carriage_4y + D_delta_y_1*h_y_w_carriage_4y + D_delta_z_1*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 25] = (
        D_delta_rx_2*h_rx_w_carriage_4y + D_delta_ry_2*h_ry_w_carriage_4y + D_delta_rz_2*h_rz_w_carriage_4y
        + D_delta_x_2*h_x_w_carriage_4y + D_delta_y_2*h_y_w_carriage_4y + D_delta_z_2*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 26] = (
        D_delta_rx_3*h_rx_w_carriage_4y + D_delta_ry_3*h_ry_w_carriage_4y + D_delta_rz_3*h_rz_w_carriage_4y
        + D_delta_x_3*h_x_w_carriage_4y + D_delta_y_3*h_y_w_carriage_4y + D_delta_z_3*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 27] = (
        D_delta_rx_4*h_rx_w_carriage_4y + D_delta_ry_4*h_ry_w_carriage_4y + D_delta_rz_4*h_rz_w_carriage_4y
        + D_delta_x_4*h_x_w_carriage_4y + D_delta_y_4*h_y_w_carriage_4y + D_delta_z_4*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 28] = (
        D_delta_rx_5*h_rx_w_carriage_4y + D_delta_ry_5*h_ry_w_carriage_4y + D_delta_rz_5*h_rz_w_carriage_4y
        + D_delta_x_5*h_x_w_carriage_4y + D_delta_y_5*h_y_w_carriage_4y + D_delta_z_5*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 29] = (
        D_delta_rx_6*h_rx_w_carriage_4y + D_delta_ry_6*h_ry_w_carriage_4y + D_delta_rz_6*h_rz_w_carriage_4y
        + D_delta_x_6*h_x_w_carriage_4y + D_delta_y_6*h_y_w_carriage_4y + D_delta_z_6*h_z_w_carriage_4y
    )
    M_wq_out[..., 10, 33] = t348
    M_wq_out[..., 10, 36] = D_delta_ry_17*t299 - D_delta_rz_17*t300 + D_delta_x_17*t301 + h_x_w_carriage_4y
    M_wq_out[..., 10, 37] = (
        -D_delta_rx_17*t299 + D_delta_rz_17*t303 + D_delta_y_17*t301 + h_y_w_carriage_4y + t346
    )
    M_wq_out[..., 10, 38] = D_delta_rx_17*t300 - D_delta_ry_17*t303 + D_delta_z_17*t301 + h_z_w_carriage_4y
    M_wq_out[..., 11, 0] = (
        D_delta_rx_18*t255 + D_delta_ry_18*t256 + D_delta_rz_18*t257 + D_delta_x_18*t304 + D_delta_y_18*t259
        + D_delta_z_18*t260 + D_p_rx_1*h_rx_w_carriage_4z + D_p_ry_1*h_ry_w_carriage_4z
        + D_p_rz_1*h_rz_w_carriage_4z + D_p_x_1*h_x_w_carriage_4z + D_p_y_1*h_y_w_carriage_4z
        + D_p_z_1*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 1] = (
        D_delta_rx_18*t268 + D_delta_ry_18*t269 + D_delta_rz_18*t270 + D_delta_x_18*t265 + D_delta_y_18*t266
        + D_delta_z_18*t267 + D_p_rx_2*h_rx_w_carriage_4z + D_p_ry_2*h_ry_w_carriage_4z
        + D_p_rz_2*h_rz_w_carriage_4z + D_p_x_2*h_x_w_carriage_4z + D_p_y_2*h_y_w_carriage_4z
        + D_p_z_2*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 2] = (
        D_delta_rx_18*t274 + D_delta_ry_18*t275 + D_delta_rz_18*t276 + D_delta_x_18*t271 + D_delta_y_18*t272
        + D_delta_z_18*t273 + D_p_rx_3*h_rx_w_carriage_4z + D_p_ry_3*h_ry_w_carriage_4z
        + D_p_rz_3*h_rz_w_carriage_4z + D_p_x_3*h_x_w_carriage_4z + D_p_y_3*h_y_w_carriage_4z
        + D_p_z_3*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 3] = (
        D_delta_rx_18*t280 + D_delta_ry_18*t281 + D_delta_rz_18*t282 + D_delta_x_18*t277 + D_delta_y_18*t278
        + D_p_rx_4*h_rx_w_carriage_4z + D_p_ry_4*h_ry_w_carriage_4z + D_p_rz_4*h_rz_w_carriage_4z
        + D_p_x_4*h_x_w_carriage_4z + D_p_y_4*h_y_w_carriage_4z + D_p_z_4*h_z_w_carriage_4z + m_t_4*n_4_z
        + n_4_z*t186 + n_4_z*t350 + t351
    )
    M_wq_out[..., 11, 4] = (
        D_delta_rx_18*t286 + D_delta_ry_18*t287 + D_delta_rz_18*t288 + D_delta_x_18*t283 + D_delta_y_18*t284
        + D_delta_z_18*t285 + D_p_rx_5*h_rx_w_carriage_4z + D_p_ry_5*h_ry_w_carriage_4z
        + D_p_rz_5*h_rz_w_carriage_4z + D_p_x_5*h_x_w_carriage_4z + D_p_y_5*h_y_w_carriage_4z
        + D_p_z_5*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 5] = (
        D_delta_rx_18*t292 + D_delta_ry_18*t293 + D_delta_rz_18*t294 + D_delta_x_18*t289 + D_delta_y_18*t290
        + D_delta_z_18*t291 + D_p_rx_6*h_rx_w_carriage_4z + D_p_ry_6*h_ry_w_carriage_4z
        + D_p_rz_6*h_rz_w_carriage_4z + D_p_x_6*h_x_w_carriage_4z + D_p_y_6*h_y_w_carriage_4z
        + D_p_z_6*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 9] = t343*t352
    M_wq_out[..., 11, 15] = t345*t352
    M_wq_out[..., 11, 24] = (
        D_delta_rx_1*h_rx_w_carriage_4z + D_delta_ry_1*h_ry_w_carriage_4z + D_delta_rz_1*h_rz_w_carriage_4z
        + D_delta_x_1*h_x_w_carriage_4z + D_delta_y_1*h_y_w_carriage_4z + D_delta_z_1*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 25] = (
        D_delta_rx_2*h_rx_w_carriage_4z + D_delta_ry_2*h_ry_w_carriage_4z + D_delta_rz_2*h_rz_w_carriage_4z
        + D_delta_x_2*h_x_w_carriage_4z + D_delta_y_2*h_y_w_carriage_4z + D_delta_z_2*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 26] = (
        D_delta_rx_3*h_rx_w_carriage_4z + D_delta_ry_3*h_ry_w_carriage_4z + D_delta_rz_3*h_rz_w_carriage_4z
        + D_delta_x_3*h_x_w_carriage_4z + D_delta_y_3*h_y_w_carriage_4z + D_delta_z_3*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 27] = (
        D_delta_rx_4*h_rx_w_carriage_4z + D_delta_ry_4*h_ry_w_carriage_4z + D_delta_rz_4*h_rz_w_carriage_4z
        + D_delta_x_4*h_x_w_carriage_4z + D_delta_y_4*h_y_w_carriage_4z + D_delta_z_4*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 28] = (
        D_delta_rx_5*h_rx_w_carriage_4z + D_delta_ry_5*h_ry_w_carriage_4z + D_delta_rz_5*h_rz_w_carriage_4z
        + D_delta_x_5*h_x_w_carriage_4z + D_delta_y_5*h_y_w_carriage_4z + D_delta_z_5*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 29] = (
        D_delta_rx_6*h_rx_w_carriage_4z + D_delta_ry_6*h_ry_w_carriage_4z + D_delta_rz_6*h_rz_w_carriage_4z
        + D_delta_x_6*h_x_w_carriage_4z + D_delta_y_6*h_y_w_carriage_4z + D_delta_z_6*h_z_w_carriage_4z
    )
    M_wq_out[..., 11, 33] = t351
    M_wq_out[..., 11, 36] = D_delta_ry_18*t299 - D_delta_rz_18*t300 + D_delta_x_18*t301 + h_x_w_carriage_4z
    M_wq_out[..., 11, 37] = -D_delta_rx_18*t299 + D_delta_rz_18*t303 + D_delta_y_18*t301 + h_y_w_carriage_4z
    M_wq_out[..., 11, 38] = (
        D_delta_rx_18*t300 - D_delta_ry_18*t303 + D_delta_z_18*t301 + h_z_w_carriage_4z + t346
    )
    M_wq_out[..., 12, 0] = (
        D_delta_rx_19*t255 + D_delta_ry_19*t256 + D_delta_rz_19*t257 + D_delta_x_19*t304 + D_delta_y_19*t259
        + D_delta_z_19*t260 + D_p_rx_1*h_rx_w_carriage_5x + D_p_ry_1*h_ry_w_carriage_5x
        + D_p_rz_1*h_rz_w_carriage_5x + D_p_x_1*h_x_w_carriage_5x + D_p_y_1*h_y_w_carriage_5x
        + D_p_z_1*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 1] = (
        D_delta_rx_19*t268 + D_delta_ry_19*t269 + D_delta_rz_19*t270 + D_delta_x_19*t265 + D_delta_y_19*t266
        + D_delta_z_19*t267 + D_p_rx_2*h_rx_w_carriage_5x + D_p_ry_2*h_ry_w_carriage_5x
        + D_p_rz_2*h_rz_w_carriage_5x + D_p_x_2*h_x_w_carriage_5x + D_p_y_2*h_y_w_carriage_5x
        + D_p_z_2*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 2] = (
        D_delta_rx_19*t274 + D_delta_ry_19*t275 + D_delta_rz_19*t276 + D_delta_x_19*t271 + D_delta_y_19*t272
        + D_delta_z_19*t273 + D_p_rx_3*h_rx_w_carriage_5x + D_p_ry_3*h_ry_w_carriage_5x
        + D_p_rz_3*h_rz_w_carriage_5x + D_p_x_3*h_x_w_carriage_5x + D_p_y_3*h_y_w_carriage_5x
        + D_p_z_3*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 3] = (
        D_delta_rx_19*t280 + D_delta_ry_19*t281 + D_delta_rz_19*t282 + D_delta_x_19*t277 + D_delta_y_19*t278
        + D_delta_z_19*t279 + D_p_rx_4*h_rx_w_carriage_5x + D_p_ry_4*h_ry_w_carriage_5x
        + D_p_rz_4*h_rz_w_carriage_5x + D_p_x_4*h_x_w_carriage_5x + D_p_y_4*h_y_w_carriage_5x
        + D_p_z_4*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 4] = (
        D_delta_rx_19*t286 + D_delta_ry_19*t287 + D_delta_rz_19*t288 + D_delta_y_19*t284 + D_delta_z_19*t285
        + D_p_rx_5*h_rx_w_carriage_5x + D_p_ry_5*h_ry_w_carriage_5x + D_p_rz_5*h_rz_w_carriage_5x
        + D_p_x_5*h_x_w_carriage_5x + D_p_y_5*h_y_w_carriage_5x + D_p_z_5*h_z_w_carriage_5x + m_t_5*n_5_x
        + n_5_x*t187 + n_5_x*t353 + t356
    )
    M_wq_out[..., 12, 5] = (
        D_delta_rx_19*t292 + D_delta_ry_19*t293 + D_delta_rz_19*t294 + D_delta_x_19*t289 + D_delta_y_19*t290
        + D_delta_z_19*t291 + D_p_rx_6*h_rx_w_carriage_5x + D_p_ry_6*h_ry_w_carriage_5x
        + D_p_rz_6*h_rz_w_carriage_5x + D_p_x_6*h_x_w_carriage_5x + D_p_y_6*h_y_w_carriage_5x
        + D_p_z_6*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 10] = t357*t358
    M_wq_out[..., 12, 16] = t358*t359
    M_wq_out[..., 12, 24] = (
        D_delta_rx_1*h_rx_w_carriage_5x + D_delta_ry_1*h_ry_w_carriage_5x + D_delta_rz_1*h_rz_w_carriage_5x
        + D_delta_x_1*h_x_w_carriage_5x + D_delta_y_1*h_y_w_carriage_5x + D_delta_z_1*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 25] = (
        D_delta_rx_2*h_rx_w_carriage_5x + D_delta_ry_2*h_ry_w_carriage_5x + D_delta_rz_2*h_rz_w_carriage_5x
        + D_delta_x_2*h_x_w_carriage_5x + D_delta_y_2*h_y_w_carriage_5x + D_delta_z_2*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 26] = (
        D_delta_rx_3*h_rx_w_carriage_5x + D_delta_ry_3*h_ry_w_carriage_5x + D_delta_rz_3*h_rz_w_carriage_5x
        + D_delta_x_3*h_x_w_carriage_5x + D_delta_y_3*h_y_w_carriage_5x + D_delta_z_3*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 27] = (
        D_delta_rx_4*h_rx_w_carriage_5x + D_delta_ry_4*h_ry_w_carriage_5x + D_delta_rz_4*h_rz_w_carriage_5x
        + D_delta_x_4*h_x_w_carriage_5x + D_delta_y_4*h_y_w_carriage_5x + D_delta_z_4*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 28] = (
        D_delta_rx_5*h_rx_w_carriage_5x + D_delta_ry_5*h_ry_w_carriage_5x + D_delta_rz_5*h_rz_w_carriage_5x
        + D_delta_x_5*h_x_w_carriage_5x + D_delta_y_5*h_y_w_carriage_5x + D_delta_z_5*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 29] = (
        D_delta_rx_6*h_rx_w_carriage_5x + D_delta_ry_6*h_ry_w_carriage_5x + D_delta_rz_6*h_rz_w_carriage_5x
        + D_delta_x_6*h_x_w_carriage_5x + D_delta_y_6*h_y_w_carriage_5x + D_delta_z_6*h_z_w_carriage_5x
    )
    M_wq_out[..., 12, 34] = t356
    M_wq_out[..., 12, 36] = (
        D_delta_ry_19*t299 - D_delta_rz_19*t300 + D_delta_x_19*t301 + h_x_w_carriage_5x + t360
    )
    M_wq_out[..., 12, 37] = -D_delta_rx_19*t299 + D_delta_rz_19*t303 + D_delta_y_19*t301 + h_y_w_carriage_5x
    M_wq_out[..., 12, 38] = D_delta_rx_19*t300 - D_delta_ry_19*t303 + D_delta_z_19*t301 + h_z_w_carriage_5x
    M_wq_out[..., 13, 0] = (
        D_delta_rx_20*t255 + D_delta_ry_20*t256 + D_delta_rz_20*t257 + D_delta_x_20*t304 + D_delta_y_20*t259
        + D_delta_z_20*t260 + D_p_rx_1*h_rx_w_carriage_5y + D_p_ry_1*h_ry_w_carriage_5y
        + D_p_rz_1*h_rz_w_carriage_5y + D_p_x_1*h_x_w_carriage_5y + D_p_y_1*h_y_w_carriage_5y
        + D_p_z_1*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 1] = (
        D_delta_rx_20*t268 + D_delta_ry_20*t269 + D_delta_rz_20*t270 + D_delta_x_20*t265 + D_delta_y_20*t266
        + D_delta_z_20*t267 + D_p_rx_2*h_rx_w_carriage_5y + D_p_ry_2*h_ry_w_carriage_5y
        + D_p_rz_2*h_rz_w_carriage_5y + D_p_x_2*h_x_w_carriage_5y + D_p_y_2*h_y_w_carriage_5y
        + D_p_z_2*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 2] = (
        D_delta_rx_20*t274 + D_delta_ry_20*t275 + D_delta_rz_20*t276 + D_delta_x_20*t271 + D_delta_y_20*t272
        + D_delta_z_20*t273 + D_p_rx_3*h_rx_w_carriage_5y + D_p_ry_3*h_ry_w_carriage_5y
        + D_p_rz_3*h_rz_w_carriage_5y + D_p_x_3*h_x_w_carriage_5y + D_p_y_3*h_y_w_carriage_5y
        + D_p_z_3*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 3] = (
        D_delta_rx_20*t280 + D_delta_ry_20*t281 + D_delta_rz_20*t282 + D_delta_x_20*t277 + D_delta_y_20*t278
        + D_delta_z_20*t279 + D_p_rx_4*h_rx_w_carriage_5y + D_p_ry_4*h_ry_w_carriage_5y
        + D_p_rz_4*h_rz_w_carriage_5y + D_p_x_4*h_x_w_carriage_5y + D_p_y_4*h_y_w_carriage_5y
        + D_p_z_4*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 4] = (
        D_delta_rx_20*t286 + D_delta_ry_20*t287 + D_delta_rz_20*t288 + D_delta_x_20*t283 + D_delta_z_20*t285
        + D_p_rx_5*h_rx_w_carriage_5y + D_p_ry_5*h_ry_w_carriage_5y + D_p_rz_5*h_rz_w_carriage_5y
        + D_p_x_5*h_x_w_carriage_5y + D_p_y_5*h_y_w_carriage_5y + D_p_z_5*h_z_w_carriage_5y + m_t_5*n_5_y
        + n_5_y*t187 + n_5_y*t361 + t362
    )
    M_wq_out[..., 13, 5] = (
        D_delta_rx_20*t292 + D_delta_ry_20*t293 + D_delta_rz_20*t294 + D_delta_x_20*t289 + D_delta_y_20*t290
        + D_delta_z_20*t291 + D_p_rx_6*h_rx_w_carriage_5y + D_p_ry_6*h_ry_w_carriage_5y
        + D_p_rz_6*h_rz_w_carriage_5y + D_p_x_6*h_x_w_carriage_5y + D_p_y_6*h_y_w_carriage_5y
        + D_p_z_6*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 10] = t357*t363
    M_wq_out[..., 13, 16] = t359*t363
    M_wq_out[..., 13, 24] = (
        D_delta_rx_1*h_rx_w_carriage_5y + D_delta_ry_1*h_ry_w_carriage_5y + D_delta_rz_1*h_rz_w_carriage_5y
        + D_delta_x_1*h_x_w_carriage_5y + D_delta_y_1*h_y_w_carriage_5y + D_delta_z_1*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 25] = (
        D_delta_rx_2*h_rx_w_carriage_5y + D_delta_ry_2*h_ry_w_carriage_5y + D_delta_rz_2*h_rz_w_carriage_5y
        + D_delta_x_2*h_x_w_carriage_5y + D_delta_y_2*h_y_w_carriage_5y + D_delta_z_2*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 26] = (
        D_delta_rx_3*h_rx_w_carriage_5y + D_delta_ry_3*h_ry_w_carriage_5y + D_delta_rz_3*h_rz_w_carriage_5y
        + D_delta_x_3*h_x_w_carriage_5y + D_delta_y_3*h_y_w_carriage_5y + D_delta_z_3*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 27] = (
        D_delta_rx_4*h_rx_w_carriage_5y + D_delta_ry_4*h_ry_w_carriage_5y + D_delta_rz_4*h_rz_w_carriage_5y
        + D_delta_x_4*h_x_w_carriage_5y + D_delta_y_4*h_y_w_carriage_5y + D_delta_z_4*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 28] = (
        D_delta_rx_5*h_rx_w_carriage_5y + D_delta_ry_5*h_ry_w_carriage_5y + D_delta_rz_5*h_rz_w_carriage_5y
        + D_delta_x_5*h_x_w_carriage_5y + D_delta_y_5*h_y_w_carriage_5y + D_delta_z_5*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 29] = (
        D_delta_rx_6*h_rx_w_carriage_5y + D_delta_ry_6*h_ry_w_carriage_5y + D_delta_rz_6*h_rz_w_carriage_5y
        + D_delta_x_6*h_x_w_carriage_5y + D_delta_y_6*h_y_w_carriage_5y + D_delta_z_6*h_z_w_carriage_5y
    )
    M_wq_out[..., 13, 34] = t362
    M_wq_out[..., 13, 36] = D_delta_ry_20*t299 - D_delta_rz_20*t300 + D_delta_x_20*t301 + h_x_w_carriage_5y
    M_wq_out[..., 13, 37] = (
        -D_delta_rx_20*t299 + D_delta_rz_20*t303 + D_delta_y_20*t301 + h_y_w_carriage_5y + t360
    )
    M_wq_out[..., 13, 38] = D_delta_rx_20*t300 - D_delta_ry_20*t303 + D_delta_z_20*t301 + h_z_w_carriage_5y
    M_wq_out[..., 14, 0] = (
        D_delta_rx_21*t255 + D_delta_ry_21*t256 + D_delta_rz_21*t257 + D_delta_x_21*t304 + D_delta_y_21*t259
        + D_delta_z_21*t260 + D_p_rx_1*h_rx_w_carriage_5z + D_p_ry_1*h_ry_w_carriage_5z
        + D_p_rz_1*h_rz_w_carriage_5z + D_p_x_1*h_x_w_carriage_5z + D_p_y_1*h_y_w_carriage_5z
        + D_p_z_1*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 1] = (
        D_delta_rx_21*t268 + D_delta_ry_21*t269 + D_delta_rz_21*t270 + D_delta_x_21*t265 + D_delta_y_21*t266
        + D_delta_z_21*t267 + D_p_rx_2*h_rx_w_carriage_5z + D_p_ry_2*h_ry_w_carriage_5z
        + D_p_rz_2*h_rz_w_carriage_5z + D_p_x_2*h_x_w_carriage_5z + D_p_y_2*h_y_w_carriage_5z
        + D_p_z_2*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 2] = (
        D_delta_rx_21*t274 + D_delta_ry_21*t275 + D_delta_rz_21*t276 + D_delta_x_21*t271 + D_delta_y_21*t272
        + D_delta_z_21*t273 + D_p_rx_3*h_rx_w_carriage_5z + D_p_ry_3*h_ry_w_carriage_5z
        + D_p_rz_3*h_rz_w_carriage_5z + D_p_x_3*h_x_w_carriage_5z + D_p_y_3*h_y_w_carriage_5z
        + D_p_z_3*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 3] = (
        D_delta_rx_21*t280 + D_delta_ry_21*t281 + D_delta_rz_21*t282 + D_delta_x_21*t277 + D_delta_y_21*t278
        + D_delta_z_21*t279 + D_p_rx_4*h_rx_w_carriage_5z + D_p_ry_4*h_ry_w_carriage_5z
        + D_p_rz_4*h_rz_w_carriage_5z + D_p_x_4*h_x_w_carriage_5z + D_p_y_4*h_y_w_carriage_5z
        + D_p_z_4*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 4] = (
        D_delta_rx_21*t286 + D_delta_ry_21*t287 + D_delta_rz_21*t288 + D_delta_x_21*t283 + D_delta_y_21*t284
        + D_p_rx_5*h_rx_w_carriage_5z + D_p_ry_5*h_ry_w_carriage_5z + D_p_rz_5*h_rz_w_carriage_5z
        + D_p_x_5*h_x_w_carriage_5z + D_p_y_5*h_y_w_carriage_5z + D_p_z_5*h_z_w_carriage_5z + m_t_5*n_5_z
        + n_5_z*t187 + n_5_z*t364 + t365
    )
    M_wq_out[..., 14, 5] = (
        D_delta_rx_21*t292 + D_delta_ry_21*t293 + D_delta_rz_21*t294 + D_delta_x_21*t289 + D_delta_y_21*t290
        + D_delta_z_21*t291 + D_p_rx_6*h_rx_w_carriage_5z + D_p_ry_6*h_ry_w_carriage_5z
        + D_p_rz_6*h_rz_w_carriage_5z + D_p_x_6*h_x_w_carriage_5z + D_p_y_6*h_y_w_carriage_5z
        + D_p_z_6*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 10] = t357*t366
    M_wq_out[..., 14, 16] = t359*t366
    M_wq_out[..., 14, 24] = (
        D_delta_rx_1*h_rx_w_carriage_5z + D_delta_ry_1*h_ry_w_carriage_5z + D_delta_rz_1*h_rz_w_carriage_5z
        + D_delta_x_1*h_x_w_carriage_5z + D_delta_y_1*h_y_w_carriage_5z + D_delta_z_1*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 25] = (
        D_delta_rx_2*h_rx_w_carriage_5z + D_delta_ry_2*h_ry_w_carriage_5z + D_delta_rz_2*h_rz_w_carriage_5z
        + D_delta_x_2*h_x_w_carriage_5z + D_delta_y_2*h_y_w_carriage_5z + D_delta_z_2*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 26] = (
        D_delta_rx_3*h_rx_w_carriage_5z + D_delta_ry_3*h_ry_w_carriage_5z + D_delta_rz_3*h_rz_w_carriage_5z
        + D_delta_x_3*h_x_w_carriage_5z + D_delta_y_3*h_y_w_carriage_5z + D_delta_z_3*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 27] = (
        D_delta_rx_4*h_rx_w_carriage_5z + D_delta_ry_4*h_ry_w_carriage_5z + D_delta_rz_4*h_rz_w_carriage_5z
        + D_delta_x_4*h_x_w_carriage_5z + D_delta_y_4*h_y_w_carriage_5z + D_delta_z_4*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 28] = (
        D_delta_rx_5*h_rx_w_carriage_5z + D_delta_ry_5*h_ry_w_carriage_5z + D_delta_rz_5*h_rz_w_carriage_5z
        + D_delta_x_5*h_x_w_carriage_5z + D_delta_y_5*h_y_w_carriage_5z + D_delta_z_5*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 29] = (
        D_delta_rx_6*h_rx_w_carriage_5z + D_delta_ry_6*h_ry_w_carriage_5z + D_delta_rz_6*h_rz_w_carriage_5z
        + D_delta_x_6*h_x_w_carriage_5z + D_delta_y_6*h_y_w_carriage_5z + D_delta_z_6*h_z_w_carriage_5z
    )
    M_wq_out[..., 14, 34] = t365
    M_wq_out[..., 14, 36] = D_delta_ry_21*t299 - D_delta_rz_21*t300 + D_delta_x_21*t301 + h_x_w_carriage_5z
    M_wq_out[..., 14, 37] = -D_delta_rx_21*t299 + D_delta_rz_21*t303 + D_delta_y_21*t301 + h_y_w_carriage_5z
    M_wq_out[..., 14, 38] = (
        D_delta_rx_21*t300 - D_delta_ry_21*t303 + D_delta_z_21*t301 + h_z_w_carriage_5z + t360
    )
    M_wq_out[..., 15, 0] = (
        D_delta_rx_22*t255 + D_delta_ry_22*t256 + D_delta_rz_22*t257 + D_delta_x_22*t304 + D_delta_y_22*t259
        + D_delta_z_22*t260 + D_p_rx_1*h_rx_w_carriage_6x + D_p_ry_1*h_ry_w_carriage_6x
        + D_p_rz_1*h_rz_w_carriage_6x + D_p_x_1*h_x_w_carriage_6x + D_p_y_1*h_y_w_carriage_6x
        + D_p_z_1*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 1] = (
        D_delta_rx_22*t268 + D_delta_ry_22*t269 + D_delta_rz_22*t270 + D_delta_x_22*t265 + D_delta_y_22*t266
        + D_delta_z_22*t267 + D_p_rx_2*h_rx_w_carriage_6x + D_p_ry_2*h_ry_w_carriage_6x
        + D_p_rz_2*h_rz_w_carriage_6x + D_p_x_2*h_x_w_carriage_6x + D_p_y_2*h_y_w_carriage_6x
        + D_p_z_2*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 2] = (
        D_delta_rx_22*t274 + D_delta_ry_22*t275 + D_delta_rz_22*t276 + D_delta_x_22*t271 + D_delta_y_22*t272
        + D_delta_z_22*t273 + D_p_rx_3*h_rx_w_carriage_6x + D_p_ry_3*h_ry_w_carriage_6x
        + D_p_rz_3*h_rz_w_carriage_6x + D_p_x_3*h_x_w_carriage_6x + D_p_y_3*h_y_w_carriage_6x
        + D_p_z_3*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 3] = (
        D_delta_rx_22*t280 + D_delta_ry_22*t281 + D_delta_rz_22*t282 + D_delta_x_22*t277 + D_delta_y_22*t278
        + D_delta_z_22*t279 + D_p_rx_4*h_rx_w_carriage_6x + D_p_ry_4*h_ry_w_carriage_6x
        + D_p_rz_4*h_rz_w_carriage_6x + D_p_x_4*h_x_w_carriage_6x + D_p_y_4*h_y_w_carriage_6x
        + D_p_z_4*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 4] = (
        D_delta_rx_22*t286 + D_delta_ry_22*t287 + D_delta_rz_22*t288 + D_delta_x_22*t283 + D_delta_y_22*t284
        + D_delta_z_22*t285 + D_p_rx_5*h_rx_w_carriage_6x + D_p_ry_5*h_ry_w_carriage_6x
        + D_p_rz_5*h_rz_w_carriage_6x + D_p_x_5*h_x_w_carriage_6x + D_p_y_5*h_y_w_carriage_6x
        + D_p_z_5*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 5] = (
        D_delta_rx_22*t292 + D_delta_ry_22*t293 + D_delta_rz_22*t294 + D_delta_y_22*t290 + D_delta_z_22*t291
        + D_p_rx_6*h_rx_w_carriage_6x + D_p_ry_6*h_ry_w_carriage_6x + D_p_rz_6*h_rz_w_carriage_6x
        + D_p_x_6*h_x_w_carriage_6x + D_p_y_6*h_y_w_carriage_6x + D_p_z_6*h_z_w_carriage_6x + m_t_6*n_6_x
        + n_6_x*t188 + n_6_x*t367 + t370
    )
    M_wq_out[..., 15, 11] = t371*t372
    M_wq_out[..., 15, 17] = t372*t373
    M_wq_out[..., 15, 24] = (
        D_delta_rx_1*h_rx_w_carriage_6x + D_delta_ry_1*h_ry_w_carriage_6x + D_delta_rz_1*h_rz_w_carriage_6x
        + D_delta_x_1*h_x_w_carriage_6x + D_delta_y_1*h_y_w_carriage_6x + D_delta_z_1*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 25] = (
        D_delta_rx_2*h_rx_w_carriage_6x + D_delta_ry_2*h_ry_w_carriage_6x + D_delta_rz_2*h_rz_w_carriage_6x
        + D_delta_x_2*h_x_w_carriage_6x + D_delta_y_2*h_y_w_carriage_6x + D_delta_z_2*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 26] = (
        D_delta_rx_3*h_rx_w_carriage_6x + D_delta_ry_3*h_ry_w_carriage_6x + D_delta_rz_3*h_rz_w_carriage_6x
        + D_delta_x_3*h_x_w_carriage_6x + D_delta_y_3*h_y_w_carriage_6x + D_delta_z_3*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 27] = (
        D_delta_rx_4*h_rx_w_carriage_6x + D_delta_ry_4*h_ry_w_carriage_6x + D_delta_rz_4*h_rz_w_carriage_6x
        + D_delta_x_4*h_x_w_carriage_6x + D_delta_y_4*h_y_w_carriage_6x + D_delta_z_4*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 28] = (
        D_delta_rx_5*h_rx_w_carriage_6x + D_delta_ry_5*h_ry_w_carriage_6x + D_delta_rz_5*h_rz_w_carriage_6x
        + D_delta_x_5*h_x_w_carriage_6x + D_delta_y_5*h_y_w_carriage_6x + D_delta_z_5*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 29] = (
        D_delta_rx_6*h_rx_w_carriage_6x + D_delta_ry_6*h_ry_w_carriage_6x + D_delta_rz_6*h_rz_w_carriage_6x
        + D_delta_x_6*h_x_w_carriage_6x + D_delta_y_6*h_y_w_carriage_6x + D_delta_z_6*h_z_w_carriage_6x
    )
    M_wq_out[..., 15, 35] = t370
    M_wq_out[..., 15, 36] = (
        D_delta_ry_22*t299 - D_delta_rz_22*t300 + D_delta_x_22*t301 + h_x_w_carriage_6x + t374
    )
    M_wq_out[..., 15, 37] = -D_delta_rx_22*t299 + D_delta_rz_22*t303 + D_delta_y_22*t301 + h_y_w_carriage_6x
    M_wq_out[..., 15, 38] = D_delta_rx_22*t300 - D_delta_ry_22*t303 + D_delta_z_22*t301 + h_z_w_carriage_6x
    M_wq_out[..., 16, 0] = (
        D_delta_rx_23*t255 + D_delta_ry_23*t256 + D_delta_rz_23*t257 + D_delta_x_23*t304 + D_delta_y_23*t259
        + D_delta_z_23*t260 + D_p_rx_1*h_rx_w_carriage_6y + D_p_ry_1*h_ry_w_carriage_6y
        + D_p_rz_1*h_rz_w_carriage_6y + D_p_x_1*h_x_w_carriage_6y + D_p_y_1*h_y_w_carriage_6y
        + D_p_z_1*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 1] = (
        D_delta_rx_23*t268 + D_delta_ry_23*t269 + D_delta_rz_23*t270 + D_delta_x_23*t265 + D_delta_y_23*t266
        + D_delta_z_23*t267 + D_p_rx_2*h_rx_w_carriage_6y + D_p_ry_2*h_ry_w_carriage_6y
        + D_p_rz_2*h_rz_w_carriage_6y + D_p_x_2*h_x_w_carriage_6y + D_p_y_2*h_y_w_carriage_6y
        + D_p_z_2*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 2] = (
        D_delta_rx_23*t274 + D_delta_ry_23*t275 + D_delta_rz_23*t276 + D_delta_x_23*t271 + D_delta_y_23*t272
        + D_delta_z_23*t273 + D_p_rx_3*h_rx_w_carriage_6y + D_p_ry_3*h_ry_w_carriage_6y
        + D_p_rz_3*h_rz_w_carriage_6y + D_p_x_3*h_x_w_carriage_6y + D_p_y_3*h_y_w_carriage_6y
        + D_p_z_3*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 3] = (
        D_delta_rx_23*t280 + D_delta_ry_23*t281 + D_delta_rz_23*t282 + D_delta_x_23*t277 + D_delta_y_23*t278
        + D_delta_z_23*t279 + D_p_rx_4*h_rx_w_carriage_6y + D_p_ry_4*h_ry_w_carriage_6y
        + D_p_rz_4*h_rz_w_carriage_6y + D_p_x_4*h_x_w_carriage_6y + D_p_y_4*h_y_w_carriage_6y
        + D_p_z_4*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 4] = (
        D_delta_rx_23*t286 + D_delta_ry_23*t287 + D_delta_rz_23*t288 + D_delta_x_23*t283 + D_delta_y_23*t284
        + D_delta_z_23*t285 + D_p_rx_5*h_rx_w_carriage_6y + D_p_ry_5*h_ry_w_carriage_6y
        + D_p_rz_5*h_rz_w_carriage_6y + D_p_x_5*h_x_w_carriage_6y + D_p_y_5*h_y_w_carriage_6y
        + D_p_z_5*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 5] = (
        D_delta_rx_23*t292 + D_delta_ry_23*t293 + D_delta_rz_23*t294 + D_delta_x_23*t289 + D_delta_z_23*t291
        + D_p_rx_6*h_rx_w_carriage_6y + D_p_ry_6*h_ry_w_carriage_6y + D_p_rz_6*h_rz_w_carriage_6y
        + D_p_x_6*h_x_w_carriage_6y + D_p_y_6*h_y_w_carriage_6y + D_p_z_6*h_z_w_carriage_6y + m_t_6*n_6_y
        + n_6_y*t188 + n_6_y*t375 + t376
    )
    M_wq_out[..., 16, 11] = t371*t377
    M_wq_out[..., 16, 17] = t373*t377
    M_wq_out[..., 16, 24] = (
        D_delta_rx_1*h_rx_w_carriage_6y + D_delta_ry_1*h_ry_w_carriage_6y + D_delta_rz_1*h_rz_w_carriage_6y
        + D_delta_x_1*h_x_w_carriage_6y + D_delta_y_1*h_y_w_carriage_6y + D_delta_z_1*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 25] = (
        D_delta_rx_2*h_rx_w_carriage_6y + D_delta_ry_2*h_ry_w_carriage_6y + D_delta_rz_2*h_rz_w_carriage_6y
        + D_delta_x_2*h_x_w_carriage_6y + D_delta_y_2*h_y_w_carriage_6y + D_delta_z_2*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 26] = (
        D_delta_rx_3*h_rx_w_carriage_6y + D_delta_ry_3*h_ry_w_carriage_6y + D_delta_rz_3*h_rz_w_carriage_6y
        + D_delta_x_3*h_x_w_carriage_6y + D_delta_y_3*h_y_w_carriage_6y + D_delta_z_3*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 27] = (
        D_delta_rx_4*h_rx_w_carriage_6y + D_delta_ry_4*h_ry_w_carriage_6y + D_delta_rz_4*h_rz_w_carriage_6y
        + D_delta_x_4*h_x_w_carriage_6y + D_delta_y_4*h_y_w_carriage_6y + D_delta_z_4*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 28] = (
        D_delta_rx_5*h_rx_w_carriage_6y + D_delta_ry_5*h_ry_w_carriage_6y + D_delta_rz_5*h_rz_w_carriage_6y
        + D_delta_x_5*h_x_w_carriage_6y + D_delta_y_5*h_y_w_carriage_6y + D_delta_z_5*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 29] = (
        D_delta_rx_6*h_rx_w_carriage_6y + D_delta_ry_6*h_ry_w_carriage_6y + D_delta_rz_6*h_rz_w_carriage_6y
        + D_delta_x_6*h_x_w_carriage_6y + D_delta_y_6*h_y_w_carriage_6y + D_delta_z_6*h_z_w_carriage_6y
    )
    M_wq_out[..., 16, 35] = t376
    M_wq_out[..., 16, 36] = D_delta_ry_23*t299 - D_delta_rz_23*t300 + D_delta_x_23*t301 + h_x_w_carriage_6y
    M_wq_out[..., 16, 37] = (
        -D_delta_rx_23*t299 + D_delta_rz_23*t303 + D_delta_y_23*t301 + h_y_w_carriage_6y + t374
    )
    M_wq_out[..., 16, 38] = D_delta_rx_23*t300 - D_delta_ry_23*t303 + D_delta_z_23*t301 + h_z_w_carriage_6y
    M_wq_out[..., 17, 0] = (
        D_delta_rx_24*t255 + D_delta_ry_24*t256 + D_delta_rz_24*t257 + D_delta_x_24*t304 + D_delta_y_24*t259
        + D_delta_z_24*t260 + D_p_rx_1*h_rx_w_carriage_6z + D_p_ry_1*h_ry_w_carriage_6z
        + D_p_rz_1*h_rz_w_carriage_6z + D_p_x_1*h_x_w_carriage_6z + D_p_y_1*h_y_w_carriage_6z
        + D_p_z_1*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 1] = (
        D_delta_rx_24*t268 + D_delta_ry_24*t269 + D_delta_rz_24*t270 + D_delta_x_24*t265 + D_delta_y_24*t266
        + D_delta_z_24*t267 + D_p_rx_2*h_rx_w_carriage_6z + D_p_ry_2*h_ry_w_carriage_6z
        + D_p_rz_2*h_rz_w_carriage_6z + D_p_x_2*h_x_w_carriage_6z + D_p_y_2*h_y_w_carriage_6z
        + D_p_z_2*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 2] = (
        D_delta_rx_24*t274 + D_delta_ry_24*t275 + D_delta_rz_24*t276 + D_delta_x_24*t271 + D_delta_y_24*t272
        + D_delta_z_24*t273 + D_p_rx_3*h_rx_w_carriage_6z + D_p_ry_3*h_ry_w_carriage_6z
        + D_p_rz_3*h_rz_w_carriage_6z + D_p_x_3*h_x_w_carriage_6z + D_p_y_3*h_y_w_carriage_6z
        + D_p_z_3*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 3] = (
        D_delta_rx_24*t280 + D_delta_ry_24*t281 + D_delta_rz_24*t282 + D_delta_x_24*t277 + D_delta_y_24*t278
        + D_delta_z_24*t279 + D_p_rx_4*h_rx_w_carriage_6z + D_p_ry_4*h_ry_w_carriage_6z
        + D_p_rz_4*h_rz_w_carriage_6z + D_p_x_4*h_x_w_carriage_6z + D_p_y_4*h_y_w_carriage_6z
        + D_p_z_4*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 4] = (
        D_delta_rx_24*t286 + D_delta_ry_24*t287 + D_delta_rz_24*t288 + D_delta_x_24*t283 + D_delta_y_24*t284
        + D_delta_z_24*t285 + D_p_rx_5*h_rx_w_carriage_6z + D_p_ry_5*h_ry_w_carriage_6z
        + D_p_rz_5*h_rz_w_carriage_6z + D_p_x_5*h_x_w_carriage_6z + D_p_y_5*h_y_w_carriage_6z
        + D_p_z_5*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 5] = (
        D_delta_rx_24*t292 + D_delta_ry_24*t293 + D_delta_rz_24*t294 + D_delta_x_24*t289 + D_delta_y_24*t290
        + D_p_rx_6*h_rx_w_carriage_6z + D_p_ry_6*h_ry_w_carriage_6z + D_p_rz_6*h_rz_w_carriage_6z
        + D_p_x_6*h_x_w_carriage_6z + D_p_y_6*h_y_w_carriage_6z + D_p_z_6*h_z_w_carriage_6z + m_t_6*n_6_z
        + n_6_z*t188 + n_6_z*t378 + t379
    )
    M_wq_out[..., 17, 11] = t371*t380
    M_wq_out[..., 17, 17] = t373*t380
    M_wq_out[..., 17, 24] = (
        D_delta_rx_1*h_rx_w_carriage_6z + D_delta_ry_1*h_ry_w_carriage_6z + D_delta_rz_1*h_rz_w_carriage_6z
        + D_delta_x_1*h_x_w_carriage_6z + D_delta_y_1*h_y_w_carriage_6z + D_delta_z_1*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 25] = (
        D_delta_rx_2*h_rx_w_carriage_6z + D_delta_ry_2*h_ry_w_carriage_6z + D_delta_rz_2*h_rz_w_carriage_6z
        + D_delta_x_2*h_x_w_carriage_6z + D_delta_y_2*h_y_w_carriage_6z + D_delta_z_2*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 26] = (
        D_delta_rx_3*h_rx_w_carriage_6z + D_delta_ry_3*h_ry_w_carriage_6z + D_delta_rz_3*h_rz_w_carriage_6z
        + D_delta_x_3*h_x_w_carriage_6z + D_delta_y_3*h_y_w_carriage_6z + D_delta_z_3*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 27] = (
        D_delta_rx_4*h_rx_w_carriage_6z + D_delta_ry_4*h_ry_w_carriage_6z + D_delta_rz_4*h_rz_w_carriage_6z
        + D_delta_x_4*h_x_w_carriage_6z + D_delta_y_4*h_y_w_carriage_6z + D_delta_z_4*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 28] = (
        D_delta_rx_5*h_rx_w_carriage_6z + D_delta_ry_5*h_ry_w_carriage_6z + D_delta_rz_5*h_rz_w_carriage_6z
        + D_delta_x_5*h_x_w_carriage_6z + D_delta_y_5*h_y_w_carriage_6z + D_delta_z_5*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 29] = (
        D_delta_rx_6*h_rx_w_carriage_6z + D_delta_ry_6*h_ry_w_carriage_6z + D_delta_rz_6*h_rz_w_carriage_6z
        + D_delta_x_6*h_x_w_carriage_6z + D_delta_y_6*h_y_w_carriage_6z + D_delta_z_6*h_z_w_carriage_6z
    )
    M_wq_out[..., 17, 35] = t379
    M_wq_out[..., 17, 36] = D_delta_ry_24*t299 - D_delta_rz_24*t300 + D_delta_x_24*t301 + h_x_w_carriage_6z
    M_wq_out[..., 17, 37] = -D_delta_rx_24*t299 + D_delta_rz_24*t303 + D_delta_y_24*t301 + h_y_w_carriage_6z
    M_wq_out[..., 17, 38] = (
        D_delta_rx_24*t300 - D_delta_ry_24*t303 + D_delta_z_24*t301 + h_z_w_carriage_6z + t374
    )
    M_wq_out[..., 18, 0] = t296
    M_wq_out[..., 18, 6] = (1/3)*R_p_1*l_f_1_3*rho_b - t382
    M_wq_out[..., 18, 12] = t383
    M_wq_out[..., 18, 30] = t296
    M_wq_out[..., 19, 0] = t298
    M_wq_out[..., 19, 6] = t383
    M_wq_out[..., 19, 12] = (1/3)*R_p_1*l_f_1_2*rho_b - t382
    M_wq_out[..., 19, 30] = t298
    M_wq_out[..., 20, 1] = t315
    M_wq_out[..., 20, 7] = (1/3)*R_p_2*l_f_2_3*rho_b - t385
    M_wq_out[..., 20, 13] = t386
    M_wq_out[..., 20, 31] = t315
    M_wq_out[..., 21, 1] = t317
    M_wq_out[..., 21, 7] = t386
    M_wq_out[..., 21, 13] = (1/3)*R_p_2*l_f_2_2*rho_b - t385
    M_wq_out[..., 21, 31] = t317
    M_wq_out[..., 22, 2] = t329
    M_wq_out[..., 22, 8] = (1/3)*R_p_3*l_f_3_3*rho_b - t388
    M_wq_out[..., 22, 14] = t389
    M_wq_out[..., 22, 32] = t329
    M_wq_out[..., 23, 2] = t331
    M_wq_out[..., 23, 8] = t389
    M_wq_out[..., 23, 14] = (1/3)*R_p_3*l_f_3_2*rho_b - t388
    M_wq_out[..., 23, 32] = t331
    M_wq_out[..., 24, 3] = t343
    M_wq_out[..., 24, 9] = (1/3)*R_p_4*l_f_4_3*rho_b - t391
    M_wq_out[..., 24, 15] = t392
    M_wq_out[..., 24, 33] = t343
    M_wq_out[..., 25, 3] = t345
    M_wq_out[..., 25, 9] = t392
    M_wq_out[..., 25, 15] = (1/3)*R_p_4*l_f_4_2*rho_b - t391
    M_wq_out[..., 25, 33] = t345
    M_wq_out[..., 26, 4] = t357
    M_wq_out[..., 26, 10] = (1/3)*R_p_5*l_f_5_3*rho_b - t394
    M_wq_out[..., 26, 16] = t395
    M_wq_out[..., 26, 34] = t357
    M_wq_out[..., 27, 4] = t359
    M_wq_out[..., 27, 10] = t395
    M_wq_out[..., 27, 16] = (1/3)*R_p_5*l_f_5_2*rho_b - t394
    M_wq_out[..., 27, 34] = t359
    M_wq_out[..., 28, 5] = t371
    M_wq_out[..., 28, 11] = (1/3)*R_p_6*l_f_6_3*rho_b - t397
    M_wq_out[..., 28, 17] = t398
    M_wq_out[..., 28, 35] = t371
    M_wq_out[..., 29, 5] = t373
    M_wq_out[..., 29, 11] = t398
    M_wq_out[..., 29, 17] = (1/3)*R_p_6*l_f_6_2*rho_b - t397
    M_wq_out[..., 29, 35] = t373
    M_ww_out = np.empty((*batch, 30), dtype)
    M_ww_out[..., 0] = (
        D_delta_rx_7*h_rx_w_carriage_1x + D_delta_ry_7*h_ry_w_carriage_1x + D_delta_ry_7*t237
        + D_delta_rz_7*h_rz_w_carriage_1x - D_delta_rz_7*t238 + D_delta_x_7*h_x_w_carriage_1x
        + D_delta_y_7*h_y_w_carriage_1x + D_delta_z_7*h_z_w_carriage_1x + t258 + t262*t399 + t263*t399 + t302
    )
    M_ww_out[..., 1] = (
        D_delta_rx_8*h_rx_w_carriage_1y - D_delta_rx_8*t237 + D_delta_ry_8*h_ry_w_carriage_1y
        + D_delta_rz_8*h_rz_w_carriage_1y + D_delta_rz_8*t249 + D_delta_x_8*h_x_w_carriage_1y
        + D_delta_y_8*h_y_w_carriage_1y + D_delta_z_8*h_z_w_carriage_1y + t262*t400 + t263*t400 + t302 + t305
    )
    M_ww_out[..., 2] = (
        D_delta_rx_9*h_rx_w_carriage_1z + D_delta_rx_9*t238 + D_delta_ry_9*h_ry_w_carriage_1z
        - D_delta_ry_9*t249 + D_delta_rz_9*h_rz_w_carriage_1z + D_delta_x_9*h_x_w_carriage_1z
        + D_delta_y_9*h_y_w_carriage_1z + D_delta_z_9*h_z_w_carriage_1z + t262*t401 + t263*t401 + t302 + t308
    )
    M_ww_out[..., 3] = (
        D_delta_rx_10*h_rx_w_carriage_2x + D_delta_ry_10*h_ry_w_carriage_2x + D_delta_ry_10*t239
        + D_delta_rz_10*h_rz_w_carriage_2x - D_delta_rz_10*t240 + D_delta_x_10*h_x_w_carriage_2x
        + D_delta_y_10*h_y_w_carriage_2x + D_delta_z_10*h_z_w_carriage_2x + t311 + t312*t402 + t313*t402
        + t318
    )
    M_ww_out[..., 4] = (
        D_delta_rx_11*h_rx_w_carriage_2y - D_delta_rx_11*t239 + D_delta_ry_11*h_ry_w_carriage_2y
        + D_delta_rz_11*h_rz_w_carriage_2y + D_delta_rz_11*t250 + D_delta_x_11*h_x_w_carriage_2y
        + D_delta_y_11*h_y_w_carriage_2y + D_delta_z_11*h_z_w_carriage_2y + t312*t403 + t313*t403 + t318
        + t319
    )
    M_ww_out[..., 5] = (
        D_delta_rx_12*h_rx_w_carriage_2z + D_delta_rx_12*t240 + D_delta_ry_12*h_ry_w_carriage_2z
        - D_delta_ry_12*t250 + D_delta_rz_12*h_rz_w_carriage_2z + D_delta_x_12*h_x_w_carriage_2z
        + D_delta_y_12*h_y_w_carriage_2z + D_delta_z_12*h_z_w_carriage_2z + t312*t404 + t313*t404 + t318
        + t322
    )
    M_ww_out[..., 6] = (
        D_delta_rx_13*h_rx_w_carriage_3x + D_delta_ry_13*h_ry_w_carriage_3x + D_delta_ry_13*t241
        + D_delta_rz_13*h_rz_w_carriage_3x - D_delta_rz_13*t242 + D_delta_x_13*h_x_w_carriage_3x
        + D_delta_y_13*h_y_w_carriage_3x + D_delta_z_13*h_z_w_carriage_3x + t325 + t326*t405 + t327*t405
        + t332
    )
    M_ww_out[..., 7] = (
        D_delta_rx_14*h_rx_w_carriage_3y - D_delta_rx_14*t241 + D_delta_ry_14*h_ry_w_carriage_3y
        + D_delta_rz_14*h_rz_w_carriage_3y + D_delta_rz_14*t251 + D_delta_x_14*h_x_w_carriage_3y
        + D_delta_y_14*h_y_w_carriage_3y + D_delta_z_14*h_z_w_carriage_3y + t326*t406 + t327*t406 + t332
        + t333
    )
    M_ww_out[..., 8] = (
        D_delta_rx_15*h_rx_w_carriage_3z + D_delta_rx_15*t242 + D_delta_ry_15*h_ry_w_carriage_3z
        - D_delta_ry_15*t251 + D_delta_rz_15*h_rz_w_carriage_3z + D_delta_x_15*h_x_w_carriage_3z
        + D_delta_y_15*h_y_w_carriage_3z + D_delta_z_15*h_z_w_carriage_3z + t326*t407 + t327*t407 + t332
        + t336
    )
    M_ww_out[..., 9] = (
        D_delta_rx_16*h_rx_w_carriage_4x + D_delta_ry_16*h_ry_w_carriage_4x + D_delta_ry_16*t243
        + D_delta_rz_16*h_rz_w_carriage_4x - D_delta_rz_16*t244 + D_delta_x_16*h_x_w_carriage_4x
        + D_delta_y_16*h_y_w_carriage_4x + D_delta_z_16*h_z_w_carriage_4x + t339 + t340*t408 + t341*t408
        + t346
    )
    M_ww_out[..., 10] = (
        D_delta_rx_17*h_rx_w_carriage_4y - D_delta_rx_17*t243 + D_delta_ry_17*h_ry_w_carriage_4y
        + D_delta_rz_17*h_rz_w_carriage_4y + D_delta_rz_17*t252 + D_delta_x_17*h_x_w_carriage_4y
        + D_delta_y_17*h_y_w_carriage_4y + D_delta_z_17*h_z_w_carriage_4y + t340*t409 + t341*t409 + t346
        + t347
    )
    M_ww_out[..., 11] = (
        D_delta_rx_18*h_rx_w_carriage_4z + D_delta_rx_18*t244 + D_delta_ry_18*h_ry_w_carriage_4z
        - D_delta_ry_18*t252 + D_delta_rz_18*h_rz_w_carriage_4z + D_delta_x_18*h_x_w_carriage_4z
        + D_delta_y_18*h_y_w_carriage_4z + D_delta_z_18*h_z_w_carriage_4z + t340*t410 + t341*t410 + t346
        + t350
    )
    M_ww_out[..., 12] = (
        D_delta_rx_19*h_rx_w_carriage_5x + D_delta_ry_19*h_ry_w_carriage_5x + D_delta_ry_19*t245
        + D_delta_rz_19*h_rz_w_carriage_5x - D_delta_rz_19*t246 + D_delta_x_19*h_x_w_carriage_5x
        + D_delta_y_19*h_y_w_carriage_5x + D_delta_z_19*h_z_w_carriage_5x + t353 + t354*t411 + t355*t411
        + t360
    )
    M_ww_out[..., 13] = (
        D_delta_rx_20*h_rx_w_carriage_5y - D_delta_rx_20*t245 + D_delta_ry_20*h_ry_w_carriage_5y
        + D_delta_rz_20*h_rz_w_carriage_5y + D_delta_rz_20*t253 + D_delta_x_20*h_x_w_carriage_5y
        + D_delta_y_20*h_y_w_carriage_5y + D_delta_z_20*h_z_w_carriage_5y + t354*t412 + t355*t412 + t360
        + t361
    )
    M_ww_out[..., 14] = (
        D_delta_rx_21*h_rx_w_carriage_5z + D_delta_rx_21*t246 + D_delta_ry_21*h_ry_w_carriage_5z
        - D_delta_ry_21*t253 + D_delta_rz_21*h_rz_w_carriage_5z + D_delta_x_21*h_x_w_carriage_5z
        + D_delta_y_21*h_y_w_carriage_5z + D_delta_z_21*h_z_w_carriage_5z + t354*t413 + t355*t413 + t360
        + t364
    )
    M_ww_out[..., 15] = (
        D_delta_rx_22*h_rx_w_carriage_6x + D_delta_ry_22*h_ry_w_carriage_6x + D_delta_ry_22*t247
        + D_delta_rz_22*h_rz_w_carriage_6x - D_delta_rz_22*t248 + D_delta_x_22*h_x_w_carriage_6x
        + D_delta_y_22*h_y_w_carriage_6x + D_delta_z_22*h_z_w_carriage_6x + t367 + t368*t414 + t369*t414
        + t374
    )
    M_ww_out[..., 16] = (
        D_delta_rx_23*h_rx_w_carriage_6y - D_delta_rx_23*t247 + D_delta_ry_23*h_ry_w_carriage_6y
        + D_delta_rz_23*h_rz_w_carriage_6y + D_delta_rz_23*t254 + D_delta_x_23*h_x_w_carriage_6y
        + D_delta_y_23*h_y_w_carriage_6y + D_delta_z_23*h_z_w_carriage_6y + t368*t415 + t369*t415 + t374
        + t375
    )
    M_ww_out[..., 17] = (
        D_delta_rx_24*h_rx_w_carriage_6z + D_delta_rx_24*t248 + D_delta_ry_24*h_ry_w_carriage_6z
        - D_delta_ry_24*t254 + D_delta_rz_24*h_rz_w_carriage_6z + D_delta_x_24*h_x_w_carriage_6z
        + D_delta_y_24*h_y_w_carriage_6z + D_delta_z_24*h_z_w_carriage_6z + t368*t416 + t369*t416 + t374
        + t378
    )
    M_ww_out[..., 18] = t263 + t381
    M_ww_out[..., 19] = t262 + t381
    M_ww_out[..., 20] = t313 + t384
    M_ww_out[..., 21] = t312 + t384
    M_ww_out[..., 22] = t327 + t387
    M_ww_out[..., 23] = t326 + t387
    M_ww_out[..., 24] = t341 + t390
    M_ww_out[..., 25] = t340 + t390
    M_ww_out[..., 26] = t355 + t393
    M_ww_out[..., 27] = t354 + t393
    M_ww_out[..., 28] = t369 + t396
    M_ww_out[..., 29] = t368 + t396
    K_wq_out = np.zeros((*batch, 30, 39), dtype)
    K_wq_out[..., 0, 0] = (
        D_delta_rx_7*t417 + D_delta_ry_7*t418 + D_delta_rz_7*t419 + D_delta_x_7*t420 + D_delta_y_7*t423
        + D_delta_z_7*t425 + D_p_rx_1*f_rx_w_carriage_1x + D_p_ry_1*f_ry_w_carriage_1x
        + D_p_rz_1*f_rz_w_carriage_1x + D_p_x_1*f_x_w_carriage_1x + D_p_x_1*t421 + D_p_y_1*f_y_w_carriage_1x
        + D_p_y_1*t422 + D_p_z_1*f_z_w_carriage_1x + D_p_z_1*t424 - t420 + t428
    )
    K_wq_out[..., 0, 1] = (
        D_delta_rx_7*t432 + D_delta_ry_7*t433 + D_delta_rz_7*t434 + D_delta_x_7*t429 + D_delta_y_7*t430
        + D_delta_z_7*t431 + D_p_rx_2*f_rx_w_carriage_1x + D_p_ry_2*f_ry_w_carriage_1x
        + D_p_rz_2*f_rz_w_carriage_1x + D_p_x_2*f_x_w_carriage_1x + D_p_x_2*t421 + D_p_y_2*f_y_w_carriage_1x
        + D_p_y_2*t422 + D_p_z_2*f_z_w_carriage_1x + D_p_z_2*t424
    )
    K_wq_out[..., 0, 2] = (
        D_delta_rx_7*t438 + D_delta_ry_7*t439 + D_delta_rz_7*t440 + D_delta_x_7*t435 + D_delta_y_7*t436
        + D_delta_z_7*t437 + D_p_rx_3*f_rx_w_carriage_1x + D_p_ry_3*f_ry_w_carriage_1x
        + D_p_rz_3*f_rz_w_carriage_1x + D_p_x_3*f_x_w_carriage_1x + D_p_x_3*t421 + D_p_y_3*f_y_w_carriage_1x
        + D_p_y_3*t422 + D_p_z_3*f_z_w_carriage_1x + D_p_z_3*t424
    )
    K_wq_out[..., 0, 3] = (
        D_delta_rx_7*t444 + D_delta_ry_7*t445 + D_delta_rz_7*t446 + D_delta_x_7*t441 + D_delta_y_7*t442
        + D_delta_z_7*t443 + D_p_rx_4*f_rx_w_carriage_1x + D_p_ry_4*f_ry_w_carriage_1x
        + D_p_rz_4*f_rz_w_carriage_1x + D_p_x_4*f_x_w_carriage_1x + D_p_x_4*t421 + D_p_y_4*f_y_w_carriage_1x
        + D_p_y_4*t422 + D_p_z_4*f_z_w_carriage_1x + D_p_z_4*t424
    )
    K_wq_out[..., 0, 4] = (
        D_delta_rx_7*t450 + D_delta_ry_7*t451 + D_delta_rz_7*t452 + D_delta_x_7*t447 + D_delta_y_7*t448
        + D_delta_z_7*t449 + D_p_rx_5*f_rx_w_carriage_1x + D_p_ry_5*f_ry_w_carriage_1x
        + D_p_rz_5*f_rz_w_carriage_1x + D_p_x_5*f_x_w_carriage_1x + D_p_x_5*t421 + D_p_y_5*f_y_w_carriage_1x
        + D_p_y_5*t422 + D_p_z_5*f_z_w_carriage_1x + D_p_z_5*t424
    )
    K_wq_out[..., 0, 5] = (
        D_delta_rx_7*t456 + D_delta_ry_7*t457 + D_delta_rz_7*t458 + D_delta_x_7*t453 + D_delta_y_7*t454
        + D_delta_z_7*t455 + D_p_rx_6*f_rx_w_carriage_1x + D_p_ry_6*f_ry_w_carriage_1x
        + D_p_rz_6*f_rz_w_carriage_1x + D_p_x_6*f_x_w_carriage_1x + D_p_x_6*t421 + D_p_y_6*f_y_w_carriage_1x
        + D_p_y_6*t422 + D_p_z_6*f_z_w_carriage_1x + D_p_z_6*t424
    )
    K_wq_out[..., 0, 6] = -R_p_1*t427
    K_wq_out[..., 0, 12] = -R_p_1*t426
    K_wq_out[..., 0, 24] = (
        D_delta_rx_1*f_rx_w_carriage_1x + D_delta_ry_1*f_ry_w_carriage_1x + D_delta_rz_1*f_rz_w_carriage_1x
        + D_delta_x_1*f_x_w_carriage_1x + D_delta_x_1*t421 + D_delta_y_1*f_y_w_carriage_1x + D_delta_y_1*t422
        + D_delta_z_1*f_z_w_carriage_1x + D_delta_z_1*t424
    )
    K_wq_out[..., 0, 25] = (
        D_delta_rx_2*f_rx_w_carriage_1x + D_delta_ry_2*f_ry_w_carriage_1x + D_delta_rz_2*f_rz_w_carriage_1x
        + D_delta_x_2*f_x_w_carriage_1x + D_delta_x_2*t421 + D_delta_y_2*f_y_w_carriage_1x + D_delta_y_2*t422
        + D_delta_z_2*f_z_w_carriage_1x + D_delta_z_2*t424
    )
    K_wq_out[..., 0, 26] = (
        D_delta_rx_3*f_rx_w_carriage_1x + D_delta_ry_3*f_ry_w_carriage_1x + D_delta_rz_3*f_rz_w_carriage_1x
        + D_delta_x_3*f_x_w_carriage_1x + D_delta_x_3*t421 + D_delta_y_3*f_y_w_carriage_1x + D_delta_y_3*t422
        + D_delta_z_3*f_z_w_carriage_1x + D_delta_z_3*t424
    )
    K_wq_out[..., 0, 27] = (
        D_delta_rx_4*f_rx_w_carriage_1x + D_delta_ry_4*f_ry_w_carriage_1x + D_delta_rz_4*f_rz_w_carriage_1x
        + D_delta_x_4*f_x_w_carriage_1x + D_delta_x_4*t421 + D_delta_y_4*f_y_w_carriage_1x + D_delta_y_4*t422
        + D_delta_z_4*f_z_w_carriage_1x + D_delta_z_4*t424
    )
    K_wq_out[..., 0, 28] = (
        D_delta_rx_5*f_rx_w_carriage_1x + D_delta_ry_5*f_ry_w_carriage_1x + D_delta_rz_5*f_rz_w_carriage_1x
        + D_delta_x_5*f_x_w_carriage_1x + D_delta_x_5*t421 + D_delta_y_5*f_y_w_carriage_1x + D_delta_y_5*t422
        + D_delta_z_5*f_z_w_carriage_1x + D_delta_z_5*t424
    )
    K_wq_out[..., 0, 29] = (
        D_delta_rx_6*f_rx_w_carriage_1x + D_delta_ry_6*f_ry_w_carriage_1x + D_delta_rz_6*f_rz_w_carriage_1x
        + D_delta_x_6*f_x_w_carriage_1x + D_delta_x_6*t421 + D_delta_y_6*f_y_w_carriage_1x + D_delta_y_6*t422
        + D_delta_z_6*f_z_w_carriage_1x + D_delta_z_6*t424
    )
    K_wq_out[..., 0, 30] = t428
    K_wq_out[..., 0, 36] = t421
    K_wq_out[..., 0, 37] = t422
    K_wq_out[..., 0, 38] = t424
    K_wq_out[..., 1, 0] = (
        D_delta_rx_8*t417 + D_delta_ry_8*t418 + D_delta_rz_8*t419 + D_delta_x_8*t420 + D_delta_y_8*t423
        + D_delta_z_8*t425 + D_p_rx_1*f_rx_w_carriage_1y + D_p_ry_1*f_ry_w_carriage_1y
        + D_p_rz_1*f_rz_w_carriage_1y + D_p_x_1*f_x_w_carriage_1y + D_p_x_1*t459 + D_p_y_1*f_y_w_carriage_1y
        + D_p_y_1*t460 + D_p_z_1*f_z_w_carriage_1y + D_p_z_1*t461 - t423 + t464
    )
    K_wq_out[..., 1, 1] = (
        D_delta_rx_8*t432 + D_delta_ry_8*t433 + D_delta_rz_8*t434 + D_delta_x_8*t429 + D_delta_y_8*t430
        + D_delta_z_8*t431 + D_p_rx_2*f_rx_w_carriage_1y + D_p_ry_2*f_ry_w_carriage_1y
        + D_p_rz_2*f_rz_w_carriage_1y + D_p_x_2*f_x_w_carriage_1y + D_p_x_2*t459 + D_p_y_2*f_y_w_carriage_1y
        + D_p_y_2*t460 + D_p_z_2*f_z_w_carriage_1y + D_p_z_2*t461
    )
    K_wq_out[..., 1, 2] = (
        D_delta_rx_8*t438 + D_delta_ry_8*t439 + D_delta_rz_8*t440 + D_delta_x_8*t435 + D_delta_y_8*t436
        + D_delta_z_8*t437 + D_p_rx_3*f_rx_w_carriage_1y + D_p_ry_3*f_ry_w_carriage_1y
        + D_p_rz_3*f_rz_w_carriage_1y + D_p_x_3*f_x_w_carriage_1y + D_p_x_3*t459 + D_p_y_3*f_y_w_carriage_1y
        + D_p_y_3*t460 + D_p_z_3*f_z_w_carriage_1y + D_p_z_3*t461
    )
    K_wq_out[..., 1, 3] = (
        D_delta_rx_8*t444 + D_delta_ry_8*t445 + D_delta_rz_8*t446 + D_delta_x_8*t441 + D_delta_y_8*t442
        + D_delta_z_8*t443 + D_p_rx_4*f_rx_w_carriage_1y + D_p_ry_4*f_ry_w_carriage_1y
        + D_p_rz_4*f_rz_w_carriage_1y + D_p_x_4*f_x_w_carriage_1y + D_p_x_4*t459 + D_p_y_4*f_y_w_carriage_1y
        + D_p_y_4*t460 + D_p_z_4*f_z_w_carriage_1y + D_p_z_4*t461
    )
    K_wq_out[..., 1, 4] = (
        D_delta_rx_8*t450 + D_delta_ry_8*t451 + D_delta_rz_8*t452 + D_delta_x_8*t447 + D_delta_y_8*t448
        + D_delta_z_8*t449 + D_p_rx_5*f_rx_w_carriage_1y + D_p_ry_5*f_ry_w_carriage_1y
        + D_p_rz_5*f_rz_w_carriage_1y + D_p_x_5*f_x_w_carriage_1y + D_p_x_5*t459 + D_p_y_5*f_y_w_carriage_1y
        + D_p_y_5*t460 + D_p_z_5*f_z_w_carriage_1y + D_p_z_5*t461
    )
    K_wq_out[..., 1, 5] = (
        D_delta_rx_8*t456 + D_delta_ry_8*t457 + D_delta_rz_8*t458 + D_delta_x_8*t453 + D_delta_y_8*t454
        + D_delta_z_8*t455 + D_p_rx_6*f_rx_w_carriage_1y + D_p_ry_6*f_ry_w_carriage_1y
        + D_p_rz_6*f_rz_w_carriage_1y + D_p_x_6*f_x_w_carriage_1y + D_p_x_6*t459 + D_p_y_6*f_y_w_carriage_1y
        + D_p_y_6*t460 + D_p_z_6*f_z_w_carriage_1y + D_p_z_6*t461
    )
    K_wq_out[..., 1, 6] = -R_p_1*t463
    K_wq_out[..., 1, 12] = -R_p_1*t462
    K_wq_out[..., 1, 24] = (
        D_delta_rx_1*f_rx_w_carriage_1y + D_delta_ry_1*f_ry_w_carriage_1y + D_delta_rz_1*f_rz_w_carriage_1y
        + D_delta_x_1*f_x_w_carriage_1y + D_delta_x_1*t459 + D_delta_y_1*f_y_w_carriage_1y + D_delta_y_1*t460
        + D_delta_z_1*f_z_w_carriage_1y + D_delta_z_1*t461
    )
    K_wq_out[..., 1, 25] = (
        D_delta_rx_2*f_rx_w_carriage_1y + D_delta_ry_2*f_ry_w_carriage_1y + D_delta_rz_2*f_rz_w_carriage_1y
        + D_delta_x_2*f_x_w_carriage_1y + D_delta_x_2*t459 + D_delta_y_2*f_y_w_carriage_1y + D_delta_y_2*t460
        + D_delta_z_2*f_z_w_carriage_1y + D_delta_z_2*t461
    )
    K_wq_out[..., 1, 26] = (
        D_delta_rx_3*f_rx_w_carriage_1y + D_delta_ry_3*f_ry_w_carriage_1y + D_delta_rz_3*f_rz_w_carriage_1y
        + D_delta_x_3*f_x_w_carriage_1y + D_delta_x_3*t459 + D_delta_y_3*f_y_w_carriage_1y + D_delta_y_3*t460
        + D_delta_z_3*f_z_w_carriage_1y + D_delta_z_3*t461
    )
    K_wq_out[..., 1, 27] = (
        D_delta_rx_4*f_rx_w_carriage_1y + D_delta_ry_4*f_ry_w_carriage_1y + D_delta_rz_4*f_rz_w_carriage_1y
        + D_delta_x_4*f_x_w_carriage_1y + D_delta_x_4*t459 + D_delta_y_4*f_y_w_carriage_1y + D_delta_y_4*t460
        + D_delta_z_4*f_z_w_carriage_1y + D_delta_z_4*t461
    )
    K_wq_out[..., 1, 28] = (
        D_delta_rx_5*f_rx_w_carriage_1y + D_delta_ry_5*f_ry_w_carriage_1y + D_delta_rz_5*f_rz_w_carriage_1y
        + D_delta_x_5*f_x_w_carriage_1y + D_delta_x_5*t459 + D_delta_y_5*f_y_w_carriage_1y + D_delta_y_5*t460
        + D_delta_z_5*f_z_w_carriage_1y + D_delta_z_5*t461
    )
    K_wq_out[..., 1, 29] = (
        D_delta_rx_6*f_rx_w_carriage_1y + D_delta_ry_6*f_ry_w_carriage_1y + D_delta_rz_6*f_rz_w_carriage_1y
        + D_delta_x_6*f_x_w_carriage_1y + D_delta_x_6*t459 + D_delta_y_6*f_y_w_carriage_1y + D_delta_y_6*t460
        + D_delta_z_6*f_z_w_carriage_1y + D_delta_z_6*t461
    )
    K_wq_out[..., 1, 30] = t464
    K_wq_out[..., 1, 36] = t459
    K_wq_out[..., 1, 37] = t460
    K_wq_out[..., 1, 38] = t461
    K_wq_out[..., 2, 0] = (
        D_delta_rx_9*t417 + D_delta_ry_9*t418 + D_delta_rz_9*t419 + D_delta_x_9*t420 + D_delta_y_9*t423
        + D_delta_z_9*t425 + D_p_rx_1*f_rx_w_carriage_1z + D_p_ry_1*f_ry_w_carriage_1z
        + D_p_rz_1*f_rz_w_carriage_1z + D_p_x_1*f_x_w_carriage_1z + D_p_x_1*t465 + D_p_y_1*f_y_w_carriage_1z
        + D_p_y_1*t466 + D_p_z_1*f_z_w_carriage_1z + D_p_z_1*t467 - t425 + t470
    )
    K_wq_out[..., 2, 1] = (
        D_delta_rx_9*t432 + D_delta_ry_9*t433 + D_delta_rz_9*t434 + D_delta_x_9*t429 + D_delta_y_9*t430
        + D_delta_z_9*t431 + D_p_rx_2*f_rx_w_carriage_1z + D_p_ry_2*f_ry_w_carriage_1z
        + D_p_rz_2*f_rz_w_carriage_1z + D_p_x_2*f_x_w_carriage_1z + D_p_x_2*t465 + D_p_y_2*f_y_w_carriage_1z
        + D_p_y_2*t466 + D_p_z_2*f_z_w_carriage_1z + D_p_z_2*t467
    )
    K_wq_out[..., 2, 2] = (
        D_delta_rx_9*t438 + D_delta_ry_9*t439 + D_delta_rz_9*t440 + D_delta_x_9*t435 + D_delta_y_9*t436
        + D_delta_z_9*t437 + D_p_rx_3*f_rx_w_carriage_1z + D_p_ry_3*f_ry_w_carriage_1z
        + D_p_rz_3*f_rz_w_carriage_1z + D_p_x_3*f_x_w_carriage_1z + D_p_x_3*t465 + D_p_y_3*f_y_w_carriage_1z
        + D_p_y_3*t466 + D_p_z_3*f_z_w_carriage_1z + D_p_z_3*t467
    )
    K_wq_out[..., 2, 3] = (
        D_delta_rx_9*t444 + D_delta_ry_9*t445 + D_delta_rz_9*t446 + D_delta_x_9*t441 + D_delta_y_9*t442
        + D_delta_z_9*t443 + D_p_rx_4*f_rx_w_carriage_1z + D_p_ry_4*f_ry_w_carriage_1z
        + D_p_rz_4*f_rz_w_carriage_1z + D_p_x_4*f_x_w_carriage_1z + D_p_x_4*t465 + D_p_y_4*f_y_w_carriage_1z
        + D_p_y_4*t466 + D_p_z_4*f_z_w_carriage_1z + D_p_z_4*t467
    )
    K_wq_out[..., 2, 4] = (
        D_delta_rx_9*t450 + D_delta_ry_9*t451 + D_delta_rz_9*t452 + D_delta_x_9*t447 + D_delta_y_9*t448
        + D_delta_z_9*t449 + D_p_rx_5*f_rx_w_carriage_1z + D_p_ry_5*f_ry_w_carriage_1z
        + D_p_rz_5*f_rz_w_carriage_1z + D_p_x_5*f_x_w_carriage_1z + D_p_x_5*t465 + D_p_y_5*f_y_w_carriage_1z
        + D_p_y_5*t466 + D_p_z_5*f_z_w_carriage_1z + D_p_z_5*t467
    )
    K_wq_out[..., 2, 5] = (
        D_delta_rx_9*t456 + D_delta_ry_9*t457 + D_delta_rz_9*t458 + D_delta_x_9*t453 + D_delta_y_9*t454
        + D_delta_z_9*t455 + D_p_rx_6*f_rx_w_carriage_1z + D_p_ry_6*f_ry_w_carriage_1z
        + D_p_rz_6*f_rz_w_carriage_1z + D_p_x_6*f_x_w_carriage_1z + D_p_x_6*t465 + D_p_y_6*f_y_w_carriage_1z
        + D_p_y_6*t466 + D_p_z_6*f_z_w_carriage_1z + D_p_z_6*t467
    )
    K_wq_out[..., 2, 6] = -R_p_1*t469
    K_wq_out[..., 2, 12] = -R_p_1*t468
    K_wq_out[..., 2, 24] = (
        D_delta_rx_1*f_rx_w_carriage_1z + D_delta_ry_1*f_ry_w_carriage_1z + D_delta_rz_1*f_rz_w_carriage_1z
        + D_delta_x_1*f_x_w_carriage_1z + D_delta_x_1*t465 + D_delta_y_1*f_y_w_carriage_1z + D_delta_y_1*t466
        + D_delta_z_1*f_z_w_carriage_1z + D_delta_z_1*t467
    )
    K_wq_out[..., 2, 25] = (
        D_delta_rx_2*f_rx_w_carriage_1z + D_delta_ry_2*f_ry_w_carriage_1z + D_delta_rz_2*f_rz_w_carriage_1z
        + D_delta_x_2*f_x_w_carriage_1z + D_delta_x_2*t465 + D_delta_y_2*f_y_w_carriage_1z + D_delta_y_2*t466
        + D_delta_z_2*f_z_w_carriage_1z + D_delta_z_2*t467
    )
    K_wq_out[..., 2, 26] = (
        D_delta_rx_3*f_rx_w_carriage_1z + D_delta_ry_3*f_ry_w_carriage_1z + D_delta_rz_3*f_rz_w_carriage_1z
        + D_delta_x_3*f_x_w_carriage_1z + D_delta_x_3*t465 + D_delta_y_3*f_y_w_carriage_1z + D_delta_y_3*t466
        + D_delta_z_3*f_z_w_carriage_1z + D_delta_z_3*t467
    )
    K_wq_out[..., 2, 27] = (
        D_delta_rx_4*f_rx_w_carriage_1z + D_delta_ry_4*f_ry_w_carriage_1z + D_delta_rz_4*f_rz_w_carriage_1z
        + D_delta_x_4*f_x_w_carriage_1z + D_delta_x_4*t465 + D_delta_y_4*f_y_w_carriage_1z + D_delta_y_4*t466
        + D_delta_z_4*f_z_w_carriage_1z + D_delta_z_4*t467
    )
    K_wq_out[..., 2, 28] = (
        D_delta_rx_5*f_rx_w_carriage_1z + D_delta_ry_5*f_ry_w_carriage_1z + D_delta_rz_5*f_rz_w_carriage_1z
        + D_delta_x_5*f_x_w_carriage_1z + D_delta_x_5*t465 + D_delta_y_5*f_y_w_carriage_1z + D_delta_y_5*t466
        + D_delta_z_5*f_z_w_carriage_1z + D_delta_z_5*t467
    )
    K_wq_out[..., 2, 29] = (
        D_delta_rx_6*f_rx_w_carriage_1z + D_delta_ry_6*f_ry_w_carriage_1z + D_delta_rz_6*f_rz_w_carriage_1z
        + D_delta_x_6*f_x_w_carriage_1z + D_delta_x_6*t465 + D_delta_y_6*f_y_w_carriage_1z + D_delta_y_6*t466
        + D_delta_z_6*f_z_w_carriage_1z + D_delta_z_6*t467
    )
    K_wq_out[..., 2, 30] = t470
    K_wq_out[..., 2, 36] = t465
    K_wq_out[..., 2, 37] = t466
    K_wq_out[..., 2, 38] = t467
    K_wq_out[..., 3, 0] = (
        D_delta_rx_10*t417 + D_delta_ry_10*t418 + D_delta_rz_10*t419 + D_delta_x_10*t420 + D_delta_y_10*t423
        + D_delta_z_10*t425 + D_p_rx_1*f_rx_w_carriage_2x + D_p_ry_1*f_ry_w_carriage_2x
        + D_p_rz_1*f_rz_w_carriage_2x + D_p_x_1*f_x_w_carriage_2x + D_p_x_1*t471 + D_p_y_1*f_y_w_carriage_2x
        + D_p_y_1*t472 + D_p_z_1*f_z_w_carriage_2x + D_p_z_1*t473
    )
    K_wq_out[..., 3, 1] = (
        D_delta_rx_10*t432 + D_delta_ry_10*t433 + D_delta_rz_10*t434 + D_delta_x_10*t429 + D_delta_y_10*t430
        + D_delta_z_10*t431 + D_p_rx_2*f_rx_w_carriage_2x + D_p_ry_2*f_ry_w_carriage_2x
        + D_p_rz_2*f_rz_w_carriage_2x + D_p_x_2*f_x_w_carriage_2x + D_p_x_2*t471 + D_p_y_2*f_y_w_carriage_2x
        + D_p_y_2*t472 + D_p_z_2*f_z_w_carriage_2x + D_p_z_2*t473 - t429 + t476
    )
    K_wq_out[..., 3, 2] = (
        D_delta_rx_10*t438 + D_delta_ry_10*t439 + D_delta_rz_10*t440 + D_delta_x_10*t435 + D_delta_y_10*t436
        + D_delta_z_10*t437 + D_p_rx_3*f_rx_w_carriage_2x + D_p_ry_3*f_ry_w_carriage_2x
        + D_p_rz_3*f_rz_w_carriage_2x + D_p_x_3*f_x_w_carriage_2x + D_p_x_3*t471 + D_p_y_3*f_y_w_carriage_2x
        + D_p_y_3*t472 + D_p_z_3*f_z_w_carriage_2x + D_p_z_3*t473
    )
    K_wq_out[..., 3, 3] = (
        D_delta_rx_10*t444 + D_delta_ry_10*t445 + D_delta_rz_10*t446 + D_delta_x_10*t441 + D_delta_y_10*t442
        + D_delta_z_10*t443 + D_p_rx_4*f_rx_w_carriage_2x + D_p_ry_4*f_ry_w_carriage_2x
        + D_p_rz_4*f_rz_w_carriage_2x + D_p_x_4*f_x_w_carriage_2x + D_p_x_4*t471 + D_p_y_4*f_y_w_carriage_2x
        + D_p_y_4*t472 + D_p_z_4*f_z_w_carriage_2x + D_p_z_4*t473
    )
    K_wq_out[..., 3, 4] = (
        D_delta_rx_10*t450 + D_delta_ry_10*t451 + D_delta_rz_10*t452 + D_delta_x_10*t447 + D_delta_y_10*t448
        + D_delta_z_10*t449 + D_p_rx_5*f_rx_w_carriage_2x + D_p_ry_5*f_ry_w_carriage_2x
        + D_p_rz_5*f_rz_w_carriage_2x + D_p_x_5*f_x_w_carriage_2x + D_p_x_5*t471 + D_p_y_5*f_y_w_carriage_2x
        + D_p_y_5*t472 + D_p_z_5*f_z_w_carriage_2x + D_p_z_5*t473
    )
    K_wq_out[..., 3, 5] = (
        D_delta_rx_10*t456 + D_delta_ry_10*t457 + D_delta_rz_10*t458 + D_delta_x_10*t453 + D_delta_y_10*t454
        + D_delta_z_10*t455 + D_p_rx_6*f_rx_w_carriage_2x + D_p_ry_6*f_ry_w_carriage_2x
        + D_p_rz_6*f_rz_w_carriage_2x + D_p_x_6*f_x_w_carriage_2x + D_p_x_6*t471 + D_p_y_6*f_y_w_carriage_2x
        + D_p_y_6*t472 + D_p_z_6*f_z_w_carriage_2x + D_p_z_6*t473
    )
    K_wq_out[..., 3, 7] = -R_p_2*t475
    K_wq_out[..., 3, 13] = -R_p_2*t474
    K_wq_out[..., 3, 24] = (
        D_delta_rx_1*f_rx_w_carriage_2x + D_delta_ry_1*f_ry_w_carriage_2x + D_delta_rz_1*f_rz_w_carriage_2x
        + D_delta_x_1*f_x_w_carriage_2x + D_delta_x_1*t471 + D_delta_y_1*f_y_w_carriage_2x + D_delta_y_1*t472
        + D_delta_z_1*f_z_w_carriage_2x + D_delta_z_1*t473
    )
    K_wq_out[..., 3, 25] = (
        D_delta_rx_2*f_rx_w_carriage_2x + D_delta_ry_2*f_ry_w_carriage_2x + D_delta_rz_2*f_rz_w_carriage_2x
        + D_delta_x_2*f_x_w_carriage_2x + D_delta_x_2*t471 + D_delta_y_2*f_y_w_carriage_2x + D_delta_y_2*t472
        + D_delta_z_2*f_z_w_carriage_2x + D_delta_z_2*t473
    )
    K_wq_out[..., 3, 26] = (
        D_delta_rx_3*f_rx_w_carriage_2x + D_delta_ry_3*f_ry_w_carriage_2x + D_delta_rz_3*f_rz_w_carriage_2x
        + D_delta_x_3*f_x_w_carriage_2x + D_delta_x_3*t471 + D_delta_y_3*f_y_w_carriage_2x + D_delta_y_3*t472
        + D_delta_z_3*f_z_w_carriage_2x + D_delta_z_3*t473
    )
    K_wq_out[..., 3, 27] = (
        D_delta_rx_4*f_rx_w_carriage_2x + D_delta_ry_4*f_ry_w_carriage_2x + D_delta_rz_4*f_rz_w_carriage_2x
        + D_delta_x_4*f_x_w_carriage_2x + D_delta_x_4*t471 + D_delta_y_4*f_y_w_carriage_2x + D_delta_y_4*t472
        + D_delta_z_4*f_z_w_carriage_2x + D_delta_z_4*t473
    )
    K_wq_out[..., 3, 28] = (
        D_delta_rx_5*f_rx_w_carriage_2x + D_delta_ry_5*f_ry_w_carriage_2x + D_delta_rz_5*f_rz_w_carriage_2x
        + D_delta_x_5*f_x_w_carriage_2x + D_delta_x_5*t471 + D_delta_y_5*f_y_w_carriage_2x + D_delta_y_5*t472
        + D_delta_z_5*f_z_w_carriage_2x + D_delta_z_5*t473
    )
    K_wq_out[..., 3, 29] = (
        D_delta_rx_6*f_rx_w_carriage_2x + D_delta_ry_6*f_ry_w_carriage_2x + D_delta_rz_6*f_rz_w_carriage_2x
        + D_delta_x_6*f_x_w_carriage_2x + D_delta_x_6*t471 + D_delta_y_6*f_y_w_carriage_2x + D_delta_y_6*t472
        + D_delta_z_6*f_z_w_carriage_2x + D_delta_z_6*t473
    )
    K_wq_out[..., 3, 31] = t476
    K_wq_out[..., 3, 36] = t471
    K_wq_out[..., 3, 37] = t472
    K_wq_out[..., 3, 38] = t473
    K_wq_out[..., 4, 0] = (
        D_delta_rx_11*t417 + D_delta_ry_11*t418 + D_delta_rz_11*t419 + D_delta_x_11*t420 + D_delta_y_11*t423
        + D_delta_z_11*t425 + D_p_rx_1*f_rx_w_carriage_2y + D_p_ry_1*f_ry_w_carriage_2y
        + D_p_rz_1*f_rz_w_carriage_2y + D_p_x_1*f_x_w_carriage_2y + D_p_x_1*t477 + D_p_y_1*f_y_w_carriage_2y
        + D_p_y_1*t478 + D_p_z_1*f_z_w_carriage_2y + D_p_z_1*t479
    )
    K_wq_out[..., 4, 1] = (
        D_delta_rx_11*t432 + D_delta_ry_11*t433 + D_delta_rz_11*t434 + D_delta_x_11*t429 + D_delta_y_11*t430
        + D_delta_z_11*t431 + D_p_rx_2*f_rx_w_carriage_2y + D_p_ry_2*f_ry_w_carriage_2y
        + D_p_rz_2*f_rz_w_carriage_2y + D_p_x_2*f_x_w_carriage_2y + D_p_x_2*t477 + D_p_y_2*f_y_w_carriage_2y
        + D_p_y_2*t478 + D_p_z_2*f_z_w_carriage_2y + D_p_z_2*t479 - t430 + t482
    )
    K_wq_out[..., 4, 2] = (
        D_delta_rx_11*t438 + D_delta_ry_11*t439 + D_delta_rz_11*t440 + D_delta_x_11*t435 + D_delta_y_11*t436
        + D_delta_z_11*t437 + D_p_rx_3*f_rx_w_carriage_2y + D_p_ry_3*f_ry_w_carriage_2y
        + D_p_rz_3*f_rz_w_carriage_2y + D_p_x_3*f_x_w_carriage_2y + D_p_x_3*t477 + D_p_y_3*f_y_w_carriage_2y
        + D_p_y_3*t478 + D_p_z_3*f_z_w_carriage_2y + D_p_z_3*t479
    )
    K_wq_out[..., 4, 3] = (
        D_delta_rx_11*t444 + D_delta_ry_11*t445 + D_delta_rz_11*t446 + D_delta_x_11*t441 + D_delta_y_11*t442
        + D_delta_z_11*t443 + D_p_rx_4*f_rx_w_carriage_2y + D_p_ry_4*f_ry_w_carriage_2y
        + D_p_rz_4*f_rz_w_carriage_2y + D_p_x_4*f_x_w_carriage_2y + D_p_x_4*t477 + D_p_y_4*f_y_w_carriage_2y
        + D_p_y_4*t478 + D_p_z_4*f_z_w_carriage_2y + D_p_z_4*t479
    )
    K_wq_out[..., 4, 4] = (
        D_delta_rx_11*t450 + D_delta_ry_11*t451 + D_delta_rz_11*t452 + D_delta_x_11*t447 + D_delta_y_11*t448
        + D_delta_z_11*t449 + D_p_rx_5*f_rx_w_carriage_2y + D_p_ry_5*f_ry_w_carriage_2y
        + D_p_rz_5*f_rz_w_carriage_2y + D_p_x_5*f_x_w_carriage_2y + D_p_x_5*t477 + D_p_y_5*f_y_w_carriage_2y
        + D_p_y_5*t478 + D_p_z_5*f_z_w_carriage_2y + D_p_z_5*t479
    )
    K_wq_out[..., 4, 5] = (
        D_delta_rx_11*t456 + D_delta_ry_11*t457 + D_delta_rz_11*t458 + D_delta_x_11*t453 + D_delta_y_11*t454
        + D_delta_z_11*t455 + D_p_rx_6*f_rx_w_carriage_2y + D_p_ry_6*f_ry_w_carriage_2y
        + D_p_rz_6*f_rz_w_carriage_2y + D_p_x_6*f_x_w_carriage_2y + D_p_x_6*t477 + D_p_y_6*f_y_w_carriage_2y
        + D_p_y_6*t478 + D_p_z_6*f_z_w_carriage_2y + D_p_z_6*t479
    )
    K_wq_out[..., 4, 7] = -R_p_2*t481
    K_wq_out[..., 4, 13] = -R_p_2*t480
    K_wq_out[..., 4, 24] = (
        D_delta_rx_1*f_rx_w_carriage_2y + D_delta_ry_1*f_ry_w_carriage_2y + D_delta_rz_1*f_rz_w_carriage_2y
        + D_delta_x_1*f_x_w_carriage_2y + D_delta_x_1*t477 + D_delta_y_1*f_y_w_carriage_2y + D_delta_y_1*t478
        + D_delta_z_1*f_z_w_carriage_2y + D_delta_z_1*t479
    )
    K_wq_out[..., 4, 25] = (
        D_delta_rx_2*f_rx_w_carriage_2y + D_delta_ry_2*f_ry_w_carriage_2y + D_delta_rz_2*f_rz_w_carriage_2y
        + D_delta_x_2*f_x_w_carriage_2y + D_delta_x_2*t477 + D_delta_y_2*f_y_w_carriage_2y + D_delta_y_2*t478
        + D_delta_z_2*f_z_w_carriage_2y + D_delta_z_2*t479
    )
    K_wq_out[..., 4, 26] = (
        D_delta_rx_3*f_rx_w_carriage_2y + D_delta_ry_3*f_ry_w_carriage_2y + D_delta_rz_3*f_rz_w_carriage_2y
        + D_delta_x_3*f_x_w_carriage_2y + D_delta_x_3*t477 + D_delta_y_3*f_y_w_carriage_2y + D_delta_y_3*t478
        + D_delta_z_3*f_z_w_carriage_2y + D_delta_z_3*t479
    )
    K_wq_out[..., 4, 27] = (
        D_delta_rx_4*f_rx_w_carriage_2y + D_delta_ry_4*f_ry_w_carriage_2y + D_delta_rz_4*f_rz_w_carriage_2y
        + D_delta_x_4*f_x_w_carriage_2y + D_delta_x_4*t477 + D_delta_y_4*f_y_w_carriage_2y + D_delta_y_4*t478
        + D_delta_z_4*f_z_w_carriage_2y + D_delta_z_4*t479
    )
    K_wq_out[..., 4, 28] = (
        D_delta_rx_5*f_rx_w_carriage_2y + D_delta_ry_5*f_ry_w_carriage_2y + D_delta_rz_5*f_rz_w_carriage_2y
        + D_delta_x_5*f_x_w_carriage_2y + D_delta_x_5*t477 + D_delta_y_5*f_y_w_carriage_2y + D_delta_y_5*t478
        + D_delta_z_5*f_z_w_carriage_2y + D_delta_z_5*t479
    )
    K_wq_out[..., 4, 29] = (
        D_delta_rx_6*f_rx_w_carriage_2y + D_delta_ry_6*f_ry_w_carriage_2y + D_delta_rz_6*f_rz_w_carriage_2y
        + D_delta_x_6*f_x_w_carriage_2y + D_delta_x_6*t477 + D_delta_y_6*f_y_w_carriage_2y + D_delta_y_6*t478
        + D_delta_z_6*f_z_w_carriage_2y + D_delta_z_6*t479
    )
    K_wq_out[..., 4, 31] = t482
    K_wq_out[..., 4, 36] = t477
    K_wq_out[..., 4, 37] = t478
    K_wq_out[..., 4, 38] = t479
    K_wq_out[..., 5, 0] = (
        D_delta_rx_12*t417 + D_delta_ry_12*t418 + D_delta_rz_12*t419 + D_delta_x_12*t420 + D_delta_y_12*t423
        + D_delta_z_12*t425 + D_p_rx_1*f_rx_w_carriage_2z + D_p_ry_1*f_ry_w_carriage_2z
        + D_p_rz_1*f_rz_w_carriage_2z + D_p_x_1*f_x_w_carriage_2z + D_p_x_1*t483 + D_p_y_1*f_y_w_carriage_2z
        + D_p_y_1*t484 + D_p_z_1*f_z_w_carriage_2z + D_p_z_1*t485
    )
    K_wq_out[..., 5, 1] = (
        D_delta_rx_12*t432 + D_delta_ry_12*t433 + D_delta_rz_12*t434 + D_delta_x_12*t429 + D_delta_y_12*t430
        + D_delta_z_12*t431 + D_p_rx_2*f_rx_w_carriage_2z + D_p_ry_2*f_ry_w_carriage_2z
        + D_p_rz_2*f_rz_w_carriage_2z + D_p_x_2*f_x_w_carriage_2z + D_p_x_2*t483 + D_p_y_2*f_y_w_carriage_2z
        + D_p_y_2*t484 + D_p_z_2*f_z_w_carriage_2z + D_p_z_2*t485 - t431 + t488
    )
    K_wq_out[..., 5, 2] = (
        D_delta_rx_12*t438 + D_delta_ry_12*t439 + D_delta_rz_12*t440 + D_delta_x_12*t435 + D_delta_y_12*t436
        + D_delta_z_12*t437 + D_p_rx_3*f_rx_w_carriage_2z + D_p_ry_3*f_ry_w_carriage_2z
        + D_p_rz_3*f_rz_w_carriage_2z + D_p_x_3*f_x_w_carriage_2z + D_p_x_3*t483 + D_p_y_3*f_y_w_carriage_2z
        + D_p_y_3*t484 + D_p_z_3*f_z_w_carriage_2z + D_p_z_3*t485
    )
    K_wq_out[..., 5, 3] = (
        D_delta_rx_12*t444 + D_delta_ry_12*t445 + D_delta_rz_12*t446 + D_delta_x_12*t441 + D_delta_y_12*t442
        + D_delta_z_12*t443 + D_p_rx_4*f_rx_w_carriage_2z + D_p_ry_4*f_ry_w_carriage_2z
        + D_p_rz_4*f_rz_w_carriage_2z + D_p_x_4*f_x_w_carriage_2z + D_p_x_4*t483 + D_p_y_4*f_y_w_carriage_2z
        + D_p_y_4*t484 + D_p_z_4*f_z_w_carriage_2z + D_p_z_4*t485
    )
    K_wq_out[..., 5, 4] = (
        D_delta_rx_12*t450 + D_delta_ry_12*t451 + D_delta_rz_12*t452 + D_delta_x_12*t447 + D_delta_y_12*t448
        + D_delta_z_12*t449 + D_p_rx_5*f_rx_w_carriage_2z + D_p_ry_5*f_ry_w_carriage_2z
        + D_p_rz_5*f_rz_w_carriage_2z + D_p_x_5*f_x_w_carriage_2z + D_p_x_5*t483 + D_p_y_5*f_y_w_carriage_2z
        + D_p_y_5*t484 + D_p_z_5*f_z_w_carriage_2z + D_p_z_5*t485
    )
    K_wq_out[..., 5, 5] = (
        D_delta_rx_12*t456 + D_delta_ry_12*t457 + D_delta_rz_12*t458 + D_delta_x_12*t453 + D_delta_y_12*t454
        + D_delta_z_12*t455 + D_p_rx_6*f_rx_w_carriage_2z + D_p_ry_6*f_ry_w_carriage_2z
        + D_p_rz_6*f_rz_w_carriage_2z + D_p_x_6*f_x_w_carriage_2z + D_p_x_6*t483 + D_p_y_6*f_y_w_carriage_2z
        + D_p_y_6*t484 + D_p_z_6*f_z_w_carriage_2z + D_p_z_6*t485
    )
    K_wq_out[..., 5, 7] = -R_p_2*t487
    K_wq_out[..., 5, 13] = -R_p_2*t486
    K_wq_out[..., 5, 24] = (
        D_delta_rx_1*f_rx_w_carriage_2z + D_delta_ry_1*f_ry_w_carriage_2z + D_delta_rz_1*f_rz_w_carriage_2z
        + D_delta_x_1*f_x_w_carriage_2z + D_delta_x_1*t483 + D_delta_y_1*f_y_w_carriage_2z + D_delta_y_1*t484
        + D_delta_z_1*f_z_w_carriage_2z + D_delta_z_1*t485
    )
    K_wq_out[..., 5, 25] = (
        D_delta_rx_2*f_rx_w_carriage_2z + D_delta_ry_2*f_ry_w_carriage_2z + D_delta_rz_2*f_rz_w_carriage_2z
        + D_delta_x_2*f_x_w_carriage_2z + D_delta_x_2*t483 + D_delta_y_2*f_y_w_carriage_2z + D_delta_y_2*t484
        + D_delta_z_2*f_z_w_carriage_2z + D_delta_z_2*t485
    )
    K_wq_out[..., 5, 26] = (
        D_delta_rx_3*f_rx_w_carriage_2z + D_delta_ry_3*f_ry_w_carriage_2z + D_delta_rz_3*f_rz_w_carriage_2z
        + D_delta_x_3*f_x_w_carriage_2z + D_delta_x_3*t483 + D_delta_y_3*f_y_w_carriage_2z + D_delta_y_3*t484
        + D_delta_z_3*f_z_w_carriage_2z + D_delta_z_3*t485
    )
    K_wq_out[..., 5, 27] = (
        D_delta_rx_4*f_rx_w_carriage_2z + D_delta_ry_4*f_ry_w_carriage_2z + D_delta_rz_4*f_rz_w_carriage_2z
        + D_delta_x_4*f_x_w_carriage_2z + D_delta_x_4*t483 + D_delta_y_4*f_y_w_carriage_2z + D_delta_y_4*t484
        + D_delta_z_4*f_z_w_carriage_2z + D_delta_z_4*t485
    )
    K_wq_out[..., 5, 28] = (
        D_delta_rx_5*f_rx_w_carriage_2z + D_delta_ry_5*f_ry_w_carriage_2z + D_delta_rz_5*f_rz_w_carriage_2z
        + D_delta_x_5*f_x_w_carriage_2z + D_delta_x_5*t483 + D_delta_y_5*f_y_w_carriage_2z + D_delta_y_5*t484
        + D_delta_z_5*f_z_w_carriage_2z + D_delta_z_5*t485
    )
    K_wq_out[..., 5, 29] = (
        D_delta_rx_6*f_rx_w_carriage_2z + D_delta_ry_6*f_ry_w_carriage_2z + D_delta_rz_6*f_rz_w_carriage_2z
        + D_delta_x_6*f_x_w_carriage_2z + D_delta_x_6*t483 + D_delta_y_6*f_y_w_carriage_2z + D_delta_y_6*t484
        + D_delta_z_6*f_z_w_carriage_2z + D_delta_z_6*t485
    )
    K_wq_out[..., 5, 31] = t488
    K_wq_out[..., 5, 36] = t483
    K_wq_out[..., 5, 37] = t484
    K_wq_out[..., 5, 38] = t485
    K_wq_out[..., 6, 0] = (
        D_delta_rx_13*t417 + D_delta_ry_13*t418 + D_delta_rz_13*t419 + D_delta_x_13*t420 + D_delta_y_13*t423
        + D_delta_z_13*t425 + D_p_rx_1*f_rx_w_carriage_3x + D_p_ry_1*f_ry_w_carriage_3x
        + D_p_rz_1*f_rz_w_carriage_3x + D_p_x_1*f_x_w_carriage_3x + D_p_x_1*t489 + D_p_y_1*f_y_w_carriage_3x
        + D_p_y_1*t490 + D_p_z_1*f_z_w_carriage_3x + D_p_z_1*t491
    )
    K_wq_out[..., 6, 1] = (
        D_delta_rx_13*t432 + D_delta_ry_13*t433 + D_delta_rz_13*t434 + D_delta_x_13*t429 + D_delta_y_13*t430
        + D_delta_z_13*t431 + D_p_rx_2*f_rx_w_carriage_3x + D_p_ry_2*f_ry_w_carriage_3x
        + D_p_rz_2*f_rz_w_carriage_3x + D_p_x_2*f_x_w_carriage_3x + D_p_x_2*t489 + D_p_y_2*f_y_w_carriage_3x
        + D_p_y_2*t490 + D_p_z_2*f_z_w_carriage_3x + D_p_z_2*t491
    )
    K_wq_out[..., 6, 2] = (
        D_delta_rx_13*t438 + D_delta_ry_13*t439 + D_delta_rz_13*t440 + D_delta_x_13*t435 + D_delta_y_13*t436
        + D_delta_z_13*t437 + D_p_rx_3*f_rx_w_carriage_3x + D_p_ry_3*f_ry_w_carriage_3x
        + D_p_rz_3*f_rz_w_carriage_3x + D_p_x_3*f_x_w_carriage_3x + D_p_x_3*t489 + D_p_y_3*f_y_w_carriage_3x
        + D_p_y_3*t490 + D_p_z_3*f_z_w_carriage_3x + D_p_z_3*t491 - t435 + t494
    )
    K_wq_out[..., 6, 3] = (
        D_delta_rx_13*t444 + D_delta_ry_13*t445 + D_delta_rz_13*t446 + D_delta_x_13*t441 + D_delta_y_13*t442
        + D_delta_z_13*t443 + D_p_rx_4*f_rx_w_carriage_3x + D_p_ry_4*f_ry_w_carriage_3x
        + D_p_rz_4*f_rz_w_carriage_3x + D_p_x_4*f_x_w_carriage_3x + D_p_x_4*t489 + D_p_y_4*f_y_w_carriage_3x
        + D_p_y_4*t490 + D_p_z_4*f_z_w_carriage_3x + D_p_z_4*t491
    )
    K_wq_out[..., 6, 4] = (
        D_delta_rx_13*t450 + D_delta_ry_13*t451 + D_delta_rz_13*t452 + D_delta_x_13*t447 + D_delta_y_13*t448
        + D_delta_z_13*t449 + D_p_rx_5*f_rx_w_carriage_3x + D_p_ry_5*f_ry_w_carriage_3x
        + D_p_rz_5*f_rz_w_carriage_3x + D_p_x_5*f_x_w_carriage_3x + D_p_x_5*t489 + D_p_y_5*f_y_w_carriage_3x
        + D_p_y_5*t490 + D_p_z_5*f_z_w_carriage_3x + D_p_z_5*t491
    )
    K_wq_out[..., 6, 5] = (
        D_delta_rx_13*t456 + D_delta_ry_13*t457 + D_delta_rz_13*t458 + D_delta_x_13*t453 + D_delta_y_13*t454
        + D_delta_z_13*t455 + D_p_rx_6*f_rx_w_carriage_3x + D_p_ry_6*f_ry_w_carriage_3x
        + D_p_rz_6*f_rz_w_carriage_3x + D_p_x_6*f_x_w_carriage_3x + D_p_x_6*t489 + D_p_y_6*f_y_w_carriage_3x
        + D_p_y_6*t490 + D_p_z_6*f_z_w_carriage_3x + D_p_z_6*t491
    )
    K_wq_out[..., 6, 8] = -R_p_3*t493
    K_wq_out[..., 6, 14] = -R_p_3*t492
    K_wq_out[..., 6, 24] = (
        D_delta_rx_1*f_rx_w_carriage_3x + D_delta_ry_1*f_ry_w_carriage_3x + D_delta_rz_1*f_rz_w_carriage_3x
        + D_delta_x_1*f_x_w_carriage_3x + D_delta_x_1*t489 + D_delta_y_1*f_y_w_carriage_3x + D_delta_y_1*t490
        + D_delta_z_1*f_z_w_carriage_3x + D_delta_z_1*t491
    )
    K_wq_out[..., 6, 25] = (
        D_delta_rx_2*f_rx_w_carriage_3x + D_delta_ry_2*f_ry_w_carriage_3x + D_delta_rz_2*f_rz_w_carriage_3x
        + D_delta_x_2*f_x_w_carriage_3x + D_delta_x_2*t489 + D_delta_y_2*f_y_w_carriage_3x + D_delta_y_2*t490
        + D_delta_z_2*f_z_w_carriage_3x + D_delta_z_2*t491
    )
    K_wq_out[..., 6, 26] = (
        D_delta_rx_3*f_rx_w_carriage_3x + D_delta_ry_3*f_ry_w_carriage_3x + D_delta_rz_3*f_rz_w_carriage_3x
        + D_delta_x_3*f_x_w_carriage_3x + D_delta_x_3*t489 + D_delta_y_3*f_y_w_carriage_3x + D_delta_y_3*t490
        + D_delta_z_3*f_z_w_carriage_3x + D_delta_z_3*t491
    )
    K_wq_out[..., 6, 27] = (
        D_delta_rx_4*f_rx_w_carriage_3x + D_delta_ry_4*f_ry_w_carriage_3x + D_delta_rz_4*f_rz_w_carriage_3x
        + D_delta_x_4*f_x_w_carriage_3x + D_delta_x_4*t489 + D_delta_y_4*f_y_w_carriage_3x + D_delta_y_4*t490
        + D_delta_z_4*f_z_w_carriage_3x + D_delta_z_4*t491
    )
    K_wq_out[..., 6, 28] = (
        D_delta_rx_5*f_rx_w_carriage_3x + D_delta_ry_5*f_ry_w_carriage_3x + D_delta_rz_5*f_rz_w_carriage_3x
        + D_delta_x_5*f_x_w_carriage_3x + D_delta_x_5*t489 + D_delta_y_5*f_y_w_carriage_3x + D_delta_y_5*t490
        + D_delta_z_5*f_z_w_carriage_3x + D_delta_z_5*t491
    )
    K_wq_out[..., 6, 29] = (
        D_delta_rx_6*f_rx_w_carriage_3x + D_delta_ry_6*f_ry_w_carriage_3x + D_delta_rz_6*f_rz_w_carriage_3x
        + D_delta_x_6*f_x_w_carriage_3x + D_delta_x_6*t489 + D_delta_y_6*f_y_w_carriage_3x + D_delta_y_6*t490
        + D_delta_z_6*f_z_w_carriage_3x + D_delta_z_6*t491
    )
    K_wq_out[..., 6, 32] = t494
    K_wq_out[..., 6, 36] = t489
    K_wq_out[..., 6, 37] = t490
    K_wq_out[..., 6, 38] = t491
    K_wq_out[..., 7, 0] = (
        D_delta_rx_14*t417 + D_delta_ry_14*t418 + D_delta_rz_14*t419 + D_delta_x_14*t420 + D_delta_y_14*t423
        + D_delta_z_14*t425 + D_p_rx_1*f_rx_w_carriage_3y + D_p_ry_1*f_ry_w_carriage_3y
        + D_p_rz_1*f_rz_w_carriage_3y + D_p_x_1*f_x_w_carriage_3y + D_p_x_1*t495 + D_p_y_1*f_y_w_carriage_3y
        + D_p_y_1*t496 + D_p_z_1*f_z_w_carriage_3y + D_p_z_1*t497
    )
    K_wq_out[..., 7, 1] = (
        D_delta_rx_14*t432 + D_delta_ry_14*t433 + D_delta_rz_14*t434 + D_delta_x_14*t429 + D_delta_y_14*t430
        + D_delta_z_14*t431 + D_p_rx_2*f_rx_w_carriage_3y + D_p_ry_2*f_ry_w_carriage_3y
        + D_p_rz_2*f_rz_w_carriage_3y + D_p_x_2*f_x_w_carriage_3y + D_p_x_2*t495 + D_p_y_2*f_y_w_carriage_3y
        + D_p_y_2*t496 + D_p_z_2*f_z_w_carriage_3y + D_p_z_2*t497
    )
    K_wq_out[..., 7, 2] = (
        D_delta_rx_14*t438 + D_delta_ry_14*t439 + D_delta_rz_14*t440 + D_delta_x_14*t435 + D_delta_y_14*t436
        + D_delta_z_14*t437 + D_p_rx_3*f_rx_w_carriage_3y + D_p_ry_3*f_ry_w_carriage_3y
        + D_p_rz_3*f_rz_w_carriage_3y + D_p_x_3*f_x_w_carriage_3y + D_p_x_3*t495 + D_p_y_3*f_y_w_carriage_3y
        + D_p_y_3*t496 + D_p_z_3*f_z_w_carriage_3y + D_p_z_3*t497 - t436 + t500
    )
    K_wq_out[..., 7, 3] = (
        D_delta_rx_14*t444 + D_delta_ry_14*t445 + D_delta_rz_14*t446 + D_delta_x_14*t441 + D_delta_y_14*t442
        + D_delta_z_14*t443 + D_p_rx_4*f_rx_w_carriage_3y + D_p_ry_4*f_ry_w_carriage_3y
        + D_p_rz_4*f_rz_w_carriage_3y + D_p_x_4*f_x_w_carriage_3y + D_p_x_4*t495 + D_p_y_4*f_y_w_carriage_3y
        + D_p_y_4*t496 + D_p_z_4*f_z_w_carriage_3y + D_p_z_4*t497
    )
    K_wq_out[..., 7, 4] = (
        D_delta_rx_14*t450 + D_delta_ry_14*t451 + D_delta_rz_14*t452 + D_delta_x_14*t447 + D_delta_y_14*t448
        + D_delta_z_14*t449 + D_p_rx_5*f_rx_w_carriage_3y + D_p_ry_5*f_ry_w_carriage_3y
        + D_p_rz_5*f_rz_w_carriage_3y + D_p_x_5*f_x_w_carriage_3y + D_p_x_5*t495 + D_p_y_5*f_y_w_carriage_3y
        + D_p_y_5*t496 + D_p_z_5*f_z_w_carriage_3y + D_p_z_5*t497
    )
    K_wq_out[..., 7, 5] = (
        D_delta_rx_14*t456 + D_delta_ry_14*t457 + D_delta_rz_14*t458 + D_delta_x_14*t453 + D_delta_y_14*t454
        + D_delta_z_14*t455 + D_p_rx_6*f_rx_w_carriage_3y + D_p_ry_6*f_ry_w_carriage_3y
        + D_p_rz_6*f_rz_w_carriage_3y + D_p_x_6*f_x_w_carriage_3y + D_p_x_6*t495 + D_p_y_6*f_y_w_carriage_3y
        + D_p_y_6*t496 + D_p_z_6*f_z_w_carriage_3y + D_p_z_6*t497
    )
    K_wq_out[..., 7, 8] = -R_p_3*t499
    K_wq_out[..., 7, 14] = -R_p_3*t498
    K_wq_out[..., 7, 24] = (
        D_delta_rx_1*f_rx_w_carriage_3y + D_delta_ry_1*f_ry_w_carriage_3y + D_delta_rz_1*f_rz_w_carriage_3y
        + D_delta_x_1*f_x_w_carriage_3y + D_delta_x_1*t495 + D_delta_y_1*f_y_w_carriage_3y + D_delta_y_1*t496
        + D_delta_z_1*f_z_w_carriage_3y + D_delta_z_1*t497
    )
    K_wq_out[..., 7, 25] = (
        D_delta_rx_2*f_rx_w_carriage_3y + D_delta_ry_2*f_ry_w_carriage_3y + D_delta_rz_2*f_rz_w_carriage_3y
        + D_delta_x_2*f_x_w_carriage_3y + D_delta_x_2*t495 + D_delta_y_2*f_y_w_carriage_3y + D_delta_y_2*t496
        + D_delta_z_2*f_z_w_carriage_3y + D_delta_z_2*t497
    )
    K_wq_out[..., 7, 26] = (
        D_delta_rx_3*f_rx_w_carriage_3y + D_delta_ry_3*f_ry_w_carriage_3y + D_delta_rz_3*f_rz_w_carriage_3y
        + D_delta_x_3*f_x_w_carriage_3y + D_delta_x_3*t495 + D_delta_y_3*f_y_w_carriage_3y + D_delta_y_3*t496
        + D_delta_z_3*f_z_w_carriage_3y + D_delta_z_3*t497
    )
    K_wq_out[..., 7, 27] = (
        D_delta_rx_4*f_rx_w_carriage_3y + D_delta_ry_4*f_ry_w_carriage_3y + D_delta_rz_4*f_rz_w_carriage_3y
        + D_delta_x_4*f_x_w_carriage_3y + D_delta_x_4*t495 + D_delta_y_4*f_y_w_carriage_3y + D_delta_y_4*t496
        + D_delta_z_4*f_z_w_carriage_3y + D_delta_z_4*t497
    )
    K_wq_out[..., 7, 28] = (
        D_delta_rx_5*f_rx_w_carriage_3y + D_delta_ry_5*f_ry_w_carriage_3y + D_delta_rz_5*f_rz_w_carriage_3y
        + D_delta_x_5*f_x_w_carriage_3y + D_delta_x_5*t495 + D_delta_y_5*f_y_w_carriage_3y + D_delta_y_5*t496
        + D_delta_z_5*f_z_w_carriage_3y + D_delta_z_5*t497
    )
    K_wq_out[..., 7, 29] = (
        D_delta_rx_6*f_rx_w_carriage_3y + D_delta_ry_6*f_ry_w_carriage_3y + D_delta_rz_6*f_rz_w_carriage_3y
        + D_delta_x_6*f_x_w_carriage_3y + D_delta_x_6*t495 + D_delta_y_6*f_y_w_carriage_3y + D_delta_y_6*t496
        + D_delta_z_6*f_z_w_carriage_3y + D_delta_z_6*t497
    )
    K_wq_out[..., 7, 32] = t500
    K_wq_out[..., 7, 36] = t495
    K_wq_out[..., 7, 37] = t496
    K_wq_out[..., 7, 38] = t497
    K_wq_out[..., 8, 0] = (
        D_delta_rx_15*t417 + D_delta_ry_15*t418 + D_delta_rz_15*t419 + D_delta_x_15*t420 + D_delta_y_15*t423
        + D_delta_z_15*t425 + D_p_rx_1*f_rx_w_carriage_3z + D_p_ry_1*f_ry_w_carriage_3z
        + D_p_rz_1*f_rz_w_carriage_3z + D_p_x_1*f_x_w_carriage_3z + D_p_x_1*t501 + D_p_y_1*f_y_w_carriage_3z
        + D_p_y_1*t502 + D_p_z_1*f_z_w_carriage_3z + D_p_z_1*t503
    )
    K_wq_out[..., 8, 1] = (
        D_delta_rx_15*t432 + D_delta_ry_15*t433 + D_delta_rz_15*t434 + D_delta_x_15*t429 + D_delta_y_15*t430
        + D_delta_z_15*t431 + D_p_rx_2*f_rx_w_carriage_3z + D_p_ry_2*f_ry_w_carriage_3z
        + D_p_rz_2*f_rz_w_carriage_3z + D_p_x_2*f_x_w_carriage_3z + D_p_x_2*t501 + D_p_y_2*f_y_w_carriage_3z
        + D_p_y_2*t502 + D_p_z_2*f_z_w_carriage_3z + D_p_z_2*t503
    )
    K_wq_out[..., 8, 2] = (
        D_delta_rx_15*t438 + D_delta_ry_15*t439 + D_delta_rz_15*t440 + D_delta_x_15*t435 + D_delta_y_15*t436
        + D_delta_z_15*t437 + D_p_rx_3*f_rx_w_carriage_3z + D_p_ry_3*f_ry_w_carriage_3z
        + D_p_rz_3*f_rz_w_carriage_3z + D_p_x_3*f_x_w_carriage_3z + D_p_x_3*t501 + D_p_y_3*f_y_w_carriage_3z
        + D_p_y_3*t502 + D_p_z_3*f_z_w_carriage_3z + D_p_z_3*t503 - t437 + t506
    )
    K_wq_out[..., 8, 3] = (
        D_delta_rx_15*t444 + D_delta_ry_15*t445 + D_delta_rz_15*t446 + D_delta_x_15*t441 + D_delta_y_15*t442
        + D_delta_z_15*t443 + D_p_rx_4*f_rx_w_carriage_3z + D_p_ry_4*f_ry_w_carriage_3z
        + D_p_rz_4*f_rz_w_carriage_3z + D_p_x_4*f_x_w_carriage_3z + D_p_x_4*t501 + D_p_y_4*f_y_w_carriage_3z
        + D_p_y_4*t502 + D_p_z_4*f_z_w_carriage_3z + D_p_z_4*t503
    )
    K_wq_out[..., 8, 4] = (
        D_delta_rx_15*t450 + D_delta_ry_15*t451 + D_delta_rz_15*t452 + D_delta_x_15*t447 + D_delta_y_15*t448
        + D_delta_z_15*t449 + D_p_rx_5*f_rx_w_carriage_3z + D_p_ry_5*f_ry_w_carriage_3z
        + D_p_rz_5*f_rz_w_carriage_3z + D_p_x_5*f_x_w_carriage_3z + D_p_x_5*t501 + D_p_y_5*f_y_w_carriage_3z
        + D_p_y_5*t502 + D_p_z_5*f_z_w_carriage_3z + D_p_z_5*t503
    )
    K_wq_out[..., 8, 5] = (
        D_delta_rx_15*t456 + D_delta_ry_15*t457 + D_delta_rz_15*t458 + D_delta_x_15*t453 + D_delta_y_15*t454
        + D_delta_z_15*t455 + D_p_rx_6*f_rx_w_carriage_3z + D_p_ry_6*f_ry_w_carriage_3z
        + D_p_rz_6*f_rz_w_carriage_3z + D_p_x_6*f_x_w_carriage_3z + D_p_x_6*t501 + D_p_y_6*f_y_w_carriage_3z
        + D_p_y_6*t502 + D_p_z_6*f_z_w_carriage_3z + D_p_z_6*t503
    )
    K_wq_out[..., 8, 8] = -R_p_3*t505
    K_wq_out[..., 8, 14] = -R_p_3*t504
    K_wq_out[..., 8, 24] = (
        D_delta_rx_1*f_rx_w_carriage_3z + D_delta_ry_1*f_ry_w_carriage_3z + D_delta_rz_1*f_rz_w_carriage_3z
        + D_delta_x_1*f_x_w_carriage_3z + D_delta_x_1*t501 + D_delta_y_1*f_y_w_carriage_3z + D_delta_y_1*t502
        + D_delta_z_1*f_z_w_carriage_3z + D_delta_z_1*t503
    )
    K_wq_out[..., 8, 25] = (
        D_delta_rx_2*f_rx_w_carriage_3z + D_delta_ry_2*f_ry_w_carriage_3z + D_delta_rz_2*f_rz_w_carriage_3z
        + D_delta_x_2*f_x_w_carriage_3z + D_delta_x_2*t501 + D_delta_y_2*f_y_w_carriage_3z + D_delta_y_2*t502
        + D_delta_z_2*f_z_w_carriage_3z + D_delta_z_2*t503
    )
    K_wq_out[..., 8, 26] = (
        D_delta_rx_3*f_rx_w_carriage_3z + D_delta_ry_3*f_ry_w_carriage_3z + D_delta_rz_3*f_rz_w_carriage_3z
        + D_delta_x_3*f_x_w_carriage_3z + D_delta_x_3*t501 + D_delta_y_3*f_y_w_carriage_3z + D_delta_y_3*t502
        + D_delta_z_3*f_z_w_carriage_3z + D_delta_z_3*t503
    )
    K_wq_out[..., 8, 27] = (
        D_delta_rx_4*f_rx_w_carriage_3z + D_delta_ry_4*f_ry_w_carriage_3z + D_delta_rz_4*f_rz_w_carriage_3z
        + D_delta_x_4*f_x_w_carriage_3z + D_delta_x_4*t501 + D_delta_y_4*f_y_w_carriage_3z + D_delta_y_4*t502
        + D_delta_z_4*f_z_w_carriage_3z + D_delta_z_4*t503
    )
    K_wq_out[..., 8, 28] = (
        D_delta_rx_5*f_rx_w_carriage_3z + D_delta_ry_5*f_ry_w_carriage_3z + D_delta_rz_5*f_rz_w_carriage_3z
        + D_delta_x_5*f_x_w_carriage_3z + D_delta_x_5*t501 + D_delta_y_5*f_y_w_carriage_3z + D_delta_y_5*t502
        + D_delta_z_5*f_z_w_carriage_3z + D_delta_z_5*t503
    )
    K_wq_out[..., 8, 29] = (
        D_delta_rx_6*f_rx_w_carriage_3z + D_delta_ry_6*f_ry_w_carriage_3z + D_delta_rz_6*f_rz_w_carriage_3z
        + D_delta_x_6*f_x_w_carriage_3z + D_delta_x_6*t501 + D_delta_y_6*f_y_w_carriage_3z + D_delta_y_6*t502
        + D_delta_z_6*f_z_w_carriage_3z + D_delta_z_6*t503
    )
    K_wq_out[..., 8, 32] = t506
    K_wq_out[..., 8, 36] = t501
    K_wq_out[..., 8, 37] = t502
    K_wq_out[..., 8, 38] = t503
    K_wq_out[..., 9, 0] = (
        D_delta_rx_16*t417 + D_delta_ry_16*t418 + D_delta_rz_16*t419 + D_delta_x_16*t420 + D_delta_y_16*t423
        + D_delta_z_16*t425 + D_p_rx_1*f_rx_w_carriage_4x + D_p_ry_1*f_ry_w_carriage_4x
        + D_p_rz_1*f_rz_w_carriage_4x + D_p_x_1*f_x_w_carriage_4x + D_p_x_1*t507 + D_p_y_1*f_y_w_carriage_4x
        + D_p_y_1*t508 + D_p_z_1*f_z_w_carriage_4x + D_p_z_1*t509
    )
    K_wq_out[..., 9, 1] = (
        D_delta_rx_16*t432 + D_delta_ry_16*t433 + D_delta_rz_16*t434 + D_delta_x_16*t429 + D_delta_y_16*t430
        + D_delta_z_16*t431 + D_p_rx_2*f_rx_w_carriage_4x + D_p_ry_2*f_ry_w_carriage_4x
        + D_p_rz_2*f_rz_w_carriage_4x + D_p_x_2*f_x_w_carriage_4x + D_p_x_2*t507 + D_p_y_2*f_y_w_carriage_4x
        + D_p_y_2*t508 + D_p_z_2*f_z_w_carriage_4x + D_p_z_2*t509
    )
    K_wq_out[..., 9, 2] = (
        D_delta_rx_16*t438 + D_delta_ry_16*t439 + D_delta_rz_16*t440 + D_delta_x_16*t435 + D_delta_y_16*t436
        + D_delta_z_16*t437 + D_p_rx_3*f_rx_w_carriage_4x + D_p_ry_3*f_ry_w_carriage_4x
        + D_p_rz_3*f_rz_w_carriage_4x + D_p_x_3*f_x_w_carriage_4x + D_p_x_3*t507 + D_p_y_3*f_y_w_carriage_4x
        + D_p_y_3*t508 + D_p_z_3*f_z_w_carriage_4x + D_p_z_3*t509
    )
    K_wq_out[..., 9, 3] = (
        D_delta_rx_16*t444 + D_delta_ry_16*t445 + D_delta_rz_16*t446 + D_delta_x_16*t441 + D_delta_y_16*t442
        + D_delta_z_16*t443 + D_p_rx_4*f_rx_w_carriage_4x + D_p_ry_4*f_ry_w_carriage_4x
        + D_p_rz_4*f_rz_w_carriage_4x + D_p_x_4*f_x_w_carriage_4x + D_p_x_4*t507 + D_p_y_4*f_y_w_carriage_4x
        + D_p_y_4*t508 + D_p_z_4*f_z_w_carriage_4x + D_p_z_4*t509 - t441 + t512
    )
    K_wq_out[..., 9, 4] = (
        D_delta_rx_16*t450 + D_delta_ry_16*t451 + D_delta_rz_16*t452 + D_delta_x_16*t447 + D_delta_y_16*t448
        + D_delta_z_16*t449 + D_p_rx_5*f_rx_w_carriage_4x + D_p_ry_5*f_ry_w_carriage_4x
        + D_p_rz_5*f_rz_w_carriage_4x + D_p_x_5*f_x_w_carriage_4x + D_p_x_5*t507 + D_p_y_5*f_y_w_carriage_4x
        + D_p_y_5*t508 + D_p_z_5*f_z_w_carriage_4x + D_p_z_5*t509
    )
    K_wq_out[..., 9, 5] = (
        D_delta_rx_16*t456 + D_delta_ry_16*t457 + D_delta_rz_16*t458 + D_delta_x_16*t453 + D_delta_y_16*t454
        + D_delta_z_16*t455 + D_p_rx_6*f_rx_w_carriage_4x + D_p_ry_6*f_ry_w_carriage_4x
        + D_p_rz_6*f_rz_w_carriage_4x + D_p_x_6*f_x_w_carriage_4x + D_p_x_6*t507 + D_p_y_6*f_y_w_carriage_4x
        + D_p_y_6*t508 + D_p_z_6*f_z_w_carriage_4x + D_p_z_6*t509
    )
    K_wq_out[..., 9, 9] = -R_p_4*t511
    K_wq_out[..., 9, 15] = -R_p_4*t510
    K_wq_out[..., 9, 24] = (
        D_delta_rx_1*f_rx_w_carriage_4x + D_delta_ry_1*f_ry_w_carriage_4x + D_delta_rz_1*f_rz_w_carriage_4x
        + D_delta_x_1*f_x_w_carriage_4x + D_delta_x_1*t507 + D_delta_y_1*f_y_w_carriage_4x + D_delta_y_1*t508
        + D_delta_z_1*f_z_w_carriage_4x + D_delta_z_1*t509
    )
    K_wq_out[..., 9, 25] = (
        D_delta_rx_2*f_rx_w_carriage_4x + D_delta_ry_2*f_ry_w_carriage_4x + D_delta_rz_2*f_rz_w_carriage_4x
        + D_delta_x_2*f_x_w_carriage_4x + D_delta_x_2*t507 + D_delta_y_2*f_y_w_carriage_4x + D_delta_y_2*t508
        + D_delta_z_2*f_z_w_carriage_4x + D_delta_z_2*t509
    )
    K_wq_out[..., 9, 26] = (
        D_delta_rx_3*f_rx_w_carriage_4x + D_delta_ry_3*f_ry_w_carriage_4x + D_delta_rz_3*f_rz_w_carriage_4x
        + D_delta_x_3*f_x_w_carriage_4x + D_delta_x_3*t507 + D_delta_y_3*f_y_w_carriage_4x + D_delta_y_3*t508
        + D_delta_z_3*f_z_w_carriage_4x + D_delta_z_3*t509
    )
    K_wq_out[..., 9, 27] = (
        D_delta_rx_4*f_rx_w_carriage_4x + D_delta_ry_4*f_ry_w_carriage_4x + D_delta_rz_4*f_rz_w_carriage_4x
        + D_delta_x_4*f_x_w_carriage_4x + D_delta_x_4*t507 + D_delta_y_4*f_y_w_carriage_4x + D_delta_y_4*t508
        + D_delta_z_4*f_z_w_carriage_4x + D_delta_z_4*t509
    )
    K_wq_out[..., 9, 28] = (
        D_delta_rx_5*f_rx_w_carriage_4x + D_delta_ry_5*f_ry_w_carriage_4x + D_delta_rz_5*f_rz_w_carriage_4x
        + D_delta_x_5*f_x_w_carriage_4x + D_delta_x_5*t507 + D_delta_y_5*f_y_w_carriage_4x + D_delta_y_5*t508
        + D_delta_z_5*f_z_w_carriage_4x + D_delta_z_5*t509
    )
    K_wq_out[..., 9, 29] = (
        D_delta_rx_6*f_rx_w_carriage_4x + D_delta_ry_6*f_ry_w_carriage_4x + D_delta_rz_6*f_rz_w_carriage_4x
        + D_delta_x_6*f_x_w_carriage_4x + D_delta_x_6*t507 + D_delta_y_6*f_y_w_carriage_4x + D_delta_y_6*t508
        + D_delta_z_6*f_z_w_carriage_4x + D_delta_z_6*t509
    )
    K_wq_out[..., 9, 33] = t512
    K_wq_out[..., 9, 36] = t507
    K_wq_out[..., 9, 37] = t508
    K_wq_out[..., 9, 38] = t509
    K_wq_out[..., 10, 0] = (
        D_delta_rx_17*t417 + D_delta_ry_17*t418 + D_delta_rz_17*t419 + D_delta_x_17*t420 + D_delta_y_17*t423
        + D_delta_z_17*t425 + D_p_rx_1*f_rx_w_carriage_4y + D_p_ry_1*f_ry_w_carriage_4y
        + D_p_rz_1*f_rz_w_carriage_4y + D_p_x_1*f_x_w_carriage_4y + D_p_x_1*t513 + D_p_y_1*f_y_w_carriage_4y
        + D_p_y_1*t514 + D_p_z_1*f_z_w_carriage_4y + D_p_z_1*t515
    )
    K_wq_out[..., 10, 1] = (
        D_delta_rx_17*t432 + D_delta_ry_17*t433 + D_delta_rz_17*t434 + D_delta_x_17*t429 + D_delta_y_17*t430
        + D_delta_z_17*t431 + D_p_rx_2*f_rx_w_carriage_4y + D_p_ry_2*f_ry_w_carriage_4y
        + D_p_rz_2*f_rz_w_carriage_4y + D_p_x_2*f_x_w_carriage_4y + D_p_x_2*t513 + D_p_y_2*f_y_w_carriage_4y
        + D_p_y_2*t514 + D_p_z_2*f_z_w_carriage_4y + D_p_z_2*t515
    )
    K_wq_out[..., 10, 2] = (
        D_delta_rx_17*t438 + D_delta_ry_17*t439 + D_delta_rz_17*t440 + D_delta_x_17*t435 + D_delta_y_17*t436
        + D_delta_z_17*t437 + D_p_rx_3*f_rx_w_carriage_4y + D_p_ry_3*f_ry_w_carriage_4y
        + D_p_rz_3*f_rz_w_carriage_4y + D_p_x_3*f_x_w_carriage_4y + D_p_x_3*t513 + D_p_y_3*f_y_w_carriage_4y
        + D_p_y_3*t514 + D_p_z_3*f_z_w_carriage_4y + D_p_z_3*t515
    )
    K_wq_out[..., 10, 3] = (
        D_delta_rx_17*t444 + D_delta_ry_17*t445 + D_delta_rz_17*t446 + D_delta_x_17*t441 + D_delta_y_17*t442
        + D_delta_z_17*t443 + D_p_rx_4*f_rx_w_carriage_4y + D_p_ry_4*f_ry_w_carriage_4y
        + D_p_rz_4*f_rz_w_carriage_4y + D_p_x_4*f_x_w_carriage_4y + D_p_x_4*t513 + D_p_y_4*f_y_w_carriage_4y
        + D_p_y_4*t514 + D_p_z_4*f_z_w_carriage_4y + D_p_z_4*t515 - t442 + t518
    )
    K_wq_out[..., 10, 4] = (
        D_delta_rx_17*t450 + D_delta_ry_17*t451 + D_delta_rz_17*t452 + D_delta_x_17*t447 + D_delta_y_17*t448
        + D_delta_z_17*t449 + D_p_rx_5*f_rx_w_carriage_4y + D_p_ry_5*f_ry_w_carriage_4y
        + D_p_rz_5*f_rz_w_carriage_4y + D_p_x_5*f_x_w_carriage_4y + D_p_x_5*t513 + D_p_y_5*f_y_w_carriage_4y
        + D_p_y_5*t514 + D_p_z_5*f_z_w_carriage_4y + D_p_z_5*t515
    )
    K_wq_out[..., 10, 5] = (
        D_delta_rx_17*t456 + D_delta_ry_17*t457 + D_delta_rz_17*t458 + D_delta_x_17*t453 + D_delta_y_17*t454
        + D_delta_z_17*t455 + D_p_rx_6*f_rx_w_carriage_4y + D_p_ry_6*f_ry_w_carriage_4y
        + D_p_rz_6*f_rz_w_carriage_4y + D_p_x_6*f_x_w_carriage_4y + D_p_x_6*t513 + D_p_y_6*f_y_w_carriage_4y
        + D_p_y_6*t514 + D_p_z_6*f_z_w_carriage_4y + D_p_z_6*t515
    )
    K_wq_out[..., 10, 9] = -R_p_4*t517
    K_wq_out[..., 10, 15] = -R_p_4*t516
    K_wq_out[..., 10, 24] = (
        D_delta_rx_1*f_rx_w_carriage_4y + D_delta_ry_1*f_ry_w_carriage_4y + D_delta_rz_1*f_rz_w_carriage_4y
        + D_delta_x_1*f_x_w_carriage_4y + D_delta_x_1*t513 + D_delta_y_1*f_y_w_carriage_4y + D_delta_y_1*t514
        + D_delta_z_1*f_z_w_carriage_4y + D_delta_z_1*t515
    )
    K_wq_out[..., 10, 25] = (
        D_delta_rx_2*f_rx_w_carriage_4y + D_delta_ry_2*f_ry_w_carriage_4y + D_delta_rz_2*f_rz_w_carriage_4y
        + D_delta_x_2*f_x_w_carriage_4y + D_delta_x_2*t513 + D_delta_y_2*f_y_w_carriage_4y + D_delta_y_2*t514
        + D_delta_z_2*f_z_w_carriage_4y + D_delta_z_2*t515
    )
    K_wq_out[..., 10, 26] = (
        D_delta_rx_3*f_rx_w_carriage_4y + D_delta_ry_3*f_ry_w_carriage_4y + D_delta_rz_3*f_rz_w_carriage_4y
        + D_delta_x_3*f_x_w_carriage_4y + D_delta_x_3*t513 + D_delta_y_3*f_y_w_carriage_4y + D_delta_y_3*t514
        + D_delta_z_3*f_z_w_carriage_4y + D_delta_z_3*t515
    )
    K_wq_out[..., 10, 27] = (
        D_delta_rx_4*f_rx_w_carriage_4y + D_delta_ry_4*f_ry_w_carriage_4y + D_delta_rz_4*f_rz_w_carriage_4y
        + D_delta_x_4*f_x_w_carriage_4y + D_delta_x_4*t513 + D_delta_y_4*f_y_w_carriage_4y + D_delta_y_4*t514
        + D_delta_z_4*f_z_w_carriage_4y + D_delta_z_4*t515
    )
    K_wq_out[..., 10, 28] = (
        D_delta_rx_5*f_rx_w_carriage_4y + D_delta_ry_5*f_ry_w_carriage_4y + D_delta_rz_5*f_rz_w_carriage_4y
        + D_delta_x_5*f_x_w_carriage_4y + D_delta_x_5*t513 + D_delta_y_5*f_y_w_carriage_4y + D_delta_y_5*t514
        + D_delta_z_5*f_z_w_carriage_4y + D_delta_z_5*t515
    )
    K_wq_out[..., 10, 29] = (
        D_delta_rx_6*f_rx_w_carriage_4y + D_delta_ry_6*f_ry_w_carriage_4y + D_delta_rz_6*f_rz_w_carriage_4y
        + D_delta_x_6*f_x_w_carriage_4y + D_delta_x_6*t513 + D_delta_y_6*f_y_w_carriage_4y + D_delta_y_6*t514
        + D_delta_z_6*f_z_w_carriage_4y + D_delta_z_6*t515
    )
    K_wq_out[..., 10, 33] = t518
    K_wq_out[..., 10, 36] = t513
    K_wq_out[..., 10, 37] = t514
    K_wq_out[..., 10, 38] = t515
    K_wq_out[..., 11, 0] = (
        D_delta_rx_18*t417 + D_delta_ry_18*t418 + D_delta_rz_18*t419 + D_delta_x_18*t420 + D_delta_y_18*t423
        + D_delta_z_18*t425 + D_p_rx_1*f_rx_w_carriage_4z + D_p_ry_1*f_ry_w_carriage_4z
        + D_p_rz_1*f_rz_w_carriage_4z + D_p_x_1*f_x_w_carriage_4z + D_p_x_1*t519 + D_p_y_1*f_y_w_carriage_4z
        + D_p_y_1*t520 + D_p_z_1*f_z_w_carriage_4z + D_p_z_1*t521
    )
    K_wq_out[..., 11, 1] = (
        D_delta_rx_18*t432 + D_delta_ry_18*t433 + D_delta_rz_18*t434 + D_delta_x_18*t429 + D_delta_y_18*t430
        + D_delta_z_18*t431 + D_p_rx_2*f_rx_w_carriage_4z + D_p_ry_2*f_ry_w_carriage_4z
        + D_p_rz_2*f_rz_w_carriage_4z + D_p_x_2*f_x_w_carriage_4z + D_p_x_2*t519 + D_p_y_2*f_y_w_carriage_4z
        + D_p_y_2*t520 + D_p_z_2*f_z_w_carriage_4z + D_p_z_2*t521
    )
    K_wq_out[..., 11, 2] = (
        D_delta_rx_18*t438 + D_delta_ry_18*t439 + D_delta_rz_18*t440 + D_delta_x_18*t435 + D_delta_y_18*t436
        + D_delta_z_18*t437 + D_p_rx_3*f_rx_w_carriage_4z + D_p_ry_3*f_ry_w_carriage_4z
        + D_p_rz_3*f_rz_w_carriage_4z + D_p_x_3*f_x_w_carriage_4z + D_p_x_3*t519 + D_p_y_3*f_y_w_carriage_4z
        + D_p_y_3*t520 + D_p_z_3*f_z_w_carriage_4z + D_p_z_3*t521
    )
    K_wq_out[..., 11, 3] = (
        D_delta_rx_18*t444 + D_delta_ry_18*t445 + D_delta_rz_18*t446 + D_delta_x_18*t441 + D_delta_y_18*t442
        + D_delta_z_18*t443 + D_p_rx_4*f_rx_w_carriage_4z + D_p_ry_4*f_ry_w_carriage_4z
        + D_p_rz_4*f_rz_w_carriage_4z + D_p_x_4*f_x_w_carriage_4z + D_p_x_4*t519 + D_p_y_4*f_y_w_carriage_4z
        + D_p_y_4*t520 + D_p_z_4*f_z_w_carriage_4z + D_p_z_4*t521 - t443 + t524
    )
    K_wq_out[..., 11, 4] = (
        D_delta_rx_18*t450 + D_delta_ry_18*t451 + D_delta_rz_18*t452 + D_delta_x_18*t447 + D_delta_y_18*t448
        + D_delta_z_18*t449 + D_p_rx_5*f_rx_w_carriage_4z + D_p_ry_5*f_ry_w_carriage_4z
        + D_p_rz_5*f_rz_w_carriage_4z + D_p_x_5*f_x_w_carriage_4z + D_p_x_5*t519 + D_p_y_5*f_y_w_carriage_4z
        + D_p_y_5*t520 + D_p_z_5*f_z_w_carriage_4z + D_p_z_5*t521
    )
    K_wq_out[..., 11, 5] = (
        D_delta_rx_18*t456 + D_delta_ry_18*t457 + D_delta_rz_18*t458 + D_delta_x_18*t453 + D_delta_y_18*t454
        + D_delta_z_18*t455 + D_p_rx_6*f_rx_w_carriage_4z + D_p_ry_6*f_ry_w_carriage_4z
        + D_p_rz_6*f_rz_w_carriage_4z + D_p_x_6*f_x_w_carriage_4z + D_p_x_6*t519 + D_p_y_6*f_y_w_carriage_4z
        + D_p_y_6*t520 + D_p_z_6*f_z_w_carriage_4z + D_p_z_6*t521
    )
    K_wq_out[..., 11, 9] = -R_p_4*t523
    K_wq_out[..., 11, 15] = -R_p_4*t522
    K_wq_out[..., 11, 24] = (
        D_delta_rx_1*f_rx_w_carriage_4z + D_delta_ry_1*f_ry_w_carriage_4z + D_delta_rz_1*f_rz_w_carriage_4z
        + D_delta_x_1*f_x_w_carriage_4z + D_delta_x_1*t519 + D_delta_y_1*f_y_w_carriage_4z + D_delta_y_1*t520
        + D_delta_z_1*f_z_w_carriage_4z + D_delta_z_1*t521
    )
    K_wq_out[..., 11, 25] = (
        D_delta_rx_2*f_rx_w_carriage_4z + D_delta_ry_2*f_ry_w_carriage_4z + D_delta_rz_2*f_rz_w_carriage_4z
        + D_delta_x_2*f_x_w_carriage_4z + D_delta_x_2*t519 + D_delta_y_2*f_y_w_carriage_4z + D_delta_y_2*t520
        + D_delta_z_2*f_z_w_carriage_4z + D_delta_z_2*t521
    )
    K_wq_out[..., 11, 26] = (
        D_delta_rx_3*f_rx_w_carriage_4z + D_delta_ry_3*f_ry_w_carriage_4z + D_delta_rz_3*f_rz_w_carriage_4z
        + D_delta_x_3*f_x_w_carriage_4z + D_delta_x_3*t519 + D_delta_y_3*f_y_w_carriage_4z + D_delta_y_3*t520
        + D_delta_z_3*f_z_w_carriage_4z + D_delta_z_3*t521
    )
    K_wq_out[..., 11, 27] = (
        D_delta_rx_4*f_rx_w_carriage_4z + D_delta_ry_4*f_ry_w_carriage_4z + D_delta_rz_4*f_rz_w_carriage_4z
        + D_delta_x_4*f_x_w_carriage_4z + D_delta_x_4*t519 + D_delta_y_4*f_y_w_carriage_4z + D_delta_y_4*t520
        + D_delta_z_4*f_z_w_carriage_4z + D_delta_z_4*t521
    )
    K_wq_out[..., 11, 28] = (
        D_delta_rx_5*f_rx_w_carriage_4z + D_delta_ry_5*f_ry_w_carriage_4z + D_delta_rz_5*f_rz_w_carriage_4z
        + D_delta_x_5*f_x_w_carriage_4z + D_delta_x_5*t519 + D_delta_y_5*f_y_w_carriage_4z + D_delta_y_5*t520
        + D_delta_z_5*f_z_w_carriage_4z + D_delta_z_5*t521
    )
    K_wq_out[..., 11, 29] = (
        D_delta_rx_6*f_rx_w_carriage_4z + D_delta_ry_6*f_ry_w_carriage_4z + D_delta_rz_6*f_rz_w_carriage_4z
        + D_delta_x_6*f_x_w_carriage_4z + D_delta_x_6*t519 + D_delta_y_6*f_y_w_carriage_4z + D_delta_y_6*t520
        + D_delta_z_6*f_z_w_carriage_4z + D_delta_z_6*t521
    )
    K_wq_out[..., 11, 33] = t524
    K_wq_out[..., 11, 36] = t519
    K_wq_out[..., 11, 37] = t520
    K_wq_out[..., 11, 38] = t521
    K_wq_out[..., 12, 0] = (
        D_delta_rx_19*t417 + D_delta_ry_19*t418 + D_delta_rz_19*t419 + D_delta_x_19*t420 + D_delta_y_19*t423
        + D_delta_z_19*t425 + D_p_rx_1*f_rx_w_carriage_5x + D_p_ry_1*f_ry_w_carriage_5x
        + D_p_rz_1*f_rz_w_carriage_5x + D_p_x_1*f_x_w_carriage_5x + D_p_x_1*t525 + D_p_y_1*f_y_w_carriage_5x
        + D_p_y_1*t526 + D_p_z_1*f_z_w_carriage_5x + D_p_z_1*t527
    )
    K_wq_out[..., 12, 1] = (
        D_delta_rx_19*t432 + D_delta_ry_19*t433 + D_delta_rz_19*t434 + D_delta_x_19*t429 + D_delta_y_19*t430
        + D_delta_z_19*t431 + D_p_rx_2*f_rx_w_carriage_5x + D_p_ry_2*f_ry_w_carriage_5x
        + D_p_rz_2*f_rz_w_carriage_5x + D_p_x_2*f_x_w_carriage_5x + D_p_x_2*t525 + D_p_y_2*f_y_w_carriage_5x
        + D_p_y_2*t526 + D_p_z_2*f_z_w_carriage_5x + D_p_z_2*t527
    )
    K_wq_out[..., 12, 2] = (
        D_delta_rx_19*t438 + D_delta_ry_19*t439 + D_delta_rz_19*t440 + D_delta_x_19*t435 + D_delta_y_19*t436
        + D_delta_z_19*t437 + D_p_rx_3*f_rx_w_carriage_5x + D_p_ry_3*f_ry_w_carriage_5x
        + D_p_rz_3*f_rz_w_carriage_5x + D_p_x_3*f_x_w_carriage_5x + D_p_x_3*t525 + D_p_y_3*f_y_w_carriage_5x
        + D_p_y_3*t526 + D_p_z_3*f_z_w_carriage_5x + D_p_z_3*t527
    )
    K_wq_out[..., 12, 3] = (
        D_delta_rx_19*t444 + D_delta_ry_19*t445 + D_delta_rz_19*t446 + D_delta_x_19*t441 + D_delta_y_19*t442
        + D_delta_z_19*t443 + D_p_rx_4*f_rx_w_carriage_5x + D_p_ry_4*f_ry_w_carriage_5x
        + D_p_rz_4*f_rz_w_carriage_5x + D_p_x_4*f_x_w_carriage_5x + D_p_x_4*t525 + D_p_y_4*f_y_w_carriage_5x
        + D_p_y_4*t526 + D_p_z_4*f_z_w_carriage_5x + D_p_z_4*t527
    )
    K_wq_out[..., 12, 4] = (
        D_delta_rx_19*t450 + D_delta_ry_19*t451 + D_delta_rz_19*t452 + D_delta_x_19*t447 + D_delta_y_19*t448
        + D_delta_z_19*t449 + D_p_rx_5*f_rx_w_carriage_5x + D_p_ry_5*f_ry_w_carriage_5x
        + D_p_rz_5*f_rz_w_carriage_5x + D_p_x_5*f_x_w_carriage_5x + D_p_x_5*t525 + D_p_y_5*f_y_w_carriage_5x
        + D_p_y_5*t526 + D_p_z_5*f_z_w_carriage_5x + D_p_z_5*t527 - t447 + t530
    )
    K_wq_out[..., 12, 5] = (
        D_delta_rx_19*t456 + D_delta_ry_19*t457 + D_delta_rz_19*t458 + D_delta_x_19*t453 + D_delta_y_19*t454
        + D_delta_z_19*t455 + D_p_rx_6*f_rx_w_carriage_5x + D_p_ry_6*f_ry_w_carriage_5x
        + D_p_rz_6*f_rz_w_carriage_5x + D_p_x_6*f_x_w_carriage_5x + D_p_x_6*t525 + D_p_y_6*f_y_w_carriage_5x
        + D_p_y_6*t526 + D_p_z_6*f_z_w_carriage_5x + D_p_z_6*t527
    )
    K_wq_out[..., 12, 10] = -R_p_5*t529
    K_wq_out[..., 12, 16] = -R_p_5*t528
    K_wq_out[..., 12, 24] = (
        D_delta_rx_1*f_rx_w_carriage_5x + D_delta_ry_1*f_ry_w_carriage_5x + D_delta_rz_1*f_rz_w_carriage_5x
        + D_delta_x_1*f_x_w_carriage_5x + D_delta_x_1*t525 + D_delta_y_1*f_y_w_carriage_5x + D_delta_y_1*t526
        + D_delta_z_1*f_z_w_carriage_5x + D_delta_z_1*t527
    )
    K_wq_out[..., 12, 25] = (
        D_delta_rx_2*f_rx_w_carriage_5x + D_delta_ry_2*f_ry_w_carriage_5x + D_delta_rz_2*f_rz_w_carriage_5x
        + D_delta_x_2*f_x_w_carriage_5x + D_delta_x_2*t525 + D_delta_y_2*f_y_w_carriage_5x + D_delta_y_2*t526
        + D_delta_z_2*f_z_w_carriage_5x + D_delta_z_2*t527
    )
    K_wq_out[..., 12, 26] = (
        D_delta_rx_3*f_rx_w_carriage_5x + D_delta_ry_3*f_ry_w_carriage_5x + D_delta_rz_3*f_rz_w_carriage_5x
        + D_delta_x_3*f_x_w_carriage_5x + D_delta_x_3*t525 + D_delta_y_3*f_y_w_carriage_5x + D_delta_y_3*t526
        + D_delta_z_3*f_z_w_carriage_5x + D_delta_z_3*t527
    )
    K_wq_out[..., 12, 27] = (
        D_delta_rx_4*f_rx_w_carriage_5x + D_delta_ry_4*f_ry_w_carriage_5x + D_delta_rz_4*f_rz_w_carriage_5x
        + D_delta_x_4*f_x_w_carriage_5x + D_delta_x_4*t525 + D_delta_y_4*f_y_w_carriage_5x + D_delta_y_4*t526
        + D_delta_z_4*f_z_w_carriage_5x + D_delta_z_4*t527
    )
    K_wq_out[..., 12, 28] = (
        D_delta_rx_5*f_rx_w_carriage_5x + D_delta_ry_5*f_ry_w_carriage_5x + D_delta_rz_5*f_rz_w_carriage_5x
        + D_delta_x_5*f_x_w_carriage_5x + D_delta_x_5*t525 + D_delta_y_5*f_y_w_carriage_5x + D_delta_y_5*t526
        + D_delta_z_5*f_z_w_carriage_5x + D_delta_z_5*t527
    )
    K_wq_out[..., 12, 29] = (
        D_delta_rx_6*f_rx_w_carriage_5x + D_delta_ry_6*f_ry_w_carriage_5x + D_delta_rz_6*f_rz_w_carriage_5x
        + D_delta_x_6*f_x_w_carriage_5x + D_delta_x_6*t525 + D_delta_y_6*f_y_w_carriage_5x + D_delta_y_6*t526
        + D_delta_z_6*f_z_w_carriage_5x + D_delta_z_6*t527
    )
    K_wq_out[..., 12, 34] = t530
    K_wq_out[..., 12, 36] = t525
    K_wq_out[..., 12, 37] = t526
    K_wq_out[..., 12, 38] = t527
    K_wq_out[..., 13, 0] = (
        D_delta_rx_20*t417 + D_delta_ry_20*t418 + D_delta_rz_20*t419 + D_delta_x_20*t420 + D_delta_y_20*t423
        + D_delta_z_20*t425 + D_p_rx_1*f_rx_w_carriage_5y + D_p_ry_1*f_ry_w_carriage_5y
        + D_p_rz_1*f_rz_w_carriage_5y + D_p_x_1*f_x_w_carriage_5y + D_p_x_1*t531 + D_p_y_1*f_y_w_carriage_5y
        + D_p_y_1*t532 + D_p_z_1*f_z_w_carriage_5y + D_p_z_1*t533
    )
    K_wq_out[..., 13, 1] = (
        D_delta_rx_20*t432 + D_delta_ry_20*t433 + D_delta_rz_20*t434 + D_delta_x_20*t429 + D_delta_y_20*t430
        + D_delta_z_20*t431 + D_p_rx_2*f_rx_w_carriage_5y + D_p_ry_2*f_ry_w_carriage_5y
        + D_p_rz_2*f_rz_w_carriage_5y + D_p_x_2*f_x_w_carriage_5y + D_p_x_2*t531 + D_p_y_2*f_y_w_carriage_5y
        + D_p_y_2*t532 + D_p_z_2*f_z_w_carriage_5y + D_p_z_2*t533
    )
    K_wq_out[..., 13, 2] = (
        D_delta_rx_20*t438 + D_delta_ry_20*t439 + D_delta_rz_20*t440 + D_delta_x_20*t435 + D_delta_y_20*t436
        + D_delta_z_20*t437 + D_p_rx_3*f_rx_w_carriage_5y + D_p_ry_3*f_ry_w_carriage_5y
        + D_p_rz_3*f_rz_w_carriage_5y + D_p_x_3*f_x_w_carriage_5y + D_p_x_3*t531 + D_p_y_3*f_y_w_carriage_5y
        + D_p_y_3*t532 + D_p_z_3*f_z_w_carriage_5y + D_p_z_3*t533
    )
    K_wq_out[..., 13, 3] = (
        D_delta_rx_20*t444 + D_delta_ry_20*t445 + D_delta_rz_20*t446 + D_delta_x_20*t441 + D_delta_y_20*t442
        + D_delta_z_20*t443 + D_p_rx_4*f_rx_w_carriage_5y + D_p_ry_4*f_ry_w_carriage_5y
        + D_p_rz_4*f_rz_w_carriage_5y + D_p_x_4*f_x_w_carriage_5y + D_p_x_4*t531 + D_p_y_4*f_y_w_carriage_5y
        + D_p_y_4*t532 + D_p_z_4*f_z_w_carriage_5y + D_p_z_4*t533
    )
    K_wq_out[..., 13, 4] = (
        D_delta_rx_20*t450 + D_delta_ry_20*t451 + D_delta_rz_20*t452 + D_delta_x_20*t447 + D_delta_y_20*t448
        + D_delta_z_20*t449 + D_p_rx_5*f_rx_w_carriage_5y + D_p_ry_5*f_ry_w_carriage_5y
        + D_p_rz_5*f_rz_w_carriage_5y + D_p_x_5*f_x_w_carriage_5y + D_p_x_5*t531 + D_p_y_5*f_y_w_carriage_5y
        + D_p_y_5*t532 + D_p_z_5*f_z_w_carriage_5y + D_p_z_5*t533 - t448 + t536
    )
    K_wq_out[..., 13, 5] = (
        D_delta_rx_20*t456 + D_delta_ry_20*t457 + D_delta_rz_20*t458 + D_delta_x_20*t453 + D_delta_y_20*t454
        + D_delta_z_20*t455 + D_p_rx_6*f_rx_w_carriage_5y + D_p_ry_6*f_ry_w_carriage_5y
        + D_p_rz_6*f_rz_w_carriage_5y + D_p_x_6*f_x_w_carriage_5y + D_p_x_6*t531 + D_p_y_6*f_y_w_carriage_5y
        + D_p_y_6*t532 + D_p_z_6*f_z_w_carriage_5y + D_p_z_6*t533
    )
    K_wq_out[..., 13, 10] = -R_p_5*t535
    K_wq_out[..., 13, 16] = -R_p_5*t534
    K_wq_out[..., 13, 24] = (
        D_delta_rx_1*f_rx_w_carriage_5y + D_delta_ry_1*f_ry_w_carriage_5y + D_delta_rz_1*f_rz_w_carriage_5y
        + D_delta_x_1*f_x_w_carriage_5y + D_delta_x_1*t531 + D_delta_y_1*f_y_w_carriage_5y + D_delta_y_1*t532
        + D_delta_z_1*f_z_w_carriage_5y + D_delta_z_1*t533
    )
    K_wq_out[..., 13, 25] = (
        D_delta_rx_2*f_rx_w_carriage_5y + D_delta_ry_2*f_ry_w_carriage_5y + D_delta_rz_2*f_rz_w_carriage_5y
        + D_delta_x_2*f_x_w_carriage_5y + D_delta_x_2*t531 + D_delta_y_2*f_y_w_carriage_5y + D_delta_y_2*t532
        + D_delta_z_2*f_z_w_carriage_5y + D_delta_z_2*t533
    )
    K_wq_out[..., 13, 26] = (
        D_delta_rx_3*f_rx_w_carriage_5y + D_delta_ry_3*f_ry_w_carriage_5y + D_delta_rz_3*f_rz_w_carriage_5y
        + D_delta_x_3*f_x_w_carriage_5y + D_delta_x_3*t531 + D_delta_y_3*f_y_w_carriage_5y + D_delta_y_3*t532
        + D_delta_z_3*f_z_w_carriage_5y + D_delta_z_3*t533
    )
    K_wq_out[..., 13, 27] = (
        D_delta_rx_4*f_rx_w_carriage_5y + D_delta_ry_4*f_ry_w_carriage_5y + D_delta_rz_4*f_rz_w_carriage_5y
        + D_delta_x_4*f_x_w_carriage_5y + D_delta_x_4*t531 + D_delta_y_4*f_y_w_carriage_5y + D_delta_y_4*t532
        + D_delta_z_4*f_z_w_carriage_5y + D_delta_z_4*t533
    )
    K_wq_out[..., 13, 28] = (
        D_delta_rx_5*f_rx_w_carriage_5y + D_delta_ry_5*f_ry_w_carriage_5y + D_delta_rz_5*f_rz_w_carriage_5y
        + D_delta_x_5*f_x_w_carriage_5y + D_delta_x_5*t531 + D_delta_y_5*f_y_w_carriage_5y + D_delta_y_5*t532
        + D_delta_z_5*f_z_w_carriage_5y + D_delta_z_5*t533
    )
    K_wq_out[..., 13, 29] = (
        D_delta_rx_6*f_rx_w_carriage_5y + D_delta_ry_6*f_ry_w_carriage_5y + D_delta_rz_6*f_rz_w_carriage_5y
        + D_delta_x_6*f_x_w_carriage_5y + D_delta_x_6*t531 + D_delta_y_6*f_y_w_carriage_5y + D_delta_y_6*t532
        + D_delta_z_6*f_z_w_carriage_5y + D_delta_z_6*t533
    )
    K_wq_out[..., 13, 34] = t536
    K_wq_out[..., 13, 36] = t531
    K_wq_out[..., 13, 37] = t532
    K_wq_out[..., 13, 38] = t533
    K_wq_out[..., 14, 0] = (
        D_delta_rx_21*t417 + D_delta_ry_21*t418 + D_delta_rz_21*t419 + D_delta_x_21*t420 + D_delta_y_21*t423
        + D_delta_z_21*t425 + D_p_rx_1*f_rx_w_carriage_5z + D_p_ry_1*f_ry_w_carriage_5z
        + D_p_rz_1*f_rz_w_carriage_5z + D_p_x_1*f_x_w_carriage_5z + D_p_x_1*t537 + D_p_y_1*f_y_w_carriage_5z
        + D_p_y_1*t538 + D_p_z_1*f_z_w_carriage_5z + D_p_z_1*t539
    )
    K_wq_out[..., 14, 1] = (
        D_delta_rx_21*t432 + D_delta_ry_21*t433 + D_delta_rz_21*t434 + D_delta_x_21*t429 + D_delta_y_21*t430
        + D_delta_z_21*t431 + D_p_rx_2*f_rx_w_carriage_5z + D_p_ry_2*f_ry_w_carriage_5z
        + D_p_rz_2*f_rz_w_carriage_5z + D_p_x_2*f_x_w_carriage_5z + D_p_x_2*t537 + D_p_y_2*f_y_w_carriage_5z
        + D_p_y_2*t538 + D_p_z_2*f_z_w_carriage_5z + D_p_z_2*t539
    )
    K_wq_out[..., 14, 2] = (
        D_delta_rx_21*t438 + D_delta_ry_21*t439 + D_delta_rz_21*t440 + D_delta_x_21*t435 + D_delta_y_21*t436
        + D_delta_z_21*t437 + D_p_rx_3*f_rx_w_carriage_5z + D_p_ry_3*f_ry_w_carriage_5z
        + D_p_rz_3*f_rz_w_carriage_5z + D_p_x_3*f_x_w_carriage_5z + D_p_x_3*t537 + D_p_y_3*f_y_w_carriage_5z
        + D_p_y_3*t538 + D_p_z_3*f_z_w_carriage_5z + D_p_z_3*t539
    )
    K_wq_out[..., 14, 3] = (
        D_delta_rx_21*t444 + D_delta_ry_21*t445 + D_delta_rz_21*t446 + D_delta_x_21*t441 + D_delta_y_21*t442
        + D_delta_z_21*t443 + D_p_rx_4*f_rx_w_carriage_5z + D_p_ry_4*f_ry_w_carriage_5z
        + D_p_rz_4*f_rz_w_carriage_5z + D_p_x_4*f_x_w_carriage_5z + D_p_x_4*t537 + D_p_y_4*f_y_w_carriage_5z
        + D_p_y_4*t538 + D_p_z_4*f_z_w_carriage_5z + D_p_z_4*t539
    )
    K_wq_out[..., 14, 4] = (
        D_delta_rx_21*t450 + D_delta_ry_21*t451 + D_delta_rz_21*t452 + D_delta_x_21*t447 + D_delta_y_21*t448
        + D_delta_z_21*t449 + D_p_rx_5*f_rx_w_carriage_5z + D_p_ry_5*f_ry_w_carriage_5z
        + D_p_rz_5*f_rz_w_carriage_5z + D_p_x_5*f_x_w_carriage_5z + D_p_x_5*t537 + D_p_y_5*f_y_w_carriage_5z
        + D_p_y_5*t538 + D_p_z_5*f_z_w_carriage_5z + D_p_z_5*t539 - t449 + t542
    )
    K_wq_out[..., 14, 5] = (
        D_delta_rx_21*t456 + D_delta_ry_21*t457 + D_delta_rz_21*t458 + D_delta_x_21*t453 + D_delta_y_21*t454
        + D_delta_z_21*t455 + D_p_rx_6*f_rx_w_carriage_5z + D_p_ry_6*f_ry_w_carriage_5z
        + D_p_rz_6*f_rz_w_carriage_5z + D_p_x_6*f_x_w_carriage_5z + D_p_x_6*t537 + D_p_y_6*f_y_w_carriage_5z
        + D_p_y_6*t538 + D_p_z_6*f_z_w_carriage_5z + D_p_z_6*t539
    )
    K_wq_out[..., 14, 10] = -R_p_5*t541
    K_wq_out[..., 14, 16] = -R_p_5*t540
    K_wq_out[..., 14, 24] = (
        D_delta_rx_1*f_rx_w_carriage_5z + D_delta_ry_1*f_ry_w_carriage_5z + D_delta_rz_1*f_rz_w_carriage_5z
        + D_delta_x_1*f_x_w_carriage_5z + D_delta_x_1*t537 + D_delta_y_1*f_y_w_carriage_5z + D_delta_y_1*t538
        + D_delta_z_1*f_z_w_carriage_5z + D_delta_z_1*t539
    )
    K_wq_out[..., 14, 25] = (
        D_delta_rx_2*f_rx_w_carriage_5z + D_delta_ry_2*f_ry_w_carriage_5z + D_delta_rz_2*f_rz_w_carriage_5z
        + D_delta_x_2*f_x_w_carriage_5z + D_delta_x_2*t537 + D_delta_y_2*f_y_w_carriage_5z + D_delta_y_2*t538
        + D_delta_z_2*f_z_w_carriage_5z + D_delta_z_2*t539
    )
    K_wq_out[..., 14, 26] = (
        D_delta_rx_3*f_rx_w_carriage_5z + D_delta_ry_3*f_ry_w_carriage_5z + D_delta_rz_3*f_rz_w_carriage_5z
        + D_delta_x_3*f_x_w_carriage_5z + D_delta_x_3*t537 + D_delta_y_3*f_y_w_carriage_5z + D_delta_y_3*t538
        + D_delta_z_3*f_z_w_carriage_5z + D_delta_z_3*t539
    )
    K_wq_out[..., 14, 27] = (
        D_delta_rx_4*f_rx_w_carriage_5z + D_delta_ry_4*f_ry_w_carriage_5z + D_delta_rz_4*f_rz_w_carriage_5z
        + D_delta_x_4*f_x_w_carriage_5z + D_delta_x_4*t537 + D_delta_y_4*f_y_w_carriage_5z + D_delta_y_4*t538
        + D_delta_z_4*f_z_w_carriage_5z + D_delta_z_4*t539
    )
    K_wq_out[..., 14, 28] = (
        D_delta_rx_5*f_rx_w_carriage_5z + D_delta_ry_5*f_ry_w_carriage_5z + D_delta_rz_5*f_rz_w_carriage_5z
        + D_delta_x_5*f_x_w_carriage_5z + D_delta_x_5*t537 + D_delta_y_5*f_y_w_carriage_5z + D_delta_y_5*t538
        + D_delta_z_5*f_z_w_carriage_5z + D_delta_z_5*t539
    )
    K_wq_out[..., 14, 29] = (
        D_delta_rx_6*f_rx_w_carriage_5z + D_delta_ry_6*f_ry_w_carriage_5z + D_delta_rz_6*f_rz_w_carriage_5z
        + D_delta_x_6*f_x_w_carriage_5z + D_delta_x_6*t537 + D_delta_y_6*f_y_w_carriage_5z + D_delta_y_6*t538
        + D_delta_z_6*f_z_w_carriage_5z + D_delta_z_6*t539
    )
    K_wq_out[..., 14, 34] = t542
    K_wq_out[..., 14, 36] = t537
    K_wq_out[..., 14, 37] = t538
    K_wq_out[..., 14, 38] = t539
    K_wq_out[..., 15, 0] = (
        D_delta_rx_22*t417 + D_delta_ry_22*t418 + D_delta_rz_22*t419 + D_delta_x_22*t420 + D_delta_y_22*t423
        + D_delta_z_22*t425 + D_p_rx_1*f_rx_w_carriage_6x + D_p_ry_1*f_ry_w_carriage_6x
        + D_p_rz_1*f_rz_w_carriage_6x + D_p_x_1*f_x_w_carriage_6x + D_p_x_1*t543 + D_p_y_1*f_y_w_carriage_6x
        + D_p_y_1*t544 + D_p_z_1*f_z_w_carriage_6x + D_p_z_1*t545
    )
    K_wq_out[..., 15, 1] = (
        D_delta_rx_22*t432 + D_delta_ry_22*t433 + D_delta_rz_22*t434 + D_delta_x_22*t429 + D_delta_y_22*t430
        + D_delta_z_22*t431 + D_p_rx_2*f_rx_w_carriage_6x + D_p_ry_2*f_ry_w_carriage_6x
        + D_p_rz_2*f_rz_w_carriage_6x + D_p_x_2*f_x_w_carriage_6x + D_p_x_2*t543 + D_p_y_2*f_y_w_carriage_6x
        + D_p_y_2*t544 + D_p_z_2*f_z_w_carriage_6x + D_p_z_2*t545
    )
    K_wq_out[..., 15, 2] = (
        D_delta_rx_22*t438 + D_delta_ry_22*t439 + D_delta_rz_22*t440 + D_delta_x_22*t435 + D_delta_y_22*t436
        + D_delta_z_22*t437 + D_p_rx_3*f_rx_w_carriage_6x + D_p_ry_3*f_ry_w_carriage_6x
        + D_p_rz_3*f_rz_w_carriage_6x + D_p_x_3*f_x_w_carriage_6x + D_p_x_3*t543 + D_p_y_3*f_y_w_carriage_6x
        + D_p_y_3*t544 + D_p_z_3*f_z_w_carriage_6x + D_p_z_3*t545
    )
    K_wq_out[..., 15, 3] = (
        D_delta_rx_22*t444 + D_delta_ry_22*t445 + D_delta_rz_22*t446 + D_delta_x_22*t441 + D_delta_y_22*t442
        + D_delta_z_22*t443 + D_p_rx_4*f_rx_w_carriage_6x + D_p_ry_4*f_ry_w_carriage_6x
        + D_p_rz_4*f_rz_w_carriage_6x + D_p_x_4*f_x_w_carriage_6x + D_p_x_4*t543 + D_p_y_4*f_y_w_carriage_6x
        + D_p_y_4*t544 + D_p_z_4*f_z_w_carriage_6x + D_p_z_4*t545
    )
    K_wq_out[..., 15, 4] = (
        D_delta_rx_22*t450 + D_delta_ry_22*t451 + D_delta_rz_22*t452 + D_delta_x_22*t447 + D_delta_y_22*t448
        + D_delta_z_22*t449 + D_p_rx_5*f_rx_w_carriage_6x + D_p_ry_5*f_ry_w_carriage_6x
        + D_p_rz_5*f_rz_w_carriage_6x + D_p_x_5*f_x_w_carriage_6x + D_p_x_5*t543 + D_p_y_5*f_y_w_carriage_6x
        + D_p_y_5*t544 + D_p_z_5*f_z_w_carriage_6x + D_p_z_5*t545
    )
    K_wq_out[..., 15, 5] = (
        D_delta_rx_22*t456 + D_delta_ry_22*t457 + D_delta_rz_22*t458 + D_delta_x_22*t453 + D_delta_y_22*t454
        + D_delta_z_22*t455 + D_p_rx_6*f_rx_w_carriage_6x + D_p_ry_6*f_ry_w_carriage_6x
        + D_p_rz_6*f_rz_w_carriage_6x + D_p_x_6*f_x_w_carriage_6x + D_p_x_6*t543 + D_p_y_6*f_y_w_carriage_6x
        + D_p_y_6*t544 + D_p_z_6*f_z_w_carriage_6x + D_p_z_6*t545 - t453 + t548
    )
    K_wq_out[..., 15, 11] = -R_p_6*t547
    K_wq_out[..., 15, 17] = -R_p_6*t546
    K_wq_out[..., 15, 24] = (
        D_delta_rx_1*f_rx_w_carriage_6x + D_delta_ry_1*f_ry_w_carriage_6x + D_delta_rz_1*f_rz_w_carriage_6x
        + D_delta_x_1*f_x_w_carriage_6x + D_delta_x_1*t543 + D_delta_y_1*f_y_w_carriage_6x + D_delta_y_1*t544
        + D_delta_z_1*f_z_w_carriage_6x + D_delta_z_1*t545
    )
    K_wq_out[..., 15, 25] = (
        D_delta_rx_2*f_rx_w_carriage_6x + D_delta_ry_2*f_ry_w_carriage_6x + D_delta_rz_2*f_rz_w_carriage_6x
        + D_delta_x_2*f_x_w_carriage_6x + D_delta_x_2*t543 + D_delta_y_2*f_y_w_carriage_6x + D_delta_y_2*t544
        + D_delta_z_2*f_z_w_carriage_6x + D_delta_z_2*t545
    )
    K_wq_out[..., 15, 26] = (
        D_delta_rx_3*f_rx_w_carriage_6x + D_delta_ry_3*f_ry_w_carriage_6x + D_delta_rz_3*f_rz_w_carriage_6x
        + D_delta_x_3*f_x_w_carriage_6x + D_delta_x_3*t543 + D_delta_y_3*f_y_w_carriage_6x + D_delta_y_3*t544
        + D_delta_z_3*f_z_w_carriage_6x + D_delta_z_3*t545
    )
    K_wq_out[..., 15, 27] = (
        D_delta_rx_4*f_rx_w_carriage_6x + D_delta_ry_4*f_ry_w_carriage_6x + D_delta_rz_4*f_rz_w_carriage_6x
        + D_delta_x_4*f_x_w_carriage_6x + D_delta_x_4*t543 + D_delta_y_4*f_y_w_carriage_6x + D_delta_y_4*t544
        + D_delta_z_4*f_z_w_carriage_6x + D_delta_z_4*t545
    )
    K_wq_out[..., 15, 28] = (
        D_delta_rx_5*f_rx_w_carriage_6x + D_delta_ry_5*f_ry_w_carriage_6x + D_delta_rz_5*f_rz_w_carriage_6x
        + D_delta_x_5*f_x_w_carriage_6x + D_delta_x_5*t543 + D_delta_y_5*f_y_w_carriage_6x + D_delta_y_5*t544
        + D_delta_z_5*f_z_w_carriage_6x + D_delta_z_5*t545
    )
    K_wq_out[..., 15, 29] = (
        D_delta_rx_6*f_rx_w_carriage_6x + D_delta_ry_6*f_ry_w_carriage_6x + D_delta_rz_6*f_rz_w_carriage_6x
        + D_delta_x_6*f_x_w_carriage_6x + D_delta_x_6*t543 + D_delta_y_6*f_y_w_carriage_6x + D_delta_y_6*t544
        + D_delta_z_6*f_z_w_carriage_6x + D_delta_z_6*t545
    )
    K_wq_out[..., 15, 35] = t548
    K_wq_out[..., 15, 36] = t543
    K_wq_out[..., 15, 37] = t544
    K_wq_out[..., 15, 38] = t545
    K_wq_out[..., 16, 0] = (
        D_delta_rx_23*t417 + D_delta_ry_23*t418 + D_delta_rz_23*t419 + D_delta_x_23*t420 + D_delta_y_23*t423
        + D_delta_z_23*t425 + D_p_rx_1*f_rx_w_carriage_6y + D_p_ry_1*f_ry_w_carriage_6y
        + D_p_rz_1*f_rz_w_carriage_6y + D_p_x_1*f_x_w_carriage_6y + D_p_x_1*t549 + D_p_y_1*f_y_w_carriage_6y
        + D_p_y_1*t550 + D_p_z_1*f_z_w_carriage_6y + D_p_z_1*t551
    )
    K_wq_out[..., 16, 1] = (
        D_delta_rx_23*t432 + D_delta_ry_23*t433 + D_delta_rz_23*t434 + D_delta_x_23*t429 + D_delta_y_23*t430
        + D_delta_z_23*t431 + D_p_rx_2*f_rx_w_carriage_6y + D_p_ry_2*f_ry_w_carriage_6y
        + D_p_rz_2*f_rz_w_carriage_6y + D_p_x_2*f_x_w_carriage_6y + D_p_x_2*t549 + D_p_y_2*f_y_w_carriage_6y
        + D_p_y_2*t550 + D_p_z_2*f_z_w_carriage_6y + D_p_z_2*t551
    )
    K_wq_out[..., 16, 2] = (
        D_delta_rx_23*t438 + D_delta_ry_23*t439 + D_delta_rz_23*t440 + D_delta_x_23*t435 + D_delta_y_23*t436
        + D_delta_z_23*t437 + D_p_rx_3*f_rx_w_carriage_6y + D_p_ry_3*f_ry_w_carriage_6y
        + D_p_rz_3*f_rz_w_carriage_6y + D_p_x_3*f_x_w_carriage_6y + D_p_x_3*t549 + D_p_y_3*f_y_w_carriage_6y
        + D_p_y_3*t550 + D_p_z_3*f_z_w_carriage_6y + D_p_z_3*t551
    )
    K_wq_out[..., 16, 3] = (
        D_delta_rx_23*t444 + D_delta_ry_23*t445 + D_delta_rz_23*t446 + D_delta_x_23*t441 + D_delta_y_23*t442
        + D_delta_z_23*t443 + D_p_rx_4*f_rx_w_carriage_6y + D_p_ry_4*f_ry_w_carriage_6y
        + D_p_rz_4*f_rz_w_carriage_6y + D_p_x_4*f_x_w_carriage_6y + D_p_x_4*t549 + D_p_y_4*f_y_w_carriage_6y
        + D_p_y_4*t550 + D_p_z_4*f_z_w_carriage_6y + D_p_z_4*t551
    )
    K_wq_out[..., 16, 4] = (
        D_delta_rx_23*t450 + D_delta_ry_23*t451 + D_delta_rz_23*t452 + D_delta_x_23*t447 + D_delta_y_23*t448
        + D_delta_z_23*t449 + D_p_rx_5*f_rx_w_carriage_6y + D_p_ry_5*f_ry_w_carriage_6y
        + D_p_rz_5*f_rz_w_carriage_6y + D_p_x_5*f_x_w_carriage_6y + D_p_x_5*t549 + D_p_y_5*f_y_w_carriage_6y
        + D_p_y_5*t550 + D_p_z_5*f_z_w_carriage_6y + D_p_z_5*t551
    )
    K_wq_out[..., 16, 5] = (
        D_delta_rx_23*t456 + D_delta_ry_23*t457 + D_delta_rz_23*t458 + D_delta_x_23*t453 + D_delta_y_23*t454
        + D_delta_z_23*t455 + D_p_rx_6*f_rx_w_carriage_6y + D_p_ry_6*f_ry_w_carriage_6y
        + D_p_rz_6*f_rz_w_carriage_6y + D_p_x_6*f_x_w_carriage_6y + D_p_x_6*t549 + D_p_y_6*f_y_w_carriage_6y
        + D_p_y_6*t550 + D_p_z_6*f_z_w_carriage_6y + D_p_z_6*t551 - t454 + t554
    )
    K_wq_out[..., 16, 11] = -R_p_6*t553
    K_wq_out[..., 16, 17] = -R_p_6*t552
    K_wq_out[..., 16, 24] = (
        D_delta_rx_1*f_rx_w_carriage_6y + D_delta_ry_1*f_ry_w_carriage_6y + D_delta_rz_1*f_rz_w_carriage_6y
        + D_delta_x_1*f_x_w_carriage_6y + D_delta_x_1*t549 + D_delta_y_1*f_y_w_carriage_6y + D_delta_y_1*t550
        + D_delta_z_1*f_z_w_carriage_6y + D_delta_z_1*t551
    )
    K_wq_out[..., 16, 25] = (
        D_delta_rx_2*f_rx_w_carriage_6y + D_delta_ry_2*f_ry_w_carriage_6y + D_delta_rz_2*f_rz_w_carriage_6y
        + D_delta_x_2*f_x_w_carriage_6y + D_delta_x_2*t549 + D_delta_y_2*f_y_w_carriage_6y + D_delta_y_2*t550
        + D_delta_z_2*f_z_w_carriage_6y + D_delta_z_2*t551
    )
    K_wq_out[..., 16, 26] = (
        D_delta_rx_3*f_rx_w_carriage_6y + D_delta_ry_3*f_ry_w_carriage_6y + D_delta_rz_3*f_rz_w_carriage_6y
        + D_delta_x_3*f_x_w_carriage_6y + D_delta_x_3*t549 + D_delta_y_3*f_y_w_carriage_6y + D_delta_y_3*t550
        + D_delta_z_3*f_z_w_carriage_6y + D_delta_z_3*t551
    )
    K_wq_out[..., 16, 27] = (
        D_delta_rx_4*f_rx_w_carriage_6y + D_delta_ry_4*f_ry_w_carriage_6y + D_delta_rz_4*f_rz_w_carriage_6y
        + D_delta_x_4*f_x_w_carriage_6y + D_delta_x_4*t549 + D_delta_y_4*f_y_w_carriage_6y + D_delta_y_4*t550
        + D_delta_z_4*f_z_w_carriage_6y + D_delta_z_4*t551
    )
    K_wq_out[..., 16, 28] = (
        D_delta_rx_5*f_rx_w_carriage_6y + D_delta_ry_5*f_ry_w_carriage_6y + D_delta_rz_5*f_rz_w_carriage_6y
        + D_delta_x_5*f_x_w_carriage_6y + D_delta_x_5*t549 + D_delta_y_5*f_y_w_carriage_6y + D_delta_y_5*t550
        + D_delta_z_5*f_z_w_carriage_6y + D_delta_z_5*t551
    )
    K_wq_out[..., 16, 29] = (
        D_delta_rx_6*f_rx_w_carriage_6y + D_delta_ry_6*f_ry_w_carriage_6y + D_delta_rz_6*f_rz_w_carriage_6y
        + D_delta_x_6*f_x_w_carriage_6y + D_delta_x_6*t549 + D_delta_y_6*f_y_w_carriage_6y + D_delta_y_6*t550
        + D_delta_z_6*f_z_w_carriage_6y + D_delta_z_6*t551
    )
    K_wq_out[..., 16, 35] = t554
    K_wq_out[..., 16, 36] = t549
    K_wq_out[..., 16, 37] = t550
    K_wq_out[..., 16, 38] = t551
    K_wq_out[..., 17, 0] = (
        D_delta_rx_24*t417 + D_delta_ry_24*t418 + D_delta_rz_24*t419 + D_delta_x_24*t420 + D_delta_y_24*t423
        + D_delta_z_24*t425 + D_p_rx_1*f_rx_w_carriage_6z + D_p_ry_1*f_ry_w_carriage_6z
        + D_p_rz_1*f_rz_w_carriage_6z + D_p_x_1*f_x_w_carriage_6z + D_p_x_1*t555 + D_p_y_1*f_y_w_carriage_6z
        + D_p_y_1*t556 + D_p_z_1*f_z_w_carriage_6z + D_p_z_1*t557
    )
    K_wq_out[..., 17, 1] = (
        D_delta_rx_24*t432 + D_delta_ry_24*t433 + D_delta_rz_24*t434 + D_delta_x_24*t429 + D_delta_y_24*t430
        + D_delta_z_24*t431 + D_p_rx_2*f_rx_w_carriage_6z + D_p_ry_2*f_ry_w_carriage_6z
        + D_p_rz_2*f_rz_w_carriage_6z + D_p_x_2*f_x_w_carriage_6z + D_p_x_2*t555 + D_p_y_2*f_y_w_carriage_6z
        + D_p_y_2*t556 + D_p_z_2*f_z_w_carriage_6z + D_p_z_2*t557
    )
    K_wq_out[..., 17, 2] = (
        D_delta_rx_24*t438 + D_delta_ry_24*t439 + D_delta_rz_24*t440 + D_delta_x_24*t435 + D_delta_y_24*t436
        + D_delta_z_24*t437 + D_p_rx_3*f_rx_w_carriage_6z + D_p_ry_3*f_ry_w_carriage_6z
        + D_p_rz_3*f_rz_w_carriage_6z + D_p_x_3*f_x_w_carriage_6z + D_p_x_3*t555 + D_p_y_3*f_y_w_carriage_6z
        + D_p_y_3*t556 + D_p_z_3*f_z_w_carriage_6z + D_p_z_3*t557
    )
    K_wq_out[..., 17, 3] = (
        D_delta_rx_24*t444 + D_delta_ry_24*t445 + D_delta_rz_24*t446 + D_delta_x_24*t441 + D_delta_y_24*t442
        + D_delta_z_24*t443 + D_p_rx_4*f_rx_w_carriage_6z + D_p_ry_4*f_ry_w_carriage_6z
        + D_p_rz_4*f_rz_w_carriage_6z + D_p_x_4*f_x_w_carriage_6z + D_p_x_4*t555 + D_p_y_4*f_y_w_carriage_6z
        + D_p_y_4*t556 + D_p_z_4*f_z_w_carriage_6z + D_p_z_4*t557
    )
    K_wq_out[..., 17, 4] = (
        D_delta_rx_24*t450 + D_delta_ry_24*t451 + D_delta_rz_24*t452 + D_delta_x_24*t447 + D_delta_y_24*t448
        + D_delta_z_24*t449 + D_p_rx_5*f_rx_w_carriage_6z + D_p_ry_5*f_ry_w_carriage_6z
        + D_p_rz_5*f_rz_w_carriage_6z + D_p_x_5*f_x_w_carriage_6z + D_p_x_5*t555 + D_p_y_5*f_y_w_carriage_6z
        + D_p_y_5*t556 + D_p_z_5*f_z_w_carriage_6z + D_p_z_5*t557
    )
    K_wq_out[..., 17, 5] = (
        D_delta_rx_24*t456 + D_delta_ry_24*t457 + D_delta_rz_24*t458 + D_delta_x_24*t453 + D_delta_y_24*t454
        + D_delta_z_24*t455 + D_p_rx_6*f_rx_w_carriage_6z + D_p_ry_6*f_ry_w_carriage_6z
        + D_p_rz_6*f_rz_w_carriage_6z + D_p_x_6*f_x_w_carriage_6z + D_p_x_6*t555 + D_p_y_6*f_y_w_carriage_6z
        + D_p_y_6*t556 + D_p_z_6*f_z_w_carriage_6z + D_p_z_6*t557 - t455 + t560
    )
    K_wq_out[..., 17, 11] = -R_p_6*t559
    K_wq_out[..., 17, 17] = -R_p_6*t558
    K_wq_out[..., 17, 24] = (
        D_delta_rx_1*f_rx_w_carriage_6z + D_delta_ry_1*f_ry_w_carriage_6z + D_delta_rz_1*f_rz_w_carriage_6z
        + D_delta_x_1*f_x_w_carriage_6z + D_delta_x_1*t555 + D_delta_y_1*f_y_w_carriage_6z + D_delta_y_1*t556
        + D_delta_z_1*f_z_w_carriage_6z + D_delta_z_1*t557
    )
    K_wq_out[..., 17, 25] = (
        D_delta_rx_2*f_rx_w_carriage_6z + D_delta_ry_2*f_ry_w_carriage_6z + D_delta_rz_2*f_rz_w_carriage_6z
        + D_delta_x_2*f_x_w_carriage_6z + D_delta_x_2*t555 + D_delta_y_2*f_y_w_carriage_6z + D_delta_y_2*t556
        + D_delta_z_2*f_z_w_carriage_6z + D_delta_z_2*t557
    )
    K_wq_out[..., 17, 26] = (
        D_delta_rx_3*f_rx_w_carriage_6z + D_delta_ry_3*f_ry_w_carriage_6z + D_delta_rz_3*f_rz_w_carriage_6z
        + D_delta_x_3*f_x_w_carriage_6z + D_delta_x_3*t555 + D_delta_y_3*f_y_w_carriage_6z + D_delta_y_3*t556
        + D_delta_z_3*f_z_w_carriage_6z + D_delta_z_3*t557
    )
    K_wq_out[..., 17, 27] = (
        D_delta_rx_4*f_rx_w_carriage_6z + D_delta_ry_4*f_ry_w_carriage_6z + D_delta_rz_4*f_rz_w_carriage_6z
        + D_delta_x_4*f_x_w_carriage_6z + D_delta_x_4*t555 + D_delta_y_4*f_y_w_carriage_6z + D_delta_y_4*t556
        + D_delta_z_4*f_z_w_carriage_6z + D_delta_z_4*t557
    )
    K_wq_out[..., 17, 28] = (
        D_delta_rx_5*f_rx_w_carriage_6z + D_delta_ry_5*f_ry_w_carriage_6z + D_delta_rz_5*f_rz_w_carriage_6z
        + D_delta_x_5*f_x_w_carriage_6z + D_delta_x_5*t555 + D_delta_y_5*f_y_w_carriage_6z + D_delta_y_5*t556
        + D_delta_z_5*f_z_w_carriage_6z + D_delta_z_5*t557
    )
    K_wq_out[..., 17, 29] = (
        D_delta_rx_6*f_rx_w_carriage_6z + D_delta_ry_6*f_ry_w_carriage_6z + D_delta_rz_6*f_rz_w_carriage_6z
        + D_delta_x_6*f_x_w_carriage_6z + D_delta_x_6*t555 + D_delta_y_6*f_y_w_carriage_6z + D_delta_y_6*t556
        + D_delta_z_6*f_z_w_carriage_6z + D_delta_z_6*t557
    )
    K_wq_out[..., 17, 35] = t560
    K_wq_out[..., 17, 36] = t555
    K_wq_out[..., 17, 37] = t556
    K_wq_out[..., 17, 38] = t557
    K_wq_out[..., 18, 0] = -k_1_3
    K_wq_out[..., 18, 6] = R_p_1*k_1_3 - t561
    K_wq_out[..., 18, 12] = t561
    K_wq_out[..., 18, 30] = -k_1_3
    K_wq_out[..., 19, 0] = -k_1_2
    K_wq_out[..., 19, 6] = t561
    K_wq_out[..., 19, 12] = R_p_1*k_1_2 - t561
    K_wq_out[..., 19, 30] = -k_1_2
    K_wq_out[..., 20, 1] = -k_2_3
    K_wq_out[..., 20, 7] = R_p_2*k_2_3 - t562
    K_wq_out[..., 20, 13] = t562
    K_wq_out[..., 20, 31] = -k_2_3
    K_wq_out[..., 21, 1] = -k_2_2
    K_wq_out[..., 21, 7] = t562
    K_wq_out[..., 21, 13] = R_p_2*k_2_2 - t562
    K_wq_out[..., 21, 31] = -k_2_2
    K_wq_out[..., 22, 2] = -k_3_3
    K_wq_out[..., 22, 8] = R_p_3*k_3_3 - t563
    K_wq_out[..., 22, 14] = t563
    K_wq_out[..., 22, 32] = -k_3_3
    K_wq_out[..., 23, 2] = -k_3_2
    K_wq_out[..., 23, 8] = t563
    K_wq_out[..., 23, 14] = R_p_3*k_3_2 - t563
    K_wq_out[..., 23, 32] = -k_3_2
    K_wq_out[..., 24, 3] = -k_4_3
    K_wq_out[..., 24, 9] = R_p_4*k_4_3 - t564
    K_wq_out[..., 24, 15] = t564
    K_wq_out[..., 24, 33] = -k_4_3
    K_wq_out[..., 25, 3] = -k_4_2
    K_wq_out[..., 25, 9] = t564
    K_wq_out[..., 25, 15] = R_p_4*k_4_2 - t564
    K_wq_out[..., 25, 33] = -k_4_2
    K_wq_out[..., 26, 4] = -k_5_3
    K_wq_out[..., 26, 10] = R_p_5*k_5_3 - t565
    K_wq_out[..., 26, 16] = t565
    K_wq_out[..., 26, 34] = -k_5_3
    K_wq_out[..., 27, 4] = -k_5_2
    K_wq_out[..., 27, 10] = t565
    K_wq_out[..., 27, 16] = R_p_5*k_5_2 - t565
    K_wq_out[..., 27, 34] = -k_5_2
    K_wq_out[..., 28, 5] = -k_6_3
    K_wq_out[..., 28, 11] = R_p_6*k_6_3 - t566
    K_wq_out[..., 28, 17] = t566
    K_wq_out[..., 28, 35] = -k_6_3
    K_wq_out[..., 29, 5] = -k_6_2
    K_wq_out[..., 29, 11] = t566
    K_wq_out[..., 29, 17] = R_p_6*k_6_2 - t566
    K_wq_out[..., 29, 35] = -k_6_2
    K_ww_out = np.empty((*batch, 30), dtype)
    K_ww_out[..., 0] = (
        D_delta_rx_7*f_rx_w_carriage_1x + D_delta_ry_7*f_ry_w_carriage_1x + D_delta_ry_7*t128
        + D_delta_rz_7*f_rz_w_carriage_1x - D_delta_rz_7*t134 + D_delta_x_7**2*k_C
        + D_delta_x_7*f_x_w_carriage_1x + D_delta_x_7*mu_1 + D_delta_y_7**2*k_C
        + D_delta_y_7*f_y_w_carriage_1x + D_delta_z_7**2*k_C + D_delta_z_7*f_z_w_carriage_1x + k_1_2*t399
        + k_1_3*t399 - mu_1
    )
    K_ww_out[..., 1] = (
        D_delta_rx_8*f_rx_w_carriage_1y - D_delta_rx_8*t128 + D_delta_ry_8*f_ry_w_carriage_1y
        + D_delta_rz_8*f_rz_w_carriage_1y + D_delta_rz_8*t140 + D_delta_x_8**2*k_C
        + D_delta_x_8*f_x_w_carriage_1y + D_delta_y_8**2*k_C + D_delta_y_8*f_y_w_carriage_1y
        + D_delta_y_8*mu_1 + D_delta_z_8**2*k_C + D_delta_z_8*f_z_w_carriage_1y + k_1_2*t400 + k_1_3*t400
        - mu_1
    )
    K_ww_out[..., 2] = (
        D_delta_rx_9*f_rx_w_carriage_1z + D_delta_rx_9*t134 + D_delta_ry_9*f_ry_w_carriage_1z
        - D_delta_ry_9*t140 + D_delta_rz_9*f_rz_w_carriage_1z + D_delta_x_9**2*k_C
        + D_delta_x_9*f_x_w_carriage_1z + D_delta_y_9**2*k_C + D_delta_y_9*f_y_w_carriage_1z
        + D_delta_z_9**2*k_C + D_delta_z_9*f_z_w_carriage_1z + D_delta_z_9*mu_1 + k_1_2*t401 + k_1_3*t401
        - mu_1
    )
    K_ww_out[..., 3] = (
        D_delta_rx_10*f_rx_w_carriage_2x + D_delta_ry_10*f_ry_w_carriage_2x + D_delta_ry_10*t129
        + D_delta_rz_10*f_rz_w_carriage_2x - D_delta_rz_10*t135 + D_delta_x_10**2*k_C
        + D_delta_x_10*f_x_w_carriage_2x + D_delta_x_10*mu_2 + D_delta_y_10**2*k_C
        + D_delta_y_10*f_y_w_carriage_2x + D_delta_z_10**2*k_C + D_delta_z_10*f_z_w_carriage_2x + k_2_2*t402
        + k_2_3*t402 - mu_2
    )
    K_ww_out[..., 4] = (
        D_delta_rx_11*f_rx_w_carriage_2y - D_delta_rx_11*t129 + D_delta_ry_11*f_ry_w_carriage_2y
        + D_delta_rz_11*f_rz_w_carriage_2y + D_delta_rz_11*t141 + D_delta_x_11**2*k_C
        + D_delta_x_11*f_x_w_carriage_2y + D_delta_y_11**2*k_C + D_delta_y_11*f_y_w_carriage_2y
        + D_delta_y_11*mu_2 + D_delta_z_11**2*k_C + D_delta_z_11*f_z_w_carriage_2y + k_2_2*t403 + k_2_3*t403
        - mu_2
    )
    K_ww_out[..., 5] = (
        D_delta_rx_12*f_rx_w_carriage_2z + D_delta_rx_12*t135 + D_delta_ry_12*f_ry_w_carriage_2z
        - D_delta_ry_12*t141 + D_delta_rz_12*f_rz_w_carriage_2z + D_delta_x_12**2*k_C
        + D_delta_x_12*f_x_w_carriage_2z + D_delta_y_12**2*k_C + D_delta_y_12*f_y_w_carriage_2z
        + D_delta_z_12**2*k_C + D_delta_z_12*f_z_w_carriage_2z + D_delta_z_12*mu_2 + k_2_2*t404 + k_2_3*t404
        - mu_2
    )
    K_ww_out[..., 6] = (
        D_delta_rx_13*f_rx_w_carriage_3x + D_delta_ry_13*f_ry_w_carriage_3x + D_delta_ry_13*t130
        + D_delta_rz_13*f_rz_w_carriage_3x - D_delta_rz_13*t136 + D_delta_x_13**2*k_C
        + D_delta_x_13*f_x_w_carriage_3x + D_delta_x_13*mu_3 + D_delta_y_13**2*k_C
        + D_delta_y_13*f_y_w_carriage_3x + D_delta_z_13**2*k_C + D_delta_z_13*f_z_w_carriage_3x + k_3_2*t405
        + k_3_3*t405 - mu_3
    )
    K_ww_out[..., 7] = (
        D_delta_rx_14*f_rx_w_carriage_3y - D_delta_rx_14*t130 + D_delta_ry_14*f_ry_w_carriage_3y
        + D_delta_rz_14*f_rz_w_carriage_3y + D_delta_rz_14*t142 + D_delta_x_14**2*k_C
        + D_delta_x_14*f_x_w_carriage_3y + D_delta_y_14**2*k_C + D_delta_y_14*f_y_w_carriage_3y
        + D_delta_y_14*mu_3 + D_delta_z_14**2*k_C + D_delta_z_14*f_z_w_carriage_3y + k_3_2*t406 + k_3_3*t406
        - mu_3
    )
    K_ww_out[..., 8] = (
        D_delta_rx_15*f_rx_w_carriage_3z + D_delta_rx_15*t136 + D_delta_ry_15*f_ry_w_carriage_3z
        - D_delta_ry_15*t142 + D_delta_rz_15*f_rz_w_carriage_3z + D_delta_x_15**2*k_C
        + D_delta_x_15*f_x_w_carriage_3z + D_delta_y_15**2*k_C + D_delta_y_15*f_y_w_carriage_3z
        + D_delta_z_15**2*k_C + D_delta_z_15*f_z_w_carriage_3z + D_delta_z_15*mu_3 + k_3_2*t407 + k_3_3*t407
        - mu_3
    )
    K_ww_out[..., 9] = (
        D_delta_rx_16*f_rx_w_carriage_4x + D_delta_ry_16*f_ry_w_carriage_4x + D_delta_ry_16*t131
        + D_delta_rz_16*f_rz_w_carriage_4x - D_delta_rz_16*t137 + D_delta_x_16**2*k_C
        + D_delta_x_16*f_x_w_carriage_4x + D_delta_x_16*mu_4 + D_delta_y_16**2*k_C
        + D_delta_y_16*f_y_w_carriage_4x + D_delta_z_16**2*k_C + D_delta_z_16*f_z_w_carriage_4x + k_4_2*t408
        + k_4_3*t408 - mu_4
    )
    K_ww_out[..., 10] = (
        D_delta_rx_17*f_rx_w_carriage_4y - D_delta_rx_17*t131 + D_delta_ry_17*f_ry_w_carriage_4y
        + D_delta_rz_17*f_rz_w_carriage_4y + D_delta_rz_17*t143 + D_delta_x_17**2*k_C
        + D_delta_x_17*f_x_w_carriage_4y + D_delta_y_17**2*k_C + D_delta_y_17*f_y_w_carriage_4y
        + D_delta_y_17*mu_4 + D_delta_z_17**2*k_C + D_delta_z_17*f_z_w_carriage_4y + k_4_2*t409 + k_4_3*t409
        - mu_4
    )
    K_ww_out[..., 11] = (
        D_delta_rx_18*f_rx_w_carriage_4z + D_delta_rx_18*t137 + D_delta_ry_18*f_ry_w_carriage_4z
        - D_delta_ry_18*t143 + D_delta_rz_18*f_rz_w_carriage_4z + D_delta_x_18**2*k_C
        + D_delta_x_18*f_x_w_carriage_4z + D_delta_y_18**2*k_C + D_delta_y_18*f_y_w_carriage_4z
        + D_delta_z_18**2*k_C + D_delta_z_18*f_z_w_carriage_4z + D_delta_z_18*mu_4 + k_4_2*t410 + k_4_3*t410
        - mu_4
    )
    K_ww_out[..., 12] = (
        D_delta_rx_19*f_rx_w_carriage_5x + D_delta_ry_19*f_ry_w_carriage_5x + D_delta_ry_19*t132
        + D_delta_rz_19*f_rz_w_carriage_5x - D_delta_rz_19*t138 + D_delta_x_19**2*k_C
        + D_delta_x_19*f_x_w_carriage_5x + D_delta_x_19*mu_5 + D_delta_y_19**2*k_C
        + D_delta_y_19*f_y_w_carriage_5x + D_delta_z_19**2*k_C + D_delta_z_19*f_z_w_carriage_5x + k_5_2*t411
        + k_5_3*t411 - mu_5
    )
    K_ww_out[..., 13] = (
        D_delta_rx_20*f_rx_w_carriage_5y - D_delta_rx_20*t132 + D_delta_ry_20*f_ry_w_carriage_5y
        + D_delta_rz_20*f_rz_w_carriage_5y + D_delta_rz_20*t144 + D_delta_x_20**2*k_C
        + D_delta_x_20*f_x_w_carriage_5y + D_delta_y_20**2*k_C + D_delta_y_20*f_y_w_carriage_5y
        + D_delta_y_20*mu_5 + D_delta_z_20**2*k_C + D_delta_z_20*f_z_w_carriage_5y + k_5_2*t412 + k_5_3*t412
        - mu_5
    )
    K_ww_out[..., 14] = (
        D_delta_rx_21*f_rx_w_carriage_5z + D_delta_rx_21*t138 + D_delta_ry_21*f_ry_w_carriage_5z
        - D_delta_ry_21*t144 + D_delta_rz_21*f_rz_w_carriage_5z + D_delta_x_21**2*k_C
        + D_delta_x_21*f_x_w_carriage_5z + D_delta_y_21**2*k_C + D_delta_y_21*f_y_w_carriage_5z
        + D_delta_z_21**2*k_C + D_delta_z_21*f_z_w_carriage_5z + D_delta_z_21*mu_5 + k_5_2*t413 + k_5_3*t413
        - mu_5
    )
    K_ww_out[..., 15] = (
        D_delta_rx_22*f_rx_w_carriage_6x + D_delta_ry_22*f_ry_w_carriage_6x + D_delta_ry_22*t133
        + D_delta_rz_22*f_rz_w_carriage_6x - D_delta_rz_22*t139 + D_delta_x_22**2*k_C
        + D_delta_x_22*f_x_w_carriage_6x + D_delta_x_22*mu_6 + D_delta_y_22**2*k_C
        + D_delta_y_22*f_y_w_carriage_6x + D_delta_z_22**2*k_C + D_delta_z_22*f_z_w_carriage_6x + k_6_2*t414
        + k_6_3*t414 - mu_6
    )
    K_ww_out[..., 16] = (
        D_delta_rx_23*f_rx_w_carriage_6y - D_delta_rx_23*t133 + D_delta_ry_23*f_ry_w_carriage_6y
        + D_delta_rz_23*f_rz_w_carriage_6y + D_delta_rz_23*t145 + D_delta_x_23**2*k_C
        + D_delta_x_23*f_x_w_carriage_6y + D_delta_y_23**2*k_C + D_delta_y_23*f_y_w_carriage_6y
        + D_delta_y_23*mu_6 + D_delta_z_23**2*k_C + D_delta_z_23*f_z_w_carriage_6y + k_6_2*t415 + k_6_3*t415
        - mu_6
    )
    K_ww_out[..., 17] = (
        D_delta_rx_24*f_rx_w_carriage_6z + D_delta_rx_24*t139 + D_delta_ry_24*f_ry_w_carriage_6z
        - D_delta_ry_24*t145 + D_delta_rz_24*f_rz_w_carriage_6z + D_delta_x_24**2*k_C
        + D_delta_x_24*f_x_w_carriage_6z + D_delta_y_24**2*k_C + D_delta_y_24*f_y_w_carriage_6z
        + D_delta_z_24**2*k_C + D_delta_z_24*f_z_w_carriage_6z + D_delta_z_24*mu_6 + k_6_2*t416 + k_6_3*t416
        - mu_6
    )
    K_ww_out[..., 18] = k_1_1 + k_1_3
    K_ww_out[..., 19] = k_1_1 + k_1_2
    K_ww_out[..., 20] = k_2_1 + k_2_3
    K_ww_out[..., 21] = k_2_1 + k_2_2
    K_ww_out[..., 22] = k_3_1 + k_3_3
    K_ww_out[..., 23] = k_3_1 + k_3_2
    K_ww_out[..., 24] = k_4_1 + k_4_3
    K_ww_out[..., 25] = k_4_1 + k_4_2
    K_ww_out[..., 26] = k_5_1 + k_5_3
    K_ww_out[..., 27] = k_5_1 + k_5_2
    K_ww_out[..., 28] = k_6_1 + k_6_3
    K_ww_out[..., 29] = k_6_1 + k_6_2
    J_p_out = np.zeros((*batch, 30, 6), dtype)
    J_p_out[..., 0, 0] = D_delta_x_7
    J_p_out[..., 0, 1] = D_delta_y_7
    J_p_out[..., 0, 2] = D_delta_z_7
    J_p_out[..., 0, 3] = D_delta_rx_7
    J_p_out[..., 0, 4] = D_delta_ry_7
    J_p_out[..., 0, 5] = D_delta_rz_7
    J_p_out[..., 1, 0] = D_delta_x_8
    J_p_out[..., 1, 1] = D_delta_y_8
    J_p_out[..., 1, 2] = D_delta_z_8
    J_p_out[..., 1, 3] = D_delta_rx_8
    J_p_out[..., 1, 4] = D_delta_ry_8
    J_p_out[..., 1, 5] = D_delta_rz_8
    J_p_out[..., 2, 0] = D_delta_x_9
    J_p_out[..., 2, 1] = D_delta_y_9
    J_p_out[..., 2, 2] = D_delta_z_9
    J_p_out[..., 2, 3] = D_delta_rx_9
    J_p_out[..., 2, 4] = D_delta_ry_9
    J_p_out[..., 2, 5] = D_delta_rz_9
    J_p_out[..., 3, 0] = D_delta_x_10
    J_p_out[..., 3, 1] = D_delta_y_10
    J_p_out[..., 3, 2] = D_delta_z_10
    J_p_out[..., 3, 3] = D_delta_rx_10
    J_p_out[..., 3, 4] = D_delta_ry_10
    J_p_out[..., 3, 5] = D_delta_rz_10
    J_p_out[..., 4, 0] = D_delta_x_11
    J_p_out[..., 4, 1] = D_delta_y_11
    J_p_out[..., 4, 2] = D_delta_z_11
    J_p_out[..., 4, 3] = D_delta_rx_11
    J_p_out[..., 4, 4] = D_delta_ry_11
    J_p_out[..., 4, 5] = D_delta_rz_11
    J_p_out[..., 5, 0] = D_delta_x_12
    J_p_out[..., 5, 1] = D_delta_y_12
    J_p_out[..., 5, 2] = D_delta_z_12
    J_p_out[..., 5, 3] = D_delta_rx_12
    J_p_out[..., 5, 4] = D_delta_ry_12
    J_p_out[..., 5, 5] = D_delta_rz_12
    J_p_out[..., 6, 0] = D_delta_x_13
    J_p_out[..., 6, 1] = D_delta_y_13
    J_p_out[..., 6, 2] = D_delta_z_13
    J_p_out[..., 6, 3] = D_delta_rx_13
    J_p_out[..., 6, 4] = D_delta_ry_13
    J_p_out[..., 6, 5] = D_delta_rz_13
    J_p_out[..., 7, 0] = D_delta_x_14
    J_p_out[..., 7, 1] = D_delta_y_14
    J_p_out[..., 7, 2] = D_delta_z_14
    J_p_out[..., 7, 3] = D_delta_rx_14
    J_p_out[..., 7, 4] = D_delta_ry_14
    J_p_out[..., 7, 5] = D_delta_rz_14
    J_p_out[..., 8, 0] = D_delta_x_15
    J_p_out[..., 8, 1] = D_delta_y_15
    J_p_out[..., 8, 2] = D_delta_z_15
    J_p_out[..., 8, 3] = D_delta_rx_15
    J_p_out[..., 8, 4] = D_delta_ry_15
    J_p_out[..., 8, 5] = D_delta_rz_15
    J_p_out[..., 9, 0] = D_delta_x_16
    J_p_out[..., 9, 1] = D_delta_y_16
    J_p_out[..., 9, 2] = D_delta_z_16
    J_p_out[..., 9, 3] = D_delta_rx_16
    J_p_out[..., 9, 4] = D_delta_ry_16
    J_p_out[..., 9, 5] = D_delta_rz_16
    J_p_out[..., 10, 0] = D_delta_x_17
    J_p_out[..., 10, 1] = D_delta_y_17
    J_p_out[..., 10, 2] = D_delta_z_17
    J_p_out[..., 10, 3] = D_delta_rx_17
    J_p_out[..., 10, 4] = D_delta_ry_17
    J_p_out[..., 10, 5] = D_delta_rz_17
    J_p_out[..., 11, 0] = D_delta_x_18
    J_p_out[..., 11, 1] = D_delta_y_18
    J_p_out[..., 11, 2] = D_delta_z_18
    J_p_out[..., 11, 3] = D_delta_rx_18
    J_p_out[..., 11, 4] = D_delta_ry_18
    J_p_out[..., 11, 5] = D_delta_rz_18
    J_p_out[..., 12, 0] = D_delta_x_19
    J_p_out[..., 12, 1] = D_delta_y_19
    J_p_out[..., 12, 2] = D_delta_z_19
    J_p_out[..., 12, 3] = D_delta_rx_19
    J_p_out[..., 12, 4] = D_delta_ry_19
    J_p_out[..., 12, 5] = D_delta_rz_19
    J_p_out[..., 13, 0] = D_delta_x_20
    J_p_out[..., 13, 1] = D_delta_y_20
    J_p_out[..., 13, 2] = D_delta_z_20
    J_p_out[..., 13, 3] = D_delta_rx_20
    J_p_out[..., 13, 4] = D_delta_ry_20
    J_p_out[..., 13, 5] = D_delta_rz_20
    J_p_out[..., 14, 0] = D_delta_x_21
    J_p_out[..., 14, 1] = D_delta_y_21
    J_p_out[..., 14, 2] = D_delta_z_21
    J_p_out[..., 14, 3] = D_delta_rx_21
    J_p_out[..., 14, 4] = D_delta_ry_21
    J_p_out[..., 14, 5] = D_delta_rz_21
    J_p_out[..., 15, 0] = D_delta_x_22
    J_p_out[..., 15, 1] = D_delta_y_22
    J_p_out[..., 15, 2] = D_delta_z_22
    J_p_out[..., 15, 3] = D_delta_rx_22
    J_p_out[..., 15, 4] = D_delta_ry_22
    J_p_out[..., 15, 5] = D_delta_rz_22
    J_p_out[..., 16, 0] = D_delta_x_23
    J_p_out[..., 16, 1] = D_delta_y_23
    J_p_out[..., 16, 2] = D_delta_z_23
    J_p_out[..., 16, 3] = D_delta_rx_23
    J_p_out[..., 16, 4] = D_delta_ry_23
    J_p_out[..., 16, 5] = D_delta_rz_23
    J_p_out[..., 17, 0] = D_delta_x_24
    J_p_out[..., 17, 1] = D_delta_y_24
    J_p_out[..., 17, 2] = D_delta_z_24
    J_p_out[..., 17, 3] = D_delta_rx_24
    J_p_out[..., 17, 4] = D_delta_ry_24
    J_p_out[..., 17, 5] = D_delta_rz_24
    return M_wq_out, M_ww_out, K_wq_out, K_ww_out, J_p_out


def mount_inertia(parameters):
    """Derivatives of the rows of M of the mounts with respect to the mass that moves with each.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M_wq : array, shape (..., 30, 39) [1]
        Of M_wq.
    M_ww : array, shape (..., 30) [1]
        Of M_ww.

    Notes
    -----
    The kinetic energy of a bearing that yields, of which the frame has the rest.
    0 operations; 0 with every named value expanded.
    """
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    batch, dtype = _batch(n_1_x)
    M_wq_out = np.zeros((*batch, 30, 39), dtype)
    M_wq_out[..., 18, 36] = n_1_x
    M_wq_out[..., 18, 37] = n_1_y
    M_wq_out[..., 18, 38] = n_1_z
    M_wq_out[..., 19, 36] = n_1_x
    M_wq_out[..., 19, 37] = n_1_y
    M_wq_out[..., 19, 38] = n_1_z
    M_wq_out[..., 20, 36] = n_2_x
    M_wq_out[..., 20, 37] = n_2_y
    M_wq_out[..., 20, 38] = n_2_z
    M_wq_out[..., 21, 36] = n_2_x
    M_wq_out[..., 21, 37] = n_2_y
    M_wq_out[..., 21, 38] = n_2_z
    M_wq_out[..., 22, 36] = n_3_x
    M_wq_out[..., 22, 37] = n_3_y
    M_wq_out[..., 22, 38] = n_3_z
    M_wq_out[..., 23, 36] = n_3_x
    M_wq_out[..., 23, 37] = n_3_y
    M_wq_out[..., 23, 38] = n_3_z
    M_wq_out[..., 24, 36] = n_4_x
    M_wq_out[..., 24, 37] = n_4_y
    M_wq_out[..., 24, 38] = n_4_z
    M_wq_out[..., 25, 36] = n_4_x
    M_wq_out[..., 25, 37] = n_4_y
    M_wq_out[..., 25, 38] = n_4_z
    M_wq_out[..., 26, 36] = n_5_x
    M_wq_out[..., 26, 37] = n_5_y
    M_wq_out[..., 26, 38] = n_5_z
    M_wq_out[..., 27, 36] = n_5_x
    M_wq_out[..., 27, 37] = n_5_y
    M_wq_out[..., 27, 38] = n_5_z
    M_wq_out[..., 28, 36] = n_6_x
    M_wq_out[..., 28, 37] = n_6_y
    M_wq_out[..., 28, 38] = n_6_z
    M_wq_out[..., 29, 36] = n_6_x
    M_wq_out[..., 29, 37] = n_6_y
    M_wq_out[..., 29, 38] = n_6_z
    M_ww_out = np.zeros((*batch, 30), dtype)
    M_ww_out[..., 18] = 1
    M_ww_out[..., 19] = 1
    M_ww_out[..., 20] = 1
    M_ww_out[..., 21] = 1
    M_ww_out[..., 22] = 1
    M_ww_out[..., 23] = 1
    M_ww_out[..., 24] = 1
    M_ww_out[..., 25] = 1
    M_ww_out[..., 26] = 1
    M_ww_out[..., 27] = 1
    M_ww_out[..., 28] = 1
    M_ww_out[..., 29] = 1
    return M_wq_out, M_ww_out
