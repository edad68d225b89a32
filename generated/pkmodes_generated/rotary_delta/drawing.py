# Generated from the derivation of rotary_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Points and springs of the mechanism rotary_delta, with effects, for pictures of it.

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
* k_j [N m/rad]: stiffness of reducer j
* D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
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


def drawing_points(p, parameters):
    """Positions of the points of a drawing.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    r : array, shape (..., 34, 3) [m]
        Base frame; first the platform.

    Notes
    -----
    The positions that the mechanism declares, or those of its parts.
    336 operations; 8154 with every named value expanded.
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
    A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z
    B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z
    rho2_1 = A_1**2 + B_1**2
    C_1 = (1/2)*(L_a_1**2 - l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t10 = 1.0/rho2_1
    c_1 = t10*(A_1*C_1 - B_1*S_1)
    sn_1 = t10*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    C_2 = (1/2)*(L_a_2**2 - l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t11 = 1.0/rho2_2
    c_2 = t11*(A_2*C_2 - B_2*S_2)
    sn_2 = t11*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    C_3 = (1/2)*(L_a_3**2 - l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t12 = 1.0/rho2_3
    c_3 = t12*(A_3*C_3 - B_3*S_3)
    sn_3 = t12*(A_3*S_3 + B_3*C_3)
    d_1_x = c_1*z_1_x + sn_1*y_1_x
    d_1_y = c_1*z_1_y + sn_1*y_1_y
    d_1_z = c_1*z_1_z + sn_1*y_1_z
    d_2_x = c_2*z_2_x + sn_2*y_2_x
    d_2_y = c_2*z_2_y + sn_2*y_2_y
    d_2_z = c_2*z_2_z + sn_2*y_2_z
    d_3_x = c_3*z_3_x + sn_3*y_3_x
    d_3_y = c_3*z_3_y + sn_3*y_3_y
    d_3_z = c_3*z_3_z + sn_3*y_3_z
    t13 = (1/8)*L_a_1
    t14 = a_1_x*t13
    t15 = o_1_x + t14
    t16 = a_1_y*t13
    t17 = o_1_y + t16
    t18 = a_1_z*t13
    t19 = o_1_z + t18
    t20 = (1/8)*L_a_2
    t21 = a_2_x*t20
    t22 = o_2_x + t21
    t23 = a_2_y*t20
    t24 = o_2_y + t23
    t25 = a_2_z*t20
    t26 = o_2_z + t25
    t27 = (1/8)*L_a_3
    t28 = a_3_x*t27
    t29 = o_3_x + t28
    t30 = a_3_y*t27
    t31 = o_3_y + t30
    t32 = a_3_z*t27
    t33 = o_3_z + t32
    t34 = (1/4)*L_a_1
    t35 = (3/8)*L_a_1
    t36 = (1/6)*L_a_1
    t37 = L_a_1*d_1_x
    t38 = o_1_x + t37
    t39 = L_a_1*d_1_y
    t40 = o_1_y + t39
    t41 = L_a_1*d_1_z
    t42 = o_1_z + t41
    t43 = (1/4)*L_a_2
    t44 = (3/8)*L_a_2
    t45 = (1/6)*L_a_2
    t46 = L_a_2*d_2_x
    t47 = o_2_x + t46
    t48 = L_a_2*d_2_y
    t49 = o_2_y + t48
    t50 = L_a_2*d_2_z
    t51 = o_2_z + t50
    t52 = (1/4)*L_a_3
    t53 = (3/8)*L_a_3
    t54 = (1/6)*L_a_3
    t55 = L_a_3*d_3_x
    t56 = o_3_x + t55
    t57 = L_a_3*d_3_y
    t58 = o_3_y + t57
    t59 = L_a_3*d_3_z
    t60 = o_3_z + t59
    r_out = np.empty((*batch, 34, 3), dtype)
    r_out[..., 0, 0] = p_x
    r_out[..., 0, 1] = p_y
    r_out[..., 0, 2] = p_z
    r_out[..., 1, 0] = t15
    r_out[..., 1, 1] = t17
    r_out[..., 1, 2] = t19
    r_out[..., 2, 0] = o_1_x - t14
    r_out[..., 2, 1] = o_1_y - t16
    r_out[..., 2, 2] = o_1_z - t18
    r_out[..., 3, 0] = t22
    r_out[..., 3, 1] = t24
    r_out[..., 3, 2] = t26
    r_out[..., 4, 0] = o_2_x - t21
    r_out[..., 4, 1] = o_2_y - t23
    r_out[..., 4, 2] = o_2_z - t25
    r_out[..., 5, 0] = t29
    r_out[..., 5, 1] = t31
    r_out[..., 5, 2] = t33
    r_out[..., 6, 0] = o_3_x - t28
    r_out[..., 6, 1] = o_3_y - t30
    r_out[..., 6, 2] = o_3_z - t32
    r_out[..., 7, 0] = a_1_x*t34 + o_1_x
    r_out[..., 7, 1] = a_1_y*t34 + o_1_y
    r_out[..., 7, 2] = a_1_z*t34 + o_1_z
    r_out[..., 8, 0] = a_1_x*t35 + o_1_x
    r_out[..., 8, 1] = a_1_y*t35 + o_1_y
    r_out[..., 8, 2] = a_1_z*t35 + o_1_z
    r_out[..., 9, 0] = o_1_x
    r_out[..., 9, 1] = o_1_y
    r_out[..., 9, 2] = o_1_z
    r_out[..., 10, 0] = a_1_x*t36 + o_1_x
    r_out[..., 10, 1] = a_1_y*t36 + o_1_y
    r_out[..., 10, 2] = a_1_z*t36 + o_1_z
    r_out[..., 11, 0] = t38
    r_out[..., 11, 1] = t40
    r_out[..., 11, 2] = t42
    r_out[..., 12, 0] = t15 + t37
    r_out[..., 12, 1] = t17 + t39
    r_out[..., 12, 2] = t19 + t41
    r_out[..., 13, 0] = -t14 + t38
    r_out[..., 13, 1] = -t16 + t40
    r_out[..., 13, 2] = -t18 + t42
    r_out[..., 14, 0] = t1 + t14
    r_out[..., 14, 1] = t16 + t2
    r_out[..., 14, 2] = t18 + t3
    r_out[..., 15, 0] = t1 - t14
    r_out[..., 15, 1] = -t16 + t2
    r_out[..., 15, 2] = -t18 + t3
    r_out[..., 16, 0] = a_2_x*t43 + o_2_x
    r_out[..., 16, 1] = a_2_y*t43 + o_2_y
    r_out[..., 16, 2] = a_2_z*t43 + o_2_z
    r_out[..., 17, 0] = a_2_x*t44 + o_2_x
    r_out[..., 17, 1] = a_2_y*t44 + o_2_y
    r_out[..., 17, 2] = a_2_z*t44 + o_2_z
    r_out[..., 18, 0] = o_2_x
    r_out[..., 18, 1] = o_2_y
    r_out[..., 18, 2] = o_2_z
    r_out[..., 19, 0] = a_2_x*t45 + o_2_x
    r_out[..., 19, 1] = a_2_y*t45 + o_2_y
    r_out[..., 19, 2] = a_2_z*t45 + o_2_z
    r_out[..., 20, 0] = t47
    r_out[..., 20, 1] = t49
    r_out[..., 20, 2] = t51
    r_out[..., 21, 0] = t22 + t46
    r_out[..., 21, 1] = t24 + t48
    r_out[..., 21, 2] = t26 + t50
    r_out[..., 22, 0] = -t21 + t47
    r_out[..., 22, 1] = -t23 + t49
    r_out[..., 22, 2] = -t25 + t51
    r_out[..., 23, 0] = t21 + t4
    r_out[..., 23, 1] = t23 + t5
    r_out[..., 23, 2] = t25 + t6
    r_out[..., 24, 0] = -t21 + t4
    r_out[..., 24, 1] = -t23 + t5
    r_out[..., 24, 2] = -t25 + t6
    r_out[..., 25, 0] = a_3_x*t52 + o_3_x
    r_out[..., 25, 1] = a_3_y*t52 + o_3_y
    r_out[..., 25, 2] = a_3_z*t52 + o_3_z
    r_out[..., 26, 0] = a_3_x*t53 + o_3_x
    r_out[..., 26, 1] = a_3_y*t53 + o_3_y
    r_out[..., 26, 2] = a_3_z*t53 + o_3_z
    r_out[..., 27, 0] = o_3_x
    r_out[..., 27, 1] = o_3_y
    r_out[..., 27, 2] = o_3_z
    r_out[..., 28, 0] = a_3_x*t54 + o_3_x
    r_out[..., 28, 1] = a_3_y*t54 + o_3_y
    r_out[..., 28, 2] = a_3_z*t54 + o_3_z
    r_out[..., 29, 0] = t56
    r_out[..., 29, 1] = t58
    r_out[..., 29, 2] = t60
    r_out[..., 30, 0] = t29 + t55
    r_out[..., 30, 1] = t31 + t57
    r_out[..., 30, 2] = t33 + t59
    r_out[..., 31, 0] = -t28 + t56
    r_out[..., 31, 1] = -t30 + t58
    r_out[..., 31, 2] = -t32 + t60
    r_out[..., 32, 0] = t28 + t7
    r_out[..., 32, 1] = t30 + t8
    r_out[..., 32, 2] = t32 + t9
    r_out[..., 33, 0] = -t28 + t7
    r_out[..., 33, 1] = -t30 + t8
    r_out[..., 33, 2] = -t32 + t9
    return r_out


def drawing_motion(p, parameters):
    """Jacobians of these points with respect to every coordinate, one for points that move alike.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J : array, shape (..., 5, 3, 12) [1, m]
        dr_i/dq_k, base frame.

    Notes
    -----
    The positions differentiated, with the contributions of released joints and the frame.
    315 operations; 119349 with every named value expanded.
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
    J_out = np.zeros((*batch, 5, 3, 12), dtype)
    J_out[..., 0, 0, 0] = D_p_x_1
    J_out[..., 0, 0, 1] = D_p_x_2
    J_out[..., 0, 0, 2] = D_p_x_3
    J_out[..., 0, 0, 6] = D_delta_x_1
    J_out[..., 0, 0, 7] = D_delta_x_2
    J_out[..., 0, 0, 8] = D_delta_x_3
    J_out[..., 0, 0, 9] = 1
    J_out[..., 0, 1, 0] = D_p_y_1
    J_out[..., 0, 1, 1] = D_p_y_2
    J_out[..., 0, 1, 2] = D_p_y_3
    J_out[..., 0, 1, 6] = D_delta_y_1
    J_out[..., 0, 1, 7] = D_delta_y_2
    J_out[..., 0, 1, 8] = D_delta_y_3
    J_out[..., 0, 1, 10] = 1
    J_out[..., 0, 2, 0] = D_p_z_1
    J_out[..., 0, 2, 1] = D_p_z_2
    J_out[..., 0, 2, 2] = D_p_z_3
    J_out[..., 0, 2, 6] = D_delta_z_1
    J_out[..., 0, 2, 7] = D_delta_z_2
    J_out[..., 0, 2, 8] = D_delta_z_3
    J_out[..., 0, 2, 11] = 1
    J_out[..., 1, 0, 9] = 1
    J_out[..., 1, 1, 10] = 1
    J_out[..., 1, 2, 11] = 1
    J_out[..., 2, 0, 0] = t4
    J_out[..., 2, 0, 9] = 1
    J_out[..., 2, 1, 0] = t5
    J_out[..., 2, 1, 10] = 1
    J_out[..., 2, 2, 0] = t6
    J_out[..., 2, 2, 11] = 1
    J_out[..., 3, 0, 1] = t7
    J_out[..., 3, 0, 9] = 1
    J_out[..., 3, 1, 1] = t8
    J_out[..., 3, 1, 10] = 1
    J_out[..., 3, 2, 1] = t9
    J_out[..., 3, 2, 11] = 1
    J_out[..., 4, 0, 2] = t12
    J_out[..., 4, 0, 9] = 1
    J_out[..., 4, 1, 2] = t10
    J_out[..., 4, 1, 10] = 1
    J_out[..., 4, 2, 2] = t11
    J_out[..., 4, 2, 11] = 1
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
    k : array, shape (..., 9) [N/m, N m/rad]
        Stiffness.
    g : array, shape (..., 9, 12) [1, m, 1/m]
        The energy is the sum of k (g . q)^2 / 2.

    Notes
    -----
    Equation 38 with the effects' energies; the springs of released joints are not among them.
    324 operations; 116739 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_R_1,) = _entries(effects.axis_reducer_stiffness_factor_1, ())
    (a_R_2,) = _entries(effects.axis_reducer_stiffness_factor_2, ())
    (a_R_3,) = _entries(effects.axis_reducer_stiffness_factor_3, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    batch, dtype = _batch(p_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, l_d_1, k_r_1, sigma_1, a_R_1, a_R_2, a_R_3,
        k_C, k_S)
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
    t5 = A_x_1*t4
    D_p_x_1 = D_r_1*t5
    t6 = A_x_2*t4
    D_p_x_2 = D_r_2*t6
    t7 = A_x_3*t4
    D_p_x_3 = D_r_3*t7
    D_delta_x_1 = l_d_1*t5
    D_delta_x_2 = l_d_2*t6
    D_delta_x_3 = l_d_3*t7
    t8 = A_y_1*t4
    D_p_y_1 = D_r_1*t8
    t9 = A_y_2*t4
    D_p_y_2 = D_r_2*t9
    t10 = A_y_3*t4
    D_p_y_3 = D_r_3*t10
    D_delta_y_1 = l_d_1*t8
    D_delta_y_2 = l_d_2*t9
    D_delta_y_3 = l_d_3*t10
    t11 = A_z_1*t4
    D_p_z_1 = D_r_1*t11
    t12 = A_z_2*t4
    D_p_z_2 = D_r_2*t12
    t13 = A_z_3*t4
    D_p_z_3 = D_r_3*t13
    D_delta_z_1 = l_d_1*t11
    D_delta_z_2 = l_d_2*t12
    D_delta_z_3 = l_d_3*t13
    k_1 = k_r_1*(a_R_1 + 1)
    k_2 = k_r_2*(a_R_2 + 1)
    k_3 = k_r_3*(a_R_3 + 1)
    k_out = np.empty((*batch, 9), dtype)
    k_out[..., 0] = k_1
    k_out[..., 1] = k_2
    k_out[..., 2] = k_3
    k_out[..., 3] = k_C
    k_out[..., 4] = k_C
    k_out[..., 5] = k_C
    k_out[..., 6] = k_S
    k_out[..., 7] = k_S
    k_out[..., 8] = k_S
    g_out = np.zeros((*batch, 9, 12), dtype)
    g_out[..., 0, 0] = 1
    g_out[..., 0, 3] = -1
    g_out[..., 1, 1] = 1
    g_out[..., 1, 4] = -1
    g_out[..., 2, 2] = 1
    g_out[..., 2, 5] = -1
    g_out[..., 3, 0] = D_p_x_1
    g_out[..., 3, 1] = D_p_x_2
    g_out[..., 3, 2] = D_p_x_3
    g_out[..., 3, 6] = D_delta_x_1
    g_out[..., 3, 7] = D_delta_x_2
    g_out[..., 3, 8] = D_delta_x_3
    g_out[..., 3, 9] = 1
    g_out[..., 4, 0] = D_p_y_1
    g_out[..., 4, 1] = D_p_y_2
    g_out[..., 4, 2] = D_p_y_3
    g_out[..., 4, 6] = D_delta_y_1
    g_out[..., 4, 7] = D_delta_y_2
    g_out[..., 4, 8] = D_delta_y_3
    g_out[..., 4, 10] = 1
    g_out[..., 5, 0] = D_p_z_1
    g_out[..., 5, 1] = D_p_z_2
    g_out[..., 5, 2] = D_p_z_3
    g_out[..., 5, 6] = D_delta_z_1
    g_out[..., 5, 7] = D_delta_z_2
    g_out[..., 5, 8] = D_delta_z_3
    g_out[..., 5, 11] = 1
    g_out[..., 6, 3] = 1
    g_out[..., 7, 4] = 1
    g_out[..., 8, 5] = 1
    return k_out, g_out


def driven():
    """Which coordinates are rotations of a rotor that a motor drives.

    Parameters
    ----------

    Returns
    -------
    d : array, shape (..., 6) [1]
        1 where a motor turns the coordinate, else 0.

    Notes
    -----
    The drives that the mechanism declares.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    d_out = np.zeros((*batch, 6), dtype)
    d_out[..., 3] = 1
    d_out[..., 4] = 1
    d_out[..., 5] = 1
    return d_out
