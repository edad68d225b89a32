/* Generated from the derivation of bed_slinger and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism bed_slinger with effects: extended matrices and sensitivities.
 * The header describes every function.
 *
 * Names in the code.  Indices: belt j; run s of a belt.  t1, t2, ... are subexpressions shared by several
 * values.
 *   tau_st_j [N m]: static torque on motor pulley j
 *   I_j [kg m^2]: moment of inertia of motor pulley j, including the motor
 *   l_f_j_s [m]: free length of run s of belt j
 *   k_j_s [N/m]: stiffness of run s of belt j
 *   G_j [N]: gradient of the gravitational potential energy with respect to independent coordinate j
 *   theta_j_st [rad]: static rotation of motor pulley j, relative to the unstrained transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "bed_slinger_extended.h"

#include <math.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void bed_slinger_extended_extended_matrices(const pkmodes_real p[2],
    const bed_slinger_parameters *parameters, const bed_slinger_effects *effects, pkmodes_real M[10][10],
    pkmodes_real K_el[10][10], pkmodes_real K_g[10][10])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_b = parameters->bed_mass;
    const pkmodes_real l_0_1_1 = parameters->axis_lengths[0][0];
    const pkmodes_real l_0_1_2 = parameters->axis_lengths[0][1];
    const pkmodes_real l_0_2_1 = parameters->axis_lengths[1][0];
    const pkmodes_real l_0_2_2 = parameters->axis_lengths[1][1];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real R_p_1 = parameters->pulley_radius[0];
    const pkmodes_real R_p_2 = parameters->pulley_radius[1];
    const pkmodes_real I_p_1 = parameters->pulley_inertia[0];
    const pkmodes_real I_p_2 = parameters->pulley_inertia[1];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real a_B_1 = effects->axis_belt_stiffness_factor_1;
    const pkmodes_real a_B_2 = effects->axis_belt_stiffness_factor_2;
    const pkmodes_real c_E = effects->belt_end_compliance_compliance;
    const pkmodes_real rho_b = effects->belt_mass_linear_density;
    const pkmodes_real c_T = effects->belt_tension_stiffness_coefficient;
    const pkmodes_real F_T = effects->belt_tension_stiffness_tension;
    const pkmodes_real k_C = effects->cable_stiffness_stiffness;
    const pkmodes_real I_G = effects->gearbox_inertia_inertia;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real k_S = effects->servo_stiffness_stiffness;
    const pkmodes_real m_F = effects->frame_compliance_mass;
    const pkmodes_real t1 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1 = I_G + I_p_1 + t1;
    const pkmodes_real t2 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2 = I_G + I_p_2 + t2;
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t3 = F_T*c_T + 1;
    const pkmodes_real t4 = c_E*t3;
    const pkmodes_real t5 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t6 = t4*t5;
    const pkmodes_real t7 = t3*t5;
    const pkmodes_real k_1_1 = t7/(l_f_1_1 + t6);
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t7/(l_f_1_2 + t6);
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t8 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t9 = t4*t8;
    const pkmodes_real t10 = t3*t8;
    const pkmodes_real k_2_1 = t10/(l_f_2_1 + t9);
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t10/(l_f_2_2 + t9);
    const pkmodes_real t11 = (R(1.0)/R(3.0))*rho_b;
    const pkmodes_real t12 = l_f_1_1*t11;
    const pkmodes_real t13 = l_f_1_2*t11;
    const pkmodes_real t14 = t12 + t13;
    const pkmodes_real t15 = (R(1.0)/R(6.0))*rho_b;
    const pkmodes_real t16 = R_p_1*t15;
    const pkmodes_real t17 = -l_f_1_1*t16 - l_f_1_2*t16;
    const pkmodes_real t18 = l_f_2_1*t11;
    const pkmodes_real t19 = l_f_2_2*t11;
    const pkmodes_real t20 = t18 + t19;
    const pkmodes_real t21 = m_L + m_b;
    const pkmodes_real t22 = R_p_2*t15;
    const pkmodes_real t23 = -l_f_2_1*t22 - l_f_2_2*t22;
    const pkmodes_real t24 = (R_p_1*R_p_1);
    const pkmodes_real t25 = (R_p_2*R_p_2);
    const pkmodes_real t26 = m_F + m_h + t21;
    const pkmodes_real t27 = k_1_1 + k_1_2;
    const pkmodes_real t28 = R_p_1*k_1_1 + R_p_1*k_1_2;
    const pkmodes_real t29 = k_2_1 + k_2_2;
    const pkmodes_real t30 = R_p_2*k_2_1 + R_p_2*k_2_2;
    memset(M, 0, sizeof(pkmodes_real[10][10]));
    M[0][0] = m_h + t14;
    M[0][2] = M[2][0] = t17;
    M[0][6] = M[6][0] = t14;
    M[0][8] = M[8][0] = m_h;
    M[1][1] = t20 + t21;
    M[1][3] = M[3][1] = t23;
    M[1][7] = M[7][1] = t20;
    M[1][9] = M[9][1] = t21;
    M[2][2] = I_1 + t12*t24 + t13*t24;
    M[2][4] = M[4][2] = t1;
    M[2][6] = M[6][2] = t17;
    M[3][3] = I_2 + t18*t25 + t19*t25;
    M[3][5] = M[5][3] = t2;
    M[3][7] = M[7][3] = t23;
    M[4][4] = t1;
    M[5][5] = t2;
    M[6][6] = t14;
    M[7][7] = t20;
    M[8][8] = t26;
    M[9][9] = t26;
    memset(K_el, 0, sizeof(pkmodes_real[10][10]));
    K_el[0][0] = k_C + t27;
    K_el[0][2] = K_el[2][0] = t28;
    K_el[0][6] = K_el[6][0] = t27;
    K_el[0][8] = K_el[8][0] = k_C;
    K_el[1][1] = k_C + t29;
    K_el[1][3] = K_el[3][1] = t30;
    K_el[1][7] = K_el[7][1] = t29;
    K_el[1][9] = K_el[9][1] = k_C;
    K_el[2][2] = k_1_1*t24 + k_1_2*t24 + k_S;
    K_el[2][4] = K_el[4][2] = k_S;
    K_el[2][6] = K_el[6][2] = t28;
    K_el[3][3] = k_2_1*t25 + k_2_2*t25 + k_S;
    K_el[3][5] = K_el[5][3] = k_S;
    K_el[3][7] = K_el[7][3] = t30;
    K_el[4][4] = k_S;
    K_el[5][5] = k_S;
    K_el[6][6] = t27;
    K_el[7][7] = t29;
    K_el[8][8] = k_C;
    K_el[9][9] = k_C;
    memset(K_g, 0, sizeof(pkmodes_real[10][10]));
}

void bed_slinger_extended_extended_platform_motion(const pkmodes_real p[2],
    const bed_slinger_parameters *parameters, pkmodes_real J_p[2][10])
{
    (void)p;
    (void)parameters;
    memset(J_p, 0, sizeof(pkmodes_real[2][10]));
    J_p[0][0] = 1;
    J_p[0][8] = 1;
    J_p[1][1] = 1;
    J_p[1][9] = 1;
}

void bed_slinger_extended_joint_stiffness(const bed_slinger_effects *effects, pkmodes_real kappa[6],
    pkmodes_real kappa_c[6])
{
    const pkmodes_real c_G = effects->gearbox_compliance_compliance;
    const pkmodes_real c_K = effects->clamp_compliance_compliance;
    const pkmodes_real c_F = effects->frame_compliance_compliance;
    const pkmodes_real c_F_x = effects->frame_compliance_compliance_x;
    const pkmodes_real c_F_y = effects->frame_compliance_compliance_y;
    const pkmodes_real t1 = 1/c_G;
    const pkmodes_real t2 = 1/c_K;
    const pkmodes_real t3 = c_F + c_F_x;
    const pkmodes_real t4 = c_F + c_F_y;
    const pkmodes_real t5 = -1/(c_G*c_G);
    const pkmodes_real t6 = -1/(c_K*c_K);
    kappa[0] = t1;
    kappa[1] = t1;
    kappa[2] = t2;
    kappa[3] = t2;
    kappa[4] = 1/t3;
    kappa[5] = 1/t4;
    kappa_c[0] = t5;
    kappa_c[1] = t5;
    kappa_c[2] = t6;
    kappa_c[3] = t6;
    kappa_c[4] = -1/(t3*t3);
    kappa_c[5] = -1/(t4*t4);
}

void bed_slinger_extended_extended_static_equilibrium(const pkmodes_real p[2],
    const bed_slinger_parameters *parameters, const bed_slinger_effects *effects, pkmodes_real tau_st[2],
    pkmodes_real theta_st[2])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_b = parameters->bed_mass;
    const pkmodes_real g_x = parameters->gravity[0];
    const pkmodes_real g_y = parameters->gravity[1];
    const pkmodes_real l_0_1_1 = parameters->axis_lengths[0][0];
    const pkmodes_real l_0_1_2 = parameters->axis_lengths[0][1];
    const pkmodes_real l_0_2_1 = parameters->axis_lengths[1][0];
    const pkmodes_real l_0_2_2 = parameters->axis_lengths[1][1];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real R_p_1 = parameters->pulley_radius[0];
    const pkmodes_real R_p_2 = parameters->pulley_radius[1];
    const pkmodes_real a_B_1 = effects->axis_belt_stiffness_factor_1;
    const pkmodes_real a_B_2 = effects->axis_belt_stiffness_factor_2;
    const pkmodes_real c_E = effects->belt_end_compliance_compliance;
    const pkmodes_real c_T = effects->belt_tension_stiffness_coefficient;
    const pkmodes_real F_T = effects->belt_tension_stiffness_tension;
    const pkmodes_real m_L = effects->payload_mass;
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = F_T*c_T + 1;
    const pkmodes_real t2 = c_E*t1;
    const pkmodes_real t3 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t4 = t2*t3;
    const pkmodes_real t5 = t1*t3;
    const pkmodes_real k_1_1 = t5/(l_f_1_1 + t4);
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t5/(l_f_1_2 + t4);
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t6 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t7 = t2*t6;
    const pkmodes_real t8 = t1*t6;
    const pkmodes_real k_2_1 = t8/(l_f_2_1 + t7);
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t8/(l_f_2_2 + t7);
    const pkmodes_real G_1 = -g_x*m_h;
    const pkmodes_real G_2 = -g_y*(m_L + m_b);
    const pkmodes_real theta_1_st = -G_1/(R_p_1*k_1_1 + R_p_1*k_1_2);
    const pkmodes_real theta_2_st = -G_2/(R_p_2*k_2_1 + R_p_2*k_2_2);
    const pkmodes_real t9 = (R_p_1*R_p_1)*theta_1_st;
    const pkmodes_real tau_st_1 = k_1_1*t9 + k_1_2*t9;
    const pkmodes_real t10 = (R_p_2*R_p_2)*theta_2_st;
    const pkmodes_real tau_st_2 = k_2_1*t10 + k_2_2*t10;
    tau_st[0] = tau_st_1;
    tau_st[1] = tau_st_2;
    theta_st[0] = theta_1_st;
    theta_st[1] = theta_2_st;
}
