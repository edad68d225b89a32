/* Generated from the derivation of rotary_delta and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism rotary_delta with effects: extended matrices and sensitivities.
 * The header describes every function.
 *
 * Names in the code.  Indices: axis j; coordinate k of a derivative; component i = x, y, z.  t1, t2, ... are
 * subexpressions shared by several values.
 *   y_j_i [1]: direction of arm j at theta_j = 90 deg: a_j times z_j, component i
 *   c_j [1]: cosine of theta_j
 *   sn_j [1]: sine of theta_j
 *   d_j_i [1]: direction of arm j, component i
 *   t_j_i [1]: direction in which the end of arm j moves, component i
 *   r_j_i [m]: platform joint j relative to the origin of arm j, component i
 *   s_j_i [m]: linkage vector j, from arm to platform joint, component i
 *   A_j [m]: component of r_j along z_j
 *   B_j [m]: component of r_j along y_j
 *   C_j [m]: component of r_j along the arm when the loop is closed
 *   rho2_j [m^2]: squared length of the part of r_j in the plane of the arm
 *   S_j [m]: component of r_j in that plane, perpendicular to the arm
 *   tau_st_j [N m]: static torque on motor j, seen at the arm
 *   I_j [kg m^2]: moment of inertia of motor j, seen at the arm
 *   k_j [N m/rad]: stiffness of reducer j
 *   D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
 *   A_i_j [m^2]: adjugate of D_l, entry i, j
 *   det_D_l [m^3]: determinant of D_l
 *   D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
 *   D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
 *   U_j_i_k [m]: derivative of linkage vector j, component i, with respect to theta_k
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 *   G_j [N m]: gradient of the gravitational potential energy with respect to theta_j
 *   phi_j_st [rad]: static angle of motor j divided by the gear ratio, relative to the unstrained
 *     transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "rotary_delta_extended.h"

#include <math.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void rotary_delta_extended_extended_matrices(const pkmodes_real p[3],
    const rotary_delta_parameters *parameters, const rotary_delta_effects *effects, pkmodes_real M[12][12],
    pkmodes_real K_el[12][12], pkmodes_real K_g[12][12])
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
    const pkmodes_real a_1_x = parameters->axis[0][0];
    const pkmodes_real a_1_y = parameters->axis[0][1];
    const pkmodes_real a_1_z = parameters->axis[0][2];
    const pkmodes_real a_2_x = parameters->axis[1][0];
    const pkmodes_real a_2_y = parameters->axis[1][1];
    const pkmodes_real a_2_z = parameters->axis[1][2];
    const pkmodes_real a_3_x = parameters->axis[2][0];
    const pkmodes_real a_3_y = parameters->axis[2][1];
    const pkmodes_real a_3_z = parameters->axis[2][2];
    const pkmodes_real z_1_x = parameters->zero[0][0];
    const pkmodes_real z_1_y = parameters->zero[0][1];
    const pkmodes_real z_1_z = parameters->zero[0][2];
    const pkmodes_real z_2_x = parameters->zero[1][0];
    const pkmodes_real z_2_y = parameters->zero[1][1];
    const pkmodes_real z_2_z = parameters->zero[1][2];
    const pkmodes_real z_3_x = parameters->zero[2][0];
    const pkmodes_real z_3_y = parameters->zero[2][1];
    const pkmodes_real z_3_z = parameters->zero[2][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real L_a_1 = parameters->arm_length[0];
    const pkmodes_real L_a_2 = parameters->arm_length[1];
    const pkmodes_real L_a_3 = parameters->arm_length[2];
    const pkmodes_real m_a_1 = parameters->arm_mass[0];
    const pkmodes_real m_a_2 = parameters->arm_mass[1];
    const pkmodes_real m_a_3 = parameters->arm_mass[2];
    const pkmodes_real r_a_1 = parameters->arm_center[0];
    const pkmodes_real r_a_2 = parameters->arm_center[1];
    const pkmodes_real r_a_3 = parameters->arm_center[2];
    const pkmodes_real I_a_1 = parameters->arm_inertia[0];
    const pkmodes_real I_a_2 = parameters->arm_inertia[1];
    const pkmodes_real I_a_3 = parameters->arm_inertia[2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real k_r_1 = parameters->reducer_stiffness[0];
    const pkmodes_real k_r_2 = parameters->reducer_stiffness[1];
    const pkmodes_real k_r_3 = parameters->reducer_stiffness[2];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real I_m_3 = parameters->motor_inertia[2];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real i_g_3 = parameters->gear_ratio[2];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real a_R_1 = effects->axis_reducer_stiffness_factor_1;
    const pkmodes_real a_R_2 = effects->axis_reducer_stiffness_factor_2;
    const pkmodes_real a_R_3 = effects->axis_reducer_stiffness_factor_3;
    const pkmodes_real k_C = effects->cable_stiffness_stiffness;
    const pkmodes_real I_G = effects->gearbox_inertia_inertia;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real k_S = effects->servo_stiffness_stiffness;
    const pkmodes_real m_F = effects->frame_compliance_mass;
    const pkmodes_real y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const pkmodes_real y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const pkmodes_real y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const pkmodes_real y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const pkmodes_real y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const pkmodes_real y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const pkmodes_real y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const pkmodes_real y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const pkmodes_real y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const pkmodes_real r_1_x = b_1_x - o_1_x + p_x;
    const pkmodes_real r_1_y = b_1_y - o_1_y + p_y;
    const pkmodes_real r_1_z = b_1_z - o_1_z + p_z;
    const pkmodes_real r_2_x = b_2_x - o_2_x + p_x;
    const pkmodes_real r_2_y = b_2_y - o_2_y + p_y;
    const pkmodes_real r_2_z = b_2_z - o_2_z + p_z;
    const pkmodes_real r_3_x = b_3_x - o_3_x + p_x;
    const pkmodes_real r_3_y = b_3_y - o_3_y + p_y;
    const pkmodes_real r_3_z = b_3_z - o_3_z + p_z;
    const pkmodes_real A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const pkmodes_real B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const pkmodes_real rho2_1 = (A_1*A_1) + (B_1*B_1);
    const pkmodes_real t1 = (L_a_1*L_a_1);
    const pkmodes_real C_1 =
        (R(1.0)/R(2.0))*(-(l_d_1*l_d_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z) + t1)/L_a_1;
    const pkmodes_real S_1 = sigma_1*R(sqrt)(-(C_1*C_1) + rho2_1);
    const pkmodes_real t2 = 1/rho2_1;
    const pkmodes_real c_1 = t2*(A_1*C_1 - B_1*S_1);
    const pkmodes_real sn_1 = t2*(A_1*S_1 + B_1*C_1);
    const pkmodes_real A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const pkmodes_real B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const pkmodes_real rho2_2 = (A_2*A_2) + (B_2*B_2);
    const pkmodes_real t3 = (L_a_2*L_a_2);
    const pkmodes_real C_2 =
        (R(1.0)/R(2.0))*(-(l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z) + t3)/L_a_2;
    const pkmodes_real S_2 = sigma_2*R(sqrt)(-(C_2*C_2) + rho2_2);
    const pkmodes_real t4 = 1/rho2_2;
    const pkmodes_real c_2 = t4*(A_2*C_2 - B_2*S_2);
    const pkmodes_real sn_2 = t4*(A_2*S_2 + B_2*C_2);
    const pkmodes_real A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const pkmodes_real B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const pkmodes_real rho2_3 = (A_3*A_3) + (B_3*B_3);
    const pkmodes_real t5 = (L_a_3*L_a_3);
    const pkmodes_real C_3 =
        (R(1.0)/R(2.0))*(-(l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z) + t5)/L_a_3;
    const pkmodes_real S_3 = sigma_3*R(sqrt)(-(C_3*C_3) + rho2_3);
    const pkmodes_real t6 = 1/rho2_3;
    const pkmodes_real c_3 = t6*(A_3*C_3 - B_3*S_3);
    const pkmodes_real sn_3 = t6*(A_3*S_3 + B_3*C_3);
    const pkmodes_real d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const pkmodes_real d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const pkmodes_real d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const pkmodes_real t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const pkmodes_real t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const pkmodes_real t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const pkmodes_real d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const pkmodes_real d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const pkmodes_real d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const pkmodes_real t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const pkmodes_real t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const pkmodes_real t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const pkmodes_real d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const pkmodes_real d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const pkmodes_real d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const pkmodes_real t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const pkmodes_real t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const pkmodes_real t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const pkmodes_real t7 = L_a_1*d_1_x;
    const pkmodes_real s_1_x = r_1_x - t7;
    const pkmodes_real t8 = L_a_1*d_1_y;
    const pkmodes_real s_1_y = r_1_y - t8;
    const pkmodes_real t9 = L_a_1*d_1_z;
    const pkmodes_real s_1_z = r_1_z - t9;
    const pkmodes_real t10 = L_a_2*d_2_x;
    const pkmodes_real s_2_x = r_2_x - t10;
    const pkmodes_real t11 = L_a_2*d_2_y;
    const pkmodes_real s_2_y = r_2_y - t11;
    const pkmodes_real t12 = L_a_2*d_2_z;
    const pkmodes_real s_2_z = r_2_z - t12;
    const pkmodes_real t13 = L_a_3*d_3_x;
    const pkmodes_real s_3_x = r_3_x - t13;
    const pkmodes_real t14 = L_a_3*d_3_y;
    const pkmodes_real s_3_y = r_3_y - t14;
    const pkmodes_real t15 = L_a_3*d_3_z;
    const pkmodes_real s_3_z = r_3_z - t15;
    const pkmodes_real t16 = L_a_1*t_1_x;
    const pkmodes_real t17 = L_a_1*t_1_y;
    const pkmodes_real t18 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t16 + s_1_y*t17 + s_1_z*t18;
    const pkmodes_real t19 = L_a_2*t_2_x;
    const pkmodes_real t20 = L_a_2*t_2_y;
    const pkmodes_real t21 = L_a_2*t_2_z;
    const pkmodes_real D_r_2 = s_2_x*t19 + s_2_y*t20 + s_2_z*t21;
    const pkmodes_real t22 = L_a_3*t_3_x;
    const pkmodes_real t23 = L_a_3*t_3_y;
    const pkmodes_real t24 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t22 + s_3_y*t23 + s_3_z*t24;
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
    const pkmodes_real t25 = 1/det_D_l;
    const pkmodes_real t26 = A_x_1*t25;
    const pkmodes_real D_p_x_1 = D_r_1*t26;
    const pkmodes_real t27 = A_x_2*t25;
    const pkmodes_real D_p_x_2 = D_r_2*t27;
    const pkmodes_real t28 = A_x_3*t25;
    const pkmodes_real D_p_x_3 = D_r_3*t28;
    const pkmodes_real D_delta_x_1 = l_d_1*t26;
    const pkmodes_real D_delta_x_2 = l_d_2*t27;
    const pkmodes_real D_delta_x_3 = l_d_3*t28;
    const pkmodes_real t29 = A_y_1*t25;
    const pkmodes_real D_p_y_1 = D_r_1*t29;
    const pkmodes_real t30 = A_y_2*t25;
    const pkmodes_real D_p_y_2 = D_r_2*t30;
    const pkmodes_real t31 = A_y_3*t25;
    const pkmodes_real D_p_y_3 = D_r_3*t31;
    const pkmodes_real D_delta_y_1 = l_d_1*t29;
    const pkmodes_real D_delta_y_2 = l_d_2*t30;
    const pkmodes_real D_delta_y_3 = l_d_3*t31;
    const pkmodes_real t32 = A_z_1*t25;
    const pkmodes_real D_p_z_1 = D_r_1*t32;
    const pkmodes_real t33 = A_z_2*t25;
    const pkmodes_real D_p_z_2 = D_r_2*t33;
    const pkmodes_real t34 = A_z_3*t25;
    const pkmodes_real D_p_z_3 = D_r_3*t34;
    const pkmodes_real D_delta_z_1 = l_d_1*t32;
    const pkmodes_real D_delta_z_2 = l_d_2*t33;
    const pkmodes_real D_delta_z_3 = l_d_3*t34;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t16;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t17;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t18;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t19;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t20;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t21;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t22;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t23;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t24;
    const pkmodes_real I_1 = I_G + I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_2 = I_G + I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_3 = I_G + I_m_3*(i_g_3*i_g_3);
    const pkmodes_real k_1 = k_r_1*(a_R_1 + 1);
    const pkmodes_real k_2 = k_r_2*(a_R_2 + 1);
    const pkmodes_real k_3 = k_r_3*(a_R_3 + 1);
    const pkmodes_real t35 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t36 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t37 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t38 = m_L + m_p;
    const pkmodes_real t39 = t35 + t36 + t37 + t38;
    const pkmodes_real t40 = g_x*t39;
    const pkmodes_real t41 = g_y*t39;
    const pkmodes_real t42 = g_z*t39;
    const pkmodes_real mu_1 = t25*(-A_x_1*t40 - A_y_1*t41 - A_z_1*t42);
    const pkmodes_real mu_2 = t25*(-A_x_2*t40 - A_y_2*t41 - A_z_2*t42);
    const pkmodes_real mu_3 = t25*(-A_x_3*t40 - A_y_3*t41 - A_z_3*t42);
    const pkmodes_real t43 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t44 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t45 = t16*t44;
    const pkmodes_real t46 = t17*t44;
    const pkmodes_real t47 = t18*t44;
    const pkmodes_real t48 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t49 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t50 = t38 + t43 + t48 + t49;
    const pkmodes_real t51 = D_p_x_1*t50;
    const pkmodes_real t52 = t45 + t51;
    const pkmodes_real t53 = D_p_y_1*t50;
    const pkmodes_real t54 = t46 + t53;
    const pkmodes_real t55 = D_p_z_1*t50;
    const pkmodes_real t56 = t47 + t55;
    const pkmodes_real t57 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t58 = t19*t57;
    const pkmodes_real t59 = t20*t57;
    const pkmodes_real t60 = t21*t57;
    const pkmodes_real t61 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t62 = t22*t61;
    const pkmodes_real t63 = t23*t61;
    const pkmodes_real t64 = t24*t61;
    const pkmodes_real t65 = m_a_1*r_a_1;
    const pkmodes_real t66 = t44 + t57 + t61;
    const pkmodes_real t67 = D_p_x_2*t50;
    const pkmodes_real t68 = t58 + t67;
    const pkmodes_real t69 = D_p_y_2*t50;
    const pkmodes_real t70 = t59 + t69;
    const pkmodes_real t71 = D_p_z_2*t50;
    const pkmodes_real t72 = t60 + t71;
    const pkmodes_real t73 = m_a_2*r_a_2;
    const pkmodes_real t74 = D_p_x_3*t50;
    const pkmodes_real t75 = t62 + t74;
    const pkmodes_real t76 = D_p_y_3*t50;
    const pkmodes_real t77 = t63 + t76;
    const pkmodes_real t78 = D_p_z_3*t50;
    const pkmodes_real t79 = t64 + t78;
    const pkmodes_real t80 = m_a_3*r_a_3;
    const pkmodes_real t81 = (D_delta_x_1*D_delta_x_1);
    const pkmodes_real t82 = (D_delta_y_1*D_delta_y_1);
    const pkmodes_real t83 = (D_delta_z_1*D_delta_z_1);
    const pkmodes_real t84 = D_delta_x_1*t50;
    const pkmodes_real t85 = D_delta_y_1*t50;
    const pkmodes_real t86 = D_delta_z_1*t50;
    const pkmodes_real t87 = (D_delta_x_2*D_delta_x_2);
    const pkmodes_real t88 = (D_delta_y_2*D_delta_y_2);
    const pkmodes_real t89 = (D_delta_z_2*D_delta_z_2);
    const pkmodes_real t90 = D_delta_x_2*t50;
    const pkmodes_real t91 = D_delta_y_2*t50;
    const pkmodes_real t92 = D_delta_z_2*t50;
    const pkmodes_real t93 = (D_delta_x_3*D_delta_x_3);
    const pkmodes_real t94 = (D_delta_y_3*D_delta_y_3);
    const pkmodes_real t95 = (D_delta_z_3*D_delta_z_3);
    const pkmodes_real t96 = m_F + m_a_1 + m_a_2 + m_a_3 + m_d_1 + m_d_2 + m_d_3 + t38;
    const pkmodes_real t97 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t98 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t99 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t100 = D_p_y_1*k_C;
    const pkmodes_real t101 = D_p_z_1*k_C;
    const pkmodes_real t102 = D_p_x_1*k_C;
    const pkmodes_real t103 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t104 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t105 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t106 = D_p_x_2*k_C;
    const pkmodes_real t107 = D_p_y_2*k_C;
    const pkmodes_real t108 = D_p_z_2*k_C;
    const pkmodes_real t109 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t110 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t111 = (D_p_z_3*D_p_z_3);
    const pkmodes_real t112 = D_p_x_3*k_C;
    const pkmodes_real t113 = D_p_y_3*k_C;
    const pkmodes_real t114 = D_p_z_3*k_C;
    const pkmodes_real t115 = D_delta_x_1*k_C;
    const pkmodes_real t116 = D_delta_y_1*k_C;
    const pkmodes_real t117 = D_delta_z_1*k_C;
    const pkmodes_real t118 = D_delta_x_2*k_C;
    const pkmodes_real t119 = D_delta_y_2*k_C;
    const pkmodes_real t120 = D_delta_z_2*k_C;
    const pkmodes_real t121 = L_a_1*t35 + t65;
    const pkmodes_real t122 = D_p_x_1*mu_3;
    const pkmodes_real t123 = D_p_x_1*mu_2;
    const pkmodes_real t124 = U_1_x_1*mu_1;
    const pkmodes_real t125 = D_p_y_1*mu_3;
    const pkmodes_real t126 = D_p_y_1*mu_2;
    const pkmodes_real t127 = U_1_y_1*mu_1;
    const pkmodes_real t128 = D_p_z_1*mu_3;
    const pkmodes_real t129 = D_p_z_1*mu_2;
    const pkmodes_real t130 = U_1_z_1*mu_1;
    const pkmodes_real t131 = L_a_2*t36 + t73;
    const pkmodes_real t132 = D_p_x_2*mu_1;
    const pkmodes_real t133 = D_p_x_2*mu_3;
    const pkmodes_real t134 = U_2_x_2*mu_2;
    const pkmodes_real t135 = D_p_y_2*mu_1;
    const pkmodes_real t136 = D_p_y_2*mu_3;
    const pkmodes_real t137 = U_2_y_2*mu_2;
    const pkmodes_real t138 = D_p_z_2*mu_1;
    const pkmodes_real t139 = D_p_z_2*mu_3;
    const pkmodes_real t140 = U_2_z_2*mu_2;
    const pkmodes_real t141 = L_a_3*t37 + t80;
    const pkmodes_real t142 = D_delta_x_1*D_p_x_3;
    const pkmodes_real t143 = U_3_x_3*mu_3;
    const pkmodes_real t144 = D_delta_y_1*D_p_y_3;
    const pkmodes_real t145 = U_3_y_3*mu_3;
    const pkmodes_real t146 = D_delta_z_1*D_p_z_3;
    const pkmodes_real t147 = U_3_z_3*mu_3;
    const pkmodes_real t148 = D_delta_x_2*D_p_x_3;
    const pkmodes_real t149 = D_delta_y_2*D_p_y_3;
    const pkmodes_real t150 = D_delta_z_2*D_p_z_3;
    const pkmodes_real t151 = D_delta_x_3*D_p_x_3;
    const pkmodes_real t152 = D_delta_y_3*D_p_y_3;
    const pkmodes_real t153 = D_delta_z_3*D_p_z_3;
    const pkmodes_real t154 = D_delta_x_1*D_delta_x_2;
    const pkmodes_real t155 = D_delta_y_1*D_delta_y_2;
    const pkmodes_real t156 = D_delta_z_1*D_delta_z_2;
    const pkmodes_real t157 = D_delta_x_1*D_delta_x_3;
    const pkmodes_real t158 = D_delta_y_1*D_delta_y_3;
    const pkmodes_real t159 = D_delta_z_1*D_delta_z_3;
    const pkmodes_real t160 = D_delta_x_2*D_delta_x_3;
    const pkmodes_real t161 = D_delta_y_2*D_delta_y_3;
    const pkmodes_real t162 = D_delta_z_2*D_delta_z_3;
    memset(M, 0, sizeof(pkmodes_real[12][12]));
    M[0][0] =
        D_p_x_1*t45 + D_p_x_1*t52 + D_p_y_1*t46 + D_p_y_1*t54 + D_p_z_1*t47 + D_p_z_1*t56 + I_a_1 + t1*t43;
    M[0][1] = M[1][0] = D_p_x_1*t58 + D_p_x_2*t52 + D_p_y_1*t59 + D_p_y_2*t54 + D_p_z_1*t60 + D_p_z_2*t56;
    M[0][2] = M[2][0] = D_p_x_1*t62 + D_p_x_3*t52 + D_p_y_1*t63 + D_p_y_3*t54 + D_p_z_1*t64 + D_p_z_3*t56;
    M[0][6] = M[6][0] = D_delta_x_1*t52 + D_delta_y_1*t54 + D_delta_z_1*t56;
    M[0][7] = M[7][0] = D_delta_x_2*t52 + D_delta_y_2*t54 + D_delta_z_2*t56;
    M[0][8] = M[8][0] = D_delta_x_3*t52 + D_delta_y_3*t54 + D_delta_z_3*t56;
    M[0][9] = M[9][0] = D_p_x_1*t66 + t16*t35 + t51 + t65*t_1_x;
    M[0][10] = M[10][0] = D_p_y_1*t66 + t17*t35 + t53 + t65*t_1_y;
    M[0][11] = M[11][0] = D_p_z_1*t66 + t18*t35 + t55 + t65*t_1_z;
    M[1][1] =
        D_p_x_2*t58 + D_p_x_2*t68 + D_p_y_2*t59 + D_p_y_2*t70 + D_p_z_2*t60 + D_p_z_2*t72 + I_a_2 + t3*t48;
    M[1][2] = M[2][1] = D_p_x_2*t62 + D_p_x_3*t68 + D_p_y_2*t63 + D_p_y_3*t70 + D_p_z_2*t64 + D_p_z_3*t72;
    M[1][6] = M[6][1] = D_delta_x_1*t68 + D_delta_y_1*t70 + D_delta_z_1*t72;
    M[1][7] = M[7][1] = D_delta_x_2*t68 + D_delta_y_2*t70 + D_delta_z_2*t72;
    M[1][8] = M[8][1] = D_delta_x_3*t68 + D_delta_y_3*t70 + D_delta_z_3*t72;
    M[1][9] = M[9][1] = D_p_x_2*t66 + t19*t36 + t67 + t73*t_2_x;
    M[1][10] = M[10][1] = D_p_y_2*t66 + t20*t36 + t69 + t73*t_2_y;
    M[1][11] = M[11][1] = D_p_z_2*t66 + t21*t36 + t71 + t73*t_2_z;
    M[2][2] =
        D_p_x_3*t62 + D_p_x_3*t75 + D_p_y_3*t63 + D_p_y_3*t77 + D_p_z_3*t64 + D_p_z_3*t79 + I_a_3 + t49*t5;
    M[2][6] = M[6][2] = D_delta_x_1*t75 + D_delta_y_1*t77 + D_delta_z_1*t79;
    M[2][7] = M[7][2] = D_delta_x_2*t75 + D_delta_y_2*t77 + D_delta_z_2*t79;
    M[2][8] = M[8][2] = D_delta_x_3*t75 + D_delta_y_3*t77 + D_delta_z_3*t79;
    M[2][9] = M[9][2] = D_p_x_3*t66 + t22*t37 + t74 + t80*t_3_x;
    M[2][10] = M[10][2] = D_p_y_3*t66 + t23*t37 + t76 + t80*t_3_y;
    M[2][11] = M[11][2] = D_p_z_3*t66 + t24*t37 + t78 + t80*t_3_z;
    M[3][3] = I_1;
    M[4][4] = I_2;
    M[5][5] = I_3;
    M[6][6] = t50*t81 + t50*t82 + t50*t83;
    M[6][7] = M[7][6] = D_delta_x_2*t84 + D_delta_y_2*t85 + D_delta_z_2*t86;
    M[6][8] = M[8][6] = D_delta_x_3*t84 + D_delta_y_3*t85 + D_delta_z_3*t86;
    M[6][9] = M[9][6] = D_delta_x_1*t66 + t84;
    M[6][10] = M[10][6] = D_delta_y_1*t66 + t85;
    M[6][11] = M[11][6] = D_delta_z_1*t66 + t86;
    M[7][7] = t50*t87 + t50*t88 + t50*t89;
    M[7][8] = M[8][7] = D_delta_x_3*t90 + D_delta_y_3*t91 + D_delta_z_3*t92;
    M[7][9] = M[9][7] = D_delta_x_2*t66 + t90;
    M[7][10] = M[10][7] = D_delta_y_2*t66 + t91;
    M[7][11] = M[11][7] = D_delta_z_2*t66 + t92;
    M[8][8] = t50*t93 + t50*t94 + t50*t95;
    M[8][9] = M[9][8] = D_delta_x_3*t50 + D_delta_x_3*t66;
    M[8][10] = M[10][8] = D_delta_y_3*t50 + D_delta_y_3*t66;
    M[8][11] = M[11][8] = D_delta_z_3*t50 + D_delta_z_3*t66;
    M[9][9] = t96;
    M[10][10] = t96;
    M[11][11] = t96;
    memset(K_el, 0, sizeof(pkmodes_real[12][12]));
    K_el[0][0] = k_1 + k_C*t97 + k_C*t98 + k_C*t99;
    K_el[0][1] = K_el[1][0] = D_p_x_2*t102 + D_p_y_2*t100 + D_p_z_2*t101;
    K_el[0][2] = K_el[2][0] = D_p_x_3*t102 + D_p_y_3*t100 + D_p_z_3*t101;
    K_el[0][3] = K_el[3][0] = -k_1;
    K_el[0][6] = K_el[6][0] = D_delta_x_1*t102 + D_delta_y_1*t100 + D_delta_z_1*t101;
    K_el[0][7] = K_el[7][0] = D_delta_x_2*t102 + D_delta_y_2*t100 + D_delta_z_2*t101;
    K_el[0][8] = K_el[8][0] = D_delta_x_3*t102 + D_delta_y_3*t100 + D_delta_z_3*t101;
    K_el[0][9] = K_el[9][0] = t102;
    K_el[0][10] = K_el[10][0] = t100;
    K_el[0][11] = K_el[11][0] = t101;
    K_el[1][1] = k_2 + k_C*t103 + k_C*t104 + k_C*t105;
    K_el[1][2] = K_el[2][1] = D_p_x_3*t106 + D_p_y_3*t107 + D_p_z_3*t108;
    K_el[1][4] = K_el[4][1] = -k_2;
    K_el[1][6] = K_el[6][1] = D_delta_x_1*t106 + D_delta_y_1*t107 + D_delta_z_1*t108;
    K_el[1][7] = K_el[7][1] = D_delta_x_2*t106 + D_delta_y_2*t107 + D_delta_z_2*t108;
    K_el[1][8] = K_el[8][1] = D_delta_x_3*t106 + D_delta_y_3*t107 + D_delta_z_3*t108;
    K_el[1][9] = K_el[9][1] = t106;
    K_el[1][10] = K_el[10][1] = t107;
    K_el[1][11] = K_el[11][1] = t108;
    K_el[2][2] = k_3 + k_C*t109 + k_C*t110 + k_C*t111;
    K_el[2][5] = K_el[5][2] = -k_3;
    K_el[2][6] = K_el[6][2] = D_delta_x_1*t112 + D_delta_y_1*t113 + D_delta_z_1*t114;
    K_el[2][7] = K_el[7][2] = D_delta_x_2*t112 + D_delta_y_2*t113 + D_delta_z_2*t114;
    K_el[2][8] = K_el[8][2] = D_delta_x_3*t112 + D_delta_y_3*t113 + D_delta_z_3*t114;
    K_el[2][9] = K_el[9][2] = t112;
    K_el[2][10] = K_el[10][2] = t113;
    K_el[2][11] = K_el[11][2] = t114;
    K_el[3][3] = k_1 + k_S;
    K_el[4][4] = k_2 + k_S;
    K_el[5][5] = k_3 + k_S;
    K_el[6][6] = k_C*t81 + k_C*t82 + k_C*t83;
    K_el[6][7] = K_el[7][6] = D_delta_x_2*t115 + D_delta_y_2*t116 + D_delta_z_2*t117;
    K_el[6][8] = K_el[8][6] = D_delta_x_3*t115 + D_delta_y_3*t116 + D_delta_z_3*t117;
    K_el[6][9] = K_el[9][6] = t115;
    K_el[6][10] = K_el[10][6] = t116;
    K_el[6][11] = K_el[11][6] = t117;
    K_el[7][7] = k_C*t87 + k_C*t88 + k_C*t89;
    K_el[7][8] = K_el[8][7] = D_delta_x_3*t118 + D_delta_y_3*t119 + D_delta_z_3*t120;
    K_el[7][9] = K_el[9][7] = t118;
    K_el[7][10] = K_el[10][7] = t119;
    K_el[7][11] = K_el[11][7] = t120;
    K_el[8][8] = k_C*t93 + k_C*t94 + k_C*t95;
    K_el[8][9] = K_el[9][8] = D_delta_x_3*k_C;
    K_el[8][10] = K_el[10][8] = D_delta_y_3*k_C;
    K_el[8][11] = K_el[11][8] = D_delta_z_3*k_C;
    K_el[9][9] = k_C;
    K_el[10][10] = k_C;
    K_el[11][11] = k_C;
    memset(K_g, 0, sizeof(pkmodes_real[12][12]));
    K_g[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + d_1_x*g_x*t121
        + d_1_y*g_y*t121 + d_1_z*g_z*t121 - mu_1*s_1_x*t7 - mu_1*s_1_y*t8 - mu_1*s_1_z*t9 - mu_2*t97
        - mu_2*t98 - mu_2*t99 - mu_3*t97 - mu_3*t98 - mu_3*t99;
    K_g[0][1] = K_g[1][0] =
        -D_p_x_2*t122 - D_p_x_2*t124 - D_p_y_2*t125 - D_p_y_2*t127 - D_p_z_2*t128 - D_p_z_2*t130
        - U_2_x_2*t123 - U_2_y_2*t126 - U_2_z_2*t129;
    K_g[0][2] = K_g[2][0] =
        -D_p_x_3*t123 - D_p_x_3*t124 - D_p_y_3*t126 - D_p_y_3*t127 - D_p_z_3*t129 - D_p_z_3*t130
        - U_3_x_3*t122 - U_3_y_3*t125 - U_3_z_3*t128;
    K_g[0][6] = K_g[6][0] =
        -D_delta_x_1*t122 - D_delta_x_1*t123 - D_delta_x_1*t124 - D_delta_y_1*t125 - D_delta_y_1*t126
        - D_delta_y_1*t127 - D_delta_z_1*t128 - D_delta_z_1*t129 - D_delta_z_1*t130;
    K_g[0][7] = K_g[7][0] =
        -D_delta_x_2*t122 - D_delta_x_2*t123 - D_delta_x_2*t124 - D_delta_y_2*t125 - D_delta_y_2*t126
        - D_delta_y_2*t127 - D_delta_z_2*t128 - D_delta_z_2*t129 - D_delta_z_2*t130;
    K_g[0][8] = K_g[8][0] =
        -D_delta_x_3*t122 - D_delta_x_3*t123 - D_delta_x_3*t124 - D_delta_y_3*t125 - D_delta_y_3*t126
        - D_delta_y_3*t127 - D_delta_z_3*t128 - D_delta_z_3*t129 - D_delta_z_3*t130;
    K_g[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + d_2_x*g_x*t131
        + d_2_y*g_y*t131 + d_2_z*g_z*t131 - mu_1*t103 - mu_1*t104 - mu_1*t105 - mu_2*s_2_x*t10
        - mu_2*s_2_y*t11 - mu_2*s_2_z*t12 - mu_3*t103 - mu_3*t104 - mu_3*t105;
    K_g[1][2] = K_g[2][1] =
        -D_p_x_3*t132 - D_p_x_3*t134 - D_p_y_3*t135 - D_p_y_3*t137 - D_p_z_3*t138 - D_p_z_3*t140
        - U_3_x_3*t133 - U_3_y_3*t136 - U_3_z_3*t139;
    K_g[1][6] = K_g[6][1] =
        -D_delta_x_1*t132 - D_delta_x_1*t133 - D_delta_x_1*t134 - D_delta_y_1*t135 - D_delta_y_1*t136
        - D_delta_y_1*t137 - D_delta_z_1*t138 - D_delta_z_1*t139 - D_delta_z_1*t140;
    K_g[1][7] = K_g[7][1] =
        -D_delta_x_2*t132 - D_delta_x_2*t133 - D_delta_x_2*t134 - D_delta_y_2*t135 - D_delta_y_2*t136
        - D_delta_y_2*t137 - D_delta_z_2*t138 - D_delta_z_2*t139 - D_delta_z_2*t140;
    K_g[1][8] = K_g[8][1] =
        -D_delta_x_3*t132 - D_delta_x_3*t133 - D_delta_x_3*t134 - D_delta_y_3*t135 - D_delta_y_3*t136
        - D_delta_y_3*t137 - D_delta_z_3*t138 - D_delta_z_3*t139 - D_delta_z_3*t140;
    K_g[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + d_3_x*g_x*t141
        + d_3_y*g_y*t141 + d_3_z*g_z*t141 - mu_1*t109 - mu_1*t110 - mu_1*t111 - mu_2*t109 - mu_2*t110
        - mu_2*t111 - mu_3*s_3_x*t13 - mu_3*s_3_y*t14 - mu_3*s_3_z*t15;
    K_g[2][6] = K_g[6][2] =
        -D_delta_x_1*t143 - D_delta_y_1*t145 - D_delta_z_1*t147 - mu_1*t142 - mu_1*t144 - mu_1*t146
        - mu_2*t142 - mu_2*t144 - mu_2*t146;
    K_g[2][7] = K_g[7][2] =
        -D_delta_x_2*t143 - D_delta_y_2*t145 - D_delta_z_2*t147 - mu_1*t148 - mu_1*t149 - mu_1*t150
        - mu_2*t148 - mu_2*t149 - mu_2*t150;
    K_g[2][8] = K_g[8][2] =
        -D_delta_x_3*t143 - D_delta_y_3*t145 - D_delta_z_3*t147 - mu_1*t151 - mu_1*t152 - mu_1*t153
        - mu_2*t151 - mu_2*t152 - mu_2*t153;
    K_g[6][6] =
        -mu_1*t81 - mu_1*t82 - mu_1*t83 + mu_1 - mu_2*t81 - mu_2*t82 - mu_2*t83 - mu_3*t81 - mu_3*t82
        - mu_3*t83;
    K_g[6][7] = K_g[7][6] =
        -mu_1*t154 - mu_1*t155 - mu_1*t156 - mu_2*t154 - mu_2*t155 - mu_2*t156 - mu_3*t154 - mu_3*t155
        - mu_3*t156;
    K_g[6][8] = K_g[8][6] =
        -mu_1*t157 - mu_1*t158 - mu_1*t159 - mu_2*t157 - mu_2*t158 - mu_2*t159 - mu_3*t157 - mu_3*t158
        - mu_3*t159;
    K_g[7][7] =
        -mu_1*t87 - mu_1*t88 - mu_1*t89 - mu_2*t87 - mu_2*t88 - mu_2*t89 + mu_2 - mu_3*t87 - mu_3*t88
        - mu_3*t89;
    K_g[7][8] = K_g[8][7] =
        -mu_1*t160 - mu_1*t161 - mu_1*t162 - mu_2*t160 - mu_2*t161 - mu_2*t162 - mu_3*t160 - mu_3*t161
        - mu_3*t162;
    K_g[8][8] =
        -mu_1*t93 - mu_1*t94 - mu_1*t95 - mu_2*t93 - mu_2*t94 - mu_2*t95 - mu_3*t93 - mu_3*t94 - mu_3*t95
        + mu_3;
}

void rotary_delta_extended_extended_platform_motion(const pkmodes_real p[3],
    const rotary_delta_parameters *parameters, pkmodes_real J_p[3][12])
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
    const pkmodes_real a_1_x = parameters->axis[0][0];
    const pkmodes_real a_1_y = parameters->axis[0][1];
    const pkmodes_real a_1_z = parameters->axis[0][2];
    const pkmodes_real a_2_x = parameters->axis[1][0];
    const pkmodes_real a_2_y = parameters->axis[1][1];
    const pkmodes_real a_2_z = parameters->axis[1][2];
    const pkmodes_real a_3_x = parameters->axis[2][0];
    const pkmodes_real a_3_y = parameters->axis[2][1];
    const pkmodes_real a_3_z = parameters->axis[2][2];
    const pkmodes_real z_1_x = parameters->zero[0][0];
    const pkmodes_real z_1_y = parameters->zero[0][1];
    const pkmodes_real z_1_z = parameters->zero[0][2];
    const pkmodes_real z_2_x = parameters->zero[1][0];
    const pkmodes_real z_2_y = parameters->zero[1][1];
    const pkmodes_real z_2_z = parameters->zero[1][2];
    const pkmodes_real z_3_x = parameters->zero[2][0];
    const pkmodes_real z_3_y = parameters->zero[2][1];
    const pkmodes_real z_3_z = parameters->zero[2][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real L_a_1 = parameters->arm_length[0];
    const pkmodes_real L_a_2 = parameters->arm_length[1];
    const pkmodes_real L_a_3 = parameters->arm_length[2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const pkmodes_real y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const pkmodes_real y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const pkmodes_real y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const pkmodes_real y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const pkmodes_real y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const pkmodes_real y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const pkmodes_real y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const pkmodes_real y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const pkmodes_real r_1_x = b_1_x - o_1_x + p_x;
    const pkmodes_real r_1_y = b_1_y - o_1_y + p_y;
    const pkmodes_real r_1_z = b_1_z - o_1_z + p_z;
    const pkmodes_real r_2_x = b_2_x - o_2_x + p_x;
    const pkmodes_real r_2_y = b_2_y - o_2_y + p_y;
    const pkmodes_real r_2_z = b_2_z - o_2_z + p_z;
    const pkmodes_real r_3_x = b_3_x - o_3_x + p_x;
    const pkmodes_real r_3_y = b_3_y - o_3_y + p_y;
    const pkmodes_real r_3_z = b_3_z - o_3_z + p_z;
    const pkmodes_real A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const pkmodes_real B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const pkmodes_real rho2_1 = (A_1*A_1) + (B_1*B_1);
    const pkmodes_real C_1 =
        (R(1.0)/R(2.0))*((L_a_1*L_a_1) - (l_d_1*l_d_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z))/L_a_1;
    const pkmodes_real S_1 = sigma_1*R(sqrt)(-(C_1*C_1) + rho2_1);
    const pkmodes_real t1 = 1/rho2_1;
    const pkmodes_real c_1 = t1*(A_1*C_1 - B_1*S_1);
    const pkmodes_real sn_1 = t1*(A_1*S_1 + B_1*C_1);
    const pkmodes_real A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const pkmodes_real B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const pkmodes_real rho2_2 = (A_2*A_2) + (B_2*B_2);
    const pkmodes_real C_2 =
        (R(1.0)/R(2.0))*((L_a_2*L_a_2) - (l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z))/L_a_2;
    const pkmodes_real S_2 = sigma_2*R(sqrt)(-(C_2*C_2) + rho2_2);
    const pkmodes_real t2 = 1/rho2_2;
    const pkmodes_real c_2 = t2*(A_2*C_2 - B_2*S_2);
    const pkmodes_real sn_2 = t2*(A_2*S_2 + B_2*C_2);
    const pkmodes_real A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const pkmodes_real B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const pkmodes_real rho2_3 = (A_3*A_3) + (B_3*B_3);
    const pkmodes_real C_3 =
        (R(1.0)/R(2.0))*((L_a_3*L_a_3) - (l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z))/L_a_3;
    const pkmodes_real S_3 = sigma_3*R(sqrt)(-(C_3*C_3) + rho2_3);
    const pkmodes_real t3 = 1/rho2_3;
    const pkmodes_real c_3 = t3*(A_3*C_3 - B_3*S_3);
    const pkmodes_real sn_3 = t3*(A_3*S_3 + B_3*C_3);
    const pkmodes_real d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const pkmodes_real d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const pkmodes_real d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const pkmodes_real t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const pkmodes_real t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const pkmodes_real t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const pkmodes_real d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const pkmodes_real d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const pkmodes_real d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const pkmodes_real t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const pkmodes_real t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const pkmodes_real t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const pkmodes_real d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const pkmodes_real d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const pkmodes_real d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const pkmodes_real t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const pkmodes_real t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const pkmodes_real t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const pkmodes_real s_1_x = -L_a_1*d_1_x + r_1_x;
    const pkmodes_real s_1_y = -L_a_1*d_1_y + r_1_y;
    const pkmodes_real s_1_z = -L_a_1*d_1_z + r_1_z;
    const pkmodes_real s_2_x = -L_a_2*d_2_x + r_2_x;
    const pkmodes_real s_2_y = -L_a_2*d_2_y + r_2_y;
    const pkmodes_real s_2_z = -L_a_2*d_2_z + r_2_z;
    const pkmodes_real s_3_x = -L_a_3*d_3_x + r_3_x;
    const pkmodes_real s_3_y = -L_a_3*d_3_y + r_3_y;
    const pkmodes_real s_3_z = -L_a_3*d_3_z + r_3_z;
    const pkmodes_real D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z;
    const pkmodes_real D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z;
    const pkmodes_real D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z;
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
    const pkmodes_real t4 = 1/det_D_l;
    const pkmodes_real t5 = A_x_1*t4;
    const pkmodes_real D_p_x_1 = D_r_1*t5;
    const pkmodes_real t6 = A_x_2*t4;
    const pkmodes_real D_p_x_2 = D_r_2*t6;
    const pkmodes_real t7 = A_x_3*t4;
    const pkmodes_real D_p_x_3 = D_r_3*t7;
    const pkmodes_real D_delta_x_1 = l_d_1*t5;
    const pkmodes_real D_delta_x_2 = l_d_2*t6;
    const pkmodes_real D_delta_x_3 = l_d_3*t7;
    const pkmodes_real t8 = A_y_1*t4;
    const pkmodes_real D_p_y_1 = D_r_1*t8;
    const pkmodes_real t9 = A_y_2*t4;
    const pkmodes_real D_p_y_2 = D_r_2*t9;
    const pkmodes_real t10 = A_y_3*t4;
    const pkmodes_real D_p_y_3 = D_r_3*t10;
    const pkmodes_real D_delta_y_1 = l_d_1*t8;
    const pkmodes_real D_delta_y_2 = l_d_2*t9;
    const pkmodes_real D_delta_y_3 = l_d_3*t10;
    const pkmodes_real t11 = A_z_1*t4;
    const pkmodes_real D_p_z_1 = D_r_1*t11;
    const pkmodes_real t12 = A_z_2*t4;
    const pkmodes_real D_p_z_2 = D_r_2*t12;
    const pkmodes_real t13 = A_z_3*t4;
    const pkmodes_real D_p_z_3 = D_r_3*t13;
    const pkmodes_real D_delta_z_1 = l_d_1*t11;
    const pkmodes_real D_delta_z_2 = l_d_2*t12;
    const pkmodes_real D_delta_z_3 = l_d_3*t13;
    memset(J_p, 0, sizeof(pkmodes_real[3][12]));
    J_p[0][0] = D_p_x_1;
    J_p[0][1] = D_p_x_2;
    J_p[0][2] = D_p_x_3;
    J_p[0][6] = D_delta_x_1;
    J_p[0][7] = D_delta_x_2;
    J_p[0][8] = D_delta_x_3;
    J_p[0][9] = 1;
    J_p[1][0] = D_p_y_1;
    J_p[1][1] = D_p_y_2;
    J_p[1][2] = D_p_y_3;
    J_p[1][6] = D_delta_y_1;
    J_p[1][7] = D_delta_y_2;
    J_p[1][8] = D_delta_y_3;
    J_p[1][10] = 1;
    J_p[2][0] = D_p_z_1;
    J_p[2][1] = D_p_z_2;
    J_p[2][2] = D_p_z_3;
    J_p[2][6] = D_delta_z_1;
    J_p[2][7] = D_delta_z_2;
    J_p[2][8] = D_delta_z_3;
    J_p[2][11] = 1;
}

void rotary_delta_extended_joint_stiffness(const rotary_delta_effects *effects, pkmodes_real kappa[6],
    pkmodes_real kappa_c[6])
{
    const pkmodes_real c_L = effects->link_compliance_compliance;
    const pkmodes_real c_F = effects->frame_compliance_compliance;
    const pkmodes_real c_F_x = effects->frame_compliance_compliance_x;
    const pkmodes_real c_F_y = effects->frame_compliance_compliance_y;
    const pkmodes_real c_F_z = effects->frame_compliance_compliance_z;
    const pkmodes_real t1 = 1/c_L;
    const pkmodes_real t2 = c_F + c_F_x;
    const pkmodes_real t3 = c_F + c_F_y;
    const pkmodes_real t4 = c_F + c_F_z;
    const pkmodes_real t5 = -1/(c_L*c_L);
    kappa[0] = t1;
    kappa[1] = t1;
    kappa[2] = t1;
    kappa[3] = 1/t2;
    kappa[4] = 1/t3;
    kappa[5] = 1/t4;
    kappa_c[0] = t5;
    kappa_c[1] = t5;
    kappa_c[2] = t5;
    kappa_c[3] = -1/(t2*t2);
    kappa_c[4] = -1/(t3*t3);
    kappa_c[5] = -1/(t4*t4);
}

void rotary_delta_extended_extended_static_equilibrium(const pkmodes_real p[3],
    const rotary_delta_parameters *parameters, const rotary_delta_effects *effects, pkmodes_real tau_st[3],
    pkmodes_real theta_st[3])
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
    const pkmodes_real a_1_x = parameters->axis[0][0];
    const pkmodes_real a_1_y = parameters->axis[0][1];
    const pkmodes_real a_1_z = parameters->axis[0][2];
    const pkmodes_real a_2_x = parameters->axis[1][0];
    const pkmodes_real a_2_y = parameters->axis[1][1];
    const pkmodes_real a_2_z = parameters->axis[1][2];
    const pkmodes_real a_3_x = parameters->axis[2][0];
    const pkmodes_real a_3_y = parameters->axis[2][1];
    const pkmodes_real a_3_z = parameters->axis[2][2];
    const pkmodes_real z_1_x = parameters->zero[0][0];
    const pkmodes_real z_1_y = parameters->zero[0][1];
    const pkmodes_real z_1_z = parameters->zero[0][2];
    const pkmodes_real z_2_x = parameters->zero[1][0];
    const pkmodes_real z_2_y = parameters->zero[1][1];
    const pkmodes_real z_2_z = parameters->zero[1][2];
    const pkmodes_real z_3_x = parameters->zero[2][0];
    const pkmodes_real z_3_y = parameters->zero[2][1];
    const pkmodes_real z_3_z = parameters->zero[2][2];
    const pkmodes_real b_1_x = parameters->joint[0][0];
    const pkmodes_real b_1_y = parameters->joint[0][1];
    const pkmodes_real b_1_z = parameters->joint[0][2];
    const pkmodes_real b_2_x = parameters->joint[1][0];
    const pkmodes_real b_2_y = parameters->joint[1][1];
    const pkmodes_real b_2_z = parameters->joint[1][2];
    const pkmodes_real b_3_x = parameters->joint[2][0];
    const pkmodes_real b_3_y = parameters->joint[2][1];
    const pkmodes_real b_3_z = parameters->joint[2][2];
    const pkmodes_real L_a_1 = parameters->arm_length[0];
    const pkmodes_real L_a_2 = parameters->arm_length[1];
    const pkmodes_real L_a_3 = parameters->arm_length[2];
    const pkmodes_real m_a_1 = parameters->arm_mass[0];
    const pkmodes_real m_a_2 = parameters->arm_mass[1];
    const pkmodes_real m_a_3 = parameters->arm_mass[2];
    const pkmodes_real r_a_1 = parameters->arm_center[0];
    const pkmodes_real r_a_2 = parameters->arm_center[1];
    const pkmodes_real r_a_3 = parameters->arm_center[2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real k_r_1 = parameters->reducer_stiffness[0];
    const pkmodes_real k_r_2 = parameters->reducer_stiffness[1];
    const pkmodes_real k_r_3 = parameters->reducer_stiffness[2];
    const pkmodes_real sigma_1 = parameters->branch[0];
    const pkmodes_real sigma_2 = parameters->branch[1];
    const pkmodes_real sigma_3 = parameters->branch[2];
    const pkmodes_real a_R_1 = effects->axis_reducer_stiffness_factor_1;
    const pkmodes_real a_R_2 = effects->axis_reducer_stiffness_factor_2;
    const pkmodes_real a_R_3 = effects->axis_reducer_stiffness_factor_3;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const pkmodes_real y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const pkmodes_real y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const pkmodes_real y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const pkmodes_real y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const pkmodes_real y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const pkmodes_real y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const pkmodes_real y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const pkmodes_real y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const pkmodes_real r_1_x = b_1_x - o_1_x + p_x;
    const pkmodes_real r_1_y = b_1_y - o_1_y + p_y;
    const pkmodes_real r_1_z = b_1_z - o_1_z + p_z;
    const pkmodes_real r_2_x = b_2_x - o_2_x + p_x;
    const pkmodes_real r_2_y = b_2_y - o_2_y + p_y;
    const pkmodes_real r_2_z = b_2_z - o_2_z + p_z;
    const pkmodes_real r_3_x = b_3_x - o_3_x + p_x;
    const pkmodes_real r_3_y = b_3_y - o_3_y + p_y;
    const pkmodes_real r_3_z = b_3_z - o_3_z + p_z;
    const pkmodes_real A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const pkmodes_real B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const pkmodes_real rho2_1 = (A_1*A_1) + (B_1*B_1);
    const pkmodes_real C_1 =
        (R(1.0)/R(2.0))*((L_a_1*L_a_1) - (l_d_1*l_d_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z))/L_a_1;
    const pkmodes_real S_1 = sigma_1*R(sqrt)(-(C_1*C_1) + rho2_1);
    const pkmodes_real t1 = 1/rho2_1;
    const pkmodes_real c_1 = t1*(A_1*C_1 - B_1*S_1);
    const pkmodes_real sn_1 = t1*(A_1*S_1 + B_1*C_1);
    const pkmodes_real A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const pkmodes_real B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const pkmodes_real rho2_2 = (A_2*A_2) + (B_2*B_2);
    const pkmodes_real C_2 =
        (R(1.0)/R(2.0))*((L_a_2*L_a_2) - (l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z))/L_a_2;
    const pkmodes_real S_2 = sigma_2*R(sqrt)(-(C_2*C_2) + rho2_2);
    const pkmodes_real t2 = 1/rho2_2;
    const pkmodes_real c_2 = t2*(A_2*C_2 - B_2*S_2);
    const pkmodes_real sn_2 = t2*(A_2*S_2 + B_2*C_2);
    const pkmodes_real A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const pkmodes_real B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const pkmodes_real rho2_3 = (A_3*A_3) + (B_3*B_3);
    const pkmodes_real C_3 =
        (R(1.0)/R(2.0))*((L_a_3*L_a_3) - (l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z))/L_a_3;
    const pkmodes_real S_3 = sigma_3*R(sqrt)(-(C_3*C_3) + rho2_3);
    const pkmodes_real t3 = 1/rho2_3;
    const pkmodes_real c_3 = t3*(A_3*C_3 - B_3*S_3);
    const pkmodes_real sn_3 = t3*(A_3*S_3 + B_3*C_3);
    const pkmodes_real d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const pkmodes_real d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const pkmodes_real d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const pkmodes_real t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const pkmodes_real t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const pkmodes_real t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const pkmodes_real d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const pkmodes_real d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const pkmodes_real d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const pkmodes_real t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const pkmodes_real t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const pkmodes_real t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const pkmodes_real d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const pkmodes_real d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const pkmodes_real d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const pkmodes_real t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const pkmodes_real t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const pkmodes_real t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const pkmodes_real s_1_x = -L_a_1*d_1_x + r_1_x;
    const pkmodes_real s_1_y = -L_a_1*d_1_y + r_1_y;
    const pkmodes_real s_1_z = -L_a_1*d_1_z + r_1_z;
    const pkmodes_real s_2_x = -L_a_2*d_2_x + r_2_x;
    const pkmodes_real s_2_y = -L_a_2*d_2_y + r_2_y;
    const pkmodes_real s_2_z = -L_a_2*d_2_z + r_2_z;
    const pkmodes_real s_3_x = -L_a_3*d_3_x + r_3_x;
    const pkmodes_real s_3_y = -L_a_3*d_3_y + r_3_y;
    const pkmodes_real s_3_z = -L_a_3*d_3_z + r_3_z;
    const pkmodes_real D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z;
    const pkmodes_real D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z;
    const pkmodes_real D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z;
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
    const pkmodes_real t4 = 1/det_D_l;
    const pkmodes_real t5 = D_r_1*t4;
    const pkmodes_real D_p_x_1 = A_x_1*t5;
    const pkmodes_real t6 = D_r_2*t4;
    const pkmodes_real D_p_x_2 = A_x_2*t6;
    const pkmodes_real t7 = D_r_3*t4;
    const pkmodes_real D_p_x_3 = A_x_3*t7;
    const pkmodes_real D_p_y_1 = A_y_1*t5;
    const pkmodes_real D_p_y_2 = A_y_2*t6;
    const pkmodes_real D_p_y_3 = A_y_3*t7;
    const pkmodes_real D_p_z_1 = A_z_1*t5;
    const pkmodes_real D_p_z_2 = A_z_2*t6;
    const pkmodes_real D_p_z_3 = A_z_3*t7;
    const pkmodes_real k_1 = k_r_1*(a_R_1 + 1);
    const pkmodes_real k_2 = k_r_2*(a_R_2 + 1);
    const pkmodes_real k_3 = k_r_3*(a_R_3 + 1);
    const pkmodes_real t8 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t9 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t10 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t11 = m_L + m_p + t10 + t8 + t9;
    const pkmodes_real t12 = g_x*t11;
    const pkmodes_real t13 = g_y*t11;
    const pkmodes_real t14 = g_z*t11;
    const pkmodes_real t15 = L_a_1*t9 + m_a_1*r_a_1;
    const pkmodes_real G_1 =
        -D_p_x_1*t12 - D_p_y_1*t13 - D_p_z_1*t14 - g_x*t15*t_1_x - g_y*t15*t_1_y - g_z*t15*t_1_z;
    const pkmodes_real t16 = L_a_2*t10 + m_a_2*r_a_2;
    const pkmodes_real G_2 =
        -D_p_x_2*t12 - D_p_y_2*t13 - D_p_z_2*t14 - g_x*t16*t_2_x - g_y*t16*t_2_y - g_z*t16*t_2_z;
    const pkmodes_real t17 = L_a_3*t8 + m_a_3*r_a_3;
    const pkmodes_real G_3 =
        -D_p_x_3*t12 - D_p_y_3*t13 - D_p_z_3*t14 - g_x*t17*t_3_x - g_y*t17*t_3_y - g_z*t17*t_3_z;
    const pkmodes_real phi_1_st = G_1/k_1;
    const pkmodes_real phi_2_st = G_2/k_2;
    const pkmodes_real phi_3_st = G_3/k_3;
    const pkmodes_real tau_st_1 = k_1*phi_1_st;
    const pkmodes_real tau_st_2 = k_2*phi_2_st;
    const pkmodes_real tau_st_3 = k_3*phi_3_st;
    tau_st[0] = tau_st_1;
    tau_st[1] = tau_st_2;
    tau_st[2] = tau_st_3;
    theta_st[0] = phi_1_st;
    theta_st[1] = phi_2_st;
    theta_st[2] = phi_3_st;
}
