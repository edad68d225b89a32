# Generated from the derivation of hexapod and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Points and springs of the mechanism hexapod, with effects, for pictures of it.

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
* k_j [N/m]: stiffness of leg j, with effects
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
* D_p_i_k [1/m]: platform Jacobian, dp_i/dl_k
"""

from math import prod

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "drawing_motion",
    "drawing_points",
    "driven",
    "springs",
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


def drawing_points(p, parameters):
    """Positions of the points of a drawing.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    r : array, shape (..., 19, 3) [m]
        Base frame; first the platform.

    Notes
    -----
    The positions that the mechanism declares, or those of its parts.
    231 operations; 5400 with every named value expanded.
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
    batch, dtype = _batch(p_x, a_1_x, b_1_x)
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
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t11 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t11
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t11
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    t12 = (1/2)*p_x
    t13 = (1/2)*p_y
    t14 = (1/2)*p_z
    r_out = np.empty((*batch, 19, 3), dtype)
    r_out[..., 0, 0] = p_x
    r_out[..., 0, 1] = p_y
    r_out[..., 0, 2] = p_z
    r_out[..., 1, 0] = a_1_x
    r_out[..., 1, 1] = a_1_y
    r_out[..., 1, 2] = a_1_z
    r_out[..., 2, 0] = a_2_x
    r_out[..., 2, 1] = a_2_y
    r_out[..., 2, 2] = a_2_z
    r_out[..., 3, 0] = a_3_x
    r_out[..., 3, 1] = a_3_y
    r_out[..., 3, 2] = a_3_z
    r_out[..., 4, 0] = a_4_x
    r_out[..., 4, 1] = a_4_y
    r_out[..., 4, 2] = a_4_z
    r_out[..., 5, 0] = a_5_x
    r_out[..., 5, 1] = a_5_y
    r_out[..., 5, 2] = a_5_z
    r_out[..., 6, 0] = a_6_x
    r_out[..., 6, 1] = a_6_y
    r_out[..., 6, 2] = a_6_z
    r_out[..., 7, 0] = (1/2)*B_1_x + (1/2)*a_1_x + t12
    r_out[..., 7, 1] = (1/2)*B_1_y + (1/2)*a_1_y + t13
    r_out[..., 7, 2] = (1/2)*B_1_z + (1/2)*a_1_z + t14
    r_out[..., 8, 0] = B_1_x + p_x
    r_out[..., 8, 1] = B_1_y + p_y
    r_out[..., 8, 2] = B_1_z + p_z
    r_out[..., 9, 0] = (1/2)*B_2_x + (1/2)*a_2_x + t12
    r_out[..., 9, 1] = (1/2)*B_2_y + (1/2)*a_2_y + t13
    r_out[..., 9, 2] = (1/2)*B_2_z + (1/2)*a_2_z + t14
    r_out[..., 10, 0] = B_2_x + p_x
    r_out[..., 10, 1] = B_2_y + p_y
    r_out[..., 10, 2] = B_2_z + p_z
    r_out[..., 11, 0] = (1/2)*B_3_x + (1/2)*a_3_x + t12
    r_out[..., 11, 1] = (1/2)*B_3_y + (1/2)*a_3_y + t13
    r_out[..., 11, 2] = (1/2)*B_3_z + (1/2)*a_3_z + t14
    r_out[..., 12, 0] = B_3_x + p_x
    r_out[..., 12, 1] = B_3_y + p_y
    r_out[..., 12, 2] = B_3_z + p_z
    r_out[..., 13, 0] = (1/2)*B_4_x + (1/2)*a_4_x + t12
    r_out[..., 13, 1] = (1/2)*B_4_y + (1/2)*a_4_y + t13
    r_out[..., 13, 2] = (1/2)*B_4_z + (1/2)*a_4_z + t14
    r_out[..., 14, 0] = B_4_x + p_x
    r_out[..., 14, 1] = B_4_y + p_y
    r_out[..., 14, 2] = B_4_z + p_z
    r_out[..., 15, 0] = (1/2)*B_5_x + (1/2)*a_5_x + t12
    r_out[..., 15, 1] = (1/2)*B_5_y + (1/2)*a_5_y + t13
    r_out[..., 15, 2] = (1/2)*B_5_z + (1/2)*a_5_z + t14
    r_out[..., 16, 0] = B_5_x + p_x
    r_out[..., 16, 1] = B_5_y + p_y
    r_out[..., 16, 2] = B_5_z + p_z
    r_out[..., 17, 0] = (1/2)*B_6_x + (1/2)*a_6_x + t12
    r_out[..., 17, 1] = (1/2)*B_6_y + (1/2)*a_6_y + t13
    r_out[..., 17, 2] = (1/2)*B_6_z + (1/2)*a_6_z + t14
    r_out[..., 18, 0] = B_6_x + p_x
    r_out[..., 18, 1] = B_6_y + p_y
    r_out[..., 18, 2] = B_6_z + p_z
    return r_out


