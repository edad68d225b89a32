# Generated from the derivation of rotary_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism rotary_delta with effects: extended matrices and sensitivities.

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
* tau_st_j [N m]: static torque on motor j, seen at the arm
* I_j [kg m^2]: moment of inertia of motor j, seen at the arm
* k_j [N m/rad]: stiffness of reducer j
* D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* U_j_i_k [m]: derivative of linkage vector j, component i, with respect to theta_k
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* G_j [N m]: gradient of the gravitational potential energy with respect to theta_j
* phi_j_st [rad]: static angle of motor j divided by the gear ratio, relative to the unstrained transmissions
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

#: Parameters of the derivatives: field of Parameters or Effects, index in it, and (row, column) of the
#: entries of M and of K, in the upper triangle, that depend on it.
VALUE_SENSITIVITIES = (
    ('platform_mass', (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11), (9, 9), (10, 10), (11, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('gravity', (0,), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('gravity', (1,), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('gravity', (2,), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('arm_mass', (0,), ((0, 9), (0, 10), (0, 11), (9, 9), (10, 10), (11, 11)), ((0, 0),)),
    ('arm_mass', (1,), ((1, 9), (1, 10), (1, 11), (9, 9), (10, 10), (11, 11)), ((1, 1),)),
    ('arm_mass', (2,), ((2, 9), (2, 10), (2, 11), (9, 9), (10, 10), (11, 11)), ((2, 2),)),
    ('arm_center', (0,), ((0, 9), (0, 10), (0, 11)), ((0, 0),)),
    ('arm_center', (1,), ((1, 9), (1, 10), (1, 11)), ((1, 1),)),
    ('arm_center', (2,), ((2, 9), (2, 10), (2, 11)), ((2, 2),)),
    ('arm_inertia', (0,), ((0, 0),), ()),
    ('arm_inertia', (1,), ((1, 1),), ()),
    ('arm_inertia', (2,), ((2, 2),), ()),
    ('link_mass', (0,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11), (9, 9), (10, 10), (11, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('link_mass', (1,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11), (9, 9), (10, 10), (11, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('link_mass', (2,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11), (9, 9), (10, 10), (11, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('reducer_stiffness', (0,), (), ((0, 0), (0, 3), (3, 3))),
    ('reducer_stiffness', (1,), (), ((1, 1), (1, 4), (4, 4))),
    ('reducer_stiffness', (2,), (), ((2, 2), (2, 5), (5, 5))),
    ('motor_inertia', (0,), ((3, 3),), ()),
    ('motor_inertia', (1,), ((4, 4),), ()),
    ('motor_inertia', (2,), ((5, 5),), ()),
    ('gear_ratio', (0,), ((3, 3),), ()),
    ('gear_ratio', (1,), ((4, 4),), ()),
    ('gear_ratio', (2,), ((5, 5),), ()),
    ('limits', (0, 0), (), ()),
    ('limits', (0, 1), (), ()),
    ('limits', (1, 0), (), ()),
    ('limits', (1, 1), (), ()),
    ('limits', (2, 0), (), ()),
    ('limits', (2, 1), (), ()),
    ('axis_reducer_stiffness_factor_1', (), (), ((0, 0), (0, 3), (3, 3))),
    ('axis_reducer_stiffness_factor_2', (), (), ((1, 1), (1, 4), (4, 4))),
    ('axis_reducer_stiffness_factor_3', (), (), ((2, 2), (2, 5), (5, 5))),
    ('cable_stiffness_stiffness', (), (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11), (9, 9), (10, 10), (11, 11))),
    ('drive_friction_viscous', (), (), ()),
    ('gearbox_inertia_inertia', (), ((3, 3), (4, 4), (5, 5)), ()),
    ('payload_mass', (),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11), (9, 9), (10, 10), (11, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (1, 1), (1, 2), (1, 6), (1, 7), (1, 8), (2, 2),
      (2, 6), (2, 7), (2, 8), (6, 6), (6, 7), (6, 8), (7, 7), (7, 8), (8, 8))),
    ('reducer_loss_loss_factor', (), (), ()),
    ('servo_stiffness_stiffness', (), (), ((3, 3), (4, 4), (5, 5))),
    ('frame_compliance_mass', (), ((9, 9), (10, 10), (11, 11)), ()),
)

#: The same for `geometry_sensitivities`.
GEOMETRY_SENSITIVITIES = (
    ('joint', (0, 0),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (0, 1),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (0, 2),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (1, 0),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (1, 1),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (1, 2),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (2, 0),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (2, 1),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('joint', (2, 2),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('arm_length', (0,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('arm_length', (1,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('arm_length', (2,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('link_length', (0,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('link_length', (1,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
    ('link_length', (2,),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11)),
     ((0, 0), (0, 1), (0, 2), (0, 6), (0, 7), (0, 8), (0, 9), (0, 10), (0, 11), (1, 1), (1, 2), (1, 6),
      (1, 7), (1, 8), (1, 9), (1, 10), (1, 11), (2, 2), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10),
      (2, 11), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 7), (7, 8), (7, 9), (7, 10),
      (7, 11), (8, 8), (8, 9), (8, 10), (8, 11))),
)


class Effects(NamedTuple):
    """Effects of a robot; every field may have its own leading batch axes.

    Attributes
    ----------
    axis_reducer_stiffness_factor_1 : float or array, shape (...) [1]
        Relative change of the stiffness of reducer 1.
    axis_reducer_stiffness_factor_2 : float or array, shape (...) [1]
        Relative change of the stiffness of reducer 2.
    axis_reducer_stiffness_factor_3 : float or array, shape (...) [1]
        Relative change of the stiffness of reducer 3.
    cable_stiffness_stiffness : float or array, shape (...) [N/m]
        Isotropic stiffness from the platform centre to ground.
    drive_friction_viscous : float or array, shape (...) [N m s/rad]
        Viscous friction of every motor, seen at the driven rotor.
    gearbox_inertia_inertia : float or array, shape (...) [kg m^2]
        Extra inertia on every driven pulley.
    payload_mass : float or array, shape (...) [kg]
        Point mass at the platform centre.
    reducer_loss_loss_factor : float or array, shape (...) [1]
        Loss factor of every reducer, or gearbox that winds up.
    servo_stiffness_stiffness : float or array, shape (...) [N m/rad]
        Torsional stiffness to ground at every motor, seen at the driven rotor.
    link_compliance_compliance : float or array, shape (...) [m/N]
        Axial compliance of every linkage.
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

    axis_reducer_stiffness_factor_1: float = 0.0
    axis_reducer_stiffness_factor_2: float = 0.0
    axis_reducer_stiffness_factor_3: float = 0.0
    cable_stiffness_stiffness: float = 0.0
    drive_friction_viscous: float = 0.0
    gearbox_inertia_inertia: float = 0.0
    payload_mass: float = 0.0
    reducer_loss_loss_factor: float = 0.0
    servo_stiffness_stiffness: float = 0.0
    link_compliance_compliance: float = 0.0
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
    M : array, shape (..., 12, 12) [kg, kg m, kg m^2]
        Mass matrix; its leading block is that of the base model.
    K_el : array, shape (..., 12, 12) [N/m, N, N m]
        Elastic stiffness with free joints.
    K_g : array, shape (..., 12, 12) [N/m, N, N m]
        Hessian of the gravitational potential energy.

    Notes
    -----
    Equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses.
    1282 operations; 10153161 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    I_a_1, I_a_2, I_a_3 = _entries(parameters.arm_inertia, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_R_1,) = _entries(effects.axis_reducer_stiffness_factor_1, ())
    (a_R_2,) = _entries(effects.axis_reducer_stiffness_factor_2, ())
    (a_R_3,) = _entries(effects.axis_reducer_stiffness_factor_3, ())
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (I_G,) = _entries(effects.gearbox_inertia_inertia, ())
    (m_L,) = _entries(effects.payload_mass, ())
    (k_S,) = _entries(effects.servo_stiffness_stiffness, ())
    (m_F,) = _entries(effects.frame_compliance_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, I_a_1, l_d_1, m_d_1,
        k_r_1, I_m_1, i_g_1, sigma_1, a_R_1, a_R_2, a_R_3, k_C, I_G, m_L, k_S, m_F)
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
    t1 = L_a_1**2
    C_1 = (1/2)*(-l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2 + t1)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t2 = 1.0/rho2_1
    c_1 = t2*(A_1*C_1 - B_1*S_1)
    sn_1 = t2*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    t3 = L_a_2**2
    C_2 = (1/2)*(-l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2 + t3)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t4 = 1.0/rho2_2
    c_2 = t4*(A_2*C_2 - B_2*S_2)
    sn_2 = t4*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t5 = L_a_3**2
    C_3 = (1/2)*(-l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2 + t5)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t6 = 1.0/rho2_3
    c_3 = t6*(A_3*C_3 - B_3*S_3)
    sn_3 = t6*(A_3*S_3 + B_3*C_3)
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
    t7 = L_a_1*d_1_x
    s_1_x = r_1_x - t7
    t8 = L_a_1*d_1_y
    s_1_y = r_1_y - t8
    t9 = L_a_1*d_1_z
    s_1_z = r_1_z - t9
    t10 = L_a_2*d_2_x
    s_2_x = r_2_x - t10
    t11 = L_a_2*d_2_y
    s_2_y = r_2_y - t11
    t12 = L_a_2*d_2_z
    s_2_z = r_2_z - t12
    t13 = L_a_3*d_3_x
    s_3_x = r_3_x - t13
    t14 = L_a_3*d_3_y
    s_3_y = r_3_y - t14
    t15 = L_a_3*d_3_z
    s_3_z = r_3_z - t15
    t16 = L_a_1*t_1_x
    t17 = L_a_1*t_1_y
    t18 = L_a_1*t_1_z
    D_r_1 = s_1_x*t16 + s_1_y*t17 + s_1_z*t18
    t19 = L_a_2*t_2_x
    t20 = L_a_2*t_2_y
    t21 = L_a_2*t_2_z
    D_r_2 = s_2_x*t19 + s_2_y*t20 + s_2_z*t21
    t22 = L_a_3*t_3_x
    t23 = L_a_3*t_3_y
    t24 = L_a_3*t_3_z
    D_r_3 = s_3_x*t22 + s_3_y*t23 + s_3_z*t24
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
    t25 = 1.0/det_D_l
    t26 = A_x_1*t25
    D_p_x_1 = D_r_1*t26
    t27 = A_x_2*t25
    D_p_x_2 = D_r_2*t27
    t28 = A_x_3*t25
    D_p_x_3 = D_r_3*t28
    D_delta_x_1 = l_d_1*t26
    D_delta_x_2 = l_d_2*t27
    D_delta_x_3 = l_d_3*t28
    t29 = A_y_1*t25
    D_p_y_1 = D_r_1*t29
    t30 = A_y_2*t25
    D_p_y_2 = D_r_2*t30
    t31 = A_y_3*t25
    D_p_y_3 = D_r_3*t31
    D_delta_y_1 = l_d_1*t29
    D_delta_y_2 = l_d_2*t30
    D_delta_y_3 = l_d_3*t31
    t32 = A_z_1*t25
    D_p_z_1 = D_r_1*t32
    t33 = A_z_2*t25
    D_p_z_2 = D_r_2*t33
    t34 = A_z_3*t25
    D_p_z_3 = D_r_3*t34
    D_delta_z_1 = l_d_1*t32
    D_delta_z_2 = l_d_2*t33
    D_delta_z_3 = l_d_3*t34
    U_1_x_1 = D_p_x_1 - t16
    U_1_y_1 = D_p_y_1 - t17
    U_1_z_1 = D_p_z_1 - t18
    U_2_x_2 = D_p_x_2 - t19
    U_2_y_2 = D_p_y_2 - t20
    U_2_z_2 = D_p_z_2 - t21
    U_3_x_3 = D_p_x_3 - t22
    U_3_y_3 = D_p_y_3 - t23
    U_3_z_3 = D_p_z_3 - t24
    I_1 = I_G + I_m_1*i_g_1**2
    I_2 = I_G + I_m_2*i_g_2**2
    I_3 = I_G + I_m_3*i_g_3**2
    k_1 = k_r_1*(a_R_1 + 1)
    k_2 = k_r_2*(a_R_2 + 1)
    k_3 = k_r_3*(a_R_3 + 1)
    t35 = (1/2)*m_d_1
    t36 = (1/2)*m_d_2
    t37 = (1/2)*m_d_3
    t38 = m_L + m_p
    t39 = t35 + t36 + t37 + t38
    t40 = g_x*t39
    t41 = g_y*t39
    t42 = g_z*t39
    mu_1 = t25*(-A_x_1*t40 - A_y_1*t41 - A_z_1*t42)
    mu_2 = t25*(-A_x_2*t40 - A_y_2*t41 - A_z_2*t42)
    mu_3 = t25*(-A_x_3*t40 - A_y_3*t41 - A_z_3*t42)
    t43 = (1/3)*m_d_1
    t44 = (1/6)*m_d_1
    t45 = t16*t44
    t46 = t17*t44
    t47 = t18*t44
    t48 = (1/3)*m_d_2
    t49 = (1/3)*m_d_3
    t50 = t38 + t43 + t48 + t49
    t51 = D_p_x_1*t50
    t52 = t45 + t51
    t53 = D_p_y_1*t50
    t54 = t46 + t53
    t55 = D_p_z_1*t50
    t56 = t47 + t55
    t57 = (1/6)*m_d_2
    t58 = t19*t57
    t59 = t20*t57
    t60 = t21*t57
    t61 = (1/6)*m_d_3
    t62 = t22*t61
    t63 = t23*t61
    t64 = t24*t61
    t65 = m_a_1*r_a_1
    t66 = t44 + t57 + t61
    t67 = D_p_x_2*t50
    t68 = t58 + t67
    t69 = D_p_y_2*t50
    t70 = t59 + t69
    t71 = D_p_z_2*t50
    t72 = t60 + t71
    t73 = m_a_2*r_a_2
    t74 = D_p_x_3*t50
    t75 = t62 + t74
    t76 = D_p_y_3*t50
    t77 = t63 + t76
    t78 = D_p_z_3*t50
    t79 = t64 + t78
    t80 = m_a_3*r_a_3
    t81 = D_delta_x_1**2
    t82 = D_delta_y_1**2
    t83 = D_delta_z_1**2
    t84 = D_delta_x_1*t50
    t85 = D_delta_y_1*t50
    t86 = D_delta_z_1*t50
    t87 = D_delta_x_2**2
    t88 = D_delta_y_2**2
    t89 = D_delta_z_2**2
    t90 = D_delta_x_2*t50
    t91 = D_delta_y_2*t50
    t92 = D_delta_z_2*t50
    t93 = D_delta_x_3**2
    t94 = D_delta_y_3**2
    t95 = D_delta_z_3**2
    t96 = m_F + m_a_1 + m_a_2 + m_a_3 + m_d_1 + m_d_2 + m_d_3 + t38
    t97 = D_p_x_1**2
    t98 = D_p_y_1**2
    t99 = D_p_z_1**2
    t100 = D_p_y_1*k_C
    t101 = D_p_z_1*k_C
    t102 = D_p_x_1*k_C
    t103 = D_p_x_2**2
    t104 = D_p_y_2**2
    t105 = D_p_z_2**2
    t106 = D_p_x_2*k_C
    t107 = D_p_y_2*k_C
    t108 = D_p_z_2*k_C
    t109 = D_p_x_3**2
    t110 = D_p_y_3**2
    t111 = D_p_z_3**2
    t112 = D_p_x_3*k_C
    t113 = D_p_y_3*k_C
    t114 = D_p_z_3*k_C
    t115 = D_delta_x_1*k_C
    t116 = D_delta_y_1*k_C
    t117 = D_delta_z_1*k_C
    t118 = D_delta_x_2*k_C
    t119 = D_delta_y_2*k_C
    t120 = D_delta_z_2*k_C
    t121 = L_a_1*t35 + t65
    t122 = D_p_x_1*mu_3
    t123 = D_p_x_1*mu_2
    t124 = U_1_x_1*mu_1
    t125 = D_p_y_1*mu_3
    t126 = D_p_y_1*mu_2
    t127 = U_1_y_1*mu_1
    t128 = D_p_z_1*mu_3
    t129 = D_p_z_1*mu_2
    t130 = U_1_z_1*mu_1
    t131 = L_a_2*t36 + t73
    t132 = D_p_x_2*mu_1
    t133 = D_p_x_2*mu_3
    t134 = U_2_x_2*mu_2
    t135 = D_p_y_2*mu_1
    t136 = D_p_y_2*mu_3
    t137 = U_2_y_2*mu_2
    t138 = D_p_z_2*mu_1
    t139 = D_p_z_2*mu_3
    t140 = U_2_z_2*mu_2
    t141 = L_a_3*t37 + t80
    t142 = D_delta_x_1*D_p_x_3
    t143 = U_3_x_3*mu_3
    t144 = D_delta_y_1*D_p_y_3
    t145 = U_3_y_3*mu_3
    t146 = D_delta_z_1*D_p_z_3
    t147 = U_3_z_3*mu_3
    t148 = D_delta_x_2*D_p_x_3
    t149 = D_delta_y_2*D_p_y_3
    t150 = D_delta_z_2*D_p_z_3
    t151 = D_delta_x_3*D_p_x_3
    t152 = D_delta_y_3*D_p_y_3
    t153 = D_delta_z_3*D_p_z_3
    t154 = D_delta_x_1*D_delta_x_2
    t155 = D_delta_y_1*D_delta_y_2
    t156 = D_delta_z_1*D_delta_z_2
    t157 = D_delta_x_1*D_delta_x_3
    t158 = D_delta_y_1*D_delta_y_3
    t159 = D_delta_z_1*D_delta_z_3
    t160 = D_delta_x_2*D_delta_x_3
    t161 = D_delta_y_2*D_delta_y_3
    t162 = D_delta_z_2*D_delta_z_3
    M_out = np.zeros((*batch, 12, 12), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t45 + D_p_x_1*t52 + D_p_y_1*t46 + D_p_y_1*t54 + D_p_z_1*t47 + D_p_z_1*t56 + I_a_1 + t1*t43
    )
    M_out[..., 0, 1] = M_out[..., 1, 0] = (
        D_p_x_1*t58 + D_p_x_2*t52 + D_p_y_1*t59 + D_p_y_2*t54 + D_p_z_1*t60 + D_p_z_2*t56
    )
    M_out[..., 0, 2] = M_out[..., 2, 0] = (
        D_p_x_1*t62 + D_p_x_3*t52 + D_p_y_1*t63 + D_p_y_3*t54 + D_p_z_1*t64 + D_p_z_3*t56
    )
    M_out[..., 0, 6] = M_out[..., 6, 0] = D_delta_x_1*t52 + D_delta_y_1*t54 + D_delta_z_1*t56
    M_out[..., 0, 7] = M_out[..., 7, 0] = D_delta_x_2*t52 + D_delta_y_2*t54 + D_delta_z_2*t56
    M_out[..., 0, 8] = M_out[..., 8, 0] = D_delta_x_3*t52 + D_delta_y_3*t54 + D_delta_z_3*t56
    M_out[..., 0, 9] = M_out[..., 9, 0] = D_p_x_1*t66 + t16*t35 + t51 + t65*t_1_x
    M_out[..., 0, 10] = M_out[..., 10, 0] = D_p_y_1*t66 + t17*t35 + t53 + t65*t_1_y
    M_out[..., 0, 11] = M_out[..., 11, 0] = D_p_z_1*t66 + t18*t35 + t55 + t65*t_1_z
    M_out[..., 1, 1] = (
        D_p_x_2*t58 + D_p_x_2*t68 + D_p_y_2*t59 + D_p_y_2*t70 + D_p_z_2*t60 + D_p_z_2*t72 + I_a_2 + t3*t48
    )
    M_out[..., 1, 2] = M_out[..., 2, 1] = (
        D_p_x_2*t62 + D_p_x_3*t68 + D_p_y_2*t63 + D_p_y_3*t70 + D_p_z_2*t64 + D_p_z_3*t72
    )
    M_out[..., 1, 6] = M_out[..., 6, 1] = D_delta_x_1*t68 + D_delta_y_1*t70 + D_delta_z_1*t72
    M_out[..., 1, 7] = M_out[..., 7, 1] = D_delta_x_2*t68 + D_delta_y_2*t70 + D_delta_z_2*t72
    M_out[..., 1, 8] = M_out[..., 8, 1] = D_delta_x_3*t68 + D_delta_y_3*t70 + D_delta_z_3*t72
    M_out[..., 1, 9] = M_out[..., 9, 1] = D_p_x_2*t66 + t19*t36 + t67 + t73*t_2_x
    M_out[..., 1, 10] = M_out[..., 10, 1] = D_p_y_2*t66 + t20*t36 + t69 + t73*t_2_y
    M_out[..., 1, 11] = M_out[..., 11, 1] = D_p_z_2*t66 + t21*t36 + t71 + t73*t_2_z
    M_out[..., 2, 2] = (
        D_p_x_3*t62 + D_p_x_3*t75 + D_p_y_3*t63 + D_p_y_3*t77 + D_p_z_3*t64 + D_p_z_3*t79 + I_a_3 + t49*t5
    )
    M_out[..., 2, 6] = M_out[..., 6, 2] = D_delta_x_1*t75 + D_delta_y_1*t77 + D_delta_z_1*t79
    M_out[..., 2, 7] = M_out[..., 7, 2] = D_delta_x_2*t75 + D_delta_y_2*t77 + D_delta_z_2*t79
    M_out[..., 2, 8] = M_out[..., 8, 2] = D_delta_x_3*t75 + D_delta_y_3*t77 + D_delta_z_3*t79
    M_out[..., 2, 9] = M_out[..., 9, 2] = D_p_x_3*t66 + t22*t37 + t74 + t80*t_3_x
    M_out[..., 2, 10] = M_out[..., 10, 2] = D_p_y_3*t66 + t23*t37 + t76 + t80*t_3_y
    M_out[..., 2, 11] = M_out[..., 11, 2] = D_p_z_3*t66 + t24*t37 + t78 + t80*t_3_z
    M_out[..., 3, 3] = I_1
    M_out[..., 4, 4] = I_2
    M_out[..., 5, 5] = I_3
    M_out[..., 6, 6] = t50*t81 + t50*t82 + t50*t83
    M_out[..., 6, 7] = M_out[..., 7, 6] = D_delta_x_2*t84 + D_delta_y_2*t85 + D_delta_z_2*t86
    M_out[..., 6, 8] = M_out[..., 8, 6] = D_delta_x_3*t84 + D_delta_y_3*t85 + D_delta_z_3*t86
    M_out[..., 6, 9] = M_out[..., 9, 6] = D_delta_x_1*t66 + t84
    M_out[..., 6, 10] = M_out[..., 10, 6] = D_delta_y_1*t66 + t85
    M_out[..., 6, 11] = M_out[..., 11, 6] = D_delta_z_1*t66 + t86
    M_out[..., 7, 7] = t50*t87 + t50*t88 + t50*t89
    M_out[..., 7, 8] = M_out[..., 8, 7] = D_delta_x_3*t90 + D_delta_y_3*t91 + D_delta_z_3*t92
    M_out[..., 7, 9] = M_out[..., 9, 7] = D_delta_x_2*t66 + t90
    M_out[..., 7, 10] = M_out[..., 10, 7] = D_delta_y_2*t66 + t91
    M_out[..., 7, 11] = M_out[..., 11, 7] = D_delta_z_2*t66 + t92
    M_out[..., 8, 8] = t50*t93 + t50*t94 + t50*t95
    M_out[..., 8, 9] = M_out[..., 9, 8] = D_delta_x_3*t50 + D_delta_x_3*t66
    M_out[..., 8, 10] = M_out[..., 10, 8] = D_delta_y_3*t50 + D_delta_y_3*t66
    M_out[..., 8, 11] = M_out[..., 11, 8] = D_delta_z_3*t50 + D_delta_z_3*t66
    M_out[..., 9, 9] = t96
    M_out[..., 10, 10] = t96
    M_out[..., 11, 11] = t96
    K_el_out = np.zeros((*batch, 12, 12), dtype)
    K_el_out[..., 0, 0] = k_1 + k_C*t97 + k_C*t98 + k_C*t99
    K_el_out[..., 0, 1] = K_el_out[..., 1, 0] = D_p_x_2*t102 + D_p_y_2*t100 + D_p_z_2*t101
    K_el_out[..., 0, 2] = K_el_out[..., 2, 0] = D_p_x_3*t102 + D_p_y_3*t100 + D_p_z_3*t101
    K_el_out[..., 0, 3] = K_el_out[..., 3, 0] = -k_1
    K_el_out[..., 0, 6] = K_el_out[..., 6, 0] = D_delta_x_1*t102 + D_delta_y_1*t100 + D_delta_z_1*t101
    K_el_out[..., 0, 7] = K_el_out[..., 7, 0] = D_delta_x_2*t102 + D_delta_y_2*t100 + D_delta_z_2*t101
    K_el_out[..., 0, 8] = K_el_out[..., 8, 0] = D_delta_x_3*t102 + D_delta_y_3*t100 + D_delta_z_3*t101
    K_el_out[..., 0, 9] = K_el_out[..., 9, 0] = t102
    K_el_out[..., 0, 10] = K_el_out[..., 10, 0] = t100
    K_el_out[..., 0, 11] = K_el_out[..., 11, 0] = t101
    K_el_out[..., 1, 1] = k_2 + k_C*t103 + k_C*t104 + k_C*t105
    K_el_out[..., 1, 2] = K_el_out[..., 2, 1] = D_p_x_3*t106 + D_p_y_3*t107 + D_p_z_3*t108
    K_el_out[..., 1, 4] = K_el_out[..., 4, 1] = -k_2
    K_el_out[..., 1, 6] = K_el_out[..., 6, 1] = D_delta_x_1*t106 + D_delta_y_1*t107 + D_delta_z_1*t108
    K_el_out[..., 1, 7] = K_el_out[..., 7, 1] = D_delta_x_2*t106 + D_delta_y_2*t107 + D_delta_z_2*t108
    K_el_out[..., 1, 8] = K_el_out[..., 8, 1] = D_delta_x_3*t106 + D_delta_y_3*t107 + D_delta_z_3*t108
    K_el_out[..., 1, 9] = K_el_out[..., 9, 1] = t106
    K_el_out[..., 1, 10] = K_el_out[..., 10, 1] = t107
    K_el_out[..., 1, 11] = K_el_out[..., 11, 1] = t108
    K_el_out[..., 2, 2] = k_3 + k_C*t109 + k_C*t110 + k_C*t111
    K_el_out[..., 2, 5] = K_el_out[..., 5, 2] = -k_3
    K_el_out[..., 2, 6] = K_el_out[..., 6, 2] = D_delta_x_1*t112 + D_delta_y_1*t113 + D_delta_z_1*t114
    K_el_out[..., 2, 7] = K_el_out[..., 7, 2] = D_delta_x_2*t112 + D_delta_y_2*t113 + D_delta_z_2*t114
    K_el_out[..., 2, 8] = K_el_out[..., 8, 2] = D_delta_x_3*t112 + D_delta_y_3*t113 + D_delta_z_3*t114
    K_el_out[..., 2, 9] = K_el_out[..., 9, 2] = t112
    K_el_out[..., 2, 10] = K_el_out[..., 10, 2] = t113
    K_el_out[..., 2, 11] = K_el_out[..., 11, 2] = t114
    K_el_out[..., 3, 3] = k_1 + k_S
    K_el_out[..., 4, 4] = k_2 + k_S
    K_el_out[..., 5, 5] = k_3 + k_S
    K_el_out[..., 6, 6] = k_C*t81 + k_C*t82 + k_C*t83
    K_el_out[..., 6, 7] = K_el_out[..., 7, 6] = D_delta_x_2*t115 + D_delta_y_2*t116 + D_delta_z_2*t117
    K_el_out[..., 6, 8] = K_el_out[..., 8, 6] = D_delta_x_3*t115 + D_delta_y_3*t116 + D_delta_z_3*t117
    K_el_out[..., 6, 9] = K_el_out[..., 9, 6] = t115
    K_el_out[..., 6, 10] = K_el_out[..., 10, 6] = t116
    K_el_out[..., 6, 11] = K_el_out[..., 11, 6] = t117
    K_el_out[..., 7, 7] = k_C*t87 + k_C*t88 + k_C*t89
    K_el_out[..., 7, 8] = K_el_out[..., 8, 7] = D_delta_x_3*t118 + D_delta_y_3*t119 + D_delta_z_3*t120
    K_el_out[..., 7, 9] = K_el_out[..., 9, 7] = t118
    K_el_out[..., 7, 10] = K_el_out[..., 10, 7] = t119
    K_el_out[..., 7, 11] = K_el_out[..., 11, 7] = t120
    K_el_out[..., 8, 8] = k_C*t93 + k_C*t94 + k_C*t95
    K_el_out[..., 8, 9] = K_el_out[..., 9, 8] = D_delta_x_3*k_C
    K_el_out[..., 8, 10] = K_el_out[..., 10, 8] = D_delta_y_3*k_C
    K_el_out[..., 8, 11] = K_el_out[..., 11, 8] = D_delta_z_3*k_C
    K_el_out[..., 9, 9] = k_C
    K_el_out[..., 10, 10] = k_C
    K_el_out[..., 11, 11] = k_C
    K_g_out = np.zeros((*batch, 12, 12), dtype)
    K_g_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 + d_1_x*g_x*t121 + d_1_y*g_y*t121
        + d_1_z*g_z*t121 - mu_1*s_1_x*t7 - mu_1*s_1_y*t8 - mu_1*s_1_z*t9 - mu_2*t97 - mu_2*t98 - mu_2*t99
        - mu_3*t97 - mu_3*t98 - mu_3*t99
    )
    K_g_out[..., 0, 1] = K_g_out[..., 1, 0] = (
        -D_p_x_2*t122 - D_p_x_2*t124 - D_p_y_2*t125 - D_p_y_2*t127 - D_p_z_2*t128 - D_p_z_2*t130
        - U_2_x_2*t123 - U_2_y_2*t126 - U_2_z_2*t129
    )
    K_g_out[..., 0, 2] = K_g_out[..., 2, 0] = (
        -D_p_x_3*t123 - D_p_x_3*t124 - D_p_y_3*t126 - D_p_y_3*t127 - D_p_z_3*t129 - D_p_z_3*t130
        - U_3_x_3*t122 - U_3_y_3*t125 - U_3_z_3*t128
    )
    K_g_out[..., 0, 6] = K_g_out[..., 6, 0] = (
        -D_delta_x_1*t122 - D_delta_x_1*t123 - D_delta_x_1*t124 - D_delta_y_1*t125 - D_delta_y_1*t126
        - D_delta_y_1*t127 - D_delta_z_1*t128 - D_delta_z_1*t129 - D_delta_z_1*t130
    )
    K_g_out[..., 0, 7] = K_g_out[..., 7, 0] = (
        -D_delta_x_2*t122 - D_delta_x_2*t123 - D_delta_x_2*t124 - D_delta_y_2*t125 - D_delta_y_2*t126
        - D_delta_y_2*t127 - D_delta_z_2*t128 - D_delta_z_2*t129 - D_delta_z_2*t130
    )
    K_g_out[..., 0, 8] = K_g_out[..., 8, 0] = (
        -D_delta_x_3*t122 - D_delta_x_3*t123 - D_delta_x_3*t124 - D_delta_y_3*t125 - D_delta_y_3*t126
        - D_delta_y_3*t127 - D_delta_z_3*t128 - D_delta_z_3*t129 - D_delta_z_3*t130
    )
    K_g_out[..., 1, 1] = (
        -U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2 - U_2_z_2**2*mu_2 + d_2_x*g_x*t131 + d_2_y*g_y*t131
        + d_2_z*g_z*t131 - mu_1*t103 - mu_1*t104 - mu_1*t105 - mu_2*s_2_x*t10 - mu_2*s_2_y*t11
        - mu_2*s_2_z*t12 - mu_3*t103 - mu_3*t104 - mu_3*t105
    )
    K_g_out[..., 1, 2] = K_g_out[..., 2, 1] = (
        -D_p_x_3*t132 - D_p_x_3*t134 - D_p_y_3*t135 - D_p_y_3*t137 - D_p_z_3*t138 - D_p_z_3*t140
        - U_3_x_3*t133 - U_3_y_3*t136 - U_3_z_3*t139
    )
    K_g_out[..., 1, 6] = K_g_out[..., 6, 1] = (
        -D_delta_x_1*t132 - D_delta_x_1*t133 - D_delta_x_1*t134 - D_delta_y_1*t135 - D_delta_y_1*t136
        - D_delta_y_1*t137 - D_delta_z_1*t138 - D_delta_z_1*t139 - D_delta_z_1*t140
    )
    K_g_out[..., 1, 7] = K_g_out[..., 7, 1] = (
        -D_delta_x_2*t132 - D_delta_x_2*t133 - D_delta_x_2*t134 - D_delta_y_2*t135 - D_delta_y_2*t136
        - D_delta_y_2*t137 - D_delta_z_2*t138 - D_delta_z_2*t139 - D_delta_z_2*t140
    )
    K_g_out[..., 1, 8] = K_g_out[..., 8, 1] = (
        -D_delta_x_3*t132 - D_delta_x_3*t133 - D_delta_x_3*t134 - D_delta_y_3*t135 - D_delta_y_3*t136
        - D_delta_y_3*t137 - D_delta_z_3*t138 - D_delta_z_3*t139 - D_delta_z_3*t140
    )
    K_g_out[..., 2, 2] = (
        -U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3 + d_3_x*g_x*t141 + d_3_y*g_y*t141
        + d_3_z*g_z*t141 - mu_1*t109 - mu_1*t110 - mu_1*t111 - mu_2*t109 - mu_2*t110 - mu_2*t111
        - mu_3*s_3_x*t13 - mu_3*s_3_y*t14 - mu_3*s_3_z*t15
    )
    K_g_out[..., 2, 6] = K_g_out[..., 6, 2] = (
        -D_delta_x_1*t143 - D_delta_y_1*t145 - D_delta_z_1*t147 - mu_1*t142 - mu_1*t144 - mu_1*t146
        - mu_2*t142 - mu_2*t144 - mu_2*t146
    )
    K_g_out[..., 2, 7] = K_g_out[..., 7, 2] = (
        -D_delta_x_2*t143 - D_delta_y_2*t145 - D_delta_z_2*t147 - mu_1*t148 - mu_1*t149 - mu_1*t150
        - mu_2*t148 - mu_2*t149 - mu_2*t150
    )
    K_g_out[..., 2, 8] = K_g_out[..., 8, 2] = (
        -D_delta_x_3*t143 - D_delta_y_3*t145 - D_delta_z_3*t147 - mu_1*t151 - mu_1*t152 - mu_1*t153
        - mu_2*t151 - mu_2*t152 - mu_2*t153
    )
    K_g_out[..., 6, 6] = (
        -mu_1*t81 - mu_1*t82 - mu_1*t83 + mu_1 - mu_2*t81 - mu_2*t82 - mu_2*t83 - mu_3*t81 - mu_3*t82
        - mu_3*t83
    )
    K_g_out[..., 6, 7] = K_g_out[..., 7, 6] = (
        -mu_1*t154 - mu_1*t155 - mu_1*t156 - mu_2*t154 - mu_2*t155 - mu_2*t156 - mu_3*t154 - mu_3*t155
        - mu_3*t156
    )
    K_g_out[..., 6, 8] = K_g_out[..., 8, 6] = (
        -mu_1*t157 - mu_1*t158 - mu_1*t159 - mu_2*t157 - mu_2*t158 - mu_2*t159 - mu_3*t157 - mu_3*t158
        - mu_3*t159
    )
    K_g_out[..., 7, 7] = (
        -mu_1*t87 - mu_1*t88 - mu_1*t89 - mu_2*t87 - mu_2*t88 - mu_2*t89 + mu_2 - mu_3*t87 - mu_3*t88
        - mu_3*t89
    )
    K_g_out[..., 7, 8] = K_g_out[..., 8, 7] = (
        -mu_1*t160 - mu_1*t161 - mu_1*t162 - mu_2*t160 - mu_2*t161 - mu_2*t162 - mu_3*t160 - mu_3*t161
        - mu_3*t162
    )
    K_g_out[..., 8, 8] = (
        -mu_1*t93 - mu_1*t94 - mu_1*t95 - mu_2*t93 - mu_2*t94 - mu_2*t95 - mu_3*t93 - mu_3*t94 - mu_3*t95
        + mu_3
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
    J_p : array, shape (..., 3, 12) [1, m]
        dp_i/dq_k, base frame.

    Notes
    -----
    Equation 15, with the contributions of released joints and the frame.
    315 operations; 116730 with every named value expanded.
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
    J_p_out = np.zeros((*batch, 3, 12), dtype)
    J_p_out[..., 0, 0] = D_p_x_1
    J_p_out[..., 0, 1] = D_p_x_2
    J_p_out[..., 0, 2] = D_p_x_3
    J_p_out[..., 0, 6] = D_delta_x_1
    J_p_out[..., 0, 7] = D_delta_x_2
    J_p_out[..., 0, 8] = D_delta_x_3
    J_p_out[..., 0, 9] = 1
    J_p_out[..., 1, 0] = D_p_y_1
    J_p_out[..., 1, 1] = D_p_y_2
    J_p_out[..., 1, 2] = D_p_y_3
    J_p_out[..., 1, 6] = D_delta_y_1
    J_p_out[..., 1, 7] = D_delta_y_2
    J_p_out[..., 1, 8] = D_delta_y_3
    J_p_out[..., 1, 10] = 1
    J_p_out[..., 2, 0] = D_p_z_1
    J_p_out[..., 2, 1] = D_p_z_2
    J_p_out[..., 2, 2] = D_p_z_3
    J_p_out[..., 2, 6] = D_delta_z_1
    J_p_out[..., 2, 7] = D_delta_z_2
    J_p_out[..., 2, 8] = D_delta_z_3
    J_p_out[..., 2, 11] = 1
    return J_p_out


def motor_motion():
    """Jacobian of the angles of the motors, seen at the rotors that they drive.

    Parameters
    ----------

    Returns
    -------
    J_m : array, shape (..., 3, 12) [1]
        d(motor angle)/dq_k.

    Notes
    -----
    The drives that the mechanism declares; a gearbox winds up by psi_j on its output side.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    J_m_out = np.zeros((*batch, 3, 12), dtype)
    J_m_out[..., 0, 3] = 1
    J_m_out[..., 1, 4] = 1
    J_m_out[..., 2, 5] = 1
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
    19 operations; 30 with every named value expanded.
    """
    (c_L,) = _entries(effects.link_compliance_compliance, ())
    (c_F,) = _entries(effects.frame_compliance_compliance, ())
    (c_F_x,) = _entries(effects.frame_compliance_compliance_x, ())
    (c_F_y,) = _entries(effects.frame_compliance_compliance_y, ())
    (c_F_z,) = _entries(effects.frame_compliance_compliance_z, ())
    batch, dtype = _batch(c_L, c_F, c_F_x, c_F_y, c_F_z)
    t1 = 1.0/c_L
    t2 = c_F + c_F_x
    t3 = c_F + c_F_y
    t4 = c_F + c_F_z
    t5 = -1/c_L**2
    kappa_out = np.empty((*batch, 6), dtype)
    kappa_out[..., 0] = t1
    kappa_out[..., 1] = t1
    kappa_out[..., 2] = t1
    kappa_out[..., 3] = 1.0/t2
    kappa_out[..., 4] = 1.0/t3
    kappa_out[..., 5] = 1.0/t4
    kappa_c_out = np.empty((*batch, 6), dtype)
    kappa_c_out[..., 0] = t5
    kappa_c_out[..., 1] = t5
    kappa_c_out[..., 2] = t5
    kappa_c_out[..., 3] = -1/t2**2
    kappa_c_out[..., 4] = -1/t3**2
    kappa_c_out[..., 5] = -1/t4**2
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
    C_v : array, shape (..., 12, 12) [N s/m, N s, N m s]
        Viscous damping matrix.
    K_loss : array, shape (..., 12, 12) [N/m, N, N m]
        Imaginary part of the elastic stiffness; the springs of released joints add theirs.

    Notes
    -----
    Dissipation function R = 1/2 sum b v^2, C_v = d2R/dq_dot2; complex stiffnesses k (1 + i eta).
    12 operations; 42 with every named value expanded.
    """
    p_x, _, _ = _entries(p, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    (a_R_1,) = _entries(effects.axis_reducer_stiffness_factor_1, ())
    (a_R_2,) = _entries(effects.axis_reducer_stiffness_factor_2, ())
    (a_R_3,) = _entries(effects.axis_reducer_stiffness_factor_3, ())
    (b_D,) = _entries(effects.drive_friction_viscous, ())
    (eta_G,) = _entries(effects.reducer_loss_loss_factor, ())
    batch, dtype = _batch(p_x, k_r_1, a_R_1, a_R_2, a_R_3, b_D, eta_G)
    k_1 = k_r_1*(a_R_1 + 1)
    k_2 = k_r_2*(a_R_2 + 1)
    k_3 = k_r_3*(a_R_3 + 1)
    t1 = eta_G*k_1
    t2 = eta_G*k_2
    t3 = eta_G*k_3
    C_v_out = np.zeros((*batch, 12, 12), dtype)
    C_v_out[..., 3, 3] = b_D
    C_v_out[..., 4, 4] = b_D
    C_v_out[..., 5, 5] = b_D
    K_loss_out = np.zeros((*batch, 12, 12), dtype)
    K_loss_out[..., 0, 0] = t1
    K_loss_out[..., 0, 3] = K_loss_out[..., 3, 0] = -t1
    K_loss_out[..., 1, 1] = t2
    K_loss_out[..., 1, 4] = K_loss_out[..., 4, 1] = -t2
    K_loss_out[..., 2, 2] = t3
    K_loss_out[..., 2, 5] = K_loss_out[..., 5, 2] = -t3
    K_loss_out[..., 3, 3] = t1
    K_loss_out[..., 4, 4] = t2
    K_loss_out[..., 5, 5] = t3
    return C_v_out, K_loss_out


def joint_loss():
    """Loss factors of the springs of the released joints.

    Parameters
    ----------

    Returns
    -------
    eta : array, shape (..., 6) [1]
        Loss factor of each released coordinate, in order.

    Notes
    -----
    Complex stiffness k (1 + i eta) of each.
    0 operations; 0 with every named value expanded.
    """
    batch, dtype = _batch()
    eta_out = np.zeros((*batch, 6), dtype)
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
    theta_st : array, shape (..., 3) [rad]
        Rotations relative to the unstrained transmissions.

    Notes
    -----
    Equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
    376 operations; 138123 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_R_1,) = _entries(effects.axis_reducer_stiffness_factor_1, ())
    (a_R_2,) = _entries(effects.axis_reducer_stiffness_factor_2, ())
    (a_R_3,) = _entries(effects.axis_reducer_stiffness_factor_3, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1, k_r_1,
        sigma_1, a_R_1, a_R_2, a_R_3, m_L)
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
    t5 = D_r_1*t4
    D_p_x_1 = A_x_1*t5
    t6 = D_r_2*t4
    D_p_x_2 = A_x_2*t6
    t7 = D_r_3*t4
    D_p_x_3 = A_x_3*t7
    D_p_y_1 = A_y_1*t5
    D_p_y_2 = A_y_2*t6
    D_p_y_3 = A_y_3*t7
    D_p_z_1 = A_z_1*t5
    D_p_z_2 = A_z_2*t6
    D_p_z_3 = A_z_3*t7
    k_1 = k_r_1*(a_R_1 + 1)
    k_2 = k_r_2*(a_R_2 + 1)
    k_3 = k_r_3*(a_R_3 + 1)
    t8 = (1/2)*m_d_3
    t9 = (1/2)*m_d_1
    t10 = (1/2)*m_d_2
    t11 = m_L + m_p + t10 + t8 + t9
    t12 = g_x*t11
    t13 = g_y*t11
    t14 = g_z*t11
    t15 = L_a_1*t9 + m_a_1*r_a_1
    G_1 = -D_p_x_1*t12 - D_p_y_1*t13 - D_p_z_1*t14 - g_x*t15*t_1_x - g_y*t15*t_1_y - g_z*t15*t_1_z
    t16 = L_a_2*t10 + m_a_2*r_a_2
    G_2 = -D_p_x_2*t12 - D_p_y_2*t13 - D_p_z_2*t14 - g_x*t16*t_2_x - g_y*t16*t_2_y - g_z*t16*t_2_z
    t17 = L_a_3*t8 + m_a_3*r_a_3
    G_3 = -D_p_x_3*t12 - D_p_y_3*t13 - D_p_z_3*t14 - g_x*t17*t_3_x - g_y*t17*t_3_y - g_z*t17*t_3_z
    phi_1_st = G_1/k_1
    phi_2_st = G_2/k_2
    phi_3_st = G_3/k_3
    tau_st_1 = k_1*phi_1_st
    tau_st_2 = k_2*phi_2_st
    tau_st_3 = k_3*phi_3_st
    tau_st_out = np.empty((*batch, 3), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    tau_st_out[..., 2] = tau_st_3
    theta_st_out = np.empty((*batch, 3), dtype)
    theta_st_out[..., 0] = phi_1_st
    theta_st_out[..., 1] = phi_2_st
    theta_st_out[..., 2] = phi_3_st
    return tau_st_out, theta_st_out


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
    M_theta : array, shape (..., 252) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 237) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Chain rule.
    1889 operations; 25692087 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    k_r_1, k_r_2, k_r_3 = _entries(parameters.reducer_stiffness, (3,))
    I_m_1, I_m_2, I_m_3 = _entries(parameters.motor_inertia, (3,))
    i_g_1, i_g_2, i_g_3 = _entries(parameters.gear_ratio, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (a_R_1,) = _entries(effects.axis_reducer_stiffness_factor_1, ())
    (a_R_2,) = _entries(effects.axis_reducer_stiffness_factor_2, ())
    (a_R_3,) = _entries(effects.axis_reducer_stiffness_factor_3, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1, k_r_1,
        I_m_1, i_g_1, sigma_1, a_R_1, a_R_2, a_R_3, m_L)
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
    t1 = L_a_1**2
    C_1 = (1/2)*(-l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2 + t1)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t2 = 1.0/rho2_1
    c_1 = t2*(A_1*C_1 - B_1*S_1)
    sn_1 = t2*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    t3 = L_a_2**2
    C_2 = (1/2)*(-l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2 + t3)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t4 = 1.0/rho2_2
    c_2 = t4*(A_2*C_2 - B_2*S_2)
    sn_2 = t4*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t5 = L_a_3**2
    C_3 = (1/2)*(-l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2 + t5)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t6 = 1.0/rho2_3
    c_3 = t6*(A_3*C_3 - B_3*S_3)
    sn_3 = t6*(A_3*S_3 + B_3*C_3)
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
    t7 = L_a_1*d_1_x
    s_1_x = r_1_x - t7
    t8 = L_a_1*d_1_y
    s_1_y = r_1_y - t8
    t9 = L_a_1*d_1_z
    s_1_z = r_1_z - t9
    t10 = L_a_2*d_2_x
    s_2_x = r_2_x - t10
    t11 = L_a_2*d_2_y
    s_2_y = r_2_y - t11
    t12 = L_a_2*d_2_z
    s_2_z = r_2_z - t12
    t13 = L_a_3*d_3_x
    s_3_x = r_3_x - t13
    t14 = L_a_3*d_3_y
    s_3_y = r_3_y - t14
    t15 = L_a_3*d_3_z
    s_3_z = r_3_z - t15
    t16 = L_a_1*t_1_x
    t17 = L_a_1*t_1_y
    t18 = L_a_1*t_1_z
    D_r_1 = s_1_x*t16 + s_1_y*t17 + s_1_z*t18
    t19 = L_a_2*t_2_x
    t20 = L_a_2*t_2_y
    t21 = L_a_2*t_2_z
    D_r_2 = s_2_x*t19 + s_2_y*t20 + s_2_z*t21
    t22 = L_a_3*t_3_x
    t23 = L_a_3*t_3_y
    t24 = L_a_3*t_3_z
    D_r_3 = s_3_x*t22 + s_3_y*t23 + s_3_z*t24
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
    t25 = 1.0/det_D_l
    t26 = A_x_1*t25
    D_p_x_1 = D_r_1*t26
    t27 = A_x_2*t25
    D_p_x_2 = D_r_2*t27
    t28 = A_x_3*t25
    D_p_x_3 = D_r_3*t28
    D_delta_x_1 = l_d_1*t26
    D_delta_x_2 = l_d_2*t27
    D_delta_x_3 = l_d_3*t28
    t29 = A_y_1*t25
    D_p_y_1 = D_r_1*t29
    t30 = A_y_2*t25
    D_p_y_2 = D_r_2*t30
    t31 = A_y_3*t25
    D_p_y_3 = D_r_3*t31
    D_delta_y_1 = l_d_1*t29
    D_delta_y_2 = l_d_2*t30
    D_delta_y_3 = l_d_3*t31
    t32 = A_z_1*t25
    D_p_z_1 = D_r_1*t32
    t33 = A_z_2*t25
    D_p_z_2 = D_r_2*t33
    t34 = A_z_3*t25
    D_p_z_3 = D_r_3*t34
    D_delta_z_1 = l_d_1*t32
    D_delta_z_2 = l_d_2*t33
    D_delta_z_3 = l_d_3*t34
    U_1_x_1 = D_p_x_1 - t16
    U_1_y_1 = D_p_y_1 - t17
    U_1_z_1 = D_p_z_1 - t18
    U_2_x_2 = D_p_x_2 - t19
    U_2_y_2 = D_p_y_2 - t20
    U_2_z_2 = D_p_z_2 - t21
    U_3_x_3 = D_p_x_3 - t22
    U_3_y_3 = D_p_y_3 - t23
    U_3_z_3 = D_p_z_3 - t24
    t35 = A_x_1*g_x
    t36 = A_y_1*g_y
    t37 = A_z_1*g_z
    mu_1_by_m_p = t25*(-t35 - t36 - t37)
    t38 = A_x_2*g_x
    t39 = A_y_2*g_y
    t40 = A_z_2*g_z
    mu_2_by_m_p = t25*(-t38 - t39 - t40)
    t41 = A_x_3*g_x
    t42 = A_y_3*g_y
    t43 = A_z_3*g_z
    mu_3_by_m_p = t25*(-t41 - t42 - t43)
    t44 = (1/2)*m_d_1
    t45 = (1/2)*m_d_2
    t46 = (1/2)*m_d_3
    t47 = -m_L - m_p - t44 - t45 - t46
    mu_1_by_g_x = t26*t47
    mu_2_by_g_x = t27*t47
    mu_3_by_g_x = t28*t47
    mu_1_by_g_y = t29*t47
    mu_2_by_g_y = t30*t47
    mu_3_by_g_y = t31*t47
    mu_1_by_g_z = t32*t47
    mu_2_by_g_z = t33*t47
    mu_3_by_g_z = t34*t47
    mu_1_by_m_d_1 = t25*(-1/2*t35 - 1/2*t36 - 1/2*t37)
    mu_2_by_m_d_1 = t25*(-1/2*t38 - 1/2*t39 - 1/2*t40)
    mu_3_by_m_d_1 = t25*(-1/2*t41 - 1/2*t42 - 1/2*t43)
    t48 = D_p_x_1**2
    t49 = D_p_y_1**2
    t50 = D_p_z_1**2
    t51 = t48 + t49 + t50
    t52 = D_p_x_1*D_p_x_2
    t53 = D_p_y_1*D_p_y_2
    t54 = D_p_z_1*D_p_z_2
    t55 = t52 + t53 + t54
    t56 = D_p_x_1*D_p_x_3
    t57 = D_p_y_1*D_p_y_3
    t58 = D_p_z_1*D_p_z_3
    t59 = t56 + t57 + t58
    t60 = D_delta_x_1*D_p_x_1
    t61 = D_delta_y_1*D_p_y_1
    t62 = D_delta_z_1*D_p_z_1
    t63 = t60 + t61 + t62
    t64 = D_delta_x_2*D_p_x_1
    t65 = D_delta_y_2*D_p_y_1
    t66 = D_delta_z_2*D_p_z_1
    t67 = t64 + t65 + t66
    t68 = D_delta_x_3*D_p_x_1
    t69 = D_delta_y_3*D_p_y_1
    t70 = D_delta_z_3*D_p_z_1
    t71 = t68 + t69 + t70
    t72 = D_p_x_2**2
    t73 = D_p_y_2**2
    t74 = D_p_z_2**2
    t75 = t72 + t73 + t74
    t76 = D_p_x_2*D_p_x_3
    t77 = D_p_y_2*D_p_y_3
    t78 = D_p_z_2*D_p_z_3
    t79 = t76 + t77 + t78
    t80 = D_delta_x_1*D_p_x_2
    t81 = D_delta_y_1*D_p_y_2
    t82 = D_delta_z_1*D_p_z_2
    t83 = t80 + t81 + t82
    t84 = D_delta_x_2*D_p_x_2
    t85 = D_delta_y_2*D_p_y_2
    t86 = D_delta_z_2*D_p_z_2
    t87 = t84 + t85 + t86
    t88 = D_delta_x_3*D_p_x_2
    t89 = D_delta_y_3*D_p_y_2
    t90 = D_delta_z_3*D_p_z_2
    t91 = t88 + t89 + t90
    t92 = D_p_x_3**2
    t93 = D_p_y_3**2
    t94 = D_p_z_3**2
    t95 = t92 + t93 + t94
    t96 = D_delta_x_1*D_p_x_3
    t97 = D_delta_y_1*D_p_y_3
    t98 = D_delta_z_1*D_p_z_3
    t99 = t96 + t97 + t98
    t100 = D_delta_x_2*D_p_x_3
    t101 = D_delta_y_2*D_p_y_3
    t102 = D_delta_z_2*D_p_z_3
    t103 = t100 + t101 + t102
    t104 = D_delta_x_3*D_p_x_3
    t105 = D_delta_y_3*D_p_y_3
    t106 = D_delta_z_3*D_p_z_3
    t107 = t104 + t105 + t106
    t108 = D_delta_x_1**2
    t109 = D_delta_y_1**2
    t110 = D_delta_z_1**2
    t111 = t108 + t109 + t110
    t112 = D_delta_x_1*D_delta_x_2
    t113 = D_delta_y_1*D_delta_y_2
    t114 = D_delta_z_1*D_delta_z_2
    t115 = t112 + t113 + t114
    t116 = D_delta_x_1*D_delta_x_3
    t117 = D_delta_y_1*D_delta_y_3
    t118 = D_delta_z_1*D_delta_z_3
    t119 = t116 + t117 + t118
    t120 = D_delta_x_2**2
    t121 = D_delta_y_2**2
    t122 = D_delta_z_2**2
    t123 = t120 + t121 + t122
    t124 = D_delta_x_2*D_delta_x_3
    t125 = D_delta_y_2*D_delta_y_3
    t126 = D_delta_z_2*D_delta_z_3
    t127 = t124 + t125 + t126
    t128 = D_delta_x_3**2
    t129 = D_delta_y_3**2
    t130 = D_delta_z_3**2
    t131 = t128 + t129 + t130
    t132 = (1/6)*t16
    t133 = (1/6)*t17
    t134 = (1/6)*t18
    t135 = (1/3)*D_p_x_1 + t132
    t136 = (1/3)*D_p_y_1 + t133
    t137 = (1/3)*D_p_z_1 + t134
    t138 = (1/2)*D_p_x_1
    t139 = (1/2)*D_p_y_1
    t140 = (1/2)*D_p_z_1
    t141 = (1/3)*t72 + (1/3)*t73 + (1/3)*t74
    t142 = (1/3)*t76 + (1/3)*t77 + (1/3)*t78
    t143 = (1/3)*t80 + (1/3)*t81 + (1/3)*t82
    t144 = (1/3)*t84 + (1/3)*t85 + (1/3)*t86
    t145 = (1/3)*t88 + (1/3)*t89 + (1/3)*t90
    t146 = (1/2)*D_p_x_2
    t147 = (1/2)*D_p_y_2
    t148 = (1/2)*D_p_z_2
    t149 = (1/3)*t92 + (1/3)*t93 + (1/3)*t94
    t150 = (1/3)*t96 + (1/3)*t97 + (1/3)*t98
    t151 = (1/3)*t100 + (1/3)*t101 + (1/3)*t102
    t152 = (1/3)*t104 + (1/3)*t105 + (1/3)*t106
    t153 = (1/2)*D_p_x_3
    t154 = (1/2)*D_p_y_3
    t155 = (1/2)*D_p_z_3
    t156 = (1/3)*t108 + (1/3)*t109 + (1/3)*t110
    t157 = (1/3)*t112 + (1/3)*t113 + (1/3)*t114
    t158 = (1/3)*t116 + (1/3)*t117 + (1/3)*t118
    t159 = (1/2)*D_delta_x_1
    t160 = (1/2)*D_delta_y_1
    t161 = (1/2)*D_delta_z_1
    t162 = (1/3)*t120 + (1/3)*t121 + (1/3)*t122
    t163 = (1/3)*t124 + (1/3)*t125 + (1/3)*t126
    t164 = (1/2)*D_delta_x_2
    t165 = (1/2)*D_delta_y_2
    t166 = (1/2)*D_delta_z_2
    t167 = (1/3)*t128 + (1/3)*t129 + (1/3)*t130
    t168 = (1/2)*D_delta_x_3
    t169 = (1/2)*D_delta_y_3
    t170 = (1/2)*D_delta_z_3
    t171 = (1/3)*t48 + (1/3)*t49 + (1/3)*t50
    t172 = (1/6)*t19
    t173 = (1/6)*t20
    t174 = (1/6)*t21
    t175 = (1/3)*t52 + (1/3)*t53 + (1/3)*t54
    t176 = (1/3)*t56 + (1/3)*t57 + (1/3)*t58
    t177 = (1/3)*t60 + (1/3)*t61 + (1/3)*t62
    t178 = (1/3)*t64 + (1/3)*t65 + (1/3)*t66
    t179 = (1/3)*t68 + (1/3)*t69 + (1/3)*t70
    t180 = (1/3)*D_p_x_2 + t172
    t181 = (1/3)*D_p_y_2 + t173
    t182 = (1/3)*D_p_z_2 + t174
    t183 = (1/6)*t22
    t184 = (1/6)*t23
    t185 = (1/6)*t24
    t186 = (1/3)*D_p_x_3 + t183
    t187 = (1/3)*D_p_y_3 + t184
    t188 = (1/3)*D_p_z_3 + t185
    t189 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2 - s_1_x*t7 - s_1_y*t8 - s_1_z*t9
    t190 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    t191 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    t192 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    t193 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    t194 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t195 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t196 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t197 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2 - s_2_x*t10 - s_2_y*t11 - s_2_z*t12
    t198 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    t199 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    t200 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t201 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t202 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t203 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2 - s_3_x*t13 - s_3_y*t14 - s_3_z*t15
    t204 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t205 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t206 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t207 = 1 - t111
    t208 = 1 - t123
    t209 = 1 - t131
    t210 = L_a_1*t44 + m_a_1*r_a_1
    t211 = L_a_2*t45 + m_a_2*r_a_2
    t212 = L_a_3*t46 + m_a_3*r_a_3
    t213 = d_1_x*g_x
    t214 = d_1_y*g_y
    t215 = d_1_z*g_z
    t216 = d_2_x*g_x
    t217 = d_2_y*g_y
    t218 = d_2_z*g_z
    t219 = d_3_x*g_x
    t220 = d_3_y*g_y
    t221 = d_3_z*g_z
    t222 = (1/2)*g_x
    t223 = (1/2)*g_y
    t224 = (1/2)*g_z
    t225 = a_R_1 + 1
    t226 = a_R_2 + 1
    t227 = a_R_3 + 1
    M_theta_out = _listed(batch, dtype, (
        t51, t55, t59, t63, t67, t71, D_p_x_1, D_p_y_1, D_p_z_1, t75, t79, t83, t87, t91, D_p_x_2, D_p_y_2,
        D_p_z_2, t95, t99, t103, t107, D_p_x_3, D_p_y_3, D_p_z_3, t111, t115, t119, D_delta_x_1, D_delta_y_1,
        D_delta_z_1, t123, t127, D_delta_x_2, D_delta_y_2, D_delta_z_2, t131, D_delta_x_3, D_delta_y_3,
        D_delta_z_3, 1, 1, 1, r_a_1*t_1_x, r_a_1*t_1_y, r_a_1*t_1_z, 1, 1, 1, r_a_2*t_2_x, r_a_2*t_2_y,
        r_a_2*t_2_z, 1, 1, 1, r_a_3*t_3_x, r_a_3*t_3_y, r_a_3*t_3_z, 1, 1, 1, m_a_1*t_1_x, m_a_1*t_1_y,
        m_a_1*t_1_z, m_a_2*t_2_x, m_a_2*t_2_y, m_a_2*t_2_z, m_a_3*t_3_x, m_a_3*t_3_y, m_a_3*t_3_z, 1, 1, 1,
        D_p_x_1*t132 + D_p_x_1*t135 + D_p_y_1*t133 + D_p_y_1*t136 + D_p_z_1*t134 + D_p_z_1*t137 + (1/3)*t1,
        D_p_x_2*t135 + D_p_y_2*t136 + D_p_z_2*t137, D_p_x_3*t135 + D_p_y_3*t136 + D_p_z_3*t137,
        D_delta_x_1*t135 + D_delta_y_1*t136 + D_delta_z_1*t137,
        D_delta_x_2*t135 + D_delta_y_2*t136 + D_delta_z_2*t137,
        D_delta_x_3*t135 + D_delta_y_3*t136 + D_delta_z_3*t137, t138 + (1/2)*t16, t139 + (1/2)*t17,
        t140 + (1/2)*t18, t141, t142, t143, t144, t145, t146, t147, t148, t149, t150, t151, t152, t153, t154,
        t155, t156, t157, t158, t159, t160, t161, t162, t163, t164, t165, t166, t167, t168, t169, t170, 1, 1,
        1, t171, D_p_x_1*t172 + D_p_y_1*t173 + D_p_z_1*t174 + t175, t176, t177, t178, t179, t138, t139, t140,
        D_p_x_2*t172 + D_p_x_2*t180 + D_p_y_2*t173 + D_p_y_2*t181 + D_p_z_2*t174 + D_p_z_2*t182 + (1/3)*t3,
        D_p_x_3*t180 + D_p_y_3*t181 + D_p_z_3*t182, D_delta_x_1*t180 + D_delta_y_1*t181 + D_delta_z_1*t182,
        D_delta_x_2*t180 + D_delta_y_2*t181 + D_delta_z_2*t182,
        D_delta_x_3*t180 + D_delta_y_3*t181 + D_delta_z_3*t182, t146 + (1/2)*t19, t147 + (1/2)*t20,
        t148 + (1/2)*t21, t149, t150, t151, t152, t153, t154, t155, t156, t157, t158, t159, t160, t161, t162,
        t163, t164, t165, t166, t167, t168, t169, t170, 1, 1, 1, t171, t175,
        D_p_x_1*t183 + D_p_y_1*t184 + D_p_z_1*t185 + t176, t177, t178, t179, t138, t139, t140, t141,
        D_p_x_2*t183 + D_p_y_2*t184 + D_p_z_2*t185 + t142, t143, t144, t145, t146, t147, t148,
        D_p_x_3*t183 + D_p_x_3*t186 + D_p_y_3*t184 + D_p_y_3*t187 + D_p_z_3*t185 + D_p_z_3*t188 + (1/3)*t5,
        D_delta_x_1*t186 + D_delta_y_1*t187 + D_delta_z_1*t188,
        D_delta_x_2*t186 + D_delta_y_2*t187 + D_delta_z_2*t188,
        D_delta_x_3*t186 + D_delta_y_3*t187 + D_delta_z_3*t188, t153 + (1/2)*t22, t154 + (1/2)*t23,
        t155 + (1/2)*t24, t156, t157, t158, t159, t160, t161, t162, t163, t164, t165, t166, t167, t168, t169,
        t170, 1, 1, 1, i_g_1**2, i_g_2**2, i_g_3**2, 2*I_m_1*i_g_1, 2*I_m_2*i_g_2, 2*I_m_3*i_g_3, 1, 1, 1,
        t51, t55, t59, t63, t67, t71, D_p_x_1, D_p_y_1, D_p_z_1, t75, t79, t83, t87, t91, D_p_x_2, D_p_y_2,
        D_p_z_2, t95, t99, t103, t107, D_p_x_3, D_p_y_3, D_p_z_3, t111, t115, t119, D_delta_x_1, D_delta_y_1,
        D_delta_z_1, t123, t127, D_delta_x_2, D_delta_y_2, D_delta_z_2, t131, D_delta_x_3, D_delta_y_3,
        D_delta_z_3, 1, 1, 1, 1, 1, 1,
    ))
    K_theta_out = _listed(batch, dtype, (
        mu_1_by_m_p*t189 - mu_2_by_m_p*t51 - mu_3_by_m_p*t51,
        mu_1_by_m_p*t190 + mu_2_by_m_p*t191 - mu_3_by_m_p*t55,
        mu_1_by_m_p*t192 - mu_2_by_m_p*t59 + mu_3_by_m_p*t193,
        mu_1_by_m_p*t194 - mu_2_by_m_p*t63 - mu_3_by_m_p*t63,
        mu_1_by_m_p*t195 - mu_2_by_m_p*t67 - mu_3_by_m_p*t67,
        mu_1_by_m_p*t196 - mu_2_by_m_p*t71 - mu_3_by_m_p*t71,
        -mu_1_by_m_p*t75 + mu_2_by_m_p*t197 - mu_3_by_m_p*t75,
        -mu_1_by_m_p*t79 + mu_2_by_m_p*t198 + mu_3_by_m_p*t199,
        -mu_1_by_m_p*t83 + mu_2_by_m_p*t200 - mu_3_by_m_p*t83,
        -mu_1_by_m_p*t87 + mu_2_by_m_p*t201 - mu_3_by_m_p*t87,
        -mu_1_by_m_p*t91 + mu_2_by_m_p*t202 - mu_3_by_m_p*t91,
        -mu_1_by_m_p*t95 - mu_2_by_m_p*t95 + mu_3_by_m_p*t203,
        -mu_1_by_m_p*t99 - mu_2_by_m_p*t99 + mu_3_by_m_p*t204,
        -mu_1_by_m_p*t103 - mu_2_by_m_p*t103 + mu_3_by_m_p*t205,
        -mu_1_by_m_p*t107 - mu_2_by_m_p*t107 + mu_3_by_m_p*t206,
        mu_1_by_m_p*t207 - mu_2_by_m_p*t111 - mu_3_by_m_p*t111,
        -mu_1_by_m_p*t115 - mu_2_by_m_p*t115 - mu_3_by_m_p*t115,
        -mu_1_by_m_p*t119 - mu_2_by_m_p*t119 - mu_3_by_m_p*t119,
        -mu_1_by_m_p*t123 + mu_2_by_m_p*t208 - mu_3_by_m_p*t123,
        -mu_1_by_m_p*t127 - mu_2_by_m_p*t127 - mu_3_by_m_p*t127,
        -mu_1_by_m_p*t131 - mu_2_by_m_p*t131 + mu_3_by_m_p*t209,
        d_1_x*t210 + mu_1_by_g_x*t189 - mu_2_by_g_x*t51 - mu_3_by_g_x*t51,
        mu_1_by_g_x*t190 + mu_2_by_g_x*t191 - mu_3_by_g_x*t55,
        mu_1_by_g_x*t192 - mu_2_by_g_x*t59 + mu_3_by_g_x*t193,
        mu_1_by_g_x*t194 - mu_2_by_g_x*t63 - mu_3_by_g_x*t63,
        mu_1_by_g_x*t195 - mu_2_by_g_x*t67 - mu_3_by_g_x*t67,
        mu_1_by_g_x*t196 - mu_2_by_g_x*t71 - mu_3_by_g_x*t71,
        d_2_x*t211 - mu_1_by_g_x*t75 + mu_2_by_g_x*t197 - mu_3_by_g_x*t75,
        -mu_1_by_g_x*t79 + mu_2_by_g_x*t198 + mu_3_by_g_x*t199,
        -mu_1_by_g_x*t83 + mu_2_by_g_x*t200 - mu_3_by_g_x*t83,
        -mu_1_by_g_x*t87 + mu_2_by_g_x*t201 - mu_3_by_g_x*t87,
        -mu_1_by_g_x*t91 + mu_2_by_g_x*t202 - mu_3_by_g_x*t91,
        d_3_x*t212 - mu_1_by_g_x*t95 - mu_2_by_g_x*t95 + mu_3_by_g_x*t203,
        -mu_1_by_g_x*t99 - mu_2_by_g_x*t99 + mu_3_by_g_x*t204,
        -mu_1_by_g_x*t103 - mu_2_by_g_x*t103 + mu_3_by_g_x*t205,
        -mu_1_by_g_x*t107 - mu_2_by_g_x*t107 + mu_3_by_g_x*t206,
        mu_1_by_g_x*t207 - mu_2_by_g_x*t111 - mu_3_by_g_x*t111,
        -mu_1_by_g_x*t115 - mu_2_by_g_x*t115 - mu_3_by_g_x*t115,
        -mu_1_by_g_x*t119 - mu_2_by_g_x*t119 - mu_3_by_g_x*t119,
        -mu_1_by_g_x*t123 + mu_2_by_g_x*t208 - mu_3_by_g_x*t123,
        -mu_1_by_g_x*t127 - mu_2_by_g_x*t127 - mu_3_by_g_x*t127,
        -mu_1_by_g_x*t131 - mu_2_by_g_x*t131 + mu_3_by_g_x*t209,
        d_1_y*t210 + mu_1_by_g_y*t189 - mu_2_by_g_y*t51 - mu_3_by_g_y*t51,
        mu_1_by_g_y*t190 + mu_2_by_g_y*t191 - mu_3_by_g_y*t55,
        mu_1_by_g_y*t192 - mu_2_by_g_y*t59 + mu_3_by_g_y*t193,
        mu_1_by_g_y*t194 - mu_2_by_g_y*t63 - mu_3_by_g_y*t63,
        mu_1_by_g_y*t195 - mu_2_by_g_y*t67 - mu_3_by_g_y*t67,
        mu_1_by_g_y*t196 - mu_2_by_g_y*t71 - mu_3_by_g_y*t71,
        d_2_y*t211 - mu_1_by_g_y*t75 + mu_2_by_g_y*t197 - mu_3_by_g_y*t75,
        -mu_1_by_g_y*t79 + mu_2_by_g_y*t198 + mu_3_by_g_y*t199,
        -mu_1_by_g_y*t83 + mu_2_by_g_y*t200 - mu_3_by_g_y*t83,
        -mu_1_by_g_y*t87 + mu_2_by_g_y*t201 - mu_3_by_g_y*t87,
        -mu_1_by_g_y*t91 + mu_2_by_g_y*t202 - mu_3_by_g_y*t91,
        d_3_y*t212 - mu_1_by_g_y*t95 - mu_2_by_g_y*t95 + mu_3_by_g_y*t203,
        -mu_1_by_g_y*t99 - mu_2_by_g_y*t99 + mu_3_by_g_y*t204,
        -mu_1_by_g_y*t103 - mu_2_by_g_y*t103 + mu_3_by_g_y*t205,
        -mu_1_by_g_y*t107 - mu_2_by_g_y*t107 + mu_3_by_g_y*t206,
        mu_1_by_g_y*t207 - mu_2_by_g_y*t111 - mu_3_by_g_y*t111,
        -mu_1_by_g_y*t115 - mu_2_by_g_y*t115 - mu_3_by_g_y*t115,
        -mu_1_by_g_y*t119 - mu_2_by_g_y*t119 - mu_3_by_g_y*t119,
        -mu_1_by_g_y*t123 + mu_2_by_g_y*t208 - mu_3_by_g_y*t123,
        -mu_1_by_g_y*t127 - mu_2_by_g_y*t127 - mu_3_by_g_y*t127,
        -mu_1_by_g_y*t131 - mu_2_by_g_y*t131 + mu_3_by_g_y*t209,
        d_1_z*t210 + mu_1_by_g_z*t189 - mu_2_by_g_z*t51 - mu_3_by_g_z*t51,
        mu_1_by_g_z*t190 + mu_2_by_g_z*t191 - mu_3_by_g_z*t55,
        mu_1_by_g_z*t192 - mu_2_by_g_z*t59 + mu_3_by_g_z*t193,
        mu_1_by_g_z*t194 - mu_2_by_g_z*t63 - mu_3_by_g_z*t63,
        mu_1_by_g_z*t195 - mu_2_by_g_z*t67 - mu_3_by_g_z*t67,
        mu_1_by_g_z*t196 - mu_2_by_g_z*t71 - mu_3_by_g_z*t71,
        d_2_z*t211 - mu_1_by_g_z*t75 + mu_2_by_g_z*t197 - mu_3_by_g_z*t75,
        -mu_1_by_g_z*t79 + mu_2_by_g_z*t198 + mu_3_by_g_z*t199,
        -mu_1_by_g_z*t83 + mu_2_by_g_z*t200 - mu_3_by_g_z*t83,
        -mu_1_by_g_z*t87 + mu_2_by_g_z*t201 - mu_3_by_g_z*t87,
        -mu_1_by_g_z*t91 + mu_2_by_g_z*t202 - mu_3_by_g_z*t91,
        d_3_z*t212 - mu_1_by_g_z*t95 - mu_2_by_g_z*t95 + mu_3_by_g_z*t203,
        -mu_1_by_g_z*t99 - mu_2_by_g_z*t99 + mu_3_by_g_z*t204,
        -mu_1_by_g_z*t103 - mu_2_by_g_z*t103 + mu_3_by_g_z*t205,
        -mu_1_by_g_z*t107 - mu_2_by_g_z*t107 + mu_3_by_g_z*t206,
        mu_1_by_g_z*t207 - mu_2_by_g_z*t111 - mu_3_by_g_z*t111,
        -mu_1_by_g_z*t115 - mu_2_by_g_z*t115 - mu_3_by_g_z*t115,
        -mu_1_by_g_z*t119 - mu_2_by_g_z*t119 - mu_3_by_g_z*t119,
        -mu_1_by_g_z*t123 + mu_2_by_g_z*t208 - mu_3_by_g_z*t123,
        -mu_1_by_g_z*t127 - mu_2_by_g_z*t127 - mu_3_by_g_z*t127,
        -mu_1_by_g_z*t131 - mu_2_by_g_z*t131 + mu_3_by_g_z*t209, r_a_1*t213 + r_a_1*t214 + r_a_1*t215,
        r_a_2*t216 + r_a_2*t217 + r_a_2*t218, r_a_3*t219 + r_a_3*t220 + r_a_3*t221,
        m_a_1*t213 + m_a_1*t214 + m_a_1*t215, m_a_2*t216 + m_a_2*t217 + m_a_2*t218,
        m_a_3*t219 + m_a_3*t220 + m_a_3*t221,
        mu_1_by_m_d_1*t189 - mu_2_by_m_d_1*t51 - mu_3_by_m_d_1*t51 + t222*t7 + t223*t8 + t224*t9,
        mu_1_by_m_d_1*t190 + mu_2_by_m_d_1*t191 - mu_3_by_m_d_1*t55,
        mu_1_by_m_d_1*t192 - mu_2_by_m_d_1*t59 + mu_3_by_m_d_1*t193,
        mu_1_by_m_d_1*t194 - mu_2_by_m_d_1*t63 - mu_3_by_m_d_1*t63,
        mu_1_by_m_d_1*t195 - mu_2_by_m_d_1*t67 - mu_3_by_m_d_1*t67,
        mu_1_by_m_d_1*t196 - mu_2_by_m_d_1*t71 - mu_3_by_m_d_1*t71,
        -mu_1_by_m_d_1*t75 + mu_2_by_m_d_1*t197 - mu_3_by_m_d_1*t75,
        -mu_1_by_m_d_1*t79 + mu_2_by_m_d_1*t198 + mu_3_by_m_d_1*t199,
        -mu_1_by_m_d_1*t83 + mu_2_by_m_d_1*t200 - mu_3_by_m_d_1*t83,
        -mu_1_by_m_d_1*t87 + mu_2_by_m_d_1*t201 - mu_3_by_m_d_1*t87,
        -mu_1_by_m_d_1*t91 + mu_2_by_m_d_1*t202 - mu_3_by_m_d_1*t91,
        -mu_1_by_m_d_1*t95 - mu_2_by_m_d_1*t95 + mu_3_by_m_d_1*t203,
        -mu_1_by_m_d_1*t99 - mu_2_by_m_d_1*t99 + mu_3_by_m_d_1*t204,
        -mu_1_by_m_d_1*t103 - mu_2_by_m_d_1*t103 + mu_3_by_m_d_1*t205,
        -mu_1_by_m_d_1*t107 - mu_2_by_m_d_1*t107 + mu_3_by_m_d_1*t206,
        mu_1_by_m_d_1*t207 - mu_2_by_m_d_1*t111 - mu_3_by_m_d_1*t111,
        -mu_1_by_m_d_1*t115 - mu_2_by_m_d_1*t115 - mu_3_by_m_d_1*t115,
        -mu_1_by_m_d_1*t119 - mu_2_by_m_d_1*t119 - mu_3_by_m_d_1*t119,
        -mu_1_by_m_d_1*t123 + mu_2_by_m_d_1*t208 - mu_3_by_m_d_1*t123,
        -mu_1_by_m_d_1*t127 - mu_2_by_m_d_1*t127 - mu_3_by_m_d_1*t127,
        -mu_1_by_m_d_1*t131 - mu_2_by_m_d_1*t131 + mu_3_by_m_d_1*t209,
        mu_1_by_m_d_1*t189 - mu_2_by_m_d_1*t51 - mu_3_by_m_d_1*t51,
        mu_1_by_m_d_1*t190 + mu_2_by_m_d_1*t191 - mu_3_by_m_d_1*t55,
        mu_1_by_m_d_1*t192 - mu_2_by_m_d_1*t59 + mu_3_by_m_d_1*t193,
        mu_1_by_m_d_1*t194 - mu_2_by_m_d_1*t63 - mu_3_by_m_d_1*t63,
        mu_1_by_m_d_1*t195 - mu_2_by_m_d_1*t67 - mu_3_by_m_d_1*t67,
        mu_1_by_m_d_1*t196 - mu_2_by_m_d_1*t71 - mu_3_by_m_d_1*t71,
        -mu_1_by_m_d_1*t75 + mu_2_by_m_d_1*t197 - mu_3_by_m_d_1*t75 + t10*t222 + t11*t223 + t12*t224,
        -mu_1_by_m_d_1*t79 + mu_2_by_m_d_1*t198 + mu_3_by_m_d_1*t199,
        -mu_1_by_m_d_1*t83 + mu_2_by_m_d_1*t200 - mu_3_by_m_d_1*t83,
        -mu_1_by_m_d_1*t87 + mu_2_by_m_d_1*t201 - mu_3_by_m_d_1*t87,
        -mu_1_by_m_d_1*t91 + mu_2_by_m_d_1*t202 - mu_3_by_m_d_1*t91,
        -mu_1_by_m_d_1*t95 - mu_2_by_m_d_1*t95 + mu_3_by_m_d_1*t203,
        -mu_1_by_m_d_1*t99 - mu_2_by_m_d_1*t99 + mu_3_by_m_d_1*t204,
        -mu_1_by_m_d_1*t103 - mu_2_by_m_d_1*t103 + mu_3_by_m_d_1*t205,
        -mu_1_by_m_d_1*t107 - mu_2_by_m_d_1*t107 + mu_3_by_m_d_1*t206,
        mu_1_by_m_d_1*t207 - mu_2_by_m_d_1*t111 - mu_3_by_m_d_1*t111,
        -mu_1_by_m_d_1*t115 - mu_2_by_m_d_1*t115 - mu_3_by_m_d_1*t115,
        -mu_1_by_m_d_1*t119 - mu_2_by_m_d_1*t119 - mu_3_by_m_d_1*t119,
        -mu_1_by_m_d_1*t123 + mu_2_by_m_d_1*t208 - mu_3_by_m_d_1*t123,
        -mu_1_by_m_d_1*t127 - mu_2_by_m_d_1*t127 - mu_3_by_m_d_1*t127,
        -mu_1_by_m_d_1*t131 - mu_2_by_m_d_1*t131 + mu_3_by_m_d_1*t209,
        mu_1_by_m_d_1*t189 - mu_2_by_m_d_1*t51 - mu_3_by_m_d_1*t51,
        mu_1_by_m_d_1*t190 + mu_2_by_m_d_1*t191 - mu_3_by_m_d_1*t55,
        mu_1_by_m_d_1*t192 - mu_2_by_m_d_1*t59 + mu_3_by_m_d_1*t193,
        mu_1_by_m_d_1*t194 - mu_2_by_m_d_1*t63 - mu_3_by_m_d_1*t63,
        mu_1_by_m_d_1*t195 - mu_2_by_m_d_1*t67 - mu_3_by_m_d_1*t67,
        mu_1_by_m_d_1*t196 - mu_2_by_m_d_1*t71 - mu_3_by_m_d_1*t71,
        -mu_1_by_m_d_1*t75 + mu_2_by_m_d_1*t197 - mu_3_by_m_d_1*t75,
        -mu_1_by_m_d_1*t79 + mu_2_by_m_d_1*t198 + mu_3_by_m_d_1*t199,
        -mu_1_by_m_d_1*t83 + mu_2_by_m_d_1*t200 - mu_3_by_m_d_1*t83,
        -mu_1_by_m_d_1*t87 + mu_2_by_m_d_1*t201 - mu_3_by_m_d_1*t87,
        -mu_1_by_m_d_1*t91 + mu_2_by_m_d_1*t202 - mu_3_by_m_d_1*t91,
        -mu_1_by_m_d_1*t95 - mu_2_by_m_d_1*t95 + mu_3_by_m_d_1*t203 + t13*t222 + t14*t223 + t15*t224,
        -mu_1_by_m_d_1*t99 - mu_2_by_m_d_1*t99 + mu_3_by_m_d_1*t204,
        -mu_1_by_m_d_1*t103 - mu_2_by_m_d_1*t103 + mu_3_by_m_d_1*t205,
        -mu_1_by_m_d_1*t107 - mu_2_by_m_d_1*t107 + mu_3_by_m_d_1*t206,
        mu_1_by_m_d_1*t207 - mu_2_by_m_d_1*t111 - mu_3_by_m_d_1*t111,
        -mu_1_by_m_d_1*t115 - mu_2_by_m_d_1*t115 - mu_3_by_m_d_1*t115,
        -mu_1_by_m_d_1*t119 - mu_2_by_m_d_1*t119 - mu_3_by_m_d_1*t119,
        -mu_1_by_m_d_1*t123 + mu_2_by_m_d_1*t208 - mu_3_by_m_d_1*t123,
        -mu_1_by_m_d_1*t127 - mu_2_by_m_d_1*t127 - mu_3_by_m_d_1*t127,
        -mu_1_by_m_d_1*t131 - mu_2_by_m_d_1*t131 + mu_3_by_m_d_1*t209, t225, -t225, t225, t226, -t226, t226,
        t227, -t227, t227, k_r_1, -k_r_1, k_r_1, k_r_2, -k_r_2, k_r_2, k_r_3, -k_r_3, k_r_3, t51, t55, t59,
        t63, t67, t71, D_p_x_1, D_p_y_1, D_p_z_1, t75, t79, t83, t87, t91, D_p_x_2, D_p_y_2, D_p_z_2, t95,
        t99, t103, t107, D_p_x_3, D_p_y_3, D_p_z_3, t111, t115, t119, D_delta_x_1, D_delta_y_1, D_delta_z_1,
        t123, t127, D_delta_x_2, D_delta_y_2, D_delta_z_2, t131, D_delta_x_3, D_delta_y_3, D_delta_z_3, 1, 1,
        1, mu_1_by_m_p*t189 - mu_2_by_m_p*t51 - mu_3_by_m_p*t51,
        mu_1_by_m_p*t190 + mu_2_by_m_p*t191 - mu_3_by_m_p*t55,
        mu_1_by_m_p*t192 - mu_2_by_m_p*t59 + mu_3_by_m_p*t193,
        mu_1_by_m_p*t194 - mu_2_by_m_p*t63 - mu_3_by_m_p*t63,
        mu_1_by_m_p*t195 - mu_2_by_m_p*t67 - mu_3_by_m_p*t67,
        mu_1_by_m_p*t196 - mu_2_by_m_p*t71 - mu_3_by_m_p*t71,
        -mu_1_by_m_p*t75 + mu_2_by_m_p*t197 - mu_3_by_m_p*t75,
        -mu_1_by_m_p*t79 + mu_2_by_m_p*t198 + mu_3_by_m_p*t199,
        -mu_1_by_m_p*t83 + mu_2_by_m_p*t200 - mu_3_by_m_p*t83,
        -mu_1_by_m_p*t87 + mu_2_by_m_p*t201 - mu_3_by_m_p*t87,
        -mu_1_by_m_p*t91 + mu_2_by_m_p*t202 - mu_3_by_m_p*t91,
        -mu_1_by_m_p*t95 - mu_2_by_m_p*t95 + mu_3_by_m_p*t203,
        -mu_1_by_m_p*t99 - mu_2_by_m_p*t99 + mu_3_by_m_p*t204,
        -mu_1_by_m_p*t103 - mu_2_by_m_p*t103 + mu_3_by_m_p*t205,
        -mu_1_by_m_p*t107 - mu_2_by_m_p*t107 + mu_3_by_m_p*t206,
        mu_1_by_m_p*t207 - mu_2_by_m_p*t111 - mu_3_by_m_p*t111,
        -mu_1_by_m_p*t115 - mu_2_by_m_p*t115 - mu_3_by_m_p*t115,
        -mu_1_by_m_p*t119 - mu_2_by_m_p*t119 - mu_3_by_m_p*t119,
        -mu_1_by_m_p*t123 + mu_2_by_m_p*t208 - mu_3_by_m_p*t123,
        -mu_1_by_m_p*t127 - mu_2_by_m_p*t127 - mu_3_by_m_p*t127,
        -mu_1_by_m_p*t131 - mu_2_by_m_p*t131 + mu_3_by_m_p*t209, 1, 1, 1,
    ))
    return M_theta_out, K_theta_out


def geometry_sensitivities(p, parameters, effects):
    """Derivatives of M and K at a fixed pose with respect to parameters that move the arm angles.

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
    M_theta : array, shape (..., 585) [unit of M / unit of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 585) [unit of K / unit of the parameter]
        dK/dtheta.

    Notes
    -----
    Implicit function theorem and chain rule.
    17467 operations; 402222801 with every named value expanded.
    """
    p_x, p_y, p_z = _entries(p, (3,))
    (m_p,) = _entries(parameters.platform_mass, ())
    g_x, g_y, g_z = _entries(parameters.gravity, (3,))
    o_1_x, o_1_y, o_1_z, o_2_x, o_2_y, o_2_z, o_3_x, o_3_y, o_3_z = _entries(parameters.origin, (3, 3))
    a_1_x, a_1_y, a_1_z, a_2_x, a_2_y, a_2_z, a_3_x, a_3_y, a_3_z = _entries(parameters.axis, (3, 3))
    z_1_x, z_1_y, z_1_z, z_2_x, z_2_y, z_2_z, z_3_x, z_3_y, z_3_z = _entries(parameters.zero, (3, 3))
    b_1_x, b_1_y, b_1_z, b_2_x, b_2_y, b_2_z, b_3_x, b_3_y, b_3_z = _entries(parameters.joint, (3, 3))
    L_a_1, L_a_2, L_a_3 = _entries(parameters.arm_length, (3,))
    m_a_1, m_a_2, m_a_3 = _entries(parameters.arm_mass, (3,))
    r_a_1, r_a_2, r_a_3 = _entries(parameters.arm_center, (3,))
    l_d_1, l_d_2, l_d_3 = _entries(parameters.link_length, (3,))
    m_d_1, m_d_2, m_d_3 = _entries(parameters.link_mass, (3,))
    sigma_1, sigma_2, sigma_3 = _entries(parameters.branch, (3,))
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, a_1_x, z_1_x, b_1_x, L_a_1, m_a_1, r_a_1, l_d_1, m_d_1,
        sigma_1, k_C, m_L)
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
    t1 = L_a_1**2
    C_1 = (1/2)*(-l_d_1**2 + r_1_x**2 + r_1_y**2 + r_1_z**2 + t1)/L_a_1
    S_1 = sigma_1*np.sqrt(-C_1**2 + rho2_1)
    t2 = 1.0/rho2_1
    c_1 = t2*(A_1*C_1 - B_1*S_1)
    sn_1 = t2*(A_1*S_1 + B_1*C_1)
    A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z
    B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z
    rho2_2 = A_2**2 + B_2**2
    t3 = L_a_2**2
    C_2 = (1/2)*(-l_d_2**2 + r_2_x**2 + r_2_y**2 + r_2_z**2 + t3)/L_a_2
    S_2 = sigma_2*np.sqrt(-C_2**2 + rho2_2)
    t4 = 1.0/rho2_2
    c_2 = t4*(A_2*C_2 - B_2*S_2)
    sn_2 = t4*(A_2*S_2 + B_2*C_2)
    A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z
    B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z
    rho2_3 = A_3**2 + B_3**2
    t5 = L_a_3**2
    C_3 = (1/2)*(-l_d_3**2 + r_3_x**2 + r_3_y**2 + r_3_z**2 + t5)/L_a_3
    S_3 = sigma_3*np.sqrt(-C_3**2 + rho2_3)
    t6 = 1.0/rho2_3
    c_3 = t6*(A_3*C_3 - B_3*S_3)
    sn_3 = t6*(A_3*S_3 + B_3*C_3)
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
    t7 = L_a_1*d_1_x
    s_1_x = r_1_x - t7
    t8 = L_a_1*d_1_y
    s_1_y = r_1_y - t8
    t9 = L_a_1*d_1_z
    s_1_z = r_1_z - t9
    t10 = L_a_2*d_2_x
    s_2_x = r_2_x - t10
    t11 = L_a_2*d_2_y
    s_2_y = r_2_y - t11
    t12 = L_a_2*d_2_z
    s_2_z = r_2_z - t12
    t13 = L_a_3*d_3_x
    s_3_x = r_3_x - t13
    t14 = L_a_3*d_3_y
    s_3_y = r_3_y - t14
    t15 = L_a_3*d_3_z
    s_3_z = r_3_z - t15
    t16 = L_a_1*t_1_x
    t17 = L_a_1*t_1_y
    t18 = L_a_1*t_1_z
    D_r_1 = s_1_x*t16 + s_1_y*t17 + s_1_z*t18
    t19 = L_a_2*t_2_x
    t20 = L_a_2*t_2_y
    t21 = L_a_2*t_2_z
    D_r_2 = s_2_x*t19 + s_2_y*t20 + s_2_z*t21
    t22 = L_a_3*t_3_x
    t23 = L_a_3*t_3_y
    t24 = L_a_3*t_3_z
    D_r_3 = s_3_x*t22 + s_3_y*t23 + s_3_z*t24
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
    t25 = 1.0/det_D_l
    t26 = A_x_1*t25
    D_p_x_1 = D_r_1*t26
    t27 = A_x_2*t25
    D_p_x_2 = D_r_2*t27
    t28 = A_x_3*t25
    D_p_x_3 = D_r_3*t28
    D_delta_x_1 = l_d_1*t26
    D_delta_x_2 = l_d_2*t27
    D_delta_x_3 = l_d_3*t28
    t29 = A_y_1*t25
    D_p_y_1 = D_r_1*t29
    t30 = A_y_2*t25
    D_p_y_2 = D_r_2*t30
    t31 = A_y_3*t25
    D_p_y_3 = D_r_3*t31
    D_delta_y_1 = l_d_1*t29
    D_delta_y_2 = l_d_2*t30
    D_delta_y_3 = l_d_3*t31
    t32 = A_z_1*t25
    D_p_z_1 = D_r_1*t32
    t33 = A_z_2*t25
    D_p_z_2 = D_r_2*t33
    t34 = A_z_3*t25
    D_p_z_3 = D_r_3*t34
    D_delta_z_1 = l_d_1*t32
    D_delta_z_2 = l_d_2*t33
    D_delta_z_3 = l_d_3*t34
    U_1_x_1 = D_p_x_1 - t16
    U_1_y_1 = D_p_y_1 - t17
    U_1_z_1 = D_p_z_1 - t18
    U_2_x_2 = D_p_x_2 - t19
    U_2_y_2 = D_p_y_2 - t20
    U_2_z_2 = D_p_z_2 - t21
    U_3_x_3 = D_p_x_3 - t22
    U_3_y_3 = D_p_y_3 - t23
    U_3_z_3 = D_p_z_3 - t24
    t35 = (1/2)*m_d_1
    t36 = (1/2)*m_d_2
    t37 = (1/2)*m_d_3
    t38 = m_L + m_p
    t39 = t35 + t36 + t37 + t38
    t40 = g_x*t39
    t41 = g_y*t39
    t42 = g_z*t39
    mu_1 = t25*(-A_x_1*t40 - A_y_1*t41 - A_z_1*t42)
    mu_2 = t25*(-A_x_2*t40 - A_y_2*t41 - A_z_2*t42)
    mu_3 = t25*(-A_x_3*t40 - A_y_3*t41 - A_z_3*t42)
    t43 = 1.0/D_r_1
    theta_1_by_b_1_x = s_1_x*t43
    s_1_x_by_b_1_x = -t16*theta_1_by_b_1_x + 1
    s_1_y_by_b_1_x = -t17*theta_1_by_b_1_x
    s_1_z_by_b_1_x = -t18*theta_1_by_b_1_x
    t44 = s_1_x*t7
    t45 = s_1_y*t8
    t46 = s_1_z*t9
    t47 = t_1_y**2
    t48 = t1*theta_1_by_b_1_x
    t49 = t_1_z**2
    t50 = (
        -D_p_x_1*s_1_x_by_b_1_x - D_p_y_1*s_1_y_by_b_1_x - D_p_z_1*s_1_z_by_b_1_x + L_a_1*s_1_x_by_b_1_x*t_1_x
        - t44*theta_1_by_b_1_x - t45*theta_1_by_b_1_x - t46*theta_1_by_b_1_x - t47*t48 - t48*t49
    )
    D_p_x_1_by_b_1_x = t26*t50
    D_p_y_1_by_b_1_x = t29*t50
    D_p_z_1_by_b_1_x = t32*t50
    t51 = -D_p_x_2*s_1_x_by_b_1_x - D_p_y_2*s_1_y_by_b_1_x - D_p_z_2*s_1_z_by_b_1_x
    D_p_x_2_by_b_1_x = t26*t51
    D_p_y_2_by_b_1_x = t29*t51
    D_p_z_2_by_b_1_x = t32*t51
    t52 = -D_p_x_3*s_1_x_by_b_1_x - D_p_y_3*s_1_y_by_b_1_x - D_p_z_3*s_1_z_by_b_1_x
    D_p_x_3_by_b_1_x = t26*t52
    D_p_y_3_by_b_1_x = t29*t52
    D_p_z_3_by_b_1_x = t32*t52
    t53 = -D_delta_x_1*s_1_x_by_b_1_x - D_delta_y_1*s_1_y_by_b_1_x - D_delta_z_1*s_1_z_by_b_1_x
    D_delta_x_1_by_b_1_x = t26*t53
    D_delta_y_1_by_b_1_x = t29*t53
    D_delta_z_1_by_b_1_x = t32*t53
    t54 = -D_delta_x_2*s_1_x_by_b_1_x - D_delta_y_2*s_1_y_by_b_1_x - D_delta_z_2*s_1_z_by_b_1_x
    D_delta_x_2_by_b_1_x = t26*t54
    D_delta_y_2_by_b_1_x = t29*t54
    D_delta_z_2_by_b_1_x = t32*t54
    t55 = -D_delta_x_3*s_1_x_by_b_1_x - D_delta_y_3*s_1_y_by_b_1_x - D_delta_z_3*s_1_z_by_b_1_x
    D_delta_x_3_by_b_1_x = t26*t55
    D_delta_y_3_by_b_1_x = t29*t55
    D_delta_z_3_by_b_1_x = t32*t55
    t56 = mu_1*s_1_x_by_b_1_x
    t57 = mu_1*s_1_y_by_b_1_x
    t58 = mu_1*s_1_z_by_b_1_x
    mu_1_by_b_1_x = t25*(-A_x_1*t56 - A_y_1*t57 - A_z_1*t58)
    mu_2_by_b_1_x = t25*(-A_x_2*t56 - A_y_2*t57 - A_z_2*t58)
    mu_3_by_b_1_x = t25*(-A_x_3*t56 - A_y_3*t57 - A_z_3*t58)
    theta_1_by_b_1_y = s_1_y*t43
    s_1_x_by_b_1_y = -t16*theta_1_by_b_1_y
    s_1_y_by_b_1_y = -t17*theta_1_by_b_1_y + 1
    s_1_z_by_b_1_y = -t18*theta_1_by_b_1_y
    t59 = t_1_x**2
    t60 = t1*theta_1_by_b_1_y
    t61 = (
        -D_p_x_1*s_1_x_by_b_1_y - D_p_y_1*s_1_y_by_b_1_y - D_p_z_1*s_1_z_by_b_1_y + L_a_1*s_1_y_by_b_1_y*t_1_y
        - t44*theta_1_by_b_1_y - t45*theta_1_by_b_1_y - t46*theta_1_by_b_1_y - t49*t60 - t59*t60
    )
    D_p_x_1_by_b_1_y = t26*t61
    D_p_y_1_by_b_1_y = t29*t61
    D_p_z_1_by_b_1_y = t32*t61
    t62 = -D_p_x_2*s_1_x_by_b_1_y - D_p_y_2*s_1_y_by_b_1_y - D_p_z_2*s_1_z_by_b_1_y
    D_p_x_2_by_b_1_y = t26*t62
    D_p_y_2_by_b_1_y = t29*t62
    D_p_z_2_by_b_1_y = t32*t62
    t63 = -D_p_x_3*s_1_x_by_b_1_y - D_p_y_3*s_1_y_by_b_1_y - D_p_z_3*s_1_z_by_b_1_y
    D_p_x_3_by_b_1_y = t26*t63
    D_p_y_3_by_b_1_y = t29*t63
    D_p_z_3_by_b_1_y = t32*t63
    t64 = -D_delta_x_1*s_1_x_by_b_1_y - D_delta_y_1*s_1_y_by_b_1_y - D_delta_z_1*s_1_z_by_b_1_y
    D_delta_x_1_by_b_1_y = t26*t64
    D_delta_y_1_by_b_1_y = t29*t64
    D_delta_z_1_by_b_1_y = t32*t64
    t65 = -D_delta_x_2*s_1_x_by_b_1_y - D_delta_y_2*s_1_y_by_b_1_y - D_delta_z_2*s_1_z_by_b_1_y
    D_delta_x_2_by_b_1_y = t26*t65
    D_delta_y_2_by_b_1_y = t29*t65
    D_delta_z_2_by_b_1_y = t32*t65
    t66 = -D_delta_x_3*s_1_x_by_b_1_y - D_delta_y_3*s_1_y_by_b_1_y - D_delta_z_3*s_1_z_by_b_1_y
    D_delta_x_3_by_b_1_y = t26*t66
    D_delta_y_3_by_b_1_y = t29*t66
    D_delta_z_3_by_b_1_y = t32*t66
    t67 = mu_1*s_1_x_by_b_1_y
    t68 = mu_1*s_1_y_by_b_1_y
    t69 = mu_1*s_1_z_by_b_1_y
    mu_1_by_b_1_y = t25*(-A_x_1*t67 - A_y_1*t68 - A_z_1*t69)
    mu_2_by_b_1_y = t25*(-A_x_2*t67 - A_y_2*t68 - A_z_2*t69)
    mu_3_by_b_1_y = t25*(-A_x_3*t67 - A_y_3*t68 - A_z_3*t69)
    theta_1_by_b_1_z = s_1_z*t43
    s_1_x_by_b_1_z = -t16*theta_1_by_b_1_z
    s_1_y_by_b_1_z = -t17*theta_1_by_b_1_z
    s_1_z_by_b_1_z = -t18*theta_1_by_b_1_z + 1
    t70 = t1*theta_1_by_b_1_z
    t71 = (
        -D_p_x_1*s_1_x_by_b_1_z - D_p_y_1*s_1_y_by_b_1_z - D_p_z_1*s_1_z_by_b_1_z + L_a_1*s_1_z_by_b_1_z*t_1_z
        - t44*theta_1_by_b_1_z - t45*theta_1_by_b_1_z - t46*theta_1_by_b_1_z - t47*t70 - t59*t70
    )
    D_p_x_1_by_b_1_z = t26*t71
    D_p_y_1_by_b_1_z = t29*t71
    D_p_z_1_by_b_1_z = t32*t71
    t72 = -D_p_x_2*s_1_x_by_b_1_z - D_p_y_2*s_1_y_by_b_1_z - D_p_z_2*s_1_z_by_b_1_z
    D_p_x_2_by_b_1_z = t26*t72
    D_p_y_2_by_b_1_z = t29*t72
    D_p_z_2_by_b_1_z = t32*t72
    t73 = -D_p_x_3*s_1_x_by_b_1_z - D_p_y_3*s_1_y_by_b_1_z - D_p_z_3*s_1_z_by_b_1_z
    D_p_x_3_by_b_1_z = t26*t73
    D_p_y_3_by_b_1_z = t29*t73
    D_p_z_3_by_b_1_z = t32*t73
    t74 = -D_delta_x_1*s_1_x_by_b_1_z - D_delta_y_1*s_1_y_by_b_1_z - D_delta_z_1*s_1_z_by_b_1_z
    D_delta_x_1_by_b_1_z = t26*t74
    D_delta_y_1_by_b_1_z = t29*t74
    D_delta_z_1_by_b_1_z = t32*t74
    t75 = -D_delta_x_2*s_1_x_by_b_1_z - D_delta_y_2*s_1_y_by_b_1_z - D_delta_z_2*s_1_z_by_b_1_z
    D_delta_x_2_by_b_1_z = t26*t75
    D_delta_y_2_by_b_1_z = t29*t75
    D_delta_z_2_by_b_1_z = t32*t75
    t76 = -D_delta_x_3*s_1_x_by_b_1_z - D_delta_y_3*s_1_y_by_b_1_z - D_delta_z_3*s_1_z_by_b_1_z
    D_delta_x_3_by_b_1_z = t26*t76
    D_delta_y_3_by_b_1_z = t29*t76
    D_delta_z_3_by_b_1_z = t32*t76
    t77 = mu_1*s_1_x_by_b_1_z
    t78 = mu_1*s_1_y_by_b_1_z
    t79 = mu_1*s_1_z_by_b_1_z
    mu_1_by_b_1_z = t25*(-A_x_1*t77 - A_y_1*t78 - A_z_1*t79)
    mu_2_by_b_1_z = t25*(-A_x_2*t77 - A_y_2*t78 - A_z_2*t79)
    mu_3_by_b_1_z = t25*(-A_x_3*t77 - A_y_3*t78 - A_z_3*t79)
    t80 = 1.0/D_r_2
    theta_2_by_b_2_x = s_2_x*t80
    s_2_x_by_b_2_x = -t19*theta_2_by_b_2_x + 1
    s_2_y_by_b_2_x = -t20*theta_2_by_b_2_x
    s_2_z_by_b_2_x = -t21*theta_2_by_b_2_x
    t81 = -D_p_x_1*s_2_x_by_b_2_x - D_p_y_1*s_2_y_by_b_2_x - D_p_z_1*s_2_z_by_b_2_x
    D_p_x_1_by_b_2_x = t27*t81
    D_p_y_1_by_b_2_x = t30*t81
    D_p_z_1_by_b_2_x = t33*t81
    t82 = s_2_x*t10
    t83 = s_2_y*t11
    t84 = s_2_z*t12
    t85 = t_2_y**2
    t86 = t3*theta_2_by_b_2_x
    t87 = t_2_z**2
    t88 = (
        -D_p_x_2*s_2_x_by_b_2_x - D_p_y_2*s_2_y_by_b_2_x - D_p_z_2*s_2_z_by_b_2_x + L_a_2*s_2_x_by_b_2_x*t_2_x
        - t82*theta_2_by_b_2_x - t83*theta_2_by_b_2_x - t84*theta_2_by_b_2_x - t85*t86 - t86*t87
    )
    D_p_x_2_by_b_2_x = t27*t88
    D_p_y_2_by_b_2_x = t30*t88
    D_p_z_2_by_b_2_x = t33*t88
    t89 = -D_p_x_3*s_2_x_by_b_2_x - D_p_y_3*s_2_y_by_b_2_x - D_p_z_3*s_2_z_by_b_2_x
    D_p_x_3_by_b_2_x = t27*t89
    D_p_y_3_by_b_2_x = t30*t89
    D_p_z_3_by_b_2_x = t33*t89
    t90 = -D_delta_x_1*s_2_x_by_b_2_x - D_delta_y_1*s_2_y_by_b_2_x - D_delta_z_1*s_2_z_by_b_2_x
    D_delta_x_1_by_b_2_x = t27*t90
    D_delta_y_1_by_b_2_x = t30*t90
    D_delta_z_1_by_b_2_x = t33*t90
    t91 = -D_delta_x_2*s_2_x_by_b_2_x - D_delta_y_2*s_2_y_by_b_2_x - D_delta_z_2*s_2_z_by_b_2_x
    D_delta_x_2_by_b_2_x = t27*t91
    D_delta_y_2_by_b_2_x = t30*t91
    D_delta_z_2_by_b_2_x = t33*t91
    t92 = -D_delta_x_3*s_2_x_by_b_2_x - D_delta_y_3*s_2_y_by_b_2_x - D_delta_z_3*s_2_z_by_b_2_x
    D_delta_x_3_by_b_2_x = t27*t92
    D_delta_y_3_by_b_2_x = t30*t92
    D_delta_z_3_by_b_2_x = t33*t92
    t93 = mu_2*s_2_x_by_b_2_x
    t94 = mu_2*s_2_y_by_b_2_x
    t95 = mu_2*s_2_z_by_b_2_x
    mu_1_by_b_2_x = t25*(-A_x_1*t93 - A_y_1*t94 - A_z_1*t95)
    mu_2_by_b_2_x = t25*(-A_x_2*t93 - A_y_2*t94 - A_z_2*t95)
    mu_3_by_b_2_x = t25*(-A_x_3*t93 - A_y_3*t94 - A_z_3*t95)
    theta_2_by_b_2_y = s_2_y*t80
    s_2_x_by_b_2_y = -t19*theta_2_by_b_2_y
    s_2_y_by_b_2_y = -t20*theta_2_by_b_2_y + 1
    s_2_z_by_b_2_y = -t21*theta_2_by_b_2_y
    t96 = -D_p_x_1*s_2_x_by_b_2_y - D_p_y_1*s_2_y_by_b_2_y - D_p_z_1*s_2_z_by_b_2_y
    D_p_x_1_by_b_2_y = t27*t96
    D_p_y_1_by_b_2_y = t30*t96
    D_p_z_1_by_b_2_y = t33*t96
    t97 = t_2_x**2
    t98 = t3*theta_2_by_b_2_y
    t99 = (
        -D_p_x_2*s_2_x_by_b_2_y - D_p_y_2*s_2_y_by_b_2_y - D_p_z_2*s_2_z_by_b_2_y + L_a_2*s_2_y_by_b_2_y*t_2_y
        - t82*theta_2_by_b_2_y - t83*theta_2_by_b_2_y - t84*theta_2_by_b_2_y - t87*t98 - t97*t98
    )
    D_p_x_2_by_b_2_y = t27*t99
    D_p_y_2_by_b_2_y = t30*t99
    D_p_z_2_by_b_2_y = t33*t99
    t100 = -D_p_x_3*s_2_x_by_b_2_y - D_p_y_3*s_2_y_by_b_2_y - D_p_z_3*s_2_z_by_b_2_y
    D_p_x_3_by_b_2_y = t100*t27
    D_p_y_3_by_b_2_y = t100*t30
    D_p_z_3_by_b_2_y = t100*t33
    t101 = -D_delta_x_1*s_2_x_by_b_2_y - D_delta_y_1*s_2_y_by_b_2_y - D_delta_z_1*s_2_z_by_b_2_y
    D_delta_x_1_by_b_2_y = t101*t27
    D_delta_y_1_by_b_2_y = t101*t30
    D_delta_z_1_by_b_2_y = t101*t33
    t102 = -D_delta_x_2*s_2_x_by_b_2_y - D_delta_y_2*s_2_y_by_b_2_y - D_delta_z_2*s_2_z_by_b_2_y
    D_delta_x_2_by_b_2_y = t102*t27
    D_delta_y_2_by_b_2_y = t102*t30
    D_delta_z_2_by_b_2_y = t102*t33
    t103 = -D_delta_x_3*s_2_x_by_b_2_y - D_delta_y_3*s_2_y_by_b_2_y - D_delta_z_3*s_2_z_by_b_2_y
    D_delta_x_3_by_b_2_y = t103*t27
    D_delta_y_3_by_b_2_y = t103*t30
    D_delta_z_3_by_b_2_y = t103*t33
    t104 = mu_2*s_2_x_by_b_2_y
    t105 = mu_2*s_2_y_by_b_2_y
    t106 = mu_2*s_2_z_by_b_2_y
    mu_1_by_b_2_y = t25*(-A_x_1*t104 - A_y_1*t105 - A_z_1*t106)
    mu_2_by_b_2_y = t25*(-A_x_2*t104 - A_y_2*t105 - A_z_2*t106)
    mu_3_by_b_2_y = t25*(-A_x_3*t104 - A_y_3*t105 - A_z_3*t106)
    theta_2_by_b_2_z = s_2_z*t80
    s_2_x_by_b_2_z = -t19*theta_2_by_b_2_z
    s_2_y_by_b_2_z = -t20*theta_2_by_b_2_z
    s_2_z_by_b_2_z = -t21*theta_2_by_b_2_z + 1
    t107 = -D_p_x_1*s_2_x_by_b_2_z - D_p_y_1*s_2_y_by_b_2_z - D_p_z_1*s_2_z_by_b_2_z
    D_p_x_1_by_b_2_z = t107*t27
    D_p_y_1_by_b_2_z = t107*t30
    D_p_z_1_by_b_2_z = t107*t33
    t108 = t3*theta_2_by_b_2_z
    t109 = (
        -D_p_x_2*s_2_x_by_b_2_z - D_p_y_2*s_2_y_by_b_2_z - D_p_z_2*s_2_z_by_b_2_z + L_a_2*s_2_z_by_b_2_z*t_2_z
        - t108*t85 - t108*t97 - t82*theta_2_by_b_2_z - t83*theta_2_by_b_2_z - t84*theta_2_by_b_2_z
    )
    D_p_x_2_by_b_2_z = t109*t27
    D_p_y_2_by_b_2_z = t109*t30
    D_p_z_2_by_b_2_z = t109*t33
    t110 = -D_p_x_3*s_2_x_by_b_2_z - D_p_y_3*s_2_y_by_b_2_z - D_p_z_3*s_2_z_by_b_2_z
    D_p_x_3_by_b_2_z = t110*t27
    D_p_y_3_by_b_2_z = t110*t30
    D_p_z_3_by_b_2_z = t110*t33
    t111 = -D_delta_x_1*s_2_x_by_b_2_z - D_delta_y_1*s_2_y_by_b_2_z - D_delta_z_1*s_2_z_by_b_2_z
    D_delta_x_1_by_b_2_z = t111*t27
    D_delta_y_1_by_b_2_z = t111*t30
    D_delta_z_1_by_b_2_z = t111*t33
    t112 = -D_delta_x_2*s_2_x_by_b_2_z - D_delta_y_2*s_2_y_by_b_2_z - D_delta_z_2*s_2_z_by_b_2_z
    D_delta_x_2_by_b_2_z = t112*t27
    D_delta_y_2_by_b_2_z = t112*t30
    D_delta_z_2_by_b_2_z = t112*t33
    t113 = -D_delta_x_3*s_2_x_by_b_2_z - D_delta_y_3*s_2_y_by_b_2_z - D_delta_z_3*s_2_z_by_b_2_z
    D_delta_x_3_by_b_2_z = t113*t27
    D_delta_y_3_by_b_2_z = t113*t30
    D_delta_z_3_by_b_2_z = t113*t33
    t114 = mu_2*s_2_x_by_b_2_z
    t115 = mu_2*s_2_y_by_b_2_z
    t116 = mu_2*s_2_z_by_b_2_z
    mu_1_by_b_2_z = t25*(-A_x_1*t114 - A_y_1*t115 - A_z_1*t116)
    mu_2_by_b_2_z = t25*(-A_x_2*t114 - A_y_2*t115 - A_z_2*t116)
    mu_3_by_b_2_z = t25*(-A_x_3*t114 - A_y_3*t115 - A_z_3*t116)
    t117 = 1.0/D_r_3
    theta_3_by_b_3_x = s_3_x*t117
    s_3_x_by_b_3_x = -t22*theta_3_by_b_3_x + 1
    s_3_y_by_b_3_x = -t23*theta_3_by_b_3_x
    s_3_z_by_b_3_x = -t24*theta_3_by_b_3_x
    t118 = -D_p_x_1*s_3_x_by_b_3_x - D_p_y_1*s_3_y_by_b_3_x - D_p_z_1*s_3_z_by_b_3_x
    D_p_x_1_by_b_3_x = t118*t28
    D_p_y_1_by_b_3_x = t118*t31
    D_p_z_1_by_b_3_x = t118*t34
    t119 = -D_p_x_2*s_3_x_by_b_3_x - D_p_y_2*s_3_y_by_b_3_x - D_p_z_2*s_3_z_by_b_3_x
    D_p_x_2_by_b_3_x = t119*t28
    D_p_y_2_by_b_3_x = t119*t31
    D_p_z_2_by_b_3_x = t119*t34
    t120 = s_3_x*t13
    t121 = s_3_y*t14
    t122 = s_3_z*t15
    t123 = t_3_y**2
    t124 = t5*theta_3_by_b_3_x
    t125 = t_3_z**2
    t126 = (
        -D_p_x_3*s_3_x_by_b_3_x - D_p_y_3*s_3_y_by_b_3_x - D_p_z_3*s_3_z_by_b_3_x + L_a_3*s_3_x_by_b_3_x*t_3_x
        - t120*theta_3_by_b_3_x - t121*theta_3_by_b_3_x - t122*theta_3_by_b_3_x - t123*t124 - t124*t125
    )
    D_p_x_3_by_b_3_x = t126*t28
    D_p_y_3_by_b_3_x = t126*t31
    D_p_z_3_by_b_3_x = t126*t34
    t127 = -D_delta_x_1*s_3_x_by_b_3_x - D_delta_y_1*s_3_y_by_b_3_x - D_delta_z_1*s_3_z_by_b_3_x
    D_delta_x_1_by_b_3_x = t127*t28
    D_delta_y_1_by_b_3_x = t127*t31
    D_delta_z_1_by_b_3_x = t127*t34
    t128 = -D_delta_x_2*s_3_x_by_b_3_x - D_delta_y_2*s_3_y_by_b_3_x - D_delta_z_2*s_3_z_by_b_3_x
    D_delta_x_2_by_b_3_x = t128*t28
    D_delta_y_2_by_b_3_x = t128*t31
    D_delta_z_2_by_b_3_x = t128*t34
    t129 = -D_delta_x_3*s_3_x_by_b_3_x - D_delta_y_3*s_3_y_by_b_3_x - D_delta_z_3*s_3_z_by_b_3_x
    D_delta_x_3_by_b_3_x = t129*t28
    D_delta_y_3_by_b_3_x = t129*t31
    D_delta_z_3_by_b_3_x = t129*t34
    t130 = mu_3*s_3_x_by_b_3_x
    t131 = mu_3*s_3_y_by_b_3_x
    t132 = mu_3*s_3_z_by_b_3_x
    mu_1_by_b_3_x = t25*(-A_x_1*t130 - A_y_1*t131 - A_z_1*t132)
    mu_2_by_b_3_x = t25*(-A_x_2*t130 - A_y_2*t131 - A_z_2*t132)
    mu_3_by_b_3_x = t25*(-A_x_3*t130 - A_y_3*t131 - A_z_3*t132)
    theta_3_by_b_3_y = s_3_y*t117
    s_3_x_by_b_3_y = -t22*theta_3_by_b_3_y
    s_3_y_by_b_3_y = -t23*theta_3_by_b_3_y + 1
    s_3_z_by_b_3_y = -t24*theta_3_by_b_3_y
    t133 = -D_p_x_1*s_3_x_by_b_3_y - D_p_y_1*s_3_y_by_b_3_y - D_p_z_1*s_3_z_by_b_3_y
    D_p_x_1_by_b_3_y = t133*t28
    D_p_y_1_by_b_3_y = t133*t31
    D_p_z_1_by_b_3_y = t133*t34
    t134 = -D_p_x_2*s_3_x_by_b_3_y - D_p_y_2*s_3_y_by_b_3_y - D_p_z_2*s_3_z_by_b_3_y
    D_p_x_2_by_b_3_y = t134*t28
    D_p_y_2_by_b_3_y = t134*t31
    D_p_z_2_by_b_3_y = t134*t34
    t135 = t_3_x**2
    t136 = t5*theta_3_by_b_3_y
    t137 = (
        -D_p_x_3*s_3_x_by_b_3_y - D_p_y_3*s_3_y_by_b_3_y - D_p_z_3*s_3_z_by_b_3_y + L_a_3*s_3_y_by_b_3_y*t_3_y
        - t120*theta_3_by_b_3_y - t121*theta_3_by_b_3_y - t122*theta_3_by_b_3_y - t125*t136 - t135*t136
    )
    D_p_x_3_by_b_3_y = t137*t28
    D_p_y_3_by_b_3_y = t137*t31
    D_p_z_3_by_b_3_y = t137*t34
    t138 = -D_delta_x_1*s_3_x_by_b_3_y - D_delta_y_1*s_3_y_by_b_3_y - D_delta_z_1*s_3_z_by_b_3_y
    D_delta_x_1_by_b_3_y = t138*t28
    D_delta_y_1_by_b_3_y = t138*t31
    D_delta_z_1_by_b_3_y = t138*t34
    t139 = -D_delta_x_2*s_3_x_by_b_3_y - D_delta_y_2*s_3_y_by_b_3_y - D_delta_z_2*s_3_z_by_b_3_y
    D_delta_x_2_by_b_3_y = t139*t28
    D_delta_y_2_by_b_3_y = t139*t31
    D_delta_z_2_by_b_3_y = t139*t34
    t140 = -D_delta_x_3*s_3_x_by_b_3_y - D_delta_y_3*s_3_y_by_b_3_y - D_delta_z_3*s_3_z_by_b_3_y
    D_delta_x_3_by_b_3_y = t140*t28
    D_delta_y_3_by_b_3_y = t140*t31
    D_delta_z_3_by_b_3_y = t140*t34
    t141 = mu_3*s_3_x_by_b_3_y
    t142 = mu_3*s_3_y_by_b_3_y
    t143 = mu_3*s_3_z_by_b_3_y
    mu_1_by_b_3_y = t25*(-A_x_1*t141 - A_y_1*t142 - A_z_1*t143)
    mu_2_by_b_3_y = t25*(-A_x_2*t141 - A_y_2*t142 - A_z_2*t143)
    mu_3_by_b_3_y = t25*(-A_x_3*t141 - A_y_3*t142 - A_z_3*t143)
    theta_3_by_b_3_z = s_3_z*t117
    s_3_x_by_b_3_z = -t22*theta_3_by_b_3_z
    s_3_y_by_b_3_z = -t23*theta_3_by_b_3_z
    s_3_z_by_b_3_z = -t24*theta_3_by_b_3_z + 1
    t144 = -D_p_x_1*s_3_x_by_b_3_z - D_p_y_1*s_3_y_by_b_3_z - D_p_z_1*s_3_z_by_b_3_z
    D_p_x_1_by_b_3_z = t144*t28
    D_p_y_1_by_b_3_z = t144*t31
    D_p_z_1_by_b_3_z = t144*t34
    t145 = -D_p_x_2*s_3_x_by_b_3_z - D_p_y_2*s_3_y_by_b_3_z - D_p_z_2*s_3_z_by_b_3_z
    D_p_x_2_by_b_3_z = t145*t28
    D_p_y_2_by_b_3_z = t145*t31
    D_p_z_2_by_b_3_z = t145*t34
    t146 = t5*theta_3_by_b_3_z
    t147 = (
        -D_p_x_3*s_3_x_by_b_3_z - D_p_y_3*s_3_y_by_b_3_z - D_p_z_3*s_3_z_by_b_3_z + L_a_3*s_3_z_by_b_3_z*t_3_z
        - t120*theta_3_by_b_3_z - t121*theta_3_by_b_3_z - t122*theta_3_by_b_3_z - t123*t146 - t135*t146
    )
    D_p_x_3_by_b_3_z = t147*t28
    D_p_y_3_by_b_3_z = t147*t31
    D_p_z_3_by_b_3_z = t147*t34
    t148 = -D_delta_x_1*s_3_x_by_b_3_z - D_delta_y_1*s_3_y_by_b_3_z - D_delta_z_1*s_3_z_by_b_3_z
    D_delta_x_1_by_b_3_z = t148*t28
    D_delta_y_1_by_b_3_z = t148*t31
    D_delta_z_1_by_b_3_z = t148*t34
    t149 = -D_delta_x_2*s_3_x_by_b_3_z - D_delta_y_2*s_3_y_by_b_3_z - D_delta_z_2*s_3_z_by_b_3_z
    D_delta_x_2_by_b_3_z = t149*t28
    D_delta_y_2_by_b_3_z = t149*t31
    D_delta_z_2_by_b_3_z = t149*t34
    t150 = -D_delta_x_3*s_3_x_by_b_3_z - D_delta_y_3*s_3_y_by_b_3_z - D_delta_z_3*s_3_z_by_b_3_z
    D_delta_x_3_by_b_3_z = t150*t28
    D_delta_y_3_by_b_3_z = t150*t31
    D_delta_z_3_by_b_3_z = t150*t34
    t151 = mu_3*s_3_x_by_b_3_z
    t152 = mu_3*s_3_y_by_b_3_z
    t153 = mu_3*s_3_z_by_b_3_z
    mu_1_by_b_3_z = t25*(-A_x_1*t151 - A_y_1*t152 - A_z_1*t153)
    mu_2_by_b_3_z = t25*(-A_x_2*t151 - A_y_2*t152 - A_z_2*t153)
    mu_3_by_b_3_z = t25*(-A_x_3*t151 - A_y_3*t152 - A_z_3*t153)
    t154 = d_1_x*s_1_x
    t155 = d_1_y*s_1_y
    t156 = d_1_z*s_1_z
    theta_1_by_L_a_1 = t43*(-t154 - t155 - t156)
    s_1_x_by_L_a_1 = -d_1_x - t16*theta_1_by_L_a_1
    s_1_y_by_L_a_1 = -d_1_y - t17*theta_1_by_L_a_1
    s_1_z_by_L_a_1 = -d_1_z - t18*theta_1_by_L_a_1
    t157 = (
        -D_p_x_1*s_1_x_by_L_a_1 - D_p_y_1*s_1_y_by_L_a_1 - D_p_z_1*s_1_z_by_L_a_1 + L_a_1*s_1_x_by_L_a_1*t_1_x
        + L_a_1*s_1_y_by_L_a_1*t_1_y + L_a_1*s_1_z_by_L_a_1*t_1_z + s_1_x*t_1_x + s_1_y*t_1_y + s_1_z*t_1_z
        - t44*theta_1_by_L_a_1 - t45*theta_1_by_L_a_1 - t46*theta_1_by_L_a_1
    )
    D_p_x_1_by_L_a_1 = t157*t26
    D_p_y_1_by_L_a_1 = t157*t29
    D_p_z_1_by_L_a_1 = t157*t32
    t158 = -D_p_x_2*s_1_x_by_L_a_1 - D_p_y_2*s_1_y_by_L_a_1 - D_p_z_2*s_1_z_by_L_a_1
    D_p_x_2_by_L_a_1 = t158*t26
    D_p_y_2_by_L_a_1 = t158*t29
    D_p_z_2_by_L_a_1 = t158*t32
    t159 = -D_p_x_3*s_1_x_by_L_a_1 - D_p_y_3*s_1_y_by_L_a_1 - D_p_z_3*s_1_z_by_L_a_1
    D_p_x_3_by_L_a_1 = t159*t26
    D_p_y_3_by_L_a_1 = t159*t29
    D_p_z_3_by_L_a_1 = t159*t32
    t160 = -D_delta_x_1*s_1_x_by_L_a_1 - D_delta_y_1*s_1_y_by_L_a_1 - D_delta_z_1*s_1_z_by_L_a_1
    D_delta_x_1_by_L_a_1 = t160*t26
    D_delta_y_1_by_L_a_1 = t160*t29
    D_delta_z_1_by_L_a_1 = t160*t32
    t161 = -D_delta_x_2*s_1_x_by_L_a_1 - D_delta_y_2*s_1_y_by_L_a_1 - D_delta_z_2*s_1_z_by_L_a_1
    D_delta_x_2_by_L_a_1 = t161*t26
    D_delta_y_2_by_L_a_1 = t161*t29
    D_delta_z_2_by_L_a_1 = t161*t32
    t162 = -D_delta_x_3*s_1_x_by_L_a_1 - D_delta_y_3*s_1_y_by_L_a_1 - D_delta_z_3*s_1_z_by_L_a_1
    D_delta_x_3_by_L_a_1 = t162*t26
    D_delta_y_3_by_L_a_1 = t162*t29
    D_delta_z_3_by_L_a_1 = t162*t32
    t163 = mu_1*s_1_x_by_L_a_1
    t164 = mu_1*s_1_y_by_L_a_1
    t165 = mu_1*s_1_z_by_L_a_1
    mu_1_by_L_a_1 = t25*(-A_x_1*t163 - A_y_1*t164 - A_z_1*t165)
    mu_2_by_L_a_1 = t25*(-A_x_2*t163 - A_y_2*t164 - A_z_2*t165)
    mu_3_by_L_a_1 = t25*(-A_x_3*t163 - A_y_3*t164 - A_z_3*t165)
    t166 = d_2_x*s_2_x
    t167 = d_2_y*s_2_y
    t168 = d_2_z*s_2_z
    theta_2_by_L_a_2 = t80*(-t166 - t167 - t168)
    s_2_x_by_L_a_2 = -d_2_x - t19*theta_2_by_L_a_2
    s_2_y_by_L_a_2 = -d_2_y - t20*theta_2_by_L_a_2
    s_2_z_by_L_a_2 = -d_2_z - t21*theta_2_by_L_a_2
    t169 = -D_p_x_1*s_2_x_by_L_a_2 - D_p_y_1*s_2_y_by_L_a_2 - D_p_z_1*s_2_z_by_L_a_2
    D_p_x_1_by_L_a_2 = t169*t27
    D_p_y_1_by_L_a_2 = t169*t30
    D_p_z_1_by_L_a_2 = t169*t33
    t170 = (
        -D_p_x_2*s_2_x_by_L_a_2 - D_p_y_2*s_2_y_by_L_a_2 - D_p_z_2*s_2_z_by_L_a_2 + L_a_2*s_2_x_by_L_a_2*t_2_x
        + L_a_2*s_2_y_by_L_a_2*t_2_y + L_a_2*s_2_z_by_L_a_2*t_2_z + s_2_x*t_2_x + s_2_y*t_2_y + s_2_z*t_2_z
        - t82*theta_2_by_L_a_2 - t83*theta_2_by_L_a_2 - t84*theta_2_by_L_a_2
    )
    D_p_x_2_by_L_a_2 = t170*t27
    D_p_y_2_by_L_a_2 = t170*t30
    D_p_z_2_by_L_a_2 = t170*t33
    t171 = -D_p_x_3*s_2_x_by_L_a_2 - D_p_y_3*s_2_y_by_L_a_2 - D_p_z_3*s_2_z_by_L_a_2
    D_p_x_3_by_L_a_2 = t171*t27
    D_p_y_3_by_L_a_2 = t171*t30
    D_p_z_3_by_L_a_2 = t171*t33
    t172 = -D_delta_x_1*s_2_x_by_L_a_2 - D_delta_y_1*s_2_y_by_L_a_2 - D_delta_z_1*s_2_z_by_L_a_2
    D_delta_x_1_by_L_a_2 = t172*t27
    D_delta_y_1_by_L_a_2 = t172*t30
    D_delta_z_1_by_L_a_2 = t172*t33
    t173 = -D_delta_x_2*s_2_x_by_L_a_2 - D_delta_y_2*s_2_y_by_L_a_2 - D_delta_z_2*s_2_z_by_L_a_2
    D_delta_x_2_by_L_a_2 = t173*t27
    D_delta_y_2_by_L_a_2 = t173*t30
    D_delta_z_2_by_L_a_2 = t173*t33
    t174 = -D_delta_x_3*s_2_x_by_L_a_2 - D_delta_y_3*s_2_y_by_L_a_2 - D_delta_z_3*s_2_z_by_L_a_2
    D_delta_x_3_by_L_a_2 = t174*t27
    D_delta_y_3_by_L_a_2 = t174*t30
    D_delta_z_3_by_L_a_2 = t174*t33
    t175 = mu_2*s_2_x_by_L_a_2
    t176 = mu_2*s_2_y_by_L_a_2
    t177 = mu_2*s_2_z_by_L_a_2
    mu_1_by_L_a_2 = t25*(-A_x_1*t175 - A_y_1*t176 - A_z_1*t177)
    mu_2_by_L_a_2 = t25*(-A_x_2*t175 - A_y_2*t176 - A_z_2*t177)
    mu_3_by_L_a_2 = t25*(-A_x_3*t175 - A_y_3*t176 - A_z_3*t177)
    t178 = d_3_x*s_3_x
    t179 = d_3_y*s_3_y
    t180 = d_3_z*s_3_z
    theta_3_by_L_a_3 = t117*(-t178 - t179 - t180)
    s_3_x_by_L_a_3 = -d_3_x - t22*theta_3_by_L_a_3
    s_3_y_by_L_a_3 = -d_3_y - t23*theta_3_by_L_a_3
    s_3_z_by_L_a_3 = -d_3_z - t24*theta_3_by_L_a_3
    t181 = -D_p_x_1*s_3_x_by_L_a_3 - D_p_y_1*s_3_y_by_L_a_3 - D_p_z_1*s_3_z_by_L_a_3
    D_p_x_1_by_L_a_3 = t181*t28
    D_p_y_1_by_L_a_3 = t181*t31
    D_p_z_1_by_L_a_3 = t181*t34
    t182 = -D_p_x_2*s_3_x_by_L_a_3 - D_p_y_2*s_3_y_by_L_a_3 - D_p_z_2*s_3_z_by_L_a_3
    D_p_x_2_by_L_a_3 = t182*t28
    D_p_y_2_by_L_a_3 = t182*t31
    D_p_z_2_by_L_a_3 = t182*t34
    t183 = (
        -D_p_x_3*s_3_x_by_L_a_3 - D_p_y_3*s_3_y_by_L_a_3 - D_p_z_3*s_3_z_by_L_a_3 + L_a_3*s_3_x_by_L_a_3*t_3_x
        + L_a_3*s_3_y_by_L_a_3*t_3_y + L_a_3*s_3_z_by_L_a_3*t_3_z + s_3_x*t_3_x + s_3_y*t_3_y + s_3_z*t_3_z
        - t120*theta_3_by_L_a_3 - t121*theta_3_by_L_a_3 - t122*theta_3_by_L_a_3
    )
    D_p_x_3_by_L_a_3 = t183*t28
    D_p_y_3_by_L_a_3 = t183*t31
    D_p_z_3_by_L_a_3 = t183*t34
    t184 = -D_delta_x_1*s_3_x_by_L_a_3 - D_delta_y_1*s_3_y_by_L_a_3 - D_delta_z_1*s_3_z_by_L_a_3
    D_delta_x_1_by_L_a_3 = t184*t28
    D_delta_y_1_by_L_a_3 = t184*t31
    D_delta_z_1_by_L_a_3 = t184*t34
    t185 = -D_delta_x_2*s_3_x_by_L_a_3 - D_delta_y_2*s_3_y_by_L_a_3 - D_delta_z_2*s_3_z_by_L_a_3
    D_delta_x_2_by_L_a_3 = t185*t28
    D_delta_y_2_by_L_a_3 = t185*t31
    D_delta_z_2_by_L_a_3 = t185*t34
    t186 = -D_delta_x_3*s_3_x_by_L_a_3 - D_delta_y_3*s_3_y_by_L_a_3 - D_delta_z_3*s_3_z_by_L_a_3
    D_delta_x_3_by_L_a_3 = t186*t28
    D_delta_y_3_by_L_a_3 = t186*t31
    D_delta_z_3_by_L_a_3 = t186*t34
    t187 = mu_3*s_3_x_by_L_a_3
    t188 = mu_3*s_3_y_by_L_a_3
    t189 = mu_3*s_3_z_by_L_a_3
    mu_1_by_L_a_3 = t25*(-A_x_1*t187 - A_y_1*t188 - A_z_1*t189)
    mu_2_by_L_a_3 = t25*(-A_x_2*t187 - A_y_2*t188 - A_z_2*t189)
    mu_3_by_L_a_3 = t25*(-A_x_3*t187 - A_y_3*t188 - A_z_3*t189)
    theta_1_by_l_d_1 = -l_d_1*t43
    s_1_x_by_l_d_1 = -t16*theta_1_by_l_d_1
    s_1_y_by_l_d_1 = -t17*theta_1_by_l_d_1
    s_1_z_by_l_d_1 = -t18*theta_1_by_l_d_1
    t190 = t1*theta_1_by_l_d_1
    t191 = (
        -D_p_x_1*s_1_x_by_l_d_1 - D_p_y_1*s_1_y_by_l_d_1 - D_p_z_1*s_1_z_by_l_d_1 - t190*t47 - t190*t49
        - t190*t59 - t44*theta_1_by_l_d_1 - t45*theta_1_by_l_d_1 - t46*theta_1_by_l_d_1
    )
    D_p_x_1_by_l_d_1 = t191*t26
    D_p_y_1_by_l_d_1 = t191*t29
    D_p_z_1_by_l_d_1 = t191*t32
    t192 = -D_p_x_2*s_1_x_by_l_d_1 - D_p_y_2*s_1_y_by_l_d_1 - D_p_z_2*s_1_z_by_l_d_1
    D_p_x_2_by_l_d_1 = t192*t26
    D_p_y_2_by_l_d_1 = t192*t29
    D_p_z_2_by_l_d_1 = t192*t32
    t193 = -D_p_x_3*s_1_x_by_l_d_1 - D_p_y_3*s_1_y_by_l_d_1 - D_p_z_3*s_1_z_by_l_d_1
    D_p_x_3_by_l_d_1 = t193*t26
    D_p_y_3_by_l_d_1 = t193*t29
    D_p_z_3_by_l_d_1 = t193*t32
    t194 = -D_delta_x_1*s_1_x_by_l_d_1 - D_delta_y_1*s_1_y_by_l_d_1 - D_delta_z_1*s_1_z_by_l_d_1 + 1
    D_delta_x_1_by_l_d_1 = t194*t26
    D_delta_y_1_by_l_d_1 = t194*t29
    D_delta_z_1_by_l_d_1 = t194*t32
    t195 = -D_delta_x_2*s_1_x_by_l_d_1 - D_delta_y_2*s_1_y_by_l_d_1 - D_delta_z_2*s_1_z_by_l_d_1
    D_delta_x_2_by_l_d_1 = t195*t26
    D_delta_y_2_by_l_d_1 = t195*t29
    D_delta_z_2_by_l_d_1 = t195*t32
    t196 = -D_delta_x_3*s_1_x_by_l_d_1 - D_delta_y_3*s_1_y_by_l_d_1 - D_delta_z_3*s_1_z_by_l_d_1
    D_delta_x_3_by_l_d_1 = t196*t26
    D_delta_y_3_by_l_d_1 = t196*t29
    D_delta_z_3_by_l_d_1 = t196*t32
    t197 = mu_1*s_1_x_by_l_d_1
    t198 = mu_1*s_1_y_by_l_d_1
    t199 = mu_1*s_1_z_by_l_d_1
    mu_1_by_l_d_1 = t25*(-A_x_1*t197 - A_y_1*t198 - A_z_1*t199)
    mu_2_by_l_d_1 = t25*(-A_x_2*t197 - A_y_2*t198 - A_z_2*t199)
    mu_3_by_l_d_1 = t25*(-A_x_3*t197 - A_y_3*t198 - A_z_3*t199)
    theta_2_by_l_d_2 = -l_d_2*t80
    s_2_x_by_l_d_2 = -t19*theta_2_by_l_d_2
    s_2_y_by_l_d_2 = -t20*theta_2_by_l_d_2
    s_2_z_by_l_d_2 = -t21*theta_2_by_l_d_2
    t200 = -D_p_x_1*s_2_x_by_l_d_2 - D_p_y_1*s_2_y_by_l_d_2 - D_p_z_1*s_2_z_by_l_d_2
    D_p_x_1_by_l_d_2 = t200*t27
    D_p_y_1_by_l_d_2 = t200*t30
    D_p_z_1_by_l_d_2 = t200*t33
    t201 = t3*theta_2_by_l_d_2
    t202 = (
        -D_p_x_2*s_2_x_by_l_d_2 - D_p_y_2*s_2_y_by_l_d_2 - D_p_z_2*s_2_z_by_l_d_2 - t201*t85 - t201*t87
        - t201*t97 - t82*theta_2_by_l_d_2 - t83*theta_2_by_l_d_2 - t84*theta_2_by_l_d_2
    )
    D_p_x_2_by_l_d_2 = t202*t27
    D_p_y_2_by_l_d_2 = t202*t30
    D_p_z_2_by_l_d_2 = t202*t33
    t203 = -D_p_x_3*s_2_x_by_l_d_2 - D_p_y_3*s_2_y_by_l_d_2 - D_p_z_3*s_2_z_by_l_d_2
    D_p_x_3_by_l_d_2 = t203*t27
    D_p_y_3_by_l_d_2 = t203*t30
    D_p_z_3_by_l_d_2 = t203*t33
    t204 = -D_delta_x_1*s_2_x_by_l_d_2 - D_delta_y_1*s_2_y_by_l_d_2 - D_delta_z_1*s_2_z_by_l_d_2
    D_delta_x_1_by_l_d_2 = t204*t27
    D_delta_y_1_by_l_d_2 = t204*t30
    D_delta_z_1_by_l_d_2 = t204*t33
    t205 = -D_delta_x_2*s_2_x_by_l_d_2 - D_delta_y_2*s_2_y_by_l_d_2 - D_delta_z_2*s_2_z_by_l_d_2 + 1
    D_delta_x_2_by_l_d_2 = t205*t27
    D_delta_y_2_by_l_d_2 = t205*t30
    D_delta_z_2_by_l_d_2 = t205*t33
    t206 = -D_delta_x_3*s_2_x_by_l_d_2 - D_delta_y_3*s_2_y_by_l_d_2 - D_delta_z_3*s_2_z_by_l_d_2
    D_delta_x_3_by_l_d_2 = t206*t27
    D_delta_y_3_by_l_d_2 = t206*t30
    D_delta_z_3_by_l_d_2 = t206*t33
    t207 = mu_2*s_2_x_by_l_d_2
    t208 = mu_2*s_2_y_by_l_d_2
    t209 = mu_2*s_2_z_by_l_d_2
    mu_1_by_l_d_2 = t25*(-A_x_1*t207 - A_y_1*t208 - A_z_1*t209)
    mu_2_by_l_d_2 = t25*(-A_x_2*t207 - A_y_2*t208 - A_z_2*t209)
    mu_3_by_l_d_2 = t25*(-A_x_3*t207 - A_y_3*t208 - A_z_3*t209)
    theta_3_by_l_d_3 = -l_d_3*t117
    s_3_x_by_l_d_3 = -t22*theta_3_by_l_d_3
    s_3_y_by_l_d_3 = -t23*theta_3_by_l_d_3
    s_3_z_by_l_d_3 = -t24*theta_3_by_l_d_3
    t210 = -D_p_x_1*s_3_x_by_l_d_3 - D_p_y_1*s_3_y_by_l_d_3 - D_p_z_1*s_3_z_by_l_d_3
    D_p_x_1_by_l_d_3 = t210*t28
    D_p_y_1_by_l_d_3 = t210*t31
    D_p_z_1_by_l_d_3 = t210*t34
    t211 = -D_p_x_2*s_3_x_by_l_d_3 - D_p_y_2*s_3_y_by_l_d_3 - D_p_z_2*s_3_z_by_l_d_3
    D_p_x_2_by_l_d_3 = t211*t28
    D_p_y_2_by_l_d_3 = t211*t31
    D_p_z_2_by_l_d_3 = t211*t34
    t212 = t5*theta_3_by_l_d_3
    t213 = (
        -D_p_x_3*s_3_x_by_l_d_3 - D_p_y_3*s_3_y_by_l_d_3 - D_p_z_3*s_3_z_by_l_d_3 - t120*theta_3_by_l_d_3
        - t121*theta_3_by_l_d_3 - t122*theta_3_by_l_d_3 - t123*t212 - t125*t212 - t135*t212
    )
    D_p_x_3_by_l_d_3 = t213*t28
    D_p_y_3_by_l_d_3 = t213*t31
    D_p_z_3_by_l_d_3 = t213*t34
    t214 = -D_delta_x_1*s_3_x_by_l_d_3 - D_delta_y_1*s_3_y_by_l_d_3 - D_delta_z_1*s_3_z_by_l_d_3
    D_delta_x_1_by_l_d_3 = t214*t28
    D_delta_y_1_by_l_d_3 = t214*t31
    D_delta_z_1_by_l_d_3 = t214*t34
    t215 = -D_delta_x_2*s_3_x_by_l_d_3 - D_delta_y_2*s_3_y_by_l_d_3 - D_delta_z_2*s_3_z_by_l_d_3
    D_delta_x_2_by_l_d_3 = t215*t28
    D_delta_y_2_by_l_d_3 = t215*t31
    D_delta_z_2_by_l_d_3 = t215*t34
    t216 = -D_delta_x_3*s_3_x_by_l_d_3 - D_delta_y_3*s_3_y_by_l_d_3 - D_delta_z_3*s_3_z_by_l_d_3 + 1
    D_delta_x_3_by_l_d_3 = t216*t28
    D_delta_y_3_by_l_d_3 = t216*t31
    D_delta_z_3_by_l_d_3 = t216*t34
    t217 = mu_3*s_3_x_by_l_d_3
    t218 = mu_3*s_3_y_by_l_d_3
    t219 = mu_3*s_3_z_by_l_d_3
    mu_1_by_l_d_3 = t25*(-A_x_1*t217 - A_y_1*t218 - A_z_1*t219)
    mu_2_by_l_d_3 = t25*(-A_x_2*t217 - A_y_2*t218 - A_z_2*t219)
    mu_3_by_l_d_3 = t25*(-A_x_3*t217 - A_y_3*t218 - A_z_3*t219)
    t220 = t7*theta_1_by_b_1_x
    t221 = (1/3)*m_d_1
    t222 = D_p_x_1*t221
    t223 = t8*theta_1_by_b_1_x
    t224 = D_p_y_1*t221
    t225 = t9*theta_1_by_b_1_x
    t226 = D_p_z_1*t221
    t227 = (1/3)*m_d_2
    t228 = (1/3)*m_d_3
    t229 = t221 + t227 + t228 + t38
    t230 = D_p_x_1*t229
    t231 = t16*t221 + 2*t230
    t232 = D_p_y_1*t229
    t233 = t17*t221 + 2*t232
    t234 = D_p_z_1*t229
    t235 = t18*t221 + 2*t234
    t236 = (1/6)*m_d_1
    t237 = t220*t236
    t238 = t223*t236
    t239 = t225*t236
    t240 = (1/6)*m_d_2
    t241 = D_p_x_2*t229
    t242 = t19*t240 + t241
    t243 = t16*t236 + t230
    t244 = D_p_y_2*t229
    t245 = t20*t240 + t244
    t246 = t17*t236 + t232
    t247 = D_p_z_2*t229
    t248 = t21*t240 + t247
    t249 = t18*t236 + t234
    t250 = (1/6)*m_d_3
    t251 = D_p_x_3*t229
    t252 = t22*t250 + t251
    t253 = D_p_y_3*t229
    t254 = t23*t250 + t253
    t255 = D_p_z_3*t229
    t256 = t24*t250 + t255
    t257 = D_p_x_1_by_b_1_x*t229
    t258 = D_p_y_1_by_b_1_x*t229
    t259 = D_p_z_1_by_b_1_x*t229
    t260 = L_a_1*t35 + m_a_1*r_a_1
    t261 = t260*theta_1_by_b_1_x
    t262 = t19*t227 + 2*t241
    t263 = t20*t227 + 2*t244
    t264 = t21*t227 + 2*t247
    t265 = D_p_x_2_by_b_1_x*t229
    t266 = D_p_y_2_by_b_1_x*t229
    t267 = D_p_z_2_by_b_1_x*t229
    t268 = t22*t228 + 2*t251
    t269 = t228*t23 + 2*t253
    t270 = t228*t24 + 2*t255
    t271 = D_p_x_3_by_b_1_x*t229
    t272 = D_p_y_3_by_b_1_x*t229
    t273 = D_p_z_3_by_b_1_x*t229
    t274 = D_delta_x_1*t229
    t275 = 2*t274
    t276 = D_delta_y_1*t229
    t277 = 2*t276
    t278 = D_delta_z_1*t229
    t279 = 2*t278
    t280 = D_delta_x_1_by_b_1_x*t229
    t281 = D_delta_y_1_by_b_1_x*t229
    t282 = D_delta_z_1_by_b_1_x*t229
    t283 = D_delta_x_2*t229
    t284 = 2*t283
    t285 = D_delta_y_2*t229
    t286 = 2*t285
    t287 = D_delta_z_2*t229
    t288 = 2*t287
    t289 = D_delta_x_3*t229
    t290 = D_delta_y_3*t229
    t291 = D_delta_z_3*t229
    t292 = 2*t289
    t293 = 2*t290
    t294 = 2*t291
    t295 = t7*theta_1_by_b_1_y
    t296 = t8*theta_1_by_b_1_y
    t297 = t9*theta_1_by_b_1_y
    t298 = t236*t295
    t299 = t236*t296
    t300 = t236*t297
    t301 = t260*theta_1_by_b_1_y
    t302 = t7*theta_1_by_b_1_z
    t303 = t8*theta_1_by_b_1_z
    t304 = t9*theta_1_by_b_1_z
    t305 = t236*t302
    t306 = t236*t303
    t307 = t236*t304
    t308 = t260*theta_1_by_b_1_z
    t309 = t10*theta_2_by_b_2_x
    t310 = t240*t309
    t311 = t11*theta_2_by_b_2_x
    t312 = t240*t311
    t313 = t12*theta_2_by_b_2_x
    t314 = t240*t313
    t315 = D_p_x_2*t227
    t316 = D_p_y_2*t227
    t317 = D_p_z_2*t227
    t318 = L_a_2*t36 + m_a_2*r_a_2
    t319 = t318*theta_2_by_b_2_x
    t320 = t10*theta_2_by_b_2_y
    t321 = t240*t320
    t322 = t11*theta_2_by_b_2_y
    t323 = t240*t322
    t324 = t12*theta_2_by_b_2_y
    t325 = t240*t324
    t326 = t318*theta_2_by_b_2_y
    t327 = t10*theta_2_by_b_2_z
    t328 = t240*t327
    t329 = t11*theta_2_by_b_2_z
    t330 = t240*t329
    t331 = t12*theta_2_by_b_2_z
    t332 = t240*t331
    t333 = t318*theta_2_by_b_2_z
    t334 = t13*theta_3_by_b_3_x
    t335 = t250*t334
    t336 = t14*theta_3_by_b_3_x
    t337 = t250*t336
    t338 = t15*theta_3_by_b_3_x
    t339 = t250*t338
    t340 = D_p_x_3*t228
    t341 = D_p_y_3*t228
    t342 = D_p_z_3*t228
    t343 = L_a_3*t37 + m_a_3*r_a_3
    t344 = t343*theta_3_by_b_3_x
    t345 = t13*theta_3_by_b_3_y
    t346 = t250*t345
    t347 = t14*theta_3_by_b_3_y
    t348 = t250*t347
    t349 = t15*theta_3_by_b_3_y
    t350 = t250*t349
    t351 = t343*theta_3_by_b_3_y
    t352 = t13*theta_3_by_b_3_z
    t353 = t250*t352
    t354 = t14*theta_3_by_b_3_z
    t355 = t250*t354
    t356 = t15*theta_3_by_b_3_z
    t357 = t250*t356
    t358 = t343*theta_3_by_b_3_z
    t359 = t7*theta_1_by_L_a_1
    t360 = t8*theta_1_by_L_a_1
    t361 = t9*theta_1_by_L_a_1
    t362 = t236*t_1_x
    t363 = t236*t_1_y
    t364 = t236*t_1_z
    t365 = t236*t359
    t366 = t236*t360
    t367 = t236*t361
    t368 = t260*theta_1_by_L_a_1
    t369 = t240*t_2_x
    t370 = t240*t_2_y
    t371 = t240*t_2_z
    t372 = t10*theta_2_by_L_a_2
    t373 = t240*t372
    t374 = t11*theta_2_by_L_a_2
    t375 = t240*t374
    t376 = t12*theta_2_by_L_a_2
    t377 = t240*t376
    t378 = t318*theta_2_by_L_a_2
    t379 = t250*t_3_x
    t380 = t250*t_3_y
    t381 = t250*t_3_z
    t382 = t13*theta_3_by_L_a_3
    t383 = t250*t382
    t384 = t14*theta_3_by_L_a_3
    t385 = t250*t384
    t386 = t15*theta_3_by_L_a_3
    t387 = t250*t386
    t388 = t343*theta_3_by_L_a_3
    t389 = t7*theta_1_by_l_d_1
    t390 = t8*theta_1_by_l_d_1
    t391 = t9*theta_1_by_l_d_1
    t392 = t236*t389
    t393 = t236*t390
    t394 = t236*t391
    t395 = t260*theta_1_by_l_d_1
    t396 = t10*theta_2_by_l_d_2
    t397 = t240*t396
    t398 = t11*theta_2_by_l_d_2
    t399 = t240*t398
    t400 = t12*theta_2_by_l_d_2
    t401 = t240*t400
    t402 = t318*theta_2_by_l_d_2
    t403 = t13*theta_3_by_l_d_3
    t404 = t250*t403
    t405 = t14*theta_3_by_l_d_3
    t406 = t250*t405
    t407 = t15*theta_3_by_l_d_3
    t408 = t250*t407
    t409 = t343*theta_3_by_l_d_3
    t410 = D_p_x_1*k_C
    t411 = 2*D_p_x_1_by_b_1_x
    t412 = D_p_x_1*mu_2
    t413 = D_p_x_1*mu_3
    t414 = D_p_y_1*k_C
    t415 = 2*D_p_y_1_by_b_1_x
    t416 = D_p_y_1*mu_2
    t417 = D_p_y_1*mu_3
    t418 = D_p_z_1*k_C
    t419 = 2*D_p_z_1_by_b_1_x
    t420 = D_p_z_1*mu_2
    t421 = D_p_z_1*mu_3
    t422 = mu_1*t48
    t423 = d_1_y*t_1_y
    t424 = d_1_z*t_1_z
    t425 = D_p_x_1_by_b_1_x + t220
    t426 = U_1_x_1*mu_1
    t427 = 2*t426
    t428 = D_p_y_1_by_b_1_x + t223
    t429 = U_1_y_1*mu_1
    t430 = 2*t429
    t431 = D_p_z_1_by_b_1_x + t225
    t432 = U_1_z_1*mu_1
    t433 = 2*t432
    t434 = mu_1*t7
    t435 = -D_p_x_1**2 - D_p_y_1**2 - D_p_z_1**2
    t436 = L_a_1*mu_1
    t437 = g_x*t260 - s_1_x*t436
    t438 = t437*t_1_x
    t439 = g_y*t260 - s_1_y*t436
    t440 = t439*t_1_y
    t441 = g_z*t260 - s_1_z*t436
    t442 = t441*t_1_z
    t443 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2 - t44 - t45 - t46
    t444 = D_p_x_2*mu_3
    t445 = U_2_x_2*mu_2
    t446 = D_p_y_2*mu_3
    t447 = U_2_y_2*mu_2
    t448 = D_p_z_2*mu_3
    t449 = U_2_z_2*mu_2
    t450 = D_p_x_2*mu_1
    t451 = D_p_y_2*mu_1
    t452 = D_p_z_2*mu_1
    t453 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1
    t454 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2
    t455 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2
    t456 = D_p_x_3*mu_2
    t457 = U_3_x_3*mu_3
    t458 = D_p_y_3*mu_2
    t459 = U_3_y_3*mu_3
    t460 = D_p_z_3*mu_2
    t461 = U_3_z_3*mu_3
    t462 = D_p_x_3*mu_1
    t463 = D_p_y_3*mu_1
    t464 = D_p_z_3*mu_1
    t465 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1
    t466 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3
    t467 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3
    t468 = D_p_x_1_by_b_1_x*k_C
    t469 = D_p_y_1_by_b_1_x*k_C
    t470 = D_p_z_1_by_b_1_x*k_C
    t471 = D_delta_x_1*mu_2
    t472 = D_delta_x_1*mu_3
    t473 = D_delta_y_1*mu_2
    t474 = D_delta_y_1*mu_3
    t475 = D_delta_z_1*mu_2
    t476 = D_delta_z_1*mu_3
    t477 = D_delta_x_1*mu_1
    t478 = D_delta_y_1*mu_1
    t479 = D_delta_z_1*mu_1
    t480 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t481 = -D_delta_x_1*D_p_x_1 - D_delta_y_1*D_p_y_1 - D_delta_z_1*D_p_z_1
    t482 = D_p_x_1*k_C - t412 - t413 - t426
    t483 = D_p_y_1*k_C - t416 - t417 - t429
    t484 = D_p_z_1*k_C - t420 - t421 - t432
    t485 = D_delta_x_2*mu_2
    t486 = D_delta_x_2*mu_3
    t487 = D_delta_y_2*mu_2
    t488 = D_delta_y_2*mu_3
    t489 = D_delta_z_2*mu_2
    t490 = D_delta_z_2*mu_3
    t491 = D_delta_x_2*mu_1
    t492 = D_delta_y_2*mu_1
    t493 = D_delta_z_2*mu_1
    t494 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t495 = -D_delta_x_2*D_p_x_1 - D_delta_y_2*D_p_y_1 - D_delta_z_2*D_p_z_1
    t496 = D_delta_x_3*mu_2
    t497 = D_delta_x_3*mu_3
    t498 = D_delta_y_3*mu_2
    t499 = D_delta_y_3*mu_3
    t500 = D_delta_z_3*mu_2
    t501 = D_delta_z_3*mu_3
    t502 = D_delta_x_3*mu_1
    t503 = D_delta_y_3*mu_1
    t504 = D_delta_z_3*mu_1
    t505 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t506 = -D_delta_x_3*D_p_x_1 - D_delta_y_3*D_p_y_1 - D_delta_z_3*D_p_z_1
    t507 = 2*D_p_x_2_by_b_1_x
    t508 = 2*D_p_y_2_by_b_1_x
    t509 = 2*D_p_z_2_by_b_1_x
    t510 = -D_p_x_2**2 - D_p_y_2**2 - D_p_z_2**2
    t511 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2 - t82 - t83 - t84
    t512 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3
    t513 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2
    t514 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3
    t515 = D_p_x_2_by_b_1_x*k_C
    t516 = D_p_y_2_by_b_1_x*k_C
    t517 = D_p_z_2_by_b_1_x*k_C
    t518 = -D_delta_x_1*D_p_x_2 - D_delta_y_1*D_p_y_2 - D_delta_z_1*D_p_z_2
    t519 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t520 = D_p_x_2*k_C - t444 - t445 - t450
    t521 = D_p_y_2*k_C - t446 - t447 - t451
    t522 = D_p_z_2*k_C - t448 - t449 - t452
    t523 = -D_delta_x_2*D_p_x_2 - D_delta_y_2*D_p_y_2 - D_delta_z_2*D_p_z_2
    t524 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t525 = -D_delta_x_3*D_p_x_2 - D_delta_y_3*D_p_y_2 - D_delta_z_3*D_p_z_2
    t526 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t527 = 2*D_p_x_3_by_b_1_x
    t528 = 2*D_p_y_3_by_b_1_x
    t529 = 2*D_p_z_3_by_b_1_x
    t530 = -D_p_x_3**2 - D_p_y_3**2 - D_p_z_3**2
    t531 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2 - t120 - t121 - t122
    t532 = D_p_x_3_by_b_1_x*k_C
    t533 = D_p_y_3_by_b_1_x*k_C
    t534 = D_p_z_3_by_b_1_x*k_C
    t535 = -D_delta_x_1*D_p_x_3 - D_delta_y_1*D_p_y_3 - D_delta_z_1*D_p_z_3
    t536 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t537 = D_p_x_3*k_C - t456 - t457 - t462
    t538 = D_p_y_3*k_C - t458 - t459 - t463
    t539 = D_p_z_3*k_C - t460 - t461 - t464
    t540 = -D_delta_x_2*D_p_x_3 - D_delta_y_2*D_p_y_3 - D_delta_z_2*D_p_z_3
    t541 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t542 = -D_delta_x_3*D_p_x_3 - D_delta_y_3*D_p_y_3 - D_delta_z_3*D_p_z_3
    t543 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t544 = D_delta_x_1**2 + D_delta_y_1**2 + D_delta_z_1**2
    t545 = 2*D_delta_x_1*k_C - 2*t471 - 2*t472 - 2*t477
    t546 = 2*D_delta_y_1*k_C - 2*t473 - 2*t474 - 2*t478
    t547 = 2*D_delta_z_1*k_C - 2*t475 - 2*t476 - 2*t479
    t548 = 1 - t544
    t549 = -D_delta_x_1*D_delta_x_2 - D_delta_y_1*D_delta_y_2 - D_delta_z_1*D_delta_z_2
    t550 = D_delta_x_2*k_C - t485 - t486 - t491
    t551 = D_delta_x_1*k_C - t471 - t472 - t477
    t552 = D_delta_y_2*k_C - t487 - t488 - t492
    t553 = D_delta_y_1*k_C - t473 - t474 - t478
    t554 = D_delta_z_2*k_C - t489 - t490 - t493
    t555 = D_delta_z_1*k_C - t475 - t476 - t479
    t556 = -D_delta_x_1*D_delta_x_3 - D_delta_y_1*D_delta_y_3 - D_delta_z_1*D_delta_z_3
    t557 = D_delta_x_3*k_C - t496 - t497 - t502
    t558 = D_delta_y_3*k_C - t498 - t499 - t503
    t559 = D_delta_z_3*k_C - t500 - t501 - t504
    t560 = D_delta_x_2**2 + D_delta_y_2**2 + D_delta_z_2**2
    t561 = 2*D_delta_x_2*k_C - 2*t485 - 2*t486 - 2*t491
    t562 = 2*D_delta_y_2*k_C - 2*t487 - 2*t488 - 2*t492
    t563 = 2*D_delta_z_2*k_C - 2*t489 - 2*t490 - 2*t493
    t564 = 1 - t560
    t565 = -D_delta_x_2*D_delta_x_3 - D_delta_y_2*D_delta_y_3 - D_delta_z_2*D_delta_z_3
    t566 = D_delta_x_3**2 + D_delta_y_3**2 + D_delta_z_3**2
    t567 = 2*D_delta_x_3*k_C - 2*t496 - 2*t497 - 2*t502
    t568 = 2*D_delta_y_3*k_C - 2*t498 - 2*t499 - 2*t503
    t569 = 2*D_delta_z_3*k_C - 2*t500 - 2*t501 - 2*t504
    t570 = 1 - t566
    t571 = 2*D_p_x_1_by_b_1_y
    t572 = 2*D_p_y_1_by_b_1_y
    t573 = 2*D_p_z_1_by_b_1_y
    t574 = mu_1*t60
    t575 = d_1_x*t_1_x
    t576 = D_p_x_1_by_b_1_y + t295
    t577 = D_p_y_1_by_b_1_y + t296
    t578 = D_p_z_1_by_b_1_y + t297
    t579 = mu_1*t8
    t580 = D_delta_x_1*k_C
    t581 = D_delta_y_1*k_C
    t582 = D_delta_z_1*k_C
    t583 = D_delta_x_2*k_C
    t584 = D_delta_y_2*k_C
    t585 = D_delta_z_2*k_C
    t586 = D_delta_x_3*k_C
    t587 = D_delta_y_3*k_C
    t588 = D_delta_z_3*k_C
    t589 = 2*D_p_x_2_by_b_1_y
    t590 = 2*D_p_y_2_by_b_1_y
    t591 = 2*D_p_z_2_by_b_1_y
    t592 = 2*D_p_x_3_by_b_1_y
    t593 = 2*D_p_y_3_by_b_1_y
    t594 = 2*D_p_z_3_by_b_1_y
    t595 = 2*D_p_x_1_by_b_1_z
    t596 = 2*D_p_y_1_by_b_1_z
    t597 = 2*D_p_z_1_by_b_1_z
    t598 = mu_1*t70
    t599 = D_p_x_1_by_b_1_z + t302
    t600 = D_p_y_1_by_b_1_z + t303
    t601 = D_p_z_1_by_b_1_z + t304
    t602 = mu_1*t9
    t603 = 2*D_p_x_2_by_b_1_z
    t604 = 2*D_p_y_2_by_b_1_z
    t605 = 2*D_p_z_2_by_b_1_z
    t606 = 2*D_p_x_3_by_b_1_z
    t607 = 2*D_p_y_3_by_b_1_z
    t608 = 2*D_p_z_3_by_b_1_z
    t609 = 2*D_p_x_1_by_b_2_x
    t610 = 2*D_p_y_1_by_b_2_x
    t611 = 2*D_p_z_1_by_b_2_x
    t612 = D_p_x_2_by_b_2_x + t309
    t613 = D_p_y_2_by_b_2_x + t311
    t614 = D_p_z_2_by_b_2_x + t313
    t615 = D_p_x_2*k_C
    t616 = 2*D_p_x_2_by_b_2_x
    t617 = D_p_y_2*k_C
    t618 = 2*D_p_y_2_by_b_2_x
    t619 = D_p_z_2*k_C
    t620 = 2*D_p_z_2_by_b_2_x
    t621 = mu_2*t86
    t622 = d_2_y*t_2_y
    t623 = d_2_z*t_2_z
    t624 = 2*t445
    t625 = 2*t447
    t626 = 2*t449
    t627 = mu_2*t10
    t628 = L_a_2*mu_2
    t629 = g_x*t318 - s_2_x*t628
    t630 = t629*t_2_x
    t631 = g_y*t318 - s_2_y*t628
    t632 = t631*t_2_y
    t633 = g_z*t318 - s_2_z*t628
    t634 = t633*t_2_z
    t635 = 2*D_p_x_3_by_b_2_x
    t636 = 2*D_p_y_3_by_b_2_x
    t637 = 2*D_p_z_3_by_b_2_x
    t638 = 2*D_p_x_1_by_b_2_y
    t639 = 2*D_p_y_1_by_b_2_y
    t640 = 2*D_p_z_1_by_b_2_y
    t641 = D_p_x_2_by_b_2_y + t320
    t642 = D_p_y_2_by_b_2_y + t322
    t643 = D_p_z_2_by_b_2_y + t324
    t644 = 2*D_p_x_2_by_b_2_y
    t645 = 2*D_p_y_2_by_b_2_y
    t646 = 2*D_p_z_2_by_b_2_y
    t647 = mu_2*t98
    t648 = d_2_x*t_2_x
    t649 = mu_2*t11
    t650 = 2*D_p_x_3_by_b_2_y
    t651 = 2*D_p_y_3_by_b_2_y
    t652 = 2*D_p_z_3_by_b_2_y
    t653 = 2*D_p_x_1_by_b_2_z
    t654 = 2*D_p_y_1_by_b_2_z
    t655 = 2*D_p_z_1_by_b_2_z
    t656 = D_p_x_2_by_b_2_z + t327
    t657 = D_p_y_2_by_b_2_z + t329
    t658 = D_p_z_2_by_b_2_z + t331
    t659 = 2*D_p_x_2_by_b_2_z
    t660 = 2*D_p_y_2_by_b_2_z
    t661 = 2*D_p_z_2_by_b_2_z
    t662 = mu_2*t108
    t663 = mu_2*t12
    t664 = 2*D_p_x_3_by_b_2_z
    t665 = 2*D_p_y_3_by_b_2_z
    t666 = 2*D_p_z_3_by_b_2_z
    t667 = 2*D_p_x_1_by_b_3_x
    t668 = 2*D_p_y_1_by_b_3_x
    t669 = 2*D_p_z_1_by_b_3_x
    t670 = D_p_x_3_by_b_3_x + t334
    t671 = D_p_y_3_by_b_3_x + t336
    t672 = D_p_z_3_by_b_3_x + t338
    t673 = 2*D_p_x_2_by_b_3_x
    t674 = 2*D_p_y_2_by_b_3_x
    t675 = 2*D_p_z_2_by_b_3_x
    t676 = D_p_x_3*k_C
    t677 = 2*D_p_x_3_by_b_3_x
    t678 = D_p_y_3*k_C
    t679 = 2*D_p_y_3_by_b_3_x
    t680 = D_p_z_3*k_C
    t681 = 2*D_p_z_3_by_b_3_x
    t682 = mu_3*t124
    t683 = d_3_y*t_3_y
    t684 = d_3_z*t_3_z
    t685 = 2*t457
    t686 = 2*t459
    t687 = 2*t461
    t688 = mu_3*t13
    t689 = L_a_3*mu_3
    t690 = g_x*t343 - s_3_x*t689
    t691 = t690*t_3_x
    t692 = g_y*t343 - s_3_y*t689
    t693 = t692*t_3_y
    t694 = g_z*t343 - s_3_z*t689
    t695 = t694*t_3_z
    t696 = 2*D_p_x_1_by_b_3_y
    t697 = 2*D_p_y_1_by_b_3_y
    t698 = 2*D_p_z_1_by_b_3_y
    t699 = D_p_x_3_by_b_3_y + t345
    t700 = D_p_y_3_by_b_3_y + t347
    t701 = D_p_z_3_by_b_3_y + t349
    t702 = 2*D_p_x_2_by_b_3_y
    t703 = 2*D_p_y_2_by_b_3_y
    t704 = 2*D_p_z_2_by_b_3_y
    t705 = 2*D_p_x_3_by_b_3_y
    t706 = 2*D_p_y_3_by_b_3_y
    t707 = 2*D_p_z_3_by_b_3_y
    t708 = mu_3*t136
    t709 = d_3_x*t_3_x
    t710 = mu_3*t14
    t711 = 2*D_p_x_1_by_b_3_z
    t712 = 2*D_p_y_1_by_b_3_z
    t713 = 2*D_p_z_1_by_b_3_z
    t714 = D_p_x_3_by_b_3_z + t352
    t715 = D_p_y_3_by_b_3_z + t354
    t716 = D_p_z_3_by_b_3_z + t356
    t717 = 2*D_p_x_2_by_b_3_z
    t718 = 2*D_p_y_2_by_b_3_z
    t719 = 2*D_p_z_2_by_b_3_z
    t720 = 2*D_p_x_3_by_b_3_z
    t721 = 2*D_p_y_3_by_b_3_z
    t722 = 2*D_p_z_3_by_b_3_z
    t723 = mu_3*t146
    t724 = mu_3*t15
    t725 = 2*D_p_x_1_by_L_a_1
    t726 = 2*D_p_y_1_by_L_a_1
    t727 = 2*D_p_z_1_by_L_a_1
    t728 = D_p_x_1_by_L_a_1 + t359 - t_1_x
    t729 = D_p_y_1_by_L_a_1 + t360 - t_1_y
    t730 = D_p_z_1_by_L_a_1 + t361 - t_1_z
    t731 = 2*D_p_x_2_by_L_a_1
    t732 = 2*D_p_y_2_by_L_a_1
    t733 = 2*D_p_z_2_by_L_a_1
    t734 = 2*D_p_x_3_by_L_a_1
    t735 = 2*D_p_y_3_by_L_a_1
    t736 = 2*D_p_z_3_by_L_a_1
    t737 = 2*D_p_x_1_by_L_a_2
    t738 = 2*D_p_y_1_by_L_a_2
    t739 = 2*D_p_z_1_by_L_a_2
    t740 = D_p_x_2_by_L_a_2 + t372 - t_2_x
    t741 = D_p_y_2_by_L_a_2 + t374 - t_2_y
    t742 = D_p_z_2_by_L_a_2 + t376 - t_2_z
    t743 = 2*D_p_x_2_by_L_a_2
    t744 = 2*D_p_y_2_by_L_a_2
    t745 = 2*D_p_z_2_by_L_a_2
    t746 = 2*D_p_x_3_by_L_a_2
    t747 = 2*D_p_y_3_by_L_a_2
    t748 = 2*D_p_z_3_by_L_a_2
    t749 = 2*D_p_x_1_by_L_a_3
    t750 = 2*D_p_y_1_by_L_a_3
    t751 = 2*D_p_z_1_by_L_a_3
    t752 = D_p_x_3_by_L_a_3 + t382 - t_3_x
    t753 = D_p_y_3_by_L_a_3 + t384 - t_3_y
    t754 = D_p_z_3_by_L_a_3 + t386 - t_3_z
    t755 = 2*D_p_x_2_by_L_a_3
    t756 = 2*D_p_y_2_by_L_a_3
    t757 = 2*D_p_z_2_by_L_a_3
    t758 = 2*D_p_x_3_by_L_a_3
    t759 = 2*D_p_y_3_by_L_a_3
    t760 = 2*D_p_z_3_by_L_a_3
    t761 = 2*D_p_x_1_by_l_d_1
    t762 = 2*D_p_y_1_by_l_d_1
    t763 = 2*D_p_z_1_by_l_d_1
    t764 = mu_1*t190
    t765 = D_p_x_1_by_l_d_1 + t389
    t766 = D_p_y_1_by_l_d_1 + t390
    t767 = D_p_z_1_by_l_d_1 + t391
    t768 = 2*D_p_x_2_by_l_d_1
    t769 = 2*D_p_y_2_by_l_d_1
    t770 = 2*D_p_z_2_by_l_d_1
    t771 = 2*D_p_x_3_by_l_d_1
    t772 = 2*D_p_y_3_by_l_d_1
    t773 = 2*D_p_z_3_by_l_d_1
    t774 = 2*D_p_x_1_by_l_d_2
    t775 = 2*D_p_y_1_by_l_d_2
    t776 = 2*D_p_z_1_by_l_d_2
    t777 = D_p_x_2_by_l_d_2 + t396
    t778 = D_p_y_2_by_l_d_2 + t398
    t779 = D_p_z_2_by_l_d_2 + t400
    t780 = 2*D_p_x_2_by_l_d_2
    t781 = 2*D_p_y_2_by_l_d_2
    t782 = 2*D_p_z_2_by_l_d_2
    t783 = mu_2*t201
    t784 = 2*D_p_x_3_by_l_d_2
    t785 = 2*D_p_y_3_by_l_d_2
    t786 = 2*D_p_z_3_by_l_d_2
    t787 = 2*D_p_x_1_by_l_d_3
    t788 = 2*D_p_y_1_by_l_d_3
    t789 = 2*D_p_z_1_by_l_d_3
    t790 = D_p_x_3_by_l_d_3 + t403
    t791 = D_p_y_3_by_l_d_3 + t405
    t792 = D_p_z_3_by_l_d_3 + t407
    t793 = 2*D_p_x_2_by_l_d_3
    t794 = 2*D_p_y_2_by_l_d_3
    t795 = 2*D_p_z_2_by_l_d_3
    t796 = 2*D_p_x_3_by_l_d_3
    t797 = 2*D_p_y_3_by_l_d_3
    t798 = 2*D_p_z_3_by_l_d_3
    t799 = mu_3*t212
    M_theta_out = _listed(batch, dtype, (
        D_p_x_1_by_b_1_x*t231 + D_p_y_1_by_b_1_x*t233 + D_p_z_1_by_b_1_x*t235 - t220*t222 - t223*t224
        - t225*t226,
        D_p_x_1_by_b_1_x*t242 - D_p_x_2*t237 + D_p_x_2_by_b_1_x*t243 + D_p_y_1_by_b_1_x*t245
        - D_p_y_2*t238 + D_p_y_2_by_b_1_x*t246 + D_p_z_1_by_b_1_x*t248 - D_p_z_2*t239
        + D_p_z_2_by_b_1_x*t249,
        D_p_x_1_by_b_1_x*t252 - D_p_x_3*t237 + D_p_x_3_by_b_1_x*t243 + D_p_y_1_by_b_1_x*t254
        - D_p_y_3*t238 + D_p_y_3_by_b_1_x*t246 + D_p_z_1_by_b_1_x*t256 - D_p_z_3*t239
        + D_p_z_3_by_b_1_x*t249,
        -D_delta_x_1*t237 + D_delta_x_1*t257 + D_delta_x_1_by_b_1_x*t243 - D_delta_y_1*t238
        + D_delta_y_1*t258 + D_delta_y_1_by_b_1_x*t246 - D_delta_z_1*t239 + D_delta_z_1*t259
        + D_delta_z_1_by_b_1_x*t249,
        -D_delta_x_2*t237 + D_delta_x_2*t257 + D_delta_x_2_by_b_1_x*t243 - D_delta_y_2*t238
        + D_delta_y_2*t258 + D_delta_y_2_by_b_1_x*t246 - D_delta_z_2*t239 + D_delta_z_2*t259
        + D_delta_z_2_by_b_1_x*t249,
        -D_delta_x_3*t237 + D_delta_x_3*t257 + D_delta_x_3_by_b_1_x*t243 - D_delta_y_3*t238
        + D_delta_y_3*t258 + D_delta_y_3_by_b_1_x*t246 - D_delta_z_3*t239 + D_delta_z_3*t259
        + D_delta_z_3_by_b_1_x*t249,
        D_p_x_1_by_b_1_x*t39 - d_1_x*t261, D_p_y_1_by_b_1_x*t39 - d_1_y*t261,
        D_p_z_1_by_b_1_x*t39 - d_1_z*t261,
        D_p_x_2_by_b_1_x*t262 + D_p_y_2_by_b_1_x*t263 + D_p_z_2_by_b_1_x*t264,
        D_p_x_2_by_b_1_x*t252 + D_p_x_3_by_b_1_x*t242 + D_p_y_2_by_b_1_x*t254 + D_p_y_3_by_b_1_x*t245
        + D_p_z_2_by_b_1_x*t256 + D_p_z_3_by_b_1_x*t248,
        D_delta_x_1*t265 + D_delta_x_1_by_b_1_x*t242 + D_delta_y_1*t266 + D_delta_y_1_by_b_1_x*t245
        + D_delta_z_1*t267 + D_delta_z_1_by_b_1_x*t248,
        D_delta_x_2*t265 + D_delta_x_2_by_b_1_x*t242 + D_delta_y_2*t266 + D_delta_y_2_by_b_1_x*t245
        + D_delta_z_2*t267 + D_delta_z_2_by_b_1_x*t248,
        D_delta_x_3*t265 + D_delta_x_3_by_b_1_x*t242 + D_delta_y_3*t266 + D_delta_y_3_by_b_1_x*t245
        + D_delta_z_3*t267 + D_delta_z_3_by_b_1_x*t248,
        D_p_x_2_by_b_1_x*t39, D_p_y_2_by_b_1_x*t39, D_p_z_2_by_b_1_x*t39,
        D_p_x_3_by_b_1_x*t268 + D_p_y_3_by_b_1_x*t269 + D_p_z_3_by_b_1_x*t270,
        D_delta_x_1*t271 + D_delta_x_1_by_b_1_x*t252 + D_delta_y_1*t272 + D_delta_y_1_by_b_1_x*t254
        + D_delta_z_1*t273 + D_delta_z_1_by_b_1_x*t256,
        D_delta_x_2*t271 + D_delta_x_2_by_b_1_x*t252 + D_delta_y_2*t272 + D_delta_y_2_by_b_1_x*t254
        + D_delta_z_2*t273 + D_delta_z_2_by_b_1_x*t256,
        D_delta_x_3*t271 + D_delta_x_3_by_b_1_x*t252 + D_delta_y_3*t272 + D_delta_y_3_by_b_1_x*t254
        + D_delta_z_3*t273 + D_delta_z_3_by_b_1_x*t256,
        D_p_x_3_by_b_1_x*t39, D_p_y_3_by_b_1_x*t39, D_p_z_3_by_b_1_x*t39,
        D_delta_x_1_by_b_1_x*t275 + D_delta_y_1_by_b_1_x*t277 + D_delta_z_1_by_b_1_x*t279,
        D_delta_x_2*t280 + D_delta_x_2_by_b_1_x*t274 + D_delta_y_2*t281 + D_delta_y_2_by_b_1_x*t276
        + D_delta_z_2*t282 + D_delta_z_2_by_b_1_x*t278,
        D_delta_x_3*t280 + D_delta_x_3_by_b_1_x*t274 + D_delta_y_3*t281 + D_delta_y_3_by_b_1_x*t276
        + D_delta_z_3*t282 + D_delta_z_3_by_b_1_x*t278,
        D_delta_x_1_by_b_1_x*t39, D_delta_y_1_by_b_1_x*t39, D_delta_z_1_by_b_1_x*t39,
        D_delta_x_2_by_b_1_x*t284 + D_delta_y_2_by_b_1_x*t286 + D_delta_z_2_by_b_1_x*t288,
        D_delta_x_2_by_b_1_x*t289 + D_delta_x_3_by_b_1_x*t283 + D_delta_y_2_by_b_1_x*t290
        + D_delta_y_3_by_b_1_x*t285 + D_delta_z_2_by_b_1_x*t291 + D_delta_z_3_by_b_1_x*t287,
        D_delta_x_2_by_b_1_x*t39, D_delta_y_2_by_b_1_x*t39, D_delta_z_2_by_b_1_x*t39,
        D_delta_x_3_by_b_1_x*t292 + D_delta_y_3_by_b_1_x*t293 + D_delta_z_3_by_b_1_x*t294,
        D_delta_x_3_by_b_1_x*t39, D_delta_y_3_by_b_1_x*t39, D_delta_z_3_by_b_1_x*t39,
        D_p_x_1_by_b_1_y*t231 + D_p_y_1_by_b_1_y*t233 + D_p_z_1_by_b_1_y*t235 - t222*t295 - t224*t296
        - t226*t297,
        D_p_x_1_by_b_1_y*t242 - D_p_x_2*t298 + D_p_x_2_by_b_1_y*t243 + D_p_y_1_by_b_1_y*t245
        - D_p_y_2*t299 + D_p_y_2_by_b_1_y*t246 + D_p_z_1_by_b_1_y*t248 - D_p_z_2*t300
        + D_p_z_2_by_b_1_y*t249,
        D_p_x_1_by_b_1_y*t252 - D_p_x_3*t298 + D_p_x_3_by_b_1_y*t243 + D_p_y_1_by_b_1_y*t254
        - D_p_y_3*t299 + D_p_y_3_by_b_1_y*t246 + D_p_z_1_by_b_1_y*t256 - D_p_z_3*t300
        + D_p_z_3_by_b_1_y*t249,
        -D_delta_x_1*t298 + D_delta_x_1_by_b_1_y*t243 - D_delta_y_1*t299 + D_delta_y_1_by_b_1_y*t246
        - D_delta_z_1*t300 + D_delta_z_1_by_b_1_y*t249 + D_p_x_1_by_b_1_y*t274 + D_p_y_1_by_b_1_y*t276
        + D_p_z_1_by_b_1_y*t278,
        -D_delta_x_2*t298 + D_delta_x_2_by_b_1_y*t243 - D_delta_y_2*t299 + D_delta_y_2_by_b_1_y*t246
        - D_delta_z_2*t300 + D_delta_z_2_by_b_1_y*t249 + D_p_x_1_by_b_1_y*t283 + D_p_y_1_by_b_1_y*t285
        + D_p_z_1_by_b_1_y*t287,
        -D_delta_x_3*t298 + D_delta_x_3_by_b_1_y*t243 - D_delta_y_3*t299 + D_delta_y_3_by_b_1_y*t246
        - D_delta_z_3*t300 + D_delta_z_3_by_b_1_y*t249 + D_p_x_1_by_b_1_y*t289 + D_p_y_1_by_b_1_y*t290
        + D_p_z_1_by_b_1_y*t291,
        D_p_x_1_by_b_1_y*t39 - d_1_x*t301, D_p_y_1_by_b_1_y*t39 - d_1_y*t301,
        D_p_z_1_by_b_1_y*t39 - d_1_z*t301,
        D_p_x_2_by_b_1_y*t262 + D_p_y_2_by_b_1_y*t263 + D_p_z_2_by_b_1_y*t264,
        D_p_x_2_by_b_1_y*t252 + D_p_x_3_by_b_1_y*t242 + D_p_y_2_by_b_1_y*t254 + D_p_y_3_by_b_1_y*t245
        + D_p_z_2_by_b_1_y*t256 + D_p_z_3_by_b_1_y*t248,
        D_delta_x_1_by_b_1_y*t242 + D_delta_y_1_by_b_1_y*t245 + D_delta_z_1_by_b_1_y*t248
        + D_p_x_2_by_b_1_y*t274 + D_p_y_2_by_b_1_y*t276 + D_p_z_2_by_b_1_y*t278,
        D_delta_x_2_by_b_1_y*t242 + D_delta_y_2_by_b_1_y*t245 + D_delta_z_2_by_b_1_y*t248
        + D_p_x_2_by_b_1_y*t283 + D_p_y_2_by_b_1_y*t285 + D_p_z_2_by_b_1_y*t287,
        D_delta_x_3_by_b_1_y*t242 + D_delta_y_3_by_b_1_y*t245 + D_delta_z_3_by_b_1_y*t248
        + D_p_x_2_by_b_1_y*t289 + D_p_y_2_by_b_1_y*t290 + D_p_z_2_by_b_1_y*t291,
        D_p_x_2_by_b_1_y*t39, D_p_y_2_by_b_1_y*t39, D_p_z_2_by_b_1_y*t39,
        D_p_x_3_by_b_1_y*t268 + D_p_y_3_by_b_1_y*t269 + D_p_z_3_by_b_1_y*t270,
        D_delta_x_1_by_b_1_y*t252 + D_delta_y_1_by_b_1_y*t254 + D_delta_z_1_by_b_1_y*t256
        + D_p_x_3_by_b_1_y*t274 + D_p_y_3_by_b_1_y*t276 + D_p_z_3_by_b_1_y*t278,
        D_delta_x_2_by_b_1_y*t252 + D_delta_y_2_by_b_1_y*t254 + D_delta_z_2_by_b_1_y*t256
        + D_p_x_3_by_b_1_y*t283 + D_p_y_3_by_b_1_y*t285 + D_p_z_3_by_b_1_y*t287,
        D_delta_x_3_by_b_1_y*t252 + D_delta_y_3_by_b_1_y*t254 + D_delta_z_3_by_b_1_y*t256
        + D_p_x_3_by_b_1_y*t289 + D_p_y_3_by_b_1_y*t290 + D_p_z_3_by_b_1_y*t291,
        D_p_x_3_by_b_1_y*t39, D_p_y_3_by_b_1_y*t39, D_p_z_3_by_b_1_y*t39,
        D_delta_x_1_by_b_1_y*t275 + D_delta_y_1_by_b_1_y*t277 + D_delta_z_1_by_b_1_y*t279,
        D_delta_x_1_by_b_1_y*t283 + D_delta_x_2_by_b_1_y*t274 + D_delta_y_1_by_b_1_y*t285
        + D_delta_y_2_by_b_1_y*t276 + D_delta_z_1_by_b_1_y*t287 + D_delta_z_2_by_b_1_y*t278,
        D_delta_x_1_by_b_1_y*t289 + D_delta_x_3_by_b_1_y*t274 + D_delta_y_1_by_b_1_y*t290
        + D_delta_y_3_by_b_1_y*t276 + D_delta_z_1_by_b_1_y*t291 + D_delta_z_3_by_b_1_y*t278,
        D_delta_x_1_by_b_1_y*t39, D_delta_y_1_by_b_1_y*t39, D_delta_z_1_by_b_1_y*t39,
        D_delta_x_2_by_b_1_y*t284 + D_delta_y_2_by_b_1_y*t286 + D_delta_z_2_by_b_1_y*t288,
        D_delta_x_2_by_b_1_y*t289 + D_delta_x_3_by_b_1_y*t283 + D_delta_y_2_by_b_1_y*t290
        + D_delta_y_3_by_b_1_y*t285 + D_delta_z_2_by_b_1_y*t291 + D_delta_z_3_by_b_1_y*t287,
        D_delta_x_2_by_b_1_y*t39, D_delta_y_2_by_b_1_y*t39, D_delta_z_2_by_b_1_y*t39,
        D_delta_x_3_by_b_1_y*t292 + D_delta_y_3_by_b_1_y*t293 + D_delta_z_3_by_b_1_y*t294,
        D_delta_x_3_by_b_1_y*t39, D_delta_y_3_by_b_1_y*t39, D_delta_z_3_by_b_1_y*t39,
        D_p_x_1_by_b_1_z*t231 + D_p_y_1_by_b_1_z*t233 + D_p_z_1_by_b_1_z*t235 - t222*t302 - t224*t303
        - t226*t304,
        D_p_x_1_by_b_1_z*t242 - D_p_x_2*t305 + D_p_x_2_by_b_1_z*t243 + D_p_y_1_by_b_1_z*t245
        - D_p_y_2*t306 + D_p_y_2_by_b_1_z*t246 + D_p_z_1_by_b_1_z*t248 - D_p_z_2*t307
        + D_p_z_2_by_b_1_z*t249,
        D_p_x_1_by_b_1_z*t252 - D_p_x_3*t305 + D_p_x_3_by_b_1_z*t243 + D_p_y_1_by_b_1_z*t254
        - D_p_y_3*t306 + D_p_y_3_by_b_1_z*t246 + D_p_z_1_by_b_1_z*t256 - D_p_z_3*t307
        + D_p_z_3_by_b_1_z*t249,
        -D_delta_x_1*t305 + D_delta_x_1_by_b_1_z*t243 - D_delta_y_1*t306 + D_delta_y_1_by_b_1_z*t246
        - D_delta_z_1*t307 + D_delta_z_1_by_b_1_z*t249 + D_p_x_1_by_b_1_z*t274 + D_p_y_1_by_b_1_z*t276
        + D_p_z_1_by_b_1_z*t278,
        -D_delta_x_2*t305 + D_delta_x_2_by_b_1_z*t243 - D_delta_y_2*t306 + D_delta_y_2_by_b_1_z*t246
        - D_delta_z_2*t307 + D_delta_z_2_by_b_1_z*t249 + D_p_x_1_by_b_1_z*t283 + D_p_y_1_by_b_1_z*t285
        + D_p_z_1_by_b_1_z*t287,
        -D_delta_x_3*t305 + D_delta_x_3_by_b_1_z*t243 - D_delta_y_3*t306 + D_delta_y_3_by_b_1_z*t246
        - D_delta_z_3*t307 + D_delta_z_3_by_b_1_z*t249 + D_p_x_1_by_b_1_z*t289 + D_p_y_1_by_b_1_z*t290
        + D_p_z_1_by_b_1_z*t291,
        D_p_x_1_by_b_1_z*t39 - d_1_x*t308, D_p_y_1_by_b_1_z*t39 - d_1_y*t308,
        D_p_z_1_by_b_1_z*t39 - d_1_z*t308,
        D_p_x_2_by_b_1_z*t262 + D_p_y_2_by_b_1_z*t263 + D_p_z_2_by_b_1_z*t264,
        D_p_x_2_by_b_1_z*t252 + D_p_x_3_by_b_1_z*t242 + D_p_y_2_by_b_1_z*t254 + D_p_y_3_by_b_1_z*t245
        + D_p_z_2_by_b_1_z*t256 + D_p_z_3_by_b_1_z*t248,
        D_delta_x_1_by_b_1_z*t242 + D_delta_y_1_by_b_1_z*t245 + D_delta_z_1_by_b_1_z*t248
        + D_p_x_2_by_b_1_z*t274 + D_p_y_2_by_b_1_z*t276 + D_p_z_2_by_b_1_z*t278,
        D_delta_x_2_by_b_1_z*t242 + D_delta_y_2_by_b_1_z*t245 + D_delta_z_2_by_b_1_z*t248
        + D_p_x_2_by_b_1_z*t283 + D_p_y_2_by_b_1_z*t285 + D_p_z_2_by_b_1_z*t287,
        D_delta_x_3_by_b_1_z*t242 + D_delta_y_3_by_b_1_z*t245 + D_delta_z_3_by_b_1_z*t248
        + D_p_x_2_by_b_1_z*t289 + D_p_y_2_by_b_1_z*t290 + D_p_z_2_by_b_1_z*t291,
        D_p_x_2_by_b_1_z*t39, D_p_y_2_by_b_1_z*t39, D_p_z_2_by_b_1_z*t39,
        D_p_x_3_by_b_1_z*t268 + D_p_y_3_by_b_1_z*t269 + D_p_z_3_by_b_1_z*t270,
        D_delta_x_1_by_b_1_z*t252 + D_delta_y_1_by_b_1_z*t254 + D_delta_z_1_by_b_1_z*t256
        + D_p_x_3_by_b_1_z*t274 + D_p_y_3_by_b_1_z*t276 + D_p_z_3_by_b_1_z*t278,
        D_delta_x_2_by_b_1_z*t252 + D_delta_y_2_by_b_1_z*t254 + D_delta_z_2_by_b_1_z*t256
        + D_p_x_3_by_b_1_z*t283 + D_p_y_3_by_b_1_z*t285 + D_p_z_3_by_b_1_z*t287,
        D_delta_x_3_by_b_1_z*t252 + D_delta_y_3_by_b_1_z*t254 + D_delta_z_3_by_b_1_z*t256
        + D_p_x_3_by_b_1_z*t289 + D_p_y_3_by_b_1_z*t290 + D_p_z_3_by_b_1_z*t291,
        D_p_x_3_by_b_1_z*t39, D_p_y_3_by_b_1_z*t39, D_p_z_3_by_b_1_z*t39,
        D_delta_x_1_by_b_1_z*t275 + D_delta_y_1_by_b_1_z*t277 + D_delta_z_1_by_b_1_z*t279,
        D_delta_x_1_by_b_1_z*t283 + D_delta_x_2_by_b_1_z*t274 + D_delta_y_1_by_b_1_z*t285
        + D_delta_y_2_by_b_1_z*t276 + D_delta_z_1_by_b_1_z*t287 + D_delta_z_2_by_b_1_z*t278,
        D_delta_x_1_by_b_1_z*t289 + D_delta_x_3_by_b_1_z*t274 + D_delta_y_1_by_b_1_z*t290
        + D_delta_y_3_by_b_1_z*t276 + D_delta_z_1_by_b_1_z*t291 + D_delta_z_3_by_b_1_z*t278,
        D_delta_x_1_by_b_1_z*t39, D_delta_y_1_by_b_1_z*t39, D_delta_z_1_by_b_1_z*t39,
        D_delta_x_2_by_b_1_z*t284 + D_delta_y_2_by_b_1_z*t286 + D_delta_z_2_by_b_1_z*t288,
        D_delta_x_2_by_b_1_z*t289 + D_delta_x_3_by_b_1_z*t283 + D_delta_y_2_by_b_1_z*t290
        + D_delta_y_3_by_b_1_z*t285 + D_delta_z_2_by_b_1_z*t291 + D_delta_z_3_by_b_1_z*t287,
        D_delta_x_2_by_b_1_z*t39, D_delta_y_2_by_b_1_z*t39, D_delta_z_2_by_b_1_z*t39,
        D_delta_x_3_by_b_1_z*t292 + D_delta_y_3_by_b_1_z*t293 + D_delta_z_3_by_b_1_z*t294,
        D_delta_x_3_by_b_1_z*t39, D_delta_y_3_by_b_1_z*t39, D_delta_z_3_by_b_1_z*t39,
        D_p_x_1_by_b_2_x*t231 + D_p_y_1_by_b_2_x*t233 + D_p_z_1_by_b_2_x*t235,
        -D_p_x_1*t310 + D_p_x_1_by_b_2_x*t242 + D_p_x_2_by_b_2_x*t243 - D_p_y_1*t312
        + D_p_y_1_by_b_2_x*t245 + D_p_y_2_by_b_2_x*t246 - D_p_z_1*t314 + D_p_z_1_by_b_2_x*t248
        + D_p_z_2_by_b_2_x*t249,
        D_p_x_1_by_b_2_x*t252 + D_p_x_3_by_b_2_x*t243 + D_p_y_1_by_b_2_x*t254 + D_p_y_3_by_b_2_x*t246
        + D_p_z_1_by_b_2_x*t256 + D_p_z_3_by_b_2_x*t249,
        D_delta_x_1_by_b_2_x*t243 + D_delta_y_1_by_b_2_x*t246 + D_delta_z_1_by_b_2_x*t249
        + D_p_x_1_by_b_2_x*t274 + D_p_y_1_by_b_2_x*t276 + D_p_z_1_by_b_2_x*t278,
        D_delta_x_2_by_b_2_x*t243 + D_delta_y_2_by_b_2_x*t246 + D_delta_z_2_by_b_2_x*t249
        + D_p_x_1_by_b_2_x*t283 + D_p_y_1_by_b_2_x*t285 + D_p_z_1_by_b_2_x*t287,
        D_delta_x_3_by_b_2_x*t243 + D_delta_y_3_by_b_2_x*t246 + D_delta_z_3_by_b_2_x*t249
        + D_p_x_1_by_b_2_x*t289 + D_p_y_1_by_b_2_x*t290 + D_p_z_1_by_b_2_x*t291,
        D_p_x_1_by_b_2_x*t39, D_p_y_1_by_b_2_x*t39, D_p_z_1_by_b_2_x*t39,
        D_p_x_2_by_b_2_x*t262 + D_p_y_2_by_b_2_x*t263 + D_p_z_2_by_b_2_x*t264 - t309*t315 - t311*t316
        - t313*t317,
        D_p_x_2_by_b_2_x*t252 - D_p_x_3*t310 + D_p_x_3_by_b_2_x*t242 + D_p_y_2_by_b_2_x*t254
        - D_p_y_3*t312 + D_p_y_3_by_b_2_x*t245 + D_p_z_2_by_b_2_x*t256 - D_p_z_3*t314
        + D_p_z_3_by_b_2_x*t248,
        -D_delta_x_1*t310 + D_delta_x_1_by_b_2_x*t242 - D_delta_y_1*t312 + D_delta_y_1_by_b_2_x*t245
        - D_delta_z_1*t314 + D_delta_z_1_by_b_2_x*t248 + D_p_x_2_by_b_2_x*t274 + D_p_y_2_by_b_2_x*t276
        + D_p_z_2_by_b_2_x*t278,
        -D_delta_x_2*t310 + D_delta_x_2_by_b_2_x*t242 - D_delta_y_2*t312 + D_delta_y_2_by_b_2_x*t245
        - D_delta_z_2*t314 + D_delta_z_2_by_b_2_x*t248 + D_p_x_2_by_b_2_x*t283 + D_p_y_2_by_b_2_x*t285
        + D_p_z_2_by_b_2_x*t287,
        -D_delta_x_3*t310 + D_delta_x_3_by_b_2_x*t242 - D_delta_y_3*t312 + D_delta_y_3_by_b_2_x*t245
        - D_delta_z_3*t314 + D_delta_z_3_by_b_2_x*t248 + D_p_x_2_by_b_2_x*t289 + D_p_y_2_by_b_2_x*t290
        + D_p_z_2_by_b_2_x*t291,
        D_p_x_2_by_b_2_x*t39 - d_2_x*t319, D_p_y_2_by_b_2_x*t39 - d_2_y*t319,
        D_p_z_2_by_b_2_x*t39 - d_2_z*t319,
        D_p_x_3_by_b_2_x*t268 + D_p_y_3_by_b_2_x*t269 + D_p_z_3_by_b_2_x*t270,
        D_delta_x_1_by_b_2_x*t252 + D_delta_y_1_by_b_2_x*t254 + D_delta_z_1_by_b_2_x*t256
        + D_p_x_3_by_b_2_x*t274 + D_p_y_3_by_b_2_x*t276 + D_p_z_3_by_b_2_x*t278,
        D_delta_x_2_by_b_2_x*t252 + D_delta_y_2_by_b_2_x*t254 + D_delta_z_2_by_b_2_x*t256
        + D_p_x_3_by_b_2_x*t283 + D_p_y_3_by_b_2_x*t285 + D_p_z_3_by_b_2_x*t287,
        D_delta_x_3_by_b_2_x*t252 + D_delta_y_3_by_b_2_x*t254 + D_delta_z_3_by_b_2_x*t256
        + D_p_x_3_by_b_2_x*t289 + D_p_y_3_by_b_2_x*t290 + D_p_z_3_by_b_2_x*t291,
        D_p_x_3_by_b_2_x*t39, D_p_y_3_by_b_2_x*t39, D_p_z_3_by_b_2_x*t39,
        D_delta_x_1_by_b_2_x*t275 + D_delta_y_1_by_b_2_x*t277 + D_delta_z_1_by_b_2_x*t279,
        D_delta_x_1_by_b_2_x*t283 + D_delta_x_2_by_b_2_x*t274 + D_delta_y_1_by_b_2_x*t285
        + D_delta_y_2_by_b_2_x*t276 + D_delta_z_1_by_b_2_x*t287 + D_delta_z_2_by_b_2_x*t278,
        D_delta_x_1_by_b_2_x*t289 + D_delta_x_3_by_b_2_x*t274 + D_delta_y_1_by_b_2_x*t290
        + D_delta_y_3_by_b_2_x*t276 + D_delta_z_1_by_b_2_x*t291 + D_delta_z_3_by_b_2_x*t278,
        D_delta_x_1_by_b_2_x*t39, D_delta_y_1_by_b_2_x*t39, D_delta_z_1_by_b_2_x*t39,
        D_delta_x_2_by_b_2_x*t284 + D_delta_y_2_by_b_2_x*t286 + D_delta_z_2_by_b_2_x*t288,
        D_delta_x_2_by_b_2_x*t289 + D_delta_x_3_by_b_2_x*t283 + D_delta_y_2_by_b_2_x*t290
        + D_delta_y_3_by_b_2_x*t285 + D_delta_z_2_by_b_2_x*t291 + D_delta_z_3_by_b_2_x*t287,
        D_delta_x_2_by_b_2_x*t39, D_delta_y_2_by_b_2_x*t39, D_delta_z_2_by_b_2_x*t39,
        D_delta_x_3_by_b_2_x*t292 + D_delta_y_3_by_b_2_x*t293 + D_delta_z_3_by_b_2_x*t294,
        D_delta_x_3_by_b_2_x*t39, D_delta_y_3_by_b_2_x*t39, D_delta_z_3_by_b_2_x*t39,
        D_p_x_1_by_b_2_y*t231 + D_p_y_1_by_b_2_y*t233 + D_p_z_1_by_b_2_y*t235,
        -D_p_x_1*t321 + D_p_x_1_by_b_2_y*t242 + D_p_x_2_by_b_2_y*t243 - D_p_y_1*t323
        + D_p_y_1_by_b_2_y*t245 + D_p_y_2_by_b_2_y*t246 - D_p_z_1*t325 + D_p_z_1_by_b_2_y*t248
        + D_p_z_2_by_b_2_y*t249,
        D_p_x_1_by_b_2_y*t252 + D_p_x_3_by_b_2_y*t243 + D_p_y_1_by_b_2_y*t254 + D_p_y_3_by_b_2_y*t246
        + D_p_z_1_by_b_2_y*t256 + D_p_z_3_by_b_2_y*t249,
        D_delta_x_1_by_b_2_y*t243 + D_delta_y_1_by_b_2_y*t246 + D_delta_z_1_by_b_2_y*t249
        + D_p_x_1_by_b_2_y*t274 + D_p_y_1_by_b_2_y*t276 + D_p_z_1_by_b_2_y*t278,
        D_delta_x_2_by_b_2_y*t243 + D_delta_y_2_by_b_2_y*t246 + D_delta_z_2_by_b_2_y*t249
        + D_p_x_1_by_b_2_y*t283 + D_p_y_1_by_b_2_y*t285 + D_p_z_1_by_b_2_y*t287,
        D_delta_x_3_by_b_2_y*t243 + D_delta_y_3_by_b_2_y*t246 + D_delta_z_3_by_b_2_y*t249
        + D_p_x_1_by_b_2_y*t289 + D_p_y_1_by_b_2_y*t290 + D_p_z_1_by_b_2_y*t291,
        D_p_x_1_by_b_2_y*t39, D_p_y_1_by_b_2_y*t39, D_p_z_1_by_b_2_y*t39,
        D_p_x_2_by_b_2_y*t262 + D_p_y_2_by_b_2_y*t263 + D_p_z_2_by_b_2_y*t264 - t315*t320 - t316*t322
        - t317*t324,
        D_p_x_2_by_b_2_y*t252 - D_p_x_3*t321 + D_p_x_3_by_b_2_y*t242 + D_p_y_2_by_b_2_y*t254
        - D_p_y_3*t323 + D_p_y_3_by_b_2_y*t245 + D_p_z_2_by_b_2_y*t256 - D_p_z_3*t325
        + D_p_z_3_by_b_2_y*t248,
        -D_delta_x_1*t321 + D_delta_x_1_by_b_2_y*t242 - D_delta_y_1*t323 + D_delta_y_1_by_b_2_y*t245
        - D_delta_z_1*t325 + D_delta_z_1_by_b_2_y*t248 + D_p_x_2_by_b_2_y*t274 + D_p_y_2_by_b_2_y*t276
        + D_p_z_2_by_b_2_y*t278,
        -D_delta_x_2*t321 + D_delta_x_2_by_b_2_y*t242 - D_delta_y_2*t323 + D_delta_y_2_by_b_2_y*t245
        - D_delta_z_2*t325 + D_delta_z_2_by_b_2_y*t248 + D_p_x_2_by_b_2_y*t283 + D_p_y_2_by_b_2_y*t285
        + D_p_z_2_by_b_2_y*t287,
        -D_delta_x_3*t321 + D_delta_x_3_by_b_2_y*t242 - D_delta_y_3*t323 + D_delta_y_3_by_b_2_y*t245
        - D_delta_z_3*t325 + D_delta_z_3_by_b_2_y*t248 + D_p_x_2_by_b_2_y*t289 + D_p_y_2_by_b_2_y*t290
        + D_p_z_2_by_b_2_y*t291,
        D_p_x_2_by_b_2_y*t39 - d_2_x*t326, D_p_y_2_by_b_2_y*t39 - d_2_y*t326,
        D_p_z_2_by_b_2_y*t39 - d_2_z*t326,
        D_p_x_3_by_b_2_y*t268 + D_p_y_3_by_b_2_y*t269 + D_p_z_3_by_b_2_y*t270,
        D_delta_x_1_by_b_2_y*t252 + D_delta_y_1_by_b_2_y*t254 + D_delta_z_1_by_b_2_y*t256
        + D_p_x_3_by_b_2_y*t274 + D_p_y_3_by_b_2_y*t276 + D_p_z_3_by_b_2_y*t278,
        D_delta_x_2_by_b_2_y*t252 + D_delta_y_2_by_b_2_y*t254 + D_delta_z_2_by_b_2_y*t256
        + D_p_x_3_by_b_2_y*t283 + D_p_y_3_by_b_2_y*t285 + D_p_z_3_by_b_2_y*t287,
        D_delta_x_3_by_b_2_y*t252 + D_delta_y_3_by_b_2_y*t254 + D_delta_z_3_by_b_2_y*t256
        + D_p_x_3_by_b_2_y*t289 + D_p_y_3_by_b_2_y*t290 + D_p_z_3_by_b_2_y*t291,
        D_p_x_3_by_b_2_y*t39, D_p_y_3_by_b_2_y*t39, D_p_z_3_by_b_2_y*t39,
        D_delta_x_1_by_b_2_y*t275 + D_delta_y_1_by_b_2_y*t277 + D_delta_z_1_by_b_2_y*t279,
        D_delta_x_1_by_b_2_y*t283 + D_delta_x_2_by_b_2_y*t274 + D_delta_y_1_by_b_2_y*t285
        + D_delta_y_2_by_b_2_y*t276 + D_delta_z_1_by_b_2_y*t287 + D_delta_z_2_by_b_2_y*t278,
        D_delta_x_1_by_b_2_y*t289 + D_delta_x_3_by_b_2_y*t274 + D_delta_y_1_by_b_2_y*t290
        + D_delta_y_3_by_b_2_y*t276 + D_delta_z_1_by_b_2_y*t291 + D_delta_z_3_by_b_2_y*t278,
        D_delta_x_1_by_b_2_y*t39, D_delta_y_1_by_b_2_y*t39, D_delta_z_1_by_b_2_y*t39,
        D_delta_x_2_by_b_2_y*t284 + D_delta_y_2_by_b_2_y*t286 + D_delta_z_2_by_b_2_y*t288,
        D_delta_x_2_by_b_2_y*t289 + D_delta_x_3_by_b_2_y*t283 + D_delta_y_2_by_b_2_y*t290
        + D_delta_y_3_by_b_2_y*t285 + D_delta_z_2_by_b_2_y*t291 + D_delta_z_3_by_b_2_y*t287,
        D_delta_x_2_by_b_2_y*t39, D_delta_y_2_by_b_2_y*t39, D_delta_z_2_by_b_2_y*t39,
        D_delta_x_3_by_b_2_y*t292 + D_delta_y_3_by_b_2_y*t293 + D_delta_z_3_by_b_2_y*t294,
        D_delta_x_3_by_b_2_y*t39, D_delta_y_3_by_b_2_y*t39, D_delta_z_3_by_b_2_y*t39,
        D_p_x_1_by_b_2_z*t231 + D_p_y_1_by_b_2_z*t233 + D_p_z_1_by_b_2_z*t235,
        -D_p_x_1*t328 + D_p_x_1_by_b_2_z*t242 + D_p_x_2_by_b_2_z*t243 - D_p_y_1*t330
        + D_p_y_1_by_b_2_z*t245 + D_p_y_2_by_b_2_z*t246 - D_p_z_1*t332 + D_p_z_1_by_b_2_z*t248
        + D_p_z_2_by_b_2_z*t249,
        D_p_x_1_by_b_2_z*t252 + D_p_x_3_by_b_2_z*t243 + D_p_y_1_by_b_2_z*t254 + D_p_y_3_by_b_2_z*t246
        + D_p_z_1_by_b_2_z*t256 + D_p_z_3_by_b_2_z*t249,
        D_delta_x_1_by_b_2_z*t243 + D_delta_y_1_by_b_2_z*t246 + D_delta_z_1_by_b_2_z*t249
        + D_p_x_1_by_b_2_z*t274 + D_p_y_1_by_b_2_z*t276 + D_p_z_1_by_b_2_z*t278,
        D_delta_x_2_by_b_2_z*t243 + D_delta_y_2_by_b_2_z*t246 + D_delta_z_2_by_b_2_z*t249
        + D_p_x_1_by_b_2_z*t283 + D_p_y_1_by_b_2_z*t285 + D_p_z_1_by_b_2_z*t287,
        D_delta_x_3_by_b_2_z*t243 + D_delta_y_3_by_b_2_z*t246 + D_delta_z_3_by_b_2_z*t249
        + D_p_x_1_by_b_2_z*t289 + D_p_y_1_by_b_2_z*t290 + D_p_z_1_by_b_2_z*t291,
        D_p_x_1_by_b_2_z*t39, D_p_y_1_by_b_2_z*t39, D_p_z_1_by_b_2_z*t39,
        D_p_x_2_by_b_2_z*t262 + D_p_y_2_by_b_2_z*t263 + D_p_z_2_by_b_2_z*t264 - t315*t327 - t316*t329
        - t317*t331,
        D_p_x_2_by_b_2_z*t252 - D_p_x_3*t328 + D_p_x_3_by_b_2_z*t242 + D_p_y_2_by_b_2_z*t254
        - D_p_y_3*t330 + D_p_y_3_by_b_2_z*t245 + D_p_z_2_by_b_2_z*t256 - D_p_z_3*t332
        + D_p_z_3_by_b_2_z*t248,
        -D_delta_x_1*t328 + D_delta_x_1_by_b_2_z*t242 - D_delta_y_1*t330 + D_delta_y_1_by_b_2_z*t245
        - D_delta_z_1*t332 + D_delta_z_1_by_b_2_z*t248 + D_p_x_2_by_b_2_z*t274 + D_p_y_2_by_b_2_z*t276
        + D_p_z_2_by_b_2_z*t278,
        -D_delta_x_2*t328 + D_delta_x_2_by_b_2_z*t242 - D_delta_y_2*t330 + D_delta_y_2_by_b_2_z*t245
        - D_delta_z_2*t332 + D_delta_z_2_by_b_2_z*t248 + D_p_x_2_by_b_2_z*t283 + D_p_y_2_by_b_2_z*t285
        + D_p_z_2_by_b_2_z*t287,
        -D_delta_x_3*t328 + D_delta_x_3_by_b_2_z*t242 - D_delta_y_3*t330 + D_delta_y_3_by_b_2_z*t245
        - D_delta_z_3*t332 + D_delta_z_3_by_b_2_z*t248 + D_p_x_2_by_b_2_z*t289 + D_p_y_2_by_b_2_z*t290
        + D_p_z_2_by_b_2_z*t291,
        D_p_x_2_by_b_2_z*t39 - d_2_x*t333, D_p_y_2_by_b_2_z*t39 - d_2_y*t333,
        D_p_z_2_by_b_2_z*t39 - d_2_z*t333,
        D_p_x_3_by_b_2_z*t268 + D_p_y_3_by_b_2_z*t269 + D_p_z_3_by_b_2_z*t270,
        D_delta_x_1_by_b_2_z*t252 + D_delta_y_1_by_b_2_z*t254 + D_delta_z_1_by_b_2_z*t256
        + D_p_x_3_by_b_2_z*t274 + D_p_y_3_by_b_2_z*t276 + D_p_z_3_by_b_2_z*t278,
        D_delta_x_2_by_b_2_z*t252 + D_delta_y_2_by_b_2_z*t254 + D_delta_z_2_by_b_2_z*t256
        + D_p_x_3_by_b_2_z*t283 + D_p_y_3_by_b_2_z*t285 + D_p_z_3_by_b_2_z*t287,
        D_delta_x_3_by_b_2_z*t252 + D_delta_y_3_by_b_2_z*t254 + D_delta_z_3_by_b_2_z*t256
        + D_p_x_3_by_b_2_z*t289 + D_p_y_3_by_b_2_z*t290 + D_p_z_3_by_b_2_z*t291,
        D_p_x_3_by_b_2_z*t39, D_p_y_3_by_b_2_z*t39, D_p_z_3_by_b_2_z*t39,
        D_delta_x_1_by_b_2_z*t275 + D_delta_y_1_by_b_2_z*t277 + D_delta_z_1_by_b_2_z*t279,
        D_delta_x_1_by_b_2_z*t283 + D_delta_x_2_by_b_2_z*t274 + D_delta_y_1_by_b_2_z*t285
        + D_delta_y_2_by_b_2_z*t276 + D_delta_z_1_by_b_2_z*t287 + D_delta_z_2_by_b_2_z*t278,
        D_delta_x_1_by_b_2_z*t289 + D_delta_x_3_by_b_2_z*t274 + D_delta_y_1_by_b_2_z*t290
        + D_delta_y_3_by_b_2_z*t276 + D_delta_z_1_by_b_2_z*t291 + D_delta_z_3_by_b_2_z*t278,
        D_delta_x_1_by_b_2_z*t39, D_delta_y_1_by_b_2_z*t39, D_delta_z_1_by_b_2_z*t39,
        D_delta_x_2_by_b_2_z*t284 + D_delta_y_2_by_b_2_z*t286 + D_delta_z_2_by_b_2_z*t288,
        D_delta_x_2_by_b_2_z*t289 + D_delta_x_3_by_b_2_z*t283 + D_delta_y_2_by_b_2_z*t290
        + D_delta_y_3_by_b_2_z*t285 + D_delta_z_2_by_b_2_z*t291 + D_delta_z_3_by_b_2_z*t287,
        D_delta_x_2_by_b_2_z*t39, D_delta_y_2_by_b_2_z*t39, D_delta_z_2_by_b_2_z*t39,
        D_delta_x_3_by_b_2_z*t292 + D_delta_y_3_by_b_2_z*t293 + D_delta_z_3_by_b_2_z*t294,
        D_delta_x_3_by_b_2_z*t39, D_delta_y_3_by_b_2_z*t39, D_delta_z_3_by_b_2_z*t39,
        D_p_x_1_by_b_3_x*t231 + D_p_y_1_by_b_3_x*t233 + D_p_z_1_by_b_3_x*t235,
        D_p_x_1_by_b_3_x*t242 + D_p_x_2_by_b_3_x*t243 + D_p_y_1_by_b_3_x*t245 + D_p_y_2_by_b_3_x*t246
        + D_p_z_1_by_b_3_x*t248 + D_p_z_2_by_b_3_x*t249,
        -D_p_x_1*t335 + D_p_x_1_by_b_3_x*t252 + D_p_x_3_by_b_3_x*t243 - D_p_y_1*t337
        + D_p_y_1_by_b_3_x*t254 + D_p_y_3_by_b_3_x*t246 - D_p_z_1*t339 + D_p_z_1_by_b_3_x*t256
        + D_p_z_3_by_b_3_x*t249,
        D_delta_x_1_by_b_3_x*t243 + D_delta_y_1_by_b_3_x*t246 + D_delta_z_1_by_b_3_x*t249
        + D_p_x_1_by_b_3_x*t274 + D_p_y_1_by_b_3_x*t276 + D_p_z_1_by_b_3_x*t278,
        D_delta_x_2_by_b_3_x*t243 + D_delta_y_2_by_b_3_x*t246 + D_delta_z_2_by_b_3_x*t249
        + D_p_x_1_by_b_3_x*t283 + D_p_y_1_by_b_3_x*t285 + D_p_z_1_by_b_3_x*t287,
        D_delta_x_3_by_b_3_x*t243 + D_delta_y_3_by_b_3_x*t246 + D_delta_z_3_by_b_3_x*t249
        + D_p_x_1_by_b_3_x*t289 + D_p_y_1_by_b_3_x*t290 + D_p_z_1_by_b_3_x*t291,
        D_p_x_1_by_b_3_x*t39, D_p_y_1_by_b_3_x*t39, D_p_z_1_by_b_3_x*t39,
        D_p_x_2_by_b_3_x*t262 + D_p_y_2_by_b_3_x*t263 + D_p_z_2_by_b_3_x*t264,
        -D_p_x_2*t335 + D_p_x_2_by_b_3_x*t252 + D_p_x_3_by_b_3_x*t242 - D_p_y_2*t337
        + D_p_y_2_by_b_3_x*t254 + D_p_y_3_by_b_3_x*t245 - D_p_z_2*t339 + D_p_z_2_by_b_3_x*t256
        + D_p_z_3_by_b_3_x*t248,
        D_delta_x_1_by_b_3_x*t242 + D_delta_y_1_by_b_3_x*t245 + D_delta_z_1_by_b_3_x*t248
        + D_p_x_2_by_b_3_x*t274 + D_p_y_2_by_b_3_x*t276 + D_p_z_2_by_b_3_x*t278,
        D_delta_x_2_by_b_3_x*t242 + D_delta_y_2_by_b_3_x*t245 + D_delta_z_2_by_b_3_x*t248
        + D_p_x_2_by_b_3_x*t283 + D_p_y_2_by_b_3_x*t285 + D_p_z_2_by_b_3_x*t287,
        D_delta_x_3_by_b_3_x*t242 + D_delta_y_3_by_b_3_x*t245 + D_delta_z_3_by_b_3_x*t248
        + D_p_x_2_by_b_3_x*t289 + D_p_y_2_by_b_3_x*t290 + D_p_z_2_by_b_3_x*t291,
        D_p_x_2_by_b_3_x*t39, D_p_y_2_by_b_3_x*t39, D_p_z_2_by_b_3_x*t39,
        D_p_x_3_by_b_3_x*t268 + D_p_y_3_by_b_3_x*t269 + D_p_z_3_by_b_3_x*t270 - t334*t340 - t336*t341
        - t338*t342,
        -D_delta_x_1*t335 + D_delta_x_1_by_b_3_x*t252 - D_delta_y_1*t337 + D_delta_y_1_by_b_3_x*t254
        - D_delta_z_1*t339 + D_delta_z_1_by_b_3_x*t256 + D_p_x_3_by_b_3_x*t274 + D_p_y_3_by_b_3_x*t276
        + D_p_z_3_by_b_3_x*t278,
        -D_delta_x_2*t335 + D_delta_x_2_by_b_3_x*t252 - D_delta_y_2*t337 + D_delta_y_2_by_b_3_x*t254
        - D_delta_z_2*t339 + D_delta_z_2_by_b_3_x*t256 + D_p_x_3_by_b_3_x*t283 + D_p_y_3_by_b_3_x*t285
        + D_p_z_3_by_b_3_x*t287,
        -D_delta_x_3*t335 + D_delta_x_3_by_b_3_x*t252 - D_delta_y_3*t337 + D_delta_y_3_by_b_3_x*t254
        - D_delta_z_3*t339 + D_delta_z_3_by_b_3_x*t256 + D_p_x_3_by_b_3_x*t289 + D_p_y_3_by_b_3_x*t290
        + D_p_z_3_by_b_3_x*t291,
        D_p_x_3_by_b_3_x*t39 - d_3_x*t344, D_p_y_3_by_b_3_x*t39 - d_3_y*t344,
        D_p_z_3_by_b_3_x*t39 - d_3_z*t344,
        D_delta_x_1_by_b_3_x*t275 + D_delta_y_1_by_b_3_x*t277 + D_delta_z_1_by_b_3_x*t279,
        D_delta_x_1_by_b_3_x*t283 + D_delta_x_2_by_b_3_x*t274 + D_delta_y_1_by_b_3_x*t285
        + D_delta_y_2_by_b_3_x*t276 + D_delta_z_1_by_b_3_x*t287 + D_delta_z_2_by_b_3_x*t278,
        D_delta_x_1_by_b_3_x*t289 + D_delta_x_3_by_b_3_x*t274 + D_delta_y_1_by_b_3_x*t290
        + D_delta_y_3_by_b_3_x*t276 + D_delta_z_1_by_b_3_x*t291 + D_delta_z_3_by_b_3_x*t278,
        D_delta_x_1_by_b_3_x*t39, D_delta_y_1_by_b_3_x*t39, D_delta_z_1_by_b_3_x*t39,
        D_delta_x_2_by_b_3_x*t284 + D_delta_y_2_by_b_3_x*t286 + D_delta_z_2_by_b_3_x*t288,
        D_delta_x_2_by_b_3_x*t289 + D_delta_x_3_by_b_3_x*t283 + D_delta_y_2_by_b_3_x*t290
        + D_delta_y_3_by_b_3_x*t285 + D_delta_z_2_by_b_3_x*t291 + D_delta_z_3_by_b_3_x*t287,
        D_delta_x_2_by_b_3_x*t39, D_delta_y_2_by_b_3_x*t39, D_delta_z_2_by_b_3_x*t39,
        D_delta_x_3_by_b_3_x*t292 + D_delta_y_3_by_b_3_x*t293 + D_delta_z_3_by_b_3_x*t294,
        D_delta_x_3_by_b_3_x*t39, D_delta_y_3_by_b_3_x*t39, D_delta_z_3_by_b_3_x*t39,
        D_p_x_1_by_b_3_y*t231 + D_p_y_1_by_b_3_y*t233 + D_p_z_1_by_b_3_y*t235,
        D_p_x_1_by_b_3_y*t242 + D_p_x_2_by_b_3_y*t243 + D_p_y_1_by_b_3_y*t245 + D_p_y_2_by_b_3_y*t246
        + D_p_z_1_by_b_3_y*t248 + D_p_z_2_by_b_3_y*t249,
        -D_p_x_1*t346 + D_p_x_1_by_b_3_y*t252 + D_p_x_3_by_b_3_y*t243 - D_p_y_1*t348
        + D_p_y_1_by_b_3_y*t254 + D_p_y_3_by_b_3_y*t246 - D_p_z_1*t350 + D_p_z_1_by_b_3_y*t256
        + D_p_z_3_by_b_3_y*t249,
        D_delta_x_1_by_b_3_y*t243 + D_delta_y_1_by_b_3_y*t246 + D_delta_z_1_by_b_3_y*t249
        + D_p_x_1_by_b_3_y*t274 + D_p_y_1_by_b_3_y*t276 + D_p_z_1_by_b_3_y*t278,
        D_delta_x_2_by_b_3_y*t243 + D_delta_y_2_by_b_3_y*t246 + D_delta_z_2_by_b_3_y*t249
        + D_p_x_1_by_b_3_y*t283 + D_p_y_1_by_b_3_y*t285 + D_p_z_1_by_b_3_y*t287,
        D_delta_x_3_by_b_3_y*t243 + D_delta_y_3_by_b_3_y*t246 + D_delta_z_3_by_b_3_y*t249
        + D_p_x_1_by_b_3_y*t289 + D_p_y_1_by_b_3_y*t290 + D_p_z_1_by_b_3_y*t291,
        D_p_x_1_by_b_3_y*t39, D_p_y_1_by_b_3_y*t39, D_p_z_1_by_b_3_y*t39,
        D_p_x_2_by_b_3_y*t262 + D_p_y_2_by_b_3_y*t263 + D_p_z_2_by_b_3_y*t264,
        -D_p_x_2*t346 + D_p_x_2_by_b_3_y*t252 + D_p_x_3_by_b_3_y*t242 - D_p_y_2*t348
        + D_p_y_2_by_b_3_y*t254 + D_p_y_3_by_b_3_y*t245 - D_p_z_2*t350 + D_p_z_2_by_b_3_y*t256
        + D_p_z_3_by_b_3_y*t248,
        D_delta_x_1_by_b_3_y*t242 + D_delta_y_1_by_b_3_y*t245 + D_delta_z_1_by_b_3_y*t248
        + D_p_x_2_by_b_3_y*t274 + D_p_y_2_by_b_3_y*t276 + D_p_z_2_by_b_3_y*t278,
        D_delta_x_2_by_b_3_y*t242 + D_delta_y_2_by_b_3_y*t245 + D_delta_z_2_by_b_3_y*t248
        + D_p_x_2_by_b_3_y*t283 + D_p_y_2_by_b_3_y*t285 + D_p_z_2_by_b_3_y*t287,
        D_delta_x_3_by_b_3_y*t242 + D_delta_y_3_by_b_3_y*t245 + D_delta_z_3_by_b_3_y*t248
        + D_p_x_2_by_b_3_y*t289 + D_p_y_2_by_b_3_y*t290 + D_p_z_2_by_b_3_y*t291,
        D_p_x_2_by_b_3_y*t39, D_p_y_2_by_b_3_y*t39, D_p_z_2_by_b_3_y*t39,
        D_p_x_3_by_b_3_y*t268 + D_p_y_3_by_b_3_y*t269 + D_p_z_3_by_b_3_y*t270 - t340*t345 - t341*t347
        - t342*t349,
        -D_delta_x_1*t346 + D_delta_x_1_by_b_3_y*t252 - D_delta_y_1*t348 + D_delta_y_1_by_b_3_y*t254
        - D_delta_z_1*t350 + D_delta_z_1_by_b_3_y*t256 + D_p_x_3_by_b_3_y*t274 + D_p_y_3_by_b_3_y*t276
        + D_p_z_3_by_b_3_y*t278,
        -D_delta_x_2*t346 + D_delta_x_2_by_b_3_y*t252 - D_delta_y_2*t348 + D_delta_y_2_by_b_3_y*t254
        - D_delta_z_2*t350 + D_delta_z_2_by_b_3_y*t256 + D_p_x_3_by_b_3_y*t283 + D_p_y_3_by_b_3_y*t285
        + D_p_z_3_by_b_3_y*t287,
        -D_delta_x_3*t346 + D_delta_x_3_by_b_3_y*t252 - D_delta_y_3*t348 + D_delta_y_3_by_b_3_y*t254
        - D_delta_z_3*t350 + D_delta_z_3_by_b_3_y*t256 + D_p_x_3_by_b_3_y*t289 + D_p_y_3_by_b_3_y*t290
        + D_p_z_3_by_b_3_y*t291,
        D_p_x_3_by_b_3_y*t39 - d_3_x*t351, D_p_y_3_by_b_3_y*t39 - d_3_y*t351,
        D_p_z_3_by_b_3_y*t39 - d_3_z*t351,
        D_delta_x_1_by_b_3_y*t275 + D_delta_y_1_by_b_3_y*t277 + D_delta_z_1_by_b_3_y*t279,
        D_delta_x_1_by_b_3_y*t283 + D_delta_x_2_by_b_3_y*t274 + D_delta_y_1_by_b_3_y*t285
        + D_delta_y_2_by_b_3_y*t276 + D_delta_z_1_by_b_3_y*t287 + D_delta_z_2_by_b_3_y*t278,
        D_delta_x_1_by_b_3_y*t289 + D_delta_x_3_by_b_3_y*t274 + D_delta_y_1_by_b_3_y*t290
        + D_delta_y_3_by_b_3_y*t276 + D_delta_z_1_by_b_3_y*t291 + D_delta_z_3_by_b_3_y*t278,
        D_delta_x_1_by_b_3_y*t39, D_delta_y_1_by_b_3_y*t39, D_delta_z_1_by_b_3_y*t39,
        D_delta_x_2_by_b_3_y*t284 + D_delta_y_2_by_b_3_y*t286 + D_delta_z_2_by_b_3_y*t288,
        D_delta_x_2_by_b_3_y*t289 + D_delta_x_3_by_b_3_y*t283 + D_delta_y_2_by_b_3_y*t290
        + D_delta_y_3_by_b_3_y*t285 + D_delta_z_2_by_b_3_y*t291 + D_delta_z_3_by_b_3_y*t287,
        D_delta_x_2_by_b_3_y*t39, D_delta_y_2_by_b_3_y*t39, D_delta_z_2_by_b_3_y*t39,
        D_delta_x_3_by_b_3_y*t292 + D_delta_y_3_by_b_3_y*t293 + D_delta_z_3_by_b_3_y*t294,
        D_delta_x_3_by_b_3_y*t39, D_delta_y_3_by_b_3_y*t39, D_delta_z_3_by_b_3_y*t39,
        D_p_x_1_by_b_3_z*t231 + D_p_y_1_by_b_3_z*t233 + D_p_z_1_by_b_3_z*t235,
        D_p_x_1_by_b_3_z*t242 + D_p_x_2_by_b_3_z*t243 + D_p_y_1_by_b_3_z*t245 + D_p_y_2_by_b_3_z*t246
        + D_p_z_1_by_b_3_z*t248 + D_p_z_2_by_b_3_z*t249,
        -D_p_x_1*t353 + D_p_x_1_by_b_3_z*t252 + D_p_x_3_by_b_3_z*t243 - D_p_y_1*t355
        + D_p_y_1_by_b_3_z*t254 + D_p_y_3_by_b_3_z*t246 - D_p_z_1*t357 + D_p_z_1_by_b_3_z*t256
        + D_p_z_3_by_b_3_z*t249,
        D_delta_x_1_by_b_3_z*t243 + D_delta_y_1_by_b_3_z*t246 + D_delta_z_1_by_b_3_z*t249
        + D_p_x_1_by_b_3_z*t274 + D_p_y_1_by_b_3_z*t276 + D_p_z_1_by_b_3_z*t278,
        D_delta_x_2_by_b_3_z*t243 + D_delta_y_2_by_b_3_z*t246 + D_delta_z_2_by_b_3_z*t249
        + D_p_x_1_by_b_3_z*t283 + D_p_y_1_by_b_3_z*t285 + D_p_z_1_by_b_3_z*t287,
        D_delta_x_3_by_b_3_z*t243 + D_delta_y_3_by_b_3_z*t246 + D_delta_z_3_by_b_3_z*t249
        + D_p_x_1_by_b_3_z*t289 + D_p_y_1_by_b_3_z*t290 + D_p_z_1_by_b_3_z*t291,
        D_p_x_1_by_b_3_z*t39, D_p_y_1_by_b_3_z*t39, D_p_z_1_by_b_3_z*t39,
        D_p_x_2_by_b_3_z*t262 + D_p_y_2_by_b_3_z*t263 + D_p_z_2_by_b_3_z*t264,
        -D_p_x_2*t353 + D_p_x_2_by_b_3_z*t252 + D_p_x_3_by_b_3_z*t242 - D_p_y_2*t355
        + D_p_y_2_by_b_3_z*t254 + D_p_y_3_by_b_3_z*t245 - D_p_z_2*t357 + D_p_z_2_by_b_3_z*t256
        + D_p_z_3_by_b_3_z*t248,
        D_delta_x_1_by_b_3_z*t242 + D_delta_y_1_by_b_3_z*t245 + D_delta_z_1_by_b_3_z*t248
        + D_p_x_2_by_b_3_z*t274 + D_p_y_2_by_b_3_z*t276 + D_p_z_2_by_b_3_z*t278,
        D_delta_x_2_by_b_3_z*t242 + D_delta_y_2_by_b_3_z*t245 + D_delta_z_2_by_b_3_z*t248
        + D_p_x_2_by_b_3_z*t283 + D_p_y_2_by_b_3_z*t285 + D_p_z_2_by_b_3_z*t287,
        D_delta_x_3_by_b_3_z*t242 + D_delta_y_3_by_b_3_z*t245 + D_delta_z_3_by_b_3_z*t248
        + D_p_x_2_by_b_3_z*t289 + D_p_y_2_by_b_3_z*t290 + D_p_z_2_by_b_3_z*t291,
        D_p_x_2_by_b_3_z*t39, D_p_y_2_by_b_3_z*t39, D_p_z_2_by_b_3_z*t39,
        D_p_x_3_by_b_3_z*t268 + D_p_y_3_by_b_3_z*t269 + D_p_z_3_by_b_3_z*t270 - t340*t352 - t341*t354
        - t342*t356,
        -D_delta_x_1*t353 + D_delta_x_1_by_b_3_z*t252 - D_delta_y_1*t355 + D_delta_y_1_by_b_3_z*t254
        - D_delta_z_1*t357 + D_delta_z_1_by_b_3_z*t256 + D_p_x_3_by_b_3_z*t274 + D_p_y_3_by_b_3_z*t276
        + D_p_z_3_by_b_3_z*t278,
        -D_delta_x_2*t353 + D_delta_x_2_by_b_3_z*t252 - D_delta_y_2*t355 + D_delta_y_2_by_b_3_z*t254
        - D_delta_z_2*t357 + D_delta_z_2_by_b_3_z*t256 + D_p_x_3_by_b_3_z*t283 + D_p_y_3_by_b_3_z*t285
        + D_p_z_3_by_b_3_z*t287,
        -D_delta_x_3*t353 + D_delta_x_3_by_b_3_z*t252 - D_delta_y_3*t355 + D_delta_y_3_by_b_3_z*t254
        - D_delta_z_3*t357 + D_delta_z_3_by_b_3_z*t256 + D_p_x_3_by_b_3_z*t289 + D_p_y_3_by_b_3_z*t290
        + D_p_z_3_by_b_3_z*t291,
        D_p_x_3_by_b_3_z*t39 - d_3_x*t358, D_p_y_3_by_b_3_z*t39 - d_3_y*t358,
        D_p_z_3_by_b_3_z*t39 - d_3_z*t358,
        D_delta_x_1_by_b_3_z*t275 + D_delta_y_1_by_b_3_z*t277 + D_delta_z_1_by_b_3_z*t279,
        D_delta_x_1_by_b_3_z*t283 + D_delta_x_2_by_b_3_z*t274 + D_delta_y_1_by_b_3_z*t285
        + D_delta_y_2_by_b_3_z*t276 + D_delta_z_1_by_b_3_z*t287 + D_delta_z_2_by_b_3_z*t278,
        D_delta_x_1_by_b_3_z*t289 + D_delta_x_3_by_b_3_z*t274 + D_delta_y_1_by_b_3_z*t290
        + D_delta_y_3_by_b_3_z*t276 + D_delta_z_1_by_b_3_z*t291 + D_delta_z_3_by_b_3_z*t278,
        D_delta_x_1_by_b_3_z*t39, D_delta_y_1_by_b_3_z*t39, D_delta_z_1_by_b_3_z*t39,
        D_delta_x_2_by_b_3_z*t284 + D_delta_y_2_by_b_3_z*t286 + D_delta_z_2_by_b_3_z*t288,
        D_delta_x_2_by_b_3_z*t289 + D_delta_x_3_by_b_3_z*t283 + D_delta_y_2_by_b_3_z*t290
        + D_delta_y_3_by_b_3_z*t285 + D_delta_z_2_by_b_3_z*t291 + D_delta_z_3_by_b_3_z*t287,
        D_delta_x_2_by_b_3_z*t39, D_delta_y_2_by_b_3_z*t39, D_delta_z_2_by_b_3_z*t39,
        D_delta_x_3_by_b_3_z*t292 + D_delta_y_3_by_b_3_z*t293 + D_delta_z_3_by_b_3_z*t294,
        D_delta_x_3_by_b_3_z*t39, D_delta_y_3_by_b_3_z*t39, D_delta_z_3_by_b_3_z*t39,
        D_p_x_1_by_L_a_1*t231 + D_p_y_1_by_L_a_1*t233 + D_p_z_1_by_L_a_1*t235 + (2/3)*L_a_1*m_d_1
        - t222*t359 + t222*t_1_x - t224*t360 + t224*t_1_y - t226*t361 + t226*t_1_z,
        D_p_x_1_by_L_a_1*t242 + D_p_x_2*t362 - D_p_x_2*t365 + D_p_x_2_by_L_a_1*t243
        + D_p_y_1_by_L_a_1*t245 + D_p_y_2*t363 - D_p_y_2*t366 + D_p_y_2_by_L_a_1*t246
        + D_p_z_1_by_L_a_1*t248 + D_p_z_2*t364 - D_p_z_2*t367 + D_p_z_2_by_L_a_1*t249,
        D_p_x_1_by_L_a_1*t252 + D_p_x_3*t362 - D_p_x_3*t365 + D_p_x_3_by_L_a_1*t243
        + D_p_y_1_by_L_a_1*t254 + D_p_y_3*t363 - D_p_y_3*t366 + D_p_y_3_by_L_a_1*t246
        + D_p_z_1_by_L_a_1*t256 + D_p_z_3*t364 - D_p_z_3*t367 + D_p_z_3_by_L_a_1*t249,
        D_delta_x_1*t362 - D_delta_x_1*t365 + D_delta_x_1_by_L_a_1*t243 + D_delta_y_1*t363
        - D_delta_y_1*t366 + D_delta_y_1_by_L_a_1*t246 + D_delta_z_1*t364 - D_delta_z_1*t367
        + D_delta_z_1_by_L_a_1*t249 + D_p_x_1_by_L_a_1*t274 + D_p_y_1_by_L_a_1*t276
        + D_p_z_1_by_L_a_1*t278,
        D_delta_x_2*t362 - D_delta_x_2*t365 + D_delta_x_2_by_L_a_1*t243 + D_delta_y_2*t363
        - D_delta_y_2*t366 + D_delta_y_2_by_L_a_1*t246 + D_delta_z_2*t364 - D_delta_z_2*t367
        + D_delta_z_2_by_L_a_1*t249 + D_p_x_1_by_L_a_1*t283 + D_p_y_1_by_L_a_1*t285
        + D_p_z_1_by_L_a_1*t287,
        D_delta_x_3*t362 - D_delta_x_3*t365 + D_delta_x_3_by_L_a_1*t243 + D_delta_y_3*t363
        - D_delta_y_3*t366 + D_delta_y_3_by_L_a_1*t246 + D_delta_z_3*t364 - D_delta_z_3*t367
        + D_delta_z_3_by_L_a_1*t249 + D_p_x_1_by_L_a_1*t289 + D_p_y_1_by_L_a_1*t290
        + D_p_z_1_by_L_a_1*t291,
        D_p_x_1_by_L_a_1*t39 - d_1_x*t368 + t35*t_1_x, D_p_y_1_by_L_a_1*t39 - d_1_y*t368 + t35*t_1_y,
        D_p_z_1_by_L_a_1*t39 - d_1_z*t368 + t35*t_1_z,
        D_p_x_2_by_L_a_1*t262 + D_p_y_2_by_L_a_1*t263 + D_p_z_2_by_L_a_1*t264,
        D_p_x_2_by_L_a_1*t252 + D_p_x_3_by_L_a_1*t242 + D_p_y_2_by_L_a_1*t254 + D_p_y_3_by_L_a_1*t245
        + D_p_z_2_by_L_a_1*t256 + D_p_z_3_by_L_a_1*t248,
        D_delta_x_1_by_L_a_1*t242 + D_delta_y_1_by_L_a_1*t245 + D_delta_z_1_by_L_a_1*t248
        + D_p_x_2_by_L_a_1*t274 + D_p_y_2_by_L_a_1*t276 + D_p_z_2_by_L_a_1*t278,
        D_delta_x_2_by_L_a_1*t242 + D_delta_y_2_by_L_a_1*t245 + D_delta_z_2_by_L_a_1*t248
        + D_p_x_2_by_L_a_1*t283 + D_p_y_2_by_L_a_1*t285 + D_p_z_2_by_L_a_1*t287,
        D_delta_x_3_by_L_a_1*t242 + D_delta_y_3_by_L_a_1*t245 + D_delta_z_3_by_L_a_1*t248
        + D_p_x_2_by_L_a_1*t289 + D_p_y_2_by_L_a_1*t290 + D_p_z_2_by_L_a_1*t291,
        D_p_x_2_by_L_a_1*t39, D_p_y_2_by_L_a_1*t39, D_p_z_2_by_L_a_1*t39,
        D_p_x_3_by_L_a_1*t268 + D_p_y_3_by_L_a_1*t269 + D_p_z_3_by_L_a_1*t270,
        D_delta_x_1_by_L_a_1*t252 + D_delta_y_1_by_L_a_1*t254 + D_delta_z_1_by_L_a_1*t256
        + D_p_x_3_by_L_a_1*t274 + D_p_y_3_by_L_a_1*t276 + D_p_z_3_by_L_a_1*t278,
        D_delta_x_2_by_L_a_1*t252 + D_delta_y_2_by_L_a_1*t254 + D_delta_z_2_by_L_a_1*t256
        + D_p_x_3_by_L_a_1*t283 + D_p_y_3_by_L_a_1*t285 + D_p_z_3_by_L_a_1*t287,
        D_delta_x_3_by_L_a_1*t252 + D_delta_y_3_by_L_a_1*t254 + D_delta_z_3_by_L_a_1*t256
        + D_p_x_3_by_L_a_1*t289 + D_p_y_3_by_L_a_1*t290 + D_p_z_3_by_L_a_1*t291,
        D_p_x_3_by_L_a_1*t39, D_p_y_3_by_L_a_1*t39, D_p_z_3_by_L_a_1*t39,
        D_delta_x_1_by_L_a_1*t275 + D_delta_y_1_by_L_a_1*t277 + D_delta_z_1_by_L_a_1*t279,
        D_delta_x_1_by_L_a_1*t283 + D_delta_x_2_by_L_a_1*t274 + D_delta_y_1_by_L_a_1*t285
        + D_delta_y_2_by_L_a_1*t276 + D_delta_z_1_by_L_a_1*t287 + D_delta_z_2_by_L_a_1*t278,
        D_delta_x_1_by_L_a_1*t289 + D_delta_x_3_by_L_a_1*t274 + D_delta_y_1_by_L_a_1*t290
        + D_delta_y_3_by_L_a_1*t276 + D_delta_z_1_by_L_a_1*t291 + D_delta_z_3_by_L_a_1*t278,
        D_delta_x_1_by_L_a_1*t39, D_delta_y_1_by_L_a_1*t39, D_delta_z_1_by_L_a_1*t39,
        D_delta_x_2_by_L_a_1*t284 + D_delta_y_2_by_L_a_1*t286 + D_delta_z_2_by_L_a_1*t288,
        D_delta_x_2_by_L_a_1*t289 + D_delta_x_3_by_L_a_1*t283 + D_delta_y_2_by_L_a_1*t290
        + D_delta_y_3_by_L_a_1*t285 + D_delta_z_2_by_L_a_1*t291 + D_delta_z_3_by_L_a_1*t287,
        D_delta_x_2_by_L_a_1*t39, D_delta_y_2_by_L_a_1*t39, D_delta_z_2_by_L_a_1*t39,
        D_delta_x_3_by_L_a_1*t292 + D_delta_y_3_by_L_a_1*t293 + D_delta_z_3_by_L_a_1*t294,
        D_delta_x_3_by_L_a_1*t39, D_delta_y_3_by_L_a_1*t39, D_delta_z_3_by_L_a_1*t39,
        D_p_x_1_by_L_a_2*t231 + D_p_y_1_by_L_a_2*t233 + D_p_z_1_by_L_a_2*t235,
        D_p_x_1*t369 - D_p_x_1*t373 + D_p_x_1_by_L_a_2*t242 + D_p_x_2_by_L_a_2*t243 + D_p_y_1*t370
        - D_p_y_1*t375 + D_p_y_1_by_L_a_2*t245 + D_p_y_2_by_L_a_2*t246 + D_p_z_1*t371 - D_p_z_1*t377
        + D_p_z_1_by_L_a_2*t248 + D_p_z_2_by_L_a_2*t249,
        D_p_x_1_by_L_a_2*t252 + D_p_x_3_by_L_a_2*t243 + D_p_y_1_by_L_a_2*t254 + D_p_y_3_by_L_a_2*t246
        + D_p_z_1_by_L_a_2*t256 + D_p_z_3_by_L_a_2*t249,
        D_delta_x_1_by_L_a_2*t243 + D_delta_y_1_by_L_a_2*t246 + D_delta_z_1_by_L_a_2*t249
        + D_p_x_1_by_L_a_2*t274 + D_p_y_1_by_L_a_2*t276 + D_p_z_1_by_L_a_2*t278,
        D_delta_x_2_by_L_a_2*t243 + D_delta_y_2_by_L_a_2*t246 + D_delta_z_2_by_L_a_2*t249
        + D_p_x_1_by_L_a_2*t283 + D_p_y_1_by_L_a_2*t285 + D_p_z_1_by_L_a_2*t287,
        D_delta_x_3_by_L_a_2*t243 + D_delta_y_3_by_L_a_2*t246 + D_delta_z_3_by_L_a_2*t249
        + D_p_x_1_by_L_a_2*t289 + D_p_y_1_by_L_a_2*t290 + D_p_z_1_by_L_a_2*t291,
        D_p_x_1_by_L_a_2*t39, D_p_y_1_by_L_a_2*t39, D_p_z_1_by_L_a_2*t39,
        D_p_x_2_by_L_a_2*t262 + D_p_y_2_by_L_a_2*t263 + D_p_z_2_by_L_a_2*t264 + (2/3)*L_a_2*m_d_2
        - t315*t372 + t315*t_2_x - t316*t374 + t316*t_2_y - t317*t376 + t317*t_2_z,
        D_p_x_2_by_L_a_2*t252 + D_p_x_3*t369 - D_p_x_3*t373 + D_p_x_3_by_L_a_2*t242
        + D_p_y_2_by_L_a_2*t254 + D_p_y_3*t370 - D_p_y_3*t375 + D_p_y_3_by_L_a_2*t245
        + D_p_z_2_by_L_a_2*t256 + D_p_z_3*t371 - D_p_z_3*t377 + D_p_z_3_by_L_a_2*t248,
        D_delta_x_1*t369 - D_delta_x_1*t373 + D_delta_x_1_by_L_a_2*t242 + D_delta_y_1*t370
        - D_delta_y_1*t375 + D_delta_y_1_by_L_a_2*t245 + D_delta_z_1*t371 - D_delta_z_1*t377
        + D_delta_z_1_by_L_a_2*t248 + D_p_x_2_by_L_a_2*t274 + D_p_y_2_by_L_a_2*t276
        + D_p_z_2_by_L_a_2*t278,
        D_delta_x_2*t369 - D_delta_x_2*t373 + D_delta_x_2_by_L_a_2*t242 + D_delta_y_2*t370
        - D_delta_y_2*t375 + D_delta_y_2_by_L_a_2*t245 + D_delta_z_2*t371 - D_delta_z_2*t377
        + D_delta_z_2_by_L_a_2*t248 + D_p_x_2_by_L_a_2*t283 + D_p_y_2_by_L_a_2*t285
        + D_p_z_2_by_L_a_2*t287,
        D_delta_x_3*t369 - D_delta_x_3*t373 + D_delta_x_3_by_L_a_2*t242 + D_delta_y_3*t370
        - D_delta_y_3*t375 + D_delta_y_3_by_L_a_2*t245 + D_delta_z_3*t371 - D_delta_z_3*t377
        + D_delta_z_3_by_L_a_2*t248 + D_p_x_2_by_L_a_2*t289 + D_p_y_2_by_L_a_2*t290
        + D_p_z_2_by_L_a_2*t291,
        D_p_x_2_by_L_a_2*t39 - d_2_x*t378 + t36*t_2_x, D_p_y_2_by_L_a_2*t39 - d_2_y*t378 + t36*t_2_y,
        D_p_z_2_by_L_a_2*t39 - d_2_z*t378 + t36*t_2_z,
        D_p_x_3_by_L_a_2*t268 + D_p_y_3_by_L_a_2*t269 + D_p_z_3_by_L_a_2*t270,
        D_delta_x_1_by_L_a_2*t252 + D_delta_y_1_by_L_a_2*t254 + D_delta_z_1_by_L_a_2*t256
        + D_p_x_3_by_L_a_2*t274 + D_p_y_3_by_L_a_2*t276 + D_p_z_3_by_L_a_2*t278,
        D_delta_x_2_by_L_a_2*t252 + D_delta_y_2_by_L_a_2*t254 + D_delta_z_2_by_L_a_2*t256
        + D_p_x_3_by_L_a_2*t283 + D_p_y_3_by_L_a_2*t285 + D_p_z_3_by_L_a_2*t287,
        D_delta_x_3_by_L_a_2*t252 + D_delta_y_3_by_L_a_2*t254 + D_delta_z_3_by_L_a_2*t256
        + D_p_x_3_by_L_a_2*t289 + D_p_y_3_by_L_a_2*t290 + D_p_z_3_by_L_a_2*t291,
        D_p_x_3_by_L_a_2*t39, D_p_y_3_by_L_a_2*t39, D_p_z_3_by_L_a_2*t39,
        D_delta_x_1_by_L_a_2*t275 + D_delta_y_1_by_L_a_2*t277 + D_delta_z_1_by_L_a_2*t279,
        D_delta_x_1_by_L_a_2*t283 + D_delta_x_2_by_L_a_2*t274 + D_delta_y_1_by_L_a_2*t285
        + D_delta_y_2_by_L_a_2*t276 + D_delta_z_1_by_L_a_2*t287 + D_delta_z_2_by_L_a_2*t278,
        D_delta_x_1_by_L_a_2*t289 + D_delta_x_3_by_L_a_2*t274 + D_delta_y_1_by_L_a_2*t290
        + D_delta_y_3_by_L_a_2*t276 + D_delta_z_1_by_L_a_2*t291 + D_delta_z_3_by_L_a_2*t278,
        D_delta_x_1_by_L_a_2*t39, D_delta_y_1_by_L_a_2*t39, D_delta_z_1_by_L_a_2*t39,
        D_delta_x_2_by_L_a_2*t284 + D_delta_y_2_by_L_a_2*t286 + D_delta_z_2_by_L_a_2*t288,
        D_delta_x_2_by_L_a_2*t289 + D_delta_x_3_by_L_a_2*t283 + D_delta_y_2_by_L_a_2*t290
        + D_delta_y_3_by_L_a_2*t285 + D_delta_z_2_by_L_a_2*t291 + D_delta_z_3_by_L_a_2*t287,
        D_delta_x_2_by_L_a_2*t39, D_delta_y_2_by_L_a_2*t39, D_delta_z_2_by_L_a_2*t39,
        D_delta_x_3_by_L_a_2*t292 + D_delta_y_3_by_L_a_2*t293 + D_delta_z_3_by_L_a_2*t294,
        D_delta_x_3_by_L_a_2*t39, D_delta_y_3_by_L_a_2*t39, D_delta_z_3_by_L_a_2*t39,
        D_p_x_1_by_L_a_3*t231 + D_p_y_1_by_L_a_3*t233 + D_p_z_1_by_L_a_3*t235,
        D_p_x_1_by_L_a_3*t242 + D_p_x_2_by_L_a_3*t243 + D_p_y_1_by_L_a_3*t245 + D_p_y_2_by_L_a_3*t246
        + D_p_z_1_by_L_a_3*t248 + D_p_z_2_by_L_a_3*t249,
        D_p_x_1*t379 - D_p_x_1*t383 + D_p_x_1_by_L_a_3*t252 + D_p_x_3_by_L_a_3*t243 + D_p_y_1*t380
        - D_p_y_1*t385 + D_p_y_1_by_L_a_3*t254 + D_p_y_3_by_L_a_3*t246 + D_p_z_1*t381 - D_p_z_1*t387
        + D_p_z_1_by_L_a_3*t256 + D_p_z_3_by_L_a_3*t249,
        D_delta_x_1_by_L_a_3*t243 + D_delta_y_1_by_L_a_3*t246 + D_delta_z_1_by_L_a_3*t249
        + D_p_x_1_by_L_a_3*t274 + D_p_y_1_by_L_a_3*t276 + D_p_z_1_by_L_a_3*t278,
        D_delta_x_2_by_L_a_3*t243 + D_delta_y_2_by_L_a_3*t246 + D_delta_z_2_by_L_a_3*t249
        + D_p_x_1_by_L_a_3*t283 + D_p_y_1_by_L_a_3*t285 + D_p_z_1_by_L_a_3*t287,
        D_delta_x_3_by_L_a_3*t243 + D_delta_y_3_by_L_a_3*t246 + D_delta_z_3_by_L_a_3*t249
        + D_p_x_1_by_L_a_3*t289 + D_p_y_1_by_L_a_3*t290 + D_p_z_1_by_L_a_3*t291,
        D_p_x_1_by_L_a_3*t39, D_p_y_1_by_L_a_3*t39, D_p_z_1_by_L_a_3*t39,
        D_p_x_2_by_L_a_3*t262 + D_p_y_2_by_L_a_3*t263 + D_p_z_2_by_L_a_3*t264,
        D_p_x_2*t379 - D_p_x_2*t383 + D_p_x_2_by_L_a_3*t252 + D_p_x_3_by_L_a_3*t242 + D_p_y_2*t380
        - D_p_y_2*t385 + D_p_y_2_by_L_a_3*t254 + D_p_y_3_by_L_a_3*t245 + D_p_z_2*t381 - D_p_z_2*t387
        + D_p_z_2_by_L_a_3*t256 + D_p_z_3_by_L_a_3*t248,
        D_delta_x_1_by_L_a_3*t242 + D_delta_y_1_by_L_a_3*t245 + D_delta_z_1_by_L_a_3*t248
        + D_p_x_2_by_L_a_3*t274 + D_p_y_2_by_L_a_3*t276 + D_p_z_2_by_L_a_3*t278,
        D_delta_x_2_by_L_a_3*t242 + D_delta_y_2_by_L_a_3*t245 + D_delta_z_2_by_L_a_3*t248
        + D_p_x_2_by_L_a_3*t283 + D_p_y_2_by_L_a_3*t285 + D_p_z_2_by_L_a_3*t287,
        D_delta_x_3_by_L_a_3*t242 + D_delta_y_3_by_L_a_3*t245 + D_delta_z_3_by_L_a_3*t248
        + D_p_x_2_by_L_a_3*t289 + D_p_y_2_by_L_a_3*t290 + D_p_z_2_by_L_a_3*t291,
        D_p_x_2_by_L_a_3*t39, D_p_y_2_by_L_a_3*t39, D_p_z_2_by_L_a_3*t39,
        D_p_x_3_by_L_a_3*t268 + D_p_y_3_by_L_a_3*t269 + D_p_z_3_by_L_a_3*t270 + (2/3)*L_a_3*m_d_3
        - t340*t382 + t340*t_3_x - t341*t384 + t341*t_3_y - t342*t386 + t342*t_3_z,
        D_delta_x_1*t379 - D_delta_x_1*t383 + D_delta_x_1_by_L_a_3*t252 + D_delta_y_1*t380
        - D_delta_y_1*t385 + D_delta_y_1_by_L_a_3*t254 + D_delta_z_1*t381 - D_delta_z_1*t387
        + D_delta_z_1_by_L_a_3*t256 + D_p_x_3_by_L_a_3*t274 + D_p_y_3_by_L_a_3*t276
        + D_p_z_3_by_L_a_3*t278,
        D_delta_x_2*t379 - D_delta_x_2*t383 + D_delta_x_2_by_L_a_3*t252 + D_delta_y_2*t380
        - D_delta_y_2*t385 + D_delta_y_2_by_L_a_3*t254 + D_delta_z_2*t381 - D_delta_z_2*t387
        + D_delta_z_2_by_L_a_3*t256 + D_p_x_3_by_L_a_3*t283 + D_p_y_3_by_L_a_3*t285
        + D_p_z_3_by_L_a_3*t287,
        D_delta_x_3*t379 - D_delta_x_3*t383 + D_delta_x_3_by_L_a_3*t252 + D_delta_y_3*t380
        - D_delta_y_3*t385 + D_delta_y_3_by_L_a_3*t254 + D_delta_z_3*t381 - D_delta_z_3*t387
        + D_delta_z_3_by_L_a_3*t256 + D_p_x_3_by_L_a_3*t289 + D_p_y_3_by_L_a_3*t290
        + D_p_z_3_by_L_a_3*t291,
        D_p_x_3_by_L_a_3*t39 - d_3_x*t388 + t37*t_3_x, D_p_y_3_by_L_a_3*t39 - d_3_y*t388 + t37*t_3_y,
        D_p_z_3_by_L_a_3*t39 - d_3_z*t388 + t37*t_3_z,
        D_delta_x_1_by_L_a_3*t275 + D_delta_y_1_by_L_a_3*t277 + D_delta_z_1_by_L_a_3*t279,
        D_delta_x_1_by_L_a_3*t283 + D_delta_x_2_by_L_a_3*t274 + D_delta_y_1_by_L_a_3*t285
        + D_delta_y_2_by_L_a_3*t276 + D_delta_z_1_by_L_a_3*t287 + D_delta_z_2_by_L_a_3*t278,
        D_delta_x_1_by_L_a_3*t289 + D_delta_x_3_by_L_a_3*t274 + D_delta_y_1_by_L_a_3*t290
        + D_delta_y_3_by_L_a_3*t276 + D_delta_z_1_by_L_a_3*t291 + D_delta_z_3_by_L_a_3*t278,
        D_delta_x_1_by_L_a_3*t39, D_delta_y_1_by_L_a_3*t39, D_delta_z_1_by_L_a_3*t39,
        D_delta_x_2_by_L_a_3*t284 + D_delta_y_2_by_L_a_3*t286 + D_delta_z_2_by_L_a_3*t288,
        D_delta_x_2_by_L_a_3*t289 + D_delta_x_3_by_L_a_3*t283 + D_delta_y_2_by_L_a_3*t290
        + D_delta_y_3_by_L_a_3*t285 + D_delta_z_2_by_L_a_3*t291 + D_delta_z_3_by_L_a_3*t287,
        D_delta_x_2_by_L_a_3*t39, D_delta_y_2_by_L_a_3*t39, D_delta_z_2_by_L_a_3*t39,
        D_delta_x_3_by_L_a_3*t292 + D_delta_y_3_by_L_a_3*t293 + D_delta_z_3_by_L_a_3*t294,
        D_delta_x_3_by_L_a_3*t39, D_delta_y_3_by_L_a_3*t39, D_delta_z_3_by_L_a_3*t39,
        D_p_x_1_by_l_d_1*t231 + D_p_y_1_by_l_d_1*t233 + D_p_z_1_by_l_d_1*t235 - t222*t389 - t224*t390
        - t226*t391,
        D_p_x_1_by_l_d_1*t242 - D_p_x_2*t392 + D_p_x_2_by_l_d_1*t243 + D_p_y_1_by_l_d_1*t245
        - D_p_y_2*t393 + D_p_y_2_by_l_d_1*t246 + D_p_z_1_by_l_d_1*t248 - D_p_z_2*t394
        + D_p_z_2_by_l_d_1*t249,
        D_p_x_1_by_l_d_1*t252 - D_p_x_3*t392 + D_p_x_3_by_l_d_1*t243 + D_p_y_1_by_l_d_1*t254
        - D_p_y_3*t393 + D_p_y_3_by_l_d_1*t246 + D_p_z_1_by_l_d_1*t256 - D_p_z_3*t394
        + D_p_z_3_by_l_d_1*t249,
        -D_delta_x_1*t392 + D_delta_x_1_by_l_d_1*t243 - D_delta_y_1*t393 + D_delta_y_1_by_l_d_1*t246
        - D_delta_z_1*t394 + D_delta_z_1_by_l_d_1*t249 + D_p_x_1_by_l_d_1*t274 + D_p_y_1_by_l_d_1*t276
        + D_p_z_1_by_l_d_1*t278,
        -D_delta_x_2*t392 + D_delta_x_2_by_l_d_1*t243 - D_delta_y_2*t393 + D_delta_y_2_by_l_d_1*t246
        - D_delta_z_2*t394 + D_delta_z_2_by_l_d_1*t249 + D_p_x_1_by_l_d_1*t283 + D_p_y_1_by_l_d_1*t285
        + D_p_z_1_by_l_d_1*t287,
        -D_delta_x_3*t392 + D_delta_x_3_by_l_d_1*t243 - D_delta_y_3*t393 + D_delta_y_3_by_l_d_1*t246
        - D_delta_z_3*t394 + D_delta_z_3_by_l_d_1*t249 + D_p_x_1_by_l_d_1*t289 + D_p_y_1_by_l_d_1*t290
        + D_p_z_1_by_l_d_1*t291,
        D_p_x_1_by_l_d_1*t39 - d_1_x*t395, D_p_y_1_by_l_d_1*t39 - d_1_y*t395,
        D_p_z_1_by_l_d_1*t39 - d_1_z*t395,
        D_p_x_2_by_l_d_1*t262 + D_p_y_2_by_l_d_1*t263 + D_p_z_2_by_l_d_1*t264,
        D_p_x_2_by_l_d_1*t252 + D_p_x_3_by_l_d_1*t242 + D_p_y_2_by_l_d_1*t254 + D_p_y_3_by_l_d_1*t245
        + D_p_z_2_by_l_d_1*t256 + D_p_z_3_by_l_d_1*t248,
        D_delta_x_1_by_l_d_1*t242 + D_delta_y_1_by_l_d_1*t245 + D_delta_z_1_by_l_d_1*t248
        + D_p_x_2_by_l_d_1*t274 + D_p_y_2_by_l_d_1*t276 + D_p_z_2_by_l_d_1*t278,
        D_delta_x_2_by_l_d_1*t242 + D_delta_y_2_by_l_d_1*t245 + D_delta_z_2_by_l_d_1*t248
        + D_p_x_2_by_l_d_1*t283 + D_p_y_2_by_l_d_1*t285 + D_p_z_2_by_l_d_1*t287,
        D_delta_x_3_by_l_d_1*t242 + D_delta_y_3_by_l_d_1*t245 + D_delta_z_3_by_l_d_1*t248
        + D_p_x_2_by_l_d_1*t289 + D_p_y_2_by_l_d_1*t290 + D_p_z_2_by_l_d_1*t291,
        D_p_x_2_by_l_d_1*t39, D_p_y_2_by_l_d_1*t39, D_p_z_2_by_l_d_1*t39,
        D_p_x_3_by_l_d_1*t268 + D_p_y_3_by_l_d_1*t269 + D_p_z_3_by_l_d_1*t270,
        D_delta_x_1_by_l_d_1*t252 + D_delta_y_1_by_l_d_1*t254 + D_delta_z_1_by_l_d_1*t256
        + D_p_x_3_by_l_d_1*t274 + D_p_y_3_by_l_d_1*t276 + D_p_z_3_by_l_d_1*t278,
        D_delta_x_2_by_l_d_1*t252 + D_delta_y_2_by_l_d_1*t254 + D_delta_z_2_by_l_d_1*t256
        + D_p_x_3_by_l_d_1*t283 + D_p_y_3_by_l_d_1*t285 + D_p_z_3_by_l_d_1*t287,
        D_delta_x_3_by_l_d_1*t252 + D_delta_y_3_by_l_d_1*t254 + D_delta_z_3_by_l_d_1*t256
        + D_p_x_3_by_l_d_1*t289 + D_p_y_3_by_l_d_1*t290 + D_p_z_3_by_l_d_1*t291,
        D_p_x_3_by_l_d_1*t39, D_p_y_3_by_l_d_1*t39, D_p_z_3_by_l_d_1*t39,
        D_delta_x_1_by_l_d_1*t275 + D_delta_y_1_by_l_d_1*t277 + D_delta_z_1_by_l_d_1*t279,
        D_delta_x_1_by_l_d_1*t283 + D_delta_x_2_by_l_d_1*t274 + D_delta_y_1_by_l_d_1*t285
        + D_delta_y_2_by_l_d_1*t276 + D_delta_z_1_by_l_d_1*t287 + D_delta_z_2_by_l_d_1*t278,
        D_delta_x_1_by_l_d_1*t289 + D_delta_x_3_by_l_d_1*t274 + D_delta_y_1_by_l_d_1*t290
        + D_delta_y_3_by_l_d_1*t276 + D_delta_z_1_by_l_d_1*t291 + D_delta_z_3_by_l_d_1*t278,
        D_delta_x_1_by_l_d_1*t39, D_delta_y_1_by_l_d_1*t39, D_delta_z_1_by_l_d_1*t39,
        D_delta_x_2_by_l_d_1*t284 + D_delta_y_2_by_l_d_1*t286 + D_delta_z_2_by_l_d_1*t288,
        D_delta_x_2_by_l_d_1*t289 + D_delta_x_3_by_l_d_1*t283 + D_delta_y_2_by_l_d_1*t290
        + D_delta_y_3_by_l_d_1*t285 + D_delta_z_2_by_l_d_1*t291 + D_delta_z_3_by_l_d_1*t287,
        D_delta_x_2_by_l_d_1*t39, D_delta_y_2_by_l_d_1*t39, D_delta_z_2_by_l_d_1*t39,
        D_delta_x_3_by_l_d_1*t292 + D_delta_y_3_by_l_d_1*t293 + D_delta_z_3_by_l_d_1*t294,
        D_delta_x_3_by_l_d_1*t39, D_delta_y_3_by_l_d_1*t39, D_delta_z_3_by_l_d_1*t39,
        D_p_x_1_by_l_d_2*t231 + D_p_y_1_by_l_d_2*t233 + D_p_z_1_by_l_d_2*t235,
        -D_p_x_1*t397 + D_p_x_1_by_l_d_2*t242 + D_p_x_2_by_l_d_2*t243 - D_p_y_1*t399
        + D_p_y_1_by_l_d_2*t245 + D_p_y_2_by_l_d_2*t246 - D_p_z_1*t401 + D_p_z_1_by_l_d_2*t248
        + D_p_z_2_by_l_d_2*t249,
        D_p_x_1_by_l_d_2*t252 + D_p_x_3_by_l_d_2*t243 + D_p_y_1_by_l_d_2*t254 + D_p_y_3_by_l_d_2*t246
        + D_p_z_1_by_l_d_2*t256 + D_p_z_3_by_l_d_2*t249,
        D_delta_x_1_by_l_d_2*t243 + D_delta_y_1_by_l_d_2*t246 + D_delta_z_1_by_l_d_2*t249
        + D_p_x_1_by_l_d_2*t274 + D_p_y_1_by_l_d_2*t276 + D_p_z_1_by_l_d_2*t278,
        D_delta_x_2_by_l_d_2*t243 + D_delta_y_2_by_l_d_2*t246 + D_delta_z_2_by_l_d_2*t249
        + D_p_x_1_by_l_d_2*t283 + D_p_y_1_by_l_d_2*t285 + D_p_z_1_by_l_d_2*t287,
        D_delta_x_3_by_l_d_2*t243 + D_delta_y_3_by_l_d_2*t246 + D_delta_z_3_by_l_d_2*t249
        + D_p_x_1_by_l_d_2*t289 + D_p_y_1_by_l_d_2*t290 + D_p_z_1_by_l_d_2*t291,
        D_p_x_1_by_l_d_2*t39, D_p_y_1_by_l_d_2*t39, D_p_z_1_by_l_d_2*t39,
        D_p_x_2_by_l_d_2*t262 + D_p_y_2_by_l_d_2*t263 + D_p_z_2_by_l_d_2*t264 - t315*t396 - t316*t398
        - t317*t400,
        D_p_x_2_by_l_d_2*t252 - D_p_x_3*t397 + D_p_x_3_by_l_d_2*t242 + D_p_y_2_by_l_d_2*t254
        - D_p_y_3*t399 + D_p_y_3_by_l_d_2*t245 + D_p_z_2_by_l_d_2*t256 - D_p_z_3*t401
        + D_p_z_3_by_l_d_2*t248,
        -D_delta_x_1*t397 + D_delta_x_1_by_l_d_2*t242 - D_delta_y_1*t399 + D_delta_y_1_by_l_d_2*t245
        - D_delta_z_1*t401 + D_delta_z_1_by_l_d_2*t248 + D_p_x_2_by_l_d_2*t274 + D_p_y_2_by_l_d_2*t276
        + D_p_z_2_by_l_d_2*t278,
        -D_delta_x_2*t397 + D_delta_x_2_by_l_d_2*t242 - D_delta_y_2*t399 + D_delta_y_2_by_l_d_2*t245
        - D_delta_z_2*t401 + D_delta_z_2_by_l_d_2*t248 + D_p_x_2_by_l_d_2*t283 + D_p_y_2_by_l_d_2*t285
        + D_p_z_2_by_l_d_2*t287,
        -D_delta_x_3*t397 + D_delta_x_3_by_l_d_2*t242 - D_delta_y_3*t399 + D_delta_y_3_by_l_d_2*t245
        - D_delta_z_3*t401 + D_delta_z_3_by_l_d_2*t248 + D_p_x_2_by_l_d_2*t289 + D_p_y_2_by_l_d_2*t290
        + D_p_z_2_by_l_d_2*t291,
        D_p_x_2_by_l_d_2*t39 - d_2_x*t402, D_p_y_2_by_l_d_2*t39 - d_2_y*t402,
        D_p_z_2_by_l_d_2*t39 - d_2_z*t402,
        D_p_x_3_by_l_d_2*t268 + D_p_y_3_by_l_d_2*t269 + D_p_z_3_by_l_d_2*t270,
        D_delta_x_1_by_l_d_2*t252 + D_delta_y_1_by_l_d_2*t254 + D_delta_z_1_by_l_d_2*t256
        + D_p_x_3_by_l_d_2*t274 + D_p_y_3_by_l_d_2*t276 + D_p_z_3_by_l_d_2*t278,
        D_delta_x_2_by_l_d_2*t252 + D_delta_y_2_by_l_d_2*t254 + D_delta_z_2_by_l_d_2*t256
        + D_p_x_3_by_l_d_2*t283 + D_p_y_3_by_l_d_2*t285 + D_p_z_3_by_l_d_2*t287,
        D_delta_x_3_by_l_d_2*t252 + D_delta_y_3_by_l_d_2*t254 + D_delta_z_3_by_l_d_2*t256
        + D_p_x_3_by_l_d_2*t289 + D_p_y_3_by_l_d_2*t290 + D_p_z_3_by_l_d_2*t291,
        D_p_x_3_by_l_d_2*t39, D_p_y_3_by_l_d_2*t39, D_p_z_3_by_l_d_2*t39,
        D_delta_x_1_by_l_d_2*t275 + D_delta_y_1_by_l_d_2*t277 + D_delta_z_1_by_l_d_2*t279,
        D_delta_x_1_by_l_d_2*t283 + D_delta_x_2_by_l_d_2*t274 + D_delta_y_1_by_l_d_2*t285
        + D_delta_y_2_by_l_d_2*t276 + D_delta_z_1_by_l_d_2*t287 + D_delta_z_2_by_l_d_2*t278,
        D_delta_x_1_by_l_d_2*t289 + D_delta_x_3_by_l_d_2*t274 + D_delta_y_1_by_l_d_2*t290
        + D_delta_y_3_by_l_d_2*t276 + D_delta_z_1_by_l_d_2*t291 + D_delta_z_3_by_l_d_2*t278,
        D_delta_x_1_by_l_d_2*t39, D_delta_y_1_by_l_d_2*t39, D_delta_z_1_by_l_d_2*t39,
        D_delta_x_2_by_l_d_2*t284 + D_delta_y_2_by_l_d_2*t286 + D_delta_z_2_by_l_d_2*t288,
        D_delta_x_2_by_l_d_2*t289 + D_delta_x_3_by_l_d_2*t283 + D_delta_y_2_by_l_d_2*t290
        + D_delta_y_3_by_l_d_2*t285 + D_delta_z_2_by_l_d_2*t291 + D_delta_z_3_by_l_d_2*t287,
        D_delta_x_2_by_l_d_2*t39, D_delta_y_2_by_l_d_2*t39, D_delta_z_2_by_l_d_2*t39,
        D_delta_x_3_by_l_d_2*t292 + D_delta_y_3_by_l_d_2*t293 + D_delta_z_3_by_l_d_2*t294,
        D_delta_x_3_by_l_d_2*t39, D_delta_y_3_by_l_d_2*t39, D_delta_z_3_by_l_d_2*t39,
        D_p_x_1_by_l_d_3*t231 + D_p_y_1_by_l_d_3*t233 + D_p_z_1_by_l_d_3*t235,
        D_p_x_1_by_l_d_3*t242 + D_p_x_2_by_l_d_3*t243 + D_p_y_1_by_l_d_3*t245 + D_p_y_2_by_l_d_3*t246
        + D_p_z_1_by_l_d_3*t248 + D_p_z_2_by_l_d_3*t249,
        -D_p_x_1*t404 + D_p_x_1_by_l_d_3*t252 + D_p_x_3_by_l_d_3*t243 - D_p_y_1*t406
        + D_p_y_1_by_l_d_3*t254 + D_p_y_3_by_l_d_3*t246 - D_p_z_1*t408 + D_p_z_1_by_l_d_3*t256
        + D_p_z_3_by_l_d_3*t249,
        D_delta_x_1_by_l_d_3*t243 + D_delta_y_1_by_l_d_3*t246 + D_delta_z_1_by_l_d_3*t249
        + D_p_x_1_by_l_d_3*t274 + D_p_y_1_by_l_d_3*t276 + D_p_z_1_by_l_d_3*t278,
        D_delta_x_2_by_l_d_3*t243 + D_delta_y_2_by_l_d_3*t246 + D_delta_z_2_by_l_d_3*t249
        + D_p_x_1_by_l_d_3*t283 + D_p_y_1_by_l_d_3*t285 + D_p_z_1_by_l_d_3*t287,
        D_delta_x_3_by_l_d_3*t243 + D_delta_y_3_by_l_d_3*t246 + D_delta_z_3_by_l_d_3*t249
        + D_p_x_1_by_l_d_3*t289 + D_p_y_1_by_l_d_3*t290 + D_p_z_1_by_l_d_3*t291,
        D_p_x_1_by_l_d_3*t39, D_p_y_1_by_l_d_3*t39, D_p_z_1_by_l_d_3*t39,
        D_p_x_2_by_l_d_3*t262 + D_p_y_2_by_l_d_3*t263 + D_p_z_2_by_l_d_3*t264,
        -D_p_x_2*t404 + D_p_x_2_by_l_d_3*t252 + D_p_x_3_by_l_d_3*t242 - D_p_y_2*t406
        + D_p_y_2_by_l_d_3*t254 + D_p_y_3_by_l_d_3*t245 - D_p_z_2*t408 + D_p_z_2_by_l_d_3*t256
        + D_p_z_3_by_l_d_3*t248,
        D_delta_x_1_by_l_d_3*t242 + D_delta_y_1_by_l_d_3*t245 + D_delta_z_1_by_l_d_3*t248
        + D_p_x_2_by_l_d_3*t274 + D_p_y_2_by_l_d_3*t276 + D_p_z_2_by_l_d_3*t278,
        D_delta_x_2_by_l_d_3*t242 + D_delta_y_2_by_l_d_3*t245 + D_delta_z_2_by_l_d_3*t248
        + D_p_x_2_by_l_d_3*t283 + D_p_y_2_by_l_d_3*t285 + D_p_z_2_by_l_d_3*t287,
        D_delta_x_3_by_l_d_3*t242 + D_delta_y_3_by_l_d_3*t245 + D_delta_z_3_by_l_d_3*t248
        + D_p_x_2_by_l_d_3*t289 + D_p_y_2_by_l_d_3*t290 + D_p_z_2_by_l_d_3*t291,
        D_p_x_2_by_l_d_3*t39, D_p_y_2_by_l_d_3*t39, D_p_z_2_by_l_d_3*t39,
        D_p_x_3_by_l_d_3*t268 + D_p_y_3_by_l_d_3*t269 + D_p_z_3_by_l_d_3*t270 - t340*t403 - t341*t405
        - t342*t407,
        -D_delta_x_1*t404 + D_delta_x_1_by_l_d_3*t252 - D_delta_y_1*t406 + D_delta_y_1_by_l_d_3*t254
        - D_delta_z_1*t408 + D_delta_z_1_by_l_d_3*t256 + D_p_x_3_by_l_d_3*t274 + D_p_y_3_by_l_d_3*t276
        + D_p_z_3_by_l_d_3*t278,
        -D_delta_x_2*t404 + D_delta_x_2_by_l_d_3*t252 - D_delta_y_2*t406 + D_delta_y_2_by_l_d_3*t254
        - D_delta_z_2*t408 + D_delta_z_2_by_l_d_3*t256 + D_p_x_3_by_l_d_3*t283 + D_p_y_3_by_l_d_3*t285
        + D_p_z_3_by_l_d_3*t287,
        -D_delta_x_3*t404 + D_delta_x_3_by_l_d_3*t252 - D_delta_y_3*t406 + D_delta_y_3_by_l_d_3*t254
        - D_delta_z_3*t408 + D_delta_z_3_by_l_d_3*t256 + D_p_x_3_by_l_d_3*t289 + D_p_y_3_by_l_d_3*t290
        + D_p_z_3_by_l_d_3*t291,
        D_p_x_3_by_l_d_3*t39 - d_3_x*t409, D_p_y_3_by_l_d_3*t39 - d_3_y*t409,
        D_p_z_3_by_l_d_3*t39 - d_3_z*t409,
        D_delta_x_1_by_l_d_3*t275 + D_delta_y_1_by_l_d_3*t277 + D_delta_z_1_by_l_d_3*t279,
        D_delta_x_1_by_l_d_3*t283 + D_delta_x_2_by_l_d_3*t274 + D_delta_y_1_by_l_d_3*t285
        + D_delta_y_2_by_l_d_3*t276 + D_delta_z_1_by_l_d_3*t287 + D_delta_z_2_by_l_d_3*t278,
        D_delta_x_1_by_l_d_3*t289 + D_delta_x_3_by_l_d_3*t274 + D_delta_y_1_by_l_d_3*t290
        + D_delta_y_3_by_l_d_3*t276 + D_delta_z_1_by_l_d_3*t291 + D_delta_z_3_by_l_d_3*t278,
        D_delta_x_1_by_l_d_3*t39, D_delta_y_1_by_l_d_3*t39, D_delta_z_1_by_l_d_3*t39,
        D_delta_x_2_by_l_d_3*t284 + D_delta_y_2_by_l_d_3*t286 + D_delta_z_2_by_l_d_3*t288,
        D_delta_x_2_by_l_d_3*t289 + D_delta_x_3_by_l_d_3*t283 + D_delta_y_2_by_l_d_3*t290
        + D_delta_y_3_by_l_d_3*t285 + D_delta_z_2_by_l_d_3*t291 + D_delta_z_3_by_l_d_3*t287,
        D_delta_x_2_by_l_d_3*t39, D_delta_y_2_by_l_d_3*t39, D_delta_z_2_by_l_d_3*t39,
        D_delta_x_3_by_l_d_3*t292 + D_delta_y_3_by_l_d_3*t293 + D_delta_z_3_by_l_d_3*t294,
        D_delta_x_3_by_l_d_3*t39, D_delta_y_3_by_l_d_3*t39, D_delta_z_3_by_l_d_3*t39,
    ))
    K_theta_out = _listed(batch, dtype, (
        mu_1_by_b_1_x*t443 + mu_2_by_b_1_x*t435 + mu_3_by_b_1_x*t435 - s_1_x_by_b_1_x*t434 + t410*t411
        - t411*t412 - t411*t413 + t414*t415 - t415*t416 - t415*t417 + t418*t419 - t419*t420 - t419*t421
        + t422*t423 + t422*t424 - t425*t427 - t428*t430 - t431*t433 + t438*theta_1_by_b_1_x
        + t440*theta_1_by_b_1_x + t442*theta_1_by_b_1_x,
        D_p_x_1*D_p_x_2_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_2*k_C - D_p_x_1_by_b_1_x*t444
        - D_p_x_1_by_b_1_x*t445 - D_p_x_2_by_b_1_x*t412 - D_p_x_2_by_b_1_x*t413 - D_p_x_2_by_b_1_x*t426
        + D_p_y_1*D_p_y_2_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_2*k_C - D_p_y_1_by_b_1_x*t446
        - D_p_y_1_by_b_1_x*t447 - D_p_y_2_by_b_1_x*t416 - D_p_y_2_by_b_1_x*t417 - D_p_y_2_by_b_1_x*t429
        + D_p_z_1*D_p_z_2_by_b_1_x*k_C + D_p_z_1_by_b_1_x*D_p_z_2*k_C - D_p_z_1_by_b_1_x*t448
        - D_p_z_1_by_b_1_x*t449 - D_p_z_2_by_b_1_x*t420 - D_p_z_2_by_b_1_x*t421 - D_p_z_2_by_b_1_x*t432
        + mu_1_by_b_1_x*t453 + mu_2_by_b_1_x*t454 + mu_3_by_b_1_x*t455 - t425*t450 - t428*t451 - t431*t452,
        D_p_x_1*D_p_x_3_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_3*k_C - D_p_x_1_by_b_1_x*t456
        - D_p_x_1_by_b_1_x*t457 - D_p_x_3_by_b_1_x*t412 - D_p_x_3_by_b_1_x*t413 - D_p_x_3_by_b_1_x*t426
        + D_p_y_1*D_p_y_3_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_3*k_C - D_p_y_1_by_b_1_x*t458
        - D_p_y_1_by_b_1_x*t459 - D_p_y_3_by_b_1_x*t416 - D_p_y_3_by_b_1_x*t417 - D_p_y_3_by_b_1_x*t429
        + D_p_z_1*D_p_z_3_by_b_1_x*k_C + D_p_z_1_by_b_1_x*D_p_z_3*k_C - D_p_z_1_by_b_1_x*t460
        - D_p_z_1_by_b_1_x*t461 - D_p_z_3_by_b_1_x*t420 - D_p_z_3_by_b_1_x*t421 - D_p_z_3_by_b_1_x*t432
        + mu_1_by_b_1_x*t465 + mu_2_by_b_1_x*t466 + mu_3_by_b_1_x*t467 - t425*t462 - t428*t463 - t431*t464,
        D_delta_x_1*t468 + D_delta_x_1_by_b_1_x*t482 + D_delta_y_1*t469 + D_delta_y_1_by_b_1_x*t483
        + D_delta_z_1*t470 + D_delta_z_1_by_b_1_x*t484 - D_p_x_1_by_b_1_x*t471 - D_p_x_1_by_b_1_x*t472
        - D_p_y_1_by_b_1_x*t473 - D_p_y_1_by_b_1_x*t474 - D_p_z_1_by_b_1_x*t475 - D_p_z_1_by_b_1_x*t476
        + mu_1_by_b_1_x*t480 + mu_2_by_b_1_x*t481 + mu_3_by_b_1_x*t481 - t425*t477 - t428*t478 - t431*t479,
        D_delta_x_2*t468 + D_delta_x_2_by_b_1_x*t482 + D_delta_y_2*t469 + D_delta_y_2_by_b_1_x*t483
        + D_delta_z_2*t470 + D_delta_z_2_by_b_1_x*t484 - D_p_x_1_by_b_1_x*t485 - D_p_x_1_by_b_1_x*t486
        - D_p_y_1_by_b_1_x*t487 - D_p_y_1_by_b_1_x*t488 - D_p_z_1_by_b_1_x*t489 - D_p_z_1_by_b_1_x*t490
        + mu_1_by_b_1_x*t494 + mu_2_by_b_1_x*t495 + mu_3_by_b_1_x*t495 - t425*t491 - t428*t492 - t431*t493,
        D_delta_x_3*t468 + D_delta_x_3_by_b_1_x*t482 + D_delta_y_3*t469 + D_delta_y_3_by_b_1_x*t483
        + D_delta_z_3*t470 + D_delta_z_3_by_b_1_x*t484 - D_p_x_1_by_b_1_x*t496 - D_p_x_1_by_b_1_x*t497
        - D_p_y_1_by_b_1_x*t498 - D_p_y_1_by_b_1_x*t499 - D_p_z_1_by_b_1_x*t500 - D_p_z_1_by_b_1_x*t501
        + mu_1_by_b_1_x*t505 + mu_2_by_b_1_x*t506 + mu_3_by_b_1_x*t506 - t425*t502 - t428*t503 - t431*t504,
        t468, t469, t470,
        2*D_p_x_2*D_p_x_2_by_b_1_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_x*k_C
        + mu_1_by_b_1_x*t510 + mu_2_by_b_1_x*t511 + mu_3_by_b_1_x*t510 - t444*t507 - t445*t507 - t446*t508
        - t447*t508 - t448*t509 - t449*t509 - t450*t507 - t451*t508 - t452*t509,
        D_p_x_2*D_p_x_3_by_b_1_x*k_C + D_p_x_2_by_b_1_x*D_p_x_3*k_C - D_p_x_2_by_b_1_x*t456
        - D_p_x_2_by_b_1_x*t457 - D_p_x_2_by_b_1_x*t462 - D_p_x_3_by_b_1_x*t444 - D_p_x_3_by_b_1_x*t445
        - D_p_x_3_by_b_1_x*t450 + D_p_y_2*D_p_y_3_by_b_1_x*k_C + D_p_y_2_by_b_1_x*D_p_y_3*k_C
        - D_p_y_2_by_b_1_x*t458 - D_p_y_2_by_b_1_x*t459 - D_p_y_2_by_b_1_x*t463 - D_p_y_3_by_b_1_x*t446
        - D_p_y_3_by_b_1_x*t447 - D_p_y_3_by_b_1_x*t451 + D_p_z_2*D_p_z_3_by_b_1_x*k_C
        + D_p_z_2_by_b_1_x*D_p_z_3*k_C - D_p_z_2_by_b_1_x*t460 - D_p_z_2_by_b_1_x*t461
        - D_p_z_2_by_b_1_x*t464 - D_p_z_3_by_b_1_x*t448 - D_p_z_3_by_b_1_x*t449 - D_p_z_3_by_b_1_x*t452
        + mu_1_by_b_1_x*t512 + mu_2_by_b_1_x*t513 + mu_3_by_b_1_x*t514,
        D_delta_x_1*t515 + D_delta_x_1_by_b_1_x*t520 + D_delta_y_1*t516 + D_delta_y_1_by_b_1_x*t521
        + D_delta_z_1*t517 + D_delta_z_1_by_b_1_x*t522 - D_p_x_2_by_b_1_x*t471 - D_p_x_2_by_b_1_x*t472
        - D_p_x_2_by_b_1_x*t477 - D_p_y_2_by_b_1_x*t473 - D_p_y_2_by_b_1_x*t474 - D_p_y_2_by_b_1_x*t478
        - D_p_z_2_by_b_1_x*t475 - D_p_z_2_by_b_1_x*t476 - D_p_z_2_by_b_1_x*t479 + mu_1_by_b_1_x*t518
        + mu_2_by_b_1_x*t519 + mu_3_by_b_1_x*t518,
        D_delta_x_2*t515 + D_delta_x_2_by_b_1_x*t520 + D_delta_y_2*t516 + D_delta_y_2_by_b_1_x*t521
        + D_delta_z_2*t517 + D_delta_z_2_by_b_1_x*t522 - D_p_x_2_by_b_1_x*t485 - D_p_x_2_by_b_1_x*t486
        - D_p_x_2_by_b_1_x*t491 - D_p_y_2_by_b_1_x*t487 - D_p_y_2_by_b_1_x*t488 - D_p_y_2_by_b_1_x*t492
        - D_p_z_2_by_b_1_x*t489 - D_p_z_2_by_b_1_x*t490 - D_p_z_2_by_b_1_x*t493 + mu_1_by_b_1_x*t523
        + mu_2_by_b_1_x*t524 + mu_3_by_b_1_x*t523,
        D_delta_x_3*t515 + D_delta_x_3_by_b_1_x*t520 + D_delta_y_3*t516 + D_delta_y_3_by_b_1_x*t521
        + D_delta_z_3*t517 + D_delta_z_3_by_b_1_x*t522 - D_p_x_2_by_b_1_x*t496 - D_p_x_2_by_b_1_x*t497
        - D_p_x_2_by_b_1_x*t502 - D_p_y_2_by_b_1_x*t498 - D_p_y_2_by_b_1_x*t499 - D_p_y_2_by_b_1_x*t503
        - D_p_z_2_by_b_1_x*t500 - D_p_z_2_by_b_1_x*t501 - D_p_z_2_by_b_1_x*t504 + mu_1_by_b_1_x*t525
        + mu_2_by_b_1_x*t526 + mu_3_by_b_1_x*t525,
        t515, t516, t517,
        2*D_p_x_3*D_p_x_3_by_b_1_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_x*k_C
        + mu_1_by_b_1_x*t530 + mu_2_by_b_1_x*t530 + mu_3_by_b_1_x*t531 - t456*t527 - t457*t527 - t458*t528
        - t459*t528 - t460*t529 - t461*t529 - t462*t527 - t463*t528 - t464*t529,
        D_delta_x_1*t532 + D_delta_x_1_by_b_1_x*t537 + D_delta_y_1*t533 + D_delta_y_1_by_b_1_x*t538
        + D_delta_z_1*t534 + D_delta_z_1_by_b_1_x*t539 - D_p_x_3_by_b_1_x*t471 - D_p_x_3_by_b_1_x*t472
        - D_p_x_3_by_b_1_x*t477 - D_p_y_3_by_b_1_x*t473 - D_p_y_3_by_b_1_x*t474 - D_p_y_3_by_b_1_x*t478
        - D_p_z_3_by_b_1_x*t475 - D_p_z_3_by_b_1_x*t476 - D_p_z_3_by_b_1_x*t479 + mu_1_by_b_1_x*t535
        + mu_2_by_b_1_x*t535 + mu_3_by_b_1_x*t536,
        D_delta_x_2*t532 + D_delta_x_2_by_b_1_x*t537 + D_delta_y_2*t533 + D_delta_y_2_by_b_1_x*t538
        + D_delta_z_2*t534 + D_delta_z_2_by_b_1_x*t539 - D_p_x_3_by_b_1_x*t485 - D_p_x_3_by_b_1_x*t486
        - D_p_x_3_by_b_1_x*t491 - D_p_y_3_by_b_1_x*t487 - D_p_y_3_by_b_1_x*t488 - D_p_y_3_by_b_1_x*t492
        - D_p_z_3_by_b_1_x*t489 - D_p_z_3_by_b_1_x*t490 - D_p_z_3_by_b_1_x*t493 + mu_1_by_b_1_x*t540
        + mu_2_by_b_1_x*t540 + mu_3_by_b_1_x*t541,
        D_delta_x_3*t532 + D_delta_x_3_by_b_1_x*t537 + D_delta_y_3*t533 + D_delta_y_3_by_b_1_x*t538
        + D_delta_z_3*t534 + D_delta_z_3_by_b_1_x*t539 - D_p_x_3_by_b_1_x*t496 - D_p_x_3_by_b_1_x*t497
        - D_p_x_3_by_b_1_x*t502 - D_p_y_3_by_b_1_x*t498 - D_p_y_3_by_b_1_x*t499 - D_p_y_3_by_b_1_x*t503
        - D_p_z_3_by_b_1_x*t500 - D_p_z_3_by_b_1_x*t501 - D_p_z_3_by_b_1_x*t504 + mu_1_by_b_1_x*t542
        + mu_2_by_b_1_x*t542 + mu_3_by_b_1_x*t543,
        t532, t533, t534,
        D_delta_x_1_by_b_1_x*t545 + D_delta_y_1_by_b_1_x*t546 + D_delta_z_1_by_b_1_x*t547
        + mu_1_by_b_1_x*t548 - mu_2_by_b_1_x*t544 - mu_3_by_b_1_x*t544,
        D_delta_x_1_by_b_1_x*t550 + D_delta_x_2_by_b_1_x*t551 + D_delta_y_1_by_b_1_x*t552
        + D_delta_y_2_by_b_1_x*t553 + D_delta_z_1_by_b_1_x*t554 + D_delta_z_2_by_b_1_x*t555
        + mu_1_by_b_1_x*t549 + mu_2_by_b_1_x*t549 + mu_3_by_b_1_x*t549,
        D_delta_x_1_by_b_1_x*t557 + D_delta_x_3_by_b_1_x*t551 + D_delta_y_1_by_b_1_x*t558
        + D_delta_y_3_by_b_1_x*t553 + D_delta_z_1_by_b_1_x*t559 + D_delta_z_3_by_b_1_x*t555
        + mu_1_by_b_1_x*t556 + mu_2_by_b_1_x*t556 + mu_3_by_b_1_x*t556,
        D_delta_x_1_by_b_1_x*k_C, D_delta_y_1_by_b_1_x*k_C, D_delta_z_1_by_b_1_x*k_C,
        D_delta_x_2_by_b_1_x*t561 + D_delta_y_2_by_b_1_x*t562 + D_delta_z_2_by_b_1_x*t563
        - mu_1_by_b_1_x*t560 + mu_2_by_b_1_x*t564 - mu_3_by_b_1_x*t560,
        D_delta_x_2_by_b_1_x*t557 + D_delta_x_3_by_b_1_x*t550 + D_delta_y_2_by_b_1_x*t558
        + D_delta_y_3_by_b_1_x*t552 + D_delta_z_2_by_b_1_x*t559 + D_delta_z_3_by_b_1_x*t554
        + mu_1_by_b_1_x*t565 + mu_2_by_b_1_x*t565 + mu_3_by_b_1_x*t565,
        D_delta_x_2_by_b_1_x*k_C, D_delta_y_2_by_b_1_x*k_C, D_delta_z_2_by_b_1_x*k_C,
        D_delta_x_3_by_b_1_x*t567 + D_delta_y_3_by_b_1_x*t568 + D_delta_z_3_by_b_1_x*t569
        - mu_1_by_b_1_x*t566 - mu_2_by_b_1_x*t566 + mu_3_by_b_1_x*t570,
        D_delta_x_3_by_b_1_x*k_C, D_delta_y_3_by_b_1_x*k_C, D_delta_z_3_by_b_1_x*k_C,
        mu_1_by_b_1_y*t443 + mu_2_by_b_1_y*t435 + mu_3_by_b_1_y*t435 - s_1_y_by_b_1_y*t579 + t410*t571
        - t412*t571 - t413*t571 + t414*t572 - t416*t572 - t417*t572 + t418*t573 - t420*t573 - t421*t573
        + t424*t574 - t427*t576 - t430*t577 - t433*t578 + t438*theta_1_by_b_1_y + t440*theta_1_by_b_1_y
        + t442*theta_1_by_b_1_y + t574*t575,
        D_p_x_1*D_p_x_2_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_2*k_C - D_p_x_1_by_b_1_y*t444
        - D_p_x_1_by_b_1_y*t445 - D_p_x_2_by_b_1_y*t412 - D_p_x_2_by_b_1_y*t413 - D_p_x_2_by_b_1_y*t426
        + D_p_y_1*D_p_y_2_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_2*k_C - D_p_y_1_by_b_1_y*t446
        - D_p_y_1_by_b_1_y*t447 - D_p_y_2_by_b_1_y*t416 - D_p_y_2_by_b_1_y*t417 - D_p_y_2_by_b_1_y*t429
        + D_p_z_1*D_p_z_2_by_b_1_y*k_C + D_p_z_1_by_b_1_y*D_p_z_2*k_C - D_p_z_1_by_b_1_y*t448
        - D_p_z_1_by_b_1_y*t449 - D_p_z_2_by_b_1_y*t420 - D_p_z_2_by_b_1_y*t421 - D_p_z_2_by_b_1_y*t432
        + mu_1_by_b_1_y*t453 + mu_2_by_b_1_y*t454 + mu_3_by_b_1_y*t455 - t450*t576 - t451*t577 - t452*t578,
        D_p_x_1*D_p_x_3_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_3*k_C - D_p_x_1_by_b_1_y*t456
        - D_p_x_1_by_b_1_y*t457 - D_p_x_3_by_b_1_y*t412 - D_p_x_3_by_b_1_y*t413 - D_p_x_3_by_b_1_y*t426
        + D_p_y_1*D_p_y_3_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_3*k_C - D_p_y_1_by_b_1_y*t458
        - D_p_y_1_by_b_1_y*t459 - D_p_y_3_by_b_1_y*t416 - D_p_y_3_by_b_1_y*t417 - D_p_y_3_by_b_1_y*t429
        + D_p_z_1*D_p_z_3_by_b_1_y*k_C + D_p_z_1_by_b_1_y*D_p_z_3*k_C - D_p_z_1_by_b_1_y*t460
        - D_p_z_1_by_b_1_y*t461 - D_p_z_3_by_b_1_y*t420 - D_p_z_3_by_b_1_y*t421 - D_p_z_3_by_b_1_y*t432
        + mu_1_by_b_1_y*t465 + mu_2_by_b_1_y*t466 + mu_3_by_b_1_y*t467 - t462*t576 - t463*t577 - t464*t578,
        D_delta_x_1_by_b_1_y*t482 + D_delta_y_1_by_b_1_y*t483 + D_delta_z_1_by_b_1_y*t484
        - D_p_x_1_by_b_1_y*t471 - D_p_x_1_by_b_1_y*t472 + D_p_x_1_by_b_1_y*t580 - D_p_y_1_by_b_1_y*t473
        - D_p_y_1_by_b_1_y*t474 + D_p_y_1_by_b_1_y*t581 - D_p_z_1_by_b_1_y*t475 - D_p_z_1_by_b_1_y*t476
        + D_p_z_1_by_b_1_y*t582 + mu_1_by_b_1_y*t480 + mu_2_by_b_1_y*t481 + mu_3_by_b_1_y*t481 - t477*t576
        - t478*t577 - t479*t578,
        D_delta_x_2_by_b_1_y*t482 + D_delta_y_2_by_b_1_y*t483 + D_delta_z_2_by_b_1_y*t484
        - D_p_x_1_by_b_1_y*t485 - D_p_x_1_by_b_1_y*t486 + D_p_x_1_by_b_1_y*t583 - D_p_y_1_by_b_1_y*t487
        - D_p_y_1_by_b_1_y*t488 + D_p_y_1_by_b_1_y*t584 - D_p_z_1_by_b_1_y*t489 - D_p_z_1_by_b_1_y*t490
        + D_p_z_1_by_b_1_y*t585 + mu_1_by_b_1_y*t494 + mu_2_by_b_1_y*t495 + mu_3_by_b_1_y*t495 - t491*t576
        - t492*t577 - t493*t578,
        D_delta_x_3_by_b_1_y*t482 + D_delta_y_3_by_b_1_y*t483 + D_delta_z_3_by_b_1_y*t484
        - D_p_x_1_by_b_1_y*t496 - D_p_x_1_by_b_1_y*t497 + D_p_x_1_by_b_1_y*t586 - D_p_y_1_by_b_1_y*t498
        - D_p_y_1_by_b_1_y*t499 + D_p_y_1_by_b_1_y*t587 - D_p_z_1_by_b_1_y*t500 - D_p_z_1_by_b_1_y*t501
        + D_p_z_1_by_b_1_y*t588 + mu_1_by_b_1_y*t505 + mu_2_by_b_1_y*t506 + mu_3_by_b_1_y*t506 - t502*t576
        - t503*t577 - t504*t578,
        D_p_x_1_by_b_1_y*k_C, D_p_y_1_by_b_1_y*k_C, D_p_z_1_by_b_1_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_y*k_C
        + mu_1_by_b_1_y*t510 + mu_2_by_b_1_y*t511 + mu_3_by_b_1_y*t510 - t444*t589 - t445*t589 - t446*t590
        - t447*t590 - t448*t591 - t449*t591 - t450*t589 - t451*t590 - t452*t591,
        D_p_x_2*D_p_x_3_by_b_1_y*k_C + D_p_x_2_by_b_1_y*D_p_x_3*k_C - D_p_x_2_by_b_1_y*t456
        - D_p_x_2_by_b_1_y*t457 - D_p_x_2_by_b_1_y*t462 - D_p_x_3_by_b_1_y*t444 - D_p_x_3_by_b_1_y*t445
        - D_p_x_3_by_b_1_y*t450 + D_p_y_2*D_p_y_3_by_b_1_y*k_C + D_p_y_2_by_b_1_y*D_p_y_3*k_C
        - D_p_y_2_by_b_1_y*t458 - D_p_y_2_by_b_1_y*t459 - D_p_y_2_by_b_1_y*t463 - D_p_y_3_by_b_1_y*t446
        - D_p_y_3_by_b_1_y*t447 - D_p_y_3_by_b_1_y*t451 + D_p_z_2*D_p_z_3_by_b_1_y*k_C
        + D_p_z_2_by_b_1_y*D_p_z_3*k_C - D_p_z_2_by_b_1_y*t460 - D_p_z_2_by_b_1_y*t461
        - D_p_z_2_by_b_1_y*t464 - D_p_z_3_by_b_1_y*t448 - D_p_z_3_by_b_1_y*t449 - D_p_z_3_by_b_1_y*t452
        + mu_1_by_b_1_y*t512 + mu_2_by_b_1_y*t513 + mu_3_by_b_1_y*t514,
        D_delta_x_1_by_b_1_y*t520 + D_delta_y_1_by_b_1_y*t521 + D_delta_z_1_by_b_1_y*t522
        - D_p_x_2_by_b_1_y*t471 - D_p_x_2_by_b_1_y*t472 - D_p_x_2_by_b_1_y*t477 + D_p_x_2_by_b_1_y*t580
        - D_p_y_2_by_b_1_y*t473 - D_p_y_2_by_b_1_y*t474 - D_p_y_2_by_b_1_y*t478 + D_p_y_2_by_b_1_y*t581
        - D_p_z_2_by_b_1_y*t475 - D_p_z_2_by_b_1_y*t476 - D_p_z_2_by_b_1_y*t479 + D_p_z_2_by_b_1_y*t582
        + mu_1_by_b_1_y*t518 + mu_2_by_b_1_y*t519 + mu_3_by_b_1_y*t518,
        D_delta_x_2_by_b_1_y*t520 + D_delta_y_2_by_b_1_y*t521 + D_delta_z_2_by_b_1_y*t522
        - D_p_x_2_by_b_1_y*t485 - D_p_x_2_by_b_1_y*t486 - D_p_x_2_by_b_1_y*t491 + D_p_x_2_by_b_1_y*t583
        - D_p_y_2_by_b_1_y*t487 - D_p_y_2_by_b_1_y*t488 - D_p_y_2_by_b_1_y*t492 + D_p_y_2_by_b_1_y*t584
        - D_p_z_2_by_b_1_y*t489 - D_p_z_2_by_b_1_y*t490 - D_p_z_2_by_b_1_y*t493 + D_p_z_2_by_b_1_y*t585
        + mu_1_by_b_1_y*t523 + mu_2_by_b_1_y*t524 + mu_3_by_b_1_y*t523,
        D_delta_x_3_by_b_1_y*t520 + D_delta_y_3_by_b_1_y*t521 + D_delta_z_3_by_b_1_y*t522
        - D_p_x_2_by_b_1_y*t496 - D_p_x_2_by_b_1_y*t497 - D_p_x_2_by_b_1_y*t502 + D_p_x_2_by_b_1_y*t586
        - D_p_y_2_by_b_1_y*t498 - D_p_y_2_by_b_1_y*t499 - D_p_y_2_by_b_1_y*t503 + D_p_y_2_by_b_1_y*t587
        - D_p_z_2_by_b_1_y*t500 - D_p_z_2_by_b_1_y*t501 - D_p_z_2_by_b_1_y*t504 + D_p_z_2_by_b_1_y*t588
        + mu_1_by_b_1_y*t525 + mu_2_by_b_1_y*t526 + mu_3_by_b_1_y*t525,
        D_p_x_2_by_b_1_y*k_C, D_p_y_2_by_b_1_y*k_C, D_p_z_2_by_b_1_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_y*k_C
        + mu_1_by_b_1_y*t530 + mu_2_by_b_1_y*t530 + mu_3_by_b_1_y*t531 - t456*t592 - t457*t592 - t458*t593
        - t459*t593 - t460*t594 - t461*t594 - t462*t592 - t463*t593 - t464*t594,
        D_delta_x_1_by_b_1_y*t537 + D_delta_y_1_by_b_1_y*t538 + D_delta_z_1_by_b_1_y*t539
        - D_p_x_3_by_b_1_y*t471 - D_p_x_3_by_b_1_y*t472 - D_p_x_3_by_b_1_y*t477 + D_p_x_3_by_b_1_y*t580
        - D_p_y_3_by_b_1_y*t473 - D_p_y_3_by_b_1_y*t474 - D_p_y_3_by_b_1_y*t478 + D_p_y_3_by_b_1_y*t581
        - D_p_z_3_by_b_1_y*t475 - D_p_z_3_by_b_1_y*t476 - D_p_z_3_by_b_1_y*t479 + D_p_z_3_by_b_1_y*t582
        + mu_1_by_b_1_y*t535 + mu_2_by_b_1_y*t535 + mu_3_by_b_1_y*t536,
        D_delta_x_2_by_b_1_y*t537 + D_delta_y_2_by_b_1_y*t538 + D_delta_z_2_by_b_1_y*t539
        - D_p_x_3_by_b_1_y*t485 - D_p_x_3_by_b_1_y*t486 - D_p_x_3_by_b_1_y*t491 + D_p_x_3_by_b_1_y*t583
        - D_p_y_3_by_b_1_y*t487 - D_p_y_3_by_b_1_y*t488 - D_p_y_3_by_b_1_y*t492 + D_p_y_3_by_b_1_y*t584
        - D_p_z_3_by_b_1_y*t489 - D_p_z_3_by_b_1_y*t490 - D_p_z_3_by_b_1_y*t493 + D_p_z_3_by_b_1_y*t585
        + mu_1_by_b_1_y*t540 + mu_2_by_b_1_y*t540 + mu_3_by_b_1_y*t541,
        D_delta_x_3_by_b_1_y*t537 + D_delta_y_3_by_b_1_y*t538 + D_delta_z_3_by_b_1_y*t539
        - D_p_x_3_by_b_1_y*t496 - D_p_x_3_by_b_1_y*t497 - D_p_x_3_by_b_1_y*t502 + D_p_x_3_by_b_1_y*t586
        - D_p_y_3_by_b_1_y*t498 - D_p_y_3_by_b_1_y*t499 - D_p_y_3_by_b_1_y*t503 + D_p_y_3_by_b_1_y*t587
        - D_p_z_3_by_b_1_y*t500 - D_p_z_3_by_b_1_y*t501 - D_p_z_3_by_b_1_y*t504 + D_p_z_3_by_b_1_y*t588
        + mu_1_by_b_1_y*t542 + mu_2_by_b_1_y*t542 + mu_3_by_b_1_y*t543,
        D_p_x_3_by_b_1_y*k_C, D_p_y_3_by_b_1_y*k_C, D_p_z_3_by_b_1_y*k_C,
        D_delta_x_1_by_b_1_y*t545 + D_delta_y_1_by_b_1_y*t546 + D_delta_z_1_by_b_1_y*t547
        + mu_1_by_b_1_y*t548 - mu_2_by_b_1_y*t544 - mu_3_by_b_1_y*t544,
        D_delta_x_1_by_b_1_y*t550 + D_delta_x_2_by_b_1_y*t551 + D_delta_y_1_by_b_1_y*t552
        + D_delta_y_2_by_b_1_y*t553 + D_delta_z_1_by_b_1_y*t554 + D_delta_z_2_by_b_1_y*t555
        + mu_1_by_b_1_y*t549 + mu_2_by_b_1_y*t549 + mu_3_by_b_1_y*t549,
        D_delta_x_1_by_b_1_y*t557 + D_delta_x_3_by_b_1_y*t551 + D_delta_y_1_by_b_1_y*t558
        + D_delta_y_3_by_b_1_y*t553 + D_delta_z_1_by_b_1_y*t559 + D_delta_z_3_by_b_1_y*t555
        + mu_1_by_b_1_y*t556 + mu_2_by_b_1_y*t556 + mu_3_by_b_1_y*t556,
        D_delta_x_1_by_b_1_y*k_C, D_delta_y_1_by_b_1_y*k_C, D_delta_z_1_by_b_1_y*k_C,
        D_delta_x_2_by_b_1_y*t561 + D_delta_y_2_by_b_1_y*t562 + D_delta_z_2_by_b_1_y*t563
        - mu_1_by_b_1_y*t560 + mu_2_by_b_1_y*t564 - mu_3_by_b_1_y*t560,
        D_delta_x_2_by_b_1_y*t557 + D_delta_x_3_by_b_1_y*t550 + D_delta_y_2_by_b_1_y*t558
        + D_delta_y_3_by_b_1_y*t552 + D_delta_z_2_by_b_1_y*t559 + D_delta_z_3_by_b_1_y*t554
        + mu_1_by_b_1_y*t565 + mu_2_by_b_1_y*t565 + mu_3_by_b_1_y*t565,
        D_delta_x_2_by_b_1_y*k_C, D_delta_y_2_by_b_1_y*k_C, D_delta_z_2_by_b_1_y*k_C,
        D_delta_x_3_by_b_1_y*t567 + D_delta_y_3_by_b_1_y*t568 + D_delta_z_3_by_b_1_y*t569
        - mu_1_by_b_1_y*t566 - mu_2_by_b_1_y*t566 + mu_3_by_b_1_y*t570,
        D_delta_x_3_by_b_1_y*k_C, D_delta_y_3_by_b_1_y*k_C, D_delta_z_3_by_b_1_y*k_C,
        mu_1_by_b_1_z*t443 + mu_2_by_b_1_z*t435 + mu_3_by_b_1_z*t435 - s_1_z_by_b_1_z*t602 + t410*t595
        - t412*t595 - t413*t595 + t414*t596 - t416*t596 - t417*t596 + t418*t597 - t420*t597 - t421*t597
        + t423*t598 - t427*t599 - t430*t600 - t433*t601 + t438*theta_1_by_b_1_z + t440*theta_1_by_b_1_z
        + t442*theta_1_by_b_1_z + t575*t598,
        D_p_x_1*D_p_x_2_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_2*k_C - D_p_x_1_by_b_1_z*t444
        - D_p_x_1_by_b_1_z*t445 - D_p_x_2_by_b_1_z*t412 - D_p_x_2_by_b_1_z*t413 - D_p_x_2_by_b_1_z*t426
        + D_p_y_1*D_p_y_2_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_2*k_C - D_p_y_1_by_b_1_z*t446
        - D_p_y_1_by_b_1_z*t447 - D_p_y_2_by_b_1_z*t416 - D_p_y_2_by_b_1_z*t417 - D_p_y_2_by_b_1_z*t429
        + D_p_z_1*D_p_z_2_by_b_1_z*k_C + D_p_z_1_by_b_1_z*D_p_z_2*k_C - D_p_z_1_by_b_1_z*t448
        - D_p_z_1_by_b_1_z*t449 - D_p_z_2_by_b_1_z*t420 - D_p_z_2_by_b_1_z*t421 - D_p_z_2_by_b_1_z*t432
        + mu_1_by_b_1_z*t453 + mu_2_by_b_1_z*t454 + mu_3_by_b_1_z*t455 - t450*t599 - t451*t600 - t452*t601,
        D_p_x_1*D_p_x_3_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_3*k_C - D_p_x_1_by_b_1_z*t456
        - D_p_x_1_by_b_1_z*t457 - D_p_x_3_by_b_1_z*t412 - D_p_x_3_by_b_1_z*t413 - D_p_x_3_by_b_1_z*t426
        + D_p_y_1*D_p_y_3_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_3*k_C - D_p_y_1_by_b_1_z*t458
        - D_p_y_1_by_b_1_z*t459 - D_p_y_3_by_b_1_z*t416 - D_p_y_3_by_b_1_z*t417 - D_p_y_3_by_b_1_z*t429
        + D_p_z_1*D_p_z_3_by_b_1_z*k_C + D_p_z_1_by_b_1_z*D_p_z_3*k_C - D_p_z_1_by_b_1_z*t460
        - D_p_z_1_by_b_1_z*t461 - D_p_z_3_by_b_1_z*t420 - D_p_z_3_by_b_1_z*t421 - D_p_z_3_by_b_1_z*t432
        + mu_1_by_b_1_z*t465 + mu_2_by_b_1_z*t466 + mu_3_by_b_1_z*t467 - t462*t599 - t463*t600 - t464*t601,
        D_delta_x_1_by_b_1_z*t482 + D_delta_y_1_by_b_1_z*t483 + D_delta_z_1_by_b_1_z*t484
        - D_p_x_1_by_b_1_z*t471 - D_p_x_1_by_b_1_z*t472 + D_p_x_1_by_b_1_z*t580 - D_p_y_1_by_b_1_z*t473
        - D_p_y_1_by_b_1_z*t474 + D_p_y_1_by_b_1_z*t581 - D_p_z_1_by_b_1_z*t475 - D_p_z_1_by_b_1_z*t476
        + D_p_z_1_by_b_1_z*t582 + mu_1_by_b_1_z*t480 + mu_2_by_b_1_z*t481 + mu_3_by_b_1_z*t481 - t477*t599
        - t478*t600 - t479*t601,
        D_delta_x_2_by_b_1_z*t482 + D_delta_y_2_by_b_1_z*t483 + D_delta_z_2_by_b_1_z*t484
        - D_p_x_1_by_b_1_z*t485 - D_p_x_1_by_b_1_z*t486 + D_p_x_1_by_b_1_z*t583 - D_p_y_1_by_b_1_z*t487
        - D_p_y_1_by_b_1_z*t488 + D_p_y_1_by_b_1_z*t584 - D_p_z_1_by_b_1_z*t489 - D_p_z_1_by_b_1_z*t490
        + D_p_z_1_by_b_1_z*t585 + mu_1_by_b_1_z*t494 + mu_2_by_b_1_z*t495 + mu_3_by_b_1_z*t495 - t491*t599
        - t492*t600 - t493*t601,
        D_delta_x_3_by_b_1_z*t482 + D_delta_y_3_by_b_1_z*t483 + D_delta_z_3_by_b_1_z*t484
        - D_p_x_1_by_b_1_z*t496 - D_p_x_1_by_b_1_z*t497 + D_p_x_1_by_b_1_z*t586 - D_p_y_1_by_b_1_z*t498
        - D_p_y_1_by_b_1_z*t499 + D_p_y_1_by_b_1_z*t587 - D_p_z_1_by_b_1_z*t500 - D_p_z_1_by_b_1_z*t501
        + D_p_z_1_by_b_1_z*t588 + mu_1_by_b_1_z*t505 + mu_2_by_b_1_z*t506 + mu_3_by_b_1_z*t506 - t502*t599
        - t503*t600 - t504*t601,
        D_p_x_1_by_b_1_z*k_C, D_p_y_1_by_b_1_z*k_C, D_p_z_1_by_b_1_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_z*k_C
        + mu_1_by_b_1_z*t510 + mu_2_by_b_1_z*t511 + mu_3_by_b_1_z*t510 - t444*t603 - t445*t603 - t446*t604
        - t447*t604 - t448*t605 - t449*t605 - t450*t603 - t451*t604 - t452*t605,
        D_p_x_2*D_p_x_3_by_b_1_z*k_C + D_p_x_2_by_b_1_z*D_p_x_3*k_C - D_p_x_2_by_b_1_z*t456
        - D_p_x_2_by_b_1_z*t457 - D_p_x_2_by_b_1_z*t462 - D_p_x_3_by_b_1_z*t444 - D_p_x_3_by_b_1_z*t445
        - D_p_x_3_by_b_1_z*t450 + D_p_y_2*D_p_y_3_by_b_1_z*k_C + D_p_y_2_by_b_1_z*D_p_y_3*k_C
        - D_p_y_2_by_b_1_z*t458 - D_p_y_2_by_b_1_z*t459 - D_p_y_2_by_b_1_z*t463 - D_p_y_3_by_b_1_z*t446
        - D_p_y_3_by_b_1_z*t447 - D_p_y_3_by_b_1_z*t451 + D_p_z_2*D_p_z_3_by_b_1_z*k_C
        + D_p_z_2_by_b_1_z*D_p_z_3*k_C - D_p_z_2_by_b_1_z*t460 - D_p_z_2_by_b_1_z*t461
        - D_p_z_2_by_b_1_z*t464 - D_p_z_3_by_b_1_z*t448 - D_p_z_3_by_b_1_z*t449 - D_p_z_3_by_b_1_z*t452
        + mu_1_by_b_1_z*t512 + mu_2_by_b_1_z*t513 + mu_3_by_b_1_z*t514,
        D_delta_x_1_by_b_1_z*t520 + D_delta_y_1_by_b_1_z*t521 + D_delta_z_1_by_b_1_z*t522
        - D_p_x_2_by_b_1_z*t471 - D_p_x_2_by_b_1_z*t472 - D_p_x_2_by_b_1_z*t477 + D_p_x_2_by_b_1_z*t580
        - D_p_y_2_by_b_1_z*t473 - D_p_y_2_by_b_1_z*t474 - D_p_y_2_by_b_1_z*t478 + D_p_y_2_by_b_1_z*t581
        - D_p_z_2_by_b_1_z*t475 - D_p_z_2_by_b_1_z*t476 - D_p_z_2_by_b_1_z*t479 + D_p_z_2_by_b_1_z*t582
        + mu_1_by_b_1_z*t518 + mu_2_by_b_1_z*t519 + mu_3_by_b_1_z*t518,
        D_delta_x_2_by_b_1_z*t520 + D_delta_y_2_by_b_1_z*t521 + D_delta_z_2_by_b_1_z*t522
        - D_p_x_2_by_b_1_z*t485 - D_p_x_2_by_b_1_z*t486 - D_p_x_2_by_b_1_z*t491 + D_p_x_2_by_b_1_z*t583
        - D_p_y_2_by_b_1_z*t487 - D_p_y_2_by_b_1_z*t488 - D_p_y_2_by_b_1_z*t492 + D_p_y_2_by_b_1_z*t584
        - D_p_z_2_by_b_1_z*t489 - D_p_z_2_by_b_1_z*t490 - D_p_z_2_by_b_1_z*t493 + D_p_z_2_by_b_1_z*t585
        + mu_1_by_b_1_z*t523 + mu_2_by_b_1_z*t524 + mu_3_by_b_1_z*t523,
        D_delta_x_3_by_b_1_z*t520 + D_delta_y_3_by_b_1_z*t521 + D_delta_z_3_by_b_1_z*t522
        - D_p_x_2_by_b_1_z*t496 - D_p_x_2_by_b_1_z*t497 - D_p_x_2_by_b_1_z*t502 + D_p_x_2_by_b_1_z*t586
        - D_p_y_2_by_b_1_z*t498 - D_p_y_2_by_b_1_z*t499 - D_p_y_2_by_b_1_z*t503 + D_p_y_2_by_b_1_z*t587
        - D_p_z_2_by_b_1_z*t500 - D_p_z_2_by_b_1_z*t501 - D_p_z_2_by_b_1_z*t504 + D_p_z_2_by_b_1_z*t588
        + mu_1_by_b_1_z*t525 + mu_2_by_b_1_z*t526 + mu_3_by_b_1_z*t525,
        D_p_x_2_by_b_1_z*k_C, D_p_y_2_by_b_1_z*k_C, D_p_z_2_by_b_1_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_z*k_C
        + mu_1_by_b_1_z*t530 + mu_2_by_b_1_z*t530 + mu_3_by_b_1_z*t531 - t456*t606 - t457*t606 - t458*t607
        - t459*t607 - t460*t608 - t461*t608 - t462*t606 - t463*t607 - t464*t608,
        D_delta_x_1_by_b_1_z*t537 + D_delta_y_1_by_b_1_z*t538 + D_delta_z_1_by_b_1_z*t539
        - D_p_x_3_by_b_1_z*t471 - D_p_x_3_by_b_1_z*t472 - D_p_x_3_by_b_1_z*t477 + D_p_x_3_by_b_1_z*t580
        - D_p_y_3_by_b_1_z*t473 - D_p_y_3_by_b_1_z*t474 - D_p_y_3_by_b_1_z*t478 + D_p_y_3_by_b_1_z*t581
        - D_p_z_3_by_b_1_z*t475 - D_p_z_3_by_b_1_z*t476 - D_p_z_3_by_b_1_z*t479 + D_p_z_3_by_b_1_z*t582
        + mu_1_by_b_1_z*t535 + mu_2_by_b_1_z*t535 + mu_3_by_b_1_z*t536,
        D_delta_x_2_by_b_1_z*t537 + D_delta_y_2_by_b_1_z*t538 + D_delta_z_2_by_b_1_z*t539
        - D_p_x_3_by_b_1_z*t485 - D_p_x_3_by_b_1_z*t486 - D_p_x_3_by_b_1_z*t491 + D_p_x_3_by_b_1_z*t583
        - D_p_y_3_by_b_1_z*t487 - D_p_y_3_by_b_1_z*t488 - D_p_y_3_by_b_1_z*t492 + D_p_y_3_by_b_1_z*t584
        - D_p_z_3_by_b_1_z*t489 - D_p_z_3_by_b_1_z*t490 - D_p_z_3_by_b_1_z*t493 + D_p_z_3_by_b_1_z*t585
        + mu_1_by_b_1_z*t540 + mu_2_by_b_1_z*t540 + mu_3_by_b_1_z*t541,
        D_delta_x_3_by_b_1_z*t537 + D_delta_y_3_by_b_1_z*t538 + D_delta_z_3_by_b_1_z*t539
        - D_p_x_3_by_b_1_z*t496 - D_p_x_3_by_b_1_z*t497 - D_p_x_3_by_b_1_z*t502 + D_p_x_3_by_b_1_z*t586
        - D_p_y_3_by_b_1_z*t498 - D_p_y_3_by_b_1_z*t499 - D_p_y_3_by_b_1_z*t503 + D_p_y_3_by_b_1_z*t587
        - D_p_z_3_by_b_1_z*t500 - D_p_z_3_by_b_1_z*t501 - D_p_z_3_by_b_1_z*t504 + D_p_z_3_by_b_1_z*t588
        + mu_1_by_b_1_z*t542 + mu_2_by_b_1_z*t542 + mu_3_by_b_1_z*t543,
        D_p_x_3_by_b_1_z*k_C, D_p_y_3_by_b_1_z*k_C, D_p_z_3_by_b_1_z*k_C,
        D_delta_x_1_by_b_1_z*t545 + D_delta_y_1_by_b_1_z*t546 + D_delta_z_1_by_b_1_z*t547
        + mu_1_by_b_1_z*t548 - mu_2_by_b_1_z*t544 - mu_3_by_b_1_z*t544,
        D_delta_x_1_by_b_1_z*t550 + D_delta_x_2_by_b_1_z*t551 + D_delta_y_1_by_b_1_z*t552
        + D_delta_y_2_by_b_1_z*t553 + D_delta_z_1_by_b_1_z*t554 + D_delta_z_2_by_b_1_z*t555
        + mu_1_by_b_1_z*t549 + mu_2_by_b_1_z*t549 + mu_3_by_b_1_z*t549,
        D_delta_x_1_by_b_1_z*t557 + D_delta_x_3_by_b_1_z*t551 + D_delta_y_1_by_b_1_z*t558
        + D_delta_y_3_by_b_1_z*t553 + D_delta_z_1_by_b_1_z*t559 + D_delta_z_3_by_b_1_z*t555
        + mu_1_by_b_1_z*t556 + mu_2_by_b_1_z*t556 + mu_3_by_b_1_z*t556,
        D_delta_x_1_by_b_1_z*k_C, D_delta_y_1_by_b_1_z*k_C, D_delta_z_1_by_b_1_z*k_C,
        D_delta_x_2_by_b_1_z*t561 + D_delta_y_2_by_b_1_z*t562 + D_delta_z_2_by_b_1_z*t563
        - mu_1_by_b_1_z*t560 + mu_2_by_b_1_z*t564 - mu_3_by_b_1_z*t560,
        D_delta_x_2_by_b_1_z*t557 + D_delta_x_3_by_b_1_z*t550 + D_delta_y_2_by_b_1_z*t558
        + D_delta_y_3_by_b_1_z*t552 + D_delta_z_2_by_b_1_z*t559 + D_delta_z_3_by_b_1_z*t554
        + mu_1_by_b_1_z*t565 + mu_2_by_b_1_z*t565 + mu_3_by_b_1_z*t565,
        D_delta_x_2_by_b_1_z*k_C, D_delta_y_2_by_b_1_z*k_C, D_delta_z_2_by_b_1_z*k_C,
        D_delta_x_3_by_b_1_z*t567 + D_delta_y_3_by_b_1_z*t568 + D_delta_z_3_by_b_1_z*t569
        - mu_1_by_b_1_z*t566 - mu_2_by_b_1_z*t566 + mu_3_by_b_1_z*t570,
        D_delta_x_3_by_b_1_z*k_C, D_delta_y_3_by_b_1_z*k_C, D_delta_z_3_by_b_1_z*k_C,
        2*D_p_x_1*D_p_x_1_by_b_2_x*k_C - D_p_x_1_by_b_2_x*t427 + 2*D_p_y_1*D_p_y_1_by_b_2_x*k_C
        - D_p_y_1_by_b_2_x*t430 + 2*D_p_z_1*D_p_z_1_by_b_2_x*k_C - D_p_z_1_by_b_2_x*t433
        + mu_1_by_b_2_x*t443 + mu_2_by_b_2_x*t435 + mu_3_by_b_2_x*t435 - t412*t609 - t413*t609 - t416*t610
        - t417*t610 - t420*t611 - t421*t611,
        D_p_x_1*D_p_x_2_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_2*k_C - D_p_x_1_by_b_2_x*t444
        - D_p_x_1_by_b_2_x*t445 - D_p_x_1_by_b_2_x*t450 - D_p_x_2_by_b_2_x*t413 - D_p_x_2_by_b_2_x*t426
        + D_p_y_1*D_p_y_2_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_2*k_C - D_p_y_1_by_b_2_x*t446
        - D_p_y_1_by_b_2_x*t447 - D_p_y_1_by_b_2_x*t451 - D_p_y_2_by_b_2_x*t417 - D_p_y_2_by_b_2_x*t429
        + D_p_z_1*D_p_z_2_by_b_2_x*k_C + D_p_z_1_by_b_2_x*D_p_z_2*k_C - D_p_z_1_by_b_2_x*t448
        - D_p_z_1_by_b_2_x*t449 - D_p_z_1_by_b_2_x*t452 - D_p_z_2_by_b_2_x*t421 - D_p_z_2_by_b_2_x*t432
        + mu_1_by_b_2_x*t453 + mu_2_by_b_2_x*t454 + mu_3_by_b_2_x*t455 - t412*t612 - t416*t613 - t420*t614,
        D_p_x_1*D_p_x_3_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_3*k_C - D_p_x_1_by_b_2_x*t456
        - D_p_x_1_by_b_2_x*t457 - D_p_x_1_by_b_2_x*t462 - D_p_x_3_by_b_2_x*t412 - D_p_x_3_by_b_2_x*t413
        - D_p_x_3_by_b_2_x*t426 + D_p_y_1*D_p_y_3_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_3*k_C
        - D_p_y_1_by_b_2_x*t458 - D_p_y_1_by_b_2_x*t459 - D_p_y_1_by_b_2_x*t463 - D_p_y_3_by_b_2_x*t416
        - D_p_y_3_by_b_2_x*t417 - D_p_y_3_by_b_2_x*t429 + D_p_z_1*D_p_z_3_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_3*k_C - D_p_z_1_by_b_2_x*t460 - D_p_z_1_by_b_2_x*t461
        - D_p_z_1_by_b_2_x*t464 - D_p_z_3_by_b_2_x*t420 - D_p_z_3_by_b_2_x*t421 - D_p_z_3_by_b_2_x*t432
        + mu_1_by_b_2_x*t465 + mu_2_by_b_2_x*t466 + mu_3_by_b_2_x*t467,
        D_delta_x_1_by_b_2_x*t482 + D_delta_y_1_by_b_2_x*t483 + D_delta_z_1_by_b_2_x*t484
        - D_p_x_1_by_b_2_x*t471 - D_p_x_1_by_b_2_x*t472 - D_p_x_1_by_b_2_x*t477 + D_p_x_1_by_b_2_x*t580
        - D_p_y_1_by_b_2_x*t473 - D_p_y_1_by_b_2_x*t474 - D_p_y_1_by_b_2_x*t478 + D_p_y_1_by_b_2_x*t581
        - D_p_z_1_by_b_2_x*t475 - D_p_z_1_by_b_2_x*t476 - D_p_z_1_by_b_2_x*t479 + D_p_z_1_by_b_2_x*t582
        + mu_1_by_b_2_x*t480 + mu_2_by_b_2_x*t481 + mu_3_by_b_2_x*t481,
        D_delta_x_2_by_b_2_x*t482 + D_delta_y_2_by_b_2_x*t483 + D_delta_z_2_by_b_2_x*t484
        - D_p_x_1_by_b_2_x*t485 - D_p_x_1_by_b_2_x*t486 - D_p_x_1_by_b_2_x*t491 + D_p_x_1_by_b_2_x*t583
        - D_p_y_1_by_b_2_x*t487 - D_p_y_1_by_b_2_x*t488 - D_p_y_1_by_b_2_x*t492 + D_p_y_1_by_b_2_x*t584
        - D_p_z_1_by_b_2_x*t489 - D_p_z_1_by_b_2_x*t490 - D_p_z_1_by_b_2_x*t493 + D_p_z_1_by_b_2_x*t585
        + mu_1_by_b_2_x*t494 + mu_2_by_b_2_x*t495 + mu_3_by_b_2_x*t495,
        D_delta_x_3_by_b_2_x*t482 + D_delta_y_3_by_b_2_x*t483 + D_delta_z_3_by_b_2_x*t484
        - D_p_x_1_by_b_2_x*t496 - D_p_x_1_by_b_2_x*t497 - D_p_x_1_by_b_2_x*t502 + D_p_x_1_by_b_2_x*t586
        - D_p_y_1_by_b_2_x*t498 - D_p_y_1_by_b_2_x*t499 - D_p_y_1_by_b_2_x*t503 + D_p_y_1_by_b_2_x*t587
        - D_p_z_1_by_b_2_x*t500 - D_p_z_1_by_b_2_x*t501 - D_p_z_1_by_b_2_x*t504 + D_p_z_1_by_b_2_x*t588
        + mu_1_by_b_2_x*t505 + mu_2_by_b_2_x*t506 + mu_3_by_b_2_x*t506,
        D_p_x_1_by_b_2_x*k_C, D_p_y_1_by_b_2_x*k_C, D_p_z_1_by_b_2_x*k_C,
        mu_1_by_b_2_x*t510 + mu_2_by_b_2_x*t511 + mu_3_by_b_2_x*t510 - s_2_x_by_b_2_x*t627 - t444*t616
        - t446*t618 - t448*t620 - t450*t616 - t451*t618 - t452*t620 - t612*t624 - t613*t625 - t614*t626
        + t615*t616 + t617*t618 + t619*t620 + t621*t622 + t621*t623 + t630*theta_2_by_b_2_x
        + t632*theta_2_by_b_2_x + t634*theta_2_by_b_2_x,
        D_p_x_2*D_p_x_3_by_b_2_x*k_C + D_p_x_2_by_b_2_x*D_p_x_3*k_C - D_p_x_2_by_b_2_x*t457
        - D_p_x_2_by_b_2_x*t462 - D_p_x_3_by_b_2_x*t444 - D_p_x_3_by_b_2_x*t445 - D_p_x_3_by_b_2_x*t450
        + D_p_y_2*D_p_y_3_by_b_2_x*k_C + D_p_y_2_by_b_2_x*D_p_y_3*k_C - D_p_y_2_by_b_2_x*t459
        - D_p_y_2_by_b_2_x*t463 - D_p_y_3_by_b_2_x*t446 - D_p_y_3_by_b_2_x*t447 - D_p_y_3_by_b_2_x*t451
        + D_p_z_2*D_p_z_3_by_b_2_x*k_C + D_p_z_2_by_b_2_x*D_p_z_3*k_C - D_p_z_2_by_b_2_x*t461
        - D_p_z_2_by_b_2_x*t464 - D_p_z_3_by_b_2_x*t448 - D_p_z_3_by_b_2_x*t449 - D_p_z_3_by_b_2_x*t452
        + mu_1_by_b_2_x*t512 + mu_2_by_b_2_x*t513 + mu_3_by_b_2_x*t514 - t456*t612 - t458*t613 - t460*t614,
        D_delta_x_1_by_b_2_x*t520 + D_delta_y_1_by_b_2_x*t521 + D_delta_z_1_by_b_2_x*t522
        - D_p_x_2_by_b_2_x*t472 - D_p_x_2_by_b_2_x*t477 + D_p_x_2_by_b_2_x*t580 - D_p_y_2_by_b_2_x*t474
        - D_p_y_2_by_b_2_x*t478 + D_p_y_2_by_b_2_x*t581 - D_p_z_2_by_b_2_x*t476 - D_p_z_2_by_b_2_x*t479
        + D_p_z_2_by_b_2_x*t582 + mu_1_by_b_2_x*t518 + mu_2_by_b_2_x*t519 + mu_3_by_b_2_x*t518 - t471*t612
        - t473*t613 - t475*t614,
        D_delta_x_2_by_b_2_x*t520 + D_delta_y_2_by_b_2_x*t521 + D_delta_z_2_by_b_2_x*t522
        - D_p_x_2_by_b_2_x*t486 - D_p_x_2_by_b_2_x*t491 + D_p_x_2_by_b_2_x*t583 - D_p_y_2_by_b_2_x*t488
        - D_p_y_2_by_b_2_x*t492 + D_p_y_2_by_b_2_x*t584 - D_p_z_2_by_b_2_x*t490 - D_p_z_2_by_b_2_x*t493
        + D_p_z_2_by_b_2_x*t585 + mu_1_by_b_2_x*t523 + mu_2_by_b_2_x*t524 + mu_3_by_b_2_x*t523 - t485*t612
        - t487*t613 - t489*t614,
        D_delta_x_3_by_b_2_x*t520 + D_delta_y_3_by_b_2_x*t521 + D_delta_z_3_by_b_2_x*t522
        - D_p_x_2_by_b_2_x*t497 - D_p_x_2_by_b_2_x*t502 + D_p_x_2_by_b_2_x*t586 - D_p_y_2_by_b_2_x*t499
        - D_p_y_2_by_b_2_x*t503 + D_p_y_2_by_b_2_x*t587 - D_p_z_2_by_b_2_x*t501 - D_p_z_2_by_b_2_x*t504
        + D_p_z_2_by_b_2_x*t588 + mu_1_by_b_2_x*t525 + mu_2_by_b_2_x*t526 + mu_3_by_b_2_x*t525 - t496*t612
        - t498*t613 - t500*t614,
        D_p_x_2_by_b_2_x*k_C, D_p_y_2_by_b_2_x*k_C, D_p_z_2_by_b_2_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_x*k_C
        + mu_1_by_b_2_x*t530 + mu_2_by_b_2_x*t530 + mu_3_by_b_2_x*t531 - t456*t635 - t457*t635 - t458*t636
        - t459*t636 - t460*t637 - t461*t637 - t462*t635 - t463*t636 - t464*t637,
        D_delta_x_1_by_b_2_x*t537 + D_delta_y_1_by_b_2_x*t538 + D_delta_z_1_by_b_2_x*t539
        - D_p_x_3_by_b_2_x*t471 - D_p_x_3_by_b_2_x*t472 - D_p_x_3_by_b_2_x*t477 + D_p_x_3_by_b_2_x*t580
        - D_p_y_3_by_b_2_x*t473 - D_p_y_3_by_b_2_x*t474 - D_p_y_3_by_b_2_x*t478 + D_p_y_3_by_b_2_x*t581
        - D_p_z_3_by_b_2_x*t475 - D_p_z_3_by_b_2_x*t476 - D_p_z_3_by_b_2_x*t479 + D_p_z_3_by_b_2_x*t582
        + mu_1_by_b_2_x*t535 + mu_2_by_b_2_x*t535 + mu_3_by_b_2_x*t536,
        D_delta_x_2_by_b_2_x*t537 + D_delta_y_2_by_b_2_x*t538 + D_delta_z_2_by_b_2_x*t539
        - D_p_x_3_by_b_2_x*t485 - D_p_x_3_by_b_2_x*t486 - D_p_x_3_by_b_2_x*t491 + D_p_x_3_by_b_2_x*t583
        - D_p_y_3_by_b_2_x*t487 - D_p_y_3_by_b_2_x*t488 - D_p_y_3_by_b_2_x*t492 + D_p_y_3_by_b_2_x*t584
        - D_p_z_3_by_b_2_x*t489 - D_p_z_3_by_b_2_x*t490 - D_p_z_3_by_b_2_x*t493 + D_p_z_3_by_b_2_x*t585
        + mu_1_by_b_2_x*t540 + mu_2_by_b_2_x*t540 + mu_3_by_b_2_x*t541,
        D_delta_x_3_by_b_2_x*t537 + D_delta_y_3_by_b_2_x*t538 + D_delta_z_3_by_b_2_x*t539
        - D_p_x_3_by_b_2_x*t496 - D_p_x_3_by_b_2_x*t497 - D_p_x_3_by_b_2_x*t502 + D_p_x_3_by_b_2_x*t586
        - D_p_y_3_by_b_2_x*t498 - D_p_y_3_by_b_2_x*t499 - D_p_y_3_by_b_2_x*t503 + D_p_y_3_by_b_2_x*t587
        - D_p_z_3_by_b_2_x*t500 - D_p_z_3_by_b_2_x*t501 - D_p_z_3_by_b_2_x*t504 + D_p_z_3_by_b_2_x*t588
        + mu_1_by_b_2_x*t542 + mu_2_by_b_2_x*t542 + mu_3_by_b_2_x*t543,
        D_p_x_3_by_b_2_x*k_C, D_p_y_3_by_b_2_x*k_C, D_p_z_3_by_b_2_x*k_C,
        D_delta_x_1_by_b_2_x*t545 + D_delta_y_1_by_b_2_x*t546 + D_delta_z_1_by_b_2_x*t547
        + mu_1_by_b_2_x*t548 - mu_2_by_b_2_x*t544 - mu_3_by_b_2_x*t544,
        D_delta_x_1_by_b_2_x*t550 + D_delta_x_2_by_b_2_x*t551 + D_delta_y_1_by_b_2_x*t552
        + D_delta_y_2_by_b_2_x*t553 + D_delta_z_1_by_b_2_x*t554 + D_delta_z_2_by_b_2_x*t555
        + mu_1_by_b_2_x*t549 + mu_2_by_b_2_x*t549 + mu_3_by_b_2_x*t549,
        D_delta_x_1_by_b_2_x*t557 + D_delta_x_3_by_b_2_x*t551 + D_delta_y_1_by_b_2_x*t558
        + D_delta_y_3_by_b_2_x*t553 + D_delta_z_1_by_b_2_x*t559 + D_delta_z_3_by_b_2_x*t555
        + mu_1_by_b_2_x*t556 + mu_2_by_b_2_x*t556 + mu_3_by_b_2_x*t556,
        D_delta_x_1_by_b_2_x*k_C, D_delta_y_1_by_b_2_x*k_C, D_delta_z_1_by_b_2_x*k_C,
        D_delta_x_2_by_b_2_x*t561 + D_delta_y_2_by_b_2_x*t562 + D_delta_z_2_by_b_2_x*t563
        - mu_1_by_b_2_x*t560 + mu_2_by_b_2_x*t564 - mu_3_by_b_2_x*t560,
        D_delta_x_2_by_b_2_x*t557 + D_delta_x_3_by_b_2_x*t550 + D_delta_y_2_by_b_2_x*t558
        + D_delta_y_3_by_b_2_x*t552 + D_delta_z_2_by_b_2_x*t559 + D_delta_z_3_by_b_2_x*t554
        + mu_1_by_b_2_x*t565 + mu_2_by_b_2_x*t565 + mu_3_by_b_2_x*t565,
        D_delta_x_2_by_b_2_x*k_C, D_delta_y_2_by_b_2_x*k_C, D_delta_z_2_by_b_2_x*k_C,
        D_delta_x_3_by_b_2_x*t567 + D_delta_y_3_by_b_2_x*t568 + D_delta_z_3_by_b_2_x*t569
        - mu_1_by_b_2_x*t566 - mu_2_by_b_2_x*t566 + mu_3_by_b_2_x*t570,
        D_delta_x_3_by_b_2_x*k_C, D_delta_y_3_by_b_2_x*k_C, D_delta_z_3_by_b_2_x*k_C,
        2*D_p_x_1*D_p_x_1_by_b_2_y*k_C - D_p_x_1_by_b_2_y*t427 + 2*D_p_y_1*D_p_y_1_by_b_2_y*k_C
        - D_p_y_1_by_b_2_y*t430 + 2*D_p_z_1*D_p_z_1_by_b_2_y*k_C - D_p_z_1_by_b_2_y*t433
        + mu_1_by_b_2_y*t443 + mu_2_by_b_2_y*t435 + mu_3_by_b_2_y*t435 - t412*t638 - t413*t638 - t416*t639
        - t417*t639 - t420*t640 - t421*t640,
        D_p_x_1*D_p_x_2_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_2*k_C - D_p_x_1_by_b_2_y*t444
        - D_p_x_1_by_b_2_y*t445 - D_p_x_1_by_b_2_y*t450 - D_p_x_2_by_b_2_y*t413 - D_p_x_2_by_b_2_y*t426
        + D_p_y_1*D_p_y_2_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_2*k_C - D_p_y_1_by_b_2_y*t446
        - D_p_y_1_by_b_2_y*t447 - D_p_y_1_by_b_2_y*t451 - D_p_y_2_by_b_2_y*t417 - D_p_y_2_by_b_2_y*t429
        + D_p_z_1*D_p_z_2_by_b_2_y*k_C + D_p_z_1_by_b_2_y*D_p_z_2*k_C - D_p_z_1_by_b_2_y*t448
        - D_p_z_1_by_b_2_y*t449 - D_p_z_1_by_b_2_y*t452 - D_p_z_2_by_b_2_y*t421 - D_p_z_2_by_b_2_y*t432
        + mu_1_by_b_2_y*t453 + mu_2_by_b_2_y*t454 + mu_3_by_b_2_y*t455 - t412*t641 - t416*t642 - t420*t643,
        D_p_x_1*D_p_x_3_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_3*k_C - D_p_x_1_by_b_2_y*t456
        - D_p_x_1_by_b_2_y*t457 - D_p_x_1_by_b_2_y*t462 - D_p_x_3_by_b_2_y*t412 - D_p_x_3_by_b_2_y*t413
        - D_p_x_3_by_b_2_y*t426 + D_p_y_1*D_p_y_3_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_3*k_C
        - D_p_y_1_by_b_2_y*t458 - D_p_y_1_by_b_2_y*t459 - D_p_y_1_by_b_2_y*t463 - D_p_y_3_by_b_2_y*t416
        - D_p_y_3_by_b_2_y*t417 - D_p_y_3_by_b_2_y*t429 + D_p_z_1*D_p_z_3_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_3*k_C - D_p_z_1_by_b_2_y*t460 - D_p_z_1_by_b_2_y*t461
        - D_p_z_1_by_b_2_y*t464 - D_p_z_3_by_b_2_y*t420 - D_p_z_3_by_b_2_y*t421 - D_p_z_3_by_b_2_y*t432
        + mu_1_by_b_2_y*t465 + mu_2_by_b_2_y*t466 + mu_3_by_b_2_y*t467,
        D_delta_x_1_by_b_2_y*t482 + D_delta_y_1_by_b_2_y*t483 + D_delta_z_1_by_b_2_y*t484
        - D_p_x_1_by_b_2_y*t471 - D_p_x_1_by_b_2_y*t472 - D_p_x_1_by_b_2_y*t477 + D_p_x_1_by_b_2_y*t580
        - D_p_y_1_by_b_2_y*t473 - D_p_y_1_by_b_2_y*t474 - D_p_y_1_by_b_2_y*t478 + D_p_y_1_by_b_2_y*t581
        - D_p_z_1_by_b_2_y*t475 - D_p_z_1_by_b_2_y*t476 - D_p_z_1_by_b_2_y*t479 + D_p_z_1_by_b_2_y*t582
        + mu_1_by_b_2_y*t480 + mu_2_by_b_2_y*t481 + mu_3_by_b_2_y*t481,
        D_delta_x_2_by_b_2_y*t482 + D_delta_y_2_by_b_2_y*t483 + D_delta_z_2_by_b_2_y*t484
        - D_p_x_1_by_b_2_y*t485 - D_p_x_1_by_b_2_y*t486 - D_p_x_1_by_b_2_y*t491 + D_p_x_1_by_b_2_y*t583
        - D_p_y_1_by_b_2_y*t487 - D_p_y_1_by_b_2_y*t488 - D_p_y_1_by_b_2_y*t492 + D_p_y_1_by_b_2_y*t584
        - D_p_z_1_by_b_2_y*t489 - D_p_z_1_by_b_2_y*t490 - D_p_z_1_by_b_2_y*t493 + D_p_z_1_by_b_2_y*t585
        + mu_1_by_b_2_y*t494 + mu_2_by_b_2_y*t495 + mu_3_by_b_2_y*t495,
        D_delta_x_3_by_b_2_y*t482 + D_delta_y_3_by_b_2_y*t483 + D_delta_z_3_by_b_2_y*t484
        - D_p_x_1_by_b_2_y*t496 - D_p_x_1_by_b_2_y*t497 - D_p_x_1_by_b_2_y*t502 + D_p_x_1_by_b_2_y*t586
        - D_p_y_1_by_b_2_y*t498 - D_p_y_1_by_b_2_y*t499 - D_p_y_1_by_b_2_y*t503 + D_p_y_1_by_b_2_y*t587
        - D_p_z_1_by_b_2_y*t500 - D_p_z_1_by_b_2_y*t501 - D_p_z_1_by_b_2_y*t504 + D_p_z_1_by_b_2_y*t588
        + mu_1_by_b_2_y*t505 + mu_2_by_b_2_y*t506 + mu_3_by_b_2_y*t506,
        D_p_x_1_by_b_2_y*k_C, D_p_y_1_by_b_2_y*k_C, D_p_z_1_by_b_2_y*k_C,
        mu_1_by_b_2_y*t510 + mu_2_by_b_2_y*t511 + mu_3_by_b_2_y*t510 - s_2_y_by_b_2_y*t649 - t444*t644
        - t446*t645 - t448*t646 - t450*t644 - t451*t645 - t452*t646 + t615*t644 + t617*t645 + t619*t646
        + t623*t647 - t624*t641 - t625*t642 - t626*t643 + t630*theta_2_by_b_2_y + t632*theta_2_by_b_2_y
        + t634*theta_2_by_b_2_y + t647*t648,
        D_p_x_2*D_p_x_3_by_b_2_y*k_C + D_p_x_2_by_b_2_y*D_p_x_3*k_C - D_p_x_2_by_b_2_y*t457
        - D_p_x_2_by_b_2_y*t462 - D_p_x_3_by_b_2_y*t444 - D_p_x_3_by_b_2_y*t445 - D_p_x_3_by_b_2_y*t450
        + D_p_y_2*D_p_y_3_by_b_2_y*k_C + D_p_y_2_by_b_2_y*D_p_y_3*k_C - D_p_y_2_by_b_2_y*t459
        - D_p_y_2_by_b_2_y*t463 - D_p_y_3_by_b_2_y*t446 - D_p_y_3_by_b_2_y*t447 - D_p_y_3_by_b_2_y*t451
        + D_p_z_2*D_p_z_3_by_b_2_y*k_C + D_p_z_2_by_b_2_y*D_p_z_3*k_C - D_p_z_2_by_b_2_y*t461
        - D_p_z_2_by_b_2_y*t464 - D_p_z_3_by_b_2_y*t448 - D_p_z_3_by_b_2_y*t449 - D_p_z_3_by_b_2_y*t452
        + mu_1_by_b_2_y*t512 + mu_2_by_b_2_y*t513 + mu_3_by_b_2_y*t514 - t456*t641 - t458*t642 - t460*t643,
        D_delta_x_1_by_b_2_y*t520 + D_delta_y_1_by_b_2_y*t521 + D_delta_z_1_by_b_2_y*t522
        - D_p_x_2_by_b_2_y*t472 - D_p_x_2_by_b_2_y*t477 + D_p_x_2_by_b_2_y*t580 - D_p_y_2_by_b_2_y*t474
        - D_p_y_2_by_b_2_y*t478 + D_p_y_2_by_b_2_y*t581 - D_p_z_2_by_b_2_y*t476 - D_p_z_2_by_b_2_y*t479
        + D_p_z_2_by_b_2_y*t582 + mu_1_by_b_2_y*t518 + mu_2_by_b_2_y*t519 + mu_3_by_b_2_y*t518 - t471*t641
        - t473*t642 - t475*t643,
        D_delta_x_2_by_b_2_y*t520 + D_delta_y_2_by_b_2_y*t521 + D_delta_z_2_by_b_2_y*t522
        - D_p_x_2_by_b_2_y*t486 - D_p_x_2_by_b_2_y*t491 + D_p_x_2_by_b_2_y*t583 - D_p_y_2_by_b_2_y*t488
        - D_p_y_2_by_b_2_y*t492 + D_p_y_2_by_b_2_y*t584 - D_p_z_2_by_b_2_y*t490 - D_p_z_2_by_b_2_y*t493
        + D_p_z_2_by_b_2_y*t585 + mu_1_by_b_2_y*t523 + mu_2_by_b_2_y*t524 + mu_3_by_b_2_y*t523 - t485*t641
        - t487*t642 - t489*t643,
        D_delta_x_3_by_b_2_y*t520 + D_delta_y_3_by_b_2_y*t521 + D_delta_z_3_by_b_2_y*t522
        - D_p_x_2_by_b_2_y*t497 - D_p_x_2_by_b_2_y*t502 + D_p_x_2_by_b_2_y*t586 - D_p_y_2_by_b_2_y*t499
        - D_p_y_2_by_b_2_y*t503 + D_p_y_2_by_b_2_y*t587 - D_p_z_2_by_b_2_y*t501 - D_p_z_2_by_b_2_y*t504
        + D_p_z_2_by_b_2_y*t588 + mu_1_by_b_2_y*t525 + mu_2_by_b_2_y*t526 + mu_3_by_b_2_y*t525 - t496*t641
        - t498*t642 - t500*t643,
        D_p_x_2_by_b_2_y*k_C, D_p_y_2_by_b_2_y*k_C, D_p_z_2_by_b_2_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_y*k_C
        + mu_1_by_b_2_y*t530 + mu_2_by_b_2_y*t530 + mu_3_by_b_2_y*t531 - t456*t650 - t457*t650 - t458*t651
        - t459*t651 - t460*t652 - t461*t652 - t462*t650 - t463*t651 - t464*t652,
        D_delta_x_1_by_b_2_y*t537 + D_delta_y_1_by_b_2_y*t538 + D_delta_z_1_by_b_2_y*t539
        - D_p_x_3_by_b_2_y*t471 - D_p_x_3_by_b_2_y*t472 - D_p_x_3_by_b_2_y*t477 + D_p_x_3_by_b_2_y*t580
        - D_p_y_3_by_b_2_y*t473 - D_p_y_3_by_b_2_y*t474 - D_p_y_3_by_b_2_y*t478 + D_p_y_3_by_b_2_y*t581
        - D_p_z_3_by_b_2_y*t475 - D_p_z_3_by_b_2_y*t476 - D_p_z_3_by_b_2_y*t479 + D_p_z_3_by_b_2_y*t582
        + mu_1_by_b_2_y*t535 + mu_2_by_b_2_y*t535 + mu_3_by_b_2_y*t536,
        D_delta_x_2_by_b_2_y*t537 + D_delta_y_2_by_b_2_y*t538 + D_delta_z_2_by_b_2_y*t539
        - D_p_x_3_by_b_2_y*t485 - D_p_x_3_by_b_2_y*t486 - D_p_x_3_by_b_2_y*t491 + D_p_x_3_by_b_2_y*t583
        - D_p_y_3_by_b_2_y*t487 - D_p_y_3_by_b_2_y*t488 - D_p_y_3_by_b_2_y*t492 + D_p_y_3_by_b_2_y*t584
        - D_p_z_3_by_b_2_y*t489 - D_p_z_3_by_b_2_y*t490 - D_p_z_3_by_b_2_y*t493 + D_p_z_3_by_b_2_y*t585
        + mu_1_by_b_2_y*t540 + mu_2_by_b_2_y*t540 + mu_3_by_b_2_y*t541,
        D_delta_x_3_by_b_2_y*t537 + D_delta_y_3_by_b_2_y*t538 + D_delta_z_3_by_b_2_y*t539
        - D_p_x_3_by_b_2_y*t496 - D_p_x_3_by_b_2_y*t497 - D_p_x_3_by_b_2_y*t502 + D_p_x_3_by_b_2_y*t586
        - D_p_y_3_by_b_2_y*t498 - D_p_y_3_by_b_2_y*t499 - D_p_y_3_by_b_2_y*t503 + D_p_y_3_by_b_2_y*t587
        - D_p_z_3_by_b_2_y*t500 - D_p_z_3_by_b_2_y*t501 - D_p_z_3_by_b_2_y*t504 + D_p_z_3_by_b_2_y*t588
        + mu_1_by_b_2_y*t542 + mu_2_by_b_2_y*t542 + mu_3_by_b_2_y*t543,
        D_p_x_3_by_b_2_y*k_C, D_p_y_3_by_b_2_y*k_C, D_p_z_3_by_b_2_y*k_C,
        D_delta_x_1_by_b_2_y*t545 + D_delta_y_1_by_b_2_y*t546 + D_delta_z_1_by_b_2_y*t547
        + mu_1_by_b_2_y*t548 - mu_2_by_b_2_y*t544 - mu_3_by_b_2_y*t544,
        D_delta_x_1_by_b_2_y*t550 + D_delta_x_2_by_b_2_y*t551 + D_delta_y_1_by_b_2_y*t552
        + D_delta_y_2_by_b_2_y*t553 + D_delta_z_1_by_b_2_y*t554 + D_delta_z_2_by_b_2_y*t555
        + mu_1_by_b_2_y*t549 + mu_2_by_b_2_y*t549 + mu_3_by_b_2_y*t549,
        D_delta_x_1_by_b_2_y*t557 + D_delta_x_3_by_b_2_y*t551 + D_delta_y_1_by_b_2_y*t558
        + D_delta_y_3_by_b_2_y*t553 + D_delta_z_1_by_b_2_y*t559 + D_delta_z_3_by_b_2_y*t555
        + mu_1_by_b_2_y*t556 + mu_2_by_b_2_y*t556 + mu_3_by_b_2_y*t556,
        D_delta_x_1_by_b_2_y*k_C, D_delta_y_1_by_b_2_y*k_C, D_delta_z_1_by_b_2_y*k_C,
        D_delta_x_2_by_b_2_y*t561 + D_delta_y_2_by_b_2_y*t562 + D_delta_z_2_by_b_2_y*t563
        - mu_1_by_b_2_y*t560 + mu_2_by_b_2_y*t564 - mu_3_by_b_2_y*t560,
        D_delta_x_2_by_b_2_y*t557 + D_delta_x_3_by_b_2_y*t550 + D_delta_y_2_by_b_2_y*t558
        + D_delta_y_3_by_b_2_y*t552 + D_delta_z_2_by_b_2_y*t559 + D_delta_z_3_by_b_2_y*t554
        + mu_1_by_b_2_y*t565 + mu_2_by_b_2_y*t565 + mu_3_by_b_2_y*t565,
        D_delta_x_2_by_b_2_y*k_C, D_delta_y_2_by_b_2_y*k_C, D_delta_z_2_by_b_2_y*k_C,
        D_delta_x_3_by_b_2_y*t567 + D_delta_y_3_by_b_2_y*t568 + D_delta_z_3_by_b_2_y*t569
        - mu_1_by_b_2_y*t566 - mu_2_by_b_2_y*t566 + mu_3_by_b_2_y*t570,
        D_delta_x_3_by_b_2_y*k_C, D_delta_y_3_by_b_2_y*k_C, D_delta_z_3_by_b_2_y*k_C,
        2*D_p_x_1*D_p_x_1_by_b_2_z*k_C - D_p_x_1_by_b_2_z*t427 + 2*D_p_y_1*D_p_y_1_by_b_2_z*k_C
        - D_p_y_1_by_b_2_z*t430 + 2*D_p_z_1*D_p_z_1_by_b_2_z*k_C - D_p_z_1_by_b_2_z*t433
        + mu_1_by_b_2_z*t443 + mu_2_by_b_2_z*t435 + mu_3_by_b_2_z*t435 - t412*t653 - t413*t653 - t416*t654
        - t417*t654 - t420*t655 - t421*t655,
        D_p_x_1*D_p_x_2_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_2*k_C - D_p_x_1_by_b_2_z*t444
        - D_p_x_1_by_b_2_z*t445 - D_p_x_1_by_b_2_z*t450 - D_p_x_2_by_b_2_z*t413 - D_p_x_2_by_b_2_z*t426
        + D_p_y_1*D_p_y_2_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_2*k_C - D_p_y_1_by_b_2_z*t446
        - D_p_y_1_by_b_2_z*t447 - D_p_y_1_by_b_2_z*t451 - D_p_y_2_by_b_2_z*t417 - D_p_y_2_by_b_2_z*t429
        + D_p_z_1*D_p_z_2_by_b_2_z*k_C + D_p_z_1_by_b_2_z*D_p_z_2*k_C - D_p_z_1_by_b_2_z*t448
        - D_p_z_1_by_b_2_z*t449 - D_p_z_1_by_b_2_z*t452 - D_p_z_2_by_b_2_z*t421 - D_p_z_2_by_b_2_z*t432
        + mu_1_by_b_2_z*t453 + mu_2_by_b_2_z*t454 + mu_3_by_b_2_z*t455 - t412*t656 - t416*t657 - t420*t658,
        D_p_x_1*D_p_x_3_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_3*k_C - D_p_x_1_by_b_2_z*t456
        - D_p_x_1_by_b_2_z*t457 - D_p_x_1_by_b_2_z*t462 - D_p_x_3_by_b_2_z*t412 - D_p_x_3_by_b_2_z*t413
        - D_p_x_3_by_b_2_z*t426 + D_p_y_1*D_p_y_3_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_3*k_C
        - D_p_y_1_by_b_2_z*t458 - D_p_y_1_by_b_2_z*t459 - D_p_y_1_by_b_2_z*t463 - D_p_y_3_by_b_2_z*t416
        - D_p_y_3_by_b_2_z*t417 - D_p_y_3_by_b_2_z*t429 + D_p_z_1*D_p_z_3_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_3*k_C - D_p_z_1_by_b_2_z*t460 - D_p_z_1_by_b_2_z*t461
        - D_p_z_1_by_b_2_z*t464 - D_p_z_3_by_b_2_z*t420 - D_p_z_3_by_b_2_z*t421 - D_p_z_3_by_b_2_z*t432
        + mu_1_by_b_2_z*t465 + mu_2_by_b_2_z*t466 + mu_3_by_b_2_z*t467,
        D_delta_x_1_by_b_2_z*t482 + D_delta_y_1_by_b_2_z*t483 + D_delta_z_1_by_b_2_z*t484
        - D_p_x_1_by_b_2_z*t471 - D_p_x_1_by_b_2_z*t472 - D_p_x_1_by_b_2_z*t477 + D_p_x_1_by_b_2_z*t580
        - D_p_y_1_by_b_2_z*t473 - D_p_y_1_by_b_2_z*t474 - D_p_y_1_by_b_2_z*t478 + D_p_y_1_by_b_2_z*t581
        - D_p_z_1_by_b_2_z*t475 - D_p_z_1_by_b_2_z*t476 - D_p_z_1_by_b_2_z*t479 + D_p_z_1_by_b_2_z*t582
        + mu_1_by_b_2_z*t480 + mu_2_by_b_2_z*t481 + mu_3_by_b_2_z*t481,
        D_delta_x_2_by_b_2_z*t482 + D_delta_y_2_by_b_2_z*t483 + D_delta_z_2_by_b_2_z*t484
        - D_p_x_1_by_b_2_z*t485 - D_p_x_1_by_b_2_z*t486 - D_p_x_1_by_b_2_z*t491 + D_p_x_1_by_b_2_z*t583
        - D_p_y_1_by_b_2_z*t487 - D_p_y_1_by_b_2_z*t488 - D_p_y_1_by_b_2_z*t492 + D_p_y_1_by_b_2_z*t584
        - D_p_z_1_by_b_2_z*t489 - D_p_z_1_by_b_2_z*t490 - D_p_z_1_by_b_2_z*t493 + D_p_z_1_by_b_2_z*t585
        + mu_1_by_b_2_z*t494 + mu_2_by_b_2_z*t495 + mu_3_by_b_2_z*t495,
        D_delta_x_3_by_b_2_z*t482 + D_delta_y_3_by_b_2_z*t483 + D_delta_z_3_by_b_2_z*t484
        - D_p_x_1_by_b_2_z*t496 - D_p_x_1_by_b_2_z*t497 - D_p_x_1_by_b_2_z*t502 + D_p_x_1_by_b_2_z*t586
        - D_p_y_1_by_b_2_z*t498 - D_p_y_1_by_b_2_z*t499 - D_p_y_1_by_b_2_z*t503 + D_p_y_1_by_b_2_z*t587
        - D_p_z_1_by_b_2_z*t500 - D_p_z_1_by_b_2_z*t501 - D_p_z_1_by_b_2_z*t504 + D_p_z_1_by_b_2_z*t588
        + mu_1_by_b_2_z*t505 + mu_2_by_b_2_z*t506 + mu_3_by_b_2_z*t506,
        D_p_x_1_by_b_2_z*k_C, D_p_y_1_by_b_2_z*k_C, D_p_z_1_by_b_2_z*k_C,
        mu_1_by_b_2_z*t510 + mu_2_by_b_2_z*t511 + mu_3_by_b_2_z*t510 - s_2_z_by_b_2_z*t663 - t444*t659
        - t446*t660 - t448*t661 - t450*t659 - t451*t660 - t452*t661 + t615*t659 + t617*t660 + t619*t661
        + t622*t662 - t624*t656 - t625*t657 - t626*t658 + t630*theta_2_by_b_2_z + t632*theta_2_by_b_2_z
        + t634*theta_2_by_b_2_z + t648*t662,
        D_p_x_2*D_p_x_3_by_b_2_z*k_C + D_p_x_2_by_b_2_z*D_p_x_3*k_C - D_p_x_2_by_b_2_z*t457
        - D_p_x_2_by_b_2_z*t462 - D_p_x_3_by_b_2_z*t444 - D_p_x_3_by_b_2_z*t445 - D_p_x_3_by_b_2_z*t450
        + D_p_y_2*D_p_y_3_by_b_2_z*k_C + D_p_y_2_by_b_2_z*D_p_y_3*k_C - D_p_y_2_by_b_2_z*t459
        - D_p_y_2_by_b_2_z*t463 - D_p_y_3_by_b_2_z*t446 - D_p_y_3_by_b_2_z*t447 - D_p_y_3_by_b_2_z*t451
        + D_p_z_2*D_p_z_3_by_b_2_z*k_C + D_p_z_2_by_b_2_z*D_p_z_3*k_C - D_p_z_2_by_b_2_z*t461
        - D_p_z_2_by_b_2_z*t464 - D_p_z_3_by_b_2_z*t448 - D_p_z_3_by_b_2_z*t449 - D_p_z_3_by_b_2_z*t452
        + mu_1_by_b_2_z*t512 + mu_2_by_b_2_z*t513 + mu_3_by_b_2_z*t514 - t456*t656 - t458*t657 - t460*t658,
        D_delta_x_1_by_b_2_z*t520 + D_delta_y_1_by_b_2_z*t521 + D_delta_z_1_by_b_2_z*t522
        - D_p_x_2_by_b_2_z*t472 - D_p_x_2_by_b_2_z*t477 + D_p_x_2_by_b_2_z*t580 - D_p_y_2_by_b_2_z*t474
        - D_p_y_2_by_b_2_z*t478 + D_p_y_2_by_b_2_z*t581 - D_p_z_2_by_b_2_z*t476 - D_p_z_2_by_b_2_z*t479
        + D_p_z_2_by_b_2_z*t582 + mu_1_by_b_2_z*t518 + mu_2_by_b_2_z*t519 + mu_3_by_b_2_z*t518 - t471*t656
        - t473*t657 - t475*t658,
        D_delta_x_2_by_b_2_z*t520 + D_delta_y_2_by_b_2_z*t521 + D_delta_z_2_by_b_2_z*t522
        - D_p_x_2_by_b_2_z*t486 - D_p_x_2_by_b_2_z*t491 + D_p_x_2_by_b_2_z*t583 - D_p_y_2_by_b_2_z*t488
        - D_p_y_2_by_b_2_z*t492 + D_p_y_2_by_b_2_z*t584 - D_p_z_2_by_b_2_z*t490 - D_p_z_2_by_b_2_z*t493
        + D_p_z_2_by_b_2_z*t585 + mu_1_by_b_2_z*t523 + mu_2_by_b_2_z*t524 + mu_3_by_b_2_z*t523 - t485*t656
        - t487*t657 - t489*t658,
        D_delta_x_3_by_b_2_z*t520 + D_delta_y_3_by_b_2_z*t521 + D_delta_z_3_by_b_2_z*t522
        - D_p_x_2_by_b_2_z*t497 - D_p_x_2_by_b_2_z*t502 + D_p_x_2_by_b_2_z*t586 - D_p_y_2_by_b_2_z*t499
        - D_p_y_2_by_b_2_z*t503 + D_p_y_2_by_b_2_z*t587 - D_p_z_2_by_b_2_z*t501 - D_p_z_2_by_b_2_z*t504
        + D_p_z_2_by_b_2_z*t588 + mu_1_by_b_2_z*t525 + mu_2_by_b_2_z*t526 + mu_3_by_b_2_z*t525 - t496*t656
        - t498*t657 - t500*t658,
        D_p_x_2_by_b_2_z*k_C, D_p_y_2_by_b_2_z*k_C, D_p_z_2_by_b_2_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_z*k_C
        + mu_1_by_b_2_z*t530 + mu_2_by_b_2_z*t530 + mu_3_by_b_2_z*t531 - t456*t664 - t457*t664 - t458*t665
        - t459*t665 - t460*t666 - t461*t666 - t462*t664 - t463*t665 - t464*t666,
        D_delta_x_1_by_b_2_z*t537 + D_delta_y_1_by_b_2_z*t538 + D_delta_z_1_by_b_2_z*t539
        - D_p_x_3_by_b_2_z*t471 - D_p_x_3_by_b_2_z*t472 - D_p_x_3_by_b_2_z*t477 + D_p_x_3_by_b_2_z*t580
        - D_p_y_3_by_b_2_z*t473 - D_p_y_3_by_b_2_z*t474 - D_p_y_3_by_b_2_z*t478 + D_p_y_3_by_b_2_z*t581
        - D_p_z_3_by_b_2_z*t475 - D_p_z_3_by_b_2_z*t476 - D_p_z_3_by_b_2_z*t479 + D_p_z_3_by_b_2_z*t582
        + mu_1_by_b_2_z*t535 + mu_2_by_b_2_z*t535 + mu_3_by_b_2_z*t536,
        D_delta_x_2_by_b_2_z*t537 + D_delta_y_2_by_b_2_z*t538 + D_delta_z_2_by_b_2_z*t539
        - D_p_x_3_by_b_2_z*t485 - D_p_x_3_by_b_2_z*t486 - D_p_x_3_by_b_2_z*t491 + D_p_x_3_by_b_2_z*t583
        - D_p_y_3_by_b_2_z*t487 - D_p_y_3_by_b_2_z*t488 - D_p_y_3_by_b_2_z*t492 + D_p_y_3_by_b_2_z*t584
        - D_p_z_3_by_b_2_z*t489 - D_p_z_3_by_b_2_z*t490 - D_p_z_3_by_b_2_z*t493 + D_p_z_3_by_b_2_z*t585
        + mu_1_by_b_2_z*t540 + mu_2_by_b_2_z*t540 + mu_3_by_b_2_z*t541,
        D_delta_x_3_by_b_2_z*t537 + D_delta_y_3_by_b_2_z*t538 + D_delta_z_3_by_b_2_z*t539
        - D_p_x_3_by_b_2_z*t496 - D_p_x_3_by_b_2_z*t497 - D_p_x_3_by_b_2_z*t502 + D_p_x_3_by_b_2_z*t586
        - D_p_y_3_by_b_2_z*t498 - D_p_y_3_by_b_2_z*t499 - D_p_y_3_by_b_2_z*t503 + D_p_y_3_by_b_2_z*t587
        - D_p_z_3_by_b_2_z*t500 - D_p_z_3_by_b_2_z*t501 - D_p_z_3_by_b_2_z*t504 + D_p_z_3_by_b_2_z*t588
        + mu_1_by_b_2_z*t542 + mu_2_by_b_2_z*t542 + mu_3_by_b_2_z*t543,
        D_p_x_3_by_b_2_z*k_C, D_p_y_3_by_b_2_z*k_C, D_p_z_3_by_b_2_z*k_C,
        D_delta_x_1_by_b_2_z*t545 + D_delta_y_1_by_b_2_z*t546 + D_delta_z_1_by_b_2_z*t547
        + mu_1_by_b_2_z*t548 - mu_2_by_b_2_z*t544 - mu_3_by_b_2_z*t544,
        D_delta_x_1_by_b_2_z*t550 + D_delta_x_2_by_b_2_z*t551 + D_delta_y_1_by_b_2_z*t552
        + D_delta_y_2_by_b_2_z*t553 + D_delta_z_1_by_b_2_z*t554 + D_delta_z_2_by_b_2_z*t555
        + mu_1_by_b_2_z*t549 + mu_2_by_b_2_z*t549 + mu_3_by_b_2_z*t549,
        D_delta_x_1_by_b_2_z*t557 + D_delta_x_3_by_b_2_z*t551 + D_delta_y_1_by_b_2_z*t558
        + D_delta_y_3_by_b_2_z*t553 + D_delta_z_1_by_b_2_z*t559 + D_delta_z_3_by_b_2_z*t555
        + mu_1_by_b_2_z*t556 + mu_2_by_b_2_z*t556 + mu_3_by_b_2_z*t556,
        D_delta_x_1_by_b_2_z*k_C, D_delta_y_1_by_b_2_z*k_C, D_delta_z_1_by_b_2_z*k_C,
        D_delta_x_2_by_b_2_z*t561 + D_delta_y_2_by_b_2_z*t562 + D_delta_z_2_by_b_2_z*t563
        - mu_1_by_b_2_z*t560 + mu_2_by_b_2_z*t564 - mu_3_by_b_2_z*t560,
        D_delta_x_2_by_b_2_z*t557 + D_delta_x_3_by_b_2_z*t550 + D_delta_y_2_by_b_2_z*t558
        + D_delta_y_3_by_b_2_z*t552 + D_delta_z_2_by_b_2_z*t559 + D_delta_z_3_by_b_2_z*t554
        + mu_1_by_b_2_z*t565 + mu_2_by_b_2_z*t565 + mu_3_by_b_2_z*t565,
        D_delta_x_2_by_b_2_z*k_C, D_delta_y_2_by_b_2_z*k_C, D_delta_z_2_by_b_2_z*k_C,
        D_delta_x_3_by_b_2_z*t567 + D_delta_y_3_by_b_2_z*t568 + D_delta_z_3_by_b_2_z*t569
        - mu_1_by_b_2_z*t566 - mu_2_by_b_2_z*t566 + mu_3_by_b_2_z*t570,
        D_delta_x_3_by_b_2_z*k_C, D_delta_y_3_by_b_2_z*k_C, D_delta_z_3_by_b_2_z*k_C,
        2*D_p_x_1*D_p_x_1_by_b_3_x*k_C - D_p_x_1_by_b_3_x*t427 + 2*D_p_y_1*D_p_y_1_by_b_3_x*k_C
        - D_p_y_1_by_b_3_x*t430 + 2*D_p_z_1*D_p_z_1_by_b_3_x*k_C - D_p_z_1_by_b_3_x*t433
        + mu_1_by_b_3_x*t443 + mu_2_by_b_3_x*t435 + mu_3_by_b_3_x*t435 - t412*t667 - t413*t667 - t416*t668
        - t417*t668 - t420*t669 - t421*t669,
        D_p_x_1*D_p_x_2_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_2*k_C - D_p_x_1_by_b_3_x*t444
        - D_p_x_1_by_b_3_x*t445 - D_p_x_1_by_b_3_x*t450 - D_p_x_2_by_b_3_x*t412 - D_p_x_2_by_b_3_x*t413
        - D_p_x_2_by_b_3_x*t426 + D_p_y_1*D_p_y_2_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_2*k_C
        - D_p_y_1_by_b_3_x*t446 - D_p_y_1_by_b_3_x*t447 - D_p_y_1_by_b_3_x*t451 - D_p_y_2_by_b_3_x*t416
        - D_p_y_2_by_b_3_x*t417 - D_p_y_2_by_b_3_x*t429 + D_p_z_1*D_p_z_2_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_2*k_C - D_p_z_1_by_b_3_x*t448 - D_p_z_1_by_b_3_x*t449
        - D_p_z_1_by_b_3_x*t452 - D_p_z_2_by_b_3_x*t420 - D_p_z_2_by_b_3_x*t421 - D_p_z_2_by_b_3_x*t432
        + mu_1_by_b_3_x*t453 + mu_2_by_b_3_x*t454 + mu_3_by_b_3_x*t455,
        D_p_x_1*D_p_x_3_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_3*k_C - D_p_x_1_by_b_3_x*t456
        - D_p_x_1_by_b_3_x*t457 - D_p_x_1_by_b_3_x*t462 - D_p_x_3_by_b_3_x*t412 - D_p_x_3_by_b_3_x*t426
        + D_p_y_1*D_p_y_3_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_3*k_C - D_p_y_1_by_b_3_x*t458
        - D_p_y_1_by_b_3_x*t459 - D_p_y_1_by_b_3_x*t463 - D_p_y_3_by_b_3_x*t416 - D_p_y_3_by_b_3_x*t429
        + D_p_z_1*D_p_z_3_by_b_3_x*k_C + D_p_z_1_by_b_3_x*D_p_z_3*k_C - D_p_z_1_by_b_3_x*t460
        - D_p_z_1_by_b_3_x*t461 - D_p_z_1_by_b_3_x*t464 - D_p_z_3_by_b_3_x*t420 - D_p_z_3_by_b_3_x*t432
        + mu_1_by_b_3_x*t465 + mu_2_by_b_3_x*t466 + mu_3_by_b_3_x*t467 - t413*t670 - t417*t671 - t421*t672,
        D_delta_x_1_by_b_3_x*t482 + D_delta_y_1_by_b_3_x*t483 + D_delta_z_1_by_b_3_x*t484
        - D_p_x_1_by_b_3_x*t471 - D_p_x_1_by_b_3_x*t472 - D_p_x_1_by_b_3_x*t477 + D_p_x_1_by_b_3_x*t580
        - D_p_y_1_by_b_3_x*t473 - D_p_y_1_by_b_3_x*t474 - D_p_y_1_by_b_3_x*t478 + D_p_y_1_by_b_3_x*t581
        - D_p_z_1_by_b_3_x*t475 - D_p_z_1_by_b_3_x*t476 - D_p_z_1_by_b_3_x*t479 + D_p_z_1_by_b_3_x*t582
        + mu_1_by_b_3_x*t480 + mu_2_by_b_3_x*t481 + mu_3_by_b_3_x*t481,
        D_delta_x_2_by_b_3_x*t482 + D_delta_y_2_by_b_3_x*t483 + D_delta_z_2_by_b_3_x*t484
        - D_p_x_1_by_b_3_x*t485 - D_p_x_1_by_b_3_x*t486 - D_p_x_1_by_b_3_x*t491 + D_p_x_1_by_b_3_x*t583
        - D_p_y_1_by_b_3_x*t487 - D_p_y_1_by_b_3_x*t488 - D_p_y_1_by_b_3_x*t492 + D_p_y_1_by_b_3_x*t584
        - D_p_z_1_by_b_3_x*t489 - D_p_z_1_by_b_3_x*t490 - D_p_z_1_by_b_3_x*t493 + D_p_z_1_by_b_3_x*t585
        + mu_1_by_b_3_x*t494 + mu_2_by_b_3_x*t495 + mu_3_by_b_3_x*t495,
        D_delta_x_3_by_b_3_x*t482 + D_delta_y_3_by_b_3_x*t483 + D_delta_z_3_by_b_3_x*t484
        - D_p_x_1_by_b_3_x*t496 - D_p_x_1_by_b_3_x*t497 - D_p_x_1_by_b_3_x*t502 + D_p_x_1_by_b_3_x*t586
        - D_p_y_1_by_b_3_x*t498 - D_p_y_1_by_b_3_x*t499 - D_p_y_1_by_b_3_x*t503 + D_p_y_1_by_b_3_x*t587
        - D_p_z_1_by_b_3_x*t500 - D_p_z_1_by_b_3_x*t501 - D_p_z_1_by_b_3_x*t504 + D_p_z_1_by_b_3_x*t588
        + mu_1_by_b_3_x*t505 + mu_2_by_b_3_x*t506 + mu_3_by_b_3_x*t506,
        D_p_x_1_by_b_3_x*k_C, D_p_y_1_by_b_3_x*k_C, D_p_z_1_by_b_3_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_x*k_C - D_p_x_2_by_b_3_x*t624 + 2*D_p_y_2*D_p_y_2_by_b_3_x*k_C
        - D_p_y_2_by_b_3_x*t625 + 2*D_p_z_2*D_p_z_2_by_b_3_x*k_C - D_p_z_2_by_b_3_x*t626
        + mu_1_by_b_3_x*t510 + mu_2_by_b_3_x*t511 + mu_3_by_b_3_x*t510 - t444*t673 - t446*t674 - t448*t675
        - t450*t673 - t451*t674 - t452*t675,
        D_p_x_2*D_p_x_3_by_b_3_x*k_C + D_p_x_2_by_b_3_x*D_p_x_3*k_C - D_p_x_2_by_b_3_x*t456
        - D_p_x_2_by_b_3_x*t457 - D_p_x_2_by_b_3_x*t462 - D_p_x_3_by_b_3_x*t445 - D_p_x_3_by_b_3_x*t450
        + D_p_y_2*D_p_y_3_by_b_3_x*k_C + D_p_y_2_by_b_3_x*D_p_y_3*k_C - D_p_y_2_by_b_3_x*t458
        - D_p_y_2_by_b_3_x*t459 - D_p_y_2_by_b_3_x*t463 - D_p_y_3_by_b_3_x*t447 - D_p_y_3_by_b_3_x*t451
        + D_p_z_2*D_p_z_3_by_b_3_x*k_C + D_p_z_2_by_b_3_x*D_p_z_3*k_C - D_p_z_2_by_b_3_x*t460
        - D_p_z_2_by_b_3_x*t461 - D_p_z_2_by_b_3_x*t464 - D_p_z_3_by_b_3_x*t449 - D_p_z_3_by_b_3_x*t452
        + mu_1_by_b_3_x*t512 + mu_2_by_b_3_x*t513 + mu_3_by_b_3_x*t514 - t444*t670 - t446*t671 - t448*t672,
        D_delta_x_1_by_b_3_x*t520 + D_delta_y_1_by_b_3_x*t521 + D_delta_z_1_by_b_3_x*t522
        - D_p_x_2_by_b_3_x*t471 - D_p_x_2_by_b_3_x*t472 - D_p_x_2_by_b_3_x*t477 + D_p_x_2_by_b_3_x*t580
        - D_p_y_2_by_b_3_x*t473 - D_p_y_2_by_b_3_x*t474 - D_p_y_2_by_b_3_x*t478 + D_p_y_2_by_b_3_x*t581
        - D_p_z_2_by_b_3_x*t475 - D_p_z_2_by_b_3_x*t476 - D_p_z_2_by_b_3_x*t479 + D_p_z_2_by_b_3_x*t582
        + mu_1_by_b_3_x*t518 + mu_2_by_b_3_x*t519 + mu_3_by_b_3_x*t518,
        D_delta_x_2_by_b_3_x*t520 + D_delta_y_2_by_b_3_x*t521 + D_delta_z_2_by_b_3_x*t522
        - D_p_x_2_by_b_3_x*t485 - D_p_x_2_by_b_3_x*t486 - D_p_x_2_by_b_3_x*t491 + D_p_x_2_by_b_3_x*t583
        - D_p_y_2_by_b_3_x*t487 - D_p_y_2_by_b_3_x*t488 - D_p_y_2_by_b_3_x*t492 + D_p_y_2_by_b_3_x*t584
        - D_p_z_2_by_b_3_x*t489 - D_p_z_2_by_b_3_x*t490 - D_p_z_2_by_b_3_x*t493 + D_p_z_2_by_b_3_x*t585
        + mu_1_by_b_3_x*t523 + mu_2_by_b_3_x*t524 + mu_3_by_b_3_x*t523,
        D_delta_x_3_by_b_3_x*t520 + D_delta_y_3_by_b_3_x*t521 + D_delta_z_3_by_b_3_x*t522
        - D_p_x_2_by_b_3_x*t496 - D_p_x_2_by_b_3_x*t497 - D_p_x_2_by_b_3_x*t502 + D_p_x_2_by_b_3_x*t586
        - D_p_y_2_by_b_3_x*t498 - D_p_y_2_by_b_3_x*t499 - D_p_y_2_by_b_3_x*t503 + D_p_y_2_by_b_3_x*t587
        - D_p_z_2_by_b_3_x*t500 - D_p_z_2_by_b_3_x*t501 - D_p_z_2_by_b_3_x*t504 + D_p_z_2_by_b_3_x*t588
        + mu_1_by_b_3_x*t525 + mu_2_by_b_3_x*t526 + mu_3_by_b_3_x*t525,
        D_p_x_2_by_b_3_x*k_C, D_p_y_2_by_b_3_x*k_C, D_p_z_2_by_b_3_x*k_C,
        mu_1_by_b_3_x*t530 + mu_2_by_b_3_x*t530 + mu_3_by_b_3_x*t531 - s_3_x_by_b_3_x*t688 - t456*t677
        - t458*t679 - t460*t681 - t462*t677 - t463*t679 - t464*t681 - t670*t685 - t671*t686 - t672*t687
        + t676*t677 + t678*t679 + t680*t681 + t682*t683 + t682*t684 + t691*theta_3_by_b_3_x
        + t693*theta_3_by_b_3_x + t695*theta_3_by_b_3_x,
        D_delta_x_1_by_b_3_x*t537 + D_delta_y_1_by_b_3_x*t538 + D_delta_z_1_by_b_3_x*t539
        - D_p_x_3_by_b_3_x*t471 - D_p_x_3_by_b_3_x*t477 + D_p_x_3_by_b_3_x*t580 - D_p_y_3_by_b_3_x*t473
        - D_p_y_3_by_b_3_x*t478 + D_p_y_3_by_b_3_x*t581 - D_p_z_3_by_b_3_x*t475 - D_p_z_3_by_b_3_x*t479
        + D_p_z_3_by_b_3_x*t582 + mu_1_by_b_3_x*t535 + mu_2_by_b_3_x*t535 + mu_3_by_b_3_x*t536 - t472*t670
        - t474*t671 - t476*t672,
        D_delta_x_2_by_b_3_x*t537 + D_delta_y_2_by_b_3_x*t538 + D_delta_z_2_by_b_3_x*t539
        - D_p_x_3_by_b_3_x*t485 - D_p_x_3_by_b_3_x*t491 + D_p_x_3_by_b_3_x*t583 - D_p_y_3_by_b_3_x*t487
        - D_p_y_3_by_b_3_x*t492 + D_p_y_3_by_b_3_x*t584 - D_p_z_3_by_b_3_x*t489 - D_p_z_3_by_b_3_x*t493
        + D_p_z_3_by_b_3_x*t585 + mu_1_by_b_3_x*t540 + mu_2_by_b_3_x*t540 + mu_3_by_b_3_x*t541 - t486*t670
        - t488*t671 - t490*t672,
        D_delta_x_3_by_b_3_x*t537 + D_delta_y_3_by_b_3_x*t538 + D_delta_z_3_by_b_3_x*t539
        - D_p_x_3_by_b_3_x*t496 - D_p_x_3_by_b_3_x*t502 + D_p_x_3_by_b_3_x*t586 - D_p_y_3_by_b_3_x*t498
        - D_p_y_3_by_b_3_x*t503 + D_p_y_3_by_b_3_x*t587 - D_p_z_3_by_b_3_x*t500 - D_p_z_3_by_b_3_x*t504
        + D_p_z_3_by_b_3_x*t588 + mu_1_by_b_3_x*t542 + mu_2_by_b_3_x*t542 + mu_3_by_b_3_x*t543 - t497*t670
        - t499*t671 - t501*t672,
        D_p_x_3_by_b_3_x*k_C, D_p_y_3_by_b_3_x*k_C, D_p_z_3_by_b_3_x*k_C,
        D_delta_x_1_by_b_3_x*t545 + D_delta_y_1_by_b_3_x*t546 + D_delta_z_1_by_b_3_x*t547
        + mu_1_by_b_3_x*t548 - mu_2_by_b_3_x*t544 - mu_3_by_b_3_x*t544,
        D_delta_x_1_by_b_3_x*t550 + D_delta_x_2_by_b_3_x*t551 + D_delta_y_1_by_b_3_x*t552
        + D_delta_y_2_by_b_3_x*t553 + D_delta_z_1_by_b_3_x*t554 + D_delta_z_2_by_b_3_x*t555
        + mu_1_by_b_3_x*t549 + mu_2_by_b_3_x*t549 + mu_3_by_b_3_x*t549,
        D_delta_x_1_by_b_3_x*t557 + D_delta_x_3_by_b_3_x*t551 + D_delta_y_1_by_b_3_x*t558
        + D_delta_y_3_by_b_3_x*t553 + D_delta_z_1_by_b_3_x*t559 + D_delta_z_3_by_b_3_x*t555
        + mu_1_by_b_3_x*t556 + mu_2_by_b_3_x*t556 + mu_3_by_b_3_x*t556,
        D_delta_x_1_by_b_3_x*k_C, D_delta_y_1_by_b_3_x*k_C, D_delta_z_1_by_b_3_x*k_C,
        D_delta_x_2_by_b_3_x*t561 + D_delta_y_2_by_b_3_x*t562 + D_delta_z_2_by_b_3_x*t563
        - mu_1_by_b_3_x*t560 + mu_2_by_b_3_x*t564 - mu_3_by_b_3_x*t560,
        D_delta_x_2_by_b_3_x*t557 + D_delta_x_3_by_b_3_x*t550 + D_delta_y_2_by_b_3_x*t558
        + D_delta_y_3_by_b_3_x*t552 + D_delta_z_2_by_b_3_x*t559 + D_delta_z_3_by_b_3_x*t554
        + mu_1_by_b_3_x*t565 + mu_2_by_b_3_x*t565 + mu_3_by_b_3_x*t565,
        D_delta_x_2_by_b_3_x*k_C, D_delta_y_2_by_b_3_x*k_C, D_delta_z_2_by_b_3_x*k_C,
        D_delta_x_3_by_b_3_x*t567 + D_delta_y_3_by_b_3_x*t568 + D_delta_z_3_by_b_3_x*t569
        - mu_1_by_b_3_x*t566 - mu_2_by_b_3_x*t566 + mu_3_by_b_3_x*t570,
        D_delta_x_3_by_b_3_x*k_C, D_delta_y_3_by_b_3_x*k_C, D_delta_z_3_by_b_3_x*k_C,
        2*D_p_x_1*D_p_x_1_by_b_3_y*k_C - D_p_x_1_by_b_3_y*t427 + 2*D_p_y_1*D_p_y_1_by_b_3_y*k_C
        - D_p_y_1_by_b_3_y*t430 + 2*D_p_z_1*D_p_z_1_by_b_3_y*k_C - D_p_z_1_by_b_3_y*t433
        + mu_1_by_b_3_y*t443 + mu_2_by_b_3_y*t435 + mu_3_by_b_3_y*t435 - t412*t696 - t413*t696 - t416*t697
        - t417*t697 - t420*t698 - t421*t698,
        D_p_x_1*D_p_x_2_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_2*k_C - D_p_x_1_by_b_3_y*t444
        - D_p_x_1_by_b_3_y*t445 - D_p_x_1_by_b_3_y*t450 - D_p_x_2_by_b_3_y*t412 - D_p_x_2_by_b_3_y*t413
        - D_p_x_2_by_b_3_y*t426 + D_p_y_1*D_p_y_2_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_2*k_C
        - D_p_y_1_by_b_3_y*t446 - D_p_y_1_by_b_3_y*t447 - D_p_y_1_by_b_3_y*t451 - D_p_y_2_by_b_3_y*t416
        - D_p_y_2_by_b_3_y*t417 - D_p_y_2_by_b_3_y*t429 + D_p_z_1*D_p_z_2_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_2*k_C - D_p_z_1_by_b_3_y*t448 - D_p_z_1_by_b_3_y*t449
        - D_p_z_1_by_b_3_y*t452 - D_p_z_2_by_b_3_y*t420 - D_p_z_2_by_b_3_y*t421 - D_p_z_2_by_b_3_y*t432
        + mu_1_by_b_3_y*t453 + mu_2_by_b_3_y*t454 + mu_3_by_b_3_y*t455,
        D_p_x_1*D_p_x_3_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_3*k_C - D_p_x_1_by_b_3_y*t456
        - D_p_x_1_by_b_3_y*t457 - D_p_x_1_by_b_3_y*t462 - D_p_x_3_by_b_3_y*t412 - D_p_x_3_by_b_3_y*t426
        + D_p_y_1*D_p_y_3_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_3*k_C - D_p_y_1_by_b_3_y*t458
        - D_p_y_1_by_b_3_y*t459 - D_p_y_1_by_b_3_y*t463 - D_p_y_3_by_b_3_y*t416 - D_p_y_3_by_b_3_y*t429
        + D_p_z_1*D_p_z_3_by_b_3_y*k_C + D_p_z_1_by_b_3_y*D_p_z_3*k_C - D_p_z_1_by_b_3_y*t460
        - D_p_z_1_by_b_3_y*t461 - D_p_z_1_by_b_3_y*t464 - D_p_z_3_by_b_3_y*t420 - D_p_z_3_by_b_3_y*t432
        + mu_1_by_b_3_y*t465 + mu_2_by_b_3_y*t466 + mu_3_by_b_3_y*t467 - t413*t699 - t417*t700 - t421*t701,
        D_delta_x_1_by_b_3_y*t482 + D_delta_y_1_by_b_3_y*t483 + D_delta_z_1_by_b_3_y*t484
        - D_p_x_1_by_b_3_y*t471 - D_p_x_1_by_b_3_y*t472 - D_p_x_1_by_b_3_y*t477 + D_p_x_1_by_b_3_y*t580
        - D_p_y_1_by_b_3_y*t473 - D_p_y_1_by_b_3_y*t474 - D_p_y_1_by_b_3_y*t478 + D_p_y_1_by_b_3_y*t581
        - D_p_z_1_by_b_3_y*t475 - D_p_z_1_by_b_3_y*t476 - D_p_z_1_by_b_3_y*t479 + D_p_z_1_by_b_3_y*t582
        + mu_1_by_b_3_y*t480 + mu_2_by_b_3_y*t481 + mu_3_by_b_3_y*t481,
        D_delta_x_2_by_b_3_y*t482 + D_delta_y_2_by_b_3_y*t483 + D_delta_z_2_by_b_3_y*t484
        - D_p_x_1_by_b_3_y*t485 - D_p_x_1_by_b_3_y*t486 - D_p_x_1_by_b_3_y*t491 + D_p_x_1_by_b_3_y*t583
        - D_p_y_1_by_b_3_y*t487 - D_p_y_1_by_b_3_y*t488 - D_p_y_1_by_b_3_y*t492 + D_p_y_1_by_b_3_y*t584
        - D_p_z_1_by_b_3_y*t489 - D_p_z_1_by_b_3_y*t490 - D_p_z_1_by_b_3_y*t493 + D_p_z_1_by_b_3_y*t585
        + mu_1_by_b_3_y*t494 + mu_2_by_b_3_y*t495 + mu_3_by_b_3_y*t495,
        D_delta_x_3_by_b_3_y*t482 + D_delta_y_3_by_b_3_y*t483 + D_delta_z_3_by_b_3_y*t484
        - D_p_x_1_by_b_3_y*t496 - D_p_x_1_by_b_3_y*t497 - D_p_x_1_by_b_3_y*t502 + D_p_x_1_by_b_3_y*t586
        - D_p_y_1_by_b_3_y*t498 - D_p_y_1_by_b_3_y*t499 - D_p_y_1_by_b_3_y*t503 + D_p_y_1_by_b_3_y*t587
        - D_p_z_1_by_b_3_y*t500 - D_p_z_1_by_b_3_y*t501 - D_p_z_1_by_b_3_y*t504 + D_p_z_1_by_b_3_y*t588
        + mu_1_by_b_3_y*t505 + mu_2_by_b_3_y*t506 + mu_3_by_b_3_y*t506,
        D_p_x_1_by_b_3_y*k_C, D_p_y_1_by_b_3_y*k_C, D_p_z_1_by_b_3_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_y*k_C - D_p_x_2_by_b_3_y*t624 + 2*D_p_y_2*D_p_y_2_by_b_3_y*k_C
        - D_p_y_2_by_b_3_y*t625 + 2*D_p_z_2*D_p_z_2_by_b_3_y*k_C - D_p_z_2_by_b_3_y*t626
        + mu_1_by_b_3_y*t510 + mu_2_by_b_3_y*t511 + mu_3_by_b_3_y*t510 - t444*t702 - t446*t703 - t448*t704
        - t450*t702 - t451*t703 - t452*t704,
        D_p_x_2*D_p_x_3_by_b_3_y*k_C + D_p_x_2_by_b_3_y*D_p_x_3*k_C - D_p_x_2_by_b_3_y*t456
        - D_p_x_2_by_b_3_y*t457 - D_p_x_2_by_b_3_y*t462 - D_p_x_3_by_b_3_y*t445 - D_p_x_3_by_b_3_y*t450
        + D_p_y_2*D_p_y_3_by_b_3_y*k_C + D_p_y_2_by_b_3_y*D_p_y_3*k_C - D_p_y_2_by_b_3_y*t458
        - D_p_y_2_by_b_3_y*t459 - D_p_y_2_by_b_3_y*t463 - D_p_y_3_by_b_3_y*t447 - D_p_y_3_by_b_3_y*t451
        + D_p_z_2*D_p_z_3_by_b_3_y*k_C + D_p_z_2_by_b_3_y*D_p_z_3*k_C - D_p_z_2_by_b_3_y*t460
        - D_p_z_2_by_b_3_y*t461 - D_p_z_2_by_b_3_y*t464 - D_p_z_3_by_b_3_y*t449 - D_p_z_3_by_b_3_y*t452
        + mu_1_by_b_3_y*t512 + mu_2_by_b_3_y*t513 + mu_3_by_b_3_y*t514 - t444*t699 - t446*t700 - t448*t701,
        D_delta_x_1_by_b_3_y*t520 + D_delta_y_1_by_b_3_y*t521 + D_delta_z_1_by_b_3_y*t522
        - D_p_x_2_by_b_3_y*t471 - D_p_x_2_by_b_3_y*t472 - D_p_x_2_by_b_3_y*t477 + D_p_x_2_by_b_3_y*t580
        - D_p_y_2_by_b_3_y*t473 - D_p_y_2_by_b_3_y*t474 - D_p_y_2_by_b_3_y*t478 + D_p_y_2_by_b_3_y*t581
        - D_p_z_2_by_b_3_y*t475 - D_p_z_2_by_b_3_y*t476 - D_p_z_2_by_b_3_y*t479 + D_p_z_2_by_b_3_y*t582
        + mu_1_by_b_3_y*t518 + mu_2_by_b_3_y*t519 + mu_3_by_b_3_y*t518,
        D_delta_x_2_by_b_3_y*t520 + D_delta_y_2_by_b_3_y*t521 + D_delta_z_2_by_b_3_y*t522
        - D_p_x_2_by_b_3_y*t485 - D_p_x_2_by_b_3_y*t486 - D_p_x_2_by_b_3_y*t491 + D_p_x_2_by_b_3_y*t583
        - D_p_y_2_by_b_3_y*t487 - D_p_y_2_by_b_3_y*t488 - D_p_y_2_by_b_3_y*t492 + D_p_y_2_by_b_3_y*t584
        - D_p_z_2_by_b_3_y*t489 - D_p_z_2_by_b_3_y*t490 - D_p_z_2_by_b_3_y*t493 + D_p_z_2_by_b_3_y*t585
        + mu_1_by_b_3_y*t523 + mu_2_by_b_3_y*t524 + mu_3_by_b_3_y*t523,
        D_delta_x_3_by_b_3_y*t520 + D_delta_y_3_by_b_3_y*t521 + D_delta_z_3_by_b_3_y*t522
        - D_p_x_2_by_b_3_y*t496 - D_p_x_2_by_b_3_y*t497 - D_p_x_2_by_b_3_y*t502 + D_p_x_2_by_b_3_y*t586
        - D_p_y_2_by_b_3_y*t498 - D_p_y_2_by_b_3_y*t499 - D_p_y_2_by_b_3_y*t503 + D_p_y_2_by_b_3_y*t587
        - D_p_z_2_by_b_3_y*t500 - D_p_z_2_by_b_3_y*t501 - D_p_z_2_by_b_3_y*t504 + D_p_z_2_by_b_3_y*t588
        + mu_1_by_b_3_y*t525 + mu_2_by_b_3_y*t526 + mu_3_by_b_3_y*t525,
        D_p_x_2_by_b_3_y*k_C, D_p_y_2_by_b_3_y*k_C, D_p_z_2_by_b_3_y*k_C,
        mu_1_by_b_3_y*t530 + mu_2_by_b_3_y*t530 + mu_3_by_b_3_y*t531 - s_3_y_by_b_3_y*t710 - t456*t705
        - t458*t706 - t460*t707 - t462*t705 - t463*t706 - t464*t707 + t676*t705 + t678*t706 + t680*t707
        + t684*t708 - t685*t699 - t686*t700 - t687*t701 + t691*theta_3_by_b_3_y + t693*theta_3_by_b_3_y
        + t695*theta_3_by_b_3_y + t708*t709,
        D_delta_x_1_by_b_3_y*t537 + D_delta_y_1_by_b_3_y*t538 + D_delta_z_1_by_b_3_y*t539
        - D_p_x_3_by_b_3_y*t471 - D_p_x_3_by_b_3_y*t477 + D_p_x_3_by_b_3_y*t580 - D_p_y_3_by_b_3_y*t473
        - D_p_y_3_by_b_3_y*t478 + D_p_y_3_by_b_3_y*t581 - D_p_z_3_by_b_3_y*t475 - D_p_z_3_by_b_3_y*t479
        + D_p_z_3_by_b_3_y*t582 + mu_1_by_b_3_y*t535 + mu_2_by_b_3_y*t535 + mu_3_by_b_3_y*t536 - t472*t699
        - t474*t700 - t476*t701,
        D_delta_x_2_by_b_3_y*t537 + D_delta_y_2_by_b_3_y*t538 + D_delta_z_2_by_b_3_y*t539
        - D_p_x_3_by_b_3_y*t485 - D_p_x_3_by_b_3_y*t491 + D_p_x_3_by_b_3_y*t583 - D_p_y_3_by_b_3_y*t487
        - D_p_y_3_by_b_3_y*t492 + D_p_y_3_by_b_3_y*t584 - D_p_z_3_by_b_3_y*t489 - D_p_z_3_by_b_3_y*t493
        + D_p_z_3_by_b_3_y*t585 + mu_1_by_b_3_y*t540 + mu_2_by_b_3_y*t540 + mu_3_by_b_3_y*t541 - t486*t699
        - t488*t700 - t490*t701,
        D_delta_x_3_by_b_3_y*t537 + D_delta_y_3_by_b_3_y*t538 + D_delta_z_3_by_b_3_y*t539
        - D_p_x_3_by_b_3_y*t496 - D_p_x_3_by_b_3_y*t502 + D_p_x_3_by_b_3_y*t586 - D_p_y_3_by_b_3_y*t498
        - D_p_y_3_by_b_3_y*t503 + D_p_y_3_by_b_3_y*t587 - D_p_z_3_by_b_3_y*t500 - D_p_z_3_by_b_3_y*t504
        + D_p_z_3_by_b_3_y*t588 + mu_1_by_b_3_y*t542 + mu_2_by_b_3_y*t542 + mu_3_by_b_3_y*t543 - t497*t699
        - t499*t700 - t501*t701,
        D_p_x_3_by_b_3_y*k_C, D_p_y_3_by_b_3_y*k_C, D_p_z_3_by_b_3_y*k_C,
        D_delta_x_1_by_b_3_y*t545 + D_delta_y_1_by_b_3_y*t546 + D_delta_z_1_by_b_3_y*t547
        + mu_1_by_b_3_y*t548 - mu_2_by_b_3_y*t544 - mu_3_by_b_3_y*t544,
        D_delta_x_1_by_b_3_y*t550 + D_delta_x_2_by_b_3_y*t551 + D_delta_y_1_by_b_3_y*t552
        + D_delta_y_2_by_b_3_y*t553 + D_delta_z_1_by_b_3_y*t554 + D_delta_z_2_by_b_3_y*t555
        + mu_1_by_b_3_y*t549 + mu_2_by_b_3_y*t549 + mu_3_by_b_3_y*t549,
        D_delta_x_1_by_b_3_y*t557 + D_delta_x_3_by_b_3_y*t551 + D_delta_y_1_by_b_3_y*t558
        + D_delta_y_3_by_b_3_y*t553 + D_delta_z_1_by_b_3_y*t559 + D_delta_z_3_by_b_3_y*t555
        + mu_1_by_b_3_y*t556 + mu_2_by_b_3_y*t556 + mu_3_by_b_3_y*t556,
        D_delta_x_1_by_b_3_y*k_C, D_delta_y_1_by_b_3_y*k_C, D_delta_z_1_by_b_3_y*k_C,
        D_delta_x_2_by_b_3_y*t561 + D_delta_y_2_by_b_3_y*t562 + D_delta_z_2_by_b_3_y*t563
        - mu_1_by_b_3_y*t560 + mu_2_by_b_3_y*t564 - mu_3_by_b_3_y*t560,
        D_delta_x_2_by_b_3_y*t557 + D_delta_x_3_by_b_3_y*t550 + D_delta_y_2_by_b_3_y*t558
        + D_delta_y_3_by_b_3_y*t552 + D_delta_z_2_by_b_3_y*t559 + D_delta_z_3_by_b_3_y*t554
        + mu_1_by_b_3_y*t565 + mu_2_by_b_3_y*t565 + mu_3_by_b_3_y*t565,
        D_delta_x_2_by_b_3_y*k_C, D_delta_y_2_by_b_3_y*k_C, D_delta_z_2_by_b_3_y*k_C,
        D_delta_x_3_by_b_3_y*t567 + D_delta_y_3_by_b_3_y*t568 + D_delta_z_3_by_b_3_y*t569
        - mu_1_by_b_3_y*t566 - mu_2_by_b_3_y*t566 + mu_3_by_b_3_y*t570,
        D_delta_x_3_by_b_3_y*k_C, D_delta_y_3_by_b_3_y*k_C, D_delta_z_3_by_b_3_y*k_C,
        2*D_p_x_1*D_p_x_1_by_b_3_z*k_C - D_p_x_1_by_b_3_z*t427 + 2*D_p_y_1*D_p_y_1_by_b_3_z*k_C
        - D_p_y_1_by_b_3_z*t430 + 2*D_p_z_1*D_p_z_1_by_b_3_z*k_C - D_p_z_1_by_b_3_z*t433
        + mu_1_by_b_3_z*t443 + mu_2_by_b_3_z*t435 + mu_3_by_b_3_z*t435 - t412*t711 - t413*t711 - t416*t712
        - t417*t712 - t420*t713 - t421*t713,
        D_p_x_1*D_p_x_2_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_2*k_C - D_p_x_1_by_b_3_z*t444
        - D_p_x_1_by_b_3_z*t445 - D_p_x_1_by_b_3_z*t450 - D_p_x_2_by_b_3_z*t412 - D_p_x_2_by_b_3_z*t413
        - D_p_x_2_by_b_3_z*t426 + D_p_y_1*D_p_y_2_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_2*k_C
        - D_p_y_1_by_b_3_z*t446 - D_p_y_1_by_b_3_z*t447 - D_p_y_1_by_b_3_z*t451 - D_p_y_2_by_b_3_z*t416
        - D_p_y_2_by_b_3_z*t417 - D_p_y_2_by_b_3_z*t429 + D_p_z_1*D_p_z_2_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_2*k_C - D_p_z_1_by_b_3_z*t448 - D_p_z_1_by_b_3_z*t449
        - D_p_z_1_by_b_3_z*t452 - D_p_z_2_by_b_3_z*t420 - D_p_z_2_by_b_3_z*t421 - D_p_z_2_by_b_3_z*t432
        + mu_1_by_b_3_z*t453 + mu_2_by_b_3_z*t454 + mu_3_by_b_3_z*t455,
        D_p_x_1*D_p_x_3_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_3*k_C - D_p_x_1_by_b_3_z*t456
        - D_p_x_1_by_b_3_z*t457 - D_p_x_1_by_b_3_z*t462 - D_p_x_3_by_b_3_z*t412 - D_p_x_3_by_b_3_z*t426
        + D_p_y_1*D_p_y_3_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_3*k_C - D_p_y_1_by_b_3_z*t458
        - D_p_y_1_by_b_3_z*t459 - D_p_y_1_by_b_3_z*t463 - D_p_y_3_by_b_3_z*t416 - D_p_y_3_by_b_3_z*t429
        + D_p_z_1*D_p_z_3_by_b_3_z*k_C + D_p_z_1_by_b_3_z*D_p_z_3*k_C - D_p_z_1_by_b_3_z*t460
        - D_p_z_1_by_b_3_z*t461 - D_p_z_1_by_b_3_z*t464 - D_p_z_3_by_b_3_z*t420 - D_p_z_3_by_b_3_z*t432
        + mu_1_by_b_3_z*t465 + mu_2_by_b_3_z*t466 + mu_3_by_b_3_z*t467 - t413*t714 - t417*t715 - t421*t716,
        D_delta_x_1_by_b_3_z*t482 + D_delta_y_1_by_b_3_z*t483 + D_delta_z_1_by_b_3_z*t484
        - D_p_x_1_by_b_3_z*t471 - D_p_x_1_by_b_3_z*t472 - D_p_x_1_by_b_3_z*t477 + D_p_x_1_by_b_3_z*t580
        - D_p_y_1_by_b_3_z*t473 - D_p_y_1_by_b_3_z*t474 - D_p_y_1_by_b_3_z*t478 + D_p_y_1_by_b_3_z*t581
        - D_p_z_1_by_b_3_z*t475 - D_p_z_1_by_b_3_z*t476 - D_p_z_1_by_b_3_z*t479 + D_p_z_1_by_b_3_z*t582
        + mu_1_by_b_3_z*t480 + mu_2_by_b_3_z*t481 + mu_3_by_b_3_z*t481,
        D_delta_x_2_by_b_3_z*t482 + D_delta_y_2_by_b_3_z*t483 + D_delta_z_2_by_b_3_z*t484
        - D_p_x_1_by_b_3_z*t485 - D_p_x_1_by_b_3_z*t486 - D_p_x_1_by_b_3_z*t491 + D_p_x_1_by_b_3_z*t583
        - D_p_y_1_by_b_3_z*t487 - D_p_y_1_by_b_3_z*t488 - D_p_y_1_by_b_3_z*t492 + D_p_y_1_by_b_3_z*t584
        - D_p_z_1_by_b_3_z*t489 - D_p_z_1_by_b_3_z*t490 - D_p_z_1_by_b_3_z*t493 + D_p_z_1_by_b_3_z*t585
        + mu_1_by_b_3_z*t494 + mu_2_by_b_3_z*t495 + mu_3_by_b_3_z*t495,
        D_delta_x_3_by_b_3_z*t482 + D_delta_y_3_by_b_3_z*t483 + D_delta_z_3_by_b_3_z*t484
        - D_p_x_1_by_b_3_z*t496 - D_p_x_1_by_b_3_z*t497 - D_p_x_1_by_b_3_z*t502 + D_p_x_1_by_b_3_z*t586
        - D_p_y_1_by_b_3_z*t498 - D_p_y_1_by_b_3_z*t499 - D_p_y_1_by_b_3_z*t503 + D_p_y_1_by_b_3_z*t587
        - D_p_z_1_by_b_3_z*t500 - D_p_z_1_by_b_3_z*t501 - D_p_z_1_by_b_3_z*t504 + D_p_z_1_by_b_3_z*t588
        + mu_1_by_b_3_z*t505 + mu_2_by_b_3_z*t506 + mu_3_by_b_3_z*t506,
        D_p_x_1_by_b_3_z*k_C, D_p_y_1_by_b_3_z*k_C, D_p_z_1_by_b_3_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_z*k_C - D_p_x_2_by_b_3_z*t624 + 2*D_p_y_2*D_p_y_2_by_b_3_z*k_C
        - D_p_y_2_by_b_3_z*t625 + 2*D_p_z_2*D_p_z_2_by_b_3_z*k_C - D_p_z_2_by_b_3_z*t626
        + mu_1_by_b_3_z*t510 + mu_2_by_b_3_z*t511 + mu_3_by_b_3_z*t510 - t444*t717 - t446*t718 - t448*t719
        - t450*t717 - t451*t718 - t452*t719,
        D_p_x_2*D_p_x_3_by_b_3_z*k_C + D_p_x_2_by_b_3_z*D_p_x_3*k_C - D_p_x_2_by_b_3_z*t456
        - D_p_x_2_by_b_3_z*t457 - D_p_x_2_by_b_3_z*t462 - D_p_x_3_by_b_3_z*t445 - D_p_x_3_by_b_3_z*t450
        + D_p_y_2*D_p_y_3_by_b_3_z*k_C + D_p_y_2_by_b_3_z*D_p_y_3*k_C - D_p_y_2_by_b_3_z*t458
        - D_p_y_2_by_b_3_z*t459 - D_p_y_2_by_b_3_z*t463 - D_p_y_3_by_b_3_z*t447 - D_p_y_3_by_b_3_z*t451
        + D_p_z_2*D_p_z_3_by_b_3_z*k_C + D_p_z_2_by_b_3_z*D_p_z_3*k_C - D_p_z_2_by_b_3_z*t460
        - D_p_z_2_by_b_3_z*t461 - D_p_z_2_by_b_3_z*t464 - D_p_z_3_by_b_3_z*t449 - D_p_z_3_by_b_3_z*t452
        + mu_1_by_b_3_z*t512 + mu_2_by_b_3_z*t513 + mu_3_by_b_3_z*t514 - t444*t714 - t446*t715 - t448*t716,
        D_delta_x_1_by_b_3_z*t520 + D_delta_y_1_by_b_3_z*t521 + D_delta_z_1_by_b_3_z*t522
        - D_p_x_2_by_b_3_z*t471 - D_p_x_2_by_b_3_z*t472 - D_p_x_2_by_b_3_z*t477 + D_p_x_2_by_b_3_z*t580
        - D_p_y_2_by_b_3_z*t473 - D_p_y_2_by_b_3_z*t474 - D_p_y_2_by_b_3_z*t478 + D_p_y_2_by_b_3_z*t581
        - D_p_z_2_by_b_3_z*t475 - D_p_z_2_by_b_3_z*t476 - D_p_z_2_by_b_3_z*t479 + D_p_z_2_by_b_3_z*t582
        + mu_1_by_b_3_z*t518 + mu_2_by_b_3_z*t519 + mu_3_by_b_3_z*t518,
        D_delta_x_2_by_b_3_z*t520 + D_delta_y_2_by_b_3_z*t521 + D_delta_z_2_by_b_3_z*t522
        - D_p_x_2_by_b_3_z*t485 - D_p_x_2_by_b_3_z*t486 - D_p_x_2_by_b_3_z*t491 + D_p_x_2_by_b_3_z*t583
        - D_p_y_2_by_b_3_z*t487 - D_p_y_2_by_b_3_z*t488 - D_p_y_2_by_b_3_z*t492 + D_p_y_2_by_b_3_z*t584
        - D_p_z_2_by_b_3_z*t489 - D_p_z_2_by_b_3_z*t490 - D_p_z_2_by_b_3_z*t493 + D_p_z_2_by_b_3_z*t585
        + mu_1_by_b_3_z*t523 + mu_2_by_b_3_z*t524 + mu_3_by_b_3_z*t523,
        D_delta_x_3_by_b_3_z*t520 + D_delta_y_3_by_b_3_z*t521 + D_delta_z_3_by_b_3_z*t522
        - D_p_x_2_by_b_3_z*t496 - D_p_x_2_by_b_3_z*t497 - D_p_x_2_by_b_3_z*t502 + D_p_x_2_by_b_3_z*t586
        - D_p_y_2_by_b_3_z*t498 - D_p_y_2_by_b_3_z*t499 - D_p_y_2_by_b_3_z*t503 + D_p_y_2_by_b_3_z*t587
        - D_p_z_2_by_b_3_z*t500 - D_p_z_2_by_b_3_z*t501 - D_p_z_2_by_b_3_z*t504 + D_p_z_2_by_b_3_z*t588
        + mu_1_by_b_3_z*t525 + mu_2_by_b_3_z*t526 + mu_3_by_b_3_z*t525,
        D_p_x_2_by_b_3_z*k_C, D_p_y_2_by_b_3_z*k_C, D_p_z_2_by_b_3_z*k_C,
        mu_1_by_b_3_z*t530 + mu_2_by_b_3_z*t530 + mu_3_by_b_3_z*t531 - s_3_z_by_b_3_z*t724 - t456*t720
        - t458*t721 - t460*t722 - t462*t720 - t463*t721 - t464*t722 + t676*t720 + t678*t721 + t680*t722
        + t683*t723 - t685*t714 - t686*t715 - t687*t716 + t691*theta_3_by_b_3_z + t693*theta_3_by_b_3_z
        + t695*theta_3_by_b_3_z + t709*t723,
        D_delta_x_1_by_b_3_z*t537 + D_delta_y_1_by_b_3_z*t538 + D_delta_z_1_by_b_3_z*t539
        - D_p_x_3_by_b_3_z*t471 - D_p_x_3_by_b_3_z*t477 + D_p_x_3_by_b_3_z*t580 - D_p_y_3_by_b_3_z*t473
        - D_p_y_3_by_b_3_z*t478 + D_p_y_3_by_b_3_z*t581 - D_p_z_3_by_b_3_z*t475 - D_p_z_3_by_b_3_z*t479
        + D_p_z_3_by_b_3_z*t582 + mu_1_by_b_3_z*t535 + mu_2_by_b_3_z*t535 + mu_3_by_b_3_z*t536 - t472*t714
        - t474*t715 - t476*t716,
        D_delta_x_2_by_b_3_z*t537 + D_delta_y_2_by_b_3_z*t538 + D_delta_z_2_by_b_3_z*t539
        - D_p_x_3_by_b_3_z*t485 - D_p_x_3_by_b_3_z*t491 + D_p_x_3_by_b_3_z*t583 - D_p_y_3_by_b_3_z*t487
        - D_p_y_3_by_b_3_z*t492 + D_p_y_3_by_b_3_z*t584 - D_p_z_3_by_b_3_z*t489 - D_p_z_3_by_b_3_z*t493
        + D_p_z_3_by_b_3_z*t585 + mu_1_by_b_3_z*t540 + mu_2_by_b_3_z*t540 + mu_3_by_b_3_z*t541 - t486*t714
        - t488*t715 - t490*t716,
        D_delta_x_3_by_b_3_z*t537 + D_delta_y_3_by_b_3_z*t538 + D_delta_z_3_by_b_3_z*t539
        - D_p_x_3_by_b_3_z*t496 - D_p_x_3_by_b_3_z*t502 + D_p_x_3_by_b_3_z*t586 - D_p_y_3_by_b_3_z*t498
        - D_p_y_3_by_b_3_z*t503 + D_p_y_3_by_b_3_z*t587 - D_p_z_3_by_b_3_z*t500 - D_p_z_3_by_b_3_z*t504
        + D_p_z_3_by_b_3_z*t588 + mu_1_by_b_3_z*t542 + mu_2_by_b_3_z*t542 + mu_3_by_b_3_z*t543 - t497*t714
        - t499*t715 - t501*t716,
        D_p_x_3_by_b_3_z*k_C, D_p_y_3_by_b_3_z*k_C, D_p_z_3_by_b_3_z*k_C,
        D_delta_x_1_by_b_3_z*t545 + D_delta_y_1_by_b_3_z*t546 + D_delta_z_1_by_b_3_z*t547
        + mu_1_by_b_3_z*t548 - mu_2_by_b_3_z*t544 - mu_3_by_b_3_z*t544,
        D_delta_x_1_by_b_3_z*t550 + D_delta_x_2_by_b_3_z*t551 + D_delta_y_1_by_b_3_z*t552
        + D_delta_y_2_by_b_3_z*t553 + D_delta_z_1_by_b_3_z*t554 + D_delta_z_2_by_b_3_z*t555
        + mu_1_by_b_3_z*t549 + mu_2_by_b_3_z*t549 + mu_3_by_b_3_z*t549,
        D_delta_x_1_by_b_3_z*t557 + D_delta_x_3_by_b_3_z*t551 + D_delta_y_1_by_b_3_z*t558
        + D_delta_y_3_by_b_3_z*t553 + D_delta_z_1_by_b_3_z*t559 + D_delta_z_3_by_b_3_z*t555
        + mu_1_by_b_3_z*t556 + mu_2_by_b_3_z*t556 + mu_3_by_b_3_z*t556,
        D_delta_x_1_by_b_3_z*k_C, D_delta_y_1_by_b_3_z*k_C, D_delta_z_1_by_b_3_z*k_C,
        D_delta_x_2_by_b_3_z*t561 + D_delta_y_2_by_b_3_z*t562 + D_delta_z_2_by_b_3_z*t563
        - mu_1_by_b_3_z*t560 + mu_2_by_b_3_z*t564 - mu_3_by_b_3_z*t560,
        D_delta_x_2_by_b_3_z*t557 + D_delta_x_3_by_b_3_z*t550 + D_delta_y_2_by_b_3_z*t558
        + D_delta_y_3_by_b_3_z*t552 + D_delta_z_2_by_b_3_z*t559 + D_delta_z_3_by_b_3_z*t554
        + mu_1_by_b_3_z*t565 + mu_2_by_b_3_z*t565 + mu_3_by_b_3_z*t565,
        D_delta_x_2_by_b_3_z*k_C, D_delta_y_2_by_b_3_z*k_C, D_delta_z_2_by_b_3_z*k_C,
        D_delta_x_3_by_b_3_z*t567 + D_delta_y_3_by_b_3_z*t568 + D_delta_z_3_by_b_3_z*t569
        - mu_1_by_b_3_z*t566 - mu_2_by_b_3_z*t566 + mu_3_by_b_3_z*t570,
        D_delta_x_3_by_b_3_z*k_C, D_delta_y_3_by_b_3_z*k_C, D_delta_z_3_by_b_3_z*k_C,
        2*D_p_x_1*D_p_x_1_by_L_a_1*k_C + 2*D_p_y_1*D_p_y_1_by_L_a_1*k_C + 2*D_p_z_1*D_p_z_1_by_L_a_1*k_C
        + (1/2)*d_1_x*g_x*m_d_1 + (1/2)*d_1_y*g_y*m_d_1 + (1/2)*d_1_z*g_z*m_d_1 - mu_1*t154 - mu_1*t155
        - mu_1*t156 + mu_1_by_L_a_1*t443 + mu_2_by_L_a_1*t435 + mu_3_by_L_a_1*t435 - s_1_x_by_L_a_1*t434
        - s_1_y_by_L_a_1*t579 - s_1_z_by_L_a_1*t602 - t412*t725 - t413*t725 - t416*t726 - t417*t726
        - t420*t727 - t421*t727 - t427*t728 - t430*t729 - t433*t730 + t437*t_1_x*theta_1_by_L_a_1
        + t439*t_1_y*theta_1_by_L_a_1 + t441*t_1_z*theta_1_by_L_a_1,
        D_p_x_1*D_p_x_2_by_L_a_1*k_C + D_p_x_1_by_L_a_1*D_p_x_2*k_C - D_p_x_1_by_L_a_1*t444
        - D_p_x_1_by_L_a_1*t445 - D_p_x_2_by_L_a_1*t412 - D_p_x_2_by_L_a_1*t413 - D_p_x_2_by_L_a_1*t426
        + D_p_y_1*D_p_y_2_by_L_a_1*k_C + D_p_y_1_by_L_a_1*D_p_y_2*k_C - D_p_y_1_by_L_a_1*t446
        - D_p_y_1_by_L_a_1*t447 - D_p_y_2_by_L_a_1*t416 - D_p_y_2_by_L_a_1*t417 - D_p_y_2_by_L_a_1*t429
        + D_p_z_1*D_p_z_2_by_L_a_1*k_C + D_p_z_1_by_L_a_1*D_p_z_2*k_C - D_p_z_1_by_L_a_1*t448
        - D_p_z_1_by_L_a_1*t449 - D_p_z_2_by_L_a_1*t420 - D_p_z_2_by_L_a_1*t421 - D_p_z_2_by_L_a_1*t432
        + mu_1_by_L_a_1*t453 + mu_2_by_L_a_1*t454 + mu_3_by_L_a_1*t455 - t450*t728 - t451*t729 - t452*t730,
        D_p_x_1*D_p_x_3_by_L_a_1*k_C + D_p_x_1_by_L_a_1*D_p_x_3*k_C - D_p_x_1_by_L_a_1*t456
        - D_p_x_1_by_L_a_1*t457 - D_p_x_3_by_L_a_1*t412 - D_p_x_3_by_L_a_1*t413 - D_p_x_3_by_L_a_1*t426
        + D_p_y_1*D_p_y_3_by_L_a_1*k_C + D_p_y_1_by_L_a_1*D_p_y_3*k_C - D_p_y_1_by_L_a_1*t458
        - D_p_y_1_by_L_a_1*t459 - D_p_y_3_by_L_a_1*t416 - D_p_y_3_by_L_a_1*t417 - D_p_y_3_by_L_a_1*t429
        + D_p_z_1*D_p_z_3_by_L_a_1*k_C + D_p_z_1_by_L_a_1*D_p_z_3*k_C - D_p_z_1_by_L_a_1*t460
        - D_p_z_1_by_L_a_1*t461 - D_p_z_3_by_L_a_1*t420 - D_p_z_3_by_L_a_1*t421 - D_p_z_3_by_L_a_1*t432
        + mu_1_by_L_a_1*t465 + mu_2_by_L_a_1*t466 + mu_3_by_L_a_1*t467 - t462*t728 - t463*t729 - t464*t730,
        D_delta_x_1_by_L_a_1*t482 + D_delta_y_1_by_L_a_1*t483 + D_delta_z_1_by_L_a_1*t484
        - D_p_x_1_by_L_a_1*t471 - D_p_x_1_by_L_a_1*t472 + D_p_x_1_by_L_a_1*t580 - D_p_y_1_by_L_a_1*t473
        - D_p_y_1_by_L_a_1*t474 + D_p_y_1_by_L_a_1*t581 - D_p_z_1_by_L_a_1*t475 - D_p_z_1_by_L_a_1*t476
        + D_p_z_1_by_L_a_1*t582 + mu_1_by_L_a_1*t480 + mu_2_by_L_a_1*t481 + mu_3_by_L_a_1*t481 - t477*t728
        - t478*t729 - t479*t730,
        D_delta_x_2_by_L_a_1*t482 + D_delta_y_2_by_L_a_1*t483 + D_delta_z_2_by_L_a_1*t484
        - D_p_x_1_by_L_a_1*t485 - D_p_x_1_by_L_a_1*t486 + D_p_x_1_by_L_a_1*t583 - D_p_y_1_by_L_a_1*t487
        - D_p_y_1_by_L_a_1*t488 + D_p_y_1_by_L_a_1*t584 - D_p_z_1_by_L_a_1*t489 - D_p_z_1_by_L_a_1*t490
        + D_p_z_1_by_L_a_1*t585 + mu_1_by_L_a_1*t494 + mu_2_by_L_a_1*t495 + mu_3_by_L_a_1*t495 - t491*t728
        - t492*t729 - t493*t730,
        D_delta_x_3_by_L_a_1*t482 + D_delta_y_3_by_L_a_1*t483 + D_delta_z_3_by_L_a_1*t484
        - D_p_x_1_by_L_a_1*t496 - D_p_x_1_by_L_a_1*t497 + D_p_x_1_by_L_a_1*t586 - D_p_y_1_by_L_a_1*t498
        - D_p_y_1_by_L_a_1*t499 + D_p_y_1_by_L_a_1*t587 - D_p_z_1_by_L_a_1*t500 - D_p_z_1_by_L_a_1*t501
        + D_p_z_1_by_L_a_1*t588 + mu_1_by_L_a_1*t505 + mu_2_by_L_a_1*t506 + mu_3_by_L_a_1*t506 - t502*t728
        - t503*t729 - t504*t730,
        D_p_x_1_by_L_a_1*k_C, D_p_y_1_by_L_a_1*k_C, D_p_z_1_by_L_a_1*k_C,
        2*D_p_x_2*D_p_x_2_by_L_a_1*k_C - D_p_x_2_by_L_a_1*t624 + 2*D_p_y_2*D_p_y_2_by_L_a_1*k_C
        - D_p_y_2_by_L_a_1*t625 + 2*D_p_z_2*D_p_z_2_by_L_a_1*k_C - D_p_z_2_by_L_a_1*t626
        + mu_1_by_L_a_1*t510 + mu_2_by_L_a_1*t511 + mu_3_by_L_a_1*t510 - t444*t731 - t446*t732 - t448*t733
        - t450*t731 - t451*t732 - t452*t733,
        D_p_x_2*D_p_x_3_by_L_a_1*k_C + D_p_x_2_by_L_a_1*D_p_x_3*k_C - D_p_x_2_by_L_a_1*t456
        - D_p_x_2_by_L_a_1*t457 - D_p_x_2_by_L_a_1*t462 - D_p_x_3_by_L_a_1*t444 - D_p_x_3_by_L_a_1*t445
        - D_p_x_3_by_L_a_1*t450 + D_p_y_2*D_p_y_3_by_L_a_1*k_C + D_p_y_2_by_L_a_1*D_p_y_3*k_C
        - D_p_y_2_by_L_a_1*t458 - D_p_y_2_by_L_a_1*t459 - D_p_y_2_by_L_a_1*t463 - D_p_y_3_by_L_a_1*t446
        - D_p_y_3_by_L_a_1*t447 - D_p_y_3_by_L_a_1*t451 + D_p_z_2*D_p_z_3_by_L_a_1*k_C
        + D_p_z_2_by_L_a_1*D_p_z_3*k_C - D_p_z_2_by_L_a_1*t460 - D_p_z_2_by_L_a_1*t461
        - D_p_z_2_by_L_a_1*t464 - D_p_z_3_by_L_a_1*t448 - D_p_z_3_by_L_a_1*t449 - D_p_z_3_by_L_a_1*t452
        + mu_1_by_L_a_1*t512 + mu_2_by_L_a_1*t513 + mu_3_by_L_a_1*t514,
        D_delta_x_1_by_L_a_1*t520 + D_delta_y_1_by_L_a_1*t521 + D_delta_z_1_by_L_a_1*t522
        - D_p_x_2_by_L_a_1*t471 - D_p_x_2_by_L_a_1*t472 - D_p_x_2_by_L_a_1*t477 + D_p_x_2_by_L_a_1*t580
        - D_p_y_2_by_L_a_1*t473 - D_p_y_2_by_L_a_1*t474 - D_p_y_2_by_L_a_1*t478 + D_p_y_2_by_L_a_1*t581
        - D_p_z_2_by_L_a_1*t475 - D_p_z_2_by_L_a_1*t476 - D_p_z_2_by_L_a_1*t479 + D_p_z_2_by_L_a_1*t582
        + mu_1_by_L_a_1*t518 + mu_2_by_L_a_1*t519 + mu_3_by_L_a_1*t518,
        D_delta_x_2_by_L_a_1*t520 + D_delta_y_2_by_L_a_1*t521 + D_delta_z_2_by_L_a_1*t522
        - D_p_x_2_by_L_a_1*t485 - D_p_x_2_by_L_a_1*t486 - D_p_x_2_by_L_a_1*t491 + D_p_x_2_by_L_a_1*t583
        - D_p_y_2_by_L_a_1*t487 - D_p_y_2_by_L_a_1*t488 - D_p_y_2_by_L_a_1*t492 + D_p_y_2_by_L_a_1*t584
        - D_p_z_2_by_L_a_1*t489 - D_p_z_2_by_L_a_1*t490 - D_p_z_2_by_L_a_1*t493 + D_p_z_2_by_L_a_1*t585
        + mu_1_by_L_a_1*t523 + mu_2_by_L_a_1*t524 + mu_3_by_L_a_1*t523,
        D_delta_x_3_by_L_a_1*t520 + D_delta_y_3_by_L_a_1*t521 + D_delta_z_3_by_L_a_1*t522
        - D_p_x_2_by_L_a_1*t496 - D_p_x_2_by_L_a_1*t497 - D_p_x_2_by_L_a_1*t502 + D_p_x_2_by_L_a_1*t586
        - D_p_y_2_by_L_a_1*t498 - D_p_y_2_by_L_a_1*t499 - D_p_y_2_by_L_a_1*t503 + D_p_y_2_by_L_a_1*t587
        - D_p_z_2_by_L_a_1*t500 - D_p_z_2_by_L_a_1*t501 - D_p_z_2_by_L_a_1*t504 + D_p_z_2_by_L_a_1*t588
        + mu_1_by_L_a_1*t525 + mu_2_by_L_a_1*t526 + mu_3_by_L_a_1*t525,
        D_p_x_2_by_L_a_1*k_C, D_p_y_2_by_L_a_1*k_C, D_p_z_2_by_L_a_1*k_C,
        2*D_p_x_3*D_p_x_3_by_L_a_1*k_C - D_p_x_3_by_L_a_1*t685 + 2*D_p_y_3*D_p_y_3_by_L_a_1*k_C
        - D_p_y_3_by_L_a_1*t686 + 2*D_p_z_3*D_p_z_3_by_L_a_1*k_C - D_p_z_3_by_L_a_1*t687
        + mu_1_by_L_a_1*t530 + mu_2_by_L_a_1*t530 + mu_3_by_L_a_1*t531 - t456*t734 - t458*t735 - t460*t736
        - t462*t734 - t463*t735 - t464*t736,
        D_delta_x_1_by_L_a_1*t537 + D_delta_y_1_by_L_a_1*t538 + D_delta_z_1_by_L_a_1*t539
        - D_p_x_3_by_L_a_1*t471 - D_p_x_3_by_L_a_1*t472 - D_p_x_3_by_L_a_1*t477 + D_p_x_3_by_L_a_1*t580
        - D_p_y_3_by_L_a_1*t473 - D_p_y_3_by_L_a_1*t474 - D_p_y_3_by_L_a_1*t478 + D_p_y_3_by_L_a_1*t581
        - D_p_z_3_by_L_a_1*t475 - D_p_z_3_by_L_a_1*t476 - D_p_z_3_by_L_a_1*t479 + D_p_z_3_by_L_a_1*t582
        + mu_1_by_L_a_1*t535 + mu_2_by_L_a_1*t535 + mu_3_by_L_a_1*t536,
        D_delta_x_2_by_L_a_1*t537 + D_delta_y_2_by_L_a_1*t538 + D_delta_z_2_by_L_a_1*t539
        - D_p_x_3_by_L_a_1*t485 - D_p_x_3_by_L_a_1*t486 - D_p_x_3_by_L_a_1*t491 + D_p_x_3_by_L_a_1*t583
        - D_p_y_3_by_L_a_1*t487 - D_p_y_3_by_L_a_1*t488 - D_p_y_3_by_L_a_1*t492 + D_p_y_3_by_L_a_1*t584
        - D_p_z_3_by_L_a_1*t489 - D_p_z_3_by_L_a_1*t490 - D_p_z_3_by_L_a_1*t493 + D_p_z_3_by_L_a_1*t585
        + mu_1_by_L_a_1*t540 + mu_2_by_L_a_1*t540 + mu_3_by_L_a_1*t541,
        D_delta_x_3_by_L_a_1*t537 + D_delta_y_3_by_L_a_1*t538 + D_delta_z_3_by_L_a_1*t539
        - D_p_x_3_by_L_a_1*t496 - D_p_x_3_by_L_a_1*t497 - D_p_x_3_by_L_a_1*t502 + D_p_x_3_by_L_a_1*t586
        - D_p_y_3_by_L_a_1*t498 - D_p_y_3_by_L_a_1*t499 - D_p_y_3_by_L_a_1*t503 + D_p_y_3_by_L_a_1*t587
        - D_p_z_3_by_L_a_1*t500 - D_p_z_3_by_L_a_1*t501 - D_p_z_3_by_L_a_1*t504 + D_p_z_3_by_L_a_1*t588
        + mu_1_by_L_a_1*t542 + mu_2_by_L_a_1*t542 + mu_3_by_L_a_1*t543,
        D_p_x_3_by_L_a_1*k_C, D_p_y_3_by_L_a_1*k_C, D_p_z_3_by_L_a_1*k_C,
        D_delta_x_1_by_L_a_1*t545 + D_delta_y_1_by_L_a_1*t546 + D_delta_z_1_by_L_a_1*t547
        + mu_1_by_L_a_1*t548 - mu_2_by_L_a_1*t544 - mu_3_by_L_a_1*t544,
        D_delta_x_1_by_L_a_1*t550 + D_delta_x_2_by_L_a_1*t551 + D_delta_y_1_by_L_a_1*t552
        + D_delta_y_2_by_L_a_1*t553 + D_delta_z_1_by_L_a_1*t554 + D_delta_z_2_by_L_a_1*t555
        + mu_1_by_L_a_1*t549 + mu_2_by_L_a_1*t549 + mu_3_by_L_a_1*t549,
        D_delta_x_1_by_L_a_1*t557 + D_delta_x_3_by_L_a_1*t551 + D_delta_y_1_by_L_a_1*t558
        + D_delta_y_3_by_L_a_1*t553 + D_delta_z_1_by_L_a_1*t559 + D_delta_z_3_by_L_a_1*t555
        + mu_1_by_L_a_1*t556 + mu_2_by_L_a_1*t556 + mu_3_by_L_a_1*t556,
        D_delta_x_1_by_L_a_1*k_C, D_delta_y_1_by_L_a_1*k_C, D_delta_z_1_by_L_a_1*k_C,
        D_delta_x_2_by_L_a_1*t561 + D_delta_y_2_by_L_a_1*t562 + D_delta_z_2_by_L_a_1*t563
        - mu_1_by_L_a_1*t560 + mu_2_by_L_a_1*t564 - mu_3_by_L_a_1*t560,
        D_delta_x_2_by_L_a_1*t557 + D_delta_x_3_by_L_a_1*t550 + D_delta_y_2_by_L_a_1*t558
        + D_delta_y_3_by_L_a_1*t552 + D_delta_z_2_by_L_a_1*t559 + D_delta_z_3_by_L_a_1*t554
        + mu_1_by_L_a_1*t565 + mu_2_by_L_a_1*t565 + mu_3_by_L_a_1*t565,
        D_delta_x_2_by_L_a_1*k_C, D_delta_y_2_by_L_a_1*k_C, D_delta_z_2_by_L_a_1*k_C,
        D_delta_x_3_by_L_a_1*t567 + D_delta_y_3_by_L_a_1*t568 + D_delta_z_3_by_L_a_1*t569
        - mu_1_by_L_a_1*t566 - mu_2_by_L_a_1*t566 + mu_3_by_L_a_1*t570,
        D_delta_x_3_by_L_a_1*k_C, D_delta_y_3_by_L_a_1*k_C, D_delta_z_3_by_L_a_1*k_C,
        2*D_p_x_1*D_p_x_1_by_L_a_2*k_C - D_p_x_1_by_L_a_2*t427 + 2*D_p_y_1*D_p_y_1_by_L_a_2*k_C
        - D_p_y_1_by_L_a_2*t430 + 2*D_p_z_1*D_p_z_1_by_L_a_2*k_C - D_p_z_1_by_L_a_2*t433
        + mu_1_by_L_a_2*t443 + mu_2_by_L_a_2*t435 + mu_3_by_L_a_2*t435 - t412*t737 - t413*t737 - t416*t738
        - t417*t738 - t420*t739 - t421*t739,
        D_p_x_1*D_p_x_2_by_L_a_2*k_C + D_p_x_1_by_L_a_2*D_p_x_2*k_C - D_p_x_1_by_L_a_2*t444
        - D_p_x_1_by_L_a_2*t445 - D_p_x_1_by_L_a_2*t450 - D_p_x_2_by_L_a_2*t413 - D_p_x_2_by_L_a_2*t426
        + D_p_y_1*D_p_y_2_by_L_a_2*k_C + D_p_y_1_by_L_a_2*D_p_y_2*k_C - D_p_y_1_by_L_a_2*t446
        - D_p_y_1_by_L_a_2*t447 - D_p_y_1_by_L_a_2*t451 - D_p_y_2_by_L_a_2*t417 - D_p_y_2_by_L_a_2*t429
        + D_p_z_1*D_p_z_2_by_L_a_2*k_C + D_p_z_1_by_L_a_2*D_p_z_2*k_C - D_p_z_1_by_L_a_2*t448
        - D_p_z_1_by_L_a_2*t449 - D_p_z_1_by_L_a_2*t452 - D_p_z_2_by_L_a_2*t421 - D_p_z_2_by_L_a_2*t432
        + mu_1_by_L_a_2*t453 + mu_2_by_L_a_2*t454 + mu_3_by_L_a_2*t455 - t412*t740 - t416*t741 - t420*t742,
        D_p_x_1*D_p_x_3_by_L_a_2*k_C + D_p_x_1_by_L_a_2*D_p_x_3*k_C - D_p_x_1_by_L_a_2*t456
        - D_p_x_1_by_L_a_2*t457 - D_p_x_1_by_L_a_2*t462 - D_p_x_3_by_L_a_2*t412 - D_p_x_3_by_L_a_2*t413
        - D_p_x_3_by_L_a_2*t426 + D_p_y_1*D_p_y_3_by_L_a_2*k_C + D_p_y_1_by_L_a_2*D_p_y_3*k_C
        - D_p_y_1_by_L_a_2*t458 - D_p_y_1_by_L_a_2*t459 - D_p_y_1_by_L_a_2*t463 - D_p_y_3_by_L_a_2*t416
        - D_p_y_3_by_L_a_2*t417 - D_p_y_3_by_L_a_2*t429 + D_p_z_1*D_p_z_3_by_L_a_2*k_C
        + D_p_z_1_by_L_a_2*D_p_z_3*k_C - D_p_z_1_by_L_a_2*t460 - D_p_z_1_by_L_a_2*t461
        - D_p_z_1_by_L_a_2*t464 - D_p_z_3_by_L_a_2*t420 - D_p_z_3_by_L_a_2*t421 - D_p_z_3_by_L_a_2*t432
        + mu_1_by_L_a_2*t465 + mu_2_by_L_a_2*t466 + mu_3_by_L_a_2*t467,
        D_delta_x_1_by_L_a_2*t482 + D_delta_y_1_by_L_a_2*t483 + D_delta_z_1_by_L_a_2*t484
        - D_p_x_1_by_L_a_2*t471 - D_p_x_1_by_L_a_2*t472 - D_p_x_1_by_L_a_2*t477 + D_p_x_1_by_L_a_2*t580
        - D_p_y_1_by_L_a_2*t473 - D_p_y_1_by_L_a_2*t474 - D_p_y_1_by_L_a_2*t478 + D_p_y_1_by_L_a_2*t581
        - D_p_z_1_by_L_a_2*t475 - D_p_z_1_by_L_a_2*t476 - D_p_z_1_by_L_a_2*t479 + D_p_z_1_by_L_a_2*t582
        + mu_1_by_L_a_2*t480 + mu_2_by_L_a_2*t481 + mu_3_by_L_a_2*t481,
        D_delta_x_2_by_L_a_2*t482 + D_delta_y_2_by_L_a_2*t483 + D_delta_z_2_by_L_a_2*t484
        - D_p_x_1_by_L_a_2*t485 - D_p_x_1_by_L_a_2*t486 - D_p_x_1_by_L_a_2*t491 + D_p_x_1_by_L_a_2*t583
        - D_p_y_1_by_L_a_2*t487 - D_p_y_1_by_L_a_2*t488 - D_p_y_1_by_L_a_2*t492 + D_p_y_1_by_L_a_2*t584
        - D_p_z_1_by_L_a_2*t489 - D_p_z_1_by_L_a_2*t490 - D_p_z_1_by_L_a_2*t493 + D_p_z_1_by_L_a_2*t585
        + mu_1_by_L_a_2*t494 + mu_2_by_L_a_2*t495 + mu_3_by_L_a_2*t495,
        D_delta_x_3_by_L_a_2*t482 + D_delta_y_3_by_L_a_2*t483 + D_delta_z_3_by_L_a_2*t484
        - D_p_x_1_by_L_a_2*t496 - D_p_x_1_by_L_a_2*t497 - D_p_x_1_by_L_a_2*t502 + D_p_x_1_by_L_a_2*t586
        - D_p_y_1_by_L_a_2*t498 - D_p_y_1_by_L_a_2*t499 - D_p_y_1_by_L_a_2*t503 + D_p_y_1_by_L_a_2*t587
        - D_p_z_1_by_L_a_2*t500 - D_p_z_1_by_L_a_2*t501 - D_p_z_1_by_L_a_2*t504 + D_p_z_1_by_L_a_2*t588
        + mu_1_by_L_a_2*t505 + mu_2_by_L_a_2*t506 + mu_3_by_L_a_2*t506,
        D_p_x_1_by_L_a_2*k_C, D_p_y_1_by_L_a_2*k_C, D_p_z_1_by_L_a_2*k_C,
        2*D_p_x_2*D_p_x_2_by_L_a_2*k_C + 2*D_p_y_2*D_p_y_2_by_L_a_2*k_C + 2*D_p_z_2*D_p_z_2_by_L_a_2*k_C
        + (1/2)*d_2_x*g_x*m_d_2 + (1/2)*d_2_y*g_y*m_d_2 + (1/2)*d_2_z*g_z*m_d_2 + mu_1_by_L_a_2*t510
        - mu_2*t166 - mu_2*t167 - mu_2*t168 + mu_2_by_L_a_2*t511 + mu_3_by_L_a_2*t510
        - s_2_x_by_L_a_2*t627 - s_2_y_by_L_a_2*t649 - s_2_z_by_L_a_2*t663 - t444*t743 - t446*t744
        - t448*t745 - t450*t743 - t451*t744 - t452*t745 - t624*t740 - t625*t741 - t626*t742
        + t629*t_2_x*theta_2_by_L_a_2 + t631*t_2_y*theta_2_by_L_a_2 + t633*t_2_z*theta_2_by_L_a_2,
        D_p_x_2*D_p_x_3_by_L_a_2*k_C + D_p_x_2_by_L_a_2*D_p_x_3*k_C - D_p_x_2_by_L_a_2*t457
        - D_p_x_2_by_L_a_2*t462 - D_p_x_3_by_L_a_2*t444 - D_p_x_3_by_L_a_2*t445 - D_p_x_3_by_L_a_2*t450
        + D_p_y_2*D_p_y_3_by_L_a_2*k_C + D_p_y_2_by_L_a_2*D_p_y_3*k_C - D_p_y_2_by_L_a_2*t459
        - D_p_y_2_by_L_a_2*t463 - D_p_y_3_by_L_a_2*t446 - D_p_y_3_by_L_a_2*t447 - D_p_y_3_by_L_a_2*t451
        + D_p_z_2*D_p_z_3_by_L_a_2*k_C + D_p_z_2_by_L_a_2*D_p_z_3*k_C - D_p_z_2_by_L_a_2*t461
        - D_p_z_2_by_L_a_2*t464 - D_p_z_3_by_L_a_2*t448 - D_p_z_3_by_L_a_2*t449 - D_p_z_3_by_L_a_2*t452
        + mu_1_by_L_a_2*t512 + mu_2_by_L_a_2*t513 + mu_3_by_L_a_2*t514 - t456*t740 - t458*t741 - t460*t742,
        D_delta_x_1_by_L_a_2*t520 + D_delta_y_1_by_L_a_2*t521 + D_delta_z_1_by_L_a_2*t522
        - D_p_x_2_by_L_a_2*t472 - D_p_x_2_by_L_a_2*t477 + D_p_x_2_by_L_a_2*t580 - D_p_y_2_by_L_a_2*t474
        - D_p_y_2_by_L_a_2*t478 + D_p_y_2_by_L_a_2*t581 - D_p_z_2_by_L_a_2*t476 - D_p_z_2_by_L_a_2*t479
        + D_p_z_2_by_L_a_2*t582 + mu_1_by_L_a_2*t518 + mu_2_by_L_a_2*t519 + mu_3_by_L_a_2*t518 - t471*t740
        - t473*t741 - t475*t742,
        D_delta_x_2_by_L_a_2*t520 + D_delta_y_2_by_L_a_2*t521 + D_delta_z_2_by_L_a_2*t522
        - D_p_x_2_by_L_a_2*t486 - D_p_x_2_by_L_a_2*t491 + D_p_x_2_by_L_a_2*t583 - D_p_y_2_by_L_a_2*t488
        - D_p_y_2_by_L_a_2*t492 + D_p_y_2_by_L_a_2*t584 - D_p_z_2_by_L_a_2*t490 - D_p_z_2_by_L_a_2*t493
        + D_p_z_2_by_L_a_2*t585 + mu_1_by_L_a_2*t523 + mu_2_by_L_a_2*t524 + mu_3_by_L_a_2*t523 - t485*t740
        - t487*t741 - t489*t742,
        D_delta_x_3_by_L_a_2*t520 + D_delta_y_3_by_L_a_2*t521 + D_delta_z_3_by_L_a_2*t522
        - D_p_x_2_by_L_a_2*t497 - D_p_x_2_by_L_a_2*t502 + D_p_x_2_by_L_a_2*t586 - D_p_y_2_by_L_a_2*t499
        - D_p_y_2_by_L_a_2*t503 + D_p_y_2_by_L_a_2*t587 - D_p_z_2_by_L_a_2*t501 - D_p_z_2_by_L_a_2*t504
        + D_p_z_2_by_L_a_2*t588 + mu_1_by_L_a_2*t525 + mu_2_by_L_a_2*t526 + mu_3_by_L_a_2*t525 - t496*t740
        - t498*t741 - t500*t742,
        D_p_x_2_by_L_a_2*k_C, D_p_y_2_by_L_a_2*k_C, D_p_z_2_by_L_a_2*k_C,
        2*D_p_x_3*D_p_x_3_by_L_a_2*k_C - D_p_x_3_by_L_a_2*t685 + 2*D_p_y_3*D_p_y_3_by_L_a_2*k_C
        - D_p_y_3_by_L_a_2*t686 + 2*D_p_z_3*D_p_z_3_by_L_a_2*k_C - D_p_z_3_by_L_a_2*t687
        + mu_1_by_L_a_2*t530 + mu_2_by_L_a_2*t530 + mu_3_by_L_a_2*t531 - t456*t746 - t458*t747 - t460*t748
        - t462*t746 - t463*t747 - t464*t748,
        D_delta_x_1_by_L_a_2*t537 + D_delta_y_1_by_L_a_2*t538 + D_delta_z_1_by_L_a_2*t539
        - D_p_x_3_by_L_a_2*t471 - D_p_x_3_by_L_a_2*t472 - D_p_x_3_by_L_a_2*t477 + D_p_x_3_by_L_a_2*t580
        - D_p_y_3_by_L_a_2*t473 - D_p_y_3_by_L_a_2*t474 - D_p_y_3_by_L_a_2*t478 + D_p_y_3_by_L_a_2*t581
        - D_p_z_3_by_L_a_2*t475 - D_p_z_3_by_L_a_2*t476 - D_p_z_3_by_L_a_2*t479 + D_p_z_3_by_L_a_2*t582
        + mu_1_by_L_a_2*t535 + mu_2_by_L_a_2*t535 + mu_3_by_L_a_2*t536,
        D_delta_x_2_by_L_a_2*t537 + D_delta_y_2_by_L_a_2*t538 + D_delta_z_2_by_L_a_2*t539
        - D_p_x_3_by_L_a_2*t485 - D_p_x_3_by_L_a_2*t486 - D_p_x_3_by_L_a_2*t491 + D_p_x_3_by_L_a_2*t583
        - D_p_y_3_by_L_a_2*t487 - D_p_y_3_by_L_a_2*t488 - D_p_y_3_by_L_a_2*t492 + D_p_y_3_by_L_a_2*t584
        - D_p_z_3_by_L_a_2*t489 - D_p_z_3_by_L_a_2*t490 - D_p_z_3_by_L_a_2*t493 + D_p_z_3_by_L_a_2*t585
        + mu_1_by_L_a_2*t540 + mu_2_by_L_a_2*t540 + mu_3_by_L_a_2*t541,
        D_delta_x_3_by_L_a_2*t537 + D_delta_y_3_by_L_a_2*t538 + D_delta_z_3_by_L_a_2*t539
        - D_p_x_3_by_L_a_2*t496 - D_p_x_3_by_L_a_2*t497 - D_p_x_3_by_L_a_2*t502 + D_p_x_3_by_L_a_2*t586
        - D_p_y_3_by_L_a_2*t498 - D_p_y_3_by_L_a_2*t499 - D_p_y_3_by_L_a_2*t503 + D_p_y_3_by_L_a_2*t587
        - D_p_z_3_by_L_a_2*t500 - D_p_z_3_by_L_a_2*t501 - D_p_z_3_by_L_a_2*t504 + D_p_z_3_by_L_a_2*t588
        + mu_1_by_L_a_2*t542 + mu_2_by_L_a_2*t542 + mu_3_by_L_a_2*t543,
        D_p_x_3_by_L_a_2*k_C, D_p_y_3_by_L_a_2*k_C, D_p_z_3_by_L_a_2*k_C,
        D_delta_x_1_by_L_a_2*t545 + D_delta_y_1_by_L_a_2*t546 + D_delta_z_1_by_L_a_2*t547
        + mu_1_by_L_a_2*t548 - mu_2_by_L_a_2*t544 - mu_3_by_L_a_2*t544,
        D_delta_x_1_by_L_a_2*t550 + D_delta_x_2_by_L_a_2*t551 + D_delta_y_1_by_L_a_2*t552
        + D_delta_y_2_by_L_a_2*t553 + D_delta_z_1_by_L_a_2*t554 + D_delta_z_2_by_L_a_2*t555
        + mu_1_by_L_a_2*t549 + mu_2_by_L_a_2*t549 + mu_3_by_L_a_2*t549,
        D_delta_x_1_by_L_a_2*t557 + D_delta_x_3_by_L_a_2*t551 + D_delta_y_1_by_L_a_2*t558
        + D_delta_y_3_by_L_a_2*t553 + D_delta_z_1_by_L_a_2*t559 + D_delta_z_3_by_L_a_2*t555
        + mu_1_by_L_a_2*t556 + mu_2_by_L_a_2*t556 + mu_3_by_L_a_2*t556,
        D_delta_x_1_by_L_a_2*k_C, D_delta_y_1_by_L_a_2*k_C, D_delta_z_1_by_L_a_2*k_C,
        D_delta_x_2_by_L_a_2*t561 + D_delta_y_2_by_L_a_2*t562 + D_delta_z_2_by_L_a_2*t563
        - mu_1_by_L_a_2*t560 + mu_2_by_L_a_2*t564 - mu_3_by_L_a_2*t560,
        D_delta_x_2_by_L_a_2*t557 + D_delta_x_3_by_L_a_2*t550 + D_delta_y_2_by_L_a_2*t558
        + D_delta_y_3_by_L_a_2*t552 + D_delta_z_2_by_L_a_2*t559 + D_delta_z_3_by_L_a_2*t554
        + mu_1_by_L_a_2*t565 + mu_2_by_L_a_2*t565 + mu_3_by_L_a_2*t565,
        D_delta_x_2_by_L_a_2*k_C, D_delta_y_2_by_L_a_2*k_C, D_delta_z_2_by_L_a_2*k_C,
        D_delta_x_3_by_L_a_2*t567 + D_delta_y_3_by_L_a_2*t568 + D_delta_z_3_by_L_a_2*t569
        - mu_1_by_L_a_2*t566 - mu_2_by_L_a_2*t566 + mu_3_by_L_a_2*t570,
        D_delta_x_3_by_L_a_2*k_C, D_delta_y_3_by_L_a_2*k_C, D_delta_z_3_by_L_a_2*k_C,
        2*D_p_x_1*D_p_x_1_by_L_a_3*k_C - D_p_x_1_by_L_a_3*t427 + 2*D_p_y_1*D_p_y_1_by_L_a_3*k_C
        - D_p_y_1_by_L_a_3*t430 + 2*D_p_z_1*D_p_z_1_by_L_a_3*k_C - D_p_z_1_by_L_a_3*t433
        + mu_1_by_L_a_3*t443 + mu_2_by_L_a_3*t435 + mu_3_by_L_a_3*t435 - t412*t749 - t413*t749 - t416*t750
        - t417*t750 - t420*t751 - t421*t751,
        D_p_x_1*D_p_x_2_by_L_a_3*k_C + D_p_x_1_by_L_a_3*D_p_x_2*k_C - D_p_x_1_by_L_a_3*t444
        - D_p_x_1_by_L_a_3*t445 - D_p_x_1_by_L_a_3*t450 - D_p_x_2_by_L_a_3*t412 - D_p_x_2_by_L_a_3*t413
        - D_p_x_2_by_L_a_3*t426 + D_p_y_1*D_p_y_2_by_L_a_3*k_C + D_p_y_1_by_L_a_3*D_p_y_2*k_C
        - D_p_y_1_by_L_a_3*t446 - D_p_y_1_by_L_a_3*t447 - D_p_y_1_by_L_a_3*t451 - D_p_y_2_by_L_a_3*t416
        - D_p_y_2_by_L_a_3*t417 - D_p_y_2_by_L_a_3*t429 + D_p_z_1*D_p_z_2_by_L_a_3*k_C
        + D_p_z_1_by_L_a_3*D_p_z_2*k_C - D_p_z_1_by_L_a_3*t448 - D_p_z_1_by_L_a_3*t449
        - D_p_z_1_by_L_a_3*t452 - D_p_z_2_by_L_a_3*t420 - D_p_z_2_by_L_a_3*t421 - D_p_z_2_by_L_a_3*t432
        + mu_1_by_L_a_3*t453 + mu_2_by_L_a_3*t454 + mu_3_by_L_a_3*t455,
        D_p_x_1*D_p_x_3_by_L_a_3*k_C + D_p_x_1_by_L_a_3*D_p_x_3*k_C - D_p_x_1_by_L_a_3*t456
        - D_p_x_1_by_L_a_3*t457 - D_p_x_1_by_L_a_3*t462 - D_p_x_3_by_L_a_3*t412 - D_p_x_3_by_L_a_3*t426
        + D_p_y_1*D_p_y_3_by_L_a_3*k_C + D_p_y_1_by_L_a_3*D_p_y_3*k_C - D_p_y_1_by_L_a_3*t458
        - D_p_y_1_by_L_a_3*t459 - D_p_y_1_by_L_a_3*t463 - D_p_y_3_by_L_a_3*t416 - D_p_y_3_by_L_a_3*t429
        + D_p_z_1*D_p_z_3_by_L_a_3*k_C + D_p_z_1_by_L_a_3*D_p_z_3*k_C - D_p_z_1_by_L_a_3*t460
        - D_p_z_1_by_L_a_3*t461 - D_p_z_1_by_L_a_3*t464 - D_p_z_3_by_L_a_3*t420 - D_p_z_3_by_L_a_3*t432
        + mu_1_by_L_a_3*t465 + mu_2_by_L_a_3*t466 + mu_3_by_L_a_3*t467 - t413*t752 - t417*t753 - t421*t754,
        D_delta_x_1_by_L_a_3*t482 + D_delta_y_1_by_L_a_3*t483 + D_delta_z_1_by_L_a_3*t484
        - D_p_x_1_by_L_a_3*t471 - D_p_x_1_by_L_a_3*t472 - D_p_x_1_by_L_a_3*t477 + D_p_x_1_by_L_a_3*t580
        - D_p_y_1_by_L_a_3*t473 - D_p_y_1_by_L_a_3*t474 - D_p_y_1_by_L_a_3*t478 + D_p_y_1_by_L_a_3*t581
        - D_p_z_1_by_L_a_3*t475 - D_p_z_1_by_L_a_3*t476 - D_p_z_1_by_L_a_3*t479 + D_p_z_1_by_L_a_3*t582
        + mu_1_by_L_a_3*t480 + mu_2_by_L_a_3*t481 + mu_3_by_L_a_3*t481,
        D_delta_x_2_by_L_a_3*t482 + D_delta_y_2_by_L_a_3*t483 + D_delta_z_2_by_L_a_3*t484
        - D_p_x_1_by_L_a_3*t485 - D_p_x_1_by_L_a_3*t486 - D_p_x_1_by_L_a_3*t491 + D_p_x_1_by_L_a_3*t583
        - D_p_y_1_by_L_a_3*t487 - D_p_y_1_by_L_a_3*t488 - D_p_y_1_by_L_a_3*t492 + D_p_y_1_by_L_a_3*t584
        - D_p_z_1_by_L_a_3*t489 - D_p_z_1_by_L_a_3*t490 - D_p_z_1_by_L_a_3*t493 + D_p_z_1_by_L_a_3*t585
        + mu_1_by_L_a_3*t494 + mu_2_by_L_a_3*t495 + mu_3_by_L_a_3*t495,
        D_delta_x_3_by_L_a_3*t482 + D_delta_y_3_by_L_a_3*t483 + D_delta_z_3_by_L_a_3*t484
        - D_p_x_1_by_L_a_3*t496 - D_p_x_1_by_L_a_3*t497 - D_p_x_1_by_L_a_3*t502 + D_p_x_1_by_L_a_3*t586
        - D_p_y_1_by_L_a_3*t498 - D_p_y_1_by_L_a_3*t499 - D_p_y_1_by_L_a_3*t503 + D_p_y_1_by_L_a_3*t587
        - D_p_z_1_by_L_a_3*t500 - D_p_z_1_by_L_a_3*t501 - D_p_z_1_by_L_a_3*t504 + D_p_z_1_by_L_a_3*t588
        + mu_1_by_L_a_3*t505 + mu_2_by_L_a_3*t506 + mu_3_by_L_a_3*t506,
        D_p_x_1_by_L_a_3*k_C, D_p_y_1_by_L_a_3*k_C, D_p_z_1_by_L_a_3*k_C,
        2*D_p_x_2*D_p_x_2_by_L_a_3*k_C - D_p_x_2_by_L_a_3*t624 + 2*D_p_y_2*D_p_y_2_by_L_a_3*k_C
        - D_p_y_2_by_L_a_3*t625 + 2*D_p_z_2*D_p_z_2_by_L_a_3*k_C - D_p_z_2_by_L_a_3*t626
        + mu_1_by_L_a_3*t510 + mu_2_by_L_a_3*t511 + mu_3_by_L_a_3*t510 - t444*t755 - t446*t756 - t448*t757
        - t450*t755 - t451*t756 - t452*t757,
        D_p_x_2*D_p_x_3_by_L_a_3*k_C + D_p_x_2_by_L_a_3*D_p_x_3*k_C - D_p_x_2_by_L_a_3*t456
        - D_p_x_2_by_L_a_3*t457 - D_p_x_2_by_L_a_3*t462 - D_p_x_3_by_L_a_3*t445 - D_p_x_3_by_L_a_3*t450
        + D_p_y_2*D_p_y_3_by_L_a_3*k_C + D_p_y_2_by_L_a_3*D_p_y_3*k_C - D_p_y_2_by_L_a_3*t458
        - D_p_y_2_by_L_a_3*t459 - D_p_y_2_by_L_a_3*t463 - D_p_y_3_by_L_a_3*t447 - D_p_y_3_by_L_a_3*t451
        + D_p_z_2*D_p_z_3_by_L_a_3*k_C + D_p_z_2_by_L_a_3*D_p_z_3*k_C - D_p_z_2_by_L_a_3*t460
        - D_p_z_2_by_L_a_3*t461 - D_p_z_2_by_L_a_3*t464 - D_p_z_3_by_L_a_3*t449 - D_p_z_3_by_L_a_3*t452
        + mu_1_by_L_a_3*t512 + mu_2_by_L_a_3*t513 + mu_3_by_L_a_3*t514 - t444*t752 - t446*t753 - t448*t754,
        D_delta_x_1_by_L_a_3*t520 + D_delta_y_1_by_L_a_3*t521 + D_delta_z_1_by_L_a_3*t522
        - D_p_x_2_by_L_a_3*t471 - D_p_x_2_by_L_a_3*t472 - D_p_x_2_by_L_a_3*t477 + D_p_x_2_by_L_a_3*t580
        - D_p_y_2_by_L_a_3*t473 - D_p_y_2_by_L_a_3*t474 - D_p_y_2_by_L_a_3*t478 + D_p_y_2_by_L_a_3*t581
        - D_p_z_2_by_L_a_3*t475 - D_p_z_2_by_L_a_3*t476 - D_p_z_2_by_L_a_3*t479 + D_p_z_2_by_L_a_3*t582
        + mu_1_by_L_a_3*t518 + mu_2_by_L_a_3*t519 + mu_3_by_L_a_3*t518,
        D_delta_x_2_by_L_a_3*t520 + D_delta_y_2_by_L_a_3*t521 + D_delta_z_2_by_L_a_3*t522
        - D_p_x_2_by_L_a_3*t485 - D_p_x_2_by_L_a_3*t486 - D_p_x_2_by_L_a_3*t491 + D_p_x_2_by_L_a_3*t583
        - D_p_y_2_by_L_a_3*t487 - D_p_y_2_by_L_a_3*t488 - D_p_y_2_by_L_a_3*t492 + D_p_y_2_by_L_a_3*t584
        - D_p_z_2_by_L_a_3*t489 - D_p_z_2_by_L_a_3*t490 - D_p_z_2_by_L_a_3*t493 + D_p_z_2_by_L_a_3*t585
        + mu_1_by_L_a_3*t523 + mu_2_by_L_a_3*t524 + mu_3_by_L_a_3*t523,
        D_delta_x_3_by_L_a_3*t520 + D_delta_y_3_by_L_a_3*t521 + D_delta_z_3_by_L_a_3*t522
        - D_p_x_2_by_L_a_3*t496 - D_p_x_2_by_L_a_3*t497 - D_p_x_2_by_L_a_3*t502 + D_p_x_2_by_L_a_3*t586
        - D_p_y_2_by_L_a_3*t498 - D_p_y_2_by_L_a_3*t499 - D_p_y_2_by_L_a_3*t503 + D_p_y_2_by_L_a_3*t587
        - D_p_z_2_by_L_a_3*t500 - D_p_z_2_by_L_a_3*t501 - D_p_z_2_by_L_a_3*t504 + D_p_z_2_by_L_a_3*t588
        + mu_1_by_L_a_3*t525 + mu_2_by_L_a_3*t526 + mu_3_by_L_a_3*t525,
        D_p_x_2_by_L_a_3*k_C, D_p_y_2_by_L_a_3*k_C, D_p_z_2_by_L_a_3*k_C,
        2*D_p_x_3*D_p_x_3_by_L_a_3*k_C + 2*D_p_y_3*D_p_y_3_by_L_a_3*k_C + 2*D_p_z_3*D_p_z_3_by_L_a_3*k_C
        + (1/2)*d_3_x*g_x*m_d_3 + (1/2)*d_3_y*g_y*m_d_3 + (1/2)*d_3_z*g_z*m_d_3 + mu_1_by_L_a_3*t530
        + mu_2_by_L_a_3*t530 - mu_3*t178 - mu_3*t179 - mu_3*t180 + mu_3_by_L_a_3*t531
        - s_3_x_by_L_a_3*t688 - s_3_y_by_L_a_3*t710 - s_3_z_by_L_a_3*t724 - t456*t758 - t458*t759
        - t460*t760 - t462*t758 - t463*t759 - t464*t760 - t685*t752 - t686*t753 - t687*t754
        + t690*t_3_x*theta_3_by_L_a_3 + t692*t_3_y*theta_3_by_L_a_3 + t694*t_3_z*theta_3_by_L_a_3,
        D_delta_x_1_by_L_a_3*t537 + D_delta_y_1_by_L_a_3*t538 + D_delta_z_1_by_L_a_3*t539
        - D_p_x_3_by_L_a_3*t471 - D_p_x_3_by_L_a_3*t477 + D_p_x_3_by_L_a_3*t580 - D_p_y_3_by_L_a_3*t473
        - D_p_y_3_by_L_a_3*t478 + D_p_y_3_by_L_a_3*t581 - D_p_z_3_by_L_a_3*t475 - D_p_z_3_by_L_a_3*t479
        + D_p_z_3_by_L_a_3*t582 + mu_1_by_L_a_3*t535 + mu_2_by_L_a_3*t535 + mu_3_by_L_a_3*t536 - t472*t752
        - t474*t753 - t476*t754,
        D_delta_x_2_by_L_a_3*t537 + D_delta_y_2_by_L_a_3*t538 + D_delta_z_2_by_L_a_3*t539
        - D_p_x_3_by_L_a_3*t485 - D_p_x_3_by_L_a_3*t491 + D_p_x_3_by_L_a_3*t583 - D_p_y_3_by_L_a_3*t487
        - D_p_y_3_by_L_a_3*t492 + D_p_y_3_by_L_a_3*t584 - D_p_z_3_by_L_a_3*t489 - D_p_z_3_by_L_a_3*t493
        + D_p_z_3_by_L_a_3*t585 + mu_1_by_L_a_3*t540 + mu_2_by_L_a_3*t540 + mu_3_by_L_a_3*t541 - t486*t752
        - t488*t753 - t490*t754,
        D_delta_x_3_by_L_a_3*t537 + D_delta_y_3_by_L_a_3*t538 + D_delta_z_3_by_L_a_3*t539
        - D_p_x_3_by_L_a_3*t496 - D_p_x_3_by_L_a_3*t502 + D_p_x_3_by_L_a_3*t586 - D_p_y_3_by_L_a_3*t498
        - D_p_y_3_by_L_a_3*t503 + D_p_y_3_by_L_a_3*t587 - D_p_z_3_by_L_a_3*t500 - D_p_z_3_by_L_a_3*t504
        + D_p_z_3_by_L_a_3*t588 + mu_1_by_L_a_3*t542 + mu_2_by_L_a_3*t542 + mu_3_by_L_a_3*t543 - t497*t752
        - t499*t753 - t501*t754,
        D_p_x_3_by_L_a_3*k_C, D_p_y_3_by_L_a_3*k_C, D_p_z_3_by_L_a_3*k_C,
        D_delta_x_1_by_L_a_3*t545 + D_delta_y_1_by_L_a_3*t546 + D_delta_z_1_by_L_a_3*t547
        + mu_1_by_L_a_3*t548 - mu_2_by_L_a_3*t544 - mu_3_by_L_a_3*t544,
        D_delta_x_1_by_L_a_3*t550 + D_delta_x_2_by_L_a_3*t551 + D_delta_y_1_by_L_a_3*t552
        + D_delta_y_2_by_L_a_3*t553 + D_delta_z_1_by_L_a_3*t554 + D_delta_z_2_by_L_a_3*t555
        + mu_1_by_L_a_3*t549 + mu_2_by_L_a_3*t549 + mu_3_by_L_a_3*t549,
        D_delta_x_1_by_L_a_3*t557 + D_delta_x_3_by_L_a_3*t551 + D_delta_y_1_by_L_a_3*t558
        + D_delta_y_3_by_L_a_3*t553 + D_delta_z_1_by_L_a_3*t559 + D_delta_z_3_by_L_a_3*t555
        + mu_1_by_L_a_3*t556 + mu_2_by_L_a_3*t556 + mu_3_by_L_a_3*t556,
        D_delta_x_1_by_L_a_3*k_C, D_delta_y_1_by_L_a_3*k_C, D_delta_z_1_by_L_a_3*k_C,
        D_delta_x_2_by_L_a_3*t561 + D_delta_y_2_by_L_a_3*t562 + D_delta_z_2_by_L_a_3*t563
        - mu_1_by_L_a_3*t560 + mu_2_by_L_a_3*t564 - mu_3_by_L_a_3*t560,
        D_delta_x_2_by_L_a_3*t557 + D_delta_x_3_by_L_a_3*t550 + D_delta_y_2_by_L_a_3*t558
        + D_delta_y_3_by_L_a_3*t552 + D_delta_z_2_by_L_a_3*t559 + D_delta_z_3_by_L_a_3*t554
        + mu_1_by_L_a_3*t565 + mu_2_by_L_a_3*t565 + mu_3_by_L_a_3*t565,
        D_delta_x_2_by_L_a_3*k_C, D_delta_y_2_by_L_a_3*k_C, D_delta_z_2_by_L_a_3*k_C,
        D_delta_x_3_by_L_a_3*t567 + D_delta_y_3_by_L_a_3*t568 + D_delta_z_3_by_L_a_3*t569
        - mu_1_by_L_a_3*t566 - mu_2_by_L_a_3*t566 + mu_3_by_L_a_3*t570,
        D_delta_x_3_by_L_a_3*k_C, D_delta_y_3_by_L_a_3*k_C, D_delta_z_3_by_L_a_3*k_C,
        mu_1_by_l_d_1*t443 + mu_2_by_l_d_1*t435 + mu_3_by_l_d_1*t435 + t410*t761 - t412*t761 - t413*t761
        + t414*t762 - t416*t762 - t417*t762 + t418*t763 - t420*t763 - t421*t763 + t423*t764 + t424*t764
        - t427*t765 - t430*t766 - t433*t767 + t438*theta_1_by_l_d_1 + t440*theta_1_by_l_d_1
        + t442*theta_1_by_l_d_1 + t575*t764,
        D_p_x_1*D_p_x_2_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_2*k_C - D_p_x_1_by_l_d_1*t444
        - D_p_x_1_by_l_d_1*t445 - D_p_x_2_by_l_d_1*t412 - D_p_x_2_by_l_d_1*t413 - D_p_x_2_by_l_d_1*t426
        + D_p_y_1*D_p_y_2_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_2*k_C - D_p_y_1_by_l_d_1*t446
        - D_p_y_1_by_l_d_1*t447 - D_p_y_2_by_l_d_1*t416 - D_p_y_2_by_l_d_1*t417 - D_p_y_2_by_l_d_1*t429
        + D_p_z_1*D_p_z_2_by_l_d_1*k_C + D_p_z_1_by_l_d_1*D_p_z_2*k_C - D_p_z_1_by_l_d_1*t448
        - D_p_z_1_by_l_d_1*t449 - D_p_z_2_by_l_d_1*t420 - D_p_z_2_by_l_d_1*t421 - D_p_z_2_by_l_d_1*t432
        + mu_1_by_l_d_1*t453 + mu_2_by_l_d_1*t454 + mu_3_by_l_d_1*t455 - t450*t765 - t451*t766 - t452*t767,
        D_p_x_1*D_p_x_3_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_3*k_C - D_p_x_1_by_l_d_1*t456
        - D_p_x_1_by_l_d_1*t457 - D_p_x_3_by_l_d_1*t412 - D_p_x_3_by_l_d_1*t413 - D_p_x_3_by_l_d_1*t426
        + D_p_y_1*D_p_y_3_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_3*k_C - D_p_y_1_by_l_d_1*t458
        - D_p_y_1_by_l_d_1*t459 - D_p_y_3_by_l_d_1*t416 - D_p_y_3_by_l_d_1*t417 - D_p_y_3_by_l_d_1*t429
        + D_p_z_1*D_p_z_3_by_l_d_1*k_C + D_p_z_1_by_l_d_1*D_p_z_3*k_C - D_p_z_1_by_l_d_1*t460
        - D_p_z_1_by_l_d_1*t461 - D_p_z_3_by_l_d_1*t420 - D_p_z_3_by_l_d_1*t421 - D_p_z_3_by_l_d_1*t432
        + mu_1_by_l_d_1*t465 + mu_2_by_l_d_1*t466 + mu_3_by_l_d_1*t467 - t462*t765 - t463*t766 - t464*t767,
        D_delta_x_1_by_l_d_1*t482 + D_delta_y_1_by_l_d_1*t483 + D_delta_z_1_by_l_d_1*t484
        - D_p_x_1_by_l_d_1*t471 - D_p_x_1_by_l_d_1*t472 + D_p_x_1_by_l_d_1*t580 - D_p_y_1_by_l_d_1*t473
        - D_p_y_1_by_l_d_1*t474 + D_p_y_1_by_l_d_1*t581 - D_p_z_1_by_l_d_1*t475 - D_p_z_1_by_l_d_1*t476
        + D_p_z_1_by_l_d_1*t582 + mu_1_by_l_d_1*t480 + mu_2_by_l_d_1*t481 + mu_3_by_l_d_1*t481 - t477*t765
        - t478*t766 - t479*t767,
        D_delta_x_2_by_l_d_1*t482 + D_delta_y_2_by_l_d_1*t483 + D_delta_z_2_by_l_d_1*t484
        - D_p_x_1_by_l_d_1*t485 - D_p_x_1_by_l_d_1*t486 + D_p_x_1_by_l_d_1*t583 - D_p_y_1_by_l_d_1*t487
        - D_p_y_1_by_l_d_1*t488 + D_p_y_1_by_l_d_1*t584 - D_p_z_1_by_l_d_1*t489 - D_p_z_1_by_l_d_1*t490
        + D_p_z_1_by_l_d_1*t585 + mu_1_by_l_d_1*t494 + mu_2_by_l_d_1*t495 + mu_3_by_l_d_1*t495 - t491*t765
        - t492*t766 - t493*t767,
        D_delta_x_3_by_l_d_1*t482 + D_delta_y_3_by_l_d_1*t483 + D_delta_z_3_by_l_d_1*t484
        - D_p_x_1_by_l_d_1*t496 - D_p_x_1_by_l_d_1*t497 + D_p_x_1_by_l_d_1*t586 - D_p_y_1_by_l_d_1*t498
        - D_p_y_1_by_l_d_1*t499 + D_p_y_1_by_l_d_1*t587 - D_p_z_1_by_l_d_1*t500 - D_p_z_1_by_l_d_1*t501
        + D_p_z_1_by_l_d_1*t588 + mu_1_by_l_d_1*t505 + mu_2_by_l_d_1*t506 + mu_3_by_l_d_1*t506 - t502*t765
        - t503*t766 - t504*t767,
        D_p_x_1_by_l_d_1*k_C, D_p_y_1_by_l_d_1*k_C, D_p_z_1_by_l_d_1*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_1*k_C - D_p_x_2_by_l_d_1*t624 + 2*D_p_y_2*D_p_y_2_by_l_d_1*k_C
        - D_p_y_2_by_l_d_1*t625 + 2*D_p_z_2*D_p_z_2_by_l_d_1*k_C - D_p_z_2_by_l_d_1*t626
        + mu_1_by_l_d_1*t510 + mu_2_by_l_d_1*t511 + mu_3_by_l_d_1*t510 - t444*t768 - t446*t769 - t448*t770
        - t450*t768 - t451*t769 - t452*t770,
        D_p_x_2*D_p_x_3_by_l_d_1*k_C + D_p_x_2_by_l_d_1*D_p_x_3*k_C - D_p_x_2_by_l_d_1*t456
        - D_p_x_2_by_l_d_1*t457 - D_p_x_2_by_l_d_1*t462 - D_p_x_3_by_l_d_1*t444 - D_p_x_3_by_l_d_1*t445
        - D_p_x_3_by_l_d_1*t450 + D_p_y_2*D_p_y_3_by_l_d_1*k_C + D_p_y_2_by_l_d_1*D_p_y_3*k_C
        - D_p_y_2_by_l_d_1*t458 - D_p_y_2_by_l_d_1*t459 - D_p_y_2_by_l_d_1*t463 - D_p_y_3_by_l_d_1*t446
        - D_p_y_3_by_l_d_1*t447 - D_p_y_3_by_l_d_1*t451 + D_p_z_2*D_p_z_3_by_l_d_1*k_C
        + D_p_z_2_by_l_d_1*D_p_z_3*k_C - D_p_z_2_by_l_d_1*t460 - D_p_z_2_by_l_d_1*t461
        - D_p_z_2_by_l_d_1*t464 - D_p_z_3_by_l_d_1*t448 - D_p_z_3_by_l_d_1*t449 - D_p_z_3_by_l_d_1*t452
        + mu_1_by_l_d_1*t512 + mu_2_by_l_d_1*t513 + mu_3_by_l_d_1*t514,
        D_delta_x_1_by_l_d_1*t520 + D_delta_y_1_by_l_d_1*t521 + D_delta_z_1_by_l_d_1*t522
        - D_p_x_2_by_l_d_1*t471 - D_p_x_2_by_l_d_1*t472 - D_p_x_2_by_l_d_1*t477 + D_p_x_2_by_l_d_1*t580
        - D_p_y_2_by_l_d_1*t473 - D_p_y_2_by_l_d_1*t474 - D_p_y_2_by_l_d_1*t478 + D_p_y_2_by_l_d_1*t581
        - D_p_z_2_by_l_d_1*t475 - D_p_z_2_by_l_d_1*t476 - D_p_z_2_by_l_d_1*t479 + D_p_z_2_by_l_d_1*t582
        + mu_1_by_l_d_1*t518 + mu_2_by_l_d_1*t519 + mu_3_by_l_d_1*t518,
        D_delta_x_2_by_l_d_1*t520 + D_delta_y_2_by_l_d_1*t521 + D_delta_z_2_by_l_d_1*t522
        - D_p_x_2_by_l_d_1*t485 - D_p_x_2_by_l_d_1*t486 - D_p_x_2_by_l_d_1*t491 + D_p_x_2_by_l_d_1*t583
        - D_p_y_2_by_l_d_1*t487 - D_p_y_2_by_l_d_1*t488 - D_p_y_2_by_l_d_1*t492 + D_p_y_2_by_l_d_1*t584
        - D_p_z_2_by_l_d_1*t489 - D_p_z_2_by_l_d_1*t490 - D_p_z_2_by_l_d_1*t493 + D_p_z_2_by_l_d_1*t585
        + mu_1_by_l_d_1*t523 + mu_2_by_l_d_1*t524 + mu_3_by_l_d_1*t523,
        D_delta_x_3_by_l_d_1*t520 + D_delta_y_3_by_l_d_1*t521 + D_delta_z_3_by_l_d_1*t522
        - D_p_x_2_by_l_d_1*t496 - D_p_x_2_by_l_d_1*t497 - D_p_x_2_by_l_d_1*t502 + D_p_x_2_by_l_d_1*t586
        - D_p_y_2_by_l_d_1*t498 - D_p_y_2_by_l_d_1*t499 - D_p_y_2_by_l_d_1*t503 + D_p_y_2_by_l_d_1*t587
        - D_p_z_2_by_l_d_1*t500 - D_p_z_2_by_l_d_1*t501 - D_p_z_2_by_l_d_1*t504 + D_p_z_2_by_l_d_1*t588
        + mu_1_by_l_d_1*t525 + mu_2_by_l_d_1*t526 + mu_3_by_l_d_1*t525,
        D_p_x_2_by_l_d_1*k_C, D_p_y_2_by_l_d_1*k_C, D_p_z_2_by_l_d_1*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_1*k_C - D_p_x_3_by_l_d_1*t685 + 2*D_p_y_3*D_p_y_3_by_l_d_1*k_C
        - D_p_y_3_by_l_d_1*t686 + 2*D_p_z_3*D_p_z_3_by_l_d_1*k_C - D_p_z_3_by_l_d_1*t687
        + mu_1_by_l_d_1*t530 + mu_2_by_l_d_1*t530 + mu_3_by_l_d_1*t531 - t456*t771 - t458*t772 - t460*t773
        - t462*t771 - t463*t772 - t464*t773,
        D_delta_x_1_by_l_d_1*t537 + D_delta_y_1_by_l_d_1*t538 + D_delta_z_1_by_l_d_1*t539
        - D_p_x_3_by_l_d_1*t471 - D_p_x_3_by_l_d_1*t472 - D_p_x_3_by_l_d_1*t477 + D_p_x_3_by_l_d_1*t580
        - D_p_y_3_by_l_d_1*t473 - D_p_y_3_by_l_d_1*t474 - D_p_y_3_by_l_d_1*t478 + D_p_y_3_by_l_d_1*t581
        - D_p_z_3_by_l_d_1*t475 - D_p_z_3_by_l_d_1*t476 - D_p_z_3_by_l_d_1*t479 + D_p_z_3_by_l_d_1*t582
        + mu_1_by_l_d_1*t535 + mu_2_by_l_d_1*t535 + mu_3_by_l_d_1*t536,
        D_delta_x_2_by_l_d_1*t537 + D_delta_y_2_by_l_d_1*t538 + D_delta_z_2_by_l_d_1*t539
        - D_p_x_3_by_l_d_1*t485 - D_p_x_3_by_l_d_1*t486 - D_p_x_3_by_l_d_1*t491 + D_p_x_3_by_l_d_1*t583
        - D_p_y_3_by_l_d_1*t487 - D_p_y_3_by_l_d_1*t488 - D_p_y_3_by_l_d_1*t492 + D_p_y_3_by_l_d_1*t584
        - D_p_z_3_by_l_d_1*t489 - D_p_z_3_by_l_d_1*t490 - D_p_z_3_by_l_d_1*t493 + D_p_z_3_by_l_d_1*t585
        + mu_1_by_l_d_1*t540 + mu_2_by_l_d_1*t540 + mu_3_by_l_d_1*t541,
        D_delta_x_3_by_l_d_1*t537 + D_delta_y_3_by_l_d_1*t538 + D_delta_z_3_by_l_d_1*t539
        - D_p_x_3_by_l_d_1*t496 - D_p_x_3_by_l_d_1*t497 - D_p_x_3_by_l_d_1*t502 + D_p_x_3_by_l_d_1*t586
        - D_p_y_3_by_l_d_1*t498 - D_p_y_3_by_l_d_1*t499 - D_p_y_3_by_l_d_1*t503 + D_p_y_3_by_l_d_1*t587
        - D_p_z_3_by_l_d_1*t500 - D_p_z_3_by_l_d_1*t501 - D_p_z_3_by_l_d_1*t504 + D_p_z_3_by_l_d_1*t588
        + mu_1_by_l_d_1*t542 + mu_2_by_l_d_1*t542 + mu_3_by_l_d_1*t543,
        D_p_x_3_by_l_d_1*k_C, D_p_y_3_by_l_d_1*k_C, D_p_z_3_by_l_d_1*k_C,
        D_delta_x_1_by_l_d_1*t545 + D_delta_y_1_by_l_d_1*t546 + D_delta_z_1_by_l_d_1*t547
        + mu_1_by_l_d_1*t548 - mu_2_by_l_d_1*t544 - mu_3_by_l_d_1*t544,
        D_delta_x_1_by_l_d_1*t550 + D_delta_x_2_by_l_d_1*t551 + D_delta_y_1_by_l_d_1*t552
        + D_delta_y_2_by_l_d_1*t553 + D_delta_z_1_by_l_d_1*t554 + D_delta_z_2_by_l_d_1*t555
        + mu_1_by_l_d_1*t549 + mu_2_by_l_d_1*t549 + mu_3_by_l_d_1*t549,
        D_delta_x_1_by_l_d_1*t557 + D_delta_x_3_by_l_d_1*t551 + D_delta_y_1_by_l_d_1*t558
        + D_delta_y_3_by_l_d_1*t553 + D_delta_z_1_by_l_d_1*t559 + D_delta_z_3_by_l_d_1*t555
        + mu_1_by_l_d_1*t556 + mu_2_by_l_d_1*t556 + mu_3_by_l_d_1*t556,
        D_delta_x_1_by_l_d_1*k_C, D_delta_y_1_by_l_d_1*k_C, D_delta_z_1_by_l_d_1*k_C,
        D_delta_x_2_by_l_d_1*t561 + D_delta_y_2_by_l_d_1*t562 + D_delta_z_2_by_l_d_1*t563
        - mu_1_by_l_d_1*t560 + mu_2_by_l_d_1*t564 - mu_3_by_l_d_1*t560,
        D_delta_x_2_by_l_d_1*t557 + D_delta_x_3_by_l_d_1*t550 + D_delta_y_2_by_l_d_1*t558
        + D_delta_y_3_by_l_d_1*t552 + D_delta_z_2_by_l_d_1*t559 + D_delta_z_3_by_l_d_1*t554
        + mu_1_by_l_d_1*t565 + mu_2_by_l_d_1*t565 + mu_3_by_l_d_1*t565,
        D_delta_x_2_by_l_d_1*k_C, D_delta_y_2_by_l_d_1*k_C, D_delta_z_2_by_l_d_1*k_C,
        D_delta_x_3_by_l_d_1*t567 + D_delta_y_3_by_l_d_1*t568 + D_delta_z_3_by_l_d_1*t569
        - mu_1_by_l_d_1*t566 - mu_2_by_l_d_1*t566 + mu_3_by_l_d_1*t570,
        D_delta_x_3_by_l_d_1*k_C, D_delta_y_3_by_l_d_1*k_C, D_delta_z_3_by_l_d_1*k_C,
        2*D_p_x_1*D_p_x_1_by_l_d_2*k_C - D_p_x_1_by_l_d_2*t427 + 2*D_p_y_1*D_p_y_1_by_l_d_2*k_C
        - D_p_y_1_by_l_d_2*t430 + 2*D_p_z_1*D_p_z_1_by_l_d_2*k_C - D_p_z_1_by_l_d_2*t433
        + mu_1_by_l_d_2*t443 + mu_2_by_l_d_2*t435 + mu_3_by_l_d_2*t435 - t412*t774 - t413*t774 - t416*t775
        - t417*t775 - t420*t776 - t421*t776,
        D_p_x_1*D_p_x_2_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_2*k_C - D_p_x_1_by_l_d_2*t444
        - D_p_x_1_by_l_d_2*t445 - D_p_x_1_by_l_d_2*t450 - D_p_x_2_by_l_d_2*t413 - D_p_x_2_by_l_d_2*t426
        + D_p_y_1*D_p_y_2_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_2*k_C - D_p_y_1_by_l_d_2*t446
        - D_p_y_1_by_l_d_2*t447 - D_p_y_1_by_l_d_2*t451 - D_p_y_2_by_l_d_2*t417 - D_p_y_2_by_l_d_2*t429
        + D_p_z_1*D_p_z_2_by_l_d_2*k_C + D_p_z_1_by_l_d_2*D_p_z_2*k_C - D_p_z_1_by_l_d_2*t448
        - D_p_z_1_by_l_d_2*t449 - D_p_z_1_by_l_d_2*t452 - D_p_z_2_by_l_d_2*t421 - D_p_z_2_by_l_d_2*t432
        + mu_1_by_l_d_2*t453 + mu_2_by_l_d_2*t454 + mu_3_by_l_d_2*t455 - t412*t777 - t416*t778 - t420*t779,
        D_p_x_1*D_p_x_3_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_3*k_C - D_p_x_1_by_l_d_2*t456
        - D_p_x_1_by_l_d_2*t457 - D_p_x_1_by_l_d_2*t462 - D_p_x_3_by_l_d_2*t412 - D_p_x_3_by_l_d_2*t413
        - D_p_x_3_by_l_d_2*t426 + D_p_y_1*D_p_y_3_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_3*k_C
        - D_p_y_1_by_l_d_2*t458 - D_p_y_1_by_l_d_2*t459 - D_p_y_1_by_l_d_2*t463 - D_p_y_3_by_l_d_2*t416
        - D_p_y_3_by_l_d_2*t417 - D_p_y_3_by_l_d_2*t429 + D_p_z_1*D_p_z_3_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_3*k_C - D_p_z_1_by_l_d_2*t460 - D_p_z_1_by_l_d_2*t461
        - D_p_z_1_by_l_d_2*t464 - D_p_z_3_by_l_d_2*t420 - D_p_z_3_by_l_d_2*t421 - D_p_z_3_by_l_d_2*t432
        + mu_1_by_l_d_2*t465 + mu_2_by_l_d_2*t466 + mu_3_by_l_d_2*t467,
        D_delta_x_1_by_l_d_2*t482 + D_delta_y_1_by_l_d_2*t483 + D_delta_z_1_by_l_d_2*t484
        - D_p_x_1_by_l_d_2*t471 - D_p_x_1_by_l_d_2*t472 - D_p_x_1_by_l_d_2*t477 + D_p_x_1_by_l_d_2*t580
        - D_p_y_1_by_l_d_2*t473 - D_p_y_1_by_l_d_2*t474 - D_p_y_1_by_l_d_2*t478 + D_p_y_1_by_l_d_2*t581
        - D_p_z_1_by_l_d_2*t475 - D_p_z_1_by_l_d_2*t476 - D_p_z_1_by_l_d_2*t479 + D_p_z_1_by_l_d_2*t582
        + mu_1_by_l_d_2*t480 + mu_2_by_l_d_2*t481 + mu_3_by_l_d_2*t481,
        D_delta_x_2_by_l_d_2*t482 + D_delta_y_2_by_l_d_2*t483 + D_delta_z_2_by_l_d_2*t484
        - D_p_x_1_by_l_d_2*t485 - D_p_x_1_by_l_d_2*t486 - D_p_x_1_by_l_d_2*t491 + D_p_x_1_by_l_d_2*t583
        - D_p_y_1_by_l_d_2*t487 - D_p_y_1_by_l_d_2*t488 - D_p_y_1_by_l_d_2*t492 + D_p_y_1_by_l_d_2*t584
        - D_p_z_1_by_l_d_2*t489 - D_p_z_1_by_l_d_2*t490 - D_p_z_1_by_l_d_2*t493 + D_p_z_1_by_l_d_2*t585
        + mu_1_by_l_d_2*t494 + mu_2_by_l_d_2*t495 + mu_3_by_l_d_2*t495,
        D_delta_x_3_by_l_d_2*t482 + D_delta_y_3_by_l_d_2*t483 + D_delta_z_3_by_l_d_2*t484
        - D_p_x_1_by_l_d_2*t496 - D_p_x_1_by_l_d_2*t497 - D_p_x_1_by_l_d_2*t502 + D_p_x_1_by_l_d_2*t586
        - D_p_y_1_by_l_d_2*t498 - D_p_y_1_by_l_d_2*t499 - D_p_y_1_by_l_d_2*t503 + D_p_y_1_by_l_d_2*t587
        - D_p_z_1_by_l_d_2*t500 - D_p_z_1_by_l_d_2*t501 - D_p_z_1_by_l_d_2*t504 + D_p_z_1_by_l_d_2*t588
        + mu_1_by_l_d_2*t505 + mu_2_by_l_d_2*t506 + mu_3_by_l_d_2*t506,
        D_p_x_1_by_l_d_2*k_C, D_p_y_1_by_l_d_2*k_C, D_p_z_1_by_l_d_2*k_C,
        mu_1_by_l_d_2*t510 + mu_2_by_l_d_2*t511 + mu_3_by_l_d_2*t510 - t444*t780 - t446*t781 - t448*t782
        - t450*t780 - t451*t781 - t452*t782 + t615*t780 + t617*t781 + t619*t782 + t622*t783 + t623*t783
        - t624*t777 - t625*t778 - t626*t779 + t630*theta_2_by_l_d_2 + t632*theta_2_by_l_d_2
        + t634*theta_2_by_l_d_2 + t648*t783,
        D_p_x_2*D_p_x_3_by_l_d_2*k_C + D_p_x_2_by_l_d_2*D_p_x_3*k_C - D_p_x_2_by_l_d_2*t457
        - D_p_x_2_by_l_d_2*t462 - D_p_x_3_by_l_d_2*t444 - D_p_x_3_by_l_d_2*t445 - D_p_x_3_by_l_d_2*t450
        + D_p_y_2*D_p_y_3_by_l_d_2*k_C + D_p_y_2_by_l_d_2*D_p_y_3*k_C - D_p_y_2_by_l_d_2*t459
        - D_p_y_2_by_l_d_2*t463 - D_p_y_3_by_l_d_2*t446 - D_p_y_3_by_l_d_2*t447 - D_p_y_3_by_l_d_2*t451
        + D_p_z_2*D_p_z_3_by_l_d_2*k_C + D_p_z_2_by_l_d_2*D_p_z_3*k_C - D_p_z_2_by_l_d_2*t461
        - D_p_z_2_by_l_d_2*t464 - D_p_z_3_by_l_d_2*t448 - D_p_z_3_by_l_d_2*t449 - D_p_z_3_by_l_d_2*t452
        + mu_1_by_l_d_2*t512 + mu_2_by_l_d_2*t513 + mu_3_by_l_d_2*t514 - t456*t777 - t458*t778 - t460*t779,
        D_delta_x_1_by_l_d_2*t520 + D_delta_y_1_by_l_d_2*t521 + D_delta_z_1_by_l_d_2*t522
        - D_p_x_2_by_l_d_2*t472 - D_p_x_2_by_l_d_2*t477 + D_p_x_2_by_l_d_2*t580 - D_p_y_2_by_l_d_2*t474
        - D_p_y_2_by_l_d_2*t478 + D_p_y_2_by_l_d_2*t581 - D_p_z_2_by_l_d_2*t476 - D_p_z_2_by_l_d_2*t479
        + D_p_z_2_by_l_d_2*t582 + mu_1_by_l_d_2*t518 + mu_2_by_l_d_2*t519 + mu_3_by_l_d_2*t518 - t471*t777
        - t473*t778 - t475*t779,
        D_delta_x_2_by_l_d_2*t520 + D_delta_y_2_by_l_d_2*t521 + D_delta_z_2_by_l_d_2*t522
        - D_p_x_2_by_l_d_2*t486 - D_p_x_2_by_l_d_2*t491 + D_p_x_2_by_l_d_2*t583 - D_p_y_2_by_l_d_2*t488
        - D_p_y_2_by_l_d_2*t492 + D_p_y_2_by_l_d_2*t584 - D_p_z_2_by_l_d_2*t490 - D_p_z_2_by_l_d_2*t493
        + D_p_z_2_by_l_d_2*t585 + mu_1_by_l_d_2*t523 + mu_2_by_l_d_2*t524 + mu_3_by_l_d_2*t523 - t485*t777
        - t487*t778 - t489*t779,
        D_delta_x_3_by_l_d_2*t520 + D_delta_y_3_by_l_d_2*t521 + D_delta_z_3_by_l_d_2*t522
        - D_p_x_2_by_l_d_2*t497 - D_p_x_2_by_l_d_2*t502 + D_p_x_2_by_l_d_2*t586 - D_p_y_2_by_l_d_2*t499
        - D_p_y_2_by_l_d_2*t503 + D_p_y_2_by_l_d_2*t587 - D_p_z_2_by_l_d_2*t501 - D_p_z_2_by_l_d_2*t504
        + D_p_z_2_by_l_d_2*t588 + mu_1_by_l_d_2*t525 + mu_2_by_l_d_2*t526 + mu_3_by_l_d_2*t525 - t496*t777
        - t498*t778 - t500*t779,
        D_p_x_2_by_l_d_2*k_C, D_p_y_2_by_l_d_2*k_C, D_p_z_2_by_l_d_2*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_2*k_C - D_p_x_3_by_l_d_2*t685 + 2*D_p_y_3*D_p_y_3_by_l_d_2*k_C
        - D_p_y_3_by_l_d_2*t686 + 2*D_p_z_3*D_p_z_3_by_l_d_2*k_C - D_p_z_3_by_l_d_2*t687
        + mu_1_by_l_d_2*t530 + mu_2_by_l_d_2*t530 + mu_3_by_l_d_2*t531 - t456*t784 - t458*t785 - t460*t786
        - t462*t784 - t463*t785 - t464*t786,
        D_delta_x_1_by_l_d_2*t537 + D_delta_y_1_by_l_d_2*t538 + D_delta_z_1_by_l_d_2*t539
        - D_p_x_3_by_l_d_2*t471 - D_p_x_3_by_l_d_2*t472 - D_p_x_3_by_l_d_2*t477 + D_p_x_3_by_l_d_2*t580
        - D_p_y_3_by_l_d_2*t473 - D_p_y_3_by_l_d_2*t474 - D_p_y_3_by_l_d_2*t478 + D_p_y_3_by_l_d_2*t581
        - D_p_z_3_by_l_d_2*t475 - D_p_z_3_by_l_d_2*t476 - D_p_z_3_by_l_d_2*t479 + D_p_z_3_by_l_d_2*t582
        + mu_1_by_l_d_2*t535 + mu_2_by_l_d_2*t535 + mu_3_by_l_d_2*t536,
        D_delta_x_2_by_l_d_2*t537 + D_delta_y_2_by_l_d_2*t538 + D_delta_z_2_by_l_d_2*t539
        - D_p_x_3_by_l_d_2*t485 - D_p_x_3_by_l_d_2*t486 - D_p_x_3_by_l_d_2*t491 + D_p_x_3_by_l_d_2*t583
        - D_p_y_3_by_l_d_2*t487 - D_p_y_3_by_l_d_2*t488 - D_p_y_3_by_l_d_2*t492 + D_p_y_3_by_l_d_2*t584
        - D_p_z_3_by_l_d_2*t489 - D_p_z_3_by_l_d_2*t490 - D_p_z_3_by_l_d_2*t493 + D_p_z_3_by_l_d_2*t585
        + mu_1_by_l_d_2*t540 + mu_2_by_l_d_2*t540 + mu_3_by_l_d_2*t541,
        D_delta_x_3_by_l_d_2*t537 + D_delta_y_3_by_l_d_2*t538 + D_delta_z_3_by_l_d_2*t539
        - D_p_x_3_by_l_d_2*t496 - D_p_x_3_by_l_d_2*t497 - D_p_x_3_by_l_d_2*t502 + D_p_x_3_by_l_d_2*t586
        - D_p_y_3_by_l_d_2*t498 - D_p_y_3_by_l_d_2*t499 - D_p_y_3_by_l_d_2*t503 + D_p_y_3_by_l_d_2*t587
        - D_p_z_3_by_l_d_2*t500 - D_p_z_3_by_l_d_2*t501 - D_p_z_3_by_l_d_2*t504 + D_p_z_3_by_l_d_2*t588
        + mu_1_by_l_d_2*t542 + mu_2_by_l_d_2*t542 + mu_3_by_l_d_2*t543,
        D_p_x_3_by_l_d_2*k_C, D_p_y_3_by_l_d_2*k_C, D_p_z_3_by_l_d_2*k_C,
        D_delta_x_1_by_l_d_2*t545 + D_delta_y_1_by_l_d_2*t546 + D_delta_z_1_by_l_d_2*t547
        + mu_1_by_l_d_2*t548 - mu_2_by_l_d_2*t544 - mu_3_by_l_d_2*t544,
        D_delta_x_1_by_l_d_2*t550 + D_delta_x_2_by_l_d_2*t551 + D_delta_y_1_by_l_d_2*t552
        + D_delta_y_2_by_l_d_2*t553 + D_delta_z_1_by_l_d_2*t554 + D_delta_z_2_by_l_d_2*t555
        + mu_1_by_l_d_2*t549 + mu_2_by_l_d_2*t549 + mu_3_by_l_d_2*t549,
        D_delta_x_1_by_l_d_2*t557 + D_delta_x_3_by_l_d_2*t551 + D_delta_y_1_by_l_d_2*t558
        + D_delta_y_3_by_l_d_2*t553 + D_delta_z_1_by_l_d_2*t559 + D_delta_z_3_by_l_d_2*t555
        + mu_1_by_l_d_2*t556 + mu_2_by_l_d_2*t556 + mu_3_by_l_d_2*t556,
        D_delta_x_1_by_l_d_2*k_C, D_delta_y_1_by_l_d_2*k_C, D_delta_z_1_by_l_d_2*k_C,
        D_delta_x_2_by_l_d_2*t561 + D_delta_y_2_by_l_d_2*t562 + D_delta_z_2_by_l_d_2*t563
        - mu_1_by_l_d_2*t560 + mu_2_by_l_d_2*t564 - mu_3_by_l_d_2*t560,
        D_delta_x_2_by_l_d_2*t557 + D_delta_x_3_by_l_d_2*t550 + D_delta_y_2_by_l_d_2*t558
        + D_delta_y_3_by_l_d_2*t552 + D_delta_z_2_by_l_d_2*t559 + D_delta_z_3_by_l_d_2*t554
        + mu_1_by_l_d_2*t565 + mu_2_by_l_d_2*t565 + mu_3_by_l_d_2*t565,
        D_delta_x_2_by_l_d_2*k_C, D_delta_y_2_by_l_d_2*k_C, D_delta_z_2_by_l_d_2*k_C,
        D_delta_x_3_by_l_d_2*t567 + D_delta_y_3_by_l_d_2*t568 + D_delta_z_3_by_l_d_2*t569
        - mu_1_by_l_d_2*t566 - mu_2_by_l_d_2*t566 + mu_3_by_l_d_2*t570,
        D_delta_x_3_by_l_d_2*k_C, D_delta_y_3_by_l_d_2*k_C, D_delta_z_3_by_l_d_2*k_C,
        2*D_p_x_1*D_p_x_1_by_l_d_3*k_C - D_p_x_1_by_l_d_3*t427 + 2*D_p_y_1*D_p_y_1_by_l_d_3*k_C
        - D_p_y_1_by_l_d_3*t430 + 2*D_p_z_1*D_p_z_1_by_l_d_3*k_C - D_p_z_1_by_l_d_3*t433
        + mu_1_by_l_d_3*t443 + mu_2_by_l_d_3*t435 + mu_3_by_l_d_3*t435 - t412*t787 - t413*t787 - t416*t788
        - t417*t788 - t420*t789 - t421*t789,
        D_p_x_1*D_p_x_2_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_2*k_C - D_p_x_1_by_l_d_3*t444
        - D_p_x_1_by_l_d_3*t445 - D_p_x_1_by_l_d_3*t450 - D_p_x_2_by_l_d_3*t412 - D_p_x_2_by_l_d_3*t413
        - D_p_x_2_by_l_d_3*t426 + D_p_y_1*D_p_y_2_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_2*k_C
        - D_p_y_1_by_l_d_3*t446 - D_p_y_1_by_l_d_3*t447 - D_p_y_1_by_l_d_3*t451 - D_p_y_2_by_l_d_3*t416
        - D_p_y_2_by_l_d_3*t417 - D_p_y_2_by_l_d_3*t429 + D_p_z_1*D_p_z_2_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_2*k_C - D_p_z_1_by_l_d_3*t448 - D_p_z_1_by_l_d_3*t449
        - D_p_z_1_by_l_d_3*t452 - D_p_z_2_by_l_d_3*t420 - D_p_z_2_by_l_d_3*t421 - D_p_z_2_by_l_d_3*t432
        + mu_1_by_l_d_3*t453 + mu_2_by_l_d_3*t454 + mu_3_by_l_d_3*t455,
        D_p_x_1*D_p_x_3_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_3*k_C - D_p_x_1_by_l_d_3*t456
        - D_p_x_1_by_l_d_3*t457 - D_p_x_1_by_l_d_3*t462 - D_p_x_3_by_l_d_3*t412 - D_p_x_3_by_l_d_3*t426
        + D_p_y_1*D_p_y_3_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_3*k_C - D_p_y_1_by_l_d_3*t458
        - D_p_y_1_by_l_d_3*t459 - D_p_y_1_by_l_d_3*t463 - D_p_y_3_by_l_d_3*t416 - D_p_y_3_by_l_d_3*t429
        + D_p_z_1*D_p_z_3_by_l_d_3*k_C + D_p_z_1_by_l_d_3*D_p_z_3*k_C - D_p_z_1_by_l_d_3*t460
        - D_p_z_1_by_l_d_3*t461 - D_p_z_1_by_l_d_3*t464 - D_p_z_3_by_l_d_3*t420 - D_p_z_3_by_l_d_3*t432
        + mu_1_by_l_d_3*t465 + mu_2_by_l_d_3*t466 + mu_3_by_l_d_3*t467 - t413*t790 - t417*t791 - t421*t792,
        D_delta_x_1_by_l_d_3*t482 + D_delta_y_1_by_l_d_3*t483 + D_delta_z_1_by_l_d_3*t484
        - D_p_x_1_by_l_d_3*t471 - D_p_x_1_by_l_d_3*t472 - D_p_x_1_by_l_d_3*t477 + D_p_x_1_by_l_d_3*t580
        - D_p_y_1_by_l_d_3*t473 - D_p_y_1_by_l_d_3*t474 - D_p_y_1_by_l_d_3*t478 + D_p_y_1_by_l_d_3*t581
        - D_p_z_1_by_l_d_3*t475 - D_p_z_1_by_l_d_3*t476 - D_p_z_1_by_l_d_3*t479 + D_p_z_1_by_l_d_3*t582
        + mu_1_by_l_d_3*t480 + mu_2_by_l_d_3*t481 + mu_3_by_l_d_3*t481,
        D_delta_x_2_by_l_d_3*t482 + D_delta_y_2_by_l_d_3*t483 + D_delta_z_2_by_l_d_3*t484
        - D_p_x_1_by_l_d_3*t485 - D_p_x_1_by_l_d_3*t486 - D_p_x_1_by_l_d_3*t491 + D_p_x_1_by_l_d_3*t583
        - D_p_y_1_by_l_d_3*t487 - D_p_y_1_by_l_d_3*t488 - D_p_y_1_by_l_d_3*t492 + D_p_y_1_by_l_d_3*t584
        - D_p_z_1_by_l_d_3*t489 - D_p_z_1_by_l_d_3*t490 - D_p_z_1_by_l_d_3*t493 + D_p_z_1_by_l_d_3*t585
        + mu_1_by_l_d_3*t494 + mu_2_by_l_d_3*t495 + mu_3_by_l_d_3*t495,
        D_delta_x_3_by_l_d_3*t482 + D_delta_y_3_by_l_d_3*t483 + D_delta_z_3_by_l_d_3*t484
        - D_p_x_1_by_l_d_3*t496 - D_p_x_1_by_l_d_3*t497 - D_p_x_1_by_l_d_3*t502 + D_p_x_1_by_l_d_3*t586
        - D_p_y_1_by_l_d_3*t498 - D_p_y_1_by_l_d_3*t499 - D_p_y_1_by_l_d_3*t503 + D_p_y_1_by_l_d_3*t587
        - D_p_z_1_by_l_d_3*t500 - D_p_z_1_by_l_d_3*t501 - D_p_z_1_by_l_d_3*t504 + D_p_z_1_by_l_d_3*t588
        + mu_1_by_l_d_3*t505 + mu_2_by_l_d_3*t506 + mu_3_by_l_d_3*t506,
        D_p_x_1_by_l_d_3*k_C, D_p_y_1_by_l_d_3*k_C, D_p_z_1_by_l_d_3*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_3*k_C - D_p_x_2_by_l_d_3*t624 + 2*D_p_y_2*D_p_y_2_by_l_d_3*k_C
        - D_p_y_2_by_l_d_3*t625 + 2*D_p_z_2*D_p_z_2_by_l_d_3*k_C - D_p_z_2_by_l_d_3*t626
        + mu_1_by_l_d_3*t510 + mu_2_by_l_d_3*t511 + mu_3_by_l_d_3*t510 - t444*t793 - t446*t794 - t448*t795
        - t450*t793 - t451*t794 - t452*t795,
        D_p_x_2*D_p_x_3_by_l_d_3*k_C + D_p_x_2_by_l_d_3*D_p_x_3*k_C - D_p_x_2_by_l_d_3*t456
        - D_p_x_2_by_l_d_3*t457 - D_p_x_2_by_l_d_3*t462 - D_p_x_3_by_l_d_3*t445 - D_p_x_3_by_l_d_3*t450
        + D_p_y_2*D_p_y_3_by_l_d_3*k_C + D_p_y_2_by_l_d_3*D_p_y_3*k_C - D_p_y_2_by_l_d_3*t458
        - D_p_y_2_by_l_d_3*t459 - D_p_y_2_by_l_d_3*t463 - D_p_y_3_by_l_d_3*t447 - D_p_y_3_by_l_d_3*t451
        + D_p_z_2*D_p_z_3_by_l_d_3*k_C + D_p_z_2_by_l_d_3*D_p_z_3*k_C - D_p_z_2_by_l_d_3*t460
        - D_p_z_2_by_l_d_3*t461 - D_p_z_2_by_l_d_3*t464 - D_p_z_3_by_l_d_3*t449 - D_p_z_3_by_l_d_3*t452
        + mu_1_by_l_d_3*t512 + mu_2_by_l_d_3*t513 + mu_3_by_l_d_3*t514 - t444*t790 - t446*t791 - t448*t792,
        D_delta_x_1_by_l_d_3*t520 + D_delta_y_1_by_l_d_3*t521 + D_delta_z_1_by_l_d_3*t522
        - D_p_x_2_by_l_d_3*t471 - D_p_x_2_by_l_d_3*t472 - D_p_x_2_by_l_d_3*t477 + D_p_x_2_by_l_d_3*t580
        - D_p_y_2_by_l_d_3*t473 - D_p_y_2_by_l_d_3*t474 - D_p_y_2_by_l_d_3*t478 + D_p_y_2_by_l_d_3*t581
        - D_p_z_2_by_l_d_3*t475 - D_p_z_2_by_l_d_3*t476 - D_p_z_2_by_l_d_3*t479 + D_p_z_2_by_l_d_3*t582
        + mu_1_by_l_d_3*t518 + mu_2_by_l_d_3*t519 + mu_3_by_l_d_3*t518,
        D_delta_x_2_by_l_d_3*t520 + D_delta_y_2_by_l_d_3*t521 + D_delta_z_2_by_l_d_3*t522
        - D_p_x_2_by_l_d_3*t485 - D_p_x_2_by_l_d_3*t486 - D_p_x_2_by_l_d_3*t491 + D_p_x_2_by_l_d_3*t583
        - D_p_y_2_by_l_d_3*t487 - D_p_y_2_by_l_d_3*t488 - D_p_y_2_by_l_d_3*t492 + D_p_y_2_by_l_d_3*t584
        - D_p_z_2_by_l_d_3*t489 - D_p_z_2_by_l_d_3*t490 - D_p_z_2_by_l_d_3*t493 + D_p_z_2_by_l_d_3*t585
        + mu_1_by_l_d_3*t523 + mu_2_by_l_d_3*t524 + mu_3_by_l_d_3*t523,
        D_delta_x_3_by_l_d_3*t520 + D_delta_y_3_by_l_d_3*t521 + D_delta_z_3_by_l_d_3*t522
        - D_p_x_2_by_l_d_3*t496 - D_p_x_2_by_l_d_3*t497 - D_p_x_2_by_l_d_3*t502 + D_p_x_2_by_l_d_3*t586
        - D_p_y_2_by_l_d_3*t498 - D_p_y_2_by_l_d_3*t499 - D_p_y_2_by_l_d_3*t503 + D_p_y_2_by_l_d_3*t587
        - D_p_z_2_by_l_d_3*t500 - D_p_z_2_by_l_d_3*t501 - D_p_z_2_by_l_d_3*t504 + D_p_z_2_by_l_d_3*t588
        + mu_1_by_l_d_3*t525 + mu_2_by_l_d_3*t526 + mu_3_by_l_d_3*t525,
        D_p_x_2_by_l_d_3*k_C, D_p_y_2_by_l_d_3*k_C, D_p_z_2_by_l_d_3*k_C,
        mu_1_by_l_d_3*t530 + mu_2_by_l_d_3*t530 + mu_3_by_l_d_3*t531 - t456*t796 - t458*t797 - t460*t798
        - t462*t796 - t463*t797 - t464*t798 + t676*t796 + t678*t797 + t680*t798 + t683*t799 + t684*t799
        - t685*t790 - t686*t791 - t687*t792 + t691*theta_3_by_l_d_3 + t693*theta_3_by_l_d_3
        + t695*theta_3_by_l_d_3 + t709*t799,
        D_delta_x_1_by_l_d_3*t537 + D_delta_y_1_by_l_d_3*t538 + D_delta_z_1_by_l_d_3*t539
        - D_p_x_3_by_l_d_3*t471 - D_p_x_3_by_l_d_3*t477 + D_p_x_3_by_l_d_3*t580 - D_p_y_3_by_l_d_3*t473
        - D_p_y_3_by_l_d_3*t478 + D_p_y_3_by_l_d_3*t581 - D_p_z_3_by_l_d_3*t475 - D_p_z_3_by_l_d_3*t479
        + D_p_z_3_by_l_d_3*t582 + mu_1_by_l_d_3*t535 + mu_2_by_l_d_3*t535 + mu_3_by_l_d_3*t536 - t472*t790
        - t474*t791 - t476*t792,
        D_delta_x_2_by_l_d_3*t537 + D_delta_y_2_by_l_d_3*t538 + D_delta_z_2_by_l_d_3*t539
        - D_p_x_3_by_l_d_3*t485 - D_p_x_3_by_l_d_3*t491 + D_p_x_3_by_l_d_3*t583 - D_p_y_3_by_l_d_3*t487
        - D_p_y_3_by_l_d_3*t492 + D_p_y_3_by_l_d_3*t584 - D_p_z_3_by_l_d_3*t489 - D_p_z_3_by_l_d_3*t493
        + D_p_z_3_by_l_d_3*t585 + mu_1_by_l_d_3*t540 + mu_2_by_l_d_3*t540 + mu_3_by_l_d_3*t541 - t486*t790
        - t488*t791 - t490*t792,
        D_delta_x_3_by_l_d_3*t537 + D_delta_y_3_by_l_d_3*t538 + D_delta_z_3_by_l_d_3*t539
        - D_p_x_3_by_l_d_3*t496 - D_p_x_3_by_l_d_3*t502 + D_p_x_3_by_l_d_3*t586 - D_p_y_3_by_l_d_3*t498
        - D_p_y_3_by_l_d_3*t503 + D_p_y_3_by_l_d_3*t587 - D_p_z_3_by_l_d_3*t500 - D_p_z_3_by_l_d_3*t504
        + D_p_z_3_by_l_d_3*t588 + mu_1_by_l_d_3*t542 + mu_2_by_l_d_3*t542 + mu_3_by_l_d_3*t543 - t497*t790
        - t499*t791 - t501*t792,
        D_p_x_3_by_l_d_3*k_C, D_p_y_3_by_l_d_3*k_C, D_p_z_3_by_l_d_3*k_C,
        D_delta_x_1_by_l_d_3*t545 + D_delta_y_1_by_l_d_3*t546 + D_delta_z_1_by_l_d_3*t547
        + mu_1_by_l_d_3*t548 - mu_2_by_l_d_3*t544 - mu_3_by_l_d_3*t544,
        D_delta_x_1_by_l_d_3*t550 + D_delta_x_2_by_l_d_3*t551 + D_delta_y_1_by_l_d_3*t552
        + D_delta_y_2_by_l_d_3*t553 + D_delta_z_1_by_l_d_3*t554 + D_delta_z_2_by_l_d_3*t555
        + mu_1_by_l_d_3*t549 + mu_2_by_l_d_3*t549 + mu_3_by_l_d_3*t549,
        D_delta_x_1_by_l_d_3*t557 + D_delta_x_3_by_l_d_3*t551 + D_delta_y_1_by_l_d_3*t558
        + D_delta_y_3_by_l_d_3*t553 + D_delta_z_1_by_l_d_3*t559 + D_delta_z_3_by_l_d_3*t555
        + mu_1_by_l_d_3*t556 + mu_2_by_l_d_3*t556 + mu_3_by_l_d_3*t556,
        D_delta_x_1_by_l_d_3*k_C, D_delta_y_1_by_l_d_3*k_C, D_delta_z_1_by_l_d_3*k_C,
        D_delta_x_2_by_l_d_3*t561 + D_delta_y_2_by_l_d_3*t562 + D_delta_z_2_by_l_d_3*t563
        - mu_1_by_l_d_3*t560 + mu_2_by_l_d_3*t564 - mu_3_by_l_d_3*t560,
        D_delta_x_2_by_l_d_3*t557 + D_delta_x_3_by_l_d_3*t550 + D_delta_y_2_by_l_d_3*t558
        + D_delta_y_3_by_l_d_3*t552 + D_delta_z_2_by_l_d_3*t559 + D_delta_z_3_by_l_d_3*t554
        + mu_1_by_l_d_3*t565 + mu_2_by_l_d_3*t565 + mu_3_by_l_d_3*t565,
        D_delta_x_2_by_l_d_3*k_C, D_delta_y_2_by_l_d_3*k_C, D_delta_z_2_by_l_d_3*k_C,
        D_delta_x_3_by_l_d_3*t567 + D_delta_y_3_by_l_d_3*t568 + D_delta_z_3_by_l_d_3*t569
        - mu_1_by_l_d_3*t566 - mu_2_by_l_d_3*t566 + mu_3_by_l_d_3*t570,
        D_delta_x_3_by_l_d_3*k_C, D_delta_y_3_by_l_d_3*k_C, D_delta_z_3_by_l_d_3*k_C,
    ))
    return M_theta_out, K_theta_out
