# Generated from the derivation of corexy and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Points and springs of the mechanism corexy, with effects, for pictures of it.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: belt j; run s of a belt.  t1, t2, ... are subexpressions shared by several
values.

* l_f_j_s [m]: free length of run s of belt j
* k_j_s [N/m]: stiffness of run s of belt j
* b [m]: distance of what slides along the beam from the beam's middle
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
    "x",
    "y",
    "theta_1",
    "theta_2",
    "psi_1",
    "psi_2",
    "eps_1",
    "eps_2",
    "u_x",
    "u_y",
    "psi_b",
)
COORDINATE_UNITS = (
    "m",
    "m",
    "rad",
    "rad",
    "rad",
    "rad",
    "m",
    "m",
    "m",
    "m",
    "rad",
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
    p : array, shape (..., 2) [m]
        Tool head in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    r : array, shape (..., 50, 3) [m]
        Base frame; first the platform.

    Notes
    -----
    The positions that the mechanism declares, or those of its parts.
    69 operations; 805 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    g_1_1, g_1_2, g_2_1, g_2_2 = _entries(parameters.belt_path_direction, (2, 2))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    travel_min_x, travel_max_x, travel_min_y, travel_max_y = _entries(parameters.workspace, (2, 2))
    batch, dtype = _batch(x, g_1_1, R_p_1, travel_min_x)
    t1 = 8*R_p_1
    t2 = -t1 + travel_min_x
    t3 = -t1 + travel_min_y
    t4 = t1 + travel_max_y
    t5 = t1 + travel_max_x
    t6 = (1/2)*travel_max_x
    t7 = (1/2)*travel_min_x
    t8 = t6 + t7
    t9 = t1 + t6 - t7
    t10 = g_1_1*t9
    t11 = -t10 + t8
    t12 = (1/2)*travel_max_y
    t13 = (1/2)*travel_min_y
    t14 = t1 + t12 - t13
    t15 = g_1_2*t14
    t16 = t12 + t13
    t17 = -t15 + t16
    t18 = 2*R_p_1
    t19 = R_p_1*g_1_2
    t20 = g_1_1*t18 + t11
    t21 = -t19 + y
    t22 = 3*R_p_1
    t23 = t10 + t8
    t24 = t19 + y
    t25 = t15 + t16
    t26 = R_p_1*g_1_1
    t27 = t11 + t26
    t28 = t23 + t26
    t29 = t19 + t25
    t30 = -t7 - 1/2*travel_max_x
    t31 = -t10 - t26 - t30
    t32 = g_2_1*t9
    t33 = -t32 + t8
    t34 = g_2_2*t14
    t35 = t16 - t34
    t36 = (7/2)*R_p_2
    t37 = R_p_2*g_2_2
    t38 = R_p_2*g_2_1
    t39 = t33 + 2*t38
    t40 = -t37 + y
    t41 = (9/2)*R_p_2
    t42 = t32 + t8
    t43 = t37 + y
    t44 = t16 + t34
    t45 = t33 + t38
    t46 = t38 + t42
    t47 = t37 + t44
    t48 = -t30 - t32 - t38
    r_out = np.zeros((*batch, 50, 3), dtype)
    r_out[..., 0, 0] = x
    r_out[..., 0, 1] = y
    r_out[..., 1, 0] = t2
    r_out[..., 1, 1] = t3
    r_out[..., 2, 0] = t2
    r_out[..., 2, 1] = t4
    r_out[..., 3, 0] = t5
    r_out[..., 3, 1] = t3
    r_out[..., 4, 0] = t5
    r_out[..., 4, 1] = t4
    r_out[..., 5, 0] = t2
    r_out[..., 5, 1] = y
    r_out[..., 6, 0] = t5
    r_out[..., 6, 1] = y
    r_out[..., 7, 0] = 4*R_p_1 + x
    r_out[..., 7, 1] = y
    r_out[..., 8, 0] = t11
    r_out[..., 8, 1] = t17
    r_out[..., 8, 2] = t18
    r_out[..., 9, 0] = t11
    r_out[..., 9, 1] = t17
    r_out[..., 9, 2] = 2*R_p_1 - g_1_1*t19
    r_out[..., 10, 0] = t20
    r_out[..., 10, 1] = t21
    r_out[..., 10, 2] = t18
    r_out[..., 11, 0] = t20
    r_out[..., 11, 1] = t21
    r_out[..., 11, 2] = t22
    r_out[..., 12, 0] = t23
    r_out[..., 12, 1] = t24
    r_out[..., 12, 2] = t18
    r_out[..., 13, 0] = t23
    r_out[..., 13, 1] = t24
    r_out[..., 13, 2] = t22
    r_out[..., 14, 0] = t23
    r_out[..., 14, 1] = t25
    r_out[..., 14, 2] = t18
    r_out[..., 15, 0] = t23
    r_out[..., 15, 1] = t25
    r_out[..., 15, 2] = t22
    r_out[..., 16, 0] = t11
    r_out[..., 16, 1] = t25
    r_out[..., 16, 2] = t18
    r_out[..., 17, 0] = t11
    r_out[..., 17, 1] = t25
    r_out[..., 17, 2] = t22
    r_out[..., 18, 0] = x
    r_out[..., 18, 1] = y
    r_out[..., 18, 2] = t18
    r_out[..., 19, 0] = t20
    r_out[..., 19, 1] = y
    r_out[..., 19, 2] = t18
    r_out[..., 20, 0] = t27
    r_out[..., 20, 1] = t21
    r_out[..., 20, 2] = t18
    r_out[..., 21, 0] = t27
    r_out[..., 21, 1] = t17
    r_out[..., 21, 2] = t18
    r_out[..., 22, 0] = t23
    r_out[..., 22, 1] = y
    r_out[..., 22, 2] = t18
    r_out[..., 23, 0] = t28
    r_out[..., 23, 1] = t24
    r_out[..., 23, 2] = t18
    r_out[..., 24, 0] = t28
    r_out[..., 24, 1] = t25
    r_out[..., 24, 2] = t18
    r_out[..., 25, 0] = t23
    r_out[..., 25, 1] = t29
    r_out[..., 25, 2] = t18
    r_out[..., 26, 0] = t11
    r_out[..., 26, 1] = t29
    r_out[..., 26, 2] = t18
    r_out[..., 27, 0] = t31
    r_out[..., 27, 1] = t25
    r_out[..., 27, 2] = t18
    r_out[..., 28, 0] = t31
    r_out[..., 28, 1] = t17
    r_out[..., 28, 2] = t18
    r_out[..., 29, 0] = t33
    r_out[..., 29, 1] = t35
    r_out[..., 29, 2] = t36
    r_out[..., 30, 0] = t33
    r_out[..., 30, 1] = t35
    r_out[..., 30, 2] = (7/2)*R_p_2 - g_2_1*t37
    r_out[..., 31, 0] = t39
    r_out[..., 31, 1] = t40
    r_out[..., 31, 2] = t36
    r_out[..., 32, 0] = t39
    r_out[..., 32, 1] = t40
    r_out[..., 32, 2] = t41
    r_out[..., 33, 0] = t42
    r_out[..., 33, 1] = t43
    r_out[..., 33, 2] = t36
    r_out[..., 34, 0] = t42
    r_out[..., 34, 1] = t43
    r_out[..., 34, 2] = t41
    r_out[..., 35, 0] = t42
    r_out[..., 35, 1] = t44
    r_out[..., 35, 2] = t36
    r_out[..., 36, 0] = t42
    r_out[..., 36, 1] = t44
    r_out[..., 36, 2] = t41
    r_out[..., 37, 0] = t33
    r_out[..., 37, 1] = t44
    r_out[..., 37, 2] = t36
    r_out[..., 38, 0] = t33
    r_out[..., 38, 1] = t44
    r_out[..., 38, 2] = t41
    r_out[..., 39, 0] = x
    r_out[..., 39, 1] = y
    r_out[..., 39, 2] = t36
    r_out[..., 40, 0] = t39
    r_out[..., 40, 1] = y
    r_out[..., 40, 2] = t36
    r_out[..., 41, 0] = t45
    r_out[..., 41, 1] = t40
    r_out[..., 41, 2] = t36
    r_out[..., 42, 0] = t45
    r_out[..., 42, 1] = t35
    r_out[..., 42, 2] = t36
    r_out[..., 43, 0] = t42
    r_out[..., 43, 1] = y
    r_out[..., 43, 2] = t36
    r_out[..., 44, 0] = t46
    r_out[..., 44, 1] = t43
    r_out[..., 44, 2] = t36
    r_out[..., 45, 0] = t46
    r_out[..., 45, 1] = t44
    r_out[..., 45, 2] = t36
    r_out[..., 46, 0] = t42
    r_out[..., 46, 1] = t47
    r_out[..., 46, 2] = t36
    r_out[..., 47, 0] = t33
    r_out[..., 47, 1] = t47
    r_out[..., 47, 2] = t36
    r_out[..., 48, 0] = t48
    r_out[..., 48, 1] = t44
    r_out[..., 48, 2] = t36
    r_out[..., 49, 0] = t48
    r_out[..., 49, 1] = t35
    r_out[..., 49, 2] = t36
    return r_out


def drawing_motion(p, parameters, effects):
    """Jacobians of these points with respect to every coordinate, one for points that move alike.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head in the base frame.
    parameters : Parameters
        The robot's parameters.
    effects : Effects
        The robot's effects.

    Returns
    -------
    J : array, shape (..., 19, 3, 11) [1, m]
        dr_i/dq_k, base frame.

    Notes
    -----
    The positions differentiated, with the contributions of released joints and the frame.
    36 operations; 176 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    g_1_1, g_1_2, g_2_1, g_2_2 = _entries(parameters.belt_path_direction, (2, 2))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    travel_min_x, travel_max_x, _, _ = _entries(parameters.workspace, (2, 2))
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, g_1_1, R_p_1, travel_min_x, x_B)
    b = x - x_B
    t1 = 8*R_p_1
    t2 = R_p_1*g_1_2
    t3 = (1/2)*travel_max_x
    t4 = (1/2)*travel_min_x
    t5 = t1 + t3 - t4
    t6 = g_1_1*t5
    t7 = t3 + t4 - x_B
    t8 = -t6 + t7
    t9 = R_p_1*g_1_1
    t10 = t8 + 2*t9
    t11 = t6 + t7
    t12 = R_p_2*g_2_2
    t13 = R_p_2*g_2_1
    t14 = g_2_1*t5
    t15 = -t14 + t7
    t16 = 2*t13 + t15
    t17 = t14 + t7
    J_out = np.zeros((*batch, 19, 3, 11), dtype)
    J_out[..., 0, 0, 0] = 1
    J_out[..., 0, 0, 8] = 1
    J_out[..., 0, 1, 1] = 1
    J_out[..., 0, 1, 9] = 1
    J_out[..., 0, 1, 10] = b
    J_out[..., 1, 0, 8] = 1
    J_out[..., 1, 1, 9] = 1
    J_out[..., 2, 0, 8] = 1
    J_out[..., 2, 1, 1] = 1
    J_out[..., 2, 1, 9] = 1
    J_out[..., 2, 1, 10] = -t1 + travel_min_x - x_B
    J_out[..., 3, 0, 8] = 1
    J_out[..., 3, 1, 1] = 1
    J_out[..., 3, 1, 9] = 1
    J_out[..., 3, 1, 10] = t1 + travel_max_x - x_B
    J_out[..., 4, 0, 0] = 1
    J_out[..., 4, 0, 8] = 1
    J_out[..., 4, 1, 1] = 1
    J_out[..., 4, 1, 9] = 1
    J_out[..., 4, 1, 10] = 4*R_p_1 + b
    J_out[..., 5, 0, 8] = 1
    J_out[..., 5, 0, 10] = t2
    J_out[..., 5, 1, 1] = 1
    J_out[..., 5, 1, 9] = 1
    J_out[..., 5, 1, 10] = t10
    J_out[..., 6, 0, 8] = 1
    J_out[..., 6, 0, 10] = -t2
    J_out[..., 6, 1, 1] = 1
    J_out[..., 6, 1, 9] = 1
    J_out[..., 6, 1, 10] = t11
    J_out[..., 7, 0, 0] = 1
    J_out[..., 7, 0, 6] = g_1_1
    J_out[..., 7, 0, 8] = 1
    J_out[..., 7, 1, 1] = 1
    J_out[..., 7, 1, 9] = 1
    J_out[..., 7, 1, 10] = b
    J_out[..., 8, 0, 8] = 1
    J_out[..., 8, 1, 1] = 1
    J_out[..., 8, 1, 9] = 1
    J_out[..., 8, 1, 10] = t10
    J_out[..., 9, 0, 8] = 1
    J_out[..., 9, 0, 10] = t2
    J_out[..., 9, 1, 1] = 1
    J_out[..., 9, 1, 9] = 1
    J_out[..., 9, 1, 10] = t8 + t9
    J_out[..., 10, 0, 8] = 1
    J_out[..., 10, 1, 1] = 1
    J_out[..., 10, 1, 9] = 1
    J_out[..., 10, 1, 10] = t11
    J_out[..., 11, 0, 8] = 1
    J_out[..., 11, 0, 10] = -t2
    J_out[..., 11, 1, 1] = 1
    J_out[..., 11, 1, 9] = 1
    J_out[..., 11, 1, 10] = t11 + t9
    J_out[..., 12, 0, 8] = 1
    J_out[..., 12, 0, 10] = t12
    J_out[..., 12, 1, 1] = 1
    J_out[..., 12, 1, 9] = 1
    J_out[..., 12, 1, 10] = t16
    J_out[..., 13, 0, 8] = 1
    J_out[..., 13, 0, 10] = -t12
    J_out[..., 13, 1, 1] = 1
    J_out[..., 13, 1, 9] = 1
    J_out[..., 13, 1, 10] = t17
    J_out[..., 14, 0, 0] = 1
    J_out[..., 14, 0, 7] = g_2_1
    J_out[..., 14, 0, 8] = 1
    J_out[..., 14, 1, 1] = 1
    J_out[..., 14, 1, 9] = 1
    J_out[..., 14, 1, 10] = b
    J_out[..., 15, 0, 8] = 1
    J_out[..., 15, 1, 1] = 1
    J_out[..., 15, 1, 9] = 1
    J_out[..., 15, 1, 10] = t16
    J_out[..., 16, 0, 8] = 1
    J_out[..., 16, 0, 10] = t12
    J_out[..., 16, 1, 1] = 1
    J_out[..., 16, 1, 9] = 1
    J_out[..., 16, 1, 10] = t13 + t15
    J_out[..., 17, 0, 8] = 1
    J_out[..., 17, 1, 1] = 1
    J_out[..., 17, 1, 9] = 1
    J_out[..., 17, 1, 10] = t17
    J_out[..., 18, 0, 8] = 1
    J_out[..., 18, 0, 10] = -t12
    J_out[..., 18, 1, 1] = 1
    J_out[..., 18, 1, 9] = 1
    J_out[..., 18, 1, 10] = t13 + t17
    return J_out


def springs(p, parameters, effects):
    """Stiffness of every spring, and its elongation or twist per unit of each coordinate.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head in the base frame.
    parameters : Parameters
        The robot's parameters.
    effects : Effects
        The robot's effects.

    Returns
    -------
    k : array, shape (..., 8) [N/m, N m/rad]
        Stiffness.
    g : array, shape (..., 8, 11) [1, m, 1/m]
        The energy is the sum of k (g . q)^2 / 2.

    Notes
    -----
    Equation 38 with the effects' energies; the springs of released joints are not among them.
    34 operations; 85 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    g_1_1, g_1_2, g_2_1, g_2_2 = _entries(parameters.belt_path_direction, (2, 2))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.belt_path_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, c_T, F_T, k_C, k_S, x_B)
    b = x - x_B
    t1 = g_1_1*x + g_1_2*y
    l_f_1_1 = l_0_1_1 + t1
    t2 = F_T*c_T + 1
    t3 = c_E*t2
    t4 = k_sp_1*w_b_1*(a_B_1 + 1)
    t5 = t3*t4
    t6 = t2*t4
    k_1_1 = t6/(l_f_1_1 + t5)
    l_f_1_2 = l_0_1_2 - t1
    k_1_2 = t6/(l_f_1_2 + t5)
    t7 = g_2_1*x + g_2_2*y
    l_f_2_1 = l_0_2_1 + t7
    t8 = k_sp_2*w_b_2*(a_B_2 + 1)
    t9 = t3*t8
    t10 = t2*t8
    k_2_1 = t10/(l_f_2_1 + t9)
    l_f_2_2 = l_0_2_2 - t7
    k_2_2 = t10/(l_f_2_2 + t9)
    t11 = b*g_1_2
    t12 = b*g_2_2
    k_out = np.empty((*batch, 8), dtype)
    k_out[..., 0] = k_1_1
    k_out[..., 1] = k_1_2
    k_out[..., 2] = k_2_1
    k_out[..., 3] = k_2_2
    k_out[..., 4] = k_C
    k_out[..., 5] = k_C
    k_out[..., 6] = k_S
    k_out[..., 7] = k_S
    g_out = np.zeros((*batch, 8, 11), dtype)
    g_out[..., 0, 0] = g_1_1
    g_out[..., 0, 1] = g_1_2
    g_out[..., 0, 2] = R_p_1
    g_out[..., 0, 6] = 1
    g_out[..., 0, 10] = t11
    g_out[..., 1, 0] = g_1_1
    g_out[..., 1, 1] = g_1_2
    g_out[..., 1, 2] = R_p_1
    g_out[..., 1, 6] = 1
    g_out[..., 1, 10] = t11
    g_out[..., 2, 0] = g_2_1
    g_out[..., 2, 1] = g_2_2
    g_out[..., 2, 3] = R_p_2
    g_out[..., 2, 7] = 1
    g_out[..., 2, 10] = t12
    g_out[..., 3, 0] = g_2_1
    g_out[..., 3, 1] = g_2_2
    g_out[..., 3, 3] = R_p_2
    g_out[..., 3, 7] = 1
    g_out[..., 3, 10] = t12
    g_out[..., 4, 0] = 1
    g_out[..., 4, 8] = 1
    g_out[..., 5, 1] = 1
    g_out[..., 5, 9] = 1
    g_out[..., 5, 10] = b
    g_out[..., 6, 2] = 1
    g_out[..., 6, 4] = 1
    g_out[..., 7, 3] = 1
    g_out[..., 7, 5] = 1
    return k_out, g_out


def driven():
    """Which coordinates are rotations of a rotor that a motor drives.

    Parameters
    ----------

    Returns
    -------
    d : array, shape (..., 4) [1]
        1 where a motor turns the coordinate, else 0.

    Notes
    -----
    The drives that the mechanism declares.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    d_out = np.zeros((*batch, 4), dtype)
    d_out[..., 2] = 1
    d_out[..., 3] = 1
    return d_out
