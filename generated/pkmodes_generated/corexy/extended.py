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
* b [m]: distance of what slides along the beam from the beam's middle
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
    "gantry_racking_margin",
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

#: Parameters of the derivatives: field of Parameters or Effects, index in it, and (row, column) of the
#: entries of M and of K, in the upper triangle, that depend on it.
VALUE_SENSITIVITIES = (
    ('toolhead_mass', (), ((0, 0), (0, 8), (1, 1), (1, 9), (1, 10), (8, 8), (9, 9), (9, 10), (10, 10)),
     ((0, 10),)),
    ('gantry_mass', (), ((1, 1), (1, 9), (8, 8), (9, 9)), ()),
    ('gravity', (0,), (), ()),
    ('gravity', (1,), (), ((0, 10),)),
    ('gravity', (2,), (), ()),
    ('belt_path_lengths', (0, 0),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 10), (1, 1), (1, 2), (1, 6), (1, 10), (2, 2), (2, 6), (2, 10),
      (6, 6), (6, 10), (10, 10)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 10), (1, 1), (1, 2), (1, 6), (1, 10), (2, 2), (2, 6), (2, 10),
      (6, 6), (6, 10), (10, 10))),
    ('belt_path_lengths', (0, 1),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 10), (1, 1), (1, 2), (1, 6), (1, 10), (2, 2), (2, 6), (2, 10),
      (6, 6), (6, 10), (10, 10)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 10), (1, 1), (1, 2), (1, 6), (1, 10), (2, 2), (2, 6), (2, 10),
      (6, 6), (6, 10), (10, 10))),
    ('belt_path_lengths', (1, 0),
     ((0, 0), (0, 1), (0, 3), (0, 7), (0, 10), (1, 1), (1, 3), (1, 7), (1, 10), (3, 3), (3, 7), (3, 10),
      (7, 7), (7, 10), (10, 10)),
     ((0, 0), (0, 1), (0, 3), (0, 7), (0, 10), (1, 1), (1, 3), (1, 7), (1, 10), (3, 3), (3, 7), (3, 10),
      (7, 7), (7, 10), (10, 10))),
    ('belt_path_lengths', (1, 1),
     ((0, 0), (0, 1), (0, 3), (0, 7), (0, 10), (1, 1), (1, 3), (1, 7), (1, 10), (3, 3), (3, 7), (3, 10),
      (7, 7), (7, 10), (10, 10)),
     ((0, 0), (0, 1), (0, 3), (0, 7), (0, 10), (1, 1), (1, 3), (1, 7), (1, 10), (3, 3), (3, 7), (3, 10),
      (7, 7), (7, 10), (10, 10))),
    ('belt_specific_stiffness', (0,), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 10), (1, 1), (1, 2), (1, 6), (1, 10), (2, 2), (2, 6), (2, 10),
      (6, 6), (6, 10), (10, 10))),
    ('belt_specific_stiffness', (1,), (),
     ((0, 0), (0, 1), (0, 3), (0, 7), (0, 10), (1, 1), (1, 3), (1, 7), (1, 10), (3, 3), (3, 7), (3, 10),
      (7, 7), (7, 10), (10, 10))),
    ('belt_width', (0,), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 10), (1, 1), (1, 2), (1, 6), (1, 10), (2, 2), (2, 6), (2, 10),
      (6, 6), (6, 10), (10, 10))),
    ('belt_width', (1,), (),
     ((0, 0), (0, 1), (0, 3), (0, 7), (0, 10), (1, 1), (1, 3), (1, 7), (1, 10), (3, 3), (3, 7), (3, 10),
      (7, 7), (7, 10), (10, 10))),
    ('pulley_radius', (0,), ((0, 2), (1, 2), (2, 2), (2, 6), (2, 10)),
     ((0, 2), (1, 2), (2, 2), (2, 6), (2, 10))),
    ('pulley_radius', (1,), ((0, 3), (1, 3), (3, 3), (3, 7), (3, 10)),
     ((0, 3), (1, 3), (3, 3), (3, 7), (3, 10))),
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
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 10), (1, 1), (1, 2), (1, 6), (1, 10), (2, 2), (2, 6), (2, 10),
      (6, 6), (6, 10), (10, 10))),
    ('axis_belt_stiffness_factor_2', (), (),
     ((0, 0), (0, 1), (0, 3), (0, 7), (0, 10), (1, 1), (1, 3), (1, 7), (1, 10), (3, 3), (3, 7), (3, 10),
      (7, 7), (7, 10), (10, 10))),
    ('belt_end_compliance_compliance', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (0, 10), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7),
      (1, 10), (2, 2), (2, 6), (2, 10), (3, 3), (3, 7), (3, 10), (6, 6), (6, 10), (7, 7), (7, 10),
      (10, 10))),
    ('belt_loss_loss_factor', (), (), ()),
    ('belt_mass_linear_density', (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (0, 10), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7),
      (1, 10), (2, 2), (2, 6), (2, 10), (3, 3), (3, 7), (3, 10), (6, 6), (6, 10), (7, 7), (7, 10),
      (10, 10)),
     ()),
    ('belt_tension_stiffness_coefficient', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (0, 10), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7),
      (1, 10), (2, 2), (2, 6), (2, 10), (3, 3), (3, 7), (3, 10), (6, 6), (6, 10), (7, 7), (7, 10),
      (10, 10))),
    ('belt_tension_stiffness_tension', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 7), (0, 10), (1, 1), (1, 2), (1, 3), (1, 6), (1, 7),
      (1, 10), (2, 2), (2, 6), (2, 10), (3, 3), (3, 7), (3, 10), (6, 6), (6, 10), (7, 7), (7, 10),
      (10, 10))),
    ('cable_stiffness_stiffness', (), (),
     ((0, 0), (0, 8), (1, 1), (1, 9), (1, 10), (8, 8), (9, 9), (9, 10), (10, 10))),
    ('drive_friction_viscous', (), (), ()),
    ('gearbox_inertia_inertia', (), ((2, 2), (3, 3)), ()),
    ('payload_mass', (), ((0, 0), (0, 8), (1, 1), (1, 9), (1, 10), (8, 8), (9, 9), (9, 10), (10, 10)),
     ((0, 10),)),
    ('rail_friction_viscous', (), (), ()),
    ('reducer_loss_loss_factor', (), (), ()),
    ('servo_stiffness_stiffness', (), (), ((2, 2), (2, 4), (3, 3), (3, 5), (4, 4), (5, 5))),
    ('frame_compliance_mass', (), ((8, 8), (9, 9)), ()),
    ('gantry_racking_inertia', (), ((10, 10),), ()),
    ('gantry_racking_center', (),
     ((0, 10), (1, 10), (2, 10), (3, 10), (6, 10), (7, 10), (9, 10), (10, 10)),
     ((0, 10), (1, 10), (2, 10), (3, 10), (6, 10), (7, 10), (9, 10), (10, 10))),
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
    frame_compliance_compliance_x : float or array, shape (...) [m/N]
        Compliance of the frame along x.
    frame_compliance_compliance_y : float or array, shape (...) [m/N]
        Compliance of the frame along y.
    gantry_racking_compliance : float or array, shape (...) [rad/(N m)]
        Compliance of the beam's guides in rotation.
    gantry_racking_inertia : float or array, shape (...) [kg m^2]
        Moment of inertia of the beam about its middle.
    gantry_racking_center : float or array, shape (...) [m]
        Position of the beam's middle along it.
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
    frame_compliance_compliance_x: float = 0.0
    frame_compliance_compliance_y: float = 0.0
    gantry_racking_compliance: float = 0.0
    gantry_racking_inertia: float = 0.0
    gantry_racking_center: float = 0.0


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
    M : array, shape (..., 11, 11) [kg, kg m, kg m^2]
        Mass matrix; its leading block is that of the base model.
    K_el : array, shape (..., 11, 11) [N/m, N, N m]
        Elastic stiffness with free joints.
    K_g : array, shape (..., 11, 11) [N/m, N, N m]
        Hessian of the gravitational potential energy.

    Notes
    -----
    Equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses.
    273 operations; 3192 with every named value expanded.
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
    (J_B,) = _entries(effects.gantry_racking_inertia, ())
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, m_h, m_g, g_x, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, I_p_1, I_m_1, i_g_1, a_B_1,
        a_B_2, c_E, rho_b, c_T, F_T, k_C, I_G, m_L, k_S, m_F, J_B, x_B)
    b = x - x_B
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
    t22 = g_1_2*t21
    t23 = g_1_1*t16
    t24 = g_1_2*t23
    t25 = g_2_1*t18
    t26 = g_2_2*t25
    t27 = g_2_1*t19
    t28 = g_2_2*t27
    t29 = (1/6)*rho_b
    t30 = R_p_1*t29
    t31 = l_f_1_1*t30
    t32 = l_f_1_2*t30
    t33 = R_p_2*t29
    t34 = l_f_2_1*t33
    t35 = l_f_2_2*t33
    t36 = g_1_2**2
    t37 = t15*t36
    t38 = t16*t36
    t39 = g_2_2**2
    t40 = t18*t39
    t41 = t19*t39
    t42 = m_g + t20
    t43 = g_1_2*t31
    t44 = g_1_2*t32
    t45 = g_2_2*t34
    t46 = g_2_2*t35
    t47 = g_1_2*t15
    t48 = g_1_2*t16
    t49 = g_2_2*t18
    t50 = g_2_2*t19
    t51 = b*t20
    t52 = R_p_1**2
    t53 = R_p_2**2
    t54 = m_F + t42
    t55 = b**2
    t56 = g_1_1*k_1_1
    t57 = g_1_2*t56
    t58 = g_1_1*k_1_2
    t59 = g_1_2*t58
    t60 = g_2_1*k_2_1
    t61 = g_2_2*t60
    t62 = g_2_1*k_2_2
    t63 = g_2_2*t62
    t64 = k_1_1*t36
    t65 = k_1_2*t36
    t66 = k_2_1*t39
    t67 = k_2_2*t39
    t68 = g_1_2*k_1_1
    t69 = R_p_1*t68
    t70 = g_1_2*k_1_2
    t71 = R_p_1*t70
    t72 = g_2_2*k_2_1
    t73 = R_p_2*t72
    t74 = g_2_2*k_2_2
    t75 = R_p_2*t74
    t76 = b*k_C
    M_out = np.zeros((*batch, 11, 11), dtype)
    M_out[..., 0, 0] = t13*t15 + t13*t16 + t17*t18 + t17*t19 + t20
    M_out[..., 0, 1] = M_out[..., 1, 0] = t22 + t24 + t26 + t28
    M_out[..., 0, 2] = M_out[..., 2, 0] = -g_1_1*t31 - g_1_1*t32
    M_out[..., 0, 3] = M_out[..., 3, 0] = -g_2_1*t34 - g_2_1*t35
    M_out[..., 0, 6] = M_out[..., 6, 0] = t21 + t23
    M_out[..., 0, 7] = M_out[..., 7, 0] = t25 + t27
    M_out[..., 0, 8] = M_out[..., 8, 0] = t20
    M_out[..., 0, 10] = M_out[..., 10, 0] = b*t22 + b*t24 + b*t26 + b*t28
    M_out[..., 1, 1] = t37 + t38 + t40 + t41 + t42
    M_out[..., 1, 2] = M_out[..., 2, 1] = -t43 - t44
    M_out[..., 1, 3] = M_out[..., 3, 1] = -t45 - t46
    M_out[..., 1, 6] = M_out[..., 6, 1] = t47 + t48
    M_out[..., 1, 7] = M_out[..., 7, 1] = t49 + t50
    M_out[..., 1, 9] = M_out[..., 9, 1] = t42
    M_out[..., 1, 10] = M_out[..., 10, 1] = b*t37 + b*t38 + b*t40 + b*t41 + t51
    M_out[..., 2, 2] = I_1 + t15*t52 + t16*t52
    M_out[..., 2, 4] = M_out[..., 4, 2] = t1
    M_out[..., 2, 6] = M_out[..., 6, 2] = -t31 - t32
    M_out[..., 2, 10] = M_out[..., 10, 2] = -b*t43 - b*t44
    M_out[..., 3, 3] = I_2 + t18*t53 + t19*t53
    M_out[..., 3, 5] = M_out[..., 5, 3] = t2
    M_out[..., 3, 7] = M_out[..., 7, 3] = -t34 - t35
    M_out[..., 3, 10] = M_out[..., 10, 3] = -b*t45 - b*t46
    M_out[..., 4, 4] = t1
    M_out[..., 5, 5] = t2
    M_out[..., 6, 6] = t15 + t16
    M_out[..., 6, 10] = M_out[..., 10, 6] = b*t47 + b*t48
    M_out[..., 7, 7] = t18 + t19
    M_out[..., 7, 10] = M_out[..., 10, 7] = b*t49 + b*t50
    M_out[..., 8, 8] = t54
    M_out[..., 9, 9] = t54
    M_out[..., 9, 10] = M_out[..., 10, 9] = t51
    M_out[..., 10, 10] = J_B + t37*t55 + t38*t55 + t40*t55 + t41*t55 + 2*t55*((1/2)*m_L + (1/2)*m_h)
    K_el_out = np.zeros((*batch, 11, 11), dtype)
    K_el_out[..., 0, 0] = k_1_1*t13 + k_1_2*t13 + k_2_1*t17 + k_2_2*t17 + k_C
    K_el_out[..., 0, 1] = K_el_out[..., 1, 0] = t57 + t59 + t61 + t63
    K_el_out[..., 0, 2] = K_el_out[..., 2, 0] = R_p_1*t56 + R_p_1*t58
    K_el_out[..., 0, 3] = K_el_out[..., 3, 0] = R_p_2*t60 + R_p_2*t62
    K_el_out[..., 0, 6] = K_el_out[..., 6, 0] = t56 + t58
    K_el_out[..., 0, 7] = K_el_out[..., 7, 0] = t60 + t62
    K_el_out[..., 0, 8] = K_el_out[..., 8, 0] = k_C
    K_el_out[..., 0, 10] = K_el_out[..., 10, 0] = b*t57 + b*t59 + b*t61 + b*t63
    K_el_out[..., 1, 1] = k_C + t64 + t65 + t66 + t67
    K_el_out[..., 1, 2] = K_el_out[..., 2, 1] = t69 + t71
    K_el_out[..., 1, 3] = K_el_out[..., 3, 1] = t73 + t75
    K_el_out[..., 1, 6] = K_el_out[..., 6, 1] = t68 + t70
    K_el_out[..., 1, 7] = K_el_out[..., 7, 1] = t72 + t74
    K_el_out[..., 1, 9] = K_el_out[..., 9, 1] = k_C
    K_el_out[..., 1, 10] = K_el_out[..., 10, 1] = b*t64 + b*t65 + b*t66 + b*t67 + t76
    K_el_out[..., 2, 2] = k_1_1*t52 + k_1_2*t52 + k_S
    K_el_out[..., 2, 4] = K_el_out[..., 4, 2] = k_S
    K_el_out[..., 2, 6] = K_el_out[..., 6, 2] = R_p_1*k_1_1 + R_p_1*k_1_2
    K_el_out[..., 2, 10] = K_el_out[..., 10, 2] = b*t69 + b*t71
    K_el_out[..., 3, 3] = k_2_1*t53 + k_2_2*t53 + k_S
    K_el_out[..., 3, 5] = K_el_out[..., 5, 3] = k_S
    K_el_out[..., 3, 7] = K_el_out[..., 7, 3] = R_p_2*k_2_1 + R_p_2*k_2_2
    K_el_out[..., 3, 10] = K_el_out[..., 10, 3] = b*t73 + b*t75
    K_el_out[..., 4, 4] = k_S
    K_el_out[..., 5, 5] = k_S
    K_el_out[..., 6, 6] = k_1_1 + k_1_2
    K_el_out[..., 6, 10] = K_el_out[..., 10, 6] = b*t68 + b*t70
    K_el_out[..., 7, 7] = k_2_1 + k_2_2
    K_el_out[..., 7, 10] = K_el_out[..., 10, 7] = b*t72 + b*t74
    K_el_out[..., 8, 8] = k_C
    K_el_out[..., 9, 9] = k_C
    K_el_out[..., 9, 10] = K_el_out[..., 10, 9] = t76
    K_el_out[..., 10, 10] = k_C*t55 + t55*t64 + t55*t65 + t55*t66 + t55*t67
    K_g_out = np.zeros((*batch, 11, 11), dtype)
    K_g_out[..., 0, 10] = K_g_out[..., 10, 0] = -g_y*t20
    return M_out, K_el_out, K_g_out


