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
    "SENSITIVITY_PARAMETERS",
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
    ('axis_belt_stiffness',
     'the belts of the three axes are not equally stiff',
     False,
     (),
     (('factor_1', '1', 'relative change of the belt stiffness of axis 1', -1.0, True),
      ('factor_2', '1', 'relative change of the belt stiffness of axis 2', -1.0, True),
      ('factor_3', '1', 'relative change of the belt stiffness of axis 3', -1.0, True))),
    ('belt_end_compliance',
     'the belts yield at their teeth and clamps too',
     False,
     (),
     (('compliance', 'm/N', 'compliance in series with every free span', 0.0, True),)),
    ('belt_mass',
     'the belts are not massless',
     False,
     (),
     (('linear_density', 'kg/m', 'mass of a belt by its length', 0.0, True),)),
    ('cable_stiffness',
     'a cable or hose ties the platform to ground',
     True,
     (),
     (('stiffness', 'N/m', 'isotropic stiffness from the platform centre to ground', 0.0, True),)),
    ('gearbox_inertia',
     'the gearboxes have an inertia of their own',
     False,
     (),
     (('inertia', 'kg m^2', 'extra inertia on every driven pulley', 0.0, True),)),
    ('payload',
     'the platform carries a mass that is not declared',
     False,
     (),
     (('mass', 'kg', 'point mass at the platform centre', 0.0, True),)),
    ('servo_stiffness',
     'the position loops hold the driven pulleys',
     True,
     (),
     (('stiffness', 'N m/rad', 'torsional stiffness to ground at every driven pulley', 0.0, True),)),
    ('gearbox_compliance',
     'the gearboxes wind up',
     False,
     ('psi_1', 'psi_2', 'psi_3'),
     (('compliance', 'rad/(N m)', 'compliance of every gearbox, output side', 0.0, True),)),
    ('link_compliance',
     'the linkages stretch',
     False,
     ('delta_1', 'delta_2', 'delta_3'),
     (('compliance', 'm/N', 'axial compliance of every linkage', 0.0, True),)),
    ('clamp_compliance',
     "the belts' clamps yield on their carriages",
     False,
     ('eps_1', 'eps_2', 'eps_3'),
     (('compliance', 'm/N', 'compliance of every belt clamp', 0.0, True),)),
    ('frame_compliance',
     'the frame moves',
     False,
     ('u_x', 'u_y', 'u_z'),
     (('compliance', 'm/N', 'isotropic compliance of the frame', 0.0, True),
      ('mass', 'kg', 'mass of the frame', 0.0, False))),
)

#: By which parameters the derivatives are taken: field of Parameters or Effects, and index in it.
SENSITIVITY_PARAMETERS = (
    ('platform_mass', ()),
    ('gravity', (0,)),
    ('gravity', (1,)),
    ('gravity', (2,)),
    ('joint', (0, 0)),
    ('joint', (0, 1)),
    ('joint', (0, 2)),
    ('joint', (1, 0)),
    ('joint', (1, 1)),
    ('joint', (1, 2)),
    ('joint', (2, 0)),
    ('joint', (2, 1)),
    ('joint', (2, 2)),
    ('link_length', (0,)),
    ('link_length', (1,)),
    ('link_length', (2,)),
    ('link_mass', (0,)),
    ('link_mass', (1,)),
    ('link_mass', (2,)),
    ('carriage_mass', (0,)),
    ('carriage_mass', (1,)),
    ('carriage_mass', (2,)),
    ('carriage_length', (0,)),
    ('carriage_length', (1,)),
    ('carriage_length', (2,)),
    ('belt_specific_stiffness', (0,)),
    ('belt_specific_stiffness', (1,)),
    ('belt_specific_stiffness', (2,)),
    ('belt_width', (0,)),
    ('belt_width', (1,)),
    ('belt_width', (2,)),
    ('pulley_radius', (0,)),
    ('pulley_radius', (1,)),
    ('pulley_radius', (2,)),
    ('pulley_inertia', (0,)),
    ('pulley_inertia', (1,)),
    ('pulley_inertia', (2,)),
    ('motor_inertia', (0,)),
    ('motor_inertia', (1,)),
    ('motor_inertia', (2,)),
    ('gear_ratio', (0,)),
    ('gear_ratio', (1,)),
    ('gear_ratio', (2,)),
    ('limits', (0, 0)),
    ('limits', (1, 0)),
    ('limits', (2, 0)),
    ('limits', (0, 1)),
    ('limits', (1, 1)),
    ('limits', (2, 1)),
    ('axis_belt_stiffness_factor_1', ()),
    ('axis_belt_stiffness_factor_2', ()),
    ('axis_belt_stiffness_factor_3', ()),
    ('belt_end_compliance_compliance', ()),
    ('belt_mass_linear_density', ()),
    ('cable_stiffness_stiffness', ()),
    ('gearbox_inertia_inertia', ()),
    ('payload_mass', ()),
    ('servo_stiffness_stiffness', ()),
    ('frame_compliance_mass', ()),
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

    In the order of SENSITIVITY_PARAMETERS; by a rail's origin, the opposite of those by its joint.

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
    M_theta : array, shape (..., 59, 21, 21) [unit of M by that of the parameter]
        dM/dtheta.
    K_theta : array, shape (..., 59, 21, 21) [unit of K by that of the parameter]
        dK/dtheta.

    Notes
    -----
    Implicit function theorem and chain rule; the carriages follow the parameter.
    15192 operations; 128038563 with every named value written out.
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
    t284 = (
        D_p_x_1_by_b_1_x*t271 + D_p_x_2_by_b_1_x*t273 + D_p_y_1_by_b_1_x*t276 + D_p_y_2_by_b_1_x*t278
        + D_p_z_1_by_b_1_x*t281 + D_p_z_2_by_b_1_x*t283
    )
    t285 = (1/6)*n_3_x
    t286 = D_p_x_3*t262
    t287 = m_d_3*t285 + t286
    t288 = (1/6)*n_3_y
    t289 = D_p_y_3*t262
    t290 = m_d_3*t288 + t289
    t291 = (1/6)*n_3_z
    t292 = D_p_z_3*t262
    t293 = m_d_3*t291 + t292
    t294 = (
        D_p_x_1_by_b_1_x*t287 + D_p_x_3_by_b_1_x*t273 + D_p_y_1_by_b_1_x*t290 + D_p_y_3_by_b_1_x*t278
        + D_p_z_1_by_b_1_x*t293 + D_p_z_3_by_b_1_x*t283
    )
    t295 = (1/6)*rho_b
    t296 = R_p_1*t295
    t297 = t296*x_1_by_b_1_x
    t298 = D_p_x_1_by_b_1_x*t262
    t299 = D_p_y_1_by_b_1_x*t262
    t300 = D_p_z_1_by_b_1_x*t262
    t301 = (
        D_delta_x_1*t298 + D_delta_x_1_by_b_1_x*t273 + D_delta_y_1*t299 + D_delta_y_1_by_b_1_x*t278
        + D_delta_z_1*t300 + D_delta_z_1_by_b_1_x*t283
    )
    t302 = (
        D_delta_x_2*t298 + D_delta_x_2_by_b_1_x*t273 + D_delta_y_2*t299 + D_delta_y_2_by_b_1_x*t278
        + D_delta_z_2*t300 + D_delta_z_2_by_b_1_x*t283
    )
    t303 = (
        D_delta_x_3*t298 + D_delta_x_3_by_b_1_x*t273 + D_delta_y_3*t299 + D_delta_y_3_by_b_1_x*t278
        + D_delta_z_3*t300 + D_delta_z_3_by_b_1_x*t283
    )
    t304 = D_p_x_1_by_b_1_x*t45
    t305 = D_p_y_1_by_b_1_x*t45
    t306 = D_p_z_1_by_b_1_x*t45
    t307 = n_2_x*t260 + 2*t270
    t308 = n_2_y*t260 + 2*t275
    t309 = n_2_z*t260 + 2*t280
    t310 = (
        D_p_x_2_by_b_1_x*t287 + D_p_x_3_by_b_1_x*t271 + D_p_y_2_by_b_1_x*t290 + D_p_y_3_by_b_1_x*t276
        + D_p_z_2_by_b_1_x*t293 + D_p_z_3_by_b_1_x*t281
    )
    t311 = D_p_x_2_by_b_1_x*t262
    t312 = D_p_y_2_by_b_1_x*t262
    t313 = D_p_z_2_by_b_1_x*t262
    t314 = (
        D_delta_x_1*t311 + D_delta_x_1_by_b_1_x*t271 + D_delta_y_1*t312 + D_delta_y_1_by_b_1_x*t276
        + D_delta_z_1*t313 + D_delta_z_1_by_b_1_x*t281
    )
    t315 = (
        D_delta_x_2*t311 + D_delta_x_2_by_b_1_x*t271 + D_delta_y_2*t312 + D_delta_y_2_by_b_1_x*t276
        + D_delta_z_2*t313 + D_delta_z_2_by_b_1_x*t281
    )
    t316 = (
        D_delta_x_3*t311 + D_delta_x_3_by_b_1_x*t271 + D_delta_y_3*t312 + D_delta_y_3_by_b_1_x*t276
        + D_delta_z_3*t313 + D_delta_z_3_by_b_1_x*t281
    )
    t317 = D_p_x_2_by_b_1_x*t45
    t318 = D_p_y_2_by_b_1_x*t45
    t319 = D_p_z_2_by_b_1_x*t45
    t320 = n_3_x*t261 + 2*t286
    t321 = n_3_y*t261 + 2*t289
    t322 = n_3_z*t261 + 2*t292
    t323 = D_p_x_3_by_b_1_x*t262
    t324 = D_p_y_3_by_b_1_x*t262
    t325 = D_p_z_3_by_b_1_x*t262
    t326 = (
        D_delta_x_1*t323 + D_delta_x_1_by_b_1_x*t287 + D_delta_y_1*t324 + D_delta_y_1_by_b_1_x*t290
        + D_delta_z_1*t325 + D_delta_z_1_by_b_1_x*t293
    )
    t327 = (
        D_delta_x_2*t323 + D_delta_x_2_by_b_1_x*t287 + D_delta_y_2*t324 + D_delta_y_2_by_b_1_x*t290
        + D_delta_z_2*t325 + D_delta_z_2_by_b_1_x*t293
    )
    t328 = (
        D_delta_x_3*t323 + D_delta_x_3_by_b_1_x*t287 + D_delta_y_3*t324 + D_delta_y_3_by_b_1_x*t290
        + D_delta_z_3*t325 + D_delta_z_3_by_b_1_x*t293
    )
    t329 = D_p_x_3_by_b_1_x*t45
    t330 = D_p_y_3_by_b_1_x*t45
    t331 = D_p_z_3_by_b_1_x*t45
    t332 = R_p_1**2
    t333 = (1/3)*rho_b
    t334 = t332*t333
    t335 = t334*x_1_by_b_1_x
    t336 = D_delta_x_1*t262
    t337 = 2*t336
    t338 = D_delta_y_1*t262
    t339 = 2*t338
    t340 = D_delta_z_1*t262
    t341 = 2*t340
    t342 = D_delta_x_1_by_b_1_x*t262
    t343 = D_delta_y_1_by_b_1_x*t262
    t344 = D_delta_z_1_by_b_1_x*t262
    t345 = (
        D_delta_x_2*t342 + D_delta_x_2_by_b_1_x*t336 + D_delta_y_2*t343 + D_delta_y_2_by_b_1_x*t338
        + D_delta_z_2*t344 + D_delta_z_2_by_b_1_x*t340
    )
    t346 = (
        D_delta_x_3*t342 + D_delta_x_3_by_b_1_x*t336 + D_delta_y_3*t343 + D_delta_y_3_by_b_1_x*t338
        + D_delta_z_3*t344 + D_delta_z_3_by_b_1_x*t340
    )
    t347 = D_delta_x_1_by_b_1_x*t45
    t348 = D_delta_y_1_by_b_1_x*t45
    t349 = D_delta_z_1_by_b_1_x*t45
    t350 = D_delta_x_2*t262
    t351 = 2*t350
    t352 = D_delta_y_2*t262
    t353 = 2*t352
    t354 = D_delta_z_2*t262
    t355 = 2*t354
    t356 = D_delta_x_3*t262
    t357 = D_delta_y_3*t262
    t358 = D_delta_z_3*t262
    t359 = (
        D_delta_x_2_by_b_1_x*t356 + D_delta_x_3_by_b_1_x*t350 + D_delta_y_2_by_b_1_x*t357
        + D_delta_y_3_by_b_1_x*t352 + D_delta_z_2_by_b_1_x*t358 + D_delta_z_3_by_b_1_x*t354
    )
    t360 = D_delta_x_2_by_b_1_x*t45
    t361 = D_delta_y_2_by_b_1_x*t45
    t362 = D_delta_z_2_by_b_1_x*t45
    t363 = 2*t356
    t364 = 2*t357
    t365 = 2*t358
    t366 = D_delta_x_3_by_b_1_x*t45
    t367 = D_delta_y_3_by_b_1_x*t45
    t368 = D_delta_z_3_by_b_1_x*t45
    t369 = (
        D_p_x_1_by_b_1_y*t271 + D_p_x_2_by_b_1_y*t273 + D_p_y_1_by_b_1_y*t276 + D_p_y_2_by_b_1_y*t278
        + D_p_z_1_by_b_1_y*t281 + D_p_z_2_by_b_1_y*t283
    )
    t370 = (
        D_p_x_1_by_b_1_y*t287 + D_p_x_3_by_b_1_y*t273 + D_p_y_1_by_b_1_y*t290 + D_p_y_3_by_b_1_y*t278
        + D_p_z_1_by_b_1_y*t293 + D_p_z_3_by_b_1_y*t283
    )
    t371 = t296*x_1_by_b_1_y
    t372 = (
        D_delta_x_1_by_b_1_y*t273 + D_delta_y_1_by_b_1_y*t278 + D_delta_z_1_by_b_1_y*t283
        + D_p_x_1_by_b_1_y*t336 + D_p_y_1_by_b_1_y*t338 + D_p_z_1_by_b_1_y*t340
    )
    t373 = (
        D_delta_x_2_by_b_1_y*t273 + D_delta_y_2_by_b_1_y*t278 + D_delta_z_2_by_b_1_y*t283
        + D_p_x_1_by_b_1_y*t350 + D_p_y_1_by_b_1_y*t352 + D_p_z_1_by_b_1_y*t354
    )
    t374 = (
        D_delta_x_3_by_b_1_y*t273 + D_delta_y_3_by_b_1_y*t278 + D_delta_z_3_by_b_1_y*t283
        + D_p_x_1_by_b_1_y*t356 + D_p_y_1_by_b_1_y*t357 + D_p_z_1_by_b_1_y*t358
    )
    t375 = D_p_x_1_by_b_1_y*t45
    t376 = D_p_y_1_by_b_1_y*t45
    t377 = D_p_z_1_by_b_1_y*t45
    t378 = (
        D_p_x_2_by_b_1_y*t287 + D_p_x_3_by_b_1_y*t271 + D_p_y_2_by_b_1_y*t290 + D_p_y_3_by_b_1_y*t276
        + D_p_z_2_by_b_1_y*t293 + D_p_z_3_by_b_1_y*t281
    )
    t379 = (
        D_delta_x_1_by_b_1_y*t271 + D_delta_y_1_by_b_1_y*t276 + D_delta_z_1_by_b_1_y*t281
        + D_p_x_2_by_b_1_y*t336 + D_p_y_2_by_b_1_y*t338 + D_p_z_2_by_b_1_y*t340
    )
    t380 = (
        D_delta_x_2_by_b_1_y*t271 + D_delta_y_2_by_b_1_y*t276 + D_delta_z_2_by_b_1_y*t281
        + D_p_x_2_by_b_1_y*t350 + D_p_y_2_by_b_1_y*t352 + D_p_z_2_by_b_1_y*t354
    )
    t381 = (
        D_delta_x_3_by_b_1_y*t271 + D_delta_y_3_by_b_1_y*t276 + D_delta_z_3_by_b_1_y*t281
        + D_p_x_2_by_b_1_y*t356 + D_p_y_2_by_b_1_y*t357 + D_p_z_2_by_b_1_y*t358
    )
    t382 = D_p_x_2_by_b_1_y*t45
    t383 = D_p_y_2_by_b_1_y*t45
    t384 = D_p_z_2_by_b_1_y*t45
    t385 = (
        D_delta_x_1_by_b_1_y*t287 + D_delta_y_1_by_b_1_y*t290 + D_delta_z_1_by_b_1_y*t293
        + D_p_x_3_by_b_1_y*t336 + D_p_y_3_by_b_1_y*t338 + D_p_z_3_by_b_1_y*t340
    )
    t386 = (
        D_delta_x_2_by_b_1_y*t287 + D_delta_y_2_by_b_1_y*t290 + D_delta_z_2_by_b_1_y*t293
        + D_p_x_3_by_b_1_y*t350 + D_p_y_3_by_b_1_y*t352 + D_p_z_3_by_b_1_y*t354
    )
    t387 = (
        D_delta_x_3_by_b_1_y*t287 + D_delta_y_3_by_b_1_y*t290 + D_delta_z_3_by_b_1_y*t293
        + D_p_x_3_by_b_1_y*t356 + D_p_y_3_by_b_1_y*t357 + D_p_z_3_by_b_1_y*t358
    )
    t388 = D_p_x_3_by_b_1_y*t45
    t389 = D_p_y_3_by_b_1_y*t45
    t390 = D_p_z_3_by_b_1_y*t45
    t391 = t334*x_1_by_b_1_y
    t392 = (
        D_delta_x_1_by_b_1_y*t350 + D_delta_x_2_by_b_1_y*t336 + D_delta_y_1_by_b_1_y*t352
        + D_delta_y_2_by_b_1_y*t338 + D_delta_z_1_by_b_1_y*t354 + D_delta_z_2_by_b_1_y*t340
    )
    t393 = (
        D_delta_x_1_by_b_1_y*t356 + D_delta_x_3_by_b_1_y*t336 + D_delta_y_1_by_b_1_y*t357
        + D_delta_y_3_by_b_1_y*t338 + D_delta_z_1_by_b_1_y*t358 + D_delta_z_3_by_b_1_y*t340
    )
    t394 = D_delta_x_1_by_b_1_y*t45
    t395 = D_delta_y_1_by_b_1_y*t45
    t396 = D_delta_z_1_by_b_1_y*t45
    t397 = (
        D_delta_x_2_by_b_1_y*t356 + D_delta_x_3_by_b_1_y*t350 + D_delta_y_2_by_b_1_y*t357
        + D_delta_y_3_by_b_1_y*t352 + D_delta_z_2_by_b_1_y*t358 + D_delta_z_3_by_b_1_y*t354
    )
    t398 = D_delta_x_2_by_b_1_y*t45
    t399 = D_delta_y_2_by_b_1_y*t45
    t400 = D_delta_z_2_by_b_1_y*t45
    t401 = D_delta_x_3_by_b_1_y*t45
    t402 = D_delta_y_3_by_b_1_y*t45
    t403 = D_delta_z_3_by_b_1_y*t45
    t404 = (
        D_p_x_1_by_b_1_z*t271 + D_p_x_2_by_b_1_z*t273 + D_p_y_1_by_b_1_z*t276 + D_p_y_2_by_b_1_z*t278
        + D_p_z_1_by_b_1_z*t281 + D_p_z_2_by_b_1_z*t283
    )
    t405 = (
        D_p_x_1_by_b_1_z*t287 + D_p_x_3_by_b_1_z*t273 + D_p_y_1_by_b_1_z*t290 + D_p_y_3_by_b_1_z*t278
        + D_p_z_1_by_b_1_z*t293 + D_p_z_3_by_b_1_z*t283
    )
    t406 = t296*x_1_by_b_1_z
    t407 = (
        D_delta_x_1_by_b_1_z*t273 + D_delta_y_1_by_b_1_z*t278 + D_delta_z_1_by_b_1_z*t283
        + D_p_x_1_by_b_1_z*t336 + D_p_y_1_by_b_1_z*t338 + D_p_z_1_by_b_1_z*t340
    )
    t408 = (
        D_delta_x_2_by_b_1_z*t273 + D_delta_y_2_by_b_1_z*t278 + D_delta_z_2_by_b_1_z*t283
        + D_p_x_1_by_b_1_z*t350 + D_p_y_1_by_b_1_z*t352 + D_p_z_1_by_b_1_z*t354
    )
    t409 = (
        D_delta_x_3_by_b_1_z*t273 + D_delta_y_3_by_b_1_z*t278 + D_delta_z_3_by_b_1_z*t283
        + D_p_x_1_by_b_1_z*t356 + D_p_y_1_by_b_1_z*t357 + D_p_z_1_by_b_1_z*t358
    )
    t410 = D_p_x_1_by_b_1_z*t45
    t411 = D_p_y_1_by_b_1_z*t45
    t412 = D_p_z_1_by_b_1_z*t45
    t413 = (
        D_p_x_2_by_b_1_z*t287 + D_p_x_3_by_b_1_z*t271 + D_p_y_2_by_b_1_z*t290 + D_p_y_3_by_b_1_z*t276
        + D_p_z_2_by_b_1_z*t293 + D_p_z_3_by_b_1_z*t281
    )
    t414 = (
        D_delta_x_1_by_b_1_z*t271 + D_delta_y_1_by_b_1_z*t276 + D_delta_z_1_by_b_1_z*t281
        + D_p_x_2_by_b_1_z*t336 + D_p_y_2_by_b_1_z*t338 + D_p_z_2_by_b_1_z*t340
    )
    t415 = (
        D_delta_x_2_by_b_1_z*t271 + D_delta_y_2_by_b_1_z*t276 + D_delta_z_2_by_b_1_z*t281
        + D_p_x_2_by_b_1_z*t350 + D_p_y_2_by_b_1_z*t352 + D_p_z_2_by_b_1_z*t354
    )
    t416 = (
        D_delta_x_3_by_b_1_z*t271 + D_delta_y_3_by_b_1_z*t276 + D_delta_z_3_by_b_1_z*t281
        + D_p_x_2_by_b_1_z*t356 + D_p_y_2_by_b_1_z*t357 + D_p_z_2_by_b_1_z*t358
    )
    t417 = D_p_x_2_by_b_1_z*t45
    t418 = D_p_y_2_by_b_1_z*t45
    t419 = D_p_z_2_by_b_1_z*t45
    t420 = (
        D_delta_x_1_by_b_1_z*t287 + D_delta_y_1_by_b_1_z*t290 + D_delta_z_1_by_b_1_z*t293
        + D_p_x_3_by_b_1_z*t336 + D_p_y_3_by_b_1_z*t338 + D_p_z_3_by_b_1_z*t340
    )
    t421 = (
        D_delta_x_2_by_b_1_z*t287 + D_delta_y_2_by_b_1_z*t290 + D_delta_z_2_by_b_1_z*t293
        + D_p_x_3_by_b_1_z*t350 + D_p_y_3_by_b_1_z*t352 + D_p_z_3_by_b_1_z*t354
    )
    t422 = (
        D_delta_x_3_by_b_1_z*t287 + D_delta_y_3_by_b_1_z*t290 + D_delta_z_3_by_b_1_z*t293
        + D_p_x_3_by_b_1_z*t356 + D_p_y_3_by_b_1_z*t357 + D_p_z_3_by_b_1_z*t358
    )
    t423 = D_p_x_3_by_b_1_z*t45
    t424 = D_p_y_3_by_b_1_z*t45
    t425 = D_p_z_3_by_b_1_z*t45
    t426 = t334*x_1_by_b_1_z
    t427 = (
        D_delta_x_1_by_b_1_z*t350 + D_delta_x_2_by_b_1_z*t336 + D_delta_y_1_by_b_1_z*t352
        + D_delta_y_2_by_b_1_z*t338 + D_delta_z_1_by_b_1_z*t354 + D_delta_z_2_by_b_1_z*t340
    )
    t428 = (
        D_delta_x_1_by_b_1_z*t356 + D_delta_x_3_by_b_1_z*t336 + D_delta_y_1_by_b_1_z*t357
        + D_delta_y_3_by_b_1_z*t338 + D_delta_z_1_by_b_1_z*t358 + D_delta_z_3_by_b_1_z*t340
    )
    t429 = D_delta_x_1_by_b_1_z*t45
    t430 = D_delta_y_1_by_b_1_z*t45
    t431 = D_delta_z_1_by_b_1_z*t45
    t432 = (
        D_delta_x_2_by_b_1_z*t356 + D_delta_x_3_by_b_1_z*t350 + D_delta_y_2_by_b_1_z*t357
        + D_delta_y_3_by_b_1_z*t352 + D_delta_z_2_by_b_1_z*t358 + D_delta_z_3_by_b_1_z*t354
    )
    t433 = D_delta_x_2_by_b_1_z*t45
    t434 = D_delta_y_2_by_b_1_z*t45
    t435 = D_delta_z_2_by_b_1_z*t45
    t436 = D_delta_x_3_by_b_1_z*t45
    t437 = D_delta_y_3_by_b_1_z*t45
    t438 = D_delta_z_3_by_b_1_z*t45
    t439 = (
        D_p_x_1_by_b_2_x*t271 + D_p_x_2_by_b_2_x*t273 + D_p_y_1_by_b_2_x*t276 + D_p_y_2_by_b_2_x*t278
        + D_p_z_1_by_b_2_x*t281 + D_p_z_2_by_b_2_x*t283
    )
    t440 = (
        D_p_x_1_by_b_2_x*t287 + D_p_x_3_by_b_2_x*t273 + D_p_y_1_by_b_2_x*t290 + D_p_y_3_by_b_2_x*t278
        + D_p_z_1_by_b_2_x*t293 + D_p_z_3_by_b_2_x*t283
    )
    t441 = (
        D_delta_x_1_by_b_2_x*t273 + D_delta_y_1_by_b_2_x*t278 + D_delta_z_1_by_b_2_x*t283
        + D_p_x_1_by_b_2_x*t336 + D_p_y_1_by_b_2_x*t338 + D_p_z_1_by_b_2_x*t340
    )
    t442 = (
        D_delta_x_2_by_b_2_x*t273 + D_delta_y_2_by_b_2_x*t278 + D_delta_z_2_by_b_2_x*t283
        + D_p_x_1_by_b_2_x*t350 + D_p_y_1_by_b_2_x*t352 + D_p_z_1_by_b_2_x*t354
    )
    t443 = (
        D_delta_x_3_by_b_2_x*t273 + D_delta_y_3_by_b_2_x*t278 + D_delta_z_3_by_b_2_x*t283
        + D_p_x_1_by_b_2_x*t356 + D_p_y_1_by_b_2_x*t357 + D_p_z_1_by_b_2_x*t358
    )
    t444 = D_p_x_1_by_b_2_x*t45
    t445 = D_p_y_1_by_b_2_x*t45
    t446 = D_p_z_1_by_b_2_x*t45
    t447 = (
        D_p_x_2_by_b_2_x*t287 + D_p_x_3_by_b_2_x*t271 + D_p_y_2_by_b_2_x*t290 + D_p_y_3_by_b_2_x*t276
        + D_p_z_2_by_b_2_x*t293 + D_p_z_3_by_b_2_x*t281
    )
    t448 = R_p_2*t295
    t449 = t448*x_2_by_b_2_x
    t450 = (
        D_delta_x_1_by_b_2_x*t271 + D_delta_y_1_by_b_2_x*t276 + D_delta_z_1_by_b_2_x*t281
        + D_p_x_2_by_b_2_x*t336 + D_p_y_2_by_b_2_x*t338 + D_p_z_2_by_b_2_x*t340
    )
    t451 = (
        D_delta_x_2_by_b_2_x*t271 + D_delta_y_2_by_b_2_x*t276 + D_delta_z_2_by_b_2_x*t281
        + D_p_x_2_by_b_2_x*t350 + D_p_y_2_by_b_2_x*t352 + D_p_z_2_by_b_2_x*t354
    )
    t452 = (
        D_delta_x_3_by_b_2_x*t271 + D_delta_y_3_by_b_2_x*t276 + D_delta_z_3_by_b_2_x*t281
        + D_p_x_2_by_b_2_x*t356 + D_p_y_2_by_b_2_x*t357 + D_p_z_2_by_b_2_x*t358
    )
    t453 = D_p_x_2_by_b_2_x*t45
    t454 = D_p_y_2_by_b_2_x*t45
    t455 = D_p_z_2_by_b_2_x*t45
    t456 = (
        D_delta_x_1_by_b_2_x*t287 + D_delta_y_1_by_b_2_x*t290 + D_delta_z_1_by_b_2_x*t293
        + D_p_x_3_by_b_2_x*t336 + D_p_y_3_by_b_2_x*t338 + D_p_z_3_by_b_2_x*t340
    )
    t457 = (
        D_delta_x_2_by_b_2_x*t287 + D_delta_y_2_by_b_2_x*t290 + D_delta_z_2_by_b_2_x*t293
        + D_p_x_3_by_b_2_x*t350 + D_p_y_3_by_b_2_x*t352 + D_p_z_3_by_b_2_x*t354
    )
    t458 = (
        D_delta_x_3_by_b_2_x*t287 + D_delta_y_3_by_b_2_x*t290 + D_delta_z_3_by_b_2_x*t293
        + D_p_x_3_by_b_2_x*t356 + D_p_y_3_by_b_2_x*t357 + D_p_z_3_by_b_2_x*t358
    )
    t459 = D_p_x_3_by_b_2_x*t45
    t460 = D_p_y_3_by_b_2_x*t45
    t461 = D_p_z_3_by_b_2_x*t45
    t462 = R_p_2**2
    t463 = t333*t462
    t464 = t463*x_2_by_b_2_x
    t465 = (
        D_delta_x_1_by_b_2_x*t350 + D_delta_x_2_by_b_2_x*t336 + D_delta_y_1_by_b_2_x*t352
        + D_delta_y_2_by_b_2_x*t338 + D_delta_z_1_by_b_2_x*t354 + D_delta_z_2_by_b_2_x*t340
    )
    t466 = (
        D_delta_x_1_by_b_2_x*t356 + D_delta_x_3_by_b_2_x*t336 + D_delta_y_1_by_b_2_x*t357
        + D_delta_y_3_by_b_2_x*t338 + D_delta_z_1_by_b_2_x*t358 + D_delta_z_3_by_b_2_x*t340
    )
    t467 = D_delta_x_1_by_b_2_x*t45
    t468 = D_delta_y_1_by_b_2_x*t45
    t469 = D_delta_z_1_by_b_2_x*t45
    t470 = (
        D_delta_x_2_by_b_2_x*t356 + D_delta_x_3_by_b_2_x*t350 + D_delta_y_2_by_b_2_x*t357
        + D_delta_y_3_by_b_2_x*t352 + D_delta_z_2_by_b_2_x*t358 + D_delta_z_3_by_b_2_x*t354
    )
    t471 = D_delta_x_2_by_b_2_x*t45
    t472 = D_delta_y_2_by_b_2_x*t45
    t473 = D_delta_z_2_by_b_2_x*t45
    t474 = D_delta_x_3_by_b_2_x*t45
    t475 = D_delta_y_3_by_b_2_x*t45
    t476 = D_delta_z_3_by_b_2_x*t45
    t477 = (
        D_p_x_1_by_b_2_y*t271 + D_p_x_2_by_b_2_y*t273 + D_p_y_1_by_b_2_y*t276 + D_p_y_2_by_b_2_y*t278
        + D_p_z_1_by_b_2_y*t281 + D_p_z_2_by_b_2_y*t283
    )
    t478 = (
        D_p_x_1_by_b_2_y*t287 + D_p_x_3_by_b_2_y*t273 + D_p_y_1_by_b_2_y*t290 + D_p_y_3_by_b_2_y*t278
        + D_p_z_1_by_b_2_y*t293 + D_p_z_3_by_b_2_y*t283
    )
    t479 = (
        D_delta_x_1_by_b_2_y*t273 + D_delta_y_1_by_b_2_y*t278 + D_delta_z_1_by_b_2_y*t283
        + D_p_x_1_by_b_2_y*t336 + D_p_y_1_by_b_2_y*t338 + D_p_z_1_by_b_2_y*t340
    )
    t480 = (
        D_delta_x_2_by_b_2_y*t273 + D_delta_y_2_by_b_2_y*t278 + D_delta_z_2_by_b_2_y*t283
        + D_p_x_1_by_b_2_y*t350 + D_p_y_1_by_b_2_y*t352 + D_p_z_1_by_b_2_y*t354
    )
    t481 = (
        D_delta_x_3_by_b_2_y*t273 + D_delta_y_3_by_b_2_y*t278 + D_delta_z_3_by_b_2_y*t283
        + D_p_x_1_by_b_2_y*t356 + D_p_y_1_by_b_2_y*t357 + D_p_z_1_by_b_2_y*t358
    )
    t482 = D_p_x_1_by_b_2_y*t45
    t483 = D_p_y_1_by_b_2_y*t45
    t484 = D_p_z_1_by_b_2_y*t45
    t485 = (
        D_p_x_2_by_b_2_y*t287 + D_p_x_3_by_b_2_y*t271 + D_p_y_2_by_b_2_y*t290 + D_p_y_3_by_b_2_y*t276
        + D_p_z_2_by_b_2_y*t293 + D_p_z_3_by_b_2_y*t281
    )
    t486 = t448*x_2_by_b_2_y
    t487 = (
        D_delta_x_1_by_b_2_y*t271 + D_delta_y_1_by_b_2_y*t276 + D_delta_z_1_by_b_2_y*t281
        + D_p_x_2_by_b_2_y*t336 + D_p_y_2_by_b_2_y*t338 + D_p_z_2_by_b_2_y*t340
    )
    t488 = (
        D_delta_x_2_by_b_2_y*t271 + D_delta_y_2_by_b_2_y*t276 + D_delta_z_2_by_b_2_y*t281
        + D_p_x_2_by_b_2_y*t350 + D_p_y_2_by_b_2_y*t352 + D_p_z_2_by_b_2_y*t354
    )
    t489 = (
        D_delta_x_3_by_b_2_y*t271 + D_delta_y_3_by_b_2_y*t276 + D_delta_z_3_by_b_2_y*t281
        + D_p_x_2_by_b_2_y*t356 + D_p_y_2_by_b_2_y*t357 + D_p_z_2_by_b_2_y*t358
    )
    t490 = D_p_x_2_by_b_2_y*t45
    t491 = D_p_y_2_by_b_2_y*t45
    t492 = D_p_z_2_by_b_2_y*t45
    t493 = (
        D_delta_x_1_by_b_2_y*t287 + D_delta_y_1_by_b_2_y*t290 + D_delta_z_1_by_b_2_y*t293
        + D_p_x_3_by_b_2_y*t336 + D_p_y_3_by_b_2_y*t338 + D_p_z_3_by_b_2_y*t340
    )
    t494 = (
        D_delta_x_2_by_b_2_y*t287 + D_delta_y_2_by_b_2_y*t290 + D_delta_z_2_by_b_2_y*t293
        + D_p_x_3_by_b_2_y*t350 + D_p_y_3_by_b_2_y*t352 + D_p_z_3_by_b_2_y*t354
    )
    t495 = (
        D_delta_x_3_by_b_2_y*t287 + D_delta_y_3_by_b_2_y*t290 + D_delta_z_3_by_b_2_y*t293
        + D_p_x_3_by_b_2_y*t356 + D_p_y_3_by_b_2_y*t357 + D_p_z_3_by_b_2_y*t358
    )
    t496 = D_p_x_3_by_b_2_y*t45
    t497 = D_p_y_3_by_b_2_y*t45
    t498 = D_p_z_3_by_b_2_y*t45
    t499 = t463*x_2_by_b_2_y
    t500 = (
        D_delta_x_1_by_b_2_y*t350 + D_delta_x_2_by_b_2_y*t336 + D_delta_y_1_by_b_2_y*t352
        + D_delta_y_2_by_b_2_y*t338 + D_delta_z_1_by_b_2_y*t354 + D_delta_z_2_by_b_2_y*t340
    )
    t501 = (
        D_delta_x_1_by_b_2_y*t356 + D_delta_x_3_by_b_2_y*t336 + D_delta_y_1_by_b_2_y*t357
        + D_delta_y_3_by_b_2_y*t338 + D_delta_z_1_by_b_2_y*t358 + D_delta_z_3_by_b_2_y*t340
    )
    t502 = D_delta_x_1_by_b_2_y*t45
    t503 = D_delta_y_1_by_b_2_y*t45
    t504 = D_delta_z_1_by_b_2_y*t45
    t505 = (
        D_delta_x_2_by_b_2_y*t356 + D_delta_x_3_by_b_2_y*t350 + D_delta_y_2_by_b_2_y*t357
        + D_delta_y_3_by_b_2_y*t352 + D_delta_z_2_by_b_2_y*t358 + D_delta_z_3_by_b_2_y*t354
    )
    t506 = D_delta_x_2_by_b_2_y*t45
    t507 = D_delta_y_2_by_b_2_y*t45
    t508 = D_delta_z_2_by_b_2_y*t45
    t509 = D_delta_x_3_by_b_2_y*t45
    t510 = D_delta_y_3_by_b_2_y*t45
    t511 = D_delta_z_3_by_b_2_y*t45
    t512 = (
        D_p_x_1_by_b_2_z*t271 + D_p_x_2_by_b_2_z*t273 + D_p_y_1_by_b_2_z*t276 + D_p_y_2_by_b_2_z*t278
        + D_p_z_1_by_b_2_z*t281 + D_p_z_2_by_b_2_z*t283
    )
    t513 = (
        D_p_x_1_by_b_2_z*t287 + D_p_x_3_by_b_2_z*t273 + D_p_y_1_by_b_2_z*t290 + D_p_y_3_by_b_2_z*t278
        + D_p_z_1_by_b_2_z*t293 + D_p_z_3_by_b_2_z*t283
    )
    t514 = (
        D_delta_x_1_by_b_2_z*t273 + D_delta_y_1_by_b_2_z*t278 + D_delta_z_1_by_b_2_z*t283
        + D_p_x_1_by_b_2_z*t336 + D_p_y_1_by_b_2_z*t338 + D_p_z_1_by_b_2_z*t340
    )
    t515 = (
        D_delta_x_2_by_b_2_z*t273 + D_delta_y_2_by_b_2_z*t278 + D_delta_z_2_by_b_2_z*t283
        + D_p_x_1_by_b_2_z*t350 + D_p_y_1_by_b_2_z*t352 + D_p_z_1_by_b_2_z*t354
    )
    t516 = (
        D_delta_x_3_by_b_2_z*t273 + D_delta_y_3_by_b_2_z*t278 + D_delta_z_3_by_b_2_z*t283
        + D_p_x_1_by_b_2_z*t356 + D_p_y_1_by_b_2_z*t357 + D_p_z_1_by_b_2_z*t358
    )
    t517 = D_p_x_1_by_b_2_z*t45
    t518 = D_p_y_1_by_b_2_z*t45
    t519 = D_p_z_1_by_b_2_z*t45
    t520 = (
        D_p_x_2_by_b_2_z*t287 + D_p_x_3_by_b_2_z*t271 + D_p_y_2_by_b_2_z*t290 + D_p_y_3_by_b_2_z*t276
        + D_p_z_2_by_b_2_z*t293 + D_p_z_3_by_b_2_z*t281
    )
    t521 = t448*x_2_by_b_2_z
    t522 = (
        D_delta_x_1_by_b_2_z*t271 + D_delta_y_1_by_b_2_z*t276 + D_delta_z_1_by_b_2_z*t281
        + D_p_x_2_by_b_2_z*t336 + D_p_y_2_by_b_2_z*t338 + D_p_z_2_by_b_2_z*t340
    )
    t523 = (
        D_delta_x_2_by_b_2_z*t271 + D_delta_y_2_by_b_2_z*t276 + D_delta_z_2_by_b_2_z*t281
        + D_p_x_2_by_b_2_z*t350 + D_p_y_2_by_b_2_z*t352 + D_p_z_2_by_b_2_z*t354
    )
    t524 = (
        D_delta_x_3_by_b_2_z*t271 + D_delta_y_3_by_b_2_z*t276 + D_delta_z_3_by_b_2_z*t281
        + D_p_x_2_by_b_2_z*t356 + D_p_y_2_by_b_2_z*t357 + D_p_z_2_by_b_2_z*t358
    )
    t525 = D_p_x_2_by_b_2_z*t45
    t526 = D_p_y_2_by_b_2_z*t45
    t527 = D_p_z_2_by_b_2_z*t45
    t528 = (
        D_delta_x_1_by_b_2_z*t287 + D_delta_y_1_by_b_2_z*t290 + D_delta_z_1_by_b_2_z*t293
        + D_p_x_3_by_b_2_z*t336 + D_p_y_3_by_b_2_z*t338 + D_p_z_3_by_b_2_z*t340
    )
    t529 = (
        D_delta_x_2_by_b_2_z*t287 + D_delta_y_2_by_b_2_z*t290 + D_delta_z_2_by_b_2_z*t293
        + D_p_x_3_by_b_2_z*t350 + D_p_y_3_by_b_2_z*t352 + D_p_z_3_by_b_2_z*t354
    )
    t530 = (
        D_delta_x_3_by_b_2_z*t287 + D_delta_y_3_by_b_2_z*t290 + D_delta_z_3_by_b_2_z*t293
        + D_p_x_3_by_b_2_z*t356 + D_p_y_3_by_b_2_z*t357 + D_p_z_3_by_b_2_z*t358
    )
    t531 = D_p_x_3_by_b_2_z*t45
    t532 = D_p_y_3_by_b_2_z*t45
    t533 = D_p_z_3_by_b_2_z*t45
    t534 = t463*x_2_by_b_2_z
    t535 = (
        D_delta_x_1_by_b_2_z*t350 + D_delta_x_2_by_b_2_z*t336 + D_delta_y_1_by_b_2_z*t352
        + D_delta_y_2_by_b_2_z*t338 + D_delta_z_1_by_b_2_z*t354 + D_delta_z_2_by_b_2_z*t340
    )
    t536 = (
        D_delta_x_1_by_b_2_z*t356 + D_delta_x_3_by_b_2_z*t336 + D_delta_y_1_by_b_2_z*t357
        + D_delta_y_3_by_b_2_z*t338 + D_delta_z_1_by_b_2_z*t358 + D_delta_z_3_by_b_2_z*t340
    )
    t537 = D_delta_x_1_by_b_2_z*t45
    t538 = D_delta_y_1_by_b_2_z*t45
    t539 = D_delta_z_1_by_b_2_z*t45
    t540 = (
        D_delta_x_2_by_b_2_z*t356 + D_delta_x_3_by_b_2_z*t350 + D_delta_y_2_by_b_2_z*t357
        + D_delta_y_3_by_b_2_z*t352 + D_delta_z_2_by_b_2_z*t358 + D_delta_z_3_by_b_2_z*t354
    )
    t541 = D_delta_x_2_by_b_2_z*t45
    t542 = D_delta_y_2_by_b_2_z*t45
    t543 = D_delta_z_2_by_b_2_z*t45
    t544 = D_delta_x_3_by_b_2_z*t45
    t545 = D_delta_y_3_by_b_2_z*t45
    t546 = D_delta_z_3_by_b_2_z*t45
    t547 = (
        D_p_x_1_by_b_3_x*t271 + D_p_x_2_by_b_3_x*t273 + D_p_y_1_by_b_3_x*t276 + D_p_y_2_by_b_3_x*t278
        + D_p_z_1_by_b_3_x*t281 + D_p_z_2_by_b_3_x*t283
    )
    t548 = (
        D_p_x_1_by_b_3_x*t287 + D_p_x_3_by_b_3_x*t273 + D_p_y_1_by_b_3_x*t290 + D_p_y_3_by_b_3_x*t278
        + D_p_z_1_by_b_3_x*t293 + D_p_z_3_by_b_3_x*t283
    )
    t549 = (
        D_delta_x_1_by_b_3_x*t273 + D_delta_y_1_by_b_3_x*t278 + D_delta_z_1_by_b_3_x*t283
        + D_p_x_1_by_b_3_x*t336 + D_p_y_1_by_b_3_x*t338 + D_p_z_1_by_b_3_x*t340
    )
    t550 = (
        D_delta_x_2_by_b_3_x*t273 + D_delta_y_2_by_b_3_x*t278 + D_delta_z_2_by_b_3_x*t283
        + D_p_x_1_by_b_3_x*t350 + D_p_y_1_by_b_3_x*t352 + D_p_z_1_by_b_3_x*t354
    )
    t551 = (
        D_delta_x_3_by_b_3_x*t273 + D_delta_y_3_by_b_3_x*t278 + D_delta_z_3_by_b_3_x*t283
        + D_p_x_1_by_b_3_x*t356 + D_p_y_1_by_b_3_x*t357 + D_p_z_1_by_b_3_x*t358
    )
    t552 = D_p_x_1_by_b_3_x*t45
    t553 = D_p_y_1_by_b_3_x*t45
    t554 = D_p_z_1_by_b_3_x*t45
    t555 = (
        D_p_x_2_by_b_3_x*t287 + D_p_x_3_by_b_3_x*t271 + D_p_y_2_by_b_3_x*t290 + D_p_y_3_by_b_3_x*t276
        + D_p_z_2_by_b_3_x*t293 + D_p_z_3_by_b_3_x*t281
    )
    t556 = (
        D_delta_x_1_by_b_3_x*t271 + D_delta_y_1_by_b_3_x*t276 + D_delta_z_1_by_b_3_x*t281
        + D_p_x_2_by_b_3_x*t336 + D_p_y_2_by_b_3_x*t338 + D_p_z_2_by_b_3_x*t340
    )
    t557 = (
        D_delta_x_2_by_b_3_x*t271 + D_delta_y_2_by_b_3_x*t276 + D_delta_z_2_by_b_3_x*t281
        + D_p_x_2_by_b_3_x*t350 + D_p_y_2_by_b_3_x*t352 + D_p_z_2_by_b_3_x*t354
    )
    t558 = (
        D_delta_x_3_by_b_3_x*t271 + D_delta_y_3_by_b_3_x*t276 + D_delta_z_3_by_b_3_x*t281
        + D_p_x_2_by_b_3_x*t356 + D_p_y_2_by_b_3_x*t357 + D_p_z_2_by_b_3_x*t358
    )
    t559 = D_p_x_2_by_b_3_x*t45
    t560 = D_p_y_2_by_b_3_x*t45
    t561 = D_p_z_2_by_b_3_x*t45
    t562 = R_p_3*t295
    t563 = t562*x_3_by_b_3_x
    t564 = (
        D_delta_x_1_by_b_3_x*t287 + D_delta_y_1_by_b_3_x*t290 + D_delta_z_1_by_b_3_x*t293
        + D_p_x_3_by_b_3_x*t336 + D_p_y_3_by_b_3_x*t338 + D_p_z_3_by_b_3_x*t340
    )
    t565 = (
        D_delta_x_2_by_b_3_x*t287 + D_delta_y_2_by_b_3_x*t290 + D_delta_z_2_by_b_3_x*t293
        + D_p_x_3_by_b_3_x*t350 + D_p_y_3_by_b_3_x*t352 + D_p_z_3_by_b_3_x*t354
    )
    t566 = (
        D_delta_x_3_by_b_3_x*t287 + D_delta_y_3_by_b_3_x*t290 + D_delta_z_3_by_b_3_x*t293
        + D_p_x_3_by_b_3_x*t356 + D_p_y_3_by_b_3_x*t357 + D_p_z_3_by_b_3_x*t358
    )
    t567 = D_p_x_3_by_b_3_x*t45
    t568 = D_p_y_3_by_b_3_x*t45
    t569 = D_p_z_3_by_b_3_x*t45
    t570 = R_p_3**2
    t571 = t333*t570
    t572 = t571*x_3_by_b_3_x
    t573 = (
        D_delta_x_1_by_b_3_x*t350 + D_delta_x_2_by_b_3_x*t336 + D_delta_y_1_by_b_3_x*t352
        + D_delta_y_2_by_b_3_x*t338 + D_delta_z_1_by_b_3_x*t354 + D_delta_z_2_by_b_3_x*t340
    )
    t574 = (
        D_delta_x_1_by_b_3_x*t356 + D_delta_x_3_by_b_3_x*t336 + D_delta_y_1_by_b_3_x*t357
        + D_delta_y_3_by_b_3_x*t338 + D_delta_z_1_by_b_3_x*t358 + D_delta_z_3_by_b_3_x*t340
    )
    t575 = D_delta_x_1_by_b_3_x*t45
    t576 = D_delta_y_1_by_b_3_x*t45
    t577 = D_delta_z_1_by_b_3_x*t45
    t578 = (
        D_delta_x_2_by_b_3_x*t356 + D_delta_x_3_by_b_3_x*t350 + D_delta_y_2_by_b_3_x*t357
        + D_delta_y_3_by_b_3_x*t352 + D_delta_z_2_by_b_3_x*t358 + D_delta_z_3_by_b_3_x*t354
    )
    t579 = D_delta_x_2_by_b_3_x*t45
    t580 = D_delta_y_2_by_b_3_x*t45
    t581 = D_delta_z_2_by_b_3_x*t45
    t582 = D_delta_x_3_by_b_3_x*t45
    t583 = D_delta_y_3_by_b_3_x*t45
    t584 = D_delta_z_3_by_b_3_x*t45
    t585 = (
        D_p_x_1_by_b_3_y*t271 + D_p_x_2_by_b_3_y*t273 + D_p_y_1_by_b_3_y*t276 + D_p_y_2_by_b_3_y*t278
        + D_p_z_1_by_b_3_y*t281 + D_p_z_2_by_b_3_y*t283
    )
    t586 = (
        D_p_x_1_by_b_3_y*t287 + D_p_x_3_by_b_3_y*t273 + D_p_y_1_by_b_3_y*t290 + D_p_y_3_by_b_3_y*t278
        + D_p_z_1_by_b_3_y*t293 + D_p_z_3_by_b_3_y*t283
    )
    t587 = (
        D_delta_x_1_by_b_3_y*t273 + D_delta_y_1_by_b_3_y*t278 + D_delta_z_1_by_b_3_y*t283
        + D_p_x_1_by_b_3_y*t336 + D_p_y_1_by_b_3_y*t338 + D_p_z_1_by_b_3_y*t340
    )
    t588 = (
        D_delta_x_2_by_b_3_y*t273 + D_delta_y_2_by_b_3_y*t278 + D_delta_z_2_by_b_3_y*t283
        + D_p_x_1_by_b_3_y*t350 + D_p_y_1_by_b_3_y*t352 + D_p_z_1_by_b_3_y*t354
    )
    t589 = (
        D_delta_x_3_by_b_3_y*t273 + D_delta_y_3_by_b_3_y*t278 + D_delta_z_3_by_b_3_y*t283
        + D_p_x_1_by_b_3_y*t356 + D_p_y_1_by_b_3_y*t357 + D_p_z_1_by_b_3_y*t358
    )
    t590 = D_p_x_1_by_b_3_y*t45
    t591 = D_p_y_1_by_b_3_y*t45
    t592 = D_p_z_1_by_b_3_y*t45
    t593 = (
        D_p_x_2_by_b_3_y*t287 + D_p_x_3_by_b_3_y*t271 + D_p_y_2_by_b_3_y*t290 + D_p_y_3_by_b_3_y*t276
        + D_p_z_2_by_b_3_y*t293 + D_p_z_3_by_b_3_y*t281
    )
    t594 = (
        D_delta_x_1_by_b_3_y*t271 + D_delta_y_1_by_b_3_y*t276 + D_delta_z_1_by_b_3_y*t281
        + D_p_x_2_by_b_3_y*t336 + D_p_y_2_by_b_3_y*t338 + D_p_z_2_by_b_3_y*t340
    )
    t595 = (
        D_delta_x_2_by_b_3_y*t271 + D_delta_y_2_by_b_3_y*t276 + D_delta_z_2_by_b_3_y*t281
        + D_p_x_2_by_b_3_y*t350 + D_p_y_2_by_b_3_y*t352 + D_p_z_2_by_b_3_y*t354
    )
    t596 = (
        D_delta_x_3_by_b_3_y*t271 + D_delta_y_3_by_b_3_y*t276 + D_delta_z_3_by_b_3_y*t281
        + D_p_x_2_by_b_3_y*t356 + D_p_y_2_by_b_3_y*t357 + D_p_z_2_by_b_3_y*t358
    )
    t597 = D_p_x_2_by_b_3_y*t45
    t598 = D_p_y_2_by_b_3_y*t45
    t599 = D_p_z_2_by_b_3_y*t45
    t600 = t562*x_3_by_b_3_y
    t601 = (
        D_delta_x_1_by_b_3_y*t287 + D_delta_y_1_by_b_3_y*t290 + D_delta_z_1_by_b_3_y*t293
        + D_p_x_3_by_b_3_y*t336 + D_p_y_3_by_b_3_y*t338 + D_p_z_3_by_b_3_y*t340
    )
    t602 = (
        D_delta_x_2_by_b_3_y*t287 + D_delta_y_2_by_b_3_y*t290 + D_delta_z_2_by_b_3_y*t293
        + D_p_x_3_by_b_3_y*t350 + D_p_y_3_by_b_3_y*t352 + D_p_z_3_by_b_3_y*t354
    )
    t603 = (
        D_delta_x_3_by_b_3_y*t287 + D_delta_y_3_by_b_3_y*t290 + D_delta_z_3_by_b_3_y*t293
        + D_p_x_3_by_b_3_y*t356 + D_p_y_3_by_b_3_y*t357 + D_p_z_3_by_b_3_y*t358
    )
    t604 = D_p_x_3_by_b_3_y*t45
    t605 = D_p_y_3_by_b_3_y*t45
    t606 = D_p_z_3_by_b_3_y*t45
    t607 = t571*x_3_by_b_3_y
    t608 = (
        D_delta_x_1_by_b_3_y*t350 + D_delta_x_2_by_b_3_y*t336 + D_delta_y_1_by_b_3_y*t352
        + D_delta_y_2_by_b_3_y*t338 + D_delta_z_1_by_b_3_y*t354 + D_delta_z_2_by_b_3_y*t340
    )
    t609 = (
        D_delta_x_1_by_b_3_y*t356 + D_delta_x_3_by_b_3_y*t336 + D_delta_y_1_by_b_3_y*t357
        + D_delta_y_3_by_b_3_y*t338 + D_delta_z_1_by_b_3_y*t358 + D_delta_z_3_by_b_3_y*t340
    )
    t610 = D_delta_x_1_by_b_3_y*t45
    t611 = D_delta_y_1_by_b_3_y*t45
    t612 = D_delta_z_1_by_b_3_y*t45
    t613 = (
        D_delta_x_2_by_b_3_y*t356 + D_delta_x_3_by_b_3_y*t350 + D_delta_y_2_by_b_3_y*t357
        + D_delta_y_3_by_b_3_y*t352 + D_delta_z_2_by_b_3_y*t358 + D_delta_z_3_by_b_3_y*t354
    )
    t614 = D_delta_x_2_by_b_3_y*t45
    t615 = D_delta_y_2_by_b_3_y*t45
    t616 = D_delta_z_2_by_b_3_y*t45
    t617 = D_delta_x_3_by_b_3_y*t45
    t618 = D_delta_y_3_by_b_3_y*t45
    t619 = D_delta_z_3_by_b_3_y*t45
    t620 = (
        D_p_x_1_by_b_3_z*t271 + D_p_x_2_by_b_3_z*t273 + D_p_y_1_by_b_3_z*t276 + D_p_y_2_by_b_3_z*t278
        + D_p_z_1_by_b_3_z*t281 + D_p_z_2_by_b_3_z*t283
    )
    t621 = (
        D_p_x_1_by_b_3_z*t287 + D_p_x_3_by_b_3_z*t273 + D_p_y_1_by_b_3_z*t290 + D_p_y_3_by_b_3_z*t278
        + D_p_z_1_by_b_3_z*t293 + D_p_z_3_by_b_3_z*t283
    )
    t622 = (
        D_delta_x_1_by_b_3_z*t273 + D_delta_y_1_by_b_3_z*t278 + D_delta_z_1_by_b_3_z*t283
        + D_p_x_1_by_b_3_z*t336 + D_p_y_1_by_b_3_z*t338 + D_p_z_1_by_b_3_z*t340
    )
    t623 = (
        D_delta_x_2_by_b_3_z*t273 + D_delta_y_2_by_b_3_z*t278 + D_delta_z_2_by_b_3_z*t283
        + D_p_x_1_by_b_3_z*t350 + D_p_y_1_by_b_3_z*t352 + D_p_z_1_by_b_3_z*t354
    )
    t624 = (
        D_delta_x_3_by_b_3_z*t273 + D_delta_y_3_by_b_3_z*t278 + D_delta_z_3_by_b_3_z*t283
        + D_p_x_1_by_b_3_z*t356 + D_p_y_1_by_b_3_z*t357 + D_p_z_1_by_b_3_z*t358
    )
    t625 = D_p_x_1_by_b_3_z*t45
    t626 = D_p_y_1_by_b_3_z*t45
    t627 = D_p_z_1_by_b_3_z*t45
    t628 = (
        D_p_x_2_by_b_3_z*t287 + D_p_x_3_by_b_3_z*t271 + D_p_y_2_by_b_3_z*t290 + D_p_y_3_by_b_3_z*t276
        + D_p_z_2_by_b_3_z*t293 + D_p_z_3_by_b_3_z*t281
    )
    t629 = (
        D_delta_x_1_by_b_3_z*t271 + D_delta_y_1_by_b_3_z*t276 + D_delta_z_1_by_b_3_z*t281
        + D_p_x_2_by_b_3_z*t336 + D_p_y_2_by_b_3_z*t338 + D_p_z_2_by_b_3_z*t340
    )
    t630 = (
        D_delta_x_2_by_b_3_z*t271 + D_delta_y_2_by_b_3_z*t276 + D_delta_z_2_by_b_3_z*t281
        + D_p_x_2_by_b_3_z*t350 + D_p_y_2_by_b_3_z*t352 + D_p_z_2_by_b_3_z*t354
    )
    t631 = (
        D_delta_x_3_by_b_3_z*t271 + D_delta_y_3_by_b_3_z*t276 + D_delta_z_3_by_b_3_z*t281
        + D_p_x_2_by_b_3_z*t356 + D_p_y_2_by_b_3_z*t357 + D_p_z_2_by_b_3_z*t358
    )
    t632 = D_p_x_2_by_b_3_z*t45
    t633 = D_p_y_2_by_b_3_z*t45
    t634 = D_p_z_2_by_b_3_z*t45
    t635 = t562*x_3_by_b_3_z
    t636 = (
        D_delta_x_1_by_b_3_z*t287 + D_delta_y_1_by_b_3_z*t290 + D_delta_z_1_by_b_3_z*t293
        + D_p_x_3_by_b_3_z*t336 + D_p_y_3_by_b_3_z*t338 + D_p_z_3_by_b_3_z*t340
    )
    t637 = (
        D_delta_x_2_by_b_3_z*t287 + D_delta_y_2_by_b_3_z*t290 + D_delta_z_2_by_b_3_z*t293
        + D_p_x_3_by_b_3_z*t350 + D_p_y_3_by_b_3_z*t352 + D_p_z_3_by_b_3_z*t354
    )
    t638 = (
        D_delta_x_3_by_b_3_z*t287 + D_delta_y_3_by_b_3_z*t290 + D_delta_z_3_by_b_3_z*t293
        + D_p_x_3_by_b_3_z*t356 + D_p_y_3_by_b_3_z*t357 + D_p_z_3_by_b_3_z*t358
    )
    t639 = D_p_x_3_by_b_3_z*t45
    t640 = D_p_y_3_by_b_3_z*t45
    t641 = D_p_z_3_by_b_3_z*t45
    t642 = t571*x_3_by_b_3_z
    t643 = (
        D_delta_x_1_by_b_3_z*t350 + D_delta_x_2_by_b_3_z*t336 + D_delta_y_1_by_b_3_z*t352
        + D_delta_y_2_by_b_3_z*t338 + D_delta_z_1_by_b_3_z*t354 + D_delta_z_2_by_b_3_z*t340
    )
    t644 = (
        D_delta_x_1_by_b_3_z*t356 + D_delta_x_3_by_b_3_z*t336 + D_delta_y_1_by_b_3_z*t357
        + D_delta_y_3_by_b_3_z*t338 + D_delta_z_1_by_b_3_z*t358 + D_delta_z_3_by_b_3_z*t340
    )
    t645 = D_delta_x_1_by_b_3_z*t45
    t646 = D_delta_y_1_by_b_3_z*t45
    t647 = D_delta_z_1_by_b_3_z*t45
    t648 = (
        D_delta_x_2_by_b_3_z*t356 + D_delta_x_3_by_b_3_z*t350 + D_delta_y_2_by_b_3_z*t357
        + D_delta_y_3_by_b_3_z*t352 + D_delta_z_2_by_b_3_z*t358 + D_delta_z_3_by_b_3_z*t354
    )
    t649 = D_delta_x_2_by_b_3_z*t45
    t650 = D_delta_y_2_by_b_3_z*t45
    t651 = D_delta_z_2_by_b_3_z*t45
    t652 = D_delta_x_3_by_b_3_z*t45
    t653 = D_delta_y_3_by_b_3_z*t45
    t654 = D_delta_z_3_by_b_3_z*t45
    t655 = (
        D_p_x_1_by_l_d_1*t271 + D_p_x_2_by_l_d_1*t273 + D_p_y_1_by_l_d_1*t276 + D_p_y_2_by_l_d_1*t278
        + D_p_z_1_by_l_d_1*t281 + D_p_z_2_by_l_d_1*t283
    )
    t656 = (
        D_p_x_1_by_l_d_1*t287 + D_p_x_3_by_l_d_1*t273 + D_p_y_1_by_l_d_1*t290 + D_p_y_3_by_l_d_1*t278
        + D_p_z_1_by_l_d_1*t293 + D_p_z_3_by_l_d_1*t283
    )
    t657 = t296*x_1_by_l_d_1
    t658 = (
        D_delta_x_1_by_l_d_1*t273 + D_delta_y_1_by_l_d_1*t278 + D_delta_z_1_by_l_d_1*t283
        + D_p_x_1_by_l_d_1*t336 + D_p_y_1_by_l_d_1*t338 + D_p_z_1_by_l_d_1*t340
    )
    t659 = (
        D_delta_x_2_by_l_d_1*t273 + D_delta_y_2_by_l_d_1*t278 + D_delta_z_2_by_l_d_1*t283
        + D_p_x_1_by_l_d_1*t350 + D_p_y_1_by_l_d_1*t352 + D_p_z_1_by_l_d_1*t354
    )
    t660 = (
        D_delta_x_3_by_l_d_1*t273 + D_delta_y_3_by_l_d_1*t278 + D_delta_z_3_by_l_d_1*t283
        + D_p_x_1_by_l_d_1*t356 + D_p_y_1_by_l_d_1*t357 + D_p_z_1_by_l_d_1*t358
    )
    t661 = D_p_x_1_by_l_d_1*t45
    t662 = D_p_y_1_by_l_d_1*t45
    t663 = D_p_z_1_by_l_d_1*t45
    t664 = (
        D_p_x_2_by_l_d_1*t287 + D_p_x_3_by_l_d_1*t271 + D_p_y_2_by_l_d_1*t290 + D_p_y_3_by_l_d_1*t276
        + D_p_z_2_by_l_d_1*t293 + D_p_z_3_by_l_d_1*t281
    )
    t665 = (
        D_delta_x_1_by_l_d_1*t271 + D_delta_y_1_by_l_d_1*t276 + D_delta_z_1_by_l_d_1*t281
        + D_p_x_2_by_l_d_1*t336 + D_p_y_2_by_l_d_1*t338 + D_p_z_2_by_l_d_1*t340
    )
    t666 = (
        D_delta_x_2_by_l_d_1*t271 + D_delta_y_2_by_l_d_1*t276 + D_delta_z_2_by_l_d_1*t281
        + D_p_x_2_by_l_d_1*t350 + D_p_y_2_by_l_d_1*t352 + D_p_z_2_by_l_d_1*t354
    )
    t667 = (
        D_delta_x_3_by_l_d_1*t271 + D_delta_y_3_by_l_d_1*t276 + D_delta_z_3_by_l_d_1*t281
        + D_p_x_2_by_l_d_1*t356 + D_p_y_2_by_l_d_1*t357 + D_p_z_2_by_l_d_1*t358
    )
    t668 = D_p_x_2_by_l_d_1*t45
    t669 = D_p_y_2_by_l_d_1*t45
    t670 = D_p_z_2_by_l_d_1*t45
    t671 = (
        D_delta_x_1_by_l_d_1*t287 + D_delta_y_1_by_l_d_1*t290 + D_delta_z_1_by_l_d_1*t293
        + D_p_x_3_by_l_d_1*t336 + D_p_y_3_by_l_d_1*t338 + D_p_z_3_by_l_d_1*t340
    )
    t672 = (
        D_delta_x_2_by_l_d_1*t287 + D_delta_y_2_by_l_d_1*t290 + D_delta_z_2_by_l_d_1*t293
        + D_p_x_3_by_l_d_1*t350 + D_p_y_3_by_l_d_1*t352 + D_p_z_3_by_l_d_1*t354
    )
    t673 = (
        D_delta_x_3_by_l_d_1*t287 + D_delta_y_3_by_l_d_1*t290 + D_delta_z_3_by_l_d_1*t293
        + D_p_x_3_by_l_d_1*t356 + D_p_y_3_by_l_d_1*t357 + D_p_z_3_by_l_d_1*t358
    )
    t674 = D_p_x_3_by_l_d_1*t45
    t675 = D_p_y_3_by_l_d_1*t45
    t676 = D_p_z_3_by_l_d_1*t45
    t677 = t334*x_1_by_l_d_1
    t678 = (
        D_delta_x_1_by_l_d_1*t350 + D_delta_x_2_by_l_d_1*t336 + D_delta_y_1_by_l_d_1*t352
        + D_delta_y_2_by_l_d_1*t338 + D_delta_z_1_by_l_d_1*t354 + D_delta_z_2_by_l_d_1*t340
    )
    t679 = (
        D_delta_x_1_by_l_d_1*t356 + D_delta_x_3_by_l_d_1*t336 + D_delta_y_1_by_l_d_1*t357
        + D_delta_y_3_by_l_d_1*t338 + D_delta_z_1_by_l_d_1*t358 + D_delta_z_3_by_l_d_1*t340
    )
    t680 = D_delta_x_1_by_l_d_1*t45
    t681 = D_delta_y_1_by_l_d_1*t45
    t682 = D_delta_z_1_by_l_d_1*t45
    t683 = (
        D_delta_x_2_by_l_d_1*t356 + D_delta_x_3_by_l_d_1*t350 + D_delta_y_2_by_l_d_1*t357
        + D_delta_y_3_by_l_d_1*t352 + D_delta_z_2_by_l_d_1*t358 + D_delta_z_3_by_l_d_1*t354
    )
    t684 = D_delta_x_2_by_l_d_1*t45
    t685 = D_delta_y_2_by_l_d_1*t45
    t686 = D_delta_z_2_by_l_d_1*t45
    t687 = D_delta_x_3_by_l_d_1*t45
    t688 = D_delta_y_3_by_l_d_1*t45
    t689 = D_delta_z_3_by_l_d_1*t45
    t690 = (
        D_p_x_1_by_l_d_2*t271 + D_p_x_2_by_l_d_2*t273 + D_p_y_1_by_l_d_2*t276 + D_p_y_2_by_l_d_2*t278
        + D_p_z_1_by_l_d_2*t281 + D_p_z_2_by_l_d_2*t283
    )
    t691 = (
        D_p_x_1_by_l_d_2*t287 + D_p_x_3_by_l_d_2*t273 + D_p_y_1_by_l_d_2*t290 + D_p_y_3_by_l_d_2*t278
        + D_p_z_1_by_l_d_2*t293 + D_p_z_3_by_l_d_2*t283
    )
    t692 = (
        D_delta_x_1_by_l_d_2*t273 + D_delta_y_1_by_l_d_2*t278 + D_delta_z_1_by_l_d_2*t283
        + D_p_x_1_by_l_d_2*t336 + D_p_y_1_by_l_d_2*t338 + D_p_z_1_by_l_d_2*t340
    )
    t693 = (
        D_delta_x_2_by_l_d_2*t273 + D_delta_y_2_by_l_d_2*t278 + D_delta_z_2_by_l_d_2*t283
        + D_p_x_1_by_l_d_2*t350 + D_p_y_1_by_l_d_2*t352 + D_p_z_1_by_l_d_2*t354
    )
    t694 = (
        D_delta_x_3_by_l_d_2*t273 + D_delta_y_3_by_l_d_2*t278 + D_delta_z_3_by_l_d_2*t283
        + D_p_x_1_by_l_d_2*t356 + D_p_y_1_by_l_d_2*t357 + D_p_z_1_by_l_d_2*t358
    )
    t695 = D_p_x_1_by_l_d_2*t45
    t696 = D_p_y_1_by_l_d_2*t45
    t697 = D_p_z_1_by_l_d_2*t45
    t698 = (
        D_p_x_2_by_l_d_2*t287 + D_p_x_3_by_l_d_2*t271 + D_p_y_2_by_l_d_2*t290 + D_p_y_3_by_l_d_2*t276
        + D_p_z_2_by_l_d_2*t293 + D_p_z_3_by_l_d_2*t281
    )
    t699 = t448*x_2_by_l_d_2
    t700 = (
        D_delta_x_1_by_l_d_2*t271 + D_delta_y_1_by_l_d_2*t276 + D_delta_z_1_by_l_d_2*t281
        + D_p_x_2_by_l_d_2*t336 + D_p_y_2_by_l_d_2*t338 + D_p_z_2_by_l_d_2*t340
    )
    t701 = (
        D_delta_x_2_by_l_d_2*t271 + D_delta_y_2_by_l_d_2*t276 + D_delta_z_2_by_l_d_2*t281
        + D_p_x_2_by_l_d_2*t350 + D_p_y_2_by_l_d_2*t352 + D_p_z_2_by_l_d_2*t354
    )
    t702 = (
        D_delta_x_3_by_l_d_2*t271 + D_delta_y_3_by_l_d_2*t276 + D_delta_z_3_by_l_d_2*t281
        + D_p_x_2_by_l_d_2*t356 + D_p_y_2_by_l_d_2*t357 + D_p_z_2_by_l_d_2*t358
    )
    t703 = D_p_x_2_by_l_d_2*t45
    t704 = D_p_y_2_by_l_d_2*t45
    t705 = D_p_z_2_by_l_d_2*t45
    t706 = (
        D_delta_x_1_by_l_d_2*t287 + D_delta_y_1_by_l_d_2*t290 + D_delta_z_1_by_l_d_2*t293
        + D_p_x_3_by_l_d_2*t336 + D_p_y_3_by_l_d_2*t338 + D_p_z_3_by_l_d_2*t340
    )
    t707 = (
        D_delta_x_2_by_l_d_2*t287 + D_delta_y_2_by_l_d_2*t290 + D_delta_z_2_by_l_d_2*t293
        + D_p_x_3_by_l_d_2*t350 + D_p_y_3_by_l_d_2*t352 + D_p_z_3_by_l_d_2*t354
    )
    t708 = (
        D_delta_x_3_by_l_d_2*t287 + D_delta_y_3_by_l_d_2*t290 + D_delta_z_3_by_l_d_2*t293
        + D_p_x_3_by_l_d_2*t356 + D_p_y_3_by_l_d_2*t357 + D_p_z_3_by_l_d_2*t358
    )
    t709 = D_p_x_3_by_l_d_2*t45
    t710 = D_p_y_3_by_l_d_2*t45
    t711 = D_p_z_3_by_l_d_2*t45
    t712 = t463*x_2_by_l_d_2
    t713 = (
        D_delta_x_1_by_l_d_2*t350 + D_delta_x_2_by_l_d_2*t336 + D_delta_y_1_by_l_d_2*t352
        + D_delta_y_2_by_l_d_2*t338 + D_delta_z_1_by_l_d_2*t354 + D_delta_z_2_by_l_d_2*t340
    )
    t714 = (
        D_delta_x_1_by_l_d_2*t356 + D_delta_x_3_by_l_d_2*t336 + D_delta_y_1_by_l_d_2*t357
        + D_delta_y_3_by_l_d_2*t338 + D_delta_z_1_by_l_d_2*t358 + D_delta_z_3_by_l_d_2*t340
    )
    t715 = D_delta_x_1_by_l_d_2*t45
    t716 = D_delta_y_1_by_l_d_2*t45
    t717 = D_delta_z_1_by_l_d_2*t45
    t718 = (
        D_delta_x_2_by_l_d_2*t356 + D_delta_x_3_by_l_d_2*t350 + D_delta_y_2_by_l_d_2*t357
        + D_delta_y_3_by_l_d_2*t352 + D_delta_z_2_by_l_d_2*t358 + D_delta_z_3_by_l_d_2*t354
    )
    t719 = D_delta_x_2_by_l_d_2*t45
    t720 = D_delta_y_2_by_l_d_2*t45
    t721 = D_delta_z_2_by_l_d_2*t45
    t722 = D_delta_x_3_by_l_d_2*t45
    t723 = D_delta_y_3_by_l_d_2*t45
    t724 = D_delta_z_3_by_l_d_2*t45
    t725 = (
        D_p_x_1_by_l_d_3*t271 + D_p_x_2_by_l_d_3*t273 + D_p_y_1_by_l_d_3*t276 + D_p_y_2_by_l_d_3*t278
        + D_p_z_1_by_l_d_3*t281 + D_p_z_2_by_l_d_3*t283
    )
    t726 = (
        D_p_x_1_by_l_d_3*t287 + D_p_x_3_by_l_d_3*t273 + D_p_y_1_by_l_d_3*t290 + D_p_y_3_by_l_d_3*t278
        + D_p_z_1_by_l_d_3*t293 + D_p_z_3_by_l_d_3*t283
    )
    t727 = (
        D_delta_x_1_by_l_d_3*t273 + D_delta_y_1_by_l_d_3*t278 + D_delta_z_1_by_l_d_3*t283
        + D_p_x_1_by_l_d_3*t336 + D_p_y_1_by_l_d_3*t338 + D_p_z_1_by_l_d_3*t340
    )
    t728 = (
        D_delta_x_2_by_l_d_3*t273 + D_delta_y_2_by_l_d_3*t278 + D_delta_z_2_by_l_d_3*t283
        + D_p_x_1_by_l_d_3*t350 + D_p_y_1_by_l_d_3*t352 + D_p_z_1_by_l_d_3*t354
    )
    t729 = (
        D_delta_x_3_by_l_d_3*t273 + D_delta_y_3_by_l_d_3*t278 + D_delta_z_3_by_l_d_3*t283
        + D_p_x_1_by_l_d_3*t356 + D_p_y_1_by_l_d_3*t357 + D_p_z_1_by_l_d_3*t358
    )
    t730 = D_p_x_1_by_l_d_3*t45
    t731 = D_p_y_1_by_l_d_3*t45
    t732 = D_p_z_1_by_l_d_3*t45
    t733 = (
        D_p_x_2_by_l_d_3*t287 + D_p_x_3_by_l_d_3*t271 + D_p_y_2_by_l_d_3*t290 + D_p_y_3_by_l_d_3*t276
        + D_p_z_2_by_l_d_3*t293 + D_p_z_3_by_l_d_3*t281
    )
    t734 = (
        D_delta_x_1_by_l_d_3*t271 + D_delta_y_1_by_l_d_3*t276 + D_delta_z_1_by_l_d_3*t281
        + D_p_x_2_by_l_d_3*t336 + D_p_y_2_by_l_d_3*t338 + D_p_z_2_by_l_d_3*t340
    )
    t735 = (
        D_delta_x_2_by_l_d_3*t271 + D_delta_y_2_by_l_d_3*t276 + D_delta_z_2_by_l_d_3*t281
        + D_p_x_2_by_l_d_3*t350 + D_p_y_2_by_l_d_3*t352 + D_p_z_2_by_l_d_3*t354
    )
    t736 = (
        D_delta_x_3_by_l_d_3*t271 + D_delta_y_3_by_l_d_3*t276 + D_delta_z_3_by_l_d_3*t281
        + D_p_x_2_by_l_d_3*t356 + D_p_y_2_by_l_d_3*t357 + D_p_z_2_by_l_d_3*t358
    )
    t737 = D_p_x_2_by_l_d_3*t45
    t738 = D_p_y_2_by_l_d_3*t45
    t739 = D_p_z_2_by_l_d_3*t45
    t740 = t562*x_3_by_l_d_3
    t741 = (
        D_delta_x_1_by_l_d_3*t287 + D_delta_y_1_by_l_d_3*t290 + D_delta_z_1_by_l_d_3*t293
        + D_p_x_3_by_l_d_3*t336 + D_p_y_3_by_l_d_3*t338 + D_p_z_3_by_l_d_3*t340
    )
    t742 = (
        D_delta_x_2_by_l_d_3*t287 + D_delta_y_2_by_l_d_3*t290 + D_delta_z_2_by_l_d_3*t293
        + D_p_x_3_by_l_d_3*t350 + D_p_y_3_by_l_d_3*t352 + D_p_z_3_by_l_d_3*t354
    )
    t743 = (
        D_delta_x_3_by_l_d_3*t287 + D_delta_y_3_by_l_d_3*t290 + D_delta_z_3_by_l_d_3*t293
        + D_p_x_3_by_l_d_3*t356 + D_p_y_3_by_l_d_3*t357 + D_p_z_3_by_l_d_3*t358
    )
    t744 = D_p_x_3_by_l_d_3*t45
    t745 = D_p_y_3_by_l_d_3*t45
    t746 = D_p_z_3_by_l_d_3*t45
    t747 = t571*x_3_by_l_d_3
    t748 = (
        D_delta_x_1_by_l_d_3*t350 + D_delta_x_2_by_l_d_3*t336 + D_delta_y_1_by_l_d_3*t352
        + D_delta_y_2_by_l_d_3*t338 + D_delta_z_1_by_l_d_3*t354 + D_delta_z_2_by_l_d_3*t340
    )
    t749 = (
        D_delta_x_1_by_l_d_3*t356 + D_delta_x_3_by_l_d_3*t336 + D_delta_y_1_by_l_d_3*t357
        + D_delta_y_3_by_l_d_3*t338 + D_delta_z_1_by_l_d_3*t358 + D_delta_z_3_by_l_d_3*t340
    )
    t750 = D_delta_x_1_by_l_d_3*t45
    t751 = D_delta_y_1_by_l_d_3*t45
    t752 = D_delta_z_1_by_l_d_3*t45
    t753 = (
        D_delta_x_2_by_l_d_3*t356 + D_delta_x_3_by_l_d_3*t350 + D_delta_y_2_by_l_d_3*t357
        + D_delta_y_3_by_l_d_3*t352 + D_delta_z_2_by_l_d_3*t358 + D_delta_z_3_by_l_d_3*t354
    )
    t754 = D_delta_x_2_by_l_d_3*t45
    t755 = D_delta_y_2_by_l_d_3*t45
    t756 = D_delta_z_2_by_l_d_3*t45
    t757 = D_delta_x_3_by_l_d_3*t45
    t758 = D_delta_y_3_by_l_d_3*t45
    t759 = D_delta_z_3_by_l_d_3*t45
    t760 = (1/3)*D_p_x_1 + t272
    t761 = (1/3)*D_p_y_1 + t277
    t762 = (1/3)*D_p_z_1 + t282
    t763 = D_p_x_2*t760 + D_p_y_2*t761 + D_p_z_2*t762
    t764 = D_p_x_3*t760 + D_p_y_3*t761 + D_p_z_3*t762
    t765 = D_delta_x_1*t760 + D_delta_y_1*t761 + D_delta_z_1*t762
    t766 = D_delta_x_2*t760 + D_delta_y_2*t761 + D_delta_z_2*t762
    t767 = D_delta_x_3*t760 + D_delta_y_3*t761 + D_delta_z_3*t762
    t768 = (1/2)*D_p_x_1
    t769 = (1/2)*n_1_x + t768
    t770 = (1/2)*D_p_y_1
    t771 = (1/2)*n_1_y + t770
    t772 = (1/2)*D_p_z_1
    t773 = (1/2)*n_1_z + t772
    t774 = (1/3)*t199 + (1/3)*t200 + (1/3)*t201
    t775 = (1/3)*t203 + (1/3)*t204 + (1/3)*t205
    t776 = (1/3)*t207 + (1/3)*t208 + (1/3)*t209
    t777 = (1/3)*t211 + (1/3)*t212 + (1/3)*t213
    t778 = (1/3)*t215 + (1/3)*t216 + (1/3)*t217
    t779 = (1/2)*D_p_x_2
    t780 = (1/2)*D_p_y_2
    t781 = (1/2)*D_p_z_2
    t782 = (1/3)*t219 + (1/3)*t220 + (1/3)*t221
    t783 = (1/3)*t223 + (1/3)*t224 + (1/3)*t225
    t784 = (1/3)*t227 + (1/3)*t228 + (1/3)*t229
    t785 = (1/3)*t231 + (1/3)*t232 + (1/3)*t233
    t786 = (1/2)*D_p_x_3
    t787 = (1/2)*D_p_y_3
    t788 = (1/2)*D_p_z_3
    t789 = (1/3)*t235 + (1/3)*t236 + (1/3)*t237
    t790 = (1/3)*t239 + (1/3)*t240 + (1/3)*t241
    t791 = (1/3)*t243 + (1/3)*t244 + (1/3)*t245
    t792 = (1/2)*D_delta_x_1
    t793 = (1/2)*D_delta_y_1
    t794 = (1/2)*D_delta_z_1
    t795 = (1/3)*t247 + (1/3)*t248 + (1/3)*t249
    t796 = (1/3)*t251 + (1/3)*t252 + (1/3)*t253
    t797 = (1/2)*D_delta_x_2
    t798 = (1/2)*D_delta_y_2
    t799 = (1/2)*D_delta_z_2
    t800 = (1/3)*t255 + (1/3)*t256 + (1/3)*t257
    t801 = (1/2)*D_delta_x_3
    t802 = (1/2)*D_delta_y_3
    t803 = (1/2)*D_delta_z_3
    t804 = (1/3)*t175 + (1/3)*t176 + (1/3)*t177
    t805 = (1/3)*t179 + (1/3)*t180 + (1/3)*t181
    t806 = D_p_x_1*t269 + D_p_y_1*t274 + D_p_z_1*t279 + t805
    t807 = (1/3)*t183 + (1/3)*t184 + (1/3)*t185
    t808 = (1/3)*t187 + (1/3)*t188 + (1/3)*t189
    t809 = (1/3)*t191 + (1/3)*t192 + (1/3)*t193
    t810 = (1/3)*t195 + (1/3)*t196 + (1/3)*t197
    t811 = (1/3)*D_p_x_2 + t269
    t812 = (1/3)*D_p_y_2 + t274
    t813 = (1/3)*D_p_z_2 + t279
    t814 = D_p_x_3*t811 + D_p_y_3*t812 + D_p_z_3*t813
    t815 = D_delta_x_1*t811 + D_delta_y_1*t812 + D_delta_z_1*t813
    t816 = D_delta_x_2*t811 + D_delta_y_2*t812 + D_delta_z_2*t813
    t817 = D_delta_x_3*t811 + D_delta_y_3*t812 + D_delta_z_3*t813
    t818 = (1/2)*n_2_x + t779
    t819 = (1/2)*n_2_y + t780
    t820 = (1/2)*n_2_z + t781
    t821 = D_p_x_1*t285 + D_p_y_1*t288 + D_p_z_1*t291 + t807
    t822 = D_p_x_2*t285 + D_p_y_2*t288 + D_p_z_2*t291 + t775
    t823 = (1/3)*D_p_x_3 + t285
    t824 = (1/3)*D_p_y_3 + t288
    t825 = (1/3)*D_p_z_3 + t291
    t826 = D_delta_x_1*t823 + D_delta_y_1*t824 + D_delta_z_1*t825
    t827 = D_delta_x_2*t823 + D_delta_y_2*t824 + D_delta_z_2*t825
    t828 = D_delta_x_3*t823 + D_delta_y_3*t824 + D_delta_z_3*t825
    t829 = (1/2)*n_3_x + t786
    t830 = (1/2)*n_3_y + t787
    t831 = (1/2)*n_3_z + t788
    t832 = (1/12)*rho_b
    t833 = -R_p_1*t832
    t834 = t295*t332
    t835 = -R_p_2*t832
    t836 = t295*t462
    t837 = -R_p_3*t832
    t838 = t295*t570
    t839 = l_f_1_3*t295
    t840 = l_f_1_2*t295
    t841 = (2/3)*rho_b
    t842 = R_p_1*t841
    t843 = l_f_1_1*t842
    t844 = R_p_1*l_f_1_1*t333
    t845 = l_f_2_3*t295
    t846 = l_f_2_2*t295
    t847 = R_p_2*t841
    t848 = l_f_2_1*t847
    t849 = R_p_2*l_f_2_1*t333
    t850 = l_f_3_3*t295
    t851 = l_f_3_2*t295
    t852 = R_p_3*t841
    t853 = l_f_3_1*t852
    t854 = R_p_3*l_f_3_1*t333
    t855 = i_g_1**2
    t856 = d_1_1*t855
    t857 = d_1_2*t855
    t858 = i_g_2**2
    t859 = d_2_1*t858
    t860 = d_2_2*t858
    t861 = i_g_3**2
    t862 = d_3_1*t861
    t863 = d_3_2*t861
    t864 = 2*I_m_1*i_g_1
    t865 = d_1_1*t864
    t866 = d_1_2*t864
    t867 = 2*I_m_2*i_g_2
    t868 = d_2_1*t867
    t869 = d_2_2*t867
    t870 = 2*I_m_3*i_g_3
    t871 = d_3_1*t870
    t872 = d_3_2*t870
    t873 = t332*t841
    t874 = t462*t841
    t875 = t570*t841
    t876 = (1/3)*l_f_1_2
    t877 = (1/3)*l_f_1_3
    t878 = t876 + t877
    t879 = (1/6)*R_p_1
    t880 = l_f_1_3*t879
    t881 = l_f_1_2*t879
    t882 = (1/3)*l_f_2_2
    t883 = (1/3)*l_f_2_3
    t884 = t882 + t883
    t885 = (1/6)*R_p_2
    t886 = l_f_2_3*t885
    t887 = l_f_2_2*t885
    t888 = (1/3)*l_f_3_2
    t889 = (1/3)*l_f_3_3
    t890 = t888 + t889
    t891 = (1/6)*R_p_3
    t892 = l_f_3_3*t891
    t893 = l_f_3_2*t891
    t894 = l_f_1_1*t332
    t895 = (1/3)*t894
    t896 = (1/6)*t894
    t897 = l_f_2_1*t462
    t898 = (1/3)*t897
    t899 = (1/6)*t897
    t900 = l_f_3_1*t570
    t901 = (1/3)*t900
    t902 = (1/6)*t900
    t903 = -U_1_x_1**2 - U_1_y_1**2 - U_1_z_1**2
    t904 = -U_2_x_1**2 - U_2_y_1**2 - U_2_z_1**2
    t905 = -U_3_x_1**2 - U_3_y_1**2 - U_3_z_1**2
    t906 = -U_1_x_1*U_1_x_2 - U_1_y_1*U_1_y_2 - U_1_z_1*U_1_z_2
    t907 = -U_2_x_1*U_2_x_2 - U_2_y_1*U_2_y_2 - U_2_z_1*U_2_z_2
    t908 = -U_3_x_1*U_3_x_2 - U_3_y_1*U_3_y_2 - U_3_z_1*U_3_z_2
    t909 = mu_1_by_m_p*t906 + mu_2_by_m_p*t907 + mu_3_by_m_p*t908
    t910 = -U_1_x_1*U_1_x_3 - U_1_y_1*U_1_y_3 - U_1_z_1*U_1_z_3
    t911 = -U_2_x_1*U_2_x_3 - U_2_y_1*U_2_y_3 - U_2_z_1*U_2_z_3
    t912 = -U_3_x_1*U_3_x_3 - U_3_y_1*U_3_y_3 - U_3_z_1*U_3_z_3
    t913 = mu_1_by_m_p*t910 + mu_2_by_m_p*t911 + mu_3_by_m_p*t912
    t914 = -D_delta_x_1*U_1_x_1 - D_delta_y_1*U_1_y_1 - D_delta_z_1*U_1_z_1
    t915 = -D_delta_x_1*U_2_x_1 - D_delta_y_1*U_2_y_1 - D_delta_z_1*U_2_z_1
    t916 = -D_delta_x_1*U_3_x_1 - D_delta_y_1*U_3_y_1 - D_delta_z_1*U_3_z_1
    t917 = mu_1_by_m_p*t914 + mu_2_by_m_p*t915 + mu_3_by_m_p*t916
    t918 = -D_delta_x_2*U_1_x_1 - D_delta_y_2*U_1_y_1 - D_delta_z_2*U_1_z_1
    t919 = -D_delta_x_2*U_2_x_1 - D_delta_y_2*U_2_y_1 - D_delta_z_2*U_2_z_1
    t920 = -D_delta_x_2*U_3_x_1 - D_delta_y_2*U_3_y_1 - D_delta_z_2*U_3_z_1
    t921 = mu_1_by_m_p*t918 + mu_2_by_m_p*t919 + mu_3_by_m_p*t920
    t922 = -D_delta_x_3*U_1_x_1 - D_delta_y_3*U_1_y_1 - D_delta_z_3*U_1_z_1
    t923 = -D_delta_x_3*U_2_x_1 - D_delta_y_3*U_2_y_1 - D_delta_z_3*U_2_z_1
    t924 = -D_delta_x_3*U_3_x_1 - D_delta_y_3*U_3_y_1 - D_delta_z_3*U_3_z_1
    t925 = mu_1_by_m_p*t922 + mu_2_by_m_p*t923 + mu_3_by_m_p*t924
    t926 = -U_1_x_2**2 - U_1_y_2**2 - U_1_z_2**2
    t927 = -U_2_x_2**2 - U_2_y_2**2 - U_2_z_2**2
    t928 = -U_3_x_2**2 - U_3_y_2**2 - U_3_z_2**2
    t929 = -U_1_x_2*U_1_x_3 - U_1_y_2*U_1_y_3 - U_1_z_2*U_1_z_3
    t930 = -U_2_x_2*U_2_x_3 - U_2_y_2*U_2_y_3 - U_2_z_2*U_2_z_3
    t931 = -U_3_x_2*U_3_x_3 - U_3_y_2*U_3_y_3 - U_3_z_2*U_3_z_3
    t932 = mu_1_by_m_p*t929 + mu_2_by_m_p*t930 + mu_3_by_m_p*t931
    t933 = -D_delta_x_1*U_1_x_2 - D_delta_y_1*U_1_y_2 - D_delta_z_1*U_1_z_2
    t934 = -D_delta_x_1*U_2_x_2 - D_delta_y_1*U_2_y_2 - D_delta_z_1*U_2_z_2
    t935 = -D_delta_x_1*U_3_x_2 - D_delta_y_1*U_3_y_2 - D_delta_z_1*U_3_z_2
    t936 = mu_1_by_m_p*t933 + mu_2_by_m_p*t934 + mu_3_by_m_p*t935
    t937 = -D_delta_x_2*U_1_x_2 - D_delta_y_2*U_1_y_2 - D_delta_z_2*U_1_z_2
    t938 = -D_delta_x_2*U_2_x_2 - D_delta_y_2*U_2_y_2 - D_delta_z_2*U_2_z_2
    t939 = -D_delta_x_2*U_3_x_2 - D_delta_y_2*U_3_y_2 - D_delta_z_2*U_3_z_2
    t940 = mu_1_by_m_p*t937 + mu_2_by_m_p*t938 + mu_3_by_m_p*t939
    t941 = -D_delta_x_3*U_1_x_2 - D_delta_y_3*U_1_y_2 - D_delta_z_3*U_1_z_2
    t942 = -D_delta_x_3*U_2_x_2 - D_delta_y_3*U_2_y_2 - D_delta_z_3*U_2_z_2
    t943 = -D_delta_x_3*U_3_x_2 - D_delta_y_3*U_3_y_2 - D_delta_z_3*U_3_z_2
    t944 = mu_1_by_m_p*t941 + mu_2_by_m_p*t942 + mu_3_by_m_p*t943
    t945 = -U_1_x_3**2 - U_1_y_3**2 - U_1_z_3**2
    t946 = -U_2_x_3**2 - U_2_y_3**2 - U_2_z_3**2
    t947 = -U_3_x_3**2 - U_3_y_3**2 - U_3_z_3**2
    t948 = -D_delta_x_1*U_1_x_3 - D_delta_y_1*U_1_y_3 - D_delta_z_1*U_1_z_3
    t949 = -D_delta_x_1*U_2_x_3 - D_delta_y_1*U_2_y_3 - D_delta_z_1*U_2_z_3
    t950 = -D_delta_x_1*U_3_x_3 - D_delta_y_1*U_3_y_3 - D_delta_z_1*U_3_z_3
    t951 = mu_1_by_m_p*t948 + mu_2_by_m_p*t949 + mu_3_by_m_p*t950
    t952 = -D_delta_x_2*U_1_x_3 - D_delta_y_2*U_1_y_3 - D_delta_z_2*U_1_z_3
    t953 = -D_delta_x_2*U_2_x_3 - D_delta_y_2*U_2_y_3 - D_delta_z_2*U_2_z_3
    t954 = -D_delta_x_2*U_3_x_3 - D_delta_y_2*U_3_y_3 - D_delta_z_2*U_3_z_3
    t955 = mu_1_by_m_p*t952 + mu_2_by_m_p*t953 + mu_3_by_m_p*t954
    t956 = -D_delta_x_3*U_2_x_3 - D_delta_y_3*U_2_y_3 - D_delta_z_3*U_2_z_3
    t957 = -D_delta_x_3*U_3_x_3 - D_delta_y_3*U_3_y_3 - D_delta_z_3*U_3_z_3
    t958 = -D_delta_x_3*U_1_x_3 - D_delta_y_3*U_1_y_3 - D_delta_z_3*U_1_z_3
    t959 = mu_1_by_m_p*t958 + mu_2_by_m_p*t956 + mu_3_by_m_p*t957
    t960 = 1 - t238
    t961 = -mu_1_by_m_p*t242 - mu_2_by_m_p*t242 - mu_3_by_m_p*t242
    t962 = -mu_1_by_m_p*t246 - mu_2_by_m_p*t246 - mu_3_by_m_p*t246
    t963 = 1 - t250
    t964 = -mu_1_by_m_p*t254 - mu_2_by_m_p*t254 - mu_3_by_m_p*t254
    t965 = 1 - t258
    t966 = mu_1_by_g_x*t906 + mu_2_by_g_x*t907 + mu_3_by_g_x*t908
    t967 = mu_1_by_g_x*t910 + mu_2_by_g_x*t911 + mu_3_by_g_x*t912
    t968 = mu_1_by_g_x*t914 + mu_2_by_g_x*t915 + mu_3_by_g_x*t916
    t969 = mu_1_by_g_x*t918 + mu_2_by_g_x*t919 + mu_3_by_g_x*t920
    t970 = mu_1_by_g_x*t922 + mu_2_by_g_x*t923 + mu_3_by_g_x*t924
    t971 = mu_1_by_g_x*t929 + mu_2_by_g_x*t930 + mu_3_by_g_x*t931
    t972 = mu_1_by_g_x*t933 + mu_2_by_g_x*t934 + mu_3_by_g_x*t935
    t973 = mu_1_by_g_x*t937 + mu_2_by_g_x*t938 + mu_3_by_g_x*t939
    t974 = mu_1_by_g_x*t941 + mu_2_by_g_x*t942 + mu_3_by_g_x*t943
    t975 = mu_1_by_g_x*t948 + mu_2_by_g_x*t949 + mu_3_by_g_x*t950
    t976 = mu_1_by_g_x*t952 + mu_2_by_g_x*t953 + mu_3_by_g_x*t954
    t977 = mu_1_by_g_x*t958 + mu_2_by_g_x*t956 + mu_3_by_g_x*t957
    t978 = -mu_1_by_g_x*t242 - mu_2_by_g_x*t242 - mu_3_by_g_x*t242
    t979 = -mu_1_by_g_x*t246 - mu_2_by_g_x*t246 - mu_3_by_g_x*t246
    t980 = -mu_1_by_g_x*t254 - mu_2_by_g_x*t254 - mu_3_by_g_x*t254
    t981 = mu_1_by_g_y*t906 + mu_2_by_g_y*t907 + mu_3_by_g_y*t908
    t982 = mu_1_by_g_y*t910 + mu_2_by_g_y*t911 + mu_3_by_g_y*t912
    t983 = mu_1_by_g_y*t914 + mu_2_by_g_y*t915 + mu_3_by_g_y*t916
    t984 = mu_1_by_g_y*t918 + mu_2_by_g_y*t919 + mu_3_by_g_y*t920
    t985 = mu_1_by_g_y*t922 + mu_2_by_g_y*t923 + mu_3_by_g_y*t924
    t986 = mu_1_by_g_y*t929 + mu_2_by_g_y*t930 + mu_3_by_g_y*t931
    t987 = mu_1_by_g_y*t933 + mu_2_by_g_y*t934 + mu_3_by_g_y*t935
    t988 = mu_1_by_g_y*t937 + mu_2_by_g_y*t938 + mu_3_by_g_y*t939
    t989 = mu_1_by_g_y*t941 + mu_2_by_g_y*t942 + mu_3_by_g_y*t943
    t990 = mu_1_by_g_y*t948 + mu_2_by_g_y*t949 + mu_3_by_g_y*t950
    t991 = mu_1_by_g_y*t952 + mu_2_by_g_y*t953 + mu_3_by_g_y*t954
    t992 = mu_1_by_g_y*t958 + mu_2_by_g_y*t956 + mu_3_by_g_y*t957
    t993 = -mu_1_by_g_y*t242 - mu_2_by_g_y*t242 - mu_3_by_g_y*t242
    t994 = -mu_1_by_g_y*t246 - mu_2_by_g_y*t246 - mu_3_by_g_y*t246
    t995 = -mu_1_by_g_y*t254 - mu_2_by_g_y*t254 - mu_3_by_g_y*t254
    t996 = mu_1_by_g_z*t906 + mu_2_by_g_z*t907 + mu_3_by_g_z*t908
    t997 = mu_1_by_g_z*t910 + mu_2_by_g_z*t911 + mu_3_by_g_z*t912
    t998 = mu_1_by_g_z*t914 + mu_2_by_g_z*t915 + mu_3_by_g_z*t916
    t999 = mu_1_by_g_z*t918 + mu_2_by_g_z*t919 + mu_3_by_g_z*t920
    t1000 = mu_1_by_g_z*t922 + mu_2_by_g_z*t923 + mu_3_by_g_z*t924
    t1001 = mu_1_by_g_z*t929 + mu_2_by_g_z*t930 + mu_3_by_g_z*t931
    t1002 = mu_1_by_g_z*t933 + mu_2_by_g_z*t934 + mu_3_by_g_z*t935
    t1003 = mu_1_by_g_z*t937 + mu_2_by_g_z*t938 + mu_3_by_g_z*t939
    t1004 = mu_1_by_g_z*t941 + mu_2_by_g_z*t942 + mu_3_by_g_z*t943
    t1005 = mu_1_by_g_z*t948 + mu_2_by_g_z*t949 + mu_3_by_g_z*t950
    t1006 = mu_1_by_g_z*t952 + mu_2_by_g_z*t953 + mu_3_by_g_z*t954
    t1007 = mu_1_by_g_z*t958 + mu_2_by_g_z*t956 + mu_3_by_g_z*t957
    t1008 = -mu_1_by_g_z*t242 - mu_2_by_g_z*t242 - mu_3_by_g_z*t242
    t1009 = -mu_1_by_g_z*t246 - mu_2_by_g_z*t246 - mu_3_by_g_z*t246
    t1010 = -mu_1_by_g_z*t254 - mu_2_by_g_z*t254 - mu_3_by_g_z*t254
    t1011 = U_1_x_1*mu_1
    t1012 = 2*D_p_x_1_by_b_1_x
    t1013 = U_2_x_1*mu_2
    t1014 = U_3_x_1*mu_3
    t1015 = U_1_y_1*mu_1
    t1016 = 2*D_p_y_1_by_b_1_x
    t1017 = U_2_y_1*mu_2
    t1018 = U_3_y_1*mu_3
    t1019 = U_1_z_1*mu_1
    t1020 = 2*D_p_z_1_by_b_1_x
    t1021 = U_2_z_1*mu_2
    t1022 = U_3_z_1*mu_3
    t1023 = 1.0/(t18**2)
    t1024 = t1023*t13
    t1025 = t1024*x_1_by_b_1_x
    t1026 = 1.0/(t20**2)
    t1027 = U_1_x_2*mu_1
    t1028 = U_2_x_2*mu_2
    t1029 = U_3_x_2*mu_3
    t1030 = U_1_y_2*mu_1
    t1031 = U_2_y_2*mu_2
    t1032 = U_3_y_2*mu_3
    t1033 = U_1_z_2*mu_1
    t1034 = U_2_z_2*mu_2
    t1035 = U_3_z_2*mu_3
    t1036 = (
        D_p_x_1*D_p_x_2_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_2*k_C - D_p_x_1_by_b_1_x*t1027
        - D_p_x_1_by_b_1_x*t1028 - D_p_x_1_by_b_1_x*t1029 - D_p_x_2_by_b_1_x*t1011 - D_p_x_2_by_b_1_x*t1013
        - D_p_x_2_by_b_1_x*t1014 + D_p_y_1*D_p_y_2_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_2*k_C
        - D_p_y_1_by_b_1_x*t1030 - D_p_y_1_by_b_1_x*t1031 - D_p_y_1_by_b_1_x*t1032 - D_p_y_2_by_b_1_x*t1015
        - D_p_y_2_by_b_1_x*t1017 - D_p_y_2_by_b_1_x*t1018 + D_p_z_1*D_p_z_2_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_2*k_C - D_p_z_1_by_b_1_x*t1033 - D_p_z_1_by_b_1_x*t1034
        - D_p_z_1_by_b_1_x*t1035 - D_p_z_2_by_b_1_x*t1019 - D_p_z_2_by_b_1_x*t1021 - D_p_z_2_by_b_1_x*t1022
        + mu_1_by_b_1_x*t906 + mu_2_by_b_1_x*t907 + mu_3_by_b_1_x*t908
    )
    t1037 = U_1_x_3*mu_1
    t1038 = U_2_x_3*mu_2
    t1039 = U_3_x_3*mu_3
    t1040 = U_1_y_3*mu_1
    t1041 = U_2_y_3*mu_2
    t1042 = U_3_y_3*mu_3
    t1043 = U_1_z_3*mu_1
    t1044 = U_2_z_3*mu_2
    t1045 = U_3_z_3*mu_3
    t1046 = (
        D_p_x_1*D_p_x_3_by_b_1_x*k_C + D_p_x_1_by_b_1_x*D_p_x_3*k_C - D_p_x_1_by_b_1_x*t1037
        - D_p_x_1_by_b_1_x*t1038 - D_p_x_1_by_b_1_x*t1039 - D_p_x_3_by_b_1_x*t1011 - D_p_x_3_by_b_1_x*t1013
        - D_p_x_3_by_b_1_x*t1014 + D_p_y_1*D_p_y_3_by_b_1_x*k_C + D_p_y_1_by_b_1_x*D_p_y_3*k_C
        - D_p_y_1_by_b_1_x*t1040 - D_p_y_1_by_b_1_x*t1041 - D_p_y_1_by_b_1_x*t1042 - D_p_y_3_by_b_1_x*t1015
        - D_p_y_3_by_b_1_x*t1017 - D_p_y_3_by_b_1_x*t1018 + D_p_z_1*D_p_z_3_by_b_1_x*k_C
        + D_p_z_1_by_b_1_x*D_p_z_3*k_C - D_p_z_1_by_b_1_x*t1043 - D_p_z_1_by_b_1_x*t1044
        - D_p_z_1_by_b_1_x*t1045 - D_p_z_3_by_b_1_x*t1019 - D_p_z_3_by_b_1_x*t1021 - D_p_z_3_by_b_1_x*t1022
        + mu_1_by_b_1_x*t910 + mu_2_by_b_1_x*t911 + mu_3_by_b_1_x*t912
    )
    t1047 = t1026*t13
    t1048 = t1047*x_1_by_b_1_x
    t1049 = -R_p_1*t1048
    t1050 = R_p_1*t1025
    t1051 = D_p_x_1_by_b_1_x*k_C
    t1052 = D_p_y_1_by_b_1_x*k_C
    t1053 = D_p_z_1_by_b_1_x*k_C
    t1054 = D_delta_x_1*mu_1
    t1055 = D_delta_x_1*mu_2
    t1056 = D_delta_x_1*mu_3
    t1057 = D_delta_y_1*mu_1
    t1058 = D_delta_y_1*mu_2
    t1059 = D_delta_y_1*mu_3
    t1060 = D_delta_z_1*mu_1
    t1061 = D_delta_z_1*mu_2
    t1062 = D_delta_z_1*mu_3
    t1063 = D_p_x_1*k_C - t1011 - t1013 - t1014
    t1064 = D_p_y_1*k_C - t1015 - t1017 - t1018
    t1065 = D_p_z_1*k_C - t1019 - t1021 - t1022
    t1066 = (
        D_delta_x_1*t1051 + D_delta_x_1_by_b_1_x*t1063 + D_delta_y_1*t1052 + D_delta_y_1_by_b_1_x*t1064
        + D_delta_z_1*t1053 + D_delta_z_1_by_b_1_x*t1065 - D_p_x_1_by_b_1_x*t1054 - D_p_x_1_by_b_1_x*t1055
        - D_p_x_1_by_b_1_x*t1056 - D_p_y_1_by_b_1_x*t1057 - D_p_y_1_by_b_1_x*t1058 - D_p_y_1_by_b_1_x*t1059
        - D_p_z_1_by_b_1_x*t1060 - D_p_z_1_by_b_1_x*t1061 - D_p_z_1_by_b_1_x*t1062 + mu_1_by_b_1_x*t914
        + mu_2_by_b_1_x*t915 + mu_3_by_b_1_x*t916
    )
    t1067 = D_delta_x_2*mu_1
    t1068 = D_delta_x_2*mu_2
    t1069 = D_delta_x_2*mu_3
    t1070 = D_delta_y_2*mu_1
    t1071 = D_delta_y_2*mu_2
    t1072 = D_delta_y_2*mu_3
    t1073 = D_delta_z_2*mu_1
    t1074 = D_delta_z_2*mu_2
    t1075 = D_delta_z_2*mu_3
    t1076 = (
        D_delta_x_2*t1051 + D_delta_x_2_by_b_1_x*t1063 + D_delta_y_2*t1052 + D_delta_y_2_by_b_1_x*t1064
        + D_delta_z_2*t1053 + D_delta_z_2_by_b_1_x*t1065 - D_p_x_1_by_b_1_x*t1067 - D_p_x_1_by_b_1_x*t1068
        - D_p_x_1_by_b_1_x*t1069 - D_p_y_1_by_b_1_x*t1070 - D_p_y_1_by_b_1_x*t1071 - D_p_y_1_by_b_1_x*t1072
        - D_p_z_1_by_b_1_x*t1073 - D_p_z_1_by_b_1_x*t1074 - D_p_z_1_by_b_1_x*t1075 + mu_1_by_b_1_x*t918
        + mu_2_by_b_1_x*t919 + mu_3_by_b_1_x*t920
    )
    t1077 = D_delta_x_3*mu_1
    t1078 = D_delta_x_3*mu_2
    t1079 = D_delta_x_3*mu_3
    t1080 = D_delta_y_3*mu_1
    t1081 = D_delta_y_3*mu_2
    t1082 = D_delta_y_3*mu_3
    t1083 = D_delta_z_3*mu_1
    t1084 = D_delta_z_3*mu_2
    t1085 = D_delta_z_3*mu_3
    t1086 = (
        D_delta_x_3*t1051 + D_delta_x_3_by_b_1_x*t1063 + D_delta_y_3*t1052 + D_delta_y_3_by_b_1_x*t1064
        + D_delta_z_3*t1053 + D_delta_z_3_by_b_1_x*t1065 - D_p_x_1_by_b_1_x*t1077 - D_p_x_1_by_b_1_x*t1078
        - D_p_x_1_by_b_1_x*t1079 - D_p_y_1_by_b_1_x*t1080 - D_p_y_1_by_b_1_x*t1081 - D_p_y_1_by_b_1_x*t1082
        - D_p_z_1_by_b_1_x*t1083 - D_p_z_1_by_b_1_x*t1084 - D_p_z_1_by_b_1_x*t1085 + mu_1_by_b_1_x*t922
        + mu_2_by_b_1_x*t923 + mu_3_by_b_1_x*t924
    )
    t1087 = -t1025 + t1048
    t1088 = 2*D_p_x_2_by_b_1_x
    t1089 = 2*D_p_y_2_by_b_1_x
    t1090 = 2*D_p_z_2_by_b_1_x
    t1091 = (
        D_p_x_2*D_p_x_3_by_b_1_x*k_C + D_p_x_2_by_b_1_x*D_p_x_3*k_C - D_p_x_2_by_b_1_x*t1037
        - D_p_x_2_by_b_1_x*t1038 - D_p_x_2_by_b_1_x*t1039 - D_p_x_3_by_b_1_x*t1027 - D_p_x_3_by_b_1_x*t1028
        - D_p_x_3_by_b_1_x*t1029 + D_p_y_2*D_p_y_3_by_b_1_x*k_C + D_p_y_2_by_b_1_x*D_p_y_3*k_C
        - D_p_y_2_by_b_1_x*t1040 - D_p_y_2_by_b_1_x*t1041 - D_p_y_2_by_b_1_x*t1042 - D_p_y_3_by_b_1_x*t1030
        - D_p_y_3_by_b_1_x*t1031 - D_p_y_3_by_b_1_x*t1032 + D_p_z_2*D_p_z_3_by_b_1_x*k_C
        + D_p_z_2_by_b_1_x*D_p_z_3*k_C - D_p_z_2_by_b_1_x*t1043 - D_p_z_2_by_b_1_x*t1044
        - D_p_z_2_by_b_1_x*t1045 - D_p_z_3_by_b_1_x*t1033 - D_p_z_3_by_b_1_x*t1034 - D_p_z_3_by_b_1_x*t1035
        + mu_1_by_b_1_x*t929 + mu_2_by_b_1_x*t930 + mu_3_by_b_1_x*t931
    )
    t1092 = D_p_x_2_by_b_1_x*k_C
    t1093 = D_p_y_2_by_b_1_x*k_C
    t1094 = D_p_z_2_by_b_1_x*k_C
    t1095 = D_p_x_2*k_C - t1027 - t1028 - t1029
    t1096 = D_p_y_2*k_C - t1030 - t1031 - t1032
    t1097 = D_p_z_2*k_C - t1033 - t1034 - t1035
    t1098 = (
        D_delta_x_1*t1092 + D_delta_x_1_by_b_1_x*t1095 + D_delta_y_1*t1093 + D_delta_y_1_by_b_1_x*t1096
        + D_delta_z_1*t1094 + D_delta_z_1_by_b_1_x*t1097 - D_p_x_2_by_b_1_x*t1054 - D_p_x_2_by_b_1_x*t1055
        - D_p_x_2_by_b_1_x*t1056 - D_p_y_2_by_b_1_x*t1057 - D_p_y_2_by_b_1_x*t1058 - D_p_y_2_by_b_1_x*t1059
        - D_p_z_2_by_b_1_x*t1060 - D_p_z_2_by_b_1_x*t1061 - D_p_z_2_by_b_1_x*t1062 + mu_1_by_b_1_x*t933
        + mu_2_by_b_1_x*t934 + mu_3_by_b_1_x*t935
    )
    t1099 = (
        D_delta_x_2*t1092 + D_delta_x_2_by_b_1_x*t1095 + D_delta_y_2*t1093 + D_delta_y_2_by_b_1_x*t1096
        + D_delta_z_2*t1094 + D_delta_z_2_by_b_1_x*t1097 - D_p_x_2_by_b_1_x*t1067 - D_p_x_2_by_b_1_x*t1068
        - D_p_x_2_by_b_1_x*t1069 - D_p_y_2_by_b_1_x*t1070 - D_p_y_2_by_b_1_x*t1071 - D_p_y_2_by_b_1_x*t1072
        - D_p_z_2_by_b_1_x*t1073 - D_p_z_2_by_b_1_x*t1074 - D_p_z_2_by_b_1_x*t1075 + mu_1_by_b_1_x*t937
        + mu_2_by_b_1_x*t938 + mu_3_by_b_1_x*t939
    )
    t1100 = (
        D_delta_x_3*t1092 + D_delta_x_3_by_b_1_x*t1095 + D_delta_y_3*t1093 + D_delta_y_3_by_b_1_x*t1096
        + D_delta_z_3*t1094 + D_delta_z_3_by_b_1_x*t1097 - D_p_x_2_by_b_1_x*t1077 - D_p_x_2_by_b_1_x*t1078
        - D_p_x_2_by_b_1_x*t1079 - D_p_y_2_by_b_1_x*t1080 - D_p_y_2_by_b_1_x*t1081 - D_p_y_2_by_b_1_x*t1082
        - D_p_z_2_by_b_1_x*t1083 - D_p_z_2_by_b_1_x*t1084 - D_p_z_2_by_b_1_x*t1085 + mu_1_by_b_1_x*t941
        + mu_2_by_b_1_x*t942 + mu_3_by_b_1_x*t943
    )
    t1101 = 2*D_p_x_3_by_b_1_x
    t1102 = 2*D_p_y_3_by_b_1_x
    t1103 = 2*D_p_z_3_by_b_1_x
    t1104 = D_p_x_3_by_b_1_x*k_C
    t1105 = D_p_y_3_by_b_1_x*k_C
    t1106 = D_p_z_3_by_b_1_x*k_C
    t1107 = D_p_x_3*k_C - t1037 - t1038 - t1039
    t1108 = D_p_y_3*k_C - t1040 - t1041 - t1042
    t1109 = D_p_z_3*k_C - t1043 - t1044 - t1045
    t1110 = (
        D_delta_x_1*t1104 + D_delta_x_1_by_b_1_x*t1107 + D_delta_y_1*t1105 + D_delta_y_1_by_b_1_x*t1108
        + D_delta_z_1*t1106 + D_delta_z_1_by_b_1_x*t1109 - D_p_x_3_by_b_1_x*t1054 - D_p_x_3_by_b_1_x*t1055
        - D_p_x_3_by_b_1_x*t1056 - D_p_y_3_by_b_1_x*t1057 - D_p_y_3_by_b_1_x*t1058 - D_p_y_3_by_b_1_x*t1059
        - D_p_z_3_by_b_1_x*t1060 - D_p_z_3_by_b_1_x*t1061 - D_p_z_3_by_b_1_x*t1062 + mu_1_by_b_1_x*t948
        + mu_2_by_b_1_x*t949 + mu_3_by_b_1_x*t950
    )
    t1111 = (
        D_delta_x_2*t1104 + D_delta_x_2_by_b_1_x*t1107 + D_delta_y_2*t1105 + D_delta_y_2_by_b_1_x*t1108
        + D_delta_z_2*t1106 + D_delta_z_2_by_b_1_x*t1109 - D_p_x_3_by_b_1_x*t1067 - D_p_x_3_by_b_1_x*t1068
        - D_p_x_3_by_b_1_x*t1069 - D_p_y_3_by_b_1_x*t1070 - D_p_y_3_by_b_1_x*t1071 - D_p_y_3_by_b_1_x*t1072
        - D_p_z_3_by_b_1_x*t1073 - D_p_z_3_by_b_1_x*t1074 - D_p_z_3_by_b_1_x*t1075 + mu_1_by_b_1_x*t952
        + mu_2_by_b_1_x*t953 + mu_3_by_b_1_x*t954
    )
    t1112 = (
        D_delta_x_3*t1104 + D_delta_x_3_by_b_1_x*t1107 + D_delta_y_3*t1105 + D_delta_y_3_by_b_1_x*t1108
        + D_delta_z_3*t1106 + D_delta_z_3_by_b_1_x*t1109 - D_p_x_3_by_b_1_x*t1077 - D_p_x_3_by_b_1_x*t1078
        - D_p_x_3_by_b_1_x*t1079 - D_p_y_3_by_b_1_x*t1080 - D_p_y_3_by_b_1_x*t1081 - D_p_y_3_by_b_1_x*t1082
        - D_p_z_3_by_b_1_x*t1083 - D_p_z_3_by_b_1_x*t1084 - D_p_z_3_by_b_1_x*t1085 + mu_1_by_b_1_x*t958
        + mu_2_by_b_1_x*t956 + mu_3_by_b_1_x*t957
    )
    t1113 = 2*D_delta_x_1*k_C - 2*t1054 - 2*t1055 - 2*t1056
    t1114 = 2*D_delta_y_1*k_C - 2*t1057 - 2*t1058 - 2*t1059
    t1115 = 2*D_delta_z_1*k_C - 2*t1060 - 2*t1061 - 2*t1062
    t1116 = D_delta_x_2*k_C - t1067 - t1068 - t1069
    t1117 = D_delta_x_1*k_C - t1054 - t1055 - t1056
    t1118 = D_delta_y_2*k_C - t1070 - t1071 - t1072
    t1119 = D_delta_y_1*k_C - t1057 - t1058 - t1059
    t1120 = D_delta_z_2*k_C - t1073 - t1074 - t1075
    t1121 = D_delta_z_1*k_C - t1060 - t1061 - t1062
    t1122 = (
        D_delta_x_1_by_b_1_x*t1116 + D_delta_x_2_by_b_1_x*t1117 + D_delta_y_1_by_b_1_x*t1118
        + D_delta_y_2_by_b_1_x*t1119 + D_delta_z_1_by_b_1_x*t1120 + D_delta_z_2_by_b_1_x*t1121
        - mu_1_by_b_1_x*t242 - mu_2_by_b_1_x*t242 - mu_3_by_b_1_x*t242
    )
    t1123 = D_delta_x_3*k_C - t1077 - t1078 - t1079
    t1124 = D_delta_y_3*k_C - t1080 - t1081 - t1082
    t1125 = D_delta_z_3*k_C - t1083 - t1084 - t1085
    t1126 = (
        D_delta_x_1_by_b_1_x*t1123 + D_delta_x_3_by_b_1_x*t1117 + D_delta_y_1_by_b_1_x*t1124
        + D_delta_y_3_by_b_1_x*t1119 + D_delta_z_1_by_b_1_x*t1125 + D_delta_z_3_by_b_1_x*t1121
        - mu_1_by_b_1_x*t246 - mu_2_by_b_1_x*t246 - mu_3_by_b_1_x*t246
    )
    t1127 = D_delta_x_1_by_b_1_x*k_C
    t1128 = D_delta_y_1_by_b_1_x*k_C
    t1129 = D_delta_z_1_by_b_1_x*k_C
    t1130 = 2*D_delta_x_2*k_C - 2*t1067 - 2*t1068 - 2*t1069
    t1131 = 2*D_delta_y_2*k_C - 2*t1070 - 2*t1071 - 2*t1072
    t1132 = 2*D_delta_z_2*k_C - 2*t1073 - 2*t1074 - 2*t1075
    t1133 = (
        D_delta_x_2_by_b_1_x*t1123 + D_delta_x_3_by_b_1_x*t1116 + D_delta_y_2_by_b_1_x*t1124
        + D_delta_y_3_by_b_1_x*t1118 + D_delta_z_2_by_b_1_x*t1125 + D_delta_z_3_by_b_1_x*t1120
        - mu_1_by_b_1_x*t254 - mu_2_by_b_1_x*t254 - mu_3_by_b_1_x*t254
    )
    t1134 = D_delta_x_2_by_b_1_x*k_C
    t1135 = D_delta_y_2_by_b_1_x*k_C
    t1136 = D_delta_z_2_by_b_1_x*k_C
    t1137 = 2*D_delta_x_3*k_C - 2*t1077 - 2*t1078 - 2*t1079
    t1138 = 2*D_delta_y_3*k_C - 2*t1080 - 2*t1081 - 2*t1082
    t1139 = 2*D_delta_z_3*k_C - 2*t1083 - 2*t1084 - 2*t1085
    t1140 = D_delta_x_3_by_b_1_x*k_C
    t1141 = D_delta_y_3_by_b_1_x*k_C
    t1142 = D_delta_z_3_by_b_1_x*k_C
    t1143 = 2*D_p_x_1_by_b_1_y
    t1144 = 2*D_p_y_1_by_b_1_y
    t1145 = 2*D_p_z_1_by_b_1_y
    t1146 = t1024*x_1_by_b_1_y
    t1147 = (
        D_p_x_1*D_p_x_2_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_2*k_C - D_p_x_1_by_b_1_y*t1027
        - D_p_x_1_by_b_1_y*t1028 - D_p_x_1_by_b_1_y*t1029 - D_p_x_2_by_b_1_y*t1011 - D_p_x_2_by_b_1_y*t1013
        - D_p_x_2_by_b_1_y*t1014 + D_p_y_1*D_p_y_2_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_2*k_C
        - D_p_y_1_by_b_1_y*t1030 - D_p_y_1_by_b_1_y*t1031 - D_p_y_1_by_b_1_y*t1032 - D_p_y_2_by_b_1_y*t1015
        - D_p_y_2_by_b_1_y*t1017 - D_p_y_2_by_b_1_y*t1018 + D_p_z_1*D_p_z_2_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_2*k_C - D_p_z_1_by_b_1_y*t1033 - D_p_z_1_by_b_1_y*t1034
        - D_p_z_1_by_b_1_y*t1035 - D_p_z_2_by_b_1_y*t1019 - D_p_z_2_by_b_1_y*t1021 - D_p_z_2_by_b_1_y*t1022
        + mu_1_by_b_1_y*t906 + mu_2_by_b_1_y*t907 + mu_3_by_b_1_y*t908
    )
    t1148 = (
        D_p_x_1*D_p_x_3_by_b_1_y*k_C + D_p_x_1_by_b_1_y*D_p_x_3*k_C - D_p_x_1_by_b_1_y*t1037
        - D_p_x_1_by_b_1_y*t1038 - D_p_x_1_by_b_1_y*t1039 - D_p_x_3_by_b_1_y*t1011 - D_p_x_3_by_b_1_y*t1013
        - D_p_x_3_by_b_1_y*t1014 + D_p_y_1*D_p_y_3_by_b_1_y*k_C + D_p_y_1_by_b_1_y*D_p_y_3*k_C
        - D_p_y_1_by_b_1_y*t1040 - D_p_y_1_by_b_1_y*t1041 - D_p_y_1_by_b_1_y*t1042 - D_p_y_3_by_b_1_y*t1015
        - D_p_y_3_by_b_1_y*t1017 - D_p_y_3_by_b_1_y*t1018 + D_p_z_1*D_p_z_3_by_b_1_y*k_C
        + D_p_z_1_by_b_1_y*D_p_z_3*k_C - D_p_z_1_by_b_1_y*t1043 - D_p_z_1_by_b_1_y*t1044
        - D_p_z_1_by_b_1_y*t1045 - D_p_z_3_by_b_1_y*t1019 - D_p_z_3_by_b_1_y*t1021 - D_p_z_3_by_b_1_y*t1022
        + mu_1_by_b_1_y*t910 + mu_2_by_b_1_y*t911 + mu_3_by_b_1_y*t912
    )
    t1149 = t1047*x_1_by_b_1_y
    t1150 = -R_p_1*t1149
    t1151 = R_p_1*t1146
    t1152 = D_delta_x_1*k_C
    t1153 = D_delta_y_1*k_C
    t1154 = D_delta_z_1*k_C
    t1155 = (
        D_delta_x_1_by_b_1_y*t1063 + D_delta_y_1_by_b_1_y*t1064 + D_delta_z_1_by_b_1_y*t1065
        - D_p_x_1_by_b_1_y*t1054 - D_p_x_1_by_b_1_y*t1055 - D_p_x_1_by_b_1_y*t1056 + D_p_x_1_by_b_1_y*t1152
        - D_p_y_1_by_b_1_y*t1057 - D_p_y_1_by_b_1_y*t1058 - D_p_y_1_by_b_1_y*t1059 + D_p_y_1_by_b_1_y*t1153
        - D_p_z_1_by_b_1_y*t1060 - D_p_z_1_by_b_1_y*t1061 - D_p_z_1_by_b_1_y*t1062 + D_p_z_1_by_b_1_y*t1154
        + mu_1_by_b_1_y*t914 + mu_2_by_b_1_y*t915 + mu_3_by_b_1_y*t916
    )
    t1156 = D_delta_x_2*k_C
    t1157 = D_delta_y_2*k_C
    t1158 = D_delta_z_2*k_C
    t1159 = (
        D_delta_x_2_by_b_1_y*t1063 + D_delta_y_2_by_b_1_y*t1064 + D_delta_z_2_by_b_1_y*t1065
        - D_p_x_1_by_b_1_y*t1067 - D_p_x_1_by_b_1_y*t1068 - D_p_x_1_by_b_1_y*t1069 + D_p_x_1_by_b_1_y*t1156
        - D_p_y_1_by_b_1_y*t1070 - D_p_y_1_by_b_1_y*t1071 - D_p_y_1_by_b_1_y*t1072 + D_p_y_1_by_b_1_y*t1157
        - D_p_z_1_by_b_1_y*t1073 - D_p_z_1_by_b_1_y*t1074 - D_p_z_1_by_b_1_y*t1075 + D_p_z_1_by_b_1_y*t1158
        + mu_1_by_b_1_y*t918 + mu_2_by_b_1_y*t919 + mu_3_by_b_1_y*t920
    )
    t1160 = D_delta_x_3*k_C
    t1161 = D_delta_y_3*k_C
    t1162 = D_delta_z_3*k_C
    t1163 = (
        D_delta_x_3_by_b_1_y*t1063 + D_delta_y_3_by_b_1_y*t1064 + D_delta_z_3_by_b_1_y*t1065
        - D_p_x_1_by_b_1_y*t1077 - D_p_x_1_by_b_1_y*t1078 - D_p_x_1_by_b_1_y*t1079 + D_p_x_1_by_b_1_y*t1160
        - D_p_y_1_by_b_1_y*t1080 - D_p_y_1_by_b_1_y*t1081 - D_p_y_1_by_b_1_y*t1082 + D_p_y_1_by_b_1_y*t1161
        - D_p_z_1_by_b_1_y*t1083 - D_p_z_1_by_b_1_y*t1084 - D_p_z_1_by_b_1_y*t1085 + D_p_z_1_by_b_1_y*t1162
        + mu_1_by_b_1_y*t922 + mu_2_by_b_1_y*t923 + mu_3_by_b_1_y*t924
    )
    t1164 = -t1146 + t1149
    t1165 = D_p_x_1_by_b_1_y*k_C
    t1166 = D_p_y_1_by_b_1_y*k_C
    t1167 = D_p_z_1_by_b_1_y*k_C
    t1168 = 2*D_p_x_2_by_b_1_y
    t1169 = 2*D_p_y_2_by_b_1_y
    t1170 = 2*D_p_z_2_by_b_1_y
    t1171 = (
        D_p_x_2*D_p_x_3_by_b_1_y*k_C + D_p_x_2_by_b_1_y*D_p_x_3*k_C - D_p_x_2_by_b_1_y*t1037
        - D_p_x_2_by_b_1_y*t1038 - D_p_x_2_by_b_1_y*t1039 - D_p_x_3_by_b_1_y*t1027 - D_p_x_3_by_b_1_y*t1028
        - D_p_x_3_by_b_1_y*t1029 + D_p_y_2*D_p_y_3_by_b_1_y*k_C + D_p_y_2_by_b_1_y*D_p_y_3*k_C
        - D_p_y_2_by_b_1_y*t1040 - D_p_y_2_by_b_1_y*t1041 - D_p_y_2_by_b_1_y*t1042 - D_p_y_3_by_b_1_y*t1030
        - D_p_y_3_by_b_1_y*t1031 - D_p_y_3_by_b_1_y*t1032 + D_p_z_2*D_p_z_3_by_b_1_y*k_C
        + D_p_z_2_by_b_1_y*D_p_z_3*k_C - D_p_z_2_by_b_1_y*t1043 - D_p_z_2_by_b_1_y*t1044
        - D_p_z_2_by_b_1_y*t1045 - D_p_z_3_by_b_1_y*t1033 - D_p_z_3_by_b_1_y*t1034 - D_p_z_3_by_b_1_y*t1035
        + mu_1_by_b_1_y*t929 + mu_2_by_b_1_y*t930 + mu_3_by_b_1_y*t931
    )
    t1172 = (
        D_delta_x_1_by_b_1_y*t1095 + D_delta_y_1_by_b_1_y*t1096 + D_delta_z_1_by_b_1_y*t1097
        - D_p_x_2_by_b_1_y*t1054 - D_p_x_2_by_b_1_y*t1055 - D_p_x_2_by_b_1_y*t1056 + D_p_x_2_by_b_1_y*t1152
        - D_p_y_2_by_b_1_y*t1057 - D_p_y_2_by_b_1_y*t1058 - D_p_y_2_by_b_1_y*t1059 + D_p_y_2_by_b_1_y*t1153
        - D_p_z_2_by_b_1_y*t1060 - D_p_z_2_by_b_1_y*t1061 - D_p_z_2_by_b_1_y*t1062 + D_p_z_2_by_b_1_y*t1154
        + mu_1_by_b_1_y*t933 + mu_2_by_b_1_y*t934 + mu_3_by_b_1_y*t935
    )
    t1173 = (
        D_delta_x_2_by_b_1_y*t1095 + D_delta_y_2_by_b_1_y*t1096 + D_delta_z_2_by_b_1_y*t1097
        - D_p_x_2_by_b_1_y*t1067 - D_p_x_2_by_b_1_y*t1068 - D_p_x_2_by_b_1_y*t1069 + D_p_x_2_by_b_1_y*t1156
        - D_p_y_2_by_b_1_y*t1070 - D_p_y_2_by_b_1_y*t1071 - D_p_y_2_by_b_1_y*t1072 + D_p_y_2_by_b_1_y*t1157
        - D_p_z_2_by_b_1_y*t1073 - D_p_z_2_by_b_1_y*t1074 - D_p_z_2_by_b_1_y*t1075 + D_p_z_2_by_b_1_y*t1158
        + mu_1_by_b_1_y*t937 + mu_2_by_b_1_y*t938 + mu_3_by_b_1_y*t939
    )
    t1174 = (
        D_delta_x_3_by_b_1_y*t1095 + D_delta_y_3_by_b_1_y*t1096 + D_delta_z_3_by_b_1_y*t1097
        - D_p_x_2_by_b_1_y*t1077 - D_p_x_2_by_b_1_y*t1078 - D_p_x_2_by_b_1_y*t1079 + D_p_x_2_by_b_1_y*t1160
        - D_p_y_2_by_b_1_y*t1080 - D_p_y_2_by_b_1_y*t1081 - D_p_y_2_by_b_1_y*t1082 + D_p_y_2_by_b_1_y*t1161
        - D_p_z_2_by_b_1_y*t1083 - D_p_z_2_by_b_1_y*t1084 - D_p_z_2_by_b_1_y*t1085 + D_p_z_2_by_b_1_y*t1162
        + mu_1_by_b_1_y*t941 + mu_2_by_b_1_y*t942 + mu_3_by_b_1_y*t943
    )
    t1175 = D_p_x_2_by_b_1_y*k_C
    t1176 = D_p_y_2_by_b_1_y*k_C
    t1177 = D_p_z_2_by_b_1_y*k_C
    t1178 = 2*D_p_x_3_by_b_1_y
    t1179 = 2*D_p_y_3_by_b_1_y
    t1180 = 2*D_p_z_3_by_b_1_y
    t1181 = (
        D_delta_x_1_by_b_1_y*t1107 + D_delta_y_1_by_b_1_y*t1108 + D_delta_z_1_by_b_1_y*t1109
        - D_p_x_3_by_b_1_y*t1054 - D_p_x_3_by_b_1_y*t1055 - D_p_x_3_by_b_1_y*t1056 + D_p_x_3_by_b_1_y*t1152
        - D_p_y_3_by_b_1_y*t1057 - D_p_y_3_by_b_1_y*t1058 - D_p_y_3_by_b_1_y*t1059 + D_p_y_3_by_b_1_y*t1153
        - D_p_z_3_by_b_1_y*t1060 - D_p_z_3_by_b_1_y*t1061 - D_p_z_3_by_b_1_y*t1062 + D_p_z_3_by_b_1_y*t1154
        + mu_1_by_b_1_y*t948 + mu_2_by_b_1_y*t949 + mu_3_by_b_1_y*t950
    )
    t1182 = (
        D_delta_x_2_by_b_1_y*t1107 + D_delta_y_2_by_b_1_y*t1108 + D_delta_z_2_by_b_1_y*t1109
        - D_p_x_3_by_b_1_y*t1067 - D_p_x_3_by_b_1_y*t1068 - D_p_x_3_by_b_1_y*t1069 + D_p_x_3_by_b_1_y*t1156
        - D_p_y_3_by_b_1_y*t1070 - D_p_y_3_by_b_1_y*t1071 - D_p_y_3_by_b_1_y*t1072 + D_p_y_3_by_b_1_y*t1157
        - D_p_z_3_by_b_1_y*t1073 - D_p_z_3_by_b_1_y*t1074 - D_p_z_3_by_b_1_y*t1075 + D_p_z_3_by_b_1_y*t1158
        + mu_1_by_b_1_y*t952 + mu_2_by_b_1_y*t953 + mu_3_by_b_1_y*t954
    )
    t1183 = (
        D_delta_x_3_by_b_1_y*t1107 + D_delta_y_3_by_b_1_y*t1108 + D_delta_z_3_by_b_1_y*t1109
        - D_p_x_3_by_b_1_y*t1077 - D_p_x_3_by_b_1_y*t1078 - D_p_x_3_by_b_1_y*t1079 + D_p_x_3_by_b_1_y*t1160
        - D_p_y_3_by_b_1_y*t1080 - D_p_y_3_by_b_1_y*t1081 - D_p_y_3_by_b_1_y*t1082 + D_p_y_3_by_b_1_y*t1161
        - D_p_z_3_by_b_1_y*t1083 - D_p_z_3_by_b_1_y*t1084 - D_p_z_3_by_b_1_y*t1085 + D_p_z_3_by_b_1_y*t1162
        + mu_1_by_b_1_y*t958 + mu_2_by_b_1_y*t956 + mu_3_by_b_1_y*t957
    )
    t1184 = D_p_x_3_by_b_1_y*k_C
    t1185 = D_p_y_3_by_b_1_y*k_C
    t1186 = D_p_z_3_by_b_1_y*k_C
    t1187 = (
        D_delta_x_1_by_b_1_y*t1116 + D_delta_x_2_by_b_1_y*t1117 + D_delta_y_1_by_b_1_y*t1118
        + D_delta_y_2_by_b_1_y*t1119 + D_delta_z_1_by_b_1_y*t1120 + D_delta_z_2_by_b_1_y*t1121
        - mu_1_by_b_1_y*t242 - mu_2_by_b_1_y*t242 - mu_3_by_b_1_y*t242
    )
    t1188 = (
        D_delta_x_1_by_b_1_y*t1123 + D_delta_x_3_by_b_1_y*t1117 + D_delta_y_1_by_b_1_y*t1124
        + D_delta_y_3_by_b_1_y*t1119 + D_delta_z_1_by_b_1_y*t1125 + D_delta_z_3_by_b_1_y*t1121
        - mu_1_by_b_1_y*t246 - mu_2_by_b_1_y*t246 - mu_3_by_b_1_y*t246
    )
    t1189 = D_delta_x_1_by_b_1_y*k_C
    t1190 = D_delta_y_1_by_b_1_y*k_C
    t1191 = D_delta_z_1_by_b_1_y*k_C
    t1192 = (
        D_delta_x_2_by_b_1_y*t1123 + D_delta_x_3_by_b_1_y*t1116 + D_delta_y_2_by_b_1_y*t1124
        + D_delta_y_3_by_b_1_y*t1118 + D_delta_z_2_by_b_1_y*t1125 + D_delta_z_3_by_b_1_y*t1120
        - mu_1_by_b_1_y*t254 - mu_2_by_b_1_y*t254 - mu_3_by_b_1_y*t254
    )
    t1193 = D_delta_x_2_by_b_1_y*k_C
    t1194 = D_delta_y_2_by_b_1_y*k_C
    t1195 = D_delta_z_2_by_b_1_y*k_C
    t1196 = D_delta_x_3_by_b_1_y*k_C
    t1197 = D_delta_y_3_by_b_1_y*k_C
    t1198 = D_delta_z_3_by_b_1_y*k_C
    t1199 = 2*D_p_x_1_by_b_1_z
    t1200 = 2*D_p_y_1_by_b_1_z
    t1201 = 2*D_p_z_1_by_b_1_z
    t1202 = t1024*x_1_by_b_1_z
    t1203 = (
        D_p_x_1*D_p_x_2_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_2*k_C - D_p_x_1_by_b_1_z*t1027
        - D_p_x_1_by_b_1_z*t1028 - D_p_x_1_by_b_1_z*t1029 - D_p_x_2_by_b_1_z*t1011 - D_p_x_2_by_b_1_z*t1013
        - D_p_x_2_by_b_1_z*t1014 + D_p_y_1*D_p_y_2_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_2*k_C
        - D_p_y_1_by_b_1_z*t1030 - D_p_y_1_by_b_1_z*t1031 - D_p_y_1_by_b_1_z*t1032 - D_p_y_2_by_b_1_z*t1015
        - D_p_y_2_by_b_1_z*t1017 - D_p_y_2_by_b_1_z*t1018 + D_p_z_1*D_p_z_2_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_2*k_C - D_p_z_1_by_b_1_z*t1033 - D_p_z_1_by_b_1_z*t1034
        - D_p_z_1_by_b_1_z*t1035 - D_p_z_2_by_b_1_z*t1019 - D_p_z_2_by_b_1_z*t1021 - D_p_z_2_by_b_1_z*t1022
        + mu_1_by_b_1_z*t906 + mu_2_by_b_1_z*t907 + mu_3_by_b_1_z*t908
    )
    t1204 = (
        D_p_x_1*D_p_x_3_by_b_1_z*k_C + D_p_x_1_by_b_1_z*D_p_x_3*k_C - D_p_x_1_by_b_1_z*t1037
        - D_p_x_1_by_b_1_z*t1038 - D_p_x_1_by_b_1_z*t1039 - D_p_x_3_by_b_1_z*t1011 - D_p_x_3_by_b_1_z*t1013
        - D_p_x_3_by_b_1_z*t1014 + D_p_y_1*D_p_y_3_by_b_1_z*k_C + D_p_y_1_by_b_1_z*D_p_y_3*k_C
        - D_p_y_1_by_b_1_z*t1040 - D_p_y_1_by_b_1_z*t1041 - D_p_y_1_by_b_1_z*t1042 - D_p_y_3_by_b_1_z*t1015
        - D_p_y_3_by_b_1_z*t1017 - D_p_y_3_by_b_1_z*t1018 + D_p_z_1*D_p_z_3_by_b_1_z*k_C
        + D_p_z_1_by_b_1_z*D_p_z_3*k_C - D_p_z_1_by_b_1_z*t1043 - D_p_z_1_by_b_1_z*t1044
        - D_p_z_1_by_b_1_z*t1045 - D_p_z_3_by_b_1_z*t1019 - D_p_z_3_by_b_1_z*t1021 - D_p_z_3_by_b_1_z*t1022
        + mu_1_by_b_1_z*t910 + mu_2_by_b_1_z*t911 + mu_3_by_b_1_z*t912
    )
    t1205 = t1047*x_1_by_b_1_z
    t1206 = -R_p_1*t1205
    t1207 = R_p_1*t1202
    t1208 = (
        D_delta_x_1_by_b_1_z*t1063 + D_delta_y_1_by_b_1_z*t1064 + D_delta_z_1_by_b_1_z*t1065
        - D_p_x_1_by_b_1_z*t1054 - D_p_x_1_by_b_1_z*t1055 - D_p_x_1_by_b_1_z*t1056 + D_p_x_1_by_b_1_z*t1152
        - D_p_y_1_by_b_1_z*t1057 - D_p_y_1_by_b_1_z*t1058 - D_p_y_1_by_b_1_z*t1059 + D_p_y_1_by_b_1_z*t1153
        - D_p_z_1_by_b_1_z*t1060 - D_p_z_1_by_b_1_z*t1061 - D_p_z_1_by_b_1_z*t1062 + D_p_z_1_by_b_1_z*t1154
        + mu_1_by_b_1_z*t914 + mu_2_by_b_1_z*t915 + mu_3_by_b_1_z*t916
    )
    t1209 = (
        D_delta_x_2_by_b_1_z*t1063 + D_delta_y_2_by_b_1_z*t1064 + D_delta_z_2_by_b_1_z*t1065
        - D_p_x_1_by_b_1_z*t1067 - D_p_x_1_by_b_1_z*t1068 - D_p_x_1_by_b_1_z*t1069 + D_p_x_1_by_b_1_z*t1156
        - D_p_y_1_by_b_1_z*t1070 - D_p_y_1_by_b_1_z*t1071 - D_p_y_1_by_b_1_z*t1072 + D_p_y_1_by_b_1_z*t1157
        - D_p_z_1_by_b_1_z*t1073 - D_p_z_1_by_b_1_z*t1074 - D_p_z_1_by_b_1_z*t1075 + D_p_z_1_by_b_1_z*t1158
        + mu_1_by_b_1_z*t918 + mu_2_by_b_1_z*t919 + mu_3_by_b_1_z*t920
    )
    t1210 = (
        D_delta_x_3_by_b_1_z*t1063 + D_delta_y_3_by_b_1_z*t1064 + D_delta_z_3_by_b_1_z*t1065
        - D_p_x_1_by_b_1_z*t1077 - D_p_x_1_by_b_1_z*t1078 - D_p_x_1_by_b_1_z*t1079 + D_p_x_1_by_b_1_z*t1160
        - D_p_y_1_by_b_1_z*t1080 - D_p_y_1_by_b_1_z*t1081 - D_p_y_1_by_b_1_z*t1082 + D_p_y_1_by_b_1_z*t1161
        - D_p_z_1_by_b_1_z*t1083 - D_p_z_1_by_b_1_z*t1084 - D_p_z_1_by_b_1_z*t1085 + D_p_z_1_by_b_1_z*t1162
        + mu_1_by_b_1_z*t922 + mu_2_by_b_1_z*t923 + mu_3_by_b_1_z*t924
    )
    t1211 = -t1202 + t1205
    t1212 = D_p_x_1_by_b_1_z*k_C
    t1213 = D_p_y_1_by_b_1_z*k_C
    t1214 = D_p_z_1_by_b_1_z*k_C
    t1215 = 2*D_p_x_2_by_b_1_z
    t1216 = 2*D_p_y_2_by_b_1_z
    t1217 = 2*D_p_z_2_by_b_1_z
    t1218 = (
        D_p_x_2*D_p_x_3_by_b_1_z*k_C + D_p_x_2_by_b_1_z*D_p_x_3*k_C - D_p_x_2_by_b_1_z*t1037
        - D_p_x_2_by_b_1_z*t1038 - D_p_x_2_by_b_1_z*t1039 - D_p_x_3_by_b_1_z*t1027 - D_p_x_3_by_b_1_z*t1028
        - D_p_x_3_by_b_1_z*t1029 + D_p_y_2*D_p_y_3_by_b_1_z*k_C + D_p_y_2_by_b_1_z*D_p_y_3*k_C
        - D_p_y_2_by_b_1_z*t1040 - D_p_y_2_by_b_1_z*t1041 - D_p_y_2_by_b_1_z*t1042 - D_p_y_3_by_b_1_z*t1030
        - D_p_y_3_by_b_1_z*t1031 - D_p_y_3_by_b_1_z*t1032 + D_p_z_2*D_p_z_3_by_b_1_z*k_C
        + D_p_z_2_by_b_1_z*D_p_z_3*k_C - D_p_z_2_by_b_1_z*t1043 - D_p_z_2_by_b_1_z*t1044
        - D_p_z_2_by_b_1_z*t1045 - D_p_z_3_by_b_1_z*t1033 - D_p_z_3_by_b_1_z*t1034 - D_p_z_3_by_b_1_z*t1035
        + mu_1_by_b_1_z*t929 + mu_2_by_b_1_z*t930 + mu_3_by_b_1_z*t931
    )
    t1219 = (
        D_delta_x_1_by_b_1_z*t1095 + D_delta_y_1_by_b_1_z*t1096 + D_delta_z_1_by_b_1_z*t1097
        - D_p_x_2_by_b_1_z*t1054 - D_p_x_2_by_b_1_z*t1055 - D_p_x_2_by_b_1_z*t1056 + D_p_x_2_by_b_1_z*t1152
        - D_p_y_2_by_b_1_z*t1057 - D_p_y_2_by_b_1_z*t1058 - D_p_y_2_by_b_1_z*t1059 + D_p_y_2_by_b_1_z*t1153
        - D_p_z_2_by_b_1_z*t1060 - D_p_z_2_by_b_1_z*t1061 - D_p_z_2_by_b_1_z*t1062 + D_p_z_2_by_b_1_z*t1154
        + mu_1_by_b_1_z*t933 + mu_2_by_b_1_z*t934 + mu_3_by_b_1_z*t935
    )
    t1220 = (
        D_delta_x_2_by_b_1_z*t1095 + D_delta_y_2_by_b_1_z*t1096 + D_delta_z_2_by_b_1_z*t1097
        - D_p_x_2_by_b_1_z*t1067 - D_p_x_2_by_b_1_z*t1068 - D_p_x_2_by_b_1_z*t1069 + D_p_x_2_by_b_1_z*t1156
        - D_p_y_2_by_b_1_z*t1070 - D_p_y_2_by_b_1_z*t1071 - D_p_y_2_by_b_1_z*t1072 + D_p_y_2_by_b_1_z*t1157
        - D_p_z_2_by_b_1_z*t1073 - D_p_z_2_by_b_1_z*t1074 - D_p_z_2_by_b_1_z*t1075 + D_p_z_2_by_b_1_z*t1158
        + mu_1_by_b_1_z*t937 + mu_2_by_b_1_z*t938 + mu_3_by_b_1_z*t939
    )
    t1221 = (
        D_delta_x_3_by_b_1_z*t1095 + D_delta_y_3_by_b_1_z*t1096 + D_delta_z_3_by_b_1_z*t1097
        - D_p_x_2_by_b_1_z*t1077 - D_p_x_2_by_b_1_z*t1078 - D_p_x_2_by_b_1_z*t1079 + D_p_x_2_by_b_1_z*t1160
        - D_p_y_2_by_b_1_z*t1080 - D_p_y_2_by_b_1_z*t1081 - D_p_y_2_by_b_1_z*t1082 + D_p_y_2_by_b_1_z*t1161
        - D_p_z_2_by_b_1_z*t1083 - D_p_z_2_by_b_1_z*t1084 - D_p_z_2_by_b_1_z*t1085 + D_p_z_2_by_b_1_z*t1162
        + mu_1_by_b_1_z*t941 + mu_2_by_b_1_z*t942 + mu_3_by_b_1_z*t943
    )
    t1222 = D_p_x_2_by_b_1_z*k_C
    t1223 = D_p_y_2_by_b_1_z*k_C
    t1224 = D_p_z_2_by_b_1_z*k_C
    t1225 = 2*D_p_x_3_by_b_1_z
    t1226 = 2*D_p_y_3_by_b_1_z
    t1227 = 2*D_p_z_3_by_b_1_z
    t1228 = (
        D_delta_x_1_by_b_1_z*t1107 + D_delta_y_1_by_b_1_z*t1108 + D_delta_z_1_by_b_1_z*t1109
        - D_p_x_3_by_b_1_z*t1054 - D_p_x_3_by_b_1_z*t1055 - D_p_x_3_by_b_1_z*t1056 + D_p_x_3_by_b_1_z*t1152
        - D_p_y_3_by_b_1_z*t1057 - D_p_y_3_by_b_1_z*t1058 - D_p_y_3_by_b_1_z*t1059 + D_p_y_3_by_b_1_z*t1153
        - D_p_z_3_by_b_1_z*t1060 - D_p_z_3_by_b_1_z*t1061 - D_p_z_3_by_b_1_z*t1062 + D_p_z_3_by_b_1_z*t1154
        + mu_1_by_b_1_z*t948 + mu_2_by_b_1_z*t949 + mu_3_by_b_1_z*t950
    )
    t1229 = (
        D_delta_x_2_by_b_1_z*t1107 + D_delta_y_2_by_b_1_z*t1108 + D_delta_z_2_by_b_1_z*t1109
        - D_p_x_3_by_b_1_z*t1067 - D_p_x_3_by_b_1_z*t1068 - D_p_x_3_by_b_1_z*t1069 + D_p_x_3_by_b_1_z*t1156
        - D_p_y_3_by_b_1_z*t1070 - D_p_y_3_by_b_1_z*t1071 - D_p_y_3_by_b_1_z*t1072 + D_p_y_3_by_b_1_z*t1157
        - D_p_z_3_by_b_1_z*t1073 - D_p_z_3_by_b_1_z*t1074 - D_p_z_3_by_b_1_z*t1075 + D_p_z_3_by_b_1_z*t1158
        + mu_1_by_b_1_z*t952 + mu_2_by_b_1_z*t953 + mu_3_by_b_1_z*t954
    )
    t1230 = (
        D_delta_x_3_by_b_1_z*t1107 + D_delta_y_3_by_b_1_z*t1108 + D_delta_z_3_by_b_1_z*t1109
        - D_p_x_3_by_b_1_z*t1077 - D_p_x_3_by_b_1_z*t1078 - D_p_x_3_by_b_1_z*t1079 + D_p_x_3_by_b_1_z*t1160
        - D_p_y_3_by_b_1_z*t1080 - D_p_y_3_by_b_1_z*t1081 - D_p_y_3_by_b_1_z*t1082 + D_p_y_3_by_b_1_z*t1161
        - D_p_z_3_by_b_1_z*t1083 - D_p_z_3_by_b_1_z*t1084 - D_p_z_3_by_b_1_z*t1085 + D_p_z_3_by_b_1_z*t1162
        + mu_1_by_b_1_z*t958 + mu_2_by_b_1_z*t956 + mu_3_by_b_1_z*t957
    )
    t1231 = D_p_x_3_by_b_1_z*k_C
    t1232 = D_p_y_3_by_b_1_z*k_C
    t1233 = D_p_z_3_by_b_1_z*k_C
    t1234 = (
        D_delta_x_1_by_b_1_z*t1116 + D_delta_x_2_by_b_1_z*t1117 + D_delta_y_1_by_b_1_z*t1118
        + D_delta_y_2_by_b_1_z*t1119 + D_delta_z_1_by_b_1_z*t1120 + D_delta_z_2_by_b_1_z*t1121
        - mu_1_by_b_1_z*t242 - mu_2_by_b_1_z*t242 - mu_3_by_b_1_z*t242
    )
    t1235 = (
        D_delta_x_1_by_b_1_z*t1123 + D_delta_x_3_by_b_1_z*t1117 + D_delta_y_1_by_b_1_z*t1124
        + D_delta_y_3_by_b_1_z*t1119 + D_delta_z_1_by_b_1_z*t1125 + D_delta_z_3_by_b_1_z*t1121
        - mu_1_by_b_1_z*t246 - mu_2_by_b_1_z*t246 - mu_3_by_b_1_z*t246
    )
    t1236 = D_delta_x_1_by_b_1_z*k_C
    t1237 = D_delta_y_1_by_b_1_z*k_C
    t1238 = D_delta_z_1_by_b_1_z*k_C
    t1239 = (
        D_delta_x_2_by_b_1_z*t1123 + D_delta_x_3_by_b_1_z*t1116 + D_delta_y_2_by_b_1_z*t1124
        + D_delta_y_3_by_b_1_z*t1118 + D_delta_z_2_by_b_1_z*t1125 + D_delta_z_3_by_b_1_z*t1120
        - mu_1_by_b_1_z*t254 - mu_2_by_b_1_z*t254 - mu_3_by_b_1_z*t254
    )
    t1240 = D_delta_x_2_by_b_1_z*k_C
    t1241 = D_delta_y_2_by_b_1_z*k_C
    t1242 = D_delta_z_2_by_b_1_z*k_C
    t1243 = D_delta_x_3_by_b_1_z*k_C
    t1244 = D_delta_y_3_by_b_1_z*k_C
    t1245 = D_delta_z_3_by_b_1_z*k_C
    t1246 = 2*D_p_x_1_by_b_2_x
    t1247 = 2*D_p_y_1_by_b_2_x
    t1248 = 2*D_p_z_1_by_b_2_x
    t1249 = (
        D_p_x_1*D_p_x_2_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_2*k_C - D_p_x_1_by_b_2_x*t1027
        - D_p_x_1_by_b_2_x*t1028 - D_p_x_1_by_b_2_x*t1029 - D_p_x_2_by_b_2_x*t1011 - D_p_x_2_by_b_2_x*t1013
        - D_p_x_2_by_b_2_x*t1014 + D_p_y_1*D_p_y_2_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_2*k_C
        - D_p_y_1_by_b_2_x*t1030 - D_p_y_1_by_b_2_x*t1031 - D_p_y_1_by_b_2_x*t1032 - D_p_y_2_by_b_2_x*t1015
        - D_p_y_2_by_b_2_x*t1017 - D_p_y_2_by_b_2_x*t1018 + D_p_z_1*D_p_z_2_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_2*k_C - D_p_z_1_by_b_2_x*t1033 - D_p_z_1_by_b_2_x*t1034
        - D_p_z_1_by_b_2_x*t1035 - D_p_z_2_by_b_2_x*t1019 - D_p_z_2_by_b_2_x*t1021 - D_p_z_2_by_b_2_x*t1022
        + mu_1_by_b_2_x*t906 + mu_2_by_b_2_x*t907 + mu_3_by_b_2_x*t908
    )
    t1250 = (
        D_p_x_1*D_p_x_3_by_b_2_x*k_C + D_p_x_1_by_b_2_x*D_p_x_3*k_C - D_p_x_1_by_b_2_x*t1037
        - D_p_x_1_by_b_2_x*t1038 - D_p_x_1_by_b_2_x*t1039 - D_p_x_3_by_b_2_x*t1011 - D_p_x_3_by_b_2_x*t1013
        - D_p_x_3_by_b_2_x*t1014 + D_p_y_1*D_p_y_3_by_b_2_x*k_C + D_p_y_1_by_b_2_x*D_p_y_3*k_C
        - D_p_y_1_by_b_2_x*t1040 - D_p_y_1_by_b_2_x*t1041 - D_p_y_1_by_b_2_x*t1042 - D_p_y_3_by_b_2_x*t1015
        - D_p_y_3_by_b_2_x*t1017 - D_p_y_3_by_b_2_x*t1018 + D_p_z_1*D_p_z_3_by_b_2_x*k_C
        + D_p_z_1_by_b_2_x*D_p_z_3*k_C - D_p_z_1_by_b_2_x*t1043 - D_p_z_1_by_b_2_x*t1044
        - D_p_z_1_by_b_2_x*t1045 - D_p_z_3_by_b_2_x*t1019 - D_p_z_3_by_b_2_x*t1021 - D_p_z_3_by_b_2_x*t1022
        + mu_1_by_b_2_x*t910 + mu_2_by_b_2_x*t911 + mu_3_by_b_2_x*t912
    )
    t1251 = (
        D_delta_x_1_by_b_2_x*t1063 + D_delta_y_1_by_b_2_x*t1064 + D_delta_z_1_by_b_2_x*t1065
        - D_p_x_1_by_b_2_x*t1054 - D_p_x_1_by_b_2_x*t1055 - D_p_x_1_by_b_2_x*t1056 + D_p_x_1_by_b_2_x*t1152
        - D_p_y_1_by_b_2_x*t1057 - D_p_y_1_by_b_2_x*t1058 - D_p_y_1_by_b_2_x*t1059 + D_p_y_1_by_b_2_x*t1153
        - D_p_z_1_by_b_2_x*t1060 - D_p_z_1_by_b_2_x*t1061 - D_p_z_1_by_b_2_x*t1062 + D_p_z_1_by_b_2_x*t1154
        + mu_1_by_b_2_x*t914 + mu_2_by_b_2_x*t915 + mu_3_by_b_2_x*t916
    )
    t1252 = (
        D_delta_x_2_by_b_2_x*t1063 + D_delta_y_2_by_b_2_x*t1064 + D_delta_z_2_by_b_2_x*t1065
        - D_p_x_1_by_b_2_x*t1067 - D_p_x_1_by_b_2_x*t1068 - D_p_x_1_by_b_2_x*t1069 + D_p_x_1_by_b_2_x*t1156
        - D_p_y_1_by_b_2_x*t1070 - D_p_y_1_by_b_2_x*t1071 - D_p_y_1_by_b_2_x*t1072 + D_p_y_1_by_b_2_x*t1157
        - D_p_z_1_by_b_2_x*t1073 - D_p_z_1_by_b_2_x*t1074 - D_p_z_1_by_b_2_x*t1075 + D_p_z_1_by_b_2_x*t1158
        + mu_1_by_b_2_x*t918 + mu_2_by_b_2_x*t919 + mu_3_by_b_2_x*t920
    )
    t1253 = (
        D_delta_x_3_by_b_2_x*t1063 + D_delta_y_3_by_b_2_x*t1064 + D_delta_z_3_by_b_2_x*t1065
        - D_p_x_1_by_b_2_x*t1077 - D_p_x_1_by_b_2_x*t1078 - D_p_x_1_by_b_2_x*t1079 + D_p_x_1_by_b_2_x*t1160
        - D_p_y_1_by_b_2_x*t1080 - D_p_y_1_by_b_2_x*t1081 - D_p_y_1_by_b_2_x*t1082 + D_p_y_1_by_b_2_x*t1161
        - D_p_z_1_by_b_2_x*t1083 - D_p_z_1_by_b_2_x*t1084 - D_p_z_1_by_b_2_x*t1085 + D_p_z_1_by_b_2_x*t1162
        + mu_1_by_b_2_x*t922 + mu_2_by_b_2_x*t923 + mu_3_by_b_2_x*t924
    )
    t1254 = D_p_x_1_by_b_2_x*k_C
    t1255 = D_p_y_1_by_b_2_x*k_C
    t1256 = D_p_z_1_by_b_2_x*k_C
    t1257 = 2*D_p_x_2_by_b_2_x
    t1258 = 2*D_p_y_2_by_b_2_x
    t1259 = 2*D_p_z_2_by_b_2_x
    t1260 = 1.0/(t29**2)
    t1261 = t1260*t24
    t1262 = t1261*x_2_by_b_2_x
    t1263 = 1.0/(t31**2)
    t1264 = (
        D_p_x_2*D_p_x_3_by_b_2_x*k_C + D_p_x_2_by_b_2_x*D_p_x_3*k_C - D_p_x_2_by_b_2_x*t1037
        - D_p_x_2_by_b_2_x*t1038 - D_p_x_2_by_b_2_x*t1039 - D_p_x_3_by_b_2_x*t1027 - D_p_x_3_by_b_2_x*t1028
        - D_p_x_3_by_b_2_x*t1029 + D_p_y_2*D_p_y_3_by_b_2_x*k_C + D_p_y_2_by_b_2_x*D_p_y_3*k_C
        - D_p_y_2_by_b_2_x*t1040 - D_p_y_2_by_b_2_x*t1041 - D_p_y_2_by_b_2_x*t1042 - D_p_y_3_by_b_2_x*t1030
        - D_p_y_3_by_b_2_x*t1031 - D_p_y_3_by_b_2_x*t1032 + D_p_z_2*D_p_z_3_by_b_2_x*k_C
        + D_p_z_2_by_b_2_x*D_p_z_3*k_C - D_p_z_2_by_b_2_x*t1043 - D_p_z_2_by_b_2_x*t1044
        - D_p_z_2_by_b_2_x*t1045 - D_p_z_3_by_b_2_x*t1033 - D_p_z_3_by_b_2_x*t1034 - D_p_z_3_by_b_2_x*t1035
        + mu_1_by_b_2_x*t929 + mu_2_by_b_2_x*t930 + mu_3_by_b_2_x*t931
    )
    t1265 = t1263*t24
    t1266 = t1265*x_2_by_b_2_x
    t1267 = -R_p_2*t1266
    t1268 = R_p_2*t1262
    t1269 = (
        D_delta_x_1_by_b_2_x*t1095 + D_delta_y_1_by_b_2_x*t1096 + D_delta_z_1_by_b_2_x*t1097
        - D_p_x_2_by_b_2_x*t1054 - D_p_x_2_by_b_2_x*t1055 - D_p_x_2_by_b_2_x*t1056 + D_p_x_2_by_b_2_x*t1152
        - D_p_y_2_by_b_2_x*t1057 - D_p_y_2_by_b_2_x*t1058 - D_p_y_2_by_b_2_x*t1059 + D_p_y_2_by_b_2_x*t1153
        - D_p_z_2_by_b_2_x*t1060 - D_p_z_2_by_b_2_x*t1061 - D_p_z_2_by_b_2_x*t1062 + D_p_z_2_by_b_2_x*t1154
        + mu_1_by_b_2_x*t933 + mu_2_by_b_2_x*t934 + mu_3_by_b_2_x*t935
    )
    t1270 = (
        D_delta_x_2_by_b_2_x*t1095 + D_delta_y_2_by_b_2_x*t1096 + D_delta_z_2_by_b_2_x*t1097
        - D_p_x_2_by_b_2_x*t1067 - D_p_x_2_by_b_2_x*t1068 - D_p_x_2_by_b_2_x*t1069 + D_p_x_2_by_b_2_x*t1156
        - D_p_y_2_by_b_2_x*t1070 - D_p_y_2_by_b_2_x*t1071 - D_p_y_2_by_b_2_x*t1072 + D_p_y_2_by_b_2_x*t1157
        - D_p_z_2_by_b_2_x*t1073 - D_p_z_2_by_b_2_x*t1074 - D_p_z_2_by_b_2_x*t1075 + D_p_z_2_by_b_2_x*t1158
        + mu_1_by_b_2_x*t937 + mu_2_by_b_2_x*t938 + mu_3_by_b_2_x*t939
    )
    t1271 = (
        D_delta_x_3_by_b_2_x*t1095 + D_delta_y_3_by_b_2_x*t1096 + D_delta_z_3_by_b_2_x*t1097
        - D_p_x_2_by_b_2_x*t1077 - D_p_x_2_by_b_2_x*t1078 - D_p_x_2_by_b_2_x*t1079 + D_p_x_2_by_b_2_x*t1160
        - D_p_y_2_by_b_2_x*t1080 - D_p_y_2_by_b_2_x*t1081 - D_p_y_2_by_b_2_x*t1082 + D_p_y_2_by_b_2_x*t1161
        - D_p_z_2_by_b_2_x*t1083 - D_p_z_2_by_b_2_x*t1084 - D_p_z_2_by_b_2_x*t1085 + D_p_z_2_by_b_2_x*t1162
        + mu_1_by_b_2_x*t941 + mu_2_by_b_2_x*t942 + mu_3_by_b_2_x*t943
    )
    t1272 = -t1262 + t1266
    t1273 = D_p_x_2_by_b_2_x*k_C
    t1274 = D_p_y_2_by_b_2_x*k_C
    t1275 = D_p_z_2_by_b_2_x*k_C
    t1276 = 2*D_p_x_3_by_b_2_x
    t1277 = 2*D_p_y_3_by_b_2_x
    t1278 = 2*D_p_z_3_by_b_2_x
    t1279 = (
        D_delta_x_1_by_b_2_x*t1107 + D_delta_y_1_by_b_2_x*t1108 + D_delta_z_1_by_b_2_x*t1109
        - D_p_x_3_by_b_2_x*t1054 - D_p_x_3_by_b_2_x*t1055 - D_p_x_3_by_b_2_x*t1056 + D_p_x_3_by_b_2_x*t1152
        - D_p_y_3_by_b_2_x*t1057 - D_p_y_3_by_b_2_x*t1058 - D_p_y_3_by_b_2_x*t1059 + D_p_y_3_by_b_2_x*t1153
        - D_p_z_3_by_b_2_x*t1060 - D_p_z_3_by_b_2_x*t1061 - D_p_z_3_by_b_2_x*t1062 + D_p_z_3_by_b_2_x*t1154
        + mu_1_by_b_2_x*t948 + mu_2_by_b_2_x*t949 + mu_3_by_b_2_x*t950
    )
    t1280 = (
        D_delta_x_2_by_b_2_x*t1107 + D_delta_y_2_by_b_2_x*t1108 + D_delta_z_2_by_b_2_x*t1109
        - D_p_x_3_by_b_2_x*t1067 - D_p_x_3_by_b_2_x*t1068 - D_p_x_3_by_b_2_x*t1069 + D_p_x_3_by_b_2_x*t1156
        - D_p_y_3_by_b_2_x*t1070 - D_p_y_3_by_b_2_x*t1071 - D_p_y_3_by_b_2_x*t1072 + D_p_y_3_by_b_2_x*t1157
        - D_p_z_3_by_b_2_x*t1073 - D_p_z_3_by_b_2_x*t1074 - D_p_z_3_by_b_2_x*t1075 + D_p_z_3_by_b_2_x*t1158
        + mu_1_by_b_2_x*t952 + mu_2_by_b_2_x*t953 + mu_3_by_b_2_x*t954
    )
    t1281 = (
        D_delta_x_3_by_b_2_x*t1107 + D_delta_y_3_by_b_2_x*t1108 + D_delta_z_3_by_b_2_x*t1109
        - D_p_x_3_by_b_2_x*t1077 - D_p_x_3_by_b_2_x*t1078 - D_p_x_3_by_b_2_x*t1079 + D_p_x_3_by_b_2_x*t1160
        - D_p_y_3_by_b_2_x*t1080 - D_p_y_3_by_b_2_x*t1081 - D_p_y_3_by_b_2_x*t1082 + D_p_y_3_by_b_2_x*t1161
        - D_p_z_3_by_b_2_x*t1083 - D_p_z_3_by_b_2_x*t1084 - D_p_z_3_by_b_2_x*t1085 + D_p_z_3_by_b_2_x*t1162
        + mu_1_by_b_2_x*t958 + mu_2_by_b_2_x*t956 + mu_3_by_b_2_x*t957
    )
    t1282 = D_p_x_3_by_b_2_x*k_C
    t1283 = D_p_y_3_by_b_2_x*k_C
    t1284 = D_p_z_3_by_b_2_x*k_C
    t1285 = (
        D_delta_x_1_by_b_2_x*t1116 + D_delta_x_2_by_b_2_x*t1117 + D_delta_y_1_by_b_2_x*t1118
        + D_delta_y_2_by_b_2_x*t1119 + D_delta_z_1_by_b_2_x*t1120 + D_delta_z_2_by_b_2_x*t1121
        - mu_1_by_b_2_x*t242 - mu_2_by_b_2_x*t242 - mu_3_by_b_2_x*t242
    )
    t1286 = (
        D_delta_x_1_by_b_2_x*t1123 + D_delta_x_3_by_b_2_x*t1117 + D_delta_y_1_by_b_2_x*t1124
        + D_delta_y_3_by_b_2_x*t1119 + D_delta_z_1_by_b_2_x*t1125 + D_delta_z_3_by_b_2_x*t1121
        - mu_1_by_b_2_x*t246 - mu_2_by_b_2_x*t246 - mu_3_by_b_2_x*t246
    )
    t1287 = D_delta_x_1_by_b_2_x*k_C
    t1288 = D_delta_y_1_by_b_2_x*k_C
    t1289 = D_delta_z_1_by_b_2_x*k_C
    t1290 = (
        D_delta_x_2_by_b_2_x*t1123 + D_delta_x_3_by_b_2_x*t1116 + D_delta_y_2_by_b_2_x*t1124
        + D_delta_y_3_by_b_2_x*t1118 + D_delta_z_2_by_b_2_x*t1125 + D_delta_z_3_by_b_2_x*t1120
        - mu_1_by_b_2_x*t254 - mu_2_by_b_2_x*t254 - mu_3_by_b_2_x*t254
    )
    t1291 = D_delta_x_2_by_b_2_x*k_C
    t1292 = D_delta_y_2_by_b_2_x*k_C
    t1293 = D_delta_z_2_by_b_2_x*k_C
    t1294 = D_delta_x_3_by_b_2_x*k_C
    t1295 = D_delta_y_3_by_b_2_x*k_C
    t1296 = D_delta_z_3_by_b_2_x*k_C
    t1297 = 2*D_p_x_1_by_b_2_y
    t1298 = 2*D_p_y_1_by_b_2_y
    t1299 = 2*D_p_z_1_by_b_2_y
    t1300 = (
        D_p_x_1*D_p_x_2_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_2*k_C - D_p_x_1_by_b_2_y*t1027
        - D_p_x_1_by_b_2_y*t1028 - D_p_x_1_by_b_2_y*t1029 - D_p_x_2_by_b_2_y*t1011 - D_p_x_2_by_b_2_y*t1013
        - D_p_x_2_by_b_2_y*t1014 + D_p_y_1*D_p_y_2_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_2*k_C
        - D_p_y_1_by_b_2_y*t1030 - D_p_y_1_by_b_2_y*t1031 - D_p_y_1_by_b_2_y*t1032 - D_p_y_2_by_b_2_y*t1015
        - D_p_y_2_by_b_2_y*t1017 - D_p_y_2_by_b_2_y*t1018 + D_p_z_1*D_p_z_2_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_2*k_C - D_p_z_1_by_b_2_y*t1033 - D_p_z_1_by_b_2_y*t1034
        - D_p_z_1_by_b_2_y*t1035 - D_p_z_2_by_b_2_y*t1019 - D_p_z_2_by_b_2_y*t1021 - D_p_z_2_by_b_2_y*t1022
        + mu_1_by_b_2_y*t906 + mu_2_by_b_2_y*t907 + mu_3_by_b_2_y*t908
    )
    t1301 = (
        D_p_x_1*D_p_x_3_by_b_2_y*k_C + D_p_x_1_by_b_2_y*D_p_x_3*k_C - D_p_x_1_by_b_2_y*t1037
        - D_p_x_1_by_b_2_y*t1038 - D_p_x_1_by_b_2_y*t1039 - D_p_x_3_by_b_2_y*t1011 - D_p_x_3_by_b_2_y*t1013
        - D_p_x_3_by_b_2_y*t1014 + D_p_y_1*D_p_y_3_by_b_2_y*k_C + D_p_y_1_by_b_2_y*D_p_y_3*k_C
        - D_p_y_1_by_b_2_y*t1040 - D_p_y_1_by_b_2_y*t1041 - D_p_y_1_by_b_2_y*t1042 - D_p_y_3_by_b_2_y*t1015
        - D_p_y_3_by_b_2_y*t1017 - D_p_y_3_by_b_2_y*t1018 + D_p_z_1*D_p_z_3_by_b_2_y*k_C
        + D_p_z_1_by_b_2_y*D_p_z_3*k_C - D_p_z_1_by_b_2_y*t1043 - D_p_z_1_by_b_2_y*t1044
        - D_p_z_1_by_b_2_y*t1045 - D_p_z_3_by_b_2_y*t1019 - D_p_z_3_by_b_2_y*t1021 - D_p_z_3_by_b_2_y*t1022
        + mu_1_by_b_2_y*t910 + mu_2_by_b_2_y*t911 + mu_3_by_b_2_y*t912
    )
    t1302 = (
        D_delta_x_1_by_b_2_y*t1063 + D_delta_y_1_by_b_2_y*t1064 + D_delta_z_1_by_b_2_y*t1065
        - D_p_x_1_by_b_2_y*t1054 - D_p_x_1_by_b_2_y*t1055 - D_p_x_1_by_b_2_y*t1056 + D_p_x_1_by_b_2_y*t1152
        - D_p_y_1_by_b_2_y*t1057 - D_p_y_1_by_b_2_y*t1058 - D_p_y_1_by_b_2_y*t1059 + D_p_y_1_by_b_2_y*t1153
        - D_p_z_1_by_b_2_y*t1060 - D_p_z_1_by_b_2_y*t1061 - D_p_z_1_by_b_2_y*t1062 + D_p_z_1_by_b_2_y*t1154
        + mu_1_by_b_2_y*t914 + mu_2_by_b_2_y*t915 + mu_3_by_b_2_y*t916
    )
    t1303 = (
        D_delta_x_2_by_b_2_y*t1063 + D_delta_y_2_by_b_2_y*t1064 + D_delta_z_2_by_b_2_y*t1065
        - D_p_x_1_by_b_2_y*t1067 - D_p_x_1_by_b_2_y*t1068 - D_p_x_1_by_b_2_y*t1069 + D_p_x_1_by_b_2_y*t1156
        - D_p_y_1_by_b_2_y*t1070 - D_p_y_1_by_b_2_y*t1071 - D_p_y_1_by_b_2_y*t1072 + D_p_y_1_by_b_2_y*t1157
        - D_p_z_1_by_b_2_y*t1073 - D_p_z_1_by_b_2_y*t1074 - D_p_z_1_by_b_2_y*t1075 + D_p_z_1_by_b_2_y*t1158
        + mu_1_by_b_2_y*t918 + mu_2_by_b_2_y*t919 + mu_3_by_b_2_y*t920
    )
    t1304 = (
        D_delta_x_3_by_b_2_y*t1063 + D_delta_y_3_by_b_2_y*t1064 + D_delta_z_3_by_b_2_y*t1065
        - D_p_x_1_by_b_2_y*t1077 - D_p_x_1_by_b_2_y*t1078 - D_p_x_1_by_b_2_y*t1079 + D_p_x_1_by_b_2_y*t1160
        - D_p_y_1_by_b_2_y*t1080 - D_p_y_1_by_b_2_y*t1081 - D_p_y_1_by_b_2_y*t1082 + D_p_y_1_by_b_2_y*t1161
        - D_p_z_1_by_b_2_y*t1083 - D_p_z_1_by_b_2_y*t1084 - D_p_z_1_by_b_2_y*t1085 + D_p_z_1_by_b_2_y*t1162
        + mu_1_by_b_2_y*t922 + mu_2_by_b_2_y*t923 + mu_3_by_b_2_y*t924
    )
    t1305 = D_p_x_1_by_b_2_y*k_C
    t1306 = D_p_y_1_by_b_2_y*k_C
    t1307 = D_p_z_1_by_b_2_y*k_C
    t1308 = 2*D_p_x_2_by_b_2_y
    t1309 = 2*D_p_y_2_by_b_2_y
    t1310 = 2*D_p_z_2_by_b_2_y
    t1311 = t1261*x_2_by_b_2_y
    t1312 = (
        D_p_x_2*D_p_x_3_by_b_2_y*k_C + D_p_x_2_by_b_2_y*D_p_x_3*k_C - D_p_x_2_by_b_2_y*t1037
        - D_p_x_2_by_b_2_y*t1038 - D_p_x_2_by_b_2_y*t1039 - D_p_x_3_by_b_2_y*t1027 - D_p_x_3_by_b_2_y*t1028
        - D_p_x_3_by_b_2_y*t1029 + D_p_y_2*D_p_y_3_by_b_2_y*k_C + D_p_y_2_by_b_2_y*D_p_y_3*k_C
        - D_p_y_2_by_b_2_y*t1040 - D_p_y_2_by_b_2_y*t1041 - D_p_y_2_by_b_2_y*t1042 - D_p_y_3_by_b_2_y*t1030
        - D_p_y_3_by_b_2_y*t1031 - D_p_y_3_by_b_2_y*t1032 + D_p_z_2*D_p_z_3_by_b_2_y*k_C
        + D_p_z_2_by_b_2_y*D_p_z_3*k_C - D_p_z_2_by_b_2_y*t1043 - D_p_z_2_by_b_2_y*t1044
        - D_p_z_2_by_b_2_y*t1045 - D_p_z_3_by_b_2_y*t1033 - D_p_z_3_by_b_2_y*t1034 - D_p_z_3_by_b_2_y*t1035
        + mu_1_by_b_2_y*t929 + mu_2_by_b_2_y*t930 + mu_3_by_b_2_y*t931
    )
    t1313 = t1265*x_2_by_b_2_y
    t1314 = -R_p_2*t1313
    t1315 = R_p_2*t1311
    t1316 = (
        D_delta_x_1_by_b_2_y*t1095 + D_delta_y_1_by_b_2_y*t1096 + D_delta_z_1_by_b_2_y*t1097
        - D_p_x_2_by_b_2_y*t1054 - D_p_x_2_by_b_2_y*t1055 - D_p_x_2_by_b_2_y*t1056 + D_p_x_2_by_b_2_y*t1152
        - D_p_y_2_by_b_2_y*t1057 - D_p_y_2_by_b_2_y*t1058 - D_p_y_2_by_b_2_y*t1059 + D_p_y_2_by_b_2_y*t1153
        - D_p_z_2_by_b_2_y*t1060 - D_p_z_2_by_b_2_y*t1061 - D_p_z_2_by_b_2_y*t1062 + D_p_z_2_by_b_2_y*t1154
        + mu_1_by_b_2_y*t933 + mu_2_by_b_2_y*t934 + mu_3_by_b_2_y*t935
    )
    t1317 = (
        D_delta_x_2_by_b_2_y*t1095 + D_delta_y_2_by_b_2_y*t1096 + D_delta_z_2_by_b_2_y*t1097
        - D_p_x_2_by_b_2_y*t1067 - D_p_x_2_by_b_2_y*t1068 - D_p_x_2_by_b_2_y*t1069 + D_p_x_2_by_b_2_y*t1156
        - D_p_y_2_by_b_2_y*t1070 - D_p_y_2_by_b_2_y*t1071 - D_p_y_2_by_b_2_y*t1072 + D_p_y_2_by_b_2_y*t1157
        - D_p_z_2_by_b_2_y*t1073 - D_p_z_2_by_b_2_y*t1074 - D_p_z_2_by_b_2_y*t1075 + D_p_z_2_by_b_2_y*t1158
        + mu_1_by_b_2_y*t937 + mu_2_by_b_2_y*t938 + mu_3_by_b_2_y*t939
    )
    t1318 = (
        D_delta_x_3_by_b_2_y*t1095 + D_delta_y_3_by_b_2_y*t1096 + D_delta_z_3_by_b_2_y*t1097
        - D_p_x_2_by_b_2_y*t1077 - D_p_x_2_by_b_2_y*t1078 - D_p_x_2_by_b_2_y*t1079 + D_p_x_2_by_b_2_y*t1160
        - D_p_y_2_by_b_2_y*t1080 - D_p_y_2_by_b_2_y*t1081 - D_p_y_2_by_b_2_y*t1082 + D_p_y_2_by_b_2_y*t1161
        - D_p_z_2_by_b_2_y*t1083 - D_p_z_2_by_b_2_y*t1084 - D_p_z_2_by_b_2_y*t1085 + D_p_z_2_by_b_2_y*t1162
        + mu_1_by_b_2_y*t941 + mu_2_by_b_2_y*t942 + mu_3_by_b_2_y*t943
    )
    t1319 = -t1311 + t1313
    t1320 = D_p_x_2_by_b_2_y*k_C
    t1321 = D_p_y_2_by_b_2_y*k_C
    t1322 = D_p_z_2_by_b_2_y*k_C
    t1323 = 2*D_p_x_3_by_b_2_y
    t1324 = 2*D_p_y_3_by_b_2_y
    t1325 = 2*D_p_z_3_by_b_2_y
    t1326 = (
        D_delta_x_1_by_b_2_y*t1107 + D_delta_y_1_by_b_2_y*t1108 + D_delta_z_1_by_b_2_y*t1109
        - D_p_x_3_by_b_2_y*t1054 - D_p_x_3_by_b_2_y*t1055 - D_p_x_3_by_b_2_y*t1056 + D_p_x_3_by_b_2_y*t1152
        - D_p_y_3_by_b_2_y*t1057 - D_p_y_3_by_b_2_y*t1058 - D_p_y_3_by_b_2_y*t1059 + D_p_y_3_by_b_2_y*t1153
        - D_p_z_3_by_b_2_y*t1060 - D_p_z_3_by_b_2_y*t1061 - D_p_z_3_by_b_2_y*t1062 + D_p_z_3_by_b_2_y*t1154
        + mu_1_by_b_2_y*t948 + mu_2_by_b_2_y*t949 + mu_3_by_b_2_y*t950
    )
    t1327 = (
        D_delta_x_2_by_b_2_y*t1107 + D_delta_y_2_by_b_2_y*t1108 + D_delta_z_2_by_b_2_y*t1109
        - D_p_x_3_by_b_2_y*t1067 - D_p_x_3_by_b_2_y*t1068 - D_p_x_3_by_b_2_y*t1069 + D_p_x_3_by_b_2_y*t1156
        - D_p_y_3_by_b_2_y*t1070 - D_p_y_3_by_b_2_y*t1071 - D_p_y_3_by_b_2_y*t1072 + D_p_y_3_by_b_2_y*t1157
        - D_p_z_3_by_b_2_y*t1073 - D_p_z_3_by_b_2_y*t1074 - D_p_z_3_by_b_2_y*t1075 + D_p_z_3_by_b_2_y*t1158
        + mu_1_by_b_2_y*t952 + mu_2_by_b_2_y*t953 + mu_3_by_b_2_y*t954
    )
    t1328 = (
        D_delta_x_3_by_b_2_y*t1107 + D_delta_y_3_by_b_2_y*t1108 + D_delta_z_3_by_b_2_y*t1109
        - D_p_x_3_by_b_2_y*t1077 - D_p_x_3_by_b_2_y*t1078 - D_p_x_3_by_b_2_y*t1079 + D_p_x_3_by_b_2_y*t1160
        - D_p_y_3_by_b_2_y*t1080 - D_p_y_3_by_b_2_y*t1081 - D_p_y_3_by_b_2_y*t1082 + D_p_y_3_by_b_2_y*t1161
        - D_p_z_3_by_b_2_y*t1083 - D_p_z_3_by_b_2_y*t1084 - D_p_z_3_by_b_2_y*t1085 + D_p_z_3_by_b_2_y*t1162
        + mu_1_by_b_2_y*t958 + mu_2_by_b_2_y*t956 + mu_3_by_b_2_y*t957
    )
    t1329 = D_p_x_3_by_b_2_y*k_C
    t1330 = D_p_y_3_by_b_2_y*k_C
    t1331 = D_p_z_3_by_b_2_y*k_C
    t1332 = (
        D_delta_x_1_by_b_2_y*t1116 + D_delta_x_2_by_b_2_y*t1117 + D_delta_y_1_by_b_2_y*t1118
        + D_delta_y_2_by_b_2_y*t1119 + D_delta_z_1_by_b_2_y*t1120 + D_delta_z_2_by_b_2_y*t1121
        - mu_1_by_b_2_y*t242 - mu_2_by_b_2_y*t242 - mu_3_by_b_2_y*t242
    )
    t1333 = (
        D_delta_x_1_by_b_2_y*t1123 + D_delta_x_3_by_b_2_y*t1117 + D_delta_y_1_by_b_2_y*t1124
        + D_delta_y_3_by_b_2_y*t1119 + D_delta_z_1_by_b_2_y*t1125 + D_delta_z_3_by_b_2_y*t1121
        - mu_1_by_b_2_y*t246 - mu_2_by_b_2_y*t246 - mu_3_by_b_2_y*t246
    )
    t1334 = D_delta_x_1_by_b_2_y*k_C
    t1335 = D_delta_y_1_by_b_2_y*k_C
    t1336 = D_delta_z_1_by_b_2_y*k_C
    t1337 = (
        D_delta_x_2_by_b_2_y*t1123 + D_delta_x_3_by_b_2_y*t1116 + D_delta_y_2_by_b_2_y*t1124
        + D_delta_y_3_by_b_2_y*t1118 + D_delta_z_2_by_b_2_y*t1125 + D_delta_z_3_by_b_2_y*t1120
        - mu_1_by_b_2_y*t254 - mu_2_by_b_2_y*t254 - mu_3_by_b_2_y*t254
    )
    t1338 = D_delta_x_2_by_b_2_y*k_C
    t1339 = D_delta_y_2_by_b_2_y*k_C
    t1340 = D_delta_z_2_by_b_2_y*k_C
    t1341 = D_delta_x_3_by_b_2_y*k_C
    t1342 = D_delta_y_3_by_b_2_y*k_C
    t1343 = D_delta_z_3_by_b_2_y*k_C
    t1344 = 2*D_p_x_1_by_b_2_z
    t1345 = 2*D_p_y_1_by_b_2_z
    t1346 = 2*D_p_z_1_by_b_2_z
    t1347 = (
        D_p_x_1*D_p_x_2_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_2*k_C - D_p_x_1_by_b_2_z*t1027
        - D_p_x_1_by_b_2_z*t1028 - D_p_x_1_by_b_2_z*t1029 - D_p_x_2_by_b_2_z*t1011 - D_p_x_2_by_b_2_z*t1013
        - D_p_x_2_by_b_2_z*t1014 + D_p_y_1*D_p_y_2_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_2*k_C
        - D_p_y_1_by_b_2_z*t1030 - D_p_y_1_by_b_2_z*t1031 - D_p_y_1_by_b_2_z*t1032 - D_p_y_2_by_b_2_z*t1015
        - D_p_y_2_by_b_2_z*t1017 - D_p_y_2_by_b_2_z*t1018 + D_p_z_1*D_p_z_2_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_2*k_C - D_p_z_1_by_b_2_z*t1033 - D_p_z_1_by_b_2_z*t1034
        - D_p_z_1_by_b_2_z*t1035 - D_p_z_2_by_b_2_z*t1019 - D_p_z_2_by_b_2_z*t1021 - D_p_z_2_by_b_2_z*t1022
        + mu_1_by_b_2_z*t906 + mu_2_by_b_2_z*t907 + mu_3_by_b_2_z*t908
    )
    t1348 = (
        D_p_x_1*D_p_x_3_by_b_2_z*k_C + D_p_x_1_by_b_2_z*D_p_x_3*k_C - D_p_x_1_by_b_2_z*t1037
        - D_p_x_1_by_b_2_z*t1038 - D_p_x_1_by_b_2_z*t1039 - D_p_x_3_by_b_2_z*t1011 - D_p_x_3_by_b_2_z*t1013
        - D_p_x_3_by_b_2_z*t1014 + D_p_y_1*D_p_y_3_by_b_2_z*k_C + D_p_y_1_by_b_2_z*D_p_y_3*k_C
        - D_p_y_1_by_b_2_z*t1040 - D_p_y_1_by_b_2_z*t1041 - D_p_y_1_by_b_2_z*t1042 - D_p_y_3_by_b_2_z*t1015
        - D_p_y_3_by_b_2_z*t1017 - D_p_y_3_by_b_2_z*t1018 + D_p_z_1*D_p_z_3_by_b_2_z*k_C
        + D_p_z_1_by_b_2_z*D_p_z_3*k_C - D_p_z_1_by_b_2_z*t1043 - D_p_z_1_by_b_2_z*t1044
        - D_p_z_1_by_b_2_z*t1045 - D_p_z_3_by_b_2_z*t1019 - D_p_z_3_by_b_2_z*t1021 - D_p_z_3_by_b_2_z*t1022
        + mu_1_by_b_2_z*t910 + mu_2_by_b_2_z*t911 + mu_3_by_b_2_z*t912
    )
    t1349 = (
        D_delta_x_1_by_b_2_z*t1063 + D_delta_y_1_by_b_2_z*t1064 + D_delta_z_1_by_b_2_z*t1065
        - D_p_x_1_by_b_2_z*t1054 - D_p_x_1_by_b_2_z*t1055 - D_p_x_1_by_b_2_z*t1056 + D_p_x_1_by_b_2_z*t1152
        - D_p_y_1_by_b_2_z*t1057 - D_p_y_1_by_b_2_z*t1058 - D_p_y_1_by_b_2_z*t1059 + D_p_y_1_by_b_2_z*t1153
        - D_p_z_1_by_b_2_z*t1060 - D_p_z_1_by_b_2_z*t1061 - D_p_z_1_by_b_2_z*t1062 + D_p_z_1_by_b_2_z*t1154
        + mu_1_by_b_2_z*t914 + mu_2_by_b_2_z*t915 + mu_3_by_b_2_z*t916
    )
    t1350 = (
        D_delta_x_2_by_b_2_z*t1063 + D_delta_y_2_by_b_2_z*t1064 + D_delta_z_2_by_b_2_z*t1065
        - D_p_x_1_by_b_2_z*t1067 - D_p_x_1_by_b_2_z*t1068 - D_p_x_1_by_b_2_z*t1069 + D_p_x_1_by_b_2_z*t1156
        - D_p_y_1_by_b_2_z*t1070 - D_p_y_1_by_b_2_z*t1071 - D_p_y_1_by_b_2_z*t1072 + D_p_y_1_by_b_2_z*t1157
        - D_p_z_1_by_b_2_z*t1073 - D_p_z_1_by_b_2_z*t1074 - D_p_z_1_by_b_2_z*t1075 + D_p_z_1_by_b_2_z*t1158
        + mu_1_by_b_2_z*t918 + mu_2_by_b_2_z*t919 + mu_3_by_b_2_z*t920
    )
    t1351 = (
        D_delta_x_3_by_b_2_z*t1063 + D_delta_y_3_by_b_2_z*t1064 + D_delta_z_3_by_b_2_z*t1065
        - D_p_x_1_by_b_2_z*t1077 - D_p_x_1_by_b_2_z*t1078 - D_p_x_1_by_b_2_z*t1079 + D_p_x_1_by_b_2_z*t1160
        - D_p_y_1_by_b_2_z*t1080 - D_p_y_1_by_b_2_z*t1081 - D_p_y_1_by_b_2_z*t1082 + D_p_y_1_by_b_2_z*t1161
        - D_p_z_1_by_b_2_z*t1083 - D_p_z_1_by_b_2_z*t1084 - D_p_z_1_by_b_2_z*t1085 + D_p_z_1_by_b_2_z*t1162
        + mu_1_by_b_2_z*t922 + mu_2_by_b_2_z*t923 + mu_3_by_b_2_z*t924
    )
    t1352 = D_p_x_1_by_b_2_z*k_C
    t1353 = D_p_y_1_by_b_2_z*k_C
    t1354 = D_p_z_1_by_b_2_z*k_C
    t1355 = 2*D_p_x_2_by_b_2_z
    t1356 = 2*D_p_y_2_by_b_2_z
    t1357 = 2*D_p_z_2_by_b_2_z
    t1358 = t1261*x_2_by_b_2_z
    t1359 = (
        D_p_x_2*D_p_x_3_by_b_2_z*k_C + D_p_x_2_by_b_2_z*D_p_x_3*k_C - D_p_x_2_by_b_2_z*t1037
        - D_p_x_2_by_b_2_z*t1038 - D_p_x_2_by_b_2_z*t1039 - D_p_x_3_by_b_2_z*t1027 - D_p_x_3_by_b_2_z*t1028
        - D_p_x_3_by_b_2_z*t1029 + D_p_y_2*D_p_y_3_by_b_2_z*k_C + D_p_y_2_by_b_2_z*D_p_y_3*k_C
        - D_p_y_2_by_b_2_z*t1040 - D_p_y_2_by_b_2_z*t1041 - D_p_y_2_by_b_2_z*t1042 - D_p_y_3_by_b_2_z*t1030
        - D_p_y_3_by_b_2_z*t1031 - D_p_y_3_by_b_2_z*t1032 + D_p_z_2*D_p_z_3_by_b_2_z*k_C
        + D_p_z_2_by_b_2_z*D_p_z_3*k_C - D_p_z_2_by_b_2_z*t1043 - D_p_z_2_by_b_2_z*t1044
        - D_p_z_2_by_b_2_z*t1045 - D_p_z_3_by_b_2_z*t1033 - D_p_z_3_by_b_2_z*t1034 - D_p_z_3_by_b_2_z*t1035
        + mu_1_by_b_2_z*t929 + mu_2_by_b_2_z*t930 + mu_3_by_b_2_z*t931
    )
    t1360 = t1265*x_2_by_b_2_z
    t1361 = -R_p_2*t1360
    t1362 = R_p_2*t1358
    t1363 = (
        D_delta_x_1_by_b_2_z*t1095 + D_delta_y_1_by_b_2_z*t1096 + D_delta_z_1_by_b_2_z*t1097
        - D_p_x_2_by_b_2_z*t1054 - D_p_x_2_by_b_2_z*t1055 - D_p_x_2_by_b_2_z*t1056 + D_p_x_2_by_b_2_z*t1152
        - D_p_y_2_by_b_2_z*t1057 - D_p_y_2_by_b_2_z*t1058 - D_p_y_2_by_b_2_z*t1059 + D_p_y_2_by_b_2_z*t1153
        - D_p_z_2_by_b_2_z*t1060 - D_p_z_2_by_b_2_z*t1061 - D_p_z_2_by_b_2_z*t1062 + D_p_z_2_by_b_2_z*t1154
        + mu_1_by_b_2_z*t933 + mu_2_by_b_2_z*t934 + mu_3_by_b_2_z*t935
    )
    t1364 = (
        D_delta_x_2_by_b_2_z*t1095 + D_delta_y_2_by_b_2_z*t1096 + D_delta_z_2_by_b_2_z*t1097
        - D_p_x_2_by_b_2_z*t1067 - D_p_x_2_by_b_2_z*t1068 - D_p_x_2_by_b_2_z*t1069 + D_p_x_2_by_b_2_z*t1156
        - D_p_y_2_by_b_2_z*t1070 - D_p_y_2_by_b_2_z*t1071 - D_p_y_2_by_b_2_z*t1072 + D_p_y_2_by_b_2_z*t1157
        - D_p_z_2_by_b_2_z*t1073 - D_p_z_2_by_b_2_z*t1074 - D_p_z_2_by_b_2_z*t1075 + D_p_z_2_by_b_2_z*t1158
        + mu_1_by_b_2_z*t937 + mu_2_by_b_2_z*t938 + mu_3_by_b_2_z*t939
    )
    t1365 = (
        D_delta_x_3_by_b_2_z*t1095 + D_delta_y_3_by_b_2_z*t1096 + D_delta_z_3_by_b_2_z*t1097
        - D_p_x_2_by_b_2_z*t1077 - D_p_x_2_by_b_2_z*t1078 - D_p_x_2_by_b_2_z*t1079 + D_p_x_2_by_b_2_z*t1160
        - D_p_y_2_by_b_2_z*t1080 - D_p_y_2_by_b_2_z*t1081 - D_p_y_2_by_b_2_z*t1082 + D_p_y_2_by_b_2_z*t1161
        - D_p_z_2_by_b_2_z*t1083 - D_p_z_2_by_b_2_z*t1084 - D_p_z_2_by_b_2_z*t1085 + D_p_z_2_by_b_2_z*t1162
        + mu_1_by_b_2_z*t941 + mu_2_by_b_2_z*t942 + mu_3_by_b_2_z*t943
    )
    t1366 = -t1358 + t1360
    t1367 = D_p_x_2_by_b_2_z*k_C
    t1368 = D_p_y_2_by_b_2_z*k_C
    t1369 = D_p_z_2_by_b_2_z*k_C
    t1370 = 2*D_p_x_3_by_b_2_z
    t1371 = 2*D_p_y_3_by_b_2_z
    t1372 = 2*D_p_z_3_by_b_2_z
    t1373 = (
        D_delta_x_1_by_b_2_z*t1107 + D_delta_y_1_by_b_2_z*t1108 + D_delta_z_1_by_b_2_z*t1109
        - D_p_x_3_by_b_2_z*t1054 - D_p_x_3_by_b_2_z*t1055 - D_p_x_3_by_b_2_z*t1056 + D_p_x_3_by_b_2_z*t1152
        - D_p_y_3_by_b_2_z*t1057 - D_p_y_3_by_b_2_z*t1058 - D_p_y_3_by_b_2_z*t1059 + D_p_y_3_by_b_2_z*t1153
        - D_p_z_3_by_b_2_z*t1060 - D_p_z_3_by_b_2_z*t1061 - D_p_z_3_by_b_2_z*t1062 + D_p_z_3_by_b_2_z*t1154
        + mu_1_by_b_2_z*t948 + mu_2_by_b_2_z*t949 + mu_3_by_b_2_z*t950
    )
    t1374 = (
        D_delta_x_2_by_b_2_z*t1107 + D_delta_y_2_by_b_2_z*t1108 + D_delta_z_2_by_b_2_z*t1109
        - D_p_x_3_by_b_2_z*t1067 - D_p_x_3_by_b_2_z*t1068 - D_p_x_3_by_b_2_z*t1069 + D_p_x_3_by_b_2_z*t1156
        - D_p_y_3_by_b_2_z*t1070 - D_p_y_3_by_b_2_z*t1071 - D_p_y_3_by_b_2_z*t1072 + D_p_y_3_by_b_2_z*t1157
        - D_p_z_3_by_b_2_z*t1073 - D_p_z_3_by_b_2_z*t1074 - D_p_z_3_by_b_2_z*t1075 + D_p_z_3_by_b_2_z*t1158
        + mu_1_by_b_2_z*t952 + mu_2_by_b_2_z*t953 + mu_3_by_b_2_z*t954
    )
    t1375 = (
        D_delta_x_3_by_b_2_z*t1107 + D_delta_y_3_by_b_2_z*t1108 + D_delta_z_3_by_b_2_z*t1109
        - D_p_x_3_by_b_2_z*t1077 - D_p_x_3_by_b_2_z*t1078 - D_p_x_3_by_b_2_z*t1079 + D_p_x_3_by_b_2_z*t1160
        - D_p_y_3_by_b_2_z*t1080 - D_p_y_3_by_b_2_z*t1081 - D_p_y_3_by_b_2_z*t1082 + D_p_y_3_by_b_2_z*t1161
        - D_p_z_3_by_b_2_z*t1083 - D_p_z_3_by_b_2_z*t1084 - D_p_z_3_by_b_2_z*t1085 + D_p_z_3_by_b_2_z*t1162
        + mu_1_by_b_2_z*t958 + mu_2_by_b_2_z*t956 + mu_3_by_b_2_z*t957
    )
    t1376 = D_p_x_3_by_b_2_z*k_C
    t1377 = D_p_y_3_by_b_2_z*k_C
    t1378 = D_p_z_3_by_b_2_z*k_C
    t1379 = (
        D_delta_x_1_by_b_2_z*t1116 + D_delta_x_2_by_b_2_z*t1117 + D_delta_y_1_by_b_2_z*t1118
        + D_delta_y_2_by_b_2_z*t1119 + D_delta_z_1_by_b_2_z*t1120 + D_delta_z_2_by_b_2_z*t1121
        - mu_1_by_b_2_z*t242 - mu_2_by_b_2_z*t242 - mu_3_by_b_2_z*t242
    )
    t1380 = (
        D_delta_x_1_by_b_2_z*t1123 + D_delta_x_3_by_b_2_z*t1117 + D_delta_y_1_by_b_2_z*t1124
        + D_delta_y_3_by_b_2_z*t1119 + D_delta_z_1_by_b_2_z*t1125 + D_delta_z_3_by_b_2_z*t1121
        - mu_1_by_b_2_z*t246 - mu_2_by_b_2_z*t246 - mu_3_by_b_2_z*t246
    )
    t1381 = D_delta_x_1_by_b_2_z*k_C
    t1382 = D_delta_y_1_by_b_2_z*k_C
    t1383 = D_delta_z_1_by_b_2_z*k_C
    t1384 = (
        D_delta_x_2_by_b_2_z*t1123 + D_delta_x_3_by_b_2_z*t1116 + D_delta_y_2_by_b_2_z*t1124
        + D_delta_y_3_by_b_2_z*t1118 + D_delta_z_2_by_b_2_z*t1125 + D_delta_z_3_by_b_2_z*t1120
        - mu_1_by_b_2_z*t254 - mu_2_by_b_2_z*t254 - mu_3_by_b_2_z*t254
    )
    t1385 = D_delta_x_2_by_b_2_z*k_C
    t1386 = D_delta_y_2_by_b_2_z*k_C
    t1387 = D_delta_z_2_by_b_2_z*k_C
    t1388 = D_delta_x_3_by_b_2_z*k_C
    t1389 = D_delta_y_3_by_b_2_z*k_C
    t1390 = D_delta_z_3_by_b_2_z*k_C
    t1391 = 2*D_p_x_1_by_b_3_x
    t1392 = 2*D_p_y_1_by_b_3_x
    t1393 = 2*D_p_z_1_by_b_3_x
    t1394 = (
        D_p_x_1*D_p_x_2_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_2*k_C - D_p_x_1_by_b_3_x*t1027
        - D_p_x_1_by_b_3_x*t1028 - D_p_x_1_by_b_3_x*t1029 - D_p_x_2_by_b_3_x*t1011 - D_p_x_2_by_b_3_x*t1013
        - D_p_x_2_by_b_3_x*t1014 + D_p_y_1*D_p_y_2_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_2*k_C
        - D_p_y_1_by_b_3_x*t1030 - D_p_y_1_by_b_3_x*t1031 - D_p_y_1_by_b_3_x*t1032 - D_p_y_2_by_b_3_x*t1015
        - D_p_y_2_by_b_3_x*t1017 - D_p_y_2_by_b_3_x*t1018 + D_p_z_1*D_p_z_2_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_2*k_C - D_p_z_1_by_b_3_x*t1033 - D_p_z_1_by_b_3_x*t1034
        - D_p_z_1_by_b_3_x*t1035 - D_p_z_2_by_b_3_x*t1019 - D_p_z_2_by_b_3_x*t1021 - D_p_z_2_by_b_3_x*t1022
        + mu_1_by_b_3_x*t906 + mu_2_by_b_3_x*t907 + mu_3_by_b_3_x*t908
    )
    t1395 = (
        D_p_x_1*D_p_x_3_by_b_3_x*k_C + D_p_x_1_by_b_3_x*D_p_x_3*k_C - D_p_x_1_by_b_3_x*t1037
        - D_p_x_1_by_b_3_x*t1038 - D_p_x_1_by_b_3_x*t1039 - D_p_x_3_by_b_3_x*t1011 - D_p_x_3_by_b_3_x*t1013
        - D_p_x_3_by_b_3_x*t1014 + D_p_y_1*D_p_y_3_by_b_3_x*k_C + D_p_y_1_by_b_3_x*D_p_y_3*k_C
        - D_p_y_1_by_b_3_x*t1040 - D_p_y_1_by_b_3_x*t1041 - D_p_y_1_by_b_3_x*t1042 - D_p_y_3_by_b_3_x*t1015
        - D_p_y_3_by_b_3_x*t1017 - D_p_y_3_by_b_3_x*t1018 + D_p_z_1*D_p_z_3_by_b_3_x*k_C
        + D_p_z_1_by_b_3_x*D_p_z_3*k_C - D_p_z_1_by_b_3_x*t1043 - D_p_z_1_by_b_3_x*t1044
        - D_p_z_1_by_b_3_x*t1045 - D_p_z_3_by_b_3_x*t1019 - D_p_z_3_by_b_3_x*t1021 - D_p_z_3_by_b_3_x*t1022
        + mu_1_by_b_3_x*t910 + mu_2_by_b_3_x*t911 + mu_3_by_b_3_x*t912
    )
    t1396 = (
        D_delta_x_1_by_b_3_x*t1063 + D_delta_y_1_by_b_3_x*t1064 + D_delta_z_1_by_b_3_x*t1065
        - D_p_x_1_by_b_3_x*t1054 - D_p_x_1_by_b_3_x*t1055 - D_p_x_1_by_b_3_x*t1056 + D_p_x_1_by_b_3_x*t1152
        - D_p_y_1_by_b_3_x*t1057 - D_p_y_1_by_b_3_x*t1058 - D_p_y_1_by_b_3_x*t1059 + D_p_y_1_by_b_3_x*t1153
        - D_p_z_1_by_b_3_x*t1060 - D_p_z_1_by_b_3_x*t1061 - D_p_z_1_by_b_3_x*t1062 + D_p_z_1_by_b_3_x*t1154
        + mu_1_by_b_3_x*t914 + mu_2_by_b_3_x*t915 + mu_3_by_b_3_x*t916
    )
    t1397 = (
        D_delta_x_2_by_b_3_x*t1063 + D_delta_y_2_by_b_3_x*t1064 + D_delta_z_2_by_b_3_x*t1065
        - D_p_x_1_by_b_3_x*t1067 - D_p_x_1_by_b_3_x*t1068 - D_p_x_1_by_b_3_x*t1069 + D_p_x_1_by_b_3_x*t1156
        - D_p_y_1_by_b_3_x*t1070 - D_p_y_1_by_b_3_x*t1071 - D_p_y_1_by_b_3_x*t1072 + D_p_y_1_by_b_3_x*t1157
        - D_p_z_1_by_b_3_x*t1073 - D_p_z_1_by_b_3_x*t1074 - D_p_z_1_by_b_3_x*t1075 + D_p_z_1_by_b_3_x*t1158
        + mu_1_by_b_3_x*t918 + mu_2_by_b_3_x*t919 + mu_3_by_b_3_x*t920
    )
    t1398 = (
        D_delta_x_3_by_b_3_x*t1063 + D_delta_y_3_by_b_3_x*t1064 + D_delta_z_3_by_b_3_x*t1065
        - D_p_x_1_by_b_3_x*t1077 - D_p_x_1_by_b_3_x*t1078 - D_p_x_1_by_b_3_x*t1079 + D_p_x_1_by_b_3_x*t1160
        - D_p_y_1_by_b_3_x*t1080 - D_p_y_1_by_b_3_x*t1081 - D_p_y_1_by_b_3_x*t1082 + D_p_y_1_by_b_3_x*t1161
        - D_p_z_1_by_b_3_x*t1083 - D_p_z_1_by_b_3_x*t1084 - D_p_z_1_by_b_3_x*t1085 + D_p_z_1_by_b_3_x*t1162
        + mu_1_by_b_3_x*t922 + mu_2_by_b_3_x*t923 + mu_3_by_b_3_x*t924
    )
    t1399 = D_p_x_1_by_b_3_x*k_C
    t1400 = D_p_y_1_by_b_3_x*k_C
    t1401 = D_p_z_1_by_b_3_x*k_C
    t1402 = 2*D_p_x_2_by_b_3_x
    t1403 = 2*D_p_y_2_by_b_3_x
    t1404 = 2*D_p_z_2_by_b_3_x
    t1405 = (
        D_p_x_2*D_p_x_3_by_b_3_x*k_C + D_p_x_2_by_b_3_x*D_p_x_3*k_C - D_p_x_2_by_b_3_x*t1037
        - D_p_x_2_by_b_3_x*t1038 - D_p_x_2_by_b_3_x*t1039 - D_p_x_3_by_b_3_x*t1027 - D_p_x_3_by_b_3_x*t1028
        - D_p_x_3_by_b_3_x*t1029 + D_p_y_2*D_p_y_3_by_b_3_x*k_C + D_p_y_2_by_b_3_x*D_p_y_3*k_C
        - D_p_y_2_by_b_3_x*t1040 - D_p_y_2_by_b_3_x*t1041 - D_p_y_2_by_b_3_x*t1042 - D_p_y_3_by_b_3_x*t1030
        - D_p_y_3_by_b_3_x*t1031 - D_p_y_3_by_b_3_x*t1032 + D_p_z_2*D_p_z_3_by_b_3_x*k_C
        + D_p_z_2_by_b_3_x*D_p_z_3*k_C - D_p_z_2_by_b_3_x*t1043 - D_p_z_2_by_b_3_x*t1044
        - D_p_z_2_by_b_3_x*t1045 - D_p_z_3_by_b_3_x*t1033 - D_p_z_3_by_b_3_x*t1034 - D_p_z_3_by_b_3_x*t1035
        + mu_1_by_b_3_x*t929 + mu_2_by_b_3_x*t930 + mu_3_by_b_3_x*t931
    )
    t1406 = (
        D_delta_x_1_by_b_3_x*t1095 + D_delta_y_1_by_b_3_x*t1096 + D_delta_z_1_by_b_3_x*t1097
        - D_p_x_2_by_b_3_x*t1054 - D_p_x_2_by_b_3_x*t1055 - D_p_x_2_by_b_3_x*t1056 + D_p_x_2_by_b_3_x*t1152
        - D_p_y_2_by_b_3_x*t1057 - D_p_y_2_by_b_3_x*t1058 - D_p_y_2_by_b_3_x*t1059 + D_p_y_2_by_b_3_x*t1153
        - D_p_z_2_by_b_3_x*t1060 - D_p_z_2_by_b_3_x*t1061 - D_p_z_2_by_b_3_x*t1062 + D_p_z_2_by_b_3_x*t1154
        + mu_1_by_b_3_x*t933 + mu_2_by_b_3_x*t934 + mu_3_by_b_3_x*t935
    )
    t1407 = (
        D_delta_x_2_by_b_3_x*t1095 + D_delta_y_2_by_b_3_x*t1096 + D_delta_z_2_by_b_3_x*t1097
        - D_p_x_2_by_b_3_x*t1067 - D_p_x_2_by_b_3_x*t1068 - D_p_x_2_by_b_3_x*t1069 + D_p_x_2_by_b_3_x*t1156
        - D_p_y_2_by_b_3_x*t1070 - D_p_y_2_by_b_3_x*t1071 - D_p_y_2_by_b_3_x*t1072 + D_p_y_2_by_b_3_x*t1157
        - D_p_z_2_by_b_3_x*t1073 - D_p_z_2_by_b_3_x*t1074 - D_p_z_2_by_b_3_x*t1075 + D_p_z_2_by_b_3_x*t1158
        + mu_1_by_b_3_x*t937 + mu_2_by_b_3_x*t938 + mu_3_by_b_3_x*t939
    )
    t1408 = (
        D_delta_x_3_by_b_3_x*t1095 + D_delta_y_3_by_b_3_x*t1096 + D_delta_z_3_by_b_3_x*t1097
        - D_p_x_2_by_b_3_x*t1077 - D_p_x_2_by_b_3_x*t1078 - D_p_x_2_by_b_3_x*t1079 + D_p_x_2_by_b_3_x*t1160
        - D_p_y_2_by_b_3_x*t1080 - D_p_y_2_by_b_3_x*t1081 - D_p_y_2_by_b_3_x*t1082 + D_p_y_2_by_b_3_x*t1161
        - D_p_z_2_by_b_3_x*t1083 - D_p_z_2_by_b_3_x*t1084 - D_p_z_2_by_b_3_x*t1085 + D_p_z_2_by_b_3_x*t1162
        + mu_1_by_b_3_x*t941 + mu_2_by_b_3_x*t942 + mu_3_by_b_3_x*t943
    )
    t1409 = D_p_x_2_by_b_3_x*k_C
    t1410 = D_p_y_2_by_b_3_x*k_C
    t1411 = D_p_z_2_by_b_3_x*k_C
    t1412 = 2*D_p_x_3_by_b_3_x
    t1413 = 2*D_p_y_3_by_b_3_x
    t1414 = 2*D_p_z_3_by_b_3_x
    t1415 = 1.0/(t40**2)
    t1416 = t1415*t35
    t1417 = t1416*x_3_by_b_3_x
    t1418 = 1.0/(t42**2)
    t1419 = t1418*t35
    t1420 = t1419*x_3_by_b_3_x
    t1421 = -R_p_3*t1420
    t1422 = R_p_3*t1417
    t1423 = (
        D_delta_x_1_by_b_3_x*t1107 + D_delta_y_1_by_b_3_x*t1108 + D_delta_z_1_by_b_3_x*t1109
        - D_p_x_3_by_b_3_x*t1054 - D_p_x_3_by_b_3_x*t1055 - D_p_x_3_by_b_3_x*t1056 + D_p_x_3_by_b_3_x*t1152
        - D_p_y_3_by_b_3_x*t1057 - D_p_y_3_by_b_3_x*t1058 - D_p_y_3_by_b_3_x*t1059 + D_p_y_3_by_b_3_x*t1153
        - D_p_z_3_by_b_3_x*t1060 - D_p_z_3_by_b_3_x*t1061 - D_p_z_3_by_b_3_x*t1062 + D_p_z_3_by_b_3_x*t1154
        + mu_1_by_b_3_x*t948 + mu_2_by_b_3_x*t949 + mu_3_by_b_3_x*t950
    )
    t1424 = (
        D_delta_x_2_by_b_3_x*t1107 + D_delta_y_2_by_b_3_x*t1108 + D_delta_z_2_by_b_3_x*t1109
        - D_p_x_3_by_b_3_x*t1067 - D_p_x_3_by_b_3_x*t1068 - D_p_x_3_by_b_3_x*t1069 + D_p_x_3_by_b_3_x*t1156
        - D_p_y_3_by_b_3_x*t1070 - D_p_y_3_by_b_3_x*t1071 - D_p_y_3_by_b_3_x*t1072 + D_p_y_3_by_b_3_x*t1157
        - D_p_z_3_by_b_3_x*t1073 - D_p_z_3_by_b_3_x*t1074 - D_p_z_3_by_b_3_x*t1075 + D_p_z_3_by_b_3_x*t1158
        + mu_1_by_b_3_x*t952 + mu_2_by_b_3_x*t953 + mu_3_by_b_3_x*t954
    )
    t1425 = (
        D_delta_x_3_by_b_3_x*t1107 + D_delta_y_3_by_b_3_x*t1108 + D_delta_z_3_by_b_3_x*t1109
        - D_p_x_3_by_b_3_x*t1077 - D_p_x_3_by_b_3_x*t1078 - D_p_x_3_by_b_3_x*t1079 + D_p_x_3_by_b_3_x*t1160
        - D_p_y_3_by_b_3_x*t1080 - D_p_y_3_by_b_3_x*t1081 - D_p_y_3_by_b_3_x*t1082 + D_p_y_3_by_b_3_x*t1161
        - D_p_z_3_by_b_3_x*t1083 - D_p_z_3_by_b_3_x*t1084 - D_p_z_3_by_b_3_x*t1085 + D_p_z_3_by_b_3_x*t1162
        + mu_1_by_b_3_x*t958 + mu_2_by_b_3_x*t956 + mu_3_by_b_3_x*t957
    )
    t1426 = -t1417 + t1420
    t1427 = D_p_x_3_by_b_3_x*k_C
    t1428 = D_p_y_3_by_b_3_x*k_C
    t1429 = D_p_z_3_by_b_3_x*k_C
    t1430 = (
        D_delta_x_1_by_b_3_x*t1116 + D_delta_x_2_by_b_3_x*t1117 + D_delta_y_1_by_b_3_x*t1118
        + D_delta_y_2_by_b_3_x*t1119 + D_delta_z_1_by_b_3_x*t1120 + D_delta_z_2_by_b_3_x*t1121
        - mu_1_by_b_3_x*t242 - mu_2_by_b_3_x*t242 - mu_3_by_b_3_x*t242
    )
    t1431 = (
        D_delta_x_1_by_b_3_x*t1123 + D_delta_x_3_by_b_3_x*t1117 + D_delta_y_1_by_b_3_x*t1124
        + D_delta_y_3_by_b_3_x*t1119 + D_delta_z_1_by_b_3_x*t1125 + D_delta_z_3_by_b_3_x*t1121
        - mu_1_by_b_3_x*t246 - mu_2_by_b_3_x*t246 - mu_3_by_b_3_x*t246
    )
    t1432 = D_delta_x_1_by_b_3_x*k_C
    t1433 = D_delta_y_1_by_b_3_x*k_C
    t1434 = D_delta_z_1_by_b_3_x*k_C
    t1435 = (
        D_delta_x_2_by_b_3_x*t1123 + D_delta_x_3_by_b_3_x*t1116 + D_delta_y_2_by_b_3_x*t1124
        + D_delta_y_3_by_b_3_x*t1118 + D_delta_z_2_by_b_3_x*t1125 + D_delta_z_3_by_b_3_x*t1120
        - mu_1_by_b_3_x*t254 - mu_2_by_b_3_x*t254 - mu_3_by_b_3_x*t254
    )
    t1436 = D_delta_x_2_by_b_3_x*k_C
    t1437 = D_delta_y_2_by_b_3_x*k_C
    t1438 = D_delta_z_2_by_b_3_x*k_C
    t1439 = D_delta_x_3_by_b_3_x*k_C
    t1440 = D_delta_y_3_by_b_3_x*k_C
    t1441 = D_delta_z_3_by_b_3_x*k_C
    t1442 = 2*D_p_x_1_by_b_3_y
    t1443 = 2*D_p_y_1_by_b_3_y
    t1444 = 2*D_p_z_1_by_b_3_y
    t1445 = (
        D_p_x_1*D_p_x_2_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_2*k_C - D_p_x_1_by_b_3_y*t1027
        - D_p_x_1_by_b_3_y*t1028 - D_p_x_1_by_b_3_y*t1029 - D_p_x_2_by_b_3_y*t1011 - D_p_x_2_by_b_3_y*t1013
        - D_p_x_2_by_b_3_y*t1014 + D_p_y_1*D_p_y_2_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_2*k_C
        - D_p_y_1_by_b_3_y*t1030 - D_p_y_1_by_b_3_y*t1031 - D_p_y_1_by_b_3_y*t1032 - D_p_y_2_by_b_3_y*t1015
        - D_p_y_2_by_b_3_y*t1017 - D_p_y_2_by_b_3_y*t1018 + D_p_z_1*D_p_z_2_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_2*k_C - D_p_z_1_by_b_3_y*t1033 - D_p_z_1_by_b_3_y*t1034
        - D_p_z_1_by_b_3_y*t1035 - D_p_z_2_by_b_3_y*t1019 - D_p_z_2_by_b_3_y*t1021 - D_p_z_2_by_b_3_y*t1022
        + mu_1_by_b_3_y*t906 + mu_2_by_b_3_y*t907 + mu_3_by_b_3_y*t908
    )
    t1446 = (
        D_p_x_1*D_p_x_3_by_b_3_y*k_C + D_p_x_1_by_b_3_y*D_p_x_3*k_C - D_p_x_1_by_b_3_y*t1037
        - D_p_x_1_by_b_3_y*t1038 - D_p_x_1_by_b_3_y*t1039 - D_p_x_3_by_b_3_y*t1011 - D_p_x_3_by_b_3_y*t1013
        - D_p_x_3_by_b_3_y*t1014 + D_p_y_1*D_p_y_3_by_b_3_y*k_C + D_p_y_1_by_b_3_y*D_p_y_3*k_C
        - D_p_y_1_by_b_3_y*t1040 - D_p_y_1_by_b_3_y*t1041 - D_p_y_1_by_b_3_y*t1042 - D_p_y_3_by_b_3_y*t1015
        - D_p_y_3_by_b_3_y*t1017 - D_p_y_3_by_b_3_y*t1018 + D_p_z_1*D_p_z_3_by_b_3_y*k_C
        + D_p_z_1_by_b_3_y*D_p_z_3*k_C - D_p_z_1_by_b_3_y*t1043 - D_p_z_1_by_b_3_y*t1044
        - D_p_z_1_by_b_3_y*t1045 - D_p_z_3_by_b_3_y*t1019 - D_p_z_3_by_b_3_y*t1021 - D_p_z_3_by_b_3_y*t1022
        + mu_1_by_b_3_y*t910 + mu_2_by_b_3_y*t911 + mu_3_by_b_3_y*t912
    )
    t1447 = (
        D_delta_x_1_by_b_3_y*t1063 + D_delta_y_1_by_b_3_y*t1064 + D_delta_z_1_by_b_3_y*t1065
        - D_p_x_1_by_b_3_y*t1054 - D_p_x_1_by_b_3_y*t1055 - D_p_x_1_by_b_3_y*t1056 + D_p_x_1_by_b_3_y*t1152
        - D_p_y_1_by_b_3_y*t1057 - D_p_y_1_by_b_3_y*t1058 - D_p_y_1_by_b_3_y*t1059 + D_p_y_1_by_b_3_y*t1153
        - D_p_z_1_by_b_3_y*t1060 - D_p_z_1_by_b_3_y*t1061 - D_p_z_1_by_b_3_y*t1062 + D_p_z_1_by_b_3_y*t1154
        + mu_1_by_b_3_y*t914 + mu_2_by_b_3_y*t915 + mu_3_by_b_3_y*t916
    )
    t1448 = (
        D_delta_x_2_by_b_3_y*t1063 + D_delta_y_2_by_b_3_y*t1064 + D_delta_z_2_by_b_3_y*t1065
        - D_p_x_1_by_b_3_y*t1067 - D_p_x_1_by_b_3_y*t1068 - D_p_x_1_by_b_3_y*t1069 + D_p_x_1_by_b_3_y*t1156
        - D_p_y_1_by_b_3_y*t1070 - D_p_y_1_by_b_3_y*t1071 - D_p_y_1_by_b_3_y*t1072 + D_p_y_1_by_b_3_y*t1157
        - D_p_z_1_by_b_3_y*t1073 - D_p_z_1_by_b_3_y*t1074 - D_p_z_1_by_b_3_y*t1075 + D_p_z_1_by_b_3_y*t1158
        + mu_1_by_b_3_y*t918 + mu_2_by_b_3_y*t919 + mu_3_by_b_3_y*t920
    )
    t1449 = (
        D_delta_x_3_by_b_3_y*t1063 + D_delta_y_3_by_b_3_y*t1064 + D_delta_z_3_by_b_3_y*t1065
        - D_p_x_1_by_b_3_y*t1077 - D_p_x_1_by_b_3_y*t1078 - D_p_x_1_by_b_3_y*t1079 + D_p_x_1_by_b_3_y*t1160
        - D_p_y_1_by_b_3_y*t1080 - D_p_y_1_by_b_3_y*t1081 - D_p_y_1_by_b_3_y*t1082 + D_p_y_1_by_b_3_y*t1161
        - D_p_z_1_by_b_3_y*t1083 - D_p_z_1_by_b_3_y*t1084 - D_p_z_1_by_b_3_y*t1085 + D_p_z_1_by_b_3_y*t1162
        + mu_1_by_b_3_y*t922 + mu_2_by_b_3_y*t923 + mu_3_by_b_3_y*t924
    )
    t1450 = D_p_x_1_by_b_3_y*k_C
    t1451 = D_p_y_1_by_b_3_y*k_C
    t1452 = D_p_z_1_by_b_3_y*k_C
    t1453 = 2*D_p_x_2_by_b_3_y
    t1454 = 2*D_p_y_2_by_b_3_y
    t1455 = 2*D_p_z_2_by_b_3_y
    t1456 = (
        D_p_x_2*D_p_x_3_by_b_3_y*k_C + D_p_x_2_by_b_3_y*D_p_x_3*k_C - D_p_x_2_by_b_3_y*t1037
        - D_p_x_2_by_b_3_y*t1038 - D_p_x_2_by_b_3_y*t1039 - D_p_x_3_by_b_3_y*t1027 - D_p_x_3_by_b_3_y*t1028
        - D_p_x_3_by_b_3_y*t1029 + D_p_y_2*D_p_y_3_by_b_3_y*k_C + D_p_y_2_by_b_3_y*D_p_y_3*k_C
        - D_p_y_2_by_b_3_y*t1040 - D_p_y_2_by_b_3_y*t1041 - D_p_y_2_by_b_3_y*t1042 - D_p_y_3_by_b_3_y*t1030
        - D_p_y_3_by_b_3_y*t1031 - D_p_y_3_by_b_3_y*t1032 + D_p_z_2*D_p_z_3_by_b_3_y*k_C
        + D_p_z_2_by_b_3_y*D_p_z_3*k_C - D_p_z_2_by_b_3_y*t1043 - D_p_z_2_by_b_3_y*t1044
        - D_p_z_2_by_b_3_y*t1045 - D_p_z_3_by_b_3_y*t1033 - D_p_z_3_by_b_3_y*t1034 - D_p_z_3_by_b_3_y*t1035
        + mu_1_by_b_3_y*t929 + mu_2_by_b_3_y*t930 + mu_3_by_b_3_y*t931
    )
    t1457 = (
        D_delta_x_1_by_b_3_y*t1095 + D_delta_y_1_by_b_3_y*t1096 + D_delta_z_1_by_b_3_y*t1097
        - D_p_x_2_by_b_3_y*t1054 - D_p_x_2_by_b_3_y*t1055 - D_p_x_2_by_b_3_y*t1056 + D_p_x_2_by_b_3_y*t1152
        - D_p_y_2_by_b_3_y*t1057 - D_p_y_2_by_b_3_y*t1058 - D_p_y_2_by_b_3_y*t1059 + D_p_y_2_by_b_3_y*t1153
        - D_p_z_2_by_b_3_y*t1060 - D_p_z_2_by_b_3_y*t1061 - D_p_z_2_by_b_3_y*t1062 + D_p_z_2_by_b_3_y*t1154
        + mu_1_by_b_3_y*t933 + mu_2_by_b_3_y*t934 + mu_3_by_b_3_y*t935
    )
    t1458 = (
        D_delta_x_2_by_b_3_y*t1095 + D_delta_y_2_by_b_3_y*t1096 + D_delta_z_2_by_b_3_y*t1097
        - D_p_x_2_by_b_3_y*t1067 - D_p_x_2_by_b_3_y*t1068 - D_p_x_2_by_b_3_y*t1069 + D_p_x_2_by_b_3_y*t1156
        - D_p_y_2_by_b_3_y*t1070 - D_p_y_2_by_b_3_y*t1071 - D_p_y_2_by_b_3_y*t1072 + D_p_y_2_by_b_3_y*t1157
        - D_p_z_2_by_b_3_y*t1073 - D_p_z_2_by_b_3_y*t1074 - D_p_z_2_by_b_3_y*t1075 + D_p_z_2_by_b_3_y*t1158
        + mu_1_by_b_3_y*t937 + mu_2_by_b_3_y*t938 + mu_3_by_b_3_y*t939
    )
    t1459 = (
        D_delta_x_3_by_b_3_y*t1095 + D_delta_y_3_by_b_3_y*t1096 + D_delta_z_3_by_b_3_y*t1097
        - D_p_x_2_by_b_3_y*t1077 - D_p_x_2_by_b_3_y*t1078 - D_p_x_2_by_b_3_y*t1079 + D_p_x_2_by_b_3_y*t1160
        - D_p_y_2_by_b_3_y*t1080 - D_p_y_2_by_b_3_y*t1081 - D_p_y_2_by_b_3_y*t1082 + D_p_y_2_by_b_3_y*t1161
        - D_p_z_2_by_b_3_y*t1083 - D_p_z_2_by_b_3_y*t1084 - D_p_z_2_by_b_3_y*t1085 + D_p_z_2_by_b_3_y*t1162
        + mu_1_by_b_3_y*t941 + mu_2_by_b_3_y*t942 + mu_3_by_b_3_y*t943
    )
    t1460 = D_p_x_2_by_b_3_y*k_C
    t1461 = D_p_y_2_by_b_3_y*k_C
    t1462 = D_p_z_2_by_b_3_y*k_C
    t1463 = 2*D_p_x_3_by_b_3_y
    t1464 = 2*D_p_y_3_by_b_3_y
    t1465 = 2*D_p_z_3_by_b_3_y
    t1466 = t1416*x_3_by_b_3_y
    t1467 = t1419*x_3_by_b_3_y
    t1468 = -R_p_3*t1467
    t1469 = R_p_3*t1466
    t1470 = (
        D_delta_x_1_by_b_3_y*t1107 + D_delta_y_1_by_b_3_y*t1108 + D_delta_z_1_by_b_3_y*t1109
        - D_p_x_3_by_b_3_y*t1054 - D_p_x_3_by_b_3_y*t1055 - D_p_x_3_by_b_3_y*t1056 + D_p_x_3_by_b_3_y*t1152
        - D_p_y_3_by_b_3_y*t1057 - D_p_y_3_by_b_3_y*t1058 - D_p_y_3_by_b_3_y*t1059 + D_p_y_3_by_b_3_y*t1153
        - D_p_z_3_by_b_3_y*t1060 - D_p_z_3_by_b_3_y*t1061 - D_p_z_3_by_b_3_y*t1062 + D_p_z_3_by_b_3_y*t1154
        + mu_1_by_b_3_y*t948 + mu_2_by_b_3_y*t949 + mu_3_by_b_3_y*t950
    )
    t1471 = (
        D_delta_x_2_by_b_3_y*t1107 + D_delta_y_2_by_b_3_y*t1108 + D_delta_z_2_by_b_3_y*t1109
        - D_p_x_3_by_b_3_y*t1067 - D_p_x_3_by_b_3_y*t1068 - D_p_x_3_by_b_3_y*t1069 + D_p_x_3_by_b_3_y*t1156
        - D_p_y_3_by_b_3_y*t1070 - D_p_y_3_by_b_3_y*t1071 - D_p_y_3_by_b_3_y*t1072 + D_p_y_3_by_b_3_y*t1157
        - D_p_z_3_by_b_3_y*t1073 - D_p_z_3_by_b_3_y*t1074 - D_p_z_3_by_b_3_y*t1075 + D_p_z_3_by_b_3_y*t1158
        + mu_1_by_b_3_y*t952 + mu_2_by_b_3_y*t953 + mu_3_by_b_3_y*t954
    )
    t1472 = (
        D_delta_x_3_by_b_3_y*t1107 + D_delta_y_3_by_b_3_y*t1108 + D_delta_z_3_by_b_3_y*t1109
        - D_p_x_3_by_b_3_y*t1077 - D_p_x_3_by_b_3_y*t1078 - D_p_x_3_by_b_3_y*t1079 + D_p_x_3_by_b_3_y*t1160
        - D_p_y_3_by_b_3_y*t1080 - D_p_y_3_by_b_3_y*t1081 - D_p_y_3_by_b_3_y*t1082 + D_p_y_3_by_b_3_y*t1161
        - D_p_z_3_by_b_3_y*t1083 - D_p_z_3_by_b_3_y*t1084 - D_p_z_3_by_b_3_y*t1085 + D_p_z_3_by_b_3_y*t1162
        + mu_1_by_b_3_y*t958 + mu_2_by_b_3_y*t956 + mu_3_by_b_3_y*t957
    )
    t1473 = -t1466 + t1467
    t1474 = D_p_x_3_by_b_3_y*k_C
    t1475 = D_p_y_3_by_b_3_y*k_C
    t1476 = D_p_z_3_by_b_3_y*k_C
    t1477 = (
        D_delta_x_1_by_b_3_y*t1116 + D_delta_x_2_by_b_3_y*t1117 + D_delta_y_1_by_b_3_y*t1118
        + D_delta_y_2_by_b_3_y*t1119 + D_delta_z_1_by_b_3_y*t1120 + D_delta_z_2_by_b_3_y*t1121
        - mu_1_by_b_3_y*t242 - mu_2_by_b_3_y*t242 - mu_3_by_b_3_y*t242
    )
    t1478 = (
        D_delta_x_1_by_b_3_y*t1123 + D_delta_x_3_by_b_3_y*t1117 + D_delta_y_1_by_b_3_y*t1124
        + D_delta_y_3_by_b_3_y*t1119 + D_delta_z_1_by_b_3_y*t1125 + D_delta_z_3_by_b_3_y*t1121
        - mu_1_by_b_3_y*t246 - mu_2_by_b_3_y*t246 - mu_3_by_b_3_y*t246
    )
    t1479 = D_delta_x_1_by_b_3_y*k_C
    t1480 = D_delta_y_1_by_b_3_y*k_C
    t1481 = D_delta_z_1_by_b_3_y*k_C
    t1482 = (
        D_delta_x_2_by_b_3_y*t1123 + D_delta_x_3_by_b_3_y*t1116 + D_delta_y_2_by_b_3_y*t1124
        + D_delta_y_3_by_b_3_y*t1118 + D_delta_z_2_by_b_3_y*t1125 + D_delta_z_3_by_b_3_y*t1120
        - mu_1_by_b_3_y*t254 - mu_2_by_b_3_y*t254 - mu_3_by_b_3_y*t254
    )
    t1483 = D_delta_x_2_by_b_3_y*k_C
    t1484 = D_delta_y_2_by_b_3_y*k_C
    t1485 = D_delta_z_2_by_b_3_y*k_C
    t1486 = D_delta_x_3_by_b_3_y*k_C
    t1487 = D_delta_y_3_by_b_3_y*k_C
    t1488 = D_delta_z_3_by_b_3_y*k_C
    t1489 = 2*D_p_x_1_by_b_3_z
    t1490 = 2*D_p_y_1_by_b_3_z
    t1491 = 2*D_p_z_1_by_b_3_z
    t1492 = (
        D_p_x_1*D_p_x_2_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_2*k_C - D_p_x_1_by_b_3_z*t1027
        - D_p_x_1_by_b_3_z*t1028 - D_p_x_1_by_b_3_z*t1029 - D_p_x_2_by_b_3_z*t1011 - D_p_x_2_by_b_3_z*t1013
        - D_p_x_2_by_b_3_z*t1014 + D_p_y_1*D_p_y_2_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_2*k_C
        - D_p_y_1_by_b_3_z*t1030 - D_p_y_1_by_b_3_z*t1031 - D_p_y_1_by_b_3_z*t1032 - D_p_y_2_by_b_3_z*t1015
        - D_p_y_2_by_b_3_z*t1017 - D_p_y_2_by_b_3_z*t1018 + D_p_z_1*D_p_z_2_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_2*k_C - D_p_z_1_by_b_3_z*t1033 - D_p_z_1_by_b_3_z*t1034
        - D_p_z_1_by_b_3_z*t1035 - D_p_z_2_by_b_3_z*t1019 - D_p_z_2_by_b_3_z*t1021 - D_p_z_2_by_b_3_z*t1022
        + mu_1_by_b_3_z*t906 + mu_2_by_b_3_z*t907 + mu_3_by_b_3_z*t908
    )
    t1493 = (
        D_p_x_1*D_p_x_3_by_b_3_z*k_C + D_p_x_1_by_b_3_z*D_p_x_3*k_C - D_p_x_1_by_b_3_z*t1037
        - D_p_x_1_by_b_3_z*t1038 - D_p_x_1_by_b_3_z*t1039 - D_p_x_3_by_b_3_z*t1011 - D_p_x_3_by_b_3_z*t1013
        - D_p_x_3_by_b_3_z*t1014 + D_p_y_1*D_p_y_3_by_b_3_z*k_C + D_p_y_1_by_b_3_z*D_p_y_3*k_C
        - D_p_y_1_by_b_3_z*t1040 - D_p_y_1_by_b_3_z*t1041 - D_p_y_1_by_b_3_z*t1042 - D_p_y_3_by_b_3_z*t1015
        - D_p_y_3_by_b_3_z*t1017 - D_p_y_3_by_b_3_z*t1018 + D_p_z_1*D_p_z_3_by_b_3_z*k_C
        + D_p_z_1_by_b_3_z*D_p_z_3*k_C - D_p_z_1_by_b_3_z*t1043 - D_p_z_1_by_b_3_z*t1044
        - D_p_z_1_by_b_3_z*t1045 - D_p_z_3_by_b_3_z*t1019 - D_p_z_3_by_b_3_z*t1021 - D_p_z_3_by_b_3_z*t1022
        + mu_1_by_b_3_z*t910 + mu_2_by_b_3_z*t911 + mu_3_by_b_3_z*t912
    )
    t1494 = (
        D_delta_x_1_by_b_3_z*t1063 + D_delta_y_1_by_b_3_z*t1064 + D_delta_z_1_by_b_3_z*t1065
        - D_p_x_1_by_b_3_z*t1054 - D_p_x_1_by_b_3_z*t1055 - D_p_x_1_by_b_3_z*t1056 + D_p_x_1_by_b_3_z*t1152
        - D_p_y_1_by_b_3_z*t1057 - D_p_y_1_by_b_3_z*t1058 - D_p_y_1_by_b_3_z*t1059 + D_p_y_1_by_b_3_z*t1153
        - D_p_z_1_by_b_3_z*t1060 - D_p_z_1_by_b_3_z*t1061 - D_p_z_1_by_b_3_z*t1062 + D_p_z_1_by_b_3_z*t1154
        + mu_1_by_b_3_z*t914 + mu_2_by_b_3_z*t915 + mu_3_by_b_3_z*t916
    )
    t1495 = (
        D_delta_x_2_by_b_3_z*t1063 + D_delta_y_2_by_b_3_z*t1064 + D_delta_z_2_by_b_3_z*t1065
        - D_p_x_1_by_b_3_z*t1067 - D_p_x_1_by_b_3_z*t1068 - D_p_x_1_by_b_3_z*t1069 + D_p_x_1_by_b_3_z*t1156
        - D_p_y_1_by_b_3_z*t1070 - D_p_y_1_by_b_3_z*t1071 - D_p_y_1_by_b_3_z*t1072 + D_p_y_1_by_b_3_z*t1157
        - D_p_z_1_by_b_3_z*t1073 - D_p_z_1_by_b_3_z*t1074 - D_p_z_1_by_b_3_z*t1075 + D_p_z_1_by_b_3_z*t1158
        + mu_1_by_b_3_z*t918 + mu_2_by_b_3_z*t919 + mu_3_by_b_3_z*t920
    )
    t1496 = (
        D_delta_x_3_by_b_3_z*t1063 + D_delta_y_3_by_b_3_z*t1064 + D_delta_z_3_by_b_3_z*t1065
        - D_p_x_1_by_b_3_z*t1077 - D_p_x_1_by_b_3_z*t1078 - D_p_x_1_by_b_3_z*t1079 + D_p_x_1_by_b_3_z*t1160
        - D_p_y_1_by_b_3_z*t1080 - D_p_y_1_by_b_3_z*t1081 - D_p_y_1_by_b_3_z*t1082 + D_p_y_1_by_b_3_z*t1161
        - D_p_z_1_by_b_3_z*t1083 - D_p_z_1_by_b_3_z*t1084 - D_p_z_1_by_b_3_z*t1085 + D_p_z_1_by_b_3_z*t1162
        + mu_1_by_b_3_z*t922 + mu_2_by_b_3_z*t923 + mu_3_by_b_3_z*t924
    )
    t1497 = D_p_x_1_by_b_3_z*k_C
    t1498 = D_p_y_1_by_b_3_z*k_C
    t1499 = D_p_z_1_by_b_3_z*k_C
    t1500 = 2*D_p_x_2_by_b_3_z
    t1501 = 2*D_p_y_2_by_b_3_z
    t1502 = 2*D_p_z_2_by_b_3_z
    t1503 = (
        D_p_x_2*D_p_x_3_by_b_3_z*k_C + D_p_x_2_by_b_3_z*D_p_x_3*k_C - D_p_x_2_by_b_3_z*t1037
        - D_p_x_2_by_b_3_z*t1038 - D_p_x_2_by_b_3_z*t1039 - D_p_x_3_by_b_3_z*t1027 - D_p_x_3_by_b_3_z*t1028
        - D_p_x_3_by_b_3_z*t1029 + D_p_y_2*D_p_y_3_by_b_3_z*k_C + D_p_y_2_by_b_3_z*D_p_y_3*k_C
        - D_p_y_2_by_b_3_z*t1040 - D_p_y_2_by_b_3_z*t1041 - D_p_y_2_by_b_3_z*t1042 - D_p_y_3_by_b_3_z*t1030
        - D_p_y_3_by_b_3_z*t1031 - D_p_y_3_by_b_3_z*t1032 + D_p_z_2*D_p_z_3_by_b_3_z*k_C
        + D_p_z_2_by_b_3_z*D_p_z_3*k_C - D_p_z_2_by_b_3_z*t1043 - D_p_z_2_by_b_3_z*t1044
        - D_p_z_2_by_b_3_z*t1045 - D_p_z_3_by_b_3_z*t1033 - D_p_z_3_by_b_3_z*t1034 - D_p_z_3_by_b_3_z*t1035
        + mu_1_by_b_3_z*t929 + mu_2_by_b_3_z*t930 + mu_3_by_b_3_z*t931
    )
    t1504 = (
        D_delta_x_1_by_b_3_z*t1095 + D_delta_y_1_by_b_3_z*t1096 + D_delta_z_1_by_b_3_z*t1097
        - D_p_x_2_by_b_3_z*t1054 - D_p_x_2_by_b_3_z*t1055 - D_p_x_2_by_b_3_z*t1056 + D_p_x_2_by_b_3_z*t1152
        - D_p_y_2_by_b_3_z*t1057 - D_p_y_2_by_b_3_z*t1058 - D_p_y_2_by_b_3_z*t1059 + D_p_y_2_by_b_3_z*t1153
        - D_p_z_2_by_b_3_z*t1060 - D_p_z_2_by_b_3_z*t1061 - D_p_z_2_by_b_3_z*t1062 + D_p_z_2_by_b_3_z*t1154
        + mu_1_by_b_3_z*t933 + mu_2_by_b_3_z*t934 + mu_3_by_b_3_z*t935
    )
    t1505 = (
        D_delta_x_2_by_b_3_z*t1095 + D_delta_y_2_by_b_3_z*t1096 + D_delta_z_2_by_b_3_z*t1097
        - D_p_x_2_by_b_3_z*t1067 - D_p_x_2_by_b_3_z*t1068 - D_p_x_2_by_b_3_z*t1069 + D_p_x_2_by_b_3_z*t1156
        - D_p_y_2_by_b_3_z*t1070 - D_p_y_2_by_b_3_z*t1071 - D_p_y_2_by_b_3_z*t1072 + D_p_y_2_by_b_3_z*t1157
        - D_p_z_2_by_b_3_z*t1073 - D_p_z_2_by_b_3_z*t1074 - D_p_z_2_by_b_3_z*t1075 + D_p_z_2_by_b_3_z*t1158
        + mu_1_by_b_3_z*t937 + mu_2_by_b_3_z*t938 + mu_3_by_b_3_z*t939
    )
    t1506 = (
        D_delta_x_3_by_b_3_z*t1095 + D_delta_y_3_by_b_3_z*t1096 + D_delta_z_3_by_b_3_z*t1097
        - D_p_x_2_by_b_3_z*t1077 - D_p_x_2_by_b_3_z*t1078 - D_p_x_2_by_b_3_z*t1079 + D_p_x_2_by_b_3_z*t1160
        - D_p_y_2_by_b_3_z*t1080 - D_p_y_2_by_b_3_z*t1081 - D_p_y_2_by_b_3_z*t1082 + D_p_y_2_by_b_3_z*t1161
        - D_p_z_2_by_b_3_z*t1083 - D_p_z_2_by_b_3_z*t1084 - D_p_z_2_by_b_3_z*t1085 + D_p_z_2_by_b_3_z*t1162
        + mu_1_by_b_3_z*t941 + mu_2_by_b_3_z*t942 + mu_3_by_b_3_z*t943
    )
    t1507 = D_p_x_2_by_b_3_z*k_C
    t1508 = D_p_y_2_by_b_3_z*k_C
    t1509 = D_p_z_2_by_b_3_z*k_C
    t1510 = 2*D_p_x_3_by_b_3_z
    t1511 = 2*D_p_y_3_by_b_3_z
    t1512 = 2*D_p_z_3_by_b_3_z
    t1513 = t1416*x_3_by_b_3_z
    t1514 = t1419*x_3_by_b_3_z
    t1515 = -R_p_3*t1514
    t1516 = R_p_3*t1513
    t1517 = (
        D_delta_x_1_by_b_3_z*t1107 + D_delta_y_1_by_b_3_z*t1108 + D_delta_z_1_by_b_3_z*t1109
        - D_p_x_3_by_b_3_z*t1054 - D_p_x_3_by_b_3_z*t1055 - D_p_x_3_by_b_3_z*t1056 + D_p_x_3_by_b_3_z*t1152
        - D_p_y_3_by_b_3_z*t1057 - D_p_y_3_by_b_3_z*t1058 - D_p_y_3_by_b_3_z*t1059 + D_p_y_3_by_b_3_z*t1153
        - D_p_z_3_by_b_3_z*t1060 - D_p_z_3_by_b_3_z*t1061 - D_p_z_3_by_b_3_z*t1062 + D_p_z_3_by_b_3_z*t1154
        + mu_1_by_b_3_z*t948 + mu_2_by_b_3_z*t949 + mu_3_by_b_3_z*t950
    )
    t1518 = (
        D_delta_x_2_by_b_3_z*t1107 + D_delta_y_2_by_b_3_z*t1108 + D_delta_z_2_by_b_3_z*t1109
        - D_p_x_3_by_b_3_z*t1067 - D_p_x_3_by_b_3_z*t1068 - D_p_x_3_by_b_3_z*t1069 + D_p_x_3_by_b_3_z*t1156
        - D_p_y_3_by_b_3_z*t1070 - D_p_y_3_by_b_3_z*t1071 - D_p_y_3_by_b_3_z*t1072 + D_p_y_3_by_b_3_z*t1157
        - D_p_z_3_by_b_3_z*t1073 - D_p_z_3_by_b_3_z*t1074 - D_p_z_3_by_b_3_z*t1075 + D_p_z_3_by_b_3_z*t1158
        + mu_1_by_b_3_z*t952 + mu_2_by_b_3_z*t953 + mu_3_by_b_3_z*t954
    )
    t1519 = (
        D_delta_x_3_by_b_3_z*t1107 + D_delta_y_3_by_b_3_z*t1108 + D_delta_z_3_by_b_3_z*t1109
        - D_p_x_3_by_b_3_z*t1077 - D_p_x_3_by_b_3_z*t1078 - D_p_x_3_by_b_3_z*t1079 + D_p_x_3_by_b_3_z*t1160
        - D_p_y_3_by_b_3_z*t1080 - D_p_y_3_by_b_3_z*t1081 - D_p_y_3_by_b_3_z*t1082 + D_p_y_3_by_b_3_z*t1161
        - D_p_z_3_by_b_3_z*t1083 - D_p_z_3_by_b_3_z*t1084 - D_p_z_3_by_b_3_z*t1085 + D_p_z_3_by_b_3_z*t1162
        + mu_1_by_b_3_z*t958 + mu_2_by_b_3_z*t956 + mu_3_by_b_3_z*t957
    )
    t1520 = -t1513 + t1514
    t1521 = D_p_x_3_by_b_3_z*k_C
    t1522 = D_p_y_3_by_b_3_z*k_C
    t1523 = D_p_z_3_by_b_3_z*k_C
    t1524 = (
        D_delta_x_1_by_b_3_z*t1116 + D_delta_x_2_by_b_3_z*t1117 + D_delta_y_1_by_b_3_z*t1118
        + D_delta_y_2_by_b_3_z*t1119 + D_delta_z_1_by_b_3_z*t1120 + D_delta_z_2_by_b_3_z*t1121
        - mu_1_by_b_3_z*t242 - mu_2_by_b_3_z*t242 - mu_3_by_b_3_z*t242
    )
    t1525 = (
        D_delta_x_1_by_b_3_z*t1123 + D_delta_x_3_by_b_3_z*t1117 + D_delta_y_1_by_b_3_z*t1124
        + D_delta_y_3_by_b_3_z*t1119 + D_delta_z_1_by_b_3_z*t1125 + D_delta_z_3_by_b_3_z*t1121
        - mu_1_by_b_3_z*t246 - mu_2_by_b_3_z*t246 - mu_3_by_b_3_z*t246
    )
    t1526 = D_delta_x_1_by_b_3_z*k_C
    t1527 = D_delta_y_1_by_b_3_z*k_C
    t1528 = D_delta_z_1_by_b_3_z*k_C
    t1529 = (
        D_delta_x_2_by_b_3_z*t1123 + D_delta_x_3_by_b_3_z*t1116 + D_delta_y_2_by_b_3_z*t1124
        + D_delta_y_3_by_b_3_z*t1118 + D_delta_z_2_by_b_3_z*t1125 + D_delta_z_3_by_b_3_z*t1120
        - mu_1_by_b_3_z*t254 - mu_2_by_b_3_z*t254 - mu_3_by_b_3_z*t254
    )
    t1530 = D_delta_x_2_by_b_3_z*k_C
    t1531 = D_delta_y_2_by_b_3_z*k_C
    t1532 = D_delta_z_2_by_b_3_z*k_C
    t1533 = D_delta_x_3_by_b_3_z*k_C
    t1534 = D_delta_y_3_by_b_3_z*k_C
    t1535 = D_delta_z_3_by_b_3_z*k_C
    t1536 = 2*D_p_x_1_by_l_d_1
    t1537 = 2*D_p_y_1_by_l_d_1
    t1538 = 2*D_p_z_1_by_l_d_1
    t1539 = t1024*x_1_by_l_d_1
    t1540 = (
        D_p_x_1*D_p_x_2_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_2*k_C - D_p_x_1_by_l_d_1*t1027
        - D_p_x_1_by_l_d_1*t1028 - D_p_x_1_by_l_d_1*t1029 - D_p_x_2_by_l_d_1*t1011 - D_p_x_2_by_l_d_1*t1013
        - D_p_x_2_by_l_d_1*t1014 + D_p_y_1*D_p_y_2_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_2*k_C
        - D_p_y_1_by_l_d_1*t1030 - D_p_y_1_by_l_d_1*t1031 - D_p_y_1_by_l_d_1*t1032 - D_p_y_2_by_l_d_1*t1015
        - D_p_y_2_by_l_d_1*t1017 - D_p_y_2_by_l_d_1*t1018 + D_p_z_1*D_p_z_2_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_2*k_C - D_p_z_1_by_l_d_1*t1033 - D_p_z_1_by_l_d_1*t1034
        - D_p_z_1_by_l_d_1*t1035 - D_p_z_2_by_l_d_1*t1019 - D_p_z_2_by_l_d_1*t1021 - D_p_z_2_by_l_d_1*t1022
        + mu_1_by_l_d_1*t906 + mu_2_by_l_d_1*t907 + mu_3_by_l_d_1*t908
    )
    t1541 = (
        D_p_x_1*D_p_x_3_by_l_d_1*k_C + D_p_x_1_by_l_d_1*D_p_x_3*k_C - D_p_x_1_by_l_d_1*t1037
        - D_p_x_1_by_l_d_1*t1038 - D_p_x_1_by_l_d_1*t1039 - D_p_x_3_by_l_d_1*t1011 - D_p_x_3_by_l_d_1*t1013
        - D_p_x_3_by_l_d_1*t1014 + D_p_y_1*D_p_y_3_by_l_d_1*k_C + D_p_y_1_by_l_d_1*D_p_y_3*k_C
        - D_p_y_1_by_l_d_1*t1040 - D_p_y_1_by_l_d_1*t1041 - D_p_y_1_by_l_d_1*t1042 - D_p_y_3_by_l_d_1*t1015
        - D_p_y_3_by_l_d_1*t1017 - D_p_y_3_by_l_d_1*t1018 + D_p_z_1*D_p_z_3_by_l_d_1*k_C
        + D_p_z_1_by_l_d_1*D_p_z_3*k_C - D_p_z_1_by_l_d_1*t1043 - D_p_z_1_by_l_d_1*t1044
        - D_p_z_1_by_l_d_1*t1045 - D_p_z_3_by_l_d_1*t1019 - D_p_z_3_by_l_d_1*t1021 - D_p_z_3_by_l_d_1*t1022
        + mu_1_by_l_d_1*t910 + mu_2_by_l_d_1*t911 + mu_3_by_l_d_1*t912
    )
    t1542 = t1047*x_1_by_l_d_1
    t1543 = -R_p_1*t1542
    t1544 = R_p_1*t1539
    t1545 = (
        D_delta_x_1_by_l_d_1*t1063 + D_delta_y_1_by_l_d_1*t1064 + D_delta_z_1_by_l_d_1*t1065
        - D_p_x_1_by_l_d_1*t1054 - D_p_x_1_by_l_d_1*t1055 - D_p_x_1_by_l_d_1*t1056 + D_p_x_1_by_l_d_1*t1152
        - D_p_y_1_by_l_d_1*t1057 - D_p_y_1_by_l_d_1*t1058 - D_p_y_1_by_l_d_1*t1059 + D_p_y_1_by_l_d_1*t1153
        - D_p_z_1_by_l_d_1*t1060 - D_p_z_1_by_l_d_1*t1061 - D_p_z_1_by_l_d_1*t1062 + D_p_z_1_by_l_d_1*t1154
        + mu_1_by_l_d_1*t914 + mu_2_by_l_d_1*t915 + mu_3_by_l_d_1*t916
    )
    t1546 = (
        D_delta_x_2_by_l_d_1*t1063 + D_delta_y_2_by_l_d_1*t1064 + D_delta_z_2_by_l_d_1*t1065
        - D_p_x_1_by_l_d_1*t1067 - D_p_x_1_by_l_d_1*t1068 - D_p_x_1_by_l_d_1*t1069 + D_p_x_1_by_l_d_1*t1156
        - D_p_y_1_by_l_d_1*t1070 - D_p_y_1_by_l_d_1*t1071 - D_p_y_1_by_l_d_1*t1072 + D_p_y_1_by_l_d_1*t1157
        - D_p_z_1_by_l_d_1*t1073 - D_p_z_1_by_l_d_1*t1074 - D_p_z_1_by_l_d_1*t1075 + D_p_z_1_by_l_d_1*t1158
        + mu_1_by_l_d_1*t918 + mu_2_by_l_d_1*t919 + mu_3_by_l_d_1*t920
    )
    t1547 = (
        D_delta_x_3_by_l_d_1*t1063 + D_delta_y_3_by_l_d_1*t1064 + D_delta_z_3_by_l_d_1*t1065
        - D_p_x_1_by_l_d_1*t1077 - D_p_x_1_by_l_d_1*t1078 - D_p_x_1_by_l_d_1*t1079 + D_p_x_1_by_l_d_1*t1160
        - D_p_y_1_by_l_d_1*t1080 - D_p_y_1_by_l_d_1*t1081 - D_p_y_1_by_l_d_1*t1082 + D_p_y_1_by_l_d_1*t1161
        - D_p_z_1_by_l_d_1*t1083 - D_p_z_1_by_l_d_1*t1084 - D_p_z_1_by_l_d_1*t1085 + D_p_z_1_by_l_d_1*t1162
        + mu_1_by_l_d_1*t922 + mu_2_by_l_d_1*t923 + mu_3_by_l_d_1*t924
    )
    t1548 = -t1539 + t1542
    t1549 = D_p_x_1_by_l_d_1*k_C
    t1550 = D_p_y_1_by_l_d_1*k_C
    t1551 = D_p_z_1_by_l_d_1*k_C
    t1552 = 2*D_p_x_2_by_l_d_1
    t1553 = 2*D_p_y_2_by_l_d_1
    t1554 = 2*D_p_z_2_by_l_d_1
    t1555 = (
        D_p_x_2*D_p_x_3_by_l_d_1*k_C + D_p_x_2_by_l_d_1*D_p_x_3*k_C - D_p_x_2_by_l_d_1*t1037
        - D_p_x_2_by_l_d_1*t1038 - D_p_x_2_by_l_d_1*t1039 - D_p_x_3_by_l_d_1*t1027 - D_p_x_3_by_l_d_1*t1028
        - D_p_x_3_by_l_d_1*t1029 + D_p_y_2*D_p_y_3_by_l_d_1*k_C + D_p_y_2_by_l_d_1*D_p_y_3*k_C
        - D_p_y_2_by_l_d_1*t1040 - D_p_y_2_by_l_d_1*t1041 - D_p_y_2_by_l_d_1*t1042 - D_p_y_3_by_l_d_1*t1030
        - D_p_y_3_by_l_d_1*t1031 - D_p_y_3_by_l_d_1*t1032 + D_p_z_2*D_p_z_3_by_l_d_1*k_C
        + D_p_z_2_by_l_d_1*D_p_z_3*k_C - D_p_z_2_by_l_d_1*t1043 - D_p_z_2_by_l_d_1*t1044
        - D_p_z_2_by_l_d_1*t1045 - D_p_z_3_by_l_d_1*t1033 - D_p_z_3_by_l_d_1*t1034 - D_p_z_3_by_l_d_1*t1035
        + mu_1_by_l_d_1*t929 + mu_2_by_l_d_1*t930 + mu_3_by_l_d_1*t931
    )
    t1556 = (
        D_delta_x_1_by_l_d_1*t1095 + D_delta_y_1_by_l_d_1*t1096 + D_delta_z_1_by_l_d_1*t1097
        - D_p_x_2_by_l_d_1*t1054 - D_p_x_2_by_l_d_1*t1055 - D_p_x_2_by_l_d_1*t1056 + D_p_x_2_by_l_d_1*t1152
        - D_p_y_2_by_l_d_1*t1057 - D_p_y_2_by_l_d_1*t1058 - D_p_y_2_by_l_d_1*t1059 + D_p_y_2_by_l_d_1*t1153
        - D_p_z_2_by_l_d_1*t1060 - D_p_z_2_by_l_d_1*t1061 - D_p_z_2_by_l_d_1*t1062 + D_p_z_2_by_l_d_1*t1154
        + mu_1_by_l_d_1*t933 + mu_2_by_l_d_1*t934 + mu_3_by_l_d_1*t935
    )
    t1557 = (
        D_delta_x_2_by_l_d_1*t1095 + D_delta_y_2_by_l_d_1*t1096 + D_delta_z_2_by_l_d_1*t1097
        - D_p_x_2_by_l_d_1*t1067 - D_p_x_2_by_l_d_1*t1068 - D_p_x_2_by_l_d_1*t1069 + D_p_x_2_by_l_d_1*t1156
        - D_p_y_2_by_l_d_1*t1070 - D_p_y_2_by_l_d_1*t1071 - D_p_y_2_by_l_d_1*t1072 + D_p_y_2_by_l_d_1*t1157
        - D_p_z_2_by_l_d_1*t1073 - D_p_z_2_by_l_d_1*t1074 - D_p_z_2_by_l_d_1*t1075 + D_p_z_2_by_l_d_1*t1158
        + mu_1_by_l_d_1*t937 + mu_2_by_l_d_1*t938 + mu_3_by_l_d_1*t939
    )
    t1558 = (
        D_delta_x_3_by_l_d_1*t1095 + D_delta_y_3_by_l_d_1*t1096 + D_delta_z_3_by_l_d_1*t1097
        - D_p_x_2_by_l_d_1*t1077 - D_p_x_2_by_l_d_1*t1078 - D_p_x_2_by_l_d_1*t1079 + D_p_x_2_by_l_d_1*t1160
        - D_p_y_2_by_l_d_1*t1080 - D_p_y_2_by_l_d_1*t1081 - D_p_y_2_by_l_d_1*t1082 + D_p_y_2_by_l_d_1*t1161
        - D_p_z_2_by_l_d_1*t1083 - D_p_z_2_by_l_d_1*t1084 - D_p_z_2_by_l_d_1*t1085 + D_p_z_2_by_l_d_1*t1162
        + mu_1_by_l_d_1*t941 + mu_2_by_l_d_1*t942 + mu_3_by_l_d_1*t943
    )
    t1559 = D_p_x_2_by_l_d_1*k_C
    t1560 = D_p_y_2_by_l_d_1*k_C
    t1561 = D_p_z_2_by_l_d_1*k_C
    t1562 = 2*D_p_x_3_by_l_d_1
    t1563 = 2*D_p_y_3_by_l_d_1
    t1564 = 2*D_p_z_3_by_l_d_1
    t1565 = (
        D_delta_x_1_by_l_d_1*t1107 + D_delta_y_1_by_l_d_1*t1108 + D_delta_z_1_by_l_d_1*t1109
        - D_p_x_3_by_l_d_1*t1054 - D_p_x_3_by_l_d_1*t1055 - D_p_x_3_by_l_d_1*t1056 + D_p_x_3_by_l_d_1*t1152
        - D_p_y_3_by_l_d_1*t1057 - D_p_y_3_by_l_d_1*t1058 - D_p_y_3_by_l_d_1*t1059 + D_p_y_3_by_l_d_1*t1153
        - D_p_z_3_by_l_d_1*t1060 - D_p_z_3_by_l_d_1*t1061 - D_p_z_3_by_l_d_1*t1062 + D_p_z_3_by_l_d_1*t1154
        + mu_1_by_l_d_1*t948 + mu_2_by_l_d_1*t949 + mu_3_by_l_d_1*t950
    )
    t1566 = (
        D_delta_x_2_by_l_d_1*t1107 + D_delta_y_2_by_l_d_1*t1108 + D_delta_z_2_by_l_d_1*t1109
        - D_p_x_3_by_l_d_1*t1067 - D_p_x_3_by_l_d_1*t1068 - D_p_x_3_by_l_d_1*t1069 + D_p_x_3_by_l_d_1*t1156
        - D_p_y_3_by_l_d_1*t1070 - D_p_y_3_by_l_d_1*t1071 - D_p_y_3_by_l_d_1*t1072 + D_p_y_3_by_l_d_1*t1157
        - D_p_z_3_by_l_d_1*t1073 - D_p_z_3_by_l_d_1*t1074 - D_p_z_3_by_l_d_1*t1075 + D_p_z_3_by_l_d_1*t1158
        + mu_1_by_l_d_1*t952 + mu_2_by_l_d_1*t953 + mu_3_by_l_d_1*t954
    )
    t1567 = (
        D_delta_x_3_by_l_d_1*t1107 + D_delta_y_3_by_l_d_1*t1108 + D_delta_z_3_by_l_d_1*t1109
        - D_p_x_3_by_l_d_1*t1077 - D_p_x_3_by_l_d_1*t1078 - D_p_x_3_by_l_d_1*t1079 + D_p_x_3_by_l_d_1*t1160
        - D_p_y_3_by_l_d_1*t1080 - D_p_y_3_by_l_d_1*t1081 - D_p_y_3_by_l_d_1*t1082 + D_p_y_3_by_l_d_1*t1161
        - D_p_z_3_by_l_d_1*t1083 - D_p_z_3_by_l_d_1*t1084 - D_p_z_3_by_l_d_1*t1085 + D_p_z_3_by_l_d_1*t1162
        + mu_1_by_l_d_1*t958 + mu_2_by_l_d_1*t956 + mu_3_by_l_d_1*t957
    )
    t1568 = D_p_x_3_by_l_d_1*k_C
    t1569 = D_p_y_3_by_l_d_1*k_C
    t1570 = D_p_z_3_by_l_d_1*k_C
    t1571 = (
        D_delta_x_1_by_l_d_1*t1116 + D_delta_x_2_by_l_d_1*t1117 + D_delta_y_1_by_l_d_1*t1118
        + D_delta_y_2_by_l_d_1*t1119 + D_delta_z_1_by_l_d_1*t1120 + D_delta_z_2_by_l_d_1*t1121
        - mu_1_by_l_d_1*t242 - mu_2_by_l_d_1*t242 - mu_3_by_l_d_1*t242
    )
    t1572 = (
        D_delta_x_1_by_l_d_1*t1123 + D_delta_x_3_by_l_d_1*t1117 + D_delta_y_1_by_l_d_1*t1124
        + D_delta_y_3_by_l_d_1*t1119 + D_delta_z_1_by_l_d_1*t1125 + D_delta_z_3_by_l_d_1*t1121
        - mu_1_by_l_d_1*t246 - mu_2_by_l_d_1*t246 - mu_3_by_l_d_1*t246
    )
    t1573 = D_delta_x_1_by_l_d_1*k_C
    t1574 = D_delta_y_1_by_l_d_1*k_C
    t1575 = D_delta_z_1_by_l_d_1*k_C
    t1576 = (
        D_delta_x_2_by_l_d_1*t1123 + D_delta_x_3_by_l_d_1*t1116 + D_delta_y_2_by_l_d_1*t1124
        + D_delta_y_3_by_l_d_1*t1118 + D_delta_z_2_by_l_d_1*t1125 + D_delta_z_3_by_l_d_1*t1120
        - mu_1_by_l_d_1*t254 - mu_2_by_l_d_1*t254 - mu_3_by_l_d_1*t254
    )
    t1577 = D_delta_x_2_by_l_d_1*k_C
    t1578 = D_delta_y_2_by_l_d_1*k_C
    t1579 = D_delta_z_2_by_l_d_1*k_C
    t1580 = D_delta_x_3_by_l_d_1*k_C
    t1581 = D_delta_y_3_by_l_d_1*k_C
    t1582 = D_delta_z_3_by_l_d_1*k_C
    t1583 = 2*D_p_x_1_by_l_d_2
    t1584 = 2*D_p_y_1_by_l_d_2
    t1585 = 2*D_p_z_1_by_l_d_2
    t1586 = (
        D_p_x_1*D_p_x_2_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_2*k_C - D_p_x_1_by_l_d_2*t1027
        - D_p_x_1_by_l_d_2*t1028 - D_p_x_1_by_l_d_2*t1029 - D_p_x_2_by_l_d_2*t1011 - D_p_x_2_by_l_d_2*t1013
        - D_p_x_2_by_l_d_2*t1014 + D_p_y_1*D_p_y_2_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_2*k_C
        - D_p_y_1_by_l_d_2*t1030 - D_p_y_1_by_l_d_2*t1031 - D_p_y_1_by_l_d_2*t1032 - D_p_y_2_by_l_d_2*t1015
        - D_p_y_2_by_l_d_2*t1017 - D_p_y_2_by_l_d_2*t1018 + D_p_z_1*D_p_z_2_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_2*k_C - D_p_z_1_by_l_d_2*t1033 - D_p_z_1_by_l_d_2*t1034
        - D_p_z_1_by_l_d_2*t1035 - D_p_z_2_by_l_d_2*t1019 - D_p_z_2_by_l_d_2*t1021 - D_p_z_2_by_l_d_2*t1022
        + mu_1_by_l_d_2*t906 + mu_2_by_l_d_2*t907 + mu_3_by_l_d_2*t908
    )
    t1587 = (
        D_p_x_1*D_p_x_3_by_l_d_2*k_C + D_p_x_1_by_l_d_2*D_p_x_3*k_C - D_p_x_1_by_l_d_2*t1037
        - D_p_x_1_by_l_d_2*t1038 - D_p_x_1_by_l_d_2*t1039 - D_p_x_3_by_l_d_2*t1011 - D_p_x_3_by_l_d_2*t1013
        - D_p_x_3_by_l_d_2*t1014 + D_p_y_1*D_p_y_3_by_l_d_2*k_C + D_p_y_1_by_l_d_2*D_p_y_3*k_C
        - D_p_y_1_by_l_d_2*t1040 - D_p_y_1_by_l_d_2*t1041 - D_p_y_1_by_l_d_2*t1042 - D_p_y_3_by_l_d_2*t1015
        - D_p_y_3_by_l_d_2*t1017 - D_p_y_3_by_l_d_2*t1018 + D_p_z_1*D_p_z_3_by_l_d_2*k_C
        + D_p_z_1_by_l_d_2*D_p_z_3*k_C - D_p_z_1_by_l_d_2*t1043 - D_p_z_1_by_l_d_2*t1044
        - D_p_z_1_by_l_d_2*t1045 - D_p_z_3_by_l_d_2*t1019 - D_p_z_3_by_l_d_2*t1021 - D_p_z_3_by_l_d_2*t1022
        + mu_1_by_l_d_2*t910 + mu_2_by_l_d_2*t911 + mu_3_by_l_d_2*t912
    )
    t1588 = (
        D_delta_x_1_by_l_d_2*t1063 + D_delta_y_1_by_l_d_2*t1064 + D_delta_z_1_by_l_d_2*t1065
        - D_p_x_1_by_l_d_2*t1054 - D_p_x_1_by_l_d_2*t1055 - D_p_x_1_by_l_d_2*t1056 + D_p_x_1_by_l_d_2*t1152
        - D_p_y_1_by_l_d_2*t1057 - D_p_y_1_by_l_d_2*t1058 - D_p_y_1_by_l_d_2*t1059 + D_p_y_1_by_l_d_2*t1153
        - D_p_z_1_by_l_d_2*t1060 - D_p_z_1_by_l_d_2*t1061 - D_p_z_1_by_l_d_2*t1062 + D_p_z_1_by_l_d_2*t1154
        + mu_1_by_l_d_2*t914 + mu_2_by_l_d_2*t915 + mu_3_by_l_d_2*t916
    )
    t1589 = (
        D_delta_x_2_by_l_d_2*t1063 + D_delta_y_2_by_l_d_2*t1064 + D_delta_z_2_by_l_d_2*t1065
        - D_p_x_1_by_l_d_2*t1067 - D_p_x_1_by_l_d_2*t1068 - D_p_x_1_by_l_d_2*t1069 + D_p_x_1_by_l_d_2*t1156
        - D_p_y_1_by_l_d_2*t1070 - D_p_y_1_by_l_d_2*t1071 - D_p_y_1_by_l_d_2*t1072 + D_p_y_1_by_l_d_2*t1157
        - D_p_z_1_by_l_d_2*t1073 - D_p_z_1_by_l_d_2*t1074 - D_p_z_1_by_l_d_2*t1075 + D_p_z_1_by_l_d_2*t1158
        + mu_1_by_l_d_2*t918 + mu_2_by_l_d_2*t919 + mu_3_by_l_d_2*t920
    )
    t1590 = (
        D_delta_x_3_by_l_d_2*t1063 + D_delta_y_3_by_l_d_2*t1064 + D_delta_z_3_by_l_d_2*t1065
        - D_p_x_1_by_l_d_2*t1077 - D_p_x_1_by_l_d_2*t1078 - D_p_x_1_by_l_d_2*t1079 + D_p_x_1_by_l_d_2*t1160
        - D_p_y_1_by_l_d_2*t1080 - D_p_y_1_by_l_d_2*t1081 - D_p_y_1_by_l_d_2*t1082 + D_p_y_1_by_l_d_2*t1161
        - D_p_z_1_by_l_d_2*t1083 - D_p_z_1_by_l_d_2*t1084 - D_p_z_1_by_l_d_2*t1085 + D_p_z_1_by_l_d_2*t1162
        + mu_1_by_l_d_2*t922 + mu_2_by_l_d_2*t923 + mu_3_by_l_d_2*t924
    )
    t1591 = D_p_x_1_by_l_d_2*k_C
    t1592 = D_p_y_1_by_l_d_2*k_C
    t1593 = D_p_z_1_by_l_d_2*k_C
    t1594 = 2*D_p_x_2_by_l_d_2
    t1595 = 2*D_p_y_2_by_l_d_2
    t1596 = 2*D_p_z_2_by_l_d_2
    t1597 = t1261*x_2_by_l_d_2
    t1598 = (
        D_p_x_2*D_p_x_3_by_l_d_2*k_C + D_p_x_2_by_l_d_2*D_p_x_3*k_C - D_p_x_2_by_l_d_2*t1037
        - D_p_x_2_by_l_d_2*t1038 - D_p_x_2_by_l_d_2*t1039 - D_p_x_3_by_l_d_2*t1027 - D_p_x_3_by_l_d_2*t1028
        - D_p_x_3_by_l_d_2*t1029 + D_p_y_2*D_p_y_3_by_l_d_2*k_C + D_p_y_2_by_l_d_2*D_p_y_3*k_C
        - D_p_y_2_by_l_d_2*t1040 - D_p_y_2_by_l_d_2*t1041 - D_p_y_2_by_l_d_2*t1042 - D_p_y_3_by_l_d_2*t1030
        - D_p_y_3_by_l_d_2*t1031 - D_p_y_3_by_l_d_2*t1032 + D_p_z_2*D_p_z_3_by_l_d_2*k_C
        + D_p_z_2_by_l_d_2*D_p_z_3*k_C - D_p_z_2_by_l_d_2*t1043 - D_p_z_2_by_l_d_2*t1044
        - D_p_z_2_by_l_d_2*t1045 - D_p_z_3_by_l_d_2*t1033 - D_p_z_3_by_l_d_2*t1034 - D_p_z_3_by_l_d_2*t1035
        + mu_1_by_l_d_2*t929 + mu_2_by_l_d_2*t930 + mu_3_by_l_d_2*t931
    )
    t1599 = t1265*x_2_by_l_d_2
    t1600 = -R_p_2*t1599
    t1601 = R_p_2*t1597
    t1602 = (
        D_delta_x_1_by_l_d_2*t1095 + D_delta_y_1_by_l_d_2*t1096 + D_delta_z_1_by_l_d_2*t1097
        - D_p_x_2_by_l_d_2*t1054 - D_p_x_2_by_l_d_2*t1055 - D_p_x_2_by_l_d_2*t1056 + D_p_x_2_by_l_d_2*t1152
        - D_p_y_2_by_l_d_2*t1057 - D_p_y_2_by_l_d_2*t1058 - D_p_y_2_by_l_d_2*t1059 + D_p_y_2_by_l_d_2*t1153
        - D_p_z_2_by_l_d_2*t1060 - D_p_z_2_by_l_d_2*t1061 - D_p_z_2_by_l_d_2*t1062 + D_p_z_2_by_l_d_2*t1154
        + mu_1_by_l_d_2*t933 + mu_2_by_l_d_2*t934 + mu_3_by_l_d_2*t935
    )
    t1603 = (
        D_delta_x_2_by_l_d_2*t1095 + D_delta_y_2_by_l_d_2*t1096 + D_delta_z_2_by_l_d_2*t1097
        - D_p_x_2_by_l_d_2*t1067 - D_p_x_2_by_l_d_2*t1068 - D_p_x_2_by_l_d_2*t1069 + D_p_x_2_by_l_d_2*t1156
        - D_p_y_2_by_l_d_2*t1070 - D_p_y_2_by_l_d_2*t1071 - D_p_y_2_by_l_d_2*t1072 + D_p_y_2_by_l_d_2*t1157
        - D_p_z_2_by_l_d_2*t1073 - D_p_z_2_by_l_d_2*t1074 - D_p_z_2_by_l_d_2*t1075 + D_p_z_2_by_l_d_2*t1158
        + mu_1_by_l_d_2*t937 + mu_2_by_l_d_2*t938 + mu_3_by_l_d_2*t939
    )
    t1604 = (
        D_delta_x_3_by_l_d_2*t1095 + D_delta_y_3_by_l_d_2*t1096 + D_delta_z_3_by_l_d_2*t1097
        - D_p_x_2_by_l_d_2*t1077 - D_p_x_2_by_l_d_2*t1078 - D_p_x_2_by_l_d_2*t1079 + D_p_x_2_by_l_d_2*t1160
        - D_p_y_2_by_l_d_2*t1080 - D_p_y_2_by_l_d_2*t1081 - D_p_y_2_by_l_d_2*t1082 + D_p_y_2_by_l_d_2*t1161
        - D_p_z_2_by_l_d_2*t1083 - D_p_z_2_by_l_d_2*t1084 - D_p_z_2_by_l_d_2*t1085 + D_p_z_2_by_l_d_2*t1162
        + mu_1_by_l_d_2*t941 + mu_2_by_l_d_2*t942 + mu_3_by_l_d_2*t943
    )
    t1605 = -t1597 + t1599
    t1606 = D_p_x_2_by_l_d_2*k_C
    t1607 = D_p_y_2_by_l_d_2*k_C
    t1608 = D_p_z_2_by_l_d_2*k_C
    t1609 = 2*D_p_x_3_by_l_d_2
    t1610 = 2*D_p_y_3_by_l_d_2
    t1611 = 2*D_p_z_3_by_l_d_2
    t1612 = (
        D_delta_x_1_by_l_d_2*t1107 + D_delta_y_1_by_l_d_2*t1108 + D_delta_z_1_by_l_d_2*t1109
        - D_p_x_3_by_l_d_2*t1054 - D_p_x_3_by_l_d_2*t1055 - D_p_x_3_by_l_d_2*t1056 + D_p_x_3_by_l_d_2*t1152
        - D_p_y_3_by_l_d_2*t1057 - D_p_y_3_by_l_d_2*t1058 - D_p_y_3_by_l_d_2*t1059 + D_p_y_3_by_l_d_2*t1153
        - D_p_z_3_by_l_d_2*t1060 - D_p_z_3_by_l_d_2*t1061 - D_p_z_3_by_l_d_2*t1062 + D_p_z_3_by_l_d_2*t1154
        + mu_1_by_l_d_2*t948 + mu_2_by_l_d_2*t949 + mu_3_by_l_d_2*t950
    )
    t1613 = (
        D_delta_x_2_by_l_d_2*t1107 + D_delta_y_2_by_l_d_2*t1108 + D_delta_z_2_by_l_d_2*t1109
        - D_p_x_3_by_l_d_2*t1067 - D_p_x_3_by_l_d_2*t1068 - D_p_x_3_by_l_d_2*t1069 + D_p_x_3_by_l_d_2*t1156
        - D_p_y_3_by_l_d_2*t1070 - D_p_y_3_by_l_d_2*t1071 - D_p_y_3_by_l_d_2*t1072 + D_p_y_3_by_l_d_2*t1157
        - D_p_z_3_by_l_d_2*t1073 - D_p_z_3_by_l_d_2*t1074 - D_p_z_3_by_l_d_2*t1075 + D_p_z_3_by_l_d_2*t1158
        + mu_1_by_l_d_2*t952 + mu_2_by_l_d_2*t953 + mu_3_by_l_d_2*t954
    )
    t1614 = (
        D_delta_x_3_by_l_d_2*t1107 + D_delta_y_3_by_l_d_2*t1108 + D_delta_z_3_by_l_d_2*t1109
        - D_p_x_3_by_l_d_2*t1077 - D_p_x_3_by_l_d_2*t1078 - D_p_x_3_by_l_d_2*t1079 + D_p_x_3_by_l_d_2*t1160
        - D_p_y_3_by_l_d_2*t1080 - D_p_y_3_by_l_d_2*t1081 - D_p_y_3_by_l_d_2*t1082 + D_p_y_3_by_l_d_2*t1161
        - D_p_z_3_by_l_d_2*t1083 - D_p_z_3_by_l_d_2*t1084 - D_p_z_3_by_l_d_2*t1085 + D_p_z_3_by_l_d_2*t1162
        + mu_1_by_l_d_2*t958 + mu_2_by_l_d_2*t956 + mu_3_by_l_d_2*t957
    )
    t1615 = D_p_x_3_by_l_d_2*k_C
    t1616 = D_p_y_3_by_l_d_2*k_C
    t1617 = D_p_z_3_by_l_d_2*k_C
    t1618 = (
        D_delta_x_1_by_l_d_2*t1116 + D_delta_x_2_by_l_d_2*t1117 + D_delta_y_1_by_l_d_2*t1118
        + D_delta_y_2_by_l_d_2*t1119 + D_delta_z_1_by_l_d_2*t1120 + D_delta_z_2_by_l_d_2*t1121
        - mu_1_by_l_d_2*t242 - mu_2_by_l_d_2*t242 - mu_3_by_l_d_2*t242
    )
    t1619 = (
        D_delta_x_1_by_l_d_2*t1123 + D_delta_x_3_by_l_d_2*t1117 + D_delta_y_1_by_l_d_2*t1124
        + D_delta_y_3_by_l_d_2*t1119 + D_delta_z_1_by_l_d_2*t1125 + D_delta_z_3_by_l_d_2*t1121
        - mu_1_by_l_d_2*t246 - mu_2_by_l_d_2*t246 - mu_3_by_l_d_2*t246
    )
    t1620 = D_delta_x_1_by_l_d_2*k_C
    t1621 = D_delta_y_1_by_l_d_2*k_C
    t1622 = D_delta_z_1_by_l_d_2*k_C
    t1623 = (
        D_delta_x_2_by_l_d_2*t1123 + D_delta_x_3_by_l_d_2*t1116 + D_delta_y_2_by_l_d_2*t1124
        + D_delta_y_3_by_l_d_2*t1118 + D_delta_z_2_by_l_d_2*t1125 + D_delta_z_3_by_l_d_2*t1120
        - mu_1_by_l_d_2*t254 - mu_2_by_l_d_2*t254 - mu_3_by_l_d_2*t254
    )
    t1624 = D_delta_x_2_by_l_d_2*k_C
    t1625 = D_delta_y_2_by_l_d_2*k_C
    t1626 = D_delta_z_2_by_l_d_2*k_C
    t1627 = D_delta_x_3_by_l_d_2*k_C
    t1628 = D_delta_y_3_by_l_d_2*k_C
    t1629 = D_delta_z_3_by_l_d_2*k_C
    t1630 = 2*D_p_x_1_by_l_d_3
    t1631 = 2*D_p_y_1_by_l_d_3
    t1632 = 2*D_p_z_1_by_l_d_3
    t1633 = (
        D_p_x_1*D_p_x_2_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_2*k_C - D_p_x_1_by_l_d_3*t1027
        - D_p_x_1_by_l_d_3*t1028 - D_p_x_1_by_l_d_3*t1029 - D_p_x_2_by_l_d_3*t1011 - D_p_x_2_by_l_d_3*t1013
        - D_p_x_2_by_l_d_3*t1014 + D_p_y_1*D_p_y_2_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_2*k_C
        - D_p_y_1_by_l_d_3*t1030 - D_p_y_1_by_l_d_3*t1031 - D_p_y_1_by_l_d_3*t1032 - D_p_y_2_by_l_d_3*t1015
        - D_p_y_2_by_l_d_3*t1017 - D_p_y_2_by_l_d_3*t1018 + D_p_z_1*D_p_z_2_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_2*k_C - D_p_z_1_by_l_d_3*t1033 - D_p_z_1_by_l_d_3*t1034
        - D_p_z_1_by_l_d_3*t1035 - D_p_z_2_by_l_d_3*t1019 - D_p_z_2_by_l_d_3*t1021 - D_p_z_2_by_l_d_3*t1022
        + mu_1_by_l_d_3*t906 + mu_2_by_l_d_3*t907 + mu_3_by_l_d_3*t908
    )
    t1634 = (
        D_p_x_1*D_p_x_3_by_l_d_3*k_C + D_p_x_1_by_l_d_3*D_p_x_3*k_C - D_p_x_1_by_l_d_3*t1037
        - D_p_x_1_by_l_d_3*t1038 - D_p_x_1_by_l_d_3*t1039 - D_p_x_3_by_l_d_3*t1011 - D_p_x_3_by_l_d_3*t1013
        - D_p_x_3_by_l_d_3*t1014 + D_p_y_1*D_p_y_3_by_l_d_3*k_C + D_p_y_1_by_l_d_3*D_p_y_3*k_C
        - D_p_y_1_by_l_d_3*t1040 - D_p_y_1_by_l_d_3*t1041 - D_p_y_1_by_l_d_3*t1042 - D_p_y_3_by_l_d_3*t1015
        - D_p_y_3_by_l_d_3*t1017 - D_p_y_3_by_l_d_3*t1018 + D_p_z_1*D_p_z_3_by_l_d_3*k_C
        + D_p_z_1_by_l_d_3*D_p_z_3*k_C - D_p_z_1_by_l_d_3*t1043 - D_p_z_1_by_l_d_3*t1044
        - D_p_z_1_by_l_d_3*t1045 - D_p_z_3_by_l_d_3*t1019 - D_p_z_3_by_l_d_3*t1021 - D_p_z_3_by_l_d_3*t1022
        + mu_1_by_l_d_3*t910 + mu_2_by_l_d_3*t911 + mu_3_by_l_d_3*t912
    )
    t1635 = (
        D_delta_x_1_by_l_d_3*t1063 + D_delta_y_1_by_l_d_3*t1064 + D_delta_z_1_by_l_d_3*t1065
        - D_p_x_1_by_l_d_3*t1054 - D_p_x_1_by_l_d_3*t1055 - D_p_x_1_by_l_d_3*t1056 + D_p_x_1_by_l_d_3*t1152
        - D_p_y_1_by_l_d_3*t1057 - D_p_y_1_by_l_d_3*t1058 - D_p_y_1_by_l_d_3*t1059 + D_p_y_1_by_l_d_3*t1153
        - D_p_z_1_by_l_d_3*t1060 - D_p_z_1_by_l_d_3*t1061 - D_p_z_1_by_l_d_3*t1062 + D_p_z_1_by_l_d_3*t1154
        + mu_1_by_l_d_3*t914 + mu_2_by_l_d_3*t915 + mu_3_by_l_d_3*t916
    )
    t1636 = (
        D_delta_x_2_by_l_d_3*t1063 + D_delta_y_2_by_l_d_3*t1064 + D_delta_z_2_by_l_d_3*t1065
        - D_p_x_1_by_l_d_3*t1067 - D_p_x_1_by_l_d_3*t1068 - D_p_x_1_by_l_d_3*t1069 + D_p_x_1_by_l_d_3*t1156
        - D_p_y_1_by_l_d_3*t1070 - D_p_y_1_by_l_d_3*t1071 - D_p_y_1_by_l_d_3*t1072 + D_p_y_1_by_l_d_3*t1157
        - D_p_z_1_by_l_d_3*t1073 - D_p_z_1_by_l_d_3*t1074 - D_p_z_1_by_l_d_3*t1075 + D_p_z_1_by_l_d_3*t1158
        + mu_1_by_l_d_3*t918 + mu_2_by_l_d_3*t919 + mu_3_by_l_d_3*t920
    )
    t1637 = (
        D_delta_x_3_by_l_d_3*t1063 + D_delta_y_3_by_l_d_3*t1064 + D_delta_z_3_by_l_d_3*t1065
        - D_p_x_1_by_l_d_3*t1077 - D_p_x_1_by_l_d_3*t1078 - D_p_x_1_by_l_d_3*t1079 + D_p_x_1_by_l_d_3*t1160
        - D_p_y_1_by_l_d_3*t1080 - D_p_y_1_by_l_d_3*t1081 - D_p_y_1_by_l_d_3*t1082 + D_p_y_1_by_l_d_3*t1161
        - D_p_z_1_by_l_d_3*t1083 - D_p_z_1_by_l_d_3*t1084 - D_p_z_1_by_l_d_3*t1085 + D_p_z_1_by_l_d_3*t1162
        + mu_1_by_l_d_3*t922 + mu_2_by_l_d_3*t923 + mu_3_by_l_d_3*t924
    )
    t1638 = D_p_x_1_by_l_d_3*k_C
    t1639 = D_p_y_1_by_l_d_3*k_C
    t1640 = D_p_z_1_by_l_d_3*k_C
    t1641 = 2*D_p_x_2_by_l_d_3
    t1642 = 2*D_p_y_2_by_l_d_3
    t1643 = 2*D_p_z_2_by_l_d_3
    t1644 = (
        D_p_x_2*D_p_x_3_by_l_d_3*k_C + D_p_x_2_by_l_d_3*D_p_x_3*k_C - D_p_x_2_by_l_d_3*t1037
        - D_p_x_2_by_l_d_3*t1038 - D_p_x_2_by_l_d_3*t1039 - D_p_x_3_by_l_d_3*t1027 - D_p_x_3_by_l_d_3*t1028
        - D_p_x_3_by_l_d_3*t1029 + D_p_y_2*D_p_y_3_by_l_d_3*k_C + D_p_y_2_by_l_d_3*D_p_y_3*k_C
        - D_p_y_2_by_l_d_3*t1040 - D_p_y_2_by_l_d_3*t1041 - D_p_y_2_by_l_d_3*t1042 - D_p_y_3_by_l_d_3*t1030
        - D_p_y_3_by_l_d_3*t1031 - D_p_y_3_by_l_d_3*t1032 + D_p_z_2*D_p_z_3_by_l_d_3*k_C
        + D_p_z_2_by_l_d_3*D_p_z_3*k_C - D_p_z_2_by_l_d_3*t1043 - D_p_z_2_by_l_d_3*t1044
        - D_p_z_2_by_l_d_3*t1045 - D_p_z_3_by_l_d_3*t1033 - D_p_z_3_by_l_d_3*t1034 - D_p_z_3_by_l_d_3*t1035
        + mu_1_by_l_d_3*t929 + mu_2_by_l_d_3*t930 + mu_3_by_l_d_3*t931
    )
    t1645 = (
        D_delta_x_1_by_l_d_3*t1095 + D_delta_y_1_by_l_d_3*t1096 + D_delta_z_1_by_l_d_3*t1097
        - D_p_x_2_by_l_d_3*t1054 - D_p_x_2_by_l_d_3*t1055 - D_p_x_2_by_l_d_3*t1056 + D_p_x_2_by_l_d_3*t1152
        - D_p_y_2_by_l_d_3*t1057 - D_p_y_2_by_l_d_3*t1058 - D_p_y_2_by_l_d_3*t1059 + D_p_y_2_by_l_d_3*t1153
        - D_p_z_2_by_l_d_3*t1060 - D_p_z_2_by_l_d_3*t1061 - D_p_z_2_by_l_d_3*t1062 + D_p_z_2_by_l_d_3*t1154
        + mu_1_by_l_d_3*t933 + mu_2_by_l_d_3*t934 + mu_3_by_l_d_3*t935
    )
    t1646 = (
        D_delta_x_2_by_l_d_3*t1095 + D_delta_y_2_by_l_d_3*t1096 + D_delta_z_2_by_l_d_3*t1097
        - D_p_x_2_by_l_d_3*t1067 - D_p_x_2_by_l_d_3*t1068 - D_p_x_2_by_l_d_3*t1069 + D_p_x_2_by_l_d_3*t1156
        - D_p_y_2_by_l_d_3*t1070 - D_p_y_2_by_l_d_3*t1071 - D_p_y_2_by_l_d_3*t1072 + D_p_y_2_by_l_d_3*t1157
        - D_p_z_2_by_l_d_3*t1073 - D_p_z_2_by_l_d_3*t1074 - D_p_z_2_by_l_d_3*t1075 + D_p_z_2_by_l_d_3*t1158
        + mu_1_by_l_d_3*t937 + mu_2_by_l_d_3*t938 + mu_3_by_l_d_3*t939
    )
    t1647 = (
        D_delta_x_3_by_l_d_3*t1095 + D_delta_y_3_by_l_d_3*t1096 + D_delta_z_3_by_l_d_3*t1097
        - D_p_x_2_by_l_d_3*t1077 - D_p_x_2_by_l_d_3*t1078 - D_p_x_2_by_l_d_3*t1079 + D_p_x_2_by_l_d_3*t1160
        - D_p_y_2_by_l_d_3*t1080 - D_p_y_2_by_l_d_3*t1081 - D_p_y_2_by_l_d_3*t1082 + D_p_y_2_by_l_d_3*t1161
        - D_p_z_2_by_l_d_3*t1083 - D_p_z_2_by_l_d_3*t1084 - D_p_z_2_by_l_d_3*t1085 + D_p_z_2_by_l_d_3*t1162
        + mu_1_by_l_d_3*t941 + mu_2_by_l_d_3*t942 + mu_3_by_l_d_3*t943
    )
    t1648 = D_p_x_2_by_l_d_3*k_C
    t1649 = D_p_y_2_by_l_d_3*k_C
    t1650 = D_p_z_2_by_l_d_3*k_C
    t1651 = 2*D_p_x_3_by_l_d_3
    t1652 = 2*D_p_y_3_by_l_d_3
    t1653 = 2*D_p_z_3_by_l_d_3
    t1654 = t1416*x_3_by_l_d_3
    t1655 = t1419*x_3_by_l_d_3
    t1656 = -R_p_3*t1655
    t1657 = R_p_3*t1654
    t1658 = (
        D_delta_x_1_by_l_d_3*t1107 + D_delta_y_1_by_l_d_3*t1108 + D_delta_z_1_by_l_d_3*t1109
        - D_p_x_3_by_l_d_3*t1054 - D_p_x_3_by_l_d_3*t1055 - D_p_x_3_by_l_d_3*t1056 + D_p_x_3_by_l_d_3*t1152
        - D_p_y_3_by_l_d_3*t1057 - D_p_y_3_by_l_d_3*t1058 - D_p_y_3_by_l_d_3*t1059 + D_p_y_3_by_l_d_3*t1153
        - D_p_z_3_by_l_d_3*t1060 - D_p_z_3_by_l_d_3*t1061 - D_p_z_3_by_l_d_3*t1062 + D_p_z_3_by_l_d_3*t1154
        + mu_1_by_l_d_3*t948 + mu_2_by_l_d_3*t949 + mu_3_by_l_d_3*t950
    )
    t1659 = (
        D_delta_x_2_by_l_d_3*t1107 + D_delta_y_2_by_l_d_3*t1108 + D_delta_z_2_by_l_d_3*t1109
        - D_p_x_3_by_l_d_3*t1067 - D_p_x_3_by_l_d_3*t1068 - D_p_x_3_by_l_d_3*t1069 + D_p_x_3_by_l_d_3*t1156
        - D_p_y_3_by_l_d_3*t1070 - D_p_y_3_by_l_d_3*t1071 - D_p_y_3_by_l_d_3*t1072 + D_p_y_3_by_l_d_3*t1157
        - D_p_z_3_by_l_d_3*t1073 - D_p_z_3_by_l_d_3*t1074 - D_p_z_3_by_l_d_3*t1075 + D_p_z_3_by_l_d_3*t1158
        + mu_1_by_l_d_3*t952 + mu_2_by_l_d_3*t953 + mu_3_by_l_d_3*t954
    )
    t1660 = (
        D_delta_x_3_by_l_d_3*t1107 + D_delta_y_3_by_l_d_3*t1108 + D_delta_z_3_by_l_d_3*t1109
        - D_p_x_3_by_l_d_3*t1077 - D_p_x_3_by_l_d_3*t1078 - D_p_x_3_by_l_d_3*t1079 + D_p_x_3_by_l_d_3*t1160
        - D_p_y_3_by_l_d_3*t1080 - D_p_y_3_by_l_d_3*t1081 - D_p_y_3_by_l_d_3*t1082 + D_p_y_3_by_l_d_3*t1161
        - D_p_z_3_by_l_d_3*t1083 - D_p_z_3_by_l_d_3*t1084 - D_p_z_3_by_l_d_3*t1085 + D_p_z_3_by_l_d_3*t1162
        + mu_1_by_l_d_3*t958 + mu_2_by_l_d_3*t956 + mu_3_by_l_d_3*t957
    )
    t1661 = -t1654 + t1655
    t1662 = D_p_x_3_by_l_d_3*k_C
    t1663 = D_p_y_3_by_l_d_3*k_C
    t1664 = D_p_z_3_by_l_d_3*k_C
    t1665 = (
        D_delta_x_1_by_l_d_3*t1116 + D_delta_x_2_by_l_d_3*t1117 + D_delta_y_1_by_l_d_3*t1118
        + D_delta_y_2_by_l_d_3*t1119 + D_delta_z_1_by_l_d_3*t1120 + D_delta_z_2_by_l_d_3*t1121
        - mu_1_by_l_d_3*t242 - mu_2_by_l_d_3*t242 - mu_3_by_l_d_3*t242
    )
    t1666 = (
        D_delta_x_1_by_l_d_3*t1123 + D_delta_x_3_by_l_d_3*t1117 + D_delta_y_1_by_l_d_3*t1124
        + D_delta_y_3_by_l_d_3*t1119 + D_delta_z_1_by_l_d_3*t1125 + D_delta_z_3_by_l_d_3*t1121
        - mu_1_by_l_d_3*t246 - mu_2_by_l_d_3*t246 - mu_3_by_l_d_3*t246
    )
    t1667 = D_delta_x_1_by_l_d_3*k_C
    t1668 = D_delta_y_1_by_l_d_3*k_C
    t1669 = D_delta_z_1_by_l_d_3*k_C
    t1670 = (
        D_delta_x_2_by_l_d_3*t1123 + D_delta_x_3_by_l_d_3*t1116 + D_delta_y_2_by_l_d_3*t1124
        + D_delta_y_3_by_l_d_3*t1118 + D_delta_z_2_by_l_d_3*t1125 + D_delta_z_3_by_l_d_3*t1120
        - mu_1_by_l_d_3*t254 - mu_2_by_l_d_3*t254 - mu_3_by_l_d_3*t254
    )
    t1671 = D_delta_x_2_by_l_d_3*k_C
    t1672 = D_delta_y_2_by_l_d_3*k_C
    t1673 = D_delta_z_2_by_l_d_3*k_C
    t1674 = D_delta_x_3_by_l_d_3*k_C
    t1675 = D_delta_y_3_by_l_d_3*k_C
    t1676 = D_delta_z_3_by_l_d_3*k_C
    t1677 = mu_1_by_m_d_1*t906 + mu_2_by_m_d_1*t907 + mu_3_by_m_d_1*t908
    t1678 = mu_1_by_m_d_1*t910 + mu_2_by_m_d_1*t911 + mu_3_by_m_d_1*t912
    t1679 = mu_1_by_m_d_1*t914 + mu_2_by_m_d_1*t915 + mu_3_by_m_d_1*t916
    t1680 = mu_1_by_m_d_1*t918 + mu_2_by_m_d_1*t919 + mu_3_by_m_d_1*t920
    t1681 = mu_1_by_m_d_1*t922 + mu_2_by_m_d_1*t923 + mu_3_by_m_d_1*t924
    t1682 = mu_1_by_m_d_1*t929 + mu_2_by_m_d_1*t930 + mu_3_by_m_d_1*t931
    t1683 = mu_1_by_m_d_1*t933 + mu_2_by_m_d_1*t934 + mu_3_by_m_d_1*t935
    t1684 = mu_1_by_m_d_1*t937 + mu_2_by_m_d_1*t938 + mu_3_by_m_d_1*t939
    t1685 = mu_1_by_m_d_1*t941 + mu_2_by_m_d_1*t942 + mu_3_by_m_d_1*t943
    t1686 = mu_1_by_m_d_1*t948 + mu_2_by_m_d_1*t949 + mu_3_by_m_d_1*t950
    t1687 = mu_1_by_m_d_1*t952 + mu_2_by_m_d_1*t953 + mu_3_by_m_d_1*t954
    t1688 = mu_1_by_m_d_1*t958 + mu_2_by_m_d_1*t956 + mu_3_by_m_d_1*t957
    t1689 = -mu_1_by_m_d_1*t242 - mu_2_by_m_d_1*t242 - mu_3_by_m_d_1*t242
    t1690 = -mu_1_by_m_d_1*t246 - mu_2_by_m_d_1*t246 - mu_3_by_m_d_1*t246
    t1691 = -mu_1_by_m_d_1*t254 - mu_2_by_m_d_1*t254 - mu_3_by_m_d_1*t254
    t1692 = mu_1_by_m_d_2*t906 + mu_2_by_m_d_2*t907 + mu_3_by_m_d_2*t908
    t1693 = mu_1_by_m_d_2*t910 + mu_2_by_m_d_2*t911 + mu_3_by_m_d_2*t912
    t1694 = mu_1_by_m_d_2*t914 + mu_2_by_m_d_2*t915 + mu_3_by_m_d_2*t916
    t1695 = mu_1_by_m_d_2*t918 + mu_2_by_m_d_2*t919 + mu_3_by_m_d_2*t920
    t1696 = mu_1_by_m_d_2*t922 + mu_2_by_m_d_2*t923 + mu_3_by_m_d_2*t924
    t1697 = mu_1_by_m_d_2*t929 + mu_2_by_m_d_2*t930 + mu_3_by_m_d_2*t931
    t1698 = mu_1_by_m_d_2*t933 + mu_2_by_m_d_2*t934 + mu_3_by_m_d_2*t935
    t1699 = mu_1_by_m_d_2*t937 + mu_2_by_m_d_2*t938 + mu_3_by_m_d_2*t939
    t1700 = mu_1_by_m_d_2*t941 + mu_2_by_m_d_2*t942 + mu_3_by_m_d_2*t943
    t1701 = mu_1_by_m_d_2*t948 + mu_2_by_m_d_2*t949 + mu_3_by_m_d_2*t950
    t1702 = mu_1_by_m_d_2*t952 + mu_2_by_m_d_2*t953 + mu_3_by_m_d_2*t954
    t1703 = mu_1_by_m_d_2*t958 + mu_2_by_m_d_2*t956 + mu_3_by_m_d_2*t957
    t1704 = -mu_1_by_m_d_2*t242 - mu_2_by_m_d_2*t242 - mu_3_by_m_d_2*t242
    t1705 = -mu_1_by_m_d_2*t246 - mu_2_by_m_d_2*t246 - mu_3_by_m_d_2*t246
    t1706 = -mu_1_by_m_d_2*t254 - mu_2_by_m_d_2*t254 - mu_3_by_m_d_2*t254
    t1707 = mu_1_by_m_d_3*t906 + mu_2_by_m_d_3*t907 + mu_3_by_m_d_3*t908
    t1708 = mu_1_by_m_d_3*t910 + mu_2_by_m_d_3*t911 + mu_3_by_m_d_3*t912
    t1709 = mu_1_by_m_d_3*t914 + mu_2_by_m_d_3*t915 + mu_3_by_m_d_3*t916
    t1710 = mu_1_by_m_d_3*t918 + mu_2_by_m_d_3*t919 + mu_3_by_m_d_3*t920
    t1711 = mu_1_by_m_d_3*t922 + mu_2_by_m_d_3*t923 + mu_3_by_m_d_3*t924
    t1712 = mu_1_by_m_d_3*t929 + mu_2_by_m_d_3*t930 + mu_3_by_m_d_3*t931
    t1713 = mu_1_by_m_d_3*t933 + mu_2_by_m_d_3*t934 + mu_3_by_m_d_3*t935
    t1714 = mu_1_by_m_d_3*t937 + mu_2_by_m_d_3*t938 + mu_3_by_m_d_3*t939
    t1715 = mu_1_by_m_d_3*t941 + mu_2_by_m_d_3*t942 + mu_3_by_m_d_3*t943
    t1716 = mu_1_by_m_d_3*t948 + mu_2_by_m_d_3*t949 + mu_3_by_m_d_3*t950
    t1717 = mu_1_by_m_d_3*t952 + mu_2_by_m_d_3*t953 + mu_3_by_m_d_3*t954
    t1718 = mu_1_by_m_d_3*t958 + mu_2_by_m_d_3*t956 + mu_3_by_m_d_3*t957
    t1719 = -mu_1_by_m_d_3*t242 - mu_2_by_m_d_3*t242 - mu_3_by_m_d_3*t242
    t1720 = -mu_1_by_m_d_3*t246 - mu_2_by_m_d_3*t246 - mu_3_by_m_d_3*t246
    t1721 = -mu_1_by_m_d_3*t254 - mu_2_by_m_d_3*t254 - mu_3_by_m_d_3*t254
    t1722 = (1/2)*t1024
    t1723 = (1/2)*t1047
    t1724 = t1722 + t1723
    t1725 = -R_p_1*t1723
    t1726 = -R_p_1*t1722
    t1727 = (1/2)*t1261
    t1728 = (1/2)*t1265
    t1729 = t1727 + t1728
    t1730 = -R_p_2*t1728
    t1731 = -R_p_2*t1727
    t1732 = (1/2)*t1416
    t1733 = (1/2)*t1419
    t1734 = t1732 + t1733
    t1735 = -R_p_3*t1733
    t1736 = -R_p_3*t1732
    t1737 = w_b_1**2
    t1738 = t11**2
    t1739 = t1737*t1738
    t1740 = k_sp_1*t1739
    t1741 = c_E*t1740
    t1742 = t1026*t1741 - t11*t21*w_b_1
    t1743 = c_E*t1023
    t1744 = -t11*t19*w_b_1 + t1740*t1743
    t1745 = -t1742 - t1744
    t1746 = R_p_1*t1742
    t1747 = R_p_1*t1744
    t1748 = 1.0/(t15**2)
    t1749 = t332*(t11*t16*w_b_1 - t1741*t1748)
    t1750 = w_b_2**2
    t1751 = t22**2
    t1752 = t1750*t1751
    t1753 = k_sp_2*t1752
    t1754 = c_E*t1753
    t1755 = t1263*t1754 - t22*t32*w_b_2
    t1756 = c_E*t1260
    t1757 = t1753*t1756 - t22*t30*w_b_2
    t1758 = -t1755 - t1757
    t1759 = R_p_2*t1755
    t1760 = R_p_2*t1757
    t1761 = 1.0/(t26**2)
    t1762 = t462*(-t1754*t1761 + t22*t27*w_b_2)
    t1763 = w_b_3**2
    t1764 = t33**2
    t1765 = t1763*t1764
    t1766 = k_sp_3*t1765
    t1767 = c_E*t1766
    t1768 = t1418*t1767 - t33*t43*w_b_3
    t1769 = c_E*t1415
    t1770 = t1766*t1769 - t33*t41*w_b_3
    t1771 = -t1768 - t1770
    t1772 = R_p_3*t1768
    t1773 = R_p_3*t1770
    t1774 = 1.0/(t37**2)
    t1775 = t570*(-t1767*t1774 + t33*t38*w_b_3)
    t1776 = t1738*w_b_1
    t1777 = k_sp_1**2
    t1778 = c_E*t1777
    t1779 = t1776*t1778
    t1780 = -k_sp_1*t11*t21 + t1026*t1779
    t1781 = t1743*t1777
    t1782 = -k_sp_1*t11*t19 + t1776*t1781
    t1783 = -t1780 - t1782
    t1784 = R_p_1*t1780
    t1785 = R_p_1*t1782
    t1786 = t332*(k_sp_1*t11*t16 - t1748*t1779)
    t1787 = t1751*w_b_2
    t1788 = k_sp_2**2
    t1789 = c_E*t1788
    t1790 = t1787*t1789
    t1791 = -k_sp_2*t22*t32 + t1263*t1790
    t1792 = t1756*t1788
    t1793 = -k_sp_2*t22*t30 + t1787*t1792
    t1794 = -t1791 - t1793
    t1795 = R_p_2*t1791
    t1796 = R_p_2*t1793
    t1797 = t462*(k_sp_2*t22*t27 - t1761*t1790)
    t1798 = t1764*w_b_3
    t1799 = k_sp_3**2
    t1800 = c_E*t1799
    t1801 = t1798*t1800
    t1802 = -k_sp_3*t33*t43 + t1418*t1801
    t1803 = t1769*t1799
    t1804 = -k_sp_3*t33*t41 + t1798*t1803
    t1805 = -t1802 - t1804
    t1806 = R_p_3*t1802
    t1807 = R_p_3*t1804
    t1808 = t570*(k_sp_3*t33*t38 - t1774*t1801)
    t1809 = 2*R_p_1
    t1810 = k_1_1*t1809
    t1811 = 2*R_p_2
    t1812 = k_2_1*t1811
    t1813 = 2*R_p_3
    t1814 = k_3_1*t1813
    t1815 = -R_p_1*t1024
    t1816 = t1748*t332
    t1817 = t13*t1816
    t1818 = -R_p_2*t1261
    t1819 = t1761*t462
    t1820 = t1819*t24
    t1821 = -R_p_3*t1416
    t1822 = t1774*t570
    t1823 = t1822*t35
    t1824 = R_p_1*t1047
    t1825 = R_p_2*t1265
    t1826 = R_p_3*t1419
    t1827 = t11*t1737
    t1828 = t1778*t1827
    t1829 = -k_sp_1*t21*w_b_1 + t1026*t1828
    t1830 = -k_sp_1*t19*w_b_1 + t1781*t1827
    t1831 = -t1829 - t1830
    t1832 = R_p_1*t1829
    t1833 = R_p_1*t1830
    t1834 = t332*(k_sp_1*t16*w_b_1 - t1748*t1828)
    t1835 = t1750*t22
    t1836 = t1789*t1835
    t1837 = -k_sp_2*t32*w_b_2 + t1263*t1836
    t1838 = -k_sp_2*t30*w_b_2 + t1792*t1835
    t1839 = -t1837 - t1838
    t1840 = R_p_2*t1837
    t1841 = R_p_2*t1838
    t1842 = t462*(k_sp_2*t27*w_b_2 - t1761*t1836)
    t1843 = t1763*t33
    t1844 = t1800*t1843
    t1845 = -k_sp_3*t43*w_b_3 + t1418*t1844
    t1846 = -k_sp_3*t41*w_b_3 + t1803*t1843
    t1847 = -t1845 - t1846
    t1848 = R_p_3*t1845
    t1849 = R_p_3*t1846
    t1850 = t570*(k_sp_3*t38*w_b_3 - t1774*t1844)
    t1851 = t1739*t1777
    t1852 = t1023*t1851
    t1853 = t1026*t1851
    t1854 = -t1852 - t1853
    t1855 = R_p_1*t1853
    t1856 = R_p_1*t1852
    t1857 = t1752*t1788
    t1858 = t1260*t1857
    t1859 = t1263*t1857
    t1860 = -t1858 - t1859
    t1861 = R_p_2*t1859
    t1862 = R_p_2*t1858
    t1863 = t1765*t1799
    t1864 = t1415*t1863
    t1865 = t1418*t1863
    t1866 = -t1864 - t1865
    t1867 = R_p_3*t1865
    t1868 = R_p_3*t1864
    t1869 = t1816*t1851
    t1870 = t1819*t1857
    t1871 = t1822*t1863
    t1872 = mu_1_by_m_L*t906 + mu_2_by_m_L*t907 + mu_3_by_m_L*t908
    t1873 = mu_1_by_m_L*t910 + mu_2_by_m_L*t911 + mu_3_by_m_L*t912
    t1874 = mu_1_by_m_L*t914 + mu_2_by_m_L*t915 + mu_3_by_m_L*t916
    t1875 = mu_1_by_m_L*t918 + mu_2_by_m_L*t919 + mu_3_by_m_L*t920
    t1876 = mu_1_by_m_L*t922 + mu_2_by_m_L*t923 + mu_3_by_m_L*t924
    t1877 = mu_1_by_m_L*t929 + mu_2_by_m_L*t930 + mu_3_by_m_L*t931
    t1878 = mu_1_by_m_L*t933 + mu_2_by_m_L*t934 + mu_3_by_m_L*t935
    t1879 = mu_1_by_m_L*t937 + mu_2_by_m_L*t938 + mu_3_by_m_L*t939
    t1880 = mu_1_by_m_L*t941 + mu_2_by_m_L*t942 + mu_3_by_m_L*t943
    t1881 = mu_1_by_m_L*t948 + mu_2_by_m_L*t949 + mu_3_by_m_L*t950
    t1882 = mu_1_by_m_L*t952 + mu_2_by_m_L*t953 + mu_3_by_m_L*t954
    t1883 = mu_1_by_m_L*t958 + mu_2_by_m_L*t956 + mu_3_by_m_L*t957
    t1884 = -mu_1_by_m_L*t242 - mu_2_by_m_L*t242 - mu_3_by_m_L*t242
    t1885 = -mu_1_by_m_L*t246 - mu_2_by_m_L*t246 - mu_3_by_m_L*t246
    t1886 = -mu_1_by_m_L*t254 - mu_2_by_m_L*t254 - mu_3_by_m_L*t254
    M_theta_out = np.zeros((*batch, 59, 21, 21), dtype)
    M_theta_out[..., 0, 0, 0] = t178
    M_theta_out[..., 0, 0, 1] = t182
    M_theta_out[..., 0, 0, 2] = t186
    M_theta_out[..., 0, 0, 12] = t190
    M_theta_out[..., 0, 0, 13] = t194
    M_theta_out[..., 0, 0, 14] = t198
    M_theta_out[..., 0, 0, 18] = D_p_x_1
    M_theta_out[..., 0, 0, 19] = D_p_y_1
    M_theta_out[..., 0, 0, 20] = D_p_z_1
    M_theta_out[..., 0, 1, 0] = t182
    M_theta_out[..., 0, 1, 1] = t202
    M_theta_out[..., 0, 1, 2] = t206
    M_theta_out[..., 0, 1, 12] = t210
    M_theta_out[..., 0, 1, 13] = t214
    M_theta_out[..., 0, 1, 14] = t218
    M_theta_out[..., 0, 1, 18] = D_p_x_2
    M_theta_out[..., 0, 1, 19] = D_p_y_2
    M_theta_out[..., 0, 1, 20] = D_p_z_2
    M_theta_out[..., 0, 2, 0] = t186
    M_theta_out[..., 0, 2, 1] = t206
    M_theta_out[..., 0, 2, 2] = t222
    M_theta_out[..., 0, 2, 12] = t226
    M_theta_out[..., 0, 2, 13] = t230
    M_theta_out[..., 0, 2, 14] = t234
    M_theta_out[..., 0, 2, 18] = D_p_x_3
    M_theta_out[..., 0, 2, 19] = D_p_y_3
    M_theta_out[..., 0, 2, 20] = D_p_z_3
    M_theta_out[..., 0, 12, 0] = t190
    M_theta_out[..., 0, 12, 1] = t210
    M_theta_out[..., 0, 12, 2] = t226
    M_theta_out[..., 0, 12, 12] = t238
    M_theta_out[..., 0, 12, 13] = t242
    M_theta_out[..., 0, 12, 14] = t246
    M_theta_out[..., 0, 12, 18] = D_delta_x_1
    M_theta_out[..., 0, 12, 19] = D_delta_y_1
    M_theta_out[..., 0, 12, 20] = D_delta_z_1
    M_theta_out[..., 0, 13, 0] = t194
    M_theta_out[..., 0, 13, 1] = t214
    M_theta_out[..., 0, 13, 2] = t230
    M_theta_out[..., 0, 13, 12] = t242
    M_theta_out[..., 0, 13, 13] = t250
    M_theta_out[..., 0, 13, 14] = t254
    M_theta_out[..., 0, 13, 18] = D_delta_x_2
    M_theta_out[..., 0, 13, 19] = D_delta_y_2
    M_theta_out[..., 0, 13, 20] = D_delta_z_2
    M_theta_out[..., 0, 14, 0] = t198
    M_theta_out[..., 0, 14, 1] = t218
    M_theta_out[..., 0, 14, 2] = t234
    M_theta_out[..., 0, 14, 12] = t246
    M_theta_out[..., 0, 14, 13] = t254
    M_theta_out[..., 0, 14, 14] = t258
    M_theta_out[..., 0, 14, 18] = D_delta_x_3
    M_theta_out[..., 0, 14, 19] = D_delta_y_3
    M_theta_out[..., 0, 14, 20] = D_delta_z_3
    M_theta_out[..., 0, 18, 0] = D_p_x_1
    M_theta_out[..., 0, 18, 1] = D_p_x_2
    M_theta_out[..., 0, 18, 2] = D_p_x_3
    M_theta_out[..., 0, 18, 12] = D_delta_x_1
    M_theta_out[..., 0, 18, 13] = D_delta_x_2
    M_theta_out[..., 0, 18, 14] = D_delta_x_3
    M_theta_out[..., 0, 18, 18] = 1
    M_theta_out[..., 0, 19, 0] = D_p_y_1
    M_theta_out[..., 0, 19, 1] = D_p_y_2
    M_theta_out[..., 0, 19, 2] = D_p_y_3
    M_theta_out[..., 0, 19, 12] = D_delta_y_1
    M_theta_out[..., 0, 19, 13] = D_delta_y_2
    M_theta_out[..., 0, 19, 14] = D_delta_y_3
    M_theta_out[..., 0, 19, 19] = 1
    M_theta_out[..., 0, 20, 0] = D_p_z_1
    M_theta_out[..., 0, 20, 1] = D_p_z_2
    M_theta_out[..., 0, 20, 2] = D_p_z_3
    M_theta_out[..., 0, 20, 12] = D_delta_z_1
    M_theta_out[..., 0, 20, 13] = D_delta_z_2
    M_theta_out[..., 0, 20, 14] = D_delta_z_3
    M_theta_out[..., 0, 20, 20] = 1
    M_theta_out[..., 4, 0, 0] = D_p_x_1_by_b_1_x*t264 + D_p_y_1_by_b_1_x*t266 + D_p_z_1_by_b_1_x*t268
    M_theta_out[..., 4, 0, 1] = t284
    M_theta_out[..., 4, 0, 2] = t294
    M_theta_out[..., 4, 0, 3] = -t297
    M_theta_out[..., 4, 0, 6] = t297
    M_theta_out[..., 4, 0, 12] = t301
    M_theta_out[..., 4, 0, 13] = t302
    M_theta_out[..., 4, 0, 14] = t303
    M_theta_out[..., 4, 0, 18] = t304
    M_theta_out[..., 4, 0, 19] = t305
    M_theta_out[..., 4, 0, 20] = t306
    M_theta_out[..., 4, 1, 0] = t284
    M_theta_out[..., 4, 1, 1] = D_p_x_2_by_b_1_x*t307 + D_p_y_2_by_b_1_x*t308 + D_p_z_2_by_b_1_x*t309
    M_theta_out[..., 4, 1, 2] = t310
    M_theta_out[..., 4, 1, 12] = t314
    M_theta_out[..., 4, 1, 13] = t315
    M_theta_out[..., 4, 1, 14] = t316
    M_theta_out[..., 4, 1, 18] = t317
    M_theta_out[..., 4, 1, 19] = t318
    M_theta_out[..., 4, 1, 20] = t319
    M_theta_out[..., 4, 2, 0] = t294
    M_theta_out[..., 4, 2, 1] = t310
    M_theta_out[..., 4, 2, 2] = D_p_x_3_by_b_1_x*t320 + D_p_y_3_by_b_1_x*t321 + D_p_z_3_by_b_1_x*t322
    M_theta_out[..., 4, 2, 12] = t326
    M_theta_out[..., 4, 2, 13] = t327
    M_theta_out[..., 4, 2, 14] = t328
    M_theta_out[..., 4, 2, 18] = t329
    M_theta_out[..., 4, 2, 19] = t330
    M_theta_out[..., 4, 2, 20] = t331
    M_theta_out[..., 4, 3, 0] = -t297
    M_theta_out[..., 4, 3, 3] = -t335
    M_theta_out[..., 4, 3, 15] = -t297
    M_theta_out[..., 4, 6, 0] = t297
    M_theta_out[..., 4, 6, 6] = t335
    M_theta_out[..., 4, 6, 15] = t297
    M_theta_out[..., 4, 12, 0] = t301
    M_theta_out[..., 4, 12, 1] = t314
    M_theta_out[..., 4, 12, 2] = t326
    M_theta_out[..., 4, 12, 12] = (
        D_delta_x_1_by_b_1_x*t337 + D_delta_y_1_by_b_1_x*t339 + D_delta_z_1_by_b_1_x*t341
    )
    M_theta_out[..., 4, 12, 13] = t345
    M_theta_out[..., 4, 12, 14] = t346
    M_theta_out[..., 4, 12, 18] = t347
    M_theta_out[..., 4, 12, 19] = t348
    M_theta_out[..., 4, 12, 20] = t349
    M_theta_out[..., 4, 13, 0] = t302
    M_theta_out[..., 4, 13, 1] = t315
    M_theta_out[..., 4, 13, 2] = t327
    M_theta_out[..., 4, 13, 12] = t345
    M_theta_out[..., 4, 13, 13] = (
        D_delta_x_2_by_b_1_x*t351 + D_delta_y_2_by_b_1_x*t353 + D_delta_z_2_by_b_1_x*t355
    )
    M_theta_out[..., 4, 13, 14] = t359
    M_theta_out[..., 4, 13, 18] = t360
    M_theta_out[..., 4, 13, 19] = t361
    M_theta_out[..., 4, 13, 20] = t362
    M_theta_out[..., 4, 14, 0] = t303
    M_theta_out[..., 4, 14, 1] = t316
    M_theta_out[..., 4, 14, 2] = t328
    M_theta_out[..., 4, 14, 12] = t346
    M_theta_out[..., 4, 14, 13] = t359
    M_theta_out[..., 4, 14, 14] = (
        D_delta_x_3_by_b_1_x*t363 + D_delta_y_3_by_b_1_x*t364 + D_delta_z_3_by_b_1_x*t365
    )
    M_theta_out[..., 4, 14, 18] = t366
    M_theta_out[..., 4, 14, 19] = t367
    M_theta_out[..., 4, 14, 20] = t368
    M_theta_out[..., 4, 15, 3] = -t297
    M_theta_out[..., 4, 15, 6] = t297
    M_theta_out[..., 4, 18, 0] = t304
    M_theta_out[..., 4, 18, 1] = t317
    M_theta_out[..., 4, 18, 2] = t329
    M_theta_out[..., 4, 18, 12] = t347
    M_theta_out[..., 4, 18, 13] = t360
    M_theta_out[..., 4, 18, 14] = t366
    M_theta_out[..., 4, 19, 0] = t305
    M_theta_out[..., 4, 19, 1] = t318
    M_theta_out[..., 4, 19, 2] = t330
    M_theta_out[..., 4, 19, 12] = t348
    M_theta_out[..., 4, 19, 13] = t361
    M_theta_out[..., 4, 19, 14] = t367
    M_theta_out[..., 4, 20, 0] = t306
    M_theta_out[..., 4, 20, 1] = t319
    M_theta_out[..., 4, 20, 2] = t331
    M_theta_out[..., 4, 20, 12] = t349
    M_theta_out[..., 4, 20, 13] = t362
    M_theta_out[..., 4, 20, 14] = t368
    M_theta_out[..., 5, 0, 0] = D_p_x_1_by_b_1_y*t264 + D_p_y_1_by_b_1_y*t266 + D_p_z_1_by_b_1_y*t268
    M_theta_out[..., 5, 0, 1] = t369
    M_theta_out[..., 5, 0, 2] = t370
    M_theta_out[..., 5, 0, 3] = -t371
    M_theta_out[..., 5, 0, 6] = t371
    M_theta_out[..., 5, 0, 12] = t372
    M_theta_out[..., 5, 0, 13] = t373
    M_theta_out[..., 5, 0, 14] = t374
    M_theta_out[..., 5, 0, 18] = t375
    M_theta_out[..., 5, 0, 19] = t376
    M_theta_out[..., 5, 0, 20] = t377
    M_theta_out[..., 5, 1, 0] = t369
    M_theta_out[..., 5, 1, 1] = D_p_x_2_by_b_1_y*t307 + D_p_y_2_by_b_1_y*t308 + D_p_z_2_by_b_1_y*t309
    M_theta_out[..., 5, 1, 2] = t378
    M_theta_out[..., 5, 1, 12] = t379
    M_theta_out[..., 5, 1, 13] = t380
    M_theta_out[..., 5, 1, 14] = t381
    M_theta_out[..., 5, 1, 18] = t382
    M_theta_out[..., 5, 1, 19] = t383
    M_theta_out[..., 5, 1, 20] = t384
    M_theta_out[..., 5, 2, 0] = t370
    M_theta_out[..., 5, 2, 1] = t378
    M_theta_out[..., 5, 2, 2] = D_p_x_3_by_b_1_y*t320 + D_p_y_3_by_b_1_y*t321 + D_p_z_3_by_b_1_y*t322
    M_theta_out[..., 5, 2, 12] = t385
    M_theta_out[..., 5, 2, 13] = t386
    M_theta_out[..., 5, 2, 14] = t387
    M_theta_out[..., 5, 2, 18] = t388
    M_theta_out[..., 5, 2, 19] = t389
    M_theta_out[..., 5, 2, 20] = t390
    M_theta_out[..., 5, 3, 0] = -t371
    M_theta_out[..., 5, 3, 3] = -t391
    M_theta_out[..., 5, 3, 15] = -t371
    M_theta_out[..., 5, 6, 0] = t371
    M_theta_out[..., 5, 6, 6] = t391
    M_theta_out[..., 5, 6, 15] = t371
    M_theta_out[..., 5, 12, 0] = t372
    M_theta_out[..., 5, 12, 1] = t379
    M_theta_out[..., 5, 12, 2] = t385
    M_theta_out[..., 5, 12, 12] = (
        D_delta_x_1_by_b_1_y*t337 + D_delta_y_1_by_b_1_y*t339 + D_delta_z_1_by_b_1_y*t341
    )
    M_theta_out[..., 5, 12, 13] = t392
    M_theta_out[..., 5, 12, 14] = t393
    M_theta_out[..., 5, 12, 18] = t394
    M_theta_out[..., 5, 12, 19] = t395
    M_theta_out[..., 5, 12, 20] = t396
    M_theta_out[..., 5, 13, 0] = t373
    M_theta_out[..., 5, 13, 1] = t380
    M_theta_out[..., 5, 13, 2] = t386
    M_theta_out[..., 5, 13, 12] = t392
    M_theta_out[..., 5, 13, 13] = (
        D_delta_x_2_by_b_1_y*t351 + D_delta_y_2_by_b_1_y*t353 + D_delta_z_2_by_b_1_y*t355
    )
    M_theta_out[..., 5, 13, 14] = t397
    M_theta_out[..., 5, 13, 18] = t398
    M_theta_out[..., 5, 13, 19] = t399
    M_theta_out[..., 5, 13, 20] = t400
    M_theta_out[..., 5, 14, 0] = t374
    M_theta_out[..., 5, 14, 1] = t381
    M_theta_out[..., 5, 14, 2] = t387
    M_theta_out[..., 5, 14, 12] = t393
    M_theta_out[..., 5, 14, 13] = t397
    M_theta_out[..., 5, 14, 14] = (
        D_delta_x_3_by_b_1_y*t363 + D_delta_y_3_by_b_1_y*t364 + D_delta_z_3_by_b_1_y*t365
    )
    M_theta_out[..., 5, 14, 18] = t401
    M_theta_out[..., 5, 14, 19] = t402
    M_theta_out[..., 5, 14, 20] = t403
    M_theta_out[..., 5, 15, 3] = -t371
    M_theta_out[..., 5, 15, 6] = t371
    M_theta_out[..., 5, 18, 0] = t375
    M_theta_out[..., 5, 18, 1] = t382
    M_theta_out[..., 5, 18, 2] = t388
    M_theta_out[..., 5, 18, 12] = t394
    M_theta_out[..., 5, 18, 13] = t398
    M_theta_out[..., 5, 18, 14] = t401
    M_theta_out[..., 5, 19, 0] = t376
    M_theta_out[..., 5, 19, 1] = t383
    M_theta_out[..., 5, 19, 2] = t389
    M_theta_out[..., 5, 19, 12] = t395
    M_theta_out[..., 5, 19, 13] = t399
    M_theta_out[..., 5, 19, 14] = t402
    M_theta_out[..., 5, 20, 0] = t377
    M_theta_out[..., 5, 20, 1] = t384
    M_theta_out[..., 5, 20, 2] = t390
    M_theta_out[..., 5, 20, 12] = t396
    M_theta_out[..., 5, 20, 13] = t400
    M_theta_out[..., 5, 20, 14] = t403
    M_theta_out[..., 6, 0, 0] = D_p_x_1_by_b_1_z*t264 + D_p_y_1_by_b_1_z*t266 + D_p_z_1_by_b_1_z*t268
    M_theta_out[..., 6, 0, 1] = t404
    M_theta_out[..., 6, 0, 2] = t405
    M_theta_out[..., 6, 0, 3] = -t406
    M_theta_out[..., 6, 0, 6] = t406
    M_theta_out[..., 6, 0, 12] = t407
    M_theta_out[..., 6, 0, 13] = t408
    M_theta_out[..., 6, 0, 14] = t409
    M_theta_out[..., 6, 0, 18] = t410
    M_theta_out[..., 6, 0, 19] = t411
    M_theta_out[..., 6, 0, 20] = t412
    M_theta_out[..., 6, 1, 0] = t404
    M_theta_out[..., 6, 1, 1] = D_p_x_2_by_b_1_z*t307 + D_p_y_2_by_b_1_z*t308 + D_p_z_2_by_b_1_z*t309
    M_theta_out[..., 6, 1, 2] = t413
    M_theta_out[..., 6, 1, 12] = t414
    M_theta_out[..., 6, 1, 13] = t415
    M_theta_out[..., 6, 1, 14] = t416
    M_theta_out[..., 6, 1, 18] = t417
    M_theta_out[..., 6, 1, 19] = t418
    M_theta_out[..., 6, 1, 20] = t419
    M_theta_out[..., 6, 2, 0] = t405
    M_theta_out[..., 6, 2, 1] = t413
    M_theta_out[..., 6, 2, 2] = D_p_x_3_by_b_1_z*t320 + D_p_y_3_by_b_1_z*t321 + D_p_z_3_by_b_1_z*t322
    M_theta_out[..., 6, 2, 12] = t420
    M_theta_out[..., 6, 2, 13] = t421
    M_theta_out[..., 6, 2, 14] = t422
    M_theta_out[..., 6, 2, 18] = t423
    M_theta_out[..., 6, 2, 19] = t424
    M_theta_out[..., 6, 2, 20] = t425
    M_theta_out[..., 6, 3, 0] = -t406
    M_theta_out[..., 6, 3, 3] = -t426
    M_theta_out[..., 6, 3, 15] = -t406
    M_theta_out[..., 6, 6, 0] = t406
    M_theta_out[..., 6, 6, 6] = t426
    M_theta_out[..., 6, 6, 15] = t406
    M_theta_out[..., 6, 12, 0] = t407
    M_theta_out[..., 6, 12, 1] = t414
    M_theta_out[..., 6, 12, 2] = t420
    M_theta_out[..., 6, 12, 12] = (
        D_delta_x_1_by_b_1_z*t337 + D_delta_y_1_by_b_1_z*t339 + D_delta_z_1_by_b_1_z*t341
    )
    M_theta_out[..., 6, 12, 13] = t427
    M_theta_out[..., 6, 12, 14] = t428
    M_theta_out[..., 6, 12, 18] = t429
    M_theta_out[..., 6, 12, 19] = t430
    M_theta_out[..., 6, 12, 20] = t431
    M_theta_out[..., 6, 13, 0] = t408
    M_theta_out[..., 6, 13, 1] = t415
    M_theta_out[..., 6, 13, 2] = t421
    M_theta_out[..., 6, 13, 12] = t427
    M_theta_out[..., 6, 13, 13] = (
        D_delta_x_2_by_b_1_z*t351 + D_delta_y_2_by_b_1_z*t353 + D_delta_z_2_by_b_1_z*t355
    )
    M_theta_out[..., 6, 13, 14] = t432
    M_theta_out[..., 6, 13, 18] = t433
    M_theta_out[..., 6, 13, 19] = t434
    M_theta_out[..., 6, 13, 20] = t435
    M_theta_out[..., 6, 14, 0] = t409
    M_theta_out[..., 6, 14, 1] = t416
    M_theta_out[..., 6, 14, 2] = t422
    M_theta_out[..., 6, 14, 12] = t428
    M_theta_out[..., 6, 14, 13] = t432
    M_theta_out[..., 6, 14, 14] = (
        D_delta_x_3_by_b_1_z*t363 + D_delta_y_3_by_b_1_z*t364 + D_delta_z_3_by_b_1_z*t365
    )
    M_theta_out[..., 6, 14, 18] = t436
    M_theta_out[..., 6, 14, 19] = t437
    M_theta_out[..., 6, 14, 20] = t438
    M_theta_out[..., 6, 15, 3] = -t406
    M_theta_out[..., 6, 15, 6] = t406
    M_theta_out[..., 6, 18, 0] = t410
    M_theta_out[..., 6, 18, 1] = t417
    M_theta_out[..., 6, 18, 2] = t423
    M_theta_out[..., 6, 18, 12] = t429
    M_theta_out[..., 6, 18, 13] = t433
    M_theta_out[..., 6, 18, 14] = t436
    M_theta_out[..., 6, 19, 0] = t411
    M_theta_out[..., 6, 19, 1] = t418
    M_theta_out[..., 6, 19, 2] = t424
    M_theta_out[..., 6, 19, 12] = t430
    M_theta_out[..., 6, 19, 13] = t434
    M_theta_out[..., 6, 19, 14] = t437
    M_theta_out[..., 6, 20, 0] = t412
    M_theta_out[..., 6, 20, 1] = t419
    M_theta_out[..., 6, 20, 2] = t425
    M_theta_out[..., 6, 20, 12] = t431
    M_theta_out[..., 6, 20, 13] = t435
    M_theta_out[..., 6, 20, 14] = t438
    M_theta_out[..., 7, 0, 0] = D_p_x_1_by_b_2_x*t264 + D_p_y_1_by_b_2_x*t266 + D_p_z_1_by_b_2_x*t268
    M_theta_out[..., 7, 0, 1] = t439
    M_theta_out[..., 7, 0, 2] = t440
    M_theta_out[..., 7, 0, 12] = t441
    M_theta_out[..., 7, 0, 13] = t442
    M_theta_out[..., 7, 0, 14] = t443
    M_theta_out[..., 7, 0, 18] = t444
    M_theta_out[..., 7, 0, 19] = t445
    M_theta_out[..., 7, 0, 20] = t446
    M_theta_out[..., 7, 1, 0] = t439
    M_theta_out[..., 7, 1, 1] = D_p_x_2_by_b_2_x*t307 + D_p_y_2_by_b_2_x*t308 + D_p_z_2_by_b_2_x*t309
    M_theta_out[..., 7, 1, 2] = t447
    M_theta_out[..., 7, 1, 4] = -t449
    M_theta_out[..., 7, 1, 7] = t449
    M_theta_out[..., 7, 1, 12] = t450
    M_theta_out[..., 7, 1, 13] = t451
    M_theta_out[..., 7, 1, 14] = t452
    M_theta_out[..., 7, 1, 18] = t453
    M_theta_out[..., 7, 1, 19] = t454
    M_theta_out[..., 7, 1, 20] = t455
    M_theta_out[..., 7, 2, 0] = t440
    M_theta_out[..., 7, 2, 1] = t447
    M_theta_out[..., 7, 2, 2] = D_p_x_3_by_b_2_x*t320 + D_p_y_3_by_b_2_x*t321 + D_p_z_3_by_b_2_x*t322
    M_theta_out[..., 7, 2, 12] = t456
    M_theta_out[..., 7, 2, 13] = t457
    M_theta_out[..., 7, 2, 14] = t458
    M_theta_out[..., 7, 2, 18] = t459
    M_theta_out[..., 7, 2, 19] = t460
    M_theta_out[..., 7, 2, 20] = t461
    M_theta_out[..., 7, 4, 1] = -t449
    M_theta_out[..., 7, 4, 4] = -t464
    M_theta_out[..., 7, 4, 16] = -t449
    M_theta_out[..., 7, 7, 1] = t449
    M_theta_out[..., 7, 7, 7] = t464
    M_theta_out[..., 7, 7, 16] = t449
    M_theta_out[..., 7, 12, 0] = t441
    M_theta_out[..., 7, 12, 1] = t450
    M_theta_out[..., 7, 12, 2] = t456
    M_theta_out[..., 7, 12, 12] = (
        D_delta_x_1_by_b_2_x*t337 + D_delta_y_1_by_b_2_x*t339 + D_delta_z_1_by_b_2_x*t341
    )
    M_theta_out[..., 7, 12, 13] = t465
    M_theta_out[..., 7, 12, 14] = t466
    M_theta_out[..., 7, 12, 18] = t467
    M_theta_out[..., 7, 12, 19] = t468
    M_theta_out[..., 7, 12, 20] = t469
    M_theta_out[..., 7, 13, 0] = t442
    M_theta_out[..., 7, 13, 1] = t451
    M_theta_out[..., 7, 13, 2] = t457
    M_theta_out[..., 7, 13, 12] = t465
    M_theta_out[..., 7, 13, 13] = (
        D_delta_x_2_by_b_2_x*t351 + D_delta_y_2_by_b_2_x*t353 + D_delta_z_2_by_b_2_x*t355
    )
    M_theta_out[..., 7, 13, 14] = t470
    M_theta_out[..., 7, 13, 18] = t471
    M_theta_out[..., 7, 13, 19] = t472
    M_theta_out[..., 7, 13, 20] = t473
    M_theta_out[..., 7, 14, 0] = t443
    M_theta_out[..., 7, 14, 1] = t452
    M_theta_out[..., 7, 14, 2] = t458
    M_theta_out[..., 7, 14, 12] = t466
    M_theta_out[..., 7, 14, 13] = t470
    M_theta_out[..., 7, 14, 14] = (
        D_delta_x_3_by_b_2_x*t363 + D_delta_y_3_by_b_2_x*t364 + D_delta_z_3_by_b_2_x*t365
    )
    M_theta_out[..., 7, 14, 18] = t474
    M_theta_out[..., 7, 14, 19] = t475
    M_theta_out[..., 7, 14, 20] = t476
    M_theta_out[..., 7, 16, 4] = -t449
    M_theta_out[..., 7, 16, 7] = t449
    M_theta_out[..., 7, 18, 0] = t444
    M_theta_out[..., 7, 18, 1] = t453
    M_theta_out[..., 7, 18, 2] = t459
    M_theta_out[..., 7, 18, 12] = t467
    M_theta_out[..., 7, 18, 13] = t471
    M_theta_out[..., 7, 18, 14] = t474
    M_theta_out[..., 7, 19, 0] = t445
    M_theta_out[..., 7, 19, 1] = t454
    M_theta_out[..., 7, 19, 2] = t460
    M_theta_out[..., 7, 19, 12] = t468
    M_theta_out[..., 7, 19, 13] = t472
    M_theta_out[..., 7, 19, 14] = t475
    M_theta_out[..., 7, 20, 0] = t446
    M_theta_out[..., 7, 20, 1] = t455
    M_theta_out[..., 7, 20, 2] = t461
    M_theta_out[..., 7, 20, 12] = t469
    M_theta_out[..., 7, 20, 13] = t473
    M_theta_out[..., 7, 20, 14] = t476
    M_theta_out[..., 8, 0, 0] = D_p_x_1_by_b_2_y*t264 + D_p_y_1_by_b_2_y*t266 + D_p_z_1_by_b_2_y*t268
    M_theta_out[..., 8, 0, 1] = t477
    M_theta_out[..., 8, 0, 2] = t478
    M_theta_out[..., 8, 0, 12] = t479
    M_theta_out[..., 8, 0, 13] = t480
    M_theta_out[..., 8, 0, 14] = t481
    M_theta_out[..., 8, 0, 18] = t482
    M_theta_out[..., 8, 0, 19] = t483
    M_theta_out[..., 8, 0, 20] = t484
    M_theta_out[..., 8, 1, 0] = t477
    M_theta_out[..., 8, 1, 1] = D_p_x_2_by_b_2_y*t307 + D_p_y_2_by_b_2_y*t308 + D_p_z_2_by_b_2_y*t309
    M_theta_out[..., 8, 1, 2] = t485
    M_theta_out[..., 8, 1, 4] = -t486
    M_theta_out[..., 8, 1, 7] = t486
    M_theta_out[..., 8, 1, 12] = t487
    M_theta_out[..., 8, 1, 13] = t488
    M_theta_out[..., 8, 1, 14] = t489
    M_theta_out[..., 8, 1, 18] = t490
    M_theta_out[..., 8, 1, 19] = t491
    M_theta_out[..., 8, 1, 20] = t492
    M_theta_out[..., 8, 2, 0] = t478
    M_theta_out[..., 8, 2, 1] = t485
    M_theta_out[..., 8, 2, 2] = D_p_x_3_by_b_2_y*t320 + D_p_y_3_by_b_2_y*t321 + D_p_z_3_by_b_2_y*t322
    M_theta_out[..., 8, 2, 12] = t493
    M_theta_out[..., 8, 2, 13] = t494
    M_theta_out[..., 8, 2, 14] = t495
    M_theta_out[..., 8, 2, 18] = t496
    M_theta_out[..., 8, 2, 19] = t497
    M_theta_out[..., 8, 2, 20] = t498
    M_theta_out[..., 8, 4, 1] = -t486
    M_theta_out[..., 8, 4, 4] = -t499
    M_theta_out[..., 8, 4, 16] = -t486
    M_theta_out[..., 8, 7, 1] = t486
    M_theta_out[..., 8, 7, 7] = t499
    M_theta_out[..., 8, 7, 16] = t486
    M_theta_out[..., 8, 12, 0] = t479
    M_theta_out[..., 8, 12, 1] = t487
    M_theta_out[..., 8, 12, 2] = t493
    M_theta_out[..., 8, 12, 12] = (
        D_delta_x_1_by_b_2_y*t337 + D_delta_y_1_by_b_2_y*t339 + D_delta_z_1_by_b_2_y*t341
    )
    M_theta_out[..., 8, 12, 13] = t500
    M_theta_out[..., 8, 12, 14] = t501
    M_theta_out[..., 8, 12, 18] = t502
    M_theta_out[..., 8, 12, 19] = t503
    M_theta_out[..., 8, 12, 20] = t504
    M_theta_out[..., 8, 13, 0] = t480
    M_theta_out[..., 8, 13, 1] = t488
    M_theta_out[..., 8, 13, 2] = t494
    M_theta_out[..., 8, 13, 12] = t500
    M_theta_out[..., 8, 13, 13] = (
        D_delta_x_2_by_b_2_y*t351 + D_delta_y_2_by_b_2_y*t353 + D_delta_z_2_by_b_2_y*t355
    )
    M_theta_out[..., 8, 13, 14] = t505
    M_theta_out[..., 8, 13, 18] = t506
    M_theta_out[..., 8, 13, 19] = t507
    M_theta_out[..., 8, 13, 20] = t508
    M_theta_out[..., 8, 14, 0] = t481
    M_theta_out[..., 8, 14, 1] = t489
    M_theta_out[..., 8, 14, 2] = t495
    M_theta_out[..., 8, 14, 12] = t501
    M_theta_out[..., 8, 14, 13] = t505
    M_theta_out[..., 8, 14, 14] = (
        D_delta_x_3_by_b_2_y*t363 + D_delta_y_3_by_b_2_y*t364 + D_delta_z_3_by_b_2_y*t365
    )
    M_theta_out[..., 8, 14, 18] = t509
    M_theta_out[..., 8, 14, 19] = t510
    M_theta_out[..., 8, 14, 20] = t511
    M_theta_out[..., 8, 16, 4] = -t486
    M_theta_out[..., 8, 16, 7] = t486
    M_theta_out[..., 8, 18, 0] = t482
    M_theta_out[..., 8, 18, 1] = t490
    M_theta_out[..., 8, 18, 2] = t496
    M_theta_out[..., 8, 18, 12] = t502
    M_theta_out[..., 8, 18, 13] = t506
    M_theta_out[..., 8, 18, 14] = t509
    M_theta_out[..., 8, 19, 0] = t483
    M_theta_out[..., 8, 19, 1] = t491
    M_theta_out[..., 8, 19, 2] = t497
    M_theta_out[..., 8, 19, 12] = t503
    M_theta_out[..., 8, 19, 13] = t507
    M_theta_out[..., 8, 19, 14] = t510
    M_theta_out[..., 8, 20, 0] = t484
    M_theta_out[..., 8, 20, 1] = t492
    M_theta_out[..., 8, 20, 2] = t498
    M_theta_out[..., 8, 20, 12] = t504
    M_theta_out[..., 8, 20, 13] = t508
    M_theta_out[..., 8, 20, 14] = t511
    M_theta_out[..., 9, 0, 0] = D_p_x_1_by_b_2_z*t264 + D_p_y_1_by_b_2_z*t266 + D_p_z_1_by_b_2_z*t268
    M_theta_out[..., 9, 0, 1] = t512
    M_theta_out[..., 9, 0, 2] = t513
    M_theta_out[..., 9, 0, 12] = t514
    M_theta_out[..., 9, 0, 13] = t515
    M_theta_out[..., 9, 0, 14] = t516
    M_theta_out[..., 9, 0, 18] = t517
    M_theta_out[..., 9, 0, 19] = t518
    M_theta_out[..., 9, 0, 20] = t519
    M_theta_out[..., 9, 1, 0] = t512
    M_theta_out[..., 9, 1, 1] = D_p_x_2_by_b_2_z*t307 + D_p_y_2_by_b_2_z*t308 + D_p_z_2_by_b_2_z*t309
    M_theta_out[..., 9, 1, 2] = t520
    M_theta_out[..., 9, 1, 4] = -t521
    M_theta_out[..., 9, 1, 7] = t521
    M_theta_out[..., 9, 1, 12] = t522
    M_theta_out[..., 9, 1, 13] = t523
    M_theta_out[..., 9, 1, 14] = t524
    M_theta_out[..., 9, 1, 18] = t525
    M_theta_out[..., 9, 1, 19] = t526
    M_theta_out[..., 9, 1, 20] = t527
    M_theta_out[..., 9, 2, 0] = t513
    M_theta_out[..., 9, 2, 1] = t520
    M_theta_out[..., 9, 2, 2] = D_p_x_3_by_b_2_z*t320 + D_p_y_3_by_b_2_z*t321 + D_p_z_3_by_b_2_z*t322
    M_theta_out[..., 9, 2, 12] = t528
    M_theta_out[..., 9, 2, 13] = t529
    M_theta_out[..., 9, 2, 14] = t530
    M_theta_out[..., 9, 2, 18] = t531
    M_theta_out[..., 9, 2, 19] = t532
    M_theta_out[..., 9, 2, 20] = t533
    M_theta_out[..., 9, 4, 1] = -t521
    M_theta_out[..., 9, 4, 4] = -t534
    M_theta_out[..., 9, 4, 16] = -t521
    M_theta_out[..., 9, 7, 1] = t521
    M_theta_out[..., 9, 7, 7] = t534
    M_theta_out[..., 9, 7, 16] = t521
    M_theta_out[..., 9, 12, 0] = t514
    M_theta_out[..., 9, 12, 1] = t522
    M_theta_out[..., 9, 12, 2] = t528
    M_theta_out[..., 9, 12, 12] = (
        D_delta_x_1_by_b_2_z*t337 + D_delta_y_1_by_b_2_z*t339 + D_delta_z_1_by_b_2_z*t341
    )
    M_theta_out[..., 9, 12, 13] = t535
    M_theta_out[..., 9, 12, 14] = t536
    M_theta_out[..., 9, 12, 18] = t537
    M_theta_out[..., 9, 12, 19] = t538
    M_theta_out[..., 9, 12, 20] = t539
    M_theta_out[..., 9, 13, 0] = t515
    M_theta_out[..., 9, 13, 1] = t523
    M_theta_out[..., 9, 13, 2] = t529
    M_theta_out[..., 9, 13, 12] = t535
    M_theta_out[..., 9, 13, 13] = (
        D_delta_x_2_by_b_2_z*t351 + D_delta_y_2_by_b_2_z*t353 + D_delta_z_2_by_b_2_z*t355
    )
    M_theta_out[..., 9, 13, 14] = t540
    M_theta_out[..., 9, 13, 18] = t541
    M_theta_out[..., 9, 13, 19] = t542
    M_theta_out[..., 9, 13, 20] = t543
    M_theta_out[..., 9, 14, 0] = t516
    M_theta_out[..., 9, 14, 1] = t524
    M_theta_out[..., 9, 14, 2] = t530
    M_theta_out[..., 9, 14, 12] = t536
    M_theta_out[..., 9, 14, 13] = t540
    M_theta_out[..., 9, 14, 14] = (
        D_delta_x_3_by_b_2_z*t363 + D_delta_y_3_by_b_2_z*t364 + D_delta_z_3_by_b_2_z*t365
    )
    M_theta_out[..., 9, 14, 18] = t544
    M_theta_out[..., 9, 14, 19] = t545
    M_theta_out[..., 9, 14, 20] = t546
    M_theta_out[..., 9, 16, 4] = -t521
    M_theta_out[..., 9, 16, 7] = t521
    M_theta_out[..., 9, 18, 0] = t517
    M_theta_out[..., 9, 18, 1] = t525
    M_theta_out[..., 9, 18, 2] = t531
    M_theta_out[..., 9, 18, 12] = t537
    M_theta_out[..., 9, 18, 13] = t541
    M_theta_out[..., 9, 18, 14] = t544
    M_theta_out[..., 9, 19, 0] = t518
    M_theta_out[..., 9, 19, 1] = t526
    M_theta_out[..., 9, 19, 2] = t532
    M_theta_out[..., 9, 19, 12] = t538
    M_theta_out[..., 9, 19, 13] = t542
    M_theta_out[..., 9, 19, 14] = t545
    M_theta_out[..., 9, 20, 0] = t519
    M_theta_out[..., 9, 20, 1] = t527
    M_theta_out[..., 9, 20, 2] = t533
    M_theta_out[..., 9, 20, 12] = t539
    M_theta_out[..., 9, 20, 13] = t543
    M_theta_out[..., 9, 20, 14] = t546
    M_theta_out[..., 10, 0, 0] = D_p_x_1_by_b_3_x*t264 + D_p_y_1_by_b_3_x*t266 + D_p_z_1_by_b_3_x*t268
    M_theta_out[..., 10, 0, 1] = t547
    M_theta_out[..., 10, 0, 2] = t548
    M_theta_out[..., 10, 0, 12] = t549
    M_theta_out[..., 10, 0, 13] = t550
    M_theta_out[..., 10, 0, 14] = t551
    M_theta_out[..., 10, 0, 18] = t552
    M_theta_out[..., 10, 0, 19] = t553
    M_theta_out[..., 10, 0, 20] = t554
    M_theta_out[..., 10, 1, 0] = t547
    M_theta_out[..., 10, 1, 1] = D_p_x_2_by_b_3_x*t307 + D_p_y_2_by_b_3_x*t308 + D_p_z_2_by_b_3_x*t309
    M_theta_out[..., 10, 1, 2] = t555
    M_theta_out[..., 10, 1, 12] = t556
    M_theta_out[..., 10, 1, 13] = t557
    M_theta_out[..., 10, 1, 14] = t558
    M_theta_out[..., 10, 1, 18] = t559
    M_theta_out[..., 10, 1, 19] = t560
    M_theta_out[..., 10, 1, 20] = t561
    M_theta_out[..., 10, 2, 0] = t548
    M_theta_out[..., 10, 2, 1] = t555
    M_theta_out[..., 10, 2, 2] = D_p_x_3_by_b_3_x*t320 + D_p_y_3_by_b_3_x*t321 + D_p_z_3_by_b_3_x*t322
    M_theta_out[..., 10, 2, 5] = -t563
    M_theta_out[..., 10, 2, 8] = t563
    M_theta_out[..., 10, 2, 12] = t564
    M_theta_out[..., 10, 2, 13] = t565
    M_theta_out[..., 10, 2, 14] = t566
    M_theta_out[..., 10, 2, 18] = t567
    M_theta_out[..., 10, 2, 19] = t568
    M_theta_out[..., 10, 2, 20] = t569
    M_theta_out[..., 10, 5, 2] = -t563
    M_theta_out[..., 10, 5, 5] = -t572
    M_theta_out[..., 10, 5, 17] = -t563
    M_theta_out[..., 10, 8, 2] = t563
    M_theta_out[..., 10, 8, 8] = t572
    M_theta_out[..., 10, 8, 17] = t563
    M_theta_out[..., 10, 12, 0] = t549
    M_theta_out[..., 10, 12, 1] = t556
    M_theta_out[..., 10, 12, 2] = t564
    M_theta_out[..., 10, 12, 12] = (
        D_delta_x_1_by_b_3_x*t337 + D_delta_y_1_by_b_3_x*t339 + D_delta_z_1_by_b_3_x*t341
    )
    M_theta_out[..., 10, 12, 13] = t573
    M_theta_out[..., 10, 12, 14] = t574
    M_theta_out[..., 10, 12, 18] = t575
    M_theta_out[..., 10, 12, 19] = t576
    M_theta_out[..., 10, 12, 20] = t577
    M_theta_out[..., 10, 13, 0] = t550
    M_theta_out[..., 10, 13, 1] = t557
    M_theta_out[..., 10, 13, 2] = t565
    M_theta_out[..., 10, 13, 12] = t573
    M_theta_out[..., 10, 13, 13] = (
        D_delta_x_2_by_b_3_x*t351 + D_delta_y_2_by_b_3_x*t353 + D_delta_z_2_by_b_3_x*t355
    )
    M_theta_out[..., 10, 13, 14] = t578
    M_theta_out[..., 10, 13, 18] = t579
    M_theta_out[..., 10, 13, 19] = t580
    M_theta_out[..., 10, 13, 20] = t581
    M_theta_out[..., 10, 14, 0] = t551
    M_theta_out[..., 10, 14, 1] = t558
    M_theta_out[..., 10, 14, 2] = t566
    M_theta_out[..., 10, 14, 12] = t574
    M_theta_out[..., 10, 14, 13] = t578
    M_theta_out[..., 10, 14, 14] = (
        D_delta_x_3_by_b_3_x*t363 + D_delta_y_3_by_b_3_x*t364 + D_delta_z_3_by_b_3_x*t365
    )
    M_theta_out[..., 10, 14, 18] = t582
    M_theta_out[..., 10, 14, 19] = t583
    M_theta_out[..., 10, 14, 20] = t584
    M_theta_out[..., 10, 17, 5] = -t563
    M_theta_out[..., 10, 17, 8] = t563
    M_theta_out[..., 10, 18, 0] = t552
    M_theta_out[..., 10, 18, 1] = t559
    M_theta_out[..., 10, 18, 2] = t567
    M_theta_out[..., 10, 18, 12] = t575
    M_theta_out[..., 10, 18, 13] = t579
    M_theta_out[..., 10, 18, 14] = t582
    M_theta_out[..., 10, 19, 0] = t553
    M_theta_out[..., 10, 19, 1] = t560
    M_theta_out[..., 10, 19, 2] = t568
    M_theta_out[..., 10, 19, 12] = t576
    M_theta_out[..., 10, 19, 13] = t580
    M_theta_out[..., 10, 19, 14] = t583
    M_theta_out[..., 10, 20, 0] = t554
    M_theta_out[..., 10, 20, 1] = t561
    M_theta_out[..., 10, 20, 2] = t569
    M_theta_out[..., 10, 20, 12] = t577
    M_theta_out[..., 10, 20, 13] = t581
    M_theta_out[..., 10, 20, 14] = t584
    M_theta_out[..., 11, 0, 0] = D_p_x_1_by_b_3_y*t264 + D_p_y_1_by_b_3_y*t266 + D_p_z_1_by_b_3_y*t268
    M_theta_out[..., 11, 0, 1] = t585
    M_theta_out[..., 11, 0, 2] = t586
    M_theta_out[..., 11, 0, 12] = t587
    M_theta_out[..., 11, 0, 13] = t588
    M_theta_out[..., 11, 0, 14] = t589
    M_theta_out[..., 11, 0, 18] = t590
    M_theta_out[..., 11, 0, 19] = t591
    M_theta_out[..., 11, 0, 20] = t592
    M_theta_out[..., 11, 1, 0] = t585
    M_theta_out[..., 11, 1, 1] = D_p_x_2_by_b_3_y*t307 + D_p_y_2_by_b_3_y*t308 + D_p_z_2_by_b_3_y*t309
    M_theta_out[..., 11, 1, 2] = t593
    M_theta_out[..., 11, 1, 12] = t594
    M_theta_out[..., 11, 1, 13] = t595
    M_theta_out[..., 11, 1, 14] = t596
    M_theta_out[..., 11, 1, 18] = t597
    M_theta_out[..., 11, 1, 19] = t598
    M_theta_out[..., 11, 1, 20] = t599
    M_theta_out[..., 11, 2, 0] = t586
    M_theta_out[..., 11, 2, 1] = t593
    M_theta_out[..., 11, 2, 2] = D_p_x_3_by_b_3_y*t320 + D_p_y_3_by_b_3_y*t321 + D_p_z_3_by_b_3_y*t322
    M_theta_out[..., 11, 2, 5] = -t600
    M_theta_out[..., 11, 2, 8] = t600
    M_theta_out[..., 11, 2, 12] = t601
    M_theta_out[..., 11, 2, 13] = t602
    M_theta_out[..., 11, 2, 14] = t603
    M_theta_out[..., 11, 2, 18] = t604
    M_theta_out[..., 11, 2, 19] = t605
    M_theta_out[..., 11, 2, 20] = t606
    M_theta_out[..., 11, 5, 2] = -t600
    M_theta_out[..., 11, 5, 5] = -t607
    M_theta_out[..., 11, 5, 17] = -t600
    M_theta_out[..., 11, 8, 2] = t600
    M_theta_out[..., 11, 8, 8] = t607
    M_theta_out[..., 11, 8, 17] = t600
    M_theta_out[..., 11, 12, 0] = t587
    M_theta_out[..., 11, 12, 1] = t594
    M_theta_out[..., 11, 12, 2] = t601
    M_theta_out[..., 11, 12, 12] = (
        D_delta_x_1_by_b_3_y*t337 + D_delta_y_1_by_b_3_y*t339 + D_delta_z_1_by_b_3_y*t341
    )
    M_theta_out[..., 11, 12, 13] = t608
    M_theta_out[..., 11, 12, 14] = t609
    M_theta_out[..., 11, 12, 18] = t610
    M_theta_out[..., 11, 12, 19] = t611
    M_theta_out[..., 11, 12, 20] = t612
    M_theta_out[..., 11, 13, 0] = t588
    M_theta_out[..., 11, 13, 1] = t595
    M_theta_out[..., 11, 13, 2] = t602
    M_theta_out[..., 11, 13, 12] = t608
    M_theta_out[..., 11, 13, 13] = (
        D_delta_x_2_by_b_3_y*t351 + D_delta_y_2_by_b_3_y*t353 + D_delta_z_2_by_b_3_y*t355
    )
    M_theta_out[..., 11, 13, 14] = t613
    M_theta_out[..., 11, 13, 18] = t614
    M_theta_out[..., 11, 13, 19] = t615
    M_theta_out[..., 11, 13, 20] = t616
    M_theta_out[..., 11, 14, 0] = t589
    M_theta_out[..., 11, 14, 1] = t596
    M_theta_out[..., 11, 14, 2] = t603
    M_theta_out[..., 11, 14, 12] = t609
    M_theta_out[..., 11, 14, 13] = t613
    M_theta_out[..., 11, 14, 14] = (
        D_delta_x_3_by_b_3_y*t363 + D_delta_y_3_by_b_3_y*t364 + D_delta_z_3_by_b_3_y*t365
    )
    M_theta_out[..., 11, 14, 18] = t617
    M_theta_out[..., 11, 14, 19] = t618
    M_theta_out[..., 11, 14, 20] = t619
    M_theta_out[..., 11, 17, 5] = -t600
    M_theta_out[..., 11, 17, 8] = t600
    M_theta_out[..., 11, 18, 0] = t590
    M_theta_out[..., 11, 18, 1] = t597
    M_theta_out[..., 11, 18, 2] = t604
    M_theta_out[..., 11, 18, 12] = t610
    M_theta_out[..., 11, 18, 13] = t614
    M_theta_out[..., 11, 18, 14] = t617
    M_theta_out[..., 11, 19, 0] = t591
    M_theta_out[..., 11, 19, 1] = t598
    M_theta_out[..., 11, 19, 2] = t605
    M_theta_out[..., 11, 19, 12] = t611
    M_theta_out[..., 11, 19, 13] = t615
    M_theta_out[..., 11, 19, 14] = t618
    M_theta_out[..., 11, 20, 0] = t592
    M_theta_out[..., 11, 20, 1] = t599
    M_theta_out[..., 11, 20, 2] = t606
    M_theta_out[..., 11, 20, 12] = t612
    M_theta_out[..., 11, 20, 13] = t616
    M_theta_out[..., 11, 20, 14] = t619
    M_theta_out[..., 12, 0, 0] = D_p_x_1_by_b_3_z*t264 + D_p_y_1_by_b_3_z*t266 + D_p_z_1_by_b_3_z*t268
    M_theta_out[..., 12, 0, 1] = t620
    M_theta_out[..., 12, 0, 2] = t621
    M_theta_out[..., 12, 0, 12] = t622
    M_theta_out[..., 12, 0, 13] = t623
    M_theta_out[..., 12, 0, 14] = t624
    M_theta_out[..., 12, 0, 18] = t625
    M_theta_out[..., 12, 0, 19] = t626
    M_theta_out[..., 12, 0, 20] = t627
    M_theta_out[..., 12, 1, 0] = t620
    M_theta_out[..., 12, 1, 1] = D_p_x_2_by_b_3_z*t307 + D_p_y_2_by_b_3_z*t308 + D_p_z_2_by_b_3_z*t309
    M_theta_out[..., 12, 1, 2] = t628
    M_theta_out[..., 12, 1, 12] = t629
    M_theta_out[..., 12, 1, 13] = t630
    M_theta_out[..., 12, 1, 14] = t631
    M_theta_out[..., 12, 1, 18] = t632
    M_theta_out[..., 12, 1, 19] = t633
    M_theta_out[..., 12, 1, 20] = t634
    M_theta_out[..., 12, 2, 0] = t621
    M_theta_out[..., 12, 2, 1] = t628
    M_theta_out[..., 12, 2, 2] = D_p_x_3_by_b_3_z*t320 + D_p_y_3_by_b_3_z*t321 + D_p_z_3_by_b_3_z*t322
    M_theta_out[..., 12, 2, 5] = -t635
    M_theta_out[..., 12, 2, 8] = t635
    M_theta_out[..., 12, 2, 12] = t636
    M_theta_out[..., 12, 2, 13] = t637
    M_theta_out[..., 12, 2, 14] = t638
    M_theta_out[..., 12, 2, 18] = t639
    M_theta_out[..., 12, 2, 19] = t640
    M_theta_out[..., 12, 2, 20] = t641
    M_theta_out[..., 12, 5, 2] = -t635
    M_theta_out[..., 12, 5, 5] = -t642
    M_theta_out[..., 12, 5, 17] = -t635
    M_theta_out[..., 12, 8, 2] = t635
    M_theta_out[..., 12, 8, 8] = t642
    M_theta_out[..., 12, 8, 17] = t635
    M_theta_out[..., 12, 12, 0] = t622
    M_theta_out[..., 12, 12, 1] = t629
    M_theta_out[..., 12, 12, 2] = t636
    M_theta_out[..., 12, 12, 12] = (
        D_delta_x_1_by_b_3_z*t337 + D_delta_y_1_by_b_3_z*t339 + D_delta_z_1_by_b_3_z*t341
    )
    M_theta_out[..., 12, 12, 13] = t643
    M_theta_out[..., 12, 12, 14] = t644
    M_theta_out[..., 12, 12, 18] = t645
    M_theta_out[..., 12, 12, 19] = t646
    M_theta_out[..., 12, 12, 20] = t647
    M_theta_out[..., 12, 13, 0] = t623
    M_theta_out[..., 12, 13, 1] = t630
    M_theta_out[..., 12, 13, 2] = t637
    M_theta_out[..., 12, 13, 12] = t643
    M_theta_out[..., 12, 13, 13] = (
        D_delta_x_2_by_b_3_z*t351 + D_delta_y_2_by_b_3_z*t353 + D_delta_z_2_by_b_3_z*t355
    )
    M_theta_out[..., 12, 13, 14] = t648
    M_theta_out[..., 12, 13, 18] = t649
    M_theta_out[..., 12, 13, 19] = t650
    M_theta_out[..., 12, 13, 20] = t651
    M_theta_out[..., 12, 14, 0] = t624
    M_theta_out[..., 12, 14, 1] = t631
    M_theta_out[..., 12, 14, 2] = t638
    M_theta_out[..., 12, 14, 12] = t644
    M_theta_out[..., 12, 14, 13] = t648
    M_theta_out[..., 12, 14, 14] = (
        D_delta_x_3_by_b_3_z*t363 + D_delta_y_3_by_b_3_z*t364 + D_delta_z_3_by_b_3_z*t365
    )
    M_theta_out[..., 12, 14, 18] = t652
    M_theta_out[..., 12, 14, 19] = t653
    M_theta_out[..., 12, 14, 20] = t654
    M_theta_out[..., 12, 17, 5] = -t635
    M_theta_out[..., 12, 17, 8] = t635
    M_theta_out[..., 12, 18, 0] = t625
    M_theta_out[..., 12, 18, 1] = t632
    M_theta_out[..., 12, 18, 2] = t639
    M_theta_out[..., 12, 18, 12] = t645
    M_theta_out[..., 12, 18, 13] = t649
    M_theta_out[..., 12, 18, 14] = t652
    M_theta_out[..., 12, 19, 0] = t626
    M_theta_out[..., 12, 19, 1] = t633
    M_theta_out[..., 12, 19, 2] = t640
    M_theta_out[..., 12, 19, 12] = t646
    M_theta_out[..., 12, 19, 13] = t650
    M_theta_out[..., 12, 19, 14] = t653
    M_theta_out[..., 12, 20, 0] = t627
    M_theta_out[..., 12, 20, 1] = t634
    M_theta_out[..., 12, 20, 2] = t641
    M_theta_out[..., 12, 20, 12] = t647
    M_theta_out[..., 12, 20, 13] = t651
    M_theta_out[..., 12, 20, 14] = t654
    M_theta_out[..., 13, 0, 0] = D_p_x_1_by_l_d_1*t264 + D_p_y_1_by_l_d_1*t266 + D_p_z_1_by_l_d_1*t268
    M_theta_out[..., 13, 0, 1] = t655
    M_theta_out[..., 13, 0, 2] = t656
    M_theta_out[..., 13, 0, 3] = -t657
    M_theta_out[..., 13, 0, 6] = t657
    M_theta_out[..., 13, 0, 12] = t658
    M_theta_out[..., 13, 0, 13] = t659
    M_theta_out[..., 13, 0, 14] = t660
    M_theta_out[..., 13, 0, 18] = t661
    M_theta_out[..., 13, 0, 19] = t662
    M_theta_out[..., 13, 0, 20] = t663
    M_theta_out[..., 13, 1, 0] = t655
    M_theta_out[..., 13, 1, 1] = D_p_x_2_by_l_d_1*t307 + D_p_y_2_by_l_d_1*t308 + D_p_z_2_by_l_d_1*t309
    M_theta_out[..., 13, 1, 2] = t664
    M_theta_out[..., 13, 1, 12] = t665
    M_theta_out[..., 13, 1, 13] = t666
    M_theta_out[..., 13, 1, 14] = t667
    M_theta_out[..., 13, 1, 18] = t668
    M_theta_out[..., 13, 1, 19] = t669
    M_theta_out[..., 13, 1, 20] = t670
    M_theta_out[..., 13, 2, 0] = t656
    M_theta_out[..., 13, 2, 1] = t664
    M_theta_out[..., 13, 2, 2] = D_p_x_3_by_l_d_1*t320 + D_p_y_3_by_l_d_1*t321 + D_p_z_3_by_l_d_1*t322
    M_theta_out[..., 13, 2, 12] = t671
    M_theta_out[..., 13, 2, 13] = t672
    M_theta_out[..., 13, 2, 14] = t673
    M_theta_out[..., 13, 2, 18] = t674
    M_theta_out[..., 13, 2, 19] = t675
    M_theta_out[..., 13, 2, 20] = t676
    M_theta_out[..., 13, 3, 0] = -t657
    M_theta_out[..., 13, 3, 3] = -t677
    M_theta_out[..., 13, 3, 15] = -t657
    M_theta_out[..., 13, 6, 0] = t657
    M_theta_out[..., 13, 6, 6] = t677
    M_theta_out[..., 13, 6, 15] = t657
    M_theta_out[..., 13, 12, 0] = t658
    M_theta_out[..., 13, 12, 1] = t665
    M_theta_out[..., 13, 12, 2] = t671
    M_theta_out[..., 13, 12, 12] = (
        D_delta_x_1_by_l_d_1*t337 + D_delta_y_1_by_l_d_1*t339 + D_delta_z_1_by_l_d_1*t341
    )
    M_theta_out[..., 13, 12, 13] = t678
    M_theta_out[..., 13, 12, 14] = t679
    M_theta_out[..., 13, 12, 18] = t680
    M_theta_out[..., 13, 12, 19] = t681
    M_theta_out[..., 13, 12, 20] = t682
    M_theta_out[..., 13, 13, 0] = t659
    M_theta_out[..., 13, 13, 1] = t666
    M_theta_out[..., 13, 13, 2] = t672
    M_theta_out[..., 13, 13, 12] = t678
    M_theta_out[..., 13, 13, 13] = (
        D_delta_x_2_by_l_d_1*t351 + D_delta_y_2_by_l_d_1*t353 + D_delta_z_2_by_l_d_1*t355
    )
    M_theta_out[..., 13, 13, 14] = t683
    M_theta_out[..., 13, 13, 18] = t684
    M_theta_out[..., 13, 13, 19] = t685
    M_theta_out[..., 13, 13, 20] = t686
    M_theta_out[..., 13, 14, 0] = t660
    M_theta_out[..., 13, 14, 1] = t667
    M_theta_out[..., 13, 14, 2] = t673
    M_theta_out[..., 13, 14, 12] = t679
    M_theta_out[..., 13, 14, 13] = t683
    M_theta_out[..., 13, 14, 14] = (
        D_delta_x_3_by_l_d_1*t363 + D_delta_y_3_by_l_d_1*t364 + D_delta_z_3_by_l_d_1*t365
    )
    M_theta_out[..., 13, 14, 18] = t687
    M_theta_out[..., 13, 14, 19] = t688
    M_theta_out[..., 13, 14, 20] = t689
    M_theta_out[..., 13, 15, 3] = -t657
    M_theta_out[..., 13, 15, 6] = t657
    M_theta_out[..., 13, 18, 0] = t661
    M_theta_out[..., 13, 18, 1] = t668
    M_theta_out[..., 13, 18, 2] = t674
    M_theta_out[..., 13, 18, 12] = t680
    M_theta_out[..., 13, 18, 13] = t684
    M_theta_out[..., 13, 18, 14] = t687
    M_theta_out[..., 13, 19, 0] = t662
    M_theta_out[..., 13, 19, 1] = t669
    M_theta_out[..., 13, 19, 2] = t675
    M_theta_out[..., 13, 19, 12] = t681
    M_theta_out[..., 13, 19, 13] = t685
    M_theta_out[..., 13, 19, 14] = t688
    M_theta_out[..., 13, 20, 0] = t663
    M_theta_out[..., 13, 20, 1] = t670
    M_theta_out[..., 13, 20, 2] = t676
    M_theta_out[..., 13, 20, 12] = t682
    M_theta_out[..., 13, 20, 13] = t686
    M_theta_out[..., 13, 20, 14] = t689
    M_theta_out[..., 14, 0, 0] = D_p_x_1_by_l_d_2*t264 + D_p_y_1_by_l_d_2*t266 + D_p_z_1_by_l_d_2*t268
    M_theta_out[..., 14, 0, 1] = t690
    M_theta_out[..., 14, 0, 2] = t691
    M_theta_out[..., 14, 0, 12] = t692
    M_theta_out[..., 14, 0, 13] = t693
    M_theta_out[..., 14, 0, 14] = t694
    M_theta_out[..., 14, 0, 18] = t695
    M_theta_out[..., 14, 0, 19] = t696
    M_theta_out[..., 14, 0, 20] = t697
    M_theta_out[..., 14, 1, 0] = t690
    M_theta_out[..., 14, 1, 1] = D_p_x_2_by_l_d_2*t307 + D_p_y_2_by_l_d_2*t308 + D_p_z_2_by_l_d_2*t309
    M_theta_out[..., 14, 1, 2] = t698
    M_theta_out[..., 14, 1, 4] = -t699
    M_theta_out[..., 14, 1, 7] = t699
    M_theta_out[..., 14, 1, 12] = t700
    M_theta_out[..., 14, 1, 13] = t701
    M_theta_out[..., 14, 1, 14] = t702
    M_theta_out[..., 14, 1, 18] = t703
    M_theta_out[..., 14, 1, 19] = t704
    M_theta_out[..., 14, 1, 20] = t705
    M_theta_out[..., 14, 2, 0] = t691
    M_theta_out[..., 14, 2, 1] = t698
    M_theta_out[..., 14, 2, 2] = D_p_x_3_by_l_d_2*t320 + D_p_y_3_by_l_d_2*t321 + D_p_z_3_by_l_d_2*t322
    M_theta_out[..., 14, 2, 12] = t706
    M_theta_out[..., 14, 2, 13] = t707
    M_theta_out[..., 14, 2, 14] = t708
    M_theta_out[..., 14, 2, 18] = t709
    M_theta_out[..., 14, 2, 19] = t710
    M_theta_out[..., 14, 2, 20] = t711
    M_theta_out[..., 14, 4, 1] = -t699
    M_theta_out[..., 14, 4, 4] = -t712
    M_theta_out[..., 14, 4, 16] = -t699
    M_theta_out[..., 14, 7, 1] = t699
    M_theta_out[..., 14, 7, 7] = t712
    M_theta_out[..., 14, 7, 16] = t699
    M_theta_out[..., 14, 12, 0] = t692
    M_theta_out[..., 14, 12, 1] = t700
    M_theta_out[..., 14, 12, 2] = t706
    M_theta_out[..., 14, 12, 12] = (
        D_delta_x_1_by_l_d_2*t337 + D_delta_y_1_by_l_d_2*t339 + D_delta_z_1_by_l_d_2*t341
    )
    M_theta_out[..., 14, 12, 13] = t713
    M_theta_out[..., 14, 12, 14] = t714
    M_theta_out[..., 14, 12, 18] = t715
    M_theta_out[..., 14, 12, 19] = t716
    M_theta_out[..., 14, 12, 20] = t717
    M_theta_out[..., 14, 13, 0] = t693
    M_theta_out[..., 14, 13, 1] = t701
    M_theta_out[..., 14, 13, 2] = t707
    M_theta_out[..., 14, 13, 12] = t713
    M_theta_out[..., 14, 13, 13] = (
        D_delta_x_2_by_l_d_2*t351 + D_delta_y_2_by_l_d_2*t353 + D_delta_z_2_by_l_d_2*t355
    )
    M_theta_out[..., 14, 13, 14] = t718
    M_theta_out[..., 14, 13, 18] = t719
    M_theta_out[..., 14, 13, 19] = t720
    M_theta_out[..., 14, 13, 20] = t721
    M_theta_out[..., 14, 14, 0] = t694
    M_theta_out[..., 14, 14, 1] = t702
    M_theta_out[..., 14, 14, 2] = t708
    M_theta_out[..., 14, 14, 12] = t714
    M_theta_out[..., 14, 14, 13] = t718
    M_theta_out[..., 14, 14, 14] = (
        D_delta_x_3_by_l_d_2*t363 + D_delta_y_3_by_l_d_2*t364 + D_delta_z_3_by_l_d_2*t365
    )
    M_theta_out[..., 14, 14, 18] = t722
    M_theta_out[..., 14, 14, 19] = t723
    M_theta_out[..., 14, 14, 20] = t724
    M_theta_out[..., 14, 16, 4] = -t699
    M_theta_out[..., 14, 16, 7] = t699
    M_theta_out[..., 14, 18, 0] = t695
    M_theta_out[..., 14, 18, 1] = t703
    M_theta_out[..., 14, 18, 2] = t709
    M_theta_out[..., 14, 18, 12] = t715
    M_theta_out[..., 14, 18, 13] = t719
    M_theta_out[..., 14, 18, 14] = t722
    M_theta_out[..., 14, 19, 0] = t696
    M_theta_out[..., 14, 19, 1] = t704
    M_theta_out[..., 14, 19, 2] = t710
    M_theta_out[..., 14, 19, 12] = t716
    M_theta_out[..., 14, 19, 13] = t720
    M_theta_out[..., 14, 19, 14] = t723
    M_theta_out[..., 14, 20, 0] = t697
    M_theta_out[..., 14, 20, 1] = t705
    M_theta_out[..., 14, 20, 2] = t711
    M_theta_out[..., 14, 20, 12] = t717
    M_theta_out[..., 14, 20, 13] = t721
    M_theta_out[..., 14, 20, 14] = t724
    M_theta_out[..., 15, 0, 0] = D_p_x_1_by_l_d_3*t264 + D_p_y_1_by_l_d_3*t266 + D_p_z_1_by_l_d_3*t268
    M_theta_out[..., 15, 0, 1] = t725
    M_theta_out[..., 15, 0, 2] = t726
    M_theta_out[..., 15, 0, 12] = t727
    M_theta_out[..., 15, 0, 13] = t728
    M_theta_out[..., 15, 0, 14] = t729
    M_theta_out[..., 15, 0, 18] = t730
    M_theta_out[..., 15, 0, 19] = t731
    M_theta_out[..., 15, 0, 20] = t732
    M_theta_out[..., 15, 1, 0] = t725
    M_theta_out[..., 15, 1, 1] = D_p_x_2_by_l_d_3*t307 + D_p_y_2_by_l_d_3*t308 + D_p_z_2_by_l_d_3*t309
    M_theta_out[..., 15, 1, 2] = t733
    M_theta_out[..., 15, 1, 12] = t734
    M_theta_out[..., 15, 1, 13] = t735
    M_theta_out[..., 15, 1, 14] = t736
    M_theta_out[..., 15, 1, 18] = t737
    M_theta_out[..., 15, 1, 19] = t738
    M_theta_out[..., 15, 1, 20] = t739
    M_theta_out[..., 15, 2, 0] = t726
    M_theta_out[..., 15, 2, 1] = t733
    M_theta_out[..., 15, 2, 2] = D_p_x_3_by_l_d_3*t320 + D_p_y_3_by_l_d_3*t321 + D_p_z_3_by_l_d_3*t322
    M_theta_out[..., 15, 2, 5] = -t740
    M_theta_out[..., 15, 2, 8] = t740
    M_theta_out[..., 15, 2, 12] = t741
    M_theta_out[..., 15, 2, 13] = t742
    M_theta_out[..., 15, 2, 14] = t743
    M_theta_out[..., 15, 2, 18] = t744
    M_theta_out[..., 15, 2, 19] = t745
    M_theta_out[..., 15, 2, 20] = t746
    M_theta_out[..., 15, 5, 2] = -t740
    M_theta_out[..., 15, 5, 5] = -t747
    M_theta_out[..., 15, 5, 17] = -t740
    M_theta_out[..., 15, 8, 2] = t740
    M_theta_out[..., 15, 8, 8] = t747
    M_theta_out[..., 15, 8, 17] = t740
    M_theta_out[..., 15, 12, 0] = t727
    M_theta_out[..., 15, 12, 1] = t734
    M_theta_out[..., 15, 12, 2] = t741
    M_theta_out[..., 15, 12, 12] = (
        D_delta_x_1_by_l_d_3*t337 + D_delta_y_1_by_l_d_3*t339 + D_delta_z_1_by_l_d_3*t341
    )
    M_theta_out[..., 15, 12, 13] = t748
    M_theta_out[..., 15, 12, 14] = t749
    M_theta_out[..., 15, 12, 18] = t750
    M_theta_out[..., 15, 12, 19] = t751
    M_theta_out[..., 15, 12, 20] = t752
    M_theta_out[..., 15, 13, 0] = t728
    M_theta_out[..., 15, 13, 1] = t735
    M_theta_out[..., 15, 13, 2] = t742
    M_theta_out[..., 15, 13, 12] = t748
    M_theta_out[..., 15, 13, 13] = (
        D_delta_x_2_by_l_d_3*t351 + D_delta_y_2_by_l_d_3*t353 + D_delta_z_2_by_l_d_3*t355
    )
    M_theta_out[..., 15, 13, 14] = t753
    M_theta_out[..., 15, 13, 18] = t754
    M_theta_out[..., 15, 13, 19] = t755
    M_theta_out[..., 15, 13, 20] = t756
    M_theta_out[..., 15, 14, 0] = t729
    M_theta_out[..., 15, 14, 1] = t736
    M_theta_out[..., 15, 14, 2] = t743
    M_theta_out[..., 15, 14, 12] = t749
    M_theta_out[..., 15, 14, 13] = t753
    M_theta_out[..., 15, 14, 14] = (
        D_delta_x_3_by_l_d_3*t363 + D_delta_y_3_by_l_d_3*t364 + D_delta_z_3_by_l_d_3*t365
    )
    M_theta_out[..., 15, 14, 18] = t757
    M_theta_out[..., 15, 14, 19] = t758
    M_theta_out[..., 15, 14, 20] = t759
    M_theta_out[..., 15, 17, 5] = -t740
    M_theta_out[..., 15, 17, 8] = t740
    M_theta_out[..., 15, 18, 0] = t730
    M_theta_out[..., 15, 18, 1] = t737
    M_theta_out[..., 15, 18, 2] = t744
    M_theta_out[..., 15, 18, 12] = t750
    M_theta_out[..., 15, 18, 13] = t754
    M_theta_out[..., 15, 18, 14] = t757
    M_theta_out[..., 15, 19, 0] = t731
    M_theta_out[..., 15, 19, 1] = t738
    M_theta_out[..., 15, 19, 2] = t745
    M_theta_out[..., 15, 19, 12] = t751
    M_theta_out[..., 15, 19, 13] = t755
    M_theta_out[..., 15, 19, 14] = t758
    M_theta_out[..., 15, 20, 0] = t732
    M_theta_out[..., 15, 20, 1] = t739
    M_theta_out[..., 15, 20, 2] = t746
    M_theta_out[..., 15, 20, 12] = t752
    M_theta_out[..., 15, 20, 13] = t756
    M_theta_out[..., 15, 20, 14] = t759
    M_theta_out[..., 16, 0, 0] = (
        D_p_x_1*t272 + D_p_x_1*t760 + D_p_y_1*t277 + D_p_y_1*t761 + D_p_z_1*t282 + D_p_z_1*t762 + 1/3
    )
    M_theta_out[..., 16, 0, 1] = t763
    M_theta_out[..., 16, 0, 2] = t764
    M_theta_out[..., 16, 0, 12] = t765
    M_theta_out[..., 16, 0, 13] = t766
    M_theta_out[..., 16, 0, 14] = t767
    M_theta_out[..., 16, 0, 18] = t769
    M_theta_out[..., 16, 0, 19] = t771
    M_theta_out[..., 16, 0, 20] = t773
    M_theta_out[..., 16, 1, 0] = t763
    M_theta_out[..., 16, 1, 1] = t774
    M_theta_out[..., 16, 1, 2] = t775
    M_theta_out[..., 16, 1, 12] = t776
    M_theta_out[..., 16, 1, 13] = t777
    M_theta_out[..., 16, 1, 14] = t778
    M_theta_out[..., 16, 1, 18] = t779
    M_theta_out[..., 16, 1, 19] = t780
    M_theta_out[..., 16, 1, 20] = t781
    M_theta_out[..., 16, 2, 0] = t764
    M_theta_out[..., 16, 2, 1] = t775
    M_theta_out[..., 16, 2, 2] = t782
    M_theta_out[..., 16, 2, 12] = t783
    M_theta_out[..., 16, 2, 13] = t784
    M_theta_out[..., 16, 2, 14] = t785
    M_theta_out[..., 16, 2, 18] = t786
    M_theta_out[..., 16, 2, 19] = t787
    M_theta_out[..., 16, 2, 20] = t788
    M_theta_out[..., 16, 12, 0] = t765
    M_theta_out[..., 16, 12, 1] = t776
    M_theta_out[..., 16, 12, 2] = t783
    M_theta_out[..., 16, 12, 12] = t789
    M_theta_out[..., 16, 12, 13] = t790
    M_theta_out[..., 16, 12, 14] = t791
    M_theta_out[..., 16, 12, 18] = t792
    M_theta_out[..., 16, 12, 19] = t793
    M_theta_out[..., 16, 12, 20] = t794
    M_theta_out[..., 16, 13, 0] = t766
    M_theta_out[..., 16, 13, 1] = t777
    M_theta_out[..., 16, 13, 2] = t784
    M_theta_out[..., 16, 13, 12] = t790
    M_theta_out[..., 16, 13, 13] = t795
    M_theta_out[..., 16, 13, 14] = t796
    M_theta_out[..., 16, 13, 18] = t797
    M_theta_out[..., 16, 13, 19] = t798
    M_theta_out[..., 16, 13, 20] = t799
    M_theta_out[..., 16, 14, 0] = t767
    M_theta_out[..., 16, 14, 1] = t778
    M_theta_out[..., 16, 14, 2] = t785
    M_theta_out[..., 16, 14, 12] = t791
    M_theta_out[..., 16, 14, 13] = t796
    M_theta_out[..., 16, 14, 14] = t800
    M_theta_out[..., 16, 14, 18] = t801
    M_theta_out[..., 16, 14, 19] = t802
    M_theta_out[..., 16, 14, 20] = t803
    M_theta_out[..., 16, 18, 0] = t769
    M_theta_out[..., 16, 18, 1] = t779
    M_theta_out[..., 16, 18, 2] = t786
    M_theta_out[..., 16, 18, 12] = t792
    M_theta_out[..., 16, 18, 13] = t797
    M_theta_out[..., 16, 18, 14] = t801
    M_theta_out[..., 16, 18, 18] = 1
    M_theta_out[..., 16, 19, 0] = t771
    M_theta_out[..., 16, 19, 1] = t780
    M_theta_out[..., 16, 19, 2] = t787
    M_theta_out[..., 16, 19, 12] = t793
    M_theta_out[..., 16, 19, 13] = t798
    M_theta_out[..., 16, 19, 14] = t802
    M_theta_out[..., 16, 19, 19] = 1
    M_theta_out[..., 16, 20, 0] = t773
    M_theta_out[..., 16, 20, 1] = t781
    M_theta_out[..., 16, 20, 2] = t788
    M_theta_out[..., 16, 20, 12] = t794
    M_theta_out[..., 16, 20, 13] = t799
    M_theta_out[..., 16, 20, 14] = t803
    M_theta_out[..., 16, 20, 20] = 1
    M_theta_out[..., 17, 0, 0] = t804
    M_theta_out[..., 17, 0, 1] = t806
    M_theta_out[..., 17, 0, 2] = t807
    M_theta_out[..., 17, 0, 12] = t808
    M_theta_out[..., 17, 0, 13] = t809
    M_theta_out[..., 17, 0, 14] = t810
    M_theta_out[..., 17, 0, 18] = t768
    M_theta_out[..., 17, 0, 19] = t770
    M_theta_out[..., 17, 0, 20] = t772
    M_theta_out[..., 17, 1, 0] = t806
    M_theta_out[..., 17, 1, 1] = (
        D_p_x_2*t269 + D_p_x_2*t811 + D_p_y_2*t274 + D_p_y_2*t812 + D_p_z_2*t279 + D_p_z_2*t813 + 1/3
    )
    M_theta_out[..., 17, 1, 2] = t814
    M_theta_out[..., 17, 1, 12] = t815
    M_theta_out[..., 17, 1, 13] = t816
    M_theta_out[..., 17, 1, 14] = t817
    M_theta_out[..., 17, 1, 18] = t818
    M_theta_out[..., 17, 1, 19] = t819
    M_theta_out[..., 17, 1, 20] = t820
    M_theta_out[..., 17, 2, 0] = t807
    M_theta_out[..., 17, 2, 1] = t814
    M_theta_out[..., 17, 2, 2] = t782
    M_theta_out[..., 17, 2, 12] = t783
    M_theta_out[..., 17, 2, 13] = t784
    M_theta_out[..., 17, 2, 14] = t785
    M_theta_out[..., 17, 2, 18] = t786
    M_theta_out[..., 17, 2, 19] = t787
    M_theta_out[..., 17, 2, 20] = t788
    M_theta_out[..., 17, 12, 0] = t808
    M_theta_out[..., 17, 12, 1] = t815
    M_theta_out[..., 17, 12, 2] = t783
    M_theta_out[..., 17, 12, 12] = t789
    M_theta_out[..., 17, 12, 13] = t790
    M_theta_out[..., 17, 12, 14] = t791
    M_theta_out[..., 17, 12, 18] = t792
    M_theta_out[..., 17, 12, 19] = t793
    M_theta_out[..., 17, 12, 20] = t794
    M_theta_out[..., 17, 13, 0] = t809
    M_theta_out[..., 17, 13, 1] = t816
    M_theta_out[..., 17, 13, 2] = t784
    M_theta_out[..., 17, 13, 12] = t790
    M_theta_out[..., 17, 13, 13] = t795
    M_theta_out[..., 17, 13, 14] = t796
    M_theta_out[..., 17, 13, 18] = t797
    M_theta_out[..., 17, 13, 19] = t798
    M_theta_out[..., 17, 13, 20] = t799
    M_theta_out[..., 17, 14, 0] = t810
    M_theta_out[..., 17, 14, 1] = t817
    M_theta_out[..., 17, 14, 2] = t785
    M_theta_out[..., 17, 14, 12] = t791
    M_theta_out[..., 17, 14, 13] = t796
    M_theta_out[..., 17, 14, 14] = t800
    M_theta_out[..., 17, 14, 18] = t801
    M_theta_out[..., 17, 14, 19] = t802
    M_theta_out[..., 17, 14, 20] = t803
    M_theta_out[..., 17, 18, 0] = t768
    M_theta_out[..., 17, 18, 1] = t818
    M_theta_out[..., 17, 18, 2] = t786
    M_theta_out[..., 17, 18, 12] = t792
    M_theta_out[..., 17, 18, 13] = t797
    M_theta_out[..., 17, 18, 14] = t801
    M_theta_out[..., 17, 18, 18] = 1
    M_theta_out[..., 17, 19, 0] = t770
    M_theta_out[..., 17, 19, 1] = t819
    M_theta_out[..., 17, 19, 2] = t787
    M_theta_out[..., 17, 19, 12] = t793
    M_theta_out[..., 17, 19, 13] = t798
    M_theta_out[..., 17, 19, 14] = t802
    M_theta_out[..., 17, 19, 19] = 1
    M_theta_out[..., 17, 20, 0] = t772
    M_theta_out[..., 17, 20, 1] = t820
    M_theta_out[..., 17, 20, 2] = t788
    M_theta_out[..., 17, 20, 12] = t794
    M_theta_out[..., 17, 20, 13] = t799
    M_theta_out[..., 17, 20, 14] = t803
    M_theta_out[..., 17, 20, 20] = 1
    M_theta_out[..., 18, 0, 0] = t804
    M_theta_out[..., 18, 0, 1] = t805
    M_theta_out[..., 18, 0, 2] = t821
    M_theta_out[..., 18, 0, 12] = t808
    M_theta_out[..., 18, 0, 13] = t809
    M_theta_out[..., 18, 0, 14] = t810
    M_theta_out[..., 18, 0, 18] = t768
    M_theta_out[..., 18, 0, 19] = t770
    M_theta_out[..., 18, 0, 20] = t772
    M_theta_out[..., 18, 1, 0] = t805
    M_theta_out[..., 18, 1, 1] = t774
    M_theta_out[..., 18, 1, 2] = t822
    M_theta_out[..., 18, 1, 12] = t776
    M_theta_out[..., 18, 1, 13] = t777
    M_theta_out[..., 18, 1, 14] = t778
    M_theta_out[..., 18, 1, 18] = t779
    M_theta_out[..., 18, 1, 19] = t780
    M_theta_out[..., 18, 1, 20] = t781
    M_theta_out[..., 18, 2, 0] = t821
    M_theta_out[..., 18, 2, 1] = t822
    M_theta_out[..., 18, 2, 2] = (
        D_p_x_3*t285 + D_p_x_3*t823 + D_p_y_3*t288 + D_p_y_3*t824 + D_p_z_3*t291 + D_p_z_3*t825 + 1/3
    )
    M_theta_out[..., 18, 2, 12] = t826
    M_theta_out[..., 18, 2, 13] = t827
    M_theta_out[..., 18, 2, 14] = t828
    M_theta_out[..., 18, 2, 18] = t829
    M_theta_out[..., 18, 2, 19] = t830
    M_theta_out[..., 18, 2, 20] = t831
    M_theta_out[..., 18, 12, 0] = t808
    M_theta_out[..., 18, 12, 1] = t776
    M_theta_out[..., 18, 12, 2] = t826
    M_theta_out[..., 18, 12, 12] = t789
    M_theta_out[..., 18, 12, 13] = t790
    M_theta_out[..., 18, 12, 14] = t791
    M_theta_out[..., 18, 12, 18] = t792
    M_theta_out[..., 18, 12, 19] = t793
    M_theta_out[..., 18, 12, 20] = t794
    M_theta_out[..., 18, 13, 0] = t809
    M_theta_out[..., 18, 13, 1] = t777
    M_theta_out[..., 18, 13, 2] = t827
    M_theta_out[..., 18, 13, 12] = t790
    M_theta_out[..., 18, 13, 13] = t795
    M_theta_out[..., 18, 13, 14] = t796
    M_theta_out[..., 18, 13, 18] = t797
    M_theta_out[..., 18, 13, 19] = t798
    M_theta_out[..., 18, 13, 20] = t799
    M_theta_out[..., 18, 14, 0] = t810
    M_theta_out[..., 18, 14, 1] = t778
    M_theta_out[..., 18, 14, 2] = t828
    M_theta_out[..., 18, 14, 12] = t791
    M_theta_out[..., 18, 14, 13] = t796
    M_theta_out[..., 18, 14, 14] = t800
    M_theta_out[..., 18, 14, 18] = t801
    M_theta_out[..., 18, 14, 19] = t802
    M_theta_out[..., 18, 14, 20] = t803
    M_theta_out[..., 18, 18, 0] = t768
    M_theta_out[..., 18, 18, 1] = t779
    M_theta_out[..., 18, 18, 2] = t829
    M_theta_out[..., 18, 18, 12] = t792
    M_theta_out[..., 18, 18, 13] = t797
    M_theta_out[..., 18, 18, 14] = t801
    M_theta_out[..., 18, 18, 18] = 1
    M_theta_out[..., 18, 19, 0] = t770
    M_theta_out[..., 18, 19, 1] = t780
    M_theta_out[..., 18, 19, 2] = t830
    M_theta_out[..., 18, 19, 12] = t793
    M_theta_out[..., 18, 19, 13] = t798
    M_theta_out[..., 18, 19, 14] = t802
    M_theta_out[..., 18, 19, 19] = 1
    M_theta_out[..., 18, 20, 0] = t772
    M_theta_out[..., 18, 20, 1] = t781
    M_theta_out[..., 18, 20, 2] = t831
    M_theta_out[..., 18, 20, 12] = t794
    M_theta_out[..., 18, 20, 13] = t799
    M_theta_out[..., 18, 20, 14] = t803
    M_theta_out[..., 18, 20, 20] = 1
    M_theta_out[..., 19, 0, 0] = 1
    M_theta_out[..., 19, 0, 18] = n_1_x
    M_theta_out[..., 19, 0, 19] = n_1_y
    M_theta_out[..., 19, 0, 20] = n_1_z
    M_theta_out[..., 19, 18, 0] = n_1_x
    M_theta_out[..., 19, 18, 18] = 1
    M_theta_out[..., 19, 19, 0] = n_1_y
    M_theta_out[..., 19, 19, 19] = 1
    M_theta_out[..., 19, 20, 0] = n_1_z
    M_theta_out[..., 19, 20, 20] = 1
    M_theta_out[..., 20, 1, 1] = 1
    M_theta_out[..., 20, 1, 18] = n_2_x
    M_theta_out[..., 20, 1, 19] = n_2_y
    M_theta_out[..., 20, 1, 20] = n_2_z
    M_theta_out[..., 20, 18, 1] = n_2_x
    M_theta_out[..., 20, 18, 18] = 1
    M_theta_out[..., 20, 19, 1] = n_2_y
    M_theta_out[..., 20, 19, 19] = 1
    M_theta_out[..., 20, 20, 1] = n_2_z
    M_theta_out[..., 20, 20, 20] = 1
    M_theta_out[..., 21, 2, 2] = 1
    M_theta_out[..., 21, 2, 18] = n_3_x
    M_theta_out[..., 21, 2, 19] = n_3_y
    M_theta_out[..., 21, 2, 20] = n_3_z
    M_theta_out[..., 21, 18, 2] = n_3_x
    M_theta_out[..., 21, 18, 18] = 1
    M_theta_out[..., 21, 19, 2] = n_3_y
    M_theta_out[..., 21, 19, 19] = 1
    M_theta_out[..., 21, 20, 2] = n_3_z
    M_theta_out[..., 21, 20, 20] = 1
    M_theta_out[..., 22, 0, 0] = -t333
    M_theta_out[..., 22, 0, 3] = t833
    M_theta_out[..., 22, 0, 6] = t833
    M_theta_out[..., 22, 0, 15] = -t333
    M_theta_out[..., 22, 3, 0] = t833
    M_theta_out[..., 22, 3, 3] = -t834
    M_theta_out[..., 22, 3, 15] = t833
    M_theta_out[..., 22, 6, 0] = t833
    M_theta_out[..., 22, 6, 6] = -t834
    M_theta_out[..., 22, 6, 15] = t833
    M_theta_out[..., 22, 15, 0] = -t333
    M_theta_out[..., 22, 15, 3] = t833
    M_theta_out[..., 22, 15, 6] = t833
    M_theta_out[..., 22, 15, 15] = -t333
    M_theta_out[..., 23, 1, 1] = -t333
    M_theta_out[..., 23, 1, 4] = t835
    M_theta_out[..., 23, 1, 7] = t835
    M_theta_out[..., 23, 1, 16] = -t333
    M_theta_out[..., 23, 4, 1] = t835
    M_theta_out[..., 23, 4, 4] = -t836
    M_theta_out[..., 23, 4, 16] = t835
    M_theta_out[..., 23, 7, 1] = t835
    M_theta_out[..., 23, 7, 7] = -t836
    M_theta_out[..., 23, 7, 16] = t835
    M_theta_out[..., 23, 16, 1] = -t333
    M_theta_out[..., 23, 16, 4] = t835
    M_theta_out[..., 23, 16, 7] = t835
    M_theta_out[..., 23, 16, 16] = -t333
    M_theta_out[..., 24, 2, 2] = -t333
    M_theta_out[..., 24, 2, 5] = t837
    M_theta_out[..., 24, 2, 8] = t837
    M_theta_out[..., 24, 2, 17] = -t333
    M_theta_out[..., 24, 5, 2] = t837
    M_theta_out[..., 24, 5, 5] = -t838
    M_theta_out[..., 24, 5, 17] = t837
    M_theta_out[..., 24, 8, 2] = t837
    M_theta_out[..., 24, 8, 8] = -t838
    M_theta_out[..., 24, 8, 17] = t837
    M_theta_out[..., 24, 17, 2] = -t333
    M_theta_out[..., 24, 17, 5] = t837
    M_theta_out[..., 24, 17, 8] = t837
    M_theta_out[..., 24, 17, 17] = -t333
    M_theta_out[..., 31, 0, 3] = t839
    M_theta_out[..., 31, 0, 6] = t840
    M_theta_out[..., 31, 3, 0] = t839
    M_theta_out[..., 31, 3, 3] = l_f_1_3*t842 + t843
    M_theta_out[..., 31, 3, 6] = t844
    M_theta_out[..., 31, 3, 15] = t839
    M_theta_out[..., 31, 6, 0] = t840
    M_theta_out[..., 31, 6, 3] = t844
    M_theta_out[..., 31, 6, 6] = l_f_1_2*t842 + t843
    M_theta_out[..., 31, 6, 15] = t840
    M_theta_out[..., 31, 15, 3] = t839
    M_theta_out[..., 31, 15, 6] = t840
    M_theta_out[..., 32, 1, 4] = t845
    M_theta_out[..., 32, 1, 7] = t846
    M_theta_out[..., 32, 4, 1] = t845
    M_theta_out[..., 32, 4, 4] = l_f_2_3*t847 + t848
    M_theta_out[..., 32, 4, 7] = t849
    M_theta_out[..., 32, 4, 16] = t845
    M_theta_out[..., 32, 7, 1] = t846
    M_theta_out[..., 32, 7, 4] = t849
    M_theta_out[..., 32, 7, 7] = l_f_2_2*t847 + t848
    M_theta_out[..., 32, 7, 16] = t846
    M_theta_out[..., 32, 16, 4] = t845
    M_theta_out[..., 32, 16, 7] = t846
    M_theta_out[..., 33, 2, 5] = t850
    M_theta_out[..., 33, 2, 8] = t851
    M_theta_out[..., 33, 5, 2] = t850
    M_theta_out[..., 33, 5, 5] = l_f_3_3*t852 + t853
    M_theta_out[..., 33, 5, 8] = t854
    M_theta_out[..., 33, 5, 17] = t850
    M_theta_out[..., 33, 8, 2] = t851
    M_theta_out[..., 33, 8, 5] = t854
    M_theta_out[..., 33, 8, 8] = l_f_3_2*t852 + t853
    M_theta_out[..., 33, 8, 17] = t851
    M_theta_out[..., 33, 17, 5] = t850
    M_theta_out[..., 33, 17, 8] = t851
    M_theta_out[..., 34, 3, 3] = 1
    M_theta_out[..., 34, 6, 6] = 1
    M_theta_out[..., 35, 4, 4] = 1
    M_theta_out[..., 35, 7, 7] = 1
    M_theta_out[..., 36, 5, 5] = 1
    M_theta_out[..., 36, 8, 8] = 1
    M_theta_out[..., 37, 3, 3] = t856
    M_theta_out[..., 37, 3, 9] = t856
    M_theta_out[..., 37, 6, 6] = t857
    M_theta_out[..., 37, 6, 9] = t857
    M_theta_out[..., 37, 9, 3] = t856
    M_theta_out[..., 37, 9, 6] = t857
    M_theta_out[..., 37, 9, 9] = t856 + t857
    M_theta_out[..., 38, 4, 4] = t859
    M_theta_out[..., 38, 4, 10] = t859
    M_theta_out[..., 38, 7, 7] = t860
    M_theta_out[..., 38, 7, 10] = t860
    M_theta_out[..., 38, 10, 4] = t859
    M_theta_out[..., 38, 10, 7] = t860
    M_theta_out[..., 38, 10, 10] = t859 + t860
    M_theta_out[..., 39, 5, 5] = t862
    M_theta_out[..., 39, 5, 11] = t862
    M_theta_out[..., 39, 8, 8] = t863
    M_theta_out[..., 39, 8, 11] = t863
    M_theta_out[..., 39, 11, 5] = t862
    M_theta_out[..., 39, 11, 8] = t863
    M_theta_out[..., 39, 11, 11] = t862 + t863
    M_theta_out[..., 40, 3, 3] = t865
    M_theta_out[..., 40, 3, 9] = t865
    M_theta_out[..., 40, 6, 6] = t866
    M_theta_out[..., 40, 6, 9] = t866
    M_theta_out[..., 40, 9, 3] = t865
    M_theta_out[..., 40, 9, 6] = t866
    M_theta_out[..., 40, 9, 9] = t865 + t866
    M_theta_out[..., 41, 4, 4] = t868
    M_theta_out[..., 41, 4, 10] = t868
    M_theta_out[..., 41, 7, 7] = t869
    M_theta_out[..., 41, 7, 10] = t869
    M_theta_out[..., 41, 10, 4] = t868
    M_theta_out[..., 41, 10, 7] = t869
    M_theta_out[..., 41, 10, 10] = t868 + t869
    M_theta_out[..., 42, 5, 5] = t871
    M_theta_out[..., 42, 5, 11] = t871
    M_theta_out[..., 42, 8, 8] = t872
    M_theta_out[..., 42, 8, 11] = t872
    M_theta_out[..., 42, 11, 5] = t871
    M_theta_out[..., 42, 11, 8] = t872
    M_theta_out[..., 42, 11, 11] = t871 + t872
    M_theta_out[..., 43, 0, 0] = -t333
    M_theta_out[..., 43, 0, 6] = -t296
    M_theta_out[..., 43, 0, 15] = -t333
    M_theta_out[..., 43, 3, 3] = -t334
    M_theta_out[..., 43, 3, 6] = -t834
    M_theta_out[..., 43, 6, 0] = -t296
    M_theta_out[..., 43, 6, 3] = -t834
    M_theta_out[..., 43, 6, 6] = -t873
    M_theta_out[..., 43, 6, 15] = -t296
    M_theta_out[..., 43, 15, 0] = -t333
    M_theta_out[..., 43, 15, 6] = -t296
    M_theta_out[..., 43, 15, 15] = -t333
    M_theta_out[..., 44, 1, 1] = -t333
    M_theta_out[..., 44, 1, 7] = -t448
    M_theta_out[..., 44, 1, 16] = -t333
    M_theta_out[..., 44, 4, 4] = -t463
    M_theta_out[..., 44, 4, 7] = -t836
    M_theta_out[..., 44, 7, 1] = -t448
    M_theta_out[..., 44, 7, 4] = -t836
    M_theta_out[..., 44, 7, 7] = -t874
    M_theta_out[..., 44, 7, 16] = -t448
    M_theta_out[..., 44, 16, 1] = -t333
    M_theta_out[..., 44, 16, 7] = -t448
    M_theta_out[..., 44, 16, 16] = -t333
    M_theta_out[..., 45, 2, 2] = -t333
    M_theta_out[..., 45, 2, 8] = -t562
    M_theta_out[..., 45, 2, 17] = -t333
    M_theta_out[..., 45, 5, 5] = -t571
    M_theta_out[..., 45, 5, 8] = -t838
    M_theta_out[..., 45, 8, 2] = -t562
    M_theta_out[..., 45, 8, 5] = -t838
    M_theta_out[..., 45, 8, 8] = -t875
    M_theta_out[..., 45, 8, 17] = -t562
    M_theta_out[..., 45, 17, 2] = -t333
    M_theta_out[..., 45, 17, 8] = -t562
    M_theta_out[..., 45, 17, 17] = -t333
    M_theta_out[..., 46, 0, 0] = t333
    M_theta_out[..., 46, 0, 3] = t296
    M_theta_out[..., 46, 0, 15] = t333
    M_theta_out[..., 46, 3, 0] = t296
    M_theta_out[..., 46, 3, 3] = t873
    M_theta_out[..., 46, 3, 6] = t834
    M_theta_out[..., 46, 3, 15] = t296
    M_theta_out[..., 46, 6, 3] = t834
    M_theta_out[..., 46, 6, 6] = t334
    M_theta_out[..., 46, 15, 0] = t333
    M_theta_out[..., 46, 15, 3] = t296
    M_theta_out[..., 46, 15, 15] = t333
    M_theta_out[..., 47, 1, 1] = t333
    M_theta_out[..., 47, 1, 4] = t448
    M_theta_out[..., 47, 1, 16] = t333
    M_theta_out[..., 47, 4, 1] = t448
    M_theta_out[..., 47, 4, 4] = t874
    M_theta_out[..., 47, 4, 7] = t836
    M_theta_out[..., 47, 4, 16] = t448
    M_theta_out[..., 47, 7, 4] = t836
    M_theta_out[..., 47, 7, 7] = t463
    M_theta_out[..., 47, 16, 1] = t333
    M_theta_out[..., 47, 16, 4] = t448
    M_theta_out[..., 47, 16, 16] = t333
    M_theta_out[..., 48, 2, 2] = t333
    M_theta_out[..., 48, 2, 5] = t562
    M_theta_out[..., 48, 2, 17] = t333
    M_theta_out[..., 48, 5, 2] = t562
    M_theta_out[..., 48, 5, 5] = t875
    M_theta_out[..., 48, 5, 8] = t838
    M_theta_out[..., 48, 5, 17] = t562
    M_theta_out[..., 48, 8, 5] = t838
    M_theta_out[..., 48, 8, 8] = t571
    M_theta_out[..., 48, 17, 2] = t333
    M_theta_out[..., 48, 17, 5] = t562
    M_theta_out[..., 48, 17, 17] = t333
    M_theta_out[..., 53, 0, 0] = t878
    M_theta_out[..., 53, 0, 3] = t880
    M_theta_out[..., 53, 0, 6] = t881
    M_theta_out[..., 53, 0, 15] = t878
    M_theta_out[..., 53, 1, 1] = t884
    M_theta_out[..., 53, 1, 4] = t886
    M_theta_out[..., 53, 1, 7] = t887
    M_theta_out[..., 53, 1, 16] = t884
    M_theta_out[..., 53, 2, 2] = t890
    M_theta_out[..., 53, 2, 5] = t892
    M_theta_out[..., 53, 2, 8] = t893
    M_theta_out[..., 53, 2, 17] = t890
    M_theta_out[..., 53, 3, 0] = t880
    M_theta_out[..., 53, 3, 3] = t332*t877 + t895
    M_theta_out[..., 53, 3, 6] = t896
    M_theta_out[..., 53, 3, 15] = t880
    M_theta_out[..., 53, 4, 1] = t886
    M_theta_out[..., 53, 4, 4] = t462*t883 + t898
    M_theta_out[..., 53, 4, 7] = t899
    M_theta_out[..., 53, 4, 16] = t886
    M_theta_out[..., 53, 5, 2] = t892
    M_theta_out[..., 53, 5, 5] = t570*t889 + t901
    M_theta_out[..., 53, 5, 8] = t902
    M_theta_out[..., 53, 5, 17] = t892
    M_theta_out[..., 53, 6, 0] = t881
    M_theta_out[..., 53, 6, 3] = t896
    M_theta_out[..., 53, 6, 6] = t332*t876 + t895
    M_theta_out[..., 53, 6, 15] = t881
    M_theta_out[..., 53, 7, 1] = t887
    M_theta_out[..., 53, 7, 4] = t899
    M_theta_out[..., 53, 7, 7] = t462*t882 + t898
    M_theta_out[..., 53, 7, 16] = t887
    M_theta_out[..., 53, 8, 2] = t893
    M_theta_out[..., 53, 8, 5] = t902
    M_theta_out[..., 53, 8, 8] = t570*t888 + t901
    M_theta_out[..., 53, 8, 17] = t893
    M_theta_out[..., 53, 15, 0] = t878
    M_theta_out[..., 53, 15, 3] = t880
    M_theta_out[..., 53, 15, 6] = t881
    M_theta_out[..., 53, 15, 15] = t878
    M_theta_out[..., 53, 16, 1] = t884
    M_theta_out[..., 53, 16, 4] = t886
    M_theta_out[..., 53, 16, 7] = t887
    M_theta_out[..., 53, 16, 16] = t884
    M_theta_out[..., 53, 17, 2] = t890
    M_theta_out[..., 53, 17, 5] = t892
    M_theta_out[..., 53, 17, 8] = t893
    M_theta_out[..., 53, 17, 17] = t890
    M_theta_out[..., 55, 3, 3] = d_1_1
    M_theta_out[..., 55, 4, 4] = d_2_1
    M_theta_out[..., 55, 5, 5] = d_3_1
    M_theta_out[..., 55, 6, 6] = d_1_2
    M_theta_out[..., 55, 7, 7] = d_2_2
    M_theta_out[..., 55, 8, 8] = d_3_2
    M_theta_out[..., 56, 0, 0] = t178
    M_theta_out[..., 56, 0, 1] = t182
    M_theta_out[..., 56, 0, 2] = t186
    M_theta_out[..., 56, 0, 12] = t190
    M_theta_out[..., 56, 0, 13] = t194
    M_theta_out[..., 56, 0, 14] = t198
    M_theta_out[..., 56, 0, 18] = D_p_x_1
    M_theta_out[..., 56, 0, 19] = D_p_y_1
    M_theta_out[..., 56, 0, 20] = D_p_z_1
    M_theta_out[..., 56, 1, 0] = t182
    M_theta_out[..., 56, 1, 1] = t202
    M_theta_out[..., 56, 1, 2] = t206
    M_theta_out[..., 56, 1, 12] = t210
    M_theta_out[..., 56, 1, 13] = t214
    M_theta_out[..., 56, 1, 14] = t218
    M_theta_out[..., 56, 1, 18] = D_p_x_2
    M_theta_out[..., 56, 1, 19] = D_p_y_2
    M_theta_out[..., 56, 1, 20] = D_p_z_2
    M_theta_out[..., 56, 2, 0] = t186
    M_theta_out[..., 56, 2, 1] = t206
    M_theta_out[..., 56, 2, 2] = t222
    M_theta_out[..., 56, 2, 12] = t226
    M_theta_out[..., 56, 2, 13] = t230
    M_theta_out[..., 56, 2, 14] = t234
    M_theta_out[..., 56, 2, 18] = D_p_x_3
    M_theta_out[..., 56, 2, 19] = D_p_y_3
    M_theta_out[..., 56, 2, 20] = D_p_z_3
    M_theta_out[..., 56, 12, 0] = t190
    M_theta_out[..., 56, 12, 1] = t210
    M_theta_out[..., 56, 12, 2] = t226
    M_theta_out[..., 56, 12, 12] = t238
    M_theta_out[..., 56, 12, 13] = t242
    M_theta_out[..., 56, 12, 14] = t246
    M_theta_out[..., 56, 12, 18] = D_delta_x_1
    M_theta_out[..., 56, 12, 19] = D_delta_y_1
    M_theta_out[..., 56, 12, 20] = D_delta_z_1
    M_theta_out[..., 56, 13, 0] = t194
    M_theta_out[..., 56, 13, 1] = t214
    M_theta_out[..., 56, 13, 2] = t230
    M_theta_out[..., 56, 13, 12] = t242
    M_theta_out[..., 56, 13, 13] = t250
    M_theta_out[..., 56, 13, 14] = t254
    M_theta_out[..., 56, 13, 18] = D_delta_x_2
    M_theta_out[..., 56, 13, 19] = D_delta_y_2
    M_theta_out[..., 56, 13, 20] = D_delta_z_2
    M_theta_out[..., 56, 14, 0] = t198
    M_theta_out[..., 56, 14, 1] = t218
    M_theta_out[..., 56, 14, 2] = t234
    M_theta_out[..., 56, 14, 12] = t246
    M_theta_out[..., 56, 14, 13] = t254
    M_theta_out[..., 56, 14, 14] = t258
    M_theta_out[..., 56, 14, 18] = D_delta_x_3
    M_theta_out[..., 56, 14, 19] = D_delta_y_3
    M_theta_out[..., 56, 14, 20] = D_delta_z_3
    M_theta_out[..., 56, 18, 0] = D_p_x_1
    M_theta_out[..., 56, 18, 1] = D_p_x_2
    M_theta_out[..., 56, 18, 2] = D_p_x_3
    M_theta_out[..., 56, 18, 12] = D_delta_x_1
    M_theta_out[..., 56, 18, 13] = D_delta_x_2
    M_theta_out[..., 56, 18, 14] = D_delta_x_3
    M_theta_out[..., 56, 18, 18] = 1
    M_theta_out[..., 56, 19, 0] = D_p_y_1
    M_theta_out[..., 56, 19, 1] = D_p_y_2
    M_theta_out[..., 56, 19, 2] = D_p_y_3
    M_theta_out[..., 56, 19, 12] = D_delta_y_1
    M_theta_out[..., 56, 19, 13] = D_delta_y_2
    M_theta_out[..., 56, 19, 14] = D_delta_y_3
    M_theta_out[..., 56, 19, 19] = 1
    M_theta_out[..., 56, 20, 0] = D_p_z_1
    M_theta_out[..., 56, 20, 1] = D_p_z_2
    M_theta_out[..., 56, 20, 2] = D_p_z_3
    M_theta_out[..., 56, 20, 12] = D_delta_z_1
    M_theta_out[..., 56, 20, 13] = D_delta_z_2
    M_theta_out[..., 56, 20, 14] = D_delta_z_3
    M_theta_out[..., 56, 20, 20] = 1
    M_theta_out[..., 58, 18, 18] = 1
    M_theta_out[..., 58, 19, 19] = 1
    M_theta_out[..., 58, 20, 20] = 1
    K_theta_out = np.zeros((*batch, 59, 21, 21), dtype)
    K_theta_out[..., 0, 0, 0] = mu_1_by_m_p*t903 + mu_2_by_m_p*t904 + mu_3_by_m_p*t905
    K_theta_out[..., 0, 0, 1] = t909
    K_theta_out[..., 0, 0, 2] = t913
    K_theta_out[..., 0, 0, 12] = t917
    K_theta_out[..., 0, 0, 13] = t921
    K_theta_out[..., 0, 0, 14] = t925
    K_theta_out[..., 0, 1, 0] = t909
    K_theta_out[..., 0, 1, 1] = mu_1_by_m_p*t926 + mu_2_by_m_p*t927 + mu_3_by_m_p*t928
    K_theta_out[..., 0, 1, 2] = t932
    K_theta_out[..., 0, 1, 12] = t936
    K_theta_out[..., 0, 1, 13] = t940
    K_theta_out[..., 0, 1, 14] = t944
    K_theta_out[..., 0, 2, 0] = t913
    K_theta_out[..., 0, 2, 1] = t932
    K_theta_out[..., 0, 2, 2] = mu_1_by_m_p*t945 + mu_2_by_m_p*t946 + mu_3_by_m_p*t947
    K_theta_out[..., 0, 2, 12] = t951
    K_theta_out[..., 0, 2, 13] = t955
    K_theta_out[..., 0, 2, 14] = t959
    K_theta_out[..., 0, 12, 0] = t917
    K_theta_out[..., 0, 12, 1] = t936
    K_theta_out[..., 0, 12, 2] = t951
    K_theta_out[..., 0, 12, 12] = mu_1_by_m_p*t960 - mu_2_by_m_p*t238 - mu_3_by_m_p*t238
    K_theta_out[..., 0, 12, 13] = t961
    K_theta_out[..., 0, 12, 14] = t962
    K_theta_out[..., 0, 13, 0] = t921
    K_theta_out[..., 0, 13, 1] = t940
    K_theta_out[..., 0, 13, 2] = t955
    K_theta_out[..., 0, 13, 12] = t961
    K_theta_out[..., 0, 13, 13] = -mu_1_by_m_p*t250 + mu_2_by_m_p*t963 - mu_3_by_m_p*t250
    K_theta_out[..., 0, 13, 14] = t964
    K_theta_out[..., 0, 14, 0] = t925
    K_theta_out[..., 0, 14, 1] = t944
    K_theta_out[..., 0, 14, 2] = t959
    K_theta_out[..., 0, 14, 12] = t962
    K_theta_out[..., 0, 14, 13] = t964
    K_theta_out[..., 0, 14, 14] = -mu_1_by_m_p*t258 - mu_2_by_m_p*t258 + mu_3_by_m_p*t965
    K_theta_out[..., 1, 0, 0] = mu_1_by_g_x*t903 + mu_2_by_g_x*t904 + mu_3_by_g_x*t905
    K_theta_out[..., 1, 0, 1] = t966
    K_theta_out[..., 1, 0, 2] = t967
    K_theta_out[..., 1, 0, 12] = t968
    K_theta_out[..., 1, 0, 13] = t969
    K_theta_out[..., 1, 0, 14] = t970
    K_theta_out[..., 1, 1, 0] = t966
    K_theta_out[..., 1, 1, 1] = mu_1_by_g_x*t926 + mu_2_by_g_x*t927 + mu_3_by_g_x*t928
    K_theta_out[..., 1, 1, 2] = t971
    K_theta_out[..., 1, 1, 12] = t972
    K_theta_out[..., 1, 1, 13] = t973
    K_theta_out[..., 1, 1, 14] = t974
    K_theta_out[..., 1, 2, 0] = t967
    K_theta_out[..., 1, 2, 1] = t971
    K_theta_out[..., 1, 2, 2] = mu_1_by_g_x*t945 + mu_2_by_g_x*t946 + mu_3_by_g_x*t947
    K_theta_out[..., 1, 2, 12] = t975
    K_theta_out[..., 1, 2, 13] = t976
    K_theta_out[..., 1, 2, 14] = t977
    K_theta_out[..., 1, 12, 0] = t968
    K_theta_out[..., 1, 12, 1] = t972
    K_theta_out[..., 1, 12, 2] = t975
    K_theta_out[..., 1, 12, 12] = mu_1_by_g_x*t960 - mu_2_by_g_x*t238 - mu_3_by_g_x*t238
    K_theta_out[..., 1, 12, 13] = t978
    K_theta_out[..., 1, 12, 14] = t979
    K_theta_out[..., 1, 13, 0] = t969
    K_theta_out[..., 1, 13, 1] = t973
    K_theta_out[..., 1, 13, 2] = t976
    K_theta_out[..., 1, 13, 12] = t978
    K_theta_out[..., 1, 13, 13] = -mu_1_by_g_x*t250 + mu_2_by_g_x*t963 - mu_3_by_g_x*t250
    K_theta_out[..., 1, 13, 14] = t980
    K_theta_out[..., 1, 14, 0] = t970
    K_theta_out[..., 1, 14, 1] = t974
    K_theta_out[..., 1, 14, 2] = t977
    K_theta_out[..., 1, 14, 12] = t979
    K_theta_out[..., 1, 14, 13] = t980
    K_theta_out[..., 1, 14, 14] = -mu_1_by_g_x*t258 - mu_2_by_g_x*t258 + mu_3_by_g_x*t965
    K_theta_out[..., 2, 0, 0] = mu_1_by_g_y*t903 + mu_2_by_g_y*t904 + mu_3_by_g_y*t905
    K_theta_out[..., 2, 0, 1] = t981
    K_theta_out[..., 2, 0, 2] = t982
    K_theta_out[..., 2, 0, 12] = t983
    K_theta_out[..., 2, 0, 13] = t984
    K_theta_out[..., 2, 0, 14] = t985
    K_theta_out[..., 2, 1, 0] = t981
    K_theta_out[..., 2, 1, 1] = mu_1_by_g_y*t926 + mu_2_by_g_y*t927 + mu_3_by_g_y*t928
    K_theta_out[..., 2, 1, 2] = t986
    K_theta_out[..., 2, 1, 12] = t987
    K_theta_out[..., 2, 1, 13] = t988
    K_theta_out[..., 2, 1, 14] = t989
    K_theta_out[..., 2, 2, 0] = t982
    K_theta_out[..., 2, 2, 1] = t986
    K_theta_out[..., 2, 2, 2] = mu_1_by_g_y*t945 + mu_2_by_g_y*t946 + mu_3_by_g_y*t947
    K_theta_out[..., 2, 2, 12] = t990
    K_theta_out[..., 2, 2, 13] = t991
    K_theta_out[..., 2, 2, 14] = t992
    K_theta_out[..., 2, 12, 0] = t983
    K_theta_out[..., 2, 12, 1] = t987
    K_theta_out[..., 2, 12, 2] = t990
    K_theta_out[..., 2, 12, 12] = mu_1_by_g_y*t960 - mu_2_by_g_y*t238 - mu_3_by_g_y*t238
    K_theta_out[..., 2, 12, 13] = t993
    K_theta_out[..., 2, 12, 14] = t994
    K_theta_out[..., 2, 13, 0] = t984
    K_theta_out[..., 2, 13, 1] = t988
    K_theta_out[..., 2, 13, 2] = t991
    K_theta_out[..., 2, 13, 12] = t993
    K_theta_out[..., 2, 13, 13] = -mu_1_by_g_y*t250 + mu_2_by_g_y*t963 - mu_3_by_g_y*t250
    K_theta_out[..., 2, 13, 14] = t995
    K_theta_out[..., 2, 14, 0] = t985
    K_theta_out[..., 2, 14, 1] = t989
    K_theta_out[..., 2, 14, 2] = t992
    K_theta_out[..., 2, 14, 12] = t994
    K_theta_out[..., 2, 14, 13] = t995
    K_theta_out[..., 2, 14, 14] = -mu_1_by_g_y*t258 - mu_2_by_g_y*t258 + mu_3_by_g_y*t965
    K_theta_out[..., 3, 0, 0] = mu_1_by_g_z*t903 + mu_2_by_g_z*t904 + mu_3_by_g_z*t905
    K_theta_out[..., 3, 0, 1] = t996
    K_theta_out[..., 3, 0, 2] = t997
    K_theta_out[..., 3, 0, 12] = t998
    K_theta_out[..., 3, 0, 13] = t999
    K_theta_out[..., 3, 0, 14] = t1000
    K_theta_out[..., 3, 1, 0] = t996
    K_theta_out[..., 3, 1, 1] = mu_1_by_g_z*t926 + mu_2_by_g_z*t927 + mu_3_by_g_z*t928
    K_theta_out[..., 3, 1, 2] = t1001
    K_theta_out[..., 3, 1, 12] = t1002
    K_theta_out[..., 3, 1, 13] = t1003
    K_theta_out[..., 3, 1, 14] = t1004
    K_theta_out[..., 3, 2, 0] = t997
    K_theta_out[..., 3, 2, 1] = t1001
    K_theta_out[..., 3, 2, 2] = mu_1_by_g_z*t945 + mu_2_by_g_z*t946 + mu_3_by_g_z*t947
    K_theta_out[..., 3, 2, 12] = t1005
    K_theta_out[..., 3, 2, 13] = t1006
    K_theta_out[..., 3, 2, 14] = t1007
    K_theta_out[..., 3, 12, 0] = t998
    K_theta_out[..., 3, 12, 1] = t1002
    K_theta_out[..., 3, 12, 2] = t1005
    K_theta_out[..., 3, 12, 12] = mu_1_by_g_z*t960 - mu_2_by_g_z*t238 - mu_3_by_g_z*t238
    K_theta_out[..., 3, 12, 13] = t1008
    K_theta_out[..., 3, 12, 14] = t1009
    K_theta_out[..., 3, 13, 0] = t999
    K_theta_out[..., 3, 13, 1] = t1003
    K_theta_out[..., 3, 13, 2] = t1006
    K_theta_out[..., 3, 13, 12] = t1008
    K_theta_out[..., 3, 13, 13] = -mu_1_by_g_z*t250 + mu_2_by_g_z*t963 - mu_3_by_g_z*t250
    K_theta_out[..., 3, 13, 14] = t1010
    K_theta_out[..., 3, 14, 0] = t1000
    K_theta_out[..., 3, 14, 1] = t1004
    K_theta_out[..., 3, 14, 2] = t1007
    K_theta_out[..., 3, 14, 12] = t1009
    K_theta_out[..., 3, 14, 13] = t1010
    K_theta_out[..., 3, 14, 14] = -mu_1_by_g_z*t258 - mu_2_by_g_z*t258 + mu_3_by_g_z*t965
    K_theta_out[..., 4, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_1_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_x*k_C
        + k_sp_1*t1026*t11*w_b_1*x_1_by_b_1_x + mu_1_by_b_1_x*t903 + mu_2_by_b_1_x*t904 + mu_3_by_b_1_x*t905
        - t1011*t1012 - t1012*t1013 - t1012*t1014 - t1015*t1016 - t1016*t1017 - t1016*t1018 - t1019*t1020
        - t1020*t1021 - t1020*t1022 - t1025
    )
    K_theta_out[..., 4, 0, 1] = t1036
    K_theta_out[..., 4, 0, 2] = t1046
    K_theta_out[..., 4, 0, 3] = t1049
    K_theta_out[..., 4, 0, 6] = t1050
    K_theta_out[..., 4, 0, 12] = t1066
    K_theta_out[..., 4, 0, 13] = t1076
    K_theta_out[..., 4, 0, 14] = t1086
    K_theta_out[..., 4, 0, 15] = t1087
    K_theta_out[..., 4, 0, 18] = t1051
    K_theta_out[..., 4, 0, 19] = t1052
    K_theta_out[..., 4, 0, 20] = t1053
    K_theta_out[..., 4, 1, 0] = t1036
    K_theta_out[..., 4, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_1_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_x*k_C
        + mu_1_by_b_1_x*t926 + mu_2_by_b_1_x*t927 + mu_3_by_b_1_x*t928 - t1027*t1088 - t1028*t1088
        - t1029*t1088 - t1030*t1089 - t1031*t1089 - t1032*t1089 - t1033*t1090 - t1034*t1090 - t1035*t1090
    )
    K_theta_out[..., 4, 1, 2] = t1091
    K_theta_out[..., 4, 1, 12] = t1098
    K_theta_out[..., 4, 1, 13] = t1099
    K_theta_out[..., 4, 1, 14] = t1100
    K_theta_out[..., 4, 1, 18] = t1092
    K_theta_out[..., 4, 1, 19] = t1093
    K_theta_out[..., 4, 1, 20] = t1094
    K_theta_out[..., 4, 2, 0] = t1046
    K_theta_out[..., 4, 2, 1] = t1091
    K_theta_out[..., 4, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_1_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_x*k_C
        + mu_1_by_b_1_x*t945 + mu_2_by_b_1_x*t946 + mu_3_by_b_1_x*t947 - t1037*t1101 - t1038*t1101
        - t1039*t1101 - t1040*t1102 - t1041*t1102 - t1042*t1102 - t1043*t1103 - t1044*t1103 - t1045*t1103
    )
    K_theta_out[..., 4, 2, 12] = t1110
    K_theta_out[..., 4, 2, 13] = t1111
    K_theta_out[..., 4, 2, 14] = t1112
    K_theta_out[..., 4, 2, 18] = t1104
    K_theta_out[..., 4, 2, 19] = t1105
    K_theta_out[..., 4, 2, 20] = t1106
    K_theta_out[..., 4, 3, 0] = t1049
    K_theta_out[..., 4, 3, 3] = t1048*t332
    K_theta_out[..., 4, 3, 15] = t1049
    K_theta_out[..., 4, 6, 0] = t1050
    K_theta_out[..., 4, 6, 6] = -t1025*t332
    K_theta_out[..., 4, 6, 15] = t1050
    K_theta_out[..., 4, 12, 0] = t1066
    K_theta_out[..., 4, 12, 1] = t1098
    K_theta_out[..., 4, 12, 2] = t1110
    K_theta_out[..., 4, 12, 12] = (
        D_delta_x_1_by_b_1_x*t1113 + D_delta_y_1_by_b_1_x*t1114 + D_delta_z_1_by_b_1_x*t1115
        + mu_1_by_b_1_x*t960 - mu_2_by_b_1_x*t238 - mu_3_by_b_1_x*t238
    )
    K_theta_out[..., 4, 12, 13] = t1122
    K_theta_out[..., 4, 12, 14] = t1126
    K_theta_out[..., 4, 12, 18] = t1127
    K_theta_out[..., 4, 12, 19] = t1128
    K_theta_out[..., 4, 12, 20] = t1129
    K_theta_out[..., 4, 13, 0] = t1076
    K_theta_out[..., 4, 13, 1] = t1099
    K_theta_out[..., 4, 13, 2] = t1111
    K_theta_out[..., 4, 13, 12] = t1122
    K_theta_out[..., 4, 13, 13] = (
        D_delta_x_2_by_b_1_x*t1130 + D_delta_y_2_by_b_1_x*t1131 + D_delta_z_2_by_b_1_x*t1132
        - mu_1_by_b_1_x*t250 + mu_2_by_b_1_x*t963 - mu_3_by_b_1_x*t250
    )
    K_theta_out[..., 4, 13, 14] = t1133
    K_theta_out[..., 4, 13, 18] = t1134
    K_theta_out[..., 4, 13, 19] = t1135
    K_theta_out[..., 4, 13, 20] = t1136
    K_theta_out[..., 4, 14, 0] = t1086
    K_theta_out[..., 4, 14, 1] = t1100
    K_theta_out[..., 4, 14, 2] = t1112
    K_theta_out[..., 4, 14, 12] = t1126
    K_theta_out[..., 4, 14, 13] = t1133
    K_theta_out[..., 4, 14, 14] = (
        D_delta_x_3_by_b_1_x*t1137 + D_delta_y_3_by_b_1_x*t1138 + D_delta_z_3_by_b_1_x*t1139
        - mu_1_by_b_1_x*t258 - mu_2_by_b_1_x*t258 + mu_3_by_b_1_x*t965
    )
    K_theta_out[..., 4, 14, 18] = t1140
    K_theta_out[..., 4, 14, 19] = t1141
    K_theta_out[..., 4, 14, 20] = t1142
    K_theta_out[..., 4, 15, 0] = t1087
    K_theta_out[..., 4, 15, 3] = t1049
    K_theta_out[..., 4, 15, 6] = t1050
    K_theta_out[..., 4, 15, 15] = t1087
    K_theta_out[..., 4, 18, 0] = t1051
    K_theta_out[..., 4, 18, 1] = t1092
    K_theta_out[..., 4, 18, 2] = t1104
    K_theta_out[..., 4, 18, 12] = t1127
    K_theta_out[..., 4, 18, 13] = t1134
    K_theta_out[..., 4, 18, 14] = t1140
    K_theta_out[..., 4, 19, 0] = t1052
    K_theta_out[..., 4, 19, 1] = t1093
    K_theta_out[..., 4, 19, 2] = t1105
    K_theta_out[..., 4, 19, 12] = t1128
    K_theta_out[..., 4, 19, 13] = t1135
    K_theta_out[..., 4, 19, 14] = t1141
    K_theta_out[..., 4, 20, 0] = t1053
    K_theta_out[..., 4, 20, 1] = t1094
    K_theta_out[..., 4, 20, 2] = t1106
    K_theta_out[..., 4, 20, 12] = t1129
    K_theta_out[..., 4, 20, 13] = t1136
    K_theta_out[..., 4, 20, 14] = t1142
    K_theta_out[..., 5, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_1_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_y*k_C
        + k_sp_1*t1026*t11*w_b_1*x_1_by_b_1_y + mu_1_by_b_1_y*t903 + mu_2_by_b_1_y*t904 + mu_3_by_b_1_y*t905
        - t1011*t1143 - t1013*t1143 - t1014*t1143 - t1015*t1144 - t1017*t1144 - t1018*t1144 - t1019*t1145
        - t1021*t1145 - t1022*t1145 - t1146
    )
    K_theta_out[..., 5, 0, 1] = t1147
    K_theta_out[..., 5, 0, 2] = t1148
    K_theta_out[..., 5, 0, 3] = t1150
    K_theta_out[..., 5, 0, 6] = t1151
    K_theta_out[..., 5, 0, 12] = t1155
    K_theta_out[..., 5, 0, 13] = t1159
    K_theta_out[..., 5, 0, 14] = t1163
    K_theta_out[..., 5, 0, 15] = t1164
    K_theta_out[..., 5, 0, 18] = t1165
    K_theta_out[..., 5, 0, 19] = t1166
    K_theta_out[..., 5, 0, 20] = t1167
    K_theta_out[..., 5, 1, 0] = t1147
    K_theta_out[..., 5, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_1_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_y*k_C
        + mu_1_by_b_1_y*t926 + mu_2_by_b_1_y*t927 + mu_3_by_b_1_y*t928 - t1027*t1168 - t1028*t1168
        - t1029*t1168 - t1030*t1169 - t1031*t1169 - t1032*t1169 - t1033*t1170 - t1034*t1170 - t1035*t1170
    )
    K_theta_out[..., 5, 1, 2] = t1171
    K_theta_out[..., 5, 1, 12] = t1172
    K_theta_out[..., 5, 1, 13] = t1173
    K_theta_out[..., 5, 1, 14] = t1174
    K_theta_out[..., 5, 1, 18] = t1175
    K_theta_out[..., 5, 1, 19] = t1176
    K_theta_out[..., 5, 1, 20] = t1177
    K_theta_out[..., 5, 2, 0] = t1148
    K_theta_out[..., 5, 2, 1] = t1171
    K_theta_out[..., 5, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_1_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_y*k_C
        + mu_1_by_b_1_y*t945 + mu_2_by_b_1_y*t946 + mu_3_by_b_1_y*t947 - t1037*t1178 - t1038*t1178
        - t1039*t1178 - t1040*t1179 - t1041*t1179 - t1042*t1179 - t1043*t1180 - t1044*t1180 - t1045*t1180
    )
    K_theta_out[..., 5, 2, 12] = t1181
    K_theta_out[..., 5, 2, 13] = t1182
    K_theta_out[..., 5, 2, 14] = t1183
    K_theta_out[..., 5, 2, 18] = t1184
    K_theta_out[..., 5, 2, 19] = t1185
    K_theta_out[..., 5, 2, 20] = t1186
    K_theta_out[..., 5, 3, 0] = t1150
    K_theta_out[..., 5, 3, 3] = t1149*t332
    K_theta_out[..., 5, 3, 15] = t1150
    K_theta_out[..., 5, 6, 0] = t1151
    K_theta_out[..., 5, 6, 6] = -t1146*t332
    K_theta_out[..., 5, 6, 15] = t1151
    K_theta_out[..., 5, 12, 0] = t1155
    K_theta_out[..., 5, 12, 1] = t1172
    K_theta_out[..., 5, 12, 2] = t1181
    K_theta_out[..., 5, 12, 12] = (
        D_delta_x_1_by_b_1_y*t1113 + D_delta_y_1_by_b_1_y*t1114 + D_delta_z_1_by_b_1_y*t1115
        + mu_1_by_b_1_y*t960 - mu_2_by_b_1_y*t238 - mu_3_by_b_1_y*t238
    )
    K_theta_out[..., 5, 12, 13] = t1187
    K_theta_out[..., 5, 12, 14] = t1188
    K_theta_out[..., 5, 12, 18] = t1189
    K_theta_out[..., 5, 12, 19] = t1190
    K_theta_out[..., 5, 12, 20] = t1191
    K_theta_out[..., 5, 13, 0] = t1159
    K_theta_out[..., 5, 13, 1] = t1173
    K_theta_out[..., 5, 13, 2] = t1182
    K_theta_out[..., 5, 13, 12] = t1187
    K_theta_out[..., 5, 13, 13] = (
        D_delta_x_2_by_b_1_y*t1130 + D_delta_y_2_by_b_1_y*t1131 + D_delta_z_2_by_b_1_y*t1132
        - mu_1_by_b_1_y*t250 + mu_2_by_b_1_y*t963 - mu_3_by_b_1_y*t250
    )
    K_theta_out[..., 5, 13, 14] = t1192
    K_theta_out[..., 5, 13, 18] = t1193
    K_theta_out[..., 5, 13, 19] = t1194
    K_theta_out[..., 5, 13, 20] = t1195
    K_theta_out[..., 5, 14, 0] = t1163
    K_theta_out[..., 5, 14, 1] = t1174
    K_theta_out[..., 5, 14, 2] = t1183
    K_theta_out[..., 5, 14, 12] = t1188
    K_theta_out[..., 5, 14, 13] = t1192
    K_theta_out[..., 5, 14, 14] = (
        D_delta_x_3_by_b_1_y*t1137 + D_delta_y_3_by_b_1_y*t1138 + D_delta_z_3_by_b_1_y*t1139
        - mu_1_by_b_1_y*t258 - mu_2_by_b_1_y*t258 + mu_3_by_b_1_y*t965
    )
    K_theta_out[..., 5, 14, 18] = t1196
    K_theta_out[..., 5, 14, 19] = t1197
    K_theta_out[..., 5, 14, 20] = t1198
    K_theta_out[..., 5, 15, 0] = t1164
    K_theta_out[..., 5, 15, 3] = t1150
    K_theta_out[..., 5, 15, 6] = t1151
    K_theta_out[..., 5, 15, 15] = t1164
    K_theta_out[..., 5, 18, 0] = t1165
    K_theta_out[..., 5, 18, 1] = t1175
    K_theta_out[..., 5, 18, 2] = t1184
    K_theta_out[..., 5, 18, 12] = t1189
    K_theta_out[..., 5, 18, 13] = t1193
    K_theta_out[..., 5, 18, 14] = t1196
    K_theta_out[..., 5, 19, 0] = t1166
    K_theta_out[..., 5, 19, 1] = t1176
    K_theta_out[..., 5, 19, 2] = t1185
    K_theta_out[..., 5, 19, 12] = t1190
    K_theta_out[..., 5, 19, 13] = t1194
    K_theta_out[..., 5, 19, 14] = t1197
    K_theta_out[..., 5, 20, 0] = t1167
    K_theta_out[..., 5, 20, 1] = t1177
    K_theta_out[..., 5, 20, 2] = t1186
    K_theta_out[..., 5, 20, 12] = t1191
    K_theta_out[..., 5, 20, 13] = t1195
    K_theta_out[..., 5, 20, 14] = t1198
    K_theta_out[..., 6, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_1_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_1_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_1_z*k_C
        + k_sp_1*t1026*t11*w_b_1*x_1_by_b_1_z + mu_1_by_b_1_z*t903 + mu_2_by_b_1_z*t904 + mu_3_by_b_1_z*t905
        - t1011*t1199 - t1013*t1199 - t1014*t1199 - t1015*t1200 - t1017*t1200 - t1018*t1200 - t1019*t1201
        - t1021*t1201 - t1022*t1201 - t1202
    )
    K_theta_out[..., 6, 0, 1] = t1203
    K_theta_out[..., 6, 0, 2] = t1204
    K_theta_out[..., 6, 0, 3] = t1206
    K_theta_out[..., 6, 0, 6] = t1207
    K_theta_out[..., 6, 0, 12] = t1208
    K_theta_out[..., 6, 0, 13] = t1209
    K_theta_out[..., 6, 0, 14] = t1210
    K_theta_out[..., 6, 0, 15] = t1211
    K_theta_out[..., 6, 0, 18] = t1212
    K_theta_out[..., 6, 0, 19] = t1213
    K_theta_out[..., 6, 0, 20] = t1214
    K_theta_out[..., 6, 1, 0] = t1203
    K_theta_out[..., 6, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_1_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_1_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_1_z*k_C
        + mu_1_by_b_1_z*t926 + mu_2_by_b_1_z*t927 + mu_3_by_b_1_z*t928 - t1027*t1215 - t1028*t1215
        - t1029*t1215 - t1030*t1216 - t1031*t1216 - t1032*t1216 - t1033*t1217 - t1034*t1217 - t1035*t1217
    )
    K_theta_out[..., 6, 1, 2] = t1218
    K_theta_out[..., 6, 1, 12] = t1219
    K_theta_out[..., 6, 1, 13] = t1220
    K_theta_out[..., 6, 1, 14] = t1221
    K_theta_out[..., 6, 1, 18] = t1222
    K_theta_out[..., 6, 1, 19] = t1223
    K_theta_out[..., 6, 1, 20] = t1224
    K_theta_out[..., 6, 2, 0] = t1204
    K_theta_out[..., 6, 2, 1] = t1218
    K_theta_out[..., 6, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_1_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_1_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_1_z*k_C
        + mu_1_by_b_1_z*t945 + mu_2_by_b_1_z*t946 + mu_3_by_b_1_z*t947 - t1037*t1225 - t1038*t1225
        - t1039*t1225 - t1040*t1226 - t1041*t1226 - t1042*t1226 - t1043*t1227 - t1044*t1227 - t1045*t1227
    )
    K_theta_out[..., 6, 2, 12] = t1228
    K_theta_out[..., 6, 2, 13] = t1229
    K_theta_out[..., 6, 2, 14] = t1230
    K_theta_out[..., 6, 2, 18] = t1231
    K_theta_out[..., 6, 2, 19] = t1232
    K_theta_out[..., 6, 2, 20] = t1233
    K_theta_out[..., 6, 3, 0] = t1206
    K_theta_out[..., 6, 3, 3] = t1205*t332
    K_theta_out[..., 6, 3, 15] = t1206
    K_theta_out[..., 6, 6, 0] = t1207
    K_theta_out[..., 6, 6, 6] = -t1202*t332
    K_theta_out[..., 6, 6, 15] = t1207
    K_theta_out[..., 6, 12, 0] = t1208
    K_theta_out[..., 6, 12, 1] = t1219
    K_theta_out[..., 6, 12, 2] = t1228
    K_theta_out[..., 6, 12, 12] = (
        D_delta_x_1_by_b_1_z*t1113 + D_delta_y_1_by_b_1_z*t1114 + D_delta_z_1_by_b_1_z*t1115
        + mu_1_by_b_1_z*t960 - mu_2_by_b_1_z*t238 - mu_3_by_b_1_z*t238
    )
    K_theta_out[..., 6, 12, 13] = t1234
    K_theta_out[..., 6, 12, 14] = t1235
    K_theta_out[..., 6, 12, 18] = t1236
    K_theta_out[..., 6, 12, 19] = t1237
    K_theta_out[..., 6, 12, 20] = t1238
    K_theta_out[..., 6, 13, 0] = t1209
    K_theta_out[..., 6, 13, 1] = t1220
    K_theta_out[..., 6, 13, 2] = t1229
    K_theta_out[..., 6, 13, 12] = t1234
    K_theta_out[..., 6, 13, 13] = (
        D_delta_x_2_by_b_1_z*t1130 + D_delta_y_2_by_b_1_z*t1131 + D_delta_z_2_by_b_1_z*t1132
        - mu_1_by_b_1_z*t250 + mu_2_by_b_1_z*t963 - mu_3_by_b_1_z*t250
    )
    K_theta_out[..., 6, 13, 14] = t1239
    K_theta_out[..., 6, 13, 18] = t1240
    K_theta_out[..., 6, 13, 19] = t1241
    K_theta_out[..., 6, 13, 20] = t1242
    K_theta_out[..., 6, 14, 0] = t1210
    K_theta_out[..., 6, 14, 1] = t1221
    K_theta_out[..., 6, 14, 2] = t1230
    K_theta_out[..., 6, 14, 12] = t1235
    K_theta_out[..., 6, 14, 13] = t1239
    K_theta_out[..., 6, 14, 14] = (
        D_delta_x_3_by_b_1_z*t1137 + D_delta_y_3_by_b_1_z*t1138 + D_delta_z_3_by_b_1_z*t1139
        - mu_1_by_b_1_z*t258 - mu_2_by_b_1_z*t258 + mu_3_by_b_1_z*t965
    )
    K_theta_out[..., 6, 14, 18] = t1243
    K_theta_out[..., 6, 14, 19] = t1244
    K_theta_out[..., 6, 14, 20] = t1245
    K_theta_out[..., 6, 15, 0] = t1211
    K_theta_out[..., 6, 15, 3] = t1206
    K_theta_out[..., 6, 15, 6] = t1207
    K_theta_out[..., 6, 15, 15] = t1211
    K_theta_out[..., 6, 18, 0] = t1212
    K_theta_out[..., 6, 18, 1] = t1222
    K_theta_out[..., 6, 18, 2] = t1231
    K_theta_out[..., 6, 18, 12] = t1236
    K_theta_out[..., 6, 18, 13] = t1240
    K_theta_out[..., 6, 18, 14] = t1243
    K_theta_out[..., 6, 19, 0] = t1213
    K_theta_out[..., 6, 19, 1] = t1223
    K_theta_out[..., 6, 19, 2] = t1232
    K_theta_out[..., 6, 19, 12] = t1237
    K_theta_out[..., 6, 19, 13] = t1241
    K_theta_out[..., 6, 19, 14] = t1244
    K_theta_out[..., 6, 20, 0] = t1214
    K_theta_out[..., 6, 20, 1] = t1224
    K_theta_out[..., 6, 20, 2] = t1233
    K_theta_out[..., 6, 20, 12] = t1238
    K_theta_out[..., 6, 20, 13] = t1242
    K_theta_out[..., 6, 20, 14] = t1245
    K_theta_out[..., 7, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_2_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_x*k_C
        + mu_1_by_b_2_x*t903 + mu_2_by_b_2_x*t904 + mu_3_by_b_2_x*t905 - t1011*t1246 - t1013*t1246
        - t1014*t1246 - t1015*t1247 - t1017*t1247 - t1018*t1247 - t1019*t1248 - t1021*t1248 - t1022*t1248
    )
    K_theta_out[..., 7, 0, 1] = t1249
    K_theta_out[..., 7, 0, 2] = t1250
    K_theta_out[..., 7, 0, 12] = t1251
    K_theta_out[..., 7, 0, 13] = t1252
    K_theta_out[..., 7, 0, 14] = t1253
    K_theta_out[..., 7, 0, 18] = t1254
    K_theta_out[..., 7, 0, 19] = t1255
    K_theta_out[..., 7, 0, 20] = t1256
    K_theta_out[..., 7, 1, 0] = t1249
    K_theta_out[..., 7, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_2_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_x*k_C
        + k_sp_2*t1263*t22*w_b_2*x_2_by_b_2_x + mu_1_by_b_2_x*t926 + mu_2_by_b_2_x*t927 + mu_3_by_b_2_x*t928
        - t1027*t1257 - t1028*t1257 - t1029*t1257 - t1030*t1258 - t1031*t1258 - t1032*t1258 - t1033*t1259
        - t1034*t1259 - t1035*t1259 - t1262
    )
    K_theta_out[..., 7, 1, 2] = t1264
    K_theta_out[..., 7, 1, 4] = t1267
    K_theta_out[..., 7, 1, 7] = t1268
    K_theta_out[..., 7, 1, 12] = t1269
    K_theta_out[..., 7, 1, 13] = t1270
    K_theta_out[..., 7, 1, 14] = t1271
    K_theta_out[..., 7, 1, 16] = t1272
    K_theta_out[..., 7, 1, 18] = t1273
    K_theta_out[..., 7, 1, 19] = t1274
    K_theta_out[..., 7, 1, 20] = t1275
    K_theta_out[..., 7, 2, 0] = t1250
    K_theta_out[..., 7, 2, 1] = t1264
    K_theta_out[..., 7, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_2_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_x*k_C
        + mu_1_by_b_2_x*t945 + mu_2_by_b_2_x*t946 + mu_3_by_b_2_x*t947 - t1037*t1276 - t1038*t1276
        - t1039*t1276 - t1040*t1277 - t1041*t1277 - t1042*t1277 - t1043*t1278 - t1044*t1278 - t1045*t1278
    )
    K_theta_out[..., 7, 2, 12] = t1279
    K_theta_out[..., 7, 2, 13] = t1280
    K_theta_out[..., 7, 2, 14] = t1281
    K_theta_out[..., 7, 2, 18] = t1282
    K_theta_out[..., 7, 2, 19] = t1283
    K_theta_out[..., 7, 2, 20] = t1284
    K_theta_out[..., 7, 4, 1] = t1267
    K_theta_out[..., 7, 4, 4] = t1266*t462
    K_theta_out[..., 7, 4, 16] = t1267
    K_theta_out[..., 7, 7, 1] = t1268
    K_theta_out[..., 7, 7, 7] = -t1262*t462
    K_theta_out[..., 7, 7, 16] = t1268
    K_theta_out[..., 7, 12, 0] = t1251
    K_theta_out[..., 7, 12, 1] = t1269
    K_theta_out[..., 7, 12, 2] = t1279
    K_theta_out[..., 7, 12, 12] = (
        D_delta_x_1_by_b_2_x*t1113 + D_delta_y_1_by_b_2_x*t1114 + D_delta_z_1_by_b_2_x*t1115
        + mu_1_by_b_2_x*t960 - mu_2_by_b_2_x*t238 - mu_3_by_b_2_x*t238
    )
    K_theta_out[..., 7, 12, 13] = t1285
    K_theta_out[..., 7, 12, 14] = t1286
    K_theta_out[..., 7, 12, 18] = t1287
    K_theta_out[..., 7, 12, 19] = t1288
    K_theta_out[..., 7, 12, 20] = t1289
    K_theta_out[..., 7, 13, 0] = t1252
    K_theta_out[..., 7, 13, 1] = t1270
    K_theta_out[..., 7, 13, 2] = t1280
    K_theta_out[..., 7, 13, 12] = t1285
    K_theta_out[..., 7, 13, 13] = (
        D_delta_x_2_by_b_2_x*t1130 + D_delta_y_2_by_b_2_x*t1131 + D_delta_z_2_by_b_2_x*t1132
        - mu_1_by_b_2_x*t250 + mu_2_by_b_2_x*t963 - mu_3_by_b_2_x*t250
    )
    K_theta_out[..., 7, 13, 14] = t1290
    K_theta_out[..., 7, 13, 18] = t1291
    K_theta_out[..., 7, 13, 19] = t1292
    K_theta_out[..., 7, 13, 20] = t1293
    K_theta_out[..., 7, 14, 0] = t1253
    K_theta_out[..., 7, 14, 1] = t1271
    K_theta_out[..., 7, 14, 2] = t1281
    K_theta_out[..., 7, 14, 12] = t1286
    K_theta_out[..., 7, 14, 13] = t1290
    K_theta_out[..., 7, 14, 14] = (
        D_delta_x_3_by_b_2_x*t1137 + D_delta_y_3_by_b_2_x*t1138 + D_delta_z_3_by_b_2_x*t1139
        - mu_1_by_b_2_x*t258 - mu_2_by_b_2_x*t258 + mu_3_by_b_2_x*t965
    )
    K_theta_out[..., 7, 14, 18] = t1294
    K_theta_out[..., 7, 14, 19] = t1295
    K_theta_out[..., 7, 14, 20] = t1296
    K_theta_out[..., 7, 16, 1] = t1272
    K_theta_out[..., 7, 16, 4] = t1267
    K_theta_out[..., 7, 16, 7] = t1268
    K_theta_out[..., 7, 16, 16] = t1272
    K_theta_out[..., 7, 18, 0] = t1254
    K_theta_out[..., 7, 18, 1] = t1273
    K_theta_out[..., 7, 18, 2] = t1282
    K_theta_out[..., 7, 18, 12] = t1287
    K_theta_out[..., 7, 18, 13] = t1291
    K_theta_out[..., 7, 18, 14] = t1294
    K_theta_out[..., 7, 19, 0] = t1255
    K_theta_out[..., 7, 19, 1] = t1274
    K_theta_out[..., 7, 19, 2] = t1283
    K_theta_out[..., 7, 19, 12] = t1288
    K_theta_out[..., 7, 19, 13] = t1292
    K_theta_out[..., 7, 19, 14] = t1295
    K_theta_out[..., 7, 20, 0] = t1256
    K_theta_out[..., 7, 20, 1] = t1275
    K_theta_out[..., 7, 20, 2] = t1284
    K_theta_out[..., 7, 20, 12] = t1289
    K_theta_out[..., 7, 20, 13] = t1293
    K_theta_out[..., 7, 20, 14] = t1296
    K_theta_out[..., 8, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_2_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_y*k_C
        + mu_1_by_b_2_y*t903 + mu_2_by_b_2_y*t904 + mu_3_by_b_2_y*t905 - t1011*t1297 - t1013*t1297
        - t1014*t1297 - t1015*t1298 - t1017*t1298 - t1018*t1298 - t1019*t1299 - t1021*t1299 - t1022*t1299
    )
    K_theta_out[..., 8, 0, 1] = t1300
    K_theta_out[..., 8, 0, 2] = t1301
    K_theta_out[..., 8, 0, 12] = t1302
    K_theta_out[..., 8, 0, 13] = t1303
    K_theta_out[..., 8, 0, 14] = t1304
    K_theta_out[..., 8, 0, 18] = t1305
    K_theta_out[..., 8, 0, 19] = t1306
    K_theta_out[..., 8, 0, 20] = t1307
    K_theta_out[..., 8, 1, 0] = t1300
    K_theta_out[..., 8, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_2_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_y*k_C
        + k_sp_2*t1263*t22*w_b_2*x_2_by_b_2_y + mu_1_by_b_2_y*t926 + mu_2_by_b_2_y*t927 + mu_3_by_b_2_y*t928
        - t1027*t1308 - t1028*t1308 - t1029*t1308 - t1030*t1309 - t1031*t1309 - t1032*t1309 - t1033*t1310
        - t1034*t1310 - t1035*t1310 - t1311
    )
    K_theta_out[..., 8, 1, 2] = t1312
    K_theta_out[..., 8, 1, 4] = t1314
    K_theta_out[..., 8, 1, 7] = t1315
    K_theta_out[..., 8, 1, 12] = t1316
    K_theta_out[..., 8, 1, 13] = t1317
    K_theta_out[..., 8, 1, 14] = t1318
    K_theta_out[..., 8, 1, 16] = t1319
    K_theta_out[..., 8, 1, 18] = t1320
    K_theta_out[..., 8, 1, 19] = t1321
    K_theta_out[..., 8, 1, 20] = t1322
    K_theta_out[..., 8, 2, 0] = t1301
    K_theta_out[..., 8, 2, 1] = t1312
    K_theta_out[..., 8, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_2_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_y*k_C
        + mu_1_by_b_2_y*t945 + mu_2_by_b_2_y*t946 + mu_3_by_b_2_y*t947 - t1037*t1323 - t1038*t1323
        - t1039*t1323 - t1040*t1324 - t1041*t1324 - t1042*t1324 - t1043*t1325 - t1044*t1325 - t1045*t1325
    )
    K_theta_out[..., 8, 2, 12] = t1326
    K_theta_out[..., 8, 2, 13] = t1327
    K_theta_out[..., 8, 2, 14] = t1328
    K_theta_out[..., 8, 2, 18] = t1329
    K_theta_out[..., 8, 2, 19] = t1330
    K_theta_out[..., 8, 2, 20] = t1331
    K_theta_out[..., 8, 4, 1] = t1314
    K_theta_out[..., 8, 4, 4] = t1313*t462
    K_theta_out[..., 8, 4, 16] = t1314
    K_theta_out[..., 8, 7, 1] = t1315
    K_theta_out[..., 8, 7, 7] = -t1311*t462
    K_theta_out[..., 8, 7, 16] = t1315
    K_theta_out[..., 8, 12, 0] = t1302
    K_theta_out[..., 8, 12, 1] = t1316
    K_theta_out[..., 8, 12, 2] = t1326
    K_theta_out[..., 8, 12, 12] = (
        D_delta_x_1_by_b_2_y*t1113 + D_delta_y_1_by_b_2_y*t1114 + D_delta_z_1_by_b_2_y*t1115
        + mu_1_by_b_2_y*t960 - mu_2_by_b_2_y*t238 - mu_3_by_b_2_y*t238
    )
    K_theta_out[..., 8, 12, 13] = t1332
    K_theta_out[..., 8, 12, 14] = t1333
    K_theta_out[..., 8, 12, 18] = t1334
    K_theta_out[..., 8, 12, 19] = t1335
    K_theta_out[..., 8, 12, 20] = t1336
    K_theta_out[..., 8, 13, 0] = t1303
    K_theta_out[..., 8, 13, 1] = t1317
    K_theta_out[..., 8, 13, 2] = t1327
    K_theta_out[..., 8, 13, 12] = t1332
    K_theta_out[..., 8, 13, 13] = (
        D_delta_x_2_by_b_2_y*t1130 + D_delta_y_2_by_b_2_y*t1131 + D_delta_z_2_by_b_2_y*t1132
        - mu_1_by_b_2_y*t250 + mu_2_by_b_2_y*t963 - mu_3_by_b_2_y*t250
    )
    K_theta_out[..., 8, 13, 14] = t1337
    K_theta_out[..., 8, 13, 18] = t1338
    K_theta_out[..., 8, 13, 19] = t1339
    K_theta_out[..., 8, 13, 20] = t1340
    K_theta_out[..., 8, 14, 0] = t1304
    K_theta_out[..., 8, 14, 1] = t1318
    K_theta_out[..., 8, 14, 2] = t1328
    K_theta_out[..., 8, 14, 12] = t1333
    K_theta_out[..., 8, 14, 13] = t1337
    K_theta_out[..., 8, 14, 14] = (
        D_delta_x_3_by_b_2_y*t1137 + D_delta_y_3_by_b_2_y*t1138 + D_delta_z_3_by_b_2_y*t1139
        - mu_1_by_b_2_y*t258 - mu_2_by_b_2_y*t258 + mu_3_by_b_2_y*t965
    )
    K_theta_out[..., 8, 14, 18] = t1341
    K_theta_out[..., 8, 14, 19] = t1342
    K_theta_out[..., 8, 14, 20] = t1343
    K_theta_out[..., 8, 16, 1] = t1319
    K_theta_out[..., 8, 16, 4] = t1314
    K_theta_out[..., 8, 16, 7] = t1315
    K_theta_out[..., 8, 16, 16] = t1319
    K_theta_out[..., 8, 18, 0] = t1305
    K_theta_out[..., 8, 18, 1] = t1320
    K_theta_out[..., 8, 18, 2] = t1329
    K_theta_out[..., 8, 18, 12] = t1334
    K_theta_out[..., 8, 18, 13] = t1338
    K_theta_out[..., 8, 18, 14] = t1341
    K_theta_out[..., 8, 19, 0] = t1306
    K_theta_out[..., 8, 19, 1] = t1321
    K_theta_out[..., 8, 19, 2] = t1330
    K_theta_out[..., 8, 19, 12] = t1335
    K_theta_out[..., 8, 19, 13] = t1339
    K_theta_out[..., 8, 19, 14] = t1342
    K_theta_out[..., 8, 20, 0] = t1307
    K_theta_out[..., 8, 20, 1] = t1322
    K_theta_out[..., 8, 20, 2] = t1331
    K_theta_out[..., 8, 20, 12] = t1336
    K_theta_out[..., 8, 20, 13] = t1340
    K_theta_out[..., 8, 20, 14] = t1343
    K_theta_out[..., 9, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_2_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_2_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_2_z*k_C
        + mu_1_by_b_2_z*t903 + mu_2_by_b_2_z*t904 + mu_3_by_b_2_z*t905 - t1011*t1344 - t1013*t1344
        - t1014*t1344 - t1015*t1345 - t1017*t1345 - t1018*t1345 - t1019*t1346 - t1021*t1346 - t1022*t1346
    )
    K_theta_out[..., 9, 0, 1] = t1347
    K_theta_out[..., 9, 0, 2] = t1348
    K_theta_out[..., 9, 0, 12] = t1349
    K_theta_out[..., 9, 0, 13] = t1350
    K_theta_out[..., 9, 0, 14] = t1351
    K_theta_out[..., 9, 0, 18] = t1352
    K_theta_out[..., 9, 0, 19] = t1353
    K_theta_out[..., 9, 0, 20] = t1354
    K_theta_out[..., 9, 1, 0] = t1347
    K_theta_out[..., 9, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_2_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_2_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_2_z*k_C
        + k_sp_2*t1263*t22*w_b_2*x_2_by_b_2_z + mu_1_by_b_2_z*t926 + mu_2_by_b_2_z*t927 + mu_3_by_b_2_z*t928
        - t1027*t1355 - t1028*t1355 - t1029*t1355 - t1030*t1356 - t1031*t1356 - t1032*t1356 - t1033*t1357
        - t1034*t1357 - t1035*t1357 - t1358
    )
    K_theta_out[..., 9, 1, 2] = t1359
    K_theta_out[..., 9, 1, 4] = t1361
    K_theta_out[..., 9, 1, 7] = t1362
    K_theta_out[..., 9, 1, 12] = t1363
    K_theta_out[..., 9, 1, 13] = t1364
    K_theta_out[..., 9, 1, 14] = t1365
    K_theta_out[..., 9, 1, 16] = t1366
    K_theta_out[..., 9, 1, 18] = t1367
    K_theta_out[..., 9, 1, 19] = t1368
    K_theta_out[..., 9, 1, 20] = t1369
    K_theta_out[..., 9, 2, 0] = t1348
    K_theta_out[..., 9, 2, 1] = t1359
    K_theta_out[..., 9, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_2_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_2_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_2_z*k_C
        + mu_1_by_b_2_z*t945 + mu_2_by_b_2_z*t946 + mu_3_by_b_2_z*t947 - t1037*t1370 - t1038*t1370
        - t1039*t1370 - t1040*t1371 - t1041*t1371 - t1042*t1371 - t1043*t1372 - t1044*t1372 - t1045*t1372
    )
    K_theta_out[..., 9, 2, 12] = t1373
    K_theta_out[..., 9, 2, 13] = t1374
    K_theta_out[..., 9, 2, 14] = t1375
    K_theta_out[..., 9, 2, 18] = t1376
    K_theta_out[..., 9, 2, 19] = t1377
    K_theta_out[..., 9, 2, 20] = t1378
    K_theta_out[..., 9, 4, 1] = t1361
    K_theta_out[..., 9, 4, 4] = t1360*t462
    K_theta_out[..., 9, 4, 16] = t1361
    K_theta_out[..., 9, 7, 1] = t1362
    K_theta_out[..., 9, 7, 7] = -t1358*t462
    K_theta_out[..., 9, 7, 16] = t1362
    K_theta_out[..., 9, 12, 0] = t1349
    K_theta_out[..., 9, 12, 1] = t1363
    K_theta_out[..., 9, 12, 2] = t1373
    K_theta_out[..., 9, 12, 12] = (
        D_delta_x_1_by_b_2_z*t1113 + D_delta_y_1_by_b_2_z*t1114 + D_delta_z_1_by_b_2_z*t1115
        + mu_1_by_b_2_z*t960 - mu_2_by_b_2_z*t238 - mu_3_by_b_2_z*t238
    )
    K_theta_out[..., 9, 12, 13] = t1379
    K_theta_out[..., 9, 12, 14] = t1380
    K_theta_out[..., 9, 12, 18] = t1381
    K_theta_out[..., 9, 12, 19] = t1382
    K_theta_out[..., 9, 12, 20] = t1383
    K_theta_out[..., 9, 13, 0] = t1350
    K_theta_out[..., 9, 13, 1] = t1364
    K_theta_out[..., 9, 13, 2] = t1374
    K_theta_out[..., 9, 13, 12] = t1379
    K_theta_out[..., 9, 13, 13] = (
        D_delta_x_2_by_b_2_z*t1130 + D_delta_y_2_by_b_2_z*t1131 + D_delta_z_2_by_b_2_z*t1132
        - mu_1_by_b_2_z*t250 + mu_2_by_b_2_z*t963 - mu_3_by_b_2_z*t250
    )
    K_theta_out[..., 9, 13, 14] = t1384
    K_theta_out[..., 9, 13, 18] = t1385
    K_theta_out[..., 9, 13, 19] = t1386
    K_theta_out[..., 9, 13, 20] = t1387
    K_theta_out[..., 9, 14, 0] = t1351
    K_theta_out[..., 9, 14, 1] = t1365
    K_theta_out[..., 9, 14, 2] = t1375
    K_theta_out[..., 9, 14, 12] = t1380
    K_theta_out[..., 9, 14, 13] = t1384
    K_theta_out[..., 9, 14, 14] = (
        D_delta_x_3_by_b_2_z*t1137 + D_delta_y_3_by_b_2_z*t1138 + D_delta_z_3_by_b_2_z*t1139
        - mu_1_by_b_2_z*t258 - mu_2_by_b_2_z*t258 + mu_3_by_b_2_z*t965
    )
    K_theta_out[..., 9, 14, 18] = t1388
    K_theta_out[..., 9, 14, 19] = t1389
    K_theta_out[..., 9, 14, 20] = t1390
    K_theta_out[..., 9, 16, 1] = t1366
    K_theta_out[..., 9, 16, 4] = t1361
    K_theta_out[..., 9, 16, 7] = t1362
    K_theta_out[..., 9, 16, 16] = t1366
    K_theta_out[..., 9, 18, 0] = t1352
    K_theta_out[..., 9, 18, 1] = t1367
    K_theta_out[..., 9, 18, 2] = t1376
    K_theta_out[..., 9, 18, 12] = t1381
    K_theta_out[..., 9, 18, 13] = t1385
    K_theta_out[..., 9, 18, 14] = t1388
    K_theta_out[..., 9, 19, 0] = t1353
    K_theta_out[..., 9, 19, 1] = t1368
    K_theta_out[..., 9, 19, 2] = t1377
    K_theta_out[..., 9, 19, 12] = t1382
    K_theta_out[..., 9, 19, 13] = t1386
    K_theta_out[..., 9, 19, 14] = t1389
    K_theta_out[..., 9, 20, 0] = t1354
    K_theta_out[..., 9, 20, 1] = t1369
    K_theta_out[..., 9, 20, 2] = t1378
    K_theta_out[..., 9, 20, 12] = t1383
    K_theta_out[..., 9, 20, 13] = t1387
    K_theta_out[..., 9, 20, 14] = t1390
    K_theta_out[..., 10, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_3_x*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_x*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_x*k_C
        + mu_1_by_b_3_x*t903 + mu_2_by_b_3_x*t904 + mu_3_by_b_3_x*t905 - t1011*t1391 - t1013*t1391
        - t1014*t1391 - t1015*t1392 - t1017*t1392 - t1018*t1392 - t1019*t1393 - t1021*t1393 - t1022*t1393
    )
    K_theta_out[..., 10, 0, 1] = t1394
    K_theta_out[..., 10, 0, 2] = t1395
    K_theta_out[..., 10, 0, 12] = t1396
    K_theta_out[..., 10, 0, 13] = t1397
    K_theta_out[..., 10, 0, 14] = t1398
    K_theta_out[..., 10, 0, 18] = t1399
    K_theta_out[..., 10, 0, 19] = t1400
    K_theta_out[..., 10, 0, 20] = t1401
    K_theta_out[..., 10, 1, 0] = t1394
    K_theta_out[..., 10, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_3_x*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_x*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_x*k_C
        + mu_1_by_b_3_x*t926 + mu_2_by_b_3_x*t927 + mu_3_by_b_3_x*t928 - t1027*t1402 - t1028*t1402
        - t1029*t1402 - t1030*t1403 - t1031*t1403 - t1032*t1403 - t1033*t1404 - t1034*t1404 - t1035*t1404
    )
    K_theta_out[..., 10, 1, 2] = t1405
    K_theta_out[..., 10, 1, 12] = t1406
    K_theta_out[..., 10, 1, 13] = t1407
    K_theta_out[..., 10, 1, 14] = t1408
    K_theta_out[..., 10, 1, 18] = t1409
    K_theta_out[..., 10, 1, 19] = t1410
    K_theta_out[..., 10, 1, 20] = t1411
    K_theta_out[..., 10, 2, 0] = t1395
    K_theta_out[..., 10, 2, 1] = t1405
    K_theta_out[..., 10, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_3_x*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_x*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_x*k_C
        + k_sp_3*t1418*t33*w_b_3*x_3_by_b_3_x + mu_1_by_b_3_x*t945 + mu_2_by_b_3_x*t946 + mu_3_by_b_3_x*t947
        - t1037*t1412 - t1038*t1412 - t1039*t1412 - t1040*t1413 - t1041*t1413 - t1042*t1413 - t1043*t1414
        - t1044*t1414 - t1045*t1414 - t1417
    )
    K_theta_out[..., 10, 2, 5] = t1421
    K_theta_out[..., 10, 2, 8] = t1422
    K_theta_out[..., 10, 2, 12] = t1423
    K_theta_out[..., 10, 2, 13] = t1424
    K_theta_out[..., 10, 2, 14] = t1425
    K_theta_out[..., 10, 2, 17] = t1426
    K_theta_out[..., 10, 2, 18] = t1427
    K_theta_out[..., 10, 2, 19] = t1428
    K_theta_out[..., 10, 2, 20] = t1429
    K_theta_out[..., 10, 5, 2] = t1421
    K_theta_out[..., 10, 5, 5] = t1420*t570
    K_theta_out[..., 10, 5, 17] = t1421
    K_theta_out[..., 10, 8, 2] = t1422
    K_theta_out[..., 10, 8, 8] = -t1417*t570
    K_theta_out[..., 10, 8, 17] = t1422
    K_theta_out[..., 10, 12, 0] = t1396
    K_theta_out[..., 10, 12, 1] = t1406
    K_theta_out[..., 10, 12, 2] = t1423
    K_theta_out[..., 10, 12, 12] = (
        D_delta_x_1_by_b_3_x*t1113 + D_delta_y_1_by_b_3_x*t1114 + D_delta_z_1_by_b_3_x*t1115
        + mu_1_by_b_3_x*t960 - mu_2_by_b_3_x*t238 - mu_3_by_b_3_x*t238
    )
    K_theta_out[..., 10, 12, 13] = t1430
    K_theta_out[..., 10, 12, 14] = t1431
    K_theta_out[..., 10, 12, 18] = t1432
    K_theta_out[..., 10, 12, 19] = t1433
    K_theta_out[..., 10, 12, 20] = t1434
    K_theta_out[..., 10, 13, 0] = t1397
    K_theta_out[..., 10, 13, 1] = t1407
    K_theta_out[..., 10, 13, 2] = t1424
    K_theta_out[..., 10, 13, 12] = t1430
    K_theta_out[..., 10, 13, 13] = (
        D_delta_x_2_by_b_3_x*t1130 + D_delta_y_2_by_b_3_x*t1131 + D_delta_z_2_by_b_3_x*t1132
        - mu_1_by_b_3_x*t250 + mu_2_by_b_3_x*t963 - mu_3_by_b_3_x*t250
    )
    K_theta_out[..., 10, 13, 14] = t1435
    K_theta_out[..., 10, 13, 18] = t1436
    K_theta_out[..., 10, 13, 19] = t1437
    K_theta_out[..., 10, 13, 20] = t1438
    K_theta_out[..., 10, 14, 0] = t1398
    K_theta_out[..., 10, 14, 1] = t1408
    K_theta_out[..., 10, 14, 2] = t1425
    K_theta_out[..., 10, 14, 12] = t1431
    K_theta_out[..., 10, 14, 13] = t1435
    K_theta_out[..., 10, 14, 14] = (
        D_delta_x_3_by_b_3_x*t1137 + D_delta_y_3_by_b_3_x*t1138 + D_delta_z_3_by_b_3_x*t1139
        - mu_1_by_b_3_x*t258 - mu_2_by_b_3_x*t258 + mu_3_by_b_3_x*t965
    )
    K_theta_out[..., 10, 14, 18] = t1439
    K_theta_out[..., 10, 14, 19] = t1440
    K_theta_out[..., 10, 14, 20] = t1441
    K_theta_out[..., 10, 17, 2] = t1426
    K_theta_out[..., 10, 17, 5] = t1421
    K_theta_out[..., 10, 17, 8] = t1422
    K_theta_out[..., 10, 17, 17] = t1426
    K_theta_out[..., 10, 18, 0] = t1399
    K_theta_out[..., 10, 18, 1] = t1409
    K_theta_out[..., 10, 18, 2] = t1427
    K_theta_out[..., 10, 18, 12] = t1432
    K_theta_out[..., 10, 18, 13] = t1436
    K_theta_out[..., 10, 18, 14] = t1439
    K_theta_out[..., 10, 19, 0] = t1400
    K_theta_out[..., 10, 19, 1] = t1410
    K_theta_out[..., 10, 19, 2] = t1428
    K_theta_out[..., 10, 19, 12] = t1433
    K_theta_out[..., 10, 19, 13] = t1437
    K_theta_out[..., 10, 19, 14] = t1440
    K_theta_out[..., 10, 20, 0] = t1401
    K_theta_out[..., 10, 20, 1] = t1411
    K_theta_out[..., 10, 20, 2] = t1429
    K_theta_out[..., 10, 20, 12] = t1434
    K_theta_out[..., 10, 20, 13] = t1438
    K_theta_out[..., 10, 20, 14] = t1441
    K_theta_out[..., 11, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_3_y*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_y*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_y*k_C
        + mu_1_by_b_3_y*t903 + mu_2_by_b_3_y*t904 + mu_3_by_b_3_y*t905 - t1011*t1442 - t1013*t1442
        - t1014*t1442 - t1015*t1443 - t1017*t1443 - t1018*t1443 - t1019*t1444 - t1021*t1444 - t1022*t1444
    )
    K_theta_out[..., 11, 0, 1] = t1445
    K_theta_out[..., 11, 0, 2] = t1446
    K_theta_out[..., 11, 0, 12] = t1447
    K_theta_out[..., 11, 0, 13] = t1448
    K_theta_out[..., 11, 0, 14] = t1449
    K_theta_out[..., 11, 0, 18] = t1450
    K_theta_out[..., 11, 0, 19] = t1451
    K_theta_out[..., 11, 0, 20] = t1452
    K_theta_out[..., 11, 1, 0] = t1445
    K_theta_out[..., 11, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_3_y*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_y*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_y*k_C
        + mu_1_by_b_3_y*t926 + mu_2_by_b_3_y*t927 + mu_3_by_b_3_y*t928 - t1027*t1453 - t1028*t1453
        - t1029*t1453 - t1030*t1454 - t1031*t1454 - t1032*t1454 - t1033*t1455 - t1034*t1455 - t1035*t1455
    )
    K_theta_out[..., 11, 1, 2] = t1456
    K_theta_out[..., 11, 1, 12] = t1457
    K_theta_out[..., 11, 1, 13] = t1458
    K_theta_out[..., 11, 1, 14] = t1459
    K_theta_out[..., 11, 1, 18] = t1460
    K_theta_out[..., 11, 1, 19] = t1461
    K_theta_out[..., 11, 1, 20] = t1462
    K_theta_out[..., 11, 2, 0] = t1446
    K_theta_out[..., 11, 2, 1] = t1456
    K_theta_out[..., 11, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_3_y*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_y*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_y*k_C
        + k_sp_3*t1418*t33*w_b_3*x_3_by_b_3_y + mu_1_by_b_3_y*t945 + mu_2_by_b_3_y*t946 + mu_3_by_b_3_y*t947
        - t1037*t1463 - t1038*t1463 - t1039*t1463 - t1040*t1464 - t1041*t1464 - t1042*t1464 - t1043*t1465
        - t1044*t1465 - t1045*t1465 - t1466
    )
    K_theta_out[..., 11, 2, 5] = t1468
    K_theta_out[..., 11, 2, 8] = t1469
    K_theta_out[..., 11, 2, 12] = t1470
    K_theta_out[..., 11, 2, 13] = t1471
    K_theta_out[..., 11, 2, 14] = t1472
    K_theta_out[..., 11, 2, 17] = t1473
    K_theta_out[..., 11, 2, 18] = t1474
    K_theta_out[..., 11, 2, 19] = t1475
    K_theta_out[..., 11, 2, 20] = t1476
    K_theta_out[..., 11, 5, 2] = t1468
    K_theta_out[..., 11, 5, 5] = t1467*t570
    K_theta_out[..., 11, 5, 17] = t1468
    K_theta_out[..., 11, 8, 2] = t1469
    K_theta_out[..., 11, 8, 8] = -t1466*t570
    K_theta_out[..., 11, 8, 17] = t1469
    K_theta_out[..., 11, 12, 0] = t1447
    K_theta_out[..., 11, 12, 1] = t1457
    K_theta_out[..., 11, 12, 2] = t1470
    K_theta_out[..., 11, 12, 12] = (
        D_delta_x_1_by_b_3_y*t1113 + D_delta_y_1_by_b_3_y*t1114 + D_delta_z_1_by_b_3_y*t1115
        + mu_1_by_b_3_y*t960 - mu_2_by_b_3_y*t238 - mu_3_by_b_3_y*t238
    )
    K_theta_out[..., 11, 12, 13] = t1477
    K_theta_out[..., 11, 12, 14] = t1478
    K_theta_out[..., 11, 12, 18] = t1479
    K_theta_out[..., 11, 12, 19] = t1480
    K_theta_out[..., 11, 12, 20] = t1481
    K_theta_out[..., 11, 13, 0] = t1448
    K_theta_out[..., 11, 13, 1] = t1458
    K_theta_out[..., 11, 13, 2] = t1471
    K_theta_out[..., 11, 13, 12] = t1477
    K_theta_out[..., 11, 13, 13] = (
        D_delta_x_2_by_b_3_y*t1130 + D_delta_y_2_by_b_3_y*t1131 + D_delta_z_2_by_b_3_y*t1132
        - mu_1_by_b_3_y*t250 + mu_2_by_b_3_y*t963 - mu_3_by_b_3_y*t250
    )
    K_theta_out[..., 11, 13, 14] = t1482
    K_theta_out[..., 11, 13, 18] = t1483
    K_theta_out[..., 11, 13, 19] = t1484
    K_theta_out[..., 11, 13, 20] = t1485
    K_theta_out[..., 11, 14, 0] = t1449
    K_theta_out[..., 11, 14, 1] = t1459
    K_theta_out[..., 11, 14, 2] = t1472
    K_theta_out[..., 11, 14, 12] = t1478
    K_theta_out[..., 11, 14, 13] = t1482
    K_theta_out[..., 11, 14, 14] = (
        D_delta_x_3_by_b_3_y*t1137 + D_delta_y_3_by_b_3_y*t1138 + D_delta_z_3_by_b_3_y*t1139
        - mu_1_by_b_3_y*t258 - mu_2_by_b_3_y*t258 + mu_3_by_b_3_y*t965
    )
    K_theta_out[..., 11, 14, 18] = t1486
    K_theta_out[..., 11, 14, 19] = t1487
    K_theta_out[..., 11, 14, 20] = t1488
    K_theta_out[..., 11, 17, 2] = t1473
    K_theta_out[..., 11, 17, 5] = t1468
    K_theta_out[..., 11, 17, 8] = t1469
    K_theta_out[..., 11, 17, 17] = t1473
    K_theta_out[..., 11, 18, 0] = t1450
    K_theta_out[..., 11, 18, 1] = t1460
    K_theta_out[..., 11, 18, 2] = t1474
    K_theta_out[..., 11, 18, 12] = t1479
    K_theta_out[..., 11, 18, 13] = t1483
    K_theta_out[..., 11, 18, 14] = t1486
    K_theta_out[..., 11, 19, 0] = t1451
    K_theta_out[..., 11, 19, 1] = t1461
    K_theta_out[..., 11, 19, 2] = t1475
    K_theta_out[..., 11, 19, 12] = t1480
    K_theta_out[..., 11, 19, 13] = t1484
    K_theta_out[..., 11, 19, 14] = t1487
    K_theta_out[..., 11, 20, 0] = t1452
    K_theta_out[..., 11, 20, 1] = t1462
    K_theta_out[..., 11, 20, 2] = t1476
    K_theta_out[..., 11, 20, 12] = t1481
    K_theta_out[..., 11, 20, 13] = t1485
    K_theta_out[..., 11, 20, 14] = t1488
    K_theta_out[..., 12, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_b_3_z*k_C + 2*D_p_y_1*D_p_y_1_by_b_3_z*k_C + 2*D_p_z_1*D_p_z_1_by_b_3_z*k_C
        + mu_1_by_b_3_z*t903 + mu_2_by_b_3_z*t904 + mu_3_by_b_3_z*t905 - t1011*t1489 - t1013*t1489
        - t1014*t1489 - t1015*t1490 - t1017*t1490 - t1018*t1490 - t1019*t1491 - t1021*t1491 - t1022*t1491
    )
    K_theta_out[..., 12, 0, 1] = t1492
    K_theta_out[..., 12, 0, 2] = t1493
    K_theta_out[..., 12, 0, 12] = t1494
    K_theta_out[..., 12, 0, 13] = t1495
    K_theta_out[..., 12, 0, 14] = t1496
    K_theta_out[..., 12, 0, 18] = t1497
    K_theta_out[..., 12, 0, 19] = t1498
    K_theta_out[..., 12, 0, 20] = t1499
    K_theta_out[..., 12, 1, 0] = t1492
    K_theta_out[..., 12, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_b_3_z*k_C + 2*D_p_y_2*D_p_y_2_by_b_3_z*k_C + 2*D_p_z_2*D_p_z_2_by_b_3_z*k_C
        + mu_1_by_b_3_z*t926 + mu_2_by_b_3_z*t927 + mu_3_by_b_3_z*t928 - t1027*t1500 - t1028*t1500
        - t1029*t1500 - t1030*t1501 - t1031*t1501 - t1032*t1501 - t1033*t1502 - t1034*t1502 - t1035*t1502
    )
    K_theta_out[..., 12, 1, 2] = t1503
    K_theta_out[..., 12, 1, 12] = t1504
    K_theta_out[..., 12, 1, 13] = t1505
    K_theta_out[..., 12, 1, 14] = t1506
    K_theta_out[..., 12, 1, 18] = t1507
    K_theta_out[..., 12, 1, 19] = t1508
    K_theta_out[..., 12, 1, 20] = t1509
    K_theta_out[..., 12, 2, 0] = t1493
    K_theta_out[..., 12, 2, 1] = t1503
    K_theta_out[..., 12, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_b_3_z*k_C + 2*D_p_y_3*D_p_y_3_by_b_3_z*k_C + 2*D_p_z_3*D_p_z_3_by_b_3_z*k_C
        + k_sp_3*t1418*t33*w_b_3*x_3_by_b_3_z + mu_1_by_b_3_z*t945 + mu_2_by_b_3_z*t946 + mu_3_by_b_3_z*t947
        - t1037*t1510 - t1038*t1510 - t1039*t1510 - t1040*t1511 - t1041*t1511 - t1042*t1511 - t1043*t1512
        - t1044*t1512 - t1045*t1512 - t1513
    )
    K_theta_out[..., 12, 2, 5] = t1515
    K_theta_out[..., 12, 2, 8] = t1516
    K_theta_out[..., 12, 2, 12] = t1517
    K_theta_out[..., 12, 2, 13] = t1518
    K_theta_out[..., 12, 2, 14] = t1519
    K_theta_out[..., 12, 2, 17] = t1520
    K_theta_out[..., 12, 2, 18] = t1521
    K_theta_out[..., 12, 2, 19] = t1522
    K_theta_out[..., 12, 2, 20] = t1523
    K_theta_out[..., 12, 5, 2] = t1515
    K_theta_out[..., 12, 5, 5] = t1514*t570
    K_theta_out[..., 12, 5, 17] = t1515
    K_theta_out[..., 12, 8, 2] = t1516
    K_theta_out[..., 12, 8, 8] = -t1513*t570
    K_theta_out[..., 12, 8, 17] = t1516
    K_theta_out[..., 12, 12, 0] = t1494
    K_theta_out[..., 12, 12, 1] = t1504
    K_theta_out[..., 12, 12, 2] = t1517
    K_theta_out[..., 12, 12, 12] = (
        D_delta_x_1_by_b_3_z*t1113 + D_delta_y_1_by_b_3_z*t1114 + D_delta_z_1_by_b_3_z*t1115
        + mu_1_by_b_3_z*t960 - mu_2_by_b_3_z*t238 - mu_3_by_b_3_z*t238
    )
    K_theta_out[..., 12, 12, 13] = t1524
    K_theta_out[..., 12, 12, 14] = t1525
    K_theta_out[..., 12, 12, 18] = t1526
    K_theta_out[..., 12, 12, 19] = t1527
    K_theta_out[..., 12, 12, 20] = t1528
    K_theta_out[..., 12, 13, 0] = t1495
    K_theta_out[..., 12, 13, 1] = t1505
    K_theta_out[..., 12, 13, 2] = t1518
    K_theta_out[..., 12, 13, 12] = t1524
    K_theta_out[..., 12, 13, 13] = (
        D_delta_x_2_by_b_3_z*t1130 + D_delta_y_2_by_b_3_z*t1131 + D_delta_z_2_by_b_3_z*t1132
        - mu_1_by_b_3_z*t250 + mu_2_by_b_3_z*t963 - mu_3_by_b_3_z*t250
    )
    K_theta_out[..., 12, 13, 14] = t1529
    K_theta_out[..., 12, 13, 18] = t1530
    K_theta_out[..., 12, 13, 19] = t1531
    K_theta_out[..., 12, 13, 20] = t1532
    K_theta_out[..., 12, 14, 0] = t1496
    K_theta_out[..., 12, 14, 1] = t1506
    K_theta_out[..., 12, 14, 2] = t1519
    K_theta_out[..., 12, 14, 12] = t1525
    K_theta_out[..., 12, 14, 13] = t1529
    K_theta_out[..., 12, 14, 14] = (
        D_delta_x_3_by_b_3_z*t1137 + D_delta_y_3_by_b_3_z*t1138 + D_delta_z_3_by_b_3_z*t1139
        - mu_1_by_b_3_z*t258 - mu_2_by_b_3_z*t258 + mu_3_by_b_3_z*t965
    )
    K_theta_out[..., 12, 14, 18] = t1533
    K_theta_out[..., 12, 14, 19] = t1534
    K_theta_out[..., 12, 14, 20] = t1535
    K_theta_out[..., 12, 17, 2] = t1520
    K_theta_out[..., 12, 17, 5] = t1515
    K_theta_out[..., 12, 17, 8] = t1516
    K_theta_out[..., 12, 17, 17] = t1520
    K_theta_out[..., 12, 18, 0] = t1497
    K_theta_out[..., 12, 18, 1] = t1507
    K_theta_out[..., 12, 18, 2] = t1521
    K_theta_out[..., 12, 18, 12] = t1526
    K_theta_out[..., 12, 18, 13] = t1530
    K_theta_out[..., 12, 18, 14] = t1533
    K_theta_out[..., 12, 19, 0] = t1498
    K_theta_out[..., 12, 19, 1] = t1508
    K_theta_out[..., 12, 19, 2] = t1522
    K_theta_out[..., 12, 19, 12] = t1527
    K_theta_out[..., 12, 19, 13] = t1531
    K_theta_out[..., 12, 19, 14] = t1534
    K_theta_out[..., 12, 20, 0] = t1499
    K_theta_out[..., 12, 20, 1] = t1509
    K_theta_out[..., 12, 20, 2] = t1523
    K_theta_out[..., 12, 20, 12] = t1528
    K_theta_out[..., 12, 20, 13] = t1532
    K_theta_out[..., 12, 20, 14] = t1535
    K_theta_out[..., 13, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_l_d_1*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_1*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_1*k_C
        + k_sp_1*t1026*t11*w_b_1*x_1_by_l_d_1 + mu_1_by_l_d_1*t903 + mu_2_by_l_d_1*t904 + mu_3_by_l_d_1*t905
        - t1011*t1536 - t1013*t1536 - t1014*t1536 - t1015*t1537 - t1017*t1537 - t1018*t1537 - t1019*t1538
        - t1021*t1538 - t1022*t1538 - t1539
    )
    K_theta_out[..., 13, 0, 1] = t1540
    K_theta_out[..., 13, 0, 2] = t1541
    K_theta_out[..., 13, 0, 3] = t1543
    K_theta_out[..., 13, 0, 6] = t1544
    K_theta_out[..., 13, 0, 12] = t1545
    K_theta_out[..., 13, 0, 13] = t1546
    K_theta_out[..., 13, 0, 14] = t1547
    K_theta_out[..., 13, 0, 15] = t1548
    K_theta_out[..., 13, 0, 18] = t1549
    K_theta_out[..., 13, 0, 19] = t1550
    K_theta_out[..., 13, 0, 20] = t1551
    K_theta_out[..., 13, 1, 0] = t1540
    K_theta_out[..., 13, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_l_d_1*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_1*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_1*k_C
        + mu_1_by_l_d_1*t926 + mu_2_by_l_d_1*t927 + mu_3_by_l_d_1*t928 - t1027*t1552 - t1028*t1552
        - t1029*t1552 - t1030*t1553 - t1031*t1553 - t1032*t1553 - t1033*t1554 - t1034*t1554 - t1035*t1554
    )
    K_theta_out[..., 13, 1, 2] = t1555
    K_theta_out[..., 13, 1, 12] = t1556
    K_theta_out[..., 13, 1, 13] = t1557
    K_theta_out[..., 13, 1, 14] = t1558
    K_theta_out[..., 13, 1, 18] = t1559
    K_theta_out[..., 13, 1, 19] = t1560
    K_theta_out[..., 13, 1, 20] = t1561
    K_theta_out[..., 13, 2, 0] = t1541
    K_theta_out[..., 13, 2, 1] = t1555
    K_theta_out[..., 13, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_l_d_1*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_1*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_1*k_C
        + mu_1_by_l_d_1*t945 + mu_2_by_l_d_1*t946 + mu_3_by_l_d_1*t947 - t1037*t1562 - t1038*t1562
        - t1039*t1562 - t1040*t1563 - t1041*t1563 - t1042*t1563 - t1043*t1564 - t1044*t1564 - t1045*t1564
    )
    K_theta_out[..., 13, 2, 12] = t1565
    K_theta_out[..., 13, 2, 13] = t1566
    K_theta_out[..., 13, 2, 14] = t1567
    K_theta_out[..., 13, 2, 18] = t1568
    K_theta_out[..., 13, 2, 19] = t1569
    K_theta_out[..., 13, 2, 20] = t1570
    K_theta_out[..., 13, 3, 0] = t1543
    K_theta_out[..., 13, 3, 3] = t1542*t332
    K_theta_out[..., 13, 3, 15] = t1543
    K_theta_out[..., 13, 6, 0] = t1544
    K_theta_out[..., 13, 6, 6] = -t1539*t332
    K_theta_out[..., 13, 6, 15] = t1544
    K_theta_out[..., 13, 12, 0] = t1545
    K_theta_out[..., 13, 12, 1] = t1556
    K_theta_out[..., 13, 12, 2] = t1565
    K_theta_out[..., 13, 12, 12] = (
        D_delta_x_1_by_l_d_1*t1113 + D_delta_y_1_by_l_d_1*t1114 + D_delta_z_1_by_l_d_1*t1115
        + mu_1_by_l_d_1*t960 - mu_2_by_l_d_1*t238 - mu_3_by_l_d_1*t238
    )
    K_theta_out[..., 13, 12, 13] = t1571
    K_theta_out[..., 13, 12, 14] = t1572
    K_theta_out[..., 13, 12, 18] = t1573
    K_theta_out[..., 13, 12, 19] = t1574
    K_theta_out[..., 13, 12, 20] = t1575
    K_theta_out[..., 13, 13, 0] = t1546
    K_theta_out[..., 13, 13, 1] = t1557
    K_theta_out[..., 13, 13, 2] = t1566
    K_theta_out[..., 13, 13, 12] = t1571
    K_theta_out[..., 13, 13, 13] = (
        D_delta_x_2_by_l_d_1*t1130 + D_delta_y_2_by_l_d_1*t1131 + D_delta_z_2_by_l_d_1*t1132
        - mu_1_by_l_d_1*t250 + mu_2_by_l_d_1*t963 - mu_3_by_l_d_1*t250
    )
    K_theta_out[..., 13, 13, 14] = t1576
    K_theta_out[..., 13, 13, 18] = t1577
    K_theta_out[..., 13, 13, 19] = t1578
    K_theta_out[..., 13, 13, 20] = t1579
    K_theta_out[..., 13, 14, 0] = t1547
    K_theta_out[..., 13, 14, 1] = t1558
    K_theta_out[..., 13, 14, 2] = t1567
    K_theta_out[..., 13, 14, 12] = t1572
    K_theta_out[..., 13, 14, 13] = t1576
    K_theta_out[..., 13, 14, 14] = (
        D_delta_x_3_by_l_d_1*t1137 + D_delta_y_3_by_l_d_1*t1138 + D_delta_z_3_by_l_d_1*t1139
        - mu_1_by_l_d_1*t258 - mu_2_by_l_d_1*t258 + mu_3_by_l_d_1*t965
    )
    K_theta_out[..., 13, 14, 18] = t1580
    K_theta_out[..., 13, 14, 19] = t1581
    K_theta_out[..., 13, 14, 20] = t1582
    K_theta_out[..., 13, 15, 0] = t1548
    K_theta_out[..., 13, 15, 3] = t1543
    K_theta_out[..., 13, 15, 6] = t1544
    K_theta_out[..., 13, 15, 15] = t1548
    K_theta_out[..., 13, 18, 0] = t1549
    K_theta_out[..., 13, 18, 1] = t1559
    K_theta_out[..., 13, 18, 2] = t1568
    K_theta_out[..., 13, 18, 12] = t1573
    K_theta_out[..., 13, 18, 13] = t1577
    K_theta_out[..., 13, 18, 14] = t1580
    K_theta_out[..., 13, 19, 0] = t1550
    K_theta_out[..., 13, 19, 1] = t1560
    K_theta_out[..., 13, 19, 2] = t1569
    K_theta_out[..., 13, 19, 12] = t1574
    K_theta_out[..., 13, 19, 13] = t1578
    K_theta_out[..., 13, 19, 14] = t1581
    K_theta_out[..., 13, 20, 0] = t1551
    K_theta_out[..., 13, 20, 1] = t1561
    K_theta_out[..., 13, 20, 2] = t1570
    K_theta_out[..., 13, 20, 12] = t1575
    K_theta_out[..., 13, 20, 13] = t1579
    K_theta_out[..., 13, 20, 14] = t1582
    K_theta_out[..., 14, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_l_d_2*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_2*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_2*k_C
        + mu_1_by_l_d_2*t903 + mu_2_by_l_d_2*t904 + mu_3_by_l_d_2*t905 - t1011*t1583 - t1013*t1583
        - t1014*t1583 - t1015*t1584 - t1017*t1584 - t1018*t1584 - t1019*t1585 - t1021*t1585 - t1022*t1585
    )
    K_theta_out[..., 14, 0, 1] = t1586
    K_theta_out[..., 14, 0, 2] = t1587
    K_theta_out[..., 14, 0, 12] = t1588
    K_theta_out[..., 14, 0, 13] = t1589
    K_theta_out[..., 14, 0, 14] = t1590
    K_theta_out[..., 14, 0, 18] = t1591
    K_theta_out[..., 14, 0, 19] = t1592
    K_theta_out[..., 14, 0, 20] = t1593
    K_theta_out[..., 14, 1, 0] = t1586
    K_theta_out[..., 14, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_l_d_2*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_2*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_2*k_C
        + k_sp_2*t1263*t22*w_b_2*x_2_by_l_d_2 + mu_1_by_l_d_2*t926 + mu_2_by_l_d_2*t927 + mu_3_by_l_d_2*t928
        - t1027*t1594 - t1028*t1594 - t1029*t1594 - t1030*t1595 - t1031*t1595 - t1032*t1595 - t1033*t1596
        - t1034*t1596 - t1035*t1596 - t1597
    )
    K_theta_out[..., 14, 1, 2] = t1598
    K_theta_out[..., 14, 1, 4] = t1600
    K_theta_out[..., 14, 1, 7] = t1601
    K_theta_out[..., 14, 1, 12] = t1602
    K_theta_out[..., 14, 1, 13] = t1603
    K_theta_out[..., 14, 1, 14] = t1604
    K_theta_out[..., 14, 1, 16] = t1605
    K_theta_out[..., 14, 1, 18] = t1606
    K_theta_out[..., 14, 1, 19] = t1607
    K_theta_out[..., 14, 1, 20] = t1608
    K_theta_out[..., 14, 2, 0] = t1587
    K_theta_out[..., 14, 2, 1] = t1598
    K_theta_out[..., 14, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_l_d_2*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_2*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_2*k_C
        + mu_1_by_l_d_2*t945 + mu_2_by_l_d_2*t946 + mu_3_by_l_d_2*t947 - t1037*t1609 - t1038*t1609
        - t1039*t1609 - t1040*t1610 - t1041*t1610 - t1042*t1610 - t1043*t1611 - t1044*t1611 - t1045*t1611
    )
    K_theta_out[..., 14, 2, 12] = t1612
    K_theta_out[..., 14, 2, 13] = t1613
    K_theta_out[..., 14, 2, 14] = t1614
    K_theta_out[..., 14, 2, 18] = t1615
    K_theta_out[..., 14, 2, 19] = t1616
    K_theta_out[..., 14, 2, 20] = t1617
    K_theta_out[..., 14, 4, 1] = t1600
    K_theta_out[..., 14, 4, 4] = t1599*t462
    K_theta_out[..., 14, 4, 16] = t1600
    K_theta_out[..., 14, 7, 1] = t1601
    K_theta_out[..., 14, 7, 7] = -t1597*t462
    K_theta_out[..., 14, 7, 16] = t1601
    K_theta_out[..., 14, 12, 0] = t1588
    K_theta_out[..., 14, 12, 1] = t1602
    K_theta_out[..., 14, 12, 2] = t1612
    K_theta_out[..., 14, 12, 12] = (
        D_delta_x_1_by_l_d_2*t1113 + D_delta_y_1_by_l_d_2*t1114 + D_delta_z_1_by_l_d_2*t1115
        + mu_1_by_l_d_2*t960 - mu_2_by_l_d_2*t238 - mu_3_by_l_d_2*t238
    )
    K_theta_out[..., 14, 12, 13] = t1618
    K_theta_out[..., 14, 12, 14] = t1619
    K_theta_out[..., 14, 12, 18] = t1620
    K_theta_out[..., 14, 12, 19] = t1621
    K_theta_out[..., 14, 12, 20] = t1622
    K_theta_out[..., 14, 13, 0] = t1589
    K_theta_out[..., 14, 13, 1] = t1603
    K_theta_out[..., 14, 13, 2] = t1613
    K_theta_out[..., 14, 13, 12] = t1618
    K_theta_out[..., 14, 13, 13] = (
        D_delta_x_2_by_l_d_2*t1130 + D_delta_y_2_by_l_d_2*t1131 + D_delta_z_2_by_l_d_2*t1132
        - mu_1_by_l_d_2*t250 + mu_2_by_l_d_2*t963 - mu_3_by_l_d_2*t250
    )
    K_theta_out[..., 14, 13, 14] = t1623
    K_theta_out[..., 14, 13, 18] = t1624
    K_theta_out[..., 14, 13, 19] = t1625
    K_theta_out[..., 14, 13, 20] = t1626
    K_theta_out[..., 14, 14, 0] = t1590
    K_theta_out[..., 14, 14, 1] = t1604
    K_theta_out[..., 14, 14, 2] = t1614
    K_theta_out[..., 14, 14, 12] = t1619
    K_theta_out[..., 14, 14, 13] = t1623
    K_theta_out[..., 14, 14, 14] = (
        D_delta_x_3_by_l_d_2*t1137 + D_delta_y_3_by_l_d_2*t1138 + D_delta_z_3_by_l_d_2*t1139
        - mu_1_by_l_d_2*t258 - mu_2_by_l_d_2*t258 + mu_3_by_l_d_2*t965
    )
    K_theta_out[..., 14, 14, 18] = t1627
    K_theta_out[..., 14, 14, 19] = t1628
    K_theta_out[..., 14, 14, 20] = t1629
    K_theta_out[..., 14, 16, 1] = t1605
    K_theta_out[..., 14, 16, 4] = t1600
    K_theta_out[..., 14, 16, 7] = t1601
    K_theta_out[..., 14, 16, 16] = t1605
    K_theta_out[..., 14, 18, 0] = t1591
    K_theta_out[..., 14, 18, 1] = t1606
    K_theta_out[..., 14, 18, 2] = t1615
    K_theta_out[..., 14, 18, 12] = t1620
    K_theta_out[..., 14, 18, 13] = t1624
    K_theta_out[..., 14, 18, 14] = t1627
    K_theta_out[..., 14, 19, 0] = t1592
    K_theta_out[..., 14, 19, 1] = t1607
    K_theta_out[..., 14, 19, 2] = t1616
    K_theta_out[..., 14, 19, 12] = t1621
    K_theta_out[..., 14, 19, 13] = t1625
    K_theta_out[..., 14, 19, 14] = t1628
    K_theta_out[..., 14, 20, 0] = t1593
    K_theta_out[..., 14, 20, 1] = t1608
    K_theta_out[..., 14, 20, 2] = t1617
    K_theta_out[..., 14, 20, 12] = t1622
    K_theta_out[..., 14, 20, 13] = t1626
    K_theta_out[..., 14, 20, 14] = t1629
    K_theta_out[..., 15, 0, 0] = (
        2*D_p_x_1*D_p_x_1_by_l_d_3*k_C + 2*D_p_y_1*D_p_y_1_by_l_d_3*k_C + 2*D_p_z_1*D_p_z_1_by_l_d_3*k_C
        + mu_1_by_l_d_3*t903 + mu_2_by_l_d_3*t904 + mu_3_by_l_d_3*t905 - t1011*t1630 - t1013*t1630
        - t1014*t1630 - t1015*t1631 - t1017*t1631 - t1018*t1631 - t1019*t1632 - t1021*t1632 - t1022*t1632
    )
    K_theta_out[..., 15, 0, 1] = t1633
    K_theta_out[..., 15, 0, 2] = t1634
    K_theta_out[..., 15, 0, 12] = t1635
    K_theta_out[..., 15, 0, 13] = t1636
    K_theta_out[..., 15, 0, 14] = t1637
    K_theta_out[..., 15, 0, 18] = t1638
    K_theta_out[..., 15, 0, 19] = t1639
    K_theta_out[..., 15, 0, 20] = t1640
    K_theta_out[..., 15, 1, 0] = t1633
    K_theta_out[..., 15, 1, 1] = (
        2*D_p_x_2*D_p_x_2_by_l_d_3*k_C + 2*D_p_y_2*D_p_y_2_by_l_d_3*k_C + 2*D_p_z_2*D_p_z_2_by_l_d_3*k_C
        + mu_1_by_l_d_3*t926 + mu_2_by_l_d_3*t927 + mu_3_by_l_d_3*t928 - t1027*t1641 - t1028*t1641
        - t1029*t1641 - t1030*t1642 - t1031*t1642 - t1032*t1642 - t1033*t1643 - t1034*t1643 - t1035*t1643
    )
    K_theta_out[..., 15, 1, 2] = t1644
    K_theta_out[..., 15, 1, 12] = t1645
    K_theta_out[..., 15, 1, 13] = t1646
    K_theta_out[..., 15, 1, 14] = t1647
    K_theta_out[..., 15, 1, 18] = t1648
    K_theta_out[..., 15, 1, 19] = t1649
    K_theta_out[..., 15, 1, 20] = t1650
    K_theta_out[..., 15, 2, 0] = t1634
    K_theta_out[..., 15, 2, 1] = t1644
    K_theta_out[..., 15, 2, 2] = (
        2*D_p_x_3*D_p_x_3_by_l_d_3*k_C + 2*D_p_y_3*D_p_y_3_by_l_d_3*k_C + 2*D_p_z_3*D_p_z_3_by_l_d_3*k_C
        + k_sp_3*t1418*t33*w_b_3*x_3_by_l_d_3 + mu_1_by_l_d_3*t945 + mu_2_by_l_d_3*t946 + mu_3_by_l_d_3*t947
        - t1037*t1651 - t1038*t1651 - t1039*t1651 - t1040*t1652 - t1041*t1652 - t1042*t1652 - t1043*t1653
        - t1044*t1653 - t1045*t1653 - t1654
    )
    K_theta_out[..., 15, 2, 5] = t1656
    K_theta_out[..., 15, 2, 8] = t1657
    K_theta_out[..., 15, 2, 12] = t1658
    K_theta_out[..., 15, 2, 13] = t1659
    K_theta_out[..., 15, 2, 14] = t1660
    K_theta_out[..., 15, 2, 17] = t1661
    K_theta_out[..., 15, 2, 18] = t1662
    K_theta_out[..., 15, 2, 19] = t1663
    K_theta_out[..., 15, 2, 20] = t1664
    K_theta_out[..., 15, 5, 2] = t1656
    K_theta_out[..., 15, 5, 5] = t1655*t570
    K_theta_out[..., 15, 5, 17] = t1656
    K_theta_out[..., 15, 8, 2] = t1657
    K_theta_out[..., 15, 8, 8] = -t1654*t570
    K_theta_out[..., 15, 8, 17] = t1657
    K_theta_out[..., 15, 12, 0] = t1635
    K_theta_out[..., 15, 12, 1] = t1645
    K_theta_out[..., 15, 12, 2] = t1658
    K_theta_out[..., 15, 12, 12] = (
        D_delta_x_1_by_l_d_3*t1113 + D_delta_y_1_by_l_d_3*t1114 + D_delta_z_1_by_l_d_3*t1115
        + mu_1_by_l_d_3*t960 - mu_2_by_l_d_3*t238 - mu_3_by_l_d_3*t238
    )
    K_theta_out[..., 15, 12, 13] = t1665
    K_theta_out[..., 15, 12, 14] = t1666
    K_theta_out[..., 15, 12, 18] = t1667
    K_theta_out[..., 15, 12, 19] = t1668
    K_theta_out[..., 15, 12, 20] = t1669
    K_theta_out[..., 15, 13, 0] = t1636
    K_theta_out[..., 15, 13, 1] = t1646
    K_theta_out[..., 15, 13, 2] = t1659
    K_theta_out[..., 15, 13, 12] = t1665
    K_theta_out[..., 15, 13, 13] = (
        D_delta_x_2_by_l_d_3*t1130 + D_delta_y_2_by_l_d_3*t1131 + D_delta_z_2_by_l_d_3*t1132
        - mu_1_by_l_d_3*t250 + mu_2_by_l_d_3*t963 - mu_3_by_l_d_3*t250
    )
    K_theta_out[..., 15, 13, 14] = t1670
    K_theta_out[..., 15, 13, 18] = t1671
    K_theta_out[..., 15, 13, 19] = t1672
    K_theta_out[..., 15, 13, 20] = t1673
    K_theta_out[..., 15, 14, 0] = t1637
    K_theta_out[..., 15, 14, 1] = t1647
    K_theta_out[..., 15, 14, 2] = t1660
    K_theta_out[..., 15, 14, 12] = t1666
    K_theta_out[..., 15, 14, 13] = t1670
    K_theta_out[..., 15, 14, 14] = (
        D_delta_x_3_by_l_d_3*t1137 + D_delta_y_3_by_l_d_3*t1138 + D_delta_z_3_by_l_d_3*t1139
        - mu_1_by_l_d_3*t258 - mu_2_by_l_d_3*t258 + mu_3_by_l_d_3*t965
    )
    K_theta_out[..., 15, 14, 18] = t1674
    K_theta_out[..., 15, 14, 19] = t1675
    K_theta_out[..., 15, 14, 20] = t1676
    K_theta_out[..., 15, 17, 2] = t1661
    K_theta_out[..., 15, 17, 5] = t1656
    K_theta_out[..., 15, 17, 8] = t1657
    K_theta_out[..., 15, 17, 17] = t1661
    K_theta_out[..., 15, 18, 0] = t1638
    K_theta_out[..., 15, 18, 1] = t1648
    K_theta_out[..., 15, 18, 2] = t1662
    K_theta_out[..., 15, 18, 12] = t1667
    K_theta_out[..., 15, 18, 13] = t1671
    K_theta_out[..., 15, 18, 14] = t1674
    K_theta_out[..., 15, 19, 0] = t1639
    K_theta_out[..., 15, 19, 1] = t1649
    K_theta_out[..., 15, 19, 2] = t1663
    K_theta_out[..., 15, 19, 12] = t1668
    K_theta_out[..., 15, 19, 13] = t1672
    K_theta_out[..., 15, 19, 14] = t1675
    K_theta_out[..., 15, 20, 0] = t1640
    K_theta_out[..., 15, 20, 1] = t1650
    K_theta_out[..., 15, 20, 2] = t1664
    K_theta_out[..., 15, 20, 12] = t1669
    K_theta_out[..., 15, 20, 13] = t1673
    K_theta_out[..., 15, 20, 14] = t1676
    K_theta_out[..., 16, 0, 0] = mu_1_by_m_d_1*t903 + mu_2_by_m_d_1*t904 + mu_3_by_m_d_1*t905
    K_theta_out[..., 16, 0, 1] = t1677
    K_theta_out[..., 16, 0, 2] = t1678
    K_theta_out[..., 16, 0, 12] = t1679
    K_theta_out[..., 16, 0, 13] = t1680
    K_theta_out[..., 16, 0, 14] = t1681
    K_theta_out[..., 16, 1, 0] = t1677
    K_theta_out[..., 16, 1, 1] = mu_1_by_m_d_1*t926 + mu_2_by_m_d_1*t927 + mu_3_by_m_d_1*t928
    K_theta_out[..., 16, 1, 2] = t1682
    K_theta_out[..., 16, 1, 12] = t1683
    K_theta_out[..., 16, 1, 13] = t1684
    K_theta_out[..., 16, 1, 14] = t1685
    K_theta_out[..., 16, 2, 0] = t1678
    K_theta_out[..., 16, 2, 1] = t1682
    K_theta_out[..., 16, 2, 2] = mu_1_by_m_d_1*t945 + mu_2_by_m_d_1*t946 + mu_3_by_m_d_1*t947
    K_theta_out[..., 16, 2, 12] = t1686
    K_theta_out[..., 16, 2, 13] = t1687
    K_theta_out[..., 16, 2, 14] = t1688
    K_theta_out[..., 16, 12, 0] = t1679
    K_theta_out[..., 16, 12, 1] = t1683
    K_theta_out[..., 16, 12, 2] = t1686
    K_theta_out[..., 16, 12, 12] = mu_1_by_m_d_1*t960 - mu_2_by_m_d_1*t238 - mu_3_by_m_d_1*t238
    K_theta_out[..., 16, 12, 13] = t1689
    K_theta_out[..., 16, 12, 14] = t1690
    K_theta_out[..., 16, 13, 0] = t1680
    K_theta_out[..., 16, 13, 1] = t1684
    K_theta_out[..., 16, 13, 2] = t1687
    K_theta_out[..., 16, 13, 12] = t1689
    K_theta_out[..., 16, 13, 13] = -mu_1_by_m_d_1*t250 + mu_2_by_m_d_1*t963 - mu_3_by_m_d_1*t250
    K_theta_out[..., 16, 13, 14] = t1691
    K_theta_out[..., 16, 14, 0] = t1681
    K_theta_out[..., 16, 14, 1] = t1685
    K_theta_out[..., 16, 14, 2] = t1688
    K_theta_out[..., 16, 14, 12] = t1690
    K_theta_out[..., 16, 14, 13] = t1691
    K_theta_out[..., 16, 14, 14] = -mu_1_by_m_d_1*t258 - mu_2_by_m_d_1*t258 + mu_3_by_m_d_1*t965
    K_theta_out[..., 17, 0, 0] = mu_1_by_m_d_2*t903 + mu_2_by_m_d_2*t904 + mu_3_by_m_d_2*t905
    K_theta_out[..., 17, 0, 1] = t1692
    K_theta_out[..., 17, 0, 2] = t1693
    K_theta_out[..., 17, 0, 12] = t1694
    K_theta_out[..., 17, 0, 13] = t1695
    K_theta_out[..., 17, 0, 14] = t1696
    K_theta_out[..., 17, 1, 0] = t1692
    K_theta_out[..., 17, 1, 1] = mu_1_by_m_d_2*t926 + mu_2_by_m_d_2*t927 + mu_3_by_m_d_2*t928
    K_theta_out[..., 17, 1, 2] = t1697
    K_theta_out[..., 17, 1, 12] = t1698
    K_theta_out[..., 17, 1, 13] = t1699
    K_theta_out[..., 17, 1, 14] = t1700
    K_theta_out[..., 17, 2, 0] = t1693
    K_theta_out[..., 17, 2, 1] = t1697
    K_theta_out[..., 17, 2, 2] = mu_1_by_m_d_2*t945 + mu_2_by_m_d_2*t946 + mu_3_by_m_d_2*t947
    K_theta_out[..., 17, 2, 12] = t1701
    K_theta_out[..., 17, 2, 13] = t1702
    K_theta_out[..., 17, 2, 14] = t1703
    K_theta_out[..., 17, 12, 0] = t1694
    K_theta_out[..., 17, 12, 1] = t1698
    K_theta_out[..., 17, 12, 2] = t1701
    K_theta_out[..., 17, 12, 12] = mu_1_by_m_d_2*t960 - mu_2_by_m_d_2*t238 - mu_3_by_m_d_2*t238
    K_theta_out[..., 17, 12, 13] = t1704
    K_theta_out[..., 17, 12, 14] = t1705
    K_theta_out[..., 17, 13, 0] = t1695
    K_theta_out[..., 17, 13, 1] = t1699
    K_theta_out[..., 17, 13, 2] = t1702
    K_theta_out[..., 17, 13, 12] = t1704
    K_theta_out[..., 17, 13, 13] = -mu_1_by_m_d_2*t250 + mu_2_by_m_d_2*t963 - mu_3_by_m_d_2*t250
    K_theta_out[..., 17, 13, 14] = t1706
    K_theta_out[..., 17, 14, 0] = t1696
    K_theta_out[..., 17, 14, 1] = t1700
    K_theta_out[..., 17, 14, 2] = t1703
    K_theta_out[..., 17, 14, 12] = t1705
    K_theta_out[..., 17, 14, 13] = t1706
    K_theta_out[..., 17, 14, 14] = -mu_1_by_m_d_2*t258 - mu_2_by_m_d_2*t258 + mu_3_by_m_d_2*t965
    K_theta_out[..., 18, 0, 0] = mu_1_by_m_d_3*t903 + mu_2_by_m_d_3*t904 + mu_3_by_m_d_3*t905
    K_theta_out[..., 18, 0, 1] = t1707
    K_theta_out[..., 18, 0, 2] = t1708
    K_theta_out[..., 18, 0, 12] = t1709
    K_theta_out[..., 18, 0, 13] = t1710
    K_theta_out[..., 18, 0, 14] = t1711
    K_theta_out[..., 18, 1, 0] = t1707
    K_theta_out[..., 18, 1, 1] = mu_1_by_m_d_3*t926 + mu_2_by_m_d_3*t927 + mu_3_by_m_d_3*t928
    K_theta_out[..., 18, 1, 2] = t1712
    K_theta_out[..., 18, 1, 12] = t1713
    K_theta_out[..., 18, 1, 13] = t1714
    K_theta_out[..., 18, 1, 14] = t1715
    K_theta_out[..., 18, 2, 0] = t1708
    K_theta_out[..., 18, 2, 1] = t1712
    K_theta_out[..., 18, 2, 2] = mu_1_by_m_d_3*t945 + mu_2_by_m_d_3*t946 + mu_3_by_m_d_3*t947
    K_theta_out[..., 18, 2, 12] = t1716
    K_theta_out[..., 18, 2, 13] = t1717
    K_theta_out[..., 18, 2, 14] = t1718
    K_theta_out[..., 18, 12, 0] = t1709
    K_theta_out[..., 18, 12, 1] = t1713
    K_theta_out[..., 18, 12, 2] = t1716
    K_theta_out[..., 18, 12, 12] = mu_1_by_m_d_3*t960 - mu_2_by_m_d_3*t238 - mu_3_by_m_d_3*t238
    K_theta_out[..., 18, 12, 13] = t1719
    K_theta_out[..., 18, 12, 14] = t1720
    K_theta_out[..., 18, 13, 0] = t1710
    K_theta_out[..., 18, 13, 1] = t1714
    K_theta_out[..., 18, 13, 2] = t1717
    K_theta_out[..., 18, 13, 12] = t1719
    K_theta_out[..., 18, 13, 13] = -mu_1_by_m_d_3*t250 + mu_2_by_m_d_3*t963 - mu_3_by_m_d_3*t250
    K_theta_out[..., 18, 13, 14] = t1721
    K_theta_out[..., 18, 14, 0] = t1711
    K_theta_out[..., 18, 14, 1] = t1715
    K_theta_out[..., 18, 14, 2] = t1718
    K_theta_out[..., 18, 14, 12] = t1720
    K_theta_out[..., 18, 14, 13] = t1721
    K_theta_out[..., 18, 14, 14] = -mu_1_by_m_d_3*t258 - mu_2_by_m_d_3*t258 + mu_3_by_m_d_3*t965
    K_theta_out[..., 22, 0, 0] = t1724
    K_theta_out[..., 22, 0, 3] = t1725
    K_theta_out[..., 22, 0, 6] = t1726
    K_theta_out[..., 22, 0, 15] = t1724
    K_theta_out[..., 22, 3, 0] = t1725
    K_theta_out[..., 22, 3, 3] = t1723*t332
    K_theta_out[..., 22, 3, 15] = t1725
    K_theta_out[..., 22, 6, 0] = t1726
    K_theta_out[..., 22, 6, 6] = t1722*t332
    K_theta_out[..., 22, 6, 15] = t1726
    K_theta_out[..., 22, 15, 0] = t1724
    K_theta_out[..., 22, 15, 3] = t1725
    K_theta_out[..., 22, 15, 6] = t1726
    K_theta_out[..., 22, 15, 15] = t1724
    K_theta_out[..., 23, 1, 1] = t1729
    K_theta_out[..., 23, 1, 4] = t1730
    K_theta_out[..., 23, 1, 7] = t1731
    K_theta_out[..., 23, 1, 16] = t1729
    K_theta_out[..., 23, 4, 1] = t1730
    K_theta_out[..., 23, 4, 4] = t1728*t462
    K_theta_out[..., 23, 4, 16] = t1730
    K_theta_out[..., 23, 7, 1] = t1731
    K_theta_out[..., 23, 7, 7] = t1727*t462
    K_theta_out[..., 23, 7, 16] = t1731
    K_theta_out[..., 23, 16, 1] = t1729
    K_theta_out[..., 23, 16, 4] = t1730
    K_theta_out[..., 23, 16, 7] = t1731
    K_theta_out[..., 23, 16, 16] = t1729
    K_theta_out[..., 24, 2, 2] = t1734
    K_theta_out[..., 24, 2, 5] = t1735
    K_theta_out[..., 24, 2, 8] = t1736
    K_theta_out[..., 24, 2, 17] = t1734
    K_theta_out[..., 24, 5, 2] = t1735
    K_theta_out[..., 24, 5, 5] = t1733*t570
    K_theta_out[..., 24, 5, 17] = t1735
    K_theta_out[..., 24, 8, 2] = t1736
    K_theta_out[..., 24, 8, 8] = t1732*t570
    K_theta_out[..., 24, 8, 17] = t1736
    K_theta_out[..., 24, 17, 2] = t1734
    K_theta_out[..., 24, 17, 5] = t1735
    K_theta_out[..., 24, 17, 8] = t1736
    K_theta_out[..., 24, 17, 17] = t1734
    K_theta_out[..., 25, 0, 0] = t1745
    K_theta_out[..., 25, 0, 3] = t1746
    K_theta_out[..., 25, 0, 6] = t1747
    K_theta_out[..., 25, 0, 15] = t1745
    K_theta_out[..., 25, 3, 0] = t1746
    K_theta_out[..., 25, 3, 3] = -t1742*t332 + t1749
    K_theta_out[..., 25, 3, 6] = -t1749
    K_theta_out[..., 25, 3, 15] = t1746
    K_theta_out[..., 25, 6, 0] = t1747
    K_theta_out[..., 25, 6, 3] = -t1749
    K_theta_out[..., 25, 6, 6] = -t1744*t332 + t1749
    K_theta_out[..., 25, 6, 15] = t1747
    K_theta_out[..., 25, 15, 0] = t1745
    K_theta_out[..., 25, 15, 3] = t1746
    K_theta_out[..., 25, 15, 6] = t1747
    K_theta_out[..., 25, 15, 15] = t1745
    K_theta_out[..., 26, 1, 1] = t1758
    K_theta_out[..., 26, 1, 4] = t1759
    K_theta_out[..., 26, 1, 7] = t1760
    K_theta_out[..., 26, 1, 16] = t1758
    K_theta_out[..., 26, 4, 1] = t1759
    K_theta_out[..., 26, 4, 4] = -t1755*t462 + t1762
    K_theta_out[..., 26, 4, 7] = -t1762
    K_theta_out[..., 26, 4, 16] = t1759
    K_theta_out[..., 26, 7, 1] = t1760
    K_theta_out[..., 26, 7, 4] = -t1762
    K_theta_out[..., 26, 7, 7] = -t1757*t462 + t1762
    K_theta_out[..., 26, 7, 16] = t1760
    K_theta_out[..., 26, 16, 1] = t1758
    K_theta_out[..., 26, 16, 4] = t1759
    K_theta_out[..., 26, 16, 7] = t1760
    K_theta_out[..., 26, 16, 16] = t1758
    K_theta_out[..., 27, 2, 2] = t1771
    K_theta_out[..., 27, 2, 5] = t1772
    K_theta_out[..., 27, 2, 8] = t1773
    K_theta_out[..., 27, 2, 17] = t1771
    K_theta_out[..., 27, 5, 2] = t1772
    K_theta_out[..., 27, 5, 5] = -t1768*t570 + t1775
    K_theta_out[..., 27, 5, 8] = -t1775
    K_theta_out[..., 27, 5, 17] = t1772
    K_theta_out[..., 27, 8, 2] = t1773
    K_theta_out[..., 27, 8, 5] = -t1775
    K_theta_out[..., 27, 8, 8] = -t1770*t570 + t1775
    K_theta_out[..., 27, 8, 17] = t1773
    K_theta_out[..., 27, 17, 2] = t1771
    K_theta_out[..., 27, 17, 5] = t1772
    K_theta_out[..., 27, 17, 8] = t1773
    K_theta_out[..., 27, 17, 17] = t1771
    K_theta_out[..., 28, 0, 0] = t1783
    K_theta_out[..., 28, 0, 3] = t1784
    K_theta_out[..., 28, 0, 6] = t1785
    K_theta_out[..., 28, 0, 15] = t1783
    K_theta_out[..., 28, 3, 0] = t1784
    K_theta_out[..., 28, 3, 3] = -t1780*t332 + t1786
    K_theta_out[..., 28, 3, 6] = -t1786
    K_theta_out[..., 28, 3, 15] = t1784
    K_theta_out[..., 28, 6, 0] = t1785
    K_theta_out[..., 28, 6, 3] = -t1786
    K_theta_out[..., 28, 6, 6] = -t1782*t332 + t1786
    K_theta_out[..., 28, 6, 15] = t1785
    K_theta_out[..., 28, 15, 0] = t1783
    K_theta_out[..., 28, 15, 3] = t1784
    K_theta_out[..., 28, 15, 6] = t1785
    K_theta_out[..., 28, 15, 15] = t1783
    K_theta_out[..., 29, 1, 1] = t1794
    K_theta_out[..., 29, 1, 4] = t1795
    K_theta_out[..., 29, 1, 7] = t1796
    K_theta_out[..., 29, 1, 16] = t1794
    K_theta_out[..., 29, 4, 1] = t1795
    K_theta_out[..., 29, 4, 4] = -t1791*t462 + t1797
    K_theta_out[..., 29, 4, 7] = -t1797
    K_theta_out[..., 29, 4, 16] = t1795
    K_theta_out[..., 29, 7, 1] = t1796
    K_theta_out[..., 29, 7, 4] = -t1797
    K_theta_out[..., 29, 7, 7] = -t1793*t462 + t1797
    K_theta_out[..., 29, 7, 16] = t1796
    K_theta_out[..., 29, 16, 1] = t1794
    K_theta_out[..., 29, 16, 4] = t1795
    K_theta_out[..., 29, 16, 7] = t1796
    K_theta_out[..., 29, 16, 16] = t1794
    K_theta_out[..., 30, 2, 2] = t1805
    K_theta_out[..., 30, 2, 5] = t1806
    K_theta_out[..., 30, 2, 8] = t1807
    K_theta_out[..., 30, 2, 17] = t1805
    K_theta_out[..., 30, 5, 2] = t1806
    K_theta_out[..., 30, 5, 5] = -t1802*t570 + t1808
    K_theta_out[..., 30, 5, 8] = -t1808
    K_theta_out[..., 30, 5, 17] = t1806
    K_theta_out[..., 30, 8, 2] = t1807
    K_theta_out[..., 30, 8, 5] = -t1808
    K_theta_out[..., 30, 8, 8] = -t1804*t570 + t1808
    K_theta_out[..., 30, 8, 17] = t1807
    K_theta_out[..., 30, 17, 2] = t1805
    K_theta_out[..., 30, 17, 5] = t1806
    K_theta_out[..., 30, 17, 8] = t1807
    K_theta_out[..., 30, 17, 17] = t1805
    K_theta_out[..., 31, 0, 3] = -k_1_3
    K_theta_out[..., 31, 0, 6] = -k_1_2
    K_theta_out[..., 31, 3, 0] = -k_1_3
    K_theta_out[..., 31, 3, 3] = k_1_3*t1809 + t1810
    K_theta_out[..., 31, 3, 6] = -t1810
    K_theta_out[..., 31, 3, 15] = -k_1_3
    K_theta_out[..., 31, 6, 0] = -k_1_2
    K_theta_out[..., 31, 6, 3] = -t1810
    K_theta_out[..., 31, 6, 6] = k_1_2*t1809 + t1810
    K_theta_out[..., 31, 6, 15] = -k_1_2
    K_theta_out[..., 31, 15, 3] = -k_1_3
    K_theta_out[..., 31, 15, 6] = -k_1_2
    K_theta_out[..., 32, 1, 4] = -k_2_3
    K_theta_out[..., 32, 1, 7] = -k_2_2
    K_theta_out[..., 32, 4, 1] = -k_2_3
    K_theta_out[..., 32, 4, 4] = k_2_3*t1811 + t1812
    K_theta_out[..., 32, 4, 7] = -t1812
    K_theta_out[..., 32, 4, 16] = -k_2_3
    K_theta_out[..., 32, 7, 1] = -k_2_2
    K_theta_out[..., 32, 7, 4] = -t1812
    K_theta_out[..., 32, 7, 7] = k_2_2*t1811 + t1812
    K_theta_out[..., 32, 7, 16] = -k_2_2
    K_theta_out[..., 32, 16, 4] = -k_2_3
    K_theta_out[..., 32, 16, 7] = -k_2_2
    K_theta_out[..., 33, 2, 5] = -k_3_3
    K_theta_out[..., 33, 2, 8] = -k_3_2
    K_theta_out[..., 33, 5, 2] = -k_3_3
    K_theta_out[..., 33, 5, 5] = k_3_3*t1813 + t1814
    K_theta_out[..., 33, 5, 8] = -t1814
    K_theta_out[..., 33, 5, 17] = -k_3_3
    K_theta_out[..., 33, 8, 2] = -k_3_2
    K_theta_out[..., 33, 8, 5] = -t1814
    K_theta_out[..., 33, 8, 8] = k_3_2*t1813 + t1814
    K_theta_out[..., 33, 8, 17] = -k_3_2
    K_theta_out[..., 33, 17, 5] = -k_3_3
    K_theta_out[..., 33, 17, 8] = -k_3_2
    K_theta_out[..., 43, 0, 0] = t1024
    K_theta_out[..., 43, 0, 6] = t1815
    K_theta_out[..., 43, 0, 15] = t1024
    K_theta_out[..., 43, 3, 3] = t1817
    K_theta_out[..., 43, 3, 6] = -t1817
    K_theta_out[..., 43, 6, 0] = t1815
    K_theta_out[..., 43, 6, 3] = -t1817
    K_theta_out[..., 43, 6, 6] = t1024*t332 + t1817
    K_theta_out[..., 43, 6, 15] = t1815
    K_theta_out[..., 43, 15, 0] = t1024
    K_theta_out[..., 43, 15, 6] = t1815
    K_theta_out[..., 43, 15, 15] = t1024
    K_theta_out[..., 44, 1, 1] = t1261
    K_theta_out[..., 44, 1, 7] = t1818
    K_theta_out[..., 44, 1, 16] = t1261
    K_theta_out[..., 44, 4, 4] = t1820
    K_theta_out[..., 44, 4, 7] = -t1820
    K_theta_out[..., 44, 7, 1] = t1818
    K_theta_out[..., 44, 7, 4] = -t1820
    K_theta_out[..., 44, 7, 7] = t1261*t462 + t1820
    K_theta_out[..., 44, 7, 16] = t1818
    K_theta_out[..., 44, 16, 1] = t1261
    K_theta_out[..., 44, 16, 7] = t1818
    K_theta_out[..., 44, 16, 16] = t1261
    K_theta_out[..., 45, 2, 2] = t1416
    K_theta_out[..., 45, 2, 8] = t1821
    K_theta_out[..., 45, 2, 17] = t1416
    K_theta_out[..., 45, 5, 5] = t1823
    K_theta_out[..., 45, 5, 8] = -t1823
    K_theta_out[..., 45, 8, 2] = t1821
    K_theta_out[..., 45, 8, 5] = -t1823
    K_theta_out[..., 45, 8, 8] = t1416*t570 + t1823
    K_theta_out[..., 45, 8, 17] = t1821
    K_theta_out[..., 45, 17, 2] = t1416
    K_theta_out[..., 45, 17, 8] = t1821
    K_theta_out[..., 45, 17, 17] = t1416
    K_theta_out[..., 46, 0, 0] = -t1047
    K_theta_out[..., 46, 0, 3] = t1824
    K_theta_out[..., 46, 0, 15] = -t1047
    K_theta_out[..., 46, 3, 0] = t1824
    K_theta_out[..., 46, 3, 3] = -t1047*t332 - t1817
    K_theta_out[..., 46, 3, 6] = t1817
    K_theta_out[..., 46, 3, 15] = t1824
    K_theta_out[..., 46, 6, 3] = t1817
    K_theta_out[..., 46, 6, 6] = -t1817
    K_theta_out[..., 46, 15, 0] = -t1047
    K_theta_out[..., 46, 15, 3] = t1824
    K_theta_out[..., 46, 15, 15] = -t1047
    K_theta_out[..., 47, 1, 1] = -t1265
    K_theta_out[..., 47, 1, 4] = t1825
    K_theta_out[..., 47, 1, 16] = -t1265
    K_theta_out[..., 47, 4, 1] = t1825
    K_theta_out[..., 47, 4, 4] = -t1265*t462 - t1820
    K_theta_out[..., 47, 4, 7] = t1820
    K_theta_out[..., 47, 4, 16] = t1825
    K_theta_out[..., 47, 7, 4] = t1820
    K_theta_out[..., 47, 7, 7] = -t1820
    K_theta_out[..., 47, 16, 1] = -t1265
    K_theta_out[..., 47, 16, 4] = t1825
    K_theta_out[..., 47, 16, 16] = -t1265
    K_theta_out[..., 48, 2, 2] = -t1419
    K_theta_out[..., 48, 2, 5] = t1826
    K_theta_out[..., 48, 2, 17] = -t1419
    K_theta_out[..., 48, 5, 2] = t1826
    K_theta_out[..., 48, 5, 5] = -t1419*t570 - t1823
    K_theta_out[..., 48, 5, 8] = t1823
    K_theta_out[..., 48, 5, 17] = t1826
    K_theta_out[..., 48, 8, 5] = t1823
    K_theta_out[..., 48, 8, 8] = -t1823
    K_theta_out[..., 48, 17, 2] = -t1419
    K_theta_out[..., 48, 17, 5] = t1826
    K_theta_out[..., 48, 17, 17] = -t1419
    K_theta_out[..., 49, 0, 0] = t1831
    K_theta_out[..., 49, 0, 3] = t1832
    K_theta_out[..., 49, 0, 6] = t1833
    K_theta_out[..., 49, 0, 15] = t1831
    K_theta_out[..., 49, 3, 0] = t1832
    K_theta_out[..., 49, 3, 3] = -t1829*t332 + t1834
    K_theta_out[..., 49, 3, 6] = -t1834
    K_theta_out[..., 49, 3, 15] = t1832
    K_theta_out[..., 49, 6, 0] = t1833
    K_theta_out[..., 49, 6, 3] = -t1834
    K_theta_out[..., 49, 6, 6] = -t1830*t332 + t1834
    K_theta_out[..., 49, 6, 15] = t1833
    K_theta_out[..., 49, 15, 0] = t1831
    K_theta_out[..., 49, 15, 3] = t1832
    K_theta_out[..., 49, 15, 6] = t1833
    K_theta_out[..., 49, 15, 15] = t1831
    K_theta_out[..., 50, 1, 1] = t1839
    K_theta_out[..., 50, 1, 4] = t1840
    K_theta_out[..., 50, 1, 7] = t1841
    K_theta_out[..., 50, 1, 16] = t1839
    K_theta_out[..., 50, 4, 1] = t1840
    K_theta_out[..., 50, 4, 4] = -t1837*t462 + t1842
    K_theta_out[..., 50, 4, 7] = -t1842
    K_theta_out[..., 50, 4, 16] = t1840
    K_theta_out[..., 50, 7, 1] = t1841
    K_theta_out[..., 50, 7, 4] = -t1842
    K_theta_out[..., 50, 7, 7] = -t1838*t462 + t1842
    K_theta_out[..., 50, 7, 16] = t1841
    K_theta_out[..., 50, 16, 1] = t1839
    K_theta_out[..., 50, 16, 4] = t1840
    K_theta_out[..., 50, 16, 7] = t1841
    K_theta_out[..., 50, 16, 16] = t1839
    K_theta_out[..., 51, 2, 2] = t1847
    K_theta_out[..., 51, 2, 5] = t1848
    K_theta_out[..., 51, 2, 8] = t1849
    K_theta_out[..., 51, 2, 17] = t1847
    K_theta_out[..., 51, 5, 2] = t1848
    K_theta_out[..., 51, 5, 5] = -t1845*t570 + t1850
    K_theta_out[..., 51, 5, 8] = -t1850
    K_theta_out[..., 51, 5, 17] = t1848
    K_theta_out[..., 51, 8, 2] = t1849
    K_theta_out[..., 51, 8, 5] = -t1850
    K_theta_out[..., 51, 8, 8] = -t1846*t570 + t1850
    K_theta_out[..., 51, 8, 17] = t1849
    K_theta_out[..., 51, 17, 2] = t1847
    K_theta_out[..., 51, 17, 5] = t1848
    K_theta_out[..., 51, 17, 8] = t1849
    K_theta_out[..., 51, 17, 17] = t1847
    K_theta_out[..., 52, 0, 0] = t1854
    K_theta_out[..., 52, 0, 3] = t1855
    K_theta_out[..., 52, 0, 6] = t1856
    K_theta_out[..., 52, 0, 15] = t1854
    K_theta_out[..., 52, 1, 1] = t1860
    K_theta_out[..., 52, 1, 4] = t1861
    K_theta_out[..., 52, 1, 7] = t1862
    K_theta_out[..., 52, 1, 16] = t1860
    K_theta_out[..., 52, 2, 2] = t1866
    K_theta_out[..., 52, 2, 5] = t1867
    K_theta_out[..., 52, 2, 8] = t1868
    K_theta_out[..., 52, 2, 17] = t1866
    K_theta_out[..., 52, 3, 0] = t1855
    K_theta_out[..., 52, 3, 3] = -t1853*t332 - t1869
    K_theta_out[..., 52, 3, 6] = t1869
    K_theta_out[..., 52, 3, 15] = t1855
    K_theta_out[..., 52, 4, 1] = t1861
    K_theta_out[..., 52, 4, 4] = -t1859*t462 - t1870
    K_theta_out[..., 52, 4, 7] = t1870
    K_theta_out[..., 52, 4, 16] = t1861
    K_theta_out[..., 52, 5, 2] = t1867
    K_theta_out[..., 52, 5, 5] = -t1865*t570 - t1871
    K_theta_out[..., 52, 5, 8] = t1871
    K_theta_out[..., 52, 5, 17] = t1867
    K_theta_out[..., 52, 6, 0] = t1856
    K_theta_out[..., 52, 6, 3] = t1869
    K_theta_out[..., 52, 6, 6] = -t1852*t332 - t1869
    K_theta_out[..., 52, 6, 15] = t1856
    K_theta_out[..., 52, 7, 1] = t1862
    K_theta_out[..., 52, 7, 4] = t1870
    K_theta_out[..., 52, 7, 7] = -t1858*t462 - t1870
    K_theta_out[..., 52, 7, 16] = t1862
    K_theta_out[..., 52, 8, 2] = t1868
    K_theta_out[..., 52, 8, 5] = t1871
    K_theta_out[..., 52, 8, 8] = -t1864*t570 - t1871
    K_theta_out[..., 52, 8, 17] = t1868
    K_theta_out[..., 52, 15, 0] = t1854
    K_theta_out[..., 52, 15, 3] = t1855
    K_theta_out[..., 52, 15, 6] = t1856
    K_theta_out[..., 52, 15, 15] = t1854
    K_theta_out[..., 52, 16, 1] = t1860
    K_theta_out[..., 52, 16, 4] = t1861
    K_theta_out[..., 52, 16, 7] = t1862
    K_theta_out[..., 52, 16, 16] = t1860
    K_theta_out[..., 52, 17, 2] = t1866
    K_theta_out[..., 52, 17, 5] = t1867
    K_theta_out[..., 52, 17, 8] = t1868
    K_theta_out[..., 52, 17, 17] = t1866
    K_theta_out[..., 54, 0, 0] = t178
    K_theta_out[..., 54, 0, 1] = t182
    K_theta_out[..., 54, 0, 2] = t186
    K_theta_out[..., 54, 0, 12] = t190
    K_theta_out[..., 54, 0, 13] = t194
    K_theta_out[..., 54, 0, 14] = t198
    K_theta_out[..., 54, 0, 18] = D_p_x_1
    K_theta_out[..., 54, 0, 19] = D_p_y_1
    K_theta_out[..., 54, 0, 20] = D_p_z_1
    K_theta_out[..., 54, 1, 0] = t182
    K_theta_out[..., 54, 1, 1] = t202
    K_theta_out[..., 54, 1, 2] = t206
    K_theta_out[..., 54, 1, 12] = t210
    K_theta_out[..., 54, 1, 13] = t214
    K_theta_out[..., 54, 1, 14] = t218
    K_theta_out[..., 54, 1, 18] = D_p_x_2
    K_theta_out[..., 54, 1, 19] = D_p_y_2
    K_theta_out[..., 54, 1, 20] = D_p_z_2
    K_theta_out[..., 54, 2, 0] = t186
    K_theta_out[..., 54, 2, 1] = t206
    K_theta_out[..., 54, 2, 2] = t222
    K_theta_out[..., 54, 2, 12] = t226
    K_theta_out[..., 54, 2, 13] = t230
    K_theta_out[..., 54, 2, 14] = t234
    K_theta_out[..., 54, 2, 18] = D_p_x_3
    K_theta_out[..., 54, 2, 19] = D_p_y_3
    K_theta_out[..., 54, 2, 20] = D_p_z_3
    K_theta_out[..., 54, 12, 0] = t190
    K_theta_out[..., 54, 12, 1] = t210
    K_theta_out[..., 54, 12, 2] = t226
    K_theta_out[..., 54, 12, 12] = t238
    K_theta_out[..., 54, 12, 13] = t242
    K_theta_out[..., 54, 12, 14] = t246
    K_theta_out[..., 54, 12, 18] = D_delta_x_1
    K_theta_out[..., 54, 12, 19] = D_delta_y_1
    K_theta_out[..., 54, 12, 20] = D_delta_z_1
    K_theta_out[..., 54, 13, 0] = t194
    K_theta_out[..., 54, 13, 1] = t214
    K_theta_out[..., 54, 13, 2] = t230
    K_theta_out[..., 54, 13, 12] = t242
    K_theta_out[..., 54, 13, 13] = t250
    K_theta_out[..., 54, 13, 14] = t254
    K_theta_out[..., 54, 13, 18] = D_delta_x_2
    K_theta_out[..., 54, 13, 19] = D_delta_y_2
    K_theta_out[..., 54, 13, 20] = D_delta_z_2
    K_theta_out[..., 54, 14, 0] = t198
    K_theta_out[..., 54, 14, 1] = t218
    K_theta_out[..., 54, 14, 2] = t234
    K_theta_out[..., 54, 14, 12] = t246
    K_theta_out[..., 54, 14, 13] = t254
    K_theta_out[..., 54, 14, 14] = t258
    K_theta_out[..., 54, 14, 18] = D_delta_x_3
    K_theta_out[..., 54, 14, 19] = D_delta_y_3
    K_theta_out[..., 54, 14, 20] = D_delta_z_3
    K_theta_out[..., 54, 18, 0] = D_p_x_1
    K_theta_out[..., 54, 18, 1] = D_p_x_2
    K_theta_out[..., 54, 18, 2] = D_p_x_3
    K_theta_out[..., 54, 18, 12] = D_delta_x_1
    K_theta_out[..., 54, 18, 13] = D_delta_x_2
    K_theta_out[..., 54, 18, 14] = D_delta_x_3
    K_theta_out[..., 54, 18, 18] = 1
    K_theta_out[..., 54, 19, 0] = D_p_y_1
    K_theta_out[..., 54, 19, 1] = D_p_y_2
    K_theta_out[..., 54, 19, 2] = D_p_y_3
    K_theta_out[..., 54, 19, 12] = D_delta_y_1
    K_theta_out[..., 54, 19, 13] = D_delta_y_2
    K_theta_out[..., 54, 19, 14] = D_delta_y_3
    K_theta_out[..., 54, 19, 19] = 1
    K_theta_out[..., 54, 20, 0] = D_p_z_1
    K_theta_out[..., 54, 20, 1] = D_p_z_2
    K_theta_out[..., 54, 20, 2] = D_p_z_3
    K_theta_out[..., 54, 20, 12] = D_delta_z_1
    K_theta_out[..., 54, 20, 13] = D_delta_z_2
    K_theta_out[..., 54, 20, 14] = D_delta_z_3
    K_theta_out[..., 54, 20, 20] = 1
    K_theta_out[..., 56, 0, 0] = mu_1_by_m_L*t903 + mu_2_by_m_L*t904 + mu_3_by_m_L*t905
    K_theta_out[..., 56, 0, 1] = t1872
    K_theta_out[..., 56, 0, 2] = t1873
    K_theta_out[..., 56, 0, 12] = t1874
    K_theta_out[..., 56, 0, 13] = t1875
    K_theta_out[..., 56, 0, 14] = t1876
    K_theta_out[..., 56, 1, 0] = t1872
    K_theta_out[..., 56, 1, 1] = mu_1_by_m_L*t926 + mu_2_by_m_L*t927 + mu_3_by_m_L*t928
    K_theta_out[..., 56, 1, 2] = t1877
    K_theta_out[..., 56, 1, 12] = t1878
    K_theta_out[..., 56, 1, 13] = t1879
    K_theta_out[..., 56, 1, 14] = t1880
    K_theta_out[..., 56, 2, 0] = t1873
    K_theta_out[..., 56, 2, 1] = t1877
    K_theta_out[..., 56, 2, 2] = mu_1_by_m_L*t945 + mu_2_by_m_L*t946 + mu_3_by_m_L*t947
    K_theta_out[..., 56, 2, 12] = t1881
    K_theta_out[..., 56, 2, 13] = t1882
    K_theta_out[..., 56, 2, 14] = t1883
    K_theta_out[..., 56, 12, 0] = t1874
    K_theta_out[..., 56, 12, 1] = t1878
    K_theta_out[..., 56, 12, 2] = t1881
    K_theta_out[..., 56, 12, 12] = mu_1_by_m_L*t960 - mu_2_by_m_L*t238 - mu_3_by_m_L*t238
    K_theta_out[..., 56, 12, 13] = t1884
    K_theta_out[..., 56, 12, 14] = t1885
    K_theta_out[..., 56, 13, 0] = t1875
    K_theta_out[..., 56, 13, 1] = t1879
    K_theta_out[..., 56, 13, 2] = t1882
    K_theta_out[..., 56, 13, 12] = t1884
    K_theta_out[..., 56, 13, 13] = -mu_1_by_m_L*t250 + mu_2_by_m_L*t963 - mu_3_by_m_L*t250
    K_theta_out[..., 56, 13, 14] = t1886
    K_theta_out[..., 56, 14, 0] = t1876
    K_theta_out[..., 56, 14, 1] = t1880
    K_theta_out[..., 56, 14, 2] = t1883
    K_theta_out[..., 56, 14, 12] = t1885
    K_theta_out[..., 56, 14, 13] = t1886
    K_theta_out[..., 56, 14, 14] = -mu_1_by_m_L*t258 - mu_2_by_m_L*t258 + mu_3_by_m_L*t965
    K_theta_out[..., 57, 3, 3] = d_1_1
    K_theta_out[..., 57, 4, 4] = d_2_1
    K_theta_out[..., 57, 5, 5] = d_3_1
    K_theta_out[..., 57, 6, 6] = d_1_2
    K_theta_out[..., 57, 7, 7] = d_2_2
    K_theta_out[..., 57, 8, 8] = d_3_2
    return M_theta_out, K_theta_out
