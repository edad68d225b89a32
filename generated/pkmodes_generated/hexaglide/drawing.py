# Generated from the derivation of hexaglide and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Points and springs of the mechanism hexaglide, with effects, for pictures of it.

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
* l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
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
"""

from math import prod

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "drawing_directions",
    "drawing_motion",
    "drawing_points",
    "driven",
    "springs",
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


def drawing_points(p, up, parameters):
    """Positions of the points of a drawing.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    up : array, shape (..., 18) [1]
        Unit vectors that the robot leaves open, one after another.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    r : array, shape (..., 73, 3) [m]
        Base frame; first the platform.

    Notes
    -----
    The positions that the mechanism declares, or those of its parts.
    678 operations; 126180 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    (
        up_1_x, up_1_y, up_1_z, up_2_x, up_2_y, up_2_z, up_3_x, up_3_y, up_3_z, up_4_x, up_4_y, up_4_z,
        up_5_x, up_5_y, up_5_z, up_6_x, up_6_y, up_6_z,
    ) = _entries(up, (18,))
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
    R_p_1, R_p_2, R_p_3, R_p_4, R_p_5, R_p_6 = _entries(parameters.pulley_radius, (6,))
    (
        x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3, x_min_4, x_max_4, x_min_5, x_max_5, x_min_6,
        x_max_6,
    ) = _entries(parameters.limits, (6, 2))
    sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6 = _entries(parameters.branch, (6,))
    batch, dtype = _batch(p_x, up_1_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, R_p_1, x_min_1, sigma_1)
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
    t11 = B_1_x + p_x
    r_1_x = -o_1_x + t11
    R_y_x = rot_y*t10 + t8
    R_y_y = t6*(-t1 - t3) + 1
    t12 = rot_x*t7
    R_y_z = (1/2)*rot_y*rot_z*t5 - t12
    B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z
    t13 = B_1_y + p_y
    r_1_y = -o_1_y + t13
    R_z_x = (1/2)*rot_x*rot_z*t5 - t9
    R_z_y = rot_y*rot_z*t6 + t12
    R_z_z = t6*(-t1 - t2) + 1
    B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z
    t14 = B_1_z + p_z
    r_1_z = -o_1_z + t14
    B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z
    t15 = B_2_x + p_x
    r_2_x = -o_2_x + t15
    B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z
    t16 = B_2_y + p_y
    r_2_y = -o_2_y + t16
    B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z
    t17 = B_2_z + p_z
    r_2_z = -o_2_z + t17
    B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z
    t18 = B_3_x + p_x
    r_3_x = -o_3_x + t18
    B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z
    t19 = B_3_y + p_y
    r_3_y = -o_3_y + t19
    B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z
    t20 = B_3_z + p_z
    r_3_z = -o_3_z + t20
    B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z
    t21 = B_4_x + p_x
    r_4_x = -o_4_x + t21
    B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z
    t22 = B_4_y + p_y
    r_4_y = -o_4_y + t22
    B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z
    t23 = B_4_z + p_z
    r_4_z = -o_4_z + t23
    B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z
    t24 = B_5_x + p_x
    r_5_x = -o_5_x + t24
    B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z
    t25 = B_5_y + p_y
    r_5_y = -o_5_y + t25
    B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z
    t26 = B_5_z + p_z
    r_5_z = -o_5_z + t26
    B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z
    t27 = B_6_x + p_x
    r_6_x = -o_6_x + t27
    B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z
    t28 = B_6_y + p_y
    r_6_y = -o_6_y + t28
    B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z
    t29 = B_6_z + p_z
    r_6_z = -o_6_z + t29
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
    t30 = n_1_x*x_min_1 + o_1_x
    t31 = n_1_y*x_min_1 + o_1_y
    t32 = n_1_z*x_min_1 + o_1_z
    t33 = n_1_x*x_max_1 + o_1_x
    t34 = n_1_y*x_max_1 + o_1_y
    t35 = n_1_z*x_max_1 + o_1_z
    t36 = n_1_x*x_1 + o_1_x
    t37 = n_1_y*x_1 + o_1_y
    t38 = n_1_z*x_1 + o_1_z
    t39 = R_p_1 + (1/2)*l_t_1
    t40 = R_p_1*(-n_1_y*up_1_z + n_1_z*up_1_y)
    t41 = R_p_1*(n_1_x*up_1_z - n_1_z*up_1_x)
    t42 = R_p_1*(-n_1_x*up_1_y + n_1_y*up_1_x)
    t43 = R_p_1*up_1_x
    t44 = R_p_1*up_1_y
    t45 = R_p_1*up_1_z
    t46 = n_2_x*x_min_2 + o_2_x
    t47 = n_2_y*x_min_2 + o_2_y
    t48 = n_2_z*x_min_2 + o_2_z
    t49 = n_2_x*x_max_2 + o_2_x
    t50 = n_2_y*x_max_2 + o_2_y
    t51 = n_2_z*x_max_2 + o_2_z
    t52 = n_2_x*x_2 + o_2_x
    t53 = n_2_y*x_2 + o_2_y
    t54 = n_2_z*x_2 + o_2_z
    t55 = R_p_2 + (1/2)*l_t_2
    t56 = R_p_2*(-n_2_y*up_2_z + n_2_z*up_2_y)
    t57 = R_p_2*(n_2_x*up_2_z - n_2_z*up_2_x)
    t58 = R_p_2*(-n_2_x*up_2_y + n_2_y*up_2_x)
    t59 = R_p_2*up_2_x
    t60 = R_p_2*up_2_y
    t61 = R_p_2*up_2_z
    t62 = n_3_x*x_min_3 + o_3_x
    t63 = n_3_y*x_min_3 + o_3_y
    t64 = n_3_z*x_min_3 + o_3_z
    t65 = n_3_x*x_max_3 + o_3_x
    t66 = n_3_y*x_max_3 + o_3_y
    t67 = n_3_z*x_max_3 + o_3_z
    t68 = n_3_x*x_3 + o_3_x
    t69 = n_3_y*x_3 + o_3_y
    t70 = n_3_z*x_3 + o_3_z
    t71 = R_p_3 + (1/2)*l_t_3
    t72 = R_p_3*(-n_3_y*up_3_z + n_3_z*up_3_y)
    t73 = R_p_3*(n_3_x*up_3_z - n_3_z*up_3_x)
    t74 = R_p_3*(-n_3_x*up_3_y + n_3_y*up_3_x)
    t75 = R_p_3*up_3_x
    t76 = R_p_3*up_3_y
    t77 = R_p_3*up_3_z
    t78 = n_4_x*x_min_4 + o_4_x
    t79 = n_4_y*x_min_4 + o_4_y
    t80 = n_4_z*x_min_4 + o_4_z
    t81 = n_4_x*x_max_4 + o_4_x
    t82 = n_4_y*x_max_4 + o_4_y
    t83 = n_4_z*x_max_4 + o_4_z
    t84 = n_4_x*x_4 + o_4_x
    t85 = n_4_y*x_4 + o_4_y
    t86 = n_4_z*x_4 + o_4_z
    t87 = R_p_4 + (1/2)*l_t_4
    t88 = R_p_4*(-n_4_y*up_4_z + n_4_z*up_4_y)
    t89 = R_p_4*(n_4_x*up_4_z - n_4_z*up_4_x)
    t90 = R_p_4*(-n_4_x*up_4_y + n_4_y*up_4_x)
    t91 = R_p_4*up_4_x
    t92 = R_p_4*up_4_y
    t93 = R_p_4*up_4_z
    t94 = n_5_x*x_min_5 + o_5_x
    t95 = n_5_y*x_min_5 + o_5_y
    t96 = n_5_z*x_min_5 + o_5_z
    t97 = n_5_x*x_max_5 + o_5_x
    t98 = n_5_y*x_max_5 + o_5_y
    t99 = n_5_z*x_max_5 + o_5_z
    t100 = n_5_x*x_5 + o_5_x
    t101 = n_5_y*x_5 + o_5_y
    t102 = n_5_z*x_5 + o_5_z
    t103 = R_p_5 + (1/2)*l_t_5
    t104 = R_p_5*(-n_5_y*up_5_z + n_5_z*up_5_y)
    t105 = R_p_5*(n_5_x*up_5_z - n_5_z*up_5_x)
    t106 = R_p_5*(-n_5_x*up_5_y + n_5_y*up_5_x)
    t107 = R_p_5*up_5_x
    t108 = R_p_5*up_5_y
    t109 = R_p_5*up_5_z
    t110 = n_6_x*x_min_6 + o_6_x
    t111 = n_6_y*x_min_6 + o_6_y
    t112 = n_6_z*x_min_6 + o_6_z
    t113 = n_6_x*x_max_6 + o_6_x
    t114 = n_6_y*x_max_6 + o_6_y
    t115 = n_6_z*x_max_6 + o_6_z
    t116 = n_6_x*x_6 + o_6_x
    t117 = n_6_y*x_6 + o_6_y
    t118 = n_6_z*x_6 + o_6_z
    t119 = R_p_6 + (1/2)*l_t_6
    t120 = R_p_6*(-n_6_y*up_6_z + n_6_z*up_6_y)
    t121 = R_p_6*(n_6_x*up_6_z - n_6_z*up_6_x)
    t122 = R_p_6*(-n_6_x*up_6_y + n_6_y*up_6_x)
    t123 = R_p_6*up_6_x
    t124 = R_p_6*up_6_y
    t125 = R_p_6*up_6_z
    r_out = np.empty((*batch, 73, 3), dtype)
    r_out[..., 0, 0] = p_x
    r_out[..., 0, 1] = p_y
    r_out[..., 0, 2] = p_z
    r_out[..., 1, 0] = t30
    r_out[..., 1, 1] = t31
    r_out[..., 1, 2] = t32
    r_out[..., 2, 0] = t33
    r_out[..., 2, 1] = t34
    r_out[..., 2, 2] = t35
    r_out[..., 3, 0] = t36
    r_out[..., 3, 1] = t37
    r_out[..., 3, 2] = t38
    r_out[..., 4, 0] = n_1_x*t39 + t36
    r_out[..., 4, 1] = n_1_y*t39 + t37
    r_out[..., 4, 2] = n_1_z*t39 + t38
    r_out[..., 5, 0] = t11
    r_out[..., 5, 1] = t13
    r_out[..., 5, 2] = t14
    r_out[..., 6, 0] = t33 + t40
    r_out[..., 6, 1] = t34 + t41
    r_out[..., 6, 2] = t35 + t42
    r_out[..., 7, 0] = t30 + t40
    r_out[..., 7, 1] = t31 + t41
    r_out[..., 7, 2] = t32 + t42
    r_out[..., 8, 0] = t30 - t43
    r_out[..., 8, 1] = t31 - t44
    r_out[..., 8, 2] = t32 - t45
    r_out[..., 9, 0] = t33 - t43
    r_out[..., 9, 1] = t34 - t44
    r_out[..., 9, 2] = t35 - t45
    r_out[..., 10, 0] = t36 + t43
    r_out[..., 10, 1] = t37 + t44
    r_out[..., 10, 2] = t38 + t45
    r_out[..., 11, 0] = t30 + t43
    r_out[..., 11, 1] = t31 + t44
    r_out[..., 11, 2] = t32 + t45
    r_out[..., 12, 0] = t33 + t43
    r_out[..., 12, 1] = t34 + t44
    r_out[..., 12, 2] = t35 + t45
    r_out[..., 13, 0] = t46
    r_out[..., 13, 1] = t47
    r_out[..., 13, 2] = t48
    r_out[..., 14, 0] = t49
    r_out[..., 14, 1] = t50
    r_out[..., 14, 2] = t51
    r_out[..., 15, 0] = t52
    r_out[..., 15, 1] = t53
    r_out[..., 15, 2] = t54
    r_out[..., 16, 0] = n_2_x*t55 + t52
    r_out[..., 16, 1] = n_2_y*t55 + t53
    r_out[..., 16, 2] = n_2_z*t55 + t54
    r_out[..., 17, 0] = t15
    r_out[..., 17, 1] = t16
    r_out[..., 17, 2] = t17
    r_out[..., 18, 0] = t49 + t56
    r_out[..., 18, 1] = t50 + t57
    r_out[..., 18, 2] = t51 + t58
    r_out[..., 19, 0] = t46 + t56
    r_out[..., 19, 1] = t47 + t57
    r_out[..., 19, 2] = t48 + t58
    r_out[..., 20, 0] = t46 - t59
    r_out[..., 20, 1] = t47 - t60
    r_out[..., 20, 2] = t48 - t61
    r_out[..., 21, 0] = t49 - t59
    r_out[..., 21, 1] = t50 - t60
    r_out[..., 21, 2] = t51 - t61
    r_out[..., 22, 0] = t52 + t59
    r_out[..., 22, 1] = t53 + t60
    r_out[..., 22, 2] = t54 + t61
    r_out[..., 23, 0] = t46 + t59
    r_out[..., 23, 1] = t47 + t60
    r_out[..., 23, 2] = t48 + t61
    r_out[..., 24, 0] = t49 + t59
    r_out[..., 24, 1] = t50 + t60
    r_out[..., 24, 2] = t51 + t61
    r_out[..., 25, 0] = t62
    r_out[..., 25, 1] = t63
    r_out[..., 25, 2] = t64
    r_out[..., 26, 0] = t65
    r_out[..., 26, 1] = t66
    r_out[..., 26, 2] = t67
    r_out[..., 27, 0] = t68
    r_out[..., 27, 1] = t69
    r_out[..., 27, 2] = t70
    r_out[..., 28, 0] = n_3_x*t71 + t68
    r_out[..., 28, 1] = n_3_y*t71 + t69
    r_out[..., 28, 2] = n_3_z*t71 + t70
    r_out[..., 29, 0] = t18
    r_out[..., 29, 1] = t19
    r_out[..., 29, 2] = t20
    r_out[..., 30, 0] = t65 + t72
    r_out[..., 30, 1] = t66 + t73
    r_out[..., 30, 2] = t67 + t74
    r_out[..., 31, 0] = t62 + t72
    r_out[..., 31, 1] = t63 + t73
    r_out[..., 31, 2] = t64 + t74
    r_out[..., 32, 0] = t62 - t75
    r_out[..., 32, 1] = t63 - t76
    r_out[..., 32, 2] = t64 - t77
    r_out[..., 33, 0] = t65 - t75
    r_out[..., 33, 1] = t66 - t76
    r_out[..., 33, 2] = t67 - t77
    r_out[..., 34, 0] = t68 + t75
    r_out[..., 34, 1] = t69 + t76
    r_out[..., 34, 2] = t70 + t77
    r_out[..., 35, 0] = t62 + t75
    r_out[..., 35, 1] = t63 + t76
    r_out[..., 35, 2] = t64 + t77
    r_out[..., 36, 0] = t65 + t75
    r_out[..., 36, 1] = t66 + t76
    r_out[..., 36, 2] = t67 + t77
    r_out[..., 37, 0] = t78
    r_out[..., 37, 1] = t79
    r_out[..., 37, 2] = t80
    r_out[..., 38, 0] = t81
    r_out[..., 38, 1] = t82
    r_out[..., 38, 2] = t83
    r_out[..., 39, 0] = t84
    r_out[..., 39, 1] = t85
    r_out[..., 39, 2] = t86
    r_out[..., 40, 0] = n_4_x*t87 + t84
    r_out[..., 40, 1] = n_4_y*t87 + t85
    r_out[..., 40, 2] = n_4_z*t87 + t86
    r_out[..., 41, 0] = t21
    r_out[..., 41, 1] = t22
    r_out[..., 41, 2] = t23
    r_out[..., 42, 0] = t81 + t88
    r_out[..., 42, 1] = t82 + t89
    r_out[..., 42, 2] = t83 + t90
    r_out[..., 43, 0] = t78 + t88
    r_out[..., 43, 1] = t79 + t89
    r_out[..., 43, 2] = t80 + t90
    r_out[..., 44, 0] = t78 - t91
    r_out[..., 44, 1] = t79 - t92
    r_out[..., 44, 2] = t80 - t93
    r_out[..., 45, 0] = t81 - t91
    r_out[..., 45, 1] = t82 - t92
    r_out[..., 45, 2] = t83 - t93
    r_out[..., 46, 0] = t84 + t91
    r_out[..., 46, 1] = t85 + t92
    r_out[..., 46, 2] = t86 + t93
    r_out[..., 47, 0] = t78 + t91
    r_out[..., 47, 1] = t79 + t92
    r_out[..., 47, 2] = t80 + t93
    r_out[..., 48, 0] = t81 + t91
    r_out[..., 48, 1] = t82 + t92
    r_out[..., 48, 2] = t83 + t93
    r_out[..., 49, 0] = t94
    r_out[..., 49, 1] = t95
    r_out[..., 49, 2] = t96
    r_out[..., 50, 0] = t97
    r_out[..., 50, 1] = t98
    r_out[..., 50, 2] = t99
    r_out[..., 51, 0] = t100
    r_out[..., 51, 1] = t101
    r_out[..., 51, 2] = t102
    r_out[..., 52, 0] = n_5_x*t103 + t100
    r_out[..., 52, 1] = n_5_y*t103 + t101
    r_out[..., 52, 2] = n_5_z*t103 + t102
    r_out[..., 53, 0] = t24
    r_out[..., 53, 1] = t25
    r_out[..., 53, 2] = t26
    r_out[..., 54, 0] = t104 + t97
    r_out[..., 54, 1] = t105 + t98
    r_out[..., 54, 2] = t106 + t99
    r_out[..., 55, 0] = t104 + t94
    r_out[..., 55, 1] = t105 + t95
    r_out[..., 55, 2] = t106 + t96
    r_out[..., 56, 0] = -t107 + t94
    r_out[..., 56, 1] = -t108 + t95
    r_out[..., 56, 2] = -t109 + t96
    r_out[..., 57, 0] = -t107 + t97
    r_out[..., 57, 1] = -t108 + t98
    r_out[..., 57, 2] = -t109 + t99
    r_out[..., 58, 0] = t100 + t107
    r_out[..., 58, 1] = t101 + t108
    r_out[..., 58, 2] = t102 + t109
    r_out[..., 59, 0] = t107 + t94
    r_out[..., 59, 1] = t108 + t95
    r_out[..., 59, 2] = t109 + t96
    r_out[..., 60, 0] = t107 + t97
    r_out[..., 60, 1] = t108 + t98
    r_out[..., 60, 2] = t109 + t99
    r_out[..., 61, 0] = t110
    r_out[..., 61, 1] = t111
    r_out[..., 61, 2] = t112
    r_out[..., 62, 0] = t113
    r_out[..., 62, 1] = t114
    r_out[..., 62, 2] = t115
    r_out[..., 63, 0] = t116
    r_out[..., 63, 1] = t117
    r_out[..., 63, 2] = t118
    r_out[..., 64, 0] = n_6_x*t119 + t116
    r_out[..., 64, 1] = n_6_y*t119 + t117
    r_out[..., 64, 2] = n_6_z*t119 + t118
    r_out[..., 65, 0] = t27
    r_out[..., 65, 1] = t28
    r_out[..., 65, 2] = t29
    r_out[..., 66, 0] = t113 + t120
    r_out[..., 66, 1] = t114 + t121
    r_out[..., 66, 2] = t115 + t122
    r_out[..., 67, 0] = t110 + t120
    r_out[..., 67, 1] = t111 + t121
    r_out[..., 67, 2] = t112 + t122
    r_out[..., 68, 0] = t110 - t123
    r_out[..., 68, 1] = t111 - t124
    r_out[..., 68, 2] = t112 - t125
    r_out[..., 69, 0] = t113 - t123
    r_out[..., 69, 1] = t114 - t124
    r_out[..., 69, 2] = t115 - t125
    r_out[..., 70, 0] = t116 + t123
    r_out[..., 70, 1] = t117 + t124
    r_out[..., 70, 2] = t118 + t125
    r_out[..., 71, 0] = t110 + t123
    r_out[..., 71, 1] = t111 + t124
    r_out[..., 71, 2] = t112 + t125
    r_out[..., 72, 0] = t113 + t123
    r_out[..., 72, 1] = t114 + t124
    r_out[..., 72, 2] = t115 + t125
    return r_out


