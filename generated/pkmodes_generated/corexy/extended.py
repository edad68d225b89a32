# Generated from the derivation of corexy and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism corexy with effects: extended matrices and sensitivities.

Arrays are batch first: a leading `...` stands for any batch shape, including none, and arguments broadcast.
Complex arguments are accepted (for complex-step derivatives).  All quantities are in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code.  Indices: belt j; run s of a belt.  t1, t2, ... are subexpressions shared by several
values.

* tau_st_j [N m]: static torque on motor pulley j
* I_j [kg m^2]: moment of inertia of motor pulley j, including the motor
* l_f_j_s [m]: free length of run s of belt j
* k_j_s [N/m]: stiffness of run s of belt j
* G_j [N]: gradient of the gravitational potential energy with respect to independent coordinate j
* det_j [N^2]: determinant of the equilibrium equations of axis j
* theta_j_st [rad]: static rotation of motor pulley j, relative to the unstrained transmissions
"""

from math import prod
from typing import NamedTuple

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "Effects",
    "VALUE_SENSITIVITIES",
    "GEOMETRY_SENSITIVITIES",
    "belt_tension_stiffness_margin",
    "extended_dissipation",
    "extended_matrices",
    "extended_platform_motion",
    "extended_static_equilibrium",
    "geometry_sensitivities",
    "joint_loss",
    "joint_stiffness",
    "motor_motion",
    "value_sensitivities",
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
)

#: Parameters of the derivatives: field of Parameters or Effects, index in it, and (row, column) of the
#: entries of M and of K, in the upper triangle, that depend on it.
VALUE_SENSITIVITIES = (
    ('toolhead_mass', (), ((0, 0), (0, 8), (1, 1), (1, 9), (8, 8), (9, 9)), ()),
    ('gantry_mass', (), ((1, 1), (1, 9), (8, 8), (9, 9)), ()),
    ('gravity', (0,), (), ()),
    ('gravity', (1,), (), ()),
    ('gravity', (2,), (), ()),
    ('belt_path_lengths', (0, 0),
     ((0, 0), (0, 1), (0, 2), (0, 6), (1, 1), (1, 2), (1, 6), (2, 2), (2, 6), (6, 6)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (1, 1), (1, 2), (1, 6), (2, 2), (2, 6), (6, 6))),
    ('belt_path_lengths', (0, 1),
     ((0, 0), (0, 1), (0, 2), (0, 6), (1, 1), (1, 2), (1, 6), (2, 2), (2, 6), (6, 6)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (1, 1), (1, 2), (1, 6), (2, 2), (2, 6), (6, 6))),
    ('belt_path_lengths', (1, 0),
     ((0, 0), (0, 1), (0, 3), (0, 7), (1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7)),
     ((0, 0), (0, 1), (0, 3), (0, 7), (1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('belt_path_lengths', (1, 1),
     ((0, 0), (0, 1), (0, 3), (0, 7), (1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7)),
     ((0, 0), (0, 1), (0, 3), (0, 7), (1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('belt_specific_stiffness', (0,), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (1, 1), (1, 2), (1, 6), (2, 2), (2, 6), (6, 6))),
    ('belt_specific_stiffness', (1,), (),
     ((0, 0), (0, 1), (0, 3), (0, 7), (1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('belt_width', (0,), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (1, 1), (1, 2), (1, 6), (2, 2), (2, 6), (6, 6))),
    ('belt_width', (1,), (),
     ((0, 0), (0, 1), (0, 3), (0, 7), (1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('pulley_radius', (0,), ((0, 2), (1, 2), (2, 2), (2, 6)), ((0, 2), (1, 2), (2, 2), (2, 6))),
    ('pulley_radius', (1,), ((0, 3), (1, 3), (3, 3), (3, 7)), ((0, 3), (1, 3), (3, 3), (3, 7))),
    ('pulley_inertia', (0,), ((2, 2),), ()),
    ('pulley_inertia', (1,), ((3, 3),), ()),
    ('motor_inertia', (0,), ((2, 2), (2, 4), (4, 4)), ()),
    ('motor_inertia', (1,), ((3, 3), (3, 5), (5, 5)), ()),
    ('gear_ratio', (0,), ((2, 2), (2, 4), (4, 4)), ()),
    ('gear_ratio', (1,), ((3, 3), (3, 5), (5, 5)), ()),
    ('workspace', (0, 0), (), ()),
    ('workspace', (0, 1), (), ()),
    ('workspace', (1, 0), (), ()),
    ('workspace', (1, 1), (), ()),
    ('axis_belt_stiffness_factor_1', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (1, 1), (1, 2), (1, 6), (2, 2), (2, 6), (6, 6))),
    ('axis_belt_stiffness_factor_2', (), (),
     ((0, 0), (0, 1), (0, 3), (0, 7), (1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('belt_end_compliance_compliance', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7), (2, 2),
      (2, 6), (3, 3), (3, 7), (6, 6), (7, 7))),
    ('belt_loss_loss_factor', (), (), ()),
    ('belt_mass_linear_density', (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7), (2, 2),
      (2, 6), (3, 3), (3, 7), (6, 6), (7, 7)),
     ()),
    ('belt_tension_stiffness_coefficient', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7), (2, 2),
      (2, 6), (3, 3), (3, 7), (6, 6), (7, 7))),
    ('belt_tension_stiffness_tension', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7), (2, 2),
      (2, 6), (3, 3), (3, 7), (6, 6), (7, 7))),
    ('cable_stiffness_stiffness', (), (), ((0, 0), (0, 8), (1, 1), (1, 9), (8, 8), (9, 9))),
    ('drive_friction_viscous', (), (), ()),
    ('gearbox_inertia_inertia', (), ((2, 2), (3, 3)), ()),
    ('payload_mass', (), ((0, 0), (0, 8), (1, 1), (1, 9), (8, 8), (9, 9)), ()),
    ('rail_friction_viscous', (), (), ()),
    ('reducer_loss_loss_factor', (), (), ()),
    ('servo_stiffness_stiffness', (), (), ((2, 2), (2, 4), (3, 3), (3, 5), (4, 4), (5, 5))),
    ('frame_compliance_mass', (), ((8, 8), (9, 9)), ()),
)

#: The same for `geometry_sensitivities`.
GEOMETRY_SENSITIVITIES = (
)


class Effects(NamedTuple):
    """Effects of a robot; every field may have its own leading batch axes.

    Attributes
    ----------
    axis_belt_stiffness_factor_1 : float or array, shape (...) [1]
        Relative change of the stiffness of belt 1.
    axis_belt_stiffness_factor_2 : float or array, shape (...) [1]
        Relative change of the stiffness of belt 2.
    belt_end_compliance_compliance : float or array, shape (...) [m/N]
        Compliance in series with every free span.
    belt_loss_loss_factor : float or array, shape (...) [1]
        Loss factor of every free span.
    belt_mass_linear_density : float or array, shape (...) [kg/m]
        Mass of a belt per unit length.
    belt_tension_stiffness_coefficient : float or array, shape (...) [1/N]
        Relative change of the belt stiffness with tension.
    belt_tension_stiffness_tension : float or array, shape (...) [N]
        Measured tension of every belt.
    cable_stiffness_stiffness : float or array, shape (...) [N/m]
        Isotropic stiffness from the platform centre to ground.
    drive_friction_viscous : float or array, shape (...) [N m s/rad]
        Viscous friction of every motor, seen at the driven rotor.
    gearbox_inertia_inertia : float or array, shape (...) [kg m^2]
        Extra inertia on every driven pulley.
    payload_mass : float or array, shape (...) [kg]
        Point mass at the platform centre.
    rail_friction_viscous : float or array, shape (...) [N s/m]
        Viscous friction of every body along its rail.
    reducer_loss_loss_factor : float or array, shape (...) [1]
        Loss factor of every reducer, or gearbox that winds up.
    servo_stiffness_stiffness : float or array, shape (...) [N m/rad]
        Torsional stiffness to ground at every motor, seen at the driven rotor.
    gearbox_compliance_compliance : float or array, shape (...) [rad/(N m)]
        Compliance of every gearbox, output side.
    clamp_compliance_compliance : float or array, shape (...) [m/N]
        Compliance of every belt clamp.
    frame_compliance_compliance : float or array, shape (...) [m/N]
        Isotropic compliance of the frame.
    frame_compliance_mass : float or array, shape (...) [kg]
        Mass of the frame.
    """

    axis_belt_stiffness_factor_1: float = 0.0
    axis_belt_stiffness_factor_2: float = 0.0
    belt_end_compliance_compliance: float = 0.0
    belt_loss_loss_factor: float = 0.0
    belt_mass_linear_density: float = 0.0
    belt_tension_stiffness_coefficient: float = 0.0
    belt_tension_stiffness_tension: float = 0.0
    cable_stiffness_stiffness: float = 0.0
    drive_friction_viscous: float = 0.0
    gearbox_inertia_inertia: float = 0.0
    payload_mass: float = 0.0
    rail_friction_viscous: float = 0.0
    reducer_loss_loss_factor: float = 0.0
    servo_stiffness_stiffness: float = 0.0
    gearbox_compliance_compliance: float = 0.0
    clamp_compliance_compliance: float = 0.0
    frame_compliance_compliance: float = 0.0
    frame_compliance_mass: float = 0.0


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


def _listed(batch, dtype, entries):
    """Return the vector of these entries for each member of the batch."""
    if not batch:
        return np.array(entries, dtype)
    columns = np.empty((len(entries), *batch), dtype)
    for column, entry in zip(columns, entries):
        column[...] = entry
    return np.moveaxis(columns, 0, -1)


def extended_matrices(p, parameters, effects):
    """Mass and stiffness matrices in the base and all released coordinates, with free joints.

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
    M : array, shape (..., 10, 10) [kg, kg m, kg m^2]
        Mass matrix; its leading block is that of the base model.
    K_el : array, shape (..., 10, 10) [N/m, N, N m]
        Elastic stiffness with free joints.
    K_g : array, shape (..., 10, 10) [N/m, N, N m]
        Hessian of the gravitational potential energy.

    Notes
    -----
    Equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses.
    188 operations; 1919 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_g,) = _entries(parameters.gantry_mass, ())
    g_1_1, g_1_2, g_2_1, g_2_2 = _entries(parameters.belt_path_direction, (2, 2))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.belt_path_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    I_p_1, I_p_2 = _entries(parameters.pulley_inertia, (2,))
    I_m_1, I_m_2 = _entries(parameters.motor_inertia, (2,))
    i_g_1, i_g_2 = _entries(parameters.gear_ratio, (2,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (I_G,) = _entries(effects.gearbox_inertia_inertia, ())
    (m_L,) = _entries(effects.payload_mass, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    (m_F,) = _entries(effects.frame_compliance_mass, ())
    batch, dtype = _batch(x, m_h, m_g, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, I_p_1, I_m_1, i_g_1, a_B_1,
        a_B_2, c_E, rho_b, c_T, F_T, k_C, I_G, m_L, k_S, m_F)
    t1 = I_m_1*i_g_1**2
    I_1 = I_G + I_p_1 + t1
    t2 = I_m_2*i_g_2**2
    I_2 = I_G + I_p_2 + t2
    t3 = g_1_1*x + g_1_2*y
    l_f_1_1 = l_0_1_1 + t3
    t4 = F_T*c_T + 1
    t5 = c_E*t4
    t6 = k_sp_1*w_b_1*(a_B_1 + 1)
    t7 = t5*t6
    t8 = t4*t6
    k_1_1 = t8/(l_f_1_1 + t7)
    l_f_1_2 = l_0_1_2 - t3
    k_1_2 = t8/(l_f_1_2 + t7)
    t9 = g_2_1*x + g_2_2*y
    l_f_2_1 = l_0_2_1 + t9
    t10 = k_sp_2*w_b_2*(a_B_2 + 1)
    t11 = t10*t5
    t12 = t10*t4
    k_2_1 = t12/(l_f_2_1 + t11)
    l_f_2_2 = l_0_2_2 - t9
    k_2_2 = t12/(l_f_2_2 + t11)
    t13 = g_1_1**2
    t14 = (1/3)*rho_b
    t15 = l_f_1_1*t14
    t16 = l_f_1_2*t14
    t17 = g_2_1**2
    t18 = l_f_2_1*t14
    t19 = l_f_2_2*t14
    t20 = m_L + m_h
    t21 = g_1_1*t15
    t22 = g_1_1*t16
    t23 = g_2_1*t18
    t24 = g_2_1*t19
    t25 = (1/6)*rho_b
    t26 = R_p_1*t25
    t27 = l_f_1_1*t26
    t28 = l_f_1_2*t26
    t29 = R_p_2*t25
    t30 = l_f_2_1*t29
    t31 = l_f_2_2*t29
    t32 = g_1_2**2
    t33 = g_2_2**2
    t34 = m_g + t20
    t35 = R_p_1**2
    t36 = R_p_2**2
    t37 = m_F + t34
    t38 = g_1_1*k_1_1
    t39 = g_1_1*k_1_2
    t40 = g_2_1*k_2_1
    t41 = g_2_1*k_2_2
    t42 = g_1_2*k_1_1
    t43 = g_1_2*k_1_2
    t44 = g_2_2*k_2_1
    t45 = g_2_2*k_2_2
    M_out = np.zeros((*batch, 10, 10), dtype)
    M_out[..., 0, 0] = t13*t15 + t13*t16 + t17*t18 + t17*t19 + t20
    M_out[..., 0, 1] = M_out[..., 1, 0] = g_1_2*t21 + g_1_2*t22 + g_2_2*t23 + g_2_2*t24
    M_out[..., 0, 2] = M_out[..., 2, 0] = -g_1_1*t27 - g_1_1*t28
    M_out[..., 0, 3] = M_out[..., 3, 0] = -g_2_1*t30 - g_2_1*t31
    M_out[..., 0, 6] = M_out[..., 6, 0] = t21 + t22
    M_out[..., 0, 7] = M_out[..., 7, 0] = t23 + t24
    M_out[..., 0, 8] = M_out[..., 8, 0] = t20
    M_out[..., 1, 1] = t15*t32 + t16*t32 + t18*t33 + t19*t33 + t34
    M_out[..., 1, 2] = M_out[..., 2, 1] = -g_1_2*t27 - g_1_2*t28
    M_out[..., 1, 3] = M_out[..., 3, 1] = -g_2_2*t30 - g_2_2*t31
    M_out[..., 1, 6] = M_out[..., 6, 1] = g_1_2*t15 + g_1_2*t16
    M_out[..., 1, 7] = M_out[..., 7, 1] = g_2_2*t18 + g_2_2*t19
    M_out[..., 1, 9] = M_out[..., 9, 1] = t34
    M_out[..., 2, 2] = I_1 + t15*t35 + t16*t35
    M_out[..., 2, 4] = M_out[..., 4, 2] = t1
    M_out[..., 2, 6] = M_out[..., 6, 2] = -t27 - t28
    M_out[..., 3, 3] = I_2 + t18*t36 + t19*t36
    M_out[..., 3, 5] = M_out[..., 5, 3] = t2
    M_out[..., 3, 7] = M_out[..., 7, 3] = -t30 - t31
    M_out[..., 4, 4] = t1
    M_out[..., 5, 5] = t2
    M_out[..., 6, 6] = t15 + t16
    M_out[..., 7, 7] = t18 + t19
    M_out[..., 8, 8] = t37
    M_out[..., 9, 9] = t37
    K_el_out = np.zeros((*batch, 10, 10), dtype)
    K_el_out[..., 0, 0] = k_1_1*t13 + k_1_2*t13 + k_2_1*t17 + k_2_2*t17 + k_C
    K_el_out[..., 0, 1] = K_el_out[..., 1, 0] = g_1_2*t38 + g_1_2*t39 + g_2_2*t40 + g_2_2*t41
    K_el_out[..., 0, 2] = K_el_out[..., 2, 0] = R_p_1*t38 + R_p_1*t39
    K_el_out[..., 0, 3] = K_el_out[..., 3, 0] = R_p_2*t40 + R_p_2*t41
    K_el_out[..., 0, 6] = K_el_out[..., 6, 0] = t38 + t39
    K_el_out[..., 0, 7] = K_el_out[..., 7, 0] = t40 + t41
    K_el_out[..., 0, 8] = K_el_out[..., 8, 0] = k_C
    K_el_out[..., 1, 1] = k_1_1*t32 + k_1_2*t32 + k_2_1*t33 + k_2_2*t33 + k_C
    K_el_out[..., 1, 2] = K_el_out[..., 2, 1] = R_p_1*t42 + R_p_1*t43
    K_el_out[..., 1, 3] = K_el_out[..., 3, 1] = R_p_2*t44 + R_p_2*t45
    K_el_out[..., 1, 6] = K_el_out[..., 6, 1] = t42 + t43
    K_el_out[..., 1, 7] = K_el_out[..., 7, 1] = t44 + t45
    K_el_out[..., 1, 9] = K_el_out[..., 9, 1] = k_C
    K_el_out[..., 2, 2] = k_1_1*t35 + k_1_2*t35 + k_S
    K_el_out[..., 2, 4] = K_el_out[..., 4, 2] = k_S
    K_el_out[..., 2, 6] = K_el_out[..., 6, 2] = R_p_1*k_1_1 + R_p_1*k_1_2
    K_el_out[..., 3, 3] = k_2_1*t36 + k_2_2*t36 + k_S
    K_el_out[..., 3, 5] = K_el_out[..., 5, 3] = k_S
    K_el_out[..., 3, 7] = K_el_out[..., 7, 3] = R_p_2*k_2_1 + R_p_2*k_2_2
    K_el_out[..., 4, 4] = k_S
    K_el_out[..., 5, 5] = k_S
    K_el_out[..., 6, 6] = k_1_1 + k_1_2
    K_el_out[..., 7, 7] = k_2_1 + k_2_2
    K_el_out[..., 8, 8] = k_C
    K_el_out[..., 9, 9] = k_C
    K_g_out = np.zeros((*batch, 10, 10), dtype)
    return M_out, K_el_out, K_g_out


def extended_platform_motion(p, parameters):
    """Jacobian of the absolute motion of the platform centre.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J_p : array, shape (..., 2, 10) [1, m]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15, with the contributions of released joints and the frame.
    0 operations; 0 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    batch, dtype = _batch(x)
    J_p_out = np.zeros((*batch, 2, 10), dtype)
    J_p_out[..., 0, 0] = 1
    J_p_out[..., 0, 8] = 1
    J_p_out[..., 1, 1] = 1
    J_p_out[..., 1, 9] = 1
    return J_p_out


def motor_motion():
    """Jacobian of the angles of the motors, seen at the rotors that they drive.

    Parameters
    ----------

    Returns
    -------
    J_m : array, shape (..., 2, 10) [1]
        d(motor angle)/dq_k.

    Notes
    -----
    The drives that the mechanism declares; a gearbox winds up by psi_j on its output side.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    J_m_out = np.zeros((*batch, 2, 10), dtype)
    J_m_out[..., 0, 2] = 1
    J_m_out[..., 0, 4] = 1
    J_m_out[..., 1, 3] = 1
    J_m_out[..., 1, 5] = 1
    return J_m_out


def joint_stiffness(effects):
    """Stiffnesses of the released joints, to be added to the diagonal of K.

    Infinite for zero compliance (a locked joint).

    Parameters
    ----------
    effects : Effects
        The robot's effects.

    Returns
    -------
    kappa : array, shape (..., 6) [N/m, N m]
        Stiffness of each released coordinate, in order.
    kappa_c : array, shape (..., 6) [N^2/m^2, N^2 m^2]
        Derivatives d(kappa)/d(compliance).

    Notes
    -----
    Energy q^2 / (2 c) of each joint.
    12 operations; 24 with every named value expanded.
    """
    (c_G,) = _entries(effects.gearbox_compliance_compliance, ())
    (c_K,) = _entries(effects.clamp_compliance_compliance, ())
    (c_F,) = _entries(effects.frame_compliance_compliance, ())
    batch, dtype = _batch(c_G, c_K, c_F)
    t1 = 1.0/c_G
    t2 = 1.0/c_K
    t3 = 1.0/c_F
    t4 = -1/c_G**2
    t5 = -1/c_K**2
    t6 = -1/c_F**2
    kappa_out = np.empty((*batch, 6), dtype)
    kappa_out[..., 0] = t1
    kappa_out[..., 1] = t1
    kappa_out[..., 2] = t2
    kappa_out[..., 3] = t2
    kappa_out[..., 4] = t3
    kappa_out[..., 5] = t3
    kappa_c_out = np.empty((*batch, 6), dtype)
    kappa_c_out[..., 0] = t4
    kappa_c_out[..., 1] = t4
    kappa_c_out[..., 2] = t5
    kappa_c_out[..., 3] = t5
    kappa_c_out[..., 4] = t6
    kappa_c_out[..., 5] = t6
    return kappa_out, kappa_c_out


def extended_dissipation(p, parameters, effects):
    """Viscous damping matrix and loss matrix in the base and all released coordinates, with free joints.

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
    C_v : array, shape (..., 10, 10) [N s/m, N s, N m s]
        Viscous damping matrix.
    K_loss : array, shape (..., 10, 10) [N/m, N, N m]
        Imaginary part of the elastic stiffness; the springs of released joints add theirs.

    Notes
    -----
    Dissipation function R = 1/2 sum b v^2, C_v = d2R/dq_dot2; complex stiffnesses k (1 + i eta).
    115 operations; 2244 with every named value expanded.
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
    (eta_B,) = _entries(effects.belt_loss_loss_factor, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (b_D,) = _entries(effects.drive_friction_viscous, ())
    (b_R,) = _entries(effects.rail_friction_viscous, ())
    batch, dtype = _batch(x, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, eta_B, c_T, F_T, b_D,
        b_R)
    t1 = g_1_1*x + g_1_2*y
    l_f_1_1 = l_0_1_1 + t1
    t2 = F_T*c_T + 1
    t3 = c_E*t2
    t4 = a_B_1 + 1
    t5 = k_sp_1*t4*w_b_1
    t6 = t3*t5
    t7 = t2*t5
    k_1_1 = t7/(l_f_1_1 + t6)
    l_f_1_2 = l_0_1_2 - t1
    k_1_2 = t7/(l_f_1_2 + t6)
    t8 = g_2_1*x + g_2_2*y
    l_f_2_1 = l_0_2_1 + t8
    t9 = a_B_2 + 1
    t10 = k_sp_2*t9*w_b_2
    t11 = t10*t3
    t12 = t10*t2
    k_2_1 = t12/(l_f_2_1 + t11)
    l_f_2_2 = l_0_2_2 - t8
    k_2_2 = t12/(l_f_2_2 + t11)
    t13 = g_1_1**2
    t14 = eta_B/t2
    t15 = t14/(k_sp_1*t4*w_b_1)
    t16 = k_1_1**2*l_f_1_1*t15
    t17 = k_1_2**2*l_f_1_2*t15
    t18 = g_2_1**2
    t19 = t14/(k_sp_2*t9*w_b_2)
    t20 = k_2_1**2*l_f_2_1*t19
    t21 = k_2_2**2*l_f_2_2*t19
    t22 = g_1_1*t16
    t23 = g_1_1*t17
    t24 = g_2_1*t20
    t25 = g_2_1*t21
    t26 = g_1_2**2
    t27 = g_2_2**2
    t28 = g_1_2*t16
    t29 = g_1_2*t17
    t30 = g_2_2*t20
    t31 = g_2_2*t21
    t32 = R_p_1**2
    t33 = R_p_2**2
    C_v_out = np.zeros((*batch, 10, 10), dtype)
    C_v_out[..., 0, 0] = b_R
    C_v_out[..., 1, 1] = b_R
    C_v_out[..., 2, 2] = b_D
    C_v_out[..., 2, 4] = C_v_out[..., 4, 2] = b_D
    C_v_out[..., 3, 3] = b_D
    C_v_out[..., 3, 5] = C_v_out[..., 5, 3] = b_D
    C_v_out[..., 4, 4] = b_D
    C_v_out[..., 5, 5] = b_D
    K_loss_out = np.zeros((*batch, 10, 10), dtype)
    K_loss_out[..., 0, 0] = t13*t16 + t13*t17 + t18*t20 + t18*t21
    K_loss_out[..., 0, 1] = K_loss_out[..., 1, 0] = g_1_2*t22 + g_1_2*t23 + g_2_2*t24 + g_2_2*t25
    K_loss_out[..., 0, 2] = K_loss_out[..., 2, 0] = R_p_1*t22 + R_p_1*t23
    K_loss_out[..., 0, 3] = K_loss_out[..., 3, 0] = R_p_2*t24 + R_p_2*t25
    K_loss_out[..., 0, 6] = K_loss_out[..., 6, 0] = t22 + t23
    K_loss_out[..., 0, 7] = K_loss_out[..., 7, 0] = t24 + t25
    K_loss_out[..., 1, 1] = t16*t26 + t17*t26 + t20*t27 + t21*t27
    K_loss_out[..., 1, 2] = K_loss_out[..., 2, 1] = R_p_1*t28 + R_p_1*t29
    K_loss_out[..., 1, 3] = K_loss_out[..., 3, 1] = R_p_2*t30 + R_p_2*t31
    K_loss_out[..., 1, 6] = K_loss_out[..., 6, 1] = t28 + t29
    K_loss_out[..., 1, 7] = K_loss_out[..., 7, 1] = t30 + t31
    K_loss_out[..., 2, 2] = t16*t32 + t17*t32
    K_loss_out[..., 2, 6] = K_loss_out[..., 6, 2] = R_p_1*t16 + R_p_1*t17
    K_loss_out[..., 3, 3] = t20*t33 + t21*t33
    K_loss_out[..., 3, 7] = K_loss_out[..., 7, 3] = R_p_2*t20 + R_p_2*t21
    K_loss_out[..., 6, 6] = t16 + t17
    K_loss_out[..., 7, 7] = t20 + t21
    return C_v_out, K_loss_out


def joint_loss(effects):
    """Loss factors of the springs of the released joints.

    Parameters
    ----------
    effects : Effects
        The robot's effects.

    Returns
    -------
    eta : array, shape (..., 6) [1]
        Loss factor of each released coordinate, in order.

    Notes
    -----
    Complex stiffness k (1 + i eta) of each.
    0 operations; 0 with every named value expanded.
    """
    (eta_G,) = _entries(effects.reducer_loss_loss_factor, ())
    batch, dtype = _batch(eta_G)
    eta_out = np.zeros((*batch, 6), dtype)
    eta_out[..., 0] = eta_G
    eta_out[..., 1] = eta_G
    return eta_out


def extended_static_equilibrium(p, parameters, effects):
    """Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.

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
    tau_st : array, shape (..., 2) [N m]
        Torques on the driven rotors.
    theta_st : array, shape (..., 2) [rad]
        Rotations relative to the unstrained transmissions.

    Notes
    -----
    Equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
    75 operations; 1722 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_g,) = _entries(parameters.gantry_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
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
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(x, m_h, m_g, g_x, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, c_T, F_T,
        m_L)
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
    t11 = m_L + m_h
    G_1 = -g_x*t11
    G_2 = -g_y*(m_g + t11)
    t12 = R_p_1*g_1_1
    t13 = k_1_1*t12 + k_1_2*t12
    t14 = R_p_2*g_2_2
    t15 = k_2_1*t14 + k_2_2*t14
    t16 = R_p_1*g_1_2
    t17 = k_1_1*t16 + k_1_2*t16
    t18 = R_p_2*g_2_1
    t19 = k_2_1*t18 + k_2_2*t18
    det_1 = t13*t15 - t17*t19
    t20 = 1.0/det_1
    theta_1_st = t20*(-G_1*t15 + G_2*t19)
    theta_2_st = t20*(G_1*t17 - G_2*t13)
    t21 = R_p_1**2*theta_1_st
    tau_st_1 = k_1_1*t21 + k_1_2*t21
    t22 = R_p_2**2*theta_2_st
    tau_st_2 = k_2_1*t22 + k_2_2*t22
    tau_st_out = np.empty((*batch, 2), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    theta_st_out = np.empty((*batch, 2), dtype)
    theta_st_out[..., 0] = theta_1_st
    theta_st_out[..., 1] = theta_2_st
    return tau_st_out, theta_st_out


def belt_tension_stiffness_margin(effects):
    """Condition on the parameters of the effect belt_tension_stiffness.

    Parameters
    ----------
    effects : Effects
        The robot's effects.

    Returns
    -------
    margin : array, shape (..., 1) [1]
        Positive for physical parameters.

    Notes
    -----
    The effect's definition.
    2 operations; 2 with every named value expanded.
    """
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    batch, dtype = _batch(c_T, F_T)
    margin_out = np.empty((*batch, 1), dtype)
    margin_out[..., 0] = F_T*c_T + 1
    return margin_out


def value_sensitivities(p, parameters, effects):
    """Derivatives of M and K at a fixed pose with respect to parameters that move no coordinate.

    Returns the upper-triangle entries listed in VALUE_SENSITIVITIES; all others are zero.

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
    M_theta : array, shape (..., 99) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 171) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Chain rule.
    892 operations; 11799 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    g_1_1, g_1_2, g_2_1, g_2_2 = _entries(parameters.belt_path_direction, (2, 2))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.belt_path_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    I_m_1, I_m_2 = _entries(parameters.motor_inertia, (2,))
    i_g_1, i_g_2 = _entries(parameters.gear_ratio, (2,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    batch, dtype = _batch(x, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, I_m_1, i_g_1, a_B_1, a_B_2, c_E, rho_b,
        c_T, F_T)
    t1 = g_1_1*x + g_1_2*y
    l_f_1_1 = l_0_1_1 + t1
    t2 = a_B_1 + 1
    t3 = F_T*c_T + 1
    t4 = t2*t3*w_b_1
    t5 = k_sp_1*t4
    t6 = c_E*t5
    t7 = l_f_1_1 + t6
    t8 = 1.0/t7
    k_1_1 = k_sp_1*t4*t8
    l_f_1_2 = l_0_1_2 - t1
    t9 = l_f_1_2 + t6
    t10 = 1.0/t9
    k_1_2 = k_sp_1*t10*t4
    t11 = g_2_1*x + g_2_2*y
    l_f_2_1 = l_0_2_1 + t11
    t12 = a_B_2 + 1
    t13 = t12*t3*w_b_2
    t14 = k_sp_2*t13
    t15 = c_E*t14
    t16 = l_f_2_1 + t15
    t17 = 1.0/t16
    k_2_1 = k_sp_2*t13*t17
    l_f_2_2 = l_0_2_2 - t11
    t18 = l_f_2_2 + t15
    t19 = 1.0/t18
    k_2_2 = k_sp_2*t13*t19
    t20 = g_1_1**2
    t21 = (1/3)*rho_b
    t22 = t20*t21
    t23 = g_1_1*t21
    t24 = g_1_2*t23
    t25 = (1/6)*rho_b
    t26 = R_p_1*t25
    t27 = -g_1_1*t26
    t28 = g_1_2**2
    t29 = t21*t28
    t30 = -g_1_2*t26
    t31 = g_1_2*t21
    t32 = R_p_1**2
    t33 = t21*t32
    t34 = g_2_1**2
    t35 = t21*t34
    t36 = g_2_1*t21
    t37 = g_2_2*t36
    t38 = R_p_2*t25
    t39 = -g_2_1*t38
    t40 = g_2_2**2
    t41 = t21*t40
    t42 = -g_2_2*t38
    t43 = g_2_2*t21
    t44 = R_p_2**2
    t45 = t21*t44
    t46 = l_f_1_1*t25
    t47 = l_f_1_2*t25
    t48 = (2/3)*rho_b
    t49 = R_p_1*t48
    t50 = l_f_2_1*t25
    t51 = l_f_2_2*t25
    t52 = R_p_2*t48
    t53 = i_g_1**2
    t54 = i_g_2**2
    t55 = 2*I_m_1*i_g_1
    t56 = 2*I_m_2*i_g_2
    t57 = (1/3)*l_f_1_1
    t58 = (1/3)*l_f_1_2
    t59 = (1/3)*l_f_2_1
    t60 = (1/3)*l_f_2_2
    t61 = g_1_1*t57
    t62 = g_1_1*t58
    t63 = g_2_1*t59
    t64 = g_2_1*t60
    t65 = (1/6)*R_p_1
    t66 = l_f_1_1*t65
    t67 = l_f_1_2*t65
    t68 = (1/6)*R_p_2
    t69 = l_f_2_1*t68
    t70 = l_f_2_2*t68
    t71 = 1.0/(t7**2)
    t72 = t5*t71
    t73 = g_1_1*t72
    t74 = g_1_2*t72
    t75 = 1.0/(t9**2)
    t76 = t5*t75
    t77 = g_1_1*t76
    t78 = g_1_2*t76
    t79 = 1.0/(t16**2)
    t80 = t14*t79
    t81 = g_2_1*t80
    t82 = g_2_2*t80
    t83 = 1.0/(t18**2)
    t84 = t14*t83
    t85 = g_2_1*t84
    t86 = g_2_2*t84
    t87 = c_E*t71
    t88 = w_b_1**2
    t89 = t2**2
    t90 = t3**2
    t91 = t88*t89*t90
    t92 = k_sp_1*t91
    t93 = -t2*t3*t8*w_b_1 + t87*t92
    t94 = c_E*t75
    t95 = -t10*t2*t3*w_b_1 + t92*t94
    t96 = -g_1_1*t95
    t97 = -g_1_1*t93
    t98 = -g_1_2*t93
    t99 = -g_1_2*t95
    t100 = c_E*t79
    t101 = w_b_2**2
    t102 = t12**2
    t103 = t101*t102*t90
    t104 = k_sp_2*t103
    t105 = t100*t104 - t12*t17*t3*w_b_2
    t106 = c_E*t83
    t107 = t104*t106 - t12*t19*t3*w_b_2
    t108 = -g_2_1*t105
    t109 = -g_2_1*t107
    t110 = -g_2_2*t105
    t111 = -g_2_2*t107
    t112 = k_sp_1**2
    t113 = t112*t90
    t114 = t113*t87
    t115 = t89*w_b_1
    t116 = -k_sp_1*t2*t3*t8 + t114*t115
    t117 = t113*t94
    t118 = -k_sp_1*t10*t2*t3 + t115*t117
    t119 = -g_1_1*t116
    t120 = -g_1_1*t118
    t121 = -g_1_2*t116
    t122 = -g_1_2*t118
    t123 = k_sp_2**2
    t124 = t123*t90
    t125 = t100*t124
    t126 = t102*w_b_2
    t127 = -k_sp_2*t12*t17*t3 + t125*t126
    t128 = t106*t124
    t129 = -k_sp_2*t12*t19*t3 + t126*t128
    t130 = -g_2_1*t127
    t131 = -g_2_1*t129
    t132 = -g_2_2*t127
    t133 = -g_2_2*t129
    t134 = 2*R_p_1
    t135 = 2*R_p_2
    t136 = t2*t88
    t137 = -k_sp_1*t3*t8*w_b_1 + t114*t136
    t138 = -k_sp_1*t10*t3*w_b_1 + t117*t136
    t139 = -g_1_1*t137
    t140 = -g_1_1*t138
    t141 = -g_1_2*t137
    t142 = -g_1_2*t138
    t143 = t101*t12
    t144 = -k_sp_2*t17*t3*w_b_2 + t125*t143
    t145 = -k_sp_2*t19*t3*w_b_2 + t128*t143
    t146 = -g_2_1*t144
    t147 = -g_2_1*t145
    t148 = -g_2_2*t144
    t149 = -g_2_2*t145
    t150 = t112*t91
    t151 = t150*t71
    t152 = t150*t75
    t153 = t103*t123
    t154 = t153*t79
    t155 = t153*t83
    t156 = g_1_1*t151
    t157 = g_1_1*t152
    t158 = g_2_1*t154
    t159 = g_2_1*t155
    t160 = g_1_2*t151
    t161 = g_1_2*t152
    t162 = g_2_2*t154
    t163 = g_2_2*t155
    t164 = F_T*t3
    t165 = t112*t88*t89
    t166 = t164*t165
    t167 = -F_T*k_sp_1*t2*t8*w_b_1 + t166*t87
    t168 = -F_T*k_sp_1*t10*t2*w_b_1 + t166*t94
    t169 = t101*t102*t123
    t170 = t164*t169
    t171 = -F_T*k_sp_2*t12*t17*w_b_2 + t100*t170
    t172 = -F_T*k_sp_2*t12*t19*w_b_2 + t106*t170
    t173 = -g_1_1*t167
    t174 = -g_1_1*t168
    t175 = -g_2_1*t171
    t176 = -g_2_1*t172
    t177 = -g_1_2*t167
    t178 = -g_1_2*t168
    t179 = -g_2_2*t171
    t180 = -g_2_2*t172
    t181 = c_T*t3
    t182 = t165*t181
    t183 = -c_T*k_sp_1*t2*t8*w_b_1 + t182*t87
    t184 = -c_T*k_sp_1*t10*t2*w_b_1 + t182*t94
    t185 = t169*t181
    t186 = -c_T*k_sp_2*t12*t17*w_b_2 + t100*t185
    t187 = -c_T*k_sp_2*t12*t19*w_b_2 + t106*t185
    t188 = -g_1_1*t183
    t189 = -g_1_1*t184
    t190 = -g_2_1*t186
    t191 = -g_2_1*t187
    t192 = -g_1_2*t183
    t193 = -g_1_2*t184
    t194 = -g_2_2*t186
    t195 = -g_2_2*t187
    M_theta_out = _listed(batch, dtype, (
        1, 1, 1, 1, 1, 1, 1, 1, 1, 1, t22, t24, t27, t23, t29, t30, t31, t33, -t26, t21, t22, t24, t27, t23,
        t29, t30, t31, t33, -t26, t21, t35, t37, t39, t36, t41, t42, t43, t45, -t38, t21, t35, t37, t39, t36,
        t41, t42, t43, t45, -t38, t21, -g_1_1*t46 - g_1_1*t47, -g_1_2*t46 - g_1_2*t47,
        l_f_1_1*t49 + l_f_1_2*t49, -t46 - t47, -g_2_1*t50 - g_2_1*t51, -g_2_2*t50 - g_2_2*t51,
        l_f_2_1*t52 + l_f_2_2*t52, -t50 - t51, 1, 1, t53, t53, t53, t54, t54, t54, t55, t55, t55, t56, t56,
        t56, t20*t57 + t20*t58 + t34*t59 + t34*t60, g_1_2*t61 + g_1_2*t62 + g_2_2*t63 + g_2_2*t64,
        -g_1_1*t66 - g_1_1*t67, -g_2_1*t69 - g_2_1*t70, t61 + t62, t63 + t64,
        t28*t57 + t28*t58 + t40*t59 + t40*t60, -g_1_2*t66 - g_1_2*t67, -g_2_2*t69 - g_2_2*t70,
        g_1_2*t57 + g_1_2*t58, g_2_2*t59 + g_2_2*t60, t32*t57 + t32*t58, -t66 - t67, t44*t59 + t44*t60,
        -t69 - t70, t57 + t58, t59 + t60, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    ))
    K_theta_out = _listed(batch, dtype, (
        -t20*t72, -g_1_2*t73, -R_p_1*t73, -t73, -t28*t72, -R_p_1*t74, -t74, -t32*t72, -R_p_1*t72, -t72,
        -t20*t76, -g_1_2*t77, -R_p_1*t77, -t77, -t28*t76, -R_p_1*t78, -t78, -t32*t76, -R_p_1*t76, -t76,
        -t34*t80, -g_2_2*t81, -R_p_2*t81, -t81, -t40*t80, -R_p_2*t82, -t82, -t44*t80, -R_p_2*t80, -t80,
        -t34*t84, -g_2_2*t85, -R_p_2*t85, -t85, -t40*t84, -R_p_2*t86, -t86, -t44*t84, -R_p_2*t84, -t84,
        -t20*t93 - t20*t95, g_1_2*t96 + g_1_2*t97, R_p_1*t96 + R_p_1*t97, t96 + t97, -t28*t93 - t28*t95,
        R_p_1*t98 + R_p_1*t99, t98 + t99, -t32*t93 - t32*t95, -R_p_1*t93 - R_p_1*t95, -t93 - t95,
        -t105*t34 - t107*t34, g_2_2*t108 + g_2_2*t109, R_p_2*t108 + R_p_2*t109, t108 + t109,
        -t105*t40 - t107*t40, R_p_2*t110 + R_p_2*t111, t110 + t111, -t105*t44 - t107*t44,
        -R_p_2*t105 - R_p_2*t107, -t105 - t107, -t116*t20 - t118*t20, g_1_2*t119 + g_1_2*t120,
        R_p_1*t119 + R_p_1*t120, t119 + t120, -t116*t28 - t118*t28, R_p_1*t121 + R_p_1*t122, t121 + t122,
        -t116*t32 - t118*t32, -R_p_1*t116 - R_p_1*t118, -t116 - t118, -t127*t34 - t129*t34,
        g_2_2*t130 + g_2_2*t131, R_p_2*t130 + R_p_2*t131, t130 + t131, -t127*t40 - t129*t40,
        R_p_2*t132 + R_p_2*t133, t132 + t133, -t127*t44 - t129*t44, -R_p_2*t127 - R_p_2*t129, -t127 - t129,
        g_1_1*k_1_1 + g_1_1*k_1_2, g_1_2*k_1_1 + g_1_2*k_1_2, k_1_1*t134 + k_1_2*t134, k_1_1 + k_1_2,
        g_2_1*k_2_1 + g_2_1*k_2_2, g_2_2*k_2_1 + g_2_2*k_2_2, k_2_1*t135 + k_2_2*t135, k_2_1 + k_2_2,
        -t137*t20 - t138*t20, g_1_2*t139 + g_1_2*t140, R_p_1*t139 + R_p_1*t140, t139 + t140,
        -t137*t28 - t138*t28, R_p_1*t141 + R_p_1*t142, t141 + t142, -t137*t32 - t138*t32,
        -R_p_1*t137 - R_p_1*t138, -t137 - t138, -t144*t34 - t145*t34, g_2_2*t146 + g_2_2*t147,
        R_p_2*t146 + R_p_2*t147, t146 + t147, -t144*t40 - t145*t40, R_p_2*t148 + R_p_2*t149, t148 + t149,
        -t144*t44 - t145*t44, -R_p_2*t144 - R_p_2*t145, -t144 - t145,
        -t151*t20 - t152*t20 - t154*t34 - t155*t34, -g_1_2*t156 - g_1_2*t157 - g_2_2*t158 - g_2_2*t159,
        -R_p_1*t156 - R_p_1*t157, -R_p_2*t158 - R_p_2*t159, -t156 - t157, -t158 - t159,
        -t151*t28 - t152*t28 - t154*t40 - t155*t40, -R_p_1*t160 - R_p_1*t161, -R_p_2*t162 - R_p_2*t163,
        -t160 - t161, -t162 - t163, -t151*t32 - t152*t32, -R_p_1*t151 - R_p_1*t152, -t154*t44 - t155*t44,
        -R_p_2*t154 - R_p_2*t155, -t151 - t152, -t154 - t155, -t167*t20 - t168*t20 - t171*t34 - t172*t34,
        g_1_2*t173 + g_1_2*t174 + g_2_2*t175 + g_2_2*t176, R_p_1*t173 + R_p_1*t174, R_p_2*t175 + R_p_2*t176,
        t173 + t174, t175 + t176, -t167*t28 - t168*t28 - t171*t40 - t172*t40, R_p_1*t177 + R_p_1*t178,
        R_p_2*t179 + R_p_2*t180, t177 + t178, t179 + t180, -t167*t32 - t168*t32, -R_p_1*t167 - R_p_1*t168,
        -t171*t44 - t172*t44, -R_p_2*t171 - R_p_2*t172, -t167 - t168, -t171 - t172,
        -t183*t20 - t184*t20 - t186*t34 - t187*t34, g_1_2*t188 + g_1_2*t189 + g_2_2*t190 + g_2_2*t191,
        R_p_1*t188 + R_p_1*t189, R_p_2*t190 + R_p_2*t191, t188 + t189, t190 + t191,
        -t183*t28 - t184*t28 - t186*t40 - t187*t40, R_p_1*t192 + R_p_1*t193, R_p_2*t194 + R_p_2*t195,
        t192 + t193, t194 + t195, -t183*t32 - t184*t32, -R_p_1*t183 - R_p_1*t184, -t186*t44 - t187*t44,
        -R_p_2*t186 - R_p_2*t187, -t183 - t184, -t186 - t187, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    ))
    return M_theta_out, K_theta_out


def geometry_sensitivities(p, parameters):
    """Derivatives of M and K at a fixed pose with respect to parameters that move the positions.

    Returns the upper-triangle entries listed in GEOMETRY_SENSITIVITIES; all others are zero.

    Parameters
    ----------
    p : array, shape (..., 2) [m]
        Tool head in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    M_theta : array, shape (..., 0) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 0) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Implicit function theorem and chain rule.
    0 operations; 0 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    batch, dtype = _batch(x)
    M_theta_out = _listed(batch, dtype, (
    ))
    K_theta_out = _listed(batch, dtype, (
    ))
    return M_theta_out, K_theta_out
