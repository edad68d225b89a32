# Generated from the derivation of linear_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism linear_delta with effects: extended matrices and sensitivities.

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
* tau_st_j [N m]: static torque on the driven pulley of axis j
* I_j_k [kg m^2]: moment of inertia of pulley k of axis j, including the motor if it is driven
* l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* D_r_j [m]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [1]: platform Jacobian, dp_i/dx_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* G_j [N]: gradient of the gravitational potential energy with respect to x_j
* det_j [N^2 m]: determinant of the equilibrium equations of axis j
* theta_j_k_st [rad]: static rotation of pulley k of axis j, relative to the unstrained transmissions
* X_by_Y [unit of X / unit of Y]: derivative of X with respect to the parameter Y, at a fixed pose
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

#: Parameters of the derivatives: field of Parameters or Effects, index in it, and (row, column) of the
#: entries of M and of K, in the upper triangle, that depend on it.
VALUE_SENSITIVITIES = (
    ('platform_mass', (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('gravity', (0,), (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('gravity', (1,), (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('gravity', (2,), (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('link_mass', (0,),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('link_mass', (1,),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('link_mass', (2,),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('carriage_mass', (0,), ((0, 0), (0, 18), (0, 19), (0, 20), (18, 18), (19, 19), (20, 20)), ()),
    ('carriage_mass', (1,), ((1, 1), (1, 18), (1, 19), (1, 20), (18, 18), (19, 19), (20, 20)), ()),
    ('carriage_mass', (2,), ((2, 2), (2, 18), (2, 19), (2, 20), (18, 18), (19, 19), (20, 20)), ()),
    ('carriage_length', (0,),
     ((0, 0), (0, 3), (0, 6), (0, 15), (3, 3), (3, 15), (6, 6), (6, 15), (15, 15)),
     ((0, 0), (0, 3), (0, 6), (0, 15), (3, 3), (3, 15), (6, 6), (6, 15), (15, 15))),
    ('carriage_length', (1,),
     ((1, 1), (1, 4), (1, 7), (1, 16), (4, 4), (4, 16), (7, 7), (7, 16), (16, 16)),
     ((1, 1), (1, 4), (1, 7), (1, 16), (4, 4), (4, 16), (7, 7), (7, 16), (16, 16))),
    ('carriage_length', (2,),
     ((2, 2), (2, 5), (2, 8), (2, 17), (5, 5), (5, 17), (8, 8), (8, 17), (17, 17)),
     ((2, 2), (2, 5), (2, 8), (2, 17), (5, 5), (5, 17), (8, 8), (8, 17), (17, 17))),
    ('belt_specific_stiffness', (0,), (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (3, 3), (3, 6), (3, 15), (6, 6), (6, 15), (15, 15))),
    ('belt_specific_stiffness', (1,), (),
     ((1, 1), (1, 4), (1, 7), (1, 16), (4, 4), (4, 7), (4, 16), (7, 7), (7, 16), (16, 16))),
    ('belt_specific_stiffness', (2,), (),
     ((2, 2), (2, 5), (2, 8), (2, 17), (5, 5), (5, 8), (5, 17), (8, 8), (8, 17), (17, 17))),
    ('belt_width', (0,), (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (3, 3), (3, 6), (3, 15), (6, 6), (6, 15), (15, 15))),
    ('belt_width', (1,), (),
     ((1, 1), (1, 4), (1, 7), (1, 16), (4, 4), (4, 7), (4, 16), (7, 7), (7, 16), (16, 16))),
    ('belt_width', (2,), (),
     ((2, 2), (2, 5), (2, 8), (2, 17), (5, 5), (5, 8), (5, 17), (8, 8), (8, 17), (17, 17))),
    ('pulley_radius', (0,), ((0, 3), (0, 6), (3, 3), (3, 6), (3, 15), (6, 6), (6, 15)),
     ((0, 3), (0, 6), (3, 3), (3, 6), (3, 15), (6, 6), (6, 15))),
    ('pulley_radius', (1,), ((1, 4), (1, 7), (4, 4), (4, 7), (4, 16), (7, 7), (7, 16)),
     ((1, 4), (1, 7), (4, 4), (4, 7), (4, 16), (7, 7), (7, 16))),
    ('pulley_radius', (2,), ((2, 5), (2, 8), (5, 5), (5, 8), (5, 17), (8, 8), (8, 17)),
     ((2, 5), (2, 8), (5, 5), (5, 8), (5, 17), (8, 8), (8, 17))),
    ('pulley_inertia', (0,), ((3, 3), (6, 6)), ()),
    ('pulley_inertia', (1,), ((4, 4), (7, 7)), ()),
    ('pulley_inertia', (2,), ((5, 5), (8, 8)), ()),
    ('motor_inertia', (0,), ((3, 3), (3, 9), (6, 6), (6, 9), (9, 9)), ()),
    ('motor_inertia', (1,), ((4, 4), (4, 10), (7, 7), (7, 10), (10, 10)), ()),
    ('motor_inertia', (2,), ((5, 5), (5, 11), (8, 8), (8, 11), (11, 11)), ()),
    ('gear_ratio', (0,), ((3, 3), (3, 9), (6, 6), (6, 9), (9, 9)), ()),
    ('gear_ratio', (1,), ((4, 4), (4, 10), (7, 7), (7, 10), (10, 10)), ()),
    ('gear_ratio', (2,), ((5, 5), (5, 11), (8, 8), (8, 11), (11, 11)), ()),
    ('limits', (0, 0), ((0, 0), (0, 6), (0, 15), (3, 3), (3, 6), (6, 6), (6, 15), (15, 15)),
     ((0, 0), (0, 6), (0, 15), (3, 3), (3, 6), (6, 6), (6, 15), (15, 15))),
    ('limits', (0, 1), ((0, 0), (0, 3), (0, 15), (3, 3), (3, 6), (3, 15), (6, 6), (15, 15)),
     ((0, 0), (0, 3), (0, 15), (3, 3), (3, 6), (3, 15), (6, 6), (15, 15))),
    ('limits', (1, 0), ((1, 1), (1, 7), (1, 16), (4, 4), (4, 7), (7, 7), (7, 16), (16, 16)),
     ((1, 1), (1, 7), (1, 16), (4, 4), (4, 7), (7, 7), (7, 16), (16, 16))),
    ('limits', (1, 1), ((1, 1), (1, 4), (1, 16), (4, 4), (4, 7), (4, 16), (7, 7), (16, 16)),
     ((1, 1), (1, 4), (1, 16), (4, 4), (4, 7), (4, 16), (7, 7), (16, 16))),
    ('limits', (2, 0), ((2, 2), (2, 8), (2, 17), (5, 5), (5, 8), (8, 8), (8, 17), (17, 17)),
     ((2, 2), (2, 8), (2, 17), (5, 5), (5, 8), (8, 8), (8, 17), (17, 17))),
    ('limits', (2, 1), ((2, 2), (2, 5), (2, 17), (5, 5), (5, 8), (5, 17), (8, 8), (17, 17)),
     ((2, 2), (2, 5), (2, 17), (5, 5), (5, 8), (5, 17), (8, 8), (17, 17))),
    ('axis_belt_stiffness_factor_1', (), (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (3, 3), (3, 6), (3, 15), (6, 6), (6, 15), (15, 15))),
    ('axis_belt_stiffness_factor_2', (), (),
     ((1, 1), (1, 4), (1, 7), (1, 16), (4, 4), (4, 7), (4, 16), (7, 7), (7, 16), (16, 16))),
    ('axis_belt_stiffness_factor_3', (), (),
     ((2, 2), (2, 5), (2, 8), (2, 17), (5, 5), (5, 8), (5, 17), (8, 8), (8, 17), (17, 17))),
    ('belt_end_compliance_compliance', (), (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (1, 1), (1, 4), (1, 7), (1, 16), (2, 2), (2, 5), (2, 8), (2, 17),
      (3, 3), (3, 6), (3, 15), (4, 4), (4, 7), (4, 16), (5, 5), (5, 8), (5, 17), (6, 6), (6, 15),
      (7, 7), (7, 16), (8, 8), (8, 17), (15, 15), (16, 16), (17, 17))),
    ('belt_loss_loss_factor', (), (), ()),
    ('belt_mass_linear_density', (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (1, 1), (1, 4), (1, 7), (1, 16), (2, 2), (2, 5), (2, 8), (2, 17),
      (3, 3), (3, 6), (3, 15), (4, 4), (4, 7), (4, 16), (5, 5), (5, 8), (5, 17), (6, 6), (6, 15),
      (7, 7), (7, 16), (8, 8), (8, 17), (15, 15), (16, 16), (17, 17)),
     ()),
    ('belt_tension_stiffness_coefficient', (), (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (1, 1), (1, 4), (1, 7), (1, 16), (2, 2), (2, 5), (2, 8), (2, 17),
      (3, 3), (3, 6), (3, 15), (4, 4), (4, 7), (4, 16), (5, 5), (5, 8), (5, 17), (6, 6), (6, 15),
      (7, 7), (7, 16), (8, 8), (8, 17), (15, 15), (16, 16), (17, 17))),
    ('belt_tension_stiffness_tension', (), (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (1, 1), (1, 4), (1, 7), (1, 16), (2, 2), (2, 5), (2, 8), (2, 17),
      (3, 3), (3, 6), (3, 15), (4, 4), (4, 7), (4, 16), (5, 5), (5, 8), (5, 17), (6, 6), (6, 15),
      (7, 7), (7, 16), (8, 8), (8, 17), (15, 15), (16, 16), (17, 17))),
    ('cable_stiffness_stiffness', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20))),
    ('drive_friction_viscous', (), (), ()),
    ('gearbox_inertia_inertia', (), ((3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8)), ()),
    ('payload_mass', (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('rail_friction_viscous', (), (), ()),
    ('reducer_loss_loss_factor', (), (), ()),
    ('servo_stiffness_stiffness', (), (),
     ((3, 3), (3, 9), (4, 4), (4, 10), (5, 5), (5, 11), (6, 6), (6, 9), (7, 7), (7, 10), (8, 8),
      (8, 11), (9, 9), (10, 10), (11, 11))),
    ('frame_compliance_mass', (), ((18, 18), (19, 19), (20, 20)), ()),
)

#: The same for `geometry_sensitivities`.
GEOMETRY_SENSITIVITIES = (
    ('joint', (0, 0),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20),
      (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 15), (0, 18), (0, 19),
      (0, 20), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (15, 15))),
    ('joint', (0, 1),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20),
      (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 15), (0, 18), (0, 19),
      (0, 20), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (15, 15))),
    ('joint', (0, 2),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20),
      (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 15), (0, 18), (0, 19),
      (0, 20), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (15, 15))),
    ('joint', (1, 0),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 16), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (16, 16))),
    ('joint', (1, 1),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 16), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (16, 16))),
    ('joint', (1, 2),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 16), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (16, 16))),
    ('joint', (2, 0),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 17), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (17, 17))),
    ('joint', (2, 1),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 17), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (17, 17))),
    ('joint', (2, 2),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 17), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (17, 17))),
    ('link_length', (0,),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20),
      (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 3), (0, 6), (0, 12), (0, 13), (0, 14), (0, 15), (0, 18), (0, 19),
      (0, 20), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (3, 3), (3, 15), (6, 6), (6, 15), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (15, 15))),
    ('link_length', (1,),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 4), (1, 7), (1, 12), (1, 13), (1, 14), (1, 16), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12),
      (2, 13), (2, 14), (2, 18), (2, 19), (2, 20), (4, 4), (4, 16), (7, 7), (7, 16), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (16, 16))),
    ('link_length', (2,),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 5), (2, 8), (2, 12), (2, 13),
      (2, 14), (2, 17), (2, 18), (2, 19), (2, 20), (5, 5), (5, 17), (8, 8), (8, 17), (12, 12), (12, 13),
      (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14), (13, 18), (13, 19), (13, 20),
      (14, 14), (14, 18), (14, 19), (14, 20), (17, 17))),
)


class Effects(NamedTuple):
    """Effects of a robot; every field may have its own leading batch axes.

    Attributes
    ----------
    axis_belt_stiffness_factor_1 : float or array, shape (...) [1]
        Relative change of the stiffness of belt 1.
    axis_belt_stiffness_factor_2 : float or array, shape (...) [1]
        Relative change of the stiffness of belt 2.
    axis_belt_stiffness_factor_3 : float or array, shape (...) [1]
        Relative change of the stiffness of belt 3.
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
    link_compliance_compliance : float or array, shape (...) [m/N]
        Axial compliance of every linkage.
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
    frame_compliance_compliance_z : float or array, shape (...) [m/N]
        Compliance of the frame along z.
    """

    axis_belt_stiffness_factor_1: float = 0.0
    axis_belt_stiffness_factor_2: float = 0.0
    axis_belt_stiffness_factor_3: float = 0.0
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
    link_compliance_compliance: float = 0.0
    clamp_compliance_compliance: float = 0.0
    frame_compliance_compliance: float = 0.0
    frame_compliance_mass: float = 0.0
    frame_compliance_compliance_x: float = 0.0
    frame_compliance_compliance_y: float = 0.0
    frame_compliance_compliance_z: float = 0.0


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
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.
    effects : Effects
        The robot's effects.

    Returns
    -------
    M : array, shape (..., 21, 21) [kg, kg m, kg m^2]
        Mass matrix; its leading block is that of the base model.
    K_el : array, shape (..., 21, 21) [N/m, N, N m]
        Elastic stiffness with free joints.
    K_g : array, shape (..., 21, 21) [N/m, N, N m]
        Hessian of the gravitational potential energy.

    Notes
    -----
    Equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses.
    1245 operations; 2335836 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    I_p_1, I_p_2, I_p_3 = _entries(parameters.pulley_inertia, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (a_B_3,) = _entries(effects.axis_belt_stiffness_factor_3, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (I_G,) = _entries(effects.gearbox_inertia_inertia, ())
    (m_L,) = _entries(effects.payload_mass, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    (m_F,) = _entries(effects.frame_compliance_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, I_p_1, I_m_1, i_g_1, d_1_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, c_T, F_T, k_C,
        I_G, m_L, k_S, m_F)
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
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    t11 = I_m_1*i_g_1**2
    t12 = I_G + t11
    I_1_1 = I_p_1 + d_1_1*t12
    I_1_2 = I_p_1 + d_1_2*t12
    t13 = I_m_2*i_g_2**2
    t14 = I_G + t13
    I_2_1 = I_p_2 + d_2_1*t14
    I_2_2 = I_p_2 + d_2_2*t14
    t15 = I_m_3*i_g_3**2
    t16 = I_G + t15
    I_3_1 = I_p_3 + d_3_1*t16
    I_3_2 = I_p_3 + d_3_2*t16
    l_f_1_1 = x_max_1 - x_min_1
    t17 = F_T*c_T + 1
    t18 = c_E*t17
    t19 = k_sp_1*w_b_1*(a_B_1 + 1)
    t20 = t18*t19
    t21 = t17*t19
    k_1_1 = t21/(l_f_1_1 + t20)
    t22 = (1/2)*l_t_1
    l_f_1_2 = -t22 + x_1 - x_min_1
    k_1_2 = t21/(l_f_1_2 + t20)
    l_f_1_3 = -t22 - x_1 + x_max_1
    k_1_3 = t21/(l_f_1_3 + t20)
    l_f_2_1 = x_max_2 - x_min_2
    t23 = k_sp_2*w_b_2*(a_B_2 + 1)
    t24 = t18*t23
    t25 = t17*t23
    k_2_1 = t25/(l_f_2_1 + t24)
    t26 = (1/2)*l_t_2
    l_f_2_2 = -t26 + x_2 - x_min_2
    k_2_2 = t25/(l_f_2_2 + t24)
    l_f_2_3 = -t26 - x_2 + x_max_2
    k_2_3 = t25/(l_f_2_3 + t24)
    l_f_3_1 = x_max_3 - x_min_3
    t27 = k_sp_3*w_b_3*(a_B_3 + 1)
    t28 = t18*t27
    t29 = t17*t27
    k_3_1 = t29/(l_f_3_1 + t28)
    t30 = (1/2)*l_t_3
    l_f_3_2 = -t30 + x_3 - x_min_3
    k_3_2 = t29/(l_f_3_2 + t28)
    l_f_3_3 = -t30 - x_3 + x_max_3
    k_3_3 = t29/(l_f_3_3 + t28)
    t31 = (1/2)*m_d_1
    t32 = (1/2)*m_d_2
    t33 = (1/2)*m_d_3
    t34 = m_L + m_p
    t35 = t31 + t32 + t33 + t34
    t36 = g_x*t35
    t37 = g_y*t35
    t38 = g_z*t35
    mu_1 = t1*(-A_x_1*t36 - A_y_1*t37 - A_z_1*t38)
    mu_2 = t1*(-A_x_2*t36 - A_y_2*t37 - A_z_2*t38)
    mu_3 = t1*(-A_x_3*t36 - A_y_3*t37 - A_z_3*t38)
    t39 = (1/3)*m_d_1
    t40 = (1/6)*m_d_1
    t41 = n_1_x*t40
    t42 = (1/3)*m_d_2
    t43 = (1/3)*m_d_3
    t44 = t34 + t39 + t42 + t43
    t45 = D_p_x_1*t44
    t46 = t41 + t45
    t47 = n_1_y*t40
    t48 = D_p_y_1*t44
    t49 = t47 + t48
    t50 = n_1_z*t40
    t51 = D_p_z_1*t44
    t52 = t50 + t51
    t53 = (1/3)*rho_b
    t54 = l_f_1_2*t53
    t55 = l_f_1_3*t53
    t56 = t54 + t55
    t57 = (1/6)*m_d_2
    t58 = n_2_x*t57
    t59 = n_2_y*t57
    t60 = n_2_z*t57
    t61 = (1/6)*m_d_3
    t62 = n_3_x*t61
    t63 = n_3_y*t61
    t64 = n_3_z*t61
    t65 = (1/6)*rho_b
    t66 = R_p_1*t65
    t67 = l_f_1_3*t66
    t68 = l_f_1_2*t66
    t69 = t40 + t57 + t61
    t70 = D_p_x_2*t44
    t71 = t58 + t70
    t72 = D_p_y_2*t44
    t73 = t59 + t72
    t74 = D_p_z_2*t44
    t75 = t60 + t74
    t76 = l_f_2_2*t53
    t77 = l_f_2_3*t53
    t78 = t76 + t77
    t79 = R_p_2*t65
    t80 = l_f_2_3*t79
    t81 = l_f_2_2*t79
    t82 = D_p_x_3*t44
    t83 = t62 + t82
    t84 = D_p_y_3*t44
    t85 = t63 + t84
    t86 = D_p_z_3*t44
    t87 = t64 + t86
    t88 = l_f_3_2*t53
    t89 = l_f_3_3*t53
    t90 = t88 + t89
    t91 = R_p_3*t65
    t92 = l_f_3_3*t91
    t93 = l_f_3_2*t91
    t94 = R_p_1**2
    t95 = l_f_1_1*t94
    t96 = t53*t95
    t97 = d_1_1*t11
    t98 = R_p_2**2
    t99 = l_f_2_1*t98
    t100 = t53*t99
    t101 = d_2_1*t13
    t102 = R_p_3**2
    t103 = l_f_3_1*t102
    t104 = t103*t53
    t105 = d_3_1*t15
    t106 = d_1_2*t11
    t107 = d_2_2*t13
    t108 = d_3_2*t15
    t109 = D_delta_x_1**2
    t110 = D_delta_y_1**2
    t111 = D_delta_z_1**2
    t112 = D_delta_x_1*t44
    t113 = D_delta_y_1*t44
    t114 = D_delta_z_1*t44
    t115 = D_delta_x_2**2
    t116 = D_delta_y_2**2
    t117 = D_delta_z_2**2
    t118 = D_delta_x_2*t44
    t119 = D_delta_y_2*t44
    t120 = D_delta_z_2*t44
    t121 = D_delta_x_3**2
    t122 = D_delta_y_3**2
    t123 = D_delta_z_3**2
    t124 = m_F + m_d_1 + m_d_2 + m_d_3 + m_t_1 + m_t_2 + m_t_3 + t34
    t125 = D_p_x_1**2
    t126 = D_p_y_1**2
    t127 = D_p_z_1**2
    t128 = k_1_2 + k_1_3
    t129 = D_p_x_1*k_C
    t130 = D_p_y_1*k_C
    t131 = D_p_z_1*k_C
    t132 = -R_p_1*k_1_3
    t133 = -R_p_1*k_1_2
    t134 = D_p_x_2**2
    t135 = D_p_y_2**2
    t136 = D_p_z_2**2
    t137 = k_2_2 + k_2_3
    t138 = D_p_x_2*k_C
    t139 = D_p_y_2*k_C
    t140 = D_p_z_2*k_C
    t141 = -R_p_2*k_2_3
    t142 = -R_p_2*k_2_2
    t143 = D_p_x_3**2
    t144 = D_p_y_3**2
    t145 = D_p_z_3**2
    t146 = k_3_2 + k_3_3
    t147 = -R_p_3*k_3_3
    t148 = -R_p_3*k_3_2
    t149 = D_p_x_3*k_C
    t150 = D_p_y_3*k_C
    t151 = D_p_z_3*k_C
    t152 = d_1_1*k_S
    t153 = k_1_1*t94
    t154 = d_2_1*k_S
    t155 = k_2_1*t98
    t156 = d_3_1*k_S
    t157 = k_3_1*t102
    t158 = d_1_2*k_S
    t159 = d_2_2*k_S
    t160 = d_3_2*k_S
    t161 = D_delta_x_1*k_C
    t162 = D_delta_y_1*k_C
    t163 = D_delta_z_1*k_C
    t164 = D_delta_x_2*k_C
    t165 = D_delta_y_2*k_C
    t166 = D_delta_z_2*k_C
    t167 = D_p_x_1*mu_3
    t168 = D_p_x_1*mu_2
    t169 = U_1_x_1*mu_1
    t170 = D_p_y_1*mu_3
    t171 = D_p_y_1*mu_2
    t172 = U_1_y_1*mu_1
    t173 = D_p_z_1*mu_3
    t174 = D_p_z_1*mu_2
    t175 = U_1_z_1*mu_1
    t176 = D_p_x_2*mu_1
    t177 = D_p_x_2*mu_3
    t178 = U_2_x_2*mu_2
    t179 = D_p_y_2*mu_1
    t180 = D_p_y_2*mu_3
    t181 = U_2_y_2*mu_2
    t182 = D_p_z_2*mu_1
    t183 = D_p_z_2*mu_3
    t184 = U_2_z_2*mu_2
    t185 = D_delta_x_1*D_p_x_3
    t186 = U_3_x_3*mu_3
    t187 = D_delta_y_1*D_p_y_3
    t188 = U_3_y_3*mu_3
    t189 = D_delta_z_1*D_p_z_3
    t190 = U_3_z_3*mu_3
    t191 = D_delta_x_2*D_p_x_3
    t192 = D_delta_y_2*D_p_y_3
    t193 = D_delta_z_2*D_p_z_3
    t194 = D_delta_x_3*D_p_x_3
    t195 = D_delta_y_3*D_p_y_3
    t196 = D_delta_z_3*D_p_z_3
    t197 = D_delta_x_1*D_delta_x_2
    t198 = D_delta_y_1*D_delta_y_2
    t199 = D_delta_z_1*D_delta_z_2
    t200 = D_delta_x_1*D_delta_x_3
    t201 = D_delta_y_1*D_delta_y_3
    t202 = D_delta_z_1*D_delta_z_3
    t203 = D_delta_x_2*D_delta_x_3
    t204 = D_delta_y_2*D_delta_y_3
    t205 = D_delta_z_2*D_delta_z_3
    M_out = np.zeros((*batch, 21, 21), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t41 + D_p_x_1*t46 + D_p_y_1*t47 + D_p_y_1*t49 + D_p_z_1*t50 + D_p_z_1*t52 + m_t_1 + t39 + t56
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_x_1*t58 + D_p_x_2*t46 + D_p_y_1*t59 + D_p_y_2*t49 + D_p_z_1*t60 + D_p_z_2*t52
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_x_1*t62 + D_p_x_3*t46 + D_p_y_1*t63 + D_p_y_3*t49 + D_p_z_1*t64 + D_p_z_3*t52
    )
    M_out[..., 0, 3] = M_out[..., 3, 0] = t67
    M_out[..., 0, 6] = M_out[..., 6, 0] = t68
    M_out[..., 0, 12] = M_out[..., 12, 0] = D_delta_x_1*t46 + D_delta_y_1*t49 + D_delta_z_1*t52
    M_out[..., 0, 13] = M_out[..., 13, 0] = D_delta_x_2*t46 + D_delta_y_2*t49 + D_delta_z_2*t52
    M_out[..., 0, 14] = M_out[..., 14, 0] = D_delta_x_3*t46 + D_delta_y_3*t49 + D_delta_z_3*t52
    M_out[..., 0, 15] = M_out[..., 15, 0] = t56
    M_out[..., 0, 18] = M_out[..., 18, 0] = D_p_x_1*t69 + m_t_1*n_1_x + n_1_x*t31 + t45
    M_out[..., 0, 19] = M_out[..., 19, 0] = D_p_y_1*t69 + m_t_1*n_1_y + n_1_y*t31 + t48
    M_out[..., 0, 20] = M_out[..., 20, 0] = D_p_z_1*t69 + m_t_1*n_1_z + n_1_z*t31 + t51
    M_out[..., 1, 1] = (
        D_p_x_2*t58 + D_p_x_2*t71 + D_p_y_2*t59 + D_p_y_2*t73 + D_p_z_2*t60 + D_p_z_2*t75 + m_t_2 + t42 + t78
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_x_2*t62 + D_p_x_3*t71 + D_p_y_2*t63 + D_p_y_3*t73 + D_p_z_2*t64 + D_p_z_3*t75
    )
    M_out[..., 1, 4] = M_out[..., 4, 1] = t80
    M_out[..., 1, 7] = M_out[..., 7, 1] = t81
    M_out[..., 1, 12] = M_out[..., 12, 1] = D_delta_x_1*t71 + D_delta_y_1*t73 + D_delta_z_1*t75
    M_out[..., 1, 13] = M_out[..., 13, 1] = D_delta_x_2*t71 + D_delta_y_2*t73 + D_delta_z_2*t75
    M_out[..., 1, 14] = M_out[..., 14, 1] = D_delta_x_3*t71 + D_delta_y_3*t73 + D_delta_z_3*t75
    M_out[..., 1, 16] = M_out[..., 16, 1] = t78
    M_out[..., 1, 18] = M_out[..., 18, 1] = D_p_x_2*t69 + m_t_2*n_2_x + n_2_x*t32 + t70
    M_out[..., 1, 19] = M_out[..., 19, 1] = D_p_y_2*t69 + m_t_2*n_2_y + n_2_y*t32 + t72
    M_out[..., 1, 20] = M_out[..., 20, 1] = D_p_z_2*t69 + m_t_2*n_2_z + n_2_z*t32 + t74
    M_out[..., 2, 2] = (
        D_p_x_3*t62 + D_p_x_3*t83 + D_p_y_3*t63 + D_p_y_3*t85 + D_p_z_3*t64 + D_p_z_3*t87 + m_t_3 + t43 + t90
    )
    M_out[..., 2, 5] = M_out[..., 5, 2] = t92
    M_out[..., 2, 8] = M_out[..., 8, 2] = t93
    M_out[..., 2, 12] = M_out[..., 12, 2] = D_delta_x_1*t83 + D_delta_y_1*t85 + D_delta_z_1*t87
    M_out[..., 2, 13] = M_out[..., 13, 2] = D_delta_x_2*t83 + D_delta_y_2*t85 + D_delta_z_2*t87
    M_out[..., 2, 14] = M_out[..., 14, 2] = D_delta_x_3*t83 + D_delta_y_3*t85 + D_delta_z_3*t87
    M_out[..., 2, 17] = M_out[..., 17, 2] = t90
    M_out[..., 2, 18] = M_out[..., 18, 2] = D_p_x_3*t69 + m_t_3*n_3_x + n_3_x*t33 + t82
    M_out[..., 2, 19] = M_out[..., 19, 2] = D_p_y_3*t69 + m_t_3*n_3_y + n_3_y*t33 + t84
    M_out[..., 2, 20] = M_out[..., 20, 2] = D_p_z_3*t69 + m_t_3*n_3_z + n_3_z*t33 + t86
    M_out[..., 3, 3] = I_1_1 + t55*t94 + t96
    M_out[..., 3, 6] = M_out[..., 6, 3] = t65*t95
    M_out[..., 3, 9] = M_out[..., 9, 3] = t97
    M_out[..., 3, 15] = M_out[..., 15, 3] = t67
    M_out[..., 4, 4] = I_2_1 + t100 + t77*t98
    M_out[..., 4, 7] = M_out[..., 7, 4] = t65*t99
    M_out[..., 4, 10] = M_out[..., 10, 4] = t101
    M_out[..., 4, 16] = M_out[..., 16, 4] = t80
    M_out[..., 5, 5] = I_3_1 + t102*t89 + t104
    M_out[..., 5, 8] = M_out[..., 8, 5] = t103*t65
    M_out[..., 5, 11] = M_out[..., 11, 5] = t105
    M_out[..., 5, 17] = M_out[..., 17, 5] = t92
    M_out[..., 6, 6] = I_1_2 + t54*t94 + t96
    M_out[..., 6, 9] = M_out[..., 9, 6] = t106
    M_out[..., 6, 15] = M_out[..., 15, 6] = t68
    M_out[..., 7, 7] = I_2_2 + t100 + t76*t98
    M_out[..., 7, 10] = M_out[..., 10, 7] = t107
    M_out[..., 7, 16] = M_out[..., 16, 7] = t81
    M_out[..., 8, 8] = I_3_2 + t102*t88 + t104
    M_out[..., 8, 11] = M_out[..., 11, 8] = t108
    M_out[..., 8, 17] = M_out[..., 17, 8] = t93
    M_out[..., 9, 9] = t106 + t97
    M_out[..., 10, 10] = t101 + t107
    M_out[..., 11, 11] = t105 + t108
    M_out[..., 12, 12] = t109*t44 + t110*t44 + t111*t44
    M_out[..., 12, 13] = M_out[..., 13, 12] = D_delta_x_2*t112 + D_delta_y_2*t113 + D_delta_z_2*t114
    M_out[..., 12, 14] = M_out[..., 14, 12] = D_delta_x_3*t112 + D_delta_y_3*t113 + D_delta_z_3*t114
    M_out[..., 12, 18] = M_out[..., 18, 12] = D_delta_x_1*t69 + t112
    M_out[..., 12, 19] = M_out[..., 19, 12] = D_delta_y_1*t69 + t113
    M_out[..., 12, 20] = M_out[..., 20, 12] = D_delta_z_1*t69 + t114
    M_out[..., 13, 13] = t115*t44 + t116*t44 + t117*t44
    M_out[..., 13, 14] = M_out[..., 14, 13] = D_delta_x_3*t118 + D_delta_y_3*t119 + D_delta_z_3*t120
    M_out[..., 13, 18] = M_out[..., 18, 13] = D_delta_x_2*t69 + t118
    M_out[..., 13, 19] = M_out[..., 19, 13] = D_delta_y_2*t69 + t119
    M_out[..., 13, 20] = M_out[..., 20, 13] = D_delta_z_2*t69 + t120
    M_out[..., 14, 14] = t121*t44 + t122*t44 + t123*t44
    M_out[..., 14, 18] = M_out[..., 18, 14] = D_delta_x_3*t44 + D_delta_x_3*t69
    M_out[..., 14, 19] = M_out[..., 19, 14] = D_delta_y_3*t44 + D_delta_y_3*t69
    M_out[..., 14, 20] = M_out[..., 20, 14] = D_delta_z_3*t44 + D_delta_z_3*t69
    M_out[..., 15, 15] = t56
    M_out[..., 16, 16] = t78
    M_out[..., 17, 17] = t90
    M_out[..., 18, 18] = t124
    M_out[..., 19, 19] = t124
    M_out[..., 20, 20] = t124
    K_el_out = np.zeros((*batch, 21, 21), dtype)
    K_el_out[..., 0, 0] = k_C*t125 + k_C*t126 + k_C*t127 + t128
    K_el_out[..., 0, 1] = K_el_out[..., 1, 0] = D_p_x_2*t129 + D_p_y_2*t130 + D_p_z_2*t131
    K_el_out[..., 0, 2] = K_el_out[..., 2, 0] = D_p_x_3*t129 + D_p_y_3*t130 + D_p_z_3*t131
    K_el_out[..., 0, 3] = K_el_out[..., 3, 0] = t132
    K_el_out[..., 0, 6] = K_el_out[..., 6, 0] = t133
    K_el_out[..., 0, 12] = K_el_out[..., 12, 0] = D_delta_x_1*t129 + D_delta_y_1*t130 + D_delta_z_1*t131
    K_el_out[..., 0, 13] = K_el_out[..., 13, 0] = D_delta_x_2*t129 + D_delta_y_2*t130 + D_delta_z_2*t131
    K_el_out[..., 0, 14] = K_el_out[..., 14, 0] = D_delta_x_3*t129 + D_delta_y_3*t130 + D_delta_z_3*t131
    K_el_out[..., 0, 15] = K_el_out[..., 15, 0] = t128
    K_el_out[..., 0, 18] = K_el_out[..., 18, 0] = t129
    K_el_out[..., 0, 19] = K_el_out[..., 19, 0] = t130
    K_el_out[..., 0, 20] = K_el_out[..., 20, 0] = t131
    K_el_out[..., 1, 1] = k_C*t134 + k_C*t135 + k_C*t136 + t137
    K_el_out[..., 1, 2] = K_el_out[..., 2, 1] = D_p_x_3*t138 + D_p_y_3*t139 + D_p_z_3*t140
    K_el_out[..., 1, 4] = K_el_out[..., 4, 1] = t141
    K_el_out[..., 1, 7] = K_el_out[..., 7, 1] = t142
    K_el_out[..., 1, 12] = K_el_out[..., 12, 1] = D_delta_x_1*t138 + D_delta_y_1*t139 + D_delta_z_1*t140
    K_el_out[..., 1, 13] = K_el_out[..., 13, 1] = D_delta_x_2*t138 + D_delta_y_2*t139 + D_delta_z_2*t140
    K_el_out[..., 1, 14] = K_el_out[..., 14, 1] = D_delta_x_3*t138 + D_delta_y_3*t139 + D_delta_z_3*t140
    K_el_out[..., 1, 16] = K_el_out[..., 16, 1] = t137
    K_el_out[..., 1, 18] = K_el_out[..., 18, 1] = t138
    K_el_out[..., 1, 19] = K_el_out[..., 19, 1] = t139
    K_el_out[..., 1, 20] = K_el_out[..., 20, 1] = t140
    K_el_out[..., 2, 2] = k_C*t143 + k_C*t144 + k_C*t145 + t146
    K_el_out[..., 2, 5] = K_el_out[..., 5, 2] = t147
    K_el_out[..., 2, 8] = K_el_out[..., 8, 2] = t148
    K_el_out[..., 2, 12] = K_el_out[..., 12, 2] = D_delta_x_1*t149 + D_delta_y_1*t150 + D_delta_z_1*t151
    K_el_out[..., 2, 13] = K_el_out[..., 13, 2] = D_delta_x_2*t149 + D_delta_y_2*t150 + D_delta_z_2*t151
    K_el_out[..., 2, 14] = K_el_out[..., 14, 2] = D_delta_x_3*t149 + D_delta_y_3*t150 + D_delta_z_3*t151
    K_el_out[..., 2, 17] = K_el_out[..., 17, 2] = t146
    K_el_out[..., 2, 18] = K_el_out[..., 18, 2] = t149
    K_el_out[..., 2, 19] = K_el_out[..., 19, 2] = t150
    K_el_out[..., 2, 20] = K_el_out[..., 20, 2] = t151
    K_el_out[..., 3, 3] = k_1_3*t94 + t152 + t153
    K_el_out[..., 3, 6] = K_el_out[..., 6, 3] = -t153
    K_el_out[..., 3, 9] = K_el_out[..., 9, 3] = t152
    K_el_out[..., 3, 15] = K_el_out[..., 15, 3] = t132
    K_el_out[..., 4, 4] = k_2_3*t98 + t154 + t155
    K_el_out[..., 4, 7] = K_el_out[..., 7, 4] = -t155
    K_el_out[..., 4, 10] = K_el_out[..., 10, 4] = t154
    K_el_out[..., 4, 16] = K_el_out[..., 16, 4] = t141
    K_el_out[..., 5, 5] = k_3_3*t102 + t156 + t157
    K_el_out[..., 5, 8] = K_el_out[..., 8, 5] = -t157
    K_el_out[..., 5, 11] = K_el_out[..., 11, 5] = t156
    K_el_out[..., 5, 17] = K_el_out[..., 17, 5] = t147
    K_el_out[..., 6, 6] = k_1_2*t94 + t153 + t158
    K_el_out[..., 6, 9] = K_el_out[..., 9, 6] = t158
    K_el_out[..., 6, 15] = K_el_out[..., 15, 6] = t133
    K_el_out[..., 7, 7] = k_2_2*t98 + t155 + t159
    K_el_out[..., 7, 10] = K_el_out[..., 10, 7] = t159
    K_el_out[..., 7, 16] = K_el_out[..., 16, 7] = t142
    K_el_out[..., 8, 8] = k_3_2*t102 + t157 + t160
    K_el_out[..., 8, 11] = K_el_out[..., 11, 8] = t160
    K_el_out[..., 8, 17] = K_el_out[..., 17, 8] = t148
    K_el_out[..., 9, 9] = t152 + t158
    K_el_out[..., 10, 10] = t154 + t159
    K_el_out[..., 11, 11] = t156 + t160
    K_el_out[..., 12, 12] = k_C*t109 + k_C*t110 + k_C*t111
    K_el_out[..., 12, 13] = K_el_out[..., 13, 12] = D_delta_x_2*t161 + D_delta_y_2*t162 + D_delta_z_2*t163
    K_el_out[..., 12, 14] = K_el_out[..., 14, 12] = D_delta_x_3*t161 + D_delta_y_3*t162 + D_delta_z_3*t163
    K_el_out[..., 12, 18] = K_el_out[..., 18, 12] = t161
    K_el_out[..., 12, 19] = K_el_out[..., 19, 12] = t162
    K_el_out[..., 12, 20] = K_el_out[..., 20, 12] = t163
    K_el_out[..., 13, 13] = k_C*t115 + k_C*t116 + k_C*t117
    K_el_out[..., 13, 14] = K_el_out[..., 14, 13] = D_delta_x_3*t164 + D_delta_y_3*t165 + D_delta_z_3*t166
    K_el_out[..., 13, 18] = K_el_out[..., 18, 13] = t164
    K_el_out[..., 13, 19] = K_el_out[..., 19, 13] = t165
    K_el_out[..., 13, 20] = K_el_out[..., 20, 13] = t166
    K_el_out[..., 14, 14] = k_C*t121 + k_C*t122 + k_C*t123
    K_el_out[..., 14, 18] = K_el_out[..., 18, 14] = D_delta_x_3*k_C
    K_el_out[..., 14, 19] = K_el_out[..., 19, 14] = D_delta_y_3*k_C
    K_el_out[..., 14, 20] = K_el_out[..., 20, 14] = D_delta_z_3*k_C
    K_el_out[..., 15, 15] = t128
    K_el_out[..., 16, 16] = t137
    K_el_out[..., 17, 17] = t146
    K_el_out[..., 18, 18] = k_C
    K_el_out[..., 19, 19] = k_C
    K_el_out[..., 20, 20] = k_C
    K_g_out = np.zeros((*batch, 21, 21), dtype)
    K_g_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 - mu_2*t125 - mu_2*t126 - mu_2*t127 - mu_3*t125
        - mu_3*t126 - mu_3*t127
    )
    K_g_out[..., 0, 1] = K_g_out[..., 1, 0] = (
        -D_p_x_2*t167 - D_p_x_2*t169 - D_p_y_2*t170 - D_p_y_2*t172 - D_p_z_2*t173 - D_p_z_2*t175
        - U_2_x_2*t168 - U_2_y_2*t171 - U_2_z_2*t174
    )
    K_g_out[..., 0, 2] = K_g_out[..., 2, 0] = (
        -D_p_x_3*t168 - D_p_x_3*t169 - D_p_y_3*t171 - D_p_y_3*t172 - D_p_z_3*t174 - D_p_z_3*t175
        - U_3_x_3*t167 - U_3_y_3*t170 - U_3_z_3*t173
    )
    K_g_out[..., 0, 12] = K_g_out[..., 12, 0] = (
        -D_delta_x_1*t167 - D_delta_x_1*t168 - D_delta_x_1*t169 - D_delta_y_1*t170 - D_delta_y_1*t171
        - D_delta_y_1*t172 - D_delta_z_1*t173 - D_delta_z_1*t174 - D_delta_z_1*t175
    )
    K_g_out[..., 0, 13] = K_g_out[..., 13, 0] = (
        -D_delta_x_2*t167 - D_delta_x_2*t168 - D_delta_x_2*t169 - D_delta_y_2*t170 - D_delta_y_2*t171
        - D_delta_y_2*t172 - D_delta_z_2*t173 - D_delta_z_2*t174 - D_delta_z_2*t175
    )
    K_g_out[..., 0, 14] = K_g_out[..., 14, 0] = (
        -D_delta_x_3*t167 - D_delta_x_3*t168 - D_delta_x_3*t169 - D_delta_y_3*t170 - D_delta_y_3*t171
        - D_delta_y_3*t172 - D_delta_z_3*t173 - D_delta_z_3*t174 - D_delta_z_3*t175
    )
    K_g_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 - mu_1*t134 - mu_1*t135 - mu_1*t136 - mu_3*t134
        - mu_3*t135 - mu_3*t136
    )
    K_g_out[..., 1, 2] = K_g_out[..., 2, 1] = (
        -D_p_x_3*t176 - D_p_x_3*t178 - D_p_y_3*t179 - D_p_y_3*t181 - D_p_z_3*t182 - D_p_z_3*t184
        - U_3_x_3*t177 - U_3_y_3*t180 - U_3_z_3*t183
    )
    K_g_out[..., 1, 12] = K_g_out[..., 12, 1] = (
        -D_delta_x_1*t176 - D_delta_x_1*t177 - D_delta_x_1*t178 - D_delta_y_1*t179 - D_delta_y_1*t180
        - D_delta_y_1*t181 - D_delta_z_1*t182 - D_delta_z_1*t183 - D_delta_z_1*t184
    )
    K_g_out[..., 1, 13] = K_g_out[..., 13, 1] = (
        -D_delta_x_2*t176 - D_delta_x_2*t177 - D_delta_x_2*t178 - D_delta_y_2*t179 - D_delta_y_2*t180
        - D_delta_y_2*t181 - D_delta_z_2*t182 - D_delta_z_2*t183 - D_delta_z_2*t184
    )
    K_g_out[..., 1, 14] = K_g_out[..., 14, 1] = (
        -D_delta_x_3*t176 - D_delta_x_3*t177 - D_delta_x_3*t178 - D_delta_y_3*t179 - D_delta_y_3*t180
        - D_delta_y_3*t181 - D_delta_z_3*t182 - D_delta_z_3*t183 - D_delta_z_3*t184
    )
    K_g_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 - mu_1*t143 - mu_1*t144 - mu_1*t145 - mu_2*t143
        - mu_2*t144 - mu_2*t145
    )
    K_g_out[..., 2, 12] = K_g_out[..., 12, 2] = (
        -D_delta_x_1*t186 - D_delta_y_1*t188 - D_delta_z_1*t190 - mu_1*t185 - mu_1*t187 - mu_1*t189
        - mu_2*t185 - mu_2*t187 - mu_2*t189
    )
    K_g_out[..., 2, 13] = K_g_out[..., 13, 2] = (
        -D_delta_x_2*t186 - D_delta_y_2*t188 - D_delta_z_2*t190 - mu_1*t191 - mu_1*t192 - mu_1*t193
        - mu_2*t191 - mu_2*t192 - mu_2*t193
    )
    K_g_out[..., 2, 14] = K_g_out[..., 14, 2] = (
        -D_delta_x_3*t186 - D_delta_y_3*t188 - D_delta_z_3*t190 - mu_1*t194 - mu_1*t195 - mu_1*t196
        - mu_2*t194 - mu_2*t195 - mu_2*t196
    )
    K_g_out[..., 12, 12] = (
        -mu_1*t109 - mu_1*t110 - mu_1*t111 + mu_1 - mu_2*t109 - mu_2*t110 - mu_2*t111 - mu_3*t109 - mu_3*t110
        - mu_3*t111
    )
    K_g_out[..., 12, 13] = K_g_out[..., 13, 12] = (
        -mu_1*t197 - mu_1*t198 - mu_1*t199 - mu_2*t197 - mu_2*t198 - mu_2*t199 - mu_3*t197 - mu_3*t198
        - mu_3*t199
    )
    K_g_out[..., 12, 14] = K_g_out[..., 14, 12] = (
        -mu_1*t200 - mu_1*t201 - mu_1*t202 - mu_2*t200 - mu_2*t201 - mu_2*t202 - mu_3*t200 - mu_3*t201
        - mu_3*t202
    )
    K_g_out[..., 13, 13] = (
        -mu_1*t115 - mu_1*t116 - mu_1*t117 - mu_2*t115 - mu_2*t116 - mu_2*t117 + mu_2 - mu_3*t115 - mu_3*t116
        - mu_3*t117
    )
    K_g_out[..., 13, 14] = K_g_out[..., 14, 13] = (
        -mu_1*t203 - mu_1*t204 - mu_1*t205 - mu_2*t203 - mu_2*t204 - mu_2*t205 - mu_3*t203 - mu_3*t204
        - mu_3*t205
    )
    K_g_out[..., 14, 14] = (
        -mu_1*t121 - mu_1*t122 - mu_1*t123 - mu_2*t121 - mu_2*t122 - mu_2*t123 - mu_3*t121 - mu_3*t122
        - mu_3*t123 + mu_3
    )
    return M_out, K_el_out, K_g_out


def extended_platform_motion(p, parameters):
    """Jacobian of the absolute motion of the platform centre.

    Parameters
    ----------
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J_p : array, shape (..., 3, 21) [1, m]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15, with the contributions of released joints and the frame.
    177 operations; 26586 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, sigma_1)
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
    J_p_out = np.zeros((*batch, 3, 21), dtype)
    J_p_out[..., 0, 0] = D_p_x_1
    J_p_out[..., 0, 1] = D_p_x_2
    J_p_out[..., 0, 2] = D_p_x_3
    J_p_out[..., 0, 12] = D_delta_x_1
    J_p_out[..., 0, 13] = D_delta_x_2
    J_p_out[..., 0, 14] = D_delta_x_3
    J_p_out[..., 0, 18] = 1
    J_p_out[..., 1, 0] = D_p_y_1
    J_p_out[..., 1, 1] = D_p_y_2
    J_p_out[..., 1, 2] = D_p_y_3
    J_p_out[..., 1, 12] = D_delta_y_1
    J_p_out[..., 1, 13] = D_delta_y_2
    J_p_out[..., 1, 14] = D_delta_y_3
    J_p_out[..., 1, 19] = 1
    J_p_out[..., 2, 0] = D_p_z_1
    J_p_out[..., 2, 1] = D_p_z_2
    J_p_out[..., 2, 2] = D_p_z_3
    J_p_out[..., 2, 12] = D_delta_z_1
    J_p_out[..., 2, 13] = D_delta_z_2
    J_p_out[..., 2, 14] = D_delta_z_3
    J_p_out[..., 2, 20] = 1
    return J_p_out


def motor_motion(parameters):
    """Jacobian of the angles of the motors, seen at the rotors that they drive.

    Parameters
    ----------
    parameters : Parameters
        The robot's parameters.

    Returns
    -------
    J_m : array, shape (..., 3, 21) [1]
        d(motor angle)/dq_k.

    Notes
    -----
    The drives that the mechanism declares; a gearbox winds up by psi_j on its output side.
    0 operations; 0 with every named value expanded.
    """
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    batch, dtype = _batch(d_1_1)
    J_m_out = np.zeros((*batch, 3, 21), dtype)
    J_m_out[..., 0, 3] = d_1_1
    J_m_out[..., 0, 6] = d_1_2
    J_m_out[..., 0, 9] = 1
    J_m_out[..., 1, 4] = d_2_1
    J_m_out[..., 1, 7] = d_2_2
    J_m_out[..., 1, 10] = 1
    J_m_out[..., 2, 5] = d_3_1
    J_m_out[..., 2, 8] = d_3_2
    J_m_out[..., 2, 11] = 1
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
    kappa : array, shape (..., 12) [N/m, N m]
        Stiffness of each released coordinate, in order.
    kappa_c : array, shape (..., 12) [N^2/m^2, N^2 m^2]
        Derivatives d(kappa)/d(compliance).

    Notes
    -----
    Energy q^2 / (2 c) of each joint.
    27 operations; 54 with every named value expanded.
    """
    (c_G,) = _entries(effects.gearbox_compliance_compliance, ())
    (c_L,) = _entries(effects.link_compliance_compliance, ())
    (c_K,) = _entries(effects.clamp_compliance_compliance, ())
    (c_F,) = _entries(effects.frame_compliance_compliance, ())
    (c_F_x,) = _entries(effects.frame_compliance_compliance_x, ())
    (c_F_y,) = _entries(effects.frame_compliance_compliance_y, ())
    (c_F_z,) = _entries(effects.frame_compliance_compliance_z, ())
    batch, dtype = _batch(c_G, c_L, c_K, c_F, c_F_x, c_F_y, c_F_z)
    t1 = 1.0/c_G
    t2 = 1.0/c_L
    t3 = 1.0/c_K
    t4 = c_F + c_F_x
    t5 = c_F + c_F_y
    t6 = c_F + c_F_z
    t7 = -1/c_G**2
    t8 = -1/c_L**2
    t9 = -1/c_K**2
    kappa_out = np.empty((*batch, 12), dtype)
    kappa_out[..., 0] = t1
    kappa_out[..., 1] = t1
    kappa_out[..., 2] = t1
    kappa_out[..., 3] = t2
    kappa_out[..., 4] = t2
    kappa_out[..., 5] = t2
    kappa_out[..., 6] = t3
    kappa_out[..., 7] = t3
    kappa_out[..., 8] = t3
    kappa_out[..., 9] = 1.0/t4
    kappa_out[..., 10] = 1.0/t5
    kappa_out[..., 11] = 1.0/t6
    kappa_c_out = np.empty((*batch, 12), dtype)
    kappa_c_out[..., 0] = t7
    kappa_c_out[..., 1] = t7
    kappa_c_out[..., 2] = t7
    kappa_c_out[..., 3] = t8
    kappa_c_out[..., 4] = t8
    kappa_c_out[..., 5] = t8
    kappa_c_out[..., 6] = t9
    kappa_c_out[..., 7] = t9
    kappa_c_out[..., 8] = t9
    kappa_c_out[..., 9] = -1/t4**2
    kappa_c_out[..., 10] = -1/t5**2
    kappa_c_out[..., 11] = -1/t6**2
    return kappa_out, kappa_c_out


def extended_dissipation(p, parameters, effects):
    """Viscous damping matrix and loss matrix in the base and all released coordinates, with free joints.

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
    C_v : array, shape (..., 21, 21) [N s/m, N s, N m s]
        Viscous damping matrix.
    K_loss : array, shape (..., 21, 21) [N/m, N, N m]
        Imaginary part of the elastic stiffness; the springs of released joints add theirs.

    Notes
    -----
    Dissipation function R = 1/2 sum b v^2, C_v = d2R/dq_dot2; complex stiffnesses k (1 + i eta).
    220 operations; 9369 with every named value expanded.
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
    (eta_B,) = _entries(effects.belt_loss_loss_factor, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (b_D,) = _entries(effects.drive_friction_viscous, ())
    (b_R,) = _entries(effects.rail_friction_viscous, ())
    batch, dtype = _batch(p_x, o_1_x, n_1_x, b_1_x, l_d_1, l_t_1, k_sp_1, w_b_1, R_p_1, d_1_1, x_min_1,
        sigma_1, a_B_1, a_B_2, a_B_3, c_E, eta_B, c_T, F_T, b_D, b_R)
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
    l_f_1_1 = x_max_1 - x_min_1
    t1 = F_T*c_T + 1
    t2 = c_E*t1
    t3 = a_B_1 + 1
    t4 = k_sp_1*t3*w_b_1
    t5 = t2*t4
    t6 = t1*t4
    k_1_1 = t6/(l_f_1_1 + t5)
    t7 = (1/2)*l_t_1
    l_f_1_2 = -t7 + x_1 - x_min_1
    k_1_2 = t6/(l_f_1_2 + t5)
    l_f_1_3 = -t7 - x_1 + x_max_1
    k_1_3 = t6/(l_f_1_3 + t5)
    l_f_2_1 = x_max_2 - x_min_2
    t8 = a_B_2 + 1
    t9 = k_sp_2*t8*w_b_2
    t10 = t1*t9
    t11 = t2*t9
    k_2_1 = t10/(l_f_2_1 + t11)
    t12 = (1/2)*l_t_2
    l_f_2_2 = -t12 + x_2 - x_min_2
    k_2_2 = t10/(l_f_2_2 + t11)
    l_f_2_3 = -t12 - x_2 + x_max_2
    k_2_3 = t10/(l_f_2_3 + t11)
    l_f_3_1 = x_max_3 - x_min_3
    t13 = a_B_3 + 1
    t14 = k_sp_3*t13*w_b_3
    t15 = t14*t2
    t16 = t1*t14
    k_3_1 = t16/(l_f_3_1 + t15)
    t17 = (1/2)*l_t_3
    l_f_3_2 = -t17 + x_3 - x_min_3
    k_3_2 = t16/(l_f_3_2 + t15)
    l_f_3_3 = -t17 - x_3 + x_max_3
    k_3_3 = t16/(l_f_3_3 + t15)
    t18 = b_D*d_1_1
    t19 = b_D*d_2_1
    t20 = b_D*d_3_1
    t21 = b_D*d_1_2
    t22 = b_D*d_2_2
    t23 = b_D*d_3_2
    t24 = eta_B/t1
    t25 = t24/(k_sp_1*t3*w_b_1)
    t26 = k_1_2**2*l_f_1_2*t25
    t27 = k_1_3**2*l_f_1_3*t25
    t28 = t26 + t27
    t29 = -R_p_1*t27
    t30 = -R_p_1*t26
    t31 = t24/(k_sp_2*t8*w_b_2)
    t32 = k_2_2**2*l_f_2_2*t31
    t33 = k_2_3**2*l_f_2_3*t31
    t34 = t32 + t33
    t35 = -R_p_2*t33
    t36 = -R_p_2*t32
    t37 = t24/(k_sp_3*t13*w_b_3)
    t38 = k_3_2**2*l_f_3_2*t37
    t39 = k_3_3**2*l_f_3_3*t37
    t40 = t38 + t39
    t41 = -R_p_3*t39
    t42 = -R_p_3*t38
    t43 = R_p_1**2
    t44 = k_1_1**2*l_f_1_1*t25*t43
    t45 = R_p_2**2
    t46 = k_2_1**2*l_f_2_1*t31*t45
    t47 = R_p_3**2
    t48 = k_3_1**2*l_f_3_1*t37*t47
    C_v_out = np.zeros((*batch, 21, 21), dtype)
    C_v_out[..., 0, 0] = b_R
    C_v_out[..., 1, 1] = b_R
    C_v_out[..., 2, 2] = b_R
    C_v_out[..., 3, 3] = t18
    C_v_out[..., 3, 9] = C_v_out[..., 9, 3] = t18
    C_v_out[..., 4, 4] = t19
    C_v_out[..., 4, 10] = C_v_out[..., 10, 4] = t19
    C_v_out[..., 5, 5] = t20
    C_v_out[..., 5, 11] = C_v_out[..., 11, 5] = t20
    C_v_out[..., 6, 6] = t21
    C_v_out[..., 6, 9] = C_v_out[..., 9, 6] = t21
    C_v_out[..., 7, 7] = t22
    C_v_out[..., 7, 10] = C_v_out[..., 10, 7] = t22
    C_v_out[..., 8, 8] = t23
    C_v_out[..., 8, 11] = C_v_out[..., 11, 8] = t23
    C_v_out[..., 9, 9] = t18 + t21
    C_v_out[..., 10, 10] = t19 + t22
    C_v_out[..., 11, 11] = t20 + t23
    K_loss_out = np.zeros((*batch, 21, 21), dtype)
    K_loss_out[..., 0, 0] = t28
    K_loss_out[..., 0, 3] = K_loss_out[..., 3, 0] = t29
    K_loss_out[..., 0, 6] = K_loss_out[..., 6, 0] = t30
    K_loss_out[..., 0, 15] = K_loss_out[..., 15, 0] = t28
    K_loss_out[..., 1, 1] = t34
    K_loss_out[..., 1, 4] = K_loss_out[..., 4, 1] = t35
    K_loss_out[..., 1, 7] = K_loss_out[..., 7, 1] = t36
    K_loss_out[..., 1, 16] = K_loss_out[..., 16, 1] = t34
    K_loss_out[..., 2, 2] = t40
    K_loss_out[..., 2, 5] = K_loss_out[..., 5, 2] = t41
    K_loss_out[..., 2, 8] = K_loss_out[..., 8, 2] = t42
    K_loss_out[..., 2, 17] = K_loss_out[..., 17, 2] = t40
    K_loss_out[..., 3, 3] = t27*t43 + t44
    K_loss_out[..., 3, 6] = K_loss_out[..., 6, 3] = -t44
    K_loss_out[..., 3, 15] = K_loss_out[..., 15, 3] = t29
    K_loss_out[..., 4, 4] = t33*t45 + t46
    K_loss_out[..., 4, 7] = K_loss_out[..., 7, 4] = -t46
    K_loss_out[..., 4, 16] = K_loss_out[..., 16, 4] = t35
    K_loss_out[..., 5, 5] = t39*t47 + t48
    K_loss_out[..., 5, 8] = K_loss_out[..., 8, 5] = -t48
    K_loss_out[..., 5, 17] = K_loss_out[..., 17, 5] = t41
    K_loss_out[..., 6, 6] = t26*t43 + t44
    K_loss_out[..., 6, 15] = K_loss_out[..., 15, 6] = t30
    K_loss_out[..., 7, 7] = t32*t45 + t46
    K_loss_out[..., 7, 16] = K_loss_out[..., 16, 7] = t36
    K_loss_out[..., 8, 8] = t38*t47 + t48
    K_loss_out[..., 8, 17] = K_loss_out[..., 17, 8] = t42
    K_loss_out[..., 15, 15] = t28
    K_loss_out[..., 16, 16] = t34
    K_loss_out[..., 17, 17] = t40
    return C_v_out, K_loss_out


def joint_loss(effects):
    """Loss factors of the springs of the released joints.

    Parameters
    ----------
    effects : Effects
        The robot's effects.

    Returns
    -------
    eta : array, shape (..., 12) [1]
        Loss factor of each released coordinate, in order.

    Notes
    -----
    Complex stiffness k (1 + i eta) of each.
    0 operations; 0 with every named value expanded.
    """
    (eta_G,) = _entries(effects.reducer_loss_loss_factor, ())
    batch, dtype = _batch(eta_G)
    eta_out = np.zeros((*batch, 12), dtype)
    eta_out[..., 0] = eta_G
    eta_out[..., 1] = eta_G
    eta_out[..., 2] = eta_G
    return eta_out


def extended_static_equilibrium(p, parameters, effects):
    """Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.

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
    tau_st : array, shape (..., 3) [N m]
        Torques on the driven rotors, positive in the direction of their rotation.
    theta_st : array, shape (..., 6) [rad]
        Rotations relative to the unstrained transmissions.

    Notes
    -----
    Equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
    388 operations; 129417 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    m_t_1, m_t_2, m_t_3 = _entries(parameters.carriage_mass, (3,))
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
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, d_1_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, c_T, F_T, m_L)
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
    t2 = D_r_1*t1
    D_p_x_1 = A_x_1*t2
    t3 = D_r_2*t1
    D_p_x_2 = A_x_2*t3
    t4 = D_r_3*t1
    D_p_x_3 = A_x_3*t4
    D_p_y_1 = A_y_1*t2
    D_p_y_2 = A_y_2*t3
    D_p_y_3 = A_y_3*t4
    D_p_z_1 = A_z_1*t2
    D_p_z_2 = A_z_2*t3
    D_p_z_3 = A_z_3*t4
    l_f_1_1 = x_max_1 - x_min_1
    t5 = F_T*c_T + 1
    t6 = c_E*t5
    t7 = k_sp_1*w_b_1*(a_B_1 + 1)
    t8 = t6*t7
    t9 = t5*t7
    k_1_1 = t9/(l_f_1_1 + t8)
    t10 = (1/2)*l_t_1
    l_f_1_2 = -t10 + x_1 - x_min_1
    k_1_2 = t9/(l_f_1_2 + t8)
    l_f_1_3 = -t10 - x_1 + x_max_1
    k_1_3 = t9/(l_f_1_3 + t8)
    l_f_2_1 = x_max_2 - x_min_2
    t11 = k_sp_2*w_b_2*(a_B_2 + 1)
    t12 = t11*t6
    t13 = t11*t5
    k_2_1 = t13/(l_f_2_1 + t12)
    t14 = (1/2)*l_t_2
    l_f_2_2 = -t14 + x_2 - x_min_2
    k_2_2 = t13/(l_f_2_2 + t12)
    l_f_2_3 = -t14 - x_2 + x_max_2
    k_2_3 = t13/(l_f_2_3 + t12)
    l_f_3_1 = x_max_3 - x_min_3
    t15 = k_sp_3*w_b_3*(a_B_3 + 1)
    t16 = t15*t6
    t17 = t15*t5
    k_3_1 = t17/(l_f_3_1 + t16)
    t18 = (1/2)*l_t_3
    l_f_3_2 = -t18 + x_3 - x_min_3
    k_3_2 = t17/(l_f_3_2 + t16)
    l_f_3_3 = -t18 - x_3 + x_max_3
    k_3_3 = t17/(l_f_3_3 + t16)
    t19 = (1/2)*m_d_1
    t20 = (1/2)*m_d_2
    t21 = (1/2)*m_d_3
    t22 = m_L + m_p + t19 + t20 + t21
    t23 = g_x*t22
    t24 = g_y*t22
    t25 = g_z*t22
    G_1 = (
        -D_p_x_1*t23 - D_p_y_1*t24 - D_p_z_1*t25 - g_x*(m_t_1*n_1_x + n_1_x*t19) - g_y*(m_t_1*n_1_y
        + n_1_y*t19) - g_z*(m_t_1*n_1_z + n_1_z*t19)
    )
    G_2 = (
        -D_p_x_2*t23 - D_p_y_2*t24 - D_p_z_2*t25 - g_x*(m_t_2*n_2_x + n_2_x*t20) - g_y*(m_t_2*n_2_y
        + n_2_y*t20) - g_z*(m_t_2*n_2_z + n_2_z*t20)
    )
    G_3 = (
        -D_p_x_3*t23 - D_p_y_3*t24 - D_p_z_3*t25 - g_x*(m_t_3*n_3_x + n_3_x*t21) - g_y*(m_t_3*n_3_y
        + n_3_y*t21) - g_z*(m_t_3*n_3_z + n_3_z*t21)
    )
    t26 = R_p_1**2
    t27 = k_1_1*t26
    t28 = k_1_3*t26
    t29 = -d_1_1*t27 + d_1_2*(t27 + t28)
    t30 = k_1_2*t26
    t31 = d_1_1*(t27 + t30) - d_1_2*t27
    det_1 = R_p_1*k_1_2*t29 - R_p_1*k_1_3*t31
    t32 = G_1/det_1
    theta_1_1_st = -t31*t32
    theta_1_2_st = t29*t32
    t33 = R_p_2**2
    t34 = k_2_1*t33
    t35 = k_2_3*t33
    t36 = -d_2_1*t34 + d_2_2*(t34 + t35)
    t37 = k_2_2*t33
    t38 = d_2_1*(t34 + t37) - d_2_2*t34
    det_2 = R_p_2*k_2_2*t36 - R_p_2*k_2_3*t38
    t39 = G_2/det_2
    theta_2_1_st = -t38*t39
    theta_2_2_st = t36*t39
    t40 = R_p_3**2
    t41 = k_3_1*t40
    t42 = k_3_3*t40
    t43 = -d_3_1*t41 + d_3_2*(t41 + t42)
    t44 = k_3_2*t40
    t45 = d_3_1*(t41 + t44) - d_3_2*t41
    det_3 = R_p_3*k_3_2*t43 - R_p_3*k_3_3*t45
    t46 = G_3/det_3
    theta_3_1_st = -t45*t46
    theta_3_2_st = t43*t46
    t47 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st)
    tau_st_1 = d_1_1*(t28*theta_1_1_st - t47) + d_1_2*(t30*theta_1_2_st + t47)
    t48 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st)
    tau_st_2 = d_2_1*(t35*theta_2_1_st - t48) + d_2_2*(t37*theta_2_2_st + t48)
    t49 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st)
    tau_st_3 = d_3_1*(t42*theta_3_1_st - t49) + d_3_2*(t44*theta_3_2_st + t49)
    tau_st_out = np.empty((*batch, 3), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    tau_st_out[..., 2] = tau_st_3
    theta_st_out = np.empty((*batch, 6), dtype)
    theta_st_out[..., 0] = theta_1_1_st
    theta_st_out[..., 1] = theta_2_1_st
    theta_st_out[..., 2] = theta_3_1_st
    theta_st_out[..., 3] = theta_1_2_st
    theta_st_out[..., 4] = theta_2_2_st
    theta_st_out[..., 5] = theta_3_2_st
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
    p : array, shape (..., 3) [m]
        Platform centre in the base frame.
    parameters : Parameters
        The robot's parameters.
    effects : Effects
        The robot's effects.

    Returns
    -------
    M_theta : array, shape (..., 402) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 501) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Chain rule.
    2475 operations; 5916756 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    d_1_1, d_1_2, d_2_1, d_2_2, d_3_1, d_3_2 = _entries(parameters.drive, (3, 2))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (a_B_3,) = _entries(effects.axis_belt_stiffness_factor_3, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, l_t_1, k_sp_1, w_b_1, R_p_1,
        I_m_1, i_g_1, d_1_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, c_T, F_T, m_L)
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
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    l_f_1_1 = x_max_1 - x_min_1
    t11 = a_B_1 + 1
    t12 = F_T*c_T + 1
    t13 = t11*t12*w_b_1
    t14 = k_sp_1*t13
    t15 = c_E*t14
    t16 = l_f_1_1 + t15
    t17 = 1.0/t16
    k_1_1 = k_sp_1*t13*t17
    t18 = (1/2)*l_t_1
    l_f_1_2 = -t18 + x_1 - x_min_1
    t19 = l_f_1_2 + t15
    t20 = 1.0/t19
    k_1_2 = k_sp_1*t13*t20
    l_f_1_3 = -t18 - x_1 + x_max_1
    t21 = l_f_1_3 + t15
    t22 = 1.0/t21
    k_1_3 = k_sp_1*t13*t22
    l_f_2_1 = x_max_2 - x_min_2
    t23 = a_B_2 + 1
    t24 = t12*t23*w_b_2
    t25 = k_sp_2*t24
    t26 = c_E*t25
    t27 = l_f_2_1 + t26
    t28 = 1.0/t27
    k_2_1 = k_sp_2*t24*t28
    t29 = (1/2)*l_t_2
    l_f_2_2 = -t29 + x_2 - x_min_2
    t30 = l_f_2_2 + t26
    t31 = 1.0/t30
    k_2_2 = k_sp_2*t24*t31
    l_f_2_3 = -t29 - x_2 + x_max_2
    t32 = l_f_2_3 + t26
    t33 = 1.0/t32
    k_2_3 = k_sp_2*t24*t33
    l_f_3_1 = x_max_3 - x_min_3
    t34 = a_B_3 + 1
    t35 = t12*t34*w_b_3
    t36 = k_sp_3*t35
    t37 = c_E*t36
    t38 = l_f_3_1 + t37
    t39 = 1.0/t38
    k_3_1 = k_sp_3*t35*t39
    t40 = (1/2)*l_t_3
    l_f_3_2 = -t40 + x_3 - x_min_3
    t41 = l_f_3_2 + t37
    t42 = 1.0/t41
    k_3_2 = k_sp_3*t35*t42
    l_f_3_3 = -t40 - x_3 + x_max_3
    t43 = l_f_3_3 + t37
    t44 = 1.0/t43
    k_3_3 = k_sp_3*t35*t44
    t45 = A_x_1*g_x
    t46 = A_y_1*g_y
    t47 = A_z_1*g_z
    mu_1_by_m_p = t1*(-t45 - t46 - t47)
    t48 = A_x_2*g_x
    t49 = A_y_2*g_y
    t50 = A_z_2*g_z
    mu_2_by_m_p = t1*(-t48 - t49 - t50)
    t51 = A_x_3*g_x
    t52 = A_y_3*g_y
    t53 = A_z_3*g_z
    mu_3_by_m_p = t1*(-t51 - t52 - t53)
    t54 = -m_L - 1/2*m_d_1 - 1/2*m_d_2 - 1/2*m_d_3 - m_p
    mu_1_by_g_x = t2*t54
    mu_2_by_g_x = t3*t54
    mu_3_by_g_x = t4*t54
    mu_1_by_g_y = t5*t54
    mu_2_by_g_y = t54*t6
    mu_3_by_g_y = t54*t7
    mu_1_by_g_z = t54*t8
    mu_2_by_g_z = t54*t9
    mu_3_by_g_z = t10*t54
    mu_1_by_m_d_1 = t1*(-1/2*t45 - 1/2*t46 - 1/2*t47)
    mu_2_by_m_d_1 = t1*(-1/2*t48 - 1/2*t49 - 1/2*t50)
    mu_3_by_m_d_1 = t1*(-1/2*t51 - 1/2*t52 - 1/2*t53)
    t55 = D_p_x_1**2
    t56 = D_p_y_1**2
    t57 = D_p_z_1**2
    t58 = t55 + t56 + t57
    t59 = D_p_x_1*D_p_x_2
    t60 = D_p_y_1*D_p_y_2
    t61 = D_p_z_1*D_p_z_2
    t62 = t59 + t60 + t61
    t63 = D_p_x_1*D_p_x_3
    t64 = D_p_y_1*D_p_y_3
    t65 = D_p_z_1*D_p_z_3
    t66 = t63 + t64 + t65
    t67 = D_delta_x_1*D_p_x_1
    t68 = D_delta_y_1*D_p_y_1
    t69 = D_delta_z_1*D_p_z_1
    t70 = t67 + t68 + t69
    t71 = D_delta_x_2*D_p_x_1
    t72 = D_delta_y_2*D_p_y_1
    t73 = D_delta_z_2*D_p_z_1
    t74 = t71 + t72 + t73
    t75 = D_delta_x_3*D_p_x_1
    t76 = D_delta_y_3*D_p_y_1
    t77 = D_delta_z_3*D_p_z_1
    t78 = t75 + t76 + t77
    t79 = D_p_x_2**2
    t80 = D_p_y_2**2
    t81 = D_p_z_2**2
    t82 = t79 + t80 + t81
    t83 = D_p_x_2*D_p_x_3
    t84 = D_p_y_2*D_p_y_3
    t85 = D_p_z_2*D_p_z_3
    t86 = t83 + t84 + t85
    t87 = D_delta_x_1*D_p_x_2
    t88 = D_delta_y_1*D_p_y_2
    t89 = D_delta_z_1*D_p_z_2
    t90 = t87 + t88 + t89
    t91 = D_delta_x_2*D_p_x_2
    t92 = D_delta_y_2*D_p_y_2
    t93 = D_delta_z_2*D_p_z_2
    t94 = t91 + t92 + t93
    t95 = D_delta_x_3*D_p_x_2
    t96 = D_delta_y_3*D_p_y_2
    t97 = D_delta_z_3*D_p_z_2
    t98 = t95 + t96 + t97
    t99 = D_p_x_3**2
    t100 = D_p_y_3**2
    t101 = D_p_z_3**2
    t102 = t100 + t101 + t99
    t103 = D_delta_x_1*D_p_x_3
    t104 = D_delta_y_1*D_p_y_3
    t105 = D_delta_z_1*D_p_z_3
    t106 = t103 + t104 + t105
    t107 = D_delta_x_2*D_p_x_3
    t108 = D_delta_y_2*D_p_y_3
    t109 = D_delta_z_2*D_p_z_3
    t110 = t107 + t108 + t109
    t111 = D_delta_x_3*D_p_x_3
    t112 = D_delta_y_3*D_p_y_3
    t113 = D_delta_z_3*D_p_z_3
    t114 = t111 + t112 + t113
    t115 = D_delta_x_1**2
    t116 = D_delta_y_1**2
    t117 = D_delta_z_1**2
    t118 = t115 + t116 + t117
    t119 = D_delta_x_1*D_delta_x_2
    t120 = D_delta_y_1*D_delta_y_2
    t121 = D_delta_z_1*D_delta_z_2
    t122 = t119 + t120 + t121
    t123 = D_delta_x_1*D_delta_x_3
    t124 = D_delta_y_1*D_delta_y_3
    t125 = D_delta_z_1*D_delta_z_3
    t126 = t123 + t124 + t125
    t127 = D_delta_x_2**2
    t128 = D_delta_y_2**2
    t129 = D_delta_z_2**2
    t130 = t127 + t128 + t129
    t131 = D_delta_x_2*D_delta_x_3
    t132 = D_delta_y_2*D_delta_y_3
    t133 = D_delta_z_2*D_delta_z_3
    t134 = t131 + t132 + t133
    t135 = D_delta_x_3**2
    t136 = D_delta_y_3**2
    t137 = D_delta_z_3**2
    t138 = t135 + t136 + t137
    t139 = (1/6)*n_1_x
    t140 = (1/6)*n_1_y
    t141 = (1/6)*n_1_z
    t142 = (1/3)*D_p_x_1 + t139
    t143 = (1/3)*D_p_y_1 + t140
    t144 = (1/3)*D_p_z_1 + t141
    t145 = (1/2)*D_p_x_1
    t146 = (1/2)*D_p_y_1
    t147 = (1/2)*D_p_z_1
    t148 = (1/3)*t79 + (1/3)*t80 + (1/3)*t81
    t149 = (1/3)*t83 + (1/3)*t84 + (1/3)*t85
    t150 = (1/3)*t87 + (1/3)*t88 + (1/3)*t89
    t151 = (1/3)*t91 + (1/3)*t92 + (1/3)*t93
    t152 = (1/3)*t95 + (1/3)*t96 + (1/3)*t97
    t153 = (1/2)*D_p_x_2
    t154 = (1/2)*D_p_y_2
    t155 = (1/2)*D_p_z_2
    t156 = (1/3)*t100 + (1/3)*t101 + (1/3)*t99
    t157 = (1/3)*t103 + (1/3)*t104 + (1/3)*t105
    t158 = (1/3)*t107 + (1/3)*t108 + (1/3)*t109
    t159 = (1/3)*t111 + (1/3)*t112 + (1/3)*t113
    t160 = (1/2)*D_p_x_3
    t161 = (1/2)*D_p_y_3
    t162 = (1/2)*D_p_z_3
    t163 = (1/3)*t115 + (1/3)*t116 + (1/3)*t117
    t164 = (1/3)*t119 + (1/3)*t120 + (1/3)*t121
    t165 = (1/3)*t123 + (1/3)*t124 + (1/3)*t125
    t166 = (1/2)*D_delta_x_1
    t167 = (1/2)*D_delta_y_1
    t168 = (1/2)*D_delta_z_1
    t169 = (1/3)*t127 + (1/3)*t128 + (1/3)*t129
    t170 = (1/3)*t131 + (1/3)*t132 + (1/3)*t133
    t171 = (1/2)*D_delta_x_2
    t172 = (1/2)*D_delta_y_2
    t173 = (1/2)*D_delta_z_2
    t174 = (1/3)*t135 + (1/3)*t136 + (1/3)*t137
    t175 = (1/2)*D_delta_x_3
    t176 = (1/2)*D_delta_y_3
    t177 = (1/2)*D_delta_z_3
    t178 = (1/3)*t55 + (1/3)*t56 + (1/3)*t57
    t179 = (1/6)*n_2_x
    t180 = (1/6)*n_2_y
    t181 = (1/6)*n_2_z
    t182 = (1/3)*t59 + (1/3)*t60 + (1/3)*t61
    t183 = (1/3)*t63 + (1/3)*t64 + (1/3)*t65
    t184 = (1/3)*t67 + (1/3)*t68 + (1/3)*t69
    t185 = (1/3)*t71 + (1/3)*t72 + (1/3)*t73
    t186 = (1/3)*t75 + (1/3)*t76 + (1/3)*t77
    t187 = (1/3)*D_p_x_2 + t179
    t188 = (1/3)*D_p_y_2 + t180
    t189 = (1/3)*D_p_z_2 + t181
    t190 = (1/6)*n_3_x
    t191 = (1/6)*n_3_y
    t192 = (1/6)*n_3_z
    t193 = (1/3)*D_p_x_3 + t190
    t194 = (1/3)*D_p_y_3 + t191
    t195 = (1/3)*D_p_z_3 + t192
    t196 = (1/3)*rho_b
    t197 = (1/12)*rho_b
    t198 = -R_p_1*t197
    t199 = R_p_1**2
    t200 = (1/6)*rho_b
    t201 = t199*t200
    t202 = -R_p_2*t197
    t203 = R_p_2**2
    t204 = t200*t203
    t205 = -R_p_3*t197
    t206 = R_p_3**2
    t207 = t200*t206
    t208 = l_f_1_3*t200
    t209 = l_f_1_2*t200
    t210 = (2/3)*rho_b
    t211 = R_p_1*t210
    t212 = l_f_1_1*t211
    t213 = l_f_2_3*t200
    t214 = l_f_2_2*t200
    t215 = R_p_2*t210
    t216 = l_f_2_1*t215
    t217 = l_f_3_3*t200
    t218 = l_f_3_2*t200
    t219 = R_p_3*t210
    t220 = l_f_3_1*t219
    t221 = i_g_1**2
    t222 = d_1_1*t221
    t223 = d_1_2*t221
    t224 = i_g_2**2
    t225 = d_2_1*t224
    t226 = d_2_2*t224
    t227 = i_g_3**2
    t228 = d_3_1*t227
    t229 = d_3_2*t227
    t230 = 2*I_m_1*i_g_1
    t231 = d_1_1*t230
    t232 = d_1_2*t230
    t233 = 2*I_m_2*i_g_2
    t234 = d_2_1*t233
    t235 = d_2_2*t233
    t236 = 2*I_m_3*i_g_3
    t237 = d_3_1*t236
    t238 = d_3_2*t236
    t239 = R_p_1*t200
    t240 = t196*t199
    t241 = t199*t210
    t242 = R_p_2*t200
    t243 = t196*t203
    t244 = t203*t210
    t245 = R_p_3*t200
    t246 = t196*t206
    t247 = t206*t210
    t248 = (1/3)*l_f_1_2
    t249 = (1/3)*l_f_1_3
    t250 = t248 + t249
    t251 = (1/6)*R_p_1
    t252 = l_f_1_3*t251
    t253 = l_f_1_2*t251
    t254 = (1/3)*l_f_2_2
    t255 = (1/3)*l_f_2_3
    t256 = t254 + t255
    t257 = (1/6)*R_p_2
    t258 = l_f_2_3*t257
    t259 = l_f_2_2*t257
    t260 = (1/3)*l_f_3_2
    t261 = (1/3)*l_f_3_3
    t262 = t260 + t261
    t263 = (1/6)*R_p_3
    t264 = l_f_3_3*t263
    t265 = l_f_3_2*t263
    t266 = l_f_1_1*t199
    t267 = (1/3)*t266
    t268 = l_f_2_1*t203
    t269 = (1/3)*t268
    t270 = l_f_3_1*t206
    t271 = (1/3)*t270
    t272 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    t273 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    t274 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    t275 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    t276 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    t277 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t278 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t279 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t280 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t281 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    t282 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    t283 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t284 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t285 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t286 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t287 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t288 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t289 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t290 = 1 - t118
    t291 = 1 - t130
    t292 = 1 - t138
    t293 = 1.0/(t19**2)
    t294 = t14*t293
    t295 = (1/2)*t294
    t296 = 1.0/(t21**2)
    t297 = t14*t296
    t298 = (1/2)*t297
    t299 = t295 + t298
    t300 = -R_p_1*t298
    t301 = -R_p_1*t295
    t302 = 1.0/(t30**2)
    t303 = t25*t302
    t304 = (1/2)*t303
    t305 = 1.0/(t32**2)
    t306 = t25*t305
    t307 = (1/2)*t306
    t308 = t304 + t307
    t309 = -R_p_2*t307
    t310 = -R_p_2*t304
    t311 = 1.0/(t41**2)
    t312 = t311*t36
    t313 = (1/2)*t312
    t314 = 1.0/(t43**2)
    t315 = t314*t36
    t316 = (1/2)*t315
    t317 = t313 + t316
    t318 = -R_p_3*t316
    t319 = -R_p_3*t313
    t320 = w_b_1**2
    t321 = t11**2
    t322 = t12**2
    t323 = t320*t321*t322
    t324 = k_sp_1*t323
    t325 = c_E*t324
    t326 = -t11*t12*t22*w_b_1 + t296*t325
    t327 = c_E*t293
    t328 = -t11*t12*t20*w_b_1 + t324*t327
    t329 = -t326 - t328
    t330 = R_p_1*t326
    t331 = R_p_1*t328
    t332 = 1.0/(t16**2)
    t333 = t199*(t11*t12*t17*w_b_1 - t325*t332)
    t334 = w_b_2**2
    t335 = t23**2
    t336 = t322*t334*t335
    t337 = k_sp_2*t336
    t338 = c_E*t337
    t339 = -t12*t23*t33*w_b_2 + t305*t338
    t340 = c_E*t302
    t341 = -t12*t23*t31*w_b_2 + t337*t340
    t342 = -t339 - t341
    t343 = R_p_2*t339
    t344 = R_p_2*t341
    t345 = 1.0/(t27**2)
    t346 = t203*(t12*t23*t28*w_b_2 - t338*t345)
    t347 = w_b_3**2
    t348 = t34**2
    t349 = t322*t347*t348
    t350 = k_sp_3*t349
    t351 = c_E*t350
    t352 = -t12*t34*t44*w_b_3 + t314*t351
    t353 = c_E*t311
    t354 = -t12*t34*t42*w_b_3 + t350*t353
    t355 = -t352 - t354
    t356 = R_p_3*t352
    t357 = R_p_3*t354
    t358 = 1.0/(t38**2)
    t359 = t206*(t12*t34*t39*w_b_3 - t351*t358)
    t360 = t321*w_b_1
    t361 = k_sp_1**2
    t362 = t322*t361
    t363 = c_E*t362
    t364 = t360*t363
    t365 = -k_sp_1*t11*t12*t22 + t296*t364
    t366 = t327*t362
    t367 = -k_sp_1*t11*t12*t20 + t360*t366
    t368 = -t365 - t367
    t369 = R_p_1*t365
    t370 = R_p_1*t367
    t371 = t199*(k_sp_1*t11*t12*t17 - t332*t364)
    t372 = t335*w_b_2
    t373 = k_sp_2**2
    t374 = t322*t373
    t375 = c_E*t374
    t376 = t372*t375
    t377 = -k_sp_2*t12*t23*t33 + t305*t376
    t378 = t340*t374
    t379 = -k_sp_2*t12*t23*t31 + t372*t378
    t380 = -t377 - t379
    t381 = R_p_2*t377
    t382 = R_p_2*t379
    t383 = t203*(k_sp_2*t12*t23*t28 - t345*t376)
    t384 = t348*w_b_3
    t385 = k_sp_3**2
    t386 = t322*t385
    t387 = c_E*t386
    t388 = t384*t387
    t389 = -k_sp_3*t12*t34*t44 + t314*t388
    t390 = t353*t386
    t391 = -k_sp_3*t12*t34*t42 + t384*t390
    t392 = -t389 - t391
    t393 = R_p_3*t389
    t394 = R_p_3*t391
    t395 = t206*(k_sp_3*t12*t34*t39 - t358*t388)
    t396 = 2*R_p_1
    t397 = k_1_1*t396
    t398 = 2*R_p_2
    t399 = k_2_1*t398
    t400 = 2*R_p_3
    t401 = k_3_1*t400
    t402 = -R_p_1*t294
    t403 = t199*t332
    t404 = t14*t403
    t405 = R_p_1*t297
    t406 = -R_p_2*t303
    t407 = t203*t345
    t408 = t25*t407
    t409 = R_p_2*t306
    t410 = -R_p_3*t312
    t411 = t206*t358
    t412 = t36*t411
    t413 = R_p_3*t315
    t414 = t11*t320
    t415 = t363*t414
    t416 = -k_sp_1*t12*t22*w_b_1 + t296*t415
    t417 = -k_sp_1*t12*t20*w_b_1 + t366*t414
    t418 = -t416 - t417
    t419 = R_p_1*t416
    t420 = R_p_1*t417
    t421 = t199*(k_sp_1*t12*t17*w_b_1 - t332*t415)
    t422 = t23*t334
    t423 = t375*t422
    t424 = -k_sp_2*t12*t33*w_b_2 + t305*t423
    t425 = -k_sp_2*t12*t31*w_b_2 + t378*t422
    t426 = -t424 - t425
    t427 = R_p_2*t424
    t428 = R_p_2*t425
    t429 = t203*(k_sp_2*t12*t28*w_b_2 - t345*t423)
    t430 = t34*t347
    t431 = t387*t430
    t432 = -k_sp_3*t12*t44*w_b_3 + t314*t431
    t433 = -k_sp_3*t12*t42*w_b_3 + t390*t430
    t434 = -t432 - t433
    t435 = R_p_3*t432
    t436 = R_p_3*t433
    t437 = t206*(k_sp_3*t12*t39*w_b_3 - t358*t431)
    t438 = t323*t361
    t439 = t293*t438
    t440 = t296*t438
    t441 = -t439 - t440
    t442 = R_p_1*t440
    t443 = R_p_1*t439
    t444 = t336*t373
    t445 = t302*t444
    t446 = t305*t444
    t447 = -t445 - t446
    t448 = R_p_2*t446
    t449 = R_p_2*t445
    t450 = t349*t385
    t451 = t311*t450
    t452 = t314*t450
    t453 = -t451 - t452
    t454 = R_p_3*t452
    t455 = R_p_3*t451
    t456 = t403*t438
    t457 = t407*t444
    t458 = t411*t450
    t459 = F_T*t12
    t460 = t320*t321*t361
    t461 = t459*t460
    t462 = c_E*t461
    t463 = -F_T*k_sp_1*t11*t22*w_b_1 + t296*t462
    t464 = -F_T*k_sp_1*t11*t20*w_b_1 + t327*t461
    t465 = -t463 - t464
    t466 = R_p_1*t463
    t467 = R_p_1*t464
    t468 = t334*t335*t373
    t469 = t459*t468
    t470 = c_E*t469
    t471 = -F_T*k_sp_2*t23*t33*w_b_2 + t305*t470
    t472 = -F_T*k_sp_2*t23*t31*w_b_2 + t340*t469
    t473 = -t471 - t472
    t474 = R_p_2*t471
    t475 = R_p_2*t472
    t476 = t347*t348*t385
    t477 = t459*t476
    t478 = c_E*t477
    t479 = -F_T*k_sp_3*t34*t44*w_b_3 + t314*t478
    t480 = -F_T*k_sp_3*t34*t42*w_b_3 + t353*t477
    t481 = -t479 - t480
    t482 = R_p_3*t479
    t483 = R_p_3*t480
    t484 = t199*(F_T*k_sp_1*t11*t17*w_b_1 - t332*t462)
    t485 = t203*(F_T*k_sp_2*t23*t28*w_b_2 - t345*t470)
    t486 = t206*(F_T*k_sp_3*t34*t39*w_b_3 - t358*t478)
    t487 = c_T*t12
    t488 = t460*t487
    t489 = c_E*t488
    t490 = -c_T*k_sp_1*t11*t22*w_b_1 + t296*t489
    t491 = -c_T*k_sp_1*t11*t20*w_b_1 + t327*t488
    t492 = -t490 - t491
    t493 = R_p_1*t490
    t494 = R_p_1*t491
    t495 = t468*t487
    t496 = c_E*t495
    t497 = -c_T*k_sp_2*t23*t33*w_b_2 + t305*t496
    t498 = -c_T*k_sp_2*t23*t31*w_b_2 + t340*t495
    t499 = -t497 - t498
    t500 = R_p_2*t497
    t501 = R_p_2*t498
    t502 = t476*t487
    t503 = c_E*t502
    t504 = -c_T*k_sp_3*t34*t44*w_b_3 + t314*t503
    t505 = -c_T*k_sp_3*t34*t42*w_b_3 + t353*t502
    t506 = -t504 - t505
    t507 = R_p_3*t504
    t508 = R_p_3*t505
    t509 = t199*(c_T*k_sp_1*t11*t17*w_b_1 - t332*t489)
    t510 = t203*(c_T*k_sp_2*t23*t28*w_b_2 - t345*t496)
    t511 = t206*(c_T*k_sp_3*t34*t39*w_b_3 - t358*t503)
    M_theta_out = _listed(batch, dtype, (
        t58, t62, t66, t70, t74, t78, D_p_x_1, D_p_y_1, D_p_z_1, t82, t86, t90, t94, t98, D_p_x_2, D_p_y_2,
        D_p_z_2, t102, t106, t110, t114, D_p_x_3, D_p_y_3, D_p_z_3, t118, t122, t126, D_delta_x_1,
        D_delta_y_1, D_delta_z_1, t130, t134, D_delta_x_2, D_delta_y_2, D_delta_z_2, t138, D_delta_x_3,
        D_delta_y_3, D_delta_z_3, 1, 1, 1,
        D_p_x_1*t139 + D_p_x_1*t142 + D_p_y_1*t140 + D_p_y_1*t143 + D_p_z_1*t141 + D_p_z_1*t144 + 1/3,
        D_p_x_2*t142 + D_p_y_2*t143 + D_p_z_2*t144, D_p_x_3*t142 + D_p_y_3*t143 + D_p_z_3*t144,
        D_delta_x_1*t142 + D_delta_y_1*t143 + D_delta_z_1*t144,
        D_delta_x_2*t142 + D_delta_y_2*t143 + D_delta_z_2*t144,
        D_delta_x_3*t142 + D_delta_y_3*t143 + D_delta_z_3*t144, (1/2)*n_1_x + t145, (1/2)*n_1_y + t146,
        (1/2)*n_1_z + t147, t148, t149, t150, t151, t152, t153, t154, t155, t156, t157, t158, t159, t160,
        t161, t162, t163, t164, t165, t166, t167, t168, t169, t170, t171, t172, t173, t174, t175, t176, t177,
        1, 1, 1, t178, D_p_x_1*t179 + D_p_y_1*t180 + D_p_z_1*t181 + t182, t183, t184, t185, t186, t145, t146,
        t147, D_p_x_2*t179 + D_p_x_2*t187 + D_p_y_2*t180 + D_p_y_2*t188 + D_p_z_2*t181 + D_p_z_2*t189 + 1/3,
        D_p_x_3*t187 + D_p_y_3*t188 + D_p_z_3*t189, D_delta_x_1*t187 + D_delta_y_1*t188 + D_delta_z_1*t189,
        D_delta_x_2*t187 + D_delta_y_2*t188 + D_delta_z_2*t189,
        D_delta_x_3*t187 + D_delta_y_3*t188 + D_delta_z_3*t189, (1/2)*n_2_x + t153, (1/2)*n_2_y + t154,
        (1/2)*n_2_z + t155, t156, t157, t158, t159, t160, t161, t162, t163, t164, t165, t166, t167, t168,
        t169, t170, t171, t172, t173, t174, t175, t176, t177, 1, 1, 1, t178, t182,
        D_p_x_1*t190 + D_p_y_1*t191 + D_p_z_1*t192 + t183, t184, t185, t186, t145, t146, t147, t148,
        D_p_x_2*t190 + D_p_y_2*t191 + D_p_z_2*t192 + t149, t150, t151, t152, t153, t154, t155,
        D_p_x_3*t190 + D_p_x_3*t193 + D_p_y_3*t191 + D_p_y_3*t194 + D_p_z_3*t192 + D_p_z_3*t195 + 1/3,
        D_delta_x_1*t193 + D_delta_y_1*t194 + D_delta_z_1*t195,
        D_delta_x_2*t193 + D_delta_y_2*t194 + D_delta_z_2*t195,
        D_delta_x_3*t193 + D_delta_y_3*t194 + D_delta_z_3*t195, (1/2)*n_3_x + t160, (1/2)*n_3_y + t161,
        (1/2)*n_3_z + t162, t163, t164, t165, t166, t167, t168, t169, t170, t171, t172, t173, t174, t175,
        t176, t177, 1, 1, 1, 1, n_1_x, n_1_y, n_1_z, 1, 1, 1, 1, n_2_x, n_2_y, n_2_z, 1, 1, 1, 1, n_3_x,
        n_3_y, n_3_z, 1, 1, 1, -t196, t198, t198, -t196, -t201, t198, -t201, t198, -t196, -t196, t202, t202,
        -t196, -t204, t202, -t204, t202, -t196, -t196, t205, t205, -t196, -t207, t205, -t207, t205, -t196,
        t208, t209, l_f_1_3*t211 + t212, R_p_1*l_f_1_1*t196, t208, l_f_1_2*t211 + t212, t209, t213, t214,
        l_f_2_3*t215 + t216, R_p_2*l_f_2_1*t196, t213, l_f_2_2*t215 + t216, t214, t217, t218,
        l_f_3_3*t219 + t220, R_p_3*l_f_3_1*t196, t217, l_f_3_2*t219 + t220, t218, 1, 1, 1, 1, 1, 1, t222,
        t222, t223, t223, t222 + t223, t225, t225, t226, t226, t225 + t226, t228, t228, t229, t229,
        t228 + t229, t231, t231, t232, t232, t231 + t232, t234, t234, t235, t235, t234 + t235, t237, t237,
        t238, t238, t237 + t238, -t196, -t239, -t196, -t240, -t201, -t241, -t239, -t196, t196, t239, t196,
        t241, t201, t239, t240, t196, -t196, -t242, -t196, -t243, -t204, -t244, -t242, -t196, t196, t242,
        t196, t244, t204, t242, t243, t196, -t196, -t245, -t196, -t246, -t207, -t247, -t245, -t196, t196,
        t245, t196, t247, t207, t245, t246, t196, t250, t252, t253, t250, t256, t258, t259, t256, t262, t264,
        t265, t262, t199*t249 + t267, (1/6)*t266, t252, t203*t255 + t269, (1/6)*t268, t258, t206*t261 + t271,
        (1/6)*t270, t264, t199*t248 + t267, t253, t203*t254 + t269, t259, t206*t260 + t271, t265, t250, t256,
        t262, d_1_1, d_2_1, d_3_1, d_1_2, d_2_2, d_3_2, t58, t62, t66, t70, t74, t78, D_p_x_1, D_p_y_1,
        D_p_z_1, t82, t86, t90, t94, t98, D_p_x_2, D_p_y_2, D_p_z_2, t102, t106, t110, t114, D_p_x_3, D_p_y_3,
        D_p_z_3, t118, t122, t126, D_delta_x_1, D_delta_y_1, D_delta_z_1, t130, t134, D_delta_x_2,
        D_delta_y_2, D_delta_z_2, t138, D_delta_x_3, D_delta_y_3, D_delta_z_3, 1, 1, 1, 1, 1, 1,
    ))
    K_theta_out = _listed(batch, dtype, (
        mu_1_by_m_p*t272 - mu_2_by_m_p*t58 - mu_3_by_m_p*t58,
        mu_1_by_m_p*t273 + mu_2_by_m_p*t274 - mu_3_by_m_p*t62,
        mu_1_by_m_p*t275 - mu_2_by_m_p*t66 + mu_3_by_m_p*t276,
        mu_1_by_m_p*t277 - mu_2_by_m_p*t70 - mu_3_by_m_p*t70,
        mu_1_by_m_p*t278 - mu_2_by_m_p*t74 - mu_3_by_m_p*t74,
        mu_1_by_m_p*t279 - mu_2_by_m_p*t78 - mu_3_by_m_p*t78,
        -mu_1_by_m_p*t82 + mu_2_by_m_p*t280 - mu_3_by_m_p*t82,
        -mu_1_by_m_p*t86 + mu_2_by_m_p*t281 + mu_3_by_m_p*t282,
        -mu_1_by_m_p*t90 + mu_2_by_m_p*t283 - mu_3_by_m_p*t90,
        -mu_1_by_m_p*t94 + mu_2_by_m_p*t284 - mu_3_by_m_p*t94,
        -mu_1_by_m_p*t98 + mu_2_by_m_p*t285 - mu_3_by_m_p*t98,
        -mu_1_by_m_p*t102 - mu_2_by_m_p*t102 + mu_3_by_m_p*t286,
        -mu_1_by_m_p*t106 - mu_2_by_m_p*t106 + mu_3_by_m_p*t287,
        -mu_1_by_m_p*t110 - mu_2_by_m_p*t110 + mu_3_by_m_p*t288,
        -mu_1_by_m_p*t114 - mu_2_by_m_p*t114 + mu_3_by_m_p*t289,
        mu_1_by_m_p*t290 - mu_2_by_m_p*t118 - mu_3_by_m_p*t118,
        -mu_1_by_m_p*t122 - mu_2_by_m_p*t122 - mu_3_by_m_p*t122,
        -mu_1_by_m_p*t126 - mu_2_by_m_p*t126 - mu_3_by_m_p*t126,
        -mu_1_by_m_p*t130 + mu_2_by_m_p*t291 - mu_3_by_m_p*t130,
        -mu_1_by_m_p*t134 - mu_2_by_m_p*t134 - mu_3_by_m_p*t134,
        -mu_1_by_m_p*t138 - mu_2_by_m_p*t138 + mu_3_by_m_p*t292,
        mu_1_by_g_x*t272 - mu_2_by_g_x*t58 - mu_3_by_g_x*t58,
        mu_1_by_g_x*t273 + mu_2_by_g_x*t274 - mu_3_by_g_x*t62,
        mu_1_by_g_x*t275 - mu_2_by_g_x*t66 + mu_3_by_g_x*t276,
        mu_1_by_g_x*t277 - mu_2_by_g_x*t70 - mu_3_by_g_x*t70,
        mu_1_by_g_x*t278 - mu_2_by_g_x*t74 - mu_3_by_g_x*t74,
        mu_1_by_g_x*t279 - mu_2_by_g_x*t78 - mu_3_by_g_x*t78,
        -mu_1_by_g_x*t82 + mu_2_by_g_x*t280 - mu_3_by_g_x*t82,
        -mu_1_by_g_x*t86 + mu_2_by_g_x*t281 + mu_3_by_g_x*t282,
        -mu_1_by_g_x*t90 + mu_2_by_g_x*t283 - mu_3_by_g_x*t90,
        -mu_1_by_g_x*t94 + mu_2_by_g_x*t284 - mu_3_by_g_x*t94,
        -mu_1_by_g_x*t98 + mu_2_by_g_x*t285 - mu_3_by_g_x*t98,
        -mu_1_by_g_x*t102 - mu_2_by_g_x*t102 + mu_3_by_g_x*t286,
        -mu_1_by_g_x*t106 - mu_2_by_g_x*t106 + mu_3_by_g_x*t287,
        -mu_1_by_g_x*t110 - mu_2_by_g_x*t110 + mu_3_by_g_x*t288,
        -mu_1_by_g_x*t114 - mu_2_by_g_x*t114 + mu_3_by_g_x*t289,
        mu_1_by_g_x*t290 - mu_2_by_g_x*t118 - mu_3_by_g_x*t118,
        -mu_1_by_g_x*t122 - mu_2_by_g_x*t122 - mu_3_by_g_x*t122,
        -mu_1_by_g_x*t126 - mu_2_by_g_x*t126 - mu_3_by_g_x*t126,
        -mu_1_by_g_x*t130 + mu_2_by_g_x*t291 - mu_3_by_g_x*t130,
        -mu_1_by_g_x*t134 - mu_2_by_g_x*t134 - mu_3_by_g_x*t134,
        -mu_1_by_g_x*t138 - mu_2_by_g_x*t138 + mu_3_by_g_x*t292,
        mu_1_by_g_y*t272 - mu_2_by_g_y*t58 - mu_3_by_g_y*t58,
        mu_1_by_g_y*t273 + mu_2_by_g_y*t274 - mu_3_by_g_y*t62,
        mu_1_by_g_y*t275 - mu_2_by_g_y*t66 + mu_3_by_g_y*t276,
        mu_1_by_g_y*t277 - mu_2_by_g_y*t70 - mu_3_by_g_y*t70,
        mu_1_by_g_y*t278 - mu_2_by_g_y*t74 - mu_3_by_g_y*t74,
        mu_1_by_g_y*t279 - mu_2_by_g_y*t78 - mu_3_by_g_y*t78,
        -mu_1_by_g_y*t82 + mu_2_by_g_y*t280 - mu_3_by_g_y*t82,
        -mu_1_by_g_y*t86 + mu_2_by_g_y*t281 + mu_3_by_g_y*t282,
        -mu_1_by_g_y*t90 + mu_2_by_g_y*t283 - mu_3_by_g_y*t90,
        -mu_1_by_g_y*t94 + mu_2_by_g_y*t284 - mu_3_by_g_y*t94,
        -mu_1_by_g_y*t98 + mu_2_by_g_y*t285 - mu_3_by_g_y*t98,
        -mu_1_by_g_y*t102 - mu_2_by_g_y*t102 + mu_3_by_g_y*t286,
        -mu_1_by_g_y*t106 - mu_2_by_g_y*t106 + mu_3_by_g_y*t287,
        -mu_1_by_g_y*t110 - mu_2_by_g_y*t110 + mu_3_by_g_y*t288,
        -mu_1_by_g_y*t114 - mu_2_by_g_y*t114 + mu_3_by_g_y*t289,
        mu_1_by_g_y*t290 - mu_2_by_g_y*t118 - mu_3_by_g_y*t118,
        -mu_1_by_g_y*t122 - mu_2_by_g_y*t122 - mu_3_by_g_y*t122,
        -mu_1_by_g_y*t126 - mu_2_by_g_y*t126 - mu_3_by_g_y*t126,
        -mu_1_by_g_y*t130 + mu_2_by_g_y*t291 - mu_3_by_g_y*t130,
        -mu_1_by_g_y*t134 - mu_2_by_g_y*t134 - mu_3_by_g_y*t134,
        -mu_1_by_g_y*t138 - mu_2_by_g_y*t138 + mu_3_by_g_y*t292,
        mu_1_by_g_z*t272 - mu_2_by_g_z*t58 - mu_3_by_g_z*t58,
        mu_1_by_g_z*t273 + mu_2_by_g_z*t274 - mu_3_by_g_z*t62,
        mu_1_by_g_z*t275 - mu_2_by_g_z*t66 + mu_3_by_g_z*t276,
        mu_1_by_g_z*t277 - mu_2_by_g_z*t70 - mu_3_by_g_z*t70,
        mu_1_by_g_z*t278 - mu_2_by_g_z*t74 - mu_3_by_g_z*t74,
        mu_1_by_g_z*t279 - mu_2_by_g_z*t78 - mu_3_by_g_z*t78,
        -mu_1_by_g_z*t82 + mu_2_by_g_z*t280 - mu_3_by_g_z*t82,
        -mu_1_by_g_z*t86 + mu_2_by_g_z*t281 + mu_3_by_g_z*t282,
        -mu_1_by_g_z*t90 + mu_2_by_g_z*t283 - mu_3_by_g_z*t90,
        -mu_1_by_g_z*t94 + mu_2_by_g_z*t284 - mu_3_by_g_z*t94,
        -mu_1_by_g_z*t98 + mu_2_by_g_z*t285 - mu_3_by_g_z*t98,
        -mu_1_by_g_z*t102 - mu_2_by_g_z*t102 + mu_3_by_g_z*t286,
        -mu_1_by_g_z*t106 - mu_2_by_g_z*t106 + mu_3_by_g_z*t287,
        -mu_1_by_g_z*t110 - mu_2_by_g_z*t110 + mu_3_by_g_z*t288,
        -mu_1_by_g_z*t114 - mu_2_by_g_z*t114 + mu_3_by_g_z*t289,
        mu_1_by_g_z*t290 - mu_2_by_g_z*t118 - mu_3_by_g_z*t118,
        -mu_1_by_g_z*t122 - mu_2_by_g_z*t122 - mu_3_by_g_z*t122,
        -mu_1_by_g_z*t126 - mu_2_by_g_z*t126 - mu_3_by_g_z*t126,
        -mu_1_by_g_z*t130 + mu_2_by_g_z*t291 - mu_3_by_g_z*t130,
        -mu_1_by_g_z*t134 - mu_2_by_g_z*t134 - mu_3_by_g_z*t134,
        -mu_1_by_g_z*t138 - mu_2_by_g_z*t138 + mu_3_by_g_z*t292,
        mu_1_by_m_d_1*t272 - mu_2_by_m_d_1*t58 - mu_3_by_m_d_1*t58,
        mu_1_by_m_d_1*t273 + mu_2_by_m_d_1*t274 - mu_3_by_m_d_1*t62,
        mu_1_by_m_d_1*t275 - mu_2_by_m_d_1*t66 + mu_3_by_m_d_1*t276,
        mu_1_by_m_d_1*t277 - mu_2_by_m_d_1*t70 - mu_3_by_m_d_1*t70,
        mu_1_by_m_d_1*t278 - mu_2_by_m_d_1*t74 - mu_3_by_m_d_1*t74,
        mu_1_by_m_d_1*t279 - mu_2_by_m_d_1*t78 - mu_3_by_m_d_1*t78,
        -mu_1_by_m_d_1*t82 + mu_2_by_m_d_1*t280 - mu_3_by_m_d_1*t82,
        -mu_1_by_m_d_1*t86 + mu_2_by_m_d_1*t281 + mu_3_by_m_d_1*t282,
        -mu_1_by_m_d_1*t90 + mu_2_by_m_d_1*t283 - mu_3_by_m_d_1*t90,
        -mu_1_by_m_d_1*t94 + mu_2_by_m_d_1*t284 - mu_3_by_m_d_1*t94,
        -mu_1_by_m_d_1*t98 + mu_2_by_m_d_1*t285 - mu_3_by_m_d_1*t98,
        -mu_1_by_m_d_1*t102 - mu_2_by_m_d_1*t102 + mu_3_by_m_d_1*t286,
        -mu_1_by_m_d_1*t106 - mu_2_by_m_d_1*t106 + mu_3_by_m_d_1*t287,
        -mu_1_by_m_d_1*t110 - mu_2_by_m_d_1*t110 + mu_3_by_m_d_1*t288,
        -mu_1_by_m_d_1*t114 - mu_2_by_m_d_1*t114 + mu_3_by_m_d_1*t289,
        mu_1_by_m_d_1*t290 - mu_2_by_m_d_1*t118 - mu_3_by_m_d_1*t118,
        -mu_1_by_m_d_1*t122 - mu_2_by_m_d_1*t122 - mu_3_by_m_d_1*t122,
        -mu_1_by_m_d_1*t126 - mu_2_by_m_d_1*t126 - mu_3_by_m_d_1*t126,
        -mu_1_by_m_d_1*t130 + mu_2_by_m_d_1*t291 - mu_3_by_m_d_1*t130,
        -mu_1_by_m_d_1*t134 - mu_2_by_m_d_1*t134 - mu_3_by_m_d_1*t134,
        -mu_1_by_m_d_1*t138 - mu_2_by_m_d_1*t138 + mu_3_by_m_d_1*t292,
        mu_1_by_m_d_1*t272 - mu_2_by_m_d_1*t58 - mu_3_by_m_d_1*t58,
        mu_1_by_m_d_1*t273 + mu_2_by_m_d_1*t274 - mu_3_by_m_d_1*t62,
        mu_1_by_m_d_1*t275 - mu_2_by_m_d_1*t66 + mu_3_by_m_d_1*t276,
        mu_1_by_m_d_1*t277 - mu_2_by_m_d_1*t70 - mu_3_by_m_d_1*t70,
        mu_1_by_m_d_1*t278 - mu_2_by_m_d_1*t74 - mu_3_by_m_d_1*t74,
        mu_1_by_m_d_1*t279 - mu_2_by_m_d_1*t78 - mu_3_by_m_d_1*t78,
        -mu_1_by_m_d_1*t82 + mu_2_by_m_d_1*t280 - mu_3_by_m_d_1*t82,
        -mu_1_by_m_d_1*t86 + mu_2_by_m_d_1*t281 + mu_3_by_m_d_1*t282,
        -mu_1_by_m_d_1*t90 + mu_2_by_m_d_1*t283 - mu_3_by_m_d_1*t90,
        -mu_1_by_m_d_1*t94 + mu_2_by_m_d_1*t284 - mu_3_by_m_d_1*t94,
        -mu_1_by_m_d_1*t98 + mu_2_by_m_d_1*t285 - mu_3_by_m_d_1*t98,
        -mu_1_by_m_d_1*t102 - mu_2_by_m_d_1*t102 + mu_3_by_m_d_1*t286,
        -mu_1_by_m_d_1*t106 - mu_2_by_m_d_1*t106 + mu_3_by_m_d_1*t287,
        -mu_1_by_m_d_1*t110 - mu_2_by_m_d_1*t110 + mu_3_by_m_d_1*t288,
        -mu_1_by_m_d_1*t114 - mu_2_by_m_d_1*t114 + mu_3_by_m_d_1*t289,
        mu_1_by_m_d_1*t290 - mu_2_by_m_d_1*t118 - mu_3_by_m_d_1*t118,
        -mu_1_by_m_d_1*t122 - mu_2_by_m_d_1*t122 - mu_3_by_m_d_1*t122,
        -mu_1_by_m_d_1*t126 - mu_2_by_m_d_1*t126 - mu_3_by_m_d_1*t126,
        -mu_1_by_m_d_1*t130 + mu_2_by_m_d_1*t291 - mu_3_by_m_d_1*t130,
        -mu_1_by_m_d_1*t134 - mu_2_by_m_d_1*t134 - mu_3_by_m_d_1*t134,
        -mu_1_by_m_d_1*t138 - mu_2_by_m_d_1*t138 + mu_3_by_m_d_1*t292,
        mu_1_by_m_d_1*t272 - mu_2_by_m_d_1*t58 - mu_3_by_m_d_1*t58,
        mu_1_by_m_d_1*t273 + mu_2_by_m_d_1*t274 - mu_3_by_m_d_1*t62,
        mu_1_by_m_d_1*t275 - mu_2_by_m_d_1*t66 + mu_3_by_m_d_1*t276,
        mu_1_by_m_d_1*t277 - mu_2_by_m_d_1*t70 - mu_3_by_m_d_1*t70,
        mu_1_by_m_d_1*t278 - mu_2_by_m_d_1*t74 - mu_3_by_m_d_1*t74,
        mu_1_by_m_d_1*t279 - mu_2_by_m_d_1*t78 - mu_3_by_m_d_1*t78,
        -mu_1_by_m_d_1*t82 + mu_2_by_m_d_1*t280 - mu_3_by_m_d_1*t82,
        -mu_1_by_m_d_1*t86 + mu_2_by_m_d_1*t281 + mu_3_by_m_d_1*t282,
        -mu_1_by_m_d_1*t90 + mu_2_by_m_d_1*t283 - mu_3_by_m_d_1*t90,
        -mu_1_by_m_d_1*t94 + mu_2_by_m_d_1*t284 - mu_3_by_m_d_1*t94,
        -mu_1_by_m_d_1*t98 + mu_2_by_m_d_1*t285 - mu_3_by_m_d_1*t98,
        -mu_1_by_m_d_1*t102 - mu_2_by_m_d_1*t102 + mu_3_by_m_d_1*t286,
        -mu_1_by_m_d_1*t106 - mu_2_by_m_d_1*t106 + mu_3_by_m_d_1*t287,
        -mu_1_by_m_d_1*t110 - mu_2_by_m_d_1*t110 + mu_3_by_m_d_1*t288,
        -mu_1_by_m_d_1*t114 - mu_2_by_m_d_1*t114 + mu_3_by_m_d_1*t289,
        mu_1_by_m_d_1*t290 - mu_2_by_m_d_1*t118 - mu_3_by_m_d_1*t118,
        -mu_1_by_m_d_1*t122 - mu_2_by_m_d_1*t122 - mu_3_by_m_d_1*t122,
        -mu_1_by_m_d_1*t126 - mu_2_by_m_d_1*t126 - mu_3_by_m_d_1*t126,
        -mu_1_by_m_d_1*t130 + mu_2_by_m_d_1*t291 - mu_3_by_m_d_1*t130,
        -mu_1_by_m_d_1*t134 - mu_2_by_m_d_1*t134 - mu_3_by_m_d_1*t134,
        -mu_1_by_m_d_1*t138 - mu_2_by_m_d_1*t138 + mu_3_by_m_d_1*t292, t299, t300, t301, t299, t199*t298,
        t300, t199*t295, t301, t299, t308, t309, t310, t308, t203*t307, t309, t203*t304, t310, t308, t317,
        t318, t319, t317, t206*t316, t318, t206*t313, t319, t317, t329, t330, t331, t329, -t199*t326 + t333,
        -t333, t330, -t199*t328 + t333, t331, t329, t342, t343, t344, t342, -t203*t339 + t346, -t346, t343,
        -t203*t341 + t346, t344, t342, t355, t356, t357, t355, -t206*t352 + t359, -t359, t356,
        -t206*t354 + t359, t357, t355, t368, t369, t370, t368, -t199*t365 + t371, -t371, t369,
        -t199*t367 + t371, t370, t368, t380, t381, t382, t380, -t203*t377 + t383, -t383, t381,
        -t203*t379 + t383, t382, t380, t392, t393, t394, t392, -t206*t389 + t395, -t395, t393,
        -t206*t391 + t395, t394, t392, -k_1_3, -k_1_2, k_1_3*t396 + t397, -t397, -k_1_3, k_1_2*t396 + t397,
        -k_1_2, -k_2_3, -k_2_2, k_2_3*t398 + t399, -t399, -k_2_3, k_2_2*t398 + t399, -k_2_2, -k_3_3, -k_3_2,
        k_3_3*t400 + t401, -t401, -k_3_3, k_3_2*t400 + t401, -k_3_2, t294, t402, t294, t404, -t404,
        t199*t294 + t404, t402, t294, -t297, t405, -t297, -t199*t297 - t404, t404, t405, -t404, -t297, t303,
        t406, t303, t408, -t408, t203*t303 + t408, t406, t303, -t306, t409, -t306, -t203*t306 - t408, t408,
        t409, -t408, -t306, t312, t410, t312, t412, -t412, t206*t312 + t412, t410, t312, -t315, t413, -t315,
        -t206*t315 - t412, t412, t413, -t412, -t315, t418, t419, t420, t418, -t199*t416 + t421, -t421, t419,
        -t199*t417 + t421, t420, t418, t426, t427, t428, t426, -t203*t424 + t429, -t429, t427,
        -t203*t425 + t429, t428, t426, t434, t435, t436, t434, -t206*t432 + t437, -t437, t435,
        -t206*t433 + t437, t436, t434, t441, t442, t443, t441, t447, t448, t449, t447, t453, t454, t455, t453,
        -t199*t440 - t456, t456, t442, -t203*t446 - t457, t457, t448, -t206*t452 - t458, t458, t454,
        -t199*t439 - t456, t443, -t203*t445 - t457, t449, -t206*t451 - t458, t455, t441, t447, t453, t465,
        t466, t467, t465, t473, t474, t475, t473, t481, t482, t483, t481, -t199*t463 + t484, -t484, t466,
        -t203*t471 + t485, -t485, t474, -t206*t479 + t486, -t486, t482, -t199*t464 + t484, t467,
        -t203*t472 + t485, t475, -t206*t480 + t486, t483, t465, t473, t481, t492, t493, t494, t492, t499,
        t500, t501, t499, t506, t507, t508, t506, -t199*t490 + t509, -t509, t493, -t203*t497 + t510, -t510,
        t500, -t206*t504 + t511, -t511, t507, -t199*t491 + t509, t494, -t203*t498 + t510, t501,
        -t206*t505 + t511, t508, t492, t499, t506, t58, t62, t66, t70, t74, t78, D_p_x_1, D_p_y_1, D_p_z_1,
        t82, t86, t90, t94, t98, D_p_x_2, D_p_y_2, D_p_z_2, t102, t106, t110, t114, D_p_x_3, D_p_y_3, D_p_z_3,
        t118, t122, t126, D_delta_x_1, D_delta_y_1, D_delta_z_1, t130, t134, D_delta_x_2, D_delta_y_2,
        D_delta_z_2, t138, D_delta_x_3, D_delta_y_3, D_delta_z_3, 1, 1, 1,
        mu_1_by_m_p*t272 - mu_2_by_m_p*t58 - mu_3_by_m_p*t58,
        mu_1_by_m_p*t273 + mu_2_by_m_p*t274 - mu_3_by_m_p*t62,
        mu_1_by_m_p*t275 - mu_2_by_m_p*t66 + mu_3_by_m_p*t276,
        mu_1_by_m_p*t277 - mu_2_by_m_p*t70 - mu_3_by_m_p*t70,
        mu_1_by_m_p*t278 - mu_2_by_m_p*t74 - mu_3_by_m_p*t74,
        mu_1_by_m_p*t279 - mu_2_by_m_p*t78 - mu_3_by_m_p*t78,
        -mu_1_by_m_p*t82 + mu_2_by_m_p*t280 - mu_3_by_m_p*t82,
        -mu_1_by_m_p*t86 + mu_2_by_m_p*t281 + mu_3_by_m_p*t282,
        -mu_1_by_m_p*t90 + mu_2_by_m_p*t283 - mu_3_by_m_p*t90,
        -mu_1_by_m_p*t94 + mu_2_by_m_p*t284 - mu_3_by_m_p*t94,
        -mu_1_by_m_p*t98 + mu_2_by_m_p*t285 - mu_3_by_m_p*t98,
        -mu_1_by_m_p*t102 - mu_2_by_m_p*t102 + mu_3_by_m_p*t286,
        -mu_1_by_m_p*t106 - mu_2_by_m_p*t106 + mu_3_by_m_p*t287,
        -mu_1_by_m_p*t110 - mu_2_by_m_p*t110 + mu_3_by_m_p*t288,
        -mu_1_by_m_p*t114 - mu_2_by_m_p*t114 + mu_3_by_m_p*t289,
        mu_1_by_m_p*t290 - mu_2_by_m_p*t118 - mu_3_by_m_p*t118,
        -mu_1_by_m_p*t122 - mu_2_by_m_p*t122 - mu_3_by_m_p*t122,
        -mu_1_by_m_p*t126 - mu_2_by_m_p*t126 - mu_3_by_m_p*t126,
        -mu_1_by_m_p*t130 + mu_2_by_m_p*t291 - mu_3_by_m_p*t130,
        -mu_1_by_m_p*t134 - mu_2_by_m_p*t134 - mu_3_by_m_p*t134,
        -mu_1_by_m_p*t138 - mu_2_by_m_p*t138 + mu_3_by_m_p*t292, d_1_1, d_1_1, d_2_1, d_2_1, d_3_1, d_3_1,
        d_1_2, d_1_2, d_2_2, d_2_2, d_3_2, d_3_2, d_1_1 + d_1_2, d_2_1 + d_2_2, d_3_1 + d_3_2,
    ))
    return M_theta_out, K_theta_out


def geometry_sensitivities(p, parameters, effects):
    """Derivatives of M and K at a fixed pose with respect to parameters that move the carriage positions.

    Returns the upper-triangle entries listed in GEOMETRY_SENSITIVITIES; all others are zero.  Derivatives
    with respect to origin are the negatives of those with respect to joint.

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
    M_theta : array, shape (..., 540) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 564) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Implicit function theorem and chain rule.
    13237 operations; 64172202 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    n_1_x, n_1_y, n_1_z, n_2_x, n_2_y, n_2_z, n_3_x, n_3_y, n_3_z = _entries(parameters.direction, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    l_t_1, l_t_2, l_t_3 = _entries(parameters.carriage_length, (3,))
    k_sp_1, k_sp_2, k_sp_3 = _entries(parameters.belt_specific_stiffness, (3,))
    w_b_1, w_b_2, w_b_3 = _entries(parameters.belt_width, (3,))
    R_p_1, R_p_2, R_p_3 = _entries(parameters.pulley_radius, (3,))
    x_min_1, x_max_1, x_min_2, x_max_2, x_min_3, x_max_3 = _entries(parameters.limits, (3, 2))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_B_1,) = _entries(effects.axis_belt_stiffness_factor_1, ())
    (a_B_2,) = _entries(effects.axis_belt_stiffness_factor_2, ())
    (a_B_3,) = _entries(effects.axis_belt_stiffness_factor_3, ())
    (c_E,) = _entries(effects.belt_end_compliance_compliance, ())
    (rho_b,) = _entries(effects.belt_mass_linear_density, ())
    (c_T,) = _entries(effects.belt_tension_stiffness_coefficient, ())
    (F_T,) = _entries(effects.belt_tension_stiffness_tension, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, l_t_1, k_sp_1, w_b_1, R_p_1,
        x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, c_T, F_T, k_C, m_L)
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
    U_1_x_1 = D_p_x_1 - n_1_x
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_z_1 = D_p_z_1 - n_1_z
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_z_2 = D_p_z_2 - n_2_z
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_3 = D_p_z_3 - n_3_z
    t11 = (1/2)*l_t_1
    l_f_1_2 = -t11 + x_1 - x_min_1
    l_f_1_3 = -t11 - x_1 + x_max_1
    t12 = (1/2)*l_t_2
    l_f_2_2 = -t12 + x_2 - x_min_2
    l_f_2_3 = -t12 - x_2 + x_max_2
    t13 = (1/2)*l_t_3
    l_f_3_2 = -t13 + x_3 - x_min_3
    l_f_3_3 = -t13 - x_3 + x_max_3
    t14 = m_L + m_p
    t15 = (1/2)*m_d_1 + (1/2)*m_d_2 + (1/2)*m_d_3 + t14
    t16 = g_x*t15
    t17 = g_y*t15
    t18 = g_z*t15
    mu_1 = t1*(-A_x_1*t16 - A_y_1*t17 - A_z_1*t18)
    mu_2 = t1*(-A_x_2*t16 - A_y_2*t17 - A_z_2*t18)
    mu_3 = t1*(-A_x_3*t16 - A_y_3*t17 - A_z_3*t18)
    t19 = 1.0/D_r_1
    x_1_by_b_1_x = s_1_x*t19
    s_1_x_by_b_1_x = -n_1_x*x_1_by_b_1_x + 1
    s_1_y_by_b_1_x = -n_1_y*x_1_by_b_1_x
    s_1_z_by_b_1_x = -n_1_z*x_1_by_b_1_x
    t20 = n_1_y**2
    t21 = n_1_z**2
    t22 = (
        -D_p_x_1*s_1_x_by_b_1_x - D_p_y_1*s_1_y_by_b_1_x - D_p_z_1*s_1_z_by_b_1_x + n_1_x*s_1_x_by_b_1_x
        - t20*x_1_by_b_1_x - t21*x_1_by_b_1_x
    )
    D_p_x_1_by_b_1_x = t2*t22
    D_p_y_1_by_b_1_x = t22*t5
    D_p_z_1_by_b_1_x = t22*t8
    t23 = -D_p_x_2*s_1_x_by_b_1_x - D_p_y_2*s_1_y_by_b_1_x - D_p_z_2*s_1_z_by_b_1_x
    D_p_x_2_by_b_1_x = t2*t23
    D_p_y_2_by_b_1_x = t23*t5
    D_p_z_2_by_b_1_x = t23*t8
    t24 = -D_p_x_3*s_1_x_by_b_1_x - D_p_y_3*s_1_y_by_b_1_x - D_p_z_3*s_1_z_by_b_1_x
    D_p_x_3_by_b_1_x = t2*t24
    D_p_y_3_by_b_1_x = t24*t5
    D_p_z_3_by_b_1_x = t24*t8
    t25 = -D_delta_x_1*s_1_x_by_b_1_x - D_delta_y_1*s_1_y_by_b_1_x - D_delta_z_1*s_1_z_by_b_1_x
    D_delta_x_1_by_b_1_x = t2*t25
    D_delta_y_1_by_b_1_x = t25*t5
    D_delta_z_1_by_b_1_x = t25*t8
    t26 = -D_delta_x_2*s_1_x_by_b_1_x - D_delta_y_2*s_1_y_by_b_1_x - D_delta_z_2*s_1_z_by_b_1_x
    D_delta_x_2_by_b_1_x = t2*t26
    D_delta_y_2_by_b_1_x = t26*t5
    D_delta_z_2_by_b_1_x = t26*t8
    t27 = -D_delta_x_3*s_1_x_by_b_1_x - D_delta_y_3*s_1_y_by_b_1_x - D_delta_z_3*s_1_z_by_b_1_x
    D_delta_x_3_by_b_1_x = t2*t27
    D_delta_y_3_by_b_1_x = t27*t5
    D_delta_z_3_by_b_1_x = t27*t8
    t28 = mu_1*s_1_x_by_b_1_x
    t29 = mu_1*s_1_y_by_b_1_x
    t30 = mu_1*s_1_z_by_b_1_x
    mu_1_by_b_1_x = t1*(-A_x_1*t28 - A_y_1*t29 - A_z_1*t30)
    mu_2_by_b_1_x = t1*(-A_x_2*t28 - A_y_2*t29 - A_z_2*t30)
    mu_3_by_b_1_x = t1*(-A_x_3*t28 - A_y_3*t29 - A_z_3*t30)
    x_1_by_b_1_y = s_1_y*t19
    s_1_x_by_b_1_y = -n_1_x*x_1_by_b_1_y
    s_1_y_by_b_1_y = -n_1_y*x_1_by_b_1_y + 1
    s_1_z_by_b_1_y = -n_1_z*x_1_by_b_1_y
    t31 = n_1_x**2
    t32 = (
        -D_p_x_1*s_1_x_by_b_1_y - D_p_y_1*s_1_y_by_b_1_y - D_p_z_1*s_1_z_by_b_1_y + n_1_y*s_1_y_by_b_1_y
        - t21*x_1_by_b_1_y - t31*x_1_by_b_1_y
    )
    D_p_x_1_by_b_1_y = t2*t32
    D_p_y_1_by_b_1_y = t32*t5
    D_p_z_1_by_b_1_y = t32*t8
    t33 = -D_p_x_2*s_1_x_by_b_1_y - D_p_y_2*s_1_y_by_b_1_y - D_p_z_2*s_1_z_by_b_1_y
    D_p_x_2_by_b_1_y = t2*t33
    D_p_y_2_by_b_1_y = t33*t5
    D_p_z_2_by_b_1_y = t33*t8
    t34 = -D_p_x_3*s_1_x_by_b_1_y - D_p_y_3*s_1_y_by_b_1_y - D_p_z_3*s_1_z_by_b_1_y
    D_p_x_3_by_b_1_y = t2*t34
    D_p_y_3_by_b_1_y = t34*t5
    D_p_z_3_by_b_1_y = t34*t8
    t35 = -D_delta_x_1*s_1_x_by_b_1_y - D_delta_y_1*s_1_y_by_b_1_y - D_delta_z_1*s_1_z_by_b_1_y
    D_delta_x_1_by_b_1_y = t2*t35
    D_delta_y_1_by_b_1_y = t35*t5
    D_delta_z_1_by_b_1_y = t35*t8
    t36 = -D_delta_x_2*s_1_x_by_b_1_y - D_delta_y_2*s_1_y_by_b_1_y - D_delta_z_2*s_1_z_by_b_1_y
    D_delta_x_2_by_b_1_y = t2*t36
    D_delta_y_2_by_b_1_y = t36*t5
    D_delta_z_2_by_b_1_y = t36*t8
    t37 = -D_delta_x_3*s_1_x_by_b_1_y - D_delta_y_3*s_1_y_by_b_1_y - D_delta_z_3*s_1_z_by_b_1_y
    D_delta_x_3_by_b_1_y = t2*t37
    D_delta_y_3_by_b_1_y = t37*t5
    D_delta_z_3_by_b_1_y = t37*t8
    t38 = mu_1*s_1_x_by_b_1_y
    t39 = mu_1*s_1_y_by_b_1_y
    t40 = mu_1*s_1_z_by_b_1_y
    mu_1_by_b_1_y = t1*(-A_x_1*t38 - A_y_1*t39 - A_z_1*t40)
    mu_2_by_b_1_y = t1*(-A_x_2*t38 - A_y_2*t39 - A_z_2*t40)
    mu_3_by_b_1_y = t1*(-A_x_3*t38 - A_y_3*t39 - A_z_3*t40)
    x_1_by_b_1_z = s_1_z*t19
    s_1_x_by_b_1_z = -n_1_x*x_1_by_b_1_z
    s_1_y_by_b_1_z = -n_1_y*x_1_by_b_1_z
    s_1_z_by_b_1_z = -n_1_z*x_1_by_b_1_z + 1
    t41 = (
        -D_p_x_1*s_1_x_by_b_1_z - D_p_y_1*s_1_y_by_b_1_z - D_p_z_1*s_1_z_by_b_1_z + n_1_z*s_1_z_by_b_1_z
        - t20*x_1_by_b_1_z - t31*x_1_by_b_1_z
    )
    D_p_x_1_by_b_1_z = t2*t41
    D_p_y_1_by_b_1_z = t41*t5
    D_p_z_1_by_b_1_z = t41*t8
    t42 = -D_p_x_2*s_1_x_by_b_1_z - D_p_y_2*s_1_y_by_b_1_z - D_p_z_2*s_1_z_by_b_1_z
    D_p_x_2_by_b_1_z = t2*t42
    D_p_y_2_by_b_1_z = t42*t5
    D_p_z_2_by_b_1_z = t42*t8
    t43 = -D_p_x_3*s_1_x_by_b_1_z - D_p_y_3*s_1_y_by_b_1_z - D_p_z_3*s_1_z_by_b_1_z
    D_p_x_3_by_b_1_z = t2*t43
    D_p_y_3_by_b_1_z = t43*t5
    D_p_z_3_by_b_1_z = t43*t8
    t44 = -D_delta_x_1*s_1_x_by_b_1_z - D_delta_y_1*s_1_y_by_b_1_z - D_delta_z_1*s_1_z_by_b_1_z
    D_delta_x_1_by_b_1_z = t2*t44
    D_delta_y_1_by_b_1_z = t44*t5
    D_delta_z_1_by_b_1_z = t44*t8
    t45 = -D_delta_x_2*s_1_x_by_b_1_z - D_delta_y_2*s_1_y_by_b_1_z - D_delta_z_2*s_1_z_by_b_1_z
    D_delta_x_2_by_b_1_z = t2*t45
    D_delta_y_2_by_b_1_z = t45*t5
    D_delta_z_2_by_b_1_z = t45*t8
    t46 = -D_delta_x_3*s_1_x_by_b_1_z - D_delta_y_3*s_1_y_by_b_1_z - D_delta_z_3*s_1_z_by_b_1_z
    D_delta_x_3_by_b_1_z = t2*t46
    D_delta_y_3_by_b_1_z = t46*t5
    D_delta_z_3_by_b_1_z = t46*t8
    t47 = mu_1*s_1_x_by_b_1_z
    t48 = mu_1*s_1_y_by_b_1_z
    t49 = mu_1*s_1_z_by_b_1_z
    mu_1_by_b_1_z = t1*(-A_x_1*t47 - A_y_1*t48 - A_z_1*t49)
    mu_2_by_b_1_z = t1*(-A_x_2*t47 - A_y_2*t48 - A_z_2*t49)
    mu_3_by_b_1_z = t1*(-A_x_3*t47 - A_y_3*t48 - A_z_3*t49)
    t50 = 1.0/D_r_2
    x_2_by_b_2_x = s_2_x*t50
    s_2_x_by_b_2_x = -n_2_x*x_2_by_b_2_x + 1
    s_2_y_by_b_2_x = -n_2_y*x_2_by_b_2_x
    s_2_z_by_b_2_x = -n_2_z*x_2_by_b_2_x
    t51 = -D_p_x_1*s_2_x_by_b_2_x - D_p_y_1*s_2_y_by_b_2_x - D_p_z_1*s_2_z_by_b_2_x
    D_p_x_1_by_b_2_x = t3*t51
    D_p_y_1_by_b_2_x = t51*t6
    D_p_z_1_by_b_2_x = t51*t9
    t52 = n_2_y**2
    t53 = n_2_z**2
    t54 = (
        -D_p_x_2*s_2_x_by_b_2_x - D_p_y_2*s_2_y_by_b_2_x - D_p_z_2*s_2_z_by_b_2_x + n_2_x*s_2_x_by_b_2_x
        - t52*x_2_by_b_2_x - t53*x_2_by_b_2_x
    )
    D_p_x_2_by_b_2_x = t3*t54
    D_p_y_2_by_b_2_x = t54*t6
    D_p_z_2_by_b_2_x = t54*t9
    t55 = -D_p_x_3*s_2_x_by_b_2_x - D_p_y_3*s_2_y_by_b_2_x - D_p_z_3*s_2_z_by_b_2_x
    D_p_x_3_by_b_2_x = t3*t55
    D_p_y_3_by_b_2_x = t55*t6
    D_p_z_3_by_b_2_x = t55*t9
    t56 = -D_delta_x_1*s_2_x_by_b_2_x - D_delta_y_1*s_2_y_by_b_2_x - D_delta_z_1*s_2_z_by_b_2_x
    D_delta_x_1_by_b_2_x = t3*t56
    D_delta_y_1_by_b_2_x = t56*t6
    D_delta_z_1_by_b_2_x = t56*t9
    t57 = -D_delta_x_2*s_2_x_by_b_2_x - D_delta_y_2*s_2_y_by_b_2_x - D_delta_z_2*s_2_z_by_b_2_x
    D_delta_x_2_by_b_2_x = t3*t57
    D_delta_y_2_by_b_2_x = t57*t6
    D_delta_z_2_by_b_2_x = t57*t9
    t58 = -D_delta_x_3*s_2_x_by_b_2_x - D_delta_y_3*s_2_y_by_b_2_x - D_delta_z_3*s_2_z_by_b_2_x
    D_delta_x_3_by_b_2_x = t3*t58
    D_delta_y_3_by_b_2_x = t58*t6
    D_delta_z_3_by_b_2_x = t58*t9
    t59 = mu_2*s_2_x_by_b_2_x
    t60 = mu_2*s_2_y_by_b_2_x
    t61 = mu_2*s_2_z_by_b_2_x
    mu_1_by_b_2_x = t1*(-A_x_1*t59 - A_y_1*t60 - A_z_1*t61)
    mu_2_by_b_2_x = t1*(-A_x_2*t59 - A_y_2*t60 - A_z_2*t61)
    mu_3_by_b_2_x = t1*(-A_x_3*t59 - A_y_3*t60 - A_z_3*t61)
    x_2_by_b_2_y = s_2_y*t50
    s_2_x_by_b_2_y = -n_2_x*x_2_by_b_2_y
    s_2_y_by_b_2_y = -n_2_y*x_2_by_b_2_y + 1
    s_2_z_by_b_2_y = -n_2_z*x_2_by_b_2_y
    t62 = -D_p_x_1*s_2_x_by_b_2_y - D_p_y_1*s_2_y_by_b_2_y - D_p_z_1*s_2_z_by_b_2_y
    D_p_x_1_by_b_2_y = t3*t62
    D_p_y_1_by_b_2_y = t6*t62
    D_p_z_1_by_b_2_y = t62*t9
    t63 = n_2_x**2
    t64 = (
        -D_p_x_2*s_2_x_by_b_2_y - D_p_y_2*s_2_y_by_b_2_y - D_p_z_2*s_2_z_by_b_2_y + n_2_y*s_2_y_by_b_2_y
        - t53*x_2_by_b_2_y - t63*x_2_by_b_2_y
    )
    D_p_x_2_by_b_2_y = t3*t64
    D_p_y_2_by_b_2_y = t6*t64
    D_p_z_2_by_b_2_y = t64*t9
    t65 = -D_p_x_3*s_2_x_by_b_2_y - D_p_y_3*s_2_y_by_b_2_y - D_p_z_3*s_2_z_by_b_2_y
    D_p_x_3_by_b_2_y = t3*t65
    D_p_y_3_by_b_2_y = t6*t65
    D_p_z_3_by_b_2_y = t65*t9
    t66 = -D_delta_x_1*s_2_x_by_b_2_y - D_delta_y_1*s_2_y_by_b_2_y - D_delta_z_1*s_2_z_by_b_2_y
    D_delta_x_1_by_b_2_y = t3*t66
    D_delta_y_1_by_b_2_y = t6*t66
    D_delta_z_1_by_b_2_y = t66*t9
    t67 = -D_delta_x_2*s_2_x_by_b_2_y - D_delta_y_2*s_2_y_by_b_2_y - D_delta_z_2*s_2_z_by_b_2_y
    D_delta_x_2_by_b_2_y = t3*t67
    D_delta_y_2_by_b_2_y = t6*t67
    D_delta_z_2_by_b_2_y = t67*t9
    t68 = -D_delta_x_3*s_2_x_by_b_2_y - D_delta_y_3*s_2_y_by_b_2_y - D_delta_z_3*s_2_z_by_b_2_y
    D_delta_x_3_by_b_2_y = t3*t68
    D_delta_y_3_by_b_2_y = t6*t68
    D_delta_z_3_by_b_2_y = t68*t9
    t69 = mu_2*s_2_x_by_b_2_y
    t70 = mu_2*s_2_y_by_b_2_y
    t71 = mu_2*s_2_z_by_b_2_y
    mu_1_by_b_2_y = t1*(-A_x_1*t69 - A_y_1*t70 - A_z_1*t71)
    mu_2_by_b_2_y = t1*(-A_x_2*t69 - A_y_2*t70 - A_z_2*t71)
    mu_3_by_b_2_y = t1*(-A_x_3*t69 - A_y_3*t70 - A_z_3*t71)
    x_2_by_b_2_z = s_2_z*t50
    s_2_x_by_b_2_z = -n_2_x*x_2_by_b_2_z
    s_2_y_by_b_2_z = -n_2_y*x_2_by_b_2_z
    s_2_z_by_b_2_z = -n_2_z*x_2_by_b_2_z + 1
    t72 = -D_p_x_1*s_2_x_by_b_2_z - D_p_y_1*s_2_y_by_b_2_z - D_p_z_1*s_2_z_by_b_2_z
    D_p_x_1_by_b_2_z = t3*t72
    D_p_y_1_by_b_2_z = t6*t72
    D_p_z_1_by_b_2_z = t72*t9
    t73 = (
        -D_p_x_2*s_2_x_by_b_2_z - D_p_y_2*s_2_y_by_b_2_z - D_p_z_2*s_2_z_by_b_2_z + n_2_z*s_2_z_by_b_2_z
        - t52*x_2_by_b_2_z - t63*x_2_by_b_2_z
    )
    D_p_x_2_by_b_2_z = t3*t73
    D_p_y_2_by_b_2_z = t6*t73
    D_p_z_2_by_b_2_z = t73*t9
    t74 = -D_p_x_3*s_2_x_by_b_2_z - D_p_y_3*s_2_y_by_b_2_z - D_p_z_3*s_2_z_by_b_2_z
    D_p_x_3_by_b_2_z = t3*t74
    D_p_y_3_by_b_2_z = t6*t74
    D_p_z_3_by_b_2_z = t74*t9
    t75 = -D_delta_x_1*s_2_x_by_b_2_z - D_delta_y_1*s_2_y_by_b_2_z - D_delta_z_1*s_2_z_by_b_2_z
    D_delta_x_1_by_b_2_z = t3*t75
    D_delta_y_1_by_b_2_z = t6*t75
    D_delta_z_1_by_b_2_z = t75*t9
    t76 = -D_delta_x_2*s_2_x_by_b_2_z - D_delta_y_2*s_2_y_by_b_2_z - D_delta_z_2*s_2_z_by_b_2_z
    D_delta_x_2_by_b_2_z = t3*t76
    D_delta_y_2_by_b_2_z = t6*t76
    D_delta_z_2_by_b_2_z = t76*t9
    t77 = -D_delta_x_3*s_2_x_by_b_2_z - D_delta_y_3*s_2_y_by_b_2_z - D_delta_z_3*s_2_z_by_b_2_z
    D_delta_x_3_by_b_2_z = t3*t77
    D_delta_y_3_by_b_2_z = t6*t77
    D_delta_z_3_by_b_2_z = t77*t9
    t78 = mu_2*s_2_x_by_b_2_z
    t79 = mu_2*s_2_y_by_b_2_z
    t80 = mu_2*s_2_z_by_b_2_z
    mu_1_by_b_2_z = t1*(-A_x_1*t78 - A_y_1*t79 - A_z_1*t80)
    mu_2_by_b_2_z = t1*(-A_x_2*t78 - A_y_2*t79 - A_z_2*t80)
    mu_3_by_b_2_z = t1*(-A_x_3*t78 - A_y_3*t79 - A_z_3*t80)
    t81 = 1.0/D_r_3
    x_3_by_b_3_x = s_3_x*t81
    s_3_x_by_b_3_x = -n_3_x*x_3_by_b_3_x + 1
    s_3_y_by_b_3_x = -n_3_y*x_3_by_b_3_x
    s_3_z_by_b_3_x = -n_3_z*x_3_by_b_3_x
    t82 = -D_p_x_1*s_3_x_by_b_3_x - D_p_y_1*s_3_y_by_b_3_x - D_p_z_1*s_3_z_by_b_3_x
    D_p_x_1_by_b_3_x = t4*t82
    D_p_y_1_by_b_3_x = t7*t82
    D_p_z_1_by_b_3_x = t10*t82
    t83 = -D_p_x_2*s_3_x_by_b_3_x - D_p_y_2*s_3_y_by_b_3_x - D_p_z_2*s_3_z_by_b_3_x
    D_p_x_2_by_b_3_x = t4*t83
    D_p_y_2_by_b_3_x = t7*t83
    D_p_z_2_by_b_3_x = t10*t83
    t84 = n_3_z**2
    t85 = n_3_y**2
    t86 = (
        -D_p_x_3*s_3_x_by_b_3_x - D_p_y_3*s_3_y_by_b_3_x - D_p_z_3*s_3_z_by_b_3_x + n_3_x*s_3_x_by_b_3_x
        - t84*x_3_by_b_3_x - t85*x_3_by_b_3_x
    )
    D_p_x_3_by_b_3_x = t4*t86
    D_p_y_3_by_b_3_x = t7*t86
    D_p_z_3_by_b_3_x = t10*t86
    t87 = -D_delta_x_1*s_3_x_by_b_3_x - D_delta_y_1*s_3_y_by_b_3_x - D_delta_z_1*s_3_z_by_b_3_x
    D_delta_x_1_by_b_3_x = t4*t87
    D_delta_y_1_by_b_3_x = t7*t87
    D_delta_z_1_by_b_3_x = t10*t87
    t88 = -D_delta_x_2*s_3_x_by_b_3_x - D_delta_y_2*s_3_y_by_b_3_x - D_delta_z_2*s_3_z_by_b_3_x
    D_delta_x_2_by_b_3_x = t4*t88
    D_delta_y_2_by_b_3_x = t7*t88
    D_delta_z_2_by_b_3_x = t10*t88
    t89 = -D_delta_x_3*s_3_x_by_b_3_x - D_delta_y_3*s_3_y_by_b_3_x - D_delta_z_3*s_3_z_by_b_3_x
    D_delta_x_3_by_b_3_x = t4*t89
    D_delta_y_3_by_b_3_x = t7*t89
    D_delta_z_3_by_b_3_x = t10*t89
    t90 = mu_3*s_3_x_by_b_3_x
    t91 = mu_3*s_3_y_by_b_3_x
    t92 = mu_3*s_3_z_by_b_3_x
    mu_1_by_b_3_x = t1*(-A_x_1*t90 - A_y_1*t91 - A_z_1*t92)
    mu_2_by_b_3_x = t1*(-A_x_2*t90 - A_y_2*t91 - A_z_2*t92)
    mu_3_by_b_3_x = t1*(-A_x_3*t90 - A_y_3*t91 - A_z_3*t92)
    x_3_by_b_3_y = s_3_y*t81
    s_3_x_by_b_3_y = -n_3_x*x_3_by_b_3_y
    s_3_y_by_b_3_y = -n_3_y*x_3_by_b_3_y + 1
    s_3_z_by_b_3_y = -n_3_z*x_3_by_b_3_y
    t93 = -D_p_x_1*s_3_x_by_b_3_y - D_p_y_1*s_3_y_by_b_3_y - D_p_z_1*s_3_z_by_b_3_y
    D_p_x_1_by_b_3_y = t4*t93
    D_p_y_1_by_b_3_y = t7*t93
    D_p_z_1_by_b_3_y = t10*t93
    t94 = -D_p_x_2*s_3_x_by_b_3_y - D_p_y_2*s_3_y_by_b_3_y - D_p_z_2*s_3_z_by_b_3_y
    D_p_x_2_by_b_3_y = t4*t94
    D_p_y_2_by_b_3_y = t7*t94
    D_p_z_2_by_b_3_y = t10*t94
    t95 = n_3_x**2
    t96 = (
        -D_p_x_3*s_3_x_by_b_3_y - D_p_y_3*s_3_y_by_b_3_y - D_p_z_3*s_3_z_by_b_3_y + n_3_y*s_3_y_by_b_3_y
        - t84*x_3_by_b_3_y - t95*x_3_by_b_3_y
    )
    D_p_x_3_by_b_3_y = t4*t96
    D_p_y_3_by_b_3_y = t7*t96
    D_p_z_3_by_b_3_y = t10*t96
    t97 = -D_delta_x_1*s_3_x_by_b_3_y - D_delta_y_1*s_3_y_by_b_3_y - D_delta_z_1*s_3_z_by_b_3_y
    D_delta_x_1_by_b_3_y = t4*t97
    D_delta_y_1_by_b_3_y = t7*t97
    D_delta_z_1_by_b_3_y = t10*t97
    t98 = -D_delta_x_2*s_3_x_by_b_3_y - D_delta_y_2*s_3_y_by_b_3_y - D_delta_z_2*s_3_z_by_b_3_y
    D_delta_x_2_by_b_3_y = t4*t98
    D_delta_y_2_by_b_3_y = t7*t98
    D_delta_z_2_by_b_3_y = t10*t98
    t99 = -D_delta_x_3*s_3_x_by_b_3_y - D_delta_y_3*s_3_y_by_b_3_y - D_delta_z_3*s_3_z_by_b_3_y
    D_delta_x_3_by_b_3_y = t4*t99
    D_delta_y_3_by_b_3_y = t7*t99
    D_delta_z_3_by_b_3_y = t10*t99
    t100 = mu_3*s_3_x_by_b_3_y
    t101 = mu_3*s_3_y_by_b_3_y
    t102 = mu_3*s_3_z_by_b_3_y
    mu_1_by_b_3_y = t1*(-A_x_1*t100 - A_y_1*t101 - A_z_1*t102)
    mu_2_by_b_3_y = t1*(-A_x_2*t100 - A_y_2*t101 - A_z_2*t102)
    mu_3_by_b_3_y = t1*(-A_x_3*t100 - A_y_3*t101 - A_z_3*t102)
    x_3_by_b_3_z = s_3_z*t81
    s_3_x_by_b_3_z = -n_3_x*x_3_by_b_3_z
    s_3_y_by_b_3_z = -n_3_y*x_3_by_b_3_z
    s_3_z_by_b_3_z = -n_3_z*x_3_by_b_3_z + 1
    t103 = -D_p_x_1*s_3_x_by_b_3_z - D_p_y_1*s_3_y_by_b_3_z - D_p_z_1*s_3_z_by_b_3_z
    D_p_x_1_by_b_3_z = t103*t4
    D_p_y_1_by_b_3_z = t103*t7
    D_p_z_1_by_b_3_z = t10*t103
    t104 = -D_p_x_2*s_3_x_by_b_3_z - D_p_y_2*s_3_y_by_b_3_z - D_p_z_2*s_3_z_by_b_3_z
    D_p_x_2_by_b_3_z = t104*t4
    D_p_y_2_by_b_3_z = t104*t7
    D_p_z_2_by_b_3_z = t10*t104
    t105 = (
        -D_p_x_3*s_3_x_by_b_3_z - D_p_y_3*s_3_y_by_b_3_z - D_p_z_3*s_3_z_by_b_3_z + n_3_z*s_3_z_by_b_3_z
        - t85*x_3_by_b_3_z - t95*x_3_by_b_3_z
    )
    D_p_x_3_by_b_3_z = t105*t4
    D_p_y_3_by_b_3_z = t105*t7
    D_p_z_3_by_b_3_z = t10*t105
    t106 = -D_delta_x_1*s_3_x_by_b_3_z - D_delta_y_1*s_3_y_by_b_3_z - D_delta_z_1*s_3_z_by_b_3_z
    D_delta_x_1_by_b_3_z = t106*t4
    D_delta_y_1_by_b_3_z = t106*t7
    D_delta_z_1_by_b_3_z = t10*t106
    t107 = -D_delta_x_2*s_3_x_by_b_3_z - D_delta_y_2*s_3_y_by_b_3_z - D_delta_z_2*s_3_z_by_b_3_z
    D_delta_x_2_by_b_3_z = t107*t4
    D_delta_y_2_by_b_3_z = t107*t7
    D_delta_z_2_by_b_3_z = t10*t107
    t108 = -D_delta_x_3*s_3_x_by_b_3_z - D_delta_y_3*s_3_y_by_b_3_z - D_delta_z_3*s_3_z_by_b_3_z
    D_delta_x_3_by_b_3_z = t108*t4
    D_delta_y_3_by_b_3_z = t108*t7
    D_delta_z_3_by_b_3_z = t10*t108
    t109 = mu_3*s_3_x_by_b_3_z
    t110 = mu_3*s_3_y_by_b_3_z
    t111 = mu_3*s_3_z_by_b_3_z
    mu_1_by_b_3_z = t1*(-A_x_1*t109 - A_y_1*t110 - A_z_1*t111)
    mu_2_by_b_3_z = t1*(-A_x_2*t109 - A_y_2*t110 - A_z_2*t111)
    mu_3_by_b_3_z = t1*(-A_x_3*t109 - A_y_3*t110 - A_z_3*t111)
    x_1_by_l_d_1 = -l_d_1*t19
    s_1_x_by_l_d_1 = -n_1_x*x_1_by_l_d_1
    s_1_y_by_l_d_1 = -n_1_y*x_1_by_l_d_1
    s_1_z_by_l_d_1 = -n_1_z*x_1_by_l_d_1
    t112 = (
        -D_p_x_1*s_1_x_by_l_d_1 - D_p_y_1*s_1_y_by_l_d_1 - D_p_z_1*s_1_z_by_l_d_1 - t20*x_1_by_l_d_1
        - t21*x_1_by_l_d_1 - t31*x_1_by_l_d_1
    )
    D_p_x_1_by_l_d_1 = t112*t2
    D_p_y_1_by_l_d_1 = t112*t5
    D_p_z_1_by_l_d_1 = t112*t8
    t113 = -D_p_x_2*s_1_x_by_l_d_1 - D_p_y_2*s_1_y_by_l_d_1 - D_p_z_2*s_1_z_by_l_d_1
    D_p_x_2_by_l_d_1 = t113*t2
    D_p_y_2_by_l_d_1 = t113*t5
    D_p_z_2_by_l_d_1 = t113*t8
    t114 = -D_p_x_3*s_1_x_by_l_d_1 - D_p_y_3*s_1_y_by_l_d_1 - D_p_z_3*s_1_z_by_l_d_1
    D_p_x_3_by_l_d_1 = t114*t2
    D_p_y_3_by_l_d_1 = t114*t5
    D_p_z_3_by_l_d_1 = t114*t8
    t115 = -D_delta_x_1*s_1_x_by_l_d_1 - D_delta_y_1*s_1_y_by_l_d_1 - D_delta_z_1*s_1_z_by_l_d_1 + 1
    D_delta_x_1_by_l_d_1 = t115*t2
    D_delta_y_1_by_l_d_1 = t115*t5
    D_delta_z_1_by_l_d_1 = t115*t8
    t116 = -D_delta_x_2*s_1_x_by_l_d_1 - D_delta_y_2*s_1_y_by_l_d_1 - D_delta_z_2*s_1_z_by_l_d_1
    D_delta_x_2_by_l_d_1 = t116*t2
    D_delta_y_2_by_l_d_1 = t116*t5
    D_delta_z_2_by_l_d_1 = t116*t8
    t117 = -D_delta_x_3*s_1_x_by_l_d_1 - D_delta_y_3*s_1_y_by_l_d_1 - D_delta_z_3*s_1_z_by_l_d_1
    D_delta_x_3_by_l_d_1 = t117*t2
    D_delta_y_3_by_l_d_1 = t117*t5
    D_delta_z_3_by_l_d_1 = t117*t8
    t118 = mu_1*s_1_x_by_l_d_1
    t119 = mu_1*s_1_y_by_l_d_1
    t120 = mu_1*s_1_z_by_l_d_1
    mu_1_by_l_d_1 = t1*(-A_x_1*t118 - A_y_1*t119 - A_z_1*t120)
    mu_2_by_l_d_1 = t1*(-A_x_2*t118 - A_y_2*t119 - A_z_2*t120)
    mu_3_by_l_d_1 = t1*(-A_x_3*t118 - A_y_3*t119 - A_z_3*t120)
    x_2_by_l_d_2 = -l_d_2*t50
    s_2_x_by_l_d_2 = -n_2_x*x_2_by_l_d_2
    s_2_y_by_l_d_2 = -n_2_y*x_2_by_l_d_2
    s_2_z_by_l_d_2 = -n_2_z*x_2_by_l_d_2
    t121 = -D_p_x_1*s_2_x_by_l_d_2 - D_p_y_1*s_2_y_by_l_d_2 - D_p_z_1*s_2_z_by_l_d_2
    D_p_x_1_by_l_d_2 = t121*t3
    D_p_y_1_by_l_d_2 = t121*t6
    D_p_z_1_by_l_d_2 = t121*t9
    t122 = (
        -D_p_x_2*s_2_x_by_l_d_2 - D_p_y_2*s_2_y_by_l_d_2 - D_p_z_2*s_2_z_by_l_d_2 - t52*x_2_by_l_d_2
        - t53*x_2_by_l_d_2 - t63*x_2_by_l_d_2
    )
    D_p_x_2_by_l_d_2 = t122*t3
    D_p_y_2_by_l_d_2 = t122*t6
    D_p_z_2_by_l_d_2 = t122*t9
    t123 = -D_p_x_3*s_2_x_by_l_d_2 - D_p_y_3*s_2_y_by_l_d_2 - D_p_z_3*s_2_z_by_l_d_2
    D_p_x_3_by_l_d_2 = t123*t3
    D_p_y_3_by_l_d_2 = t123*t6
    D_p_z_3_by_l_d_2 = t123*t9
    t124 = -D_delta_x_1*s_2_x_by_l_d_2 - D_delta_y_1*s_2_y_by_l_d_2 - D_delta_z_1*s_2_z_by_l_d_2
    D_delta_x_1_by_l_d_2 = t124*t3
    D_delta_y_1_by_l_d_2 = t124*t6
    D_delta_z_1_by_l_d_2 = t124*t9
    t125 = -D_delta_x_2*s_2_x_by_l_d_2 - D_delta_y_2*s_2_y_by_l_d_2 - D_delta_z_2*s_2_z_by_l_d_2 + 1
    D_delta_x_2_by_l_d_2 = t125*t3
    D_delta_y_2_by_l_d_2 = t125*t6
    D_delta_z_2_by_l_d_2 = t125*t9
    t126 = -D_delta_x_3*s_2_x_by_l_d_2 - D_delta_y_3*s_2_y_by_l_d_2 - D_delta_z_3*s_2_z_by_l_d_2
    D_delta_x_3_by_l_d_2 = t126*t3
    D_delta_y_3_by_l_d_2 = t126*t6
    D_delta_z_3_by_l_d_2 = t126*t9
    t127 = mu_2*s_2_x_by_l_d_2
    t128 = mu_2*s_2_y_by_l_d_2
    t129 = mu_2*s_2_z_by_l_d_2
    mu_1_by_l_d_2 = t1*(-A_x_1*t127 - A_y_1*t128 - A_z_1*t129)
    mu_2_by_l_d_2 = t1*(-A_x_2*t127 - A_y_2*t128 - A_z_2*t129)
    mu_3_by_l_d_2 = t1*(-A_x_3*t127 - A_y_3*t128 - A_z_3*t129)
    x_3_by_l_d_3 = -l_d_3*t81
    s_3_x_by_l_d_3 = -n_3_x*x_3_by_l_d_3
    s_3_y_by_l_d_3 = -n_3_y*x_3_by_l_d_3
    s_3_z_by_l_d_3 = -n_3_z*x_3_by_l_d_3
    t130 = -D_p_x_1*s_3_x_by_l_d_3 - D_p_y_1*s_3_y_by_l_d_3 - D_p_z_1*s_3_z_by_l_d_3
    D_p_x_1_by_l_d_3 = t130*t4
    D_p_y_1_by_l_d_3 = t130*t7
    D_p_z_1_by_l_d_3 = t10*t130
    t131 = -D_p_x_2*s_3_x_by_l_d_3 - D_p_y_2*s_3_y_by_l_d_3 - D_p_z_2*s_3_z_by_l_d_3
    D_p_x_2_by_l_d_3 = t131*t4
    D_p_y_2_by_l_d_3 = t131*t7
    D_p_z_2_by_l_d_3 = t10*t131
    t132 = (
        -D_p_x_3*s_3_x_by_l_d_3 - D_p_y_3*s_3_y_by_l_d_3 - D_p_z_3*s_3_z_by_l_d_3 - t84*x_3_by_l_d_3
        - t85*x_3_by_l_d_3 - t95*x_3_by_l_d_3
    )
    D_p_x_3_by_l_d_3 = t132*t4
    D_p_y_3_by_l_d_3 = t132*t7
    D_p_z_3_by_l_d_3 = t10*t132
    t133 = -D_delta_x_1*s_3_x_by_l_d_3 - D_delta_y_1*s_3_y_by_l_d_3 - D_delta_z_1*s_3_z_by_l_d_3
    D_delta_x_1_by_l_d_3 = t133*t4
    D_delta_y_1_by_l_d_3 = t133*t7
    D_delta_z_1_by_l_d_3 = t10*t133
    t134 = -D_delta_x_2*s_3_x_by_l_d_3 - D_delta_y_2*s_3_y_by_l_d_3 - D_delta_z_2*s_3_z_by_l_d_3
    D_delta_x_2_by_l_d_3 = t134*t4
    D_delta_y_2_by_l_d_3 = t134*t7
    D_delta_z_2_by_l_d_3 = t10*t134
    t135 = -D_delta_x_3*s_3_x_by_l_d_3 - D_delta_y_3*s_3_y_by_l_d_3 - D_delta_z_3*s_3_z_by_l_d_3 + 1
    D_delta_x_3_by_l_d_3 = t135*t4
    D_delta_y_3_by_l_d_3 = t135*t7
    D_delta_z_3_by_l_d_3 = t10*t135
    t136 = mu_3*s_3_x_by_l_d_3
    t137 = mu_3*s_3_y_by_l_d_3
    t138 = mu_3*s_3_z_by_l_d_3
    mu_1_by_l_d_3 = t1*(-A_x_1*t136 - A_y_1*t137 - A_z_1*t138)
    mu_2_by_l_d_3 = t1*(-A_x_2*t136 - A_y_2*t137 - A_z_2*t138)
    mu_3_by_l_d_3 = t1*(-A_x_3*t136 - A_y_3*t137 - A_z_3*t138)
    t139 = (1/3)*m_d_1
    t140 = (1/3)*m_d_2
    t141 = (1/3)*m_d_3
    t142 = t139 + t14 + t140 + t141
    t143 = D_p_x_1*t142
    t144 = n_1_x*t139 + 2*t143
    t145 = D_p_y_1*t142
    t146 = n_1_y*t139 + 2*t145
    t147 = D_p_z_1*t142
    t148 = n_1_z*t139 + 2*t147
    t149 = (1/6)*m_d_2
    t150 = D_p_x_2*t142
    t151 = n_2_x*t149 + t150
    t152 = (1/6)*m_d_1
    t153 = n_1_x*t152 + t143
    t154 = D_p_y_2*t142
    t155 = n_2_y*t149 + t154
    t156 = n_1_y*t152 + t145
    t157 = D_p_z_2*t142
    t158 = n_2_z*t149 + t157
    t159 = n_1_z*t152 + t147
    t160 = (1/6)*m_d_3
    t161 = D_p_x_3*t142
    t162 = n_3_x*t160 + t161
    t163 = D_p_y_3*t142
    t164 = n_3_y*t160 + t163
    t165 = D_p_z_3*t142
    t166 = n_3_z*t160 + t165
    t167 = rho_b*x_1_by_b_1_x
    t168 = (1/6)*R_p_1
    t169 = t167*t168
    t170 = D_p_x_1_by_b_1_x*t142
    t171 = D_p_y_1_by_b_1_x*t142
    t172 = D_p_z_1_by_b_1_x*t142
    t173 = n_2_x*t140 + 2*t150
    t174 = n_2_y*t140 + 2*t154
    t175 = n_2_z*t140 + 2*t157
    t176 = D_p_x_2_by_b_1_x*t142
    t177 = D_p_y_2_by_b_1_x*t142
    t178 = D_p_z_2_by_b_1_x*t142
    t179 = n_3_x*t141 + 2*t161
    t180 = n_3_y*t141 + 2*t163
    t181 = n_3_z*t141 + 2*t165
    t182 = D_p_x_3_by_b_1_x*t142
    t183 = D_p_y_3_by_b_1_x*t142
    t184 = D_p_z_3_by_b_1_x*t142
    t185 = R_p_1**2
    t186 = (1/3)*t185
    t187 = t167*t186
    t188 = D_delta_x_1*t142
    t189 = 2*t188
    t190 = D_delta_y_1*t142
    t191 = 2*t190
    t192 = D_delta_z_1*t142
    t193 = 2*t192
    t194 = D_delta_x_1_by_b_1_x*t142
    t195 = D_delta_y_1_by_b_1_x*t142
    t196 = D_delta_z_1_by_b_1_x*t142
    t197 = D_delta_x_2*t142
    t198 = 2*t197
    t199 = D_delta_y_2*t142
    t200 = 2*t199
    t201 = D_delta_z_2*t142
    t202 = 2*t201
    t203 = D_delta_x_3*t142
    t204 = D_delta_y_3*t142
    t205 = D_delta_z_3*t142
    t206 = 2*t203
    t207 = 2*t204
    t208 = 2*t205
    t209 = rho_b*x_1_by_b_1_y
    t210 = t168*t209
    t211 = t186*t209
    t212 = rho_b*x_1_by_b_1_z
    t213 = t168*t212
    t214 = t186*t212
    t215 = rho_b*x_2_by_b_2_x
    t216 = (1/6)*R_p_2
    t217 = t215*t216
    t218 = R_p_2**2
    t219 = (1/3)*t218
    t220 = t215*t219
    t221 = rho_b*x_2_by_b_2_y
    t222 = t216*t221
    t223 = t219*t221
    t224 = rho_b*x_2_by_b_2_z
    t225 = t216*t224
    t226 = t219*t224
    t227 = rho_b*x_3_by_b_3_x
    t228 = (1/6)*R_p_3
    t229 = t227*t228
    t230 = R_p_3**2
    t231 = (1/3)*t230
    t232 = t227*t231
    t233 = rho_b*x_3_by_b_3_y
    t234 = t228*t233
    t235 = t231*t233
    t236 = rho_b*x_3_by_b_3_z
    t237 = t228*t236
    t238 = t231*t236
    t239 = rho_b*x_1_by_l_d_1
    t240 = t168*t239
    t241 = t186*t239
    t242 = rho_b*x_2_by_l_d_2
    t243 = t216*t242
    t244 = t219*t242
    t245 = rho_b*x_3_by_l_d_3
    t246 = t228*t245
    t247 = t231*t245
    t248 = D_p_x_1*mu_2
    t249 = 2*D_p_x_1_by_b_1_x
    t250 = D_p_x_1*mu_3
    t251 = U_1_x_1*mu_1
    t252 = D_p_y_1*mu_2
    t253 = 2*D_p_y_1_by_b_1_x
    t254 = D_p_y_1*mu_3
    t255 = U_1_y_1*mu_1
    t256 = D_p_z_1*mu_2
    t257 = 2*D_p_z_1_by_b_1_x
    t258 = D_p_z_1*mu_3
    t259 = U_1_z_1*mu_1
    t260 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    t261 = -D_p_x_1**2 - D_p_y_1**2 - D_p_z_1**2
    t262 = F_T*c_T + 1
    t263 = a_B_1 + 1
    t264 = c_E*t262
    t265 = k_sp_1*t263*w_b_1
    t266 = t264*t265
    t267 = 1.0/((l_f_1_2 + t266)**2)
    t268 = t262*t265
    t269 = t268*x_1_by_b_1_x
    t270 = t267*t269
    t271 = 1.0/((l_f_1_3 + t266)**2)
    t272 = D_p_x_2*mu_1
    t273 = D_p_x_2*mu_3
    t274 = U_2_x_2*mu_2
    t275 = D_p_y_2*mu_1
    t276 = D_p_y_2*mu_3
    t277 = U_2_y_2*mu_2
    t278 = D_p_z_2*mu_1
    t279 = D_p_z_2*mu_3
    t280 = U_2_z_2*mu_2
    t281 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    t282 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    t283 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2
    t284 = D_p_x_3*mu_1
    t285 = D_p_x_3*mu_2
    t286 = U_3_x_3*mu_3
    t287 = D_p_y_3*mu_1
    t288 = D_p_y_3*mu_2
    t289 = U_3_y_3*mu_3
    t290 = D_p_z_3*mu_1
    t291 = D_p_z_3*mu_2
    t292 = U_3_z_3*mu_3
    t293 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    t294 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3
    t295 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    t296 = t269*t271
    t297 = -R_p_1*t296
    t298 = R_p_1*t270
    t299 = D_p_x_1_by_b_1_x*k_C
    t300 = D_p_y_1_by_b_1_x*k_C
    t301 = D_p_z_1_by_b_1_x*k_C
    t302 = D_delta_x_1*mu_1
    t303 = D_delta_x_1*mu_2
    t304 = D_delta_x_1*mu_3
    t305 = D_delta_y_1*mu_1
    t306 = D_delta_y_1*mu_2
    t307 = D_delta_y_1*mu_3
    t308 = D_delta_z_1*mu_1
    t309 = D_delta_z_1*mu_2
    t310 = D_delta_z_1*mu_3
    t311 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t312 = -D_delta_x_1*D_p_x_1 - D_delta_y_1*D_p_y_1 - D_delta_z_1*D_p_z_1
    t313 = D_p_x_1*k_C - t248 - t250 - t251
    t314 = D_p_y_1*k_C - t252 - t254 - t255
    t315 = D_p_z_1*k_C - t256 - t258 - t259
    t316 = D_delta_x_2*mu_1
    t317 = D_delta_x_2*mu_2
    t318 = D_delta_x_2*mu_3
    t319 = D_delta_y_2*mu_1
    t320 = D_delta_y_2*mu_2
    t321 = D_delta_y_2*mu_3
    t322 = D_delta_z_2*mu_1
    t323 = D_delta_z_2*mu_2
    t324 = D_delta_z_2*mu_3
    t325 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t326 = -D_delta_x_2*D_p_x_1 - D_delta_y_2*D_p_y_1 - D_delta_z_2*D_p_z_1
    t327 = D_delta_x_3*mu_1
    t328 = D_delta_x_3*mu_2
    t329 = D_delta_x_3*mu_3
    t330 = D_delta_y_3*mu_1
    t331 = D_delta_y_3*mu_2
    t332 = D_delta_y_3*mu_3
    t333 = D_delta_z_3*mu_1
    t334 = D_delta_z_3*mu_2
    t335 = D_delta_z_3*mu_3
    t336 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t337 = -D_delta_x_3*D_p_x_1 - D_delta_y_3*D_p_y_1 - D_delta_z_3*D_p_z_1
    t338 = -t270 + t296
    t339 = 2*D_p_x_2_by_b_1_x
    t340 = 2*D_p_y_2_by_b_1_x
    t341 = 2*D_p_z_2_by_b_1_x
    t342 = -D_p_x_2**2 - D_p_y_2**2 - D_p_z_2**2
    t343 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t344 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3
    t345 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    t346 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    t347 = D_p_x_2_by_b_1_x*k_C
    t348 = D_p_y_2_by_b_1_x*k_C
    t349 = D_p_z_2_by_b_1_x*k_C
    t350 = -D_delta_x_1*D_p_x_2 - D_delta_y_1*D_p_y_2 - D_delta_z_1*D_p_z_2
    t351 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t352 = D_p_x_2*k_C - t272 - t273 - t274
    t353 = D_p_y_2*k_C - t275 - t276 - t277
    t354 = D_p_z_2*k_C - t278 - t279 - t280
    t355 = -D_delta_x_2*D_p_x_2 - D_delta_y_2*D_p_y_2 - D_delta_z_2*D_p_z_2
    t356 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t357 = -D_delta_x_3*D_p_x_2 - D_delta_y_3*D_p_y_2 - D_delta_z_3*D_p_z_2
    t358 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t359 = 2*D_p_x_3_by_b_1_x
    t360 = 2*D_p_y_3_by_b_1_x
    t361 = 2*D_p_z_3_by_b_1_x
    t362 = -D_p_x_3**2 - D_p_y_3**2 - D_p_z_3**2
    t363 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t364 = D_p_x_3_by_b_1_x*k_C
    t365 = D_p_y_3_by_b_1_x*k_C
    t366 = D_p_z_3_by_b_1_x*k_C
    t367 = -D_delta_x_1*D_p_x_3 - D_delta_y_1*D_p_y_3 - D_delta_z_1*D_p_z_3
    t368 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t369 = D_p_x_3*k_C - t284 - t285 - t286
    t370 = D_p_y_3*k_C - t287 - t288 - t289
    t371 = D_p_z_3*k_C - t290 - t291 - t292
    t372 = -D_delta_x_2*D_p_x_3 - D_delta_y_2*D_p_y_3 - D_delta_z_2*D_p_z_3
    t373 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t374 = -D_delta_x_3*D_p_x_3 - D_delta_y_3*D_p_y_3 - D_delta_z_3*D_p_z_3
    t375 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t376 = D_delta_x_1**2 + D_delta_y_1**2 + D_delta_z_1**2
    t377 = 2*D_delta_x_1*k_C - 2*t302 - 2*t303 - 2*t304
    t378 = 2*D_delta_y_1*k_C - 2*t305 - 2*t306 - 2*t307
    t379 = 2*D_delta_z_1*k_C - 2*t308 - 2*t309 - 2*t310
    t380 = 1 - t376
    t381 = -D_delta_x_1*D_delta_x_2 - D_delta_y_1*D_delta_y_2 - D_delta_z_1*D_delta_z_2
    t382 = D_delta_x_2*k_C - t316 - t317 - t318
    t383 = D_delta_x_1*k_C - t302 - t303 - t304
    t384 = D_delta_y_2*k_C - t319 - t320 - t321
    t385 = D_delta_y_1*k_C - t305 - t306 - t307
    t386 = D_delta_z_2*k_C - t322 - t323 - t324
    t387 = D_delta_z_1*k_C - t308 - t309 - t310
    t388 = -D_delta_x_1*D_delta_x_3 - D_delta_y_1*D_delta_y_3 - D_delta_z_1*D_delta_z_3
    t389 = D_delta_x_3*k_C - t327 - t328 - t329
    t390 = D_delta_y_3*k_C - t330 - t331 - t332
    t391 = D_delta_z_3*k_C - t333 - t334 - t335
    t392 = D_delta_x_2**2 + D_delta_y_2**2 + D_delta_z_2**2
    t393 = 2*D_delta_x_2*k_C - 2*t316 - 2*t317 - 2*t318
    t394 = 2*D_delta_y_2*k_C - 2*t319 - 2*t320 - 2*t321
    t395 = 2*D_delta_z_2*k_C - 2*t322 - 2*t323 - 2*t324
    t396 = 1 - t392
    t397 = -D_delta_x_2*D_delta_x_3 - D_delta_y_2*D_delta_y_3 - D_delta_z_2*D_delta_z_3
    t398 = D_delta_x_3**2 + D_delta_y_3**2 + D_delta_z_3**2
    t399 = 2*D_delta_x_3*k_C - 2*t327 - 2*t328 - 2*t329
    t400 = 2*D_delta_y_3*k_C - 2*t330 - 2*t331 - 2*t332
    t401 = 2*D_delta_z_3*k_C - 2*t333 - 2*t334 - 2*t335
    t402 = 1 - t398
    t403 = 2*D_p_x_1_by_b_1_y
    t404 = 2*D_p_y_1_by_b_1_y
    t405 = 2*D_p_z_1_by_b_1_y
    t406 = t268*x_1_by_b_1_y
    t407 = t267*t406
    t408 = t271*t406
    t409 = -R_p_1*t408
    t410 = R_p_1*t407
    t411 = D_delta_x_1*k_C
    t412 = D_delta_y_1*k_C
    t413 = D_delta_z_1*k_C
    t414 = D_delta_x_2*k_C
    t415 = D_delta_y_2*k_C
    t416 = D_delta_z_2*k_C
    t417 = D_delta_x_3*k_C
    t418 = D_delta_y_3*k_C
    t419 = D_delta_z_3*k_C
    t420 = -t407 + t408
    t421 = 2*D_p_x_2_by_b_1_y
    t422 = 2*D_p_y_2_by_b_1_y
    t423 = 2*D_p_z_2_by_b_1_y
    t424 = 2*D_p_x_3_by_b_1_y
    t425 = 2*D_p_y_3_by_b_1_y
    t426 = 2*D_p_z_3_by_b_1_y
    t427 = 2*D_p_x_1_by_b_1_z
    t428 = 2*D_p_y_1_by_b_1_z
    t429 = 2*D_p_z_1_by_b_1_z
    t430 = t268*x_1_by_b_1_z
    t431 = t267*t430
    t432 = t271*t430
    t433 = -R_p_1*t432
    t434 = R_p_1*t431
    t435 = -t431 + t432
    t436 = 2*D_p_x_2_by_b_1_z
    t437 = 2*D_p_y_2_by_b_1_z
    t438 = 2*D_p_z_2_by_b_1_z
    t439 = 2*D_p_x_3_by_b_1_z
    t440 = 2*D_p_y_3_by_b_1_z
    t441 = 2*D_p_z_3_by_b_1_z
    t442 = 2*D_p_x_1_by_b_2_x
    t443 = 2*D_p_y_1_by_b_2_x
    t444 = 2*D_p_z_1_by_b_2_x
    t445 = 2*D_p_x_2_by_b_2_x
    t446 = 2*D_p_y_2_by_b_2_x
    t447 = 2*D_p_z_2_by_b_2_x
    t448 = a_B_2 + 1
    t449 = k_sp_2*t448*w_b_2
    t450 = t264*t449
    t451 = 1.0/((l_f_2_2 + t450)**2)
    t452 = t262*t449
    t453 = t452*x_2_by_b_2_x
    t454 = t451*t453
    t455 = 1.0/((l_f_2_3 + t450)**2)
    t456 = t453*t455
    t457 = -R_p_2*t456
    t458 = R_p_2*t454
    t459 = -t454 + t456
    t460 = 2*D_p_x_3_by_b_2_x
    t461 = 2*D_p_y_3_by_b_2_x
    t462 = 2*D_p_z_3_by_b_2_x
    t463 = 2*D_p_x_1_by_b_2_y
    t464 = 2*D_p_y_1_by_b_2_y
    t465 = 2*D_p_z_1_by_b_2_y
    t466 = 2*D_p_x_2_by_b_2_y
    t467 = 2*D_p_y_2_by_b_2_y
    t468 = 2*D_p_z_2_by_b_2_y
    t469 = t452*x_2_by_b_2_y
    t470 = t451*t469
    t471 = t455*t469
    t472 = -R_p_2*t471
    t473 = R_p_2*t470
    t474 = -t470 + t471
    t475 = 2*D_p_x_3_by_b_2_y
    t476 = 2*D_p_y_3_by_b_2_y
    t477 = 2*D_p_z_3_by_b_2_y
    t478 = 2*D_p_x_1_by_b_2_z
    t479 = 2*D_p_y_1_by_b_2_z
    t480 = 2*D_p_z_1_by_b_2_z
    t481 = 2*D_p_x_2_by_b_2_z
    t482 = 2*D_p_y_2_by_b_2_z
    t483 = 2*D_p_z_2_by_b_2_z
    t484 = t452*x_2_by_b_2_z
    t485 = t451*t484
    t486 = t455*t484
    t487 = -R_p_2*t486
    t488 = R_p_2*t485
    t489 = -t485 + t486
    t490 = 2*D_p_x_3_by_b_2_z
    t491 = 2*D_p_y_3_by_b_2_z
    t492 = 2*D_p_z_3_by_b_2_z
    t493 = 2*D_p_x_1_by_b_3_x
    t494 = 2*D_p_y_1_by_b_3_x
    t495 = 2*D_p_z_1_by_b_3_x
    t496 = 2*D_p_x_2_by_b_3_x
    t497 = 2*D_p_y_2_by_b_3_x
    t498 = 2*D_p_z_2_by_b_3_x
    t499 = 2*D_p_x_3_by_b_3_x
    t500 = 2*D_p_y_3_by_b_3_x
    t501 = 2*D_p_z_3_by_b_3_x
    t502 = a_B_3 + 1
    t503 = k_sp_3*t502*w_b_3
    t504 = t264*t503
    t505 = 1.0/((l_f_3_2 + t504)**2)
    t506 = t262*t503
    t507 = t506*x_3_by_b_3_x
    t508 = t505*t507
    t509 = 1.0/((l_f_3_3 + t504)**2)
    t510 = t507*t509
    t511 = -R_p_3*t510
    t512 = R_p_3*t508
    t513 = -t508 + t510
    t514 = 2*D_p_x_1_by_b_3_y
    t515 = 2*D_p_y_1_by_b_3_y
    t516 = 2*D_p_z_1_by_b_3_y
    t517 = 2*D_p_x_2_by_b_3_y
    t518 = 2*D_p_y_2_by_b_3_y
    t519 = 2*D_p_z_2_by_b_3_y
    t520 = 2*D_p_x_3_by_b_3_y
    t521 = 2*D_p_y_3_by_b_3_y
    t522 = 2*D_p_z_3_by_b_3_y
    t523 = t506*x_3_by_b_3_y
    t524 = t505*t523
    t525 = t509*t523
    t526 = -R_p_3*t525
    t527 = R_p_3*t524
    t528 = -t524 + t525
    t529 = 2*D_p_x_1_by_b_3_z
    t530 = 2*D_p_y_1_by_b_3_z
    t531 = 2*D_p_z_1_by_b_3_z
    t532 = 2*D_p_x_2_by_b_3_z
    t533 = 2*D_p_y_2_by_b_3_z
    t534 = 2*D_p_z_2_by_b_3_z
    t535 = 2*D_p_x_3_by_b_3_z
    t536 = 2*D_p_y_3_by_b_3_z
    t537 = 2*D_p_z_3_by_b_3_z
    t538 = t506*x_3_by_b_3_z
    t539 = t505*t538
    t540 = t509*t538
    t541 = -R_p_3*t540
    t542 = R_p_3*t539
    t543 = -t539 + t540
    t544 = 2*D_p_x_1_by_l_d_1
    t545 = 2*D_p_y_1_by_l_d_1
    t546 = 2*D_p_z_1_by_l_d_1
    t547 = t268*x_1_by_l_d_1
    t548 = t267*t547
    t549 = t271*t547
    t550 = -R_p_1*t549
    t551 = R_p_1*t548
    t552 = -t548 + t549
    t553 = 2*D_p_x_2_by_l_d_1
    t554 = 2*D_p_y_2_by_l_d_1
    t555 = 2*D_p_z_2_by_l_d_1
    t556 = 2*D_p_x_3_by_l_d_1
    t557 = 2*D_p_y_3_by_l_d_1
    t558 = 2*D_p_z_3_by_l_d_1
    t559 = 2*D_p_x_1_by_l_d_2
    t560 = 2*D_p_y_1_by_l_d_2
    t561 = 2*D_p_z_1_by_l_d_2
    t562 = 2*D_p_x_2_by_l_d_2
    t563 = 2*D_p_y_2_by_l_d_2
    t564 = 2*D_p_z_2_by_l_d_2
    t565 = t452*x_2_by_l_d_2
    t566 = t451*t565
    t567 = t455*t565
    t568 = -R_p_2*t567
    t569 = R_p_2*t566
    t570 = -t566 + t567
    t571 = 2*D_p_x_3_by_l_d_2
    t572 = 2*D_p_y_3_by_l_d_2
    t573 = 2*D_p_z_3_by_l_d_2
    t574 = 2*D_p_x_1_by_l_d_3
    t575 = 2*D_p_y_1_by_l_d_3
    t576 = 2*D_p_z_1_by_l_d_3
    t577 = 2*D_p_x_2_by_l_d_3
    t578 = 2*D_p_y_2_by_l_d_3
    t579 = 2*D_p_z_2_by_l_d_3
    t580 = 2*D_p_x_3_by_l_d_3
    t581 = 2*D_p_y_3_by_l_d_3
    t582 = 2*D_p_z_3_by_l_d_3
    t583 = t506*x_3_by_l_d_3
    t584 = t505*t583
    t585 = t509*t583
    t586 = -R_p_3*t585
    t587 = R_p_3*t584
    t588 = -t584 + t585
    M_theta_out = _listed(batch, dtype, (
        D_p_x_1_by_b_1_x*t144 + D_p_y_1_by_b_1_x*t146 + D_p_z_1_by_b_1_x*t148,
        D_p_x_1_by_b_1_x*t151 + D_p_x_2_by_b_1_x*t153 + D_p_y_1_by_b_1_x*t155 + D_p_y_2_by_b_1_x*t156
        + D_p_z_1_by_b_1_x*t158 + D_p_z_2_by_b_1_x*t159,
        D_p_x_1_by_b_1_x*t162 + D_p_x_3_by_b_1_x*t153 + D_p_y_1_by_b_1_x*t164 + D_p_y_3_by_b_1_x*t156
        + D_p_z_1_by_b_1_x*t166 + D_p_z_3_by_b_1_x*t159,
        -t169, t169,
        D_delta_x_1*t170 + D_delta_x_1_by_b_1_x*t153 + D_delta_y_1*t171 + D_delta_y_1_by_b_1_x*t156
        + D_delta_z_1*t172 + D_delta_z_1_by_b_1_x*t159,
        D_delta_x_2*t170 + D_delta_x_2_by_b_1_x*t153 + D_delta_y_2*t171 + D_delta_y_2_by_b_1_x*t156
        + D_delta_z_2*t172 + D_delta_z_2_by_b_1_x*t159,
        D_delta_x_3*t170 + D_delta_x_3_by_b_1_x*t153 + D_delta_y_3*t171 + D_delta_y_3_by_b_1_x*t156
        + D_delta_z_3*t172 + D_delta_z_3_by_b_1_x*t159,
        D_p_x_1_by_b_1_x*t15, D_p_y_1_by_b_1_x*t15, D_p_z_1_by_b_1_x*t15,
        D_p_x_2_by_b_1_x*t173 + D_p_y_2_by_b_1_x*t174 + D_p_z_2_by_b_1_x*t175,
        D_p_x_2_by_b_1_x*t162 + D_p_x_3_by_b_1_x*t151 + D_p_y_2_by_b_1_x*t164 + D_p_y_3_by_b_1_x*t155
        + D_p_z_2_by_b_1_x*t166 + D_p_z_3_by_b_1_x*t158,
        D_delta_x_1*t176 + D_delta_x_1_by_b_1_x*t151 + D_delta_y_1*t177 + D_delta_y_1_by_b_1_x*t155
        + D_delta_z_1*t178 + D_delta_z_1_by_b_1_x*t158,
        D_delta_x_2*t176 + D_delta_x_2_by_b_1_x*t151 + D_delta_y_2*t177 + D_delta_y_2_by_b_1_x*t155
        + D_delta_z_2*t178 + D_delta_z_2_by_b_1_x*t158,
        D_delta_x_3*t176 + D_delta_x_3_by_b_1_x*t151 + D_delta_y_3*t177 + D_delta_y_3_by_b_1_x*t155
        + D_delta_z_3*t178 + D_delta_z_3_by_b_1_x*t158,
        D_p_x_2_by_b_1_x*t15, D_p_y_2_by_b_1_x*t15, D_p_z_2_by_b_1_x*t15,
        D_p_x_3_by_b_1_x*t179 + D_p_y_3_by_b_1_x*t180 + D_p_z_3_by_b_1_x*t181,
        D_delta_x_1*t182 + D_delta_x_1_by_b_1_x*t162 + D_delta_y_1*t183 + D_delta_y_1_by_b_1_x*t164
        + D_delta_z_1*t184 + D_delta_z_1_by_b_1_x*t166,
        D_delta_x_2*t182 + D_delta_x_2_by_b_1_x*t162 + D_delta_y_2*t183 + D_delta_y_2_by_b_1_x*t164
        + D_delta_z_2*t184 + D_delta_z_2_by_b_1_x*t166,
        D_delta_x_3*t182 + D_delta_x_3_by_b_1_x*t162 + D_delta_y_3*t183 + D_delta_y_3_by_b_1_x*t164
        + D_delta_z_3*t184 + D_delta_z_3_by_b_1_x*t166,
        D_p_x_3_by_b_1_x*t15, D_p_y_3_by_b_1_x*t15, D_p_z_3_by_b_1_x*t15, -t187, -t169, t187, t169,
        D_delta_x_1_by_b_1_x*t189 + D_delta_y_1_by_b_1_x*t191 + D_delta_z_1_by_b_1_x*t193,
        D_delta_x_2*t194 + D_delta_x_2_by_b_1_x*t188 + D_delta_y_2*t195 + D_delta_y_2_by_b_1_x*t190
        + D_delta_z_2*t196 + D_delta_z_2_by_b_1_x*t192,
        D_delta_x_3*t194 + D_delta_x_3_by_b_1_x*t188 + D_delta_y_3*t195 + D_delta_y_3_by_b_1_x*t190
        + D_delta_z_3*t196 + D_delta_z_3_by_b_1_x*t192,
        D_delta_x_1_by_b_1_x*t15, D_delta_y_1_by_b_1_x*t15, D_delta_z_1_by_b_1_x*t15,
        D_delta_x_2_by_b_1_x*t198 + D_delta_y_2_by_b_1_x*t200 + D_delta_z_2_by_b_1_x*t202,
        D_delta_x_2_by_b_1_x*t203 + D_delta_x_3_by_b_1_x*t197 + D_delta_y_2_by_b_1_x*t204
        + D_delta_y_3_by_b_1_x*t199 + D_delta_z_2_by_b_1_x*t205 + D_delta_z_3_by_b_1_x*t201,
        D_delta_x_2_by_b_1_x*t15, D_delta_y_2_by_b_1_x*t15, D_delta_z_2_by_b_1_x*t15,
        D_delta_x_3_by_b_1_x*t206 + D_delta_y_3_by_b_1_x*t207 + D_delta_z_3_by_b_1_x*t208,
        D_delta_x_3_by_b_1_x*t15, D_delta_y_3_by_b_1_x*t15, D_delta_z_3_by_b_1_x*t15,
        D_p_x_1_by_b_1_y*t144 + D_p_y_1_by_b_1_y*t146 + D_p_z_1_by_b_1_y*t148,
        D_p_x_1_by_b_1_y*t151 + D_p_x_2_by_b_1_y*t153 + D_p_y_1_by_b_1_y*t155 + D_p_y_2_by_b_1_y*t156
        + D_p_z_1_by_b_1_y*t158 + D_p_z_2_by_b_1_y*t159,
        D_p_x_1_by_b_1_y*t162 + D_p_x_3_by_b_1_y*t153 + D_p_y_1_by_b_1_y*t164 + D_p_y_3_by_b_1_y*t156
        + D_p_z_1_by_b_1_y*t166 + D_p_z_3_by_b_1_y*t159,
        -t210, t210,
        D_delta_x_1_by_b_1_y*t153 + D_delta_y_1_by_b_1_y*t156 + D_delta_z_1_by_b_1_y*t159
        + D_p_x_1_by_b_1_y*t188 + D_p_y_1_by_b_1_y*t190 + D_p_z_1_by_b_1_y*t192,
        D_delta_x_2_by_b_1_y*t153 + D_delta_y_2_by_b_1_y*t156 + D_delta_z_2_by_b_1_y*t159
        + D_p_x_1_by_b_1_y*t197 + D_p_y_1_by_b_1_y*t199 + D_p_z_1_by_b_1_y*t201,
        D_delta_x_3_by_b_1_y*t153 + D_delta_y_3_by_b_1_y*t156 + D_delta_z_3_by_b_1_y*t159
        + D_p_x_1_by_b_1_y*t203 + D_p_y_1_by_b_1_y*t204 + D_p_z_1_by_b_1_y*t205,
        D_p_x_1_by_b_1_y*t15, D_p_y_1_by_b_1_y*t15, D_p_z_1_by_b_1_y*t15,
        D_p_x_2_by_b_1_y*t173 + D_p_y_2_by_b_1_y*t174 + D_p_z_2_by_b_1_y*t175,
        D_p_x_2_by_b_1_y*t162 + D_p_x_3_by_b_1_y*t151 + D_p_y_2_by_b_1_y*t164 + D_p_y_3_by_b_1_y*t155
        + D_p_z_2_by_b_1_y*t166 + D_p_z_3_by_b_1_y*t158,
        D_delta_x_1_by_b_1_y*t151 + D_delta_y_1_by_b_1_y*t155 + D_delta_z_1_by_b_1_y*t158
        + D_p_x_2_by_b_1_y*t188 + D_p_y_2_by_b_1_y*t190 + D_p_z_2_by_b_1_y*t192,
        D_delta_x_2_by_b_1_y*t151 + D_delta_y_2_by_b_1_y*t155 + D_delta_z_2_by_b_1_y*t158
        + D_p_x_2_by_b_1_y*t197 + D_p_y_2_by_b_1_y*t199 + D_p_z_2_by_b_1_y*t201,
        D_delta_x_3_by_b_1_y*t151 + D_delta_y_3_by_b_1_y*t155 + D_delta_z_3_by_b_1_y*t158
        + D_p_x_2_by_b_1_y*t203 + D_p_y_2_by_b_1_y*t204 + D_p_z_2_by_b_1_y*t205,
        D_p_x_2_by_b_1_y*t15, D_p_y_2_by_b_1_y*t15, D_p_z_2_by_b_1_y*t15,
        D_p_x_3_by_b_1_y*t179 + D_p_y_3_by_b_1_y*t180 + D_p_z_3_by_b_1_y*t181,
        D_delta_x_1_by_b_1_y*t162 + D_delta_y_1_by_b_1_y*t164 + D_delta_z_1_by_b_1_y*t166
        + D_p_x_3_by_b_1_y*t188 + D_p_y_3_by_b_1_y*t190 + D_p_z_3_by_b_1_y*t192,
        D_delta_x_2_by_b_1_y*t162 + D_delta_y_2_by_b_1_y*t164 + D_delta_z_2_by_b_1_y*t166
        + D_p_x_3_by_b_1_y*t197 + D_p_y_3_by_b_1_y*t199 + D_p_z_3_by_b_1_y*t201,
        D_delta_x_3_by_b_1_y*t162 + D_delta_y_3_by_b_1_y*t164 + D_delta_z_3_by_b_1_y*t166
        + D_p_x_3_by_b_1_y*t203 + D_p_y_3_by_b_1_y*t204 + D_p_z_3_by_b_1_y*t205,
        D_p_x_3_by_b_1_y*t15, D_p_y_3_by_b_1_y*t15, D_p_z_3_by_b_1_y*t15, -t211, -t210, t211, t210,
        D_delta_x_1_by_b_1_y*t189 + D_delta_y_1_by_b_1_y*t191 + D_delta_z_1_by_b_1_y*t193,
        D_delta_x_1_by_b_1_y*t197 + D_delta_x_2_by_b_1_y*t188 + D_delta_y_1_by_b_1_y*t199
        + D_delta_y_2_by_b_1_y*t190 + D_delta_z_1_by_b_1_y*t201 + D_delta_z_2_by_b_1_y*t192,
        D_delta_x_1_by_b_1_y*t203 + D_delta_x_3_by_b_1_y*t188 + D_delta_y_1_by_b_1_y*t204
        + D_delta_y_3_by_b_1_y*t190 + D_delta_z_1_by_b_1_y*t205 + D_delta_z_3_by_b_1_y*t192,
        D_delta_x_1_by_b_1_y*t15, D_delta_y_1_by_b_1_y*t15, D_delta_z_1_by_b_1_y*t15,
        D_delta_x_2_by_b_1_y*t198 + D_delta_y_2_by_b_1_y*t200 + D_delta_z_2_by_b_1_y*t202,
        D_delta_x_2_by_b_1_y*t203 + D_delta_x_3_by_b_1_y*t197 + D_delta_y_2_by_b_1_y*t204
        + D_delta_y_3_by_b_1_y*t199 + D_delta_z_2_by_b_1_y*t205 + D_delta_z_3_by_b_1_y*t201,
        D_delta_x_2_by_b_1_y*t15, D_delta_y_2_by_b_1_y*t15, D_delta_z_2_by_b_1_y*t15,
        D_delta_x_3_by_b_1_y*t206 + D_delta_y_3_by_b_1_y*t207 + D_delta_z_3_by_b_1_y*t208,
        D_delta_x_3_by_b_1_y*t15, D_delta_y_3_by_b_1_y*t15, D_delta_z_3_by_b_1_y*t15,
        D_p_x_1_by_b_1_z*t144 + D_p_y_1_by_b_1_z*t146 + D_p_z_1_by_b_1_z*t148,
        D_p_x_1_by_b_1_z*t151 + D_p_x_2_by_b_1_z*t153 + D_p_y_1_by_b_1_z*t155 + D_p_y_2_by_b_1_z*t156
        + D_p_z_1_by_b_1_z*t158 + D_p_z_2_by_b_1_z*t159,
        D_p_x_1_by_b_1_z*t162 + D_p_x_3_by_b_1_z*t153 + D_p_y_1_by_b_1_z*t164 + D_p_y_3_by_b_1_z*t156
        + D_p_z_1_by_b_1_z*t166 + D_p_z_3_by_b_1_z*t159,
        -t213, t213,
        D_delta_x_1_by_b_1_z*t153 + D_delta_y_1_by_b_1_z*t156 + D_delta_z_1_by_b_1_z*t159
        + D_p_x_1_by_b_1_z*t188 + D_p_y_1_by_b_1_z*t190 + D_p_z_1_by_b_1_z*t192,
        D_delta_x_2_by_b_1_z*t153 + D_delta_y_2_by_b_1_z*t156 + D_delta_z_2_by_b_1_z*t159
        + D_p_x_1_by_b_1_z*t197 + D_p_y_1_by_b_1_z*t199 + D_p_z_1_by_b_1_z*t201,
        D_delta_x_3_by_b_1_z*t153 + D_delta_y_3_by_b_1_z*t156 + D_delta_z_3_by_b_1_z*t159
        + D_p_x_1_by_b_1_z*t203 + D_p_y_1_by_b_1_z*t204 + D_p_z_1_by_b_1_z*t205,
        D_p_x_1_by_b_1_z*t15, D_p_y_1_by_b_1_z*t15, D_p_z_1_by_b_1_z*t15,
        D_p_x_2_by_b_1_z*t173 + D_p_y_2_by_b_1_z*t174 + D_p_z_2_by_b_1_z*t175,
        D_p_x_2_by_b_1_z*t162 + D_p_x_3_by_b_1_z*t151 + D_p_y_2_by_b_1_z*t164 + D_p_y_3_by_b_1_z*t155
        + D_p_z_2_by_b_1_z*t166 + D_p_z_3_by_b_1_z*t158,
        D_delta_x_1_by_b_1_z*t151 + D_delta_y_1_by_b_1_z*t155 + D_delta_z_1_by_b_1_z*t158
        + D_p_x_2_by_b_1_z*t188 + D_p_y_2_by_b_1_z*t190 + D_p_z_2_by_b_1_z*t192,
        D_delta_x_2_by_b_1_z*t151 + D_delta_y_2_by_b_1_z*t155 + D_delta_z_2_by_b_1_z*t158
        + D_p_x_2_by_b_1_z*t197 + D_p_y_2_by_b_1_z*t199 + D_p_z_2_by_b_1_z*t201,
        D_delta_x_3_by_b_1_z*t151 + D_delta_y_3_by_b_1_z*t155 + D_delta_z_3_by_b_1_z*t158
        + D_p_x_2_by_b_1_z*t203 + D_p_y_2_by_b_1_z*t204 + D_p_z_2_by_b_1_z*t205,
        D_p_x_2_by_b_1_z*t15, D_p_y_2_by_b_1_z*t15, D_p_z_2_by_b_1_z*t15,
        D_p_x_3_by_b_1_z*t179 + D_p_y_3_by_b_1_z*t180 + D_p_z_3_by_b_1_z*t181,
        D_delta_x_1_by_b_1_z*t162 + D_delta_y_1_by_b_1_z*t164 + D_delta_z_1_by_b_1_z*t166
        + D_p_x_3_by_b_1_z*t188 + D_p_y_3_by_b_1_z*t190 + D_p_z_3_by_b_1_z*t192,
        D_delta_x_2_by_b_1_z*t162 + D_delta_y_2_by_b_1_z*t164 + D_delta_z_2_by_b_1_z*t166
        + D_p_x_3_by_b_1_z*t197 + D_p_y_3_by_b_1_z*t199 + D_p_z_3_by_b_1_z*t201,
        D_delta_x_3_by_b_1_z*t162 + D_delta_y_3_by_b_1_z*t164 + D_delta_z_3_by_b_1_z*t166
        + D_p_x_3_by_b_1_z*t203 + D_p_y_3_by_b_1_z*t204 + D_p_z_3_by_b_1_z*t205,
        D_p_x_3_by_b_1_z*t15, D_p_y_3_by_b_1_z*t15, D_p_z_3_by_b_1_z*t15, -t214, -t213, t214, t213,
        D_delta_x_1_by_b_1_z*t189 + D_delta_y_1_by_b_1_z*t191 + D_delta_z_1_by_b_1_z*t193,
        D_delta_x_1_by_b_1_z*t197 + D_delta_x_2_by_b_1_z*t188 + D_delta_y_1_by_b_1_z*t199
        + D_delta_y_2_by_b_1_z*t190 + D_delta_z_1_by_b_1_z*t201 + D_delta_z_2_by_b_1_z*t192,
        D_delta_x_1_by_b_1_z*t203 + D_delta_x_3_by_b_1_z*t188 + D_delta_y_1_by_b_1_z*t204
        + D_delta_y_3_by_b_1_z*t190 + D_delta_z_1_by_b_1_z*t205 + D_delta_z_3_by_b_1_z*t192,
        D_delta_x_1_by_b_1_z*t15, D_delta_y_1_by_b_1_z*t15, D_delta_z_1_by_b_1_z*t15,
        D_delta_x_2_by_b_1_z*t198 + D_delta_y_2_by_b_1_z*t200 + D_delta_z_2_by_b_1_z*t202,
        D_delta_x_2_by_b_1_z*t203 + D_delta_x_3_by_b_1_z*t197 + D_delta_y_2_by_b_1_z*t204
        + D_delta_y_3_by_b_1_z*t199 + D_delta_z_2_by_b_1_z*t205 + D_delta_z_3_by_b_1_z*t201,
        D_delta_x_2_by_b_1_z*t15, D_delta_y_2_by_b_1_z*t15, D_delta_z_2_by_b_1_z*t15,
        D_delta_x_3_by_b_1_z*t206 + D_delta_y_3_by_b_1_z*t207 + D_delta_z_3_by_b_1_z*t208,
        D_delta_x_3_by_b_1_z*t15, D_delta_y_3_by_b_1_z*t15, D_delta_z_3_by_b_1_z*t15,
        D_p_x_1_by_b_2_x*t144 + D_p_y_1_by_b_2_x*t146 + D_p_z_1_by_b_2_x*t148,
        D_p_x_1_by_b_2_x*t151 + D_p_x_2_by_b_2_x*t153 + D_p_y_1_by_b_2_x*t155 + D_p_y_2_by_b_2_x*t156
        + D_p_z_1_by_b_2_x*t158 + D_p_z_2_by_b_2_x*t159,
        D_p_x_1_by_b_2_x*t162 + D_p_x_3_by_b_2_x*t153 + D_p_y_1_by_b_2_x*t164 + D_p_y_3_by_b_2_x*t156
        + D_p_z_1_by_b_2_x*t166 + D_p_z_3_by_b_2_x*t159,
        D_delta_x_1_by_b_2_x*t153 + D_delta_y_1_by_b_2_x*t156 + D_delta_z_1_by_b_2_x*t159
        + D_p_x_1_by_b_2_x*t188 + D_p_y_1_by_b_2_x*t190 + D_p_z_1_by_b_2_x*t192,
        D_delta_x_2_by_b_2_x*t153 + D_delta_y_2_by_b_2_x*t156 + D_delta_z_2_by_b_2_x*t159
        + D_p_x_1_by_b_2_x*t197 + D_p_y_1_by_b_2_x*t199 + D_p_z_1_by_b_2_x*t201,
        D_delta_x_3_by_b_2_x*t153 + D_delta_y_3_by_b_2_x*t156 + D_delta_z_3_by_b_2_x*t159
        + D_p_x_1_by_b_2_x*t203 + D_p_y_1_by_b_2_x*t204 + D_p_z_1_by_b_2_x*t205,
        D_p_x_1_by_b_2_x*t15, D_p_y_1_by_b_2_x*t15, D_p_z_1_by_b_2_x*t15,
        D_p_x_2_by_b_2_x*t173 + D_p_y_2_by_b_2_x*t174 + D_p_z_2_by_b_2_x*t175,
        D_p_x_2_by_b_2_x*t162 + D_p_x_3_by_b_2_x*t151 + D_p_y_2_by_b_2_x*t164 + D_p_y_3_by_b_2_x*t155
        + D_p_z_2_by_b_2_x*t166 + D_p_z_3_by_b_2_x*t158,
        -t217, t217,
        D_delta_x_1_by_b_2_x*t151 + D_delta_y_1_by_b_2_x*t155 + D_delta_z_1_by_b_2_x*t158
        + D_p_x_2_by_b_2_x*t188 + D_p_y_2_by_b_2_x*t190 + D_p_z_2_by_b_2_x*t192,
        D_delta_x_2_by_b_2_x*t151 + D_delta_y_2_by_b_2_x*t155 + D_delta_z_2_by_b_2_x*t158
        + D_p_x_2_by_b_2_x*t197 + D_p_y_2_by_b_2_x*t199 + D_p_z_2_by_b_2_x*t201,
        D_delta_x_3_by_b_2_x*t151 + D_delta_y_3_by_b_2_x*t155 + D_delta_z_3_by_b_2_x*t158
        + D_p_x_2_by_b_2_x*t203 + D_p_y_2_by_b_2_x*t204 + D_p_z_2_by_b_2_x*t205,
        D_p_x_2_by_b_2_x*t15, D_p_y_2_by_b_2_x*t15, D_p_z_2_by_b_2_x*t15,
        D_p_x_3_by_b_2_x*t179 + D_p_y_3_by_b_2_x*t180 + D_p_z_3_by_b_2_x*t181,
        D_delta_x_1_by_b_2_x*t162 + D_delta_y_1_by_b_2_x*t164 + D_delta_z_1_by_b_2_x*t166
        + D_p_x_3_by_b_2_x*t188 + D_p_y_3_by_b_2_x*t190 + D_p_z_3_by_b_2_x*t192,
        D_delta_x_2_by_b_2_x*t162 + D_delta_y_2_by_b_2_x*t164 + D_delta_z_2_by_b_2_x*t166
        + D_p_x_3_by_b_2_x*t197 + D_p_y_3_by_b_2_x*t199 + D_p_z_3_by_b_2_x*t201,
        D_delta_x_3_by_b_2_x*t162 + D_delta_y_3_by_b_2_x*t164 + D_delta_z_3_by_b_2_x*t166
        + D_p_x_3_by_b_2_x*t203 + D_p_y_3_by_b_2_x*t204 + D_p_z_3_by_b_2_x*t205,
        D_p_x_3_by_b_2_x*t15, D_p_y_3_by_b_2_x*t15, D_p_z_3_by_b_2_x*t15, -t220, -t217, t220, t217,
        D_delta_x_1_by_b_2_x*t189 + D_delta_y_1_by_b_2_x*t191 + D_delta_z_1_by_b_2_x*t193,
        D_delta_x_1_by_b_2_x*t197 + D_delta_x_2_by_b_2_x*t188 + D_delta_y_1_by_b_2_x*t199
        + D_delta_y_2_by_b_2_x*t190 + D_delta_z_1_by_b_2_x*t201 + D_delta_z_2_by_b_2_x*t192,
        D_delta_x_1_by_b_2_x*t203 + D_delta_x_3_by_b_2_x*t188 + D_delta_y_1_by_b_2_x*t204
        + D_delta_y_3_by_b_2_x*t190 + D_delta_z_1_by_b_2_x*t205 + D_delta_z_3_by_b_2_x*t192,
        D_delta_x_1_by_b_2_x*t15, D_delta_y_1_by_b_2_x*t15, D_delta_z_1_by_b_2_x*t15,
        D_delta_x_2_by_b_2_x*t198 + D_delta_y_2_by_b_2_x*t200 + D_delta_z_2_by_b_2_x*t202,
        D_delta_x_2_by_b_2_x*t203 + D_delta_x_3_by_b_2_x*t197 + D_delta_y_2_by_b_2_x*t204
        + D_delta_y_3_by_b_2_x*t199 + D_delta_z_2_by_b_2_x*t205 + D_delta_z_3_by_b_2_x*t201,
        D_delta_x_2_by_b_2_x*t15, D_delta_y_2_by_b_2_x*t15, D_delta_z_2_by_b_2_x*t15,
        D_delta_x_3_by_b_2_x*t206 + D_delta_y_3_by_b_2_x*t207 + D_delta_z_3_by_b_2_x*t208,
        D_delta_x_3_by_b_2_x*t15, D_delta_y_3_by_b_2_x*t15, D_delta_z_3_by_b_2_x*t15,
        D_p_x_1_by_b_2_y*t144 + D_p_y_1_by_b_2_y*t146 + D_p_z_1_by_b_2_y*t148,
        D_p_x_1_by_b_2_y*t151 + D_p_x_2_by_b_2_y*t153 + D_p_y_1_by_b_2_y*t155 + D_p_y_2_by_b_2_y*t156
        + D_p_z_1_by_b_2_y*t158 + D_p_z_2_by_b_2_y*t159,
        D_p_x_1_by_b_2_y*t162 + D_p_x_3_by_b_2_y*t153 + D_p_y_1_by_b_2_y*t164 + D_p_y_3_by_b_2_y*t156
        + D_p_z_1_by_b_2_y*t166 + D_p_z_3_by_b_2_y*t159,
        D_delta_x_1_by_b_2_y*t153 + D_delta_y_1_by_b_2_y*t156 + D_delta_z_1_by_b_2_y*t159
        + D_p_x_1_by_b_2_y*t188 + D_p_y_1_by_b_2_y*t190 + D_p_z_1_by_b_2_y*t192,
        D_delta_x_2_by_b_2_y*t153 + D_delta_y_2_by_b_2_y*t156 + D_delta_z_2_by_b_2_y*t159
        + D_p_x_1_by_b_2_y*t197 + D_p_y_1_by_b_2_y*t199 + D_p_z_1_by_b_2_y*t201,
        D_delta_x_3_by_b_2_y*t153 + D_delta_y_3_by_b_2_y*t156 + D_delta_z_3_by_b_2_y*t159
        + D_p_x_1_by_b_2_y*t203 + D_p_y_1_by_b_2_y*t204 + D_p_z_1_by_b_2_y*t205,
        D_p_x_1_by_b_2_y*t15, D_p_y_1_by_b_2_y*t15, D_p_z_1_by_b_2_y*t15,
        D_p_x_2_by_b_2_y*t173 + D_p_y_2_by_b_2_y*t174 + D_p_z_2_by_b_2_y*t175,
        D_p_x_2_by_b_2_y*t162 + D_p_x_3_by_b_2_y*t151 + D_p_y_2_by_b_2_y*t164 + D_p_y_3_by_b_2_y*t155
        + D_p_z_2_by_b_2_y*t166 + D_p_z_3_by_b_2_y*t158,
        -t222, t222,
        D_delta_x_1_by_b_2_y*t151 + D_delta_y_1_by_b_2_y*t155 + D_delta_z_1_by_b_2_y*t158
        + D_p_x_2_by_b_2_y*t188 + D_p_y_2_by_b_2_y*t190 + D_p_z_2_by_b_2_y*t192,
        D_delta_x_2_by_b_2_y*t151 + D_delta_y_2_by_b_2_y*t155 + D_delta_z_2_by_b_2_y*t158
        + D_p_x_2_by_b_2_y*t197 + D_p_y_2_by_b_2_y*t199 + D_p_z_2_by_b_2_y*t201,
        D_delta_x_3_by_b_2_y*t151 + D_delta_y_3_by_b_2_y*t155 + D_delta_z_3_by_b_2_y*t158
        + D_p_x_2_by_b_2_y*t203 + D_p_y_2_by_b_2_y*t204 + D_p_z_2_by_b_2_y*t205,
        D_p_x_2_by_b_2_y*t15, D_p_y_2_by_b_2_y*t15, D_p_z_2_by_b_2_y*t15,
        D_p_x_3_by_b_2_y*t179 + D_p_y_3_by_b_2_y*t180 + D_p_z_3_by_b_2_y*t181,
        D_delta_x_1_by_b_2_y*t162 + D_delta_y_1_by_b_2_y*t164 + D_delta_z_1_by_b_2_y*t166
        + D_p_x_3_by_b_2_y*t188 + D_p_y_3_by_b_2_y*t190 + D_p_z_3_by_b_2_y*t192,
        D_delta_x_2_by_b_2_y*t162 + D_delta_y_2_by_b_2_y*t164 + D_delta_z_2_by_b_2_y*t166
        + D_p_x_3_by_b_2_y*t197 + D_p_y_3_by_b_2_y*t199 + D_p_z_3_by_b_2_y*t201,
        D_delta_x_3_by_b_2_y*t162 + D_delta_y_3_by_b_2_y*t164 + D_delta_z_3_by_b_2_y*t166
        + D_p_x_3_by_b_2_y*t203 + D_p_y_3_by_b_2_y*t204 + D_p_z_3_by_b_2_y*t205,
        D_p_x_3_by_b_2_y*t15, D_p_y_3_by_b_2_y*t15, D_p_z_3_by_b_2_y*t15, -t223, -t222, t223, t222,
        D_delta_x_1_by_b_2_y*t189 + D_delta_y_1_by_b_2_y*t191 + D_delta_z_1_by_b_2_y*t193,
        D_delta_x_1_by_b_2_y*t197 + D_delta_x_2_by_b_2_y*t188 + D_delta_y_1_by_b_2_y*t199
        + D_delta_y_2_by_b_2_y*t190 + D_delta_z_1_by_b_2_y*t201 + D_delta_z_2_by_b_2_y*t192,
        D_delta_x_1_by_b_2_y*t203 + D_delta_x_3_by_b_2_y*t188 + D_delta_y_1_by_b_2_y*t204
        + D_delta_y_3_by_b_2_y*t190 + D_delta_z_1_by_b_2_y*t205 + D_delta_z_3_by_b_2_y*t192,
        D_delta_x_1_by_b_2_y*t15, D_delta_y_1_by_b_2_y*t15, D_delta_z_1_by_b_2_y*t15,
        D_delta_x_2_by_b_2_y*t198 + D_delta_y_2_by_b_2_y*t200 + D_delta_z_2_by_b_2_y*t202,
        D_delta_x_2_by_b_2_y*t203 + D_delta_x_3_by_b_2_y*t197 + D_delta_y_2_by_b_2_y*t204
        + D_delta_y_3_by_b_2_y*t199 + D_delta_z_2_by_b_2_y*t205 + D_delta_z_3_by_b_2_y*t201,
        D_delta_x_2_by_b_2_y*t15, D_delta_y_2_by_b_2_y*t15, D_delta_z_2_by_b_2_y*t15,
        D_delta_x_3_by_b_2_y*t206 + D_delta_y_3_by_b_2_y*t207 + D_delta_z_3_by_b_2_y*t208,
        D_delta_x_3_by_b_2_y*t15, D_delta_y_3_by_b_2_y*t15, D_delta_z_3_by_b_2_y*t15,
        D_p_x_1_by_b_2_z*t144 + D_p_y_1_by_b_2_z*t146 + D_p_z_1_by_b_2_z*t148,
        D_p_x_1_by_b_2_z*t151 + D_p_x_2_by_b_2_z*t153 + D_p_y_1_by_b_2_z*t155 + D_p_y_2_by_b_2_z*t156
        + D_p_z_1_by_b_2_z*t158 + D_p_z_2_by_b_2_z*t159,
        D_p_x_1_by_b_2_z*t162 + D_p_x_3_by_b_2_z*t153 + D_p_y_1_by_b_2_z*t164 + D_p_y_3_by_b_2_z*t156
        + D_p_z_1_by_b_2_z*t166 + D_p_z_3_by_b_2_z*t159,
        D_delta_x_1_by_b_2_z*t153 + D_delta_y_1_by_b_2_z*t156 + D_delta_z_1_by_b_2_z*t159
        + D_p_x_1_by_b_2_z*t188 + D_p_y_1_by_b_2_z*t190 + D_p_z_1_by_b_2_z*t192,
        D_delta_x_2_by_b_2_z*t153 + D_delta_y_2_by_b_2_z*t156 + D_delta_z_2_by_b_2_z*t159
        + D_p_x_1_by_b_2_z*t197 + D_p_y_1_by_b_2_z*t199 + D_p_z_1_by_b_2_z*t201,
        D_delta_x_3_by_b_2_z*t153 + D_delta_y_3_by_b_2_z*t156 + D_delta_z_3_by_b_2_z*t159
        + D_p_x_1_by_b_2_z*t203 + D_p_y_1_by_b_2_z*t204 + D_p_z_1_by_b_2_z*t205,
        D_p_x_1_by_b_2_z*t15, D_p_y_1_by_b_2_z*t15, D_p_z_1_by_b_2_z*t15,
        D_p_x_2_by_b_2_z*t173 + D_p_y_2_by_b_2_z*t174 + D_p_z_2_by_b_2_z*t175,
        D_p_x_2_by_b_2_z*t162 + D_p_x_3_by_b_2_z*t151 + D_p_y_2_by_b_2_z*t164 + D_p_y_3_by_b_2_z*t155
        + D_p_z_2_by_b_2_z*t166 + D_p_z_3_by_b_2_z*t158,
        -t225, t225,
        D_delta_x_1_by_b_2_z*t151 + D_delta_y_1_by_b_2_z*t155 + D_delta_z_1_by_b_2_z*t158
        + D_p_x_2_by_b_2_z*t188 + D_p_y_2_by_b_2_z*t190 + D_p_z_2_by_b_2_z*t192,
        D_delta_x_2_by_b_2_z*t151 + D_delta_y_2_by_b_2_z*t155 + D_delta_z_2_by_b_2_z*t158
        + D_p_x_2_by_b_2_z*t197 + D_p_y_2_by_b_2_z*t199 + D_p_z_2_by_b_2_z*t201,
        D_delta_x_3_by_b_2_z*t151 + D_delta_y_3_by_b_2_z*t155 + D_delta_z_3_by_b_2_z*t158
        + D_p_x_2_by_b_2_z*t203 + D_p_y_2_by_b_2_z*t204 + D_p_z_2_by_b_2_z*t205,
        D_p_x_2_by_b_2_z*t15, D_p_y_2_by_b_2_z*t15, D_p_z_2_by_b_2_z*t15,
        D_p_x_3_by_b_2_z*t179 + D_p_y_3_by_b_2_z*t180 + D_p_z_3_by_b_2_z*t181,
        D_delta_x_1_by_b_2_z*t162 + D_delta_y_1_by_b_2_z*t164 + D_delta_z_1_by_b_2_z*t166
        + D_p_x_3_by_b_2_z*t188 + D_p_y_3_by_b_2_z*t190 + D_p_z_3_by_b_2_z*t192,
        D_delta_x_2_by_b_2_z*t162 + D_delta_y_2_by_b_2_z*t164 + D_delta_z_2_by_b_2_z*t166
        + D_p_x_3_by_b_2_z*t197 + D_p_y_3_by_b_2_z*t199 + D_p_z_3_by_b_2_z*t201,
        D_delta_x_3_by_b_2_z*t162 + D_delta_y_3_by_b_2_z*t164 + D_delta_z_3_by_b_2_z*t166
        + D_p_x_3_by_b_2_z*t203 + D_p_y_3_by_b_2_z*t204 + D_p_z_3_by_b_2_z*t205,
        D_p_x_3_by_b_2_z*t15, D_p_y_3_by_b_2_z*t15, D_p_z_3_by_b_2_z*t15, -t226, -t225, t226, t225,
        D_delta_x_1_by_b_2_z*t189 + D_delta_y_1_by_b_2_z*t191 + D_delta_z_1_by_b_2_z*t193,
        D_delta_x_1_by_b_2_z*t197 + D_delta_x_2_by_b_2_z*t188 + D_delta_y_1_by_b_2_z*t199
        + D_delta_y_2_by_b_2_z*t190 + D_delta_z_1_by_b_2_z*t201 + D_delta_z_2_by_b_2_z*t192,
        D_delta_x_1_by_b_2_z*t203 + D_delta_x_3_by_b_2_z*t188 + D_delta_y_1_by_b_2_z*t204
        + D_delta_y_3_by_b_2_z*t190 + D_delta_z_1_by_b_2_z*t205 + D_delta_z_3_by_b_2_z*t192,
        D_delta_x_1_by_b_2_z*t15, D_delta_y_1_by_b_2_z*t15, D_delta_z_1_by_b_2_z*t15,
        D_delta_x_2_by_b_2_z*t198 + D_delta_y_2_by_b_2_z*t200 + D_delta_z_2_by_b_2_z*t202,
        D_delta_x_2_by_b_2_z*t203 + D_delta_x_3_by_b_2_z*t197 + D_delta_y_2_by_b_2_z*t204
        + D_delta_y_3_by_b_2_z*t199 + D_delta_z_2_by_b_2_z*t205 + D_delta_z_3_by_b_2_z*t201,
        D_delta_x_2_by_b_2_z*t15, D_delta_y_2_by_b_2_z*t15, D_delta_z_2_by_b_2_z*t15,
        D_delta_x_3_by_b_2_z*t206 + D_delta_y_3_by_b_2_z*t207 + D_delta_z_3_by_b_2_z*t208,
        D_delta_x_3_by_b_2_z*t15, D_delta_y_3_by_b_2_z*t15, D_delta_z_3_by_b_2_z*t15,
        D_p_x_1_by_b_3_x*t144 + D_p_y_1_by_b_3_x*t146 + D_p_z_1_by_b_3_x*t148,
        D_p_x_1_by_b_3_x*t151 + D_p_x_2_by_b_3_x*t153 + D_p_y_1_by_b_3_x*t155 + D_p_y_2_by_b_3_x*t156
        + D_p_z_1_by_b_3_x*t158 + D_p_z_2_by_b_3_x*t159,
        D_p_x_1_by_b_3_x*t162 + D_p_x_3_by_b_3_x*t153 + D_p_y_1_by_b_3_x*t164 + D_p_y_3_by_b_3_x*t156
        + D_p_z_1_by_b_3_x*t166 + D_p_z_3_by_b_3_x*t159,
        D_delta_x_1_by_b_3_x*t153 + D_delta_y_1_by_b_3_x*t156 + D_delta_z_1_by_b_3_x*t159
        + D_p_x_1_by_b_3_x*t188 + D_p_y_1_by_b_3_x*t190 + D_p_z_1_by_b_3_x*t192,
        D_delta_x_2_by_b_3_x*t153 + D_delta_y_2_by_b_3_x*t156 + D_delta_z_2_by_b_3_x*t159
        + D_p_x_1_by_b_3_x*t197 + D_p_y_1_by_b_3_x*t199 + D_p_z_1_by_b_3_x*t201,
        D_delta_x_3_by_b_3_x*t153 + D_delta_y_3_by_b_3_x*t156 + D_delta_z_3_by_b_3_x*t159
        + D_p_x_1_by_b_3_x*t203 + D_p_y_1_by_b_3_x*t204 + D_p_z_1_by_b_3_x*t205,
        D_p_x_1_by_b_3_x*t15, D_p_y_1_by_b_3_x*t15, D_p_z_1_by_b_3_x*t15,
        D_p_x_2_by_b_3_x*t173 + D_p_y_2_by_b_3_x*t174 + D_p_z_2_by_b_3_x*t175,
        D_p_x_2_by_b_3_x*t162 + D_p_x_3_by_b_3_x*t151 + D_p_y_2_by_b_3_x*t164 + D_p_y_3_by_b_3_x*t155
        + D_p_z_2_by_b_3_x*t166 + D_p_z_3_by_b_3_x*t158,
        D_delta_x_1_by_b_3_x*t151 + D_delta_y_1_by_b_3_x*t155 + D_delta_z_1_by_b_3_x*t158
        + D_p_x_2_by_b_3_x*t188 + D_p_y_2_by_b_3_x*t190 + D_p_z_2_by_b_3_x*t192,
        D_delta_x_2_by_b_3_x*t151 + D_delta_y_2_by_b_3_x*t155 + D_delta_z_2_by_b_3_x*t158
        + D_p_x_2_by_b_3_x*t197 + D_p_y_2_by_b_3_x*t199 + D_p_z_2_by_b_3_x*t201,
        D_delta_x_3_by_b_3_x*t151 + D_delta_y_3_by_b_3_x*t155 + D_delta_z_3_by_b_3_x*t158
        + D_p_x_2_by_b_3_x*t203 + D_p_y_2_by_b_3_x*t204 + D_p_z_2_by_b_3_x*t205,
        D_p_x_2_by_b_3_x*t15, D_p_y_2_by_b_3_x*t15, D_p_z_2_by_b_3_x*t15,
        D_p_x_3_by_b_3_x*t179 + D_p_y_3_by_b_3_x*t180 + D_p_z_3_by_b_3_x*t181, -t229, t229,
        D_delta_x_1_by_b_3_x*t162 + D_delta_y_1_by_b_3_x*t164 + D_delta_z_1_by_b_3_x*t166
        + D_p_x_3_by_b_3_x*t188 + D_p_y_3_by_b_3_x*t190 + D_p_z_3_by_b_3_x*t192,
        D_delta_x_2_by_b_3_x*t162 + D_delta_y_2_by_b_3_x*t164 + D_delta_z_2_by_b_3_x*t166
        + D_p_x_3_by_b_3_x*t197 + D_p_y_3_by_b_3_x*t199 + D_p_z_3_by_b_3_x*t201,
        D_delta_x_3_by_b_3_x*t162 + D_delta_y_3_by_b_3_x*t164 + D_delta_z_3_by_b_3_x*t166
        + D_p_x_3_by_b_3_x*t203 + D_p_y_3_by_b_3_x*t204 + D_p_z_3_by_b_3_x*t205,
        D_p_x_3_by_b_3_x*t15, D_p_y_3_by_b_3_x*t15, D_p_z_3_by_b_3_x*t15, -t232, -t229, t232, t229,
        D_delta_x_1_by_b_3_x*t189 + D_delta_y_1_by_b_3_x*t191 + D_delta_z_1_by_b_3_x*t193,
        D_delta_x_1_by_b_3_x*t197 + D_delta_x_2_by_b_3_x*t188 + D_delta_y_1_by_b_3_x*t199
        + D_delta_y_2_by_b_3_x*t190 + D_delta_z_1_by_b_3_x*t201 + D_delta_z_2_by_b_3_x*t192,
        D_delta_x_1_by_b_3_x*t203 + D_delta_x_3_by_b_3_x*t188 + D_delta_y_1_by_b_3_x*t204
        + D_delta_y_3_by_b_3_x*t190 + D_delta_z_1_by_b_3_x*t205 + D_delta_z_3_by_b_3_x*t192,
        D_delta_x_1_by_b_3_x*t15, D_delta_y_1_by_b_3_x*t15, D_delta_z_1_by_b_3_x*t15,
        D_delta_x_2_by_b_3_x*t198 + D_delta_y_2_by_b_3_x*t200 + D_delta_z_2_by_b_3_x*t202,
        D_delta_x_2_by_b_3_x*t203 + D_delta_x_3_by_b_3_x*t197 + D_delta_y_2_by_b_3_x*t204
        + D_delta_y_3_by_b_3_x*t199 + D_delta_z_2_by_b_3_x*t205 + D_delta_z_3_by_b_3_x*t201,
        D_delta_x_2_by_b_3_x*t15, D_delta_y_2_by_b_3_x*t15, D_delta_z_2_by_b_3_x*t15,
        D_delta_x_3_by_b_3_x*t206 + D_delta_y_3_by_b_3_x*t207 + D_delta_z_3_by_b_3_x*t208,
        D_delta_x_3_by_b_3_x*t15, D_delta_y_3_by_b_3_x*t15, D_delta_z_3_by_b_3_x*t15,
        D_p_x_1_by_b_3_y*t144 + D_p_y_1_by_b_3_y*t146 + D_p_z_1_by_b_3_y*t148,
        D_p_x_1_by_b_3_y*t151 + D_p_x_2_by_b_3_y*t153 + D_p_y_1_by_b_3_y*t155 + D_p_y_2_by_b_3_y*t156
        + D_p_z_1_by_b_3_y*t158 + D_p_z_2_by_b_3_y*t159,
        D_p_x_1_by_b_3_y*t162 + D_p_x_3_by_b_3_y*t153 + D_p_y_1_by_b_3_y*t164 + D_p_y_3_by_b_3_y*t156
        + D_p_z_1_by_b_3_y*t166 + D_p_z_3_by_b_3_y*t159,
        D_delta_x_1_by_b_3_y*t153 + D_delta_y_1_by_b_3_y*t156 + D_delta_z_1_by_b_3_y*t159
        + D_p_x_1_by_b_3_y*t188 + D_p_y_1_by_b_3_y*t190 + D_p_z_1_by_b_3_y*t192,
        D_delta_x_2_by_b_3_y*t153 + D_delta_y_2_by_b_3_y*t156 + D_delta_z_2_by_b_3_y*t159
        + D_p_x_1_by_b_3_y*t197 + D_p_y_1_by_b_3_y*t199 + D_p_z_1_by_b_3_y*t201,
        D_delta_x_3_by_b_3_y*t153 + D_delta_y_3_by_b_3_y*t156 + D_delta_z_3_by_b_3_y*t159
        + D_p_x_1_by_b_3_y*t203 + D_p_y_1_by_b_3_y*t204 + D_p_z_1_by_b_3_y*t205,
        D_p_x_1_by_b_3_y*t15, D_p_y_1_by_b_3_y*t15, D_p_z_1_by_b_3_y*t15,
        D_p_x_2_by_b_3_y*t173 + D_p_y_2_by_b_3_y*t174 + D_p_z_2_by_b_3_y*t175,
        D_p_x_2_by_b_3_y*t162 + D_p_x_3_by_b_3_y*t151 + D_p_y_2_by_b_3_y*t164 + D_p_y_3_by_b_3_y*t155
        + D_p_z_2_by_b_3_y*t166 + D_p_z_3_by_b_3_y*t158,
        D_delta_x_1_by_b_3_y*t151 + D_delta_y_1_by_b_3_y*t155 + D_delta_z_1_by_b_3_y*t158
        + D_p_x_2_by_b_3_y*t188 + D_p_y_2_by_b_3_y*t190 + D_p_z_2_by_b_3_y*t192,
        D_delta_x_2_by_b_3_y*t151 + D_delta_y_2_by_b_3_y*t155 + D_delta_z_2_by_b_3_y*t158
        + D_p_x_2_by_b_3_y*t197 + D_p_y_2_by_b_3_y*t199 + D_p_z_2_by_b_3_y*t201,
        D_delta_x_3_by_b_3_y*t151 + D_delta_y_3_by_b_3_y*t155 + D_delta_z_3_by_b_3_y*t158
        + D_p_x_2_by_b_3_y*t203 + D_p_y_2_by_b_3_y*t204 + D_p_z_2_by_b_3_y*t205,
        D_p_x_2_by_b_3_y*t15, D_p_y_2_by_b_3_y*t15, D_p_z_2_by_b_3_y*t15,
        D_p_x_3_by_b_3_y*t179 + D_p_y_3_by_b_3_y*t180 + D_p_z_3_by_b_3_y*t181, -t234, t234,
        D_delta_x_1_by_b_3_y*t162 + D_delta_y_1_by_b_3_y*t164 + D_delta_z_1_by_b_3_y*t166
        + D_p_x_3_by_b_3_y*t188 + D_p_y_3_by_b_3_y*t190 + D_p_z_3_by_b_3_y*t192,
        D_delta_x_2_by_b_3_y*t162 + D_delta_y_2_by_b_3_y*t164 + D_delta_z_2_by_b_3_y*t166
        + D_p_x_3_by_b_3_y*t197 + D_p_y_3_by_b_3_y*t199 + D_p_z_3_by_b_3_y*t201,
        D_delta_x_3_by_b_3_y*t162 + D_delta_y_3_by_b_3_y*t164 + D_delta_z_3_by_b_3_y*t166
        + D_p_x_3_by_b_3_y*t203 + D_p_y_3_by_b_3_y*t204 + D_p_z_3_by_b_3_y*t205,
        D_p_x_3_by_b_3_y*t15, D_p_y_3_by_b_3_y*t15, D_p_z_3_by_b_3_y*t15, -t235, -t234, t235, t234,
        D_delta_x_1_by_b_3_y*t189 + D_delta_y_1_by_b_3_y*t191 + D_delta_z_1_by_b_3_y*t193,
        D_delta_x_1_by_b_3_y*t197 + D_delta_x_2_by_b_3_y*t188 + D_delta_y_1_by_b_3_y*t199
        + D_delta_y_2_by_b_3_y*t190 + D_delta_z_1_by_b_3_y*t201 + D_delta_z_2_by_b_3_y*t192,
        D_delta_x_1_by_b_3_y*t203 + D_delta_x_3_by_b_3_y*t188 + D_delta_y_1_by_b_3_y*t204
        + D_delta_y_3_by_b_3_y*t190 + D_delta_z_1_by_b_3_y*t205 + D_delta_z_3_by_b_3_y*t192,
        D_delta_x_1_by_b_3_y*t15, D_delta_y_1_by_b_3_y*t15, D_delta_z_1_by_b_3_y*t15,
        D_delta_x_2_by_b_3_y*t198 + D_delta_y_2_by_b_3_y*t200 + D_delta_z_2_by_b_3_y*t202,
        D_delta_x_2_by_b_3_y*t203 + D_delta_x_3_by_b_3_y*t197 + D_delta_y_2_by_b_3_y*t204
        + D_delta_y_3_by_b_3_y*t199 + D_delta_z_2_by_b_3_y*t205 + D_delta_z_3_by_b_3_y*t201,
        D_delta_x_2_by_b_3_y*t15, D_delta_y_2_by_b_3_y*t15, D_delta_z_2_by_b_3_y*t15,
        D_delta_x_3_by_b_3_y*t206 + D_delta_y_3_by_b_3_y*t207 + D_delta_z_3_by_b_3_y*t208,
        D_delta_x_3_by_b_3_y*t15, D_delta_y_3_by_b_3_y*t15, D_delta_z_3_by_b_3_y*t15,
        D_p_x_1_by_b_3_z*t144 + D_p_y_1_by_b_3_z*t146 + D_p_z_1_by_b_3_z*t148,
        D_p_x_1_by_b_3_z*t151 + D_p_x_2_by_b_3_z*t153 + D_p_y_1_by_b_3_z*t155 + D_p_y_2_by_b_3_z*t156
        + D_p_z_1_by_b_3_z*t158 + D_p_z_2_by_b_3_z*t159,
        D_p_x_1_by_b_3_z*t162 + D_p_x_3_by_b_3_z*t153 + D_p_y_1_by_b_3_z*t164 + D_p_y_3_by_b_3_z*t156
        + D_p_z_1_by_b_3_z*t166 + D_p_z_3_by_b_3_z*t159,
        D_delta_x_1_by_b_3_z*t153 + D_delta_y_1_by_b_3_z*t156 + D_delta_z_1_by_b_3_z*t159
        + D_p_x_1_by_b_3_z*t188 + D_p_y_1_by_b_3_z*t190 + D_p_z_1_by_b_3_z*t192,
        D_delta_x_2_by_b_3_z*t153 + D_delta_y_2_by_b_3_z*t156 + D_delta_z_2_by_b_3_z*t159
        + D_p_x_1_by_b_3_z*t197 + D_p_y_1_by_b_3_z*t199 + D_p_z_1_by_b_3_z*t201,
        D_delta_x_3_by_b_3_z*t153 + D_delta_y_3_by_b_3_z*t156 + D_delta_z_3_by_b_3_z*t159
        + D_p_x_1_by_b_3_z*t203 + D_p_y_1_by_b_3_z*t204 + D_p_z_1_by_b_3_z*t205,
        D_p_x_1_by_b_3_z*t15, D_p_y_1_by_b_3_z*t15, D_p_z_1_by_b_3_z*t15,
        D_p_x_2_by_b_3_z*t173 + D_p_y_2_by_b_3_z*t174 + D_p_z_2_by_b_3_z*t175,
        D_p_x_2_by_b_3_z*t162 + D_p_x_3_by_b_3_z*t151 + D_p_y_2_by_b_3_z*t164 + D_p_y_3_by_b_3_z*t155
        + D_p_z_2_by_b_3_z*t166 + D_p_z_3_by_b_3_z*t158,
        D_delta_x_1_by_b_3_z*t151 + D_delta_y_1_by_b_3_z*t155 + D_delta_z_1_by_b_3_z*t158
        + D_p_x_2_by_b_3_z*t188 + D_p_y_2_by_b_3_z*t190 + D_p_z_2_by_b_3_z*t192,
        D_delta_x_2_by_b_3_z*t151 + D_delta_y_2_by_b_3_z*t155 + D_delta_z_2_by_b_3_z*t158
        + D_p_x_2_by_b_3_z*t197 + D_p_y_2_by_b_3_z*t199 + D_p_z_2_by_b_3_z*t201,
        D_delta_x_3_by_b_3_z*t151 + D_delta_y_3_by_b_3_z*t155 + D_delta_z_3_by_b_3_z*t158
        + D_p_x_2_by_b_3_z*t203 + D_p_y_2_by_b_3_z*t204 + D_p_z_2_by_b_3_z*t205,
        D_p_x_2_by_b_3_z*t15, D_p_y_2_by_b_3_z*t15, D_p_z_2_by_b_3_z*t15,
        D_p_x_3_by_b_3_z*t179 + D_p_y_3_by_b_3_z*t180 + D_p_z_3_by_b_3_z*t181, -t237, t237,
        D_delta_x_1_by_b_3_z*t162 + D_delta_y_1_by_b_3_z*t164 + D_delta_z_1_by_b_3_z*t166
        + D_p_x_3_by_b_3_z*t188 + D_p_y_3_by_b_3_z*t190 + D_p_z_3_by_b_3_z*t192,
        D_delta_x_2_by_b_3_z*t162 + D_delta_y_2_by_b_3_z*t164 + D_delta_z_2_by_b_3_z*t166
        + D_p_x_3_by_b_3_z*t197 + D_p_y_3_by_b_3_z*t199 + D_p_z_3_by_b_3_z*t201,
        D_delta_x_3_by_b_3_z*t162 + D_delta_y_3_by_b_3_z*t164 + D_delta_z_3_by_b_3_z*t166
        + D_p_x_3_by_b_3_z*t203 + D_p_y_3_by_b_3_z*t204 + D_p_z_3_by_b_3_z*t205,
        D_p_x_3_by_b_3_z*t15, D_p_y_3_by_b_3_z*t15, D_p_z_3_by_b_3_z*t15, -t238, -t237, t238, t237,
        D_delta_x_1_by_b_3_z*t189 + D_delta_y_1_by_b_3_z*t191 + D_delta_z_1_by_b_3_z*t193,
        D_delta_x_1_by_b_3_z*t197 + D_delta_x_2_by_b_3_z*t188 + D_delta_y_1_by_b_3_z*t199
        + D_delta_y_2_by_b_3_z*t190 + D_delta_z_1_by_b_3_z*t201 + D_delta_z_2_by_b_3_z*t192,
        D_delta_x_1_by_b_3_z*t203 + D_delta_x_3_by_b_3_z*t188 + D_delta_y_1_by_b_3_z*t204
        + D_delta_y_3_by_b_3_z*t190 + D_delta_z_1_by_b_3_z*t205 + D_delta_z_3_by_b_3_z*t192,
        D_delta_x_1_by_b_3_z*t15, D_delta_y_1_by_b_3_z*t15, D_delta_z_1_by_b_3_z*t15,
        D_delta_x_2_by_b_3_z*t198 + D_delta_y_2_by_b_3_z*t200 + D_delta_z_2_by_b_3_z*t202,
        D_delta_x_2_by_b_3_z*t203 + D_delta_x_3_by_b_3_z*t197 + D_delta_y_2_by_b_3_z*t204
        + D_delta_y_3_by_b_3_z*t199 + D_delta_z_2_by_b_3_z*t205 + D_delta_z_3_by_b_3_z*t201,
        D_delta_x_2_by_b_3_z*t15, D_delta_y_2_by_b_3_z*t15, D_delta_z_2_by_b_3_z*t15,
        D_delta_x_3_by_b_3_z*t206 + D_delta_y_3_by_b_3_z*t207 + D_delta_z_3_by_b_3_z*t208,
        D_delta_x_3_by_b_3_z*t15, D_delta_y_3_by_b_3_z*t15, D_delta_z_3_by_b_3_z*t15,
        D_p_x_1_by_l_d_1*t144 + D_p_y_1_by_l_d_1*t146 + D_p_z_1_by_l_d_1*t148,
        D_p_x_1_by_l_d_1*t151 + D_p_x_2_by_l_d_1*t153 + D_p_y_1_by_l_d_1*t155 + D_p_y_2_by_l_d_1*t156
        + D_p_z_1_by_l_d_1*t158 + D_p_z_2_by_l_d_1*t159,
        D_p_x_1_by_l_d_1*t162 + D_p_x_3_by_l_d_1*t153 + D_p_y_1_by_l_d_1*t164 + D_p_y_3_by_l_d_1*t156
        + D_p_z_1_by_l_d_1*t166 + D_p_z_3_by_l_d_1*t159,
        -t240, t240,
        D_delta_x_1_by_l_d_1*t153 + D_delta_y_1_by_l_d_1*t156 + D_delta_z_1_by_l_d_1*t159
        + D_p_x_1_by_l_d_1*t188 + D_p_y_1_by_l_d_1*t190 + D_p_z_1_by_l_d_1*t192,
        D_delta_x_2_by_l_d_1*t153 + D_delta_y_2_by_l_d_1*t156 + D_delta_z_2_by_l_d_1*t159
        + D_p_x_1_by_l_d_1*t197 + D_p_y_1_by_l_d_1*t199 + D_p_z_1_by_l_d_1*t201,
        D_delta_x_3_by_l_d_1*t153 + D_delta_y_3_by_l_d_1*t156 + D_delta_z_3_by_l_d_1*t159
        + D_p_x_1_by_l_d_1*t203 + D_p_y_1_by_l_d_1*t204 + D_p_z_1_by_l_d_1*t205,
        D_p_x_1_by_l_d_1*t15, D_p_y_1_by_l_d_1*t15, D_p_z_1_by_l_d_1*t15,
        D_p_x_2_by_l_d_1*t173 + D_p_y_2_by_l_d_1*t174 + D_p_z_2_by_l_d_1*t175,
        D_p_x_2_by_l_d_1*t162 + D_p_x_3_by_l_d_1*t151 + D_p_y_2_by_l_d_1*t164 + D_p_y_3_by_l_d_1*t155
        + D_p_z_2_by_l_d_1*t166 + D_p_z_3_by_l_d_1*t158,
        D_delta_x_1_by_l_d_1*t151 + D_delta_y_1_by_l_d_1*t155 + D_delta_z_1_by_l_d_1*t158
        + D_p_x_2_by_l_d_1*t188 + D_p_y_2_by_l_d_1*t190 + D_p_z_2_by_l_d_1*t192,
        D_delta_x_2_by_l_d_1*t151 + D_delta_y_2_by_l_d_1*t155 + D_delta_z_2_by_l_d_1*t158
        + D_p_x_2_by_l_d_1*t197 + D_p_y_2_by_l_d_1*t199 + D_p_z_2_by_l_d_1*t201,
        D_delta_x_3_by_l_d_1*t151 + D_delta_y_3_by_l_d_1*t155 + D_delta_z_3_by_l_d_1*t158
        + D_p_x_2_by_l_d_1*t203 + D_p_y_2_by_l_d_1*t204 + D_p_z_2_by_l_d_1*t205,
        D_p_x_2_by_l_d_1*t15, D_p_y_2_by_l_d_1*t15, D_p_z_2_by_l_d_1*t15,
        D_p_x_3_by_l_d_1*t179 + D_p_y_3_by_l_d_1*t180 + D_p_z_3_by_l_d_1*t181,
        D_delta_x_1_by_l_d_1*t162 + D_delta_y_1_by_l_d_1*t164 + D_delta_z_1_by_l_d_1*t166
        + D_p_x_3_by_l_d_1*t188 + D_p_y_3_by_l_d_1*t190 + D_p_z_3_by_l_d_1*t192,
        D_delta_x_2_by_l_d_1*t162 + D_delta_y_2_by_l_d_1*t164 + D_delta_z_2_by_l_d_1*t166
        + D_p_x_3_by_l_d_1*t197 + D_p_y_3_by_l_d_1*t199 + D_p_z_3_by_l_d_1*t201,
        D_delta_x_3_by_l_d_1*t162 + D_delta_y_3_by_l_d_1*t164 + D_delta_z_3_by_l_d_1*t166
        + D_p_x_3_by_l_d_1*t203 + D_p_y_3_by_l_d_1*t204 + D_p_z_3_by_l_d_1*t205,
        D_p_x_3_by_l_d_1*t15, D_p_y_3_by_l_d_1*t15, D_p_z_3_by_l_d_1*t15, -t241, -t240, t241, t240,
        D_delta_x_1_by_l_d_1*t189 + D_delta_y_1_by_l_d_1*t191 + D_delta_z_1_by_l_d_1*t193,
        D_delta_x_1_by_l_d_1*t197 + D_delta_x_2_by_l_d_1*t188 + D_delta_y_1_by_l_d_1*t199
        + D_delta_y_2_by_l_d_1*t190 + D_delta_z_1_by_l_d_1*t201 + D_delta_z_2_by_l_d_1*t192,
        D_delta_x_1_by_l_d_1*t203 + D_delta_x_3_by_l_d_1*t188 + D_delta_y_1_by_l_d_1*t204
        + D_delta_y_3_by_l_d_1*t190 + D_delta_z_1_by_l_d_1*t205 + D_delta_z_3_by_l_d_1*t192,
        D_delta_x_1_by_l_d_1*t15, D_delta_y_1_by_l_d_1*t15, D_delta_z_1_by_l_d_1*t15,
        D_delta_x_2_by_l_d_1*t198 + D_delta_y_2_by_l_d_1*t200 + D_delta_z_2_by_l_d_1*t202,
        D_delta_x_2_by_l_d_1*t203 + D_delta_x_3_by_l_d_1*t197 + D_delta_y_2_by_l_d_1*t204
        + D_delta_y_3_by_l_d_1*t199 + D_delta_z_2_by_l_d_1*t205 + D_delta_z_3_by_l_d_1*t201,
        D_delta_x_2_by_l_d_1*t15, D_delta_y_2_by_l_d_1*t15, D_delta_z_2_by_l_d_1*t15,
        D_delta_x_3_by_l_d_1*t206 + D_delta_y_3_by_l_d_1*t207 + D_delta_z_3_by_l_d_1*t208,
        D_delta_x_3_by_l_d_1*t15, D_delta_y_3_by_l_d_1*t15, D_delta_z_3_by_l_d_1*t15,
        D_p_x_1_by_l_d_2*t144 + D_p_y_1_by_l_d_2*t146 + D_p_z_1_by_l_d_2*t148,
        D_p_x_1_by_l_d_2*t151 + D_p_x_2_by_l_d_2*t153 + D_p_y_1_by_l_d_2*t155 + D_p_y_2_by_l_d_2*t156
        + D_p_z_1_by_l_d_2*t158 + D_p_z_2_by_l_d_2*t159,
        D_p_x_1_by_l_d_2*t162 + D_p_x_3_by_l_d_2*t153 + D_p_y_1_by_l_d_2*t164 + D_p_y_3_by_l_d_2*t156
        + D_p_z_1_by_l_d_2*t166 + D_p_z_3_by_l_d_2*t159,
        D_delta_x_1_by_l_d_2*t153 + D_delta_y_1_by_l_d_2*t156 + D_delta_z_1_by_l_d_2*t159
        + D_p_x_1_by_l_d_2*t188 + D_p_y_1_by_l_d_2*t190 + D_p_z_1_by_l_d_2*t192,
        D_delta_x_2_by_l_d_2*t153 + D_delta_y_2_by_l_d_2*t156 + D_delta_z_2_by_l_d_2*t159
        + D_p_x_1_by_l_d_2*t197 + D_p_y_1_by_l_d_2*t199 + D_p_z_1_by_l_d_2*t201,
        D_delta_x_3_by_l_d_2*t153 + D_delta_y_3_by_l_d_2*t156 + D_delta_z_3_by_l_d_2*t159
        + D_p_x_1_by_l_d_2*t203 + D_p_y_1_by_l_d_2*t204 + D_p_z_1_by_l_d_2*t205,
        D_p_x_1_by_l_d_2*t15, D_p_y_1_by_l_d_2*t15, D_p_z_1_by_l_d_2*t15,
        D_p_x_2_by_l_d_2*t173 + D_p_y_2_by_l_d_2*t174 + D_p_z_2_by_l_d_2*t175,
        D_p_x_2_by_l_d_2*t162 + D_p_x_3_by_l_d_2*t151 + D_p_y_2_by_l_d_2*t164 + D_p_y_3_by_l_d_2*t155
        + D_p_z_2_by_l_d_2*t166 + D_p_z_3_by_l_d_2*t158,
        -t243, t243,
        D_delta_x_1_by_l_d_2*t151 + D_delta_y_1_by_l_d_2*t155 + D_delta_z_1_by_l_d_2*t158
        + D_p_x_2_by_l_d_2*t188 + D_p_y_2_by_l_d_2*t190 + D_p_z_2_by_l_d_2*t192,
        D_delta_x_2_by_l_d_2*t151 + D_delta_y_2_by_l_d_2*t155 + D_delta_z_2_by_l_d_2*t158
        + D_p_x_2_by_l_d_2*t197 + D_p_y_2_by_l_d_2*t199 + D_p_z_2_by_l_d_2*t201,
        D_delta_x_3_by_l_d_2*t151 + D_delta_y_3_by_l_d_2*t155 + D_delta_z_3_by_l_d_2*t158
        + D_p_x_2_by_l_d_2*t203 + D_p_y_2_by_l_d_2*t204 + D_p_z_2_by_l_d_2*t205,
        D_p_x_2_by_l_d_2*t15, D_p_y_2_by_l_d_2*t15, D_p_z_2_by_l_d_2*t15,
        D_p_x_3_by_l_d_2*t179 + D_p_y_3_by_l_d_2*t180 + D_p_z_3_by_l_d_2*t181,
        D_delta_x_1_by_l_d_2*t162 + D_delta_y_1_by_l_d_2*t164 + D_delta_z_1_by_l_d_2*t166
        + D_p_x_3_by_l_d_2*t188 + D_p_y_3_by_l_d_2*t190 + D_p_z_3_by_l_d_2*t192,
        D_delta_x_2_by_l_d_2*t162 + D_delta_y_2_by_l_d_2*t164 + D_delta_z_2_by_l_d_2*t166
        + D_p_x_3_by_l_d_2*t197 + D_p_y_3_by_l_d_2*t199 + D_p_z_3_by_l_d_2*t201,
        D_delta_x_3_by_l_d_2*t162 + D_delta_y_3_by_l_d_2*t164 + D_delta_z_3_by_l_d_2*t166
        + D_p_x_3_by_l_d_2*t203 + D_p_y_3_by_l_d_2*t204 + D_p_z_3_by_l_d_2*t205,
        D_p_x_3_by_l_d_2*t15, D_p_y_3_by_l_d_2*t15, D_p_z_3_by_l_d_2*t15, -t244, -t243, t244, t243,
        D_delta_x_1_by_l_d_2*t189 + D_delta_y_1_by_l_d_2*t191 + D_delta_z_1_by_l_d_2*t193,
        D_delta_x_1_by_l_d_2*t197 + D_delta_x_2_by_l_d_2*t188 + D_delta_y_1_by_l_d_2*t199
        + D_delta_y_2_by_l_d_2*t190 + D_delta_z_1_by_l_d_2*t201 + D_delta_z_2_by_l_d_2*t192,
        D_delta_x_1_by_l_d_2*t203 + D_delta_x_3_by_l_d_2*t188 + D_delta_y_1_by_l_d_2*t204
        + D_delta_y_3_by_l_d_2*t190 + D_delta_z_1_by_l_d_2*t205 + D_delta_z_3_by_l_d_2*t192,
        D_delta_x_1_by_l_d_2*t15, D_delta_y_1_by_l_d_2*t15, D_delta_z_1_by_l_d_2*t15,
        D_delta_x_2_by_l_d_2*t198 + D_delta_y_2_by_l_d_2*t200 + D_delta_z_2_by_l_d_2*t202,
        D_delta_x_2_by_l_d_2*t203 + D_delta_x_3_by_l_d_2*t197 + D_delta_y_2_by_l_d_2*t204
        + D_delta_y_3_by_l_d_2*t199 + D_delta_z_2_by_l_d_2*t205 + D_delta_z_3_by_l_d_2*t201,
        D_delta_x_2_by_l_d_2*t15, D_delta_y_2_by_l_d_2*t15, D_delta_z_2_by_l_d_2*t15,
        D_delta_x_3_by_l_d_2*t206 + D_delta_y_3_by_l_d_2*t207 + D_delta_z_3_by_l_d_2*t208,
        D_delta_x_3_by_l_d_2*t15, D_delta_y_3_by_l_d_2*t15, D_delta_z_3_by_l_d_2*t15,
        D_p_x_1_by_l_d_3*t144 + D_p_y_1_by_l_d_3*t146 + D_p_z_1_by_l_d_3*t148,
        D_p_x_1_by_l_d_3*t151 + D_p_x_2_by_l_d_3*t153 + D_p_y_1_by_l_d_3*t155 + D_p_y_2_by_l_d_3*t156
        + D_p_z_1_by_l_d_3*t158 + D_p_z_2_by_l_d_3*t159,
        D_p_x_1_by_l_d_3*t162 + D_p_x_3_by_l_d_3*t153 + D_p_y_1_by_l_d_3*t164 + D_p_y_3_by_l_d_3*t156
        + D_p_z_1_by_l_d_3*t166 + D_p_z_3_by_l_d_3*t159,
        D_delta_x_1_by_l_d_3*t153 + D_delta_y_1_by_l_d_3*t156 + D_delta_z_1_by_l_d_3*t159
        + D_p_x_1_by_l_d_3*t188 + D_p_y_1_by_l_d_3*t190 + D_p_z_1_by_l_d_3*t192,
        D_delta_x_2_by_l_d_3*t153 + D_delta_y_2_by_l_d_3*t156 + D_delta_z_2_by_l_d_3*t159
        + D_p_x_1_by_l_d_3*t197 + D_p_y_1_by_l_d_3*t199 + D_p_z_1_by_l_d_3*t201,
        D_delta_x_3_by_l_d_3*t153 + D_delta_y_3_by_l_d_3*t156 + D_delta_z_3_by_l_d_3*t159
        + D_p_x_1_by_l_d_3*t203 + D_p_y_1_by_l_d_3*t204 + D_p_z_1_by_l_d_3*t205,
        D_p_x_1_by_l_d_3*t15, D_p_y_1_by_l_d_3*t15, D_p_z_1_by_l_d_3*t15,
        D_p_x_2_by_l_d_3*t173 + D_p_y_2_by_l_d_3*t174 + D_p_z_2_by_l_d_3*t175,
        D_p_x_2_by_l_d_3*t162 + D_p_x_3_by_l_d_3*t151 + D_p_y_2_by_l_d_3*t164 + D_p_y_3_by_l_d_3*t155
        + D_p_z_2_by_l_d_3*t166 + D_p_z_3_by_l_d_3*t158,
        D_delta_x_1_by_l_d_3*t151 + D_delta_y_1_by_l_d_3*t155 + D_delta_z_1_by_l_d_3*t158
        + D_p_x_2_by_l_d_3*t188 + D_p_y_2_by_l_d_3*t190 + D_p_z_2_by_l_d_3*t192,
        D_delta_x_2_by_l_d_3*t151 + D_delta_y_2_by_l_d_3*t155 + D_delta_z_2_by_l_d_3*t158
        + D_p_x_2_by_l_d_3*t197 + D_p_y_2_by_l_d_3*t199 + D_p_z_2_by_l_d_3*t201,
        D_delta_x_3_by_l_d_3*t151 + D_delta_y_3_by_l_d_3*t155 + D_delta_z_3_by_l_d_3*t158
        + D_p_x_2_by_l_d_3*t203 + D_p_y_2_by_l_d_3*t204 + D_p_z_2_by_l_d_3*t205,
        D_p_x_2_by_l_d_3*t15, D_p_y_2_by_l_d_3*t15, D_p_z_2_by_l_d_3*t15,
        D_p_x_3_by_l_d_3*t179 + D_p_y_3_by_l_d_3*t180 + D_p_z_3_by_l_d_3*t181, -t246, t246,
        D_delta_x_1_by_l_d_3*t162 + D_delta_y_1_by_l_d_3*t164 + D_delta_z_1_by_l_d_3*t166
        + D_p_x_3_by_l_d_3*t188 + D_p_y_3_by_l_d_3*t190 + D_p_z_3_by_l_d_3*t192,
        D_delta_x_2_by_l_d_3*t162 + D_delta_y_2_by_l_d_3*t164 + D_delta_z_2_by_l_d_3*t166
        + D_p_x_3_by_l_d_3*t197 + D_p_y_3_by_l_d_3*t199 + D_p_z_3_by_l_d_3*t201,
        D_delta_x_3_by_l_d_3*t162 + D_delta_y_3_by_l_d_3*t164 + D_delta_z_3_by_l_d_3*t166
        + D_p_x_3_by_l_d_3*t203 + D_p_y_3_by_l_d_3*t204 + D_p_z_3_by_l_d_3*t205,
        D_p_x_3_by_l_d_3*t15, D_p_y_3_by_l_d_3*t15, D_p_z_3_by_l_d_3*t15, -t247, -t246, t247, t246,
        D_delta_x_1_by_l_d_3*t189 + D_delta_y_1_by_l_d_3*t191 + D_delta_z_1_by_l_d_3*t193,
        D_delta_x_1_by_l_d_3*t197 + D_delta_x_2_by_l_d_3*t188 + D_delta_y_1_by_l_d_3*t199
        + D_delta_y_2_by_l_d_3*t190 + D_delta_z_1_by_l_d_3*t201 + D_delta_z_2_by_l_d_3*t192,
        D_delta_x_1_by_l_d_3*t203 + D_delta_x_3_by_l_d_3*t188 + D_delta_y_1_by_l_d_3*t204
        + D_delta_y_3_by_l_d_3*t190 + D_delta_z_1_by_l_d_3*t205 + D_delta_z_3_by_l_d_3*t192,
        D_delta_x_1_by_l_d_3*t15, D_delta_y_1_by_l_d_3*t15, D_delta_z_1_by_l_d_3*t15,
        D_delta_x_2_by_l_d_3*t198 + D_delta_y_2_by_l_d_3*t200 + D_delta_z_2_by_l_d_3*t202,
        D_delta_x_2_by_l_d_3*t203 + D_delta_x_3_by_l_d_3*t197 + D_delta_y_2_by_l_d_3*t204
        + D_delta_y_3_by_l_d_3*t199 + D_delta_z_2_by_l_d_3*t205 + D_delta_z_3_by_l_d_3*t201,
        D_delta_x_2_by_l_d_3*t15, D_delta_y_2_by_l_d_3*t15, D_delta_z_2_by_l_d_3*t15,
        D_delta_x_3_by_l_d_3*t206 + D_delta_y_3_by_l_d_3*t207 + D_delta_z_3_by_l_d_3*t208,
        D_delta_x_3_by_l_d_3*t15, D_delta_y_3_by_l_d_3*t15, D_delta_z_3_by_l_d_3*t15,
    ))
    K_theta_out = _listed(batch, dtype, (
        2*D_p_x_1*D_p_x_1_by_b_1_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_x*k_C
        + k_sp_1*t262*t263*t271*w_b_1*x_1_by_b_1_x + mu_1_by_b_1_x*t260 + mu_2_by_b_1_x*t261
        + mu_3_by_b_1_x*t261 - t248*t249 - t249*t250 - t249*t251 - t252*t253 - t253*t254 - t253*t255
        - t256*t257 - t257*t258 - t257*t259 - t270,
        D_p_x_1*D_p_x_2_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_2*k_C - D_p_x_1_by_b_1_x*t272
        - D_p_x_1_by_b_1_x*t273 - D_p_x_1_by_b_1_x*t274 - D_p_x_2_by_b_1_x*t248 - D_p_x_2_by_b_1_x*t250
        - D_p_x_2_by_b_1_x*t251 + D_p_y_1*D_p_y_2_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_2*k_C
        - D_p_y_1_by_b_1_x*t275 - D_p_y_1_by_b_1_x*t276 - D_p_y_1_by_b_1_x*t277 - D_p_y_2_by_b_1_x*t252
        - D_p_y_2_by_b_1_x*t254 - D_p_y_2_by_b_1_x*t255 + D_p_z_1*D_p_z_2_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_2*k_C - D_p_z_1_by_b_1_x*t278 - D_p_z_1_by_b_1_x*t279
        - D_p_z_1_by_b_1_x*t280 - D_p_z_2_by_b_1_x*t256 - D_p_z_2_by_b_1_x*t258 - D_p_z_2_by_b_1_x*t259
        + mu_1_by_b_1_x*t281 + mu_2_by_b_1_x*t282 + mu_3_by_b_1_x*t283,
        D_p_x_1*D_p_x_3_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_3*k_C - D_p_x_1_by_b_1_x*t284
        - D_p_x_1_by_b_1_x*t285 - D_p_x_1_by_b_1_x*t286 - D_p_x_3_by_b_1_x*t248 - D_p_x_3_by_b_1_x*t250
        - D_p_x_3_by_b_1_x*t251 + D_p_y_1*D_p_y_3_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_3*k_C
        - D_p_y_1_by_b_1_x*t287 - D_p_y_1_by_b_1_x*t288 - D_p_y_1_by_b_1_x*t289 - D_p_y_3_by_b_1_x*t252
        - D_p_y_3_by_b_1_x*t254 - D_p_y_3_by_b_1_x*t255 + D_p_z_1*D_p_z_3_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_3*k_C - D_p_z_1_by_b_1_x*t290 - D_p_z_1_by_b_1_x*t291
        - D_p_z_1_by_b_1_x*t292 - D_p_z_3_by_b_1_x*t256 - D_p_z_3_by_b_1_x*t258 - D_p_z_3_by_b_1_x*t259
        + mu_1_by_b_1_x*t293 + mu_2_by_b_1_x*t294 + mu_3_by_b_1_x*t295,
        t297, t298,
        D_delta_x_1*t299 + D_delta_x_1_by_b_1_x*t313 + D_delta_y_1*t300 + D_delta_y_1_by_b_1_x*t314
        + D_delta_z_1*t301 + D_delta_z_1_by_b_1_x*t315 - D_p_x_1_by_b_1_x*t302 - D_p_x_1_by_b_1_x*t303
        - D_p_x_1_by_b_1_x*t304 - D_p_y_1_by_b_1_x*t305 - D_p_y_1_by_b_1_x*t306 - D_p_y_1_by_b_1_x*t307
        - D_p_z_1_by_b_1_x*t308 - D_p_z_1_by_b_1_x*t309 - D_p_z_1_by_b_1_x*t310 + mu_1_by_b_1_x*t311
        + mu_2_by_b_1_x*t312 + mu_3_by_b_1_x*t312,
        D_delta_x_2*t299 + D_delta_x_2_by_b_1_x*t313 + D_delta_y_2*t300 + D_delta_y_2_by_b_1_x*t314
        + D_delta_z_2*t301 + D_delta_z_2_by_b_1_x*t315 - D_p_x_1_by_b_1_x*t316 - D_p_x_1_by_b_1_x*t317
        - D_p_x_1_by_b_1_x*t318 - D_p_y_1_by_b_1_x*t319 - D_p_y_1_by_b_1_x*t320 - D_p_y_1_by_b_1_x*t321
        - D_p_z_1_by_b_1_x*t322 - D_p_z_1_by_b_1_x*t323 - D_p_z_1_by_b_1_x*t324 + mu_1_by_b_1_x*t325
        + mu_2_by_b_1_x*t326 + mu_3_by_b_1_x*t326,
        D_delta_x_3*t299 + D_delta_x_3_by_b_1_x*t313 + D_delta_y_3*t300 + D_delta_y_3_by_b_1_x*t314
        + D_delta_z_3*t301 + D_delta_z_3_by_b_1_x*t315 - D_p_x_1_by_b_1_x*t327 - D_p_x_1_by_b_1_x*t328
        - D_p_x_1_by_b_1_x*t329 - D_p_y_1_by_b_1_x*t330 - D_p_y_1_by_b_1_x*t331 - D_p_y_1_by_b_1_x*t332
        - D_p_z_1_by_b_1_x*t333 - D_p_z_1_by_b_1_x*t334 - D_p_z_1_by_b_1_x*t335 + mu_1_by_b_1_x*t336
        + mu_2_by_b_1_x*t337 + mu_3_by_b_1_x*t337,
        t338, t299, t300, t301,
        2*D_p_x_2*D_p_x_2_by_b_1_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_x*k_C
        + mu_1_by_b_1_x*t342 + mu_2_by_b_1_x*t343 + mu_3_by_b_1_x*t342 - t272*t339 - t273*t339 - t274*t339
        - t275*t340 - t276*t340 - t277*t340 - t278*t341 - t279*t341 - t280*t341,
        D_p_x_2*D_p_x_3_by_b_1_x*k_C + D_p_x_2_by_b_1_x*D_p_x_3*k_C - D_p_x_2_by_b_1_x*t284
        - D_p_x_2_by_b_1_x*t285 - D_p_x_2_by_b_1_x*t286 - D_p_x_3_by_b_1_x*t272 - D_p_x_3_by_b_1_x*t273
        - D_p_x_3_by_b_1_x*t274 + D_p_y_2*D_p_y_3_by_b_1_x*k_C + D_p_y_2_by_b_1_x*D_p_y_3*k_C
        - D_p_y_2_by_b_1_x*t287 - D_p_y_2_by_b_1_x*t288 - D_p_y_2_by_b_1_x*t289 - D_p_y_3_by_b_1_x*t275
        - D_p_y_3_by_b_1_x*t276 - D_p_y_3_by_b_1_x*t277 + D_p_z_2*D_p_z_3_by_b_1_x*k_C
        + D_p_z_2_by_b_1_x*D_p_z_3*k_C - D_p_z_2_by_b_1_x*t290 - D_p_z_2_by_b_1_x*t291
        - D_p_z_2_by_b_1_x*t292 - D_p_z_3_by_b_1_x*t278 - D_p_z_3_by_b_1_x*t279 - D_p_z_3_by_b_1_x*t280
        + mu_1_by_b_1_x*t344 + mu_2_by_b_1_x*t345 + mu_3_by_b_1_x*t346,
        D_delta_x_1*t347 + D_delta_x_1_by_b_1_x*t352 + D_delta_y_1*t348 + D_delta_y_1_by_b_1_x*t353
        + D_delta_z_1*t349 + D_delta_z_1_by_b_1_x*t354 - D_p_x_2_by_b_1_x*t302 - D_p_x_2_by_b_1_x*t303
        - D_p_x_2_by_b_1_x*t304 - D_p_y_2_by_b_1_x*t305 - D_p_y_2_by_b_1_x*t306 - D_p_y_2_by_b_1_x*t307
        - D_p_z_2_by_b_1_x*t308 - D_p_z_2_by_b_1_x*t309 - D_p_z_2_by_b_1_x*t310 + mu_1_by_b_1_x*t350
        + mu_2_by_b_1_x*t351 + mu_3_by_b_1_x*t350,
        D_delta_x_2*t347 + D_delta_x_2_by_b_1_x*t352 + D_delta_y_2*t348 + D_delta_y_2_by_b_1_x*t353
        + D_delta_z_2*t349 + D_delta_z_2_by_b_1_x*t354 - D_p_x_2_by_b_1_x*t316 - D_p_x_2_by_b_1_x*t317
        - D_p_x_2_by_b_1_x*t318 - D_p_y_2_by_b_1_x*t319 - D_p_y_2_by_b_1_x*t320 - D_p_y_2_by_b_1_x*t321
        - D_p_z_2_by_b_1_x*t322 - D_p_z_2_by_b_1_x*t323 - D_p_z_2_by_b_1_x*t324 + mu_1_by_b_1_x*t355
        + mu_2_by_b_1_x*t356 + mu_3_by_b_1_x*t355,
        D_delta_x_3*t347 + D_delta_x_3_by_b_1_x*t352 + D_delta_y_3*t348 + D_delta_y_3_by_b_1_x*t353
        + D_delta_z_3*t349 + D_delta_z_3_by_b_1_x*t354 - D_p_x_2_by_b_1_x*t327 - D_p_x_2_by_b_1_x*t328
        - D_p_x_2_by_b_1_x*t329 - D_p_y_2_by_b_1_x*t330 - D_p_y_2_by_b_1_x*t331 - D_p_y_2_by_b_1_x*t332
        - D_p_z_2_by_b_1_x*t333 - D_p_z_2_by_b_1_x*t334 - D_p_z_2_by_b_1_x*t335 + mu_1_by_b_1_x*t357
        + mu_2_by_b_1_x*t358 + mu_3_by_b_1_x*t357,
        t347, t348, t349,
        2*D_p_x_3*D_p_x_3_by_b_1_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_x*k_C
        + mu_1_by_b_1_x*t362 + mu_2_by_b_1_x*t362 + mu_3_by_b_1_x*t363 - t284*t359 - t285*t359 - t286*t359
        - t287*t360 - t288*t360 - t289*t360 - t290*t361 - t291*t361 - t292*t361,
        D_delta_x_1*t364 + D_delta_x_1_by_b_1_x*t369 + D_delta_y_1*t365 + D_delta_y_1_by_b_1_x*t370
        + D_delta_z_1*t366 + D_delta_z_1_by_b_1_x*t371 - D_p_x_3_by_b_1_x*t302 - D_p_x_3_by_b_1_x*t303
        - D_p_x_3_by_b_1_x*t304 - D_p_y_3_by_b_1_x*t305 - D_p_y_3_by_b_1_x*t306 - D_p_y_3_by_b_1_x*t307
        - D_p_z_3_by_b_1_x*t308 - D_p_z_3_by_b_1_x*t309 - D_p_z_3_by_b_1_x*t310 + mu_1_by_b_1_x*t367
        + mu_2_by_b_1_x*t367 + mu_3_by_b_1_x*t368,
        D_delta_x_2*t364 + D_delta_x_2_by_b_1_x*t369 + D_delta_y_2*t365 + D_delta_y_2_by_b_1_x*t370
        + D_delta_z_2*t366 + D_delta_z_2_by_b_1_x*t371 - D_p_x_3_by_b_1_x*t316 - D_p_x_3_by_b_1_x*t317
        - D_p_x_3_by_b_1_x*t318 - D_p_y_3_by_b_1_x*t319 - D_p_y_3_by_b_1_x*t320 - D_p_y_3_by_b_1_x*t321
        - D_p_z_3_by_b_1_x*t322 - D_p_z_3_by_b_1_x*t323 - D_p_z_3_by_b_1_x*t324 + mu_1_by_b_1_x*t372
        + mu_2_by_b_1_x*t372 + mu_3_by_b_1_x*t373,
        D_delta_x_3*t364 + D_delta_x_3_by_b_1_x*t369 + D_delta_y_3*t365 + D_delta_y_3_by_b_1_x*t370
        + D_delta_z_3*t366 + D_delta_z_3_by_b_1_x*t371 - D_p_x_3_by_b_1_x*t327 - D_p_x_3_by_b_1_x*t328
        - D_p_x_3_by_b_1_x*t329 - D_p_y_3_by_b_1_x*t330 - D_p_y_3_by_b_1_x*t331 - D_p_y_3_by_b_1_x*t332
        - D_p_z_3_by_b_1_x*t333 - D_p_z_3_by_b_1_x*t334 - D_p_z_3_by_b_1_x*t335 + mu_1_by_b_1_x*t374
        + mu_2_by_b_1_x*t374 + mu_3_by_b_1_x*t375,
        t364, t365, t366, t185*t296, t297, -t185*t270, t298,
        D_delta_x_1_by_b_1_x*t377 + D_delta_y_1_by_b_1_x*t378 + D_delta_z_1_by_b_1_x*t379
        + mu_1_by_b_1_x*t380 - mu_2_by_b_1_x*t376 - mu_3_by_b_1_x*t376,
        D_delta_x_1_by_b_1_x*t382 + D_delta_x_2_by_b_1_x*t383 + D_delta_y_1_by_b_1_x*t384
        + D_delta_y_2_by_b_1_x*t385 + D_delta_z_1_by_b_1_x*t386 + D_delta_z_2_by_b_1_x*t387
        + mu_1_by_b_1_x*t381 + mu_2_by_b_1_x*t381 + mu_3_by_b_1_x*t381,
        D_delta_x_1_by_b_1_x*t389 + D_delta_x_3_by_b_1_x*t383 + D_delta_y_1_by_b_1_x*t390
        + D_delta_y_3_by_b_1_x*t385 + D_delta_z_1_by_b_1_x*t391 + D_delta_z_3_by_b_1_x*t387
        + mu_1_by_b_1_x*t388 + mu_2_by_b_1_x*t388 + mu_3_by_b_1_x*t388,
        D_delta_x_1_by_b_1_x*k_C, D_delta_y_1_by_b_1_x*k_C, D_delta_z_1_by_b_1_x*k_C,
        D_delta_x_2_by_b_1_x*t393 + D_delta_y_2_by_b_1_x*t394 + D_delta_z_2_by_b_1_x*t395
        - mu_1_by_b_1_x*t392 + mu_2_by_b_1_x*t396 - mu_3_by_b_1_x*t392,
        D_delta_x_2_by_b_1_x*t389 + D_delta_x_3_by_b_1_x*t382 + D_delta_y_2_by_b_1_x*t390
        + D_delta_y_3_by_b_1_x*t384 + D_delta_z_2_by_b_1_x*t391 + D_delta_z_3_by_b_1_x*t386
        + mu_1_by_b_1_x*t397 + mu_2_by_b_1_x*t397 + mu_3_by_b_1_x*t397,
        D_delta_x_2_by_b_1_x*k_C, D_delta_y_2_by_b_1_x*k_C, D_delta_z_2_by_b_1_x*k_C,
        D_delta_x_3_by_b_1_x*t399 + D_delta_y_3_by_b_1_x*t400 + D_delta_z_3_by_b_1_x*t401
        - mu_1_by_b_1_x*t398 - mu_2_by_b_1_x*t398 + mu_3_by_b_1_x*t402,
        D_delta_x_3_by_b_1_x*k_C, D_delta_y_3_by_b_1_x*k_C, D_delta_z_3_by_b_1_x*k_C, t338,
        2*D_p_x_1*D_p_x_1_by_b_1_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_y*k_C
        + k_sp_1*t262*t263*t271*w_b_1*x_1_by_b_1_y + mu_1_by_b_1_y*t260 + mu_2_by_b_1_y*t261
        + mu_3_by_b_1_y*t261 - t248*t403 - t250*t403 - t251*t403 - t252*t404 - t254*t404 - t255*t404
        - t256*t405 - t258*t405 - t259*t405 - t407,
        D_p_x_1*D_p_x_2_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_2*k_C - D_p_x_1_by_b_1_y*t272
        - D_p_x_1_by_b_1_y*t273 - D_p_x_1_by_b_1_y*t274 - D_p_x_2_by_b_1_y*t248 - D_p_x_2_by_b_1_y*t250
        - D_p_x_2_by_b_1_y*t251 + D_p_y_1*D_p_y_2_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_2*k_C
        - D_p_y_1_by_b_1_y*t275 - D_p_y_1_by_b_1_y*t276 - D_p_y_1_by_b_1_y*t277 - D_p_y_2_by_b_1_y*t252
        - D_p_y_2_by_b_1_y*t254 - D_p_y_2_by_b_1_y*t255 + D_p_z_1*D_p_z_2_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_2*k_C - D_p_z_1_by_b_1_y*t278 - D_p_z_1_by_b_1_y*t279
        - D_p_z_1_by_b_1_y*t280 - D_p_z_2_by_b_1_y*t256 - D_p_z_2_by_b_1_y*t258 - D_p_z_2_by_b_1_y*t259
        + mu_1_by_b_1_y*t281 + mu_2_by_b_1_y*t282 + mu_3_by_b_1_y*t283,
        D_p_x_1*D_p_x_3_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_3*k_C - D_p_x_1_by_b_1_y*t284
        - D_p_x_1_by_b_1_y*t285 - D_p_x_1_by_b_1_y*t286 - D_p_x_3_by_b_1_y*t248 - D_p_x_3_by_b_1_y*t250
        - D_p_x_3_by_b_1_y*t251 + D_p_y_1*D_p_y_3_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_3*k_C
        - D_p_y_1_by_b_1_y*t287 - D_p_y_1_by_b_1_y*t288 - D_p_y_1_by_b_1_y*t289 - D_p_y_3_by_b_1_y*t252
        - D_p_y_3_by_b_1_y*t254 - D_p_y_3_by_b_1_y*t255 + D_p_z_1*D_p_z_3_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_3*k_C - D_p_z_1_by_b_1_y*t290 - D_p_z_1_by_b_1_y*t291
        - D_p_z_1_by_b_1_y*t292 - D_p_z_3_by_b_1_y*t256 - D_p_z_3_by_b_1_y*t258 - D_p_z_3_by_b_1_y*t259
        + mu_1_by_b_1_y*t293 + mu_2_by_b_1_y*t294 + mu_3_by_b_1_y*t295,
        t409, t410,
        D_delta_x_1_by_b_1_y*t313 + D_delta_y_1_by_b_1_y*t314 + D_delta_z_1_by_b_1_y*t315
        - D_p_x_1_by_b_1_y*t302 - D_p_x_1_by_b_1_y*t303 - D_p_x_1_by_b_1_y*t304 + D_p_x_1_by_b_1_y*t411
        - D_p_y_1_by_b_1_y*t305 - D_p_y_1_by_b_1_y*t306 - D_p_y_1_by_b_1_y*t307 + D_p_y_1_by_b_1_y*t412
        - D_p_z_1_by_b_1_y*t308 - D_p_z_1_by_b_1_y*t309 - D_p_z_1_by_b_1_y*t310 + D_p_z_1_by_b_1_y*t413
        + mu_1_by_b_1_y*t311 + mu_2_by_b_1_y*t312 + mu_3_by_b_1_y*t312,
        D_delta_x_2_by_b_1_y*t313 + D_delta_y_2_by_b_1_y*t314 + D_delta_z_2_by_b_1_y*t315
        - D_p_x_1_by_b_1_y*t316 - D_p_x_1_by_b_1_y*t317 - D_p_x_1_by_b_1_y*t318 + D_p_x_1_by_b_1_y*t414
        - D_p_y_1_by_b_1_y*t319 - D_p_y_1_by_b_1_y*t320 - D_p_y_1_by_b_1_y*t321 + D_p_y_1_by_b_1_y*t415
        - D_p_z_1_by_b_1_y*t322 - D_p_z_1_by_b_1_y*t323 - D_p_z_1_by_b_1_y*t324 + D_p_z_1_by_b_1_y*t416
        + mu_1_by_b_1_y*t325 + mu_2_by_b_1_y*t326 + mu_3_by_b_1_y*t326,
        D_delta_x_3_by_b_1_y*t313 + D_delta_y_3_by_b_1_y*t314 + D_delta_z_3_by_b_1_y*t315
        - D_p_x_1_by_b_1_y*t327 - D_p_x_1_by_b_1_y*t328 - D_p_x_1_by_b_1_y*t329 + D_p_x_1_by_b_1_y*t417
        - D_p_y_1_by_b_1_y*t330 - D_p_y_1_by_b_1_y*t331 - D_p_y_1_by_b_1_y*t332 + D_p_y_1_by_b_1_y*t418
        - D_p_z_1_by_b_1_y*t333 - D_p_z_1_by_b_1_y*t334 - D_p_z_1_by_b_1_y*t335 + D_p_z_1_by_b_1_y*t419
        + mu_1_by_b_1_y*t336 + mu_2_by_b_1_y*t337 + mu_3_by_b_1_y*t337,
        t420, D_p_x_1_by_b_1_y*k_C, D_p_y_1_by_b_1_y*k_C, D_p_z_1_by_b_1_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_y*k_C
        + mu_1_by_b_1_y*t342 + mu_2_by_b_1_y*t343 + mu_3_by_b_1_y*t342 - t272*t421 - t273*t421 - t274*t421
        - t275*t422 - t276*t422 - t277*t422 - t278*t423 - t279*t423 - t280*t423,
        D_p_x_2*D_p_x_3_by_b_1_y*k_C + D_p_x_2_by_b_1_y*D_p_x_3*k_C - D_p_x_2_by_b_1_y*t284
        - D_p_x_2_by_b_1_y*t285 - D_p_x_2_by_b_1_y*t286 - D_p_x_3_by_b_1_y*t272 - D_p_x_3_by_b_1_y*t273
        - D_p_x_3_by_b_1_y*t274 + D_p_y_2*D_p_y_3_by_b_1_y*k_C + D_p_y_2_by_b_1_y*D_p_y_3*k_C
        - D_p_y_2_by_b_1_y*t287 - D_p_y_2_by_b_1_y*t288 - D_p_y_2_by_b_1_y*t289 - D_p_y_3_by_b_1_y*t275
        - D_p_y_3_by_b_1_y*t276 - D_p_y_3_by_b_1_y*t277 + D_p_z_2*D_p_z_3_by_b_1_y*k_C
        + D_p_z_2_by_b_1_y*D_p_z_3*k_C - D_p_z_2_by_b_1_y*t290 - D_p_z_2_by_b_1_y*t291
        - D_p_z_2_by_b_1_y*t292 - D_p_z_3_by_b_1_y*t278 - D_p_z_3_by_b_1_y*t279 - D_p_z_3_by_b_1_y*t280
        + mu_1_by_b_1_y*t344 + mu_2_by_b_1_y*t345 + mu_3_by_b_1_y*t346,
        D_delta_x_1_by_b_1_y*t352 + D_delta_y_1_by_b_1_y*t353 + D_delta_z_1_by_b_1_y*t354
        - D_p_x_2_by_b_1_y*t302 - D_p_x_2_by_b_1_y*t303 - D_p_x_2_by_b_1_y*t304 + D_p_x_2_by_b_1_y*t411
        - D_p_y_2_by_b_1_y*t305 - D_p_y_2_by_b_1_y*t306 - D_p_y_2_by_b_1_y*t307 + D_p_y_2_by_b_1_y*t412
        - D_p_z_2_by_b_1_y*t308 - D_p_z_2_by_b_1_y*t309 - D_p_z_2_by_b_1_y*t310 + D_p_z_2_by_b_1_y*t413
        + mu_1_by_b_1_y*t350 + mu_2_by_b_1_y*t351 + mu_3_by_b_1_y*t350,
        D_delta_x_2_by_b_1_y*t352 + D_delta_y_2_by_b_1_y*t353 + D_delta_z_2_by_b_1_y*t354
        - D_p_x_2_by_b_1_y*t316 - D_p_x_2_by_b_1_y*t317 - D_p_x_2_by_b_1_y*t318 + D_p_x_2_by_b_1_y*t414
        - D_p_y_2_by_b_1_y*t319 - D_p_y_2_by_b_1_y*t320 - D_p_y_2_by_b_1_y*t321 + D_p_y_2_by_b_1_y*t415
        - D_p_z_2_by_b_1_y*t322 - D_p_z_2_by_b_1_y*t323 - D_p_z_2_by_b_1_y*t324 + D_p_z_2_by_b_1_y*t416
        + mu_1_by_b_1_y*t355 + mu_2_by_b_1_y*t356 + mu_3_by_b_1_y*t355,
        D_delta_x_3_by_b_1_y*t352 + D_delta_y_3_by_b_1_y*t353 + D_delta_z_3_by_b_1_y*t354
        - D_p_x_2_by_b_1_y*t327 - D_p_x_2_by_b_1_y*t328 - D_p_x_2_by_b_1_y*t329 + D_p_x_2_by_b_1_y*t417
        - D_p_y_2_by_b_1_y*t330 - D_p_y_2_by_b_1_y*t331 - D_p_y_2_by_b_1_y*t332 + D_p_y_2_by_b_1_y*t418
        - D_p_z_2_by_b_1_y*t333 - D_p_z_2_by_b_1_y*t334 - D_p_z_2_by_b_1_y*t335 + D_p_z_2_by_b_1_y*t419
        + mu_1_by_b_1_y*t357 + mu_2_by_b_1_y*t358 + mu_3_by_b_1_y*t357,
        D_p_x_2_by_b_1_y*k_C, D_p_y_2_by_b_1_y*k_C, D_p_z_2_by_b_1_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_y*k_C
        + mu_1_by_b_1_y*t362 + mu_2_by_b_1_y*t362 + mu_3_by_b_1_y*t363 - t284*t424 - t285*t424 - t286*t424
        - t287*t425 - t288*t425 - t289*t425 - t290*t426 - t291*t426 - t292*t426,
        D_delta_x_1_by_b_1_y*t369 + D_delta_y_1_by_b_1_y*t370 + D_delta_z_1_by_b_1_y*t371
        - D_p_x_3_by_b_1_y*t302 - D_p_x_3_by_b_1_y*t303 - D_p_x_3_by_b_1_y*t304 + D_p_x_3_by_b_1_y*t411
        - D_p_y_3_by_b_1_y*t305 - D_p_y_3_by_b_1_y*t306 - D_p_y_3_by_b_1_y*t307 + D_p_y_3_by_b_1_y*t412
        - D_p_z_3_by_b_1_y*t308 - D_p_z_3_by_b_1_y*t309 - D_p_z_3_by_b_1_y*t310 + D_p_z_3_by_b_1_y*t413
        + mu_1_by_b_1_y*t367 + mu_2_by_b_1_y*t367 + mu_3_by_b_1_y*t368,
        D_delta_x_2_by_b_1_y*t369 + D_delta_y_2_by_b_1_y*t370 + D_delta_z_2_by_b_1_y*t371
        - D_p_x_3_by_b_1_y*t316 - D_p_x_3_by_b_1_y*t317 - D_p_x_3_by_b_1_y*t318 + D_p_x_3_by_b_1_y*t414
        - D_p_y_3_by_b_1_y*t319 - D_p_y_3_by_b_1_y*t320 - D_p_y_3_by_b_1_y*t321 + D_p_y_3_by_b_1_y*t415
        - D_p_z_3_by_b_1_y*t322 - D_p_z_3_by_b_1_y*t323 - D_p_z_3_by_b_1_y*t324 + D_p_z_3_by_b_1_y*t416
        + mu_1_by_b_1_y*t372 + mu_2_by_b_1_y*t372 + mu_3_by_b_1_y*t373,
        D_delta_x_3_by_b_1_y*t369 + D_delta_y_3_by_b_1_y*t370 + D_delta_z_3_by_b_1_y*t371
        - D_p_x_3_by_b_1_y*t327 - D_p_x_3_by_b_1_y*t328 - D_p_x_3_by_b_1_y*t329 + D_p_x_3_by_b_1_y*t417
        - D_p_y_3_by_b_1_y*t330 - D_p_y_3_by_b_1_y*t331 - D_p_y_3_by_b_1_y*t332 + D_p_y_3_by_b_1_y*t418
        - D_p_z_3_by_b_1_y*t333 - D_p_z_3_by_b_1_y*t334 - D_p_z_3_by_b_1_y*t335 + D_p_z_3_by_b_1_y*t419
        + mu_1_by_b_1_y*t374 + mu_2_by_b_1_y*t374 + mu_3_by_b_1_y*t375,
        D_p_x_3_by_b_1_y*k_C, D_p_y_3_by_b_1_y*k_C, D_p_z_3_by_b_1_y*k_C, t185*t408, t409, -t185*t407, t410,
        D_delta_x_1_by_b_1_y*t377 + D_delta_y_1_by_b_1_y*t378 + D_delta_z_1_by_b_1_y*t379
        + mu_1_by_b_1_y*t380 - mu_2_by_b_1_y*t376 - mu_3_by_b_1_y*t376,
        D_delta_x_1_by_b_1_y*t382 + D_delta_x_2_by_b_1_y*t383 + D_delta_y_1_by_b_1_y*t384
        + D_delta_y_2_by_b_1_y*t385 + D_delta_z_1_by_b_1_y*t386 + D_delta_z_2_by_b_1_y*t387
        + mu_1_by_b_1_y*t381 + mu_2_by_b_1_y*t381 + mu_3_by_b_1_y*t381,
        D_delta_x_1_by_b_1_y*t389 + D_delta_x_3_by_b_1_y*t383 + D_delta_y_1_by_b_1_y*t390
        + D_delta_y_3_by_b_1_y*t385 + D_delta_z_1_by_b_1_y*t391 + D_delta_z_3_by_b_1_y*t387
        + mu_1_by_b_1_y*t388 + mu_2_by_b_1_y*t388 + mu_3_by_b_1_y*t388,
        D_delta_x_1_by_b_1_y*k_C, D_delta_y_1_by_b_1_y*k_C, D_delta_z_1_by_b_1_y*k_C,
        D_delta_x_2_by_b_1_y*t393 + D_delta_y_2_by_b_1_y*t394 + D_delta_z_2_by_b_1_y*t395
        - mu_1_by_b_1_y*t392 + mu_2_by_b_1_y*t396 - mu_3_by_b_1_y*t392,
        D_delta_x_2_by_b_1_y*t389 + D_delta_x_3_by_b_1_y*t382 + D_delta_y_2_by_b_1_y*t390
        + D_delta_y_3_by_b_1_y*t384 + D_delta_z_2_by_b_1_y*t391 + D_delta_z_3_by_b_1_y*t386
        + mu_1_by_b_1_y*t397 + mu_2_by_b_1_y*t397 + mu_3_by_b_1_y*t397,
        D_delta_x_2_by_b_1_y*k_C, D_delta_y_2_by_b_1_y*k_C, D_delta_z_2_by_b_1_y*k_C,
        D_delta_x_3_by_b_1_y*t399 + D_delta_y_3_by_b_1_y*t400 + D_delta_z_3_by_b_1_y*t401
        - mu_1_by_b_1_y*t398 - mu_2_by_b_1_y*t398 + mu_3_by_b_1_y*t402,
        D_delta_x_3_by_b_1_y*k_C, D_delta_y_3_by_b_1_y*k_C, D_delta_z_3_by_b_1_y*k_C, t420,
        2*D_p_x_1*D_p_x_1_by_b_1_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_z*k_C
        + k_sp_1*t262*t263*t271*w_b_1*x_1_by_b_1_z + mu_1_by_b_1_z*t260 + mu_2_by_b_1_z*t261
        + mu_3_by_b_1_z*t261 - t248*t427 - t250*t427 - t251*t427 - t252*t428 - t254*t428 - t255*t428
        - t256*t429 - t258*t429 - t259*t429 - t431,
        D_p_x_1*D_p_x_2_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_2*k_C - D_p_x_1_by_b_1_z*t272
        - D_p_x_1_by_b_1_z*t273 - D_p_x_1_by_b_1_z*t274 - D_p_x_2_by_b_1_z*t248 - D_p_x_2_by_b_1_z*t250
        - D_p_x_2_by_b_1_z*t251 + D_p_y_1*D_p_y_2_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_2*k_C
        - D_p_y_1_by_b_1_z*t275 - D_p_y_1_by_b_1_z*t276 - D_p_y_1_by_b_1_z*t277 - D_p_y_2_by_b_1_z*t252
        - D_p_y_2_by_b_1_z*t254 - D_p_y_2_by_b_1_z*t255 + D_p_z_1*D_p_z_2_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_2*k_C - D_p_z_1_by_b_1_z*t278 - D_p_z_1_by_b_1_z*t279
        - D_p_z_1_by_b_1_z*t280 - D_p_z_2_by_b_1_z*t256 - D_p_z_2_by_b_1_z*t258 - D_p_z_2_by_b_1_z*t259
        + mu_1_by_b_1_z*t281 + mu_2_by_b_1_z*t282 + mu_3_by_b_1_z*t283,
        D_p_x_1*D_p_x_3_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_3*k_C - D_p_x_1_by_b_1_z*t284
        - D_p_x_1_by_b_1_z*t285 - D_p_x_1_by_b_1_z*t286 - D_p_x_3_by_b_1_z*t248 - D_p_x_3_by_b_1_z*t250
        - D_p_x_3_by_b_1_z*t251 + D_p_y_1*D_p_y_3_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_3*k_C
        - D_p_y_1_by_b_1_z*t287 - D_p_y_1_by_b_1_z*t288 - D_p_y_1_by_b_1_z*t289 - D_p_y_3_by_b_1_z*t252
        - D_p_y_3_by_b_1_z*t254 - D_p_y_3_by_b_1_z*t255 + D_p_z_1*D_p_z_3_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_3*k_C - D_p_z_1_by_b_1_z*t290 - D_p_z_1_by_b_1_z*t291
        - D_p_z_1_by_b_1_z*t292 - D_p_z_3_by_b_1_z*t256 - D_p_z_3_by_b_1_z*t258 - D_p_z_3_by_b_1_z*t259
        + mu_1_by_b_1_z*t293 + mu_2_by_b_1_z*t294 + mu_3_by_b_1_z*t295,
        t433, t434,
        D_delta_x_1_by_b_1_z*t313 + D_delta_y_1_by_b_1_z*t314 + D_delta_z_1_by_b_1_z*t315
        - D_p_x_1_by_b_1_z*t302 - D_p_x_1_by_b_1_z*t303 - D_p_x_1_by_b_1_z*t304 + D_p_x_1_by_b_1_z*t411
        - D_p_y_1_by_b_1_z*t305 - D_p_y_1_by_b_1_z*t306 - D_p_y_1_by_b_1_z*t307 + D_p_y_1_by_b_1_z*t412
        - D_p_z_1_by_b_1_z*t308 - D_p_z_1_by_b_1_z*t309 - D_p_z_1_by_b_1_z*t310 + D_p_z_1_by_b_1_z*t413
        + mu_1_by_b_1_z*t311 + mu_2_by_b_1_z*t312 + mu_3_by_b_1_z*t312,
        D_delta_x_2_by_b_1_z*t313 + D_delta_y_2_by_b_1_z*t314 + D_delta_z_2_by_b_1_z*t315
        - D_p_x_1_by_b_1_z*t316 - D_p_x_1_by_b_1_z*t317 - D_p_x_1_by_b_1_z*t318 + D_p_x_1_by_b_1_z*t414
        - D_p_y_1_by_b_1_z*t319 - D_p_y_1_by_b_1_z*t320 - D_p_y_1_by_b_1_z*t321 + D_p_y_1_by_b_1_z*t415
        - D_p_z_1_by_b_1_z*t322 - D_p_z_1_by_b_1_z*t323 - D_p_z_1_by_b_1_z*t324 + D_p_z_1_by_b_1_z*t416
        + mu_1_by_b_1_z*t325 + mu_2_by_b_1_z*t326 + mu_3_by_b_1_z*t326,
        D_delta_x_3_by_b_1_z*t313 + D_delta_y_3_by_b_1_z*t314 + D_delta_z_3_by_b_1_z*t315
        - D_p_x_1_by_b_1_z*t327 - D_p_x_1_by_b_1_z*t328 - D_p_x_1_by_b_1_z*t329 + D_p_x_1_by_b_1_z*t417
        - D_p_y_1_by_b_1_z*t330 - D_p_y_1_by_b_1_z*t331 - D_p_y_1_by_b_1_z*t332 + D_p_y_1_by_b_1_z*t418
        - D_p_z_1_by_b_1_z*t333 - D_p_z_1_by_b_1_z*t334 - D_p_z_1_by_b_1_z*t335 + D_p_z_1_by_b_1_z*t419
        + mu_1_by_b_1_z*t336 + mu_2_by_b_1_z*t337 + mu_3_by_b_1_z*t337,
        t435, D_p_x_1_by_b_1_z*k_C, D_p_y_1_by_b_1_z*k_C, D_p_z_1_by_b_1_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_z*k_C
        + mu_1_by_b_1_z*t342 + mu_2_by_b_1_z*t343 + mu_3_by_b_1_z*t342 - t272*t436 - t273*t436 - t274*t436
        - t275*t437 - t276*t437 - t277*t437 - t278*t438 - t279*t438 - t280*t438,
        D_p_x_2*D_p_x_3_by_b_1_z*k_C + D_p_x_2_by_b_1_z*D_p_x_3*k_C - D_p_x_2_by_b_1_z*t284
        - D_p_x_2_by_b_1_z*t285 - D_p_x_2_by_b_1_z*t286 - D_p_x_3_by_b_1_z*t272 - D_p_x_3_by_b_1_z*t273
        - D_p_x_3_by_b_1_z*t274 + D_p_y_2*D_p_y_3_by_b_1_z*k_C + D_p_y_2_by_b_1_z*D_p_y_3*k_C
        - D_p_y_2_by_b_1_z*t287 - D_p_y_2_by_b_1_z*t288 - D_p_y_2_by_b_1_z*t289 - D_p_y_3_by_b_1_z*t275
        - D_p_y_3_by_b_1_z*t276 - D_p_y_3_by_b_1_z*t277 + D_p_z_2*D_p_z_3_by_b_1_z*k_C
        + D_p_z_2_by_b_1_z*D_p_z_3*k_C - D_p_z_2_by_b_1_z*t290 - D_p_z_2_by_b_1_z*t291
        - D_p_z_2_by_b_1_z*t292 - D_p_z_3_by_b_1_z*t278 - D_p_z_3_by_b_1_z*t279 - D_p_z_3_by_b_1_z*t280
        + mu_1_by_b_1_z*t344 + mu_2_by_b_1_z*t345 + mu_3_by_b_1_z*t346,
        D_delta_x_1_by_b_1_z*t352 + D_delta_y_1_by_b_1_z*t353 + D_delta_z_1_by_b_1_z*t354
        - D_p_x_2_by_b_1_z*t302 - D_p_x_2_by_b_1_z*t303 - D_p_x_2_by_b_1_z*t304 + D_p_x_2_by_b_1_z*t411
        - D_p_y_2_by_b_1_z*t305 - D_p_y_2_by_b_1_z*t306 - D_p_y_2_by_b_1_z*t307 + D_p_y_2_by_b_1_z*t412
        - D_p_z_2_by_b_1_z*t308 - D_p_z_2_by_b_1_z*t309 - D_p_z_2_by_b_1_z*t310 + D_p_z_2_by_b_1_z*t413
        + mu_1_by_b_1_z*t350 + mu_2_by_b_1_z*t351 + mu_3_by_b_1_z*t350,
        D_delta_x_2_by_b_1_z*t352 + D_delta_y_2_by_b_1_z*t353 + D_delta_z_2_by_b_1_z*t354
        - D_p_x_2_by_b_1_z*t316 - D_p_x_2_by_b_1_z*t317 - D_p_x_2_by_b_1_z*t318 + D_p_x_2_by_b_1_z*t414
        - D_p_y_2_by_b_1_z*t319 - D_p_y_2_by_b_1_z*t320 - D_p_y_2_by_b_1_z*t321 + D_p_y_2_by_b_1_z*t415
        - D_p_z_2_by_b_1_z*t322 - D_p_z_2_by_b_1_z*t323 - D_p_z_2_by_b_1_z*t324 + D_p_z_2_by_b_1_z*t416
        + mu_1_by_b_1_z*t355 + mu_2_by_b_1_z*t356 + mu_3_by_b_1_z*t355,
        D_delta_x_3_by_b_1_z*t352 + D_delta_y_3_by_b_1_z*t353 + D_delta_z_3_by_b_1_z*t354
        - D_p_x_2_by_b_1_z*t327 - D_p_x_2_by_b_1_z*t328 - D_p_x_2_by_b_1_z*t329 + D_p_x_2_by_b_1_z*t417
        - D_p_y_2_by_b_1_z*t330 - D_p_y_2_by_b_1_z*t331 - D_p_y_2_by_b_1_z*t332 + D_p_y_2_by_b_1_z*t418
        - D_p_z_2_by_b_1_z*t333 - D_p_z_2_by_b_1_z*t334 - D_p_z_2_by_b_1_z*t335 + D_p_z_2_by_b_1_z*t419
        + mu_1_by_b_1_z*t357 + mu_2_by_b_1_z*t358 + mu_3_by_b_1_z*t357,
        D_p_x_2_by_b_1_z*k_C, D_p_y_2_by_b_1_z*k_C, D_p_z_2_by_b_1_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_z*k_C
        + mu_1_by_b_1_z*t362 + mu_2_by_b_1_z*t362 + mu_3_by_b_1_z*t363 - t284*t439 - t285*t439 - t286*t439
        - t287*t440 - t288*t440 - t289*t440 - t290*t441 - t291*t441 - t292*t441,
        D_delta_x_1_by_b_1_z*t369 + D_delta_y_1_by_b_1_z*t370 + D_delta_z_1_by_b_1_z*t371
        - D_p_x_3_by_b_1_z*t302 - D_p_x_3_by_b_1_z*t303 - D_p_x_3_by_b_1_z*t304 + D_p_x_3_by_b_1_z*t411
        - D_p_y_3_by_b_1_z*t305 - D_p_y_3_by_b_1_z*t306 - D_p_y_3_by_b_1_z*t307 + D_p_y_3_by_b_1_z*t412
        - D_p_z_3_by_b_1_z*t308 - D_p_z_3_by_b_1_z*t309 - D_p_z_3_by_b_1_z*t310 + D_p_z_3_by_b_1_z*t413
        + mu_1_by_b_1_z*t367 + mu_2_by_b_1_z*t367 + mu_3_by_b_1_z*t368,
        D_delta_x_2_by_b_1_z*t369 + D_delta_y_2_by_b_1_z*t370 + D_delta_z_2_by_b_1_z*t371
        - D_p_x_3_by_b_1_z*t316 - D_p_x_3_by_b_1_z*t317 - D_p_x_3_by_b_1_z*t318 + D_p_x_3_by_b_1_z*t414
        - D_p_y_3_by_b_1_z*t319 - D_p_y_3_by_b_1_z*t320 - D_p_y_3_by_b_1_z*t321 + D_p_y_3_by_b_1_z*t415
        - D_p_z_3_by_b_1_z*t322 - D_p_z_3_by_b_1_z*t323 - D_p_z_3_by_b_1_z*t324 + D_p_z_3_by_b_1_z*t416
        + mu_1_by_b_1_z*t372 + mu_2_by_b_1_z*t372 + mu_3_by_b_1_z*t373,
        D_delta_x_3_by_b_1_z*t369 + D_delta_y_3_by_b_1_z*t370 + D_delta_z_3_by_b_1_z*t371
        - D_p_x_3_by_b_1_z*t327 - D_p_x_3_by_b_1_z*t328 - D_p_x_3_by_b_1_z*t329 + D_p_x_3_by_b_1_z*t417
        - D_p_y_3_by_b_1_z*t330 - D_p_y_3_by_b_1_z*t331 - D_p_y_3_by_b_1_z*t332 + D_p_y_3_by_b_1_z*t418
        - D_p_z_3_by_b_1_z*t333 - D_p_z_3_by_b_1_z*t334 - D_p_z_3_by_b_1_z*t335 + D_p_z_3_by_b_1_z*t419
        + mu_1_by_b_1_z*t374 + mu_2_by_b_1_z*t374 + mu_3_by_b_1_z*t375,
        D_p_x_3_by_b_1_z*k_C, D_p_y_3_by_b_1_z*k_C, D_p_z_3_by_b_1_z*k_C, t185*t432, t433, -t185*t431, t434,
        D_delta_x_1_by_b_1_z*t377 + D_delta_y_1_by_b_1_z*t378 + D_delta_z_1_by_b_1_z*t379
        + mu_1_by_b_1_z*t380 - mu_2_by_b_1_z*t376 - mu_3_by_b_1_z*t376,
        D_delta_x_1_by_b_1_z*t382 + D_delta_x_2_by_b_1_z*t383 + D_delta_y_1_by_b_1_z*t384
        + D_delta_y_2_by_b_1_z*t385 + D_delta_z_1_by_b_1_z*t386 + D_delta_z_2_by_b_1_z*t387
        + mu_1_by_b_1_z*t381 + mu_2_by_b_1_z*t381 + mu_3_by_b_1_z*t381,
        D_delta_x_1_by_b_1_z*t389 + D_delta_x_3_by_b_1_z*t383 + D_delta_y_1_by_b_1_z*t390
        + D_delta_y_3_by_b_1_z*t385 + D_delta_z_1_by_b_1_z*t391 + D_delta_z_3_by_b_1_z*t387
        + mu_1_by_b_1_z*t388 + mu_2_by_b_1_z*t388 + mu_3_by_b_1_z*t388,
        D_delta_x_1_by_b_1_z*k_C, D_delta_y_1_by_b_1_z*k_C, D_delta_z_1_by_b_1_z*k_C,
        D_delta_x_2_by_b_1_z*t393 + D_delta_y_2_by_b_1_z*t394 + D_delta_z_2_by_b_1_z*t395
        - mu_1_by_b_1_z*t392 + mu_2_by_b_1_z*t396 - mu_3_by_b_1_z*t392,
        D_delta_x_2_by_b_1_z*t389 + D_delta_x_3_by_b_1_z*t382 + D_delta_y_2_by_b_1_z*t390
        + D_delta_y_3_by_b_1_z*t384 + D_delta_z_2_by_b_1_z*t391 + D_delta_z_3_by_b_1_z*t386
        + mu_1_by_b_1_z*t397 + mu_2_by_b_1_z*t397 + mu_3_by_b_1_z*t397,
        D_delta_x_2_by_b_1_z*k_C, D_delta_y_2_by_b_1_z*k_C, D_delta_z_2_by_b_1_z*k_C,
        D_delta_x_3_by_b_1_z*t399 + D_delta_y_3_by_b_1_z*t400 + D_delta_z_3_by_b_1_z*t401
        - mu_1_by_b_1_z*t398 - mu_2_by_b_1_z*t398 + mu_3_by_b_1_z*t402,
        D_delta_x_3_by_b_1_z*k_C, D_delta_y_3_by_b_1_z*k_C, D_delta_z_3_by_b_1_z*k_C, t435,
        2*D_p_x_1*D_p_x_1_by_b_2_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_x*k_C
        + mu_1_by_b_2_x*t260 + mu_2_by_b_2_x*t261 + mu_3_by_b_2_x*t261 - t248*t442 - t250*t442 - t251*t442
        - t252*t443 - t254*t443 - t255*t443 - t256*t444 - t258*t444 - t259*t444,
        D_p_x_1*D_p_x_2_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_2*k_C - D_p_x_1_by_b_2_x*t272
        - D_p_x_1_by_b_2_x*t273 - D_p_x_1_by_b_2_x*t274 - D_p_x_2_by_b_2_x*t248 - D_p_x_2_by_b_2_x*t250
        - D_p_x_2_by_b_2_x*t251 + D_p_y_1*D_p_y_2_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_2*k_C
        - D_p_y_1_by_b_2_x*t275 - D_p_y_1_by_b_2_x*t276 - D_p_y_1_by_b_2_x*t277 - D_p_y_2_by_b_2_x*t252
        - D_p_y_2_by_b_2_x*t254 - D_p_y_2_by_b_2_x*t255 + D_p_z_1*D_p_z_2_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_2*k_C - D_p_z_1_by_b_2_x*t278 - D_p_z_1_by_b_2_x*t279
        - D_p_z_1_by_b_2_x*t280 - D_p_z_2_by_b_2_x*t256 - D_p_z_2_by_b_2_x*t258 - D_p_z_2_by_b_2_x*t259
        + mu_1_by_b_2_x*t281 + mu_2_by_b_2_x*t282 + mu_3_by_b_2_x*t283,
        D_p_x_1*D_p_x_3_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_3*k_C - D_p_x_1_by_b_2_x*t284
        - D_p_x_1_by_b_2_x*t285 - D_p_x_1_by_b_2_x*t286 - D_p_x_3_by_b_2_x*t248 - D_p_x_3_by_b_2_x*t250
        - D_p_x_3_by_b_2_x*t251 + D_p_y_1*D_p_y_3_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_3*k_C
        - D_p_y_1_by_b_2_x*t287 - D_p_y_1_by_b_2_x*t288 - D_p_y_1_by_b_2_x*t289 - D_p_y_3_by_b_2_x*t252
        - D_p_y_3_by_b_2_x*t254 - D_p_y_3_by_b_2_x*t255 + D_p_z_1*D_p_z_3_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_3*k_C - D_p_z_1_by_b_2_x*t290 - D_p_z_1_by_b_2_x*t291
        - D_p_z_1_by_b_2_x*t292 - D_p_z_3_by_b_2_x*t256 - D_p_z_3_by_b_2_x*t258 - D_p_z_3_by_b_2_x*t259
        + mu_1_by_b_2_x*t293 + mu_2_by_b_2_x*t294 + mu_3_by_b_2_x*t295,
        D_delta_x_1_by_b_2_x*t313 + D_delta_y_1_by_b_2_x*t314 + D_delta_z_1_by_b_2_x*t315
        - D_p_x_1_by_b_2_x*t302 - D_p_x_1_by_b_2_x*t303 - D_p_x_1_by_b_2_x*t304 + D_p_x_1_by_b_2_x*t411
        - D_p_y_1_by_b_2_x*t305 - D_p_y_1_by_b_2_x*t306 - D_p_y_1_by_b_2_x*t307 + D_p_y_1_by_b_2_x*t412
        - D_p_z_1_by_b_2_x*t308 - D_p_z_1_by_b_2_x*t309 - D_p_z_1_by_b_2_x*t310 + D_p_z_1_by_b_2_x*t413
        + mu_1_by_b_2_x*t311 + mu_2_by_b_2_x*t312 + mu_3_by_b_2_x*t312,
        D_delta_x_2_by_b_2_x*t313 + D_delta_y_2_by_b_2_x*t314 + D_delta_z_2_by_b_2_x*t315
        - D_p_x_1_by_b_2_x*t316 - D_p_x_1_by_b_2_x*t317 - D_p_x_1_by_b_2_x*t318 + D_p_x_1_by_b_2_x*t414
        - D_p_y_1_by_b_2_x*t319 - D_p_y_1_by_b_2_x*t320 - D_p_y_1_by_b_2_x*t321 + D_p_y_1_by_b_2_x*t415
        - D_p_z_1_by_b_2_x*t322 - D_p_z_1_by_b_2_x*t323 - D_p_z_1_by_b_2_x*t324 + D_p_z_1_by_b_2_x*t416
        + mu_1_by_b_2_x*t325 + mu_2_by_b_2_x*t326 + mu_3_by_b_2_x*t326,
        D_delta_x_3_by_b_2_x*t313 + D_delta_y_3_by_b_2_x*t314 + D_delta_z_3_by_b_2_x*t315
        - D_p_x_1_by_b_2_x*t327 - D_p_x_1_by_b_2_x*t328 - D_p_x_1_by_b_2_x*t329 + D_p_x_1_by_b_2_x*t417
        - D_p_y_1_by_b_2_x*t330 - D_p_y_1_by_b_2_x*t331 - D_p_y_1_by_b_2_x*t332 + D_p_y_1_by_b_2_x*t418
        - D_p_z_1_by_b_2_x*t333 - D_p_z_1_by_b_2_x*t334 - D_p_z_1_by_b_2_x*t335 + D_p_z_1_by_b_2_x*t419
        + mu_1_by_b_2_x*t336 + mu_2_by_b_2_x*t337 + mu_3_by_b_2_x*t337,
        D_p_x_1_by_b_2_x*k_C, D_p_y_1_by_b_2_x*k_C, D_p_z_1_by_b_2_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_x*k_C
        + k_sp_2*t262*t448*t455*w_b_2*x_2_by_b_2_x + mu_1_by_b_2_x*t342 + mu_2_by_b_2_x*t343
        + mu_3_by_b_2_x*t342 - t272*t445 - t273*t445 - t274*t445 - t275*t446 - t276*t446 - t277*t446
        - t278*t447 - t279*t447 - t280*t447 - t454,
        D_p_x_2*D_p_x_3_by_b_2_x*k_C + D_p_x_2_by_b_2_x*D_p_x_3*k_C - D_p_x_2_by_b_2_x*t284
        - D_p_x_2_by_b_2_x*t285 - D_p_x_2_by_b_2_x*t286 - D_p_x_3_by_b_2_x*t272 - D_p_x_3_by_b_2_x*t273
        - D_p_x_3_by_b_2_x*t274 + D_p_y_2*D_p_y_3_by_b_2_x*k_C + D_p_y_2_by_b_2_x*D_p_y_3*k_C
        - D_p_y_2_by_b_2_x*t287 - D_p_y_2_by_b_2_x*t288 - D_p_y_2_by_b_2_x*t289 - D_p_y_3_by_b_2_x*t275
        - D_p_y_3_by_b_2_x*t276 - D_p_y_3_by_b_2_x*t277 + D_p_z_2*D_p_z_3_by_b_2_x*k_C
        + D_p_z_2_by_b_2_x*D_p_z_3*k_C - D_p_z_2_by_b_2_x*t290 - D_p_z_2_by_b_2_x*t291
        - D_p_z_2_by_b_2_x*t292 - D_p_z_3_by_b_2_x*t278 - D_p_z_3_by_b_2_x*t279 - D_p_z_3_by_b_2_x*t280
        + mu_1_by_b_2_x*t344 + mu_2_by_b_2_x*t345 + mu_3_by_b_2_x*t346,
        t457, t458,
        D_delta_x_1_by_b_2_x*t352 + D_delta_y_1_by_b_2_x*t353 + D_delta_z_1_by_b_2_x*t354
        - D_p_x_2_by_b_2_x*t302 - D_p_x_2_by_b_2_x*t303 - D_p_x_2_by_b_2_x*t304 + D_p_x_2_by_b_2_x*t411
        - D_p_y_2_by_b_2_x*t305 - D_p_y_2_by_b_2_x*t306 - D_p_y_2_by_b_2_x*t307 + D_p_y_2_by_b_2_x*t412
        - D_p_z_2_by_b_2_x*t308 - D_p_z_2_by_b_2_x*t309 - D_p_z_2_by_b_2_x*t310 + D_p_z_2_by_b_2_x*t413
        + mu_1_by_b_2_x*t350 + mu_2_by_b_2_x*t351 + mu_3_by_b_2_x*t350,
        D_delta_x_2_by_b_2_x*t352 + D_delta_y_2_by_b_2_x*t353 + D_delta_z_2_by_b_2_x*t354
        - D_p_x_2_by_b_2_x*t316 - D_p_x_2_by_b_2_x*t317 - D_p_x_2_by_b_2_x*t318 + D_p_x_2_by_b_2_x*t414
        - D_p_y_2_by_b_2_x*t319 - D_p_y_2_by_b_2_x*t320 - D_p_y_2_by_b_2_x*t321 + D_p_y_2_by_b_2_x*t415
        - D_p_z_2_by_b_2_x*t322 - D_p_z_2_by_b_2_x*t323 - D_p_z_2_by_b_2_x*t324 + D_p_z_2_by_b_2_x*t416
        + mu_1_by_b_2_x*t355 + mu_2_by_b_2_x*t356 + mu_3_by_b_2_x*t355,
        D_delta_x_3_by_b_2_x*t352 + D_delta_y_3_by_b_2_x*t353 + D_delta_z_3_by_b_2_x*t354
        - D_p_x_2_by_b_2_x*t327 - D_p_x_2_by_b_2_x*t328 - D_p_x_2_by_b_2_x*t329 + D_p_x_2_by_b_2_x*t417
        - D_p_y_2_by_b_2_x*t330 - D_p_y_2_by_b_2_x*t331 - D_p_y_2_by_b_2_x*t332 + D_p_y_2_by_b_2_x*t418
        - D_p_z_2_by_b_2_x*t333 - D_p_z_2_by_b_2_x*t334 - D_p_z_2_by_b_2_x*t335 + D_p_z_2_by_b_2_x*t419
        + mu_1_by_b_2_x*t357 + mu_2_by_b_2_x*t358 + mu_3_by_b_2_x*t357,
        t459, D_p_x_2_by_b_2_x*k_C, D_p_y_2_by_b_2_x*k_C, D_p_z_2_by_b_2_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_x*k_C
        + mu_1_by_b_2_x*t362 + mu_2_by_b_2_x*t362 + mu_3_by_b_2_x*t363 - t284*t460 - t285*t460 - t286*t460
        - t287*t461 - t288*t461 - t289*t461 - t290*t462 - t291*t462 - t292*t462,
        D_delta_x_1_by_b_2_x*t369 + D_delta_y_1_by_b_2_x*t370 + D_delta_z_1_by_b_2_x*t371
        - D_p_x_3_by_b_2_x*t302 - D_p_x_3_by_b_2_x*t303 - D_p_x_3_by_b_2_x*t304 + D_p_x_3_by_b_2_x*t411
        - D_p_y_3_by_b_2_x*t305 - D_p_y_3_by_b_2_x*t306 - D_p_y_3_by_b_2_x*t307 + D_p_y_3_by_b_2_x*t412
        - D_p_z_3_by_b_2_x*t308 - D_p_z_3_by_b_2_x*t309 - D_p_z_3_by_b_2_x*t310 + D_p_z_3_by_b_2_x*t413
        + mu_1_by_b_2_x*t367 + mu_2_by_b_2_x*t367 + mu_3_by_b_2_x*t368,
        D_delta_x_2_by_b_2_x*t369 + D_delta_y_2_by_b_2_x*t370 + D_delta_z_2_by_b_2_x*t371
        - D_p_x_3_by_b_2_x*t316 - D_p_x_3_by_b_2_x*t317 - D_p_x_3_by_b_2_x*t318 + D_p_x_3_by_b_2_x*t414
        - D_p_y_3_by_b_2_x*t319 - D_p_y_3_by_b_2_x*t320 - D_p_y_3_by_b_2_x*t321 + D_p_y_3_by_b_2_x*t415
        - D_p_z_3_by_b_2_x*t322 - D_p_z_3_by_b_2_x*t323 - D_p_z_3_by_b_2_x*t324 + D_p_z_3_by_b_2_x*t416
        + mu_1_by_b_2_x*t372 + mu_2_by_b_2_x*t372 + mu_3_by_b_2_x*t373,
        D_delta_x_3_by_b_2_x*t369 + D_delta_y_3_by_b_2_x*t370 + D_delta_z_3_by_b_2_x*t371
        - D_p_x_3_by_b_2_x*t327 - D_p_x_3_by_b_2_x*t328 - D_p_x_3_by_b_2_x*t329 + D_p_x_3_by_b_2_x*t417
        - D_p_y_3_by_b_2_x*t330 - D_p_y_3_by_b_2_x*t331 - D_p_y_3_by_b_2_x*t332 + D_p_y_3_by_b_2_x*t418
        - D_p_z_3_by_b_2_x*t333 - D_p_z_3_by_b_2_x*t334 - D_p_z_3_by_b_2_x*t335 + D_p_z_3_by_b_2_x*t419
        + mu_1_by_b_2_x*t374 + mu_2_by_b_2_x*t374 + mu_3_by_b_2_x*t375,
        D_p_x_3_by_b_2_x*k_C, D_p_y_3_by_b_2_x*k_C, D_p_z_3_by_b_2_x*k_C, t218*t456, t457, -t218*t454, t458,
        D_delta_x_1_by_b_2_x*t377 + D_delta_y_1_by_b_2_x*t378 + D_delta_z_1_by_b_2_x*t379
        + mu_1_by_b_2_x*t380 - mu_2_by_b_2_x*t376 - mu_3_by_b_2_x*t376,
        D_delta_x_1_by_b_2_x*t382 + D_delta_x_2_by_b_2_x*t383 + D_delta_y_1_by_b_2_x*t384
        + D_delta_y_2_by_b_2_x*t385 + D_delta_z_1_by_b_2_x*t386 + D_delta_z_2_by_b_2_x*t387
        + mu_1_by_b_2_x*t381 + mu_2_by_b_2_x*t381 + mu_3_by_b_2_x*t381,
        D_delta_x_1_by_b_2_x*t389 + D_delta_x_3_by_b_2_x*t383 + D_delta_y_1_by_b_2_x*t390
        + D_delta_y_3_by_b_2_x*t385 + D_delta_z_1_by_b_2_x*t391 + D_delta_z_3_by_b_2_x*t387
        + mu_1_by_b_2_x*t388 + mu_2_by_b_2_x*t388 + mu_3_by_b_2_x*t388,
        D_delta_x_1_by_b_2_x*k_C, D_delta_y_1_by_b_2_x*k_C, D_delta_z_1_by_b_2_x*k_C,
        D_delta_x_2_by_b_2_x*t393 + D_delta_y_2_by_b_2_x*t394 + D_delta_z_2_by_b_2_x*t395
        - mu_1_by_b_2_x*t392 + mu_2_by_b_2_x*t396 - mu_3_by_b_2_x*t392,
        D_delta_x_2_by_b_2_x*t389 + D_delta_x_3_by_b_2_x*t382 + D_delta_y_2_by_b_2_x*t390
        + D_delta_y_3_by_b_2_x*t384 + D_delta_z_2_by_b_2_x*t391 + D_delta_z_3_by_b_2_x*t386
        + mu_1_by_b_2_x*t397 + mu_2_by_b_2_x*t397 + mu_3_by_b_2_x*t397,
        D_delta_x_2_by_b_2_x*k_C, D_delta_y_2_by_b_2_x*k_C, D_delta_z_2_by_b_2_x*k_C,
        D_delta_x_3_by_b_2_x*t399 + D_delta_y_3_by_b_2_x*t400 + D_delta_z_3_by_b_2_x*t401
        - mu_1_by_b_2_x*t398 - mu_2_by_b_2_x*t398 + mu_3_by_b_2_x*t402,
        D_delta_x_3_by_b_2_x*k_C, D_delta_y_3_by_b_2_x*k_C, D_delta_z_3_by_b_2_x*k_C, t459,
        2*D_p_x_1*D_p_x_1_by_b_2_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_y*k_C
        + mu_1_by_b_2_y*t260 + mu_2_by_b_2_y*t261 + mu_3_by_b_2_y*t261 - t248*t463 - t250*t463 - t251*t463
        - t252*t464 - t254*t464 - t255*t464 - t256*t465 - t258*t465 - t259*t465,
        D_p_x_1*D_p_x_2_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_2*k_C - D_p_x_1_by_b_2_y*t272
        - D_p_x_1_by_b_2_y*t273 - D_p_x_1_by_b_2_y*t274 - D_p_x_2_by_b_2_y*t248 - D_p_x_2_by_b_2_y*t250
        - D_p_x_2_by_b_2_y*t251 + D_p_y_1*D_p_y_2_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_2*k_C
        - D_p_y_1_by_b_2_y*t275 - D_p_y_1_by_b_2_y*t276 - D_p_y_1_by_b_2_y*t277 - D_p_y_2_by_b_2_y*t252
        - D_p_y_2_by_b_2_y*t254 - D_p_y_2_by_b_2_y*t255 + D_p_z_1*D_p_z_2_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_2*k_C - D_p_z_1_by_b_2_y*t278 - D_p_z_1_by_b_2_y*t279
        - D_p_z_1_by_b_2_y*t280 - D_p_z_2_by_b_2_y*t256 - D_p_z_2_by_b_2_y*t258 - D_p_z_2_by_b_2_y*t259
        + mu_1_by_b_2_y*t281 + mu_2_by_b_2_y*t282 + mu_3_by_b_2_y*t283,
        D_p_x_1*D_p_x_3_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_3*k_C - D_p_x_1_by_b_2_y*t284
        - D_p_x_1_by_b_2_y*t285 - D_p_x_1_by_b_2_y*t286 - D_p_x_3_by_b_2_y*t248 - D_p_x_3_by_b_2_y*t250
        - D_p_x_3_by_b_2_y*t251 + D_p_y_1*D_p_y_3_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_3*k_C
        - D_p_y_1_by_b_2_y*t287 - D_p_y_1_by_b_2_y*t288 - D_p_y_1_by_b_2_y*t289 - D_p_y_3_by_b_2_y*t252
        - D_p_y_3_by_b_2_y*t254 - D_p_y_3_by_b_2_y*t255 + D_p_z_1*D_p_z_3_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_3*k_C - D_p_z_1_by_b_2_y*t290 - D_p_z_1_by_b_2_y*t291
        - D_p_z_1_by_b_2_y*t292 - D_p_z_3_by_b_2_y*t256 - D_p_z_3_by_b_2_y*t258 - D_p_z_3_by_b_2_y*t259
        + mu_1_by_b_2_y*t293 + mu_2_by_b_2_y*t294 + mu_3_by_b_2_y*t295,
        D_delta_x_1_by_b_2_y*t313 + D_delta_y_1_by_b_2_y*t314 + D_delta_z_1_by_b_2_y*t315
        - D_p_x_1_by_b_2_y*t302 - D_p_x_1_by_b_2_y*t303 - D_p_x_1_by_b_2_y*t304 + D_p_x_1_by_b_2_y*t411
        - D_p_y_1_by_b_2_y*t305 - D_p_y_1_by_b_2_y*t306 - D_p_y_1_by_b_2_y*t307 + D_p_y_1_by_b_2_y*t412
        - D_p_z_1_by_b_2_y*t308 - D_p_z_1_by_b_2_y*t309 - D_p_z_1_by_b_2_y*t310 + D_p_z_1_by_b_2_y*t413
        + mu_1_by_b_2_y*t311 + mu_2_by_b_2_y*t312 + mu_3_by_b_2_y*t312,
        D_delta_x_2_by_b_2_y*t313 + D_delta_y_2_by_b_2_y*t314 + D_delta_z_2_by_b_2_y*t315
        - D_p_x_1_by_b_2_y*t316 - D_p_x_1_by_b_2_y*t317 - D_p_x_1_by_b_2_y*t318 + D_p_x_1_by_b_2_y*t414
        - D_p_y_1_by_b_2_y*t319 - D_p_y_1_by_b_2_y*t320 - D_p_y_1_by_b_2_y*t321 + D_p_y_1_by_b_2_y*t415
        - D_p_z_1_by_b_2_y*t322 - D_p_z_1_by_b_2_y*t323 - D_p_z_1_by_b_2_y*t324 + D_p_z_1_by_b_2_y*t416
        + mu_1_by_b_2_y*t325 + mu_2_by_b_2_y*t326 + mu_3_by_b_2_y*t326,
        D_delta_x_3_by_b_2_y*t313 + D_delta_y_3_by_b_2_y*t314 + D_delta_z_3_by_b_2_y*t315
        - D_p_x_1_by_b_2_y*t327 - D_p_x_1_by_b_2_y*t328 - D_p_x_1_by_b_2_y*t329 + D_p_x_1_by_b_2_y*t417
        - D_p_y_1_by_b_2_y*t330 - D_p_y_1_by_b_2_y*t331 - D_p_y_1_by_b_2_y*t332 + D_p_y_1_by_b_2_y*t418
        - D_p_z_1_by_b_2_y*t333 - D_p_z_1_by_b_2_y*t334 - D_p_z_1_by_b_2_y*t335 + D_p_z_1_by_b_2_y*t419
        + mu_1_by_b_2_y*t336 + mu_2_by_b_2_y*t337 + mu_3_by_b_2_y*t337,
        D_p_x_1_by_b_2_y*k_C, D_p_y_1_by_b_2_y*k_C, D_p_z_1_by_b_2_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_y*k_C
        + k_sp_2*t262*t448*t455*w_b_2*x_2_by_b_2_y + mu_1_by_b_2_y*t342 + mu_2_by_b_2_y*t343
        + mu_3_by_b_2_y*t342 - t272*t466 - t273*t466 - t274*t466 - t275*t467 - t276*t467 - t277*t467
        - t278*t468 - t279*t468 - t280*t468 - t470,
        D_p_x_2*D_p_x_3_by_b_2_y*k_C + D_p_x_2_by_b_2_y*D_p_x_3*k_C - D_p_x_2_by_b_2_y*t284
        - D_p_x_2_by_b_2_y*t285 - D_p_x_2_by_b_2_y*t286 - D_p_x_3_by_b_2_y*t272 - D_p_x_3_by_b_2_y*t273
        - D_p_x_3_by_b_2_y*t274 + D_p_y_2*D_p_y_3_by_b_2_y*k_C + D_p_y_2_by_b_2_y*D_p_y_3*k_C
        - D_p_y_2_by_b_2_y*t287 - D_p_y_2_by_b_2_y*t288 - D_p_y_2_by_b_2_y*t289 - D_p_y_3_by_b_2_y*t275
        - D_p_y_3_by_b_2_y*t276 - D_p_y_3_by_b_2_y*t277 + D_p_z_2*D_p_z_3_by_b_2_y*k_C
        + D_p_z_2_by_b_2_y*D_p_z_3*k_C - D_p_z_2_by_b_2_y*t290 - D_p_z_2_by_b_2_y*t291
        - D_p_z_2_by_b_2_y*t292 - D_p_z_3_by_b_2_y*t278 - D_p_z_3_by_b_2_y*t279 - D_p_z_3_by_b_2_y*t280
        + mu_1_by_b_2_y*t344 + mu_2_by_b_2_y*t345 + mu_3_by_b_2_y*t346,
        t472, t473,
        D_delta_x_1_by_b_2_y*t352 + D_delta_y_1_by_b_2_y*t353 + D_delta_z_1_by_b_2_y*t354
        - D_p_x_2_by_b_2_y*t302 - D_p_x_2_by_b_2_y*t303 - D_p_x_2_by_b_2_y*t304 + D_p_x_2_by_b_2_y*t411
        - D_p_y_2_by_b_2_y*t305 - D_p_y_2_by_b_2_y*t306 - D_p_y_2_by_b_2_y*t307 + D_p_y_2_by_b_2_y*t412
        - D_p_z_2_by_b_2_y*t308 - D_p_z_2_by_b_2_y*t309 - D_p_z_2_by_b_2_y*t310 + D_p_z_2_by_b_2_y*t413
        + mu_1_by_b_2_y*t350 + mu_2_by_b_2_y*t351 + mu_3_by_b_2_y*t350,
        D_delta_x_2_by_b_2_y*t352 + D_delta_y_2_by_b_2_y*t353 + D_delta_z_2_by_b_2_y*t354
        - D_p_x_2_by_b_2_y*t316 - D_p_x_2_by_b_2_y*t317 - D_p_x_2_by_b_2_y*t318 + D_p_x_2_by_b_2_y*t414
        - D_p_y_2_by_b_2_y*t319 - D_p_y_2_by_b_2_y*t320 - D_p_y_2_by_b_2_y*t321 + D_p_y_2_by_b_2_y*t415
        - D_p_z_2_by_b_2_y*t322 - D_p_z_2_by_b_2_y*t323 - D_p_z_2_by_b_2_y*t324 + D_p_z_2_by_b_2_y*t416
        + mu_1_by_b_2_y*t355 + mu_2_by_b_2_y*t356 + mu_3_by_b_2_y*t355,
        D_delta_x_3_by_b_2_y*t352 + D_delta_y_3_by_b_2_y*t353 + D_delta_z_3_by_b_2_y*t354
        - D_p_x_2_by_b_2_y*t327 - D_p_x_2_by_b_2_y*t328 - D_p_x_2_by_b_2_y*t329 + D_p_x_2_by_b_2_y*t417
        - D_p_y_2_by_b_2_y*t330 - D_p_y_2_by_b_2_y*t331 - D_p_y_2_by_b_2_y*t332 + D_p_y_2_by_b_2_y*t418
        - D_p_z_2_by_b_2_y*t333 - D_p_z_2_by_b_2_y*t334 - D_p_z_2_by_b_2_y*t335 + D_p_z_2_by_b_2_y*t419
        + mu_1_by_b_2_y*t357 + mu_2_by_b_2_y*t358 + mu_3_by_b_2_y*t357,
        t474, D_p_x_2_by_b_2_y*k_C, D_p_y_2_by_b_2_y*k_C, D_p_z_2_by_b_2_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_y*k_C
        + mu_1_by_b_2_y*t362 + mu_2_by_b_2_y*t362 + mu_3_by_b_2_y*t363 - t284*t475 - t285*t475 - t286*t475
        - t287*t476 - t288*t476 - t289*t476 - t290*t477 - t291*t477 - t292*t477,
        D_delta_x_1_by_b_2_y*t369 + D_delta_y_1_by_b_2_y*t370 + D_delta_z_1_by_b_2_y*t371
        - D_p_x_3_by_b_2_y*t302 - D_p_x_3_by_b_2_y*t303 - D_p_x_3_by_b_2_y*t304 + D_p_x_3_by_b_2_y*t411
        - D_p_y_3_by_b_2_y*t305 - D_p_y_3_by_b_2_y*t306 - D_p_y_3_by_b_2_y*t307 + D_p_y_3_by_b_2_y*t412
        - D_p_z_3_by_b_2_y*t308 - D_p_z_3_by_b_2_y*t309 - D_p_z_3_by_b_2_y*t310 + D_p_z_3_by_b_2_y*t413
        + mu_1_by_b_2_y*t367 + mu_2_by_b_2_y*t367 + mu_3_by_b_2_y*t368,
        D_delta_x_2_by_b_2_y*t369 + D_delta_y_2_by_b_2_y*t370 + D_delta_z_2_by_b_2_y*t371
        - D_p_x_3_by_b_2_y*t316 - D_p_x_3_by_b_2_y*t317 - D_p_x_3_by_b_2_y*t318 + D_p_x_3_by_b_2_y*t414
        - D_p_y_3_by_b_2_y*t319 - D_p_y_3_by_b_2_y*t320 - D_p_y_3_by_b_2_y*t321 + D_p_y_3_by_b_2_y*t415
        - D_p_z_3_by_b_2_y*t322 - D_p_z_3_by_b_2_y*t323 - D_p_z_3_by_b_2_y*t324 + D_p_z_3_by_b_2_y*t416
        + mu_1_by_b_2_y*t372 + mu_2_by_b_2_y*t372 + mu_3_by_b_2_y*t373,
        D_delta_x_3_by_b_2_y*t369 + D_delta_y_3_by_b_2_y*t370 + D_delta_z_3_by_b_2_y*t371
        - D_p_x_3_by_b_2_y*t327 - D_p_x_3_by_b_2_y*t328 - D_p_x_3_by_b_2_y*t329 + D_p_x_3_by_b_2_y*t417
        - D_p_y_3_by_b_2_y*t330 - D_p_y_3_by_b_2_y*t331 - D_p_y_3_by_b_2_y*t332 + D_p_y_3_by_b_2_y*t418
        - D_p_z_3_by_b_2_y*t333 - D_p_z_3_by_b_2_y*t334 - D_p_z_3_by_b_2_y*t335 + D_p_z_3_by_b_2_y*t419
        + mu_1_by_b_2_y*t374 + mu_2_by_b_2_y*t374 + mu_3_by_b_2_y*t375,
        D_p_x_3_by_b_2_y*k_C, D_p_y_3_by_b_2_y*k_C, D_p_z_3_by_b_2_y*k_C, t218*t471, t472, -t218*t470, t473,
        D_delta_x_1_by_b_2_y*t377 + D_delta_y_1_by_b_2_y*t378 + D_delta_z_1_by_b_2_y*t379
        + mu_1_by_b_2_y*t380 - mu_2_by_b_2_y*t376 - mu_3_by_b_2_y*t376,
        D_delta_x_1_by_b_2_y*t382 + D_delta_x_2_by_b_2_y*t383 + D_delta_y_1_by_b_2_y*t384
        + D_delta_y_2_by_b_2_y*t385 + D_delta_z_1_by_b_2_y*t386 + D_delta_z_2_by_b_2_y*t387
        + mu_1_by_b_2_y*t381 + mu_2_by_b_2_y*t381 + mu_3_by_b_2_y*t381,
        D_delta_x_1_by_b_2_y*t389 + D_delta_x_3_by_b_2_y*t383 + D_delta_y_1_by_b_2_y*t390
        + D_delta_y_3_by_b_2_y*t385 + D_delta_z_1_by_b_2_y*t391 + D_delta_z_3_by_b_2_y*t387
        + mu_1_by_b_2_y*t388 + mu_2_by_b_2_y*t388 + mu_3_by_b_2_y*t388,
        D_delta_x_1_by_b_2_y*k_C, D_delta_y_1_by_b_2_y*k_C, D_delta_z_1_by_b_2_y*k_C,
        D_delta_x_2_by_b_2_y*t393 + D_delta_y_2_by_b_2_y*t394 + D_delta_z_2_by_b_2_y*t395
        - mu_1_by_b_2_y*t392 + mu_2_by_b_2_y*t396 - mu_3_by_b_2_y*t392,
        D_delta_x_2_by_b_2_y*t389 + D_delta_x_3_by_b_2_y*t382 + D_delta_y_2_by_b_2_y*t390
        + D_delta_y_3_by_b_2_y*t384 + D_delta_z_2_by_b_2_y*t391 + D_delta_z_3_by_b_2_y*t386
        + mu_1_by_b_2_y*t397 + mu_2_by_b_2_y*t397 + mu_3_by_b_2_y*t397,
        D_delta_x_2_by_b_2_y*k_C, D_delta_y_2_by_b_2_y*k_C, D_delta_z_2_by_b_2_y*k_C,
        D_delta_x_3_by_b_2_y*t399 + D_delta_y_3_by_b_2_y*t400 + D_delta_z_3_by_b_2_y*t401
        - mu_1_by_b_2_y*t398 - mu_2_by_b_2_y*t398 + mu_3_by_b_2_y*t402,
        D_delta_x_3_by_b_2_y*k_C, D_delta_y_3_by_b_2_y*k_C, D_delta_z_3_by_b_2_y*k_C, t474,
        2*D_p_x_1*D_p_x_1_by_b_2_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_z*k_C
        + mu_1_by_b_2_z*t260 + mu_2_by_b_2_z*t261 + mu_3_by_b_2_z*t261 - t248*t478 - t250*t478 - t251*t478
        - t252*t479 - t254*t479 - t255*t479 - t256*t480 - t258*t480 - t259*t480,
        D_p_x_1*D_p_x_2_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_2*k_C - D_p_x_1_by_b_2_z*t272
        - D_p_x_1_by_b_2_z*t273 - D_p_x_1_by_b_2_z*t274 - D_p_x_2_by_b_2_z*t248 - D_p_x_2_by_b_2_z*t250
        - D_p_x_2_by_b_2_z*t251 + D_p_y_1*D_p_y_2_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_2*k_C
        - D_p_y_1_by_b_2_z*t275 - D_p_y_1_by_b_2_z*t276 - D_p_y_1_by_b_2_z*t277 - D_p_y_2_by_b_2_z*t252
        - D_p_y_2_by_b_2_z*t254 - D_p_y_2_by_b_2_z*t255 + D_p_z_1*D_p_z_2_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_2*k_C - D_p_z_1_by_b_2_z*t278 - D_p_z_1_by_b_2_z*t279
        - D_p_z_1_by_b_2_z*t280 - D_p_z_2_by_b_2_z*t256 - D_p_z_2_by_b_2_z*t258 - D_p_z_2_by_b_2_z*t259
        + mu_1_by_b_2_z*t281 + mu_2_by_b_2_z*t282 + mu_3_by_b_2_z*t283,
        D_p_x_1*D_p_x_3_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_3*k_C - D_p_x_1_by_b_2_z*t284
        - D_p_x_1_by_b_2_z*t285 - D_p_x_1_by_b_2_z*t286 - D_p_x_3_by_b_2_z*t248 - D_p_x_3_by_b_2_z*t250
        - D_p_x_3_by_b_2_z*t251 + D_p_y_1*D_p_y_3_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_3*k_C
        - D_p_y_1_by_b_2_z*t287 - D_p_y_1_by_b_2_z*t288 - D_p_y_1_by_b_2_z*t289 - D_p_y_3_by_b_2_z*t252
        - D_p_y_3_by_b_2_z*t254 - D_p_y_3_by_b_2_z*t255 + D_p_z_1*D_p_z_3_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_3*k_C - D_p_z_1_by_b_2_z*t290 - D_p_z_1_by_b_2_z*t291
        - D_p_z_1_by_b_2_z*t292 - D_p_z_3_by_b_2_z*t256 - D_p_z_3_by_b_2_z*t258 - D_p_z_3_by_b_2_z*t259
        + mu_1_by_b_2_z*t293 + mu_2_by_b_2_z*t294 + mu_3_by_b_2_z*t295,
        D_delta_x_1_by_b_2_z*t313 + D_delta_y_1_by_b_2_z*t314 + D_delta_z_1_by_b_2_z*t315
        - D_p_x_1_by_b_2_z*t302 - D_p_x_1_by_b_2_z*t303 - D_p_x_1_by_b_2_z*t304 + D_p_x_1_by_b_2_z*t411
        - D_p_y_1_by_b_2_z*t305 - D_p_y_1_by_b_2_z*t306 - D_p_y_1_by_b_2_z*t307 + D_p_y_1_by_b_2_z*t412
        - D_p_z_1_by_b_2_z*t308 - D_p_z_1_by_b_2_z*t309 - D_p_z_1_by_b_2_z*t310 + D_p_z_1_by_b_2_z*t413
        + mu_1_by_b_2_z*t311 + mu_2_by_b_2_z*t312 + mu_3_by_b_2_z*t312,
        D_delta_x_2_by_b_2_z*t313 + D_delta_y_2_by_b_2_z*t314 + D_delta_z_2_by_b_2_z*t315
        - D_p_x_1_by_b_2_z*t316 - D_p_x_1_by_b_2_z*t317 - D_p_x_1_by_b_2_z*t318 + D_p_x_1_by_b_2_z*t414
        - D_p_y_1_by_b_2_z*t319 - D_p_y_1_by_b_2_z*t320 - D_p_y_1_by_b_2_z*t321 + D_p_y_1_by_b_2_z*t415
        - D_p_z_1_by_b_2_z*t322 - D_p_z_1_by_b_2_z*t323 - D_p_z_1_by_b_2_z*t324 + D_p_z_1_by_b_2_z*t416
        + mu_1_by_b_2_z*t325 + mu_2_by_b_2_z*t326 + mu_3_by_b_2_z*t326,
        D_delta_x_3_by_b_2_z*t313 + D_delta_y_3_by_b_2_z*t314 + D_delta_z_3_by_b_2_z*t315
        - D_p_x_1_by_b_2_z*t327 - D_p_x_1_by_b_2_z*t328 - D_p_x_1_by_b_2_z*t329 + D_p_x_1_by_b_2_z*t417
        - D_p_y_1_by_b_2_z*t330 - D_p_y_1_by_b_2_z*t331 - D_p_y_1_by_b_2_z*t332 + D_p_y_1_by_b_2_z*t418
        - D_p_z_1_by_b_2_z*t333 - D_p_z_1_by_b_2_z*t334 - D_p_z_1_by_b_2_z*t335 + D_p_z_1_by_b_2_z*t419
        + mu_1_by_b_2_z*t336 + mu_2_by_b_2_z*t337 + mu_3_by_b_2_z*t337,
        D_p_x_1_by_b_2_z*k_C, D_p_y_1_by_b_2_z*k_C, D_p_z_1_by_b_2_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_z*k_C
        + k_sp_2*t262*t448*t455*w_b_2*x_2_by_b_2_z + mu_1_by_b_2_z*t342 + mu_2_by_b_2_z*t343
        + mu_3_by_b_2_z*t342 - t272*t481 - t273*t481 - t274*t481 - t275*t482 - t276*t482 - t277*t482
        - t278*t483 - t279*t483 - t280*t483 - t485,
        D_p_x_2*D_p_x_3_by_b_2_z*k_C + D_p_x_2_by_b_2_z*D_p_x_3*k_C - D_p_x_2_by_b_2_z*t284
        - D_p_x_2_by_b_2_z*t285 - D_p_x_2_by_b_2_z*t286 - D_p_x_3_by_b_2_z*t272 - D_p_x_3_by_b_2_z*t273
        - D_p_x_3_by_b_2_z*t274 + D_p_y_2*D_p_y_3_by_b_2_z*k_C + D_p_y_2_by_b_2_z*D_p_y_3*k_C
        - D_p_y_2_by_b_2_z*t287 - D_p_y_2_by_b_2_z*t288 - D_p_y_2_by_b_2_z*t289 - D_p_y_3_by_b_2_z*t275
        - D_p_y_3_by_b_2_z*t276 - D_p_y_3_by_b_2_z*t277 + D_p_z_2*D_p_z_3_by_b_2_z*k_C
        + D_p_z_2_by_b_2_z*D_p_z_3*k_C - D_p_z_2_by_b_2_z*t290 - D_p_z_2_by_b_2_z*t291
        - D_p_z_2_by_b_2_z*t292 - D_p_z_3_by_b_2_z*t278 - D_p_z_3_by_b_2_z*t279 - D_p_z_3_by_b_2_z*t280
        + mu_1_by_b_2_z*t344 + mu_2_by_b_2_z*t345 + mu_3_by_b_2_z*t346,
        t487, t488,
        D_delta_x_1_by_b_2_z*t352 + D_delta_y_1_by_b_2_z*t353 + D_delta_z_1_by_b_2_z*t354
        - D_p_x_2_by_b_2_z*t302 - D_p_x_2_by_b_2_z*t303 - D_p_x_2_by_b_2_z*t304 + D_p_x_2_by_b_2_z*t411
        - D_p_y_2_by_b_2_z*t305 - D_p_y_2_by_b_2_z*t306 - D_p_y_2_by_b_2_z*t307 + D_p_y_2_by_b_2_z*t412
        - D_p_z_2_by_b_2_z*t308 - D_p_z_2_by_b_2_z*t309 - D_p_z_2_by_b_2_z*t310 + D_p_z_2_by_b_2_z*t413
        + mu_1_by_b_2_z*t350 + mu_2_by_b_2_z*t351 + mu_3_by_b_2_z*t350,
        D_delta_x_2_by_b_2_z*t352 + D_delta_y_2_by_b_2_z*t353 + D_delta_z_2_by_b_2_z*t354
        - D_p_x_2_by_b_2_z*t316 - D_p_x_2_by_b_2_z*t317 - D_p_x_2_by_b_2_z*t318 + D_p_x_2_by_b_2_z*t414
        - D_p_y_2_by_b_2_z*t319 - D_p_y_2_by_b_2_z*t320 - D_p_y_2_by_b_2_z*t321 + D_p_y_2_by_b_2_z*t415
        - D_p_z_2_by_b_2_z*t322 - D_p_z_2_by_b_2_z*t323 - D_p_z_2_by_b_2_z*t324 + D_p_z_2_by_b_2_z*t416
        + mu_1_by_b_2_z*t355 + mu_2_by_b_2_z*t356 + mu_3_by_b_2_z*t355,
        D_delta_x_3_by_b_2_z*t352 + D_delta_y_3_by_b_2_z*t353 + D_delta_z_3_by_b_2_z*t354
        - D_p_x_2_by_b_2_z*t327 - D_p_x_2_by_b_2_z*t328 - D_p_x_2_by_b_2_z*t329 + D_p_x_2_by_b_2_z*t417
        - D_p_y_2_by_b_2_z*t330 - D_p_y_2_by_b_2_z*t331 - D_p_y_2_by_b_2_z*t332 + D_p_y_2_by_b_2_z*t418
        - D_p_z_2_by_b_2_z*t333 - D_p_z_2_by_b_2_z*t334 - D_p_z_2_by_b_2_z*t335 + D_p_z_2_by_b_2_z*t419
        + mu_1_by_b_2_z*t357 + mu_2_by_b_2_z*t358 + mu_3_by_b_2_z*t357,
        t489, D_p_x_2_by_b_2_z*k_C, D_p_y_2_by_b_2_z*k_C, D_p_z_2_by_b_2_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_z*k_C
        + mu_1_by_b_2_z*t362 + mu_2_by_b_2_z*t362 + mu_3_by_b_2_z*t363 - t284*t490 - t285*t490 - t286*t490
        - t287*t491 - t288*t491 - t289*t491 - t290*t492 - t291*t492 - t292*t492,
        D_delta_x_1_by_b_2_z*t369 + D_delta_y_1_by_b_2_z*t370 + D_delta_z_1_by_b_2_z*t371
        - D_p_x_3_by_b_2_z*t302 - D_p_x_3_by_b_2_z*t303 - D_p_x_3_by_b_2_z*t304 + D_p_x_3_by_b_2_z*t411
        - D_p_y_3_by_b_2_z*t305 - D_p_y_3_by_b_2_z*t306 - D_p_y_3_by_b_2_z*t307 + D_p_y_3_by_b_2_z*t412
        - D_p_z_3_by_b_2_z*t308 - D_p_z_3_by_b_2_z*t309 - D_p_z_3_by_b_2_z*t310 + D_p_z_3_by_b_2_z*t413
        + mu_1_by_b_2_z*t367 + mu_2_by_b_2_z*t367 + mu_3_by_b_2_z*t368,
        D_delta_x_2_by_b_2_z*t369 + D_delta_y_2_by_b_2_z*t370 + D_delta_z_2_by_b_2_z*t371
        - D_p_x_3_by_b_2_z*t316 - D_p_x_3_by_b_2_z*t317 - D_p_x_3_by_b_2_z*t318 + D_p_x_3_by_b_2_z*t414
        - D_p_y_3_by_b_2_z*t319 - D_p_y_3_by_b_2_z*t320 - D_p_y_3_by_b_2_z*t321 + D_p_y_3_by_b_2_z*t415
        - D_p_z_3_by_b_2_z*t322 - D_p_z_3_by_b_2_z*t323 - D_p_z_3_by_b_2_z*t324 + D_p_z_3_by_b_2_z*t416
        + mu_1_by_b_2_z*t372 + mu_2_by_b_2_z*t372 + mu_3_by_b_2_z*t373,
        D_delta_x_3_by_b_2_z*t369 + D_delta_y_3_by_b_2_z*t370 + D_delta_z_3_by_b_2_z*t371
        - D_p_x_3_by_b_2_z*t327 - D_p_x_3_by_b_2_z*t328 - D_p_x_3_by_b_2_z*t329 + D_p_x_3_by_b_2_z*t417
        - D_p_y_3_by_b_2_z*t330 - D_p_y_3_by_b_2_z*t331 - D_p_y_3_by_b_2_z*t332 + D_p_y_3_by_b_2_z*t418
        - D_p_z_3_by_b_2_z*t333 - D_p_z_3_by_b_2_z*t334 - D_p_z_3_by_b_2_z*t335 + D_p_z_3_by_b_2_z*t419
        + mu_1_by_b_2_z*t374 + mu_2_by_b_2_z*t374 + mu_3_by_b_2_z*t375,
        D_p_x_3_by_b_2_z*k_C, D_p_y_3_by_b_2_z*k_C, D_p_z_3_by_b_2_z*k_C, t218*t486, t487, -t218*t485, t488,
        D_delta_x_1_by_b_2_z*t377 + D_delta_y_1_by_b_2_z*t378 + D_delta_z_1_by_b_2_z*t379
        + mu_1_by_b_2_z*t380 - mu_2_by_b_2_z*t376 - mu_3_by_b_2_z*t376,
        D_delta_x_1_by_b_2_z*t382 + D_delta_x_2_by_b_2_z*t383 + D_delta_y_1_by_b_2_z*t384
        + D_delta_y_2_by_b_2_z*t385 + D_delta_z_1_by_b_2_z*t386 + D_delta_z_2_by_b_2_z*t387
        + mu_1_by_b_2_z*t381 + mu_2_by_b_2_z*t381 + mu_3_by_b_2_z*t381,
        D_delta_x_1_by_b_2_z*t389 + D_delta_x_3_by_b_2_z*t383 + D_delta_y_1_by_b_2_z*t390
        + D_delta_y_3_by_b_2_z*t385 + D_delta_z_1_by_b_2_z*t391 + D_delta_z_3_by_b_2_z*t387
        + mu_1_by_b_2_z*t388 + mu_2_by_b_2_z*t388 + mu_3_by_b_2_z*t388,
        D_delta_x_1_by_b_2_z*k_C, D_delta_y_1_by_b_2_z*k_C, D_delta_z_1_by_b_2_z*k_C,
        D_delta_x_2_by_b_2_z*t393 + D_delta_y_2_by_b_2_z*t394 + D_delta_z_2_by_b_2_z*t395
        - mu_1_by_b_2_z*t392 + mu_2_by_b_2_z*t396 - mu_3_by_b_2_z*t392,
        D_delta_x_2_by_b_2_z*t389 + D_delta_x_3_by_b_2_z*t382 + D_delta_y_2_by_b_2_z*t390
        + D_delta_y_3_by_b_2_z*t384 + D_delta_z_2_by_b_2_z*t391 + D_delta_z_3_by_b_2_z*t386
        + mu_1_by_b_2_z*t397 + mu_2_by_b_2_z*t397 + mu_3_by_b_2_z*t397,
        D_delta_x_2_by_b_2_z*k_C, D_delta_y_2_by_b_2_z*k_C, D_delta_z_2_by_b_2_z*k_C,
        D_delta_x_3_by_b_2_z*t399 + D_delta_y_3_by_b_2_z*t400 + D_delta_z_3_by_b_2_z*t401
        - mu_1_by_b_2_z*t398 - mu_2_by_b_2_z*t398 + mu_3_by_b_2_z*t402,
        D_delta_x_3_by_b_2_z*k_C, D_delta_y_3_by_b_2_z*k_C, D_delta_z_3_by_b_2_z*k_C, t489,
        2*D_p_x_1*D_p_x_1_by_b_3_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_x*k_C
        + mu_1_by_b_3_x*t260 + mu_2_by_b_3_x*t261 + mu_3_by_b_3_x*t261 - t248*t493 - t250*t493 - t251*t493
        - t252*t494 - t254*t494 - t255*t494 - t256*t495 - t258*t495 - t259*t495,
        D_p_x_1*D_p_x_2_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_2*k_C - D_p_x_1_by_b_3_x*t272
        - D_p_x_1_by_b_3_x*t273 - D_p_x_1_by_b_3_x*t274 - D_p_x_2_by_b_3_x*t248 - D_p_x_2_by_b_3_x*t250
        - D_p_x_2_by_b_3_x*t251 + D_p_y_1*D_p_y_2_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_2*k_C
        - D_p_y_1_by_b_3_x*t275 - D_p_y_1_by_b_3_x*t276 - D_p_y_1_by_b_3_x*t277 - D_p_y_2_by_b_3_x*t252
        - D_p_y_2_by_b_3_x*t254 - D_p_y_2_by_b_3_x*t255 + D_p_z_1*D_p_z_2_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_2*k_C - D_p_z_1_by_b_3_x*t278 - D_p_z_1_by_b_3_x*t279
        - D_p_z_1_by_b_3_x*t280 - D_p_z_2_by_b_3_x*t256 - D_p_z_2_by_b_3_x*t258 - D_p_z_2_by_b_3_x*t259
        + mu_1_by_b_3_x*t281 + mu_2_by_b_3_x*t282 + mu_3_by_b_3_x*t283,
        D_p_x_1*D_p_x_3_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_3*k_C - D_p_x_1_by_b_3_x*t284
        - D_p_x_1_by_b_3_x*t285 - D_p_x_1_by_b_3_x*t286 - D_p_x_3_by_b_3_x*t248 - D_p_x_3_by_b_3_x*t250
        - D_p_x_3_by_b_3_x*t251 + D_p_y_1*D_p_y_3_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_3*k_C
        - D_p_y_1_by_b_3_x*t287 - D_p_y_1_by_b_3_x*t288 - D_p_y_1_by_b_3_x*t289 - D_p_y_3_by_b_3_x*t252
        - D_p_y_3_by_b_3_x*t254 - D_p_y_3_by_b_3_x*t255 + D_p_z_1*D_p_z_3_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_3*k_C - D_p_z_1_by_b_3_x*t290 - D_p_z_1_by_b_3_x*t291
        - D_p_z_1_by_b_3_x*t292 - D_p_z_3_by_b_3_x*t256 - D_p_z_3_by_b_3_x*t258 - D_p_z_3_by_b_3_x*t259
        + mu_1_by_b_3_x*t293 + mu_2_by_b_3_x*t294 + mu_3_by_b_3_x*t295,
        D_delta_x_1_by_b_3_x*t313 + D_delta_y_1_by_b_3_x*t314 + D_delta_z_1_by_b_3_x*t315
        - D_p_x_1_by_b_3_x*t302 - D_p_x_1_by_b_3_x*t303 - D_p_x_1_by_b_3_x*t304 + D_p_x_1_by_b_3_x*t411
        - D_p_y_1_by_b_3_x*t305 - D_p_y_1_by_b_3_x*t306 - D_p_y_1_by_b_3_x*t307 + D_p_y_1_by_b_3_x*t412
        - D_p_z_1_by_b_3_x*t308 - D_p_z_1_by_b_3_x*t309 - D_p_z_1_by_b_3_x*t310 + D_p_z_1_by_b_3_x*t413
        + mu_1_by_b_3_x*t311 + mu_2_by_b_3_x*t312 + mu_3_by_b_3_x*t312,
        D_delta_x_2_by_b_3_x*t313 + D_delta_y_2_by_b_3_x*t314 + D_delta_z_2_by_b_3_x*t315
        - D_p_x_1_by_b_3_x*t316 - D_p_x_1_by_b_3_x*t317 - D_p_x_1_by_b_3_x*t318 + D_p_x_1_by_b_3_x*t414
        - D_p_y_1_by_b_3_x*t319 - D_p_y_1_by_b_3_x*t320 - D_p_y_1_by_b_3_x*t321 + D_p_y_1_by_b_3_x*t415
        - D_p_z_1_by_b_3_x*t322 - D_p_z_1_by_b_3_x*t323 - D_p_z_1_by_b_3_x*t324 + D_p_z_1_by_b_3_x*t416
        + mu_1_by_b_3_x*t325 + mu_2_by_b_3_x*t326 + mu_3_by_b_3_x*t326,
        D_delta_x_3_by_b_3_x*t313 + D_delta_y_3_by_b_3_x*t314 + D_delta_z_3_by_b_3_x*t315
        - D_p_x_1_by_b_3_x*t327 - D_p_x_1_by_b_3_x*t328 - D_p_x_1_by_b_3_x*t329 + D_p_x_1_by_b_3_x*t417
        - D_p_y_1_by_b_3_x*t330 - D_p_y_1_by_b_3_x*t331 - D_p_y_1_by_b_3_x*t332 + D_p_y_1_by_b_3_x*t418
        - D_p_z_1_by_b_3_x*t333 - D_p_z_1_by_b_3_x*t334 - D_p_z_1_by_b_3_x*t335 + D_p_z_1_by_b_3_x*t419
        + mu_1_by_b_3_x*t336 + mu_2_by_b_3_x*t337 + mu_3_by_b_3_x*t337,
        D_p_x_1_by_b_3_x*k_C, D_p_y_1_by_b_3_x*k_C, D_p_z_1_by_b_3_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_x*k_C
        + mu_1_by_b_3_x*t342 + mu_2_by_b_3_x*t343 + mu_3_by_b_3_x*t342 - t272*t496 - t273*t496 - t274*t496
        - t275*t497 - t276*t497 - t277*t497 - t278*t498 - t279*t498 - t280*t498,
        D_p_x_2*D_p_x_3_by_b_3_x*k_C + D_p_x_2_by_b_3_x*D_p_x_3*k_C - D_p_x_2_by_b_3_x*t284
        - D_p_x_2_by_b_3_x*t285 - D_p_x_2_by_b_3_x*t286 - D_p_x_3_by_b_3_x*t272 - D_p_x_3_by_b_3_x*t273
        - D_p_x_3_by_b_3_x*t274 + D_p_y_2*D_p_y_3_by_b_3_x*k_C + D_p_y_2_by_b_3_x*D_p_y_3*k_C
        - D_p_y_2_by_b_3_x*t287 - D_p_y_2_by_b_3_x*t288 - D_p_y_2_by_b_3_x*t289 - D_p_y_3_by_b_3_x*t275
        - D_p_y_3_by_b_3_x*t276 - D_p_y_3_by_b_3_x*t277 + D_p_z_2*D_p_z_3_by_b_3_x*k_C
        + D_p_z_2_by_b_3_x*D_p_z_3*k_C - D_p_z_2_by_b_3_x*t290 - D_p_z_2_by_b_3_x*t291
        - D_p_z_2_by_b_3_x*t292 - D_p_z_3_by_b_3_x*t278 - D_p_z_3_by_b_3_x*t279 - D_p_z_3_by_b_3_x*t280
        + mu_1_by_b_3_x*t344 + mu_2_by_b_3_x*t345 + mu_3_by_b_3_x*t346,
        D_delta_x_1_by_b_3_x*t352 + D_delta_y_1_by_b_3_x*t353 + D_delta_z_1_by_b_3_x*t354
        - D_p_x_2_by_b_3_x*t302 - D_p_x_2_by_b_3_x*t303 - D_p_x_2_by_b_3_x*t304 + D_p_x_2_by_b_3_x*t411
        - D_p_y_2_by_b_3_x*t305 - D_p_y_2_by_b_3_x*t306 - D_p_y_2_by_b_3_x*t307 + D_p_y_2_by_b_3_x*t412
        - D_p_z_2_by_b_3_x*t308 - D_p_z_2_by_b_3_x*t309 - D_p_z_2_by_b_3_x*t310 + D_p_z_2_by_b_3_x*t413
        + mu_1_by_b_3_x*t350 + mu_2_by_b_3_x*t351 + mu_3_by_b_3_x*t350,
        D_delta_x_2_by_b_3_x*t352 + D_delta_y_2_by_b_3_x*t353 + D_delta_z_2_by_b_3_x*t354
        - D_p_x_2_by_b_3_x*t316 - D_p_x_2_by_b_3_x*t317 - D_p_x_2_by_b_3_x*t318 + D_p_x_2_by_b_3_x*t414
        - D_p_y_2_by_b_3_x*t319 - D_p_y_2_by_b_3_x*t320 - D_p_y_2_by_b_3_x*t321 + D_p_y_2_by_b_3_x*t415
        - D_p_z_2_by_b_3_x*t322 - D_p_z_2_by_b_3_x*t323 - D_p_z_2_by_b_3_x*t324 + D_p_z_2_by_b_3_x*t416
        + mu_1_by_b_3_x*t355 + mu_2_by_b_3_x*t356 + mu_3_by_b_3_x*t355,
        D_delta_x_3_by_b_3_x*t352 + D_delta_y_3_by_b_3_x*t353 + D_delta_z_3_by_b_3_x*t354
        - D_p_x_2_by_b_3_x*t327 - D_p_x_2_by_b_3_x*t328 - D_p_x_2_by_b_3_x*t329 + D_p_x_2_by_b_3_x*t417
        - D_p_y_2_by_b_3_x*t330 - D_p_y_2_by_b_3_x*t331 - D_p_y_2_by_b_3_x*t332 + D_p_y_2_by_b_3_x*t418
        - D_p_z_2_by_b_3_x*t333 - D_p_z_2_by_b_3_x*t334 - D_p_z_2_by_b_3_x*t335 + D_p_z_2_by_b_3_x*t419
        + mu_1_by_b_3_x*t357 + mu_2_by_b_3_x*t358 + mu_3_by_b_3_x*t357,
        D_p_x_2_by_b_3_x*k_C, D_p_y_2_by_b_3_x*k_C, D_p_z_2_by_b_3_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_x*k_C
        + k_sp_3*t262*t502*t509*w_b_3*x_3_by_b_3_x + mu_1_by_b_3_x*t362 + mu_2_by_b_3_x*t362
        + mu_3_by_b_3_x*t363 - t284*t499 - t285*t499 - t286*t499 - t287*t500 - t288*t500 - t289*t500
        - t290*t501 - t291*t501 - t292*t501 - t508,
        t511, t512,
        D_delta_x_1_by_b_3_x*t369 + D_delta_y_1_by_b_3_x*t370 + D_delta_z_1_by_b_3_x*t371
        - D_p_x_3_by_b_3_x*t302 - D_p_x_3_by_b_3_x*t303 - D_p_x_3_by_b_3_x*t304 + D_p_x_3_by_b_3_x*t411
        - D_p_y_3_by_b_3_x*t305 - D_p_y_3_by_b_3_x*t306 - D_p_y_3_by_b_3_x*t307 + D_p_y_3_by_b_3_x*t412
        - D_p_z_3_by_b_3_x*t308 - D_p_z_3_by_b_3_x*t309 - D_p_z_3_by_b_3_x*t310 + D_p_z_3_by_b_3_x*t413
        + mu_1_by_b_3_x*t367 + mu_2_by_b_3_x*t367 + mu_3_by_b_3_x*t368,
        D_delta_x_2_by_b_3_x*t369 + D_delta_y_2_by_b_3_x*t370 + D_delta_z_2_by_b_3_x*t371
        - D_p_x_3_by_b_3_x*t316 - D_p_x_3_by_b_3_x*t317 - D_p_x_3_by_b_3_x*t318 + D_p_x_3_by_b_3_x*t414
        - D_p_y_3_by_b_3_x*t319 - D_p_y_3_by_b_3_x*t320 - D_p_y_3_by_b_3_x*t321 + D_p_y_3_by_b_3_x*t415
        - D_p_z_3_by_b_3_x*t322 - D_p_z_3_by_b_3_x*t323 - D_p_z_3_by_b_3_x*t324 + D_p_z_3_by_b_3_x*t416
        + mu_1_by_b_3_x*t372 + mu_2_by_b_3_x*t372 + mu_3_by_b_3_x*t373,
        D_delta_x_3_by_b_3_x*t369 + D_delta_y_3_by_b_3_x*t370 + D_delta_z_3_by_b_3_x*t371
        - D_p_x_3_by_b_3_x*t327 - D_p_x_3_by_b_3_x*t328 - D_p_x_3_by_b_3_x*t329 + D_p_x_3_by_b_3_x*t417
        - D_p_y_3_by_b_3_x*t330 - D_p_y_3_by_b_3_x*t331 - D_p_y_3_by_b_3_x*t332 + D_p_y_3_by_b_3_x*t418
        - D_p_z_3_by_b_3_x*t333 - D_p_z_3_by_b_3_x*t334 - D_p_z_3_by_b_3_x*t335 + D_p_z_3_by_b_3_x*t419
        + mu_1_by_b_3_x*t374 + mu_2_by_b_3_x*t374 + mu_3_by_b_3_x*t375,
        t513, D_p_x_3_by_b_3_x*k_C, D_p_y_3_by_b_3_x*k_C, D_p_z_3_by_b_3_x*k_C, t230*t510, t511, -t230*t508,
        t512,
        D_delta_x_1_by_b_3_x*t377 + D_delta_y_1_by_b_3_x*t378 + D_delta_z_1_by_b_3_x*t379
        + mu_1_by_b_3_x*t380 - mu_2_by_b_3_x*t376 - mu_3_by_b_3_x*t376,
        D_delta_x_1_by_b_3_x*t382 + D_delta_x_2_by_b_3_x*t383 + D_delta_y_1_by_b_3_x*t384
        + D_delta_y_2_by_b_3_x*t385 + D_delta_z_1_by_b_3_x*t386 + D_delta_z_2_by_b_3_x*t387
        + mu_1_by_b_3_x*t381 + mu_2_by_b_3_x*t381 + mu_3_by_b_3_x*t381,
        D_delta_x_1_by_b_3_x*t389 + D_delta_x_3_by_b_3_x*t383 + D_delta_y_1_by_b_3_x*t390
        + D_delta_y_3_by_b_3_x*t385 + D_delta_z_1_by_b_3_x*t391 + D_delta_z_3_by_b_3_x*t387
        + mu_1_by_b_3_x*t388 + mu_2_by_b_3_x*t388 + mu_3_by_b_3_x*t388,
        D_delta_x_1_by_b_3_x*k_C, D_delta_y_1_by_b_3_x*k_C, D_delta_z_1_by_b_3_x*k_C,
        D_delta_x_2_by_b_3_x*t393 + D_delta_y_2_by_b_3_x*t394 + D_delta_z_2_by_b_3_x*t395
        - mu_1_by_b_3_x*t392 + mu_2_by_b_3_x*t396 - mu_3_by_b_3_x*t392,
        D_delta_x_2_by_b_3_x*t389 + D_delta_x_3_by_b_3_x*t382 + D_delta_y_2_by_b_3_x*t390
        + D_delta_y_3_by_b_3_x*t384 + D_delta_z_2_by_b_3_x*t391 + D_delta_z_3_by_b_3_x*t386
        + mu_1_by_b_3_x*t397 + mu_2_by_b_3_x*t397 + mu_3_by_b_3_x*t397,
        D_delta_x_2_by_b_3_x*k_C, D_delta_y_2_by_b_3_x*k_C, D_delta_z_2_by_b_3_x*k_C,
        D_delta_x_3_by_b_3_x*t399 + D_delta_y_3_by_b_3_x*t400 + D_delta_z_3_by_b_3_x*t401
        - mu_1_by_b_3_x*t398 - mu_2_by_b_3_x*t398 + mu_3_by_b_3_x*t402,
        D_delta_x_3_by_b_3_x*k_C, D_delta_y_3_by_b_3_x*k_C, D_delta_z_3_by_b_3_x*k_C, t513,
        2*D_p_x_1*D_p_x_1_by_b_3_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_y*k_C
        + mu_1_by_b_3_y*t260 + mu_2_by_b_3_y*t261 + mu_3_by_b_3_y*t261 - t248*t514 - t250*t514 - t251*t514
        - t252*t515 - t254*t515 - t255*t515 - t256*t516 - t258*t516 - t259*t516,
        D_p_x_1*D_p_x_2_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_2*k_C - D_p_x_1_by_b_3_y*t272
        - D_p_x_1_by_b_3_y*t273 - D_p_x_1_by_b_3_y*t274 - D_p_x_2_by_b_3_y*t248 - D_p_x_2_by_b_3_y*t250
        - D_p_x_2_by_b_3_y*t251 + D_p_y_1*D_p_y_2_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_2*k_C
        - D_p_y_1_by_b_3_y*t275 - D_p_y_1_by_b_3_y*t276 - D_p_y_1_by_b_3_y*t277 - D_p_y_2_by_b_3_y*t252
        - D_p_y_2_by_b_3_y*t254 - D_p_y_2_by_b_3_y*t255 + D_p_z_1*D_p_z_2_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_2*k_C - D_p_z_1_by_b_3_y*t278 - D_p_z_1_by_b_3_y*t279
        - D_p_z_1_by_b_3_y*t280 - D_p_z_2_by_b_3_y*t256 - D_p_z_2_by_b_3_y*t258 - D_p_z_2_by_b_3_y*t259
        + mu_1_by_b_3_y*t281 + mu_2_by_b_3_y*t282 + mu_3_by_b_3_y*t283,
        D_p_x_1*D_p_x_3_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_3*k_C - D_p_x_1_by_b_3_y*t284
        - D_p_x_1_by_b_3_y*t285 - D_p_x_1_by_b_3_y*t286 - D_p_x_3_by_b_3_y*t248 - D_p_x_3_by_b_3_y*t250
        - D_p_x_3_by_b_3_y*t251 + D_p_y_1*D_p_y_3_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_3*k_C
        - D_p_y_1_by_b_3_y*t287 - D_p_y_1_by_b_3_y*t288 - D_p_y_1_by_b_3_y*t289 - D_p_y_3_by_b_3_y*t252
        - D_p_y_3_by_b_3_y*t254 - D_p_y_3_by_b_3_y*t255 + D_p_z_1*D_p_z_3_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_3*k_C - D_p_z_1_by_b_3_y*t290 - D_p_z_1_by_b_3_y*t291
        - D_p_z_1_by_b_3_y*t292 - D_p_z_3_by_b_3_y*t256 - D_p_z_3_by_b_3_y*t258 - D_p_z_3_by_b_3_y*t259
        + mu_1_by_b_3_y*t293 + mu_2_by_b_3_y*t294 + mu_3_by_b_3_y*t295,
        D_delta_x_1_by_b_3_y*t313 + D_delta_y_1_by_b_3_y*t314 + D_delta_z_1_by_b_3_y*t315
        - D_p_x_1_by_b_3_y*t302 - D_p_x_1_by_b_3_y*t303 - D_p_x_1_by_b_3_y*t304 + D_p_x_1_by_b_3_y*t411
        - D_p_y_1_by_b_3_y*t305 - D_p_y_1_by_b_3_y*t306 - D_p_y_1_by_b_3_y*t307 + D_p_y_1_by_b_3_y*t412
        - D_p_z_1_by_b_3_y*t308 - D_p_z_1_by_b_3_y*t309 - D_p_z_1_by_b_3_y*t310 + D_p_z_1_by_b_3_y*t413
        + mu_1_by_b_3_y*t311 + mu_2_by_b_3_y*t312 + mu_3_by_b_3_y*t312,
        D_delta_x_2_by_b_3_y*t313 + D_delta_y_2_by_b_3_y*t314 + D_delta_z_2_by_b_3_y*t315
        - D_p_x_1_by_b_3_y*t316 - D_p_x_1_by_b_3_y*t317 - D_p_x_1_by_b_3_y*t318 + D_p_x_1_by_b_3_y*t414
        - D_p_y_1_by_b_3_y*t319 - D_p_y_1_by_b_3_y*t320 - D_p_y_1_by_b_3_y*t321 + D_p_y_1_by_b_3_y*t415
        - D_p_z_1_by_b_3_y*t322 - D_p_z_1_by_b_3_y*t323 - D_p_z_1_by_b_3_y*t324 + D_p_z_1_by_b_3_y*t416
        + mu_1_by_b_3_y*t325 + mu_2_by_b_3_y*t326 + mu_3_by_b_3_y*t326,
        D_delta_x_3_by_b_3_y*t313 + D_delta_y_3_by_b_3_y*t314 + D_delta_z_3_by_b_3_y*t315
        - D_p_x_1_by_b_3_y*t327 - D_p_x_1_by_b_3_y*t328 - D_p_x_1_by_b_3_y*t329 + D_p_x_1_by_b_3_y*t417
        - D_p_y_1_by_b_3_y*t330 - D_p_y_1_by_b_3_y*t331 - D_p_y_1_by_b_3_y*t332 + D_p_y_1_by_b_3_y*t418
        - D_p_z_1_by_b_3_y*t333 - D_p_z_1_by_b_3_y*t334 - D_p_z_1_by_b_3_y*t335 + D_p_z_1_by_b_3_y*t419
        + mu_1_by_b_3_y*t336 + mu_2_by_b_3_y*t337 + mu_3_by_b_3_y*t337,
        D_p_x_1_by_b_3_y*k_C, D_p_y_1_by_b_3_y*k_C, D_p_z_1_by_b_3_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_y*k_C
        + mu_1_by_b_3_y*t342 + mu_2_by_b_3_y*t343 + mu_3_by_b_3_y*t342 - t272*t517 - t273*t517 - t274*t517
        - t275*t518 - t276*t518 - t277*t518 - t278*t519 - t279*t519 - t280*t519,
        D_p_x_2*D_p_x_3_by_b_3_y*k_C + D_p_x_2_by_b_3_y*D_p_x_3*k_C - D_p_x_2_by_b_3_y*t284
        - D_p_x_2_by_b_3_y*t285 - D_p_x_2_by_b_3_y*t286 - D_p_x_3_by_b_3_y*t272 - D_p_x_3_by_b_3_y*t273
        - D_p_x_3_by_b_3_y*t274 + D_p_y_2*D_p_y_3_by_b_3_y*k_C + D_p_y_2_by_b_3_y*D_p_y_3*k_C
        - D_p_y_2_by_b_3_y*t287 - D_p_y_2_by_b_3_y*t288 - D_p_y_2_by_b_3_y*t289 - D_p_y_3_by_b_3_y*t275
        - D_p_y_3_by_b_3_y*t276 - D_p_y_3_by_b_3_y*t277 + D_p_z_2*D_p_z_3_by_b_3_y*k_C
        + D_p_z_2_by_b_3_y*D_p_z_3*k_C - D_p_z_2_by_b_3_y*t290 - D_p_z_2_by_b_3_y*t291
        - D_p_z_2_by_b_3_y*t292 - D_p_z_3_by_b_3_y*t278 - D_p_z_3_by_b_3_y*t279 - D_p_z_3_by_b_3_y*t280
        + mu_1_by_b_3_y*t344 + mu_2_by_b_3_y*t345 + mu_3_by_b_3_y*t346,
        D_delta_x_1_by_b_3_y*t352 + D_delta_y_1_by_b_3_y*t353 + D_delta_z_1_by_b_3_y*t354
        - D_p_x_2_by_b_3_y*t302 - D_p_x_2_by_b_3_y*t303 - D_p_x_2_by_b_3_y*t304 + D_p_x_2_by_b_3_y*t411
        - D_p_y_2_by_b_3_y*t305 - D_p_y_2_by_b_3_y*t306 - D_p_y_2_by_b_3_y*t307 + D_p_y_2_by_b_3_y*t412
        - D_p_z_2_by_b_3_y*t308 - D_p_z_2_by_b_3_y*t309 - D_p_z_2_by_b_3_y*t310 + D_p_z_2_by_b_3_y*t413
        + mu_1_by_b_3_y*t350 + mu_2_by_b_3_y*t351 + mu_3_by_b_3_y*t350,
        D_delta_x_2_by_b_3_y*t352 + D_delta_y_2_by_b_3_y*t353 + D_delta_z_2_by_b_3_y*t354
        - D_p_x_2_by_b_3_y*t316 - D_p_x_2_by_b_3_y*t317 - D_p_x_2_by_b_3_y*t318 + D_p_x_2_by_b_3_y*t414
        - D_p_y_2_by_b_3_y*t319 - D_p_y_2_by_b_3_y*t320 - D_p_y_2_by_b_3_y*t321 + D_p_y_2_by_b_3_y*t415
        - D_p_z_2_by_b_3_y*t322 - D_p_z_2_by_b_3_y*t323 - D_p_z_2_by_b_3_y*t324 + D_p_z_2_by_b_3_y*t416
        + mu_1_by_b_3_y*t355 + mu_2_by_b_3_y*t356 + mu_3_by_b_3_y*t355,
        D_delta_x_3_by_b_3_y*t352 + D_delta_y_3_by_b_3_y*t353 + D_delta_z_3_by_b_3_y*t354
        - D_p_x_2_by_b_3_y*t327 - D_p_x_2_by_b_3_y*t328 - D_p_x_2_by_b_3_y*t329 + D_p_x_2_by_b_3_y*t417
        - D_p_y_2_by_b_3_y*t330 - D_p_y_2_by_b_3_y*t331 - D_p_y_2_by_b_3_y*t332 + D_p_y_2_by_b_3_y*t418
        - D_p_z_2_by_b_3_y*t333 - D_p_z_2_by_b_3_y*t334 - D_p_z_2_by_b_3_y*t335 + D_p_z_2_by_b_3_y*t419
        + mu_1_by_b_3_y*t357 + mu_2_by_b_3_y*t358 + mu_3_by_b_3_y*t357,
        D_p_x_2_by_b_3_y*k_C, D_p_y_2_by_b_3_y*k_C, D_p_z_2_by_b_3_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_y*k_C
        + k_sp_3*t262*t502*t509*w_b_3*x_3_by_b_3_y + mu_1_by_b_3_y*t362 + mu_2_by_b_3_y*t362
        + mu_3_by_b_3_y*t363 - t284*t520 - t285*t520 - t286*t520 - t287*t521 - t288*t521 - t289*t521
        - t290*t522 - t291*t522 - t292*t522 - t524,
        t526, t527,
        D_delta_x_1_by_b_3_y*t369 + D_delta_y_1_by_b_3_y*t370 + D_delta_z_1_by_b_3_y*t371
        - D_p_x_3_by_b_3_y*t302 - D_p_x_3_by_b_3_y*t303 - D_p_x_3_by_b_3_y*t304 + D_p_x_3_by_b_3_y*t411
        - D_p_y_3_by_b_3_y*t305 - D_p_y_3_by_b_3_y*t306 - D_p_y_3_by_b_3_y*t307 + D_p_y_3_by_b_3_y*t412
        - D_p_z_3_by_b_3_y*t308 - D_p_z_3_by_b_3_y*t309 - D_p_z_3_by_b_3_y*t310 + D_p_z_3_by_b_3_y*t413
        + mu_1_by_b_3_y*t367 + mu_2_by_b_3_y*t367 + mu_3_by_b_3_y*t368,
        D_delta_x_2_by_b_3_y*t369 + D_delta_y_2_by_b_3_y*t370 + D_delta_z_2_by_b_3_y*t371
        - D_p_x_3_by_b_3_y*t316 - D_p_x_3_by_b_3_y*t317 - D_p_x_3_by_b_3_y*t318 + D_p_x_3_by_b_3_y*t414
        - D_p_y_3_by_b_3_y*t319 - D_p_y_3_by_b_3_y*t320 - D_p_y_3_by_b_3_y*t321 + D_p_y_3_by_b_3_y*t415
        - D_p_z_3_by_b_3_y*t322 - D_p_z_3_by_b_3_y*t323 - D_p_z_3_by_b_3_y*t324 + D_p_z_3_by_b_3_y*t416
        + mu_1_by_b_3_y*t372 + mu_2_by_b_3_y*t372 + mu_3_by_b_3_y*t373,
        D_delta_x_3_by_b_3_y*t369 + D_delta_y_3_by_b_3_y*t370 + D_delta_z_3_by_b_3_y*t371
        - D_p_x_3_by_b_3_y*t327 - D_p_x_3_by_b_3_y*t328 - D_p_x_3_by_b_3_y*t329 + D_p_x_3_by_b_3_y*t417
        - D_p_y_3_by_b_3_y*t330 - D_p_y_3_by_b_3_y*t331 - D_p_y_3_by_b_3_y*t332 + D_p_y_3_by_b_3_y*t418
        - D_p_z_3_by_b_3_y*t333 - D_p_z_3_by_b_3_y*t334 - D_p_z_3_by_b_3_y*t335 + D_p_z_3_by_b_3_y*t419
        + mu_1_by_b_3_y*t374 + mu_2_by_b_3_y*t374 + mu_3_by_b_3_y*t375,
        t528, D_p_x_3_by_b_3_y*k_C, D_p_y_3_by_b_3_y*k_C, D_p_z_3_by_b_3_y*k_C, t230*t525, t526, -t230*t524,
        t527,
        D_delta_x_1_by_b_3_y*t377 + D_delta_y_1_by_b_3_y*t378 + D_delta_z_1_by_b_3_y*t379
        + mu_1_by_b_3_y*t380 - mu_2_by_b_3_y*t376 - mu_3_by_b_3_y*t376,
        D_delta_x_1_by_b_3_y*t382 + D_delta_x_2_by_b_3_y*t383 + D_delta_y_1_by_b_3_y*t384
        + D_delta_y_2_by_b_3_y*t385 + D_delta_z_1_by_b_3_y*t386 + D_delta_z_2_by_b_3_y*t387
        + mu_1_by_b_3_y*t381 + mu_2_by_b_3_y*t381 + mu_3_by_b_3_y*t381,
        D_delta_x_1_by_b_3_y*t389 + D_delta_x_3_by_b_3_y*t383 + D_delta_y_1_by_b_3_y*t390
        + D_delta_y_3_by_b_3_y*t385 + D_delta_z_1_by_b_3_y*t391 + D_delta_z_3_by_b_3_y*t387
        + mu_1_by_b_3_y*t388 + mu_2_by_b_3_y*t388 + mu_3_by_b_3_y*t388,
        D_delta_x_1_by_b_3_y*k_C, D_delta_y_1_by_b_3_y*k_C, D_delta_z_1_by_b_3_y*k_C,
        D_delta_x_2_by_b_3_y*t393 + D_delta_y_2_by_b_3_y*t394 + D_delta_z_2_by_b_3_y*t395
        - mu_1_by_b_3_y*t392 + mu_2_by_b_3_y*t396 - mu_3_by_b_3_y*t392,
        D_delta_x_2_by_b_3_y*t389 + D_delta_x_3_by_b_3_y*t382 + D_delta_y_2_by_b_3_y*t390
        + D_delta_y_3_by_b_3_y*t384 + D_delta_z_2_by_b_3_y*t391 + D_delta_z_3_by_b_3_y*t386
        + mu_1_by_b_3_y*t397 + mu_2_by_b_3_y*t397 + mu_3_by_b_3_y*t397,
        D_delta_x_2_by_b_3_y*k_C, D_delta_y_2_by_b_3_y*k_C, D_delta_z_2_by_b_3_y*k_C,
        D_delta_x_3_by_b_3_y*t399 + D_delta_y_3_by_b_3_y*t400 + D_delta_z_3_by_b_3_y*t401
        - mu_1_by_b_3_y*t398 - mu_2_by_b_3_y*t398 + mu_3_by_b_3_y*t402,
        D_delta_x_3_by_b_3_y*k_C, D_delta_y_3_by_b_3_y*k_C, D_delta_z_3_by_b_3_y*k_C, t528,
        2*D_p_x_1*D_p_x_1_by_b_3_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_z*k_C
        + mu_1_by_b_3_z*t260 + mu_2_by_b_3_z*t261 + mu_3_by_b_3_z*t261 - t248*t529 - t250*t529 - t251*t529
        - t252*t530 - t254*t530 - t255*t530 - t256*t531 - t258*t531 - t259*t531,
        D_p_x_1*D_p_x_2_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_2*k_C - D_p_x_1_by_b_3_z*t272
        - D_p_x_1_by_b_3_z*t273 - D_p_x_1_by_b_3_z*t274 - D_p_x_2_by_b_3_z*t248 - D_p_x_2_by_b_3_z*t250
        - D_p_x_2_by_b_3_z*t251 + D_p_y_1*D_p_y_2_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_2*k_C
        - D_p_y_1_by_b_3_z*t275 - D_p_y_1_by_b_3_z*t276 - D_p_y_1_by_b_3_z*t277 - D_p_y_2_by_b_3_z*t252
        - D_p_y_2_by_b_3_z*t254 - D_p_y_2_by_b_3_z*t255 + D_p_z_1*D_p_z_2_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_2*k_C - D_p_z_1_by_b_3_z*t278 - D_p_z_1_by_b_3_z*t279
        - D_p_z_1_by_b_3_z*t280 - D_p_z_2_by_b_3_z*t256 - D_p_z_2_by_b_3_z*t258 - D_p_z_2_by_b_3_z*t259
        + mu_1_by_b_3_z*t281 + mu_2_by_b_3_z*t282 + mu_3_by_b_3_z*t283,
        D_p_x_1*D_p_x_3_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_3*k_C - D_p_x_1_by_b_3_z*t284
        - D_p_x_1_by_b_3_z*t285 - D_p_x_1_by_b_3_z*t286 - D_p_x_3_by_b_3_z*t248 - D_p_x_3_by_b_3_z*t250
        - D_p_x_3_by_b_3_z*t251 + D_p_y_1*D_p_y_3_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_3*k_C
        - D_p_y_1_by_b_3_z*t287 - D_p_y_1_by_b_3_z*t288 - D_p_y_1_by_b_3_z*t289 - D_p_y_3_by_b_3_z*t252
        - D_p_y_3_by_b_3_z*t254 - D_p_y_3_by_b_3_z*t255 + D_p_z_1*D_p_z_3_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_3*k_C - D_p_z_1_by_b_3_z*t290 - D_p_z_1_by_b_3_z*t291
        - D_p_z_1_by_b_3_z*t292 - D_p_z_3_by_b_3_z*t256 - D_p_z_3_by_b_3_z*t258 - D_p_z_3_by_b_3_z*t259
        + mu_1_by_b_3_z*t293 + mu_2_by_b_3_z*t294 + mu_3_by_b_3_z*t295,
        D_delta_x_1_by_b_3_z*t313 + D_delta_y_1_by_b_3_z*t314 + D_delta_z_1_by_b_3_z*t315
        - D_p_x_1_by_b_3_z*t302 - D_p_x_1_by_b_3_z*t303 - D_p_x_1_by_b_3_z*t304 + D_p_x_1_by_b_3_z*t411
        - D_p_y_1_by_b_3_z*t305 - D_p_y_1_by_b_3_z*t306 - D_p_y_1_by_b_3_z*t307 + D_p_y_1_by_b_3_z*t412
        - D_p_z_1_by_b_3_z*t308 - D_p_z_1_by_b_3_z*t309 - D_p_z_1_by_b_3_z*t310 + D_p_z_1_by_b_3_z*t413
        + mu_1_by_b_3_z*t311 + mu_2_by_b_3_z*t312 + mu_3_by_b_3_z*t312,
        D_delta_x_2_by_b_3_z*t313 + D_delta_y_2_by_b_3_z*t314 + D_delta_z_2_by_b_3_z*t315
        - D_p_x_1_by_b_3_z*t316 - D_p_x_1_by_b_3_z*t317 - D_p_x_1_by_b_3_z*t318 + D_p_x_1_by_b_3_z*t414
        - D_p_y_1_by_b_3_z*t319 - D_p_y_1_by_b_3_z*t320 - D_p_y_1_by_b_3_z*t321 + D_p_y_1_by_b_3_z*t415
        - D_p_z_1_by_b_3_z*t322 - D_p_z_1_by_b_3_z*t323 - D_p_z_1_by_b_3_z*t324 + D_p_z_1_by_b_3_z*t416
        + mu_1_by_b_3_z*t325 + mu_2_by_b_3_z*t326 + mu_3_by_b_3_z*t326,
        D_delta_x_3_by_b_3_z*t313 + D_delta_y_3_by_b_3_z*t314 + D_delta_z_3_by_b_3_z*t315
        - D_p_x_1_by_b_3_z*t327 - D_p_x_1_by_b_3_z*t328 - D_p_x_1_by_b_3_z*t329 + D_p_x_1_by_b_3_z*t417
        - D_p_y_1_by_b_3_z*t330 - D_p_y_1_by_b_3_z*t331 - D_p_y_1_by_b_3_z*t332 + D_p_y_1_by_b_3_z*t418
        - D_p_z_1_by_b_3_z*t333 - D_p_z_1_by_b_3_z*t334 - D_p_z_1_by_b_3_z*t335 + D_p_z_1_by_b_3_z*t419
        + mu_1_by_b_3_z*t336 + mu_2_by_b_3_z*t337 + mu_3_by_b_3_z*t337,
        D_p_x_1_by_b_3_z*k_C, D_p_y_1_by_b_3_z*k_C, D_p_z_1_by_b_3_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_z*k_C
        + mu_1_by_b_3_z*t342 + mu_2_by_b_3_z*t343 + mu_3_by_b_3_z*t342 - t272*t532 - t273*t532 - t274*t532
        - t275*t533 - t276*t533 - t277*t533 - t278*t534 - t279*t534 - t280*t534,
        D_p_x_2*D_p_x_3_by_b_3_z*k_C + D_p_x_2_by_b_3_z*D_p_x_3*k_C - D_p_x_2_by_b_3_z*t284
        - D_p_x_2_by_b_3_z*t285 - D_p_x_2_by_b_3_z*t286 - D_p_x_3_by_b_3_z*t272 - D_p_x_3_by_b_3_z*t273
        - D_p_x_3_by_b_3_z*t274 + D_p_y_2*D_p_y_3_by_b_3_z*k_C + D_p_y_2_by_b_3_z*D_p_y_3*k_C
        - D_p_y_2_by_b_3_z*t287 - D_p_y_2_by_b_3_z*t288 - D_p_y_2_by_b_3_z*t289 - D_p_y_3_by_b_3_z*t275
        - D_p_y_3_by_b_3_z*t276 - D_p_y_3_by_b_3_z*t277 + D_p_z_2*D_p_z_3_by_b_3_z*k_C
        + D_p_z_2_by_b_3_z*D_p_z_3*k_C - D_p_z_2_by_b_3_z*t290 - D_p_z_2_by_b_3_z*t291
        - D_p_z_2_by_b_3_z*t292 - D_p_z_3_by_b_3_z*t278 - D_p_z_3_by_b_3_z*t279 - D_p_z_3_by_b_3_z*t280
        + mu_1_by_b_3_z*t344 + mu_2_by_b_3_z*t345 + mu_3_by_b_3_z*t346,
        D_delta_x_1_by_b_3_z*t352 + D_delta_y_1_by_b_3_z*t353 + D_delta_z_1_by_b_3_z*t354
        - D_p_x_2_by_b_3_z*t302 - D_p_x_2_by_b_3_z*t303 - D_p_x_2_by_b_3_z*t304 + D_p_x_2_by_b_3_z*t411
        - D_p_y_2_by_b_3_z*t305 - D_p_y_2_by_b_3_z*t306 - D_p_y_2_by_b_3_z*t307 + D_p_y_2_by_b_3_z*t412
        - D_p_z_2_by_b_3_z*t308 - D_p_z_2_by_b_3_z*t309 - D_p_z_2_by_b_3_z*t310 + D_p_z_2_by_b_3_z*t413
        + mu_1_by_b_3_z*t350 + mu_2_by_b_3_z*t351 + mu_3_by_b_3_z*t350,
        D_delta_x_2_by_b_3_z*t352 + D_delta_y_2_by_b_3_z*t353 + D_delta_z_2_by_b_3_z*t354
        - D_p_x_2_by_b_3_z*t316 - D_p_x_2_by_b_3_z*t317 - D_p_x_2_by_b_3_z*t318 + D_p_x_2_by_b_3_z*t414
        - D_p_y_2_by_b_3_z*t319 - D_p_y_2_by_b_3_z*t320 - D_p_y_2_by_b_3_z*t321 + D_p_y_2_by_b_3_z*t415
        - D_p_z_2_by_b_3_z*t322 - D_p_z_2_by_b_3_z*t323 - D_p_z_2_by_b_3_z*t324 + D_p_z_2_by_b_3_z*t416
        + mu_1_by_b_3_z*t355 + mu_2_by_b_3_z*t356 + mu_3_by_b_3_z*t355,
        D_delta_x_3_by_b_3_z*t352 + D_delta_y_3_by_b_3_z*t353 + D_delta_z_3_by_b_3_z*t354
        - D_p_x_2_by_b_3_z*t327 - D_p_x_2_by_b_3_z*t328 - D_p_x_2_by_b_3_z*t329 + D_p_x_2_by_b_3_z*t417
        - D_p_y_2_by_b_3_z*t330 - D_p_y_2_by_b_3_z*t331 - D_p_y_2_by_b_3_z*t332 + D_p_y_2_by_b_3_z*t418
        - D_p_z_2_by_b_3_z*t333 - D_p_z_2_by_b_3_z*t334 - D_p_z_2_by_b_3_z*t335 + D_p_z_2_by_b_3_z*t419
        + mu_1_by_b_3_z*t357 + mu_2_by_b_3_z*t358 + mu_3_by_b_3_z*t357,
        D_p_x_2_by_b_3_z*k_C, D_p_y_2_by_b_3_z*k_C, D_p_z_2_by_b_3_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_z*k_C
        + k_sp_3*t262*t502*t509*w_b_3*x_3_by_b_3_z + mu_1_by_b_3_z*t362 + mu_2_by_b_3_z*t362
        + mu_3_by_b_3_z*t363 - t284*t535 - t285*t535 - t286*t535 - t287*t536 - t288*t536 - t289*t536
        - t290*t537 - t291*t537 - t292*t537 - t539,
        t541, t542,
        D_delta_x_1_by_b_3_z*t369 + D_delta_y_1_by_b_3_z*t370 + D_delta_z_1_by_b_3_z*t371
        - D_p_x_3_by_b_3_z*t302 - D_p_x_3_by_b_3_z*t303 - D_p_x_3_by_b_3_z*t304 + D_p_x_3_by_b_3_z*t411
        - D_p_y_3_by_b_3_z*t305 - D_p_y_3_by_b_3_z*t306 - D_p_y_3_by_b_3_z*t307 + D_p_y_3_by_b_3_z*t412
        - D_p_z_3_by_b_3_z*t308 - D_p_z_3_by_b_3_z*t309 - D_p_z_3_by_b_3_z*t310 + D_p_z_3_by_b_3_z*t413
        + mu_1_by_b_3_z*t367 + mu_2_by_b_3_z*t367 + mu_3_by_b_3_z*t368,
        D_delta_x_2_by_b_3_z*t369 + D_delta_y_2_by_b_3_z*t370 + D_delta_z_2_by_b_3_z*t371
        - D_p_x_3_by_b_3_z*t316 - D_p_x_3_by_b_3_z*t317 - D_p_x_3_by_b_3_z*t318 + D_p_x_3_by_b_3_z*t414
        - D_p_y_3_by_b_3_z*t319 - D_p_y_3_by_b_3_z*t320 - D_p_y_3_by_b_3_z*t321 + D_p_y_3_by_b_3_z*t415
        - D_p_z_3_by_b_3_z*t322 - D_p_z_3_by_b_3_z*t323 - D_p_z_3_by_b_3_z*t324 + D_p_z_3_by_b_3_z*t416
        + mu_1_by_b_3_z*t372 + mu_2_by_b_3_z*t372 + mu_3_by_b_3_z*t373,
        D_delta_x_3_by_b_3_z*t369 + D_delta_y_3_by_b_3_z*t370 + D_delta_z_3_by_b_3_z*t371
        - D_p_x_3_by_b_3_z*t327 - D_p_x_3_by_b_3_z*t328 - D_p_x_3_by_b_3_z*t329 + D_p_x_3_by_b_3_z*t417
        - D_p_y_3_by_b_3_z*t330 - D_p_y_3_by_b_3_z*t331 - D_p_y_3_by_b_3_z*t332 + D_p_y_3_by_b_3_z*t418
        - D_p_z_3_by_b_3_z*t333 - D_p_z_3_by_b_3_z*t334 - D_p_z_3_by_b_3_z*t335 + D_p_z_3_by_b_3_z*t419
        + mu_1_by_b_3_z*t374 + mu_2_by_b_3_z*t374 + mu_3_by_b_3_z*t375,
        t543, D_p_x_3_by_b_3_z*k_C, D_p_y_3_by_b_3_z*k_C, D_p_z_3_by_b_3_z*k_C, t230*t540, t541, -t230*t539,
        t542,
        D_delta_x_1_by_b_3_z*t377 + D_delta_y_1_by_b_3_z*t378 + D_delta_z_1_by_b_3_z*t379
        + mu_1_by_b_3_z*t380 - mu_2_by_b_3_z*t376 - mu_3_by_b_3_z*t376,
        D_delta_x_1_by_b_3_z*t382 + D_delta_x_2_by_b_3_z*t383 + D_delta_y_1_by_b_3_z*t384
        + D_delta_y_2_by_b_3_z*t385 + D_delta_z_1_by_b_3_z*t386 + D_delta_z_2_by_b_3_z*t387
        + mu_1_by_b_3_z*t381 + mu_2_by_b_3_z*t381 + mu_3_by_b_3_z*t381,
        D_delta_x_1_by_b_3_z*t389 + D_delta_x_3_by_b_3_z*t383 + D_delta_y_1_by_b_3_z*t390
        + D_delta_y_3_by_b_3_z*t385 + D_delta_z_1_by_b_3_z*t391 + D_delta_z_3_by_b_3_z*t387
        + mu_1_by_b_3_z*t388 + mu_2_by_b_3_z*t388 + mu_3_by_b_3_z*t388,
        D_delta_x_1_by_b_3_z*k_C, D_delta_y_1_by_b_3_z*k_C, D_delta_z_1_by_b_3_z*k_C,
        D_delta_x_2_by_b_3_z*t393 + D_delta_y_2_by_b_3_z*t394 + D_delta_z_2_by_b_3_z*t395
        - mu_1_by_b_3_z*t392 + mu_2_by_b_3_z*t396 - mu_3_by_b_3_z*t392,
        D_delta_x_2_by_b_3_z*t389 + D_delta_x_3_by_b_3_z*t382 + D_delta_y_2_by_b_3_z*t390
        + D_delta_y_3_by_b_3_z*t384 + D_delta_z_2_by_b_3_z*t391 + D_delta_z_3_by_b_3_z*t386
        + mu_1_by_b_3_z*t397 + mu_2_by_b_3_z*t397 + mu_3_by_b_3_z*t397,
        D_delta_x_2_by_b_3_z*k_C, D_delta_y_2_by_b_3_z*k_C, D_delta_z_2_by_b_3_z*k_C,
        D_delta_x_3_by_b_3_z*t399 + D_delta_y_3_by_b_3_z*t400 + D_delta_z_3_by_b_3_z*t401
        - mu_1_by_b_3_z*t398 - mu_2_by_b_3_z*t398 + mu_3_by_b_3_z*t402,
        D_delta_x_3_by_b_3_z*k_C, D_delta_y_3_by_b_3_z*k_C, D_delta_z_3_by_b_3_z*k_C, t543,
        2*D_p_x_1*D_p_x_1_by_l_d_1*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_1*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_1*k_C
        + k_sp_1*t262*t263*t271*w_b_1*x_1_by_l_d_1 + mu_1_by_l_d_1*t260 + mu_2_by_l_d_1*t261
        + mu_3_by_l_d_1*t261 - t248*t544 - t250*t544 - t251*t544 - t252*t545 - t254*t545 - t255*t545
        - t256*t546 - t258*t546 - t259*t546 - t548,
        D_p_x_1*D_p_x_2_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_2*k_C - D_p_x_1_by_l_d_1*t272
        - D_p_x_1_by_l_d_1*t273 - D_p_x_1_by_l_d_1*t274 - D_p_x_2_by_l_d_1*t248 - D_p_x_2_by_l_d_1*t250
        - D_p_x_2_by_l_d_1*t251 + D_p_y_1*D_p_y_2_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_2*k_C
        - D_p_y_1_by_l_d_1*t275 - D_p_y_1_by_l_d_1*t276 - D_p_y_1_by_l_d_1*t277 - D_p_y_2_by_l_d_1*t252
        - D_p_y_2_by_l_d_1*t254 - D_p_y_2_by_l_d_1*t255 + D_p_z_1*D_p_z_2_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_2*k_C - D_p_z_1_by_l_d_1*t278 - D_p_z_1_by_l_d_1*t279
        - D_p_z_1_by_l_d_1*t280 - D_p_z_2_by_l_d_1*t256 - D_p_z_2_by_l_d_1*t258 - D_p_z_2_by_l_d_1*t259
        + mu_1_by_l_d_1*t281 + mu_2_by_l_d_1*t282 + mu_3_by_l_d_1*t283,
        D_p_x_1*D_p_x_3_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_3*k_C - D_p_x_1_by_l_d_1*t284
        - D_p_x_1_by_l_d_1*t285 - D_p_x_1_by_l_d_1*t286 - D_p_x_3_by_l_d_1*t248 - D_p_x_3_by_l_d_1*t250
        - D_p_x_3_by_l_d_1*t251 + D_p_y_1*D_p_y_3_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_3*k_C
        - D_p_y_1_by_l_d_1*t287 - D_p_y_1_by_l_d_1*t288 - D_p_y_1_by_l_d_1*t289 - D_p_y_3_by_l_d_1*t252
        - D_p_y_3_by_l_d_1*t254 - D_p_y_3_by_l_d_1*t255 + D_p_z_1*D_p_z_3_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_3*k_C - D_p_z_1_by_l_d_1*t290 - D_p_z_1_by_l_d_1*t291
        - D_p_z_1_by_l_d_1*t292 - D_p_z_3_by_l_d_1*t256 - D_p_z_3_by_l_d_1*t258 - D_p_z_3_by_l_d_1*t259
        + mu_1_by_l_d_1*t293 + mu_2_by_l_d_1*t294 + mu_3_by_l_d_1*t295,
        t550, t551,
        D_delta_x_1_by_l_d_1*t313 + D_delta_y_1_by_l_d_1*t314 + D_delta_z_1_by_l_d_1*t315
        - D_p_x_1_by_l_d_1*t302 - D_p_x_1_by_l_d_1*t303 - D_p_x_1_by_l_d_1*t304 + D_p_x_1_by_l_d_1*t411
        - D_p_y_1_by_l_d_1*t305 - D_p_y_1_by_l_d_1*t306 - D_p_y_1_by_l_d_1*t307 + D_p_y_1_by_l_d_1*t412
        - D_p_z_1_by_l_d_1*t308 - D_p_z_1_by_l_d_1*t309 - D_p_z_1_by_l_d_1*t310 + D_p_z_1_by_l_d_1*t413
        + mu_1_by_l_d_1*t311 + mu_2_by_l_d_1*t312 + mu_3_by_l_d_1*t312,
        D_delta_x_2_by_l_d_1*t313 + D_delta_y_2_by_l_d_1*t314 + D_delta_z_2_by_l_d_1*t315
        - D_p_x_1_by_l_d_1*t316 - D_p_x_1_by_l_d_1*t317 - D_p_x_1_by_l_d_1*t318 + D_p_x_1_by_l_d_1*t414
        - D_p_y_1_by_l_d_1*t319 - D_p_y_1_by_l_d_1*t320 - D_p_y_1_by_l_d_1*t321 + D_p_y_1_by_l_d_1*t415
        - D_p_z_1_by_l_d_1*t322 - D_p_z_1_by_l_d_1*t323 - D_p_z_1_by_l_d_1*t324 + D_p_z_1_by_l_d_1*t416
        + mu_1_by_l_d_1*t325 + mu_2_by_l_d_1*t326 + mu_3_by_l_d_1*t326,
        D_delta_x_3_by_l_d_1*t313 + D_delta_y_3_by_l_d_1*t314 + D_delta_z_3_by_l_d_1*t315
        - D_p_x_1_by_l_d_1*t327 - D_p_x_1_by_l_d_1*t328 - D_p_x_1_by_l_d_1*t329 + D_p_x_1_by_l_d_1*t417
        - D_p_y_1_by_l_d_1*t330 - D_p_y_1_by_l_d_1*t331 - D_p_y_1_by_l_d_1*t332 + D_p_y_1_by_l_d_1*t418
        - D_p_z_1_by_l_d_1*t333 - D_p_z_1_by_l_d_1*t334 - D_p_z_1_by_l_d_1*t335 + D_p_z_1_by_l_d_1*t419
        + mu_1_by_l_d_1*t336 + mu_2_by_l_d_1*t337 + mu_3_by_l_d_1*t337,
        t552, D_p_x_1_by_l_d_1*k_C, D_p_y_1_by_l_d_1*k_C, D_p_z_1_by_l_d_1*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_1*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_1*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_1*k_C
        + mu_1_by_l_d_1*t342 + mu_2_by_l_d_1*t343 + mu_3_by_l_d_1*t342 - t272*t553 - t273*t553 - t274*t553
        - t275*t554 - t276*t554 - t277*t554 - t278*t555 - t279*t555 - t280*t555,
        D_p_x_2*D_p_x_3_by_l_d_1*k_C + D_p_x_2_by_l_d_1*D_p_x_3*k_C - D_p_x_2_by_l_d_1*t284
        - D_p_x_2_by_l_d_1*t285 - D_p_x_2_by_l_d_1*t286 - D_p_x_3_by_l_d_1*t272 - D_p_x_3_by_l_d_1*t273
        - D_p_x_3_by_l_d_1*t274 + D_p_y_2*D_p_y_3_by_l_d_1*k_C + D_p_y_2_by_l_d_1*D_p_y_3*k_C
        - D_p_y_2_by_l_d_1*t287 - D_p_y_2_by_l_d_1*t288 - D_p_y_2_by_l_d_1*t289 - D_p_y_3_by_l_d_1*t275
        - D_p_y_3_by_l_d_1*t276 - D_p_y_3_by_l_d_1*t277 + D_p_z_2*D_p_z_3_by_l_d_1*k_C
        + D_p_z_2_by_l_d_1*D_p_z_3*k_C - D_p_z_2_by_l_d_1*t290 - D_p_z_2_by_l_d_1*t291
        - D_p_z_2_by_l_d_1*t292 - D_p_z_3_by_l_d_1*t278 - D_p_z_3_by_l_d_1*t279 - D_p_z_3_by_l_d_1*t280
        + mu_1_by_l_d_1*t344 + mu_2_by_l_d_1*t345 + mu_3_by_l_d_1*t346,
        D_delta_x_1_by_l_d_1*t352 + D_delta_y_1_by_l_d_1*t353 + D_delta_z_1_by_l_d_1*t354
        - D_p_x_2_by_l_d_1*t302 - D_p_x_2_by_l_d_1*t303 - D_p_x_2_by_l_d_1*t304 + D_p_x_2_by_l_d_1*t411
        - D_p_y_2_by_l_d_1*t305 - D_p_y_2_by_l_d_1*t306 - D_p_y_2_by_l_d_1*t307 + D_p_y_2_by_l_d_1*t412
        - D_p_z_2_by_l_d_1*t308 - D_p_z_2_by_l_d_1*t309 - D_p_z_2_by_l_d_1*t310 + D_p_z_2_by_l_d_1*t413
        + mu_1_by_l_d_1*t350 + mu_2_by_l_d_1*t351 + mu_3_by_l_d_1*t350,
        D_delta_x_2_by_l_d_1*t352 + D_delta_y_2_by_l_d_1*t353 + D_delta_z_2_by_l_d_1*t354
        - D_p_x_2_by_l_d_1*t316 - D_p_x_2_by_l_d_1*t317 - D_p_x_2_by_l_d_1*t318 + D_p_x_2_by_l_d_1*t414
        - D_p_y_2_by_l_d_1*t319 - D_p_y_2_by_l_d_1*t320 - D_p_y_2_by_l_d_1*t321 + D_p_y_2_by_l_d_1*t415
        - D_p_z_2_by_l_d_1*t322 - D_p_z_2_by_l_d_1*t323 - D_p_z_2_by_l_d_1*t324 + D_p_z_2_by_l_d_1*t416
        + mu_1_by_l_d_1*t355 + mu_2_by_l_d_1*t356 + mu_3_by_l_d_1*t355,
        D_delta_x_3_by_l_d_1*t352 + D_delta_y_3_by_l_d_1*t353 + D_delta_z_3_by_l_d_1*t354
        - D_p_x_2_by_l_d_1*t327 - D_p_x_2_by_l_d_1*t328 - D_p_x_2_by_l_d_1*t329 + D_p_x_2_by_l_d_1*t417
        - D_p_y_2_by_l_d_1*t330 - D_p_y_2_by_l_d_1*t331 - D_p_y_2_by_l_d_1*t332 + D_p_y_2_by_l_d_1*t418
        - D_p_z_2_by_l_d_1*t333 - D_p_z_2_by_l_d_1*t334 - D_p_z_2_by_l_d_1*t335 + D_p_z_2_by_l_d_1*t419
        + mu_1_by_l_d_1*t357 + mu_2_by_l_d_1*t358 + mu_3_by_l_d_1*t357,
        D_p_x_2_by_l_d_1*k_C, D_p_y_2_by_l_d_1*k_C, D_p_z_2_by_l_d_1*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_1*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_1*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_1*k_C
        + mu_1_by_l_d_1*t362 + mu_2_by_l_d_1*t362 + mu_3_by_l_d_1*t363 - t284*t556 - t285*t556 - t286*t556
        - t287*t557 - t288*t557 - t289*t557 - t290*t558 - t291*t558 - t292*t558,
        D_delta_x_1_by_l_d_1*t369 + D_delta_y_1_by_l_d_1*t370 + D_delta_z_1_by_l_d_1*t371
        - D_p_x_3_by_l_d_1*t302 - D_p_x_3_by_l_d_1*t303 - D_p_x_3_by_l_d_1*t304 + D_p_x_3_by_l_d_1*t411
        - D_p_y_3_by_l_d_1*t305 - D_p_y_3_by_l_d_1*t306 - D_p_y_3_by_l_d_1*t307 + D_p_y_3_by_l_d_1*t412
        - D_p_z_3_by_l_d_1*t308 - D_p_z_3_by_l_d_1*t309 - D_p_z_3_by_l_d_1*t310 + D_p_z_3_by_l_d_1*t413
        + mu_1_by_l_d_1*t367 + mu_2_by_l_d_1*t367 + mu_3_by_l_d_1*t368,
        D_delta_x_2_by_l_d_1*t369 + D_delta_y_2_by_l_d_1*t370 + D_delta_z_2_by_l_d_1*t371
        - D_p_x_3_by_l_d_1*t316 - D_p_x_3_by_l_d_1*t317 - D_p_x_3_by_l_d_1*t318 + D_p_x_3_by_l_d_1*t414
        - D_p_y_3_by_l_d_1*t319 - D_p_y_3_by_l_d_1*t320 - D_p_y_3_by_l_d_1*t321 + D_p_y_3_by_l_d_1*t415
        - D_p_z_3_by_l_d_1*t322 - D_p_z_3_by_l_d_1*t323 - D_p_z_3_by_l_d_1*t324 + D_p_z_3_by_l_d_1*t416
        + mu_1_by_l_d_1*t372 + mu_2_by_l_d_1*t372 + mu_3_by_l_d_1*t373,
        D_delta_x_3_by_l_d_1*t369 + D_delta_y_3_by_l_d_1*t370 + D_delta_z_3_by_l_d_1*t371
        - D_p_x_3_by_l_d_1*t327 - D_p_x_3_by_l_d_1*t328 - D_p_x_3_by_l_d_1*t329 + D_p_x_3_by_l_d_1*t417
        - D_p_y_3_by_l_d_1*t330 - D_p_y_3_by_l_d_1*t331 - D_p_y_3_by_l_d_1*t332 + D_p_y_3_by_l_d_1*t418
        - D_p_z_3_by_l_d_1*t333 - D_p_z_3_by_l_d_1*t334 - D_p_z_3_by_l_d_1*t335 + D_p_z_3_by_l_d_1*t419
        + mu_1_by_l_d_1*t374 + mu_2_by_l_d_1*t374 + mu_3_by_l_d_1*t375,
        D_p_x_3_by_l_d_1*k_C, D_p_y_3_by_l_d_1*k_C, D_p_z_3_by_l_d_1*k_C, t185*t549, t550, -t185*t548, t551,
        D_delta_x_1_by_l_d_1*t377 + D_delta_y_1_by_l_d_1*t378 + D_delta_z_1_by_l_d_1*t379
        + mu_1_by_l_d_1*t380 - mu_2_by_l_d_1*t376 - mu_3_by_l_d_1*t376,
        D_delta_x_1_by_l_d_1*t382 + D_delta_x_2_by_l_d_1*t383 + D_delta_y_1_by_l_d_1*t384
        + D_delta_y_2_by_l_d_1*t385 + D_delta_z_1_by_l_d_1*t386 + D_delta_z_2_by_l_d_1*t387
        + mu_1_by_l_d_1*t381 + mu_2_by_l_d_1*t381 + mu_3_by_l_d_1*t381,
        D_delta_x_1_by_l_d_1*t389 + D_delta_x_3_by_l_d_1*t383 + D_delta_y_1_by_l_d_1*t390
        + D_delta_y_3_by_l_d_1*t385 + D_delta_z_1_by_l_d_1*t391 + D_delta_z_3_by_l_d_1*t387
        + mu_1_by_l_d_1*t388 + mu_2_by_l_d_1*t388 + mu_3_by_l_d_1*t388,
        D_delta_x_1_by_l_d_1*k_C, D_delta_y_1_by_l_d_1*k_C, D_delta_z_1_by_l_d_1*k_C,
        D_delta_x_2_by_l_d_1*t393 + D_delta_y_2_by_l_d_1*t394 + D_delta_z_2_by_l_d_1*t395
        - mu_1_by_l_d_1*t392 + mu_2_by_l_d_1*t396 - mu_3_by_l_d_1*t392,
        D_delta_x_2_by_l_d_1*t389 + D_delta_x_3_by_l_d_1*t382 + D_delta_y_2_by_l_d_1*t390
        + D_delta_y_3_by_l_d_1*t384 + D_delta_z_2_by_l_d_1*t391 + D_delta_z_3_by_l_d_1*t386
        + mu_1_by_l_d_1*t397 + mu_2_by_l_d_1*t397 + mu_3_by_l_d_1*t397,
        D_delta_x_2_by_l_d_1*k_C, D_delta_y_2_by_l_d_1*k_C, D_delta_z_2_by_l_d_1*k_C,
        D_delta_x_3_by_l_d_1*t399 + D_delta_y_3_by_l_d_1*t400 + D_delta_z_3_by_l_d_1*t401
        - mu_1_by_l_d_1*t398 - mu_2_by_l_d_1*t398 + mu_3_by_l_d_1*t402,
        D_delta_x_3_by_l_d_1*k_C, D_delta_y_3_by_l_d_1*k_C, D_delta_z_3_by_l_d_1*k_C, t552,
        2*D_p_x_1*D_p_x_1_by_l_d_2*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_2*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_2*k_C
        + mu_1_by_l_d_2*t260 + mu_2_by_l_d_2*t261 + mu_3_by_l_d_2*t261 - t248*t559 - t250*t559 - t251*t559
        - t252*t560 - t254*t560 - t255*t560 - t256*t561 - t258*t561 - t259*t561,
        D_p_x_1*D_p_x_2_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_2*k_C - D_p_x_1_by_l_d_2*t272
        - D_p_x_1_by_l_d_2*t273 - D_p_x_1_by_l_d_2*t274 - D_p_x_2_by_l_d_2*t248 - D_p_x_2_by_l_d_2*t250
        - D_p_x_2_by_l_d_2*t251 + D_p_y_1*D_p_y_2_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_2*k_C
        - D_p_y_1_by_l_d_2*t275 - D_p_y_1_by_l_d_2*t276 - D_p_y_1_by_l_d_2*t277 - D_p_y_2_by_l_d_2*t252
        - D_p_y_2_by_l_d_2*t254 - D_p_y_2_by_l_d_2*t255 + D_p_z_1*D_p_z_2_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_2*k_C - D_p_z_1_by_l_d_2*t278 - D_p_z_1_by_l_d_2*t279
        - D_p_z_1_by_l_d_2*t280 - D_p_z_2_by_l_d_2*t256 - D_p_z_2_by_l_d_2*t258 - D_p_z_2_by_l_d_2*t259
        + mu_1_by_l_d_2*t281 + mu_2_by_l_d_2*t282 + mu_3_by_l_d_2*t283,
        D_p_x_1*D_p_x_3_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_3*k_C - D_p_x_1_by_l_d_2*t284
        - D_p_x_1_by_l_d_2*t285 - D_p_x_1_by_l_d_2*t286 - D_p_x_3_by_l_d_2*t248 - D_p_x_3_by_l_d_2*t250
        - D_p_x_3_by_l_d_2*t251 + D_p_y_1*D_p_y_3_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_3*k_C
        - D_p_y_1_by_l_d_2*t287 - D_p_y_1_by_l_d_2*t288 - D_p_y_1_by_l_d_2*t289 - D_p_y_3_by_l_d_2*t252
        - D_p_y_3_by_l_d_2*t254 - D_p_y_3_by_l_d_2*t255 + D_p_z_1*D_p_z_3_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_3*k_C - D_p_z_1_by_l_d_2*t290 - D_p_z_1_by_l_d_2*t291
        - D_p_z_1_by_l_d_2*t292 - D_p_z_3_by_l_d_2*t256 - D_p_z_3_by_l_d_2*t258 - D_p_z_3_by_l_d_2*t259
        + mu_1_by_l_d_2*t293 + mu_2_by_l_d_2*t294 + mu_3_by_l_d_2*t295,
        D_delta_x_1_by_l_d_2*t313 + D_delta_y_1_by_l_d_2*t314 + D_delta_z_1_by_l_d_2*t315
        - D_p_x_1_by_l_d_2*t302 - D_p_x_1_by_l_d_2*t303 - D_p_x_1_by_l_d_2*t304 + D_p_x_1_by_l_d_2*t411
        - D_p_y_1_by_l_d_2*t305 - D_p_y_1_by_l_d_2*t306 - D_p_y_1_by_l_d_2*t307 + D_p_y_1_by_l_d_2*t412
        - D_p_z_1_by_l_d_2*t308 - D_p_z_1_by_l_d_2*t309 - D_p_z_1_by_l_d_2*t310 + D_p_z_1_by_l_d_2*t413
        + mu_1_by_l_d_2*t311 + mu_2_by_l_d_2*t312 + mu_3_by_l_d_2*t312,
        D_delta_x_2_by_l_d_2*t313 + D_delta_y_2_by_l_d_2*t314 + D_delta_z_2_by_l_d_2*t315
        - D_p_x_1_by_l_d_2*t316 - D_p_x_1_by_l_d_2*t317 - D_p_x_1_by_l_d_2*t318 + D_p_x_1_by_l_d_2*t414
        - D_p_y_1_by_l_d_2*t319 - D_p_y_1_by_l_d_2*t320 - D_p_y_1_by_l_d_2*t321 + D_p_y_1_by_l_d_2*t415
        - D_p_z_1_by_l_d_2*t322 - D_p_z_1_by_l_d_2*t323 - D_p_z_1_by_l_d_2*t324 + D_p_z_1_by_l_d_2*t416
        + mu_1_by_l_d_2*t325 + mu_2_by_l_d_2*t326 + mu_3_by_l_d_2*t326,
        D_delta_x_3_by_l_d_2*t313 + D_delta_y_3_by_l_d_2*t314 + D_delta_z_3_by_l_d_2*t315
        - D_p_x_1_by_l_d_2*t327 - D_p_x_1_by_l_d_2*t328 - D_p_x_1_by_l_d_2*t329 + D_p_x_1_by_l_d_2*t417
        - D_p_y_1_by_l_d_2*t330 - D_p_y_1_by_l_d_2*t331 - D_p_y_1_by_l_d_2*t332 + D_p_y_1_by_l_d_2*t418
        - D_p_z_1_by_l_d_2*t333 - D_p_z_1_by_l_d_2*t334 - D_p_z_1_by_l_d_2*t335 + D_p_z_1_by_l_d_2*t419
        + mu_1_by_l_d_2*t336 + mu_2_by_l_d_2*t337 + mu_3_by_l_d_2*t337,
        D_p_x_1_by_l_d_2*k_C, D_p_y_1_by_l_d_2*k_C, D_p_z_1_by_l_d_2*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_2*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_2*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_2*k_C
        + k_sp_2*t262*t448*t455*w_b_2*x_2_by_l_d_2 + mu_1_by_l_d_2*t342 + mu_2_by_l_d_2*t343
        + mu_3_by_l_d_2*t342 - t272*t562 - t273*t562 - t274*t562 - t275*t563 - t276*t563 - t277*t563
        - t278*t564 - t279*t564 - t280*t564 - t566,
        D_p_x_2*D_p_x_3_by_l_d_2*k_C + D_p_x_2_by_l_d_2*D_p_x_3*k_C - D_p_x_2_by_l_d_2*t284
        - D_p_x_2_by_l_d_2*t285 - D_p_x_2_by_l_d_2*t286 - D_p_x_3_by_l_d_2*t272 - D_p_x_3_by_l_d_2*t273
        - D_p_x_3_by_l_d_2*t274 + D_p_y_2*D_p_y_3_by_l_d_2*k_C + D_p_y_2_by_l_d_2*D_p_y_3*k_C
        - D_p_y_2_by_l_d_2*t287 - D_p_y_2_by_l_d_2*t288 - D_p_y_2_by_l_d_2*t289 - D_p_y_3_by_l_d_2*t275
        - D_p_y_3_by_l_d_2*t276 - D_p_y_3_by_l_d_2*t277 + D_p_z_2*D_p_z_3_by_l_d_2*k_C
        + D_p_z_2_by_l_d_2*D_p_z_3*k_C - D_p_z_2_by_l_d_2*t290 - D_p_z_2_by_l_d_2*t291
        - D_p_z_2_by_l_d_2*t292 - D_p_z_3_by_l_d_2*t278 - D_p_z_3_by_l_d_2*t279 - D_p_z_3_by_l_d_2*t280
        + mu_1_by_l_d_2*t344 + mu_2_by_l_d_2*t345 + mu_3_by_l_d_2*t346,
        t568, t569,
        D_delta_x_1_by_l_d_2*t352 + D_delta_y_1_by_l_d_2*t353 + D_delta_z_1_by_l_d_2*t354
        - D_p_x_2_by_l_d_2*t302 - D_p_x_2_by_l_d_2*t303 - D_p_x_2_by_l_d_2*t304 + D_p_x_2_by_l_d_2*t411
        - D_p_y_2_by_l_d_2*t305 - D_p_y_2_by_l_d_2*t306 - D_p_y_2_by_l_d_2*t307 + D_p_y_2_by_l_d_2*t412
        - D_p_z_2_by_l_d_2*t308 - D_p_z_2_by_l_d_2*t309 - D_p_z_2_by_l_d_2*t310 + D_p_z_2_by_l_d_2*t413
        + mu_1_by_l_d_2*t350 + mu_2_by_l_d_2*t351 + mu_3_by_l_d_2*t350,
        D_delta_x_2_by_l_d_2*t352 + D_delta_y_2_by_l_d_2*t353 + D_delta_z_2_by_l_d_2*t354
        - D_p_x_2_by_l_d_2*t316 - D_p_x_2_by_l_d_2*t317 - D_p_x_2_by_l_d_2*t318 + D_p_x_2_by_l_d_2*t414
        - D_p_y_2_by_l_d_2*t319 - D_p_y_2_by_l_d_2*t320 - D_p_y_2_by_l_d_2*t321 + D_p_y_2_by_l_d_2*t415
        - D_p_z_2_by_l_d_2*t322 - D_p_z_2_by_l_d_2*t323 - D_p_z_2_by_l_d_2*t324 + D_p_z_2_by_l_d_2*t416
        + mu_1_by_l_d_2*t355 + mu_2_by_l_d_2*t356 + mu_3_by_l_d_2*t355,
        D_delta_x_3_by_l_d_2*t352 + D_delta_y_3_by_l_d_2*t353 + D_delta_z_3_by_l_d_2*t354
        - D_p_x_2_by_l_d_2*t327 - D_p_x_2_by_l_d_2*t328 - D_p_x_2_by_l_d_2*t329 + D_p_x_2_by_l_d_2*t417
        - D_p_y_2_by_l_d_2*t330 - D_p_y_2_by_l_d_2*t331 - D_p_y_2_by_l_d_2*t332 + D_p_y_2_by_l_d_2*t418
        - D_p_z_2_by_l_d_2*t333 - D_p_z_2_by_l_d_2*t334 - D_p_z_2_by_l_d_2*t335 + D_p_z_2_by_l_d_2*t419
        + mu_1_by_l_d_2*t357 + mu_2_by_l_d_2*t358 + mu_3_by_l_d_2*t357,
        t570, D_p_x_2_by_l_d_2*k_C, D_p_y_2_by_l_d_2*k_C, D_p_z_2_by_l_d_2*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_2*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_2*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_2*k_C
        + mu_1_by_l_d_2*t362 + mu_2_by_l_d_2*t362 + mu_3_by_l_d_2*t363 - t284*t571 - t285*t571 - t286*t571
        - t287*t572 - t288*t572 - t289*t572 - t290*t573 - t291*t573 - t292*t573,
        D_delta_x_1_by_l_d_2*t369 + D_delta_y_1_by_l_d_2*t370 + D_delta_z_1_by_l_d_2*t371
        - D_p_x_3_by_l_d_2*t302 - D_p_x_3_by_l_d_2*t303 - D_p_x_3_by_l_d_2*t304 + D_p_x_3_by_l_d_2*t411
        - D_p_y_3_by_l_d_2*t305 - D_p_y_3_by_l_d_2*t306 - D_p_y_3_by_l_d_2*t307 + D_p_y_3_by_l_d_2*t412
        - D_p_z_3_by_l_d_2*t308 - D_p_z_3_by_l_d_2*t309 - D_p_z_3_by_l_d_2*t310 + D_p_z_3_by_l_d_2*t413
        + mu_1_by_l_d_2*t367 + mu_2_by_l_d_2*t367 + mu_3_by_l_d_2*t368,
        D_delta_x_2_by_l_d_2*t369 + D_delta_y_2_by_l_d_2*t370 + D_delta_z_2_by_l_d_2*t371
        - D_p_x_3_by_l_d_2*t316 - D_p_x_3_by_l_d_2*t317 - D_p_x_3_by_l_d_2*t318 + D_p_x_3_by_l_d_2*t414
        - D_p_y_3_by_l_d_2*t319 - D_p_y_3_by_l_d_2*t320 - D_p_y_3_by_l_d_2*t321 + D_p_y_3_by_l_d_2*t415
        - D_p_z_3_by_l_d_2*t322 - D_p_z_3_by_l_d_2*t323 - D_p_z_3_by_l_d_2*t324 + D_p_z_3_by_l_d_2*t416
        + mu_1_by_l_d_2*t372 + mu_2_by_l_d_2*t372 + mu_3_by_l_d_2*t373,
        D_delta_x_3_by_l_d_2*t369 + D_delta_y_3_by_l_d_2*t370 + D_delta_z_3_by_l_d_2*t371
        - D_p_x_3_by_l_d_2*t327 - D_p_x_3_by_l_d_2*t328 - D_p_x_3_by_l_d_2*t329 + D_p_x_3_by_l_d_2*t417
        - D_p_y_3_by_l_d_2*t330 - D_p_y_3_by_l_d_2*t331 - D_p_y_3_by_l_d_2*t332 + D_p_y_3_by_l_d_2*t418
        - D_p_z_3_by_l_d_2*t333 - D_p_z_3_by_l_d_2*t334 - D_p_z_3_by_l_d_2*t335 + D_p_z_3_by_l_d_2*t419
        + mu_1_by_l_d_2*t374 + mu_2_by_l_d_2*t374 + mu_3_by_l_d_2*t375,
        D_p_x_3_by_l_d_2*k_C, D_p_y_3_by_l_d_2*k_C, D_p_z_3_by_l_d_2*k_C, t218*t567, t568, -t218*t566, t569,
        D_delta_x_1_by_l_d_2*t377 + D_delta_y_1_by_l_d_2*t378 + D_delta_z_1_by_l_d_2*t379
        + mu_1_by_l_d_2*t380 - mu_2_by_l_d_2*t376 - mu_3_by_l_d_2*t376,
        D_delta_x_1_by_l_d_2*t382 + D_delta_x_2_by_l_d_2*t383 + D_delta_y_1_by_l_d_2*t384
        + D_delta_y_2_by_l_d_2*t385 + D_delta_z_1_by_l_d_2*t386 + D_delta_z_2_by_l_d_2*t387
        + mu_1_by_l_d_2*t381 + mu_2_by_l_d_2*t381 + mu_3_by_l_d_2*t381,
        D_delta_x_1_by_l_d_2*t389 + D_delta_x_3_by_l_d_2*t383 + D_delta_y_1_by_l_d_2*t390
        + D_delta_y_3_by_l_d_2*t385 + D_delta_z_1_by_l_d_2*t391 + D_delta_z_3_by_l_d_2*t387
        + mu_1_by_l_d_2*t388 + mu_2_by_l_d_2*t388 + mu_3_by_l_d_2*t388,
        D_delta_x_1_by_l_d_2*k_C, D_delta_y_1_by_l_d_2*k_C, D_delta_z_1_by_l_d_2*k_C,
        D_delta_x_2_by_l_d_2*t393 + D_delta_y_2_by_l_d_2*t394 + D_delta_z_2_by_l_d_2*t395
        - mu_1_by_l_d_2*t392 + mu_2_by_l_d_2*t396 - mu_3_by_l_d_2*t392,
        D_delta_x_2_by_l_d_2*t389 + D_delta_x_3_by_l_d_2*t382 + D_delta_y_2_by_l_d_2*t390
        + D_delta_y_3_by_l_d_2*t384 + D_delta_z_2_by_l_d_2*t391 + D_delta_z_3_by_l_d_2*t386
        + mu_1_by_l_d_2*t397 + mu_2_by_l_d_2*t397 + mu_3_by_l_d_2*t397,
        D_delta_x_2_by_l_d_2*k_C, D_delta_y_2_by_l_d_2*k_C, D_delta_z_2_by_l_d_2*k_C,
        D_delta_x_3_by_l_d_2*t399 + D_delta_y_3_by_l_d_2*t400 + D_delta_z_3_by_l_d_2*t401
        - mu_1_by_l_d_2*t398 - mu_2_by_l_d_2*t398 + mu_3_by_l_d_2*t402,
        D_delta_x_3_by_l_d_2*k_C, D_delta_y_3_by_l_d_2*k_C, D_delta_z_3_by_l_d_2*k_C, t570,
        2*D_p_x_1*D_p_x_1_by_l_d_3*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_3*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_3*k_C
        + mu_1_by_l_d_3*t260 + mu_2_by_l_d_3*t261 + mu_3_by_l_d_3*t261 - t248*t574 - t250*t574 - t251*t574
        - t252*t575 - t254*t575 - t255*t575 - t256*t576 - t258*t576 - t259*t576,
        D_p_x_1*D_p_x_2_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_2*k_C - D_p_x_1_by_l_d_3*t272
        - D_p_x_1_by_l_d_3*t273 - D_p_x_1_by_l_d_3*t274 - D_p_x_2_by_l_d_3*t248 - D_p_x_2_by_l_d_3*t250
        - D_p_x_2_by_l_d_3*t251 + D_p_y_1*D_p_y_2_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_2*k_C
        - D_p_y_1_by_l_d_3*t275 - D_p_y_1_by_l_d_3*t276 - D_p_y_1_by_l_d_3*t277 - D_p_y_2_by_l_d_3*t252
        - D_p_y_2_by_l_d_3*t254 - D_p_y_2_by_l_d_3*t255 + D_p_z_1*D_p_z_2_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_2*k_C - D_p_z_1_by_l_d_3*t278 - D_p_z_1_by_l_d_3*t279
        - D_p_z_1_by_l_d_3*t280 - D_p_z_2_by_l_d_3*t256 - D_p_z_2_by_l_d_3*t258 - D_p_z_2_by_l_d_3*t259
        + mu_1_by_l_d_3*t281 + mu_2_by_l_d_3*t282 + mu_3_by_l_d_3*t283,
        D_p_x_1*D_p_x_3_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_3*k_C - D_p_x_1_by_l_d_3*t284
        - D_p_x_1_by_l_d_3*t285 - D_p_x_1_by_l_d_3*t286 - D_p_x_3_by_l_d_3*t248 - D_p_x_3_by_l_d_3*t250
        - D_p_x_3_by_l_d_3*t251 + D_p_y_1*D_p_y_3_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_3*k_C
        - D_p_y_1_by_l_d_3*t287 - D_p_y_1_by_l_d_3*t288 - D_p_y_1_by_l_d_3*t289 - D_p_y_3_by_l_d_3*t252
        - D_p_y_3_by_l_d_3*t254 - D_p_y_3_by_l_d_3*t255 + D_p_z_1*D_p_z_3_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_3*k_C - D_p_z_1_by_l_d_3*t290 - D_p_z_1_by_l_d_3*t291
        - D_p_z_1_by_l_d_3*t292 - D_p_z_3_by_l_d_3*t256 - D_p_z_3_by_l_d_3*t258 - D_p_z_3_by_l_d_3*t259
        + mu_1_by_l_d_3*t293 + mu_2_by_l_d_3*t294 + mu_3_by_l_d_3*t295,
        D_delta_x_1_by_l_d_3*t313 + D_delta_y_1_by_l_d_3*t314 + D_delta_z_1_by_l_d_3*t315
        - D_p_x_1_by_l_d_3*t302 - D_p_x_1_by_l_d_3*t303 - D_p_x_1_by_l_d_3*t304 + D_p_x_1_by_l_d_3*t411
        - D_p_y_1_by_l_d_3*t305 - D_p_y_1_by_l_d_3*t306 - D_p_y_1_by_l_d_3*t307 + D_p_y_1_by_l_d_3*t412
        - D_p_z_1_by_l_d_3*t308 - D_p_z_1_by_l_d_3*t309 - D_p_z_1_by_l_d_3*t310 + D_p_z_1_by_l_d_3*t413
        + mu_1_by_l_d_3*t311 + mu_2_by_l_d_3*t312 + mu_3_by_l_d_3*t312,
        D_delta_x_2_by_l_d_3*t313 + D_delta_y_2_by_l_d_3*t314 + D_delta_z_2_by_l_d_3*t315
        - D_p_x_1_by_l_d_3*t316 - D_p_x_1_by_l_d_3*t317 - D_p_x_1_by_l_d_3*t318 + D_p_x_1_by_l_d_3*t414
        - D_p_y_1_by_l_d_3*t319 - D_p_y_1_by_l_d_3*t320 - D_p_y_1_by_l_d_3*t321 + D_p_y_1_by_l_d_3*t415
        - D_p_z_1_by_l_d_3*t322 - D_p_z_1_by_l_d_3*t323 - D_p_z_1_by_l_d_3*t324 + D_p_z_1_by_l_d_3*t416
        + mu_1_by_l_d_3*t325 + mu_2_by_l_d_3*t326 + mu_3_by_l_d_3*t326,
        D_delta_x_3_by_l_d_3*t313 + D_delta_y_3_by_l_d_3*t314 + D_delta_z_3_by_l_d_3*t315
        - D_p_x_1_by_l_d_3*t327 - D_p_x_1_by_l_d_3*t328 - D_p_x_1_by_l_d_3*t329 + D_p_x_1_by_l_d_3*t417
        - D_p_y_1_by_l_d_3*t330 - D_p_y_1_by_l_d_3*t331 - D_p_y_1_by_l_d_3*t332 + D_p_y_1_by_l_d_3*t418
        - D_p_z_1_by_l_d_3*t333 - D_p_z_1_by_l_d_3*t334 - D_p_z_1_by_l_d_3*t335 + D_p_z_1_by_l_d_3*t419
        + mu_1_by_l_d_3*t336 + mu_2_by_l_d_3*t337 + mu_3_by_l_d_3*t337,
        D_p_x_1_by_l_d_3*k_C, D_p_y_1_by_l_d_3*k_C, D_p_z_1_by_l_d_3*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_3*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_3*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_3*k_C
        + mu_1_by_l_d_3*t342 + mu_2_by_l_d_3*t343 + mu_3_by_l_d_3*t342 - t272*t577 - t273*t577 - t274*t577
        - t275*t578 - t276*t578 - t277*t578 - t278*t579 - t279*t579 - t280*t579,
        D_p_x_2*D_p_x_3_by_l_d_3*k_C + D_p_x_2_by_l_d_3*D_p_x_3*k_C - D_p_x_2_by_l_d_3*t284
        - D_p_x_2_by_l_d_3*t285 - D_p_x_2_by_l_d_3*t286 - D_p_x_3_by_l_d_3*t272 - D_p_x_3_by_l_d_3*t273
        - D_p_x_3_by_l_d_3*t274 + D_p_y_2*D_p_y_3_by_l_d_3*k_C + D_p_y_2_by_l_d_3*D_p_y_3*k_C
        - D_p_y_2_by_l_d_3*t287 - D_p_y_2_by_l_d_3*t288 - D_p_y_2_by_l_d_3*t289 - D_p_y_3_by_l_d_3*t275
        - D_p_y_3_by_l_d_3*t276 - D_p_y_3_by_l_d_3*t277 + D_p_z_2*D_p_z_3_by_l_d_3*k_C
        + D_p_z_2_by_l_d_3*D_p_z_3*k_C - D_p_z_2_by_l_d_3*t290 - D_p_z_2_by_l_d_3*t291
        - D_p_z_2_by_l_d_3*t292 - D_p_z_3_by_l_d_3*t278 - D_p_z_3_by_l_d_3*t279 - D_p_z_3_by_l_d_3*t280
        + mu_1_by_l_d_3*t344 + mu_2_by_l_d_3*t345 + mu_3_by_l_d_3*t346,
        D_delta_x_1_by_l_d_3*t352 + D_delta_y_1_by_l_d_3*t353 + D_delta_z_1_by_l_d_3*t354
        - D_p_x_2_by_l_d_3*t302 - D_p_x_2_by_l_d_3*t303 - D_p_x_2_by_l_d_3*t304 + D_p_x_2_by_l_d_3*t411
        - D_p_y_2_by_l_d_3*t305 - D_p_y_2_by_l_d_3*t306 - D_p_y_2_by_l_d_3*t307 + D_p_y_2_by_l_d_3*t412
        - D_p_z_2_by_l_d_3*t308 - D_p_z_2_by_l_d_3*t309 - D_p_z_2_by_l_d_3*t310 + D_p_z_2_by_l_d_3*t413
        + mu_1_by_l_d_3*t350 + mu_2_by_l_d_3*t351 + mu_3_by_l_d_3*t350,
        D_delta_x_2_by_l_d_3*t352 + D_delta_y_2_by_l_d_3*t353 + D_delta_z_2_by_l_d_3*t354
        - D_p_x_2_by_l_d_3*t316 - D_p_x_2_by_l_d_3*t317 - D_p_x_2_by_l_d_3*t318 + D_p_x_2_by_l_d_3*t414
        - D_p_y_2_by_l_d_3*t319 - D_p_y_2_by_l_d_3*t320 - D_p_y_2_by_l_d_3*t321 + D_p_y_2_by_l_d_3*t415
        - D_p_z_2_by_l_d_3*t322 - D_p_z_2_by_l_d_3*t323 - D_p_z_2_by_l_d_3*t324 + D_p_z_2_by_l_d_3*t416
        + mu_1_by_l_d_3*t355 + mu_2_by_l_d_3*t356 + mu_3_by_l_d_3*t355,
        D_delta_x_3_by_l_d_3*t352 + D_delta_y_3_by_l_d_3*t353 + D_delta_z_3_by_l_d_3*t354
        - D_p_x_2_by_l_d_3*t327 - D_p_x_2_by_l_d_3*t328 - D_p_x_2_by_l_d_3*t329 + D_p_x_2_by_l_d_3*t417
        - D_p_y_2_by_l_d_3*t330 - D_p_y_2_by_l_d_3*t331 - D_p_y_2_by_l_d_3*t332 + D_p_y_2_by_l_d_3*t418
        - D_p_z_2_by_l_d_3*t333 - D_p_z_2_by_l_d_3*t334 - D_p_z_2_by_l_d_3*t335 + D_p_z_2_by_l_d_3*t419
        + mu_1_by_l_d_3*t357 + mu_2_by_l_d_3*t358 + mu_3_by_l_d_3*t357,
        D_p_x_2_by_l_d_3*k_C, D_p_y_2_by_l_d_3*k_C, D_p_z_2_by_l_d_3*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_3*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_3*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_3*k_C
        + k_sp_3*t262*t502*t509*w_b_3*x_3_by_l_d_3 + mu_1_by_l_d_3*t362 + mu_2_by_l_d_3*t362
        + mu_3_by_l_d_3*t363 - t284*t580 - t285*t580 - t286*t580 - t287*t581 - t288*t581 - t289*t581
        - t290*t582 - t291*t582 - t292*t582 - t584,
        t586, t587,
        D_delta_x_1_by_l_d_3*t369 + D_delta_y_1_by_l_d_3*t370 + D_delta_z_1_by_l_d_3*t371
        - D_p_x_3_by_l_d_3*t302 - D_p_x_3_by_l_d_3*t303 - D_p_x_3_by_l_d_3*t304 + D_p_x_3_by_l_d_3*t411
        - D_p_y_3_by_l_d_3*t305 - D_p_y_3_by_l_d_3*t306 - D_p_y_3_by_l_d_3*t307 + D_p_y_3_by_l_d_3*t412
        - D_p_z_3_by_l_d_3*t308 - D_p_z_3_by_l_d_3*t309 - D_p_z_3_by_l_d_3*t310 + D_p_z_3_by_l_d_3*t413
        + mu_1_by_l_d_3*t367 + mu_2_by_l_d_3*t367 + mu_3_by_l_d_3*t368,
        D_delta_x_2_by_l_d_3*t369 + D_delta_y_2_by_l_d_3*t370 + D_delta_z_2_by_l_d_3*t371
        - D_p_x_3_by_l_d_3*t316 - D_p_x_3_by_l_d_3*t317 - D_p_x_3_by_l_d_3*t318 + D_p_x_3_by_l_d_3*t414
        - D_p_y_3_by_l_d_3*t319 - D_p_y_3_by_l_d_3*t320 - D_p_y_3_by_l_d_3*t321 + D_p_y_3_by_l_d_3*t415
        - D_p_z_3_by_l_d_3*t322 - D_p_z_3_by_l_d_3*t323 - D_p_z_3_by_l_d_3*t324 + D_p_z_3_by_l_d_3*t416
        + mu_1_by_l_d_3*t372 + mu_2_by_l_d_3*t372 + mu_3_by_l_d_3*t373,
        D_delta_x_3_by_l_d_3*t369 + D_delta_y_3_by_l_d_3*t370 + D_delta_z_3_by_l_d_3*t371
        - D_p_x_3_by_l_d_3*t327 - D_p_x_3_by_l_d_3*t328 - D_p_x_3_by_l_d_3*t329 + D_p_x_3_by_l_d_3*t417
        - D_p_y_3_by_l_d_3*t330 - D_p_y_3_by_l_d_3*t331 - D_p_y_3_by_l_d_3*t332 + D_p_y_3_by_l_d_3*t418
        - D_p_z_3_by_l_d_3*t333 - D_p_z_3_by_l_d_3*t334 - D_p_z_3_by_l_d_3*t335 + D_p_z_3_by_l_d_3*t419
        + mu_1_by_l_d_3*t374 + mu_2_by_l_d_3*t374 + mu_3_by_l_d_3*t375,
        t588, D_p_x_3_by_l_d_3*k_C, D_p_y_3_by_l_d_3*k_C, D_p_z_3_by_l_d_3*k_C, t230*t585, t586, -t230*t584,
        t587,
        D_delta_x_1_by_l_d_3*t377 + D_delta_y_1_by_l_d_3*t378 + D_delta_z_1_by_l_d_3*t379
        + mu_1_by_l_d_3*t380 - mu_2_by_l_d_3*t376 - mu_3_by_l_d_3*t376,
        D_delta_x_1_by_l_d_3*t382 + D_delta_x_2_by_l_d_3*t383 + D_delta_y_1_by_l_d_3*t384
        + D_delta_y_2_by_l_d_3*t385 + D_delta_z_1_by_l_d_3*t386 + D_delta_z_2_by_l_d_3*t387
        + mu_1_by_l_d_3*t381 + mu_2_by_l_d_3*t381 + mu_3_by_l_d_3*t381,
        D_delta_x_1_by_l_d_3*t389 + D_delta_x_3_by_l_d_3*t383 + D_delta_y_1_by_l_d_3*t390
        + D_delta_y_3_by_l_d_3*t385 + D_delta_z_1_by_l_d_3*t391 + D_delta_z_3_by_l_d_3*t387
        + mu_1_by_l_d_3*t388 + mu_2_by_l_d_3*t388 + mu_3_by_l_d_3*t388,
        D_delta_x_1_by_l_d_3*k_C, D_delta_y_1_by_l_d_3*k_C, D_delta_z_1_by_l_d_3*k_C,
        D_delta_x_2_by_l_d_3*t393 + D_delta_y_2_by_l_d_3*t394 + D_delta_z_2_by_l_d_3*t395
        - mu_1_by_l_d_3*t392 + mu_2_by_l_d_3*t396 - mu_3_by_l_d_3*t392,
        D_delta_x_2_by_l_d_3*t389 + D_delta_x_3_by_l_d_3*t382 + D_delta_y_2_by_l_d_3*t390
        + D_delta_y_3_by_l_d_3*t384 + D_delta_z_2_by_l_d_3*t391 + D_delta_z_3_by_l_d_3*t386
        + mu_1_by_l_d_3*t397 + mu_2_by_l_d_3*t397 + mu_3_by_l_d_3*t397,
        D_delta_x_2_by_l_d_3*k_C, D_delta_y_2_by_l_d_3*k_C, D_delta_z_2_by_l_d_3*k_C,
        D_delta_x_3_by_l_d_3*t399 + D_delta_y_3_by_l_d_3*t400 + D_delta_z_3_by_l_d_3*t401
        - mu_1_by_l_d_3*t398 - mu_2_by_l_d_3*t398 + mu_3_by_l_d_3*t402,
        D_delta_x_3_by_l_d_3*k_C, D_delta_y_3_by_l_d_3*k_C, D_delta_z_3_by_l_d_3*k_C, t588,
    ))
    return M_theta_out, K_theta_out