def drawing_motion(p, up, parameters):
    """Jacobians of these points with respect to every coordinate, one for points that move alike.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    up : array, shape (..., 18) [1]
        Unit vectors that the robot leaves open, one after another.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J : array, shape (..., 20, 3, 39) [1, m]
        dr_i/dq_k, base frame.

    Notes
    -----
    The positions differentiated, with the contributions of released joints and the frame.
    2564 operations; 3451159692 with every named value expanded.
    """
    p_x, p_y, p_z, rot_x, rot_y, rot_z = _entries(p, (6,))
    up_1_x, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _ = _entries(up, (18,))
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
    batch, dtype = _batch(p_x, up_1_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
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
    J_out = np.zeros((*batch, 20, 3, 39), dtype)
    J_out[..., 0, 0, 0] = D_p_x_1
    J_out[..., 0, 0, 1] = D_p_x_2
    J_out[..., 0, 0, 2] = D_p_x_3
    J_out[..., 0, 0, 3] = D_p_x_4
    J_out[..., 0, 0, 4] = D_p_x_5
    J_out[..., 0, 0, 5] = D_p_x_6
    J_out[..., 0, 0, 24] = D_delta_x_1
    J_out[..., 0, 0, 25] = D_delta_x_2
    J_out[..., 0, 0, 26] = D_delta_x_3
    J_out[..., 0, 0, 27] = D_delta_x_4
    J_out[..., 0, 0, 28] = D_delta_x_5
    J_out[..., 0, 0, 29] = D_delta_x_6
    J_out[..., 0, 0, 36] = 1
    J_out[..., 0, 1, 0] = D_p_y_1
    J_out[..., 0, 1, 1] = D_p_y_2
    J_out[..., 0, 1, 2] = D_p_y_3
    J_out[..., 0, 1, 3] = D_p_y_4
    J_out[..., 0, 1, 4] = D_p_y_5
    J_out[..., 0, 1, 5] = D_p_y_6
    J_out[..., 0, 1, 24] = D_delta_y_1
    J_out[..., 0, 1, 25] = D_delta_y_2
    J_out[..., 0, 1, 26] = D_delta_y_3
    J_out[..., 0, 1, 27] = D_delta_y_4
    J_out[..., 0, 1, 28] = D_delta_y_5
    J_out[..., 0, 1, 29] = D_delta_y_6
    J_out[..., 0, 1, 37] = 1
    J_out[..., 0, 2, 0] = D_p_z_1
    J_out[..., 0, 2, 1] = D_p_z_2
    J_out[..., 0, 2, 2] = D_p_z_3
    J_out[..., 0, 2, 3] = D_p_z_4
    J_out[..., 0, 2, 4] = D_p_z_5
    J_out[..., 0, 2, 5] = D_p_z_6
    J_out[..., 0, 2, 24] = D_delta_z_1
    J_out[..., 0, 2, 25] = D_delta_z_2
    J_out[..., 0, 2, 26] = D_delta_z_3
    J_out[..., 0, 2, 27] = D_delta_z_4
    J_out[..., 0, 2, 28] = D_delta_z_5
    J_out[..., 0, 2, 29] = D_delta_z_6
    J_out[..., 0, 2, 38] = 1
    J_out[..., 1, 0, 36] = 1
    J_out[..., 1, 1, 37] = 1
    J_out[..., 1, 2, 38] = 1
    J_out[..., 2, 0, 0] = n_1_x
    J_out[..., 2, 0, 36] = 1
    J_out[..., 2, 1, 0] = n_1_y
    J_out[..., 2, 1, 37] = 1
    J_out[..., 2, 2, 0] = n_1_z
    J_out[..., 2, 2, 38] = 1
    J_out[..., 3, 0, 0] = -B_1_y*D_p_rz_1 + B_1_z*D_p_ry_1 + D_p_x_1
    J_out[..., 3, 0, 1] = -B_1_y*D_p_rz_2 + B_1_z*D_p_ry_2 + D_p_x_2
    J_out[..., 3, 0, 2] = -B_1_y*D_p_rz_3 + B_1_z*D_p_ry_3 + D_p_x_3
    J_out[..., 3, 0, 3] = -B_1_y*D_p_rz_4 + B_1_z*D_p_ry_4 + D_p_x_4
    J_out[..., 3, 0, 4] = -B_1_y*D_p_rz_5 + B_1_z*D_p_ry_5 + D_p_x_5
    J_out[..., 3, 0, 5] = -B_1_y*D_p_rz_6 + B_1_z*D_p_ry_6 + D_p_x_6
    J_out[..., 3, 0, 24] = -B_1_y*D_delta_rz_1 + B_1_z*D_delta_ry_1 + D_delta_x_1
    J_out[..., 3, 0, 25] = -B_1_y*D_delta_rz_2 + B_1_z*D_delta_ry_2 + D_delta_x_2
    J_out[..., 3, 0, 26] = -B_1_y*D_delta_rz_3 + B_1_z*D_delta_ry_3 + D_delta_x_3
    J_out[..., 3, 0, 27] = -B_1_y*D_delta_rz_4 + B_1_z*D_delta_ry_4 + D_delta_x_4
    J_out[..., 3, 0, 28] = -B_1_y*D_delta_rz_5 + B_1_z*D_delta_ry_5 + D_delta_x_5
    J_out[..., 3, 0, 29] = -B_1_y*D_delta_rz_6 + B_1_z*D_delta_ry_6 + D_delta_x_6
    J_out[..., 3, 0, 36] = 1
    J_out[..., 3, 1, 0] = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1 + D_p_y_1
    J_out[..., 3, 1, 1] = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2 + D_p_y_2
    J_out[..., 3, 1, 2] = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3 + D_p_y_3
    J_out[..., 3, 1, 3] = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4 + D_p_y_4
    J_out[..., 3, 1, 4] = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5 + D_p_y_5
    J_out[..., 3, 1, 5] = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6 + D_p_y_6
    J_out[..., 3, 1, 24] = B_1_x*D_delta_rz_1 - B_1_z*D_delta_rx_1 + D_delta_y_1
    J_out[..., 3, 1, 25] = B_1_x*D_delta_rz_2 - B_1_z*D_delta_rx_2 + D_delta_y_2
    J_out[..., 3, 1, 26] = B_1_x*D_delta_rz_3 - B_1_z*D_delta_rx_3 + D_delta_y_3
    J_out[..., 3, 1, 27] = B_1_x*D_delta_rz_4 - B_1_z*D_delta_rx_4 + D_delta_y_4
    J_out[..., 3, 1, 28] = B_1_x*D_delta_rz_5 - B_1_z*D_delta_rx_5 + D_delta_y_5
    J_out[..., 3, 1, 29] = B_1_x*D_delta_rz_6 - B_1_z*D_delta_rx_6 + D_delta_y_6
    J_out[..., 3, 1, 37] = 1
    J_out[..., 3, 2, 0] = -B_1_x*D_p_ry_1 + B_1_y*D_p_rx_1 + D_p_z_1
    J_out[..., 3, 2, 1] = -B_1_x*D_p_ry_2 + B_1_y*D_p_rx_2 + D_p_z_2
    J_out[..., 3, 2, 2] = -B_1_x*D_p_ry_3 + B_1_y*D_p_rx_3 + D_p_z_3
    J_out[..., 3, 2, 3] = -B_1_x*D_p_ry_4 + B_1_y*D_p_rx_4 + D_p_z_4
    J_out[..., 3, 2, 4] = -B_1_x*D_p_ry_5 + B_1_y*D_p_rx_5 + D_p_z_5
    J_out[..., 3, 2, 5] = -B_1_x*D_p_ry_6 + B_1_y*D_p_rx_6 + D_p_z_6
    J_out[..., 3, 2, 24] = -B_1_x*D_delta_ry_1 + B_1_y*D_delta_rx_1 + D_delta_z_1
    J_out[..., 3, 2, 25] = -B_1_x*D_delta_ry_2 + B_1_y*D_delta_rx_2 + D_delta_z_2
    J_out[..., 3, 2, 26] = -B_1_x*D_delta_ry_3 + B_1_y*D_delta_rx_3 + D_delta_z_3
    J_out[..., 3, 2, 27] = -B_1_x*D_delta_ry_4 + B_1_y*D_delta_rx_4 + D_delta_z_4
    J_out[..., 3, 2, 28] = -B_1_x*D_delta_ry_5 + B_1_y*D_delta_rx_5 + D_delta_z_5
    J_out[..., 3, 2, 29] = -B_1_x*D_delta_ry_6 + B_1_y*D_delta_rx_6 + D_delta_z_6
    J_out[..., 3, 2, 38] = 1
    J_out[..., 4, 0, 0] = n_1_x
    J_out[..., 4, 0, 30] = n_1_x
    J_out[..., 4, 0, 36] = 1
    J_out[..., 4, 1, 0] = n_1_y
    J_out[..., 4, 1, 30] = n_1_y
    J_out[..., 4, 1, 37] = 1
    J_out[..., 4, 2, 0] = n_1_z
    J_out[..., 4, 2, 30] = n_1_z
    J_out[..., 4, 2, 38] = 1
    J_out[..., 5, 0, 1] = n_2_x
    J_out[..., 5, 0, 36] = 1
    J_out[..., 5, 1, 1] = n_2_y
    J_out[..., 5, 1, 37] = 1
    J_out[..., 5, 2, 1] = n_2_z
    J_out[..., 5, 2, 38] = 1
    J_out[..., 6, 0, 0] = -B_2_y*D_p_rz_1 + B_2_z*D_p_ry_1 + D_p_x_1
    J_out[..., 6, 0, 1] = -B_2_y*D_p_rz_2 + B_2_z*D_p_ry_2 + D_p_x_2
    J_out[..., 6, 0, 2] = -B_2_y*D_p_rz_3 + B_2_z*D_p_ry_3 + D_p_x_3
    J_out[..., 6, 0, 3] = -B_2_y*D_p_rz_4 + B_2_z*D_p_ry_4 + D_p_x_4
    J_out[..., 6, 0, 4] = -B_2_y*D_p_rz_5 + B_2_z*D_p_ry_5 + D_p_x_5
    J_out[..., 6, 0, 5] = -B_2_y*D_p_rz_6 + B_2_z*D_p_ry_6 + D_p_x_6
    J_out[..., 6, 0, 24] = -B_2_y*D_delta_rz_1 + B_2_z*D_delta_ry_1 + D_delta_x_1
    J_out[..., 6, 0, 25] = -B_2_y*D_delta_rz_2 + B_2_z*D_delta_ry_2 + D_delta_x_2
    J_out[..., 6, 0, 26] = -B_2_y*D_delta_rz_3 + B_2_z*D_delta_ry_3 + D_delta_x_3
    J_out[..., 6, 0, 27] = -B_2_y*D_delta_rz_4 + B_2_z*D_delta_ry_4 + D_delta_x_4
    J_out[..., 6, 0, 28] = -B_2_y*D_delta_rz_5 + B_2_z*D_delta_ry_5 + D_delta_x_5
    J_out[..., 6, 0, 29] = -B_2_y*D_delta_rz_6 + B_2_z*D_delta_ry_6 + D_delta_x_6
    J_out[..., 6, 0, 36] = 1
    J_out[..., 6, 1, 0] = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1 + D_p_y_1
    J_out[..., 6, 1, 1] = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2 + D_p_y_2
    J_out[..., 6, 1, 2] = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3 + D_p_y_3
    J_out[..., 6, 1, 3] = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4 + D_p_y_4
    J_out[..., 6, 1, 4] = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5 + D_p_y_5
    J_out[..., 6, 1, 5] = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6 + D_p_y_6
    J_out[..., 6, 1, 24] = B_2_x*D_delta_rz_1 - B_2_z*D_delta_rx_1 + D_delta_y_1
    J_out[..., 6, 1, 25] = B_2_x*D_delta_rz_2 - B_2_z*D_delta_rx_2 + D_delta_y_2
    J_out[..., 6, 1, 26] = B_2_x*D_delta_rz_3 - B_2_z*D_delta_rx_3 + D_delta_y_3
    J_out[..., 6, 1, 27] = B_2_x*D_delta_rz_4 - B_2_z*D_delta_rx_4 + D_delta_y_4
    J_out[..., 6, 1, 28] = B_2_x*D_delta_rz_5 - B_2_z*D_delta_rx_5 + D_delta_y_5
    J_out[..., 6, 1, 29] = B_2_x*D_delta_rz_6 - B_2_z*D_delta_rx_6 + D_delta_y_6
    J_out[..., 6, 1, 37] = 1
    J_out[..., 6, 2, 0] = -B_2_x*D_p_ry_1 + B_2_y*D_p_rx_1 + D_p_z_1
    J_out[..., 6, 2, 1] = -B_2_x*D_p_ry_2 + B_2_y*D_p_rx_2 + D_p_z_2
    J_out[..., 6, 2, 2] = -B_2_x*D_p_ry_3 + B_2_y*D_p_rx_3 + D_p_z_3
    J_out[..., 6, 2, 3] = -B_2_x*D_p_ry_4 + B_2_y*D_p_rx_4 + D_p_z_4
    J_out[..., 6, 2, 4] = -B_2_x*D_p_ry_5 + B_2_y*D_p_rx_5 + D_p_z_5
    J_out[..., 6, 2, 5] = -B_2_x*D_p_ry_6 + B_2_y*D_p_rx_6 + D_p_z_6
    J_out[..., 6, 2, 24] = -B_2_x*D_delta_ry_1 + B_2_y*D_delta_rx_1 + D_delta_z_1
    J_out[..., 6, 2, 25] = -B_2_x*D_delta_ry_2 + B_2_y*D_delta_rx_2 + D_delta_z_2
    J_out[..., 6, 2, 26] = -B_2_x*D_delta_ry_3 + B_2_y*D_delta_rx_3 + D_delta_z_3
    J_out[..., 6, 2, 27] = -B_2_x*D_delta_ry_4 + B_2_y*D_delta_rx_4 + D_delta_z_4
    J_out[..., 6, 2, 28] = -B_2_x*D_delta_ry_5 + B_2_y*D_delta_rx_5 + D_delta_z_5
    J_out[..., 6, 2, 29] = -B_2_x*D_delta_ry_6 + B_2_y*D_delta_rx_6 + D_delta_z_6
    J_out[..., 6, 2, 38] = 1
    J_out[..., 7, 0, 1] = n_2_x
    J_out[..., 7, 0, 31] = n_2_x
    J_out[..., 7, 0, 36] = 1
    J_out[..., 7, 1, 1] = n_2_y
    J_out[..., 7, 1, 31] = n_2_y
    J_out[..., 7, 1, 37] = 1
    J_out[..., 7, 2, 1] = n_2_z
    J_out[..., 7, 2, 31] = n_2_z
    J_out[..., 7, 2, 38] = 1
    J_out[..., 8, 0, 2] = n_3_x
    J_out[..., 8, 0, 36] = 1
    J_out[..., 8, 1, 2] = n_3_y
    J_out[..., 8, 1, 37] = 1
    J_out[..., 8, 2, 2] = n_3_z
    J_out[..., 8, 2, 38] = 1
    J_out[..., 9, 0, 0] = -B_3_y*D_p_rz_1 + B_3_z*D_p_ry_1 + D_p_x_1
    J_out[..., 9, 0, 1] = -B_3_y*D_p_rz_2 + B_3_z*D_p_ry_2 + D_p_x_2
    J_out[..., 9, 0, 2] = -B_3_y*D_p_rz_3 + B_3_z*D_p_ry_3 + D_p_x_3
    J_out[..., 9, 0, 3] = -B_3_y*D_p_rz_4 + B_3_z*D_p_ry_4 + D_p_x_4
    J_out[..., 9, 0, 4] = -B_3_y*D_p_rz_5 + B_3_z*D_p_ry_5 + D_p_x_5
    J_out[..., 9, 0, 5] = -B_3_y*D_p_rz_6 + B_3_z*D_p_ry_6 + D_p_x_6
    J_out[..., 9, 0, 24] = -B_3_y*D_delta_rz_1 + B_3_z*D_delta_ry_1 + D_delta_x_1
    J_out[..., 9, 0, 25] = -B_3_y*D_delta_rz_2 + B_3_z*D_delta_ry_2 + D_delta_x_2
    J_out[..., 9, 0, 26] = -B_3_y*D_delta_rz_3 + B_3_z*D_delta_ry_3 + D_delta_x_3
    J_out[..., 9, 0, 27] = -B_3_y*D_delta_rz_4 + B_3_z*D_delta_ry_4 + D_delta_x_4
    J_out[..., 9, 0, 28] = -B_3_y*D_delta_rz_5 + B_3_z*D_delta_ry_5 + D_delta_x_5
    J_out[..., 9, 0, 29] = -B_3_y*D_delta_rz_6 + B_3_z*D_delta_ry_6 + D_delta_x_6
    J_out[..., 9, 0, 36] = 1
    J_out[..., 9, 1, 0] = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1 + D_p_y_1
    J_out[..., 9, 1, 1] = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2 + D_p_y_2
    J_out[..., 9, 1, 2] = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3 + D_p_y_3
    J_out[..., 9, 1, 3] = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4 + D_p_y_4
    J_out[..., 9, 1, 4] = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5 + D_p_y_5
    J_out[..., 9, 1, 5] = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6 + D_p_y_6
    J_out[..., 9, 1, 24] = B_3_x*D_delta_rz_1 - B_3_z*D_delta_rx_1 + D_delta_y_1
    J_out[..., 9, 1, 25] = B_3_x*D_delta_rz_2 - B_3_z*D_delta_rx_2 + D_delta_y_2
    J_out[..., 9, 1, 26] = B_3_x*D_delta_rz_3 - B_3_z*D_delta_rx_3 + D_delta_y_3
    J_out[..., 9, 1, 27] = B_3_x*D_delta_rz_4 - B_3_z*D_delta_rx_4 + D_delta_y_4
    J_out[..., 9, 1, 28] = B_3_x*D_delta_rz_5 - B_3_z*D_delta_rx_5 + D_delta_y_5
    J_out[..., 9, 1, 29] = B_3_x*D_delta_rz_6 - B_3_z*D_delta_rx_6 + D_delta_y_6
    J_out[..., 9, 1, 37] = 1
    J_out[..., 9, 2, 0] = -B_3_x*D_p_ry_1 + B_3_y*D_p_rx_1 + D_p_z_1
    J_out[..., 9, 2, 1] = -B_3_x*D_p_ry_2 + B_3_y*D_p_rx_2 + D_p_z_2
    J_out[..., 9, 2, 2] = -B_3_x*D_p_ry_3 + B_3_y*D_p_rx_3 + D_p_z_3
    J_out[..., 9, 2, 3] = -B_3_x*D_p_ry_4 + B_3_y*D_p_rx_4 + D_p_z_4
    J_out[..., 9, 2, 4] = -B_3_x*D_p_ry_5 + B_3_y*D_p_rx_5 + D_p_z_5
    J_out[..., 9, 2, 5] = -B_3_x*D_p_ry_6 + B_3_y*D_p_rx_6 + D_p_z_6
    J_out[..., 9, 2, 24] = -B_3_x*D_delta_ry_1 + B_3_y*D_delta_rx_1 + D_delta_z_1
    J_out[..., 9, 2, 25] = -B_3_x*D_delta_ry_2 + B_3_y*D_delta_rx_2 + D_delta_z_2
    J_out[..., 9, 2, 26] = -B_3_x*D_delta_ry_3 + B_3_y*D_delta_rx_3 + D_delta_z_3
    J_out[..., 9, 2, 27] = -B_3_x*D_delta_ry_4 + B_3_y*D_delta_rx_4 + D_delta_z_4
    J_out[..., 9, 2, 28] = -B_3_x*D_delta_ry_5 + B_3_y*D_delta_rx_5 + D_delta_z_5
    J_out[..., 9, 2, 29] = -B_3_x*D_delta_ry_6 + B_3_y*D_delta_rx_6 + D_delta_z_6
    J_out[..., 9, 2, 38] = 1
    J_out[..., 10, 0, 2] = n_3_x
    J_out[..., 10, 0, 32] = n_3_x
    J_out[..., 10, 0, 36] = 1
    J_out[..., 10, 1, 2] = n_3_y
    J_out[..., 10, 1, 32] = n_3_y
    J_out[..., 10, 1, 37] = 1
    J_out[..., 10, 2, 2] = n_3_z
    J_out[..., 10, 2, 32] = n_3_z
    J_out[..., 10, 2, 38] = 1
    J_out[..., 11, 0, 3] = n_4_x
    J_out[..., 11, 0, 36] = 1
    J_out[..., 11, 1, 3] = n_4_y
    J_out[..., 11, 1, 37] = 1
    J_out[..., 11, 2, 3] = n_4_z
    J_out[..., 11, 2, 38] = 1
    J_out[..., 12, 0, 0] = -B_4_y*D_p_rz_1 + B_4_z*D_p_ry_1 + D_p_x_1
    J_out[..., 12, 0, 1] = -B_4_y*D_p_rz_2 + B_4_z*D_p_ry_2 + D_p_x_2
    J_out[..., 12, 0, 2] = -B_4_y*D_p_rz_3 + B_4_z*D_p_ry_3 + D_p_x_3
    J_out[..., 12, 0, 3] = -B_4_y*D_p_rz_4 + B_4_z*D_p_ry_4 + D_p_x_4
    J_out[..., 12, 0, 4] = -B_4_y*D_p_rz_5 + B_4_z*D_p_ry_5 + D_p_x_5
    J_out[..., 12, 0, 5] = -B_4_y*D_p_rz_6 + B_4_z*D_p_ry_6 + D_p_x_6
    J_out[..., 12, 0, 24] = -B_4_y*D_delta_rz_1 + B_4_z*D_delta_ry_1 + D_delta_x_1
    J_out[..., 12, 0, 25] = -B_4_y*D_delta_rz_2 + B_4_z*D_delta_ry_2 + D_delta_x_2
    J_out[..., 12, 0, 26] = -B_4_y*D_delta_rz_3 + B_4_z*D_delta_ry_3 + D_delta_x_3
    J_out[..., 12, 0, 27] = -B_4_y*D_delta_rz_4 + B_4_z*D_delta_ry_4 + D_delta_x_4
    J_out[..., 12, 0, 28] = -B_4_y*D_delta_rz_5 + B_4_z*D_delta_ry_5 + D_delta_x_5
    J_out[..., 12, 0, 29] = -B_4_y*D_delta_rz_6 + B_4_z*D_delta_ry_6 + D_delta_x_6
    J_out[..., 12, 0, 36] = 1
    J_out[..., 12, 1, 0] = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1 + D_p_y_1
    J_out[..., 12, 1, 1] = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2 + D_p_y_2
    J_out[..., 12, 1, 2] = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3 + D_p_y_3
    J_out[..., 12, 1, 3] = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4 + D_p_y_4
    J_out[..., 12, 1, 4] = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5 + D_p_y_5
    J_out[..., 12, 1, 5] = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6 + D_p_y_6
    J_out[..., 12, 1, 24] = B_4_x*D_delta_rz_1 - B_4_z*D_delta_rx_1 + D_delta_y_1
    J_out[..., 12, 1, 25] = B_4_x*D_delta_rz_2 - B_4_z*D_delta_rx_2 + D_delta_y_2
    J_out[..., 12, 1, 26] = B_4_x*D_delta_rz_3 - B_4_z*D_delta_rx_3 + D_delta_y_3
    J_out[..., 12, 1, 27] = B_4_x*D_delta_rz_4 - B_4_z*D_delta_rx_4 + D_delta_y_4
    J_out[..., 12, 1, 28] = B_4_x*D_delta_rz_5 - B_4_z*D_delta_rx_5 + D_delta_y_5
    J_out[..., 12, 1, 29] = B_4_x*D_delta_rz_6 - B_4_z*D_delta_rx_6 + D_delta_y_6
    J_out[..., 12, 1, 37] = 1
    J_out[..., 12, 2, 0] = -B_4_x*D_p_ry_1 + B_4_y*D_p_rx_1 + D_p_z_1
    J_out[..., 12, 2, 1] = -B_4_x*D_p_ry_2 + B_4_y*D_p_rx_2 + D_p_z_2
    J_out[..., 12, 2, 2] = -B_4_x*D_p_ry_3 + B_4_y*D_p_rx_3 + D_p_z_3
    J_out[..., 12, 2, 3] = -B_4_x*D_p_ry_4 + B_4_y*D_p_rx_4 + D_p_z_4
    J_out[..., 12, 2, 4] = -B_4_x*D_p_ry_5 + B_4_y*D_p_rx_5 + D_p_z_5
    J_out[..., 12, 2, 5] = -B_4_x*D_p_ry_6 + B_4_y*D_p_rx_6 + D_p_z_6
    J_out[..., 12, 2, 24] = -B_4_x*D_delta_ry_1 + B_4_y*D_delta_rx_1 + D_delta_z_1
    J_out[..., 12, 2, 25] = -B_4_x*D_delta_ry_2 + B_4_y*D_delta_rx_2 + D_delta_z_2
    J_out[..., 12, 2, 26] = -B_4_x*D_delta_ry_3 + B_4_y*D_delta_rx_3 + D_delta_z_3
    J_out[..., 12, 2, 27] = -B_4_x*D_delta_ry_4 + B_4_y*D_delta_rx_4 + D_delta_z_4
    J_out[..., 12, 2, 28] = -B_4_x*D_delta_ry_5 + B_4_y*D_delta_rx_5 + D_delta_z_5
    J_out[..., 12, 2, 29] = -B_4_x*D_delta_ry_6 + B_4_y*D_delta_rx_6 + D_delta_z_6
    J_out[..., 12, 2, 38] = 1
    J_out[..., 13, 0, 3] = n_4_x
    J_out[..., 13, 0, 33] = n_4_x
    J_out[..., 13, 0, 36] = 1
    J_out[..., 13, 1, 3] = n_4_y
    J_out[..., 13, 1, 33] = n_4_y
    J_out[..., 13, 1, 37] = 1
    J_out[..., 13, 2, 3] = n_4_z
    J_out[..., 13, 2, 33] = n_4_z
    J_out[..., 13, 2, 38] = 1
    J_out[..., 14, 0, 4] = n_5_x
    J_out[..., 14, 0, 36] = 1
    J_out[..., 14, 1, 4] = n_5_y
    J_out[..., 14, 1, 37] = 1
    J_out[..., 14, 2, 4] = n_5_z
    J_out[..., 14, 2, 38] = 1
    J_out[..., 15, 0, 0] = -B_5_y*D_p_rz_1 + B_5_z*D_p_ry_1 + D_p_x_1
    J_out[..., 15, 0, 1] = -B_5_y*D_p_rz_2 + B_5_z*D_p_ry_2 + D_p_x_2
    J_out[..., 15, 0, 2] = -B_5_y*D_p_rz_3 + B_5_z*D_p_ry_3 + D_p_x_3
    J_out[..., 15, 0, 3] = -B_5_y*D_p_rz_4 + B_5_z*D_p_ry_4 + D_p_x_4
    J_out[..., 15, 0, 4] = -B_5_y*D_p_rz_5 + B_5_z*D_p_ry_5 + D_p_x_5
    J_out[..., 15, 0, 5] = -B_5_y*D_p_rz_6 + B_5_z*D_p_ry_6 + D_p_x_6
    J_out[..., 15, 0, 24] = -B_5_y*D_delta_rz_1 + B_5_z*D_delta_ry_1 + D_delta_x_1
    J_out[..., 15, 0, 25] = -B_5_y*D_delta_rz_2 + B_5_z*D_delta_ry_2 + D_delta_x_2
    J_out[..., 15, 0, 26] = -B_5_y*D_delta_rz_3 + B_5_z*D_delta_ry_3 + D_delta_x_3
    J_out[..., 15, 0, 27] = -B_5_y*D_delta_rz_4 + B_5_z*D_delta_ry_4 + D_delta_x_4
    J_out[..., 15, 0, 28] = -B_5_y*D_delta_rz_5 + B_5_z*D_delta_ry_5 + D_delta_x_5
    J_out[..., 15, 0, 29] = -B_5_y*D_delta_rz_6 + B_5_z*D_delta_ry_6 + D_delta_x_6
    J_out[..., 15, 0, 36] = 1
    J_out[..., 15, 1, 0] = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1 + D_p_y_1
    J_out[..., 15, 1, 1] = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2 + D_p_y_2
    J_out[..., 15, 1, 2] = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3 + D_p_y_3
    J_out[..., 15, 1, 3] = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4 + D_p_y_4
    J_out[..., 15, 1, 4] = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5 + D_p_y_5
    J_out[..., 15, 1, 5] = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6 + D_p_y_6
    J_out[..., 15, 1, 24] = B_5_x*D_delta_rz_1 - B_5_z*D_delta_rx_1 + D_delta_y_1
    J_out[..., 15, 1, 25] = B_5_x*D_delta_rz_2 - B_5_z*D_delta_rx_2 + D_delta_y_2
    J_out[..., 15, 1, 26] = B_5_x*D_delta_rz_3 - B_5_z*D_delta_rx_3 + D_delta_y_3
    J_out[..., 15, 1, 27] = B_5_x*D_delta_rz_4 - B_5_z*D_delta_rx_4 + D_delta_y_4
    J_out[..., 15, 1, 28] = B_5_x*D_delta_rz_5 - B_5_z*D_delta_rx_5 + D_delta_y_5
    J_out[..., 15, 1, 29] = B_5_x*D_delta_rz_6 - B_5_z*D_delta_rx_6 + D_delta_y_6
    J_out[..., 15, 1, 37] = 1
    J_out[..., 15, 2, 0] = -B_5_x*D_p_ry_1 + B_5_y*D_p_rx_1 + D_p_z_1
    J_out[..., 15, 2, 1] = -B_5_x*D_p_ry_2 + B_5_y*D_p_rx_2 + D_p_z_2
    J_out[..., 15, 2, 2] = -B_5_x*D_p_ry_3 + B_5_y*D_p_rx_3 + D_p_z_3
    J_out[..., 15, 2, 3] = -B_5_x*D_p_ry_4 + B_5_y*D_p_rx_4 + D_p_z_4
    J_out[..., 15, 2, 4] = -B_5_x*D_p_ry_5 + B_5_y*D_p_rx_5 + D_p_z_5
    J_out[..., 15, 2, 5] = -B_5_x*D_p_ry_6 + B_5_y*D_p_rx_6 + D_p_z_6
    J_out[..., 15, 2, 24] = -B_5_x*D_delta_ry_1 + B_5_y*D_delta_rx_1 + D_delta_z_1
    J_out[..., 15, 2, 25] = -B_5_x*D_delta_ry_2 + B_5_y*D_delta_rx_2 + D_delta_z_2
    J_out[..., 15, 2, 26] = -B_5_x*D_delta_ry_3 + B_5_y*D_delta_rx_3 + D_delta_z_3
    J_out[..., 15, 2, 27] = -B_5_x*D_delta_ry_4 + B_5_y*D_delta_rx_4 + D_delta_z_4
    J_out[..., 15, 2, 28] = -B_5_x*D_delta_ry_5 + B_5_y*D_delta_rx_5 + D_delta_z_5
    J_out[..., 15, 2, 29] = -B_5_x*D_delta_ry_6 + B_5_y*D_delta_rx_6 + D_delta_z_6
    J_out[..., 15, 2, 38] = 1
    J_out[..., 16, 0, 4] = n_5_x
    J_out[..., 16, 0, 34] = n_5_x
    J_out[..., 16, 0, 36] = 1
    J_out[..., 16, 1, 4] = n_5_y
    J_out[..., 16, 1, 34] = n_5_y
    J_out[..., 16, 1, 37] = 1
    J_out[..., 16, 2, 4] = n_5_z
    J_out[..., 16, 2, 34] = n_5_z
    J_out[..., 16, 2, 38] = 1
    J_out[..., 17, 0, 5] = n_6_x
    J_out[..., 17, 0, 36] = 1
    J_out[..., 17, 1, 5] = n_6_y
    J_out[..., 17, 1, 37] = 1
    J_out[..., 17, 2, 5] = n_6_z
    J_out[..., 17, 2, 38] = 1
    J_out[..., 18, 0, 0] = -B_6_y*D_p_rz_1 + B_6_z*D_p_ry_1 + D_p_x_1
    J_out[..., 18, 0, 1] = -B_6_y*D_p_rz_2 + B_6_z*D_p_ry_2 + D_p_x_2
    J_out[..., 18, 0, 2] = -B_6_y*D_p_rz_3 + B_6_z*D_p_ry_3 + D_p_x_3
    J_out[..., 18, 0, 3] = -B_6_y*D_p_rz_4 + B_6_z*D_p_ry_4 + D_p_x_4
    J_out[..., 18, 0, 4] = -B_6_y*D_p_rz_5 + B_6_z*D_p_ry_5 + D_p_x_5
    J_out[..., 18, 0, 5] = -B_6_y*D_p_rz_6 + B_6_z*D_p_ry_6 + D_p_x_6
    J_out[..., 18, 0, 24] = -B_6_y*D_delta_rz_1 + B_6_z*D_delta_ry_1 + D_delta_x_1
    J_out[..., 18, 0, 25] = -B_6_y*D_delta_rz_2 + B_6_z*D_delta_ry_2 + D_delta_x_2
    J_out[..., 18, 0, 26] = -B_6_y*D_delta_rz_3 + B_6_z*D_delta_ry_3 + D_delta_x_3
    J_out[..., 18, 0, 27] = -B_6_y*D_delta_rz_4 + B_6_z*D_delta_ry_4 + D_delta_x_4
    J_out[..., 18, 0, 28] = -B_6_y*D_delta_rz_5 + B_6_z*D_delta_ry_5 + D_delta_x_5
    J_out[..., 18, 0, 29] = -B_6_y*D_delta_rz_6 + B_6_z*D_delta_ry_6 + D_delta_x_6
    J_out[..., 18, 0, 36] = 1
    J_out[..., 18, 1, 0] = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1 + D_p_y_1
    J_out[..., 18, 1, 1] = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2 + D_p_y_2
    J_out[..., 18, 1, 2] = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3 + D_p_y_3
    J_out[..., 18, 1, 3] = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4 + D_p_y_4
    J_out[..., 18, 1, 4] = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5 + D_p_y_5
    J_out[..., 18, 1, 5] = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6 + D_p_y_6
    J_out[..., 18, 1, 24] = B_6_x*D_delta_rz_1 - B_6_z*D_delta_rx_1 + D_delta_y_1
    J_out[..., 18, 1, 25] = B_6_x*D_delta_rz_2 - B_6_z*D_delta_rx_2 + D_delta_y_2
    J_out[..., 18, 1, 26] = B_6_x*D_delta_rz_3 - B_6_z*D_delta_rx_3 + D_delta_y_3
    J_out[..., 18, 1, 27] = B_6_x*D_delta_rz_4 - B_6_z*D_delta_rx_4 + D_delta_y_4
    J_out[..., 18, 1, 28] = B_6_x*D_delta_rz_5 - B_6_z*D_delta_rx_5 + D_delta_y_5
    J_out[..., 18, 1, 29] = B_6_x*D_delta_rz_6 - B_6_z*D_delta_rx_6 + D_delta_y_6
    J_out[..., 18, 1, 37] = 1
    J_out[..., 18, 2, 0] = -B_6_x*D_p_ry_1 + B_6_y*D_p_rx_1 + D_p_z_1
    J_out[..., 18, 2, 1] = -B_6_x*D_p_ry_2 + B_6_y*D_p_rx_2 + D_p_z_2
    J_out[..., 18, 2, 2] = -B_6_x*D_p_ry_3 + B_6_y*D_p_rx_3 + D_p_z_3
    J_out[..., 18, 2, 3] = -B_6_x*D_p_ry_4 + B_6_y*D_p_rx_4 + D_p_z_4
    J_out[..., 18, 2, 4] = -B_6_x*D_p_ry_5 + B_6_y*D_p_rx_5 + D_p_z_5
    J_out[..., 18, 2, 5] = -B_6_x*D_p_ry_6 + B_6_y*D_p_rx_6 + D_p_z_6
    J_out[..., 18, 2, 24] = -B_6_x*D_delta_ry_1 + B_6_y*D_delta_rx_1 + D_delta_z_1
    J_out[..., 18, 2, 25] = -B_6_x*D_delta_ry_2 + B_6_y*D_delta_rx_2 + D_delta_z_2
    J_out[..., 18, 2, 26] = -B_6_x*D_delta_ry_3 + B_6_y*D_delta_rx_3 + D_delta_z_3
    J_out[..., 18, 2, 27] = -B_6_x*D_delta_ry_4 + B_6_y*D_delta_rx_4 + D_delta_z_4
    J_out[..., 18, 2, 28] = -B_6_x*D_delta_ry_5 + B_6_y*D_delta_rx_5 + D_delta_z_5
    J_out[..., 18, 2, 29] = -B_6_x*D_delta_ry_6 + B_6_y*D_delta_rx_6 + D_delta_z_6
    J_out[..., 18, 2, 38] = 1
    J_out[..., 19, 0, 5] = n_6_x
    J_out[..., 19, 0, 35] = n_6_x
    J_out[..., 19, 0, 36] = 1
    J_out[..., 19, 1, 5] = n_6_y
    J_out[..., 19, 1, 35] = n_6_y
    J_out[..., 19, 1, 37] = 1
    J_out[..., 19, 2, 5] = n_6_z
    J_out[..., 19, 2, 35] = n_6_z
    J_out[..., 19, 2, 38] = 1
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
    k : array, shape (..., 33) [N/m, N m/rad]
        Stiffness.
    g : array, shape (..., 33, 39) [1, m, 1/m]
        The energy is the sum of k (g . q)^2 / 2.

    Notes
    -----
    Equation 38 with the effects' energies; the springs of released joints are not among them.
    1497 operations; 184014288 with every named value expanded.
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
        d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2, d_4_1, d_4_2, d_5_1, d_5_2, d_6_1, d_6_2,
    ) = _entries(parameters.drive, (6, 2))
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
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, d_1_1, x_min_1,
        sigma_1, a_B_1, a_B_2, a_B_3, a_B_4, a_B_5, a_B_6, c_E, c_T, F_T, k_C, k_S)
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
    l_f_1_1 = x_max_1 - x_min_1
    t31 = F_T*c_T + 1
    t32 = c_E*t31
    t33 = k_sp_1*w_b_1*(a_B_1 + 1)
    t34 = t32*t33
    t35 = t31*t33
    k_1_1 = t35/(l_f_1_1 + t34)
    t36 = (1/2)*l_t_1
    l_f_1_2 = -t36 + x_1 - x_min_1
    k_1_2 = t35/(l_f_1_2 + t34)
    l_f_1_3 = -t36 - x_1 + x_max_1
    k_1_3 = t35/(l_f_1_3 + t34)
    l_f_2_1 = x_max_2 - x_min_2
    t37 = k_sp_2*w_b_2*(a_B_2 + 1)
    t38 = t32*t37
    t39 = t31*t37
    k_2_1 = t39/(l_f_2_1 + t38)
    t40 = (1/2)*l_t_2
    l_f_2_2 = -t40 + x_2 - x_min_2
    k_2_2 = t39/(l_f_2_2 + t38)
    l_f_2_3 = -t40 - x_2 + x_max_2
    k_2_3 = t39/(l_f_2_3 + t38)
    l_f_3_1 = x_max_3 - x_min_3
    t41 = k_sp_3*w_b_3*(a_B_3 + 1)
    t42 = t32*t41
    t43 = t31*t41
    k_3_1 = t43/(l_f_3_1 + t42)
    t44 = (1/2)*l_t_3
    l_f_3_2 = -t44 + x_3 - x_min_3
    k_3_2 = t43/(l_f_3_2 + t42)
    l_f_3_3 = -t44 - x_3 + x_max_3
    k_3_3 = t43/(l_f_3_3 + t42)
    l_f_4_1 = x_max_4 - x_min_4
    t45 = k_sp_4*w_b_4*(a_B_4 + 1)
    t46 = t32*t45
    t47 = t31*t45
    k_4_1 = t47/(l_f_4_1 + t46)
    t48 = (1/2)*l_t_4
    l_f_4_2 = -t48 + x_4 - x_min_4
    k_4_2 = t47/(l_f_4_2 + t46)
    l_f_4_3 = -t48 - x_4 + x_max_4
    k_4_3 = t47/(l_f_4_3 + t46)
    l_f_5_1 = x_max_5 - x_min_5
    t49 = k_sp_5*w_b_5*(a_B_5 + 1)
    t50 = t32*t49
    t51 = t31*t49
    k_5_1 = t51/(l_f_5_1 + t50)
    t52 = (1/2)*l_t_5
    l_f_5_2 = -t52 + x_5 - x_min_5
    k_5_2 = t51/(l_f_5_2 + t50)
    l_f_5_3 = -t52 - x_5 + x_max_5
    k_5_3 = t51/(l_f_5_3 + t50)
    l_f_6_1 = x_max_6 - x_min_6
    t53 = k_sp_6*w_b_6*(a_B_6 + 1)
    t54 = t32*t53
    t55 = t31*t53
    k_6_1 = t55/(l_f_6_1 + t54)
    t56 = (1/2)*l_t_6
    l_f_6_2 = -t56 + x_6 - x_min_6
    k_6_2 = t55/(l_f_6_2 + t54)
    l_f_6_3 = -t56 - x_6 + x_max_6
    k_6_3 = t55/(l_f_6_3 + t54)
    k_out = np.empty((*batch, 33), dtype)
    k_out[..., 0] = k_1_1
    k_out[..., 1] = k_1_2
    k_out[..., 2] = k_1_3
    k_out[..., 3] = k_2_1
    k_out[..., 4] = k_2_2
    k_out[..., 5] = k_2_3
    k_out[..., 6] = k_3_1
    k_out[..., 7] = k_3_2
    k_out[..., 8] = k_3_3
    k_out[..., 9] = k_4_1
    k_out[..., 10] = k_4_2
    k_out[..., 11] = k_4_3
    k_out[..., 12] = k_5_1
    k_out[..., 13] = k_5_2
    k_out[..., 14] = k_5_3
    k_out[..., 15] = k_6_1
    k_out[..., 16] = k_6_2
    k_out[..., 17] = k_6_3
    k_out[..., 18] = k_C
    k_out[..., 19] = k_C
    k_out[..., 20] = k_C
    k_out[..., 21] = d_1_1*k_S
    k_out[..., 22] = d_1_2*k_S
    k_out[..., 23] = d_2_1*k_S
    k_out[..., 24] = d_2_2*k_S
    k_out[..., 25] = d_3_1*k_S
    k_out[..., 26] = d_3_2*k_S
    k_out[..., 27] = d_4_1*k_S
    k_out[..., 28] = d_4_2*k_S
    k_out[..., 29] = d_5_1*k_S
    k_out[..., 30] = d_5_2*k_S
    k_out[..., 31] = d_6_1*k_S
    k_out[..., 32] = d_6_2*k_S
    g_out = np.zeros((*batch, 33, 39), dtype)
    g_out[..., 0, 6] = -R_p_1
    g_out[..., 0, 12] = R_p_1
    g_out[..., 1, 0] = 1
    g_out[..., 1, 12] = -R_p_1
    g_out[..., 1, 30] = 1
    g_out[..., 2, 0] = -1
    g_out[..., 2, 6] = R_p_1
    g_out[..., 2, 30] = -1
    g_out[..., 3, 7] = -R_p_2
    g_out[..., 3, 13] = R_p_2
    g_out[..., 4, 1] = 1
    g_out[..., 4, 13] = -R_p_2
    g_out[..., 4, 31] = 1
    g_out[..., 5, 1] = -1
    g_out[..., 5, 7] = R_p_2
    g_out[..., 5, 31] = -1
    g_out[..., 6, 8] = -R_p_3
    g_out[..., 6, 14] = R_p_3
    g_out[..., 7, 2] = 1
    g_out[..., 7, 14] = -R_p_3
    g_out[..., 7, 32] = 1
    g_out[..., 8, 2] = -1
    g_out[..., 8, 8] = R_p_3
    g_out[..., 8, 32] = -1
    g_out[..., 9, 9] = -R_p_4
    g_out[..., 9, 15] = R_p_4
    g_out[..., 10, 3] = 1
    g_out[..., 10, 15] = -R_p_4
    g_out[..., 10, 33] = 1
    g_out[..., 11, 3] = -1
    g_out[..., 11, 9] = R_p_4
    g_out[..., 11, 33] = -1
    g_out[..., 12, 10] = -R_p_5
    g_out[..., 12, 16] = R_p_5
    g_out[..., 13, 4] = 1
    g_out[..., 13, 16] = -R_p_5
    g_out[..., 13, 34] = 1
    g_out[..., 14, 4] = -1
    g_out[..., 14, 10] = R_p_5
    g_out[..., 14, 34] = -1
    g_out[..., 15, 11] = -R_p_6
    g_out[..., 15, 17] = R_p_6
    g_out[..., 16, 5] = 1
    g_out[..., 16, 17] = -R_p_6
    g_out[..., 16, 35] = 1
    g_out[..., 17, 5] = -1
    g_out[..., 17, 11] = R_p_6
    g_out[..., 17, 35] = -1
    g_out[..., 18, 0] = D_p_x_1
    g_out[..., 18, 1] = D_p_x_2
    g_out[..., 18, 2] = D_p_x_3
    g_out[..., 18, 3] = D_p_x_4
    g_out[..., 18, 4] = D_p_x_5
    g_out[..., 18, 5] = D_p_x_6
    g_out[..., 18, 24] = D_delta_x_1
    g_out[..., 18, 25] = D_delta_x_2
    g_out[..., 18, 26] = D_delta_x_3
    g_out[..., 18, 27] = D_delta_x_4
    g_out[..., 18, 28] = D_delta_x_5
    g_out[..., 18, 29] = D_delta_x_6
    g_out[..., 18, 36] = 1
    g_out[..., 19, 0] = D_p_y_1
    g_out[..., 19, 1] = D_p_y_2
    g_out[..., 19, 2] = D_p_y_3
    g_out[..., 19, 3] = D_p_y_4
    g_out[..., 19, 4] = D_p_y_5
    g_out[..., 19, 5] = D_p_y_6
    g_out[..., 19, 24] = D_delta_y_1
    g_out[..., 19, 25] = D_delta_y_2
    g_out[..., 19, 26] = D_delta_y_3
    g_out[..., 19, 27] = D_delta_y_4
    g_out[..., 19, 28] = D_delta_y_5
    g_out[..., 19, 29] = D_delta_y_6
    g_out[..., 19, 37] = 1
    g_out[..., 20, 0] = D_p_z_1
    g_out[..., 20, 1] = D_p_z_2
    g_out[..., 20, 2] = D_p_z_3
    g_out[..., 20, 3] = D_p_z_4
    g_out[..., 20, 4] = D_p_z_5
    g_out[..., 20, 5] = D_p_z_6
    g_out[..., 20, 24] = D_delta_z_1
    g_out[..., 20, 25] = D_delta_z_2
    g_out[..., 20, 26] = D_delta_z_3
    g_out[..., 20, 27] = D_delta_z_4
    g_out[..., 20, 28] = D_delta_z_5
    g_out[..., 20, 29] = D_delta_z_6
    g_out[..., 20, 38] = 1
    g_out[..., 21, 6] = 1
    g_out[..., 21, 18] = 1
    g_out[..., 22, 12] = 1
    g_out[..., 22, 18] = 1
    g_out[..., 23, 7] = 1
    g_out[..., 23, 19] = 1
    g_out[..., 24, 13] = 1
    g_out[..., 24, 19] = 1
    g_out[..., 25, 8] = 1
    g_out[..., 25, 20] = 1
    g_out[..., 26, 14] = 1
    g_out[..., 26, 20] = 1
    g_out[..., 27, 9] = 1
    g_out[..., 27, 21] = 1
    g_out[..., 28, 15] = 1
    g_out[..., 28, 21] = 1
    g_out[..., 29, 10] = 1
    g_out[..., 29, 22] = 1
    g_out[..., 30, 16] = 1
    g_out[..., 30, 22] = 1
    g_out[..., 31, 11] = 1
    g_out[..., 31, 23] = 1
    g_out[..., 32, 17] = 1
    g_out[..., 32, 23] = 1
    return k_out, g_out


