# Generated from the derivation of linear_delta and the catalogue of effects.
# By pkmodes_derive 0.1.0 with SymPy 1.14.0.
# Do not edit: regenerate with `python -m pkmodes_derive generate`.
"""Dynamics of the mechanism linear_delta with effects: extended matrices and sensitivities.

Arrays are batch first: a leading `...` stands for any batch shape, none included, and arguments broadcast.
Complex arguments are accepted (for derivatives by complex step).  Everything is in SI units and in the base
frame; V is potential energy, forces are -dV/dq, and K is positive for a restoring force.

Names in the code, for axis j, pulley or span k (or carriage k, l of a derivative) and component i = x, y, z;
t1, t2, ... are subexpressions that several values share:

* x_j [m]: position of carriage j along its rail
* r_j_i [m]: platform joint j seen from the origin of rail j, component i
* s_j_i [m]: linkage vector j, from carriage to platform joint, component i
* a_j [m]: coordinate of platform joint j along rail j
* w_j_i [m]: vector from rail j to platform joint j, perpendicular to it, component i
* w2_j [m^2]: squared distance of platform joint j from rail j
* tau_st_j [N m]: static torque on the driven pulley of axis j
* I_j_k [kg m^2]: moment of inertia of pulley k of axis j, with the motor where it is driven
* l_f_j_k [m]: free length of span k of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_k [N/m]: stiffness of span k of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* D_r_j [m]: entry of D_r for axis j: linkage vector along the motion of its joint
* A_i_j [m^2]: adjugate of D_l, entry i, j
* det_D_l [m^3]: determinant of D_l
* D_p_i_k [1]: platform Jacobian, dp_i/dx_k
* D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
* U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
* mu_j [N/m]: static force in linkage j divided by its length, positive in compression
* G_j [N]: gradient of the gravitational potential energy with respect to x_j
* det_j [N^2 m]: determinant of the equilibrium of axis j
* theta_j_k_st [rad]: static rotation of pulley k of axis j, from unstrained transmissions
* mu_1_by_m_p [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: platform mass
* mu_2_by_m_p [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: platform mass
* mu_3_by_m_p [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: platform mass
* mu_1_by_g_x [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: gravitational acceleration, component x
* mu_2_by_g_x [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: gravitational acceleration, component x
* mu_3_by_g_x [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: gravitational acceleration, component x
* mu_1_by_g_y [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: gravitational acceleration, component y
* mu_2_by_g_y [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: gravitational acceleration, component y
* mu_3_by_g_y [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: gravitational acceleration, component y
* mu_1_by_g_z [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: gravitational acceleration, component z
* mu_2_by_g_z [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: gravitational acceleration, component z
* mu_3_by_g_z [(N/m)/(m/s^2)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: gravitational acceleration, component z
* mu_1_by_m_d_1 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: mass of linkage 1, both rods together
* mu_2_by_m_d_1 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: mass of linkage 1, both rods together
* mu_3_by_m_d_1 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: mass of linkage 1, both rods together
* mu_1_by_m_d_2 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: mass of linkage 2, both rods together
* mu_2_by_m_d_2 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: mass of linkage 2, both rods together
* mu_3_by_m_d_2 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: mass of linkage 2, both rods together
* mu_1_by_m_d_3 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: mass of linkage 3, both rods together
* mu_2_by_m_d_3 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: mass of linkage 3, both rods together
* mu_3_by_m_d_3 [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: mass of linkage 3, both rods together
* mu_1_by_m_L [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: point mass at the platform centre
* mu_2_by_m_L [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: point mass at the platform centre
* mu_3_by_m_L [(N/m)/(kg)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: point mass at the platform centre
* x_1_by_b_1_x [(m)/(m)]: derivative at a fixed pose of: position of carriage 1 along its rail; by: joint 1 of
    the platform seen from its centre, component x
* s_1_x_by_b_1_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component x; by: joint 1 of the platform seen from its centre, component x
* s_1_y_by_b_1_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component y; by: joint 1 of the platform seen from its centre, component x
* s_1_z_by_b_1_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component z; by: joint 1 of the platform seen from its centre, component x
* D_p_x_1_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 1 of the
    platform seen from its centre, component x
* D_p_y_1_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 1 of the
    platform seen from its centre, component x
* D_p_z_1_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 1 of the
    platform seen from its centre, component x
* D_p_x_2_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 1 of the
    platform seen from its centre, component x
* D_p_y_2_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 1 of the
    platform seen from its centre, component x
* D_p_z_2_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 1 of the
    platform seen from its centre, component x
* D_p_x_3_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 1 of the
    platform seen from its centre, component x
* D_p_y_3_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 1 of the
    platform seen from its centre, component x
* D_p_z_3_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 1 of the
    platform seen from its centre, component x
* D_delta_x_1_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 1
    of the platform seen from its centre, component x
* D_delta_y_1_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 1
    of the platform seen from its centre, component x
* D_delta_z_1_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 1
    of the platform seen from its centre, component x
* D_delta_x_2_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 1
    of the platform seen from its centre, component x
* D_delta_y_2_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 1
    of the platform seen from its centre, component x
* D_delta_z_2_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 1
    of the platform seen from its centre, component x
* D_delta_x_3_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 1
    of the platform seen from its centre, component x
* D_delta_y_3_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 1
    of the platform seen from its centre, component x
* D_delta_z_3_by_b_1_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 1
    of the platform seen from its centre, component x
* mu_1_by_b_1_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component x
* mu_2_by_b_1_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component x
* mu_3_by_b_1_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component x
* x_1_by_b_1_y [(m)/(m)]: derivative at a fixed pose of: position of carriage 1 along its rail; by: joint 1 of
    the platform seen from its centre, component y
* s_1_x_by_b_1_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component x; by: joint 1 of the platform seen from its centre, component y
* s_1_y_by_b_1_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component y; by: joint 1 of the platform seen from its centre, component y
* s_1_z_by_b_1_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component z; by: joint 1 of the platform seen from its centre, component y
* D_p_x_1_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 1 of the
    platform seen from its centre, component y
* D_p_y_1_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 1 of the
    platform seen from its centre, component y
* D_p_z_1_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 1 of the
    platform seen from its centre, component y
* D_p_x_2_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 1 of the
    platform seen from its centre, component y
* D_p_y_2_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 1 of the
    platform seen from its centre, component y
* D_p_z_2_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 1 of the
    platform seen from its centre, component y
* D_p_x_3_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 1 of the
    platform seen from its centre, component y
* D_p_y_3_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 1 of the
    platform seen from its centre, component y
* D_p_z_3_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 1 of the
    platform seen from its centre, component y
* D_delta_x_1_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 1
    of the platform seen from its centre, component y
* D_delta_y_1_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 1
    of the platform seen from its centre, component y
* D_delta_z_1_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 1
    of the platform seen from its centre, component y
* D_delta_x_2_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 1
    of the platform seen from its centre, component y
* D_delta_y_2_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 1
    of the platform seen from its centre, component y
* D_delta_z_2_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 1
    of the platform seen from its centre, component y
* D_delta_x_3_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 1
    of the platform seen from its centre, component y
* D_delta_y_3_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 1
    of the platform seen from its centre, component y
* D_delta_z_3_by_b_1_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 1
    of the platform seen from its centre, component y
* mu_1_by_b_1_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component y
* mu_2_by_b_1_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component y
* mu_3_by_b_1_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component y
* x_1_by_b_1_z [(m)/(m)]: derivative at a fixed pose of: position of carriage 1 along its rail; by: joint 1 of
    the platform seen from its centre, component z
* s_1_x_by_b_1_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component x; by: joint 1 of the platform seen from its centre, component z
* s_1_y_by_b_1_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component y; by: joint 1 of the platform seen from its centre, component z
* s_1_z_by_b_1_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component z; by: joint 1 of the platform seen from its centre, component z
* D_p_x_1_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 1 of the
    platform seen from its centre, component z
* D_p_y_1_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 1 of the
    platform seen from its centre, component z
* D_p_z_1_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 1 of the
    platform seen from its centre, component z
* D_p_x_2_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 1 of the
    platform seen from its centre, component z
* D_p_y_2_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 1 of the
    platform seen from its centre, component z
* D_p_z_2_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 1 of the
    platform seen from its centre, component z
* D_p_x_3_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 1 of the
    platform seen from its centre, component z
* D_p_y_3_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 1 of the
    platform seen from its centre, component z
* D_p_z_3_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 1 of the
    platform seen from its centre, component z
* D_delta_x_1_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 1
    of the platform seen from its centre, component z
* D_delta_y_1_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 1
    of the platform seen from its centre, component z
* D_delta_z_1_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 1
    of the platform seen from its centre, component z
* D_delta_x_2_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 1
    of the platform seen from its centre, component z
* D_delta_y_2_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 1
    of the platform seen from its centre, component z
* D_delta_z_2_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 1
    of the platform seen from its centre, component z
* D_delta_x_3_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 1
    of the platform seen from its centre, component z
* D_delta_y_3_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 1
    of the platform seen from its centre, component z
* D_delta_z_3_by_b_1_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 1
    of the platform seen from its centre, component z
* mu_1_by_b_1_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component z
* mu_2_by_b_1_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component z
* mu_3_by_b_1_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 1 of the platform seen from its centre, component z
* x_2_by_b_2_x [(m)/(m)]: derivative at a fixed pose of: position of carriage 2 along its rail; by: joint 2 of
    the platform seen from its centre, component x
* s_2_x_by_b_2_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component x; by: joint 2 of the platform seen from its centre, component x
* s_2_y_by_b_2_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component y; by: joint 2 of the platform seen from its centre, component x
* s_2_z_by_b_2_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component z; by: joint 2 of the platform seen from its centre, component x
* D_p_x_1_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 2 of the
    platform seen from its centre, component x
* D_p_y_1_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 2 of the
    platform seen from its centre, component x
* D_p_z_1_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 2 of the
    platform seen from its centre, component x
* D_p_x_2_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 2 of the
    platform seen from its centre, component x
* D_p_y_2_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 2 of the
    platform seen from its centre, component x
* D_p_z_2_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 2 of the
    platform seen from its centre, component x
* D_p_x_3_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 2 of the
    platform seen from its centre, component x
* D_p_y_3_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 2 of the
    platform seen from its centre, component x
* D_p_z_3_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 2 of the
    platform seen from its centre, component x
* D_delta_x_1_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 2
    of the platform seen from its centre, component x
* D_delta_y_1_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 2
    of the platform seen from its centre, component x
* D_delta_z_1_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 2
    of the platform seen from its centre, component x
* D_delta_x_2_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 2
    of the platform seen from its centre, component x
* D_delta_y_2_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 2
    of the platform seen from its centre, component x
* D_delta_z_2_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 2
    of the platform seen from its centre, component x
* D_delta_x_3_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 2
    of the platform seen from its centre, component x
* D_delta_y_3_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 2
    of the platform seen from its centre, component x
* D_delta_z_3_by_b_2_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 2
    of the platform seen from its centre, component x
* mu_1_by_b_2_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component x
* mu_2_by_b_2_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component x
* mu_3_by_b_2_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component x
* x_2_by_b_2_y [(m)/(m)]: derivative at a fixed pose of: position of carriage 2 along its rail; by: joint 2 of
    the platform seen from its centre, component y
* s_2_x_by_b_2_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component x; by: joint 2 of the platform seen from its centre, component y
* s_2_y_by_b_2_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component y; by: joint 2 of the platform seen from its centre, component y
* s_2_z_by_b_2_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component z; by: joint 2 of the platform seen from its centre, component y
* D_p_x_1_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 2 of the
    platform seen from its centre, component y
* D_p_y_1_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 2 of the
    platform seen from its centre, component y
* D_p_z_1_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 2 of the
    platform seen from its centre, component y
* D_p_x_2_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 2 of the
    platform seen from its centre, component y
* D_p_y_2_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 2 of the
    platform seen from its centre, component y
* D_p_z_2_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 2 of the
    platform seen from its centre, component y
* D_p_x_3_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 2 of the
    platform seen from its centre, component y
* D_p_y_3_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 2 of the
    platform seen from its centre, component y
* D_p_z_3_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 2 of the
    platform seen from its centre, component y
* D_delta_x_1_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 2
    of the platform seen from its centre, component y
* D_delta_y_1_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 2
    of the platform seen from its centre, component y
* D_delta_z_1_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 2
    of the platform seen from its centre, component y
* D_delta_x_2_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 2
    of the platform seen from its centre, component y
* D_delta_y_2_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 2
    of the platform seen from its centre, component y
* D_delta_z_2_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 2
    of the platform seen from its centre, component y
* D_delta_x_3_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 2
    of the platform seen from its centre, component y
* D_delta_y_3_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 2
    of the platform seen from its centre, component y
* D_delta_z_3_by_b_2_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 2
    of the platform seen from its centre, component y
* mu_1_by_b_2_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component y
* mu_2_by_b_2_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component y
* mu_3_by_b_2_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component y
* x_2_by_b_2_z [(m)/(m)]: derivative at a fixed pose of: position of carriage 2 along its rail; by: joint 2 of
    the platform seen from its centre, component z
* s_2_x_by_b_2_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component x; by: joint 2 of the platform seen from its centre, component z
* s_2_y_by_b_2_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component y; by: joint 2 of the platform seen from its centre, component z
* s_2_z_by_b_2_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component z; by: joint 2 of the platform seen from its centre, component z
* D_p_x_1_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 2 of the
    platform seen from its centre, component z
* D_p_y_1_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 2 of the
    platform seen from its centre, component z
* D_p_z_1_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 2 of the
    platform seen from its centre, component z
* D_p_x_2_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 2 of the
    platform seen from its centre, component z
* D_p_y_2_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 2 of the
    platform seen from its centre, component z
* D_p_z_2_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 2 of the
    platform seen from its centre, component z
* D_p_x_3_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 2 of the
    platform seen from its centre, component z
* D_p_y_3_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 2 of the
    platform seen from its centre, component z
* D_p_z_3_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 2 of the
    platform seen from its centre, component z
* D_delta_x_1_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 2
    of the platform seen from its centre, component z
* D_delta_y_1_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 2
    of the platform seen from its centre, component z
* D_delta_z_1_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 2
    of the platform seen from its centre, component z
* D_delta_x_2_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 2
    of the platform seen from its centre, component z
* D_delta_y_2_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 2
    of the platform seen from its centre, component z
* D_delta_z_2_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 2
    of the platform seen from its centre, component z
* D_delta_x_3_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 2
    of the platform seen from its centre, component z
* D_delta_y_3_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 2
    of the platform seen from its centre, component z
* D_delta_z_3_by_b_2_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 2
    of the platform seen from its centre, component z
* mu_1_by_b_2_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component z
* mu_2_by_b_2_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component z
* mu_3_by_b_2_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 2 of the platform seen from its centre, component z
* x_3_by_b_3_x [(m)/(m)]: derivative at a fixed pose of: position of carriage 3 along its rail; by: joint 3 of
    the platform seen from its centre, component x
* s_3_x_by_b_3_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component x; by: joint 3 of the platform seen from its centre, component x
* s_3_y_by_b_3_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component y; by: joint 3 of the platform seen from its centre, component x
* s_3_z_by_b_3_x [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component z; by: joint 3 of the platform seen from its centre, component x
* D_p_x_1_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 3 of the
    platform seen from its centre, component x
* D_p_y_1_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 3 of the
    platform seen from its centre, component x
* D_p_z_1_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 3 of the
    platform seen from its centre, component x
* D_p_x_2_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 3 of the
    platform seen from its centre, component x
* D_p_y_2_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 3 of the
    platform seen from its centre, component x
* D_p_z_2_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 3 of the
    platform seen from its centre, component x
* D_p_x_3_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 3 of the
    platform seen from its centre, component x
* D_p_y_3_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 3 of the
    platform seen from its centre, component x
* D_p_z_3_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 3 of the
    platform seen from its centre, component x
* D_delta_x_1_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 3
    of the platform seen from its centre, component x
* D_delta_y_1_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 3
    of the platform seen from its centre, component x
* D_delta_z_1_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 3
    of the platform seen from its centre, component x
* D_delta_x_2_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 3
    of the platform seen from its centre, component x
* D_delta_y_2_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 3
    of the platform seen from its centre, component x
* D_delta_z_2_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 3
    of the platform seen from its centre, component x
* D_delta_x_3_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 3
    of the platform seen from its centre, component x
* D_delta_y_3_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 3
    of the platform seen from its centre, component x
* D_delta_z_3_by_b_3_x [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 3
    of the platform seen from its centre, component x
* mu_1_by_b_3_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component x
* mu_2_by_b_3_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component x
* mu_3_by_b_3_x [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component x
* x_3_by_b_3_y [(m)/(m)]: derivative at a fixed pose of: position of carriage 3 along its rail; by: joint 3 of
    the platform seen from its centre, component y
* s_3_x_by_b_3_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component x; by: joint 3 of the platform seen from its centre, component y
* s_3_y_by_b_3_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component y; by: joint 3 of the platform seen from its centre, component y
* s_3_z_by_b_3_y [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component z; by: joint 3 of the platform seen from its centre, component y
* D_p_x_1_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 3 of the
    platform seen from its centre, component y
* D_p_y_1_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 3 of the
    platform seen from its centre, component y
* D_p_z_1_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 3 of the
    platform seen from its centre, component y
* D_p_x_2_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 3 of the
    platform seen from its centre, component y
* D_p_y_2_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 3 of the
    platform seen from its centre, component y
* D_p_z_2_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 3 of the
    platform seen from its centre, component y
* D_p_x_3_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 3 of the
    platform seen from its centre, component y
* D_p_y_3_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 3 of the
    platform seen from its centre, component y
* D_p_z_3_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 3 of the
    platform seen from its centre, component y
* D_delta_x_1_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 3
    of the platform seen from its centre, component y
* D_delta_y_1_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 3
    of the platform seen from its centre, component y
* D_delta_z_1_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 3
    of the platform seen from its centre, component y
* D_delta_x_2_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 3
    of the platform seen from its centre, component y
* D_delta_y_2_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 3
    of the platform seen from its centre, component y
* D_delta_z_2_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 3
    of the platform seen from its centre, component y
* D_delta_x_3_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 3
    of the platform seen from its centre, component y
* D_delta_y_3_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 3
    of the platform seen from its centre, component y
* D_delta_z_3_by_b_3_y [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 3
    of the platform seen from its centre, component y
* mu_1_by_b_3_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component y
* mu_2_by_b_3_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component y
* mu_3_by_b_3_y [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component y
* x_3_by_b_3_z [(m)/(m)]: derivative at a fixed pose of: position of carriage 3 along its rail; by: joint 3 of
    the platform seen from its centre, component z
* s_3_x_by_b_3_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component x; by: joint 3 of the platform seen from its centre, component z
* s_3_y_by_b_3_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component y; by: joint 3 of the platform seen from its centre, component z
* s_3_z_by_b_3_z [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component z; by: joint 3 of the platform seen from its centre, component z
* D_p_x_1_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: joint 3 of the
    platform seen from its centre, component z
* D_p_y_1_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: joint 3 of the
    platform seen from its centre, component z
* D_p_z_1_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: joint 3 of the
    platform seen from its centre, component z
* D_p_x_2_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: joint 3 of the
    platform seen from its centre, component z
* D_p_y_2_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: joint 3 of the
    platform seen from its centre, component z
* D_p_z_2_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: joint 3 of the
    platform seen from its centre, component z
* D_p_x_3_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: joint 3 of the
    platform seen from its centre, component z
* D_p_y_3_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: joint 3 of the
    platform seen from its centre, component z
* D_p_z_3_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: joint 3 of the
    platform seen from its centre, component z
* D_delta_x_1_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: joint 3
    of the platform seen from its centre, component z
* D_delta_y_1_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: joint 3
    of the platform seen from its centre, component z
* D_delta_z_1_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: joint 3
    of the platform seen from its centre, component z
* D_delta_x_2_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: joint 3
    of the platform seen from its centre, component z
* D_delta_y_2_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: joint 3
    of the platform seen from its centre, component z
* D_delta_z_2_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: joint 3
    of the platform seen from its centre, component z
* D_delta_x_3_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: joint 3
    of the platform seen from its centre, component z
* D_delta_y_3_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: joint 3
    of the platform seen from its centre, component z
* D_delta_z_3_by_b_3_z [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: joint 3
    of the platform seen from its centre, component z
* mu_1_by_b_3_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component z
* mu_2_by_b_3_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component z
* mu_3_by_b_3_z [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: joint 3 of the platform seen from its centre, component z
* x_1_by_l_d_1 [(m)/(m)]: derivative at a fixed pose of: position of carriage 1 along its rail; by: length of
    linkage 1
* s_1_x_by_l_d_1 [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component x; by: length of linkage 1
* s_1_y_by_l_d_1 [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component y; by: length of linkage 1
* s_1_z_by_l_d_1 [(m)/(m)]: derivative at a fixed pose of: linkage vector 1, from carriage to platform joint,
    component z; by: length of linkage 1
* D_p_x_1_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: length of
    linkage 1
* D_p_y_1_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: length of
    linkage 1
* D_p_z_1_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: length of
    linkage 1
* D_p_x_2_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: length of
    linkage 1
* D_p_y_2_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: length of
    linkage 1
* D_p_z_2_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: length of
    linkage 1
* D_p_x_3_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: length of
    linkage 1
* D_p_y_3_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: length of
    linkage 1
* D_p_z_3_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: length of
    linkage 1
* D_delta_x_1_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: length
    of linkage 1
* D_delta_y_1_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: length
    of linkage 1
* D_delta_z_1_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: length
    of linkage 1
* D_delta_x_2_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: length
    of linkage 1
* D_delta_y_2_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: length
    of linkage 1
* D_delta_z_2_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: length
    of linkage 1
* D_delta_x_3_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: length
    of linkage 1
* D_delta_y_3_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: length
    of linkage 1
* D_delta_z_3_by_l_d_1 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: length
    of linkage 1
* mu_1_by_l_d_1 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: length of linkage 1
* mu_2_by_l_d_1 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: length of linkage 1
* mu_3_by_l_d_1 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: length of linkage 1
* x_2_by_l_d_2 [(m)/(m)]: derivative at a fixed pose of: position of carriage 2 along its rail; by: length of
    linkage 2
* s_2_x_by_l_d_2 [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component x; by: length of linkage 2
* s_2_y_by_l_d_2 [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component y; by: length of linkage 2
* s_2_z_by_l_d_2 [(m)/(m)]: derivative at a fixed pose of: linkage vector 2, from carriage to platform joint,
    component z; by: length of linkage 2
* D_p_x_1_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: length of
    linkage 2
* D_p_y_1_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: length of
    linkage 2
* D_p_z_1_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: length of
    linkage 2
* D_p_x_2_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: length of
    linkage 2
* D_p_y_2_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: length of
    linkage 2
* D_p_z_2_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: length of
    linkage 2
* D_p_x_3_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: length of
    linkage 2
* D_p_y_3_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: length of
    linkage 2
* D_p_z_3_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: length of
    linkage 2
* D_delta_x_1_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: length
    of linkage 2
* D_delta_y_1_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: length
    of linkage 2
* D_delta_z_1_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: length
    of linkage 2
* D_delta_x_2_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: length
    of linkage 2
* D_delta_y_2_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: length
    of linkage 2
* D_delta_z_2_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: length
    of linkage 2
* D_delta_x_3_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: length
    of linkage 2
* D_delta_y_3_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: length
    of linkage 2
* D_delta_z_3_by_l_d_2 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: length
    of linkage 2
* mu_1_by_l_d_2 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: length of linkage 2
* mu_2_by_l_d_2 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: length of linkage 2
* mu_3_by_l_d_2 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: length of linkage 2
* x_3_by_l_d_3 [(m)/(m)]: derivative at a fixed pose of: position of carriage 3 along its rail; by: length of
    linkage 3
* s_3_x_by_l_d_3 [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component x; by: length of linkage 3
* s_3_y_by_l_d_3 [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component y; by: length of linkage 3
* s_3_z_by_l_d_3 [(m)/(m)]: derivative at a fixed pose of: linkage vector 3, from carriage to platform joint,
    component z; by: length of linkage 3
* D_p_x_1_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_1; by: length of
    linkage 3
* D_p_y_1_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_1; by: length of
    linkage 3
* D_p_z_1_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_1; by: length of
    linkage 3
* D_p_x_2_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_2; by: length of
    linkage 3
* D_p_y_2_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_2; by: length of
    linkage 3
* D_p_z_2_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_2; by: length of
    linkage 3
* D_p_x_3_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/dx_3; by: length of
    linkage 3
* D_p_y_3_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/dx_3; by: length of
    linkage 3
* D_p_z_3_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/dx_3; by: length of
    linkage 3
* D_delta_x_1_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_1; by: length
    of linkage 3
* D_delta_y_1_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_1; by: length
    of linkage 3
* D_delta_z_1_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_1; by: length
    of linkage 3
* D_delta_x_2_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_2; by: length
    of linkage 3
* D_delta_y_2_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_2; by: length
    of linkage 3
* D_delta_z_2_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_2; by: length
    of linkage 3
* D_delta_x_3_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_x/ddelta_3; by: length
    of linkage 3
* D_delta_y_3_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_y/ddelta_3; by: length
    of linkage 3
* D_delta_z_3_by_l_d_3 [(1)/(m)]: derivative at a fixed pose of: platform Jacobian, dp_z/ddelta_3; by: length
    of linkage 3
* mu_1_by_l_d_3 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 1 divided by its length,
    positive in compression; by: length of linkage 3
* mu_2_by_l_d_3 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 2 divided by its length,
    positive in compression; by: length of linkage 3
* mu_3_by_l_d_3 [(N/m)/(m)]: derivative at a fixed pose of: static force in linkage 3 divided by its length,
    positive in compression; by: length of linkage 3
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
    ('axis_belt_stiffness', 'the belts of the axes are not equally stiff', False, (),
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

#: The same for the geometry.
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
    1254 operations; 2335419 with every named value written out.
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
    U_1_x_2 = D_p_x_2
    U_1_x_3 = D_p_x_3
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_y_2 = D_p_y_2
    U_1_y_3 = D_p_y_3
    U_1_z_1 = D_p_z_1 - n_1_z
    U_1_z_2 = D_p_z_2
    U_1_z_3 = D_p_z_3
    U_2_x_1 = D_p_x_1
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_x_3 = D_p_x_3
    U_2_y_1 = D_p_y_1
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_y_3 = D_p_y_3
    U_2_z_1 = D_p_z_1
    U_2_z_2 = D_p_z_2 - n_2_z
    U_2_z_3 = D_p_z_3
    U_3_x_1 = D_p_x_1
    U_3_x_2 = D_p_x_2
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_1 = D_p_y_1
    U_3_y_2 = D_p_y_2
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_1 = D_p_z_1
    U_3_z_2 = D_p_z_2
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
    t56 = D_p_x_1*t53 + D_p_x_2*t41 + D_p_y_1*t54 + D_p_y_2*t44 + D_p_z_1*t55 + D_p_z_2*t47
    t57 = (1/6)*m_d_3
    t58 = n_3_x*t57
    t59 = n_3_y*t57
    t60 = n_3_z*t57
    t61 = D_p_x_1*t58 + D_p_x_3*t41 + D_p_y_1*t59 + D_p_y_3*t44 + D_p_z_1*t60 + D_p_z_3*t47
    t62 = (1/6)*rho_b
    t63 = R_p_1*t62
    t64 = l_f_1_3*t63
    t65 = l_f_1_2*t63
    t66 = D_delta_x_1*t41 + D_delta_y_1*t44 + D_delta_z_1*t47
    t67 = D_delta_x_2*t41 + D_delta_y_2*t44 + D_delta_z_2*t47
    t68 = D_delta_x_3*t41 + D_delta_y_3*t44 + D_delta_z_3*t47
    t69 = t35 + t52 + t57
    t70 = D_p_x_1*t69 + m_t_1*n_1_x + n_1_x*t26 + t40
    t71 = D_p_y_1*t69 + m_t_1*n_1_y + n_1_y*t26 + t43
    t72 = D_p_z_1*t69 + m_t_1*n_1_z + n_1_z*t26 + t46
    t73 = D_p_x_2*t39
    t74 = t53 + t73
    t75 = D_p_y_2*t39
    t76 = t54 + t75
    t77 = D_p_z_2*t39
    t78 = t55 + t77
    t79 = l_f_2_2*t48
    t80 = l_f_2_3*t48
    t81 = t79 + t80
    t82 = D_p_x_2*t58 + D_p_x_3*t74 + D_p_y_2*t59 + D_p_y_3*t76 + D_p_z_2*t60 + D_p_z_3*t78
    t83 = R_p_2*t62
    t84 = l_f_2_3*t83
    t85 = l_f_2_2*t83
    t86 = D_delta_x_1*t74 + D_delta_y_1*t76 + D_delta_z_1*t78
    t87 = D_delta_x_2*t74 + D_delta_y_2*t76 + D_delta_z_2*t78
    t88 = D_delta_x_3*t74 + D_delta_y_3*t76 + D_delta_z_3*t78
    t89 = D_p_x_2*t69 + m_t_2*n_2_x + n_2_x*t27 + t73
    t90 = D_p_y_2*t69 + m_t_2*n_2_y + n_2_y*t27 + t75
    t91 = D_p_z_2*t69 + m_t_2*n_2_z + n_2_z*t27 + t77
    t92 = D_p_x_3*t39
    t93 = t58 + t92
    t94 = D_p_y_3*t39
    t95 = t59 + t94
    t96 = D_p_z_3*t39
    t97 = t60 + t96
    t98 = l_f_3_2*t48
    t99 = l_f_3_3*t48
    t100 = t98 + t99
    t101 = R_p_3*t62
    t102 = l_f_3_3*t101
    t103 = l_f_3_2*t101
    t104 = D_delta_x_1*t93 + D_delta_y_1*t95 + D_delta_z_1*t97
    t105 = D_delta_x_2*t93 + D_delta_y_2*t95 + D_delta_z_2*t97
    t106 = D_delta_x_3*t93 + D_delta_y_3*t95 + D_delta_z_3*t97
    t107 = D_p_x_3*t69 + m_t_3*n_3_x + n_3_x*t28 + t92
    t108 = D_p_y_3*t69 + m_t_3*n_3_y + n_3_y*t28 + t94
    t109 = D_p_z_3*t69 + m_t_3*n_3_z + n_3_z*t28 + t96
    t110 = R_p_1**2
    t111 = l_f_1_1*t110
    t112 = t111*t48
    t113 = t111*t62
    t114 = d_1_1*t11
    t115 = R_p_2**2
    t116 = l_f_2_1*t115
    t117 = t116*t48
    t118 = t116*t62
    t119 = d_2_1*t13
    t120 = R_p_3**2
    t121 = l_f_3_1*t120
    t122 = t121*t48
    t123 = t121*t62
    t124 = d_3_1*t15
    t125 = d_1_2*t11
    t126 = d_2_2*t13
    t127 = d_3_2*t15
    t128 = D_delta_x_1**2
    t129 = D_delta_y_1**2
    t130 = D_delta_z_1**2
    t131 = D_delta_x_1*t39
    t132 = D_delta_y_1*t39
    t133 = D_delta_z_1*t39
    t134 = D_delta_x_2*t131 + D_delta_y_2*t132 + D_delta_z_2*t133
    t135 = D_delta_x_3*t131 + D_delta_y_3*t132 + D_delta_z_3*t133
    t136 = D_delta_x_1*t69 + t131
    t137 = D_delta_y_1*t69 + t132
    t138 = D_delta_z_1*t69 + t133
    t139 = D_delta_x_2**2
    t140 = D_delta_y_2**2
    t141 = D_delta_z_2**2
    t142 = D_delta_x_2*t39
    t143 = D_delta_y_2*t39
    t144 = D_delta_z_2*t39
    t145 = D_delta_x_3*t142 + D_delta_y_3*t143 + D_delta_z_3*t144
    t146 = D_delta_x_2*t69 + t142
    t147 = D_delta_y_2*t69 + t143
    t148 = D_delta_z_2*t69 + t144
    t149 = D_delta_x_3**2
    t150 = D_delta_y_3**2
    t151 = D_delta_z_3**2
    t152 = D_delta_x_3*t39 + D_delta_x_3*t69
    t153 = D_delta_y_3*t39 + D_delta_y_3*t69
    t154 = D_delta_z_3*t39 + D_delta_z_3*t69
    t155 = m_F + m_d_1 + m_d_2 + m_d_3 + m_t_1 + m_t_2 + m_t_3 + t29
    t156 = k_1_2 + k_1_3
    t157 = D_p_x_1*k_C
    t158 = D_p_y_1*k_C
    t159 = D_p_z_1*k_C
    t160 = D_p_x_2*t157 + D_p_y_2*t158 + D_p_z_2*t159
    t161 = D_p_x_3*t157 + D_p_y_3*t158 + D_p_z_3*t159
    t162 = -R_p_1*k_1_3
    t163 = -R_p_1*k_1_2
    t164 = D_delta_x_1*t157 + D_delta_y_1*t158 + D_delta_z_1*t159
    t165 = D_delta_x_2*t157 + D_delta_y_2*t158 + D_delta_z_2*t159
    t166 = D_delta_x_3*t157 + D_delta_y_3*t158 + D_delta_z_3*t159
    t167 = k_2_2 + k_2_3
    t168 = D_p_x_2*k_C
    t169 = D_p_y_2*k_C
    t170 = D_p_z_2*k_C
    t171 = D_p_x_3*t168 + D_p_y_3*t169 + D_p_z_3*t170
    t172 = -R_p_2*k_2_3
    t173 = -R_p_2*k_2_2
    t174 = D_delta_x_1*t168 + D_delta_y_1*t169 + D_delta_z_1*t170
    t175 = D_delta_x_2*t168 + D_delta_y_2*t169 + D_delta_z_2*t170
    t176 = D_delta_x_3*t168 + D_delta_y_3*t169 + D_delta_z_3*t170
    t177 = k_3_2 + k_3_3
    t178 = -R_p_3*k_3_3
    t179 = -R_p_3*k_3_2
    t180 = D_p_x_3*k_C
    t181 = D_p_y_3*k_C
    t182 = D_p_z_3*k_C
    t183 = D_delta_x_1*t180 + D_delta_y_1*t181 + D_delta_z_1*t182
    t184 = D_delta_x_2*t180 + D_delta_y_2*t181 + D_delta_z_2*t182
    t185 = D_delta_x_3*t180 + D_delta_y_3*t181 + D_delta_z_3*t182
    t186 = k_1_1*t110
    t187 = k_2_1*t115
    t188 = k_3_1*t120
    t189 = D_delta_x_1*k_C
    t190 = D_delta_y_1*k_C
    t191 = D_delta_z_1*k_C
    t192 = D_delta_x_2*t189 + D_delta_y_2*t190 + D_delta_z_2*t191
    t193 = D_delta_x_3*t189 + D_delta_y_3*t190 + D_delta_z_3*t191
    t194 = D_delta_x_2*k_C
    t195 = D_delta_y_2*k_C
    t196 = D_delta_z_2*k_C
    t197 = D_delta_x_3*t194 + D_delta_y_3*t195 + D_delta_z_3*t196
    t198 = D_delta_x_3*k_C
    t199 = D_delta_y_3*k_C
    t200 = D_delta_z_3*k_C
    t201 = U_1_x_1*mu_1
    t202 = U_1_y_1*mu_1
    t203 = U_1_z_1*mu_1
    t204 = U_2_x_1*mu_2
    t205 = U_2_y_1*mu_2
    t206 = U_2_z_1*mu_2
    t207 = U_3_x_1*mu_3
    t208 = U_3_y_1*mu_3
    t209 = U_3_z_1*mu_3
    t210 = (
        -U_1_x_2*t201 - U_1_y_2*t202 - U_1_z_2*t203 - U_2_x_2*t204 - U_2_y_2*t205 - U_2_z_2*t206
        - U_3_x_2*t207 - U_3_y_2*t208 - U_3_z_2*t209
    )
    t211 = (
        -U_1_x_3*t201 - U_1_y_3*t202 - U_1_z_3*t203 - U_2_x_3*t204 - U_2_y_3*t205 - U_2_z_3*t206
        - U_3_x_3*t207 - U_3_y_3*t208 - U_3_z_3*t209
    )
    t212 = (
        -D_delta_x_1*t201 - D_delta_x_1*t204 - D_delta_x_1*t207 - D_delta_y_1*t202 - D_delta_y_1*t205
        - D_delta_y_1*t208 - D_delta_z_1*t203 - D_delta_z_1*t206 - D_delta_z_1*t209
    )
    t213 = (
        -D_delta_x_2*t201 - D_delta_x_2*t204 - D_delta_x_2*t207 - D_delta_y_2*t202 - D_delta_y_2*t205
        - D_delta_y_2*t208 - D_delta_z_2*t203 - D_delta_z_2*t206 - D_delta_z_2*t209
    )
    t214 = (
        -D_delta_x_3*t201 - D_delta_x_3*t204 - D_delta_x_3*t207 - D_delta_y_3*t202 - D_delta_y_3*t205
        - D_delta_y_3*t208 - D_delta_z_3*t203 - D_delta_z_3*t206 - D_delta_z_3*t209
    )
    t215 = U_1_x_2*mu_1
    t216 = U_1_y_2*mu_1
    t217 = U_1_z_2*mu_1
    t218 = U_2_x_2*mu_2
    t219 = U_2_y_2*mu_2
    t220 = U_2_z_2*mu_2
    t221 = U_3_x_2*mu_3
    t222 = U_3_y_2*mu_3
    t223 = U_3_z_2*mu_3
    t224 = (
        -U_1_x_3*t215 - U_1_y_3*t216 - U_1_z_3*t217 - U_2_x_3*t218 - U_2_y_3*t219 - U_2_z_3*t220
        - U_3_x_3*t221 - U_3_y_3*t222 - U_3_z_3*t223
    )
    t225 = (
        -D_delta_x_1*t215 - D_delta_x_1*t218 - D_delta_x_1*t221 - D_delta_y_1*t216 - D_delta_y_1*t219
        - D_delta_y_1*t222 - D_delta_z_1*t217 - D_delta_z_1*t220 - D_delta_z_1*t223
    )
    t226 = (
        -D_delta_x_2*t215 - D_delta_x_2*t218 - D_delta_x_2*t221 - D_delta_y_2*t216 - D_delta_y_2*t219
        - D_delta_y_2*t222 - D_delta_z_2*t217 - D_delta_z_2*t220 - D_delta_z_2*t223
    )
    t227 = (
        -D_delta_x_3*t215 - D_delta_x_3*t218 - D_delta_x_3*t221 - D_delta_y_3*t216 - D_delta_y_3*t219
        - D_delta_y_3*t222 - D_delta_z_3*t217 - D_delta_z_3*t220 - D_delta_z_3*t223
    )
    t228 = U_1_x_3*mu_1
    t229 = U_2_x_3*mu_2
    t230 = U_3_x_3*mu_3
    t231 = U_1_y_3*mu_1
    t232 = U_2_y_3*mu_2
    t233 = U_3_y_3*mu_3
    t234 = U_1_z_3*mu_1
    t235 = U_2_z_3*mu_2
    t236 = U_3_z_3*mu_3
    t237 = (
        -D_delta_x_1*t228 - D_delta_x_1*t229 - D_delta_x_1*t230 - D_delta_y_1*t231 - D_delta_y_1*t232
        - D_delta_y_1*t233 - D_delta_z_1*t234 - D_delta_z_1*t235 - D_delta_z_1*t236
    )
    t238 = (
        -D_delta_x_2*t228 - D_delta_x_2*t229 - D_delta_x_2*t230 - D_delta_y_2*t231 - D_delta_y_2*t232
        - D_delta_y_2*t233 - D_delta_z_2*t234 - D_delta_z_2*t235 - D_delta_z_2*t236
    )
    t239 = (
        -D_delta_x_3*t228 - D_delta_x_3*t229 - D_delta_x_3*t230 - D_delta_y_3*t231 - D_delta_y_3*t232
        - D_delta_y_3*t233 - D_delta_z_3*t234 - D_delta_z_3*t235 - D_delta_z_3*t236
    )
    t240 = D_delta_x_1*D_delta_x_2
    t241 = D_delta_y_1*D_delta_y_2
    t242 = D_delta_z_1*D_delta_z_2
    t243 = (
        -mu_1*t240 - mu_1*t241 - mu_1*t242 - mu_2*t240 - mu_2*t241 - mu_2*t242 - mu_3*t240 - mu_3*t241
        - mu_3*t242
    )
    t244 = D_delta_x_1*D_delta_x_3
    t245 = D_delta_y_1*D_delta_y_3
    t246 = D_delta_z_1*D_delta_z_3
    t247 = (
        -mu_1*t244 - mu_1*t245 - mu_1*t246 - mu_2*t244 - mu_2*t245 - mu_2*t246 - mu_3*t244 - mu_3*t245
        - mu_3*t246
    )
    t248 = D_delta_x_2*D_delta_x_3
    t249 = D_delta_y_2*D_delta_y_3
    t250 = D_delta_z_2*D_delta_z_3
    t251 = (
        -mu_1*t248 - mu_1*t249 - mu_1*t250 - mu_2*t248 - mu_2*t249 - mu_2*t250 - mu_3*t248 - mu_3*t249
        - mu_3*t250
    )
    M_out = np.zeros((*batch, 21, 21), dtype)
    M_out[..., 0, 0] = (
        D_p_x_1*t36 + D_p_x_1*t41 + D_p_y_1*t42 + D_p_y_1*t44 + D_p_z_1*t45 + D_p_z_1*t47 + m_t_1 + t34 + t51
    )
    M_out[..., 0, 1] = t56
    M_out[..., 0, 2] = t61
    M_out[..., 0, 3] = t64
    M_out[..., 0, 6] = t65
    M_out[..., 0, 12] = t66
    M_out[..., 0, 13] = t67
    M_out[..., 0, 14] = t68
    M_out[..., 0, 15] = t51
    M_out[..., 0, 18] = t70
    M_out[..., 0, 19] = t71
    M_out[..., 0, 20] = t72
    M_out[..., 1, 0] = t56
    M_out[..., 1, 1] = (
        D_p_x_2*t53 + D_p_x_2*t74 + D_p_y_2*t54 + D_p_y_2*t76 + D_p_z_2*t55 + D_p_z_2*t78 + m_t_2 + t37 + t81
    )
    M_out[..., 1, 2] = t82
    M_out[..., 1, 4] = t84
    M_out[..., 1, 7] = t85
    M_out[..., 1, 12] = t86
    M_out[..., 1, 13] = t87
    M_out[..., 1, 14] = t88
    M_out[..., 1, 16] = t81
    M_out[..., 1, 18] = t89
    M_out[..., 1, 19] = t90
    M_out[..., 1, 20] = t91
    M_out[..., 2, 0] = t61
    M_out[..., 2, 1] = t82
    M_out[..., 2, 2] = (
        D_p_x_3*t58 + D_p_x_3*t93 + D_p_y_3*t59 + D_p_y_3*t95 + D_p_z_3*t60 + D_p_z_3*t97 + m_t_3 + t100 + t38
    )
    M_out[..., 2, 5] = t102
    M_out[..., 2, 8] = t103
    M_out[..., 2, 12] = t104
    M_out[..., 2, 13] = t105
    M_out[..., 2, 14] = t106
    M_out[..., 2, 17] = t100
    M_out[..., 2, 18] = t107
    M_out[..., 2, 19] = t108
    M_out[..., 2, 20] = t109
    M_out[..., 3, 0] = t64
    M_out[..., 3, 3] = I_1_1 + t110*t50 + t112
    M_out[..., 3, 6] = t113
    M_out[..., 3, 9] = t114
    M_out[..., 3, 15] = t64
    M_out[..., 4, 1] = t84
    M_out[..., 4, 4] = I_2_1 + t115*t80 + t117
    M_out[..., 4, 7] = t118
    M_out[..., 4, 10] = t119
    M_out[..., 4, 16] = t84
    M_out[..., 5, 2] = t102
    M_out[..., 5, 5] = I_3_1 + t120*t99 + t122
    M_out[..., 5, 8] = t123
    M_out[..., 5, 11] = t124
    M_out[..., 5, 17] = t102
    M_out[..., 6, 0] = t65
    M_out[..., 6, 3] = t113
    M_out[..., 6, 6] = I_1_2 + t110*t49 + t112
    M_out[..., 6, 9] = t125
    M_out[..., 6, 15] = t65
    M_out[..., 7, 1] = t85
    M_out[..., 7, 4] = t118
    M_out[..., 7, 7] = I_2_2 + t115*t79 + t117
    M_out[..., 7, 10] = t126
    M_out[..., 7, 16] = t85
    M_out[..., 8, 2] = t103
    M_out[..., 8, 5] = t123
    M_out[..., 8, 8] = I_3_2 + t120*t98 + t122
    M_out[..., 8, 11] = t127
    M_out[..., 8, 17] = t103
    M_out[..., 9, 3] = t114
    M_out[..., 9, 6] = t125
    M_out[..., 9, 9] = t114 + t125
    M_out[..., 10, 4] = t119
    M_out[..., 10, 7] = t126
    M_out[..., 10, 10] = t119 + t126
    M_out[..., 11, 5] = t124
    M_out[..., 11, 8] = t127
    M_out[..., 11, 11] = t124 + t127
    M_out[..., 12, 0] = t66
    M_out[..., 12, 1] = t86
    M_out[..., 12, 2] = t104
    M_out[..., 12, 12] = t128*t39 + t129*t39 + t130*t39
    M_out[..., 12, 13] = t134
    M_out[..., 12, 14] = t135
    M_out[..., 12, 18] = t136
    M_out[..., 12, 19] = t137
    M_out[..., 12, 20] = t138
    M_out[..., 13, 0] = t67
    M_out[..., 13, 1] = t87
    M_out[..., 13, 2] = t105
    M_out[..., 13, 12] = t134
    M_out[..., 13, 13] = t139*t39 + t140*t39 + t141*t39
    M_out[..., 13, 14] = t145
    M_out[..., 13, 18] = t146
    M_out[..., 13, 19] = t147
    M_out[..., 13, 20] = t148
    M_out[..., 14, 0] = t68
    M_out[..., 14, 1] = t88
    M_out[..., 14, 2] = t106
    M_out[..., 14, 12] = t135
    M_out[..., 14, 13] = t145
    M_out[..., 14, 14] = t149*t39 + t150*t39 + t151*t39
    M_out[..., 14, 18] = t152
    M_out[..., 14, 19] = t153
    M_out[..., 14, 20] = t154
    M_out[..., 15, 0] = t51
    M_out[..., 15, 3] = t64
    M_out[..., 15, 6] = t65
    M_out[..., 15, 15] = t51
    M_out[..., 16, 1] = t81
    M_out[..., 16, 4] = t84
    M_out[..., 16, 7] = t85
    M_out[..., 16, 16] = t81
    M_out[..., 17, 2] = t100
    M_out[..., 17, 5] = t102
    M_out[..., 17, 8] = t103
    M_out[..., 17, 17] = t100
    M_out[..., 18, 0] = t70
    M_out[..., 18, 1] = t89
    M_out[..., 18, 2] = t107
    M_out[..., 18, 12] = t136
    M_out[..., 18, 13] = t146
    M_out[..., 18, 14] = t152
    M_out[..., 18, 18] = t155
    M_out[..., 19, 0] = t71
    M_out[..., 19, 1] = t90
    M_out[..., 19, 2] = t108
    M_out[..., 19, 12] = t137
    M_out[..., 19, 13] = t147
    M_out[..., 19, 14] = t153
    M_out[..., 19, 19] = t155
    M_out[..., 20, 0] = t72
    M_out[..., 20, 1] = t91
    M_out[..., 20, 2] = t109
    M_out[..., 20, 12] = t138
    M_out[..., 20, 13] = t148
    M_out[..., 20, 14] = t154
    M_out[..., 20, 20] = t155
    K_el_out = np.zeros((*batch, 21, 21), dtype)
    K_el_out[..., 0, 0] = D_p_x_1**2*k_C + D_p_y_1**2*k_C + D_p_z_1**2*k_C + t156
    K_el_out[..., 0, 1] = t160
    K_el_out[..., 0, 2] = t161
    K_el_out[..., 0, 3] = t162
    K_el_out[..., 0, 6] = t163
    K_el_out[..., 0, 12] = t164
    K_el_out[..., 0, 13] = t165
    K_el_out[..., 0, 14] = t166
    K_el_out[..., 0, 15] = t156
    K_el_out[..., 0, 18] = t157
    K_el_out[..., 0, 19] = t158
    K_el_out[..., 0, 20] = t159
    K_el_out[..., 1, 0] = t160
    K_el_out[..., 1, 1] = D_p_x_2**2*k_C + D_p_y_2**2*k_C + D_p_z_2**2*k_C + t167
    K_el_out[..., 1, 2] = t171
    K_el_out[..., 1, 4] = t172
    K_el_out[..., 1, 7] = t173
    K_el_out[..., 1, 12] = t174
    K_el_out[..., 1, 13] = t175
    K_el_out[..., 1, 14] = t176
    K_el_out[..., 1, 16] = t167
    K_el_out[..., 1, 18] = t168
    K_el_out[..., 1, 19] = t169
    K_el_out[..., 1, 20] = t170
    K_el_out[..., 2, 0] = t161
    K_el_out[..., 2, 1] = t171
    K_el_out[..., 2, 2] = D_p_x_3**2*k_C + D_p_y_3**2*k_C + D_p_z_3**2*k_C + t177
    K_el_out[..., 2, 5] = t178
    K_el_out[..., 2, 8] = t179
    K_el_out[..., 2, 12] = t183
    K_el_out[..., 2, 13] = t184
    K_el_out[..., 2, 14] = t185
    K_el_out[..., 2, 17] = t177
    K_el_out[..., 2, 18] = t180
    K_el_out[..., 2, 19] = t181
    K_el_out[..., 2, 20] = t182
    K_el_out[..., 3, 0] = t162
    K_el_out[..., 3, 3] = d_1_1*k_S + k_1_3*t110 + t186
    K_el_out[..., 3, 6] = -t186
    K_el_out[..., 3, 15] = t162
    K_el_out[..., 4, 1] = t172
    K_el_out[..., 4, 4] = d_2_1*k_S + k_2_3*t115 + t187
    K_el_out[..., 4, 7] = -t187
    K_el_out[..., 4, 16] = t172
    K_el_out[..., 5, 2] = t178
    K_el_out[..., 5, 5] = d_3_1*k_S + k_3_3*t120 + t188
    K_el_out[..., 5, 8] = -t188
    K_el_out[..., 5, 17] = t178
    K_el_out[..., 6, 0] = t163
    K_el_out[..., 6, 3] = -t186
    K_el_out[..., 6, 6] = d_1_2*k_S + k_1_2*t110 + t186
    K_el_out[..., 6, 15] = t163
    K_el_out[..., 7, 1] = t173
    K_el_out[..., 7, 4] = -t187
    K_el_out[..., 7, 7] = d_2_2*k_S + k_2_2*t115 + t187
    K_el_out[..., 7, 16] = t173
    K_el_out[..., 8, 2] = t179
    K_el_out[..., 8, 5] = -t188
    K_el_out[..., 8, 8] = d_3_2*k_S + k_3_2*t120 + t188
    K_el_out[..., 8, 17] = t179
    K_el_out[..., 12, 0] = t164
    K_el_out[..., 12, 1] = t174
    K_el_out[..., 12, 2] = t183
    K_el_out[..., 12, 12] = k_C*t128 + k_C*t129 + k_C*t130
    K_el_out[..., 12, 13] = t192
    K_el_out[..., 12, 14] = t193
    K_el_out[..., 12, 18] = t189
    K_el_out[..., 12, 19] = t190
    K_el_out[..., 12, 20] = t191
    K_el_out[..., 13, 0] = t165
    K_el_out[..., 13, 1] = t175
    K_el_out[..., 13, 2] = t184
    K_el_out[..., 13, 12] = t192
    K_el_out[..., 13, 13] = k_C*t139 + k_C*t140 + k_C*t141
    K_el_out[..., 13, 14] = t197
    K_el_out[..., 13, 18] = t194
    K_el_out[..., 13, 19] = t195
    K_el_out[..., 13, 20] = t196
    K_el_out[..., 14, 0] = t166
    K_el_out[..., 14, 1] = t176
    K_el_out[..., 14, 2] = t185
    K_el_out[..., 14, 12] = t193
    K_el_out[..., 14, 13] = t197
    K_el_out[..., 14, 14] = k_C*t149 + k_C*t150 + k_C*t151
    K_el_out[..., 14, 18] = t198
    K_el_out[..., 14, 19] = t199
    K_el_out[..., 14, 20] = t200
    K_el_out[..., 15, 0] = t156
    K_el_out[..., 15, 3] = t162
    K_el_out[..., 15, 6] = t163
    K_el_out[..., 15, 15] = t156
    K_el_out[..., 16, 1] = t167
    K_el_out[..., 16, 4] = t172
    K_el_out[..., 16, 7] = t173
    K_el_out[..., 16, 16] = t167
    K_el_out[..., 17, 2] = t177
    K_el_out[..., 17, 5] = t178
    K_el_out[..., 17, 8] = t179
    K_el_out[..., 17, 17] = t177
    K_el_out[..., 18, 0] = t157
    K_el_out[..., 18, 1] = t168
    K_el_out[..., 18, 2] = t180
    K_el_out[..., 18, 12] = t189
    K_el_out[..., 18, 13] = t194
    K_el_out[..., 18, 14] = t198
    K_el_out[..., 18, 18] = k_C
    K_el_out[..., 19, 0] = t158
    K_el_out[..., 19, 1] = t169
    K_el_out[..., 19, 2] = t181
    K_el_out[..., 19, 12] = t190
    K_el_out[..., 19, 13] = t195
    K_el_out[..., 19, 14] = t199
    K_el_out[..., 19, 19] = k_C
    K_el_out[..., 20, 0] = t159
    K_el_out[..., 20, 1] = t170
    K_el_out[..., 20, 2] = t182
    K_el_out[..., 20, 12] = t191
    K_el_out[..., 20, 13] = t196
    K_el_out[..., 20, 14] = t200
    K_el_out[..., 20, 20] = k_C
    K_g_out = np.zeros((*batch, 21, 21), dtype)
    K_g_out[..., 0, 0] = (
        -U_1_x_1**2*mu_1 - U_1_y_1**2*mu_1 - U_1_z_1**2*mu_1 - U_2_x_1**2*mu_2 - U_2_y_1**2*mu_2
        - U_2_z_1**2*mu_2 - U_3_x_1**2*mu_3 - U_3_y_1**2*mu_3 - U_3_z_1**2*mu_3
    )
    K_g_out[..., 0, 1] = t210
    K_g_out[..., 0, 2] = t211
    K_g_out[..., 0, 12] = t212
    K_g_out[..., 0, 13] = t213
    K_g_out[..., 0, 14] = t214
    K_g_out[..., 1, 0] = t210
    K_g_out[..., 1, 1] = (
        -U_1_x_2**2*mu_1 - U_1_y_2**2*mu_1 - U_1_z_2**2*mu_1 - U_2_x_2**2*mu_2 - U_2_y_2**2*mu_2
        - U_2_z_2**2*mu_2 - U_3_x_2**2*mu_3 - U_3_y_2**2*mu_3 - U_3_z_2**2*mu_3
    )
    K_g_out[..., 1, 2] = t224
    K_g_out[..., 1, 12] = t225
    K_g_out[..., 1, 13] = t226
    K_g_out[..., 1, 14] = t227
    K_g_out[..., 2, 0] = t211
    K_g_out[..., 2, 1] = t224
    K_g_out[..., 2, 2] = (
        -U_1_x_3**2*mu_1 - U_1_y_3**2*mu_1 - U_1_z_3**2*mu_1 - U_2_x_3**2*mu_2 - U_2_y_3**2*mu_2
        - U_2_z_3**2*mu_2 - U_3_x_3**2*mu_3 - U_3_y_3**2*mu_3 - U_3_z_3**2*mu_3
    )
    K_g_out[..., 2, 12] = t237
    K_g_out[..., 2, 13] = t238
    K_g_out[..., 2, 14] = t239
    K_g_out[..., 12, 0] = t212
    K_g_out[..., 12, 1] = t225
    K_g_out[..., 12, 2] = t237
    K_g_out[..., 12, 12] = (
        -mu_1*t128 - mu_1*t129 - mu_1*t130 + mu_1 - mu_2*t128 - mu_2*t129 - mu_2*t130 - mu_3*t128 - mu_3*t129
        - mu_3*t130
    )
    K_g_out[..., 12, 13] = t243
    K_g_out[..., 12, 14] = t247
    K_g_out[..., 13, 0] = t213
    K_g_out[..., 13, 1] = t226
    K_g_out[..., 13, 2] = t238
    K_g_out[..., 13, 12] = t243
    K_g_out[..., 13, 13] = (
        -mu_1*t139 - mu_1*t140 - mu_1*t141 - mu_2*t139 - mu_2*t140 - mu_2*t141 + mu_2 - mu_3*t139 - mu_3*t140
        - mu_3*t141
    )
    K_g_out[..., 13, 14] = t251
    K_g_out[..., 14, 0] = t214
    K_g_out[..., 14, 1] = t227
    K_g_out[..., 14, 2] = t239
    K_g_out[..., 14, 12] = t247
    K_g_out[..., 14, 13] = t251
    K_g_out[..., 14, 14] = (
        -mu_1*t149 - mu_1*t150 - mu_1*t151 - mu_2*t149 - mu_2*t150 - mu_2*t151 - mu_3*t149 - mu_3*t150
        - mu_3*t151 + mu_3
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
    kappa_out = np.zeros((*batch, 12), dtype)
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
    kappa_c_out = np.zeros((*batch, 12), dtype)
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
    """Torques and rotations that hold the pose, the effects' weights and changes of stiffness included.

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
        Torques on the driven rotors.
    theta_st : array, shape (..., 6) [rad]
        Rotations from unstrained transmissions.

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
    G_2 = (
        -D_p_x_2*t18 - D_p_y_2*t19 - D_p_z_2*t20 - g_x*(m_t_2*n_2_x + n_2_x*t15) - g_y*(m_t_2*n_2_y
        + n_2_y*t15) - g_z*(m_t_2*n_2_z + n_2_z*t15)
    )
    G_3 = (
        -D_p_x_3*t18 - D_p_y_3*t19 - D_p_z_3*t20 - g_x*(m_t_3*n_3_x + n_3_x*t16) - g_y*(m_t_3*n_3_y
        + n_3_y*t16) - g_z*(m_t_3*n_3_z + n_3_z*t16)
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
    t28 = R_p_2**2
    t29 = k_2_1*t28
    t30 = k_2_3*t28
    t31 = -d_2_1*t29 + d_2_2*(t29 + t30)
    t32 = k_2_2*t28
    t33 = d_2_1*(t29 + t32) - d_2_2*t29
    det_2 = R_p_2*k_2_2*t31 - R_p_2*k_2_3*t33
    t34 = G_2/det_2
    theta_2_1_st = -t33*t34
    theta_2_2_st = t31*t34
    t35 = R_p_3**2
    t36 = k_3_1*t35
    t37 = k_3_3*t35
    t38 = -d_3_1*t36 + d_3_2*(t36 + t37)
    t39 = k_3_2*t35
    t40 = d_3_1*(t36 + t39) - d_3_2*t36
    det_3 = R_p_3*k_3_2*t38 - R_p_3*k_3_3*t40
    t41 = G_3/det_3
    theta_3_1_st = -t40*t41
    theta_3_2_st = t38*t41
    t42 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st)
    tau_st_1 = d_1_1*(t23*theta_1_1_st - t42) + d_1_2*(t25*theta_1_2_st + t42)
    t43 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st)
    tau_st_2 = d_2_1*(t30*theta_2_1_st - t43) + d_2_2*(t32*theta_2_2_st + t43)
    t44 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st)
    tau_st_3 = d_3_1*(t37*theta_3_1_st - t44) + d_3_2*(t39*theta_3_2_st + t44)
    tau_st_out = np.zeros((*batch, 3), dtype)
    tau_st_out[..., 0] = tau_st_1
    tau_st_out[..., 1] = tau_st_2
    tau_st_out[..., 2] = tau_st_3
    theta_st_out = np.zeros((*batch, 6), dtype)
    theta_st_out[..., 0] = theta_1_1_st
    theta_st_out[..., 1] = theta_2_1_st
    theta_st_out[..., 2] = theta_3_1_st
    theta_st_out[..., 3] = theta_1_2_st
    theta_st_out[..., 4] = theta_2_2_st
    theta_st_out[..., 5] = theta_3_2_st
    return tau_st_out, theta_st_out


