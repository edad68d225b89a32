# Generated from the derivation of linear_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Points and springs of the mechanism linear_delta, with effects, for pictures of it.

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


def drawing_points(p, up, parameters):
    """Positions of the points of a drawing.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    up : array, shape (..., 9) [1]
        Unit vectors that the robot leaves open, one after another.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    r : array, shape (..., 46, 3) [m]
        Base frame; first the platform.

    Notes
    -----
    The positions that the mechanism declares, or those of its parts.
    318 operations; 3699 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    up_1_x, up_1_y, up_1_z, up_2_x, up_2_y, up_2_z, up_3_x, up_3_y, up_3_z = _entries(up, (9,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, up_1_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, R_p_1, x_min_1, sigma_1)
    t1 = b_1_x + p_x
    r_1_x = -o_1_x + t1
    t2 = b_1_y + p_y
    r_1_y = -o_1_y + t2
    t3 = b_1_z + p_z
    r_1_z = -o_1_z + t3
    t4 = b_2_x + p_x
    r_2_x = -o_2_x + t4
    t5 = b_2_y + p_y
    r_2_y = -o_2_y + t5
    t6 = b_2_z + p_z
    r_2_z = -o_2_z + t6
    t7 = b_3_x + p_x
    r_3_x = -o_3_x + t7
    t8 = b_3_y + p_y
    r_3_y = -o_3_y + t8
    t9 = b_3_z + p_z
    r_3_z = -o_3_z + t9
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
    t10 = n_1_x*x_min_1 + o_1_x
    t11 = n_1_y*x_min_1 + o_1_y
    t12 = n_1_z*x_min_1 + o_1_z
    t13 = n_1_x*x_max_1 + o_1_x
    t14 = n_1_y*x_max_1 + o_1_y
    t15 = n_1_z*x_max_1 + o_1_z
    t16 = n_1_x*x_1 + o_1_x
    t17 = n_1_y*x_1 + o_1_y
    t18 = n_1_z*x_1 + o_1_z
    t19 = R_p_1 + (1/2)*l_t_1
    t20 = -n_1_y*up_1_z + n_1_z*up_1_y
    t21 = (1/14)*l_d_1
    t22 = t20*t21
    t23 = n_1_x*up_1_z - n_1_z*up_1_x
    t24 = t21*t23
    t25 = -n_1_x*up_1_y + n_1_y*up_1_x
    t26 = t21*t25
    t27 = R_p_1*t20
    t28 = R_p_1*t23
    t29 = R_p_1*t25
    t30 = R_p_1*up_1_x
    t31 = R_p_1*up_1_y
    t32 = R_p_1*up_1_z
    t33 = n_2_x*x_min_2 + o_2_x
    t34 = n_2_y*x_min_2 + o_2_y
    t35 = n_2_z*x_min_2 + o_2_z
    t36 = n_2_x*x_max_2 + o_2_x
    t37 = n_2_y*x_max_2 + o_2_y
    t38 = n_2_z*x_max_2 + o_2_z
    t39 = n_2_x*x_2 + o_2_x
    t40 = n_2_y*x_2 + o_2_y
    t41 = n_2_z*x_2 + o_2_z
    t42 = R_p_2 + (1/2)*l_t_2
    t43 = -n_2_y*up_2_z + n_2_z*up_2_y
    t44 = (1/14)*l_d_2
    t45 = t43*t44
    t46 = n_2_x*up_2_z - n_2_z*up_2_x
    t47 = t44*t46
    t48 = -n_2_x*up_2_y + n_2_y*up_2_x
    t49 = t44*t48
    t50 = R_p_2*t43
    t51 = R_p_2*t46
    t52 = R_p_2*t48
    t53 = R_p_2*up_2_x
    t54 = R_p_2*up_2_y
    t55 = R_p_2*up_2_z
    t56 = n_3_x*x_min_3 + o_3_x
    t57 = n_3_y*x_min_3 + o_3_y
    t58 = n_3_z*x_min_3 + o_3_z
    t59 = n_3_x*x_max_3 + o_3_x
    t60 = n_3_y*x_max_3 + o_3_y
    t61 = n_3_z*x_max_3 + o_3_z
    t62 = n_3_x*x_3 + o_3_x
    t63 = n_3_y*x_3 + o_3_y
    t64 = n_3_z*x_3 + o_3_z
    t65 = R_p_3 + (1/2)*l_t_3
    t66 = -n_3_y*up_3_z + n_3_z*up_3_y
    t67 = (1/14)*l_d_3
    t68 = t66*t67
    t69 = n_3_x*up_3_z - n_3_z*up_3_x
    t70 = t67*t69
    t71 = -n_3_x*up_3_y + n_3_y*up_3_x
    t72 = t67*t71
    t73 = R_p_3*t66
    t74 = R_p_3*t69
    t75 = R_p_3*t71
    t76 = R_p_3*up_3_x
    t77 = R_p_3*up_3_y
    t78 = R_p_3*up_3_z
    r_out = np.empty((*batch, 46, 3), dtype)
    r_out[..., 0, 0] = p_x
    r_out[..., 0, 1] = p_y
    r_out[..., 0, 2] = p_z
    r_out[..., 1, 0] = t10
    r_out[..., 1, 1] = t11
    r_out[..., 1, 2] = t12
    r_out[..., 2, 0] = t13
    r_out[..., 2, 1] = t14
    r_out[..., 2, 2] = t15
    r_out[..., 3, 0] = t16
    r_out[..., 3, 1] = t17
    r_out[..., 3, 2] = t18
    r_out[..., 4, 0] = n_1_x*t19 + t16
    r_out[..., 4, 1] = n_1_y*t19 + t17
    r_out[..., 4, 2] = n_1_z*t19 + t18
    r_out[..., 5, 0] = t16 + t22
    r_out[..., 5, 1] = t17 + t24
    r_out[..., 5, 2] = t18 + t26
    r_out[..., 6, 0] = t1 + t22
    r_out[..., 6, 1] = t2 + t24
    r_out[..., 6, 2] = t26 + t3
    r_out[..., 7, 0] = t16 - t22
    r_out[..., 7, 1] = t17 - t24
    r_out[..., 7, 2] = t18 - t26
    r_out[..., 8, 0] = t1 - t22
    r_out[..., 8, 1] = t2 - t24
    r_out[..., 8, 2] = -t26 + t3
    r_out[..., 9, 0] = t13 + t27
    r_out[..., 9, 1] = t14 + t28
    r_out[..., 9, 2] = t15 + t29
    r_out[..., 10, 0] = t10 + t27
    r_out[..., 10, 1] = t11 + t28
    r_out[..., 10, 2] = t12 + t29
    r_out[..., 11, 0] = t10 - t30
    r_out[..., 11, 1] = t11 - t31
    r_out[..., 11, 2] = t12 - t32
    r_out[..., 12, 0] = t13 - t30
    r_out[..., 12, 1] = t14 - t31
    r_out[..., 12, 2] = t15 - t32
    r_out[..., 13, 0] = t16 + t30
    r_out[..., 13, 1] = t17 + t31
    r_out[..., 13, 2] = t18 + t32
    r_out[..., 14, 0] = t10 + t30
    r_out[..., 14, 1] = t11 + t31
    r_out[..., 14, 2] = t12 + t32
    r_out[..., 15, 0] = t13 + t30
    r_out[..., 15, 1] = t14 + t31
    r_out[..., 15, 2] = t15 + t32
    r_out[..., 16, 0] = t33
    r_out[..., 16, 1] = t34
    r_out[..., 16, 2] = t35
    r_out[..., 17, 0] = t36
    r_out[..., 17, 1] = t37
    r_out[..., 17, 2] = t38
    r_out[..., 18, 0] = t39
    r_out[..., 18, 1] = t40
    r_out[..., 18, 2] = t41
    r_out[..., 19, 0] = n_2_x*t42 + t39
    r_out[..., 19, 1] = n_2_y*t42 + t40
    r_out[..., 19, 2] = n_2_z*t42 + t41
    r_out[..., 20, 0] = t39 + t45
    r_out[..., 20, 1] = t40 + t47
    r_out[..., 20, 2] = t41 + t49
    r_out[..., 21, 0] = t4 + t45
    r_out[..., 21, 1] = t47 + t5
    r_out[..., 21, 2] = t49 + t6
    r_out[..., 22, 0] = t39 - t45
    r_out[..., 22, 1] = t40 - t47
    r_out[..., 22, 2] = t41 - t49
    r_out[..., 23, 0] = t4 - t45
    r_out[..., 23, 1] = -t47 + t5
    r_out[..., 23, 2] = -t49 + t6
    r_out[..., 24, 0] = t36 + t50
    r_out[..., 24, 1] = t37 + t51
    r_out[..., 24, 2] = t38 + t52
    r_out[..., 25, 0] = t33 + t50
    r_out[..., 25, 1] = t34 + t51
    r_out[..., 25, 2] = t35 + t52
    r_out[..., 26, 0] = t33 - t53
    r_out[..., 26, 1] = t34 - t54
    r_out[..., 26, 2] = t35 - t55
    r_out[..., 27, 0] = t36 - t53
    r_out[..., 27, 1] = t37 - t54
    r_out[..., 27, 2] = t38 - t55
    r_out[..., 28, 0] = t39 + t53
    r_out[..., 28, 1] = t40 + t54
    r_out[..., 28, 2] = t41 + t55
    r_out[..., 29, 0] = t33 + t53
    r_out[..., 29, 1] = t34 + t54
    r_out[..., 29, 2] = t35 + t55
    r_out[..., 30, 0] = t36 + t53
    r_out[..., 30, 1] = t37 + t54
    r_out[..., 30, 2] = t38 + t55
    r_out[..., 31, 0] = t56
    r_out[..., 31, 1] = t57
    r_out[..., 31, 2] = t58
    r_out[..., 32, 0] = t59
    r_out[..., 32, 1] = t60
    r_out[..., 32, 2] = t61
    r_out[..., 33, 0] = t62
    r_out[..., 33, 1] = t63
    r_out[..., 33, 2] = t64
    r_out[..., 34, 0] = n_3_x*t65 + t62
    r_out[..., 34, 1] = n_3_y*t65 + t63
    r_out[..., 34, 2] = n_3_z*t65 + t64
    r_out[..., 35, 0] = t62 + t68
    r_out[..., 35, 1] = t63 + t70
    r_out[..., 35, 2] = t64 + t72
    r_out[..., 36, 0] = t68 + t7
    r_out[..., 36, 1] = t70 + t8
    r_out[..., 36, 2] = t72 + t9
    r_out[..., 37, 0] = t62 - t68
    r_out[..., 37, 1] = t63 - t70
    r_out[..., 37, 2] = t64 - t72
    r_out[..., 38, 0] = -t68 + t7
    r_out[..., 38, 1] = -t70 + t8
    r_out[..., 38, 2] = -t72 + t9
    r_out[..., 39, 0] = t59 + t73
    r_out[..., 39, 1] = t60 + t74
    r_out[..., 39, 2] = t61 + t75
    r_out[..., 40, 0] = t56 + t73
    r_out[..., 40, 1] = t57 + t74
    r_out[..., 40, 2] = t58 + t75
    r_out[..., 41, 0] = t56 - t76
    r_out[..., 41, 1] = t57 - t77
    r_out[..., 41, 2] = t58 - t78
    r_out[..., 42, 0] = t59 - t76
    r_out[..., 42, 1] = t60 - t77
    r_out[..., 42, 2] = t61 - t78
    r_out[..., 43, 0] = t62 + t76
    r_out[..., 43, 1] = t63 + t77
    r_out[..., 43, 2] = t64 + t78
    r_out[..., 44, 0] = t56 + t76
    r_out[..., 44, 1] = t57 + t77
    r_out[..., 44, 2] = t58 + t78
    r_out[..., 45, 0] = t59 + t76
    r_out[..., 45, 1] = t60 + t77
    r_out[..., 45, 2] = t61 + t78
    return r_out


def drawing_motion(p, up, parameters):
    """Jacobians of these points with respect to every coordinate, one for points that move alike.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    up : array, shape (..., 9) [1]
        Unit vectors that the robot leaves open, one after another.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J : array, shape (..., 8, 3, 21) [1, m]
        dr_i/dq_k, base frame.

    Notes
    -----
    The positions differentiated, with the contributions of released joints and the frame.
    177 operations; 26586 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    up_1_x, _, _, _, _, _, _, _, _ = _entries(up, (9,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, up_1_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
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
    J_out = np.zeros((*batch, 8, 3, 21), dtype)
    J_out[..., 0, 0, 0] = D_p_x_1
    J_out[..., 0, 0, 1] = D_p_x_2
    J_out[..., 0, 0, 2] = D_p_x_3
    J_out[..., 0, 0, 12] = D_delta_x_1
    J_out[..., 0, 0, 13] = D_delta_x_2
    J_out[..., 0, 0, 14] = D_delta_x_3
    J_out[..., 0, 0, 18] = 1
    J_out[..., 0, 1, 0] = D_p_y_1
    J_out[..., 0, 1, 1] = D_p_y_2
    J_out[..., 0, 1, 2] = D_p_y_3
    J_out[..., 0, 1, 12] = D_delta_y_1
    J_out[..., 0, 1, 13] = D_delta_y_2
    J_out[..., 0, 1, 14] = D_delta_y_3
    J_out[..., 0, 1, 19] = 1
    J_out[..., 0, 2, 0] = D_p_z_1
    J_out[..., 0, 2, 1] = D_p_z_2
    J_out[..., 0, 2, 2] = D_p_z_3
    J_out[..., 0, 2, 12] = D_delta_z_1
    J_out[..., 0, 2, 13] = D_delta_z_2
    J_out[..., 0, 2, 14] = D_delta_z_3
    J_out[..., 0, 2, 20] = 1
    J_out[..., 1, 0, 18] = 1
    J_out[..., 1, 1, 19] = 1
    J_out[..., 1, 2, 20] = 1
    J_out[..., 2, 0, 0] = n_1_x
    J_out[..., 2, 0, 18] = 1
    J_out[..., 2, 1, 0] = n_1_y
    J_out[..., 2, 1, 19] = 1
    J_out[..., 2, 2, 0] = n_1_z
    J_out[..., 2, 2, 20] = 1
    J_out[..., 3, 0, 0] = n_1_x
    J_out[..., 3, 0, 15] = n_1_x
    J_out[..., 3, 0, 18] = 1
    J_out[..., 3, 1, 0] = n_1_y
    J_out[..., 3, 1, 15] = n_1_y
    J_out[..., 3, 1, 19] = 1
    J_out[..., 3, 2, 0] = n_1_z
    J_out[..., 3, 2, 15] = n_1_z
    J_out[..., 3, 2, 20] = 1
    J_out[..., 4, 0, 1] = n_2_x
    J_out[..., 4, 0, 18] = 1
    J_out[..., 4, 1, 1] = n_2_y
    J_out[..., 4, 1, 19] = 1
    J_out[..., 4, 2, 1] = n_2_z
    J_out[..., 4, 2, 20] = 1
    J_out[..., 5, 0, 1] = n_2_x
    J_out[..., 5, 0, 16] = n_2_x
    J_out[..., 5, 0, 18] = 1
    J_out[..., 5, 1, 1] = n_2_y
    J_out[..., 5, 1, 16] = n_2_y
    J_out[..., 5, 1, 19] = 1
    J_out[..., 5, 2, 1] = n_2_z
    J_out[..., 5, 2, 16] = n_2_z
    J_out[..., 5, 2, 20] = 1
    J_out[..., 6, 0, 2] = n_3_x
    J_out[..., 6, 0, 18] = 1
    J_out[..., 6, 1, 2] = n_3_y
    J_out[..., 6, 1, 19] = 1
    J_out[..., 6, 2, 2] = n_3_z
    J_out[..., 6, 2, 20] = 1
    J_out[..., 7, 0, 2] = n_3_x
    J_out[..., 7, 0, 17] = n_3_x
    J_out[..., 7, 0, 18] = 1
    J_out[..., 7, 1, 2] = n_3_y
    J_out[..., 7, 1, 17] = n_3_y
    J_out[..., 7, 1, 19] = 1
    J_out[..., 7, 2, 2] = n_3_z
    J_out[..., 7, 2, 17] = n_3_z
    J_out[..., 7, 2, 20] = 1
    return J_out


def springs(p, parameters, effects):
    """Stiffness of every spring, and its elongation or twist per unit of each coordinate.

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
    k : array, shape (..., 18) [N/m, N m/rad]
        Stiffness.
    g : array, shape (..., 18, 21) [1, m, 1/m]
        The energy is the sum of k (g . q)^2 / 2.

    Notes
    -----
    Equation 38 with the effects' energies; the springs of released joints are not among them.
    249 operations; 27162 with every named value expanded.
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
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (a_B_3,) = _entries(effects.axis_belt_stiffness_factor_3, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, d_1_1, x_min_1,
        sigma_1, a_B_1, a_B_2, a_B_3, c_E, c_T, F_T, k_C, k_S)
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
    l_f_1_1 = x_max_1 - x_min_1
    t11 = F_T*c_T + 1
    t12 = c_E*t11
    t13 = k_sp_1*w_b_1*(a_B_1 + 1)
    t14 = t12*t13
    t15 = t11*t13
    k_1_1 = t15/(l_f_1_1 + t14)
    t16 = (1/2)*l_t_1
    l_f_1_2 = -t16 + x_1 - x_min_1
    k_1_2 = t15/(l_f_1_2 + t14)
    l_f_1_3 = -t16 - x_1 + x_max_1
    k_1_3 = t15/(l_f_1_3 + t14)
    l_f_2_1 = x_max_2 - x_min_2
    t17 = k_sp_2*w_b_2*(a_B_2 + 1)
    t18 = t12*t17
    t19 = t11*t17
    k_2_1 = t19/(l_f_2_1 + t18)
    t20 = (1/2)*l_t_2
    l_f_2_2 = -t20 + x_2 - x_min_2
    k_2_2 = t19/(l_f_2_2 + t18)
    l_f_2_3 = -t20 - x_2 + x_max_2
    k_2_3 = t19/(l_f_2_3 + t18)
    l_f_3_1 = x_max_3 - x_min_3
    t21 = k_sp_3*w_b_3*(a_B_3 + 1)
    t22 = t12*t21
    t23 = t11*t21
    k_3_1 = t23/(l_f_3_1 + t22)
    t24 = (1/2)*l_t_3
    l_f_3_2 = -t24 + x_3 - x_min_3
    k_3_2 = t23/(l_f_3_2 + t22)
    l_f_3_3 = -t24 - x_3 + x_max_3
    k_3_3 = t23/(l_f_3_3 + t22)
    k_out = np.empty((*batch, 18), dtype)
    k_out[..., 0] = k_1_1
    k_out[..., 1] = k_1_2
    k_out[..., 2] = k_1_3
    k_out[..., 3] = k_2_1
    k_out[..., 4] = k_2_2
    k_out[..., 5] = k_2_3
    k_out[..., 6] = k_3_1
    k_out[..., 7] = k_3_2
    k_out[..., 8] = k_3_3
    k_out[..., 9] = k_C
    k_out[..., 10] = k_C
    k_out[..., 11] = k_C
    k_out[..., 12] = d_1_1*k_S
    k_out[..., 13] = d_1_2*k_S
    k_out[..., 14] = d_2_1*k_S
    k_out[..., 15] = d_2_2*k_S
    k_out[..., 16] = d_3_1*k_S
    k_out[..., 17] = d_3_2*k_S
    g_out = np.zeros((*batch, 18, 21), dtype)
    g_out[..., 0, 3] = -R_p_1
    g_out[..., 0, 6] = R_p_1
    g_out[..., 1, 0] = 1
    g_out[..., 1, 6] = -R_p_1
    g_out[..., 1, 15] = 1
    g_out[..., 2, 0] = -1
    g_out[..., 2, 3] = R_p_1
    g_out[..., 2, 15] = -1
    g_out[..., 3, 4] = -R_p_2
    g_out[..., 3, 7] = R_p_2
    g_out[..., 4, 1] = 1
    g_out[..., 4, 7] = -R_p_2
    g_out[..., 4, 16] = 1
    g_out[..., 5, 1] = -1
    g_out[..., 5, 4] = R_p_2
    g_out[..., 5, 16] = -1
    g_out[..., 6, 5] = -R_p_3
    g_out[..., 6, 8] = R_p_3
    g_out[..., 7, 2] = 1
    g_out[..., 7, 8] = -R_p_3
    g_out[..., 7, 17] = 1
    g_out[..., 8, 2] = -1
    g_out[..., 8, 5] = R_p_3
    g_out[..., 8, 17] = -1
    g_out[..., 9, 0] = D_p_x_1
    g_out[..., 9, 1] = D_p_x_2
    g_out[..., 9, 2] = D_p_x_3
    g_out[..., 9, 12] = D_delta_x_1
    g_out[..., 9, 13] = D_delta_x_2
    g_out[..., 9, 14] = D_delta_x_3
    g_out[..., 9, 18] = 1
    g_out[..., 10, 0] = D_p_y_1
    g_out[..., 10, 1] = D_p_y_2
    g_out[..., 10, 2] = D_p_y_3
    g_out[..., 10, 12] = D_delta_y_1
    g_out[..., 10, 13] = D_delta_y_2
    g_out[..., 10, 14] = D_delta_y_3
    g_out[..., 10, 19] = 1
    g_out[..., 11, 0] = D_p_z_1
    g_out[..., 11, 1] = D_p_z_2
    g_out[..., 11, 2] = D_p_z_3
    g_out[..., 11, 12] = D_delta_z_1
    g_out[..., 11, 13] = D_delta_z_2
    g_out[..., 11, 14] = D_delta_z_3
    g_out[..., 11, 20] = 1
    g_out[..., 12, 3] = 1
    g_out[..., 12, 9] = 1
    g_out[..., 13, 6] = 1
    g_out[..., 13, 9] = 1
    g_out[..., 14, 4] = 1
    g_out[..., 14, 10] = 1
    g_out[..., 15, 7] = 1
    g_out[..., 15, 10] = 1
    g_out[..., 16, 5] = 1
    g_out[..., 16, 11] = 1
    g_out[..., 17, 8] = 1
    g_out[..., 17, 11] = 1
    return k_out, g_out


def driven(parameters):
    """Which coordinates are rotations of a rotor that a motor drives.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    d : array, shape (..., 9) [1]
        1 where a motor turns the coordinate, else 0.

    Notes
    -----
    The drives that the mechanism declares.
    0 operations; 0 with every named value expanded.
    """
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    batch, dtype = _batch(d_1_1)
    d_out = np.zeros((*batch, 9), dtype)
    d_out[..., 3] = d_1_1
    d_out[..., 4] = d_2_1
    d_out[..., 5] = d_3_1
    d_out[..., 6] = d_1_2
    d_out[..., 7] = d_2_2
    d_out[..., 8] = d_3_2
    return d_out


def drawing_directions(p, parameters):
    """Directions to which the unit vectors `up` of a drawing must be perpendicular.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    e : array, shape (..., 3, 2, 3) [1, m]
        a unit vector, and the point where it is used.

    Notes
    -----
    The directions that the mechanism declares.
    0 operations; 0 with every named value expanded.
    """
    p_x, _, _ = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    batch, dtype = _batch(p_x, o_1_x, n_1_x)
    e_out = np.empty((*batch, 3, 2, 3), dtype)
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
    return e_out