def extended_platform_motion(p, parameters, effects):
    """Jacobian of the absolute motion of the platform centre.

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
    J_p : array, shape (..., 2, 11) [1, m]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15, with the contributions of released joints and the frame.
    1 operations; 1 with every named value expanded.
    """
    x, _ = _entries(p, (2,))
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, x_B)
    b = x - x_B
    J_p_out = np.zeros((*batch, 2, 11), dtype)
    J_p_out[..., 0, 0] = 1
    J_p_out[..., 0, 8] = 1
    J_p_out[..., 1, 1] = 1
    J_p_out[..., 1, 9] = 1
    J_p_out[..., 1, 10] = b
    return J_p_out


def motor_motion():
    """Jacobian of the angles of the motors, seen at the rotors that they drive.

    Parameters
    ----------

    Returns
    -------
    J_m : array, shape (..., 2, 11) [1]
        d(motor angle)/dq_k.

    Notes
    -----
    The drives that the mechanism declares; a gearbox winds up by psi_j on its output side.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    J_m_out = np.zeros((*batch, 2, 11), dtype)
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
    kappa : array, shape (..., 7) [N/m, N m]
        Stiffness of each released coordinate, in order.
    kappa_c : array, shape (..., 7) [N^2/m^2, N^2 m^2]
        Derivatives d(kappa)/d(compliance).

    Notes
    -----
    Energy q^2 / (2 c) of each joint.
    22 operations; 32 with every named value expanded.
    """
    (c_G,) = _entries(effects.gearbox_compliance_compliance, ())
    (c_K,) = _entries(effects.clamp_compliance_compliance, ())
    (c_F,) = _entries(effects.frame_compliance_compliance, ())
    (c_F_x,) = _entries(effects.frame_compliance_compliance_x, ())
    (c_F_y,) = _entries(effects.frame_compliance_compliance_y, ())
    (c_B,) = _entries(effects.gantry_racking_compliance, ())
    batch, dtype = _batch(c_G, c_K, c_F, c_F_x, c_F_y, c_B)
    t1 = 1.0/c_G
    t2 = 1.0/c_K
    t3 = c_F + c_F_x
    t4 = c_F + c_F_y
    t5 = -1/c_G**2
    t6 = -1/c_K**2
    kappa_out = np.empty((*batch, 7), dtype)
    kappa_out[..., 0] = t1
    kappa_out[..., 1] = t1
    kappa_out[..., 2] = t2
    kappa_out[..., 3] = t2
    kappa_out[..., 4] = 1.0/t3
    kappa_out[..., 5] = 1.0/t4
    kappa_out[..., 6] = 1.0/c_B
    kappa_c_out = np.empty((*batch, 7), dtype)
    kappa_c_out[..., 0] = t5
    kappa_c_out[..., 1] = t5
    kappa_c_out[..., 2] = t6
    kappa_c_out[..., 3] = t6
    kappa_c_out[..., 4] = -1/t3**2
    kappa_c_out[..., 5] = -1/t4**2
    kappa_c_out[..., 6] = -1/c_B**2
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
    C_v : array, shape (..., 11, 11) [N s/m, N s, N m s]
        Viscous damping matrix.
    K_loss : array, shape (..., 11, 11) [N/m, N, N m]
        Imaginary part of the elastic stiffness; the springs of released joints add theirs.

    Notes
    -----
    Dissipation function R = 1/2 sum b v^2, C_v = d2R/dq_dot2; complex stiffnesses k (1 + i eta).
    150 operations; 3595 with every named value expanded.
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
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, eta_B, c_T, F_T, b_D,
        b_R, x_B)
    b = x - x_B
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
    t23 = g_1_2*t22
    t24 = g_1_1*t17
    t25 = g_1_2*t24
    t26 = g_2_1*t20
    t27 = g_2_2*t26
    t28 = g_2_1*t21
    t29 = g_2_2*t28
    t30 = g_1_2**2
    t31 = t16*t30
    t32 = t17*t30
    t33 = g_2_2**2
    t34 = t20*t33
    t35 = t21*t33
    t36 = g_1_2*t16
    t37 = R_p_1*t36
    t38 = g_1_2*t17
    t39 = R_p_1*t38
    t40 = g_2_2*t20
    t41 = R_p_2*t40
    t42 = g_2_2*t21
    t43 = R_p_2*t42
    t44 = R_p_1**2
    t45 = R_p_2**2
    t46 = b**2
    C_v_out = np.zeros((*batch, 11, 11), dtype)
    C_v_out[..., 0, 0] = b_R
    C_v_out[..., 1, 1] = b_R
    C_v_out[..., 2, 2] = b_D
    C_v_out[..., 2, 4] = C_v_out[..., 4, 2] = b_D
    C_v_out[..., 3, 3] = b_D
    C_v_out[..., 3, 5] = C_v_out[..., 5, 3] = b_D
    C_v_out[..., 4, 4] = b_D
    C_v_out[..., 5, 5] = b_D
    K_loss_out = np.zeros((*batch, 11, 11), dtype)
    K_loss_out[..., 0, 0] = t13*t16 + t13*t17 + t18*t20 + t18*t21
    K_loss_out[..., 0, 1] = K_loss_out[..., 1, 0] = t23 + t25 + t27 + t29
    K_loss_out[..., 0, 2] = K_loss_out[..., 2, 0] = R_p_1*t22 + R_p_1*t24
    K_loss_out[..., 0, 3] = K_loss_out[..., 3, 0] = R_p_2*t26 + R_p_2*t28
    K_loss_out[..., 0, 6] = K_loss_out[..., 6, 0] = t22 + t24
    K_loss_out[..., 0, 7] = K_loss_out[..., 7, 0] = t26 + t28
    K_loss_out[..., 0, 10] = K_loss_out[..., 10, 0] = b*t23 + b*t25 + b*t27 + b*t29
    K_loss_out[..., 1, 1] = t31 + t32 + t34 + t35
    K_loss_out[..., 1, 2] = K_loss_out[..., 2, 1] = t37 + t39
    K_loss_out[..., 1, 3] = K_loss_out[..., 3, 1] = t41 + t43
    K_loss_out[..., 1, 6] = K_loss_out[..., 6, 1] = t36 + t38
    K_loss_out[..., 1, 7] = K_loss_out[..., 7, 1] = t40 + t42
    K_loss_out[..., 1, 10] = K_loss_out[..., 10, 1] = b*t31 + b*t32 + b*t34 + b*t35
    K_loss_out[..., 2, 2] = t16*t44 + t17*t44
    K_loss_out[..., 2, 6] = K_loss_out[..., 6, 2] = R_p_1*t16 + R_p_1*t17
    K_loss_out[..., 2, 10] = K_loss_out[..., 10, 2] = b*t37 + b*t39
    K_loss_out[..., 3, 3] = t20*t45 + t21*t45
    K_loss_out[..., 3, 7] = K_loss_out[..., 7, 3] = R_p_2*t20 + R_p_2*t21
    K_loss_out[..., 3, 10] = K_loss_out[..., 10, 3] = b*t41 + b*t43
    K_loss_out[..., 6, 6] = t16 + t17
    K_loss_out[..., 6, 10] = K_loss_out[..., 10, 6] = b*t36 + b*t38
    K_loss_out[..., 7, 7] = t20 + t21
    K_loss_out[..., 7, 10] = K_loss_out[..., 10, 7] = b*t40 + b*t42
    K_loss_out[..., 10, 10] = t31*t46 + t32*t46 + t34*t46 + t35*t46
    return C_v_out, K_loss_out


