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
* l_f_j_k [m]: free length of span k of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
    carriage to pulley 1)
* k_j_k [N/m]: stiffness of span k of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
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
"""

from math import prod
from typing import NamedTuple

import numpy as np

__all__ = [
    "COORDINATES",
    "COORDINATE_UNITS",
    "Effects",
    "EFFECTS",
    "SENSITIVITIES",
    "extended_matrices",
    "extended_platform_motion",
    "extended_sensitivities",
    "extended_static_equilibrium",
    "joint_stiffness",
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
SENSITIVITIES = (
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


def extended_sensitivities(p, parameters, effects):
    """Derivatives of M and K by every parameter, at a fixed platform pose.

    The entries of the upper triangles that SENSITIVITIES lists, all others being zero; by a rail's origin,
    the opposite of those by its joint.

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
    M_theta : array, shape (..., 942) [unit of M by that of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 996) [unit of K by that of the parameter]
        dK/dtheta.

    Notes
    -----
    Implicit function theorem and chain rule; the carriages follow the parameter.
    15123 operations; 70071909 with every named value written out.
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
    (k_C,) = _entries(effects.cable_stiffness_stiffness, ())
    (m_L,) = _entries(effects.payload_mass, ())
    batch, dtype = _batch(p_x, m_p, g_x, o_1_x, n_1_x, b_1_x, l_d_1, m_d_1, l_t_1, k_sp_1, w_b_1, R_p_1,
        I_m_1, i_g_1, d_1_1, x_min_1, sigma_1, a_B_1, a_B_2, a_B_3, c_E, rho_b, k_C, m_L)
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
    t44 = m_L + m_p
    t45 = (1/2)*m_d_1 + (1/2)*m_d_2 + (1/2)*m_d_3 + t44
    t46 = A_x_1*g_x
    t47 = A_y_1*g_y
    t48 = A_z_1*g_z
    mu_1 = t1*(-t45*t46 - t45*t47 - t45*t48)
    t49 = A_x_2*g_x
    t50 = A_y_2*g_y
    t51 = A_z_2*g_z
    mu_2 = t1*(-t45*t49 - t45*t50 - t45*t51)
    t52 = A_x_3*g_x
    t53 = A_y_3*g_y
    t54 = A_z_3*g_z
    mu_3 = t1*(-t45*t52 - t45*t53 - t45*t54)
    mu_1_by_m_p = t1*(-t46 - t47 - t48)
    mu_2_by_m_p = t1*(-t49 - t50 - t51)
    mu_3_by_m_p = t1*(-t52 - t53 - t54)
    mu_1_by_g_x = -t2*t45
    mu_2_by_g_x = -t3*t45
    mu_3_by_g_x = -t4*t45
    mu_1_by_g_y = -t45*t5
    mu_2_by_g_y = -t45*t6
    mu_3_by_g_y = -t45*t7
    mu_1_by_g_z = -t45*t8
    mu_2_by_g_z = -t45*t9
    mu_3_by_g_z = -t10*t45
    t55 = 1.0/D_r_1
    x_1_by_b_1_x = s_1_x*t55
    s_1_x_by_b_1_x = -n_1_x*x_1_by_b_1_x + 1
    s_1_y_by_b_1_x = -n_1_y*x_1_by_b_1_x
    s_1_z_by_b_1_x = -n_1_z*x_1_by_b_1_x
    t56 = n_1_y**2
    t57 = n_1_z**2
    t58 = (
        -D_p_x_1*s_1_x_by_b_1_x - D_p_y_1*s_1_y_by_b_1_x - D_p_z_1*s_1_z_by_b_1_x + n_1_x*s_1_x_by_b_1_x
        - t56*x_1_by_b_1_x - t57*x_1_by_b_1_x
    )
    D_p_x_1_by_b_1_x = t2*t58
    D_p_y_1_by_b_1_x = t5*t58
    D_p_z_1_by_b_1_x = t58*t8
    t59 = -D_p_x_2*s_1_x_by_b_1_x - D_p_y_2*s_1_y_by_b_1_x - D_p_z_2*s_1_z_by_b_1_x
    D_p_x_2_by_b_1_x = t2*t59
    D_p_y_2_by_b_1_x = t5*t59
    D_p_z_2_by_b_1_x = t59*t8
    t60 = -D_p_x_3*s_1_x_by_b_1_x - D_p_y_3*s_1_y_by_b_1_x - D_p_z_3*s_1_z_by_b_1_x
    D_p_x_3_by_b_1_x = t2*t60
    D_p_y_3_by_b_1_x = t5*t60
    D_p_z_3_by_b_1_x = t60*t8
    t61 = -D_delta_x_1*s_1_x_by_b_1_x - D_delta_y_1*s_1_y_by_b_1_x - D_delta_z_1*s_1_z_by_b_1_x
    D_delta_x_1_by_b_1_x = t2*t61
    D_delta_y_1_by_b_1_x = t5*t61
    D_delta_z_1_by_b_1_x = t61*t8
    t62 = -D_delta_x_2*s_1_x_by_b_1_x - D_delta_y_2*s_1_y_by_b_1_x - D_delta_z_2*s_1_z_by_b_1_x
    D_delta_x_2_by_b_1_x = t2*t62
    D_delta_y_2_by_b_1_x = t5*t62
    D_delta_z_2_by_b_1_x = t62*t8
    t63 = -D_delta_x_3*s_1_x_by_b_1_x - D_delta_y_3*s_1_y_by_b_1_x - D_delta_z_3*s_1_z_by_b_1_x
    D_delta_x_3_by_b_1_x = t2*t63
    D_delta_y_3_by_b_1_x = t5*t63
    D_delta_z_3_by_b_1_x = t63*t8
    t64 = mu_1*s_1_x_by_b_1_x
    t65 = mu_1*s_1_y_by_b_1_x
    t66 = mu_1*s_1_z_by_b_1_x
    mu_1_by_b_1_x = t1*(-A_x_1*t64 - A_y_1*t65 - A_z_1*t66)
    mu_2_by_b_1_x = t1*(-A_x_2*t64 - A_y_2*t65 - A_z_2*t66)
    mu_3_by_b_1_x = t1*(-A_x_3*t64 - A_y_3*t65 - A_z_3*t66)
    x_1_by_b_1_y = s_1_y*t55
    s_1_x_by_b_1_y = -n_1_x*x_1_by_b_1_y
    s_1_y_by_b_1_y = -n_1_y*x_1_by_b_1_y + 1
    s_1_z_by_b_1_y = -n_1_z*x_1_by_b_1_y
    t67 = n_1_x**2
    t68 = (
        -D_p_x_1*s_1_x_by_b_1_y - D_p_y_1*s_1_y_by_b_1_y - D_p_z_1*s_1_z_by_b_1_y + n_1_y*s_1_y_by_b_1_y
        - t57*x_1_by_b_1_y - t67*x_1_by_b_1_y
    )
    D_p_x_1_by_b_1_y = t2*t68
    D_p_y_1_by_b_1_y = t5*t68
    D_p_z_1_by_b_1_y = t68*t8
    t69 = -D_p_x_2*s_1_x_by_b_1_y - D_p_y_2*s_1_y_by_b_1_y - D_p_z_2*s_1_z_by_b_1_y
    D_p_x_2_by_b_1_y = t2*t69
    D_p_y_2_by_b_1_y = t5*t69
    D_p_z_2_by_b_1_y = t69*t8
    t70 = -D_p_x_3*s_1_x_by_b_1_y - D_p_y_3*s_1_y_by_b_1_y - D_p_z_3*s_1_z_by_b_1_y
    D_p_x_3_by_b_1_y = t2*t70
    D_p_y_3_by_b_1_y = t5*t70
    D_p_z_3_by_b_1_y = t70*t8
    t71 = -D_delta_x_1*s_1_x_by_b_1_y - D_delta_y_1*s_1_y_by_b_1_y - D_delta_z_1*s_1_z_by_b_1_y
    D_delta_x_1_by_b_1_y = t2*t71
    D_delta_y_1_by_b_1_y = t5*t71
    D_delta_z_1_by_b_1_y = t71*t8
    t72 = -D_delta_x_2*s_1_x_by_b_1_y - D_delta_y_2*s_1_y_by_b_1_y - D_delta_z_2*s_1_z_by_b_1_y
    D_delta_x_2_by_b_1_y = t2*t72
    D_delta_y_2_by_b_1_y = t5*t72
    D_delta_z_2_by_b_1_y = t72*t8
    t73 = -D_delta_x_3*s_1_x_by_b_1_y - D_delta_y_3*s_1_y_by_b_1_y - D_delta_z_3*s_1_z_by_b_1_y
    D_delta_x_3_by_b_1_y = t2*t73
    D_delta_y_3_by_b_1_y = t5*t73
    D_delta_z_3_by_b_1_y = t73*t8
    t74 = mu_1*s_1_x_by_b_1_y
    t75 = mu_1*s_1_y_by_b_1_y
    t76 = mu_1*s_1_z_by_b_1_y
    mu_1_by_b_1_y = t1*(-A_x_1*t74 - A_y_1*t75 - A_z_1*t76)
    mu_2_by_b_1_y = t1*(-A_x_2*t74 - A_y_2*t75 - A_z_2*t76)
    mu_3_by_b_1_y = t1*(-A_x_3*t74 - A_y_3*t75 - A_z_3*t76)
    x_1_by_b_1_z = s_1_z*t55
    s_1_x_by_b_1_z = -n_1_x*x_1_by_b_1_z
    s_1_y_by_b_1_z = -n_1_y*x_1_by_b_1_z
    s_1_z_by_b_1_z = -n_1_z*x_1_by_b_1_z + 1
    t77 = (
        -D_p_x_1*s_1_x_by_b_1_z - D_p_y_1*s_1_y_by_b_1_z - D_p_z_1*s_1_z_by_b_1_z + n_1_z*s_1_z_by_b_1_z
        - t56*x_1_by_b_1_z - t67*x_1_by_b_1_z
    )
    D_p_x_1_by_b_1_z = t2*t77
    D_p_y_1_by_b_1_z = t5*t77
    D_p_z_1_by_b_1_z = t77*t8
    t78 = -D_p_x_2*s_1_x_by_b_1_z - D_p_y_2*s_1_y_by_b_1_z - D_p_z_2*s_1_z_by_b_1_z
    D_p_x_2_by_b_1_z = t2*t78
    D_p_y_2_by_b_1_z = t5*t78
    D_p_z_2_by_b_1_z = t78*t8
    t79 = -D_p_x_3*s_1_x_by_b_1_z - D_p_y_3*s_1_y_by_b_1_z - D_p_z_3*s_1_z_by_b_1_z
    D_p_x_3_by_b_1_z = t2*t79
    D_p_y_3_by_b_1_z = t5*t79
    D_p_z_3_by_b_1_z = t79*t8
    t80 = -D_delta_x_1*s_1_x_by_b_1_z - D_delta_y_1*s_1_y_by_b_1_z - D_delta_z_1*s_1_z_by_b_1_z
    D_delta_x_1_by_b_1_z = t2*t80
    D_delta_y_1_by_b_1_z = t5*t80
    D_delta_z_1_by_b_1_z = t8*t80
    t81 = -D_delta_x_2*s_1_x_by_b_1_z - D_delta_y_2*s_1_y_by_b_1_z - D_delta_z_2*s_1_z_by_b_1_z
    D_delta_x_2_by_b_1_z = t2*t81
    D_delta_y_2_by_b_1_z = t5*t81
    D_delta_z_2_by_b_1_z = t8*t81
    t82 = -D_delta_x_3*s_1_x_by_b_1_z - D_delta_y_3*s_1_y_by_b_1_z - D_delta_z_3*s_1_z_by_b_1_z
    D_delta_x_3_by_b_1_z = t2*t82
    D_delta_y_3_by_b_1_z = t5*t82
    D_delta_z_3_by_b_1_z = t8*t82
    t83 = mu_1*s_1_z_by_b_1_z
    t84 = mu_1*s_1_x_by_b_1_z
    t85 = mu_1*s_1_y_by_b_1_z
    mu_1_by_b_1_z = t1*(-A_x_1*t84 - A_y_1*t85 - A_z_1*t83)
    mu_2_by_b_1_z = t1*(-A_x_2*t84 - A_y_2*t85 - A_z_2*t83)
    mu_3_by_b_1_z = t1*(-A_x_3*t84 - A_y_3*t85 - A_z_3*t83)
    t86 = 1.0/D_r_2
    x_2_by_b_2_x = s_2_x*t86
    s_2_x_by_b_2_x = -n_2_x*x_2_by_b_2_x + 1
    s_2_y_by_b_2_x = -n_2_y*x_2_by_b_2_x
    s_2_z_by_b_2_x = -n_2_z*x_2_by_b_2_x
    t87 = -D_p_x_1*s_2_x_by_b_2_x - D_p_y_1*s_2_y_by_b_2_x - D_p_z_1*s_2_z_by_b_2_x
    D_p_x_1_by_b_2_x = t3*t87
    D_p_y_1_by_b_2_x = t6*t87
    D_p_z_1_by_b_2_x = t87*t9
    t88 = n_2_y**2
    t89 = n_2_z**2
    t90 = (
        -D_p_x_2*s_2_x_by_b_2_x - D_p_y_2*s_2_y_by_b_2_x - D_p_z_2*s_2_z_by_b_2_x + n_2_x*s_2_x_by_b_2_x
        - t88*x_2_by_b_2_x - t89*x_2_by_b_2_x
    )
    D_p_x_2_by_b_2_x = t3*t90
    D_p_y_2_by_b_2_x = t6*t90
    D_p_z_2_by_b_2_x = t9*t90
    t91 = -D_p_x_3*s_2_x_by_b_2_x - D_p_y_3*s_2_y_by_b_2_x - D_p_z_3*s_2_z_by_b_2_x
    D_p_x_3_by_b_2_x = t3*t91
    D_p_y_3_by_b_2_x = t6*t91
    D_p_z_3_by_b_2_x = t9*t91
    t92 = -D_delta_x_1*s_2_x_by_b_2_x - D_delta_y_1*s_2_y_by_b_2_x - D_delta_z_1*s_2_z_by_b_2_x
    D_delta_x_1_by_b_2_x = t3*t92
    D_delta_y_1_by_b_2_x = t6*t92
    D_delta_z_1_by_b_2_x = t9*t92
    t93 = -D_delta_x_2*s_2_x_by_b_2_x - D_delta_y_2*s_2_y_by_b_2_x - D_delta_z_2*s_2_z_by_b_2_x
    D_delta_x_2_by_b_2_x = t3*t93
    D_delta_y_2_by_b_2_x = t6*t93
    D_delta_z_2_by_b_2_x = t9*t93
    t94 = -D_delta_x_3*s_2_x_by_b_2_x - D_delta_y_3*s_2_y_by_b_2_x - D_delta_z_3*s_2_z_by_b_2_x
    D_delta_x_3_by_b_2_x = t3*t94
    D_delta_y_3_by_b_2_x = t6*t94
    D_delta_z_3_by_b_2_x = t9*t94
    t95 = mu_2*s_2_x_by_b_2_x
    t96 = mu_2*s_2_y_by_b_2_x
    t97 = mu_2*s_2_z_by_b_2_x
    mu_1_by_b_2_x = t1*(-A_x_1*t95 - A_y_1*t96 - A_z_1*t97)
    mu_2_by_b_2_x = t1*(-A_x_2*t95 - A_y_2*t96 - A_z_2*t97)
    mu_3_by_b_2_x = t1*(-A_x_3*t95 - A_y_3*t96 - A_z_3*t97)
    x_2_by_b_2_y = s_2_y*t86
    s_2_x_by_b_2_y = -n_2_x*x_2_by_b_2_y
    s_2_y_by_b_2_y = -n_2_y*x_2_by_b_2_y + 1
    s_2_z_by_b_2_y = -n_2_z*x_2_by_b_2_y
    t98 = -D_p_x_1*s_2_x_by_b_2_y - D_p_y_1*s_2_y_by_b_2_y - D_p_z_1*s_2_z_by_b_2_y
    D_p_x_1_by_b_2_y = t3*t98
    D_p_y_1_by_b_2_y = t6*t98
    D_p_z_1_by_b_2_y = t9*t98
    t99 = n_2_x**2
    t100 = (
        -D_p_x_2*s_2_x_by_b_2_y - D_p_y_2*s_2_y_by_b_2_y - D_p_z_2*s_2_z_by_b_2_y + n_2_y*s_2_y_by_b_2_y
        - t89*x_2_by_b_2_y - t99*x_2_by_b_2_y
    )
    D_p_x_2_by_b_2_y = t100*t3
    D_p_y_2_by_b_2_y = t100*t6
    D_p_z_2_by_b_2_y = t100*t9
    t101 = -D_p_x_3*s_2_x_by_b_2_y - D_p_y_3*s_2_y_by_b_2_y - D_p_z_3*s_2_z_by_b_2_y
    D_p_x_3_by_b_2_y = t101*t3
    D_p_y_3_by_b_2_y = t101*t6
    D_p_z_3_by_b_2_y = t101*t9
    t102 = -D_delta_x_1*s_2_x_by_b_2_y - D_delta_y_1*s_2_y_by_b_2_y - D_delta_z_1*s_2_z_by_b_2_y
    D_delta_x_1_by_b_2_y = t102*t3
    D_delta_y_1_by_b_2_y = t102*t6
    D_delta_z_1_by_b_2_y = t102*t9
    t103 = -D_delta_x_2*s_2_x_by_b_2_y - D_delta_y_2*s_2_y_by_b_2_y - D_delta_z_2*s_2_z_by_b_2_y
    D_delta_x_2_by_b_2_y = t103*t3
    D_delta_y_2_by_b_2_y = t103*t6
    D_delta_z_2_by_b_2_y = t103*t9
    t104 = -D_delta_x_3*s_2_x_by_b_2_y - D_delta_y_3*s_2_y_by_b_2_y - D_delta_z_3*s_2_z_by_b_2_y
    D_delta_x_3_by_b_2_y = t104*t3
    D_delta_y_3_by_b_2_y = t104*t6
    D_delta_z_3_by_b_2_y = t104*t9
    t105 = mu_2*s_2_x_by_b_2_y
    t106 = mu_2*s_2_y_by_b_2_y
    t107 = mu_2*s_2_z_by_b_2_y
    mu_1_by_b_2_y = t1*(-A_x_1*t105 - A_y_1*t106 - A_z_1*t107)
    mu_2_by_b_2_y = t1*(-A_x_2*t105 - A_y_2*t106 - A_z_2*t107)
    mu_3_by_b_2_y = t1*(-A_x_3*t105 - A_y_3*t106 - A_z_3*t107)
    x_2_by_b_2_z = s_2_z*t86
    s_2_x_by_b_2_z = -n_2_x*x_2_by_b_2_z
    s_2_y_by_b_2_z = -n_2_y*x_2_by_b_2_z
    s_2_z_by_b_2_z = -n_2_z*x_2_by_b_2_z + 1
    t108 = -D_p_x_1*s_2_x_by_b_2_z - D_p_y_1*s_2_y_by_b_2_z - D_p_z_1*s_2_z_by_b_2_z
    D_p_x_1_by_b_2_z = t108*t3
    D_p_y_1_by_b_2_z = t108*t6
    D_p_z_1_by_b_2_z = t108*t9
    t109 = (
        -D_p_x_2*s_2_x_by_b_2_z - D_p_y_2*s_2_y_by_b_2_z - D_p_z_2*s_2_z_by_b_2_z + n_2_z*s_2_z_by_b_2_z
        - t88*x_2_by_b_2_z - t99*x_2_by_b_2_z
    )
    D_p_x_2_by_b_2_z = t109*t3
    D_p_y_2_by_b_2_z = t109*t6
    D_p_z_2_by_b_2_z = t109*t9
    t110 = -D_p_x_3*s_2_x_by_b_2_z - D_p_y_3*s_2_y_by_b_2_z - D_p_z_3*s_2_z_by_b_2_z
    D_p_x_3_by_b_2_z = t110*t3
    D_p_y_3_by_b_2_z = t110*t6
    D_p_z_3_by_b_2_z = t110*t9
    t111 = -D_delta_x_1*s_2_x_by_b_2_z - D_delta_y_1*s_2_y_by_b_2_z - D_delta_z_1*s_2_z_by_b_2_z
    D_delta_x_1_by_b_2_z = t111*t3
    D_delta_y_1_by_b_2_z = t111*t6
    D_delta_z_1_by_b_2_z = t111*t9
    t112 = -D_delta_x_2*s_2_x_by_b_2_z - D_delta_y_2*s_2_y_by_b_2_z - D_delta_z_2*s_2_z_by_b_2_z
    D_delta_x_2_by_b_2_z = t112*t3
    D_delta_y_2_by_b_2_z = t112*t6
    D_delta_z_2_by_b_2_z = t112*t9
    t113 = -D_delta_x_3*s_2_x_by_b_2_z - D_delta_y_3*s_2_y_by_b_2_z - D_delta_z_3*s_2_z_by_b_2_z
    D_delta_x_3_by_b_2_z = t113*t3
    D_delta_y_3_by_b_2_z = t113*t6
    D_delta_z_3_by_b_2_z = t113*t9
    t114 = mu_2*s_2_x_by_b_2_z
    t115 = mu_2*s_2_y_by_b_2_z
    t116 = mu_2*s_2_z_by_b_2_z
    mu_1_by_b_2_z = t1*(-A_x_1*t114 - A_y_1*t115 - A_z_1*t116)
    mu_2_by_b_2_z = t1*(-A_x_2*t114 - A_y_2*t115 - A_z_2*t116)
    mu_3_by_b_2_z = t1*(-A_x_3*t114 - A_y_3*t115 - A_z_3*t116)
    t117 = 1.0/D_r_3
    x_3_by_b_3_x = s_3_x*t117
    s_3_x_by_b_3_x = -n_3_x*x_3_by_b_3_x + 1
    s_3_y_by_b_3_x = -n_3_y*x_3_by_b_3_x
    s_3_z_by_b_3_x = -n_3_z*x_3_by_b_3_x
    t118 = -D_p_x_1*s_3_x_by_b_3_x - D_p_y_1*s_3_y_by_b_3_x - D_p_z_1*s_3_z_by_b_3_x
    D_p_x_1_by_b_3_x = t118*t4
    D_p_y_1_by_b_3_x = t118*t7
    D_p_z_1_by_b_3_x = t10*t118
    t119 = -D_p_x_2*s_3_x_by_b_3_x - D_p_y_2*s_3_y_by_b_3_x - D_p_z_2*s_3_z_by_b_3_x
    D_p_x_2_by_b_3_x = t119*t4
    D_p_y_2_by_b_3_x = t119*t7
    D_p_z_2_by_b_3_x = t10*t119
    t120 = n_3_y**2
    t121 = n_3_z**2
    t122 = (
        -D_p_x_3*s_3_x_by_b_3_x - D_p_y_3*s_3_y_by_b_3_x - D_p_z_3*s_3_z_by_b_3_x + n_3_x*s_3_x_by_b_3_x
        - t120*x_3_by_b_3_x - t121*x_3_by_b_3_x
    )
    D_p_x_3_by_b_3_x = t122*t4
    D_p_y_3_by_b_3_x = t122*t7
    D_p_z_3_by_b_3_x = t10*t122
    t123 = -D_delta_x_1*s_3_x_by_b_3_x - D_delta_y_1*s_3_y_by_b_3_x - D_delta_z_1*s_3_z_by_b_3_x
    D_delta_x_1_by_b_3_x = t123*t4
    D_delta_y_1_by_b_3_x = t123*t7
    D_delta_z_1_by_b_3_x = t10*t123
    t124 = -D_delta_x_2*s_3_x_by_b_3_x - D_delta_y_2*s_3_y_by_b_3_x - D_delta_z_2*s_3_z_by_b_3_x
    D_delta_x_2_by_b_3_x = t124*t4
    D_delta_y_2_by_b_3_x = t124*t7
    D_delta_z_2_by_b_3_x = t10*t124
    t125 = -D_delta_x_3*s_3_x_by_b_3_x - D_delta_y_3*s_3_y_by_b_3_x - D_delta_z_3*s_3_z_by_b_3_x
    D_delta_x_3_by_b_3_x = t125*t4
    D_delta_y_3_by_b_3_x = t125*t7
    D_delta_z_3_by_b_3_x = t10*t125
    t126 = mu_3*s_3_x_by_b_3_x
    t127 = mu_3*s_3_y_by_b_3_x
    t128 = mu_3*s_3_z_by_b_3_x
    mu_1_by_b_3_x = t1*(-A_x_1*t126 - A_y_1*t127 - A_z_1*t128)
    mu_2_by_b_3_x = t1*(-A_x_2*t126 - A_y_2*t127 - A_z_2*t128)
    mu_3_by_b_3_x = t1*(-A_x_3*t126 - A_y_3*t127 - A_z_3*t128)
    x_3_by_b_3_y = s_3_y*t117
    s_3_x_by_b_3_y = -n_3_x*x_3_by_b_3_y
    s_3_y_by_b_3_y = -n_3_y*x_3_by_b_3_y + 1
    s_3_z_by_b_3_y = -n_3_z*x_3_by_b_3_y
    t129 = -D_p_x_1*s_3_x_by_b_3_y - D_p_y_1*s_3_y_by_b_3_y - D_p_z_1*s_3_z_by_b_3_y
    D_p_x_1_by_b_3_y = t129*t4
    D_p_y_1_by_b_3_y = t129*t7
    D_p_z_1_by_b_3_y = t10*t129
    t130 = -D_p_x_2*s_3_x_by_b_3_y - D_p_y_2*s_3_y_by_b_3_y - D_p_z_2*s_3_z_by_b_3_y
    D_p_x_2_by_b_3_y = t130*t4
    D_p_y_2_by_b_3_y = t130*t7
    D_p_z_2_by_b_3_y = t10*t130
    t131 = n_3_x**2
    t132 = (
        -D_p_x_3*s_3_x_by_b_3_y - D_p_y_3*s_3_y_by_b_3_y - D_p_z_3*s_3_z_by_b_3_y + n_3_y*s_3_y_by_b_3_y
        - t121*x_3_by_b_3_y - t131*x_3_by_b_3_y
    )
    D_p_x_3_by_b_3_y = t132*t4
    D_p_y_3_by_b_3_y = t132*t7
    D_p_z_3_by_b_3_y = t10*t132
    t133 = -D_delta_x_1*s_3_x_by_b_3_y - D_delta_y_1*s_3_y_by_b_3_y - D_delta_z_1*s_3_z_by_b_3_y
    D_delta_x_1_by_b_3_y = t133*t4
    D_delta_y_1_by_b_3_y = t133*t7
    D_delta_z_1_by_b_3_y = t10*t133
    t134 = -D_delta_x_2*s_3_x_by_b_3_y - D_delta_y_2*s_3_y_by_b_3_y - D_delta_z_2*s_3_z_by_b_3_y
    D_delta_x_2_by_b_3_y = t134*t4
    D_delta_y_2_by_b_3_y = t134*t7
    D_delta_z_2_by_b_3_y = t10*t134
    t135 = -D_delta_x_3*s_3_x_by_b_3_y - D_delta_y_3*s_3_y_by_b_3_y - D_delta_z_3*s_3_z_by_b_3_y
    D_delta_x_3_by_b_3_y = t135*t4
    D_delta_y_3_by_b_3_y = t135*t7
    D_delta_z_3_by_b_3_y = t10*t135
    t136 = mu_3*s_3_x_by_b_3_y
    t137 = mu_3*s_3_y_by_b_3_y
    t138 = mu_3*s_3_z_by_b_3_y
    mu_1_by_b_3_y = t1*(-A_x_1*t136 - A_y_1*t137 - A_z_1*t138)
    mu_2_by_b_3_y = t1*(-A_x_2*t136 - A_y_2*t137 - A_z_2*t138)
    mu_3_by_b_3_y = t1*(-A_x_3*t136 - A_y_3*t137 - A_z_3*t138)
    x_3_by_b_3_z = s_3_z*t117
    s_3_x_by_b_3_z = -n_3_x*x_3_by_b_3_z
    s_3_y_by_b_3_z = -n_3_y*x_3_by_b_3_z
    s_3_z_by_b_3_z = -n_3_z*x_3_by_b_3_z + 1
    t139 = -D_p_x_1*s_3_x_by_b_3_z - D_p_y_1*s_3_y_by_b_3_z - D_p_z_1*s_3_z_by_b_3_z
    D_p_x_1_by_b_3_z = t139*t4
    D_p_y_1_by_b_3_z = t139*t7
    D_p_z_1_by_b_3_z = t10*t139
    t140 = -D_p_x_2*s_3_x_by_b_3_z - D_p_y_2*s_3_y_by_b_3_z - D_p_z_2*s_3_z_by_b_3_z
    D_p_x_2_by_b_3_z = t140*t4
    D_p_y_2_by_b_3_z = t140*t7
    D_p_z_2_by_b_3_z = t10*t140
    t141 = (
        -D_p_x_3*s_3_x_by_b_3_z - D_p_y_3*s_3_y_by_b_3_z - D_p_z_3*s_3_z_by_b_3_z + n_3_z*s_3_z_by_b_3_z
        - t120*x_3_by_b_3_z - t131*x_3_by_b_3_z
    )
    D_p_x_3_by_b_3_z = t141*t4
    D_p_y_3_by_b_3_z = t141*t7
    D_p_z_3_by_b_3_z = t10*t141
    t142 = -D_delta_x_1*s_3_x_by_b_3_z - D_delta_y_1*s_3_y_by_b_3_z - D_delta_z_1*s_3_z_by_b_3_z
    D_delta_x_1_by_b_3_z = t142*t4
    D_delta_y_1_by_b_3_z = t142*t7
    D_delta_z_1_by_b_3_z = t10*t142
    t143 = -D_delta_x_2*s_3_x_by_b_3_z - D_delta_y_2*s_3_y_by_b_3_z - D_delta_z_2*s_3_z_by_b_3_z
    D_delta_x_2_by_b_3_z = t143*t4
    D_delta_y_2_by_b_3_z = t143*t7
    D_delta_z_2_by_b_3_z = t10*t143
    t144 = -D_delta_x_3*s_3_x_by_b_3_z - D_delta_y_3*s_3_y_by_b_3_z - D_delta_z_3*s_3_z_by_b_3_z
    D_delta_x_3_by_b_3_z = t144*t4
    D_delta_y_3_by_b_3_z = t144*t7
    D_delta_z_3_by_b_3_z = t10*t144
    t145 = mu_3*s_3_x_by_b_3_z
    t146 = mu_3*s_3_y_by_b_3_z
    t147 = mu_3*s_3_z_by_b_3_z
    mu_1_by_b_3_z = t1*(-A_x_1*t145 - A_y_1*t146 - A_z_1*t147)
    mu_2_by_b_3_z = t1*(-A_x_2*t145 - A_y_2*t146 - A_z_2*t147)
    mu_3_by_b_3_z = t1*(-A_x_3*t145 - A_y_3*t146 - A_z_3*t147)
    x_1_by_l_d_1 = -l_d_1*t55
    s_1_x_by_l_d_1 = -n_1_x*x_1_by_l_d_1
    s_1_y_by_l_d_1 = -n_1_y*x_1_by_l_d_1
    s_1_z_by_l_d_1 = -n_1_z*x_1_by_l_d_1
    t148 = (
        -D_p_x_1*s_1_x_by_l_d_1 - D_p_y_1*s_1_y_by_l_d_1 - D_p_z_1*s_1_z_by_l_d_1 - t56*x_1_by_l_d_1
        - t57*x_1_by_l_d_1 - t67*x_1_by_l_d_1
    )
    D_p_x_1_by_l_d_1 = t148*t2
    D_p_y_1_by_l_d_1 = t148*t5
    D_p_z_1_by_l_d_1 = t148*t8
    t149 = -D_p_x_2*s_1_x_by_l_d_1 - D_p_y_2*s_1_y_by_l_d_1 - D_p_z_2*s_1_z_by_l_d_1
    D_p_x_2_by_l_d_1 = t149*t2
    D_p_y_2_by_l_d_1 = t149*t5
    D_p_z_2_by_l_d_1 = t149*t8
    t150 = -D_p_x_3*s_1_x_by_l_d_1 - D_p_y_3*s_1_y_by_l_d_1 - D_p_z_3*s_1_z_by_l_d_1
    D_p_x_3_by_l_d_1 = t150*t2
    D_p_y_3_by_l_d_1 = t150*t5
    D_p_z_3_by_l_d_1 = t150*t8
    t151 = -D_delta_x_1*s_1_x_by_l_d_1 - D_delta_y_1*s_1_y_by_l_d_1 - D_delta_z_1*s_1_z_by_l_d_1 + 1
    D_delta_x_1_by_l_d_1 = t151*t2
    D_delta_y_1_by_l_d_1 = t151*t5
    D_delta_z_1_by_l_d_1 = t151*t8
    t152 = -D_delta_x_2*s_1_x_by_l_d_1 - D_delta_y_2*s_1_y_by_l_d_1 - D_delta_z_2*s_1_z_by_l_d_1
    D_delta_x_2_by_l_d_1 = t152*t2
    D_delta_y_2_by_l_d_1 = t152*t5
    D_delta_z_2_by_l_d_1 = t152*t8
    t153 = -D_delta_x_3*s_1_x_by_l_d_1 - D_delta_y_3*s_1_y_by_l_d_1 - D_delta_z_3*s_1_z_by_l_d_1
    D_delta_x_3_by_l_d_1 = t153*t2
    D_delta_y_3_by_l_d_1 = t153*t5
    D_delta_z_3_by_l_d_1 = t153*t8
    t154 = mu_1*s_1_x_by_l_d_1
    t155 = mu_1*s_1_y_by_l_d_1
    t156 = mu_1*s_1_z_by_l_d_1
    mu_1_by_l_d_1 = t1*(-A_x_1*t154 - A_y_1*t155 - A_z_1*t156)
    mu_2_by_l_d_1 = t1*(-A_x_2*t154 - A_y_2*t155 - A_z_2*t156)
    mu_3_by_l_d_1 = t1*(-A_x_3*t154 - A_y_3*t155 - A_z_3*t156)
    x_2_by_l_d_2 = -l_d_2*t86
    s_2_x_by_l_d_2 = -n_2_x*x_2_by_l_d_2
    s_2_y_by_l_d_2 = -n_2_y*x_2_by_l_d_2
    s_2_z_by_l_d_2 = -n_2_z*x_2_by_l_d_2
    t157 = -D_p_x_1*s_2_x_by_l_d_2 - D_p_y_1*s_2_y_by_l_d_2 - D_p_z_1*s_2_z_by_l_d_2
    D_p_x_1_by_l_d_2 = t157*t3
    D_p_y_1_by_l_d_2 = t157*t6
    D_p_z_1_by_l_d_2 = t157*t9
    t158 = (
        -D_p_x_2*s_2_x_by_l_d_2 - D_p_y_2*s_2_y_by_l_d_2 - D_p_z_2*s_2_z_by_l_d_2 - t88*x_2_by_l_d_2
        - t89*x_2_by_l_d_2 - t99*x_2_by_l_d_2
    )
    D_p_x_2_by_l_d_2 = t158*t3
    D_p_y_2_by_l_d_2 = t158*t6
    D_p_z_2_by_l_d_2 = t158*t9
    t159 = -D_p_x_3*s_2_x_by_l_d_2 - D_p_y_3*s_2_y_by_l_d_2 - D_p_z_3*s_2_z_by_l_d_2
    D_p_x_3_by_l_d_2 = t159*t3
    D_p_y_3_by_l_d_2 = t159*t6
    D_p_z_3_by_l_d_2 = t159*t9
    t160 = -D_delta_x_1*s_2_x_by_l_d_2 - D_delta_y_1*s_2_y_by_l_d_2 - D_delta_z_1*s_2_z_by_l_d_2
    D_delta_x_1_by_l_d_2 = t160*t3
    D_delta_y_1_by_l_d_2 = t160*t6
    D_delta_z_1_by_l_d_2 = t160*t9
    t161 = -D_delta_x_2*s_2_x_by_l_d_2 - D_delta_y_2*s_2_y_by_l_d_2 - D_delta_z_2*s_2_z_by_l_d_2 + 1
    D_delta_x_2_by_l_d_2 = t161*t3
    D_delta_y_2_by_l_d_2 = t161*t6
    D_delta_z_2_by_l_d_2 = t161*t9
    t162 = -D_delta_x_3*s_2_x_by_l_d_2 - D_delta_y_3*s_2_y_by_l_d_2 - D_delta_z_3*s_2_z_by_l_d_2
    D_delta_x_3_by_l_d_2 = t162*t3
    D_delta_y_3_by_l_d_2 = t162*t6
    D_delta_z_3_by_l_d_2 = t162*t9
    t163 = mu_2*s_2_x_by_l_d_2
    t164 = mu_2*s_2_y_by_l_d_2
    t165 = mu_2*s_2_z_by_l_d_2
    mu_1_by_l_d_2 = t1*(-A_x_1*t163 - A_y_1*t164 - A_z_1*t165)
    mu_2_by_l_d_2 = t1*(-A_x_2*t163 - A_y_2*t164 - A_z_2*t165)
    mu_3_by_l_d_2 = t1*(-A_x_3*t163 - A_y_3*t164 - A_z_3*t165)
    x_3_by_l_d_3 = -l_d_3*t117
    s_3_x_by_l_d_3 = -n_3_x*x_3_by_l_d_3
    s_3_y_by_l_d_3 = -n_3_y*x_3_by_l_d_3
    s_3_z_by_l_d_3 = -n_3_z*x_3_by_l_d_3
    t166 = -D_p_x_1*s_3_x_by_l_d_3 - D_p_y_1*s_3_y_by_l_d_3 - D_p_z_1*s_3_z_by_l_d_3
    D_p_x_1_by_l_d_3 = t166*t4
    D_p_y_1_by_l_d_3 = t166*t7
    D_p_z_1_by_l_d_3 = t10*t166
    t167 = -D_p_x_2*s_3_x_by_l_d_3 - D_p_y_2*s_3_y_by_l_d_3 - D_p_z_2*s_3_z_by_l_d_3
    D_p_x_2_by_l_d_3 = t167*t4
    D_p_y_2_by_l_d_3 = t167*t7
    D_p_z_2_by_l_d_3 = t10*t167
    t168 = (
        -D_p_x_3*s_3_x_by_l_d_3 - D_p_y_3*s_3_y_by_l_d_3 - D_p_z_3*s_3_z_by_l_d_3 - t120*x_3_by_l_d_3
        - t121*x_3_by_l_d_3 - t131*x_3_by_l_d_3
    )
    D_p_x_3_by_l_d_3 = t168*t4
    D_p_y_3_by_l_d_3 = t168*t7
    D_p_z_3_by_l_d_3 = t10*t168
    t169 = -D_delta_x_1*s_3_x_by_l_d_3 - D_delta_y_1*s_3_y_by_l_d_3 - D_delta_z_1*s_3_z_by_l_d_3
    D_delta_x_1_by_l_d_3 = t169*t4
    D_delta_y_1_by_l_d_3 = t169*t7
    D_delta_z_1_by_l_d_3 = t10*t169
    t170 = -D_delta_x_2*s_3_x_by_l_d_3 - D_delta_y_2*s_3_y_by_l_d_3 - D_delta_z_2*s_3_z_by_l_d_3
    D_delta_x_2_by_l_d_3 = t170*t4
    D_delta_y_2_by_l_d_3 = t170*t7
    D_delta_z_2_by_l_d_3 = t10*t170
    t171 = -D_delta_x_3*s_3_x_by_l_d_3 - D_delta_y_3*s_3_y_by_l_d_3 - D_delta_z_3*s_3_z_by_l_d_3 + 1
    D_delta_x_3_by_l_d_3 = t171*t4
    D_delta_y_3_by_l_d_3 = t171*t7
    D_delta_z_3_by_l_d_3 = t10*t171
    t172 = mu_3*s_3_x_by_l_d_3
    t173 = mu_3*s_3_y_by_l_d_3
    t174 = mu_3*s_3_z_by_l_d_3
    mu_1_by_l_d_3 = t1*(-A_x_1*t172 - A_y_1*t173 - A_z_1*t174)
    mu_2_by_l_d_3 = t1*(-A_x_2*t172 - A_y_2*t173 - A_z_2*t174)
    mu_3_by_l_d_3 = t1*(-A_x_3*t172 - A_y_3*t173 - A_z_3*t174)
    mu_1_by_m_d_1 = t1*(-1/2*t46 - 1/2*t47 - 1/2*t48)
    mu_2_by_m_d_1 = t1*(-1/2*t49 - 1/2*t50 - 1/2*t51)
    mu_3_by_m_d_1 = t1*(-1/2*t52 - 1/2*t53 - 1/2*t54)
    mu_1_by_m_d_2 = mu_1_by_m_d_1
    mu_2_by_m_d_2 = mu_2_by_m_d_1
    mu_3_by_m_d_2 = mu_3_by_m_d_1
    mu_1_by_m_d_3 = mu_1_by_m_d_1
    mu_2_by_m_d_3 = mu_2_by_m_d_1
    mu_3_by_m_d_3 = mu_3_by_m_d_1
    mu_1_by_m_L = mu_1_by_m_p
    mu_2_by_m_L = mu_2_by_m_p
    mu_3_by_m_L = mu_3_by_m_p
    t175 = D_p_x_1**2
    t176 = D_p_y_1**2
    t177 = D_p_z_1**2
    t178 = t175 + t176 + t177
    t179 = D_p_x_1*D_p_x_2
    t180 = D_p_y_1*D_p_y_2
    t181 = D_p_z_1*D_p_z_2
    t182 = t179 + t180 + t181
    t183 = D_p_x_1*D_p_x_3
    t184 = D_p_y_1*D_p_y_3
    t185 = D_p_z_1*D_p_z_3
    t186 = t183 + t184 + t185
    t187 = D_delta_x_1*D_p_x_1
    t188 = D_delta_y_1*D_p_y_1
    t189 = D_delta_z_1*D_p_z_1
    t190 = t187 + t188 + t189
    t191 = D_delta_x_2*D_p_x_1
    t192 = D_delta_y_2*D_p_y_1
    t193 = D_delta_z_2*D_p_z_1
    t194 = t191 + t192 + t193
    t195 = D_delta_x_3*D_p_x_1
    t196 = D_delta_y_3*D_p_y_1
    t197 = D_delta_z_3*D_p_z_1
    t198 = t195 + t196 + t197
    t199 = D_p_x_2**2
    t200 = D_p_y_2**2
    t201 = D_p_z_2**2
    t202 = t199 + t200 + t201
    t203 = D_p_x_2*D_p_x_3
    t204 = D_p_y_2*D_p_y_3
    t205 = D_p_z_2*D_p_z_3
    t206 = t203 + t204 + t205
    t207 = D_delta_x_1*D_p_x_2
    t208 = D_delta_y_1*D_p_y_2
    t209 = D_delta_z_1*D_p_z_2
    t210 = t207 + t208 + t209
    t211 = D_delta_x_2*D_p_x_2
    t212 = D_delta_y_2*D_p_y_2
    t213 = D_delta_z_2*D_p_z_2
    t214 = t211 + t212 + t213
    t215 = D_delta_x_3*D_p_x_2
    t216 = D_delta_y_3*D_p_y_2
    t217 = D_delta_z_3*D_p_z_2
    t218 = t215 + t216 + t217
    t219 = D_p_x_3**2
    t220 = D_p_y_3**2
    t221 = D_p_z_3**2
    t222 = t219 + t220 + t221
    t223 = D_delta_x_1*D_p_x_3
    t224 = D_delta_y_1*D_p_y_3
    t225 = D_delta_z_1*D_p_z_3
    t226 = t223 + t224 + t225
    t227 = D_delta_x_2*D_p_x_3
    t228 = D_delta_y_2*D_p_y_3
    t229 = D_delta_z_2*D_p_z_3
    t230 = t227 + t228 + t229
    t231 = D_delta_x_3*D_p_x_3
    t232 = D_delta_y_3*D_p_y_3
    t233 = D_delta_z_3*D_p_z_3
    t234 = t231 + t232 + t233
    t235 = D_delta_x_1**2
    t236 = D_delta_y_1**2
    t237 = D_delta_z_1**2
    t238 = t235 + t236 + t237
    t239 = D_delta_x_1*D_delta_x_2
    t240 = D_delta_y_1*D_delta_y_2
    t241 = D_delta_z_1*D_delta_z_2
    t242 = t239 + t240 + t241
    t243 = D_delta_x_1*D_delta_x_3
    t244 = D_delta_y_1*D_delta_y_3
    t245 = D_delta_z_1*D_delta_z_3
    t246 = t243 + t244 + t245
    t247 = D_delta_x_2**2
    t248 = D_delta_y_2**2
    t249 = D_delta_z_2**2
    t250 = t247 + t248 + t249
    t251 = D_delta_x_2*D_delta_x_3
    t252 = D_delta_y_2*D_delta_y_3
    t253 = D_delta_z_2*D_delta_z_3
    t254 = t251 + t252 + t253
    t255 = D_delta_x_3**2
    t256 = D_delta_y_3**2
    t257 = D_delta_z_3**2
    t258 = t255 + t256 + t257
    t259 = (1/3)*m_d_1
    t260 = (1/3)*m_d_2
    t261 = (1/3)*m_d_3
    t262 = t259 + t260 + t261 + t44
    t263 = D_p_x_1*t262
    t264 = n_1_x*t259 + 2*t263
    t265 = D_p_y_1*t262
    t266 = n_1_y*t259 + 2*t265
    t267 = D_p_z_1*t262
    t268 = n_1_z*t259 + 2*t267
    t269 = (1/6)*n_2_x
    t270 = D_p_x_2*t262
    t271 = m_d_2*t269 + t270
    t272 = (1/6)*n_1_x
    t273 = m_d_1*t272 + t263
    t274 = (1/6)*n_2_y
    t275 = D_p_y_2*t262
    t276 = m_d_2*t274 + t275
    t277 = (1/6)*n_1_y
    t278 = m_d_1*t277 + t265
    t279 = (1/6)*n_2_z
    t280 = D_p_z_2*t262
    t281 = m_d_2*t279 + t280
    t282 = (1/6)*n_1_z
    t283 = m_d_1*t282 + t267
    t284 = (1/6)*n_3_x
    t285 = D_p_x_3*t262
    t286 = m_d_3*t284 + t285
    t287 = (1/6)*n_3_y
    t288 = D_p_y_3*t262
    t289 = m_d_3*t287 + t288
    t290 = (1/6)*n_3_z
    t291 = D_p_z_3*t262
    t292 = m_d_3*t290 + t291
    t293 = (1/6)*rho_b
    t294 = R_p_1*t293
    t295 = t294*x_1_by_b_1_x
    t296 = D_p_x_1_by_b_1_x*t262
    t297 = D_p_y_1_by_b_1_x*t262
    t298 = D_p_z_1_by_b_1_x*t262
    t299 = n_2_x*t260 + 2*t270
    t300 = n_2_y*t260 + 2*t275
    t301 = n_2_z*t260 + 2*t280
    t302 = D_p_x_2_by_b_1_x*t262
    t303 = D_p_y_2_by_b_1_x*t262
    t304 = D_p_z_2_by_b_1_x*t262
    t305 = n_3_x*t261 + 2*t285
    t306 = n_3_y*t261 + 2*t288
    t307 = n_3_z*t261 + 2*t291
    t308 = D_p_x_3_by_b_1_x*t262
    t309 = D_p_y_3_by_b_1_x*t262
    t310 = D_p_z_3_by_b_1_x*t262
    t311 = R_p_1**2
    t312 = (1/3)*rho_b
    t313 = t311*t312
    t314 = t313*x_1_by_b_1_x
    t315 = D_delta_x_1*t262
    t316 = 2*t315
    t317 = D_delta_y_1*t262
    t318 = 2*t317
    t319 = D_delta_z_1*t262
    t320 = 2*t319
    t321 = D_delta_x_1_by_b_1_x*t262
    t322 = D_delta_y_1_by_b_1_x*t262
    t323 = D_delta_z_1_by_b_1_x*t262
    t324 = D_delta_x_2*t262
    t325 = 2*t324
    t326 = D_delta_y_2*t262
    t327 = 2*t326
    t328 = D_delta_z_2*t262
    t329 = 2*t328
    t330 = D_delta_x_3*t262
    t331 = D_delta_y_3*t262
    t332 = D_delta_z_3*t262
    t333 = 2*t330
    t334 = 2*t331
    t335 = 2*t332
    t336 = t294*x_1_by_b_1_y
    t337 = t313*x_1_by_b_1_y
    t338 = t294*x_1_by_b_1_z
    t339 = t313*x_1_by_b_1_z
    t340 = R_p_2*t293
    t341 = t340*x_2_by_b_2_x
    t342 = R_p_2**2
    t343 = t312*t342
    t344 = t343*x_2_by_b_2_x
    t345 = t340*x_2_by_b_2_y
    t346 = t343*x_2_by_b_2_y
    t347 = t340*x_2_by_b_2_z
    t348 = t343*x_2_by_b_2_z
    t349 = R_p_3*t293
    t350 = t349*x_3_by_b_3_x
    t351 = R_p_3**2
    t352 = t312*t351
    t353 = t352*x_3_by_b_3_x
    t354 = t349*x_3_by_b_3_y
    t355 = t352*x_3_by_b_3_y
    t356 = t349*x_3_by_b_3_z
    t357 = t352*x_3_by_b_3_z
    t358 = t294*x_1_by_l_d_1
    t359 = t313*x_1_by_l_d_1
    t360 = t340*x_2_by_l_d_2
    t361 = t343*x_2_by_l_d_2
    t362 = t349*x_3_by_l_d_3
    t363 = t352*x_3_by_l_d_3
    t364 = (1/3)*D_p_x_1 + t272
    t365 = (1/3)*D_p_y_1 + t277
    t366 = (1/3)*D_p_z_1 + t282
    t367 = (1/2)*D_p_x_1
    t368 = (1/2)*D_p_y_1
    t369 = (1/2)*D_p_z_1
    t370 = (1/3)*t199 + (1/3)*t200 + (1/3)*t201
    t371 = (1/3)*t203 + (1/3)*t204 + (1/3)*t205
    t372 = (1/3)*t207 + (1/3)*t208 + (1/3)*t209
    t373 = (1/3)*t211 + (1/3)*t212 + (1/3)*t213
    t374 = (1/3)*t215 + (1/3)*t216 + (1/3)*t217
    t375 = (1/2)*D_p_x_2
    t376 = (1/2)*D_p_y_2
    t377 = (1/2)*D_p_z_2
    t378 = (1/3)*t219 + (1/3)*t220 + (1/3)*t221
    t379 = (1/3)*t223 + (1/3)*t224 + (1/3)*t225
    t380 = (1/3)*t227 + (1/3)*t228 + (1/3)*t229
    t381 = (1/3)*t231 + (1/3)*t232 + (1/3)*t233
    t382 = (1/2)*D_p_x_3
    t383 = (1/2)*D_p_y_3
    t384 = (1/2)*D_p_z_3
    t385 = (1/3)*t235 + (1/3)*t236 + (1/3)*t237
    t386 = (1/3)*t239 + (1/3)*t240 + (1/3)*t241
    t387 = (1/3)*t243 + (1/3)*t244 + (1/3)*t245
    t388 = (1/2)*D_delta_x_1
    t389 = (1/2)*D_delta_y_1
    t390 = (1/2)*D_delta_z_1
    t391 = (1/3)*t247 + (1/3)*t248 + (1/3)*t249
    t392 = (1/3)*t251 + (1/3)*t252 + (1/3)*t253
    t393 = (1/2)*D_delta_x_2
    t394 = (1/2)*D_delta_y_2
    t395 = (1/2)*D_delta_z_2
    t396 = (1/3)*t255 + (1/3)*t256 + (1/3)*t257
    t397 = (1/2)*D_delta_x_3
    t398 = (1/2)*D_delta_y_3
    t399 = (1/2)*D_delta_z_3
    t400 = (1/3)*t175 + (1/3)*t176 + (1/3)*t177
    t401 = (1/3)*t179 + (1/3)*t180 + (1/3)*t181
    t402 = (1/3)*t183 + (1/3)*t184 + (1/3)*t185
    t403 = (1/3)*t187 + (1/3)*t188 + (1/3)*t189
    t404 = (1/3)*t191 + (1/3)*t192 + (1/3)*t193
    t405 = (1/3)*t195 + (1/3)*t196 + (1/3)*t197
    t406 = (1/3)*D_p_x_2 + t269
    t407 = (1/3)*D_p_y_2 + t274
    t408 = (1/3)*D_p_z_2 + t279
    t409 = (1/3)*D_p_x_3 + t284
    t410 = (1/3)*D_p_y_3 + t287
    t411 = (1/3)*D_p_z_3 + t290
    t412 = (1/12)*rho_b
    t413 = -R_p_1*t412
    t414 = t293*t311
    t415 = -R_p_2*t412
    t416 = t293*t342
    t417 = -R_p_3*t412
    t418 = t293*t351
    t419 = l_f_1_3*t293
    t420 = l_f_1_2*t293
    t421 = (2/3)*rho_b
    t422 = R_p_1*t421
    t423 = l_f_1_1*t422
    t424 = l_f_2_3*t293
    t425 = l_f_2_2*t293
    t426 = R_p_2*t421
    t427 = l_f_2_1*t426
    t428 = l_f_3_3*t293
    t429 = l_f_3_2*t293
    t430 = R_p_3*t421
    t431 = l_f_3_1*t430
    t432 = i_g_1**2
    t433 = d_1_1*t432
    t434 = d_1_2*t432
    t435 = i_g_2**2
    t436 = d_2_1*t435
    t437 = d_2_2*t435
    t438 = i_g_3**2
    t439 = d_3_1*t438
    t440 = d_3_2*t438
    t441 = 2*I_m_1*i_g_1
    t442 = d_1_1*t441
    t443 = d_1_2*t441
    t444 = 2*I_m_2*i_g_2
    t445 = d_2_1*t444
    t446 = d_2_2*t444
    t447 = 2*I_m_3*i_g_3
    t448 = d_3_1*t447
    t449 = d_3_2*t447
    t450 = t311*t421
    t451 = t342*t421
    t452 = t351*t421
    t453 = (1/3)*l_f_1_2
    t454 = (1/3)*l_f_1_3
    t455 = t453 + t454
    t456 = (1/6)*R_p_1
    t457 = l_f_1_3*t456
    t458 = l_f_1_2*t456
    t459 = (1/3)*l_f_2_2
    t460 = (1/3)*l_f_2_3
    t461 = t459 + t460
    t462 = (1/6)*R_p_2
    t463 = l_f_2_3*t462
    t464 = l_f_2_2*t462
    t465 = (1/3)*l_f_3_2
    t466 = (1/3)*l_f_3_3
    t467 = t465 + t466
    t468 = (1/6)*R_p_3
    t469 = l_f_3_3*t468
    t470 = l_f_3_2*t468
    t471 = l_f_1_1*t311
    t472 = (1/3)*t471
    t473 = l_f_2_1*t342
    t474 = (1/3)*t473
    t475 = l_f_3_1*t351
    t476 = (1/3)*t475
    t477 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    t478 = -U_2_x_1**2 - U_2_y_1**2 - U_2_z_1**2
    t479 = -U_3_x_1**2 - U_3_y_1**2 - U_3_z_1**2
    t480 = -U_1_x_1*U_1_x_2 - U_1_y_1*U_1_y_2 - U_1_z_1*U_1_z_2
    t481 = -U_2_x_1*U_2_x_2 - U_2_y_1*U_2_y_2 - U_2_z_1*U_2_z_2
    t482 = -U_3_x_1*U_3_x_2 - U_3_y_1*U_3_y_2 - U_3_z_1*U_3_z_2
    t483 = -U_1_x_1*U_1_x_3 - U_1_y_1*U_1_y_3 - U_1_z_1*U_1_z_3
    t484 = -U_2_x_1*U_2_x_3 - U_2_y_1*U_2_y_3 - U_2_z_1*U_2_z_3
    t485 = -U_3_x_1*U_3_x_3 - U_3_y_1*U_3_y_3 - U_3_z_1*U_3_z_3
    t486 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t487 = -D_delta_x_1*U_2_x_1 - D_delta_y_1*U_2_y_1 - D_delta_z_1*U_2_z_1
    t488 = -D_delta_x_1*U_3_x_1 - D_delta_y_1*U_3_y_1 - D_delta_z_1*U_3_z_1
    t489 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t490 = -D_delta_x_2*U_2_x_1 - D_delta_y_2*U_2_y_1 - D_delta_z_2*U_2_z_1
    t491 = -D_delta_x_2*U_3_x_1 - D_delta_y_2*U_3_y_1 - D_delta_z_2*U_3_z_1
    t492 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t493 = -D_delta_x_3*U_2_x_1 - D_delta_y_3*U_2_y_1 - D_delta_z_3*U_2_z_1
    t494 = -D_delta_x_3*U_3_x_1 - D_delta_y_3*U_3_y_1 - D_delta_z_3*U_3_z_1
    t495 = -U_1_x_2**2 - U_1_y_2**2 - U_1_z_2**2
    t496 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t497 = -U_3_x_2**2 - U_3_y_2**2 - U_3_z_2**2
    t498 = -U_1_x_2*U_1_x_3 - U_1_y_2*U_1_y_3 - U_1_z_2*U_1_z_3
    t499 = -U_2_x_2*U_2_x_3 - U_2_y_2*U_2_y_3 - U_2_z_2*U_2_z_3
    t500 = -U_3_x_2*U_3_x_3 - U_3_y_2*U_3_y_3 - U_3_z_2*U_3_z_3
    t501 = -D_delta_x_1*U_1_x_2 - D_delta_y_1*U_1_y_2 - D_delta_z_1*U_1_z_2
    t502 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t503 = -D_delta_x_1*U_3_x_2 - D_delta_y_1*U_3_y_2 - D_delta_z_1*U_3_z_2
    t504 = -D_delta_x_2*U_1_x_2 - D_delta_y_2*U_1_y_2 - D_delta_z_2*U_1_z_2
    t505 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t506 = -D_delta_x_2*U_3_x_2 - D_delta_y_2*U_3_y_2 - D_delta_z_2*U_3_z_2
    t507 = -D_delta_x_3*U_1_x_2 - D_delta_y_3*U_1_y_2 - D_delta_z_3*U_1_z_2
    t508 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t509 = -D_delta_x_3*U_3_x_2 - D_delta_y_3*U_3_y_2 - D_delta_z_3*U_3_z_2
    t510 = -U_1_x_3**2 - U_1_y_3**2 - U_1_z_3**2
    t511 = -U_2_x_3**2 - U_2_y_3**2 - U_2_z_3**2
    t512 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t513 = -D_delta_x_1*U_1_x_3 - D_delta_y_1*U_1_y_3 - D_delta_z_1*U_1_z_3
    t514 = -D_delta_x_1*U_2_x_3 - D_delta_y_1*U_2_y_3 - D_delta_z_1*U_2_z_3
    t515 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t516 = -D_delta_x_2*U_1_x_3 - D_delta_y_2*U_1_y_3 - D_delta_z_2*U_1_z_3
    t517 = -D_delta_x_2*U_2_x_3 - D_delta_y_2*U_2_y_3 - D_delta_z_2*U_2_z_3
    t518 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t519 = -D_delta_x_3*U_1_x_3 - D_delta_y_3*U_1_y_3 - D_delta_z_3*U_1_z_3
    t520 = -D_delta_x_3*U_2_x_3 - D_delta_y_3*U_2_y_3 - D_delta_z_3*U_2_z_3
    t521 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t522 = 1 - t238
    t523 = 1 - t250
    t524 = 1 - t258
    t525 = U_1_x_1*mu_1
    t526 = 2*D_p_x_1_by_b_1_x
    t527 = U_2_x_1*mu_2
    t528 = U_3_x_1*mu_3
    t529 = U_1_y_1*mu_1
    t530 = 2*D_p_y_1_by_b_1_x
    t531 = U_2_y_1*mu_2
    t532 = U_3_y_1*mu_3
    t533 = U_1_z_1*mu_1
    t534 = 2*D_p_z_1_by_b_1_x
    t535 = U_2_z_1*mu_2
    t536 = U_3_z_1*mu_3
    t537 = 1.0/(t18**2)
    t538 = t13*t537
    t539 = t538*x_1_by_b_1_x
    t540 = 1.0/(t20**2)
    t541 = U_1_x_2*mu_1
    t542 = U_2_x_2*mu_2
    t543 = U_3_x_2*mu_3
    t544 = U_1_y_2*mu_1
    t545 = U_2_y_2*mu_2
    t546 = U_3_y_2*mu_3
    t547 = U_1_z_2*mu_1
    t548 = U_2_z_2*mu_2
    t549 = U_3_z_2*mu_3
    t550 = U_1_x_3*mu_1
    t551 = U_2_x_3*mu_2
    t552 = U_3_x_3*mu_3
    t553 = U_1_y_3*mu_1
    t554 = U_2_y_3*mu_2
    t555 = U_3_y_3*mu_3
    t556 = U_1_z_3*mu_1
    t557 = U_2_z_3*mu_2
    t558 = U_3_z_3*mu_3
    t559 = t13*t540
    t560 = t559*x_1_by_b_1_x
    t561 = -R_p_1*t560
    t562 = R_p_1*t539
    t563 = D_p_x_1_by_b_1_x*k_C
    t564 = D_p_y_1_by_b_1_x*k_C
    t565 = D_p_z_1_by_b_1_x*k_C
    t566 = D_delta_x_1*mu_1
    t567 = D_delta_x_1*mu_2
    t568 = D_delta_x_1*mu_3
    t569 = D_delta_y_1*mu_1
    t570 = D_delta_y_1*mu_2
    t571 = D_delta_y_1*mu_3
    t572 = D_delta_z_1*mu_1
    t573 = D_delta_z_1*mu_2
    t574 = D_delta_z_1*mu_3
    t575 = D_p_x_1*k_C - t525 - t527 - t528
    t576 = D_p_y_1*k_C - t529 - t531 - t532
    t577 = D_p_z_1*k_C - t533 - t535 - t536
    t578 = D_delta_x_2*mu_1
    t579 = D_delta_x_2*mu_2
    t580 = D_delta_x_2*mu_3
    t581 = D_delta_y_2*mu_1
    t582 = D_delta_y_2*mu_2
    t583 = D_delta_y_2*mu_3
    t584 = D_delta_z_2*mu_1
    t585 = D_delta_z_2*mu_2
    t586 = D_delta_z_2*mu_3
    t587 = D_delta_x_3*mu_1
    t588 = D_delta_x_3*mu_2
    t589 = D_delta_x_3*mu_3
    t590 = D_delta_y_3*mu_1
    t591 = D_delta_y_3*mu_2
    t592 = D_delta_y_3*mu_3
    t593 = D_delta_z_3*mu_1
    t594 = D_delta_z_3*mu_2
    t595 = D_delta_z_3*mu_3
    t596 = -t539 + t560
    t597 = 2*D_p_x_2_by_b_1_x
    t598 = 2*D_p_y_2_by_b_1_x
    t599 = 2*D_p_z_2_by_b_1_x
    t600 = D_p_x_2_by_b_1_x*k_C
    t601 = D_p_y_2_by_b_1_x*k_C
    t602 = D_p_z_2_by_b_1_x*k_C
    t603 = D_p_x_2*k_C - t541 - t542 - t543
    t604 = D_p_y_2*k_C - t544 - t545 - t546
    t605 = D_p_z_2*k_C - t547 - t548 - t549
    t606 = 2*D_p_x_3_by_b_1_x
    t607 = 2*D_p_y_3_by_b_1_x
    t608 = 2*D_p_z_3_by_b_1_x
    t609 = D_p_x_3_by_b_1_x*k_C
    t610 = D_p_y_3_by_b_1_x*k_C
    t611 = D_p_z_3_by_b_1_x*k_C
    t612 = D_p_x_3*k_C - t550 - t551 - t552
    t613 = D_p_y_3*k_C - t553 - t554 - t555
    t614 = D_p_z_3*k_C - t556 - t557 - t558
    t615 = 2*D_delta_x_1*k_C - 2*t566 - 2*t567 - 2*t568
    t616 = 2*D_delta_y_1*k_C - 2*t569 - 2*t570 - 2*t571
    t617 = 2*D_delta_z_1*k_C - 2*t572 - 2*t573 - 2*t574
    t618 = D_delta_x_2*k_C - t578 - t579 - t580
    t619 = D_delta_x_1*k_C - t566 - t567 - t568
    t620 = D_delta_y_2*k_C - t581 - t582 - t583
    t621 = D_delta_y_1*k_C - t569 - t570 - t571
    t622 = D_delta_z_2*k_C - t584 - t585 - t586
    t623 = D_delta_z_1*k_C - t572 - t573 - t574
    t624 = D_delta_x_3*k_C - t587 - t588 - t589
    t625 = D_delta_y_3*k_C - t590 - t591 - t592
    t626 = D_delta_z_3*k_C - t593 - t594 - t595
    t627 = 2*D_delta_x_2*k_C - 2*t578 - 2*t579 - 2*t580
    t628 = 2*D_delta_y_2*k_C - 2*t581 - 2*t582 - 2*t583
    t629 = 2*D_delta_z_2*k_C - 2*t584 - 2*t585 - 2*t586
    t630 = 2*D_delta_x_3*k_C - 2*t587 - 2*t588 - 2*t589
    t631 = 2*D_delta_y_3*k_C - 2*t590 - 2*t591 - 2*t592
    t632 = 2*D_delta_z_3*k_C - 2*t593 - 2*t594 - 2*t595
    t633 = 2*D_p_x_1_by_b_1_y
    t634 = 2*D_p_y_1_by_b_1_y
    t635 = 2*D_p_z_1_by_b_1_y
    t636 = t538*x_1_by_b_1_y
    t637 = t559*x_1_by_b_1_y
    t638 = -R_p_1*t637
    t639 = R_p_1*t636
    t640 = D_delta_x_1*k_C
    t641 = D_delta_y_1*k_C
    t642 = D_delta_z_1*k_C
    t643 = D_delta_x_2*k_C
    t644 = D_delta_y_2*k_C
    t645 = D_delta_z_2*k_C
    t646 = D_delta_x_3*k_C
    t647 = D_delta_y_3*k_C
    t648 = D_delta_z_3*k_C
    t649 = -t636 + t637
    t650 = 2*D_p_x_2_by_b_1_y
    t651 = 2*D_p_y_2_by_b_1_y
    t652 = 2*D_p_z_2_by_b_1_y
    t653 = 2*D_p_x_3_by_b_1_y
    t654 = 2*D_p_y_3_by_b_1_y
    t655 = 2*D_p_z_3_by_b_1_y
    t656 = 2*D_p_x_1_by_b_1_z
    t657 = 2*D_p_y_1_by_b_1_z
    t658 = 2*D_p_z_1_by_b_1_z
    t659 = t538*x_1_by_b_1_z
    t660 = t559*x_1_by_b_1_z
    t661 = -R_p_1*t660
    t662 = R_p_1*t659
    t663 = -t659 + t660
    t664 = 2*D_p_x_2_by_b_1_z
    t665 = 2*D_p_y_2_by_b_1_z
    t666 = 2*D_p_z_2_by_b_1_z
    t667 = 2*D_p_x_3_by_b_1_z
    t668 = 2*D_p_y_3_by_b_1_z
    t669 = 2*D_p_z_3_by_b_1_z
    t670 = 2*D_p_x_1_by_b_2_x
    t671 = 2*D_p_y_1_by_b_2_x
    t672 = 2*D_p_z_1_by_b_2_x
    t673 = 2*D_p_x_2_by_b_2_x
    t674 = 2*D_p_y_2_by_b_2_x
    t675 = 2*D_p_z_2_by_b_2_x
    t676 = 1.0/(t29**2)
    t677 = t24*t676
    t678 = t677*x_2_by_b_2_x
    t679 = 1.0/(t31**2)
    t680 = t24*t679
    t681 = t680*x_2_by_b_2_x
    t682 = -R_p_2*t681
    t683 = R_p_2*t678
    t684 = -t678 + t681
    t685 = 2*D_p_x_3_by_b_2_x
    t686 = 2*D_p_y_3_by_b_2_x
    t687 = 2*D_p_z_3_by_b_2_x
    t688 = 2*D_p_x_1_by_b_2_y
    t689 = 2*D_p_y_1_by_b_2_y
    t690 = 2*D_p_z_1_by_b_2_y
    t691 = 2*D_p_x_2_by_b_2_y
    t692 = 2*D_p_y_2_by_b_2_y
    t693 = 2*D_p_z_2_by_b_2_y
    t694 = t677*x_2_by_b_2_y
    t695 = t680*x_2_by_b_2_y
    t696 = -R_p_2*t695
    t697 = R_p_2*t694
    t698 = -t694 + t695
    t699 = 2*D_p_x_3_by_b_2_y
    t700 = 2*D_p_y_3_by_b_2_y
    t701 = 2*D_p_z_3_by_b_2_y
    t702 = 2*D_p_x_1_by_b_2_z
    t703 = 2*D_p_y_1_by_b_2_z
    t704 = 2*D_p_z_1_by_b_2_z
    t705 = 2*D_p_x_2_by_b_2_z
    t706 = 2*D_p_y_2_by_b_2_z
    t707 = 2*D_p_z_2_by_b_2_z
    t708 = t677*x_2_by_b_2_z
    t709 = t680*x_2_by_b_2_z
    t710 = -R_p_2*t709
    t711 = R_p_2*t708
    t712 = -t708 + t709
    t713 = 2*D_p_x_3_by_b_2_z
    t714 = 2*D_p_y_3_by_b_2_z
    t715 = 2*D_p_z_3_by_b_2_z
    t716 = 2*D_p_x_1_by_b_3_x
    t717 = 2*D_p_y_1_by_b_3_x
    t718 = 2*D_p_z_1_by_b_3_x
    t719 = 2*D_p_x_2_by_b_3_x
    t720 = 2*D_p_y_2_by_b_3_x
    t721 = 2*D_p_z_2_by_b_3_x
    t722 = 2*D_p_x_3_by_b_3_x
    t723 = 2*D_p_y_3_by_b_3_x
    t724 = 2*D_p_z_3_by_b_3_x
    t725 = 1.0/(t40**2)
    t726 = t35*t725
    t727 = t726*x_3_by_b_3_x
    t728 = 1.0/(t42**2)
    t729 = t35*t728
    t730 = t729*x_3_by_b_3_x
    t731 = -R_p_3*t730
    t732 = R_p_3*t727
    t733 = -t727 + t730
    t734 = 2*D_p_x_1_by_b_3_y
    t735 = 2*D_p_y_1_by_b_3_y
    t736 = 2*D_p_z_1_by_b_3_y
    t737 = 2*D_p_x_2_by_b_3_y
    t738 = 2*D_p_y_2_by_b_3_y
    t739 = 2*D_p_z_2_by_b_3_y
    t740 = 2*D_p_x_3_by_b_3_y
    t741 = 2*D_p_y_3_by_b_3_y
    t742 = 2*D_p_z_3_by_b_3_y
    t743 = t726*x_3_by_b_3_y
    t744 = t729*x_3_by_b_3_y
    t745 = -R_p_3*t744
    t746 = R_p_3*t743
    t747 = -t743 + t744
    t748 = 2*D_p_x_1_by_b_3_z
    t749 = 2*D_p_y_1_by_b_3_z
    t750 = 2*D_p_z_1_by_b_3_z
    t751 = 2*D_p_x_2_by_b_3_z
    t752 = 2*D_p_y_2_by_b_3_z
    t753 = 2*D_p_z_2_by_b_3_z
    t754 = 2*D_p_x_3_by_b_3_z
    t755 = 2*D_p_y_3_by_b_3_z
    t756 = 2*D_p_z_3_by_b_3_z
    t757 = t726*x_3_by_b_3_z
    t758 = t729*x_3_by_b_3_z
    t759 = -R_p_3*t758
    t760 = R_p_3*t757
    t761 = -t757 + t758
    t762 = 2*D_p_x_1_by_l_d_1
    t763 = 2*D_p_y_1_by_l_d_1
    t764 = 2*D_p_z_1_by_l_d_1
    t765 = t538*x_1_by_l_d_1
    t766 = t559*x_1_by_l_d_1
    t767 = -R_p_1*t766
    t768 = R_p_1*t765
    t769 = -t765 + t766
    t770 = 2*D_p_x_2_by_l_d_1
    t771 = 2*D_p_y_2_by_l_d_1
    t772 = 2*D_p_z_2_by_l_d_1
    t773 = 2*D_p_x_3_by_l_d_1
    t774 = 2*D_p_y_3_by_l_d_1
    t775 = 2*D_p_z_3_by_l_d_1
    t776 = 2*D_p_x_1_by_l_d_2
    t777 = 2*D_p_y_1_by_l_d_2
    t778 = 2*D_p_z_1_by_l_d_2
    t779 = 2*D_p_x_2_by_l_d_2
    t780 = 2*D_p_y_2_by_l_d_2
    t781 = 2*D_p_z_2_by_l_d_2
    t782 = t677*x_2_by_l_d_2
    t783 = t680*x_2_by_l_d_2
    t784 = -R_p_2*t783
    t785 = R_p_2*t782
    t786 = -t782 + t783
    t787 = 2*D_p_x_3_by_l_d_2
    t788 = 2*D_p_y_3_by_l_d_2
    t789 = 2*D_p_z_3_by_l_d_2
    t790 = 2*D_p_x_1_by_l_d_3
    t791 = 2*D_p_y_1_by_l_d_3
    t792 = 2*D_p_z_1_by_l_d_3
    t793 = 2*D_p_x_2_by_l_d_3
    t794 = 2*D_p_y_2_by_l_d_3
    t795 = 2*D_p_z_2_by_l_d_3
    t796 = 2*D_p_x_3_by_l_d_3
    t797 = 2*D_p_y_3_by_l_d_3
    t798 = 2*D_p_z_3_by_l_d_3
    t799 = t726*x_3_by_l_d_3
    t800 = t729*x_3_by_l_d_3
    t801 = -R_p_3*t800
    t802 = R_p_3*t799
    t803 = -t799 + t800
    t804 = (1/2)*t538
    t805 = (1/2)*t559
    t806 = t804 + t805
    t807 = -R_p_1*t805
    t808 = -R_p_1*t804
    t809 = (1/2)*t677
    t810 = (1/2)*t680
    t811 = t809 + t810
    t812 = -R_p_2*t810
    t813 = -R_p_2*t809
    t814 = (1/2)*t726
    t815 = (1/2)*t729
    t816 = t814 + t815
    t817 = -R_p_3*t815
    t818 = -R_p_3*t814
    t819 = w_b_1**2
    t820 = t11**2
    t821 = t819*t820
    t822 = k_sp_1*t821
    t823 = c_E*t822
    t824 = -t11*t21*w_b_1 + t540*t823
    t825 = c_E*t537
    t826 = -t11*t19*w_b_1 + t822*t825
    t827 = -t824 - t826
    t828 = R_p_1*t824
    t829 = R_p_1*t826
    t830 = 1.0/(t15**2)
    t831 = t311*(t11*t16*w_b_1 - t823*t830)
    t832 = w_b_2**2
    t833 = t22**2
    t834 = t832*t833
    t835 = k_sp_2*t834
    t836 = c_E*t835
    t837 = -t22*t32*w_b_2 + t679*t836
    t838 = c_E*t676
    t839 = -t22*t30*w_b_2 + t835*t838
    t840 = -t837 - t839
    t841 = R_p_2*t837
    t842 = R_p_2*t839
    t843 = 1.0/(t26**2)
    t844 = t342*(t22*t27*w_b_2 - t836*t843)
    t845 = w_b_3**2
    t846 = t33**2
    t847 = t845*t846
    t848 = k_sp_3*t847
    t849 = c_E*t848
    t850 = -t33*t43*w_b_3 + t728*t849
    t851 = c_E*t725
    t852 = -t33*t41*w_b_3 + t848*t851
    t853 = -t850 - t852
    t854 = R_p_3*t850
    t855 = R_p_3*t852
    t856 = 1.0/(t37**2)
    t857 = t351*(t33*t38*w_b_3 - t849*t856)
    t858 = t820*w_b_1
    t859 = k_sp_1**2
    t860 = c_E*t859
    t861 = t858*t860
    t862 = -k_sp_1*t11*t21 + t540*t861
    t863 = t825*t859
    t864 = -k_sp_1*t11*t19 + t858*t863
    t865 = -t862 - t864
    t866 = R_p_1*t862
    t867 = R_p_1*t864
    t868 = t311*(k_sp_1*t11*t16 - t830*t861)
    t869 = t833*w_b_2
    t870 = k_sp_2**2
    t871 = c_E*t870
    t872 = t869*t871
    t873 = -k_sp_2*t22*t32 + t679*t872
    t874 = t838*t870
    t875 = -k_sp_2*t22*t30 + t869*t874
    t876 = -t873 - t875
    t877 = R_p_2*t873
    t878 = R_p_2*t875
    t879 = t342*(k_sp_2*t22*t27 - t843*t872)
    t880 = t846*w_b_3
    t881 = k_sp_3**2
    t882 = c_E*t881
    t883 = t880*t882
    t884 = -k_sp_3*t33*t43 + t728*t883
    t885 = t851*t881
    t886 = -k_sp_3*t33*t41 + t880*t885
    t887 = -t884 - t886
    t888 = R_p_3*t884
    t889 = R_p_3*t886
    t890 = t351*(k_sp_3*t33*t38 - t856*t883)
    t891 = 2*R_p_1
    t892 = k_1_1*t891
    t893 = 2*R_p_2
    t894 = k_2_1*t893
    t895 = 2*R_p_3
    t896 = k_3_1*t895
    t897 = -R_p_1*t538
    t898 = t311*t830
    t899 = t13*t898
    t900 = -R_p_2*t677
    t901 = t342*t843
    t902 = t24*t901
    t903 = -R_p_3*t726
    t904 = t351*t856
    t905 = t35*t904
    t906 = R_p_1*t559
    t907 = R_p_2*t680
    t908 = R_p_3*t729
    t909 = t11*t819
    t910 = t860*t909
    t911 = -k_sp_1*t21*w_b_1 + t540*t910
    t912 = -k_sp_1*t19*w_b_1 + t863*t909
    t913 = -t911 - t912
    t914 = R_p_1*t911
    t915 = R_p_1*t912
    t916 = t311*(k_sp_1*t16*w_b_1 - t830*t910)
    t917 = t22*t832
    t918 = t871*t917
    t919 = -k_sp_2*t32*w_b_2 + t679*t918
    t920 = -k_sp_2*t30*w_b_2 + t874*t917
    t921 = -t919 - t920
    t922 = R_p_2*t919
    t923 = R_p_2*t920
    t924 = t342*(k_sp_2*t27*w_b_2 - t843*t918)
    t925 = t33*t845
    t926 = t882*t925
    t927 = -k_sp_3*t43*w_b_3 + t728*t926
    t928 = -k_sp_3*t41*w_b_3 + t885*t925
    t929 = -t927 - t928
    t930 = R_p_3*t927
    t931 = R_p_3*t928
    t932 = t351*(k_sp_3*t38*w_b_3 - t856*t926)
    t933 = t821*t859
    t934 = t537*t933
    t935 = t540*t933
    t936 = -t934 - t935
    t937 = R_p_1*t935
    t938 = R_p_1*t934
    t939 = t834*t870
    t940 = t676*t939
    t941 = t679*t939
    t942 = -t940 - t941
    t943 = R_p_2*t941
    t944 = R_p_2*t940
    t945 = t847*t881
    t946 = t725*t945
    t947 = t728*t945
    t948 = -t946 - t947
    t949 = R_p_3*t947
    t950 = R_p_3*t946
    t951 = t898*t933
    t952 = t901*t939
    t953 = t904*t945
    M_theta_out = _listed(batch, dtype, (
        t178, t182, t186, t190, t194, t198, D_p_x_1, D_p_y_1, D_p_z_1, t202, t206, t210, t214, t218, D_p_x_2,
        D_p_y_2, D_p_z_2, t222, t226, t230, t234, D_p_x_3, D_p_y_3, D_p_z_3, t238, t242, t246, D_delta_x_1,
        D_delta_y_1, D_delta_z_1, t250, t254, D_delta_x_2, D_delta_y_2, D_delta_z_2, t258, D_delta_x_3,
        D_delta_y_3, D_delta_z_3, 1, 1, 1,
        D_p_x_1_by_b_1_x*t264 + D_p_y_1_by_b_1_x*t266 + D_p_z_1_by_b_1_x*t268,
        D_p_x_1_by_b_1_x*t271 + D_p_x_2_by_b_1_x*t273 + D_p_y_1_by_b_1_x*t276 + D_p_y_2_by_b_1_x*t278
        + D_p_z_1_by_b_1_x*t281 + D_p_z_2_by_b_1_x*t283,
        D_p_x_1_by_b_1_x*t286 + D_p_x_3_by_b_1_x*t273 + D_p_y_1_by_b_1_x*t289 + D_p_y_3_by_b_1_x*t278
        + D_p_z_1_by_b_1_x*t292 + D_p_z_3_by_b_1_x*t283,
        -t295, t295,
        D_delta_x_1*t296 + D_delta_x_1_by_b_1_x*t273 + D_delta_y_1*t297 + D_delta_y_1_by_b_1_x*t278
        + D_delta_z_1*t298 + D_delta_z_1_by_b_1_x*t283,
        D_delta_x_2*t296 + D_delta_x_2_by_b_1_x*t273 + D_delta_y_2*t297 + D_delta_y_2_by_b_1_x*t278
        + D_delta_z_2*t298 + D_delta_z_2_by_b_1_x*t283,
        D_delta_x_3*t296 + D_delta_x_3_by_b_1_x*t273 + D_delta_y_3*t297 + D_delta_y_3_by_b_1_x*t278
        + D_delta_z_3*t298 + D_delta_z_3_by_b_1_x*t283,
        D_p_x_1_by_b_1_x*t45, D_p_y_1_by_b_1_x*t45, D_p_z_1_by_b_1_x*t45,
        D_p_x_2_by_b_1_x*t299 + D_p_y_2_by_b_1_x*t300 + D_p_z_2_by_b_1_x*t301,
        D_p_x_2_by_b_1_x*t286 + D_p_x_3_by_b_1_x*t271 + D_p_y_2_by_b_1_x*t289 + D_p_y_3_by_b_1_x*t276
        + D_p_z_2_by_b_1_x*t292 + D_p_z_3_by_b_1_x*t281,
        D_delta_x_1*t302 + D_delta_x_1_by_b_1_x*t271 + D_delta_y_1*t303 + D_delta_y_1_by_b_1_x*t276
        + D_delta_z_1*t304 + D_delta_z_1_by_b_1_x*t281,
        D_delta_x_2*t302 + D_delta_x_2_by_b_1_x*t271 + D_delta_y_2*t303 + D_delta_y_2_by_b_1_x*t276
        + D_delta_z_2*t304 + D_delta_z_2_by_b_1_x*t281,
        D_delta_x_3*t302 + D_delta_x_3_by_b_1_x*t271 + D_delta_y_3*t303 + D_delta_y_3_by_b_1_x*t276
        + D_delta_z_3*t304 + D_delta_z_3_by_b_1_x*t281,
        D_p_x_2_by_b_1_x*t45, D_p_y_2_by_b_1_x*t45, D_p_z_2_by_b_1_x*t45,
        D_p_x_3_by_b_1_x*t305 + D_p_y_3_by_b_1_x*t306 + D_p_z_3_by_b_1_x*t307,
        D_delta_x_1*t308 + D_delta_x_1_by_b_1_x*t286 + D_delta_y_1*t309 + D_delta_y_1_by_b_1_x*t289
        + D_delta_z_1*t310 + D_delta_z_1_by_b_1_x*t292,
        D_delta_x_2*t308 + D_delta_x_2_by_b_1_x*t286 + D_delta_y_2*t309 + D_delta_y_2_by_b_1_x*t289
        + D_delta_z_2*t310 + D_delta_z_2_by_b_1_x*t292,
        D_delta_x_3*t308 + D_delta_x_3_by_b_1_x*t286 + D_delta_y_3*t309 + D_delta_y_3_by_b_1_x*t289
        + D_delta_z_3*t310 + D_delta_z_3_by_b_1_x*t292,
        D_p_x_3_by_b_1_x*t45, D_p_y_3_by_b_1_x*t45, D_p_z_3_by_b_1_x*t45, -t314, -t295, t314, t295,
        D_delta_x_1_by_b_1_x*t316 + D_delta_y_1_by_b_1_x*t318 + D_delta_z_1_by_b_1_x*t320,
        D_delta_x_2*t321 + D_delta_x_2_by_b_1_x*t315 + D_delta_y_2*t322 + D_delta_y_2_by_b_1_x*t317
        + D_delta_z_2*t323 + D_delta_z_2_by_b_1_x*t319,
        D_delta_x_3*t321 + D_delta_x_3_by_b_1_x*t315 + D_delta_y_3*t322 + D_delta_y_3_by_b_1_x*t317
        + D_delta_z_3*t323 + D_delta_z_3_by_b_1_x*t319,
        D_delta_x_1_by_b_1_x*t45, D_delta_y_1_by_b_1_x*t45, D_delta_z_1_by_b_1_x*t45,
        D_delta_x_2_by_b_1_x*t325 + D_delta_y_2_by_b_1_x*t327 + D_delta_z_2_by_b_1_x*t329,
        D_delta_x_2_by_b_1_x*t330 + D_delta_x_3_by_b_1_x*t324 + D_delta_y_2_by_b_1_x*t331
        + D_delta_y_3_by_b_1_x*t326 + D_delta_z_2_by_b_1_x*t332 + D_delta_z_3_by_b_1_x*t328,
        D_delta_x_2_by_b_1_x*t45, D_delta_y_2_by_b_1_x*t45, D_delta_z_2_by_b_1_x*t45,
        D_delta_x_3_by_b_1_x*t333 + D_delta_y_3_by_b_1_x*t334 + D_delta_z_3_by_b_1_x*t335,
        D_delta_x_3_by_b_1_x*t45, D_delta_y_3_by_b_1_x*t45, D_delta_z_3_by_b_1_x*t45,
        D_p_x_1_by_b_1_y*t264 + D_p_y_1_by_b_1_y*t266 + D_p_z_1_by_b_1_y*t268,
        D_p_x_1_by_b_1_y*t271 + D_p_x_2_by_b_1_y*t273 + D_p_y_1_by_b_1_y*t276 + D_p_y_2_by_b_1_y*t278
        + D_p_z_1_by_b_1_y*t281 + D_p_z_2_by_b_1_y*t283,
        D_p_x_1_by_b_1_y*t286 + D_p_x_3_by_b_1_y*t273 + D_p_y_1_by_b_1_y*t289 + D_p_y_3_by_b_1_y*t278
        + D_p_z_1_by_b_1_y*t292 + D_p_z_3_by_b_1_y*t283,
        -t336, t336,
        D_delta_x_1_by_b_1_y*t273 + D_delta_y_1_by_b_1_y*t278 + D_delta_z_1_by_b_1_y*t283
        + D_p_x_1_by_b_1_y*t315 + D_p_y_1_by_b_1_y*t317 + D_p_z_1_by_b_1_y*t319,
        D_delta_x_2_by_b_1_y*t273 + D_delta_y_2_by_b_1_y*t278 + D_delta_z_2_by_b_1_y*t283
        + D_p_x_1_by_b_1_y*t324 + D_p_y_1_by_b_1_y*t326 + D_p_z_1_by_b_1_y*t328,
        D_delta_x_3_by_b_1_y*t273 + D_delta_y_3_by_b_1_y*t278 + D_delta_z_3_by_b_1_y*t283
        + D_p_x_1_by_b_1_y*t330 + D_p_y_1_by_b_1_y*t331 + D_p_z_1_by_b_1_y*t332,
        D_p_x_1_by_b_1_y*t45, D_p_y_1_by_b_1_y*t45, D_p_z_1_by_b_1_y*t45,
        D_p_x_2_by_b_1_y*t299 + D_p_y_2_by_b_1_y*t300 + D_p_z_2_by_b_1_y*t301,
        D_p_x_2_by_b_1_y*t286 + D_p_x_3_by_b_1_y*t271 + D_p_y_2_by_b_1_y*t289 + D_p_y_3_by_b_1_y*t276
        + D_p_z_2_by_b_1_y*t292 + D_p_z_3_by_b_1_y*t281,
        D_delta_x_1_by_b_1_y*t271 + D_delta_y_1_by_b_1_y*t276 + D_delta_z_1_by_b_1_y*t281
        + D_p_x_2_by_b_1_y*t315 + D_p_y_2_by_b_1_y*t317 + D_p_z_2_by_b_1_y*t319,
        D_delta_x_2_by_b_1_y*t271 + D_delta_y_2_by_b_1_y*t276 + D_delta_z_2_by_b_1_y*t281
        + D_p_x_2_by_b_1_y*t324 + D_p_y_2_by_b_1_y*t326 + D_p_z_2_by_b_1_y*t328,
        D_delta_x_3_by_b_1_y*t271 + D_delta_y_3_by_b_1_y*t276 + D_delta_z_3_by_b_1_y*t281
        + D_p_x_2_by_b_1_y*t330 + D_p_y_2_by_b_1_y*t331 + D_p_z_2_by_b_1_y*t332,
        D_p_x_2_by_b_1_y*t45, D_p_y_2_by_b_1_y*t45, D_p_z_2_by_b_1_y*t45,
        D_p_x_3_by_b_1_y*t305 + D_p_y_3_by_b_1_y*t306 + D_p_z_3_by_b_1_y*t307,
        D_delta_x_1_by_b_1_y*t286 + D_delta_y_1_by_b_1_y*t289 + D_delta_z_1_by_b_1_y*t292
        + D_p_x_3_by_b_1_y*t315 + D_p_y_3_by_b_1_y*t317 + D_p_z_3_by_b_1_y*t319,
        D_delta_x_2_by_b_1_y*t286 + D_delta_y_2_by_b_1_y*t289 + D_delta_z_2_by_b_1_y*t292
        + D_p_x_3_by_b_1_y*t324 + D_p_y_3_by_b_1_y*t326 + D_p_z_3_by_b_1_y*t328,
        D_delta_x_3_by_b_1_y*t286 + D_delta_y_3_by_b_1_y*t289 + D_delta_z_3_by_b_1_y*t292
        + D_p_x_3_by_b_1_y*t330 + D_p_y_3_by_b_1_y*t331 + D_p_z_3_by_b_1_y*t332,
        D_p_x_3_by_b_1_y*t45, D_p_y_3_by_b_1_y*t45, D_p_z_3_by_b_1_y*t45, -t337, -t336, t337, t336,
        D_delta_x_1_by_b_1_y*t316 + D_delta_y_1_by_b_1_y*t318 + D_delta_z_1_by_b_1_y*t320,
        D_delta_x_1_by_b_1_y*t324 + D_delta_x_2_by_b_1_y*t315 + D_delta_y_1_by_b_1_y*t326
        + D_delta_y_2_by_b_1_y*t317 + D_delta_z_1_by_b_1_y*t328 + D_delta_z_2_by_b_1_y*t319,
        D_delta_x_1_by_b_1_y*t330 + D_delta_x_3_by_b_1_y*t315 + D_delta_y_1_by_b_1_y*t331
        + D_delta_y_3_by_b_1_y*t317 + D_delta_z_1_by_b_1_y*t332 + D_delta_z_3_by_b_1_y*t319,
        D_delta_x_1_by_b_1_y*t45, D_delta_y_1_by_b_1_y*t45, D_delta_z_1_by_b_1_y*t45,
        D_delta_x_2_by_b_1_y*t325 + D_delta_y_2_by_b_1_y*t327 + D_delta_z_2_by_b_1_y*t329,
        D_delta_x_2_by_b_1_y*t330 + D_delta_x_3_by_b_1_y*t324 + D_delta_y_2_by_b_1_y*t331
        + D_delta_y_3_by_b_1_y*t326 + D_delta_z_2_by_b_1_y*t332 + D_delta_z_3_by_b_1_y*t328,
        D_delta_x_2_by_b_1_y*t45, D_delta_y_2_by_b_1_y*t45, D_delta_z_2_by_b_1_y*t45,
        D_delta_x_3_by_b_1_y*t333 + D_delta_y_3_by_b_1_y*t334 + D_delta_z_3_by_b_1_y*t335,
        D_delta_x_3_by_b_1_y*t45, D_delta_y_3_by_b_1_y*t45, D_delta_z_3_by_b_1_y*t45,
        D_p_x_1_by_b_1_z*t264 + D_p_y_1_by_b_1_z*t266 + D_p_z_1_by_b_1_z*t268,
        D_p_x_1_by_b_1_z*t271 + D_p_x_2_by_b_1_z*t273 + D_p_y_1_by_b_1_z*t276 + D_p_y_2_by_b_1_z*t278
        + D_p_z_1_by_b_1_z*t281 + D_p_z_2_by_b_1_z*t283,
        D_p_x_1_by_b_1_z*t286 + D_p_x_3_by_b_1_z*t273 + D_p_y_1_by_b_1_z*t289 + D_p_y_3_by_b_1_z*t278
        + D_p_z_1_by_b_1_z*t292 + D_p_z_3_by_b_1_z*t283,
        -t338, t338,
        D_delta_x_1_by_b_1_z*t273 + D_delta_y_1_by_b_1_z*t278 + D_delta_z_1_by_b_1_z*t283
        + D_p_x_1_by_b_1_z*t315 + D_p_y_1_by_b_1_z*t317 + D_p_z_1_by_b_1_z*t319,
        D_delta_x_2_by_b_1_z*t273 + D_delta_y_2_by_b_1_z*t278 + D_delta_z_2_by_b_1_z*t283
        + D_p_x_1_by_b_1_z*t324 + D_p_y_1_by_b_1_z*t326 + D_p_z_1_by_b_1_z*t328,
        D_delta_x_3_by_b_1_z*t273 + D_delta_y_3_by_b_1_z*t278 + D_delta_z_3_by_b_1_z*t283
        + D_p_x_1_by_b_1_z*t330 + D_p_y_1_by_b_1_z*t331 + D_p_z_1_by_b_1_z*t332,
        D_p_x_1_by_b_1_z*t45, D_p_y_1_by_b_1_z*t45, D_p_z_1_by_b_1_z*t45,
        D_p_x_2_by_b_1_z*t299 + D_p_y_2_by_b_1_z*t300 + D_p_z_2_by_b_1_z*t301,
        D_p_x_2_by_b_1_z*t286 + D_p_x_3_by_b_1_z*t271 + D_p_y_2_by_b_1_z*t289 + D_p_y_3_by_b_1_z*t276
        + D_p_z_2_by_b_1_z*t292 + D_p_z_3_by_b_1_z*t281,
        D_delta_x_1_by_b_1_z*t271 + D_delta_y_1_by_b_1_z*t276 + D_delta_z_1_by_b_1_z*t281
        + D_p_x_2_by_b_1_z*t315 + D_p_y_2_by_b_1_z*t317 + D_p_z_2_by_b_1_z*t319,
        D_delta_x_2_by_b_1_z*t271 + D_delta_y_2_by_b_1_z*t276 + D_delta_z_2_by_b_1_z*t281
        + D_p_x_2_by_b_1_z*t324 + D_p_y_2_by_b_1_z*t326 + D_p_z_2_by_b_1_z*t328,
        D_delta_x_3_by_b_1_z*t271 + D_delta_y_3_by_b_1_z*t276 + D_delta_z_3_by_b_1_z*t281
        + D_p_x_2_by_b_1_z*t330 + D_p_y_2_by_b_1_z*t331 + D_p_z_2_by_b_1_z*t332,
        D_p_x_2_by_b_1_z*t45, D_p_y_2_by_b_1_z*t45, D_p_z_2_by_b_1_z*t45,
        D_p_x_3_by_b_1_z*t305 + D_p_y_3_by_b_1_z*t306 + D_p_z_3_by_b_1_z*t307,
        D_delta_x_1_by_b_1_z*t286 + D_delta_y_1_by_b_1_z*t289 + D_delta_z_1_by_b_1_z*t292
        + D_p_x_3_by_b_1_z*t315 + D_p_y_3_by_b_1_z*t317 + D_p_z_3_by_b_1_z*t319,
        D_delta_x_2_by_b_1_z*t286 + D_delta_y_2_by_b_1_z*t289 + D_delta_z_2_by_b_1_z*t292
        + D_p_x_3_by_b_1_z*t324 + D_p_y_3_by_b_1_z*t326 + D_p_z_3_by_b_1_z*t328,
        D_delta_x_3_by_b_1_z*t286 + D_delta_y_3_by_b_1_z*t289 + D_delta_z_3_by_b_1_z*t292
        + D_p_x_3_by_b_1_z*t330 + D_p_y_3_by_b_1_z*t331 + D_p_z_3_by_b_1_z*t332,
        D_p_x_3_by_b_1_z*t45, D_p_y_3_by_b_1_z*t45, D_p_z_3_by_b_1_z*t45, -t339, -t338, t339, t338,
        D_delta_x_1_by_b_1_z*t316 + D_delta_y_1_by_b_1_z*t318 + D_delta_z_1_by_b_1_z*t320,
        D_delta_x_1_by_b_1_z*t324 + D_delta_x_2_by_b_1_z*t315 + D_delta_y_1_by_b_1_z*t326
        + D_delta_y_2_by_b_1_z*t317 + D_delta_z_1_by_b_1_z*t328 + D_delta_z_2_by_b_1_z*t319,
        D_delta_x_1_by_b_1_z*t330 + D_delta_x_3_by_b_1_z*t315 + D_delta_y_1_by_b_1_z*t331
        + D_delta_y_3_by_b_1_z*t317 + D_delta_z_1_by_b_1_z*t332 + D_delta_z_3_by_b_1_z*t319,
        D_delta_x_1_by_b_1_z*t45, D_delta_y_1_by_b_1_z*t45, D_delta_z_1_by_b_1_z*t45,
        D_delta_x_2_by_b_1_z*t325 + D_delta_y_2_by_b_1_z*t327 + D_delta_z_2_by_b_1_z*t329,
        D_delta_x_2_by_b_1_z*t330 + D_delta_x_3_by_b_1_z*t324 + D_delta_y_2_by_b_1_z*t331
        + D_delta_y_3_by_b_1_z*t326 + D_delta_z_2_by_b_1_z*t332 + D_delta_z_3_by_b_1_z*t328,
        D_delta_x_2_by_b_1_z*t45, D_delta_y_2_by_b_1_z*t45, D_delta_z_2_by_b_1_z*t45,
        D_delta_x_3_by_b_1_z*t333 + D_delta_y_3_by_b_1_z*t334 + D_delta_z_3_by_b_1_z*t335,
        D_delta_x_3_by_b_1_z*t45, D_delta_y_3_by_b_1_z*t45, D_delta_z_3_by_b_1_z*t45,
        D_p_x_1_by_b_2_x*t264 + D_p_y_1_by_b_2_x*t266 + D_p_z_1_by_b_2_x*t268,
        D_p_x_1_by_b_2_x*t271 + D_p_x_2_by_b_2_x*t273 + D_p_y_1_by_b_2_x*t276 + D_p_y_2_by_b_2_x*t278
        + D_p_z_1_by_b_2_x*t281 + D_p_z_2_by_b_2_x*t283,
        D_p_x_1_by_b_2_x*t286 + D_p_x_3_by_b_2_x*t273 + D_p_y_1_by_b_2_x*t289 + D_p_y_3_by_b_2_x*t278
        + D_p_z_1_by_b_2_x*t292 + D_p_z_3_by_b_2_x*t283,
        D_delta_x_1_by_b_2_x*t273 + D_delta_y_1_by_b_2_x*t278 + D_delta_z_1_by_b_2_x*t283
        + D_p_x_1_by_b_2_x*t315 + D_p_y_1_by_b_2_x*t317 + D_p_z_1_by_b_2_x*t319,
        D_delta_x_2_by_b_2_x*t273 + D_delta_y_2_by_b_2_x*t278 + D_delta_z_2_by_b_2_x*t283
        + D_p_x_1_by_b_2_x*t324 + D_p_y_1_by_b_2_x*t326 + D_p_z_1_by_b_2_x*t328,
        D_delta_x_3_by_b_2_x*t273 + D_delta_y_3_by_b_2_x*t278 + D_delta_z_3_by_b_2_x*t283
        + D_p_x_1_by_b_2_x*t330 + D_p_y_1_by_b_2_x*t331 + D_p_z_1_by_b_2_x*t332,
        D_p_x_1_by_b_2_x*t45, D_p_y_1_by_b_2_x*t45, D_p_z_1_by_b_2_x*t45,
        D_p_x_2_by_b_2_x*t299 + D_p_y_2_by_b_2_x*t300 + D_p_z_2_by_b_2_x*t301,
        D_p_x_2_by_b_2_x*t286 + D_p_x_3_by_b_2_x*t271 + D_p_y_2_by_b_2_x*t289 + D_p_y_3_by_b_2_x*t276
        + D_p_z_2_by_b_2_x*t292 + D_p_z_3_by_b_2_x*t281,
        -t341, t341,
        D_delta_x_1_by_b_2_x*t271 + D_delta_y_1_by_b_2_x*t276 + D_delta_z_1_by_b_2_x*t281
        + D_p_x_2_by_b_2_x*t315 + D_p_y_2_by_b_2_x*t317 + D_p_z_2_by_b_2_x*t319,
        D_delta_x_2_by_b_2_x*t271 + D_delta_y_2_by_b_2_x*t276 + D_delta_z_2_by_b_2_x*t281
        + D_p_x_2_by_b_2_x*t324 + D_p_y_2_by_b_2_x*t326 + D_p_z_2_by_b_2_x*t328,
        D_delta_x_3_by_b_2_x*t271 + D_delta_y_3_by_b_2_x*t276 + D_delta_z_3_by_b_2_x*t281
        + D_p_x_2_by_b_2_x*t330 + D_p_y_2_by_b_2_x*t331 + D_p_z_2_by_b_2_x*t332,
        D_p_x_2_by_b_2_x*t45, D_p_y_2_by_b_2_x*t45, D_p_z_2_by_b_2_x*t45,
        D_p_x_3_by_b_2_x*t305 + D_p_y_3_by_b_2_x*t306 + D_p_z_3_by_b_2_x*t307,
        D_delta_x_1_by_b_2_x*t286 + D_delta_y_1_by_b_2_x*t289 + D_delta_z_1_by_b_2_x*t292
        + D_p_x_3_by_b_2_x*t315 + D_p_y_3_by_b_2_x*t317 + D_p_z_3_by_b_2_x*t319,
        D_delta_x_2_by_b_2_x*t286 + D_delta_y_2_by_b_2_x*t289 + D_delta_z_2_by_b_2_x*t292
        + D_p_x_3_by_b_2_x*t324 + D_p_y_3_by_b_2_x*t326 + D_p_z_3_by_b_2_x*t328,
        D_delta_x_3_by_b_2_x*t286 + D_delta_y_3_by_b_2_x*t289 + D_delta_z_3_by_b_2_x*t292
        + D_p_x_3_by_b_2_x*t330 + D_p_y_3_by_b_2_x*t331 + D_p_z_3_by_b_2_x*t332,
        D_p_x_3_by_b_2_x*t45, D_p_y_3_by_b_2_x*t45, D_p_z_3_by_b_2_x*t45, -t344, -t341, t344, t341,
        D_delta_x_1_by_b_2_x*t316 + D_delta_y_1_by_b_2_x*t318 + D_delta_z_1_by_b_2_x*t320,
        D_delta_x_1_by_b_2_x*t324 + D_delta_x_2_by_b_2_x*t315 + D_delta_y_1_by_b_2_x*t326
        + D_delta_y_2_by_b_2_x*t317 + D_delta_z_1_by_b_2_x*t328 + D_delta_z_2_by_b_2_x*t319,
        D_delta_x_1_by_b_2_x*t330 + D_delta_x_3_by_b_2_x*t315 + D_delta_y_1_by_b_2_x*t331
        + D_delta_y_3_by_b_2_x*t317 + D_delta_z_1_by_b_2_x*t332 + D_delta_z_3_by_b_2_x*t319,
        D_delta_x_1_by_b_2_x*t45, D_delta_y_1_by_b_2_x*t45, D_delta_z_1_by_b_2_x*t45,
        D_delta_x_2_by_b_2_x*t325 + D_delta_y_2_by_b_2_x*t327 + D_delta_z_2_by_b_2_x*t329,
        D_delta_x_2_by_b_2_x*t330 + D_delta_x_3_by_b_2_x*t324 + D_delta_y_2_by_b_2_x*t331
        + D_delta_y_3_by_b_2_x*t326 + D_delta_z_2_by_b_2_x*t332 + D_delta_z_3_by_b_2_x*t328,
        D_delta_x_2_by_b_2_x*t45, D_delta_y_2_by_b_2_x*t45, D_delta_z_2_by_b_2_x*t45,
        D_delta_x_3_by_b_2_x*t333 + D_delta_y_3_by_b_2_x*t334 + D_delta_z_3_by_b_2_x*t335,
        D_delta_x_3_by_b_2_x*t45, D_delta_y_3_by_b_2_x*t45, D_delta_z_3_by_b_2_x*t45,
        D_p_x_1_by_b_2_y*t264 + D_p_y_1_by_b_2_y*t266 + D_p_z_1_by_b_2_y*t268,
        D_p_x_1_by_b_2_y*t271 + D_p_x_2_by_b_2_y*t273 + D_p_y_1_by_b_2_y*t276 + D_p_y_2_by_b_2_y*t278
        + D_p_z_1_by_b_2_y*t281 + D_p_z_2_by_b_2_y*t283,
        D_p_x_1_by_b_2_y*t286 + D_p_x_3_by_b_2_y*t273 + D_p_y_1_by_b_2_y*t289 + D_p_y_3_by_b_2_y*t278
        + D_p_z_1_by_b_2_y*t292 + D_p_z_3_by_b_2_y*t283,
        D_delta_x_1_by_b_2_y*t273 + D_delta_y_1_by_b_2_y*t278 + D_delta_z_1_by_b_2_y*t283
        + D_p_x_1_by_b_2_y*t315 + D_p_y_1_by_b_2_y*t317 + D_p_z_1_by_b_2_y*t319,
        D_delta_x_2_by_b_2_y*t273 + D_delta_y_2_by_b_2_y*t278 + D_delta_z_2_by_b_2_y*t283
        + D_p_x_1_by_b_2_y*t324 + D_p_y_1_by_b_2_y*t326 + D_p_z_1_by_b_2_y*t328,
        D_delta_x_3_by_b_2_y*t273 + D_delta_y_3_by_b_2_y*t278 + D_delta_z_3_by_b_2_y*t283
        + D_p_x_1_by_b_2_y*t330 + D_p_y_1_by_b_2_y*t331 + D_p_z_1_by_b_2_y*t332,
        D_p_x_1_by_b_2_y*t45, D_p_y_1_by_b_2_y*t45, D_p_z_1_by_b_2_y*t45,
        D_p_x_2_by_b_2_y*t299 + D_p_y_2_by_b_2_y*t300 + D_p_z_2_by_b_2_y*t301,
        D_p_x_2_by_b_2_y*t286 + D_p_x_3_by_b_2_y*t271 + D_p_y_2_by_b_2_y*t289 + D_p_y_3_by_b_2_y*t276
        + D_p_z_2_by_b_2_y*t292 + D_p_z_3_by_b_2_y*t281,
        -t345, t345,
        D_delta_x_1_by_b_2_y*t271 + D_delta_y_1_by_b_2_y*t276 + D_delta_z_1_by_b_2_y*t281
        + D_p_x_2_by_b_2_y*t315 + D_p_y_2_by_b_2_y*t317 + D_p_z_2_by_b_2_y*t319,
        D_delta_x_2_by_b_2_y*t271 + D_delta_y_2_by_b_2_y*t276 + D_delta_z_2_by_b_2_y*t281
        + D_p_x_2_by_b_2_y*t324 + D_p_y_2_by_b_2_y*t326 + D_p_z_2_by_b_2_y*t328,
        D_delta_x_3_by_b_2_y*t271 + D_delta_y_3_by_b_2_y*t276 + D_delta_z_3_by_b_2_y*t281
        + D_p_x_2_by_b_2_y*t330 + D_p_y_2_by_b_2_y*t331 + D_p_z_2_by_b_2_y*t332,
        D_p_x_2_by_b_2_y*t45, D_p_y_2_by_b_2_y*t45, D_p_z_2_by_b_2_y*t45,
        D_p_x_3_by_b_2_y*t305 + D_p_y_3_by_b_2_y*t306 + D_p_z_3_by_b_2_y*t307,
        D_delta_x_1_by_b_2_y*t286 + D_delta_y_1_by_b_2_y*t289 + D_delta_z_1_by_b_2_y*t292
        + D_p_x_3_by_b_2_y*t315 + D_p_y_3_by_b_2_y*t317 + D_p_z_3_by_b_2_y*t319,
        D_delta_x_2_by_b_2_y*t286 + D_delta_y_2_by_b_2_y*t289 + D_delta_z_2_by_b_2_y*t292
        + D_p_x_3_by_b_2_y*t324 + D_p_y_3_by_b_2_y*t326 + D_p_z_3_by_b_2_y*t328,
        D_delta_x_3_by_b_2_y*t286 + D_delta_y_3_by_b_2_y*t289 + D_delta_z_3_by_b_2_y*t292
        + D_p_x_3_by_b_2_y*t330 + D_p_y_3_by_b_2_y*t331 + D_p_z_3_by_b_2_y*t332,
        D_p_x_3_by_b_2_y*t45, D_p_y_3_by_b_2_y*t45, D_p_z_3_by_b_2_y*t45, -t346, -t345, t346, t345,
        D_delta_x_1_by_b_2_y*t316 + D_delta_y_1_by_b_2_y*t318 + D_delta_z_1_by_b_2_y*t320,
        D_delta_x_1_by_b_2_y*t324 + D_delta_x_2_by_b_2_y*t315 + D_delta_y_1_by_b_2_y*t326
        + D_delta_y_2_by_b_2_y*t317 + D_delta_z_1_by_b_2_y*t328 + D_delta_z_2_by_b_2_y*t319,
        D_delta_x_1_by_b_2_y*t330 + D_delta_x_3_by_b_2_y*t315 + D_delta_y_1_by_b_2_y*t331
        + D_delta_y_3_by_b_2_y*t317 + D_delta_z_1_by_b_2_y*t332 + D_delta_z_3_by_b_2_y*t319,
        D_delta_x_1_by_b_2_y*t45, D_delta_y_1_by_b_2_y*t45, D_delta_z_1_by_b_2_y*t45,
        D_delta_x_2_by_b_2_y*t325 + D_delta_y_2_by_b_2_y*t327 + D_delta_z_2_by_b_2_y*t329,
        D_delta_x_2_by_b_2_y*t330 + D_delta_x_3_by_b_2_y*t324 + D_delta_y_2_by_b_2_y*t331
        + D_delta_y_3_by_b_2_y*t326 + D_delta_z_2_by_b_2_y*t332 + D_delta_z_3_by_b_2_y*t328,
        D_delta_x_2_by_b_2_y*t45, D_delta_y_2_by_b_2_y*t45, D_delta_z_2_by_b_2_y*t45,
        D_delta_x_3_by_b_2_y*t333 + D_delta_y_3_by_b_2_y*t334 + D_delta_z_3_by_b_2_y*t335,
        D_delta_x_3_by_b_2_y*t45, D_delta_y_3_by_b_2_y*t45, D_delta_z_3_by_b_2_y*t45,
        D_p_x_1_by_b_2_z*t264 + D_p_y_1_by_b_2_z*t266 + D_p_z_1_by_b_2_z*t268,
        D_p_x_1_by_b_2_z*t271 + D_p_x_2_by_b_2_z*t273 + D_p_y_1_by_b_2_z*t276 + D_p_y_2_by_b_2_z*t278
        + D_p_z_1_by_b_2_z*t281 + D_p_z_2_by_b_2_z*t283,
        D_p_x_1_by_b_2_z*t286 + D_p_x_3_by_b_2_z*t273 + D_p_y_1_by_b_2_z*t289 + D_p_y_3_by_b_2_z*t278
        + D_p_z_1_by_b_2_z*t292 + D_p_z_3_by_b_2_z*t283,
        D_delta_x_1_by_b_2_z*t273 + D_delta_y_1_by_b_2_z*t278 + D_delta_z_1_by_b_2_z*t283
        + D_p_x_1_by_b_2_z*t315 + D_p_y_1_by_b_2_z*t317 + D_p_z_1_by_b_2_z*t319,
        D_delta_x_2_by_b_2_z*t273 + D_delta_y_2_by_b_2_z*t278 + D_delta_z_2_by_b_2_z*t283
        + D_p_x_1_by_b_2_z*t324 + D_p_y_1_by_b_2_z*t326 + D_p_z_1_by_b_2_z*t328,
        D_delta_x_3_by_b_2_z*t273 + D_delta_y_3_by_b_2_z*t278 + D_delta_z_3_by_b_2_z*t283
        + D_p_x_1_by_b_2_z*t330 + D_p_y_1_by_b_2_z*t331 + D_p_z_1_by_b_2_z*t332,
        D_p_x_1_by_b_2_z*t45, D_p_y_1_by_b_2_z*t45, D_p_z_1_by_b_2_z*t45,
        D_p_x_2_by_b_2_z*t299 + D_p_y_2_by_b_2_z*t300 + D_p_z_2_by_b_2_z*t301,
        D_p_x_2_by_b_2_z*t286 + D_p_x_3_by_b_2_z*t271 + D_p_y_2_by_b_2_z*t289 + D_p_y_3_by_b_2_z*t276
        + D_p_z_2_by_b_2_z*t292 + D_p_z_3_by_b_2_z*t281,
        -t347, t347,
        D_delta_x_1_by_b_2_z*t271 + D_delta_y_1_by_b_2_z*t276 + D_delta_z_1_by_b_2_z*t281
        + D_p_x_2_by_b_2_z*t315 + D_p_y_2_by_b_2_z*t317 + D_p_z_2_by_b_2_z*t319,
        D_delta_x_2_by_b_2_z*t271 + D_delta_y_2_by_b_2_z*t276 + D_delta_z_2_by_b_2_z*t281
        + D_p_x_2_by_b_2_z*t324 + D_p_y_2_by_b_2_z*t326 + D_p_z_2_by_b_2_z*t328,
        D_delta_x_3_by_b_2_z*t271 + D_delta_y_3_by_b_2_z*t276 + D_delta_z_3_by_b_2_z*t281
        + D_p_x_2_by_b_2_z*t330 + D_p_y_2_by_b_2_z*t331 + D_p_z_2_by_b_2_z*t332,
        D_p_x_2_by_b_2_z*t45, D_p_y_2_by_b_2_z*t45, D_p_z_2_by_b_2_z*t45,
        D_p_x_3_by_b_2_z*t305 + D_p_y_3_by_b_2_z*t306 + D_p_z_3_by_b_2_z*t307,
        D_delta_x_1_by_b_2_z*t286 + D_delta_y_1_by_b_2_z*t289 + D_delta_z_1_by_b_2_z*t292
        + D_p_x_3_by_b_2_z*t315 + D_p_y_3_by_b_2_z*t317 + D_p_z_3_by_b_2_z*t319,
        D_delta_x_2_by_b_2_z*t286 + D_delta_y_2_by_b_2_z*t289 + D_delta_z_2_by_b_2_z*t292
        + D_p_x_3_by_b_2_z*t324 + D_p_y_3_by_b_2_z*t326 + D_p_z_3_by_b_2_z*t328,
        D_delta_x_3_by_b_2_z*t286 + D_delta_y_3_by_b_2_z*t289 + D_delta_z_3_by_b_2_z*t292
        + D_p_x_3_by_b_2_z*t330 + D_p_y_3_by_b_2_z*t331 + D_p_z_3_by_b_2_z*t332,
        D_p_x_3_by_b_2_z*t45, D_p_y_3_by_b_2_z*t45, D_p_z_3_by_b_2_z*t45, -t348, -t347, t348, t347,
        D_delta_x_1_by_b_2_z*t316 + D_delta_y_1_by_b_2_z*t318 + D_delta_z_1_by_b_2_z*t320,
        D_delta_x_1_by_b_2_z*t324 + D_delta_x_2_by_b_2_z*t315 + D_delta_y_1_by_b_2_z*t326
        + D_delta_y_2_by_b_2_z*t317 + D_delta_z_1_by_b_2_z*t328 + D_delta_z_2_by_b_2_z*t319,
        D_delta_x_1_by_b_2_z*t330 + D_delta_x_3_by_b_2_z*t315 + D_delta_y_1_by_b_2_z*t331
        + D_delta_y_3_by_b_2_z*t317 + D_delta_z_1_by_b_2_z*t332 + D_delta_z_3_by_b_2_z*t319,
        D_delta_x_1_by_b_2_z*t45, D_delta_y_1_by_b_2_z*t45, D_delta_z_1_by_b_2_z*t45,
        D_delta_x_2_by_b_2_z*t325 + D_delta_y_2_by_b_2_z*t327 + D_delta_z_2_by_b_2_z*t329,
        D_delta_x_2_by_b_2_z*t330 + D_delta_x_3_by_b_2_z*t324 + D_delta_y_2_by_b_2_z*t331
        + D_delta_y_3_by_b_2_z*t326 + D_delta_z_2_by_b_2_z*t332 + D_delta_z_3_by_b_2_z*t328,
        D_delta_x_2_by_b_2_z*t45, D_delta_y_2_by_b_2_z*t45, D_delta_z_2_by_b_2_z*t45,
        D_delta_x_3_by_b_2_z*t333 + D_delta_y_3_by_b_2_z*t334 + D_delta_z_3_by_b_2_z*t335,
        D_delta_x_3_by_b_2_z*t45, D_delta_y_3_by_b_2_z*t45, D_delta_z_3_by_b_2_z*t45,
        D_p_x_1_by_b_3_x*t264 + D_p_y_1_by_b_3_x*t266 + D_p_z_1_by_b_3_x*t268,
        D_p_x_1_by_b_3_x*t271 + D_p_x_2_by_b_3_x*t273 + D_p_y_1_by_b_3_x*t276 + D_p_y_2_by_b_3_x*t278
        + D_p_z_1_by_b_3_x*t281 + D_p_z_2_by_b_3_x*t283,
        D_p_x_1_by_b_3_x*t286 + D_p_x_3_by_b_3_x*t273 + D_p_y_1_by_b_3_x*t289 + D_p_y_3_by_b_3_x*t278
        + D_p_z_1_by_b_3_x*t292 + D_p_z_3_by_b_3_x*t283,
        D_delta_x_1_by_b_3_x*t273 + D_delta_y_1_by_b_3_x*t278 + D_delta_z_1_by_b_3_x*t283
        + D_p_x_1_by_b_3_x*t315 + D_p_y_1_by_b_3_x*t317 + D_p_z_1_by_b_3_x*t319,
        D_delta_x_2_by_b_3_x*t273 + D_delta_y_2_by_b_3_x*t278 + D_delta_z_2_by_b_3_x*t283
        + D_p_x_1_by_b_3_x*t324 + D_p_y_1_by_b_3_x*t326 + D_p_z_1_by_b_3_x*t328,
        D_delta_x_3_by_b_3_x*t273 + D_delta_y_3_by_b_3_x*t278 + D_delta_z_3_by_b_3_x*t283
        + D_p_x_1_by_b_3_x*t330 + D_p_y_1_by_b_3_x*t331 + D_p_z_1_by_b_3_x*t332,
        D_p_x_1_by_b_3_x*t45, D_p_y_1_by_b_3_x*t45, D_p_z_1_by_b_3_x*t45,
        D_p_x_2_by_b_3_x*t299 + D_p_y_2_by_b_3_x*t300 + D_p_z_2_by_b_3_x*t301,
        D_p_x_2_by_b_3_x*t286 + D_p_x_3_by_b_3_x*t271 + D_p_y_2_by_b_3_x*t289 + D_p_y_3_by_b_3_x*t276
        + D_p_z_2_by_b_3_x*t292 + D_p_z_3_by_b_3_x*t281,
        D_delta_x_1_by_b_3_x*t271 + D_delta_y_1_by_b_3_x*t276 + D_delta_z_1_by_b_3_x*t281
        + D_p_x_2_by_b_3_x*t315 + D_p_y_2_by_b_3_x*t317 + D_p_z_2_by_b_3_x*t319,
        D_delta_x_2_by_b_3_x*t271 + D_delta_y_2_by_b_3_x*t276 + D_delta_z_2_by_b_3_x*t281
        + D_p_x_2_by_b_3_x*t324 + D_p_y_2_by_b_3_x*t326 + D_p_z_2_by_b_3_x*t328,
        D_delta_x_3_by_b_3_x*t271 + D_delta_y_3_by_b_3_x*t276 + D_delta_z_3_by_b_3_x*t281
        + D_p_x_2_by_b_3_x*t330 + D_p_y_2_by_b_3_x*t331 + D_p_z_2_by_b_3_x*t332,
        D_p_x_2_by_b_3_x*t45, D_p_y_2_by_b_3_x*t45, D_p_z_2_by_b_3_x*t45,
        D_p_x_3_by_b_3_x*t305 + D_p_y_3_by_b_3_x*t306 + D_p_z_3_by_b_3_x*t307, -t350, t350,
        D_delta_x_1_by_b_3_x*t286 + D_delta_y_1_by_b_3_x*t289 + D_delta_z_1_by_b_3_x*t292
        + D_p_x_3_by_b_3_x*t315 + D_p_y_3_by_b_3_x*t317 + D_p_z_3_by_b_3_x*t319,
        D_delta_x_2_by_b_3_x*t286 + D_delta_y_2_by_b_3_x*t289 + D_delta_z_2_by_b_3_x*t292
        + D_p_x_3_by_b_3_x*t324 + D_p_y_3_by_b_3_x*t326 + D_p_z_3_by_b_3_x*t328,
        D_delta_x_3_by_b_3_x*t286 + D_delta_y_3_by_b_3_x*t289 + D_delta_z_3_by_b_3_x*t292
        + D_p_x_3_by_b_3_x*t330 + D_p_y_3_by_b_3_x*t331 + D_p_z_3_by_b_3_x*t332,
        D_p_x_3_by_b_3_x*t45, D_p_y_3_by_b_3_x*t45, D_p_z_3_by_b_3_x*t45, -t353, -t350, t353, t350,
        D_delta_x_1_by_b_3_x*t316 + D_delta_y_1_by_b_3_x*t318 + D_delta_z_1_by_b_3_x*t320,
        D_delta_x_1_by_b_3_x*t324 + D_delta_x_2_by_b_3_x*t315 + D_delta_y_1_by_b_3_x*t326
        + D_delta_y_2_by_b_3_x*t317 + D_delta_z_1_by_b_3_x*t328 + D_delta_z_2_by_b_3_x*t319,
        D_delta_x_1_by_b_3_x*t330 + D_delta_x_3_by_b_3_x*t315 + D_delta_y_1_by_b_3_x*t331
        + D_delta_y_3_by_b_3_x*t317 + D_delta_z_1_by_b_3_x*t332 + D_delta_z_3_by_b_3_x*t319,
        D_delta_x_1_by_b_3_x*t45, D_delta_y_1_by_b_3_x*t45, D_delta_z_1_by_b_3_x*t45,
        D_delta_x_2_by_b_3_x*t325 + D_delta_y_2_by_b_3_x*t327 + D_delta_z_2_by_b_3_x*t329,
        D_delta_x_2_by_b_3_x*t330 + D_delta_x_3_by_b_3_x*t324 + D_delta_y_2_by_b_3_x*t331
        + D_delta_y_3_by_b_3_x*t326 + D_delta_z_2_by_b_3_x*t332 + D_delta_z_3_by_b_3_x*t328,
        D_delta_x_2_by_b_3_x*t45, D_delta_y_2_by_b_3_x*t45, D_delta_z_2_by_b_3_x*t45,
        D_delta_x_3_by_b_3_x*t333 + D_delta_y_3_by_b_3_x*t334 + D_delta_z_3_by_b_3_x*t335,
        D_delta_x_3_by_b_3_x*t45, D_delta_y_3_by_b_3_x*t45, D_delta_z_3_by_b_3_x*t45,
        D_p_x_1_by_b_3_y*t264 + D_p_y_1_by_b_3_y*t266 + D_p_z_1_by_b_3_y*t268,
        D_p_x_1_by_b_3_y*t271 + D_p_x_2_by_b_3_y*t273 + D_p_y_1_by_b_3_y*t276 + D_p_y_2_by_b_3_y*t278
        + D_p_z_1_by_b_3_y*t281 + D_p_z_2_by_b_3_y*t283,
        D_p_x_1_by_b_3_y*t286 + D_p_x_3_by_b_3_y*t273 + D_p_y_1_by_b_3_y*t289 + D_p_y_3_by_b_3_y*t278
        + D_p_z_1_by_b_3_y*t292 + D_p_z_3_by_b_3_y*t283,
        D_delta_x_1_by_b_3_y*t273 + D_delta_y_1_by_b_3_y*t278 + D_delta_z_1_by_b_3_y*t283
        + D_p_x_1_by_b_3_y*t315 + D_p_y_1_by_b_3_y*t317 + D_p_z_1_by_b_3_y*t319,
        D_delta_x_2_by_b_3_y*t273 + D_delta_y_2_by_b_3_y*t278 + D_delta_z_2_by_b_3_y*t283
        + D_p_x_1_by_b_3_y*t324 + D_p_y_1_by_b_3_y*t326 + D_p_z_1_by_b_3_y*t328,
        D_delta_x_3_by_b_3_y*t273 + D_delta_y_3_by_b_3_y*t278 + D_delta_z_3_by_b_3_y*t283
        + D_p_x_1_by_b_3_y*t330 + D_p_y_1_by_b_3_y*t331 + D_p_z_1_by_b_3_y*t332,
        D_p_x_1_by_b_3_y*t45, D_p_y_1_by_b_3_y*t45, D_p_z_1_by_b_3_y*t45,
        D_p_x_2_by_b_3_y*t299 + D_p_y_2_by_b_3_y*t300 + D_p_z_2_by_b_3_y*t301,
        D_p_x_2_by_b_3_y*t286 + D_p_x_3_by_b_3_y*t271 + D_p_y_2_by_b_3_y*t289 + D_p_y_3_by_b_3_y*t276
        + D_p_z_2_by_b_3_y*t292 + D_p_z_3_by_b_3_y*t281,
        D_delta_x_1_by_b_3_y*t271 + D_delta_y_1_by_b_3_y*t276 + D_delta_z_1_by_b_3_y*t281
        + D_p_x_2_by_b_3_y*t315 + D_p_y_2_by_b_3_y*t317 + D_p_z_2_by_b_3_y*t319,
        D_delta_x_2_by_b_3_y*t271 + D_delta_y_2_by_b_3_y*t276 + D_delta_z_2_by_b_3_y*t281
        + D_p_x_2_by_b_3_y*t324 + D_p_y_2_by_b_3_y*t326 + D_p_z_2_by_b_3_y*t328,
        D_delta_x_3_by_b_3_y*t271 + D_delta_y_3_by_b_3_y*t276 + D_delta_z_3_by_b_3_y*t281
        + D_p_x_2_by_b_3_y*t330 + D_p_y_2_by_b_3_y*t331 + D_p_z_2_by_b_3_y*t332,
        D_p_x_2_by_b_3_y*t45, D_p_y_2_by_b_3_y*t45, D_p_z_2_by_b_3_y*t45,
        D_p_x_3_by_b_3_y*t305 + D_p_y_3_by_b_3_y*t306 + D_p_z_3_by_b_3_y*t307, -t354, t354,
        D_delta_x_1_by_b_3_y*t286 + D_delta_y_1_by_b_3_y*t289 + D_delta_z_1_by_b_3_y*t292
        + D_p_x_3_by_b_3_y*t315 + D_p_y_3_by_b_3_y*t317 + D_p_z_3_by_b_3_y*t319,
        D_delta_x_2_by_b_3_y*t286 + D_delta_y_2_by_b_3_y*t289 + D_delta_z_2_by_b_3_y*t292
        + D_p_x_3_by_b_3_y*t324 + D_p_y_3_by_b_3_y*t326 + D_p_z_3_by_b_3_y*t328,
        D_delta_x_3_by_b_3_y*t286 + D_delta_y_3_by_b_3_y*t289 + D_delta_z_3_by_b_3_y*t292
        + D_p_x_3_by_b_3_y*t330 + D_p_y_3_by_b_3_y*t331 + D_p_z_3_by_b_3_y*t332,
        D_p_x_3_by_b_3_y*t45, D_p_y_3_by_b_3_y*t45, D_p_z_3_by_b_3_y*t45, -t355, -t354, t355, t354,
        D_delta_x_1_by_b_3_y*t316 + D_delta_y_1_by_b_3_y*t318 + D_delta_z_1_by_b_3_y*t320,
        D_delta_x_1_by_b_3_y*t324 + D_delta_x_2_by_b_3_y*t315 + D_delta_y_1_by_b_3_y*t326
        + D_delta_y_2_by_b_3_y*t317 + D_delta_z_1_by_b_3_y*t328 + D_delta_z_2_by_b_3_y*t319,
        D_delta_x_1_by_b_3_y*t330 + D_delta_x_3_by_b_3_y*t315 + D_delta_y_1_by_b_3_y*t331
        + D_delta_y_3_by_b_3_y*t317 + D_delta_z_1_by_b_3_y*t332 + D_delta_z_3_by_b_3_y*t319,
        D_delta_x_1_by_b_3_y*t45, D_delta_y_1_by_b_3_y*t45, D_delta_z_1_by_b_3_y*t45,
        D_delta_x_2_by_b_3_y*t325 + D_delta_y_2_by_b_3_y*t327 + D_delta_z_2_by_b_3_y*t329,
        D_delta_x_2_by_b_3_y*t330 + D_delta_x_3_by_b_3_y*t324 + D_delta_y_2_by_b_3_y*t331
        + D_delta_y_3_by_b_3_y*t326 + D_delta_z_2_by_b_3_y*t332 + D_delta_z_3_by_b_3_y*t328,
        D_delta_x_2_by_b_3_y*t45, D_delta_y_2_by_b_3_y*t45, D_delta_z_2_by_b_3_y*t45,
        D_delta_x_3_by_b_3_y*t333 + D_delta_y_3_by_b_3_y*t334 + D_delta_z_3_by_b_3_y*t335,
        D_delta_x_3_by_b_3_y*t45, D_delta_y_3_by_b_3_y*t45, D_delta_z_3_by_b_3_y*t45,
        D_p_x_1_by_b_3_z*t264 + D_p_y_1_by_b_3_z*t266 + D_p_z_1_by_b_3_z*t268,
        D_p_x_1_by_b_3_z*t271 + D_p_x_2_by_b_3_z*t273 + D_p_y_1_by_b_3_z*t276 + D_p_y_2_by_b_3_z*t278
        + D_p_z_1_by_b_3_z*t281 + D_p_z_2_by_b_3_z*t283,
        D_p_x_1_by_b_3_z*t286 + D_p_x_3_by_b_3_z*t273 + D_p_y_1_by_b_3_z*t289 + D_p_y_3_by_b_3_z*t278
        + D_p_z_1_by_b_3_z*t292 + D_p_z_3_by_b_3_z*t283,
        D_delta_x_1_by_b_3_z*t273 + D_delta_y_1_by_b_3_z*t278 + D_delta_z_1_by_b_3_z*t283
        + D_p_x_1_by_b_3_z*t315 + D_p_y_1_by_b_3_z*t317 + D_p_z_1_by_b_3_z*t319,
        D_delta_x_2_by_b_3_z*t273 + D_delta_y_2_by_b_3_z*t278 + D_delta_z_2_by_b_3_z*t283
        + D_p_x_1_by_b_3_z*t324 + D_p_y_1_by_b_3_z*t326 + D_p_z_1_by_b_3_z*t328,
        D_delta_x_3_by_b_3_z*t273 + D_delta_y_3_by_b_3_z*t278 + D_delta_z_3_by_b_3_z*t283
        + D_p_x_1_by_b_3_z*t330 + D_p_y_1_by_b_3_z*t331 + D_p_z_1_by_b_3_z*t332,
        D_p_x_1_by_b_3_z*t45, D_p_y_1_by_b_3_z*t45, D_p_z_1_by_b_3_z*t45,
        D_p_x_2_by_b_3_z*t299 + D_p_y_2_by_b_3_z*t300 + D_p_z_2_by_b_3_z*t301,
        D_p_x_2_by_b_3_z*t286 + D_p_x_3_by_b_3_z*t271 + D_p_y_2_by_b_3_z*t289 + D_p_y_3_by_b_3_z*t276
        + D_p_z_2_by_b_3_z*t292 + D_p_z_3_by_b_3_z*t281,
        D_delta_x_1_by_b_3_z*t271 + D_delta_y_1_by_b_3_z*t276 + D_delta_z_1_by_b_3_z*t281
        + D_p_x_2_by_b_3_z*t315 + D_p_y_2_by_b_3_z*t317 + D_p_z_2_by_b_3_z*t319,
        D_delta_x_2_by_b_3_z*t271 + D_delta_y_2_by_b_3_z*t276 + D_delta_z_2_by_b_3_z*t281
        + D_p_x_2_by_b_3_z*t324 + D_p_y_2_by_b_3_z*t326 + D_p_z_2_by_b_3_z*t328,
        D_delta_x_3_by_b_3_z*t271 + D_delta_y_3_by_b_3_z*t276 + D_delta_z_3_by_b_3_z*t281
        + D_p_x_2_by_b_3_z*t330 + D_p_y_2_by_b_3_z*t331 + D_p_z_2_by_b_3_z*t332,
        D_p_x_2_by_b_3_z*t45, D_p_y_2_by_b_3_z*t45, D_p_z_2_by_b_3_z*t45,
        D_p_x_3_by_b_3_z*t305 + D_p_y_3_by_b_3_z*t306 + D_p_z_3_by_b_3_z*t307, -t356, t356,
        D_delta_x_1_by_b_3_z*t286 + D_delta_y_1_by_b_3_z*t289 + D_delta_z_1_by_b_3_z*t292
        + D_p_x_3_by_b_3_z*t315 + D_p_y_3_by_b_3_z*t317 + D_p_z_3_by_b_3_z*t319,
        D_delta_x_2_by_b_3_z*t286 + D_delta_y_2_by_b_3_z*t289 + D_delta_z_2_by_b_3_z*t292
        + D_p_x_3_by_b_3_z*t324 + D_p_y_3_by_b_3_z*t326 + D_p_z_3_by_b_3_z*t328,
        D_delta_x_3_by_b_3_z*t286 + D_delta_y_3_by_b_3_z*t289 + D_delta_z_3_by_b_3_z*t292
        + D_p_x_3_by_b_3_z*t330 + D_p_y_3_by_b_3_z*t331 + D_p_z_3_by_b_3_z*t332,
        D_p_x_3_by_b_3_z*t45, D_p_y_3_by_b_3_z*t45, D_p_z_3_by_b_3_z*t45, -t357, -t356, t357, t356,
        D_delta_x_1_by_b_3_z*t316 + D_delta_y_1_by_b_3_z*t318 + D_delta_z_1_by_b_3_z*t320,
        D_delta_x_1_by_b_3_z*t324 + D_delta_x_2_by_b_3_z*t315 + D_delta_y_1_by_b_3_z*t326
        + D_delta_y_2_by_b_3_z*t317 + D_delta_z_1_by_b_3_z*t328 + D_delta_z_2_by_b_3_z*t319,
        D_delta_x_1_by_b_3_z*t330 + D_delta_x_3_by_b_3_z*t315 + D_delta_y_1_by_b_3_z*t331
        + D_delta_y_3_by_b_3_z*t317 + D_delta_z_1_by_b_3_z*t332 + D_delta_z_3_by_b_3_z*t319,
        D_delta_x_1_by_b_3_z*t45, D_delta_y_1_by_b_3_z*t45, D_delta_z_1_by_b_3_z*t45,
        D_delta_x_2_by_b_3_z*t325 + D_delta_y_2_by_b_3_z*t327 + D_delta_z_2_by_b_3_z*t329,
        D_delta_x_2_by_b_3_z*t330 + D_delta_x_3_by_b_3_z*t324 + D_delta_y_2_by_b_3_z*t331
        + D_delta_y_3_by_b_3_z*t326 + D_delta_z_2_by_b_3_z*t332 + D_delta_z_3_by_b_3_z*t328,
        D_delta_x_2_by_b_3_z*t45, D_delta_y_2_by_b_3_z*t45, D_delta_z_2_by_b_3_z*t45,
        D_delta_x_3_by_b_3_z*t333 + D_delta_y_3_by_b_3_z*t334 + D_delta_z_3_by_b_3_z*t335,
        D_delta_x_3_by_b_3_z*t45, D_delta_y_3_by_b_3_z*t45, D_delta_z_3_by_b_3_z*t45,
        D_p_x_1_by_l_d_1*t264 + D_p_y_1_by_l_d_1*t266 + D_p_z_1_by_l_d_1*t268,
        D_p_x_1_by_l_d_1*t271 + D_p_x_2_by_l_d_1*t273 + D_p_y_1_by_l_d_1*t276 + D_p_y_2_by_l_d_1*t278
        + D_p_z_1_by_l_d_1*t281 + D_p_z_2_by_l_d_1*t283,
        D_p_x_1_by_l_d_1*t286 + D_p_x_3_by_l_d_1*t273 + D_p_y_1_by_l_d_1*t289 + D_p_y_3_by_l_d_1*t278
        + D_p_z_1_by_l_d_1*t292 + D_p_z_3_by_l_d_1*t283,
        -t358, t358,
        D_delta_x_1_by_l_d_1*t273 + D_delta_y_1_by_l_d_1*t278 + D_delta_z_1_by_l_d_1*t283
        + D_p_x_1_by_l_d_1*t315 + D_p_y_1_by_l_d_1*t317 + D_p_z_1_by_l_d_1*t319,
        D_delta_x_2_by_l_d_1*t273 + D_delta_y_2_by_l_d_1*t278 + D_delta_z_2_by_l_d_1*t283
        + D_p_x_1_by_l_d_1*t324 + D_p_y_1_by_l_d_1*t326 + D_p_z_1_by_l_d_1*t328,
        D_delta_x_3_by_l_d_1*t273 + D_delta_y_3_by_l_d_1*t278 + D_delta_z_3_by_l_d_1*t283
        + D_p_x_1_by_l_d_1*t330 + D_p_y_1_by_l_d_1*t331 + D_p_z_1_by_l_d_1*t332,
        D_p_x_1_by_l_d_1*t45, D_p_y_1_by_l_d_1*t45, D_p_z_1_by_l_d_1*t45,
        D_p_x_2_by_l_d_1*t299 + D_p_y_2_by_l_d_1*t300 + D_p_z_2_by_l_d_1*t301,
        D_p_x_2_by_l_d_1*t286 + D_p_x_3_by_l_d_1*t271 + D_p_y_2_by_l_d_1*t289 + D_p_y_3_by_l_d_1*t276
        + D_p_z_2_by_l_d_1*t292 + D_p_z_3_by_l_d_1*t281,
        D_delta_x_1_by_l_d_1*t271 + D_delta_y_1_by_l_d_1*t276 + D_delta_z_1_by_l_d_1*t281
        + D_p_x_2_by_l_d_1*t315 + D_p_y_2_by_l_d_1*t317 + D_p_z_2_by_l_d_1*t319,
        D_delta_x_2_by_l_d_1*t271 + D_delta_y_2_by_l_d_1*t276 + D_delta_z_2_by_l_d_1*t281
        + D_p_x_2_by_l_d_1*t324 + D_p_y_2_by_l_d_1*t326 + D_p_z_2_by_l_d_1*t328,
        D_delta_x_3_by_l_d_1*t271 + D_delta_y_3_by_l_d_1*t276 + D_delta_z_3_by_l_d_1*t281
        + D_p_x_2_by_l_d_1*t330 + D_p_y_2_by_l_d_1*t331 + D_p_z_2_by_l_d_1*t332,
        D_p_x_2_by_l_d_1*t45, D_p_y_2_by_l_d_1*t45, D_p_z_2_by_l_d_1*t45,
        D_p_x_3_by_l_d_1*t305 + D_p_y_3_by_l_d_1*t306 + D_p_z_3_by_l_d_1*t307,
        D_delta_x_1_by_l_d_1*t286 + D_delta_y_1_by_l_d_1*t289 + D_delta_z_1_by_l_d_1*t292
        + D_p_x_3_by_l_d_1*t315 + D_p_y_3_by_l_d_1*t317 + D_p_z_3_by_l_d_1*t319,
        D_delta_x_2_by_l_d_1*t286 + D_delta_y_2_by_l_d_1*t289 + D_delta_z_2_by_l_d_1*t292
        + D_p_x_3_by_l_d_1*t324 + D_p_y_3_by_l_d_1*t326 + D_p_z_3_by_l_d_1*t328,
        D_delta_x_3_by_l_d_1*t286 + D_delta_y_3_by_l_d_1*t289 + D_delta_z_3_by_l_d_1*t292
        + D_p_x_3_by_l_d_1*t330 + D_p_y_3_by_l_d_1*t331 + D_p_z_3_by_l_d_1*t332,
        D_p_x_3_by_l_d_1*t45, D_p_y_3_by_l_d_1*t45, D_p_z_3_by_l_d_1*t45, -t359, -t358, t359, t358,
        D_delta_x_1_by_l_d_1*t316 + D_delta_y_1_by_l_d_1*t318 + D_delta_z_1_by_l_d_1*t320,
        D_delta_x_1_by_l_d_1*t324 + D_delta_x_2_by_l_d_1*t315 + D_delta_y_1_by_l_d_1*t326
        + D_delta_y_2_by_l_d_1*t317 + D_delta_z_1_by_l_d_1*t328 + D_delta_z_2_by_l_d_1*t319,
        D_delta_x_1_by_l_d_1*t330 + D_delta_x_3_by_l_d_1*t315 + D_delta_y_1_by_l_d_1*t331
        + D_delta_y_3_by_l_d_1*t317 + D_delta_z_1_by_l_d_1*t332 + D_delta_z_3_by_l_d_1*t319,
        D_delta_x_1_by_l_d_1*t45, D_delta_y_1_by_l_d_1*t45, D_delta_z_1_by_l_d_1*t45,
        D_delta_x_2_by_l_d_1*t325 + D_delta_y_2_by_l_d_1*t327 + D_delta_z_2_by_l_d_1*t329,
        D_delta_x_2_by_l_d_1*t330 + D_delta_x_3_by_l_d_1*t324 + D_delta_y_2_by_l_d_1*t331
        + D_delta_y_3_by_l_d_1*t326 + D_delta_z_2_by_l_d_1*t332 + D_delta_z_3_by_l_d_1*t328,
        D_delta_x_2_by_l_d_1*t45, D_delta_y_2_by_l_d_1*t45, D_delta_z_2_by_l_d_1*t45,
        D_delta_x_3_by_l_d_1*t333 + D_delta_y_3_by_l_d_1*t334 + D_delta_z_3_by_l_d_1*t335,
        D_delta_x_3_by_l_d_1*t45, D_delta_y_3_by_l_d_1*t45, D_delta_z_3_by_l_d_1*t45,
        D_p_x_1_by_l_d_2*t264 + D_p_y_1_by_l_d_2*t266 + D_p_z_1_by_l_d_2*t268,
        D_p_x_1_by_l_d_2*t271 + D_p_x_2_by_l_d_2*t273 + D_p_y_1_by_l_d_2*t276 + D_p_y_2_by_l_d_2*t278
        + D_p_z_1_by_l_d_2*t281 + D_p_z_2_by_l_d_2*t283,
        D_p_x_1_by_l_d_2*t286 + D_p_x_3_by_l_d_2*t273 + D_p_y_1_by_l_d_2*t289 + D_p_y_3_by_l_d_2*t278
        + D_p_z_1_by_l_d_2*t292 + D_p_z_3_by_l_d_2*t283,
        D_delta_x_1_by_l_d_2*t273 + D_delta_y_1_by_l_d_2*t278 + D_delta_z_1_by_l_d_2*t283
        + D_p_x_1_by_l_d_2*t315 + D_p_y_1_by_l_d_2*t317 + D_p_z_1_by_l_d_2*t319,
        D_delta_x_2_by_l_d_2*t273 + D_delta_y_2_by_l_d_2*t278 + D_delta_z_2_by_l_d_2*t283
        + D_p_x_1_by_l_d_2*t324 + D_p_y_1_by_l_d_2*t326 + D_p_z_1_by_l_d_2*t328,
        D_delta_x_3_by_l_d_2*t273 + D_delta_y_3_by_l_d_2*t278 + D_delta_z_3_by_l_d_2*t283
        + D_p_x_1_by_l_d_2*t330 + D_p_y_1_by_l_d_2*t331 + D_p_z_1_by_l_d_2*t332,
        D_p_x_1_by_l_d_2*t45, D_p_y_1_by_l_d_2*t45, D_p_z_1_by_l_d_2*t45,
        D_p_x_2_by_l_d_2*t299 + D_p_y_2_by_l_d_2*t300 + D_p_z_2_by_l_d_2*t301,
        D_p_x_2_by_l_d_2*t286 + D_p_x_3_by_l_d_2*t271 + D_p_y_2_by_l_d_2*t289 + D_p_y_3_by_l_d_2*t276
        + D_p_z_2_by_l_d_2*t292 + D_p_z_3_by_l_d_2*t281,
        -t360, t360,
        D_delta_x_1_by_l_d_2*t271 + D_delta_y_1_by_l_d_2*t276 + D_delta_z_1_by_l_d_2*t281
        + D_p_x_2_by_l_d_2*t315 + D_p_y_2_by_l_d_2*t317 + D_p_z_2_by_l_d_2*t319,
        D_delta_x_2_by_l_d_2*t271 + D_delta_y_2_by_l_d_2*t276 + D_delta_z_2_by_l_d_2*t281
        + D_p_x_2_by_l_d_2*t324 + D_p_y_2_by_l_d_2*t326 + D_p_z_2_by_l_d_2*t328,
        D_delta_x_3_by_l_d_2*t271 + D_delta_y_3_by_l_d_2*t276 + D_delta_z_3_by_l_d_2*t281
        + D_p_x_2_by_l_d_2*t330 + D_p_y_2_by_l_d_2*t331 + D_p_z_2_by_l_d_2*t332,
        D_p_x_2_by_l_d_2*t45, D_p_y_2_by_l_d_2*t45, D_p_z_2_by_l_d_2*t45,
        D_p_x_3_by_l_d_2*t305 + D_p_y_3_by_l_d_2*t306 + D_p_z_3_by_l_d_2*t307,
        D_delta_x_1_by_l_d_2*t286 + D_delta_y_1_by_l_d_2*t289 + D_delta_z_1_by_l_d_2*t292
        + D_p_x_3_by_l_d_2*t315 + D_p_y_3_by_l_d_2*t317 + D_p_z_3_by_l_d_2*t319,
        D_delta_x_2_by_l_d_2*t286 + D_delta_y_2_by_l_d_2*t289 + D_delta_z_2_by_l_d_2*t292
        + D_p_x_3_by_l_d_2*t324 + D_p_y_3_by_l_d_2*t326 + D_p_z_3_by_l_d_2*t328,
        D_delta_x_3_by_l_d_2*t286 + D_delta_y_3_by_l_d_2*t289 + D_delta_z_3_by_l_d_2*t292
        + D_p_x_3_by_l_d_2*t330 + D_p_y_3_by_l_d_2*t331 + D_p_z_3_by_l_d_2*t332,
        D_p_x_3_by_l_d_2*t45, D_p_y_3_by_l_d_2*t45, D_p_z_3_by_l_d_2*t45, -t361, -t360, t361, t360,
        D_delta_x_1_by_l_d_2*t316 + D_delta_y_1_by_l_d_2*t318 + D_delta_z_1_by_l_d_2*t320,
        D_delta_x_1_by_l_d_2*t324 + D_delta_x_2_by_l_d_2*t315 + D_delta_y_1_by_l_d_2*t326
        + D_delta_y_2_by_l_d_2*t317 + D_delta_z_1_by_l_d_2*t328 + D_delta_z_2_by_l_d_2*t319,
        D_delta_x_1_by_l_d_2*t330 + D_delta_x_3_by_l_d_2*t315 + D_delta_y_1_by_l_d_2*t331
        + D_delta_y_3_by_l_d_2*t317 + D_delta_z_1_by_l_d_2*t332 + D_delta_z_3_by_l_d_2*t319,
        D_delta_x_1_by_l_d_2*t45, D_delta_y_1_by_l_d_2*t45, D_delta_z_1_by_l_d_2*t45,
        D_delta_x_2_by_l_d_2*t325 + D_delta_y_2_by_l_d_2*t327 + D_delta_z_2_by_l_d_2*t329,
        D_delta_x_2_by_l_d_2*t330 + D_delta_x_3_by_l_d_2*t324 + D_delta_y_2_by_l_d_2*t331
        + D_delta_y_3_by_l_d_2*t326 + D_delta_z_2_by_l_d_2*t332 + D_delta_z_3_by_l_d_2*t328,
        D_delta_x_2_by_l_d_2*t45, D_delta_y_2_by_l_d_2*t45, D_delta_z_2_by_l_d_2*t45,
        D_delta_x_3_by_l_d_2*t333 + D_delta_y_3_by_l_d_2*t334 + D_delta_z_3_by_l_d_2*t335,
        D_delta_x_3_by_l_d_2*t45, D_delta_y_3_by_l_d_2*t45, D_delta_z_3_by_l_d_2*t45,
        D_p_x_1_by_l_d_3*t264 + D_p_y_1_by_l_d_3*t266 + D_p_z_1_by_l_d_3*t268,
        D_p_x_1_by_l_d_3*t271 + D_p_x_2_by_l_d_3*t273 + D_p_y_1_by_l_d_3*t276 + D_p_y_2_by_l_d_3*t278
        + D_p_z_1_by_l_d_3*t281 + D_p_z_2_by_l_d_3*t283,
        D_p_x_1_by_l_d_3*t286 + D_p_x_3_by_l_d_3*t273 + D_p_y_1_by_l_d_3*t289 + D_p_y_3_by_l_d_3*t278
        + D_p_z_1_by_l_d_3*t292 + D_p_z_3_by_l_d_3*t283,
        D_delta_x_1_by_l_d_3*t273 + D_delta_y_1_by_l_d_3*t278 + D_delta_z_1_by_l_d_3*t283
        + D_p_x_1_by_l_d_3*t315 + D_p_y_1_by_l_d_3*t317 + D_p_z_1_by_l_d_3*t319,
        D_delta_x_2_by_l_d_3*t273 + D_delta_y_2_by_l_d_3*t278 + D_delta_z_2_by_l_d_3*t283
        + D_p_x_1_by_l_d_3*t324 + D_p_y_1_by_l_d_3*t326 + D_p_z_1_by_l_d_3*t328,
        D_delta_x_3_by_l_d_3*t273 + D_delta_y_3_by_l_d_3*t278 + D_delta_z_3_by_l_d_3*t283
        + D_p_x_1_by_l_d_3*t330 + D_p_y_1_by_l_d_3*t331 + D_p_z_1_by_l_d_3*t332,
        D_p_x_1_by_l_d_3*t45, D_p_y_1_by_l_d_3*t45, D_p_z_1_by_l_d_3*t45,
        D_p_x_2_by_l_d_3*t299 + D_p_y_2_by_l_d_3*t300 + D_p_z_2_by_l_d_3*t301,
        D_p_x_2_by_l_d_3*t286 + D_p_x_3_by_l_d_3*t271 + D_p_y_2_by_l_d_3*t289 + D_p_y_3_by_l_d_3*t276
        + D_p_z_2_by_l_d_3*t292 + D_p_z_3_by_l_d_3*t281,
        D_delta_x_1_by_l_d_3*t271 + D_delta_y_1_by_l_d_3*t276 + D_delta_z_1_by_l_d_3*t281
        + D_p_x_2_by_l_d_3*t315 + D_p_y_2_by_l_d_3*t317 + D_p_z_2_by_l_d_3*t319,
        D_delta_x_2_by_l_d_3*t271 + D_delta_y_2_by_l_d_3*t276 + D_delta_z_2_by_l_d_3*t281
        + D_p_x_2_by_l_d_3*t324 + D_p_y_2_by_l_d_3*t326 + D_p_z_2_by_l_d_3*t328,
        D_delta_x_3_by_l_d_3*t271 + D_delta_y_3_by_l_d_3*t276 + D_delta_z_3_by_l_d_3*t281
        + D_p_x_2_by_l_d_3*t330 + D_p_y_2_by_l_d_3*t331 + D_p_z_2_by_l_d_3*t332,
        D_p_x_2_by_l_d_3*t45, D_p_y_2_by_l_d_3*t45, D_p_z_2_by_l_d_3*t45,
        D_p_x_3_by_l_d_3*t305 + D_p_y_3_by_l_d_3*t306 + D_p_z_3_by_l_d_3*t307, -t362, t362,
        D_delta_x_1_by_l_d_3*t286 + D_delta_y_1_by_l_d_3*t289 + D_delta_z_1_by_l_d_3*t292
        + D_p_x_3_by_l_d_3*t315 + D_p_y_3_by_l_d_3*t317 + D_p_z_3_by_l_d_3*t319,
        D_delta_x_2_by_l_d_3*t286 + D_delta_y_2_by_l_d_3*t289 + D_delta_z_2_by_l_d_3*t292
        + D_p_x_3_by_l_d_3*t324 + D_p_y_3_by_l_d_3*t326 + D_p_z_3_by_l_d_3*t328,
        D_delta_x_3_by_l_d_3*t286 + D_delta_y_3_by_l_d_3*t289 + D_delta_z_3_by_l_d_3*t292
        + D_p_x_3_by_l_d_3*t330 + D_p_y_3_by_l_d_3*t331 + D_p_z_3_by_l_d_3*t332,
        D_p_x_3_by_l_d_3*t45, D_p_y_3_by_l_d_3*t45, D_p_z_3_by_l_d_3*t45, -t363, -t362, t363, t362,
        D_delta_x_1_by_l_d_3*t316 + D_delta_y_1_by_l_d_3*t318 + D_delta_z_1_by_l_d_3*t320,
        D_delta_x_1_by_l_d_3*t324 + D_delta_x_2_by_l_d_3*t315 + D_delta_y_1_by_l_d_3*t326
        + D_delta_y_2_by_l_d_3*t317 + D_delta_z_1_by_l_d_3*t328 + D_delta_z_2_by_l_d_3*t319,
        D_delta_x_1_by_l_d_3*t330 + D_delta_x_3_by_l_d_3*t315 + D_delta_y_1_by_l_d_3*t331
        + D_delta_y_3_by_l_d_3*t317 + D_delta_z_1_by_l_d_3*t332 + D_delta_z_3_by_l_d_3*t319,
        D_delta_x_1_by_l_d_3*t45, D_delta_y_1_by_l_d_3*t45, D_delta_z_1_by_l_d_3*t45,
        D_delta_x_2_by_l_d_3*t325 + D_delta_y_2_by_l_d_3*t327 + D_delta_z_2_by_l_d_3*t329,
        D_delta_x_2_by_l_d_3*t330 + D_delta_x_3_by_l_d_3*t324 + D_delta_y_2_by_l_d_3*t331
        + D_delta_y_3_by_l_d_3*t326 + D_delta_z_2_by_l_d_3*t332 + D_delta_z_3_by_l_d_3*t328,
        D_delta_x_2_by_l_d_3*t45, D_delta_y_2_by_l_d_3*t45, D_delta_z_2_by_l_d_3*t45,
        D_delta_x_3_by_l_d_3*t333 + D_delta_y_3_by_l_d_3*t334 + D_delta_z_3_by_l_d_3*t335,
        D_delta_x_3_by_l_d_3*t45, D_delta_y_3_by_l_d_3*t45, D_delta_z_3_by_l_d_3*t45,
        D_p_x_1*t272 + D_p_x_1*t364 + D_p_y_1*t277 + D_p_y_1*t365 + D_p_z_1*t282 + D_p_z_1*t366 + 1/3,
        D_p_x_2*t364 + D_p_y_2*t365 + D_p_z_2*t366, D_p_x_3*t364 + D_p_y_3*t365 + D_p_z_3*t366,
        D_delta_x_1*t364 + D_delta_y_1*t365 + D_delta_z_1*t366,
        D_delta_x_2*t364 + D_delta_y_2*t365 + D_delta_z_2*t366,
        D_delta_x_3*t364 + D_delta_y_3*t365 + D_delta_z_3*t366, (1/2)*n_1_x + t367, (1/2)*n_1_y + t368,
        (1/2)*n_1_z + t369, t370, t371, t372, t373, t374, t375, t376, t377, t378, t379, t380, t381, t382,
        t383, t384, t385, t386, t387, t388, t389, t390, t391, t392, t393, t394, t395, t396, t397, t398, t399,
        1, 1, 1, t400, D_p_x_1*t269 + D_p_y_1*t274 + D_p_z_1*t279 + t401, t402, t403, t404, t405, t367, t368,
        t369, D_p_x_2*t269 + D_p_x_2*t406 + D_p_y_2*t274 + D_p_y_2*t407 + D_p_z_2*t279 + D_p_z_2*t408 + 1/3,
        D_p_x_3*t406 + D_p_y_3*t407 + D_p_z_3*t408, D_delta_x_1*t406 + D_delta_y_1*t407 + D_delta_z_1*t408,
        D_delta_x_2*t406 + D_delta_y_2*t407 + D_delta_z_2*t408,
        D_delta_x_3*t406 + D_delta_y_3*t407 + D_delta_z_3*t408, (1/2)*n_2_x + t375, (1/2)*n_2_y + t376,
        (1/2)*n_2_z + t377, t378, t379, t380, t381, t382, t383, t384, t385, t386, t387, t388, t389, t390,
        t391, t392, t393, t394, t395, t396, t397, t398, t399, 1, 1, 1, t400, t401,
        D_p_x_1*t284 + D_p_y_1*t287 + D_p_z_1*t290 + t402, t403, t404, t405, t367, t368, t369, t370,
        D_p_x_2*t284 + D_p_y_2*t287 + D_p_z_2*t290 + t371, t372, t373, t374, t375, t376, t377,
        D_p_x_3*t284 + D_p_x_3*t409 + D_p_y_3*t287 + D_p_y_3*t410 + D_p_z_3*t290 + D_p_z_3*t411 + 1/3,
        D_delta_x_1*t409 + D_delta_y_1*t410 + D_delta_z_1*t411,
        D_delta_x_2*t409 + D_delta_y_2*t410 + D_delta_z_2*t411,
        D_delta_x_3*t409 + D_delta_y_3*t410 + D_delta_z_3*t411, (1/2)*n_3_x + t382, (1/2)*n_3_y + t383,
        (1/2)*n_3_z + t384, t385, t386, t387, t388, t389, t390, t391, t392, t393, t394, t395, t396, t397,
        t398, t399, 1, 1, 1, 1, n_1_x, n_1_y, n_1_z, 1, 1, 1, 1, n_2_x, n_2_y, n_2_z, 1, 1, 1, 1, n_3_x,
        n_3_y, n_3_z, 1, 1, 1, -t312, t413, t413, -t312, -t414, t413, -t414, t413, -t312, -t312, t415, t415,
        -t312, -t416, t415, -t416, t415, -t312, -t312, t417, t417, -t312, -t418, t417, -t418, t417, -t312,
        t419, t420, l_f_1_3*t422 + t423, R_p_1*l_f_1_1*t312, t419, l_f_1_2*t422 + t423, t420, t424, t425,
        l_f_2_3*t426 + t427, R_p_2*l_f_2_1*t312, t424, l_f_2_2*t426 + t427, t425, t428, t429,
        l_f_3_3*t430 + t431, R_p_3*l_f_3_1*t312, t428, l_f_3_2*t430 + t431, t429, 1, 1, 1, 1, 1, 1, t433,
        t433, t434, t434, t433 + t434, t436, t436, t437, t437, t436 + t437, t439, t439, t440, t440,
        t439 + t440, t442, t442, t443, t443, t442 + t443, t445, t445, t446, t446, t445 + t446, t448, t448,
        t449, t449, t448 + t449, -t312, -t294, -t312, -t313, -t414, -t450, -t294, -t312, -t312, -t340, -t312,
        -t343, -t416, -t451, -t340, -t312, -t312, -t349, -t312, -t352, -t418, -t452, -t349, -t312, t312, t294,
        t312, t450, t414, t294, t313, t312, t312, t340, t312, t451, t416, t340, t343, t312, t312, t349, t312,
        t452, t418, t349, t352, t312, t455, t457, t458, t455, t461, t463, t464, t461, t467, t469, t470, t467,
        t311*t454 + t472, (1/6)*t471, t457, t342*t460 + t474, (1/6)*t473, t463, t351*t466 + t476, (1/6)*t475,
        t469, t311*t453 + t472, t458, t342*t459 + t474, t464, t351*t465 + t476, t470, t455, t461, t467, d_1_1,
        d_2_1, d_3_1, d_1_2, d_2_2, d_3_2, t178, t182, t186, t190, t194, t198, D_p_x_1, D_p_y_1, D_p_z_1,
        t202, t206, t210, t214, t218, D_p_x_2, D_p_y_2, D_p_z_2, t222, t226, t230, t234, D_p_x_3, D_p_y_3,
        D_p_z_3, t238, t242, t246, D_delta_x_1, D_delta_y_1, D_delta_z_1, t250, t254, D_delta_x_2,
        D_delta_y_2, D_delta_z_2, t258, D_delta_x_3, D_delta_y_3, D_delta_z_3, 1, 1, 1, 1, 1, 1,
    ))
    K_theta_out = _listed(batch, dtype, (
        mu_1_by_m_p*t477 + mu_2_by_m_p*t478 + mu_3_by_m_p*t479,
        mu_1_by_m_p*t480 + mu_2_by_m_p*t481 + mu_3_by_m_p*t482,
        mu_1_by_m_p*t483 + mu_2_by_m_p*t484 + mu_3_by_m_p*t485,
        mu_1_by_m_p*t486 + mu_2_by_m_p*t487 + mu_3_by_m_p*t488,
        mu_1_by_m_p*t489 + mu_2_by_m_p*t490 + mu_3_by_m_p*t491,
        mu_1_by_m_p*t492 + mu_2_by_m_p*t493 + mu_3_by_m_p*t494,
        mu_1_by_m_p*t495 + mu_2_by_m_p*t496 + mu_3_by_m_p*t497,
        mu_1_by_m_p*t498 + mu_2_by_m_p*t499 + mu_3_by_m_p*t500,
        mu_1_by_m_p*t501 + mu_2_by_m_p*t502 + mu_3_by_m_p*t503,
        mu_1_by_m_p*t504 + mu_2_by_m_p*t505 + mu_3_by_m_p*t506,
        mu_1_by_m_p*t507 + mu_2_by_m_p*t508 + mu_3_by_m_p*t509,
        mu_1_by_m_p*t510 + mu_2_by_m_p*t511 + mu_3_by_m_p*t512,
        mu_1_by_m_p*t513 + mu_2_by_m_p*t514 + mu_3_by_m_p*t515,
        mu_1_by_m_p*t516 + mu_2_by_m_p*t517 + mu_3_by_m_p*t518,
        mu_1_by_m_p*t519 + mu_2_by_m_p*t520 + mu_3_by_m_p*t521,
        mu_1_by_m_p*t522 - mu_2_by_m_p*t238 - mu_3_by_m_p*t238,
        -mu_1_by_m_p*t242 - mu_2_by_m_p*t242 - mu_3_by_m_p*t242,
        -mu_1_by_m_p*t246 - mu_2_by_m_p*t246 - mu_3_by_m_p*t246,
        -mu_1_by_m_p*t250 + mu_2_by_m_p*t523 - mu_3_by_m_p*t250,
        -mu_1_by_m_p*t254 - mu_2_by_m_p*t254 - mu_3_by_m_p*t254,
        -mu_1_by_m_p*t258 - mu_2_by_m_p*t258 + mu_3_by_m_p*t524,
        mu_1_by_g_x*t477 + mu_2_by_g_x*t478 + mu_3_by_g_x*t479,
        mu_1_by_g_x*t480 + mu_2_by_g_x*t481 + mu_3_by_g_x*t482,
        mu_1_by_g_x*t483 + mu_2_by_g_x*t484 + mu_3_by_g_x*t485,
        mu_1_by_g_x*t486 + mu_2_by_g_x*t487 + mu_3_by_g_x*t488,
        mu_1_by_g_x*t489 + mu_2_by_g_x*t490 + mu_3_by_g_x*t491,
        mu_1_by_g_x*t492 + mu_2_by_g_x*t493 + mu_3_by_g_x*t494,
        mu_1_by_g_x*t495 + mu_2_by_g_x*t496 + mu_3_by_g_x*t497,
        mu_1_by_g_x*t498 + mu_2_by_g_x*t499 + mu_3_by_g_x*t500,
        mu_1_by_g_x*t501 + mu_2_by_g_x*t502 + mu_3_by_g_x*t503,
        mu_1_by_g_x*t504 + mu_2_by_g_x*t505 + mu_3_by_g_x*t506,
        mu_1_by_g_x*t507 + mu_2_by_g_x*t508 + mu_3_by_g_x*t509,
        mu_1_by_g_x*t510 + mu_2_by_g_x*t511 + mu_3_by_g_x*t512,
        mu_1_by_g_x*t513 + mu_2_by_g_x*t514 + mu_3_by_g_x*t515,
        mu_1_by_g_x*t516 + mu_2_by_g_x*t517 + mu_3_by_g_x*t518,
        mu_1_by_g_x*t519 + mu_2_by_g_x*t520 + mu_3_by_g_x*t521,
        mu_1_by_g_x*t522 - mu_2_by_g_x*t238 - mu_3_by_g_x*t238,
        -mu_1_by_g_x*t242 - mu_2_by_g_x*t242 - mu_3_by_g_x*t242,
        -mu_1_by_g_x*t246 - mu_2_by_g_x*t246 - mu_3_by_g_x*t246,
        -mu_1_by_g_x*t250 + mu_2_by_g_x*t523 - mu_3_by_g_x*t250,
        -mu_1_by_g_x*t254 - mu_2_by_g_x*t254 - mu_3_by_g_x*t254,
        -mu_1_by_g_x*t258 - mu_2_by_g_x*t258 + mu_3_by_g_x*t524,
        mu_1_by_g_y*t477 + mu_2_by_g_y*t478 + mu_3_by_g_y*t479,
        mu_1_by_g_y*t480 + mu_2_by_g_y*t481 + mu_3_by_g_y*t482,
        mu_1_by_g_y*t483 + mu_2_by_g_y*t484 + mu_3_by_g_y*t485,
        mu_1_by_g_y*t486 + mu_2_by_g_y*t487 + mu_3_by_g_y*t488,
        mu_1_by_g_y*t489 + mu_2_by_g_y*t490 + mu_3_by_g_y*t491,
        mu_1_by_g_y*t492 + mu_2_by_g_y*t493 + mu_3_by_g_y*t494,
        mu_1_by_g_y*t495 + mu_2_by_g_y*t496 + mu_3_by_g_y*t497,
        mu_1_by_g_y*t498 + mu_2_by_g_y*t499 + mu_3_by_g_y*t500,
        mu_1_by_g_y*t501 + mu_2_by_g_y*t502 + mu_3_by_g_y*t503,
        mu_1_by_g_y*t504 + mu_2_by_g_y*t505 + mu_3_by_g_y*t506,
        mu_1_by_g_y*t507 + mu_2_by_g_y*t508 + mu_3_by_g_y*t509,
        mu_1_by_g_y*t510 + mu_2_by_g_y*t511 + mu_3_by_g_y*t512,
        mu_1_by_g_y*t513 + mu_2_by_g_y*t514 + mu_3_by_g_y*t515,
        mu_1_by_g_y*t516 + mu_2_by_g_y*t517 + mu_3_by_g_y*t518,
        mu_1_by_g_y*t519 + mu_2_by_g_y*t520 + mu_3_by_g_y*t521,
        mu_1_by_g_y*t522 - mu_2_by_g_y*t238 - mu_3_by_g_y*t238,
        -mu_1_by_g_y*t242 - mu_2_by_g_y*t242 - mu_3_by_g_y*t242,
        -mu_1_by_g_y*t246 - mu_2_by_g_y*t246 - mu_3_by_g_y*t246,
        -mu_1_by_g_y*t250 + mu_2_by_g_y*t523 - mu_3_by_g_y*t250,
        -mu_1_by_g_y*t254 - mu_2_by_g_y*t254 - mu_3_by_g_y*t254,
        -mu_1_by_g_y*t258 - mu_2_by_g_y*t258 + mu_3_by_g_y*t524,
        mu_1_by_g_z*t477 + mu_2_by_g_z*t478 + mu_3_by_g_z*t479,
        mu_1_by_g_z*t480 + mu_2_by_g_z*t481 + mu_3_by_g_z*t482,
        mu_1_by_g_z*t483 + mu_2_by_g_z*t484 + mu_3_by_g_z*t485,
        mu_1_by_g_z*t486 + mu_2_by_g_z*t487 + mu_3_by_g_z*t488,
        mu_1_by_g_z*t489 + mu_2_by_g_z*t490 + mu_3_by_g_z*t491,
        mu_1_by_g_z*t492 + mu_2_by_g_z*t493 + mu_3_by_g_z*t494,
        mu_1_by_g_z*t495 + mu_2_by_g_z*t496 + mu_3_by_g_z*t497,
        mu_1_by_g_z*t498 + mu_2_by_g_z*t499 + mu_3_by_g_z*t500,
        mu_1_by_g_z*t501 + mu_2_by_g_z*t502 + mu_3_by_g_z*t503,
        mu_1_by_g_z*t504 + mu_2_by_g_z*t505 + mu_3_by_g_z*t506,
        mu_1_by_g_z*t507 + mu_2_by_g_z*t508 + mu_3_by_g_z*t509,
        mu_1_by_g_z*t510 + mu_2_by_g_z*t511 + mu_3_by_g_z*t512,
        mu_1_by_g_z*t513 + mu_2_by_g_z*t514 + mu_3_by_g_z*t515,
        mu_1_by_g_z*t516 + mu_2_by_g_z*t517 + mu_3_by_g_z*t518,
        mu_1_by_g_z*t519 + mu_2_by_g_z*t520 + mu_3_by_g_z*t521,
        mu_1_by_g_z*t522 - mu_2_by_g_z*t238 - mu_3_by_g_z*t238,
        -mu_1_by_g_z*t242 - mu_2_by_g_z*t242 - mu_3_by_g_z*t242,
        -mu_1_by_g_z*t246 - mu_2_by_g_z*t246 - mu_3_by_g_z*t246,
        -mu_1_by_g_z*t250 + mu_2_by_g_z*t523 - mu_3_by_g_z*t250,
        -mu_1_by_g_z*t254 - mu_2_by_g_z*t254 - mu_3_by_g_z*t254,
        -mu_1_by_g_z*t258 - mu_2_by_g_z*t258 + mu_3_by_g_z*t524,
        2*D_p_x_1*D_p_x_1_by_b_1_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_x*k_C
        + k_sp_1*t11*t540*w_b_1*x_1_by_b_1_x + mu_1_by_b_1_x*t477 + mu_2_by_b_1_x*t478
        + mu_3_by_b_1_x*t479 - t525*t526 - t526*t527 - t526*t528 - t529*t530 - t530*t531 - t530*t532
        - t533*t534 - t534*t535 - t534*t536 - t539,
        D_p_x_1*D_p_x_2_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_2*k_C - D_p_x_1_by_b_1_x*t541
        - D_p_x_1_by_b_1_x*t542 - D_p_x_1_by_b_1_x*t543 - D_p_x_2_by_b_1_x*t525 - D_p_x_2_by_b_1_x*t527
        - D_p_x_2_by_b_1_x*t528 + D_p_y_1*D_p_y_2_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_2*k_C
        - D_p_y_1_by_b_1_x*t544 - D_p_y_1_by_b_1_x*t545 - D_p_y_1_by_b_1_x*t546 - D_p_y_2_by_b_1_x*t529
        - D_p_y_2_by_b_1_x*t531 - D_p_y_2_by_b_1_x*t532 + D_p_z_1*D_p_z_2_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_2*k_C - D_p_z_1_by_b_1_x*t547 - D_p_z_1_by_b_1_x*t548
        - D_p_z_1_by_b_1_x*t549 - D_p_z_2_by_b_1_x*t533 - D_p_z_2_by_b_1_x*t535 - D_p_z_2_by_b_1_x*t536
        + mu_1_by_b_1_x*t480 + mu_2_by_b_1_x*t481 + mu_3_by_b_1_x*t482,
        D_p_x_1*D_p_x_3_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_3*k_C - D_p_x_1_by_b_1_x*t550
        - D_p_x_1_by_b_1_x*t551 - D_p_x_1_by_b_1_x*t552 - D_p_x_3_by_b_1_x*t525 - D_p_x_3_by_b_1_x*t527
        - D_p_x_3_by_b_1_x*t528 + D_p_y_1*D_p_y_3_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_3*k_C
        - D_p_y_1_by_b_1_x*t553 - D_p_y_1_by_b_1_x*t554 - D_p_y_1_by_b_1_x*t555 - D_p_y_3_by_b_1_x*t529
        - D_p_y_3_by_b_1_x*t531 - D_p_y_3_by_b_1_x*t532 + D_p_z_1*D_p_z_3_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_3*k_C - D_p_z_1_by_b_1_x*t556 - D_p_z_1_by_b_1_x*t557
        - D_p_z_1_by_b_1_x*t558 - D_p_z_3_by_b_1_x*t533 - D_p_z_3_by_b_1_x*t535 - D_p_z_3_by_b_1_x*t536
        + mu_1_by_b_1_x*t483 + mu_2_by_b_1_x*t484 + mu_3_by_b_1_x*t485,
        t561, t562,
        D_delta_x_1*t563 + D_delta_x_1_by_b_1_x*t575 + D_delta_y_1*t564 + D_delta_y_1_by_b_1_x*t576
        + D_delta_z_1*t565 + D_delta_z_1_by_b_1_x*t577 - D_p_x_1_by_b_1_x*t566 - D_p_x_1_by_b_1_x*t567
        - D_p_x_1_by_b_1_x*t568 - D_p_y_1_by_b_1_x*t569 - D_p_y_1_by_b_1_x*t570 - D_p_y_1_by_b_1_x*t571
        - D_p_z_1_by_b_1_x*t572 - D_p_z_1_by_b_1_x*t573 - D_p_z_1_by_b_1_x*t574 + mu_1_by_b_1_x*t486
        + mu_2_by_b_1_x*t487 + mu_3_by_b_1_x*t488,
        D_delta_x_2*t563 + D_delta_x_2_by_b_1_x*t575 + D_delta_y_2*t564 + D_delta_y_2_by_b_1_x*t576
        + D_delta_z_2*t565 + D_delta_z_2_by_b_1_x*t577 - D_p_x_1_by_b_1_x*t578 - D_p_x_1_by_b_1_x*t579
        - D_p_x_1_by_b_1_x*t580 - D_p_y_1_by_b_1_x*t581 - D_p_y_1_by_b_1_x*t582 - D_p_y_1_by_b_1_x*t583
        - D_p_z_1_by_b_1_x*t584 - D_p_z_1_by_b_1_x*t585 - D_p_z_1_by_b_1_x*t586 + mu_1_by_b_1_x*t489
        + mu_2_by_b_1_x*t490 + mu_3_by_b_1_x*t491,
        D_delta_x_3*t563 + D_delta_x_3_by_b_1_x*t575 + D_delta_y_3*t564 + D_delta_y_3_by_b_1_x*t576
        + D_delta_z_3*t565 + D_delta_z_3_by_b_1_x*t577 - D_p_x_1_by_b_1_x*t587 - D_p_x_1_by_b_1_x*t588
        - D_p_x_1_by_b_1_x*t589 - D_p_y_1_by_b_1_x*t590 - D_p_y_1_by_b_1_x*t591 - D_p_y_1_by_b_1_x*t592
        - D_p_z_1_by_b_1_x*t593 - D_p_z_1_by_b_1_x*t594 - D_p_z_1_by_b_1_x*t595 + mu_1_by_b_1_x*t492
        + mu_2_by_b_1_x*t493 + mu_3_by_b_1_x*t494,
        t596, t563, t564, t565,
        2*D_p_x_2*D_p_x_2_by_b_1_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_x*k_C
        + mu_1_by_b_1_x*t495 + mu_2_by_b_1_x*t496 + mu_3_by_b_1_x*t497 - t541*t597 - t542*t597 - t543*t597
        - t544*t598 - t545*t598 - t546*t598 - t547*t599 - t548*t599 - t549*t599,
        D_p_x_2*D_p_x_3_by_b_1_x*k_C + D_p_x_2_by_b_1_x*D_p_x_3*k_C - D_p_x_2_by_b_1_x*t550
        - D_p_x_2_by_b_1_x*t551 - D_p_x_2_by_b_1_x*t552 - D_p_x_3_by_b_1_x*t541 - D_p_x_3_by_b_1_x*t542
        - D_p_x_3_by_b_1_x*t543 + D_p_y_2*D_p_y_3_by_b_1_x*k_C + D_p_y_2_by_b_1_x*D_p_y_3*k_C
        - D_p_y_2_by_b_1_x*t553 - D_p_y_2_by_b_1_x*t554 - D_p_y_2_by_b_1_x*t555 - D_p_y_3_by_b_1_x*t544
        - D_p_y_3_by_b_1_x*t545 - D_p_y_3_by_b_1_x*t546 + D_p_z_2*D_p_z_3_by_b_1_x*k_C
        + D_p_z_2_by_b_1_x*D_p_z_3*k_C - D_p_z_2_by_b_1_x*t556 - D_p_z_2_by_b_1_x*t557
        - D_p_z_2_by_b_1_x*t558 - D_p_z_3_by_b_1_x*t547 - D_p_z_3_by_b_1_x*t548 - D_p_z_3_by_b_1_x*t549
        + mu_1_by_b_1_x*t498 + mu_2_by_b_1_x*t499 + mu_3_by_b_1_x*t500,
        D_delta_x_1*t600 + D_delta_x_1_by_b_1_x*t603 + D_delta_y_1*t601 + D_delta_y_1_by_b_1_x*t604
        + D_delta_z_1*t602 + D_delta_z_1_by_b_1_x*t605 - D_p_x_2_by_b_1_x*t566 - D_p_x_2_by_b_1_x*t567
        - D_p_x_2_by_b_1_x*t568 - D_p_y_2_by_b_1_x*t569 - D_p_y_2_by_b_1_x*t570 - D_p_y_2_by_b_1_x*t571
        - D_p_z_2_by_b_1_x*t572 - D_p_z_2_by_b_1_x*t573 - D_p_z_2_by_b_1_x*t574 + mu_1_by_b_1_x*t501
        + mu_2_by_b_1_x*t502 + mu_3_by_b_1_x*t503,
        D_delta_x_2*t600 + D_delta_x_2_by_b_1_x*t603 + D_delta_y_2*t601 + D_delta_y_2_by_b_1_x*t604
        + D_delta_z_2*t602 + D_delta_z_2_by_b_1_x*t605 - D_p_x_2_by_b_1_x*t578 - D_p_x_2_by_b_1_x*t579
        - D_p_x_2_by_b_1_x*t580 - D_p_y_2_by_b_1_x*t581 - D_p_y_2_by_b_1_x*t582 - D_p_y_2_by_b_1_x*t583
        - D_p_z_2_by_b_1_x*t584 - D_p_z_2_by_b_1_x*t585 - D_p_z_2_by_b_1_x*t586 + mu_1_by_b_1_x*t504
        + mu_2_by_b_1_x*t505 + mu_3_by_b_1_x*t506,
        D_delta_x_3*t600 + D_delta_x_3_by_b_1_x*t603 + D_delta_y_3*t601 + D_delta_y_3_by_b_1_x*t604
        + D_delta_z_3*t602 + D_delta_z_3_by_b_1_x*t605 - D_p_x_2_by_b_1_x*t587 - D_p_x_2_by_b_1_x*t588
        - D_p_x_2_by_b_1_x*t589 - D_p_y_2_by_b_1_x*t590 - D_p_y_2_by_b_1_x*t591 - D_p_y_2_by_b_1_x*t592
        - D_p_z_2_by_b_1_x*t593 - D_p_z_2_by_b_1_x*t594 - D_p_z_2_by_b_1_x*t595 + mu_1_by_b_1_x*t507
        + mu_2_by_b_1_x*t508 + mu_3_by_b_1_x*t509,
        t600, t601, t602,
        2*D_p_x_3*D_p_x_3_by_b_1_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_x*k_C
        + mu_1_by_b_1_x*t510 + mu_2_by_b_1_x*t511 + mu_3_by_b_1_x*t512 - t550*t606 - t551*t606 - t552*t606
        - t553*t607 - t554*t607 - t555*t607 - t556*t608 - t557*t608 - t558*t608,
        D_delta_x_1*t609 + D_delta_x_1_by_b_1_x*t612 + D_delta_y_1*t610 + D_delta_y_1_by_b_1_x*t613
        + D_delta_z_1*t611 + D_delta_z_1_by_b_1_x*t614 - D_p_x_3_by_b_1_x*t566 - D_p_x_3_by_b_1_x*t567
        - D_p_x_3_by_b_1_x*t568 - D_p_y_3_by_b_1_x*t569 - D_p_y_3_by_b_1_x*t570 - D_p_y_3_by_b_1_x*t571
        - D_p_z_3_by_b_1_x*t572 - D_p_z_3_by_b_1_x*t573 - D_p_z_3_by_b_1_x*t574 + mu_1_by_b_1_x*t513
        + mu_2_by_b_1_x*t514 + mu_3_by_b_1_x*t515,
        D_delta_x_2*t609 + D_delta_x_2_by_b_1_x*t612 + D_delta_y_2*t610 + D_delta_y_2_by_b_1_x*t613
        + D_delta_z_2*t611 + D_delta_z_2_by_b_1_x*t614 - D_p_x_3_by_b_1_x*t578 - D_p_x_3_by_b_1_x*t579
        - D_p_x_3_by_b_1_x*t580 - D_p_y_3_by_b_1_x*t581 - D_p_y_3_by_b_1_x*t582 - D_p_y_3_by_b_1_x*t583
        - D_p_z_3_by_b_1_x*t584 - D_p_z_3_by_b_1_x*t585 - D_p_z_3_by_b_1_x*t586 + mu_1_by_b_1_x*t516
        + mu_2_by_b_1_x*t517 + mu_3_by_b_1_x*t518,
        D_delta_x_3*t609 + D_delta_x_3_by_b_1_x*t612 + D_delta_y_3*t610 + D_delta_y_3_by_b_1_x*t613
        + D_delta_z_3*t611 + D_delta_z_3_by_b_1_x*t614 - D_p_x_3_by_b_1_x*t587 - D_p_x_3_by_b_1_x*t588
        - D_p_x_3_by_b_1_x*t589 - D_p_y_3_by_b_1_x*t590 - D_p_y_3_by_b_1_x*t591 - D_p_y_3_by_b_1_x*t592
        - D_p_z_3_by_b_1_x*t593 - D_p_z_3_by_b_1_x*t594 - D_p_z_3_by_b_1_x*t595 + mu_1_by_b_1_x*t519
        + mu_2_by_b_1_x*t520 + mu_3_by_b_1_x*t521,
        t609, t610, t611, t311*t560, t561, -t311*t539, t562,
        D_delta_x_1_by_b_1_x*t615 + D_delta_y_1_by_b_1_x*t616 + D_delta_z_1_by_b_1_x*t617
        + mu_1_by_b_1_x*t522 - mu_2_by_b_1_x*t238 - mu_3_by_b_1_x*t238,
        D_delta_x_1_by_b_1_x*t618 + D_delta_x_2_by_b_1_x*t619 + D_delta_y_1_by_b_1_x*t620
        + D_delta_y_2_by_b_1_x*t621 + D_delta_z_1_by_b_1_x*t622 + D_delta_z_2_by_b_1_x*t623
        - mu_1_by_b_1_x*t242 - mu_2_by_b_1_x*t242 - mu_3_by_b_1_x*t242,
        D_delta_x_1_by_b_1_x*t624 + D_delta_x_3_by_b_1_x*t619 + D_delta_y_1_by_b_1_x*t625
        + D_delta_y_3_by_b_1_x*t621 + D_delta_z_1_by_b_1_x*t626 + D_delta_z_3_by_b_1_x*t623
        - mu_1_by_b_1_x*t246 - mu_2_by_b_1_x*t246 - mu_3_by_b_1_x*t246,
        D_delta_x_1_by_b_1_x*k_C, D_delta_y_1_by_b_1_x*k_C, D_delta_z_1_by_b_1_x*k_C,
        D_delta_x_2_by_b_1_x*t627 + D_delta_y_2_by_b_1_x*t628 + D_delta_z_2_by_b_1_x*t629
        - mu_1_by_b_1_x*t250 + mu_2_by_b_1_x*t523 - mu_3_by_b_1_x*t250,
        D_delta_x_2_by_b_1_x*t624 + D_delta_x_3_by_b_1_x*t618 + D_delta_y_2_by_b_1_x*t625
        + D_delta_y_3_by_b_1_x*t620 + D_delta_z_2_by_b_1_x*t626 + D_delta_z_3_by_b_1_x*t622
        - mu_1_by_b_1_x*t254 - mu_2_by_b_1_x*t254 - mu_3_by_b_1_x*t254,
        D_delta_x_2_by_b_1_x*k_C, D_delta_y_2_by_b_1_x*k_C, D_delta_z_2_by_b_1_x*k_C,
        D_delta_x_3_by_b_1_x*t630 + D_delta_y_3_by_b_1_x*t631 + D_delta_z_3_by_b_1_x*t632
        - mu_1_by_b_1_x*t258 - mu_2_by_b_1_x*t258 + mu_3_by_b_1_x*t524,
        D_delta_x_3_by_b_1_x*k_C, D_delta_y_3_by_b_1_x*k_C, D_delta_z_3_by_b_1_x*k_C, t596,
        2*D_p_x_1*D_p_x_1_by_b_1_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_y*k_C
        + k_sp_1*t11*t540*w_b_1*x_1_by_b_1_y + mu_1_by_b_1_y*t477 + mu_2_by_b_1_y*t478
        + mu_3_by_b_1_y*t479 - t525*t633 - t527*t633 - t528*t633 - t529*t634 - t531*t634 - t532*t634
        - t533*t635 - t535*t635 - t536*t635 - t636,
        D_p_x_1*D_p_x_2_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_2*k_C - D_p_x_1_by_b_1_y*t541
        - D_p_x_1_by_b_1_y*t542 - D_p_x_1_by_b_1_y*t543 - D_p_x_2_by_b_1_y*t525 - D_p_x_2_by_b_1_y*t527
        - D_p_x_2_by_b_1_y*t528 + D_p_y_1*D_p_y_2_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_2*k_C
        - D_p_y_1_by_b_1_y*t544 - D_p_y_1_by_b_1_y*t545 - D_p_y_1_by_b_1_y*t546 - D_p_y_2_by_b_1_y*t529
        - D_p_y_2_by_b_1_y*t531 - D_p_y_2_by_b_1_y*t532 + D_p_z_1*D_p_z_2_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_2*k_C - D_p_z_1_by_b_1_y*t547 - D_p_z_1_by_b_1_y*t548
        - D_p_z_1_by_b_1_y*t549 - D_p_z_2_by_b_1_y*t533 - D_p_z_2_by_b_1_y*t535 - D_p_z_2_by_b_1_y*t536
        + mu_1_by_b_1_y*t480 + mu_2_by_b_1_y*t481 + mu_3_by_b_1_y*t482,
        D_p_x_1*D_p_x_3_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_3*k_C - D_p_x_1_by_b_1_y*t550
        - D_p_x_1_by_b_1_y*t551 - D_p_x_1_by_b_1_y*t552 - D_p_x_3_by_b_1_y*t525 - D_p_x_3_by_b_1_y*t527
        - D_p_x_3_by_b_1_y*t528 + D_p_y_1*D_p_y_3_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_3*k_C
        - D_p_y_1_by_b_1_y*t553 - D_p_y_1_by_b_1_y*t554 - D_p_y_1_by_b_1_y*t555 - D_p_y_3_by_b_1_y*t529
        - D_p_y_3_by_b_1_y*t531 - D_p_y_3_by_b_1_y*t532 + D_p_z_1*D_p_z_3_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_3*k_C - D_p_z_1_by_b_1_y*t556 - D_p_z_1_by_b_1_y*t557
        - D_p_z_1_by_b_1_y*t558 - D_p_z_3_by_b_1_y*t533 - D_p_z_3_by_b_1_y*t535 - D_p_z_3_by_b_1_y*t536
        + mu_1_by_b_1_y*t483 + mu_2_by_b_1_y*t484 + mu_3_by_b_1_y*t485,
        t638, t639,
        D_delta_x_1_by_b_1_y*t575 + D_delta_y_1_by_b_1_y*t576 + D_delta_z_1_by_b_1_y*t577
        - D_p_x_1_by_b_1_y*t566 - D_p_x_1_by_b_1_y*t567 - D_p_x_1_by_b_1_y*t568 + D_p_x_1_by_b_1_y*t640
        - D_p_y_1_by_b_1_y*t569 - D_p_y_1_by_b_1_y*t570 - D_p_y_1_by_b_1_y*t571 + D_p_y_1_by_b_1_y*t641
        - D_p_z_1_by_b_1_y*t572 - D_p_z_1_by_b_1_y*t573 - D_p_z_1_by_b_1_y*t574 + D_p_z_1_by_b_1_y*t642
        + mu_1_by_b_1_y*t486 + mu_2_by_b_1_y*t487 + mu_3_by_b_1_y*t488,
        D_delta_x_2_by_b_1_y*t575 + D_delta_y_2_by_b_1_y*t576 + D_delta_z_2_by_b_1_y*t577
        - D_p_x_1_by_b_1_y*t578 - D_p_x_1_by_b_1_y*t579 - D_p_x_1_by_b_1_y*t580 + D_p_x_1_by_b_1_y*t643
        - D_p_y_1_by_b_1_y*t581 - D_p_y_1_by_b_1_y*t582 - D_p_y_1_by_b_1_y*t583 + D_p_y_1_by_b_1_y*t644
        - D_p_z_1_by_b_1_y*t584 - D_p_z_1_by_b_1_y*t585 - D_p_z_1_by_b_1_y*t586 + D_p_z_1_by_b_1_y*t645
        + mu_1_by_b_1_y*t489 + mu_2_by_b_1_y*t490 + mu_3_by_b_1_y*t491,
        D_delta_x_3_by_b_1_y*t575 + D_delta_y_3_by_b_1_y*t576 + D_delta_z_3_by_b_1_y*t577
        - D_p_x_1_by_b_1_y*t587 - D_p_x_1_by_b_1_y*t588 - D_p_x_1_by_b_1_y*t589 + D_p_x_1_by_b_1_y*t646
        - D_p_y_1_by_b_1_y*t590 - D_p_y_1_by_b_1_y*t591 - D_p_y_1_by_b_1_y*t592 + D_p_y_1_by_b_1_y*t647
        - D_p_z_1_by_b_1_y*t593 - D_p_z_1_by_b_1_y*t594 - D_p_z_1_by_b_1_y*t595 + D_p_z_1_by_b_1_y*t648
        + mu_1_by_b_1_y*t492 + mu_2_by_b_1_y*t493 + mu_3_by_b_1_y*t494,
        t649, D_p_x_1_by_b_1_y*k_C, D_p_y_1_by_b_1_y*k_C, D_p_z_1_by_b_1_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_y*k_C
        + mu_1_by_b_1_y*t495 + mu_2_by_b_1_y*t496 + mu_3_by_b_1_y*t497 - t541*t650 - t542*t650 - t543*t650
        - t544*t651 - t545*t651 - t546*t651 - t547*t652 - t548*t652 - t549*t652,
        D_p_x_2*D_p_x_3_by_b_1_y*k_C + D_p_x_2_by_b_1_y*D_p_x_3*k_C - D_p_x_2_by_b_1_y*t550
        - D_p_x_2_by_b_1_y*t551 - D_p_x_2_by_b_1_y*t552 - D_p_x_3_by_b_1_y*t541 - D_p_x_3_by_b_1_y*t542
        - D_p_x_3_by_b_1_y*t543 + D_p_y_2*D_p_y_3_by_b_1_y*k_C + D_p_y_2_by_b_1_y*D_p_y_3*k_C
        - D_p_y_2_by_b_1_y*t553 - D_p_y_2_by_b_1_y*t554 - D_p_y_2_by_b_1_y*t555 - D_p_y_3_by_b_1_y*t544
        - D_p_y_3_by_b_1_y*t545 - D_p_y_3_by_b_1_y*t546 + D_p_z_2*D_p_z_3_by_b_1_y*k_C
        + D_p_z_2_by_b_1_y*D_p_z_3*k_C - D_p_z_2_by_b_1_y*t556 - D_p_z_2_by_b_1_y*t557
        - D_p_z_2_by_b_1_y*t558 - D_p_z_3_by_b_1_y*t547 - D_p_z_3_by_b_1_y*t548 - D_p_z_3_by_b_1_y*t549
        + mu_1_by_b_1_y*t498 + mu_2_by_b_1_y*t499 + mu_3_by_b_1_y*t500,
        D_delta_x_1_by_b_1_y*t603 + D_delta_y_1_by_b_1_y*t604 + D_delta_z_1_by_b_1_y*t605
        - D_p_x_2_by_b_1_y*t566 - D_p_x_2_by_b_1_y*t567 - D_p_x_2_by_b_1_y*t568 + D_p_x_2_by_b_1_y*t640
        - D_p_y_2_by_b_1_y*t569 - D_p_y_2_by_b_1_y*t570 - D_p_y_2_by_b_1_y*t571 + D_p_y_2_by_b_1_y*t641
        - D_p_z_2_by_b_1_y*t572 - D_p_z_2_by_b_1_y*t573 - D_p_z_2_by_b_1_y*t574 + D_p_z_2_by_b_1_y*t642
        + mu_1_by_b_1_y*t501 + mu_2_by_b_1_y*t502 + mu_3_by_b_1_y*t503,
        D_delta_x_2_by_b_1_y*t603 + D_delta_y_2_by_b_1_y*t604 + D_delta_z_2_by_b_1_y*t605
        - D_p_x_2_by_b_1_y*t578 - D_p_x_2_by_b_1_y*t579 - D_p_x_2_by_b_1_y*t580 + D_p_x_2_by_b_1_y*t643
        - D_p_y_2_by_b_1_y*t581 - D_p_y_2_by_b_1_y*t582 - D_p_y_2_by_b_1_y*t583 + D_p_y_2_by_b_1_y*t644
        - D_p_z_2_by_b_1_y*t584 - D_p_z_2_by_b_1_y*t585 - D_p_z_2_by_b_1_y*t586 + D_p_z_2_by_b_1_y*t645
        + mu_1_by_b_1_y*t504 + mu_2_by_b_1_y*t505 + mu_3_by_b_1_y*t506,
        D_delta_x_3_by_b_1_y*t603 + D_delta_y_3_by_b_1_y*t604 + D_delta_z_3_by_b_1_y*t605
        - D_p_x_2_by_b_1_y*t587 - D_p_x_2_by_b_1_y*t588 - D_p_x_2_by_b_1_y*t589 + D_p_x_2_by_b_1_y*t646
        - D_p_y_2_by_b_1_y*t590 - D_p_y_2_by_b_1_y*t591 - D_p_y_2_by_b_1_y*t592 + D_p_y_2_by_b_1_y*t647
        - D_p_z_2_by_b_1_y*t593 - D_p_z_2_by_b_1_y*t594 - D_p_z_2_by_b_1_y*t595 + D_p_z_2_by_b_1_y*t648
        + mu_1_by_b_1_y*t507 + mu_2_by_b_1_y*t508 + mu_3_by_b_1_y*t509,
        D_p_x_2_by_b_1_y*k_C, D_p_y_2_by_b_1_y*k_C, D_p_z_2_by_b_1_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_y*k_C
        + mu_1_by_b_1_y*t510 + mu_2_by_b_1_y*t511 + mu_3_by_b_1_y*t512 - t550*t653 - t551*t653 - t552*t653
        - t553*t654 - t554*t654 - t555*t654 - t556*t655 - t557*t655 - t558*t655,
        D_delta_x_1_by_b_1_y*t612 + D_delta_y_1_by_b_1_y*t613 + D_delta_z_1_by_b_1_y*t614
        - D_p_x_3_by_b_1_y*t566 - D_p_x_3_by_b_1_y*t567 - D_p_x_3_by_b_1_y*t568 + D_p_x_3_by_b_1_y*t640
        - D_p_y_3_by_b_1_y*t569 - D_p_y_3_by_b_1_y*t570 - D_p_y_3_by_b_1_y*t571 + D_p_y_3_by_b_1_y*t641
        - D_p_z_3_by_b_1_y*t572 - D_p_z_3_by_b_1_y*t573 - D_p_z_3_by_b_1_y*t574 + D_p_z_3_by_b_1_y*t642
        + mu_1_by_b_1_y*t513 + mu_2_by_b_1_y*t514 + mu_3_by_b_1_y*t515,
        D_delta_x_2_by_b_1_y*t612 + D_delta_y_2_by_b_1_y*t613 + D_delta_z_2_by_b_1_y*t614
        - D_p_x_3_by_b_1_y*t578 - D_p_x_3_by_b_1_y*t579 - D_p_x_3_by_b_1_y*t580 + D_p_x_3_by_b_1_y*t643
        - D_p_y_3_by_b_1_y*t581 - D_p_y_3_by_b_1_y*t582 - D_p_y_3_by_b_1_y*t583 + D_p_y_3_by_b_1_y*t644
        - D_p_z_3_by_b_1_y*t584 - D_p_z_3_by_b_1_y*t585 - D_p_z_3_by_b_1_y*t586 + D_p_z_3_by_b_1_y*t645
        + mu_1_by_b_1_y*t516 + mu_2_by_b_1_y*t517 + mu_3_by_b_1_y*t518,
        D_delta_x_3_by_b_1_y*t612 + D_delta_y_3_by_b_1_y*t613 + D_delta_z_3_by_b_1_y*t614
        - D_p_x_3_by_b_1_y*t587 - D_p_x_3_by_b_1_y*t588 - D_p_x_3_by_b_1_y*t589 + D_p_x_3_by_b_1_y*t646
        - D_p_y_3_by_b_1_y*t590 - D_p_y_3_by_b_1_y*t591 - D_p_y_3_by_b_1_y*t592 + D_p_y_3_by_b_1_y*t647
        - D_p_z_3_by_b_1_y*t593 - D_p_z_3_by_b_1_y*t594 - D_p_z_3_by_b_1_y*t595 + D_p_z_3_by_b_1_y*t648
        + mu_1_by_b_1_y*t519 + mu_2_by_b_1_y*t520 + mu_3_by_b_1_y*t521,
        D_p_x_3_by_b_1_y*k_C, D_p_y_3_by_b_1_y*k_C, D_p_z_3_by_b_1_y*k_C, t311*t637, t638, -t311*t636, t639,
        D_delta_x_1_by_b_1_y*t615 + D_delta_y_1_by_b_1_y*t616 + D_delta_z_1_by_b_1_y*t617
        + mu_1_by_b_1_y*t522 - mu_2_by_b_1_y*t238 - mu_3_by_b_1_y*t238,
        D_delta_x_1_by_b_1_y*t618 + D_delta_x_2_by_b_1_y*t619 + D_delta_y_1_by_b_1_y*t620
        + D_delta_y_2_by_b_1_y*t621 + D_delta_z_1_by_b_1_y*t622 + D_delta_z_2_by_b_1_y*t623
        - mu_1_by_b_1_y*t242 - mu_2_by_b_1_y*t242 - mu_3_by_b_1_y*t242,
        D_delta_x_1_by_b_1_y*t624 + D_delta_x_3_by_b_1_y*t619 + D_delta_y_1_by_b_1_y*t625
        + D_delta_y_3_by_b_1_y*t621 + D_delta_z_1_by_b_1_y*t626 + D_delta_z_3_by_b_1_y*t623
        - mu_1_by_b_1_y*t246 - mu_2_by_b_1_y*t246 - mu_3_by_b_1_y*t246,
        D_delta_x_1_by_b_1_y*k_C, D_delta_y_1_by_b_1_y*k_C, D_delta_z_1_by_b_1_y*k_C,
        D_delta_x_2_by_b_1_y*t627 + D_delta_y_2_by_b_1_y*t628 + D_delta_z_2_by_b_1_y*t629
        - mu_1_by_b_1_y*t250 + mu_2_by_b_1_y*t523 - mu_3_by_b_1_y*t250,
        D_delta_x_2_by_b_1_y*t624 + D_delta_x_3_by_b_1_y*t618 + D_delta_y_2_by_b_1_y*t625
        + D_delta_y_3_by_b_1_y*t620 + D_delta_z_2_by_b_1_y*t626 + D_delta_z_3_by_b_1_y*t622
        - mu_1_by_b_1_y*t254 - mu_2_by_b_1_y*t254 - mu_3_by_b_1_y*t254,
        D_delta_x_2_by_b_1_y*k_C, D_delta_y_2_by_b_1_y*k_C, D_delta_z_2_by_b_1_y*k_C,
        D_delta_x_3_by_b_1_y*t630 + D_delta_y_3_by_b_1_y*t631 + D_delta_z_3_by_b_1_y*t632
        - mu_1_by_b_1_y*t258 - mu_2_by_b_1_y*t258 + mu_3_by_b_1_y*t524,
        D_delta_x_3_by_b_1_y*k_C, D_delta_y_3_by_b_1_y*k_C, D_delta_z_3_by_b_1_y*k_C, t649,
        2*D_p_x_1*D_p_x_1_by_b_1_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_z*k_C
        + k_sp_1*t11*t540*w_b_1*x_1_by_b_1_z + mu_1_by_b_1_z*t477 + mu_2_by_b_1_z*t478
        + mu_3_by_b_1_z*t479 - t525*t656 - t527*t656 - t528*t656 - t529*t657 - t531*t657 - t532*t657
        - t533*t658 - t535*t658 - t536*t658 - t659,
        D_p_x_1*D_p_x_2_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_2*k_C - D_p_x_1_by_b_1_z*t541
        - D_p_x_1_by_b_1_z*t542 - D_p_x_1_by_b_1_z*t543 - D_p_x_2_by_b_1_z*t525 - D_p_x_2_by_b_1_z*t527
        - D_p_x_2_by_b_1_z*t528 + D_p_y_1*D_p_y_2_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_2*k_C
        - D_p_y_1_by_b_1_z*t544 - D_p_y_1_by_b_1_z*t545 - D_p_y_1_by_b_1_z*t546 - D_p_y_2_by_b_1_z*t529
        - D_p_y_2_by_b_1_z*t531 - D_p_y_2_by_b_1_z*t532 + D_p_z_1*D_p_z_2_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_2*k_C - D_p_z_1_by_b_1_z*t547 - D_p_z_1_by_b_1_z*t548
        - D_p_z_1_by_b_1_z*t549 - D_p_z_2_by_b_1_z*t533 - D_p_z_2_by_b_1_z*t535 - D_p_z_2_by_b_1_z*t536
        + mu_1_by_b_1_z*t480 + mu_2_by_b_1_z*t481 + mu_3_by_b_1_z*t482,
        D_p_x_1*D_p_x_3_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_3*k_C - D_p_x_1_by_b_1_z*t550
        - D_p_x_1_by_b_1_z*t551 - D_p_x_1_by_b_1_z*t552 - D_p_x_3_by_b_1_z*t525 - D_p_x_3_by_b_1_z*t527
        - D_p_x_3_by_b_1_z*t528 + D_p_y_1*D_p_y_3_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_3*k_C
        - D_p_y_1_by_b_1_z*t553 - D_p_y_1_by_b_1_z*t554 - D_p_y_1_by_b_1_z*t555 - D_p_y_3_by_b_1_z*t529
        - D_p_y_3_by_b_1_z*t531 - D_p_y_3_by_b_1_z*t532 + D_p_z_1*D_p_z_3_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_3*k_C - D_p_z_1_by_b_1_z*t556 - D_p_z_1_by_b_1_z*t557
        - D_p_z_1_by_b_1_z*t558 - D_p_z_3_by_b_1_z*t533 - D_p_z_3_by_b_1_z*t535 - D_p_z_3_by_b_1_z*t536
        + mu_1_by_b_1_z*t483 + mu_2_by_b_1_z*t484 + mu_3_by_b_1_z*t485,
        t661, t662,
        D_delta_x_1_by_b_1_z*t575 + D_delta_y_1_by_b_1_z*t576 + D_delta_z_1_by_b_1_z*t577
        - D_p_x_1_by_b_1_z*t566 - D_p_x_1_by_b_1_z*t567 - D_p_x_1_by_b_1_z*t568 + D_p_x_1_by_b_1_z*t640
        - D_p_y_1_by_b_1_z*t569 - D_p_y_1_by_b_1_z*t570 - D_p_y_1_by_b_1_z*t571 + D_p_y_1_by_b_1_z*t641
        - D_p_z_1_by_b_1_z*t572 - D_p_z_1_by_b_1_z*t573 - D_p_z_1_by_b_1_z*t574 + D_p_z_1_by_b_1_z*t642
        + mu_1_by_b_1_z*t486 + mu_2_by_b_1_z*t487 + mu_3_by_b_1_z*t488,
        D_delta_x_2_by_b_1_z*t575 + D_delta_y_2_by_b_1_z*t576 + D_delta_z_2_by_b_1_z*t577
        - D_p_x_1_by_b_1_z*t578 - D_p_x_1_by_b_1_z*t579 - D_p_x_1_by_b_1_z*t580 + D_p_x_1_by_b_1_z*t643
        - D_p_y_1_by_b_1_z*t581 - D_p_y_1_by_b_1_z*t582 - D_p_y_1_by_b_1_z*t583 + D_p_y_1_by_b_1_z*t644
        - D_p_z_1_by_b_1_z*t584 - D_p_z_1_by_b_1_z*t585 - D_p_z_1_by_b_1_z*t586 + D_p_z_1_by_b_1_z*t645
        + mu_1_by_b_1_z*t489 + mu_2_by_b_1_z*t490 + mu_3_by_b_1_z*t491,
        D_delta_x_3_by_b_1_z*t575 + D_delta_y_3_by_b_1_z*t576 + D_delta_z_3_by_b_1_z*t577
        - D_p_x_1_by_b_1_z*t587 - D_p_x_1_by_b_1_z*t588 - D_p_x_1_by_b_1_z*t589 + D_p_x_1_by_b_1_z*t646
        - D_p_y_1_by_b_1_z*t590 - D_p_y_1_by_b_1_z*t591 - D_p_y_1_by_b_1_z*t592 + D_p_y_1_by_b_1_z*t647
        - D_p_z_1_by_b_1_z*t593 - D_p_z_1_by_b_1_z*t594 - D_p_z_1_by_b_1_z*t595 + D_p_z_1_by_b_1_z*t648
        + mu_1_by_b_1_z*t492 + mu_2_by_b_1_z*t493 + mu_3_by_b_1_z*t494,
        t663, D_p_x_1_by_b_1_z*k_C, D_p_y_1_by_b_1_z*k_C, D_p_z_1_by_b_1_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_1_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_z*k_C
        + mu_1_by_b_1_z*t495 + mu_2_by_b_1_z*t496 + mu_3_by_b_1_z*t497 - t541*t664 - t542*t664 - t543*t664
        - t544*t665 - t545*t665 - t546*t665 - t547*t666 - t548*t666 - t549*t666,
        D_p_x_2*D_p_x_3_by_b_1_z*k_C + D_p_x_2_by_b_1_z*D_p_x_3*k_C - D_p_x_2_by_b_1_z*t550
        - D_p_x_2_by_b_1_z*t551 - D_p_x_2_by_b_1_z*t552 - D_p_x_3_by_b_1_z*t541 - D_p_x_3_by_b_1_z*t542
        - D_p_x_3_by_b_1_z*t543 + D_p_y_2*D_p_y_3_by_b_1_z*k_C + D_p_y_2_by_b_1_z*D_p_y_3*k_C
        - D_p_y_2_by_b_1_z*t553 - D_p_y_2_by_b_1_z*t554 - D_p_y_2_by_b_1_z*t555 - D_p_y_3_by_b_1_z*t544
        - D_p_y_3_by_b_1_z*t545 - D_p_y_3_by_b_1_z*t546 + D_p_z_2*D_p_z_3_by_b_1_z*k_C
        + D_p_z_2_by_b_1_z*D_p_z_3*k_C - D_p_z_2_by_b_1_z*t556 - D_p_z_2_by_b_1_z*t557
        - D_p_z_2_by_b_1_z*t558 - D_p_z_3_by_b_1_z*t547 - D_p_z_3_by_b_1_z*t548 - D_p_z_3_by_b_1_z*t549
        + mu_1_by_b_1_z*t498 + mu_2_by_b_1_z*t499 + mu_3_by_b_1_z*t500,
        D_delta_x_1_by_b_1_z*t603 + D_delta_y_1_by_b_1_z*t604 + D_delta_z_1_by_b_1_z*t605
        - D_p_x_2_by_b_1_z*t566 - D_p_x_2_by_b_1_z*t567 - D_p_x_2_by_b_1_z*t568 + D_p_x_2_by_b_1_z*t640
        - D_p_y_2_by_b_1_z*t569 - D_p_y_2_by_b_1_z*t570 - D_p_y_2_by_b_1_z*t571 + D_p_y_2_by_b_1_z*t641
        - D_p_z_2_by_b_1_z*t572 - D_p_z_2_by_b_1_z*t573 - D_p_z_2_by_b_1_z*t574 + D_p_z_2_by_b_1_z*t642
        + mu_1_by_b_1_z*t501 + mu_2_by_b_1_z*t502 + mu_3_by_b_1_z*t503,
        D_delta_x_2_by_b_1_z*t603 + D_delta_y_2_by_b_1_z*t604 + D_delta_z_2_by_b_1_z*t605
        - D_p_x_2_by_b_1_z*t578 - D_p_x_2_by_b_1_z*t579 - D_p_x_2_by_b_1_z*t580 + D_p_x_2_by_b_1_z*t643
        - D_p_y_2_by_b_1_z*t581 - D_p_y_2_by_b_1_z*t582 - D_p_y_2_by_b_1_z*t583 + D_p_y_2_by_b_1_z*t644
        - D_p_z_2_by_b_1_z*t584 - D_p_z_2_by_b_1_z*t585 - D_p_z_2_by_b_1_z*t586 + D_p_z_2_by_b_1_z*t645
        + mu_1_by_b_1_z*t504 + mu_2_by_b_1_z*t505 + mu_3_by_b_1_z*t506,
        D_delta_x_3_by_b_1_z*t603 + D_delta_y_3_by_b_1_z*t604 + D_delta_z_3_by_b_1_z*t605
        - D_p_x_2_by_b_1_z*t587 - D_p_x_2_by_b_1_z*t588 - D_p_x_2_by_b_1_z*t589 + D_p_x_2_by_b_1_z*t646
        - D_p_y_2_by_b_1_z*t590 - D_p_y_2_by_b_1_z*t591 - D_p_y_2_by_b_1_z*t592 + D_p_y_2_by_b_1_z*t647
        - D_p_z_2_by_b_1_z*t593 - D_p_z_2_by_b_1_z*t594 - D_p_z_2_by_b_1_z*t595 + D_p_z_2_by_b_1_z*t648
        + mu_1_by_b_1_z*t507 + mu_2_by_b_1_z*t508 + mu_3_by_b_1_z*t509,
        D_p_x_2_by_b_1_z*k_C, D_p_y_2_by_b_1_z*k_C, D_p_z_2_by_b_1_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_1_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_z*k_C
        + mu_1_by_b_1_z*t510 + mu_2_by_b_1_z*t511 + mu_3_by_b_1_z*t512 - t550*t667 - t551*t667 - t552*t667
        - t553*t668 - t554*t668 - t555*t668 - t556*t669 - t557*t669 - t558*t669,
        D_delta_x_1_by_b_1_z*t612 + D_delta_y_1_by_b_1_z*t613 + D_delta_z_1_by_b_1_z*t614
        - D_p_x_3_by_b_1_z*t566 - D_p_x_3_by_b_1_z*t567 - D_p_x_3_by_b_1_z*t568 + D_p_x_3_by_b_1_z*t640
        - D_p_y_3_by_b_1_z*t569 - D_p_y_3_by_b_1_z*t570 - D_p_y_3_by_b_1_z*t571 + D_p_y_3_by_b_1_z*t641
        - D_p_z_3_by_b_1_z*t572 - D_p_z_3_by_b_1_z*t573 - D_p_z_3_by_b_1_z*t574 + D_p_z_3_by_b_1_z*t642
        + mu_1_by_b_1_z*t513 + mu_2_by_b_1_z*t514 + mu_3_by_b_1_z*t515,
        D_delta_x_2_by_b_1_z*t612 + D_delta_y_2_by_b_1_z*t613 + D_delta_z_2_by_b_1_z*t614
        - D_p_x_3_by_b_1_z*t578 - D_p_x_3_by_b_1_z*t579 - D_p_x_3_by_b_1_z*t580 + D_p_x_3_by_b_1_z*t643
        - D_p_y_3_by_b_1_z*t581 - D_p_y_3_by_b_1_z*t582 - D_p_y_3_by_b_1_z*t583 + D_p_y_3_by_b_1_z*t644
        - D_p_z_3_by_b_1_z*t584 - D_p_z_3_by_b_1_z*t585 - D_p_z_3_by_b_1_z*t586 + D_p_z_3_by_b_1_z*t645
        + mu_1_by_b_1_z*t516 + mu_2_by_b_1_z*t517 + mu_3_by_b_1_z*t518,
        D_delta_x_3_by_b_1_z*t612 + D_delta_y_3_by_b_1_z*t613 + D_delta_z_3_by_b_1_z*t614
        - D_p_x_3_by_b_1_z*t587 - D_p_x_3_by_b_1_z*t588 - D_p_x_3_by_b_1_z*t589 + D_p_x_3_by_b_1_z*t646
        - D_p_y_3_by_b_1_z*t590 - D_p_y_3_by_b_1_z*t591 - D_p_y_3_by_b_1_z*t592 + D_p_y_3_by_b_1_z*t647
        - D_p_z_3_by_b_1_z*t593 - D_p_z_3_by_b_1_z*t594 - D_p_z_3_by_b_1_z*t595 + D_p_z_3_by_b_1_z*t648
        + mu_1_by_b_1_z*t519 + mu_2_by_b_1_z*t520 + mu_3_by_b_1_z*t521,
        D_p_x_3_by_b_1_z*k_C, D_p_y_3_by_b_1_z*k_C, D_p_z_3_by_b_1_z*k_C, t311*t660, t661, -t311*t659, t662,
        D_delta_x_1_by_b_1_z*t615 + D_delta_y_1_by_b_1_z*t616 + D_delta_z_1_by_b_1_z*t617
        + mu_1_by_b_1_z*t522 - mu_2_by_b_1_z*t238 - mu_3_by_b_1_z*t238,
        D_delta_x_1_by_b_1_z*t618 + D_delta_x_2_by_b_1_z*t619 + D_delta_y_1_by_b_1_z*t620
        + D_delta_y_2_by_b_1_z*t621 + D_delta_z_1_by_b_1_z*t622 + D_delta_z_2_by_b_1_z*t623
        - mu_1_by_b_1_z*t242 - mu_2_by_b_1_z*t242 - mu_3_by_b_1_z*t242,
        D_delta_x_1_by_b_1_z*t624 + D_delta_x_3_by_b_1_z*t619 + D_delta_y_1_by_b_1_z*t625
        + D_delta_y_3_by_b_1_z*t621 + D_delta_z_1_by_b_1_z*t626 + D_delta_z_3_by_b_1_z*t623
        - mu_1_by_b_1_z*t246 - mu_2_by_b_1_z*t246 - mu_3_by_b_1_z*t246,
        D_delta_x_1_by_b_1_z*k_C, D_delta_y_1_by_b_1_z*k_C, D_delta_z_1_by_b_1_z*k_C,
        D_delta_x_2_by_b_1_z*t627 + D_delta_y_2_by_b_1_z*t628 + D_delta_z_2_by_b_1_z*t629
        - mu_1_by_b_1_z*t250 + mu_2_by_b_1_z*t523 - mu_3_by_b_1_z*t250,
        D_delta_x_2_by_b_1_z*t624 + D_delta_x_3_by_b_1_z*t618 + D_delta_y_2_by_b_1_z*t625
        + D_delta_y_3_by_b_1_z*t620 + D_delta_z_2_by_b_1_z*t626 + D_delta_z_3_by_b_1_z*t622
        - mu_1_by_b_1_z*t254 - mu_2_by_b_1_z*t254 - mu_3_by_b_1_z*t254,
        D_delta_x_2_by_b_1_z*k_C, D_delta_y_2_by_b_1_z*k_C, D_delta_z_2_by_b_1_z*k_C,
        D_delta_x_3_by_b_1_z*t630 + D_delta_y_3_by_b_1_z*t631 + D_delta_z_3_by_b_1_z*t632
        - mu_1_by_b_1_z*t258 - mu_2_by_b_1_z*t258 + mu_3_by_b_1_z*t524,
        D_delta_x_3_by_b_1_z*k_C, D_delta_y_3_by_b_1_z*k_C, D_delta_z_3_by_b_1_z*k_C, t663,
        2*D_p_x_1*D_p_x_1_by_b_2_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_x*k_C
        + mu_1_by_b_2_x*t477 + mu_2_by_b_2_x*t478 + mu_3_by_b_2_x*t479 - t525*t670 - t527*t670 - t528*t670
        - t529*t671 - t531*t671 - t532*t671 - t533*t672 - t535*t672 - t536*t672,
        D_p_x_1*D_p_x_2_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_2*k_C - D_p_x_1_by_b_2_x*t541
        - D_p_x_1_by_b_2_x*t542 - D_p_x_1_by_b_2_x*t543 - D_p_x_2_by_b_2_x*t525 - D_p_x_2_by_b_2_x*t527
        - D_p_x_2_by_b_2_x*t528 + D_p_y_1*D_p_y_2_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_2*k_C
        - D_p_y_1_by_b_2_x*t544 - D_p_y_1_by_b_2_x*t545 - D_p_y_1_by_b_2_x*t546 - D_p_y_2_by_b_2_x*t529
        - D_p_y_2_by_b_2_x*t531 - D_p_y_2_by_b_2_x*t532 + D_p_z_1*D_p_z_2_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_2*k_C - D_p_z_1_by_b_2_x*t547 - D_p_z_1_by_b_2_x*t548
        - D_p_z_1_by_b_2_x*t549 - D_p_z_2_by_b_2_x*t533 - D_p_z_2_by_b_2_x*t535 - D_p_z_2_by_b_2_x*t536
        + mu_1_by_b_2_x*t480 + mu_2_by_b_2_x*t481 + mu_3_by_b_2_x*t482,
        D_p_x_1*D_p_x_3_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_3*k_C - D_p_x_1_by_b_2_x*t550
        - D_p_x_1_by_b_2_x*t551 - D_p_x_1_by_b_2_x*t552 - D_p_x_3_by_b_2_x*t525 - D_p_x_3_by_b_2_x*t527
        - D_p_x_3_by_b_2_x*t528 + D_p_y_1*D_p_y_3_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_3*k_C
        - D_p_y_1_by_b_2_x*t553 - D_p_y_1_by_b_2_x*t554 - D_p_y_1_by_b_2_x*t555 - D_p_y_3_by_b_2_x*t529
        - D_p_y_3_by_b_2_x*t531 - D_p_y_3_by_b_2_x*t532 + D_p_z_1*D_p_z_3_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_3*k_C - D_p_z_1_by_b_2_x*t556 - D_p_z_1_by_b_2_x*t557
        - D_p_z_1_by_b_2_x*t558 - D_p_z_3_by_b_2_x*t533 - D_p_z_3_by_b_2_x*t535 - D_p_z_3_by_b_2_x*t536
        + mu_1_by_b_2_x*t483 + mu_2_by_b_2_x*t484 + mu_3_by_b_2_x*t485,
        D_delta_x_1_by_b_2_x*t575 + D_delta_y_1_by_b_2_x*t576 + D_delta_z_1_by_b_2_x*t577
        - D_p_x_1_by_b_2_x*t566 - D_p_x_1_by_b_2_x*t567 - D_p_x_1_by_b_2_x*t568 + D_p_x_1_by_b_2_x*t640
        - D_p_y_1_by_b_2_x*t569 - D_p_y_1_by_b_2_x*t570 - D_p_y_1_by_b_2_x*t571 + D_p_y_1_by_b_2_x*t641
        - D_p_z_1_by_b_2_x*t572 - D_p_z_1_by_b_2_x*t573 - D_p_z_1_by_b_2_x*t574 + D_p_z_1_by_b_2_x*t642
        + mu_1_by_b_2_x*t486 + mu_2_by_b_2_x*t487 + mu_3_by_b_2_x*t488,
        D_delta_x_2_by_b_2_x*t575 + D_delta_y_2_by_b_2_x*t576 + D_delta_z_2_by_b_2_x*t577
        - D_p_x_1_by_b_2_x*t578 - D_p_x_1_by_b_2_x*t579 - D_p_x_1_by_b_2_x*t580 + D_p_x_1_by_b_2_x*t643
        - D_p_y_1_by_b_2_x*t581 - D_p_y_1_by_b_2_x*t582 - D_p_y_1_by_b_2_x*t583 + D_p_y_1_by_b_2_x*t644
        - D_p_z_1_by_b_2_x*t584 - D_p_z_1_by_b_2_x*t585 - D_p_z_1_by_b_2_x*t586 + D_p_z_1_by_b_2_x*t645
        + mu_1_by_b_2_x*t489 + mu_2_by_b_2_x*t490 + mu_3_by_b_2_x*t491,
        D_delta_x_3_by_b_2_x*t575 + D_delta_y_3_by_b_2_x*t576 + D_delta_z_3_by_b_2_x*t577
        - D_p_x_1_by_b_2_x*t587 - D_p_x_1_by_b_2_x*t588 - D_p_x_1_by_b_2_x*t589 + D_p_x_1_by_b_2_x*t646
        - D_p_y_1_by_b_2_x*t590 - D_p_y_1_by_b_2_x*t591 - D_p_y_1_by_b_2_x*t592 + D_p_y_1_by_b_2_x*t647
        - D_p_z_1_by_b_2_x*t593 - D_p_z_1_by_b_2_x*t594 - D_p_z_1_by_b_2_x*t595 + D_p_z_1_by_b_2_x*t648
        + mu_1_by_b_2_x*t492 + mu_2_by_b_2_x*t493 + mu_3_by_b_2_x*t494,
        D_p_x_1_by_b_2_x*k_C, D_p_y_1_by_b_2_x*k_C, D_p_z_1_by_b_2_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_x*k_C
        + k_sp_2*t22*t679*w_b_2*x_2_by_b_2_x + mu_1_by_b_2_x*t495 + mu_2_by_b_2_x*t496
        + mu_3_by_b_2_x*t497 - t541*t673 - t542*t673 - t543*t673 - t544*t674 - t545*t674 - t546*t674
        - t547*t675 - t548*t675 - t549*t675 - t678,
        D_p_x_2*D_p_x_3_by_b_2_x*k_C + D_p_x_2_by_b_2_x*D_p_x_3*k_C - D_p_x_2_by_b_2_x*t550
        - D_p_x_2_by_b_2_x*t551 - D_p_x_2_by_b_2_x*t552 - D_p_x_3_by_b_2_x*t541 - D_p_x_3_by_b_2_x*t542
        - D_p_x_3_by_b_2_x*t543 + D_p_y_2*D_p_y_3_by_b_2_x*k_C + D_p_y_2_by_b_2_x*D_p_y_3*k_C
        - D_p_y_2_by_b_2_x*t553 - D_p_y_2_by_b_2_x*t554 - D_p_y_2_by_b_2_x*t555 - D_p_y_3_by_b_2_x*t544
        - D_p_y_3_by_b_2_x*t545 - D_p_y_3_by_b_2_x*t546 + D_p_z_2*D_p_z_3_by_b_2_x*k_C
        + D_p_z_2_by_b_2_x*D_p_z_3*k_C - D_p_z_2_by_b_2_x*t556 - D_p_z_2_by_b_2_x*t557
        - D_p_z_2_by_b_2_x*t558 - D_p_z_3_by_b_2_x*t547 - D_p_z_3_by_b_2_x*t548 - D_p_z_3_by_b_2_x*t549
        + mu_1_by_b_2_x*t498 + mu_2_by_b_2_x*t499 + mu_3_by_b_2_x*t500,
        t682, t683,
        D_delta_x_1_by_b_2_x*t603 + D_delta_y_1_by_b_2_x*t604 + D_delta_z_1_by_b_2_x*t605
        - D_p_x_2_by_b_2_x*t566 - D_p_x_2_by_b_2_x*t567 - D_p_x_2_by_b_2_x*t568 + D_p_x_2_by_b_2_x*t640
        - D_p_y_2_by_b_2_x*t569 - D_p_y_2_by_b_2_x*t570 - D_p_y_2_by_b_2_x*t571 + D_p_y_2_by_b_2_x*t641
        - D_p_z_2_by_b_2_x*t572 - D_p_z_2_by_b_2_x*t573 - D_p_z_2_by_b_2_x*t574 + D_p_z_2_by_b_2_x*t642
        + mu_1_by_b_2_x*t501 + mu_2_by_b_2_x*t502 + mu_3_by_b_2_x*t503,
        D_delta_x_2_by_b_2_x*t603 + D_delta_y_2_by_b_2_x*t604 + D_delta_z_2_by_b_2_x*t605
        - D_p_x_2_by_b_2_x*t578 - D_p_x_2_by_b_2_x*t579 - D_p_x_2_by_b_2_x*t580 + D_p_x_2_by_b_2_x*t643
        - D_p_y_2_by_b_2_x*t581 - D_p_y_2_by_b_2_x*t582 - D_p_y_2_by_b_2_x*t583 + D_p_y_2_by_b_2_x*t644
        - D_p_z_2_by_b_2_x*t584 - D_p_z_2_by_b_2_x*t585 - D_p_z_2_by_b_2_x*t586 + D_p_z_2_by_b_2_x*t645
        + mu_1_by_b_2_x*t504 + mu_2_by_b_2_x*t505 + mu_3_by_b_2_x*t506,
        D_delta_x_3_by_b_2_x*t603 + D_delta_y_3_by_b_2_x*t604 + D_delta_z_3_by_b_2_x*t605
        - D_p_x_2_by_b_2_x*t587 - D_p_x_2_by_b_2_x*t588 - D_p_x_2_by_b_2_x*t589 + D_p_x_2_by_b_2_x*t646
        - D_p_y_2_by_b_2_x*t590 - D_p_y_2_by_b_2_x*t591 - D_p_y_2_by_b_2_x*t592 + D_p_y_2_by_b_2_x*t647
        - D_p_z_2_by_b_2_x*t593 - D_p_z_2_by_b_2_x*t594 - D_p_z_2_by_b_2_x*t595 + D_p_z_2_by_b_2_x*t648
        + mu_1_by_b_2_x*t507 + mu_2_by_b_2_x*t508 + mu_3_by_b_2_x*t509,
        t684, D_p_x_2_by_b_2_x*k_C, D_p_y_2_by_b_2_x*k_C, D_p_z_2_by_b_2_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_x*k_C
        + mu_1_by_b_2_x*t510 + mu_2_by_b_2_x*t511 + mu_3_by_b_2_x*t512 - t550*t685 - t551*t685 - t552*t685
        - t553*t686 - t554*t686 - t555*t686 - t556*t687 - t557*t687 - t558*t687,
        D_delta_x_1_by_b_2_x*t612 + D_delta_y_1_by_b_2_x*t613 + D_delta_z_1_by_b_2_x*t614
        - D_p_x_3_by_b_2_x*t566 - D_p_x_3_by_b_2_x*t567 - D_p_x_3_by_b_2_x*t568 + D_p_x_3_by_b_2_x*t640
        - D_p_y_3_by_b_2_x*t569 - D_p_y_3_by_b_2_x*t570 - D_p_y_3_by_b_2_x*t571 + D_p_y_3_by_b_2_x*t641
        - D_p_z_3_by_b_2_x*t572 - D_p_z_3_by_b_2_x*t573 - D_p_z_3_by_b_2_x*t574 + D_p_z_3_by_b_2_x*t642
        + mu_1_by_b_2_x*t513 + mu_2_by_b_2_x*t514 + mu_3_by_b_2_x*t515,
        D_delta_x_2_by_b_2_x*t612 + D_delta_y_2_by_b_2_x*t613 + D_delta_z_2_by_b_2_x*t614
        - D_p_x_3_by_b_2_x*t578 - D_p_x_3_by_b_2_x*t579 - D_p_x_3_by_b_2_x*t580 + D_p_x_3_by_b_2_x*t643
        - D_p_y_3_by_b_2_x*t581 - D_p_y_3_by_b_2_x*t582 - D_p_y_3_by_b_2_x*t583 + D_p_y_3_by_b_2_x*t644
        - D_p_z_3_by_b_2_x*t584 - D_p_z_3_by_b_2_x*t585 - D_p_z_3_by_b_2_x*t586 + D_p_z_3_by_b_2_x*t645
        + mu_1_by_b_2_x*t516 + mu_2_by_b_2_x*t517 + mu_3_by_b_2_x*t518,
        D_delta_x_3_by_b_2_x*t612 + D_delta_y_3_by_b_2_x*t613 + D_delta_z_3_by_b_2_x*t614
        - D_p_x_3_by_b_2_x*t587 - D_p_x_3_by_b_2_x*t588 - D_p_x_3_by_b_2_x*t589 + D_p_x_3_by_b_2_x*t646
        - D_p_y_3_by_b_2_x*t590 - D_p_y_3_by_b_2_x*t591 - D_p_y_3_by_b_2_x*t592 + D_p_y_3_by_b_2_x*t647
        - D_p_z_3_by_b_2_x*t593 - D_p_z_3_by_b_2_x*t594 - D_p_z_3_by_b_2_x*t595 + D_p_z_3_by_b_2_x*t648
        + mu_1_by_b_2_x*t519 + mu_2_by_b_2_x*t520 + mu_3_by_b_2_x*t521,
        D_p_x_3_by_b_2_x*k_C, D_p_y_3_by_b_2_x*k_C, D_p_z_3_by_b_2_x*k_C, t342*t681, t682, -t342*t678, t683,
        D_delta_x_1_by_b_2_x*t615 + D_delta_y_1_by_b_2_x*t616 + D_delta_z_1_by_b_2_x*t617
        + mu_1_by_b_2_x*t522 - mu_2_by_b_2_x*t238 - mu_3_by_b_2_x*t238,
        D_delta_x_1_by_b_2_x*t618 + D_delta_x_2_by_b_2_x*t619 + D_delta_y_1_by_b_2_x*t620
        + D_delta_y_2_by_b_2_x*t621 + D_delta_z_1_by_b_2_x*t622 + D_delta_z_2_by_b_2_x*t623
        - mu_1_by_b_2_x*t242 - mu_2_by_b_2_x*t242 - mu_3_by_b_2_x*t242,
        D_delta_x_1_by_b_2_x*t624 + D_delta_x_3_by_b_2_x*t619 + D_delta_y_1_by_b_2_x*t625
        + D_delta_y_3_by_b_2_x*t621 + D_delta_z_1_by_b_2_x*t626 + D_delta_z_3_by_b_2_x*t623
        - mu_1_by_b_2_x*t246 - mu_2_by_b_2_x*t246 - mu_3_by_b_2_x*t246,
        D_delta_x_1_by_b_2_x*k_C, D_delta_y_1_by_b_2_x*k_C, D_delta_z_1_by_b_2_x*k_C,
        D_delta_x_2_by_b_2_x*t627 + D_delta_y_2_by_b_2_x*t628 + D_delta_z_2_by_b_2_x*t629
        - mu_1_by_b_2_x*t250 + mu_2_by_b_2_x*t523 - mu_3_by_b_2_x*t250,
        D_delta_x_2_by_b_2_x*t624 + D_delta_x_3_by_b_2_x*t618 + D_delta_y_2_by_b_2_x*t625
        + D_delta_y_3_by_b_2_x*t620 + D_delta_z_2_by_b_2_x*t626 + D_delta_z_3_by_b_2_x*t622
        - mu_1_by_b_2_x*t254 - mu_2_by_b_2_x*t254 - mu_3_by_b_2_x*t254,
        D_delta_x_2_by_b_2_x*k_C, D_delta_y_2_by_b_2_x*k_C, D_delta_z_2_by_b_2_x*k_C,
        D_delta_x_3_by_b_2_x*t630 + D_delta_y_3_by_b_2_x*t631 + D_delta_z_3_by_b_2_x*t632
        - mu_1_by_b_2_x*t258 - mu_2_by_b_2_x*t258 + mu_3_by_b_2_x*t524,
        D_delta_x_3_by_b_2_x*k_C, D_delta_y_3_by_b_2_x*k_C, D_delta_z_3_by_b_2_x*k_C, t684,
        2*D_p_x_1*D_p_x_1_by_b_2_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_y*k_C
        + mu_1_by_b_2_y*t477 + mu_2_by_b_2_y*t478 + mu_3_by_b_2_y*t479 - t525*t688 - t527*t688 - t528*t688
        - t529*t689 - t531*t689 - t532*t689 - t533*t690 - t535*t690 - t536*t690,
        D_p_x_1*D_p_x_2_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_2*k_C - D_p_x_1_by_b_2_y*t541
        - D_p_x_1_by_b_2_y*t542 - D_p_x_1_by_b_2_y*t543 - D_p_x_2_by_b_2_y*t525 - D_p_x_2_by_b_2_y*t527
        - D_p_x_2_by_b_2_y*t528 + D_p_y_1*D_p_y_2_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_2*k_C
        - D_p_y_1_by_b_2_y*t544 - D_p_y_1_by_b_2_y*t545 - D_p_y_1_by_b_2_y*t546 - D_p_y_2_by_b_2_y*t529
        - D_p_y_2_by_b_2_y*t531 - D_p_y_2_by_b_2_y*t532 + D_p_z_1*D_p_z_2_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_2*k_C - D_p_z_1_by_b_2_y*t547 - D_p_z_1_by_b_2_y*t548
        - D_p_z_1_by_b_2_y*t549 - D_p_z_2_by_b_2_y*t533 - D_p_z_2_by_b_2_y*t535 - D_p_z_2_by_b_2_y*t536
        + mu_1_by_b_2_y*t480 + mu_2_by_b_2_y*t481 + mu_3_by_b_2_y*t482,
        D_p_x_1*D_p_x_3_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_3*k_C - D_p_x_1_by_b_2_y*t550
        - D_p_x_1_by_b_2_y*t551 - D_p_x_1_by_b_2_y*t552 - D_p_x_3_by_b_2_y*t525 - D_p_x_3_by_b_2_y*t527
        - D_p_x_3_by_b_2_y*t528 + D_p_y_1*D_p_y_3_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_3*k_C
        - D_p_y_1_by_b_2_y*t553 - D_p_y_1_by_b_2_y*t554 - D_p_y_1_by_b_2_y*t555 - D_p_y_3_by_b_2_y*t529
        - D_p_y_3_by_b_2_y*t531 - D_p_y_3_by_b_2_y*t532 + D_p_z_1*D_p_z_3_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_3*k_C - D_p_z_1_by_b_2_y*t556 - D_p_z_1_by_b_2_y*t557
        - D_p_z_1_by_b_2_y*t558 - D_p_z_3_by_b_2_y*t533 - D_p_z_3_by_b_2_y*t535 - D_p_z_3_by_b_2_y*t536
        + mu_1_by_b_2_y*t483 + mu_2_by_b_2_y*t484 + mu_3_by_b_2_y*t485,
        D_delta_x_1_by_b_2_y*t575 + D_delta_y_1_by_b_2_y*t576 + D_delta_z_1_by_b_2_y*t577
        - D_p_x_1_by_b_2_y*t566 - D_p_x_1_by_b_2_y*t567 - D_p_x_1_by_b_2_y*t568 + D_p_x_1_by_b_2_y*t640
        - D_p_y_1_by_b_2_y*t569 - D_p_y_1_by_b_2_y*t570 - D_p_y_1_by_b_2_y*t571 + D_p_y_1_by_b_2_y*t641
        - D_p_z_1_by_b_2_y*t572 - D_p_z_1_by_b_2_y*t573 - D_p_z_1_by_b_2_y*t574 + D_p_z_1_by_b_2_y*t642
        + mu_1_by_b_2_y*t486 + mu_2_by_b_2_y*t487 + mu_3_by_b_2_y*t488,
        D_delta_x_2_by_b_2_y*t575 + D_delta_y_2_by_b_2_y*t576 + D_delta_z_2_by_b_2_y*t577
        - D_p_x_1_by_b_2_y*t578 - D_p_x_1_by_b_2_y*t579 - D_p_x_1_by_b_2_y*t580 + D_p_x_1_by_b_2_y*t643
        - D_p_y_1_by_b_2_y*t581 - D_p_y_1_by_b_2_y*t582 - D_p_y_1_by_b_2_y*t583 + D_p_y_1_by_b_2_y*t644
        - D_p_z_1_by_b_2_y*t584 - D_p_z_1_by_b_2_y*t585 - D_p_z_1_by_b_2_y*t586 + D_p_z_1_by_b_2_y*t645
        + mu_1_by_b_2_y*t489 + mu_2_by_b_2_y*t490 + mu_3_by_b_2_y*t491,
        D_delta_x_3_by_b_2_y*t575 + D_delta_y_3_by_b_2_y*t576 + D_delta_z_3_by_b_2_y*t577
        - D_p_x_1_by_b_2_y*t587 - D_p_x_1_by_b_2_y*t588 - D_p_x_1_by_b_2_y*t589 + D_p_x_1_by_b_2_y*t646
        - D_p_y_1_by_b_2_y*t590 - D_p_y_1_by_b_2_y*t591 - D_p_y_1_by_b_2_y*t592 + D_p_y_1_by_b_2_y*t647
        - D_p_z_1_by_b_2_y*t593 - D_p_z_1_by_b_2_y*t594 - D_p_z_1_by_b_2_y*t595 + D_p_z_1_by_b_2_y*t648
        + mu_1_by_b_2_y*t492 + mu_2_by_b_2_y*t493 + mu_3_by_b_2_y*t494,
        D_p_x_1_by_b_2_y*k_C, D_p_y_1_by_b_2_y*k_C, D_p_z_1_by_b_2_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_y*k_C
        + k_sp_2*t22*t679*w_b_2*x_2_by_b_2_y + mu_1_by_b_2_y*t495 + mu_2_by_b_2_y*t496
        + mu_3_by_b_2_y*t497 - t541*t691 - t542*t691 - t543*t691 - t544*t692 - t545*t692 - t546*t692
        - t547*t693 - t548*t693 - t549*t693 - t694,
        D_p_x_2*D_p_x_3_by_b_2_y*k_C + D_p_x_2_by_b_2_y*D_p_x_3*k_C - D_p_x_2_by_b_2_y*t550
        - D_p_x_2_by_b_2_y*t551 - D_p_x_2_by_b_2_y*t552 - D_p_x_3_by_b_2_y*t541 - D_p_x_3_by_b_2_y*t542
        - D_p_x_3_by_b_2_y*t543 + D_p_y_2*D_p_y_3_by_b_2_y*k_C + D_p_y_2_by_b_2_y*D_p_y_3*k_C
        - D_p_y_2_by_b_2_y*t553 - D_p_y_2_by_b_2_y*t554 - D_p_y_2_by_b_2_y*t555 - D_p_y_3_by_b_2_y*t544
        - D_p_y_3_by_b_2_y*t545 - D_p_y_3_by_b_2_y*t546 + D_p_z_2*D_p_z_3_by_b_2_y*k_C
        + D_p_z_2_by_b_2_y*D_p_z_3*k_C - D_p_z_2_by_b_2_y*t556 - D_p_z_2_by_b_2_y*t557
        - D_p_z_2_by_b_2_y*t558 - D_p_z_3_by_b_2_y*t547 - D_p_z_3_by_b_2_y*t548 - D_p_z_3_by_b_2_y*t549
        + mu_1_by_b_2_y*t498 + mu_2_by_b_2_y*t499 + mu_3_by_b_2_y*t500,
        t696, t697,
        D_delta_x_1_by_b_2_y*t603 + D_delta_y_1_by_b_2_y*t604 + D_delta_z_1_by_b_2_y*t605
        - D_p_x_2_by_b_2_y*t566 - D_p_x_2_by_b_2_y*t567 - D_p_x_2_by_b_2_y*t568 + D_p_x_2_by_b_2_y*t640
        - D_p_y_2_by_b_2_y*t569 - D_p_y_2_by_b_2_y*t570 - D_p_y_2_by_b_2_y*t571 + D_p_y_2_by_b_2_y*t641
        - D_p_z_2_by_b_2_y*t572 - D_p_z_2_by_b_2_y*t573 - D_p_z_2_by_b_2_y*t574 + D_p_z_2_by_b_2_y*t642
        + mu_1_by_b_2_y*t501 + mu_2_by_b_2_y*t502 + mu_3_by_b_2_y*t503,
        D_delta_x_2_by_b_2_y*t603 + D_delta_y_2_by_b_2_y*t604 + D_delta_z_2_by_b_2_y*t605
        - D_p_x_2_by_b_2_y*t578 - D_p_x_2_by_b_2_y*t579 - D_p_x_2_by_b_2_y*t580 + D_p_x_2_by_b_2_y*t643
        - D_p_y_2_by_b_2_y*t581 - D_p_y_2_by_b_2_y*t582 - D_p_y_2_by_b_2_y*t583 + D_p_y_2_by_b_2_y*t644
        - D_p_z_2_by_b_2_y*t584 - D_p_z_2_by_b_2_y*t585 - D_p_z_2_by_b_2_y*t586 + D_p_z_2_by_b_2_y*t645
        + mu_1_by_b_2_y*t504 + mu_2_by_b_2_y*t505 + mu_3_by_b_2_y*t506,
        D_delta_x_3_by_b_2_y*t603 + D_delta_y_3_by_b_2_y*t604 + D_delta_z_3_by_b_2_y*t605
        - D_p_x_2_by_b_2_y*t587 - D_p_x_2_by_b_2_y*t588 - D_p_x_2_by_b_2_y*t589 + D_p_x_2_by_b_2_y*t646
        - D_p_y_2_by_b_2_y*t590 - D_p_y_2_by_b_2_y*t591 - D_p_y_2_by_b_2_y*t592 + D_p_y_2_by_b_2_y*t647
        - D_p_z_2_by_b_2_y*t593 - D_p_z_2_by_b_2_y*t594 - D_p_z_2_by_b_2_y*t595 + D_p_z_2_by_b_2_y*t648
        + mu_1_by_b_2_y*t507 + mu_2_by_b_2_y*t508 + mu_3_by_b_2_y*t509,
        t698, D_p_x_2_by_b_2_y*k_C, D_p_y_2_by_b_2_y*k_C, D_p_z_2_by_b_2_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_y*k_C
        + mu_1_by_b_2_y*t510 + mu_2_by_b_2_y*t511 + mu_3_by_b_2_y*t512 - t550*t699 - t551*t699 - t552*t699
        - t553*t700 - t554*t700 - t555*t700 - t556*t701 - t557*t701 - t558*t701,
        D_delta_x_1_by_b_2_y*t612 + D_delta_y_1_by_b_2_y*t613 + D_delta_z_1_by_b_2_y*t614
        - D_p_x_3_by_b_2_y*t566 - D_p_x_3_by_b_2_y*t567 - D_p_x_3_by_b_2_y*t568 + D_p_x_3_by_b_2_y*t640
        - D_p_y_3_by_b_2_y*t569 - D_p_y_3_by_b_2_y*t570 - D_p_y_3_by_b_2_y*t571 + D_p_y_3_by_b_2_y*t641
        - D_p_z_3_by_b_2_y*t572 - D_p_z_3_by_b_2_y*t573 - D_p_z_3_by_b_2_y*t574 + D_p_z_3_by_b_2_y*t642
        + mu_1_by_b_2_y*t513 + mu_2_by_b_2_y*t514 + mu_3_by_b_2_y*t515,
        D_delta_x_2_by_b_2_y*t612 + D_delta_y_2_by_b_2_y*t613 + D_delta_z_2_by_b_2_y*t614
        - D_p_x_3_by_b_2_y*t578 - D_p_x_3_by_b_2_y*t579 - D_p_x_3_by_b_2_y*t580 + D_p_x_3_by_b_2_y*t643
        - D_p_y_3_by_b_2_y*t581 - D_p_y_3_by_b_2_y*t582 - D_p_y_3_by_b_2_y*t583 + D_p_y_3_by_b_2_y*t644
        - D_p_z_3_by_b_2_y*t584 - D_p_z_3_by_b_2_y*t585 - D_p_z_3_by_b_2_y*t586 + D_p_z_3_by_b_2_y*t645
        + mu_1_by_b_2_y*t516 + mu_2_by_b_2_y*t517 + mu_3_by_b_2_y*t518,
        D_delta_x_3_by_b_2_y*t612 + D_delta_y_3_by_b_2_y*t613 + D_delta_z_3_by_b_2_y*t614
        - D_p_x_3_by_b_2_y*t587 - D_p_x_3_by_b_2_y*t588 - D_p_x_3_by_b_2_y*t589 + D_p_x_3_by_b_2_y*t646
        - D_p_y_3_by_b_2_y*t590 - D_p_y_3_by_b_2_y*t591 - D_p_y_3_by_b_2_y*t592 + D_p_y_3_by_b_2_y*t647
        - D_p_z_3_by_b_2_y*t593 - D_p_z_3_by_b_2_y*t594 - D_p_z_3_by_b_2_y*t595 + D_p_z_3_by_b_2_y*t648
        + mu_1_by_b_2_y*t519 + mu_2_by_b_2_y*t520 + mu_3_by_b_2_y*t521,
        D_p_x_3_by_b_2_y*k_C, D_p_y_3_by_b_2_y*k_C, D_p_z_3_by_b_2_y*k_C, t342*t695, t696, -t342*t694, t697,
        D_delta_x_1_by_b_2_y*t615 + D_delta_y_1_by_b_2_y*t616 + D_delta_z_1_by_b_2_y*t617
        + mu_1_by_b_2_y*t522 - mu_2_by_b_2_y*t238 - mu_3_by_b_2_y*t238,
        D_delta_x_1_by_b_2_y*t618 + D_delta_x_2_by_b_2_y*t619 + D_delta_y_1_by_b_2_y*t620
        + D_delta_y_2_by_b_2_y*t621 + D_delta_z_1_by_b_2_y*t622 + D_delta_z_2_by_b_2_y*t623
        - mu_1_by_b_2_y*t242 - mu_2_by_b_2_y*t242 - mu_3_by_b_2_y*t242,
        D_delta_x_1_by_b_2_y*t624 + D_delta_x_3_by_b_2_y*t619 + D_delta_y_1_by_b_2_y*t625
        + D_delta_y_3_by_b_2_y*t621 + D_delta_z_1_by_b_2_y*t626 + D_delta_z_3_by_b_2_y*t623
        - mu_1_by_b_2_y*t246 - mu_2_by_b_2_y*t246 - mu_3_by_b_2_y*t246,
        D_delta_x_1_by_b_2_y*k_C, D_delta_y_1_by_b_2_y*k_C, D_delta_z_1_by_b_2_y*k_C,
        D_delta_x_2_by_b_2_y*t627 + D_delta_y_2_by_b_2_y*t628 + D_delta_z_2_by_b_2_y*t629
        - mu_1_by_b_2_y*t250 + mu_2_by_b_2_y*t523 - mu_3_by_b_2_y*t250,
        D_delta_x_2_by_b_2_y*t624 + D_delta_x_3_by_b_2_y*t618 + D_delta_y_2_by_b_2_y*t625
        + D_delta_y_3_by_b_2_y*t620 + D_delta_z_2_by_b_2_y*t626 + D_delta_z_3_by_b_2_y*t622
        - mu_1_by_b_2_y*t254 - mu_2_by_b_2_y*t254 - mu_3_by_b_2_y*t254,
        D_delta_x_2_by_b_2_y*k_C, D_delta_y_2_by_b_2_y*k_C, D_delta_z_2_by_b_2_y*k_C,
        D_delta_x_3_by_b_2_y*t630 + D_delta_y_3_by_b_2_y*t631 + D_delta_z_3_by_b_2_y*t632
        - mu_1_by_b_2_y*t258 - mu_2_by_b_2_y*t258 + mu_3_by_b_2_y*t524,
        D_delta_x_3_by_b_2_y*k_C, D_delta_y_3_by_b_2_y*k_C, D_delta_z_3_by_b_2_y*k_C, t698,
        2*D_p_x_1*D_p_x_1_by_b_2_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_z*k_C
        + mu_1_by_b_2_z*t477 + mu_2_by_b_2_z*t478 + mu_3_by_b_2_z*t479 - t525*t702 - t527*t702 - t528*t702
        - t529*t703 - t531*t703 - t532*t703 - t533*t704 - t535*t704 - t536*t704,
        D_p_x_1*D_p_x_2_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_2*k_C - D_p_x_1_by_b_2_z*t541
        - D_p_x_1_by_b_2_z*t542 - D_p_x_1_by_b_2_z*t543 - D_p_x_2_by_b_2_z*t525 - D_p_x_2_by_b_2_z*t527
        - D_p_x_2_by_b_2_z*t528 + D_p_y_1*D_p_y_2_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_2*k_C
        - D_p_y_1_by_b_2_z*t544 - D_p_y_1_by_b_2_z*t545 - D_p_y_1_by_b_2_z*t546 - D_p_y_2_by_b_2_z*t529
        - D_p_y_2_by_b_2_z*t531 - D_p_y_2_by_b_2_z*t532 + D_p_z_1*D_p_z_2_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_2*k_C - D_p_z_1_by_b_2_z*t547 - D_p_z_1_by_b_2_z*t548
        - D_p_z_1_by_b_2_z*t549 - D_p_z_2_by_b_2_z*t533 - D_p_z_2_by_b_2_z*t535 - D_p_z_2_by_b_2_z*t536
        + mu_1_by_b_2_z*t480 + mu_2_by_b_2_z*t481 + mu_3_by_b_2_z*t482,
        D_p_x_1*D_p_x_3_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_3*k_C - D_p_x_1_by_b_2_z*t550
        - D_p_x_1_by_b_2_z*t551 - D_p_x_1_by_b_2_z*t552 - D_p_x_3_by_b_2_z*t525 - D_p_x_3_by_b_2_z*t527
        - D_p_x_3_by_b_2_z*t528 + D_p_y_1*D_p_y_3_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_3*k_C
        - D_p_y_1_by_b_2_z*t553 - D_p_y_1_by_b_2_z*t554 - D_p_y_1_by_b_2_z*t555 - D_p_y_3_by_b_2_z*t529
        - D_p_y_3_by_b_2_z*t531 - D_p_y_3_by_b_2_z*t532 + D_p_z_1*D_p_z_3_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_3*k_C - D_p_z_1_by_b_2_z*t556 - D_p_z_1_by_b_2_z*t557
        - D_p_z_1_by_b_2_z*t558 - D_p_z_3_by_b_2_z*t533 - D_p_z_3_by_b_2_z*t535 - D_p_z_3_by_b_2_z*t536
        + mu_1_by_b_2_z*t483 + mu_2_by_b_2_z*t484 + mu_3_by_b_2_z*t485,
        D_delta_x_1_by_b_2_z*t575 + D_delta_y_1_by_b_2_z*t576 + D_delta_z_1_by_b_2_z*t577
        - D_p_x_1_by_b_2_z*t566 - D_p_x_1_by_b_2_z*t567 - D_p_x_1_by_b_2_z*t568 + D_p_x_1_by_b_2_z*t640
        - D_p_y_1_by_b_2_z*t569 - D_p_y_1_by_b_2_z*t570 - D_p_y_1_by_b_2_z*t571 + D_p_y_1_by_b_2_z*t641
        - D_p_z_1_by_b_2_z*t572 - D_p_z_1_by_b_2_z*t573 - D_p_z_1_by_b_2_z*t574 + D_p_z_1_by_b_2_z*t642
        + mu_1_by_b_2_z*t486 + mu_2_by_b_2_z*t487 + mu_3_by_b_2_z*t488,
        D_delta_x_2_by_b_2_z*t575 + D_delta_y_2_by_b_2_z*t576 + D_delta_z_2_by_b_2_z*t577
        - D_p_x_1_by_b_2_z*t578 - D_p_x_1_by_b_2_z*t579 - D_p_x_1_by_b_2_z*t580 + D_p_x_1_by_b_2_z*t643
        - D_p_y_1_by_b_2_z*t581 - D_p_y_1_by_b_2_z*t582 - D_p_y_1_by_b_2_z*t583 + D_p_y_1_by_b_2_z*t644
        - D_p_z_1_by_b_2_z*t584 - D_p_z_1_by_b_2_z*t585 - D_p_z_1_by_b_2_z*t586 + D_p_z_1_by_b_2_z*t645
        + mu_1_by_b_2_z*t489 + mu_2_by_b_2_z*t490 + mu_3_by_b_2_z*t491,
        D_delta_x_3_by_b_2_z*t575 + D_delta_y_3_by_b_2_z*t576 + D_delta_z_3_by_b_2_z*t577
        - D_p_x_1_by_b_2_z*t587 - D_p_x_1_by_b_2_z*t588 - D_p_x_1_by_b_2_z*t589 + D_p_x_1_by_b_2_z*t646
        - D_p_y_1_by_b_2_z*t590 - D_p_y_1_by_b_2_z*t591 - D_p_y_1_by_b_2_z*t592 + D_p_y_1_by_b_2_z*t647
        - D_p_z_1_by_b_2_z*t593 - D_p_z_1_by_b_2_z*t594 - D_p_z_1_by_b_2_z*t595 + D_p_z_1_by_b_2_z*t648
        + mu_1_by_b_2_z*t492 + mu_2_by_b_2_z*t493 + mu_3_by_b_2_z*t494,
        D_p_x_1_by_b_2_z*k_C, D_p_y_1_by_b_2_z*k_C, D_p_z_1_by_b_2_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_2_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_z*k_C
        + k_sp_2*t22*t679*w_b_2*x_2_by_b_2_z + mu_1_by_b_2_z*t495 + mu_2_by_b_2_z*t496
        + mu_3_by_b_2_z*t497 - t541*t705 - t542*t705 - t543*t705 - t544*t706 - t545*t706 - t546*t706
        - t547*t707 - t548*t707 - t549*t707 - t708,
        D_p_x_2*D_p_x_3_by_b_2_z*k_C + D_p_x_2_by_b_2_z*D_p_x_3*k_C - D_p_x_2_by_b_2_z*t550
        - D_p_x_2_by_b_2_z*t551 - D_p_x_2_by_b_2_z*t552 - D_p_x_3_by_b_2_z*t541 - D_p_x_3_by_b_2_z*t542
        - D_p_x_3_by_b_2_z*t543 + D_p_y_2*D_p_y_3_by_b_2_z*k_C + D_p_y_2_by_b_2_z*D_p_y_3*k_C
        - D_p_y_2_by_b_2_z*t553 - D_p_y_2_by_b_2_z*t554 - D_p_y_2_by_b_2_z*t555 - D_p_y_3_by_b_2_z*t544
        - D_p_y_3_by_b_2_z*t545 - D_p_y_3_by_b_2_z*t546 + D_p_z_2*D_p_z_3_by_b_2_z*k_C
        + D_p_z_2_by_b_2_z*D_p_z_3*k_C - D_p_z_2_by_b_2_z*t556 - D_p_z_2_by_b_2_z*t557
        - D_p_z_2_by_b_2_z*t558 - D_p_z_3_by_b_2_z*t547 - D_p_z_3_by_b_2_z*t548 - D_p_z_3_by_b_2_z*t549
        + mu_1_by_b_2_z*t498 + mu_2_by_b_2_z*t499 + mu_3_by_b_2_z*t500,
        t710, t711,
        D_delta_x_1_by_b_2_z*t603 + D_delta_y_1_by_b_2_z*t604 + D_delta_z_1_by_b_2_z*t605
        - D_p_x_2_by_b_2_z*t566 - D_p_x_2_by_b_2_z*t567 - D_p_x_2_by_b_2_z*t568 + D_p_x_2_by_b_2_z*t640
        - D_p_y_2_by_b_2_z*t569 - D_p_y_2_by_b_2_z*t570 - D_p_y_2_by_b_2_z*t571 + D_p_y_2_by_b_2_z*t641
        - D_p_z_2_by_b_2_z*t572 - D_p_z_2_by_b_2_z*t573 - D_p_z_2_by_b_2_z*t574 + D_p_z_2_by_b_2_z*t642
        + mu_1_by_b_2_z*t501 + mu_2_by_b_2_z*t502 + mu_3_by_b_2_z*t503,
        D_delta_x_2_by_b_2_z*t603 + D_delta_y_2_by_b_2_z*t604 + D_delta_z_2_by_b_2_z*t605
        - D_p_x_2_by_b_2_z*t578 - D_p_x_2_by_b_2_z*t579 - D_p_x_2_by_b_2_z*t580 + D_p_x_2_by_b_2_z*t643
        - D_p_y_2_by_b_2_z*t581 - D_p_y_2_by_b_2_z*t582 - D_p_y_2_by_b_2_z*t583 + D_p_y_2_by_b_2_z*t644
        - D_p_z_2_by_b_2_z*t584 - D_p_z_2_by_b_2_z*t585 - D_p_z_2_by_b_2_z*t586 + D_p_z_2_by_b_2_z*t645
        + mu_1_by_b_2_z*t504 + mu_2_by_b_2_z*t505 + mu_3_by_b_2_z*t506,
        D_delta_x_3_by_b_2_z*t603 + D_delta_y_3_by_b_2_z*t604 + D_delta_z_3_by_b_2_z*t605
        - D_p_x_2_by_b_2_z*t587 - D_p_x_2_by_b_2_z*t588 - D_p_x_2_by_b_2_z*t589 + D_p_x_2_by_b_2_z*t646
        - D_p_y_2_by_b_2_z*t590 - D_p_y_2_by_b_2_z*t591 - D_p_y_2_by_b_2_z*t592 + D_p_y_2_by_b_2_z*t647
        - D_p_z_2_by_b_2_z*t593 - D_p_z_2_by_b_2_z*t594 - D_p_z_2_by_b_2_z*t595 + D_p_z_2_by_b_2_z*t648
        + mu_1_by_b_2_z*t507 + mu_2_by_b_2_z*t508 + mu_3_by_b_2_z*t509,
        t712, D_p_x_2_by_b_2_z*k_C, D_p_y_2_by_b_2_z*k_C, D_p_z_2_by_b_2_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_2_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_z*k_C
        + mu_1_by_b_2_z*t510 + mu_2_by_b_2_z*t511 + mu_3_by_b_2_z*t512 - t550*t713 - t551*t713 - t552*t713
        - t553*t714 - t554*t714 - t555*t714 - t556*t715 - t557*t715 - t558*t715,
        D_delta_x_1_by_b_2_z*t612 + D_delta_y_1_by_b_2_z*t613 + D_delta_z_1_by_b_2_z*t614
        - D_p_x_3_by_b_2_z*t566 - D_p_x_3_by_b_2_z*t567 - D_p_x_3_by_b_2_z*t568 + D_p_x_3_by_b_2_z*t640
        - D_p_y_3_by_b_2_z*t569 - D_p_y_3_by_b_2_z*t570 - D_p_y_3_by_b_2_z*t571 + D_p_y_3_by_b_2_z*t641
        - D_p_z_3_by_b_2_z*t572 - D_p_z_3_by_b_2_z*t573 - D_p_z_3_by_b_2_z*t574 + D_p_z_3_by_b_2_z*t642
        + mu_1_by_b_2_z*t513 + mu_2_by_b_2_z*t514 + mu_3_by_b_2_z*t515,
        D_delta_x_2_by_b_2_z*t612 + D_delta_y_2_by_b_2_z*t613 + D_delta_z_2_by_b_2_z*t614
        - D_p_x_3_by_b_2_z*t578 - D_p_x_3_by_b_2_z*t579 - D_p_x_3_by_b_2_z*t580 + D_p_x_3_by_b_2_z*t643
        - D_p_y_3_by_b_2_z*t581 - D_p_y_3_by_b_2_z*t582 - D_p_y_3_by_b_2_z*t583 + D_p_y_3_by_b_2_z*t644
        - D_p_z_3_by_b_2_z*t584 - D_p_z_3_by_b_2_z*t585 - D_p_z_3_by_b_2_z*t586 + D_p_z_3_by_b_2_z*t645
        + mu_1_by_b_2_z*t516 + mu_2_by_b_2_z*t517 + mu_3_by_b_2_z*t518,
        D_delta_x_3_by_b_2_z*t612 + D_delta_y_3_by_b_2_z*t613 + D_delta_z_3_by_b_2_z*t614
        - D_p_x_3_by_b_2_z*t587 - D_p_x_3_by_b_2_z*t588 - D_p_x_3_by_b_2_z*t589 + D_p_x_3_by_b_2_z*t646
        - D_p_y_3_by_b_2_z*t590 - D_p_y_3_by_b_2_z*t591 - D_p_y_3_by_b_2_z*t592 + D_p_y_3_by_b_2_z*t647
        - D_p_z_3_by_b_2_z*t593 - D_p_z_3_by_b_2_z*t594 - D_p_z_3_by_b_2_z*t595 + D_p_z_3_by_b_2_z*t648
        + mu_1_by_b_2_z*t519 + mu_2_by_b_2_z*t520 + mu_3_by_b_2_z*t521,
        D_p_x_3_by_b_2_z*k_C, D_p_y_3_by_b_2_z*k_C, D_p_z_3_by_b_2_z*k_C, t342*t709, t710, -t342*t708, t711,
        D_delta_x_1_by_b_2_z*t615 + D_delta_y_1_by_b_2_z*t616 + D_delta_z_1_by_b_2_z*t617
        + mu_1_by_b_2_z*t522 - mu_2_by_b_2_z*t238 - mu_3_by_b_2_z*t238,
        D_delta_x_1_by_b_2_z*t618 + D_delta_x_2_by_b_2_z*t619 + D_delta_y_1_by_b_2_z*t620
        + D_delta_y_2_by_b_2_z*t621 + D_delta_z_1_by_b_2_z*t622 + D_delta_z_2_by_b_2_z*t623
        - mu_1_by_b_2_z*t242 - mu_2_by_b_2_z*t242 - mu_3_by_b_2_z*t242,
        D_delta_x_1_by_b_2_z*t624 + D_delta_x_3_by_b_2_z*t619 + D_delta_y_1_by_b_2_z*t625
        + D_delta_y_3_by_b_2_z*t621 + D_delta_z_1_by_b_2_z*t626 + D_delta_z_3_by_b_2_z*t623
        - mu_1_by_b_2_z*t246 - mu_2_by_b_2_z*t246 - mu_3_by_b_2_z*t246,
        D_delta_x_1_by_b_2_z*k_C, D_delta_y_1_by_b_2_z*k_C, D_delta_z_1_by_b_2_z*k_C,
        D_delta_x_2_by_b_2_z*t627 + D_delta_y_2_by_b_2_z*t628 + D_delta_z_2_by_b_2_z*t629
        - mu_1_by_b_2_z*t250 + mu_2_by_b_2_z*t523 - mu_3_by_b_2_z*t250,
        D_delta_x_2_by_b_2_z*t624 + D_delta_x_3_by_b_2_z*t618 + D_delta_y_2_by_b_2_z*t625
        + D_delta_y_3_by_b_2_z*t620 + D_delta_z_2_by_b_2_z*t626 + D_delta_z_3_by_b_2_z*t622
        - mu_1_by_b_2_z*t254 - mu_2_by_b_2_z*t254 - mu_3_by_b_2_z*t254,
        D_delta_x_2_by_b_2_z*k_C, D_delta_y_2_by_b_2_z*k_C, D_delta_z_2_by_b_2_z*k_C,
        D_delta_x_3_by_b_2_z*t630 + D_delta_y_3_by_b_2_z*t631 + D_delta_z_3_by_b_2_z*t632
        - mu_1_by_b_2_z*t258 - mu_2_by_b_2_z*t258 + mu_3_by_b_2_z*t524,
        D_delta_x_3_by_b_2_z*k_C, D_delta_y_3_by_b_2_z*k_C, D_delta_z_3_by_b_2_z*k_C, t712,
        2*D_p_x_1*D_p_x_1_by_b_3_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_x*k_C
        + mu_1_by_b_3_x*t477 + mu_2_by_b_3_x*t478 + mu_3_by_b_3_x*t479 - t525*t716 - t527*t716 - t528*t716
        - t529*t717 - t531*t717 - t532*t717 - t533*t718 - t535*t718 - t536*t718,
        D_p_x_1*D_p_x_2_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_2*k_C - D_p_x_1_by_b_3_x*t541
        - D_p_x_1_by_b_3_x*t542 - D_p_x_1_by_b_3_x*t543 - D_p_x_2_by_b_3_x*t525 - D_p_x_2_by_b_3_x*t527
        - D_p_x_2_by_b_3_x*t528 + D_p_y_1*D_p_y_2_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_2*k_C
        - D_p_y_1_by_b_3_x*t544 - D_p_y_1_by_b_3_x*t545 - D_p_y_1_by_b_3_x*t546 - D_p_y_2_by_b_3_x*t529
        - D_p_y_2_by_b_3_x*t531 - D_p_y_2_by_b_3_x*t532 + D_p_z_1*D_p_z_2_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_2*k_C - D_p_z_1_by_b_3_x*t547 - D_p_z_1_by_b_3_x*t548
        - D_p_z_1_by_b_3_x*t549 - D_p_z_2_by_b_3_x*t533 - D_p_z_2_by_b_3_x*t535 - D_p_z_2_by_b_3_x*t536
        + mu_1_by_b_3_x*t480 + mu_2_by_b_3_x*t481 + mu_3_by_b_3_x*t482,
        D_p_x_1*D_p_x_3_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_3*k_C - D_p_x_1_by_b_3_x*t550
        - D_p_x_1_by_b_3_x*t551 - D_p_x_1_by_b_3_x*t552 - D_p_x_3_by_b_3_x*t525 - D_p_x_3_by_b_3_x*t527
        - D_p_x_3_by_b_3_x*t528 + D_p_y_1*D_p_y_3_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_3*k_C
        - D_p_y_1_by_b_3_x*t553 - D_p_y_1_by_b_3_x*t554 - D_p_y_1_by_b_3_x*t555 - D_p_y_3_by_b_3_x*t529
        - D_p_y_3_by_b_3_x*t531 - D_p_y_3_by_b_3_x*t532 + D_p_z_1*D_p_z_3_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_3*k_C - D_p_z_1_by_b_3_x*t556 - D_p_z_1_by_b_3_x*t557
        - D_p_z_1_by_b_3_x*t558 - D_p_z_3_by_b_3_x*t533 - D_p_z_3_by_b_3_x*t535 - D_p_z_3_by_b_3_x*t536
        + mu_1_by_b_3_x*t483 + mu_2_by_b_3_x*t484 + mu_3_by_b_3_x*t485,
        D_delta_x_1_by_b_3_x*t575 + D_delta_y_1_by_b_3_x*t576 + D_delta_z_1_by_b_3_x*t577
        - D_p_x_1_by_b_3_x*t566 - D_p_x_1_by_b_3_x*t567 - D_p_x_1_by_b_3_x*t568 + D_p_x_1_by_b_3_x*t640
        - D_p_y_1_by_b_3_x*t569 - D_p_y_1_by_b_3_x*t570 - D_p_y_1_by_b_3_x*t571 + D_p_y_1_by_b_3_x*t641
        - D_p_z_1_by_b_3_x*t572 - D_p_z_1_by_b_3_x*t573 - D_p_z_1_by_b_3_x*t574 + D_p_z_1_by_b_3_x*t642
        + mu_1_by_b_3_x*t486 + mu_2_by_b_3_x*t487 + mu_3_by_b_3_x*t488,
        D_delta_x_2_by_b_3_x*t575 + D_delta_y_2_by_b_3_x*t576 + D_delta_z_2_by_b_3_x*t577
        - D_p_x_1_by_b_3_x*t578 - D_p_x_1_by_b_3_x*t579 - D_p_x_1_by_b_3_x*t580 + D_p_x_1_by_b_3_x*t643
        - D_p_y_1_by_b_3_x*t581 - D_p_y_1_by_b_3_x*t582 - D_p_y_1_by_b_3_x*t583 + D_p_y_1_by_b_3_x*t644
        - D_p_z_1_by_b_3_x*t584 - D_p_z_1_by_b_3_x*t585 - D_p_z_1_by_b_3_x*t586 + D_p_z_1_by_b_3_x*t645
        + mu_1_by_b_3_x*t489 + mu_2_by_b_3_x*t490 + mu_3_by_b_3_x*t491,
        D_delta_x_3_by_b_3_x*t575 + D_delta_y_3_by_b_3_x*t576 + D_delta_z_3_by_b_3_x*t577
        - D_p_x_1_by_b_3_x*t587 - D_p_x_1_by_b_3_x*t588 - D_p_x_1_by_b_3_x*t589 + D_p_x_1_by_b_3_x*t646
        - D_p_y_1_by_b_3_x*t590 - D_p_y_1_by_b_3_x*t591 - D_p_y_1_by_b_3_x*t592 + D_p_y_1_by_b_3_x*t647
        - D_p_z_1_by_b_3_x*t593 - D_p_z_1_by_b_3_x*t594 - D_p_z_1_by_b_3_x*t595 + D_p_z_1_by_b_3_x*t648
        + mu_1_by_b_3_x*t492 + mu_2_by_b_3_x*t493 + mu_3_by_b_3_x*t494,
        D_p_x_1_by_b_3_x*k_C, D_p_y_1_by_b_3_x*k_C, D_p_z_1_by_b_3_x*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_x*k_C
        + mu_1_by_b_3_x*t495 + mu_2_by_b_3_x*t496 + mu_3_by_b_3_x*t497 - t541*t719 - t542*t719 - t543*t719
        - t544*t720 - t545*t720 - t546*t720 - t547*t721 - t548*t721 - t549*t721,
        D_p_x_2*D_p_x_3_by_b_3_x*k_C + D_p_x_2_by_b_3_x*D_p_x_3*k_C - D_p_x_2_by_b_3_x*t550
        - D_p_x_2_by_b_3_x*t551 - D_p_x_2_by_b_3_x*t552 - D_p_x_3_by_b_3_x*t541 - D_p_x_3_by_b_3_x*t542
        - D_p_x_3_by_b_3_x*t543 + D_p_y_2*D_p_y_3_by_b_3_x*k_C + D_p_y_2_by_b_3_x*D_p_y_3*k_C
        - D_p_y_2_by_b_3_x*t553 - D_p_y_2_by_b_3_x*t554 - D_p_y_2_by_b_3_x*t555 - D_p_y_3_by_b_3_x*t544
        - D_p_y_3_by_b_3_x*t545 - D_p_y_3_by_b_3_x*t546 + D_p_z_2*D_p_z_3_by_b_3_x*k_C
        + D_p_z_2_by_b_3_x*D_p_z_3*k_C - D_p_z_2_by_b_3_x*t556 - D_p_z_2_by_b_3_x*t557
        - D_p_z_2_by_b_3_x*t558 - D_p_z_3_by_b_3_x*t547 - D_p_z_3_by_b_3_x*t548 - D_p_z_3_by_b_3_x*t549
        + mu_1_by_b_3_x*t498 + mu_2_by_b_3_x*t499 + mu_3_by_b_3_x*t500,
        D_delta_x_1_by_b_3_x*t603 + D_delta_y_1_by_b_3_x*t604 + D_delta_z_1_by_b_3_x*t605
        - D_p_x_2_by_b_3_x*t566 - D_p_x_2_by_b_3_x*t567 - D_p_x_2_by_b_3_x*t568 + D_p_x_2_by_b_3_x*t640
        - D_p_y_2_by_b_3_x*t569 - D_p_y_2_by_b_3_x*t570 - D_p_y_2_by_b_3_x*t571 + D_p_y_2_by_b_3_x*t641
        - D_p_z_2_by_b_3_x*t572 - D_p_z_2_by_b_3_x*t573 - D_p_z_2_by_b_3_x*t574 + D_p_z_2_by_b_3_x*t642
        + mu_1_by_b_3_x*t501 + mu_2_by_b_3_x*t502 + mu_3_by_b_3_x*t503,
        D_delta_x_2_by_b_3_x*t603 + D_delta_y_2_by_b_3_x*t604 + D_delta_z_2_by_b_3_x*t605
        - D_p_x_2_by_b_3_x*t578 - D_p_x_2_by_b_3_x*t579 - D_p_x_2_by_b_3_x*t580 + D_p_x_2_by_b_3_x*t643
        - D_p_y_2_by_b_3_x*t581 - D_p_y_2_by_b_3_x*t582 - D_p_y_2_by_b_3_x*t583 + D_p_y_2_by_b_3_x*t644
        - D_p_z_2_by_b_3_x*t584 - D_p_z_2_by_b_3_x*t585 - D_p_z_2_by_b_3_x*t586 + D_p_z_2_by_b_3_x*t645
        + mu_1_by_b_3_x*t504 + mu_2_by_b_3_x*t505 + mu_3_by_b_3_x*t506,
        D_delta_x_3_by_b_3_x*t603 + D_delta_y_3_by_b_3_x*t604 + D_delta_z_3_by_b_3_x*t605
        - D_p_x_2_by_b_3_x*t587 - D_p_x_2_by_b_3_x*t588 - D_p_x_2_by_b_3_x*t589 + D_p_x_2_by_b_3_x*t646
        - D_p_y_2_by_b_3_x*t590 - D_p_y_2_by_b_3_x*t591 - D_p_y_2_by_b_3_x*t592 + D_p_y_2_by_b_3_x*t647
        - D_p_z_2_by_b_3_x*t593 - D_p_z_2_by_b_3_x*t594 - D_p_z_2_by_b_3_x*t595 + D_p_z_2_by_b_3_x*t648
        + mu_1_by_b_3_x*t507 + mu_2_by_b_3_x*t508 + mu_3_by_b_3_x*t509,
        D_p_x_2_by_b_3_x*k_C, D_p_y_2_by_b_3_x*k_C, D_p_z_2_by_b_3_x*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_x*k_C
        + k_sp_3*t33*t728*w_b_3*x_3_by_b_3_x + mu_1_by_b_3_x*t510 + mu_2_by_b_3_x*t511
        + mu_3_by_b_3_x*t512 - t550*t722 - t551*t722 - t552*t722 - t553*t723 - t554*t723 - t555*t723
        - t556*t724 - t557*t724 - t558*t724 - t727,
        t731, t732,
        D_delta_x_1_by_b_3_x*t612 + D_delta_y_1_by_b_3_x*t613 + D_delta_z_1_by_b_3_x*t614
        - D_p_x_3_by_b_3_x*t566 - D_p_x_3_by_b_3_x*t567 - D_p_x_3_by_b_3_x*t568 + D_p_x_3_by_b_3_x*t640
        - D_p_y_3_by_b_3_x*t569 - D_p_y_3_by_b_3_x*t570 - D_p_y_3_by_b_3_x*t571 + D_p_y_3_by_b_3_x*t641
        - D_p_z_3_by_b_3_x*t572 - D_p_z_3_by_b_3_x*t573 - D_p_z_3_by_b_3_x*t574 + D_p_z_3_by_b_3_x*t642
        + mu_1_by_b_3_x*t513 + mu_2_by_b_3_x*t514 + mu_3_by_b_3_x*t515,
        D_delta_x_2_by_b_3_x*t612 + D_delta_y_2_by_b_3_x*t613 + D_delta_z_2_by_b_3_x*t614
        - D_p_x_3_by_b_3_x*t578 - D_p_x_3_by_b_3_x*t579 - D_p_x_3_by_b_3_x*t580 + D_p_x_3_by_b_3_x*t643
        - D_p_y_3_by_b_3_x*t581 - D_p_y_3_by_b_3_x*t582 - D_p_y_3_by_b_3_x*t583 + D_p_y_3_by_b_3_x*t644
        - D_p_z_3_by_b_3_x*t584 - D_p_z_3_by_b_3_x*t585 - D_p_z_3_by_b_3_x*t586 + D_p_z_3_by_b_3_x*t645
        + mu_1_by_b_3_x*t516 + mu_2_by_b_3_x*t517 + mu_3_by_b_3_x*t518,
        D_delta_x_3_by_b_3_x*t612 + D_delta_y_3_by_b_3_x*t613 + D_delta_z_3_by_b_3_x*t614
        - D_p_x_3_by_b_3_x*t587 - D_p_x_3_by_b_3_x*t588 - D_p_x_3_by_b_3_x*t589 + D_p_x_3_by_b_3_x*t646
        - D_p_y_3_by_b_3_x*t590 - D_p_y_3_by_b_3_x*t591 - D_p_y_3_by_b_3_x*t592 + D_p_y_3_by_b_3_x*t647
        - D_p_z_3_by_b_3_x*t593 - D_p_z_3_by_b_3_x*t594 - D_p_z_3_by_b_3_x*t595 + D_p_z_3_by_b_3_x*t648
        + mu_1_by_b_3_x*t519 + mu_2_by_b_3_x*t520 + mu_3_by_b_3_x*t521,
        t733, D_p_x_3_by_b_3_x*k_C, D_p_y_3_by_b_3_x*k_C, D_p_z_3_by_b_3_x*k_C, t351*t730, t731, -t351*t727,
        t732,
        D_delta_x_1_by_b_3_x*t615 + D_delta_y_1_by_b_3_x*t616 + D_delta_z_1_by_b_3_x*t617
        + mu_1_by_b_3_x*t522 - mu_2_by_b_3_x*t238 - mu_3_by_b_3_x*t238,
        D_delta_x_1_by_b_3_x*t618 + D_delta_x_2_by_b_3_x*t619 + D_delta_y_1_by_b_3_x*t620
        + D_delta_y_2_by_b_3_x*t621 + D_delta_z_1_by_b_3_x*t622 + D_delta_z_2_by_b_3_x*t623
        - mu_1_by_b_3_x*t242 - mu_2_by_b_3_x*t242 - mu_3_by_b_3_x*t242,
        D_delta_x_1_by_b_3_x*t624 + D_delta_x_3_by_b_3_x*t619 + D_delta_y_1_by_b_3_x*t625
        + D_delta_y_3_by_b_3_x*t621 + D_delta_z_1_by_b_3_x*t626 + D_delta_z_3_by_b_3_x*t623
        - mu_1_by_b_3_x*t246 - mu_2_by_b_3_x*t246 - mu_3_by_b_3_x*t246,
        D_delta_x_1_by_b_3_x*k_C, D_delta_y_1_by_b_3_x*k_C, D_delta_z_1_by_b_3_x*k_C,
        D_delta_x_2_by_b_3_x*t627 + D_delta_y_2_by_b_3_x*t628 + D_delta_z_2_by_b_3_x*t629
        - mu_1_by_b_3_x*t250 + mu_2_by_b_3_x*t523 - mu_3_by_b_3_x*t250,
        D_delta_x_2_by_b_3_x*t624 + D_delta_x_3_by_b_3_x*t618 + D_delta_y_2_by_b_3_x*t625
        + D_delta_y_3_by_b_3_x*t620 + D_delta_z_2_by_b_3_x*t626 + D_delta_z_3_by_b_3_x*t622
        - mu_1_by_b_3_x*t254 - mu_2_by_b_3_x*t254 - mu_3_by_b_3_x*t254,
        D_delta_x_2_by_b_3_x*k_C, D_delta_y_2_by_b_3_x*k_C, D_delta_z_2_by_b_3_x*k_C,
        D_delta_x_3_by_b_3_x*t630 + D_delta_y_3_by_b_3_x*t631 + D_delta_z_3_by_b_3_x*t632
        - mu_1_by_b_3_x*t258 - mu_2_by_b_3_x*t258 + mu_3_by_b_3_x*t524,
        D_delta_x_3_by_b_3_x*k_C, D_delta_y_3_by_b_3_x*k_C, D_delta_z_3_by_b_3_x*k_C, t733,
        2*D_p_x_1*D_p_x_1_by_b_3_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_y*k_C
        + mu_1_by_b_3_y*t477 + mu_2_by_b_3_y*t478 + mu_3_by_b_3_y*t479 - t525*t734 - t527*t734 - t528*t734
        - t529*t735 - t531*t735 - t532*t735 - t533*t736 - t535*t736 - t536*t736,
        D_p_x_1*D_p_x_2_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_2*k_C - D_p_x_1_by_b_3_y*t541
        - D_p_x_1_by_b_3_y*t542 - D_p_x_1_by_b_3_y*t543 - D_p_x_2_by_b_3_y*t525 - D_p_x_2_by_b_3_y*t527
        - D_p_x_2_by_b_3_y*t528 + D_p_y_1*D_p_y_2_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_2*k_C
        - D_p_y_1_by_b_3_y*t544 - D_p_y_1_by_b_3_y*t545 - D_p_y_1_by_b_3_y*t546 - D_p_y_2_by_b_3_y*t529
        - D_p_y_2_by_b_3_y*t531 - D_p_y_2_by_b_3_y*t532 + D_p_z_1*D_p_z_2_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_2*k_C - D_p_z_1_by_b_3_y*t547 - D_p_z_1_by_b_3_y*t548
        - D_p_z_1_by_b_3_y*t549 - D_p_z_2_by_b_3_y*t533 - D_p_z_2_by_b_3_y*t535 - D_p_z_2_by_b_3_y*t536
        + mu_1_by_b_3_y*t480 + mu_2_by_b_3_y*t481 + mu_3_by_b_3_y*t482,
        D_p_x_1*D_p_x_3_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_3*k_C - D_p_x_1_by_b_3_y*t550
        - D_p_x_1_by_b_3_y*t551 - D_p_x_1_by_b_3_y*t552 - D_p_x_3_by_b_3_y*t525 - D_p_x_3_by_b_3_y*t527
        - D_p_x_3_by_b_3_y*t528 + D_p_y_1*D_p_y_3_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_3*k_C
        - D_p_y_1_by_b_3_y*t553 - D_p_y_1_by_b_3_y*t554 - D_p_y_1_by_b_3_y*t555 - D_p_y_3_by_b_3_y*t529
        - D_p_y_3_by_b_3_y*t531 - D_p_y_3_by_b_3_y*t532 + D_p_z_1*D_p_z_3_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_3*k_C - D_p_z_1_by_b_3_y*t556 - D_p_z_1_by_b_3_y*t557
        - D_p_z_1_by_b_3_y*t558 - D_p_z_3_by_b_3_y*t533 - D_p_z_3_by_b_3_y*t535 - D_p_z_3_by_b_3_y*t536
        + mu_1_by_b_3_y*t483 + mu_2_by_b_3_y*t484 + mu_3_by_b_3_y*t485,
        D_delta_x_1_by_b_3_y*t575 + D_delta_y_1_by_b_3_y*t576 + D_delta_z_1_by_b_3_y*t577
        - D_p_x_1_by_b_3_y*t566 - D_p_x_1_by_b_3_y*t567 - D_p_x_1_by_b_3_y*t568 + D_p_x_1_by_b_3_y*t640
        - D_p_y_1_by_b_3_y*t569 - D_p_y_1_by_b_3_y*t570 - D_p_y_1_by_b_3_y*t571 + D_p_y_1_by_b_3_y*t641
        - D_p_z_1_by_b_3_y*t572 - D_p_z_1_by_b_3_y*t573 - D_p_z_1_by_b_3_y*t574 + D_p_z_1_by_b_3_y*t642
        + mu_1_by_b_3_y*t486 + mu_2_by_b_3_y*t487 + mu_3_by_b_3_y*t488,
        D_delta_x_2_by_b_3_y*t575 + D_delta_y_2_by_b_3_y*t576 + D_delta_z_2_by_b_3_y*t577
        - D_p_x_1_by_b_3_y*t578 - D_p_x_1_by_b_3_y*t579 - D_p_x_1_by_b_3_y*t580 + D_p_x_1_by_b_3_y*t643
        - D_p_y_1_by_b_3_y*t581 - D_p_y_1_by_b_3_y*t582 - D_p_y_1_by_b_3_y*t583 + D_p_y_1_by_b_3_y*t644
        - D_p_z_1_by_b_3_y*t584 - D_p_z_1_by_b_3_y*t585 - D_p_z_1_by_b_3_y*t586 + D_p_z_1_by_b_3_y*t645
        + mu_1_by_b_3_y*t489 + mu_2_by_b_3_y*t490 + mu_3_by_b_3_y*t491,
        D_delta_x_3_by_b_3_y*t575 + D_delta_y_3_by_b_3_y*t576 + D_delta_z_3_by_b_3_y*t577
        - D_p_x_1_by_b_3_y*t587 - D_p_x_1_by_b_3_y*t588 - D_p_x_1_by_b_3_y*t589 + D_p_x_1_by_b_3_y*t646
        - D_p_y_1_by_b_3_y*t590 - D_p_y_1_by_b_3_y*t591 - D_p_y_1_by_b_3_y*t592 + D_p_y_1_by_b_3_y*t647
        - D_p_z_1_by_b_3_y*t593 - D_p_z_1_by_b_3_y*t594 - D_p_z_1_by_b_3_y*t595 + D_p_z_1_by_b_3_y*t648
        + mu_1_by_b_3_y*t492 + mu_2_by_b_3_y*t493 + mu_3_by_b_3_y*t494,
        D_p_x_1_by_b_3_y*k_C, D_p_y_1_by_b_3_y*k_C, D_p_z_1_by_b_3_y*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_y*k_C
        + mu_1_by_b_3_y*t495 + mu_2_by_b_3_y*t496 + mu_3_by_b_3_y*t497 - t541*t737 - t542*t737 - t543*t737
        - t544*t738 - t545*t738 - t546*t738 - t547*t739 - t548*t739 - t549*t739,
        D_p_x_2*D_p_x_3_by_b_3_y*k_C + D_p_x_2_by_b_3_y*D_p_x_3*k_C - D_p_x_2_by_b_3_y*t550
        - D_p_x_2_by_b_3_y*t551 - D_p_x_2_by_b_3_y*t552 - D_p_x_3_by_b_3_y*t541 - D_p_x_3_by_b_3_y*t542
        - D_p_x_3_by_b_3_y*t543 + D_p_y_2*D_p_y_3_by_b_3_y*k_C + D_p_y_2_by_b_3_y*D_p_y_3*k_C
        - D_p_y_2_by_b_3_y*t553 - D_p_y_2_by_b_3_y*t554 - D_p_y_2_by_b_3_y*t555 - D_p_y_3_by_b_3_y*t544
        - D_p_y_3_by_b_3_y*t545 - D_p_y_3_by_b_3_y*t546 + D_p_z_2*D_p_z_3_by_b_3_y*k_C
        + D_p_z_2_by_b_3_y*D_p_z_3*k_C - D_p_z_2_by_b_3_y*t556 - D_p_z_2_by_b_3_y*t557
        - D_p_z_2_by_b_3_y*t558 - D_p_z_3_by_b_3_y*t547 - D_p_z_3_by_b_3_y*t548 - D_p_z_3_by_b_3_y*t549
        + mu_1_by_b_3_y*t498 + mu_2_by_b_3_y*t499 + mu_3_by_b_3_y*t500,
        D_delta_x_1_by_b_3_y*t603 + D_delta_y_1_by_b_3_y*t604 + D_delta_z_1_by_b_3_y*t605
        - D_p_x_2_by_b_3_y*t566 - D_p_x_2_by_b_3_y*t567 - D_p_x_2_by_b_3_y*t568 + D_p_x_2_by_b_3_y*t640
        - D_p_y_2_by_b_3_y*t569 - D_p_y_2_by_b_3_y*t570 - D_p_y_2_by_b_3_y*t571 + D_p_y_2_by_b_3_y*t641
        - D_p_z_2_by_b_3_y*t572 - D_p_z_2_by_b_3_y*t573 - D_p_z_2_by_b_3_y*t574 + D_p_z_2_by_b_3_y*t642
        + mu_1_by_b_3_y*t501 + mu_2_by_b_3_y*t502 + mu_3_by_b_3_y*t503,
        D_delta_x_2_by_b_3_y*t603 + D_delta_y_2_by_b_3_y*t604 + D_delta_z_2_by_b_3_y*t605
        - D_p_x_2_by_b_3_y*t578 - D_p_x_2_by_b_3_y*t579 - D_p_x_2_by_b_3_y*t580 + D_p_x_2_by_b_3_y*t643
        - D_p_y_2_by_b_3_y*t581 - D_p_y_2_by_b_3_y*t582 - D_p_y_2_by_b_3_y*t583 + D_p_y_2_by_b_3_y*t644
        - D_p_z_2_by_b_3_y*t584 - D_p_z_2_by_b_3_y*t585 - D_p_z_2_by_b_3_y*t586 + D_p_z_2_by_b_3_y*t645
        + mu_1_by_b_3_y*t504 + mu_2_by_b_3_y*t505 + mu_3_by_b_3_y*t506,
        D_delta_x_3_by_b_3_y*t603 + D_delta_y_3_by_b_3_y*t604 + D_delta_z_3_by_b_3_y*t605
        - D_p_x_2_by_b_3_y*t587 - D_p_x_2_by_b_3_y*t588 - D_p_x_2_by_b_3_y*t589 + D_p_x_2_by_b_3_y*t646
        - D_p_y_2_by_b_3_y*t590 - D_p_y_2_by_b_3_y*t591 - D_p_y_2_by_b_3_y*t592 + D_p_y_2_by_b_3_y*t647
        - D_p_z_2_by_b_3_y*t593 - D_p_z_2_by_b_3_y*t594 - D_p_z_2_by_b_3_y*t595 + D_p_z_2_by_b_3_y*t648
        + mu_1_by_b_3_y*t507 + mu_2_by_b_3_y*t508 + mu_3_by_b_3_y*t509,
        D_p_x_2_by_b_3_y*k_C, D_p_y_2_by_b_3_y*k_C, D_p_z_2_by_b_3_y*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_y*k_C
        + k_sp_3*t33*t728*w_b_3*x_3_by_b_3_y + mu_1_by_b_3_y*t510 + mu_2_by_b_3_y*t511
        + mu_3_by_b_3_y*t512 - t550*t740 - t551*t740 - t552*t740 - t553*t741 - t554*t741 - t555*t741
        - t556*t742 - t557*t742 - t558*t742 - t743,
        t745, t746,
        D_delta_x_1_by_b_3_y*t612 + D_delta_y_1_by_b_3_y*t613 + D_delta_z_1_by_b_3_y*t614
        - D_p_x_3_by_b_3_y*t566 - D_p_x_3_by_b_3_y*t567 - D_p_x_3_by_b_3_y*t568 + D_p_x_3_by_b_3_y*t640
        - D_p_y_3_by_b_3_y*t569 - D_p_y_3_by_b_3_y*t570 - D_p_y_3_by_b_3_y*t571 + D_p_y_3_by_b_3_y*t641
        - D_p_z_3_by_b_3_y*t572 - D_p_z_3_by_b_3_y*t573 - D_p_z_3_by_b_3_y*t574 + D_p_z_3_by_b_3_y*t642
        + mu_1_by_b_3_y*t513 + mu_2_by_b_3_y*t514 + mu_3_by_b_3_y*t515,
        D_delta_x_2_by_b_3_y*t612 + D_delta_y_2_by_b_3_y*t613 + D_delta_z_2_by_b_3_y*t614
        - D_p_x_3_by_b_3_y*t578 - D_p_x_3_by_b_3_y*t579 - D_p_x_3_by_b_3_y*t580 + D_p_x_3_by_b_3_y*t643
        - D_p_y_3_by_b_3_y*t581 - D_p_y_3_by_b_3_y*t582 - D_p_y_3_by_b_3_y*t583 + D_p_y_3_by_b_3_y*t644
        - D_p_z_3_by_b_3_y*t584 - D_p_z_3_by_b_3_y*t585 - D_p_z_3_by_b_3_y*t586 + D_p_z_3_by_b_3_y*t645
        + mu_1_by_b_3_y*t516 + mu_2_by_b_3_y*t517 + mu_3_by_b_3_y*t518,
        D_delta_x_3_by_b_3_y*t612 + D_delta_y_3_by_b_3_y*t613 + D_delta_z_3_by_b_3_y*t614
        - D_p_x_3_by_b_3_y*t587 - D_p_x_3_by_b_3_y*t588 - D_p_x_3_by_b_3_y*t589 + D_p_x_3_by_b_3_y*t646
        - D_p_y_3_by_b_3_y*t590 - D_p_y_3_by_b_3_y*t591 - D_p_y_3_by_b_3_y*t592 + D_p_y_3_by_b_3_y*t647
        - D_p_z_3_by_b_3_y*t593 - D_p_z_3_by_b_3_y*t594 - D_p_z_3_by_b_3_y*t595 + D_p_z_3_by_b_3_y*t648
        + mu_1_by_b_3_y*t519 + mu_2_by_b_3_y*t520 + mu_3_by_b_3_y*t521,
        t747, D_p_x_3_by_b_3_y*k_C, D_p_y_3_by_b_3_y*k_C, D_p_z_3_by_b_3_y*k_C, t351*t744, t745, -t351*t743,
        t746,
        D_delta_x_1_by_b_3_y*t615 + D_delta_y_1_by_b_3_y*t616 + D_delta_z_1_by_b_3_y*t617
        + mu_1_by_b_3_y*t522 - mu_2_by_b_3_y*t238 - mu_3_by_b_3_y*t238,
        D_delta_x_1_by_b_3_y*t618 + D_delta_x_2_by_b_3_y*t619 + D_delta_y_1_by_b_3_y*t620
        + D_delta_y_2_by_b_3_y*t621 + D_delta_z_1_by_b_3_y*t622 + D_delta_z_2_by_b_3_y*t623
        - mu_1_by_b_3_y*t242 - mu_2_by_b_3_y*t242 - mu_3_by_b_3_y*t242,
        D_delta_x_1_by_b_3_y*t624 + D_delta_x_3_by_b_3_y*t619 + D_delta_y_1_by_b_3_y*t625
        + D_delta_y_3_by_b_3_y*t621 + D_delta_z_1_by_b_3_y*t626 + D_delta_z_3_by_b_3_y*t623
        - mu_1_by_b_3_y*t246 - mu_2_by_b_3_y*t246 - mu_3_by_b_3_y*t246,
        D_delta_x_1_by_b_3_y*k_C, D_delta_y_1_by_b_3_y*k_C, D_delta_z_1_by_b_3_y*k_C,
        D_delta_x_2_by_b_3_y*t627 + D_delta_y_2_by_b_3_y*t628 + D_delta_z_2_by_b_3_y*t629
        - mu_1_by_b_3_y*t250 + mu_2_by_b_3_y*t523 - mu_3_by_b_3_y*t250,
        D_delta_x_2_by_b_3_y*t624 + D_delta_x_3_by_b_3_y*t618 + D_delta_y_2_by_b_3_y*t625
        + D_delta_y_3_by_b_3_y*t620 + D_delta_z_2_by_b_3_y*t626 + D_delta_z_3_by_b_3_y*t622
        - mu_1_by_b_3_y*t254 - mu_2_by_b_3_y*t254 - mu_3_by_b_3_y*t254,
        D_delta_x_2_by_b_3_y*k_C, D_delta_y_2_by_b_3_y*k_C, D_delta_z_2_by_b_3_y*k_C,
        D_delta_x_3_by_b_3_y*t630 + D_delta_y_3_by_b_3_y*t631 + D_delta_z_3_by_b_3_y*t632
        - mu_1_by_b_3_y*t258 - mu_2_by_b_3_y*t258 + mu_3_by_b_3_y*t524,
        D_delta_x_3_by_b_3_y*k_C, D_delta_y_3_by_b_3_y*k_C, D_delta_z_3_by_b_3_y*k_C, t747,
        2*D_p_x_1*D_p_x_1_by_b_3_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_z*k_C
        + mu_1_by_b_3_z*t477 + mu_2_by_b_3_z*t478 + mu_3_by_b_3_z*t479 - t525*t748 - t527*t748 - t528*t748
        - t529*t749 - t531*t749 - t532*t749 - t533*t750 - t535*t750 - t536*t750,
        D_p_x_1*D_p_x_2_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_2*k_C - D_p_x_1_by_b_3_z*t541
        - D_p_x_1_by_b_3_z*t542 - D_p_x_1_by_b_3_z*t543 - D_p_x_2_by_b_3_z*t525 - D_p_x_2_by_b_3_z*t527
        - D_p_x_2_by_b_3_z*t528 + D_p_y_1*D_p_y_2_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_2*k_C
        - D_p_y_1_by_b_3_z*t544 - D_p_y_1_by_b_3_z*t545 - D_p_y_1_by_b_3_z*t546 - D_p_y_2_by_b_3_z*t529
        - D_p_y_2_by_b_3_z*t531 - D_p_y_2_by_b_3_z*t532 + D_p_z_1*D_p_z_2_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_2*k_C - D_p_z_1_by_b_3_z*t547 - D_p_z_1_by_b_3_z*t548
        - D_p_z_1_by_b_3_z*t549 - D_p_z_2_by_b_3_z*t533 - D_p_z_2_by_b_3_z*t535 - D_p_z_2_by_b_3_z*t536
        + mu_1_by_b_3_z*t480 + mu_2_by_b_3_z*t481 + mu_3_by_b_3_z*t482,
        D_p_x_1*D_p_x_3_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_3*k_C - D_p_x_1_by_b_3_z*t550
        - D_p_x_1_by_b_3_z*t551 - D_p_x_1_by_b_3_z*t552 - D_p_x_3_by_b_3_z*t525 - D_p_x_3_by_b_3_z*t527
        - D_p_x_3_by_b_3_z*t528 + D_p_y_1*D_p_y_3_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_3*k_C
        - D_p_y_1_by_b_3_z*t553 - D_p_y_1_by_b_3_z*t554 - D_p_y_1_by_b_3_z*t555 - D_p_y_3_by_b_3_z*t529
        - D_p_y_3_by_b_3_z*t531 - D_p_y_3_by_b_3_z*t532 + D_p_z_1*D_p_z_3_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_3*k_C - D_p_z_1_by_b_3_z*t556 - D_p_z_1_by_b_3_z*t557
        - D_p_z_1_by_b_3_z*t558 - D_p_z_3_by_b_3_z*t533 - D_p_z_3_by_b_3_z*t535 - D_p_z_3_by_b_3_z*t536
        + mu_1_by_b_3_z*t483 + mu_2_by_b_3_z*t484 + mu_3_by_b_3_z*t485,
        D_delta_x_1_by_b_3_z*t575 + D_delta_y_1_by_b_3_z*t576 + D_delta_z_1_by_b_3_z*t577
        - D_p_x_1_by_b_3_z*t566 - D_p_x_1_by_b_3_z*t567 - D_p_x_1_by_b_3_z*t568 + D_p_x_1_by_b_3_z*t640
        - D_p_y_1_by_b_3_z*t569 - D_p_y_1_by_b_3_z*t570 - D_p_y_1_by_b_3_z*t571 + D_p_y_1_by_b_3_z*t641
        - D_p_z_1_by_b_3_z*t572 - D_p_z_1_by_b_3_z*t573 - D_p_z_1_by_b_3_z*t574 + D_p_z_1_by_b_3_z*t642
        + mu_1_by_b_3_z*t486 + mu_2_by_b_3_z*t487 + mu_3_by_b_3_z*t488,
        D_delta_x_2_by_b_3_z*t575 + D_delta_y_2_by_b_3_z*t576 + D_delta_z_2_by_b_3_z*t577
        - D_p_x_1_by_b_3_z*t578 - D_p_x_1_by_b_3_z*t579 - D_p_x_1_by_b_3_z*t580 + D_p_x_1_by_b_3_z*t643
        - D_p_y_1_by_b_3_z*t581 - D_p_y_1_by_b_3_z*t582 - D_p_y_1_by_b_3_z*t583 + D_p_y_1_by_b_3_z*t644
        - D_p_z_1_by_b_3_z*t584 - D_p_z_1_by_b_3_z*t585 - D_p_z_1_by_b_3_z*t586 + D_p_z_1_by_b_3_z*t645
        + mu_1_by_b_3_z*t489 + mu_2_by_b_3_z*t490 + mu_3_by_b_3_z*t491,
        D_delta_x_3_by_b_3_z*t575 + D_delta_y_3_by_b_3_z*t576 + D_delta_z_3_by_b_3_z*t577
        - D_p_x_1_by_b_3_z*t587 - D_p_x_1_by_b_3_z*t588 - D_p_x_1_by_b_3_z*t589 + D_p_x_1_by_b_3_z*t646
        - D_p_y_1_by_b_3_z*t590 - D_p_y_1_by_b_3_z*t591 - D_p_y_1_by_b_3_z*t592 + D_p_y_1_by_b_3_z*t647
        - D_p_z_1_by_b_3_z*t593 - D_p_z_1_by_b_3_z*t594 - D_p_z_1_by_b_3_z*t595 + D_p_z_1_by_b_3_z*t648
        + mu_1_by_b_3_z*t492 + mu_2_by_b_3_z*t493 + mu_3_by_b_3_z*t494,
        D_p_x_1_by_b_3_z*k_C, D_p_y_1_by_b_3_z*k_C, D_p_z_1_by_b_3_z*k_C,
        2*D_p_x_2*D_p_x_2_by_b_3_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_z*k_C
        + mu_1_by_b_3_z*t495 + mu_2_by_b_3_z*t496 + mu_3_by_b_3_z*t497 - t541*t751 - t542*t751 - t543*t751
        - t544*t752 - t545*t752 - t546*t752 - t547*t753 - t548*t753 - t549*t753,
        D_p_x_2*D_p_x_3_by_b_3_z*k_C + D_p_x_2_by_b_3_z*D_p_x_3*k_C - D_p_x_2_by_b_3_z*t550
        - D_p_x_2_by_b_3_z*t551 - D_p_x_2_by_b_3_z*t552 - D_p_x_3_by_b_3_z*t541 - D_p_x_3_by_b_3_z*t542
        - D_p_x_3_by_b_3_z*t543 + D_p_y_2*D_p_y_3_by_b_3_z*k_C + D_p_y_2_by_b_3_z*D_p_y_3*k_C
        - D_p_y_2_by_b_3_z*t553 - D_p_y_2_by_b_3_z*t554 - D_p_y_2_by_b_3_z*t555 - D_p_y_3_by_b_3_z*t544
        - D_p_y_3_by_b_3_z*t545 - D_p_y_3_by_b_3_z*t546 + D_p_z_2*D_p_z_3_by_b_3_z*k_C
        + D_p_z_2_by_b_3_z*D_p_z_3*k_C - D_p_z_2_by_b_3_z*t556 - D_p_z_2_by_b_3_z*t557
        - D_p_z_2_by_b_3_z*t558 - D_p_z_3_by_b_3_z*t547 - D_p_z_3_by_b_3_z*t548 - D_p_z_3_by_b_3_z*t549
        + mu_1_by_b_3_z*t498 + mu_2_by_b_3_z*t499 + mu_3_by_b_3_z*t500,
        D_delta_x_1_by_b_3_z*t603 + D_delta_y_1_by_b_3_z*t604 + D_delta_z_1_by_b_3_z*t605
        - D_p_x_2_by_b_3_z*t566 - D_p_x_2_by_b_3_z*t567 - D_p_x_2_by_b_3_z*t568 + D_p_x_2_by_b_3_z*t640
        - D_p_y_2_by_b_3_z*t569 - D_p_y_2_by_b_3_z*t570 - D_p_y_2_by_b_3_z*t571 + D_p_y_2_by_b_3_z*t641
        - D_p_z_2_by_b_3_z*t572 - D_p_z_2_by_b_3_z*t573 - D_p_z_2_by_b_3_z*t574 + D_p_z_2_by_b_3_z*t642
        + mu_1_by_b_3_z*t501 + mu_2_by_b_3_z*t502 + mu_3_by_b_3_z*t503,
        D_delta_x_2_by_b_3_z*t603 + D_delta_y_2_by_b_3_z*t604 + D_delta_z_2_by_b_3_z*t605
        - D_p_x_2_by_b_3_z*t578 - D_p_x_2_by_b_3_z*t579 - D_p_x_2_by_b_3_z*t580 + D_p_x_2_by_b_3_z*t643
        - D_p_y_2_by_b_3_z*t581 - D_p_y_2_by_b_3_z*t582 - D_p_y_2_by_b_3_z*t583 + D_p_y_2_by_b_3_z*t644
        - D_p_z_2_by_b_3_z*t584 - D_p_z_2_by_b_3_z*t585 - D_p_z_2_by_b_3_z*t586 + D_p_z_2_by_b_3_z*t645
        + mu_1_by_b_3_z*t504 + mu_2_by_b_3_z*t505 + mu_3_by_b_3_z*t506,
        D_delta_x_3_by_b_3_z*t603 + D_delta_y_3_by_b_3_z*t604 + D_delta_z_3_by_b_3_z*t605
        - D_p_x_2_by_b_3_z*t587 - D_p_x_2_by_b_3_z*t588 - D_p_x_2_by_b_3_z*t589 + D_p_x_2_by_b_3_z*t646
        - D_p_y_2_by_b_3_z*t590 - D_p_y_2_by_b_3_z*t591 - D_p_y_2_by_b_3_z*t592 + D_p_y_2_by_b_3_z*t647
        - D_p_z_2_by_b_3_z*t593 - D_p_z_2_by_b_3_z*t594 - D_p_z_2_by_b_3_z*t595 + D_p_z_2_by_b_3_z*t648
        + mu_1_by_b_3_z*t507 + mu_2_by_b_3_z*t508 + mu_3_by_b_3_z*t509,
        D_p_x_2_by_b_3_z*k_C, D_p_y_2_by_b_3_z*k_C, D_p_z_2_by_b_3_z*k_C,
        2*D_p_x_3*D_p_x_3_by_b_3_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_z*k_C
        + k_sp_3*t33*t728*w_b_3*x_3_by_b_3_z + mu_1_by_b_3_z*t510 + mu_2_by_b_3_z*t511
        + mu_3_by_b_3_z*t512 - t550*t754 - t551*t754 - t552*t754 - t553*t755 - t554*t755 - t555*t755
        - t556*t756 - t557*t756 - t558*t756 - t757,
        t759, t760,
        D_delta_x_1_by_b_3_z*t612 + D_delta_y_1_by_b_3_z*t613 + D_delta_z_1_by_b_3_z*t614
        - D_p_x_3_by_b_3_z*t566 - D_p_x_3_by_b_3_z*t567 - D_p_x_3_by_b_3_z*t568 + D_p_x_3_by_b_3_z*t640
        - D_p_y_3_by_b_3_z*t569 - D_p_y_3_by_b_3_z*t570 - D_p_y_3_by_b_3_z*t571 + D_p_y_3_by_b_3_z*t641
        - D_p_z_3_by_b_3_z*t572 - D_p_z_3_by_b_3_z*t573 - D_p_z_3_by_b_3_z*t574 + D_p_z_3_by_b_3_z*t642
        + mu_1_by_b_3_z*t513 + mu_2_by_b_3_z*t514 + mu_3_by_b_3_z*t515,
        D_delta_x_2_by_b_3_z*t612 + D_delta_y_2_by_b_3_z*t613 + D_delta_z_2_by_b_3_z*t614
        - D_p_x_3_by_b_3_z*t578 - D_p_x_3_by_b_3_z*t579 - D_p_x_3_by_b_3_z*t580 + D_p_x_3_by_b_3_z*t643
        - D_p_y_3_by_b_3_z*t581 - D_p_y_3_by_b_3_z*t582 - D_p_y_3_by_b_3_z*t583 + D_p_y_3_by_b_3_z*t644
        - D_p_z_3_by_b_3_z*t584 - D_p_z_3_by_b_3_z*t585 - D_p_z_3_by_b_3_z*t586 + D_p_z_3_by_b_3_z*t645
        + mu_1_by_b_3_z*t516 + mu_2_by_b_3_z*t517 + mu_3_by_b_3_z*t518,
        D_delta_x_3_by_b_3_z*t612 + D_delta_y_3_by_b_3_z*t613 + D_delta_z_3_by_b_3_z*t614
        - D_p_x_3_by_b_3_z*t587 - D_p_x_3_by_b_3_z*t588 - D_p_x_3_by_b_3_z*t589 + D_p_x_3_by_b_3_z*t646
        - D_p_y_3_by_b_3_z*t590 - D_p_y_3_by_b_3_z*t591 - D_p_y_3_by_b_3_z*t592 + D_p_y_3_by_b_3_z*t647
        - D_p_z_3_by_b_3_z*t593 - D_p_z_3_by_b_3_z*t594 - D_p_z_3_by_b_3_z*t595 + D_p_z_3_by_b_3_z*t648
        + mu_1_by_b_3_z*t519 + mu_2_by_b_3_z*t520 + mu_3_by_b_3_z*t521,
        t761, D_p_x_3_by_b_3_z*k_C, D_p_y_3_by_b_3_z*k_C, D_p_z_3_by_b_3_z*k_C, t351*t758, t759, -t351*t757,
        t760,
        D_delta_x_1_by_b_3_z*t615 + D_delta_y_1_by_b_3_z*t616 + D_delta_z_1_by_b_3_z*t617
        + mu_1_by_b_3_z*t522 - mu_2_by_b_3_z*t238 - mu_3_by_b_3_z*t238,
        D_delta_x_1_by_b_3_z*t618 + D_delta_x_2_by_b_3_z*t619 + D_delta_y_1_by_b_3_z*t620
        + D_delta_y_2_by_b_3_z*t621 + D_delta_z_1_by_b_3_z*t622 + D_delta_z_2_by_b_3_z*t623
        - mu_1_by_b_3_z*t242 - mu_2_by_b_3_z*t242 - mu_3_by_b_3_z*t242,
        D_delta_x_1_by_b_3_z*t624 + D_delta_x_3_by_b_3_z*t619 + D_delta_y_1_by_b_3_z*t625
        + D_delta_y_3_by_b_3_z*t621 + D_delta_z_1_by_b_3_z*t626 + D_delta_z_3_by_b_3_z*t623
        - mu_1_by_b_3_z*t246 - mu_2_by_b_3_z*t246 - mu_3_by_b_3_z*t246,
        D_delta_x_1_by_b_3_z*k_C, D_delta_y_1_by_b_3_z*k_C, D_delta_z_1_by_b_3_z*k_C,
        D_delta_x_2_by_b_3_z*t627 + D_delta_y_2_by_b_3_z*t628 + D_delta_z_2_by_b_3_z*t629
        - mu_1_by_b_3_z*t250 + mu_2_by_b_3_z*t523 - mu_3_by_b_3_z*t250,
        D_delta_x_2_by_b_3_z*t624 + D_delta_x_3_by_b_3_z*t618 + D_delta_y_2_by_b_3_z*t625
        + D_delta_y_3_by_b_3_z*t620 + D_delta_z_2_by_b_3_z*t626 + D_delta_z_3_by_b_3_z*t622
        - mu_1_by_b_3_z*t254 - mu_2_by_b_3_z*t254 - mu_3_by_b_3_z*t254,
        D_delta_x_2_by_b_3_z*k_C, D_delta_y_2_by_b_3_z*k_C, D_delta_z_2_by_b_3_z*k_C,
        D_delta_x_3_by_b_3_z*t630 + D_delta_y_3_by_b_3_z*t631 + D_delta_z_3_by_b_3_z*t632
        - mu_1_by_b_3_z*t258 - mu_2_by_b_3_z*t258 + mu_3_by_b_3_z*t524,
        D_delta_x_3_by_b_3_z*k_C, D_delta_y_3_by_b_3_z*k_C, D_delta_z_3_by_b_3_z*k_C, t761,
        2*D_p_x_1*D_p_x_1_by_l_d_1*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_1*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_1*k_C
        + k_sp_1*t11*t540*w_b_1*x_1_by_l_d_1 + mu_1_by_l_d_1*t477 + mu_2_by_l_d_1*t478
        + mu_3_by_l_d_1*t479 - t525*t762 - t527*t762 - t528*t762 - t529*t763 - t531*t763 - t532*t763
        - t533*t764 - t535*t764 - t536*t764 - t765,
        D_p_x_1*D_p_x_2_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_2*k_C - D_p_x_1_by_l_d_1*t541
        - D_p_x_1_by_l_d_1*t542 - D_p_x_1_by_l_d_1*t543 - D_p_x_2_by_l_d_1*t525 - D_p_x_2_by_l_d_1*t527
        - D_p_x_2_by_l_d_1*t528 + D_p_y_1*D_p_y_2_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_2*k_C
        - D_p_y_1_by_l_d_1*t544 - D_p_y_1_by_l_d_1*t545 - D_p_y_1_by_l_d_1*t546 - D_p_y_2_by_l_d_1*t529
        - D_p_y_2_by_l_d_1*t531 - D_p_y_2_by_l_d_1*t532 + D_p_z_1*D_p_z_2_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_2*k_C - D_p_z_1_by_l_d_1*t547 - D_p_z_1_by_l_d_1*t548
        - D_p_z_1_by_l_d_1*t549 - D_p_z_2_by_l_d_1*t533 - D_p_z_2_by_l_d_1*t535 - D_p_z_2_by_l_d_1*t536
        + mu_1_by_l_d_1*t480 + mu_2_by_l_d_1*t481 + mu_3_by_l_d_1*t482,
        D_p_x_1*D_p_x_3_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_3*k_C - D_p_x_1_by_l_d_1*t550
        - D_p_x_1_by_l_d_1*t551 - D_p_x_1_by_l_d_1*t552 - D_p_x_3_by_l_d_1*t525 - D_p_x_3_by_l_d_1*t527
        - D_p_x_3_by_l_d_1*t528 + D_p_y_1*D_p_y_3_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_3*k_C
        - D_p_y_1_by_l_d_1*t553 - D_p_y_1_by_l_d_1*t554 - D_p_y_1_by_l_d_1*t555 - D_p_y_3_by_l_d_1*t529
        - D_p_y_3_by_l_d_1*t531 - D_p_y_3_by_l_d_1*t532 + D_p_z_1*D_p_z_3_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_3*k_C - D_p_z_1_by_l_d_1*t556 - D_p_z_1_by_l_d_1*t557
        - D_p_z_1_by_l_d_1*t558 - D_p_z_3_by_l_d_1*t533 - D_p_z_3_by_l_d_1*t535 - D_p_z_3_by_l_d_1*t536
        + mu_1_by_l_d_1*t483 + mu_2_by_l_d_1*t484 + mu_3_by_l_d_1*t485,
        t767, t768,
        D_delta_x_1_by_l_d_1*t575 + D_delta_y_1_by_l_d_1*t576 + D_delta_z_1_by_l_d_1*t577
        - D_p_x_1_by_l_d_1*t566 - D_p_x_1_by_l_d_1*t567 - D_p_x_1_by_l_d_1*t568 + D_p_x_1_by_l_d_1*t640
        - D_p_y_1_by_l_d_1*t569 - D_p_y_1_by_l_d_1*t570 - D_p_y_1_by_l_d_1*t571 + D_p_y_1_by_l_d_1*t641
        - D_p_z_1_by_l_d_1*t572 - D_p_z_1_by_l_d_1*t573 - D_p_z_1_by_l_d_1*t574 + D_p_z_1_by_l_d_1*t642
        + mu_1_by_l_d_1*t486 + mu_2_by_l_d_1*t487 + mu_3_by_l_d_1*t488,
        D_delta_x_2_by_l_d_1*t575 + D_delta_y_2_by_l_d_1*t576 + D_delta_z_2_by_l_d_1*t577
        - D_p_x_1_by_l_d_1*t578 - D_p_x_1_by_l_d_1*t579 - D_p_x_1_by_l_d_1*t580 + D_p_x_1_by_l_d_1*t643
        - D_p_y_1_by_l_d_1*t581 - D_p_y_1_by_l_d_1*t582 - D_p_y_1_by_l_d_1*t583 + D_p_y_1_by_l_d_1*t644
        - D_p_z_1_by_l_d_1*t584 - D_p_z_1_by_l_d_1*t585 - D_p_z_1_by_l_d_1*t586 + D_p_z_1_by_l_d_1*t645
        + mu_1_by_l_d_1*t489 + mu_2_by_l_d_1*t490 + mu_3_by_l_d_1*t491,
        D_delta_x_3_by_l_d_1*t575 + D_delta_y_3_by_l_d_1*t576 + D_delta_z_3_by_l_d_1*t577
        - D_p_x_1_by_l_d_1*t587 - D_p_x_1_by_l_d_1*t588 - D_p_x_1_by_l_d_1*t589 + D_p_x_1_by_l_d_1*t646
        - D_p_y_1_by_l_d_1*t590 - D_p_y_1_by_l_d_1*t591 - D_p_y_1_by_l_d_1*t592 + D_p_y_1_by_l_d_1*t647
        - D_p_z_1_by_l_d_1*t593 - D_p_z_1_by_l_d_1*t594 - D_p_z_1_by_l_d_1*t595 + D_p_z_1_by_l_d_1*t648
        + mu_1_by_l_d_1*t492 + mu_2_by_l_d_1*t493 + mu_3_by_l_d_1*t494,
        t769, D_p_x_1_by_l_d_1*k_C, D_p_y_1_by_l_d_1*k_C, D_p_z_1_by_l_d_1*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_1*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_1*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_1*k_C
        + mu_1_by_l_d_1*t495 + mu_2_by_l_d_1*t496 + mu_3_by_l_d_1*t497 - t541*t770 - t542*t770 - t543*t770
        - t544*t771 - t545*t771 - t546*t771 - t547*t772 - t548*t772 - t549*t772,
        D_p_x_2*D_p_x_3_by_l_d_1*k_C + D_p_x_2_by_l_d_1*D_p_x_3*k_C - D_p_x_2_by_l_d_1*t550
        - D_p_x_2_by_l_d_1*t551 - D_p_x_2_by_l_d_1*t552 - D_p_x_3_by_l_d_1*t541 - D_p_x_3_by_l_d_1*t542
        - D_p_x_3_by_l_d_1*t543 + D_p_y_2*D_p_y_3_by_l_d_1*k_C + D_p_y_2_by_l_d_1*D_p_y_3*k_C
        - D_p_y_2_by_l_d_1*t553 - D_p_y_2_by_l_d_1*t554 - D_p_y_2_by_l_d_1*t555 - D_p_y_3_by_l_d_1*t544
        - D_p_y_3_by_l_d_1*t545 - D_p_y_3_by_l_d_1*t546 + D_p_z_2*D_p_z_3_by_l_d_1*k_C
        + D_p_z_2_by_l_d_1*D_p_z_3*k_C - D_p_z_2_by_l_d_1*t556 - D_p_z_2_by_l_d_1*t557
        - D_p_z_2_by_l_d_1*t558 - D_p_z_3_by_l_d_1*t547 - D_p_z_3_by_l_d_1*t548 - D_p_z_3_by_l_d_1*t549
        + mu_1_by_l_d_1*t498 + mu_2_by_l_d_1*t499 + mu_3_by_l_d_1*t500,
        D_delta_x_1_by_l_d_1*t603 + D_delta_y_1_by_l_d_1*t604 + D_delta_z_1_by_l_d_1*t605
        - D_p_x_2_by_l_d_1*t566 - D_p_x_2_by_l_d_1*t567 - D_p_x_2_by_l_d_1*t568 + D_p_x_2_by_l_d_1*t640
        - D_p_y_2_by_l_d_1*t569 - D_p_y_2_by_l_d_1*t570 - D_p_y_2_by_l_d_1*t571 + D_p_y_2_by_l_d_1*t641
        - D_p_z_2_by_l_d_1*t572 - D_p_z_2_by_l_d_1*t573 - D_p_z_2_by_l_d_1*t574 + D_p_z_2_by_l_d_1*t642
        + mu_1_by_l_d_1*t501 + mu_2_by_l_d_1*t502 + mu_3_by_l_d_1*t503,
        D_delta_x_2_by_l_d_1*t603 + D_delta_y_2_by_l_d_1*t604 + D_delta_z_2_by_l_d_1*t605
        - D_p_x_2_by_l_d_1*t578 - D_p_x_2_by_l_d_1*t579 - D_p_x_2_by_l_d_1*t580 + D_p_x_2_by_l_d_1*t643
        - D_p_y_2_by_l_d_1*t581 - D_p_y_2_by_l_d_1*t582 - D_p_y_2_by_l_d_1*t583 + D_p_y_2_by_l_d_1*t644
        - D_p_z_2_by_l_d_1*t584 - D_p_z_2_by_l_d_1*t585 - D_p_z_2_by_l_d_1*t586 + D_p_z_2_by_l_d_1*t645
        + mu_1_by_l_d_1*t504 + mu_2_by_l_d_1*t505 + mu_3_by_l_d_1*t506,
        D_delta_x_3_by_l_d_1*t603 + D_delta_y_3_by_l_d_1*t604 + D_delta_z_3_by_l_d_1*t605
        - D_p_x_2_by_l_d_1*t587 - D_p_x_2_by_l_d_1*t588 - D_p_x_2_by_l_d_1*t589 + D_p_x_2_by_l_d_1*t646
        - D_p_y_2_by_l_d_1*t590 - D_p_y_2_by_l_d_1*t591 - D_p_y_2_by_l_d_1*t592 + D_p_y_2_by_l_d_1*t647
        - D_p_z_2_by_l_d_1*t593 - D_p_z_2_by_l_d_1*t594 - D_p_z_2_by_l_d_1*t595 + D_p_z_2_by_l_d_1*t648
        + mu_1_by_l_d_1*t507 + mu_2_by_l_d_1*t508 + mu_3_by_l_d_1*t509,
        D_p_x_2_by_l_d_1*k_C, D_p_y_2_by_l_d_1*k_C, D_p_z_2_by_l_d_1*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_1*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_1*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_1*k_C
        + mu_1_by_l_d_1*t510 + mu_2_by_l_d_1*t511 + mu_3_by_l_d_1*t512 - t550*t773 - t551*t773 - t552*t773
        - t553*t774 - t554*t774 - t555*t774 - t556*t775 - t557*t775 - t558*t775,
        D_delta_x_1_by_l_d_1*t612 + D_delta_y_1_by_l_d_1*t613 + D_delta_z_1_by_l_d_1*t614
        - D_p_x_3_by_l_d_1*t566 - D_p_x_3_by_l_d_1*t567 - D_p_x_3_by_l_d_1*t568 + D_p_x_3_by_l_d_1*t640
        - D_p_y_3_by_l_d_1*t569 - D_p_y_3_by_l_d_1*t570 - D_p_y_3_by_l_d_1*t571 + D_p_y_3_by_l_d_1*t641
        - D_p_z_3_by_l_d_1*t572 - D_p_z_3_by_l_d_1*t573 - D_p_z_3_by_l_d_1*t574 + D_p_z_3_by_l_d_1*t642
        + mu_1_by_l_d_1*t513 + mu_2_by_l_d_1*t514 + mu_3_by_l_d_1*t515,
        D_delta_x_2_by_l_d_1*t612 + D_delta_y_2_by_l_d_1*t613 + D_delta_z_2_by_l_d_1*t614
        - D_p_x_3_by_l_d_1*t578 - D_p_x_3_by_l_d_1*t579 - D_p_x_3_by_l_d_1*t580 + D_p_x_3_by_l_d_1*t643
        - D_p_y_3_by_l_d_1*t581 - D_p_y_3_by_l_d_1*t582 - D_p_y_3_by_l_d_1*t583 + D_p_y_3_by_l_d_1*t644
        - D_p_z_3_by_l_d_1*t584 - D_p_z_3_by_l_d_1*t585 - D_p_z_3_by_l_d_1*t586 + D_p_z_3_by_l_d_1*t645
        + mu_1_by_l_d_1*t516 + mu_2_by_l_d_1*t517 + mu_3_by_l_d_1*t518,
        D_delta_x_3_by_l_d_1*t612 + D_delta_y_3_by_l_d_1*t613 + D_delta_z_3_by_l_d_1*t614
        - D_p_x_3_by_l_d_1*t587 - D_p_x_3_by_l_d_1*t588 - D_p_x_3_by_l_d_1*t589 + D_p_x_3_by_l_d_1*t646
        - D_p_y_3_by_l_d_1*t590 - D_p_y_3_by_l_d_1*t591 - D_p_y_3_by_l_d_1*t592 + D_p_y_3_by_l_d_1*t647
        - D_p_z_3_by_l_d_1*t593 - D_p_z_3_by_l_d_1*t594 - D_p_z_3_by_l_d_1*t595 + D_p_z_3_by_l_d_1*t648
        + mu_1_by_l_d_1*t519 + mu_2_by_l_d_1*t520 + mu_3_by_l_d_1*t521,
        D_p_x_3_by_l_d_1*k_C, D_p_y_3_by_l_d_1*k_C, D_p_z_3_by_l_d_1*k_C, t311*t766, t767, -t311*t765, t768,
        D_delta_x_1_by_l_d_1*t615 + D_delta_y_1_by_l_d_1*t616 + D_delta_z_1_by_l_d_1*t617
        + mu_1_by_l_d_1*t522 - mu_2_by_l_d_1*t238 - mu_3_by_l_d_1*t238,
        D_delta_x_1_by_l_d_1*t618 + D_delta_x_2_by_l_d_1*t619 + D_delta_y_1_by_l_d_1*t620
        + D_delta_y_2_by_l_d_1*t621 + D_delta_z_1_by_l_d_1*t622 + D_delta_z_2_by_l_d_1*t623
        - mu_1_by_l_d_1*t242 - mu_2_by_l_d_1*t242 - mu_3_by_l_d_1*t242,
        D_delta_x_1_by_l_d_1*t624 + D_delta_x_3_by_l_d_1*t619 + D_delta_y_1_by_l_d_1*t625
        + D_delta_y_3_by_l_d_1*t621 + D_delta_z_1_by_l_d_1*t626 + D_delta_z_3_by_l_d_1*t623
        - mu_1_by_l_d_1*t246 - mu_2_by_l_d_1*t246 - mu_3_by_l_d_1*t246,
        D_delta_x_1_by_l_d_1*k_C, D_delta_y_1_by_l_d_1*k_C, D_delta_z_1_by_l_d_1*k_C,
        D_delta_x_2_by_l_d_1*t627 + D_delta_y_2_by_l_d_1*t628 + D_delta_z_2_by_l_d_1*t629
        - mu_1_by_l_d_1*t250 + mu_2_by_l_d_1*t523 - mu_3_by_l_d_1*t250,
        D_delta_x_2_by_l_d_1*t624 + D_delta_x_3_by_l_d_1*t618 + D_delta_y_2_by_l_d_1*t625
        + D_delta_y_3_by_l_d_1*t620 + D_delta_z_2_by_l_d_1*t626 + D_delta_z_3_by_l_d_1*t622
        - mu_1_by_l_d_1*t254 - mu_2_by_l_d_1*t254 - mu_3_by_l_d_1*t254,
        D_delta_x_2_by_l_d_1*k_C, D_delta_y_2_by_l_d_1*k_C, D_delta_z_2_by_l_d_1*k_C,
        D_delta_x_3_by_l_d_1*t630 + D_delta_y_3_by_l_d_1*t631 + D_delta_z_3_by_l_d_1*t632
        - mu_1_by_l_d_1*t258 - mu_2_by_l_d_1*t258 + mu_3_by_l_d_1*t524,
        D_delta_x_3_by_l_d_1*k_C, D_delta_y_3_by_l_d_1*k_C, D_delta_z_3_by_l_d_1*k_C, t769,
        2*D_p_x_1*D_p_x_1_by_l_d_2*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_2*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_2*k_C
        + mu_1_by_l_d_2*t477 + mu_2_by_l_d_2*t478 + mu_3_by_l_d_2*t479 - t525*t776 - t527*t776 - t528*t776
        - t529*t777 - t531*t777 - t532*t777 - t533*t778 - t535*t778 - t536*t778,
        D_p_x_1*D_p_x_2_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_2*k_C - D_p_x_1_by_l_d_2*t541
        - D_p_x_1_by_l_d_2*t542 - D_p_x_1_by_l_d_2*t543 - D_p_x_2_by_l_d_2*t525 - D_p_x_2_by_l_d_2*t527
        - D_p_x_2_by_l_d_2*t528 + D_p_y_1*D_p_y_2_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_2*k_C
        - D_p_y_1_by_l_d_2*t544 - D_p_y_1_by_l_d_2*t545 - D_p_y_1_by_l_d_2*t546 - D_p_y_2_by_l_d_2*t529
        - D_p_y_2_by_l_d_2*t531 - D_p_y_2_by_l_d_2*t532 + D_p_z_1*D_p_z_2_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_2*k_C - D_p_z_1_by_l_d_2*t547 - D_p_z_1_by_l_d_2*t548
        - D_p_z_1_by_l_d_2*t549 - D_p_z_2_by_l_d_2*t533 - D_p_z_2_by_l_d_2*t535 - D_p_z_2_by_l_d_2*t536
        + mu_1_by_l_d_2*t480 + mu_2_by_l_d_2*t481 + mu_3_by_l_d_2*t482,
        D_p_x_1*D_p_x_3_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_3*k_C - D_p_x_1_by_l_d_2*t550
        - D_p_x_1_by_l_d_2*t551 - D_p_x_1_by_l_d_2*t552 - D_p_x_3_by_l_d_2*t525 - D_p_x_3_by_l_d_2*t527
        - D_p_x_3_by_l_d_2*t528 + D_p_y_1*D_p_y_3_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_3*k_C
        - D_p_y_1_by_l_d_2*t553 - D_p_y_1_by_l_d_2*t554 - D_p_y_1_by_l_d_2*t555 - D_p_y_3_by_l_d_2*t529
        - D_p_y_3_by_l_d_2*t531 - D_p_y_3_by_l_d_2*t532 + D_p_z_1*D_p_z_3_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_3*k_C - D_p_z_1_by_l_d_2*t556 - D_p_z_1_by_l_d_2*t557
        - D_p_z_1_by_l_d_2*t558 - D_p_z_3_by_l_d_2*t533 - D_p_z_3_by_l_d_2*t535 - D_p_z_3_by_l_d_2*t536
        + mu_1_by_l_d_2*t483 + mu_2_by_l_d_2*t484 + mu_3_by_l_d_2*t485,
        D_delta_x_1_by_l_d_2*t575 + D_delta_y_1_by_l_d_2*t576 + D_delta_z_1_by_l_d_2*t577
        - D_p_x_1_by_l_d_2*t566 - D_p_x_1_by_l_d_2*t567 - D_p_x_1_by_l_d_2*t568 + D_p_x_1_by_l_d_2*t640
        - D_p_y_1_by_l_d_2*t569 - D_p_y_1_by_l_d_2*t570 - D_p_y_1_by_l_d_2*t571 + D_p_y_1_by_l_d_2*t641
        - D_p_z_1_by_l_d_2*t572 - D_p_z_1_by_l_d_2*t573 - D_p_z_1_by_l_d_2*t574 + D_p_z_1_by_l_d_2*t642
        + mu_1_by_l_d_2*t486 + mu_2_by_l_d_2*t487 + mu_3_by_l_d_2*t488,
        D_delta_x_2_by_l_d_2*t575 + D_delta_y_2_by_l_d_2*t576 + D_delta_z_2_by_l_d_2*t577
        - D_p_x_1_by_l_d_2*t578 - D_p_x_1_by_l_d_2*t579 - D_p_x_1_by_l_d_2*t580 + D_p_x_1_by_l_d_2*t643
        - D_p_y_1_by_l_d_2*t581 - D_p_y_1_by_l_d_2*t582 - D_p_y_1_by_l_d_2*t583 + D_p_y_1_by_l_d_2*t644
        - D_p_z_1_by_l_d_2*t584 - D_p_z_1_by_l_d_2*t585 - D_p_z_1_by_l_d_2*t586 + D_p_z_1_by_l_d_2*t645
        + mu_1_by_l_d_2*t489 + mu_2_by_l_d_2*t490 + mu_3_by_l_d_2*t491,
        D_delta_x_3_by_l_d_2*t575 + D_delta_y_3_by_l_d_2*t576 + D_delta_z_3_by_l_d_2*t577
        - D_p_x_1_by_l_d_2*t587 - D_p_x_1_by_l_d_2*t588 - D_p_x_1_by_l_d_2*t589 + D_p_x_1_by_l_d_2*t646
        - D_p_y_1_by_l_d_2*t590 - D_p_y_1_by_l_d_2*t591 - D_p_y_1_by_l_d_2*t592 + D_p_y_1_by_l_d_2*t647
        - D_p_z_1_by_l_d_2*t593 - D_p_z_1_by_l_d_2*t594 - D_p_z_1_by_l_d_2*t595 + D_p_z_1_by_l_d_2*t648
        + mu_1_by_l_d_2*t492 + mu_2_by_l_d_2*t493 + mu_3_by_l_d_2*t494,
        D_p_x_1_by_l_d_2*k_C, D_p_y_1_by_l_d_2*k_C, D_p_z_1_by_l_d_2*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_2*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_2*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_2*k_C
        + k_sp_2*t22*t679*w_b_2*x_2_by_l_d_2 + mu_1_by_l_d_2*t495 + mu_2_by_l_d_2*t496
        + mu_3_by_l_d_2*t497 - t541*t779 - t542*t779 - t543*t779 - t544*t780 - t545*t780 - t546*t780
        - t547*t781 - t548*t781 - t549*t781 - t782,
        D_p_x_2*D_p_x_3_by_l_d_2*k_C + D_p_x_2_by_l_d_2*D_p_x_3*k_C - D_p_x_2_by_l_d_2*t550
        - D_p_x_2_by_l_d_2*t551 - D_p_x_2_by_l_d_2*t552 - D_p_x_3_by_l_d_2*t541 - D_p_x_3_by_l_d_2*t542
        - D_p_x_3_by_l_d_2*t543 + D_p_y_2*D_p_y_3_by_l_d_2*k_C + D_p_y_2_by_l_d_2*D_p_y_3*k_C
        - D_p_y_2_by_l_d_2*t553 - D_p_y_2_by_l_d_2*t554 - D_p_y_2_by_l_d_2*t555 - D_p_y_3_by_l_d_2*t544
        - D_p_y_3_by_l_d_2*t545 - D_p_y_3_by_l_d_2*t546 + D_p_z_2*D_p_z_3_by_l_d_2*k_C
        + D_p_z_2_by_l_d_2*D_p_z_3*k_C - D_p_z_2_by_l_d_2*t556 - D_p_z_2_by_l_d_2*t557
        - D_p_z_2_by_l_d_2*t558 - D_p_z_3_by_l_d_2*t547 - D_p_z_3_by_l_d_2*t548 - D_p_z_3_by_l_d_2*t549
        + mu_1_by_l_d_2*t498 + mu_2_by_l_d_2*t499 + mu_3_by_l_d_2*t500,
        t784, t785,
        D_delta_x_1_by_l_d_2*t603 + D_delta_y_1_by_l_d_2*t604 + D_delta_z_1_by_l_d_2*t605
        - D_p_x_2_by_l_d_2*t566 - D_p_x_2_by_l_d_2*t567 - D_p_x_2_by_l_d_2*t568 + D_p_x_2_by_l_d_2*t640
        - D_p_y_2_by_l_d_2*t569 - D_p_y_2_by_l_d_2*t570 - D_p_y_2_by_l_d_2*t571 + D_p_y_2_by_l_d_2*t641
        - D_p_z_2_by_l_d_2*t572 - D_p_z_2_by_l_d_2*t573 - D_p_z_2_by_l_d_2*t574 + D_p_z_2_by_l_d_2*t642
        + mu_1_by_l_d_2*t501 + mu_2_by_l_d_2*t502 + mu_3_by_l_d_2*t503,
        D_delta_x_2_by_l_d_2*t603 + D_delta_y_2_by_l_d_2*t604 + D_delta_z_2_by_l_d_2*t605
        - D_p_x_2_by_l_d_2*t578 - D_p_x_2_by_l_d_2*t579 - D_p_x_2_by_l_d_2*t580 + D_p_x_2_by_l_d_2*t643
        - D_p_y_2_by_l_d_2*t581 - D_p_y_2_by_l_d_2*t582 - D_p_y_2_by_l_d_2*t583 + D_p_y_2_by_l_d_2*t644
        - D_p_z_2_by_l_d_2*t584 - D_p_z_2_by_l_d_2*t585 - D_p_z_2_by_l_d_2*t586 + D_p_z_2_by_l_d_2*t645
        + mu_1_by_l_d_2*t504 + mu_2_by_l_d_2*t505 + mu_3_by_l_d_2*t506,
        D_delta_x_3_by_l_d_2*t603 + D_delta_y_3_by_l_d_2*t604 + D_delta_z_3_by_l_d_2*t605
        - D_p_x_2_by_l_d_2*t587 - D_p_x_2_by_l_d_2*t588 - D_p_x_2_by_l_d_2*t589 + D_p_x_2_by_l_d_2*t646
        - D_p_y_2_by_l_d_2*t590 - D_p_y_2_by_l_d_2*t591 - D_p_y_2_by_l_d_2*t592 + D_p_y_2_by_l_d_2*t647
        - D_p_z_2_by_l_d_2*t593 - D_p_z_2_by_l_d_2*t594 - D_p_z_2_by_l_d_2*t595 + D_p_z_2_by_l_d_2*t648
        + mu_1_by_l_d_2*t507 + mu_2_by_l_d_2*t508 + mu_3_by_l_d_2*t509,
        t786, D_p_x_2_by_l_d_2*k_C, D_p_y_2_by_l_d_2*k_C, D_p_z_2_by_l_d_2*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_2*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_2*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_2*k_C
        + mu_1_by_l_d_2*t510 + mu_2_by_l_d_2*t511 + mu_3_by_l_d_2*t512 - t550*t787 - t551*t787 - t552*t787
        - t553*t788 - t554*t788 - t555*t788 - t556*t789 - t557*t789 - t558*t789,
        D_delta_x_1_by_l_d_2*t612 + D_delta_y_1_by_l_d_2*t613 + D_delta_z_1_by_l_d_2*t614
        - D_p_x_3_by_l_d_2*t566 - D_p_x_3_by_l_d_2*t567 - D_p_x_3_by_l_d_2*t568 + D_p_x_3_by_l_d_2*t640
        - D_p_y_3_by_l_d_2*t569 - D_p_y_3_by_l_d_2*t570 - D_p_y_3_by_l_d_2*t571 + D_p_y_3_by_l_d_2*t641
        - D_p_z_3_by_l_d_2*t572 - D_p_z_3_by_l_d_2*t573 - D_p_z_3_by_l_d_2*t574 + D_p_z_3_by_l_d_2*t642
        + mu_1_by_l_d_2*t513 + mu_2_by_l_d_2*t514 + mu_3_by_l_d_2*t515,
        D_delta_x_2_by_l_d_2*t612 + D_delta_y_2_by_l_d_2*t613 + D_delta_z_2_by_l_d_2*t614
        - D_p_x_3_by_l_d_2*t578 - D_p_x_3_by_l_d_2*t579 - D_p_x_3_by_l_d_2*t580 + D_p_x_3_by_l_d_2*t643
        - D_p_y_3_by_l_d_2*t581 - D_p_y_3_by_l_d_2*t582 - D_p_y_3_by_l_d_2*t583 + D_p_y_3_by_l_d_2*t644
        - D_p_z_3_by_l_d_2*t584 - D_p_z_3_by_l_d_2*t585 - D_p_z_3_by_l_d_2*t586 + D_p_z_3_by_l_d_2*t645
        + mu_1_by_l_d_2*t516 + mu_2_by_l_d_2*t517 + mu_3_by_l_d_2*t518,
        D_delta_x_3_by_l_d_2*t612 + D_delta_y_3_by_l_d_2*t613 + D_delta_z_3_by_l_d_2*t614
        - D_p_x_3_by_l_d_2*t587 - D_p_x_3_by_l_d_2*t588 - D_p_x_3_by_l_d_2*t589 + D_p_x_3_by_l_d_2*t646
        - D_p_y_3_by_l_d_2*t590 - D_p_y_3_by_l_d_2*t591 - D_p_y_3_by_l_d_2*t592 + D_p_y_3_by_l_d_2*t647
        - D_p_z_3_by_l_d_2*t593 - D_p_z_3_by_l_d_2*t594 - D_p_z_3_by_l_d_2*t595 + D_p_z_3_by_l_d_2*t648
        + mu_1_by_l_d_2*t519 + mu_2_by_l_d_2*t520 + mu_3_by_l_d_2*t521,
        D_p_x_3_by_l_d_2*k_C, D_p_y_3_by_l_d_2*k_C, D_p_z_3_by_l_d_2*k_C, t342*t783, t784, -t342*t782, t785,
        D_delta_x_1_by_l_d_2*t615 + D_delta_y_1_by_l_d_2*t616 + D_delta_z_1_by_l_d_2*t617
        + mu_1_by_l_d_2*t522 - mu_2_by_l_d_2*t238 - mu_3_by_l_d_2*t238,
        D_delta_x_1_by_l_d_2*t618 + D_delta_x_2_by_l_d_2*t619 + D_delta_y_1_by_l_d_2*t620
        + D_delta_y_2_by_l_d_2*t621 + D_delta_z_1_by_l_d_2*t622 + D_delta_z_2_by_l_d_2*t623
        - mu_1_by_l_d_2*t242 - mu_2_by_l_d_2*t242 - mu_3_by_l_d_2*t242,
        D_delta_x_1_by_l_d_2*t624 + D_delta_x_3_by_l_d_2*t619 + D_delta_y_1_by_l_d_2*t625
        + D_delta_y_3_by_l_d_2*t621 + D_delta_z_1_by_l_d_2*t626 + D_delta_z_3_by_l_d_2*t623
        - mu_1_by_l_d_2*t246 - mu_2_by_l_d_2*t246 - mu_3_by_l_d_2*t246,
        D_delta_x_1_by_l_d_2*k_C, D_delta_y_1_by_l_d_2*k_C, D_delta_z_1_by_l_d_2*k_C,
        D_delta_x_2_by_l_d_2*t627 + D_delta_y_2_by_l_d_2*t628 + D_delta_z_2_by_l_d_2*t629
        - mu_1_by_l_d_2*t250 + mu_2_by_l_d_2*t523 - mu_3_by_l_d_2*t250,
        D_delta_x_2_by_l_d_2*t624 + D_delta_x_3_by_l_d_2*t618 + D_delta_y_2_by_l_d_2*t625
        + D_delta_y_3_by_l_d_2*t620 + D_delta_z_2_by_l_d_2*t626 + D_delta_z_3_by_l_d_2*t622
        - mu_1_by_l_d_2*t254 - mu_2_by_l_d_2*t254 - mu_3_by_l_d_2*t254,
        D_delta_x_2_by_l_d_2*k_C, D_delta_y_2_by_l_d_2*k_C, D_delta_z_2_by_l_d_2*k_C,
        D_delta_x_3_by_l_d_2*t630 + D_delta_y_3_by_l_d_2*t631 + D_delta_z_3_by_l_d_2*t632
        - mu_1_by_l_d_2*t258 - mu_2_by_l_d_2*t258 + mu_3_by_l_d_2*t524,
        D_delta_x_3_by_l_d_2*k_C, D_delta_y_3_by_l_d_2*k_C, D_delta_z_3_by_l_d_2*k_C, t786,
        2*D_p_x_1*D_p_x_1_by_l_d_3*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_3*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_3*k_C
        + mu_1_by_l_d_3*t477 + mu_2_by_l_d_3*t478 + mu_3_by_l_d_3*t479 - t525*t790 - t527*t790 - t528*t790
        - t529*t791 - t531*t791 - t532*t791 - t533*t792 - t535*t792 - t536*t792,
        D_p_x_1*D_p_x_2_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_2*k_C - D_p_x_1_by_l_d_3*t541
        - D_p_x_1_by_l_d_3*t542 - D_p_x_1_by_l_d_3*t543 - D_p_x_2_by_l_d_3*t525 - D_p_x_2_by_l_d_3*t527
        - D_p_x_2_by_l_d_3*t528 + D_p_y_1*D_p_y_2_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_2*k_C
        - D_p_y_1_by_l_d_3*t544 - D_p_y_1_by_l_d_3*t545 - D_p_y_1_by_l_d_3*t546 - D_p_y_2_by_l_d_3*t529
        - D_p_y_2_by_l_d_3*t531 - D_p_y_2_by_l_d_3*t532 + D_p_z_1*D_p_z_2_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_2*k_C - D_p_z_1_by_l_d_3*t547 - D_p_z_1_by_l_d_3*t548
        - D_p_z_1_by_l_d_3*t549 - D_p_z_2_by_l_d_3*t533 - D_p_z_2_by_l_d_3*t535 - D_p_z_2_by_l_d_3*t536
        + mu_1_by_l_d_3*t480 + mu_2_by_l_d_3*t481 + mu_3_by_l_d_3*t482,
        D_p_x_1*D_p_x_3_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_3*k_C - D_p_x_1_by_l_d_3*t550
        - D_p_x_1_by_l_d_3*t551 - D_p_x_1_by_l_d_3*t552 - D_p_x_3_by_l_d_3*t525 - D_p_x_3_by_l_d_3*t527
        - D_p_x_3_by_l_d_3*t528 + D_p_y_1*D_p_y_3_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_3*k_C
        - D_p_y_1_by_l_d_3*t553 - D_p_y_1_by_l_d_3*t554 - D_p_y_1_by_l_d_3*t555 - D_p_y_3_by_l_d_3*t529
        - D_p_y_3_by_l_d_3*t531 - D_p_y_3_by_l_d_3*t532 + D_p_z_1*D_p_z_3_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_3*k_C - D_p_z_1_by_l_d_3*t556 - D_p_z_1_by_l_d_3*t557
        - D_p_z_1_by_l_d_3*t558 - D_p_z_3_by_l_d_3*t533 - D_p_z_3_by_l_d_3*t535 - D_p_z_3_by_l_d_3*t536
        + mu_1_by_l_d_3*t483 + mu_2_by_l_d_3*t484 + mu_3_by_l_d_3*t485,
        D_delta_x_1_by_l_d_3*t575 + D_delta_y_1_by_l_d_3*t576 + D_delta_z_1_by_l_d_3*t577
        - D_p_x_1_by_l_d_3*t566 - D_p_x_1_by_l_d_3*t567 - D_p_x_1_by_l_d_3*t568 + D_p_x_1_by_l_d_3*t640
        - D_p_y_1_by_l_d_3*t569 - D_p_y_1_by_l_d_3*t570 - D_p_y_1_by_l_d_3*t571 + D_p_y_1_by_l_d_3*t641
        - D_p_z_1_by_l_d_3*t572 - D_p_z_1_by_l_d_3*t573 - D_p_z_1_by_l_d_3*t574 + D_p_z_1_by_l_d_3*t642
        + mu_1_by_l_d_3*t486 + mu_2_by_l_d_3*t487 + mu_3_by_l_d_3*t488,
        D_delta_x_2_by_l_d_3*t575 + D_delta_y_2_by_l_d_3*t576 + D_delta_z_2_by_l_d_3*t577
        - D_p_x_1_by_l_d_3*t578 - D_p_x_1_by_l_d_3*t579 - D_p_x_1_by_l_d_3*t580 + D_p_x_1_by_l_d_3*t643
        - D_p_y_1_by_l_d_3*t581 - D_p_y_1_by_l_d_3*t582 - D_p_y_1_by_l_d_3*t583 + D_p_y_1_by_l_d_3*t644
        - D_p_z_1_by_l_d_3*t584 - D_p_z_1_by_l_d_3*t585 - D_p_z_1_by_l_d_3*t586 + D_p_z_1_by_l_d_3*t645
        + mu_1_by_l_d_3*t489 + mu_2_by_l_d_3*t490 + mu_3_by_l_d_3*t491,
        D_delta_x_3_by_l_d_3*t575 + D_delta_y_3_by_l_d_3*t576 + D_delta_z_3_by_l_d_3*t577
        - D_p_x_1_by_l_d_3*t587 - D_p_x_1_by_l_d_3*t588 - D_p_x_1_by_l_d_3*t589 + D_p_x_1_by_l_d_3*t646
        - D_p_y_1_by_l_d_3*t590 - D_p_y_1_by_l_d_3*t591 - D_p_y_1_by_l_d_3*t592 + D_p_y_1_by_l_d_3*t647
        - D_p_z_1_by_l_d_3*t593 - D_p_z_1_by_l_d_3*t594 - D_p_z_1_by_l_d_3*t595 + D_p_z_1_by_l_d_3*t648
        + mu_1_by_l_d_3*t492 + mu_2_by_l_d_3*t493 + mu_3_by_l_d_3*t494,
        D_p_x_1_by_l_d_3*k_C, D_p_y_1_by_l_d_3*k_C, D_p_z_1_by_l_d_3*k_C,
        2*D_p_x_2*D_p_x_2_by_l_d_3*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_3*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_3*k_C
        + mu_1_by_l_d_3*t495 + mu_2_by_l_d_3*t496 + mu_3_by_l_d_3*t497 - t541*t793 - t542*t793 - t543*t793
        - t544*t794 - t545*t794 - t546*t794 - t547*t795 - t548*t795 - t549*t795,
        D_p_x_2*D_p_x_3_by_l_d_3*k_C + D_p_x_2_by_l_d_3*D_p_x_3*k_C - D_p_x_2_by_l_d_3*t550
        - D_p_x_2_by_l_d_3*t551 - D_p_x_2_by_l_d_3*t552 - D_p_x_3_by_l_d_3*t541 - D_p_x_3_by_l_d_3*t542
        - D_p_x_3_by_l_d_3*t543 + D_p_y_2*D_p_y_3_by_l_d_3*k_C + D_p_y_2_by_l_d_3*D_p_y_3*k_C
        - D_p_y_2_by_l_d_3*t553 - D_p_y_2_by_l_d_3*t554 - D_p_y_2_by_l_d_3*t555 - D_p_y_3_by_l_d_3*t544
        - D_p_y_3_by_l_d_3*t545 - D_p_y_3_by_l_d_3*t546 + D_p_z_2*D_p_z_3_by_l_d_3*k_C
        + D_p_z_2_by_l_d_3*D_p_z_3*k_C - D_p_z_2_by_l_d_3*t556 - D_p_z_2_by_l_d_3*t557
        - D_p_z_2_by_l_d_3*t558 - D_p_z_3_by_l_d_3*t547 - D_p_z_3_by_l_d_3*t548 - D_p_z_3_by_l_d_3*t549
        + mu_1_by_l_d_3*t498 + mu_2_by_l_d_3*t499 + mu_3_by_l_d_3*t500,
        D_delta_x_1_by_l_d_3*t603 + D_delta_y_1_by_l_d_3*t604 + D_delta_z_1_by_l_d_3*t605
        - D_p_x_2_by_l_d_3*t566 - D_p_x_2_by_l_d_3*t567 - D_p_x_2_by_l_d_3*t568 + D_p_x_2_by_l_d_3*t640
        - D_p_y_2_by_l_d_3*t569 - D_p_y_2_by_l_d_3*t570 - D_p_y_2_by_l_d_3*t571 + D_p_y_2_by_l_d_3*t641
        - D_p_z_2_by_l_d_3*t572 - D_p_z_2_by_l_d_3*t573 - D_p_z_2_by_l_d_3*t574 + D_p_z_2_by_l_d_3*t642
        + mu_1_by_l_d_3*t501 + mu_2_by_l_d_3*t502 + mu_3_by_l_d_3*t503,
        D_delta_x_2_by_l_d_3*t603 + D_delta_y_2_by_l_d_3*t604 + D_delta_z_2_by_l_d_3*t605
        - D_p_x_2_by_l_d_3*t578 - D_p_x_2_by_l_d_3*t579 - D_p_x_2_by_l_d_3*t580 + D_p_x_2_by_l_d_3*t643
        - D_p_y_2_by_l_d_3*t581 - D_p_y_2_by_l_d_3*t582 - D_p_y_2_by_l_d_3*t583 + D_p_y_2_by_l_d_3*t644
        - D_p_z_2_by_l_d_3*t584 - D_p_z_2_by_l_d_3*t585 - D_p_z_2_by_l_d_3*t586 + D_p_z_2_by_l_d_3*t645
        + mu_1_by_l_d_3*t504 + mu_2_by_l_d_3*t505 + mu_3_by_l_d_3*t506,
        D_delta_x_3_by_l_d_3*t603 + D_delta_y_3_by_l_d_3*t604 + D_delta_z_3_by_l_d_3*t605
        - D_p_x_2_by_l_d_3*t587 - D_p_x_2_by_l_d_3*t588 - D_p_x_2_by_l_d_3*t589 + D_p_x_2_by_l_d_3*t646
        - D_p_y_2_by_l_d_3*t590 - D_p_y_2_by_l_d_3*t591 - D_p_y_2_by_l_d_3*t592 + D_p_y_2_by_l_d_3*t647
        - D_p_z_2_by_l_d_3*t593 - D_p_z_2_by_l_d_3*t594 - D_p_z_2_by_l_d_3*t595 + D_p_z_2_by_l_d_3*t648
        + mu_1_by_l_d_3*t507 + mu_2_by_l_d_3*t508 + mu_3_by_l_d_3*t509,
        D_p_x_2_by_l_d_3*k_C, D_p_y_2_by_l_d_3*k_C, D_p_z_2_by_l_d_3*k_C,
        2*D_p_x_3*D_p_x_3_by_l_d_3*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_3*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_3*k_C
        + k_sp_3*t33*t728*w_b_3*x_3_by_l_d_3 + mu_1_by_l_d_3*t510 + mu_2_by_l_d_3*t511
        + mu_3_by_l_d_3*t512 - t550*t796 - t551*t796 - t552*t796 - t553*t797 - t554*t797 - t555*t797
        - t556*t798 - t557*t798 - t558*t798 - t799,
        t801, t802,
        D_delta_x_1_by_l_d_3*t612 + D_delta_y_1_by_l_d_3*t613 + D_delta_z_1_by_l_d_3*t614
        - D_p_x_3_by_l_d_3*t566 - D_p_x_3_by_l_d_3*t567 - D_p_x_3_by_l_d_3*t568 + D_p_x_3_by_l_d_3*t640
        - D_p_y_3_by_l_d_3*t569 - D_p_y_3_by_l_d_3*t570 - D_p_y_3_by_l_d_3*t571 + D_p_y_3_by_l_d_3*t641
        - D_p_z_3_by_l_d_3*t572 - D_p_z_3_by_l_d_3*t573 - D_p_z_3_by_l_d_3*t574 + D_p_z_3_by_l_d_3*t642
        + mu_1_by_l_d_3*t513 + mu_2_by_l_d_3*t514 + mu_3_by_l_d_3*t515,
        D_delta_x_2_by_l_d_3*t612 + D_delta_y_2_by_l_d_3*t613 + D_delta_z_2_by_l_d_3*t614
        - D_p_x_3_by_l_d_3*t578 - D_p_x_3_by_l_d_3*t579 - D_p_x_3_by_l_d_3*t580 + D_p_x_3_by_l_d_3*t643
        - D_p_y_3_by_l_d_3*t581 - D_p_y_3_by_l_d_3*t582 - D_p_y_3_by_l_d_3*t583 + D_p_y_3_by_l_d_3*t644
        - D_p_z_3_by_l_d_3*t584 - D_p_z_3_by_l_d_3*t585 - D_p_z_3_by_l_d_3*t586 + D_p_z_3_by_l_d_3*t645
        + mu_1_by_l_d_3*t516 + mu_2_by_l_d_3*t517 + mu_3_by_l_d_3*t518,
        D_delta_x_3_by_l_d_3*t612 + D_delta_y_3_by_l_d_3*t613 + D_delta_z_3_by_l_d_3*t614
        - D_p_x_3_by_l_d_3*t587 - D_p_x_3_by_l_d_3*t588 - D_p_x_3_by_l_d_3*t589 + D_p_x_3_by_l_d_3*t646
        - D_p_y_3_by_l_d_3*t590 - D_p_y_3_by_l_d_3*t591 - D_p_y_3_by_l_d_3*t592 + D_p_y_3_by_l_d_3*t647
        - D_p_z_3_by_l_d_3*t593 - D_p_z_3_by_l_d_3*t594 - D_p_z_3_by_l_d_3*t595 + D_p_z_3_by_l_d_3*t648
        + mu_1_by_l_d_3*t519 + mu_2_by_l_d_3*t520 + mu_3_by_l_d_3*t521,
        t803, D_p_x_3_by_l_d_3*k_C, D_p_y_3_by_l_d_3*k_C, D_p_z_3_by_l_d_3*k_C, t351*t800, t801, -t351*t799,
        t802,
        D_delta_x_1_by_l_d_3*t615 + D_delta_y_1_by_l_d_3*t616 + D_delta_z_1_by_l_d_3*t617
        + mu_1_by_l_d_3*t522 - mu_2_by_l_d_3*t238 - mu_3_by_l_d_3*t238,
        D_delta_x_1_by_l_d_3*t618 + D_delta_x_2_by_l_d_3*t619 + D_delta_y_1_by_l_d_3*t620
        + D_delta_y_2_by_l_d_3*t621 + D_delta_z_1_by_l_d_3*t622 + D_delta_z_2_by_l_d_3*t623
        - mu_1_by_l_d_3*t242 - mu_2_by_l_d_3*t242 - mu_3_by_l_d_3*t242,
        D_delta_x_1_by_l_d_3*t624 + D_delta_x_3_by_l_d_3*t619 + D_delta_y_1_by_l_d_3*t625
        + D_delta_y_3_by_l_d_3*t621 + D_delta_z_1_by_l_d_3*t626 + D_delta_z_3_by_l_d_3*t623
        - mu_1_by_l_d_3*t246 - mu_2_by_l_d_3*t246 - mu_3_by_l_d_3*t246,
        D_delta_x_1_by_l_d_3*k_C, D_delta_y_1_by_l_d_3*k_C, D_delta_z_1_by_l_d_3*k_C,
        D_delta_x_2_by_l_d_3*t627 + D_delta_y_2_by_l_d_3*t628 + D_delta_z_2_by_l_d_3*t629
        - mu_1_by_l_d_3*t250 + mu_2_by_l_d_3*t523 - mu_3_by_l_d_3*t250,
        D_delta_x_2_by_l_d_3*t624 + D_delta_x_3_by_l_d_3*t618 + D_delta_y_2_by_l_d_3*t625
        + D_delta_y_3_by_l_d_3*t620 + D_delta_z_2_by_l_d_3*t626 + D_delta_z_3_by_l_d_3*t622
        - mu_1_by_l_d_3*t254 - mu_2_by_l_d_3*t254 - mu_3_by_l_d_3*t254,
        D_delta_x_2_by_l_d_3*k_C, D_delta_y_2_by_l_d_3*k_C, D_delta_z_2_by_l_d_3*k_C,
        D_delta_x_3_by_l_d_3*t630 + D_delta_y_3_by_l_d_3*t631 + D_delta_z_3_by_l_d_3*t632
        - mu_1_by_l_d_3*t258 - mu_2_by_l_d_3*t258 + mu_3_by_l_d_3*t524,
        D_delta_x_3_by_l_d_3*k_C, D_delta_y_3_by_l_d_3*k_C, D_delta_z_3_by_l_d_3*k_C, t803,
        mu_1_by_m_d_1*t477 + mu_2_by_m_d_1*t478 + mu_3_by_m_d_1*t479,
        mu_1_by_m_d_1*t480 + mu_2_by_m_d_1*t481 + mu_3_by_m_d_1*t482,
        mu_1_by_m_d_1*t483 + mu_2_by_m_d_1*t484 + mu_3_by_m_d_1*t485,
        mu_1_by_m_d_1*t486 + mu_2_by_m_d_1*t487 + mu_3_by_m_d_1*t488,
        mu_1_by_m_d_1*t489 + mu_2_by_m_d_1*t490 + mu_3_by_m_d_1*t491,
        mu_1_by_m_d_1*t492 + mu_2_by_m_d_1*t493 + mu_3_by_m_d_1*t494,
        mu_1_by_m_d_1*t495 + mu_2_by_m_d_1*t496 + mu_3_by_m_d_1*t497,
        mu_1_by_m_d_1*t498 + mu_2_by_m_d_1*t499 + mu_3_by_m_d_1*t500,
        mu_1_by_m_d_1*t501 + mu_2_by_m_d_1*t502 + mu_3_by_m_d_1*t503,
        mu_1_by_m_d_1*t504 + mu_2_by_m_d_1*t505 + mu_3_by_m_d_1*t506,
        mu_1_by_m_d_1*t507 + mu_2_by_m_d_1*t508 + mu_3_by_m_d_1*t509,
        mu_1_by_m_d_1*t510 + mu_2_by_m_d_1*t511 + mu_3_by_m_d_1*t512,
        mu_1_by_m_d_1*t513 + mu_2_by_m_d_1*t514 + mu_3_by_m_d_1*t515,
        mu_1_by_m_d_1*t516 + mu_2_by_m_d_1*t517 + mu_3_by_m_d_1*t518,
        mu_1_by_m_d_1*t519 + mu_2_by_m_d_1*t520 + mu_3_by_m_d_1*t521,
        mu_1_by_m_d_1*t522 - mu_2_by_m_d_1*t238 - mu_3_by_m_d_1*t238,
        -mu_1_by_m_d_1*t242 - mu_2_by_m_d_1*t242 - mu_3_by_m_d_1*t242,
        -mu_1_by_m_d_1*t246 - mu_2_by_m_d_1*t246 - mu_3_by_m_d_1*t246,
        -mu_1_by_m_d_1*t250 + mu_2_by_m_d_1*t523 - mu_3_by_m_d_1*t250,
        -mu_1_by_m_d_1*t254 - mu_2_by_m_d_1*t254 - mu_3_by_m_d_1*t254,
        -mu_1_by_m_d_1*t258 - mu_2_by_m_d_1*t258 + mu_3_by_m_d_1*t524,
        mu_1_by_m_d_2*t477 + mu_2_by_m_d_2*t478 + mu_3_by_m_d_2*t479,
        mu_1_by_m_d_2*t480 + mu_2_by_m_d_2*t481 + mu_3_by_m_d_2*t482,
        mu_1_by_m_d_2*t483 + mu_2_by_m_d_2*t484 + mu_3_by_m_d_2*t485,
        mu_1_by_m_d_2*t486 + mu_2_by_m_d_2*t487 + mu_3_by_m_d_2*t488,
        mu_1_by_m_d_2*t489 + mu_2_by_m_d_2*t490 + mu_3_by_m_d_2*t491,
        mu_1_by_m_d_2*t492 + mu_2_by_m_d_2*t493 + mu_3_by_m_d_2*t494,
        mu_1_by_m_d_2*t495 + mu_2_by_m_d_2*t496 + mu_3_by_m_d_2*t497,
        mu_1_by_m_d_2*t498 + mu_2_by_m_d_2*t499 + mu_3_by_m_d_2*t500,
        mu_1_by_m_d_2*t501 + mu_2_by_m_d_2*t502 + mu_3_by_m_d_2*t503,
        mu_1_by_m_d_2*t504 + mu_2_by_m_d_2*t505 + mu_3_by_m_d_2*t506,
        mu_1_by_m_d_2*t507 + mu_2_by_m_d_2*t508 + mu_3_by_m_d_2*t509,
        mu_1_by_m_d_2*t510 + mu_2_by_m_d_2*t511 + mu_3_by_m_d_2*t512,
        mu_1_by_m_d_2*t513 + mu_2_by_m_d_2*t514 + mu_3_by_m_d_2*t515,
        mu_1_by_m_d_2*t516 + mu_2_by_m_d_2*t517 + mu_3_by_m_d_2*t518,
        mu_1_by_m_d_2*t519 + mu_2_by_m_d_2*t520 + mu_3_by_m_d_2*t521,
        mu_1_by_m_d_2*t522 - mu_2_by_m_d_2*t238 - mu_3_by_m_d_2*t238,
        -mu_1_by_m_d_2*t242 - mu_2_by_m_d_2*t242 - mu_3_by_m_d_2*t242,
        -mu_1_by_m_d_2*t246 - mu_2_by_m_d_2*t246 - mu_3_by_m_d_2*t246,
        -mu_1_by_m_d_2*t250 + mu_2_by_m_d_2*t523 - mu_3_by_m_d_2*t250,
        -mu_1_by_m_d_2*t254 - mu_2_by_m_d_2*t254 - mu_3_by_m_d_2*t254,
        -mu_1_by_m_d_2*t258 - mu_2_by_m_d_2*t258 + mu_3_by_m_d_2*t524,
        mu_1_by_m_d_3*t477 + mu_2_by_m_d_3*t478 + mu_3_by_m_d_3*t479,
        mu_1_by_m_d_3*t480 + mu_2_by_m_d_3*t481 + mu_3_by_m_d_3*t482,
        mu_1_by_m_d_3*t483 + mu_2_by_m_d_3*t484 + mu_3_by_m_d_3*t485,
        mu_1_by_m_d_3*t486 + mu_2_by_m_d_3*t487 + mu_3_by_m_d_3*t488,
        mu_1_by_m_d_3*t489 + mu_2_by_m_d_3*t490 + mu_3_by_m_d_3*t491,
        mu_1_by_m_d_3*t492 + mu_2_by_m_d_3*t493 + mu_3_by_m_d_3*t494,
        mu_1_by_m_d_3*t495 + mu_2_by_m_d_3*t496 + mu_3_by_m_d_3*t497,
        mu_1_by_m_d_3*t498 + mu_2_by_m_d_3*t499 + mu_3_by_m_d_3*t500,
        mu_1_by_m_d_3*t501 + mu_2_by_m_d_3*t502 + mu_3_by_m_d_3*t503,
        mu_1_by_m_d_3*t504 + mu_2_by_m_d_3*t505 + mu_3_by_m_d_3*t506,
        mu_1_by_m_d_3*t507 + mu_2_by_m_d_3*t508 + mu_3_by_m_d_3*t509,
        mu_1_by_m_d_3*t510 + mu_2_by_m_d_3*t511 + mu_3_by_m_d_3*t512,
        mu_1_by_m_d_3*t513 + mu_2_by_m_d_3*t514 + mu_3_by_m_d_3*t515,
        mu_1_by_m_d_3*t516 + mu_2_by_m_d_3*t517 + mu_3_by_m_d_3*t518,
        mu_1_by_m_d_3*t519 + mu_2_by_m_d_3*t520 + mu_3_by_m_d_3*t521,
        mu_1_by_m_d_3*t522 - mu_2_by_m_d_3*t238 - mu_3_by_m_d_3*t238,
        -mu_1_by_m_d_3*t242 - mu_2_by_m_d_3*t242 - mu_3_by_m_d_3*t242,
        -mu_1_by_m_d_3*t246 - mu_2_by_m_d_3*t246 - mu_3_by_m_d_3*t246,
        -mu_1_by_m_d_3*t250 + mu_2_by_m_d_3*t523 - mu_3_by_m_d_3*t250,
        -mu_1_by_m_d_3*t254 - mu_2_by_m_d_3*t254 - mu_3_by_m_d_3*t254,
        -mu_1_by_m_d_3*t258 - mu_2_by_m_d_3*t258 + mu_3_by_m_d_3*t524, t806, t807, t808, t806, t311*t805,
        t807, t311*t804, t808, t806, t811, t812, t813, t811, t342*t810, t812, t342*t809, t813, t811, t816,
        t817, t818, t816, t351*t815, t817, t351*t814, t818, t816, t827, t828, t829, t827, -t311*t824 + t831,
        -t831, t828, -t311*t826 + t831, t829, t827, t840, t841, t842, t840, -t342*t837 + t844, -t844, t841,
        -t342*t839 + t844, t842, t840, t853, t854, t855, t853, -t351*t850 + t857, -t857, t854,
        -t351*t852 + t857, t855, t853, t865, t866, t867, t865, -t311*t862 + t868, -t868, t866,
        -t311*t864 + t868, t867, t865, t876, t877, t878, t876, -t342*t873 + t879, -t879, t877,
        -t342*t875 + t879, t878, t876, t887, t888, t889, t887, -t351*t884 + t890, -t890, t888,
        -t351*t886 + t890, t889, t887, -k_1_3, -k_1_2, k_1_3*t891 + t892, -t892, -k_1_3, k_1_2*t891 + t892,
        -k_1_2, -k_2_3, -k_2_2, k_2_3*t893 + t894, -t894, -k_2_3, k_2_2*t893 + t894, -k_2_2, -k_3_3, -k_3_2,
        k_3_3*t895 + t896, -t896, -k_3_3, k_3_2*t895 + t896, -k_3_2, t538, t897, t538, t899, -t899,
        t311*t538 + t899, t897, t538, t677, t900, t677, t902, -t902, t342*t677 + t902, t900, t677, t726, t903,
        t726, t905, -t905, t351*t726 + t905, t903, t726, -t559, t906, -t559, -t311*t559 - t899, t899, t906,
        -t899, -t559, -t680, t907, -t680, -t342*t680 - t902, t902, t907, -t902, -t680, -t729, t908, -t729,
        -t351*t729 - t905, t905, t908, -t905, -t729, t913, t914, t915, t913, -t311*t911 + t916, -t916, t914,
        -t311*t912 + t916, t915, t913, t921, t922, t923, t921, -t342*t919 + t924, -t924, t922,
        -t342*t920 + t924, t923, t921, t929, t930, t931, t929, -t351*t927 + t932, -t932, t930,
        -t351*t928 + t932, t931, t929, t936, t937, t938, t936, t942, t943, t944, t942, t948, t949, t950, t948,
        -t311*t935 - t951, t951, t937, -t342*t941 - t952, t952, t943, -t351*t947 - t953, t953, t949,
        -t311*t934 - t951, t938, -t342*t940 - t952, t944, -t351*t946 - t953, t950, t936, t942, t948, t178,
        t182, t186, t190, t194, t198, D_p_x_1, D_p_y_1, D_p_z_1, t202, t206, t210, t214, t218, D_p_x_2,
        D_p_y_2, D_p_z_2, t222, t226, t230, t234, D_p_x_3, D_p_y_3, D_p_z_3, t238, t242, t246, D_delta_x_1,
        D_delta_y_1, D_delta_z_1, t250, t254, D_delta_x_2, D_delta_y_2, D_delta_z_2, t258, D_delta_x_3,
        D_delta_y_3, D_delta_z_3, 1, 1, 1, mu_1_by_m_L*t477 + mu_2_by_m_L*t478 + mu_3_by_m_L*t479,
        mu_1_by_m_L*t480 + mu_2_by_m_L*t481 + mu_3_by_m_L*t482,
        mu_1_by_m_L*t483 + mu_2_by_m_L*t484 + mu_3_by_m_L*t485,
        mu_1_by_m_L*t486 + mu_2_by_m_L*t487 + mu_3_by_m_L*t488,
        mu_1_by_m_L*t489 + mu_2_by_m_L*t490 + mu_3_by_m_L*t491,
        mu_1_by_m_L*t492 + mu_2_by_m_L*t493 + mu_3_by_m_L*t494,
        mu_1_by_m_L*t495 + mu_2_by_m_L*t496 + mu_3_by_m_L*t497,
        mu_1_by_m_L*t498 + mu_2_by_m_L*t499 + mu_3_by_m_L*t500,
        mu_1_by_m_L*t501 + mu_2_by_m_L*t502 + mu_3_by_m_L*t503,
        mu_1_by_m_L*t504 + mu_2_by_m_L*t505 + mu_3_by_m_L*t506,
        mu_1_by_m_L*t507 + mu_2_by_m_L*t508 + mu_3_by_m_L*t509,
        mu_1_by_m_L*t510 + mu_2_by_m_L*t511 + mu_3_by_m_L*t512,
        mu_1_by_m_L*t513 + mu_2_by_m_L*t514 + mu_3_by_m_L*t515,
        mu_1_by_m_L*t516 + mu_2_by_m_L*t517 + mu_3_by_m_L*t518,
        mu_1_by_m_L*t519 + mu_2_by_m_L*t520 + mu_3_by_m_L*t521,
        mu_1_by_m_L*t522 - mu_2_by_m_L*t238 - mu_3_by_m_L*t238,
        -mu_1_by_m_L*t242 - mu_2_by_m_L*t242 - mu_3_by_m_L*t242,
        -mu_1_by_m_L*t246 - mu_2_by_m_L*t246 - mu_3_by_m_L*t246,
        -mu_1_by_m_L*t250 + mu_2_by_m_L*t523 - mu_3_by_m_L*t250,
        -mu_1_by_m_L*t254 - mu_2_by_m_L*t254 - mu_3_by_m_L*t254,
        -mu_1_by_m_L*t258 - mu_2_by_m_L*t258 + mu_3_by_m_L*t524, d_1_1, d_2_1, d_3_1, d_1_2, d_2_2, d_3_2,
    ))
    return M_theta_out, K_theta_out
