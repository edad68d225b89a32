# Generated from the derivation of linear_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism linear_delta with effects: extended matrices and sensitivities.

Arrays are batch first: a leading `...` stands for any batch shape, none included, and arguments broadcast.
Complex arguments are accepted (for derivatives by complex step).  Everything is in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code, for axis j; pulley k, or carriage k of a derivative; belt span s; component i = x, y, z.
t1, t2, ... are subexpressions that several values share.

* x_j [m]: position of carriage j along its rail
* l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* r_j_i [m]: platform joint j seen from the origin of rail j, component i
* s_j_i [m]: linkage vector j, from carriage to platform joint, component i
* a_j [m]: coordinate of platform joint j along rail j
* w_j_i [m]: vector from rail j square to platform joint j, component i
* w2_j [m^2]: squared distance of platform joint j from rail j
* D_r_j [m]: entry of D_r for axis j: linkage vector along the rail
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [1]: platform Jacobian, dp_i/dx_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* U_j_i_k [1]: derivative of linkage vector j, component i, by x_k
* I_j_k [kg m^2]: moment of inertia of pulley k of axis j, with the motor where it is driven
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* G_j [N]: gradient of the gravitational potential energy by x_j
* tau_st_j [N m]: static torque on the driven pulley of axis j
* det_j [N^2 m]: determinant of the equilibrium of axis j
* theta_j_k_st [rad]: static rotation of pulley k of axis j from the unstrained belts
* X_by_Y [unit of X by unit of Y]: derivative of X by the parameter Y, at a fixed pose
"""

from math import prod
from typing import NamedTuple

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "Effects",
    "EFFECTS",
    "VALUE_SENSITIVITIES",
    "GEOMETRY_SENSITIVITIES",
    "extended_matrices",
    "extended_platform_motion",
    "extended_static_equilibrium",
    "geometry_sensitivities",
    "joint_stiffness",
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

#: The effects: name, sentence, whether it ties the platform to ground, released coordinates, and parameters
#: as (name, unit, description, exclusive lower bound, whether it can be fitted).
EFFECTS = (
    ('axis_belt_stiffness', 'the belts of the three axes are not equally stiff', False, (),
     (('factor_1', '1', 'relative change of the belt stiffness of axis 1', -1.0, True),
      ('factor_2', '1', 'relative change of the belt stiffness of axis 2', -1.0, True),
      ('factor_3', '1', 'relative change of the belt stiffness of axis 3', -1.0, True))),
    ('belt_end_compliance', 'the belts yield at their teeth and clamps too', False, (),
     (('compliance', 'm/N', 'compliance in series with every free span', 0.0, True),)),
    ('belt_mass', 'the belts are not massless', False, (),
     (('linear_density', 'kg/m', 'mass of a belt by its length', 0.0, True),)),
    ('cable_stiffness', 'a cable or hose ties the platform to ground', True, (),
     (('stiffness', 'N/m', 'isotropic stiffness from the platform centre to ground', 0.0, True),)),
    ('gearbox_inertia', 'the gearboxes have an inertia of their own', False, (),
     (('inertia', 'kg m^2', 'extra inertia on every driven pulley', 0.0, True),)),
    ('payload', 'the platform carries a mass that is not declared', False, (),
     (('mass', 'kg', 'point mass at the platform centre', 0.0, True),)),
    ('servo_stiffness', 'the position loops hold the driven pulleys', True, (),
     (('stiffness', 'N m/rad', 'torsional stiffness to ground at every driven pulley', 0.0, True),)),
    ('gearbox_compliance', 'the gearboxes wind up', False, ('psi_1', 'psi_2', 'psi_3'),
     (('compliance', 'rad/(N m)', 'compliance of every gearbox, output side', 0.0, True),)),
    ('link_compliance', 'the linkages stretch', False, ('delta_1', 'delta_2', 'delta_3'),
     (('compliance', 'm/N', 'axial compliance of every linkage', 0.0, True),)),
    ('clamp_compliance', "the belts' clamps yield on their carriages", False,
     ('eps_1', 'eps_2', 'eps_3'),
     (('compliance', 'm/N', 'compliance of every belt clamp', 0.0, True),)),
    ('frame_compliance', 'the frame moves', False, ('u_x', 'u_y', 'u_z'),
     (('compliance', 'm/N', 'isotropic compliance of the frame', 0.0, True),
      ('mass', 'kg', 'mass of the frame', 0.0, False))),
)

#: By which parameters the derivatives are taken: field of Parameters or Effects, index in it, and the (row,
#: column) of the entries of M and of K that depend on it, in the upper triangle.
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
    ('limits', (1, 0), ((1, 1), (1, 7), (1, 16), (4, 4), (4, 7), (7, 7), (7, 16), (16, 16)),
     ((1, 1), (1, 7), (1, 16), (4, 4), (4, 7), (7, 7), (7, 16), (16, 16))),
    ('limits', (2, 0), ((2, 2), (2, 8), (2, 17), (5, 5), (5, 8), (8, 8), (8, 17), (17, 17)),
     ((2, 2), (2, 8), (2, 17), (5, 5), (5, 8), (8, 8), (8, 17), (17, 17))),
    ('limits', (0, 1), ((0, 0), (0, 3), (0, 15), (3, 3), (3, 6), (3, 15), (6, 6), (15, 15)),
     ((0, 0), (0, 3), (0, 15), (3, 3), (3, 6), (3, 15), (6, 6), (15, 15))),
    ('limits', (1, 1), ((1, 1), (1, 4), (1, 16), (4, 4), (4, 7), (4, 16), (7, 7), (16, 16)),
     ((1, 1), (1, 4), (1, 16), (4, 4), (4, 7), (4, 16), (7, 7), (16, 16))),
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
    ('belt_mass_linear_density', (),
     ((0, 0), (0, 3), (0, 6), (0, 15), (1, 1), (1, 4), (1, 7), (1, 16), (2, 2), (2, 5), (2, 8), (2, 17),
      (3, 3), (3, 6), (3, 15), (4, 4), (4, 7), (4, 16), (5, 5), (5, 8), (5, 17), (6, 6), (6, 15),
      (7, 7), (7, 16), (8, 8), (8, 17), (15, 15), (16, 16), (17, 17)),
     ()),
    ('cable_stiffness_stiffness', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20))),
    ('gearbox_inertia_inertia', (), ((3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8)), ()),
    ('payload_mass', (),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (0, 18), (0, 19), (0, 20), (1, 1), (1, 2),
      (1, 12), (1, 13), (1, 14), (1, 18), (1, 19), (1, 20), (2, 2), (2, 12), (2, 13), (2, 14), (2, 18),
      (2, 19), (2, 20), (12, 12), (12, 13), (12, 14), (12, 18), (12, 19), (12, 20), (13, 13), (13, 14),
      (13, 18), (13, 19), (13, 20), (14, 14), (14, 18), (14, 19), (14, 20), (18, 18), (19, 19),
      (20, 20)),
     ((0, 0), (0, 1), (0, 2), (0, 12), (0, 13), (0, 14), (1, 1), (1, 2), (1, 12), (1, 13), (1, 14),
      (2, 2), (2, 12), (2, 13), (2, 14), (12, 12), (12, 13), (12, 14), (13, 13), (13, 14), (14, 14))),
    ('servo_stiffness_stiffness', (), (), ((3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8))),
    ('frame_compliance_mass', (), ((18, 18), (19, 19), (20, 20)), ()),
)

#: The same for the geometry, which moves the carriages.
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
    """Effects of a robot; every field may have leading batch axes of its own.

    Attributes
    ----------
    axis_belt_stiffness_factor_1 : float or array, shape (...) [1]
        Relative change of the belt stiffness of axis 1.
    axis_belt_stiffness_factor_2 : float or array, shape (...) [1]
        Relative change of the belt stiffness of axis 2.
    axis_belt_stiffness_factor_3 : float or array, shape (...) [1]
        Relative change of the belt stiffness of axis 3.
    belt_end_compliance_compliance : float or array, shape (...) [m/N]
        Compliance in series with every free span.
    belt_mass_linear_density : float or array, shape (...) [kg/m]
        Mass of a belt by its length.
    cable_stiffness_stiffness : float or array, shape (...) [N/m]
        Isotropic stiffness from the platform centre to ground.
    gearbox_inertia_inertia : float or array, shape (...) [kg m^2]
        Extra inertia on every driven pulley.
    payload_mass : float or array, shape (...) [kg]
        Point mass at the platform centre.
    servo_stiffness_stiffness : float or array, shape (...) [N m/rad]
        Torsional stiffness to ground at every driven pulley.
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
    """

    axis_belt_stiffness_factor_1: float = 0.0
    axis_belt_stiffness_factor_2: float = 0.0
    axis_belt_stiffness_factor_3: float = 0.0
    belt_end_compliance_compliance: float = 0.0
    belt_mass_linear_density: float = 0.0
    cable_stiffness_stiffness: float = 0.0
    gearbox_inertia_inertia: float = 0.0
    payload_mass: float = 0.0
    servo_stiffness_stiffness: float = 0.0
    gearbox_compliance_compliance: float = 0.0
    link_compliance_compliance: float = 0.0
    clamp_compliance_compliance: float = 0.0
    frame_compliance_compliance: float = 0.0
    frame_compliance_mass: float = 0.0


def _entries(array, shape):
    """Entries of an array of shape (..., *shape), row by row; numbers where there is no batch."""
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
    """Common batch shape and type of the arguments."""
    return np.broadcast_shapes(*map(np.shape, arrays)), np.result_type(float, *arrays)


def _listed(batch, dtype, entries):
    """A vector of these entries for each member of the batch."""
    if not batch:
        return np.array(entries, dtype)
    columns = np.empty((len(entries), *batch), dtype)
    for column, entry in zip(columns, entries):
        column[...] = entry
    return np.moveaxis(columns, 0, -1)


def extended_matrices(p, parameters, effects):
    """Mass and stiffness matrices in the base and all released coordinates, joints free.

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
        Mass matrix; the base model's is the leading block.
    K_el : array, shape (..., 21, 21) [N/m, N, N m]
        Elastic stiffness, released joints free.
    K_g : array, shape (..., 21, 21) [N/m, N, N m]
        Hessian of the gravitational potential energy.

    Notes
    -----
    Equations 24 to 48 with the effects' energies; K = K_el + K_g and the joints' stiffnesses.
    1236 operations; 2335419 with every named value written out.
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
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (I_G,) = _entries(effects.gearbox_inertia_inertia, ())
    (m_L,) = _entries(effects.payload_mass, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    (m_F,) = _entries(effects.frame_compliance_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, I_p_1, I_m_1, i_g_1, d_1_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, k_C, I_G, m_L,
        k_S, m_F)
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
    t13 = I_m_2*i_g_2**2
    t14 = I_G + t13
    I_2_1 = I_p_2 + d_2_1*t14
    t15 = I_m_3*i_g_3**2
    t16 = I_G + t15
    I_3_1 = I_p_3 + d_3_1*t16
    I_1_2 = I_p_1 + d_1_2*t12
    I_2_2 = I_p_2 + d_2_2*t14
    I_3_2 = I_p_3 + d_3_2*t16
    l_f_1_1 = x_max_1 - x_min_1
    t17 = k_sp_1*w_b_1*(a_B_1 + 1)
    t18 = c_E*t17
    k_1_1 = t17/(l_f_1_1 + t18)
    t19 = (1/2)*l_t_1
    l_f_1_2 = -t19 + x_1 - x_min_1
    k_1_2 = t17/(l_f_1_2 + t18)
    l_f_1_3 = -t19 - x_1 + x_max_1
    k_1_3 = t17/(l_f_1_3 + t18)
    l_f_2_1 = x_max_2 - x_min_2
    t20 = k_sp_2*w_b_2*(a_B_2 + 1)
    t21 = c_E*t20
    k_2_1 = t20/(l_f_2_1 + t21)
    t22 = (1/2)*l_t_2
    l_f_2_2 = -t22 + x_2 - x_min_2
    k_2_2 = t20/(l_f_2_2 + t21)
    l_f_2_3 = -t22 - x_2 + x_max_2
    k_2_3 = t20/(l_f_2_3 + t21)
    l_f_3_1 = x_max_3 - x_min_3
    t23 = k_sp_3*w_b_3*(a_B_3 + 1)
    t24 = c_E*t23
    k_3_1 = t23/(l_f_3_1 + t24)
    t25 = (1/2)*l_t_3
    l_f_3_2 = -t25 + x_3 - x_min_3
    k_3_2 = t23/(l_f_3_2 + t24)
    l_f_3_3 = -t25 - x_3 + x_max_3
    k_3_3 = t23/(l_f_3_3 + t24)
    t26 = (1/2)*m_d_1
    t27 = (1/2)*m_d_2
    t28 = (1/2)*m_d_3
    t29 = m_L + m_p
    t30 = t26 + t27 + t28 + t29
    t31 = g_x*t30
    t32 = g_y*t30
    t33 = g_z*t30
    mu_1 = t1*(-A_x_1*t31 - A_y_1*t32 - A_z_1*t33)
    mu_2 = t1*(-A_x_2*t31 - A_y_2*t32 - A_z_2*t33)
    mu_3 = t1*(-A_x_3*t31 - A_y_3*t32 - A_z_3*t33)
    t34 = (1/3)*m_d_1
    t35 = (1/6)*m_d_1
    t36 = n_1_x*t35
    t37 = (1/3)*m_d_2
    t38 = (1/3)*m_d_3
    t39 = t29 + t34 + t37 + t38
    t40 = D_p_x_1*t39
    t41 = t36 + t40
    t42 = n_1_y*t35
    t43 = D_p_y_1*t39
    t44 = t42 + t43
    t45 = n_1_z*t35
    t46 = D_p_z_1*t39
    t47 = t45 + t46
    t48 = (1/3)*rho_b
    t49 = l_f_1_2*t48
    t50 = l_f_1_3*t48
    t51 = t49 + t50
    t52 = (1/6)*m_d_2
    t53 = n_2_x*t52
    t54 = n_2_y*t52
    t55 = n_2_z*t52
    t56 = (1/6)*m_d_3
    t57 = n_3_x*t56
    t58 = n_3_y*t56
    t59 = n_3_z*t56
    t60 = (1/6)*rho_b
    t61 = R_p_1*t60
    t62 = l_f_1_3*t61
    t63 = l_f_1_2*t61
    t64 = t35 + t52 + t56
    t65 = D_p_x_2*t39
    t66 = t53 + t65
    t67 = D_p_y_2*t39
    t68 = t54 + t67
    t69 = D_p_z_2*t39
    t70 = t55 + t69
    t71 = l_f_2_2*t48
    t72 = l_f_2_3*t48
    t73 = t71 + t72
    t74 = R_p_2*t60
    t75 = l_f_2_3*t74
    t76 = l_f_2_2*t74
    t77 = D_p_x_3*t39
    t78 = t57 + t77
    t79 = D_p_y_3*t39
    t80 = t58 + t79
    t81 = D_p_z_3*t39
    t82 = t59 + t81
    t83 = l_f_3_2*t48
    t84 = l_f_3_3*t48
    t85 = t83 + t84
    t86 = R_p_3*t60
    t87 = l_f_3_3*t86
    t88 = l_f_3_2*t86
    t89 = R_p_1**2
    t90 = l_f_1_1*t89
    t91 = t48*t90
    t92 = d_1_1*t11
    t93 = R_p_2**2
    t94 = l_f_2_1*t93
    t95 = t48*t94
    t96 = d_2_1*t13
    t97 = R_p_3**2
    t98 = l_f_3_1*t97
    t99 = t48*t98
    t100 = d_3_1*t15
    t101 = d_1_2*t11
    t102 = d_2_2*t13
    t103 = d_3_2*t15
    t104 = D_delta_x_1**2
    t105 = D_delta_y_1**2
    t106 = D_delta_z_1**2
    t107 = D_delta_x_1*t39
    t108 = D_delta_y_1*t39
    t109 = D_delta_z_1*t39
    t110 = D_delta_x_2**2
    t111 = D_delta_y_2**2
    t112 = D_delta_z_2**2
    t113 = D_delta_x_2*t39
    t114 = D_delta_y_2*t39
    t115 = D_delta_z_2*t39
    t116 = D_delta_x_3**2
    t117 = D_delta_y_3**2
    t118 = D_delta_z_3**2
    t119 = m_F + m_d_1 + m_d_2 + m_d_3 + m_t_1 + m_t_2 + m_t_3 + t29
    t120 = D_p_x_1**2
    t121 = D_p_y_1**2
    t122 = D_p_z_1**2
    t123 = k_1_2 + k_1_3
    t124 = D_p_x_1*k_C
    t125 = D_p_y_1*k_C
    t126 = D_p_z_1*k_C
    t127 = -R_p_1*k_1_3
    t128 = -R_p_1*k_1_2
    t129 = D_p_x_2**2
    t130 = D_p_y_2**2
    t131 = D_p_z_2**2
    t132 = k_2_2 + k_2_3
    t133 = D_p_x_2*k_C
    t134 = D_p_y_2*k_C
    t135 = D_p_z_2*k_C
    t136 = -R_p_2*k_2_3
    t137 = -R_p_2*k_2_2
    t138 = D_p_x_3**2
    t139 = D_p_y_3**2
    t140 = D_p_z_3**2
    t141 = k_3_2 + k_3_3
    t142 = -R_p_3*k_3_3
    t143 = -R_p_3*k_3_2
    t144 = D_p_x_3*k_C
    t145 = D_p_y_3*k_C
    t146 = D_p_z_3*k_C
    t147 = k_1_1*t89
    t148 = k_2_1*t93
    t149 = k_3_1*t97
    t150 = D_delta_x_1*k_C
    t151 = D_delta_y_1*k_C
    t152 = D_delta_z_1*k_C
    t153 = D_delta_x_2*k_C
    t154 = D_delta_y_2*k_C
    t155 = D_delta_z_2*k_C
    t156 = D_p_x_1*mu_3
    t157 = D_p_x_1*mu_2
    t158 = U_1_x_1*mu_1
    t159 = D_p_y_1*mu_3
    t160 = D_p_y_1*mu_2
    t161 = U_1_y_1*mu_1
    t162 = D_p_z_1*mu_3
    t163 = D_p_z_1*mu_2
    t164 = U_1_z_1*mu_1
    t165 = D_p_x_2*mu_1
    t166 = D_p_x_2*mu_3
    t167 = U_2_x_2*mu_2
    t168 = D_p_y_2*mu_1
    t169 = D_p_y_2*mu_3
    t170 = U_2_y_2*mu_2
    t171 = D_p_z_2*mu_1
    t172 = D_p_z_2*mu_3
    t173 = U_2_z_2*mu_2
    t174 = D_delta_x_1*D_p_x_3
    t175 = U_3_x_3*mu_3
    t176 = D_delta_y_1*D_p_y_3
    t177 = U_3_y_3*mu_3
    t178 = D_delta_z_1*D_p_z_3
    t179 = U_3_z_3*mu_3
    t180 = D_delta_x_2*D_p_x_3
    t181 = D_delta_y_2*D_p_y_3
    t182 = D_delta_z_2*D_p_z_3
    t183 = D_delta_x_3*D_p_x_3
    t184 = D_delta_y_3*D_p_y_3
    t185 = D_delta_z_3*D_p_z_3
    t186 = D_delta_x_1*D_delta_x_2
    t187 = D_delta_y_1*D_delta_y_2
    t188 = D_delta_z_1*D_delta_z_2
    t189 = D_delta_x_1*D_delta_x_3
    t190 = D_delta_y_1*D_delta_y_3
    t191 = D_delta_z_1*D_delta_z_3
    t192 = D_delta_x_2*D_delta_x_3
    t193 = D_delta_y_2*D_delta_y_3
    t194 = D_delta_z_2*D_delta_z_3
    M_out = np.zeros((*batch, 21, 21), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t36 + D_p_x_1*t41 + D_p_y_1*t42 + D_p_y_1*t44 + D_p_z_1*t45 + D_p_z_1*t47 + m_t_1 + t34 + t51
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_x_1*t53 + D_p_x_2*t41 + D_p_y_1*t54 + D_p_y_2*t44 + D_p_z_1*t55 + D_p_z_2*t47
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_x_1*t57 + D_p_x_3*t41 + D_p_y_1*t58 + D_p_y_3*t44 + D_p_z_1*t59 + D_p_z_3*t47
    )
    M_out[..., 0, 3] = M_out[..., 3, 0] = t62
    M_out[..., 0, 6] = M_out[..., 6, 0] = t63
    M_out[..., 0, 12] = M_out[..., 12, 0] = D_delta_x_1*t41 + D_delta_y_1*t44 + D_delta_z_1*t47
    M_out[..., 0, 13] = M_out[..., 13, 0] = D_delta_x_2*t41 + D_delta_y_2*t44 + D_delta_z_2*t47
    M_out[..., 0, 14] = M_out[..., 14, 0] = D_delta_x_3*t41 + D_delta_y_3*t44 + D_delta_z_3*t47
    M_out[..., 0, 15] = M_out[..., 15, 0] = t51
    M_out[..., 0, 18] = M_out[..., 18, 0] = D_p_x_1*t64 + m_t_1*n_1_x + n_1_x*t26 + t40
    M_out[..., 0, 19] = M_out[..., 19, 0] = D_p_y_1*t64 + m_t_1*n_1_y + n_1_y*t26 + t43
    M_out[..., 0, 20] = M_out[..., 20, 0] = D_p_z_1*t64 + m_t_1*n_1_z + n_1_z*t26 + t46
    M_out[..., 1, 1] = (
        D_p_x_2*t53 + D_p_x_2*t66 + D_p_y_2*t54 + D_p_y_2*t68 + D_p_z_2*t55 + D_p_z_2*t70 + m_t_2 + t37 + t73
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_x_2*t57 + D_p_x_3*t66 + D_p_y_2*t58 + D_p_y_3*t68 + D_p_z_2*t59 + D_p_z_3*t70
    )
    M_out[..., 1, 4] = M_out[..., 4, 1] = t75
    M_out[..., 1, 7] = M_out[..., 7, 1] = t76
    M_out[..., 1, 12] = M_out[..., 12, 1] = D_delta_x_1*t66 + D_delta_y_1*t68 + D_delta_z_1*t70
    M_out[..., 1, 13] = M_out[..., 13, 1] = D_delta_x_2*t66 + D_delta_y_2*t68 + D_delta_z_2*t70
    M_out[..., 1, 14] = M_out[..., 14, 1] = D_delta_x_3*t66 + D_delta_y_3*t68 + D_delta_z_3*t70
    M_out[..., 1, 16] = M_out[..., 16, 1] = t73
    M_out[..., 1, 18] = M_out[..., 18, 1] = D_p_x_2*t64 + m_t_2*n_2_x + n_2_x*t27 + t65
    M_out[..., 1, 19] = M_out[..., 19, 1] = D_p_y_2*t64 + m_t_2*n_2_y + n_2_y*t27 + t67
    M_out[..., 1, 20] = M_out[..., 20, 1] = D_p_z_2*t64 + m_t_2*n_2_z + n_2_z*t27 + t69
    M_out[..., 2, 2] = (
        D_p_x_3*t57 + D_p_x_3*t78 + D_p_y_3*t58 + D_p_y_3*t80 + D_p_z_3*t59 + D_p_z_3*t82 + m_t_3 + t38 + t85
    )
    M_out[..., 2, 5] = M_out[..., 5, 2] = t87
    M_out[..., 2, 8] = M_out[..., 8, 2] = t88
    M_out[..., 2, 12] = M_out[..., 12, 2] = D_delta_x_1*t78 + D_delta_y_1*t80 + D_delta_z_1*t82
    M_out[..., 2, 13] = M_out[..., 13, 2] = D_delta_x_2*t78 + D_delta_y_2*t80 + D_delta_z_2*t82
    M_out[..., 2, 14] = M_out[..., 14, 2] = D_delta_x_3*t78 + D_delta_y_3*t80 + D_delta_z_3*t82
    M_out[..., 2, 17] = M_out[..., 17, 2] = t85
    M_out[..., 2, 18] = M_out[..., 18, 2] = D_p_x_3*t64 + m_t_3*n_3_x + n_3_x*t28 + t77
    M_out[..., 2, 19] = M_out[..., 19, 2] = D_p_y_3*t64 + m_t_3*n_3_y + n_3_y*t28 + t79
    M_out[..., 2, 20] = M_out[..., 20, 2] = D_p_z_3*t64 + m_t_3*n_3_z + n_3_z*t28 + t81
    M_out[..., 3, 3] = I_1_1 + t50*t89 + t91
    M_out[..., 3, 6] = M_out[..., 6, 3] = t60*t90
    M_out[..., 3, 9] = M_out[..., 9, 3] = t92
    M_out[..., 3, 15] = M_out[..., 15, 3] = t62
    M_out[..., 4, 4] = I_2_1 + t72*t93 + t95
    M_out[..., 4, 7] = M_out[..., 7, 4] = t60*t94
    M_out[..., 4, 10] = M_out[..., 10, 4] = t96
    M_out[..., 4, 16] = M_out[..., 16, 4] = t75
    M_out[..., 5, 5] = I_3_1 + t84*t97 + t99
    M_out[..., 5, 8] = M_out[..., 8, 5] = t60*t98
    M_out[..., 5, 11] = M_out[..., 11, 5] = t100
    M_out[..., 5, 17] = M_out[..., 17, 5] = t87
    M_out[..., 6, 6] = I_1_2 + t49*t89 + t91
    M_out[..., 6, 9] = M_out[..., 9, 6] = t101
    M_out[..., 6, 15] = M_out[..., 15, 6] = t63
    M_out[..., 7, 7] = I_2_2 + t71*t93 + t95
    M_out[..., 7, 10] = M_out[..., 10, 7] = t102
    M_out[..., 7, 16] = M_out[..., 16, 7] = t76
    M_out[..., 8, 8] = I_3_2 + t83*t97 + t99
    M_out[..., 8, 11] = M_out[..., 11, 8] = t103
    M_out[..., 8, 17] = M_out[..., 17, 8] = t88
    M_out[..., 9, 9] = t101 + t92
    M_out[..., 10, 10] = t102 + t96
    M_out[..., 11, 11] = t100 + t103
    M_out[..., 12, 12] = t104*t39 + t105*t39 + t106*t39
    M_out[..., 12, 13] = M_out[..., 13, 12] = D_delta_x_2*t107 + D_delta_y_2*t108 + D_delta_z_2*t109
    M_out[..., 12, 14] = M_out[..., 14, 12] = D_delta_x_3*t107 + D_delta_y_3*t108 + D_delta_z_3*t109
    M_out[..., 12, 18] = M_out[..., 18, 12] = D_delta_x_1*t64 + t107
    M_out[..., 12, 19] = M_out[..., 19, 12] = D_delta_y_1*t64 + t108
    M_out[..., 12, 20] = M_out[..., 20, 12] = D_delta_z_1*t64 + t109
    M_out[..., 13, 13] = t110*t39 + t111*t39 + t112*t39
    M_out[..., 13, 14] = M_out[..., 14, 13] = D_delta_x_3*t113 + D_delta_y_3*t114 + D_delta_z_3*t115
    M_out[..., 13, 18] = M_out[..., 18, 13] = D_delta_x_2*t64 + t113
    M_out[..., 13, 19] = M_out[..., 19, 13] = D_delta_y_2*t64 + t114
    M_out[..., 13, 20] = M_out[..., 20, 13] = D_delta_z_2*t64 + t115
    M_out[..., 14, 14] = t116*t39 + t117*t39 + t118*t39
    M_out[..., 14, 18] = M_out[..., 18, 14] = D_delta_x_3*t39 + D_delta_x_3*t64
    M_out[..., 14, 19] = M_out[..., 19, 14] = D_delta_y_3*t39 + D_delta_y_3*t64
    M_out[..., 14, 20] = M_out[..., 20, 14] = D_delta_z_3*t39 + D_delta_z_3*t64
    M_out[..., 15, 15] = t51
    M_out[..., 16, 16] = t73
    M_out[..., 17, 17] = t85
    M_out[..., 18, 18] = t119
    M_out[..., 19, 19] = t119
    M_out[..., 20, 20] = t119
    K_el_out = np.zeros((*batch, 21, 21), dtype)
    K_el_out[..., 0, 0] = k_C*t120 + k_C*t121 + k_C*t122 + t123
    K_el_out[..., 0, 1] = K_el_out[..., 1, 0] = D_p_x_2*t124 + D_p_y_2*t125 + D_p_z_2*t126
    K_el_out[..., 0, 2] = K_el_out[..., 2, 0] = D_p_x_3*t124 + D_p_y_3*t125 + D_p_z_3*t126
    K_el_out[..., 0, 3] = K_el_out[..., 3, 0] = t127
    K_el_out[..., 0, 6] = K_el_out[..., 6, 0] = t128
    K_el_out[..., 0, 12] = K_el_out[..., 12, 0] = D_delta_x_1*t124 + D_delta_y_1*t125 + D_delta_z_1*t126
    K_el_out[..., 0, 13] = K_el_out[..., 13, 0] = D_delta_x_2*t124 + D_delta_y_2*t125 + D_delta_z_2*t126
    K_el_out[..., 0, 14] = K_el_out[..., 14, 0] = D_delta_x_3*t124 + D_delta_y_3*t125 + D_delta_z_3*t126
    K_el_out[..., 0, 15] = K_el_out[..., 15, 0] = t123
    K_el_out[..., 0, 18] = K_el_out[..., 18, 0] = t124
    K_el_out[..., 0, 19] = K_el_out[..., 19, 0] = t125
    K_el_out[..., 0, 20] = K_el_out[..., 20, 0] = t126
    K_el_out[..., 1, 1] = k_C*t129 + k_C*t130 + k_C*t131 + t132
    K_el_out[..., 1, 2] = K_el_out[..., 2, 1] = D_p_x_3*t133 + D_p_y_3*t134 + D_p_z_3*t135
    K_el_out[..., 1, 4] = K_el_out[..., 4, 1] = t136
    K_el_out[..., 1, 7] = K_el_out[..., 7, 1] = t137
    K_el_out[..., 1, 12] = K_el_out[..., 12, 1] = D_delta_x_1*t133 + D_delta_y_1*t134 + D_delta_z_1*t135
    K_el_out[..., 1, 13] = K_el_out[..., 13, 1] = D_delta_x_2*t133 + D_delta_y_2*t134 + D_delta_z_2*t135
    K_el_out[..., 1, 14] = K_el_out[..., 14, 1] = D_delta_x_3*t133 + D_delta_y_3*t134 + D_delta_z_3*t135
    K_el_out[..., 1, 16] = K_el_out[..., 16, 1] = t132
    K_el_out[..., 1, 18] = K_el_out[..., 18, 1] = t133
    K_el_out[..., 1, 19] = K_el_out[..., 19, 1] = t134
    K_el_out[..., 1, 20] = K_el_out[..., 20, 1] = t135
    K_el_out[..., 2, 2] = k_C*t138 + k_C*t139 + k_C*t140 + t141
    K_el_out[..., 2, 5] = K_el_out[..., 5, 2] = t142
    K_el_out[..., 2, 8] = K_el_out[..., 8, 2] = t143
    K_el_out[..., 2, 12] = K_el_out[..., 12, 2] = D_delta_x_1*t144 + D_delta_y_1*t145 + D_delta_z_1*t146
    K_el_out[..., 2, 13] = K_el_out[..., 13, 2] = D_delta_x_2*t144 + D_delta_y_2*t145 + D_delta_z_2*t146
    K_el_out[..., 2, 14] = K_el_out[..., 14, 2] = D_delta_x_3*t144 + D_delta_y_3*t145 + D_delta_z_3*t146
    K_el_out[..., 2, 17] = K_el_out[..., 17, 2] = t141
    K_el_out[..., 2, 18] = K_el_out[..., 18, 2] = t144
    K_el_out[..., 2, 19] = K_el_out[..., 19, 2] = t145
    K_el_out[..., 2, 20] = K_el_out[..., 20, 2] = t146
    K_el_out[..., 3, 3] = d_1_1*k_S + k_1_3*t89 + t147
    K_el_out[..., 3, 6] = K_el_out[..., 6, 3] = -t147
    K_el_out[..., 3, 15] = K_el_out[..., 15, 3] = t127
    K_el_out[..., 4, 4] = d_2_1*k_S + k_2_3*t93 + t148
    K_el_out[..., 4, 7] = K_el_out[..., 7, 4] = -t148
    K_el_out[..., 4, 16] = K_el_out[..., 16, 4] = t136
    K_el_out[..., 5, 5] = d_3_1*k_S + k_3_3*t97 + t149
    K_el_out[..., 5, 8] = K_el_out[..., 8, 5] = -t149
    K_el_out[..., 5, 17] = K_el_out[..., 17, 5] = t142
    K_el_out[..., 6, 6] = d_1_2*k_S + k_1_2*t89 + t147
    K_el_out[..., 6, 15] = K_el_out[..., 15, 6] = t128
    K_el_out[..., 7, 7] = d_2_2*k_S + k_2_2*t93 + t148
    K_el_out[..., 7, 16] = K_el_out[..., 16, 7] = t137
    K_el_out[..., 8, 8] = d_3_2*k_S + k_3_2*t97 + t149
    K_el_out[..., 8, 17] = K_el_out[..., 17, 8] = t143
    K_el_out[..., 12, 12] = k_C*t104 + k_C*t105 + k_C*t106
    K_el_out[..., 12, 13] = K_el_out[..., 13, 12] = D_delta_x_2*t150 + D_delta_y_2*t151 + D_delta_z_2*t152
    K_el_out[..., 12, 14] = K_el_out[..., 14, 12] = D_delta_x_3*t150 + D_delta_y_3*t151 + D_delta_z_3*t152
    K_el_out[..., 12, 18] = K_el_out[..., 18, 12] = t150
    K_el_out[..., 12, 19] = K_el_out[..., 19, 12] = t151
    K_el_out[..., 12, 20] = K_el_out[..., 20, 12] = t152
    K_el_out[..., 13, 13] = k_C*t110 + k_C*t111 + k_C*t112
    K_el_out[..., 13, 14] = K_el_out[..., 14, 13] = D_delta_x_3*t153 + D_delta_y_3*t154 + D_delta_z_3*t155
    K_el_out[..., 13, 18] = K_el_out[..., 18, 13] = t153
    K_el_out[..., 13, 19] = K_el_out[..., 19, 13] = t154
    K_el_out[..., 13, 20] = K_el_out[..., 20, 13] = t155
    K_el_out[..., 14, 14] = k_C*t116 + k_C*t117 + k_C*t118
    K_el_out[..., 14, 18] = K_el_out[..., 18, 14] = D_delta_x_3*k_C
    K_el_out[..., 14, 19] = K_el_out[..., 19, 14] = D_delta_y_3*k_C
    K_el_out[..., 14, 20] = K_el_out[..., 20, 14] = D_delta_z_3*k_C
    K_el_out[..., 15, 15] = t123
    K_el_out[..., 16, 16] = t132
    K_el_out[..., 17, 17] = t141
    K_el_out[..., 18, 18] = k_C
    K_el_out[..., 19, 19] = k_C
    K_el_out[..., 20, 20] = k_C
    K_g_out = np.zeros((*batch, 21, 21), dtype)
    K_g_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 - mu_2*t120 - mu_2*t121 - mu_2*t122 - mu_3*t120
        - mu_3*t121 - mu_3*t122
    )
    K_g_out[..., 0, 1] = K_g_out[..., 1, 0] = (
        -D_p_x_2*t156 - D_p_x_2*t158 - D_p_y_2*t159 - D_p_y_2*t161 - D_p_z_2*t162 - D_p_z_2*t164
        - U_2_x_2*t157 - U_2_y_2*t160 - U_2_z_2*t163
    )
    K_g_out[..., 0, 2] = K_g_out[..., 2, 0] = (
        -D_p_x_3*t157 - D_p_x_3*t158 - D_p_y_3*t160 - D_p_y_3*t161 - D_p_z_3*t163 - D_p_z_3*t164
        - U_3_x_3*t156 - U_3_y_3*t159 - U_3_z_3*t162
    )
    K_g_out[..., 0, 12] = K_g_out[..., 12, 0] = (
        -D_delta_x_1*t156 - D_delta_x_1*t157 - D_delta_x_1*t158 - D_delta_y_1*t159 - D_delta_y_1*t160
        - D_delta_y_1*t161 - D_delta_z_1*t162 - D_delta_z_1*t163 - D_delta_z_1*t164
    )
    K_g_out[..., 0, 13] = K_g_out[..., 13, 0] = (
        -D_delta_x_2*t156 - D_delta_x_2*t157 - D_delta_x_2*t158 - D_delta_y_2*t159 - D_delta_y_2*t160
        - D_delta_y_2*t161 - D_delta_z_2*t162 - D_delta_z_2*t163 - D_delta_z_2*t164
    )
    K_g_out[..., 0, 14] = K_g_out[..., 14, 0] = (
        -D_delta_x_3*t156 - D_delta_x_3*t157 - D_delta_x_3*t158 - D_delta_y_3*t159 - D_delta_y_3*t160
        - D_delta_y_3*t161 - D_delta_z_3*t162 - D_delta_z_3*t163 - D_delta_z_3*t164
    )
    K_g_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 - mu_1*t129 - mu_1*t130 - mu_1*t131 - mu_3*t129
        - mu_3*t130 - mu_3*t131
    )
    K_g_out[..., 1, 2] = K_g_out[..., 2, 1] = (
        -D_p_x_3*t165 - D_p_x_3*t167 - D_p_y_3*t168 - D_p_y_3*t170 - D_p_z_3*t171 - D_p_z_3*t173
        - U_3_x_3*t166 - U_3_y_3*t169 - U_3_z_3*t172
    )
    K_g_out[..., 1, 12] = K_g_out[..., 12, 1] = (
        -D_delta_x_1*t165 - D_delta_x_1*t166 - D_delta_x_1*t167 - D_delta_y_1*t168 - D_delta_y_1*t169
        - D_delta_y_1*t170 - D_delta_z_1*t171 - D_delta_z_1*t172 - D_delta_z_1*t173
    )
    K_g_out[..., 1, 13] = K_g_out[..., 13, 1] = (
        -D_delta_x_2*t165 - D_delta_x_2*t166 - D_delta_x_2*t167 - D_delta_y_2*t168 - D_delta_y_2*t169
        - D_delta_y_2*t170 - D_delta_z_2*t171 - D_delta_z_2*t172 - D_delta_z_2*t173
    )
    K_g_out[..., 1, 14] = K_g_out[..., 14, 1] = (
        -D_delta_x_3*t165 - D_delta_x_3*t166 - D_delta_x_3*t167 - D_delta_y_3*t168 - D_delta_y_3*t169
        - D_delta_y_3*t170 - D_delta_z_3*t171 - D_delta_z_3*t172 - D_delta_z_3*t173
    )
    K_g_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 - mu_1*t138 - mu_1*t139 - mu_1*t140 - mu_2*t138
        - mu_2*t139 - mu_2*t140
    )
    K_g_out[..., 2, 12] = K_g_out[..., 12, 2] = (
        -D_delta_x_1*t175 - D_delta_y_1*t177 - D_delta_z_1*t179 - mu_1*t174 - mu_1*t176 - mu_1*t178
        - mu_2*t174 - mu_2*t176 - mu_2*t178
    )
    K_g_out[..., 2, 13] = K_g_out[..., 13, 2] = (
        -D_delta_x_2*t175 - D_delta_y_2*t177 - D_delta_z_2*t179 - mu_1*t180 - mu_1*t181 - mu_1*t182
        - mu_2*t180 - mu_2*t181 - mu_2*t182
    )
    K_g_out[..., 2, 14] = K_g_out[..., 14, 2] = (
        -D_delta_x_3*t175 - D_delta_y_3*t177 - D_delta_z_3*t179 - mu_1*t183 - mu_1*t184 - mu_1*t185
        - mu_2*t183 - mu_2*t184 - mu_2*t185
    )
    K_g_out[..., 12, 12] = (
        -mu_1*t104 - mu_1*t105 - mu_1*t106 + mu_1 - mu_2*t104 - mu_2*t105 - mu_2*t106 - mu_3*t104 - mu_3*t105
        - mu_3*t106
    )
    K_g_out[..., 12, 13] = K_g_out[..., 13, 12] = (
        -mu_1*t186 - mu_1*t187 - mu_1*t188 - mu_2*t186 - mu_2*t187 - mu_2*t188 - mu_3*t186 - mu_3*t187
        - mu_3*t188
    )
    K_g_out[..., 12, 14] = K_g_out[..., 14, 12] = (
        -mu_1*t189 - mu_1*t190 - mu_1*t191 - mu_2*t189 - mu_2*t190 - mu_2*t191 - mu_3*t189 - mu_3*t190
        - mu_3*t191
    )
    K_g_out[..., 13, 13] = (
        -mu_1*t110 - mu_1*t111 - mu_1*t112 - mu_2*t110 - mu_2*t111 - mu_2*t112 + mu_2 - mu_3*t110 - mu_3*t111
        - mu_3*t112
    )
    K_g_out[..., 13, 14] = K_g_out[..., 14, 13] = (
        -mu_1*t192 - mu_1*t193 - mu_1*t194 - mu_2*t192 - mu_2*t193 - mu_2*t194 - mu_3*t192 - mu_3*t193
        - mu_3*t194
    )
    K_g_out[..., 14, 14] = (
        -mu_1*t116 - mu_1*t117 - mu_1*t118 - mu_2*t116 - mu_2*t117 - mu_2*t118 - mu_3*t116 - mu_3*t117
        - mu_3*t118 + mu_3
    )
    return M_out, K_el_out, K_g_out