def drawing_motion(p, parameters):
    """Jacobians of these points with respect to every coordinate, one for points that move alike.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J : array, shape (..., 14, 3, 15) [1, m]
        dr_i/dq_k, base frame.

    Notes
    -----
    The positions differentiated, with the contributions of released joints and the frame.
    2360 operations; 330575652 with every named value expanded.
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
    batch, dtype = _batch(p_x, a_1_x, b_1_x)
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
    t19 = (1/2)*D_p_x_1
    t20 = B_1_y*D_p_rz_1
    t21 = B_1_z*D_p_ry_1
    t22 = (1/2)*D_p_x_2
    t23 = B_1_y*D_p_rz_2
    t24 = B_1_z*D_p_ry_2
    t25 = (1/2)*D_p_x_3
    t26 = B_1_y*D_p_rz_3
    t27 = B_1_z*D_p_ry_3
    t28 = (1/2)*D_p_x_4
    t29 = B_1_y*D_p_rz_4
    t30 = B_1_z*D_p_ry_4
    t31 = (1/2)*D_p_x_5
    t32 = B_1_y*D_p_rz_5
    t33 = B_1_z*D_p_ry_5
    t34 = (1/2)*D_p_x_6
    t35 = B_1_y*D_p_rz_6
    t36 = B_1_z*D_p_ry_6
    t37 = (1/2)*D_p_y_1
    t38 = B_1_x*D_p_rz_1
    t39 = B_1_z*D_p_rx_1
    t40 = (1/2)*D_p_y_2
    t41 = B_1_x*D_p_rz_2
    t42 = B_1_z*D_p_rx_2
    t43 = (1/2)*D_p_y_3
    t44 = B_1_x*D_p_rz_3
    t45 = B_1_z*D_p_rx_3
    t46 = (1/2)*D_p_y_4
    t47 = B_1_x*D_p_rz_4
    t48 = B_1_z*D_p_rx_4
    t49 = (1/2)*D_p_y_5
    t50 = B_1_x*D_p_rz_5
    t51 = B_1_z*D_p_rx_5
    t52 = (1/2)*D_p_y_6
    t53 = B_1_x*D_p_rz_6
    t54 = B_1_z*D_p_rx_6
    t55 = (1/2)*D_p_z_1
    t56 = B_1_x*D_p_ry_1
    t57 = B_1_y*D_p_rx_1
    t58 = (1/2)*D_p_z_2
    t59 = B_1_x*D_p_ry_2
    t60 = B_1_y*D_p_rx_2
    t61 = (1/2)*D_p_z_3
    t62 = B_1_x*D_p_ry_3
    t63 = B_1_y*D_p_rx_3
    t64 = (1/2)*D_p_z_4
    t65 = B_1_x*D_p_ry_4
    t66 = B_1_y*D_p_rx_4
    t67 = (1/2)*D_p_z_5
    t68 = B_1_x*D_p_ry_5
    t69 = B_1_y*D_p_rx_5
    t70 = (1/2)*D_p_z_6
    t71 = B_1_x*D_p_ry_6
    t72 = B_1_y*D_p_rx_6
    t73 = B_2_y*D_p_rz_1
    t74 = B_2_z*D_p_ry_1
    t75 = B_2_y*D_p_rz_2
    t76 = B_2_z*D_p_ry_2
    t77 = B_2_y*D_p_rz_3
    t78 = B_2_z*D_p_ry_3
    t79 = B_2_y*D_p_rz_4
    t80 = B_2_z*D_p_ry_4
    t81 = B_2_y*D_p_rz_5
    t82 = B_2_z*D_p_ry_5
    t83 = B_2_y*D_p_rz_6
    t84 = B_2_z*D_p_ry_6
    t85 = B_2_x*D_p_rz_1
    t86 = B_2_z*D_p_rx_1
    t87 = B_2_x*D_p_rz_2
    t88 = B_2_z*D_p_rx_2
    t89 = B_2_x*D_p_rz_3
    t90 = B_2_z*D_p_rx_3
    t91 = B_2_x*D_p_rz_4
    t92 = B_2_z*D_p_rx_4
    t93 = B_2_x*D_p_rz_5
    t94 = B_2_z*D_p_rx_5
    t95 = B_2_x*D_p_rz_6
    t96 = B_2_z*D_p_rx_6
    t97 = B_2_x*D_p_ry_1
    t98 = B_2_y*D_p_rx_1
    t99 = B_2_x*D_p_ry_2
    t100 = B_2_y*D_p_rx_2
    t101 = B_2_x*D_p_ry_3
    t102 = B_2_y*D_p_rx_3
    t103 = B_2_x*D_p_ry_4
    t104 = B_2_y*D_p_rx_4
    t105 = B_2_x*D_p_ry_5
    t106 = B_2_y*D_p_rx_5
    t107 = B_2_x*D_p_ry_6
    t108 = B_2_y*D_p_rx_6
    t109 = B_3_y*D_p_rz_1
    t110 = B_3_z*D_p_ry_1
    t111 = B_3_y*D_p_rz_2
    t112 = B_3_z*D_p_ry_2
    t113 = B_3_y*D_p_rz_3
    t114 = B_3_z*D_p_ry_3
    t115 = B_3_y*D_p_rz_4
    t116 = B_3_z*D_p_ry_4
    t117 = B_3_y*D_p_rz_5
    t118 = B_3_z*D_p_ry_5
    t119 = B_3_y*D_p_rz_6
    t120 = B_3_z*D_p_ry_6
    t121 = B_3_x*D_p_rz_1
    t122 = B_3_z*D_p_rx_1
    t123 = B_3_x*D_p_rz_2
    t124 = B_3_z*D_p_rx_2
    t125 = B_3_x*D_p_rz_3
    t126 = B_3_z*D_p_rx_3
    t127 = B_3_x*D_p_rz_4
    t128 = B_3_z*D_p_rx_4
    t129 = B_3_x*D_p_rz_5
    t130 = B_3_z*D_p_rx_5
    t131 = B_3_x*D_p_rz_6
    t132 = B_3_z*D_p_rx_6
    t133 = B_3_x*D_p_ry_1
    t134 = B_3_y*D_p_rx_1
    t135 = B_3_x*D_p_ry_2
    t136 = B_3_y*D_p_rx_2
    t137 = B_3_x*D_p_ry_3
    t138 = B_3_y*D_p_rx_3
    t139 = B_3_x*D_p_ry_4
    t140 = B_3_y*D_p_rx_4
    t141 = B_3_x*D_p_ry_5
    t142 = B_3_y*D_p_rx_5
    t143 = B_3_x*D_p_ry_6
    t144 = B_3_y*D_p_rx_6
    t145 = B_4_y*D_p_rz_1
    t146 = B_4_z*D_p_ry_1
    t147 = B_4_y*D_p_rz_2
    t148 = B_4_z*D_p_ry_2
    t149 = B_4_y*D_p_rz_3
    t150 = B_4_z*D_p_ry_3
    t151 = B_4_y*D_p_rz_4
    t152 = B_4_z*D_p_ry_4
    t153 = B_4_y*D_p_rz_5
    t154 = B_4_z*D_p_ry_5
    t155 = B_4_y*D_p_rz_6
    t156 = B_4_z*D_p_ry_6
    t157 = B_4_x*D_p_rz_1
    t158 = B_4_z*D_p_rx_1
    t159 = B_4_x*D_p_rz_2
    t160 = B_4_z*D_p_rx_2
    t161 = B_4_x*D_p_rz_3
    t162 = B_4_z*D_p_rx_3
    t163 = B_4_x*D_p_rz_4
    t164 = B_4_z*D_p_rx_4
    t165 = B_4_x*D_p_rz_5
    t166 = B_4_z*D_p_rx_5
    t167 = B_4_x*D_p_rz_6
    t168 = B_4_z*D_p_rx_6
    t169 = B_4_x*D_p_ry_1
    t170 = B_4_y*D_p_rx_1
    t171 = B_4_x*D_p_ry_2
    t172 = B_4_y*D_p_rx_2
    t173 = B_4_x*D_p_ry_3
    t174 = B_4_y*D_p_rx_3
    t175 = B_4_x*D_p_ry_4
    t176 = B_4_y*D_p_rx_4
    t177 = B_4_x*D_p_ry_5
    t178 = B_4_y*D_p_rx_5
    t179 = B_4_x*D_p_ry_6
    t180 = B_4_y*D_p_rx_6
    t181 = B_5_y*D_p_rz_1
    t182 = B_5_z*D_p_ry_1
    t183 = B_5_y*D_p_rz_2
    t184 = B_5_z*D_p_ry_2
    t185 = B_5_y*D_p_rz_3
    t186 = B_5_z*D_p_ry_3
    t187 = B_5_y*D_p_rz_4
    t188 = B_5_z*D_p_ry_4
    t189 = B_5_y*D_p_rz_5
    t190 = B_5_z*D_p_ry_5
    t191 = B_5_y*D_p_rz_6
    t192 = B_5_z*D_p_ry_6
    t193 = B_5_x*D_p_rz_1
    t194 = B_5_z*D_p_rx_1
    t195 = B_5_x*D_p_rz_2
    t196 = B_5_z*D_p_rx_2
    t197 = B_5_x*D_p_rz_3
    t198 = B_5_z*D_p_rx_3
    t199 = B_5_x*D_p_rz_4
    t200 = B_5_z*D_p_rx_4
    t201 = B_5_x*D_p_rz_5
    t202 = B_5_z*D_p_rx_5
    t203 = B_5_x*D_p_rz_6
    t204 = B_5_z*D_p_rx_6
    t205 = B_5_x*D_p_ry_1
    t206 = B_5_y*D_p_rx_1
    t207 = B_5_x*D_p_ry_2
    t208 = B_5_y*D_p_rx_2
    t209 = B_5_x*D_p_ry_3
    t210 = B_5_y*D_p_rx_3
    t211 = B_5_x*D_p_ry_4
    t212 = B_5_y*D_p_rx_4
    t213 = B_5_x*D_p_ry_5
    t214 = B_5_y*D_p_rx_5
    t215 = B_5_x*D_p_ry_6
    t216 = B_5_y*D_p_rx_6
    t217 = B_6_y*D_p_rz_1
    t218 = B_6_z*D_p_ry_1
    t219 = B_6_y*D_p_rz_2
    t220 = B_6_z*D_p_ry_2
    t221 = B_6_y*D_p_rz_3
    t222 = B_6_z*D_p_ry_3
    t223 = B_6_y*D_p_rz_4
    t224 = B_6_z*D_p_ry_4
    t225 = B_6_y*D_p_rz_5
    t226 = B_6_z*D_p_ry_5
    t227 = B_6_y*D_p_rz_6
    t228 = B_6_z*D_p_ry_6
    t229 = B_6_x*D_p_rz_1
    t230 = B_6_z*D_p_rx_1
    t231 = B_6_x*D_p_rz_2
    t232 = B_6_z*D_p_rx_2
    t233 = B_6_x*D_p_rz_3
    t234 = B_6_z*D_p_rx_3
    t235 = B_6_x*D_p_rz_4
    t236 = B_6_z*D_p_rx_4
    t237 = B_6_x*D_p_rz_5
    t238 = B_6_z*D_p_rx_5
    t239 = B_6_x*D_p_rz_6
    t240 = B_6_z*D_p_rx_6
    t241 = B_6_x*D_p_ry_1
    t242 = B_6_y*D_p_rx_1
    t243 = B_6_x*D_p_ry_2
    t244 = B_6_y*D_p_rx_2
    t245 = B_6_x*D_p_ry_3
    t246 = B_6_y*D_p_rx_3
    t247 = B_6_x*D_p_ry_4
    t248 = B_6_y*D_p_rx_4
    t249 = B_6_x*D_p_ry_5
    t250 = B_6_y*D_p_rx_5
    t251 = B_6_x*D_p_ry_6
    t252 = B_6_y*D_p_rx_6
    J_out = np.zeros((*batch, 14, 3, 15), dtype)
    J_out[..., 0, 0, 0] = D_p_x_1
    J_out[..., 0, 0, 1] = D_p_x_2
    J_out[..., 0, 0, 2] = D_p_x_3
    J_out[..., 0, 0, 3] = D_p_x_4
    J_out[..., 0, 0, 4] = D_p_x_5
    J_out[..., 0, 0, 5] = D_p_x_6
    J_out[..., 0, 0, 12] = 1
    J_out[..., 0, 1, 0] = D_p_y_1
    J_out[..., 0, 1, 1] = D_p_y_2
    J_out[..., 0, 1, 2] = D_p_y_3
    J_out[..., 0, 1, 3] = D_p_y_4
    J_out[..., 0, 1, 4] = D_p_y_5
    J_out[..., 0, 1, 5] = D_p_y_6
    J_out[..., 0, 1, 13] = 1
    J_out[..., 0, 2, 0] = D_p_z_1
    J_out[..., 0, 2, 1] = D_p_z_2
    J_out[..., 0, 2, 2] = D_p_z_3
    J_out[..., 0, 2, 3] = D_p_z_4
    J_out[..., 0, 2, 4] = D_p_z_5
    J_out[..., 0, 2, 5] = D_p_z_6
    J_out[..., 0, 2, 14] = 1
    J_out[..., 1, 0, 12] = 1
    J_out[..., 1, 1, 13] = 1
    J_out[..., 1, 2, 14] = 1
    J_out[..., 2, 0, 0] = t19 - 1/2*t20 + (1/2)*t21
    J_out[..., 2, 0, 1] = t22 - 1/2*t23 + (1/2)*t24
    J_out[..., 2, 0, 2] = t25 - 1/2*t26 + (1/2)*t27
    J_out[..., 2, 0, 3] = t28 - 1/2*t29 + (1/2)*t30
    J_out[..., 2, 0, 4] = t31 - 1/2*t32 + (1/2)*t33
    J_out[..., 2, 0, 5] = t34 - 1/2*t35 + (1/2)*t36
    J_out[..., 2, 0, 12] = 1
    J_out[..., 2, 1, 0] = t37 + (1/2)*t38 - 1/2*t39
    J_out[..., 2, 1, 1] = t40 + (1/2)*t41 - 1/2*t42
    J_out[..., 2, 1, 2] = t43 + (1/2)*t44 - 1/2*t45
    J_out[..., 2, 1, 3] = t46 + (1/2)*t47 - 1/2*t48
    J_out[..., 2, 1, 4] = t49 + (1/2)*t50 - 1/2*t51
    J_out[..., 2, 1, 5] = t52 + (1/2)*t53 - 1/2*t54
    J_out[..., 2, 1, 13] = 1
    J_out[..., 2, 2, 0] = t55 - 1/2*t56 + (1/2)*t57
    J_out[..., 2, 2, 1] = t58 - 1/2*t59 + (1/2)*t60
    J_out[..., 2, 2, 2] = t61 - 1/2*t62 + (1/2)*t63
    J_out[..., 2, 2, 3] = t64 - 1/2*t65 + (1/2)*t66
    J_out[..., 2, 2, 4] = t67 - 1/2*t68 + (1/2)*t69
    J_out[..., 2, 2, 5] = t70 - 1/2*t71 + (1/2)*t72
    J_out[..., 2, 2, 14] = 1
    J_out[..., 3, 0, 0] = D_p_x_1 - t20 + t21
    J_out[..., 3, 0, 1] = D_p_x_2 - t23 + t24
    J_out[..., 3, 0, 2] = D_p_x_3 - t26 + t27
    J_out[..., 3, 0, 3] = D_p_x_4 - t29 + t30
    J_out[..., 3, 0, 4] = D_p_x_5 - t32 + t33
    J_out[..., 3, 0, 5] = D_p_x_6 - t35 + t36
    J_out[..., 3, 0, 12] = 1
    J_out[..., 3, 1, 0] = D_p_y_1 + t38 - t39
    J_out[..., 3, 1, 1] = D_p_y_2 + t41 - t42
    J_out[..., 3, 1, 2] = D_p_y_3 + t44 - t45
    J_out[..., 3, 1, 3] = D_p_y_4 + t47 - t48
    J_out[..., 3, 1, 4] = D_p_y_5 + t50 - t51
    J_out[..., 3, 1, 5] = D_p_y_6 + t53 - t54
    J_out[..., 3, 1, 13] = 1
    J_out[..., 3, 2, 0] = D_p_z_1 - t56 + t57
    J_out[..., 3, 2, 1] = D_p_z_2 - t59 + t60
    J_out[..., 3, 2, 2] = D_p_z_3 - t62 + t63
    J_out[..., 3, 2, 3] = D_p_z_4 - t65 + t66
    J_out[..., 3, 2, 4] = D_p_z_5 - t68 + t69
    J_out[..., 3, 2, 5] = D_p_z_6 - t71 + t72
    J_out[..., 3, 2, 14] = 1
    J_out[..., 4, 0, 0] = t19 - 1/2*t73 + (1/2)*t74
    J_out[..., 4, 0, 1] = t22 - 1/2*t75 + (1/2)*t76
    J_out[..., 4, 0, 2] = t25 - 1/2*t77 + (1/2)*t78
    J_out[..., 4, 0, 3] = t28 - 1/2*t79 + (1/2)*t80
    J_out[..., 4, 0, 4] = t31 - 1/2*t81 + (1/2)*t82
    J_out[..., 4, 0, 5] = t34 - 1/2*t83 + (1/2)*t84
    J_out[..., 4, 0, 12] = 1
    J_out[..., 4, 1, 0] = t37 + (1/2)*t85 - 1/2*t86
    J_out[..., 4, 1, 1] = t40 + (1/2)*t87 - 1/2*t88
    J_out[..., 4, 1, 2] = t43 + (1/2)*t89 - 1/2*t90
    J_out[..., 4, 1, 3] = t46 + (1/2)*t91 - 1/2*t92
    J_out[..., 4, 1, 4] = t49 + (1/2)*t93 - 1/2*t94
    J_out[..., 4, 1, 5] = t52 + (1/2)*t95 - 1/2*t96
    J_out[..., 4, 1, 13] = 1
    J_out[..., 4, 2, 0] = t55 - 1/2*t97 + (1/2)*t98
    J_out[..., 4, 2, 1] = (1/2)*t100 + t58 - 1/2*t99
    J_out[..., 4, 2, 2] = -1/2*t101 + (1/2)*t102 + t61
    J_out[..., 4, 2, 3] = -1/2*t103 + (1/2)*t104 + t64
    J_out[..., 4, 2, 4] = -1/2*t105 + (1/2)*t106 + t67
    J_out[..., 4, 2, 5] = -1/2*t107 + (1/2)*t108 + t70
    J_out[..., 4, 2, 14] = 1
    J_out[..., 5, 0, 0] = D_p_x_1 - t73 + t74
    J_out[..., 5, 0, 1] = D_p_x_2 - t75 + t76
    J_out[..., 5, 0, 2] = D_p_x_3 - t77 + t78
    J_out[..., 5, 0, 3] = D_p_x_4 - t79 + t80
    J_out[..., 5, 0, 4] = D_p_x_5 - t81 + t82
    J_out[..., 5, 0, 5] = D_p_x_6 - t83 + t84
    J_out[..., 5, 0, 12] = 1
    J_out[..., 5, 1, 0] = D_p_y_1 + t85 - t86
    J_out[..., 5, 1, 1] = D_p_y_2 + t87 - t88
    J_out[..., 5, 1, 2] = D_p_y_3 + t89 - t90
    J_out[..., 5, 1, 3] = D_p_y_4 + t91 - t92
    J_out[..., 5, 1, 4] = D_p_y_5 + t93 - t94
    J_out[..., 5, 1, 5] = D_p_y_6 + t95 - t96
    J_out[..., 5, 1, 13] = 1
    J_out[..., 5, 2, 0] = D_p_z_1 - t97 + t98
    J_out[..., 5, 2, 1] = D_p_z_2 + t100 - t99
    J_out[..., 5, 2, 2] = D_p_z_3 - t101 + t102
    J_out[..., 5, 2, 3] = D_p_z_4 - t103 + t104
    J_out[..., 5, 2, 4] = D_p_z_5 - t105 + t106
    J_out[..., 5, 2, 5] = D_p_z_6 - t107 + t108
    J_out[..., 5, 2, 14] = 1
    J_out[..., 6, 0, 0] = -1/2*t109 + (1/2)*t110 + t19
    J_out[..., 6, 0, 1] = -1/2*t111 + (1/2)*t112 + t22
    J_out[..., 6, 0, 2] = -1/2*t113 + (1/2)*t114 + t25
    J_out[..., 6, 0, 3] = -1/2*t115 + (1/2)*t116 + t28
    J_out[..., 6, 0, 4] = -1/2*t117 + (1/2)*t118 + t31
    J_out[..., 6, 0, 5] = -1/2*t119 + (1/2)*t120 + t34
    J_out[..., 6, 0, 12] = 1
    J_out[..., 6, 1, 0] = (1/2)*t121 - 1/2*t122 + t37
    J_out[..., 6, 1, 1] = (1/2)*t123 - 1/2*t124 + t40
    J_out[..., 6, 1, 2] = (1/2)*t125 - 1/2*t126 + t43
    J_out[..., 6, 1, 3] = (1/2)*t127 - 1/2*t128 + t46
    J_out[..., 6, 1, 4] = (1/2)*t129 - 1/2*t130 + t49
    J_out[..., 6, 1, 5] = (1/2)*t131 - 1/2*t132 + t52
    J_out[..., 6, 1, 13] = 1
    J_out[..., 6, 2, 0] = -1/2*t133 + (1/2)*t134 + t55
    J_out[..., 6, 2, 1] = -1/2*t135 + (1/2)*t136 + t58
    J_out[..., 6, 2, 2] = -1/2*t137 + (1/2)*t138 + t61
    J_out[..., 6, 2, 3] = -1/2*t139 + (1/2)*t140 + t64
    J_out[..., 6, 2, 4] = -1/2*t141 + (1/2)*t142 + t67
    J_out[..., 6, 2, 5] = -1/2*t143 + (1/2)*t144 + t70
    J_out[..., 6, 2, 14] = 1
    J_out[..., 7, 0, 0] = D_p_x_1 - t109 + t110
    J_out[..., 7, 0, 1] = D_p_x_2 - t111 + t112
    J_out[..., 7, 0, 2] = D_p_x_3 - t113 + t114
    J_out[..., 7, 0, 3] = D_p_x_4 - t115 + t116
    J_out[..., 7, 0, 4] = D_p_x_5 - t117 + t118
    J_out[..., 7, 0, 5] = D_p_x_6 - t119 + t120
    J_out[..., 7, 0, 12] = 1
    J_out[..., 7, 1, 0] = D_p_y_1 + t121 - t122
    J_out[..., 7, 1, 1] = D_p_y_2 + t123 - t124
    J_out[..., 7, 1, 2] = D_p_y_3 + t125 - t126
    J_out[..., 7, 1, 3] = D_p_y_4 + t127 - t128
    J_out[..., 7, 1, 4] = D_p_y_5 + t129 - t130
    J_out[..., 7, 1, 5] = D_p_y_6 + t131 - t132
    J_out[..., 7, 1, 13] = 1
    J_out[..., 7, 2, 0] = D_p_z_1 - t133 + t134
    J_out[..., 7, 2, 1] = D_p_z_2 - t135 + t136
    J_out[..., 7, 2, 2] = D_p_z_3 - t137 + t138
    J_out[..., 7, 2, 3] = D_p_z_4 - t139 + t140
    J_out[..., 7, 2, 4] = D_p_z_5 - t141 + t142
    J_out[..., 7, 2, 5] = D_p_z_6 - t143 + t144
    J_out[..., 7, 2, 14] = 1
    J_out[..., 8, 0, 0] = -1/2*t145 + (1/2)*t146 + t19
    J_out[..., 8, 0, 1] = -1/2*t147 + (1/2)*t148 + t22
    J_out[..., 8, 0, 2] = -1/2*t149 + (1/2)*t150 + t25
    J_out[..., 8, 0, 3] = -1/2*t151 + (1/2)*t152 + t28
    J_out[..., 8, 0, 4] = -1/2*t153 + (1/2)*t154 + t31
    J_out[..., 8, 0, 5] = -1/2*t155 + (1/2)*t156 + t34
    J_out[..., 8, 0, 12] = 1
    J_out[..., 8, 1, 0] = (1/2)*t157 - 1/2*t158 + t37
    J_out[..., 8, 1, 1] = (1/2)*t159 - 1/2*t160 + t40
    J_out[..., 8, 1, 2] = (1/2)*t161 - 1/2*t162 + t43
    J_out[..., 8, 1, 3] = (1/2)*t163 - 1/2*t164 + t46
    J_out[..., 8, 1, 4] = (1/2)*t165 - 1/2*t166 + t49
    J_out[..., 8, 1, 5] = (1/2)*t167 - 1/2*t168 + t52
    J_out[..., 8, 1, 13] = 1
    J_out[..., 8, 2, 0] = -1/2*t169 + (1/2)*t170 + t55
    J_out[..., 8, 2, 1] = -1/2*t171 + (1/2)*t172 + t58
    J_out[..., 8, 2, 2] = -1/2*t173 + (1/2)*t174 + t61
    J_out[..., 8, 2, 3] = -1/2*t175 + (1/2)*t176 + t64
    J_out[..., 8, 2, 4] = -1/2*t177 + (1/2)*t178 + t67
    J_out[..., 8, 2, 5] = -1/2*t179 + (1/2)*t180 + t70
    J_out[..., 8, 2, 14] = 1
    J_out[..., 9, 0, 0] = D_p_x_1 - t145 + t146
    J_out[..., 9, 0, 1] = D_p_x_2 - t147 + t148
    J_out[..., 9, 0, 2] = D_p_x_3 - t149 + t150
    J_out[..., 9, 0, 3] = D_p_x_4 - t151 + t152
    J_out[..., 9, 0, 4] = D_p_x_5 - t153 + t154
    J_out[..., 9, 0, 5] = D_p_x_6 - t155 + t156
    J_out[..., 9, 0, 12] = 1
    J_out[..., 9, 1, 0] = D_p_y_1 + t157 - t158
    J_out[..., 9, 1, 1] = D_p_y_2 + t159 - t160
    J_out[..., 9, 1, 2] = D_p_y_3 + t161 - t162
    J_out[..., 9, 1, 3] = D_p_y_4 + t163 - t164
    J_out[..., 9, 1, 4] = D_p_y_5 + t165 - t166
    J_out[..., 9, 1, 5] = D_p_y_6 + t167 - t168
    J_out[..., 9, 1, 13] = 1
    J_out[..., 9, 2, 0] = D_p_z_1 - t169 + t170
    J_out[..., 9, 2, 1] = D_p_z_2 - t171 + t172
    J_out[..., 9, 2, 2] = D_p_z_3 - t173 + t174
    J_out[..., 9, 2, 3] = D_p_z_4 - t175 + t176
    J_out[..., 9, 2, 4] = D_p_z_5 - t177 + t178
    J_out[..., 9, 2, 5] = D_p_z_6 - t179 + t180
    J_out[..., 9, 2, 14] = 1
    J_out[..., 10, 0, 0] = -1/2*t181 + (1/2)*t182 + t19
    J_out[..., 10, 0, 1] = -1/2*t183 + (1/2)*t184 + t22
    J_out[..., 10, 0, 2] = -1/2*t185 + (1/2)*t186 + t25
    J_out[..., 10, 0, 3] = -1/2*t187 + (1/2)*t188 + t28
    J_out[..., 10, 0, 4] = -1/2*t189 + (1/2)*t190 + t31
    J_out[..., 10, 0, 5] = -1/2*t191 + (1/2)*t192 + t34
    J_out[..., 10, 0, 12] = 1
    J_out[..., 10, 1, 0] = (1/2)*t193 - 1/2*t194 + t37
    J_out[..., 10, 1, 1] = (1/2)*t195 - 1/2*t196 + t40
    J_out[..., 10, 1, 2] = (1/2)*t197 - 1/2*t198 + t43
    J_out[..., 10, 1, 3] = (1/2)*t199 - 1/2*t200 + t46
    J_out[..., 10, 1, 4] = (1/2)*t201 - 1/2*t202 + t49
    J_out[..., 10, 1, 5] = (1/2)*t203 - 1/2*t204 + t52
    J_out[..., 10, 1, 13] = 1
    J_out[..., 10, 2, 0] = -1/2*t205 + (1/2)*t206 + t55
    J_out[..., 10, 2, 1] = -1/2*t207 + (1/2)*t208 + t58
    J_out[..., 10, 2, 2] = -1/2*t209 + (1/2)*t210 + t61
    J_out[..., 10, 2, 3] = -1/2*t211 + (1/2)*t212 + t64
    J_out[..., 10, 2, 4] = -1/2*t213 + (1/2)*t214 + t67
    J_out[..., 10, 2, 5] = -1/2*t215 + (1/2)*t216 + t70
    J_out[..., 10, 2, 14] = 1
    J_out[..., 11, 0, 0] = D_p_x_1 - t181 + t182
    J_out[..., 11, 0, 1] = D_p_x_2 - t183 + t184
    J_out[..., 11, 0, 2] = D_p_x_3 - t185 + t186
    J_out[..., 11, 0, 3] = D_p_x_4 - t187 + t188
    J_out[..., 11, 0, 4] = D_p_x_5 - t189 + t190
    J_out[..., 11, 0, 5] = D_p_x_6 - t191 + t192
    J_out[..., 11, 0, 12] = 1
    J_out[..., 11, 1, 0] = D_p_y_1 + t193 - t194
    J_out[..., 11, 1, 1] = D_p_y_2 + t195 - t196
    J_out[..., 11, 1, 2] = D_p_y_3 + t197 - t198
    J_out[..., 11, 1, 3] = D_p_y_4 + t199 - t200
    J_out[..., 11, 1, 4] = D_p_y_5 + t201 - t202
    J_out[..., 11, 1, 5] = D_p_y_6 + t203 - t204
    J_out[..., 11, 1, 13] = 1
    J_out[..., 11, 2, 0] = D_p_z_1 - t205 + t206
    J_out[..., 11, 2, 1] = D_p_z_2 - t207 + t208
    J_out[..., 11, 2, 2] = D_p_z_3 - t209 + t210
    J_out[..., 11, 2, 3] = D_p_z_4 - t211 + t212
    J_out[..., 11, 2, 4] = D_p_z_5 - t213 + t214
    J_out[..., 11, 2, 5] = D_p_z_6 - t215 + t216
    J_out[..., 11, 2, 14] = 1
    J_out[..., 12, 0, 0] = t19 - 1/2*t217 + (1/2)*t218
    J_out[..., 12, 0, 1] = -1/2*t219 + t22 + (1/2)*t220
    J_out[..., 12, 0, 2] = -1/2*t221 + (1/2)*t222 + t25
    J_out[..., 12, 0, 3] = -1/2*t223 + (1/2)*t224 + t28
    J_out[..., 12, 0, 4] = -1/2*t225 + (1/2)*t226 + t31
    J_out[..., 12, 0, 5] = -1/2*t227 + (1/2)*t228 + t34
    J_out[..., 12, 0, 12] = 1
    J_out[..., 12, 1, 0] = (1/2)*t229 - 1/2*t230 + t37
    J_out[..., 12, 1, 1] = (1/2)*t231 - 1/2*t232 + t40
    J_out[..., 12, 1, 2] = (1/2)*t233 - 1/2*t234 + t43
    J_out[..., 12, 1, 3] = (1/2)*t235 - 1/2*t236 + t46
    J_out[..., 12, 1, 4] = (1/2)*t237 - 1/2*t238 + t49
    J_out[..., 12, 1, 5] = (1/2)*t239 - 1/2*t240 + t52
    J_out[..., 12, 1, 13] = 1
    J_out[..., 12, 2, 0] = -1/2*t241 + (1/2)*t242 + t55
    J_out[..., 12, 2, 1] = -1/2*t243 + (1/2)*t244 + t58
    J_out[..., 12, 2, 2] = -1/2*t245 + (1/2)*t246 + t61
    J_out[..., 12, 2, 3] = -1/2*t247 + (1/2)*t248 + t64
    J_out[..., 12, 2, 4] = -1/2*t249 + (1/2)*t250 + t67
    J_out[..., 12, 2, 5] = -1/2*t251 + (1/2)*t252 + t70
    J_out[..., 12, 2, 14] = 1
    J_out[..., 13, 0, 0] = D_p_x_1 - t217 + t218
    J_out[..., 13, 0, 1] = D_p_x_2 - t219 + t220
    J_out[..., 13, 0, 2] = D_p_x_3 - t221 + t222
    J_out[..., 13, 0, 3] = D_p_x_4 - t223 + t224
    J_out[..., 13, 0, 4] = D_p_x_5 - t225 + t226
    J_out[..., 13, 0, 5] = D_p_x_6 - t227 + t228
    J_out[..., 13, 0, 12] = 1
    J_out[..., 13, 1, 0] = D_p_y_1 + t229 - t230
    J_out[..., 13, 1, 1] = D_p_y_2 + t231 - t232
    J_out[..., 13, 1, 2] = D_p_y_3 + t233 - t234
    J_out[..., 13, 1, 3] = D_p_y_4 + t235 - t236
    J_out[..., 13, 1, 4] = D_p_y_5 + t237 - t238
    J_out[..., 13, 1, 5] = D_p_y_6 + t239 - t240
    J_out[..., 13, 1, 13] = 1
    J_out[..., 13, 2, 0] = D_p_z_1 - t241 + t242
    J_out[..., 13, 2, 1] = D_p_z_2 - t243 + t244
    J_out[..., 13, 2, 2] = D_p_z_3 - t245 + t246
    J_out[..., 13, 2, 3] = D_p_z_4 - t247 + t248
    J_out[..., 13, 2, 4] = D_p_z_5 - t249 + t250
    J_out[..., 13, 2, 5] = D_p_z_6 - t251 + t252
    J_out[..., 13, 2, 14] = 1
    return J_out


def springs(p, parameters, effects):
    """Stiffness of every spring, and its elongation or twist per unit of each coordinate.

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
    k : array, shape (..., 15) [N/m, N m/rad]
        Stiffness.
    g : array, shape (..., 15, 15) [1, m, 1/m]
        The energy is the sum of k (g . q)^2 / 2.

    Notes
    -----
    Equation 38 with the effects' energies; the springs of released joints are not among them.
    1188 operations; 9130626 with every named value expanded.
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
    k_l_1, k_l_2, k_l_3, k_l_4, k_l_5, k_l_6 = _entries(parameters.leg_stiffness, (6,))
    (a_S_1,) = _entries(effects.axis_leg_stiffness_factor_1, ())
    (a_S_2,) = _entries(effects.axis_leg_stiffness_factor_2, ())
    (a_S_3,) = _entries(effects.axis_leg_stiffness_factor_3, ())
    (a_S_4,) = _entries(effects.axis_leg_stiffness_factor_4, ())
    (a_S_5,) = _entries(effects.axis_leg_stiffness_factor_5, ())
    (a_S_6,) = _entries(effects.axis_leg_stiffness_factor_6, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    batch, dtype = _batch(p_x, a_1_x, b_1_x, k_l_1, a_S_1, a_S_2, a_S_3, a_S_4, a_S_5, a_S_6, k_C, k_S)
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
    k_1 = k_l_1*(a_S_1 + 1)
    k_2 = k_l_2*(a_S_2 + 1)
    k_3 = k_l_3*(a_S_3 + 1)
    k_4 = k_l_4*(a_S_4 + 1)
    k_5 = k_l_5*(a_S_5 + 1)
    k_6 = k_l_6*(a_S_6 + 1)
    k_out = np.empty((*batch, 15), dtype)
    k_out[..., 0] = k_1
    k_out[..., 1] = k_2
    k_out[..., 2] = k_3
    k_out[..., 3] = k_4
    k_out[..., 4] = k_5
    k_out[..., 5] = k_6
    k_out[..., 6] = k_C
    k_out[..., 7] = k_C
    k_out[..., 8] = k_C
    k_out[..., 9] = k_S
    k_out[..., 10] = k_S
    k_out[..., 11] = k_S
    k_out[..., 12] = k_S
    k_out[..., 13] = k_S
    k_out[..., 14] = k_S
    g_out = np.zeros((*batch, 15, 15), dtype)
    g_out[..., 0, 0] = 1
    g_out[..., 0, 6] = -1
    g_out[..., 1, 1] = 1
    g_out[..., 1, 7] = -1
    g_out[..., 2, 2] = 1
    g_out[..., 2, 8] = -1
    g_out[..., 3, 3] = 1
    g_out[..., 3, 9] = -1
    g_out[..., 4, 4] = 1
    g_out[..., 4, 10] = -1
    g_out[..., 5, 5] = 1
    g_out[..., 5, 11] = -1
    g_out[..., 6, 0] = D_p_x_1
    g_out[..., 6, 1] = D_p_x_2
    g_out[..., 6, 2] = D_p_x_3
    g_out[..., 6, 3] = D_p_x_4
    g_out[..., 6, 4] = D_p_x_5
    g_out[..., 6, 5] = D_p_x_6
    g_out[..., 6, 12] = 1
    g_out[..., 7, 0] = D_p_y_1
    g_out[..., 7, 1] = D_p_y_2
    g_out[..., 7, 2] = D_p_y_3
    g_out[..., 7, 3] = D_p_y_4
    g_out[..., 7, 4] = D_p_y_5
    g_out[..., 7, 5] = D_p_y_6
    g_out[..., 7, 13] = 1
    g_out[..., 8, 0] = D_p_z_1
    g_out[..., 8, 1] = D_p_z_2
    g_out[..., 8, 2] = D_p_z_3
    g_out[..., 8, 3] = D_p_z_4
    g_out[..., 8, 4] = D_p_z_5
    g_out[..., 8, 5] = D_p_z_6
    g_out[..., 8, 14] = 1
    g_out[..., 9, 6] = 1
    g_out[..., 10, 7] = 1
    g_out[..., 11, 8] = 1
    g_out[..., 12, 9] = 1
    g_out[..., 13, 10] = 1
    g_out[..., 14, 11] = 1
    return k_out, g_out


def driven():
    """Which coordinates are rotations of a rotor that a motor drives.

    Parameters
    ----------

    Returns
    -------
    d : array, shape (..., 12) [1]
        1 where a motor turns the coordinate, else 0.

    Notes
    -----
    The drives that the mechanism declares.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    d_out = np.zeros((*batch, 12), dtype)
    d_out[..., 6] = 1
    d_out[..., 7] = 1
    d_out[..., 8] = 1
    d_out[..., 9] = 1
    d_out[..., 10] = 1
    d_out[..., 11] = 1
    return d_out
