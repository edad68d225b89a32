/* Generated from the derivation of linear_delta and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism linear_delta with effects: extended matrices and sensitivities.
 * The header describes every function.
 *
 * Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; belt span s; component i = x,
 * y, z.  t1, t2, ... are subexpressions shared by several values.
 *   x_j [m]: position of carriage j along its rail
 *   r_j_i [m]: platform joint j relative to the origin of rail j, component i
 *   s_j_i [m]: linkage vector j, from carriage to platform joint, component i
 *   a_j [m]: coordinate of platform joint j along rail j
 *   w_j_i [m]: vector from rail j to platform joint j, perpendicular to it, component i
 *   w2_j [m^2]: squared distance of platform joint j from rail j
 *   tau_st_j [N m]: static torque on the driven pulley of axis j
 *   I_j_k [kg m^2]: moment of inertia of pulley k of axis j, including the motor if it is driven
 *   l_f_j_s [m]: free length of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
 *     carriage to pulley 1)
 *   k_j_s [N/m]: stiffness of span s of belt j (1 between the pulleys, 2 from carriage to pulley 2, 3 from
 *     carriage to pulley 1)
 *   D_r_j [m]: entry of D_r for axis j: component of linkage vector along the motion of its joint
 *   A_i_j [m^2]: adjugate of D_l, entry i, j
 *   det_D_l [m^3]: determinant of D_l
 *   D_p_i_k [1]: platform Jacobian, dp_i/dx_k
 *   D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
 *   U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 *   G_j [N]: gradient of the gravitational potential energy with respect to x_j
 *   det_j [N^2 m]: determinant of the equilibrium equations of axis j
 *   theta_j_k_st [rad]: static rotation of pulley k of axis j, relative to the unstrained transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "linear_delta_extended.h"

#include <math.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void linear_delta_extended_extended_matrices(const pkmodes_real p[3],
    const linear_delta_parameters *parameters, const linear_delta_effects *effects, pkmodes_real M[21][21],
    pkmodes_real K_el[21][21], pkmodes_real K_g[21][21])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real m_p = parameters->platform_mass;
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
    const pkmodes_real n_1_x = parameters->direction[0][0];
    const pkmodes_real n_1_y = parameters->direction[0][1];
    const pkmodes_real n_1_z = parameters->direction[0][2];
    const pkmodes_real n_2_x = parameters->direction[1][0];
    const pkmodes_real n_2_y = parameters->direction[1][1];
    const pkmodes_real n_2_z = parameters->direction[1][2];
    const pkmodes_real n_3_x = parameters->direction[2][0];
    const pkmodes_real n_3_y = parameters->direction[2][1];
    const pkmodes_real n_3_z = parameters->direction[2][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real m_t_1 = parameters->carriage_mass[0];
    const pkmodes_real m_t_2 = parameters->carriage_mass[1];
    const pkmodes_real m_t_3 = parameters->carriage_mass[2];
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real k_sp_3 = parameters->belt_specific_stiffness[2];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real w_b_3 = parameters->belt_width[2];
    const pkmodes_real R_p_1 = parameters->pulley_radius[0];
    const pkmodes_real R_p_2 = parameters->pulley_radius[1];
    const pkmodes_real R_p_3 = parameters->pulley_radius[2];
    const pkmodes_real I_p_1 = parameters->pulley_inertia[0];
    const pkmodes_real I_p_2 = parameters->pulley_inertia[1];
    const pkmodes_real I_p_3 = parameters->pulley_inertia[2];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real I_m_3 = parameters->motor_inertia[2];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real i_g_3 = parameters->gear_ratio[2];
    const pkmodes_real d_1_1 = parameters->drive[0][0];
    const pkmodes_real d_1_2 = parameters->drive[0][1];
    const pkmodes_real d_2_1 = parameters->drive[1][0];
    const pkmodes_real d_2_2 = parameters->drive[1][1];
    const pkmodes_real d_3_1 = parameters->drive[2][0];
    const pkmodes_real d_3_2 = parameters->drive[2][1];
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real a_B_1 = effects->axis_belt_stiffness_factor_1;
    const pkmodes_real a_B_2 = effects->axis_belt_stiffness_factor_2;
    const pkmodes_real a_B_3 = effects->axis_belt_stiffness_factor_3;
    const pkmodes_real c_E = effects->belt_end_compliance_compliance;
    const pkmodes_real rho_b = effects->belt_mass_linear_density;
    const pkmodes_real c_T = effects->belt_tension_stiffness_coefficient;
    const pkmodes_real F_T = effects->belt_tension_stiffness_tension;
    const pkmodes_real k_C = effects->cable_stiffness_stiffness;
    const pkmodes_real I_G = effects->gearbox_inertia_inertia;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real k_S = effects->servo_stiffness_stiffness;
    const pkmodes_real m_F = effects->frame_compliance_mass;
    const pkmodes_real r_1_x = b_1_x - o_1_x + p_x;
    const pkmodes_real r_1_y = b_1_y - o_1_y + p_y;
    const pkmodes_real r_1_z = b_1_z - o_1_z + p_z;
    const pkmodes_real r_2_x = b_2_x - o_2_x + p_x;
    const pkmodes_real r_2_y = b_2_y - o_2_y + p_y;
    const pkmodes_real r_2_z = b_2_z - o_2_z + p_z;
    const pkmodes_real r_3_x = b_3_x - o_3_x + p_x;
    const pkmodes_real r_3_y = b_3_y - o_3_y + p_y;
    const pkmodes_real r_3_z = b_3_z - o_3_z + p_z;
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
    const pkmodes_real s_1_x = -n_1_x*x_1 + r_1_x;
    const pkmodes_real s_1_y = -n_1_y*x_1 + r_1_y;
    const pkmodes_real s_1_z = -n_1_z*x_1 + r_1_z;
    const pkmodes_real s_2_x = -n_2_x*x_2 + r_2_x;
    const pkmodes_real s_2_y = -n_2_y*x_2 + r_2_y;
    const pkmodes_real s_2_z = -n_2_z*x_2 + r_2_z;
    const pkmodes_real s_3_x = -n_3_x*x_3 + r_3_x;
    const pkmodes_real s_3_y = -n_3_y*x_3 + r_3_y;
    const pkmodes_real s_3_z = -n_3_z*x_3 + r_3_z;
    const pkmodes_real D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const pkmodes_real D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const pkmodes_real D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const pkmodes_real A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y;
    const pkmodes_real A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x;
    const pkmodes_real A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x;
    const pkmodes_real A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y;
    const pkmodes_real A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x;
    const pkmodes_real A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x;
    const pkmodes_real A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y;
    const pkmodes_real A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x;
    const pkmodes_real A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x;
    const pkmodes_real det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const pkmodes_real t1 = 1/det_D_l;
    const pkmodes_real t2 = A_x_1*t1;
    const pkmodes_real D_p_x_1 = D_r_1*t2;
    const pkmodes_real t3 = A_x_2*t1;
    const pkmodes_real D_p_x_2 = D_r_2*t3;
    const pkmodes_real t4 = A_x_3*t1;
    const pkmodes_real D_p_x_3 = D_r_3*t4;
    const pkmodes_real D_delta_x_1 = l_d_1*t2;
    const pkmodes_real D_delta_x_2 = l_d_2*t3;
    const pkmodes_real D_delta_x_3 = l_d_3*t4;
    const pkmodes_real t5 = A_y_1*t1;
    const pkmodes_real D_p_y_1 = D_r_1*t5;
    const pkmodes_real t6 = A_y_2*t1;
    const pkmodes_real D_p_y_2 = D_r_2*t6;
    const pkmodes_real t7 = A_y_3*t1;
    const pkmodes_real D_p_y_3 = D_r_3*t7;
    const pkmodes_real D_delta_y_1 = l_d_1*t5;
    const pkmodes_real D_delta_y_2 = l_d_2*t6;
    const pkmodes_real D_delta_y_3 = l_d_3*t7;
    const pkmodes_real t8 = A_z_1*t1;
    const pkmodes_real D_p_z_1 = D_r_1*t8;
    const pkmodes_real t9 = A_z_2*t1;
    const pkmodes_real D_p_z_2 = D_r_2*t9;
    const pkmodes_real t10 = A_z_3*t1;
    const pkmodes_real D_p_z_3 = D_r_3*t10;
    const pkmodes_real D_delta_z_1 = l_d_1*t8;
    const pkmodes_real D_delta_z_2 = l_d_2*t9;
    const pkmodes_real D_delta_z_3 = l_d_3*t10;
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real t11 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real t12 = I_G + t11;
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t12;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t12;
    const pkmodes_real t13 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real t14 = I_G + t13;
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t14;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t14;
    const pkmodes_real t15 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real t16 = I_G + t15;
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t16;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t16;
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t17 = F_T*c_T + 1;
    const pkmodes_real t18 = c_E*t17;
    const pkmodes_real t19 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t20 = t18*t19;
    const pkmodes_real t21 = t17*t19;
    const pkmodes_real k_1_1 = t21/(l_f_1_1 + t20);
    const pkmodes_real t22 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t22 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t21/(l_f_1_2 + t20);
    const pkmodes_real l_f_1_3 = -t22 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t21/(l_f_1_3 + t20);
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t23 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t24 = t18*t23;
    const pkmodes_real t25 = t17*t23;
    const pkmodes_real k_2_1 = t25/(l_f_2_1 + t24);
    const pkmodes_real t26 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t26 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t25/(l_f_2_2 + t24);
    const pkmodes_real l_f_2_3 = -t26 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t25/(l_f_2_3 + t24);
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t27 = k_sp_3*w_b_3*(a_B_3 + 1);
    const pkmodes_real t28 = t18*t27;
    const pkmodes_real t29 = t17*t27;
    const pkmodes_real k_3_1 = t29/(l_f_3_1 + t28);
    const pkmodes_real t30 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t30 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t29/(l_f_3_2 + t28);
    const pkmodes_real l_f_3_3 = -t30 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t29/(l_f_3_3 + t28);
    const pkmodes_real t31 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t32 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t33 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t34 = m_L + m_p;
    const pkmodes_real t35 = t31 + t32 + t33 + t34;
    const pkmodes_real t36 = g_x*t35;
    const pkmodes_real t37 = g_y*t35;
    const pkmodes_real t38 = g_z*t35;
    const pkmodes_real mu_1 = t1*(-A_x_1*t36 - A_y_1*t37 - A_z_1*t38);
    const pkmodes_real mu_2 = t1*(-A_x_2*t36 - A_y_2*t37 - A_z_2*t38);
    const pkmodes_real mu_3 = t1*(-A_x_3*t36 - A_y_3*t37 - A_z_3*t38);
    const pkmodes_real t39 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t40 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t41 = n_1_x*t40;
    const pkmodes_real t42 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t43 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t44 = t34 + t39 + t42 + t43;
    const pkmodes_real t45 = D_p_x_1*t44;
    const pkmodes_real t46 = t41 + t45;
    const pkmodes_real t47 = n_1_y*t40;
    const pkmodes_real t48 = D_p_y_1*t44;
    const pkmodes_real t49 = t47 + t48;
    const pkmodes_real t50 = n_1_z*t40;
    const pkmodes_real t51 = D_p_z_1*t44;
    const pkmodes_real t52 = t50 + t51;
    const pkmodes_real t53 = (R(1.0)/R(3.0))*rho_b;
    const pkmodes_real t54 = l_f_1_2*t53;
    const pkmodes_real t55 = l_f_1_3*t53;
    const pkmodes_real t56 = t54 + t55;
    const pkmodes_real t57 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t58 = n_2_x*t57;
    const pkmodes_real t59 = n_2_y*t57;
    const pkmodes_real t60 = n_2_z*t57;
    const pkmodes_real t61 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t62 = n_3_x*t61;
    const pkmodes_real t63 = n_3_y*t61;
    const pkmodes_real t64 = n_3_z*t61;
    const pkmodes_real t65 = (R(1.0)/R(6.0))*rho_b;
    const pkmodes_real t66 = R_p_1*t65;
    const pkmodes_real t67 = l_f_1_3*t66;
    const pkmodes_real t68 = l_f_1_2*t66;
    const pkmodes_real t69 = t40 + t57 + t61;
    const pkmodes_real t70 = D_p_x_2*t44;
    const pkmodes_real t71 = t58 + t70;
    const pkmodes_real t72 = D_p_y_2*t44;
    const pkmodes_real t73 = t59 + t72;
    const pkmodes_real t74 = D_p_z_2*t44;
    const pkmodes_real t75 = t60 + t74;
    const pkmodes_real t76 = l_f_2_2*t53;
    const pkmodes_real t77 = l_f_2_3*t53;
    const pkmodes_real t78 = t76 + t77;
    const pkmodes_real t79 = R_p_2*t65;
    const pkmodes_real t80 = l_f_2_3*t79;
    const pkmodes_real t81 = l_f_2_2*t79;
    const pkmodes_real t82 = D_p_x_3*t44;
    const pkmodes_real t83 = t62 + t82;
    const pkmodes_real t84 = D_p_y_3*t44;
    const pkmodes_real t85 = t63 + t84;
    const pkmodes_real t86 = D_p_z_3*t44;
    const pkmodes_real t87 = t64 + t86;
    const pkmodes_real t88 = l_f_3_2*t53;
    const pkmodes_real t89 = l_f_3_3*t53;
    const pkmodes_real t90 = t88 + t89;
    const pkmodes_real t91 = R_p_3*t65;
    const pkmodes_real t92 = l_f_3_3*t91;
    const pkmodes_real t93 = l_f_3_2*t91;
    const pkmodes_real t94 = (R_p_1*R_p_1);
    const pkmodes_real t95 = l_f_1_1*t94;
    const pkmodes_real t96 = t53*t95;
    const pkmodes_real t97 = d_1_1*t11;
    const pkmodes_real t98 = (R_p_2*R_p_2);
    const pkmodes_real t99 = l_f_2_1*t98;
    const pkmodes_real t100 = t53*t99;
    const pkmodes_real t101 = d_2_1*t13;
    const pkmodes_real t102 = (R_p_3*R_p_3);
    const pkmodes_real t103 = l_f_3_1*t102;
    const pkmodes_real t104 = t103*t53;
    const pkmodes_real t105 = d_3_1*t15;
    const pkmodes_real t106 = d_1_2*t11;
    const pkmodes_real t107 = d_2_2*t13;
    const pkmodes_real t108 = d_3_2*t15;
    const pkmodes_real t109 = (D_delta_x_1*D_delta_x_1);
    const pkmodes_real t110 = (D_delta_y_1*D_delta_y_1);
    const pkmodes_real t111 = (D_delta_z_1*D_delta_z_1);
    const pkmodes_real t112 = D_delta_x_1*t44;
    const pkmodes_real t113 = D_delta_y_1*t44;
    const pkmodes_real t114 = D_delta_z_1*t44;
    const pkmodes_real t115 = (D_delta_x_2*D_delta_x_2);
    const pkmodes_real t116 = (D_delta_y_2*D_delta_y_2);
    const pkmodes_real t117 = (D_delta_z_2*D_delta_z_2);
    const pkmodes_real t118 = D_delta_x_2*t44;
    const pkmodes_real t119 = D_delta_y_2*t44;
    const pkmodes_real t120 = D_delta_z_2*t44;
    const pkmodes_real t121 = (D_delta_x_3*D_delta_x_3);
    const pkmodes_real t122 = (D_delta_y_3*D_delta_y_3);
    const pkmodes_real t123 = (D_delta_z_3*D_delta_z_3);
    const pkmodes_real t124 = m_F + m_d_1 + m_d_2 + m_d_3 + m_t_1 + m_t_2 + m_t_3 + t34;
    const pkmodes_real t125 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t126 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t127 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t128 = k_1_2 + k_1_3;
    const pkmodes_real t129 = D_p_x_1*k_C;
    const pkmodes_real t130 = D_p_y_1*k_C;
    const pkmodes_real t131 = D_p_z_1*k_C;
    const pkmodes_real t132 = -R_p_1*k_1_3;
    const pkmodes_real t133 = -R_p_1*k_1_2;
    const pkmodes_real t134 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t135 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t136 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t137 = k_2_2 + k_2_3;
    const pkmodes_real t138 = D_p_x_2*k_C;
    const pkmodes_real t139 = D_p_y_2*k_C;
    const pkmodes_real t140 = D_p_z_2*k_C;
    const pkmodes_real t141 = -R_p_2*k_2_3;
    const pkmodes_real t142 = -R_p_2*k_2_2;
    const pkmodes_real t143 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t144 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t145 = (D_p_z_3*D_p_z_3);
    const pkmodes_real t146 = k_3_2 + k_3_3;
    const pkmodes_real t147 = -R_p_3*k_3_3;
    const pkmodes_real t148 = -R_p_3*k_3_2;
    const pkmodes_real t149 = D_p_x_3*k_C;
    const pkmodes_real t150 = D_p_y_3*k_C;
    const pkmodes_real t151 = D_p_z_3*k_C;
    const pkmodes_real t152 = d_1_1*k_S;
    const pkmodes_real t153 = k_1_1*t94;
    const pkmodes_real t154 = d_2_1*k_S;
    const pkmodes_real t155 = k_2_1*t98;
    const pkmodes_real t156 = d_3_1*k_S;
    const pkmodes_real t157 = k_3_1*t102;
    const pkmodes_real t158 = d_1_2*k_S;
    const pkmodes_real t159 = d_2_2*k_S;
    const pkmodes_real t160 = d_3_2*k_S;
    const pkmodes_real t161 = D_delta_x_1*k_C;
    const pkmodes_real t162 = D_delta_y_1*k_C;
    const pkmodes_real t163 = D_delta_z_1*k_C;
    const pkmodes_real t164 = D_delta_x_2*k_C;
    const pkmodes_real t165 = D_delta_y_2*k_C;
    const pkmodes_real t166 = D_delta_z_2*k_C;
    const pkmodes_real t167 = D_p_x_1*mu_3;
    const pkmodes_real t168 = D_p_x_1*mu_2;
    const pkmodes_real t169 = U_1_x_1*mu_1;
    const pkmodes_real t170 = D_p_y_1*mu_3;
    const pkmodes_real t171 = D_p_y_1*mu_2;
    const pkmodes_real t172 = U_1_y_1*mu_1;
    const pkmodes_real t173 = D_p_z_1*mu_3;
    const pkmodes_real t174 = D_p_z_1*mu_2;
    const pkmodes_real t175 = U_1_z_1*mu_1;
    const pkmodes_real t176 = D_p_x_2*mu_1;
    const pkmodes_real t177 = D_p_x_2*mu_3;
    const pkmodes_real t178 = U_2_x_2*mu_2;
    const pkmodes_real t179 = D_p_y_2*mu_1;
    const pkmodes_real t180 = D_p_y_2*mu_3;
    const pkmodes_real t181 = U_2_y_2*mu_2;
    const pkmodes_real t182 = D_p_z_2*mu_1;
    const pkmodes_real t183 = D_p_z_2*mu_3;
    const pkmodes_real t184 = U_2_z_2*mu_2;
    const pkmodes_real t185 = D_delta_x_1*D_p_x_3;
    const pkmodes_real t186 = U_3_x_3*mu_3;
    const pkmodes_real t187 = D_delta_y_1*D_p_y_3;
    const pkmodes_real t188 = U_3_y_3*mu_3;
    const pkmodes_real t189 = D_delta_z_1*D_p_z_3;
    const pkmodes_real t190 = U_3_z_3*mu_3;
    const pkmodes_real t191 = D_delta_x_2*D_p_x_3;
    const pkmodes_real t192 = D_delta_y_2*D_p_y_3;
    const pkmodes_real t193 = D_delta_z_2*D_p_z_3;
    const pkmodes_real t194 = D_delta_x_3*D_p_x_3;
    const pkmodes_real t195 = D_delta_y_3*D_p_y_3;
    const pkmodes_real t196 = D_delta_z_3*D_p_z_3;
    const pkmodes_real t197 = D_delta_x_1*D_delta_x_2;
    const pkmodes_real t198 = D_delta_y_1*D_delta_y_2;
    const pkmodes_real t199 = D_delta_z_1*D_delta_z_2;
    const pkmodes_real t200 = D_delta_x_1*D_delta_x_3;
    const pkmodes_real t201 = D_delta_y_1*D_delta_y_3;
    const pkmodes_real t202 = D_delta_z_1*D_delta_z_3;
    const pkmodes_real t203 = D_delta_x_2*D_delta_x_3;
    const pkmodes_real t204 = D_delta_y_2*D_delta_y_3;
    const pkmodes_real t205 = D_delta_z_2*D_delta_z_3;
    memset(M, 0, sizeof(pkmodes_real[21][21]));
    M[0][0] =
        D_p_x_1*t41 + D_p_x_1*t46 + D_p_y_1*t47 + D_p_y_1*t49 + D_p_z_1*t50 + D_p_z_1*t52 + m_t_1 + t39 + t56;
    M[0][1] = M[1][0] = D_p_x_1*t58 + D_p_x_2*t46 + D_p_y_1*t59 + D_p_y_2*t49 + D_p_z_1*t60 + D_p_z_2*t52;
    M[0][2] = M[2][0] = D_p_x_1*t62 + D_p_x_3*t46 + D_p_y_1*t63 + D_p_y_3*t49 + D_p_z_1*t64 + D_p_z_3*t52;
    M[0][3] = M[3][0] = t67;
    M[0][6] = M[6][0] = t68;
    M[0][12] = M[12][0] = D_delta_x_1*t46 + D_delta_y_1*t49 + D_delta_z_1*t52;
    M[0][13] = M[13][0] = D_delta_x_2*t46 + D_delta_y_2*t49 + D_delta_z_2*t52;
    M[0][14] = M[14][0] = D_delta_x_3*t46 + D_delta_y_3*t49 + D_delta_z_3*t52;
    M[0][15] = M[15][0] = t56;
    M[0][18] = M[18][0] = D_p_x_1*t69 + m_t_1*n_1_x + n_1_x*t31 + t45;
    M[0][19] = M[19][0] = D_p_y_1*t69 + m_t_1*n_1_y + n_1_y*t31 + t48;
    M[0][20] = M[20][0] = D_p_z_1*t69 + m_t_1*n_1_z + n_1_z*t31 + t51;
    M[1][1] =
        D_p_x_2*t58 + D_p_x_2*t71 + D_p_y_2*t59 + D_p_y_2*t73 + D_p_z_2*t60 + D_p_z_2*t75 + m_t_2 + t42 + t78;
    M[1][2] = M[2][1] = D_p_x_2*t62 + D_p_x_3*t71 + D_p_y_2*t63 + D_p_y_3*t73 + D_p_z_2*t64 + D_p_z_3*t75;
    M[1][4] = M[4][1] = t80;
    M[1][7] = M[7][1] = t81;
    M[1][12] = M[12][1] = D_delta_x_1*t71 + D_delta_y_1*t73 + D_delta_z_1*t75;
    M[1][13] = M[13][1] = D_delta_x_2*t71 + D_delta_y_2*t73 + D_delta_z_2*t75;
    M[1][14] = M[14][1] = D_delta_x_3*t71 + D_delta_y_3*t73 + D_delta_z_3*t75;
    M[1][16] = M[16][1] = t78;
    M[1][18] = M[18][1] = D_p_x_2*t69 + m_t_2*n_2_x + n_2_x*t32 + t70;
    M[1][19] = M[19][1] = D_p_y_2*t69 + m_t_2*n_2_y + n_2_y*t32 + t72;
    M[1][20] = M[20][1] = D_p_z_2*t69 + m_t_2*n_2_z + n_2_z*t32 + t74;
    M[2][2] =
        D_p_x_3*t62 + D_p_x_3*t83 + D_p_y_3*t63 + D_p_y_3*t85 + D_p_z_3*t64 + D_p_z_3*t87 + m_t_3 + t43 + t90;
    M[2][5] = M[5][2] = t92;
    M[2][8] = M[8][2] = t93;
    M[2][12] = M[12][2] = D_delta_x_1*t83 + D_delta_y_1*t85 + D_delta_z_1*t87;
    M[2][13] = M[13][2] = D_delta_x_2*t83 + D_delta_y_2*t85 + D_delta_z_2*t87;
    M[2][14] = M[14][2] = D_delta_x_3*t83 + D_delta_y_3*t85 + D_delta_z_3*t87;
    M[2][17] = M[17][2] = t90;
    M[2][18] = M[18][2] = D_p_x_3*t69 + m_t_3*n_3_x + n_3_x*t33 + t82;
    M[2][19] = M[19][2] = D_p_y_3*t69 + m_t_3*n_3_y + n_3_y*t33 + t84;
    M[2][20] = M[20][2] = D_p_z_3*t69 + m_t_3*n_3_z + n_3_z*t33 + t86;
    M[3][3] = I_1_1 + t55*t94 + t96;
    M[3][6] = M[6][3] = t65*t95;
    M[3][9] = M[9][3] = t97;
    M[3][15] = M[15][3] = t67;
    M[4][4] = I_2_1 + t100 + t77*t98;
    M[4][7] = M[7][4] = t65*t99;
    M[4][10] = M[10][4] = t101;
    M[4][16] = M[16][4] = t80;
    M[5][5] = I_3_1 + t102*t89 + t104;
    M[5][8] = M[8][5] = t103*t65;
    M[5][11] = M[11][5] = t105;
    M[5][17] = M[17][5] = t92;
    M[6][6] = I_1_2 + t54*t94 + t96;
    M[6][9] = M[9][6] = t106;
    M[6][15] = M[15][6] = t68;
    M[7][7] = I_2_2 + t100 + t76*t98;
    M[7][10] = M[10][7] = t107;
    M[7][16] = M[16][7] = t81;
    M[8][8] = I_3_2 + t102*t88 + t104;
    M[8][11] = M[11][8] = t108;
    M[8][17] = M[17][8] = t93;
    M[9][9] = t106 + t97;
    M[10][10] = t101 + t107;
    M[11][11] = t105 + t108;
    M[12][12] = t109*t44 + t110*t44 + t111*t44;
    M[12][13] = M[13][12] = D_delta_x_2*t112 + D_delta_y_2*t113 + D_delta_z_2*t114;
    M[12][14] = M[14][12] = D_delta_x_3*t112 + D_delta_y_3*t113 + D_delta_z_3*t114;
    M[12][18] = M[18][12] = D_delta_x_1*t69 + t112;
    M[12][19] = M[19][12] = D_delta_y_1*t69 + t113;
    M[12][20] = M[20][12] = D_delta_z_1*t69 + t114;
    M[13][13] = t115*t44 + t116*t44 + t117*t44;
    M[13][14] = M[14][13] = D_delta_x_3*t118 + D_delta_y_3*t119 + D_delta_z_3*t120;
    M[13][18] = M[18][13] = D_delta_x_2*t69 + t118;
    M[13][19] = M[19][13] = D_delta_y_2*t69 + t119;
    M[13][20] = M[20][13] = D_delta_z_2*t69 + t120;
    M[14][14] = t121*t44 + t122*t44 + t123*t44;
    M[14][18] = M[18][14] = D_delta_x_3*t44 + D_delta_x_3*t69;
    M[14][19] = M[19][14] = D_delta_y_3*t44 + D_delta_y_3*t69;
    M[14][20] = M[20][14] = D_delta_z_3*t44 + D_delta_z_3*t69;
    M[15][15] = t56;
    M[16][16] = t78;
    M[17][17] = t90;
    M[18][18] = t124;
    M[19][19] = t124;
    M[20][20] = t124;
    memset(K_el, 0, sizeof(pkmodes_real[21][21]));
    K_el[0][0] = k_C*t125 + k_C*t126 + k_C*t127 + t128;
    K_el[0][1] = K_el[1][0] = D_p_x_2*t129 + D_p_y_2*t130 + D_p_z_2*t131;
    K_el[0][2] = K_el[2][0] = D_p_x_3*t129 + D_p_y_3*t130 + D_p_z_3*t131;
    K_el[0][3] = K_el[3][0] = t132;
    K_el[0][6] = K_el[6][0] = t133;
    K_el[0][12] = K_el[12][0] = D_delta_x_1*t129 + D_delta_y_1*t130 + D_delta_z_1*t131;
    K_el[0][13] = K_el[13][0] = D_delta_x_2*t129 + D_delta_y_2*t130 + D_delta_z_2*t131;
    K_el[0][14] = K_el[14][0] = D_delta_x_3*t129 + D_delta_y_3*t130 + D_delta_z_3*t131;
    K_el[0][15] = K_el[15][0] = t128;
    K_el[0][18] = K_el[18][0] = t129;
    K_el[0][19] = K_el[19][0] = t130;
    K_el[0][20] = K_el[20][0] = t131;
    K_el[1][1] = k_C*t134 + k_C*t135 + k_C*t136 + t137;
    K_el[1][2] = K_el[2][1] = D_p_x_3*t138 + D_p_y_3*t139 + D_p_z_3*t140;
    K_el[1][4] = K_el[4][1] = t141;
    K_el[1][7] = K_el[7][1] = t142;
    K_el[1][12] = K_el[12][1] = D_delta_x_1*t138 + D_delta_y_1*t139 + D_delta_z_1*t140;
    K_el[1][13] = K_el[13][1] = D_delta_x_2*t138 + D_delta_y_2*t139 + D_delta_z_2*t140;
    K_el[1][14] = K_el[14][1] = D_delta_x_3*t138 + D_delta_y_3*t139 + D_delta_z_3*t140;
    K_el[1][16] = K_el[16][1] = t137;
    K_el[1][18] = K_el[18][1] = t138;
    K_el[1][19] = K_el[19][1] = t139;
    K_el[1][20] = K_el[20][1] = t140;
    K_el[2][2] = k_C*t143 + k_C*t144 + k_C*t145 + t146;
    K_el[2][5] = K_el[5][2] = t147;
    K_el[2][8] = K_el[8][2] = t148;
    K_el[2][12] = K_el[12][2] = D_delta_x_1*t149 + D_delta_y_1*t150 + D_delta_z_1*t151;
    K_el[2][13] = K_el[13][2] = D_delta_x_2*t149 + D_delta_y_2*t150 + D_delta_z_2*t151;
    K_el[2][14] = K_el[14][2] = D_delta_x_3*t149 + D_delta_y_3*t150 + D_delta_z_3*t151;
    K_el[2][17] = K_el[17][2] = t146;
    K_el[2][18] = K_el[18][2] = t149;
    K_el[2][19] = K_el[19][2] = t150;
    K_el[2][20] = K_el[20][2] = t151;
    K_el[3][3] = k_1_3*t94 + t152 + t153;
    K_el[3][6] = K_el[6][3] = -t153;
    K_el[3][9] = K_el[9][3] = t152;
    K_el[3][15] = K_el[15][3] = t132;
    K_el[4][4] = k_2_3*t98 + t154 + t155;
    K_el[4][7] = K_el[7][4] = -t155;
    K_el[4][10] = K_el[10][4] = t154;
    K_el[4][16] = K_el[16][4] = t141;
    K_el[5][5] = k_3_3*t102 + t156 + t157;
    K_el[5][8] = K_el[8][5] = -t157;
    K_el[5][11] = K_el[11][5] = t156;
    K_el[5][17] = K_el[17][5] = t147;
    K_el[6][6] = k_1_2*t94 + t153 + t158;
    K_el[6][9] = K_el[9][6] = t158;
    K_el[6][15] = K_el[15][6] = t133;
    K_el[7][7] = k_2_2*t98 + t155 + t159;
    K_el[7][10] = K_el[10][7] = t159;
    K_el[7][16] = K_el[16][7] = t142;
    K_el[8][8] = k_3_2*t102 + t157 + t160;
    K_el[8][11] = K_el[11][8] = t160;
    K_el[8][17] = K_el[17][8] = t148;
    K_el[9][9] = t152 + t158;
    K_el[10][10] = t154 + t159;
    K_el[11][11] = t156 + t160;
    K_el[12][12] = k_C*t109 + k_C*t110 + k_C*t111;
    K_el[12][13] = K_el[13][12] = D_delta_x_2*t161 + D_delta_y_2*t162 + D_delta_z_2*t163;
    K_el[12][14] = K_el[14][12] = D_delta_x_3*t161 + D_delta_y_3*t162 + D_delta_z_3*t163;
    K_el[12][18] = K_el[18][12] = t161;
    K_el[12][19] = K_el[19][12] = t162;
    K_el[12][20] = K_el[20][12] = t163;
    K_el[13][13] = k_C*t115 + k_C*t116 + k_C*t117;
    K_el[13][14] = K_el[14][13] = D_delta_x_3*t164 + D_delta_y_3*t165 + D_delta_z_3*t166;
    K_el[13][18] = K_el[18][13] = t164;
    K_el[13][19] = K_el[19][13] = t165;
    K_el[13][20] = K_el[20][13] = t166;
    K_el[14][14] = k_C*t121 + k_C*t122 + k_C*t123;
    K_el[14][18] = K_el[18][14] = D_delta_x_3*k_C;
    K_el[14][19] = K_el[19][14] = D_delta_y_3*k_C;
    K_el[14][20] = K_el[20][14] = D_delta_z_3*k_C;
    K_el[15][15] = t128;
    K_el[16][16] = t137;
    K_el[17][17] = t146;
    K_el[18][18] = k_C;
    K_el[19][19] = k_C;
    K_el[20][20] = k_C;
    memset(K_g, 0, sizeof(pkmodes_real[21][21]));
    K_g[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 - mu_2*t125 - mu_2*t126
        - mu_2*t127 - mu_3*t125 - mu_3*t126 - mu_3*t127;
    K_g[0][1] = K_g[1][0] =
        -D_p_x_2*t167 - D_p_x_2*t169 - D_p_y_2*t170 - D_p_y_2*t172 - D_p_z_2*t173 - D_p_z_2*t175
        - U_2_x_2*t168 - U_2_y_2*t171 - U_2_z_2*t174;
    K_g[0][2] = K_g[2][0] =
        -D_p_x_3*t168 - D_p_x_3*t169 - D_p_y_3*t171 - D_p_y_3*t172 - D_p_z_3*t174 - D_p_z_3*t175
        - U_3_x_3*t167 - U_3_y_3*t170 - U_3_z_3*t173;
    K_g[0][12] = K_g[12][0] =
        -D_delta_x_1*t167 - D_delta_x_1*t168 - D_delta_x_1*t169 - D_delta_y_1*t170 - D_delta_y_1*t171
        - D_delta_y_1*t172 - D_delta_z_1*t173 - D_delta_z_1*t174 - D_delta_z_1*t175;
    K_g[0][13] = K_g[13][0] =
        -D_delta_x_2*t167 - D_delta_x_2*t168 - D_delta_x_2*t169 - D_delta_y_2*t170 - D_delta_y_2*t171
        - D_delta_y_2*t172 - D_delta_z_2*t173 - D_delta_z_2*t174 - D_delta_z_2*t175;
    K_g[0][14] = K_g[14][0] =
        -D_delta_x_3*t167 - D_delta_x_3*t168 - D_delta_x_3*t169 - D_delta_y_3*t170 - D_delta_y_3*t171
        - D_delta_y_3*t172 - D_delta_z_3*t173 - D_delta_z_3*t174 - D_delta_z_3*t175;
    K_g[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 - mu_1*t134 - mu_1*t135
        - mu_1*t136 - mu_3*t134 - mu_3*t135 - mu_3*t136;
    K_g[1][2] = K_g[2][1] =
        -D_p_x_3*t176 - D_p_x_3*t178 - D_p_y_3*t179 - D_p_y_3*t181 - D_p_z_3*t182 - D_p_z_3*t184
        - U_3_x_3*t177 - U_3_y_3*t180 - U_3_z_3*t183;
    K_g[1][12] = K_g[12][1] =
        -D_delta_x_1*t176 - D_delta_x_1*t177 - D_delta_x_1*t178 - D_delta_y_1*t179 - D_delta_y_1*t180
        - D_delta_y_1*t181 - D_delta_z_1*t182 - D_delta_z_1*t183 - D_delta_z_1*t184;
    K_g[1][13] = K_g[13][1] =
        -D_delta_x_2*t176 - D_delta_x_2*t177 - D_delta_x_2*t178 - D_delta_y_2*t179 - D_delta_y_2*t180
        - D_delta_y_2*t181 - D_delta_z_2*t182 - D_delta_z_2*t183 - D_delta_z_2*t184;
    K_g[1][14] = K_g[14][1] =
        -D_delta_x_3*t176 - D_delta_x_3*t177 - D_delta_x_3*t178 - D_delta_y_3*t179 - D_delta_y_3*t180
        - D_delta_y_3*t181 - D_delta_z_3*t182 - D_delta_z_3*t183 - D_delta_z_3*t184;
    K_g[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 - mu_1*t143 - mu_1*t144
        - mu_1*t145 - mu_2*t143 - mu_2*t144 - mu_2*t145;
    K_g[2][12] = K_g[12][2] =
        -D_delta_x_1*t186 - D_delta_y_1*t188 - D_delta_z_1*t190 - mu_1*t185 - mu_1*t187 - mu_1*t189
        - mu_2*t185 - mu_2*t187 - mu_2*t189;
    K_g[2][13] = K_g[13][2] =
        -D_delta_x_2*t186 - D_delta_y_2*t188 - D_delta_z_2*t190 - mu_1*t191 - mu_1*t192 - mu_1*t193
        - mu_2*t191 - mu_2*t192 - mu_2*t193;
    K_g[2][14] = K_g[14][2] =
        -D_delta_x_3*t186 - D_delta_y_3*t188 - D_delta_z_3*t190 - mu_1*t194 - mu_1*t195 - mu_1*t196
        - mu_2*t194 - mu_2*t195 - mu_2*t196;
    K_g[12][12] =
        -mu_1*t109 - mu_1*t110 - mu_1*t111 + mu_1 - mu_2*t109 - mu_2*t110 - mu_2*t111 - mu_3*t109 - mu_3*t110
        - mu_3*t111;
    K_g[12][13] = K_g[13][12] =
        -mu_1*t197 - mu_1*t198 - mu_1*t199 - mu_2*t197 - mu_2*t198 - mu_2*t199 - mu_3*t197 - mu_3*t198
        - mu_3*t199;
    K_g[12][14] = K_g[14][12] =
        -mu_1*t200 - mu_1*t201 - mu_1*t202 - mu_2*t200 - mu_2*t201 - mu_2*t202 - mu_3*t200 - mu_3*t201
        - mu_3*t202;
    K_g[13][13] =
        -mu_1*t115 - mu_1*t116 - mu_1*t117 - mu_2*t115 - mu_2*t116 - mu_2*t117 + mu_2 - mu_3*t115 - mu_3*t116
        - mu_3*t117;
    K_g[13][14] = K_g[14][13] =
        -mu_1*t203 - mu_1*t204 - mu_1*t205 - mu_2*t203 - mu_2*t204 - mu_2*t205 - mu_3*t203 - mu_3*t204
        - mu_3*t205;
    K_g[14][14] =
        -mu_1*t121 - mu_1*t122 - mu_1*t123 - mu_2*t121 - mu_2*t122 - mu_2*t123 - mu_3*t121 - mu_3*t122
        - mu_3*t123 + mu_3;
}

void linear_delta_extended_extended_platform_motion(const pkmodes_real p[3],
    const linear_delta_parameters *parameters, pkmodes_real J_p[3][21])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real o_1_x = parameters->origin[0][0];
    const pkmodes_real o_1_y = parameters->origin[0][1];
    const pkmodes_real o_1_z = parameters->origin[0][2];
    const pkmodes_real o_2_x = parameters->origin[1][0];
    const pkmodes_real o_2_y = parameters->origin[1][1];
    const pkmodes_real o_2_z = parameters->origin[1][2];
    const pkmodes_real o_3_x = parameters->origin[2][0];
    const pkmodes_real o_3_y = parameters->origin[2][1];
    const pkmodes_real o_3_z = parameters->origin[2][2];
    const pkmodes_real n_1_x = parameters->direction[0][0];
    const pkmodes_real n_1_y = parameters->direction[0][1];
    const pkmodes_real n_1_z = parameters->direction[0][2];
    const pkmodes_real n_2_x = parameters->direction[1][0];
    const pkmodes_real n_2_y = parameters->direction[1][1];
    const pkmodes_real n_2_z = parameters->direction[1][2];
    const pkmodes_real n_3_x = parameters->direction[2][0];
    const pkmodes_real n_3_y = parameters->direction[2][1];
    const pkmodes_real n_3_z = parameters->direction[2][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real r_1_x = b_1_x - o_1_x + p_x;
    const pkmodes_real r_1_y = b_1_y - o_1_y + p_y;
    const pkmodes_real r_1_z = b_1_z - o_1_z + p_z;
    const pkmodes_real r_2_x = b_2_x - o_2_x + p_x;
    const pkmodes_real r_2_y = b_2_y - o_2_y + p_y;
    const pkmodes_real r_2_z = b_2_z - o_2_z + p_z;
    const pkmodes_real r_3_x = b_3_x - o_3_x + p_x;
    const pkmodes_real r_3_y = b_3_y - o_3_y + p_y;
    const pkmodes_real r_3_z = b_3_z - o_3_z + p_z;
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
    const pkmodes_real s_1_x = -n_1_x*x_1 + r_1_x;
    const pkmodes_real s_1_y = -n_1_y*x_1 + r_1_y;
    const pkmodes_real s_1_z = -n_1_z*x_1 + r_1_z;
    const pkmodes_real s_2_x = -n_2_x*x_2 + r_2_x;
    const pkmodes_real s_2_y = -n_2_y*x_2 + r_2_y;
    const pkmodes_real s_2_z = -n_2_z*x_2 + r_2_z;
    const pkmodes_real s_3_x = -n_3_x*x_3 + r_3_x;
    const pkmodes_real s_3_y = -n_3_y*x_3 + r_3_y;
    const pkmodes_real s_3_z = -n_3_z*x_3 + r_3_z;
    const pkmodes_real D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const pkmodes_real D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const pkmodes_real D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const pkmodes_real A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y;
    const pkmodes_real A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x;
    const pkmodes_real A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x;
    const pkmodes_real A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y;
    const pkmodes_real A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x;
    const pkmodes_real A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x;
    const pkmodes_real A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y;
    const pkmodes_real A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x;
    const pkmodes_real A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x;
    const pkmodes_real det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const pkmodes_real t1 = 1/det_D_l;
    const pkmodes_real t2 = A_x_1*t1;
    const pkmodes_real D_p_x_1 = D_r_1*t2;
    const pkmodes_real t3 = A_x_2*t1;
    const pkmodes_real D_p_x_2 = D_r_2*t3;
    const pkmodes_real t4 = A_x_3*t1;
    const pkmodes_real D_p_x_3 = D_r_3*t4;
    const pkmodes_real D_delta_x_1 = l_d_1*t2;
    const pkmodes_real D_delta_x_2 = l_d_2*t3;
    const pkmodes_real D_delta_x_3 = l_d_3*t4;
    const pkmodes_real t5 = A_y_1*t1;
    const pkmodes_real D_p_y_1 = D_r_1*t5;
    const pkmodes_real t6 = A_y_2*t1;
    const pkmodes_real D_p_y_2 = D_r_2*t6;
    const pkmodes_real t7 = A_y_3*t1;
    const pkmodes_real D_p_y_3 = D_r_3*t7;
    const pkmodes_real D_delta_y_1 = l_d_1*t5;
    const pkmodes_real D_delta_y_2 = l_d_2*t6;
    const pkmodes_real D_delta_y_3 = l_d_3*t7;
    const pkmodes_real t8 = A_z_1*t1;
    const pkmodes_real D_p_z_1 = D_r_1*t8;
    const pkmodes_real t9 = A_z_2*t1;
    const pkmodes_real D_p_z_2 = D_r_2*t9;
    const pkmodes_real t10 = A_z_3*t1;
    const pkmodes_real D_p_z_3 = D_r_3*t10;
    const pkmodes_real D_delta_z_1 = l_d_1*t8;
    const pkmodes_real D_delta_z_2 = l_d_2*t9;
    const pkmodes_real D_delta_z_3 = l_d_3*t10;
    memset(J_p, 0, sizeof(pkmodes_real[3][21]));
    J_p[0][0] = D_p_x_1;
    J_p[0][1] = D_p_x_2;
    J_p[0][2] = D_p_x_3;
    J_p[0][12] = D_delta_x_1;
    J_p[0][13] = D_delta_x_2;
    J_p[0][14] = D_delta_x_3;
    J_p[0][18] = 1;
    J_p[1][0] = D_p_y_1;
    J_p[1][1] = D_p_y_2;
    J_p[1][2] = D_p_y_3;
    J_p[1][12] = D_delta_y_1;
    J_p[1][13] = D_delta_y_2;
    J_p[1][14] = D_delta_y_3;
    J_p[1][19] = 1;
    J_p[2][0] = D_p_z_1;
    J_p[2][1] = D_p_z_2;
    J_p[2][2] = D_p_z_3;
    J_p[2][12] = D_delta_z_1;
    J_p[2][13] = D_delta_z_2;
    J_p[2][14] = D_delta_z_3;
    J_p[2][20] = 1;
}

void linear_delta_extended_joint_stiffness(const linear_delta_effects *effects, pkmodes_real kappa[12],
    pkmodes_real kappa_c[12])
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
    kappa[3] = t2;
    kappa[4] = t2;
    kappa[5] = t2;
    kappa[6] = t3;
    kappa[7] = t3;
    kappa[8] = t3;
    kappa[9] = 1/t4;
    kappa[10] = 1/t5;
    kappa[11] = 1/t6;
    kappa_c[0] = t7;
    kappa_c[1] = t7;
    kappa_c[2] = t7;
    kappa_c[3] = t8;
    kappa_c[4] = t8;
    kappa_c[5] = t8;
    kappa_c[6] = t9;
    kappa_c[7] = t9;
    kappa_c[8] = t9;
    kappa_c[9] = -1/(t4*t4);
    kappa_c[10] = -1/(t5*t5);
    kappa_c[11] = -1/(t6*t6);
}

void linear_delta_extended_extended_static_equilibrium(const pkmodes_real p[3],
    const linear_delta_parameters *parameters, const linear_delta_effects *effects, pkmodes_real tau_st[3],
    pkmodes_real theta_st[6])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real m_p = parameters->platform_mass;
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
    const pkmodes_real n_1_x = parameters->direction[0][0];
    const pkmodes_real n_1_y = parameters->direction[0][1];
    const pkmodes_real n_1_z = parameters->direction[0][2];
    const pkmodes_real n_2_x = parameters->direction[1][0];
    const pkmodes_real n_2_y = parameters->direction[1][1];
    const pkmodes_real n_2_z = parameters->direction[1][2];
    const pkmodes_real n_3_x = parameters->direction[2][0];
    const pkmodes_real n_3_y = parameters->direction[2][1];
    const pkmodes_real n_3_z = parameters->direction[2][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real m_t_1 = parameters->carriage_mass[0];
    const pkmodes_real m_t_2 = parameters->carriage_mass[1];
    const pkmodes_real m_t_3 = parameters->carriage_mass[2];
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real k_sp_3 = parameters->belt_specific_stiffness[2];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real w_b_3 = parameters->belt_width[2];
    const pkmodes_real R_p_1 = parameters->pulley_radius[0];
    const pkmodes_real R_p_2 = parameters->pulley_radius[1];
    const pkmodes_real R_p_3 = parameters->pulley_radius[2];
    const pkmodes_real d_1_1 = parameters->drive[0][0];
    const pkmodes_real d_1_2 = parameters->drive[0][1];
    const pkmodes_real d_2_1 = parameters->drive[1][0];
    const pkmodes_real d_2_2 = parameters->drive[1][1];
    const pkmodes_real d_3_1 = parameters->drive[2][0];
    const pkmodes_real d_3_2 = parameters->drive[2][1];
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real a_B_1 = effects->axis_belt_stiffness_factor_1;
    const pkmodes_real a_B_2 = effects->axis_belt_stiffness_factor_2;
    const pkmodes_real a_B_3 = effects->axis_belt_stiffness_factor_3;
    const pkmodes_real c_E = effects->belt_end_compliance_compliance;
    const pkmodes_real c_T = effects->belt_tension_stiffness_coefficient;
    const pkmodes_real F_T = effects->belt_tension_stiffness_tension;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real r_1_x = b_1_x - o_1_x + p_x;
    const pkmodes_real r_1_y = b_1_y - o_1_y + p_y;
    const pkmodes_real r_1_z = b_1_z - o_1_z + p_z;
    const pkmodes_real r_2_x = b_2_x - o_2_x + p_x;
    const pkmodes_real r_2_y = b_2_y - o_2_y + p_y;
    const pkmodes_real r_2_z = b_2_z - o_2_z + p_z;
    const pkmodes_real r_3_x = b_3_x - o_3_x + p_x;
    const pkmodes_real r_3_y = b_3_y - o_3_y + p_y;
    const pkmodes_real r_3_z = b_3_z - o_3_z + p_z;
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
    const pkmodes_real s_1_x = -n_1_x*x_1 + r_1_x;
    const pkmodes_real s_1_y = -n_1_y*x_1 + r_1_y;
    const pkmodes_real s_1_z = -n_1_z*x_1 + r_1_z;
    const pkmodes_real s_2_x = -n_2_x*x_2 + r_2_x;
    const pkmodes_real s_2_y = -n_2_y*x_2 + r_2_y;
    const pkmodes_real s_2_z = -n_2_z*x_2 + r_2_z;
    const pkmodes_real s_3_x = -n_3_x*x_3 + r_3_x;
    const pkmodes_real s_3_y = -n_3_y*x_3 + r_3_y;
    const pkmodes_real s_3_z = -n_3_z*x_3 + r_3_z;
    const pkmodes_real D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const pkmodes_real D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const pkmodes_real D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const pkmodes_real A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y;
    const pkmodes_real A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x;
    const pkmodes_real A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x;
    const pkmodes_real A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y;
    const pkmodes_real A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x;
    const pkmodes_real A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x;
    const pkmodes_real A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y;
    const pkmodes_real A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x;
    const pkmodes_real A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x;
    const pkmodes_real det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const pkmodes_real t1 = 1/det_D_l;
    const pkmodes_real t2 = D_r_1*t1;
    const pkmodes_real D_p_x_1 = A_x_1*t2;
    const pkmodes_real t3 = D_r_2*t1;
    const pkmodes_real D_p_x_2 = A_x_2*t3;
    const pkmodes_real t4 = D_r_3*t1;
    const pkmodes_real D_p_x_3 = A_x_3*t4;
    const pkmodes_real D_p_y_1 = A_y_1*t2;
    const pkmodes_real D_p_y_2 = A_y_2*t3;
    const pkmodes_real D_p_y_3 = A_y_3*t4;
    const pkmodes_real D_p_z_1 = A_z_1*t2;
    const pkmodes_real D_p_z_2 = A_z_2*t3;
    const pkmodes_real D_p_z_3 = A_z_3*t4;
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t5 = F_T*c_T + 1;
    const pkmodes_real t6 = c_E*t5;
    const pkmodes_real t7 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t8 = t6*t7;
    const pkmodes_real t9 = t5*t7;
    const pkmodes_real k_1_1 = t9/(l_f_1_1 + t8);
    const pkmodes_real t10 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t10 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t9/(l_f_1_2 + t8);
    const pkmodes_real l_f_1_3 = -t10 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t9/(l_f_1_3 + t8);
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t11 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t12 = t11*t6;
    const pkmodes_real t13 = t11*t5;
    const pkmodes_real k_2_1 = t13/(l_f_2_1 + t12);
    const pkmodes_real t14 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t14 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t13/(l_f_2_2 + t12);
    const pkmodes_real l_f_2_3 = -t14 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t13/(l_f_2_3 + t12);
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t15 = k_sp_3*w_b_3*(a_B_3 + 1);
    const pkmodes_real t16 = t15*t6;
    const pkmodes_real t17 = t15*t5;
    const pkmodes_real k_3_1 = t17/(l_f_3_1 + t16);
    const pkmodes_real t18 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t18 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t17/(l_f_3_2 + t16);
    const pkmodes_real l_f_3_3 = -t18 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t17/(l_f_3_3 + t16);
    const pkmodes_real t19 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t20 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t22 = m_L + m_p + t19 + t20 + t21;
    const pkmodes_real t23 = g_x*t22;
    const pkmodes_real t24 = g_y*t22;
    const pkmodes_real t25 = g_z*t22;
    const pkmodes_real G_1 =
        -D_p_x_1*t23 - D_p_y_1*t24 - D_p_z_1*t25 - g_x*(m_t_1*n_1_x + n_1_x*t19) - g_y*(m_t_1*n_1_y
        + n_1_y*t19) - g_z*(m_t_1*n_1_z + n_1_z*t19);
    const pkmodes_real G_2 =
        -D_p_x_2*t23 - D_p_y_2*t24 - D_p_z_2*t25 - g_x*(m_t_2*n_2_x + n_2_x*t20) - g_y*(m_t_2*n_2_y
        + n_2_y*t20) - g_z*(m_t_2*n_2_z + n_2_z*t20);
    const pkmodes_real G_3 =
        -D_p_x_3*t23 - D_p_y_3*t24 - D_p_z_3*t25 - g_x*(m_t_3*n_3_x + n_3_x*t21) - g_y*(m_t_3*n_3_y
        + n_3_y*t21) - g_z*(m_t_3*n_3_z + n_3_z*t21);
    const pkmodes_real t26 = (R_p_1*R_p_1);
    const pkmodes_real t27 = k_1_1*t26;
    const pkmodes_real t28 = k_1_3*t26;
    const pkmodes_real t29 = -d_1_1*t27 + d_1_2*(t27 + t28);
    const pkmodes_real t30 = k_1_2*t26;
    const pkmodes_real t31 = d_1_1*(t27 + t30) - d_1_2*t27;
    const pkmodes_real det_1 = R_p_1*k_1_2*t29 - R_p_1*k_1_3*t31;
    const pkmodes_real t32 = G_1/det_1;
    const pkmodes_real theta_1_1_st = -t31*t32;
    const pkmodes_real theta_1_2_st = t29*t32;
    const pkmodes_real t33 = (R_p_2*R_p_2);
    const pkmodes_real t34 = k_2_1*t33;
    const pkmodes_real t35 = k_2_3*t33;
    const pkmodes_real t36 = -d_2_1*t34 + d_2_2*(t34 + t35);
    const pkmodes_real t37 = k_2_2*t33;
    const pkmodes_real t38 = d_2_1*(t34 + t37) - d_2_2*t34;
    const pkmodes_real det_2 = R_p_2*k_2_2*t36 - R_p_2*k_2_3*t38;
    const pkmodes_real t39 = G_2/det_2;
    const pkmodes_real theta_2_1_st = -t38*t39;
    const pkmodes_real theta_2_2_st = t36*t39;
    const pkmodes_real t40 = (R_p_3*R_p_3);
    const pkmodes_real t41 = k_3_1*t40;
    const pkmodes_real t42 = k_3_3*t40;
    const pkmodes_real t43 = -d_3_1*t41 + d_3_2*(t41 + t42);
    const pkmodes_real t44 = k_3_2*t40;
    const pkmodes_real t45 = d_3_1*(t41 + t44) - d_3_2*t41;
    const pkmodes_real det_3 = R_p_3*k_3_2*t43 - R_p_3*k_3_3*t45;
    const pkmodes_real t46 = G_3/det_3;
    const pkmodes_real theta_3_1_st = -t45*t46;
    const pkmodes_real theta_3_2_st = t43*t46;
    const pkmodes_real t47 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st);
    const pkmodes_real tau_st_1 = d_1_1*(t28*theta_1_1_st - t47) + d_1_2*(t30*theta_1_2_st + t47);
    const pkmodes_real t48 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st);
    const pkmodes_real tau_st_2 = d_2_1*(t35*theta_2_1_st - t48) + d_2_2*(t37*theta_2_2_st + t48);
    const pkmodes_real t49 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st);
    const pkmodes_real tau_st_3 = d_3_1*(t42*theta_3_1_st - t49) + d_3_2*(t44*theta_3_2_st + t49);
    tau_st[0] = tau_st_1;
    tau_st[1] = tau_st_2;
    tau_st[2] = tau_st_3;
    theta_st[0] = theta_1_1_st;
    theta_st[1] = theta_2_1_st;
    theta_st[2] = theta_3_1_st;
    theta_st[3] = theta_1_2_st;
    theta_st[4] = theta_2_2_st;
    theta_st[5] = theta_3_2_st;
}
