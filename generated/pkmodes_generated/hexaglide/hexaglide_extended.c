/* Generated from the derivation of hexaglide and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism hexaglide with effects: extended matrices and sensitivities.
 * The header describes every function.
 *
 * Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; belt span s; component i = x,
 * y, z; rows r of a minor; columns c of a minor; axis a of the platform.  t1, t2, ... are subexpressions
 * shared by several values.
 *   half_angle [rad]: half the angle of rotation
 *   s_half [1]: sine of half the angle over half the angle
 *   c_half [1]: cosine of half the angle
 *   R_i_a [1]: rotation matrix of the platform: component i of its axis a
 *   x_j [m]: position of carriage j along its rail
 *   B_j_i [m]: platform joint j from the platform's origin, base frame, component i
 *   r_j_i [m]: platform joint j relative to the origin of rail j, component i
 *   s_j_i [m]: linkage vector j, from carriage to platform joint, component i
 *   a_j [m]: coordinate of platform joint j along rail j
 *   w_j_i [m]: vector from rail j to platform joint j, perpendicular to it, component i
 *   w2_j [m^2]: squared distance of platform joint j from rail j
 *   c_i [m]: centre of mass of the platform from its origin, component i
 *   J_i_a [kg m^2]: inertia tensor of the platform about its centre of mass, base frame, entry ia
 *   tau_st_j [N m]: static torque on the driven pulley of axis j
 *   I_j_k [kg m^2]: moment of inertia of pulley k of axis j, including the motor if it is driven
 *   l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
 *     carriage to pulley 1)
 *   k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
 *     carriage to pulley 1)
 *   o_L_i [m]: payload from the platform's origin, base frame, component i
 *   D_l_j_i [m^2]: moment of linkage vector j about the platform's origin, component i
 *   D_r_j [m]: entry of D_r for axis j: component of linkage vector along the motion of its joint
 *   A_i_j [m^8]: adjugate of D_l, entry i, j
 *   minor_r_c [m^2]: minor of D_l, rows r and columns c
 *   minor_r_c [m^4]: minor of D_l, rows r and columns c
 *   minor_r_c [m^6]: minor of D_l, rows r and columns c
 *   minor_r_c [m^3]: minor of D_l, rows r and columns c
 *   minor_r_c [m^5]: minor of D_l, rows r and columns c
 *   A_i_j [m^7]: adjugate of D_l, entry i, j
 *   det_D_l [m^9]: determinant of D_l
 *   D_p_i_k [1]: platform Jacobian, dp_i/dx_k
 *   D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
 *   D_p_i_k [1/m]: platform Jacobian, dp_i/dx_k
 *   D_delta_i_k [1/m]: platform Jacobian, dp_i/ddelta_k
 *   G_p_i [N]: gradient of the gravitational potential energy with respect to the platform, component i
 *   G_p_i [N m]: gradient of the gravitational potential energy with respect to the platform, component i
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 *   g_j_i [N]: derivative of gravity and closures with respect to vector j that turns, component i
 *   L_i_a [N/m]: second derivative of gravity and closures with respect to the platform, entry i, a
 *   L_i_a [N]: second derivative of gravity and closures with respect to the platform, entry i, a
 *   L_i_a [N m]: second derivative of gravity and closures with respect to the platform, entry i, a
 *   f_i_k [N/m]: force on the platform along i per unit of coordinate k
 *   f_i_k [N]: force on the platform along i per unit of coordinate k
 *   G_j [N]: gradient of the gravitational potential energy with respect to x_j
 *   det_j [N^2 m]: determinant of the equilibrium equations of axis j
 *   theta_j_k_st [rad]: static rotation of pulley k of axis j, relative to the unstrained transmissions
 *   M_p_i_a [kg]: apparent mass of the platform, entry i, a
 *   M_p_i_a [kg m]: apparent mass of the platform, entry i, a
 *   M_p_i_a [kg m^2]: apparent mass of the platform, entry i, a
 *   h_i_k [kg]: momentum of the platform along i per unit rate of coordinate k
 *   h_i_k [kg m]: momentum of the platform along i per unit rate of coordinate k
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "hexaglide_extended.h"

#include <math.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void hexaglide_extended_extended_matrices(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    const hexaglide_effects *effects, pkmodes_real M[39][39], pkmodes_real K_el[39][39],
    pkmodes_real K_g[39][39])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real m_p = parameters->platform_mass;
    const pkmodes_real c_p_x = parameters->platform_center[0];
    const pkmodes_real c_p_y = parameters->platform_center[1];
    const pkmodes_real c_p_z = parameters->platform_center[2];
    const pkmodes_real I_p_x = parameters->platform_inertia[0];
    const pkmodes_real I_p_y = parameters->platform_inertia[1];
    const pkmodes_real I_p_z = parameters->platform_inertia[2];
    const pkmodes_real I_p_xy = parameters->platform_products[0];
    const pkmodes_real I_p_xz = parameters->platform_products[1];
    const pkmodes_real I_p_yz = parameters->platform_products[2];
    const pkmodes_real g_x = parameters->gravity[0];
    const pkmodes_real g_y = parameters->gravity[1];
    const pkmodes_real g_z = parameters->gravity[2];
    const pkmodes_real o_1_x = parameters->origin[0][0];
    const pkmodes_real o_1_y = parameters->origin[0][1];
    const pkmodes_real o_1_z = parameters->origin[0][2];
    const pkmodes_real o_2_x = parameters->origin[1][0];
    const pkmodes_real o_2_y = parameters->origin[1][1];
    const pkmodes_real o_2_z = parameters->origin[1][2];
    const pkmodes_real o_3_x = parameters->origin[2][0];
    const pkmodes_real o_3_y = parameters->origin[2][1];
    const pkmodes_real o_3_z = parameters->origin[2][2];
    const pkmodes_real o_4_x = parameters->origin[3][0];
    const pkmodes_real o_4_y = parameters->origin[3][1];
    const pkmodes_real o_4_z = parameters->origin[3][2];
    const pkmodes_real o_5_x = parameters->origin[4][0];
    const pkmodes_real o_5_y = parameters->origin[4][1];
    const pkmodes_real o_5_z = parameters->origin[4][2];
    const pkmodes_real o_6_x = parameters->origin[5][0];
    const pkmodes_real o_6_y = parameters->origin[5][1];
    const pkmodes_real o_6_z = parameters->origin[5][2];
    const pkmodes_real n_1_x = parameters->direction[0][0];
    const pkmodes_real n_1_y = parameters->direction[0][1];
    const pkmodes_real n_1_z = parameters->direction[0][2];
    const pkmodes_real n_2_x = parameters->direction[1][0];
    const pkmodes_real n_2_y = parameters->direction[1][1];
    const pkmodes_real n_2_z = parameters->direction[1][2];
    const pkmodes_real n_3_x = parameters->direction[2][0];
    const pkmodes_real n_3_y = parameters->direction[2][1];
    const pkmodes_real n_3_z = parameters->direction[2][2];
    const pkmodes_real n_4_x = parameters->direction[3][0];
    const pkmodes_real n_4_y = parameters->direction[3][1];
    const pkmodes_real n_4_z = parameters->direction[3][2];
    const pkmodes_real n_5_x = parameters->direction[4][0];
    const pkmodes_real n_5_y = parameters->direction[4][1];
    const pkmodes_real n_5_z = parameters->direction[4][2];
    const pkmodes_real n_6_x = parameters->direction[5][0];
    const pkmodes_real n_6_y = parameters->direction[5][1];
    const pkmodes_real n_6_z = parameters->direction[5][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real b_4_x = parameters->joint[3][0];
    const pkmodes_real b_4_y = parameters->joint[3][1];
    const pkmodes_real b_4_z = parameters->joint[3][2];
    const pkmodes_real b_5_x = parameters->joint[4][0];
    const pkmodes_real b_5_y = parameters->joint[4][1];
    const pkmodes_real b_5_z = parameters->joint[4][2];
    const pkmodes_real b_6_x = parameters->joint[5][0];
    const pkmodes_real b_6_y = parameters->joint[5][1];
    const pkmodes_real b_6_z = parameters->joint[5][2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real l_d_4 = parameters->link_length[3];
    const pkmodes_real l_d_5 = parameters->link_length[4];
    const pkmodes_real l_d_6 = parameters->link_length[5];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real m_d_4 = parameters->link_mass[3];
    const pkmodes_real m_d_5 = parameters->link_mass[4];
    const pkmodes_real m_d_6 = parameters->link_mass[5];
    const pkmodes_real m_t_1 = parameters->carriage_mass[0];
    const pkmodes_real m_t_2 = parameters->carriage_mass[1];
    const pkmodes_real m_t_3 = parameters->carriage_mass[2];
    const pkmodes_real m_t_4 = parameters->carriage_mass[3];
    const pkmodes_real m_t_5 = parameters->carriage_mass[4];
    const pkmodes_real m_t_6 = parameters->carriage_mass[5];
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real l_t_4 = parameters->carriage_length[3];
    const pkmodes_real l_t_5 = parameters->carriage_length[4];
    const pkmodes_real l_t_6 = parameters->carriage_length[5];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real k_sp_3 = parameters->belt_specific_stiffness[2];
    const pkmodes_real k_sp_4 = parameters->belt_specific_stiffness[3];
    const pkmodes_real k_sp_5 = parameters->belt_specific_stiffness[4];
    const pkmodes_real k_sp_6 = parameters->belt_specific_stiffness[5];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real w_b_3 = parameters->belt_width[2];
    const pkmodes_real w_b_4 = parameters->belt_width[3];
    const pkmodes_real w_b_5 = parameters->belt_width[4];
    const pkmodes_real w_b_6 = parameters->belt_width[5];
    const pkmodes_real R_p_1 = parameters->pulley_radius[0];
    const pkmodes_real R_p_2 = parameters->pulley_radius[1];
    const pkmodes_real R_p_3 = parameters->pulley_radius[2];
    const pkmodes_real R_p_4 = parameters->pulley_radius[3];
    const pkmodes_real R_p_5 = parameters->pulley_radius[4];
    const pkmodes_real R_p_6 = parameters->pulley_radius[5];
    const pkmodes_real I_p_1 = parameters->pulley_inertia[0];
    const pkmodes_real I_p_2 = parameters->pulley_inertia[1];
    const pkmodes_real I_p_3 = parameters->pulley_inertia[2];
    const pkmodes_real I_p_4 = parameters->pulley_inertia[3];
    const pkmodes_real I_p_5 = parameters->pulley_inertia[4];
    const pkmodes_real I_p_6 = parameters->pulley_inertia[5];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real I_m_3 = parameters->motor_inertia[2];
    const pkmodes_real I_m_4 = parameters->motor_inertia[3];
    const pkmodes_real I_m_5 = parameters->motor_inertia[4];
    const pkmodes_real I_m_6 = parameters->motor_inertia[5];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real i_g_3 = parameters->gear_ratio[2];
    const pkmodes_real i_g_4 = parameters->gear_ratio[3];
    const pkmodes_real i_g_5 = parameters->gear_ratio[4];
    const pkmodes_real i_g_6 = parameters->gear_ratio[5];
    const pkmodes_real d_1_1 = parameters->drive[0][0];
    const pkmodes_real d_1_2 = parameters->drive[0][1];
    const pkmodes_real d_2_1 = parameters->drive[1][0];
    const pkmodes_real d_2_2 = parameters->drive[1][1];
    const pkmodes_real d_3_1 = parameters->drive[2][0];
    const pkmodes_real d_3_2 = parameters->drive[2][1];
    const pkmodes_real d_4_1 = parameters->drive[3][0];
    const pkmodes_real d_4_2 = parameters->drive[3][1];
    const pkmodes_real d_5_1 = parameters->drive[4][0];
    const pkmodes_real d_5_2 = parameters->drive[4][1];
    const pkmodes_real d_6_1 = parameters->drive[5][0];
    const pkmodes_real d_6_2 = parameters->drive[5][1];
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
    const pkmodes_real x_min_4 = parameters->limits[3][0];
    const pkmodes_real x_max_4 = parameters->limits[3][1];
    const pkmodes_real x_min_5 = parameters->limits[4][0];
    const pkmodes_real x_max_5 = parameters->limits[4][1];
    const pkmodes_real x_min_6 = parameters->limits[5][0];
    const pkmodes_real x_max_6 = parameters->limits[5][1];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real sigma_4 = parameters->branch[3];
    const pkmodes_real sigma_5 = parameters->branch[4];
    const pkmodes_real sigma_6 = parameters->branch[5];
    const pkmodes_real a_B_1 = effects->axis_belt_stiffness_factor_1;
    const pkmodes_real a_B_2 = effects->axis_belt_stiffness_factor_2;
    const pkmodes_real a_B_3 = effects->axis_belt_stiffness_factor_3;
    const pkmodes_real a_B_4 = effects->axis_belt_stiffness_factor_4;
    const pkmodes_real a_B_5 = effects->axis_belt_stiffness_factor_5;
    const pkmodes_real a_B_6 = effects->axis_belt_stiffness_factor_6;
    const pkmodes_real c_E = effects->belt_end_compliance_compliance;
    const pkmodes_real rho_b = effects->belt_mass_linear_density;
    const pkmodes_real c_T = effects->belt_tension_stiffness_coefficient;
    const pkmodes_real F_T = effects->belt_tension_stiffness_tension;
    const pkmodes_real k_C = effects->cable_stiffness_stiffness;
    const pkmodes_real I_G = effects->gearbox_inertia_inertia;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real b_L_x = effects->payload_offset_x;
    const pkmodes_real b_L_y = effects->payload_offset_y;
    const pkmodes_real b_L_z = effects->payload_offset_z;
    const pkmodes_real k_S = effects->servo_stiffness_stiffness;
    const pkmodes_real m_F = effects->frame_compliance_mass;
    const pkmodes_real t1 = (rot_x*rot_x);
    const pkmodes_real t2 = (rot_y*rot_y);
    const pkmodes_real t3 = (rot_z*rot_z);
    const pkmodes_real t4 = t2 + t3;
    const pkmodes_real half_angle = (R(1.0)/R(2.0))*R(sqrt)(t1 + t4 + R(1e-30));
    const pkmodes_real s_half = R(sin)(half_angle)/half_angle;
    const pkmodes_real t5 = (s_half*s_half);
    const pkmodes_real t6 = (R(1.0)/R(2.0))*t5;
    const pkmodes_real R_x_x = -t4*t6 + 1;
    const pkmodes_real c_half = R(cos)(half_angle);
    const pkmodes_real t7 = c_half*s_half;
    const pkmodes_real t8 = rot_z*t7;
    const pkmodes_real R_x_y = (R(1.0)/R(2.0))*rot_x*rot_y*t5 - t8;
    const pkmodes_real t9 = rot_y*t7;
    const pkmodes_real t10 = rot_x*t6;
    const pkmodes_real R_x_z = rot_z*t10 + t9;
    const pkmodes_real B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const pkmodes_real r_1_x = B_1_x - o_1_x + p_x;
    const pkmodes_real R_y_x = rot_y*t10 + t8;
    const pkmodes_real R_y_y = t6*(-t1 - t3) + 1;
    const pkmodes_real t11 = rot_x*t7;
    const pkmodes_real R_y_z = (R(1.0)/R(2.0))*rot_y*rot_z*t5 - t11;
    const pkmodes_real B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const pkmodes_real r_1_y = B_1_y - o_1_y + p_y;
    const pkmodes_real R_z_x = (R(1.0)/R(2.0))*rot_x*rot_z*t5 - t9;
    const pkmodes_real R_z_y = rot_y*rot_z*t6 + t11;
    const pkmodes_real R_z_z = t6*(-t1 - t2) + 1;
    const pkmodes_real B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const pkmodes_real r_1_z = B_1_z - o_1_z + p_z;
    const pkmodes_real B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const pkmodes_real r_2_x = B_2_x - o_2_x + p_x;
    const pkmodes_real B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const pkmodes_real r_2_y = B_2_y - o_2_y + p_y;
    const pkmodes_real B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const pkmodes_real r_2_z = B_2_z - o_2_z + p_z;
    const pkmodes_real B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const pkmodes_real r_3_x = B_3_x - o_3_x + p_x;
    const pkmodes_real B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const pkmodes_real r_3_y = B_3_y - o_3_y + p_y;
    const pkmodes_real B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const pkmodes_real r_3_z = B_3_z - o_3_z + p_z;
    const pkmodes_real B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const pkmodes_real r_4_x = B_4_x - o_4_x + p_x;
    const pkmodes_real B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const pkmodes_real r_4_y = B_4_y - o_4_y + p_y;
    const pkmodes_real B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const pkmodes_real r_4_z = B_4_z - o_4_z + p_z;
    const pkmodes_real B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const pkmodes_real r_5_x = B_5_x - o_5_x + p_x;
    const pkmodes_real B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const pkmodes_real r_5_y = B_5_y - o_5_y + p_y;
    const pkmodes_real B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const pkmodes_real r_5_z = B_5_z - o_5_z + p_z;
    const pkmodes_real B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const pkmodes_real r_6_x = B_6_x - o_6_x + p_x;
    const pkmodes_real B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const pkmodes_real r_6_y = B_6_y - o_6_y + p_y;
    const pkmodes_real B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const pkmodes_real r_6_z = B_6_z - o_6_z + p_z;
    const pkmodes_real a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z;
    const pkmodes_real w_1_x = -a_1*n_1_x + r_1_x;
    const pkmodes_real w_1_y = -a_1*n_1_y + r_1_y;
    const pkmodes_real w_1_z = -a_1*n_1_z + r_1_z;
    const pkmodes_real w2_1 = (w_1_x*w_1_x) + (w_1_y*w_1_y) + (w_1_z*w_1_z);
    const pkmodes_real x_1 = a_1 + sigma_1*R(sqrt)((l_d_1*l_d_1) - w2_1);
    const pkmodes_real a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const pkmodes_real w_2_x = -a_2*n_2_x + r_2_x;
    const pkmodes_real w_2_y = -a_2*n_2_y + r_2_y;
    const pkmodes_real w_2_z = -a_2*n_2_z + r_2_z;
    const pkmodes_real w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const pkmodes_real x_2 = a_2 + sigma_2*R(sqrt)((l_d_2*l_d_2) - w2_2);
    const pkmodes_real a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const pkmodes_real w_3_x = -a_3*n_3_x + r_3_x;
    const pkmodes_real w_3_y = -a_3*n_3_y + r_3_y;
    const pkmodes_real w_3_z = -a_3*n_3_z + r_3_z;
    const pkmodes_real w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const pkmodes_real x_3 = a_3 + sigma_3*R(sqrt)((l_d_3*l_d_3) - w2_3);
    const pkmodes_real a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z;
    const pkmodes_real w_4_x = -a_4*n_4_x + r_4_x;
    const pkmodes_real w_4_y = -a_4*n_4_y + r_4_y;
    const pkmodes_real w_4_z = -a_4*n_4_z + r_4_z;
    const pkmodes_real w2_4 = (w_4_x*w_4_x) + (w_4_y*w_4_y) + (w_4_z*w_4_z);
    const pkmodes_real x_4 = a_4 + sigma_4*R(sqrt)((l_d_4*l_d_4) - w2_4);
    const pkmodes_real a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z;
    const pkmodes_real w_5_x = -a_5*n_5_x + r_5_x;
    const pkmodes_real w_5_y = -a_5*n_5_y + r_5_y;
    const pkmodes_real w_5_z = -a_5*n_5_z + r_5_z;
    const pkmodes_real w2_5 = (w_5_x*w_5_x) + (w_5_y*w_5_y) + (w_5_z*w_5_z);
    const pkmodes_real x_5 = a_5 + sigma_5*R(sqrt)((l_d_5*l_d_5) - w2_5);
    const pkmodes_real a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z;
    const pkmodes_real w_6_x = -a_6*n_6_x + r_6_x;
    const pkmodes_real w_6_y = -a_6*n_6_y + r_6_y;
    const pkmodes_real w_6_z = -a_6*n_6_z + r_6_z;
    const pkmodes_real w2_6 = (w_6_x*w_6_x) + (w_6_y*w_6_y) + (w_6_z*w_6_z);
    const pkmodes_real x_6 = a_6 + sigma_6*R(sqrt)((l_d_6*l_d_6) - w2_6);
    const pkmodes_real s_1_x = -n_1_x*x_1 + r_1_x;
    const pkmodes_real s_1_y = -n_1_y*x_1 + r_1_y;
    const pkmodes_real s_1_z = -n_1_z*x_1 + r_1_z;
    const pkmodes_real s_2_x = -n_2_x*x_2 + r_2_x;
    const pkmodes_real s_2_y = -n_2_y*x_2 + r_2_y;
    const pkmodes_real s_2_z = -n_2_z*x_2 + r_2_z;
    const pkmodes_real s_3_x = -n_3_x*x_3 + r_3_x;
    const pkmodes_real s_3_y = -n_3_y*x_3 + r_3_y;
    const pkmodes_real s_3_z = -n_3_z*x_3 + r_3_z;
    const pkmodes_real s_4_x = -n_4_x*x_4 + r_4_x;
    const pkmodes_real s_4_y = -n_4_y*x_4 + r_4_y;
    const pkmodes_real s_4_z = -n_4_z*x_4 + r_4_z;
    const pkmodes_real s_5_x = -n_5_x*x_5 + r_5_x;
    const pkmodes_real s_5_y = -n_5_y*x_5 + r_5_y;
    const pkmodes_real s_5_z = -n_5_z*x_5 + r_5_z;
    const pkmodes_real s_6_x = -n_6_x*x_6 + r_6_x;
    const pkmodes_real s_6_y = -n_6_y*x_6 + r_6_y;
    const pkmodes_real s_6_z = -n_6_z*x_6 + r_6_z;
    const pkmodes_real c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const pkmodes_real c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const pkmodes_real c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const pkmodes_real t12 = I_p_xy*R_x_x;
    const pkmodes_real t13 = I_p_xz*R_x_x;
    const pkmodes_real t14 = 2*R_x_z;
    const pkmodes_real t15 = I_p_yz*R_x_y;
    const pkmodes_real J_x_x =
        I_p_x*(R_x_x*R_x_x) + I_p_y*(R_x_y*R_x_y) + I_p_z*(R_x_z*R_x_z) + 2*R_x_y*t12 + t13*t14 + t14*t15;
    const pkmodes_real t16 = I_p_x*R_x_x;
    const pkmodes_real t17 = I_p_xy*R_x_y;
    const pkmodes_real t18 = I_p_xz*R_x_z;
    const pkmodes_real t19 = I_p_y*R_x_y;
    const pkmodes_real t20 = I_p_yz*R_x_z;
    const pkmodes_real t21 = I_p_z*R_x_z;
    const pkmodes_real J_x_y =
        R_y_x*t16 + R_y_x*t17 + R_y_x*t18 + R_y_y*t12 + R_y_y*t19 + R_y_y*t20 + R_y_z*t13 + R_y_z*t15
        + R_y_z*t21;
    const pkmodes_real J_x_z =
        R_z_x*t16 + R_z_x*t17 + R_z_x*t18 + R_z_y*t12 + R_z_y*t19 + R_z_y*t20 + R_z_z*t13 + R_z_z*t15
        + R_z_z*t21;
    const pkmodes_real t22 = I_p_xy*R_y_x;
    const pkmodes_real t23 = I_p_xz*R_y_x;
    const pkmodes_real t24 = 2*R_y_z;
    const pkmodes_real t25 = I_p_yz*R_y_y;
    const pkmodes_real J_y_y =
        I_p_x*(R_y_x*R_y_x) + I_p_y*(R_y_y*R_y_y) + I_p_z*(R_y_z*R_y_z) + 2*R_y_y*t22 + t23*t24 + t24*t25;
    const pkmodes_real t26 = I_p_xy*R_z_x;
    const pkmodes_real t27 = I_p_xz*R_z_x;
    const pkmodes_real t28 = I_p_yz*R_z_y;
    const pkmodes_real J_y_z =
        I_p_x*R_y_x*R_z_x + I_p_y*R_y_y*R_z_y + I_p_z*R_y_z*R_z_z + R_y_y*t26 + R_y_z*t27 + R_y_z*t28
        + R_z_y*t22 + R_z_z*t23 + R_z_z*t25;
    const pkmodes_real t29 = 2*R_z_z;
    const pkmodes_real J_z_z =
        I_p_x*(R_z_x*R_z_x) + I_p_y*(R_z_y*R_z_y) + I_p_z*(R_z_z*R_z_z) + 2*R_z_y*t26 + t27*t29 + t28*t29;
    const pkmodes_real o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const pkmodes_real o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const pkmodes_real o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const pkmodes_real D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y;
    const pkmodes_real D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x;
    const pkmodes_real D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x;
    const pkmodes_real D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y;
    const pkmodes_real D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x;
    const pkmodes_real D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x;
    const pkmodes_real D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y;
    const pkmodes_real D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x;
    const pkmodes_real D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x;
    const pkmodes_real D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y;
    const pkmodes_real D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x;
    const pkmodes_real D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x;
    const pkmodes_real D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y;
    const pkmodes_real D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x;
    const pkmodes_real D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x;
    const pkmodes_real D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y;
    const pkmodes_real D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x;
    const pkmodes_real D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x;
    const pkmodes_real D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const pkmodes_real D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const pkmodes_real D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const pkmodes_real D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z;
    const pkmodes_real D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z;
    const pkmodes_real D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z;
    const pkmodes_real minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y;
    const pkmodes_real minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const pkmodes_real minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const pkmodes_real minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const pkmodes_real minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const pkmodes_real minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y;
    const pkmodes_real minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z;
    const pkmodes_real minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z;
    const pkmodes_real minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z;
    const pkmodes_real minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y;
    const pkmodes_real minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z;
    const pkmodes_real minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z;
    const pkmodes_real minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y;
    const pkmodes_real minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z;
    const pkmodes_real minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z;
    const pkmodes_real minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y;
    const pkmodes_real minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y;
    const pkmodes_real minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y;
    const pkmodes_real minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z;
    const pkmodes_real minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y;
    const pkmodes_real minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y;
    const pkmodes_real minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z;
    const pkmodes_real minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y;
    const pkmodes_real minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const pkmodes_real minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y;
    const pkmodes_real minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y;
    const pkmodes_real minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const pkmodes_real minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y;
    const pkmodes_real minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const pkmodes_real minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y;
    const pkmodes_real A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const pkmodes_real minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x;
    const pkmodes_real minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x;
    const pkmodes_real minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x;
    const pkmodes_real minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x;
    const pkmodes_real minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x;
    const pkmodes_real minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x;
    const pkmodes_real minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x;
    const pkmodes_real minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x;
    const pkmodes_real minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x;
    const pkmodes_real minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x;
    const pkmodes_real minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x;
    const pkmodes_real minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x;
    const pkmodes_real minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x;
    const pkmodes_real minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x;
    const pkmodes_real A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const pkmodes_real minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x;
    const pkmodes_real minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x;
    const pkmodes_real minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x;
    const pkmodes_real minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x;
    const pkmodes_real minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x;
    const pkmodes_real A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const pkmodes_real minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x;
    const pkmodes_real A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const pkmodes_real A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const pkmodes_real A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const pkmodes_real minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y;
    const pkmodes_real minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y;
    const pkmodes_real minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y;
    const pkmodes_real minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y;
    const pkmodes_real minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z;
    const pkmodes_real minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z;
    const pkmodes_real minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z;
    const pkmodes_real minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const pkmodes_real minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const pkmodes_real minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const pkmodes_real A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const pkmodes_real minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x;
    const pkmodes_real minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x;
    const pkmodes_real minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x;
    const pkmodes_real minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x;
    const pkmodes_real A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const pkmodes_real minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x;
    const pkmodes_real A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const pkmodes_real A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const pkmodes_real A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const pkmodes_real A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const pkmodes_real minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y;
    const pkmodes_real minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y;
    const pkmodes_real minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y;
    const pkmodes_real minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y;
    const pkmodes_real minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z;
    const pkmodes_real minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z;
    const pkmodes_real minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z;
    const pkmodes_real minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const pkmodes_real minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const pkmodes_real minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const pkmodes_real A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const pkmodes_real minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x;
    const pkmodes_real minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x;
    const pkmodes_real minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x;
    const pkmodes_real minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x;
    const pkmodes_real A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const pkmodes_real minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x;
    const pkmodes_real A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const pkmodes_real A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const pkmodes_real A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const pkmodes_real A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const pkmodes_real minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y;
    const pkmodes_real minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y;
    const pkmodes_real minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y;
    const pkmodes_real minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y;
    const pkmodes_real minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y;
    const pkmodes_real minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y;
    const pkmodes_real minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z;
    const pkmodes_real minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z;
    const pkmodes_real minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z;
    const pkmodes_real minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const pkmodes_real A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const pkmodes_real minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x;
    const pkmodes_real minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x;
    const pkmodes_real minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x;
    const pkmodes_real minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x;
    const pkmodes_real minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x;
    const pkmodes_real minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x;
    const pkmodes_real A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const pkmodes_real minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x;
    const pkmodes_real minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x;
    const pkmodes_real minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x;
    const pkmodes_real A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const pkmodes_real minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x;
    const pkmodes_real A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const pkmodes_real A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const pkmodes_real A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const pkmodes_real minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const pkmodes_real minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const pkmodes_real minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const pkmodes_real minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z;
    const pkmodes_real minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z;
    const pkmodes_real minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z;
    const pkmodes_real minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y;
    const pkmodes_real minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y;
    const pkmodes_real minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y;
    const pkmodes_real minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y;
    const pkmodes_real A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const pkmodes_real minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x;
    const pkmodes_real minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x;
    const pkmodes_real minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x;
    const pkmodes_real minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x;
    const pkmodes_real A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const pkmodes_real minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x;
    const pkmodes_real A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const pkmodes_real A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const pkmodes_real A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const pkmodes_real A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const pkmodes_real minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const pkmodes_real minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const pkmodes_real minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const pkmodes_real minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z;
    const pkmodes_real minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z;
    const pkmodes_real minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z;
    const pkmodes_real minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y;
    const pkmodes_real minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y;
    const pkmodes_real minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y;
    const pkmodes_real minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y;
    const pkmodes_real A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const pkmodes_real minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x;
    const pkmodes_real minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x;
    const pkmodes_real minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x;
    const pkmodes_real minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x;
    const pkmodes_real A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const pkmodes_real minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x;
    const pkmodes_real A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const pkmodes_real A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const pkmodes_real A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const pkmodes_real A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const pkmodes_real det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const pkmodes_real t30 = 1/det_D_l;
    const pkmodes_real t31 = A_x_1*t30;
    const pkmodes_real D_p_x_1 = D_r_1*t31;
    const pkmodes_real t32 = A_x_2*t30;
    const pkmodes_real D_p_x_2 = D_r_2*t32;
    const pkmodes_real t33 = A_x_3*t30;
    const pkmodes_real D_p_x_3 = D_r_3*t33;
    const pkmodes_real t34 = A_x_4*t30;
    const pkmodes_real D_p_x_4 = D_r_4*t34;
    const pkmodes_real t35 = A_x_5*t30;
    const pkmodes_real D_p_x_5 = D_r_5*t35;
    const pkmodes_real t36 = A_x_6*t30;
    const pkmodes_real D_p_x_6 = D_r_6*t36;
    const pkmodes_real D_delta_x_1 = l_d_1*t31;
    const pkmodes_real D_delta_x_2 = l_d_2*t32;
    const pkmodes_real D_delta_x_3 = l_d_3*t33;
    const pkmodes_real D_delta_x_4 = l_d_4*t34;
    const pkmodes_real D_delta_x_5 = l_d_5*t35;
    const pkmodes_real D_delta_x_6 = l_d_6*t36;
    const pkmodes_real t37 = A_y_1*t30;
    const pkmodes_real D_p_y_1 = D_r_1*t37;
    const pkmodes_real t38 = A_y_2*t30;
    const pkmodes_real D_p_y_2 = D_r_2*t38;
    const pkmodes_real t39 = A_y_3*t30;
    const pkmodes_real D_p_y_3 = D_r_3*t39;
    const pkmodes_real t40 = A_y_4*t30;
    const pkmodes_real D_p_y_4 = D_r_4*t40;
    const pkmodes_real t41 = A_y_5*t30;
    const pkmodes_real D_p_y_5 = D_r_5*t41;
    const pkmodes_real t42 = A_y_6*t30;
    const pkmodes_real D_p_y_6 = D_r_6*t42;
    const pkmodes_real D_delta_y_1 = l_d_1*t37;
    const pkmodes_real D_delta_y_2 = l_d_2*t38;
    const pkmodes_real D_delta_y_3 = l_d_3*t39;
    const pkmodes_real D_delta_y_4 = l_d_4*t40;
    const pkmodes_real D_delta_y_5 = l_d_5*t41;
    const pkmodes_real D_delta_y_6 = l_d_6*t42;
    const pkmodes_real t43 = A_z_1*t30;
    const pkmodes_real D_p_z_1 = D_r_1*t43;
    const pkmodes_real t44 = A_z_2*t30;
    const pkmodes_real D_p_z_2 = D_r_2*t44;
    const pkmodes_real t45 = A_z_3*t30;
    const pkmodes_real D_p_z_3 = D_r_3*t45;
    const pkmodes_real t46 = A_z_4*t30;
    const pkmodes_real D_p_z_4 = D_r_4*t46;
    const pkmodes_real t47 = A_z_5*t30;
    const pkmodes_real D_p_z_5 = D_r_5*t47;
    const pkmodes_real t48 = A_z_6*t30;
    const pkmodes_real D_p_z_6 = D_r_6*t48;
    const pkmodes_real D_delta_z_1 = l_d_1*t43;
    const pkmodes_real D_delta_z_2 = l_d_2*t44;
    const pkmodes_real D_delta_z_3 = l_d_3*t45;
    const pkmodes_real D_delta_z_4 = l_d_4*t46;
    const pkmodes_real D_delta_z_5 = l_d_5*t47;
    const pkmodes_real D_delta_z_6 = l_d_6*t48;
    const pkmodes_real t49 = A_rx_1*t30;
    const pkmodes_real D_p_rx_1 = D_r_1*t49;
    const pkmodes_real t50 = A_rx_2*t30;
    const pkmodes_real D_p_rx_2 = D_r_2*t50;
    const pkmodes_real t51 = A_rx_3*t30;
    const pkmodes_real D_p_rx_3 = D_r_3*t51;
    const pkmodes_real t52 = A_rx_4*t30;
    const pkmodes_real D_p_rx_4 = D_r_4*t52;
    const pkmodes_real t53 = A_rx_5*t30;
    const pkmodes_real D_p_rx_5 = D_r_5*t53;
    const pkmodes_real t54 = A_rx_6*t30;
    const pkmodes_real D_p_rx_6 = D_r_6*t54;
    const pkmodes_real D_delta_rx_1 = l_d_1*t49;
    const pkmodes_real D_delta_rx_2 = l_d_2*t50;
    const pkmodes_real D_delta_rx_3 = l_d_3*t51;
    const pkmodes_real D_delta_rx_4 = l_d_4*t52;
    const pkmodes_real D_delta_rx_5 = l_d_5*t53;
    const pkmodes_real D_delta_rx_6 = l_d_6*t54;
    const pkmodes_real t55 = A_ry_1*t30;
    const pkmodes_real D_p_ry_1 = D_r_1*t55;
    const pkmodes_real t56 = A_ry_2*t30;
    const pkmodes_real D_p_ry_2 = D_r_2*t56;
    const pkmodes_real t57 = A_ry_3*t30;
    const pkmodes_real D_p_ry_3 = D_r_3*t57;
    const pkmodes_real t58 = A_ry_4*t30;
    const pkmodes_real D_p_ry_4 = D_r_4*t58;
    const pkmodes_real t59 = A_ry_5*t30;
    const pkmodes_real D_p_ry_5 = D_r_5*t59;
    const pkmodes_real t60 = A_ry_6*t30;
    const pkmodes_real D_p_ry_6 = D_r_6*t60;
    const pkmodes_real D_delta_ry_1 = l_d_1*t55;
    const pkmodes_real D_delta_ry_2 = l_d_2*t56;
    const pkmodes_real D_delta_ry_3 = l_d_3*t57;
    const pkmodes_real D_delta_ry_4 = l_d_4*t58;
    const pkmodes_real D_delta_ry_5 = l_d_5*t59;
    const pkmodes_real D_delta_ry_6 = l_d_6*t60;
    const pkmodes_real t61 = A_rz_1*t30;
    const pkmodes_real D_p_rz_1 = D_r_1*t61;
    const pkmodes_real t62 = A_rz_2*t30;
    const pkmodes_real D_p_rz_2 = D_r_2*t62;
    const pkmodes_real t63 = A_rz_3*t30;
    const pkmodes_real D_p_rz_3 = D_r_3*t63;
    const pkmodes_real t64 = A_rz_4*t30;
    const pkmodes_real D_p_rz_4 = D_r_4*t64;
    const pkmodes_real t65 = A_rz_5*t30;
    const pkmodes_real D_p_rz_5 = D_r_5*t65;
    const pkmodes_real t66 = A_rz_6*t30;
    const pkmodes_real D_p_rz_6 = D_r_6*t66;
    const pkmodes_real D_delta_rz_1 = l_d_1*t61;
    const pkmodes_real D_delta_rz_2 = l_d_2*t62;
    const pkmodes_real D_delta_rz_3 = l_d_3*t63;
    const pkmodes_real D_delta_rz_4 = l_d_4*t64;
    const pkmodes_real D_delta_rz_5 = l_d_5*t65;
    const pkmodes_real D_delta_rz_6 = l_d_6*t66;
    const pkmodes_real t67 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real t68 = I_G + t67;
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t68;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t68;
    const pkmodes_real t69 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real t70 = I_G + t69;
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t70;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t70;
    const pkmodes_real t71 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real t72 = I_G + t71;
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t72;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t72;
    const pkmodes_real t73 = I_m_4*(i_g_4*i_g_4);
    const pkmodes_real t74 = I_G + t73;
    const pkmodes_real I_4_1 = I_p_4 + d_4_1*t74;
    const pkmodes_real I_4_2 = I_p_4 + d_4_2*t74;
    const pkmodes_real t75 = I_m_5*(i_g_5*i_g_5);
    const pkmodes_real t76 = I_G + t75;
    const pkmodes_real I_5_1 = I_p_5 + d_5_1*t76;
    const pkmodes_real I_5_2 = I_p_5 + d_5_2*t76;
    const pkmodes_real t77 = I_m_6*(i_g_6*i_g_6);
    const pkmodes_real t78 = I_G + t77;
    const pkmodes_real I_6_1 = I_p_6 + d_6_1*t78;
    const pkmodes_real I_6_2 = I_p_6 + d_6_2*t78;
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t79 = F_T*c_T + 1;
    const pkmodes_real t80 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t81 = t79*t80;
    const pkmodes_real t82 = c_E*t79;
    const pkmodes_real t83 = t80*t82;
    const pkmodes_real k_1_1 = t81/(l_f_1_1 + t83);
    const pkmodes_real t84 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t84 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t81/(l_f_1_2 + t83);
    const pkmodes_real l_f_1_3 = -t84 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t81/(l_f_1_3 + t83);
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t85 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t86 = t82*t85;
    const pkmodes_real t87 = t79*t85;
    const pkmodes_real k_2_1 = t87/(l_f_2_1 + t86);
    const pkmodes_real t88 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t88 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t87/(l_f_2_2 + t86);
    const pkmodes_real l_f_2_3 = -t88 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t87/(l_f_2_3 + t86);
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t89 = k_sp_3*w_b_3*(a_B_3 + 1);
    const pkmodes_real t90 = t82*t89;
    const pkmodes_real t91 = t79*t89;
    const pkmodes_real k_3_1 = t91/(l_f_3_1 + t90);
    const pkmodes_real t92 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t92 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t91/(l_f_3_2 + t90);
    const pkmodes_real l_f_3_3 = -t92 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t91/(l_f_3_3 + t90);
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t93 = k_sp_4*w_b_4*(a_B_4 + 1);
    const pkmodes_real t94 = t82*t93;
    const pkmodes_real t95 = t79*t93;
    const pkmodes_real k_4_1 = t95/(l_f_4_1 + t94);
    const pkmodes_real t96 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t96 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t95/(l_f_4_2 + t94);
    const pkmodes_real l_f_4_3 = -t96 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t95/(l_f_4_3 + t94);
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t97 = k_sp_5*w_b_5*(a_B_5 + 1);
    const pkmodes_real t98 = t82*t97;
    const pkmodes_real t99 = t79*t97;
    const pkmodes_real k_5_1 = t99/(l_f_5_1 + t98);
    const pkmodes_real t100 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t100 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t99/(l_f_5_2 + t98);
    const pkmodes_real l_f_5_3 = -t100 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t99/(l_f_5_3 + t98);
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t101 = k_sp_6*w_b_6*(a_B_6 + 1);
    const pkmodes_real t102 = t101*t82;
    const pkmodes_real t103 = t101*t79;
    const pkmodes_real k_6_1 = t103/(l_f_6_1 + t102);
    const pkmodes_real t104 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t104 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t103/(l_f_6_2 + t102);
    const pkmodes_real l_f_6_3 = -t104 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t103/(l_f_6_3 + t102);
    const pkmodes_real t105 = m_L + m_p;
    const pkmodes_real t106 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t107 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t108 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t109 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t110 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t111 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t112 = t106 + t107 + t108 + t109 + t110 + t111;
    const pkmodes_real t113 = t105 + t112;
    const pkmodes_real G_p_x = -g_x*t113;
    const pkmodes_real G_p_y = -g_y*t113;
    const pkmodes_real G_p_z = -g_z*t113;
    const pkmodes_real t114 = g_z*m_p;
    const pkmodes_real t115 = g_z*m_L;
    const pkmodes_real t116 = g_z*t106;
    const pkmodes_real t117 = g_z*t107;
    const pkmodes_real t118 = g_z*t108;
    const pkmodes_real t119 = g_z*t109;
    const pkmodes_real t120 = g_z*t110;
    const pkmodes_real t121 = g_z*t111;
    const pkmodes_real G_p_rx =
        -B_1_y*t116 + (R(1.0)/R(2.0))*B_1_z*g_y*m_d_1 - B_2_y*t117 + (R(1.0)/R(2.0))*B_2_z*g_y*m_d_2
        - B_3_y*t118 + (R(1.0)/R(2.0))*B_3_z*g_y*m_d_3 - B_4_y*t119 + (R(1.0)/R(2.0))*B_4_z*g_y*m_d_4
        - B_5_y*t120 + (R(1.0)/R(2.0))*B_5_z*g_y*m_d_5 - B_6_y*t121 + (R(1.0)/R(2.0))*B_6_z*g_y*m_d_6
        - c_y*t114 + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t115;
    const pkmodes_real t122 = g_x*t106;
    const pkmodes_real t123 = g_x*t107;
    const pkmodes_real t124 = g_x*t108;
    const pkmodes_real t125 = g_x*t109;
    const pkmodes_real t126 = g_x*t110;
    const pkmodes_real t127 = g_x*t111;
    const pkmodes_real t128 = g_x*m_p;
    const pkmodes_real t129 = g_x*m_L;
    const pkmodes_real G_p_ry =
        B_1_x*t116 - B_1_z*t122 + B_2_x*t117 - B_2_z*t123 + B_3_x*t118 - B_3_z*t124 + B_4_x*t119 - B_4_z*t125
        + B_5_x*t120 - B_5_z*t126 + B_6_x*t121 - B_6_z*t127 + c_x*t114 - c_z*t128 + o_L_x*t115 - o_L_z*t129;
    const pkmodes_real t130 = g_y*m_p;
    const pkmodes_real t131 = g_y*m_L;
    const pkmodes_real t132 = g_y*t106;
    const pkmodes_real t133 = g_y*t107;
    const pkmodes_real t134 = g_y*t108;
    const pkmodes_real t135 = g_y*t109;
    const pkmodes_real t136 = g_y*t110;
    const pkmodes_real t137 = g_y*t111;
    const pkmodes_real G_p_rz =
        -B_1_x*t132 + (R(1.0)/R(2.0))*B_1_y*g_x*m_d_1 - B_2_x*t133 + (R(1.0)/R(2.0))*B_2_y*g_x*m_d_2
        - B_3_x*t134 + (R(1.0)/R(2.0))*B_3_y*g_x*m_d_3 - B_4_x*t135 + (R(1.0)/R(2.0))*B_4_y*g_x*m_d_4
        - B_5_x*t136 + (R(1.0)/R(2.0))*B_5_y*g_x*m_d_5 - B_6_x*t137 + (R(1.0)/R(2.0))*B_6_y*g_x*m_d_6
        - c_x*t130 + c_y*g_x*m_p + g_x*m_L*o_L_y - o_L_x*t131;
    const pkmodes_real mu_1 =
        t30*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const pkmodes_real mu_2 =
        t30*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const pkmodes_real mu_3 =
        t30*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const pkmodes_real mu_4 =
        t30*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const pkmodes_real mu_5 =
        t30*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const pkmodes_real mu_6 =
        t30*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const pkmodes_real g_4_x = -mu_1*s_1_x - t122;
    const pkmodes_real g_4_y = -mu_1*s_1_y - t132;
    const pkmodes_real g_4_z = -mu_1*s_1_z - t116;
    const pkmodes_real g_5_x = -mu_2*s_2_x - t123;
    const pkmodes_real g_5_y = -mu_2*s_2_y - t133;
    const pkmodes_real g_5_z = -mu_2*s_2_z - t117;
    const pkmodes_real g_6_x = -mu_3*s_3_x - t124;
    const pkmodes_real g_6_y = -mu_3*s_3_y - t134;
    const pkmodes_real g_6_z = -mu_3*s_3_z - t118;
    const pkmodes_real g_7_x = -mu_4*s_4_x - t125;
    const pkmodes_real g_7_y = -mu_4*s_4_y - t135;
    const pkmodes_real g_7_z = -mu_4*s_4_z - t119;
    const pkmodes_real g_8_x = -mu_5*s_5_x - t126;
    const pkmodes_real g_8_y = -mu_5*s_5_y - t136;
    const pkmodes_real g_8_z = -mu_5*s_5_z - t120;
    const pkmodes_real g_9_x = -mu_6*s_6_x - t127;
    const pkmodes_real g_9_y = -mu_6*s_6_y - t137;
    const pkmodes_real g_9_z = -mu_6*s_6_z - t121;
    const pkmodes_real g_10_x = -t128;
    const pkmodes_real g_10_y = -t130;
    const pkmodes_real g_10_z = -t114;
    const pkmodes_real g_11_x = -t129;
    const pkmodes_real g_11_y = -t131;
    const pkmodes_real g_11_z = -t115;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t138 = B_1_z*mu_1;
    const pkmodes_real t139 = B_2_z*mu_2;
    const pkmodes_real t140 = B_3_z*mu_3;
    const pkmodes_real t141 = B_4_z*mu_4;
    const pkmodes_real t142 = B_5_z*mu_5;
    const pkmodes_real t143 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t138 + t139 + t140 + t141 + t142 + t143;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t144 = B_1_y*mu_1;
    const pkmodes_real t145 = B_2_y*mu_2;
    const pkmodes_real t146 = B_3_y*mu_3;
    const pkmodes_real t147 = B_4_y*mu_4;
    const pkmodes_real t148 = B_5_y*mu_5;
    const pkmodes_real t149 = B_6_y*mu_6;
    const pkmodes_real L_x_rz = t144 + t145 + t146 + t147 + t148 + t149;
    const pkmodes_real t150 = B_1_x*mu_1;
    const pkmodes_real t151 = B_2_x*mu_2;
    const pkmodes_real t152 = B_3_x*mu_3;
    const pkmodes_real t153 = B_4_x*mu_4;
    const pkmodes_real t154 = B_5_x*mu_5;
    const pkmodes_real t155 = B_6_x*mu_6;
    const pkmodes_real L_z_ry = t150 + t151 + t152 + t153 + t154 + t155;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t156 = (B_1_z*B_1_z);
    const pkmodes_real t157 = (B_2_z*B_2_z);
    const pkmodes_real t158 = (B_3_z*B_3_z);
    const pkmodes_real t159 = (B_4_z*B_4_z);
    const pkmodes_real t160 = (B_5_z*B_5_z);
    const pkmodes_real t161 = (B_6_z*B_6_z);
    const pkmodes_real t162 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + g_11_z*o_L_z + mu_1*t156 + mu_2*t157 + mu_3*t158 + mu_4*t159 + mu_5*t160 + mu_6*t161;
    const pkmodes_real t163 = (B_1_y*B_1_y);
    const pkmodes_real t164 = (B_2_y*B_2_y);
    const pkmodes_real t165 = (B_3_y*B_3_y);
    const pkmodes_real t166 = (B_4_y*B_4_y);
    const pkmodes_real t167 = (B_5_y*B_5_y);
    const pkmodes_real t168 = (B_6_y*B_6_y);
    const pkmodes_real t169 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + g_11_y*o_L_y + mu_1*t163 + mu_2*t164 + mu_3*t165 + mu_4*t166 + mu_5*t167 + mu_6*t168;
    const pkmodes_real L_rx_rx = -t162 - t169;
    const pkmodes_real t170 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t171 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t172 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t173 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t174 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t175 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t176 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t177 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t178 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t179 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t180 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t181 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real t182 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t183 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real t184 = (R(1.0)/R(2.0))*g_11_x;
    const pkmodes_real t185 = (R(1.0)/R(2.0))*o_L_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t144 + B_1_y*t171 + B_2_x*t145 + B_2_y*t173 + B_3_x*t146 + B_3_y*t175 + B_4_x*t147 + B_4_y*t177
        + B_5_x*t148 + B_5_y*t179 + B_6_x*t149 + B_6_y*t181 + c_y*t183 + g_10_y*t182 + g_11_y*t185
        + g_4_y*t170 + g_5_y*t172 + g_6_y*t174 + g_7_y*t176 + g_8_y*t178 + g_9_y*t180 + o_L_y*t184;
    const pkmodes_real L_rx_rz =
        B_1_x*t138 + B_1_z*t171 + B_2_x*t139 + B_2_z*t173 + B_3_x*t140 + B_3_z*t175 + B_4_x*t141 + B_4_z*t177
        + B_5_x*t142 + B_5_z*t179 + B_6_x*t143 + B_6_z*t181 + c_z*t183 + g_10_z*t182 + g_11_z*t185
        + g_4_z*t170 + g_5_z*t172 + g_6_z*t174 + g_7_z*t176 + g_8_z*t178 + g_9_z*t180 + o_L_z*t184;
    const pkmodes_real t186 = (B_1_x*B_1_x);
    const pkmodes_real t187 = (B_2_x*B_2_x);
    const pkmodes_real t188 = (B_3_x*B_3_x);
    const pkmodes_real t189 = (B_4_x*B_4_x);
    const pkmodes_real t190 = (B_5_x*B_5_x);
    const pkmodes_real t191 = (B_6_x*B_6_x);
    const pkmodes_real t192 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + g_11_x*o_L_x + mu_1*t186 + mu_2*t187 + mu_3*t188 + mu_4*t189 + mu_5*t190 + mu_6*t191;
    const pkmodes_real L_ry_ry = -t162 - t192;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t138 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t139 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t140
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t141
        + (R(1.0)/R(2.0))*B_4_z*g_7_y + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t142
        + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z + B_6_y*t143
        + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y
        + (R(1.0)/R(2.0))*g_11_y*o_L_z + (R(1.0)/R(2.0))*g_11_z*o_L_y;
    const pkmodes_real L_rz_rz = -t169 - t192;
    const pkmodes_real t193 = mu_1*n_1_x;
    const pkmodes_real f_x_x_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t193;
    const pkmodes_real t194 = mu_2*n_2_x;
    const pkmodes_real f_x_x_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t194;
    const pkmodes_real t195 = mu_3*n_3_x;
    const pkmodes_real f_x_x_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t195;
    const pkmodes_real t196 = mu_4*n_4_x;
    const pkmodes_real f_x_x_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t196;
    const pkmodes_real t197 = mu_5*n_5_x;
    const pkmodes_real f_x_x_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t197;
    const pkmodes_real t198 = mu_6*n_6_x;
    const pkmodes_real f_x_x_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t198;
    const pkmodes_real f_x_delta_1 = D_delta_ry_1*L_x_ry + D_delta_rz_1*L_x_rz + D_delta_x_1*L_x_x;
    const pkmodes_real f_x_delta_2 = D_delta_ry_2*L_x_ry + D_delta_rz_2*L_x_rz + D_delta_x_2*L_x_x;
    const pkmodes_real f_x_delta_3 = D_delta_ry_3*L_x_ry + D_delta_rz_3*L_x_rz + D_delta_x_3*L_x_x;
    const pkmodes_real f_x_delta_4 = D_delta_ry_4*L_x_ry + D_delta_rz_4*L_x_rz + D_delta_x_4*L_x_x;
    const pkmodes_real f_x_delta_5 = D_delta_ry_5*L_x_ry + D_delta_rz_5*L_x_rz + D_delta_x_5*L_x_x;
    const pkmodes_real f_x_delta_6 = D_delta_ry_6*L_x_ry + D_delta_rz_6*L_x_rz + D_delta_x_6*L_x_x;
    const pkmodes_real t199 = mu_1*n_1_y;
    const pkmodes_real f_y_x_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t199;
    const pkmodes_real t200 = mu_2*n_2_y;
    const pkmodes_real f_y_x_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t200;
    const pkmodes_real t201 = mu_3*n_3_y;
    const pkmodes_real f_y_x_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t201;
    const pkmodes_real t202 = mu_4*n_4_y;
    const pkmodes_real f_y_x_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t202;
    const pkmodes_real t203 = mu_5*n_5_y;
    const pkmodes_real f_y_x_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t203;
    const pkmodes_real t204 = mu_6*n_6_y;
    const pkmodes_real f_y_x_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t204;
    const pkmodes_real f_y_delta_1 = D_delta_rx_1*L_y_rx + D_delta_rz_1*L_y_rz + D_delta_y_1*L_x_x;
    const pkmodes_real f_y_delta_2 = D_delta_rx_2*L_y_rx + D_delta_rz_2*L_y_rz + D_delta_y_2*L_x_x;
    const pkmodes_real f_y_delta_3 = D_delta_rx_3*L_y_rx + D_delta_rz_3*L_y_rz + D_delta_y_3*L_x_x;
    const pkmodes_real f_y_delta_4 = D_delta_rx_4*L_y_rx + D_delta_rz_4*L_y_rz + D_delta_y_4*L_x_x;
    const pkmodes_real f_y_delta_5 = D_delta_rx_5*L_y_rx + D_delta_rz_5*L_y_rz + D_delta_y_5*L_x_x;
    const pkmodes_real f_y_delta_6 = D_delta_rx_6*L_y_rx + D_delta_rz_6*L_y_rz + D_delta_y_6*L_x_x;
    const pkmodes_real t205 = mu_1*n_1_z;
    const pkmodes_real f_z_x_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t205;
    const pkmodes_real t206 = mu_2*n_2_z;
    const pkmodes_real f_z_x_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t206;
    const pkmodes_real t207 = mu_3*n_3_z;
    const pkmodes_real f_z_x_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t207;
    const pkmodes_real t208 = mu_4*n_4_z;
    const pkmodes_real f_z_x_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t208;
    const pkmodes_real t209 = mu_5*n_5_z;
    const pkmodes_real f_z_x_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t209;
    const pkmodes_real t210 = mu_6*n_6_z;
    const pkmodes_real f_z_x_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t210;
    const pkmodes_real f_z_delta_1 = D_delta_rx_1*L_z_rx + D_delta_ry_1*L_z_ry + D_delta_z_1*L_x_x;
    const pkmodes_real f_z_delta_2 = D_delta_rx_2*L_z_rx + D_delta_ry_2*L_z_ry + D_delta_z_2*L_x_x;
    const pkmodes_real f_z_delta_3 = D_delta_rx_3*L_z_rx + D_delta_ry_3*L_z_ry + D_delta_z_3*L_x_x;
    const pkmodes_real f_z_delta_4 = D_delta_rx_4*L_z_rx + D_delta_ry_4*L_z_ry + D_delta_z_4*L_x_x;
    const pkmodes_real f_z_delta_5 = D_delta_rx_5*L_z_rx + D_delta_ry_5*L_z_ry + D_delta_z_5*L_x_x;
    const pkmodes_real f_z_delta_6 = D_delta_rx_6*L_z_rx + D_delta_ry_6*L_z_ry + D_delta_z_6*L_x_x;
    const pkmodes_real t211 = -n_1_y*t138 + n_1_z*t144;
    const pkmodes_real f_rx_x_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx + t211;
    const pkmodes_real t212 = -n_2_y*t139 + n_2_z*t145;
    const pkmodes_real f_rx_x_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx + t212;
    const pkmodes_real t213 = -n_3_y*t140 + n_3_z*t146;
    const pkmodes_real f_rx_x_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx + t213;
    const pkmodes_real t214 = -n_4_y*t141 + n_4_z*t147;
    const pkmodes_real f_rx_x_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx + t214;
    const pkmodes_real t215 = -n_5_y*t142 + n_5_z*t148;
    const pkmodes_real f_rx_x_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx + t215;
    const pkmodes_real t216 = -n_6_y*t143 + n_6_z*t149;
    const pkmodes_real f_rx_x_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx + t216;
    const pkmodes_real f_rx_delta_1 =
        D_delta_rx_1*L_rx_rx + D_delta_ry_1*L_rx_ry + D_delta_rz_1*L_rx_rz + D_delta_y_1*L_y_rx
        + D_delta_z_1*L_z_rx;
    const pkmodes_real f_rx_delta_2 =
        D_delta_rx_2*L_rx_rx + D_delta_ry_2*L_rx_ry + D_delta_rz_2*L_rx_rz + D_delta_y_2*L_y_rx
        + D_delta_z_2*L_z_rx;
    const pkmodes_real f_rx_delta_3 =
        D_delta_rx_3*L_rx_rx + D_delta_ry_3*L_rx_ry + D_delta_rz_3*L_rx_rz + D_delta_y_3*L_y_rx
        + D_delta_z_3*L_z_rx;
    const pkmodes_real f_rx_delta_4 =
        D_delta_rx_4*L_rx_rx + D_delta_ry_4*L_rx_ry + D_delta_rz_4*L_rx_rz + D_delta_y_4*L_y_rx
        + D_delta_z_4*L_z_rx;
    const pkmodes_real f_rx_delta_5 =
        D_delta_rx_5*L_rx_rx + D_delta_ry_5*L_rx_ry + D_delta_rz_5*L_rx_rz + D_delta_y_5*L_y_rx
        + D_delta_z_5*L_z_rx;
    const pkmodes_real f_rx_delta_6 =
        D_delta_rx_6*L_rx_rx + D_delta_ry_6*L_rx_ry + D_delta_rz_6*L_rx_rz + D_delta_y_6*L_y_rx
        + D_delta_z_6*L_z_rx;
    const pkmodes_real t217 = n_1_z*t150;
    const pkmodes_real f_ry_x_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry + n_1_x*t138
        - t217;
    const pkmodes_real t218 = n_2_z*t151;
    const pkmodes_real f_ry_x_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry + n_2_x*t139
        - t218;
    const pkmodes_real t219 = n_3_z*t152;
    const pkmodes_real f_ry_x_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry + n_3_x*t140
        - t219;
    const pkmodes_real t220 = n_4_z*t153;
    const pkmodes_real f_ry_x_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry + n_4_x*t141
        - t220;
    const pkmodes_real t221 = n_5_z*t154;
    const pkmodes_real f_ry_x_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry + n_5_x*t142
        - t221;
    const pkmodes_real t222 = n_6_z*t155;
    const pkmodes_real f_ry_x_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry + n_6_x*t143
        - t222;
    const pkmodes_real f_ry_delta_1 =
        D_delta_rx_1*L_rx_ry + D_delta_ry_1*L_ry_ry + D_delta_rz_1*L_ry_rz + D_delta_x_1*L_x_ry
        + D_delta_z_1*L_z_ry;
    const pkmodes_real f_ry_delta_2 =
        D_delta_rx_2*L_rx_ry + D_delta_ry_2*L_ry_ry + D_delta_rz_2*L_ry_rz + D_delta_x_2*L_x_ry
        + D_delta_z_2*L_z_ry;
    const pkmodes_real f_ry_delta_3 =
        D_delta_rx_3*L_rx_ry + D_delta_ry_3*L_ry_ry + D_delta_rz_3*L_ry_rz + D_delta_x_3*L_x_ry
        + D_delta_z_3*L_z_ry;
    const pkmodes_real f_ry_delta_4 =
        D_delta_rx_4*L_rx_ry + D_delta_ry_4*L_ry_ry + D_delta_rz_4*L_ry_rz + D_delta_x_4*L_x_ry
        + D_delta_z_4*L_z_ry;
    const pkmodes_real f_ry_delta_5 =
        D_delta_rx_5*L_rx_ry + D_delta_ry_5*L_ry_ry + D_delta_rz_5*L_ry_rz + D_delta_x_5*L_x_ry
        + D_delta_z_5*L_z_ry;
    const pkmodes_real f_ry_delta_6 =
        D_delta_rx_6*L_rx_ry + D_delta_ry_6*L_ry_ry + D_delta_rz_6*L_ry_rz + D_delta_x_6*L_x_ry
        + D_delta_z_6*L_z_ry;
    const pkmodes_real t223 = -n_1_x*t144 + n_1_y*t150;
    const pkmodes_real f_rz_x_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz + t223;
    const pkmodes_real t224 = -n_2_x*t145 + n_2_y*t151;
    const pkmodes_real f_rz_x_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz + t224;
    const pkmodes_real t225 = -n_3_x*t146 + n_3_y*t152;
    const pkmodes_real f_rz_x_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz + t225;
    const pkmodes_real t226 = -n_4_x*t147 + n_4_y*t153;
    const pkmodes_real f_rz_x_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz + t226;
    const pkmodes_real t227 = -n_5_x*t148 + n_5_y*t154;
    const pkmodes_real f_rz_x_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz + t227;
    const pkmodes_real t228 = -n_6_x*t149 + n_6_y*t155;
    const pkmodes_real f_rz_x_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz + t228;
    const pkmodes_real f_rz_delta_1 =
        D_delta_rx_1*L_rx_rz + D_delta_ry_1*L_ry_rz + D_delta_rz_1*L_rz_rz + D_delta_x_1*L_x_rz
        + D_delta_y_1*L_y_rz;
    const pkmodes_real f_rz_delta_2 =
        D_delta_rx_2*L_rx_rz + D_delta_ry_2*L_ry_rz + D_delta_rz_2*L_rz_rz + D_delta_x_2*L_x_rz
        + D_delta_y_2*L_y_rz;
    const pkmodes_real f_rz_delta_3 =
        D_delta_rx_3*L_rx_rz + D_delta_ry_3*L_ry_rz + D_delta_rz_3*L_rz_rz + D_delta_x_3*L_x_rz
        + D_delta_y_3*L_y_rz;
    const pkmodes_real f_rz_delta_4 =
        D_delta_rx_4*L_rx_rz + D_delta_ry_4*L_ry_rz + D_delta_rz_4*L_rz_rz + D_delta_x_4*L_x_rz
        + D_delta_y_4*L_y_rz;
    const pkmodes_real f_rz_delta_5 =
        D_delta_rx_5*L_rx_rz + D_delta_ry_5*L_ry_rz + D_delta_rz_5*L_rz_rz + D_delta_x_5*L_x_rz
        + D_delta_y_5*L_y_rz;
    const pkmodes_real f_rz_delta_6 =
        D_delta_rx_6*L_rx_rz + D_delta_ry_6*L_ry_rz + D_delta_rz_6*L_rz_rz + D_delta_x_6*L_x_rz
        + D_delta_y_6*L_y_rz;
    const pkmodes_real t229 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t230 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t231 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t232 = (R(1.0)/R(3.0))*m_d_4;
    const pkmodes_real t233 = (R(1.0)/R(3.0))*m_d_5;
    const pkmodes_real t234 = (R(1.0)/R(3.0))*m_d_6;
    const pkmodes_real M_p_x_x = t105 + t229 + t230 + t231 + t232 + t233 + t234;
    const pkmodes_real t235 = c_z*m_p;
    const pkmodes_real t236 = m_L*o_L_z;
    const pkmodes_real t237 = B_1_z*t229;
    const pkmodes_real t238 = B_2_z*t230;
    const pkmodes_real t239 = B_3_z*t231;
    const pkmodes_real t240 = B_4_z*t232;
    const pkmodes_real t241 = B_5_z*t233;
    const pkmodes_real t242 = B_6_z*t234;
    const pkmodes_real M_p_x_ry = t235 + t236 + t237 + t238 + t239 + t240 + t241 + t242;
    const pkmodes_real t243 = c_y*m_p;
    const pkmodes_real t244 = m_L*o_L_y;
    const pkmodes_real t245 = B_1_y*t229;
    const pkmodes_real t246 = B_2_y*t230;
    const pkmodes_real t247 = B_3_y*t231;
    const pkmodes_real t248 = B_4_y*t232;
    const pkmodes_real t249 = B_5_y*t233;
    const pkmodes_real t250 = B_6_y*t234;
    const pkmodes_real M_p_z_rx = t243 + t244 + t245 + t246 + t247 + t248 + t249 + t250;
    const pkmodes_real M_p_x_rz = -M_p_z_rx;
    const pkmodes_real M_p_y_rx = -M_p_x_ry;
    const pkmodes_real M_p_y_rz =
        B_1_x*t229 + B_2_x*t230 + B_3_x*t231 + B_4_x*t232 + B_5_x*t233 + B_6_x*t234 + c_x*m_p + m_L*o_L_x;
    const pkmodes_real M_p_z_ry = -M_p_y_rz;
    const pkmodes_real t251 = 2*(o_L_y*o_L_y);
    const pkmodes_real t252 = 2*(o_L_z*o_L_z);
    const pkmodes_real t253 = (R(1.0)/R(2.0))*m_L;
    const pkmodes_real t254 = 2*t163;
    const pkmodes_real t255 = 2*t156;
    const pkmodes_real t256 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t257 = 2*t164;
    const pkmodes_real t258 = 2*t157;
    const pkmodes_real t259 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t260 = 2*t165;
    const pkmodes_real t261 = 2*t158;
    const pkmodes_real t262 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t263 = 2*t166;
    const pkmodes_real t264 = 2*t159;
    const pkmodes_real t265 = (R(1.0)/R(6.0))*m_d_4;
    const pkmodes_real t266 = 2*t167;
    const pkmodes_real t267 = 2*t160;
    const pkmodes_real t268 = (R(1.0)/R(6.0))*m_d_5;
    const pkmodes_real t269 = 2*t168;
    const pkmodes_real t270 = 2*t161;
    const pkmodes_real t271 = (R(1.0)/R(6.0))*m_d_6;
    const pkmodes_real t272 = 2*(c_y*c_y);
    const pkmodes_real t273 = 2*(c_z*c_z);
    const pkmodes_real t274 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real M_p_rx_rx =
        J_x_x + t253*(t251 + t252) + t256*(t254 + t255) + t259*(t257 + t258) + t262*(t260 + t261)
        + t265*(t263 + t264) + t268*(t266 + t267) + t271*(t269 + t270) + t274*(t272 + t273);
    const pkmodes_real M_p_rx_ry =
        -B_1_x*t245 - B_2_x*t246 - B_3_x*t247 - B_4_x*t248 - B_5_x*t249 - B_6_x*t250 + J_x_y - c_x*t243
        - o_L_x*t244;
    const pkmodes_real M_p_rx_rz =
        -B_1_x*t237 - B_2_x*t238 - B_3_x*t239 - B_4_x*t240 - B_5_x*t241 - B_6_x*t242 + J_x_z - c_x*t235
        - o_L_x*t236;
    const pkmodes_real t275 = 2*(o_L_x*o_L_x);
    const pkmodes_real t276 = 2*t186;
    const pkmodes_real t277 = 2*t187;
    const pkmodes_real t278 = 2*t188;
    const pkmodes_real t279 = 2*t189;
    const pkmodes_real t280 = 2*t190;
    const pkmodes_real t281 = 2*t191;
    const pkmodes_real t282 = 2*(c_x*c_x);
    const pkmodes_real M_p_ry_ry =
        J_y_y + t253*(t252 + t275) + t256*(t255 + t276) + t259*(t258 + t277) + t262*(t261 + t278)
        + t265*(t264 + t279) + t268*(t267 + t280) + t271*(t270 + t281) + t274*(t273 + t282);
    const pkmodes_real M_p_ry_rz =
        -B_1_y*t237 - B_2_y*t238 - B_3_y*t239 - B_4_y*t240 - B_5_y*t241 - B_6_y*t242 + J_y_z - c_y*t235
        - o_L_y*t236;
    const pkmodes_real M_p_rz_rz =
        J_z_z + t253*(t251 + t275) + t256*(t254 + t276) + t259*(t257 + t277) + t262*(t260 + t278)
        + t265*(t263 + t279) + t268*(t266 + t280) + t271*(t269 + t281) + t274*(t272 + t282);
    const pkmodes_real t283 = n_1_x*t256;
    const pkmodes_real h_x_x_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x + t283;
    const pkmodes_real t284 = n_2_x*t259;
    const pkmodes_real h_x_x_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x + t284;
    const pkmodes_real t285 = n_3_x*t262;
    const pkmodes_real h_x_x_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x + t285;
    const pkmodes_real t286 = n_4_x*t265;
    const pkmodes_real h_x_x_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x + t286;
    const pkmodes_real t287 = n_5_x*t268;
    const pkmodes_real h_x_x_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x + t287;
    const pkmodes_real t288 = n_6_x*t271;
    const pkmodes_real h_x_x_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x + t288;
    const pkmodes_real h_x_delta_1 = D_delta_ry_1*M_p_x_ry + D_delta_rz_1*M_p_x_rz + D_delta_x_1*M_p_x_x;
    const pkmodes_real h_x_delta_2 = D_delta_ry_2*M_p_x_ry + D_delta_rz_2*M_p_x_rz + D_delta_x_2*M_p_x_x;
    const pkmodes_real h_x_delta_3 = D_delta_ry_3*M_p_x_ry + D_delta_rz_3*M_p_x_rz + D_delta_x_3*M_p_x_x;
    const pkmodes_real h_x_delta_4 = D_delta_ry_4*M_p_x_ry + D_delta_rz_4*M_p_x_rz + D_delta_x_4*M_p_x_x;
    const pkmodes_real h_x_delta_5 = D_delta_ry_5*M_p_x_ry + D_delta_rz_5*M_p_x_rz + D_delta_x_5*M_p_x_x;
    const pkmodes_real h_x_delta_6 = D_delta_ry_6*M_p_x_ry + D_delta_rz_6*M_p_x_rz + D_delta_x_6*M_p_x_x;
    const pkmodes_real t289 = t256 + t259 + t262 + t265 + t268 + t271;
    const pkmodes_real h_x_u_x = M_p_x_x + t289;
    const pkmodes_real t290 = n_1_y*t256;
    const pkmodes_real h_y_x_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x + t290;
    const pkmodes_real t291 = n_2_y*t259;
    const pkmodes_real h_y_x_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x + t291;
    const pkmodes_real t292 = n_3_y*t262;
    const pkmodes_real h_y_x_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x + t292;
    const pkmodes_real t293 = n_4_y*t265;
    const pkmodes_real h_y_x_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x + t293;
    const pkmodes_real t294 = n_5_y*t268;
    const pkmodes_real h_y_x_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x + t294;
    const pkmodes_real t295 = n_6_y*t271;
    const pkmodes_real h_y_x_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x + t295;
    const pkmodes_real h_y_delta_1 = D_delta_rx_1*M_p_y_rx + D_delta_rz_1*M_p_y_rz + D_delta_y_1*M_p_x_x;
    const pkmodes_real h_y_delta_2 = D_delta_rx_2*M_p_y_rx + D_delta_rz_2*M_p_y_rz + D_delta_y_2*M_p_x_x;
    const pkmodes_real h_y_delta_3 = D_delta_rx_3*M_p_y_rx + D_delta_rz_3*M_p_y_rz + D_delta_y_3*M_p_x_x;
    const pkmodes_real h_y_delta_4 = D_delta_rx_4*M_p_y_rx + D_delta_rz_4*M_p_y_rz + D_delta_y_4*M_p_x_x;
    const pkmodes_real h_y_delta_5 = D_delta_rx_5*M_p_y_rx + D_delta_rz_5*M_p_y_rz + D_delta_y_5*M_p_x_x;
    const pkmodes_real h_y_delta_6 = D_delta_rx_6*M_p_y_rx + D_delta_rz_6*M_p_y_rz + D_delta_y_6*M_p_x_x;
    const pkmodes_real h_y_u_y = M_p_x_x + t289;
    const pkmodes_real t296 = n_1_z*t256;
    const pkmodes_real h_z_x_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x + t296;
    const pkmodes_real t297 = n_2_z*t259;
    const pkmodes_real h_z_x_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x + t297;
    const pkmodes_real t298 = n_3_z*t262;
    const pkmodes_real h_z_x_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x + t298;
    const pkmodes_real t299 = n_4_z*t265;
    const pkmodes_real h_z_x_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x + t299;
    const pkmodes_real t300 = n_5_z*t268;
    const pkmodes_real h_z_x_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x + t300;
    const pkmodes_real t301 = n_6_z*t271;
    const pkmodes_real h_z_x_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x + t301;
    const pkmodes_real h_z_delta_1 = D_delta_rx_1*M_p_z_rx + D_delta_ry_1*M_p_z_ry + D_delta_z_1*M_p_x_x;
    const pkmodes_real h_z_delta_2 = D_delta_rx_2*M_p_z_rx + D_delta_ry_2*M_p_z_ry + D_delta_z_2*M_p_x_x;
    const pkmodes_real h_z_delta_3 = D_delta_rx_3*M_p_z_rx + D_delta_ry_3*M_p_z_ry + D_delta_z_3*M_p_x_x;
    const pkmodes_real h_z_delta_4 = D_delta_rx_4*M_p_z_rx + D_delta_ry_4*M_p_z_ry + D_delta_z_4*M_p_x_x;
    const pkmodes_real h_z_delta_5 = D_delta_rx_5*M_p_z_rx + D_delta_ry_5*M_p_z_ry + D_delta_z_5*M_p_x_x;
    const pkmodes_real h_z_delta_6 = D_delta_rx_6*M_p_z_rx + D_delta_ry_6*M_p_z_ry + D_delta_z_6*M_p_x_x;
    const pkmodes_real h_z_u_z = M_p_x_x + t289;
    const pkmodes_real t302 = t256*(B_1_y*n_1_z - B_1_z*n_1_y);
    const pkmodes_real h_rx_x_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx
        + t302;
    const pkmodes_real t303 = t259*(B_2_y*n_2_z - B_2_z*n_2_y);
    const pkmodes_real h_rx_x_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx
        + t303;
    const pkmodes_real t304 = t262*(B_3_y*n_3_z - B_3_z*n_3_y);
    const pkmodes_real h_rx_x_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx
        + t304;
    const pkmodes_real t305 = t265*(B_4_y*n_4_z - B_4_z*n_4_y);
    const pkmodes_real h_rx_x_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx
        + t305;
    const pkmodes_real t306 = t268*(B_5_y*n_5_z - B_5_z*n_5_y);
    const pkmodes_real h_rx_x_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx
        + t306;
    const pkmodes_real t307 = t271*(B_6_y*n_6_z - B_6_z*n_6_y);
    const pkmodes_real h_rx_x_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx
        + t307;
    const pkmodes_real h_rx_delta_1 =
        D_delta_rx_1*M_p_rx_rx + D_delta_ry_1*M_p_rx_ry + D_delta_rz_1*M_p_rx_rz + D_delta_y_1*M_p_y_rx
        + D_delta_z_1*M_p_z_rx;
    const pkmodes_real h_rx_delta_2 =
        D_delta_rx_2*M_p_rx_rx + D_delta_ry_2*M_p_rx_ry + D_delta_rz_2*M_p_rx_rz + D_delta_y_2*M_p_y_rx
        + D_delta_z_2*M_p_z_rx;
    const pkmodes_real h_rx_delta_3 =
        D_delta_rx_3*M_p_rx_rx + D_delta_ry_3*M_p_rx_ry + D_delta_rz_3*M_p_rx_rz + D_delta_y_3*M_p_y_rx
        + D_delta_z_3*M_p_z_rx;
    const pkmodes_real h_rx_delta_4 =
        D_delta_rx_4*M_p_rx_rx + D_delta_ry_4*M_p_rx_ry + D_delta_rz_4*M_p_rx_rz + D_delta_y_4*M_p_y_rx
        + D_delta_z_4*M_p_z_rx;
    const pkmodes_real h_rx_delta_5 =
        D_delta_rx_5*M_p_rx_rx + D_delta_ry_5*M_p_rx_ry + D_delta_rz_5*M_p_rx_rz + D_delta_y_5*M_p_y_rx
        + D_delta_z_5*M_p_z_rx;
    const pkmodes_real h_rx_delta_6 =
        D_delta_rx_6*M_p_rx_rx + D_delta_ry_6*M_p_rx_ry + D_delta_rz_6*M_p_rx_rz + D_delta_y_6*M_p_y_rx
        + D_delta_z_6*M_p_z_rx;
    const pkmodes_real t308 = B_1_z*t256 + B_2_z*t259 + B_3_z*t262 + B_4_z*t265 + B_5_z*t268 + B_6_z*t271;
    const pkmodes_real h_rx_u_y = M_p_y_rx - t308;
    const pkmodes_real t309 = B_1_y*t256 + B_2_y*t259 + B_3_y*t262 + B_4_y*t265 + B_5_y*t268 + B_6_y*t271;
    const pkmodes_real h_rx_u_z = M_p_z_rx + t309;
    const pkmodes_real t310 = t256*(-B_1_x*n_1_z + B_1_z*n_1_x);
    const pkmodes_real h_ry_x_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry
        + t310;
    const pkmodes_real t311 = t259*(-B_2_x*n_2_z + B_2_z*n_2_x);
    const pkmodes_real h_ry_x_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry
        + t311;
    const pkmodes_real t312 = t262*(-B_3_x*n_3_z + B_3_z*n_3_x);
    const pkmodes_real h_ry_x_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry
        + t312;
    const pkmodes_real t313 = t265*(-B_4_x*n_4_z + B_4_z*n_4_x);
    const pkmodes_real h_ry_x_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry
        + t313;
    const pkmodes_real t314 = t268*(-B_5_x*n_5_z + B_5_z*n_5_x);
    const pkmodes_real h_ry_x_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry
        + t314;
    const pkmodes_real t315 = t271*(-B_6_x*n_6_z + B_6_z*n_6_x);
    const pkmodes_real h_ry_x_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry
        + t315;
    const pkmodes_real h_ry_delta_1 =
        D_delta_rx_1*M_p_rx_ry + D_delta_ry_1*M_p_ry_ry + D_delta_rz_1*M_p_ry_rz + D_delta_x_1*M_p_x_ry
        + D_delta_z_1*M_p_z_ry;
    const pkmodes_real h_ry_delta_2 =
        D_delta_rx_2*M_p_rx_ry + D_delta_ry_2*M_p_ry_ry + D_delta_rz_2*M_p_ry_rz + D_delta_x_2*M_p_x_ry
        + D_delta_z_2*M_p_z_ry;
    const pkmodes_real h_ry_delta_3 =
        D_delta_rx_3*M_p_rx_ry + D_delta_ry_3*M_p_ry_ry + D_delta_rz_3*M_p_ry_rz + D_delta_x_3*M_p_x_ry
        + D_delta_z_3*M_p_z_ry;
    const pkmodes_real h_ry_delta_4 =
        D_delta_rx_4*M_p_rx_ry + D_delta_ry_4*M_p_ry_ry + D_delta_rz_4*M_p_ry_rz + D_delta_x_4*M_p_x_ry
        + D_delta_z_4*M_p_z_ry;
    const pkmodes_real h_ry_delta_5 =
        D_delta_rx_5*M_p_rx_ry + D_delta_ry_5*M_p_ry_ry + D_delta_rz_5*M_p_ry_rz + D_delta_x_5*M_p_x_ry
        + D_delta_z_5*M_p_z_ry;
    const pkmodes_real h_ry_delta_6 =
        D_delta_rx_6*M_p_rx_ry + D_delta_ry_6*M_p_ry_ry + D_delta_rz_6*M_p_ry_rz + D_delta_x_6*M_p_x_ry
        + D_delta_z_6*M_p_z_ry;
    const pkmodes_real h_ry_u_x = M_p_x_ry + t308;
    const pkmodes_real t316 = B_1_x*t256 + B_2_x*t259 + B_3_x*t262 + B_4_x*t265 + B_5_x*t268 + B_6_x*t271;
    const pkmodes_real h_ry_u_z = M_p_z_ry - t316;
    const pkmodes_real t317 = t256*(B_1_x*n_1_y - B_1_y*n_1_x);
    const pkmodes_real h_rz_x_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz
        + t317;
    const pkmodes_real t318 = t259*(B_2_x*n_2_y - B_2_y*n_2_x);
    const pkmodes_real h_rz_x_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz
        + t318;
    const pkmodes_real t319 = t262*(B_3_x*n_3_y - B_3_y*n_3_x);
    const pkmodes_real h_rz_x_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz
        + t319;
    const pkmodes_real t320 = t265*(B_4_x*n_4_y - B_4_y*n_4_x);
    const pkmodes_real h_rz_x_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz
        + t320;
    const pkmodes_real t321 = t268*(B_5_x*n_5_y - B_5_y*n_5_x);
    const pkmodes_real h_rz_x_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz
        + t321;
    const pkmodes_real t322 = t271*(B_6_x*n_6_y - B_6_y*n_6_x);
    const pkmodes_real h_rz_x_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz
        + t322;
    const pkmodes_real h_rz_delta_1 =
        D_delta_rx_1*M_p_rx_rz + D_delta_ry_1*M_p_ry_rz + D_delta_rz_1*M_p_rz_rz + D_delta_x_1*M_p_x_rz
        + D_delta_y_1*M_p_y_rz;
    const pkmodes_real h_rz_delta_2 =
        D_delta_rx_2*M_p_rx_rz + D_delta_ry_2*M_p_ry_rz + D_delta_rz_2*M_p_rz_rz + D_delta_x_2*M_p_x_rz
        + D_delta_y_2*M_p_y_rz;
    const pkmodes_real h_rz_delta_3 =
        D_delta_rx_3*M_p_rx_rz + D_delta_ry_3*M_p_ry_rz + D_delta_rz_3*M_p_rz_rz + D_delta_x_3*M_p_x_rz
        + D_delta_y_3*M_p_y_rz;
    const pkmodes_real h_rz_delta_4 =
        D_delta_rx_4*M_p_rx_rz + D_delta_ry_4*M_p_ry_rz + D_delta_rz_4*M_p_rz_rz + D_delta_x_4*M_p_x_rz
        + D_delta_y_4*M_p_y_rz;
    const pkmodes_real h_rz_delta_5 =
        D_delta_rx_5*M_p_rx_rz + D_delta_ry_5*M_p_ry_rz + D_delta_rz_5*M_p_rz_rz + D_delta_x_5*M_p_x_rz
        + D_delta_y_5*M_p_y_rz;
    const pkmodes_real h_rz_delta_6 =
        D_delta_rx_6*M_p_rx_rz + D_delta_ry_6*M_p_ry_rz + D_delta_rz_6*M_p_rz_rz + D_delta_x_6*M_p_x_rz
        + D_delta_y_6*M_p_y_rz;
    const pkmodes_real h_rz_u_x = M_p_x_rz - t309;
    const pkmodes_real h_rz_u_y = M_p_y_rz + t316;
    const pkmodes_real t323 = (R(1.0)/R(3.0))*rho_b;
    const pkmodes_real t324 = l_f_1_2*t323;
    const pkmodes_real t325 = l_f_1_3*t323;
    const pkmodes_real t326 = t324 + t325;
    const pkmodes_real t327 = (R(1.0)/R(6.0))*rho_b;
    const pkmodes_real t328 = R_p_1*t327;
    const pkmodes_real t329 = l_f_1_3*t328;
    const pkmodes_real t330 = l_f_1_2*t328;
    const pkmodes_real t331 = l_f_2_2*t323;
    const pkmodes_real t332 = l_f_2_3*t323;
    const pkmodes_real t333 = t331 + t332;
    const pkmodes_real t334 = R_p_2*t327;
    const pkmodes_real t335 = l_f_2_3*t334;
    const pkmodes_real t336 = l_f_2_2*t334;
    const pkmodes_real t337 = l_f_3_2*t323;
    const pkmodes_real t338 = l_f_3_3*t323;
    const pkmodes_real t339 = t337 + t338;
    const pkmodes_real t340 = R_p_3*t327;
    const pkmodes_real t341 = l_f_3_3*t340;
    const pkmodes_real t342 = l_f_3_2*t340;
    const pkmodes_real t343 = l_f_4_2*t323;
    const pkmodes_real t344 = l_f_4_3*t323;
    const pkmodes_real t345 = t343 + t344;
    const pkmodes_real t346 = R_p_4*t327;
    const pkmodes_real t347 = l_f_4_3*t346;
    const pkmodes_real t348 = l_f_4_2*t346;
    const pkmodes_real t349 = l_f_5_2*t323;
    const pkmodes_real t350 = l_f_5_3*t323;
    const pkmodes_real t351 = t349 + t350;
    const pkmodes_real t352 = R_p_5*t327;
    const pkmodes_real t353 = l_f_5_3*t352;
    const pkmodes_real t354 = l_f_5_2*t352;
    const pkmodes_real t355 = l_f_6_2*t323;
    const pkmodes_real t356 = l_f_6_3*t323;
    const pkmodes_real t357 = t355 + t356;
    const pkmodes_real t358 = R_p_6*t327;
    const pkmodes_real t359 = l_f_6_3*t358;
    const pkmodes_real t360 = l_f_6_2*t358;
    const pkmodes_real t361 = (R_p_1*R_p_1);
    const pkmodes_real t362 = l_f_1_1*t361;
    const pkmodes_real t363 = t323*t362;
    const pkmodes_real t364 = d_1_1*t67;
    const pkmodes_real t365 = (R_p_2*R_p_2);
    const pkmodes_real t366 = l_f_2_1*t365;
    const pkmodes_real t367 = t323*t366;
    const pkmodes_real t368 = d_2_1*t69;
    const pkmodes_real t369 = (R_p_3*R_p_3);
    const pkmodes_real t370 = l_f_3_1*t369;
    const pkmodes_real t371 = t323*t370;
    const pkmodes_real t372 = d_3_1*t71;
    const pkmodes_real t373 = (R_p_4*R_p_4);
    const pkmodes_real t374 = l_f_4_1*t373;
    const pkmodes_real t375 = t323*t374;
    const pkmodes_real t376 = d_4_1*t73;
    const pkmodes_real t377 = (R_p_5*R_p_5);
    const pkmodes_real t378 = l_f_5_1*t377;
    const pkmodes_real t379 = t323*t378;
    const pkmodes_real t380 = d_5_1*t75;
    const pkmodes_real t381 = (R_p_6*R_p_6);
    const pkmodes_real t382 = l_f_6_1*t381;
    const pkmodes_real t383 = t323*t382;
    const pkmodes_real t384 = d_6_1*t77;
    const pkmodes_real t385 = d_1_2*t67;
    const pkmodes_real t386 = d_2_2*t69;
    const pkmodes_real t387 = d_3_2*t71;
    const pkmodes_real t388 = d_4_2*t73;
    const pkmodes_real t389 = d_5_2*t75;
    const pkmodes_real t390 = d_6_2*t77;
    const pkmodes_real t391 = m_F + m_t_1 + m_t_2 + m_t_3 + m_t_4 + m_t_5 + m_t_6 + t112;
    const pkmodes_real t392 = k_1_2 + k_1_3;
    const pkmodes_real t393 = D_p_x_1*k_C;
    const pkmodes_real t394 = D_p_y_1*k_C;
    const pkmodes_real t395 = D_p_z_1*k_C;
    const pkmodes_real t396 = -R_p_1*k_1_3;
    const pkmodes_real t397 = -R_p_1*k_1_2;
    const pkmodes_real t398 = k_2_2 + k_2_3;
    const pkmodes_real t399 = D_p_x_2*k_C;
    const pkmodes_real t400 = D_p_y_2*k_C;
    const pkmodes_real t401 = D_p_z_2*k_C;
    const pkmodes_real t402 = -R_p_2*k_2_3;
    const pkmodes_real t403 = -R_p_2*k_2_2;
    const pkmodes_real t404 = k_3_2 + k_3_3;
    const pkmodes_real t405 = D_p_x_3*k_C;
    const pkmodes_real t406 = D_p_y_3*k_C;
    const pkmodes_real t407 = D_p_z_3*k_C;
    const pkmodes_real t408 = -R_p_3*k_3_3;
    const pkmodes_real t409 = -R_p_3*k_3_2;
    const pkmodes_real t410 = k_4_2 + k_4_3;
    const pkmodes_real t411 = D_p_x_4*k_C;
    const pkmodes_real t412 = D_p_y_4*k_C;
    const pkmodes_real t413 = D_p_z_4*k_C;
    const pkmodes_real t414 = -R_p_4*k_4_3;
    const pkmodes_real t415 = -R_p_4*k_4_2;
    const pkmodes_real t416 = k_5_2 + k_5_3;
    const pkmodes_real t417 = D_p_x_5*k_C;
    const pkmodes_real t418 = D_p_y_5*k_C;
    const pkmodes_real t419 = D_p_z_5*k_C;
    const pkmodes_real t420 = -R_p_5*k_5_3;
    const pkmodes_real t421 = -R_p_5*k_5_2;
    const pkmodes_real t422 = k_6_2 + k_6_3;
    const pkmodes_real t423 = -R_p_6*k_6_3;
    const pkmodes_real t424 = -R_p_6*k_6_2;
    const pkmodes_real t425 = D_p_x_6*k_C;
    const pkmodes_real t426 = D_p_y_6*k_C;
    const pkmodes_real t427 = D_p_z_6*k_C;
    const pkmodes_real t428 = d_1_1*k_S;
    const pkmodes_real t429 = k_1_1*t361;
    const pkmodes_real t430 = d_2_1*k_S;
    const pkmodes_real t431 = k_2_1*t365;
    const pkmodes_real t432 = d_3_1*k_S;
    const pkmodes_real t433 = k_3_1*t369;
    const pkmodes_real t434 = d_4_1*k_S;
    const pkmodes_real t435 = k_4_1*t373;
    const pkmodes_real t436 = d_5_1*k_S;
    const pkmodes_real t437 = k_5_1*t377;
    const pkmodes_real t438 = d_6_1*k_S;
    const pkmodes_real t439 = k_6_1*t381;
    const pkmodes_real t440 = d_1_2*k_S;
    const pkmodes_real t441 = d_2_2*k_S;
    const pkmodes_real t442 = d_3_2*k_S;
    const pkmodes_real t443 = d_4_2*k_S;
    const pkmodes_real t444 = d_5_2*k_S;
    const pkmodes_real t445 = d_6_2*k_S;
    const pkmodes_real t446 = D_delta_x_1*k_C;
    const pkmodes_real t447 = D_delta_y_1*k_C;
    const pkmodes_real t448 = D_delta_z_1*k_C;
    const pkmodes_real t449 = D_delta_x_2*k_C;
    const pkmodes_real t450 = D_delta_y_2*k_C;
    const pkmodes_real t451 = D_delta_z_2*k_C;
    const pkmodes_real t452 = D_delta_x_3*k_C;
    const pkmodes_real t453 = D_delta_y_3*k_C;
    const pkmodes_real t454 = D_delta_z_3*k_C;
    const pkmodes_real t455 = D_delta_x_4*k_C;
    const pkmodes_real t456 = D_delta_y_4*k_C;
    const pkmodes_real t457 = D_delta_z_4*k_C;
    const pkmodes_real t458 = D_delta_x_5*k_C;
    const pkmodes_real t459 = D_delta_y_5*k_C;
    const pkmodes_real t460 = D_delta_z_5*k_C;
    const pkmodes_real t461 = B_1_z*mu_1*n_1_x - t217;
    const pkmodes_real t462 = B_2_z*mu_2*n_2_x - t218;
    const pkmodes_real t463 = B_3_z*mu_3*n_3_x - t219;
    const pkmodes_real t464 = B_4_z*mu_4*n_4_x - t220;
    const pkmodes_real t465 = B_5_z*mu_5*n_5_x - t221;
    const pkmodes_real t466 = B_6_z*mu_6*n_6_x - t222;
    memset(M, 0, sizeof(pkmodes_real[39][39]));
    M[0][0] =
        D_p_rx_1*h_rx_x_1 + D_p_rx_1*t302 + D_p_ry_1*h_ry_x_1 + D_p_ry_1*t310 + D_p_rz_1*h_rz_x_1
        + D_p_rz_1*t317 + D_p_x_1*h_x_x_1 + D_p_x_1*t283 + D_p_y_1*h_y_x_1 + D_p_y_1*t290 + D_p_z_1*h_z_x_1
        + D_p_z_1*t296 + m_t_1 + t229 + t326;
    M[0][1] = M[1][0] =
        D_p_rx_1*h_rx_x_2 + D_p_rx_2*t302 + D_p_ry_1*h_ry_x_2 + D_p_ry_2*t310 + D_p_rz_1*h_rz_x_2
        + D_p_rz_2*t317 + D_p_x_1*h_x_x_2 + D_p_x_2*t283 + D_p_y_1*h_y_x_2 + D_p_y_2*t290 + D_p_z_1*h_z_x_2
        + D_p_z_2*t296;
    M[0][2] = M[2][0] =
        D_p_rx_1*h_rx_x_3 + D_p_rx_3*t302 + D_p_ry_1*h_ry_x_3 + D_p_ry_3*t310 + D_p_rz_1*h_rz_x_3
        + D_p_rz_3*t317 + D_p_x_1*h_x_x_3 + D_p_x_3*t283 + D_p_y_1*h_y_x_3 + D_p_y_3*t290 + D_p_z_1*h_z_x_3
        + D_p_z_3*t296;
    M[0][3] = M[3][0] =
        D_p_rx_1*h_rx_x_4 + D_p_rx_4*t302 + D_p_ry_1*h_ry_x_4 + D_p_ry_4*t310 + D_p_rz_1*h_rz_x_4
        + D_p_rz_4*t317 + D_p_x_1*h_x_x_4 + D_p_x_4*t283 + D_p_y_1*h_y_x_4 + D_p_y_4*t290 + D_p_z_1*h_z_x_4
        + D_p_z_4*t296;
    M[0][4] = M[4][0] =
        D_p_rx_1*h_rx_x_5 + D_p_rx_5*t302 + D_p_ry_1*h_ry_x_5 + D_p_ry_5*t310 + D_p_rz_1*h_rz_x_5
        + D_p_rz_5*t317 + D_p_x_1*h_x_x_5 + D_p_x_5*t283 + D_p_y_1*h_y_x_5 + D_p_y_5*t290 + D_p_z_1*h_z_x_5
        + D_p_z_5*t296;
    M[0][5] = M[5][0] =
        D_p_rx_1*h_rx_x_6 + D_p_rx_6*t302 + D_p_ry_1*h_ry_x_6 + D_p_ry_6*t310 + D_p_rz_1*h_rz_x_6
        + D_p_rz_6*t317 + D_p_x_1*h_x_x_6 + D_p_x_6*t283 + D_p_y_1*h_y_x_6 + D_p_y_6*t290 + D_p_z_1*h_z_x_6
        + D_p_z_6*t296;
    M[0][6] = M[6][0] = t329;
    M[0][12] = M[12][0] = t330;
    M[0][24] = M[24][0] =
        D_delta_rx_1*t302 + D_delta_ry_1*t310 + D_delta_rz_1*t317 + D_delta_x_1*t283 + D_delta_y_1*t290
        + D_delta_z_1*t296 + D_p_rx_1*h_rx_delta_1 + D_p_ry_1*h_ry_delta_1 + D_p_rz_1*h_rz_delta_1
        + D_p_x_1*h_x_delta_1 + D_p_y_1*h_y_delta_1 + D_p_z_1*h_z_delta_1;
    M[0][25] = M[25][0] =
        D_delta_rx_2*t302 + D_delta_ry_2*t310 + D_delta_rz_2*t317 + D_delta_x_2*t283 + D_delta_y_2*t290
        + D_delta_z_2*t296 + D_p_rx_1*h_rx_delta_2 + D_p_ry_1*h_ry_delta_2 + D_p_rz_1*h_rz_delta_2
        + D_p_x_1*h_x_delta_2 + D_p_y_1*h_y_delta_2 + D_p_z_1*h_z_delta_2;
    M[0][26] = M[26][0] =
        D_delta_rx_3*t302 + D_delta_ry_3*t310 + D_delta_rz_3*t317 + D_delta_x_3*t283 + D_delta_y_3*t290
        + D_delta_z_3*t296 + D_p_rx_1*h_rx_delta_3 + D_p_ry_1*h_ry_delta_3 + D_p_rz_1*h_rz_delta_3
        + D_p_x_1*h_x_delta_3 + D_p_y_1*h_y_delta_3 + D_p_z_1*h_z_delta_3;
    M[0][27] = M[27][0] =
        D_delta_rx_4*t302 + D_delta_ry_4*t310 + D_delta_rz_4*t317 + D_delta_x_4*t283 + D_delta_y_4*t290
        + D_delta_z_4*t296 + D_p_rx_1*h_rx_delta_4 + D_p_ry_1*h_ry_delta_4 + D_p_rz_1*h_rz_delta_4
        + D_p_x_1*h_x_delta_4 + D_p_y_1*h_y_delta_4 + D_p_z_1*h_z_delta_4;
    M[0][28] = M[28][0] =
        D_delta_rx_5*t302 + D_delta_ry_5*t310 + D_delta_rz_5*t317 + D_delta_x_5*t283 + D_delta_y_5*t290
        + D_delta_z_5*t296 + D_p_rx_1*h_rx_delta_5 + D_p_ry_1*h_ry_delta_5 + D_p_rz_1*h_rz_delta_5
        + D_p_x_1*h_x_delta_5 + D_p_y_1*h_y_delta_5 + D_p_z_1*h_z_delta_5;
    M[0][29] = M[29][0] =
        D_delta_rx_6*t302 + D_delta_ry_6*t310 + D_delta_rz_6*t317 + D_delta_x_6*t283 + D_delta_y_6*t290
        + D_delta_z_6*t296 + D_p_rx_1*h_rx_delta_6 + D_p_ry_1*h_ry_delta_6 + D_p_rz_1*h_rz_delta_6
        + D_p_x_1*h_x_delta_6 + D_p_y_1*h_y_delta_6 + D_p_z_1*h_z_delta_6;
    M[0][30] = M[30][0] = t326;
    M[0][36] = M[36][0] = D_p_ry_1*h_ry_u_x + D_p_rz_1*h_rz_u_x + D_p_x_1*h_x_u_x + m_t_1*n_1_x + n_1_x*t106;
    M[0][37] = M[37][0] = D_p_rx_1*h_rx_u_y + D_p_rz_1*h_rz_u_y + D_p_y_1*h_y_u_y + m_t_1*n_1_y + n_1_y*t106;
    M[0][38] = M[38][0] = D_p_rx_1*h_rx_u_z + D_p_ry_1*h_ry_u_z + D_p_z_1*h_z_u_z + m_t_1*n_1_z + n_1_z*t106;
    M[1][1] =
        D_p_rx_2*h_rx_x_2 + D_p_rx_2*t303 + D_p_ry_2*h_ry_x_2 + D_p_ry_2*t311 + D_p_rz_2*h_rz_x_2
        + D_p_rz_2*t318 + D_p_x_2*h_x_x_2 + D_p_x_2*t284 + D_p_y_2*h_y_x_2 + D_p_y_2*t291 + D_p_z_2*h_z_x_2
        + D_p_z_2*t297 + m_t_2 + t230 + t333;
    M[1][2] = M[2][1] =
        D_p_rx_2*h_rx_x_3 + D_p_rx_3*t303 + D_p_ry_2*h_ry_x_3 + D_p_ry_3*t311 + D_p_rz_2*h_rz_x_3
        + D_p_rz_3*t318 + D_p_x_2*h_x_x_3 + D_p_x_3*t284 + D_p_y_2*h_y_x_3 + D_p_y_3*t291 + D_p_z_2*h_z_x_3
        + D_p_z_3*t297;
    M[1][3] = M[3][1] =
        D_p_rx_2*h_rx_x_4 + D_p_rx_4*t303 + D_p_ry_2*h_ry_x_4 + D_p_ry_4*t311 + D_p_rz_2*h_rz_x_4
        + D_p_rz_4*t318 + D_p_x_2*h_x_x_4 + D_p_x_4*t284 + D_p_y_2*h_y_x_4 + D_p_y_4*t291 + D_p_z_2*h_z_x_4
        + D_p_z_4*t297;
    M[1][4] = M[4][1] =
        D_p_rx_2*h_rx_x_5 + D_p_rx_5*t303 + D_p_ry_2*h_ry_x_5 + D_p_ry_5*t311 + D_p_rz_2*h_rz_x_5
        + D_p_rz_5*t318 + D_p_x_2*h_x_x_5 + D_p_x_5*t284 + D_p_y_2*h_y_x_5 + D_p_y_5*t291 + D_p_z_2*h_z_x_5
        + D_p_z_5*t297;
    M[1][5] = M[5][1] =
        D_p_rx_2*h_rx_x_6 + D_p_rx_6*t303 + D_p_ry_2*h_ry_x_6 + D_p_ry_6*t311 + D_p_rz_2*h_rz_x_6
        + D_p_rz_6*t318 + D_p_x_2*h_x_x_6 + D_p_x_6*t284 + D_p_y_2*h_y_x_6 + D_p_y_6*t291 + D_p_z_2*h_z_x_6
        + D_p_z_6*t297;
    M[1][7] = M[7][1] = t335;
    M[1][13] = M[13][1] = t336;
    M[1][24] = M[24][1] =
        D_delta_rx_1*t303 + D_delta_ry_1*t311 + D_delta_rz_1*t318 + D_delta_x_1*t284 + D_delta_y_1*t291
        + D_delta_z_1*t297 + D_p_rx_2*h_rx_delta_1 + D_p_ry_2*h_ry_delta_1 + D_p_rz_2*h_rz_delta_1
        + D_p_x_2*h_x_delta_1 + D_p_y_2*h_y_delta_1 + D_p_z_2*h_z_delta_1;
    M[1][25] = M[25][1] =
        D_delta_rx_2*t303 + D_delta_ry_2*t311 + D_delta_rz_2*t318 + D_delta_x_2*t284 + D_delta_y_2*t291
        + D_delta_z_2*t297 + D_p_rx_2*h_rx_delta_2 + D_p_ry_2*h_ry_delta_2 + D_p_rz_2*h_rz_delta_2
        + D_p_x_2*h_x_delta_2 + D_p_y_2*h_y_delta_2 + D_p_z_2*h_z_delta_2;
    M[1][26] = M[26][1] =
        D_delta_rx_3*t303 + D_delta_ry_3*t311 + D_delta_rz_3*t318 + D_delta_x_3*t284 + D_delta_y_3*t291
        + D_delta_z_3*t297 + D_p_rx_2*h_rx_delta_3 + D_p_ry_2*h_ry_delta_3 + D_p_rz_2*h_rz_delta_3
        + D_p_x_2*h_x_delta_3 + D_p_y_2*h_y_delta_3 + D_p_z_2*h_z_delta_3;
    M[1][27] = M[27][1] =
        D_delta_rx_4*t303 + D_delta_ry_4*t311 + D_delta_rz_4*t318 + D_delta_x_4*t284 + D_delta_y_4*t291
        + D_delta_z_4*t297 + D_p_rx_2*h_rx_delta_4 + D_p_ry_2*h_ry_delta_4 + D_p_rz_2*h_rz_delta_4
        + D_p_x_2*h_x_delta_4 + D_p_y_2*h_y_delta_4 + D_p_z_2*h_z_delta_4;
    M[1][28] = M[28][1] =
        D_delta_rx_5*t303 + D_delta_ry_5*t311 + D_delta_rz_5*t318 + D_delta_x_5*t284 + D_delta_y_5*t291
        + D_delta_z_5*t297 + D_p_rx_2*h_rx_delta_5 + D_p_ry_2*h_ry_delta_5 + D_p_rz_2*h_rz_delta_5
        + D_p_x_2*h_x_delta_5 + D_p_y_2*h_y_delta_5 + D_p_z_2*h_z_delta_5;
    M[1][29] = M[29][1] =
        D_delta_rx_6*t303 + D_delta_ry_6*t311 + D_delta_rz_6*t318 + D_delta_x_6*t284 + D_delta_y_6*t291
        + D_delta_z_6*t297 + D_p_rx_2*h_rx_delta_6 + D_p_ry_2*h_ry_delta_6 + D_p_rz_2*h_rz_delta_6
        + D_p_x_2*h_x_delta_6 + D_p_y_2*h_y_delta_6 + D_p_z_2*h_z_delta_6;
    M[1][31] = M[31][1] = t333;
    M[1][36] = M[36][1] = D_p_ry_2*h_ry_u_x + D_p_rz_2*h_rz_u_x + D_p_x_2*h_x_u_x + m_t_2*n_2_x + n_2_x*t107;
    M[1][37] = M[37][1] = D_p_rx_2*h_rx_u_y + D_p_rz_2*h_rz_u_y + D_p_y_2*h_y_u_y + m_t_2*n_2_y + n_2_y*t107;
    M[1][38] = M[38][1] = D_p_rx_2*h_rx_u_z + D_p_ry_2*h_ry_u_z + D_p_z_2*h_z_u_z + m_t_2*n_2_z + n_2_z*t107;
    M[2][2] =
        D_p_rx_3*h_rx_x_3 + D_p_rx_3*t304 + D_p_ry_3*h_ry_x_3 + D_p_ry_3*t312 + D_p_rz_3*h_rz_x_3
        + D_p_rz_3*t319 + D_p_x_3*h_x_x_3 + D_p_x_3*t285 + D_p_y_3*h_y_x_3 + D_p_y_3*t292 + D_p_z_3*h_z_x_3
        + D_p_z_3*t298 + m_t_3 + t231 + t339;
    M[2][3] = M[3][2] =
        D_p_rx_3*h_rx_x_4 + D_p_rx_4*t304 + D_p_ry_3*h_ry_x_4 + D_p_ry_4*t312 + D_p_rz_3*h_rz_x_4
        + D_p_rz_4*t319 + D_p_x_3*h_x_x_4 + D_p_x_4*t285 + D_p_y_3*h_y_x_4 + D_p_y_4*t292 + D_p_z_3*h_z_x_4
        + D_p_z_4*t298;
    M[2][4] = M[4][2] =
        D_p_rx_3*h_rx_x_5 + D_p_rx_5*t304 + D_p_ry_3*h_ry_x_5 + D_p_ry_5*t312 + D_p_rz_3*h_rz_x_5
        + D_p_rz_5*t319 + D_p_x_3*h_x_x_5 + D_p_x_5*t285 + D_p_y_3*h_y_x_5 + D_p_y_5*t292 + D_p_z_3*h_z_x_5
        + D_p_z_5*t298;
    M[2][5] = M[5][2] =
        D_p_rx_3*h_rx_x_6 + D_p_rx_6*t304 + D_p_ry_3*h_ry_x_6 + D_p_ry_6*t312 + D_p_rz_3*h_rz_x_6
        + D_p_rz_6*t319 + D_p_x_3*h_x_x_6 + D_p_x_6*t285 + D_p_y_3*h_y_x_6 + D_p_y_6*t292 + D_p_z_3*h_z_x_6
        + D_p_z_6*t298;
    M[2][8] = M[8][2] = t341;
    M[2][14] = M[14][2] = t342;
    M[2][24] = M[24][2] =
        D_delta_rx_1*t304 + D_delta_ry_1*t312 + D_delta_rz_1*t319 + D_delta_x_1*t285 + D_delta_y_1*t292
        + D_delta_z_1*t298 + D_p_rx_3*h_rx_delta_1 + D_p_ry_3*h_ry_delta_1 + D_p_rz_3*h_rz_delta_1
        + D_p_x_3*h_x_delta_1 + D_p_y_3*h_y_delta_1 + D_p_z_3*h_z_delta_1;
    M[2][25] = M[25][2] =
        D_delta_rx_2*t304 + D_delta_ry_2*t312 + D_delta_rz_2*t319 + D_delta_x_2*t285 + D_delta_y_2*t292
        + D_delta_z_2*t298 + D_p_rx_3*h_rx_delta_2 + D_p_ry_3*h_ry_delta_2 + D_p_rz_3*h_rz_delta_2
        + D_p_x_3*h_x_delta_2 + D_p_y_3*h_y_delta_2 + D_p_z_3*h_z_delta_2;
    M[2][26] = M[26][2] =
        D_delta_rx_3*t304 + D_delta_ry_3*t312 + D_delta_rz_3*t319 + D_delta_x_3*t285 + D_delta_y_3*t292
        + D_delta_z_3*t298 + D_p_rx_3*h_rx_delta_3 + D_p_ry_3*h_ry_delta_3 + D_p_rz_3*h_rz_delta_3
        + D_p_x_3*h_x_delta_3 + D_p_y_3*h_y_delta_3 + D_p_z_3*h_z_delta_3;
    M[2][27] = M[27][2] =
        D_delta_rx_4*t304 + D_delta_ry_4*t312 + D_delta_rz_4*t319 + D_delta_x_4*t285 + D_delta_y_4*t292
        + D_delta_z_4*t298 + D_p_rx_3*h_rx_delta_4 + D_p_ry_3*h_ry_delta_4 + D_p_rz_3*h_rz_delta_4
        + D_p_x_3*h_x_delta_4 + D_p_y_3*h_y_delta_4 + D_p_z_3*h_z_delta_4;
    M[2][28] = M[28][2] =
        D_delta_rx_5*t304 + D_delta_ry_5*t312 + D_delta_rz_5*t319 + D_delta_x_5*t285 + D_delta_y_5*t292
        + D_delta_z_5*t298 + D_p_rx_3*h_rx_delta_5 + D_p_ry_3*h_ry_delta_5 + D_p_rz_3*h_rz_delta_5
        + D_p_x_3*h_x_delta_5 + D_p_y_3*h_y_delta_5 + D_p_z_3*h_z_delta_5;
    M[2][29] = M[29][2] =
        D_delta_rx_6*t304 + D_delta_ry_6*t312 + D_delta_rz_6*t319 + D_delta_x_6*t285 + D_delta_y_6*t292
        + D_delta_z_6*t298 + D_p_rx_3*h_rx_delta_6 + D_p_ry_3*h_ry_delta_6 + D_p_rz_3*h_rz_delta_6
        + D_p_x_3*h_x_delta_6 + D_p_y_3*h_y_delta_6 + D_p_z_3*h_z_delta_6;
    M[2][32] = M[32][2] = t339;
    M[2][36] = M[36][2] = D_p_ry_3*h_ry_u_x + D_p_rz_3*h_rz_u_x + D_p_x_3*h_x_u_x + m_t_3*n_3_x + n_3_x*t108;
    M[2][37] = M[37][2] = D_p_rx_3*h_rx_u_y + D_p_rz_3*h_rz_u_y + D_p_y_3*h_y_u_y + m_t_3*n_3_y + n_3_y*t108;
    M[2][38] = M[38][2] = D_p_rx_3*h_rx_u_z + D_p_ry_3*h_ry_u_z + D_p_z_3*h_z_u_z + m_t_3*n_3_z + n_3_z*t108;
    M[3][3] =
        D_p_rx_4*h_rx_x_4 + D_p_rx_4*t305 + D_p_ry_4*h_ry_x_4 + D_p_ry_4*t313 + D_p_rz_4*h_rz_x_4
        + D_p_rz_4*t320 + D_p_x_4*h_x_x_4 + D_p_x_4*t286 + D_p_y_4*h_y_x_4 + D_p_y_4*t293 + D_p_z_4*h_z_x_4
        + D_p_z_4*t299 + m_t_4 + t232 + t345;
    M[3][4] = M[4][3] =
        D_p_rx_4*h_rx_x_5 + D_p_rx_5*t305 + D_p_ry_4*h_ry_x_5 + D_p_ry_5*t313 + D_p_rz_4*h_rz_x_5
        + D_p_rz_5*t320 + D_p_x_4*h_x_x_5 + D_p_x_5*t286 + D_p_y_4*h_y_x_5 + D_p_y_5*t293 + D_p_z_4*h_z_x_5
        + D_p_z_5*t299;
    M[3][5] = M[5][3] =
        D_p_rx_4*h_rx_x_6 + D_p_rx_6*t305 + D_p_ry_4*h_ry_x_6 + D_p_ry_6*t313 + D_p_rz_4*h_rz_x_6
        + D_p_rz_6*t320 + D_p_x_4*h_x_x_6 + D_p_x_6*t286 + D_p_y_4*h_y_x_6 + D_p_y_6*t293 + D_p_z_4*h_z_x_6
        + D_p_z_6*t299;
    M[3][9] = M[9][3] = t347;
    M[3][15] = M[15][3] = t348;
    M[3][24] = M[24][3] =
        D_delta_rx_1*t305 + D_delta_ry_1*t313 + D_delta_rz_1*t320 + D_delta_x_1*t286 + D_delta_y_1*t293
        + D_delta_z_1*t299 + D_p_rx_4*h_rx_delta_1 + D_p_ry_4*h_ry_delta_1 + D_p_rz_4*h_rz_delta_1
        + D_p_x_4*h_x_delta_1 + D_p_y_4*h_y_delta_1 + D_p_z_4*h_z_delta_1;
    M[3][25] = M[25][3] =
        D_delta_rx_2*t305 + D_delta_ry_2*t313 + D_delta_rz_2*t320 + D_delta_x_2*t286 + D_delta_y_2*t293
        + D_delta_z_2*t299 + D_p_rx_4*h_rx_delta_2 + D_p_ry_4*h_ry_delta_2 + D_p_rz_4*h_rz_delta_2
        + D_p_x_4*h_x_delta_2 + D_p_y_4*h_y_delta_2 + D_p_z_4*h_z_delta_2;
    M[3][26] = M[26][3] =
        D_delta_rx_3*t305 + D_delta_ry_3*t313 + D_delta_rz_3*t320 + D_delta_x_3*t286 + D_delta_y_3*t293
        + D_delta_z_3*t299 + D_p_rx_4*h_rx_delta_3 + D_p_ry_4*h_ry_delta_3 + D_p_rz_4*h_rz_delta_3
        + D_p_x_4*h_x_delta_3 + D_p_y_4*h_y_delta_3 + D_p_z_4*h_z_delta_3;
    M[3][27] = M[27][3] =
        D_delta_rx_4*t305 + D_delta_ry_4*t313 + D_delta_rz_4*t320 + D_delta_x_4*t286 + D_delta_y_4*t293
        + D_delta_z_4*t299 + D_p_rx_4*h_rx_delta_4 + D_p_ry_4*h_ry_delta_4 + D_p_rz_4*h_rz_delta_4
        + D_p_x_4*h_x_delta_4 + D_p_y_4*h_y_delta_4 + D_p_z_4*h_z_delta_4;
    M[3][28] = M[28][3] =
        D_delta_rx_5*t305 + D_delta_ry_5*t313 + D_delta_rz_5*t320 + D_delta_x_5*t286 + D_delta_y_5*t293
        + D_delta_z_5*t299 + D_p_rx_4*h_rx_delta_5 + D_p_ry_4*h_ry_delta_5 + D_p_rz_4*h_rz_delta_5
        + D_p_x_4*h_x_delta_5 + D_p_y_4*h_y_delta_5 + D_p_z_4*h_z_delta_5;
    M[3][29] = M[29][3] =
        D_delta_rx_6*t305 + D_delta_ry_6*t313 + D_delta_rz_6*t320 + D_delta_x_6*t286 + D_delta_y_6*t293
        + D_delta_z_6*t299 + D_p_rx_4*h_rx_delta_6 + D_p_ry_4*h_ry_delta_6 + D_p_rz_4*h_rz_delta_6
        + D_p_x_4*h_x_delta_6 + D_p_y_4*h_y_delta_6 + D_p_z_4*h_z_delta_6;
    M[3][33] = M[33][3] = t345;
    M[3][36] = M[36][3] = D_p_ry_4*h_ry_u_x + D_p_rz_4*h_rz_u_x + D_p_x_4*h_x_u_x + m_t_4*n_4_x + n_4_x*t109;
    M[3][37] = M[37][3] = D_p_rx_4*h_rx_u_y + D_p_rz_4*h_rz_u_y + D_p_y_4*h_y_u_y + m_t_4*n_4_y + n_4_y*t109;
    M[3][38] = M[38][3] = D_p_rx_4*h_rx_u_z + D_p_ry_4*h_ry_u_z + D_p_z_4*h_z_u_z + m_t_4*n_4_z + n_4_z*t109;
    M[4][4] =
        D_p_rx_5*h_rx_x_5 + D_p_rx_5*t306 + D_p_ry_5*h_ry_x_5 + D_p_ry_5*t314 + D_p_rz_5*h_rz_x_5
        + D_p_rz_5*t321 + D_p_x_5*h_x_x_5 + D_p_x_5*t287 + D_p_y_5*h_y_x_5 + D_p_y_5*t294 + D_p_z_5*h_z_x_5
        + D_p_z_5*t300 + m_t_5 + t233 + t351;
    M[4][5] = M[5][4] =
        D_p_rx_5*h_rx_x_6 + D_p_rx_6*t306 + D_p_ry_5*h_ry_x_6 + D_p_ry_6*t314 + D_p_rz_5*h_rz_x_6
        + D_p_rz_6*t321 + D_p_x_5*h_x_x_6 + D_p_x_6*t287 + D_p_y_5*h_y_x_6 + D_p_y_6*t294 + D_p_z_5*h_z_x_6
        + D_p_z_6*t300;
    M[4][10] = M[10][4] = t353;
    M[4][16] = M[16][4] = t354;
    M[4][24] = M[24][4] =
        D_delta_rx_1*t306 + D_delta_ry_1*t314 + D_delta_rz_1*t321 + D_delta_x_1*t287 + D_delta_y_1*t294
        + D_delta_z_1*t300 + D_p_rx_5*h_rx_delta_1 + D_p_ry_5*h_ry_delta_1 + D_p_rz_5*h_rz_delta_1
        + D_p_x_5*h_x_delta_1 + D_p_y_5*h_y_delta_1 + D_p_z_5*h_z_delta_1;
    M[4][25] = M[25][4] =
        D_delta_rx_2*t306 + D_delta_ry_2*t314 + D_delta_rz_2*t321 + D_delta_x_2*t287 + D_delta_y_2*t294
        + D_delta_z_2*t300 + D_p_rx_5*h_rx_delta_2 + D_p_ry_5*h_ry_delta_2 + D_p_rz_5*h_rz_delta_2
        + D_p_x_5*h_x_delta_2 + D_p_y_5*h_y_delta_2 + D_p_z_5*h_z_delta_2;
    M[4][26] = M[26][4] =
        D_delta_rx_3*t306 + D_delta_ry_3*t314 + D_delta_rz_3*t321 + D_delta_x_3*t287 + D_delta_y_3*t294
        + D_delta_z_3*t300 + D_p_rx_5*h_rx_delta_3 + D_p_ry_5*h_ry_delta_3 + D_p_rz_5*h_rz_delta_3
        + D_p_x_5*h_x_delta_3 + D_p_y_5*h_y_delta_3 + D_p_z_5*h_z_delta_3;
    M[4][27] = M[27][4] =
        D_delta_rx_4*t306 + D_delta_ry_4*t314 + D_delta_rz_4*t321 + D_delta_x_4*t287 + D_delta_y_4*t294
        + D_delta_z_4*t300 + D_p_rx_5*h_rx_delta_4 + D_p_ry_5*h_ry_delta_4 + D_p_rz_5*h_rz_delta_4
        + D_p_x_5*h_x_delta_4 + D_p_y_5*h_y_delta_4 + D_p_z_5*h_z_delta_4;
    M[4][28] = M[28][4] =
        D_delta_rx_5*t306 + D_delta_ry_5*t314 + D_delta_rz_5*t321 + D_delta_x_5*t287 + D_delta_y_5*t294
        + D_delta_z_5*t300 + D_p_rx_5*h_rx_delta_5 + D_p_ry_5*h_ry_delta_5 + D_p_rz_5*h_rz_delta_5
        + D_p_x_5*h_x_delta_5 + D_p_y_5*h_y_delta_5 + D_p_z_5*h_z_delta_5;
    M[4][29] = M[29][4] =
        D_delta_rx_6*t306 + D_delta_ry_6*t314 + D_delta_rz_6*t321 + D_delta_x_6*t287 + D_delta_y_6*t294
        + D_delta_z_6*t300 + D_p_rx_5*h_rx_delta_6 + D_p_ry_5*h_ry_delta_6 + D_p_rz_5*h_rz_delta_6
        + D_p_x_5*h_x_delta_6 + D_p_y_5*h_y_delta_6 + D_p_z_5*h_z_delta_6;
    M[4][34] = M[34][4] = t351;
    M[4][36] = M[36][4] = D_p_ry_5*h_ry_u_x + D_p_rz_5*h_rz_u_x + D_p_x_5*h_x_u_x + m_t_5*n_5_x + n_5_x*t110;
    M[4][37] = M[37][4] = D_p_rx_5*h_rx_u_y + D_p_rz_5*h_rz_u_y + D_p_y_5*h_y_u_y + m_t_5*n_5_y + n_5_y*t110;
    M[4][38] = M[38][4] = D_p_rx_5*h_rx_u_z + D_p_ry_5*h_ry_u_z + D_p_z_5*h_z_u_z + m_t_5*n_5_z + n_5_z*t110;
    M[5][5] =
        D_p_rx_6*h_rx_x_6 + D_p_rx_6*t307 + D_p_ry_6*h_ry_x_6 + D_p_ry_6*t315 + D_p_rz_6*h_rz_x_6
        + D_p_rz_6*t322 + D_p_x_6*h_x_x_6 + D_p_x_6*t288 + D_p_y_6*h_y_x_6 + D_p_y_6*t295 + D_p_z_6*h_z_x_6
        + D_p_z_6*t301 + m_t_6 + t234 + t357;
    M[5][11] = M[11][5] = t359;
    M[5][17] = M[17][5] = t360;
    M[5][24] = M[24][5] =
        D_delta_rx_1*t307 + D_delta_ry_1*t315 + D_delta_rz_1*t322 + D_delta_x_1*t288 + D_delta_y_1*t295
        + D_delta_z_1*t301 + D_p_rx_6*h_rx_delta_1 + D_p_ry_6*h_ry_delta_1 + D_p_rz_6*h_rz_delta_1
        + D_p_x_6*h_x_delta_1 + D_p_y_6*h_y_delta_1 + D_p_z_6*h_z_delta_1;
    M[5][25] = M[25][5] =
        D_delta_rx_2*t307 + D_delta_ry_2*t315 + D_delta_rz_2*t322 + D_delta_x_2*t288 + D_delta_y_2*t295
        + D_delta_z_2*t301 + D_p_rx_6*h_rx_delta_2 + D_p_ry_6*h_ry_delta_2 + D_p_rz_6*h_rz_delta_2
        + D_p_x_6*h_x_delta_2 + D_p_y_6*h_y_delta_2 + D_p_z_6*h_z_delta_2;
    M[5][26] = M[26][5] =
        D_delta_rx_3*t307 + D_delta_ry_3*t315 + D_delta_rz_3*t322 + D_delta_x_3*t288 + D_delta_y_3*t295
        + D_delta_z_3*t301 + D_p_rx_6*h_rx_delta_3 + D_p_ry_6*h_ry_delta_3 + D_p_rz_6*h_rz_delta_3
        + D_p_x_6*h_x_delta_3 + D_p_y_6*h_y_delta_3 + D_p_z_6*h_z_delta_3;
    M[5][27] = M[27][5] =
        D_delta_rx_4*t307 + D_delta_ry_4*t315 + D_delta_rz_4*t322 + D_delta_x_4*t288 + D_delta_y_4*t295
        + D_delta_z_4*t301 + D_p_rx_6*h_rx_delta_4 + D_p_ry_6*h_ry_delta_4 + D_p_rz_6*h_rz_delta_4
        + D_p_x_6*h_x_delta_4 + D_p_y_6*h_y_delta_4 + D_p_z_6*h_z_delta_4;
    M[5][28] = M[28][5] =
        D_delta_rx_5*t307 + D_delta_ry_5*t315 + D_delta_rz_5*t322 + D_delta_x_5*t288 + D_delta_y_5*t295
        + D_delta_z_5*t301 + D_p_rx_6*h_rx_delta_5 + D_p_ry_6*h_ry_delta_5 + D_p_rz_6*h_rz_delta_5
        + D_p_x_6*h_x_delta_5 + D_p_y_6*h_y_delta_5 + D_p_z_6*h_z_delta_5;
    M[5][29] = M[29][5] =
        D_delta_rx_6*t307 + D_delta_ry_6*t315 + D_delta_rz_6*t322 + D_delta_x_6*t288 + D_delta_y_6*t295
        + D_delta_z_6*t301 + D_p_rx_6*h_rx_delta_6 + D_p_ry_6*h_ry_delta_6 + D_p_rz_6*h_rz_delta_6
        + D_p_x_6*h_x_delta_6 + D_p_y_6*h_y_delta_6 + D_p_z_6*h_z_delta_6;
    M[5][35] = M[35][5] = t357;
    M[5][36] = M[36][5] = D_p_ry_6*h_ry_u_x + D_p_rz_6*h_rz_u_x + D_p_x_6*h_x_u_x + m_t_6*n_6_x + n_6_x*t111;
    M[5][37] = M[37][5] = D_p_rx_6*h_rx_u_y + D_p_rz_6*h_rz_u_y + D_p_y_6*h_y_u_y + m_t_6*n_6_y + n_6_y*t111;
    M[5][38] = M[38][5] = D_p_rx_6*h_rx_u_z + D_p_ry_6*h_ry_u_z + D_p_z_6*h_z_u_z + m_t_6*n_6_z + n_6_z*t111;
    M[6][6] = I_1_1 + t325*t361 + t363;
    M[6][12] = M[12][6] = t327*t362;
    M[6][18] = M[18][6] = t364;
    M[6][30] = M[30][6] = t329;
    M[7][7] = I_2_1 + t332*t365 + t367;
    M[7][13] = M[13][7] = t327*t366;
    M[7][19] = M[19][7] = t368;
    M[7][31] = M[31][7] = t335;
    M[8][8] = I_3_1 + t338*t369 + t371;
    M[8][14] = M[14][8] = t327*t370;
    M[8][20] = M[20][8] = t372;
    M[8][32] = M[32][8] = t341;
    M[9][9] = I_4_1 + t344*t373 + t375;
    M[9][15] = M[15][9] = t327*t374;
    M[9][21] = M[21][9] = t376;
    M[9][33] = M[33][9] = t347;
    M[10][10] = I_5_1 + t350*t377 + t379;
    M[10][16] = M[16][10] = t327*t378;
    M[10][22] = M[22][10] = t380;
    M[10][34] = M[34][10] = t353;
    M[11][11] = I_6_1 + t356*t381 + t383;
    M[11][17] = M[17][11] = t327*t382;
    M[11][23] = M[23][11] = t384;
    M[11][35] = M[35][11] = t359;
    M[12][12] = I_1_2 + t324*t361 + t363;
    M[12][18] = M[18][12] = t385;
    M[12][30] = M[30][12] = t330;
    M[13][13] = I_2_2 + t331*t365 + t367;
    M[13][19] = M[19][13] = t386;
    M[13][31] = M[31][13] = t336;
    M[14][14] = I_3_2 + t337*t369 + t371;
    M[14][20] = M[20][14] = t387;
    M[14][32] = M[32][14] = t342;
    M[15][15] = I_4_2 + t343*t373 + t375;
    M[15][21] = M[21][15] = t388;
    M[15][33] = M[33][15] = t348;
    M[16][16] = I_5_2 + t349*t377 + t379;
    M[16][22] = M[22][16] = t389;
    M[16][34] = M[34][16] = t354;
    M[17][17] = I_6_2 + t355*t381 + t383;
    M[17][23] = M[23][17] = t390;
    M[17][35] = M[35][17] = t360;
    M[18][18] = t364 + t385;
    M[19][19] = t368 + t386;
    M[20][20] = t372 + t387;
    M[21][21] = t376 + t388;
    M[22][22] = t380 + t389;
    M[23][23] = t384 + t390;
    M[24][24] =
        D_delta_rx_1*h_rx_delta_1 + D_delta_ry_1*h_ry_delta_1 + D_delta_rz_1*h_rz_delta_1
        + D_delta_x_1*h_x_delta_1 + D_delta_y_1*h_y_delta_1 + D_delta_z_1*h_z_delta_1;
    M[24][25] = M[25][24] =
        D_delta_rx_1*h_rx_delta_2 + D_delta_ry_1*h_ry_delta_2 + D_delta_rz_1*h_rz_delta_2
        + D_delta_x_1*h_x_delta_2 + D_delta_y_1*h_y_delta_2 + D_delta_z_1*h_z_delta_2;
    M[24][26] = M[26][24] =
        D_delta_rx_1*h_rx_delta_3 + D_delta_ry_1*h_ry_delta_3 + D_delta_rz_1*h_rz_delta_3
        + D_delta_x_1*h_x_delta_3 + D_delta_y_1*h_y_delta_3 + D_delta_z_1*h_z_delta_3;
    M[24][27] = M[27][24] =
        D_delta_rx_1*h_rx_delta_4 + D_delta_ry_1*h_ry_delta_4 + D_delta_rz_1*h_rz_delta_4
        + D_delta_x_1*h_x_delta_4 + D_delta_y_1*h_y_delta_4 + D_delta_z_1*h_z_delta_4;
    M[24][28] = M[28][24] =
        D_delta_rx_1*h_rx_delta_5 + D_delta_ry_1*h_ry_delta_5 + D_delta_rz_1*h_rz_delta_5
        + D_delta_x_1*h_x_delta_5 + D_delta_y_1*h_y_delta_5 + D_delta_z_1*h_z_delta_5;
    M[24][29] = M[29][24] =
        D_delta_rx_1*h_rx_delta_6 + D_delta_ry_1*h_ry_delta_6 + D_delta_rz_1*h_rz_delta_6
        + D_delta_x_1*h_x_delta_6 + D_delta_y_1*h_y_delta_6 + D_delta_z_1*h_z_delta_6;
    M[24][36] = M[36][24] = D_delta_ry_1*h_ry_u_x + D_delta_rz_1*h_rz_u_x + D_delta_x_1*h_x_u_x;
    M[24][37] = M[37][24] = D_delta_rx_1*h_rx_u_y + D_delta_rz_1*h_rz_u_y + D_delta_y_1*h_y_u_y;
    M[24][38] = M[38][24] = D_delta_rx_1*h_rx_u_z + D_delta_ry_1*h_ry_u_z + D_delta_z_1*h_z_u_z;
    M[25][25] =
        D_delta_rx_2*h_rx_delta_2 + D_delta_ry_2*h_ry_delta_2 + D_delta_rz_2*h_rz_delta_2
        + D_delta_x_2*h_x_delta_2 + D_delta_y_2*h_y_delta_2 + D_delta_z_2*h_z_delta_2;
    M[25][26] = M[26][25] =
        D_delta_rx_2*h_rx_delta_3 + D_delta_ry_2*h_ry_delta_3 + D_delta_rz_2*h_rz_delta_3
        + D_delta_x_2*h_x_delta_3 + D_delta_y_2*h_y_delta_3 + D_delta_z_2*h_z_delta_3;
    M[25][27] = M[27][25] =
        D_delta_rx_2*h_rx_delta_4 + D_delta_ry_2*h_ry_delta_4 + D_delta_rz_2*h_rz_delta_4
        + D_delta_x_2*h_x_delta_4 + D_delta_y_2*h_y_delta_4 + D_delta_z_2*h_z_delta_4;
    M[25][28] = M[28][25] =
        D_delta_rx_2*h_rx_delta_5 + D_delta_ry_2*h_ry_delta_5 + D_delta_rz_2*h_rz_delta_5
        + D_delta_x_2*h_x_delta_5 + D_delta_y_2*h_y_delta_5 + D_delta_z_2*h_z_delta_5;
    M[25][29] = M[29][25] =
        D_delta_rx_2*h_rx_delta_6 + D_delta_ry_2*h_ry_delta_6 + D_delta_rz_2*h_rz_delta_6
        + D_delta_x_2*h_x_delta_6 + D_delta_y_2*h_y_delta_6 + D_delta_z_2*h_z_delta_6;
    M[25][36] = M[36][25] = D_delta_ry_2*h_ry_u_x + D_delta_rz_2*h_rz_u_x + D_delta_x_2*h_x_u_x;
    M[25][37] = M[37][25] = D_delta_rx_2*h_rx_u_y + D_delta_rz_2*h_rz_u_y + D_delta_y_2*h_y_u_y;
    M[25][38] = M[38][25] = D_delta_rx_2*h_rx_u_z + D_delta_ry_2*h_ry_u_z + D_delta_z_2*h_z_u_z;
    M[26][26] =
        D_delta_rx_3*h_rx_delta_3 + D_delta_ry_3*h_ry_delta_3 + D_delta_rz_3*h_rz_delta_3
        + D_delta_x_3*h_x_delta_3 + D_delta_y_3*h_y_delta_3 + D_delta_z_3*h_z_delta_3;
    M[26][27] = M[27][26] =
        D_delta_rx_3*h_rx_delta_4 + D_delta_ry_3*h_ry_delta_4 + D_delta_rz_3*h_rz_delta_4
        + D_delta_x_3*h_x_delta_4 + D_delta_y_3*h_y_delta_4 + D_delta_z_3*h_z_delta_4;
    M[26][28] = M[28][26] =
        D_delta_rx_3*h_rx_delta_5 + D_delta_ry_3*h_ry_delta_5 + D_delta_rz_3*h_rz_delta_5
        + D_delta_x_3*h_x_delta_5 + D_delta_y_3*h_y_delta_5 + D_delta_z_3*h_z_delta_5;
    M[26][29] = M[29][26] =
        D_delta_rx_3*h_rx_delta_6 + D_delta_ry_3*h_ry_delta_6 + D_delta_rz_3*h_rz_delta_6
        + D_delta_x_3*h_x_delta_6 + D_delta_y_3*h_y_delta_6 + D_delta_z_3*h_z_delta_6;
    M[26][36] = M[36][26] = D_delta_ry_3*h_ry_u_x + D_delta_rz_3*h_rz_u_x + D_delta_x_3*h_x_u_x;
    M[26][37] = M[37][26] = D_delta_rx_3*h_rx_u_y + D_delta_rz_3*h_rz_u_y + D_delta_y_3*h_y_u_y;
    M[26][38] = M[38][26] = D_delta_rx_3*h_rx_u_z + D_delta_ry_3*h_ry_u_z + D_delta_z_3*h_z_u_z;
    M[27][27] =
        D_delta_rx_4*h_rx_delta_4 + D_delta_ry_4*h_ry_delta_4 + D_delta_rz_4*h_rz_delta_4
        + D_delta_x_4*h_x_delta_4 + D_delta_y_4*h_y_delta_4 + D_delta_z_4*h_z_delta_4;
    M[27][28] = M[28][27] =
        D_delta_rx_4*h_rx_delta_5 + D_delta_ry_4*h_ry_delta_5 + D_delta_rz_4*h_rz_delta_5
        + D_delta_x_4*h_x_delta_5 + D_delta_y_4*h_y_delta_5 + D_delta_z_4*h_z_delta_5;
    M[27][29] = M[29][27] =
        D_delta_rx_4*h_rx_delta_6 + D_delta_ry_4*h_ry_delta_6 + D_delta_rz_4*h_rz_delta_6
        + D_delta_x_4*h_x_delta_6 + D_delta_y_4*h_y_delta_6 + D_delta_z_4*h_z_delta_6;
    M[27][36] = M[36][27] = D_delta_ry_4*h_ry_u_x + D_delta_rz_4*h_rz_u_x + D_delta_x_4*h_x_u_x;
    M[27][37] = M[37][27] = D_delta_rx_4*h_rx_u_y + D_delta_rz_4*h_rz_u_y + D_delta_y_4*h_y_u_y;
    M[27][38] = M[38][27] = D_delta_rx_4*h_rx_u_z + D_delta_ry_4*h_ry_u_z + D_delta_z_4*h_z_u_z;
    M[28][28] =
        D_delta_rx_5*h_rx_delta_5 + D_delta_ry_5*h_ry_delta_5 + D_delta_rz_5*h_rz_delta_5
        + D_delta_x_5*h_x_delta_5 + D_delta_y_5*h_y_delta_5 + D_delta_z_5*h_z_delta_5;
    M[28][29] = M[29][28] =
        D_delta_rx_5*h_rx_delta_6 + D_delta_ry_5*h_ry_delta_6 + D_delta_rz_5*h_rz_delta_6
        + D_delta_x_5*h_x_delta_6 + D_delta_y_5*h_y_delta_6 + D_delta_z_5*h_z_delta_6;
    M[28][36] = M[36][28] = D_delta_ry_5*h_ry_u_x + D_delta_rz_5*h_rz_u_x + D_delta_x_5*h_x_u_x;
    M[28][37] = M[37][28] = D_delta_rx_5*h_rx_u_y + D_delta_rz_5*h_rz_u_y + D_delta_y_5*h_y_u_y;
    M[28][38] = M[38][28] = D_delta_rx_5*h_rx_u_z + D_delta_ry_5*h_ry_u_z + D_delta_z_5*h_z_u_z;
    M[29][29] =
        D_delta_rx_6*h_rx_delta_6 + D_delta_ry_6*h_ry_delta_6 + D_delta_rz_6*h_rz_delta_6
        + D_delta_x_6*h_x_delta_6 + D_delta_y_6*h_y_delta_6 + D_delta_z_6*h_z_delta_6;
    M[29][36] = M[36][29] = D_delta_ry_6*h_ry_u_x + D_delta_rz_6*h_rz_u_x + D_delta_x_6*h_x_u_x;
    M[29][37] = M[37][29] = D_delta_rx_6*h_rx_u_y + D_delta_rz_6*h_rz_u_y + D_delta_y_6*h_y_u_y;
    M[29][38] = M[38][29] = D_delta_rx_6*h_rx_u_z + D_delta_ry_6*h_ry_u_z + D_delta_z_6*h_z_u_z;
    M[30][30] = t326;
    M[31][31] = t333;
    M[32][32] = t339;
    M[33][33] = t345;
    M[34][34] = t351;
    M[35][35] = t357;
    M[36][36] = h_x_u_x + t391;
    M[37][37] = h_y_u_y + t391;
    M[38][38] = h_z_u_z + t391;
    memset(K_el, 0, sizeof(pkmodes_real[39][39]));
    K_el[0][0] = (D_p_x_1*D_p_x_1)*k_C + (D_p_y_1*D_p_y_1)*k_C + (D_p_z_1*D_p_z_1)*k_C + t392;
    K_el[0][1] = K_el[1][0] = D_p_x_2*t393 + D_p_y_2*t394 + D_p_z_2*t395;
    K_el[0][2] = K_el[2][0] = D_p_x_3*t393 + D_p_y_3*t394 + D_p_z_3*t395;
    K_el[0][3] = K_el[3][0] = D_p_x_4*t393 + D_p_y_4*t394 + D_p_z_4*t395;
    K_el[0][4] = K_el[4][0] = D_p_x_5*t393 + D_p_y_5*t394 + D_p_z_5*t395;
    K_el[0][5] = K_el[5][0] = D_p_x_6*t393 + D_p_y_6*t394 + D_p_z_6*t395;
    K_el[0][6] = K_el[6][0] = t396;
    K_el[0][12] = K_el[12][0] = t397;
    K_el[0][24] = K_el[24][0] = D_delta_x_1*t393 + D_delta_y_1*t394 + D_delta_z_1*t395;
    K_el[0][25] = K_el[25][0] = D_delta_x_2*t393 + D_delta_y_2*t394 + D_delta_z_2*t395;
    K_el[0][26] = K_el[26][0] = D_delta_x_3*t393 + D_delta_y_3*t394 + D_delta_z_3*t395;
    K_el[0][27] = K_el[27][0] = D_delta_x_4*t393 + D_delta_y_4*t394 + D_delta_z_4*t395;
    K_el[0][28] = K_el[28][0] = D_delta_x_5*t393 + D_delta_y_5*t394 + D_delta_z_5*t395;
    K_el[0][29] = K_el[29][0] = D_delta_x_6*t393 + D_delta_y_6*t394 + D_delta_z_6*t395;
    K_el[0][30] = K_el[30][0] = t392;
    K_el[0][36] = K_el[36][0] = t393;
    K_el[0][37] = K_el[37][0] = t394;
    K_el[0][38] = K_el[38][0] = t395;
    K_el[1][1] = (D_p_x_2*D_p_x_2)*k_C + (D_p_y_2*D_p_y_2)*k_C + (D_p_z_2*D_p_z_2)*k_C + t398;
    K_el[1][2] = K_el[2][1] = D_p_x_3*t399 + D_p_y_3*t400 + D_p_z_3*t401;
    K_el[1][3] = K_el[3][1] = D_p_x_4*t399 + D_p_y_4*t400 + D_p_z_4*t401;
    K_el[1][4] = K_el[4][1] = D_p_x_5*t399 + D_p_y_5*t400 + D_p_z_5*t401;
    K_el[1][5] = K_el[5][1] = D_p_x_6*t399 + D_p_y_6*t400 + D_p_z_6*t401;
    K_el[1][7] = K_el[7][1] = t402;
    K_el[1][13] = K_el[13][1] = t403;
    K_el[1][24] = K_el[24][1] = D_delta_x_1*t399 + D_delta_y_1*t400 + D_delta_z_1*t401;
    K_el[1][25] = K_el[25][1] = D_delta_x_2*t399 + D_delta_y_2*t400 + D_delta_z_2*t401;
    K_el[1][26] = K_el[26][1] = D_delta_x_3*t399 + D_delta_y_3*t400 + D_delta_z_3*t401;
    K_el[1][27] = K_el[27][1] = D_delta_x_4*t399 + D_delta_y_4*t400 + D_delta_z_4*t401;
    K_el[1][28] = K_el[28][1] = D_delta_x_5*t399 + D_delta_y_5*t400 + D_delta_z_5*t401;
    K_el[1][29] = K_el[29][1] = D_delta_x_6*t399 + D_delta_y_6*t400 + D_delta_z_6*t401;
    K_el[1][31] = K_el[31][1] = t398;
    K_el[1][36] = K_el[36][1] = t399;
    K_el[1][37] = K_el[37][1] = t400;
    K_el[1][38] = K_el[38][1] = t401;
    K_el[2][2] = (D_p_x_3*D_p_x_3)*k_C + (D_p_y_3*D_p_y_3)*k_C + (D_p_z_3*D_p_z_3)*k_C + t404;
    K_el[2][3] = K_el[3][2] = D_p_x_4*t405 + D_p_y_4*t406 + D_p_z_4*t407;
    K_el[2][4] = K_el[4][2] = D_p_x_5*t405 + D_p_y_5*t406 + D_p_z_5*t407;
    K_el[2][5] = K_el[5][2] = D_p_x_6*t405 + D_p_y_6*t406 + D_p_z_6*t407;
    K_el[2][8] = K_el[8][2] = t408;
    K_el[2][14] = K_el[14][2] = t409;
    K_el[2][24] = K_el[24][2] = D_delta_x_1*t405 + D_delta_y_1*t406 + D_delta_z_1*t407;
    K_el[2][25] = K_el[25][2] = D_delta_x_2*t405 + D_delta_y_2*t406 + D_delta_z_2*t407;
    K_el[2][26] = K_el[26][2] = D_delta_x_3*t405 + D_delta_y_3*t406 + D_delta_z_3*t407;
    K_el[2][27] = K_el[27][2] = D_delta_x_4*t405 + D_delta_y_4*t406 + D_delta_z_4*t407;
    K_el[2][28] = K_el[28][2] = D_delta_x_5*t405 + D_delta_y_5*t406 + D_delta_z_5*t407;
    K_el[2][29] = K_el[29][2] = D_delta_x_6*t405 + D_delta_y_6*t406 + D_delta_z_6*t407;
    K_el[2][32] = K_el[32][2] = t404;
    K_el[2][36] = K_el[36][2] = t405;
    K_el[2][37] = K_el[37][2] = t406;
    K_el[2][38] = K_el[38][2] = t407;
    K_el[3][3] = (D_p_x_4*D_p_x_4)*k_C + (D_p_y_4*D_p_y_4)*k_C + (D_p_z_4*D_p_z_4)*k_C + t410;
    K_el[3][4] = K_el[4][3] = D_p_x_5*t411 + D_p_y_5*t412 + D_p_z_5*t413;
    K_el[3][5] = K_el[5][3] = D_p_x_6*t411 + D_p_y_6*t412 + D_p_z_6*t413;
    K_el[3][9] = K_el[9][3] = t414;
    K_el[3][15] = K_el[15][3] = t415;
    K_el[3][24] = K_el[24][3] = D_delta_x_1*t411 + D_delta_y_1*t412 + D_delta_z_1*t413;
    K_el[3][25] = K_el[25][3] = D_delta_x_2*t411 + D_delta_y_2*t412 + D_delta_z_2*t413;
    K_el[3][26] = K_el[26][3] = D_delta_x_3*t411 + D_delta_y_3*t412 + D_delta_z_3*t413;
    K_el[3][27] = K_el[27][3] = D_delta_x_4*t411 + D_delta_y_4*t412 + D_delta_z_4*t413;
    K_el[3][28] = K_el[28][3] = D_delta_x_5*t411 + D_delta_y_5*t412 + D_delta_z_5*t413;
    K_el[3][29] = K_el[29][3] = D_delta_x_6*t411 + D_delta_y_6*t412 + D_delta_z_6*t413;
    K_el[3][33] = K_el[33][3] = t410;
    K_el[3][36] = K_el[36][3] = t411;
    K_el[3][37] = K_el[37][3] = t412;
    K_el[3][38] = K_el[38][3] = t413;
    K_el[4][4] = (D_p_x_5*D_p_x_5)*k_C + (D_p_y_5*D_p_y_5)*k_C + (D_p_z_5*D_p_z_5)*k_C + t416;
    K_el[4][5] = K_el[5][4] = D_p_x_6*t417 + D_p_y_6*t418 + D_p_z_6*t419;
    K_el[4][10] = K_el[10][4] = t420;
    K_el[4][16] = K_el[16][4] = t421;
    K_el[4][24] = K_el[24][4] = D_delta_x_1*t417 + D_delta_y_1*t418 + D_delta_z_1*t419;
    K_el[4][25] = K_el[25][4] = D_delta_x_2*t417 + D_delta_y_2*t418 + D_delta_z_2*t419;
    K_el[4][26] = K_el[26][4] = D_delta_x_3*t417 + D_delta_y_3*t418 + D_delta_z_3*t419;
    K_el[4][27] = K_el[27][4] = D_delta_x_4*t417 + D_delta_y_4*t418 + D_delta_z_4*t419;
    K_el[4][28] = K_el[28][4] = D_delta_x_5*t417 + D_delta_y_5*t418 + D_delta_z_5*t419;
    K_el[4][29] = K_el[29][4] = D_delta_x_6*t417 + D_delta_y_6*t418 + D_delta_z_6*t419;
    K_el[4][34] = K_el[34][4] = t416;
    K_el[4][36] = K_el[36][4] = t417;
    K_el[4][37] = K_el[37][4] = t418;
    K_el[4][38] = K_el[38][4] = t419;
    K_el[5][5] = (D_p_x_6*D_p_x_6)*k_C + (D_p_y_6*D_p_y_6)*k_C + (D_p_z_6*D_p_z_6)*k_C + t422;
    K_el[5][11] = K_el[11][5] = t423;
    K_el[5][17] = K_el[17][5] = t424;
    K_el[5][24] = K_el[24][5] = D_delta_x_1*t425 + D_delta_y_1*t426 + D_delta_z_1*t427;
    K_el[5][25] = K_el[25][5] = D_delta_x_2*t425 + D_delta_y_2*t426 + D_delta_z_2*t427;
    K_el[5][26] = K_el[26][5] = D_delta_x_3*t425 + D_delta_y_3*t426 + D_delta_z_3*t427;
    K_el[5][27] = K_el[27][5] = D_delta_x_4*t425 + D_delta_y_4*t426 + D_delta_z_4*t427;
    K_el[5][28] = K_el[28][5] = D_delta_x_5*t425 + D_delta_y_5*t426 + D_delta_z_5*t427;
    K_el[5][29] = K_el[29][5] = D_delta_x_6*t425 + D_delta_y_6*t426 + D_delta_z_6*t427;
    K_el[5][35] = K_el[35][5] = t422;
    K_el[5][36] = K_el[36][5] = t425;
    K_el[5][37] = K_el[37][5] = t426;
    K_el[5][38] = K_el[38][5] = t427;
    K_el[6][6] = k_1_3*t361 + t428 + t429;
    K_el[6][12] = K_el[12][6] = -t429;
    K_el[6][18] = K_el[18][6] = t428;
    K_el[6][30] = K_el[30][6] = t396;
    K_el[7][7] = k_2_3*t365 + t430 + t431;
    K_el[7][13] = K_el[13][7] = -t431;
    K_el[7][19] = K_el[19][7] = t430;
    K_el[7][31] = K_el[31][7] = t402;
    K_el[8][8] = k_3_3*t369 + t432 + t433;
    K_el[8][14] = K_el[14][8] = -t433;
    K_el[8][20] = K_el[20][8] = t432;
    K_el[8][32] = K_el[32][8] = t408;
    K_el[9][9] = k_4_3*t373 + t434 + t435;
    K_el[9][15] = K_el[15][9] = -t435;
    K_el[9][21] = K_el[21][9] = t434;
    K_el[9][33] = K_el[33][9] = t414;
    K_el[10][10] = k_5_3*t377 + t436 + t437;
    K_el[10][16] = K_el[16][10] = -t437;
    K_el[10][22] = K_el[22][10] = t436;
    K_el[10][34] = K_el[34][10] = t420;
    K_el[11][11] = k_6_3*t381 + t438 + t439;
    K_el[11][17] = K_el[17][11] = -t439;
    K_el[11][23] = K_el[23][11] = t438;
    K_el[11][35] = K_el[35][11] = t423;
    K_el[12][12] = k_1_2*t361 + t429 + t440;
    K_el[12][18] = K_el[18][12] = t440;
    K_el[12][30] = K_el[30][12] = t397;
    K_el[13][13] = k_2_2*t365 + t431 + t441;
    K_el[13][19] = K_el[19][13] = t441;
    K_el[13][31] = K_el[31][13] = t403;
    K_el[14][14] = k_3_2*t369 + t433 + t442;
    K_el[14][20] = K_el[20][14] = t442;
    K_el[14][32] = K_el[32][14] = t409;
    K_el[15][15] = k_4_2*t373 + t435 + t443;
    K_el[15][21] = K_el[21][15] = t443;
    K_el[15][33] = K_el[33][15] = t415;
    K_el[16][16] = k_5_2*t377 + t437 + t444;
    K_el[16][22] = K_el[22][16] = t444;
    K_el[16][34] = K_el[34][16] = t421;
    K_el[17][17] = k_6_2*t381 + t439 + t445;
    K_el[17][23] = K_el[23][17] = t445;
    K_el[17][35] = K_el[35][17] = t424;
    K_el[18][18] = t428 + t440;
    K_el[19][19] = t430 + t441;
    K_el[20][20] = t432 + t442;
    K_el[21][21] = t434 + t443;
    K_el[22][22] = t436 + t444;
    K_el[23][23] = t438 + t445;
    K_el[24][24] =
        (D_delta_x_1*D_delta_x_1)*k_C + (D_delta_y_1*D_delta_y_1)*k_C + (D_delta_z_1*D_delta_z_1)*k_C;
    K_el[24][25] = K_el[25][24] = D_delta_x_2*t446 + D_delta_y_2*t447 + D_delta_z_2*t448;
    K_el[24][26] = K_el[26][24] = D_delta_x_3*t446 + D_delta_y_3*t447 + D_delta_z_3*t448;
    K_el[24][27] = K_el[27][24] = D_delta_x_4*t446 + D_delta_y_4*t447 + D_delta_z_4*t448;
    K_el[24][28] = K_el[28][24] = D_delta_x_5*t446 + D_delta_y_5*t447 + D_delta_z_5*t448;
    K_el[24][29] = K_el[29][24] = D_delta_x_6*t446 + D_delta_y_6*t447 + D_delta_z_6*t448;
    K_el[24][36] = K_el[36][24] = t446;
    K_el[24][37] = K_el[37][24] = t447;
    K_el[24][38] = K_el[38][24] = t448;
    K_el[25][25] =
        (D_delta_x_2*D_delta_x_2)*k_C + (D_delta_y_2*D_delta_y_2)*k_C + (D_delta_z_2*D_delta_z_2)*k_C;
    K_el[25][26] = K_el[26][25] = D_delta_x_3*t449 + D_delta_y_3*t450 + D_delta_z_3*t451;
    K_el[25][27] = K_el[27][25] = D_delta_x_4*t449 + D_delta_y_4*t450 + D_delta_z_4*t451;
    K_el[25][28] = K_el[28][25] = D_delta_x_5*t449 + D_delta_y_5*t450 + D_delta_z_5*t451;
    K_el[25][29] = K_el[29][25] = D_delta_x_6*t449 + D_delta_y_6*t450 + D_delta_z_6*t451;
    K_el[25][36] = K_el[36][25] = t449;
    K_el[25][37] = K_el[37][25] = t450;
    K_el[25][38] = K_el[38][25] = t451;
    K_el[26][26] =
        (D_delta_x_3*D_delta_x_3)*k_C + (D_delta_y_3*D_delta_y_3)*k_C + (D_delta_z_3*D_delta_z_3)*k_C;
    K_el[26][27] = K_el[27][26] = D_delta_x_4*t452 + D_delta_y_4*t453 + D_delta_z_4*t454;
    K_el[26][28] = K_el[28][26] = D_delta_x_5*t452 + D_delta_y_5*t453 + D_delta_z_5*t454;
    K_el[26][29] = K_el[29][26] = D_delta_x_6*t452 + D_delta_y_6*t453 + D_delta_z_6*t454;
    K_el[26][36] = K_el[36][26] = t452;
    K_el[26][37] = K_el[37][26] = t453;
    K_el[26][38] = K_el[38][26] = t454;
    K_el[27][27] =
        (D_delta_x_4*D_delta_x_4)*k_C + (D_delta_y_4*D_delta_y_4)*k_C + (D_delta_z_4*D_delta_z_4)*k_C;
    K_el[27][28] = K_el[28][27] = D_delta_x_5*t455 + D_delta_y_5*t456 + D_delta_z_5*t457;
    K_el[27][29] = K_el[29][27] = D_delta_x_6*t455 + D_delta_y_6*t456 + D_delta_z_6*t457;
    K_el[27][36] = K_el[36][27] = t455;
    K_el[27][37] = K_el[37][27] = t456;
    K_el[27][38] = K_el[38][27] = t457;
    K_el[28][28] =
        (D_delta_x_5*D_delta_x_5)*k_C + (D_delta_y_5*D_delta_y_5)*k_C + (D_delta_z_5*D_delta_z_5)*k_C;
    K_el[28][29] = K_el[29][28] = D_delta_x_6*t458 + D_delta_y_6*t459 + D_delta_z_6*t460;
    K_el[28][36] = K_el[36][28] = t458;
    K_el[28][37] = K_el[37][28] = t459;
    K_el[28][38] = K_el[38][28] = t460;
    K_el[29][29] =
        (D_delta_x_6*D_delta_x_6)*k_C + (D_delta_y_6*D_delta_y_6)*k_C + (D_delta_z_6*D_delta_z_6)*k_C;
    K_el[29][36] = K_el[36][29] = D_delta_x_6*k_C;
    K_el[29][37] = K_el[37][29] = D_delta_y_6*k_C;
    K_el[29][38] = K_el[38][29] = D_delta_z_6*k_C;
    K_el[30][30] = t392;
    K_el[31][31] = t398;
    K_el[32][32] = t404;
    K_el[33][33] = t410;
    K_el[34][34] = t416;
    K_el[35][35] = t422;
    K_el[36][36] = k_C;
    K_el[37][37] = k_C;
    K_el[38][38] = k_C;
    memset(K_g, 0, sizeof(pkmodes_real[39][39]));
    K_g[0][0] =
        D_p_rx_1*f_rx_x_1 + D_p_rx_1*t211 + D_p_ry_1*f_ry_x_1 + D_p_ry_1*t461 + D_p_rz_1*f_rz_x_1
        + D_p_rz_1*t223 + D_p_x_1*f_x_x_1 + D_p_x_1*t193 + D_p_y_1*f_y_x_1 + D_p_y_1*t199 + D_p_z_1*f_z_x_1
        + D_p_z_1*t205 - mu_1*(n_1_x*n_1_x) - mu_1*(n_1_y*n_1_y) - mu_1*(n_1_z*n_1_z);
    K_g[0][1] = K_g[1][0] =
        D_p_rx_1*f_rx_x_2 + D_p_rx_2*t211 + D_p_ry_1*f_ry_x_2 + D_p_ry_2*t461 + D_p_rz_1*f_rz_x_2
        + D_p_rz_2*t223 + D_p_x_1*f_x_x_2 + D_p_x_2*t193 + D_p_y_1*f_y_x_2 + D_p_y_2*t199 + D_p_z_1*f_z_x_2
        + D_p_z_2*t205;
    K_g[0][2] = K_g[2][0] =
        D_p_rx_1*f_rx_x_3 + D_p_rx_3*t211 + D_p_ry_1*f_ry_x_3 + D_p_ry_3*t461 + D_p_rz_1*f_rz_x_3
        + D_p_rz_3*t223 + D_p_x_1*f_x_x_3 + D_p_x_3*t193 + D_p_y_1*f_y_x_3 + D_p_y_3*t199 + D_p_z_1*f_z_x_3
        + D_p_z_3*t205;
    K_g[0][3] = K_g[3][0] =
        D_p_rx_1*f_rx_x_4 + D_p_rx_4*t211 + D_p_ry_1*f_ry_x_4 + D_p_ry_4*t461 + D_p_rz_1*f_rz_x_4
        + D_p_rz_4*t223 + D_p_x_1*f_x_x_4 + D_p_x_4*t193 + D_p_y_1*f_y_x_4 + D_p_y_4*t199 + D_p_z_1*f_z_x_4
        + D_p_z_4*t205;
    K_g[0][4] = K_g[4][0] =
        D_p_rx_1*f_rx_x_5 + D_p_rx_5*t211 + D_p_ry_1*f_ry_x_5 + D_p_ry_5*t461 + D_p_rz_1*f_rz_x_5
        + D_p_rz_5*t223 + D_p_x_1*f_x_x_5 + D_p_x_5*t193 + D_p_y_1*f_y_x_5 + D_p_y_5*t199 + D_p_z_1*f_z_x_5
        + D_p_z_5*t205;
    K_g[0][5] = K_g[5][0] =
        D_p_rx_1*f_rx_x_6 + D_p_rx_6*t211 + D_p_ry_1*f_ry_x_6 + D_p_ry_6*t461 + D_p_rz_1*f_rz_x_6
        + D_p_rz_6*t223 + D_p_x_1*f_x_x_6 + D_p_x_6*t193 + D_p_y_1*f_y_x_6 + D_p_y_6*t199 + D_p_z_1*f_z_x_6
        + D_p_z_6*t205;
    K_g[0][24] = K_g[24][0] =
        D_delta_rx_1*t211 + D_delta_ry_1*t461 + D_delta_rz_1*t223 + D_delta_x_1*t193 + D_delta_y_1*t199
        + D_delta_z_1*t205 + D_p_rx_1*f_rx_delta_1 + D_p_ry_1*f_ry_delta_1 + D_p_rz_1*f_rz_delta_1
        + D_p_x_1*f_x_delta_1 + D_p_y_1*f_y_delta_1 + D_p_z_1*f_z_delta_1;
    K_g[0][25] = K_g[25][0] =
        D_delta_rx_2*t211 + D_delta_ry_2*t461 + D_delta_rz_2*t223 + D_delta_x_2*t193 + D_delta_y_2*t199
        + D_delta_z_2*t205 + D_p_rx_1*f_rx_delta_2 + D_p_ry_1*f_ry_delta_2 + D_p_rz_1*f_rz_delta_2
        + D_p_x_1*f_x_delta_2 + D_p_y_1*f_y_delta_2 + D_p_z_1*f_z_delta_2;
    K_g[0][26] = K_g[26][0] =
        D_delta_rx_3*t211 + D_delta_ry_3*t461 + D_delta_rz_3*t223 + D_delta_x_3*t193 + D_delta_y_3*t199
        + D_delta_z_3*t205 + D_p_rx_1*f_rx_delta_3 + D_p_ry_1*f_ry_delta_3 + D_p_rz_1*f_rz_delta_3
        + D_p_x_1*f_x_delta_3 + D_p_y_1*f_y_delta_3 + D_p_z_1*f_z_delta_3;
    K_g[0][27] = K_g[27][0] =
        D_delta_rx_4*t211 + D_delta_ry_4*t461 + D_delta_rz_4*t223 + D_delta_x_4*t193 + D_delta_y_4*t199
        + D_delta_z_4*t205 + D_p_rx_1*f_rx_delta_4 + D_p_ry_1*f_ry_delta_4 + D_p_rz_1*f_rz_delta_4
        + D_p_x_1*f_x_delta_4 + D_p_y_1*f_y_delta_4 + D_p_z_1*f_z_delta_4;
    K_g[0][28] = K_g[28][0] =
        D_delta_rx_5*t211 + D_delta_ry_5*t461 + D_delta_rz_5*t223 + D_delta_x_5*t193 + D_delta_y_5*t199
        + D_delta_z_5*t205 + D_p_rx_1*f_rx_delta_5 + D_p_ry_1*f_ry_delta_5 + D_p_rz_1*f_rz_delta_5
        + D_p_x_1*f_x_delta_5 + D_p_y_1*f_y_delta_5 + D_p_z_1*f_z_delta_5;
    K_g[0][29] = K_g[29][0] =
        D_delta_rx_6*t211 + D_delta_ry_6*t461 + D_delta_rz_6*t223 + D_delta_x_6*t193 + D_delta_y_6*t199
        + D_delta_z_6*t205 + D_p_rx_1*f_rx_delta_6 + D_p_ry_1*f_ry_delta_6 + D_p_rz_1*f_rz_delta_6
        + D_p_x_1*f_x_delta_6 + D_p_y_1*f_y_delta_6 + D_p_z_1*f_z_delta_6;
    K_g[1][1] =
        D_p_rx_2*f_rx_x_2 + D_p_rx_2*t212 + D_p_ry_2*f_ry_x_2 + D_p_ry_2*t462 + D_p_rz_2*f_rz_x_2
        + D_p_rz_2*t224 + D_p_x_2*f_x_x_2 + D_p_x_2*t194 + D_p_y_2*f_y_x_2 + D_p_y_2*t200 + D_p_z_2*f_z_x_2
        + D_p_z_2*t206 - mu_2*(n_2_x*n_2_x) - mu_2*(n_2_y*n_2_y) - mu_2*(n_2_z*n_2_z);
    K_g[1][2] = K_g[2][1] =
        D_p_rx_2*f_rx_x_3 + D_p_rx_3*t212 + D_p_ry_2*f_ry_x_3 + D_p_ry_3*t462 + D_p_rz_2*f_rz_x_3
        + D_p_rz_3*t224 + D_p_x_2*f_x_x_3 + D_p_x_3*t194 + D_p_y_2*f_y_x_3 + D_p_y_3*t200 + D_p_z_2*f_z_x_3
        + D_p_z_3*t206;
    K_g[1][3] = K_g[3][1] =
        D_p_rx_2*f_rx_x_4 + D_p_rx_4*t212 + D_p_ry_2*f_ry_x_4 + D_p_ry_4*t462 + D_p_rz_2*f_rz_x_4
        + D_p_rz_4*t224 + D_p_x_2*f_x_x_4 + D_p_x_4*t194 + D_p_y_2*f_y_x_4 + D_p_y_4*t200 + D_p_z_2*f_z_x_4
        + D_p_z_4*t206;
    K_g[1][4] = K_g[4][1] =
        D_p_rx_2*f_rx_x_5 + D_p_rx_5*t212 + D_p_ry_2*f_ry_x_5 + D_p_ry_5*t462 + D_p_rz_2*f_rz_x_5
        + D_p_rz_5*t224 + D_p_x_2*f_x_x_5 + D_p_x_5*t194 + D_p_y_2*f_y_x_5 + D_p_y_5*t200 + D_p_z_2*f_z_x_5
        + D_p_z_5*t206;
    K_g[1][5] = K_g[5][1] =
        D_p_rx_2*f_rx_x_6 + D_p_rx_6*t212 + D_p_ry_2*f_ry_x_6 + D_p_ry_6*t462 + D_p_rz_2*f_rz_x_6
        + D_p_rz_6*t224 + D_p_x_2*f_x_x_6 + D_p_x_6*t194 + D_p_y_2*f_y_x_6 + D_p_y_6*t200 + D_p_z_2*f_z_x_6
        + D_p_z_6*t206;
    K_g[1][24] = K_g[24][1] =
        D_delta_rx_1*t212 + D_delta_ry_1*t462 + D_delta_rz_1*t224 + D_delta_x_1*t194 + D_delta_y_1*t200
        + D_delta_z_1*t206 + D_p_rx_2*f_rx_delta_1 + D_p_ry_2*f_ry_delta_1 + D_p_rz_2*f_rz_delta_1
        + D_p_x_2*f_x_delta_1 + D_p_y_2*f_y_delta_1 + D_p_z_2*f_z_delta_1;
    K_g[1][25] = K_g[25][1] =
        D_delta_rx_2*t212 + D_delta_ry_2*t462 + D_delta_rz_2*t224 + D_delta_x_2*t194 + D_delta_y_2*t200
        + D_delta_z_2*t206 + D_p_rx_2*f_rx_delta_2 + D_p_ry_2*f_ry_delta_2 + D_p_rz_2*f_rz_delta_2
        + D_p_x_2*f_x_delta_2 + D_p_y_2*f_y_delta_2 + D_p_z_2*f_z_delta_2;
    K_g[1][26] = K_g[26][1] =
        D_delta_rx_3*t212 + D_delta_ry_3*t462 + D_delta_rz_3*t224 + D_delta_x_3*t194 + D_delta_y_3*t200
        + D_delta_z_3*t206 + D_p_rx_2*f_rx_delta_3 + D_p_ry_2*f_ry_delta_3 + D_p_rz_2*f_rz_delta_3
        + D_p_x_2*f_x_delta_3 + D_p_y_2*f_y_delta_3 + D_p_z_2*f_z_delta_3;
    K_g[1][27] = K_g[27][1] =
        D_delta_rx_4*t212 + D_delta_ry_4*t462 + D_delta_rz_4*t224 + D_delta_x_4*t194 + D_delta_y_4*t200
        + D_delta_z_4*t206 + D_p_rx_2*f_rx_delta_4 + D_p_ry_2*f_ry_delta_4 + D_p_rz_2*f_rz_delta_4
        + D_p_x_2*f_x_delta_4 + D_p_y_2*f_y_delta_4 + D_p_z_2*f_z_delta_4;
    K_g[1][28] = K_g[28][1] =
        D_delta_rx_5*t212 + D_delta_ry_5*t462 + D_delta_rz_5*t224 + D_delta_x_5*t194 + D_delta_y_5*t200
        + D_delta_z_5*t206 + D_p_rx_2*f_rx_delta_5 + D_p_ry_2*f_ry_delta_5 + D_p_rz_2*f_rz_delta_5
        + D_p_x_2*f_x_delta_5 + D_p_y_2*f_y_delta_5 + D_p_z_2*f_z_delta_5;
    K_g[1][29] = K_g[29][1] =
        D_delta_rx_6*t212 + D_delta_ry_6*t462 + D_delta_rz_6*t224 + D_delta_x_6*t194 + D_delta_y_6*t200
        + D_delta_z_6*t206 + D_p_rx_2*f_rx_delta_6 + D_p_ry_2*f_ry_delta_6 + D_p_rz_2*f_rz_delta_6
        + D_p_x_2*f_x_delta_6 + D_p_y_2*f_y_delta_6 + D_p_z_2*f_z_delta_6;
    K_g[2][2] =
        D_p_rx_3*f_rx_x_3 + D_p_rx_3*t213 + D_p_ry_3*f_ry_x_3 + D_p_ry_3*t463 + D_p_rz_3*f_rz_x_3
        + D_p_rz_3*t225 + D_p_x_3*f_x_x_3 + D_p_x_3*t195 + D_p_y_3*f_y_x_3 + D_p_y_3*t201 + D_p_z_3*f_z_x_3
        + D_p_z_3*t207 - mu_3*(n_3_x*n_3_x) - mu_3*(n_3_y*n_3_y) - mu_3*(n_3_z*n_3_z);
    K_g[2][3] = K_g[3][2] =
        D_p_rx_3*f_rx_x_4 + D_p_rx_4*t213 + D_p_ry_3*f_ry_x_4 + D_p_ry_4*t463 + D_p_rz_3*f_rz_x_4
        + D_p_rz_4*t225 + D_p_x_3*f_x_x_4 + D_p_x_4*t195 + D_p_y_3*f_y_x_4 + D_p_y_4*t201 + D_p_z_3*f_z_x_4
        + D_p_z_4*t207;
    K_g[2][4] = K_g[4][2] =
        D_p_rx_3*f_rx_x_5 + D_p_rx_5*t213 + D_p_ry_3*f_ry_x_5 + D_p_ry_5*t463 + D_p_rz_3*f_rz_x_5
        + D_p_rz_5*t225 + D_p_x_3*f_x_x_5 + D_p_x_5*t195 + D_p_y_3*f_y_x_5 + D_p_y_5*t201 + D_p_z_3*f_z_x_5
        + D_p_z_5*t207;
    K_g[2][5] = K_g[5][2] =
        D_p_rx_3*f_rx_x_6 + D_p_rx_6*t213 + D_p_ry_3*f_ry_x_6 + D_p_ry_6*t463 + D_p_rz_3*f_rz_x_6
        + D_p_rz_6*t225 + D_p_x_3*f_x_x_6 + D_p_x_6*t195 + D_p_y_3*f_y_x_6 + D_p_y_6*t201 + D_p_z_3*f_z_x_6
        + D_p_z_6*t207;
    K_g[2][24] = K_g[24][2] =
        D_delta_rx_1*t213 + D_delta_ry_1*t463 + D_delta_rz_1*t225 + D_delta_x_1*t195 + D_delta_y_1*t201
        + D_delta_z_1*t207 + D_p_rx_3*f_rx_delta_1 + D_p_ry_3*f_ry_delta_1 + D_p_rz_3*f_rz_delta_1
        + D_p_x_3*f_x_delta_1 + D_p_y_3*f_y_delta_1 + D_p_z_3*f_z_delta_1;
    K_g[2][25] = K_g[25][2] =
        D_delta_rx_2*t213 + D_delta_ry_2*t463 + D_delta_rz_2*t225 + D_delta_x_2*t195 + D_delta_y_2*t201
        + D_delta_z_2*t207 + D_p_rx_3*f_rx_delta_2 + D_p_ry_3*f_ry_delta_2 + D_p_rz_3*f_rz_delta_2
        + D_p_x_3*f_x_delta_2 + D_p_y_3*f_y_delta_2 + D_p_z_3*f_z_delta_2;
    K_g[2][26] = K_g[26][2] =
        D_delta_rx_3*t213 + D_delta_ry_3*t463 + D_delta_rz_3*t225 + D_delta_x_3*t195 + D_delta_y_3*t201
        + D_delta_z_3*t207 + D_p_rx_3*f_rx_delta_3 + D_p_ry_3*f_ry_delta_3 + D_p_rz_3*f_rz_delta_3
        + D_p_x_3*f_x_delta_3 + D_p_y_3*f_y_delta_3 + D_p_z_3*f_z_delta_3;
    K_g[2][27] = K_g[27][2] =
        D_delta_rx_4*t213 + D_delta_ry_4*t463 + D_delta_rz_4*t225 + D_delta_x_4*t195 + D_delta_y_4*t201
        + D_delta_z_4*t207 + D_p_rx_3*f_rx_delta_4 + D_p_ry_3*f_ry_delta_4 + D_p_rz_3*f_rz_delta_4
        + D_p_x_3*f_x_delta_4 + D_p_y_3*f_y_delta_4 + D_p_z_3*f_z_delta_4;
    K_g[2][28] = K_g[28][2] =
        D_delta_rx_5*t213 + D_delta_ry_5*t463 + D_delta_rz_5*t225 + D_delta_x_5*t195 + D_delta_y_5*t201
        + D_delta_z_5*t207 + D_p_rx_3*f_rx_delta_5 + D_p_ry_3*f_ry_delta_5 + D_p_rz_3*f_rz_delta_5
        + D_p_x_3*f_x_delta_5 + D_p_y_3*f_y_delta_5 + D_p_z_3*f_z_delta_5;
    K_g[2][29] = K_g[29][2] =
        D_delta_rx_6*t213 + D_delta_ry_6*t463 + D_delta_rz_6*t225 + D_delta_x_6*t195 + D_delta_y_6*t201
        + D_delta_z_6*t207 + D_p_rx_3*f_rx_delta_6 + D_p_ry_3*f_ry_delta_6 + D_p_rz_3*f_rz_delta_6
        + D_p_x_3*f_x_delta_6 + D_p_y_3*f_y_delta_6 + D_p_z_3*f_z_delta_6;
    K_g[3][3] =
        D_p_rx_4*f_rx_x_4 + D_p_rx_4*t214 + D_p_ry_4*f_ry_x_4 + D_p_ry_4*t464 + D_p_rz_4*f_rz_x_4
        + D_p_rz_4*t226 + D_p_x_4*f_x_x_4 + D_p_x_4*t196 + D_p_y_4*f_y_x_4 + D_p_y_4*t202 + D_p_z_4*f_z_x_4
        + D_p_z_4*t208 - mu_4*(n_4_x*n_4_x) - mu_4*(n_4_y*n_4_y) - mu_4*(n_4_z*n_4_z);
    K_g[3][4] = K_g[4][3] =
        D_p_rx_4*f_rx_x_5 + D_p_rx_5*t214 + D_p_ry_4*f_ry_x_5 + D_p_ry_5*t464 + D_p_rz_4*f_rz_x_5
        + D_p_rz_5*t226 + D_p_x_4*f_x_x_5 + D_p_x_5*t196 + D_p_y_4*f_y_x_5 + D_p_y_5*t202 + D_p_z_4*f_z_x_5
        + D_p_z_5*t208;
    K_g[3][5] = K_g[5][3] =
        D_p_rx_4*f_rx_x_6 + D_p_rx_6*t214 + D_p_ry_4*f_ry_x_6 + D_p_ry_6*t464 + D_p_rz_4*f_rz_x_6
        + D_p_rz_6*t226 + D_p_x_4*f_x_x_6 + D_p_x_6*t196 + D_p_y_4*f_y_x_6 + D_p_y_6*t202 + D_p_z_4*f_z_x_6
        + D_p_z_6*t208;
    K_g[3][24] = K_g[24][3] =
        D_delta_rx_1*t214 + D_delta_ry_1*t464 + D_delta_rz_1*t226 + D_delta_x_1*t196 + D_delta_y_1*t202
        + D_delta_z_1*t208 + D_p_rx_4*f_rx_delta_1 + D_p_ry_4*f_ry_delta_1 + D_p_rz_4*f_rz_delta_1
        + D_p_x_4*f_x_delta_1 + D_p_y_4*f_y_delta_1 + D_p_z_4*f_z_delta_1;
    K_g[3][25] = K_g[25][3] =
        D_delta_rx_2*t214 + D_delta_ry_2*t464 + D_delta_rz_2*t226 + D_delta_x_2*t196 + D_delta_y_2*t202
        + D_delta_z_2*t208 + D_p_rx_4*f_rx_delta_2 + D_p_ry_4*f_ry_delta_2 + D_p_rz_4*f_rz_delta_2
        + D_p_x_4*f_x_delta_2 + D_p_y_4*f_y_delta_2 + D_p_z_4*f_z_delta_2;
    K_g[3][26] = K_g[26][3] =
        D_delta_rx_3*t214 + D_delta_ry_3*t464 + D_delta_rz_3*t226 + D_delta_x_3*t196 + D_delta_y_3*t202
        + D_delta_z_3*t208 + D_p_rx_4*f_rx_delta_3 + D_p_ry_4*f_ry_delta_3 + D_p_rz_4*f_rz_delta_3
        + D_p_x_4*f_x_delta_3 + D_p_y_4*f_y_delta_3 + D_p_z_4*f_z_delta_3;
    K_g[3][27] = K_g[27][3] =
        D_delta_rx_4*t214 + D_delta_ry_4*t464 + D_delta_rz_4*t226 + D_delta_x_4*t196 + D_delta_y_4*t202
        + D_delta_z_4*t208 + D_p_rx_4*f_rx_delta_4 + D_p_ry_4*f_ry_delta_4 + D_p_rz_4*f_rz_delta_4
        + D_p_x_4*f_x_delta_4 + D_p_y_4*f_y_delta_4 + D_p_z_4*f_z_delta_4;
    K_g[3][28] = K_g[28][3] =
        D_delta_rx_5*t214 + D_delta_ry_5*t464 + D_delta_rz_5*t226 + D_delta_x_5*t196 + D_delta_y_5*t202
        + D_delta_z_5*t208 + D_p_rx_4*f_rx_delta_5 + D_p_ry_4*f_ry_delta_5 + D_p_rz_4*f_rz_delta_5
        + D_p_x_4*f_x_delta_5 + D_p_y_4*f_y_delta_5 + D_p_z_4*f_z_delta_5;
    K_g[3][29] = K_g[29][3] =
        D_delta_rx_6*t214 + D_delta_ry_6*t464 + D_delta_rz_6*t226 + D_delta_x_6*t196 + D_delta_y_6*t202
        + D_delta_z_6*t208 + D_p_rx_4*f_rx_delta_6 + D_p_ry_4*f_ry_delta_6 + D_p_rz_4*f_rz_delta_6
        + D_p_x_4*f_x_delta_6 + D_p_y_4*f_y_delta_6 + D_p_z_4*f_z_delta_6;
    K_g[4][4] =
        D_p_rx_5*f_rx_x_5 + D_p_rx_5*t215 + D_p_ry_5*f_ry_x_5 + D_p_ry_5*t465 + D_p_rz_5*f_rz_x_5
        + D_p_rz_5*t227 + D_p_x_5*f_x_x_5 + D_p_x_5*t197 + D_p_y_5*f_y_x_5 + D_p_y_5*t203 + D_p_z_5*f_z_x_5
        + D_p_z_5*t209 - mu_5*(n_5_x*n_5_x) - mu_5*(n_5_y*n_5_y) - mu_5*(n_5_z*n_5_z);
    K_g[4][5] = K_g[5][4] =
        D_p_rx_5*f_rx_x_6 + D_p_rx_6*t215 + D_p_ry_5*f_ry_x_6 + D_p_ry_6*t465 + D_p_rz_5*f_rz_x_6
        + D_p_rz_6*t227 + D_p_x_5*f_x_x_6 + D_p_x_6*t197 + D_p_y_5*f_y_x_6 + D_p_y_6*t203 + D_p_z_5*f_z_x_6
        + D_p_z_6*t209;
    K_g[4][24] = K_g[24][4] =
        D_delta_rx_1*t215 + D_delta_ry_1*t465 + D_delta_rz_1*t227 + D_delta_x_1*t197 + D_delta_y_1*t203
        + D_delta_z_1*t209 + D_p_rx_5*f_rx_delta_1 + D_p_ry_5*f_ry_delta_1 + D_p_rz_5*f_rz_delta_1
        + D_p_x_5*f_x_delta_1 + D_p_y_5*f_y_delta_1 + D_p_z_5*f_z_delta_1;
    K_g[4][25] = K_g[25][4] =
        D_delta_rx_2*t215 + D_delta_ry_2*t465 + D_delta_rz_2*t227 + D_delta_x_2*t197 + D_delta_y_2*t203
        + D_delta_z_2*t209 + D_p_rx_5*f_rx_delta_2 + D_p_ry_5*f_ry_delta_2 + D_p_rz_5*f_rz_delta_2
        + D_p_x_5*f_x_delta_2 + D_p_y_5*f_y_delta_2 + D_p_z_5*f_z_delta_2;
    K_g[4][26] = K_g[26][4] =
        D_delta_rx_3*t215 + D_delta_ry_3*t465 + D_delta_rz_3*t227 + D_delta_x_3*t197 + D_delta_y_3*t203
        + D_delta_z_3*t209 + D_p_rx_5*f_rx_delta_3 + D_p_ry_5*f_ry_delta_3 + D_p_rz_5*f_rz_delta_3
        + D_p_x_5*f_x_delta_3 + D_p_y_5*f_y_delta_3 + D_p_z_5*f_z_delta_3;
    K_g[4][27] = K_g[27][4] =
        D_delta_rx_4*t215 + D_delta_ry_4*t465 + D_delta_rz_4*t227 + D_delta_x_4*t197 + D_delta_y_4*t203
        + D_delta_z_4*t209 + D_p_rx_5*f_rx_delta_4 + D_p_ry_5*f_ry_delta_4 + D_p_rz_5*f_rz_delta_4
        + D_p_x_5*f_x_delta_4 + D_p_y_5*f_y_delta_4 + D_p_z_5*f_z_delta_4;
    K_g[4][28] = K_g[28][4] =
        D_delta_rx_5*t215 + D_delta_ry_5*t465 + D_delta_rz_5*t227 + D_delta_x_5*t197 + D_delta_y_5*t203
        + D_delta_z_5*t209 + D_p_rx_5*f_rx_delta_5 + D_p_ry_5*f_ry_delta_5 + D_p_rz_5*f_rz_delta_5
        + D_p_x_5*f_x_delta_5 + D_p_y_5*f_y_delta_5 + D_p_z_5*f_z_delta_5;
    K_g[4][29] = K_g[29][4] =
        D_delta_rx_6*t215 + D_delta_ry_6*t465 + D_delta_rz_6*t227 + D_delta_x_6*t197 + D_delta_y_6*t203
        + D_delta_z_6*t209 + D_p_rx_5*f_rx_delta_6 + D_p_ry_5*f_ry_delta_6 + D_p_rz_5*f_rz_delta_6
        + D_p_x_5*f_x_delta_6 + D_p_y_5*f_y_delta_6 + D_p_z_5*f_z_delta_6;
    K_g[5][5] =
        D_p_rx_6*f_rx_x_6 + D_p_rx_6*t216 + D_p_ry_6*f_ry_x_6 + D_p_ry_6*t466 + D_p_rz_6*f_rz_x_6
        + D_p_rz_6*t228 + D_p_x_6*f_x_x_6 + D_p_x_6*t198 + D_p_y_6*f_y_x_6 + D_p_y_6*t204 + D_p_z_6*f_z_x_6
        + D_p_z_6*t210 - mu_6*(n_6_x*n_6_x) - mu_6*(n_6_y*n_6_y) - mu_6*(n_6_z*n_6_z);
    K_g[5][24] = K_g[24][5] =
        D_delta_rx_1*t216 + D_delta_ry_1*t466 + D_delta_rz_1*t228 + D_delta_x_1*t198 + D_delta_y_1*t204
        + D_delta_z_1*t210 + D_p_rx_6*f_rx_delta_1 + D_p_ry_6*f_ry_delta_1 + D_p_rz_6*f_rz_delta_1
        + D_p_x_6*f_x_delta_1 + D_p_y_6*f_y_delta_1 + D_p_z_6*f_z_delta_1;
    K_g[5][25] = K_g[25][5] =
        D_delta_rx_2*t216 + D_delta_ry_2*t466 + D_delta_rz_2*t228 + D_delta_x_2*t198 + D_delta_y_2*t204
        + D_delta_z_2*t210 + D_p_rx_6*f_rx_delta_2 + D_p_ry_6*f_ry_delta_2 + D_p_rz_6*f_rz_delta_2
        + D_p_x_6*f_x_delta_2 + D_p_y_6*f_y_delta_2 + D_p_z_6*f_z_delta_2;
    K_g[5][26] = K_g[26][5] =
        D_delta_rx_3*t216 + D_delta_ry_3*t466 + D_delta_rz_3*t228 + D_delta_x_3*t198 + D_delta_y_3*t204
        + D_delta_z_3*t210 + D_p_rx_6*f_rx_delta_3 + D_p_ry_6*f_ry_delta_3 + D_p_rz_6*f_rz_delta_3
        + D_p_x_6*f_x_delta_3 + D_p_y_6*f_y_delta_3 + D_p_z_6*f_z_delta_3;
    K_g[5][27] = K_g[27][5] =
        D_delta_rx_4*t216 + D_delta_ry_4*t466 + D_delta_rz_4*t228 + D_delta_x_4*t198 + D_delta_y_4*t204
        + D_delta_z_4*t210 + D_p_rx_6*f_rx_delta_4 + D_p_ry_6*f_ry_delta_4 + D_p_rz_6*f_rz_delta_4
        + D_p_x_6*f_x_delta_4 + D_p_y_6*f_y_delta_4 + D_p_z_6*f_z_delta_4;
    K_g[5][28] = K_g[28][5] =
        D_delta_rx_5*t216 + D_delta_ry_5*t466 + D_delta_rz_5*t228 + D_delta_x_5*t198 + D_delta_y_5*t204
        + D_delta_z_5*t210 + D_p_rx_6*f_rx_delta_5 + D_p_ry_6*f_ry_delta_5 + D_p_rz_6*f_rz_delta_5
        + D_p_x_6*f_x_delta_5 + D_p_y_6*f_y_delta_5 + D_p_z_6*f_z_delta_5;
    K_g[5][29] = K_g[29][5] =
        D_delta_rx_6*t216 + D_delta_ry_6*t466 + D_delta_rz_6*t228 + D_delta_x_6*t198 + D_delta_y_6*t204
        + D_delta_z_6*t210 + D_p_rx_6*f_rx_delta_6 + D_p_ry_6*f_ry_delta_6 + D_p_rz_6*f_rz_delta_6
        + D_p_x_6*f_x_delta_6 + D_p_y_6*f_y_delta_6 + D_p_z_6*f_z_delta_6;
    K_g[24][24] =
        D_delta_rx_1*f_rx_delta_1 + D_delta_ry_1*f_ry_delta_1 + D_delta_rz_1*f_rz_delta_1
        + D_delta_x_1*f_x_delta_1 + D_delta_y_1*f_y_delta_1 + D_delta_z_1*f_z_delta_1 + mu_1;
    K_g[24][25] = K_g[25][24] =
        D_delta_rx_1*f_rx_delta_2 + D_delta_ry_1*f_ry_delta_2 + D_delta_rz_1*f_rz_delta_2
        + D_delta_x_1*f_x_delta_2 + D_delta_y_1*f_y_delta_2 + D_delta_z_1*f_z_delta_2;
    K_g[24][26] = K_g[26][24] =
        D_delta_rx_1*f_rx_delta_3 + D_delta_ry_1*f_ry_delta_3 + D_delta_rz_1*f_rz_delta_3
        + D_delta_x_1*f_x_delta_3 + D_delta_y_1*f_y_delta_3 + D_delta_z_1*f_z_delta_3;
    K_g[24][27] = K_g[27][24] =
        D_delta_rx_1*f_rx_delta_4 + D_delta_ry_1*f_ry_delta_4 + D_delta_rz_1*f_rz_delta_4
        + D_delta_x_1*f_x_delta_4 + D_delta_y_1*f_y_delta_4 + D_delta_z_1*f_z_delta_4;
    K_g[24][28] = K_g[28][24] =
        D_delta_rx_1*f_rx_delta_5 + D_delta_ry_1*f_ry_delta_5 + D_delta_rz_1*f_rz_delta_5
        + D_delta_x_1*f_x_delta_5 + D_delta_y_1*f_y_delta_5 + D_delta_z_1*f_z_delta_5;
    K_g[24][29] = K_g[29][24] =
        D_delta_rx_1*f_rx_delta_6 + D_delta_ry_1*f_ry_delta_6 + D_delta_rz_1*f_rz_delta_6
        + D_delta_x_1*f_x_delta_6 + D_delta_y_1*f_y_delta_6 + D_delta_z_1*f_z_delta_6;
    K_g[25][25] =
        D_delta_rx_2*f_rx_delta_2 + D_delta_ry_2*f_ry_delta_2 + D_delta_rz_2*f_rz_delta_2
        + D_delta_x_2*f_x_delta_2 + D_delta_y_2*f_y_delta_2 + D_delta_z_2*f_z_delta_2 + mu_2;
    K_g[25][26] = K_g[26][25] =
        D_delta_rx_2*f_rx_delta_3 + D_delta_ry_2*f_ry_delta_3 + D_delta_rz_2*f_rz_delta_3
        + D_delta_x_2*f_x_delta_3 + D_delta_y_2*f_y_delta_3 + D_delta_z_2*f_z_delta_3;
    K_g[25][27] = K_g[27][25] =
        D_delta_rx_2*f_rx_delta_4 + D_delta_ry_2*f_ry_delta_4 + D_delta_rz_2*f_rz_delta_4
        + D_delta_x_2*f_x_delta_4 + D_delta_y_2*f_y_delta_4 + D_delta_z_2*f_z_delta_4;
    K_g[25][28] = K_g[28][25] =
        D_delta_rx_2*f_rx_delta_5 + D_delta_ry_2*f_ry_delta_5 + D_delta_rz_2*f_rz_delta_5
        + D_delta_x_2*f_x_delta_5 + D_delta_y_2*f_y_delta_5 + D_delta_z_2*f_z_delta_5;
    K_g[25][29] = K_g[29][25] =
        D_delta_rx_2*f_rx_delta_6 + D_delta_ry_2*f_ry_delta_6 + D_delta_rz_2*f_rz_delta_6
        + D_delta_x_2*f_x_delta_6 + D_delta_y_2*f_y_delta_6 + D_delta_z_2*f_z_delta_6;
    K_g[26][26] =
        D_delta_rx_3*f_rx_delta_3 + D_delta_ry_3*f_ry_delta_3 + D_delta_rz_3*f_rz_delta_3
        + D_delta_x_3*f_x_delta_3 + D_delta_y_3*f_y_delta_3 + D_delta_z_3*f_z_delta_3 + mu_3;
    K_g[26][27] = K_g[27][26] =
        D_delta_rx_3*f_rx_delta_4 + D_delta_ry_3*f_ry_delta_4 + D_delta_rz_3*f_rz_delta_4
        + D_delta_x_3*f_x_delta_4 + D_delta_y_3*f_y_delta_4 + D_delta_z_3*f_z_delta_4;
    K_g[26][28] = K_g[28][26] =
        D_delta_rx_3*f_rx_delta_5 + D_delta_ry_3*f_ry_delta_5 + D_delta_rz_3*f_rz_delta_5
        + D_delta_x_3*f_x_delta_5 + D_delta_y_3*f_y_delta_5 + D_delta_z_3*f_z_delta_5;
    K_g[26][29] = K_g[29][26] =
        D_delta_rx_3*f_rx_delta_6 + D_delta_ry_3*f_ry_delta_6 + D_delta_rz_3*f_rz_delta_6
        + D_delta_x_3*f_x_delta_6 + D_delta_y_3*f_y_delta_6 + D_delta_z_3*f_z_delta_6;
    K_g[27][27] =
        D_delta_rx_4*f_rx_delta_4 + D_delta_ry_4*f_ry_delta_4 + D_delta_rz_4*f_rz_delta_4
        + D_delta_x_4*f_x_delta_4 + D_delta_y_4*f_y_delta_4 + D_delta_z_4*f_z_delta_4 + mu_4;
    K_g[27][28] = K_g[28][27] =
        D_delta_rx_4*f_rx_delta_5 + D_delta_ry_4*f_ry_delta_5 + D_delta_rz_4*f_rz_delta_5
        + D_delta_x_4*f_x_delta_5 + D_delta_y_4*f_y_delta_5 + D_delta_z_4*f_z_delta_5;
    K_g[27][29] = K_g[29][27] =
        D_delta_rx_4*f_rx_delta_6 + D_delta_ry_4*f_ry_delta_6 + D_delta_rz_4*f_rz_delta_6
        + D_delta_x_4*f_x_delta_6 + D_delta_y_4*f_y_delta_6 + D_delta_z_4*f_z_delta_6;
    K_g[28][28] =
        D_delta_rx_5*f_rx_delta_5 + D_delta_ry_5*f_ry_delta_5 + D_delta_rz_5*f_rz_delta_5
        + D_delta_x_5*f_x_delta_5 + D_delta_y_5*f_y_delta_5 + D_delta_z_5*f_z_delta_5 + mu_5;
    K_g[28][29] = K_g[29][28] =
        D_delta_rx_5*f_rx_delta_6 + D_delta_ry_5*f_ry_delta_6 + D_delta_rz_5*f_rz_delta_6
        + D_delta_x_5*f_x_delta_6 + D_delta_y_5*f_y_delta_6 + D_delta_z_5*f_z_delta_6;
    K_g[29][29] =
        D_delta_rx_6*f_rx_delta_6 + D_delta_ry_6*f_ry_delta_6 + D_delta_rz_6*f_rz_delta_6
        + D_delta_x_6*f_x_delta_6 + D_delta_y_6*f_y_delta_6 + D_delta_z_6*f_z_delta_6 + mu_6;
}

void hexaglide_extended_extended_platform_motion(const pkmodes_real p[6],
    const hexaglide_parameters *parameters, pkmodes_real J_p[6][39])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real o_1_x = parameters->origin[0][0];
    const pkmodes_real o_1_y = parameters->origin[0][1];
    const pkmodes_real o_1_z = parameters->origin[0][2];
    const pkmodes_real o_2_x = parameters->origin[1][0];
    const pkmodes_real o_2_y = parameters->origin[1][1];
    const pkmodes_real o_2_z = parameters->origin[1][2];
    const pkmodes_real o_3_x = parameters->origin[2][0];
    const pkmodes_real o_3_y = parameters->origin[2][1];
    const pkmodes_real o_3_z = parameters->origin[2][2];
    const pkmodes_real o_4_x = parameters->origin[3][0];
    const pkmodes_real o_4_y = parameters->origin[3][1];
    const pkmodes_real o_4_z = parameters->origin[3][2];
    const pkmodes_real o_5_x = parameters->origin[4][0];
    const pkmodes_real o_5_y = parameters->origin[4][1];
    const pkmodes_real o_5_z = parameters->origin[4][2];
    const pkmodes_real o_6_x = parameters->origin[5][0];
    const pkmodes_real o_6_y = parameters->origin[5][1];
    const pkmodes_real o_6_z = parameters->origin[5][2];
    const pkmodes_real n_1_x = parameters->direction[0][0];
    const pkmodes_real n_1_y = parameters->direction[0][1];
    const pkmodes_real n_1_z = parameters->direction[0][2];
    const pkmodes_real n_2_x = parameters->direction[1][0];
    const pkmodes_real n_2_y = parameters->direction[1][1];
    const pkmodes_real n_2_z = parameters->direction[1][2];
    const pkmodes_real n_3_x = parameters->direction[2][0];
    const pkmodes_real n_3_y = parameters->direction[2][1];
    const pkmodes_real n_3_z = parameters->direction[2][2];
    const pkmodes_real n_4_x = parameters->direction[3][0];
    const pkmodes_real n_4_y = parameters->direction[3][1];
    const pkmodes_real n_4_z = parameters->direction[3][2];
    const pkmodes_real n_5_x = parameters->direction[4][0];
    const pkmodes_real n_5_y = parameters->direction[4][1];
    const pkmodes_real n_5_z = parameters->direction[4][2];
    const pkmodes_real n_6_x = parameters->direction[5][0];
    const pkmodes_real n_6_y = parameters->direction[5][1];
    const pkmodes_real n_6_z = parameters->direction[5][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real b_4_x = parameters->joint[3][0];
    const pkmodes_real b_4_y = parameters->joint[3][1];
    const pkmodes_real b_4_z = parameters->joint[3][2];
    const pkmodes_real b_5_x = parameters->joint[4][0];
    const pkmodes_real b_5_y = parameters->joint[4][1];
    const pkmodes_real b_5_z = parameters->joint[4][2];
    const pkmodes_real b_6_x = parameters->joint[5][0];
    const pkmodes_real b_6_y = parameters->joint[5][1];
    const pkmodes_real b_6_z = parameters->joint[5][2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real l_d_4 = parameters->link_length[3];
    const pkmodes_real l_d_5 = parameters->link_length[4];
    const pkmodes_real l_d_6 = parameters->link_length[5];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real sigma_4 = parameters->branch[3];
    const pkmodes_real sigma_5 = parameters->branch[4];
    const pkmodes_real sigma_6 = parameters->branch[5];
    const pkmodes_real t1 = (rot_x*rot_x);
    const pkmodes_real t2 = (rot_y*rot_y);
    const pkmodes_real t3 = (rot_z*rot_z);
    const pkmodes_real t4 = t2 + t3;
    const pkmodes_real half_angle = (R(1.0)/R(2.0))*R(sqrt)(t1 + t4 + R(1e-30));
    const pkmodes_real s_half = R(sin)(half_angle)/half_angle;
    const pkmodes_real t5 = (s_half*s_half);
    const pkmodes_real t6 = (R(1.0)/R(2.0))*t5;
    const pkmodes_real R_x_x = -t4*t6 + 1;
    const pkmodes_real c_half = R(cos)(half_angle);
    const pkmodes_real t7 = c_half*s_half;
    const pkmodes_real t8 = rot_z*t7;
    const pkmodes_real R_x_y = (R(1.0)/R(2.0))*rot_x*rot_y*t5 - t8;
    const pkmodes_real t9 = rot_y*t7;
    const pkmodes_real t10 = rot_x*t6;
    const pkmodes_real R_x_z = rot_z*t10 + t9;
    const pkmodes_real B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const pkmodes_real r_1_x = B_1_x - o_1_x + p_x;
    const pkmodes_real R_y_x = rot_y*t10 + t8;
    const pkmodes_real R_y_y = t6*(-t1 - t3) + 1;
    const pkmodes_real t11 = rot_x*t7;
    const pkmodes_real R_y_z = (R(1.0)/R(2.0))*rot_y*rot_z*t5 - t11;
    const pkmodes_real B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const pkmodes_real r_1_y = B_1_y - o_1_y + p_y;
    const pkmodes_real R_z_x = (R(1.0)/R(2.0))*rot_x*rot_z*t5 - t9;
    const pkmodes_real R_z_y = rot_y*rot_z*t6 + t11;
    const pkmodes_real R_z_z = t6*(-t1 - t2) + 1;
    const pkmodes_real B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const pkmodes_real r_1_z = B_1_z - o_1_z + p_z;
    const pkmodes_real B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const pkmodes_real r_2_x = B_2_x - o_2_x + p_x;
    const pkmodes_real B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const pkmodes_real r_2_y = B_2_y - o_2_y + p_y;
    const pkmodes_real B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const pkmodes_real r_2_z = B_2_z - o_2_z + p_z;
    const pkmodes_real B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const pkmodes_real r_3_x = B_3_x - o_3_x + p_x;
    const pkmodes_real B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const pkmodes_real r_3_y = B_3_y - o_3_y + p_y;
    const pkmodes_real B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const pkmodes_real r_3_z = B_3_z - o_3_z + p_z;
    const pkmodes_real B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const pkmodes_real r_4_x = B_4_x - o_4_x + p_x;
    const pkmodes_real B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const pkmodes_real r_4_y = B_4_y - o_4_y + p_y;
    const pkmodes_real B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const pkmodes_real r_4_z = B_4_z - o_4_z + p_z;
    const pkmodes_real B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const pkmodes_real r_5_x = B_5_x - o_5_x + p_x;
    const pkmodes_real B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const pkmodes_real r_5_y = B_5_y - o_5_y + p_y;
    const pkmodes_real B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const pkmodes_real r_5_z = B_5_z - o_5_z + p_z;
    const pkmodes_real B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const pkmodes_real r_6_x = B_6_x - o_6_x + p_x;
    const pkmodes_real B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const pkmodes_real r_6_y = B_6_y - o_6_y + p_y;
    const pkmodes_real B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const pkmodes_real r_6_z = B_6_z - o_6_z + p_z;
    const pkmodes_real a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z;
    const pkmodes_real w_1_x = -a_1*n_1_x + r_1_x;
    const pkmodes_real w_1_y = -a_1*n_1_y + r_1_y;
    const pkmodes_real w_1_z = -a_1*n_1_z + r_1_z;
    const pkmodes_real w2_1 = (w_1_x*w_1_x) + (w_1_y*w_1_y) + (w_1_z*w_1_z);
    const pkmodes_real x_1 = a_1 + sigma_1*R(sqrt)((l_d_1*l_d_1) - w2_1);
    const pkmodes_real a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const pkmodes_real w_2_x = -a_2*n_2_x + r_2_x;
    const pkmodes_real w_2_y = -a_2*n_2_y + r_2_y;
    const pkmodes_real w_2_z = -a_2*n_2_z + r_2_z;
    const pkmodes_real w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const pkmodes_real x_2 = a_2 + sigma_2*R(sqrt)((l_d_2*l_d_2) - w2_2);
    const pkmodes_real a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const pkmodes_real w_3_x = -a_3*n_3_x + r_3_x;
    const pkmodes_real w_3_y = -a_3*n_3_y + r_3_y;
    const pkmodes_real w_3_z = -a_3*n_3_z + r_3_z;
    const pkmodes_real w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const pkmodes_real x_3 = a_3 + sigma_3*R(sqrt)((l_d_3*l_d_3) - w2_3);
    const pkmodes_real a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z;
    const pkmodes_real w_4_x = -a_4*n_4_x + r_4_x;
    const pkmodes_real w_4_y = -a_4*n_4_y + r_4_y;
    const pkmodes_real w_4_z = -a_4*n_4_z + r_4_z;
    const pkmodes_real w2_4 = (w_4_x*w_4_x) + (w_4_y*w_4_y) + (w_4_z*w_4_z);
    const pkmodes_real x_4 = a_4 + sigma_4*R(sqrt)((l_d_4*l_d_4) - w2_4);
    const pkmodes_real a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z;
    const pkmodes_real w_5_x = -a_5*n_5_x + r_5_x;
    const pkmodes_real w_5_y = -a_5*n_5_y + r_5_y;
    const pkmodes_real w_5_z = -a_5*n_5_z + r_5_z;
    const pkmodes_real w2_5 = (w_5_x*w_5_x) + (w_5_y*w_5_y) + (w_5_z*w_5_z);
    const pkmodes_real x_5 = a_5 + sigma_5*R(sqrt)((l_d_5*l_d_5) - w2_5);
    const pkmodes_real a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z;
    const pkmodes_real w_6_x = -a_6*n_6_x + r_6_x;
    const pkmodes_real w_6_y = -a_6*n_6_y + r_6_y;
    const pkmodes_real w_6_z = -a_6*n_6_z + r_6_z;
    const pkmodes_real w2_6 = (w_6_x*w_6_x) + (w_6_y*w_6_y) + (w_6_z*w_6_z);
    const pkmodes_real x_6 = a_6 + sigma_6*R(sqrt)((l_d_6*l_d_6) - w2_6);
    const pkmodes_real s_1_x = -n_1_x*x_1 + r_1_x;
    const pkmodes_real s_1_y = -n_1_y*x_1 + r_1_y;
    const pkmodes_real s_1_z = -n_1_z*x_1 + r_1_z;
    const pkmodes_real s_2_x = -n_2_x*x_2 + r_2_x;
    const pkmodes_real s_2_y = -n_2_y*x_2 + r_2_y;
    const pkmodes_real s_2_z = -n_2_z*x_2 + r_2_z;
    const pkmodes_real s_3_x = -n_3_x*x_3 + r_3_x;
    const pkmodes_real s_3_y = -n_3_y*x_3 + r_3_y;
    const pkmodes_real s_3_z = -n_3_z*x_3 + r_3_z;
    const pkmodes_real s_4_x = -n_4_x*x_4 + r_4_x;
    const pkmodes_real s_4_y = -n_4_y*x_4 + r_4_y;
    const pkmodes_real s_4_z = -n_4_z*x_4 + r_4_z;
    const pkmodes_real s_5_x = -n_5_x*x_5 + r_5_x;
    const pkmodes_real s_5_y = -n_5_y*x_5 + r_5_y;
    const pkmodes_real s_5_z = -n_5_z*x_5 + r_5_z;
    const pkmodes_real s_6_x = -n_6_x*x_6 + r_6_x;
    const pkmodes_real s_6_y = -n_6_y*x_6 + r_6_y;
    const pkmodes_real s_6_z = -n_6_z*x_6 + r_6_z;
    const pkmodes_real D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y;
    const pkmodes_real D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x;
    const pkmodes_real D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x;
    const pkmodes_real D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y;
    const pkmodes_real D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x;
    const pkmodes_real D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x;
    const pkmodes_real D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y;
    const pkmodes_real D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x;
    const pkmodes_real D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x;
    const pkmodes_real D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y;
    const pkmodes_real D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x;
    const pkmodes_real D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x;
    const pkmodes_real D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y;
    const pkmodes_real D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x;
    const pkmodes_real D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x;
    const pkmodes_real D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y;
    const pkmodes_real D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x;
    const pkmodes_real D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x;
    const pkmodes_real D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const pkmodes_real D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const pkmodes_real D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const pkmodes_real D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z;
    const pkmodes_real D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z;
    const pkmodes_real D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z;
    const pkmodes_real minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y;
    const pkmodes_real minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const pkmodes_real minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const pkmodes_real minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const pkmodes_real minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const pkmodes_real minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y;
    const pkmodes_real minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z;
    const pkmodes_real minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z;
    const pkmodes_real minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z;
    const pkmodes_real minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y;
    const pkmodes_real minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z;
    const pkmodes_real minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z;
    const pkmodes_real minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y;
    const pkmodes_real minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z;
    const pkmodes_real minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z;
    const pkmodes_real minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y;
    const pkmodes_real minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y;
    const pkmodes_real minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y;
    const pkmodes_real minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z;
    const pkmodes_real minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y;
    const pkmodes_real minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y;
    const pkmodes_real minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z;
    const pkmodes_real minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y;
    const pkmodes_real minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const pkmodes_real minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y;
    const pkmodes_real minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y;
    const pkmodes_real minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const pkmodes_real minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y;
    const pkmodes_real minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const pkmodes_real minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y;
    const pkmodes_real A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const pkmodes_real minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x;
    const pkmodes_real minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x;
    const pkmodes_real minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x;
    const pkmodes_real minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x;
    const pkmodes_real minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x;
    const pkmodes_real minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x;
    const pkmodes_real minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x;
    const pkmodes_real minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x;
    const pkmodes_real minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x;
    const pkmodes_real minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x;
    const pkmodes_real minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x;
    const pkmodes_real minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x;
    const pkmodes_real minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x;
    const pkmodes_real minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x;
    const pkmodes_real A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const pkmodes_real minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x;
    const pkmodes_real minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x;
    const pkmodes_real minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x;
    const pkmodes_real minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x;
    const pkmodes_real minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x;
    const pkmodes_real A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const pkmodes_real minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x;
    const pkmodes_real A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const pkmodes_real A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const pkmodes_real A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const pkmodes_real minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y;
    const pkmodes_real minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y;
    const pkmodes_real minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y;
    const pkmodes_real minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y;
    const pkmodes_real minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z;
    const pkmodes_real minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z;
    const pkmodes_real minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z;
    const pkmodes_real minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const pkmodes_real minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const pkmodes_real minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const pkmodes_real A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const pkmodes_real minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x;
    const pkmodes_real minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x;
    const pkmodes_real minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x;
    const pkmodes_real minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x;
    const pkmodes_real A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const pkmodes_real minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x;
    const pkmodes_real A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const pkmodes_real A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const pkmodes_real A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const pkmodes_real A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const pkmodes_real minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y;
    const pkmodes_real minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y;
    const pkmodes_real minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y;
    const pkmodes_real minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y;
    const pkmodes_real minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z;
    const pkmodes_real minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z;
    const pkmodes_real minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z;
    const pkmodes_real minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const pkmodes_real minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const pkmodes_real minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const pkmodes_real A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const pkmodes_real minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x;
    const pkmodes_real minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x;
    const pkmodes_real minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x;
    const pkmodes_real minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x;
    const pkmodes_real A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const pkmodes_real minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x;
    const pkmodes_real A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const pkmodes_real A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const pkmodes_real A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const pkmodes_real A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const pkmodes_real minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y;
    const pkmodes_real minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y;
    const pkmodes_real minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y;
    const pkmodes_real minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y;
    const pkmodes_real minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y;
    const pkmodes_real minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y;
    const pkmodes_real minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z;
    const pkmodes_real minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z;
    const pkmodes_real minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z;
    const pkmodes_real minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const pkmodes_real A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const pkmodes_real minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x;
    const pkmodes_real minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x;
    const pkmodes_real minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x;
    const pkmodes_real minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x;
    const pkmodes_real minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x;
    const pkmodes_real minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x;
    const pkmodes_real A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const pkmodes_real minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x;
    const pkmodes_real minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x;
    const pkmodes_real minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x;
    const pkmodes_real A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const pkmodes_real minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x;
    const pkmodes_real A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const pkmodes_real A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const pkmodes_real A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const pkmodes_real minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const pkmodes_real minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const pkmodes_real minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const pkmodes_real minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z;
    const pkmodes_real minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z;
    const pkmodes_real minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z;
    const pkmodes_real minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y;
    const pkmodes_real minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y;
    const pkmodes_real minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y;
    const pkmodes_real minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y;
    const pkmodes_real A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const pkmodes_real minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x;
    const pkmodes_real minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x;
    const pkmodes_real minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x;
    const pkmodes_real minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x;
    const pkmodes_real A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const pkmodes_real minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x;
    const pkmodes_real A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const pkmodes_real A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const pkmodes_real A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const pkmodes_real A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const pkmodes_real minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const pkmodes_real minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const pkmodes_real minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const pkmodes_real minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z;
    const pkmodes_real minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z;
    const pkmodes_real minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z;
    const pkmodes_real minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y;
    const pkmodes_real minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y;
    const pkmodes_real minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y;
    const pkmodes_real minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y;
    const pkmodes_real A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const pkmodes_real minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x;
    const pkmodes_real minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x;
    const pkmodes_real minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x;
    const pkmodes_real minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x;
    const pkmodes_real A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const pkmodes_real minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x;
    const pkmodes_real A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const pkmodes_real A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const pkmodes_real A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const pkmodes_real A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const pkmodes_real det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const pkmodes_real t12 = 1/det_D_l;
    const pkmodes_real t13 = A_x_1*t12;
    const pkmodes_real D_p_x_1 = D_r_1*t13;
    const pkmodes_real t14 = A_x_2*t12;
    const pkmodes_real D_p_x_2 = D_r_2*t14;
    const pkmodes_real t15 = A_x_3*t12;
    const pkmodes_real D_p_x_3 = D_r_3*t15;
    const pkmodes_real t16 = A_x_4*t12;
    const pkmodes_real D_p_x_4 = D_r_4*t16;
    const pkmodes_real t17 = A_x_5*t12;
    const pkmodes_real D_p_x_5 = D_r_5*t17;
    const pkmodes_real t18 = A_x_6*t12;
    const pkmodes_real D_p_x_6 = D_r_6*t18;
    const pkmodes_real D_delta_x_1 = l_d_1*t13;
    const pkmodes_real D_delta_x_2 = l_d_2*t14;
    const pkmodes_real D_delta_x_3 = l_d_3*t15;
    const pkmodes_real D_delta_x_4 = l_d_4*t16;
    const pkmodes_real D_delta_x_5 = l_d_5*t17;
    const pkmodes_real D_delta_x_6 = l_d_6*t18;
    const pkmodes_real t19 = A_y_1*t12;
    const pkmodes_real D_p_y_1 = D_r_1*t19;
    const pkmodes_real t20 = A_y_2*t12;
    const pkmodes_real D_p_y_2 = D_r_2*t20;
    const pkmodes_real t21 = A_y_3*t12;
    const pkmodes_real D_p_y_3 = D_r_3*t21;
    const pkmodes_real t22 = A_y_4*t12;
    const pkmodes_real D_p_y_4 = D_r_4*t22;
    const pkmodes_real t23 = A_y_5*t12;
    const pkmodes_real D_p_y_5 = D_r_5*t23;
    const pkmodes_real t24 = A_y_6*t12;
    const pkmodes_real D_p_y_6 = D_r_6*t24;
    const pkmodes_real D_delta_y_1 = l_d_1*t19;
    const pkmodes_real D_delta_y_2 = l_d_2*t20;
    const pkmodes_real D_delta_y_3 = l_d_3*t21;
    const pkmodes_real D_delta_y_4 = l_d_4*t22;
    const pkmodes_real D_delta_y_5 = l_d_5*t23;
    const pkmodes_real D_delta_y_6 = l_d_6*t24;
    const pkmodes_real t25 = A_z_1*t12;
    const pkmodes_real D_p_z_1 = D_r_1*t25;
    const pkmodes_real t26 = A_z_2*t12;
    const pkmodes_real D_p_z_2 = D_r_2*t26;
    const pkmodes_real t27 = A_z_3*t12;
    const pkmodes_real D_p_z_3 = D_r_3*t27;
    const pkmodes_real t28 = A_z_4*t12;
    const pkmodes_real D_p_z_4 = D_r_4*t28;
    const pkmodes_real t29 = A_z_5*t12;
    const pkmodes_real D_p_z_5 = D_r_5*t29;
    const pkmodes_real t30 = A_z_6*t12;
    const pkmodes_real D_p_z_6 = D_r_6*t30;
    const pkmodes_real D_delta_z_1 = l_d_1*t25;
    const pkmodes_real D_delta_z_2 = l_d_2*t26;
    const pkmodes_real D_delta_z_3 = l_d_3*t27;
    const pkmodes_real D_delta_z_4 = l_d_4*t28;
    const pkmodes_real D_delta_z_5 = l_d_5*t29;
    const pkmodes_real D_delta_z_6 = l_d_6*t30;
    const pkmodes_real t31 = A_rx_1*t12;
    const pkmodes_real D_p_rx_1 = D_r_1*t31;
    const pkmodes_real t32 = A_rx_2*t12;
    const pkmodes_real D_p_rx_2 = D_r_2*t32;
    const pkmodes_real t33 = A_rx_3*t12;
    const pkmodes_real D_p_rx_3 = D_r_3*t33;
    const pkmodes_real t34 = A_rx_4*t12;
    const pkmodes_real D_p_rx_4 = D_r_4*t34;
    const pkmodes_real t35 = A_rx_5*t12;
    const pkmodes_real D_p_rx_5 = D_r_5*t35;
    const pkmodes_real t36 = A_rx_6*t12;
    const pkmodes_real D_p_rx_6 = D_r_6*t36;
    const pkmodes_real D_delta_rx_1 = l_d_1*t31;
    const pkmodes_real D_delta_rx_2 = l_d_2*t32;
    const pkmodes_real D_delta_rx_3 = l_d_3*t33;
    const pkmodes_real D_delta_rx_4 = l_d_4*t34;
    const pkmodes_real D_delta_rx_5 = l_d_5*t35;
    const pkmodes_real D_delta_rx_6 = l_d_6*t36;
    const pkmodes_real t37 = A_ry_1*t12;
    const pkmodes_real D_p_ry_1 = D_r_1*t37;
    const pkmodes_real t38 = A_ry_2*t12;
    const pkmodes_real D_p_ry_2 = D_r_2*t38;
    const pkmodes_real t39 = A_ry_3*t12;
    const pkmodes_real D_p_ry_3 = D_r_3*t39;
    const pkmodes_real t40 = A_ry_4*t12;
    const pkmodes_real D_p_ry_4 = D_r_4*t40;
    const pkmodes_real t41 = A_ry_5*t12;
    const pkmodes_real D_p_ry_5 = D_r_5*t41;
    const pkmodes_real t42 = A_ry_6*t12;
    const pkmodes_real D_p_ry_6 = D_r_6*t42;
    const pkmodes_real D_delta_ry_1 = l_d_1*t37;
    const pkmodes_real D_delta_ry_2 = l_d_2*t38;
    const pkmodes_real D_delta_ry_3 = l_d_3*t39;
    const pkmodes_real D_delta_ry_4 = l_d_4*t40;
    const pkmodes_real D_delta_ry_5 = l_d_5*t41;
    const pkmodes_real D_delta_ry_6 = l_d_6*t42;
    const pkmodes_real t43 = A_rz_1*t12;
    const pkmodes_real D_p_rz_1 = D_r_1*t43;
    const pkmodes_real t44 = A_rz_2*t12;
    const pkmodes_real D_p_rz_2 = D_r_2*t44;
    const pkmodes_real t45 = A_rz_3*t12;
    const pkmodes_real D_p_rz_3 = D_r_3*t45;
    const pkmodes_real t46 = A_rz_4*t12;
    const pkmodes_real D_p_rz_4 = D_r_4*t46;
    const pkmodes_real t47 = A_rz_5*t12;
    const pkmodes_real D_p_rz_5 = D_r_5*t47;
    const pkmodes_real t48 = A_rz_6*t12;
    const pkmodes_real D_p_rz_6 = D_r_6*t48;
    const pkmodes_real D_delta_rz_1 = l_d_1*t43;
    const pkmodes_real D_delta_rz_2 = l_d_2*t44;
    const pkmodes_real D_delta_rz_3 = l_d_3*t45;
    const pkmodes_real D_delta_rz_4 = l_d_4*t46;
    const pkmodes_real D_delta_rz_5 = l_d_5*t47;
    const pkmodes_real D_delta_rz_6 = l_d_6*t48;
    memset(J_p, 0, sizeof(pkmodes_real[6][39]));
    J_p[0][0] = D_p_x_1;
    J_p[0][1] = D_p_x_2;
    J_p[0][2] = D_p_x_3;
    J_p[0][3] = D_p_x_4;
    J_p[0][4] = D_p_x_5;
    J_p[0][5] = D_p_x_6;
    J_p[0][24] = D_delta_x_1;
    J_p[0][25] = D_delta_x_2;
    J_p[0][26] = D_delta_x_3;
    J_p[0][27] = D_delta_x_4;
    J_p[0][28] = D_delta_x_5;
    J_p[0][29] = D_delta_x_6;
    J_p[0][36] = 1;
    J_p[1][0] = D_p_y_1;
    J_p[1][1] = D_p_y_2;
    J_p[1][2] = D_p_y_3;
    J_p[1][3] = D_p_y_4;
    J_p[1][4] = D_p_y_5;
    J_p[1][5] = D_p_y_6;
    J_p[1][24] = D_delta_y_1;
    J_p[1][25] = D_delta_y_2;
    J_p[1][26] = D_delta_y_3;
    J_p[1][27] = D_delta_y_4;
    J_p[1][28] = D_delta_y_5;
    J_p[1][29] = D_delta_y_6;
    J_p[1][37] = 1;
    J_p[2][0] = D_p_z_1;
    J_p[2][1] = D_p_z_2;
    J_p[2][2] = D_p_z_3;
    J_p[2][3] = D_p_z_4;
    J_p[2][4] = D_p_z_5;
    J_p[2][5] = D_p_z_6;
    J_p[2][24] = D_delta_z_1;
    J_p[2][25] = D_delta_z_2;
    J_p[2][26] = D_delta_z_3;
    J_p[2][27] = D_delta_z_4;
    J_p[2][28] = D_delta_z_5;
    J_p[2][29] = D_delta_z_6;
    J_p[2][38] = 1;
    J_p[3][0] = D_p_rx_1;
    J_p[3][1] = D_p_rx_2;
    J_p[3][2] = D_p_rx_3;
    J_p[3][3] = D_p_rx_4;
    J_p[3][4] = D_p_rx_5;
    J_p[3][5] = D_p_rx_6;
    J_p[3][24] = D_delta_rx_1;
    J_p[3][25] = D_delta_rx_2;
    J_p[3][26] = D_delta_rx_3;
    J_p[3][27] = D_delta_rx_4;
    J_p[3][28] = D_delta_rx_5;
    J_p[3][29] = D_delta_rx_6;
    J_p[4][0] = D_p_ry_1;
    J_p[4][1] = D_p_ry_2;
    J_p[4][2] = D_p_ry_3;
    J_p[4][3] = D_p_ry_4;
    J_p[4][4] = D_p_ry_5;
    J_p[4][5] = D_p_ry_6;
    J_p[4][24] = D_delta_ry_1;
    J_p[4][25] = D_delta_ry_2;
    J_p[4][26] = D_delta_ry_3;
    J_p[4][27] = D_delta_ry_4;
    J_p[4][28] = D_delta_ry_5;
    J_p[4][29] = D_delta_ry_6;
    J_p[5][0] = D_p_rz_1;
    J_p[5][1] = D_p_rz_2;
    J_p[5][2] = D_p_rz_3;
    J_p[5][3] = D_p_rz_4;
    J_p[5][4] = D_p_rz_5;
    J_p[5][5] = D_p_rz_6;
    J_p[5][24] = D_delta_rz_1;
    J_p[5][25] = D_delta_rz_2;
    J_p[5][26] = D_delta_rz_3;
    J_p[5][27] = D_delta_rz_4;
    J_p[5][28] = D_delta_rz_5;
    J_p[5][29] = D_delta_rz_6;
}

void hexaglide_extended_joint_stiffness(const hexaglide_effects *effects, pkmodes_real kappa[21],
    pkmodes_real kappa_c[21])
{
    const pkmodes_real c_G = effects->gearbox_compliance_compliance;
    const pkmodes_real c_L = effects->link_compliance_compliance;
    const pkmodes_real c_K = effects->clamp_compliance_compliance;
    const pkmodes_real c_F = effects->frame_compliance_compliance;
    const pkmodes_real c_F_x = effects->frame_compliance_compliance_x;
    const pkmodes_real c_F_y = effects->frame_compliance_compliance_y;
    const pkmodes_real c_F_z = effects->frame_compliance_compliance_z;
    const pkmodes_real t1 = 1/c_G;
    const pkmodes_real t2 = 1/c_L;
    const pkmodes_real t3 = 1/c_K;
    const pkmodes_real t4 = c_F + c_F_x;
    const pkmodes_real t5 = c_F + c_F_y;
    const pkmodes_real t6 = c_F + c_F_z;
    const pkmodes_real t7 = -1/(c_G*c_G);
    const pkmodes_real t8 = -1/(c_L*c_L);
    const pkmodes_real t9 = -1/(c_K*c_K);
    kappa[0] = t1;
    kappa[1] = t1;
    kappa[2] = t1;
    kappa[3] = t1;
    kappa[4] = t1;
    kappa[5] = t1;
    kappa[6] = t2;
    kappa[7] = t2;
    kappa[8] = t2;
    kappa[9] = t2;
    kappa[10] = t2;
    kappa[11] = t2;
    kappa[12] = t3;
    kappa[13] = t3;
    kappa[14] = t3;
    kappa[15] = t3;
    kappa[16] = t3;
    kappa[17] = t3;
    kappa[18] = 1/t4;
    kappa[19] = 1/t5;
    kappa[20] = 1/t6;
    kappa_c[0] = t7;
    kappa_c[1] = t7;
    kappa_c[2] = t7;
    kappa_c[3] = t7;
    kappa_c[4] = t7;
    kappa_c[5] = t7;
    kappa_c[6] = t8;
    kappa_c[7] = t8;
    kappa_c[8] = t8;
    kappa_c[9] = t8;
    kappa_c[10] = t8;
    kappa_c[11] = t8;
    kappa_c[12] = t9;
    kappa_c[13] = t9;
    kappa_c[14] = t9;
    kappa_c[15] = t9;
    kappa_c[16] = t9;
    kappa_c[17] = t9;
    kappa_c[18] = -1/(t4*t4);
    kappa_c[19] = -1/(t5*t5);
    kappa_c[20] = -1/(t6*t6);
}

void hexaglide_extended_extended_static_equilibrium(const pkmodes_real p[6],
    const hexaglide_parameters *parameters, const hexaglide_effects *effects, pkmodes_real tau_st[6],
    pkmodes_real theta_st[12])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real m_p = parameters->platform_mass;
    const pkmodes_real c_p_x = parameters->platform_center[0];
    const pkmodes_real c_p_y = parameters->platform_center[1];
    const pkmodes_real c_p_z = parameters->platform_center[2];
    const pkmodes_real g_x = parameters->gravity[0];
    const pkmodes_real g_y = parameters->gravity[1];
    const pkmodes_real g_z = parameters->gravity[2];
    const pkmodes_real o_1_x = parameters->origin[0][0];
    const pkmodes_real o_1_y = parameters->origin[0][1];
    const pkmodes_real o_1_z = parameters->origin[0][2];
    const pkmodes_real o_2_x = parameters->origin[1][0];
    const pkmodes_real o_2_y = parameters->origin[1][1];
    const pkmodes_real o_2_z = parameters->origin[1][2];
    const pkmodes_real o_3_x = parameters->origin[2][0];
    const pkmodes_real o_3_y = parameters->origin[2][1];
    const pkmodes_real o_3_z = parameters->origin[2][2];
    const pkmodes_real o_4_x = parameters->origin[3][0];
    const pkmodes_real o_4_y = parameters->origin[3][1];
    const pkmodes_real o_4_z = parameters->origin[3][2];
    const pkmodes_real o_5_x = parameters->origin[4][0];
    const pkmodes_real o_5_y = parameters->origin[4][1];
    const pkmodes_real o_5_z = parameters->origin[4][2];
    const pkmodes_real o_6_x = parameters->origin[5][0];
    const pkmodes_real o_6_y = parameters->origin[5][1];
    const pkmodes_real o_6_z = parameters->origin[5][2];
    const pkmodes_real n_1_x = parameters->direction[0][0];
    const pkmodes_real n_1_y = parameters->direction[0][1];
    const pkmodes_real n_1_z = parameters->direction[0][2];
    const pkmodes_real n_2_x = parameters->direction[1][0];
    const pkmodes_real n_2_y = parameters->direction[1][1];
    const pkmodes_real n_2_z = parameters->direction[1][2];
    const pkmodes_real n_3_x = parameters->direction[2][0];
    const pkmodes_real n_3_y = parameters->direction[2][1];
    const pkmodes_real n_3_z = parameters->direction[2][2];
    const pkmodes_real n_4_x = parameters->direction[3][0];
    const pkmodes_real n_4_y = parameters->direction[3][1];
    const pkmodes_real n_4_z = parameters->direction[3][2];
    const pkmodes_real n_5_x = parameters->direction[4][0];
    const pkmodes_real n_5_y = parameters->direction[4][1];
    const pkmodes_real n_5_z = parameters->direction[4][2];
    const pkmodes_real n_6_x = parameters->direction[5][0];
    const pkmodes_real n_6_y = parameters->direction[5][1];
    const pkmodes_real n_6_z = parameters->direction[5][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real b_4_x = parameters->joint[3][0];
    const pkmodes_real b_4_y = parameters->joint[3][1];
    const pkmodes_real b_4_z = parameters->joint[3][2];
    const pkmodes_real b_5_x = parameters->joint[4][0];
    const pkmodes_real b_5_y = parameters->joint[4][1];
    const pkmodes_real b_5_z = parameters->joint[4][2];
    const pkmodes_real b_6_x = parameters->joint[5][0];
    const pkmodes_real b_6_y = parameters->joint[5][1];
    const pkmodes_real b_6_z = parameters->joint[5][2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real l_d_4 = parameters->link_length[3];
    const pkmodes_real l_d_5 = parameters->link_length[4];
    const pkmodes_real l_d_6 = parameters->link_length[5];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real m_d_4 = parameters->link_mass[3];
    const pkmodes_real m_d_5 = parameters->link_mass[4];
    const pkmodes_real m_d_6 = parameters->link_mass[5];
    const pkmodes_real m_t_1 = parameters->carriage_mass[0];
    const pkmodes_real m_t_2 = parameters->carriage_mass[1];
    const pkmodes_real m_t_3 = parameters->carriage_mass[2];
    const pkmodes_real m_t_4 = parameters->carriage_mass[3];
    const pkmodes_real m_t_5 = parameters->carriage_mass[4];
    const pkmodes_real m_t_6 = parameters->carriage_mass[5];
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real l_t_4 = parameters->carriage_length[3];
    const pkmodes_real l_t_5 = parameters->carriage_length[4];
    const pkmodes_real l_t_6 = parameters->carriage_length[5];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real k_sp_3 = parameters->belt_specific_stiffness[2];
    const pkmodes_real k_sp_4 = parameters->belt_specific_stiffness[3];
    const pkmodes_real k_sp_5 = parameters->belt_specific_stiffness[4];
    const pkmodes_real k_sp_6 = parameters->belt_specific_stiffness[5];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real w_b_3 = parameters->belt_width[2];
    const pkmodes_real w_b_4 = parameters->belt_width[3];
    const pkmodes_real w_b_5 = parameters->belt_width[4];
    const pkmodes_real w_b_6 = parameters->belt_width[5];
    const pkmodes_real R_p_1 = parameters->pulley_radius[0];
    const pkmodes_real R_p_2 = parameters->pulley_radius[1];
    const pkmodes_real R_p_3 = parameters->pulley_radius[2];
    const pkmodes_real R_p_4 = parameters->pulley_radius[3];
    const pkmodes_real R_p_5 = parameters->pulley_radius[4];
    const pkmodes_real R_p_6 = parameters->pulley_radius[5];
    const pkmodes_real d_1_1 = parameters->drive[0][0];
    const pkmodes_real d_1_2 = parameters->drive[0][1];
    const pkmodes_real d_2_1 = parameters->drive[1][0];
    const pkmodes_real d_2_2 = parameters->drive[1][1];
    const pkmodes_real d_3_1 = parameters->drive[2][0];
    const pkmodes_real d_3_2 = parameters->drive[2][1];
    const pkmodes_real d_4_1 = parameters->drive[3][0];
    const pkmodes_real d_4_2 = parameters->drive[3][1];
    const pkmodes_real d_5_1 = parameters->drive[4][0];
    const pkmodes_real d_5_2 = parameters->drive[4][1];
    const pkmodes_real d_6_1 = parameters->drive[5][0];
    const pkmodes_real d_6_2 = parameters->drive[5][1];
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
    const pkmodes_real x_min_4 = parameters->limits[3][0];
    const pkmodes_real x_max_4 = parameters->limits[3][1];
    const pkmodes_real x_min_5 = parameters->limits[4][0];
    const pkmodes_real x_max_5 = parameters->limits[4][1];
    const pkmodes_real x_min_6 = parameters->limits[5][0];
    const pkmodes_real x_max_6 = parameters->limits[5][1];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real sigma_4 = parameters->branch[3];
    const pkmodes_real sigma_5 = parameters->branch[4];
    const pkmodes_real sigma_6 = parameters->branch[5];
    const pkmodes_real a_B_1 = effects->axis_belt_stiffness_factor_1;
    const pkmodes_real a_B_2 = effects->axis_belt_stiffness_factor_2;
    const pkmodes_real a_B_3 = effects->axis_belt_stiffness_factor_3;
    const pkmodes_real a_B_4 = effects->axis_belt_stiffness_factor_4;
    const pkmodes_real a_B_5 = effects->axis_belt_stiffness_factor_5;
    const pkmodes_real a_B_6 = effects->axis_belt_stiffness_factor_6;
    const pkmodes_real c_E = effects->belt_end_compliance_compliance;
    const pkmodes_real c_T = effects->belt_tension_stiffness_coefficient;
    const pkmodes_real F_T = effects->belt_tension_stiffness_tension;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real b_L_x = effects->payload_offset_x;
    const pkmodes_real b_L_y = effects->payload_offset_y;
    const pkmodes_real b_L_z = effects->payload_offset_z;
    const pkmodes_real t1 = (rot_x*rot_x);
    const pkmodes_real t2 = (rot_y*rot_y);
    const pkmodes_real t3 = (rot_z*rot_z);
    const pkmodes_real t4 = t2 + t3;
    const pkmodes_real half_angle = (R(1.0)/R(2.0))*R(sqrt)(t1 + t4 + R(1e-30));
    const pkmodes_real s_half = R(sin)(half_angle)/half_angle;
    const pkmodes_real t5 = (s_half*s_half);
    const pkmodes_real t6 = (R(1.0)/R(2.0))*t5;
    const pkmodes_real R_x_x = -t4*t6 + 1;
    const pkmodes_real c_half = R(cos)(half_angle);
    const pkmodes_real t7 = c_half*s_half;
    const pkmodes_real t8 = rot_z*t7;
    const pkmodes_real R_x_y = (R(1.0)/R(2.0))*rot_x*rot_y*t5 - t8;
    const pkmodes_real t9 = rot_y*t7;
    const pkmodes_real t10 = rot_x*t6;
    const pkmodes_real R_x_z = rot_z*t10 + t9;
    const pkmodes_real B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const pkmodes_real r_1_x = B_1_x - o_1_x + p_x;
    const pkmodes_real R_y_x = rot_y*t10 + t8;
    const pkmodes_real R_y_y = t6*(-t1 - t3) + 1;
    const pkmodes_real t11 = rot_x*t7;
    const pkmodes_real R_y_z = (R(1.0)/R(2.0))*rot_y*rot_z*t5 - t11;
    const pkmodes_real B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const pkmodes_real r_1_y = B_1_y - o_1_y + p_y;
    const pkmodes_real R_z_x = (R(1.0)/R(2.0))*rot_x*rot_z*t5 - t9;
    const pkmodes_real R_z_y = rot_y*rot_z*t6 + t11;
    const pkmodes_real R_z_z = t6*(-t1 - t2) + 1;
    const pkmodes_real B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const pkmodes_real r_1_z = B_1_z - o_1_z + p_z;
    const pkmodes_real B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const pkmodes_real r_2_x = B_2_x - o_2_x + p_x;
    const pkmodes_real B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const pkmodes_real r_2_y = B_2_y - o_2_y + p_y;
    const pkmodes_real B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const pkmodes_real r_2_z = B_2_z - o_2_z + p_z;
    const pkmodes_real B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const pkmodes_real r_3_x = B_3_x - o_3_x + p_x;
    const pkmodes_real B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const pkmodes_real r_3_y = B_3_y - o_3_y + p_y;
    const pkmodes_real B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const pkmodes_real r_3_z = B_3_z - o_3_z + p_z;
    const pkmodes_real B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const pkmodes_real r_4_x = B_4_x - o_4_x + p_x;
    const pkmodes_real B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const pkmodes_real r_4_y = B_4_y - o_4_y + p_y;
    const pkmodes_real B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const pkmodes_real r_4_z = B_4_z - o_4_z + p_z;
    const pkmodes_real B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const pkmodes_real r_5_x = B_5_x - o_5_x + p_x;
    const pkmodes_real B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const pkmodes_real r_5_y = B_5_y - o_5_y + p_y;
    const pkmodes_real B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const pkmodes_real r_5_z = B_5_z - o_5_z + p_z;
    const pkmodes_real B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const pkmodes_real r_6_x = B_6_x - o_6_x + p_x;
    const pkmodes_real B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const pkmodes_real r_6_y = B_6_y - o_6_y + p_y;
    const pkmodes_real B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const pkmodes_real r_6_z = B_6_z - o_6_z + p_z;
    const pkmodes_real a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z;
    const pkmodes_real w_1_x = -a_1*n_1_x + r_1_x;
    const pkmodes_real w_1_y = -a_1*n_1_y + r_1_y;
    const pkmodes_real w_1_z = -a_1*n_1_z + r_1_z;
    const pkmodes_real w2_1 = (w_1_x*w_1_x) + (w_1_y*w_1_y) + (w_1_z*w_1_z);
    const pkmodes_real x_1 = a_1 + sigma_1*R(sqrt)((l_d_1*l_d_1) - w2_1);
    const pkmodes_real a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const pkmodes_real w_2_x = -a_2*n_2_x + r_2_x;
    const pkmodes_real w_2_y = -a_2*n_2_y + r_2_y;
    const pkmodes_real w_2_z = -a_2*n_2_z + r_2_z;
    const pkmodes_real w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const pkmodes_real x_2 = a_2 + sigma_2*R(sqrt)((l_d_2*l_d_2) - w2_2);
    const pkmodes_real a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const pkmodes_real w_3_x = -a_3*n_3_x + r_3_x;
    const pkmodes_real w_3_y = -a_3*n_3_y + r_3_y;
    const pkmodes_real w_3_z = -a_3*n_3_z + r_3_z;
    const pkmodes_real w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const pkmodes_real x_3 = a_3 + sigma_3*R(sqrt)((l_d_3*l_d_3) - w2_3);
    const pkmodes_real a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z;
    const pkmodes_real w_4_x = -a_4*n_4_x + r_4_x;
    const pkmodes_real w_4_y = -a_4*n_4_y + r_4_y;
    const pkmodes_real w_4_z = -a_4*n_4_z + r_4_z;
    const pkmodes_real w2_4 = (w_4_x*w_4_x) + (w_4_y*w_4_y) + (w_4_z*w_4_z);
    const pkmodes_real x_4 = a_4 + sigma_4*R(sqrt)((l_d_4*l_d_4) - w2_4);
    const pkmodes_real a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z;
    const pkmodes_real w_5_x = -a_5*n_5_x + r_5_x;
    const pkmodes_real w_5_y = -a_5*n_5_y + r_5_y;
    const pkmodes_real w_5_z = -a_5*n_5_z + r_5_z;
    const pkmodes_real w2_5 = (w_5_x*w_5_x) + (w_5_y*w_5_y) + (w_5_z*w_5_z);
    const pkmodes_real x_5 = a_5 + sigma_5*R(sqrt)((l_d_5*l_d_5) - w2_5);
    const pkmodes_real a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z;
    const pkmodes_real w_6_x = -a_6*n_6_x + r_6_x;
    const pkmodes_real w_6_y = -a_6*n_6_y + r_6_y;
    const pkmodes_real w_6_z = -a_6*n_6_z + r_6_z;
    const pkmodes_real w2_6 = (w_6_x*w_6_x) + (w_6_y*w_6_y) + (w_6_z*w_6_z);
    const pkmodes_real x_6 = a_6 + sigma_6*R(sqrt)((l_d_6*l_d_6) - w2_6);
    const pkmodes_real s_1_x = -n_1_x*x_1 + r_1_x;
    const pkmodes_real s_1_y = -n_1_y*x_1 + r_1_y;
    const pkmodes_real s_1_z = -n_1_z*x_1 + r_1_z;
    const pkmodes_real s_2_x = -n_2_x*x_2 + r_2_x;
    const pkmodes_real s_2_y = -n_2_y*x_2 + r_2_y;
    const pkmodes_real s_2_z = -n_2_z*x_2 + r_2_z;
    const pkmodes_real s_3_x = -n_3_x*x_3 + r_3_x;
    const pkmodes_real s_3_y = -n_3_y*x_3 + r_3_y;
    const pkmodes_real s_3_z = -n_3_z*x_3 + r_3_z;
    const pkmodes_real s_4_x = -n_4_x*x_4 + r_4_x;
    const pkmodes_real s_4_y = -n_4_y*x_4 + r_4_y;
    const pkmodes_real s_4_z = -n_4_z*x_4 + r_4_z;
    const pkmodes_real s_5_x = -n_5_x*x_5 + r_5_x;
    const pkmodes_real s_5_y = -n_5_y*x_5 + r_5_y;
    const pkmodes_real s_5_z = -n_5_z*x_5 + r_5_z;
    const pkmodes_real s_6_x = -n_6_x*x_6 + r_6_x;
    const pkmodes_real s_6_y = -n_6_y*x_6 + r_6_y;
    const pkmodes_real s_6_z = -n_6_z*x_6 + r_6_z;
    const pkmodes_real c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const pkmodes_real c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const pkmodes_real c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const pkmodes_real o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const pkmodes_real o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const pkmodes_real o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const pkmodes_real D_l_1_rx = B_1_y*s_1_z - B_1_z*s_1_y;
    const pkmodes_real D_l_1_ry = -B_1_x*s_1_z + B_1_z*s_1_x;
    const pkmodes_real D_l_1_rz = B_1_x*s_1_y - B_1_y*s_1_x;
    const pkmodes_real D_l_2_rx = B_2_y*s_2_z - B_2_z*s_2_y;
    const pkmodes_real D_l_2_ry = -B_2_x*s_2_z + B_2_z*s_2_x;
    const pkmodes_real D_l_2_rz = B_2_x*s_2_y - B_2_y*s_2_x;
    const pkmodes_real D_l_3_rx = B_3_y*s_3_z - B_3_z*s_3_y;
    const pkmodes_real D_l_3_ry = -B_3_x*s_3_z + B_3_z*s_3_x;
    const pkmodes_real D_l_3_rz = B_3_x*s_3_y - B_3_y*s_3_x;
    const pkmodes_real D_l_4_rx = B_4_y*s_4_z - B_4_z*s_4_y;
    const pkmodes_real D_l_4_ry = -B_4_x*s_4_z + B_4_z*s_4_x;
    const pkmodes_real D_l_4_rz = B_4_x*s_4_y - B_4_y*s_4_x;
    const pkmodes_real D_l_5_rx = B_5_y*s_5_z - B_5_z*s_5_y;
    const pkmodes_real D_l_5_ry = -B_5_x*s_5_z + B_5_z*s_5_x;
    const pkmodes_real D_l_5_rz = B_5_x*s_5_y - B_5_y*s_5_x;
    const pkmodes_real D_l_6_rx = B_6_y*s_6_z - B_6_z*s_6_y;
    const pkmodes_real D_l_6_ry = -B_6_x*s_6_z + B_6_z*s_6_x;
    const pkmodes_real D_l_6_rz = B_6_x*s_6_y - B_6_y*s_6_x;
    const pkmodes_real D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const pkmodes_real D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const pkmodes_real D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const pkmodes_real D_r_4 = n_4_x*s_4_x + n_4_y*s_4_y + n_4_z*s_4_z;
    const pkmodes_real D_r_5 = n_5_x*s_5_x + n_5_y*s_5_y + n_5_z*s_5_z;
    const pkmodes_real D_r_6 = n_6_x*s_6_x + n_6_y*s_6_y + n_6_z*s_6_z;
    const pkmodes_real minor_23_23 = s_2_y*s_3_z - s_2_z*s_3_y;
    const pkmodes_real minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const pkmodes_real minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const pkmodes_real minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const pkmodes_real minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const pkmodes_real minor_23_24 = -D_l_2_rx*s_3_y + D_l_3_rx*s_2_y;
    const pkmodes_real minor_56_36 = -D_l_5_rz*s_6_z + D_l_6_rz*s_5_z;
    const pkmodes_real minor_56_35 = -D_l_5_ry*s_6_z + D_l_6_ry*s_5_z;
    const pkmodes_real minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + minor_56_56*s_4_z;
    const pkmodes_real minor_23_25 = -D_l_2_ry*s_3_y + D_l_3_ry*s_2_y;
    const pkmodes_real minor_56_34 = -D_l_5_rx*s_6_z + D_l_6_rx*s_5_z;
    const pkmodes_real minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + minor_56_46*s_4_z;
    const pkmodes_real minor_23_26 = -D_l_2_rz*s_3_y + D_l_3_rz*s_2_y;
    const pkmodes_real minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + minor_56_45*s_4_z;
    const pkmodes_real minor_23_34 = -D_l_2_rx*s_3_z + D_l_3_rx*s_2_z;
    const pkmodes_real minor_56_26 = -D_l_5_rz*s_6_y + D_l_6_rz*s_5_y;
    const pkmodes_real minor_56_25 = -D_l_5_ry*s_6_y + D_l_6_ry*s_5_y;
    const pkmodes_real minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + minor_56_56*s_4_y;
    const pkmodes_real minor_23_35 = -D_l_2_ry*s_3_z + D_l_3_ry*s_2_z;
    const pkmodes_real minor_56_24 = -D_l_5_rx*s_6_y + D_l_6_rx*s_5_y;
    const pkmodes_real minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + minor_56_46*s_4_y;
    const pkmodes_real minor_23_36 = -D_l_2_rz*s_3_z + D_l_3_rz*s_2_z;
    const pkmodes_real minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + minor_56_45*s_4_y;
    const pkmodes_real minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const pkmodes_real minor_56_23 = s_5_y*s_6_z - s_5_z*s_6_y;
    const pkmodes_real minor_456_236 = D_l_4_rz*minor_56_23 - minor_56_26*s_4_z + minor_56_36*s_4_y;
    const pkmodes_real minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const pkmodes_real minor_456_235 = D_l_4_ry*minor_56_23 - minor_56_25*s_4_z + minor_56_35*s_4_y;
    const pkmodes_real minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const pkmodes_real minor_456_234 = D_l_4_rx*minor_56_23 - minor_56_24*s_4_z + minor_56_34*s_4_y;
    const pkmodes_real A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const pkmodes_real minor_23_13 = s_2_x*s_3_z - s_2_z*s_3_x;
    const pkmodes_real minor_23_14 = -D_l_2_rx*s_3_x + D_l_3_rx*s_2_x;
    const pkmodes_real minor_23_15 = -D_l_2_ry*s_3_x + D_l_3_ry*s_2_x;
    const pkmodes_real minor_23_16 = -D_l_2_rz*s_3_x + D_l_3_rz*s_2_x;
    const pkmodes_real minor_56_16 = -D_l_5_rz*s_6_x + D_l_6_rz*s_5_x;
    const pkmodes_real minor_56_15 = -D_l_5_ry*s_6_x + D_l_6_ry*s_5_x;
    const pkmodes_real minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + minor_56_56*s_4_x;
    const pkmodes_real minor_56_14 = -D_l_5_rx*s_6_x + D_l_6_rx*s_5_x;
    const pkmodes_real minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + minor_56_46*s_4_x;
    const pkmodes_real minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + minor_56_45*s_4_x;
    const pkmodes_real minor_56_13 = s_5_x*s_6_z - s_5_z*s_6_x;
    const pkmodes_real minor_456_136 = D_l_4_rz*minor_56_13 - minor_56_16*s_4_z + minor_56_36*s_4_x;
    const pkmodes_real minor_456_135 = D_l_4_ry*minor_56_13 - minor_56_15*s_4_z + minor_56_35*s_4_x;
    const pkmodes_real minor_456_134 = D_l_4_rx*minor_56_13 - minor_56_14*s_4_z + minor_56_34*s_4_x;
    const pkmodes_real A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const pkmodes_real minor_23_12 = s_2_x*s_3_y - s_2_y*s_3_x;
    const pkmodes_real minor_56_12 = s_5_x*s_6_y - s_5_y*s_6_x;
    const pkmodes_real minor_456_126 = D_l_4_rz*minor_56_12 - minor_56_16*s_4_y + minor_56_26*s_4_x;
    const pkmodes_real minor_456_125 = D_l_4_ry*minor_56_12 - minor_56_15*s_4_y + minor_56_25*s_4_x;
    const pkmodes_real minor_456_124 = D_l_4_rx*minor_56_12 - minor_56_14*s_4_y + minor_56_24*s_4_x;
    const pkmodes_real A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const pkmodes_real minor_456_123 = minor_56_12*s_4_z - minor_56_13*s_4_y + minor_56_23*s_4_x;
    const pkmodes_real A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const pkmodes_real A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const pkmodes_real A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const pkmodes_real minor_13_23 = s_1_y*s_3_z - s_1_z*s_3_y;
    const pkmodes_real minor_13_24 = -D_l_1_rx*s_3_y + D_l_3_rx*s_1_y;
    const pkmodes_real minor_13_25 = -D_l_1_ry*s_3_y + D_l_3_ry*s_1_y;
    const pkmodes_real minor_13_26 = -D_l_1_rz*s_3_y + D_l_3_rz*s_1_y;
    const pkmodes_real minor_13_34 = -D_l_1_rx*s_3_z + D_l_3_rx*s_1_z;
    const pkmodes_real minor_13_35 = -D_l_1_ry*s_3_z + D_l_3_ry*s_1_z;
    const pkmodes_real minor_13_36 = -D_l_1_rz*s_3_z + D_l_3_rz*s_1_z;
    const pkmodes_real minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const pkmodes_real minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const pkmodes_real minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const pkmodes_real A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const pkmodes_real minor_13_13 = s_1_x*s_3_z - s_1_z*s_3_x;
    const pkmodes_real minor_13_14 = -D_l_1_rx*s_3_x + D_l_3_rx*s_1_x;
    const pkmodes_real minor_13_15 = -D_l_1_ry*s_3_x + D_l_3_ry*s_1_x;
    const pkmodes_real minor_13_16 = -D_l_1_rz*s_3_x + D_l_3_rz*s_1_x;
    const pkmodes_real A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const pkmodes_real minor_13_12 = s_1_x*s_3_y - s_1_y*s_3_x;
    const pkmodes_real A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const pkmodes_real A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const pkmodes_real A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const pkmodes_real A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const pkmodes_real minor_12_23 = s_1_y*s_2_z - s_1_z*s_2_y;
    const pkmodes_real minor_12_24 = -D_l_1_rx*s_2_y + D_l_2_rx*s_1_y;
    const pkmodes_real minor_12_25 = -D_l_1_ry*s_2_y + D_l_2_ry*s_1_y;
    const pkmodes_real minor_12_26 = -D_l_1_rz*s_2_y + D_l_2_rz*s_1_y;
    const pkmodes_real minor_12_34 = -D_l_1_rx*s_2_z + D_l_2_rx*s_1_z;
    const pkmodes_real minor_12_35 = -D_l_1_ry*s_2_z + D_l_2_ry*s_1_z;
    const pkmodes_real minor_12_36 = -D_l_1_rz*s_2_z + D_l_2_rz*s_1_z;
    const pkmodes_real minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const pkmodes_real minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const pkmodes_real minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const pkmodes_real A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const pkmodes_real minor_12_13 = s_1_x*s_2_z - s_1_z*s_2_x;
    const pkmodes_real minor_12_14 = -D_l_1_rx*s_2_x + D_l_2_rx*s_1_x;
    const pkmodes_real minor_12_15 = -D_l_1_ry*s_2_x + D_l_2_ry*s_1_x;
    const pkmodes_real minor_12_16 = -D_l_1_rz*s_2_x + D_l_2_rz*s_1_x;
    const pkmodes_real A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const pkmodes_real minor_12_12 = s_1_x*s_2_y - s_1_y*s_2_x;
    const pkmodes_real A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const pkmodes_real A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const pkmodes_real A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const pkmodes_real A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const pkmodes_real minor_123_234 = D_l_1_rx*minor_23_23 - minor_23_24*s_1_z + minor_23_34*s_1_y;
    const pkmodes_real minor_123_235 = D_l_1_ry*minor_23_23 - minor_23_25*s_1_z + minor_23_35*s_1_y;
    const pkmodes_real minor_123_236 = D_l_1_rz*minor_23_23 - minor_23_26*s_1_z + minor_23_36*s_1_y;
    const pkmodes_real minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + minor_23_45*s_1_y;
    const pkmodes_real minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + minor_23_46*s_1_y;
    const pkmodes_real minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + minor_23_56*s_1_y;
    const pkmodes_real minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + minor_23_45*s_1_z;
    const pkmodes_real minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + minor_23_46*s_1_z;
    const pkmodes_real minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + minor_23_56*s_1_z;
    const pkmodes_real minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const pkmodes_real A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const pkmodes_real minor_123_134 = D_l_1_rx*minor_23_13 - minor_23_14*s_1_z + minor_23_34*s_1_x;
    const pkmodes_real minor_123_135 = D_l_1_ry*minor_23_13 - minor_23_15*s_1_z + minor_23_35*s_1_x;
    const pkmodes_real minor_123_136 = D_l_1_rz*minor_23_13 - minor_23_16*s_1_z + minor_23_36*s_1_x;
    const pkmodes_real minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + minor_23_45*s_1_x;
    const pkmodes_real minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + minor_23_46*s_1_x;
    const pkmodes_real minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + minor_23_56*s_1_x;
    const pkmodes_real A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const pkmodes_real minor_123_124 = D_l_1_rx*minor_23_12 - minor_23_14*s_1_y + minor_23_24*s_1_x;
    const pkmodes_real minor_123_125 = D_l_1_ry*minor_23_12 - minor_23_15*s_1_y + minor_23_25*s_1_x;
    const pkmodes_real minor_123_126 = D_l_1_rz*minor_23_12 - minor_23_16*s_1_y + minor_23_26*s_1_x;
    const pkmodes_real A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const pkmodes_real minor_123_123 = minor_23_12*s_1_z - minor_23_13*s_1_y + minor_23_23*s_1_x;
    const pkmodes_real A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const pkmodes_real A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const pkmodes_real A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const pkmodes_real minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const pkmodes_real minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const pkmodes_real minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const pkmodes_real minor_46_36 = -D_l_4_rz*s_6_z + D_l_6_rz*s_4_z;
    const pkmodes_real minor_46_35 = -D_l_4_ry*s_6_z + D_l_6_ry*s_4_z;
    const pkmodes_real minor_46_34 = -D_l_4_rx*s_6_z + D_l_6_rx*s_4_z;
    const pkmodes_real minor_46_26 = -D_l_4_rz*s_6_y + D_l_6_rz*s_4_y;
    const pkmodes_real minor_46_25 = -D_l_4_ry*s_6_y + D_l_6_ry*s_4_y;
    const pkmodes_real minor_46_24 = -D_l_4_rx*s_6_y + D_l_6_rx*s_4_y;
    const pkmodes_real minor_46_23 = s_4_y*s_6_z - s_4_z*s_6_y;
    const pkmodes_real A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const pkmodes_real minor_46_16 = -D_l_4_rz*s_6_x + D_l_6_rz*s_4_x;
    const pkmodes_real minor_46_15 = -D_l_4_ry*s_6_x + D_l_6_ry*s_4_x;
    const pkmodes_real minor_46_14 = -D_l_4_rx*s_6_x + D_l_6_rx*s_4_x;
    const pkmodes_real minor_46_13 = s_4_x*s_6_z - s_4_z*s_6_x;
    const pkmodes_real A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const pkmodes_real minor_46_12 = s_4_x*s_6_y - s_4_y*s_6_x;
    const pkmodes_real A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const pkmodes_real A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const pkmodes_real A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const pkmodes_real A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const pkmodes_real minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const pkmodes_real minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const pkmodes_real minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const pkmodes_real minor_45_36 = -D_l_4_rz*s_5_z + D_l_5_rz*s_4_z;
    const pkmodes_real minor_45_35 = -D_l_4_ry*s_5_z + D_l_5_ry*s_4_z;
    const pkmodes_real minor_45_34 = -D_l_4_rx*s_5_z + D_l_5_rx*s_4_z;
    const pkmodes_real minor_45_26 = -D_l_4_rz*s_5_y + D_l_5_rz*s_4_y;
    const pkmodes_real minor_45_25 = -D_l_4_ry*s_5_y + D_l_5_ry*s_4_y;
    const pkmodes_real minor_45_24 = -D_l_4_rx*s_5_y + D_l_5_rx*s_4_y;
    const pkmodes_real minor_45_23 = s_4_y*s_5_z - s_4_z*s_5_y;
    const pkmodes_real A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const pkmodes_real minor_45_16 = -D_l_4_rz*s_5_x + D_l_5_rz*s_4_x;
    const pkmodes_real minor_45_15 = -D_l_4_ry*s_5_x + D_l_5_ry*s_4_x;
    const pkmodes_real minor_45_14 = -D_l_4_rx*s_5_x + D_l_5_rx*s_4_x;
    const pkmodes_real minor_45_13 = s_4_x*s_5_z - s_4_z*s_5_x;
    const pkmodes_real A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const pkmodes_real minor_45_12 = s_4_x*s_5_y - s_4_y*s_5_x;
    const pkmodes_real A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const pkmodes_real A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const pkmodes_real A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const pkmodes_real A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const pkmodes_real det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const pkmodes_real t12 = 1/det_D_l;
    const pkmodes_real t13 = D_r_1*t12;
    const pkmodes_real D_p_x_1 = A_x_1*t13;
    const pkmodes_real t14 = D_r_2*t12;
    const pkmodes_real D_p_x_2 = A_x_2*t14;
    const pkmodes_real t15 = D_r_3*t12;
    const pkmodes_real D_p_x_3 = A_x_3*t15;
    const pkmodes_real t16 = D_r_4*t12;
    const pkmodes_real D_p_x_4 = A_x_4*t16;
    const pkmodes_real t17 = D_r_5*t12;
    const pkmodes_real D_p_x_5 = A_x_5*t17;
    const pkmodes_real t18 = D_r_6*t12;
    const pkmodes_real D_p_x_6 = A_x_6*t18;
    const pkmodes_real D_p_y_1 = A_y_1*t13;
    const pkmodes_real D_p_y_2 = A_y_2*t14;
    const pkmodes_real D_p_y_3 = A_y_3*t15;
    const pkmodes_real D_p_y_4 = A_y_4*t16;
    const pkmodes_real D_p_y_5 = A_y_5*t17;
    const pkmodes_real D_p_y_6 = A_y_6*t18;
    const pkmodes_real D_p_z_1 = A_z_1*t13;
    const pkmodes_real D_p_z_2 = A_z_2*t14;
    const pkmodes_real D_p_z_3 = A_z_3*t15;
    const pkmodes_real D_p_z_4 = A_z_4*t16;
    const pkmodes_real D_p_z_5 = A_z_5*t17;
    const pkmodes_real D_p_z_6 = A_z_6*t18;
    const pkmodes_real D_p_rx_1 = A_rx_1*t13;
    const pkmodes_real D_p_rx_2 = A_rx_2*t14;
    const pkmodes_real D_p_rx_3 = A_rx_3*t15;
    const pkmodes_real D_p_rx_4 = A_rx_4*t16;
    const pkmodes_real D_p_rx_5 = A_rx_5*t17;
    const pkmodes_real D_p_rx_6 = A_rx_6*t18;
    const pkmodes_real D_p_ry_1 = A_ry_1*t13;
    const pkmodes_real D_p_ry_2 = A_ry_2*t14;
    const pkmodes_real D_p_ry_3 = A_ry_3*t15;
    const pkmodes_real D_p_ry_4 = A_ry_4*t16;
    const pkmodes_real D_p_ry_5 = A_ry_5*t17;
    const pkmodes_real D_p_ry_6 = A_ry_6*t18;
    const pkmodes_real D_p_rz_1 = A_rz_1*t13;
    const pkmodes_real D_p_rz_2 = A_rz_2*t14;
    const pkmodes_real D_p_rz_3 = A_rz_3*t15;
    const pkmodes_real D_p_rz_4 = A_rz_4*t16;
    const pkmodes_real D_p_rz_5 = A_rz_5*t17;
    const pkmodes_real D_p_rz_6 = A_rz_6*t18;
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t19 = F_T*c_T + 1;
    const pkmodes_real t20 = c_E*t19;
    const pkmodes_real t21 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t22 = t20*t21;
    const pkmodes_real t23 = t19*t21;
    const pkmodes_real k_1_1 = t23/(l_f_1_1 + t22);
    const pkmodes_real t24 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t24 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t23/(l_f_1_2 + t22);
    const pkmodes_real l_f_1_3 = -t24 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t23/(l_f_1_3 + t22);
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t25 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t26 = t20*t25;
    const pkmodes_real t27 = t19*t25;
    const pkmodes_real k_2_1 = t27/(l_f_2_1 + t26);
    const pkmodes_real t28 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t28 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t27/(l_f_2_2 + t26);
    const pkmodes_real l_f_2_3 = -t28 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t27/(l_f_2_3 + t26);
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t29 = k_sp_3*w_b_3*(a_B_3 + 1);
    const pkmodes_real t30 = t20*t29;
    const pkmodes_real t31 = t19*t29;
    const pkmodes_real k_3_1 = t31/(l_f_3_1 + t30);
    const pkmodes_real t32 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t32 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t31/(l_f_3_2 + t30);
    const pkmodes_real l_f_3_3 = -t32 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t31/(l_f_3_3 + t30);
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t33 = k_sp_4*w_b_4*(a_B_4 + 1);
    const pkmodes_real t34 = t20*t33;
    const pkmodes_real t35 = t19*t33;
    const pkmodes_real k_4_1 = t35/(l_f_4_1 + t34);
    const pkmodes_real t36 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t36 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t35/(l_f_4_2 + t34);
    const pkmodes_real l_f_4_3 = -t36 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t35/(l_f_4_3 + t34);
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t37 = k_sp_5*w_b_5*(a_B_5 + 1);
    const pkmodes_real t38 = t20*t37;
    const pkmodes_real t39 = t19*t37;
    const pkmodes_real k_5_1 = t39/(l_f_5_1 + t38);
    const pkmodes_real t40 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t40 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t39/(l_f_5_2 + t38);
    const pkmodes_real l_f_5_3 = -t40 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t39/(l_f_5_3 + t38);
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t41 = k_sp_6*w_b_6*(a_B_6 + 1);
    const pkmodes_real t42 = t20*t41;
    const pkmodes_real t43 = t19*t41;
    const pkmodes_real k_6_1 = t43/(l_f_6_1 + t42);
    const pkmodes_real t44 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t44 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t43/(l_f_6_2 + t42);
    const pkmodes_real l_f_6_3 = -t44 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t43/(l_f_6_3 + t42);
    const pkmodes_real t45 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t46 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t47 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t48 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t49 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t50 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t51 = m_L + m_p + t45 + t46 + t47 + t48 + t49 + t50;
    const pkmodes_real G_p_x = -g_x*t51;
    const pkmodes_real G_p_y = -g_y*t51;
    const pkmodes_real G_p_z = -g_z*t51;
    const pkmodes_real t52 = g_z*m_p;
    const pkmodes_real t53 = g_z*m_L;
    const pkmodes_real t54 = g_z*t45;
    const pkmodes_real t55 = g_z*t46;
    const pkmodes_real t56 = g_z*t47;
    const pkmodes_real t57 = g_z*t48;
    const pkmodes_real t58 = g_z*t49;
    const pkmodes_real t59 = g_z*t50;
    const pkmodes_real G_p_rx =
        -B_1_y*t54 + (R(1.0)/R(2.0))*B_1_z*g_y*m_d_1 - B_2_y*t55 + (R(1.0)/R(2.0))*B_2_z*g_y*m_d_2
        - B_3_y*t56 + (R(1.0)/R(2.0))*B_3_z*g_y*m_d_3 - B_4_y*t57 + (R(1.0)/R(2.0))*B_4_z*g_y*m_d_4
        - B_5_y*t58 + (R(1.0)/R(2.0))*B_5_z*g_y*m_d_5 - B_6_y*t59 + (R(1.0)/R(2.0))*B_6_z*g_y*m_d_6 - c_y*t52
        + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t53;
    const pkmodes_real G_p_ry =
        B_1_x*t54 - B_1_z*g_x*t45 + B_2_x*t55 - B_2_z*g_x*t46 + B_3_x*t56 - B_3_z*g_x*t47 + B_4_x*t57
        - B_4_z*g_x*t48 + B_5_x*t58 - B_5_z*g_x*t49 + B_6_x*t59 - B_6_z*g_x*t50 + c_x*t52 - c_z*g_x*m_p
        - g_x*m_L*o_L_z + o_L_x*t53;
    const pkmodes_real G_p_rz =
        -B_1_x*g_y*t45 + (R(1.0)/R(2.0))*B_1_y*g_x*m_d_1 - B_2_x*g_y*t46 + (R(1.0)/R(2.0))*B_2_y*g_x*m_d_2
        - B_3_x*g_y*t47 + (R(1.0)/R(2.0))*B_3_y*g_x*m_d_3 - B_4_x*g_y*t48 + (R(1.0)/R(2.0))*B_4_y*g_x*m_d_4
        - B_5_x*g_y*t49 + (R(1.0)/R(2.0))*B_5_y*g_x*m_d_5 - B_6_x*g_y*t50 + (R(1.0)/R(2.0))*B_6_y*g_x*m_d_6
        - c_x*g_y*m_p + c_y*g_x*m_p + g_x*m_L*o_L_y - g_y*m_L*o_L_x;
    const pkmodes_real G_1 =
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - g_x*(m_t_1*n_1_x + n_1_x*t45) - g_y*(m_t_1*n_1_y + n_1_y*t45) - g_z*(m_t_1*n_1_z + n_1_z*t45);
    const pkmodes_real G_2 =
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - g_x*(m_t_2*n_2_x + n_2_x*t46) - g_y*(m_t_2*n_2_y + n_2_y*t46) - g_z*(m_t_2*n_2_z + n_2_z*t46);
    const pkmodes_real G_3 =
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - g_x*(m_t_3*n_3_x + n_3_x*t47) - g_y*(m_t_3*n_3_y + n_3_y*t47) - g_z*(m_t_3*n_3_z + n_3_z*t47);
    const pkmodes_real G_4 =
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - g_x*(m_t_4*n_4_x + n_4_x*t48) - g_y*(m_t_4*n_4_y + n_4_y*t48) - g_z*(m_t_4*n_4_z + n_4_z*t48);
    const pkmodes_real G_5 =
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - g_x*(m_t_5*n_5_x + n_5_x*t49) - g_y*(m_t_5*n_5_y + n_5_y*t49) - g_z*(m_t_5*n_5_z + n_5_z*t49);
    const pkmodes_real G_6 =
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - g_x*(m_t_6*n_6_x + n_6_x*t50) - g_y*(m_t_6*n_6_y + n_6_y*t50) - g_z*(m_t_6*n_6_z + n_6_z*t50);
    const pkmodes_real t60 = (R_p_1*R_p_1);
    const pkmodes_real t61 = k_1_1*t60;
    const pkmodes_real t62 = k_1_3*t60;
    const pkmodes_real t63 = -d_1_1*t61 + d_1_2*(t61 + t62);
    const pkmodes_real t64 = k_1_2*t60;
    const pkmodes_real t65 = d_1_1*(t61 + t64) - d_1_2*t61;
    const pkmodes_real det_1 = R_p_1*k_1_2*t63 - R_p_1*k_1_3*t65;
    const pkmodes_real t66 = G_1/det_1;
    const pkmodes_real theta_1_1_st = -t65*t66;
    const pkmodes_real theta_1_2_st = t63*t66;
    const pkmodes_real t67 = (R_p_2*R_p_2);
    const pkmodes_real t68 = k_2_1*t67;
    const pkmodes_real t69 = k_2_3*t67;
    const pkmodes_real t70 = -d_2_1*t68 + d_2_2*(t68 + t69);
    const pkmodes_real t71 = k_2_2*t67;
    const pkmodes_real t72 = d_2_1*(t68 + t71) - d_2_2*t68;
    const pkmodes_real det_2 = R_p_2*k_2_2*t70 - R_p_2*k_2_3*t72;
    const pkmodes_real t73 = G_2/det_2;
    const pkmodes_real theta_2_1_st = -t72*t73;
    const pkmodes_real theta_2_2_st = t70*t73;
    const pkmodes_real t74 = (R_p_3*R_p_3);
    const pkmodes_real t75 = k_3_1*t74;
    const pkmodes_real t76 = k_3_3*t74;
    const pkmodes_real t77 = -d_3_1*t75 + d_3_2*(t75 + t76);
    const pkmodes_real t78 = k_3_2*t74;
    const pkmodes_real t79 = d_3_1*(t75 + t78) - d_3_2*t75;
    const pkmodes_real det_3 = R_p_3*k_3_2*t77 - R_p_3*k_3_3*t79;
    const pkmodes_real t80 = G_3/det_3;
    const pkmodes_real theta_3_1_st = -t79*t80;
    const pkmodes_real theta_3_2_st = t77*t80;
    const pkmodes_real t81 = (R_p_4*R_p_4);
    const pkmodes_real t82 = k_4_3*t81;
    const pkmodes_real t83 = k_4_1*t81;
    const pkmodes_real t84 = -d_4_1*t83 + d_4_2*(t82 + t83);
    const pkmodes_real t85 = k_4_2*t81;
    const pkmodes_real t86 = d_4_1*(t83 + t85) - d_4_2*t83;
    const pkmodes_real det_4 = R_p_4*k_4_2*t84 - R_p_4*k_4_3*t86;
    const pkmodes_real t87 = G_4/det_4;
    const pkmodes_real theta_4_1_st = -t86*t87;
    const pkmodes_real theta_4_2_st = t84*t87;
    const pkmodes_real t88 = (R_p_5*R_p_5);
    const pkmodes_real t89 = k_5_1*t88;
    const pkmodes_real t90 = k_5_3*t88;
    const pkmodes_real t91 = -d_5_1*t89 + d_5_2*(t89 + t90);
    const pkmodes_real t92 = k_5_2*t88;
    const pkmodes_real t93 = d_5_1*(t89 + t92) - d_5_2*t89;
    const pkmodes_real det_5 = R_p_5*k_5_2*t91 - R_p_5*k_5_3*t93;
    const pkmodes_real t94 = G_5/det_5;
    const pkmodes_real theta_5_1_st = -t93*t94;
    const pkmodes_real theta_5_2_st = t91*t94;
    const pkmodes_real t95 = (R_p_6*R_p_6);
    const pkmodes_real t96 = k_6_1*t95;
    const pkmodes_real t97 = k_6_3*t95;
    const pkmodes_real t98 = -d_6_1*t96 + d_6_2*(t96 + t97);
    const pkmodes_real t99 = k_6_2*t95;
    const pkmodes_real t100 = d_6_1*(t96 + t99) - d_6_2*t96;
    const pkmodes_real det_6 = R_p_6*k_6_2*t98 - R_p_6*k_6_3*t100;
    const pkmodes_real t101 = G_6/det_6;
    const pkmodes_real theta_6_1_st = -t100*t101;
    const pkmodes_real theta_6_2_st = t101*t98;
    const pkmodes_real t102 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st);
    const pkmodes_real tau_st_1 = d_1_1*(-t102 + t62*theta_1_1_st) + d_1_2*(t102 + t64*theta_1_2_st);
    const pkmodes_real t103 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st);
    const pkmodes_real tau_st_2 = d_2_1*(-t103 + t69*theta_2_1_st) + d_2_2*(t103 + t71*theta_2_2_st);
    const pkmodes_real t104 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st);
    const pkmodes_real tau_st_3 = d_3_1*(-t104 + t76*theta_3_1_st) + d_3_2*(t104 + t78*theta_3_2_st);
    const pkmodes_real t105 = R_p_4*k_4_1*(-R_p_4*theta_4_1_st + R_p_4*theta_4_2_st);
    const pkmodes_real tau_st_4 = d_4_1*(-t105 + t82*theta_4_1_st) + d_4_2*(t105 + t85*theta_4_2_st);
    const pkmodes_real t106 = R_p_5*k_5_1*(-R_p_5*theta_5_1_st + R_p_5*theta_5_2_st);
    const pkmodes_real tau_st_5 = d_5_1*(-t106 + t90*theta_5_1_st) + d_5_2*(t106 + t92*theta_5_2_st);
    const pkmodes_real t107 = R_p_6*k_6_1*(-R_p_6*theta_6_1_st + R_p_6*theta_6_2_st);
    const pkmodes_real tau_st_6 = d_6_1*(-t107 + t97*theta_6_1_st) + d_6_2*(t107 + t99*theta_6_2_st);
    tau_st[0] = tau_st_1;
    tau_st[1] = tau_st_2;
    tau_st[2] = tau_st_3;
    tau_st[3] = tau_st_4;
    tau_st[4] = tau_st_5;
    tau_st[5] = tau_st_6;
    theta_st[0] = theta_1_1_st;
    theta_st[1] = theta_2_1_st;
    theta_st[2] = theta_3_1_st;
    theta_st[3] = theta_4_1_st;
    theta_st[4] = theta_5_1_st;
    theta_st[5] = theta_6_1_st;
    theta_st[6] = theta_1_2_st;
    theta_st[7] = theta_2_2_st;
    theta_st[8] = theta_3_2_st;
    theta_st[9] = theta_4_2_st;
    theta_st[10] = theta_5_2_st;
    theta_st[11] = theta_6_2_st;
}