def extended_platform_motion(p, parameters):
    """Absolute motion of the platform centre by the coordinates.

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
    Equation 15, with what released joints and the frame add.
    177 operations; 26586 with every named value written out.
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


def joint_stiffness(effects):
    """Stiffnesses of the released joints, to be added to the diagonal of K.

    Infinite for a compliance of zero: a locked joint.

    Parameters
    ----------
    effects : Effects
        The robot's effects.

    Returns
    -------
    kappa : array, shape (..., 12) [N/m, N m]
        In the order of the released coordinates.
    kappa_c : array, shape (..., 12) [N^2/m^2, N^2 m^2]
        Derivatives by the compliances.

    Notes
    -----
    Energy q^2 / (2 c) of each joint.
    16 operations; 48 with every named value written out.
    """
    (c_G,) = _entries(effects.gearbox_compliance_compliance, ())
    (c_L,) = _entries(effects.link_compliance_compliance, ())
    (c_K,) = _entries(effects.clamp_compliance_compliance, ())
    (c_F,) = _entries(effects.frame_compliance_compliance, ())
    batch, dtype = _batch(c_G, c_L, c_K, c_F)
    t1 = 1.0/c_G
    t2 = 1.0/c_L
    t3 = 1.0/c_K
    t4 = 1.0/c_F
    t5 = -1/c_G**2
    t6 = -1/c_L**2
    t7 = -1/c_K**2
    t8 = -1/c_F**2
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
    kappa_out[..., 9] = t4
    kappa_out[..., 10] = t4
    kappa_out[..., 11] = t4
    kappa_c_out = np.empty((*batch, 12), dtype)
    kappa_c_out[..., 0] = t5
    kappa_c_out[..., 1] = t5
    kappa_c_out[..., 2] = t5
    kappa_c_out[..., 3] = t6
    kappa_c_out[..., 4] = t6
    kappa_c_out[..., 5] = t6
    kappa_c_out[..., 6] = t7
    kappa_c_out[..., 7] = t7
    kappa_c_out[..., 8] = t7
    kappa_c_out[..., 9] = t8
    kappa_c_out[..., 10] = t8
    kappa_c_out[..., 11] = t8
    return kappa_out, kappa_c_out


def extended_static_equilibrium(p, parameters, effects):
    """Torques and pulley rotations that hold the pose, the effects' weights and belts included.

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
        Torques on the driven pulleys.
    theta_st : array, shape (..., 6) [rad]
        Rotations from the unstrained belts.

    Notes
    -----
    Equation 44; springs that effects add are relaxed at the pose, and the released joints hold.
    382 operations; 127761 with every named value written out.
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
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, m_t_1, l_t_1, k_sp_1, w_b_1,
        R_p_1, d_1_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, m_L)
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
    t5 = k_sp_1*w_b_1*(a_B_1 + 1)
    t6 = c_E*t5
    k_1_1 = t5/(l_f_1_1 + t6)
    t7 = (1/2)*l_t_1
    l_f_1_2 = -t7 + x_1 - x_min_1
    k_1_2 = t5/(l_f_1_2 + t6)
    l_f_1_3 = -t7 - x_1 + x_max_1
    k_1_3 = t5/(l_f_1_3 + t6)
    l_f_2_1 = x_max_2 - x_min_2
    t8 = k_sp_2*w_b_2*(a_B_2 + 1)
    t9 = c_E*t8
    k_2_1 = t8/(l_f_2_1 + t9)
    t10 = (1/2)*l_t_2
    l_f_2_2 = -t10 + x_2 - x_min_2
    k_2_2 = t8/(l_f_2_2 + t9)
    l_f_2_3 = -t10 - x_2 + x_max_2
    k_2_3 = t8/(l_f_2_3 + t9)
    l_f_3_1 = x_max_3 - x_min_3
    t11 = k_sp_3*w_b_3*(a_B_3 + 1)
    t12 = c_E*t11
    k_3_1 = t11/(l_f_3_1 + t12)
    t13 = (1/2)*l_t_3
    l_f_3_2 = -t13 + x_3 - x_min_3
    k_3_2 = t11/(l_f_3_2 + t12)
    l_f_3_3 = -t13 - x_3 + x_max_3
    k_3_3 = t11/(l_f_3_3 + t12)
    t14 = (1/2)*m_d_1
    t15 = (1/2)*m_d_2
    t16 = (1/2)*m_d_3
    t17 = m_L + m_p + t14 + t15 + t16
    t18 = g_x*t17
    t19 = g_y*t17
    t20 = g_z*t17
    G_1 = (
        -D_p_x_1*t18 - D_p_y_1*t19 - D_p_z_1*t20 - g_x*(m_t_1*n_1_x + n_1_x*t14) - g_y*(m_t_1*n_1_y
        + n_1_y*t14) - g_z*(m_t_1*n_1_z + n_1_z*t14)
    )
    t21 = R_p_1**2
    t22 = k_1_1*t21
    t23 = k_1_3*t21
    t24 = -d_1_1*t22 + d_1_2*(t22 + t23)
    t25 = k_1_2*t21
    t26 = d_1_1*(t22 + t25) - d_1_2*t22
    det_1 = R_p_1*k_1_2*t24 - R_p_1*k_1_3*t26
    t27 = G_1/det_1
    theta_1_1_st = -t26*t27
    theta_1_2_st = t24*t27
    t28 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st)
    tau_st_1 = d_1_1*(t23*theta_1_1_st - t28) + d_1_2*(t25*theta_1_2_st + t28)
    G_2 = (
        -D_p_x_2*t18 - D_p_y_2*t19 - D_p_z_2*t20 - g_x*(m_t_2*n_2_x + n_2_x*t15) - g_y*(m_t_2*n_2_y
        + n_2_y*t15) - g_z*(m_t_2*n_2_z + n_2_z*t15)
    )
    t29 = R_p_2**2
    t30 = k_2_1*t29
    t31 = k_2_3*t29
    t32 = -d_2_1*t30 + d_2_2*(t30 + t31)
    t33 = k_2_2*t29
    t34 = d_2_1*(t30 + t33) - d_2_2*t30
    det_2 = R_p_2*k_2_2*t32 - R_p_2*k_2_3*t34
    t35 = G_2/det_2
    theta_2_1_st = -t34*t35
    theta_2_2_st = t32*t35
    t36 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st)
    tau_st_2 = d_2_1*(t31*theta_2_1_st - t36) + d_2_2*(t33*theta_2_2_st + t36)
    G_3 = (
        -D_p_x_3*t18 - D_p_y_3*t19 - D_p_z_3*t20 - g_x*(m_t_3*n_3_x + n_3_x*t16) - g_y*(m_t_3*n_3_y
        + n_3_y*t16) - g_z*(m_t_3*n_3_z + n_3_z*t16)
    )
    t37 = R_p_3**2
    t38 = k_3_1*t37
    t39 = k_3_3*t37
    t40 = -d_3_1*t38 + d_3_2*(t38 + t39)
    t41 = k_3_2*t37
    t42 = d_3_1*(t38 + t41) - d_3_2*t38
    det_3 = R_p_3*k_3_2*t40 - R_p_3*k_3_3*t42
    t43 = G_3/det_3
    theta_3_1_st = -t42*t43
    theta_3_2_st = t40*t43
    t44 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st)
    tau_st_3 = d_3_1*(t39*theta_3_1_st - t44) + d_3_2*(t41*theta_3_2_st + t44)
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


