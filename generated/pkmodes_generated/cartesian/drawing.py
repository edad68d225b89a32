# Generated from the derivation of cartesian and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Points and springs of the mechanism cartesian, with effects, for pictures of it.

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
    r : array, shape (..., 28, 3) [m]
        Base frame; first the platform.

    Notes
    -----
    The positions that the mechanism declares, or those of its parts.
    19 operations; 119 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    travel_min_x, travel_max_x, travel_min_y, travel_max_y = _entries(parameters.workspace, (2, 2))
    batch, dtype = _batch(x, R_p_1, travel_min_x)
    t1 = 8*R_p_1
    t2 = -t1 + travel_min_x
    t3 = -t1 + travel_min_y
    t4 = t1 + travel_max_y
    t5 = t1 + travel_max_x
    t6 = -R_p_1 + y
    t7 = 2*R_p_1
    t8 = 3*R_p_1
    t9 = -t7 + y
    t10 = -t1 + travel_min_x
    t11 = R_p_2 + t10
    t12 = R_p_2 + t7
    t13 = 2*R_p_2 + t10
    r_out = np.zeros((*batch, 28, 3), dtype)
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
    r_out[..., 8, 0] = t2
    r_out[..., 8, 1] = t6
    r_out[..., 8, 2] = t7
    r_out[..., 9, 0] = t2
    r_out[..., 9, 1] = t6
    r_out[..., 9, 2] = t8
    r_out[..., 10, 0] = t5
    r_out[..., 10, 1] = t6
    r_out[..., 10, 2] = t7
    r_out[..., 11, 0] = t5
    r_out[..., 11, 1] = t6
    r_out[..., 11, 2] = t8
    r_out[..., 12, 0] = x
    r_out[..., 12, 1] = y
    r_out[..., 12, 2] = t7
    r_out[..., 13, 0] = t2
    r_out[..., 13, 1] = y
    r_out[..., 13, 2] = t7
    r_out[..., 14, 0] = t5
    r_out[..., 14, 1] = y
    r_out[..., 14, 2] = t7
    r_out[..., 15, 0] = 9*R_p_1 + travel_max_x
    r_out[..., 15, 1] = t6
    r_out[..., 15, 2] = t7
    r_out[..., 16, 0] = t5
    r_out[..., 16, 1] = t9
    r_out[..., 16, 2] = t7
    r_out[..., 17, 0] = t2
    r_out[..., 17, 1] = t9
    r_out[..., 17, 2] = t7
    r_out[..., 18, 0] = t11
    r_out[..., 18, 1] = t3
    r_out[..., 18, 2] = t7
    r_out[..., 19, 0] = t11
    r_out[..., 19, 1] = t3
    r_out[..., 19, 2] = t12
    r_out[..., 20, 0] = t11
    r_out[..., 20, 1] = t4
    r_out[..., 20, 2] = t7
    r_out[..., 21, 0] = t11
    r_out[..., 21, 1] = t4
    r_out[..., 21, 2] = t12
    r_out[..., 22, 0] = t2
    r_out[..., 22, 1] = y
    r_out[..., 22, 2] = t7
    r_out[..., 23, 0] = t2
    r_out[..., 23, 1] = t3
    r_out[..., 23, 2] = t7
    r_out[..., 24, 0] = t2
    r_out[..., 24, 1] = t4
    r_out[..., 24, 2] = t7
    r_out[..., 25, 0] = t11
    r_out[..., 25, 1] = R_p_2 + t4
    r_out[..., 25, 2] = t7
    r_out[..., 26, 0] = t13
    r_out[..., 26, 1] = t4
    r_out[..., 26, 2] = t7
    r_out[..., 27, 0] = t13
    r_out[..., 27, 1] = t3
    r_out[..., 27, 2] = t7
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
    J : array, shape (..., 12, 3, 11) [1, m]
        dr_i/dq_k, base frame.

    Notes
    -----
    The positions differentiated, with the contributions of released joints and the frame.
    11 operations; 31 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    R_p_1, _ = _entries(parameters.pulley_radius, (2,))
    travel_min_x, travel_max_x, _, _ = _entries(parameters.workspace, (2, 2))
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, R_p_1, travel_min_x, x_B)
    b = x - x_B
    t1 = 8*R_p_1
    t2 = -t1 + travel_min_x - x_B
    t3 = travel_max_x - x_B
    t4 = t1 + t3
    t5 = 2*R_p_1
    J_out = np.zeros((*batch, 12, 3, 11), dtype)
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
    J_out[..., 2, 1, 10] = t2
    J_out[..., 3, 0, 8] = 1
    J_out[..., 3, 1, 1] = 1
    J_out[..., 3, 1, 9] = 1
    J_out[..., 3, 1, 10] = t4
    J_out[..., 4, 0, 0] = 1
    J_out[..., 4, 0, 8] = 1
    J_out[..., 4, 1, 1] = 1
    J_out[..., 4, 1, 9] = 1
    J_out[..., 4, 1, 10] = 4*R_p_1 + b
    J_out[..., 5, 0, 8] = 1
    J_out[..., 5, 0, 10] = R_p_1
    J_out[..., 5, 1, 1] = 1
    J_out[..., 5, 1, 9] = 1
    J_out[..., 5, 1, 10] = t2
    J_out[..., 6, 0, 8] = 1
    J_out[..., 6, 0, 10] = R_p_1
    J_out[..., 6, 1, 1] = 1
    J_out[..., 6, 1, 9] = 1
    J_out[..., 6, 1, 10] = t4
    J_out[..., 7, 0, 0] = 1
    J_out[..., 7, 0, 6] = 1
    J_out[..., 7, 0, 8] = 1
    J_out[..., 7, 1, 1] = 1
    J_out[..., 7, 1, 9] = 1
    J_out[..., 7, 1, 10] = b
    J_out[..., 8, 0, 8] = 1
    J_out[..., 8, 0, 10] = R_p_1
    J_out[..., 8, 1, 1] = 1
    J_out[..., 8, 1, 9] = 1
    J_out[..., 8, 1, 10] = 9*R_p_1 + t3
    J_out[..., 9, 0, 8] = 1
    J_out[..., 9, 0, 10] = t5
    J_out[..., 9, 1, 1] = 1
    J_out[..., 9, 1, 9] = 1
    J_out[..., 9, 1, 10] = t4
    J_out[..., 10, 0, 8] = 1
    J_out[..., 10, 0, 10] = t5
    J_out[..., 10, 1, 1] = 1
    J_out[..., 10, 1, 9] = 1
    J_out[..., 10, 1, 10] = t2
    J_out[..., 11, 0, 8] = 1
    J_out[..., 11, 1, 1] = 1
    J_out[..., 11, 1, 7] = 1
    J_out[..., 11, 1, 9] = 1
    J_out[..., 11, 1, 10] = t2
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
    26 operations; 65 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
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
    batch, dtype = _batch(x, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, c_T, F_T, k_C, k_S, x_B)
    b = x - x_B
    l_f_1_1 = l_0_1_1 + x
    t1 = F_T*c_T + 1
    t2 = c_E*t1
    t3 = k_sp_1*w_b_1*(a_B_1 + 1)
    t4 = t2*t3
    t5 = t1*t3
    k_1_1 = t5/(l_f_1_1 + t4)
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t5/(l_f_1_2 + t4)
    l_f_2_1 = l_0_2_1 + y
    t6 = k_sp_2*w_b_2*(a_B_2 + 1)
    t7 = t2*t6
    t8 = t1*t6
    k_2_1 = t8/(l_f_2_1 + t7)
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t8/(l_f_2_2 + t7)
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
    g_out[..., 0, 0] = 1
    g_out[..., 0, 2] = R_p_1
    g_out[..., 0, 6] = 1
    g_out[..., 1, 0] = 1
    g_out[..., 1, 2] = R_p_1
    g_out[..., 1, 6] = 1
    g_out[..., 2, 1] = 1
    g_out[..., 2, 3] = R_p_2
    g_out[..., 2, 7] = 1
    g_out[..., 3, 1] = 1
    g_out[..., 3, 3] = R_p_2
    g_out[..., 3, 7] = 1
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
