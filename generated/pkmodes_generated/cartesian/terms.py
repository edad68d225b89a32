# Generated from the derivation of cartesian and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Terms of the mechanism cartesian: motion of its bodies, and what holds them yielding.

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
    "mount_inertia",
    "mount_matrices",
    "place_motion",
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


def place_motion(p, parameters, effects):
    """Displacements of the places of terms per unit of every coordinate.

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
    J : array, shape (..., 7, 11) [1, m]
        One row for each displacement.

    Notes
    -----
    The velocities of the bodies that the mechanism declares, without the mounts of terms.
    1 operations; 1 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, x_B)
    b = x - x_B
    J_out = np.zeros((*batch, 7, 11), dtype)
    J_out[..., 0, 0] = 1
    J_out[..., 0, 8] = 1
    J_out[..., 1, 1] = 1
    J_out[..., 1, 9] = 1
    J_out[..., 1, 10] = b
    J_out[..., 2, 8] = 1
    J_out[..., 3, 1] = 1
    J_out[..., 3, 9] = 1
    J_out[..., 4, 2] = 1
    J_out[..., 5, 3] = 1
    J_out[..., 6, 9] = 1
    return J_out


def mount_matrices(p, parameters, effects):
    """Rows of M and K of what holds a body, where it yields alone.

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
    M_wq : array, shape (..., 2, 11) [kg, kg m]
        Entries of M between each mount and every coordinate.
    M_ww : array, shape (..., 2) [kg, kg m]
        Diagonal entry of M of each mount.
    K_wq : array, shape (..., 2, 11) [N/m, N]
        Entries of K between each mount and every coordinate.
    K_ww : array, shape (..., 2) [N/m, N]
        Diagonal entry of K of each mount.
    J_p : array, shape (..., 2, 2) [1, 1/m]
        Motion of the platform per unit of each mount.

    Notes
    -----
    Equations 24 to 48 with these displacements released; without the springs of the mounts.
    57 operations; 328 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    batch, dtype = _batch(x, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, rho_b, c_T, F_T)
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
    t9 = (1/6)*rho_b
    t10 = -l_f_1_1*t9 + (1/6)*l_f_1_2*rho_b
    t11 = (1/3)*rho_b
    t12 = l_f_1_1*t11
    t13 = l_f_1_2*t11
    t14 = -l_f_2_1*t9 + (1/6)*l_f_2_2*rho_b
    t15 = l_f_2_1*t11
    t16 = l_f_2_2*t11
    t17 = k_1_1 - k_1_2
    t18 = k_2_1 - k_2_2
    M_wq_out = np.zeros((*batch, 2, 11), dtype)
    M_wq_out[..., 0, 0] = t10
    M_wq_out[..., 0, 2] = R_p_1*t12 - R_p_1*t13
    M_wq_out[..., 0, 6] = t10
    M_wq_out[..., 1, 1] = t14
    M_wq_out[..., 1, 3] = R_p_2*t15 - R_p_2*t16
    M_wq_out[..., 1, 7] = t14
    M_ww_out = np.empty((*batch, 2), dtype)
    M_ww_out[..., 0] = t12 + t13
    M_ww_out[..., 1] = t15 + t16
    K_wq_out = np.zeros((*batch, 2, 11), dtype)
    K_wq_out[..., 0, 0] = t17
    K_wq_out[..., 0, 2] = R_p_1*k_1_1 - R_p_1*k_1_2
    K_wq_out[..., 0, 6] = t17
    K_wq_out[..., 1, 1] = t18
    K_wq_out[..., 1, 3] = R_p_2*k_2_1 - R_p_2*k_2_2
    K_wq_out[..., 1, 7] = t18
    K_ww_out = np.empty((*batch, 2), dtype)
    K_ww_out[..., 0] = k_1_1 + k_1_2
    K_ww_out[..., 1] = k_2_1 + k_2_2
    J_p_out = np.zeros((*batch, 2, 2), dtype)
    return M_wq_out, M_ww_out, K_wq_out, K_ww_out, J_p_out


def mount_inertia():
    """Derivatives of the rows of M of the mounts with respect to the mass that moves with each.

    Parameters
    ----------

    Returns
    -------
    M_wq : array, shape (..., 2, 11) [1]
        Of M_wq.
    M_ww : array, shape (..., 2) [1]
        Of M_ww.

    Notes
    -----
    The kinetic energy of a bearing that yields, of which the frame has the rest.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    M_wq_out = np.zeros((*batch, 2, 11), dtype)
    M_ww_out = np.empty((*batch, 2), dtype)
    M_ww_out[..., 0] = 1
    M_ww_out[..., 1] = 1
    return M_wq_out, M_ww_out