def driven(parameters):
    """Which coordinates are rotations of a rotor that a motor drives.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    d : array, shape (..., 18) [1]
        1 where a motor turns the coordinate, else 0.

    Notes
    -----
    The drives that the mechanism declares.
    0 operations; 0 with every named value expanded.
    """
    (
        d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2, d_4_1, d_4_2, d_5_1, d_5_2, d_6_1, d_6_2,
    ) = _entries(parameters.drive, (6, 2))
    batch, dtype = _batch(d_1_1)
    d_out = np.zeros((*batch, 18), dtype)
    d_out[..., 6] = d_1_1
    d_out[..., 7] = d_2_1
    d_out[..., 8] = d_3_1
    d_out[..., 9] = d_4_1
    d_out[..., 10] = d_5_1
    d_out[..., 11] = d_6_1
    d_out[..., 12] = d_1_2
    d_out[..., 13] = d_2_2
    d_out[..., 14] = d_3_2
    d_out[..., 15] = d_4_2
    d_out[..., 16] = d_5_2
    d_out[..., 17] = d_6_2
    return d_out


def drawing_directions(p, parameters):
    """Directions to which the unit vectors `up` of a drawing must be perpendicular.

    Parameters
    ----------
    p : array, shape (..., 6) [m, rad]
        platform's origin in the base frame, then the platform's rotation vector.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    e : array, shape (..., 6, 2, 3) [1, m]
        a unit vector, and the point where it is used.

    Notes
    -----
    The directions that the mechanism declares.
    0 operations; 0 with every named value expanded.
    """
    p_x, _, _, _, _, _ = _entries(p, (6,))
    (
        o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z, o_4_x, o_4_y, o_4_z, o_5_x, o_5_y,
        o_5_z, o_6_x, o_6_y, o_6_z,
    ) = _entries(parameters.origin, (6, 3))
    (
        n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z, n_4_x, n_4_y, n_4_z, n_5_x, n_5_y,
        n_5_z, n_6_x, n_6_y, n_6_z,
    ) = _entries(parameters.direction, (6, 3))
    batch, dtype = _batch(p_x, o_1_x, n_1_x)
    e_out = np.empty((*batch, 6, 2, 3), dtype)
    e_out[..., 0, 0, 0] = n_1_x
    e_out[..., 0, 0, 1] = n_1_y
    e_out[..., 0, 0, 2] = n_1_z
    e_out[..., 0, 1, 0] = o_1_x
    e_out[..., 0, 1, 1] = o_1_y
    e_out[..., 0, 1, 2] = o_1_z
    e_out[..., 1, 0, 0] = n_2_x
    e_out[..., 1, 0, 1] = n_2_y
    e_out[..., 1, 0, 2] = n_2_z
    e_out[..., 1, 1, 0] = o_2_x
    e_out[..., 1, 1, 1] = o_2_y
    e_out[..., 1, 1, 2] = o_2_z
    e_out[..., 2, 0, 0] = n_3_x
    e_out[..., 2, 0, 1] = n_3_y
    e_out[..., 2, 0, 2] = n_3_z
    e_out[..., 2, 1, 0] = o_3_x
    e_out[..., 2, 1, 1] = o_3_y
    e_out[..., 2, 1, 2] = o_3_z
    e_out[..., 3, 0, 0] = n_4_x
    e_out[..., 3, 0, 1] = n_4_y
    e_out[..., 3, 0, 2] = n_4_z
    e_out[..., 3, 1, 0] = o_4_x
    e_out[..., 3, 1, 1] = o_4_y
    e_out[..., 3, 1, 2] = o_4_z
    e_out[..., 4, 0, 0] = n_5_x
    e_out[..., 4, 0, 1] = n_5_y
    e_out[..., 4, 0, 2] = n_5_z
    e_out[..., 4, 1, 0] = o_5_x
    e_out[..., 4, 1, 1] = o_5_y
    e_out[..., 4, 1, 2] = o_5_z
    e_out[..., 5, 0, 0] = n_6_x
    e_out[..., 5, 0, 1] = n_6_y
    e_out[..., 5, 0, 2] = n_6_z
    e_out[..., 5, 1, 0] = o_6_x
    e_out[..., 5, 1, 1] = o_6_y
    e_out[..., 5, 1, 2] = o_6_z
    return e_out
