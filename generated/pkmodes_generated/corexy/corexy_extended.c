/* Generated from the derivation of corexy and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism corexy with effects: extended matrices and sensitivities.
 * The header describes every function.
 *
 * Names in the code.  Indices: belt j; run s of a belt.  t1, t2, ... are subexpressions shared by several
 * values.
 *   tau_st_j [N m]: static torque on motor pulley j
 *   I_j [kg m^2]: moment of inertia of motor pulley j, including the motor
 *   l_f_j_s [m]: free length of run s of belt j
 *   k_j_s [N/m]: stiffness of run s of belt j
 *   b [m]: distance of what slides along the beam from the beam's middle
 *   G_j [N]: gradient of the gravitational potential energy with respect to independent coordinate j
 *   det_j [N^2]: determinant of the equilibrium equations of axis j
 *   theta_j_st [rad]: static rotation of motor pulley j, relative to the unstrained transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "corexy_extended.h"

#include <math.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void corexy_extended_extended_matrices(const pkmodes_real p[2], const corexy_parameters *parameters,
    const corexy_effects *effects, pkmodes_real M[11][11], pkmodes_real K_el[11][11],
    pkmodes_real K_g[11][11])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_g = parameters->gantry_mass;
    const pkmodes_real g_y = parameters->gravity[1];
    const pkmodes_real g_1_1 = parameters->belt_path_direction[0][0];
    const pkmodes_real g_1_2 = parameters->belt_path_direction[0][1];
    const pkmodes_real g_2_1 = parameters->belt_path_direction[1][0];
    const pkmodes_real g_2_2 = parameters->belt_path_direction[1][1];
    const pkmodes_real l_0_1_1 = parameters->belt_path_lengths[0][0];
    const pkmodes_real l_0_1_2 = parameters->belt_path_lengths[0][1];
    const pkmodes_real l_0_2_1 = parameters->belt_path_lengths[1][0];
    const pkmodes_real l_0_2_2 = parameters->belt_path_lengths[1][1];
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
    const pkmodes_real J_B = effects->gantry_racking_inertia;
    const pkmodes_real x_B = effects->gantry_racking_center;
    const pkmodes_real b = x - x_B;
    const pkmodes_real t1 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1 = I_G + I_p_1 + t1;
    const pkmodes_real t2 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2 = I_G + I_p_2 + t2;
    const pkmodes_real t3 = g_1_1*x + g_1_2*y;
    const pkmodes_real l_f_1_1 = l_0_1_1 + t3;
    const pkmodes_real t4 = F_T*c_T + 1;
    const pkmodes_real t5 = c_E*t4;
    const pkmodes_real t6 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t7 = t5*t6;
    const pkmodes_real t8 = t4*t6;
    const pkmodes_real k_1_1 = t8/(l_f_1_1 + t7);
    const pkmodes_real l_f_1_2 = l_0_1_2 - t3;
    const pkmodes_real k_1_2 = t8/(l_f_1_2 + t7);
    const pkmodes_real t9 = g_2_1*x + g_2_2*y;
    const pkmodes_real l_f_2_1 = l_0_2_1 + t9;
    const pkmodes_real t10 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t11 = t10*t5;
    const pkmodes_real t12 = t10*t4;
    const pkmodes_real k_2_1 = t12/(l_f_2_1 + t11);
    const pkmodes_real l_f_2_2 = l_0_2_2 - t9;
    const pkmodes_real k_2_2 = t12/(l_f_2_2 + t11);
    const pkmodes_real t13 = (g_1_1*g_1_1);
    const pkmodes_real t14 = (R(1.0)/R(3.0))*rho_b;
    const pkmodes_real t15 = l_f_1_1*t14;
    const pkmodes_real t16 = l_f_1_2*t14;
    const pkmodes_real t17 = (g_2_1*g_2_1);
    const pkmodes_real t18 = l_f_2_1*t14;
    const pkmodes_real t19 = l_f_2_2*t14;
    const pkmodes_real t20 = m_L + m_h;
    const pkmodes_real t21 = g_1_1*t15;
    const pkmodes_real t22 = g_1_2*t21;
    const pkmodes_real t23 = g_1_1*t16;
    const pkmodes_real t24 = g_1_2*t23;
    const pkmodes_real t25 = g_2_1*t18;
    const pkmodes_real t26 = g_2_2*t25;
    const pkmodes_real t27 = g_2_1*t19;
    const pkmodes_real t28 = g_2_2*t27;
    const pkmodes_real t29 = (R(1.0)/R(6.0))*rho_b;
    const pkmodes_real t30 = R_p_1*t29;
    const pkmodes_real t31 = l_f_1_1*t30;
    const pkmodes_real t32 = l_f_1_2*t30;
    const pkmodes_real t33 = R_p_2*t29;
    const pkmodes_real t34 = l_f_2_1*t33;
    const pkmodes_real t35 = l_f_2_2*t33;
    const pkmodes_real t36 = (g_1_2*g_1_2);
    const pkmodes_real t37 = t15*t36;
    const pkmodes_real t38 = t16*t36;
    const pkmodes_real t39 = (g_2_2*g_2_2);
    const pkmodes_real t40 = t18*t39;
    const pkmodes_real t41 = t19*t39;
    const pkmodes_real t42 = m_g + t20;
    const pkmodes_real t43 = g_1_2*t31;
    const pkmodes_real t44 = g_1_2*t32;
    const pkmodes_real t45 = g_2_2*t34;
    const pkmodes_real t46 = g_2_2*t35;
    const pkmodes_real t47 = g_1_2*t15;
    const pkmodes_real t48 = g_1_2*t16;
    const pkmodes_real t49 = g_2_2*t18;
    const pkmodes_real t50 = g_2_2*t19;
    const pkmodes_real t51 = b*t20;
    const pkmodes_real t52 = (R_p_1*R_p_1);
    const pkmodes_real t53 = (R_p_2*R_p_2);
    const pkmodes_real t54 = m_F + t42;
    const pkmodes_real t55 = (b*b);
    const pkmodes_real t56 = g_1_1*k_1_1;
    const pkmodes_real t57 = g_1_2*t56;
    const pkmodes_real t58 = g_1_1*k_1_2;
    const pkmodes_real t59 = g_1_2*t58;
    const pkmodes_real t60 = g_2_1*k_2_1;
    const pkmodes_real t61 = g_2_2*t60;
    const pkmodes_real t62 = g_2_1*k_2_2;
    const pkmodes_real t63 = g_2_2*t62;
    const pkmodes_real t64 = k_1_1*t36;
    const pkmodes_real t65 = k_1_2*t36;
    const pkmodes_real t66 = k_2_1*t39;
    const pkmodes_real t67 = k_2_2*t39;
    const pkmodes_real t68 = g_1_2*k_1_1;
    const pkmodes_real t69 = R_p_1*t68;
    const pkmodes_real t70 = g_1_2*k_1_2;
    const pkmodes_real t71 = R_p_1*t70;
    const pkmodes_real t72 = g_2_2*k_2_1;
    const pkmodes_real t73 = R_p_2*t72;
    const pkmodes_real t74 = g_2_2*k_2_2;
    const pkmodes_real t75 = R_p_2*t74;
    const pkmodes_real t76 = b*k_C;
    memset(M, 0, sizeof(pkmodes_real[11][11]));
    M[0][0] = t13*t15 + t13*t16 + t17*t18 + t17*t19 + t20;
    M[0][1] = M[1][0] = t22 + t24 + t26 + t28;
    M[0][2] = M[2][0] = -g_1_1*t31 - g_1_1*t32;
    M[0][3] = M[3][0] = -g_2_1*t34 - g_2_1*t35;
    M[0][6] = M[6][0] = t21 + t23;
    M[0][7] = M[7][0] = t25 + t27;
    M[0][8] = M[8][0] = t20;
    M[0][10] = M[10][0] = b*t22 + b*t24 + b*t26 + b*t28;
    M[1][1] = t37 + t38 + t40 + t41 + t42;
    M[1][2] = M[2][1] = -t43 - t44;
    M[1][3] = M[3][1] = -t45 - t46;
    M[1][6] = M[6][1] = t47 + t48;
    M[1][7] = M[7][1] = t49 + t50;
    M[1][9] = M[9][1] = t42;
    M[1][10] = M[10][1] = b*t37 + b*t38 + b*t40 + b*t41 + t51;
    M[2][2] = I_1 + t15*t52 + t16*t52;
    M[2][4] = M[4][2] = t1;
    M[2][6] = M[6][2] = -t31 - t32;
    M[2][10] = M[10][2] = -b*t43 - b*t44;
    M[3][3] = I_2 + t18*t53 + t19*t53;
    M[3][5] = M[5][3] = t2;
    M[3][7] = M[7][3] = -t34 - t35;
    M[3][10] = M[10][3] = -b*t45 - b*t46;
    M[4][4] = t1;
    M[5][5] = t2;
    M[6][6] = t15 + t16;
    M[6][10] = M[10][6] = b*t47 + b*t48;
    M[7][7] = t18 + t19;
    M[7][10] = M[10][7] = b*t49 + b*t50;
    M[8][8] = t54;
    M[9][9] = t54;
    M[9][10] = M[10][9] = t51;
    M[10][10] =
        J_B + t37*t55 + t38*t55 + t40*t55 + t41*t55 + 2*t55*((R(1.0)/R(2.0))*m_L + (R(1.0)/R(2.0))*m_h);
    memset(K_el, 0, sizeof(pkmodes_real[11][11]));
    K_el[0][0] = k_1_1*t13 + k_1_2*t13 + k_2_1*t17 + k_2_2*t17 + k_C;
    K_el[0][1] = K_el[1][0] = t57 + t59 + t61 + t63;
    K_el[0][2] = K_el[2][0] = R_p_1*t56 + R_p_1*t58;
    K_el[0][3] = K_el[3][0] = R_p_2*t60 + R_p_2*t62;
    K_el[0][6] = K_el[6][0] = t56 + t58;
    K_el[0][7] = K_el[7][0] = t60 + t62;
    K_el[0][8] = K_el[8][0] = k_C;
    K_el[0][10] = K_el[10][0] = b*t57 + b*t59 + b*t61 + b*t63;
    K_el[1][1] = k_C + t64 + t65 + t66 + t67;
    K_el[1][2] = K_el[2][1] = t69 + t71;
    K_el[1][3] = K_el[3][1] = t73 + t75;
    K_el[1][6] = K_el[6][1] = t68 + t70;
    K_el[1][7] = K_el[7][1] = t72 + t74;
    K_el[1][9] = K_el[9][1] = k_C;
    K_el[1][10] = K_el[10][1] = b*t64 + b*t65 + b*t66 + b*t67 + t76;
    K_el[2][2] = k_1_1*t52 + k_1_2*t52 + k_S;
    K_el[2][4] = K_el[4][2] = k_S;
    K_el[2][6] = K_el[6][2] = R_p_1*k_1_1 + R_p_1*k_1_2;
    K_el[2][10] = K_el[10][2] = b*t69 + b*t71;
    K_el[3][3] = k_2_1*t53 + k_2_2*t53 + k_S;
    K_el[3][5] = K_el[5][3] = k_S;
    K_el[3][7] = K_el[7][3] = R_p_2*k_2_1 + R_p_2*k_2_2;
    K_el[3][10] = K_el[10][3] = b*t73 + b*t75;
    K_el[4][4] = k_S;
    K_el[5][5] = k_S;
    K_el[6][6] = k_1_1 + k_1_2;
    K_el[6][10] = K_el[10][6] = b*t68 + b*t70;
    K_el[7][7] = k_2_1 + k_2_2;
    K_el[7][10] = K_el[10][7] = b*t72 + b*t74;
    K_el[8][8] = k_C;
    K_el[9][9] = k_C;
    K_el[9][10] = K_el[10][9] = t76;
    K_el[10][10] = k_C*t55 + t55*t64 + t55*t65 + t55*t66 + t55*t67;
    memset(K_g, 0, sizeof(pkmodes_real[11][11]));
    K_g[0][10] = K_g[10][0] = -g_y*t20;
}

void corexy_extended_extended_platform_motion(const pkmodes_real p[2], const corexy_parameters *parameters,
    const corexy_effects *effects, pkmodes_real J_p[2][11])
{
    const pkmodes_real x = p[0];
    (void)parameters;
    const pkmodes_real x_B = effects->gantry_racking_center;
    const pkmodes_real b = x - x_B;
    memset(J_p, 0, sizeof(pkmodes_real[2][11]));
    J_p[0][0] = 1;
    J_p[0][8] = 1;
    J_p[1][1] = 1;
    J_p[1][9] = 1;
    J_p[1][10] = b;
}

void corexy_extended_joint_stiffness(const corexy_effects *effects, pkmodes_real kappa[7],
    pkmodes_real kappa_c[7])
{
    const pkmodes_real c_G = effects->gearbox_compliance_compliance;
    const pkmodes_real c_K = effects->clamp_compliance_compliance;
    const pkmodes_real c_F = effects->frame_compliance_compliance;
    const pkmodes_real c_F_x = effects->frame_compliance_compliance_x;
    const pkmodes_real c_F_y = effects->frame_compliance_compliance_y;
    const pkmodes_real c_B = effects->gantry_racking_compliance;
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
    kappa[6] = 1/c_B;
    kappa_c[0] = t5;
    kappa_c[1] = t5;
    kappa_c[2] = t6;
    kappa_c[3] = t6;
    kappa_c[4] = -1/(t3*t3);
    kappa_c[5] = -1/(t4*t4);
    kappa_c[6] = -1/(c_B*c_B);
}

void corexy_extended_extended_static_equilibrium(const pkmodes_real p[2],
    const corexy_parameters *parameters, const corexy_effects *effects, pkmodes_real tau_st[2],
    pkmodes_real theta_st[2])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_g = parameters->gantry_mass;
    const pkmodes_real g_x = parameters->gravity[0];
    const pkmodes_real g_y = parameters->gravity[1];
    const pkmodes_real g_1_1 = parameters->belt_path_direction[0][0];
    const pkmodes_real g_1_2 = parameters->belt_path_direction[0][1];
    const pkmodes_real g_2_1 = parameters->belt_path_direction[1][0];
    const pkmodes_real g_2_2 = parameters->belt_path_direction[1][1];
    const pkmodes_real l_0_1_1 = parameters->belt_path_lengths[0][0];
    const pkmodes_real l_0_1_2 = parameters->belt_path_lengths[0][1];
    const pkmodes_real l_0_2_1 = parameters->belt_path_lengths[1][0];
    const pkmodes_real l_0_2_2 = parameters->belt_path_lengths[1][1];
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
    const pkmodes_real t1 = g_1_1*x + g_1_2*y;
    const pkmodes_real l_f_1_1 = l_0_1_1 + t1;
    const pkmodes_real t2 = F_T*c_T + 1;
    const pkmodes_real t3 = c_E*t2;
    const pkmodes_real t4 = k_sp_1*w_b_1*(a_B_1 + 1);
    const pkmodes_real t5 = t3*t4;
    const pkmodes_real t6 = t2*t4;
    const pkmodes_real k_1_1 = t6/(l_f_1_1 + t5);
    const pkmodes_real l_f_1_2 = l_0_1_2 - t1;
    const pkmodes_real k_1_2 = t6/(l_f_1_2 + t5);
    const pkmodes_real t7 = g_2_1*x + g_2_2*y;
    const pkmodes_real l_f_2_1 = l_0_2_1 + t7;
    const pkmodes_real t8 = k_sp_2*w_b_2*(a_B_2 + 1);
    const pkmodes_real t9 = t3*t8;
    const pkmodes_real t10 = t2*t8;
    const pkmodes_real k_2_1 = t10/(l_f_2_1 + t9);
    const pkmodes_real l_f_2_2 = l_0_2_2 - t7;
    const pkmodes_real k_2_2 = t10/(l_f_2_2 + t9);
    const pkmodes_real t11 = m_L + m_h;
    const pkmodes_real G_1 = -g_x*t11;
    const pkmodes_real G_2 = -g_y*(m_g + t11);
    const pkmodes_real t12 = R_p_1*g_1_1;
    const pkmodes_real t13 = k_1_1*t12 + k_1_2*t12;
    const pkmodes_real t14 = R_p_2*g_2_2;
    const pkmodes_real t15 = k_2_1*t14 + k_2_2*t14;
    const pkmodes_real t16 = R_p_1*g_1_2;
    const pkmodes_real t17 = k_1_1*t16 + k_1_2*t16;
    const pkmodes_real t18 = R_p_2*g_2_1;
    const pkmodes_real t19 = k_2_1*t18 + k_2_2*t18;
    const pkmodes_real det_1 = t13*t15 - t17*t19;
    const pkmodes_real t20 = 1/det_1;
    const pkmodes_real theta_1_st = t20*(-G_1*t15 + G_2*t19);
    const pkmodes_real theta_2_st = t20*(G_1*t17 - G_2*t13);
    const pkmodes_real t21 = (R_p_1*R_p_1)*theta_1_st;
    const pkmodes_real tau_st_1 = k_1_1*t21 + k_1_2*t21;
    const pkmodes_real t22 = (R_p_2*R_p_2)*theta_2_st;
    const pkmodes_real tau_st_2 = k_2_1*t22 + k_2_2*t22;
    tau_st[0] = tau_st_1;
    tau_st[1] = tau_st_2;
    theta_st[0] = theta_1_st;
    theta_st[1] = theta_2_st;
}