def value_sensitivities(p, parameters, effects):
    """Derivatives of M and K by every parameter that moves no carriage, at a fixed platform pose.

    The entries of the upper triangles that VALUE_SENSITIVITIES lists, all others being zero.

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
    M_theta : array, shape (..., 402) [unit of M by that of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 432) [unit of K by that of the parameter]
        dK/dtheta.

    Notes
    -----
    Chain rule.
    2245 operations; 5900571 with every named value written out.
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
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, l_t_1, k_sp_1, w_b_1, R_p_1,
        I_m_1, i_g_1, d_1_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, m_L)
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
    t12 = t11*w_b_1
    t13 = k_sp_1*t12
    t14 = c_E*t13
    t15 = l_f_1_1 + t14
    t16 = 1.0/t15
    k_1_1 = k_sp_1*t12*t16
    t17 = (1/2)*l_t_1
    l_f_1_2 = -t17 + x_1 - x_min_1
    t18 = l_f_1_2 + t14
    t19 = 1.0/t18
    k_1_2 = k_sp_1*t12*t19
    l_f_1_3 = -t17 - x_1 + x_max_1
    t20 = l_f_1_3 + t14
    t21 = 1.0/t20
    k_1_3 = k_sp_1*t12*t21
    l_f_2_1 = x_max_2 - x_min_2
    t22 = a_B_2 + 1
    t23 = t22*w_b_2
    t24 = k_sp_2*t23
    t25 = c_E*t24
    t26 = l_f_2_1 + t25
    t27 = 1.0/t26
    k_2_1 = k_sp_2*t23*t27
    t28 = (1/2)*l_t_2
    l_f_2_2 = -t28 + x_2 - x_min_2
    t29 = l_f_2_2 + t25
    t30 = 1.0/t29
    k_2_2 = k_sp_2*t23*t30
    l_f_2_3 = -t28 - x_2 + x_max_2
    t31 = l_f_2_3 + t25
    t32 = 1.0/t31
    k_2_3 = k_sp_2*t23*t32
    l_f_3_1 = x_max_3 - x_min_3
    t33 = a_B_3 + 1
    t34 = t33*w_b_3
    t35 = k_sp_3*t34
    t36 = c_E*t35
    t37 = l_f_3_1 + t36
    t38 = 1.0/t37
    k_3_1 = k_sp_3*t34*t38
    t39 = (1/2)*l_t_3
    l_f_3_2 = -t39 + x_3 - x_min_3
    t40 = l_f_3_2 + t36
    t41 = 1.0/t40
    k_3_2 = k_sp_3*t34*t41
    l_f_3_3 = -t39 - x_3 + x_max_3
    t42 = l_f_3_3 + t36
    t43 = 1.0/t42
    k_3_3 = k_sp_3*t34*t43
    t44 = A_x_1*g_x
    t45 = A_y_1*g_y
    t46 = A_z_1*g_z
    mu_1_by_m_p = t1*(-t44 - t45 - t46)
    t47 = A_x_2*g_x
    t48 = A_y_2*g_y
    t49 = A_z_2*g_z
    mu_2_by_m_p = t1*(-t47 - t48 - t49)
    t50 = A_x_3*g_x
    t51 = A_y_3*g_y
    t52 = A_z_3*g_z
    mu_3_by_m_p = t1*(-t50 - t51 - t52)
    t53 = -m_L - 1/2*m_d_1 - 1/2*m_d_2 - 1/2*m_d_3 - m_p
    mu_1_by_g_x = t2*t53
    mu_2_by_g_x = t3*t53
    mu_3_by_g_x = t4*t53
    mu_1_by_g_y = t5*t53
    mu_2_by_g_y = t53*t6
    mu_3_by_g_y = t53*t7
    mu_1_by_g_z = t53*t8
    mu_2_by_g_z = t53*t9
    mu_3_by_g_z = t10*t53
    mu_1_by_m_d_1 = t1*(-1/2*t44 - 1/2*t45 - 1/2*t46)
    mu_2_by_m_d_1 = t1*(-1/2*t47 - 1/2*t48 - 1/2*t49)
    mu_3_by_m_d_1 = t1*(-1/2*t50 - 1/2*t51 - 1/2*t52)
    t54 = D_p_x_1**2
    t55 = D_p_y_1**2
    t56 = D_p_z_1**2
    t57 = t54 + t55 + t56
    t58 = D_p_x_1*D_p_x_2
    t59 = D_p_y_1*D_p_y_2
    t60 = D_p_z_1*D_p_z_2
    t61 = t58 + t59 + t60
    t62 = D_p_x_1*D_p_x_3
    t63 = D_p_y_1*D_p_y_3
    t64 = D_p_z_1*D_p_z_3
    t65 = t62 + t63 + t64
    t66 = D_delta_x_1*D_p_x_1
    t67 = D_delta_y_1*D_p_y_1
    t68 = D_delta_z_1*D_p_z_1
    t69 = t66 + t67 + t68
    t70 = D_delta_x_2*D_p_x_1
    t71 = D_delta_y_2*D_p_y_1
    t72 = D_delta_z_2*D_p_z_1
    t73 = t70 + t71 + t72
    t74 = D_delta_x_3*D_p_x_1
    t75 = D_delta_y_3*D_p_y_1
    t76 = D_delta_z_3*D_p_z_1
    t77 = t74 + t75 + t76
    t78 = D_p_x_2**2
    t79 = D_p_y_2**2
    t80 = D_p_z_2**2
    t81 = t78 + t79 + t80
    t82 = D_p_x_2*D_p_x_3
    t83 = D_p_y_2*D_p_y_3
    t84 = D_p_z_2*D_p_z_3
    t85 = t82 + t83 + t84
    t86 = D_delta_x_1*D_p_x_2
    t87 = D_delta_y_1*D_p_y_2
    t88 = D_delta_z_1*D_p_z_2
    t89 = t86 + t87 + t88
    t90 = D_delta_x_2*D_p_x_2
    t91 = D_delta_y_2*D_p_y_2
    t92 = D_delta_z_2*D_p_z_2
    t93 = t90 + t91 + t92
    t94 = D_delta_x_3*D_p_x_2
    t95 = D_delta_y_3*D_p_y_2
    t96 = D_delta_z_3*D_p_z_2
    t97 = t94 + t95 + t96
    t98 = D_p_x_3**2
    t99 = D_p_y_3**2
    t100 = D_p_z_3**2
    t101 = t100 + t98 + t99
    t102 = D_delta_x_1*D_p_x_3
    t103 = D_delta_y_1*D_p_y_3
    t104 = D_delta_z_1*D_p_z_3
    t105 = t102 + t103 + t104
    t106 = D_delta_x_2*D_p_x_3
    t107 = D_delta_y_2*D_p_y_3
    t108 = D_delta_z_2*D_p_z_3
    t109 = t106 + t107 + t108
    t110 = D_delta_x_3*D_p_x_3
    t111 = D_delta_y_3*D_p_y_3
    t112 = D_delta_z_3*D_p_z_3
    t113 = t110 + t111 + t112
    t114 = D_delta_x_1**2
    t115 = D_delta_y_1**2
    t116 = D_delta_z_1**2
    t117 = t114 + t115 + t116
    t118 = D_delta_x_1*D_delta_x_2
    t119 = D_delta_y_1*D_delta_y_2
    t120 = D_delta_z_1*D_delta_z_2
    t121 = t118 + t119 + t120
    t122 = D_delta_x_1*D_delta_x_3
    t123 = D_delta_y_1*D_delta_y_3
    t124 = D_delta_z_1*D_delta_z_3
    t125 = t122 + t123 + t124
    t126 = D_delta_x_2**2
    t127 = D_delta_y_2**2
    t128 = D_delta_z_2**2
    t129 = t126 + t127 + t128
    t130 = D_delta_x_2*D_delta_x_3
    t131 = D_delta_y_2*D_delta_y_3
    t132 = D_delta_z_2*D_delta_z_3
    t133 = t130 + t131 + t132
    t134 = D_delta_x_3**2
    t135 = D_delta_y_3**2
    t136 = D_delta_z_3**2
    t137 = t134 + t135 + t136
    t138 = (1/6)*n_1_x
    t139 = (1/6)*n_1_y
    t140 = (1/6)*n_1_z
    t141 = (1/3)*D_p_x_1 + t138
    t142 = (1/3)*D_p_y_1 + t139
    t143 = (1/3)*D_p_z_1 + t140
    t144 = (1/2)*D_p_x_1
    t145 = (1/2)*D_p_y_1
    t146 = (1/2)*D_p_z_1
    t147 = (1/3)*t78 + (1/3)*t79 + (1/3)*t80
    t148 = (1/3)*t82 + (1/3)*t83 + (1/3)*t84
    t149 = (1/3)*t86 + (1/3)*t87 + (1/3)*t88
    t150 = (1/3)*t90 + (1/3)*t91 + (1/3)*t92
    t151 = (1/3)*t94 + (1/3)*t95 + (1/3)*t96
    t152 = (1/2)*D_p_x_2
    t153 = (1/2)*D_p_y_2
    t154 = (1/2)*D_p_z_2
    t155 = (1/3)*t100 + (1/3)*t98 + (1/3)*t99
    t156 = (1/3)*t102 + (1/3)*t103 + (1/3)*t104
    t157 = (1/3)*t106 + (1/3)*t107 + (1/3)*t108
    t158 = (1/3)*t110 + (1/3)*t111 + (1/3)*t112
    t159 = (1/2)*D_p_x_3
    t160 = (1/2)*D_p_y_3
    t161 = (1/2)*D_p_z_3
    t162 = (1/3)*t114 + (1/3)*t115 + (1/3)*t116
    t163 = (1/3)*t118 + (1/3)*t119 + (1/3)*t120
    t164 = (1/3)*t122 + (1/3)*t123 + (1/3)*t124
    t165 = (1/2)*D_delta_x_1
    t166 = (1/2)*D_delta_y_1
    t167 = (1/2)*D_delta_z_1
    t168 = (1/3)*t126 + (1/3)*t127 + (1/3)*t128
    t169 = (1/3)*t130 + (1/3)*t131 + (1/3)*t132
    t170 = (1/2)*D_delta_x_2
    t171 = (1/2)*D_delta_y_2
    t172 = (1/2)*D_delta_z_2
    t173 = (1/3)*t134 + (1/3)*t135 + (1/3)*t136
    t174 = (1/2)*D_delta_x_3
    t175 = (1/2)*D_delta_y_3
    t176 = (1/2)*D_delta_z_3
    t177 = (1/3)*t54 + (1/3)*t55 + (1/3)*t56
    t178 = (1/6)*n_2_x
    t179 = (1/6)*n_2_y
    t180 = (1/6)*n_2_z
    t181 = (1/3)*t58 + (1/3)*t59 + (1/3)*t60
    t182 = (1/3)*t62 + (1/3)*t63 + (1/3)*t64
    t183 = (1/3)*t66 + (1/3)*t67 + (1/3)*t68
    t184 = (1/3)*t70 + (1/3)*t71 + (1/3)*t72
    t185 = (1/3)*t74 + (1/3)*t75 + (1/3)*t76
    t186 = (1/3)*D_p_x_2 + t178
    t187 = (1/3)*D_p_y_2 + t179
    t188 = (1/3)*D_p_z_2 + t180
    t189 = (1/6)*n_3_x
    t190 = (1/6)*n_3_y
    t191 = (1/6)*n_3_z
    t192 = (1/3)*D_p_x_3 + t189
    t193 = (1/3)*D_p_y_3 + t190
    t194 = (1/3)*D_p_z_3 + t191
    t195 = (1/3)*rho_b
    t196 = (1/12)*rho_b
    t197 = -R_p_1*t196
    t198 = R_p_1**2
    t199 = (1/6)*rho_b
    t200 = t198*t199
    t201 = -R_p_2*t196
    t202 = R_p_2**2
    t203 = t199*t202
    t204 = -R_p_3*t196
    t205 = R_p_3**2
    t206 = t199*t205
    t207 = l_f_1_3*t199
    t208 = l_f_1_2*t199
    t209 = (2/3)*rho_b
    t210 = R_p_1*t209
    t211 = l_f_1_1*t210
    t212 = l_f_2_3*t199
    t213 = l_f_2_2*t199
    t214 = R_p_2*t209
    t215 = l_f_2_1*t214
    t216 = l_f_3_3*t199
    t217 = l_f_3_2*t199
    t218 = R_p_3*t209
    t219 = l_f_3_1*t218
    t220 = i_g_1**2
    t221 = d_1_1*t220
    t222 = d_1_2*t220
    t223 = i_g_2**2
    t224 = d_2_1*t223
    t225 = d_2_2*t223
    t226 = i_g_3**2
    t227 = d_3_1*t226
    t228 = d_3_2*t226
    t229 = 2*I_m_1*i_g_1
    t230 = d_1_1*t229
    t231 = d_1_2*t229
    t232 = 2*I_m_2*i_g_2
    t233 = d_2_1*t232
    t234 = d_2_2*t232
    t235 = 2*I_m_3*i_g_3
    t236 = d_3_1*t235
    t237 = d_3_2*t235
    t238 = R_p_1*t199
    t239 = t195*t198
    t240 = t198*t209
    t241 = R_p_2*t199
    t242 = t195*t202
    t243 = t202*t209
    t244 = R_p_3*t199
    t245 = t195*t205
    t246 = t205*t209
    t247 = (1/3)*l_f_1_2
    t248 = (1/3)*l_f_1_3
    t249 = t247 + t248
    t250 = (1/6)*R_p_1
    t251 = l_f_1_3*t250
    t252 = l_f_1_2*t250
    t253 = (1/3)*l_f_2_2
    t254 = (1/3)*l_f_2_3
    t255 = t253 + t254
    t256 = (1/6)*R_p_2
    t257 = l_f_2_3*t256
    t258 = l_f_2_2*t256
    t259 = (1/3)*l_f_3_2
    t260 = (1/3)*l_f_3_3
    t261 = t259 + t260
    t262 = (1/6)*R_p_3
    t263 = l_f_3_3*t262
    t264 = l_f_3_2*t262
    t265 = l_f_1_1*t198
    t266 = (1/3)*t265
    t267 = l_f_2_1*t202
    t268 = (1/3)*t267
    t269 = l_f_3_1*t205
    t270 = (1/3)*t269
    t271 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    t272 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    t273 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    t274 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    t275 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    t276 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t277 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t278 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t279 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t280 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    t281 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    t282 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t283 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t284 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t285 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t286 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t287 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t288 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t289 = 1 - t117
    t290 = 1 - t129
    t291 = 1 - t137
    t292 = 1.0/(t18**2)
    t293 = t13*t292
    t294 = (1/2)*t293
    t295 = 1.0/(t20**2)
    t296 = t13*t295
    t297 = (1/2)*t296
    t298 = t294 + t297
    t299 = -R_p_1*t297
    t300 = -R_p_1*t294
    t301 = 1.0/(t29**2)
    t302 = t24*t301
    t303 = (1/2)*t302
    t304 = 1.0/(t31**2)
    t305 = t24*t304
    t306 = (1/2)*t305
    t307 = t303 + t306
    t308 = -R_p_2*t306
    t309 = -R_p_2*t303
    t310 = 1.0/(t40**2)
    t311 = t310*t35
    t312 = (1/2)*t311
    t313 = 1.0/(t42**2)
    t314 = t313*t35
    t315 = (1/2)*t314
    t316 = t312 + t315
    t317 = -R_p_3*t315
    t318 = -R_p_3*t312
    t319 = w_b_1**2
    t320 = t11**2
    t321 = t319*t320
    t322 = k_sp_1*t321
    t323 = c_E*t322
    t324 = -t11*t21*w_b_1 + t295*t323
    t325 = c_E*t292
    t326 = -t11*t19*w_b_1 + t322*t325
    t327 = -t324 - t326
    t328 = R_p_1*t324
    t329 = R_p_1*t326
    t330 = 1.0/(t15**2)
    t331 = t198*(t11*t16*w_b_1 - t323*t330)
    t332 = w_b_2**2
    t333 = t22**2
    t334 = t332*t333
    t335 = k_sp_2*t334
    t336 = c_E*t335
    t337 = -t22*t32*w_b_2 + t304*t336
    t338 = c_E*t301
    t339 = -t22*t30*w_b_2 + t335*t338
    t340 = -t337 - t339
    t341 = R_p_2*t337
    t342 = R_p_2*t339
    t343 = 1.0/(t26**2)
    t344 = t202*(t22*t27*w_b_2 - t336*t343)
    t345 = w_b_3**2
    t346 = t33**2
    t347 = t345*t346
    t348 = k_sp_3*t347
    t349 = c_E*t348
    t350 = t313*t349 - t33*t43*w_b_3
    t351 = c_E*t310
    t352 = -t33*t41*w_b_3 + t348*t351
    t353 = -t350 - t352
    t354 = R_p_3*t350
    t355 = R_p_3*t352
    t356 = 1.0/(t37**2)
    t357 = t205*(t33*t38*w_b_3 - t349*t356)
    t358 = t320*w_b_1
    t359 = k_sp_1**2
    t360 = c_E*t359
    t361 = t358*t360
    t362 = -k_sp_1*t11*t21 + t295*t361
    t363 = t325*t359
    t364 = -k_sp_1*t11*t19 + t358*t363
    t365 = -t362 - t364
    t366 = R_p_1*t362
    t367 = R_p_1*t364
    t368 = t198*(k_sp_1*t11*t16 - t330*t361)
    t369 = t333*w_b_2
    t370 = k_sp_2**2
    t371 = c_E*t370
    t372 = t369*t371
    t373 = -k_sp_2*t22*t32 + t304*t372
    t374 = t338*t370
    t375 = -k_sp_2*t22*t30 + t369*t374
    t376 = -t373 - t375
    t377 = R_p_2*t373
    t378 = R_p_2*t375
    t379 = t202*(k_sp_2*t22*t27 - t343*t372)
    t380 = t346*w_b_3
    t381 = k_sp_3**2
    t382 = c_E*t381
    t383 = t380*t382
    t384 = -k_sp_3*t33*t43 + t313*t383
    t385 = t351*t381
    t386 = -k_sp_3*t33*t41 + t380*t385
    t387 = -t384 - t386
    t388 = R_p_3*t384
    t389 = R_p_3*t386
    t390 = t205*(k_sp_3*t33*t38 - t356*t383)
    t391 = 2*R_p_1
    t392 = k_1_1*t391
    t393 = 2*R_p_2
    t394 = k_2_1*t393
    t395 = 2*R_p_3
    t396 = k_3_1*t395
    t397 = -R_p_1*t293
    t398 = t198*t330
    t399 = t13*t398
    t400 = -R_p_2*t302
    t401 = t202*t343
    t402 = t24*t401
    t403 = -R_p_3*t311
    t404 = t205*t356
    t405 = t35*t404
    t406 = R_p_1*t296
    t407 = R_p_2*t305
    t408 = R_p_3*t314
    t409 = t11*t319
    t410 = t360*t409
    t411 = -k_sp_1*t21*w_b_1 + t295*t410
    t412 = -k_sp_1*t19*w_b_1 + t363*t409
    t413 = -t411 - t412
    t414 = R_p_1*t411
    t415 = R_p_1*t412
    t416 = t198*(k_sp_1*t16*w_b_1 - t330*t410)
    t417 = t22*t332
    t418 = t371*t417
    t419 = -k_sp_2*t32*w_b_2 + t304*t418
    t420 = -k_sp_2*t30*w_b_2 + t374*t417
    t421 = -t419 - t420
    t422 = R_p_2*t419
    t423 = R_p_2*t420
    t424 = t202*(k_sp_2*t27*w_b_2 - t343*t418)
    t425 = t33*t345
    t426 = t382*t425
    t427 = -k_sp_3*t43*w_b_3 + t313*t426
    t428 = -k_sp_3*t41*w_b_3 + t385*t425
    t429 = -t427 - t428
    t430 = R_p_3*t427
    t431 = R_p_3*t428
    t432 = t205*(k_sp_3*t38*w_b_3 - t356*t426)
    t433 = t321*t359
    t434 = t292*t433
    t435 = t295*t433
    t436 = -t434 - t435
    t437 = R_p_1*t435
    t438 = R_p_1*t434
    t439 = t334*t370
    t440 = t301*t439
    t441 = t304*t439
    t442 = -t440 - t441
    t443 = R_p_2*t441
    t444 = R_p_2*t440
    t445 = t347*t381
    t446 = t310*t445
    t447 = t313*t445
    t448 = -t446 - t447
    t449 = R_p_3*t447
    t450 = R_p_3*t446
    t451 = t398*t433
    t452 = t401*t439
    t453 = t404*t445
    M_theta_out = _listed(batch, dtype, (
        t57, t61, t65, t69, t73, t77, D_p_x_1, D_p_y_1, D_p_z_1, t81, t85, t89, t93, t97, D_p_x_2, D_p_y_2,
        D_p_z_2, t101, t105, t109, t113, D_p_x_3, D_p_y_3, D_p_z_3, t117, t121, t125, D_delta_x_1,
        D_delta_y_1, D_delta_z_1, t129, t133, D_delta_x_2, D_delta_y_2, D_delta_z_2, t137, D_delta_x_3,
        D_delta_y_3, D_delta_z_3, 1, 1, 1,
        D_p_x_1*t138 + D_p_x_1*t141 + D_p_y_1*t139 + D_p_y_1*t142 + D_p_z_1*t140 + D_p_z_1*t143 + 1/3,
        D_p_x_2*t141 + D_p_y_2*t142 + D_p_z_2*t143, D_p_x_3*t141 + D_p_y_3*t142 + D_p_z_3*t143,
        D_delta_x_1*t141 + D_delta_y_1*t142 + D_delta_z_1*t143,
        D_delta_x_2*t141 + D_delta_y_2*t142 + D_delta_z_2*t143,
        D_delta_x_3*t141 + D_delta_y_3*t142 + D_delta_z_3*t143, (1/2)*n_1_x + t144, (1/2)*n_1_y + t145,
        (1/2)*n_1_z + t146, t147, t148, t149, t150, t151, t152, t153, t154, t155, t156, t157, t158, t159,
        t160, t161, t162, t163, t164, t165, t166, t167, t168, t169, t170, t171, t172, t173, t174, t175, t176,
        1, 1, 1, t177, D_p_x_1*t178 + D_p_y_1*t179 + D_p_z_1*t180 + t181, t182, t183, t184, t185, t144, t145,
        t146, D_p_x_2*t178 + D_p_x_2*t186 + D_p_y_2*t179 + D_p_y_2*t187 + D_p_z_2*t180 + D_p_z_2*t188 + 1/3,
        D_p_x_3*t186 + D_p_y_3*t187 + D_p_z_3*t188, D_delta_x_1*t186 + D_delta_y_1*t187 + D_delta_z_1*t188,
        D_delta_x_2*t186 + D_delta_y_2*t187 + D_delta_z_2*t188,
        D_delta_x_3*t186 + D_delta_y_3*t187 + D_delta_z_3*t188, (1/2)*n_2_x + t152, (1/2)*n_2_y + t153,
        (1/2)*n_2_z + t154, t155, t156, t157, t158, t159, t160, t161, t162, t163, t164, t165, t166, t167,
        t168, t169, t170, t171, t172, t173, t174, t175, t176, 1, 1, 1, t177, t181,
        D_p_x_1*t189 + D_p_y_1*t190 + D_p_z_1*t191 + t182, t183, t184, t185, t144, t145, t146, t147,
        D_p_x_2*t189 + D_p_y_2*t190 + D_p_z_2*t191 + t148, t149, t150, t151, t152, t153, t154,
        D_p_x_3*t189 + D_p_x_3*t192 + D_p_y_3*t190 + D_p_y_3*t193 + D_p_z_3*t191 + D_p_z_3*t194 + 1/3,
        D_delta_x_1*t192 + D_delta_y_1*t193 + D_delta_z_1*t194,
        D_delta_x_2*t192 + D_delta_y_2*t193 + D_delta_z_2*t194,
        D_delta_x_3*t192 + D_delta_y_3*t193 + D_delta_z_3*t194, (1/2)*n_3_x + t159, (1/2)*n_3_y + t160,
        (1/2)*n_3_z + t161, t162, t163, t164, t165, t166, t167, t168, t169, t170, t171, t172, t173, t174,
        t175, t176, 1, 1, 1, 1, n_1_x, n_1_y, n_1_z, 1, 1, 1, 1, n_2_x, n_2_y, n_2_z, 1, 1, 1, 1, n_3_x,
        n_3_y, n_3_z, 1, 1, 1, -t195, t197, t197, -t195, -t200, t197, -t200, t197, -t195, -t195, t201, t201,
        -t195, -t203, t201, -t203, t201, -t195, -t195, t204, t204, -t195, -t206, t204, -t206, t204, -t195,
        t207, t208, l_f_1_3*t210 + t211, R_p_1*l_f_1_1*t195, t207, l_f_1_2*t210 + t211, t208, t212, t213,
        l_f_2_3*t214 + t215, R_p_2*l_f_2_1*t195, t212, l_f_2_2*t214 + t215, t213, t216, t217,
        l_f_3_3*t218 + t219, R_p_3*l_f_3_1*t195, t216, l_f_3_2*t218 + t219, t217, 1, 1, 1, 1, 1, 1, t221,
        t221, t222, t222, t221 + t222, t224, t224, t225, t225, t224 + t225, t227, t227, t228, t228,
        t227 + t228, t230, t230, t231, t231, t230 + t231, t233, t233, t234, t234, t233 + t234, t236, t236,
        t237, t237, t236 + t237, -t195, -t238, -t195, -t239, -t200, -t240, -t238, -t195, -t195, -t241, -t195,
        -t242, -t203, -t243, -t241, -t195, -t195, -t244, -t195, -t245, -t206, -t246, -t244, -t195, t195, t238,
        t195, t240, t200, t238, t239, t195, t195, t241, t195, t243, t203, t241, t242, t195, t195, t244, t195,
        t246, t206, t244, t245, t195, t249, t251, t252, t249, t255, t257, t258, t255, t261, t263, t264, t261,
        t198*t248 + t266, (1/6)*t265, t251, t202*t254 + t268, (1/6)*t267, t257, t205*t260 + t270, (1/6)*t269,
        t263, t198*t247 + t266, t252, t202*t253 + t268, t258, t205*t259 + t270, t264, t249, t255, t261, d_1_1,
        d_2_1, d_3_1, d_1_2, d_2_2, d_3_2, t57, t61, t65, t69, t73, t77, D_p_x_1, D_p_y_1, D_p_z_1, t81, t85,
        t89, t93, t97, D_p_x_2, D_p_y_2, D_p_z_2, t101, t105, t109, t113, D_p_x_3, D_p_y_3, D_p_z_3, t117,
        t121, t125, D_delta_x_1, D_delta_y_1, D_delta_z_1, t129, t133, D_delta_x_2, D_delta_y_2, D_delta_z_2,
        t137, D_delta_x_3, D_delta_y_3, D_delta_z_3, 1, 1, 1, 1, 1, 1,
    ))
    K_theta_out = _listed(batch, dtype, (
        mu_1_by_m_p*t271 - mu_2_by_m_p*t57 - mu_3_by_m_p*t57,
        mu_1_by_m_p*t272 + mu_2_by_m_p*t273 - mu_3_by_m_p*t61,
        mu_1_by_m_p*t274 - mu_2_by_m_p*t65 + mu_3_by_m_p*t275,
        mu_1_by_m_p*t276 - mu_2_by_m_p*t69 - mu_3_by_m_p*t69,
        mu_1_by_m_p*t277 - mu_2_by_m_p*t73 - mu_3_by_m_p*t73,
        mu_1_by_m_p*t278 - mu_2_by_m_p*t77 - mu_3_by_m_p*t77,
        -mu_1_by_m_p*t81 + mu_2_by_m_p*t279 - mu_3_by_m_p*t81,
        -mu_1_by_m_p*t85 + mu_2_by_m_p*t280 + mu_3_by_m_p*t281,
        -mu_1_by_m_p*t89 + mu_2_by_m_p*t282 - mu_3_by_m_p*t89,
        -mu_1_by_m_p*t93 + mu_2_by_m_p*t283 - mu_3_by_m_p*t93,
        -mu_1_by_m_p*t97 + mu_2_by_m_p*t284 - mu_3_by_m_p*t97,
        -mu_1_by_m_p*t101 - mu_2_by_m_p*t101 + mu_3_by_m_p*t285,
        -mu_1_by_m_p*t105 - mu_2_by_m_p*t105 + mu_3_by_m_p*t286,
        -mu_1_by_m_p*t109 - mu_2_by_m_p*t109 + mu_3_by_m_p*t287,
        -mu_1_by_m_p*t113 - mu_2_by_m_p*t113 + mu_3_by_m_p*t288,
        mu_1_by_m_p*t289 - mu_2_by_m_p*t117 - mu_3_by_m_p*t117,
        -mu_1_by_m_p*t121 - mu_2_by_m_p*t121 - mu_3_by_m_p*t121,
        -mu_1_by_m_p*t125 - mu_2_by_m_p*t125 - mu_3_by_m_p*t125,
        -mu_1_by_m_p*t129 + mu_2_by_m_p*t290 - mu_3_by_m_p*t129,
        -mu_1_by_m_p*t133 - mu_2_by_m_p*t133 - mu_3_by_m_p*t133,
        -mu_1_by_m_p*t137 - mu_2_by_m_p*t137 + mu_3_by_m_p*t291,
        mu_1_by_g_x*t271 - mu_2_by_g_x*t57 - mu_3_by_g_x*t57,
        mu_1_by_g_x*t272 + mu_2_by_g_x*t273 - mu_3_by_g_x*t61,
        mu_1_by_g_x*t274 - mu_2_by_g_x*t65 + mu_3_by_g_x*t275,
        mu_1_by_g_x*t276 - mu_2_by_g_x*t69 - mu_3_by_g_x*t69,
        mu_1_by_g_x*t277 - mu_2_by_g_x*t73 - mu_3_by_g_x*t73,
        mu_1_by_g_x*t278 - mu_2_by_g_x*t77 - mu_3_by_g_x*t77,
        -mu_1_by_g_x*t81 + mu_2_by_g_x*t279 - mu_3_by_g_x*t81,
        -mu_1_by_g_x*t85 + mu_2_by_g_x*t280 + mu_3_by_g_x*t281,
        -mu_1_by_g_x*t89 + mu_2_by_g_x*t282 - mu_3_by_g_x*t89,
        -mu_1_by_g_x*t93 + mu_2_by_g_x*t283 - mu_3_by_g_x*t93,
        -mu_1_by_g_x*t97 + mu_2_by_g_x*t284 - mu_3_by_g_x*t97,
        -mu_1_by_g_x*t101 - mu_2_by_g_x*t101 + mu_3_by_g_x*t285,
        -mu_1_by_g_x*t105 - mu_2_by_g_x*t105 + mu_3_by_g_x*t286,
        -mu_1_by_g_x*t109 - mu_2_by_g_x*t109 + mu_3_by_g_x*t287,
        -mu_1_by_g_x*t113 - mu_2_by_g_x*t113 + mu_3_by_g_x*t288,
        mu_1_by_g_x*t289 - mu_2_by_g_x*t117 - mu_3_by_g_x*t117,
        -mu_1_by_g_x*t121 - mu_2_by_g_x*t121 - mu_3_by_g_x*t121,
        -mu_1_by_g_x*t125 - mu_2_by_g_x*t125 - mu_3_by_g_x*t125,
        -mu_1_by_g_x*t129 + mu_2_by_g_x*t290 - mu_3_by_g_x*t129,
        -mu_1_by_g_x*t133 - mu_2_by_g_x*t133 - mu_3_by_g_x*t133,
        -mu_1_by_g_x*t137 - mu_2_by_g_x*t137 + mu_3_by_g_x*t291,
        mu_1_by_g_y*t271 - mu_2_by_g_y*t57 - mu_3_by_g_y*t57,
        mu_1_by_g_y*t272 + mu_2_by_g_y*t273 - mu_3_by_g_y*t61,
        mu_1_by_g_y*t274 - mu_2_by_g_y*t65 + mu_3_by_g_y*t275,
        mu_1_by_g_y*t276 - mu_2_by_g_y*t69 - mu_3_by_g_y*t69,
        mu_1_by_g_y*t277 - mu_2_by_g_y*t73 - mu_3_by_g_y*t73,
        mu_1_by_g_y*t278 - mu_2_by_g_y*t77 - mu_3_by_g_y*t77,
        -mu_1_by_g_y*t81 + mu_2_by_g_y*t279 - mu_3_by_g_y*t81,
        -mu_1_by_g_y*t85 + mu_2_by_g_y*t280 + mu_3_by_g_y*t281,
        -mu_1_by_g_y*t89 + mu_2_by_g_y*t282 - mu_3_by_g_y*t89,
        -mu_1_by_g_y*t93 + mu_2_by_g_y*t283 - mu_3_by_g_y*t93,
        -mu_1_by_g_y*t97 + mu_2_by_g_y*t284 - mu_3_by_g_y*t97,
        -mu_1_by_g_y*t101 - mu_2_by_g_y*t101 + mu_3_by_g_y*t285,
        -mu_1_by_g_y*t105 - mu_2_by_g_y*t105 + mu_3_by_g_y*t286,
        -mu_1_by_g_y*t109 - mu_2_by_g_y*t109 + mu_3_by_g_y*t287,
        -mu_1_by_g_y*t113 - mu_2_by_g_y*t113 + mu_3_by_g_y*t288,
        mu_1_by_g_y*t289 - mu_2_by_g_y*t117 - mu_3_by_g_y*t117,
        -mu_1_by_g_y*t121 - mu_2_by_g_y*t121 - mu_3_by_g_y*t121,
        -mu_1_by_g_y*t125 - mu_2_by_g_y*t125 - mu_3_by_g_y*t125,
        -mu_1_by_g_y*t129 + mu_2_by_g_y*t290 - mu_3_by_g_y*t129,
        -mu_1_by_g_y*t133 - mu_2_by_g_y*t133 - mu_3_by_g_y*t133,
        -mu_1_by_g_y*t137 - mu_2_by_g_y*t137 + mu_3_by_g_y*t291,
        mu_1_by_g_z*t271 - mu_2_by_g_z*t57 - mu_3_by_g_z*t57,
        mu_1_by_g_z*t272 + mu_2_by_g_z*t273 - mu_3_by_g_z*t61,
        mu_1_by_g_z*t274 - mu_2_by_g_z*t65 + mu_3_by_g_z*t275,
        mu_1_by_g_z*t276 - mu_2_by_g_z*t69 - mu_3_by_g_z*t69,
        mu_1_by_g_z*t277 - mu_2_by_g_z*t73 - mu_3_by_g_z*t73,
        mu_1_by_g_z*t278 - mu_2_by_g_z*t77 - mu_3_by_g_z*t77,
        -mu_1_by_g_z*t81 + mu_2_by_g_z*t279 - mu_3_by_g_z*t81,
        -mu_1_by_g_z*t85 + mu_2_by_g_z*t280 + mu_3_by_g_z*t281,
        -mu_1_by_g_z*t89 + mu_2_by_g_z*t282 - mu_3_by_g_z*t89,
        -mu_1_by_g_z*t93 + mu_2_by_g_z*t283 - mu_3_by_g_z*t93,
        -mu_1_by_g_z*t97 + mu_2_by_g_z*t284 - mu_3_by_g_z*t97,
        -mu_1_by_g_z*t101 - mu_2_by_g_z*t101 + mu_3_by_g_z*t285,
        -mu_1_by_g_z*t105 - mu_2_by_g_z*t105 + mu_3_by_g_z*t286,
        -mu_1_by_g_z*t109 - mu_2_by_g_z*t109 + mu_3_by_g_z*t287,
        -mu_1_by_g_z*t113 - mu_2_by_g_z*t113 + mu_3_by_g_z*t288,
        mu_1_by_g_z*t289 - mu_2_by_g_z*t117 - mu_3_by_g_z*t117,
        -mu_1_by_g_z*t121 - mu_2_by_g_z*t121 - mu_3_by_g_z*t121,
        -mu_1_by_g_z*t125 - mu_2_by_g_z*t125 - mu_3_by_g_z*t125,
        -mu_1_by_g_z*t129 + mu_2_by_g_z*t290 - mu_3_by_g_z*t129,
        -mu_1_by_g_z*t133 - mu_2_by_g_z*t133 - mu_3_by_g_z*t133,
        -mu_1_by_g_z*t137 - mu_2_by_g_z*t137 + mu_3_by_g_z*t291,
        mu_1_by_m_d_1*t271 - mu_2_by_m_d_1*t57 - mu_3_by_m_d_1*t57,
        mu_1_by_m_d_1*t272 + mu_2_by_m_d_1*t273 - mu_3_by_m_d_1*t61,
        mu_1_by_m_d_1*t274 - mu_2_by_m_d_1*t65 + mu_3_by_m_d_1*t275,
        mu_1_by_m_d_1*t276 - mu_2_by_m_d_1*t69 - mu_3_by_m_d_1*t69,
        mu_1_by_m_d_1*t277 - mu_2_by_m_d_1*t73 - mu_3_by_m_d_1*t73,
        mu_1_by_m_d_1*t278 - mu_2_by_m_d_1*t77 - mu_3_by_m_d_1*t77,
        -mu_1_by_m_d_1*t81 + mu_2_by_m_d_1*t279 - mu_3_by_m_d_1*t81,
        -mu_1_by_m_d_1*t85 + mu_2_by_m_d_1*t280 + mu_3_by_m_d_1*t281,
        -mu_1_by_m_d_1*t89 + mu_2_by_m_d_1*t282 - mu_3_by_m_d_1*t89,
        -mu_1_by_m_d_1*t93 + mu_2_by_m_d_1*t283 - mu_3_by_m_d_1*t93,
        -mu_1_by_m_d_1*t97 + mu_2_by_m_d_1*t284 - mu_3_by_m_d_1*t97,
        -mu_1_by_m_d_1*t101 - mu_2_by_m_d_1*t101 + mu_3_by_m_d_1*t285,
        -mu_1_by_m_d_1*t105 - mu_2_by_m_d_1*t105 + mu_3_by_m_d_1*t286,
        -mu_1_by_m_d_1*t109 - mu_2_by_m_d_1*t109 + mu_3_by_m_d_1*t287,
        -mu_1_by_m_d_1*t113 - mu_2_by_m_d_1*t113 + mu_3_by_m_d_1*t288,
        mu_1_by_m_d_1*t289 - mu_2_by_m_d_1*t117 - mu_3_by_m_d_1*t117,
        -mu_1_by_m_d_1*t121 - mu_2_by_m_d_1*t121 - mu_3_by_m_d_1*t121,
        -mu_1_by_m_d_1*t125 - mu_2_by_m_d_1*t125 - mu_3_by_m_d_1*t125,
        -mu_1_by_m_d_1*t129 + mu_2_by_m_d_1*t290 - mu_3_by_m_d_1*t129,
        -mu_1_by_m_d_1*t133 - mu_2_by_m_d_1*t133 - mu_3_by_m_d_1*t133,
        -mu_1_by_m_d_1*t137 - mu_2_by_m_d_1*t137 + mu_3_by_m_d_1*t291,
        mu_1_by_m_d_1*t271 - mu_2_by_m_d_1*t57 - mu_3_by_m_d_1*t57,
        mu_1_by_m_d_1*t272 + mu_2_by_m_d_1*t273 - mu_3_by_m_d_1*t61,
        mu_1_by_m_d_1*t274 - mu_2_by_m_d_1*t65 + mu_3_by_m_d_1*t275,
        mu_1_by_m_d_1*t276 - mu_2_by_m_d_1*t69 - mu_3_by_m_d_1*t69,
        mu_1_by_m_d_1*t277 - mu_2_by_m_d_1*t73 - mu_3_by_m_d_1*t73,
        mu_1_by_m_d_1*t278 - mu_2_by_m_d_1*t77 - mu_3_by_m_d_1*t77,
        -mu_1_by_m_d_1*t81 + mu_2_by_m_d_1*t279 - mu_3_by_m_d_1*t81,
        -mu_1_by_m_d_1*t85 + mu_2_by_m_d_1*t280 + mu_3_by_m_d_1*t281,
        -mu_1_by_m_d_1*t89 + mu_2_by_m_d_1*t282 - mu_3_by_m_d_1*t89,
        -mu_1_by_m_d_1*t93 + mu_2_by_m_d_1*t283 - mu_3_by_m_d_1*t93,
        -mu_1_by_m_d_1*t97 + mu_2_by_m_d_1*t284 - mu_3_by_m_d_1*t97,
        -mu_1_by_m_d_1*t101 - mu_2_by_m_d_1*t101 + mu_3_by_m_d_1*t285,
        -mu_1_by_m_d_1*t105 - mu_2_by_m_d_1*t105 + mu_3_by_m_d_1*t286,
        -mu_1_by_m_d_1*t109 - mu_2_by_m_d_1*t109 + mu_3_by_m_d_1*t287,
        -mu_1_by_m_d_1*t113 - mu_2_by_m_d_1*t113 + mu_3_by_m_d_1*t288,
        mu_1_by_m_d_1*t289 - mu_2_by_m_d_1*t117 - mu_3_by_m_d_1*t117,
        -mu_1_by_m_d_1*t121 - mu_2_by_m_d_1*t121 - mu_3_by_m_d_1*t121,
        -mu_1_by_m_d_1*t125 - mu_2_by_m_d_1*t125 - mu_3_by_m_d_1*t125,
        -mu_1_by_m_d_1*t129 + mu_2_by_m_d_1*t290 - mu_3_by_m_d_1*t129,
        -mu_1_by_m_d_1*t133 - mu_2_by_m_d_1*t133 - mu_3_by_m_d_1*t133,
        -mu_1_by_m_d_1*t137 - mu_2_by_m_d_1*t137 + mu_3_by_m_d_1*t291,
        mu_1_by_m_d_1*t271 - mu_2_by_m_d_1*t57 - mu_3_by_m_d_1*t57,
        mu_1_by_m_d_1*t272 + mu_2_by_m_d_1*t273 - mu_3_by_m_d_1*t61,
        mu_1_by_m_d_1*t274 - mu_2_by_m_d_1*t65 + mu_3_by_m_d_1*t275,
        mu_1_by_m_d_1*t276 - mu_2_by_m_d_1*t69 - mu_3_by_m_d_1*t69,
        mu_1_by_m_d_1*t277 - mu_2_by_m_d_1*t73 - mu_3_by_m_d_1*t73,
        mu_1_by_m_d_1*t278 - mu_2_by_m_d_1*t77 - mu_3_by_m_d_1*t77,
        -mu_1_by_m_d_1*t81 + mu_2_by_m_d_1*t279 - mu_3_by_m_d_1*t81,
        -mu_1_by_m_d_1*t85 + mu_2_by_m_d_1*t280 + mu_3_by_m_d_1*t281,
        -mu_1_by_m_d_1*t89 + mu_2_by_m_d_1*t282 - mu_3_by_m_d_1*t89,
        -mu_1_by_m_d_1*t93 + mu_2_by_m_d_1*t283 - mu_3_by_m_d_1*t93,
        -mu_1_by_m_d_1*t97 + mu_2_by_m_d_1*t284 - mu_3_by_m_d_1*t97,
        -mu_1_by_m_d_1*t101 - mu_2_by_m_d_1*t101 + mu_3_by_m_d_1*t285,
        -mu_1_by_m_d_1*t105 - mu_2_by_m_d_1*t105 + mu_3_by_m_d_1*t286,
        -mu_1_by_m_d_1*t109 - mu_2_by_m_d_1*t109 + mu_3_by_m_d_1*t287,
        -mu_1_by_m_d_1*t113 - mu_2_by_m_d_1*t113 + mu_3_by_m_d_1*t288,
        mu_1_by_m_d_1*t289 - mu_2_by_m_d_1*t117 - mu_3_by_m_d_1*t117,
        -mu_1_by_m_d_1*t121 - mu_2_by_m_d_1*t121 - mu_3_by_m_d_1*t121,
        -mu_1_by_m_d_1*t125 - mu_2_by_m_d_1*t125 - mu_3_by_m_d_1*t125,
        -mu_1_by_m_d_1*t129 + mu_2_by_m_d_1*t290 - mu_3_by_m_d_1*t129,
        -mu_1_by_m_d_1*t133 - mu_2_by_m_d_1*t133 - mu_3_by_m_d_1*t133,
        -mu_1_by_m_d_1*t137 - mu_2_by_m_d_1*t137 + mu_3_by_m_d_1*t291, t298, t299, t300, t298, t198*t297,
        t299, t198*t294, t300, t298, t307, t308, t309, t307, t202*t306, t308, t202*t303, t309, t307, t316,
        t317, t318, t316, t205*t315, t317, t205*t312, t318, t316, t327, t328, t329, t327, -t198*t324 + t331,
        -t331, t328, -t198*t326 + t331, t329, t327, t340, t341, t342, t340, -t202*t337 + t344, -t344, t341,
        -t202*t339 + t344, t342, t340, t353, t354, t355, t353, -t205*t350 + t357, -t357, t354,
        -t205*t352 + t357, t355, t353, t365, t366, t367, t365, -t198*t362 + t368, -t368, t366,
        -t198*t364 + t368, t367, t365, t376, t377, t378, t376, -t202*t373 + t379, -t379, t377,
        -t202*t375 + t379, t378, t376, t387, t388, t389, t387, -t205*t384 + t390, -t390, t388,
        -t205*t386 + t390, t389, t387, -k_1_3, -k_1_2, k_1_3*t391 + t392, -t392, -k_1_3, k_1_2*t391 + t392,
        -k_1_2, -k_2_3, -k_2_2, k_2_3*t393 + t394, -t394, -k_2_3, k_2_2*t393 + t394, -k_2_2, -k_3_3, -k_3_2,
        k_3_3*t395 + t396, -t396, -k_3_3, k_3_2*t395 + t396, -k_3_2, t293, t397, t293, t399, -t399,
        t198*t293 + t399, t397, t293, t302, t400, t302, t402, -t402, t202*t302 + t402, t400, t302, t311, t403,
        t311, t405, -t405, t205*t311 + t405, t403, t311, -t296, t406, -t296, -t198*t296 - t399, t399, t406,
        -t399, -t296, -t305, t407, -t305, -t202*t305 - t402, t402, t407, -t402, -t305, -t314, t408, -t314,
        -t205*t314 - t405, t405, t408, -t405, -t314, t413, t414, t415, t413, -t198*t411 + t416, -t416, t414,
        -t198*t412 + t416, t415, t413, t421, t422, t423, t421, -t202*t419 + t424, -t424, t422,
        -t202*t420 + t424, t423, t421, t429, t430, t431, t429, -t205*t427 + t432, -t432, t430,
        -t205*t428 + t432, t431, t429, t436, t437, t438, t436, t442, t443, t444, t442, t448, t449, t450, t448,
        -t198*t435 - t451, t451, t437, -t202*t441 - t452, t452, t443, -t205*t447 - t453, t453, t449,
        -t198*t434 - t451, t438, -t202*t440 - t452, t444, -t205*t446 - t453, t450, t436, t442, t448, t57, t61,
        t65, t69, t73, t77, D_p_x_1, D_p_y_1, D_p_z_1, t81, t85, t89, t93, t97, D_p_x_2, D_p_y_2, D_p_z_2,
        t101, t105, t109, t113, D_p_x_3, D_p_y_3, D_p_z_3, t117, t121, t125, D_delta_x_1, D_delta_y_1,
        D_delta_z_1, t129, t133, D_delta_x_2, D_delta_y_2, D_delta_z_2, t137, D_delta_x_3, D_delta_y_3,
        D_delta_z_3, 1, 1, 1, mu_1_by_m_p*t271 - mu_2_by_m_p*t57 - mu_3_by_m_p*t57,
        mu_1_by_m_p*t272 + mu_2_by_m_p*t273 - mu_3_by_m_p*t61,
        mu_1_by_m_p*t274 - mu_2_by_m_p*t65 + mu_3_by_m_p*t275,
        mu_1_by_m_p*t276 - mu_2_by_m_p*t69 - mu_3_by_m_p*t69,
        mu_1_by_m_p*t277 - mu_2_by_m_p*t73 - mu_3_by_m_p*t73,
        mu_1_by_m_p*t278 - mu_2_by_m_p*t77 - mu_3_by_m_p*t77,
        -mu_1_by_m_p*t81 + mu_2_by_m_p*t279 - mu_3_by_m_p*t81,
        -mu_1_by_m_p*t85 + mu_2_by_m_p*t280 + mu_3_by_m_p*t281,
        -mu_1_by_m_p*t89 + mu_2_by_m_p*t282 - mu_3_by_m_p*t89,
        -mu_1_by_m_p*t93 + mu_2_by_m_p*t283 - mu_3_by_m_p*t93,
        -mu_1_by_m_p*t97 + mu_2_by_m_p*t284 - mu_3_by_m_p*t97,
        -mu_1_by_m_p*t101 - mu_2_by_m_p*t101 + mu_3_by_m_p*t285,
        -mu_1_by_m_p*t105 - mu_2_by_m_p*t105 + mu_3_by_m_p*t286,
        -mu_1_by_m_p*t109 - mu_2_by_m_p*t109 + mu_3_by_m_p*t287,
        -mu_1_by_m_p*t113 - mu_2_by_m_p*t113 + mu_3_by_m_p*t288,
        mu_1_by_m_p*t289 - mu_2_by_m_p*t117 - mu_3_by_m_p*t117,
        -mu_1_by_m_p*t121 - mu_2_by_m_p*t121 - mu_3_by_m_p*t121,
        -mu_1_by_m_p*t125 - mu_2_by_m_p*t125 - mu_3_by_m_p*t125,
        -mu_1_by_m_p*t129 + mu_2_by_m_p*t290 - mu_3_by_m_p*t129,
        -mu_1_by_m_p*t133 - mu_2_by_m_p*t133 - mu_3_by_m_p*t133,
        -mu_1_by_m_p*t137 - mu_2_by_m_p*t137 + mu_3_by_m_p*t291, d_1_1, d_2_1, d_3_1, d_1_2, d_2_2, d_3_2,
    ))
    return M_theta_out, K_theta_out


def geometry_sensitivities(p, parameters, effects):
    """Derivatives of M and K by the platform joints and link lengths, at a fixed platform pose.

    The entries of the upper triangles that GEOMETRY_SENSITIVITIES lists, all others being zero; by a rail's
    origin, the opposite of those by its joint.

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
    M_theta : array, shape (..., 540) [unit of M by that of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 564) [unit of K by that of the parameter]
        dK/dtheta.

    Notes
    -----
    Implicit function theorem and chain rule; the carriages follow the parameter.
    13219 operations; 64171338 with every named value written out.
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
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, l_t_1, k_sp_1, w_b_1, R_p_1,
        x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, k_C, m_L)
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
    t260 = a_B_1 + 1
    t261 = k_sp_1*t260*w_b_1
    t262 = c_E*t261
    t263 = 1.0/((l_f_1_2 + t262)**2)
    t264 = t261*x_1_by_b_1_x
    t265 = t263*t264
    t266 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    t267 = -D_p_x_1**2 - D_p_y_1**2 - D_p_z_1**2
    t268 = 1.0/((l_f_1_3 + t262)**2)
    t269 = D_p_x_2*mu_1
    t270 = D_p_x_2*mu_3
    t271 = U_2_x_2*mu_2
    t272 = D_p_y_2*mu_1
    t273 = D_p_y_2*mu_3
    t274 = U_2_y_2*mu_2
    t275 = D_p_z_2*mu_1
    t276 = D_p_z_2*mu_3
    t277 = U_2_z_2*mu_2
    t278 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    t279 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    t280 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2
    t281 = D_p_x_3*mu_1
    t282 = D_p_x_3*mu_2
    t283 = U_3_x_3*mu_3
    t284 = D_p_y_3*mu_1
    t285 = D_p_y_3*mu_2
    t286 = U_3_y_3*mu_3
    t287 = D_p_z_3*mu_1
    t288 = D_p_z_3*mu_2
    t289 = U_3_z_3*mu_3
    t290 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    t291 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3
    t292 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    t293 = t264*t268
    t294 = -R_p_1*t293
    t295 = R_p_1*t265
    t296 = D_p_x_1_by_b_1_x*k_C
    t297 = D_p_y_1_by_b_1_x*k_C
    t298 = D_p_z_1_by_b_1_x*k_C
    t299 = D_delta_x_1*mu_1
    t300 = D_delta_x_1*mu_2
    t301 = D_delta_x_1*mu_3
    t302 = D_delta_y_1*mu_1
    t303 = D_delta_y_1*mu_2
    t304 = D_delta_y_1*mu_3
    t305 = D_delta_z_1*mu_1
    t306 = D_delta_z_1*mu_2
    t307 = D_delta_z_1*mu_3
    t308 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t309 = -D_delta_x_1*D_p_x_1 - D_delta_y_1*D_p_y_1 - D_delta_z_1*D_p_z_1
    t310 = D_p_x_1*k_C - t248 - t250 - t251
    t311 = D_p_y_1*k_C - t252 - t254 - t255
    t312 = D_p_z_1*k_C - t256 - t258 - t259
    t313 = D_delta_x_2*mu_1
    t314 = D_delta_x_2*mu_2
    t315 = D_delta_x_2*mu_3
    t316 = D_delta_y_2*mu_1
    t317 = D_delta_y_2*mu_2
    t318 = D_delta_y_2*mu_3
    t319 = D_delta_z_2*mu_1
    t320 = D_delta_z_2*mu_2
    t321 = D_delta_z_2*mu_3
    t322 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t323 = -D_delta_x_2*D_p_x_1 - D_delta_y_2*D_p_y_1 - D_delta_z_2*D_p_z_1
    t324 = D_delta_x_3*mu_1
    t325 = D_delta_x_3*mu_2
    t326 = D_delta_x_3*mu_3
    t327 = D_delta_y_3*mu_1
    t328 = D_delta_y_3*mu_2
    t329 = D_delta_y_3*mu_3
    t330 = D_delta_z_3*mu_1
    t331 = D_delta_z_3*mu_2
    t332 = D_delta_z_3*mu_3
    t333 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t334 = -D_delta_x_3*D_p_x_1 - D_delta_y_3*D_p_y_1 - D_delta_z_3*D_p_z_1
    t335 = -t265 + t293
    t336 = 2*D_p_x_2_by_b_1_x
    t337 = 2*D_p_y_2_by_b_1_x
    t338 = 2*D_p_z_2_by_b_1_x
    t339 = -D_p_x_2**2 - D_p_y_2**2 - D_p_z_2**2
    t340 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t341 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3
    t342 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    t343 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    t344 = D_p_x_2_by_b_1_x*k_C
    t345 = D_p_y_2_by_b_1_x*k_C
    t346 = D_p_z_2_by_b_1_x*k_C
    t347 = -D_delta_x_1*D_p_x_2 - D_delta_y_1*D_p_y_2 - D_delta_z_1*D_p_z_2
    t348 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t349 = D_p_x_2*k_C - t269 - t270 - t271
    t350 = D_p_y_2*k_C - t272 - t273 - t274
    t351 = D_p_z_2*k_C - t275 - t276 - t277
    t352 = -D_delta_x_2*D_p_x_2 - D_delta_y_2*D_p_y_2 - D_delta_z_2*D_p_z_2
    t353 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t354 = -D_delta_x_3*D_p_x_2 - D_delta_y_3*D_p_y_2 - D_delta_z_3*D_p_z_2
    t355 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t356 = 2*D_p_x_3_by_b_1_x
    t357 = 2*D_p_y_3_by_b_1_x
    t358 = 2*D_p_z_3_by_b_1_x
    t359 = -D_p_x_3**2 - D_p_y_3**2 - D_p_z_3**2
    t360 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t361 = D_p_x_3_by_b_1_x*k_C
    t362 = D_p_y_3_by_b_1_x*k_C
    t363 = D_p_z_3_by_b_1_x*k_C
    t364 = -D_delta_x_1*D_p_x_3 - D_delta_y_1*D_p_y_3 - D_delta_z_1*D_p_z_3
    t365 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t366 = D_p_x_3*k_C - t281 - t282 - t283
    t367 = D_p_y_3*k_C - t284 - t285 - t286
    t368 = D_p_z_3*k_C - t287 - t288 - t289
    t369 = -D_delta_x_2*D_p_x_3 - D_delta_y_2*D_p_y_3 - D_delta_z_2*D_p_z_3
    t370 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t371 = -D_delta_x_3*D_p_x_3 - D_delta_y_3*D_p_y_3 - D_delta_z_3*D_p_z_3
    t372 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t373 = D_delta_x_1**2 + D_delta_y_1**2 + D_delta_z_1**2
    t374 = 2*D_delta_x_1*k_C - 2*t299 - 2*t300 - 2*t301
    t375 = 2*D_delta_y_1*k_C - 2*t302 - 2*t303 - 2*t304
    t376 = 2*D_delta_z_1*k_C - 2*t305 - 2*t306 - 2*t307
    t377 = 1 - t373
    t378 = -D_delta_x_1*D_delta_x_2 - D_delta_y_1*D_delta_y_2 - D_delta_z_1*D_delta_z_2
    t379 = D_delta_x_2*k_C - t313 - t314 - t315
    t380 = D_delta_x_1*k_C - t299 - t300 - t301
    t381 = D_delta_y_2*k_C - t316 - t317 - t318
    t382 = D_delta_y_1*k_C - t302 - t303 - t304
    t383 = D_delta_z_2*k_C - t319 - t320 - t321
    t384 = D_delta_z_1*k_C - t305 - t306 - t307
    t385 = -D_delta_x_1*D_delta_x_3 - D_delta_y_1*D_delta_y_3 - D_delta_z_1*D_delta_z_3
    t386 = D_delta_x_3*k_C - t324 - t325 - t326
    t387 = D_delta_y_3*k_C - t327 - t328 - t329
    t388 = D_delta_z_3*k_C - t330 - t331 - t332
    t389 = D_delta_x_2**2 + D_delta_y_2**2 + D_delta_z_2**2
    t390 = 2*D_delta_x_2*k_C - 2*t313 - 2*t314 - 2*t315
    t391 = 2*D_delta_y_2*k_C - 2*t316 - 2*t317 - 2*t318
    t392 = 2*D_delta_z_2*k_C - 2*t319 - 2*t320 - 2*t321
    t393 = 1 - t389
    t394 = -D_delta_x_2*D_delta_x_3 - D_delta_y_2*D_delta_y_3 - D_delta_z_2*D_delta_z_3
    t395 = D_delta_x_3**2 + D_delta_y_3**2 + D_delta_z_3**2
    t396 = 2*D_delta_x_3*k_C - 2*t324 - 2*t325 - 2*t326
    t397 = 2*D_delta_y_3*k_C - 2*t327 - 2*t328 - 2*t329
    t398 = 2*D_delta_z_3*k_C - 2*t330 - 2*t331 - 2*t332
    t399 = 1 - t395
    t400 = 2*D_p_x_1_by_b_1_y
    t401 = 2*D_p_y_1_by_b_1_y
    t402 = 2*D_p_z_1_by_b_1_y
    t403 = t261*x_1_by_b_1_y
    t404 = t263*t403
    t405 = t268*t403
    t406 = -R_p_1*t405
    t407 = R_p_1*t404
    t408 = D_delta_x_1*k_C
    t409 = D_delta_y_1*k_C
    t410 = D_delta_z_1*k_C
    t411 = D_delta_x_2*k_C
    t412 = D_delta_y_2*k_C
    t413 = D_delta_z_2*k_C
    t414 = D_delta_x_3*k_C
    t415 = D_delta_y_3*k_C
    t416 = D_delta_z_3*k_C
    t417 = -t404 + t405
    t418 = 2*D_p_x_2_by_b_1_y
    t419 = 2*D_p_y_2_by_b_1_y
    t420 = 2*D_p_z_2_by_b_1_y
    t421 = 2*D_p_x_3_by_b_1_y
    t422 = 2*D_p_y_3_by_b_1_y
    t423 = 2*D_p_z_3_by_b_1_y
    t424 = 2*D_p_x_1_by_b_1_z
    t425 = 2*D_p_y_1_by_b_1_z
    t426 = 2*D_p_z_1_by_b_1_z
    t427 = t261*x_1_by_b_1_z
    t428 = t263*t427
    t429 = t268*t427
    t430 = -R_p_1*t429
    t431 = R_p_1*t428
    t432 = -t428 + t429
    t433 = 2*D_p_x_2_by_b_1_z
    t434 = 2*D_p_y_2_by_b_1_z
    t435 = 2*D_p_z_2_by_b_1_z
    t436 = 2*D_p_x_3_by_b_1_z
    t437 = 2*D_p_y_3_by_b_1_z
    t438 = 2*D_p_z_3_by_b_1_z
    t439 = 2*D_p_x_1_by_b_2_x
    t440 = 2*D_p_y_1_by_b_2_x
    t441 = 2*D_p_z_1_by_b_2_x
    t442 = 2*D_p_x_2_by_b_2_x
    t443 = 2*D_p_y_2_by_b_2_x
    t444 = 2*D_p_z_2_by_b_2_x
    t445 = a_B_2 + 1
    t446 = k_sp_2*t445*w_b_2
    t447 = c_E*t446
    t448 = 1.0/((l_f_2_2 + t447)**2)
    t449 = t446*x_2_by_b_2_x
    t450 = t448*t449
    t451 = 1.0/((l_f_2_3 + t447)**2)
    t452 = t449*t451
    t453 = -R_p_2*t452
    t454 = R_p_2*t450
    t455 = -t450 + t452
    t456 = 2*D_p_x_3_by_b_2_x
    t457 = 2*D_p_y_3_by_b_2_x
    t458 = 2*D_p_z_3_by_b_2_x
    t459 = 2*D_p_x_1_by_b_2_y
    t460 = 2*D_p_y_1_by_b_2_y
    t461 = 2*D_p_z_1_by_b_2_y
    t462 = 2*D_p_x_2_by_b_2_y
    t463 = 2*D_p_y_2_by_b_2_y
    t464 = 2*D_p_z_2_by_b_2_y
    t465 = t446*x_2_by_b_2_y
    t466 = t448*t465
    t467 = t451*t465
    t468 = -R_p_2*t467
    t469 = R_p_2*t466
    t470 = -t466 + t467
    t471 = 2*D_p_x_3_by_b_2_y
    t472 = 2*D_p_y_3_by_b_2_y
    t473 = 2*D_p_z_3_by_b_2_y
    t474 = 2*D_p_x_1_by_b_2_z
    t475 = 2*D_p_y_1_by_b_2_z
    t476 = 2*D_p_z_1_by_b_2_z
    t477 = 2*D_p_x_2_by_b_2_z
    t478 = 2*D_p_y_2_by_b_2_z
    t479 = 2*D_p_z_2_by_b_2_z
    t480 = t446*x_2_by_b_2_z
    t481 = t448*t480
    t482 = t451*t480
    t483 = -R_p_2*t482
    t484 = R_p_2*t481
    t485 = -t481 + t482
    t486 = 2*D_p_x_3_by_b_2_z
    t487 = 2*D_p_y_3_by_b_2_z
    t488 = 2*D_p_z_3_by_b_2_z
    t489 = 2*D_p_x_1_by_b_3_x
    t490 = 2*D_p_y_1_by_b_3_x
    t491 = 2*D_p_z_1_by_b_3_x
    t492 = 2*D_p_x_2_by_b_3_x
    t493 = 2*D_p_y_2_by_b_3_x
    t494 = 2*D_p_z_2_by_b_3_x
    t495 = 2*D_p_x_3_by_b_3_x
    t496 = 2*D_p_y_3_by_b_3_x
    t497 = 2*D_p_z_3_by_b_3_x
    t498 = a_B_3 + 1
    t499 = k_sp_3*t498*w_b_3
    t500 = c_E*t499
    t501 = 1.0/((l_f_3_2 + t500)**2)
    t502 = t499*x_3_by_b_3_x
    t503 = t501*t502
    t504 = 1.0/((l_f_3_3 + t500)**2)
    t505 = t502*t504
    t506 = -R_p_3*t505
    t507 = R_p_3*t503
    t508 = -t503 + t505
    t509 = 2*D_p_x_1_by_b_3_y
    t510 = 2*D_p_y_1_by_b_3_y
    t511 = 2*D_p_z_1_by_b_3_y
    t512 = 2*D_p_x_2_by_b_3_y
    t513 = 2*D_p_y_2_by_b_3_y
    t514 = 2*D_p_z_2_by_b_3_y
    t515 = 2*D_p_x_3_by_b_3_y
    t516 = 2*D_p_y_3_by_b_3_y
    t517 = 2*D_p_z_3_by_b_3_y
    t518 = t499*x_3_by_b_3_y
    t519 = t501*t518
    t520 = t504*t518
    t521 = -R_p_3*t520
    t522 = R_p_3*t519
    t523 = -t519 + t520
    t524 = 2*D_p_x_1_by_b_3_z
    t525 = 2*D_p_y_1_by_b_3_z
    t526 = 2*D_p_z_1_by_b_3_z
    t527 = 2*D_p_x_2_by_b_3_z
    t528 = 2*D_p_y_2_by_b_3_z
    t529 = 2*D_p_z_2_by_b_3_z
    t530 = 2*D_p_x_3_by_b_3_z
    t531 = 2*D_p_y_3_by_b_3_z
    t532 = 2*D_p_z_3_by_b_3_z
    t533 = t499*x_3_by_b_3_z
    t534 = t501*t533
    t535 = t504*t533
    t536 = -R_p_3*t535
    t537 = R_p_3*t534
    t538 = -t534 + t535
    t539 = 2*D_p_x_1_by_l_d_1
    t540 = 2*D_p_y_1_by_l_d_1
    t541 = 2*D_p_z_1_by_l_d_1
    t542 = t261*x_1_by_l_d_1
    t543 = t263*t542
    t544 = t268*t542
    t545 = -R_p_1*t544
    t546 = R_p_1*t543
    t547 = -t543 + t544
    t548 = 2*D_p_x_2_by_l_d_1
    t549 = 2*D_p_y_2_by_l_d_1
    t550 = 2*D_p_z_2_by_l_d_1
    t551 = 2*D_p_x_3_by_l_d_1
    t552 = 2*D_p_y_3_by_l_d_1
    t553 = 2*D_p_z_3_by_l_d_1
    t554 = 2*D_p_x_1_by_l_d_2
    t555 = 2*D_p_y_1_by_l_d_2
    t556 = 2*D_p_z_1_by_l_d_2
    t557 = 2*D_p_x_2_by_l_d_2
    t558 = 2*D_p_y_2_by_l_d_2
    t559 = 2*D_p_z_2_by_l_d_2
    t560 = t446*x_2_by_l_d_2
    t561 = t448*t560
    t562 = t451*t560
    t563 = -R_p_2*t562
    t564 = R_p_2*t561
    t565 = -t561 + t562
    t566 = 2*D_p_x_3_by_l_d_2
    t567 = 2*D_p_y_3_by_l_d_2
    t568 = 2*D_p_z_3_by_l_d_2
    t569 = 2*D_p_x_1_by_l_d_3
    t570 = 2*D_p_y_1_by_l_d_3
    t571 = 2*D_p_z_1_by_l_d_3
    t572 = 2*D_p_x_2_by_l_d_3
    t573 = 2*D_p_y_2_by_l_d_3
    t574 = 2*D_p_z_2_by_l_d_3
    t575 = 2*D_p_x_3_by_l_d_3
    t576 = 2*D_p_y_3_by_l_d_3
    t577 = 2*D_p_z_3_by_l_d_3
    t578 = t499*x_3_by_l_d_3
    t579 = t501*t578
    t580 = t504*t578
    t581 = -R_p_3*t580
    t582 = R_p_3*t579
    t583 = -t579 + t580
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
        + k_sp_1*t260*t268*w_b_1*x_1_by_b_1_x + mu_1_by_b_1_x*t266 + mu_2_by_b_1_x*t267
        + mu_3_by_b_1_x*t267 - t248*t249 - t249*t250 - t249*t251 - t252*t253 - t253*t254 - t253*t255
        - t256*t257 - t257*t258 - t257*t259 - t265,
        D_p_x_1*D_p_x_2_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_2*k_C - D_p_x_1_by_b_1_x*t269
        - D_p_x_1_by_b_1_x*t270 - D_p_x_1_by_b_1_x*t271 - D_p_x_2_by_b_1_x*t248 - D_p_x_2_by_b_1_x*t250
        - D_p_x_2_by_b_1_x*t251 + D_p_y_1*D_p_y_2_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_2*k_C
        - D_p_y_1_by_b_1_x*t272 - D_p_y_1_by_b_1_x*t273 - D_p_y_1_by_b_1_x*t274 - D_p_y_2_by_b_1_x*t252
        - D_p_y_2_by_b_1_x*t254 - D_p_y_2_by_b_1_x*t255 + D_p_z_1*D_p_z_2_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_2*k_C - D_p_z_1_by_b_1_x*t275 - D_p_z_1_by_b_1_x*t276
        - D_p_z_1_by_b_1_x*t277 - D_p_z_2_by_b_1_x*t256 - D_p_z_2_by_b_1_x*t258 - D_p_z_2_by_b_1_x*t259
        + mu_1_by_b_1_x*t278 + mu_2_by_b_1_x*t279 + mu_3_by_b_1_x*t280,
        D_p_x_1*D_p_x_3_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_3*k_C - D_p_x_1_by_b_1_x*t281
        - D_p_x_1_by_b_1_x*t282 - D_p_x_1_by_b_1_x*t283 - D_p_x_3_by_b_1_x*t248 - D_p_x_3_by_b_1_x*t250
        - D_p_x_3_by_b_1_x*t251 + D_p_y_1*D_p_y_3_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_3*k_C
        - D_p_y_1_by_b_1_x*t284 - D_p_y_1_by_b_1_x*t285 - D_p_y_1_by_b_1_x*t286 - D_p_y_3_by_b_1_x*t252
        - D_p_y_3_by_b_1_x*t254 - D_p_y_3_by_b_1_x*t255 + D_p_z_1*D_p_z_3_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_3*k_C - D_p_z_1_by_b_1_x*t287 - D_p_z_1_by_b_1_x*t288
        - D_p_z_1_by_b_1_x*t289 - D_p_z_3_by_b_1_x*t256 - D_p_z_3_by_b_1_x*t258 - D_p_z_3_by_b_1_x*t259
        + mu_1_by_b_1_x*t290 + mu_2_by_b_1_x*t291 + mu_3_by_b_1_x*t292,
        t294, t295,
        D_delta_x_1*t296 + D_delta_x_1_by_b_1_x*t310 + D_delta_y_1*t297 + D_delta_y_1_by_b_1_x*t311
        + D_delta_z_1*t298 + D_delta_z_1_by_b_1_x*t312 - D_p_x_1_by_b_1_x*t299 - D_p_x_1_by_b_1_x*t300
        - D_p_x_1_by_b_1_x*t301 - D_p_y_1_by_b_1_x*t302 - D_p_y_1_by_b_1_x*t303 - D_p_y_1_by_b_1_x*t304
        - D_p_z_1_by_b_1_x*t305 - D_p_z_1_by_b_1_x*t306 - D_p_z_1_by_b_1_x*t307 + mu_1_by_b_1_x*t308
        + mu_2_by_b_1_x*t309 + mu_3_by_b_1_x*t309,
        D_delta_x_2*t296 + D_delta_x_2_by_b_1_x*t310 + D_delta_y_2*t297 + D_delta_y_2_by_b_1_x*t311
        + D_delta_z_2*t298 + D_delta_z_2_by_b_1_x*t312 - D_p_x_1_by_b_1_x*t313 - D_p_x_1_by_b_1_x*t314
        - D_p_x_1_by_b_1_x*t315 - D_p_y_1_by_b_1_x*t316 - D_p_y_1_by_b_1_x*t317 - D_p_y_1_by_b_1_x*t318
        - D_p_z_1_by_b_1_x*t319 - D_p_z_1_by_b_1_x*t320 - D_p_z_1_by_b_1_x*t321 + mu_1_by_b_1_x*t322
        + mu_2_by_b_1_x*t323 + mu_3_by_b_1_x*t323,
        D_delta_x_3*t296 + D_delta_x_3_by_b_1_x*t310 + D_delta_y_3*t297 + D_delta_y_3_by_b_1_x*t311
        + D_delta_z_3*t298 + D_delta_z_3_by_b_1_x*t312 - D_p_x_1_by_b_1_x*t324 - D_p_x_1_by_b_1_x*t325
        - D_p_x_1_by_b_1_x*t326 - D_p_y_1_by_b_1_x*t327 - D_p_y_1_by_b_1_x*t328 - D_p_y_1_by_b_1_x*t329
        - D_p_z_1_by_b_1_x*t330 - D_p_z_1_by_b_1_x*t331 - D_p_z_1_by_b_1_x*t332 + mu_1_by_b_1_x*t333
        + mu_2_by_b_1_x*t334 + mu_3_by_b_1_x*t334,
        t335, t296, t297, t298,
        2*D_p_x_2*D_p_x_2_by_b_1_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_x*k_C
        + mu_1_by_b_1_x*t339 + mu_2_by_b_1_x*t340 + mu_3_by_b_1_x*t339 - t269*t336 - t270*t336 - t271*t336
        - t272*t337 - t273*t337 - t274*t337 - t275*t338 - t276*t338 - t277*t338,
        D_p_x_2*D_p_x_3_by_b_1_x*k_C + D_p_x_2_by_b_1_x*D_p_x_3*k_C - D_p_x_2_by_b_1_x*t281
        - D_p_x_2_by_b_1_x*t282 - D_p_x_2_by_b_1_x*t283 - D_p_x_3_by_b_1_x*t269 - D_p_x_3_by_b_1_x*t270
        - D_p_x_3_by_b_1_x*t271 + D_p_y_2*D_p_y_3_by_b_1_x*k_C + D_p_y_2_by_b_1_x*D_p_y_3*k_C
        - D_p_y_2_by_b_1_x*t284 - D_p_y_2_by_b_1_x*t285 - D_p_y_2_by_b_1_x*t286 - D_p_y_3_by_b_1_x*t272
        - D_p_y_3_by_b_1_x*t273 - D_p_y_3_by_b_1_x*t274 + D_p_z_2*D_p_z_3_by_b_1_x*k_C
        + D_p_z_2_by_b_1_x*D_p_z_3*k_C - D_p_z_2_by_b_1_x*t287 - D_p_z_2_by_b_1_x*t288
        - D_p_z_2_by_b_1_x*t289 - D_p_z_3_by_b_1_x*t275 - D_p_z_3_by_b_1_x*t276 - D_p_z_3_by_b_1_x*t277
        + mu_1_by_b_1_x*t341 + mu_2_by_b_1_x*t342 + mu_3_by_b_1_x*t343,
        D_delta_x_1*t344 + D_delta_x_1_by_b_1_x*t349 + D_delta_y_1*t345 + D_delta_y_1_by_b_1_x*t350
        + D_delta_z_1*t346 + D_delta_z_1_by_b_1_x*t351 - D_p_x_2_by_b_1_x*t299 - D_p_x_2_by_b_1_x*t300
        - D_p_x_2_by_b_1_x*t301 - D_p_y_2_by_b_1_x*t302 - D_p_y_2_by_b_1_x*t303 - D_p_y_2_by_b_1_x*t304
        - D_p_z_2_by_b_1_x*t305 - D_p_z_2_by_b_1_x*t306 - D_p_z_2_by_b_1_x*t307 + mu_1_by_b_1_x*t347
        + mu_2_by_b_1_x*t348 + mu_3_by_b_1_x*t347,
        D_delta_x_2*t344 + D_delta_x_2_by_b_1_x*t349 + D_delta_y_2*t345 + D_delta_y_2_by_b_1_x*t350
        + D_delta_z_2*t346 + D_delta_z_2_by_b_1_x*t351 - D_p_x_2_by_b_1_x*t313 - D_p_x_2_by_b_1_x*t314
        - D_p_x_2_by_b_1_x*t315 - D_p_y_2_by_b_1_x*t316 - D_p_y_2_by_b_1_x*t317 - D_p_y_2_by_b_1_x*t318
        - D_p_z_2_by_b_1_x*t319 - D_p_z_2_by_b_1_x*t320 - D_p_z_2_by_b_1_x*t321 + mu_1_by_b_1_x*t352
        + mu_2_by_b_1_x*t353 + mu_3_by_b_1_x*t352,
        D_delta_x_3*t344 + D_delta_x_3_by_b_1_x*t349 + D_delta_y_3*t345 + D_delta_y_3_by_b_1_x*t350
        + D_delta_z_3*t346 + D_delta_z_3_by_b_1_x*t351 - D_p_x_2_by_b_1_x*t324 - D_p_x_2_by_b_1_x*t325
        - D_p_x_2_by_b_1_x*t326 - D_p_y_2_by_b_1_x*t327 - D_p_y_2_by_b_1_x*t328 - D_p_y_2_by_b_1_x*t329
        - D_p_z_2_by_b_1_x*t330 - D_p_z_2_by_b_1_x*t331 - D_p_z_2_by_b_1_x*t332 + mu_1_by_b_1_x*t354
        + mu_2_by_b_1_x*t355 + mu_3_by_b_1_x*t354,
        t344, t345, t346,
        2*D_p_x_3*D_p_x_3_by_b_1_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_x*k_C
        + mu_1_by_b_1_x*t359 + mu_2_by_b_1_x*t359 + mu_3_by_b_1_x*t360 - t281*t356 - t282*t356 - t283*t356
        - t284*t357 - t285*t357 - t286*t357 - t287*t358 - t288*t358 - t289*t358,
        D_delta_x_1*t361 + D_delta_x_1_by_b_1_x*t366 + D_delta_y_1*t362 + D_delta_y_1_by_b_1_x*t367
        + D_delta_z_1*t363 + D_delta_z_1_by_b_1_x*t368 - D_p_x_3_by_b_1_x*t299 - D_p_x_3_by_b_1_x*t300
        - D_p_x_3_by_b_1_x*t301 - D_p_y_3_by_b_1_x*t302 - D_p_y_3_by_b_1_x*t303 - D_p_y_3_by_b_1_x*t304
        - D_p_z_3_by_b_1_x*t305 - D_p_z_3_by_b_1_x*t306 - D_p_z_3_by_b_1_x*t307 + mu_1_by_b_1_x*t364
        + mu_2_by_b_1_x*t364 + mu_3_by_b_1_x*t365,
        D_delta_x_2*t361 + D_delta_x_2_by_b_1_x*t366 + D_delta_y_2*t362 + D_delta_y_2_by_b_1_x*t367
        + D_delta_z_2*t363 + D_delta_z_2_by_b_1_x*t368 - D_p_x_3_by_b_1_x*t313 - D_p_x_3_by_b_1_x*t314
        - D_p_x_3_by_b_1_x*t315 - D_p_y_3_by_b_1_x*t316 - D_p_y_3_by_b_1_x*t317 - D_p_y_3_by_b_1_x*t318
        - D_p_z_3_by_b_1_x*t319 - D_p_z_3_by_b_1_x*t320 - D_p_z_3_by_b_1_x*t321 + mu_1_by_b_1_x*t369
        + mu_2_by_b_1_x*t369 + mu_3_by_b_1_x*t370,
        D_delta_x_3*t361 + D_delta_x_3_by_b_1_x*t366 + D_delta_y_3*t362 + D_delta_y_3_by_b_1_x*t367
        + D_delta_z_3*t363 + D_delta_z_3_by_b_1_x*t368 - D_p_x_3_by_b_1_x*t324 - D_p_x_3_by_b_1_x*t325
        - D_p_x_3_by_b_1_x*t326 - D_p_y_3_by_b_1_x*t327 - D_p_y_3_by_b_1_x*t328 - D_p_y_3_by_b_1_x*t329
        - D_p_z_3_by_b_1_x*t330 - D_p_z_3_by_b_1_x*t331 - D_p_z_3_by_b_1_x*t332 + mu_1_by_b_1_x*t371
        + mu_2_by_b_1_x*t371 + mu_3_by_b_1_x*t372,
        t361, t362, t363, t185*t293, t294, -t185*t265, t295,
        D_delta_x_1_by_b_1_x*t374 + D_delta_y_1_by_b_1_x*t375 + D_delta_z_1_by_b_1_x*t376
        + mu_1_by_b_1_x*t377 - mu_2_by_b_1_x*t373 - mu_3_by_b_1_x*t373,
        D_delta_x_1_by_b_1_x*t379 + D_delta_x_2_by_b_1_x*t380 + D_delta_y_1_by_b_1_x*t381
        + D_delta_y_2_by_b_1_x*t382 + D_delta_z_1_by_b_1_x*t383 + D_delta_z_2_by_b_1_x*t384
        + mu_1_by_b_1_x*t378 + mu_2_by_b_1_x*t378 + mu_3_by_b_1_x*t378,
        D_delta_x_1_by_b_1_x*t386 + D_delta_x_3_by_b_1_x*t380 + D_delta_y_1_by_b_1_x*t387
        + D_delta_y_3_by_b_1_x*t382 + D_delta_z_1_by_b_1_x*t388 + D_delta_z_3_by_b_1_x*t384
        + mu_1_by_b_1_x*t385 + mu_2_by_b_1_x*t385 + mu_3_by_b_1_x*t385,
        D_delta_x_1_by_b_1_x*k_C, D_delta_y_1_by_b_1_x*k_C, D_delta_z_1_by_b_1_x*k_C,
        D_delta_x_2_by_b_1_x*t390 + D_delta_y_2_by_b_1_x*t391 + D_delta_z_2_by_b_1_x*t392
        - mu_1_by_b_1_x*t389 + mu_2_by_b_1_x*t393 - mu_3_by_b_1_x*t389,
        D_delta_x_2_by_b_1_x*t386 + D_delta_x_3_by_b_1_x*t379 + D_delta_y_2_by_b_1_x*t387
        + D_delta_y_3_by_b_1_x*t381 + D_delta_z_2_by_b_1_x*t388 + D_delta_z_3_by_b_1_x*t383
        + mu_1_by_b_1_x*t394 + mu_2_by_b_1_x*t394 + mu_3_by_b_1_x*t394,
        D_delta_x_2_by_b_1_x*k_C, D_delta_y_2_by_b_1_x*k_C, D_delta_z_2_by_b_1_x*k_C,
        D_delta_x_3_by_b_1_x*t396 + D_delta_y_3_by_b_1_x*t397 + D_delta_z_3_by_b_1_x*t398
        - mu_1_by_b_1_x*t395 - mu_2_by_b_1_x*t395 + mu_3_by_b_1_x*t399,
        D_delta_x_3_by_b_1_x*k_C, D_delta_y_3_by_b_1_x*k_C, D_delta_z_3_by_b_1_x*k_C, t335,
        2*D_p_x_1*D_p_x_1_by_b_1_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_y*k_C
        + k_sp_1*t260*t268*w_b_1*x_1_by_b_1_y + mu_1_by_b_1_y*t266 + mu_2_by_b_1_y*t267
        + mu_3_by_b_1_y*t267 - t248*t400 - t250*t400 - t251*t400 - t252*t401 - t254*t401 - t255*t401
        - t256*t402 - t258*t402 - t259*t402 - t404,
        D_p_x_1*D_p_x_2_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_2*k_C - D_p_x_1_by_b_1_y*t269
        - D_p_x_1_by_b_1_y*t270 - D_p_x_1_by_b_1_y*t271 - D_p_x_2_by_b_1_y*t248 - D_p_x_2_by_b_1_y*t250
        - D_p_x_2_by_b_1_y*t251 + D_p_y_1*D_p_y_2_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_2*k_C
        - D_p_y_1_by_b_1_y*t272 - D_p_y_1_by_b_1_y*t273 - D_p_y_1_by_b_1_y*t274 - D_p_y_2_by_b_1_y*t252
        - D_p_y_2_by_b_1_y*t254 - D_p_y_2_by_b_1_y*t255 + D_p_z_1*D_p_z_2_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_2*k_C - D_p_z_1_by_b_1_y*t275 - D_p_z_1_by_b_1_y*t276
        - D_p_z_1_by_b_1_y*t277 - D_p_z_2_by_b_1_y*t256 - D_p_z_2_by_b_1_y*t258 - D_p_z_2_by_b_1_y*t259
        + mu_1_by_b_1_y*t278 + mu_2_by_b_1_y*t279 + mu_3_by_b_1_y*t280,
        D_p_x_1*D_p_x_3_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_3*k_C - D_p_x_1_by_b_1_y*t281
        - D_p_x_1_by_b_1_y*t282 - D_p_x_1_by_b_1_y*t283 - D_p_x_3_by_b_1_y*t248 - D_p_x_3_by_b_1_y*t250
        - D_p_x_3_by_b_1_y*t251 + D_p_y_1*D_p_y_3_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_3*k_C
        - D_p_y_1_by_b_1_y*t284 - D_p_y_1_by_b_1_y*t285 - D_p_y_1_by_b_1_y*t286 - D_p_y_3_by_b_1_y*t252
        - D_p_y_3_by_b_1_y*t254 - D_p_y_3_by_b_1_y*t255 + D_p_z_1*D_p_z_3_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_3*k_C - D_p_z_1_by_b_1_y*t287 - D_p_z_1_by_b_1_y*t288
        - D_p_z_1_by_b_1_y*t289 - D_p_z_3_by_b_1_y*t256 - D_p_z_3_by_b_1_y*t258 - D_p_z_3_by_b_1_y*t259
        + mu_1_by_b_1_y*t290 + mu_2_by_b_1_y*t291 + mu_3_by_b_1_y*t292,
        t406, t407,
        D_delta_x_1_by_b_1_y*t310 + D_delta_y_1_by_b_1_y*t311 + D_delta_z_1_by_b_1_y*t312
        - D_p_x_1_by_b_1_y*t299 - D_p_x_1_by_b_1_y*t300 - D_p_x_1_by_b_1_y*t301 + D_p_x_1_by_b_1_y*t408
        - D_p_y_1_by_b_1_y*t302 - D_p_y_1_by_b_1_y*t303 - D_p_y_1_by_b_1_y*t304 + D_p_y_1_by_b_1_y*t409
        - D_p_z_1_by_b_1_y*t305 - D_p_z_1_by_b_1_y*t306 - D_p_z_1_by_b_1_y*t307 + D_p_z_1_by_b_1_y*t410
        + mu_1_by_b_1_y*t308 + mu_2_by_b_1_y*t309 + mu_3_by_b_1_y*t309,
        D_delta_x_2_by_b_1_y*t310 + D_delta_y_2_by_b_1_y*t311 + D_delta_z_2_by_b_1_y*t312
        - D_p_x_1_by_b_1_y*t313 - D_p_x_1_by_b_1_y*t314 - D_p_x_1_by_b_1_y*t315 + D_p_x_1_by_b_1_y*t411
        - D_p_y_1_by_b_1_y*t316 - D_p_y_1_by_b_1_y*t317 - D_p_y_1_by_b_1_y*t318 + D_p_y_1_by_b_1_y*t412
        - D_p_z_1_by_b_1_y*t319 - D_p_z_1_by_b_1_y*t320 - D_p_z_1_by_b_1_y*t321 + D_p_z_1_by_b_1_y*t413
        + mu_1_by_b_1_y*t322 + mu_2_by_b_1_y*t323 + mu_3_by_b_1_y*t323,
        D_delta_x_3_by_b_1_y*t310 + D_delta_y_3_by_b_1_y*t311 + D_delta_z_3_by_b_1_y*t312
        - D_p_x_1_by_b_1_y*t324 - D_p_x_1_by_b_1_y*t325 - D_p_x_1_by_b_1_y*t326 + D_p_x_1_by_b_1_y*t414
        - D_p_y_1_by_b_1_y*t327 - D_p_y_1_by_b_1_y*t328 - D_p_y_1_by_b_1_y*t329 + D_p_y_1_by_b_1_y*t415
        - D_p_z_1_by_b_1_y*t330 - D_p_z_1_by_b_1_y*t331 - D_p_z_1_by_b_1_y*t332 + D_p_z_1_by_b_1_y*t416
        + mu_1_by_b_1_y*t333 + mu_2_by_b_1_y*t334 + mu_3_by_b_1_y*t334,
        t417, D_p_x_1_by_b_1_y*k_C, D_p_y_1_by_b_1_y*k_C, D_p_z_1_by_b_1_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_y*k_C
        + mu_1_by_b_1_y*t339 + mu_2_by_b_1_y*t340 + mu_3_by_b_1_y*t339 - t269*t418 - t270*t418 - t271*t418
        - t272*t419 - t273*t419 - t274*t419 - t275*t420 - t276*t420 - t277*t420,
        D_p_x_2*D_p_x_3_by_b_1_y*k_C + D_p_x_2_by_b_1_y*D_p_x_3*k_C - D_p_x_2_by_b_1_y*t281
        - D_p_x_2_by_b_1_y*t282 - D_p_x_2_by_b_1_y*t283 - D_p_x_3_by_b_1_y*t269 - D_p_x_3_by_b_1_y*t270
        - D_p_x_3_by_b_1_y*t271 + D_p_y_2*D_p_y_3_by_b_1_y*k_C + D_p_y_2_by_b_1_y*D_p_y_3*k_C
        - D_p_y_2_by_b_1_y*t284 - D_p_y_2_by_b_1_y*t285 - D_p_y_2_by_b_1_y*t286 - D_p_y_3_by_b_1_y*t272
        - D_p_y_3_by_b_1_y*t273 - D_p_y_3_by_b_1_y*t274 + D_p_z_2*D_p_z_3_by_b_1_y*k_C
        + D_p_z_2_by_b_1_y*D_p_z_3*k_C - D_p_z_2_by_b_1_y*t287 - D_p_z_2_by_b_1_y*t288
        - D_p_z_2_by_b_1_y*t289 - D_p_z_3_by_b_1_y*t275 - D_p_z_3_by_b_1_y*t276 - D_p_z_3_by_b_1_y*t277
        + mu_1_by_b_1_y*t341 + mu_2_by_b_1_y*t342 + mu_3_by_b_1_y*t343,
        D_delta_x_1_by_b_1_y*t349 + D_delta_y_1_by_b_1_y*t350 + D_delta_z_1_by_b_1_y*t351
        - D_p_x_2_by_b_1_y*t299 - D_p_x_2_by_b_1_y*t300 - D_p_x_2_by_b_1_y*t301 + D_p_x_2_by_b_1_y*t408
        - D_p_y_2_by_b_1_y*t302 - D_p_y_2_by_b_1_y*t303 - D_p_y_2_by_b_1_y*t304 + D_p_y_2_by_b_1_y*t409
        - D_p_z_2_by_b_1_y*t305 - D_p_z_2_by_b_1_y*t306 - D_p_z_2_by_b_1_y*t307 + D_p_z_2_by_b_1_y*t410
        + mu_1_by_b_1_y*t347 + mu_2_by_b_1_y*t348 + mu_3_by_b_1_y*t347,
        D_delta_x_2_by_b_1_y*t349 + D_delta_y_2_by_b_1_y*t350 + D_delta_z_2_by_b_1_y*t351
        - D_p_x_2_by_b_1_y*t313 - D_p_x_2_by_b_1_y*t314 - D_p_x_2_by_b_1_y*t315 + D_p_x_2_by_b_1_y*t411
        - D_p_y_2_by_b_1_y*t316 - D_p_y_2_by_b_1_y*t317 - D_p_y_2_by_b_1_y*t318 + D_p_y_2_by_b_1_y*t412
        - D_p_z_2_by_b_1_y*t319 - D_p_z_2_by_b_1_y*t320 - D_p_z_2_by_b_1_y*t321 + D_p_z_2_by_b_1_y*t413
        + mu_1_by_b_1_y*t352 + mu_2_by_b_1_y*t353 + mu_3_by_b_1_y*t352,
        D_delta_x_3_by_b_1_y*t349 + D_delta_y_3_by_b_1_y*t350 + D_delta_z_3_by_b_1_y*t351
        - D_p_x_2_by_b_1_y*t324 - D_p_x_2_by_b_1_y*t325 - D_p_x_2_by_b_1_y*t326 + D_p_x_2_by_b_1_y*t414
        - D_p_y_2_by_b_1_y*t327 - D_p_y_2_by_b_1_y*t328 - D_p_y_2_by_b_1_y*t329 + D_p_y_2_by_b_1_y*t415
        - D_p_z_2_by_b_1_y*t330 - D_p_z_2_by_b_1_y*t331 - D_p_z_2_by_b_1_y*t332 + D_p_z_2_by_b_1_y*t416
        + mu_1_by_b_1_y*t354 + mu_2_by_b_1_y*t355 + mu_3_by_b_1_y*t354,
        D_p_x_2_by_b_1_y*k_C, D_p_y_2_by_b_1_y*k_C, D_p_z_2_by_b_1_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_y*k_C
        + mu_1_by_b_1_y*t359 + mu_2_by_b_1_y*t359 + mu_3_by_b_1_y*t360 - t281*t421 - t282*t421 - t283*t421
        - t284*t422 - t285*t422 - t286*t422 - t287*t423 - t288*t423 - t289*t423,
        D_delta_x_1_by_b_1_y*t366 + D_delta_y_1_by_b_1_y*t367 + D_delta_z_1_by_b_1_y*t368
        - D_p_x_3_by_b_1_y*t299 - D_p_x_3_by_b_1_y*t300 - D_p_x_3_by_b_1_y*t301 + D_p_x_3_by_b_1_y*t408
        - D_p_y_3_by_b_1_y*t302 - D_p_y_3_by_b_1_y*t303 - D_p_y_3_by_b_1_y*t304 + D_p_y_3_by_b_1_y*t409
        - D_p_z_3_by_b_1_y*t305 - D_p_z_3_by_b_1_y*t306 - D_p_z_3_by_b_1_y*t307 + D_p_z_3_by_b_1_y*t410
        + mu_1_by_b_1_y*t364 + mu_2_by_b_1_y*t364 + mu_3_by_b_1_y*t365,
        D_delta_x_2_by_b_1_y*t366 + D_delta_y_2_by_b_1_y*t367 + D_delta_z_2_by_b_1_y*t368
        - D_p_x_3_by_b_1_y*t313 - D_p_x_3_by_b_1_y*t314 - D_p_x_3_by_b_1_y*t315 + D_p_x_3_by_b_1_y*t411
        - D_p_y_3_by_b_1_y*t316 - D_p_y_3_by_b_1_y*t317 - D_p_y_3_by_b_1_y*t318 + D_p_y_3_by_b_1_y*t412
        - D_p_z_3_by_b_1_y*t319 - D_p_z_3_by_b_1_y*t320 - D_p_z_3_by_b_1_y*t321 + D_p_z_3_by_b_1_y*t413
        + mu_1_by_b_1_y*t369 + mu_2_by_b_1_y*t369 + mu_3_by_b_1_y*t370,
        D_delta_x_3_by_b_1_y*t366 + D_delta_y_3_by_b_1_y*t367 + D_delta_z_3_by_b_1_y*t368
        - D_p_x_3_by_b_1_y*t324 - D_p_x_3_by_b_1_y*t325 - D_p_x_3_by_b_1_y*t326 + D_p_x_3_by_b_1_y*t414
        - D_p_y_3_by_b_1_y*t327 - D_p_y_3_by_b_1_y*t328 - D_p_y_3_by_b_1_y*t329 + D_p_y_3_by_b_1_y*t415
        - D_p_z_3_by_b_1_y*t330 - D_p_z_3_by_b_1_y*t331 - D_p_z_3_by_b_1_y*t332 + D_p_z_3_by_b_1_y*t416
        + mu_1_by_b_1_y*t371 + mu_2_by_b_1_y*t371 + mu_3_by_b_1_y*t372,
        D_p_x_3_by_b_1_y*k_C, D_p_y_3_by_b_1_y*k_C, D_p_z_3_by_b_1_y*k_C, t185*t405, t406, -t185*t404, t407,
        D_delta_x_1_by_b_1_y*t374 + D_delta_y_1_by_b_1_y*t375 + D_delta_z_1_by_b_1_y*t376
        + mu_1_by_b_1_y*t377 - mu_2_by_b_1_y*t373 - mu_3_by_b_1_y*t373,
        D_delta_x_1_by_b_1_y*t379 + D_delta_x_2_by_b_1_y*t380 + D_delta_y_1_by_b_1_y*t381
        + D_delta_y_2_by_b_1_y*t382 + D_delta_z_1_by_b_1_y*t383 + D_delta_z_2_by_b_1_y*t384
        + mu_1_by_b_1_y*t378 + mu_2_by_b_1_y*t378 + mu_3_by_b_1_y*t378,
        D_delta_x_1_by_b_1_y*t386 + D_delta_x_3_by_b_1_y*t380 + D_delta_y_1_by_b_1_y*t387
        + D_delta_y_3_by_b_1_y*t382 + D_delta_z_1_by_b_1_y*t388 + D_delta_z_3_by_b_1_y*t384
        + mu_1_by_b_1_y*t385 + mu_2_by_b_1_y*t385 + mu_3_by_b_1_y*t385,
        D_delta_x_1_by_b_1_y*k_C, D_delta_y_1_by_b_1_y*k_C, D_delta_z_1_by_b_1_y*k_C,
        D_delta_x_2_by_b_1_y*t390 + D_delta_y_2_by_b_1_y*t391 + D_delta_z_2_by_b_1_y*t392
        - mu_1_by_b_1_y*t389 + mu_2_by_b_1_y*t393 - mu_3_by_b_1_y*t389,
        D_delta_x_2_by_b_1_y*t386 + D_delta_x_3_by_b_1_y*t379 + D_delta_y_2_by_b_1_y*t387
        + D_delta_y_3_by_b_1_y*t381 + D_delta_z_2_by_b_1_y*t388 + D_delta_z_3_by_b_1_y*t383
        + mu_1_by_b_1_y*t394 + mu_2_by_b_1_y*t394 + mu_3_by_b_1_y*t394,
        D_delta_x_2_by_b_1_y*k_C, D_delta_y_2_by_b_1_y*k_C, D_delta_z_2_by_b_1_y*k_C,
        D_delta_x_3_by_b_1_y*t396 + D_delta_y_3_by_b_1_y*t397 + D_delta_z_3_by_b_1_y*t398
        - mu_1_by_b_1_y*t395 - mu_2_by_b_1_y*t395 + mu_3_by_b_1_y*t399,
        D_delta_x_3_by_b_1_y*k_C, D_delta_y_3_by_b_1_y*k_C, D_delta_z_3_by_b_1_y*k_C, t417,
        2*D_p_x_1*D_p_x_1_by_b_1_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_z*k_C
        + k_sp_1*t260*t268*w_b_1*x_1_by_b_1_z + mu_1_by_b_1_z*t266 + mu_2_by_b_1_z*t267
        + mu_3_by_b_1_z*t267 - t248*t424 - t250*t424 - t251*t424 - t252*t425 - t254*t425 - t255*t425
        - t256*t426 - t258*t426 - t259*t426 - t428,
        D_p_x_1*D_p_x_2_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_2*k_C - D_p_x_1_by_b_1_z*t269
        - D_p_x_1_by_b_1_z*t270 - D_p_x_1_by_b_1_z*t271 - D_p_x_2_by_b_1_z*t248 - D_p_x_2_by_b_1_z*t250
        - D_p_x_2_by_b_1_z*t251 + D_p_y_1*D_p_y_2_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_2*k_C
        - D_p_y_1_by_b_1_z*t272 - D_p_y_1_by_b_1_z*t273 - D_p_y_1_by_b_1_z*t274 - D_p_y_2_by_b_1_z*t252
        - D_p_y_2_by_b_1_z*t254 - D_p_y_2_by_b_1_z*t255 + D_p_z_1*D_p_z_2_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_2*k_C - D_p_z_1_by_b_1_z*t275 - D_p_z_1_by_b_1_z*t276
        - D_p_z_1_by_b_1_z*t277 - D_p_z_2_by_b_1_z*t256 - D_p_z_2_by_b_1_z*t258 - D_p_z_2_by_b_1_z*t259
        + mu_1_by_b_1_z*t278 + mu_2_by_b_1_z*t279 + mu_3_by_b_1_z*t280,
        D_p_x_1*D_p_x_3_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_3*k_C - D_p_x_1_by_b_1_z*t281
        - D_p_x_1_by_b_1_z*t282 - D_p_x_1_by_b_1_z*t283 - D_p_x_3_by_b_1_z*t248 - D_p_x_3_by_b_1_z*t250
        - D_p_x_3_by_b_1_z*t251 + D_p_y_1*D_p_y_3_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_3*k_C
        - D_p_y_1_by_b_1_z*t284 - D_p_y_1_by_b_1_z*t285 - D_p_y_1_by_b_1_z*t286 - D_p_y_3_by_b_1_z*t252
        - D_p_y_3_by_b_1_z*t254 - D_p_y_3_by_b_1_z*t255 + D_p_z_1*D_p_z_3_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_3*k_C - D_p_z_1_by_b_1_z*t287 - D_p_z_1_by_b_1_z*t288
        - D_p_z_1_by_b_1_z*t289 - D_p_z_3_by_b_1_z*t256 - D_p_z_3_by_b_1_z*t258 - D_p_z_3_by_b_1_z*t259
        + mu_1_by_b_1_z*t290 + mu_2_by_b_1_z*t291 + mu_3_by_b_1_z*t292,
        t430, t431,
        D_delta_x_1_by_b_1_z*t310 + D_delta_y_1_by_b_1_z*t311 + D_delta_z_1_by_b_1_z*t312
        - D_p_x_1_by_b_1_z*t299 - D_p_x_1_by_b_1_z*t300 - D_p_x_1_by_b_1_z*t301 + D_p_x_1_by_b_1_z*t408
        - D_p_y_1_by_b_1_z*t302 - D_p_y_1_by_b_1_z*t303 - D_p_y_1_by_b_1_z*t304 + D_p_y_1_by_b_1_z*t409
        - D_p_z_1_by_b_1_z*t305 - D_p_z_1_by_b_1_z*t306 - D_p_z_1_by_b_1_z*t307 + D_p_z_1_by_b_1_z*t410
        + mu_1_by_b_1_z*t308 + mu_2_by_b_1_z*t309 + mu_3_by_b_1_z*t309,
        D_delta_x_2_by_b_1_z*t310 + D_delta_y_2_by_b_1_z*t311 + D_delta_z_2_by_b_1_z*t312
        - D_p_x_1_by_b_1_z*t313 - D_p_x_1_by_b_1_z*t314 - D_p_x_1_by_b_1_z*t315 + D_p_x_1_by_b_1_z*t411
        - D_p_y_1_by_b_1_z*t316 - D_p_y_1_by_b_1_z*t317 - D_p_y_1_by_b_1_z*t318 + D_p_y_1_by_b_1_z*t412
        - D_p_z_1_by_b_1_z*t319 - D_p_z_1_by_b_1_z*t320 - D_p_z_1_by_b_1_z*t321 + D_p_z_1_by_b_1_z*t413
        + mu_1_by_b_1_z*t322 + mu_2_by_b_1_z*t323 + mu_3_by_b_1_z*t323,
        D_delta_x_3_by_b_1_z*t310 + D_delta_y_3_by_b_1_z*t311 + D_delta_z_3_by_b_1_z*t312
        - D_p_x_1_by_b_1_z*t324 - D_p_x_1_by_b_1_z*t325 - D_p_x_1_by_b_1_z*t326 + D_p_x_1_by_b_1_z*t414
        - D_p_y_1_by_b_1_z*t327 - D_p_y_1_by_b_1_z*t328 - D_p_y_1_by_b_1_z*t329 + D_p_y_1_by_b_1_z*t415
        - D_p_z_1_by_b_1_z*t330 - D_p_z_1_by_b_1_z*t331 - D_p_z_1_by_b_1_z*t332 + D_p_z_1_by_b_1_z*t416
        + mu_1_by_b_1_z*t333 + mu_2_by_b_1_z*t334 + mu_3_by_b_1_z*t334,
        t432, D_p_x_1_by_b_1_z*k_C, D_p_y_1_by_b_1_z*k_C, D_p_z_1_by_b_1_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_z*k_C
        + mu_1_by_b_1_z*t339 + mu_2_by_b_1_z*t340 + mu_3_by_b_1_z*t339 - t269*t433 - t270*t433 - t271*t433
        - t272*t434 - t273*t434 - t274*t434 - t275*t435 - t276*t435 - t277*t435,
        D_p_x_2*D_p_x_3_by_b_1_z*k_C + D_p_x_2_by_b_1_z*D_p_x_3*k_C - D_p_x_2_by_b_1_z*t281
        - D_p_x_2_by_b_1_z*t282 - D_p_x_2_by_b_1_z*t283 - D_p_x_3_by_b_1_z*t269 - D_p_x_3_by_b_1_z*t270
        - D_p_x_3_by_b_1_z*t271 + D_p_y_2*D_p_y_3_by_b_1_z*k_C + D_p_y_2_by_b_1_z*D_p_y_3*k_C
        - D_p_y_2_by_b_1_z*t284 - D_p_y_2_by_b_1_z*t285 - D_p_y_2_by_b_1_z*t286 - D_p_y_3_by_b_1_z*t272
        - D_p_y_3_by_b_1_z*t273 - D_p_y_3_by_b_1_z*t274 + D_p_z_2*D_p_z_3_by_b_1_z*k_C
        + D_p_z_2_by_b_1_z*D_p_z_3*k_C - D_p_z_2_by_b_1_z*t287 - D_p_z_2_by_b_1_z*t288
        - D_p_z_2_by_b_1_z*t289 - D_p_z_3_by_b_1_z*t275 - D_p_z_3_by_b_1_z*t276 - D_p_z_3_by_b_1_z*t277
        + mu_1_by_b_1_z*t341 + mu_2_by_b_1_z*t342 + mu_3_by_b_1_z*t343,
        D_delta_x_1_by_b_1_z*t349 + D_delta_y_1_by_b_1_z*t350 + D_delta_z_1_by_b_1_z*t351
        - D_p_x_2_by_b_1_z*t299 - D_p_x_2_by_b_1_z*t300 - D_p_x_2_by_b_1_z*t301 + D_p_x_2_by_b_1_z*t408
        - D_p_y_2_by_b_1_z*t302 - D_p_y_2_by_b_1_z*t303 - D_p_y_2_by_b_1_z*t304 + D_p_y_2_by_b_1_z*t409
        - D_p_z_2_by_b_1_z*t305 - D_p_z_2_by_b_1_z*t306 - D_p_z_2_by_b_1_z*t307 + D_p_z_2_by_b_1_z*t410
        + mu_1_by_b_1_z*t347 + mu_2_by_b_1_z*t348 + mu_3_by_b_1_z*t347,
        D_delta_x_2_by_b_1_z*t349 + D_delta_y_2_by_b_1_z*t350 + D_delta_z_2_by_b_1_z*t351
        - D_p_x_2_by_b_1_z*t313 - D_p_x_2_by_b_1_z*t314 - D_p_x_2_by_b_1_z*t315 + D_p_x_2_by_b_1_z*t411
        - D_p_y_2_by_b_1_z*t316 - D_p_y_2_by_b_1_z*t317 - D_p_y_2_by_b_1_z*t318 + D_p_y_2_by_b_1_z*t412
        - D_p_z_2_by_b_1_z*t319 - D_p_z_2_by_b_1_z*t320 - D_p_z_2_by_b_1_z*t321 + D_p_z_2_by_b_1_z*t413
        + mu_1_by_b_1_z*t352 + mu_2_by_b_1_z*t353 + mu_3_by_b_1_z*t352,
        D_delta_x_3_by_b_1_z*t349 + D_delta_y_3_by_b_1_z*t350 + D_delta_z_3_by_b_1_z*t351
        - D_p_x_2_by_b_1_z*t324 - D_p_x_2_by_b_1_z*t325 - D_p_x_2_by_b_1_z*t326 + D_p_x_2_by_b_1_z*t414
        - D_p_y_2_by_b_1_z*t327 - D_p_y_2_by_b_1_z*t328 - D_p_y_2_by_b_1_z*t329 + D_p_y_2_by_b_1_z*t415
        - D_p_z_2_by_b_1_z*t330 - D_p_z_2_by_b_1_z*t331 - D_p_z_2_by_b_1_z*t332 + D_p_z_2_by_b_1_z*t416
        + mu_1_by_b_1_z*t354 + mu_2_by_b_1_z*t355 + mu_3_by_b_1_z*t354,
        D_p_x_2_by_b_1_z*k_C, D_p_y_2_by_b_1_z*k_C, D_p_z_2_by_b_1_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_z*k_C
        + mu_1_by_b_1_z*t359 + mu_2_by_b_1_z*t359 + mu_3_by_b_1_z*t360 - t281*t436 - t282*t436 - t283*t436
        - t284*t437 - t285*t437 - t286*t437 - t287*t438 - t288*t438 - t289*t438,
        D_delta_x_1_by_b_1_z*t366 + D_delta_y_1_by_b_1_z*t367 + D_delta_z_1_by_b_1_z*t368
        - D_p_x_3_by_b_1_z*t299 - D_p_x_3_by_b_1_z*t300 - D_p_x_3_by_b_1_z*t301 + D_p_x_3_by_b_1_z*t408
        - D_p_y_3_by_b_1_z*t302 - D_p_y_3_by_b_1_z*t303 - D_p_y_3_by_b_1_z*t304 + D_p_y_3_by_b_1_z*t409
        - D_p_z_3_by_b_1_z*t305 - D_p_z_3_by_b_1_z*t306 - D_p_z_3_by_b_1_z*t307 + D_p_z_3_by_b_1_z*t410
        + mu_1_by_b_1_z*t364 + mu_2_by_b_1_z*t364 + mu_3_by_b_1_z*t365,
        D_delta_x_2_by_b_1_z*t366 + D_delta_y_2_by_b_1_z*t367 + D_delta_z_2_by_b_1_z*t368
        - D_p_x_3_by_b_1_z*t313 - D_p_x_3_by_b_1_z*t314 - D_p_x_3_by_b_1_z*t315 + D_p_x_3_by_b_1_z*t411
        - D_p_y_3_by_b_1_z*t316 - D_p_y_3_by_b_1_z*t317 - D_p_y_3_by_b_1_z*t318 + D_p_y_3_by_b_1_z*t412
        - D_p_z_3_by_b_1_z*t319 - D_p_z_3_by_b_1_z*t320 - D_p_z_3_by_b_1_z*t321 + D_p_z_3_by_b_1_z*t413
        + mu_1_by_b_1_z*t369 + mu_2_by_b_1_z*t369 + mu_3_by_b_1_z*t370,
        D_delta_x_3_by_b_1_z*t366 + D_delta_y_3_by_b_1_z*t367 + D_delta_z_3_by_b_1_z*t368
        - D_p_x_3_by_b_1_z*t324 - D_p_x_3_by_b_1_z*t325 - D_p_x_3_by_b_1_z*t326 + D_p_x_3_by_b_1_z*t414
        - D_p_y_3_by_b_1_z*t327 - D_p_y_3_by_b_1_z*t328 - D_p_y_3_by_b_1_z*t329 + D_p_y_3_by_b_1_z*t415
        - D_p_z_3_by_b_1_z*t330 - D_p_z_3_by_b_1_z*t331 - D_p_z_3_by_b_1_z*t332 + D_p_z_3_by_b_1_z*t416
        + mu_1_by_b_1_z*t371 + mu_2_by_b_1_z*t371 + mu_3_by_b_1_z*t372,
        D_p_x_3_by_b_1_z*k_C, D_p_y_3_by_b_1_z*k_C, D_p_z_3_by_b_1_z*k_C, t185*t429, t430, -t185*t428, t431,
        D_delta_x_1_by_b_1_z*t374 + D_delta_y_1_by_b_1_z*t375 + D_delta_z_1_by_b_1_z*t376
        + mu_1_by_b_1_z*t377 - mu_2_by_b_1_z*t373 - mu_3_by_b_1_z*t373,
        D_delta_x_1_by_b_1_z*t379 + D_delta_x_2_by_b_1_z*t380 + D_delta_y_1_by_b_1_z*t381
        + D_delta_y_2_by_b_1_z*t382 + D_delta_z_1_by_b_1_z*t383 + D_delta_z_2_by_b_1_z*t384
        + mu_1_by_b_1_z*t378 + mu_2_by_b_1_z*t378 + mu_3_by_b_1_z*t378,
        D_delta_x_1_by_b_1_z*t386 + D_delta_x_3_by_b_1_z*t380 + D_delta_y_1_by_b_1_z*t387
        + D_delta_y_3_by_b_1_z*t382 + D_delta_z_1_by_b_1_z*t388 + D_delta_z_3_by_b_1_z*t384
        + mu_1_by_b_1_z*t385 + mu_2_by_b_1_z*t385 + mu_3_by_b_1_z*t385,
        D_delta_x_1_by_b_1_z*k_C, D_delta_y_1_by_b_1_z*k_C, D_delta_z_1_by_b_1_z*k_C,
        D_delta_x_2_by_b_1_z*t390 + D_delta_y_2_by_b_1_z*t391 + D_delta_z_2_by_b_1_z*t392
        - mu_1_by_b_1_z*t389 + mu_2_by_b_1_z*t393 - mu_3_by_b_1_z*t389,
        D_delta_x_2_by_b_1_z*t386 + D_delta_x_3_by_b_1_z*t379 + D_delta_y_2_by_b_1_z*t387
        + D_delta_y_3_by_b_1_z*t381 + D_delta_z_2_by_b_1_z*t388 + D_delta_z_3_by_b_1_z*t383
        + mu_1_by_b_1_z*t394 + mu_2_by_b_1_z*t394 + mu_3_by_b_1_z*t394,
        D_delta_x_2_by_b_1_z*k_C, D_delta_y_2_by_b_1_z*k_C, D_delta_z_2_by_b_1_z*k_C,
        D_delta_x_3_by_b_1_z*t396 + D_delta_y_3_by_b_1_z*t397 + D_delta_z_3_by_b_1_z*t398
        - mu_1_by_b_1_z*t395 - mu_2_by_b_1_z*t395 + mu_3_by_b_1_z*t399,
        D_delta_x_3_by_b_1_z*k_C, D_delta_y_3_by_b_1_z*k_C, D_delta_z_3_by_b_1_z*k_C, t432,
        2*D_p_x_1*D_p_x_1_by_b_2_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_x*k_C
        + mu_1_by_b_2_x*t266 + mu_2_by_b_2_x*t267 + mu_3_by_b_2_x*t267 - t248*t439 - t250*t439 - t251*t439
        - t252*t440 - t254*t440 - t255*t440 - t256*t441 - t258*t441 - t259*t441,
        D_p_x_1*D_p_x_2_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_2*k_C - D_p_x_1_by_b_2_x*t269
        - D_p_x_1_by_b_2_x*t270 - D_p_x_1_by_b_2_x*t271 - D_p_x_2_by_b_2_x*t248 - D_p_x_2_by_b_2_x*t250
        - D_p_x_2_by_b_2_x*t251 + D_p_y_1*D_p_y_2_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_2*k_C
        - D_p_y_1_by_b_2_x*t272 - D_p_y_1_by_b_2_x*t273 - D_p_y_1_by_b_2_x*t274 - D_p_y_2_by_b_2_x*t252
        - D_p_y_2_by_b_2_x*t254 - D_p_y_2_by_b_2_x*t255 + D_p_z_1*D_p_z_2_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_2*k_C - D_p_z_1_by_b_2_x*t275 - D_p_z_1_by_b_2_x*t276
        - D_p_z_1_by_b_2_x*t277 - D_p_z_2_by_b_2_x*t256 - D_p_z_2_by_b_2_x*t258 - D_p_z_2_by_b_2_x*t259
        + mu_1_by_b_2_x*t278 + mu_2_by_b_2_x*t279 + mu_3_by_b_2_x*t280,
        D_p_x_1*D_p_x_3_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_3*k_C - D_p_x_1_by_b_2_x*t281
        - D_p_x_1_by_b_2_x*t282 - D_p_x_1_by_b_2_x*t283 - D_p_x_3_by_b_2_x*t248 - D_p_x_3_by_b_2_x*t250
        - D_p_x_3_by_b_2_x*t251 + D_p_y_1*D_p_y_3_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_3*k_C
        - D_p_y_1_by_b_2_x*t284 - D_p_y_1_by_b_2_x*t285 - D_p_y_1_by_b_2_x*t286 - D_p_y_3_by_b_2_x*t252
        - D_p_y_3_by_b_2_x*t254 - D_p_y_3_by_b_2_x*t255 + D_p_z_1*D_p_z_3_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_3*k_C - D_p_z_1_by_b_2_x*t287 - D_p_z_1_by_b_2_x*t288
        - D_p_z_1_by_b_2_x*t289 - D_p_z_3_by_b_2_x*t256 - D_p_z_3_by_b_2_x*t258 - D_p_z_3_by_b_2_x*t259
        + mu_1_by_b_2_x*t290 + mu_2_by_b_2_x*t291 + mu_3_by_b_2_x*t292,
        D_delta_x_1_by_b_2_x*t310 + D_delta_y_1_by_b_2_x*t311 + D_delta_z_1_by_b_2_x*t312
        - D_p_x_1_by_b_2_x*t299 - D_p_x_1_by_b_2_x*t300 - D_p_x_1_by_b_2_x*t301 + D_p_x_1_by_b_2_x*t408
        - D_p_y_1_by_b_2_x*t302 - D_p_y_1_by_b_2_x*t303 - D_p_y_1_by_b_2_x*t304 + D_p_y_1_by_b_2_x*t409
        - D_p_z_1_by_b_2_x*t305 - D_p_z_1_by_b_2_x*t306 - D_p_z_1_by_b_2_x*t307 + D_p_z_1_by_b_2_x*t410
        + mu_1_by_b_2_x*t308 + mu_2_by_b_2_x*t309 + mu_3_by_b_2_x*t309,
        D_delta_x_2_by_b_2_x*t310 + D_delta_y_2_by_b_2_x*t311 + D_delta_z_2_by_b_2_x*t312
        - D_p_x_1_by_b_2_x*t313 - D_p_x_1_by_b_2_x*t314 - D_p_x_1_by_b_2_x*t315 + D_p_x_1_by_b_2_x*t411
        - D_p_y_1_by_b_2_x*t316 - D_p_y_1_by_b_2_x*t317 - D_p_y_1_by_b_2_x*t318 + D_p_y_1_by_b_2_x*t412
        - D_p_z_1_by_b_2_x*t319 - D_p_z_1_by_b_2_x*t320 - D_p_z_1_by_b_2_x*t321 + D_p_z_1_by_b_2_x*t413
        + mu_1_by_b_2_x*t322 + mu_2_by_b_2_x*t323 + mu_3_by_b_2_x*t323,
        D_delta_x_3_by_b_2_x*t310 + D_delta_y_3_by_b_2_x*t311 + D_delta_z_3_by_b_2_x*t312
        - D_p_x_1_by_b_2_x*t324 - D_p_x_1_by_b_2_x*t325 - D_p_x_1_by_b_2_x*t326 + D_p_x_1_by_b_2_x*t414
        - D_p_y_1_by_b_2_x*t327 - D_p_y_1_by_b_2_x*t328 - D_p_y_1_by_b_2_x*t329 + D_p_y_1_by_b_2_x*t415
        - D_p_z_1_by_b_2_x*t330 - D_p_z_1_by_b_2_x*t331 - D_p_z_1_by_b_2_x*t332 + D_p_z_1_by_b_2_x*t416
        + mu_1_by_b_2_x*t333 + mu_2_by_b_2_x*t334 + mu_3_by_b_2_x*t334,
        D_p_x_1_by_b_2_x*k_C, D_p_y_1_by_b_2_x*k_C, D_p_z_1_by_b_2_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_x*k_C
        + k_sp_2*t445*t451*w_b_2*x_2_by_b_2_x + mu_1_by_b_2_x*t339 + mu_2_by_b_2_x*t340
        + mu_3_by_b_2_x*t339 - t269*t442 - t270*t442 - t271*t442 - t272*t443 - t273*t443 - t274*t443
        - t275*t444 - t276*t444 - t277*t444 - t450,
        D_p_x_2*D_p_x_3_by_b_2_x*k_C + D_p_x_2_by_b_2_x*D_p_x_3*k_C - D_p_x_2_by_b_2_x*t281
        - D_p_x_2_by_b_2_x*t282 - D_p_x_2_by_b_2_x*t283 - D_p_x_3_by_b_2_x*t269 - D_p_x_3_by_b_2_x*t270
        - D_p_x_3_by_b_2_x*t271 + D_p_y_2*D_p_y_3_by_b_2_x*k_C + D_p_y_2_by_b_2_x*D_p_y_3*k_C
        - D_p_y_2_by_b_2_x*t284 - D_p_y_2_by_b_2_x*t285 - D_p_y_2_by_b_2_x*t286 - D_p_y_3_by_b_2_x*t272
        - D_p_y_3_by_b_2_x*t273 - D_p_y_3_by_b_2_x*t274 + D_p_z_2*D_p_z_3_by_b_2_x*k_C
        + D_p_z_2_by_b_2_x*D_p_z_3*k_C - D_p_z_2_by_b_2_x*t287 - D_p_z_2_by_b_2_x*t288
        - D_p_z_2_by_b_2_x*t289 - D_p_z_3_by_b_2_x*t275 - D_p_z_3_by_b_2_x*t276 - D_p_z_3_by_b_2_x*t277
        + mu_1_by_b_2_x*t341 + mu_2_by_b_2_x*t342 + mu_3_by_b_2_x*t343,
        t453, t454,
        D_delta_x_1_by_b_2_x*t349 + D_delta_y_1_by_b_2_x*t350 + D_delta_z_1_by_b_2_x*t351
        - D_p_x_2_by_b_2_x*t299 - D_p_x_2_by_b_2_x*t300 - D_p_x_2_by_b_2_x*t301 + D_p_x_2_by_b_2_x*t408
        - D_p_y_2_by_b_2_x*t302 - D_p_y_2_by_b_2_x*t303 - D_p_y_2_by_b_2_x*t304 + D_p_y_2_by_b_2_x*t409
        - D_p_z_2_by_b_2_x*t305 - D_p_z_2_by_b_2_x*t306 - D_p_z_2_by_b_2_x*t307 + D_p_z_2_by_b_2_x*t410
        + mu_1_by_b_2_x*t347 + mu_2_by_b_2_x*t348 + mu_3_by_b_2_x*t347,
        D_delta_x_2_by_b_2_x*t349 + D_delta_y_2_by_b_2_x*t350 + D_delta_z_2_by_b_2_x*t351
        - D_p_x_2_by_b_2_x*t313 - D_p_x_2_by_b_2_x*t314 - D_p_x_2_by_b_2_x*t315 + D_p_x_2_by_b_2_x*t411
        - D_p_y_2_by_b_2_x*t316 - D_p_y_2_by_b_2_x*t317 - D_p_y_2_by_b_2_x*t318 + D_p_y_2_by_b_2_x*t412
        - D_p_z_2_by_b_2_x*t319 - D_p_z_2_by_b_2_x*t320 - D_p_z_2_by_b_2_x*t321 + D_p_z_2_by_b_2_x*t413
        + mu_1_by_b_2_x*t352 + mu_2_by_b_2_x*t353 + mu_3_by_b_2_x*t352,
        D_delta_x_3_by_b_2_x*t349 + D_delta_y_3_by_b_2_x*t350 + D_delta_z_3_by_b_2_x*t351
        - D_p_x_2_by_b_2_x*t324 - D_p_x_2_by_b_2_x*t325 - D_p_x_2_by_b_2_x*t326 + D_p_x_2_by_b_2_x*t414
        - D_p_y_2_by_b_2_x*t327 - D_p_y_2_by_b_2_x*t328 - D_p_y_2_by_b_2_x*t329 + D_p_y_2_by_b_2_x*t415
        - D_p_z_2_by_b_2_x*t330 - D_p_z_2_by_b_2_x*t331 - D_p_z_2_by_b_2_x*t332 + D_p_z_2_by_b_2_x*t416
        + mu_1_by_b_2_x*t354 + mu_2_by_b_2_x*t355 + mu_3_by_b_2_x*t354,
        t455, D_p_x_2_by_b_2_x*k_C, D_p_y_2_by_b_2_x*k_C, D_p_z_2_by_b_2_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_x*k_C
        + mu_1_by_b_2_x*t359 + mu_2_by_b_2_x*t359 + mu_3_by_b_2_x*t360 - t281*t456 - t282*t456 - t283*t456
        - t284*t457 - t285*t457 - t286*t457 - t287*t458 - t288*t458 - t289*t458,
        D_delta_x_1_by_b_2_x*t366 + D_delta_y_1_by_b_2_x*t367 + D_delta_z_1_by_b_2_x*t368
        - D_p_x_3_by_b_2_x*t299 - D_p_x_3_by_b_2_x*t300 - D_p_x_3_by_b_2_x*t301 + D_p_x_3_by_b_2_x*t408
        - D_p_y_3_by_b_2_x*t302 - D_p_y_3_by_b_2_x*t303 - D_p_y_3_by_b_2_x*t304 + D_p_y_3_by_b_2_x*t409
        - D_p_z_3_by_b_2_x*t305 - D_p_z_3_by_b_2_x*t306 - D_p_z_3_by_b_2_x*t307 + D_p_z_3_by_b_2_x*t410
        + mu_1_by_b_2_x*t364 + mu_2_by_b_2_x*t364 + mu_3_by_b_2_x*t365,
        D_delta_x_2_by_b_2_x*t366 + D_delta_y_2_by_b_2_x*t367 + D_delta_z_2_by_b_2_x*t368
        - D_p_x_3_by_b_2_x*t313 - D_p_x_3_by_b_2_x*t314 - D_p_x_3_by_b_2_x*t315 + D_p_x_3_by_b_2_x*t411
        - D_p_y_3_by_b_2_x*t316 - D_p_y_3_by_b_2_x*t317 - D_p_y_3_by_b_2_x*t318 + D_p_y_3_by_b_2_x*t412
        - D_p_z_3_by_b_2_x*t319 - D_p_z_3_by_b_2_x*t320 - D_p_z_3_by_b_2_x*t321 + D_p_z_3_by_b_2_x*t413
        + mu_1_by_b_2_x*t369 + mu_2_by_b_2_x*t369 + mu_3_by_b_2_x*t370,
        D_delta_x_3_by_b_2_x*t366 + D_delta_y_3_by_b_2_x*t367 + D_delta_z_3_by_b_2_x*t368
        - D_p_x_3_by_b_2_x*t324 - D_p_x_3_by_b_2_x*t325 - D_p_x_3_by_b_2_x*t326 + D_p_x_3_by_b_2_x*t414
        - D_p_y_3_by_b_2_x*t327 - D_p_y_3_by_b_2_x*t328 - D_p_y_3_by_b_2_x*t329 + D_p_y_3_by_b_2_x*t415
        - D_p_z_3_by_b_2_x*t330 - D_p_z_3_by_b_2_x*t331 - D_p_z_3_by_b_2_x*t332 + D_p_z_3_by_b_2_x*t416
        + mu_1_by_b_2_x*t371 + mu_2_by_b_2_x*t371 + mu_3_by_b_2_x*t372,
        D_p_x_3_by_b_2_x*k_C, D_p_y_3_by_b_2_x*k_C, D_p_z_3_by_b_2_x*k_C, t218*t452, t453, -t218*t450, t454,
        D_delta_x_1_by_b_2_x*t374 + D_delta_y_1_by_b_2_x*t375 + D_delta_z_1_by_b_2_x*t376
        + mu_1_by_b_2_x*t377 - mu_2_by_b_2_x*t373 - mu_3_by_b_2_x*t373,
        D_delta_x_1_by_b_2_x*t379 + D_delta_x_2_by_b_2_x*t380 + D_delta_y_1_by_b_2_x*t381
        + D_delta_y_2_by_b_2_x*t382 + D_delta_z_1_by_b_2_x*t383 + D_delta_z_2_by_b_2_x*t384
        + mu_1_by_b_2_x*t378 + mu_2_by_b_2_x*t378 + mu_3_by_b_2_x*t378,
        D_delta_x_1_by_b_2_x*t386 + D_delta_x_3_by_b_2_x*t380 + D_delta_y_1_by_b_2_x*t387
        + D_delta_y_3_by_b_2_x*t382 + D_delta_z_1_by_b_2_x*t388 + D_delta_z_3_by_b_2_x*t384
        + mu_1_by_b_2_x*t385 + mu_2_by_b_2_x*t385 + mu_3_by_b_2_x*t385,
        D_delta_x_1_by_b_2_x*k_C, D_delta_y_1_by_b_2_x*k_C, D_delta_z_1_by_b_2_x*k_C,
        D_delta_x_2_by_b_2_x*t390 + D_delta_y_2_by_b_2_x*t391 + D_delta_z_2_by_b_2_x*t392
        - mu_1_by_b_2_x*t389 + mu_2_by_b_2_x*t393 - mu_3_by_b_2_x*t389,
        D_delta_x_2_by_b_2_x*t386 + D_delta_x_3_by_b_2_x*t379 + D_delta_y_2_by_b_2_x*t387
        + D_delta_y_3_by_b_2_x*t381 + D_delta_z_2_by_b_2_x*t388 + D_delta_z_3_by_b_2_x*t383
        + mu_1_by_b_2_x*t394 + mu_2_by_b_2_x*t394 + mu_3_by_b_2_x*t394,
        D_delta_x_2_by_b_2_x*k_C, D_delta_y_2_by_b_2_x*k_C, D_delta_z_2_by_b_2_x*k_C,
        D_delta_x_3_by_b_2_x*t396 + D_delta_y_3_by_b_2_x*t397 + D_delta_z_3_by_b_2_x*t398
        - mu_1_by_b_2_x*t395 - mu_2_by_b_2_x*t395 + mu_3_by_b_2_x*t399,
        D_delta_x_3_by_b_2_x*k_C, D_delta_y_3_by_b_2_x*k_C, D_delta_z_3_by_b_2_x*k_C, t455,
        2*D_p_x_1*D_p_x_1_by_b_2_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_y*k_C
        + mu_1_by_b_2_y*t266 + mu_2_by_b_2_y*t267 + mu_3_by_b_2_y*t267 - t248*t459 - t250*t459 - t251*t459
        - t252*t460 - t254*t460 - t255*t460 - t256*t461 - t258*t461 - t259*t461,
        D_p_x_1*D_p_x_2_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_2*k_C - D_p_x_1_by_b_2_y*t269
        - D_p_x_1_by_b_2_y*t270 - D_p_x_1_by_b_2_y*t271 - D_p_x_2_by_b_2_y*t248 - D_p_x_2_by_b_2_y*t250
        - D_p_x_2_by_b_2_y*t251 + D_p_y_1*D_p_y_2_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_2*k_C
        - D_p_y_1_by_b_2_y*t272 - D_p_y_1_by_b_2_y*t273 - D_p_y_1_by_b_2_y*t274 - D_p_y_2_by_b_2_y*t252
        - D_p_y_2_by_b_2_y*t254 - D_p_y_2_by_b_2_y*t255 + D_p_z_1*D_p_z_2_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_2*k_C - D_p_z_1_by_b_2_y*t275 - D_p_z_1_by_b_2_y*t276
        - D_p_z_1_by_b_2_y*t277 - D_p_z_2_by_b_2_y*t256 - D_p_z_2_by_b_2_y*t258 - D_p_z_2_by_b_2_y*t259
        + mu_1_by_b_2_y*t278 + mu_2_by_b_2_y*t279 + mu_3_by_b_2_y*t280,
        D_p_x_1*D_p_x_3_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_3*k_C - D_p_x_1_by_b_2_y*t281
        - D_p_x_1_by_b_2_y*t282 - D_p_x_1_by_b_2_y*t283 - D_p_x_3_by_b_2_y*t248 - D_p_x_3_by_b_2_y*t250
        - D_p_x_3_by_b_2_y*t251 + D_p_y_1*D_p_y_3_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_3*k_C
        - D_p_y_1_by_b_2_y*t284 - D_p_y_1_by_b_2_y*t285 - D_p_y_1_by_b_2_y*t286 - D_p_y_3_by_b_2_y*t252
        - D_p_y_3_by_b_2_y*t254 - D_p_y_3_by_b_2_y*t255 + D_p_z_1*D_p_z_3_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_3*k_C - D_p_z_1_by_b_2_y*t287 - D_p_z_1_by_b_2_y*t288
        - D_p_z_1_by_b_2_y*t289 - D_p_z_3_by_b_2_y*t256 - D_p_z_3_by_b_2_y*t258 - D_p_z_3_by_b_2_y*t259
        + mu_1_by_b_2_y*t290 + mu_2_by_b_2_y*t291 + mu_3_by_b_2_y*t292,
        D_delta_x_1_by_b_2_y*t310 + D_delta_y_1_by_b_2_y*t311 + D_delta_z_1_by_b_2_y*t312
        - D_p_x_1_by_b_2_y*t299 - D_p_x_1_by_b_2_y*t300 - D_p_x_1_by_b_2_y*t301 + D_p_x_1_by_b_2_y*t408
        - D_p_y_1_by_b_2_y*t302 - D_p_y_1_by_b_2_y*t303 - D_p_y_1_by_b_2_y*t304 + D_p_y_1_by_b_2_y*t409
        - D_p_z_1_by_b_2_y*t305 - D_p_z_1_by_b_2_y*t306 - D_p_z_1_by_b_2_y*t307 + D_p_z_1_by_b_2_y*t410
        + mu_1_by_b_2_y*t308 + mu_2_by_b_2_y*t309 + mu_3_by_b_2_y*t309,
        D_delta_x_2_by_b_2_y*t310 + D_delta_y_2_by_b_2_y*t311 + D_delta_z_2_by_b_2_y*t312
        - D_p_x_1_by_b_2_y*t313 - D_p_x_1_by_b_2_y*t314 - D_p_x_1_by_b_2_y*t315 + D_p_x_1_by_b_2_y*t411
        - D_p_y_1_by_b_2_y*t316 - D_p_y_1_by_b_2_y*t317 - D_p_y_1_by_b_2_y*t318 + D_p_y_1_by_b_2_y*t412
        - D_p_z_1_by_b_2_y*t319 - D_p_z_1_by_b_2_y*t320 - D_p_z_1_by_b_2_y*t321 + D_p_z_1_by_b_2_y*t413
        + mu_1_by_b_2_y*t322 + mu_2_by_b_2_y*t323 + mu_3_by_b_2_y*t323,
        D_delta_x_3_by_b_2_y*t310 + D_delta_y_3_by_b_2_y*t311 + D_delta_z_3_by_b_2_y*t312
        - D_p_x_1_by_b_2_y*t324 - D_p_x_1_by_b_2_y*t325 - D_p_x_1_by_b_2_y*t326 + D_p_x_1_by_b_2_y*t414
        - D_p_y_1_by_b_2_y*t327 - D_p_y_1_by_b_2_y*t328 - D_p_y_1_by_b_2_y*t329 + D_p_y_1_by_b_2_y*t415
        - D_p_z_1_by_b_2_y*t330 - D_p_z_1_by_b_2_y*t331 - D_p_z_1_by_b_2_y*t332 + D_p_z_1_by_b_2_y*t416
        + mu_1_by_b_2_y*t333 + mu_2_by_b_2_y*t334 + mu_3_by_b_2_y*t334,
        D_p_x_1_by_b_2_y*k_C, D_p_y_1_by_b_2_y*k_C, D_p_z_1_by_b_2_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_y*k_C
        + k_sp_2*t445*t451*w_b_2*x_2_by_b_2_y + mu_1_by_b_2_y*t339 + mu_2_by_b_2_y*t340
        + mu_3_by_b_2_y*t339 - t269*t462 - t270*t462 - t271*t462 - t272*t463 - t273*t463 - t274*t463
        - t275*t464 - t276*t464 - t277*t464 - t466,
        D_p_x_2*D_p_x_3_by_b_2_y*k_C + D_p_x_2_by_b_2_y*D_p_x_3*k_C - D_p_x_2_by_b_2_y*t281
        - D_p_x_2_by_b_2_y*t282 - D_p_x_2_by_b_2_y*t283 - D_p_x_3_by_b_2_y*t269 - D_p_x_3_by_b_2_y*t270
        - D_p_x_3_by_b_2_y*t271 + D_p_y_2*D_p_y_3_by_b_2_y*k_C + D_p_y_2_by_b_2_y*D_p_y_3*k_C
        - D_p_y_2_by_b_2_y*t284 - D_p_y_2_by_b_2_y*t285 - D_p_y_2_by_b_2_y*t286 - D_p_y_3_by_b_2_y*t272
        - D_p_y_3_by_b_2_y*t273 - D_p_y_3_by_b_2_y*t274 + D_p_z_2*D_p_z_3_by_b_2_y*k_C
        + D_p_z_2_by_b_2_y*D_p_z_3*k_C - D_p_z_2_by_b_2_y*t287 - D_p_z_2_by_b_2_y*t288
        - D_p_z_2_by_b_2_y*t289 - D_p_z_3_by_b_2_y*t275 - D_p_z_3_by_b_2_y*t276 - D_p_z_3_by_b_2_y*t277
        + mu_1_by_b_2_y*t341 + mu_2_by_b_2_y*t342 + mu_3_by_b_2_y*t343,
        t468, t469,
        D_delta_x_1_by_b_2_y*t349 + D_delta_y_1_by_b_2_y*t350 + D_delta_z_1_by_b_2_y*t351
        - D_p_x_2_by_b_2_y*t299 - D_p_x_2_by_b_2_y*t300 - D_p_x_2_by_b_2_y*t301 + D_p_x_2_by_b_2_y*t408
        - D_p_y_2_by_b_2_y*t302 - D_p_y_2_by_b_2_y*t303 - D_p_y_2_by_b_2_y*t304 + D_p_y_2_by_b_2_y*t409
        - D_p_z_2_by_b_2_y*t305 - D_p_z_2_by_b_2_y*t306 - D_p_z_2_by_b_2_y*t307 + D_p_z_2_by_b_2_y*t410
        + mu_1_by_b_2_y*t347 + mu_2_by_b_2_y*t348 + mu_3_by_b_2_y*t347,
        D_delta_x_2_by_b_2_y*t349 + D_delta_y_2_by_b_2_y*t350 + D_delta_z_2_by_b_2_y*t351
        - D_p_x_2_by_b_2_y*t313 - D_p_x_2_by_b_2_y*t314 - D_p_x_2_by_b_2_y*t315 + D_p_x_2_by_b_2_y*t411
        - D_p_y_2_by_b_2_y*t316 - D_p_y_2_by_b_2_y*t317 - D_p_y_2_by_b_2_y*t318 + D_p_y_2_by_b_2_y*t412
        - D_p_z_2_by_b_2_y*t319 - D_p_z_2_by_b_2_y*t320 - D_p_z_2_by_b_2_y*t321 + D_p_z_2_by_b_2_y*t413
        + mu_1_by_b_2_y*t352 + mu_2_by_b_2_y*t353 + mu_3_by_b_2_y*t352,
        D_delta_x_3_by_b_2_y*t349 + D_delta_y_3_by_b_2_y*t350 + D_delta_z_3_by_b_2_y*t351
        - D_p_x_2_by_b_2_y*t324 - D_p_x_2_by_b_2_y*t325 - D_p_x_2_by_b_2_y*t326 + D_p_x_2_by_b_2_y*t414
        - D_p_y_2_by_b_2_y*t327 - D_p_y_2_by_b_2_y*t328 - D_p_y_2_by_b_2_y*t329 + D_p_y_2_by_b_2_y*t415
        - D_p_z_2_by_b_2_y*t330 - D_p_z_2_by_b_2_y*t331 - D_p_z_2_by_b_2_y*t332 + D_p_z_2_by_b_2_y*t416
        + mu_1_by_b_2_y*t354 + mu_2_by_b_2_y*t355 + mu_3_by_b_2_y*t354,
        t470, D_p_x_2_by_b_2_y*k_C, D_p_y_2_by_b_2_y*k_C, D_p_z_2_by_b_2_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_y*k_C
        + mu_1_by_b_2_y*t359 + mu_2_by_b_2_y*t359 + mu_3_by_b_2_y*t360 - t281*t471 - t282*t471 - t283*t471
        - t284*t472 - t285*t472 - t286*t472 - t287*t473 - t288*t473 - t289*t473,
        D_delta_x_1_by_b_2_y*t366 + D_delta_y_1_by_b_2_y*t367 + D_delta_z_1_by_b_2_y*t368
        - D_p_x_3_by_b_2_y*t299 - D_p_x_3_by_b_2_y*t300 - D_p_x_3_by_b_2_y*t301 + D_p_x_3_by_b_2_y*t408
        - D_p_y_3_by_b_2_y*t302 - D_p_y_3_by_b_2_y*t303 - D_p_y_3_by_b_2_y*t304 + D_p_y_3_by_b_2_y*t409
        - D_p_z_3_by_b_2_y*t305 - D_p_z_3_by_b_2_y*t306 - D_p_z_3_by_b_2_y*t307 + D_p_z_3_by_b_2_y*t410
        + mu_1_by_b_2_y*t364 + mu_2_by_b_2_y*t364 + mu_3_by_b_2_y*t365,
        D_delta_x_2_by_b_2_y*t366 + D_delta_y_2_by_b_2_y*t367 + D_delta_z_2_by_b_2_y*t368
        - D_p_x_3_by_b_2_y*t313 - D_p_x_3_by_b_2_y*t314 - D_p_x_3_by_b_2_y*t315 + D_p_x_3_by_b_2_y*t411
        - D_p_y_3_by_b_2_y*t316 - D_p_y_3_by_b_2_y*t317 - D_p_y_3_by_b_2_y*t318 + D_p_y_3_by_b_2_y*t412
        - D_p_z_3_by_b_2_y*t319 - D_p_z_3_by_b_2_y*t320 - D_p_z_3_by_b_2_y*t321 + D_p_z_3_by_b_2_y*t413
        + mu_1_by_b_2_y*t369 + mu_2_by_b_2_y*t369 + mu_3_by_b_2_y*t370,
        D_delta_x_3_by_b_2_y*t366 + D_delta_y_3_by_b_2_y*t367 + D_delta_z_3_by_b_2_y*t368
        - D_p_x_3_by_b_2_y*t324 - D_p_x_3_by_b_2_y*t325 - D_p_x_3_by_b_2_y*t326 + D_p_x_3_by_b_2_y*t414
        - D_p_y_3_by_b_2_y*t327 - D_p_y_3_by_b_2_y*t328 - D_p_y_3_by_b_2_y*t329 + D_p_y_3_by_b_2_y*t415
        - D_p_z_3_by_b_2_y*t330 - D_p_z_3_by_b_2_y*t331 - D_p_z_3_by_b_2_y*t332 + D_p_z_3_by_b_2_y*t416
        + mu_1_by_b_2_y*t371 + mu_2_by_b_2_y*t371 + mu_3_by_b_2_y*t372,
        D_p_x_3_by_b_2_y*k_C, D_p_y_3_by_b_2_y*k_C, D_p_z_3_by_b_2_y*k_C, t218*t467, t468, -t218*t466, t469,
        D_delta_x_1_by_b_2_y*t374 + D_delta_y_1_by_b_2_y*t375 + D_delta_z_1_by_b_2_y*t376
        + mu_1_by_b_2_y*t377 - mu_2_by_b_2_y*t373 - mu_3_by_b_2_y*t373,
        D_delta_x_1_by_b_2_y*t379 + D_delta_x_2_by_b_2_y*t380 + D_delta_y_1_by_b_2_y*t381
        + D_delta_y_2_by_b_2_y*t382 + D_delta_z_1_by_b_2_y*t383 + D_delta_z_2_by_b_2_y*t384
        + mu_1_by_b_2_y*t378 + mu_2_by_b_2_y*t378 + mu_3_by_b_2_y*t378,
        D_delta_x_1_by_b_2_y*t386 + D_delta_x_3_by_b_2_y*t380 + D_delta_y_1_by_b_2_y*t387
        + D_delta_y_3_by_b_2_y*t382 + D_delta_z_1_by_b_2_y*t388 + D_delta_z_3_by_b_2_y*t384
        + mu_1_by_b_2_y*t385 + mu_2_by_b_2_y*t385 + mu_3_by_b_2_y*t385,
        D_delta_x_1_by_b_2_y*k_C, D_delta_y_1_by_b_2_y*k_C, D_delta_z_1_by_b_2_y*k_C,
        D_delta_x_2_by_b_2_y*t390 + D_delta_y_2_by_b_2_y*t391 + D_delta_z_2_by_b_2_y*t392
        - mu_1_by_b_2_y*t389 + mu_2_by_b_2_y*t393 - mu_3_by_b_2_y*t389,
        D_delta_x_2_by_b_2_y*t386 + D_delta_x_3_by_b_2_y*t379 + D_delta_y_2_by_b_2_y*t387
        + D_delta_y_3_by_b_2_y*t381 + D_delta_z_2_by_b_2_y*t388 + D_delta_z_3_by_b_2_y*t383
        + mu_1_by_b_2_y*t394 + mu_2_by_b_2_y*t394 + mu_3_by_b_2_y*t394,
        D_delta_x_2_by_b_2_y*k_C, D_delta_y_2_by_b_2_y*k_C, D_delta_z_2_by_b_2_y*k_C,
        D_delta_x_3_by_b_2_y*t396 + D_delta_y_3_by_b_2_y*t397 + D_delta_z_3_by_b_2_y*t398
        - mu_1_by_b_2_y*t395 - mu_2_by_b_2_y*t395 + mu_3_by_b_2_y*t399,
        D_delta_x_3_by_b_2_y*k_C, D_delta_y_3_by_b_2_y*k_C, D_delta_z_3_by_b_2_y*k_C, t470,
        2*D_p_x_1*D_p_x_1_by_b_2_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_z*k_C
        + mu_1_by_b_2_z*t266 + mu_2_by_b_2_z*t267 + mu_3_by_b_2_z*t267 - t248*t474 - t250*t474 - t251*t474
        - t252*t475 - t254*t475 - t255*t475 - t256*t476 - t258*t476 - t259*t476,
        D_p_x_1*D_p_x_2_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_2*k_C - D_p_x_1_by_b_2_z*t269
        - D_p_x_1_by_b_2_z*t270 - D_p_x_1_by_b_2_z*t271 - D_p_x_2_by_b_2_z*t248 - D_p_x_2_by_b_2_z*t250
        - D_p_x_2_by_b_2_z*t251 + D_p_y_1*D_p_y_2_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_2*k_C
        - D_p_y_1_by_b_2_z*t272 - D_p_y_1_by_b_2_z*t273 - D_p_y_1_by_b_2_z*t274 - D_p_y_2_by_b_2_z*t252
        - D_p_y_2_by_b_2_z*t254 - D_p_y_2_by_b_2_z*t255 + D_p_z_1*D_p_z_2_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_2*k_C - D_p_z_1_by_b_2_z*t275 - D_p_z_1_by_b_2_z*t276
        - D_p_z_1_by_b_2_z*t277 - D_p_z_2_by_b_2_z*t256 - D_p_z_2_by_b_2_z*t258 - D_p_z_2_by_b_2_z*t259
        + mu_1_by_b_2_z*t278 + mu_2_by_b_2_z*t279 + mu_3_by_b_2_z*t280,
        D_p_x_1*D_p_x_3_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_3*k_C - D_p_x_1_by_b_2_z*t281
        - D_p_x_1_by_b_2_z*t282 - D_p_x_1_by_b_2_z*t283 - D_p_x_3_by_b_2_z*t248 - D_p_x_3_by_b_2_z*t250
        - D_p_x_3_by_b_2_z*t251 + D_p_y_1*D_p_y_3_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_3*k_C
        - D_p_y_1_by_b_2_z*t284 - D_p_y_1_by_b_2_z*t285 - D_p_y_1_by_b_2_z*t286 - D_p_y_3_by_b_2_z*t252
        - D_p_y_3_by_b_2_z*t254 - D_p_y_3_by_b_2_z*t255 + D_p_z_1*D_p_z_3_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_3*k_C - D_p_z_1_by_b_2_z*t287 - D_p_z_1_by_b_2_z*t288
        - D_p_z_1_by_b_2_z*t289 - D_p_z_3_by_b_2_z*t256 - D_p_z_3_by_b_2_z*t258 - D_p_z_3_by_b_2_z*t259
        + mu_1_by_b_2_z*t290 + mu_2_by_b_2_z*t291 + mu_3_by_b_2_z*t292,
        D_delta_x_1_by_b_2_z*t310 + D_delta_y_1_by_b_2_z*t311 + D_delta_z_1_by_b_2_z*t312
        - D_p_x_1_by_b_2_z*t299 - D_p_x_1_by_b_2_z*t300 - D_p_x_1_by_b_2_z*t301 + D_p_x_1_by_b_2_z*t408
        - D_p_y_1_by_b_2_z*t302 - D_p_y_1_by_b_2_z*t303 - D_p_y_1_by_b_2_z*t304 + D_p_y_1_by_b_2_z*t409
        - D_p_z_1_by_b_2_z*t305 - D_p_z_1_by_b_2_z*t306 - D_p_z_1_by_b_2_z*t307 + D_p_z_1_by_b_2_z*t410
        + mu_1_by_b_2_z*t308 + mu_2_by_b_2_z*t309 + mu_3_by_b_2_z*t309,
        D_delta_x_2_by_b_2_z*t310 + D_delta_y_2_by_b_2_z*t311 + D_delta_z_2_by_b_2_z*t312
        - D_p_x_1_by_b_2_z*t313 - D_p_x_1_by_b_2_z*t314 - D_p_x_1_by_b_2_z*t315 + D_p_x_1_by_b_2_z*t411
        - D_p_y_1_by_b_2_z*t316 - D_p_y_1_by_b_2_z*t317 - D_p_y_1_by_b_2_z*t318 + D_p_y_1_by_b_2_z*t412
        - D_p_z_1_by_b_2_z*t319 - D_p_z_1_by_b_2_z*t320 - D_p_z_1_by_b_2_z*t321 + D_p_z_1_by_b_2_z*t413
        + mu_1_by_b_2_z*t322 + mu_2_by_b_2_z*t323 + mu_3_by_b_2_z*t323,
        D_delta_x_3_by_b_2_z*t310 + D_delta_y_3_by_b_2_z*t311 + D_delta_z_3_by_b_2_z*t312
        - D_p_x_1_by_b_2_z*t324 - D_p_x_1_by_b_2_z*t325 - D_p_x_1_by_b_2_z*t326 + D_p_x_1_by_b_2_z*t414
        - D_p_y_1_by_b_2_z*t327 - D_p_y_1_by_b_2_z*t328 - D_p_y_1_by_b_2_z*t329 + D_p_y_1_by_b_2_z*t415
        - D_p_z_1_by_b_2_z*t330 - D_p_z_1_by_b_2_z*t331 - D_p_z_1_by_b_2_z*t332 + D_p_z_1_by_b_2_z*t416
        + mu_1_by_b_2_z*t333 + mu_2_by_b_2_z*t334 + mu_3_by_b_2_z*t334,
        D_p_x_1_by_b_2_z*k_C, D_p_y_1_by_b_2_z*k_C, D_p_z_1_by_b_2_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_z*k_C
        + k_sp_2*t445*t451*w_b_2*x_2_by_b_2_z + mu_1_by_b_2_z*t339 + mu_2_by_b_2_z*t340
        + mu_3_by_b_2_z*t339 - t269*t477 - t270*t477 - t271*t477 - t272*t478 - t273*t478 - t274*t478
        - t275*t479 - t276*t479 - t277*t479 - t481,
        D_p_x_2*D_p_x_3_by_b_2_z*k_C + D_p_x_2_by_b_2_z*D_p_x_3*k_C - D_p_x_2_by_b_2_z*t281
        - D_p_x_2_by_b_2_z*t282 - D_p_x_2_by_b_2_z*t283 - D_p_x_3_by_b_2_z*t269 - D_p_x_3_by_b_2_z*t270
        - D_p_x_3_by_b_2_z*t271 + D_p_y_2*D_p_y_3_by_b_2_z*k_C + D_p_y_2_by_b_2_z*D_p_y_3*k_C
        - D_p_y_2_by_b_2_z*t284 - D_p_y_2_by_b_2_z*t285 - D_p_y_2_by_b_2_z*t286 - D_p_y_3_by_b_2_z*t272
        - D_p_y_3_by_b_2_z*t273 - D_p_y_3_by_b_2_z*t274 + D_p_z_2*D_p_z_3_by_b_2_z*k_C
        + D_p_z_2_by_b_2_z*D_p_z_3*k_C - D_p_z_2_by_b_2_z*t287 - D_p_z_2_by_b_2_z*t288
        - D_p_z_2_by_b_2_z*t289 - D_p_z_3_by_b_2_z*t275 - D_p_z_3_by_b_2_z*t276 - D_p_z_3_by_b_2_z*t277
        + mu_1_by_b_2_z*t341 + mu_2_by_b_2_z*t342 + mu_3_by_b_2_z*t343,
        t483, t484,
        D_delta_x_1_by_b_2_z*t349 + D_delta_y_1_by_b_2_z*t350 + D_delta_z_1_by_b_2_z*t351
        - D_p_x_2_by_b_2_z*t299 - D_p_x_2_by_b_2_z*t300 - D_p_x_2_by_b_2_z*t301 + D_p_x_2_by_b_2_z*t408
        - D_p_y_2_by_b_2_z*t302 - D_p_y_2_by_b_2_z*t303 - D_p_y_2_by_b_2_z*t304 + D_p_y_2_by_b_2_z*t409
        - D_p_z_2_by_b_2_z*t305 - D_p_z_2_by_b_2_z*t306 - D_p_z_2_by_b_2_z*t307 + D_p_z_2_by_b_2_z*t410
        + mu_1_by_b_2_z*t347 + mu_2_by_b_2_z*t348 + mu_3_by_b_2_z*t347,
        D_delta_x_2_by_b_2_z*t349 + D_delta_y_2_by_b_2_z*t350 + D_delta_z_2_by_b_2_z*t351
        - D_p_x_2_by_b_2_z*t313 - D_p_x_2_by_b_2_z*t314 - D_p_x_2_by_b_2_z*t315 + D_p_x_2_by_b_2_z*t411
        - D_p_y_2_by_b_2_z*t316 - D_p_y_2_by_b_2_z*t317 - D_p_y_2_by_b_2_z*t318 + D_p_y_2_by_b_2_z*t412
        - D_p_z_2_by_b_2_z*t319 - D_p_z_2_by_b_2_z*t320 - D_p_z_2_by_b_2_z*t321 + D_p_z_2_by_b_2_z*t413
        + mu_1_by_b_2_z*t352 + mu_2_by_b_2_z*t353 + mu_3_by_b_2_z*t352,
        D_delta_x_3_by_b_2_z*t349 + D_delta_y_3_by_b_2_z*t350 + D_delta_z_3_by_b_2_z*t351
        - D_p_x_2_by_b_2_z*t324 - D_p_x_2_by_b_2_z*t325 - D_p_x_2_by_b_2_z*t326 + D_p_x_2_by_b_2_z*t414
        - D_p_y_2_by_b_2_z*t327 - D_p_y_2_by_b_2_z*t328 - D_p_y_2_by_b_2_z*t329 + D_p_y_2_by_b_2_z*t415
        - D_p_z_2_by_b_2_z*t330 - D_p_z_2_by_b_2_z*t331 - D_p_z_2_by_b_2_z*t332 + D_p_z_2_by_b_2_z*t416
        + mu_1_by_b_2_z*t354 + mu_2_by_b_2_z*t355 + mu_3_by_b_2_z*t354,
        t485, D_p_x_2_by_b_2_z*k_C, D_p_y_2_by_b_2_z*k_C, D_p_z_2_by_b_2_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_z*k_C
        + mu_1_by_b_2_z*t359 + mu_2_by_b_2_z*t359 + mu_3_by_b_2_z*t360 - t281*t486 - t282*t486 - t283*t486
        - t284*t487 - t285*t487 - t286*t487 - t287*t488 - t288*t488 - t289*t488,
        D_delta_x_1_by_b_2_z*t366 + D_delta_y_1_by_b_2_z*t367 + D_delta_z_1_by_b_2_z*t368
        - D_p_x_3_by_b_2_z*t299 - D_p_x_3_by_b_2_z*t300 - D_p_x_3_by_b_2_z*t301 + D_p_x_3_by_b_2_z*t408
        - D_p_y_3_by_b_2_z*t302 - D_p_y_3_by_b_2_z*t303 - D_p_y_3_by_b_2_z*t304 + D_p_y_3_by_b_2_z*t409
        - D_p_z_3_by_b_2_z*t305 - D_p_z_3_by_b_2_z*t306 - D_p_z_3_by_b_2_z*t307 + D_p_z_3_by_b_2_z*t410
        + mu_1_by_b_2_z*t364 + mu_2_by_b_2_z*t364 + mu_3_by_b_2_z*t365,
        D_delta_x_2_by_b_2_z*t366 + D_delta_y_2_by_b_2_z*t367 + D_delta_z_2_by_b_2_z*t368
        - D_p_x_3_by_b_2_z*t313 - D_p_x_3_by_b_2_z*t314 - D_p_x_3_by_b_2_z*t315 + D_p_x_3_by_b_2_z*t411
        - D_p_y_3_by_b_2_z*t316 - D_p_y_3_by_b_2_z*t317 - D_p_y_3_by_b_2_z*t318 + D_p_y_3_by_b_2_z*t412
        - D_p_z_3_by_b_2_z*t319 - D_p_z_3_by_b_2_z*t320 - D_p_z_3_by_b_2_z*t321 + D_p_z_3_by_b_2_z*t413
        + mu_1_by_b_2_z*t369 + mu_2_by_b_2_z*t369 + mu_3_by_b_2_z*t370,
        D_delta_x_3_by_b_2_z*t366 + D_delta_y_3_by_b_2_z*t367 + D_delta_z_3_by_b_2_z*t368
        - D_p_x_3_by_b_2_z*t324 - D_p_x_3_by_b_2_z*t325 - D_p_x_3_by_b_2_z*t326 + D_p_x_3_by_b_2_z*t414
        - D_p_y_3_by_b_2_z*t327 - D_p_y_3_by_b_2_z*t328 - D_p_y_3_by_b_2_z*t329 + D_p_y_3_by_b_2_z*t415
        - D_p_z_3_by_b_2_z*t330 - D_p_z_3_by_b_2_z*t331 - D_p_z_3_by_b_2_z*t332 + D_p_z_3_by_b_2_z*t416
        + mu_1_by_b_2_z*t371 + mu_2_by_b_2_z*t371 + mu_3_by_b_2_z*t372,
        D_p_x_3_by_b_2_z*k_C, D_p_y_3_by_b_2_z*k_C, D_p_z_3_by_b_2_z*k_C, t218*t482, t483, -t218*t481, t484,
        D_delta_x_1_by_b_2_z*t374 + D_delta_y_1_by_b_2_z*t375 + D_delta_z_1_by_b_2_z*t376
        + mu_1_by_b_2_z*t377 - mu_2_by_b_2_z*t373 - mu_3_by_b_2_z*t373,
        D_delta_x_1_by_b_2_z*t379 + D_delta_x_2_by_b_2_z*t380 + D_delta_y_1_by_b_2_z*t381
        + D_delta_y_2_by_b_2_z*t382 + D_delta_z_1_by_b_2_z*t383 + D_delta_z_2_by_b_2_z*t384
        + mu_1_by_b_2_z*t378 + mu_2_by_b_2_z*t378 + mu_3_by_b_2_z*t378,
        D_delta_x_1_by_b_2_z*t386 + D_delta_x_3_by_b_2_z*t380 + D_delta_y_1_by_b_2_z*t387
        + D_delta_y_3_by_b_2_z*t382 + D_delta_z_1_by_b_2_z*t388 + D_delta_z_3_by_b_2_z*t384
        + mu_1_by_b_2_z*t385 + mu_2_by_b_2_z*t385 + mu_3_by_b_2_z*t385,
        D_delta_x_1_by_b_2_z*k_C, D_delta_y_1_by_b_2_z*k_C, D_delta_z_1_by_b_2_z*k_C,
        D_delta_x_2_by_b_2_z*t390 + D_delta_y_2_by_b_2_z*t391 + D_delta_z_2_by_b_2_z*t392
        - mu_1_by_b_2_z*t389 + mu_2_by_b_2_z*t393 - mu_3_by_b_2_z*t389,
        D_delta_x_2_by_b_2_z*t386 + D_delta_x_3_by_b_2_z*t379 + D_delta_y_2_by_b_2_z*t387
        + D_delta_y_3_by_b_2_z*t381 + D_delta_z_2_by_b_2_z*t388 + D_delta_z_3_by_b_2_z*t383
        + mu_1_by_b_2_z*t394 + mu_2_by_b_2_z*t394 + mu_3_by_b_2_z*t394,
        D_delta_x_2_by_b_2_z*k_C, D_delta_y_2_by_b_2_z*k_C, D_delta_z_2_by_b_2_z*k_C,
        D_delta_x_3_by_b_2_z*t396 + D_delta_y_3_by_b_2_z*t397 + D_delta_z_3_by_b_2_z*t398
        - mu_1_by_b_2_z*t395 - mu_2_by_b_2_z*t395 + mu_3_by_b_2_z*t399,
        D_delta_x_3_by_b_2_z*k_C, D_delta_y_3_by_b_2_z*k_C, D_delta_z_3_by_b_2_z*k_C, t485,
        2*D_p_x_1*D_p_x_1_by_b_3_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_x*k_C
        + mu_1_by_b_3_x*t266 + mu_2_by_b_3_x*t267 + mu_3_by_b_3_x*t267 - t248*t489 - t250*t489 - t251*t489
        - t252*t490 - t254*t490 - t255*t490 - t256*t491 - t258*t491 - t259*t491,
        D_p_x_1*D_p_x_2_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_2*k_C - D_p_x_1_by_b_3_x*t269
        - D_p_x_1_by_b_3_x*t270 - D_p_x_1_by_b_3_x*t271 - D_p_x_2_by_b_3_x*t248 - D_p_x_2_by_b_3_x*t250
        - D_p_x_2_by_b_3_x*t251 + D_p_y_1*D_p_y_2_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_2*k_C
        - D_p_y_1_by_b_3_x*t272 - D_p_y_1_by_b_3_x*t273 - D_p_y_1_by_b_3_x*t274 - D_p_y_2_by_b_3_x*t252
        - D_p_y_2_by_b_3_x*t254 - D_p_y_2_by_b_3_x*t255 + D_p_z_1*D_p_z_2_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_2*k_C - D_p_z_1_by_b_3_x*t275 - D_p_z_1_by_b_3_x*t276
        - D_p_z_1_by_b_3_x*t277 - D_p_z_2_by_b_3_x*t256 - D_p_z_2_by_b_3_x*t258 - D_p_z_2_by_b_3_x*t259
        + mu_1_by_b_3_x*t278 + mu_2_by_b_3_x*t279 + mu_3_by_b_3_x*t280,
        D_p_x_1*D_p_x_3_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_3*k_C - D_p_x_1_by_b_3_x*t281
        - D_p_x_1_by_b_3_x*t282 - D_p_x_1_by_b_3_x*t283 - D_p_x_3_by_b_3_x*t248 - D_p_x_3_by_b_3_x*t250
        - D_p_x_3_by_b_3_x*t251 + D_p_y_1*D_p_y_3_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_3*k_C
        - D_p_y_1_by_b_3_x*t284 - D_p_y_1_by_b_3_x*t285 - D_p_y_1_by_b_3_x*t286 - D_p_y_3_by_b_3_x*t252
        - D_p_y_3_by_b_3_x*t254 - D_p_y_3_by_b_3_x*t255 + D_p_z_1*D_p_z_3_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_3*k_C - D_p_z_1_by_b_3_x*t287 - D_p_z_1_by_b_3_x*t288
        - D_p_z_1_by_b_3_x*t289 - D_p_z_3_by_b_3_x*t256 - D_p_z_3_by_b_3_x*t258 - D_p_z_3_by_b_3_x*t259
        + mu_1_by_b_3_x*t290 + mu_2_by_b_3_x*t291 + mu_3_by_b_3_x*t292,
        D_delta_x_1_by_b_3_x*t310 + D_delta_y_1_by_b_3_x*t311 + D_delta_z_1_by_b_3_x*t312
        - D_p_x_1_by_b_3_x*t299 - D_p_x_1_by_b_3_x*t300 - D_p_x_1_by_b_3_x*t301 + D_p_x_1_by_b_3_x*t408
        - D_p_y_1_by_b_3_x*t302 - D_p_y_1_by_b_3_x*t303 - D_p_y_1_by_b_3_x*t304 + D_p_y_1_by_b_3_x*t409
        - D_p_z_1_by_b_3_x*t305 - D_p_z_1_by_b_3_x*t306 - D_p_z_1_by_b_3_x*t307 + D_p_z_1_by_b_3_x*t410
        + mu_1_by_b_3_x*t308 + mu_2_by_b_3_x*t309 + mu_3_by_b_3_x*t309,
        D_delta_x_2_by_b_3_x*t310 + D_delta_y_2_by_b_3_x*t311 + D_delta_z_2_by_b_3_x*t312
        - D_p_x_1_by_b_3_x*t313 - D_p_x_1_by_b_3_x*t314 - D_p_x_1_by_b_3_x*t315 + D_p_x_1_by_b_3_x*t411
        - D_p_y_1_by_b_3_x*t316 - D_p_y_1_by_b_3_x*t317 - D_p_y_1_by_b_3_x*t318 + D_p_y_1_by_b_3_x*t412
        - D_p_z_1_by_b_3_x*t319 - D_p_z_1_by_b_3_x*t320 - D_p_z_1_by_b_3_x*t321 + D_p_z_1_by_b_3_x*t413
        + mu_1_by_b_3_x*t322 + mu_2_by_b_3_x*t323 + mu_3_by_b_3_x*t323,
        D_delta_x_3_by_b_3_x*t310 + D_delta_y_3_by_b_3_x*t311 + D_delta_z_3_by_b_3_x*t312
        - D_p_x_1_by_b_3_x*t324 - D_p_x_1_by_b_3_x*t325 - D_p_x_1_by_b_3_x*t326 + D_p_x_1_by_b_3_x*t414
        - D_p_y_1_by_b_3_x*t327 - D_p_y_1_by_b_3_x*t328 - D_p_y_1_by_b_3_x*t329 + D_p_y_1_by_b_3_x*t415
        - D_p_z_1_by_b_3_x*t330 - D_p_z_1_by_b_3_x*t331 - D_p_z_1_by_b_3_x*t332 + D_p_z_1_by_b_3_x*t416
        + mu_1_by_b_3_x*t333 + mu_2_by_b_3_x*t334 + mu_3_by_b_3_x*t334,
        D_p_x_1_by_b_3_x*k_C, D_p_y_1_by_b_3_x*k_C, D_p_z_1_by_b_3_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_x*k_C
        + mu_1_by_b_3_x*t339 + mu_2_by_b_3_x*t340 + mu_3_by_b_3_x*t339 - t269*t492 - t270*t492 - t271*t492
        - t272*t493 - t273*t493 - t274*t493 - t275*t494 - t276*t494 - t277*t494,
        D_p_x_2*D_p_x_3_by_b_3_x*k_C + D_p_x_2_by_b_3_x*D_p_x_3*k_C - D_p_x_2_by_b_3_x*t281
        - D_p_x_2_by_b_3_x*t282 - D_p_x_2_by_b_3_x*t283 - D_p_x_3_by_b_3_x*t269 - D_p_x_3_by_b_3_x*t270
        - D_p_x_3_by_b_3_x*t271 + D_p_y_2*D_p_y_3_by_b_3_x*k_C + D_p_y_2_by_b_3_x*D_p_y_3*k_C
        - D_p_y_2_by_b_3_x*t284 - D_p_y_2_by_b_3_x*t285 - D_p_y_2_by_b_3_x*t286 - D_p_y_3_by_b_3_x*t272
        - D_p_y_3_by_b_3_x*t273 - D_p_y_3_by_b_3_x*t274 + D_p_z_2*D_p_z_3_by_b_3_x*k_C
        + D_p_z_2_by_b_3_x*D_p_z_3*k_C - D_p_z_2_by_b_3_x*t287 - D_p_z_2_by_b_3_x*t288
        - D_p_z_2_by_b_3_x*t289 - D_p_z_3_by_b_3_x*t275 - D_p_z_3_by_b_3_x*t276 - D_p_z_3_by_b_3_x*t277
        + mu_1_by_b_3_x*t341 + mu_2_by_b_3_x*t342 + mu_3_by_b_3_x*t343,
        D_delta_x_1_by_b_3_x*t349 + D_delta_y_1_by_b_3_x*t350 + D_delta_z_1_by_b_3_x*t351
        - D_p_x_2_by_b_3_x*t299 - D_p_x_2_by_b_3_x*t300 - D_p_x_2_by_b_3_x*t301 + D_p_x_2_by_b_3_x*t408
        - D_p_y_2_by_b_3_x*t302 - D_p_y_2_by_b_3_x*t303 - D_p_y_2_by_b_3_x*t304 + D_p_y_2_by_b_3_x*t409
        - D_p_z_2_by_b_3_x*t305 - D_p_z_2_by_b_3_x*t306 - D_p_z_2_by_b_3_x*t307 + D_p_z_2_by_b_3_x*t410
        + mu_1_by_b_3_x*t347 + mu_2_by_b_3_x*t348 + mu_3_by_b_3_x*t347,
        D_delta_x_2_by_b_3_x*t349 + D_delta_y_2_by_b_3_x*t350 + D_delta_z_2_by_b_3_x*t351
        - D_p_x_2_by_b_3_x*t313 - D_p_x_2_by_b_3_x*t314 - D_p_x_2_by_b_3_x*t315 + D_p_x_2_by_b_3_x*t411
        - D_p_y_2_by_b_3_x*t316 - D_p_y_2_by_b_3_x*t317 - D_p_y_2_by_b_3_x*t318 + D_p_y_2_by_b_3_x*t412
        - D_p_z_2_by_b_3_x*t319 - D_p_z_2_by_b_3_x*t320 - D_p_z_2_by_b_3_x*t321 + D_p_z_2_by_b_3_x*t413
        + mu_1_by_b_3_x*t352 + mu_2_by_b_3_x*t353 + mu_3_by_b_3_x*t352,
        D_delta_x_3_by_b_3_x*t349 + D_delta_y_3_by_b_3_x*t350 + D_delta_z_3_by_b_3_x*t351
        - D_p_x_2_by_b_3_x*t324 - D_p_x_2_by_b_3_x*t325 - D_p_x_2_by_b_3_x*t326 + D_p_x_2_by_b_3_x*t414
        - D_p_y_2_by_b_3_x*t327 - D_p_y_2_by_b_3_x*t328 - D_p_y_2_by_b_3_x*t329 + D_p_y_2_by_b_3_x*t415
        - D_p_z_2_by_b_3_x*t330 - D_p_z_2_by_b_3_x*t331 - D_p_z_2_by_b_3_x*t332 + D_p_z_2_by_b_3_x*t416
        + mu_1_by_b_3_x*t354 + mu_2_by_b_3_x*t355 + mu_3_by_b_3_x*t354,
        D_p_x_2_by_b_3_x*k_C, D_p_y_2_by_b_3_x*k_C, D_p_z_2_by_b_3_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_x*k_C
        + k_sp_3*t498*t504*w_b_3*x_3_by_b_3_x + mu_1_by_b_3_x*t359 + mu_2_by_b_3_x*t359
        + mu_3_by_b_3_x*t360 - t281*t495 - t282*t495 - t283*t495 - t284*t496 - t285*t496 - t286*t496
        - t287*t497 - t288*t497 - t289*t497 - t503,
        t506, t507,
        D_delta_x_1_by_b_3_x*t366 + D_delta_y_1_by_b_3_x*t367 + D_delta_z_1_by_b_3_x*t368
        - D_p_x_3_by_b_3_x*t299 - D_p_x_3_by_b_3_x*t300 - D_p_x_3_by_b_3_x*t301 + D_p_x_3_by_b_3_x*t408
        - D_p_y_3_by_b_3_x*t302 - D_p_y_3_by_b_3_x*t303 - D_p_y_3_by_b_3_x*t304 + D_p_y_3_by_b_3_x*t409
        - D_p_z_3_by_b_3_x*t305 - D_p_z_3_by_b_3_x*t306 - D_p_z_3_by_b_3_x*t307 + D_p_z_3_by_b_3_x*t410
        + mu_1_by_b_3_x*t364 + mu_2_by_b_3_x*t364 + mu_3_by_b_3_x*t365,
        D_delta_x_2_by_b_3_x*t366 + D_delta_y_2_by_b_3_x*t367 + D_delta_z_2_by_b_3_x*t368
        - D_p_x_3_by_b_3_x*t313 - D_p_x_3_by_b_3_x*t314 - D_p_x_3_by_b_3_x*t315 + D_p_x_3_by_b_3_x*t411
        - D_p_y_3_by_b_3_x*t316 - D_p_y_3_by_b_3_x*t317 - D_p_y_3_by_b_3_x*t318 + D_p_y_3_by_b_3_x*t412
        - D_p_z_3_by_b_3_x*t319 - D_p_z_3_by_b_3_x*t320 - D_p_z_3_by_b_3_x*t321 + D_p_z_3_by_b_3_x*t413
        + mu_1_by_b_3_x*t369 + mu_2_by_b_3_x*t369 + mu_3_by_b_3_x*t370,
        D_delta_x_3_by_b_3_x*t366 + D_delta_y_3_by_b_3_x*t367 + D_delta_z_3_by_b_3_x*t368
        - D_p_x_3_by_b_3_x*t324 - D_p_x_3_by_b_3_x*t325 - D_p_x_3_by_b_3_x*t326 + D_p_x_3_by_b_3_x*t414
        - D_p_y_3_by_b_3_x*t327 - D_p_y_3_by_b_3_x*t328 - D_p_y_3_by_b_3_x*t329 + D_p_y_3_by_b_3_x*t415
        - D_p_z_3_by_b_3_x*t330 - D_p_z_3_by_b_3_x*t331 - D_p_z_3_by_b_3_x*t332 + D_p_z_3_by_b_3_x*t416
        + mu_1_by_b_3_x*t371 + mu_2_by_b_3_x*t371 + mu_3_by_b_3_x*t372,
        t508, D_p_x_3_by_b_3_x*k_C, D_p_y_3_by_b_3_x*k_C, D_p_z_3_by_b_3_x*k_C, t230*t505, t506, -t230*t503,
        t507,
        D_delta_x_1_by_b_3_x*t374 + D_delta_y_1_by_b_3_x*t375 + D_delta_z_1_by_b_3_x*t376
        + mu_1_by_b_3_x*t377 - mu_2_by_b_3_x*t373 - mu_3_by_b_3_x*t373,
        D_delta_x_1_by_b_3_x*t379 + D_delta_x_2_by_b_3_x*t380 + D_delta_y_1_by_b_3_x*t381
        + D_delta_y_2_by_b_3_x*t382 + D_delta_z_1_by_b_3_x*t383 + D_delta_z_2_by_b_3_x*t384
        + mu_1_by_b_3_x*t378 + mu_2_by_b_3_x*t378 + mu_3_by_b_3_x*t378,
        D_delta_x_1_by_b_3_x*t386 + D_delta_x_3_by_b_3_x*t380 + D_delta_y_1_by_b_3_x*t387
        + D_delta_y_3_by_b_3_x*t382 + D_delta_z_1_by_b_3_x*t388 + D_delta_z_3_by_b_3_x*t384
        + mu_1_by_b_3_x*t385 + mu_2_by_b_3_x*t385 + mu_3_by_b_3_x*t385,
        D_delta_x_1_by_b_3_x*k_C, D_delta_y_1_by_b_3_x*k_C, D_delta_z_1_by_b_3_x*k_C,
        D_delta_x_2_by_b_3_x*t390 + D_delta_y_2_by_b_3_x*t391 + D_delta_z_2_by_b_3_x*t392
        - mu_1_by_b_3_x*t389 + mu_2_by_b_3_x*t393 - mu_3_by_b_3_x*t389,
        D_delta_x_2_by_b_3_x*t386 + D_delta_x_3_by_b_3_x*t379 + D_delta_y_2_by_b_3_x*t387
        + D_delta_y_3_by_b_3_x*t381 + D_delta_z_2_by_b_3_x*t388 + D_delta_z_3_by_b_3_x*t383
        + mu_1_by_b_3_x*t394 + mu_2_by_b_3_x*t394 + mu_3_by_b_3_x*t394,
        D_delta_x_2_by_b_3_x*k_C, D_delta_y_2_by_b_3_x*k_C, D_delta_z_2_by_b_3_x*k_C,
        D_delta_x_3_by_b_3_x*t396 + D_delta_y_3_by_b_3_x*t397 + D_delta_z_3_by_b_3_x*t398
        - mu_1_by_b_3_x*t395 - mu_2_by_b_3_x*t395 + mu_3_by_b_3_x*t399,
        D_delta_x_3_by_b_3_x*k_C, D_delta_y_3_by_b_3_x*k_C, D_delta_z_3_by_b_3_x*k_C, t508,
        2*D_p_x_1*D_p_x_1_by_b_3_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_y*k_C
        + mu_1_by_b_3_y*t266 + mu_2_by_b_3_y*t267 + mu_3_by_b_3_y*t267 - t248*t509 - t250*t509 - t251*t509
        - t252*t510 - t254*t510 - t255*t510 - t256*t511 - t258*t511 - t259*t511,
        D_p_x_1*D_p_x_2_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_2*k_C - D_p_x_1_by_b_3_y*t269
        - D_p_x_1_by_b_3_y*t270 - D_p_x_1_by_b_3_y*t271 - D_p_x_2_by_b_3_y*t248 - D_p_x_2_by_b_3_y*t250
        - D_p_x_2_by_b_3_y*t251 + D_p_y_1*D_p_y_2_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_2*k_C
        - D_p_y_1_by_b_3_y*t272 - D_p_y_1_by_b_3_y*t273 - D_p_y_1_by_b_3_y*t274 - D_p_y_2_by_b_3_y*t252
        - D_p_y_2_by_b_3_y*t254 - D_p_y_2_by_b_3_y*t255 + D_p_z_1*D_p_z_2_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_2*k_C - D_p_z_1_by_b_3_y*t275 - D_p_z_1_by_b_3_y*t276
        - D_p_z_1_by_b_3_y*t277 - D_p_z_2_by_b_3_y*t256 - D_p_z_2_by_b_3_y*t258 - D_p_z_2_by_b_3_y*t259
        + mu_1_by_b_3_y*t278 + mu_2_by_b_3_y*t279 + mu_3_by_b_3_y*t280,
        D_p_x_1*D_p_x_3_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_3*k_C - D_p_x_1_by_b_3_y*t281
        - D_p_x_1_by_b_3_y*t282 - D_p_x_1_by_b_3_y*t283 - D_p_x_3_by_b_3_y*t248 - D_p_x_3_by_b_3_y*t250
        - D_p_x_3_by_b_3_y*t251 + D_p_y_1*D_p_y_3_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_3*k_C
        - D_p_y_1_by_b_3_y*t284 - D_p_y_1_by_b_3_y*t285 - D_p_y_1_by_b_3_y*t286 - D_p_y_3_by_b_3_y*t252
        - D_p_y_3_by_b_3_y*t254 - D_p_y_3_by_b_3_y*t255 + D_p_z_1*D_p_z_3_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_3*k_C - D_p_z_1_by_b_3_y*t287 - D_p_z_1_by_b_3_y*t288
        - D_p_z_1_by_b_3_y*t289 - D_p_z_3_by_b_3_y*t256 - D_p_z_3_by_b_3_y*t258 - D_p_z_3_by_b_3_y*t259
        + mu_1_by_b_3_y*t290 + mu_2_by_b_3_y*t291 + mu_3_by_b_3_y*t292,
        D_delta_x_1_by_b_3_y*t310 + D_delta_y_1_by_b_3_y*t311 + D_delta_z_1_by_b_3_y*t312
        - D_p_x_1_by_b_3_y*t299 - D_p_x_1_by_b_3_y*t300 - D_p_x_1_by_b_3_y*t301 + D_p_x_1_by_b_3_y*t408
        - D_p_y_1_by_b_3_y*t302 - D_p_y_1_by_b_3_y*t303 - D_p_y_1_by_b_3_y*t304 + D_p_y_1_by_b_3_y*t409
        - D_p_z_1_by_b_3_y*t305 - D_p_z_1_by_b_3_y*t306 - D_p_z_1_by_b_3_y*t307 + D_p_z_1_by_b_3_y*t410
        + mu_1_by_b_3_y*t308 + mu_2_by_b_3_y*t309 + mu_3_by_b_3_y*t309,
        D_delta_x_2_by_b_3_y*t310 + D_delta_y_2_by_b_3_y*t311 + D_delta_z_2_by_b_3_y*t312
        - D_p_x_1_by_b_3_y*t313 - D_p_x_1_by_b_3_y*t314 - D_p_x_1_by_b_3_y*t315 + D_p_x_1_by_b_3_y*t411
        - D_p_y_1_by_b_3_y*t316 - D_p_y_1_by_b_3_y*t317 - D_p_y_1_by_b_3_y*t318 + D_p_y_1_by_b_3_y*t412
        - D_p_z_1_by_b_3_y*t319 - D_p_z_1_by_b_3_y*t320 - D_p_z_1_by_b_3_y*t321 + D_p_z_1_by_b_3_y*t413
        + mu_1_by_b_3_y*t322 + mu_2_by_b_3_y*t323 + mu_3_by_b_3_y*t323,
        D_delta_x_3_by_b_3_y*t310 + D_delta_y_3_by_b_3_y*t311 + D_delta_z_3_by_b_3_y*t312
        - D_p_x_1_by_b_3_y*t324 - D_p_x_1_by_b_3_y*t325 - D_p_x_1_by_b_3_y*t326 + D_p_x_1_by_b_3_y*t414
        - D_p_y_1_by_b_3_y*t327 - D_p_y_1_by_b_3_y*t328 - D_p_y_1_by_b_3_y*t329 + D_p_y_1_by_b_3_y*t415
        - D_p_z_1_by_b_3_y*t330 - D_p_z_1_by_b_3_y*t331 - D_p_z_1_by_b_3_y*t332 + D_p_z_1_by_b_3_y*t416
        + mu_1_by_b_3_y*t333 + mu_2_by_b_3_y*t334 + mu_3_by_b_3_y*t334,
        D_p_x_1_by_b_3_y*k_C, D_p_y_1_by_b_3_y*k_C, D_p_z_1_by_b_3_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_y*k_C
        + mu_1_by_b_3_y*t339 + mu_2_by_b_3_y*t340 + mu_3_by_b_3_y*t339 - t269*t512 - t270*t512 - t271*t512
        - t272*t513 - t273*t513 - t274*t513 - t275*t514 - t276*t514 - t277*t514,
        D_p_x_2*D_p_x_3_by_b_3_y*k_C + D_p_x_2_by_b_3_y*D_p_x_3*k_C - D_p_x_2_by_b_3_y*t281
        - D_p_x_2_by_b_3_y*t282 - D_p_x_2_by_b_3_y*t283 - D_p_x_3_by_b_3_y*t269 - D_p_x_3_by_b_3_y*t270
        - D_p_x_3_by_b_3_y*t271 + D_p_y_2*D_p_y_3_by_b_3_y*k_C + D_p_y_2_by_b_3_y*D_p_y_3*k_C
        - D_p_y_2_by_b_3_y*t284 - D_p_y_2_by_b_3_y*t285 - D_p_y_2_by_b_3_y*t286 - D_p_y_3_by_b_3_y*t272
        - D_p_y_3_by_b_3_y*t273 - D_p_y_3_by_b_3_y*t274 + D_p_z_2*D_p_z_3_by_b_3_y*k_C
        + D_p_z_2_by_b_3_y*D_p_z_3*k_C - D_p_z_2_by_b_3_y*t287 - D_p_z_2_by_b_3_y*t288
        - D_p_z_2_by_b_3_y*t289 - D_p_z_3_by_b_3_y*t275 - D_p_z_3_by_b_3_y*t276 - D_p_z_3_by_b_3_y*t277
        + mu_1_by_b_3_y*t341 + mu_2_by_b_3_y*t342 + mu_3_by_b_3_y*t343,
        D_delta_x_1_by_b_3_y*t349 + D_delta_y_1_by_b_3_y*t350 + D_delta_z_1_by_b_3_y*t351
        - D_p_x_2_by_b_3_y*t299 - D_p_x_2_by_b_3_y*t300 - D_p_x_2_by_b_3_y*t301 + D_p_x_2_by_b_3_y*t408
        - D_p_y_2_by_b_3_y*t302 - D_p_y_2_by_b_3_y*t303 - D_p_y_2_by_b_3_y*t304 + D_p_y_2_by_b_3_y*t409
        - D_p_z_2_by_b_3_y*t305 - D_p_z_2_by_b_3_y*t306 - D_p_z_2_by_b_3_y*t307 + D_p_z_2_by_b_3_y*t410
        + mu_1_by_b_3_y*t347 + mu_2_by_b_3_y*t348 + mu_3_by_b_3_y*t347,
        D_delta_x_2_by_b_3_y*t349 + D_delta_y_2_by_b_3_y*t350 + D_delta_z_2_by_b_3_y*t351
        - D_p_x_2_by_b_3_y*t313 - D_p_x_2_by_b_3_y*t314 - D_p_x_2_by_b_3_y*t315 + D_p_x_2_by_b_3_y*t411
        - D_p_y_2_by_b_3_y*t316 - D_p_y_2_by_b_3_y*t317 - D_p_y_2_by_b_3_y*t318 + D_p_y_2_by_b_3_y*t412
        - D_p_z_2_by_b_3_y*t319 - D_p_z_2_by_b_3_y*t320 - D_p_z_2_by_b_3_y*t321 + D_p_z_2_by_b_3_y*t413
        + mu_1_by_b_3_y*t352 + mu_2_by_b_3_y*t353 + mu_3_by_b_3_y*t352,
        D_delta_x_3_by_b_3_y*t349 + D_delta_y_3_by_b_3_y*t350 + D_delta_z_3_by_b_3_y*t351
        - D_p_x_2_by_b_3_y*t324 - D_p_x_2_by_b_3_y*t325 - D_p_x_2_by_b_3_y*t326 + D_p_x_2_by_b_3_y*t414
        - D_p_y_2_by_b_3_y*t327 - D_p_y_2_by_b_3_y*t328 - D_p_y_2_by_b_3_y*t329 + D_p_y_2_by_b_3_y*t415
        - D_p_z_2_by_b_3_y*t330 - D_p_z_2_by_b_3_y*t331 - D_p_z_2_by_b_3_y*t332 + D_p_z_2_by_b_3_y*t416
        + mu_1_by_b_3_y*t354 + mu_2_by_b_3_y*t355 + mu_3_by_b_3_y*t354,
        D_p_x_2_by_b_3_y*k_C, D_p_y_2_by_b_3_y*k_C, D_p_z_2_by_b_3_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_y*k_C
        + k_sp_3*t498*t504*w_b_3*x_3_by_b_3_y + mu_1_by_b_3_y*t359 + mu_2_by_b_3_y*t359
        + mu_3_by_b_3_y*t360 - t281*t515 - t282*t515 - t283*t515 - t284*t516 - t285*t516 - t286*t516
        - t287*t517 - t288*t517 - t289*t517 - t519,
        t521, t522,
        D_delta_x_1_by_b_3_y*t366 + D_delta_y_1_by_b_3_y*t367 + D_delta_z_1_by_b_3_y*t368
        - D_p_x_3_by_b_3_y*t299 - D_p_x_3_by_b_3_y*t300 - D_p_x_3_by_b_3_y*t301 + D_p_x_3_by_b_3_y*t408
        - D_p_y_3_by_b_3_y*t302 - D_p_y_3_by_b_3_y*t303 - D_p_y_3_by_b_3_y*t304 + D_p_y_3_by_b_3_y*t409
        - D_p_z_3_by_b_3_y*t305 - D_p_z_3_by_b_3_y*t306 - D_p_z_3_by_b_3_y*t307 + D_p_z_3_by_b_3_y*t410
        + mu_1_by_b_3_y*t364 + mu_2_by_b_3_y*t364 + mu_3_by_b_3_y*t365,
        D_delta_x_2_by_b_3_y*t366 + D_delta_y_2_by_b_3_y*t367 + D_delta_z_2_by_b_3_y*t368
        - D_p_x_3_by_b_3_y*t313 - D_p_x_3_by_b_3_y*t314 - D_p_x_3_by_b_3_y*t315 + D_p_x_3_by_b_3_y*t411
        - D_p_y_3_by_b_3_y*t316 - D_p_y_3_by_b_3_y*t317 - D_p_y_3_by_b_3_y*t318 + D_p_y_3_by_b_3_y*t412
        - D_p_z_3_by_b_3_y*t319 - D_p_z_3_by_b_3_y*t320 - D_p_z_3_by_b_3_y*t321 + D_p_z_3_by_b_3_y*t413
        + mu_1_by_b_3_y*t369 + mu_2_by_b_3_y*t369 + mu_3_by_b_3_y*t370,
        D_delta_x_3_by_b_3_y*t366 + D_delta_y_3_by_b_3_y*t367 + D_delta_z_3_by_b_3_y*t368
        - D_p_x_3_by_b_3_y*t324 - D_p_x_3_by_b_3_y*t325 - D_p_x_3_by_b_3_y*t326 + D_p_x_3_by_b_3_y*t414
        - D_p_y_3_by_b_3_y*t327 - D_p_y_3_by_b_3_y*t328 - D_p_y_3_by_b_3_y*t329 + D_p_y_3_by_b_3_y*t415
        - D_p_z_3_by_b_3_y*t330 - D_p_z_3_by_b_3_y*t331 - D_p_z_3_by_b_3_y*t332 + D_p_z_3_by_b_3_y*t416
        + mu_1_by_b_3_y*t371 + mu_2_by_b_3_y*t371 + mu_3_by_b_3_y*t372,
        t523, D_p_x_3_by_b_3_y*k_C, D_p_y_3_by_b_3_y*k_C, D_p_z_3_by_b_3_y*k_C, t230*t520, t521, -t230*t519,
        t522,
        D_delta_x_1_by_b_3_y*t374 + D_delta_y_1_by_b_3_y*t375 + D_delta_z_1_by_b_3_y*t376
        + mu_1_by_b_3_y*t377 - mu_2_by_b_3_y*t373 - mu_3_by_b_3_y*t373,
        D_delta_x_1_by_b_3_y*t379 + D_delta_x_2_by_b_3_y*t380 + D_delta_y_1_by_b_3_y*t381
        + D_delta_y_2_by_b_3_y*t382 + D_delta_z_1_by_b_3_y*t383 + D_delta_z_2_by_b_3_y*t384
        + mu_1_by_b_3_y*t378 + mu_2_by_b_3_y*t378 + mu_3_by_b_3_y*t378,
        D_delta_x_1_by_b_3_y*t386 + D_delta_x_3_by_b_3_y*t380 + D_delta_y_1_by_b_3_y*t387
        + D_delta_y_3_by_b_3_y*t382 + D_delta_z_1_by_b_3_y*t388 + D_delta_z_3_by_b_3_y*t384
        + mu_1_by_b_3_y*t385 + mu_2_by_b_3_y*t385 + mu_3_by_b_3_y*t385,
        D_delta_x_1_by_b_3_y*k_C, D_delta_y_1_by_b_3_y*k_C, D_delta_z_1_by_b_3_y*k_C,
        D_delta_x_2_by_b_3_y*t390 + D_delta_y_2_by_b_3_y*t391 + D_delta_z_2_by_b_3_y*t392
        - mu_1_by_b_3_y*t389 + mu_2_by_b_3_y*t393 - mu_3_by_b_3_y*t389,
        D_delta_x_2_by_b_3_y*t386 + D_delta_x_3_by_b_3_y*t379 + D_delta_y_2_by_b_3_y*t387
        + D_delta_y_3_by_b_3_y*t381 + D_delta_z_2_by_b_3_y*t388 + D_delta_z_3_by_b_3_y*t383
        + mu_1_by_b_3_y*t394 + mu_2_by_b_3_y*t394 + mu_3_by_b_3_y*t394,
        D_delta_x_2_by_b_3_y*k_C, D_delta_y_2_by_b_3_y*k_C, D_delta_z_2_by_b_3_y*k_C,
        D_delta_x_3_by_b_3_y*t396 + D_delta_y_3_by_b_3_y*t397 + D_delta_z_3_by_b_3_y*t398
        - mu_1_by_b_3_y*t395 - mu_2_by_b_3_y*t395 + mu_3_by_b_3_y*t399,
        D_delta_x_3_by_b_3_y*k_C, D_delta_y_3_by_b_3_y*k_C, D_delta_z_3_by_b_3_y*k_C, t523,
        2*D_p_x_1*D_p_x_1_by_b_3_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_z*k_C
        + mu_1_by_b_3_z*t266 + mu_2_by_b_3_z*t267 + mu_3_by_b_3_z*t267 - t248*t524 - t250*t524 - t251*t524
        - t252*t525 - t254*t525 - t255*t525 - t256*t526 - t258*t526 - t259*t526,
        D_p_x_1*D_p_x_2_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_2*k_C - D_p_x_1_by_b_3_z*t269
        - D_p_x_1_by_b_3_z*t270 - D_p_x_1_by_b_3_z*t271 - D_p_x_2_by_b_3_z*t248 - D_p_x_2_by_b_3_z*t250
        - D_p_x_2_by_b_3_z*t251 + D_p_y_1*D_p_y_2_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_2*k_C
        - D_p_y_1_by_b_3_z*t272 - D_p_y_1_by_b_3_z*t273 - D_p_y_1_by_b_3_z*t274 - D_p_y_2_by_b_3_z*t252
        - D_p_y_2_by_b_3_z*t254 - D_p_y_2_by_b_3_z*t255 + D_p_z_1*D_p_z_2_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_2*k_C - D_p_z_1_by_b_3_z*t275 - D_p_z_1_by_b_3_z*t276
        - D_p_z_1_by_b_3_z*t277 - D_p_z_2_by_b_3_z*t256 - D_p_z_2_by_b_3_z*t258 - D_p_z_2_by_b_3_z*t259
        + mu_1_by_b_3_z*t278 + mu_2_by_b_3_z*t279 + mu_3_by_b_3_z*t280,
        D_p_x_1*D_p_x_3_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_3*k_C - D_p_x_1_by_b_3_z*t281
        - D_p_x_1_by_b_3_z*t282 - D_p_x_1_by_b_3_z*t283 - D_p_x_3_by_b_3_z*t248 - D_p_x_3_by_b_3_z*t250
        - D_p_x_3_by_b_3_z*t251 + D_p_y_1*D_p_y_3_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_3*k_C
        - D_p_y_1_by_b_3_z*t284 - D_p_y_1_by_b_3_z*t285 - D_p_y_1_by_b_3_z*t286 - D_p_y_3_by_b_3_z*t252
        - D_p_y_3_by_b_3_z*t254 - D_p_y_3_by_b_3_z*t255 + D_p_z_1*D_p_z_3_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_3*k_C - D_p_z_1_by_b_3_z*t287 - D_p_z_1_by_b_3_z*t288
        - D_p_z_1_by_b_3_z*t289 - D_p_z_3_by_b_3_z*t256 - D_p_z_3_by_b_3_z*t258 - D_p_z_3_by_b_3_z*t259
        + mu_1_by_b_3_z*t290 + mu_2_by_b_3_z*t291 + mu_3_by_b_3_z*t292,
        D_delta_x_1_by_b_3_z*t310 + D_delta_y_1_by_b_3_z*t311 + D_delta_z_1_by_b_3_z*t312
        - D_p_x_1_by_b_3_z*t299 - D_p_x_1_by_b_3_z*t300 - D_p_x_1_by_b_3_z*t301 + D_p_x_1_by_b_3_z*t408
        - D_p_y_1_by_b_3_z*t302 - D_p_y_1_by_b_3_z*t303 - D_p_y_1_by_b_3_z*t304 + D_p_y_1_by_b_3_z*t409
        - D_p_z_1_by_b_3_z*t305 - D_p_z_1_by_b_3_z*t306 - D_p_z_1_by_b_3_z*t307 + D_p_z_1_by_b_3_z*t410
        + mu_1_by_b_3_z*t308 + mu_2_by_b_3_z*t309 + mu_3_by_b_3_z*t309,
        D_delta_x_2_by_b_3_z*t310 + D_delta_y_2_by_b_3_z*t311 + D_delta_z_2_by_b_3_z*t312
        - D_p_x_1_by_b_3_z*t313 - D_p_x_1_by_b_3_z*t314 - D_p_x_1_by_b_3_z*t315 + D_p_x_1_by_b_3_z*t411
        - D_p_y_1_by_b_3_z*t316 - D_p_y_1_by_b_3_z*t317 - D_p_y_1_by_b_3_z*t318 + D_p_y_1_by_b_3_z*t412
        - D_p_z_1_by_b_3_z*t319 - D_p_z_1_by_b_3_z*t320 - D_p_z_1_by_b_3_z*t321 + D_p_z_1_by_b_3_z*t413
        + mu_1_by_b_3_z*t322 + mu_2_by_b_3_z*t323 + mu_3_by_b_3_z*t323,
        D_delta_x_3_by_b_3_z*t310 + D_delta_y_3_by_b_3_z*t311 + D_delta_z_3_by_b_3_z*t312
        - D_p_x_1_by_b_3_z*t324 - D_p_x_1_by_b_3_z*t325 - D_p_x_1_by_b_3_z*t326 + D_p_x_1_by_b_3_z*t414
        - D_p_y_1_by_b_3_z*t327 - D_p_y_1_by_b_3_z*t328 - D_p_y_1_by_b_3_z*t329 + D_p_y_1_by_b_3_z*t415
        - D_p_z_1_by_b_3_z*t330 - D_p_z_1_by_b_3_z*t331 - D_p_z_1_by_b_3_z*t332 + D_p_z_1_by_b_3_z*t416
        + mu_1_by_b_3_z*t333 + mu_2_by_b_3_z*t334 + mu_3_by_b_3_z*t334,
        D_p_x_1_by_b_3_z*k_C, D_p_y_1_by_b_3_z*k_C, D_p_z_1_by_b_3_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_z*k_C
        + mu_1_by_b_3_z*t339 + mu_2_by_b_3_z*t340 + mu_3_by_b_3_z*t339 - t269*t527 - t270*t527 - t271*t527
        - t272*t528 - t273*t528 - t274*t528 - t275*t529 - t276*t529 - t277*t529,
        D_p_x_2*D_p_x_3_by_b_3_z*k_C + D_p_x_2_by_b_3_z*D_p_x_3*k_C - D_p_x_2_by_b_3_z*t281
        - D_p_x_2_by_b_3_z*t282 - D_p_x_2_by_b_3_z*t283 - D_p_x_3_by_b_3_z*t269 - D_p_x_3_by_b_3_z*t270
        - D_p_x_3_by_b_3_z*t271 + D_p_y_2*D_p_y_3_by_b_3_z*k_C + D_p_y_2_by_b_3_z*D_p_y_3*k_C
        - D_p_y_2_by_b_3_z*t284 - D_p_y_2_by_b_3_z*t285 - D_p_y_2_by_b_3_z*t286 - D_p_y_3_by_b_3_z*t272
        - D_p_y_3_by_b_3_z*t273 - D_p_y_3_by_b_3_z*t274 + D_p_z_2*D_p_z_3_by_b_3_z*k_C
        + D_p_z_2_by_b_3_z*D_p_z_3*k_C - D_p_z_2_by_b_3_z*t287 - D_p_z_2_by_b_3_z*t288
        - D_p_z_2_by_b_3_z*t289 - D_p_z_3_by_b_3_z*t275 - D_p_z_3_by_b_3_z*t276 - D_p_z_3_by_b_3_z*t277
        + mu_1_by_b_3_z*t341 + mu_2_by_b_3_z*t342 + mu_3_by_b_3_z*t343,
        D_delta_x_1_by_b_3_z*t349 + D_delta_y_1_by_b_3_z*t350 + D_delta_z_1_by_b_3_z*t351
        - D_p_x_2_by_b_3_z*t299 - D_p_x_2_by_b_3_z*t300 - D_p_x_2_by_b_3_z*t301 + D_p_x_2_by_b_3_z*t408
        - D_p_y_2_by_b_3_z*t302 - D_p_y_2_by_b_3_z*t303 - D_p_y_2_by_b_3_z*t304 + D_p_y_2_by_b_3_z*t409
        - D_p_z_2_by_b_3_z*t305 - D_p_z_2_by_b_3_z*t306 - D_p_z_2_by_b_3_z*t307 + D_p_z_2_by_b_3_z*t410
        + mu_1_by_b_3_z*t347 + mu_2_by_b_3_z*t348 + mu_3_by_b_3_z*t347,
        D_delta_x_2_by_b_3_z*t349 + D_delta_y_2_by_b_3_z*t350 + D_delta_z_2_by_b_3_z*t351
        - D_p_x_2_by_b_3_z*t313 - D_p_x_2_by_b_3_z*t314 - D_p_x_2_by_b_3_z*t315 + D_p_x_2_by_b_3_z*t411
        - D_p_y_2_by_b_3_z*t316 - D_p_y_2_by_b_3_z*t317 - D_p_y_2_by_b_3_z*t318 + D_p_y_2_by_b_3_z*t412
        - D_p_z_2_by_b_3_z*t319 - D_p_z_2_by_b_3_z*t320 - D_p_z_2_by_b_3_z*t321 + D_p_z_2_by_b_3_z*t413
        + mu_1_by_b_3_z*t352 + mu_2_by_b_3_z*t353 + mu_3_by_b_3_z*t352,
        D_delta_x_3_by_b_3_z*t349 + D_delta_y_3_by_b_3_z*t350 + D_delta_z_3_by_b_3_z*t351
        - D_p_x_2_by_b_3_z*t324 - D_p_x_2_by_b_3_z*t325 - D_p_x_2_by_b_3_z*t326 + D_p_x_2_by_b_3_z*t414
        - D_p_y_2_by_b_3_z*t327 - D_p_y_2_by_b_3_z*t328 - D_p_y_2_by_b_3_z*t329 + D_p_y_2_by_b_3_z*t415
        - D_p_z_2_by_b_3_z*t330 - D_p_z_2_by_b_3_z*t331 - D_p_z_2_by_b_3_z*t332 + D_p_z_2_by_b_3_z*t416
        + mu_1_by_b_3_z*t354 + mu_2_by_b_3_z*t355 + mu_3_by_b_3_z*t354,
        D_p_x_2_by_b_3_z*k_C, D_p_y_2_by_b_3_z*k_C, D_p_z_2_by_b_3_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_z*k_C
        + k_sp_3*t498*t504*w_b_3*x_3_by_b_3_z + mu_1_by_b_3_z*t359 + mu_2_by_b_3_z*t359
        + mu_3_by_b_3_z*t360 - t281*t530 - t282*t530 - t283*t530 - t284*t531 - t285*t531 - t286*t531
        - t287*t532 - t288*t532 - t289*t532 - t534,
        t536, t537,
        D_delta_x_1_by_b_3_z*t366 + D_delta_y_1_by_b_3_z*t367 + D_delta_z_1_by_b_3_z*t368
        - D_p_x_3_by_b_3_z*t299 - D_p_x_3_by_b_3_z*t300 - D_p_x_3_by_b_3_z*t301 + D_p_x_3_by_b_3_z*t408
        - D_p_y_3_by_b_3_z*t302 - D_p_y_3_by_b_3_z*t303 - D_p_y_3_by_b_3_z*t304 + D_p_y_3_by_b_3_z*t409
        - D_p_z_3_by_b_3_z*t305 - D_p_z_3_by_b_3_z*t306 - D_p_z_3_by_b_3_z*t307 + D_p_z_3_by_b_3_z*t410
        + mu_1_by_b_3_z*t364 + mu_2_by_b_3_z*t364 + mu_3_by_b_3_z*t365,
        D_delta_x_2_by_b_3_z*t366 + D_delta_y_2_by_b_3_z*t367 + D_delta_z_2_by_b_3_z*t368
        - D_p_x_3_by_b_3_z*t313 - D_p_x_3_by_b_3_z*t314 - D_p_x_3_by_b_3_z*t315 + D_p_x_3_by_b_3_z*t411
        - D_p_y_3_by_b_3_z*t316 - D_p_y_3_by_b_3_z*t317 - D_p_y_3_by_b_3_z*t318 + D_p_y_3_by_b_3_z*t412
        - D_p_z_3_by_b_3_z*t319 - D_p_z_3_by_b_3_z*t320 - D_p_z_3_by_b_3_z*t321 + D_p_z_3_by_b_3_z*t413
        + mu_1_by_b_3_z*t369 + mu_2_by_b_3_z*t369 + mu_3_by_b_3_z*t370,
        D_delta_x_3_by_b_3_z*t366 + D_delta_y_3_by_b_3_z*t367 + D_delta_z_3_by_b_3_z*t368
        - D_p_x_3_by_b_3_z*t324 - D_p_x_3_by_b_3_z*t325 - D_p_x_3_by_b_3_z*t326 + D_p_x_3_by_b_3_z*t414
        - D_p_y_3_by_b_3_z*t327 - D_p_y_3_by_b_3_z*t328 - D_p_y_3_by_b_3_z*t329 + D_p_y_3_by_b_3_z*t415
        - D_p_z_3_by_b_3_z*t330 - D_p_z_3_by_b_3_z*t331 - D_p_z_3_by_b_3_z*t332 + D_p_z_3_by_b_3_z*t416
        + mu_1_by_b_3_z*t371 + mu_2_by_b_3_z*t371 + mu_3_by_b_3_z*t372,
        t538, D_p_x_3_by_b_3_z*k_C, D_p_y_3_by_b_3_z*k_C, D_p_z_3_by_b_3_z*k_C, t230*t535, t536, -t230*t534,
        t537,
        D_delta_x_1_by_b_3_z*t374 + D_delta_y_1_by_b_3_z*t375 + D_delta_z_1_by_b_3_z*t376
        + mu_1_by_b_3_z*t377 - mu_2_by_b_3_z*t373 - mu_3_by_b_3_z*t373,
        D_delta_x_1_by_b_3_z*t379 + D_delta_x_2_by_b_3_z*t380 + D_delta_y_1_by_b_3_z*t381
        + D_delta_y_2_by_b_3_z*t382 + D_delta_z_1_by_b_3_z*t383 + D_delta_z_2_by_b_3_z*t384
        + mu_1_by_b_3_z*t378 + mu_2_by_b_3_z*t378 + mu_3_by_b_3_z*t378,
        D_delta_x_1_by_b_3_z*t386 + D_delta_x_3_by_b_3_z*t380 + D_delta_y_1_by_b_3_z*t387
        + D_delta_y_3_by_b_3_z*t382 + D_delta_z_1_by_b_3_z*t388 + D_delta_z_3_by_b_3_z*t384
        + mu_1_by_b_3_z*t385 + mu_2_by_b_3_z*t385 + mu_3_by_b_3_z*t385,
        D_delta_x_1_by_b_3_z*k_C, D_delta_y_1_by_b_3_z*k_C, D_delta_z_1_by_b_3_z*k_C,
        D_delta_x_2_by_b_3_z*t390 + D_delta_y_2_by_b_3_z*t391 + D_delta_z_2_by_b_3_z*t392
        - mu_1_by_b_3_z*t389 + mu_2_by_b_3_z*t393 - mu_3_by_b_3_z*t389,
        D_delta_x_2_by_b_3_z*t386 + D_delta_x_3_by_b_3_z*t379 + D_delta_y_2_by_b_3_z*t387
        + D_delta_y_3_by_b_3_z*t381 + D_delta_z_2_by_b_3_z*t388 + D_delta_z_3_by_b_3_z*t383
        + mu_1_by_b_3_z*t394 + mu_2_by_b_3_z*t394 + mu_3_by_b_3_z*t394,
        D_delta_x_2_by_b_3_z*k_C, D_delta_y_2_by_b_3_z*k_C, D_delta_z_2_by_b_3_z*k_C,
        D_delta_x_3_by_b_3_z*t396 + D_delta_y_3_by_b_3_z*t397 + D_delta_z_3_by_b_3_z*t398
        - mu_1_by_b_3_z*t395 - mu_2_by_b_3_z*t395 + mu_3_by_b_3_z*t399,
        D_delta_x_3_by_b_3_z*k_C, D_delta_y_3_by_b_3_z*k_C, D_delta_z_3_by_b_3_z*k_C, t538,
        2*D_p_x_1*D_p_x_1_by_l_d_1*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_1*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_1*k_C
        + k_sp_1*t260*t268*w_b_1*x_1_by_l_d_1 + mu_1_by_l_d_1*t266 + mu_2_by_l_d_1*t267
        + mu_3_by_l_d_1*t267 - t248*t539 - t250*t539 - t251*t539 - t252*t540 - t254*t540 - t255*t540
        - t256*t541 - t258*t541 - t259*t541 - t543,
        D_p_x_1*D_p_x_2_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_2*k_C - D_p_x_1_by_l_d_1*t269
        - D_p_x_1_by_l_d_1*t270 - D_p_x_1_by_l_d_1*t271 - D_p_x_2_by_l_d_1*t248 - D_p_x_2_by_l_d_1*t250
        - D_p_x_2_by_l_d_1*t251 + D_p_y_1*D_p_y_2_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_2*k_C
        - D_p_y_1_by_l_d_1*t272 - D_p_y_1_by_l_d_1*t273 - D_p_y_1_by_l_d_1*t274 - D_p_y_2_by_l_d_1*t252
        - D_p_y_2_by_l_d_1*t254 - D_p_y_2_by_l_d_1*t255 + D_p_z_1*D_p_z_2_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_2*k_C - D_p_z_1_by_l_d_1*t275 - D_p_z_1_by_l_d_1*t276
        - D_p_z_1_by_l_d_1*t277 - D_p_z_2_by_l_d_1*t256 - D_p_z_2_by_l_d_1*t258 - D_p_z_2_by_l_d_1*t259
        + mu_1_by_l_d_1*t278 + mu_2_by_l_d_1*t279 + mu_3_by_l_d_1*t280,
        D_p_x_1*D_p_x_3_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_3*k_C - D_p_x_1_by_l_d_1*t281
        - D_p_x_1_by_l_d_1*t282 - D_p_x_1_by_l_d_1*t283 - D_p_x_3_by_l_d_1*t248 - D_p_x_3_by_l_d_1*t250
        - D_p_x_3_by_l_d_1*t251 + D_p_y_1*D_p_y_3_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_3*k_C
        - D_p_y_1_by_l_d_1*t284 - D_p_y_1_by_l_d_1*t285 - D_p_y_1_by_l_d_1*t286 - D_p_y_3_by_l_d_1*t252
        - D_p_y_3_by_l_d_1*t254 - D_p_y_3_by_l_d_1*t255 + D_p_z_1*D_p_z_3_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_3*k_C - D_p_z_1_by_l_d_1*t287 - D_p_z_1_by_l_d_1*t288
        - D_p_z_1_by_l_d_1*t289 - D_p_z_3_by_l_d_1*t256 - D_p_z_3_by_l_d_1*t258 - D_p_z_3_by_l_d_1*t259
        + mu_1_by_l_d_1*t290 + mu_2_by_l_d_1*t291 + mu_3_by_l_d_1*t292,
        t545, t546,
        D_delta_x_1_by_l_d_1*t310 + D_delta_y_1_by_l_d_1*t311 + D_delta_z_1_by_l_d_1*t312
        - D_p_x_1_by_l_d_1*t299 - D_p_x_1_by_l_d_1*t300 - D_p_x_1_by_l_d_1*t301 + D_p_x_1_by_l_d_1*t408
        - D_p_y_1_by_l_d_1*t302 - D_p_y_1_by_l_d_1*t303 - D_p_y_1_by_l_d_1*t304 + D_p_y_1_by_l_d_1*t409
        - D_p_z_1_by_l_d_1*t305 - D_p_z_1_by_l_d_1*t306 - D_p_z_1_by_l_d_1*t307 + D_p_z_1_by_l_d_1*t410
        + mu_1_by_l_d_1*t308 + mu_2_by_l_d_1*t309 + mu_3_by_l_d_1*t309,
        D_delta_x_2_by_l_d_1*t310 + D_delta_y_2_by_l_d_1*t311 + D_delta_z_2_by_l_d_1*t312
        - D_p_x_1_by_l_d_1*t313 - D_p_x_1_by_l_d_1*t314 - D_p_x_1_by_l_d_1*t315 + D_p_x_1_by_l_d_1*t411
        - D_p_y_1_by_l_d_1*t316 - D_p_y_1_by_l_d_1*t317 - D_p_y_1_by_l_d_1*t318 + D_p_y_1_by_l_d_1*t412
        - D_p_z_1_by_l_d_1*t319 - D_p_z_1_by_l_d_1*t320 - D_p_z_1_by_l_d_1*t321 + D_p_z_1_by_l_d_1*t413
        + mu_1_by_l_d_1*t322 + mu_2_by_l_d_1*t323 + mu_3_by_l_d_1*t323,
        D_delta_x_3_by_l_d_1*t310 + D_delta_y_3_by_l_d_1*t311 + D_delta_z_3_by_l_d_1*t312
        - D_p_x_1_by_l_d_1*t324 - D_p_x_1_by_l_d_1*t325 - D_p_x_1_by_l_d_1*t326 + D_p_x_1_by_l_d_1*t414
        - D_p_y_1_by_l_d_1*t327 - D_p_y_1_by_l_d_1*t328 - D_p_y_1_by_l_d_1*t329 + D_p_y_1_by_l_d_1*t415
        - D_p_z_1_by_l_d_1*t330 - D_p_z_1_by_l_d_1*t331 - D_p_z_1_by_l_d_1*t332 + D_p_z_1_by_l_d_1*t416
        + mu_1_by_l_d_1*t333 + mu_2_by_l_d_1*t334 + mu_3_by_l_d_1*t334,
        t547, D_p_x_1_by_l_d_1*k_C, D_p_y_1_by_l_d_1*k_C, D_p_z_1_by_l_d_1*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_1*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_1*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_1*k_C
        + mu_1_by_l_d_1*t339 + mu_2_by_l_d_1*t340 + mu_3_by_l_d_1*t339 - t269*t548 - t270*t548 - t271*t548
        - t272*t549 - t273*t549 - t274*t549 - t275*t550 - t276*t550 - t277*t550,
        D_p_x_2*D_p_x_3_by_l_d_1*k_C + D_p_x_2_by_l_d_1*D_p_x_3*k_C - D_p_x_2_by_l_d_1*t281
        - D_p_x_2_by_l_d_1*t282 - D_p_x_2_by_l_d_1*t283 - D_p_x_3_by_l_d_1*t269 - D_p_x_3_by_l_d_1*t270
        - D_p_x_3_by_l_d_1*t271 + D_p_y_2*D_p_y_3_by_l_d_1*k_C + D_p_y_2_by_l_d_1*D_p_y_3*k_C
        - D_p_y_2_by_l_d_1*t284 - D_p_y_2_by_l_d_1*t285 - D_p_y_2_by_l_d_1*t286 - D_p_y_3_by_l_d_1*t272
        - D_p_y_3_by_l_d_1*t273 - D_p_y_3_by_l_d_1*t274 + D_p_z_2*D_p_z_3_by_l_d_1*k_C
        + D_p_z_2_by_l_d_1*D_p_z_3*k_C - D_p_z_2_by_l_d_1*t287 - D_p_z_2_by_l_d_1*t288
        - D_p_z_2_by_l_d_1*t289 - D_p_z_3_by_l_d_1*t275 - D_p_z_3_by_l_d_1*t276 - D_p_z_3_by_l_d_1*t277
        + mu_1_by_l_d_1*t341 + mu_2_by_l_d_1*t342 + mu_3_by_l_d_1*t343,
        D_delta_x_1_by_l_d_1*t349 + D_delta_y_1_by_l_d_1*t350 + D_delta_z_1_by_l_d_1*t351
        - D_p_x_2_by_l_d_1*t299 - D_p_x_2_by_l_d_1*t300 - D_p_x_2_by_l_d_1*t301 + D_p_x_2_by_l_d_1*t408
        - D_p_y_2_by_l_d_1*t302 - D_p_y_2_by_l_d_1*t303 - D_p_y_2_by_l_d_1*t304 + D_p_y_2_by_l_d_1*t409
        - D_p_z_2_by_l_d_1*t305 - D_p_z_2_by_l_d_1*t306 - D_p_z_2_by_l_d_1*t307 + D_p_z_2_by_l_d_1*t410
        + mu_1_by_l_d_1*t347 + mu_2_by_l_d_1*t348 + mu_3_by_l_d_1*t347,
        D_delta_x_2_by_l_d_1*t349 + D_delta_y_2_by_l_d_1*t350 + D_delta_z_2_by_l_d_1*t351
        - D_p_x_2_by_l_d_1*t313 - D_p_x_2_by_l_d_1*t314 - D_p_x_2_by_l_d_1*t315 + D_p_x_2_by_l_d_1*t411
        - D_p_y_2_by_l_d_1*t316 - D_p_y_2_by_l_d_1*t317 - D_p_y_2_by_l_d_1*t318 + D_p_y_2_by_l_d_1*t412
        - D_p_z_2_by_l_d_1*t319 - D_p_z_2_by_l_d_1*t320 - D_p_z_2_by_l_d_1*t321 + D_p_z_2_by_l_d_1*t413
        + mu_1_by_l_d_1*t352 + mu_2_by_l_d_1*t353 + mu_3_by_l_d_1*t352,
        D_delta_x_3_by_l_d_1*t349 + D_delta_y_3_by_l_d_1*t350 + D_delta_z_3_by_l_d_1*t351
        - D_p_x_2_by_l_d_1*t324 - D_p_x_2_by_l_d_1*t325 - D_p_x_2_by_l_d_1*t326 + D_p_x_2_by_l_d_1*t414
        - D_p_y_2_by_l_d_1*t327 - D_p_y_2_by_l_d_1*t328 - D_p_y_2_by_l_d_1*t329 + D_p_y_2_by_l_d_1*t415
        - D_p_z_2_by_l_d_1*t330 - D_p_z_2_by_l_d_1*t331 - D_p_z_2_by_l_d_1*t332 + D_p_z_2_by_l_d_1*t416
        + mu_1_by_l_d_1*t354 + mu_2_by_l_d_1*t355 + mu_3_by_l_d_1*t354,
        D_p_x_2_by_l_d_1*k_C, D_p_y_2_by_l_d_1*k_C, D_p_z_2_by_l_d_1*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_1*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_1*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_1*k_C
        + mu_1_by_l_d_1*t359 + mu_2_by_l_d_1*t359 + mu_3_by_l_d_1*t360 - t281*t551 - t282*t551 - t283*t551
        - t284*t552 - t285*t552 - t286*t552 - t287*t553 - t288*t553 - t289*t553,
        D_delta_x_1_by_l_d_1*t366 + D_delta_y_1_by_l_d_1*t367 + D_delta_z_1_by_l_d_1*t368
        - D_p_x_3_by_l_d_1*t299 - D_p_x_3_by_l_d_1*t300 - D_p_x_3_by_l_d_1*t301 + D_p_x_3_by_l_d_1*t408
        - D_p_y_3_by_l_d_1*t302 - D_p_y_3_by_l_d_1*t303 - D_p_y_3_by_l_d_1*t304 + D_p_y_3_by_l_d_1*t409
        - D_p_z_3_by_l_d_1*t305 - D_p_z_3_by_l_d_1*t306 - D_p_z_3_by_l_d_1*t307 + D_p_z_3_by_l_d_1*t410
        + mu_1_by_l_d_1*t364 + mu_2_by_l_d_1*t364 + mu_3_by_l_d_1*t365,
        D_delta_x_2_by_l_d_1*t366 + D_delta_y_2_by_l_d_1*t367 + D_delta_z_2_by_l_d_1*t368
        - D_p_x_3_by_l_d_1*t313 - D_p_x_3_by_l_d_1*t314 - D_p_x_3_by_l_d_1*t315 + D_p_x_3_by_l_d_1*t411
        - D_p_y_3_by_l_d_1*t316 - D_p_y_3_by_l_d_1*t317 - D_p_y_3_by_l_d_1*t318 + D_p_y_3_by_l_d_1*t412
        - D_p_z_3_by_l_d_1*t319 - D_p_z_3_by_l_d_1*t320 - D_p_z_3_by_l_d_1*t321 + D_p_z_3_by_l_d_1*t413
        + mu_1_by_l_d_1*t369 + mu_2_by_l_d_1*t369 + mu_3_by_l_d_1*t370,
        D_delta_x_3_by_l_d_1*t366 + D_delta_y_3_by_l_d_1*t367 + D_delta_z_3_by_l_d_1*t368
        - D_p_x_3_by_l_d_1*t324 - D_p_x_3_by_l_d_1*t325 - D_p_x_3_by_l_d_1*t326 + D_p_x_3_by_l_d_1*t414
        - D_p_y_3_by_l_d_1*t327 - D_p_y_3_by_l_d_1*t328 - D_p_y_3_by_l_d_1*t329 + D_p_y_3_by_l_d_1*t415
        - D_p_z_3_by_l_d_1*t330 - D_p_z_3_by_l_d_1*t331 - D_p_z_3_by_l_d_1*t332 + D_p_z_3_by_l_d_1*t416
        + mu_1_by_l_d_1*t371 + mu_2_by_l_d_1*t371 + mu_3_by_l_d_1*t372,
        D_p_x_3_by_l_d_1*k_C, D_p_y_3_by_l_d_1*k_C, D_p_z_3_by_l_d_1*k_C, t185*t544, t545, -t185*t543, t546,
        D_delta_x_1_by_l_d_1*t374 + D_delta_y_1_by_l_d_1*t375 + D_delta_z_1_by_l_d_1*t376
        + mu_1_by_l_d_1*t377 - mu_2_by_l_d_1*t373 - mu_3_by_l_d_1*t373,
        D_delta_x_1_by_l_d_1*t379 + D_delta_x_2_by_l_d_1*t380 + D_delta_y_1_by_l_d_1*t381
        + D_delta_y_2_by_l_d_1*t382 + D_delta_z_1_by_l_d_1*t383 + D_delta_z_2_by_l_d_1*t384
        + mu_1_by_l_d_1*t378 + mu_2_by_l_d_1*t378 + mu_3_by_l_d_1*t378,
        D_delta_x_1_by_l_d_1*t386 + D_delta_x_3_by_l_d_1*t380 + D_delta_y_1_by_l_d_1*t387
        + D_delta_y_3_by_l_d_1*t382 + D_delta_z_1_by_l_d_1*t388 + D_delta_z_3_by_l_d_1*t384
        + mu_1_by_l_d_1*t385 + mu_2_by_l_d_1*t385 + mu_3_by_l_d_1*t385,
        D_delta_x_1_by_l_d_1*k_C, D_delta_y_1_by_l_d_1*k_C, D_delta_z_1_by_l_d_1*k_C,
        D_delta_x_2_by_l_d_1*t390 + D_delta_y_2_by_l_d_1*t391 + D_delta_z_2_by_l_d_1*t392
        - mu_1_by_l_d_1*t389 + mu_2_by_l_d_1*t393 - mu_3_by_l_d_1*t389,
        D_delta_x_2_by_l_d_1*t386 + D_delta_x_3_by_l_d_1*t379 + D_delta_y_2_by_l_d_1*t387
        + D_delta_y_3_by_l_d_1*t381 + D_delta_z_2_by_l_d_1*t388 + D_delta_z_3_by_l_d_1*t383
        + mu_1_by_l_d_1*t394 + mu_2_by_l_d_1*t394 + mu_3_by_l_d_1*t394,
        D_delta_x_2_by_l_d_1*k_C, D_delta_y_2_by_l_d_1*k_C, D_delta_z_2_by_l_d_1*k_C,
        D_delta_x_3_by_l_d_1*t396 + D_delta_y_3_by_l_d_1*t397 + D_delta_z_3_by_l_d_1*t398
        - mu_1_by_l_d_1*t395 - mu_2_by_l_d_1*t395 + mu_3_by_l_d_1*t399,
        D_delta_x_3_by_l_d_1*k_C, D_delta_y_3_by_l_d_1*k_C, D_delta_z_3_by_l_d_1*k_C, t547,
        2*D_p_x_1*D_p_x_1_by_l_d_2*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_2*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_2*k_C
        + mu_1_by_l_d_2*t266 + mu_2_by_l_d_2*t267 + mu_3_by_l_d_2*t267 - t248*t554 - t250*t554 - t251*t554
        - t252*t555 - t254*t555 - t255*t555 - t256*t556 - t258*t556 - t259*t556,
        D_p_x_1*D_p_x_2_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_2*k_C - D_p_x_1_by_l_d_2*t269
        - D_p_x_1_by_l_d_2*t270 - D_p_x_1_by_l_d_2*t271 - D_p_x_2_by_l_d_2*t248 - D_p_x_2_by_l_d_2*t250
        - D_p_x_2_by_l_d_2*t251 + D_p_y_1*D_p_y_2_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_2*k_C
        - D_p_y_1_by_l_d_2*t272 - D_p_y_1_by_l_d_2*t273 - D_p_y_1_by_l_d_2*t274 - D_p_y_2_by_l_d_2*t252
        - D_p_y_2_by_l_d_2*t254 - D_p_y_2_by_l_d_2*t255 + D_p_z_1*D_p_z_2_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_2*k_C - D_p_z_1_by_l_d_2*t275 - D_p_z_1_by_l_d_2*t276
        - D_p_z_1_by_l_d_2*t277 - D_p_z_2_by_l_d_2*t256 - D_p_z_2_by_l_d_2*t258 - D_p_z_2_by_l_d_2*t259
        + mu_1_by_l_d_2*t278 + mu_2_by_l_d_2*t279 + mu_3_by_l_d_2*t280,
        D_p_x_1*D_p_x_3_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_3*k_C - D_p_x_1_by_l_d_2*t281
        - D_p_x_1_by_l_d_2*t282 - D_p_x_1_by_l_d_2*t283 - D_p_x_3_by_l_d_2*t248 - D_p_x_3_by_l_d_2*t250
        - D_p_x_3_by_l_d_2*t251 + D_p_y_1*D_p_y_3_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_3*k_C
        - D_p_y_1_by_l_d_2*t284 - D_p_y_1_by_l_d_2*t285 - D_p_y_1_by_l_d_2*t286 - D_p_y_3_by_l_d_2*t252
        - D_p_y_3_by_l_d_2*t254 - D_p_y_3_by_l_d_2*t255 + D_p_z_1*D_p_z_3_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_3*k_C - D_p_z_1_by_l_d_2*t287 - D_p_z_1_by_l_d_2*t288
        - D_p_z_1_by_l_d_2*t289 - D_p_z_3_by_l_d_2*t256 - D_p_z_3_by_l_d_2*t258 - D_p_z_3_by_l_d_2*t259
        + mu_1_by_l_d_2*t290 + mu_2_by_l_d_2*t291 + mu_3_by_l_d_2*t292,
        D_delta_x_1_by_l_d_2*t310 + D_delta_y_1_by_l_d_2*t311 + D_delta_z_1_by_l_d_2*t312
        - D_p_x_1_by_l_d_2*t299 - D_p_x_1_by_l_d_2*t300 - D_p_x_1_by_l_d_2*t301 + D_p_x_1_by_l_d_2*t408
        - D_p_y_1_by_l_d_2*t302 - D_p_y_1_by_l_d_2*t303 - D_p_y_1_by_l_d_2*t304 + D_p_y_1_by_l_d_2*t409
        - D_p_z_1_by_l_d_2*t305 - D_p_z_1_by_l_d_2*t306 - D_p_z_1_by_l_d_2*t307 + D_p_z_1_by_l_d_2*t410
        + mu_1_by_l_d_2*t308 + mu_2_by_l_d_2*t309 + mu_3_by_l_d_2*t309,
        D_delta_x_2_by_l_d_2*t310 + D_delta_y_2_by_l_d_2*t311 + D_delta_z_2_by_l_d_2*t312
        - D_p_x_1_by_l_d_2*t313 - D_p_x_1_by_l_d_2*t314 - D_p_x_1_by_l_d_2*t315 + D_p_x_1_by_l_d_2*t411
        - D_p_y_1_by_l_d_2*t316 - D_p_y_1_by_l_d_2*t317 - D_p_y_1_by_l_d_2*t318 + D_p_y_1_by_l_d_2*t412
        - D_p_z_1_by_l_d_2*t319 - D_p_z_1_by_l_d_2*t320 - D_p_z_1_by_l_d_2*t321 + D_p_z_1_by_l_d_2*t413
        + mu_1_by_l_d_2*t322 + mu_2_by_l_d_2*t323 + mu_3_by_l_d_2*t323,
        D_delta_x_3_by_l_d_2*t310 + D_delta_y_3_by_l_d_2*t311 + D_delta_z_3_by_l_d_2*t312
        - D_p_x_1_by_l_d_2*t324 - D_p_x_1_by_l_d_2*t325 - D_p_x_1_by_l_d_2*t326 + D_p_x_1_by_l_d_2*t414
        - D_p_y_1_by_l_d_2*t327 - D_p_y_1_by_l_d_2*t328 - D_p_y_1_by_l_d_2*t329 + D_p_y_1_by_l_d_2*t415
        - D_p_z_1_by_l_d_2*t330 - D_p_z_1_by_l_d_2*t331 - D_p_z_1_by_l_d_2*t332 + D_p_z_1_by_l_d_2*t416
        + mu_1_by_l_d_2*t333 + mu_2_by_l_d_2*t334 + mu_3_by_l_d_2*t334,
        D_p_x_1_by_l_d_2*k_C, D_p_y_1_by_l_d_2*k_C, D_p_z_1_by_l_d_2*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_2*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_2*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_2*k_C
        + k_sp_2*t445*t451*w_b_2*x_2_by_l_d_2 + mu_1_by_l_d_2*t339 + mu_2_by_l_d_2*t340
        + mu_3_by_l_d_2*t339 - t269*t557 - t270*t557 - t271*t557 - t272*t558 - t273*t558 - t274*t558
        - t275*t559 - t276*t559 - t277*t559 - t561,
        D_p_x_2*D_p_x_3_by_l_d_2*k_C + D_p_x_2_by_l_d_2*D_p_x_3*k_C - D_p_x_2_by_l_d_2*t281
        - D_p_x_2_by_l_d_2*t282 - D_p_x_2_by_l_d_2*t283 - D_p_x_3_by_l_d_2*t269 - D_p_x_3_by_l_d_2*t270
        - D_p_x_3_by_l_d_2*t271 + D_p_y_2*D_p_y_3_by_l_d_2*k_C + D_p_y_2_by_l_d_2*D_p_y_3*k_C
        - D_p_y_2_by_l_d_2*t284 - D_p_y_2_by_l_d_2*t285 - D_p_y_2_by_l_d_2*t286 - D_p_y_3_by_l_d_2*t272
        - D_p_y_3_by_l_d_2*t273 - D_p_y_3_by_l_d_2*t274 + D_p_z_2*D_p_z_3_by_l_d_2*k_C
        + D_p_z_2_by_l_d_2*D_p_z_3*k_C - D_p_z_2_by_l_d_2*t287 - D_p_z_2_by_l_d_2*t288
        - D_p_z_2_by_l_d_2*t289 - D_p_z_3_by_l_d_2*t275 - D_p_z_3_by_l_d_2*t276 - D_p_z_3_by_l_d_2*t277
        + mu_1_by_l_d_2*t341 + mu_2_by_l_d_2*t342 + mu_3_by_l_d_2*t343,
        t563, t564,
        D_delta_x_1_by_l_d_2*t349 + D_delta_y_1_by_l_d_2*t350 + D_delta_z_1_by_l_d_2*t351
        - D_p_x_2_by_l_d_2*t299 - D_p_x_2_by_l_d_2*t300 - D_p_x_2_by_l_d_2*t301 + D_p_x_2_by_l_d_2*t408
        - D_p_y_2_by_l_d_2*t302 - D_p_y_2_by_l_d_2*t303 - D_p_y_2_by_l_d_2*t304 + D_p_y_2_by_l_d_2*t409
        - D_p_z_2_by_l_d_2*t305 - D_p_z_2_by_l_d_2*t306 - D_p_z_2_by_l_d_2*t307 + D_p_z_2_by_l_d_2*t410
        + mu_1_by_l_d_2*t347 + mu_2_by_l_d_2*t348 + mu_3_by_l_d_2*t347,
        D_delta_x_2_by_l_d_2*t349 + D_delta_y_2_by_l_d_2*t350 + D_delta_z_2_by_l_d_2*t351
        - D_p_x_2_by_l_d_2*t313 - D_p_x_2_by_l_d_2*t314 - D_p_x_2_by_l_d_2*t315 + D_p_x_2_by_l_d_2*t411
        - D_p_y_2_by_l_d_2*t316 - D_p_y_2_by_l_d_2*t317 - D_p_y_2_by_l_d_2*t318 + D_p_y_2_by_l_d_2*t412
        - D_p_z_2_by_l_d_2*t319 - D_p_z_2_by_l_d_2*t320 - D_p_z_2_by_l_d_2*t321 + D_p_z_2_by_l_d_2*t413
        + mu_1_by_l_d_2*t352 + mu_2_by_l_d_2*t353 + mu_3_by_l_d_2*t352,
        D_delta_x_3_by_l_d_2*t349 + D_delta_y_3_by_l_d_2*t350 + D_delta_z_3_by_l_d_2*t351
        - D_p_x_2_by_l_d_2*t324 - D_p_x_2_by_l_d_2*t325 - D_p_x_2_by_l_d_2*t326 + D_p_x_2_by_l_d_2*t414
        - D_p_y_2_by_l_d_2*t327 - D_p_y_2_by_l_d_2*t328 - D_p_y_2_by_l_d_2*t329 + D_p_y_2_by_l_d_2*t415
        - D_p_z_2_by_l_d_2*t330 - D_p_z_2_by_l_d_2*t331 - D_p_z_2_by_l_d_2*t332 + D_p_z_2_by_l_d_2*t416
        + mu_1_by_l_d_2*t354 + mu_2_by_l_d_2*t355 + mu_3_by_l_d_2*t354,
        t565, D_p_x_2_by_l_d_2*k_C, D_p_y_2_by_l_d_2*k_C, D_p_z_2_by_l_d_2*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_2*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_2*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_2*k_C
        + mu_1_by_l_d_2*t359 + mu_2_by_l_d_2*t359 + mu_3_by_l_d_2*t360 - t281*t566 - t282*t566 - t283*t566
        - t284*t567 - t285*t567 - t286*t567 - t287*t568 - t288*t568 - t289*t568,
        D_delta_x_1_by_l_d_2*t366 + D_delta_y_1_by_l_d_2*t367 + D_delta_z_1_by_l_d_2*t368
        - D_p_x_3_by_l_d_2*t299 - D_p_x_3_by_l_d_2*t300 - D_p_x_3_by_l_d_2*t301 + D_p_x_3_by_l_d_2*t408
        - D_p_y_3_by_l_d_2*t302 - D_p_y_3_by_l_d_2*t303 - D_p_y_3_by_l_d_2*t304 + D_p_y_3_by_l_d_2*t409
        - D_p_z_3_by_l_d_2*t305 - D_p_z_3_by_l_d_2*t306 - D_p_z_3_by_l_d_2*t307 + D_p_z_3_by_l_d_2*t410
        + mu_1_by_l_d_2*t364 + mu_2_by_l_d_2*t364 + mu_3_by_l_d_2*t365,
        D_delta_x_2_by_l_d_2*t366 + D_delta_y_2_by_l_d_2*t367 + D_delta_z_2_by_l_d_2*t368
        - D_p_x_3_by_l_d_2*t313 - D_p_x_3_by_l_d_2*t314 - D_p_x_3_by_l_d_2*t315 + D_p_x_3_by_l_d_2*t411
        - D_p_y_3_by_l_d_2*t316 - D_p_y_3_by_l_d_2*t317 - D_p_y_3_by_l_d_2*t318 + D_p_y_3_by_l_d_2*t412
        - D_p_z_3_by_l_d_2*t319 - D_p_z_3_by_l_d_2*t320 - D_p_z_3_by_l_d_2*t321 + D_p_z_3_by_l_d_2*t413
        + mu_1_by_l_d_2*t369 + mu_2_by_l_d_2*t369 + mu_3_by_l_d_2*t370,
        D_delta_x_3_by_l_d_2*t366 + D_delta_y_3_by_l_d_2*t367 + D_delta_z_3_by_l_d_2*t368
        - D_p_x_3_by_l_d_2*t324 - D_p_x_3_by_l_d_2*t325 - D_p_x_3_by_l_d_2*t326 + D_p_x_3_by_l_d_2*t414
        - D_p_y_3_by_l_d_2*t327 - D_p_y_3_by_l_d_2*t328 - D_p_y_3_by_l_d_2*t329 + D_p_y_3_by_l_d_2*t415
        - D_p_z_3_by_l_d_2*t330 - D_p_z_3_by_l_d_2*t331 - D_p_z_3_by_l_d_2*t332 + D_p_z_3_by_l_d_2*t416
        + mu_1_by_l_d_2*t371 + mu_2_by_l_d_2*t371 + mu_3_by_l_d_2*t372,
        D_p_x_3_by_l_d_2*k_C, D_p_y_3_by_l_d_2*k_C, D_p_z_3_by_l_d_2*k_C, t218*t562, t563, -t218*t561, t564,
        D_delta_x_1_by_l_d_2*t374 + D_delta_y_1_by_l_d_2*t375 + D_delta_z_1_by_l_d_2*t376
        + mu_1_by_l_d_2*t377 - mu_2_by_l_d_2*t373 - mu_3_by_l_d_2*t373,
        D_delta_x_1_by_l_d_2*t379 + D_delta_x_2_by_l_d_2*t380 + D_delta_y_1_by_l_d_2*t381
        + D_delta_y_2_by_l_d_2*t382 + D_delta_z_1_by_l_d_2*t383 + D_delta_z_2_by_l_d_2*t384
        + mu_1_by_l_d_2*t378 + mu_2_by_l_d_2*t378 + mu_3_by_l_d_2*t378,
        D_delta_x_1_by_l_d_2*t386 + D_delta_x_3_by_l_d_2*t380 + D_delta_y_1_by_l_d_2*t387
        + D_delta_y_3_by_l_d_2*t382 + D_delta_z_1_by_l_d_2*t388 + D_delta_z_3_by_l_d_2*t384
        + mu_1_by_l_d_2*t385 + mu_2_by_l_d_2*t385 + mu_3_by_l_d_2*t385,
        D_delta_x_1_by_l_d_2*k_C, D_delta_y_1_by_l_d_2*k_C, D_delta_z_1_by_l_d_2*k_C,
        D_delta_x_2_by_l_d_2*t390 + D_delta_y_2_by_l_d_2*t391 + D_delta_z_2_by_l_d_2*t392
        - mu_1_by_l_d_2*t389 + mu_2_by_l_d_2*t393 - mu_3_by_l_d_2*t389,
        D_delta_x_2_by_l_d_2*t386 + D_delta_x_3_by_l_d_2*t379 + D_delta_y_2_by_l_d_2*t387
        + D_delta_y_3_by_l_d_2*t381 + D_delta_z_2_by_l_d_2*t388 + D_delta_z_3_by_l_d_2*t383
        + mu_1_by_l_d_2*t394 + mu_2_by_l_d_2*t394 + mu_3_by_l_d_2*t394,
        D_delta_x_2_by_l_d_2*k_C, D_delta_y_2_by_l_d_2*k_C, D_delta_z_2_by_l_d_2*k_C,
        D_delta_x_3_by_l_d_2*t396 + D_delta_y_3_by_l_d_2*t397 + D_delta_z_3_by_l_d_2*t398
        - mu_1_by_l_d_2*t395 - mu_2_by_l_d_2*t395 + mu_3_by_l_d_2*t399,
        D_delta_x_3_by_l_d_2*k_C, D_delta_y_3_by_l_d_2*k_C, D_delta_z_3_by_l_d_2*k_C, t565,
        2*D_p_x_1*D_p_x_1_by_l_d_3*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_3*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_3*k_C
        + mu_1_by_l_d_3*t266 + mu_2_by_l_d_3*t267 + mu_3_by_l_d_3*t267 - t248*t569 - t250*t569 - t251*t569
        - t252*t570 - t254*t570 - t255*t570 - t256*t571 - t258*t571 - t259*t571,
        D_p_x_1*D_p_x_2_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_2*k_C - D_p_x_1_by_l_d_3*t269
        - D_p_x_1_by_l_d_3*t270 - D_p_x_1_by_l_d_3*t271 - D_p_x_2_by_l_d_3*t248 - D_p_x_2_by_l_d_3*t250
        - D_p_x_2_by_l_d_3*t251 + D_p_y_1*D_p_y_2_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_2*k_C
        - D_p_y_1_by_l_d_3*t272 - D_p_y_1_by_l_d_3*t273 - D_p_y_1_by_l_d_3*t274 - D_p_y_2_by_l_d_3*t252
        - D_p_y_2_by_l_d_3*t254 - D_p_y_2_by_l_d_3*t255 + D_p_z_1*D_p_z_2_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_2*k_C - D_p_z_1_by_l_d_3*t275 - D_p_z_1_by_l_d_3*t276
        - D_p_z_1_by_l_d_3*t277 - D_p_z_2_by_l_d_3*t256 - D_p_z_2_by_l_d_3*t258 - D_p_z_2_by_l_d_3*t259
        + mu_1_by_l_d_3*t278 + mu_2_by_l_d_3*t279 + mu_3_by_l_d_3*t280,
        D_p_x_1*D_p_x_3_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_3*k_C - D_p_x_1_by_l_d_3*t281
        - D_p_x_1_by_l_d_3*t282 - D_p_x_1_by_l_d_3*t283 - D_p_x_3_by_l_d_3*t248 - D_p_x_3_by_l_d_3*t250
        - D_p_x_3_by_l_d_3*t251 + D_p_y_1*D_p_y_3_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_3*k_C
        - D_p_y_1_by_l_d_3*t284 - D_p_y_1_by_l_d_3*t285 - D_p_y_1_by_l_d_3*t286 - D_p_y_3_by_l_d_3*t252
        - D_p_y_3_by_l_d_3*t254 - D_p_y_3_by_l_d_3*t255 + D_p_z_1*D_p_z_3_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_3*k_C - D_p_z_1_by_l_d_3*t287 - D_p_z_1_by_l_d_3*t288
        - D_p_z_1_by_l_d_3*t289 - D_p_z_3_by_l_d_3*t256 - D_p_z_3_by_l_d_3*t258 - D_p_z_3_by_l_d_3*t259
        + mu_1_by_l_d_3*t290 + mu_2_by_l_d_3*t291 + mu_3_by_l_d_3*t292,
        D_delta_x_1_by_l_d_3*t310 + D_delta_y_1_by_l_d_3*t311 + D_delta_z_1_by_l_d_3*t312
        - D_p_x_1_by_l_d_3*t299 - D_p_x_1_by_l_d_3*t300 - D_p_x_1_by_l_d_3*t301 + D_p_x_1_by_l_d_3*t408
        - D_p_y_1_by_l_d_3*t302 - D_p_y_1_by_l_d_3*t303 - D_p_y_1_by_l_d_3*t304 + D_p_y_1_by_l_d_3*t409
        - D_p_z_1_by_l_d_3*t305 - D_p_z_1_by_l_d_3*t306 - D_p_z_1_by_l_d_3*t307 + D_p_z_1_by_l_d_3*t410
        + mu_1_by_l_d_3*t308 + mu_2_by_l_d_3*t309 + mu_3_by_l_d_3*t309,
        D_delta_x_2_by_l_d_3*t310 + D_delta_y_2_by_l_d_3*t311 + D_delta_z_2_by_l_d_3*t312
        - D_p_x_1_by_l_d_3*t313 - D_p_x_1_by_l_d_3*t314 - D_p_x_1_by_l_d_3*t315 + D_p_x_1_by_l_d_3*t411
        - D_p_y_1_by_l_d_3*t316 - D_p_y_1_by_l_d_3*t317 - D_p_y_1_by_l_d_3*t318 + D_p_y_1_by_l_d_3*t412
        - D_p_z_1_by_l_d_3*t319 - D_p_z_1_by_l_d_3*t320 - D_p_z_1_by_l_d_3*t321 + D_p_z_1_by_l_d_3*t413
        + mu_1_by_l_d_3*t322 + mu_2_by_l_d_3*t323 + mu_3_by_l_d_3*t323,
        D_delta_x_3_by_l_d_3*t310 + D_delta_y_3_by_l_d_3*t311 + D_delta_z_3_by_l_d_3*t312
        - D_p_x_1_by_l_d_3*t324 - D_p_x_1_by_l_d_3*t325 - D_p_x_1_by_l_d_3*t326 + D_p_x_1_by_l_d_3*t414
        - D_p_y_1_by_l_d_3*t327 - D_p_y_1_by_l_d_3*t328 - D_p_y_1_by_l_d_3*t329 + D_p_y_1_by_l_d_3*t415
        - D_p_z_1_by_l_d_3*t330 - D_p_z_1_by_l_d_3*t331 - D_p_z_1_by_l_d_3*t332 + D_p_z_1_by_l_d_3*t416
        + mu_1_by_l_d_3*t333 + mu_2_by_l_d_3*t334 + mu_3_by_l_d_3*t334,
        D_p_x_1_by_l_d_3*k_C, D_p_y_1_by_l_d_3*k_C, D_p_z_1_by_l_d_3*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_3*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_3*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_3*k_C
        + mu_1_by_l_d_3*t339 + mu_2_by_l_d_3*t340 + mu_3_by_l_d_3*t339 - t269*t572 - t270*t572 - t271*t572
        - t272*t573 - t273*t573 - t274*t573 - t275*t574 - t276*t574 - t277*t574,
        D_p_x_2*D_p_x_3_by_l_d_3*k_C + D_p_x_2_by_l_d_3*D_p_x_3*k_C - D_p_x_2_by_l_d_3*t281
        - D_p_x_2_by_l_d_3*t282 - D_p_x_2_by_l_d_3*t283 - D_p_x_3_by_l_d_3*t269 - D_p_x_3_by_l_d_3*t270
        - D_p_x_3_by_l_d_3*t271 + D_p_y_2*D_p_y_3_by_l_d_3*k_C + D_p_y_2_by_l_d_3*D_p_y_3*k_C
        - D_p_y_2_by_l_d_3*t284 - D_p_y_2_by_l_d_3*t285 - D_p_y_2_by_l_d_3*t286 - D_p_y_3_by_l_d_3*t272
        - D_p_y_3_by_l_d_3*t273 - D_p_y_3_by_l_d_3*t274 + D_p_z_2*D_p_z_3_by_l_d_3*k_C
        + D_p_z_2_by_l_d_3*D_p_z_3*k_C - D_p_z_2_by_l_d_3*t287 - D_p_z_2_by_l_d_3*t288
        - D_p_z_2_by_l_d_3*t289 - D_p_z_3_by_l_d_3*t275 - D_p_z_3_by_l_d_3*t276 - D_p_z_3_by_l_d_3*t277
        + mu_1_by_l_d_3*t341 + mu_2_by_l_d_3*t342 + mu_3_by_l_d_3*t343,
        D_delta_x_1_by_l_d_3*t349 + D_delta_y_1_by_l_d_3*t350 + D_delta_z_1_by_l_d_3*t351
        - D_p_x_2_by_l_d_3*t299 - D_p_x_2_by_l_d_3*t300 - D_p_x_2_by_l_d_3*t301 + D_p_x_2_by_l_d_3*t408
        - D_p_y_2_by_l_d_3*t302 - D_p_y_2_by_l_d_3*t303 - D_p_y_2_by_l_d_3*t304 + D_p_y_2_by_l_d_3*t409
        - D_p_z_2_by_l_d_3*t305 - D_p_z_2_by_l_d_3*t306 - D_p_z_2_by_l_d_3*t307 + D_p_z_2_by_l_d_3*t410
        + mu_1_by_l_d_3*t347 + mu_2_by_l_d_3*t348 + mu_3_by_l_d_3*t347,
        D_delta_x_2_by_l_d_3*t349 + D_delta_y_2_by_l_d_3*t350 + D_delta_z_2_by_l_d_3*t351
        - D_p_x_2_by_l_d_3*t313 - D_p_x_2_by_l_d_3*t314 - D_p_x_2_by_l_d_3*t315 + D_p_x_2_by_l_d_3*t411
        - D_p_y_2_by_l_d_3*t316 - D_p_y_2_by_l_d_3*t317 - D_p_y_2_by_l_d_3*t318 + D_p_y_2_by_l_d_3*t412
        - D_p_z_2_by_l_d_3*t319 - D_p_z_2_by_l_d_3*t320 - D_p_z_2_by_l_d_3*t321 + D_p_z_2_by_l_d_3*t413
        + mu_1_by_l_d_3*t352 + mu_2_by_l_d_3*t353 + mu_3_by_l_d_3*t352,
        D_delta_x_3_by_l_d_3*t349 + D_delta_y_3_by_l_d_3*t350 + D_delta_z_3_by_l_d_3*t351
        - D_p_x_2_by_l_d_3*t324 - D_p_x_2_by_l_d_3*t325 - D_p_x_2_by_l_d_3*t326 + D_p_x_2_by_l_d_3*t414
        - D_p_y_2_by_l_d_3*t327 - D_p_y_2_by_l_d_3*t328 - D_p_y_2_by_l_d_3*t329 + D_p_y_2_by_l_d_3*t415
        - D_p_z_2_by_l_d_3*t330 - D_p_z_2_by_l_d_3*t331 - D_p_z_2_by_l_d_3*t332 + D_p_z_2_by_l_d_3*t416
        + mu_1_by_l_d_3*t354 + mu_2_by_l_d_3*t355 + mu_3_by_l_d_3*t354,
        D_p_x_2_by_l_d_3*k_C, D_p_y_2_by_l_d_3*k_C, D_p_z_2_by_l_d_3*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_3*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_3*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_3*k_C
        + k_sp_3*t498*t504*w_b_3*x_3_by_l_d_3 + mu_1_by_l_d_3*t359 + mu_2_by_l_d_3*t359
        + mu_3_by_l_d_3*t360 - t281*t575 - t282*t575 - t283*t575 - t284*t576 - t285*t576 - t286*t576
        - t287*t577 - t288*t577 - t289*t577 - t579,
        t581, t582,
        D_delta_x_1_by_l_d_3*t366 + D_delta_y_1_by_l_d_3*t367 + D_delta_z_1_by_l_d_3*t368
        - D_p_x_3_by_l_d_3*t299 - D_p_x_3_by_l_d_3*t300 - D_p_x_3_by_l_d_3*t301 + D_p_x_3_by_l_d_3*t408
        - D_p_y_3_by_l_d_3*t302 - D_p_y_3_by_l_d_3*t303 - D_p_y_3_by_l_d_3*t304 + D_p_y_3_by_l_d_3*t409
        - D_p_z_3_by_l_d_3*t305 - D_p_z_3_by_l_d_3*t306 - D_p_z_3_by_l_d_3*t307 + D_p_z_3_by_l_d_3*t410
        + mu_1_by_l_d_3*t364 + mu_2_by_l_d_3*t364 + mu_3_by_l_d_3*t365,
        D_delta_x_2_by_l_d_3*t366 + D_delta_y_2_by_l_d_3*t367 + D_delta_z_2_by_l_d_3*t368
        - D_p_x_3_by_l_d_3*t313 - D_p_x_3_by_l_d_3*t314 - D_p_x_3_by_l_d_3*t315 + D_p_x_3_by_l_d_3*t411
        - D_p_y_3_by_l_d_3*t316 - D_p_y_3_by_l_d_3*t317 - D_p_y_3_by_l_d_3*t318 + D_p_y_3_by_l_d_3*t412
        - D_p_z_3_by_l_d_3*t319 - D_p_z_3_by_l_d_3*t320 - D_p_z_3_by_l_d_3*t321 + D_p_z_3_by_l_d_3*t413
        + mu_1_by_l_d_3*t369 + mu_2_by_l_d_3*t369 + mu_3_by_l_d_3*t370,
        D_delta_x_3_by_l_d_3*t366 + D_delta_y_3_by_l_d_3*t367 + D_delta_z_3_by_l_d_3*t368
        - D_p_x_3_by_l_d_3*t324 - D_p_x_3_by_l_d_3*t325 - D_p_x_3_by_l_d_3*t326 + D_p_x_3_by_l_d_3*t414
        - D_p_y_3_by_l_d_3*t327 - D_p_y_3_by_l_d_3*t328 - D_p_y_3_by_l_d_3*t329 + D_p_y_3_by_l_d_3*t415
        - D_p_z_3_by_l_d_3*t330 - D_p_z_3_by_l_d_3*t331 - D_p_z_3_by_l_d_3*t332 + D_p_z_3_by_l_d_3*t416
        + mu_1_by_l_d_3*t371 + mu_2_by_l_d_3*t371 + mu_3_by_l_d_3*t372,
        t583, D_p_x_3_by_l_d_3*k_C, D_p_y_3_by_l_d_3*k_C, D_p_z_3_by_l_d_3*k_C, t230*t580, t581, -t230*t579,
        t582,
        D_delta_x_1_by_l_d_3*t374 + D_delta_y_1_by_l_d_3*t375 + D_delta_z_1_by_l_d_3*t376
        + mu_1_by_l_d_3*t377 - mu_2_by_l_d_3*t373 - mu_3_by_l_d_3*t373,
        D_delta_x_1_by_l_d_3*t379 + D_delta_x_2_by_l_d_3*t380 + D_delta_y_1_by_l_d_3*t381
        + D_delta_y_2_by_l_d_3*t382 + D_delta_z_1_by_l_d_3*t383 + D_delta_z_2_by_l_d_3*t384
        + mu_1_by_l_d_3*t378 + mu_2_by_l_d_3*t378 + mu_3_by_l_d_3*t378,
        D_delta_x_1_by_l_d_3*t386 + D_delta_x_3_by_l_d_3*t380 + D_delta_y_1_by_l_d_3*t387
        + D_delta_y_3_by_l_d_3*t382 + D_delta_z_1_by_l_d_3*t388 + D_delta_z_3_by_l_d_3*t384
        + mu_1_by_l_d_3*t385 + mu_2_by_l_d_3*t385 + mu_3_by_l_d_3*t385,
        D_delta_x_1_by_l_d_3*k_C, D_delta_y_1_by_l_d_3*k_C, D_delta_z_1_by_l_d_3*k_C,
        D_delta_x_2_by_l_d_3*t390 + D_delta_y_2_by_l_d_3*t391 + D_delta_z_2_by_l_d_3*t392
        - mu_1_by_l_d_3*t389 + mu_2_by_l_d_3*t393 - mu_3_by_l_d_3*t389,
        D_delta_x_2_by_l_d_3*t386 + D_delta_x_3_by_l_d_3*t379 + D_delta_y_2_by_l_d_3*t387
        + D_delta_y_3_by_l_d_3*t381 + D_delta_z_2_by_l_d_3*t388 + D_delta_z_3_by_l_d_3*t383
        + mu_1_by_l_d_3*t394 + mu_2_by_l_d_3*t394 + mu_3_by_l_d_3*t394,
        D_delta_x_2_by_l_d_3*k_C, D_delta_y_2_by_l_d_3*k_C, D_delta_z_2_by_l_d_3*k_C,
        D_delta_x_3_by_l_d_3*t396 + D_delta_y_3_by_l_d_3*t397 + D_delta_z_3_by_l_d_3*t398
        - mu_1_by_l_d_3*t395 - mu_2_by_l_d_3*t395 + mu_3_by_l_d_3*t399,
        D_delta_x_3_by_l_d_3*k_C, D_delta_y_3_by_l_d_3*k_C, D_delta_z_3_by_l_d_3*k_C, t583,
    ))
    return M_theta_out, K_theta_out