def value_sensitivities(p, parameters, effects):
    """Derivatives of M and K by every parameter that moves nothing, at a fixed pose.

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
    2407 operations; 5900571 with every named value written out.
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
    U_1_x_2 = D_p_x_2
    U_1_x_3 = D_p_x_3
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_y_2 = D_p_y_2
    U_1_y_3 = D_p_y_3
    U_1_z_1 = D_p_z_1 - n_1_z
    U_1_z_2 = D_p_z_2
    U_1_z_3 = D_p_z_3
    U_2_x_1 = D_p_x_1
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_x_3 = D_p_x_3
    U_2_y_1 = D_p_y_1
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_y_3 = D_p_y_3
    U_2_z_1 = D_p_z_1
    U_2_z_2 = D_p_z_2 - n_2_z
    U_2_z_3 = D_p_z_3
    U_3_x_1 = D_p_x_1
    U_3_x_2 = D_p_x_2
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_1 = D_p_y_1
    U_3_y_2 = D_p_y_2
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_1 = D_p_z_1
    U_3_z_2 = D_p_z_2
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
    mu_1_by_m_d_2 = mu_1_by_m_d_1
    mu_2_by_m_d_2 = mu_2_by_m_d_1
    mu_3_by_m_d_2 = mu_3_by_m_d_1
    mu_1_by_m_d_3 = mu_1_by_m_d_1
    mu_2_by_m_d_3 = mu_2_by_m_d_1
    mu_3_by_m_d_3 = mu_3_by_m_d_1
    mu_1_by_m_L = mu_1_by_m_p
    mu_2_by_m_L = mu_2_by_m_p
    mu_3_by_m_L = mu_3_by_m_p
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
    t272 = -U_2_x_1**2 - U_2_y_1**2 - U_2_z_1**2
    t273 = -U_3_x_1**2 - U_3_y_1**2 - U_3_z_1**2
    t274 = -U_1_x_1*U_1_x_2 - U_1_y_1*U_1_y_2 - U_1_z_1*U_1_z_2
    t275 = -U_2_x_1*U_2_x_2 - U_2_y_1*U_2_y_2 - U_2_z_1*U_2_z_2
    t276 = -U_3_x_1*U_3_x_2 - U_3_y_1*U_3_y_2 - U_3_z_1*U_3_z_2
    t277 = -U_1_x_1*U_1_x_3 - U_1_y_1*U_1_y_3 - U_1_z_1*U_1_z_3
    t278 = -U_2_x_1*U_2_x_3 - U_2_y_1*U_2_y_3 - U_2_z_1*U_2_z_3
    t279 = -U_3_x_1*U_3_x_3 - U_3_y_1*U_3_y_3 - U_3_z_1*U_3_z_3
    t280 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t281 = -D_delta_x_1*U_2_x_1 - D_delta_y_1*U_2_y_1 - D_delta_z_1*U_2_z_1
    t282 = -D_delta_x_1*U_3_x_1 - D_delta_y_1*U_3_y_1 - D_delta_z_1*U_3_z_1
    t283 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t284 = -D_delta_x_2*U_2_x_1 - D_delta_y_2*U_2_y_1 - D_delta_z_2*U_2_z_1
    t285 = -D_delta_x_2*U_3_x_1 - D_delta_y_2*U_3_y_1 - D_delta_z_2*U_3_z_1
    t286 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t287 = -D_delta_x_3*U_2_x_1 - D_delta_y_3*U_2_y_1 - D_delta_z_3*U_2_z_1
    t288 = -D_delta_x_3*U_3_x_1 - D_delta_y_3*U_3_y_1 - D_delta_z_3*U_3_z_1
    t289 = -U_1_x_2**2 - U_1_y_2**2 - U_1_z_2**2
    t290 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t291 = -U_3_x_2**2 - U_3_y_2**2 - U_3_z_2**2
    t292 = -U_1_x_2*U_1_x_3 - U_1_y_2*U_1_y_3 - U_1_z_2*U_1_z_3
    t293 = -U_2_x_2*U_2_x_3 - U_2_y_2*U_2_y_3 - U_2_z_2*U_2_z_3
    t294 = -U_3_x_2*U_3_x_3 - U_3_y_2*U_3_y_3 - U_3_z_2*U_3_z_3
    t295 = -D_delta_x_1*U_1_x_2 - D_delta_y_1*U_1_y_2 - D_delta_z_1*U_1_z_2
    t296 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t297 = -D_delta_x_1*U_3_x_2 - D_delta_y_1*U_3_y_2 - D_delta_z_1*U_3_z_2
    t298 = -D_delta_x_2*U_1_x_2 - D_delta_y_2*U_1_y_2 - D_delta_z_2*U_1_z_2
    t299 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t300 = -D_delta_x_2*U_3_x_2 - D_delta_y_2*U_3_y_2 - D_delta_z_2*U_3_z_2
    t301 = -D_delta_x_3*U_1_x_2 - D_delta_y_3*U_1_y_2 - D_delta_z_3*U_1_z_2
    t302 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t303 = -D_delta_x_3*U_3_x_2 - D_delta_y_3*U_3_y_2 - D_delta_z_3*U_3_z_2
    t304 = -U_1_x_3**2 - U_1_y_3**2 - U_1_z_3**2
    t305 = -U_2_x_3**2 - U_2_y_3**2 - U_2_z_3**2
    t306 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t307 = -D_delta_x_1*U_1_x_3 - D_delta_y_1*U_1_y_3 - D_delta_z_1*U_1_z_3
    t308 = -D_delta_x_1*U_2_x_3 - D_delta_y_1*U_2_y_3 - D_delta_z_1*U_2_z_3
    t309 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t310 = -D_delta_x_2*U_1_x_3 - D_delta_y_2*U_1_y_3 - D_delta_z_2*U_1_z_3
    t311 = -D_delta_x_2*U_2_x_3 - D_delta_y_2*U_2_y_3 - D_delta_z_2*U_2_z_3
    t312 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t313 = -D_delta_x_3*U_1_x_3 - D_delta_y_3*U_1_y_3 - D_delta_z_3*U_1_z_3
    t314 = -D_delta_x_3*U_2_x_3 - D_delta_y_3*U_2_y_3 - D_delta_z_3*U_2_z_3
    t315 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t316 = 1 - t117
    t317 = 1 - t129
    t318 = 1 - t137
    t319 = 1.0/(t18**2)
    t320 = t13*t319
    t321 = (1/2)*t320
    t322 = 1.0/(t20**2)
    t323 = t13*t322
    t324 = (1/2)*t323
    t325 = t321 + t324
    t326 = -R_p_1*t324
    t327 = -R_p_1*t321
    t328 = 1.0/(t29**2)
    t329 = t24*t328
    t330 = (1/2)*t329
    t331 = 1.0/(t31**2)
    t332 = t24*t331
    t333 = (1/2)*t332
    t334 = t330 + t333
    t335 = -R_p_2*t333
    t336 = -R_p_2*t330
    t337 = 1.0/(t40**2)
    t338 = t337*t35
    t339 = (1/2)*t338
    t340 = 1.0/(t42**2)
    t341 = t340*t35
    t342 = (1/2)*t341
    t343 = t339 + t342
    t344 = -R_p_3*t342
    t345 = -R_p_3*t339
    t346 = w_b_1**2
    t347 = t11**2
    t348 = t346*t347
    t349 = k_sp_1*t348
    t350 = c_E*t349
    t351 = -t11*t21*w_b_1 + t322*t350
    t352 = c_E*t319
    t353 = -t11*t19*w_b_1 + t349*t352
    t354 = -t351 - t353
    t355 = R_p_1*t351
    t356 = R_p_1*t353
    t357 = 1.0/(t15**2)
    t358 = t198*(t11*t16*w_b_1 - t350*t357)
    t359 = w_b_2**2
    t360 = t22**2
    t361 = t359*t360
    t362 = k_sp_2*t361
    t363 = c_E*t362
    t364 = -t22*t32*w_b_2 + t331*t363
    t365 = c_E*t328
    t366 = -t22*t30*w_b_2 + t362*t365
    t367 = -t364 - t366
    t368 = R_p_2*t364
    t369 = R_p_2*t366
    t370 = 1.0/(t26**2)
    t371 = t202*(t22*t27*w_b_2 - t363*t370)
    t372 = w_b_3**2
    t373 = t33**2
    t374 = t372*t373
    t375 = k_sp_3*t374
    t376 = c_E*t375
    t377 = -t33*t43*w_b_3 + t340*t376
    t378 = c_E*t337
    t379 = -t33*t41*w_b_3 + t375*t378
    t380 = -t377 - t379
    t381 = R_p_3*t377
    t382 = R_p_3*t379
    t383 = 1.0/(t37**2)
    t384 = t205*(t33*t38*w_b_3 - t376*t383)
    t385 = t347*w_b_1
    t386 = k_sp_1**2
    t387 = c_E*t386
    t388 = t385*t387
    t389 = -k_sp_1*t11*t21 + t322*t388
    t390 = t352*t386
    t391 = -k_sp_1*t11*t19 + t385*t390
    t392 = -t389 - t391
    t393 = R_p_1*t389
    t394 = R_p_1*t391
    t395 = t198*(k_sp_1*t11*t16 - t357*t388)
    t396 = t360*w_b_2
    t397 = k_sp_2**2
    t398 = c_E*t397
    t399 = t396*t398
    t400 = -k_sp_2*t22*t32 + t331*t399
    t401 = t365*t397
    t402 = -k_sp_2*t22*t30 + t396*t401
    t403 = -t400 - t402
    t404 = R_p_2*t400
    t405 = R_p_2*t402
    t406 = t202*(k_sp_2*t22*t27 - t370*t399)
    t407 = t373*w_b_3
    t408 = k_sp_3**2
    t409 = c_E*t408
    t410 = t407*t409
    t411 = -k_sp_3*t33*t43 + t340*t410
    t412 = t378*t408
    t413 = -k_sp_3*t33*t41 + t407*t412
    t414 = -t411 - t413
    t415 = R_p_3*t411
    t416 = R_p_3*t413
    t417 = t205*(k_sp_3*t33*t38 - t383*t410)
    t418 = 2*R_p_1
    t419 = k_1_1*t418
    t420 = 2*R_p_2
    t421 = k_2_1*t420
    t422 = 2*R_p_3
    t423 = k_3_1*t422
    t424 = -R_p_1*t320
    t425 = t198*t357
    t426 = t13*t425
    t427 = R_p_1*t323
    t428 = -R_p_2*t329
    t429 = t202*t370
    t430 = t24*t429
    t431 = R_p_2*t332
    t432 = -R_p_3*t338
    t433 = t205*t383
    t434 = t35*t433
    t435 = R_p_3*t341
    t436 = t11*t346
    t437 = t387*t436
    t438 = -k_sp_1*t21*w_b_1 + t322*t437
    t439 = -k_sp_1*t19*w_b_1 + t390*t436
    t440 = -t438 - t439
    t441 = R_p_1*t438
    t442 = R_p_1*t439
    t443 = t198*(k_sp_1*t16*w_b_1 - t357*t437)
    t444 = t22*t359
    t445 = t398*t444
    t446 = -k_sp_2*t32*w_b_2 + t331*t445
    t447 = -k_sp_2*t30*w_b_2 + t401*t444
    t448 = -t446 - t447
    t449 = R_p_2*t446
    t450 = R_p_2*t447
    t451 = t202*(k_sp_2*t27*w_b_2 - t370*t445)
    t452 = t33*t372
    t453 = t409*t452
    t454 = -k_sp_3*t43*w_b_3 + t340*t453
    t455 = -k_sp_3*t41*w_b_3 + t412*t452
    t456 = -t454 - t455
    t457 = R_p_3*t454
    t458 = R_p_3*t455
    t459 = t205*(k_sp_3*t38*w_b_3 - t383*t453)
    t460 = t348*t386
    t461 = t319*t460
    t462 = t322*t460
    t463 = -t461 - t462
    t464 = R_p_1*t462
    t465 = R_p_1*t461
    t466 = t361*t397
    t467 = t328*t466
    t468 = t331*t466
    t469 = -t467 - t468
    t470 = R_p_2*t468
    t471 = R_p_2*t467
    t472 = t374*t408
    t473 = t337*t472
    t474 = t340*t472
    t475 = -t473 - t474
    t476 = R_p_3*t474
    t477 = R_p_3*t473
    t478 = t425*t460
    t479 = t429*t466
    t480 = t433*t472
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
        t237, t237, t236 + t237, -t195, -t238, -t195, -t239, -t200, -t240, -t238, -t195, t195, t238, t195,
        t240, t200, t238, t239, t195, -t195, -t241, -t195, -t242, -t203, -t243, -t241, -t195, t195, t241,
        t195, t243, t203, t241, t242, t195, -t195, -t244, -t195, -t245, -t206, -t246, -t244, -t195, t195,
        t244, t195, t246, t206, t244, t245, t195, t249, t251, t252, t249, t255, t257, t258, t255, t261, t263,
        t264, t261, t198*t248 + t266, (1/6)*t265, t251, t202*t254 + t268, (1/6)*t267, t257, t205*t260 + t270,
        (1/6)*t269, t263, t198*t247 + t266, t252, t202*t253 + t268, t258, t205*t259 + t270, t264, t249, t255,
        t261, d_1_1, d_2_1, d_3_1, d_1_2, d_2_2, d_3_2, t57, t61, t65, t69, t73, t77, D_p_x_1, D_p_y_1,
        D_p_z_1, t81, t85, t89, t93, t97, D_p_x_2, D_p_y_2, D_p_z_2, t101, t105, t109, t113, D_p_x_3, D_p_y_3,
        D_p_z_3, t117, t121, t125, D_delta_x_1, D_delta_y_1, D_delta_z_1, t129, t133, D_delta_x_2,
        D_delta_y_2, D_delta_z_2, t137, D_delta_x_3, D_delta_y_3, D_delta_z_3, 1, 1, 1, 1, 1, 1,
    ))
    K_theta_out = _listed(batch, dtype, (
        mu_1_by_m_p*t271 + mu_2_by_m_p*t272 + mu_3_by_m_p*t273,
        mu_1_by_m_p*t274 + mu_2_by_m_p*t275 + mu_3_by_m_p*t276,
        mu_1_by_m_p*t277 + mu_2_by_m_p*t278 + mu_3_by_m_p*t279,
        mu_1_by_m_p*t280 + mu_2_by_m_p*t281 + mu_3_by_m_p*t282,
        mu_1_by_m_p*t283 + mu_2_by_m_p*t284 + mu_3_by_m_p*t285,
        mu_1_by_m_p*t286 + mu_2_by_m_p*t287 + mu_3_by_m_p*t288,
        mu_1_by_m_p*t289 + mu_2_by_m_p*t290 + mu_3_by_m_p*t291,
        mu_1_by_m_p*t292 + mu_2_by_m_p*t293 + mu_3_by_m_p*t294,
        mu_1_by_m_p*t295 + mu_2_by_m_p*t296 + mu_3_by_m_p*t297,
        mu_1_by_m_p*t298 + mu_2_by_m_p*t299 + mu_3_by_m_p*t300,
        mu_1_by_m_p*t301 + mu_2_by_m_p*t302 + mu_3_by_m_p*t303,
        mu_1_by_m_p*t304 + mu_2_by_m_p*t305 + mu_3_by_m_p*t306,
        mu_1_by_m_p*t307 + mu_2_by_m_p*t308 + mu_3_by_m_p*t309,
        mu_1_by_m_p*t310 + mu_2_by_m_p*t311 + mu_3_by_m_p*t312,
        mu_1_by_m_p*t313 + mu_2_by_m_p*t314 + mu_3_by_m_p*t315,
        mu_1_by_m_p*t316 - mu_2_by_m_p*t117 - mu_3_by_m_p*t117,
        -mu_1_by_m_p*t121 - mu_2_by_m_p*t121 - mu_3_by_m_p*t121,
        -mu_1_by_m_p*t125 - mu_2_by_m_p*t125 - mu_3_by_m_p*t125,
        -mu_1_by_m_p*t129 + mu_2_by_m_p*t317 - mu_3_by_m_p*t129,
        -mu_1_by_m_p*t133 - mu_2_by_m_p*t133 - mu_3_by_m_p*t133,
        -mu_1_by_m_p*t137 - mu_2_by_m_p*t137 + mu_3_by_m_p*t318,
        mu_1_by_g_x*t271 + mu_2_by_g_x*t272 + mu_3_by_g_x*t273,
        mu_1_by_g_x*t274 + mu_2_by_g_x*t275 + mu_3_by_g_x*t276,
        mu_1_by_g_x*t277 + mu_2_by_g_x*t278 + mu_3_by_g_x*t279,
        mu_1_by_g_x*t280 + mu_2_by_g_x*t281 + mu_3_by_g_x*t282,
        mu_1_by_g_x*t283 + mu_2_by_g_x*t284 + mu_3_by_g_x*t285,
        mu_1_by_g_x*t286 + mu_2_by_g_x*t287 + mu_3_by_g_x*t288,
        mu_1_by_g_x*t289 + mu_2_by_g_x*t290 + mu_3_by_g_x*t291,
        mu_1_by_g_x*t292 + mu_2_by_g_x*t293 + mu_3_by_g_x*t294,
        mu_1_by_g_x*t295 + mu_2_by_g_x*t296 + mu_3_by_g_x*t297,
        mu_1_by_g_x*t298 + mu_2_by_g_x*t299 + mu_3_by_g_x*t300,
        mu_1_by_g_x*t301 + mu_2_by_g_x*t302 + mu_3_by_g_x*t303,
        mu_1_by_g_x*t304 + mu_2_by_g_x*t305 + mu_3_by_g_x*t306,
        mu_1_by_g_x*t307 + mu_2_by_g_x*t308 + mu_3_by_g_x*t309,
        mu_1_by_g_x*t310 + mu_2_by_g_x*t311 + mu_3_by_g_x*t312,
        mu_1_by_g_x*t313 + mu_2_by_g_x*t314 + mu_3_by_g_x*t315,
        mu_1_by_g_x*t316 - mu_2_by_g_x*t117 - mu_3_by_g_x*t117,
        -mu_1_by_g_x*t121 - mu_2_by_g_x*t121 - mu_3_by_g_x*t121,
        -mu_1_by_g_x*t125 - mu_2_by_g_x*t125 - mu_3_by_g_x*t125,
        -mu_1_by_g_x*t129 + mu_2_by_g_x*t317 - mu_3_by_g_x*t129,
        -mu_1_by_g_x*t133 - mu_2_by_g_x*t133 - mu_3_by_g_x*t133,
        -mu_1_by_g_x*t137 - mu_2_by_g_x*t137 + mu_3_by_g_x*t318,
        mu_1_by_g_y*t271 + mu_2_by_g_y*t272 + mu_3_by_g_y*t273,
        mu_1_by_g_y*t274 + mu_2_by_g_y*t275 + mu_3_by_g_y*t276,
        mu_1_by_g_y*t277 + mu_2_by_g_y*t278 + mu_3_by_g_y*t279,
        mu_1_by_g_y*t280 + mu_2_by_g_y*t281 + mu_3_by_g_y*t282,
        mu_1_by_g_y*t283 + mu_2_by_g_y*t284 + mu_3_by_g_y*t285,
        mu_1_by_g_y*t286 + mu_2_by_g_y*t287 + mu_3_by_g_y*t288,
        mu_1_by_g_y*t289 + mu_2_by_g_y*t290 + mu_3_by_g_y*t291,
        mu_1_by_g_y*t292 + mu_2_by_g_y*t293 + mu_3_by_g_y*t294,
        mu_1_by_g_y*t295 + mu_2_by_g_y*t296 + mu_3_by_g_y*t297,
        mu_1_by_g_y*t298 + mu_2_by_g_y*t299 + mu_3_by_g_y*t300,
        mu_1_by_g_y*t301 + mu_2_by_g_y*t302 + mu_3_by_g_y*t303,
        mu_1_by_g_y*t304 + mu_2_by_g_y*t305 + mu_3_by_g_y*t306,
        mu_1_by_g_y*t307 + mu_2_by_g_y*t308 + mu_3_by_g_y*t309,
        mu_1_by_g_y*t310 + mu_2_by_g_y*t311 + mu_3_by_g_y*t312,
        mu_1_by_g_y*t313 + mu_2_by_g_y*t314 + mu_3_by_g_y*t315,
        mu_1_by_g_y*t316 - mu_2_by_g_y*t117 - mu_3_by_g_y*t117,
        -mu_1_by_g_y*t121 - mu_2_by_g_y*t121 - mu_3_by_g_y*t121,
        -mu_1_by_g_y*t125 - mu_2_by_g_y*t125 - mu_3_by_g_y*t125,
        -mu_1_by_g_y*t129 + mu_2_by_g_y*t317 - mu_3_by_g_y*t129,
        -mu_1_by_g_y*t133 - mu_2_by_g_y*t133 - mu_3_by_g_y*t133,
        -mu_1_by_g_y*t137 - mu_2_by_g_y*t137 + mu_3_by_g_y*t318,
        mu_1_by_g_z*t271 + mu_2_by_g_z*t272 + mu_3_by_g_z*t273,
        mu_1_by_g_z*t274 + mu_2_by_g_z*t275 + mu_3_by_g_z*t276,
        mu_1_by_g_z*t277 + mu_2_by_g_z*t278 + mu_3_by_g_z*t279,
        mu_1_by_g_z*t280 + mu_2_by_g_z*t281 + mu_3_by_g_z*t282,
        mu_1_by_g_z*t283 + mu_2_by_g_z*t284 + mu_3_by_g_z*t285,
        mu_1_by_g_z*t286 + mu_2_by_g_z*t287 + mu_3_by_g_z*t288,
        mu_1_by_g_z*t289 + mu_2_by_g_z*t290 + mu_3_by_g_z*t291,
        mu_1_by_g_z*t292 + mu_2_by_g_z*t293 + mu_3_by_g_z*t294,
        mu_1_by_g_z*t295 + mu_2_by_g_z*t296 + mu_3_by_g_z*t297,
        mu_1_by_g_z*t298 + mu_2_by_g_z*t299 + mu_3_by_g_z*t300,
        mu_1_by_g_z*t301 + mu_2_by_g_z*t302 + mu_3_by_g_z*t303,
        mu_1_by_g_z*t304 + mu_2_by_g_z*t305 + mu_3_by_g_z*t306,
        mu_1_by_g_z*t307 + mu_2_by_g_z*t308 + mu_3_by_g_z*t309,
        mu_1_by_g_z*t310 + mu_2_by_g_z*t311 + mu_3_by_g_z*t312,
        mu_1_by_g_z*t313 + mu_2_by_g_z*t314 + mu_3_by_g_z*t315,
        mu_1_by_g_z*t316 - mu_2_by_g_z*t117 - mu_3_by_g_z*t117,
        -mu_1_by_g_z*t121 - mu_2_by_g_z*t121 - mu_3_by_g_z*t121,
        -mu_1_by_g_z*t125 - mu_2_by_g_z*t125 - mu_3_by_g_z*t125,
        -mu_1_by_g_z*t129 + mu_2_by_g_z*t317 - mu_3_by_g_z*t129,
        -mu_1_by_g_z*t133 - mu_2_by_g_z*t133 - mu_3_by_g_z*t133,
        -mu_1_by_g_z*t137 - mu_2_by_g_z*t137 + mu_3_by_g_z*t318,
        mu_1_by_m_d_1*t271 + mu_2_by_m_d_1*t272 + mu_3_by_m_d_1*t273,
        mu_1_by_m_d_1*t274 + mu_2_by_m_d_1*t275 + mu_3_by_m_d_1*t276,
        mu_1_by_m_d_1*t277 + mu_2_by_m_d_1*t278 + mu_3_by_m_d_1*t279,
        mu_1_by_m_d_1*t280 + mu_2_by_m_d_1*t281 + mu_3_by_m_d_1*t282,
        mu_1_by_m_d_1*t283 + mu_2_by_m_d_1*t284 + mu_3_by_m_d_1*t285,
        mu_1_by_m_d_1*t286 + mu_2_by_m_d_1*t287 + mu_3_by_m_d_1*t288,
        mu_1_by_m_d_1*t289 + mu_2_by_m_d_1*t290 + mu_3_by_m_d_1*t291,
        mu_1_by_m_d_1*t292 + mu_2_by_m_d_1*t293 + mu_3_by_m_d_1*t294,
        mu_1_by_m_d_1*t295 + mu_2_by_m_d_1*t296 + mu_3_by_m_d_1*t297,
        mu_1_by_m_d_1*t298 + mu_2_by_m_d_1*t299 + mu_3_by_m_d_1*t300,
        mu_1_by_m_d_1*t301 + mu_2_by_m_d_1*t302 + mu_3_by_m_d_1*t303,
        mu_1_by_m_d_1*t304 + mu_2_by_m_d_1*t305 + mu_3_by_m_d_1*t306,
        mu_1_by_m_d_1*t307 + mu_2_by_m_d_1*t308 + mu_3_by_m_d_1*t309,
        mu_1_by_m_d_1*t310 + mu_2_by_m_d_1*t311 + mu_3_by_m_d_1*t312,
        mu_1_by_m_d_1*t313 + mu_2_by_m_d_1*t314 + mu_3_by_m_d_1*t315,
        mu_1_by_m_d_1*t316 - mu_2_by_m_d_1*t117 - mu_3_by_m_d_1*t117,
        -mu_1_by_m_d_1*t121 - mu_2_by_m_d_1*t121 - mu_3_by_m_d_1*t121,
        -mu_1_by_m_d_1*t125 - mu_2_by_m_d_1*t125 - mu_3_by_m_d_1*t125,
        -mu_1_by_m_d_1*t129 + mu_2_by_m_d_1*t317 - mu_3_by_m_d_1*t129,
        -mu_1_by_m_d_1*t133 - mu_2_by_m_d_1*t133 - mu_3_by_m_d_1*t133,
        -mu_1_by_m_d_1*t137 - mu_2_by_m_d_1*t137 + mu_3_by_m_d_1*t318,
        mu_1_by_m_d_2*t271 + mu_2_by_m_d_2*t272 + mu_3_by_m_d_2*t273,
        mu_1_by_m_d_2*t274 + mu_2_by_m_d_2*t275 + mu_3_by_m_d_2*t276,
        mu_1_by_m_d_2*t277 + mu_2_by_m_d_2*t278 + mu_3_by_m_d_2*t279,
        mu_1_by_m_d_2*t280 + mu_2_by_m_d_2*t281 + mu_3_by_m_d_2*t282,
        mu_1_by_m_d_2*t283 + mu_2_by_m_d_2*t284 + mu_3_by_m_d_2*t285,
        mu_1_by_m_d_2*t286 + mu_2_by_m_d_2*t287 + mu_3_by_m_d_2*t288,
        mu_1_by_m_d_2*t289 + mu_2_by_m_d_2*t290 + mu_3_by_m_d_2*t291,
        mu_1_by_m_d_2*t292 + mu_2_by_m_d_2*t293 + mu_3_by_m_d_2*t294,
        mu_1_by_m_d_2*t295 + mu_2_by_m_d_2*t296 + mu_3_by_m_d_2*t297,
        mu_1_by_m_d_2*t298 + mu_2_by_m_d_2*t299 + mu_3_by_m_d_2*t300,
        mu_1_by_m_d_2*t301 + mu_2_by_m_d_2*t302 + mu_3_by_m_d_2*t303,
        mu_1_by_m_d_2*t304 + mu_2_by_m_d_2*t305 + mu_3_by_m_d_2*t306,
        mu_1_by_m_d_2*t307 + mu_2_by_m_d_2*t308 + mu_3_by_m_d_2*t309,
        mu_1_by_m_d_2*t310 + mu_2_by_m_d_2*t311 + mu_3_by_m_d_2*t312,
        mu_1_by_m_d_2*t313 + mu_2_by_m_d_2*t314 + mu_3_by_m_d_2*t315,
        mu_1_by_m_d_2*t316 - mu_2_by_m_d_2*t117 - mu_3_by_m_d_2*t117,
        -mu_1_by_m_d_2*t121 - mu_2_by_m_d_2*t121 - mu_3_by_m_d_2*t121,
        -mu_1_by_m_d_2*t125 - mu_2_by_m_d_2*t125 - mu_3_by_m_d_2*t125,
        -mu_1_by_m_d_2*t129 + mu_2_by_m_d_2*t317 - mu_3_by_m_d_2*t129,
        -mu_1_by_m_d_2*t133 - mu_2_by_m_d_2*t133 - mu_3_by_m_d_2*t133,
        -mu_1_by_m_d_2*t137 - mu_2_by_m_d_2*t137 + mu_3_by_m_d_2*t318,
        mu_1_by_m_d_3*t271 + mu_2_by_m_d_3*t272 + mu_3_by_m_d_3*t273,
        mu_1_by_m_d_3*t274 + mu_2_by_m_d_3*t275 + mu_3_by_m_d_3*t276,
        mu_1_by_m_d_3*t277 + mu_2_by_m_d_3*t278 + mu_3_by_m_d_3*t279,
        mu_1_by_m_d_3*t280 + mu_2_by_m_d_3*t281 + mu_3_by_m_d_3*t282,
        mu_1_by_m_d_3*t283 + mu_2_by_m_d_3*t284 + mu_3_by_m_d_3*t285,
        mu_1_by_m_d_3*t286 + mu_2_by_m_d_3*t287 + mu_3_by_m_d_3*t288,
        mu_1_by_m_d_3*t289 + mu_2_by_m_d_3*t290 + mu_3_by_m_d_3*t291,
        mu_1_by_m_d_3*t292 + mu_2_by_m_d_3*t293 + mu_3_by_m_d_3*t294,
        mu_1_by_m_d_3*t295 + mu_2_by_m_d_3*t296 + mu_3_by_m_d_3*t297,
        mu_1_by_m_d_3*t298 + mu_2_by_m_d_3*t299 + mu_3_by_m_d_3*t300,
        mu_1_by_m_d_3*t301 + mu_2_by_m_d_3*t302 + mu_3_by_m_d_3*t303,
        mu_1_by_m_d_3*t304 + mu_2_by_m_d_3*t305 + mu_3_by_m_d_3*t306,
        mu_1_by_m_d_3*t307 + mu_2_by_m_d_3*t308 + mu_3_by_m_d_3*t309,
        mu_1_by_m_d_3*t310 + mu_2_by_m_d_3*t311 + mu_3_by_m_d_3*t312,
        mu_1_by_m_d_3*t313 + mu_2_by_m_d_3*t314 + mu_3_by_m_d_3*t315,
        mu_1_by_m_d_3*t316 - mu_2_by_m_d_3*t117 - mu_3_by_m_d_3*t117,
        -mu_1_by_m_d_3*t121 - mu_2_by_m_d_3*t121 - mu_3_by_m_d_3*t121,
        -mu_1_by_m_d_3*t125 - mu_2_by_m_d_3*t125 - mu_3_by_m_d_3*t125,
        -mu_1_by_m_d_3*t129 + mu_2_by_m_d_3*t317 - mu_3_by_m_d_3*t129,
        -mu_1_by_m_d_3*t133 - mu_2_by_m_d_3*t133 - mu_3_by_m_d_3*t133,
        -mu_1_by_m_d_3*t137 - mu_2_by_m_d_3*t137 + mu_3_by_m_d_3*t318, t325, t326, t327, t325, t198*t324,
        t326, t198*t321, t327, t325, t334, t335, t336, t334, t202*t333, t335, t202*t330, t336, t334, t343,
        t344, t345, t343, t205*t342, t344, t205*t339, t345, t343, t354, t355, t356, t354, -t198*t351 + t358,
        -t358, t355, -t198*t353 + t358, t356, t354, t367, t368, t369, t367, -t202*t364 + t371, -t371, t368,
        -t202*t366 + t371, t369, t367, t380, t381, t382, t380, -t205*t377 + t384, -t384, t381,
        -t205*t379 + t384, t382, t380, t392, t393, t394, t392, -t198*t389 + t395, -t395, t393,
        -t198*t391 + t395, t394, t392, t403, t404, t405, t403, -t202*t400 + t406, -t406, t404,
        -t202*t402 + t406, t405, t403, t414, t415, t416, t414, -t205*t411 + t417, -t417, t415,
        -t205*t413 + t417, t416, t414, -k_1_3, -k_1_2, k_1_3*t418 + t419, -t419, -k_1_3, k_1_2*t418 + t419,
        -k_1_2, -k_2_3, -k_2_2, k_2_3*t420 + t421, -t421, -k_2_3, k_2_2*t420 + t421, -k_2_2, -k_3_3, -k_3_2,
        k_3_3*t422 + t423, -t423, -k_3_3, k_3_2*t422 + t423, -k_3_2, t320, t424, t320, t426, -t426,
        t198*t320 + t426, t424, t320, -t323, t427, -t323, -t198*t323 - t426, t426, t427, -t426, -t323, t329,
        t428, t329, t430, -t430, t202*t329 + t430, t428, t329, -t332, t431, -t332, -t202*t332 - t430, t430,
        t431, -t430, -t332, t338, t432, t338, t434, -t434, t205*t338 + t434, t432, t338, -t341, t435, -t341,
        -t205*t341 - t434, t434, t435, -t434, -t341, t440, t441, t442, t440, -t198*t438 + t443, -t443, t441,
        -t198*t439 + t443, t442, t440, t448, t449, t450, t448, -t202*t446 + t451, -t451, t449,
        -t202*t447 + t451, t450, t448, t456, t457, t458, t456, -t205*t454 + t459, -t459, t457,
        -t205*t455 + t459, t458, t456, t463, t464, t465, t463, t469, t470, t471, t469, t475, t476, t477, t475,
        -t198*t462 - t478, t478, t464, -t202*t468 - t479, t479, t470, -t205*t474 - t480, t480, t476,
        -t198*t461 - t478, t465, -t202*t467 - t479, t471, -t205*t473 - t480, t477, t463, t469, t475, t57, t61,
        t65, t69, t73, t77, D_p_x_1, D_p_y_1, D_p_z_1, t81, t85, t89, t93, t97, D_p_x_2, D_p_y_2, D_p_z_2,
        t101, t105, t109, t113, D_p_x_3, D_p_y_3, D_p_z_3, t117, t121, t125, D_delta_x_1, D_delta_y_1,
        D_delta_z_1, t129, t133, D_delta_x_2, D_delta_y_2, D_delta_z_2, t137, D_delta_x_3, D_delta_y_3,
        D_delta_z_3, 1, 1, 1, mu_1_by_m_L*t271 + mu_2_by_m_L*t272 + mu_3_by_m_L*t273,
        mu_1_by_m_L*t274 + mu_2_by_m_L*t275 + mu_3_by_m_L*t276,
        mu_1_by_m_L*t277 + mu_2_by_m_L*t278 + mu_3_by_m_L*t279,
        mu_1_by_m_L*t280 + mu_2_by_m_L*t281 + mu_3_by_m_L*t282,
        mu_1_by_m_L*t283 + mu_2_by_m_L*t284 + mu_3_by_m_L*t285,
        mu_1_by_m_L*t286 + mu_2_by_m_L*t287 + mu_3_by_m_L*t288,
        mu_1_by_m_L*t289 + mu_2_by_m_L*t290 + mu_3_by_m_L*t291,
        mu_1_by_m_L*t292 + mu_2_by_m_L*t293 + mu_3_by_m_L*t294,
        mu_1_by_m_L*t295 + mu_2_by_m_L*t296 + mu_3_by_m_L*t297,
        mu_1_by_m_L*t298 + mu_2_by_m_L*t299 + mu_3_by_m_L*t300,
        mu_1_by_m_L*t301 + mu_2_by_m_L*t302 + mu_3_by_m_L*t303,
        mu_1_by_m_L*t304 + mu_2_by_m_L*t305 + mu_3_by_m_L*t306,
        mu_1_by_m_L*t307 + mu_2_by_m_L*t308 + mu_3_by_m_L*t309,
        mu_1_by_m_L*t310 + mu_2_by_m_L*t311 + mu_3_by_m_L*t312,
        mu_1_by_m_L*t313 + mu_2_by_m_L*t314 + mu_3_by_m_L*t315,
        mu_1_by_m_L*t316 - mu_2_by_m_L*t117 - mu_3_by_m_L*t117,
        -mu_1_by_m_L*t121 - mu_2_by_m_L*t121 - mu_3_by_m_L*t121,
        -mu_1_by_m_L*t125 - mu_2_by_m_L*t125 - mu_3_by_m_L*t125,
        -mu_1_by_m_L*t129 + mu_2_by_m_L*t317 - mu_3_by_m_L*t129,
        -mu_1_by_m_L*t133 - mu_2_by_m_L*t133 - mu_3_by_m_L*t133,
        -mu_1_by_m_L*t137 - mu_2_by_m_L*t137 + mu_3_by_m_L*t318, d_1_1, d_2_1, d_3_1, d_1_2, d_2_2, d_3_2,
    ))
    return M_theta_out, K_theta_out


def geometry_sensitivities(p, parameters, effects):
    """Derivatives of M and K by every parameter that moves the carriage positions, at a fixed pose.

    The entries of the upper triangles that GEOMETRY_SENSITIVITIES lists, all others being zero; by the field
    origin, the opposite of those by joint.

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
    Implicit function theorem and chain rule.
    13291 operations; 64171338 with every named value written out.
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
    U_1_x_2 = D_p_x_2
    U_1_x_3 = D_p_x_3
    U_1_y_1 = D_p_y_1 - n_1_y
    U_1_y_2 = D_p_y_2
    U_1_y_3 = D_p_y_3
    U_1_z_1 = D_p_z_1 - n_1_z
    U_1_z_2 = D_p_z_2
    U_1_z_3 = D_p_z_3
    U_2_x_1 = D_p_x_1
    U_2_x_2 = D_p_x_2 - n_2_x
    U_2_x_3 = D_p_x_3
    U_2_y_1 = D_p_y_1
    U_2_y_2 = D_p_y_2 - n_2_y
    U_2_y_3 = D_p_y_3
    U_2_z_1 = D_p_z_1
    U_2_z_2 = D_p_z_2 - n_2_z
    U_2_z_3 = D_p_z_3
    U_3_x_1 = D_p_x_1
    U_3_x_2 = D_p_x_2
    U_3_x_3 = D_p_x_3 - n_3_x
    U_3_y_1 = D_p_y_1
    U_3_y_2 = D_p_y_2
    U_3_y_3 = D_p_y_3 - n_3_y
    U_3_z_1 = D_p_z_1
    U_3_z_2 = D_p_z_2
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
    t248 = U_1_x_1*mu_1
    t249 = 2*D_p_x_1_by_b_1_x
    t250 = U_2_x_1*mu_2
    t251 = U_3_x_1*mu_3
    t252 = U_1_y_1*mu_1
    t253 = 2*D_p_y_1_by_b_1_x
    t254 = U_2_y_1*mu_2
    t255 = U_3_y_1*mu_3
    t256 = U_1_z_1*mu_1
    t257 = 2*D_p_z_1_by_b_1_x
    t258 = U_2_z_1*mu_2
    t259 = U_3_z_1*mu_3
    t260 = a_B_1 + 1
    t261 = k_sp_1*t260*w_b_1
    t262 = c_E*t261
    t263 = 1.0/((l_f_1_2 + t262)**2)
    t264 = t261*x_1_by_b_1_x
    t265 = t263*t264
    t266 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    t267 = -U_2_x_1**2 - U_2_y_1**2 - U_2_z_1**2
    t268 = -U_3_x_1**2 - U_3_y_1**2 - U_3_z_1**2
    t269 = 1.0/((l_f_1_3 + t262)**2)
    t270 = U_1_x_2*mu_1
    t271 = U_2_x_2*mu_2
    t272 = U_3_x_2*mu_3
    t273 = U_1_y_2*mu_1
    t274 = U_2_y_2*mu_2
    t275 = U_3_y_2*mu_3
    t276 = U_1_z_2*mu_1
    t277 = U_2_z_2*mu_2
    t278 = U_3_z_2*mu_3
    t279 = -U_1_x_1*U_1_x_2 - U_1_y_1*U_1_y_2 - U_1_z_1*U_1_z_2
    t280 = -U_2_x_1*U_2_x_2 - U_2_y_1*U_2_y_2 - U_2_z_1*U_2_z_2
    t281 = -U_3_x_1*U_3_x_2 - U_3_y_1*U_3_y_2 - U_3_z_1*U_3_z_2
    t282 = U_1_x_3*mu_1
    t283 = U_2_x_3*mu_2
    t284 = U_3_x_3*mu_3
    t285 = U_1_y_3*mu_1
    t286 = U_2_y_3*mu_2
    t287 = U_3_y_3*mu_3
    t288 = U_1_z_3*mu_1
    t289 = U_2_z_3*mu_2
    t290 = U_3_z_3*mu_3
    t291 = -U_1_x_1*U_1_x_3 - U_1_y_1*U_1_y_3 - U_1_z_1*U_1_z_3
    t292 = -U_2_x_1*U_2_x_3 - U_2_y_1*U_2_y_3 - U_2_z_1*U_2_z_3
    t293 = -U_3_x_1*U_3_x_3 - U_3_y_1*U_3_y_3 - U_3_z_1*U_3_z_3
    t294 = t264*t269
    t295 = -R_p_1*t294
    t296 = R_p_1*t265
    t297 = D_p_x_1_by_b_1_x*k_C
    t298 = D_p_y_1_by_b_1_x*k_C
    t299 = D_p_z_1_by_b_1_x*k_C
    t300 = D_delta_x_1*mu_1
    t301 = D_delta_x_1*mu_2
    t302 = D_delta_x_1*mu_3
    t303 = D_delta_y_1*mu_1
    t304 = D_delta_y_1*mu_2
    t305 = D_delta_y_1*mu_3
    t306 = D_delta_z_1*mu_1
    t307 = D_delta_z_1*mu_2
    t308 = D_delta_z_1*mu_3
    t309 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t310 = -D_delta_x_1*U_2_x_1 - D_delta_y_1*U_2_y_1 - D_delta_z_1*U_2_z_1
    t311 = -D_delta_x_1*U_3_x_1 - D_delta_y_1*U_3_y_1 - D_delta_z_1*U_3_z_1
    t312 = D_p_x_1*k_C - t248 - t250 - t251
    t313 = D_p_y_1*k_C - t252 - t254 - t255
    t314 = D_p_z_1*k_C - t256 - t258 - t259
    t315 = D_delta_x_2*mu_1
    t316 = D_delta_x_2*mu_2
    t317 = D_delta_x_2*mu_3
    t318 = D_delta_y_2*mu_1
    t319 = D_delta_y_2*mu_2
    t320 = D_delta_y_2*mu_3
    t321 = D_delta_z_2*mu_1
    t322 = D_delta_z_2*mu_2
    t323 = D_delta_z_2*mu_3
    t324 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t325 = -D_delta_x_2*U_2_x_1 - D_delta_y_2*U_2_y_1 - D_delta_z_2*U_2_z_1
    t326 = -D_delta_x_2*U_3_x_1 - D_delta_y_2*U_3_y_1 - D_delta_z_2*U_3_z_1
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
    t337 = -D_delta_x_3*U_2_x_1 - D_delta_y_3*U_2_y_1 - D_delta_z_3*U_2_z_1
    t338 = -D_delta_x_3*U_3_x_1 - D_delta_y_3*U_3_y_1 - D_delta_z_3*U_3_z_1
    t339 = -t265 + t294
    t340 = 2*D_p_x_2_by_b_1_x
    t341 = 2*D_p_y_2_by_b_1_x
    t342 = 2*D_p_z_2_by_b_1_x
    t343 = -U_1_x_2**2 - U_1_y_2**2 - U_1_z_2**2
    t344 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t345 = -U_3_x_2**2 - U_3_y_2**2 - U_3_z_2**2
    t346 = -U_1_x_2*U_1_x_3 - U_1_y_2*U_1_y_3 - U_1_z_2*U_1_z_3
    t347 = -U_2_x_2*U_2_x_3 - U_2_y_2*U_2_y_3 - U_2_z_2*U_2_z_3
    t348 = -U_3_x_2*U_3_x_3 - U_3_y_2*U_3_y_3 - U_3_z_2*U_3_z_3
    t349 = D_p_x_2_by_b_1_x*k_C
    t350 = D_p_y_2_by_b_1_x*k_C
    t351 = D_p_z_2_by_b_1_x*k_C
    t352 = -D_delta_x_1*U_1_x_2 - D_delta_y_1*U_1_y_2 - D_delta_z_1*U_1_z_2
    t353 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t354 = -D_delta_x_1*U_3_x_2 - D_delta_y_1*U_3_y_2 - D_delta_z_1*U_3_z_2
    t355 = D_p_x_2*k_C - t270 - t271 - t272
    t356 = D_p_y_2*k_C - t273 - t274 - t275
    t357 = D_p_z_2*k_C - t276 - t277 - t278
    t358 = -D_delta_x_2*U_1_x_2 - D_delta_y_2*U_1_y_2 - D_delta_z_2*U_1_z_2
    t359 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t360 = -D_delta_x_2*U_3_x_2 - D_delta_y_2*U_3_y_2 - D_delta_z_2*U_3_z_2
    t361 = -D_delta_x_3*U_1_x_2 - D_delta_y_3*U_1_y_2 - D_delta_z_3*U_1_z_2
    t362 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t363 = -D_delta_x_3*U_3_x_2 - D_delta_y_3*U_3_y_2 - D_delta_z_3*U_3_z_2
    t364 = 2*D_p_x_3_by_b_1_x
    t365 = 2*D_p_y_3_by_b_1_x
    t366 = 2*D_p_z_3_by_b_1_x
    t367 = -U_1_x_3**2 - U_1_y_3**2 - U_1_z_3**2
    t368 = -U_2_x_3**2 - U_2_y_3**2 - U_2_z_3**2
    t369 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t370 = D_p_x_3_by_b_1_x*k_C
    t371 = D_p_y_3_by_b_1_x*k_C
    t372 = D_p_z_3_by_b_1_x*k_C
    t373 = -D_delta_x_1*U_1_x_3 - D_delta_y_1*U_1_y_3 - D_delta_z_1*U_1_z_3
    t374 = -D_delta_x_1*U_2_x_3 - D_delta_y_1*U_2_y_3 - D_delta_z_1*U_2_z_3
    t375 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t376 = D_p_x_3*k_C - t282 - t283 - t284
    t377 = D_p_y_3*k_C - t285 - t286 - t287
    t378 = D_p_z_3*k_C - t288 - t289 - t290
    t379 = -D_delta_x_2*U_1_x_3 - D_delta_y_2*U_1_y_3 - D_delta_z_2*U_1_z_3
    t380 = -D_delta_x_2*U_2_x_3 - D_delta_y_2*U_2_y_3 - D_delta_z_2*U_2_z_3
    t381 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t382 = -D_delta_x_3*U_1_x_3 - D_delta_y_3*U_1_y_3 - D_delta_z_3*U_1_z_3
    t383 = -D_delta_x_3*U_2_x_3 - D_delta_y_3*U_2_y_3 - D_delta_z_3*U_2_z_3
    t384 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t385 = D_delta_x_1**2 + D_delta_y_1**2 + D_delta_z_1**2
    t386 = 2*D_delta_x_1*k_C - 2*t300 - 2*t301 - 2*t302
    t387 = 2*D_delta_y_1*k_C - 2*t303 - 2*t304 - 2*t305
    t388 = 2*D_delta_z_1*k_C - 2*t306 - 2*t307 - 2*t308
    t389 = 1 - t385
    t390 = -D_delta_x_1*D_delta_x_2 - D_delta_y_1*D_delta_y_2 - D_delta_z_1*D_delta_z_2
    t391 = D_delta_x_2*k_C - t315 - t316 - t317
    t392 = D_delta_x_1*k_C - t300 - t301 - t302
    t393 = D_delta_y_2*k_C - t318 - t319 - t320
    t394 = D_delta_y_1*k_C - t303 - t304 - t305
    t395 = D_delta_z_2*k_C - t321 - t322 - t323
    t396 = D_delta_z_1*k_C - t306 - t307 - t308
    t397 = -D_delta_x_1*D_delta_x_3 - D_delta_y_1*D_delta_y_3 - D_delta_z_1*D_delta_z_3
    t398 = D_delta_x_3*k_C - t327 - t328 - t329
    t399 = D_delta_y_3*k_C - t330 - t331 - t332
    t400 = D_delta_z_3*k_C - t333 - t334 - t335
    t401 = D_delta_x_2**2 + D_delta_y_2**2 + D_delta_z_2**2
    t402 = 2*D_delta_x_2*k_C - 2*t315 - 2*t316 - 2*t317
    t403 = 2*D_delta_y_2*k_C - 2*t318 - 2*t319 - 2*t320
    t404 = 2*D_delta_z_2*k_C - 2*t321 - 2*t322 - 2*t323
    t405 = 1 - t401
    t406 = -D_delta_x_2*D_delta_x_3 - D_delta_y_2*D_delta_y_3 - D_delta_z_2*D_delta_z_3
    t407 = D_delta_x_3**2 + D_delta_y_3**2 + D_delta_z_3**2
    t408 = 2*D_delta_x_3*k_C - 2*t327 - 2*t328 - 2*t329
    t409 = 2*D_delta_y_3*k_C - 2*t330 - 2*t331 - 2*t332
    t410 = 2*D_delta_z_3*k_C - 2*t333 - 2*t334 - 2*t335
    t411 = 1 - t407
    t412 = 2*D_p_x_1_by_b_1_y
    t413 = 2*D_p_y_1_by_b_1_y
    t414 = 2*D_p_z_1_by_b_1_y
    t415 = t261*x_1_by_b_1_y
    t416 = t263*t415
    t417 = t269*t415
    t418 = -R_p_1*t417
    t419 = R_p_1*t416
    t420 = D_delta_x_1*k_C
    t421 = D_delta_y_1*k_C
    t422 = D_delta_z_1*k_C
    t423 = D_delta_x_2*k_C
    t424 = D_delta_y_2*k_C
    t425 = D_delta_z_2*k_C
    t426 = D_delta_x_3*k_C
    t427 = D_delta_y_3*k_C
    t428 = D_delta_z_3*k_C
    t429 = -t416 + t417
    t430 = 2*D_p_x_2_by_b_1_y
    t431 = 2*D_p_y_2_by_b_1_y
    t432 = 2*D_p_z_2_by_b_1_y
    t433 = 2*D_p_x_3_by_b_1_y
    t434 = 2*D_p_y_3_by_b_1_y
    t435 = 2*D_p_z_3_by_b_1_y
    t436 = 2*D_p_x_1_by_b_1_z
    t437 = 2*D_p_y_1_by_b_1_z
    t438 = 2*D_p_z_1_by_b_1_z
    t439 = t261*x_1_by_b_1_z
    t440 = t263*t439
    t441 = t269*t439
    t442 = -R_p_1*t441
    t443 = R_p_1*t440
    t444 = -t440 + t441
    t445 = 2*D_p_x_2_by_b_1_z
    t446 = 2*D_p_y_2_by_b_1_z
    t447 = 2*D_p_z_2_by_b_1_z
    t448 = 2*D_p_x_3_by_b_1_z
    t449 = 2*D_p_y_3_by_b_1_z
    t450 = 2*D_p_z_3_by_b_1_z
    t451 = 2*D_p_x_1_by_b_2_x
    t452 = 2*D_p_y_1_by_b_2_x
    t453 = 2*D_p_z_1_by_b_2_x
    t454 = 2*D_p_x_2_by_b_2_x
    t455 = 2*D_p_y_2_by_b_2_x
    t456 = 2*D_p_z_2_by_b_2_x
    t457 = a_B_2 + 1
    t458 = k_sp_2*t457*w_b_2
    t459 = c_E*t458
    t460 = 1.0/((l_f_2_2 + t459)**2)
    t461 = t458*x_2_by_b_2_x
    t462 = t460*t461
    t463 = 1.0/((l_f_2_3 + t459)**2)
    t464 = t461*t463
    t465 = -R_p_2*t464
    t466 = R_p_2*t462
    t467 = -t462 + t464
    t468 = 2*D_p_x_3_by_b_2_x
    t469 = 2*D_p_y_3_by_b_2_x
    t470 = 2*D_p_z_3_by_b_2_x
    t471 = 2*D_p_x_1_by_b_2_y
    t472 = 2*D_p_y_1_by_b_2_y
    t473 = 2*D_p_z_1_by_b_2_y
    t474 = 2*D_p_x_2_by_b_2_y
    t475 = 2*D_p_y_2_by_b_2_y
    t476 = 2*D_p_z_2_by_b_2_y
    t477 = t458*x_2_by_b_2_y
    t478 = t460*t477
    t479 = t463*t477
    t480 = -R_p_2*t479
    t481 = R_p_2*t478
    t482 = -t478 + t479
    t483 = 2*D_p_x_3_by_b_2_y
    t484 = 2*D_p_y_3_by_b_2_y
    t485 = 2*D_p_z_3_by_b_2_y
    t486 = 2*D_p_x_1_by_b_2_z
    t487 = 2*D_p_y_1_by_b_2_z
    t488 = 2*D_p_z_1_by_b_2_z
    t489 = 2*D_p_x_2_by_b_2_z
    t490 = 2*D_p_y_2_by_b_2_z
    t491 = 2*D_p_z_2_by_b_2_z
    t492 = t458*x_2_by_b_2_z
    t493 = t460*t492
    t494 = t463*t492
    t495 = -R_p_2*t494
    t496 = R_p_2*t493
    t497 = -t493 + t494
    t498 = 2*D_p_x_3_by_b_2_z
    t499 = 2*D_p_y_3_by_b_2_z
    t500 = 2*D_p_z_3_by_b_2_z
    t501 = 2*D_p_x_1_by_b_3_x
    t502 = 2*D_p_y_1_by_b_3_x
    t503 = 2*D_p_z_1_by_b_3_x
    t504 = 2*D_p_x_2_by_b_3_x
    t505 = 2*D_p_y_2_by_b_3_x
    t506 = 2*D_p_z_2_by_b_3_x
    t507 = 2*D_p_x_3_by_b_3_x
    t508 = 2*D_p_y_3_by_b_3_x
    t509 = 2*D_p_z_3_by_b_3_x
    t510 = a_B_3 + 1
    t511 = k_sp_3*t510*w_b_3
    t512 = c_E*t511
    t513 = 1.0/((l_f_3_2 + t512)**2)
    t514 = t511*x_3_by_b_3_x
    t515 = t513*t514
    t516 = 1.0/((l_f_3_3 + t512)**2)
    t517 = t514*t516
    t518 = -R_p_3*t517
    t519 = R_p_3*t515
    t520 = -t515 + t517
    t521 = 2*D_p_x_1_by_b_3_y
    t522 = 2*D_p_y_1_by_b_3_y
    t523 = 2*D_p_z_1_by_b_3_y
    t524 = 2*D_p_x_2_by_b_3_y
    t525 = 2*D_p_y_2_by_b_3_y
    t526 = 2*D_p_z_2_by_b_3_y
    t527 = 2*D_p_x_3_by_b_3_y
    t528 = 2*D_p_y_3_by_b_3_y
    t529 = 2*D_p_z_3_by_b_3_y
    t530 = t511*x_3_by_b_3_y
    t531 = t513*t530
    t532 = t516*t530
    t533 = -R_p_3*t532
    t534 = R_p_3*t531
    t535 = -t531 + t532
    t536 = 2*D_p_x_1_by_b_3_z
    t537 = 2*D_p_y_1_by_b_3_z
    t538 = 2*D_p_z_1_by_b_3_z
    t539 = 2*D_p_x_2_by_b_3_z
    t540 = 2*D_p_y_2_by_b_3_z
    t541 = 2*D_p_z_2_by_b_3_z
    t542 = 2*D_p_x_3_by_b_3_z
    t543 = 2*D_p_y_3_by_b_3_z
    t544 = 2*D_p_z_3_by_b_3_z
    t545 = t511*x_3_by_b_3_z
    t546 = t513*t545
    t547 = t516*t545
    t548 = -R_p_3*t547
    t549 = R_p_3*t546
    t550 = -t546 + t547
    t551 = 2*D_p_x_1_by_l_d_1
    t552 = 2*D_p_y_1_by_l_d_1
    t553 = 2*D_p_z_1_by_l_d_1
    t554 = t261*x_1_by_l_d_1
    t555 = t263*t554
    t556 = t269*t554
    t557 = -R_p_1*t556
    t558 = R_p_1*t555
    t559 = -t555 + t556
    t560 = 2*D_p_x_2_by_l_d_1
    t561 = 2*D_p_y_2_by_l_d_1
    t562 = 2*D_p_z_2_by_l_d_1
    t563 = 2*D_p_x_3_by_l_d_1
    t564 = 2*D_p_y_3_by_l_d_1
    t565 = 2*D_p_z_3_by_l_d_1
    t566 = 2*D_p_x_1_by_l_d_2
    t567 = 2*D_p_y_1_by_l_d_2
    t568 = 2*D_p_z_1_by_l_d_2
    t569 = 2*D_p_x_2_by_l_d_2
    t570 = 2*D_p_y_2_by_l_d_2
    t571 = 2*D_p_z_2_by_l_d_2
    t572 = t458*x_2_by_l_d_2
    t573 = t460*t572
    t574 = t463*t572
    t575 = -R_p_2*t574
    t576 = R_p_2*t573
    t577 = -t573 + t574
    t578 = 2*D_p_x_3_by_l_d_2
    t579 = 2*D_p_y_3_by_l_d_2
    t580 = 2*D_p_z_3_by_l_d_2
    t581 = 2*D_p_x_1_by_l_d_3
    t582 = 2*D_p_y_1_by_l_d_3
    t583 = 2*D_p_z_1_by_l_d_3
    t584 = 2*D_p_x_2_by_l_d_3
    t585 = 2*D_p_y_2_by_l_d_3
    t586 = 2*D_p_z_2_by_l_d_3
    t587 = 2*D_p_x_3_by_l_d_3
    t588 = 2*D_p_y_3_by_l_d_3
    t589 = 2*D_p_z_3_by_l_d_3
    t590 = t511*x_3_by_l_d_3
    t591 = t513*t590
    t592 = t516*t590
    t593 = -R_p_3*t592
    t594 = R_p_3*t591
    t595 = -t591 + t592
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
        + k_sp_1*t260*t269*w_b_1*x_1_by_b_1_x + mu_1_by_b_1_x*t266 + mu_2_by_b_1_x*t267
        + mu_3_by_b_1_x*t268 - t248*t249 - t249*t250 - t249*t251 - t252*t253 - t253*t254 - t253*t255
        - t256*t257 - t257*t258 - t257*t259 - t265,
        D_p_x_1*D_p_x_2_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_2*k_C - D_p_x_1_by_b_1_x*t270
        - D_p_x_1_by_b_1_x*t271 - D_p_x_1_by_b_1_x*t272 - D_p_x_2_by_b_1_x*t248 - D_p_x_2_by_b_1_x*t250
        - D_p_x_2_by_b_1_x*t251 + D_p_y_1*D_p_y_2_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_2*k_C
        - D_p_y_1_by_b_1_x*t273 - D_p_y_1_by_b_1_x*t274 - D_p_y_1_by_b_1_x*t275 - D_p_y_2_by_b_1_x*t252
        - D_p_y_2_by_b_1_x*t254 - D_p_y_2_by_b_1_x*t255 + D_p_z_1*D_p_z_2_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_2*k_C - D_p_z_1_by_b_1_x*t276 - D_p_z_1_by_b_1_x*t277
        - D_p_z_1_by_b_1_x*t278 - D_p_z_2_by_b_1_x*t256 - D_p_z_2_by_b_1_x*t258 - D_p_z_2_by_b_1_x*t259
        + mu_1_by_b_1_x*t279 + mu_2_by_b_1_x*t280 + mu_3_by_b_1_x*t281,
        D_p_x_1*D_p_x_3_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_3*k_C - D_p_x_1_by_b_1_x*t282
        - D_p_x_1_by_b_1_x*t283 - D_p_x_1_by_b_1_x*t284 - D_p_x_3_by_b_1_x*t248 - D_p_x_3_by_b_1_x*t250
        - D_p_x_3_by_b_1_x*t251 + D_p_y_1*D_p_y_3_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_3*k_C
        - D_p_y_1_by_b_1_x*t285 - D_p_y_1_by_b_1_x*t286 - D_p_y_1_by_b_1_x*t287 - D_p_y_3_by_b_1_x*t252
        - D_p_y_3_by_b_1_x*t254 - D_p_y_3_by_b_1_x*t255 + D_p_z_1*D_p_z_3_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_3*k_C - D_p_z_1_by_b_1_x*t288 - D_p_z_1_by_b_1_x*t289
        - D_p_z_1_by_b_1_x*t290 - D_p_z_3_by_b_1_x*t256 - D_p_z_3_by_b_1_x*t258 - D_p_z_3_by_b_1_x*t259
        + mu_1_by_b_1_x*t291 + mu_2_by_b_1_x*t292 + mu_3_by_b_1_x*t293,
        t295, t296,
        D_delta_x_1*t297 + D_delta_x_1_by_b_1_x*t312 + D_delta_y_1*t298 + D_delta_y_1_by_b_1_x*t313
        + D_delta_z_1*t299 + D_delta_z_1_by_b_1_x*t314 - D_p_x_1_by_b_1_x*t300 - D_p_x_1_by_b_1_x*t301
        - D_p_x_1_by_b_1_x*t302 - D_p_y_1_by_b_1_x*t303 - D_p_y_1_by_b_1_x*t304 - D_p_y_1_by_b_1_x*t305
        - D_p_z_1_by_b_1_x*t306 - D_p_z_1_by_b_1_x*t307 - D_p_z_1_by_b_1_x*t308 + mu_1_by_b_1_x*t309
        + mu_2_by_b_1_x*t310 + mu_3_by_b_1_x*t311,
        D_delta_x_2*t297 + D_delta_x_2_by_b_1_x*t312 + D_delta_y_2*t298 + D_delta_y_2_by_b_1_x*t313
        + D_delta_z_2*t299 + D_delta_z_2_by_b_1_x*t314 - D_p_x_1_by_b_1_x*t315 - D_p_x_1_by_b_1_x*t316
        - D_p_x_1_by_b_1_x*t317 - D_p_y_1_by_b_1_x*t318 - D_p_y_1_by_b_1_x*t319 - D_p_y_1_by_b_1_x*t320
        - D_p_z_1_by_b_1_x*t321 - D_p_z_1_by_b_1_x*t322 - D_p_z_1_by_b_1_x*t323 + mu_1_by_b_1_x*t324
        + mu_2_by_b_1_x*t325 + mu_3_by_b_1_x*t326,
        D_delta_x_3*t297 + D_delta_x_3_by_b_1_x*t312 + D_delta_y_3*t298 + D_delta_y_3_by_b_1_x*t313
        + D_delta_z_3*t299 + D_delta_z_3_by_b_1_x*t314 - D_p_x_1_by_b_1_x*t327 - D_p_x_1_by_b_1_x*t328
        - D_p_x_1_by_b_1_x*t329 - D_p_y_1_by_b_1_x*t330 - D_p_y_1_by_b_1_x*t331 - D_p_y_1_by_b_1_x*t332
        - D_p_z_1_by_b_1_x*t333 - D_p_z_1_by_b_1_x*t334 - D_p_z_1_by_b_1_x*t335 + mu_1_by_b_1_x*t336
        + mu_2_by_b_1_x*t337 + mu_3_by_b_1_x*t338,
        t339, t297, t298, t299,
        2*D_p_x_2*D_p_x_2_by_b_1_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_x*k_C
        + mu_1_by_b_1_x*t343 + mu_2_by_b_1_x*t344 + mu_3_by_b_1_x*t345 - t270*t340 - t271*t340 - t272*t340
        - t273*t341 - t274*t341 - t275*t341 - t276*t342 - t277*t342 - t278*t342,
        D_p_x_2*D_p_x_3_by_b_1_x*k_C + D_p_x_2_by_b_1_x*D_p_x_3*k_C - D_p_x_2_by_b_1_x*t282
        - D_p_x_2_by_b_1_x*t283 - D_p_x_2_by_b_1_x*t284 - D_p_x_3_by_b_1_x*t270 - D_p_x_3_by_b_1_x*t271
        - D_p_x_3_by_b_1_x*t272 + D_p_y_2*D_p_y_3_by_b_1_x*k_C + D_p_y_2_by_b_1_x*D_p_y_3*k_C
        - D_p_y_2_by_b_1_x*t285 - D_p_y_2_by_b_1_x*t286 - D_p_y_2_by_b_1_x*t287 - D_p_y_3_by_b_1_x*t273
        - D_p_y_3_by_b_1_x*t274 - D_p_y_3_by_b_1_x*t275 + D_p_z_2*D_p_z_3_by_b_1_x*k_C
        + D_p_z_2_by_b_1_x*D_p_z_3*k_C - D_p_z_2_by_b_1_x*t288 - D_p_z_2_by_b_1_x*t289
        - D_p_z_2_by_b_1_x*t290 - D_p_z_3_by_b_1_x*t276 - D_p_z_3_by_b_1_x*t277 - D_p_z_3_by_b_1_x*t278
        + mu_1_by_b_1_x*t346 + mu_2_by_b_1_x*t347 + mu_3_by_b_1_x*t348,
        D_delta_x_1*t349 + D_delta_x_1_by_b_1_x*t355 + D_delta_y_1*t350 + D_delta_y_1_by_b_1_x*t356
        + D_delta_z_1*t351 + D_delta_z_1_by_b_1_x*t357 - D_p_x_2_by_b_1_x*t300 - D_p_x_2_by_b_1_x*t301
        - D_p_x_2_by_b_1_x*t302 - D_p_y_2_by_b_1_x*t303 - D_p_y_2_by_b_1_x*t304 - D_p_y_2_by_b_1_x*t305
        - D_p_z_2_by_b_1_x*t306 - D_p_z_2_by_b_1_x*t307 - D_p_z_2_by_b_1_x*t308 + mu_1_by_b_1_x*t352
        + mu_2_by_b_1_x*t353 + mu_3_by_b_1_x*t354,
        D_delta_x_2*t349 + D_delta_x_2_by_b_1_x*t355 + D_delta_y_2*t350 + D_delta_y_2_by_b_1_x*t356
        + D_delta_z_2*t351 + D_delta_z_2_by_b_1_x*t357 - D_p_x_2_by_b_1_x*t315 - D_p_x_2_by_b_1_x*t316
        - D_p_x_2_by_b_1_x*t317 - D_p_y_2_by_b_1_x*t318 - D_p_y_2_by_b_1_x*t319 - D_p_y_2_by_b_1_x*t320
        - D_p_z_2_by_b_1_x*t321 - D_p_z_2_by_b_1_x*t322 - D_p_z_2_by_b_1_x*t323 + mu_1_by_b_1_x*t358
        + mu_2_by_b_1_x*t359 + mu_3_by_b_1_x*t360,
        D_delta_x_3*t349 + D_delta_x_3_by_b_1_x*t355 + D_delta_y_3*t350 + D_delta_y_3_by_b_1_x*t356
        + D_delta_z_3*t351 + D_delta_z_3_by_b_1_x*t357 - D_p_x_2_by_b_1_x*t327 - D_p_x_2_by_b_1_x*t328
        - D_p_x_2_by_b_1_x*t329 - D_p_y_2_by_b_1_x*t330 - D_p_y_2_by_b_1_x*t331 - D_p_y_2_by_b_1_x*t332
        - D_p_z_2_by_b_1_x*t333 - D_p_z_2_by_b_1_x*t334 - D_p_z_2_by_b_1_x*t335 + mu_1_by_b_1_x*t361
        + mu_2_by_b_1_x*t362 + mu_3_by_b_1_x*t363,
        t349, t350, t351,
        2*D_p_x_3*D_p_x_3_by_b_1_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_x*k_C
        + mu_1_by_b_1_x*t367 + mu_2_by_b_1_x*t368 + mu_3_by_b_1_x*t369 - t282*t364 - t283*t364 - t284*t364
        - t285*t365 - t286*t365 - t287*t365 - t288*t366 - t289*t366 - t290*t366,
        D_delta_x_1*t370 + D_delta_x_1_by_b_1_x*t376 + D_delta_y_1*t371 + D_delta_y_1_by_b_1_x*t377
        + D_delta_z_1*t372 + D_delta_z_1_by_b_1_x*t378 - D_p_x_3_by_b_1_x*t300 - D_p_x_3_by_b_1_x*t301
        - D_p_x_3_by_b_1_x*t302 - D_p_y_3_by_b_1_x*t303 - D_p_y_3_by_b_1_x*t304 - D_p_y_3_by_b_1_x*t305
        - D_p_z_3_by_b_1_x*t306 - D_p_z_3_by_b_1_x*t307 - D_p_z_3_by_b_1_x*t308 + mu_1_by_b_1_x*t373
        + mu_2_by_b_1_x*t374 + mu_3_by_b_1_x*t375,
        D_delta_x_2*t370 + D_delta_x_2_by_b_1_x*t376 + D_delta_y_2*t371 + D_delta_y_2_by_b_1_x*t377
        + D_delta_z_2*t372 + D_delta_z_2_by_b_1_x*t378 - D_p_x_3_by_b_1_x*t315 - D_p_x_3_by_b_1_x*t316
        - D_p_x_3_by_b_1_x*t317 - D_p_y_3_by_b_1_x*t318 - D_p_y_3_by_b_1_x*t319 - D_p_y_3_by_b_1_x*t320
        - D_p_z_3_by_b_1_x*t321 - D_p_z_3_by_b_1_x*t322 - D_p_z_3_by_b_1_x*t323 + mu_1_by_b_1_x*t379
        + mu_2_by_b_1_x*t380 + mu_3_by_b_1_x*t381,
        D_delta_x_3*t370 + D_delta_x_3_by_b_1_x*t376 + D_delta_y_3*t371 + D_delta_y_3_by_b_1_x*t377
        + D_delta_z_3*t372 + D_delta_z_3_by_b_1_x*t378 - D_p_x_3_by_b_1_x*t327 - D_p_x_3_by_b_1_x*t328
        - D_p_x_3_by_b_1_x*t329 - D_p_y_3_by_b_1_x*t330 - D_p_y_3_by_b_1_x*t331 - D_p_y_3_by_b_1_x*t332
        - D_p_z_3_by_b_1_x*t333 - D_p_z_3_by_b_1_x*t334 - D_p_z_3_by_b_1_x*t335 + mu_1_by_b_1_x*t382
        + mu_2_by_b_1_x*t383 + mu_3_by_b_1_x*t384,
        t370, t371, t372, t185*t294, t295, -t185*t265, t296,
        D_delta_x_1_by_b_1_x*t386 + D_delta_y_1_by_b_1_x*t387 + D_delta_z_1_by_b_1_x*t388
        + mu_1_by_b_1_x*t389 - mu_2_by_b_1_x*t385 - mu_3_by_b_1_x*t385,
        D_delta_x_1_by_b_1_x*t391 + D_delta_x_2_by_b_1_x*t392 + D_delta_y_1_by_b_1_x*t393
        + D_delta_y_2_by_b_1_x*t394 + D_delta_z_1_by_b_1_x*t395 + D_delta_z_2_by_b_1_x*t396
        + mu_1_by_b_1_x*t390 + mu_2_by_b_1_x*t390 + mu_3_by_b_1_x*t390,
        D_delta_x_1_by_b_1_x*t398 + D_delta_x_3_by_b_1_x*t392 + D_delta_y_1_by_b_1_x*t399
        + D_delta_y_3_by_b_1_x*t394 + D_delta_z_1_by_b_1_x*t400 + D_delta_z_3_by_b_1_x*t396
        + mu_1_by_b_1_x*t397 + mu_2_by_b_1_x*t397 + mu_3_by_b_1_x*t397,
        D_delta_x_1_by_b_1_x*k_C, D_delta_y_1_by_b_1_x*k_C, D_delta_z_1_by_b_1_x*k_C,
        D_delta_x_2_by_b_1_x*t402 + D_delta_y_2_by_b_1_x*t403 + D_delta_z_2_by_b_1_x*t404
        - mu_1_by_b_1_x*t401 + mu_2_by_b_1_x*t405 - mu_3_by_b_1_x*t401,
        D_delta_x_2_by_b_1_x*t398 + D_delta_x_3_by_b_1_x*t391 + D_delta_y_2_by_b_1_x*t399
        + D_delta_y_3_by_b_1_x*t393 + D_delta_z_2_by_b_1_x*t400 + D_delta_z_3_by_b_1_x*t395
        + mu_1_by_b_1_x*t406 + mu_2_by_b_1_x*t406 + mu_3_by_b_1_x*t406,
        D_delta_x_2_by_b_1_x*k_C, D_delta_y_2_by_b_1_x*k_C, D_delta_z_2_by_b_1_x*k_C,
        D_delta_x_3_by_b_1_x*t408 + D_delta_y_3_by_b_1_x*t409 + D_delta_z_3_by_b_1_x*t410
        - mu_1_by_b_1_x*t407 - mu_2_by_b_1_x*t407 + mu_3_by_b_1_x*t411,
        D_delta_x_3_by_b_1_x*k_C, D_delta_y_3_by_b_1_x*k_C, D_delta_z_3_by_b_1_x*k_C, t339,
        2*D_p_x_1*D_p_x_1_by_b_1_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_y*k_C
        + k_sp_1*t260*t269*w_b_1*x_1_by_b_1_y + mu_1_by_b_1_y*t266 + mu_2_by_b_1_y*t267
        + mu_3_by_b_1_y*t268 - t248*t412 - t250*t412 - t251*t412 - t252*t413 - t254*t413 - t255*t413
        - t256*t414 - t258*t414 - t259*t414 - t416,
        D_p_x_1*D_p_x_2_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_2*k_C - D_p_x_1_by_b_1_y*t270
        - D_p_x_1_by_b_1_y*t271 - D_p_x_1_by_b_1_y*t272 - D_p_x_2_by_b_1_y*t248 - D_p_x_2_by_b_1_y*t250
        - D_p_x_2_by_b_1_y*t251 + D_p_y_1*D_p_y_2_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_2*k_C
        - D_p_y_1_by_b_1_y*t273 - D_p_y_1_by_b_1_y*t274 - D_p_y_1_by_b_1_y*t275 - D_p_y_2_by_b_1_y*t252
        - D_p_y_2_by_b_1_y*t254 - D_p_y_2_by_b_1_y*t255 + D_p_z_1*D_p_z_2_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_2*k_C - D_p_z_1_by_b_1_y*t276 - D_p_z_1_by_b_1_y*t277
        - D_p_z_1_by_b_1_y*t278 - D_p_z_2_by_b_1_y*t256 - D_p_z_2_by_b_1_y*t258 - D_p_z_2_by_b_1_y*t259
        + mu_1_by_b_1_y*t279 + mu_2_by_b_1_y*t280 + mu_3_by_b_1_y*t281,
        D_p_x_1*D_p_x_3_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_3*k_C - D_p_x_1_by_b_1_y*t282
        - D_p_x_1_by_b_1_y*t283 - D_p_x_1_by_b_1_y*t284 - D_p_x_3_by_b_1_y*t248 - D_p_x_3_by_b_1_y*t250
        - D_p_x_3_by_b_1_y*t251 + D_p_y_1*D_p_y_3_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_3*k_C
        - D_p_y_1_by_b_1_y*t285 - D_p_y_1_by_b_1_y*t286 - D_p_y_1_by_b_1_y*t287 - D_p_y_3_by_b_1_y*t252
        - D_p_y_3_by_b_1_y*t254 - D_p_y_3_by_b_1_y*t255 + D_p_z_1*D_p_z_3_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_3*k_C - D_p_z_1_by_b_1_y*t288 - D_p_z_1_by_b_1_y*t289
        - D_p_z_1_by_b_1_y*t290 - D_p_z_3_by_b_1_y*t256 - D_p_z_3_by_b_1_y*t258 - D_p_z_3_by_b_1_y*t259
        + mu_1_by_b_1_y*t291 + mu_2_by_b_1_y*t292 + mu_3_by_b_1_y*t293,
        t418, t419,
        D_delta_x_1_by_b_1_y*t312 + D_delta_y_1_by_b_1_y*t313 + D_delta_z_1_by_b_1_y*t314
        - D_p_x_1_by_b_1_y*t300 - D_p_x_1_by_b_1_y*t301 - D_p_x_1_by_b_1_y*t302 + D_p_x_1_by_b_1_y*t420
        - D_p_y_1_by_b_1_y*t303 - D_p_y_1_by_b_1_y*t304 - D_p_y_1_by_b_1_y*t305 + D_p_y_1_by_b_1_y*t421
        - D_p_z_1_by_b_1_y*t306 - D_p_z_1_by_b_1_y*t307 - D_p_z_1_by_b_1_y*t308 + D_p_z_1_by_b_1_y*t422
        + mu_1_by_b_1_y*t309 + mu_2_by_b_1_y*t310 + mu_3_by_b_1_y*t311,
        D_delta_x_2_by_b_1_y*t312 + D_delta_y_2_by_b_1_y*t313 + D_delta_z_2_by_b_1_y*t314
        - D_p_x_1_by_b_1_y*t315 - D_p_x_1_by_b_1_y*t316 - D_p_x_1_by_b_1_y*t317 + D_p_x_1_by_b_1_y*t423
        - D_p_y_1_by_b_1_y*t318 - D_p_y_1_by_b_1_y*t319 - D_p_y_1_by_b_1_y*t320 + D_p_y_1_by_b_1_y*t424
        - D_p_z_1_by_b_1_y*t321 - D_p_z_1_by_b_1_y*t322 - D_p_z_1_by_b_1_y*t323 + D_p_z_1_by_b_1_y*t425
        + mu_1_by_b_1_y*t324 + mu_2_by_b_1_y*t325 + mu_3_by_b_1_y*t326,
        D_delta_x_3_by_b_1_y*t312 + D_delta_y_3_by_b_1_y*t313 + D_delta_z_3_by_b_1_y*t314
        - D_p_x_1_by_b_1_y*t327 - D_p_x_1_by_b_1_y*t328 - D_p_x_1_by_b_1_y*t329 + D_p_x_1_by_b_1_y*t426
        - D_p_y_1_by_b_1_y*t330 - D_p_y_1_by_b_1_y*t331 - D_p_y_1_by_b_1_y*t332 + D_p_y_1_by_b_1_y*t427
        - D_p_z_1_by_b_1_y*t333 - D_p_z_1_by_b_1_y*t334 - D_p_z_1_by_b_1_y*t335 + D_p_z_1_by_b_1_y*t428
        + mu_1_by_b_1_y*t336 + mu_2_by_b_1_y*t337 + mu_3_by_b_1_y*t338,
        t429, D_p_x_1_by_b_1_y*k_C, D_p_y_1_by_b_1_y*k_C, D_p_z_1_by_b_1_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_y*k_C
        + mu_1_by_b_1_y*t343 + mu_2_by_b_1_y*t344 + mu_3_by_b_1_y*t345 - t270*t430 - t271*t430 - t272*t430
        - t273*t431 - t274*t431 - t275*t431 - t276*t432 - t277*t432 - t278*t432,
        D_p_x_2*D_p_x_3_by_b_1_y*k_C + D_p_x_2_by_b_1_y*D_p_x_3*k_C - D_p_x_2_by_b_1_y*t282
        - D_p_x_2_by_b_1_y*t283 - D_p_x_2_by_b_1_y*t284 - D_p_x_3_by_b_1_y*t270 - D_p_x_3_by_b_1_y*t271
        - D_p_x_3_by_b_1_y*t272 + D_p_y_2*D_p_y_3_by_b_1_y*k_C + D_p_y_2_by_b_1_y*D_p_y_3*k_C
        - D_p_y_2_by_b_1_y*t285 - D_p_y_2_by_b_1_y*t286 - D_p_y_2_by_b_1_y*t287 - D_p_y_3_by_b_1_y*t273
        - D_p_y_3_by_b_1_y*t274 - D_p_y_3_by_b_1_y*t275 + D_p_z_2*D_p_z_3_by_b_1_y*k_C
        + D_p_z_2_by_b_1_y*D_p_z_3*k_C - D_p_z_2_by_b_1_y*t288 - D_p_z_2_by_b_1_y*t289
        - D_p_z_2_by_b_1_y*t290 - D_p_z_3_by_b_1_y*t276 - D_p_z_3_by_b_1_y*t277 - D_p_z_3_by_b_1_y*t278
        + mu_1_by_b_1_y*t346 + mu_2_by_b_1_y*t347 + mu_3_by_b_1_y*t348,
        D_delta_x_1_by_b_1_y*t355 + D_delta_y_1_by_b_1_y*t356 + D_delta_z_1_by_b_1_y*t357
        - D_p_x_2_by_b_1_y*t300 - D_p_x_2_by_b_1_y*t301 - D_p_x_2_by_b_1_y*t302 + D_p_x_2_by_b_1_y*t420
        - D_p_y_2_by_b_1_y*t303 - D_p_y_2_by_b_1_y*t304 - D_p_y_2_by_b_1_y*t305 + D_p_y_2_by_b_1_y*t421
        - D_p_z_2_by_b_1_y*t306 - D_p_z_2_by_b_1_y*t307 - D_p_z_2_by_b_1_y*t308 + D_p_z_2_by_b_1_y*t422
        + mu_1_by_b_1_y*t352 + mu_2_by_b_1_y*t353 + mu_3_by_b_1_y*t354,
        D_delta_x_2_by_b_1_y*t355 + D_delta_y_2_by_b_1_y*t356 + D_delta_z_2_by_b_1_y*t357
        - D_p_x_2_by_b_1_y*t315 - D_p_x_2_by_b_1_y*t316 - D_p_x_2_by_b_1_y*t317 + D_p_x_2_by_b_1_y*t423
        - D_p_y_2_by_b_1_y*t318 - D_p_y_2_by_b_1_y*t319 - D_p_y_2_by_b_1_y*t320 + D_p_y_2_by_b_1_y*t424
        - D_p_z_2_by_b_1_y*t321 - D_p_z_2_by_b_1_y*t322 - D_p_z_2_by_b_1_y*t323 + D_p_z_2_by_b_1_y*t425
        + mu_1_by_b_1_y*t358 + mu_2_by_b_1_y*t359 + mu_3_by_b_1_y*t360,
        D_delta_x_3_by_b_1_y*t355 + D_delta_y_3_by_b_1_y*t356 + D_delta_z_3_by_b_1_y*t357
        - D_p_x_2_by_b_1_y*t327 - D_p_x_2_by_b_1_y*t328 - D_p_x_2_by_b_1_y*t329 + D_p_x_2_by_b_1_y*t426
        - D_p_y_2_by_b_1_y*t330 - D_p_y_2_by_b_1_y*t331 - D_p_y_2_by_b_1_y*t332 + D_p_y_2_by_b_1_y*t427
        - D_p_z_2_by_b_1_y*t333 - D_p_z_2_by_b_1_y*t334 - D_p_z_2_by_b_1_y*t335 + D_p_z_2_by_b_1_y*t428
        + mu_1_by_b_1_y*t361 + mu_2_by_b_1_y*t362 + mu_3_by_b_1_y*t363,
        D_p_x_2_by_b_1_y*k_C, D_p_y_2_by_b_1_y*k_C, D_p_z_2_by_b_1_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_y*k_C
        + mu_1_by_b_1_y*t367 + mu_2_by_b_1_y*t368 + mu_3_by_b_1_y*t369 - t282*t433 - t283*t433 - t284*t433
        - t285*t434 - t286*t434 - t287*t434 - t288*t435 - t289*t435 - t290*t435,
        D_delta_x_1_by_b_1_y*t376 + D_delta_y_1_by_b_1_y*t377 + D_delta_z_1_by_b_1_y*t378
        - D_p_x_3_by_b_1_y*t300 - D_p_x_3_by_b_1_y*t301 - D_p_x_3_by_b_1_y*t302 + D_p_x_3_by_b_1_y*t420
        - D_p_y_3_by_b_1_y*t303 - D_p_y_3_by_b_1_y*t304 - D_p_y_3_by_b_1_y*t305 + D_p_y_3_by_b_1_y*t421
        - D_p_z_3_by_b_1_y*t306 - D_p_z_3_by_b_1_y*t307 - D_p_z_3_by_b_1_y*t308 + D_p_z_3_by_b_1_y*t422
        + mu_1_by_b_1_y*t373 + mu_2_by_b_1_y*t374 + mu_3_by_b_1_y*t375,
        D_delta_x_2_by_b_1_y*t376 + D_delta_y_2_by_b_1_y*t377 + D_delta_z_2_by_b_1_y*t378
        - D_p_x_3_by_b_1_y*t315 - D_p_x_3_by_b_1_y*t316 - D_p_x_3_by_b_1_y*t317 + D_p_x_3_by_b_1_y*t423
        - D_p_y_3_by_b_1_y*t318 - D_p_y_3_by_b_1_y*t319 - D_p_y_3_by_b_1_y*t320 + D_p_y_3_by_b_1_y*t424
        - D_p_z_3_by_b_1_y*t321 - D_p_z_3_by_b_1_y*t322 - D_p_z_3_by_b_1_y*t323 + D_p_z_3_by_b_1_y*t425
        + mu_1_by_b_1_y*t379 + mu_2_by_b_1_y*t380 + mu_3_by_b_1_y*t381,
        D_delta_x_3_by_b_1_y*t376 + D_delta_y_3_by_b_1_y*t377 + D_delta_z_3_by_b_1_y*t378
        - D_p_x_3_by_b_1_y*t327 - D_p_x_3_by_b_1_y*t328 - D_p_x_3_by_b_1_y*t329 + D_p_x_3_by_b_1_y*t426
        - D_p_y_3_by_b_1_y*t330 - D_p_y_3_by_b_1_y*t331 - D_p_y_3_by_b_1_y*t332 + D_p_y_3_by_b_1_y*t427
        - D_p_z_3_by_b_1_y*t333 - D_p_z_3_by_b_1_y*t334 - D_p_z_3_by_b_1_y*t335 + D_p_z_3_by_b_1_y*t428
        + mu_1_by_b_1_y*t382 + mu_2_by_b_1_y*t383 + mu_3_by_b_1_y*t384,
        D_p_x_3_by_b_1_y*k_C, D_p_y_3_by_b_1_y*k_C, D_p_z_3_by_b_1_y*k_C, t185*t417, t418, -t185*t416, t419,
        D_delta_x_1_by_b_1_y*t386 + D_delta_y_1_by_b_1_y*t387 + D_delta_z_1_by_b_1_y*t388
        + mu_1_by_b_1_y*t389 - mu_2_by_b_1_y*t385 - mu_3_by_b_1_y*t385,
        D_delta_x_1_by_b_1_y*t391 + D_delta_x_2_by_b_1_y*t392 + D_delta_y_1_by_b_1_y*t393
        + D_delta_y_2_by_b_1_y*t394 + D_delta_z_1_by_b_1_y*t395 + D_delta_z_2_by_b_1_y*t396
        + mu_1_by_b_1_y*t390 + mu_2_by_b_1_y*t390 + mu_3_by_b_1_y*t390,
        D_delta_x_1_by_b_1_y*t398 + D_delta_x_3_by_b_1_y*t392 + D_delta_y_1_by_b_1_y*t399
        + D_delta_y_3_by_b_1_y*t394 + D_delta_z_1_by_b_1_y*t400 + D_delta_z_3_by_b_1_y*t396
        + mu_1_by_b_1_y*t397 + mu_2_by_b_1_y*t397 + mu_3_by_b_1_y*t397,
        D_delta_x_1_by_b_1_y*k_C, D_delta_y_1_by_b_1_y*k_C, D_delta_z_1_by_b_1_y*k_C,
        D_delta_x_2_by_b_1_y*t402 + D_delta_y_2_by_b_1_y*t403 + D_delta_z_2_by_b_1_y*t404
        - mu_1_by_b_1_y*t401 + mu_2_by_b_1_y*t405 - mu_3_by_b_1_y*t401,
        D_delta_x_2_by_b_1_y*t398 + D_delta_x_3_by_b_1_y*t391 + D_delta_y_2_by_b_1_y*t399
        + D_delta_y_3_by_b_1_y*t393 + D_delta_z_2_by_b_1_y*t400 + D_delta_z_3_by_b_1_y*t395
        + mu_1_by_b_1_y*t406 + mu_2_by_b_1_y*t406 + mu_3_by_b_1_y*t406,
        D_delta_x_2_by_b_1_y*k_C, D_delta_y_2_by_b_1_y*k_C, D_delta_z_2_by_b_1_y*k_C,
        D_delta_x_3_by_b_1_y*t408 + D_delta_y_3_by_b_1_y*t409 + D_delta_z_3_by_b_1_y*t410
        - mu_1_by_b_1_y*t407 - mu_2_by_b_1_y*t407 + mu_3_by_b_1_y*t411,
        D_delta_x_3_by_b_1_y*k_C, D_delta_y_3_by_b_1_y*k_C, D_delta_z_3_by_b_1_y*k_C, t429,
        2*D_p_x_1*D_p_x_1_by_b_1_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_z*k_C
        + k_sp_1*t260*t269*w_b_1*x_1_by_b_1_z + mu_1_by_b_1_z*t266 + mu_2_by_b_1_z*t267
        + mu_3_by_b_1_z*t268 - t248*t436 - t250*t436 - t251*t436 - t252*t437 - t254*t437 - t255*t437
        - t256*t438 - t258*t438 - t259*t438 - t440,
        D_p_x_1*D_p_x_2_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_2*k_C - D_p_x_1_by_b_1_z*t270
        - D_p_x_1_by_b_1_z*t271 - D_p_x_1_by_b_1_z*t272 - D_p_x_2_by_b_1_z*t248 - D_p_x_2_by_b_1_z*t250
        - D_p_x_2_by_b_1_z*t251 + D_p_y_1*D_p_y_2_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_2*k_C
        - D_p_y_1_by_b_1_z*t273 - D_p_y_1_by_b_1_z*t274 - D_p_y_1_by_b_1_z*t275 - D_p_y_2_by_b_1_z*t252
        - D_p_y_2_by_b_1_z*t254 - D_p_y_2_by_b_1_z*t255 + D_p_z_1*D_p_z_2_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_2*k_C - D_p_z_1_by_b_1_z*t276 - D_p_z_1_by_b_1_z*t277
        - D_p_z_1_by_b_1_z*t278 - D_p_z_2_by_b_1_z*t256 - D_p_z_2_by_b_1_z*t258 - D_p_z_2_by_b_1_z*t259
        + mu_1_by_b_1_z*t279 + mu_2_by_b_1_z*t280 + mu_3_by_b_1_z*t281,
        D_p_x_1*D_p_x_3_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_3*k_C - D_p_x_1_by_b_1_z*t282
        - D_p_x_1_by_b_1_z*t283 - D_p_x_1_by_b_1_z*t284 - D_p_x_3_by_b_1_z*t248 - D_p_x_3_by_b_1_z*t250
        - D_p_x_3_by_b_1_z*t251 + D_p_y_1*D_p_y_3_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_3*k_C
        - D_p_y_1_by_b_1_z*t285 - D_p_y_1_by_b_1_z*t286 - D_p_y_1_by_b_1_z*t287 - D_p_y_3_by_b_1_z*t252
        - D_p_y_3_by_b_1_z*t254 - D_p_y_3_by_b_1_z*t255 + D_p_z_1*D_p_z_3_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_3*k_C - D_p_z_1_by_b_1_z*t288 - D_p_z_1_by_b_1_z*t289
        - D_p_z_1_by_b_1_z*t290 - D_p_z_3_by_b_1_z*t256 - D_p_z_3_by_b_1_z*t258 - D_p_z_3_by_b_1_z*t259
        + mu_1_by_b_1_z*t291 + mu_2_by_b_1_z*t292 + mu_3_by_b_1_z*t293,
        t442, t443,
        D_delta_x_1_by_b_1_z*t312 + D_delta_y_1_by_b_1_z*t313 + D_delta_z_1_by_b_1_z*t314
        - D_p_x_1_by_b_1_z*t300 - D_p_x_1_by_b_1_z*t301 - D_p_x_1_by_b_1_z*t302 + D_p_x_1_by_b_1_z*t420
        - D_p_y_1_by_b_1_z*t303 - D_p_y_1_by_b_1_z*t304 - D_p_y_1_by_b_1_z*t305 + D_p_y_1_by_b_1_z*t421
        - D_p_z_1_by_b_1_z*t306 - D_p_z_1_by_b_1_z*t307 - D_p_z_1_by_b_1_z*t308 + D_p_z_1_by_b_1_z*t422
        + mu_1_by_b_1_z*t309 + mu_2_by_b_1_z*t310 + mu_3_by_b_1_z*t311,
        D_delta_x_2_by_b_1_z*t312 + D_delta_y_2_by_b_1_z*t313 + D_delta_z_2_by_b_1_z*t314
        - D_p_x_1_by_b_1_z*t315 - D_p_x_1_by_b_1_z*t316 - D_p_x_1_by_b_1_z*t317 + D_p_x_1_by_b_1_z*t423
        - D_p_y_1_by_b_1_z*t318 - D_p_y_1_by_b_1_z*t319 - D_p_y_1_by_b_1_z*t320 + D_p_y_1_by_b_1_z*t424
        - D_p_z_1_by_b_1_z*t321 - D_p_z_1_by_b_1_z*t322 - D_p_z_1_by_b_1_z*t323 + D_p_z_1_by_b_1_z*t425
        + mu_1_by_b_1_z*t324 + mu_2_by_b_1_z*t325 + mu_3_by_b_1_z*t326,
        D_delta_x_3_by_b_1_z*t312 + D_delta_y_3_by_b_1_z*t313 + D_delta_z_3_by_b_1_z*t314
        - D_p_x_1_by_b_1_z*t327 - D_p_x_1_by_b_1_z*t328 - D_p_x_1_by_b_1_z*t329 + D_p_x_1_by_b_1_z*t426
        - D_p_y_1_by_b_1_z*t330 - D_p_y_1_by_b_1_z*t331 - D_p_y_1_by_b_1_z*t332 + D_p_y_1_by_b_1_z*t427
        - D_p_z_1_by_b_1_z*t333 - D_p_z_1_by_b_1_z*t334 - D_p_z_1_by_b_1_z*t335 + D_p_z_1_by_b_1_z*t428
        + mu_1_by_b_1_z*t336 + mu_2_by_b_1_z*t337 + mu_3_by_b_1_z*t338,
        t444, D_p_x_1_by_b_1_z*k_C, D_p_y_1_by_b_1_z*k_C, D_p_z_1_by_b_1_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_z*k_C
        + mu_1_by_b_1_z*t343 + mu_2_by_b_1_z*t344 + mu_3_by_b_1_z*t345 - t270*t445 - t271*t445 - t272*t445
        - t273*t446 - t274*t446 - t275*t446 - t276*t447 - t277*t447 - t278*t447,
        D_p_x_2*D_p_x_3_by_b_1_z*k_C + D_p_x_2_by_b_1_z*D_p_x_3*k_C - D_p_x_2_by_b_1_z*t282
        - D_p_x_2_by_b_1_z*t283 - D_p_x_2_by_b_1_z*t284 - D_p_x_3_by_b_1_z*t270 - D_p_x_3_by_b_1_z*t271
        - D_p_x_3_by_b_1_z*t272 + D_p_y_2*D_p_y_3_by_b_1_z*k_C + D_p_y_2_by_b_1_z*D_p_y_3*k_C
        - D_p_y_2_by_b_1_z*t285 - D_p_y_2_by_b_1_z*t286 - D_p_y_2_by_b_1_z*t287 - D_p_y_3_by_b_1_z*t273
        - D_p_y_3_by_b_1_z*t274 - D_p_y_3_by_b_1_z*t275 + D_p_z_2*D_p_z_3_by_b_1_z*k_C
        + D_p_z_2_by_b_1_z*D_p_z_3*k_C - D_p_z_2_by_b_1_z*t288 - D_p_z_2_by_b_1_z*t289
        - D_p_z_2_by_b_1_z*t290 - D_p_z_3_by_b_1_z*t276 - D_p_z_3_by_b_1_z*t277 - D_p_z_3_by_b_1_z*t278
        + mu_1_by_b_1_z*t346 + mu_2_by_b_1_z*t347 + mu_3_by_b_1_z*t348,
        D_delta_x_1_by_b_1_z*t355 + D_delta_y_1_by_b_1_z*t356 + D_delta_z_1_by_b_1_z*t357
        - D_p_x_2_by_b_1_z*t300 - D_p_x_2_by_b_1_z*t301 - D_p_x_2_by_b_1_z*t302 + D_p_x_2_by_b_1_z*t420
        - D_p_y_2_by_b_1_z*t303 - D_p_y_2_by_b_1_z*t304 - D_p_y_2_by_b_1_z*t305 + D_p_y_2_by_b_1_z*t421
        - D_p_z_2_by_b_1_z*t306 - D_p_z_2_by_b_1_z*t307 - D_p_z_2_by_b_1_z*t308 + D_p_z_2_by_b_1_z*t422
        + mu_1_by_b_1_z*t352 + mu_2_by_b_1_z*t353 + mu_3_by_b_1_z*t354,
        D_delta_x_2_by_b_1_z*t355 + D_delta_y_2_by_b_1_z*t356 + D_delta_z_2_by_b_1_z*t357
        - D_p_x_2_by_b_1_z*t315 - D_p_x_2_by_b_1_z*t316 - D_p_x_2_by_b_1_z*t317 + D_p_x_2_by_b_1_z*t423
        - D_p_y_2_by_b_1_z*t318 - D_p_y_2_by_b_1_z*t319 - D_p_y_2_by_b_1_z*t320 + D_p_y_2_by_b_1_z*t424
        - D_p_z_2_by_b_1_z*t321 - D_p_z_2_by_b_1_z*t322 - D_p_z_2_by_b_1_z*t323 + D_p_z_2_by_b_1_z*t425
        + mu_1_by_b_1_z*t358 + mu_2_by_b_1_z*t359 + mu_3_by_b_1_z*t360,
        D_delta_x_3_by_b_1_z*t355 + D_delta_y_3_by_b_1_z*t356 + D_delta_z_3_by_b_1_z*t357
        - D_p_x_2_by_b_1_z*t327 - D_p_x_2_by_b_1_z*t328 - D_p_x_2_by_b_1_z*t329 + D_p_x_2_by_b_1_z*t426
        - D_p_y_2_by_b_1_z*t330 - D_p_y_2_by_b_1_z*t331 - D_p_y_2_by_b_1_z*t332 + D_p_y_2_by_b_1_z*t427
        - D_p_z_2_by_b_1_z*t333 - D_p_z_2_by_b_1_z*t334 - D_p_z_2_by_b_1_z*t335 + D_p_z_2_by_b_1_z*t428
        + mu_1_by_b_1_z*t361 + mu_2_by_b_1_z*t362 + mu_3_by_b_1_z*t363,
        D_p_x_2_by_b_1_z*k_C, D_p_y_2_by_b_1_z*k_C, D_p_z_2_by_b_1_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_z*k_C
        + mu_1_by_b_1_z*t367 + mu_2_by_b_1_z*t368 + mu_3_by_b_1_z*t369 - t282*t448 - t283*t448 - t284*t448
        - t285*t449 - t286*t449 - t287*t449 - t288*t450 - t289*t450 - t290*t450,
        D_delta_x_1_by_b_1_z*t376 + D_delta_y_1_by_b_1_z*t377 + D_delta_z_1_by_b_1_z*t378
        - D_p_x_3_by_b_1_z*t300 - D_p_x_3_by_b_1_z*t301 - D_p_x_3_by_b_1_z*t302 + D_p_x_3_by_b_1_z*t420
        - D_p_y_3_by_b_1_z*t303 - D_p_y_3_by_b_1_z*t304 - D_p_y_3_by_b_1_z*t305 + D_p_y_3_by_b_1_z*t421
        - D_p_z_3_by_b_1_z*t306 - D_p_z_3_by_b_1_z*t307 - D_p_z_3_by_b_1_z*t308 + D_p_z_3_by_b_1_z*t422
        + mu_1_by_b_1_z*t373 + mu_2_by_b_1_z*t374 + mu_3_by_b_1_z*t375,
        D_delta_x_2_by_b_1_z*t376 + D_delta_y_2_by_b_1_z*t377 + D_delta_z_2_by_b_1_z*t378
        - D_p_x_3_by_b_1_z*t315 - D_p_x_3_by_b_1_z*t316 - D_p_x_3_by_b_1_z*t317 + D_p_x_3_by_b_1_z*t423
        - D_p_y_3_by_b_1_z*t318 - D_p_y_3_by_b_1_z*t319 - D_p_y_3_by_b_1_z*t320 + D_p_y_3_by_b_1_z*t424
        - D_p_z_3_by_b_1_z*t321 - D_p_z_3_by_b_1_z*t322 - D_p_z_3_by_b_1_z*t323 + D_p_z_3_by_b_1_z*t425
        + mu_1_by_b_1_z*t379 + mu_2_by_b_1_z*t380 + mu_3_by_b_1_z*t381,
        D_delta_x_3_by_b_1_z*t376 + D_delta_y_3_by_b_1_z*t377 + D_delta_z_3_by_b_1_z*t378
        - D_p_x_3_by_b_1_z*t327 - D_p_x_3_by_b_1_z*t328 - D_p_x_3_by_b_1_z*t329 + D_p_x_3_by_b_1_z*t426
        - D_p_y_3_by_b_1_z*t330 - D_p_y_3_by_b_1_z*t331 - D_p_y_3_by_b_1_z*t332 + D_p_y_3_by_b_1_z*t427
        - D_p_z_3_by_b_1_z*t333 - D_p_z_3_by_b_1_z*t334 - D_p_z_3_by_b_1_z*t335 + D_p_z_3_by_b_1_z*t428
        + mu_1_by_b_1_z*t382 + mu_2_by_b_1_z*t383 + mu_3_by_b_1_z*t384,
        D_p_x_3_by_b_1_z*k_C, D_p_y_3_by_b_1_z*k_C, D_p_z_3_by_b_1_z*k_C, t185*t441, t442, -t185*t440, t443,
        D_delta_x_1_by_b_1_z*t386 + D_delta_y_1_by_b_1_z*t387 + D_delta_z_1_by_b_1_z*t388
        + mu_1_by_b_1_z*t389 - mu_2_by_b_1_z*t385 - mu_3_by_b_1_z*t385,
        D_delta_x_1_by_b_1_z*t391 + D_delta_x_2_by_b_1_z*t392 + D_delta_y_1_by_b_1_z*t393
        + D_delta_y_2_by_b_1_z*t394 + D_delta_z_1_by_b_1_z*t395 + D_delta_z_2_by_b_1_z*t396
        + mu_1_by_b_1_z*t390 + mu_2_by_b_1_z*t390 + mu_3_by_b_1_z*t390,
        D_delta_x_1_by_b_1_z*t398 + D_delta_x_3_by_b_1_z*t392 + D_delta_y_1_by_b_1_z*t399
        + D_delta_y_3_by_b_1_z*t394 + D_delta_z_1_by_b_1_z*t400 + D_delta_z_3_by_b_1_z*t396
        + mu_1_by_b_1_z*t397 + mu_2_by_b_1_z*t397 + mu_3_by_b_1_z*t397,
        D_delta_x_1_by_b_1_z*k_C, D_delta_y_1_by_b_1_z*k_C, D_delta_z_1_by_b_1_z*k_C,
        D_delta_x_2_by_b_1_z*t402 + D_delta_y_2_by_b_1_z*t403 + D_delta_z_2_by_b_1_z*t404
        - mu_1_by_b_1_z*t401 + mu_2_by_b_1_z*t405 - mu_3_by_b_1_z*t401,
        D_delta_x_2_by_b_1_z*t398 + D_delta_x_3_by_b_1_z*t391 + D_delta_y_2_by_b_1_z*t399
        + D_delta_y_3_by_b_1_z*t393 + D_delta_z_2_by_b_1_z*t400 + D_delta_z_3_by_b_1_z*t395
        + mu_1_by_b_1_z*t406 + mu_2_by_b_1_z*t406 + mu_3_by_b_1_z*t406,
        D_delta_x_2_by_b_1_z*k_C, D_delta_y_2_by_b_1_z*k_C, D_delta_z_2_by_b_1_z*k_C,
        D_delta_x_3_by_b_1_z*t408 + D_delta_y_3_by_b_1_z*t409 + D_delta_z_3_by_b_1_z*t410
        - mu_1_by_b_1_z*t407 - mu_2_by_b_1_z*t407 + mu_3_by_b_1_z*t411,
        D_delta_x_3_by_b_1_z*k_C, D_delta_y_3_by_b_1_z*k_C, D_delta_z_3_by_b_1_z*k_C, t444,
        2*D_p_x_1*D_p_x_1_by_b_2_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_x*k_C
        + mu_1_by_b_2_x*t266 + mu_2_by_b_2_x*t267 + mu_3_by_b_2_x*t268 - t248*t451 - t250*t451 - t251*t451
        - t252*t452 - t254*t452 - t255*t452 - t256*t453 - t258*t453 - t259*t453,
        D_p_x_1*D_p_x_2_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_2*k_C - D_p_x_1_by_b_2_x*t270
        - D_p_x_1_by_b_2_x*t271 - D_p_x_1_by_b_2_x*t272 - D_p_x_2_by_b_2_x*t248 - D_p_x_2_by_b_2_x*t250
        - D_p_x_2_by_b_2_x*t251 + D_p_y_1*D_p_y_2_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_2*k_C
        - D_p_y_1_by_b_2_x*t273 - D_p_y_1_by_b_2_x*t274 - D_p_y_1_by_b_2_x*t275 - D_p_y_2_by_b_2_x*t252
        - D_p_y_2_by_b_2_x*t254 - D_p_y_2_by_b_2_x*t255 + D_p_z_1*D_p_z_2_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_2*k_C - D_p_z_1_by_b_2_x*t276 - D_p_z_1_by_b_2_x*t277
        - D_p_z_1_by_b_2_x*t278 - D_p_z_2_by_b_2_x*t256 - D_p_z_2_by_b_2_x*t258 - D_p_z_2_by_b_2_x*t259
        + mu_1_by_b_2_x*t279 + mu_2_by_b_2_x*t280 + mu_3_by_b_2_x*t281,
        D_p_x_1*D_p_x_3_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_3*k_C - D_p_x_1_by_b_2_x*t282
        - D_p_x_1_by_b_2_x*t283 - D_p_x_1_by_b_2_x*t284 - D_p_x_3_by_b_2_x*t248 - D_p_x_3_by_b_2_x*t250
        - D_p_x_3_by_b_2_x*t251 + D_p_y_1*D_p_y_3_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_3*k_C
        - D_p_y_1_by_b_2_x*t285 - D_p_y_1_by_b_2_x*t286 - D_p_y_1_by_b_2_x*t287 - D_p_y_3_by_b_2_x*t252
        - D_p_y_3_by_b_2_x*t254 - D_p_y_3_by_b_2_x*t255 + D_p_z_1*D_p_z_3_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_3*k_C - D_p_z_1_by_b_2_x*t288 - D_p_z_1_by_b_2_x*t289
        - D_p_z_1_by_b_2_x*t290 - D_p_z_3_by_b_2_x*t256 - D_p_z_3_by_b_2_x*t258 - D_p_z_3_by_b_2_x*t259
        + mu_1_by_b_2_x*t291 + mu_2_by_b_2_x*t292 + mu_3_by_b_2_x*t293,
        D_delta_x_1_by_b_2_x*t312 + D_delta_y_1_by_b_2_x*t313 + D_delta_z_1_by_b_2_x*t314
        - D_p_x_1_by_b_2_x*t300 - D_p_x_1_by_b_2_x*t301 - D_p_x_1_by_b_2_x*t302 + D_p_x_1_by_b_2_x*t420
        - D_p_y_1_by_b_2_x*t303 - D_p_y_1_by_b_2_x*t304 - D_p_y_1_by_b_2_x*t305 + D_p_y_1_by_b_2_x*t421
        - D_p_z_1_by_b_2_x*t306 - D_p_z_1_by_b_2_x*t307 - D_p_z_1_by_b_2_x*t308 + D_p_z_1_by_b_2_x*t422
        + mu_1_by_b_2_x*t309 + mu_2_by_b_2_x*t310 + mu_3_by_b_2_x*t311,
        D_delta_x_2_by_b_2_x*t312 + D_delta_y_2_by_b_2_x*t313 + D_delta_z_2_by_b_2_x*t314
        - D_p_x_1_by_b_2_x*t315 - D_p_x_1_by_b_2_x*t316 - D_p_x_1_by_b_2_x*t317 + D_p_x_1_by_b_2_x*t423
        - D_p_y_1_by_b_2_x*t318 - D_p_y_1_by_b_2_x*t319 - D_p_y_1_by_b_2_x*t320 + D_p_y_1_by_b_2_x*t424
        - D_p_z_1_by_b_2_x*t321 - D_p_z_1_by_b_2_x*t322 - D_p_z_1_by_b_2_x*t323 + D_p_z_1_by_b_2_x*t425
        + mu_1_by_b_2_x*t324 + mu_2_by_b_2_x*t325 + mu_3_by_b_2_x*t326,
        D_delta_x_3_by_b_2_x*t312 + D_delta_y_3_by_b_2_x*t313 + D_delta_z_3_by_b_2_x*t314
        - D_p_x_1_by_b_2_x*t327 - D_p_x_1_by_b_2_x*t328 - D_p_x_1_by_b_2_x*t329 + D_p_x_1_by_b_2_x*t426
        - D_p_y_1_by_b_2_x*t330 - D_p_y_1_by_b_2_x*t331 - D_p_y_1_by_b_2_x*t332 + D_p_y_1_by_b_2_x*t427
        - D_p_z_1_by_b_2_x*t333 - D_p_z_1_by_b_2_x*t334 - D_p_z_1_by_b_2_x*t335 + D_p_z_1_by_b_2_x*t428
        + mu_1_by_b_2_x*t336 + mu_2_by_b_2_x*t337 + mu_3_by_b_2_x*t338,
        D_p_x_1_by_b_2_x*k_C, D_p_y_1_by_b_2_x*k_C, D_p_z_1_by_b_2_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_x*k_C
        + k_sp_2*t457*t463*w_b_2*x_2_by_b_2_x + mu_1_by_b_2_x*t343 + mu_2_by_b_2_x*t344
        + mu_3_by_b_2_x*t345 - t270*t454 - t271*t454 - t272*t454 - t273*t455 - t274*t455 - t275*t455
        - t276*t456 - t277*t456 - t278*t456 - t462,
        D_p_x_2*D_p_x_3_by_b_2_x*k_C + D_p_x_2_by_b_2_x*D_p_x_3*k_C - D_p_x_2_by_b_2_x*t282
        - D_p_x_2_by_b_2_x*t283 - D_p_x_2_by_b_2_x*t284 - D_p_x_3_by_b_2_x*t270 - D_p_x_3_by_b_2_x*t271
        - D_p_x_3_by_b_2_x*t272 + D_p_y_2*D_p_y_3_by_b_2_x*k_C + D_p_y_2_by_b_2_x*D_p_y_3*k_C
        - D_p_y_2_by_b_2_x*t285 - D_p_y_2_by_b_2_x*t286 - D_p_y_2_by_b_2_x*t287 - D_p_y_3_by_b_2_x*t273
        - D_p_y_3_by_b_2_x*t274 - D_p_y_3_by_b_2_x*t275 + D_p_z_2*D_p_z_3_by_b_2_x*k_C
        + D_p_z_2_by_b_2_x*D_p_z_3*k_C - D_p_z_2_by_b_2_x*t288 - D_p_z_2_by_b_2_x*t289
        - D_p_z_2_by_b_2_x*t290 - D_p_z_3_by_b_2_x*t276 - D_p_z_3_by_b_2_x*t277 - D_p_z_3_by_b_2_x*t278
        + mu_1_by_b_2_x*t346 + mu_2_by_b_2_x*t347 + mu_3_by_b_2_x*t348,
        t465, t466,
        D_delta_x_1_by_b_2_x*t355 + D_delta_y_1_by_b_2_x*t356 + D_delta_z_1_by_b_2_x*t357
        - D_p_x_2_by_b_2_x*t300 - D_p_x_2_by_b_2_x*t301 - D_p_x_2_by_b_2_x*t302 + D_p_x_2_by_b_2_x*t420
        - D_p_y_2_by_b_2_x*t303 - D_p_y_2_by_b_2_x*t304 - D_p_y_2_by_b_2_x*t305 + D_p_y_2_by_b_2_x*t421
        - D_p_z_2_by_b_2_x*t306 - D_p_z_2_by_b_2_x*t307 - D_p_z_2_by_b_2_x*t308 + D_p_z_2_by_b_2_x*t422
        + mu_1_by_b_2_x*t352 + mu_2_by_b_2_x*t353 + mu_3_by_b_2_x*t354,
        D_delta_x_2_by_b_2_x*t355 + D_delta_y_2_by_b_2_x*t356 + D_delta_z_2_by_b_2_x*t357
        - D_p_x_2_by_b_2_x*t315 - D_p_x_2_by_b_2_x*t316 - D_p_x_2_by_b_2_x*t317 + D_p_x_2_by_b_2_x*t423
        - D_p_y_2_by_b_2_x*t318 - D_p_y_2_by_b_2_x*t319 - D_p_y_2_by_b_2_x*t320 + D_p_y_2_by_b_2_x*t424
        - D_p_z_2_by_b_2_x*t321 - D_p_z_2_by_b_2_x*t322 - D_p_z_2_by_b_2_x*t323 + D_p_z_2_by_b_2_x*t425
        + mu_1_by_b_2_x*t358 + mu_2_by_b_2_x*t359 + mu_3_by_b_2_x*t360,
        D_delta_x_3_by_b_2_x*t355 + D_delta_y_3_by_b_2_x*t356 + D_delta_z_3_by_b_2_x*t357
        - D_p_x_2_by_b_2_x*t327 - D_p_x_2_by_b_2_x*t328 - D_p_x_2_by_b_2_x*t329 + D_p_x_2_by_b_2_x*t426
        - D_p_y_2_by_b_2_x*t330 - D_p_y_2_by_b_2_x*t331 - D_p_y_2_by_b_2_x*t332 + D_p_y_2_by_b_2_x*t427
        - D_p_z_2_by_b_2_x*t333 - D_p_z_2_by_b_2_x*t334 - D_p_z_2_by_b_2_x*t335 + D_p_z_2_by_b_2_x*t428
        + mu_1_by_b_2_x*t361 + mu_2_by_b_2_x*t362 + mu_3_by_b_2_x*t363,
        t467, D_p_x_2_by_b_2_x*k_C, D_p_y_2_by_b_2_x*k_C, D_p_z_2_by_b_2_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_x*k_C
        + mu_1_by_b_2_x*t367 + mu_2_by_b_2_x*t368 + mu_3_by_b_2_x*t369 - t282*t468 - t283*t468 - t284*t468
        - t285*t469 - t286*t469 - t287*t469 - t288*t470 - t289*t470 - t290*t470,
        D_delta_x_1_by_b_2_x*t376 + D_delta_y_1_by_b_2_x*t377 + D_delta_z_1_by_b_2_x*t378
        - D_p_x_3_by_b_2_x*t300 - D_p_x_3_by_b_2_x*t301 - D_p_x_3_by_b_2_x*t302 + D_p_x_3_by_b_2_x*t420
        - D_p_y_3_by_b_2_x*t303 - D_p_y_3_by_b_2_x*t304 - D_p_y_3_by_b_2_x*t305 + D_p_y_3_by_b_2_x*t421
        - D_p_z_3_by_b_2_x*t306 - D_p_z_3_by_b_2_x*t307 - D_p_z_3_by_b_2_x*t308 + D_p_z_3_by_b_2_x*t422
        + mu_1_by_b_2_x*t373 + mu_2_by_b_2_x*t374 + mu_3_by_b_2_x*t375,
        D_delta_x_2_by_b_2_x*t376 + D_delta_y_2_by_b_2_x*t377 + D_delta_z_2_by_b_2_x*t378
        - D_p_x_3_by_b_2_x*t315 - D_p_x_3_by_b_2_x*t316 - D_p_x_3_by_b_2_x*t317 + D_p_x_3_by_b_2_x*t423
        - D_p_y_3_by_b_2_x*t318 - D_p_y_3_by_b_2_x*t319 - D_p_y_3_by_b_2_x*t320 + D_p_y_3_by_b_2_x*t424
        - D_p_z_3_by_b_2_x*t321 - D_p_z_3_by_b_2_x*t322 - D_p_z_3_by_b_2_x*t323 + D_p_z_3_by_b_2_x*t425
        + mu_1_by_b_2_x*t379 + mu_2_by_b_2_x*t380 + mu_3_by_b_2_x*t381,
        D_delta_x_3_by_b_2_x*t376 + D_delta_y_3_by_b_2_x*t377 + D_delta_z_3_by_b_2_x*t378
        - D_p_x_3_by_b_2_x*t327 - D_p_x_3_by_b_2_x*t328 - D_p_x_3_by_b_2_x*t329 + D_p_x_3_by_b_2_x*t426
        - D_p_y_3_by_b_2_x*t330 - D_p_y_3_by_b_2_x*t331 - D_p_y_3_by_b_2_x*t332 + D_p_y_3_by_b_2_x*t427
        - D_p_z_3_by_b_2_x*t333 - D_p_z_3_by_b_2_x*t334 - D_p_z_3_by_b_2_x*t335 + D_p_z_3_by_b_2_x*t428
        + mu_1_by_b_2_x*t382 + mu_2_by_b_2_x*t383 + mu_3_by_b_2_x*t384,
        D_p_x_3_by_b_2_x*k_C, D_p_y_3_by_b_2_x*k_C, D_p_z_3_by_b_2_x*k_C, t218*t464, t465, -t218*t462, t466,
        D_delta_x_1_by_b_2_x*t386 + D_delta_y_1_by_b_2_x*t387 + D_delta_z_1_by_b_2_x*t388
        + mu_1_by_b_2_x*t389 - mu_2_by_b_2_x*t385 - mu_3_by_b_2_x*t385,
        D_delta_x_1_by_b_2_x*t391 + D_delta_x_2_by_b_2_x*t392 + D_delta_y_1_by_b_2_x*t393
        + D_delta_y_2_by_b_2_x*t394 + D_delta_z_1_by_b_2_x*t395 + D_delta_z_2_by_b_2_x*t396
        + mu_1_by_b_2_x*t390 + mu_2_by_b_2_x*t390 + mu_3_by_b_2_x*t390,
        D_delta_x_1_by_b_2_x*t398 + D_delta_x_3_by_b_2_x*t392 + D_delta_y_1_by_b_2_x*t399
        + D_delta_y_3_by_b_2_x*t394 + D_delta_z_1_by_b_2_x*t400 + D_delta_z_3_by_b_2_x*t396
        + mu_1_by_b_2_x*t397 + mu_2_by_b_2_x*t397 + mu_3_by_b_2_x*t397,
        D_delta_x_1_by_b_2_x*k_C, D_delta_y_1_by_b_2_x*k_C, D_delta_z_1_by_b_2_x*k_C,
        D_delta_x_2_by_b_2_x*t402 + D_delta_y_2_by_b_2_x*t403 + D_delta_z_2_by_b_2_x*t404
        - mu_1_by_b_2_x*t401 + mu_2_by_b_2_x*t405 - mu_3_by_b_2_x*t401,
        D_delta_x_2_by_b_2_x*t398 + D_delta_x_3_by_b_2_x*t391 + D_delta_y_2_by_b_2_x*t399
        + D_delta_y_3_by_b_2_x*t393 + D_delta_z_2_by_b_2_x*t400 + D_delta_z_3_by_b_2_x*t395
        + mu_1_by_b_2_x*t406 + mu_2_by_b_2_x*t406 + mu_3_by_b_2_x*t406,
        D_delta_x_2_by_b_2_x*k_C, D_delta_y_2_by_b_2_x*k_C, D_delta_z_2_by_b_2_x*k_C,
        D_delta_x_3_by_b_2_x*t408 + D_delta_y_3_by_b_2_x*t409 + D_delta_z_3_by_b_2_x*t410
        - mu_1_by_b_2_x*t407 - mu_2_by_b_2_x*t407 + mu_3_by_b_2_x*t411,
        D_delta_x_3_by_b_2_x*k_C, D_delta_y_3_by_b_2_x*k_C, D_delta_z_3_by_b_2_x*k_C, t467,
        2*D_p_x_1*D_p_x_1_by_b_2_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_y*k_C
        + mu_1_by_b_2_y*t266 + mu_2_by_b_2_y*t267 + mu_3_by_b_2_y*t268 - t248*t471 - t250*t471 - t251*t471
        - t252*t472 - t254*t472 - t255*t472 - t256*t473 - t258*t473 - t259*t473,
        D_p_x_1*D_p_x_2_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_2*k_C - D_p_x_1_by_b_2_y*t270
        - D_p_x_1_by_b_2_y*t271 - D_p_x_1_by_b_2_y*t272 - D_p_x_2_by_b_2_y*t248 - D_p_x_2_by_b_2_y*t250
        - D_p_x_2_by_b_2_y*t251 + D_p_y_1*D_p_y_2_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_2*k_C
        - D_p_y_1_by_b_2_y*t273 - D_p_y_1_by_b_2_y*t274 - D_p_y_1_by_b_2_y*t275 - D_p_y_2_by_b_2_y*t252
        - D_p_y_2_by_b_2_y*t254 - D_p_y_2_by_b_2_y*t255 + D_p_z_1*D_p_z_2_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_2*k_C - D_p_z_1_by_b_2_y*t276 - D_p_z_1_by_b_2_y*t277
        - D_p_z_1_by_b_2_y*t278 - D_p_z_2_by_b_2_y*t256 - D_p_z_2_by_b_2_y*t258 - D_p_z_2_by_b_2_y*t259
        + mu_1_by_b_2_y*t279 + mu_2_by_b_2_y*t280 + mu_3_by_b_2_y*t281,
        D_p_x_1*D_p_x_3_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_3*k_C - D_p_x_1_by_b_2_y*t282
        - D_p_x_1_by_b_2_y*t283 - D_p_x_1_by_b_2_y*t284 - D_p_x_3_by_b_2_y*t248 - D_p_x_3_by_b_2_y*t250
        - D_p_x_3_by_b_2_y*t251 + D_p_y_1*D_p_y_3_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_3*k_C
        - D_p_y_1_by_b_2_y*t285 - D_p_y_1_by_b_2_y*t286 - D_p_y_1_by_b_2_y*t287 - D_p_y_3_by_b_2_y*t252
        - D_p_y_3_by_b_2_y*t254 - D_p_y_3_by_b_2_y*t255 + D_p_z_1*D_p_z_3_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_3*k_C - D_p_z_1_by_b_2_y*t288 - D_p_z_1_by_b_2_y*t289
        - D_p_z_1_by_b_2_y*t290 - D_p_z_3_by_b_2_y*t256 - D_p_z_3_by_b_2_y*t258 - D_p_z_3_by_b_2_y*t259
        + mu_1_by_b_2_y*t291 + mu_2_by_b_2_y*t292 + mu_3_by_b_2_y*t293,
        D_delta_x_1_by_b_2_y*t312 + D_delta_y_1_by_b_2_y*t313 + D_delta_z_1_by_b_2_y*t314
        - D_p_x_1_by_b_2_y*t300 - D_p_x_1_by_b_2_y*t301 - D_p_x_1_by_b_2_y*t302 + D_p_x_1_by_b_2_y*t420
        - D_p_y_1_by_b_2_y*t303 - D_p_y_1_by_b_2_y*t304 - D_p_y_1_by_b_2_y*t305 + D_p_y_1_by_b_2_y*t421
        - D_p_z_1_by_b_2_y*t306 - D_p_z_1_by_b_2_y*t307 - D_p_z_1_by_b_2_y*t308 + D_p_z_1_by_b_2_y*t422
        + mu_1_by_b_2_y*t309 + mu_2_by_b_2_y*t310 + mu_3_by_b_2_y*t311,
        D_delta_x_2_by_b_2_y*t312 + D_delta_y_2_by_b_2_y*t313 + D_delta_z_2_by_b_2_y*t314
        - D_p_x_1_by_b_2_y*t315 - D_p_x_1_by_b_2_y*t316 - D_p_x_1_by_b_2_y*t317 + D_p_x_1_by_b_2_y*t423
        - D_p_y_1_by_b_2_y*t318 - D_p_y_1_by_b_2_y*t319 - D_p_y_1_by_b_2_y*t320 + D_p_y_1_by_b_2_y*t424
        - D_p_z_1_by_b_2_y*t321 - D_p_z_1_by_b_2_y*t322 - D_p_z_1_by_b_2_y*t323 + D_p_z_1_by_b_2_y*t425
        + mu_1_by_b_2_y*t324 + mu_2_by_b_2_y*t325 + mu_3_by_b_2_y*t326,
        D_delta_x_3_by_b_2_y*t312 + D_delta_y_3_by_b_2_y*t313 + D_delta_z_3_by_b_2_y*t314
        - D_p_x_1_by_b_2_y*t327 - D_p_x_1_by_b_2_y*t328 - D_p_x_1_by_b_2_y*t329 + D_p_x_1_by_b_2_y*t426
        - D_p_y_1_by_b_2_y*t330 - D_p_y_1_by_b_2_y*t331 - D_p_y_1_by_b_2_y*t332 + D_p_y_1_by_b_2_y*t427
        - D_p_z_1_by_b_2_y*t333 - D_p_z_1_by_b_2_y*t334 - D_p_z_1_by_b_2_y*t335 + D_p_z_1_by_b_2_y*t428
        + mu_1_by_b_2_y*t336 + mu_2_by_b_2_y*t337 + mu_3_by_b_2_y*t338,
        D_p_x_1_by_b_2_y*k_C, D_p_y_1_by_b_2_y*k_C, D_p_z_1_by_b_2_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_y*k_C
        + k_sp_2*t457*t463*w_b_2*x_2_by_b_2_y + mu_1_by_b_2_y*t343 + mu_2_by_b_2_y*t344
        + mu_3_by_b_2_y*t345 - t270*t474 - t271*t474 - t272*t474 - t273*t475 - t274*t475 - t275*t475
        - t276*t476 - t277*t476 - t278*t476 - t478,
        D_p_x_2*D_p_x_3_by_b_2_y*k_C + D_p_x_2_by_b_2_y*D_p_x_3*k_C - D_p_x_2_by_b_2_y*t282
        - D_p_x_2_by_b_2_y*t283 - D_p_x_2_by_b_2_y*t284 - D_p_x_3_by_b_2_y*t270 - D_p_x_3_by_b_2_y*t271
        - D_p_x_3_by_b_2_y*t272 + D_p_y_2*D_p_y_3_by_b_2_y*k_C + D_p_y_2_by_b_2_y*D_p_y_3*k_C
        - D_p_y_2_by_b_2_y*t285 - D_p_y_2_by_b_2_y*t286 - D_p_y_2_by_b_2_y*t287 - D_p_y_3_by_b_2_y*t273
        - D_p_y_3_by_b_2_y*t274 - D_p_y_3_by_b_2_y*t275 + D_p_z_2*D_p_z_3_by_b_2_y*k_C
        + D_p_z_2_by_b_2_y*D_p_z_3*k_C - D_p_z_2_by_b_2_y*t288 - D_p_z_2_by_b_2_y*t289
        - D_p_z_2_by_b_2_y*t290 - D_p_z_3_by_b_2_y*t276 - D_p_z_3_by_b_2_y*t277 - D_p_z_3_by_b_2_y*t278
        + mu_1_by_b_2_y*t346 + mu_2_by_b_2_y*t347 + mu_3_by_b_2_y*t348,
        t480, t481,
        D_delta_x_1_by_b_2_y*t355 + D_delta_y_1_by_b_2_y*t356 + D_delta_z_1_by_b_2_y*t357
        - D_p_x_2_by_b_2_y*t300 - D_p_x_2_by_b_2_y*t301 - D_p_x_2_by_b_2_y*t302 + D_p_x_2_by_b_2_y*t420
        - D_p_y_2_by_b_2_y*t303 - D_p_y_2_by_b_2_y*t304 - D_p_y_2_by_b_2_y*t305 + D_p_y_2_by_b_2_y*t421
        - D_p_z_2_by_b_2_y*t306 - D_p_z_2_by_b_2_y*t307 - D_p_z_2_by_b_2_y*t308 + D_p_z_2_by_b_2_y*t422
        + mu_1_by_b_2_y*t352 + mu_2_by_b_2_y*t353 + mu_3_by_b_2_y*t354,
        D_delta_x_2_by_b_2_y*t355 + D_delta_y_2_by_b_2_y*t356 + D_delta_z_2_by_b_2_y*t357
        - D_p_x_2_by_b_2_y*t315 - D_p_x_2_by_b_2_y*t316 - D_p_x_2_by_b_2_y*t317 + D_p_x_2_by_b_2_y*t423
        - D_p_y_2_by_b_2_y*t318 - D_p_y_2_by_b_2_y*t319 - D_p_y_2_by_b_2_y*t320 + D_p_y_2_by_b_2_y*t424
        - D_p_z_2_by_b_2_y*t321 - D_p_z_2_by_b_2_y*t322 - D_p_z_2_by_b_2_y*t323 + D_p_z_2_by_b_2_y*t425
        + mu_1_by_b_2_y*t358 + mu_2_by_b_2_y*t359 + mu_3_by_b_2_y*t360,
        D_delta_x_3_by_b_2_y*t355 + D_delta_y_3_by_b_2_y*t356 + D_delta_z_3_by_b_2_y*t357
        - D_p_x_2_by_b_2_y*t327 - D_p_x_2_by_b_2_y*t328 - D_p_x_2_by_b_2_y*t329 + D_p_x_2_by_b_2_y*t426
        - D_p_y_2_by_b_2_y*t330 - D_p_y_2_by_b_2_y*t331 - D_p_y_2_by_b_2_y*t332 + D_p_y_2_by_b_2_y*t427
        - D_p_z_2_by_b_2_y*t333 - D_p_z_2_by_b_2_y*t334 - D_p_z_2_by_b_2_y*t335 + D_p_z_2_by_b_2_y*t428
        + mu_1_by_b_2_y*t361 + mu_2_by_b_2_y*t362 + mu_3_by_b_2_y*t363,
        t482, D_p_x_2_by_b_2_y*k_C, D_p_y_2_by_b_2_y*k_C, D_p_z_2_by_b_2_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_y*k_C
        + mu_1_by_b_2_y*t367 + mu_2_by_b_2_y*t368 + mu_3_by_b_2_y*t369 - t282*t483 - t283*t483 - t284*t483
        - t285*t484 - t286*t484 - t287*t484 - t288*t485 - t289*t485 - t290*t485,
        D_delta_x_1_by_b_2_y*t376 + D_delta_y_1_by_b_2_y*t377 + D_delta_z_1_by_b_2_y*t378
        - D_p_x_3_by_b_2_y*t300 - D_p_x_3_by_b_2_y*t301 - D_p_x_3_by_b_2_y*t302 + D_p_x_3_by_b_2_y*t420
        - D_p_y_3_by_b_2_y*t303 - D_p_y_3_by_b_2_y*t304 - D_p_y_3_by_b_2_y*t305 + D_p_y_3_by_b_2_y*t421
        - D_p_z_3_by_b_2_y*t306 - D_p_z_3_by_b_2_y*t307 - D_p_z_3_by_b_2_y*t308 + D_p_z_3_by_b_2_y*t422
        + mu_1_by_b_2_y*t373 + mu_2_by_b_2_y*t374 + mu_3_by_b_2_y*t375,
        D_delta_x_2_by_b_2_y*t376 + D_delta_y_2_by_b_2_y*t377 + D_delta_z_2_by_b_2_y*t378
        - D_p_x_3_by_b_2_y*t315 - D_p_x_3_by_b_2_y*t316 - D_p_x_3_by_b_2_y*t317 + D_p_x_3_by_b_2_y*t423
        - D_p_y_3_by_b_2_y*t318 - D_p_y_3_by_b_2_y*t319 - D_p_y_3_by_b_2_y*t320 + D_p_y_3_by_b_2_y*t424
        - D_p_z_3_by_b_2_y*t321 - D_p_z_3_by_b_2_y*t322 - D_p_z_3_by_b_2_y*t323 + D_p_z_3_by_b_2_y*t425
        + mu_1_by_b_2_y*t379 + mu_2_by_b_2_y*t380 + mu_3_by_b_2_y*t381,
        D_delta_x_3_by_b_2_y*t376 + D_delta_y_3_by_b_2_y*t377 + D_delta_z_3_by_b_2_y*t378
        - D_p_x_3_by_b_2_y*t327 - D_p_x_3_by_b_2_y*t328 - D_p_x_3_by_b_2_y*t329 + D_p_x_3_by_b_2_y*t426
        - D_p_y_3_by_b_2_y*t330 - D_p_y_3_by_b_2_y*t331 - D_p_y_3_by_b_2_y*t332 + D_p_y_3_by_b_2_y*t427
        - D_p_z_3_by_b_2_y*t333 - D_p_z_3_by_b_2_y*t334 - D_p_z_3_by_b_2_y*t335 + D_p_z_3_by_b_2_y*t428
        + mu_1_by_b_2_y*t382 + mu_2_by_b_2_y*t383 + mu_3_by_b_2_y*t384,
        D_p_x_3_by_b_2_y*k_C, D_p_y_3_by_b_2_y*k_C, D_p_z_3_by_b_2_y*k_C, t218*t479, t480, -t218*t478, t481,
        D_delta_x_1_by_b_2_y*t386 + D_delta_y_1_by_b_2_y*t387 + D_delta_z_1_by_b_2_y*t388
        + mu_1_by_b_2_y*t389 - mu_2_by_b_2_y*t385 - mu_3_by_b_2_y*t385,
        D_delta_x_1_by_b_2_y*t391 + D_delta_x_2_by_b_2_y*t392 + D_delta_y_1_by_b_2_y*t393
        + D_delta_y_2_by_b_2_y*t394 + D_delta_z_1_by_b_2_y*t395 + D_delta_z_2_by_b_2_y*t396
        + mu_1_by_b_2_y*t390 + mu_2_by_b_2_y*t390 + mu_3_by_b_2_y*t390,
        D_delta_x_1_by_b_2_y*t398 + D_delta_x_3_by_b_2_y*t392 + D_delta_y_1_by_b_2_y*t399
        + D_delta_y_3_by_b_2_y*t394 + D_delta_z_1_by_b_2_y*t400 + D_delta_z_3_by_b_2_y*t396
        + mu_1_by_b_2_y*t397 + mu_2_by_b_2_y*t397 + mu_3_by_b_2_y*t397,
        D_delta_x_1_by_b_2_y*k_C, D_delta_y_1_by_b_2_y*k_C, D_delta_z_1_by_b_2_y*k_C,
        D_delta_x_2_by_b_2_y*t402 + D_delta_y_2_by_b_2_y*t403 + D_delta_z_2_by_b_2_y*t404
        - mu_1_by_b_2_y*t401 + mu_2_by_b_2_y*t405 - mu_3_by_b_2_y*t401,
        D_delta_x_2_by_b_2_y*t398 + D_delta_x_3_by_b_2_y*t391 + D_delta_y_2_by_b_2_y*t399
        + D_delta_y_3_by_b_2_y*t393 + D_delta_z_2_by_b_2_y*t400 + D_delta_z_3_by_b_2_y*t395
        + mu_1_by_b_2_y*t406 + mu_2_by_b_2_y*t406 + mu_3_by_b_2_y*t406,
        D_delta_x_2_by_b_2_y*k_C, D_delta_y_2_by_b_2_y*k_C, D_delta_z_2_by_b_2_y*k_C,
        D_delta_x_3_by_b_2_y*t408 + D_delta_y_3_by_b_2_y*t409 + D_delta_z_3_by_b_2_y*t410
        - mu_1_by_b_2_y*t407 - mu_2_by_b_2_y*t407 + mu_3_by_b_2_y*t411,
        D_delta_x_3_by_b_2_y*k_C, D_delta_y_3_by_b_2_y*k_C, D_delta_z_3_by_b_2_y*k_C, t482,
        2*D_p_x_1*D_p_x_1_by_b_2_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_z*k_C
        + mu_1_by_b_2_z*t266 + mu_2_by_b_2_z*t267 + mu_3_by_b_2_z*t268 - t248*t486 - t250*t486 - t251*t486
        - t252*t487 - t254*t487 - t255*t487 - t256*t488 - t258*t488 - t259*t488,
        D_p_x_1*D_p_x_2_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_2*k_C - D_p_x_1_by_b_2_z*t270
        - D_p_x_1_by_b_2_z*t271 - D_p_x_1_by_b_2_z*t272 - D_p_x_2_by_b_2_z*t248 - D_p_x_2_by_b_2_z*t250
        - D_p_x_2_by_b_2_z*t251 + D_p_y_1*D_p_y_2_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_2*k_C
        - D_p_y_1_by_b_2_z*t273 - D_p_y_1_by_b_2_z*t274 - D_p_y_1_by_b_2_z*t275 - D_p_y_2_by_b_2_z*t252
        - D_p_y_2_by_b_2_z*t254 - D_p_y_2_by_b_2_z*t255 + D_p_z_1*D_p_z_2_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_2*k_C - D_p_z_1_by_b_2_z*t276 - D_p_z_1_by_b_2_z*t277
        - D_p_z_1_by_b_2_z*t278 - D_p_z_2_by_b_2_z*t256 - D_p_z_2_by_b_2_z*t258 - D_p_z_2_by_b_2_z*t259
        + mu_1_by_b_2_z*t279 + mu_2_by_b_2_z*t280 + mu_3_by_b_2_z*t281,
        D_p_x_1*D_p_x_3_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_3*k_C - D_p_x_1_by_b_2_z*t282
        - D_p_x_1_by_b_2_z*t283 - D_p_x_1_by_b_2_z*t284 - D_p_x_3_by_b_2_z*t248 - D_p_x_3_by_b_2_z*t250
        - D_p_x_3_by_b_2_z*t251 + D_p_y_1*D_p_y_3_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_3*k_C
        - D_p_y_1_by_b_2_z*t285 - D_p_y_1_by_b_2_z*t286 - D_p_y_1_by_b_2_z*t287 - D_p_y_3_by_b_2_z*t252
        - D_p_y_3_by_b_2_z*t254 - D_p_y_3_by_b_2_z*t255 + D_p_z_1*D_p_z_3_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_3*k_C - D_p_z_1_by_b_2_z*t288 - D_p_z_1_by_b_2_z*t289
        - D_p_z_1_by_b_2_z*t290 - D_p_z_3_by_b_2_z*t256 - D_p_z_3_by_b_2_z*t258 - D_p_z_3_by_b_2_z*t259
        + mu_1_by_b_2_z*t291 + mu_2_by_b_2_z*t292 + mu_3_by_b_2_z*t293,
        D_delta_x_1_by_b_2_z*t312 + D_delta_y_1_by_b_2_z*t313 + D_delta_z_1_by_b_2_z*t314
        - D_p_x_1_by_b_2_z*t300 - D_p_x_1_by_b_2_z*t301 - D_p_x_1_by_b_2_z*t302 + D_p_x_1_by_b_2_z*t420
        - D_p_y_1_by_b_2_z*t303 - D_p_y_1_by_b_2_z*t304 - D_p_y_1_by_b_2_z*t305 + D_p_y_1_by_b_2_z*t421
        - D_p_z_1_by_b_2_z*t306 - D_p_z_1_by_b_2_z*t307 - D_p_z_1_by_b_2_z*t308 + D_p_z_1_by_b_2_z*t422
        + mu_1_by_b_2_z*t309 + mu_2_by_b_2_z*t310 + mu_3_by_b_2_z*t311,
        D_delta_x_2_by_b_2_z*t312 + D_delta_y_2_by_b_2_z*t313 + D_delta_z_2_by_b_2_z*t314
        - D_p_x_1_by_b_2_z*t315 - D_p_x_1_by_b_2_z*t316 - D_p_x_1_by_b_2_z*t317 + D_p_x_1_by_b_2_z*t423
        - D_p_y_1_by_b_2_z*t318 - D_p_y_1_by_b_2_z*t319 - D_p_y_1_by_b_2_z*t320 + D_p_y_1_by_b_2_z*t424
        - D_p_z_1_by_b_2_z*t321 - D_p_z_1_by_b_2_z*t322 - D_p_z_1_by_b_2_z*t323 + D_p_z_1_by_b_2_z*t425
        + mu_1_by_b_2_z*t324 + mu_2_by_b_2_z*t325 + mu_3_by_b_2_z*t326,
        D_delta_x_3_by_b_2_z*t312 + D_delta_y_3_by_b_2_z*t313 + D_delta_z_3_by_b_2_z*t314
        - D_p_x_1_by_b_2_z*t327 - D_p_x_1_by_b_2_z*t328 - D_p_x_1_by_b_2_z*t329 + D_p_x_1_by_b_2_z*t426
        - D_p_y_1_by_b_2_z*t330 - D_p_y_1_by_b_2_z*t331 - D_p_y_1_by_b_2_z*t332 + D_p_y_1_by_b_2_z*t427
        - D_p_z_1_by_b_2_z*t333 - D_p_z_1_by_b_2_z*t334 - D_p_z_1_by_b_2_z*t335 + D_p_z_1_by_b_2_z*t428
        + mu_1_by_b_2_z*t336 + mu_2_by_b_2_z*t337 + mu_3_by_b_2_z*t338,
        D_p_x_1_by_b_2_z*k_C, D_p_y_1_by_b_2_z*k_C, D_p_z_1_by_b_2_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_z*k_C
        + k_sp_2*t457*t463*w_b_2*x_2_by_b_2_z + mu_1_by_b_2_z*t343 + mu_2_by_b_2_z*t344
        + mu_3_by_b_2_z*t345 - t270*t489 - t271*t489 - t272*t489 - t273*t490 - t274*t490 - t275*t490
        - t276*t491 - t277*t491 - t278*t491 - t493,
        D_p_x_2*D_p_x_3_by_b_2_z*k_C + D_p_x_2_by_b_2_z*D_p_x_3*k_C - D_p_x_2_by_b_2_z*t282
        - D_p_x_2_by_b_2_z*t283 - D_p_x_2_by_b_2_z*t284 - D_p_x_3_by_b_2_z*t270 - D_p_x_3_by_b_2_z*t271
        - D_p_x_3_by_b_2_z*t272 + D_p_y_2*D_p_y_3_by_b_2_z*k_C + D_p_y_2_by_b_2_z*D_p_y_3*k_C
        - D_p_y_2_by_b_2_z*t285 - D_p_y_2_by_b_2_z*t286 - D_p_y_2_by_b_2_z*t287 - D_p_y_3_by_b_2_z*t273
        - D_p_y_3_by_b_2_z*t274 - D_p_y_3_by_b_2_z*t275 + D_p_z_2*D_p_z_3_by_b_2_z*k_C
        + D_p_z_2_by_b_2_z*D_p_z_3*k_C - D_p_z_2_by_b_2_z*t288 - D_p_z_2_by_b_2_z*t289
        - D_p_z_2_by_b_2_z*t290 - D_p_z_3_by_b_2_z*t276 - D_p_z_3_by_b_2_z*t277 - D_p_z_3_by_b_2_z*t278
        + mu_1_by_b_2_z*t346 + mu_2_by_b_2_z*t347 + mu_3_by_b_2_z*t348,
        t495, t496,
        D_delta_x_1_by_b_2_z*t355 + D_delta_y_1_by_b_2_z*t356 + D_delta_z_1_by_b_2_z*t357
        - D_p_x_2_by_b_2_z*t300 - D_p_x_2_by_b_2_z*t301 - D_p_x_2_by_b_2_z*t302 + D_p_x_2_by_b_2_z*t420
        - D_p_y_2_by_b_2_z*t303 - D_p_y_2_by_b_2_z*t304 - D_p_y_2_by_b_2_z*t305 + D_p_y_2_by_b_2_z*t421
        - D_p_z_2_by_b_2_z*t306 - D_p_z_2_by_b_2_z*t307 - D_p_z_2_by_b_2_z*t308 + D_p_z_2_by_b_2_z*t422
        + mu_1_by_b_2_z*t352 + mu_2_by_b_2_z*t353 + mu_3_by_b_2_z*t354,
        D_delta_x_2_by_b_2_z*t355 + D_delta_y_2_by_b_2_z*t356 + D_delta_z_2_by_b_2_z*t357
        - D_p_x_2_by_b_2_z*t315 - D_p_x_2_by_b_2_z*t316 - D_p_x_2_by_b_2_z*t317 + D_p_x_2_by_b_2_z*t423
        - D_p_y_2_by_b_2_z*t318 - D_p_y_2_by_b_2_z*t319 - D_p_y_2_by_b_2_z*t320 + D_p_y_2_by_b_2_z*t424
        - D_p_z_2_by_b_2_z*t321 - D_p_z_2_by_b_2_z*t322 - D_p_z_2_by_b_2_z*t323 + D_p_z_2_by_b_2_z*t425
        + mu_1_by_b_2_z*t358 + mu_2_by_b_2_z*t359 + mu_3_by_b_2_z*t360,
        D_delta_x_3_by_b_2_z*t355 + D_delta_y_3_by_b_2_z*t356 + D_delta_z_3_by_b_2_z*t357
        - D_p_x_2_by_b_2_z*t327 - D_p_x_2_by_b_2_z*t328 - D_p_x_2_by_b_2_z*t329 + D_p_x_2_by_b_2_z*t426
        - D_p_y_2_by_b_2_z*t330 - D_p_y_2_by_b_2_z*t331 - D_p_y_2_by_b_2_z*t332 + D_p_y_2_by_b_2_z*t427
        - D_p_z_2_by_b_2_z*t333 - D_p_z_2_by_b_2_z*t334 - D_p_z_2_by_b_2_z*t335 + D_p_z_2_by_b_2_z*t428
        + mu_1_by_b_2_z*t361 + mu_2_by_b_2_z*t362 + mu_3_by_b_2_z*t363,
        t497, D_p_x_2_by_b_2_z*k_C, D_p_y_2_by_b_2_z*k_C, D_p_z_2_by_b_2_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_z*k_C
        + mu_1_by_b_2_z*t367 + mu_2_by_b_2_z*t368 + mu_3_by_b_2_z*t369 - t282*t498 - t283*t498 - t284*t498
        - t285*t499 - t286*t499 - t287*t499 - t288*t500 - t289*t500 - t290*t500,
        D_delta_x_1_by_b_2_z*t376 + D_delta_y_1_by_b_2_z*t377 + D_delta_z_1_by_b_2_z*t378
        - D_p_x_3_by_b_2_z*t300 - D_p_x_3_by_b_2_z*t301 - D_p_x_3_by_b_2_z*t302 + D_p_x_3_by_b_2_z*t420
        - D_p_y_3_by_b_2_z*t303 - D_p_y_3_by_b_2_z*t304 - D_p_y_3_by_b_2_z*t305 + D_p_y_3_by_b_2_z*t421
        - D_p_z_3_by_b_2_z*t306 - D_p_z_3_by_b_2_z*t307 - D_p_z_3_by_b_2_z*t308 + D_p_z_3_by_b_2_z*t422
        + mu_1_by_b_2_z*t373 + mu_2_by_b_2_z*t374 + mu_3_by_b_2_z*t375,
        D_delta_x_2_by_b_2_z*t376 + D_delta_y_2_by_b_2_z*t377 + D_delta_z_2_by_b_2_z*t378
        - D_p_x_3_by_b_2_z*t315 - D_p_x_3_by_b_2_z*t316 - D_p_x_3_by_b_2_z*t317 + D_p_x_3_by_b_2_z*t423
        - D_p_y_3_by_b_2_z*t318 - D_p_y_3_by_b_2_z*t319 - D_p_y_3_by_b_2_z*t320 + D_p_y_3_by_b_2_z*t424
        - D_p_z_3_by_b_2_z*t321 - D_p_z_3_by_b_2_z*t322 - D_p_z_3_by_b_2_z*t323 + D_p_z_3_by_b_2_z*t425
        + mu_1_by_b_2_z*t379 + mu_2_by_b_2_z*t380 + mu_3_by_b_2_z*t381,
        D_delta_x_3_by_b_2_z*t376 + D_delta_y_3_by_b_2_z*t377 + D_delta_z_3_by_b_2_z*t378
        - D_p_x_3_by_b_2_z*t327 - D_p_x_3_by_b_2_z*t328 - D_p_x_3_by_b_2_z*t329 + D_p_x_3_by_b_2_z*t426
        - D_p_y_3_by_b_2_z*t330 - D_p_y_3_by_b_2_z*t331 - D_p_y_3_by_b_2_z*t332 + D_p_y_3_by_b_2_z*t427
        - D_p_z_3_by_b_2_z*t333 - D_p_z_3_by_b_2_z*t334 - D_p_z_3_by_b_2_z*t335 + D_p_z_3_by_b_2_z*t428
        + mu_1_by_b_2_z*t382 + mu_2_by_b_2_z*t383 + mu_3_by_b_2_z*t384,
        D_p_x_3_by_b_2_z*k_C, D_p_y_3_by_b_2_z*k_C, D_p_z_3_by_b_2_z*k_C, t218*t494, t495, -t218*t493, t496,
        D_delta_x_1_by_b_2_z*t386 + D_delta_y_1_by_b_2_z*t387 + D_delta_z_1_by_b_2_z*t388
        + mu_1_by_b_2_z*t389 - mu_2_by_b_2_z*t385 - mu_3_by_b_2_z*t385,
        D_delta_x_1_by_b_2_z*t391 + D_delta_x_2_by_b_2_z*t392 + D_delta_y_1_by_b_2_z*t393
        + D_delta_y_2_by_b_2_z*t394 + D_delta_z_1_by_b_2_z*t395 + D_delta_z_2_by_b_2_z*t396
        + mu_1_by_b_2_z*t390 + mu_2_by_b_2_z*t390 + mu_3_by_b_2_z*t390,
        D_delta_x_1_by_b_2_z*t398 + D_delta_x_3_by_b_2_z*t392 + D_delta_y_1_by_b_2_z*t399
        + D_delta_y_3_by_b_2_z*t394 + D_delta_z_1_by_b_2_z*t400 + D_delta_z_3_by_b_2_z*t396
        + mu_1_by_b_2_z*t397 + mu_2_by_b_2_z*t397 + mu_3_by_b_2_z*t397,
        D_delta_x_1_by_b_2_z*k_C, D_delta_y_1_by_b_2_z*k_C, D_delta_z_1_by_b_2_z*k_C,
        D_delta_x_2_by_b_2_z*t402 + D_delta_y_2_by_b_2_z*t403 + D_delta_z_2_by_b_2_z*t404
        - mu_1_by_b_2_z*t401 + mu_2_by_b_2_z*t405 - mu_3_by_b_2_z*t401,
        D_delta_x_2_by_b_2_z*t398 + D_delta_x_3_by_b_2_z*t391 + D_delta_y_2_by_b_2_z*t399
        + D_delta_y_3_by_b_2_z*t393 + D_delta_z_2_by_b_2_z*t400 + D_delta_z_3_by_b_2_z*t395
        + mu_1_by_b_2_z*t406 + mu_2_by_b_2_z*t406 + mu_3_by_b_2_z*t406,
        D_delta_x_2_by_b_2_z*k_C, D_delta_y_2_by_b_2_z*k_C, D_delta_z_2_by_b_2_z*k_C,
        D_delta_x_3_by_b_2_z*t408 + D_delta_y_3_by_b_2_z*t409 + D_delta_z_3_by_b_2_z*t410
        - mu_1_by_b_2_z*t407 - mu_2_by_b_2_z*t407 + mu_3_by_b_2_z*t411,
        D_delta_x_3_by_b_2_z*k_C, D_delta_y_3_by_b_2_z*k_C, D_delta_z_3_by_b_2_z*k_C, t497,
        2*D_p_x_1*D_p_x_1_by_b_3_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_x*k_C
        + mu_1_by_b_3_x*t266 + mu_2_by_b_3_x*t267 + mu_3_by_b_3_x*t268 - t248*t501 - t250*t501 - t251*t501
        - t252*t502 - t254*t502 - t255*t502 - t256*t503 - t258*t503 - t259*t503,
        D_p_x_1*D_p_x_2_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_2*k_C - D_p_x_1_by_b_3_x*t270
        - D_p_x_1_by_b_3_x*t271 - D_p_x_1_by_b_3_x*t272 - D_p_x_2_by_b_3_x*t248 - D_p_x_2_by_b_3_x*t250
        - D_p_x_2_by_b_3_x*t251 + D_p_y_1*D_p_y_2_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_2*k_C
        - D_p_y_1_by_b_3_x*t273 - D_p_y_1_by_b_3_x*t274 - D_p_y_1_by_b_3_x*t275 - D_p_y_2_by_b_3_x*t252
        - D_p_y_2_by_b_3_x*t254 - D_p_y_2_by_b_3_x*t255 + D_p_z_1*D_p_z_2_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_2*k_C - D_p_z_1_by_b_3_x*t276 - D_p_z_1_by_b_3_x*t277
        - D_p_z_1_by_b_3_x*t278 - D_p_z_2_by_b_3_x*t256 - D_p_z_2_by_b_3_x*t258 - D_p_z_2_by_b_3_x*t259
        + mu_1_by_b_3_x*t279 + mu_2_by_b_3_x*t280 + mu_3_by_b_3_x*t281,
        D_p_x_1*D_p_x_3_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_3*k_C - D_p_x_1_by_b_3_x*t282
        - D_p_x_1_by_b_3_x*t283 - D_p_x_1_by_b_3_x*t284 - D_p_x_3_by_b_3_x*t248 - D_p_x_3_by_b_3_x*t250
        - D_p_x_3_by_b_3_x*t251 + D_p_y_1*D_p_y_3_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_3*k_C
        - D_p_y_1_by_b_3_x*t285 - D_p_y_1_by_b_3_x*t286 - D_p_y_1_by_b_3_x*t287 - D_p_y_3_by_b_3_x*t252
        - D_p_y_3_by_b_3_x*t254 - D_p_y_3_by_b_3_x*t255 + D_p_z_1*D_p_z_3_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_3*k_C - D_p_z_1_by_b_3_x*t288 - D_p_z_1_by_b_3_x*t289
        - D_p_z_1_by_b_3_x*t290 - D_p_z_3_by_b_3_x*t256 - D_p_z_3_by_b_3_x*t258 - D_p_z_3_by_b_3_x*t259
        + mu_1_by_b_3_x*t291 + mu_2_by_b_3_x*t292 + mu_3_by_b_3_x*t293,
        D_delta_x_1_by_b_3_x*t312 + D_delta_y_1_by_b_3_x*t313 + D_delta_z_1_by_b_3_x*t314
        - D_p_x_1_by_b_3_x*t300 - D_p_x_1_by_b_3_x*t301 - D_p_x_1_by_b_3_x*t302 + D_p_x_1_by_b_3_x*t420
        - D_p_y_1_by_b_3_x*t303 - D_p_y_1_by_b_3_x*t304 - D_p_y_1_by_b_3_x*t305 + D_p_y_1_by_b_3_x*t421
        - D_p_z_1_by_b_3_x*t306 - D_p_z_1_by_b_3_x*t307 - D_p_z_1_by_b_3_x*t308 + D_p_z_1_by_b_3_x*t422
        + mu_1_by_b_3_x*t309 + mu_2_by_b_3_x*t310 + mu_3_by_b_3_x*t311,
        D_delta_x_2_by_b_3_x*t312 + D_delta_y_2_by_b_3_x*t313 + D_delta_z_2_by_b_3_x*t314
        - D_p_x_1_by_b_3_x*t315 - D_p_x_1_by_b_3_x*t316 - D_p_x_1_by_b_3_x*t317 + D_p_x_1_by_b_3_x*t423
        - D_p_y_1_by_b_3_x*t318 - D_p_y_1_by_b_3_x*t319 - D_p_y_1_by_b_3_x*t320 + D_p_y_1_by_b_3_x*t424
        - D_p_z_1_by_b_3_x*t321 - D_p_z_1_by_b_3_x*t322 - D_p_z_1_by_b_3_x*t323 + D_p_z_1_by_b_3_x*t425
        + mu_1_by_b_3_x*t324 + mu_2_by_b_3_x*t325 + mu_3_by_b_3_x*t326,
        D_delta_x_3_by_b_3_x*t312 + D_delta_y_3_by_b_3_x*t313 + D_delta_z_3_by_b_3_x*t314
        - D_p_x_1_by_b_3_x*t327 - D_p_x_1_by_b_3_x*t328 - D_p_x_1_by_b_3_x*t329 + D_p_x_1_by_b_3_x*t426
        - D_p_y_1_by_b_3_x*t330 - D_p_y_1_by_b_3_x*t331 - D_p_y_1_by_b_3_x*t332 + D_p_y_1_by_b_3_x*t427
        - D_p_z_1_by_b_3_x*t333 - D_p_z_1_by_b_3_x*t334 - D_p_z_1_by_b_3_x*t335 + D_p_z_1_by_b_3_x*t428
        + mu_1_by_b_3_x*t336 + mu_2_by_b_3_x*t337 + mu_3_by_b_3_x*t338,
        D_p_x_1_by_b_3_x*k_C, D_p_y_1_by_b_3_x*k_C, D_p_z_1_by_b_3_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_x*k_C
        + mu_1_by_b_3_x*t343 + mu_2_by_b_3_x*t344 + mu_3_by_b_3_x*t345 - t270*t504 - t271*t504 - t272*t504
        - t273*t505 - t274*t505 - t275*t505 - t276*t506 - t277*t506 - t278*t506,
        D_p_x_2*D_p_x_3_by_b_3_x*k_C + D_p_x_2_by_b_3_x*D_p_x_3*k_C - D_p_x_2_by_b_3_x*t282
        - D_p_x_2_by_b_3_x*t283 - D_p_x_2_by_b_3_x*t284 - D_p_x_3_by_b_3_x*t270 - D_p_x_3_by_b_3_x*t271
        - D_p_x_3_by_b_3_x*t272 + D_p_y_2*D_p_y_3_by_b_3_x*k_C + D_p_y_2_by_b_3_x*D_p_y_3*k_C
        - D_p_y_2_by_b_3_x*t285 - D_p_y_2_by_b_3_x*t286 - D_p_y_2_by_b_3_x*t287 - D_p_y_3_by_b_3_x*t273
        - D_p_y_3_by_b_3_x*t274 - D_p_y_3_by_b_3_x*t275 + D_p_z_2*D_p_z_3_by_b_3_x*k_C
        + D_p_z_2_by_b_3_x*D_p_z_3*k_C - D_p_z_2_by_b_3_x*t288 - D_p_z_2_by_b_3_x*t289
        - D_p_z_2_by_b_3_x*t290 - D_p_z_3_by_b_3_x*t276 - D_p_z_3_by_b_3_x*t277 - D_p_z_3_by_b_3_x*t278
        + mu_1_by_b_3_x*t346 + mu_2_by_b_3_x*t347 + mu_3_by_b_3_x*t348,
        D_delta_x_1_by_b_3_x*t355 + D_delta_y_1_by_b_3_x*t356 + D_delta_z_1_by_b_3_x*t357
        - D_p_x_2_by_b_3_x*t300 - D_p_x_2_by_b_3_x*t301 - D_p_x_2_by_b_3_x*t302 + D_p_x_2_by_b_3_x*t420
        - D_p_y_2_by_b_3_x*t303 - D_p_y_2_by_b_3_x*t304 - D_p_y_2_by_b_3_x*t305 + D_p_y_2_by_b_3_x*t421
        - D_p_z_2_by_b_3_x*t306 - D_p_z_2_by_b_3_x*t307 - D_p_z_2_by_b_3_x*t308 + D_p_z_2_by_b_3_x*t422
        + mu_1_by_b_3_x*t352 + mu_2_by_b_3_x*t353 + mu_3_by_b_3_x*t354,
        D_delta_x_2_by_b_3_x*t355 + D_delta_y_2_by_b_3_x*t356 + D_delta_z_2_by_b_3_x*t357
        - D_p_x_2_by_b_3_x*t315 - D_p_x_2_by_b_3_x*t316 - D_p_x_2_by_b_3_x*t317 + D_p_x_2_by_b_3_x*t423
        - D_p_y_2_by_b_3_x*t318 - D_p_y_2_by_b_3_x*t319 - D_p_y_2_by_b_3_x*t320 + D_p_y_2_by_b_3_x*t424
        - D_p_z_2_by_b_3_x*t321 - D_p_z_2_by_b_3_x*t322 - D_p_z_2_by_b_3_x*t323 + D_p_z_2_by_b_3_x*t425
        + mu_1_by_b_3_x*t358 + mu_2_by_b_3_x*t359 + mu_3_by_b_3_x*t360,
        D_delta_x_3_by_b_3_x*t355 + D_delta_y_3_by_b_3_x*t356 + D_delta_z_3_by_b_3_x*t357
        - D_p_x_2_by_b_3_x*t327 - D_p_x_2_by_b_3_x*t328 - D_p_x_2_by_b_3_x*t329 + D_p_x_2_by_b_3_x*t426
        - D_p_y_2_by_b_3_x*t330 - D_p_y_2_by_b_3_x*t331 - D_p_y_2_by_b_3_x*t332 + D_p_y_2_by_b_3_x*t427
        - D_p_z_2_by_b_3_x*t333 - D_p_z_2_by_b_3_x*t334 - D_p_z_2_by_b_3_x*t335 + D_p_z_2_by_b_3_x*t428
        + mu_1_by_b_3_x*t361 + mu_2_by_b_3_x*t362 + mu_3_by_b_3_x*t363,
        D_p_x_2_by_b_3_x*k_C, D_p_y_2_by_b_3_x*k_C, D_p_z_2_by_b_3_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_x*k_C
        + k_sp_3*t510*t516*w_b_3*x_3_by_b_3_x + mu_1_by_b_3_x*t367 + mu_2_by_b_3_x*t368
        + mu_3_by_b_3_x*t369 - t282*t507 - t283*t507 - t284*t507 - t285*t508 - t286*t508 - t287*t508
        - t288*t509 - t289*t509 - t290*t509 - t515,
        t518, t519,
        D_delta_x_1_by_b_3_x*t376 + D_delta_y_1_by_b_3_x*t377 + D_delta_z_1_by_b_3_x*t378
        - D_p_x_3_by_b_3_x*t300 - D_p_x_3_by_b_3_x*t301 - D_p_x_3_by_b_3_x*t302 + D_p_x_3_by_b_3_x*t420
        - D_p_y_3_by_b_3_x*t303 - D_p_y_3_by_b_3_x*t304 - D_p_y_3_by_b_3_x*t305 + D_p_y_3_by_b_3_x*t421
        - D_p_z_3_by_b_3_x*t306 - D_p_z_3_by_b_3_x*t307 - D_p_z_3_by_b_3_x*t308 + D_p_z_3_by_b_3_x*t422
        + mu_1_by_b_3_x*t373 + mu_2_by_b_3_x*t374 + mu_3_by_b_3_x*t375,
        D_delta_x_2_by_b_3_x*t376 + D_delta_y_2_by_b_3_x*t377 + D_delta_z_2_by_b_3_x*t378
        - D_p_x_3_by_b_3_x*t315 - D_p_x_3_by_b_3_x*t316 - D_p_x_3_by_b_3_x*t317 + D_p_x_3_by_b_3_x*t423
        - D_p_y_3_by_b_3_x*t318 - D_p_y_3_by_b_3_x*t319 - D_p_y_3_by_b_3_x*t320 + D_p_y_3_by_b_3_x*t424
        - D_p_z_3_by_b_3_x*t321 - D_p_z_3_by_b_3_x*t322 - D_p_z_3_by_b_3_x*t323 + D_p_z_3_by_b_3_x*t425
        + mu_1_by_b_3_x*t379 + mu_2_by_b_3_x*t380 + mu_3_by_b_3_x*t381,
        D_delta_x_3_by_b_3_x*t376 + D_delta_y_3_by_b_3_x*t377 + D_delta_z_3_by_b_3_x*t378
        - D_p_x_3_by_b_3_x*t327 - D_p_x_3_by_b_3_x*t328 - D_p_x_3_by_b_3_x*t329 + D_p_x_3_by_b_3_x*t426
        - D_p_y_3_by_b_3_x*t330 - D_p_y_3_by_b_3_x*t331 - D_p_y_3_by_b_3_x*t332 + D_p_y_3_by_b_3_x*t427
        - D_p_z_3_by_b_3_x*t333 - D_p_z_3_by_b_3_x*t334 - D_p_z_3_by_b_3_x*t335 + D_p_z_3_by_b_3_x*t428
        + mu_1_by_b_3_x*t382 + mu_2_by_b_3_x*t383 + mu_3_by_b_3_x*t384,
        t520, D_p_x_3_by_b_3_x*k_C, D_p_y_3_by_b_3_x*k_C, D_p_z_3_by_b_3_x*k_C, t230*t517, t518, -t230*t515,
        t519,
        D_delta_x_1_by_b_3_x*t386 + D_delta_y_1_by_b_3_x*t387 + D_delta_z_1_by_b_3_x*t388
        + mu_1_by_b_3_x*t389 - mu_2_by_b_3_x*t385 - mu_3_by_b_3_x*t385,
        D_delta_x_1_by_b_3_x*t391 + D_delta_x_2_by_b_3_x*t392 + D_delta_y_1_by_b_3_x*t393
        + D_delta_y_2_by_b_3_x*t394 + D_delta_z_1_by_b_3_x*t395 + D_delta_z_2_by_b_3_x*t396
        + mu_1_by_b_3_x*t390 + mu_2_by_b_3_x*t390 + mu_3_by_b_3_x*t390,
        D_delta_x_1_by_b_3_x*t398 + D_delta_x_3_by_b_3_x*t392 + D_delta_y_1_by_b_3_x*t399
        + D_delta_y_3_by_b_3_x*t394 + D_delta_z_1_by_b_3_x*t400 + D_delta_z_3_by_b_3_x*t396
        + mu_1_by_b_3_x*t397 + mu_2_by_b_3_x*t397 + mu_3_by_b_3_x*t397,
        D_delta_x_1_by_b_3_x*k_C, D_delta_y_1_by_b_3_x*k_C, D_delta_z_1_by_b_3_x*k_C,
        D_delta_x_2_by_b_3_x*t402 + D_delta_y_2_by_b_3_x*t403 + D_delta_z_2_by_b_3_x*t404
        - mu_1_by_b_3_x*t401 + mu_2_by_b_3_x*t405 - mu_3_by_b_3_x*t401,
        D_delta_x_2_by_b_3_x*t398 + D_delta_x_3_by_b_3_x*t391 + D_delta_y_2_by_b_3_x*t399
        + D_delta_y_3_by_b_3_x*t393 + D_delta_z_2_by_b_3_x*t400 + D_delta_z_3_by_b_3_x*t395
        + mu_1_by_b_3_x*t406 + mu_2_by_b_3_x*t406 + mu_3_by_b_3_x*t406,
        D_delta_x_2_by_b_3_x*k_C, D_delta_y_2_by_b_3_x*k_C, D_delta_z_2_by_b_3_x*k_C,
        D_delta_x_3_by_b_3_x*t408 + D_delta_y_3_by_b_3_x*t409 + D_delta_z_3_by_b_3_x*t410
        - mu_1_by_b_3_x*t407 - mu_2_by_b_3_x*t407 + mu_3_by_b_3_x*t411,
        D_delta_x_3_by_b_3_x*k_C, D_delta_y_3_by_b_3_x*k_C, D_delta_z_3_by_b_3_x*k_C, t520,
        2*D_p_x_1*D_p_x_1_by_b_3_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_y*k_C
        + mu_1_by_b_3_y*t266 + mu_2_by_b_3_y*t267 + mu_3_by_b_3_y*t268 - t248*t521 - t250*t521 - t251*t521
        - t252*t522 - t254*t522 - t255*t522 - t256*t523 - t258*t523 - t259*t523,
        D_p_x_1*D_p_x_2_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_2*k_C - D_p_x_1_by_b_3_y*t270
        - D_p_x_1_by_b_3_y*t271 - D_p_x_1_by_b_3_y*t272 - D_p_x_2_by_b_3_y*t248 - D_p_x_2_by_b_3_y*t250
        - D_p_x_2_by_b_3_y*t251 + D_p_y_1*D_p_y_2_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_2*k_C
        - D_p_y_1_by_b_3_y*t273 - D_p_y_1_by_b_3_y*t274 - D_p_y_1_by_b_3_y*t275 - D_p_y_2_by_b_3_y*t252
        - D_p_y_2_by_b_3_y*t254 - D_p_y_2_by_b_3_y*t255 + D_p_z_1*D_p_z_2_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_2*k_C - D_p_z_1_by_b_3_y*t276 - D_p_z_1_by_b_3_y*t277
        - D_p_z_1_by_b_3_y*t278 - D_p_z_2_by_b_3_y*t256 - D_p_z_2_by_b_3_y*t258 - D_p_z_2_by_b_3_y*t259
        + mu_1_by_b_3_y*t279 + mu_2_by_b_3_y*t280 + mu_3_by_b_3_y*t281,
        D_p_x_1*D_p_x_3_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_3*k_C - D_p_x_1_by_b_3_y*t282
        - D_p_x_1_by_b_3_y*t283 - D_p_x_1_by_b_3_y*t284 - D_p_x_3_by_b_3_y*t248 - D_p_x_3_by_b_3_y*t250
        - D_p_x_3_by_b_3_y*t251 + D_p_y_1*D_p_y_3_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_3*k_C
        - D_p_y_1_by_b_3_y*t285 - D_p_y_1_by_b_3_y*t286 - D_p_y_1_by_b_3_y*t287 - D_p_y_3_by_b_3_y*t252
        - D_p_y_3_by_b_3_y*t254 - D_p_y_3_by_b_3_y*t255 + D_p_z_1*D_p_z_3_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_3*k_C - D_p_z_1_by_b_3_y*t288 - D_p_z_1_by_b_3_y*t289
        - D_p_z_1_by_b_3_y*t290 - D_p_z_3_by_b_3_y*t256 - D_p_z_3_by_b_3_y*t258 - D_p_z_3_by_b_3_y*t259
        + mu_1_by_b_3_y*t291 + mu_2_by_b_3_y*t292 + mu_3_by_b_3_y*t293,
        D_delta_x_1_by_b_3_y*t312 + D_delta_y_1_by_b_3_y*t313 + D_delta_z_1_by_b_3_y*t314
        - D_p_x_1_by_b_3_y*t300 - D_p_x_1_by_b_3_y*t301 - D_p_x_1_by_b_3_y*t302 + D_p_x_1_by_b_3_y*t420
        - D_p_y_1_by_b_3_y*t303 - D_p_y_1_by_b_3_y*t304 - D_p_y_1_by_b_3_y*t305 + D_p_y_1_by_b_3_y*t421
        - D_p_z_1_by_b_3_y*t306 - D_p_z_1_by_b_3_y*t307 - D_p_z_1_by_b_3_y*t308 + D_p_z_1_by_b_3_y*t422
        + mu_1_by_b_3_y*t309 + mu_2_by_b_3_y*t310 + mu_3_by_b_3_y*t311,
        D_delta_x_2_by_b_3_y*t312 + D_delta_y_2_by_b_3_y*t313 + D_delta_z_2_by_b_3_y*t314
        - D_p_x_1_by_b_3_y*t315 - D_p_x_1_by_b_3_y*t316 - D_p_x_1_by_b_3_y*t317 + D_p_x_1_by_b_3_y*t423
        - D_p_y_1_by_b_3_y*t318 - D_p_y_1_by_b_3_y*t319 - D_p_y_1_by_b_3_y*t320 + D_p_y_1_by_b_3_y*t424
        - D_p_z_1_by_b_3_y*t321 - D_p_z_1_by_b_3_y*t322 - D_p_z_1_by_b_3_y*t323 + D_p_z_1_by_b_3_y*t425
        + mu_1_by_b_3_y*t324 + mu_2_by_b_3_y*t325 + mu_3_by_b_3_y*t326,
        D_delta_x_3_by_b_3_y*t312 + D_delta_y_3_by_b_3_y*t313 + D_delta_z_3_by_b_3_y*t314
        - D_p_x_1_by_b_3_y*t327 - D_p_x_1_by_b_3_y*t328 - D_p_x_1_by_b_3_y*t329 + D_p_x_1_by_b_3_y*t426
        - D_p_y_1_by_b_3_y*t330 - D_p_y_1_by_b_3_y*t331 - D_p_y_1_by_b_3_y*t332 + D_p_y_1_by_b_3_y*t427
        - D_p_z_1_by_b_3_y*t333 - D_p_z_1_by_b_3_y*t334 - D_p_z_1_by_b_3_y*t335 + D_p_z_1_by_b_3_y*t428
        + mu_1_by_b_3_y*t336 + mu_2_by_b_3_y*t337 + mu_3_by_b_3_y*t338,
        D_p_x_1_by_b_3_y*k_C, D_p_y_1_by_b_3_y*k_C, D_p_z_1_by_b_3_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_y*k_C
        + mu_1_by_b_3_y*t343 + mu_2_by_b_3_y*t344 + mu_3_by_b_3_y*t345 - t270*t524 - t271*t524 - t272*t524
        - t273*t525 - t274*t525 - t275*t525 - t276*t526 - t277*t526 - t278*t526,
        D_p_x_2*D_p_x_3_by_b_3_y*k_C + D_p_x_2_by_b_3_y*D_p_x_3*k_C - D_p_x_2_by_b_3_y*t282
        - D_p_x_2_by_b_3_y*t283 - D_p_x_2_by_b_3_y*t284 - D_p_x_3_by_b_3_y*t270 - D_p_x_3_by_b_3_y*t271
        - D_p_x_3_by_b_3_y*t272 + D_p_y_2*D_p_y_3_by_b_3_y*k_C + D_p_y_2_by_b_3_y*D_p_y_3*k_C
        - D_p_y_2_by_b_3_y*t285 - D_p_y_2_by_b_3_y*t286 - D_p_y_2_by_b_3_y*t287 - D_p_y_3_by_b_3_y*t273
        - D_p_y_3_by_b_3_y*t274 - D_p_y_3_by_b_3_y*t275 + D_p_z_2*D_p_z_3_by_b_3_y*k_C
        + D_p_z_2_by_b_3_y*D_p_z_3*k_C - D_p_z_2_by_b_3_y*t288 - D_p_z_2_by_b_3_y*t289
        - D_p_z_2_by_b_3_y*t290 - D_p_z_3_by_b_3_y*t276 - D_p_z_3_by_b_3_y*t277 - D_p_z_3_by_b_3_y*t278
        + mu_1_by_b_3_y*t346 + mu_2_by_b_3_y*t347 + mu_3_by_b_3_y*t348,
        D_delta_x_1_by_b_3_y*t355 + D_delta_y_1_by_b_3_y*t356 + D_delta_z_1_by_b_3_y*t357
        - D_p_x_2_by_b_3_y*t300 - D_p_x_2_by_b_3_y*t301 - D_p_x_2_by_b_3_y*t302 + D_p_x_2_by_b_3_y*t420
        - D_p_y_2_by_b_3_y*t303 - D_p_y_2_by_b_3_y*t304 - D_p_y_2_by_b_3_y*t305 + D_p_y_2_by_b_3_y*t421
        - D_p_z_2_by_b_3_y*t306 - D_p_z_2_by_b_3_y*t307 - D_p_z_2_by_b_3_y*t308 + D_p_z_2_by_b_3_y*t422
        + mu_1_by_b_3_y*t352 + mu_2_by_b_3_y*t353 + mu_3_by_b_3_y*t354,
        D_delta_x_2_by_b_3_y*t355 + D_delta_y_2_by_b_3_y*t356 + D_delta_z_2_by_b_3_y*t357
        - D_p_x_2_by_b_3_y*t315 - D_p_x_2_by_b_3_y*t316 - D_p_x_2_by_b_3_y*t317 + D_p_x_2_by_b_3_y*t423
        - D_p_y_2_by_b_3_y*t318 - D_p_y_2_by_b_3_y*t319 - D_p_y_2_by_b_3_y*t320 + D_p_y_2_by_b_3_y*t424
        - D_p_z_2_by_b_3_y*t321 - D_p_z_2_by_b_3_y*t322 - D_p_z_2_by_b_3_y*t323 + D_p_z_2_by_b_3_y*t425
        + mu_1_by_b_3_y*t358 + mu_2_by_b_3_y*t359 + mu_3_by_b_3_y*t360,
        D_delta_x_3_by_b_3_y*t355 + D_delta_y_3_by_b_3_y*t356 + D_delta_z_3_by_b_3_y*t357
        - D_p_x_2_by_b_3_y*t327 - D_p_x_2_by_b_3_y*t328 - D_p_x_2_by_b_3_y*t329 + D_p_x_2_by_b_3_y*t426
        - D_p_y_2_by_b_3_y*t330 - D_p_y_2_by_b_3_y*t331 - D_p_y_2_by_b_3_y*t332 + D_p_y_2_by_b_3_y*t427
        - D_p_z_2_by_b_3_y*t333 - D_p_z_2_by_b_3_y*t334 - D_p_z_2_by_b_3_y*t335 + D_p_z_2_by_b_3_y*t428
        + mu_1_by_b_3_y*t361 + mu_2_by_b_3_y*t362 + mu_3_by_b_3_y*t363,
        D_p_x_2_by_b_3_y*k_C, D_p_y_2_by_b_3_y*k_C, D_p_z_2_by_b_3_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_y*k_C
        + k_sp_3*t510*t516*w_b_3*x_3_by_b_3_y + mu_1_by_b_3_y*t367 + mu_2_by_b_3_y*t368
        + mu_3_by_b_3_y*t369 - t282*t527 - t283*t527 - t284*t527 - t285*t528 - t286*t528 - t287*t528
        - t288*t529 - t289*t529 - t290*t529 - t531,
        t533, t534,
        D_delta_x_1_by_b_3_y*t376 + D_delta_y_1_by_b_3_y*t377 + D_delta_z_1_by_b_3_y*t378
        - D_p_x_3_by_b_3_y*t300 - D_p_x_3_by_b_3_y*t301 - D_p_x_3_by_b_3_y*t302 + D_p_x_3_by_b_3_y*t420
        - D_p_y_3_by_b_3_y*t303 - D_p_y_3_by_b_3_y*t304 - D_p_y_3_by_b_3_y*t305 + D_p_y_3_by_b_3_y*t421
        - D_p_z_3_by_b_3_y*t306 - D_p_z_3_by_b_3_y*t307 - D_p_z_3_by_b_3_y*t308 + D_p_z_3_by_b_3_y*t422
        + mu_1_by_b_3_y*t373 + mu_2_by_b_3_y*t374 + mu_3_by_b_3_y*t375,
        D_delta_x_2_by_b_3_y*t376 + D_delta_y_2_by_b_3_y*t377 + D_delta_z_2_by_b_3_y*t378
        - D_p_x_3_by_b_3_y*t315 - D_p_x_3_by_b_3_y*t316 - D_p_x_3_by_b_3_y*t317 + D_p_x_3_by_b_3_y*t423
        - D_p_y_3_by_b_3_y*t318 - D_p_y_3_by_b_3_y*t319 - D_p_y_3_by_b_3_y*t320 + D_p_y_3_by_b_3_y*t424
        - D_p_z_3_by_b_3_y*t321 - D_p_z_3_by_b_3_y*t322 - D_p_z_3_by_b_3_y*t323 + D_p_z_3_by_b_3_y*t425
        + mu_1_by_b_3_y*t379 + mu_2_by_b_3_y*t380 + mu_3_by_b_3_y*t381,
        D_delta_x_3_by_b_3_y*t376 + D_delta_y_3_by_b_3_y*t377 + D_delta_z_3_by_b_3_y*t378
        - D_p_x_3_by_b_3_y*t327 - D_p_x_3_by_b_3_y*t328 - D_p_x_3_by_b_3_y*t329 + D_p_x_3_by_b_3_y*t426
        - D_p_y_3_by_b_3_y*t330 - D_p_y_3_by_b_3_y*t331 - D_p_y_3_by_b_3_y*t332 + D_p_y_3_by_b_3_y*t427
        - D_p_z_3_by_b_3_y*t333 - D_p_z_3_by_b_3_y*t334 - D_p_z_3_by_b_3_y*t335 + D_p_z_3_by_b_3_y*t428
        + mu_1_by_b_3_y*t382 + mu_2_by_b_3_y*t383 + mu_3_by_b_3_y*t384,
        t535, D_p_x_3_by_b_3_y*k_C, D_p_y_3_by_b_3_y*k_C, D_p_z_3_by_b_3_y*k_C, t230*t532, t533, -t230*t531,
        t534,
        D_delta_x_1_by_b_3_y*t386 + D_delta_y_1_by_b_3_y*t387 + D_delta_z_1_by_b_3_y*t388
        + mu_1_by_b_3_y*t389 - mu_2_by_b_3_y*t385 - mu_3_by_b_3_y*t385,
        D_delta_x_1_by_b_3_y*t391 + D_delta_x_2_by_b_3_y*t392 + D_delta_y_1_by_b_3_y*t393
        + D_delta_y_2_by_b_3_y*t394 + D_delta_z_1_by_b_3_y*t395 + D_delta_z_2_by_b_3_y*t396
        + mu_1_by_b_3_y*t390 + mu_2_by_b_3_y*t390 + mu_3_by_b_3_y*t390,
        D_delta_x_1_by_b_3_y*t398 + D_delta_x_3_by_b_3_y*t392 + D_delta_y_1_by_b_3_y*t399
        + D_delta_y_3_by_b_3_y*t394 + D_delta_z_1_by_b_3_y*t400 + D_delta_z_3_by_b_3_y*t396
        + mu_1_by_b_3_y*t397 + mu_2_by_b_3_y*t397 + mu_3_by_b_3_y*t397,
        D_delta_x_1_by_b_3_y*k_C, D_delta_y_1_by_b_3_y*k_C, D_delta_z_1_by_b_3_y*k_C,
        D_delta_x_2_by_b_3_y*t402 + D_delta_y_2_by_b_3_y*t403 + D_delta_z_2_by_b_3_y*t404
        - mu_1_by_b_3_y*t401 + mu_2_by_b_3_y*t405 - mu_3_by_b_3_y*t401,
        D_delta_x_2_by_b_3_y*t398 + D_delta_x_3_by_b_3_y*t391 + D_delta_y_2_by_b_3_y*t399
        + D_delta_y_3_by_b_3_y*t393 + D_delta_z_2_by_b_3_y*t400 + D_delta_z_3_by_b_3_y*t395
        + mu_1_by_b_3_y*t406 + mu_2_by_b_3_y*t406 + mu_3_by_b_3_y*t406,
        D_delta_x_2_by_b_3_y*k_C, D_delta_y_2_by_b_3_y*k_C, D_delta_z_2_by_b_3_y*k_C,
        D_delta_x_3_by_b_3_y*t408 + D_delta_y_3_by_b_3_y*t409 + D_delta_z_3_by_b_3_y*t410
        - mu_1_by_b_3_y*t407 - mu_2_by_b_3_y*t407 + mu_3_by_b_3_y*t411,
        D_delta_x_3_by_b_3_y*k_C, D_delta_y_3_by_b_3_y*k_C, D_delta_z_3_by_b_3_y*k_C, t535,
        2*D_p_x_1*D_p_x_1_by_b_3_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_z*k_C
        + mu_1_by_b_3_z*t266 + mu_2_by_b_3_z*t267 + mu_3_by_b_3_z*t268 - t248*t536 - t250*t536 - t251*t536
        - t252*t537 - t254*t537 - t255*t537 - t256*t538 - t258*t538 - t259*t538,
        D_p_x_1*D_p_x_2_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_2*k_C - D_p_x_1_by_b_3_z*t270
        - D_p_x_1_by_b_3_z*t271 - D_p_x_1_by_b_3_z*t272 - D_p_x_2_by_b_3_z*t248 - D_p_x_2_by_b_3_z*t250
        - D_p_x_2_by_b_3_z*t251 + D_p_y_1*D_p_y_2_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_2*k_C
        - D_p_y_1_by_b_3_z*t273 - D_p_y_1_by_b_3_z*t274 - D_p_y_1_by_b_3_z*t275 - D_p_y_2_by_b_3_z*t252
        - D_p_y_2_by_b_3_z*t254 - D_p_y_2_by_b_3_z*t255 + D_p_z_1*D_p_z_2_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_2*k_C - D_p_z_1_by_b_3_z*t276 - D_p_z_1_by_b_3_z*t277
        - D_p_z_1_by_b_3_z*t278 - D_p_z_2_by_b_3_z*t256 - D_p_z_2_by_b_3_z*t258 - D_p_z_2_by_b_3_z*t259
        + mu_1_by_b_3_z*t279 + mu_2_by_b_3_z*t280 + mu_3_by_b_3_z*t281,
        D_p_x_1*D_p_x_3_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_3*k_C - D_p_x_1_by_b_3_z*t282
        - D_p_x_1_by_b_3_z*t283 - D_p_x_1_by_b_3_z*t284 - D_p_x_3_by_b_3_z*t248 - D_p_x_3_by_b_3_z*t250
        - D_p_x_3_by_b_3_z*t251 + D_p_y_1*D_p_y_3_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_3*k_C
        - D_p_y_1_by_b_3_z*t285 - D_p_y_1_by_b_3_z*t286 - D_p_y_1_by_b_3_z*t287 - D_p_y_3_by_b_3_z*t252
        - D_p_y_3_by_b_3_z*t254 - D_p_y_3_by_b_3_z*t255 + D_p_z_1*D_p_z_3_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_3*k_C - D_p_z_1_by_b_3_z*t288 - D_p_z_1_by_b_3_z*t289
        - D_p_z_1_by_b_3_z*t290 - D_p_z_3_by_b_3_z*t256 - D_p_z_3_by_b_3_z*t258 - D_p_z_3_by_b_3_z*t259
        + mu_1_by_b_3_z*t291 + mu_2_by_b_3_z*t292 + mu_3_by_b_3_z*t293,
        D_delta_x_1_by_b_3_z*t312 + D_delta_y_1_by_b_3_z*t313 + D_delta_z_1_by_b_3_z*t314
        - D_p_x_1_by_b_3_z*t300 - D_p_x_1_by_b_3_z*t301 - D_p_x_1_by_b_3_z*t302 + D_p_x_1_by_b_3_z*t420
        - D_p_y_1_by_b_3_z*t303 - D_p_y_1_by_b_3_z*t304 - D_p_y_1_by_b_3_z*t305 + D_p_y_1_by_b_3_z*t421
        - D_p_z_1_by_b_3_z*t306 - D_p_z_1_by_b_3_z*t307 - D_p_z_1_by_b_3_z*t308 + D_p_z_1_by_b_3_z*t422
        + mu_1_by_b_3_z*t309 + mu_2_by_b_3_z*t310 + mu_3_by_b_3_z*t311,
        D_delta_x_2_by_b_3_z*t312 + D_delta_y_2_by_b_3_z*t313 + D_delta_z_2_by_b_3_z*t314
        - D_p_x_1_by_b_3_z*t315 - D_p_x_1_by_b_3_z*t316 - D_p_x_1_by_b_3_z*t317 + D_p_x_1_by_b_3_z*t423
        - D_p_y_1_by_b_3_z*t318 - D_p_y_1_by_b_3_z*t319 - D_p_y_1_by_b_3_z*t320 + D_p_y_1_by_b_3_z*t424
        - D_p_z_1_by_b_3_z*t321 - D_p_z_1_by_b_3_z*t322 - D_p_z_1_by_b_3_z*t323 + D_p_z_1_by_b_3_z*t425
        + mu_1_by_b_3_z*t324 + mu_2_by_b_3_z*t325 + mu_3_by_b_3_z*t326,
        D_delta_x_3_by_b_3_z*t312 + D_delta_y_3_by_b_3_z*t313 + D_delta_z_3_by_b_3_z*t314
        - D_p_x_1_by_b_3_z*t327 - D_p_x_1_by_b_3_z*t328 - D_p_x_1_by_b_3_z*t329 + D_p_x_1_by_b_3_z*t426
        - D_p_y_1_by_b_3_z*t330 - D_p_y_1_by_b_3_z*t331 - D_p_y_1_by_b_3_z*t332 + D_p_y_1_by_b_3_z*t427
        - D_p_z_1_by_b_3_z*t333 - D_p_z_1_by_b_3_z*t334 - D_p_z_1_by_b_3_z*t335 + D_p_z_1_by_b_3_z*t428
        + mu_1_by_b_3_z*t336 + mu_2_by_b_3_z*t337 + mu_3_by_b_3_z*t338,
        D_p_x_1_by_b_3_z*k_C, D_p_y_1_by_b_3_z*k_C, D_p_z_1_by_b_3_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_z*k_C
        + mu_1_by_b_3_z*t343 + mu_2_by_b_3_z*t344 + mu_3_by_b_3_z*t345 - t270*t539 - t271*t539 - t272*t539
        - t273*t540 - t274*t540 - t275*t540 - t276*t541 - t277*t541 - t278*t541,
        D_p_x_2*D_p_x_3_by_b_3_z*k_C + D_p_x_2_by_b_3_z*D_p_x_3*k_C - D_p_x_2_by_b_3_z*t282
        - D_p_x_2_by_b_3_z*t283 - D_p_x_2_by_b_3_z*t284 - D_p_x_3_by_b_3_z*t270 - D_p_x_3_by_b_3_z*t271
        - D_p_x_3_by_b_3_z*t272 + D_p_y_2*D_p_y_3_by_b_3_z*k_C + D_p_y_2_by_b_3_z*D_p_y_3*k_C
        - D_p_y_2_by_b_3_z*t285 - D_p_y_2_by_b_3_z*t286 - D_p_y_2_by_b_3_z*t287 - D_p_y_3_by_b_3_z*t273
        - D_p_y_3_by_b_3_z*t274 - D_p_y_3_by_b_3_z*t275 + D_p_z_2*D_p_z_3_by_b_3_z*k_C
        + D_p_z_2_by_b_3_z*D_p_z_3*k_C - D_p_z_2_by_b_3_z*t288 - D_p_z_2_by_b_3_z*t289
        - D_p_z_2_by_b_3_z*t290 - D_p_z_3_by_b_3_z*t276 - D_p_z_3_by_b_3_z*t277 - D_p_z_3_by_b_3_z*t278
        + mu_1_by_b_3_z*t346 + mu_2_by_b_3_z*t347 + mu_3_by_b_3_z*t348,
        D_delta_x_1_by_b_3_z*t355 + D_delta_y_1_by_b_3_z*t356 + D_delta_z_1_by_b_3_z*t357
        - D_p_x_2_by_b_3_z*t300 - D_p_x_2_by_b_3_z*t301 - D_p_x_2_by_b_3_z*t302 + D_p_x_2_by_b_3_z*t420
        - D_p_y_2_by_b_3_z*t303 - D_p_y_2_by_b_3_z*t304 - D_p_y_2_by_b_3_z*t305 + D_p_y_2_by_b_3_z*t421
        - D_p_z_2_by_b_3_z*t306 - D_p_z_2_by_b_3_z*t307 - D_p_z_2_by_b_3_z*t308 + D_p_z_2_by_b_3_z*t422
        + mu_1_by_b_3_z*t352 + mu_2_by_b_3_z*t353 + mu_3_by_b_3_z*t354,
        D_delta_x_2_by_b_3_z*t355 + D_delta_y_2_by_b_3_z*t356 + D_delta_z_2_by_b_3_z*t357
        - D_p_x_2_by_b_3_z*t315 - D_p_x_2_by_b_3_z*t316 - D_p_x_2_by_b_3_z*t317 + D_p_x_2_by_b_3_z*t423
        - D_p_y_2_by_b_3_z*t318 - D_p_y_2_by_b_3_z*t319 - D_p_y_2_by_b_3_z*t320 + D_p_y_2_by_b_3_z*t424
        - D_p_z_2_by_b_3_z*t321 - D_p_z_2_by_b_3_z*t322 - D_p_z_2_by_b_3_z*t323 + D_p_z_2_by_b_3_z*t425
        + mu_1_by_b_3_z*t358 + mu_2_by_b_3_z*t359 + mu_3_by_b_3_z*t360,
        D_delta_x_3_by_b_3_z*t355 + D_delta_y_3_by_b_3_z*t356 + D_delta_z_3_by_b_3_z*t357
        - D_p_x_2_by_b_3_z*t327 - D_p_x_2_by_b_3_z*t328 - D_p_x_2_by_b_3_z*t329 + D_p_x_2_by_b_3_z*t426
        - D_p_y_2_by_b_3_z*t330 - D_p_y_2_by_b_3_z*t331 - D_p_y_2_by_b_3_z*t332 + D_p_y_2_by_b_3_z*t427
        - D_p_z_2_by_b_3_z*t333 - D_p_z_2_by_b_3_z*t334 - D_p_z_2_by_b_3_z*t335 + D_p_z_2_by_b_3_z*t428
        + mu_1_by_b_3_z*t361 + mu_2_by_b_3_z*t362 + mu_3_by_b_3_z*t363,
        D_p_x_2_by_b_3_z*k_C, D_p_y_2_by_b_3_z*k_C, D_p_z_2_by_b_3_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_z*k_C
        + k_sp_3*t510*t516*w_b_3*x_3_by_b_3_z + mu_1_by_b_3_z*t367 + mu_2_by_b_3_z*t368
        + mu_3_by_b_3_z*t369 - t282*t542 - t283*t542 - t284*t542 - t285*t543 - t286*t543 - t287*t543
        - t288*t544 - t289*t544 - t290*t544 - t546,
        t548, t549,
        D_delta_x_1_by_b_3_z*t376 + D_delta_y_1_by_b_3_z*t377 + D_delta_z_1_by_b_3_z*t378
        - D_p_x_3_by_b_3_z*t300 - D_p_x_3_by_b_3_z*t301 - D_p_x_3_by_b_3_z*t302 + D_p_x_3_by_b_3_z*t420
        - D_p_y_3_by_b_3_z*t303 - D_p_y_3_by_b_3_z*t304 - D_p_y_3_by_b_3_z*t305 + D_p_y_3_by_b_3_z*t421
        - D_p_z_3_by_b_3_z*t306 - D_p_z_3_by_b_3_z*t307 - D_p_z_3_by_b_3_z*t308 + D_p_z_3_by_b_3_z*t422
        + mu_1_by_b_3_z*t373 + mu_2_by_b_3_z*t374 + mu_3_by_b_3_z*t375,
        D_delta_x_2_by_b_3_z*t376 + D_delta_y_2_by_b_3_z*t377 + D_delta_z_2_by_b_3_z*t378
        - D_p_x_3_by_b_3_z*t315 - D_p_x_3_by_b_3_z*t316 - D_p_x_3_by_b_3_z*t317 + D_p_x_3_by_b_3_z*t423
        - D_p_y_3_by_b_3_z*t318 - D_p_y_3_by_b_3_z*t319 - D_p_y_3_by_b_3_z*t320 + D_p_y_3_by_b_3_z*t424
        - D_p_z_3_by_b_3_z*t321 - D_p_z_3_by_b_3_z*t322 - D_p_z_3_by_b_3_z*t323 + D_p_z_3_by_b_3_z*t425
        + mu_1_by_b_3_z*t379 + mu_2_by_b_3_z*t380 + mu_3_by_b_3_z*t381,
        D_delta_x_3_by_b_3_z*t376 + D_delta_y_3_by_b_3_z*t377 + D_delta_z_3_by_b_3_z*t378
        - D_p_x_3_by_b_3_z*t327 - D_p_x_3_by_b_3_z*t328 - D_p_x_3_by_b_3_z*t329 + D_p_x_3_by_b_3_z*t426
        - D_p_y_3_by_b_3_z*t330 - D_p_y_3_by_b_3_z*t331 - D_p_y_3_by_b_3_z*t332 + D_p_y_3_by_b_3_z*t427
        - D_p_z_3_by_b_3_z*t333 - D_p_z_3_by_b_3_z*t334 - D_p_z_3_by_b_3_z*t335 + D_p_z_3_by_b_3_z*t428
        + mu_1_by_b_3_z*t382 + mu_2_by_b_3_z*t383 + mu_3_by_b_3_z*t384,
        t550, D_p_x_3_by_b_3_z*k_C, D_p_y_3_by_b_3_z*k_C, D_p_z_3_by_b_3_z*k_C, t230*t547, t548, -t230*t546,
        t549,
        D_delta_x_1_by_b_3_z*t386 + D_delta_y_1_by_b_3_z*t387 + D_delta_z_1_by_b_3_z*t388
        + mu_1_by_b_3_z*t389 - mu_2_by_b_3_z*t385 - mu_3_by_b_3_z*t385,
        D_delta_x_1_by_b_3_z*t391 + D_delta_x_2_by_b_3_z*t392 + D_delta_y_1_by_b_3_z*t393
        + D_delta_y_2_by_b_3_z*t394 + D_delta_z_1_by_b_3_z*t395 + D_delta_z_2_by_b_3_z*t396
        + mu_1_by_b_3_z*t390 + mu_2_by_b_3_z*t390 + mu_3_by_b_3_z*t390,
        D_delta_x_1_by_b_3_z*t398 + D_delta_x_3_by_b_3_z*t392 + D_delta_y_1_by_b_3_z*t399
        + D_delta_y_3_by_b_3_z*t394 + D_delta_z_1_by_b_3_z*t400 + D_delta_z_3_by_b_3_z*t396
        + mu_1_by_b_3_z*t397 + mu_2_by_b_3_z*t397 + mu_3_by_b_3_z*t397,
        D_delta_x_1_by_b_3_z*k_C, D_delta_y_1_by_b_3_z*k_C, D_delta_z_1_by_b_3_z*k_C,
        D_delta_x_2_by_b_3_z*t402 + D_delta_y_2_by_b_3_z*t403 + D_delta_z_2_by_b_3_z*t404
        - mu_1_by_b_3_z*t401 + mu_2_by_b_3_z*t405 - mu_3_by_b_3_z*t401,
        D_delta_x_2_by_b_3_z*t398 + D_delta_x_3_by_b_3_z*t391 + D_delta_y_2_by_b_3_z*t399
        + D_delta_y_3_by_b_3_z*t393 + D_delta_z_2_by_b_3_z*t400 + D_delta_z_3_by_b_3_z*t395
        + mu_1_by_b_3_z*t406 + mu_2_by_b_3_z*t406 + mu_3_by_b_3_z*t406,
        D_delta_x_2_by_b_3_z*k_C, D_delta_y_2_by_b_3_z*k_C, D_delta_z_2_by_b_3_z*k_C,
        D_delta_x_3_by_b_3_z*t408 + D_delta_y_3_by_b_3_z*t409 + D_delta_z_3_by_b_3_z*t410
        - mu_1_by_b_3_z*t407 - mu_2_by_b_3_z*t407 + mu_3_by_b_3_z*t411,
        D_delta_x_3_by_b_3_z*k_C, D_delta_y_3_by_b_3_z*k_C, D_delta_z_3_by_b_3_z*k_C, t550,
        2*D_p_x_1*D_p_x_1_by_l_d_1*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_1*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_1*k_C
        + k_sp_1*t260*t269*w_b_1*x_1_by_l_d_1 + mu_1_by_l_d_1*t266 + mu_2_by_l_d_1*t267
        + mu_3_by_l_d_1*t268 - t248*t551 - t250*t551 - t251*t551 - t252*t552 - t254*t552 - t255*t552
        - t256*t553 - t258*t553 - t259*t553 - t555,
        D_p_x_1*D_p_x_2_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_2*k_C - D_p_x_1_by_l_d_1*t270
        - D_p_x_1_by_l_d_1*t271 - D_p_x_1_by_l_d_1*t272 - D_p_x_2_by_l_d_1*t248 - D_p_x_2_by_l_d_1*t250
        - D_p_x_2_by_l_d_1*t251 + D_p_y_1*D_p_y_2_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_2*k_C
        - D_p_y_1_by_l_d_1*t273 - D_p_y_1_by_l_d_1*t274 - D_p_y_1_by_l_d_1*t275 - D_p_y_2_by_l_d_1*t252
        - D_p_y_2_by_l_d_1*t254 - D_p_y_2_by_l_d_1*t255 + D_p_z_1*D_p_z_2_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_2*k_C - D_p_z_1_by_l_d_1*t276 - D_p_z_1_by_l_d_1*t277
        - D_p_z_1_by_l_d_1*t278 - D_p_z_2_by_l_d_1*t256 - D_p_z_2_by_l_d_1*t258 - D_p_z_2_by_l_d_1*t259
        + mu_1_by_l_d_1*t279 + mu_2_by_l_d_1*t280 + mu_3_by_l_d_1*t281,
        D_p_x_1*D_p_x_3_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_3*k_C - D_p_x_1_by_l_d_1*t282
        - D_p_x_1_by_l_d_1*t283 - D_p_x_1_by_l_d_1*t284 - D_p_x_3_by_l_d_1*t248 - D_p_x_3_by_l_d_1*t250
        - D_p_x_3_by_l_d_1*t251 + D_p_y_1*D_p_y_3_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_3*k_C
        - D_p_y_1_by_l_d_1*t285 - D_p_y_1_by_l_d_1*t286 - D_p_y_1_by_l_d_1*t287 - D_p_y_3_by_l_d_1*t252
        - D_p_y_3_by_l_d_1*t254 - D_p_y_3_by_l_d_1*t255 + D_p_z_1*D_p_z_3_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_3*k_C - D_p_z_1_by_l_d_1*t288 - D_p_z_1_by_l_d_1*t289
        - D_p_z_1_by_l_d_1*t290 - D_p_z_3_by_l_d_1*t256 - D_p_z_3_by_l_d_1*t258 - D_p_z_3_by_l_d_1*t259
        + mu_1_by_l_d_1*t291 + mu_2_by_l_d_1*t292 + mu_3_by_l_d_1*t293,
        t557, t558,
        D_delta_x_1_by_l_d_1*t312 + D_delta_y_1_by_l_d_1*t313 + D_delta_z_1_by_l_d_1*t314
        - D_p_x_1_by_l_d_1*t300 - D_p_x_1_by_l_d_1*t301 - D_p_x_1_by_l_d_1*t302 + D_p_x_1_by_l_d_1*t420
        - D_p_y_1_by_l_d_1*t303 - D_p_y_1_by_l_d_1*t304 - D_p_y_1_by_l_d_1*t305 + D_p_y_1_by_l_d_1*t421
        - D_p_z_1_by_l_d_1*t306 - D_p_z_1_by_l_d_1*t307 - D_p_z_1_by_l_d_1*t308 + D_p_z_1_by_l_d_1*t422
        + mu_1_by_l_d_1*t309 + mu_2_by_l_d_1*t310 + mu_3_by_l_d_1*t311,
        D_delta_x_2_by_l_d_1*t312 + D_delta_y_2_by_l_d_1*t313 + D_delta_z_2_by_l_d_1*t314
        - D_p_x_1_by_l_d_1*t315 - D_p_x_1_by_l_d_1*t316 - D_p_x_1_by_l_d_1*t317 + D_p_x_1_by_l_d_1*t423
        - D_p_y_1_by_l_d_1*t318 - D_p_y_1_by_l_d_1*t319 - D_p_y_1_by_l_d_1*t320 + D_p_y_1_by_l_d_1*t424
        - D_p_z_1_by_l_d_1*t321 - D_p_z_1_by_l_d_1*t322 - D_p_z_1_by_l_d_1*t323 + D_p_z_1_by_l_d_1*t425
        + mu_1_by_l_d_1*t324 + mu_2_by_l_d_1*t325 + mu_3_by_l_d_1*t326,
        D_delta_x_3_by_l_d_1*t312 + D_delta_y_3_by_l_d_1*t313 + D_delta_z_3_by_l_d_1*t314
        - D_p_x_1_by_l_d_1*t327 - D_p_x_1_by_l_d_1*t328 - D_p_x_1_by_l_d_1*t329 + D_p_x_1_by_l_d_1*t426
        - D_p_y_1_by_l_d_1*t330 - D_p_y_1_by_l_d_1*t331 - D_p_y_1_by_l_d_1*t332 + D_p_y_1_by_l_d_1*t427
        - D_p_z_1_by_l_d_1*t333 - D_p_z_1_by_l_d_1*t334 - D_p_z_1_by_l_d_1*t335 + D_p_z_1_by_l_d_1*t428
        + mu_1_by_l_d_1*t336 + mu_2_by_l_d_1*t337 + mu_3_by_l_d_1*t338,
        t559, D_p_x_1_by_l_d_1*k_C, D_p_y_1_by_l_d_1*k_C, D_p_z_1_by_l_d_1*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_1*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_1*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_1*k_C
        + mu_1_by_l_d_1*t343 + mu_2_by_l_d_1*t344 + mu_3_by_l_d_1*t345 - t270*t560 - t271*t560 - t272*t560
        - t273*t561 - t274*t561 - t275*t561 - t276*t562 - t277*t562 - t278*t562,
        D_p_x_2*D_p_x_3_by_l_d_1*k_C + D_p_x_2_by_l_d_1*D_p_x_3*k_C - D_p_x_2_by_l_d_1*t282
        - D_p_x_2_by_l_d_1*t283 - D_p_x_2_by_l_d_1*t284 - D_p_x_3_by_l_d_1*t270 - D_p_x_3_by_l_d_1*t271
        - D_p_x_3_by_l_d_1*t272 + D_p_y_2*D_p_y_3_by_l_d_1*k_C + D_p_y_2_by_l_d_1*D_p_y_3*k_C
        - D_p_y_2_by_l_d_1*t285 - D_p_y_2_by_l_d_1*t286 - D_p_y_2_by_l_d_1*t287 - D_p_y_3_by_l_d_1*t273
        - D_p_y_3_by_l_d_1*t274 - D_p_y_3_by_l_d_1*t275 + D_p_z_2*D_p_z_3_by_l_d_1*k_C
        + D_p_z_2_by_l_d_1*D_p_z_3*k_C - D_p_z_2_by_l_d_1*t288 - D_p_z_2_by_l_d_1*t289
        - D_p_z_2_by_l_d_1*t290 - D_p_z_3_by_l_d_1*t276 - D_p_z_3_by_l_d_1*t277 - D_p_z_3_by_l_d_1*t278
        + mu_1_by_l_d_1*t346 + mu_2_by_l_d_1*t347 + mu_3_by_l_d_1*t348,
        D_delta_x_1_by_l_d_1*t355 + D_delta_y_1_by_l_d_1*t356 + D_delta_z_1_by_l_d_1*t357
        - D_p_x_2_by_l_d_1*t300 - D_p_x_2_by_l_d_1*t301 - D_p_x_2_by_l_d_1*t302 + D_p_x_2_by_l_d_1*t420
        - D_p_y_2_by_l_d_1*t303 - D_p_y_2_by_l_d_1*t304 - D_p_y_2_by_l_d_1*t305 + D_p_y_2_by_l_d_1*t421
        - D_p_z_2_by_l_d_1*t306 - D_p_z_2_by_l_d_1*t307 - D_p_z_2_by_l_d_1*t308 + D_p_z_2_by_l_d_1*t422
        + mu_1_by_l_d_1*t352 + mu_2_by_l_d_1*t353 + mu_3_by_l_d_1*t354,
        D_delta_x_2_by_l_d_1*t355 + D_delta_y_2_by_l_d_1*t356 + D_delta_z_2_by_l_d_1*t357
        - D_p_x_2_by_l_d_1*t315 - D_p_x_2_by_l_d_1*t316 - D_p_x_2_by_l_d_1*t317 + D_p_x_2_by_l_d_1*t423
        - D_p_y_2_by_l_d_1*t318 - D_p_y_2_by_l_d_1*t319 - D_p_y_2_by_l_d_1*t320 + D_p_y_2_by_l_d_1*t424
        - D_p_z_2_by_l_d_1*t321 - D_p_z_2_by_l_d_1*t322 - D_p_z_2_by_l_d_1*t323 + D_p_z_2_by_l_d_1*t425
        + mu_1_by_l_d_1*t358 + mu_2_by_l_d_1*t359 + mu_3_by_l_d_1*t360,
        D_delta_x_3_by_l_d_1*t355 + D_delta_y_3_by_l_d_1*t356 + D_delta_z_3_by_l_d_1*t357
        - D_p_x_2_by_l_d_1*t327 - D_p_x_2_by_l_d_1*t328 - D_p_x_2_by_l_d_1*t329 + D_p_x_2_by_l_d_1*t426
        - D_p_y_2_by_l_d_1*t330 - D_p_y_2_by_l_d_1*t331 - D_p_y_2_by_l_d_1*t332 + D_p_y_2_by_l_d_1*t427
        - D_p_z_2_by_l_d_1*t333 - D_p_z_2_by_l_d_1*t334 - D_p_z_2_by_l_d_1*t335 + D_p_z_2_by_l_d_1*t428
        + mu_1_by_l_d_1*t361 + mu_2_by_l_d_1*t362 + mu_3_by_l_d_1*t363,
        D_p_x_2_by_l_d_1*k_C, D_p_y_2_by_l_d_1*k_C, D_p_z_2_by_l_d_1*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_1*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_1*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_1*k_C
        + mu_1_by_l_d_1*t367 + mu_2_by_l_d_1*t368 + mu_3_by_l_d_1*t369 - t282*t563 - t283*t563 - t284*t563
        - t285*t564 - t286*t564 - t287*t564 - t288*t565 - t289*t565 - t290*t565,
        D_delta_x_1_by_l_d_1*t376 + D_delta_y_1_by_l_d_1*t377 + D_delta_z_1_by_l_d_1*t378
        - D_p_x_3_by_l_d_1*t300 - D_p_x_3_by_l_d_1*t301 - D_p_x_3_by_l_d_1*t302 + D_p_x_3_by_l_d_1*t420
        - D_p_y_3_by_l_d_1*t303 - D_p_y_3_by_l_d_1*t304 - D_p_y_3_by_l_d_1*t305 + D_p_y_3_by_l_d_1*t421
        - D_p_z_3_by_l_d_1*t306 - D_p_z_3_by_l_d_1*t307 - D_p_z_3_by_l_d_1*t308 + D_p_z_3_by_l_d_1*t422
        + mu_1_by_l_d_1*t373 + mu_2_by_l_d_1*t374 + mu_3_by_l_d_1*t375,
        D_delta_x_2_by_l_d_1*t376 + D_delta_y_2_by_l_d_1*t377 + D_delta_z_2_by_l_d_1*t378
        - D_p_x_3_by_l_d_1*t315 - D_p_x_3_by_l_d_1*t316 - D_p_x_3_by_l_d_1*t317 + D_p_x_3_by_l_d_1*t423
        - D_p_y_3_by_l_d_1*t318 - D_p_y_3_by_l_d_1*t319 - D_p_y_3_by_l_d_1*t320 + D_p_y_3_by_l_d_1*t424
        - D_p_z_3_by_l_d_1*t321 - D_p_z_3_by_l_d_1*t322 - D_p_z_3_by_l_d_1*t323 + D_p_z_3_by_l_d_1*t425
        + mu_1_by_l_d_1*t379 + mu_2_by_l_d_1*t380 + mu_3_by_l_d_1*t381,
        D_delta_x_3_by_l_d_1*t376 + D_delta_y_3_by_l_d_1*t377 + D_delta_z_3_by_l_d_1*t378
        - D_p_x_3_by_l_d_1*t327 - D_p_x_3_by_l_d_1*t328 - D_p_x_3_by_l_d_1*t329 + D_p_x_3_by_l_d_1*t426
        - D_p_y_3_by_l_d_1*t330 - D_p_y_3_by_l_d_1*t331 - D_p_y_3_by_l_d_1*t332 + D_p_y_3_by_l_d_1*t427
        - D_p_z_3_by_l_d_1*t333 - D_p_z_3_by_l_d_1*t334 - D_p_z_3_by_l_d_1*t335 + D_p_z_3_by_l_d_1*t428
        + mu_1_by_l_d_1*t382 + mu_2_by_l_d_1*t383 + mu_3_by_l_d_1*t384,
        D_p_x_3_by_l_d_1*k_C, D_p_y_3_by_l_d_1*k_C, D_p_z_3_by_l_d_1*k_C, t185*t556, t557, -t185*t555, t558,
        D_delta_x_1_by_l_d_1*t386 + D_delta_y_1_by_l_d_1*t387 + D_delta_z_1_by_l_d_1*t388
        + mu_1_by_l_d_1*t389 - mu_2_by_l_d_1*t385 - mu_3_by_l_d_1*t385,
        D_delta_x_1_by_l_d_1*t391 + D_delta_x_2_by_l_d_1*t392 + D_delta_y_1_by_l_d_1*t393
        + D_delta_y_2_by_l_d_1*t394 + D_delta_z_1_by_l_d_1*t395 + D_delta_z_2_by_l_d_1*t396
        + mu_1_by_l_d_1*t390 + mu_2_by_l_d_1*t390 + mu_3_by_l_d_1*t390,
        D_delta_x_1_by_l_d_1*t398 + D_delta_x_3_by_l_d_1*t392 + D_delta_y_1_by_l_d_1*t399
        + D_delta_y_3_by_l_d_1*t394 + D_delta_z_1_by_l_d_1*t400 + D_delta_z_3_by_l_d_1*t396
        + mu_1_by_l_d_1*t397 + mu_2_by_l_d_1*t397 + mu_3_by_l_d_1*t397,
        D_delta_x_1_by_l_d_1*k_C, D_delta_y_1_by_l_d_1*k_C, D_delta_z_1_by_l_d_1*k_C,
        D_delta_x_2_by_l_d_1*t402 + D_delta_y_2_by_l_d_1*t403 + D_delta_z_2_by_l_d_1*t404
        - mu_1_by_l_d_1*t401 + mu_2_by_l_d_1*t405 - mu_3_by_l_d_1*t401,
        D_delta_x_2_by_l_d_1*t398 + D_delta_x_3_by_l_d_1*t391 + D_delta_y_2_by_l_d_1*t399
        + D_delta_y_3_by_l_d_1*t393 + D_delta_z_2_by_l_d_1*t400 + D_delta_z_3_by_l_d_1*t395
        + mu_1_by_l_d_1*t406 + mu_2_by_l_d_1*t406 + mu_3_by_l_d_1*t406,
        D_delta_x_2_by_l_d_1*k_C, D_delta_y_2_by_l_d_1*k_C, D_delta_z_2_by_l_d_1*k_C,
        D_delta_x_3_by_l_d_1*t408 + D_delta_y_3_by_l_d_1*t409 + D_delta_z_3_by_l_d_1*t410
        - mu_1_by_l_d_1*t407 - mu_2_by_l_d_1*t407 + mu_3_by_l_d_1*t411,
        D_delta_x_3_by_l_d_1*k_C, D_delta_y_3_by_l_d_1*k_C, D_delta_z_3_by_l_d_1*k_C, t559,
        2*D_p_x_1*D_p_x_1_by_l_d_2*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_2*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_2*k_C
        + mu_1_by_l_d_2*t266 + mu_2_by_l_d_2*t267 + mu_3_by_l_d_2*t268 - t248*t566 - t250*t566 - t251*t566
        - t252*t567 - t254*t567 - t255*t567 - t256*t568 - t258*t568 - t259*t568,
        D_p_x_1*D_p_x_2_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_2*k_C - D_p_x_1_by_l_d_2*t270
        - D_p_x_1_by_l_d_2*t271 - D_p_x_1_by_l_d_2*t272 - D_p_x_2_by_l_d_2*t248 - D_p_x_2_by_l_d_2*t250
        - D_p_x_2_by_l_d_2*t251 + D_p_y_1*D_p_y_2_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_2*k_C
        - D_p_y_1_by_l_d_2*t273 - D_p_y_1_by_l_d_2*t274 - D_p_y_1_by_l_d_2*t275 - D_p_y_2_by_l_d_2*t252
        - D_p_y_2_by_l_d_2*t254 - D_p_y_2_by_l_d_2*t255 + D_p_z_1*D_p_z_2_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_2*k_C - D_p_z_1_by_l_d_2*t276 - D_p_z_1_by_l_d_2*t277
        - D_p_z_1_by_l_d_2*t278 - D_p_z_2_by_l_d_2*t256 - D_p_z_2_by_l_d_2*t258 - D_p_z_2_by_l_d_2*t259
        + mu_1_by_l_d_2*t279 + mu_2_by_l_d_2*t280 + mu_3_by_l_d_2*t281,
        D_p_x_1*D_p_x_3_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_3*k_C - D_p_x_1_by_l_d_2*t282
        - D_p_x_1_by_l_d_2*t283 - D_p_x_1_by_l_d_2*t284 - D_p_x_3_by_l_d_2*t248 - D_p_x_3_by_l_d_2*t250
        - D_p_x_3_by_l_d_2*t251 + D_p_y_1*D_p_y_3_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_3*k_C
        - D_p_y_1_by_l_d_2*t285 - D_p_y_1_by_l_d_2*t286 - D_p_y_1_by_l_d_2*t287 - D_p_y_3_by_l_d_2*t252
        - D_p_y_3_by_l_d_2*t254 - D_p_y_3_by_l_d_2*t255 + D_p_z_1*D_p_z_3_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_3*k_C - D_p_z_1_by_l_d_2*t288 - D_p_z_1_by_l_d_2*t289
        - D_p_z_1_by_l_d_2*t290 - D_p_z_3_by_l_d_2*t256 - D_p_z_3_by_l_d_2*t258 - D_p_z_3_by_l_d_2*t259
        + mu_1_by_l_d_2*t291 + mu_2_by_l_d_2*t292 + mu_3_by_l_d_2*t293,
        D_delta_x_1_by_l_d_2*t312 + D_delta_y_1_by_l_d_2*t313 + D_delta_z_1_by_l_d_2*t314
        - D_p_x_1_by_l_d_2*t300 - D_p_x_1_by_l_d_2*t301 - D_p_x_1_by_l_d_2*t302 + D_p_x_1_by_l_d_2*t420
        - D_p_y_1_by_l_d_2*t303 - D_p_y_1_by_l_d_2*t304 - D_p_y_1_by_l_d_2*t305 + D_p_y_1_by_l_d_2*t421
        - D_p_z_1_by_l_d_2*t306 - D_p_z_1_by_l_d_2*t307 - D_p_z_1_by_l_d_2*t308 + D_p_z_1_by_l_d_2*t422
        + mu_1_by_l_d_2*t309 + mu_2_by_l_d_2*t310 + mu_3_by_l_d_2*t311,
        D_delta_x_2_by_l_d_2*t312 + D_delta_y_2_by_l_d_2*t313 + D_delta_z_2_by_l_d_2*t314
        - D_p_x_1_by_l_d_2*t315 - D_p_x_1_by_l_d_2*t316 - D_p_x_1_by_l_d_2*t317 + D_p_x_1_by_l_d_2*t423
        - D_p_y_1_by_l_d_2*t318 - D_p_y_1_by_l_d_2*t319 - D_p_y_1_by_l_d_2*t320 + D_p_y_1_by_l_d_2*t424
        - D_p_z_1_by_l_d_2*t321 - D_p_z_1_by_l_d_2*t322 - D_p_z_1_by_l_d_2*t323 + D_p_z_1_by_l_d_2*t425
        + mu_1_by_l_d_2*t324 + mu_2_by_l_d_2*t325 + mu_3_by_l_d_2*t326,
        D_delta_x_3_by_l_d_2*t312 + D_delta_y_3_by_l_d_2*t313 + D_delta_z_3_by_l_d_2*t314
        - D_p_x_1_by_l_d_2*t327 - D_p_x_1_by_l_d_2*t328 - D_p_x_1_by_l_d_2*t329 + D_p_x_1_by_l_d_2*t426
        - D_p_y_1_by_l_d_2*t330 - D_p_y_1_by_l_d_2*t331 - D_p_y_1_by_l_d_2*t332 + D_p_y_1_by_l_d_2*t427
        - D_p_z_1_by_l_d_2*t333 - D_p_z_1_by_l_d_2*t334 - D_p_z_1_by_l_d_2*t335 + D_p_z_1_by_l_d_2*t428
        + mu_1_by_l_d_2*t336 + mu_2_by_l_d_2*t337 + mu_3_by_l_d_2*t338,
        D_p_x_1_by_l_d_2*k_C, D_p_y_1_by_l_d_2*k_C, D_p_z_1_by_l_d_2*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_2*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_2*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_2*k_C
        + k_sp_2*t457*t463*w_b_2*x_2_by_l_d_2 + mu_1_by_l_d_2*t343 + mu_2_by_l_d_2*t344
        + mu_3_by_l_d_2*t345 - t270*t569 - t271*t569 - t272*t569 - t273*t570 - t274*t570 - t275*t570
        - t276*t571 - t277*t571 - t278*t571 - t573,
        D_p_x_2*D_p_x_3_by_l_d_2*k_C + D_p_x_2_by_l_d_2*D_p_x_3*k_C - D_p_x_2_by_l_d_2*t282
        - D_p_x_2_by_l_d_2*t283 - D_p_x_2_by_l_d_2*t284 - D_p_x_3_by_l_d_2*t270 - D_p_x_3_by_l_d_2*t271
        - D_p_x_3_by_l_d_2*t272 + D_p_y_2*D_p_y_3_by_l_d_2*k_C + D_p_y_2_by_l_d_2*D_p_y_3*k_C
        - D_p_y_2_by_l_d_2*t285 - D_p_y_2_by_l_d_2*t286 - D_p_y_2_by_l_d_2*t287 - D_p_y_3_by_l_d_2*t273
        - D_p_y_3_by_l_d_2*t274 - D_p_y_3_by_l_d_2*t275 + D_p_z_2*D_p_z_3_by_l_d_2*k_C
        + D_p_z_2_by_l_d_2*D_p_z_3*k_C - D_p_z_2_by_l_d_2*t288 - D_p_z_2_by_l_d_2*t289
        - D_p_z_2_by_l_d_2*t290 - D_p_z_3_by_l_d_2*t276 - D_p_z_3_by_l_d_2*t277 - D_p_z_3_by_l_d_2*t278
        + mu_1_by_l_d_2*t346 + mu_2_by_l_d_2*t347 + mu_3_by_l_d_2*t348,
        t575, t576,
        D_delta_x_1_by_l_d_2*t355 + D_delta_y_1_by_l_d_2*t356 + D_delta_z_1_by_l_d_2*t357
        - D_p_x_2_by_l_d_2*t300 - D_p_x_2_by_l_d_2*t301 - D_p_x_2_by_l_d_2*t302 + D_p_x_2_by_l_d_2*t420
        - D_p_y_2_by_l_d_2*t303 - D_p_y_2_by_l_d_2*t304 - D_p_y_2_by_l_d_2*t305 + D_p_y_2_by_l_d_2*t421
        - D_p_z_2_by_l_d_2*t306 - D_p_z_2_by_l_d_2*t307 - D_p_z_2_by_l_d_2*t308 + D_p_z_2_by_l_d_2*t422
        + mu_1_by_l_d_2*t352 + mu_2_by_l_d_2*t353 + mu_3_by_l_d_2*t354,
        D_delta_x_2_by_l_d_2*t355 + D_delta_y_2_by_l_d_2*t356 + D_delta_z_2_by_l_d_2*t357
        - D_p_x_2_by_l_d_2*t315 - D_p_x_2_by_l_d_2*t316 - D_p_x_2_by_l_d_2*t317 + D_p_x_2_by_l_d_2*t423
        - D_p_y_2_by_l_d_2*t318 - D_p_y_2_by_l_d_2*t319 - D_p_y_2_by_l_d_2*t320 + D_p_y_2_by_l_d_2*t424
        - D_p_z_2_by_l_d_2*t321 - D_p_z_2_by_l_d_2*t322 - D_p_z_2_by_l_d_2*t323 + D_p_z_2_by_l_d_2*t425
        + mu_1_by_l_d_2*t358 + mu_2_by_l_d_2*t359 + mu_3_by_l_d_2*t360,
        D_delta_x_3_by_l_d_2*t355 + D_delta_y_3_by_l_d_2*t356 + D_delta_z_3_by_l_d_2*t357
        - D_p_x_2_by_l_d_2*t327 - D_p_x_2_by_l_d_2*t328 - D_p_x_2_by_l_d_2*t329 + D_p_x_2_by_l_d_2*t426
        - D_p_y_2_by_l_d_2*t330 - D_p_y_2_by_l_d_2*t331 - D_p_y_2_by_l_d_2*t332 + D_p_y_2_by_l_d_2*t427
        - D_p_z_2_by_l_d_2*t333 - D_p_z_2_by_l_d_2*t334 - D_p_z_2_by_l_d_2*t335 + D_p_z_2_by_l_d_2*t428
        + mu_1_by_l_d_2*t361 + mu_2_by_l_d_2*t362 + mu_3_by_l_d_2*t363,
        t577, D_p_x_2_by_l_d_2*k_C, D_p_y_2_by_l_d_2*k_C, D_p_z_2_by_l_d_2*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_2*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_2*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_2*k_C
        + mu_1_by_l_d_2*t367 + mu_2_by_l_d_2*t368 + mu_3_by_l_d_2*t369 - t282*t578 - t283*t578 - t284*t578
        - t285*t579 - t286*t579 - t287*t579 - t288*t580 - t289*t580 - t290*t580,
        D_delta_x_1_by_l_d_2*t376 + D_delta_y_1_by_l_d_2*t377 + D_delta_z_1_by_l_d_2*t378
        - D_p_x_3_by_l_d_2*t300 - D_p_x_3_by_l_d_2*t301 - D_p_x_3_by_l_d_2*t302 + D_p_x_3_by_l_d_2*t420
        - D_p_y_3_by_l_d_2*t303 - D_p_y_3_by_l_d_2*t304 - D_p_y_3_by_l_d_2*t305 + D_p_y_3_by_l_d_2*t421
        - D_p_z_3_by_l_d_2*t306 - D_p_z_3_by_l_d_2*t307 - D_p_z_3_by_l_d_2*t308 + D_p_z_3_by_l_d_2*t422
        + mu_1_by_l_d_2*t373 + mu_2_by_l_d_2*t374 + mu_3_by_l_d_2*t375,
        D_delta_x_2_by_l_d_2*t376 + D_delta_y_2_by_l_d_2*t377 + D_delta_z_2_by_l_d_2*t378
        - D_p_x_3_by_l_d_2*t315 - D_p_x_3_by_l_d_2*t316 - D_p_x_3_by_l_d_2*t317 + D_p_x_3_by_l_d_2*t423
        - D_p_y_3_by_l_d_2*t318 - D_p_y_3_by_l_d_2*t319 - D_p_y_3_by_l_d_2*t320 + D_p_y_3_by_l_d_2*t424
        - D_p_z_3_by_l_d_2*t321 - D_p_z_3_by_l_d_2*t322 - D_p_z_3_by_l_d_2*t323 + D_p_z_3_by_l_d_2*t425
        + mu_1_by_l_d_2*t379 + mu_2_by_l_d_2*t380 + mu_3_by_l_d_2*t381,
        D_delta_x_3_by_l_d_2*t376 + D_delta_y_3_by_l_d_2*t377 + D_delta_z_3_by_l_d_2*t378
        - D_p_x_3_by_l_d_2*t327 - D_p_x_3_by_l_d_2*t328 - D_p_x_3_by_l_d_2*t329 + D_p_x_3_by_l_d_2*t426
        - D_p_y_3_by_l_d_2*t330 - D_p_y_3_by_l_d_2*t331 - D_p_y_3_by_l_d_2*t332 + D_p_y_3_by_l_d_2*t427
        - D_p_z_3_by_l_d_2*t333 - D_p_z_3_by_l_d_2*t334 - D_p_z_3_by_l_d_2*t335 + D_p_z_3_by_l_d_2*t428
        + mu_1_by_l_d_2*t382 + mu_2_by_l_d_2*t383 + mu_3_by_l_d_2*t384,
        D_p_x_3_by_l_d_2*k_C, D_p_y_3_by_l_d_2*k_C, D_p_z_3_by_l_d_2*k_C, t218*t574, t575, -t218*t573, t576,
        D_delta_x_1_by_l_d_2*t386 + D_delta_y_1_by_l_d_2*t387 + D_delta_z_1_by_l_d_2*t388
        + mu_1_by_l_d_2*t389 - mu_2_by_l_d_2*t385 - mu_3_by_l_d_2*t385,
        D_delta_x_1_by_l_d_2*t391 + D_delta_x_2_by_l_d_2*t392 + D_delta_y_1_by_l_d_2*t393
        + D_delta_y_2_by_l_d_2*t394 + D_delta_z_1_by_l_d_2*t395 + D_delta_z_2_by_l_d_2*t396
        + mu_1_by_l_d_2*t390 + mu_2_by_l_d_2*t390 + mu_3_by_l_d_2*t390,
        D_delta_x_1_by_l_d_2*t398 + D_delta_x_3_by_l_d_2*t392 + D_delta_y_1_by_l_d_2*t399
        + D_delta_y_3_by_l_d_2*t394 + D_delta_z_1_by_l_d_2*t400 + D_delta_z_3_by_l_d_2*t396
        + mu_1_by_l_d_2*t397 + mu_2_by_l_d_2*t397 + mu_3_by_l_d_2*t397,
        D_delta_x_1_by_l_d_2*k_C, D_delta_y_1_by_l_d_2*k_C, D_delta_z_1_by_l_d_2*k_C,
        D_delta_x_2_by_l_d_2*t402 + D_delta_y_2_by_l_d_2*t403 + D_delta_z_2_by_l_d_2*t404
        - mu_1_by_l_d_2*t401 + mu_2_by_l_d_2*t405 - mu_3_by_l_d_2*t401,
        D_delta_x_2_by_l_d_2*t398 + D_delta_x_3_by_l_d_2*t391 + D_delta_y_2_by_l_d_2*t399
        + D_delta_y_3_by_l_d_2*t393 + D_delta_z_2_by_l_d_2*t400 + D_delta_z_3_by_l_d_2*t395
        + mu_1_by_l_d_2*t406 + mu_2_by_l_d_2*t406 + mu_3_by_l_d_2*t406,
        D_delta_x_2_by_l_d_2*k_C, D_delta_y_2_by_l_d_2*k_C, D_delta_z_2_by_l_d_2*k_C,
        D_delta_x_3_by_l_d_2*t408 + D_delta_y_3_by_l_d_2*t409 + D_delta_z_3_by_l_d_2*t410
        - mu_1_by_l_d_2*t407 - mu_2_by_l_d_2*t407 + mu_3_by_l_d_2*t411,
        D_delta_x_3_by_l_d_2*k_C, D_delta_y_3_by_l_d_2*k_C, D_delta_z_3_by_l_d_2*k_C, t577,
        2*D_p_x_1*D_p_x_1_by_l_d_3*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_3*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_3*k_C
        + mu_1_by_l_d_3*t266 + mu_2_by_l_d_3*t267 + mu_3_by_l_d_3*t268 - t248*t581 - t250*t581 - t251*t581
        - t252*t582 - t254*t582 - t255*t582 - t256*t583 - t258*t583 - t259*t583,
        D_p_x_1*D_p_x_2_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_2*k_C - D_p_x_1_by_l_d_3*t270
        - D_p_x_1_by_l_d_3*t271 - D_p_x_1_by_l_d_3*t272 - D_p_x_2_by_l_d_3*t248 - D_p_x_2_by_l_d_3*t250
        - D_p_x_2_by_l_d_3*t251 + D_p_y_1*D_p_y_2_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_2*k_C
        - D_p_y_1_by_l_d_3*t273 - D_p_y_1_by_l_d_3*t274 - D_p_y_1_by_l_d_3*t275 - D_p_y_2_by_l_d_3*t252
        - D_p_y_2_by_l_d_3*t254 - D_p_y_2_by_l_d_3*t255 + D_p_z_1*D_p_z_2_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_2*k_C - D_p_z_1_by_l_d_3*t276 - D_p_z_1_by_l_d_3*t277
        - D_p_z_1_by_l_d_3*t278 - D_p_z_2_by_l_d_3*t256 - D_p_z_2_by_l_d_3*t258 - D_p_z_2_by_l_d_3*t259
        + mu_1_by_l_d_3*t279 + mu_2_by_l_d_3*t280 + mu_3_by_l_d_3*t281,
        D_p_x_1*D_p_x_3_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_3*k_C - D_p_x_1_by_l_d_3*t282
        - D_p_x_1_by_l_d_3*t283 - D_p_x_1_by_l_d_3*t284 - D_p_x_3_by_l_d_3*t248 - D_p_x_3_by_l_d_3*t250
        - D_p_x_3_by_l_d_3*t251 + D_p_y_1*D_p_y_3_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_3*k_C
        - D_p_y_1_by_l_d_3*t285 - D_p_y_1_by_l_d_3*t286 - D_p_y_1_by_l_d_3*t287 - D_p_y_3_by_l_d_3*t252
        - D_p_y_3_by_l_d_3*t254 - D_p_y_3_by_l_d_3*t255 + D_p_z_1*D_p_z_3_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_3*k_C - D_p_z_1_by_l_d_3*t288 - D_p_z_1_by_l_d_3*t289
        - D_p_z_1_by_l_d_3*t290 - D_p_z_3_by_l_d_3*t256 - D_p_z_3_by_l_d_3*t258 - D_p_z_3_by_l_d_3*t259
        + mu_1_by_l_d_3*t291 + mu_2_by_l_d_3*t292 + mu_3_by_l_d_3*t293,
        D_delta_x_1_by_l_d_3*t312 + D_delta_y_1_by_l_d_3*t313 + D_delta_z_1_by_l_d_3*t314
        - D_p_x_1_by_l_d_3*t300 - D_p_x_1_by_l_d_3*t301 - D_p_x_1_by_l_d_3*t302 + D_p_x_1_by_l_d_3*t420
        - D_p_y_1_by_l_d_3*t303 - D_p_y_1_by_l_d_3*t304 - D_p_y_1_by_l_d_3*t305 + D_p_y_1_by_l_d_3*t421
        - D_p_z_1_by_l_d_3*t306 - D_p_z_1_by_l_d_3*t307 - D_p_z_1_by_l_d_3*t308 + D_p_z_1_by_l_d_3*t422
        + mu_1_by_l_d_3*t309 + mu_2_by_l_d_3*t310 + mu_3_by_l_d_3*t311,
        D_delta_x_2_by_l_d_3*t312 + D_delta_y_2_by_l_d_3*t313 + D_delta_z_2_by_l_d_3*t314
        - D_p_x_1_by_l_d_3*t315 - D_p_x_1_by_l_d_3*t316 - D_p_x_1_by_l_d_3*t317 + D_p_x_1_by_l_d_3*t423
        - D_p_y_1_by_l_d_3*t318 - D_p_y_1_by_l_d_3*t319 - D_p_y_1_by_l_d_3*t320 + D_p_y_1_by_l_d_3*t424
        - D_p_z_1_by_l_d_3*t321 - D_p_z_1_by_l_d_3*t322 - D_p_z_1_by_l_d_3*t323 + D_p_z_1_by_l_d_3*t425
        + mu_1_by_l_d_3*t324 + mu_2_by_l_d_3*t325 + mu_3_by_l_d_3*t326,
        D_delta_x_3_by_l_d_3*t312 + D_delta_y_3_by_l_d_3*t313 + D_delta_z_3_by_l_d_3*t314
        - D_p_x_1_by_l_d_3*t327 - D_p_x_1_by_l_d_3*t328 - D_p_x_1_by_l_d_3*t329 + D_p_x_1_by_l_d_3*t426
        - D_p_y_1_by_l_d_3*t330 - D_p_y_1_by_l_d_3*t331 - D_p_y_1_by_l_d_3*t332 + D_p_y_1_by_l_d_3*t427
        - D_p_z_1_by_l_d_3*t333 - D_p_z_1_by_l_d_3*t334 - D_p_z_1_by_l_d_3*t335 + D_p_z_1_by_l_d_3*t428
        + mu_1_by_l_d_3*t336 + mu_2_by_l_d_3*t337 + mu_3_by_l_d_3*t338,
        D_p_x_1_by_l_d_3*k_C, D_p_y_1_by_l_d_3*k_C, D_p_z_1_by_l_d_3*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_3*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_3*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_3*k_C
        + mu_1_by_l_d_3*t343 + mu_2_by_l_d_3*t344 + mu_3_by_l_d_3*t345 - t270*t584 - t271*t584 - t272*t584
        - t273*t585 - t274*t585 - t275*t585 - t276*t586 - t277*t586 - t278*t586,
        D_p_x_2*D_p_x_3_by_l_d_3*k_C + D_p_x_2_by_l_d_3*D_p_x_3*k_C - D_p_x_2_by_l_d_3*t282
        - D_p_x_2_by_l_d_3*t283 - D_p_x_2_by_l_d_3*t284 - D_p_x_3_by_l_d_3*t270 - D_p_x_3_by_l_d_3*t271
        - D_p_x_3_by_l_d_3*t272 + D_p_y_2*D_p_y_3_by_l_d_3*k_C + D_p_y_2_by_l_d_3*D_p_y_3*k_C
        - D_p_y_2_by_l_d_3*t285 - D_p_y_2_by_l_d_3*t286 - D_p_y_2_by_l_d_3*t287 - D_p_y_3_by_l_d_3*t273
        - D_p_y_3_by_l_d_3*t274 - D_p_y_3_by_l_d_3*t275 + D_p_z_2*D_p_z_3_by_l_d_3*k_C
        + D_p_z_2_by_l_d_3*D_p_z_3*k_C - D_p_z_2_by_l_d_3*t288 - D_p_z_2_by_l_d_3*t289
        - D_p_z_2_by_l_d_3*t290 - D_p_z_3_by_l_d_3*t276 - D_p_z_3_by_l_d_3*t277 - D_p_z_3_by_l_d_3*t278
        + mu_1_by_l_d_3*t346 + mu_2_by_l_d_3*t347 + mu_3_by_l_d_3*t348,
        D_delta_x_1_by_l_d_3*t355 + D_delta_y_1_by_l_d_3*t356 + D_delta_z_1_by_l_d_3*t357
        - D_p_x_2_by_l_d_3*t300 - D_p_x_2_by_l_d_3*t301 - D_p_x_2_by_l_d_3*t302 + D_p_x_2_by_l_d_3*t420
        - D_p_y_2_by_l_d_3*t303 - D_p_y_2_by_l_d_3*t304 - D_p_y_2_by_l_d_3*t305 + D_p_y_2_by_l_d_3*t421
        - D_p_z_2_by_l_d_3*t306 - D_p_z_2_by_l_d_3*t307 - D_p_z_2_by_l_d_3*t308 + D_p_z_2_by_l_d_3*t422
        + mu_1_by_l_d_3*t352 + mu_2_by_l_d_3*t353 + mu_3_by_l_d_3*t354,
        D_delta_x_2_by_l_d_3*t355 + D_delta_y_2_by_l_d_3*t356 + D_delta_z_2_by_l_d_3*t357
        - D_p_x_2_by_l_d_3*t315 - D_p_x_2_by_l_d_3*t316 - D_p_x_2_by_l_d_3*t317 + D_p_x_2_by_l_d_3*t423
        - D_p_y_2_by_l_d_3*t318 - D_p_y_2_by_l_d_3*t319 - D_p_y_2_by_l_d_3*t320 + D_p_y_2_by_l_d_3*t424
        - D_p_z_2_by_l_d_3*t321 - D_p_z_2_by_l_d_3*t322 - D_p_z_2_by_l_d_3*t323 + D_p_z_2_by_l_d_3*t425
        + mu_1_by_l_d_3*t358 + mu_2_by_l_d_3*t359 + mu_3_by_l_d_3*t360,
        D_delta_x_3_by_l_d_3*t355 + D_delta_y_3_by_l_d_3*t356 + D_delta_z_3_by_l_d_3*t357
        - D_p_x_2_by_l_d_3*t327 - D_p_x_2_by_l_d_3*t328 - D_p_x_2_by_l_d_3*t329 + D_p_x_2_by_l_d_3*t426
        - D_p_y_2_by_l_d_3*t330 - D_p_y_2_by_l_d_3*t331 - D_p_y_2_by_l_d_3*t332 + D_p_y_2_by_l_d_3*t427
        - D_p_z_2_by_l_d_3*t333 - D_p_z_2_by_l_d_3*t334 - D_p_z_2_by_l_d_3*t335 + D_p_z_2_by_l_d_3*t428
        + mu_1_by_l_d_3*t361 + mu_2_by_l_d_3*t362 + mu_3_by_l_d_3*t363,
        D_p_x_2_by_l_d_3*k_C, D_p_y_2_by_l_d_3*k_C, D_p_z_2_by_l_d_3*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_3*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_3*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_3*k_C
        + k_sp_3*t510*t516*w_b_3*x_3_by_l_d_3 + mu_1_by_l_d_3*t367 + mu_2_by_l_d_3*t368
        + mu_3_by_l_d_3*t369 - t282*t587 - t283*t587 - t284*t587 - t285*t588 - t286*t588 - t287*t588
        - t288*t589 - t289*t589 - t290*t589 - t591,
        t593, t594,
        D_delta_x_1_by_l_d_3*t376 + D_delta_y_1_by_l_d_3*t377 + D_delta_z_1_by_l_d_3*t378
        - D_p_x_3_by_l_d_3*t300 - D_p_x_3_by_l_d_3*t301 - D_p_x_3_by_l_d_3*t302 + D_p_x_3_by_l_d_3*t420
        - D_p_y_3_by_l_d_3*t303 - D_p_y_3_by_l_d_3*t304 - D_p_y_3_by_l_d_3*t305 + D_p_y_3_by_l_d_3*t421
        - D_p_z_3_by_l_d_3*t306 - D_p_z_3_by_l_d_3*t307 - D_p_z_3_by_l_d_3*t308 + D_p_z_3_by_l_d_3*t422
        + mu_1_by_l_d_3*t373 + mu_2_by_l_d_3*t374 + mu_3_by_l_d_3*t375,
        D_delta_x_2_by_l_d_3*t376 + D_delta_y_2_by_l_d_3*t377 + D_delta_z_2_by_l_d_3*t378
        - D_p_x_3_by_l_d_3*t315 - D_p_x_3_by_l_d_3*t316 - D_p_x_3_by_l_d_3*t317 + D_p_x_3_by_l_d_3*t423
        - D_p_y_3_by_l_d_3*t318 - D_p_y_3_by_l_d_3*t319 - D_p_y_3_by_l_d_3*t320 + D_p_y_3_by_l_d_3*t424
        - D_p_z_3_by_l_d_3*t321 - D_p_z_3_by_l_d_3*t322 - D_p_z_3_by_l_d_3*t323 + D_p_z_3_by_l_d_3*t425
        + mu_1_by_l_d_3*t379 + mu_2_by_l_d_3*t380 + mu_3_by_l_d_3*t381,
        D_delta_x_3_by_l_d_3*t376 + D_delta_y_3_by_l_d_3*t377 + D_delta_z_3_by_l_d_3*t378
        - D_p_x_3_by_l_d_3*t327 - D_p_x_3_by_l_d_3*t328 - D_p_x_3_by_l_d_3*t329 + D_p_x_3_by_l_d_3*t426
        - D_p_y_3_by_l_d_3*t330 - D_p_y_3_by_l_d_3*t331 - D_p_y_3_by_l_d_3*t332 + D_p_y_3_by_l_d_3*t427
        - D_p_z_3_by_l_d_3*t333 - D_p_z_3_by_l_d_3*t334 - D_p_z_3_by_l_d_3*t335 + D_p_z_3_by_l_d_3*t428
        + mu_1_by_l_d_3*t382 + mu_2_by_l_d_3*t383 + mu_3_by_l_d_3*t384,
        t595, D_p_x_3_by_l_d_3*k_C, D_p_y_3_by_l_d_3*k_C, D_p_z_3_by_l_d_3*k_C, t230*t592, t593, -t230*t591,
        t594,
        D_delta_x_1_by_l_d_3*t386 + D_delta_y_1_by_l_d_3*t387 + D_delta_z_1_by_l_d_3*t388
        + mu_1_by_l_d_3*t389 - mu_2_by_l_d_3*t385 - mu_3_by_l_d_3*t385,
        D_delta_x_1_by_l_d_3*t391 + D_delta_x_2_by_l_d_3*t392 + D_delta_y_1_by_l_d_3*t393
        + D_delta_y_2_by_l_d_3*t394 + D_delta_z_1_by_l_d_3*t395 + D_delta_z_2_by_l_d_3*t396
        + mu_1_by_l_d_3*t390 + mu_2_by_l_d_3*t390 + mu_3_by_l_d_3*t390,
        D_delta_x_1_by_l_d_3*t398 + D_delta_x_3_by_l_d_3*t392 + D_delta_y_1_by_l_d_3*t399
        + D_delta_y_3_by_l_d_3*t394 + D_delta_z_1_by_l_d_3*t400 + D_delta_z_3_by_l_d_3*t396
        + mu_1_by_l_d_3*t397 + mu_2_by_l_d_3*t397 + mu_3_by_l_d_3*t397,
        D_delta_x_1_by_l_d_3*k_C, D_delta_y_1_by_l_d_3*k_C, D_delta_z_1_by_l_d_3*k_C,
        D_delta_x_2_by_l_d_3*t402 + D_delta_y_2_by_l_d_3*t403 + D_delta_z_2_by_l_d_3*t404
        - mu_1_by_l_d_3*t401 + mu_2_by_l_d_3*t405 - mu_3_by_l_d_3*t401,
        D_delta_x_2_by_l_d_3*t398 + D_delta_x_3_by_l_d_3*t391 + D_delta_y_2_by_l_d_3*t399
        + D_delta_y_3_by_l_d_3*t393 + D_delta_z_2_by_l_d_3*t400 + D_delta_z_3_by_l_d_3*t395
        + mu_1_by_l_d_3*t406 + mu_2_by_l_d_3*t406 + mu_3_by_l_d_3*t406,
        D_delta_x_2_by_l_d_3*k_C, D_delta_y_2_by_l_d_3*k_C, D_delta_z_2_by_l_d_3*k_C,
        D_delta_x_3_by_l_d_3*t408 + D_delta_y_3_by_l_d_3*t409 + D_delta_z_3_by_l_d_3*t410
        - mu_1_by_l_d_3*t407 - mu_2_by_l_d_3*t407 + mu_3_by_l_d_3*t411,
        D_delta_x_3_by_l_d_3*k_C, D_delta_y_3_by_l_d_3*k_C, D_delta_z_3_by_l_d_3*k_C, t595,
    ))
    return M_theta_out, K_theta_out
