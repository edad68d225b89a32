# Generated from the derivation of hexapod and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Terms of the mechanism hexapod: motion of its bodies, and what holds them yielding.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: leg j; coordinate k of a derivative; component i = x, y, z; rows r of a minor;
columns c of a minor; axis a of the platform.  t1, t2, ... are subexpressions shared by several values.

* half_angle [rad]: half the angle of rotation
* s_half [1]: sine of half the angle over half the angle
* c_half [1]: cosine of half the angle
* R_i_a [1]: rotation matrix of the platform: component i of its axis a
* l_j [m]: length of leg j
* B_j_i [m]: platform joint j from the platform's origin, base frame, component i
* d_j_i [m]: leg j, from base joint to platform joint, component i
* c_i [m]: centre of mass of the platform from its origin, component i
* J_i_a [kg m^2]: inertia tensor of the platform about its centre of mass, base frame, entry ia
* m_perp_j [kg]: inertia of leg j at its platform joint, perpendicular to the leg
* m_lift_j [kg]: mass that is lifted with the vector of leg j
* o_L_i [m]: payload from the platform's origin, base frame, component i
* D_l_j_i [m^2]: moment of linkage vector j about the platform's origin, component i
* A_i_j [m^8]: adjugate of D_l, entry i, j
* minor_r_c [m^2]: minor of D_l, rows r and columns c
* minor_r_c [m^4]: minor of D_l, rows r and columns c
* minor_r_c [m^6]: minor of D_l, rows r and columns c
* minor_r_c [m^3]: minor of D_l, rows r and columns c
* minor_r_c [m^5]: minor of D_l, rows r and columns c
* A_i_j [m^7]: adjugate of D_l, entry i, j
* det_D_l [m^9]: determinant of D_l
* D_p_i_k [1]: platform Jacobian, dp_i/dl_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* D_p_i_k [1/m]: platform Jacobian, dp_i/dl_k
* D_delta_i_k [1/m]: platform Jacobian, dp_i/ddelta_k
* U_j_i_k [1]: derivative of linkage vector j, component i, with respect to l_k
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
    "l_1",
    "l_2",
    "l_3",
    "l_4",
    "l_5",
    "l_6",
    "s_1",
    "s_2",
    "s_3",
    "s_4",
    "s_5",
    "s_6",
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
    J : array, shape (..., 51, 15) [1, m]
        One row for each displacement.

    Notes
    -----
    The velocities of the bodies that the mechanism declares, without the mounts of terms.
    2528 operations; 500243688 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z, a_4_x, a_4_y, a_4_z, a_5_x, a_5_y,
        a_5_z, a_6_x, a_6_y, a_6_z,
    ) = _entries(parameters.base, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    c_b_1, c_b_2, c_b_3, c_b_4, c_b_5, c_b_6 = _entries(parameters.leg_base_center, (6,))
    c_r_1, c_r_2, c_r_3, c_r_4, c_r_5, c_r_6 = _entries(parameters.leg_rod_center, (6,))
    batch, dtype = _batch(p_x, a_1_x, b_1_x, c_b_1, c_r_1)
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
    d_1_x = B_1_x - a_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    d_1_y = B_1_y - a_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    d_1_z = B_1_z - a_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    d_2_x = B_2_x - a_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    d_2_y = B_2_y - a_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    d_2_z = B_2_z - a_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    d_3_x = B_3_x - a_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    d_3_y = B_3_y - a_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    d_3_z = B_3_z - a_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    d_4_x = B_4_x - a_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    d_4_y = B_4_y - a_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    d_4_z = B_4_z - a_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    d_5_x = B_5_x - a_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    d_5_y = B_5_y - a_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    d_5_z = B_5_z - a_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    d_6_x = B_6_x - a_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    d_6_y = B_6_y - a_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    d_6_z = B_6_z - a_6_z + p_z
    l_1 = np.sqrt(d_1_x**2 + d_1_y**2 + d_1_z**2)
    l_2 = np.sqrt(d_2_x**2 + d_2_y**2 + d_2_z**2)
    l_3 = np.sqrt(d_3_x**2 + d_3_y**2 + d_3_z**2)
    l_4 = np.sqrt(d_4_x**2 + d_4_y**2 + d_4_z**2)
    l_5 = np.sqrt(d_5_x**2 + d_5_y**2 + d_5_z**2)
    l_6 = np.sqrt(d_6_x**2 + d_6_y**2 + d_6_z**2)
    D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y
    D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x
    D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x
    D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y
    D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x
    D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x
    D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y
    D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x
    D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x
    D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y
    D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x
    D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x
    D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y
    D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x
    D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x
    D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y
    D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x
    D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x
    minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y
    minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z
    minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56
    minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y
    minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46
    minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45
    minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z
    minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y
    minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56
    minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z
    minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46
    minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x
    minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x
    minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x
    minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x
    minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x
    minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56
    minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45
    minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16
    minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15
    minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x
    minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16
    minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15
    minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12
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
    minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y
    minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y
    minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y
    minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y
    minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z
    minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z
    minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x
    minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x
    minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x
    minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x
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
    minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y
    minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y
    minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y
    minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y
    minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z
    minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z
    minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x
    minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x
    minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x
    minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x
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
    minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24
    minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25
    minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14
    minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15
    minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14
    minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15
    minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12
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
    minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z
    minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z
    minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z
    minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y
    minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y
    minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y
    minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x
    minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x
    minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x
    minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x
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
    minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z
    minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z
    minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z
    minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y
    minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y
    minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y
    minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x
    minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x
    minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x
    minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x
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
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z
    t12 = 1.0/det_D_l
    t13 = l_1*t12
    D_p_x_1 = A_x_1*t13
    t14 = l_2*t12
    D_p_x_2 = A_x_2*t14
    t15 = l_3*t12
    D_p_x_3 = A_x_3*t15
    t16 = l_4*t12
    D_p_x_4 = A_x_4*t16
    t17 = l_5*t12
    D_p_x_5 = A_x_5*t17
    t18 = l_6*t12
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
    U_1_x_1 = -B_1_y*D_p_rz_1 + B_1_z*D_p_ry_1 + D_p_x_1
    t19 = B_1_y*D_p_rz_2
    U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t19
    t20 = B_1_y*D_p_rz_3
    U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t20
    t21 = B_1_y*D_p_rz_4
    U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t21
    t22 = B_1_y*D_p_rz_5
    U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t22
    t23 = B_1_y*D_p_rz_6
    U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t23
    U_1_y_1 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1 + D_p_y_1
    U_1_y_2 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2 + D_p_y_2
    U_1_y_3 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3 + D_p_y_3
    U_1_y_4 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4 + D_p_y_4
    U_1_y_5 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5 + D_p_y_5
    U_1_y_6 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6 + D_p_y_6
    U_1_z_1 = -B_1_x*D_p_ry_1 + B_1_y*D_p_rx_1 + D_p_z_1
    t24 = B_1_x*D_p_ry_2
    U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t24
    t25 = B_1_x*D_p_ry_3
    U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t25
    t26 = B_1_x*D_p_ry_4
    U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t26
    t27 = B_1_x*D_p_ry_5
    U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t27
    t28 = B_1_x*D_p_ry_6
    U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t28
    t29 = B_2_y*D_p_rz_1
    U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t29
    U_2_x_2 = -B_2_y*D_p_rz_2 + B_2_z*D_p_ry_2 + D_p_x_2
    t30 = B_2_y*D_p_rz_3
    U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t30
    t31 = B_2_y*D_p_rz_4
    U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t31
    t32 = B_2_y*D_p_rz_5
    U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t32
    t33 = B_2_y*D_p_rz_6
    U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t33
    U_2_y_1 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1 + D_p_y_1
    U_2_y_2 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2 + D_p_y_2
    U_2_y_3 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3 + D_p_y_3
    U_2_y_4 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4 + D_p_y_4
    U_2_y_5 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5 + D_p_y_5
    U_2_y_6 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6 + D_p_y_6
    t34 = B_2_x*D_p_ry_1
    U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t34
    U_2_z_2 = -B_2_x*D_p_ry_2 + B_2_y*D_p_rx_2 + D_p_z_2
    t35 = B_2_x*D_p_ry_3
    U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t35
    t36 = B_2_x*D_p_ry_4
    U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t36
    t37 = B_2_x*D_p_ry_5
    U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t37
    t38 = B_2_x*D_p_ry_6
    U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t38
    t39 = B_3_y*D_p_rz_1
    U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t39
    t40 = B_3_y*D_p_rz_2
    U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t40
    U_3_x_3 = -B_3_y*D_p_rz_3 + B_3_z*D_p_ry_3 + D_p_x_3
    t41 = B_3_y*D_p_rz_4
    U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t41
    t42 = B_3_y*D_p_rz_5
    U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t42
    t43 = B_3_y*D_p_rz_6
    U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t43
    U_3_y_1 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1 + D_p_y_1
    U_3_y_2 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2 + D_p_y_2
    U_3_y_3 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3 + D_p_y_3
    U_3_y_4 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4 + D_p_y_4
    U_3_y_5 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5 + D_p_y_5
    U_3_y_6 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6 + D_p_y_6
    t44 = B_3_x*D_p_ry_1
    U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t44
    t45 = B_3_x*D_p_ry_2
    U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t45
    U_3_z_3 = -B_3_x*D_p_ry_3 + B_3_y*D_p_rx_3 + D_p_z_3
    t46 = B_3_x*D_p_ry_4
    U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t46
    t47 = B_3_x*D_p_ry_5
    U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t47
    t48 = B_3_x*D_p_ry_6
    U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t48
    t49 = B_4_y*D_p_rz_1
    U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t49
    t50 = B_4_y*D_p_rz_2
    U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t50
    t51 = B_4_y*D_p_rz_3
    U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t51
    U_4_x_4 = -B_4_y*D_p_rz_4 + B_4_z*D_p_ry_4 + D_p_x_4
    t52 = B_4_y*D_p_rz_5
    U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t52
    t53 = B_4_y*D_p_rz_6
    U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t53
    U_4_y_1 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1 + D_p_y_1
    U_4_y_2 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2 + D_p_y_2
    U_4_y_3 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3 + D_p_y_3
    U_4_y_4 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4 + D_p_y_4
    U_4_y_5 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5 + D_p_y_5
    U_4_y_6 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6 + D_p_y_6
    t54 = B_4_x*D_p_ry_1
    U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t54
    t55 = B_4_x*D_p_ry_2
    U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t55
    t56 = B_4_x*D_p_ry_3
    U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t56
    U_4_z_4 = -B_4_x*D_p_ry_4 + B_4_y*D_p_rx_4 + D_p_z_4
    t57 = B_4_x*D_p_ry_5
    U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t57
    t58 = B_4_x*D_p_ry_6
    U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t58
    t59 = B_5_y*D_p_rz_1
    U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t59
    t60 = B_5_y*D_p_rz_2
    U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t60
    t61 = B_5_y*D_p_rz_3
    U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t61
    t62 = B_5_y*D_p_rz_4
    U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t62
    U_5_x_5 = -B_5_y*D_p_rz_5 + B_5_z*D_p_ry_5 + D_p_x_5
    t63 = B_5_y*D_p_rz_6
    U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t63
    U_5_y_1 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1 + D_p_y_1
    U_5_y_2 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2 + D_p_y_2
    U_5_y_3 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3 + D_p_y_3
    U_5_y_4 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4 + D_p_y_4
    U_5_y_5 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5 + D_p_y_5
    U_5_y_6 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6 + D_p_y_6
    t64 = B_5_x*D_p_ry_1
    U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t64
    t65 = B_5_x*D_p_ry_2
    U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t65
    t66 = B_5_x*D_p_ry_3
    U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t66
    t67 = B_5_x*D_p_ry_4
    U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t67
    U_5_z_5 = -B_5_x*D_p_ry_5 + B_5_y*D_p_rx_5 + D_p_z_5
    t68 = B_5_x*D_p_ry_6
    U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t68
    t69 = B_6_y*D_p_rz_1
    U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t69
    t70 = B_6_y*D_p_rz_2
    U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t70
    t71 = B_6_y*D_p_rz_3
    U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t71
    t72 = B_6_y*D_p_rz_4
    U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t72
    t73 = B_6_y*D_p_rz_5
    U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t73
    U_6_x_6 = -B_6_y*D_p_rz_6 + B_6_z*D_p_ry_6 + D_p_x_6
    U_6_y_1 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1 + D_p_y_1
    U_6_y_2 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2 + D_p_y_2
    U_6_y_3 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3 + D_p_y_3
    U_6_y_4 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4 + D_p_y_4
    U_6_y_5 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5 + D_p_y_5
    U_6_y_6 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6 + D_p_y_6
    t74 = B_6_x*D_p_ry_1
    U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t74
    t75 = B_6_x*D_p_ry_2
    U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t75
    t76 = B_6_x*D_p_ry_3
    U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t76
    t77 = B_6_x*D_p_ry_4
    U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t77
    t78 = B_6_x*D_p_ry_5
    U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t78
    U_6_z_6 = -B_6_x*D_p_ry_6 + B_6_y*D_p_rx_6 + D_p_z_6
    t79 = 1.0/l_1
    t80 = c_b_1*t79
    t81 = 1.0/(l_1**2)
    t82 = c_b_1*t81
    t83 = c_r_1*t81
    t84 = c_r_1*t79
    t85 = 1.0/l_2
    t86 = c_b_2*t85
    t87 = 1.0/(l_2**2)
    t88 = c_b_2*t87
    t89 = c_r_2*t85
    t90 = c_r_2*t87
    t91 = 1.0/l_3
    t92 = c_b_3*t91
    t93 = 1.0/(l_3**2)
    t94 = c_b_3*t93
    t95 = c_r_3*t91
    t96 = c_r_3*t93
    t97 = 1.0/l_4
    t98 = c_b_4*t97
    t99 = 1.0/(l_4**2)
    t100 = c_b_4*t99
    t101 = c_r_4*t97
    t102 = c_r_4*t99
    t103 = 1.0/l_5
    t104 = c_b_5*t103
    t105 = 1.0/(l_5**2)
    t106 = c_b_5*t105
    t107 = c_r_5*t103
    t108 = c_r_5*t105
    t109 = 1.0/l_6
    t110 = c_b_6*t109
    t111 = 1.0/(l_6**2)
    t112 = c_b_6*t111
    t113 = c_r_6*t109
    t114 = c_r_6*t111
    J_out = np.zeros((*batch, 51, 15), dtype)
    J_out[..., 0, 0] = D_p_x_1
    J_out[..., 0, 1] = D_p_x_2
    J_out[..., 0, 2] = D_p_x_3
    J_out[..., 0, 3] = D_p_x_4
    J_out[..., 0, 4] = D_p_x_5
    J_out[..., 0, 5] = D_p_x_6
    J_out[..., 0, 12] = 1
    J_out[..., 1, 0] = D_p_y_1
    J_out[..., 1, 1] = D_p_y_2
    J_out[..., 1, 2] = D_p_y_3
    J_out[..., 1, 3] = D_p_y_4
    J_out[..., 1, 4] = D_p_y_5
    J_out[..., 1, 5] = D_p_y_6
    J_out[..., 1, 13] = 1
    J_out[..., 2, 0] = D_p_z_1
    J_out[..., 2, 1] = D_p_z_2
    J_out[..., 2, 2] = D_p_z_3
    J_out[..., 2, 3] = D_p_z_4
    J_out[..., 2, 4] = D_p_z_5
    J_out[..., 2, 5] = D_p_z_6
    J_out[..., 2, 14] = 1
    J_out[..., 3, 0] = U_1_x_1*t80 - d_1_x*t82
    J_out[..., 3, 1] = U_1_x_2*t80
    J_out[..., 3, 2] = U_1_x_3*t80
    J_out[..., 3, 3] = U_1_x_4*t80
    J_out[..., 3, 4] = U_1_x_5*t80
    J_out[..., 3, 5] = U_1_x_6*t80
    J_out[..., 3, 12] = 1
    J_out[..., 4, 0] = U_1_y_1*t80 - d_1_y*t82
    J_out[..., 4, 1] = U_1_y_2*t80
    J_out[..., 4, 2] = U_1_y_3*t80
    J_out[..., 4, 3] = U_1_y_4*t80
    J_out[..., 4, 4] = U_1_y_5*t80
    J_out[..., 4, 5] = U_1_y_6*t80
    J_out[..., 4, 13] = 1
    J_out[..., 5, 0] = U_1_z_1*t80 - d_1_z*t82
    J_out[..., 5, 1] = U_1_z_2*t80
    J_out[..., 5, 2] = U_1_z_3*t80
    J_out[..., 5, 3] = U_1_z_4*t80
    J_out[..., 5, 4] = U_1_z_5*t80
    J_out[..., 5, 5] = U_1_z_6*t80
    J_out[..., 5, 14] = 1
    J_out[..., 6, 0] = -U_1_x_1*t84 + U_1_x_1 + d_1_x*t83
    J_out[..., 6, 1] = B_1_z*D_p_ry_2 + D_p_x_2 - U_1_x_2*t84 - t19
    J_out[..., 6, 2] = B_1_z*D_p_ry_3 + D_p_x_3 - U_1_x_3*t84 - t20
    J_out[..., 6, 3] = B_1_z*D_p_ry_4 + D_p_x_4 - U_1_x_4*t84 - t21
    J_out[..., 6, 4] = B_1_z*D_p_ry_5 + D_p_x_5 - U_1_x_5*t84 - t22
    J_out[..., 6, 5] = B_1_z*D_p_ry_6 + D_p_x_6 - U_1_x_6*t84 - t23
    J_out[..., 6, 12] = 1
    J_out[..., 7, 0] = -U_1_y_1*t84 + U_1_y_1 + d_1_y*t83
    J_out[..., 7, 1] = -U_1_y_2*t84 + U_1_y_2
    J_out[..., 7, 2] = -U_1_y_3*t84 + U_1_y_3
    J_out[..., 7, 3] = -U_1_y_4*t84 + U_1_y_4
    J_out[..., 7, 4] = -U_1_y_5*t84 + U_1_y_5
    J_out[..., 7, 5] = -U_1_y_6*t84 + U_1_y_6
    J_out[..., 7, 13] = 1
    J_out[..., 8, 0] = -U_1_z_1*t84 + U_1_z_1 + d_1_z*t83
    J_out[..., 8, 1] = B_1_y*D_p_rx_2 + D_p_z_2 - U_1_z_2*t84 - t24
    J_out[..., 8, 2] = B_1_y*D_p_rx_3 + D_p_z_3 - U_1_z_3*t84 - t25
    J_out[..., 8, 3] = B_1_y*D_p_rx_4 + D_p_z_4 - U_1_z_4*t84 - t26
    J_out[..., 8, 4] = B_1_y*D_p_rx_5 + D_p_z_5 - U_1_z_5*t84 - t27
    J_out[..., 8, 5] = B_1_y*D_p_rx_6 + D_p_z_6 - U_1_z_6*t84 - t28
    J_out[..., 8, 14] = 1
    J_out[..., 9, 0] = U_2_x_1*t86
    J_out[..., 9, 1] = U_2_x_2*t86 - d_2_x*t88
    J_out[..., 9, 2] = U_2_x_3*t86
    J_out[..., 9, 3] = U_2_x_4*t86
    J_out[..., 9, 4] = U_2_x_5*t86
    J_out[..., 9, 5] = U_2_x_6*t86
    J_out[..., 9, 12] = 1
    J_out[..., 10, 0] = U_2_y_1*t86
    J_out[..., 10, 1] = U_2_y_2*t86 - d_2_y*t88
    J_out[..., 10, 2] = U_2_y_3*t86
    J_out[..., 10, 3] = U_2_y_4*t86
    J_out[..., 10, 4] = U_2_y_5*t86
    J_out[..., 10, 5] = U_2_y_6*t86
    J_out[..., 10, 13] = 1
    J_out[..., 11, 0] = U_2_z_1*t86
    J_out[..., 11, 1] = U_2_z_2*t86 - d_2_z*t88
    J_out[..., 11, 2] = U_2_z_3*t86
    J_out[..., 11, 3] = U_2_z_4*t86
    J_out[..., 11, 4] = U_2_z_5*t86
    J_out[..., 11, 5] = U_2_z_6*t86
    J_out[..., 11, 14] = 1
    J_out[..., 12, 0] = B_2_z*D_p_ry_1 + D_p_x_1 - U_2_x_1*t89 - t29
    J_out[..., 12, 1] = -U_2_x_2*t89 + U_2_x_2 + d_2_x*t90
    J_out[..., 12, 2] = B_2_z*D_p_ry_3 + D_p_x_3 - U_2_x_3*t89 - t30
    J_out[..., 12, 3] = B_2_z*D_p_ry_4 + D_p_x_4 - U_2_x_4*t89 - t31
    J_out[..., 12, 4] = B_2_z*D_p_ry_5 + D_p_x_5 - U_2_x_5*t89 - t32
    J_out[..., 12, 5] = B_2_z*D_p_ry_6 + D_p_x_6 - U_2_x_6*t89 - t33
    J_out[..., 12, 12] = 1
    J_out[..., 13, 0] = -U_2_y_1*t89 + U_2_y_1
    J_out[..., 13, 1] = -U_2_y_2*t89 + U_2_y_2 + d_2_y*t90
    J_out[..., 13, 2] = -U_2_y_3*t89 + U_2_y_3
    J_out[..., 13, 3] = -U_2_y_4*t89 + U_2_y_4
    J_out[..., 13, 4] = -U_2_y_5*t89 + U_2_y_5
    J_out[..., 13, 5] = -U_2_y_6*t89 + U_2_y_6
    J_out[..., 13, 13] = 1
    J_out[..., 14, 0] = B_2_y*D_p_rx_1 + D_p_z_1 - U_2_z_1*t89 - t34
    J_out[..., 14, 1] = -U_2_z_2*t89 + U_2_z_2 + d_2_z*t90
    J_out[..., 14, 2] = B_2_y*D_p_rx_3 + D_p_z_3 - U_2_z_3*t89 - t35
    J_out[..., 14, 3] = B_2_y*D_p_rx_4 + D_p_z_4 - U_2_z_4*t89 - t36
    J_out[..., 14, 4] = B_2_y*D_p_rx_5 + D_p_z_5 - U_2_z_5*t89 - t37
    J_out[..., 14, 5] = B_2_y*D_p_rx_6 + D_p_z_6 - U_2_z_6*t89 - t38
    J_out[..., 14, 14] = 1
    J_out[..., 15, 0] = U_3_x_1*t92
    J_out[..., 15, 1] = U_3_x_2*t92
    J_out[..., 15, 2] = U_3_x_3*t92 - d_3_x*t94
    J_out[..., 15, 3] = U_3_x_4*t92
    J_out[..., 15, 4] = U_3_x_5*t92
    J_out[..., 15, 5] = U_3_x_6*t92
    J_out[..., 15, 12] = 1
    J_out[..., 16, 0] = U_3_y_1*t92
    J_out[..., 16, 1] = U_3_y_2*t92
    J_out[..., 16, 2] = U_3_y_3*t92 - d_3_y*t94
    J_out[..., 16, 3] = U_3_y_4*t92
    J_out[..., 16, 4] = U_3_y_5*t92
    J_out[..., 16, 5] = U_3_y_6*t92
    J_out[..., 16, 13] = 1
    J_out[..., 17, 0] = U_3_z_1*t92
    J_out[..., 17, 1] = U_3_z_2*t92
    J_out[..., 17, 2] = U_3_z_3*t92 - d_3_z*t94
    J_out[..., 17, 3] = U_3_z_4*t92
    J_out[..., 17, 4] = U_3_z_5*t92
    J_out[..., 17, 5] = U_3_z_6*t92
    J_out[..., 17, 14] = 1
    J_out[..., 18, 0] = B_3_z*D_p_ry_1 + D_p_x_1 - U_3_x_1*t95 - t39
    J_out[..., 18, 1] = B_3_z*D_p_ry_2 + D_p_x_2 - U_3_x_2*t95 - t40
    J_out[..., 18, 2] = -U_3_x_3*t95 + U_3_x_3 + d_3_x*t96
    J_out[..., 18, 3] = B_3_z*D_p_ry_4 + D_p_x_4 - U_3_x_4*t95 - t41
    J_out[..., 18, 4] = B_3_z*D_p_ry_5 + D_p_x_5 - U_3_x_5*t95 - t42
    J_out[..., 18, 5] = B_3_z*D_p_ry_6 + D_p_x_6 - U_3_x_6*t95 - t43
    J_out[..., 18, 12] = 1
    J_out[..., 19, 0] = -U_3_y_1*t95 + U_3_y_1
    J_out[..., 19, 1] = -U_3_y_2*t95 + U_3_y_2
    J_out[..., 19, 2] = -U_3_y_3*t95 + U_3_y_3 + d_3_y*t96
    J_out[..., 19, 3] = -U_3_y_4*t95 + U_3_y_4
    J_out[..., 19, 4] = -U_3_y_5*t95 + U_3_y_5
    J_out[..., 19, 5] = -U_3_y_6*t95 + U_3_y_6
    J_out[..., 19, 13] = 1
    J_out[..., 20, 0] = B_3_y*D_p_rx_1 + D_p_z_1 - U_3_z_1*t95 - t44
    J_out[..., 20, 1] = B_3_y*D_p_rx_2 + D_p_z_2 - U_3_z_2*t95 - t45
    J_out[..., 20, 2] = -U_3_z_3*t95 + U_3_z_3 + d_3_z*t96
    J_out[..., 20, 3] = B_3_y*D_p_rx_4 + D_p_z_4 - U_3_z_4*t95 - t46
    J_out[..., 20, 4] = B_3_y*D_p_rx_5 + D_p_z_5 - U_3_z_5*t95 - t47
    J_out[..., 20, 5] = B_3_y*D_p_rx_6 + D_p_z_6 - U_3_z_6*t95 - t48
    J_out[..., 20, 14] = 1
    J_out[..., 21, 0] = U_4_x_1*t98
    J_out[..., 21, 1] = U_4_x_2*t98
    J_out[..., 21, 2] = U_4_x_3*t98
    J_out[..., 21, 3] = U_4_x_4*t98 - d_4_x*t100
    J_out[..., 21, 4] = U_4_x_5*t98
    J_out[..., 21, 5] = U_4_x_6*t98
    J_out[..., 21, 12] = 1
    J_out[..., 22, 0] = U_4_y_1*t98
    J_out[..., 22, 1] = U_4_y_2*t98
    J_out[..., 22, 2] = U_4_y_3*t98
    J_out[..., 22, 3] = U_4_y_4*t98 - d_4_y*t100
    J_out[..., 22, 4] = U_4_y_5*t98
    J_out[..., 22, 5] = U_4_y_6*t98
    J_out[..., 22, 13] = 1
    J_out[..., 23, 0] = U_4_z_1*t98
    J_out[..., 23, 1] = U_4_z_2*t98
    J_out[..., 23, 2] = U_4_z_3*t98
    J_out[..., 23, 3] = U_4_z_4*t98 - d_4_z*t100
    J_out[..., 23, 4] = U_4_z_5*t98
    J_out[..., 23, 5] = U_4_z_6*t98
    J_out[..., 23, 14] = 1
    J_out[..., 24, 0] = B_4_z*D_p_ry_1 + D_p_x_1 - U_4_x_1*t101 - t49
    J_out[..., 24, 1] = B_4_z*D_p_ry_2 + D_p_x_2 - U_4_x_2*t101 - t50
    J_out[..., 24, 2] = B_4_z*D_p_ry_3 + D_p_x_3 - U_4_x_3*t101 - t51
    J_out[..., 24, 3] = -U_4_x_4*t101 + U_4_x_4 + d_4_x*t102
    J_out[..., 24, 4] = B_4_z*D_p_ry_5 + D_p_x_5 - U_4_x_5*t101 - t52
    J_out[..., 24, 5] = B_4_z*D_p_ry_6 + D_p_x_6 - U_4_x_6*t101 - t53
    J_out[..., 24, 12] = 1
    J_out[..., 25, 0] = -U_4_y_1*t101 + U_4_y_1
    J_out[..., 25, 1] = -U_4_y_2*t101 + U_4_y_2
    J_out[..., 25, 2] = -U_4_y_3*t101 + U_4_y_3
    J_out[..., 25, 3] = -U_4_y_4*t101 + U_4_y_4 + d_4_y*t102
    J_out[..., 25, 4] = -U_4_y_5*t101 + U_4_y_5
    J_out[..., 25, 5] = -U_4_y_6*t101 + U_4_y_6
    J_out[..., 25, 13] = 1
    J_out[..., 26, 0] = B_4_y*D_p_rx_1 + D_p_z_1 - U_4_z_1*t101 - t54
    J_out[..., 26, 1] = B_4_y*D_p_rx_2 + D_p_z_2 - U_4_z_2*t101 - t55
    J_out[..., 26, 2] = B_4_y*D_p_rx_3 + D_p_z_3 - U_4_z_3*t101 - t56
    J_out[..., 26, 3] = -U_4_z_4*t101 + U_4_z_4 + d_4_z*t102
    J_out[..., 26, 4] = B_4_y*D_p_rx_5 + D_p_z_5 - U_4_z_5*t101 - t57
    J_out[..., 26, 5] = B_4_y*D_p_rx_6 + D_p_z_6 - U_4_z_6*t101 - t58
    J_out[..., 26, 14] = 1
    J_out[..., 27, 0] = U_5_x_1*t104
    J_out[..., 27, 1] = U_5_x_2*t104
    J_out[..., 27, 2] = U_5_x_3*t104
    J_out[..., 27, 3] = U_5_x_4*t104
    J_out[..., 27, 4] = U_5_x_5*t104 - d_5_x*t106
    J_out[..., 27, 5] = U_5_x_6*t104
    J_out[..., 27, 12] = 1
    J_out[..., 28, 0] = U_5_y_1*t104
    J_out[..., 28, 1] = U_5_y_2*t104
    J_out[..., 28, 2] = U_5_y_3*t104
    J_out[..., 28, 3] = U_5_y_4*t104
    J_out[..., 28, 4] = U_5_y_5*t104 - d_5_y*t106
    J_out[..., 28, 5] = U_5_y_6*t104
    J_out[..., 28, 13] = 1
    J_out[..., 29, 0] = U_5_z_1*t104
    J_out[..., 29, 1] = U_5_z_2*t104
    J_out[..., 29, 2] = U_5_z_3*t104
    J_out[..., 29, 3] = U_5_z_4*t104
    J_out[..., 29, 4] = U_5_z_5*t104 - d_5_z*t106
    J_out[..., 29, 5] = U_5_z_6*t104
    J_out[..., 29, 14] = 1
    J_out[..., 30, 0] = B_5_z*D_p_ry_1 + D_p_x_1 - U_5_x_1*t107 - t59
    J_out[..., 30, 1] = B_5_z*D_p_ry_2 + D_p_x_2 - U_5_x_2*t107 - t60
    J_out[..., 30, 2] = B_5_z*D_p_ry_3 + D_p_x_3 - U_5_x_3*t107 - t61
    J_out[..., 30, 3] = B_5_z*D_p_ry_4 + D_p_x_4 - U_5_x_4*t107 - t62
    J_out[..., 30, 4] = -U_5_x_5*t107 + U_5_x_5 + d_5_x*t108
    J_out[..., 30, 5] = B_5_z*D_p_ry_6 + D_p_x_6 - U_5_x_6*t107 - t63
    J_out[..., 30, 12] = 1
    J_out[..., 31, 0] = -U_5_y_1*t107 + U_5_y_1
    J_out[..., 31, 1] = -U_5_y_2*t107 + U_5_y_2
    J_out[..., 31, 2] = -U_5_y_3*t107 + U_5_y_3
    J_out[..., 31, 3] = -U_5_y_4*t107 + U_5_y_4
    J_out[..., 31, 4] = -U_5_y_5*t107 + U_5_y_5 + d_5_y*t108
    J_out[..., 31, 5] = -U_5_y_6*t107 + U_5_y_6
    J_out[..., 31, 13] = 1
    J_out[..., 32, 0] = B_5_y*D_p_rx_1 + D_p_z_1 - U_5_z_1*t107 - t64
    J_out[..., 32, 1] = B_5_y*D_p_rx_2 + D_p_z_2 - U_5_z_2*t107 - t65
    J_out[..., 32, 2] = B_5_y*D_p_rx_3 + D_p_z_3 - U_5_z_3*t107 - t66
    J_out[..., 32, 3] = B_5_y*D_p_rx_4 + D_p_z_4 - U_5_z_4*t107 - t67
    J_out[..., 32, 4] = -U_5_z_5*t107 + U_5_z_5 + d_5_z*t108
    J_out[..., 32, 5] = B_5_y*D_p_rx_6 + D_p_z_6 - U_5_z_6*t107 - t68
    J_out[..., 32, 14] = 1
    J_out[..., 33, 0] = U_6_x_1*t110
    J_out[..., 33, 1] = U_6_x_2*t110
    J_out[..., 33, 2] = U_6_x_3*t110
    J_out[..., 33, 3] = U_6_x_4*t110
    J_out[..., 33, 4] = U_6_x_5*t110
    J_out[..., 33, 5] = U_6_x_6*t110 - d_6_x*t112
    J_out[..., 33, 12] = 1
    J_out[..., 34, 0] = U_6_y_1*t110
    J_out[..., 34, 1] = U_6_y_2*t110
    J_out[..., 34, 2] = U_6_y_3*t110
    J_out[..., 34, 3] = U_6_y_4*t110
    J_out[..., 34, 4] = U_6_y_5*t110
    J_out[..., 34, 5] = U_6_y_6*t110 - d_6_y*t112
    J_out[..., 34, 13] = 1
    J_out[..., 35, 0] = U_6_z_1*t110
    J_out[..., 35, 1] = U_6_z_2*t110
    J_out[..., 35, 2] = U_6_z_3*t110
    J_out[..., 35, 3] = U_6_z_4*t110
    J_out[..., 35, 4] = U_6_z_5*t110
    J_out[..., 35, 5] = U_6_z_6*t110 - d_6_z*t112
    J_out[..., 35, 14] = 1
    J_out[..., 36, 0] = B_6_z*D_p_ry_1 + D_p_x_1 - U_6_x_1*t113 - t69
    J_out[..., 36, 1] = B_6_z*D_p_ry_2 + D_p_x_2 - U_6_x_2*t113 - t70
    J_out[..., 36, 2] = B_6_z*D_p_ry_3 + D_p_x_3 - U_6_x_3*t113 - t71
    J_out[..., 36, 3] = B_6_z*D_p_ry_4 + D_p_x_4 - U_6_x_4*t113 - t72
    J_out[..., 36, 4] = B_6_z*D_p_ry_5 + D_p_x_5 - U_6_x_5*t113 - t73
    J_out[..., 36, 5] = -U_6_x_6*t113 + U_6_x_6 + d_6_x*t114
    J_out[..., 36, 12] = 1
    J_out[..., 37, 0] = -U_6_y_1*t113 + U_6_y_1
    J_out[..., 37, 1] = -U_6_y_2*t113 + U_6_y_2
    J_out[..., 37, 2] = -U_6_y_3*t113 + U_6_y_3
    J_out[..., 37, 3] = -U_6_y_4*t113 + U_6_y_4
    J_out[..., 37, 4] = -U_6_y_5*t113 + U_6_y_5
    J_out[..., 37, 5] = -U_6_y_6*t113 + U_6_y_6 + d_6_y*t114
    J_out[..., 37, 13] = 1
    J_out[..., 38, 0] = B_6_y*D_p_rx_1 + D_p_z_1 - U_6_z_1*t113 - t74
    J_out[..., 38, 1] = B_6_y*D_p_rx_2 + D_p_z_2 - U_6_z_2*t113 - t75
    J_out[..., 38, 2] = B_6_y*D_p_rx_3 + D_p_z_3 - U_6_z_3*t113 - t76
    J_out[..., 38, 3] = B_6_y*D_p_rx_4 + D_p_z_4 - U_6_z_4*t113 - t77
    J_out[..., 38, 4] = B_6_y*D_p_rx_5 + D_p_z_5 - U_6_z_5*t113 - t78
    J_out[..., 38, 5] = -U_6_z_6*t113 + U_6_z_6 + d_6_z*t114
    J_out[..., 38, 14] = 1
    J_out[..., 39, 6] = 1
    J_out[..., 40, 7] = 1
    J_out[..., 41, 8] = 1
    J_out[..., 42, 9] = 1
    J_out[..., 43, 10] = 1
    J_out[..., 44, 11] = 1
    J_out[..., 45, 12] = 1
    J_out[..., 46, 13] = 1
    J_out[..., 47, 14] = 1
    J_out[..., 48, 0] = D_p_rx_1
    J_out[..., 48, 1] = D_p_rx_2
    J_out[..., 48, 2] = D_p_rx_3
    J_out[..., 48, 3] = D_p_rx_4
    J_out[..., 48, 4] = D_p_rx_5
    J_out[..., 48, 5] = D_p_rx_6
    J_out[..., 49, 0] = D_p_ry_1
    J_out[..., 49, 1] = D_p_ry_2
    J_out[..., 49, 2] = D_p_ry_3
    J_out[..., 49, 3] = D_p_ry_4
    J_out[..., 49, 4] = D_p_ry_5
    J_out[..., 49, 5] = D_p_ry_6
    J_out[..., 50, 0] = D_p_rz_1
    J_out[..., 50, 1] = D_p_rz_2
    J_out[..., 50, 2] = D_p_rz_3
    J_out[..., 50, 3] = D_p_rz_4
    J_out[..., 50, 4] = D_p_rz_5
    J_out[..., 50, 5] = D_p_rz_6
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
    M_wq : array, shape (..., 18, 15) [kg, kg m]
        Entries of M between each mount and every coordinate.
    M_ww : array, shape (..., 18) [kg, kg m]
        Diagonal entry of M of each mount.
    K_wq : array, shape (..., 18, 15) [N/m, N]
        Entries of K between each mount and every coordinate.
    K_ww : array, shape (..., 18) [N/m, N]
        Diagonal entry of K of each mount.
    J_p : array, shape (..., 18, 6) [1, 1/m]
        Motion of the platform per unit of each mount.

    Notes
    -----
    Equations 24 to 48 with these displacements released; without the springs of the mounts.
    10147 operations; 35285520852 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (m_p,) = _entries(parameters.platform_mass, ())
    c_p_x, c_p_y, c_p_z = _entries(parameters.platform_center, (3,))
    I_p_x, I_p_y, I_p_z = _entries(parameters.platform_inertia, (3,))
    I_p_xy, I_p_xz, I_p_yz = _entries(parameters.platform_products, (3,))
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    (
        a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z, a_4_x, a_4_y, a_4_z, a_5_x, a_5_y,
        a_5_z, a_6_x, a_6_y, a_6_z,
    ) = _entries(parameters.base, (6, 3))
    (
        b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z, b_4_x, b_4_y, b_4_z, b_5_x, b_5_y,
        b_5_z, b_6_x, b_6_y, b_6_z,
    ) = _entries(parameters.joint, (6, 3))
    m_b_1, m_b_2, m_b_3, m_b_4, m_b_5, m_b_6 = _entries(parameters.leg_base_mass, (6,))
    c_b_1, c_b_2, c_b_3, c_b_4, c_b_5, c_b_6 = _entries(parameters.leg_base_center, (6,))
    I_b_1, I_b_2, I_b_3, I_b_4, I_b_5, I_b_6 = _entries(parameters.leg_base_inertia, (6,))
    m_r_1, m_r_2, m_r_3, m_r_4, m_r_5, m_r_6 = _entries(parameters.leg_rod_mass, (6,))
    c_r_1, c_r_2, c_r_3, c_r_4, c_r_5, c_r_6 = _entries(parameters.leg_rod_center, (6,))
    I_r_1, I_r_2, I_r_3, I_r_4, I_r_5, I_r_6 = _entries(parameters.leg_rod_inertia, (6,))
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    (b_L_x,) = _entries(effects.payload_offset_x, ())
    (b_L_y,) = _entries(effects.payload_offset_y, ())
    (b_L_z,) = _entries(effects.payload_offset_z, ())
    batch, dtype = _batch(p_x, m_p, c_p_x, I_p_x, I_p_xy, g_x, a_1_x, b_1_x, m_b_1, c_b_1, I_b_1, m_r_1,
        c_r_1, I_r_1, k_C, m_L, b_L_x, b_L_y, b_L_z)
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
    d_1_x = B_1_x - a_1_x + p_x
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    d_1_y = B_1_y - a_1_y + p_y
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    d_1_z = B_1_z - a_1_z + p_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    d_2_x = B_2_x - a_2_x + p_x
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    d_2_y = B_2_y - a_2_y + p_y
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    d_2_z = B_2_z - a_2_z + p_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    d_3_x = B_3_x - a_3_x + p_x
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    d_3_y = B_3_y - a_3_y + p_y
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    d_3_z = B_3_z - a_3_z + p_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    d_4_x = B_4_x - a_4_x + p_x
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    d_4_y = B_4_y - a_4_y + p_y
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    d_4_z = B_4_z - a_4_z + p_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    d_5_x = B_5_x - a_5_x + p_x
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    d_5_y = B_5_y - a_5_y + p_y
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    d_5_z = B_5_z - a_5_z + p_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    d_6_x = B_6_x - a_6_x + p_x
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    d_6_y = B_6_y - a_6_y + p_y
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    d_6_z = B_6_z - a_6_z + p_z
    l_1 = np.sqrt(d_1_x**2 + d_1_y**2 + d_1_z**2)
    l_2 = np.sqrt(d_2_x**2 + d_2_y**2 + d_2_z**2)
    l_3 = np.sqrt(d_3_x**2 + d_3_y**2 + d_3_z**2)
    l_4 = np.sqrt(d_4_x**2 + d_4_y**2 + d_4_z**2)
    l_5 = np.sqrt(d_5_x**2 + d_5_y**2 + d_5_z**2)
    l_6 = np.sqrt(d_6_x**2 + d_6_y**2 + d_6_z**2)
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
    t30 = 1.0/(l_1**2)
    t31 = 1.0/l_1
    m_perp_1 = I_b_1*t30 + I_r_1*t30 + c_b_1**2*m_b_1*t30 + m_r_1*(-c_r_1*t31 + 1)**2
    t32 = c_b_1*m_b_1 - c_r_1*m_r_1
    t33 = t31*t32
    m_lift_1 = m_r_1 + t33
    t34 = 1.0/(l_2**2)
    t35 = 1.0/l_2
    m_perp_2 = I_b_2*t34 + I_r_2*t34 + c_b_2**2*m_b_2*t34 + m_r_2*(-c_r_2*t35 + 1)**2
    t36 = c_b_2*m_b_2 - c_r_2*m_r_2
    t37 = t35*t36
    m_lift_2 = m_r_2 + t37
    t38 = 1.0/(l_3**2)
    t39 = 1.0/l_3
    m_perp_3 = I_b_3*t38 + I_r_3*t38 + c_b_3**2*m_b_3*t38 + m_r_3*(-c_r_3*t39 + 1)**2
    t40 = c_b_3*m_b_3 - c_r_3*m_r_3
    t41 = t39*t40
    m_lift_3 = m_r_3 + t41
    t42 = 1.0/(l_4**2)
    t43 = 1.0/l_4
    m_perp_4 = I_b_4*t42 + I_r_4*t42 + c_b_4**2*m_b_4*t42 + m_r_4*(-c_r_4*t43 + 1)**2
    t44 = c_b_4*m_b_4 - c_r_4*m_r_4
    t45 = t43*t44
    m_lift_4 = m_r_4 + t45
    t46 = 1.0/(l_5**2)
    t47 = 1.0/l_5
    m_perp_5 = I_b_5*t46 + I_r_5*t46 + c_b_5**2*m_b_5*t46 + m_r_5*(-c_r_5*t47 + 1)**2
    t48 = c_b_5*m_b_5 - c_r_5*m_r_5
    t49 = t47*t48
    m_lift_5 = m_r_5 + t49
    t50 = 1.0/(l_6**2)
    t51 = 1.0/l_6
    m_perp_6 = I_b_6*t50 + I_r_6*t50 + c_b_6**2*m_b_6*t50 + m_r_6*(-c_r_6*t51 + 1)**2
    t52 = c_b_6*m_b_6 - c_r_6*m_r_6
    t53 = t51*t52
    m_lift_6 = m_r_6 + t53
    o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z
    o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z
    o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z
    D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y
    D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x
    D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x
    D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y
    D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x
    D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x
    D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y
    D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x
    D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x
    D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y
    D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x
    D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x
    D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y
    D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x
    D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x
    D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y
    D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x
    D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x
    minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y
    minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry
    minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx
    minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx
    minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45
    minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y
    minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z
    minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z
    minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56
    minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y
    minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z
    minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46
    minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y
    minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45
    minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z
    minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y
    minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y
    minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56
    minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z
    minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y
    minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46
    minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z
    minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45
    minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx
    minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y
    minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26
    minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx
    minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25
    minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry
    minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24
    A_x_1 = (
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234
    )
    minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x
    minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x
    minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x
    minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x
    minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x
    minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x
    minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56
    minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x
    minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46
    minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45
    minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x
    minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16
    minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15
    minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14
    A_y_1 = (
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134
    )
    minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x
    minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x
    minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16
    minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15
    minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14
    A_z_1 = (
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124
    )
    minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12
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
    minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y
    minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y
    minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y
    minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y
    minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z
    minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z
    minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z
    minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx
    minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx
    minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry
    A_x_2 = (
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234
    )
    minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x
    minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x
    minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x
    minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x
    A_y_2 = (
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134
    )
    minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x
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
    minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y
    minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y
    minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y
    minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y
    minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z
    minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z
    minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z
    minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx
    minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx
    minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry
    A_x_3 = (
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234
    )
    minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x
    minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x
    minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x
    minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x
    A_y_3 = (
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134
    )
    minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x
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
    minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24
    minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25
    minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26
    minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45
    minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46
    minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56
    minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45
    minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46
    minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56
    minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45
    A_x_4 = (
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23
    )
    minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14
    minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15
    minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16
    minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45
    minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46
    minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56
    A_y_4 = (
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13
    )
    minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14
    minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15
    minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16
    A_z_4 = (
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12
    )
    minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12
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
    minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z
    minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z
    minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z
    minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y
    minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y
    minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y
    minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y
    A_x_5 = (
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23
    )
    minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x
    minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x
    minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x
    minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x
    A_y_5 = (
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13
    )
    minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x
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
    minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z
    minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z
    minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z
    minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y
    minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y
    minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y
    minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y
    A_x_6 = (
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23
    )
    minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x
    minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x
    minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x
    minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x
    A_y_6 = (
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13
    )
    minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x
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
    t54 = A_x_1*d_1_x
    t55 = A_y_1*d_1_y
    t56 = A_z_1*d_1_z
    det_D_l = A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + t54 + t55 + t56
    t57 = 1.0/det_D_l
    t58 = A_x_1*t57
    D_p_x_1 = l_1*t58
    t59 = A_x_2*t57
    D_p_x_2 = l_2*t59
    t60 = A_x_3*t57
    D_p_x_3 = l_3*t60
    t61 = A_x_4*t57
    D_p_x_4 = l_4*t61
    t62 = A_x_5*t57
    D_p_x_5 = l_5*t62
    t63 = A_x_6*t57
    D_p_x_6 = l_6*t63
    D_delta_x_1 = t54*t57
    D_delta_x_2 = d_1_y*t58
    D_delta_x_3 = d_1_z*t58
    D_delta_x_4 = d_2_x*t59
    D_delta_x_5 = d_2_y*t59
    D_delta_x_6 = d_2_z*t59
    D_delta_x_7 = d_3_x*t60
    D_delta_x_8 = d_3_y*t60
    D_delta_x_9 = d_3_z*t60
    D_delta_x_10 = d_4_x*t61
    D_delta_x_11 = d_4_y*t61
    D_delta_x_12 = d_4_z*t61
    D_delta_x_13 = d_5_x*t62
    D_delta_x_14 = d_5_y*t62
    D_delta_x_15 = d_5_z*t62
    D_delta_x_16 = d_6_x*t63
    D_delta_x_17 = d_6_y*t63
    D_delta_x_18 = d_6_z*t63
    t64 = A_y_1*t57
    D_p_y_1 = l_1*t64
    t65 = A_y_2*t57
    D_p_y_2 = l_2*t65
    t66 = A_y_3*t57
    D_p_y_3 = l_3*t66
    t67 = A_y_4*t57
    D_p_y_4 = l_4*t67
    t68 = A_y_5*t57
    D_p_y_5 = l_5*t68
    t69 = A_y_6*t57
    D_p_y_6 = l_6*t69
    D_delta_y_1 = d_1_x*t64
    D_delta_y_2 = t55*t57
    D_delta_y_3 = d_1_z*t64
    D_delta_y_4 = d_2_x*t65
    D_delta_y_5 = d_2_y*t65
    D_delta_y_6 = d_2_z*t65
    D_delta_y_7 = d_3_x*t66
    D_delta_y_8 = d_3_y*t66
    D_delta_y_9 = d_3_z*t66
    D_delta_y_10 = d_4_x*t67
    D_delta_y_11 = d_4_y*t67
    D_delta_y_12 = d_4_z*t67
    D_delta_y_13 = d_5_x*t68
    D_delta_y_14 = d_5_y*t68
    D_delta_y_15 = d_5_z*t68
    D_delta_y_16 = d_6_x*t69
    D_delta_y_17 = d_6_y*t69
    D_delta_y_18 = d_6_z*t69
    t70 = A_z_1*t57
    D_p_z_1 = l_1*t70
    t71 = A_z_2*t57
    D_p_z_2 = l_2*t71
    t72 = A_z_3*t57
    D_p_z_3 = l_3*t72
    t73 = A_z_4*t57
    D_p_z_4 = l_4*t73
    t74 = A_z_5*t57
    D_p_z_5 = l_5*t74
    t75 = A_z_6*t57
    D_p_z_6 = l_6*t75
    D_delta_z_1 = d_1_x*t70
    D_delta_z_2 = d_1_y*t70
    D_delta_z_3 = t56*t57
    D_delta_z_4 = d_2_x*t71
    D_delta_z_5 = d_2_y*t71
    D_delta_z_6 = d_2_z*t71
    D_delta_z_7 = d_3_x*t72
    D_delta_z_8 = d_3_y*t72
    D_delta_z_9 = d_3_z*t72
    D_delta_z_10 = d_4_x*t73
    D_delta_z_11 = d_4_y*t73
    D_delta_z_12 = d_4_z*t73
    D_delta_z_13 = d_5_x*t74
    D_delta_z_14 = d_5_y*t74
    D_delta_z_15 = d_5_z*t74
    D_delta_z_16 = d_6_x*t75
    D_delta_z_17 = d_6_y*t75
    D_delta_z_18 = d_6_z*t75
    t76 = A_rx_1*t57
    D_p_rx_1 = l_1*t76
    t77 = A_rx_2*t57
    D_p_rx_2 = l_2*t77
    t78 = A_rx_3*t57
    D_p_rx_3 = l_3*t78
    t79 = A_rx_4*t57
    D_p_rx_4 = l_4*t79
    t80 = A_rx_5*t57
    D_p_rx_5 = l_5*t80
    t81 = A_rx_6*t57
    D_p_rx_6 = l_6*t81
    D_delta_rx_1 = d_1_x*t76
    D_delta_rx_2 = d_1_y*t76
    D_delta_rx_3 = d_1_z*t76
    D_delta_rx_4 = d_2_x*t77
    D_delta_rx_5 = d_2_y*t77
    D_delta_rx_6 = d_2_z*t77
    D_delta_rx_7 = d_3_x*t78
    D_delta_rx_8 = d_3_y*t78
    D_delta_rx_9 = d_3_z*t78
    D_delta_rx_10 = d_4_x*t79
    D_delta_rx_11 = d_4_y*t79
    D_delta_rx_12 = d_4_z*t79
    D_delta_rx_13 = d_5_x*t80
    D_delta_rx_14 = d_5_y*t80
    D_delta_rx_15 = d_5_z*t80
    D_delta_rx_16 = d_6_x*t81
    D_delta_rx_17 = d_6_y*t81
    D_delta_rx_18 = d_6_z*t81
    t82 = A_ry_1*t57
    D_p_ry_1 = l_1*t82
    t83 = A_ry_2*t57
    D_p_ry_2 = l_2*t83
    t84 = A_ry_3*t57
    D_p_ry_3 = l_3*t84
    t85 = A_ry_4*t57
    D_p_ry_4 = l_4*t85
    t86 = A_ry_5*t57
    D_p_ry_5 = l_5*t86
    t87 = A_ry_6*t57
    D_p_ry_6 = l_6*t87
    D_delta_ry_1 = d_1_x*t82
    D_delta_ry_2 = d_1_y*t82
    D_delta_ry_3 = d_1_z*t82
    D_delta_ry_4 = d_2_x*t83
    D_delta_ry_5 = d_2_y*t83
    D_delta_ry_6 = d_2_z*t83
    D_delta_ry_7 = d_3_x*t84
    D_delta_ry_8 = d_3_y*t84
    D_delta_ry_9 = d_3_z*t84
    D_delta_ry_10 = d_4_x*t85
    D_delta_ry_11 = d_4_y*t85
    D_delta_ry_12 = d_4_z*t85
    D_delta_ry_13 = d_5_x*t86
    D_delta_ry_14 = d_5_y*t86
    D_delta_ry_15 = d_5_z*t86
    D_delta_ry_16 = d_6_x*t87
    D_delta_ry_17 = d_6_y*t87
    D_delta_ry_18 = d_6_z*t87
    t88 = A_rz_1*t57
    D_p_rz_1 = l_1*t88
    t89 = A_rz_2*t57
    D_p_rz_2 = l_2*t89
    t90 = A_rz_3*t57
    D_p_rz_3 = l_3*t90
    t91 = A_rz_4*t57
    D_p_rz_4 = l_4*t91
    t92 = A_rz_5*t57
    D_p_rz_5 = l_5*t92
    t93 = A_rz_6*t57
    D_p_rz_6 = l_6*t93
    D_delta_rz_1 = d_1_x*t88
    D_delta_rz_2 = d_1_y*t88
    D_delta_rz_3 = d_1_z*t88
    D_delta_rz_4 = d_2_x*t89
    D_delta_rz_5 = d_2_y*t89
    D_delta_rz_6 = d_2_z*t89
    D_delta_rz_7 = d_3_x*t90
    D_delta_rz_8 = d_3_y*t90
    D_delta_rz_9 = d_3_z*t90
    D_delta_rz_10 = d_4_x*t91
    D_delta_rz_11 = d_4_y*t91
    D_delta_rz_12 = d_4_z*t91
    D_delta_rz_13 = d_5_x*t92
    D_delta_rz_14 = d_5_y*t92
    D_delta_rz_15 = d_5_z*t92
    D_delta_rz_16 = d_6_x*t93
    D_delta_rz_17 = d_6_y*t93
    D_delta_rz_18 = d_6_z*t93
    t94 = g_x*m_lift_2
    t95 = g_x*m_lift_3
    t96 = g_x*m_lift_4
    t97 = g_x*m_lift_5
    t98 = g_x*m_lift_6
    t99 = m_L + m_p
    t100 = g_x*m_lift_1
    G_p_x = -g_x*t99 - t100 - t94 - t95 - t96 - t97 - t98
    t101 = g_y*m_lift_1
    t102 = g_y*m_lift_2
    t103 = g_y*m_lift_3
    t104 = g_y*m_lift_4
    t105 = g_y*m_lift_5
    t106 = g_y*m_lift_6
    G_p_y = -g_y*t99 - t101 - t102 - t103 - t104 - t105 - t106
    t107 = g_z*m_lift_1
    t108 = g_z*m_lift_2
    t109 = g_z*m_lift_3
    t110 = g_z*m_lift_4
    t111 = g_z*m_lift_5
    t112 = g_z*m_lift_6
    G_p_z = -g_z*t99 - t107 - t108 - t109 - t110 - t111 - t112
    t113 = g_z*m_p
    t114 = g_z*m_L
    G_p_rx = (
        -B_1_y*t107 + B_1_z*g_y*m_lift_1 - B_2_y*t108 + B_2_z*g_y*m_lift_2 - B_3_y*t109 + B_3_z*g_y*m_lift_3
        - B_4_y*t110 + B_4_z*g_y*m_lift_4 - B_5_y*t111 + B_5_z*g_y*m_lift_5 - B_6_y*t112 + B_6_z*g_y*m_lift_6
        - c_y*t113 + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t114
    )
    t115 = g_x*m_p
    t116 = g_x*m_L
    G_p_ry = (
        B_1_x*t107 - B_1_z*t100 + B_2_x*t108 - B_2_z*t94 + B_3_x*t109 - B_3_z*t95 + B_4_x*t110 - B_4_z*t96
        + B_5_x*t111 - B_5_z*t97 + B_6_x*t112 - B_6_z*t98 + c_x*t113 - c_z*t115 + o_L_x*t114 - o_L_z*t116
    )
    t117 = g_y*m_p
    t118 = g_y*m_L
    G_p_rz = (
        -B_1_x*t101 + B_1_y*g_x*m_lift_1 - B_2_x*t102 + B_2_y*g_x*m_lift_2 - B_3_x*t103 + B_3_y*g_x*m_lift_3
        - B_4_x*t104 + B_4_y*g_x*m_lift_4 - B_5_x*t105 + B_5_y*g_x*m_lift_5 - B_6_x*t106 + B_6_y*g_x*m_lift_6
        - c_x*t117 + c_y*g_x*m_p + g_x*m_L*o_L_y - o_L_x*t118
    )
    mu_1 = t57*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z)
    mu_2 = t57*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z)
    mu_3 = t57*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z)
    mu_4 = t57*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z)
    mu_5 = t57*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z)
    mu_6 = t57*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z)
    g_4_x = -d_1_x*mu_1 - t100
    g_4_y = -d_1_y*mu_1 - t101
    g_4_z = -d_1_z*mu_1 - t107
    g_5_x = -d_2_x*mu_2 - t94
    g_5_y = -d_2_y*mu_2 - t102
    g_5_z = -d_2_z*mu_2 - t108
    g_6_x = -d_3_x*mu_3 - t95
    g_6_y = -d_3_y*mu_3 - t103
    g_6_z = -d_3_z*mu_3 - t109
    g_7_x = -d_4_x*mu_4 - t96
    g_7_y = -d_4_y*mu_4 - t104
    g_7_z = -d_4_z*mu_4 - t110
    g_8_x = -d_5_x*mu_5 - t97
    g_8_y = -d_5_y*mu_5 - t105
    g_8_z = -d_5_z*mu_5 - t111
    g_9_x = -d_6_x*mu_6 - t98
    g_9_y = -d_6_y*mu_6 - t106
    g_9_z = -d_6_z*mu_6 - t112
    g_10_x = -t115
    g_10_y = -t117
    g_10_z = -t113
    g_11_x = -t116
    g_11_y = -t118
    g_11_z = -t114
    L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6
    t119 = B_1_z*mu_1
    t120 = B_2_z*mu_2
    t121 = B_3_z*mu_3
    t122 = B_4_z*mu_4
    t123 = B_5_z*mu_5
    t124 = B_6_z*mu_6
    L_y_rx = t119 + t120 + t121 + t122 + t123 + t124
    L_x_ry = -L_y_rx
    t125 = B_1_y*mu_1
    t126 = B_2_y*mu_2
    t127 = B_3_y*mu_3
    t128 = B_4_y*mu_4
    t129 = B_5_y*mu_5
    t130 = B_6_y*mu_6
    L_x_rz = t125 + t126 + t127 + t128 + t129 + t130
    t131 = B_1_x*mu_1
    t132 = B_2_x*mu_2
    t133 = B_3_x*mu_3
    t134 = B_4_x*mu_4
    t135 = B_5_x*mu_5
    t136 = B_6_x*mu_6
    L_z_ry = t131 + t132 + t133 + t134 + t135 + t136
    L_y_rz = -L_z_ry
    L_z_rx = -L_x_rz
    t137 = B_1_z**2
    t138 = B_2_z**2
    t139 = B_3_z**2
    t140 = B_4_z**2
    t141 = B_5_z**2
    t142 = B_6_z**2
    t143 = (
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + g_11_z*o_L_z + mu_1*t137 + mu_2*t138 + mu_3*t139 + mu_4*t140 + mu_5*t141 + mu_6*t142
    )
    t144 = B_1_y**2
    t145 = B_2_y**2
    t146 = B_3_y**2
    t147 = B_4_y**2
    t148 = B_5_y**2
    t149 = B_6_y**2
    t150 = (
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + g_11_y*o_L_y + mu_1*t144 + mu_2*t145 + mu_3*t146 + mu_4*t147 + mu_5*t148 + mu_6*t149
    )
    L_rx_rx = -t143 - t150
    t151 = (1/2)*B_1_x
    t152 = (1/2)*g_4_x
    t153 = (1/2)*B_2_x
    t154 = (1/2)*g_5_x
    t155 = (1/2)*B_3_x
    t156 = (1/2)*g_6_x
    t157 = (1/2)*B_4_x
    t158 = (1/2)*g_7_x
    t159 = (1/2)*B_5_x
    t160 = (1/2)*g_8_x
    t161 = (1/2)*B_6_x
    t162 = (1/2)*g_9_x
    t163 = (1/2)*c_x
    t164 = (1/2)*g_10_x
    t165 = (1/2)*g_11_x
    t166 = (1/2)*o_L_x
    L_rx_ry = (
        B_1_x*t125 + B_1_y*t152 + B_2_x*t126 + B_2_y*t154 + B_3_x*t127 + B_3_y*t156 + B_4_x*t128 + B_4_y*t158
        + B_5_x*t129 + B_5_y*t160 + B_6_x*t130 + B_6_y*t162 + c_y*t164 + g_10_y*t163 + g_11_y*t166
        + g_4_y*t151 + g_5_y*t153 + g_6_y*t155 + g_7_y*t157 + g_8_y*t159 + g_9_y*t161 + o_L_y*t165
    )
    L_rx_rz = (
        B_1_x*t119 + B_1_z*t152 + B_2_x*t120 + B_2_z*t154 + B_3_x*t121 + B_3_z*t156 + B_4_x*t122 + B_4_z*t158
        + B_5_x*t123 + B_5_z*t160 + B_6_x*t124 + B_6_z*t162 + c_z*t164 + g_10_z*t163 + g_11_z*t166
        + g_4_z*t151 + g_5_z*t153 + g_6_z*t155 + g_7_z*t157 + g_8_z*t159 + g_9_z*t161 + o_L_z*t165
    )
    t167 = B_1_x**2
    t168 = B_2_x**2
    t169 = B_3_x**2
    t170 = B_4_x**2
    t171 = B_5_x**2
    t172 = B_6_x**2
    t173 = (
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + g_11_x*o_L_x + mu_1*t167 + mu_2*t168 + mu_3*t169 + mu_4*t170 + mu_5*t171 + mu_6*t172
    )
    L_ry_ry = -t143 - t173
    L_ry_rz = (
        (1/2)*B_1_y*g_4_z + B_1_y*t119 + (1/2)*B_1_z*g_4_y + (1/2)*B_2_y*g_5_z + B_2_y*t120
        + (1/2)*B_2_z*g_5_y + (1/2)*B_3_y*g_6_z + B_3_y*t121 + (1/2)*B_3_z*g_6_y + (1/2)*B_4_y*g_7_z
        + B_4_y*t122 + (1/2)*B_4_z*g_7_y + (1/2)*B_5_y*g_8_z + B_5_y*t123 + (1/2)*B_5_z*g_8_y
        + (1/2)*B_6_y*g_9_z + B_6_y*t124 + (1/2)*B_6_z*g_9_y + (1/2)*c_y*g_10_z + (1/2)*c_z*g_10_y
        + (1/2)*g_11_y*o_L_z + (1/2)*g_11_z*o_L_y
    )
    L_rz_rz = -t150 - t173
    f_x_w_leg_1x = D_delta_ry_1*L_x_ry + D_delta_rz_1*L_x_rz + D_delta_x_1*L_x_x + mu_1
    f_x_w_leg_1y = D_delta_ry_2*L_x_ry + D_delta_rz_2*L_x_rz + D_delta_x_2*L_x_x
    f_x_w_leg_1z = D_delta_ry_3*L_x_ry + D_delta_rz_3*L_x_rz + D_delta_x_3*L_x_x
    f_x_w_leg_2x = D_delta_ry_4*L_x_ry + D_delta_rz_4*L_x_rz + D_delta_x_4*L_x_x + mu_2
    f_x_w_leg_2y = D_delta_ry_5*L_x_ry + D_delta_rz_5*L_x_rz + D_delta_x_5*L_x_x
    f_x_w_leg_2z = D_delta_ry_6*L_x_ry + D_delta_rz_6*L_x_rz + D_delta_x_6*L_x_x
    f_x_w_leg_3x = D_delta_ry_7*L_x_ry + D_delta_rz_7*L_x_rz + D_delta_x_7*L_x_x + mu_3
    f_x_w_leg_3y = D_delta_ry_8*L_x_ry + D_delta_rz_8*L_x_rz + D_delta_x_8*L_x_x
    f_x_w_leg_3z = D_delta_ry_9*L_x_ry + D_delta_rz_9*L_x_rz + D_delta_x_9*L_x_x
    f_x_w_leg_4x = D_delta_ry_10*L_x_ry + D_delta_rz_10*L_x_rz + D_delta_x_10*L_x_x + mu_4
    f_x_w_leg_4y = D_delta_ry_11*L_x_ry + D_delta_rz_11*L_x_rz + D_delta_x_11*L_x_x
    f_x_w_leg_4z = D_delta_ry_12*L_x_ry + D_delta_rz_12*L_x_rz + D_delta_x_12*L_x_x
    f_x_w_leg_5x = D_delta_ry_13*L_x_ry + D_delta_rz_13*L_x_rz + D_delta_x_13*L_x_x + mu_5
    f_x_w_leg_5y = D_delta_ry_14*L_x_ry + D_delta_rz_14*L_x_rz + D_delta_x_14*L_x_x
    f_x_w_leg_5z = D_delta_ry_15*L_x_ry + D_delta_rz_15*L_x_rz + D_delta_x_15*L_x_x
    f_x_w_leg_6x = D_delta_ry_16*L_x_ry + D_delta_rz_16*L_x_rz + D_delta_x_16*L_x_x + mu_6
    f_x_w_leg_6y = D_delta_ry_17*L_x_ry + D_delta_rz_17*L_x_rz + D_delta_x_17*L_x_x
    f_x_w_leg_6z = D_delta_ry_18*L_x_ry + D_delta_rz_18*L_x_rz + D_delta_x_18*L_x_x
    f_y_w_leg_1x = D_delta_rx_1*L_y_rx + D_delta_rz_1*L_y_rz + D_delta_y_1*L_x_x
    f_y_w_leg_1y = D_delta_rx_2*L_y_rx + D_delta_rz_2*L_y_rz + D_delta_y_2*L_x_x + mu_1
    f_y_w_leg_1z = D_delta_rx_3*L_y_rx + D_delta_rz_3*L_y_rz + D_delta_y_3*L_x_x
    f_y_w_leg_2x = D_delta_rx_4*L_y_rx + D_delta_rz_4*L_y_rz + D_delta_y_4*L_x_x
    f_y_w_leg_2y = D_delta_rx_5*L_y_rx + D_delta_rz_5*L_y_rz + D_delta_y_5*L_x_x + mu_2
    f_y_w_leg_2z = D_delta_rx_6*L_y_rx + D_delta_rz_6*L_y_rz + D_delta_y_6*L_x_x
    f_y_w_leg_3x = D_delta_rx_7*L_y_rx + D_delta_rz_7*L_y_rz + D_delta_y_7*L_x_x
    f_y_w_leg_3y = D_delta_rx_8*L_y_rx + D_delta_rz_8*L_y_rz + D_delta_y_8*L_x_x + mu_3
    f_y_w_leg_3z = D_delta_rx_9*L_y_rx + D_delta_rz_9*L_y_rz + D_delta_y_9*L_x_x
    f_y_w_leg_4x = D_delta_rx_10*L_y_rx + D_delta_rz_10*L_y_rz + D_delta_y_10*L_x_x
    f_y_w_leg_4y = D_delta_rx_11*L_y_rx + D_delta_rz_11*L_y_rz + D_delta_y_11*L_x_x + mu_4
    f_y_w_leg_4z = D_delta_rx_12*L_y_rx + D_delta_rz_12*L_y_rz + D_delta_y_12*L_x_x
    f_y_w_leg_5x = D_delta_rx_13*L_y_rx + D_delta_rz_13*L_y_rz + D_delta_y_13*L_x_x
    f_y_w_leg_5y = D_delta_rx_14*L_y_rx + D_delta_rz_14*L_y_rz + D_delta_y_14*L_x_x + mu_5
    f_y_w_leg_5z = D_delta_rx_15*L_y_rx + D_delta_rz_15*L_y_rz + D_delta_y_15*L_x_x
    f_y_w_leg_6x = D_delta_rx_16*L_y_rx + D_delta_rz_16*L_y_rz + D_delta_y_16*L_x_x
    f_y_w_leg_6y = D_delta_rx_17*L_y_rx + D_delta_rz_17*L_y_rz + D_delta_y_17*L_x_x + mu_6
    f_y_w_leg_6z = D_delta_rx_18*L_y_rx + D_delta_rz_18*L_y_rz + D_delta_y_18*L_x_x
    f_z_w_leg_1x = D_delta_rx_1*L_z_rx + D_delta_ry_1*L_z_ry + D_delta_z_1*L_x_x
    f_z_w_leg_1y = D_delta_rx_2*L_z_rx + D_delta_ry_2*L_z_ry + D_delta_z_2*L_x_x
    f_z_w_leg_1z = D_delta_rx_3*L_z_rx + D_delta_ry_3*L_z_ry + D_delta_z_3*L_x_x + mu_1
    f_z_w_leg_2x = D_delta_rx_4*L_z_rx + D_delta_ry_4*L_z_ry + D_delta_z_4*L_x_x
    f_z_w_leg_2y = D_delta_rx_5*L_z_rx + D_delta_ry_5*L_z_ry + D_delta_z_5*L_x_x
    f_z_w_leg_2z = D_delta_rx_6*L_z_rx + D_delta_ry_6*L_z_ry + D_delta_z_6*L_x_x + mu_2
    f_z_w_leg_3x = D_delta_rx_7*L_z_rx + D_delta_ry_7*L_z_ry + D_delta_z_7*L_x_x
    f_z_w_leg_3y = D_delta_rx_8*L_z_rx + D_delta_ry_8*L_z_ry + D_delta_z_8*L_x_x
    f_z_w_leg_3z = D_delta_rx_9*L_z_rx + D_delta_ry_9*L_z_ry + D_delta_z_9*L_x_x + mu_3
    f_z_w_leg_4x = D_delta_rx_10*L_z_rx + D_delta_ry_10*L_z_ry + D_delta_z_10*L_x_x
    f_z_w_leg_4y = D_delta_rx_11*L_z_rx + D_delta_ry_11*L_z_ry + D_delta_z_11*L_x_x
    f_z_w_leg_4z = D_delta_rx_12*L_z_rx + D_delta_ry_12*L_z_ry + D_delta_z_12*L_x_x + mu_4
    f_z_w_leg_5x = D_delta_rx_13*L_z_rx + D_delta_ry_13*L_z_ry + D_delta_z_13*L_x_x
    f_z_w_leg_5y = D_delta_rx_14*L_z_rx + D_delta_ry_14*L_z_ry + D_delta_z_14*L_x_x
    f_z_w_leg_5z = D_delta_rx_15*L_z_rx + D_delta_ry_15*L_z_ry + D_delta_z_15*L_x_x + mu_5
    f_z_w_leg_6x = D_delta_rx_16*L_z_rx + D_delta_ry_16*L_z_ry + D_delta_z_16*L_x_x
    f_z_w_leg_6y = D_delta_rx_17*L_z_rx + D_delta_ry_17*L_z_ry + D_delta_z_17*L_x_x
    f_z_w_leg_6z = D_delta_rx_18*L_z_rx + D_delta_ry_18*L_z_ry + D_delta_z_18*L_x_x + mu_6
    f_rx_w_leg_1x = (
        D_delta_rx_1*L_rx_rx + D_delta_ry_1*L_rx_ry + D_delta_rz_1*L_rx_rz + D_delta_y_1*L_y_rx
        + D_delta_z_1*L_z_rx
    )
    f_rx_w_leg_1y = (
        D_delta_rx_2*L_rx_rx + D_delta_ry_2*L_rx_ry + D_delta_rz_2*L_rx_rz + D_delta_y_2*L_y_rx
        + D_delta_z_2*L_z_rx - t119
    )
    f_rx_w_leg_1z = (
        D_delta_rx_3*L_rx_rx + D_delta_ry_3*L_rx_ry + D_delta_rz_3*L_rx_rz + D_delta_y_3*L_y_rx
        + D_delta_z_3*L_z_rx + t125
    )
    f_rx_w_leg_2x = (
        D_delta_rx_4*L_rx_rx + D_delta_ry_4*L_rx_ry + D_delta_rz_4*L_rx_rz + D_delta_y_4*L_y_rx
        + D_delta_z_4*L_z_rx
    )
    f_rx_w_leg_2y = (
        D_delta_rx_5*L_rx_rx + D_delta_ry_5*L_rx_ry + D_delta_rz_5*L_rx_rz + D_delta_y_5*L_y_rx
        + D_delta_z_5*L_z_rx - t120
    )
    f_rx_w_leg_2z = (
        D_delta_rx_6*L_rx_rx + D_delta_ry_6*L_rx_ry + D_delta_rz_6*L_rx_rz + D_delta_y_6*L_y_rx
        + D_delta_z_6*L_z_rx + t126
    )
    f_rx_w_leg_3x = (
        D_delta_rx_7*L_rx_rx + D_delta_ry_7*L_rx_ry + D_delta_rz_7*L_rx_rz + D_delta_y_7*L_y_rx
        + D_delta_z_7*L_z_rx
    )
    f_rx_w_leg_3y = (
        D_delta_rx_8*L_rx_rx + D_delta_ry_8*L_rx_ry + D_delta_rz_8*L_rx_rz + D_delta_y_8*L_y_rx
        + D_delta_z_8*L_z_rx - t121
    )
    f_rx_w_leg_3z = (
        D_delta_rx_9*L_rx_rx + D_delta_ry_9*L_rx_ry + D_delta_rz_9*L_rx_rz + D_delta_y_9*L_y_rx
        + D_delta_z_9*L_z_rx + t127
    )
    f_rx_w_leg_4x = (
        D_delta_rx_10*L_rx_rx + D_delta_ry_10*L_rx_ry + D_delta_rz_10*L_rx_rz + D_delta_y_10*L_y_rx
        + D_delta_z_10*L_z_rx
    )
    f_rx_w_leg_4y = (
        D_delta_rx_11*L_rx_rx + D_delta_ry_11*L_rx_ry + D_delta_rz_11*L_rx_rz + D_delta_y_11*L_y_rx
        + D_delta_z_11*L_z_rx - t122
    )
    f_rx_w_leg_4z = (
        D_delta_rx_12*L_rx_rx + D_delta_ry_12*L_rx_ry + D_delta_rz_12*L_rx_rz + D_delta_y_12*L_y_rx
        + D_delta_z_12*L_z_rx + t128
    )
    f_rx_w_leg_5x = (
        D_delta_rx_13*L_rx_rx + D_delta_ry_13*L_rx_ry + D_delta_rz_13*L_rx_rz + D_delta_y_13*L_y_rx
        + D_delta_z_13*L_z_rx
    )
    f_rx_w_leg_5y = (
        D_delta_rx_14*L_rx_rx + D_delta_ry_14*L_rx_ry + D_delta_rz_14*L_rx_rz + D_delta_y_14*L_y_rx
        + D_delta_z_14*L_z_rx - t123
    )
    f_rx_w_leg_5z = (
        D_delta_rx_15*L_rx_rx + D_delta_ry_15*L_rx_ry + D_delta_rz_15*L_rx_rz + D_delta_y_15*L_y_rx
        + D_delta_z_15*L_z_rx + t129
    )
    f_rx_w_leg_6x = (
        D_delta_rx_16*L_rx_rx + D_delta_ry_16*L_rx_ry + D_delta_rz_16*L_rx_rz + D_delta_y_16*L_y_rx
        + D_delta_z_16*L_z_rx
    )
    f_rx_w_leg_6y = (
        D_delta_rx_17*L_rx_rx + D_delta_ry_17*L_rx_ry + D_delta_rz_17*L_rx_rz + D_delta_y_17*L_y_rx
        + D_delta_z_17*L_z_rx - t124
    )
    f_rx_w_leg_6z = (
        D_delta_rx_18*L_rx_rx + D_delta_ry_18*L_rx_ry + D_delta_rz_18*L_rx_rz + D_delta_y_18*L_y_rx
        + D_delta_z_18*L_z_rx + t130
    )
    f_ry_w_leg_1x = (
        D_delta_rx_1*L_rx_ry + D_delta_ry_1*L_ry_ry + D_delta_rz_1*L_ry_rz + D_delta_x_1*L_x_ry
        + D_delta_z_1*L_z_ry + t119
    )
    f_ry_w_leg_1y = (
        D_delta_rx_2*L_rx_ry + D_delta_ry_2*L_ry_ry + D_delta_rz_2*L_ry_rz + D_delta_x_2*L_x_ry
        + D_delta_z_2*L_z_ry
    )
    f_ry_w_leg_1z = (
        D_delta_rx_3*L_rx_ry + D_delta_ry_3*L_ry_ry + D_delta_rz_3*L_ry_rz + D_delta_x_3*L_x_ry
        + D_delta_z_3*L_z_ry - t131
    )
    f_ry_w_leg_2x = (
        D_delta_rx_4*L_rx_ry + D_delta_ry_4*L_ry_ry + D_delta_rz_4*L_ry_rz + D_delta_x_4*L_x_ry
        + D_delta_z_4*L_z_ry + t120
    )
    f_ry_w_leg_2y = (
        D_delta_rx_5*L_rx_ry + D_delta_ry_5*L_ry_ry + D_delta_rz_5*L_ry_rz + D_delta_x_5*L_x_ry
        + D_delta_z_5*L_z_ry
    )
    f_ry_w_leg_2z = (
        D_delta_rx_6*L_rx_ry + D_delta_ry_6*L_ry_ry + D_delta_rz_6*L_ry_rz + D_delta_x_6*L_x_ry
        + D_delta_z_6*L_z_ry - t132
    )
    f_ry_w_leg_3x = (
        D_delta_rx_7*L_rx_ry + D_delta_ry_7*L_ry_ry + D_delta_rz_7*L_ry_rz + D_delta_x_7*L_x_ry
        + D_delta_z_7*L_z_ry + t121
    )
    f_ry_w_leg_3y = (
        D_delta_rx_8*L_rx_ry + D_delta_ry_8*L_ry_ry + D_delta_rz_8*L_ry_rz + D_delta_x_8*L_x_ry
        + D_delta_z_8*L_z_ry
    )
    f_ry_w_leg_3z = (
        D_delta_rx_9*L_rx_ry + D_delta_ry_9*L_ry_ry + D_delta_rz_9*L_ry_rz + D_delta_x_9*L_x_ry
        + D_delta_z_9*L_z_ry - t133
    )
    f_ry_w_leg_4x = (
        D_delta_rx_10*L_rx_ry + D_delta_ry_10*L_ry_ry + D_delta_rz_10*L_ry_rz + D_delta_x_10*L_x_ry
        + D_delta_z_10*L_z_ry + t122
    )
    f_ry_w_leg_4y = (
        D_delta_rx_11*L_rx_ry + D_delta_ry_11*L_ry_ry + D_delta_rz_11*L_ry_rz + D_delta_x_11*L_x_ry
        + D_delta_z_11*L_z_ry
    )
    f_ry_w_leg_4z = (
        D_delta_rx_12*L_rx_ry + D_delta_ry_12*L_ry_ry + D_delta_rz_12*L_ry_rz + D_delta_x_12*L_x_ry
        + D_delta_z_12*L_z_ry - t134
    )
    f_ry_w_leg_5x = (
        D_delta_rx_13*L_rx_ry + D_delta_ry_13*L_ry_ry + D_delta_rz_13*L_ry_rz + D_delta_x_13*L_x_ry
        + D_delta_z_13*L_z_ry + t123
    )
    f_ry_w_leg_5y = (
        D_delta_rx_14*L_rx_ry + D_delta_ry_14*L_ry_ry + D_delta_rz_14*L_ry_rz + D_delta_x_14*L_x_ry
        + D_delta_z_14*L_z_ry
    )
    f_ry_w_leg_5z = (
        D_delta_rx_15*L_rx_ry + D_delta_ry_15*L_ry_ry + D_delta_rz_15*L_ry_rz + D_delta_x_15*L_x_ry
        + D_delta_z_15*L_z_ry - t135
    )
    f_ry_w_leg_6x = (
        D_delta_rx_16*L_rx_ry + D_delta_ry_16*L_ry_ry + D_delta_rz_16*L_ry_rz + D_delta_x_16*L_x_ry
        + D_delta_z_16*L_z_ry + t124
    )
    f_ry_w_leg_6y = (
        D_delta_rx_17*L_rx_ry + D_delta_ry_17*L_ry_ry + D_delta_rz_17*L_ry_rz + D_delta_x_17*L_x_ry
        + D_delta_z_17*L_z_ry
    )
    f_ry_w_leg_6z = (
        D_delta_rx_18*L_rx_ry + D_delta_ry_18*L_ry_ry + D_delta_rz_18*L_ry_rz + D_delta_x_18*L_x_ry
        + D_delta_z_18*L_z_ry - t136
    )
    f_rz_w_leg_1x = (
        D_delta_rx_1*L_rx_rz + D_delta_ry_1*L_ry_rz + D_delta_rz_1*L_rz_rz + D_delta_x_1*L_x_rz
        + D_delta_y_1*L_y_rz - t125
    )
    f_rz_w_leg_1y = (
        D_delta_rx_2*L_rx_rz + D_delta_ry_2*L_ry_rz + D_delta_rz_2*L_rz_rz + D_delta_x_2*L_x_rz
        + D_delta_y_2*L_y_rz + t131
    )
    f_rz_w_leg_1z = (
        D_delta_rx_3*L_rx_rz + D_delta_ry_3*L_ry_rz + D_delta_rz_3*L_rz_rz + D_delta_x_3*L_x_rz
        + D_delta_y_3*L_y_rz
    )
    f_rz_w_leg_2x = (
        D_delta_rx_4*L_rx_rz + D_delta_ry_4*L_ry_rz + D_delta_rz_4*L_rz_rz + D_delta_x_4*L_x_rz
        + D_delta_y_4*L_y_rz - t126
    )
    f_rz_w_leg_2y = (
        D_delta_rx_5*L_rx_rz + D_delta_ry_5*L_ry_rz + D_delta_rz_5*L_rz_rz + D_delta_x_5*L_x_rz
        + D_delta_y_5*L_y_rz + t132
    )
    f_rz_w_leg_2z = (
        D_delta_rx_6*L_rx_rz + D_delta_ry_6*L_ry_rz + D_delta_rz_6*L_rz_rz + D_delta_x_6*L_x_rz
        + D_delta_y_6*L_y_rz
    )
    f_rz_w_leg_3x = (
        D_delta_rx_7*L_rx_rz + D_delta_ry_7*L_ry_rz + D_delta_rz_7*L_rz_rz + D_delta_x_7*L_x_rz
        + D_delta_y_7*L_y_rz - t127
    )
    f_rz_w_leg_3y = (
        D_delta_rx_8*L_rx_rz + D_delta_ry_8*L_ry_rz + D_delta_rz_8*L_rz_rz + D_delta_x_8*L_x_rz
        + D_delta_y_8*L_y_rz + t133
    )
    f_rz_w_leg_3z = (
        D_delta_rx_9*L_rx_rz + D_delta_ry_9*L_ry_rz + D_delta_rz_9*L_rz_rz + D_delta_x_9*L_x_rz
        + D_delta_y_9*L_y_rz
    )
    f_rz_w_leg_4x = (
        D_delta_rx_10*L_rx_rz + D_delta_ry_10*L_ry_rz + D_delta_rz_10*L_rz_rz + D_delta_x_10*L_x_rz
        + D_delta_y_10*L_y_rz - t128
    )
    f_rz_w_leg_4y = (
        D_delta_rx_11*L_rx_rz + D_delta_ry_11*L_ry_rz + D_delta_rz_11*L_rz_rz + D_delta_x_11*L_x_rz
        + D_delta_y_11*L_y_rz + t134
    )
    f_rz_w_leg_4z = (
        D_delta_rx_12*L_rx_rz + D_delta_ry_12*L_ry_rz + D_delta_rz_12*L_rz_rz + D_delta_x_12*L_x_rz
        + D_delta_y_12*L_y_rz
    )
    f_rz_w_leg_5x = (
        D_delta_rx_13*L_rx_rz + D_delta_ry_13*L_ry_rz + D_delta_rz_13*L_rz_rz + D_delta_x_13*L_x_rz
        + D_delta_y_13*L_y_rz - t129
    )
    f_rz_w_leg_5y = (
        D_delta_rx_14*L_rx_rz + D_delta_ry_14*L_ry_rz + D_delta_rz_14*L_rz_rz + D_delta_x_14*L_x_rz
        + D_delta_y_14*L_y_rz + t135
    )
    f_rz_w_leg_5z = (
        D_delta_rx_15*L_rx_rz + D_delta_ry_15*L_ry_rz + D_delta_rz_15*L_rz_rz + D_delta_x_15*L_x_rz
        + D_delta_y_15*L_y_rz
    )
    f_rz_w_leg_6x = (
        D_delta_rx_16*L_rx_rz + D_delta_ry_16*L_ry_rz + D_delta_rz_16*L_rz_rz + D_delta_x_16*L_x_rz
        + D_delta_y_16*L_y_rz - t130
    )
    f_rz_w_leg_6y = (
        D_delta_rx_17*L_rx_rz + D_delta_ry_17*L_ry_rz + D_delta_rz_17*L_rz_rz + D_delta_x_17*L_x_rz
        + D_delta_y_17*L_y_rz + t136
    )
    f_rz_w_leg_6z = (
        D_delta_rx_18*L_rx_rz + D_delta_ry_18*L_ry_rz + D_delta_rz_18*L_rz_rz + D_delta_x_18*L_x_rz
        + D_delta_y_18*L_y_rz
    )
    M_p_x_x = m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6 + t99
    t174 = B_1_z*m_perp_1
    t175 = B_2_z*m_perp_2
    t176 = B_3_z*m_perp_3
    t177 = B_4_z*m_perp_4
    t178 = B_5_z*m_perp_5
    t179 = B_6_z*m_perp_6
    t180 = c_z*m_p
    t181 = m_L*o_L_z
    M_p_x_ry = t174 + t175 + t176 + t177 + t178 + t179 + t180 + t181
    t182 = B_1_y*m_perp_1
    t183 = B_2_y*m_perp_2
    t184 = B_3_y*m_perp_3
    t185 = B_4_y*m_perp_4
    t186 = B_5_y*m_perp_5
    t187 = B_6_y*m_perp_6
    t188 = c_y*m_p
    t189 = m_L*o_L_y
    M_p_z_rx = t182 + t183 + t184 + t185 + t186 + t187 + t188 + t189
    M_p_x_rz = -M_p_z_rx
    M_p_y_rx = -M_p_x_ry
    t190 = B_1_x*m_perp_1
    t191 = B_2_x*m_perp_2
    t192 = B_3_x*m_perp_3
    t193 = B_4_x*m_perp_4
    t194 = B_5_x*m_perp_5
    t195 = B_6_x*m_perp_6
    M_p_y_rz = c_x*m_p + m_L*o_L_x + t190 + t191 + t192 + t193 + t194 + t195
    M_p_z_ry = -M_p_y_rz
    t196 = 2*o_L_y**2
    t197 = 2*o_L_z**2
    t198 = (1/2)*m_L
    t199 = 2*c_y**2
    t200 = 2*c_z**2
    t201 = (1/2)*m_p
    t202 = 2*t144
    t203 = 2*t137
    t204 = (1/2)*m_perp_1
    t205 = 2*t145
    t206 = 2*t138
    t207 = (1/2)*m_perp_2
    t208 = 2*t146
    t209 = 2*t139
    t210 = (1/2)*m_perp_3
    t211 = 2*t147
    t212 = 2*t140
    t213 = (1/2)*m_perp_4
    t214 = 2*t148
    t215 = 2*t141
    t216 = (1/2)*m_perp_5
    t217 = 2*t149
    t218 = 2*t142
    t219 = (1/2)*m_perp_6
    M_p_rx_rx = (
        J_x_x + t198*(t196 + t197) + t201*(t199 + t200) + t204*(t202 + t203) + t207*(t205 + t206) + t210*(t208
        + t209) + t213*(t211 + t212) + t216*(t214 + t215) + t219*(t217 + t218)
    )
    M_p_rx_ry = (
        -B_1_x*t182 - B_2_x*t183 - B_3_x*t184 - B_4_x*t185 - B_5_x*t186 - B_6_x*t187 + J_x_y - c_x*t188
        - o_L_x*t189
    )
    M_p_rx_rz = (
        -B_1_x*t174 - B_2_x*t175 - B_3_x*t176 - B_4_x*t177 - B_5_x*t178 - B_6_x*t179 + J_x_z - c_x*t180
        - o_L_x*t181
    )
    t220 = 2*o_L_x**2
    t221 = 2*c_x**2
    t222 = 2*t167
    t223 = 2*t168
    t224 = 2*t169
    t225 = 2*t170
    t226 = 2*t171
    t227 = 2*t172
    M_p_ry_ry = (
        J_y_y + t198*(t197 + t220) + t201*(t200 + t221) + t204*(t203 + t222) + t207*(t206 + t223) + t210*(t209
        + t224) + t213*(t212 + t225) + t216*(t215 + t226) + t219*(t218 + t227)
    )
    M_p_ry_rz = (
        -B_1_y*t174 - B_2_y*t175 - B_3_y*t176 - B_4_y*t177 - B_5_y*t178 - B_6_y*t179 + J_y_z - c_y*t180
        - o_L_y*t181
    )
    M_p_rz_rz = (
        J_z_z + t198*(t196 + t220) + t201*(t199 + t221) + t204*(t202 + t222) + t207*(t205 + t223) + t210*(t208
        + t224) + t213*(t211 + t225) + t216*(t214 + t226) + t219*(t217 + t227)
    )
    t228 = m_lift_1 - m_perp_1
    h_x_w_leg_1x = D_delta_ry_1*M_p_x_ry + D_delta_rz_1*M_p_x_rz + D_delta_x_1*M_p_x_x + t228
    h_x_w_leg_1y = D_delta_ry_2*M_p_x_ry + D_delta_rz_2*M_p_x_rz + D_delta_x_2*M_p_x_x
    h_x_w_leg_1z = D_delta_ry_3*M_p_x_ry + D_delta_rz_3*M_p_x_rz + D_delta_x_3*M_p_x_x
    t229 = m_lift_2 - m_perp_2
    h_x_w_leg_2x = D_delta_ry_4*M_p_x_ry + D_delta_rz_4*M_p_x_rz + D_delta_x_4*M_p_x_x + t229
    h_x_w_leg_2y = D_delta_ry_5*M_p_x_ry + D_delta_rz_5*M_p_x_rz + D_delta_x_5*M_p_x_x
    h_x_w_leg_2z = D_delta_ry_6*M_p_x_ry + D_delta_rz_6*M_p_x_rz + D_delta_x_6*M_p_x_x
    t230 = m_lift_3 - m_perp_3
    h_x_w_leg_3x = D_delta_ry_7*M_p_x_ry + D_delta_rz_7*M_p_x_rz + D_delta_x_7*M_p_x_x + t230
    h_x_w_leg_3y = D_delta_ry_8*M_p_x_ry + D_delta_rz_8*M_p_x_rz + D_delta_x_8*M_p_x_x
    h_x_w_leg_3z = D_delta_ry_9*M_p_x_ry + D_delta_rz_9*M_p_x_rz + D_delta_x_9*M_p_x_x
    t231 = m_lift_4 - m_perp_4
    h_x_w_leg_4x = D_delta_ry_10*M_p_x_ry + D_delta_rz_10*M_p_x_rz + D_delta_x_10*M_p_x_x + t231
    h_x_w_leg_4y = D_delta_ry_11*M_p_x_ry + D_delta_rz_11*M_p_x_rz + D_delta_x_11*M_p_x_x
    h_x_w_leg_4z = D_delta_ry_12*M_p_x_ry + D_delta_rz_12*M_p_x_rz + D_delta_x_12*M_p_x_x
    t232 = m_lift_5 - m_perp_5
    h_x_w_leg_5x = D_delta_ry_13*M_p_x_ry + D_delta_rz_13*M_p_x_rz + D_delta_x_13*M_p_x_x + t232
    h_x_w_leg_5y = D_delta_ry_14*M_p_x_ry + D_delta_rz_14*M_p_x_rz + D_delta_x_14*M_p_x_x
    h_x_w_leg_5z = D_delta_ry_15*M_p_x_ry + D_delta_rz_15*M_p_x_rz + D_delta_x_15*M_p_x_x
    t233 = m_lift_6 - m_perp_6
    h_x_w_leg_6x = D_delta_ry_16*M_p_x_ry + D_delta_rz_16*M_p_x_rz + D_delta_x_16*M_p_x_x + t233
    h_x_w_leg_6y = D_delta_ry_17*M_p_x_ry + D_delta_rz_17*M_p_x_rz + D_delta_x_17*M_p_x_x
    h_x_w_leg_6z = D_delta_ry_18*M_p_x_ry + D_delta_rz_18*M_p_x_rz + D_delta_x_18*M_p_x_x
    h_y_w_leg_1x = D_delta_rx_1*M_p_y_rx + D_delta_rz_1*M_p_y_rz + D_delta_y_1*M_p_x_x
    h_y_w_leg_1y = D_delta_rx_2*M_p_y_rx + D_delta_rz_2*M_p_y_rz + D_delta_y_2*M_p_x_x + t228
    h_y_w_leg_1z = D_delta_rx_3*M_p_y_rx + D_delta_rz_3*M_p_y_rz + D_delta_y_3*M_p_x_x
    h_y_w_leg_2x = D_delta_rx_4*M_p_y_rx + D_delta_rz_4*M_p_y_rz + D_delta_y_4*M_p_x_x
    h_y_w_leg_2y = D_delta_rx_5*M_p_y_rx + D_delta_rz_5*M_p_y_rz + D_delta_y_5*M_p_x_x + t229
    h_y_w_leg_2z = D_delta_rx_6*M_p_y_rx + D_delta_rz_6*M_p_y_rz + D_delta_y_6*M_p_x_x
    h_y_w_leg_3x = D_delta_rx_7*M_p_y_rx + D_delta_rz_7*M_p_y_rz + D_delta_y_7*M_p_x_x
    h_y_w_leg_3y = D_delta_rx_8*M_p_y_rx + D_delta_rz_8*M_p_y_rz + D_delta_y_8*M_p_x_x + t230
    h_y_w_leg_3z = D_delta_rx_9*M_p_y_rx + D_delta_rz_9*M_p_y_rz + D_delta_y_9*M_p_x_x
    h_y_w_leg_4x = D_delta_rx_10*M_p_y_rx + D_delta_rz_10*M_p_y_rz + D_delta_y_10*M_p_x_x
    h_y_w_leg_4y = D_delta_rx_11*M_p_y_rx + D_delta_rz_11*M_p_y_rz + D_delta_y_11*M_p_x_x + t231
    h_y_w_leg_4z = D_delta_rx_12*M_p_y_rx + D_delta_rz_12*M_p_y_rz + D_delta_y_12*M_p_x_x
    h_y_w_leg_5x = D_delta_rx_13*M_p_y_rx + D_delta_rz_13*M_p_y_rz + D_delta_y_13*M_p_x_x
    h_y_w_leg_5y = D_delta_rx_14*M_p_y_rx + D_delta_rz_14*M_p_y_rz + D_delta_y_14*M_p_x_x + t232
    h_y_w_leg_5z = D_delta_rx_15*M_p_y_rx + D_delta_rz_15*M_p_y_rz + D_delta_y_15*M_p_x_x
    h_y_w_leg_6x = D_delta_rx_16*M_p_y_rx + D_delta_rz_16*M_p_y_rz + D_delta_y_16*M_p_x_x
    h_y_w_leg_6y = D_delta_rx_17*M_p_y_rx + D_delta_rz_17*M_p_y_rz + D_delta_y_17*M_p_x_x + t233
    h_y_w_leg_6z = D_delta_rx_18*M_p_y_rx + D_delta_rz_18*M_p_y_rz + D_delta_y_18*M_p_x_x
    h_z_w_leg_1x = D_delta_rx_1*M_p_z_rx + D_delta_ry_1*M_p_z_ry + D_delta_z_1*M_p_x_x
    h_z_w_leg_1y = D_delta_rx_2*M_p_z_rx + D_delta_ry_2*M_p_z_ry + D_delta_z_2*M_p_x_x
    h_z_w_leg_1z = D_delta_rx_3*M_p_z_rx + D_delta_ry_3*M_p_z_ry + D_delta_z_3*M_p_x_x + t228
    h_z_w_leg_2x = D_delta_rx_4*M_p_z_rx + D_delta_ry_4*M_p_z_ry + D_delta_z_4*M_p_x_x
    h_z_w_leg_2y = D_delta_rx_5*M_p_z_rx + D_delta_ry_5*M_p_z_ry + D_delta_z_5*M_p_x_x
    h_z_w_leg_2z = D_delta_rx_6*M_p_z_rx + D_delta_ry_6*M_p_z_ry + D_delta_z_6*M_p_x_x + t229
    h_z_w_leg_3x = D_delta_rx_7*M_p_z_rx + D_delta_ry_7*M_p_z_ry + D_delta_z_7*M_p_x_x
    h_z_w_leg_3y = D_delta_rx_8*M_p_z_rx + D_delta_ry_8*M_p_z_ry + D_delta_z_8*M_p_x_x
    h_z_w_leg_3z = D_delta_rx_9*M_p_z_rx + D_delta_ry_9*M_p_z_ry + D_delta_z_9*M_p_x_x + t230
    h_z_w_leg_4x = D_delta_rx_10*M_p_z_rx + D_delta_ry_10*M_p_z_ry + D_delta_z_10*M_p_x_x
    h_z_w_leg_4y = D_delta_rx_11*M_p_z_rx + D_delta_ry_11*M_p_z_ry + D_delta_z_11*M_p_x_x
    h_z_w_leg_4z = D_delta_rx_12*M_p_z_rx + D_delta_ry_12*M_p_z_ry + D_delta_z_12*M_p_x_x + t231
    h_z_w_leg_5x = D_delta_rx_13*M_p_z_rx + D_delta_ry_13*M_p_z_ry + D_delta_z_13*M_p_x_x
    h_z_w_leg_5y = D_delta_rx_14*M_p_z_rx + D_delta_ry_14*M_p_z_ry + D_delta_z_14*M_p_x_x
    h_z_w_leg_5z = D_delta_rx_15*M_p_z_rx + D_delta_ry_15*M_p_z_ry + D_delta_z_15*M_p_x_x + t232
    h_z_w_leg_6x = D_delta_rx_16*M_p_z_rx + D_delta_ry_16*M_p_z_ry + D_delta_z_16*M_p_x_x
    h_z_w_leg_6y = D_delta_rx_17*M_p_z_rx + D_delta_ry_17*M_p_z_ry + D_delta_z_17*M_p_x_x
    h_z_w_leg_6z = D_delta_rx_18*M_p_z_rx + D_delta_ry_18*M_p_z_ry + D_delta_z_18*M_p_x_x + t233
    h_rx_w_leg_1x = (
        D_delta_rx_1*M_p_rx_rx + D_delta_ry_1*M_p_rx_ry + D_delta_rz_1*M_p_rx_rz + D_delta_y_1*M_p_y_rx
        + D_delta_z_1*M_p_z_rx
    )
    t234 = B_1_z*m_r_1
    t235 = B_1_z*t33
    h_rx_w_leg_1y = (
        D_delta_rx_2*M_p_rx_rx + D_delta_ry_2*M_p_rx_ry + D_delta_rz_2*M_p_rx_rz + D_delta_y_2*M_p_y_rx
        + D_delta_z_2*M_p_z_rx + t174 - t234 - t235
    )
    t236 = B_1_y*m_r_1
    t237 = B_1_y*t33
    t238 = -t182 + t236 + t237
    h_rx_w_leg_1z = (
        D_delta_rx_3*M_p_rx_rx + D_delta_ry_3*M_p_rx_ry + D_delta_rz_3*M_p_rx_rz + D_delta_y_3*M_p_y_rx
        + D_delta_z_3*M_p_z_rx + t238
    )
    h_rx_w_leg_2x = (
        D_delta_rx_4*M_p_rx_rx + D_delta_ry_4*M_p_rx_ry + D_delta_rz_4*M_p_rx_rz + D_delta_y_4*M_p_y_rx
        + D_delta_z_4*M_p_z_rx
    )
    t239 = B_2_z*m_r_2
    t240 = B_2_z*t37
    h_rx_w_leg_2y = (
        D_delta_rx_5*M_p_rx_rx + D_delta_ry_5*M_p_rx_ry + D_delta_rz_5*M_p_rx_rz + D_delta_y_5*M_p_y_rx
        + D_delta_z_5*M_p_z_rx + t175 - t239 - t240
    )
    t241 = B_2_y*m_r_2
    t242 = B_2_y*t37
    t243 = -t183 + t241 + t242
    h_rx_w_leg_2z = (
        D_delta_rx_6*M_p_rx_rx + D_delta_ry_6*M_p_rx_ry + D_delta_rz_6*M_p_rx_rz + D_delta_y_6*M_p_y_rx
        + D_delta_z_6*M_p_z_rx + t243
    )
    h_rx_w_leg_3x = (
        D_delta_rx_7*M_p_rx_rx + D_delta_ry_7*M_p_rx_ry + D_delta_rz_7*M_p_rx_rz + D_delta_y_7*M_p_y_rx
        + D_delta_z_7*M_p_z_rx
    )
    t244 = B_3_z*m_r_3
    t245 = B_3_z*t41
    h_rx_w_leg_3y = (
        D_delta_rx_8*M_p_rx_rx + D_delta_ry_8*M_p_rx_ry + D_delta_rz_8*M_p_rx_rz + D_delta_y_8*M_p_y_rx
        + D_delta_z_8*M_p_z_rx + t176 - t244 - t245
    )
    t246 = B_3_y*m_r_3
    t247 = B_3_y*t41
    t248 = -t184 + t246 + t247
    h_rx_w_leg_3z = (
        D_delta_rx_9*M_p_rx_rx + D_delta_ry_9*M_p_rx_ry + D_delta_rz_9*M_p_rx_rz + D_delta_y_9*M_p_y_rx
        + D_delta_z_9*M_p_z_rx + t248
    )
    h_rx_w_leg_4x = (
        D_delta_rx_10*M_p_rx_rx + D_delta_ry_10*M_p_rx_ry + D_delta_rz_10*M_p_rx_rz + D_delta_y_10*M_p_y_rx
        + D_delta_z_10*M_p_z_rx
    )
    t249 = B_4_z*m_r_4
    t250 = B_4_z*t45
    h_rx_w_leg_4y = (
        D_delta_rx_11*M_p_rx_rx + D_delta_ry_11*M_p_rx_ry + D_delta_rz_11*M_p_rx_rz + D_delta_y_11*M_p_y_rx
        + D_delta_z_11*M_p_z_rx + t177 - t249 - t250
    )
    t251 = B_4_y*m_r_4
    t252 = B_4_y*t45
    t253 = -t185 + t251 + t252
    h_rx_w_leg_4z = (
        D_delta_rx_12*M_p_rx_rx + D_delta_ry_12*M_p_rx_ry + D_delta_rz_12*M_p_rx_rz + D_delta_y_12*M_p_y_rx
        + D_delta_z_12*M_p_z_rx + t253
    )
    h_rx_w_leg_5x = (
        D_delta_rx_13*M_p_rx_rx + D_delta_ry_13*M_p_rx_ry + D_delta_rz_13*M_p_rx_rz + D_delta_y_13*M_p_y_rx
        + D_delta_z_13*M_p_z_rx
    )
    t254 = B_5_z*m_r_5
    t255 = B_5_z*t49
    h_rx_w_leg_5y = (
        D_delta_rx_14*M_p_rx_rx + D_delta_ry_14*M_p_rx_ry + D_delta_rz_14*M_p_rx_rz + D_delta_y_14*M_p_y_rx
        + D_delta_z_14*M_p_z_rx + t178 - t254 - t255
    )
    t256 = B_5_y*m_r_5
    t257 = B_5_y*t49
    t258 = -t186 + t256 + t257
    h_rx_w_leg_5z = (
        D_delta_rx_15*M_p_rx_rx + D_delta_ry_15*M_p_rx_ry + D_delta_rz_15*M_p_rx_rz + D_delta_y_15*M_p_y_rx
        + D_delta_z_15*M_p_z_rx + t258
    )
    h_rx_w_leg_6x = (
        D_delta_rx_16*M_p_rx_rx + D_delta_ry_16*M_p_rx_ry + D_delta_rz_16*M_p_rx_rz + D_delta_y_16*M_p_y_rx
        + D_delta_z_16*M_p_z_rx
    )
    t259 = B_6_z*m_r_6
    t260 = B_6_z*t53
    h_rx_w_leg_6y = (
        D_delta_rx_17*M_p_rx_rx + D_delta_ry_17*M_p_rx_ry + D_delta_rz_17*M_p_rx_rz + D_delta_y_17*M_p_y_rx
        + D_delta_z_17*M_p_z_rx + t179 - t259 - t260
    )
    t261 = B_6_y*m_r_6
    t262 = B_6_y*t53
    t263 = -t187 + t261 + t262
    h_rx_w_leg_6z = (
        D_delta_rx_18*M_p_rx_rx + D_delta_ry_18*M_p_rx_ry + D_delta_rz_18*M_p_rx_rz + D_delta_y_18*M_p_y_rx
        + D_delta_z_18*M_p_z_rx + t263
    )
    t264 = -t174 + t234 + t235
    h_ry_w_leg_1x = (
        D_delta_rx_1*M_p_rx_ry + D_delta_ry_1*M_p_ry_ry + D_delta_rz_1*M_p_ry_rz + D_delta_x_1*M_p_x_ry
        + D_delta_z_1*M_p_z_ry + t264
    )
    h_ry_w_leg_1y = (
        D_delta_rx_2*M_p_rx_ry + D_delta_ry_2*M_p_ry_ry + D_delta_rz_2*M_p_ry_rz + D_delta_x_2*M_p_x_ry
        + D_delta_z_2*M_p_z_ry
    )
    t265 = B_1_x*m_r_1
    t266 = B_1_x*t33
    h_ry_w_leg_1z = (
        D_delta_rx_3*M_p_rx_ry + D_delta_ry_3*M_p_ry_ry + D_delta_rz_3*M_p_ry_rz + D_delta_x_3*M_p_x_ry
        + D_delta_z_3*M_p_z_ry + t190 - t265 - t266
    )
    t267 = -t175 + t239 + t240
    h_ry_w_leg_2x = (
        D_delta_rx_4*M_p_rx_ry + D_delta_ry_4*M_p_ry_ry + D_delta_rz_4*M_p_ry_rz + D_delta_x_4*M_p_x_ry
        + D_delta_z_4*M_p_z_ry + t267
    )
    h_ry_w_leg_2y = (
        D_delta_rx_5*M_p_rx_ry + D_delta_ry_5*M_p_ry_ry + D_delta_rz_5*M_p_ry_rz + D_delta_x_5*M_p_x_ry
        + D_delta_z_5*M_p_z_ry
    )
    t268 = B_2_x*m_r_2
    t269 = B_2_x*t37
    h_ry_w_leg_2z = (
        D_delta_rx_6*M_p_rx_ry + D_delta_ry_6*M_p_ry_ry + D_delta_rz_6*M_p_ry_rz + D_delta_x_6*M_p_x_ry
        + D_delta_z_6*M_p_z_ry + t191 - t268 - t269
    )
    t270 = -t176 + t244 + t245
    h_ry_w_leg_3x = (
        D_delta_rx_7*M_p_rx_ry + D_delta_ry_7*M_p_ry_ry + D_delta_rz_7*M_p_ry_rz + D_delta_x_7*M_p_x_ry
        + D_delta_z_7*M_p_z_ry + t270
    )
    h_ry_w_leg_3y = (
        D_delta_rx_8*M_p_rx_ry + D_delta_ry_8*M_p_ry_ry + D_delta_rz_8*M_p_ry_rz + D_delta_x_8*M_p_x_ry
        + D_delta_z_8*M_p_z_ry
    )
    t271 = B_3_x*m_r_3
    t272 = B_3_x*t41
    h_ry_w_leg_3z = (
        D_delta_rx_9*M_p_rx_ry + D_delta_ry_9*M_p_ry_ry + D_delta_rz_9*M_p_ry_rz + D_delta_x_9*M_p_x_ry
        + D_delta_z_9*M_p_z_ry + t192 - t271 - t272
    )
    t273 = -t177 + t249 + t250
    h_ry_w_leg_4x = (
        D_delta_rx_10*M_p_rx_ry + D_delta_ry_10*M_p_ry_ry + D_delta_rz_10*M_p_ry_rz + D_delta_x_10*M_p_x_ry
        + D_delta_z_10*M_p_z_ry + t273
    )
    h_ry_w_leg_4y = (
        D_delta_rx_11*M_p_rx_ry + D_delta_ry_11*M_p_ry_ry + D_delta_rz_11*M_p_ry_rz + D_delta_x_11*M_p_x_ry
        + D_delta_z_11*M_p_z_ry
    )
    t274 = B_4_x*m_r_4
    t275 = B_4_x*t45
    h_ry_w_leg_4z = (
        D_delta_rx_12*M_p_rx_ry + D_delta_ry_12*M_p_ry_ry + D_delta_rz_12*M_p_ry_rz + D_delta_x_12*M_p_x_ry
        + D_delta_z_12*M_p_z_ry + t193 - t274 - t275
    )
    t276 = -t178 + t254 + t255
    h_ry_w_leg_5x = (
        D_delta_rx_13*M_p_rx_ry + D_delta_ry_13*M_p_ry_ry + D_delta_rz_13*M_p_ry_rz + D_delta_x_13*M_p_x_ry
        + D_delta_z_13*M_p_z_ry + t276
    )
    h_ry_w_leg_5y = (
        D_delta_rx_14*M_p_rx_ry + D_delta_ry_14*M_p_ry_ry + D_delta_rz_14*M_p_ry_rz + D_delta_x_14*M_p_x_ry
        + D_delta_z_14*M_p_z_ry
    )
    t277 = B_5_x*m_r_5
    t278 = B_5_x*t49
    h_ry_w_leg_5z = (
        D_delta_rx_15*M_p_rx_ry + D_delta_ry_15*M_p_ry_ry + D_delta_rz_15*M_p_ry_rz + D_delta_x_15*M_p_x_ry
        + D_delta_z_15*M_p_z_ry + t194 - t277 - t278
    )
    t279 = -t179 + t259 + t260
    h_ry_w_leg_6x = (
        D_delta_rx_16*M_p_rx_ry + D_delta_ry_16*M_p_ry_ry + D_delta_rz_16*M_p_ry_rz + D_delta_x_16*M_p_x_ry
        + D_delta_z_16*M_p_z_ry + t279
    )
    h_ry_w_leg_6y = (
        D_delta_rx_17*M_p_rx_ry + D_delta_ry_17*M_p_ry_ry + D_delta_rz_17*M_p_ry_rz + D_delta_x_17*M_p_x_ry
        + D_delta_z_17*M_p_z_ry
    )
    t280 = B_6_x*m_r_6
    t281 = B_6_x*t53
    h_ry_w_leg_6z = (
        D_delta_rx_18*M_p_rx_ry + D_delta_ry_18*M_p_ry_ry + D_delta_rz_18*M_p_ry_rz + D_delta_x_18*M_p_x_ry
        + D_delta_z_18*M_p_z_ry + t195 - t280 - t281
    )
    h_rz_w_leg_1x = (
        D_delta_rx_1*M_p_rx_rz + D_delta_ry_1*M_p_ry_rz + D_delta_rz_1*M_p_rz_rz + D_delta_x_1*M_p_x_rz
        + D_delta_y_1*M_p_y_rz + t182 - t236 - t237
    )
    t282 = -t190 + t265 + t266
    h_rz_w_leg_1y = (
        D_delta_rx_2*M_p_rx_rz + D_delta_ry_2*M_p_ry_rz + D_delta_rz_2*M_p_rz_rz + D_delta_x_2*M_p_x_rz
        + D_delta_y_2*M_p_y_rz + t282
    )
    h_rz_w_leg_1z = (
        D_delta_rx_3*M_p_rx_rz + D_delta_ry_3*M_p_ry_rz + D_delta_rz_3*M_p_rz_rz + D_delta_x_3*M_p_x_rz
        + D_delta_y_3*M_p_y_rz
    )
    h_rz_w_leg_2x = (
        D_delta_rx_4*M_p_rx_rz + D_delta_ry_4*M_p_ry_rz + D_delta_rz_4*M_p_rz_rz + D_delta_x_4*M_p_x_rz
        + D_delta_y_4*M_p_y_rz + t183 - t241 - t242
    )
    t283 = -t191 + t268 + t269
    h_rz_w_leg_2y = (
        D_delta_rx_5*M_p_rx_rz + D_delta_ry_5*M_p_ry_rz + D_delta_rz_5*M_p_rz_rz + D_delta_x_5*M_p_x_rz
        + D_delta_y_5*M_p_y_rz + t283
    )
    h_rz_w_leg_2z = (
        D_delta_rx_6*M_p_rx_rz + D_delta_ry_6*M_p_ry_rz + D_delta_rz_6*M_p_rz_rz + D_delta_x_6*M_p_x_rz
        + D_delta_y_6*M_p_y_rz
    )
    h_rz_w_leg_3x = (
        D_delta_rx_7*M_p_rx_rz + D_delta_ry_7*M_p_ry_rz + D_delta_rz_7*M_p_rz_rz + D_delta_x_7*M_p_x_rz
        + D_delta_y_7*M_p_y_rz + t184 - t246 - t247
    )
    t284 = -t192 + t271 + t272
    h_rz_w_leg_3y = (
        D_delta_rx_8*M_p_rx_rz + D_delta_ry_8*M_p_ry_rz + D_delta_rz_8*M_p_rz_rz + D_delta_x_8*M_p_x_rz
        + D_delta_y_8*M_p_y_rz + t284
    )
    h_rz_w_leg_3z = (
        D_delta_rx_9*M_p_rx_rz + D_delta_ry_9*M_p_ry_rz + D_delta_rz_9*M_p_rz_rz + D_delta_x_9*M_p_x_rz
        + D_delta_y_9*M_p_y_rz
    )
    h_rz_w_leg_4x = (
        D_delta_rx_10*M_p_rx_rz + D_delta_ry_10*M_p_ry_rz + D_delta_rz_10*M_p_rz_rz + D_delta_x_10*M_p_x_rz
        + D_delta_y_10*M_p_y_rz + t185 - t251 - t252
    )
    t285 = -t193 + t274 + t275
    h_rz_w_leg_4y = (
        D_delta_rx_11*M_p_rx_rz + D_delta_ry_11*M_p_ry_rz + D_delta_rz_11*M_p_rz_rz + D_delta_x_11*M_p_x_rz
        + D_delta_y_11*M_p_y_rz + t285
    )
    h_rz_w_leg_4z = (
        D_delta_rx_12*M_p_rx_rz + D_delta_ry_12*M_p_ry_rz + D_delta_rz_12*M_p_rz_rz + D_delta_x_12*M_p_x_rz
        + D_delta_y_12*M_p_y_rz
    )
    h_rz_w_leg_5x = (
        D_delta_rx_13*M_p_rx_rz + D_delta_ry_13*M_p_ry_rz + D_delta_rz_13*M_p_rz_rz + D_delta_x_13*M_p_x_rz
        + D_delta_y_13*M_p_y_rz + t186 - t256 - t257
    )
    t286 = -t194 + t277 + t278
    h_rz_w_leg_5y = (
        D_delta_rx_14*M_p_rx_rz + D_delta_ry_14*M_p_ry_rz + D_delta_rz_14*M_p_rz_rz + D_delta_x_14*M_p_x_rz
        + D_delta_y_14*M_p_y_rz + t286
    )
    h_rz_w_leg_5z = (
        D_delta_rx_15*M_p_rx_rz + D_delta_ry_15*M_p_ry_rz + D_delta_rz_15*M_p_rz_rz + D_delta_x_15*M_p_x_rz
        + D_delta_y_15*M_p_y_rz
    )
    h_rz_w_leg_6x = (
        D_delta_rx_16*M_p_rx_rz + D_delta_ry_16*M_p_ry_rz + D_delta_rz_16*M_p_rz_rz + D_delta_x_16*M_p_x_rz
        + D_delta_y_16*M_p_y_rz + t187 - t261 - t262
    )
    t287 = -t195 + t280 + t281
    h_rz_w_leg_6y = (
        D_delta_rx_17*M_p_rx_rz + D_delta_ry_17*M_p_ry_rz + D_delta_rz_17*M_p_rz_rz + D_delta_x_17*M_p_x_rz
        + D_delta_y_17*M_p_y_rz + t287
    )
    h_rz_w_leg_6z = (
        D_delta_rx_18*M_p_rx_rz + D_delta_ry_18*M_p_ry_rz + D_delta_rz_18*M_p_rz_rz + D_delta_x_18*M_p_x_rz
        + D_delta_y_18*M_p_y_rz
    )
    t288 = t30*t32
    t289 = t264 + t267 + t270 + t273 + t276 + t279
    t290 = t238 + t243 + t248 + t253 + t258 + t263
    t291 = t228 + t229 + t230 + t231 + t232 + t233
    t292 = m_b_1 + m_perp_1 - m_r_1 - 2*t33
    t293 = t282 + t283 + t284 + t285 + t286 + t287
    t294 = t34*t36
    t295 = m_b_2 + m_perp_2 - m_r_2 - 2*t37
    t296 = t38*t40
    t297 = m_b_3 + m_perp_3 - m_r_3 - 2*t41
    t298 = t42*t44
    t299 = m_b_4 + m_perp_4 - m_r_4 - 2*t45
    t300 = t46*t48
    t301 = m_b_5 + m_perp_5 - m_r_5 - 2*t49
    t302 = t50*t52
    t303 = m_b_6 + m_perp_6 - m_r_6 - 2*t53
    t304 = D_delta_x_1*k_C
    t305 = D_delta_y_1*k_C
    t306 = D_delta_z_1*k_C
    t307 = g_x*t288
    t308 = g_y*t288
    t309 = g_z*t288
    t310 = t288*(-B_1_y*g_z + B_1_z*g_y)
    t311 = t288*(B_1_x*g_z - B_1_z*g_x)
    t312 = t288*(-B_1_x*g_y + B_1_y*g_x)
    t313 = g_x*t294
    t314 = g_y*t294
    t315 = g_z*t294
    t316 = t294*(-B_2_y*g_z + B_2_z*g_y)
    t317 = t294*(B_2_x*g_z - B_2_z*g_x)
    t318 = t294*(-B_2_x*g_y + B_2_y*g_x)
    t319 = g_x*t296
    t320 = g_y*t296
    t321 = g_z*t296
    t322 = t296*(-B_3_y*g_z + B_3_z*g_y)
    t323 = t296*(B_3_x*g_z - B_3_z*g_x)
    t324 = t296*(-B_3_x*g_y + B_3_y*g_x)
    t325 = g_x*t298
    t326 = g_y*t298
    t327 = g_z*t298
    t328 = t298*(-B_4_y*g_z + B_4_z*g_y)
    t329 = t298*(B_4_x*g_z - B_4_z*g_x)
    t330 = t298*(-B_4_x*g_y + B_4_y*g_x)
    t331 = g_x*t300
    t332 = g_y*t300
    t333 = g_z*t300
    t334 = t300*(-B_5_y*g_z + B_5_z*g_y)
    t335 = t300*(B_5_x*g_z - B_5_z*g_x)
    t336 = t300*(-B_5_x*g_y + B_5_y*g_x)
    t337 = g_x*t302
    t338 = g_y*t302
    t339 = g_z*t302
    t340 = t302*(-B_6_y*g_z + B_6_z*g_y)
    t341 = t302*(B_6_x*g_z - B_6_z*g_x)
    t342 = t302*(-B_6_x*g_y + B_6_y*g_x)
    t343 = D_delta_x_2*k_C
    t344 = D_delta_y_2*k_C
    t345 = D_delta_z_2*k_C
    t346 = D_delta_x_3*k_C
    t347 = D_delta_y_3*k_C
    t348 = D_delta_z_3*k_C
    t349 = D_delta_x_4*k_C
    t350 = D_delta_y_4*k_C
    t351 = D_delta_z_4*k_C
    t352 = D_delta_x_5*k_C
    t353 = D_delta_y_5*k_C
    t354 = D_delta_z_5*k_C
    t355 = D_delta_x_6*k_C
    t356 = D_delta_y_6*k_C
    t357 = D_delta_z_6*k_C
    t358 = D_delta_x_7*k_C
    t359 = D_delta_y_7*k_C
    t360 = D_delta_z_7*k_C
    t361 = D_delta_x_8*k_C
    t362 = D_delta_y_8*k_C
    t363 = D_delta_z_8*k_C
    t364 = D_delta_x_9*k_C
    t365 = D_delta_y_9*k_C
    t366 = D_delta_z_9*k_C
    t367 = D_delta_x_10*k_C
    t368 = D_delta_y_10*k_C
    t369 = D_delta_z_10*k_C
    t370 = D_delta_x_11*k_C
    t371 = D_delta_y_11*k_C
    t372 = D_delta_z_11*k_C
    t373 = D_delta_x_12*k_C
    t374 = D_delta_y_12*k_C
    t375 = D_delta_z_12*k_C
    t376 = D_delta_x_13*k_C
    t377 = D_delta_y_13*k_C
    t378 = D_delta_z_13*k_C
    t379 = D_delta_x_14*k_C
    t380 = D_delta_y_14*k_C
    t381 = D_delta_z_14*k_C
    t382 = D_delta_x_15*k_C
    t383 = D_delta_y_15*k_C
    t384 = D_delta_z_15*k_C
    t385 = D_delta_x_16*k_C
    t386 = D_delta_y_16*k_C
    t387 = D_delta_z_16*k_C
    t388 = D_delta_x_17*k_C
    t389 = D_delta_y_17*k_C
    t390 = D_delta_z_17*k_C
    t391 = D_delta_x_18*k_C
    t392 = D_delta_y_18*k_C
    t393 = D_delta_z_18*k_C
    M_wq_out = np.zeros((*batch, 18, 15), dtype)
    M_wq_out[..., 0, 0] = (
        D_p_rx_1*h_rx_w_leg_1x + D_p_ry_1*h_ry_w_leg_1x + D_p_rz_1*h_rz_w_leg_1x + D_p_x_1*h_x_w_leg_1x
        + D_p_y_1*h_y_w_leg_1x + D_p_z_1*h_z_w_leg_1x - d_1_x*t288
    )
    M_wq_out[..., 0, 1] = (
        D_p_rx_2*h_rx_w_leg_1x + D_p_ry_2*h_ry_w_leg_1x + D_p_rz_2*h_rz_w_leg_1x + D_p_x_2*h_x_w_leg_1x
        + D_p_y_2*h_y_w_leg_1x + D_p_z_2*h_z_w_leg_1x
    )
    M_wq_out[..., 0, 2] = (
        D_p_rx_3*h_rx_w_leg_1x + D_p_ry_3*h_ry_w_leg_1x + D_p_rz_3*h_rz_w_leg_1x + D_p_x_3*h_x_w_leg_1x
        + D_p_y_3*h_y_w_leg_1x + D_p_z_3*h_z_w_leg_1x
    )
    M_wq_out[..., 0, 3] = (
        D_p_rx_4*h_rx_w_leg_1x + D_p_ry_4*h_ry_w_leg_1x + D_p_rz_4*h_rz_w_leg_1x + D_p_x_4*h_x_w_leg_1x
        + D_p_y_4*h_y_w_leg_1x + D_p_z_4*h_z_w_leg_1x
    )
    M_wq_out[..., 0, 4] = (
        D_p_rx_5*h_rx_w_leg_1x + D_p_ry_5*h_ry_w_leg_1x + D_p_rz_5*h_rz_w_leg_1x + D_p_x_5*h_x_w_leg_1x
        + D_p_y_5*h_y_w_leg_1x + D_p_z_5*h_z_w_leg_1x
    )
    M_wq_out[..., 0, 5] = (
        D_p_rx_6*h_rx_w_leg_1x + D_p_ry_6*h_ry_w_leg_1x + D_p_rz_6*h_rz_w_leg_1x + D_p_x_6*h_x_w_leg_1x
        + D_p_y_6*h_y_w_leg_1x + D_p_z_6*h_z_w_leg_1x
    )
    M_wq_out[..., 0, 12] = D_delta_ry_1*t289 - D_delta_rz_1*t290 + D_delta_x_1*t291 + h_x_w_leg_1x + t292
    M_wq_out[..., 0, 13] = -D_delta_rx_1*t289 + D_delta_rz_1*t293 + D_delta_y_1*t291 + h_y_w_leg_1x
    M_wq_out[..., 0, 14] = D_delta_rx_1*t290 - D_delta_ry_1*t293 + D_delta_z_1*t291 + h_z_w_leg_1x
    M_wq_out[..., 1, 0] = (
        D_p_rx_1*h_rx_w_leg_1y + D_p_ry_1*h_ry_w_leg_1y + D_p_rz_1*h_rz_w_leg_1y + D_p_x_1*h_x_w_leg_1y
        + D_p_y_1*h_y_w_leg_1y + D_p_z_1*h_z_w_leg_1y - d_1_y*t288
    )
    M_wq_out[..., 1, 1] = (
        D_p_rx_2*h_rx_w_leg_1y + D_p_ry_2*h_ry_w_leg_1y + D_p_rz_2*h_rz_w_leg_1y + D_p_x_2*h_x_w_leg_1y
        + D_p_y_2*h_y_w_leg_1y + D_p_z_2*h_z_w_leg_1y
    )
    M_wq_out[..., 1, 2] = (
        D_p_rx_3*h_rx_w_leg_1y + D_p_ry_3*h_ry_w_leg_1y + D_p_rz_3*h_rz_w_leg_1y + D_p_x_3*h_x_w_leg_1y
        + D_p_y_3*h_y_w_leg_1y + D_p_z_3*h_z_w_leg_1y
    )
    M_wq_out[..., 1, 3] = (
        D_p_rx_4*h_rx_w_leg_1y + D_p_ry_4*h_ry_w_leg_1y + D_p_rz_4*h_rz_w_leg_1y + D_p_x_4*h_x_w_leg_1y
        + D_p_y_4*h_y_w_leg_1y + D_p_z_4*h_z_w_leg_1y
    )
    M_wq_out[..., 1, 4] = (
        D_p_rx_5*h_rx_w_leg_1y + D_p_ry_5*h_ry_w_leg_1y + D_p_rz_5*h_rz_w_leg_1y + D_p_x_5*h_x_w_leg_1y
        + D_p_y_5*h_y_w_leg_1y + D_p_z_5*h_z_w_leg_1y
    )
    M_wq_out[..., 1, 5] = (
        D_p_rx_6*h_rx_w_leg_1y + D_p_ry_6*h_ry_w_leg_1y + D_p_rz_6*h_rz_w_leg_1y + D_p_x_6*h_x_w_leg_1y
        + D_p_y_6*h_y_w_leg_1y + D_p_z_6*h_z_w_leg_1y
    )
    M_wq_out[..., 1, 12] = D_delta_ry_2*t289 - D_delta_rz_2*t290 + D_delta_x_2*t291 + h_x_w_leg_1y
    M_wq_out[..., 1, 13] = -D_delta_rx_2*t289 + D_delta_rz_2*t293 + D_delta_y_2*t291 + h_y_w_leg_1y + t292
    M_wq_out[..., 1, 14] = D_delta_rx_2*t290 - D_delta_ry_2*t293 + D_delta_z_2*t291 + h_z_w_leg_1y
    M_wq_out[..., 2, 0] = (
        D_p_rx_1*h_rx_w_leg_1z + D_p_ry_1*h_ry_w_leg_1z + D_p_rz_1*h_rz_w_leg_1z + D_p_x_1*h_x_w_leg_1z
        + D_p_y_1*h_y_w_leg_1z + D_p_z_1*h_z_w_leg_1z - d_1_z*t288
    )
    M_wq_out[..., 2, 1] = (
        D_p_rx_2*h_rx_w_leg_1z + D_p_ry_2*h_ry_w_leg_1z + D_p_rz_2*h_rz_w_leg_1z + D_p_x_2*h_x_w_leg_1z
        + D_p_y_2*h_y_w_leg_1z + D_p_z_2*h_z_w_leg_1z
    )
    M_wq_out[..., 2, 2] = (
        D_p_rx_3*h_rx_w_leg_1z + D_p_ry_3*h_ry_w_leg_1z + D_p_rz_3*h_rz_w_leg_1z + D_p_x_3*h_x_w_leg_1z
        + D_p_y_3*h_y_w_leg_1z + D_p_z_3*h_z_w_leg_1z
    )
    M_wq_out[..., 2, 3] = (
        D_p_rx_4*h_rx_w_leg_1z + D_p_ry_4*h_ry_w_leg_1z + D_p_rz_4*h_rz_w_leg_1z + D_p_x_4*h_x_w_leg_1z
        + D_p_y_4*h_y_w_leg_1z + D_p_z_4*h_z_w_leg_1z
    )
    M_wq_out[..., 2, 4] = (
        D_p_rx_5*h_rx_w_leg_1z + D_p_ry_5*h_ry_w_leg_1z + D_p_rz_5*h_rz_w_leg_1z + D_p_x_5*h_x_w_leg_1z
        + D_p_y_5*h_y_w_leg_1z + D_p_z_5*h_z_w_leg_1z
    )
    M_wq_out[..., 2, 5] = (
        D_p_rx_6*h_rx_w_leg_1z + D_p_ry_6*h_ry_w_leg_1z + D_p_rz_6*h_rz_w_leg_1z + D_p_x_6*h_x_w_leg_1z
        + D_p_y_6*h_y_w_leg_1z + D_p_z_6*h_z_w_leg_1z
    )
    M_wq_out[..., 2, 12] = D_delta_ry_3*t289 - D_delta_rz_3*t290 + D_delta_x_3*t291 + h_x_w_leg_1z
    M_wq_out[..., 2, 13] = -D_delta_rx_3*t289 + D_delta_rz_3*t293 + D_delta_y_3*t291 + h_y_w_leg_1z
    M_wq_out[..., 2, 14] = D_delta_rx_3*t290 - D_delta_ry_3*t293 + D_delta_z_3*t291 + h_z_w_leg_1z + t292
    M_wq_out[..., 3, 0] = (
        D_p_rx_1*h_rx_w_leg_2x + D_p_ry_1*h_ry_w_leg_2x + D_p_rz_1*h_rz_w_leg_2x + D_p_x_1*h_x_w_leg_2x
        + D_p_y_1*h_y_w_leg_2x + D_p_z_1*h_z_w_leg_2x
    )
    M_wq_out[..., 3, 1] = (
        D_p_rx_2*h_rx_w_leg_2x + D_p_ry_2*h_ry_w_leg_2x + D_p_rz_2*h_rz_w_leg_2x + D_p_x_2*h_x_w_leg_2x
        + D_p_y_2*h_y_w_leg_2x + D_p_z_2*h_z_w_leg_2x - d_2_x*t294
    )
    M_wq_out[..., 3, 2] = (
        D_p_rx_3*h_rx_w_leg_2x + D_p_ry_3*h_ry_w_leg_2x + D_p_rz_3*h_rz_w_leg_2x + D_p_x_3*h_x_w_leg_2x
        + D_p_y_3*h_y_w_leg_2x + D_p_z_3*h_z_w_leg_2x
    )
    M_wq_out[..., 3, 3] = (
        D_p_rx_4*h_rx_w_leg_2x + D_p_ry_4*h_ry_w_leg_2x + D_p_rz_4*h_rz_w_leg_2x + D_p_x_4*h_x_w_leg_2x
        + D_p_y_4*h_y_w_leg_2x + D_p_z_4*h_z_w_leg_2x
    )
    M_wq_out[..., 3, 4] = (
        D_p_rx_5*h_rx_w_leg_2x + D_p_ry_5*h_ry_w_leg_2x + D_p_rz_5*h_rz_w_leg_2x + D_p_x_5*h_x_w_leg_2x
        + D_p_y_5*h_y_w_leg_2x + D_p_z_5*h_z_w_leg_2x
    )
    M_wq_out[..., 3, 5] = (
        D_p_rx_6*h_rx_w_leg_2x + D_p_ry_6*h_ry_w_leg_2x + D_p_rz_6*h_rz_w_leg_2x + D_p_x_6*h_x_w_leg_2x
        + D_p_y_6*h_y_w_leg_2x + D_p_z_6*h_z_w_leg_2x
    )
    M_wq_out[..., 3, 12] = D_delta_ry_4*t289 - D_delta_rz_4*t290 + D_delta_x_4*t291 + h_x_w_leg_2x + t295
    M_wq_out[..., 3, 13] = -D_delta_rx_4*t289 + D_delta_rz_4*t293 + D_delta_y_4*t291 + h_y_w_leg_2x
    M_wq_out[..., 3, 14] = D_delta_rx_4*t290 - D_delta_ry_4*t293 + D_delta_z_4*t291 + h_z_w_leg_2x
    M_wq_out[..., 4, 0] = (
        D_p_rx_1*h_rx_w_leg_2y + D_p_ry_1*h_ry_w_leg_2y + D_p_rz_1*h_rz_w_leg_2y + D_p_x_1*h_x_w_leg_2y
        + D_p_y_1*h_y_w_leg_2y + D_p_z_1*h_z_w_leg_2y
    )
    M_wq_out[..., 4, 1] = (
        D_p_rx_2*h_rx_w_leg_2y + D_p_ry_2*h_ry_w_leg_2y + D_p_rz_2*h_rz_w_leg_2y + D_p_x_2*h_x_w_leg_2y
        + D_p_y_2*h_y_w_leg_2y + D_p_z_2*h_z_w_leg_2y - d_2_y*t294
    )
    M_wq_out[..., 4, 2] = (
        D_p_rx_3*h_rx_w_leg_2y + D_p_ry_3*h_ry_w_leg_2y + D_p_rz_3*h_rz_w_leg_2y + D_p_x_3*h_x_w_leg_2y
        + D_p_y_3*h_y_w_leg_2y + D_p_z_3*h_z_w_leg_2y
    )
    M_wq_out[..., 4, 3] = (
        D_p_rx_4*h_rx_w_leg_2y + D_p_ry_4*h_ry_w_leg_2y + D_p_rz_4*h_rz_w_leg_2y + D_p_x_4*h_x_w_leg_2y
        + D_p_y_4*h_y_w_leg_2y + D_p_z_4*h_z_w_leg_2y
    )
    M_wq_out[..., 4, 4] = (
        D_p_rx_5*h_rx_w_leg_2y + D_p_ry_5*h_ry_w_leg_2y + D_p_rz_5*h_rz_w_leg_2y + D_p_x_5*h_x_w_leg_2y
        + D_p_y_5*h_y_w_leg_2y + D_p_z_5*h_z_w_leg_2y
    )
    M_wq_out[..., 4, 5] = (
        D_p_rx_6*h_rx_w_leg_2y + D_p_ry_6*h_ry_w_leg_2y + D_p_rz_6*h_rz_w_leg_2y + D_p_x_6*h_x_w_leg_2y
        + D_p_y_6*h_y_w_leg_2y + D_p_z_6*h_z_w_leg_2y
    )
    M_wq_out[..., 4, 12] = D_delta_ry_5*t289 - D_delta_rz_5*t290 + D_delta_x_5*t291 + h_x_w_leg_2y
    M_wq_out[..., 4, 13] = -D_delta_rx_5*t289 + D_delta_rz_5*t293 + D_delta_y_5*t291 + h_y_w_leg_2y + t295
    M_wq_out[..., 4, 14] = D_delta_rx_5*t290 - D_delta_ry_5*t293 + D_delta_z_5*t291 + h_z_w_leg_2y
    M_wq_out[..., 5, 0] = (
        D_p_rx_1*h_rx_w_leg_2z + D_p_ry_1*h_ry_w_leg_2z + D_p_rz_1*h_rz_w_leg_2z + D_p_x_1*h_x_w_leg_2z
        + D_p_y_1*h_y_w_leg_2z + D_p_z_1*h_z_w_leg_2z
    )
    M_wq_out[..., 5, 1] = (
        D_p_rx_2*h_rx_w_leg_2z + D_p_ry_2*h_ry_w_leg_2z + D_p_rz_2*h_rz_w_leg_2z + D_p_x_2*h_x_w_leg_2z
        + D_p_y_2*h_y_w_leg_2z + D_p_z_2*h_z_w_leg_2z - d_2_z*t294
    )
    M_wq_out[..., 5, 2] = (
        D_p_rx_3*h_rx_w_leg_2z + D_p_ry_3*h_ry_w_leg_2z + D_p_rz_3*h_rz_w_leg_2z + D_p_x_3*h_x_w_leg_2z
        + D_p_y_3*h_y_w_leg_2z + D_p_z_3*h_z_w_leg_2z
    )
    M_wq_out[..., 5, 3] = (
        D_p_rx_4*h_rx_w_leg_2z + D_p_ry_4*h_ry_w_leg_2z + D_p_rz_4*h_rz_w_leg_2z + D_p_x_4*h_x_w_leg_2z
        + D_p_y_4*h_y_w_leg_2z + D_p_z_4*h_z_w_leg_2z
    )
    M_wq_out[..., 5, 4] = (
        D_p_rx_5*h_rx_w_leg_2z + D_p_ry_5*h_ry_w_leg_2z + D_p_rz_5*h_rz_w_leg_2z + D_p_x_5*h_x_w_leg_2z
        + D_p_y_5*h_y_w_leg_2z + D_p_z_5*h_z_w_leg_2z
    )
    M_wq_out[..., 5, 5] = (
        D_p_rx_6*h_rx_w_leg_2z + D_p_ry_6*h_ry_w_leg_2z + D_p_rz_6*h_rz_w_leg_2z + D_p_x_6*h_x_w_leg_2z
        + D_p_y_6*h_y_w_leg_2z + D_p_z_6*h_z_w_leg_2z
    )
    M_wq_out[..., 5, 12] = D_delta_ry_6*t289 - D_delta_rz_6*t290 + D_delta_x_6*t291 + h_x_w_leg_2z
    M_wq_out[..., 5, 13] = -D_delta_rx_6*t289 + D_delta_rz_6*t293 + D_delta_y_6*t291 + h_y_w_leg_2z
    M_wq_out[..., 5, 14] = D_delta_rx_6*t290 - D_delta_ry_6*t293 + D_delta_z_6*t291 + h_z_w_leg_2z + t295
    M_wq_out[..., 6, 0] = (
        D_p_rx_1*h_rx_w_leg_3x + D_p_ry_1*h_ry_w_leg_3x + D_p_rz_1*h_rz_w_leg_3x + D_p_x_1*h_x_w_leg_3x
        + D_p_y_1*h_y_w_leg_3x + D_p_z_1*h_z_w_leg_3x
    )
    M_wq_out[..., 6, 1] = (
        D_p_rx_2*h_rx_w_leg_3x + D_p_ry_2*h_ry_w_leg_3x + D_p_rz_2*h_rz_w_leg_3x + D_p_x_2*h_x_w_leg_3x
        + D_p_y_2*h_y_w_leg_3x + D_p_z_2*h_z_w_leg_3x
    )
    M_wq_out[..., 6, 2] = (
        D_p_rx_3*h_rx_w_leg_3x + D_p_ry_3*h_ry_w_leg_3x + D_p_rz_3*h_rz_w_leg_3x + D_p_x_3*h_x_w_leg_3x
        + D_p_y_3*h_y_w_leg_3x + D_p_z_3*h_z_w_leg_3x - d_3_x*t296
    )
    M_wq_out[..., 6, 3] = (
        D_p_rx_4*h_rx_w_leg_3x + D_p_ry_4*h_ry_w_leg_3x + D_p_rz_4*h_rz_w_leg_3x + D_p_x_4*h_x_w_leg_3x
        + D_p_y_4*h_y_w_leg_3x + D_p_z_4*h_z_w_leg_3x
    )
    M_wq_out[..., 6, 4] = (
        D_p_rx_5*h_rx_w_leg_3x + D_p_ry_5*h_ry_w_leg_3x + D_p_rz_5*h_rz_w_leg_3x + D_p_x_5*h_x_w_leg_3x
        + D_p_y_5*h_y_w_leg_3x + D_p_z_5*h_z_w_leg_3x
    )
    M_wq_out[..., 6, 5] = (
        D_p_rx_6*h_rx_w_leg_3x + D_p_ry_6*h_ry_w_leg_3x + D_p_rz_6*h_rz_w_leg_3x + D_p_x_6*h_x_w_leg_3x
        + D_p_y_6*h_y_w_leg_3x + D_p_z_6*h_z_w_leg_3x
    )
    M_wq_out[..., 6, 12] = D_delta_ry_7*t289 - D_delta_rz_7*t290 + D_delta_x_7*t291 + h_x_w_leg_3x + t297
    M_wq_out[..., 6, 13] = -D_delta_rx_7*t289 + D_delta_rz_7*t293 + D_delta_y_7*t291 + h_y_w_leg_3x
    M_wq_out[..., 6, 14] = D_delta_rx_7*t290 - D_delta_ry_7*t293 + D_delta_z_7*t291 + h_z_w_leg_3x
    M_wq_out[..., 7, 0] = (
        D_p_rx_1*h_rx_w_leg_3y + D_p_ry_1*h_ry_w_leg_3y + D_p_rz_1*h_rz_w_leg_3y + D_p_x_1*h_x_w_leg_3y
        + D_p_y_1*h_y_w_leg_3y + D_p_z_1*h_z_w_leg_3y
    )
    M_wq_out[..., 7, 1] = (
        D_p_rx_2*h_rx_w_leg_3y + D_p_ry_2*h_ry_w_leg_3y + D_p_rz_2*h_rz_w_leg_3y + D_p_x_2*h_x_w_leg_3y
        + D_p_y_2*h_y_w_leg_3y + D_p_z_2*h_z_w_leg_3y
    )
    M_wq_out[..., 7, 2] = (
        D_p_rx_3*h_rx_w_leg_3y + D_p_ry_3*h_ry_w_leg_3y + D_p_rz_3*h_rz_w_leg_3y + D_p_x_3*h_x_w_leg_3y
        + D_p_y_3*h_y_w_leg_3y + D_p_z_3*h_z_w_leg_3y - d_3_y*t296
    )
    M_wq_out[..., 7, 3] = (
        D_p_rx_4*h_rx_w_leg_3y + D_p_ry_4*h_ry_w_leg_3y + D_p_rz_4*h_rz_w_leg_3y + D_p_x_4*h_x_w_leg_3y
        + D_p_y_4*h_y_w_leg_3y + D_p_z_4*h_z_w_leg_3y
    )
    M_wq_out[..., 7, 4] = (
        D_p_rx_5*h_rx_w_leg_3y + D_p_ry_5*h_ry_w_leg_3y + D_p_rz_5*h_rz_w_leg_3y + D_p_x_5*h_x_w_leg_3y
        + D_p_y_5*h_y_w_leg_3y + D_p_z_5*h_z_w_leg_3y
    )
    M_wq_out[..., 7, 5] = (
        D_p_rx_6*h_rx_w_leg_3y + D_p_ry_6*h_ry_w_leg_3y + D_p_rz_6*h_rz_w_leg_3y + D_p_x_6*h_x_w_leg_3y
        + D_p_y_6*h_y_w_leg_3y + D_p_z_6*h_z_w_leg_3y
    )
    M_wq_out[..., 7, 12] = D_delta_ry_8*t289 - D_delta_rz_8*t290 + D_delta_x_8*t291 + h_x_w_leg_3y
    M_wq_out[..., 7, 13] = -D_delta_rx_8*t289 + D_delta_rz_8*t293 + D_delta_y_8*t291 + h_y_w_leg_3y + t297
    M_wq_out[..., 7, 14] = D_delta_rx_8*t290 - D_delta_ry_8*t293 + D_delta_z_8*t291 + h_z_w_leg_3y
    M_wq_out[..., 8, 0] = (
        D_p_rx_1*h_rx_w_leg_3z + D_p_ry_1*h_ry_w_leg_3z + D_p_rz_1*h_rz_w_leg_3z + D_p_x_1*h_x_w_leg_3z
        + D_p_y_1*h_y_w_leg_3z + D_p_z_1*h_z_w_leg_3z
    )
    M_wq_out[..., 8, 1] = (
        D_p_rx_2*h_rx_w_leg_3z + D_p_ry_2*h_ry_w_leg_3z + D_p_rz_2*h_rz_w_leg_3z + D_p_x_2*h_x_w_leg_3z
        + D_p_y_2*h_y_w_leg_3z + D_p_z_2*h_z_w_leg_3z
    )
    M_wq_out[..., 8, 2] = (
        D_p_rx_3*h_rx_w_leg_3z + D_p_ry_3*h_ry_w_leg_3z + D_p_rz_3*h_rz_w_leg_3z + D_p_x_3*h_x_w_leg_3z
        + D_p_y_3*h_y_w_leg_3z + D_p_z_3*h_z_w_leg_3z - d_3_z*t296
    )
    M_wq_out[..., 8, 3] = (
        D_p_rx_4*h_rx_w_leg_3z + D_p_ry_4*h_ry_w_leg_3z + D_p_rz_4*h_rz_w_leg_3z + D_p_x_4*h_x_w_leg_3z
        + D_p_y_4*h_y_w_leg_3z + D_p_z_4*h_z_w_leg_3z
    )
    M_wq_out[..., 8, 4] = (
        D_p_rx_5*h_rx_w_leg_3z + D_p_ry_5*h_ry_w_leg_3z + D_p_rz_5*h_rz_w_leg_3z + D_p_x_5*h_x_w_leg_3z
        + D_p_y_5*h_y_w_leg_3z + D_p_z_5*h_z_w_leg_3z
    )
    M_wq_out[..., 8, 5] = (
        D_p_rx_6*h_rx_w_leg_3z + D_p_ry_6*h_ry_w_leg_3z + D_p_rz_6*h_rz_w_leg_3z + D_p_x_6*h_x_w_leg_3z
        + D_p_y_6*h_y_w_leg_3z + D_p_z_6*h_z_w_leg_3z
    )
    M_wq_out[..., 8, 12] = D_delta_ry_9*t289 - D_delta_rz_9*t290 + D_delta_x_9*t291 + h_x_w_leg_3z
    M_wq_out[..., 8, 13] = -D_delta_rx_9*t289 + D_delta_rz_9*t293 + D_delta_y_9*t291 + h_y_w_leg_3z
    M_wq_out[..., 8, 14] = D_delta_rx_9*t290 - D_delta_ry_9*t293 + D_delta_z_9*t291 + h_z_w_leg_3z + t297
    M_wq_out[..., 9, 0] = (
        D_p_rx_1*h_rx_w_leg_4x + D_p_ry_1*h_ry_w_leg_4x + D_p_rz_1*h_rz_w_leg_4x + D_p_x_1*h_x_w_leg_4x
        + D_p_y_1*h_y_w_leg_4x + D_p_z_1*h_z_w_leg_4x
    )
    M_wq_out[..., 9, 1] = (
        D_p_rx_2*h_rx_w_leg_4x + D_p_ry_2*h_ry_w_leg_4x + D_p_rz_2*h_rz_w_leg_4x + D_p_x_2*h_x_w_leg_4x
        + D_p_y_2*h_y_w_leg_4x + D_p_z_2*h_z_w_leg_4x
    )
    M_wq_out[..., 9, 2] = (
        D_p_rx_3*h_rx_w_leg_4x + D_p_ry_3*h_ry_w_leg_4x + D_p_rz_3*h_rz_w_leg_4x + D_p_x_3*h_x_w_leg_4x
        + D_p_y_3*h_y_w_leg_4x + D_p_z_3*h_z_w_leg_4x
    )
    M_wq_out[..., 9, 3] = (
        D_p_rx_4*h_rx_w_leg_4x + D_p_ry_4*h_ry_w_leg_4x + D_p_rz_4*h_rz_w_leg_4x + D_p_x_4*h_x_w_leg_4x
        + D_p_y_4*h_y_w_leg_4x + D_p_z_4*h_z_w_leg_4x - d_4_x*t298
    )
    M_wq_out[..., 9, 4] = (
        D_p_rx_5*h_rx_w_leg_4x + D_p_ry_5*h_ry_w_leg_4x + D_p_rz_5*h_rz_w_leg_4x + D_p_x_5*h_x_w_leg_4x
        + D_p_y_5*h_y_w_leg_4x + D_p_z_5*h_z_w_leg_4x
    )
    M_wq_out[..., 9, 5] = (
        D_p_rx_6*h_rx_w_leg_4x + D_p_ry_6*h_ry_w_leg_4x + D_p_rz_6*h_rz_w_leg_4x + D_p_x_6*h_x_w_leg_4x
        + D_p_y_6*h_y_w_leg_4x + D_p_z_6*h_z_w_leg_4x
    )
    M_wq_out[..., 9, 12] = D_delta_ry_10*t289 - D_delta_rz_10*t290 + D_delta_x_10*t291 + h_x_w_leg_4x + t299
    M_wq_out[..., 9, 13] = -D_delta_rx_10*t289 + D_delta_rz_10*t293 + D_delta_y_10*t291 + h_y_w_leg_4x
    M_wq_out[..., 9, 14] = D_delta_rx_10*t290 - D_delta_ry_10*t293 + D_delta_z_10*t291 + h_z_w_leg_4x
    M_wq_out[..., 10, 0] = (
        D_p_rx_1*h_rx_w_leg_4y + D_p_ry_1*h_ry_w_leg_4y + D_p_rz_1*h_rz_w_leg_4y + D_p_x_1*h_x_w_leg_4y
        + D_p_y_1*h_y_w_leg_4y + D_p_z_1*h_z_w_leg_4y
    )
    M_wq_out[..., 10, 1] = (
        D_p_rx_2*h_rx_w_leg_4y + D_p_ry_2*h_ry_w_leg_4y + D_p_rz_2*h_rz_w_leg_4y + D_p_x_2*h_x_w_leg_4y
        + D_p_y_2*h_y_w_leg_4y + D_p_z_2*h_z_w_leg_4y
    )
    M_wq_out[..., 10, 2] = (
        D_p_rx_3*h_rx_w_leg_4y + D_p_ry_3*h_ry_w_leg_4y + D_p_rz_3*h_rz_w_leg_4y + D_p_x_3*h_x_w_leg_4y
        + D_p_y_3*h_y_w_leg_4y + D_p_z_3*h_z_w_leg_4y
    )
    M_wq_out[..., 10, 3] = (
        D_p_rx_4*h_rx_w_leg_4y + D_p_ry_4*h_ry_w_leg_4y + D_p_rz_4*h_rz_w_leg_4y + D_p_x_4*h_x_w_leg_4y
        + D_p_y_4*h_y_w_leg_4y + D_p_z_4*h_z_w_leg_4y - d_4_y*t298
    )
    M_wq_out[..., 10, 4] = (
        D_p_rx_5*h_rx_w_leg_4y + D_p_ry_5*h_ry_w_leg_4y + D_p_rz_5*h_rz_w_leg_4y + D_p_x_5*h_x_w_leg_4y
        + D_p_y_5*h_y_w_leg_4y + D_p_z_5*h_z_w_leg_4y
    )
    M_wq_out[..., 10, 5] = (
        D_p_rx_6*h_rx_w_leg_4y + D_p_ry_6*h_ry_w_leg_4y + D_p_rz_6*h_rz_w_leg_4y + D_p_x_6*h_x_w_leg_4y
        + D_p_y_6*h_y_w_leg_4y + D_p_z_6*h_z_w_leg_4y
    )
    M_wq_out[..., 10, 12] = D_delta_ry_11*t289 - D_delta_rz_11*t290 + D_delta_x_11*t291 + h_x_w_leg_4y
    M_wq_out[..., 10, 13] = -D_delta_rx_11*t289 + D_delta_rz_11*t293 + D_delta_y_11*t291 + h_y_w_leg_4y + t299
    M_wq_out[..., 10, 14] = D_delta_rx_11*t290 - D_delta_ry_11*t293 + D_delta_z_11*t291 + h_z_w_leg_4y
    M_wq_out[..., 11, 0] = (
        D_p_rx_1*h_rx_w_leg_4z + D_p_ry_1*h_ry_w_leg_4z + D_p_rz_1*h_rz_w_leg_4z + D_p_x_1*h_x_w_leg_4z
        + D_p_y_1*h_y_w_leg_4z + D_p_z_1*h_z_w_leg_4z
    )
    M_wq_out[..., 11, 1] = (
        D_p_rx_2*h_rx_w_leg_4z + D_p_ry_2*h_ry_w_leg_4z + D_p_rz_2*h_rz_w_leg_4z + D_p_x_2*h_x_w_leg_4z
        + D_p_y_2*h_y_w_leg_4z + D_p_z_2*h_z_w_leg_4z
    )
    M_wq_out[..., 11, 2] = (
        D_p_rx_3*h_rx_w_leg_4z + D_p_ry_3*h_ry_w_leg_4z + D_p_rz_3*h_rz_w_leg_4z + D_p_x_3*h_x_w_leg_4z
        + D_p_y_3*h_y_w_leg_4z + D_p_z_3*h_z_w_leg_4z
    )
    M_wq_out[..., 11, 3] = (
        D_p_rx_4*h_rx_w_leg_4z + D_p_ry_4*h_ry_w_leg_4z + D_p_rz_4*h_rz_w_leg_4z + D_p_x_4*h_x_w_leg_4z
        + D_p_y_4*h_y_w_leg_4z + D_p_z_4*h_z_w_leg_4z - d_4_z*t298
    )
    M_wq_out[..., 11, 4] = (
        D_p_rx_5*h_rx_w_leg_4z + D_p_ry_5*h_ry_w_leg_4z + D_p_rz_5*h_rz_w_leg_4z + D_p_x_5*h_x_w_leg_4z
        + D_p_y_5*h_y_w_leg_4z + D_p_z_5*h_z_w_leg_4z
    )
    M_wq_out[..., 11, 5] = (
        D_p_rx_6*h_rx_w_leg_4z + D_p_ry_6*h_ry_w_leg_4z + D_p_rz_6*h_rz_w_leg_4z + D_p_x_6*h_x_w_leg_4z
        + D_p_y_6*h_y_w_leg_4z + D_p_z_6*h_z_w_leg_4z
    )
    M_wq_out[..., 11, 12] = D_delta_ry_12*t289 - D_delta_rz_12*t290 + D_delta_x_12*t291 + h_x_w_leg_4z
    M_wq_out[..., 11, 13] = -D_delta_rx_12*t289 + D_delta_rz_12*t293 + D_delta_y_12*t291 + h_y_w_leg_4z
    M_wq_out[..., 11, 14] = D_delta_rx_12*t290 - D_delta_ry_12*t293 + D_delta_z_12*t291 + h_z_w_leg_4z + t299
    M_wq_out[..., 12, 0] = (
        D_p_rx_1*h_rx_w_leg_5x + D_p_ry_1*h_ry_w_leg_5x + D_p_rz_1*h_rz_w_leg_5x + D_p_x_1*h_x_w_leg_5x
        + D_p_y_1*h_y_w_leg_5x + D_p_z_1*h_z_w_leg_5x
    )
    M_wq_out[..., 12, 1] = (
        D_p_rx_2*h_rx_w_leg_5x + D_p_ry_2*h_ry_w_leg_5x + D_p_rz_2*h_rz_w_leg_5x + D_p_x_2*h_x_w_leg_5x
        + D_p_y_2*h_y_w_leg_5x + D_p_z_2*h_z_w_leg_5x
    )
    M_wq_out[..., 12, 2] = (
        D_p_rx_3*h_rx_w_leg_5x + D_p_ry_3*h_ry_w_leg_5x + D_p_rz_3*h_rz_w_leg_5x + D_p_x_3*h_x_w_leg_5x
        + D_p_y_3*h_y_w_leg_5x + D_p_z_3*h_z_w_leg_5x
    )
    M_wq_out[..., 12, 3] = (
        D_p_rx_4*h_rx_w_leg_5x + D_p_ry_4*h_ry_w_leg_5x + D_p_rz_4*h_rz_w_leg_5x + D_p_x_4*h_x_w_leg_5x
        + D_p_y_4*h_y_w_leg_5x + D_p_z_4*h_z_w_leg_5x
    )
    M_wq_out[..., 12, 4] = (
        D_p_rx_5*h_rx_w_leg_5x + D_p_ry_5*h_ry_w_leg_5x + D_p_rz_5*h_rz_w_leg_5x + D_p_x_5*h_x_w_leg_5x
        + D_p_y_5*h_y_w_leg_5x + D_p_z_5*h_z_w_leg_5x - d_5_x*t300
    )
    M_wq_out[..., 12, 5] = (
        D_p_rx_6*h_rx_w_leg_5x + D_p_ry_6*h_ry_w_leg_5x + D_p_rz_6*h_rz_w_leg_5x + D_p_x_6*h_x_w_leg_5x
        + D_p_y_6*h_y_w_leg_5x + D_p_z_6*h_z_w_leg_5x
    )
    M_wq_out[..., 12, 12] = D_delta_ry_13*t289 - D_delta_rz_13*t290 + D_delta_x_13*t291 + h_x_w_leg_5x + t301
    M_wq_out[..., 12, 13] = -D_delta_rx_13*t289 + D_delta_rz_13*t293 + D_delta_y_13*t291 + h_y_w_leg_5x
    M_wq_out[..., 12, 14] = D_delta_rx_13*t290 - D_delta_ry_13*t293 + D_delta_z_13*t291 + h_z_w_leg_5x
    M_wq_out[..., 13, 0] = (
        D_p_rx_1*h_rx_w_leg_5y + D_p_ry_1*h_ry_w_leg_5y + D_p_rz_1*h_rz_w_leg_5y + D_p_x_1*h_x_w_leg_5y
        + D_p_y_1*h_y_w_leg_5y + D_p_z_1*h_z_w_leg_5y
    )
    M_wq_out[..., 13, 1] = (
        D_p_rx_2*h_rx_w_leg_5y + D_p_ry_2*h_ry_w_leg_5y + D_p_rz_2*h_rz_w_leg_5y + D_p_x_2*h_x_w_leg_5y
        + D_p_y_2*h_y_w_leg_5y + D_p_z_2*h_z_w_leg_5y
    )
    M_wq_out[..., 13, 2] = (
        D_p_rx_3*h_rx_w_leg_5y + D_p_ry_3*h_ry_w_leg_5y + D_p_rz_3*h_rz_w_leg_5y + D_p_x_3*h_x_w_leg_5y
        + D_p_y_3*h_y_w_leg_5y + D_p_z_3*h_z_w_leg_5y
    )
    M_wq_out[..., 13, 3] = (
        D_p_rx_4*h_rx_w_leg_5y + D_p_ry_4*h_ry_w_leg_5y + D_p_rz_4*h_rz_w_leg_5y + D_p_x_4*h_x_w_leg_5y
        + D_p_y_4*h_y_w_leg_5y + D_p_z_4*h_z_w_leg_5y
    )
    M_wq_out[..., 13, 4] = (
        D_p_rx_5*h_rx_w_leg_5y + D_p_ry_5*h_ry_w_leg_5y + D_p_rz_5*h_rz_w_leg_5y + D_p_x_5*h_x_w_leg_5y
        + D_p_y_5*h_y_w_leg_5y + D_p_z_5*h_z_w_leg_5y - d_5_y*t300
    )
    M_wq_out[..., 13, 5] = (
        D_p_rx_6*h_rx_w_leg_5y + D_p_ry_6*h_ry_w_leg_5y + D_p_rz_6*h_rz_w_leg_5y + D_p_x_6*h_x_w_leg_5y
        + D_p_y_6*h_y_w_leg_5y + D_p_z_6*h_z_w_leg_5y
    )
    M_wq_out[..., 13, 12] = D_delta_ry_14*t289 - D_delta_rz_14*t290 + D_delta_x_14*t291 + h_x_w_leg_5y
    M_wq_out[..., 13, 13] = -D_delta_rx_14*t289 + D_delta_rz_14*t293 + D_delta_y_14*t291 + h_y_w_leg_5y + t301
    M_wq_out[..., 13, 14] = D_delta_rx_14*t290 - D_delta_ry_14*t293 + D_delta_z_14*t291 + h_z_w_leg_5y
    M_wq_out[..., 14, 0] = (
        D_p_rx_1*h_rx_w_leg_5z + D_p_ry_1*h_ry_w_leg_5z + D_p_rz_1*h_rz_w_leg_5z + D_p_x_1*h_x_w_leg_5z
        + D_p_y_1*h_y_w_leg_5z + D_p_z_1*h_z_w_leg_5z
    )
    M_wq_out[..., 14, 1] = (
        D_p_rx_2*h_rx_w_leg_5z + D_p_ry_2*h_ry_w_leg_5z + D_p_rz_2*h_rz_w_leg_5z + D_p_x_2*h_x_w_leg_5z
        + D_p_y_2*h_y_w_leg_5z + D_p_z_2*h_z_w_leg_5z
    )
    M_wq_out[..., 14, 2] = (
        D_p_rx_3*h_rx_w_leg_5z + D_p_ry_3*h_ry_w_leg_5z + D_p_rz_3*h_rz_w_leg_5z + D_p_x_3*h_x_w_leg_5z
        + D_p_y_3*h_y_w_leg_5z + D_p_z_3*h_z_w_leg_5z
    )
    M_wq_out[..., 14, 3] = (
        D_p_rx_4*h_rx_w_leg_5z + D_p_ry_4*h_ry_w_leg_5z + D_p_rz_4*h_rz_w_leg_5z + D_p_x_4*h_x_w_leg_5z
        + D_p_y_4*h_y_w_leg_5z + D_p_z_4*h_z_w_leg_5z
    )
    M_wq_out[..., 14, 4] = (
        D_p_rx_5*h_rx_w_leg_5z + D_p_ry_5*h_ry_w_leg_5z + D_p_rz_5*h_rz_w_leg_5z + D_p_x_5*h_x_w_leg_5z
        + D_p_y_5*h_y_w_leg_5z + D_p_z_5*h_z_w_leg_5z - d_5_z*t300
    )
    M_wq_out[..., 14, 5] = (
        D_p_rx_6*h_rx_w_leg_5z + D_p_ry_6*h_ry_w_leg_5z + D_p_rz_6*h_rz_w_leg_5z + D_p_x_6*h_x_w_leg_5z
        + D_p_y_6*h_y_w_leg_5z + D_p_z_6*h_z_w_leg_5z
    )
    M_wq_out[..., 14, 12] = D_delta_ry_15*t289 - D_delta_rz_15*t290 + D_delta_x_15*t291 + h_x_w_leg_5z
    M_wq_out[..., 14, 13] = -D_delta_rx_15*t289 + D_delta_rz_15*t293 + D_delta_y_15*t291 + h_y_w_leg_5z
    M_wq_out[..., 14, 14] = D_delta_rx_15*t290 - D_delta_ry_15*t293 + D_delta_z_15*t291 + h_z_w_leg_5z + t301
    M_wq_out[..., 15, 0] = (
        D_p_rx_1*h_rx_w_leg_6x + D_p_ry_1*h_ry_w_leg_6x + D_p_rz_1*h_rz_w_leg_6x + D_p_x_1*h_x_w_leg_6x
        + D_p_y_1*h_y_w_leg_6x + D_p_z_1*h_z_w_leg_6x
    )
    M_wq_out[..., 15, 1] = (
        D_p_rx_2*h_rx_w_leg_6x + D_p_ry_2*h_ry_w_leg_6x + D_p_rz_2*h_rz_w_leg_6x + D_p_x_2*h_x_w_leg_6x
        + D_p_y_2*h_y_w_leg_6x + D_p_z_2*h_z_w_leg_6x
    )
    M_wq_out[..., 15, 2] = (
        D_p_rx_3*h_rx_w_leg_6x + D_p_ry_3*h_ry_w_leg_6x + D_p_rz_3*h_rz_w_leg_6x + D_p_x_3*h_x_w_leg_6x
        + D_p_y_3*h_y_w_leg_6x + D_p_z_3*h_z_w_leg_6x
    )
    M_wq_out[..., 15, 3] = (
        D_p_rx_4*h_rx_w_leg_6x + D_p_ry_4*h_ry_w_leg_6x + D_p_rz_4*h_rz_w_leg_6x + D_p_x_4*h_x_w_leg_6x
        + D_p_y_4*h_y_w_leg_6x + D_p_z_4*h_z_w_leg_6x
    )
    M_wq_out[..., 15, 4] = (
        D_p_rx_5*h_rx_w_leg_6x + D_p_ry_5*h_ry_w_leg_6x + D_p_rz_5*h_rz_w_leg_6x + D_p_x_5*h_x_w_leg_6x
        + D_p_y_5*h_y_w_leg_6x + D_p_z_5*h_z_w_leg_6x
    )
    M_wq_out[..., 15, 5] = (
        D_p_rx_6*h_rx_w_leg_6x + D_p_ry_6*h_ry_w_leg_6x + D_p_rz_6*h_rz_w_leg_6x + D_p_x_6*h_x_w_leg_6x
        + D_p_y_6*h_y_w_leg_6x + D_p_z_6*h_z_w_leg_6x - d_6_x*t302
    )
    M_wq_out[..., 15, 12] = D_delta_ry_16*t289 - D_delta_rz_16*t290 + D_delta_x_16*t291 + h_x_w_leg_6x + t303
    M_wq_out[..., 15, 13] = -D_delta_rx_16*t289 + D_delta_rz_16*t293 + D_delta_y_16*t291 + h_y_w_leg_6x
    M_wq_out[..., 15, 14] = D_delta_rx_16*t290 - D_delta_ry_16*t293 + D_delta_z_16*t291 + h_z_w_leg_6x
    M_wq_out[..., 16, 0] = (
        D_p_rx_1*h_rx_w_leg_6y + D_p_ry_1*h_ry_w_leg_6y + D_p_rz_1*h_rz_w_leg_6y + D_p_x_1*h_x_w_leg_6y
        + D_p_y_1*h_y_w_leg_6y + D_p_z_1*h_z_w_leg_6y
    )
    M_wq_out[..., 16, 1] = (
        D_p_rx_2*h_rx_w_leg_6y + D_p_ry_2*h_ry_w_leg_6y + D_p_rz_2*h_rz_w_leg_6y + D_p_x_2*h_x_w_leg_6y
        + D_p_y_2*h_y_w_leg_6y + D_p_z_2*h_z_w_leg_6y
    )
    M_wq_out[..., 16, 2] = (
        D_p_rx_3*h_rx_w_leg_6y + D_p_ry_3*h_ry_w_leg_6y + D_p_rz_3*h_rz_w_leg_6y + D_p_x_3*h_x_w_leg_6y
        + D_p_y_3*h_y_w_leg_6y + D_p_z_3*h_z_w_leg_6y
    )
    M_wq_out[..., 16, 3] = (
        D_p_rx_4*h_rx_w_leg_6y + D_p_ry_4*h_ry_w_leg_6y + D_p_rz_4*h_rz_w_leg_6y + D_p_x_4*h_x_w_leg_6y
        + D_p_y_4*h_y_w_leg_6y + D_p_z_4*h_z_w_leg_6y
    )
    M_wq_out[..., 16, 4] = (
        D_p_rx_5*h_rx_w_leg_6y + D_p_ry_5*h_ry_w_leg_6y + D_p_rz_5*h_rz_w_leg_6y + D_p_x_5*h_x_w_leg_6y
        + D_p_y_5*h_y_w_leg_6y + D_p_z_5*h_z_w_leg_6y
    )
    M_wq_out[..., 16, 5] = (
        D_p_rx_6*h_rx_w_leg_6y + D_p_ry_6*h_ry_w_leg_6y + D_p_rz_6*h_rz_w_leg_6y + D_p_x_6*h_x_w_leg_6y
        + D_p_y_6*h_y_w_leg_6y + D_p_z_6*h_z_w_leg_6y - d_6_y*t302
    )
    M_wq_out[..., 16, 12] = D_delta_ry_17*t289 - D_delta_rz_17*t290 + D_delta_x_17*t291 + h_x_w_leg_6y
    M_wq_out[..., 16, 13] = -D_delta_rx_17*t289 + D_delta_rz_17*t293 + D_delta_y_17*t291 + h_y_w_leg_6y + t303
    M_wq_out[..., 16, 14] = D_delta_rx_17*t290 - D_delta_ry_17*t293 + D_delta_z_17*t291 + h_z_w_leg_6y
    M_wq_out[..., 17, 0] = (
        D_p_rx_1*h_rx_w_leg_6z + D_p_ry_1*h_ry_w_leg_6z + D_p_rz_1*h_rz_w_leg_6z + D_p_x_1*h_x_w_leg_6z
        + D_p_y_1*h_y_w_leg_6z + D_p_z_1*h_z_w_leg_6z
    )
    M_wq_out[..., 17, 1] = (
        D_p_rx_2*h_rx_w_leg_6z + D_p_ry_2*h_ry_w_leg_6z + D_p_rz_2*h_rz_w_leg_6z + D_p_x_2*h_x_w_leg_6z
        + D_p_y_2*h_y_w_leg_6z + D_p_z_2*h_z_w_leg_6z
    )
    M_wq_out[..., 17, 2] = (
        D_p_rx_3*h_rx_w_leg_6z + D_p_ry_3*h_ry_w_leg_6z + D_p_rz_3*h_rz_w_leg_6z + D_p_x_3*h_x_w_leg_6z
        + D_p_y_3*h_y_w_leg_6z + D_p_z_3*h_z_w_leg_6z
    )
    M_wq_out[..., 17, 3] = (
        D_p_rx_4*h_rx_w_leg_6z + D_p_ry_4*h_ry_w_leg_6z + D_p_rz_4*h_rz_w_leg_6z + D_p_x_4*h_x_w_leg_6z
        + D_p_y_4*h_y_w_leg_6z + D_p_z_4*h_z_w_leg_6z
    )
    M_wq_out[..., 17, 4] = (
        D_p_rx_5*h_rx_w_leg_6z + D_p_ry_5*h_ry_w_leg_6z + D_p_rz_5*h_rz_w_leg_6z + D_p_x_5*h_x_w_leg_6z
        + D_p_y_5*h_y_w_leg_6z + D_p_z_5*h_z_w_leg_6z
    )
    M_wq_out[..., 17, 5] = (
        D_p_rx_6*h_rx_w_leg_6z + D_p_ry_6*h_ry_w_leg_6z + D_p_rz_6*h_rz_w_leg_6z + D_p_x_6*h_x_w_leg_6z
        + D_p_y_6*h_y_w_leg_6z + D_p_z_6*h_z_w_leg_6z - d_6_z*t302
    )
    M_wq_out[..., 17, 12] = D_delta_ry_18*t289 - D_delta_rz_18*t290 + D_delta_x_18*t291 + h_x_w_leg_6z
    M_wq_out[..., 17, 13] = -D_delta_rx_18*t289 + D_delta_rz_18*t293 + D_delta_y_18*t291 + h_y_w_leg_6z
    M_wq_out[..., 17, 14] = D_delta_rx_18*t290 - D_delta_ry_18*t293 + D_delta_z_18*t291 + h_z_w_leg_6z + t303
    M_ww_out = np.empty((*batch, 18), dtype)
    M_ww_out[..., 0] = (
        D_delta_rx_1*h_rx_w_leg_1x + D_delta_ry_1*h_ry_w_leg_1x + D_delta_ry_1*t264
        + D_delta_rz_1*h_rz_w_leg_1x - D_delta_rz_1*t238 + D_delta_x_1*h_x_w_leg_1x + D_delta_x_1*t228
        + D_delta_y_1*h_y_w_leg_1x + D_delta_z_1*h_z_w_leg_1x + t292
    )
    M_ww_out[..., 1] = (
        D_delta_rx_2*h_rx_w_leg_1y - D_delta_rx_2*t264 + D_delta_ry_2*h_ry_w_leg_1y
        + D_delta_rz_2*h_rz_w_leg_1y + D_delta_rz_2*t282 + D_delta_x_2*h_x_w_leg_1y + D_delta_y_2*h_y_w_leg_1y
        + D_delta_y_2*t228 + D_delta_z_2*h_z_w_leg_1y + t292
    )
    M_ww_out[..., 2] = (
        D_delta_rx_3*h_rx_w_leg_1z + D_delta_rx_3*t238 + D_delta_ry_3*h_ry_w_leg_1z - D_delta_ry_3*t282
        + D_delta_rz_3*h_rz_w_leg_1z + D_delta_x_3*h_x_w_leg_1z + D_delta_y_3*h_y_w_leg_1z
        + D_delta_z_3*h_z_w_leg_1z + D_delta_z_3*t228 + t292
    )
    M_ww_out[..., 3] = (
        D_delta_rx_4*h_rx_w_leg_2x + D_delta_ry_4*h_ry_w_leg_2x + D_delta_ry_4*t267
        + D_delta_rz_4*h_rz_w_leg_2x - D_delta_rz_4*t243 + D_delta_x_4*h_x_w_leg_2x + D_delta_x_4*t229
        + D_delta_y_4*h_y_w_leg_2x + D_delta_z_4*h_z_w_leg_2x + t295
    )
    M_ww_out[..., 4] = (
        D_delta_rx_5*h_rx_w_leg_2y - D_delta_rx_5*t267 + D_delta_ry_5*h_ry_w_leg_2y
        + D_delta_rz_5*h_rz_w_leg_2y + D_delta_rz_5*t283 + D_delta_x_5*h_x_w_leg_2y + D_delta_y_5*h_y_w_leg_2y
        + D_delta_y_5*t229 + D_delta_z_5*h_z_w_leg_2y + t295
    )
    M_ww_out[..., 5] = (
        D_delta_rx_6*h_rx_w_leg_2z + D_delta_rx_6*t243 + D_delta_ry_6*h_ry_w_leg_2z - D_delta_ry_6*t283
        + D_delta_rz_6*h_rz_w_leg_2z + D_delta_x_6*h_x_w_leg_2z + D_delta_y_6*h_y_w_leg_2z
        + D_delta_z_6*h_z_w_leg_2z + D_delta_z_6*t229 + t295
    )
    M_ww_out[..., 6] = (
        D_delta_rx_7*h_rx_w_leg_3x + D_delta_ry_7*h_ry_w_leg_3x + D_delta_ry_7*t270
        + D_delta_rz_7*h_rz_w_leg_3x - D_delta_rz_7*t248 + D_delta_x_7*h_x_w_leg_3x + D_delta_x_7*t230
        + D_delta_y_7*h_y_w_leg_3x + D_delta_z_7*h_z_w_leg_3x + t297
    )
    M_ww_out[..., 7] = (
        D_delta_rx_8*h_rx_w_leg_3y - D_delta_rx_8*t270 + D_delta_ry_8*h_ry_w_leg_3y
        + D_delta_rz_8*h_rz_w_leg_3y + D_delta_rz_8*t284 + D_delta_x_8*h_x_w_leg_3y + D_delta_y_8*h_y_w_leg_3y
        + D_delta_y_8*t230 + D_delta_z_8*h_z_w_leg_3y + t297
    )
    M_ww_out[..., 8] = (
        D_delta_rx_9*h_rx_w_leg_3z + D_delta_rx_9*t248 + D_delta_ry_9*h_ry_w_leg_3z - D_delta_ry_9*t284
        + D_delta_rz_9*h_rz_w_leg_3z + D_delta_x_9*h_x_w_leg_3z + D_delta_y_9*h_y_w_leg_3z
        + D_delta_z_9*h_z_w_leg_3z + D_delta_z_9*t230 + t297
    )
    M_ww_out[..., 9] = (
        D_delta_rx_10*h_rx_w_leg_4x + D_delta_ry_10*h_ry_w_leg_4x + D_delta_ry_10*t273
        + D_delta_rz_10*h_rz_w_leg_4x - D_delta_rz_10*t253 + D_delta_x_10*h_x_w_leg_4x + D_delta_x_10*t231
        + D_delta_y_10*h_y_w_leg_4x + D_delta_z_10*h_z_w_leg_4x + t299
    )
    M_ww_out[..., 10] = (
        D_delta_rx_11*h_rx_w_leg_4y - D_delta_rx_11*t273 + D_delta_ry_11*h_ry_w_leg_4y
        + D_delta_rz_11*h_rz_w_leg_4y + D_delta_rz_11*t285 + D_delta_x_11*h_x_w_leg_4y
        + D_delta_y_11*h_y_w_leg_4y + D_delta_y_11*t231 + D_delta_z_11*h_z_w_leg_4y + t299
    )
    M_ww_out[..., 11] = (
        D_delta_rx_12*h_rx_w_leg_4z + D_delta_rx_12*t253 + D_delta_ry_12*h_ry_w_leg_4z - D_delta_ry_12*t285
        + D_delta_rz_12*h_rz_w_leg_4z + D_delta_x_12*h_x_w_leg_4z + D_delta_y_12*h_y_w_leg_4z
        + D_delta_z_12*h_z_w_leg_4z + D_delta_z_12*t231 + t299
    )
    M_ww_out[..., 12] = (
        D_delta_rx_13*h_rx_w_leg_5x + D_delta_ry_13*h_ry_w_leg_5x + D_delta_ry_13*t276
        + D_delta_rz_13*h_rz_w_leg_5x - D_delta_rz_13*t258 + D_delta_x_13*h_x_w_leg_5x + D_delta_x_13*t232
        + D_delta_y_13*h_y_w_leg_5x + D_delta_z_13*h_z_w_leg_5x + t301
    )
    M_ww_out[..., 13] = (
        D_delta_rx_14*h_rx_w_leg_5y - D_delta_rx_14*t276 + D_delta_ry_14*h_ry_w_leg_5y
        + D_delta_rz_14*h_rz_w_leg_5y + D_delta_rz_14*t286 + D_delta_x_14*h_x_w_leg_5y
        + D_delta_y_14*h_y_w_leg_5y + D_delta_y_14*t232 + D_delta_z_14*h_z_w_leg_5y + t301
    )
    M_ww_out[..., 14] = (
        D_delta_rx_15*h_rx_w_leg_5z + D_delta_rx_15*t258 + D_delta_ry_15*h_ry_w_leg_5z - D_delta_ry_15*t286
        + D_delta_rz_15*h_rz_w_leg_5z + D_delta_x_15*h_x_w_leg_5z + D_delta_y_15*h_y_w_leg_5z
        + D_delta_z_15*h_z_w_leg_5z + D_delta_z_15*t232 + t301
    )
    M_ww_out[..., 15] = (
        D_delta_rx_16*h_rx_w_leg_6x + D_delta_ry_16*h_ry_w_leg_6x + D_delta_ry_16*t279
        + D_delta_rz_16*h_rz_w_leg_6x - D_delta_rz_16*t263 + D_delta_x_16*h_x_w_leg_6x + D_delta_x_16*t233
        + D_delta_y_16*h_y_w_leg_6x + D_delta_z_16*h_z_w_leg_6x + t303
    )
    M_ww_out[..., 16] = (
        D_delta_rx_17*h_rx_w_leg_6y - D_delta_rx_17*t279 + D_delta_ry_17*h_ry_w_leg_6y
        + D_delta_rz_17*h_rz_w_leg_6y + D_delta_rz_17*t287 + D_delta_x_17*h_x_w_leg_6y
        + D_delta_y_17*h_y_w_leg_6y + D_delta_y_17*t233 + D_delta_z_17*h_z_w_leg_6y + t303
    )
    M_ww_out[..., 17] = (
        D_delta_rx_18*h_rx_w_leg_6z + D_delta_rx_18*t263 + D_delta_ry_18*h_ry_w_leg_6z - D_delta_ry_18*t287
        + D_delta_rz_18*h_rz_w_leg_6z + D_delta_x_18*h_x_w_leg_6z + D_delta_y_18*h_y_w_leg_6z
        + D_delta_z_18*h_z_w_leg_6z + D_delta_z_18*t233 + t303
    )
    K_wq_out = np.zeros((*batch, 18, 15), dtype)
    K_wq_out[..., 0, 0] = (
        -D_delta_rx_1*t310 - D_delta_ry_1*t311 - D_delta_rz_1*t312 + D_delta_x_1*t307 + D_delta_y_1*t308
        + D_delta_z_1*t309 + D_p_rx_1*f_rx_w_leg_1x + D_p_ry_1*f_ry_w_leg_1x + D_p_rz_1*f_rz_w_leg_1x
        + D_p_x_1*f_x_w_leg_1x + D_p_x_1*t304 + D_p_y_1*f_y_w_leg_1x + D_p_y_1*t305 + D_p_z_1*f_z_w_leg_1x
        + D_p_z_1*t306 - t307
    )
    K_wq_out[..., 0, 1] = (
        -D_delta_rx_1*t316 - D_delta_ry_1*t317 - D_delta_rz_1*t318 + D_delta_x_1*t313 + D_delta_y_1*t314
        + D_delta_z_1*t315 + D_p_rx_2*f_rx_w_leg_1x + D_p_ry_2*f_ry_w_leg_1x + D_p_rz_2*f_rz_w_leg_1x
        + D_p_x_2*f_x_w_leg_1x + D_p_x_2*t304 + D_p_y_2*f_y_w_leg_1x + D_p_y_2*t305 + D_p_z_2*f_z_w_leg_1x
        + D_p_z_2*t306
    )
    K_wq_out[..., 0, 2] = (
        -D_delta_rx_1*t322 - D_delta_ry_1*t323 - D_delta_rz_1*t324 + D_delta_x_1*t319 + D_delta_y_1*t320
        + D_delta_z_1*t321 + D_p_rx_3*f_rx_w_leg_1x + D_p_ry_3*f_ry_w_leg_1x + D_p_rz_3*f_rz_w_leg_1x
        + D_p_x_3*f_x_w_leg_1x + D_p_x_3*t304 + D_p_y_3*f_y_w_leg_1x + D_p_y_3*t305 + D_p_z_3*f_z_w_leg_1x
        + D_p_z_3*t306
    )
    K_wq_out[..., 0, 3] = (
        -D_delta_rx_1*t328 - D_delta_ry_1*t329 - D_delta_rz_1*t330 + D_delta_x_1*t325 + D_delta_y_1*t326
        + D_delta_z_1*t327 + D_p_rx_4*f_rx_w_leg_1x + D_p_ry_4*f_ry_w_leg_1x + D_p_rz_4*f_rz_w_leg_1x
        + D_p_x_4*f_x_w_leg_1x + D_p_x_4*t304 + D_p_y_4*f_y_w_leg_1x + D_p_y_4*t305 + D_p_z_4*f_z_w_leg_1x
        + D_p_z_4*t306
    )
    K_wq_out[..., 0, 4] = (
        -D_delta_rx_1*t334 - D_delta_ry_1*t335 - D_delta_rz_1*t336 + D_delta_x_1*t331 + D_delta_y_1*t332
        + D_delta_z_1*t333 + D_p_rx_5*f_rx_w_leg_1x + D_p_ry_5*f_ry_w_leg_1x + D_p_rz_5*f_rz_w_leg_1x
        + D_p_x_5*f_x_w_leg_1x + D_p_x_5*t304 + D_p_y_5*f_y_w_leg_1x + D_p_y_5*t305 + D_p_z_5*f_z_w_leg_1x
        + D_p_z_5*t306
    )
    K_wq_out[..., 0, 5] = (
        -D_delta_rx_1*t340 - D_delta_ry_1*t341 - D_delta_rz_1*t342 + D_delta_x_1*t337 + D_delta_y_1*t338
        + D_delta_z_1*t339 + D_p_rx_6*f_rx_w_leg_1x + D_p_ry_6*f_ry_w_leg_1x + D_p_rz_6*f_rz_w_leg_1x
        + D_p_x_6*f_x_w_leg_1x + D_p_x_6*t304 + D_p_y_6*f_y_w_leg_1x + D_p_y_6*t305 + D_p_z_6*f_z_w_leg_1x
        + D_p_z_6*t306
    )
    K_wq_out[..., 0, 12] = t304
    K_wq_out[..., 0, 13] = t305
    K_wq_out[..., 0, 14] = t306
    K_wq_out[..., 1, 0] = (
        -D_delta_rx_2*t310 - D_delta_ry_2*t311 - D_delta_rz_2*t312 + D_delta_x_2*t307 + D_delta_y_2*t308
        + D_delta_z_2*t309 + D_p_rx_1*f_rx_w_leg_1y + D_p_ry_1*f_ry_w_leg_1y + D_p_rz_1*f_rz_w_leg_1y
        + D_p_x_1*f_x_w_leg_1y + D_p_x_1*t343 + D_p_y_1*f_y_w_leg_1y + D_p_y_1*t344 + D_p_z_1*f_z_w_leg_1y
        + D_p_z_1*t345 - t308
    )
    K_wq_out[..., 1, 1] = (
        -D_delta_rx_2*t316 - D_delta_ry_2*t317 - D_delta_rz_2*t318 + D_delta_x_2*t313 + D_delta_y_2*t314
        + D_delta_z_2*t315 + D_p_rx_2*f_rx_w_leg_1y + D_p_ry_2*f_ry_w_leg_1y + D_p_rz_2*f_rz_w_leg_1y
        + D_p_x_2*f_x_w_leg_1y + D_p_x_2*t343 + D_p_y_2*f_y_w_leg_1y + D_p_y_2*t344 + D_p_z_2*f_z_w_leg_1y
        + D_p_z_2*t345
    )
    K_wq_out[..., 1, 2] = (
        -D_delta_rx_2*t322 - D_delta_ry_2*t323 - D_delta_rz_2*t324 + D_delta_x_2*t319 + D_delta_y_2*t320
        + D_delta_z_2*t321 + D_p_rx_3*f_rx_w_leg_1y + D_p_ry_3*f_ry_w_leg_1y + D_p_rz_3*f_rz_w_leg_1y
        + D_p_x_3*f_x_w_leg_1y + D_p_x_3*t343 + D_p_y_3*f_y_w_leg_1y + D_p_y_3*t344 + D_p_z_3*f_z_w_leg_1y
        + D_p_z_3*t345
    )
    K_wq_out[..., 1, 3] = (
        -D_delta_rx_2*t328 - D_delta_ry_2*t329 - D_delta_rz_2*t330 + D_delta_x_2*t325 + D_delta_y_2*t326
        + D_delta_z_2*t327 + D_p_rx_4*f_rx_w_leg_1y + D_p_ry_4*f_ry_w_leg_1y + D_p_rz_4*f_rz_w_leg_1y
        + D_p_x_4*f_x_w_leg_1y + D_p_x_4*t343 + D_p_y_4*f_y_w_leg_1y + D_p_y_4*t344 + D_p_z_4*f_z_w_leg_1y
        + D_p_z_4*t345
    )
    K_wq_out[..., 1, 4] = (
        -D_delta_rx_2*t334 - D_delta_ry_2*t335 - D_delta_rz_2*t336 + D_delta_x_2*t331 + D_delta_y_2*t332
        + D_delta_z_2*t333 + D_p_rx_5*f_rx_w_leg_1y + D_p_ry_5*f_ry_w_leg_1y + D_p_rz_5*f_rz_w_leg_1y
        + D_p_x_5*f_x_w_leg_1y + D_p_x_5*t343 + D_p_y_5*f_y_w_leg_1y + D_p_y_5*t344 + D_p_z_5*f_z_w_leg_1y
        + D_p_z_5*t345
    )
    K_wq_out[..., 1, 5] = (
        -D_delta_rx_2*t340 - D_delta_ry_2*t341 - D_delta_rz_2*t342 + D_delta_x_2*t337 + D_delta_y_2*t338
        + D_delta_z_2*t339 + D_p_rx_6*f_rx_w_leg_1y + D_p_ry_6*f_ry_w_leg_1y + D_p_rz_6*f_rz_w_leg_1y
        + D_p_x_6*f_x_w_leg_1y + D_p_x_6*t343 + D_p_y_6*f_y_w_leg_1y + D_p_y_6*t344 + D_p_z_6*f_z_w_leg_1y
        + D_p_z_6*t345
    )
    K_wq_out[..., 1, 12] = t343
    K_wq_out[..., 1, 13] = t344
    K_wq_out[..., 1, 14] = t345
    K_wq_out[..., 2, 0] = (
        -D_delta_rx_3*t310 - D_delta_ry_3*t311 - D_delta_rz_3*t312 + D_delta_x_3*t307 + D_delta_y_3*t308
        + D_delta_z_3*t309 + D_p_rx_1*f_rx_w_leg_1z + D_p_ry_1*f_ry_w_leg_1z + D_p_rz_1*f_rz_w_leg_1z
        + D_p_x_1*f_x_w_leg_1z + D_p_x_1*t346 + D_p_y_1*f_y_w_leg_1z + D_p_y_1*t347 + D_p_z_1*f_z_w_leg_1z
        + D_p_z_1*t348 - t309
    )
    K_wq_out[..., 2, 1] = (
        -D_delta_rx_3*t316 - D_delta_ry_3*t317 - D_delta_rz_3*t318 + D_delta_x_3*t313 + D_delta_y_3*t314
        + D_delta_z_3*t315 + D_p_rx_2*f_rx_w_leg_1z + D_p_ry_2*f_ry_w_leg_1z + D_p_rz_2*f_rz_w_leg_1z
        + D_p_x_2*f_x_w_leg_1z + D_p_x_2*t346 + D_p_y_2*f_y_w_leg_1z + D_p_y_2*t347 + D_p_z_2*f_z_w_leg_1z
        + D_p_z_2*t348
    )
    K_wq_out[..., 2, 2] = (
        -D_delta_rx_3*t322 - D_delta_ry_3*t323 - D_delta_rz_3*t324 + D_delta_x_3*t319 + D_delta_y_3*t320
        + D_delta_z_3*t321 + D_p_rx_3*f_rx_w_leg_1z + D_p_ry_3*f_ry_w_leg_1z + D_p_rz_3*f_rz_w_leg_1z
        + D_p_x_3*f_x_w_leg_1z + D_p_x_3*t346 + D_p_y_3*f_y_w_leg_1z + D_p_y_3*t347 + D_p_z_3*f_z_w_leg_1z
        + D_p_z_3*t348
    )
    K_wq_out[..., 2, 3] = (
        -D_delta_rx_3*t328 - D_delta_ry_3*t329 - D_delta_rz_3*t330 + D_delta_x_3*t325 + D_delta_y_3*t326
        + D_delta_z_3*t327 + D_p_rx_4*f_rx_w_leg_1z + D_p_ry_4*f_ry_w_leg_1z + D_p_rz_4*f_rz_w_leg_1z
        + D_p_x_4*f_x_w_leg_1z + D_p_x_4*t346 + D_p_y_4*f_y_w_leg_1z + D_p_y_4*t347 + D_p_z_4*f_z_w_leg_1z
        + D_p_z_4*t348
    )
    K_wq_out[..., 2, 4] = (
        -D_delta_rx_3*t334 - D_delta_ry_3*t335 - D_delta_rz_3*t336 + D_delta_x_3*t331 + D_delta_y_3*t332
        + D_delta_z_3*t333 + D_p_rx_5*f_rx_w_leg_1z + D_p_ry_5*f_ry_w_leg_1z + D_p_rz_5*f_rz_w_leg_1z
        + D_p_x_5*f_x_w_leg_1z + D_p_x_5*t346 + D_p_y_5*f_y_w_leg_1z + D_p_y_5*t347 + D_p_z_5*f_z_w_leg_1z
        + D_p_z_5*t348
    )
    K_wq_out[..., 2, 5] = (
        -D_delta_rx_3*t340 - D_delta_ry_3*t341 - D_delta_rz_3*t342 + D_delta_x_3*t337 + D_delta_y_3*t338
        + D_delta_z_3*t339 + D_p_rx_6*f_rx_w_leg_1z + D_p_ry_6*f_ry_w_leg_1z + D_p_rz_6*f_rz_w_leg_1z
        + D_p_x_6*f_x_w_leg_1z + D_p_x_6*t346 + D_p_y_6*f_y_w_leg_1z + D_p_y_6*t347 + D_p_z_6*f_z_w_leg_1z
        + D_p_z_6*t348
    )
    K_wq_out[..., 2, 12] = t346
    K_wq_out[..., 2, 13] = t347
    K_wq_out[..., 2, 14] = t348
    K_wq_out[..., 3, 0] = (
        -D_delta_rx_4*t310 - D_delta_ry_4*t311 - D_delta_rz_4*t312 + D_delta_x_4*t307 + D_delta_y_4*t308
        + D_delta_z_4*t309 + D_p_rx_1*f_rx_w_leg_2x + D_p_ry_1*f_ry_w_leg_2x + D_p_rz_1*f_rz_w_leg_2x
        + D_p_x_1*f_x_w_leg_2x + D_p_x_1*t349 + D_p_y_1*f_y_w_leg_2x + D_p_y_1*t350 + D_p_z_1*f_z_w_leg_2x
        + D_p_z_1*t351
    )
    K_wq_out[..., 3, 1] = (
        -D_delta_rx_4*t316 - D_delta_ry_4*t317 - D_delta_rz_4*t318 + D_delta_x_4*t313 + D_delta_y_4*t314
        + D_delta_z_4*t315 + D_p_rx_2*f_rx_w_leg_2x + D_p_ry_2*f_ry_w_leg_2x + D_p_rz_2*f_rz_w_leg_2x
        + D_p_x_2*f_x_w_leg_2x + D_p_x_2*t349 + D_p_y_2*f_y_w_leg_2x + D_p_y_2*t350 + D_p_z_2*f_z_w_leg_2x
        + D_p_z_2*t351 - t313
    )
    K_wq_out[..., 3, 2] = (
        -D_delta_rx_4*t322 - D_delta_ry_4*t323 - D_delta_rz_4*t324 + D_delta_x_4*t319 + D_delta_y_4*t320
        + D_delta_z_4*t321 + D_p_rx_3*f_rx_w_leg_2x + D_p_ry_3*f_ry_w_leg_2x + D_p_rz_3*f_rz_w_leg_2x
        + D_p_x_3*f_x_w_leg_2x + D_p_x_3*t349 + D_p_y_3*f_y_w_leg_2x + D_p_y_3*t350 + D_p_z_3*f_z_w_leg_2x
        + D_p_z_3*t351
    )
    K_wq_out[..., 3, 3] = (
        -D_delta_rx_4*t328 - D_delta_ry_4*t329 - D_delta_rz_4*t330 + D_delta_x_4*t325 + D_delta_y_4*t326
        + D_delta_z_4*t327 + D_p_rx_4*f_rx_w_leg_2x + D_p_ry_4*f_ry_w_leg_2x + D_p_rz_4*f_rz_w_leg_2x
        + D_p_x_4*f_x_w_leg_2x + D_p_x_4*t349 + D_p_y_4*f_y_w_leg_2x + D_p_y_4*t350 + D_p_z_4*f_z_w_leg_2x
        + D_p_z_4*t351
    )
    K_wq_out[..., 3, 4] = (
        -D_delta_rx_4*t334 - D_delta_ry_4*t335 - D_delta_rz_4*t336 + D_delta_x_4*t331 + D_delta_y_4*t332
        + D_delta_z_4*t333 + D_p_rx_5*f_rx_w_leg_2x + D_p_ry_5*f_ry_w_leg_2x + D_p_rz_5*f_rz_w_leg_2x
        + D_p_x_5*f_x_w_leg_2x + D_p_x_5*t349 + D_p_y_5*f_y_w_leg_2x + D_p_y_5*t350 + D_p_z_5*f_z_w_leg_2x
        + D_p_z_5*t351
    )
    K_wq_out[..., 3, 5] = (
        -D_delta_rx_4*t340 - D_delta_ry_4*t341 - D_delta_rz_4*t342 + D_delta_x_4*t337 + D_delta_y_4*t338
        + D_delta_z_4*t339 + D_p_rx_6*f_rx_w_leg_2x + D_p_ry_6*f_ry_w_leg_2x + D_p_rz_6*f_rz_w_leg_2x
        + D_p_x_6*f_x_w_leg_2x + D_p_x_6*t349 + D_p_y_6*f_y_w_leg_2x + D_p_y_6*t350 + D_p_z_6*f_z_w_leg_2x
        + D_p_z_6*t351
    )
    K_wq_out[..., 3, 12] = t349
    K_wq_out[..., 3, 13] = t350
    K_wq_out[..., 3, 14] = t351
    K_wq_out[..., 4, 0] = (
        -D_delta_rx_5*t310 - D_delta_ry_5*t311 - D_delta_rz_5*t312 + D_delta_x_5*t307 + D_delta_y_5*t308
        + D_delta_z_5*t309 + D_p_rx_1*f_rx_w_leg_2y + D_p_ry_1*f_ry_w_leg_2y + D_p_rz_1*f_rz_w_leg_2y
        + D_p_x_1*f_x_w_leg_2y + D_p_x_1*t352 + D_p_y_1*f_y_w_leg_2y + D_p_y_1*t353 + D_p_z_1*f_z_w_leg_2y
        + D_p_z_1*t354
    )
    K_wq_out[..., 4, 1] = (
        -D_delta_rx_5*t316 - D_delta_ry_5*t317 - D_delta_rz_5*t318 + D_delta_x_5*t313 + D_delta_y_5*t314
        + D_delta_z_5*t315 + D_p_rx_2*f_rx_w_leg_2y + D_p_ry_2*f_ry_w_leg_2y + D_p_rz_2*f_rz_w_leg_2y
        + D_p_x_2*f_x_w_leg_2y + D_p_x_2*t352 + D_p_y_2*f_y_w_leg_2y + D_p_y_2*t353 + D_p_z_2*f_z_w_leg_2y
        + D_p_z_2*t354 - t314
    )
    K_wq_out[..., 4, 2] = (
        -D_delta_rx_5*t322 - D_delta_ry_5*t323 - D_delta_rz_5*t324 + D_delta_x_5*t319 + D_delta_y_5*t320
        + D_delta_z_5*t321 + D_p_rx_3*f_rx_w_leg_2y + D_p_ry_3*f_ry_w_leg_2y + D_p_rz_3*f_rz_w_leg_2y
        + D_p_x_3*f_x_w_leg_2y + D_p_x_3*t352 + D_p_y_3*f_y_w_leg_2y + D_p_y_3*t353 + D_p_z_3*f_z_w_leg_2y
        + D_p_z_3*t354
    )
    K_wq_out[..., 4, 3] = (
        -D_delta_rx_5*t328 - D_delta_ry_5*t329 - D_delta_rz_5*t330 + D_delta_x_5*t325 + D_delta_y_5*t326
        + D_delta_z_5*t327 + D_p_rx_4*f_rx_w_leg_2y + D_p_ry_4*f_ry_w_leg_2y + D_p_rz_4*f_rz_w_leg_2y
        + D_p_x_4*f_x_w_leg_2y + D_p_x_4*t352 + D_p_y_4*f_y_w_leg_2y + D_p_y_4*t353 + D_p_z_4*f_z_w_leg_2y
        + D_p_z_4*t354
    )
    K_wq_out[..., 4, 4] = (
        -D_delta_rx_5*t334 - D_delta_ry_5*t335 - D_delta_rz_5*t336 + D_delta_x_5*t331 + D_delta_y_5*t332
        + D_delta_z_5*t333 + D_p_rx_5*f_rx_w_leg_2y + D_p_ry_5*f_ry_w_leg_2y + D_p_rz_5*f_rz_w_leg_2y
        + D_p_x_5*f_x_w_leg_2y + D_p_x_5*t352 + D_p_y_5*f_y_w_leg_2y + D_p_y_5*t353 + D_p_z_5*f_z_w_leg_2y
        + D_p_z_5*t354
    )
    K_wq_out[..., 4, 5] = (
        -D_delta_rx_5*t340 - D_delta_ry_5*t341 - D_delta_rz_5*t342 + D_delta_x_5*t337 + D_delta_y_5*t338
        + D_delta_z_5*t339 + D_p_rx_6*f_rx_w_leg_2y + D_p_ry_6*f_ry_w_leg_2y + D_p_rz_6*f_rz_w_leg_2y
        + D_p_x_6*f_x_w_leg_2y + D_p_x_6*t352 + D_p_y_6*f_y_w_leg_2y + D_p_y_6*t353 + D_p_z_6*f_z_w_leg_2y
        + D_p_z_6*t354
    )
    K_wq_out[..., 4, 12] = t352
    K_wq_out[..., 4, 13] = t353
    K_wq_out[..., 4, 14] = t354
    K_wq_out[..., 5, 0] = (
        -D_delta_rx_6*t310 - D_delta_ry_6*t311 - D_delta_rz_6*t312 + D_delta_x_6*t307 + D_delta_y_6*t308
        + D_delta_z_6*t309 + D_p_rx_1*f_rx_w_leg_2z + D_p_ry_1*f_ry_w_leg_2z + D_p_rz_1*f_rz_w_leg_2z
        + D_p_x_1*f_x_w_leg_2z + D_p_x_1*t355 + D_p_y_1*f_y_w_leg_2z + D_p_y_1*t356 + D_p_z_1*f_z_w_leg_2z
        + D_p_z_1*t357
    )
    K_wq_out[..., 5, 1] = (
        -D_delta_rx_6*t316 - D_delta_ry_6*t317 - D_delta_rz_6*t318 + D_delta_x_6*t313 + D_delta_y_6*t314
        + D_delta_z_6*t315 + D_p_rx_2*f_rx_w_leg_2z + D_p_ry_2*f_ry_w_leg_2z + D_p_rz_2*f_rz_w_leg_2z
        + D_p_x_2*f_x_w_leg_2z + D_p_x_2*t355 + D_p_y_2*f_y_w_leg_2z + D_p_y_2*t356 + D_p_z_2*f_z_w_leg_2z
        + D_p_z_2*t357 - t315
    )
    K_wq_out[..., 5, 2] = (
        -D_delta_rx_6*t322 - D_delta_ry_6*t323 - D_delta_rz_6*t324 + D_delta_x_6*t319 + D_delta_y_6*t320
        + D_delta_z_6*t321 + D_p_rx_3*f_rx_w_leg_2z + D_p_ry_3*f_ry_w_leg_2z + D_p_rz_3*f_rz_w_leg_2z
        + D_p_x_3*f_x_w_leg_2z + D_p_x_3*t355 + D_p_y_3*f_y_w_leg_2z + D_p_y_3*t356 + D_p_z_3*f_z_w_leg_2z
        + D_p_z_3*t357
    )
    K_wq_out[..., 5, 3] = (
        -D_delta_rx_6*t328 - D_delta_ry_6*t329 - D_delta_rz_6*t330 + D_delta_x_6*t325 + D_delta_y_6*t326
        + D_delta_z_6*t327 + D_p_rx_4*f_rx_w_leg_2z + D_p_ry_4*f_ry_w_leg_2z + D_p_rz_4*f_rz_w_leg_2z
        + D_p_x_4*f_x_w_leg_2z + D_p_x_4*t355 + D_p_y_4*f_y_w_leg_2z + D_p_y_4*t356 + D_p_z_4*f_z_w_leg_2z
        + D_p_z_4*t357
    )
    K_wq_out[..., 5, 4] = (
        -D_delta_rx_6*t334 - D_delta_ry_6*t335 - D_delta_rz_6*t336 + D_delta_x_6*t331 + D_delta_y_6*t332
        + D_delta_z_6*t333 + D_p_rx_5*f_rx_w_leg_2z + D_p_ry_5*f_ry_w_leg_2z + D_p_rz_5*f_rz_w_leg_2z
        + D_p_x_5*f_x_w_leg_2z + D_p_x_5*t355 + D_p_y_5*f_y_w_leg_2z + D_p_y_5*t356 + D_p_z_5*f_z_w_leg_2z
        + D_p_z_5*t357
    )
    K_wq_out[..., 5, 5] = (
        -D_delta_rx_6*t340 - D_delta_ry_6*t341 - D_delta_rz_6*t342 + D_delta_x_6*t337 + D_delta_y_6*t338
        + D_delta_z_6*t339 + D_p_rx_6*f_rx_w_leg_2z + D_p_ry_6*f_ry_w_leg_2z + D_p_rz_6*f_rz_w_leg_2z
        + D_p_x_6*f_x_w_leg_2z + D_p_x_6*t355 + D_p_y_6*f_y_w_leg_2z + D_p_y_6*t356 + D_p_z_6*f_z_w_leg_2z
        + D_p_z_6*t357
    )
    K_wq_out[..., 5, 12] = t355
    K_wq_out[..., 5, 13] = t356
    K_wq_out[..., 5, 14] = t357
    K_wq_out[..., 6, 0] = (
        -D_delta_rx_7*t310 - D_delta_ry_7*t311 - D_delta_rz_7*t312 + D_delta_x_7*t307 + D_delta_y_7*t308
        + D_delta_z_7*t309 + D_p_rx_1*f_rx_w_leg_3x + D_p_ry_1*f_ry_w_leg_3x + D_p_rz_1*f_rz_w_leg_3x
        + D_p_x_1*f_x_w_leg_3x + D_p_x_1*t358 + D_p_y_1*f_y_w_leg_3x + D_p_y_1*t359 + D_p_z_1*f_z_w_leg_3x
        + D_p_z_1*t360
    )
    K_wq_out[..., 6, 1] = (
        -D_delta_rx_7*t316 - D_delta_ry_7*t317 - D_delta_rz_7*t318 + D_delta_x_7*t313 + D_delta_y_7*t314
        + D_delta_z_7*t315 + D_p_rx_2*f_rx_w_leg_3x + D_p_ry_2*f_ry_w_leg_3x + D_p_rz_2*f_rz_w_leg_3x
        + D_p_x_2*f_x_w_leg_3x + D_p_x_2*t358 + D_p_y_2*f_y_w_leg_3x + D_p_y_2*t359 + D_p_z_2*f_z_w_leg_3x
        + D_p_z_2*t360
    )
    K_wq_out[..., 6, 2] = (
        -D_delta_rx_7*t322 - D_delta_ry_7*t323 - D_delta_rz_7*t324 + D_delta_x_7*t319 + D_delta_y_7*t320
        + D_delta_z_7*t321 + D_p_rx_3*f_rx_w_leg_3x + D_p_ry_3*f_ry_w_leg_3x + D_p_rz_3*f_rz_w_leg_3x
        + D_p_x_3*f_x_w_leg_3x + D_p_x_3*t358 + D_p_y_3*f_y_w_leg_3x + D_p_y_3*t359 + D_p_z_3*f_z_w_leg_3x
        + D_p_z_3*t360 - t319
    )
    K_wq_out[..., 6, 3] = (
        -D_delta_rx_7*t328 - D_delta_ry_7*t329 - D_delta_rz_7*t330 + D_delta_x_7*t325 + D_delta_y_7*t326
        + D_delta_z_7*t327 + D_p_rx_4*f_rx_w_leg_3x + D_p_ry_4*f_ry_w_leg_3x + D_p_rz_4*f_rz_w_leg_3x
        + D_p_x_4*f_x_w_leg_3x + D_p_x_4*t358 + D_p_y_4*f_y_w_leg_3x + D_p_y_4*t359 + D_p_z_4*f_z_w_leg_3x
        + D_p_z_4*t360
    )
    K_wq_out[..., 6, 4] = (
        -D_delta_rx_7*t334 - D_delta_ry_7*t335 - D_delta_rz_7*t336 + D_delta_x_7*t331 + D_delta_y_7*t332
        + D_delta_z_7*t333 + D_p_rx_5*f_rx_w_leg_3x + D_p_ry_5*f_ry_w_leg_3x + D_p_rz_5*f_rz_w_leg_3x
        + D_p_x_5*f_x_w_leg_3x + D_p_x_5*t358 + D_p_y_5*f_y_w_leg_3x + D_p_y_5*t359 + D_p_z_5*f_z_w_leg_3x
        + D_p_z_5*t360
    )
    K_wq_out[..., 6, 5] = (
        -D_delta_rx_7*t340 - D_delta_ry_7*t341 - D_delta_rz_7*t342 + D_delta_x_7*t337 + D_delta_y_7*t338
        + D_delta_z_7*t339 + D_p_rx_6*f_rx_w_leg_3x + D_p_ry_6*f_ry_w_leg_3x + D_p_rz_6*f_rz_w_leg_3x
        + D_p_x_6*f_x_w_leg_3x + D_p_x_6*t358 + D_p_y_6*f_y_w_leg_3x + D_p_y_6*t359 + D_p_z_6*f_z_w_leg_3x
        + D_p_z_6*t360
    )
    K_wq_out[..., 6, 12] = t358
    K_wq_out[..., 6, 13] = t359
    K_wq_out[..., 6, 14] = t360
    K_wq_out[..., 7, 0] = (
        -D_delta_rx_8*t310 - D_delta_ry_8*t311 - D_delta_rz_8*t312 + D_delta_x_8*t307 + D_delta_y_8*t308
        + D_delta_z_8*t309 + D_p_rx_1*f_rx_w_leg_3y + D_p_ry_1*f_ry_w_leg_3y + D_p_rz_1*f_rz_w_leg_3y
        + D_p_x_1*f_x_w_leg_3y + D_p_x_1*t361 + D_p_y_1*f_y_w_leg_3y + D_p_y_1*t362 + D_p_z_1*f_z_w_leg_3y
        + D_p_z_1*t363
    )
    K_wq_out[..., 7, 1] = (
        -D_delta_rx_8*t316 - D_delta_ry_8*t317 - D_delta_rz_8*t318 + D_delta_x_8*t313 + D_delta_y_8*t314
        + D_delta_z_8*t315 + D_p_rx_2*f_rx_w_leg_3y + D_p_ry_2*f_ry_w_leg_3y + D_p_rz_2*f_rz_w_leg_3y
        + D_p_x_2*f_x_w_leg_3y + D_p_x_2*t361 + D_p_y_2*f_y_w_leg_3y + D_p_y_2*t362 + D_p_z_2*f_z_w_leg_3y
        + D_p_z_2*t363
    )
    K_wq_out[..., 7, 2] = (
        -D_delta_rx_8*t322 - D_delta_ry_8*t323 - D_delta_rz_8*t324 + D_delta_x_8*t319 + D_delta_y_8*t320
        + D_delta_z_8*t321 + D_p_rx_3*f_rx_w_leg_3y + D_p_ry_3*f_ry_w_leg_3y + D_p_rz_3*f_rz_w_leg_3y
        + D_p_x_3*f_x_w_leg_3y + D_p_x_3*t361 + D_p_y_3*f_y_w_leg_3y + D_p_y_3*t362 + D_p_z_3*f_z_w_leg_3y
        + D_p_z_3*t363 - t320
    )
    K_wq_out[..., 7, 3] = (
        -D_delta_rx_8*t328 - D_delta_ry_8*t329 - D_delta_rz_8*t330 + D_delta_x_8*t325 + D_delta_y_8*t326
        + D_delta_z_8*t327 + D_p_rx_4*f_rx_w_leg_3y + D_p_ry_4*f_ry_w_leg_3y + D_p_rz_4*f_rz_w_leg_3y
        + D_p_x_4*f_x_w_leg_3y + D_p_x_4*t361 + D_p_y_4*f_y_w_leg_3y + D_p_y_4*t362 + D_p_z_4*f_z_w_leg_3y
        + D_p_z_4*t363
    )
    K_wq_out[..., 7, 4] = (
        -D_delta_rx_8*t334 - D_delta_ry_8*t335 - D_delta_rz_8*t336 + D_delta_x_8*t331 + D_delta_y_8*t332
        + D_delta_z_8*t333 + D_p_rx_5*f_rx_w_leg_3y + D_p_ry_5*f_ry_w_leg_3y + D_p_rz_5*f_rz_w_leg_3y
        + D_p_x_5*f_x_w_leg_3y + D_p_x_5*t361 + D_p_y_5*f_y_w_leg_3y + D_p_y_5*t362 + D_p_z_5*f_z_w_leg_3y
        + D_p_z_5*t363
    )
    K_wq_out[..., 7, 5] = (
        -D_delta_rx_8*t340 - D_delta_ry_8*t341 - D_delta_rz_8*t342 + D_delta_x_8*t337 + D_delta_y_8*t338
        + D_delta_z_8*t339 + D_p_rx_6*f_rx_w_leg_3y + D_p_ry_6*f_ry_w_leg_3y + D_p_rz_6*f_rz_w_leg_3y
        + D_p_x_6*f_x_w_leg_3y + D_p_x_6*t361 + D_p_y_6*f_y_w_leg_3y + D_p_y_6*t362 + D_p_z_6*f_z_w_leg_3y
        + D_p_z_6*t363
    )
    K_wq_out[..., 7, 12] = t361
    K_wq_out[..., 7, 13] = t362
    K_wq_out[..., 7, 14] = t363
    K_wq_out[..., 8, 0] = (
        -D_delta_rx_9*t310 - D_delta_ry_9*t311 - D_delta_rz_9*t312 + D_delta_x_9*t307 + D_delta_y_9*t308
        + D_delta_z_9*t309 + D_p_rx_1*f_rx_w_leg_3z + D_p_ry_1*f_ry_w_leg_3z + D_p_rz_1*f_rz_w_leg_3z
        + D_p_x_1*f_x_w_leg_3z + D_p_x_1*t364 + D_p_y_1*f_y_w_leg_3z + D_p_y_1*t365 + D_p_z_1*f_z_w_leg_3z
        + D_p_z_1*t366
    )
    K_wq_out[..., 8, 1] = (
        -D_delta_rx_9*t316 - D_delta_ry_9*t317 - D_delta_rz_9*t318 + D_delta_x_9*t313 + D_delta_y_9*t314
        + D_delta_z_9*t315 + D_p_rx_2*f_rx_w_leg_3z + D_p_ry_2*f_ry_w_leg_3z + D_p_rz_2*f_rz_w_leg_3z
        + D_p_x_2*f_x_w_leg_3z + D_p_x_2*t364 + D_p_y_2*f_y_w_leg_3z + D_p_y_2*t365 + D_p_z_2*f_z_w_leg_3z
        + D_p_z_2*t366
    )
    K_wq_out[..., 8, 2] = (
        -D_delta_rx_9*t322 - D_delta_ry_9*t323 - D_delta_rz_9*t324 + D_delta_x_9*t319 + D_delta_y_9*t320
        + D_delta_z_9*t321 + D_p_rx_3*f_rx_w_leg_3z + D_p_ry_3*f_ry_w_leg_3z + D_p_rz_3*f_rz_w_leg_3z
        + D_p_x_3*f_x_w_leg_3z + D_p_x_3*t364 + D_p_y_3*f_y_w_leg_3z + D_p_y_3*t365 + D_p_z_3*f_z_w_leg_3z
        + D_p_z_3*t366 - t321
    )
    K_wq_out[..., 8, 3] = (
        -D_delta_rx_9*t328 - D_delta_ry_9*t329 - D_delta_rz_9*t330 + D_delta_x_9*t325 + D_delta_y_9*t326
        + D_delta_z_9*t327 + D_p_rx_4*f_rx_w_leg_3z + D_p_ry_4*f_ry_w_leg_3z + D_p_rz_4*f_rz_w_leg_3z
        + D_p_x_4*f_x_w_leg_3z + D_p_x_4*t364 + D_p_y_4*f_y_w_leg_3z + D_p_y_4*t365 + D_p_z_4*f_z_w_leg_3z
        + D_p_z_4*t366
    )
    K_wq_out[..., 8, 4] = (
        -D_delta_rx_9*t334 - D_delta_ry_9*t335 - D_delta_rz_9*t336 + D_delta_x_9*t331 + D_delta_y_9*t332
        + D_delta_z_9*t333 + D_p_rx_5*f_rx_w_leg_3z + D_p_ry_5*f_ry_w_leg_3z + D_p_rz_5*f_rz_w_leg_3z
        + D_p_x_5*f_x_w_leg_3z + D_p_x_5*t364 + D_p_y_5*f_y_w_leg_3z + D_p_y_5*t365 + D_p_z_5*f_z_w_leg_3z
        + D_p_z_5*t366
    )
    K_wq_out[..., 8, 5] = (
        -D_delta_rx_9*t340 - D_delta_ry_9*t341 - D_delta_rz_9*t342 + D_delta_x_9*t337 + D_delta_y_9*t338
        + D_delta_z_9*t339 + D_p_rx_6*f_rx_w_leg_3z + D_p_ry_6*f_ry_w_leg_3z + D_p_rz_6*f_rz_w_leg_3z
        + D_p_x_6*f_x_w_leg_3z + D_p_x_6*t364 + D_p_y_6*f_y_w_leg_3z + D_p_y_6*t365 + D_p_z_6*f_z_w_leg_3z
        + D_p_z_6*t366
    )
    K_wq_out[..., 8, 12] = t364
    K_wq_out[..., 8, 13] = t365
    K_wq_out[..., 8, 14] = t366
    K_wq_out[..., 9, 0] = (
        -D_delta_rx_10*t310 - D_delta_ry_10*t311 - D_delta_rz_10*t312 + D_delta_x_10*t307 + D_delta_y_10*t308
        + D_delta_z_10*t309 + D_p_rx_1*f_rx_w_leg_4x + D_p_ry_1*f_ry_w_leg_4x + D_p_rz_1*f_rz_w_leg_4x
        + D_p_x_1*f_x_w_leg_4x + D_p_x_1*t367 + D_p_y_1*f_y_w_leg_4x + D_p_y_1*t368 + D_p_z_1*f_z_w_leg_4x
        + D_p_z_1*t369
    )
    K_wq_out[..., 9, 1] = (
        -D_delta_rx_10*t316 - D_delta_ry_10*t317 - D_delta_rz_10*t318 + D_delta_x_10*t313 + D_delta_y_10*t314
        + D_delta_z_10*t315 + D_p_rx_2*f_rx_w_leg_4x + D_p_ry_2*f_ry_w_leg_4x + D_p_rz_2*f_rz_w_leg_4x
        + D_p_x_2*f_x_w_leg_4x + D_p_x_2*t367 + D_p_y_2*f_y_w_leg_4x + D_p_y_2*t368 + D_p_z_2*f_z_w_leg_4x
        + D_p_z_2*t369
    )
    K_wq_out[..., 9, 2] = (
        -D_delta_rx_10*t322 - D_delta_ry_10*t323 - D_delta_rz_10*t324 + D_delta_x_10*t319 + D_delta_y_10*t320
        + D_delta_z_10*t321 + D_p_rx_3*f_rx_w_leg_4x + D_p_ry_3*f_ry_w_leg_4x + D_p_rz_3*f_rz_w_leg_4x
        + D_p_x_3*f_x_w_leg_4x + D_p_x_3*t367 + D_p_y_3*f_y_w_leg_4x + D_p_y_3*t368 + D_p_z_3*f_z_w_leg_4x
        + D_p_z_3*t369
    )
    K_wq_out[..., 9, 3] = (
        -D_delta_rx_10*t328 - D_delta_ry_10*t329 - D_delta_rz_10*t330 + D_delta_x_10*t325 + D_delta_y_10*t326
        + D_delta_z_10*t327 + D_p_rx_4*f_rx_w_leg_4x + D_p_ry_4*f_ry_w_leg_4x + D_p_rz_4*f_rz_w_leg_4x
        + D_p_x_4*f_x_w_leg_4x + D_p_x_4*t367 + D_p_y_4*f_y_w_leg_4x + D_p_y_4*t368 + D_p_z_4*f_z_w_leg_4x
        + D_p_z_4*t369 - t325
    )
    K_wq_out[..., 9, 4] = (
        -D_delta_rx_10*t334 - D_delta_ry_10*t335 - D_delta_rz_10*t336 + D_delta_x_10*t331 + D_delta_y_10*t332
        + D_delta_z_10*t333 + D_p_rx_5*f_rx_w_leg_4x + D_p_ry_5*f_ry_w_leg_4x + D_p_rz_5*f_rz_w_leg_4x
        + D_p_x_5*f_x_w_leg_4x + D_p_x_5*t367 + D_p_y_5*f_y_w_leg_4x + D_p_y_5*t368 + D_p_z_5*f_z_w_leg_4x
        + D_p_z_5*t369
    )
    K_wq_out[..., 9, 5] = (
        -D_delta_rx_10*t340 - D_delta_ry_10*t341 - D_delta_rz_10*t342 + D_delta_x_10*t337 + D_delta_y_10*t338
        + D_delta_z_10*t339 + D_p_rx_6*f_rx_w_leg_4x + D_p_ry_6*f_ry_w_leg_4x + D_p_rz_6*f_rz_w_leg_4x
        + D_p_x_6*f_x_w_leg_4x + D_p_x_6*t367 + D_p_y_6*f_y_w_leg_4x + D_p_y_6*t368 + D_p_z_6*f_z_w_leg_4x
        + D_p_z_6*t369
    )
    K_wq_out[..., 9, 12] = t367
    K_wq_out[..., 9, 13] = t368
    K_wq_out[..., 9, 14] = t369
    K_wq_out[..., 10, 0] = (
        -D_delta_rx_11*t310 - D_delta_ry_11*t311 - D_delta_rz_11*t312 + D_delta_x_11*t307 + D_delta_y_11*t308
        + D_delta_z_11*t309 + D_p_rx_1*f_rx_w_leg_4y + D_p_ry_1*f_ry_w_leg_4y + D_p_rz_1*f_rz_w_leg_4y
        + D_p_x_1*f_x_w_leg_4y + D_p_x_1*t370 + D_p_y_1*f_y_w_leg_4y + D_p_y_1*t371 + D_p_z_1*f_z_w_leg_4y
        + D_p_z_1*t372
    )
    K_wq_out[..., 10, 1] = (
        -D_delta_rx_11*t316 - D_delta_ry_11*t317 - D_delta_rz_11*t318 + D_delta_x_11*t313 + D_delta_y_11*t314
        + D_delta_z_11*t315 + D_p_rx_2*f_rx_w_leg_4y + D_p_ry_2*f_ry_w_leg_4y + D_p_rz_2*f_rz_w_leg_4y
        + D_p_x_2*f_x_w_leg_4y + D_p_x_2*t370 + D_p_y_2*f_y_w_leg_4y + D_p_y_2*t371 + D_p_z_2*f_z_w_leg_4y
        + D_p_z_2*t372
    )
    K_wq_out[..., 10, 2] = (
        -D_delta_rx_11*t322 - D_delta_ry_11*t323 - D_delta_rz_11*t324 + D_delta_x_11*t319 + D_delta_y_11*t320
        + D_delta_z_11*t321 + D_p_rx_3*f_rx_w_leg_4y + D_p_ry_3*f_ry_w_leg_4y + D_p_rz_3*f_rz_w_leg_4y
        + D_p_x_3*f_x_w_leg_4y + D_p_x_3*t370 + D_p_y_3*f_y_w_leg_4y + D_p_y_3*t371 + D_p_z_3*f_z_w_leg_4y
        + D_p_z_3*t372
    )
    K_wq_out[..., 10, 3] = (
        -D_delta_rx_11*t328 - D_delta_ry_11*t329 - D_delta_rz_11*t330 + D_delta_x_11*t325 + D_delta_y_11*t326
        + D_delta_z_11*t327 + D_p_rx_4*f_rx_w_leg_4y + D_p_ry_4*f_ry_w_leg_4y + D_p_rz_4*f_rz_w_leg_4y
        + D_p_x_4*f_x_w_leg_4y + D_p_x_4*t370 + D_p_y_4*f_y_w_leg_4y + D_p_y_4*t371 + D_p_z_4*f_z_w_leg_4y
        + D_p_z_4*t372 - t326
    )
    K_wq_out[..., 10, 4] = (
        -D_delta_rx_11*t334 - D_delta_ry_11*t335 - D_delta_rz_11*t336 + D_delta_x_11*t331 + D_delta_y_11*t332
        + D_delta_z_11*t333 + D_p_rx_5*f_rx_w_leg_4y + D_p_ry_5*f_ry_w_leg_4y + D_p_rz_5*f_rz_w_leg_4y
        + D_p_x_5*f_x_w_leg_4y + D_p_x_5*t370 + D_p_y_5*f_y_w_leg_4y + D_p_y_5*t371 + D_p_z_5*f_z_w_leg_4y
        + D_p_z_5*t372
    )
    K_wq_out[..., 10, 5] = (
        -D_delta_rx_11*t340 - D_delta_ry_11*t341 - D_delta_rz_11*t342 + D_delta_x_11*t337 + D_delta_y_11*t338
        + D_delta_z_11*t339 + D_p_rx_6*f_rx_w_leg_4y + D_p_ry_6*f_ry_w_leg_4y + D_p_rz_6*f_rz_w_leg_4y
        + D_p_x_6*f_x_w_leg_4y + D_p_x_6*t370 + D_p_y_6*f_y_w_leg_4y + D_p_y_6*t371 + D_p_z_6*f_z_w_leg_4y
        + D_p_z_6*t372
    )
    K_wq_out[..., 10, 12] = t370
    K_wq_out[..., 10, 13] = t371
    K_wq_out[..., 10, 14] = t372
    K_wq_out[..., 11, 0] = (
        -D_delta_rx_12*t310 - D_delta_ry_12*t311 - D_delta_rz_12*t312 + D_delta_x_12*t307 + D_delta_y_12*t308
        + D_delta_z_12*t309 + D_p_rx_1*f_rx_w_leg_4z + D_p_ry_1*f_ry_w_leg_4z + D_p_rz_1*f_rz_w_leg_4z
        + D_p_x_1*f_x_w_leg_4z + D_p_x_1*t373 + D_p_y_1*f_y_w_leg_4z + D_p_y_1*t374 + D_p_z_1*f_z_w_leg_4z
        + D_p_z_1*t375
    )
    K_wq_out[..., 11, 1] = (
        -D_delta_rx_12*t316 - D_delta_ry_12*t317 - D_delta_rz_12*t318 + D_delta_x_12*t313 + D_delta_y_12*t314
        + D_delta_z_12*t315 + D_p_rx_2*f_rx_w_leg_4z + D_p_ry_2*f_ry_w_leg_4z + D_p_rz_2*f_rz_w_leg_4z
        + D_p_x_2*f_x_w_leg_4z + D_p_x_2*t373 + D_p_y_2*f_y_w_leg_4z + D_p_y_2*t374 + D_p_z_2*f_z_w_leg_4z
        + D_p_z_2*t375
    )
    K_wq_out[..., 11, 2] = (
        -D_delta_rx_12*t322 - D_delta_ry_12*t323 - D_delta_rz_12*t324 + D_delta_x_12*t319 + D_delta_y_12*t320
        + D_delta_z_12*t321 + D_p_rx_3*f_rx_w_leg_4z + D_p_ry_3*f_ry_w_leg_4z + D_p_rz_3*f_rz_w_leg_4z
        + D_p_x_3*f_x_w_leg_4z + D_p_x_3*t373 + D_p_y_3*f_y_w_leg_4z + D_p_y_3*t374 + D_p_z_3*f_z_w_leg_4z
        + D_p_z_3*t375
    )
    K_wq_out[..., 11, 3] = (
        -D_delta_rx_12*t328 - D_delta_ry_12*t329 - D_delta_rz_12*t330 + D_delta_x_12*t325 + D_delta_y_12*t326
        + D_delta_z_12*t327 + D_p_rx_4*f_rx_w_leg_4z + D_p_ry_4*f_ry_w_leg_4z + D_p_rz_4*f_rz_w_leg_4z
        + D_p_x_4*f_x_w_leg_4z + D_p_x_4*t373 + D_p_y_4*f_y_w_leg_4z + D_p_y_4*t374 + D_p_z_4*f_z_w_leg_4z
        + D_p_z_4*t375 - t327
    )
    K_wq_out[..., 11, 4] = (
        -D_delta_rx_12*t334 - D_delta_ry_12*t335 - D_delta_rz_12*t336 + D_delta_x_12*t331 + D_delta_y_12*t332
        + D_delta_z_12*t333 + D_p_rx_5*f_rx_w_leg_4z + D_p_ry_5*f_ry_w_leg_4z + D_p_rz_5*f_rz_w_leg_4z
        + D_p_x_5*f_x_w_leg_4z + D_p_x_5*t373 + D_p_y_5*f_y_w_leg_4z + D_p_y_5*t374 + D_p_z_5*f_z_w_leg_4z
        + D_p_z_5*t375
    )
    K_wq_out[..., 11, 5] = (
        -D_delta_rx_12*t340 - D_delta_ry_12*t341 - D_delta_rz_12*t342 + D_delta_x_12*t337 + D_delta_y_12*t338
        + D_delta_z_12*t339 + D_p_rx_6*f_rx_w_leg_4z + D_p_ry_6*f_ry_w_leg_4z + D_p_rz_6*f_rz_w_leg_4z
        + D_p_x_6*f_x_w_leg_4z + D_p_x_6*t373 + D_p_y_6*f_y_w_leg_4z + D_p_y_6*t374 + D_p_z_6*f_z_w_leg_4z
        + D_p_z_6*t375
    )
    K_wq_out[..., 11, 12] = t373
    K_wq_out[..., 11, 13] = t374
    K_wq_out[..., 11, 14] = t375
    K_wq_out[..., 12, 0] = (
        -D_delta_rx_13*t310 - D_delta_ry_13*t311 - D_delta_rz_13*t312 + D_delta_x_13*t307 + D_delta_y_13*t308
        + D_delta_z_13*t309 + D_p_rx_1*f_rx_w_leg_5x + D_p_ry_1*f_ry_w_leg_5x + D_p_rz_1*f_rz_w_leg_5x
        + D_p_x_1*f_x_w_leg_5x + D_p_x_1*t376 + D_p_y_1*f_y_w_leg_5x + D_p_y_1*t377 + D_p_z_1*f_z_w_leg_5x
        + D_p_z_1*t378
    )
    K_wq_out[..., 12, 1] = (
        -D_delta_rx_13*t316 - D_delta_ry_13*t317 - D_delta_rz_13*t318 + D_delta_x_13*t313 + D_delta_y_13*t314
        + D_delta_z_13*t315 + D_p_rx_2*f_rx_w_leg_5x + D_p_ry_2*f_ry_w_leg_5x + D_p_rz_2*f_rz_w_leg_5x
        + D_p_x_2*f_x_w_leg_5x + D_p_x_2*t376 + D_p_y_2*f_y_w_leg_5x + D_p_y_2*t377 + D_p_z_2*f_z_w_leg_5x
        + D_p_z_2*t378
    )
    K_wq_out[..., 12, 2] = (
        -D_delta_rx_13*t322 - D_delta_ry_13*t323 - D_delta_rz_13*t324 + D_delta_x_13*t319 + D_delta_y_13*t320
        + D_delta_z_13*t321 + D_p_rx_3*f_rx_w_leg_5x + D_p_ry_3*f_ry_w_leg_5x + D_p_rz_3*f_rz_w_leg_5x
        + D_p_x_3*f_x_w_leg_5x + D_p_x_3*t376 + D_p_y_3*f_y_w_leg_5x + D_p_y_3*t377 + D_p_z_3*f_z_w_leg_5x
        + D_p_z_3*t378
    )
    K_wq_out[..., 12, 3] = (
        -D_delta_rx_13*t328 - D_delta_ry_13*t329 - D_delta_rz_13*t330 + D_delta_x_13*t325 + D_delta_y_13*t326
        + D_delta_z_13*t327 + D_p_rx_4*f_rx_w_leg_5x + D_p_ry_4*f_ry_w_leg_5x + D_p_rz_4*f_rz_w_leg_5x
        + D_p_x_4*f_x_w_leg_5x + D_p_x_4*t376 + D_p_y_4*f_y_w_leg_5x + D_p_y_4*t377 + D_p_z_4*f_z_w_leg_5x
        + D_p_z_4*t378
    )
    K_wq_out[..., 12, 4] = (
        -D_delta_rx_13*t334 - D_delta_ry_13*t335 - D_delta_rz_13*t336 + D_delta_x_13*t331 + D_delta_y_13*t332
        + D_delta_z_13*t333 + D_p_rx_5*f_rx_w_leg_5x + D_p_ry_5*f_ry_w_leg_5x + D_p_rz_5*f_rz_w_leg_5x
        + D_p_x_5*f_x_w_leg_5x + D_p_x_5*t376 + D_p_y_5*f_y_w_leg_5x + D_p_y_5*t377 + D_p_z_5*f_z_w_leg_5x
        + D_p_z_5*t378 - t331
    )
    K_wq_out[..., 12, 5] = (
        -D_delta_rx_13*t340 - D_delta_ry_13*t341 - D_delta_rz_13*t342 + D_delta_x_13*t337 + D_delta_y_13*t338
        + D_delta_z_13*t339 + D_p_rx_6*f_rx_w_leg_5x + D_p_ry_6*f_ry_w_leg_5x + D_p_rz_6*f_rz_w_leg_5x
        + D_p_x_6*f_x_w_leg_5x + D_p_x_6*t376 + D_p_y_6*f_y_w_leg_5x + D_p_y_6*t377 + D_p_z_6*f_z_w_leg_5x
        + D_p_z_6*t378
    )
    K_wq_out[..., 12, 12] = t376
    K_wq_out[..., 12, 13] = t377
    K_wq_out[..., 12, 14] = t378
    K_wq_out[..., 13, 0] = (
        -D_delta_rx_14*t310 - D_delta_ry_14*t311 - D_delta_rz_14*t312 + D_delta_x_14*t307 + D_delta_y_14*t308
        + D_delta_z_14*t309 + D_p_rx_1*f_rx_w_leg_5y + D_p_ry_1*f_ry_w_leg_5y + D_p_rz_1*f_rz_w_leg_5y
        + D_p_x_1*f_x_w_leg_5y + D_p_x_1*t379 + D_p_y_1*f_y_w_leg_5y + D_p_y_1*t380 + D_p_z_1*f_z_w_leg_5y
        + D_p_z_1*t381
    )
    K_wq_out[..., 13, 1] = (
        -D_delta_rx_14*t316 - D_delta_ry_14*t317 - D_delta_rz_14*t318 + D_delta_x_14*t313 + D_delta_y_14*t314
        + D_delta_z_14*t315 + D_p_rx_2*f_rx_w_leg_5y + D_p_ry_2*f_ry_w_leg_5y + D_p_rz_2*f_rz_w_leg_5y
        + D_p_x_2*f_x_w_leg_5y + D_p_x_2*t379 + D_p_y_2*f_y_w_leg_5y + D_p_y_2*t380 + D_p_z_2*f_z_w_leg_5y
        + D_p_z_2*t381
    )
    K_wq_out[..., 13, 2] = (
        -D_delta_rx_14*t322 - D_delta_ry_14*t323 - D_delta_rz_14*t324 + D_delta_x_14*t319 + D_delta_y_14*t320
        + D_delta_z_14*t321 + D_p_rx_3*f_rx_w_leg_5y + D_p_ry_3*f_ry_w_leg_5y + D_p_rz_3*f_rz_w_leg_5y
        + D_p_x_3*f_x_w_leg_5y + D_p_x_3*t379 + D_p_y_3*f_y_w_leg_5y + D_p_y_3*t380 + D_p_z_3*f_z_w_leg_5y
        + D_p_z_3*t381
    )
    K_wq_out[..., 13, 3] = (
        -D_delta_rx_14*t328 - D_delta_ry_14*t329 - D_delta_rz_14*t330 + D_delta_x_14*t325 + D_delta_y_14*t326
        + D_delta_z_14*t327 + D_p_rx_4*f_rx_w_leg_5y + D_p_ry_4*f_ry_w_leg_5y + D_p_rz_4*f_rz_w_leg_5y
        + D_p_x_4*f_x_w_leg_5y + D_p_x_4*t379 + D_p_y_4*f_y_w_leg_5y + D_p_y_4*t380 + D_p_z_4*f_z_w_leg_5y
        + D_p_z_4*t381
    )
    K_wq_out[..., 13, 4] = (
        -D_delta_rx_14*t334 - D_delta_ry_14*t335 - D_delta_rz_14*t336 + D_delta_x_14*t331 + D_delta_y_14*t332
        + D_delta_z_14*t333 + D_p_rx_5*f_rx_w_leg_5y + D_p_ry_5*f_ry_w_leg_5y + D_p_rz_5*f_rz_w_leg_5y
        + D_p_x_5*f_x_w_leg_5y + D_p_x_5*t379 + D_p_y_5*f_y_w_leg_5y + D_p_y_5*t380 + D_p_z_5*f_z_w_leg_5y
        + D_p_z_5*t381 - t332
    )
    K_wq_out[..., 13, 5] = (
        -D_delta_rx_14*t340 - D_delta_ry_14*t341 - D_delta_rz_14*t342 + D_delta_x_14*t337 + D_delta_y_14*t338
        + D_delta_z_14*t339 + D_p_rx_6*f_rx_w_leg_5y + D_p_ry_6*f_ry_w_leg_5y + D_p_rz_6*f_rz_w_leg_5y
        + D_p_x_6*f_x_w_leg_5y + D_p_x_6*t379 + D_p_y_6*f_y_w_leg_5y + D_p_y_6*t380 + D_p_z_6*f_z_w_leg_5y
        + D_p_z_6*t381
    )
    K_wq_out[..., 13, 12] = t379
    K_wq_out[..., 13, 13] = t380
    K_wq_out[..., 13, 14] = t381
    K_wq_out[..., 14, 0] = (
        -D_delta_rx_15*t310 - D_delta_ry_15*t311 - D_delta_rz_15*t312 + D_delta_x_15*t307 + D_delta_y_15*t308
        + D_delta_z_15*t309 + D_p_rx_1*f_rx_w_leg_5z + D_p_ry_1*f_ry_w_leg_5z + D_p_rz_1*f_rz_w_leg_5z
        + D_p_x_1*f_x_w_leg_5z + D_p_x_1*t382 + D_p_y_1*f_y_w_leg_5z + D_p_y_1*t383 + D_p_z_1*f_z_w_leg_5z
        + D_p_z_1*t384
    )
    K_wq_out[..., 14, 1] = (
        -D_delta_rx_15*t316 - D_delta_ry_15*t317 - D_delta_rz_15*t318 + D_delta_x_15*t313 + D_delta_y_15*t314
        + D_delta_z_15*t315 + D_p_rx_2*f_rx_w_leg_5z + D_p_ry_2*f_ry_w_leg_5z + D_p_rz_2*f_rz_w_leg_5z
        + D_p_x_2*f_x_w_leg_5z + D_p_x_2*t382 + D_p_y_2*f_y_w_leg_5z + D_p_y_2*t383 + D_p_z_2*f_z_w_leg_5z
        + D_p_z_2*t384
    )
    K_wq_out[..., 14, 2] = (
        -D_delta_rx_15*t322 - D_delta_ry_15*t323 - D_delta_rz_15*t324 + D_delta_x_15*t319 + D_delta_y_15*t320
        + D_delta_z_15*t321 + D_p_rx_3*f_rx_w_leg_5z + D_p_ry_3*f_ry_w_leg_5z + D_p_rz_3*f_rz_w_leg_5z
        + D_p_x_3*f_x_w_leg_5z + D_p_x_3*t382 + D_p_y_3*f_y_w_leg_5z + D_p_y_3*t383 + D_p_z_3*f_z_w_leg_5z
        + D_p_z_3*t384
    )
    K_wq_out[..., 14, 3] = (
        -D_delta_rx_15*t328 - D_delta_ry_15*t329 - D_delta_rz_15*t330 + D_delta_x_15*t325 + D_delta_y_15*t326
        + D_delta_z_15*t327 + D_p_rx_4*f_rx_w_leg_5z + D_p_ry_4*f_ry_w_leg_5z + D_p_rz_4*f_rz_w_leg_5z
        + D_p_x_4*f_x_w_leg_5z + D_p_x_4*t382 + D_p_y_4*f_y_w_leg_5z + D_p_y_4*t383 + D_p_z_4*f_z_w_leg_5z
        + D_p_z_4*t384
    )
    K_wq_out[..., 14, 4] = (
        -D_delta_rx_15*t334 - D_delta_ry_15*t335 - D_delta_rz_15*t336 + D_delta_x_15*t331 + D_delta_y_15*t332
        + D_delta_z_15*t333 + D_p_rx_5*f_rx_w_leg_5z + D_p_ry_5*f_ry_w_leg_5z + D_p_rz_5*f_rz_w_leg_5z
        + D_p_x_5*f_x_w_leg_5z + D_p_x_5*t382 + D_p_y_5*f_y_w_leg_5z + D_p_y_5*t383 + D_p_z_5*f_z_w_leg_5z
        + D_p_z_5*t384 - t333
    )
    K_wq_out[..., 14, 5] = (
        -D_delta_rx_15*t340 - D_delta_ry_15*t341 - D_delta_rz_15*t342 + D_delta_x_15*t337 + D_delta_y_15*t338
        + D_delta_z_15*t339 + D_p_rx_6*f_rx_w_leg_5z + D_p_ry_6*f_ry_w_leg_5z + D_p_rz_6*f_rz_w_leg_5z
        + D_p_x_6*f_x_w_leg_5z + D_p_x_6*t382 + D_p_y_6*f_y_w_leg_5z + D_p_y_6*t383 + D_p_z_6*f_z_w_leg_5z
        + D_p_z_6*t384
    )
    K_wq_out[..., 14, 12] = t382
    K_wq_out[..., 14, 13] = t383
    K_wq_out[..., 14, 14] = t384
    K_wq_out[..., 15, 0] = (
        -D_delta_rx_16*t310 - D_delta_ry_16*t311 - D_delta_rz_16*t312 + D_delta_x_16*t307 + D_delta_y_16*t308
        + D_delta_z_16*t309 + D_p_rx_1*f_rx_w_leg_6x + D_p_ry_1*f_ry_w_leg_6x + D_p_rz_1*f_rz_w_leg_6x
        + D_p_x_1*f_x_w_leg_6x + D_p_x_1*t385 + D_p_y_1*f_y_w_leg_6x + D_p_y_1*t386 + D_p_z_1*f_z_w_leg_6x
        + D_p_z_1*t387
    )
    K_wq_out[..., 15, 1] = (
        -D_delta_rx_16*t316 - D_delta_ry_16*t317 - D_delta_rz_16*t318 + D_delta_x_16*t313 + D_delta_y_16*t314
        + D_delta_z_16*t315 + D_p_rx_2*f_rx_w_leg_6x + D_p_ry_2*f_ry_w_leg_6x + D_p_rz_2*f_rz_w_leg_6x
        + D_p_x_2*f_x_w_leg_6x + D_p_x_2*t385 + D_p_y_2*f_y_w_leg_6x + D_p_y_2*t386 + D_p_z_2*f_z_w_leg_6x
        + D_p_z_2*t387
    )
    K_wq_out[..., 15, 2] = (
        -D_delta_rx_16*t322 - D_delta_ry_16*t323 - D_delta_rz_16*t324 + D_delta_x_16*t319 + D_delta_y_16*t320
        + D_delta_z_16*t321 + D_p_rx_3*f_rx_w_leg_6x + D_p_ry_3*f_ry_w_leg_6x + D_p_rz_3*f_rz_w_leg_6x
        + D_p_x_3*f_x_w_leg_6x + D_p_x_3*t385 + D_p_y_3*f_y_w_leg_6x + D_p_y_3*t386 + D_p_z_3*f_z_w_leg_6x
        + D_p_z_3*t387
    )
    K_wq_out[..., 15, 3] = (
        -D_delta_rx_16*t328 - D_delta_ry_16*t329 - D_delta_rz_16*t330 + D_delta_x_16*t325 + D_delta_y_16*t326
        + D_delta_z_16*t327 + D_p_rx_4*f_rx_w_leg_6x + D_p_ry_4*f_ry_w_leg_6x + D_p_rz_4*f_rz_w_leg_6x
        + D_p_x_4*f_x_w_leg_6x + D_p_x_4*t385 + D_p_y_4*f_y_w_leg_6x + D_p_y_4*t386 + D_p_z_4*f_z_w_leg_6x
        + D_p_z_4*t387
    )
    K_wq_out[..., 15, 4] = (
        -D_delta_rx_16*t334 - D_delta_ry_16*t335 - D_delta_rz_16*t336 + D_delta_x_16*t331 + D_delta_y_16*t332
        + D_delta_z_16*t333 + D_p_rx_5*f_rx_w_leg_6x + D_p_ry_5*f_ry_w_leg_6x + D_p_rz_5*f_rz_w_leg_6x
        + D_p_x_5*f_x_w_leg_6x + D_p_x_5*t385 + D_p_y_5*f_y_w_leg_6x + D_p_y_5*t386 + D_p_z_5*f_z_w_leg_6x
        + D_p_z_5*t387
    )
    K_wq_out[..., 15, 5] = (
        -D_delta_rx_16*t340 - D_delta_ry_16*t341 - D_delta_rz_16*t342 + D_delta_x_16*t337 + D_delta_y_16*t338
        + D_delta_z_16*t339 + D_p_rx_6*f_rx_w_leg_6x + D_p_ry_6*f_ry_w_leg_6x + D_p_rz_6*f_rz_w_leg_6x
        + D_p_x_6*f_x_w_leg_6x + D_p_x_6*t385 + D_p_y_6*f_y_w_leg_6x + D_p_y_6*t386 + D_p_z_6*f_z_w_leg_6x
        + D_p_z_6*t387 - t337
    )
    K_wq_out[..., 15, 12] = t385
    K_wq_out[..., 15, 13] = t386
    K_wq_out[..., 15, 14] = t387
    K_wq_out[..., 16, 0] = (
        -D_delta_rx_17*t310 - D_delta_ry_17*t311 - D_delta_rz_17*t312 + D_delta_x_17*t307 + D_delta_y_17*t308
        + D_delta_z_17*t309 + D_p_rx_1*f_rx_w_leg_6y + D_p_ry_1*f_ry_w_leg_6y + D_p_rz_1*f_rz_w_leg_6y
        + D_p_x_1*f_x_w_leg_6y + D_p_x_1*t388 + D_p_y_1*f_y_w_leg_6y + D_p_y_1*t389 + D_p_z_1*f_z_w_leg_6y
        + D_p_z_1*t390
    )
    K_wq_out[..., 16, 1] = (
        -D_delta_rx_17*t316 - D_delta_ry_17*t317 - D_delta_rz_17*t318 + D_delta_x_17*t313 + D_delta_y_17*t314
        + D_delta_z_17*t315 + D_p_rx_2*f_rx_w_leg_6y + D_p_ry_2*f_ry_w_leg_6y + D_p_rz_2*f_rz_w_leg_6y
        + D_p_x_2*f_x_w_leg_6y + D_p_x_2*t388 + D_p_y_2*f_y_w_leg_6y + D_p_y_2*t389 + D_p_z_2*f_z_w_leg_6y
        + D_p_z_2*t390
    )
    K_wq_out[..., 16, 2] = (
        -D_delta_rx_17*t322 - D_delta_ry_17*t323 - D_delta_rz_17*t324 + D_delta_x_17*t319 + D_delta_y_17*t320
        + D_delta_z_17*t321 + D_p_rx_3*f_rx_w_leg_6y + D_p_ry_3*f_ry_w_leg_6y + D_p_rz_3*f_rz_w_leg_6y
        + D_p_x_3*f_x_w_leg_6y + D_p_x_3*t388 + D_p_y_3*f_y_w_leg_6y + D_p_y_3*t389 + D_p_z_3*f_z_w_leg_6y
        + D_p_z_3*t390
    )
    K_wq_out[..., 16, 3] = (
        -D_delta_rx_17*t328 - D_delta_ry_17*t329 - D_delta_rz_17*t330 + D_delta_x_17*t325 + D_delta_y_17*t326
        + D_delta_z_17*t327 + D_p_rx_4*f_rx_w_leg_6y + D_p_ry_4*f_ry_w_leg_6y + D_p_rz_4*f_rz_w_leg_6y
        + D_p_x_4*f_x_w_leg_6y + D_p_x_4*t388 + D_p_y_4*f_y_w_leg_6y + D_p_y_4*t389 + D_p_z_4*f_z_w_leg_6y
        + D_p_z_4*t390
    )
    K_wq_out[..., 16, 4] = (
        -D_delta_rx_17*t334 - D_delta_ry_17*t335 - D_delta_rz_17*t336 + D_delta_x_17*t331 + D_delta_y_17*t332
        + D_delta_z_17*t333 + D_p_rx_5*f_rx_w_leg_6y + D_p_ry_5*f_ry_w_leg_6y + D_p_rz_5*f_rz_w_leg_6y
        + D_p_x_5*f_x_w_leg_6y + D_p_x_5*t388 + D_p_y_5*f_y_w_leg_6y + D_p_y_5*t389 + D_p_z_5*f_z_w_leg_6y
        + D_p_z_5*t390
    )
    K_wq_out[..., 16, 5] = (
        -D_delta_rx_17*t340 - D_delta_ry_17*t341 - D_delta_rz_17*t342 + D_delta_x_17*t337 + D_delta_y_17*t338
        + D_delta_z_17*t339 + D_p_rx_6*f_rx_w_leg_6y + D_p_ry_6*f_ry_w_leg_6y + D_p_rz_6*f_rz_w_leg_6y
        + D_p_x_6*f_x_w_leg_6y + D_p_x_6*t388 + D_p_y_6*f_y_w_leg_6y + D_p_y_6*t389 + D_p_z_6*f_z_w_leg_6y
        + D_p_z_6*t390 - t338
    )
    K_wq_out[..., 16, 12] = t388
    K_wq_out[..., 16, 13] = t389
    K_wq_out[..., 16, 14] = t390
    K_wq_out[..., 17, 0] = (
        -D_delta_rx_18*t310 - D_delta_ry_18*t311 - D_delta_rz_18*t312 + D_delta_x_18*t307 + D_delta_y_18*t308
        + D_delta_z_18*t309 + D_p_rx_1*f_rx_w_leg_6z + D_p_ry_1*f_ry_w_leg_6z + D_p_rz_1*f_rz_w_leg_6z
        + D_p_x_1*f_x_w_leg_6z + D_p_x_1*t391 + D_p_y_1*f_y_w_leg_6z + D_p_y_1*t392 + D_p_z_1*f_z_w_leg_6z
        + D_p_z_1*t393
    )
    K_wq_out[..., 17, 1] = (
        -D_delta_rx_18*t316 - D_delta_ry_18*t317 - D_delta_rz_18*t318 + D_delta_x_18*t313 + D_delta_y_18*t314
        + D_delta_z_18*t315 + D_p_rx_2*f_rx_w_leg_6z + D_p_ry_2*f_ry_w_leg_6z + D_p_rz_2*f_rz_w_leg_6z
        + D_p_x_2*f_x_w_leg_6z + D_p_x_2*t391 + D_p_y_2*f_y_w_leg_6z + D_p_y_2*t392 + D_p_z_2*f_z_w_leg_6z
        + D_p_z_2*t393
    )
    K_wq_out[..., 17, 2] = (
        -D_delta_rx_18*t322 - D_delta_ry_18*t323 - D_delta_rz_18*t324 + D_delta_x_18*t319 + D_delta_y_18*t320
        + D_delta_z_18*t321 + D_p_rx_3*f_rx_w_leg_6z + D_p_ry_3*f_ry_w_leg_6z + D_p_rz_3*f_rz_w_leg_6z
        + D_p_x_3*f_x_w_leg_6z + D_p_x_3*t391 + D_p_y_3*f_y_w_leg_6z + D_p_y_3*t392 + D_p_z_3*f_z_w_leg_6z
        + D_p_z_3*t393
    )
    K_wq_out[..., 17, 3] = (
        -D_delta_rx_18*t328 - D_delta_ry_18*t329 - D_delta_rz_18*t330 + D_delta_x_18*t325 + D_delta_y_18*t326
        + D_delta_z_18*t327 + D_p_rx_4*f_rx_w_leg_6z + D_p_ry_4*f_ry_w_leg_6z + D_p_rz_4*f_rz_w_leg_6z
        + D_p_x_4*f_x_w_leg_6z + D_p_x_4*t391 + D_p_y_4*f_y_w_leg_6z + D_p_y_4*t392 + D_p_z_4*f_z_w_leg_6z
        + D_p_z_4*t393
    )
    K_wq_out[..., 17, 4] = (
        -D_delta_rx_18*t334 - D_delta_ry_18*t335 - D_delta_rz_18*t336 + D_delta_x_18*t331 + D_delta_y_18*t332
        + D_delta_z_18*t333 + D_p_rx_5*f_rx_w_leg_6z + D_p_ry_5*f_ry_w_leg_6z + D_p_rz_5*f_rz_w_leg_6z
        + D_p_x_5*f_x_w_leg_6z + D_p_x_5*t391 + D_p_y_5*f_y_w_leg_6z + D_p_y_5*t392 + D_p_z_5*f_z_w_leg_6z
        + D_p_z_5*t393
    )
    K_wq_out[..., 17, 5] = (
        -D_delta_rx_18*t340 - D_delta_ry_18*t341 - D_delta_rz_18*t342 + D_delta_x_18*t337 + D_delta_y_18*t338
        + D_delta_z_18*t339 + D_p_rx_6*f_rx_w_leg_6z + D_p_ry_6*f_ry_w_leg_6z + D_p_rz_6*f_rz_w_leg_6z
        + D_p_x_6*f_x_w_leg_6z + D_p_x_6*t391 + D_p_y_6*f_y_w_leg_6z + D_p_y_6*t392 + D_p_z_6*f_z_w_leg_6z
        + D_p_z_6*t393 - t339
    )
    K_wq_out[..., 17, 12] = t391
    K_wq_out[..., 17, 13] = t392
    K_wq_out[..., 17, 14] = t393
    K_ww_out = np.empty((*batch, 18), dtype)
    K_ww_out[..., 0] = (
        D_delta_rx_1*f_rx_w_leg_1x + D_delta_ry_1*f_ry_w_leg_1x + D_delta_ry_1*t119
        + D_delta_rz_1*f_rz_w_leg_1x - D_delta_rz_1*t125 + D_delta_x_1**2*k_C + D_delta_x_1*f_x_w_leg_1x
        + D_delta_x_1*mu_1 + D_delta_y_1**2*k_C + D_delta_y_1*f_y_w_leg_1x + D_delta_z_1**2*k_C
        + D_delta_z_1*f_z_w_leg_1x - mu_1
    )
    K_ww_out[..., 1] = (
        D_delta_rx_2*f_rx_w_leg_1y - D_delta_rx_2*t119 + D_delta_ry_2*f_ry_w_leg_1y
        + D_delta_rz_2*f_rz_w_leg_1y + D_delta_rz_2*t131 + D_delta_x_2**2*k_C + D_delta_x_2*f_x_w_leg_1y
        + D_delta_y_2**2*k_C + D_delta_y_2*f_y_w_leg_1y + D_delta_y_2*mu_1 + D_delta_z_2**2*k_C
        + D_delta_z_2*f_z_w_leg_1y - mu_1
    )
    K_ww_out[..., 2] = (
        D_delta_rx_3*f_rx_w_leg_1z + D_delta_rx_3*t125 + D_delta_ry_3*f_ry_w_leg_1z - D_delta_ry_3*t131
        + D_delta_rz_3*f_rz_w_leg_1z + D_delta_x_3**2*k_C + D_delta_x_3*f_x_w_leg_1z + D_delta_y_3**2*k_C
        + D_delta_y_3*f_y_w_leg_1z + D_delta_z_3**2*k_C + D_delta_z_3*f_z_w_leg_1z + D_delta_z_3*mu_1 - mu_1
    )
    K_ww_out[..., 3] = (
        D_delta_rx_4*f_rx_w_leg_2x + D_delta_ry_4*f_ry_w_leg_2x + D_delta_ry_4*t120
        + D_delta_rz_4*f_rz_w_leg_2x - D_delta_rz_4*t126 + D_delta_x_4**2*k_C + D_delta_x_4*f_x_w_leg_2x
        + D_delta_x_4*mu_2 + D_delta_y_4**2*k_C + D_delta_y_4*f_y_w_leg_2x + D_delta_z_4**2*k_C
        + D_delta_z_4*f_z_w_leg_2x - mu_2
    )
    K_ww_out[..., 4] = (
        D_delta_rx_5*f_rx_w_leg_2y - D_delta_rx_5*t120 + D_delta_ry_5*f_ry_w_leg_2y
        + D_delta_rz_5*f_rz_w_leg_2y + D_delta_rz_5*t132 + D_delta_x_5**2*k_C + D_delta_x_5*f_x_w_leg_2y
        + D_delta_y_5**2*k_C + D_delta_y_5*f_y_w_leg_2y + D_delta_y_5*mu_2 + D_delta_z_5**2*k_C
        + D_delta_z_5*f_z_w_leg_2y - mu_2
    )
    K_ww_out[..., 5] = (
        D_delta_rx_6*f_rx_w_leg_2z + D_delta_rx_6*t126 + D_delta_ry_6*f_ry_w_leg_2z - D_delta_ry_6*t132
        + D_delta_rz_6*f_rz_w_leg_2z + D_delta_x_6**2*k_C + D_delta_x_6*f_x_w_leg_2z + D_delta_y_6**2*k_C
        + D_delta_y_6*f_y_w_leg_2z + D_delta_z_6**2*k_C + D_delta_z_6*f_z_w_leg_2z + D_delta_z_6*mu_2 - mu_2
    )
    K_ww_out[..., 6] = (
        D_delta_rx_7*f_rx_w_leg_3x + D_delta_ry_7*f_ry_w_leg_3x + D_delta_ry_7*t121
        + D_delta_rz_7*f_rz_w_leg_3x - D_delta_rz_7*t127 + D_delta_x_7**2*k_C + D_delta_x_7*f_x_w_leg_3x
        + D_delta_x_7*mu_3 + D_delta_y_7**2*k_C + D_delta_y_7*f_y_w_leg_3x + D_delta_z_7**2*k_C
        + D_delta_z_7*f_z_w_leg_3x - mu_3
    )
    K_ww_out[..., 7] = (
        D_delta_rx_8*f_rx_w_leg_3y - D_delta_rx_8*t121 + D_delta_ry_8*f_ry_w_leg_3y
        + D_delta_rz_8*f_rz_w_leg_3y + D_delta_rz_8*t133 + D_delta_x_8**2*k_C + D_delta_x_8*f_x_w_leg_3y
        + D_delta_y_8**2*k_C + D_delta_y_8*f_y_w_leg_3y + D_delta_y_8*mu_3 + D_delta_z_8**2*k_C
        + D_delta_z_8*f_z_w_leg_3y - mu_3
    )
    K_ww_out[..., 8] = (
        D_delta_rx_9*f_rx_w_leg_3z + D_delta_rx_9*t127 + D_delta_ry_9*f_ry_w_leg_3z - D_delta_ry_9*t133
        + D_delta_rz_9*f_rz_w_leg_3z + D_delta_x_9**2*k_C + D_delta_x_9*f_x_w_leg_3z + D_delta_y_9**2*k_C
        + D_delta_y_9*f_y_w_leg_3z + D_delta_z_9**2*k_C + D_delta_z_9*f_z_w_leg_3z + D_delta_z_9*mu_3 - mu_3
    )
    K_ww_out[..., 9] = (
        D_delta_rx_10*f_rx_w_leg_4x + D_delta_ry_10*f_ry_w_leg_4x + D_delta_ry_10*t122
        + D_delta_rz_10*f_rz_w_leg_4x - D_delta_rz_10*t128 + D_delta_x_10**2*k_C + D_delta_x_10*f_x_w_leg_4x
        + D_delta_x_10*mu_4 + D_delta_y_10**2*k_C + D_delta_y_10*f_y_w_leg_4x + D_delta_z_10**2*k_C
        + D_delta_z_10*f_z_w_leg_4x - mu_4
    )
    K_ww_out[..., 10] = (
        D_delta_rx_11*f_rx_w_leg_4y - D_delta_rx_11*t122 + D_delta_ry_11*f_ry_w_leg_4y
        + D_delta_rz_11*f_rz_w_leg_4y + D_delta_rz_11*t134 + D_delta_x_11**2*k_C + D_delta_x_11*f_x_w_leg_4y
        + D_delta_y_11**2*k_C + D_delta_y_11*f_y_w_leg_4y + D_delta_y_11*mu_4 + D_delta_z_11**2*k_C
        + D_delta_z_11*f_z_w_leg_4y - mu_4
    )
    K_ww_out[..., 11] = (
        D_delta_rx_12*f_rx_w_leg_4z + D_delta_rx_12*t128 + D_delta_ry_12*f_ry_w_leg_4z - D_delta_ry_12*t134
        + D_delta_rz_12*f_rz_w_leg_4z + D_delta_x_12**2*k_C + D_delta_x_12*f_x_w_leg_4z + D_delta_y_12**2*k_C
        + D_delta_y_12*f_y_w_leg_4z + D_delta_z_12**2*k_C + D_delta_z_12*f_z_w_leg_4z + D_delta_z_12*mu_4
        - mu_4
    )
    K_ww_out[..., 12] = (
        D_delta_rx_13*f_rx_w_leg_5x + D_delta_ry_13*f_ry_w_leg_5x + D_delta_ry_13*t123
        + D_delta_rz_13*f_rz_w_leg_5x - D_delta_rz_13*t129 + D_delta_x_13**2*k_C + D_delta_x_13*f_x_w_leg_5x
        + D_delta_x_13*mu_5 + D_delta_y_13**2*k_C + D_delta_y_13*f_y_w_leg_5x + D_delta_z_13**2*k_C
        + D_delta_z_13*f_z_w_leg_5x - mu_5
    )
    K_ww_out[..., 13] = (
        D_delta_rx_14*f_rx_w_leg_5y - D_delta_rx_14*t123 + D_delta_ry_14*f_ry_w_leg_5y
        + D_delta_rz_14*f_rz_w_leg_5y + D_delta_rz_14*t135 + D_delta_x_14**2*k_C + D_delta_x_14*f_x_w_leg_5y
        + D_delta_y_14**2*k_C + D_delta_y_14*f_y_w_leg_5y + D_delta_y_14*mu_5 + D_delta_z_14**2*k_C
        + D_delta_z_14*f_z_w_leg_5y - mu_5
    )
    K_ww_out[..., 14] = (
        D_delta_rx_15*f_rx_w_leg_5z + D_delta_rx_15*t129 + D_delta_ry_15*f_ry_w_leg_5z - D_delta_ry_15*t135
        + D_delta_rz_15*f_rz_w_leg_5z + D_delta_x_15**2*k_C + D_delta_x_15*f_x_w_leg_5z + D_delta_y_15**2*k_C
        + D_delta_y_15*f_y_w_leg_5z + D_delta_z_15**2*k_C + D_delta_z_15*f_z_w_leg_5z + D_delta_z_15*mu_5
        - mu_5
    )
    K_ww_out[..., 15] = (
        D_delta_rx_16*f_rx_w_leg_6x + D_delta_ry_16*f_ry_w_leg_6x + D_delta_ry_16*t124
        + D_delta_rz_16*f_rz_w_leg_6x - D_delta_rz_16*t130 + D_delta_x_16**2*k_C + D_delta_x_16*f_x_w_leg_6x
        + D_delta_x_16*mu_6 + D_delta_y_16**2*k_C + D_delta_y_16*f_y_w_leg_6x + D_delta_z_16**2*k_C
        + D_delta_z_16*f_z_w_leg_6x - mu_6
    )
    K_ww_out[..., 16] = (
        D_delta_rx_17*f_rx_w_leg_6y - D_delta_rx_17*t124 + D_delta_ry_17*f_ry_w_leg_6y
        + D_delta_rz_17*f_rz_w_leg_6y + D_delta_rz_17*t136 + D_delta_x_17**2*k_C + D_delta_x_17*f_x_w_leg_6y
        + D_delta_y_17**2*k_C + D_delta_y_17*f_y_w_leg_6y + D_delta_y_17*mu_6 + D_delta_z_17**2*k_C
        + D_delta_z_17*f_z_w_leg_6y - mu_6
    )
    K_ww_out[..., 17] = (
        D_delta_rx_18*f_rx_w_leg_6z + D_delta_rx_18*t130 + D_delta_ry_18*f_ry_w_leg_6z - D_delta_ry_18*t136
        + D_delta_rz_18*f_rz_w_leg_6z + D_delta_x_18**2*k_C + D_delta_x_18*f_x_w_leg_6z + D_delta_y_18**2*k_C
        + D_delta_y_18*f_y_w_leg_6z + D_delta_z_18**2*k_C + D_delta_z_18*f_z_w_leg_6z + D_delta_z_18*mu_6
        - mu_6
    )
    J_p_out = np.empty((*batch, 18, 6), dtype)
    J_p_out[..., 0, 0] = D_delta_x_1
    J_p_out[..., 0, 1] = D_delta_y_1
    J_p_out[..., 0, 2] = D_delta_z_1
    J_p_out[..., 0, 3] = D_delta_rx_1
    J_p_out[..., 0, 4] = D_delta_ry_1
    J_p_out[..., 0, 5] = D_delta_rz_1
    J_p_out[..., 1, 0] = D_delta_x_2
    J_p_out[..., 1, 1] = D_delta_y_2
    J_p_out[..., 1, 2] = D_delta_z_2
    J_p_out[..., 1, 3] = D_delta_rx_2
    J_p_out[..., 1, 4] = D_delta_ry_2
    J_p_out[..., 1, 5] = D_delta_rz_2
    J_p_out[..., 2, 0] = D_delta_x_3
    J_p_out[..., 2, 1] = D_delta_y_3
    J_p_out[..., 2, 2] = D_delta_z_3
    J_p_out[..., 2, 3] = D_delta_rx_3
    J_p_out[..., 2, 4] = D_delta_ry_3
    J_p_out[..., 2, 5] = D_delta_rz_3
    J_p_out[..., 3, 0] = D_delta_x_4
    J_p_out[..., 3, 1] = D_delta_y_4
    J_p_out[..., 3, 2] = D_delta_z_4
    J_p_out[..., 3, 3] = D_delta_rx_4
    J_p_out[..., 3, 4] = D_delta_ry_4
    J_p_out[..., 3, 5] = D_delta_rz_4
    J_p_out[..., 4, 0] = D_delta_x_5
    J_p_out[..., 4, 1] = D_delta_y_5
    J_p_out[..., 4, 2] = D_delta_z_5
    J_p_out[..., 4, 3] = D_delta_rx_5
    J_p_out[..., 4, 4] = D_delta_ry_5
    J_p_out[..., 4, 5] = D_delta_rz_5
    J_p_out[..., 5, 0] = D_delta_x_6
    J_p_out[..., 5, 1] = D_delta_y_6
    J_p_out[..., 5, 2] = D_delta_z_6
    J_p_out[..., 5, 3] = D_delta_rx_6
    J_p_out[..., 5, 4] = D_delta_ry_6
    J_p_out[..., 5, 5] = D_delta_rz_6
    J_p_out[..., 6, 0] = D_delta_x_7
    J_p_out[..., 6, 1] = D_delta_y_7
    J_p_out[..., 6, 2] = D_delta_z_7
    J_p_out[..., 6, 3] = D_delta_rx_7
    J_p_out[..., 6, 4] = D_delta_ry_7
    J_p_out[..., 6, 5] = D_delta_rz_7
    J_p_out[..., 7, 0] = D_delta_x_8
    J_p_out[..., 7, 1] = D_delta_y_8
    J_p_out[..., 7, 2] = D_delta_z_8
    J_p_out[..., 7, 3] = D_delta_rx_8
    J_p_out[..., 7, 4] = D_delta_ry_8
    J_p_out[..., 7, 5] = D_delta_rz_8
    J_p_out[..., 8, 0] = D_delta_x_9
    J_p_out[..., 8, 1] = D_delta_y_9
    J_p_out[..., 8, 2] = D_delta_z_9
    J_p_out[..., 8, 3] = D_delta_rx_9
    J_p_out[..., 8, 4] = D_delta_ry_9
    J_p_out[..., 8, 5] = D_delta_rz_9
    J_p_out[..., 9, 0] = D_delta_x_10
    J_p_out[..., 9, 1] = D_delta_y_10
    J_p_out[..., 9, 2] = D_delta_z_10
    J_p_out[..., 9, 3] = D_delta_rx_10
    J_p_out[..., 9, 4] = D_delta_ry_10
    J_p_out[..., 9, 5] = D_delta_rz_10
    J_p_out[..., 10, 0] = D_delta_x_11
    J_p_out[..., 10, 1] = D_delta_y_11
    J_p_out[..., 10, 2] = D_delta_z_11
    J_p_out[..., 10, 3] = D_delta_rx_11
    J_p_out[..., 10, 4] = D_delta_ry_11
    J_p_out[..., 10, 5] = D_delta_rz_11
    J_p_out[..., 11, 0] = D_delta_x_12
    J_p_out[..., 11, 1] = D_delta_y_12
    J_p_out[..., 11, 2] = D_delta_z_12
    J_p_out[..., 11, 3] = D_delta_rx_12
    J_p_out[..., 11, 4] = D_delta_ry_12
    J_p_out[..., 11, 5] = D_delta_rz_12
    J_p_out[..., 12, 0] = D_delta_x_13
    J_p_out[..., 12, 1] = D_delta_y_13
    J_p_out[..., 12, 2] = D_delta_z_13
    J_p_out[..., 12, 3] = D_delta_rx_13
    J_p_out[..., 12, 4] = D_delta_ry_13
    J_p_out[..., 12, 5] = D_delta_rz_13
    J_p_out[..., 13, 0] = D_delta_x_14
    J_p_out[..., 13, 1] = D_delta_y_14
    J_p_out[..., 13, 2] = D_delta_z_14
    J_p_out[..., 13, 3] = D_delta_rx_14
    J_p_out[..., 13, 4] = D_delta_ry_14
    J_p_out[..., 13, 5] = D_delta_rz_14
    J_p_out[..., 14, 0] = D_delta_x_15
    J_p_out[..., 14, 1] = D_delta_y_15
    J_p_out[..., 14, 2] = D_delta_z_15
    J_p_out[..., 14, 3] = D_delta_rx_15
    J_p_out[..., 14, 4] = D_delta_ry_15
    J_p_out[..., 14, 5] = D_delta_rz_15
    J_p_out[..., 15, 0] = D_delta_x_16
    J_p_out[..., 15, 1] = D_delta_y_16
    J_p_out[..., 15, 2] = D_delta_z_16
    J_p_out[..., 15, 3] = D_delta_rx_16
    J_p_out[..., 15, 4] = D_delta_ry_16
    J_p_out[..., 15, 5] = D_delta_rz_16
    J_p_out[..., 16, 0] = D_delta_x_17
    J_p_out[..., 16, 1] = D_delta_y_17
    J_p_out[..., 16, 2] = D_delta_z_17
    J_p_out[..., 16, 3] = D_delta_rx_17
    J_p_out[..., 16, 4] = D_delta_ry_17
    J_p_out[..., 16, 5] = D_delta_rz_17
    J_p_out[..., 17, 0] = D_delta_x_18
    J_p_out[..., 17, 1] = D_delta_y_18
    J_p_out[..., 17, 2] = D_delta_z_18
    J_p_out[..., 17, 3] = D_delta_rx_18
    J_p_out[..., 17, 4] = D_delta_ry_18
    J_p_out[..., 17, 5] = D_delta_rz_18
    return M_wq_out, M_ww_out, K_wq_out, K_ww_out, J_p_out


def mount_inertia():
    """Derivatives of the rows of M of the mounts with respect to the mass that moves with each.

    Parameters
    ----------

    Returns
    -------
    M_wq : array, shape (..., 18, 15) [1]
        Of M_wq.
    M_ww : array, shape (..., 18) [1]
        Of M_ww.

    Notes
    -----
    The kinetic energy of a bearing that yields, of which the frame has the rest.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    M_wq_out = np.zeros((*batch, 18, 15), dtype)
    M_ww_out = np.zeros((*batch, 18), dtype)
    return M_wq_out, M_ww_out