def joint_loss(effects):
    """Loss factors of the springs of the released joints.

    Parameters
    ----------
    effects : Effects
        The robot's effects.

    Returns
    -------
    eta : array, shape (..., 7) [1]
        Loss factor of each released coordinate, in order.

    Notes
    -----
    Complex stiffness k (1 + i eta) of each.
    0 operations; 0 with every named value expanded.
    """
    (eta_G,) = _entries(effects.reducer_loss_loss_factor, ())
    batch, dtype = _batch(eta_G)
    eta_out = np.zeros((*batch, 7), dtype)
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
        Torques on the driven rotors, positive in the direction of their rotation.
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


def gantry_racking_margin(effects):
    """Condition on the parameters of the effect gantry_racking.

    Parameters
    ----------
    effects : Effects
        The robot's effects.

    Returns
    -------
    margin : array, shape (..., 1) [kg m^2]
        Positive for physical parameters.

    Notes
    -----
    The effect's definition.
    0 operations; 0 with every named value expanded.
    """
    (J_B,) = _entries(effects.gantry_racking_inertia, ())
    batch, dtype = _batch(J_B)
    margin_out = np.empty((*batch, 1), dtype)
    margin_out[..., 0] = J_B
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
    M_theta : array, shape (..., 143) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 258) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Chain rule.
    1297 operations; 18711 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
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
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    (x_B,) = _entries(effects.gantry_racking_center, ())
    batch, dtype = _batch(x, m_h, g_x, g_1_1, l_0_1_1, k_sp_1, w_b_1, R_p_1, I_m_1, i_g_1, a_B_1, a_B_2, c_E,
        rho_b, c_T, F_T, k_C, m_L, x_B)
    b = x - x_B
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
    t20 = b**2
    t21 = g_1_1**2
    t22 = (1/3)*rho_b
    t23 = t21*t22
    t24 = g_1_1*t22
    t25 = g_1_2*t24
    t26 = (1/6)*rho_b
    t27 = R_p_1*t26
    t28 = -g_1_1*t27
    t29 = b*t25
    t30 = g_1_2**2
    t31 = t22*t30
    t32 = g_1_2*t27
    t33 = g_1_2*t22
    t34 = b*t31
    t35 = R_p_1**2
    t36 = t22*t35
    t37 = -b*t32
    t38 = b*t33
    t39 = t20*t31
    t40 = g_2_1**2
    t41 = t22*t40
    t42 = g_2_1*t22
    t43 = g_2_2*t42
    t44 = R_p_2*t26
    t45 = -g_2_1*t44
    t46 = b*t43
    t47 = g_2_2**2
    t48 = t22*t47
    t49 = g_2_2*t44
    t50 = g_2_2*t22
    t51 = b*t48
    t52 = R_p_2**2
    t53 = t22*t52
    t54 = -b*t49
    t55 = b*t50
    t56 = t20*t48
    t57 = l_f_1_1*t26
    t58 = l_f_1_2*t26
    t59 = g_1_2*t57
    t60 = g_1_2*t58
    t61 = (2/3)*rho_b
    t62 = R_p_1*t61
    t63 = l_f_2_1*t26
    t64 = l_f_2_2*t26
    t65 = g_2_2*t63
    t66 = g_2_2*t64
    t67 = R_p_2*t61
    t68 = i_g_1**2
    t69 = i_g_2**2
    t70 = 2*I_m_1*i_g_1
    t71 = 2*I_m_2*i_g_2
    t72 = (1/3)*l_f_1_1
    t73 = (1/3)*l_f_1_2
    t74 = (1/3)*l_f_2_1
    t75 = (1/3)*l_f_2_2
    t76 = g_1_1*t72
    t77 = g_1_2*t76
    t78 = g_1_1*t73
    t79 = g_1_2*t78
    t80 = g_2_1*t74
    t81 = g_2_2*t80
    t82 = g_2_1*t75
    t83 = g_2_2*t82
    t84 = (1/6)*R_p_1
    t85 = l_f_1_1*t84
    t86 = l_f_1_2*t84
    t87 = (1/6)*R_p_2
    t88 = l_f_2_1*t87
    t89 = l_f_2_2*t87
    t90 = t30*t72
    t91 = t30*t73
    t92 = t47*t74
    t93 = t47*t75
    t94 = g_1_2*t85
    t95 = g_1_2*t86
    t96 = g_2_2*t89
    t97 = g_2_2*t88
    t98 = g_1_2*t72
    t99 = g_1_2*t73
    t100 = g_2_2*t74
    t101 = g_2_2*t75
    t102 = m_L + m_h
    t103 = b*t61
    t104 = t103*t30
    t105 = t103*t47
    t106 = 1.0/(t7**2)
    t107 = t106*t5
    t108 = g_1_1*t107
    t109 = g_1_2*t108
    t110 = t107*t30
    t111 = g_1_2*t107
    t112 = R_p_1*t111
    t113 = 1.0/(t9**2)
    t114 = t113*t5
    t115 = g_1_1*t114
    t116 = g_1_2*t115
    t117 = t114*t30
    t118 = g_1_2*t114
    t119 = R_p_1*t118
    t120 = 1.0/(t16**2)
    t121 = t120*t14
    t122 = g_2_1*t121
    t123 = g_2_2*t122
    t124 = t121*t47
    t125 = g_2_2*t121
    t126 = R_p_2*t125
    t127 = 1.0/(t18**2)
    t128 = t127*t14
    t129 = g_2_1*t128
    t130 = g_2_2*t129
    t131 = t128*t47
    t132 = g_2_2*t128
    t133 = R_p_2*t132
    t134 = c_E*t106
    t135 = w_b_1**2
    t136 = t2**2
    t137 = t3**2
    t138 = t135*t136*t137
    t139 = k_sp_1*t138
    t140 = t134*t139 - t2*t3*t8*w_b_1
    t141 = c_E*t113
    t142 = -t10*t2*t3*w_b_1 + t139*t141
    t143 = -g_1_1*t140
    t144 = g_1_2*t143
    t145 = -g_1_1*t142
    t146 = g_1_2*t145
    t147 = -t140*t30
    t148 = -t142*t30
    t149 = -g_1_2*t140
    t150 = R_p_1*t149
    t151 = -g_1_2*t142
    t152 = R_p_1*t151
    t153 = c_E*t120
    t154 = w_b_2**2
    t155 = t12**2
    t156 = t137*t154*t155
    t157 = k_sp_2*t156
    t158 = -t12*t17*t3*w_b_2 + t153*t157
    t159 = c_E*t127
    t160 = -t12*t19*t3*w_b_2 + t157*t159
    t161 = -g_2_1*t158
    t162 = g_2_2*t161
    t163 = -g_2_1*t160
    t164 = g_2_2*t163
    t165 = -t158*t47
    t166 = -t160*t47
    t167 = -g_2_2*t158
    t168 = R_p_2*t167
    t169 = -g_2_2*t160
    t170 = R_p_2*t169
    t171 = k_sp_1**2
    t172 = t137*t171
    t173 = t134*t172
    t174 = t136*w_b_1
    t175 = -k_sp_1*t2*t3*t8 + t173*t174
    t176 = t141*t172
    t177 = -k_sp_1*t10*t2*t3 + t174*t176
    t178 = -g_1_1*t175
    t179 = g_1_2*t178
    t180 = -g_1_1*t177
    t181 = g_1_2*t180
    t182 = -t175*t30
    t183 = -t177*t30
    t184 = -g_1_2*t175
    t185 = R_p_1*t184
    t186 = -g_1_2*t177
    t187 = R_p_1*t186
    t188 = k_sp_2**2
    t189 = t137*t188
    t190 = t153*t189
    t191 = t155*w_b_2
    t192 = -k_sp_2*t12*t17*t3 + t190*t191
    t193 = t159*t189
    t194 = -k_sp_2*t12*t19*t3 + t191*t193
    t195 = -g_2_1*t192
    t196 = g_2_2*t195
    t197 = -g_2_1*t194
    t198 = g_2_2*t197
    t199 = -t192*t47
    t200 = -t194*t47
    t201 = -g_2_2*t192
    t202 = R_p_2*t201
    t203 = -g_2_2*t194
    t204 = R_p_2*t203
    t205 = g_1_1*k_1_1
    t206 = g_1_1*k_1_2
    t207 = g_1_2*k_1_1
    t208 = g_1_2*k_1_2
    t209 = t207 + t208
    t210 = 2*R_p_1
    t211 = g_2_1*k_2_1
    t212 = g_2_1*k_2_2
    t213 = g_2_2*k_2_1
    t214 = g_2_2*k_2_2
    t215 = t213 + t214
    t216 = 2*R_p_2
    t217 = t135*t2
    t218 = -k_sp_1*t3*t8*w_b_1 + t173*t217
    t219 = -k_sp_1*t10*t3*w_b_1 + t176*t217
    t220 = -g_1_1*t218
    t221 = g_1_2*t220
    t222 = -g_1_1*t219
    t223 = g_1_2*t222
    t224 = -t218*t30
    t225 = -t219*t30
    t226 = -g_1_2*t218
    t227 = R_p_1*t226
    t228 = -g_1_2*t219
    t229 = R_p_1*t228
    t230 = t12*t154
    t231 = -k_sp_2*t17*t3*w_b_2 + t190*t230
    t232 = -k_sp_2*t19*t3*w_b_2 + t193*t230
    t233 = -g_2_1*t231
    t234 = g_2_2*t233
    t235 = -g_2_1*t232
    t236 = g_2_2*t235
    t237 = -t231*t47
    t238 = -t232*t47
    t239 = -g_2_2*t231
    t240 = R_p_2*t239
    t241 = -g_2_2*t232
    t242 = R_p_2*t241
    t243 = t138*t171
    t244 = t106*t243
    t245 = t113*t243
    t246 = t156*t188
    t247 = t120*t246
    t248 = t127*t246
    t249 = g_1_1*t244
    t250 = g_1_2*t249
    t251 = g_1_1*t245
    t252 = g_1_2*t251
    t253 = g_2_1*t247
    t254 = g_2_2*t253
    t255 = g_2_1*t248
    t256 = g_2_2*t255
    t257 = t244*t30
    t258 = t245*t30
    t259 = t247*t47
    t260 = t248*t47
    t261 = g_1_2*t244
    t262 = R_p_1*t261
    t263 = g_1_2*t245
    t264 = R_p_1*t263
    t265 = g_2_2*t247
    t266 = R_p_2*t265
    t267 = g_2_2*t248
    t268 = R_p_2*t267
    t269 = F_T*t3
    t270 = t135*t136*t171
    t271 = t269*t270
    t272 = -F_T*k_sp_1*t2*t8*w_b_1 + t134*t271
    t273 = -F_T*k_sp_1*t10*t2*w_b_1 + t141*t271
    t274 = t154*t155*t188
    t275 = t269*t274
    t276 = -F_T*k_sp_2*t12*t17*w_b_2 + t153*t275
    t277 = -F_T*k_sp_2*t12*t19*w_b_2 + t159*t275
    t278 = -g_1_1*t272
    t279 = g_1_2*t278
    t280 = -g_1_1*t273
    t281 = g_1_2*t280
    t282 = -g_2_1*t276
    t283 = g_2_2*t282
    t284 = -g_2_1*t277
    t285 = g_2_2*t284
    t286 = -t272*t30
    t287 = -t273*t30
    t288 = -t276*t47
    t289 = -t277*t47
    t290 = -g_1_2*t272
    t291 = R_p_1*t290
    t292 = -g_1_2*t273
    t293 = R_p_1*t292
    t294 = -g_2_2*t276
    t295 = R_p_2*t294
    t296 = -g_2_2*t277
    t297 = R_p_2*t296
    t298 = c_T*t3
    t299 = t270*t298
    t300 = -c_T*k_sp_1*t2*t8*w_b_1 + t134*t299
    t301 = -c_T*k_sp_1*t10*t2*w_b_1 + t141*t299
    t302 = t274*t298
    t303 = -c_T*k_sp_2*t12*t17*w_b_2 + t153*t302
    t304 = -c_T*k_sp_2*t12*t19*w_b_2 + t159*t302
    t305 = -g_1_1*t300
    t306 = g_1_2*t305
    t307 = -g_1_1*t301
    t308 = g_1_2*t307
    t309 = -g_2_1*t303
    t310 = g_2_2*t309
    t311 = -g_2_1*t304
    t312 = g_2_2*t311
    t313 = -t30*t300
    t314 = -t30*t301
    t315 = -t303*t47
    t316 = -t304*t47
    t317 = -g_1_2*t300
    t318 = R_p_1*t317
    t319 = -g_1_2*t301
    t320 = R_p_1*t319
    t321 = -g_2_2*t303
    t322 = R_p_2*t321
    t323 = -g_2_2*t304
    t324 = R_p_2*t323
    t325 = k_1_1*t30
    t326 = k_1_2*t30
    t327 = k_2_1*t47
    t328 = k_2_2*t47
    t329 = 2*b
    M_theta_out = _listed(batch, dtype, (
        1, 1, 1, 1, b, 1, 1, b, t20, 1, 1, 1, 1, t23, t25, t28, t24, t29, t31, -t32, t33, t34, t36, -t27, t37,
        t22, t38, t39, t23, t25, t28, t24, t29, t31, -t32, t33, t34, t36, -t27, t37, t22, t38, t39, t41, t43,
        t45, t42, t46, t48, -t49, t50, t51, t53, -t44, t54, t22, t55, t56, t41, t43, t45, t42, t46, t48, -t49,
        t50, t51, t53, -t44, t54, t22, t55, t56, -g_1_1*t57 - g_1_1*t58, -t59 - t60,
        l_f_1_1*t62 + l_f_1_2*t62, -t57 - t58, -b*t59 - b*t60, -g_2_1*t63 - g_2_1*t64, -t65 - t66,
        l_f_2_1*t67 + l_f_2_2*t67, -t63 - t64, -b*t65 - b*t66, 1, 1, t68, t68, t68, t69, t69, t69, t70, t70,
        t70, t71, t71, t71, t21*t72 + t21*t73 + t40*t74 + t40*t75, t77 + t79 + t81 + t83,
        -g_1_1*t85 - g_1_1*t86, -g_2_1*t88 - g_2_1*t89, t76 + t78, t80 + t82, b*t77 + b*t79 + b*t81 + b*t83,
        t90 + t91 + t92 + t93, -t94 - t95, -t96 - t97, t98 + t99, t100 + t101, b*t90 + b*t91 + b*t92 + b*t93,
        t35*t72 + t35*t73, -t85 - t86, -b*t94 - b*t95, t52*t74 + t52*t75, -t88 - t89, -b*t96 - b*t97,
        t72 + t73, b*t98 + b*t99, t74 + t75, b*t100 + b*t101, t20*t90 + t20*t91 + t20*t92 + t20*t93, 1, 1, 1,
        1, 1, 1, b, 1, 1, b, t20, 1, 1, 1, -l_f_1_1*t25 - l_f_1_2*t25 - l_f_2_1*t43 - l_f_2_2*t43,
        -l_f_1_1*t31 - l_f_1_2*t31 - l_f_2_1*t48 - l_f_2_2*t48 - t102, l_f_1_1*t32 + l_f_1_2*t32,
        l_f_2_1*t49 + l_f_2_2*t49, -l_f_1_1*t33 - l_f_1_2*t33, -l_f_2_1*t50 - l_f_2_2*t50, -t102,
        -4*b*((1/2)*m_L + (1/2)*m_h) - l_f_1_1*t104 - l_f_1_2*t104 - l_f_2_1*t105 - l_f_2_2*t105,
    ))
    K_theta_out = _listed(batch, dtype, (
        -g_y, -t102, -t107*t21, -t109, -R_p_1*t108, -t108, -b*t109, -t110, -t112, -t111, -b*t110, -t107*t35,
        -R_p_1*t107, -b*t112, -t107, -b*t111, -t110*t20, -t114*t21, -t116, -R_p_1*t115, -t115, -b*t116, -t117,
        -t119, -t118, -b*t117, -t114*t35, -R_p_1*t114, -b*t119, -t114, -b*t118, -t117*t20, -t121*t40, -t123,
        -R_p_2*t122, -t122, -b*t123, -t124, -t126, -t125, -b*t124, -t121*t52, -R_p_2*t121, -b*t126, -t121,
        -b*t125, -t124*t20, -t128*t40, -t130, -R_p_2*t129, -t129, -b*t130, -t131, -t133, -t132, -b*t131,
        -t128*t52, -R_p_2*t128, -b*t133, -t128, -b*t132, -t131*t20, -t140*t21 - t142*t21, t144 + t146,
        R_p_1*t143 + R_p_1*t145, t143 + t145, b*t144 + b*t146, t147 + t148, t150 + t152, t149 + t151,
        b*t147 + b*t148, -t140*t35 - t142*t35, -R_p_1*t140 - R_p_1*t142, b*t150 + b*t152, -t140 - t142,
        b*t149 + b*t151, t147*t20 + t148*t20, -t158*t40 - t160*t40, t162 + t164, R_p_2*t161 + R_p_2*t163,
        t161 + t163, b*t162 + b*t164, t165 + t166, t168 + t170, t167 + t169, b*t165 + b*t166,
        -t158*t52 - t160*t52, -R_p_2*t158 - R_p_2*t160, b*t168 + b*t170, -t158 - t160, b*t167 + b*t169,
        t165*t20 + t166*t20, -t175*t21 - t177*t21, t179 + t181, R_p_1*t178 + R_p_1*t180, t178 + t180,
        b*t179 + b*t181, t182 + t183, t185 + t187, t184 + t186, b*t182 + b*t183, -t175*t35 - t177*t35,
        -R_p_1*t175 - R_p_1*t177, b*t185 + b*t187, -t175 - t177, b*t184 + b*t186, t182*t20 + t183*t20,
        -t192*t40 - t194*t40, t196 + t198, R_p_2*t195 + R_p_2*t197, t195 + t197, b*t196 + b*t198, t199 + t200,
        t202 + t204, t201 + t203, b*t199 + b*t200, -t192*t52 - t194*t52, -R_p_2*t192 - R_p_2*t194,
        b*t202 + b*t204, -t192 - t194, b*t201 + b*t203, t199*t20 + t20*t200, t205 + t206, t209,
        k_1_1*t210 + k_1_2*t210, k_1_1 + k_1_2, b*t207 + b*t208, t211 + t212, t215, k_2_1*t216 + k_2_2*t216,
        k_2_1 + k_2_2, b*t213 + b*t214, -t21*t218 - t21*t219, t221 + t223, R_p_1*t220 + R_p_1*t222,
        t220 + t222, b*t221 + b*t223, t224 + t225, t227 + t229, t226 + t228, b*t224 + b*t225,
        -t218*t35 - t219*t35, -R_p_1*t218 - R_p_1*t219, b*t227 + b*t229, -t218 - t219, b*t226 + b*t228,
        t20*t224 + t20*t225, -t231*t40 - t232*t40, t234 + t236, R_p_2*t233 + R_p_2*t235, t233 + t235,
        b*t234 + b*t236, t237 + t238, t240 + t242, t239 + t241, b*t237 + b*t238, -t231*t52 - t232*t52,
        -R_p_2*t231 - R_p_2*t232, b*t240 + b*t242, -t231 - t232, b*t239 + b*t241, t20*t237 + t20*t238,
        -t21*t244 - t21*t245 - t247*t40 - t248*t40, -t250 - t252 - t254 - t256, -R_p_1*t249 - R_p_1*t251,
        -R_p_2*t253 - R_p_2*t255, -t249 - t251, -t253 - t255, -b*t250 - b*t252 - b*t254 - b*t256,
        -t257 - t258 - t259 - t260, -t262 - t264, -t266 - t268, -t261 - t263, -t265 - t267,
        -b*t257 - b*t258 - b*t259 - b*t260, -t244*t35 - t245*t35, -R_p_1*t244 - R_p_1*t245, -b*t262 - b*t264,
        -t247*t52 - t248*t52, -R_p_2*t247 - R_p_2*t248, -b*t266 - b*t268, -t244 - t245, -b*t261 - b*t263,
        -t247 - t248, -b*t265 - b*t267, -t20*t257 - t20*t258 - t20*t259 - t20*t260,
        -t21*t272 - t21*t273 - t276*t40 - t277*t40, t279 + t281 + t283 + t285, R_p_1*t278 + R_p_1*t280,
        R_p_2*t282 + R_p_2*t284, t278 + t280, t282 + t284, b*t279 + b*t281 + b*t283 + b*t285,
        t286 + t287 + t288 + t289, t291 + t293, t295 + t297, t290 + t292, t294 + t296,
        b*t286 + b*t287 + b*t288 + b*t289, -t272*t35 - t273*t35, -R_p_1*t272 - R_p_1*t273, b*t291 + b*t293,
        -t276*t52 - t277*t52, -R_p_2*t276 - R_p_2*t277, b*t295 + b*t297, -t272 - t273, b*t290 + b*t292,
        -t276 - t277, b*t294 + b*t296, t20*t286 + t20*t287 + t20*t288 + t20*t289,
        -t21*t300 - t21*t301 - t303*t40 - t304*t40, t306 + t308 + t310 + t312, R_p_1*t305 + R_p_1*t307,
        R_p_2*t309 + R_p_2*t311, t305 + t307, t309 + t311, b*t306 + b*t308 + b*t310 + b*t312,
        t313 + t314 + t315 + t316, t318 + t320, t322 + t324, t317 + t319, t321 + t323,
        b*t313 + b*t314 + b*t315 + b*t316, -t300*t35 - t301*t35, -R_p_1*t300 - R_p_1*t301, b*t318 + b*t320,
        -t303*t52 - t304*t52, -R_p_2*t303 - R_p_2*t304, b*t322 + b*t324, -t300 - t301, b*t317 + b*t319,
        -t303 - t304, b*t321 + b*t323, t20*t313 + t20*t314 + t20*t315 + t20*t316, 1, 1, 1, 1, b, 1, 1, b, t20,
        -g_y, 1, 1, 1, 1, 1, 1, -g_1_2*t205 - g_1_2*t206 - g_2_2*t211 - g_2_2*t212,
        -k_C - t325 - t326 - t327 - t328, -R_p_1*t207 - R_p_1*t208, -R_p_2*t213 - R_p_2*t214, -t209, -t215,
        -k_C, -k_C*t329 - t325*t329 - t326*t329 - t327*t329 - t328*t329,
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
