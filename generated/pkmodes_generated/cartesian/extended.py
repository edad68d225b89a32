# Generated from the derivation of cartesian and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism cartesian with effects: extended matrices and sensitivities.

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
    ('beam_mass', (), ((1, 1), (1, 9), (8, 8), (9, 9)), ()),
    ('gravity', (0,), (), ()),
    ('gravity', (1,), (), ((0, 10),)),
    ('gravity', (2,), (), ()),
    ('axis_lengths', (0, 0), ((0, 0), (0, 2), (0, 6), (2, 2), (2, 6), (6, 6)),
     ((0, 0), (0, 2), (0, 6), (2, 2), (2, 6), (6, 6))),
    ('axis_lengths', (0, 1), ((0, 0), (0, 2), (0, 6), (2, 2), (2, 6), (6, 6)),
     ((0, 0), (0, 2), (0, 6), (2, 2), (2, 6), (6, 6))),
    ('axis_lengths', (1, 0), ((1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7)),
     ((1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('axis_lengths', (1, 1), ((1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7)),
     ((1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('belt_specific_stiffness', (0,), (), ((0, 0), (0, 2), (0, 6), (2, 2), (2, 6), (6, 6))),
    ('belt_specific_stiffness', (1,), (), ((1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('belt_width', (0,), (), ((0, 0), (0, 2), (0, 6), (2, 2), (2, 6), (6, 6))),
    ('belt_width', (1,), (), ((1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('pulley_radius', (0,), ((0, 2), (2, 2), (2, 6)), ((0, 2), (2, 2), (2, 6))),
    ('pulley_radius', (1,), ((1, 3), (3, 3), (3, 7)), ((1, 3), (3, 3), (3, 7))),
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
    ('axis_belt_stiffness_factor_1', (), (), ((0, 0), (0, 2), (0, 6), (2, 2), (2, 6), (6, 6))),
    ('axis_belt_stiffness_factor_2', (), (), ((1, 1), (1, 3), (1, 7), (3, 3), (3, 7), (7, 7))),
    ('belt_end_compliance_compliance', (), (),
     ((0, 0), (0, 2), (0, 6), (1, 1), (1, 3), (1, 7), (2, 2), (2, 6), (3, 3), (3, 7), (6, 6), (7, 7))),
    ('belt_loss_loss_factor', (), (), ()),
    ('belt_mass_linear_density', (),
     ((0, 0), (0, 2), (0, 6), (1, 1), (1, 3), (1, 7), (2, 2), (2, 6), (3, 3), (3, 7), (6, 6), (7, 7)),
     ()),
    ('belt_tension_stiffness_coefficient', (), (),
     ((0, 0), (0, 2), (0, 6), (1, 1), (1, 3), (1, 7), (2, 2), (2, 6), (3, 3), (3, 7), (6, 6), (7, 7))),
    ('belt_tension_stiffness_tension', (), (),
     ((0, 0), (0, 2), (0, 6), (1, 1), (1, 3), (1, 7), (2, 2), (2, 6), (3, 3), (3, 7), (6, 6), (7, 7))),
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
    ('gantry_racking_center', (), ((1, 10), (9, 10), (10, 10)), ((1, 10), (9, 10), (10, 10))),
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
    97 operations; 856 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.beam_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
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
    batch, dtype = _batch(x, m_h, m_b, g_x, l_0_1_1, k_sp_1, w_b_1, R_p_1, I_p_1, I_m_1, i_g_1, a_B_1, a_B_2,
        c_E, rho_b, c_T, F_T, k_C, I_G, m_L, k_S, m_F, J_B, x_B)
    b = x - x_B
    t1 = I_m_1*i_g_1**2
    I_1 = I_G + I_p_1 + t1
    t2 = I_m_2*i_g_2**2
    I_2 = I_G + I_p_2 + t2
    l_f_1_1 = l_0_1_1 + x
    t3 = F_T*c_T + 1
    t4 = c_E*t3
    t5 = k_sp_1*w_b_1*(a_B_1 + 1)
    t6 = t4*t5
    t7 = t3*t5
    k_1_1 = t7/(l_f_1_1 + t6)
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t7/(l_f_1_2 + t6)
    l_f_2_1 = l_0_2_1 + y
    t8 = k_sp_2*w_b_2*(a_B_2 + 1)
    t9 = t4*t8
    t10 = t3*t8
    k_2_1 = t10/(l_f_2_1 + t9)
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t10/(l_f_2_2 + t9)
    t11 = (1/3)*rho_b
    t12 = l_f_1_1*t11
    t13 = l_f_1_2*t11
    t14 = t12 + t13
    t15 = m_L + m_h
    t16 = (1/6)*rho_b
    t17 = R_p_1*t16
    t18 = -l_f_1_1*t17 - l_f_1_2*t17
    t19 = l_f_2_1*t11
    t20 = l_f_2_2*t11
    t21 = t19 + t20
    t22 = m_b + t15
    t23 = R_p_2*t16
    t24 = -l_f_2_1*t23 - l_f_2_2*t23
    t25 = b*t15
    t26 = R_p_1**2
    t27 = R_p_2**2
    t28 = m_F + t22
    t29 = b**2
    t30 = k_1_1 + k_1_2
    t31 = R_p_1*k_1_1 + R_p_1*k_1_2
    t32 = k_2_1 + k_2_2
    t33 = R_p_2*k_2_1 + R_p_2*k_2_2
    t34 = b*k_C
    M_out = np.zeros((*batch, 11, 11), dtype)
    M_out[..., 0, 0] = t14 + t15
    M_out[..., 0, 2] = M_out[..., 2, 0] = t18
    M_out[..., 0, 6] = M_out[..., 6, 0] = t14
    M_out[..., 0, 8] = M_out[..., 8, 0] = t15
    M_out[..., 1, 1] = t21 + t22
    M_out[..., 1, 3] = M_out[..., 3, 1] = t24
    M_out[..., 1, 7] = M_out[..., 7, 1] = t21
    M_out[..., 1, 9] = M_out[..., 9, 1] = t22
    M_out[..., 1, 10] = M_out[..., 10, 1] = t25
    M_out[..., 2, 2] = I_1 + t12*t26 + t13*t26
    M_out[..., 2, 4] = M_out[..., 4, 2] = t1
    M_out[..., 2, 6] = M_out[..., 6, 2] = t18
    M_out[..., 3, 3] = I_2 + t19*t27 + t20*t27
    M_out[..., 3, 5] = M_out[..., 5, 3] = t2
    M_out[..., 3, 7] = M_out[..., 7, 3] = t24
    M_out[..., 4, 4] = t1
    M_out[..., 5, 5] = t2
    M_out[..., 6, 6] = t14
    M_out[..., 7, 7] = t21
    M_out[..., 8, 8] = t28
    M_out[..., 9, 9] = t28
    M_out[..., 9, 10] = M_out[..., 10, 9] = t25
    M_out[..., 10, 10] = J_B + 2*t29*((1/2)*m_L + (1/2)*m_h)
    K_el_out = np.zeros((*batch, 11, 11), dtype)
    K_el_out[..., 0, 0] = k_C + t30
    K_el_out[..., 0, 2] = K_el_out[..., 2, 0] = t31
    K_el_out[..., 0, 6] = K_el_out[..., 6, 0] = t30
    K_el_out[..., 0, 8] = K_el_out[..., 8, 0] = k_C
    K_el_out[..., 1, 1] = k_C + t32
    K_el_out[..., 1, 3] = K_el_out[..., 3, 1] = t33
    K_el_out[..., 1, 7] = K_el_out[..., 7, 1] = t32
    K_el_out[..., 1, 9] = K_el_out[..., 9, 1] = k_C
    K_el_out[..., 1, 10] = K_el_out[..., 10, 1] = t34
    K_el_out[..., 2, 2] = k_1_1*t26 + k_1_2*t26 + k_S
    K_el_out[..., 2, 4] = K_el_out[..., 4, 2] = k_S
    K_el_out[..., 2, 6] = K_el_out[..., 6, 2] = t31
    K_el_out[..., 3, 3] = k_2_1*t27 + k_2_2*t27 + k_S
    K_el_out[..., 3, 5] = K_el_out[..., 5, 3] = k_S
    K_el_out[..., 3, 7] = K_el_out[..., 7, 3] = t33
    K_el_out[..., 4, 4] = k_S
    K_el_out[..., 5, 5] = k_S
    K_el_out[..., 6, 6] = t30
    K_el_out[..., 7, 7] = t32
    K_el_out[..., 8, 8] = k_C
    K_el_out[..., 9, 9] = k_C
    K_el_out[..., 9, 10] = K_el_out[..., 10, 9] = t34
    K_el_out[..., 10, 10] = k_C*t29
    K_g_out = np.zeros((*batch, 11, 11), dtype)
    K_g_out[..., 0, 10] = K_g_out[..., 10, 0] = -g_y*t15
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
    60 operations; 1014 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
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
    batch, dtype = _batch(x, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, eta_B, c_T, F_T, b_D, b_R)
    l_f_1_1 = l_0_1_1 + x
    t1 = F_T*c_T + 1
    t2 = c_E*t1
    t3 = a_B_1 + 1
    t4 = k_sp_1*t3*w_b_1
    t5 = t2*t4
    t6 = t1*t4
    k_1_1 = t6/(l_f_1_1 + t5)
    l_f_1_2 = l_0_1_2 - x
    k_1_2 = t6/(l_f_1_2 + t5)
    l_f_2_1 = l_0_2_1 + y
    t7 = a_B_2 + 1
    t8 = k_sp_2*t7*w_b_2
    t9 = t2*t8
    t10 = t1*t8
    k_2_1 = t10/(l_f_2_1 + t9)
    l_f_2_2 = l_0_2_2 - y
    k_2_2 = t10/(l_f_2_2 + t9)
    t11 = eta_B/t1
    t12 = t11/(k_sp_1*t3*w_b_1)
    t13 = k_1_1**2*l_f_1_1*t12
    t14 = k_1_2**2*l_f_1_2*t12
    t15 = t13 + t14
    t16 = R_p_1*t13 + R_p_1*t14
    t17 = t11/(k_sp_2*t7*w_b_2)
    t18 = k_2_1**2*l_f_2_1*t17
    t19 = k_2_2**2*l_f_2_2*t17
    t20 = t18 + t19
    t21 = R_p_2*t18 + R_p_2*t19
    t22 = R_p_1**2
    t23 = R_p_2**2
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
    K_loss_out[..., 0, 0] = t15
    K_loss_out[..., 0, 2] = K_loss_out[..., 2, 0] = t16
    K_loss_out[..., 0, 6] = K_loss_out[..., 6, 0] = t15
    K_loss_out[..., 1, 1] = t20
    K_loss_out[..., 1, 3] = K_loss_out[..., 3, 1] = t21
    K_loss_out[..., 1, 7] = K_loss_out[..., 7, 1] = t20
    K_loss_out[..., 2, 2] = t13*t22 + t14*t22
    K_loss_out[..., 2, 6] = K_loss_out[..., 6, 2] = t16
    K_loss_out[..., 3, 3] = t18*t23 + t19*t23
    K_loss_out[..., 3, 7] = K_loss_out[..., 7, 3] = t21
    K_loss_out[..., 6, 6] = t15
    K_loss_out[..., 7, 7] = t20
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
    51 operations; 321 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    (m_b,) = _entries(parameters.beam_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
    k_sp_1, k_sp_2 = _entries(parameters.belt_specific_stiffness, (2,))
    w_b_1, w_b_2 = _entries(parameters.belt_width, (2,))
    R_p_1, R_p_2 = _entries(parameters.pulley_radius, (2,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(x, m_h, m_b, g_x, l_0_1_1, k_sp_1, w_b_1, R_p_1, a_B_1, a_B_2, c_E, c_T, F_T, m_L)
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
    t9 = m_L + m_h
    G_1 = -g_x*t9
    G_2 = -g_y*(m_b + t9)
    theta_1_st = -G_1/(R_p_1*k_1_1 + R_p_1*k_1_2)
    theta_2_st = -G_2/(R_p_2*k_2_1 + R_p_2*k_2_2)
    t10 = R_p_1**2*theta_1_st
    tau_st_1 = k_1_1*t10 + k_1_2*t10
    t11 = R_p_2**2*theta_2_st
    tau_st_2 = k_2_1*t11 + k_2_2*t11
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
    M_theta : array, shape (..., 86) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 123) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Chain rule.
    426 operations; 5987 with every named value expanded.
    """
    x, y = _entries(p, (2,))
    (m_h,) = _entries(parameters.toolhead_mass, ())
    g_x, g_y, _ = _entries(parameters.gravity, (3,))
    l_0_1_1, l_0_1_2, l_0_2_1, l_0_2_2 = _entries(parameters.axis_lengths, (2, 2))
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
    batch, dtype = _batch(x, m_h, g_x, l_0_1_1, k_sp_1, w_b_1, R_p_1, I_m_1, i_g_1, a_B_1, a_B_2, c_E, rho_b,
        c_T, F_T, k_C, m_L, x_B)
    b = x - x_B
    l_f_1_1 = l_0_1_1 + x
    t1 = a_B_1 + 1
    t2 = F_T*c_T + 1
    t3 = t1*t2*w_b_1
    t4 = k_sp_1*t3
    t5 = c_E*t4
    t6 = l_f_1_1 + t5
    t7 = 1.0/t6
    k_1_1 = k_sp_1*t3*t7
    l_f_1_2 = l_0_1_2 - x
    t8 = l_f_1_2 + t5
    t9 = 1.0/t8
    k_1_2 = k_sp_1*t3*t9
    l_f_2_1 = l_0_2_1 + y
    t10 = a_B_2 + 1
    t11 = t10*t2*w_b_2
    t12 = k_sp_2*t11
    t13 = c_E*t12
    t14 = l_f_2_1 + t13
    t15 = 1.0/t14
    k_2_1 = k_sp_2*t11*t15
    l_f_2_2 = l_0_2_2 - y
    t16 = l_f_2_2 + t13
    t17 = 1.0/t16
    k_2_2 = k_sp_2*t11*t17
    t18 = b**2
    t19 = (1/3)*rho_b
    t20 = (1/6)*rho_b
    t21 = -R_p_1*t20
    t22 = R_p_1**2
    t23 = t19*t22
    t24 = -R_p_2*t20
    t25 = R_p_2**2
    t26 = t19*t25
    t27 = -l_f_1_1*t20 - l_f_1_2*t20
    t28 = (2/3)*rho_b
    t29 = R_p_1*t28
    t30 = -l_f_2_1*t20 - l_f_2_2*t20
    t31 = R_p_2*t28
    t32 = i_g_1**2
    t33 = i_g_2**2
    t34 = 2*I_m_1*i_g_1
    t35 = 2*I_m_2*i_g_2
    t36 = (1/3)*l_f_1_1
    t37 = (1/3)*l_f_1_2
    t38 = t36 + t37
    t39 = (1/6)*R_p_1
    t40 = -l_f_1_1*t39 - l_f_1_2*t39
    t41 = (1/3)*l_f_2_1
    t42 = (1/3)*l_f_2_2
    t43 = t41 + t42
    t44 = (1/6)*R_p_2
    t45 = -l_f_2_1*t44 - l_f_2_2*t44
    t46 = -m_L - m_h
    t47 = 1.0/(t6**2)
    t48 = t4*t47
    t49 = -R_p_1*t48
    t50 = 1.0/(t8**2)
    t51 = t4*t50
    t52 = -R_p_1*t51
    t53 = 1.0/(t14**2)
    t54 = t12*t53
    t55 = -R_p_2*t54
    t56 = 1.0/(t16**2)
    t57 = t12*t56
    t58 = -R_p_2*t57
    t59 = c_E*t47
    t60 = w_b_1**2
    t61 = t1**2
    t62 = t2**2
    t63 = t60*t61*t62
    t64 = k_sp_1*t63
    t65 = -t1*t2*t7*w_b_1 + t59*t64
    t66 = c_E*t50
    t67 = -t1*t2*t9*w_b_1 + t64*t66
    t68 = -t65 - t67
    t69 = -R_p_1*t65 - R_p_1*t67
    t70 = c_E*t53
    t71 = w_b_2**2
    t72 = t10**2
    t73 = t62*t71*t72
    t74 = k_sp_2*t73
    t75 = -t10*t15*t2*w_b_2 + t70*t74
    t76 = c_E*t56
    t77 = -t10*t17*t2*w_b_2 + t74*t76
    t78 = -t75 - t77
    t79 = -R_p_2*t75 - R_p_2*t77
    t80 = k_sp_1**2
    t81 = t62*t80
    t82 = t59*t81
    t83 = t61*w_b_1
    t84 = -k_sp_1*t1*t2*t7 + t82*t83
    t85 = t66*t81
    t86 = -k_sp_1*t1*t2*t9 + t83*t85
    t87 = -t84 - t86
    t88 = -R_p_1*t84 - R_p_1*t86
    t89 = k_sp_2**2
    t90 = t62*t89
    t91 = t70*t90
    t92 = t72*w_b_2
    t93 = -k_sp_2*t10*t15*t2 + t91*t92
    t94 = t76*t90
    t95 = -k_sp_2*t10*t17*t2 + t92*t94
    t96 = -t93 - t95
    t97 = -R_p_2*t93 - R_p_2*t95
    t98 = k_1_1 + k_1_2
    t99 = 2*R_p_1
    t100 = k_2_1 + k_2_2
    t101 = 2*R_p_2
    t102 = t1*t60
    t103 = -k_sp_1*t2*t7*w_b_1 + t102*t82
    t104 = -k_sp_1*t2*t9*w_b_1 + t102*t85
    t105 = -t103 - t104
    t106 = -R_p_1*t103 - R_p_1*t104
    t107 = t10*t71
    t108 = -k_sp_2*t15*t2*w_b_2 + t107*t91
    t109 = -k_sp_2*t17*t2*w_b_2 + t107*t94
    t110 = -t108 - t109
    t111 = -R_p_2*t108 - R_p_2*t109
    t112 = t63*t80
    t113 = t112*t47
    t114 = t112*t50
    t115 = -t113 - t114
    t116 = -R_p_1*t113 - R_p_1*t114
    t117 = t73*t89
    t118 = t117*t53
    t119 = t117*t56
    t120 = -t118 - t119
    t121 = -R_p_2*t118 - R_p_2*t119
    t122 = F_T*t2
    t123 = t60*t61*t80
    t124 = t122*t123
    t125 = -F_T*k_sp_1*t1*t7*w_b_1 + t124*t59
    t126 = -F_T*k_sp_1*t1*t9*w_b_1 + t124*t66
    t127 = -t125 - t126
    t128 = -R_p_1*t125 - R_p_1*t126
    t129 = t71*t72*t89
    t130 = t122*t129
    t131 = -F_T*k_sp_2*t10*t15*w_b_2 + t130*t70
    t132 = -F_T*k_sp_2*t10*t17*w_b_2 + t130*t76
    t133 = -t131 - t132
    t134 = -R_p_2*t131 - R_p_2*t132
    t135 = c_T*t2
    t136 = t123*t135
    t137 = -c_T*k_sp_1*t1*t7*w_b_1 + t136*t59
    t138 = -c_T*k_sp_1*t1*t9*w_b_1 + t136*t66
    t139 = -t137 - t138
    t140 = -R_p_1*t137 - R_p_1*t138
    t141 = t129*t135
    t142 = -c_T*k_sp_2*t10*t15*w_b_2 + t141*t70
    t143 = -c_T*k_sp_2*t10*t17*w_b_2 + t141*t76
    t144 = -t142 - t143
    t145 = -R_p_2*t142 - R_p_2*t143
    M_theta_out = _listed(batch, dtype, (
        1, 1, 1, 1, b, 1, 1, b, t18, 1, 1, 1, 1, t19, t21, t19, t23, t21, t19, t19, t21, t19, t23, t21, t19,
        t19, t24, t19, t26, t24, t19, t19, t24, t19, t26, t24, t19, t27, l_f_1_1*t29 + l_f_1_2*t29, t27, t30,
        l_f_2_1*t31 + l_f_2_2*t31, t30, 1, 1, t32, t32, t32, t33, t33, t33, t34, t34, t34, t35, t35, t35, t38,
        t40, t38, t43, t45, t43, t22*t36 + t22*t37, t40, t25*t41 + t25*t42, t45, t38, t43, 1, 1, 1, 1, 1, 1,
        b, 1, 1, b, t18, 1, 1, 1, t46, t46, -4*b*((1/2)*m_L + (1/2)*m_h),
    ))
    K_theta_out = _listed(batch, dtype, (
        -g_y, t46, -t48, t49, -t48, -t22*t48, t49, -t48, -t51, t52, -t51, -t22*t51, t52, -t51, -t54, t55,
        -t54, -t25*t54, t55, -t54, -t57, t58, -t57, -t25*t57, t58, -t57, t68, t69, t68, -t22*t65 - t22*t67,
        t69, t68, t78, t79, t78, -t25*t75 - t25*t77, t79, t78, t87, t88, t87, -t22*t84 - t22*t86, t88, t87,
        t96, t97, t96, -t25*t93 - t25*t95, t97, t96, t98, k_1_1*t99 + k_1_2*t99, t98, t100,
        k_2_1*t101 + k_2_2*t101, t100, t105, t106, t105, -t103*t22 - t104*t22, t106, t105, t110, t111, t110,
        -t108*t25 - t109*t25, t111, t110, t115, t116, t115, t120, t121, t120, -t113*t22 - t114*t22, t116,
        -t118*t25 - t119*t25, t121, t115, t120, t127, t128, t127, t133, t134, t133, -t125*t22 - t126*t22,
        t128, -t131*t25 - t132*t25, t134, t127, t133, t139, t140, t139, t144, t145, t144,
        -t137*t22 - t138*t22, t140, -t142*t25 - t143*t25, t145, t139, t144, 1, 1, 1, 1, b, 1, 1, b, t18, -g_y,
        1, 1, 1, 1, 1, 1, -k_C, -k_C, -2*b*k_C,
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
