/* Generated from the derivation of hexapod and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism hexapod with effects: extended matrices and sensitivities.
 * The header describes every function.
 *
 * Names in the code.  Indices: leg j; coordinate k of a derivative; component i = x, y, z; rows r of a minor;
 * columns c of a minor; axis a of the platform.  t1, t2, ... are subexpressions shared by several values.
 *   half_angle [rad]: half the angle of rotation
 *   s_half [1]: sine of half the angle over half the angle
 *   c_half [1]: cosine of half the angle
 *   R_i_a [1]: rotation matrix of the platform: component i of its axis a
 *   l_j [m]: length of leg j
 *   B_j_i [m]: platform joint j from the platform's origin, base frame, component i
 *   d_j_i [m]: leg j, from base joint to platform joint, component i
 *   c_i [m]: centre of mass of the platform from its origin, component i
 *   J_i_a [kg m^2]: inertia tensor of the platform about its centre of mass, base frame, entry ia
 *   m_perp_j [kg]: inertia of leg j at its platform joint, perpendicular to the leg
 *   m_lift_j [kg]: mass that is lifted with the vector of leg j
 *   f_st_j [N]: static force on drive j
 *   k_j [N/m]: stiffness of leg j, with effects
 *   o_L_i [m]: payload from the platform's origin, base frame, component i
 *   D_l_j_i [m^2]: moment of linkage vector j about the platform's origin, component i
 *   A_i_j [m^8]: adjugate of D_l, entry i, j
 *   minor_r_c [m^2]: minor of D_l, rows r and columns c
 *   minor_r_c [m^4]: minor of D_l, rows r and columns c
 *   minor_r_c [m^6]: minor of D_l, rows r and columns c
 *   minor_r_c [m^3]: minor of D_l, rows r and columns c
 *   minor_r_c [m^5]: minor of D_l, rows r and columns c
 *   A_i_j [m^7]: adjugate of D_l, entry i, j
 *   det_D_l [m^9]: determinant of D_l
 *   D_p_i_k [1]: platform Jacobian, dp_i/dl_k
 *   D_p_i_k [1/m]: platform Jacobian, dp_i/dl_k
 *   G_p_i [N]: gradient of the gravitational potential energy with respect to the platform, component i
 *   G_p_i [N m]: gradient of the gravitational potential energy with respect to the platform, component i
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 *   g_j_i [N]: derivative of gravity and closures with respect to vector j that turns, component i
 *   L_i_a [N/m]: second derivative of gravity and closures with respect to the platform, entry i, a
 *   L_i_a [N]: second derivative of gravity and closures with respect to the platform, entry i, a
 *   L_i_a [N m]: second derivative of gravity and closures with respect to the platform, entry i, a
 *   f_i_k [N/m]: force on the platform along i per unit of coordinate k
 *   f_i_k [N]: force on the platform along i per unit of coordinate k
 *   G_j [N]: gradient of the gravitational potential energy with respect to l_j
 *   s_j_st [m]: static length that motor j commands, relative to the unstrained transmissions
 *   M_p_i_a [kg]: apparent mass of the platform, entry i, a
 *   M_p_i_a [kg m]: apparent mass of the platform, entry i, a
 *   M_p_i_a [kg m^2]: apparent mass of the platform, entry i, a
 *   h_i_k [kg]: momentum of the platform along i per unit rate of coordinate k
 *   h_i_k [kg m]: momentum of the platform along i per unit rate of coordinate k
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "hexapod_extended.h"

#include <math.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void hexapod_extended_extended_matrices(const pkmodes_real p[6], const hexapod_parameters *parameters,
    const hexapod_effects *effects, pkmodes_real M[15][15], pkmodes_real K_el[15][15],
    pkmodes_real K_g[15][15])
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
    const pkmodes_real a_1_x = parameters->base[0][0];
    const pkmodes_real a_1_y = parameters->base[0][1];
    const pkmodes_real a_1_z = parameters->base[0][2];
    const pkmodes_real a_2_x = parameters->base[1][0];
    const pkmodes_real a_2_y = parameters->base[1][1];
    const pkmodes_real a_2_z = parameters->base[1][2];
    const pkmodes_real a_3_x = parameters->base[2][0];
    const pkmodes_real a_3_y = parameters->base[2][1];
    const pkmodes_real a_3_z = parameters->base[2][2];
    const pkmodes_real a_4_x = parameters->base[3][0];
    const pkmodes_real a_4_y = parameters->base[3][1];
    const pkmodes_real a_4_z = parameters->base[3][2];
    const pkmodes_real a_5_x = parameters->base[4][0];
    const pkmodes_real a_5_y = parameters->base[4][1];
    const pkmodes_real a_5_z = parameters->base[4][2];
    const pkmodes_real a_6_x = parameters->base[5][0];
    const pkmodes_real a_6_y = parameters->base[5][1];
    const pkmodes_real a_6_z = parameters->base[5][2];
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
    const pkmodes_real k_l_1 = parameters->leg_stiffness[0];
    const pkmodes_real k_l_2 = parameters->leg_stiffness[1];
    const pkmodes_real k_l_3 = parameters->leg_stiffness[2];
    const pkmodes_real k_l_4 = parameters->leg_stiffness[3];
    const pkmodes_real k_l_5 = parameters->leg_stiffness[4];
    const pkmodes_real k_l_6 = parameters->leg_stiffness[5];
    const pkmodes_real m_b_1 = parameters->leg_base_mass[0];
    const pkmodes_real m_b_2 = parameters->leg_base_mass[1];
    const pkmodes_real m_b_3 = parameters->leg_base_mass[2];
    const pkmodes_real m_b_4 = parameters->leg_base_mass[3];
    const pkmodes_real m_b_5 = parameters->leg_base_mass[4];
    const pkmodes_real m_b_6 = parameters->leg_base_mass[5];
    const pkmodes_real c_b_1 = parameters->leg_base_center[0];
    const pkmodes_real c_b_2 = parameters->leg_base_center[1];
    const pkmodes_real c_b_3 = parameters->leg_base_center[2];
    const pkmodes_real c_b_4 = parameters->leg_base_center[3];
    const pkmodes_real c_b_5 = parameters->leg_base_center[4];
    const pkmodes_real c_b_6 = parameters->leg_base_center[5];
    const pkmodes_real I_b_1 = parameters->leg_base_inertia[0];
    const pkmodes_real I_b_2 = parameters->leg_base_inertia[1];
    const pkmodes_real I_b_3 = parameters->leg_base_inertia[2];
    const pkmodes_real I_b_4 = parameters->leg_base_inertia[3];
    const pkmodes_real I_b_5 = parameters->leg_base_inertia[4];
    const pkmodes_real I_b_6 = parameters->leg_base_inertia[5];
    const pkmodes_real m_r_1 = parameters->leg_rod_mass[0];
    const pkmodes_real m_r_2 = parameters->leg_rod_mass[1];
    const pkmodes_real m_r_3 = parameters->leg_rod_mass[2];
    const pkmodes_real m_r_4 = parameters->leg_rod_mass[3];
    const pkmodes_real m_r_5 = parameters->leg_rod_mass[4];
    const pkmodes_real m_r_6 = parameters->leg_rod_mass[5];
    const pkmodes_real c_r_1 = parameters->leg_rod_center[0];
    const pkmodes_real c_r_2 = parameters->leg_rod_center[1];
    const pkmodes_real c_r_3 = parameters->leg_rod_center[2];
    const pkmodes_real c_r_4 = parameters->leg_rod_center[3];
    const pkmodes_real c_r_5 = parameters->leg_rod_center[4];
    const pkmodes_real c_r_6 = parameters->leg_rod_center[5];
    const pkmodes_real I_r_1 = parameters->leg_rod_inertia[0];
    const pkmodes_real I_r_2 = parameters->leg_rod_inertia[1];
    const pkmodes_real I_r_3 = parameters->leg_rod_inertia[2];
    const pkmodes_real I_r_4 = parameters->leg_rod_inertia[3];
    const pkmodes_real I_r_5 = parameters->leg_rod_inertia[4];
    const pkmodes_real I_r_6 = parameters->leg_rod_inertia[5];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real I_m_3 = parameters->motor_inertia[2];
    const pkmodes_real I_m_4 = parameters->motor_inertia[3];
    const pkmodes_real I_m_5 = parameters->motor_inertia[4];
    const pkmodes_real I_m_6 = parameters->motor_inertia[5];
    const pkmodes_real h_m_1 = parameters->motor_travel[0];
    const pkmodes_real h_m_2 = parameters->motor_travel[1];
    const pkmodes_real h_m_3 = parameters->motor_travel[2];
    const pkmodes_real h_m_4 = parameters->motor_travel[3];
    const pkmodes_real h_m_5 = parameters->motor_travel[4];
    const pkmodes_real h_m_6 = parameters->motor_travel[5];
    const pkmodes_real a_S_1 = effects->axis_leg_stiffness_factor_1;
    const pkmodes_real a_S_2 = effects->axis_leg_stiffness_factor_2;
    const pkmodes_real a_S_3 = effects->axis_leg_stiffness_factor_3;
    const pkmodes_real a_S_4 = effects->axis_leg_stiffness_factor_4;
    const pkmodes_real a_S_5 = effects->axis_leg_stiffness_factor_5;
    const pkmodes_real a_S_6 = effects->axis_leg_stiffness_factor_6;
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
    const pkmodes_real d_1_x = B_1_x - a_1_x + p_x;
    const pkmodes_real R_y_x = rot_y*t10 + t8;
    const pkmodes_real R_y_y = t6*(-t1 - t3) + 1;
    const pkmodes_real t11 = rot_x*t7;
    const pkmodes_real R_y_z = (R(1.0)/R(2.0))*rot_y*rot_z*t5 - t11;
    const pkmodes_real B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const pkmodes_real d_1_y = B_1_y - a_1_y + p_y;
    const pkmodes_real R_z_x = (R(1.0)/R(2.0))*rot_x*rot_z*t5 - t9;
    const pkmodes_real R_z_y = rot_y*rot_z*t6 + t11;
    const pkmodes_real R_z_z = t6*(-t1 - t2) + 1;
    const pkmodes_real B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const pkmodes_real d_1_z = B_1_z - a_1_z + p_z;
    const pkmodes_real B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const pkmodes_real d_2_x = B_2_x - a_2_x + p_x;
    const pkmodes_real B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const pkmodes_real d_2_y = B_2_y - a_2_y + p_y;
    const pkmodes_real B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const pkmodes_real d_2_z = B_2_z - a_2_z + p_z;
    const pkmodes_real B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const pkmodes_real d_3_x = B_3_x - a_3_x + p_x;
    const pkmodes_real B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const pkmodes_real d_3_y = B_3_y - a_3_y + p_y;
    const pkmodes_real B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const pkmodes_real d_3_z = B_3_z - a_3_z + p_z;
    const pkmodes_real B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const pkmodes_real d_4_x = B_4_x - a_4_x + p_x;
    const pkmodes_real B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const pkmodes_real d_4_y = B_4_y - a_4_y + p_y;
    const pkmodes_real B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const pkmodes_real d_4_z = B_4_z - a_4_z + p_z;
    const pkmodes_real B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const pkmodes_real d_5_x = B_5_x - a_5_x + p_x;
    const pkmodes_real B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const pkmodes_real d_5_y = B_5_y - a_5_y + p_y;
    const pkmodes_real B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const pkmodes_real d_5_z = B_5_z - a_5_z + p_z;
    const pkmodes_real B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const pkmodes_real d_6_x = B_6_x - a_6_x + p_x;
    const pkmodes_real B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const pkmodes_real d_6_y = B_6_y - a_6_y + p_y;
    const pkmodes_real B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const pkmodes_real d_6_z = B_6_z - a_6_z + p_z;
    const pkmodes_real l_1 = R(sqrt)((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const pkmodes_real l_2 = R(sqrt)((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const pkmodes_real l_3 = R(sqrt)((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const pkmodes_real l_4 = R(sqrt)((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const pkmodes_real l_5 = R(sqrt)((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const pkmodes_real l_6 = R(sqrt)((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
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
    const pkmodes_real t30 = 1/((l_1*l_1));
    const pkmodes_real t31 = 1/l_1;
    const pkmodes_real m_perp_1 =
        I_b_1*t30 + I_r_1*t30 + (c_b_1*c_b_1)*m_b_1*t30 + m_r_1*((-c_r_1*t31 + 1)*(-c_r_1*t31 + 1));
    const pkmodes_real t32 = c_b_1*m_b_1 - c_r_1*m_r_1;
    const pkmodes_real t33 = t31*t32;
    const pkmodes_real m_lift_1 = m_r_1 + t33;
    const pkmodes_real t34 = 1/((l_2*l_2));
    const pkmodes_real t35 = 1/l_2;
    const pkmodes_real m_perp_2 =
        I_b_2*t34 + I_r_2*t34 + (c_b_2*c_b_2)*m_b_2*t34 + m_r_2*((-c_r_2*t35 + 1)*(-c_r_2*t35 + 1));
    const pkmodes_real t36 = c_b_2*m_b_2 - c_r_2*m_r_2;
    const pkmodes_real t37 = t35*t36;
    const pkmodes_real m_lift_2 = m_r_2 + t37;
    const pkmodes_real t38 = 1/((l_3*l_3));
    const pkmodes_real t39 = 1/l_3;
    const pkmodes_real m_perp_3 =
        I_b_3*t38 + I_r_3*t38 + (c_b_3*c_b_3)*m_b_3*t38 + m_r_3*((-c_r_3*t39 + 1)*(-c_r_3*t39 + 1));
    const pkmodes_real t40 = c_b_3*m_b_3 - c_r_3*m_r_3;
    const pkmodes_real t41 = t39*t40;
    const pkmodes_real m_lift_3 = m_r_3 + t41;
    const pkmodes_real t42 = 1/((l_4*l_4));
    const pkmodes_real t43 = 1/l_4;
    const pkmodes_real m_perp_4 =
        I_b_4*t42 + I_r_4*t42 + (c_b_4*c_b_4)*m_b_4*t42 + m_r_4*((-c_r_4*t43 + 1)*(-c_r_4*t43 + 1));
    const pkmodes_real t44 = c_b_4*m_b_4 - c_r_4*m_r_4;
    const pkmodes_real t45 = t43*t44;
    const pkmodes_real m_lift_4 = m_r_4 + t45;
    const pkmodes_real t46 = 1/((l_5*l_5));
    const pkmodes_real t47 = 1/l_5;
    const pkmodes_real m_perp_5 =
        I_b_5*t46 + I_r_5*t46 + (c_b_5*c_b_5)*m_b_5*t46 + m_r_5*((-c_r_5*t47 + 1)*(-c_r_5*t47 + 1));
    const pkmodes_real t48 = c_b_5*m_b_5 - c_r_5*m_r_5;
    const pkmodes_real t49 = t47*t48;
    const pkmodes_real m_lift_5 = m_r_5 + t49;
    const pkmodes_real t50 = 1/((l_6*l_6));
    const pkmodes_real t51 = 1/l_6;
    const pkmodes_real m_perp_6 =
        I_b_6*t50 + I_r_6*t50 + (c_b_6*c_b_6)*m_b_6*t50 + m_r_6*((-c_r_6*t51 + 1)*(-c_r_6*t51 + 1));
    const pkmodes_real t52 = c_b_6*m_b_6 - c_r_6*m_r_6;
    const pkmodes_real t53 = t51*t52;
    const pkmodes_real m_lift_6 = m_r_6 + t53;
    const pkmodes_real o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const pkmodes_real o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const pkmodes_real o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const pkmodes_real D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const pkmodes_real D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const pkmodes_real D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const pkmodes_real D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const pkmodes_real D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const pkmodes_real D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const pkmodes_real D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const pkmodes_real D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const pkmodes_real D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const pkmodes_real D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const pkmodes_real D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const pkmodes_real D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const pkmodes_real D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const pkmodes_real D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const pkmodes_real D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const pkmodes_real D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const pkmodes_real D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const pkmodes_real D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const pkmodes_real minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const pkmodes_real minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const pkmodes_real minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const pkmodes_real minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const pkmodes_real minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const pkmodes_real minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const pkmodes_real minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const pkmodes_real minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const pkmodes_real minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const pkmodes_real minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const pkmodes_real minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const pkmodes_real minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const pkmodes_real minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const pkmodes_real minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const pkmodes_real minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const pkmodes_real minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const pkmodes_real minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const pkmodes_real minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const pkmodes_real minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const pkmodes_real minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const pkmodes_real minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const pkmodes_real minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const pkmodes_real minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const pkmodes_real minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const pkmodes_real minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const pkmodes_real minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const pkmodes_real minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const pkmodes_real minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const pkmodes_real minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const pkmodes_real minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const pkmodes_real A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const pkmodes_real minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const pkmodes_real minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const pkmodes_real minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const pkmodes_real minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const pkmodes_real minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const pkmodes_real minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const pkmodes_real minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const pkmodes_real minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const pkmodes_real minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const pkmodes_real minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const pkmodes_real minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const pkmodes_real minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const pkmodes_real minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const pkmodes_real minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const pkmodes_real A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const pkmodes_real minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const pkmodes_real minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const pkmodes_real minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const pkmodes_real minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const pkmodes_real minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const pkmodes_real A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const pkmodes_real minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
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
    const pkmodes_real minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const pkmodes_real minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const pkmodes_real minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const pkmodes_real minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const pkmodes_real minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const pkmodes_real minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const pkmodes_real minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const pkmodes_real minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const pkmodes_real minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const pkmodes_real minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const pkmodes_real A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const pkmodes_real minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const pkmodes_real minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const pkmodes_real minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const pkmodes_real minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const pkmodes_real A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const pkmodes_real minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
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
    const pkmodes_real minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const pkmodes_real minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const pkmodes_real minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const pkmodes_real minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const pkmodes_real minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const pkmodes_real minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const pkmodes_real minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const pkmodes_real minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const pkmodes_real minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const pkmodes_real minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const pkmodes_real A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const pkmodes_real minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const pkmodes_real minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const pkmodes_real minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const pkmodes_real minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const pkmodes_real A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const pkmodes_real minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
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
    const pkmodes_real minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const pkmodes_real minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const pkmodes_real minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const pkmodes_real minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const pkmodes_real minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const pkmodes_real minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const pkmodes_real minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const pkmodes_real minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const pkmodes_real minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const pkmodes_real minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const pkmodes_real A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const pkmodes_real minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const pkmodes_real minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const pkmodes_real minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const pkmodes_real minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const pkmodes_real minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const pkmodes_real minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const pkmodes_real A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const pkmodes_real minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const pkmodes_real minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const pkmodes_real minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const pkmodes_real A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const pkmodes_real minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
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
    const pkmodes_real minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const pkmodes_real minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const pkmodes_real minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const pkmodes_real minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const pkmodes_real minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const pkmodes_real minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const pkmodes_real minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const pkmodes_real A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const pkmodes_real minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const pkmodes_real minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const pkmodes_real minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const pkmodes_real minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const pkmodes_real A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const pkmodes_real minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
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
    const pkmodes_real minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const pkmodes_real minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const pkmodes_real minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const pkmodes_real minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const pkmodes_real minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const pkmodes_real minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const pkmodes_real minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const pkmodes_real A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const pkmodes_real minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const pkmodes_real minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const pkmodes_real minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const pkmodes_real minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const pkmodes_real A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const pkmodes_real minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
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
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const pkmodes_real t54 = 1/det_D_l;
    const pkmodes_real t55 = l_1*t54;
    const pkmodes_real D_p_x_1 = A_x_1*t55;
    const pkmodes_real t56 = l_2*t54;
    const pkmodes_real D_p_x_2 = A_x_2*t56;
    const pkmodes_real t57 = l_3*t54;
    const pkmodes_real D_p_x_3 = A_x_3*t57;
    const pkmodes_real t58 = l_4*t54;
    const pkmodes_real D_p_x_4 = A_x_4*t58;
    const pkmodes_real t59 = l_5*t54;
    const pkmodes_real D_p_x_5 = A_x_5*t59;
    const pkmodes_real t60 = l_6*t54;
    const pkmodes_real D_p_x_6 = A_x_6*t60;
    const pkmodes_real D_p_y_1 = A_y_1*t55;
    const pkmodes_real D_p_y_2 = A_y_2*t56;
    const pkmodes_real D_p_y_3 = A_y_3*t57;
    const pkmodes_real D_p_y_4 = A_y_4*t58;
    const pkmodes_real D_p_y_5 = A_y_5*t59;
    const pkmodes_real D_p_y_6 = A_y_6*t60;
    const pkmodes_real D_p_z_1 = A_z_1*t55;
    const pkmodes_real D_p_z_2 = A_z_2*t56;
    const pkmodes_real D_p_z_3 = A_z_3*t57;
    const pkmodes_real D_p_z_4 = A_z_4*t58;
    const pkmodes_real D_p_z_5 = A_z_5*t59;
    const pkmodes_real D_p_z_6 = A_z_6*t60;
    const pkmodes_real D_p_rx_1 = A_rx_1*t55;
    const pkmodes_real D_p_rx_2 = A_rx_2*t56;
    const pkmodes_real D_p_rx_3 = A_rx_3*t57;
    const pkmodes_real D_p_rx_4 = A_rx_4*t58;
    const pkmodes_real D_p_rx_5 = A_rx_5*t59;
    const pkmodes_real D_p_rx_6 = A_rx_6*t60;
    const pkmodes_real D_p_ry_1 = A_ry_1*t55;
    const pkmodes_real D_p_ry_2 = A_ry_2*t56;
    const pkmodes_real D_p_ry_3 = A_ry_3*t57;
    const pkmodes_real D_p_ry_4 = A_ry_4*t58;
    const pkmodes_real D_p_ry_5 = A_ry_5*t59;
    const pkmodes_real D_p_ry_6 = A_ry_6*t60;
    const pkmodes_real D_p_rz_1 = A_rz_1*t55;
    const pkmodes_real D_p_rz_2 = A_rz_2*t56;
    const pkmodes_real D_p_rz_3 = A_rz_3*t57;
    const pkmodes_real D_p_rz_4 = A_rz_4*t58;
    const pkmodes_real D_p_rz_5 = A_rz_5*t59;
    const pkmodes_real D_p_rz_6 = A_rz_6*t60;
    const pkmodes_real k_1 = k_l_1*(a_S_1 + 1);
    const pkmodes_real k_2 = k_l_2*(a_S_2 + 1);
    const pkmodes_real k_3 = k_l_3*(a_S_3 + 1);
    const pkmodes_real k_4 = k_l_4*(a_S_4 + 1);
    const pkmodes_real k_5 = k_l_5*(a_S_5 + 1);
    const pkmodes_real k_6 = k_l_6*(a_S_6 + 1);
    const pkmodes_real t61 = g_x*m_lift_1;
    const pkmodes_real t62 = g_x*m_lift_2;
    const pkmodes_real t63 = g_x*m_lift_3;
    const pkmodes_real t64 = g_x*m_lift_4;
    const pkmodes_real t65 = g_x*m_lift_5;
    const pkmodes_real t66 = g_x*m_lift_6;
    const pkmodes_real t67 = m_L + m_p;
    const pkmodes_real G_p_x = -g_x*t67 - t61 - t62 - t63 - t64 - t65 - t66;
    const pkmodes_real t68 = g_y*m_lift_1;
    const pkmodes_real t69 = g_y*m_lift_2;
    const pkmodes_real t70 = g_y*m_lift_3;
    const pkmodes_real t71 = g_y*m_lift_4;
    const pkmodes_real t72 = g_y*m_lift_5;
    const pkmodes_real t73 = g_y*m_lift_6;
    const pkmodes_real G_p_y = -g_y*t67 - t68 - t69 - t70 - t71 - t72 - t73;
    const pkmodes_real t74 = g_z*m_lift_1;
    const pkmodes_real t75 = g_z*m_lift_2;
    const pkmodes_real t76 = g_z*m_lift_3;
    const pkmodes_real t77 = g_z*m_lift_4;
    const pkmodes_real t78 = g_z*m_lift_5;
    const pkmodes_real t79 = g_z*m_lift_6;
    const pkmodes_real G_p_z = -g_z*t67 - t74 - t75 - t76 - t77 - t78 - t79;
    const pkmodes_real t80 = g_z*m_p;
    const pkmodes_real t81 = g_z*m_L;
    const pkmodes_real G_p_rx =
        -B_1_y*t74 + B_1_z*g_y*m_lift_1 - B_2_y*t75 + B_2_z*g_y*m_lift_2 - B_3_y*t76 + B_3_z*g_y*m_lift_3
        - B_4_y*t77 + B_4_z*g_y*m_lift_4 - B_5_y*t78 + B_5_z*g_y*m_lift_5 - B_6_y*t79 + B_6_z*g_y*m_lift_6
        - c_y*t80 + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t81;
    const pkmodes_real t82 = g_x*m_p;
    const pkmodes_real t83 = g_x*m_L;
    const pkmodes_real G_p_ry =
        B_1_x*t74 - B_1_z*t61 + B_2_x*t75 - B_2_z*t62 + B_3_x*t76 - B_3_z*t63 + B_4_x*t77 - B_4_z*t64
        + B_5_x*t78 - B_5_z*t65 + B_6_x*t79 - B_6_z*t66 + c_x*t80 - c_z*t82 + o_L_x*t81 - o_L_z*t83;
    const pkmodes_real t84 = g_y*m_p;
    const pkmodes_real t85 = g_y*m_L;
    const pkmodes_real G_p_rz =
        -B_1_x*t68 + B_1_y*g_x*m_lift_1 - B_2_x*t69 + B_2_y*g_x*m_lift_2 - B_3_x*t70 + B_3_y*g_x*m_lift_3
        - B_4_x*t71 + B_4_y*g_x*m_lift_4 - B_5_x*t72 + B_5_y*g_x*m_lift_5 - B_6_x*t73 + B_6_y*g_x*m_lift_6
        - c_x*t84 + c_y*g_x*m_p + g_x*m_L*o_L_y - o_L_x*t85;
    const pkmodes_real mu_1 =
        t54*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const pkmodes_real mu_2 =
        t54*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const pkmodes_real mu_3 =
        t54*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const pkmodes_real mu_4 =
        t54*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const pkmodes_real mu_5 =
        t54*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const pkmodes_real mu_6 =
        t54*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const pkmodes_real g_4_x = -d_1_x*mu_1 - t61;
    const pkmodes_real g_4_y = -d_1_y*mu_1 - t68;
    const pkmodes_real g_4_z = -d_1_z*mu_1 - t74;
    const pkmodes_real g_5_x = -d_2_x*mu_2 - t62;
    const pkmodes_real g_5_y = -d_2_y*mu_2 - t69;
    const pkmodes_real g_5_z = -d_2_z*mu_2 - t75;
    const pkmodes_real g_6_x = -d_3_x*mu_3 - t63;
    const pkmodes_real g_6_y = -d_3_y*mu_3 - t70;
    const pkmodes_real g_6_z = -d_3_z*mu_3 - t76;
    const pkmodes_real g_7_x = -d_4_x*mu_4 - t64;
    const pkmodes_real g_7_y = -d_4_y*mu_4 - t71;
    const pkmodes_real g_7_z = -d_4_z*mu_4 - t77;
    const pkmodes_real g_8_x = -d_5_x*mu_5 - t65;
    const pkmodes_real g_8_y = -d_5_y*mu_5 - t72;
    const pkmodes_real g_8_z = -d_5_z*mu_5 - t78;
    const pkmodes_real g_9_x = -d_6_x*mu_6 - t66;
    const pkmodes_real g_9_y = -d_6_y*mu_6 - t73;
    const pkmodes_real g_9_z = -d_6_z*mu_6 - t79;
    const pkmodes_real g_10_x = -t82;
    const pkmodes_real g_10_y = -t84;
    const pkmodes_real g_10_z = -t80;
    const pkmodes_real g_11_x = -t83;
    const pkmodes_real g_11_y = -t85;
    const pkmodes_real g_11_z = -t81;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t86 = B_1_z*mu_1;
    const pkmodes_real t87 = B_2_z*mu_2;
    const pkmodes_real t88 = B_3_z*mu_3;
    const pkmodes_real t89 = B_4_z*mu_4;
    const pkmodes_real t90 = B_5_z*mu_5;
    const pkmodes_real t91 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t86 + t87 + t88 + t89 + t90 + t91;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t92 = B_2_y*mu_2;
    const pkmodes_real t93 = B_3_y*mu_3;
    const pkmodes_real t94 = B_4_y*mu_4;
    const pkmodes_real t95 = B_5_y*mu_5;
    const pkmodes_real t96 = B_6_y*mu_6;
    const pkmodes_real t97 = B_1_y*mu_1;
    const pkmodes_real L_x_rz = t92 + t93 + t94 + t95 + t96 + t97;
    const pkmodes_real L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t98 = (B_1_z*B_1_z);
    const pkmodes_real t99 = (B_2_z*B_2_z);
    const pkmodes_real t100 = (B_3_z*B_3_z);
    const pkmodes_real t101 = (B_4_z*B_4_z);
    const pkmodes_real t102 = (B_5_z*B_5_z);
    const pkmodes_real t103 = (B_6_z*B_6_z);
    const pkmodes_real t104 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + g_11_z*o_L_z + mu_1*t98 + mu_2*t99 + mu_3*t100 + mu_4*t101 + mu_5*t102 + mu_6*t103;
    const pkmodes_real t105 = (B_1_y*B_1_y);
    const pkmodes_real t106 = (B_2_y*B_2_y);
    const pkmodes_real t107 = (B_3_y*B_3_y);
    const pkmodes_real t108 = (B_4_y*B_4_y);
    const pkmodes_real t109 = (B_5_y*B_5_y);
    const pkmodes_real t110 = (B_6_y*B_6_y);
    const pkmodes_real t111 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + g_11_y*o_L_y + mu_1*t105 + mu_2*t106 + mu_3*t107 + mu_4*t108 + mu_5*t109 + mu_6*t110;
    const pkmodes_real L_rx_rx = -t104 - t111;
    const pkmodes_real t112 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t113 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t114 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t115 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t116 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t117 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t118 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t119 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t120 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t121 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t122 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t123 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real t124 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t125 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real t126 = (R(1.0)/R(2.0))*g_11_x;
    const pkmodes_real t127 = (R(1.0)/R(2.0))*o_L_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t97 + B_1_y*t113 + B_2_x*t92 + B_2_y*t115 + B_3_x*t93 + B_3_y*t117 + B_4_x*t94 + B_4_y*t119
        + B_5_x*t95 + B_5_y*t121 + B_6_x*t96 + B_6_y*t123 + c_y*t125 + g_10_y*t124 + g_11_y*t127 + g_4_y*t112
        + g_5_y*t114 + g_6_y*t116 + g_7_y*t118 + g_8_y*t120 + g_9_y*t122 + o_L_y*t126;
    const pkmodes_real L_rx_rz =
        B_1_x*t86 + B_1_z*t113 + B_2_x*t87 + B_2_z*t115 + B_3_x*t88 + B_3_z*t117 + B_4_x*t89 + B_4_z*t119
        + B_5_x*t90 + B_5_z*t121 + B_6_x*t91 + B_6_z*t123 + c_z*t125 + g_10_z*t124 + g_11_z*t127 + g_4_z*t112
        + g_5_z*t114 + g_6_z*t116 + g_7_z*t118 + g_8_z*t120 + g_9_z*t122 + o_L_z*t126;
    const pkmodes_real t128 = (B_1_x*B_1_x);
    const pkmodes_real t129 = (B_2_x*B_2_x);
    const pkmodes_real t130 = (B_3_x*B_3_x);
    const pkmodes_real t131 = (B_4_x*B_4_x);
    const pkmodes_real t132 = (B_5_x*B_5_x);
    const pkmodes_real t133 = (B_6_x*B_6_x);
    const pkmodes_real t134 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + g_11_x*o_L_x + mu_1*t128 + mu_2*t129 + mu_3*t130 + mu_4*t131 + mu_5*t132 + mu_6*t133;
    const pkmodes_real L_ry_ry = -t104 - t134;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t86 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t87 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t88
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t89 + (R(1.0)/R(2.0))*B_4_z*g_7_y
        + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t90 + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z
        + B_6_y*t91 + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y
        + (R(1.0)/R(2.0))*g_11_y*o_L_z + (R(1.0)/R(2.0))*g_11_z*o_L_y;
    const pkmodes_real L_rz_rz = -t111 - t134;
    const pkmodes_real t135 = t30*t32;
    const pkmodes_real t136 = g_x*t135;
    const pkmodes_real f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t136;
    const pkmodes_real t137 = t34*t36;
    const pkmodes_real t138 = g_x*t137;
    const pkmodes_real f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t138;
    const pkmodes_real t139 = t38*t40;
    const pkmodes_real t140 = g_x*t139;
    const pkmodes_real f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t140;
    const pkmodes_real t141 = t42*t44;
    const pkmodes_real t142 = g_x*t141;
    const pkmodes_real f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t142;
    const pkmodes_real t143 = t46*t48;
    const pkmodes_real t144 = g_x*t143;
    const pkmodes_real f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t144;
    const pkmodes_real t145 = t50*t52;
    const pkmodes_real t146 = g_x*t145;
    const pkmodes_real f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t146;
    const pkmodes_real t147 = g_y*t135;
    const pkmodes_real f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t147;
    const pkmodes_real t148 = g_y*t137;
    const pkmodes_real f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t148;
    const pkmodes_real t149 = g_y*t139;
    const pkmodes_real f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t149;
    const pkmodes_real t150 = g_y*t141;
    const pkmodes_real f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t150;
    const pkmodes_real t151 = g_y*t143;
    const pkmodes_real f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t151;
    const pkmodes_real t152 = g_y*t145;
    const pkmodes_real f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t152;
    const pkmodes_real t153 = g_z*t135;
    const pkmodes_real f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t153;
    const pkmodes_real t154 = g_z*t137;
    const pkmodes_real f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t154;
    const pkmodes_real t155 = g_z*t139;
    const pkmodes_real f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t155;
    const pkmodes_real t156 = g_z*t141;
    const pkmodes_real f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t156;
    const pkmodes_real t157 = g_z*t143;
    const pkmodes_real f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t157;
    const pkmodes_real t158 = g_z*t145;
    const pkmodes_real f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t158;
    const pkmodes_real t159 = t135*(-B_1_y*g_z + B_1_z*g_y);
    const pkmodes_real f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx - t159;
    const pkmodes_real t160 = t137*(-B_2_y*g_z + B_2_z*g_y);
    const pkmodes_real f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx - t160;
    const pkmodes_real t161 = t139*(-B_3_y*g_z + B_3_z*g_y);
    const pkmodes_real f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx - t161;
    const pkmodes_real t162 = t141*(-B_4_y*g_z + B_4_z*g_y);
    const pkmodes_real f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx - t162;
    const pkmodes_real t163 = t143*(-B_5_y*g_z + B_5_z*g_y);
    const pkmodes_real f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx - t163;
    const pkmodes_real t164 = t145*(-B_6_y*g_z + B_6_z*g_y);
    const pkmodes_real f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx - t164;
    const pkmodes_real t165 = t135*(B_1_x*g_z - B_1_z*g_x);
    const pkmodes_real f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry - t165;
    const pkmodes_real t166 = t137*(B_2_x*g_z - B_2_z*g_x);
    const pkmodes_real f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry - t166;
    const pkmodes_real t167 = t139*(B_3_x*g_z - B_3_z*g_x);
    const pkmodes_real f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry - t167;
    const pkmodes_real t168 = t141*(B_4_x*g_z - B_4_z*g_x);
    const pkmodes_real f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry - t168;
    const pkmodes_real t169 = t143*(B_5_x*g_z - B_5_z*g_x);
    const pkmodes_real f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry - t169;
    const pkmodes_real t170 = t145*(B_6_x*g_z - B_6_z*g_x);
    const pkmodes_real f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry - t170;
    const pkmodes_real t171 = t135*(-B_1_x*g_y + B_1_y*g_x);
    const pkmodes_real f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz - t171;
    const pkmodes_real t172 = t137*(-B_2_x*g_y + B_2_y*g_x);
    const pkmodes_real f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz - t172;
    const pkmodes_real t173 = t139*(-B_3_x*g_y + B_3_y*g_x);
    const pkmodes_real f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz - t173;
    const pkmodes_real t174 = t141*(-B_4_x*g_y + B_4_y*g_x);
    const pkmodes_real f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz - t174;
    const pkmodes_real t175 = t143*(-B_5_x*g_y + B_5_y*g_x);
    const pkmodes_real f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz - t175;
    const pkmodes_real t176 = t145*(-B_6_x*g_y + B_6_y*g_x);
    const pkmodes_real f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz - t176;
    const pkmodes_real M_p_x_x = m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6 + t67;
    const pkmodes_real t177 = B_1_z*m_perp_1;
    const pkmodes_real t178 = B_2_z*m_perp_2;
    const pkmodes_real t179 = B_3_z*m_perp_3;
    const pkmodes_real t180 = B_4_z*m_perp_4;
    const pkmodes_real t181 = B_5_z*m_perp_5;
    const pkmodes_real t182 = B_6_z*m_perp_6;
    const pkmodes_real t183 = c_z*m_p;
    const pkmodes_real t184 = m_L*o_L_z;
    const pkmodes_real M_p_x_ry = t177 + t178 + t179 + t180 + t181 + t182 + t183 + t184;
    const pkmodes_real t185 = B_1_y*m_perp_1;
    const pkmodes_real t186 = B_2_y*m_perp_2;
    const pkmodes_real t187 = B_3_y*m_perp_3;
    const pkmodes_real t188 = B_4_y*m_perp_4;
    const pkmodes_real t189 = B_5_y*m_perp_5;
    const pkmodes_real t190 = B_6_y*m_perp_6;
    const pkmodes_real t191 = c_y*m_p;
    const pkmodes_real t192 = m_L*o_L_y;
    const pkmodes_real M_p_z_rx = t185 + t186 + t187 + t188 + t189 + t190 + t191 + t192;
    const pkmodes_real M_p_x_rz = -M_p_z_rx;
    const pkmodes_real M_p_y_rx = -M_p_x_ry;
    const pkmodes_real t193 = B_1_x*m_perp_1;
    const pkmodes_real t194 = B_2_x*m_perp_2;
    const pkmodes_real t195 = B_3_x*m_perp_3;
    const pkmodes_real t196 = B_4_x*m_perp_4;
    const pkmodes_real t197 = B_5_x*m_perp_5;
    const pkmodes_real t198 = B_6_x*m_perp_6;
    const pkmodes_real M_p_y_rz = c_x*m_p + m_L*o_L_x + t193 + t194 + t195 + t196 + t197 + t198;
    const pkmodes_real M_p_z_ry = -M_p_y_rz;
    const pkmodes_real t199 = 2*(o_L_y*o_L_y);
    const pkmodes_real t200 = 2*(o_L_z*o_L_z);
    const pkmodes_real t201 = (R(1.0)/R(2.0))*m_L;
    const pkmodes_real t202 = 2*(c_y*c_y);
    const pkmodes_real t203 = 2*(c_z*c_z);
    const pkmodes_real t204 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real t205 = 2*t105;
    const pkmodes_real t206 = 2*t98;
    const pkmodes_real t207 = (R(1.0)/R(2.0))*m_perp_1;
    const pkmodes_real t208 = 2*t106;
    const pkmodes_real t209 = 2*t99;
    const pkmodes_real t210 = (R(1.0)/R(2.0))*m_perp_2;
    const pkmodes_real t211 = 2*t107;
    const pkmodes_real t212 = 2*t100;
    const pkmodes_real t213 = (R(1.0)/R(2.0))*m_perp_3;
    const pkmodes_real t214 = 2*t108;
    const pkmodes_real t215 = 2*t101;
    const pkmodes_real t216 = (R(1.0)/R(2.0))*m_perp_4;
    const pkmodes_real t217 = 2*t109;
    const pkmodes_real t218 = 2*t102;
    const pkmodes_real t219 = (R(1.0)/R(2.0))*m_perp_5;
    const pkmodes_real t220 = 2*t110;
    const pkmodes_real t221 = 2*t103;
    const pkmodes_real t222 = (R(1.0)/R(2.0))*m_perp_6;
    const pkmodes_real M_p_rx_rx =
        J_x_x + t201*(t199 + t200) + t204*(t202 + t203) + t207*(t205 + t206) + t210*(t208 + t209)
        + t213*(t211 + t212) + t216*(t214 + t215) + t219*(t217 + t218) + t222*(t220 + t221);
    const pkmodes_real M_p_rx_ry =
        -B_1_x*t185 - B_2_x*t186 - B_3_x*t187 - B_4_x*t188 - B_5_x*t189 - B_6_x*t190 + J_x_y - c_x*t191
        - o_L_x*t192;
    const pkmodes_real M_p_rx_rz =
        -B_1_x*t177 - B_2_x*t178 - B_3_x*t179 - B_4_x*t180 - B_5_x*t181 - B_6_x*t182 + J_x_z - c_x*t183
        - o_L_x*t184;
    const pkmodes_real t223 = 2*(o_L_x*o_L_x);
    const pkmodes_real t224 = 2*(c_x*c_x);
    const pkmodes_real t225 = 2*t128;
    const pkmodes_real t226 = 2*t129;
    const pkmodes_real t227 = 2*t130;
    const pkmodes_real t228 = 2*t131;
    const pkmodes_real t229 = 2*t132;
    const pkmodes_real t230 = 2*t133;
    const pkmodes_real M_p_ry_ry =
        J_y_y + t201*(t200 + t223) + t204*(t203 + t224) + t207*(t206 + t225) + t210*(t209 + t226)
        + t213*(t212 + t227) + t216*(t215 + t228) + t219*(t218 + t229) + t222*(t221 + t230);
    const pkmodes_real M_p_ry_rz =
        -B_1_y*t177 - B_2_y*t178 - B_3_y*t179 - B_4_y*t180 - B_5_y*t181 - B_6_y*t182 + J_y_z - c_y*t183
        - o_L_y*t184;
    const pkmodes_real M_p_rz_rz =
        J_z_z + t201*(t199 + t223) + t204*(t202 + t224) + t207*(t205 + t225) + t210*(t208 + t226)
        + t213*(t211 + t227) + t216*(t214 + t228) + t219*(t217 + t229) + t222*(t220 + t230);
    const pkmodes_real h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const pkmodes_real h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const pkmodes_real h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const pkmodes_real h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const pkmodes_real h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const pkmodes_real h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const pkmodes_real t231 =
        m_lift_1 + m_lift_2 + m_lift_3 + m_lift_4 + m_lift_5 + m_lift_6 - m_perp_1 - m_perp_2 - m_perp_3
        - m_perp_4 - m_perp_5 - m_perp_6;
    const pkmodes_real h_x_u_x = M_p_x_x + t231;
    const pkmodes_real h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const pkmodes_real h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const pkmodes_real h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const pkmodes_real h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const pkmodes_real h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const pkmodes_real h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const pkmodes_real h_y_u_y = M_p_x_x + t231;
    const pkmodes_real h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const pkmodes_real h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const pkmodes_real h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const pkmodes_real h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const pkmodes_real h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const pkmodes_real h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
    const pkmodes_real h_z_u_z = M_p_x_x + t231;
    const pkmodes_real h_rx_l_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx;
    const pkmodes_real h_rx_l_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx;
    const pkmodes_real h_rx_l_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx;
    const pkmodes_real h_rx_l_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx;
    const pkmodes_real h_rx_l_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx;
    const pkmodes_real h_rx_l_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx;
    const pkmodes_real t232 =
        B_1_z*m_r_1 + B_1_z*t33 + B_2_z*m_r_2 + B_2_z*t37 + B_3_z*m_r_3 + B_3_z*t41 + B_4_z*m_r_4 + B_4_z*t45
        + B_5_z*m_r_5 + B_5_z*t49 + B_6_z*m_r_6 + B_6_z*t53 - t177 - t178 - t179 - t180 - t181 - t182;
    const pkmodes_real h_rx_u_y = M_p_y_rx - t232;
    const pkmodes_real t233 =
        B_1_y*m_r_1 + B_1_y*t33 + B_2_y*m_r_2 + B_2_y*t37 + B_3_y*m_r_3 + B_3_y*t41 + B_4_y*m_r_4 + B_4_y*t45
        + B_5_y*m_r_5 + B_5_y*t49 + B_6_y*m_r_6 + B_6_y*t53 - t185 - t186 - t187 - t188 - t189 - t190;
    const pkmodes_real h_rx_u_z = M_p_z_rx + t233;
    const pkmodes_real h_ry_l_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry;
    const pkmodes_real h_ry_l_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry;
    const pkmodes_real h_ry_l_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry;
    const pkmodes_real h_ry_l_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry;
    const pkmodes_real h_ry_l_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry;
    const pkmodes_real h_ry_l_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry;
    const pkmodes_real h_ry_u_x = M_p_x_ry + t232;
    const pkmodes_real t234 =
        B_1_x*m_r_1 + B_1_x*t33 + B_2_x*m_r_2 + B_2_x*t37 + B_3_x*m_r_3 + B_3_x*t41 + B_4_x*m_r_4 + B_4_x*t45
        + B_5_x*m_r_5 + B_5_x*t49 + B_6_x*m_r_6 + B_6_x*t53 - t193 - t194 - t195 - t196 - t197 - t198;
    const pkmodes_real h_ry_u_z = M_p_z_ry - t234;
    const pkmodes_real h_rz_l_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz;
    const pkmodes_real h_rz_l_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz;
    const pkmodes_real h_rz_l_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz;
    const pkmodes_real h_rz_l_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz;
    const pkmodes_real h_rz_l_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz;
    const pkmodes_real h_rz_l_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz;
    const pkmodes_real h_rz_u_x = M_p_x_rz - t233;
    const pkmodes_real h_rz_u_y = M_p_y_rz + t234;
    const pkmodes_real t235 =
        m_F + m_b_1 + m_b_2 + m_b_3 + m_b_4 + m_b_5 + m_b_6 - t33 - t37 - t41 - t45 - t49 - t53;
    const pkmodes_real t236 = D_p_x_1*k_C;
    const pkmodes_real t237 = D_p_y_1*k_C;
    const pkmodes_real t238 = D_p_z_1*k_C;
    const pkmodes_real t239 = D_p_x_2*k_C;
    const pkmodes_real t240 = D_p_y_2*k_C;
    const pkmodes_real t241 = D_p_z_2*k_C;
    const pkmodes_real t242 = D_p_x_3*k_C;
    const pkmodes_real t243 = D_p_y_3*k_C;
    const pkmodes_real t244 = D_p_z_3*k_C;
    const pkmodes_real t245 = D_p_x_4*k_C;
    const pkmodes_real t246 = D_p_y_4*k_C;
    const pkmodes_real t247 = D_p_z_4*k_C;
    const pkmodes_real t248 = D_p_x_5*k_C;
    const pkmodes_real t249 = D_p_y_5*k_C;
    const pkmodes_real t250 = D_p_z_5*k_C;
    memset(M, 0, sizeof(pkmodes_real[15][15]));
    M[0][0] =
        D_p_rx_1*h_rx_l_1 + D_p_ry_1*h_ry_l_1 + D_p_rz_1*h_rz_l_1 + D_p_x_1*h_x_l_1 + D_p_y_1*h_y_l_1
        + D_p_z_1*h_z_l_1 - m_perp_1 + m_r_1;
    M[0][1] = M[1][0] =
        D_p_rx_1*h_rx_l_2 + D_p_ry_1*h_ry_l_2 + D_p_rz_1*h_rz_l_2 + D_p_x_1*h_x_l_2 + D_p_y_1*h_y_l_2
        + D_p_z_1*h_z_l_2;
    M[0][2] = M[2][0] =
        D_p_rx_1*h_rx_l_3 + D_p_ry_1*h_ry_l_3 + D_p_rz_1*h_rz_l_3 + D_p_x_1*h_x_l_3 + D_p_y_1*h_y_l_3
        + D_p_z_1*h_z_l_3;
    M[0][3] = M[3][0] =
        D_p_rx_1*h_rx_l_4 + D_p_ry_1*h_ry_l_4 + D_p_rz_1*h_rz_l_4 + D_p_x_1*h_x_l_4 + D_p_y_1*h_y_l_4
        + D_p_z_1*h_z_l_4;
    M[0][4] = M[4][0] =
        D_p_rx_1*h_rx_l_5 + D_p_ry_1*h_ry_l_5 + D_p_rz_1*h_rz_l_5 + D_p_x_1*h_x_l_5 + D_p_y_1*h_y_l_5
        + D_p_z_1*h_z_l_5;
    M[0][5] = M[5][0] =
        D_p_rx_1*h_rx_l_6 + D_p_ry_1*h_ry_l_6 + D_p_rz_1*h_rz_l_6 + D_p_x_1*h_x_l_6 + D_p_y_1*h_y_l_6
        + D_p_z_1*h_z_l_6;
    M[0][12] = M[12][0] = D_p_ry_1*h_ry_u_x + D_p_rz_1*h_rz_u_x + D_p_x_1*h_x_u_x - d_1_x*t135;
    M[0][13] = M[13][0] = D_p_rx_1*h_rx_u_y + D_p_rz_1*h_rz_u_y + D_p_y_1*h_y_u_y - d_1_y*t135;
    M[0][14] = M[14][0] = D_p_rx_1*h_rx_u_z + D_p_ry_1*h_ry_u_z + D_p_z_1*h_z_u_z - d_1_z*t135;
    M[1][1] =
        D_p_rx_2*h_rx_l_2 + D_p_ry_2*h_ry_l_2 + D_p_rz_2*h_rz_l_2 + D_p_x_2*h_x_l_2 + D_p_y_2*h_y_l_2
        + D_p_z_2*h_z_l_2 - m_perp_2 + m_r_2;
    M[1][2] = M[2][1] =
        D_p_rx_2*h_rx_l_3 + D_p_ry_2*h_ry_l_3 + D_p_rz_2*h_rz_l_3 + D_p_x_2*h_x_l_3 + D_p_y_2*h_y_l_3
        + D_p_z_2*h_z_l_3;
    M[1][3] = M[3][1] =
        D_p_rx_2*h_rx_l_4 + D_p_ry_2*h_ry_l_4 + D_p_rz_2*h_rz_l_4 + D_p_x_2*h_x_l_4 + D_p_y_2*h_y_l_4
        + D_p_z_2*h_z_l_4;
    M[1][4] = M[4][1] =
        D_p_rx_2*h_rx_l_5 + D_p_ry_2*h_ry_l_5 + D_p_rz_2*h_rz_l_5 + D_p_x_2*h_x_l_5 + D_p_y_2*h_y_l_5
        + D_p_z_2*h_z_l_5;
    M[1][5] = M[5][1] =
        D_p_rx_2*h_rx_l_6 + D_p_ry_2*h_ry_l_6 + D_p_rz_2*h_rz_l_6 + D_p_x_2*h_x_l_6 + D_p_y_2*h_y_l_6
        + D_p_z_2*h_z_l_6;
    M[1][12] = M[12][1] = D_p_ry_2*h_ry_u_x + D_p_rz_2*h_rz_u_x + D_p_x_2*h_x_u_x - d_2_x*t137;
    M[1][13] = M[13][1] = D_p_rx_2*h_rx_u_y + D_p_rz_2*h_rz_u_y + D_p_y_2*h_y_u_y - d_2_y*t137;
    M[1][14] = M[14][1] = D_p_rx_2*h_rx_u_z + D_p_ry_2*h_ry_u_z + D_p_z_2*h_z_u_z - d_2_z*t137;
    M[2][2] =
        D_p_rx_3*h_rx_l_3 + D_p_ry_3*h_ry_l_3 + D_p_rz_3*h_rz_l_3 + D_p_x_3*h_x_l_3 + D_p_y_3*h_y_l_3
        + D_p_z_3*h_z_l_3 - m_perp_3 + m_r_3;
    M[2][3] = M[3][2] =
        D_p_rx_3*h_rx_l_4 + D_p_ry_3*h_ry_l_4 + D_p_rz_3*h_rz_l_4 + D_p_x_3*h_x_l_4 + D_p_y_3*h_y_l_4
        + D_p_z_3*h_z_l_4;
    M[2][4] = M[4][2] =
        D_p_rx_3*h_rx_l_5 + D_p_ry_3*h_ry_l_5 + D_p_rz_3*h_rz_l_5 + D_p_x_3*h_x_l_5 + D_p_y_3*h_y_l_5
        + D_p_z_3*h_z_l_5;
    M[2][5] = M[5][2] =
        D_p_rx_3*h_rx_l_6 + D_p_ry_3*h_ry_l_6 + D_p_rz_3*h_rz_l_6 + D_p_x_3*h_x_l_6 + D_p_y_3*h_y_l_6
        + D_p_z_3*h_z_l_6;
    M[2][12] = M[12][2] = D_p_ry_3*h_ry_u_x + D_p_rz_3*h_rz_u_x + D_p_x_3*h_x_u_x - d_3_x*t139;
    M[2][13] = M[13][2] = D_p_rx_3*h_rx_u_y + D_p_rz_3*h_rz_u_y + D_p_y_3*h_y_u_y - d_3_y*t139;
    M[2][14] = M[14][2] = D_p_rx_3*h_rx_u_z + D_p_ry_3*h_ry_u_z + D_p_z_3*h_z_u_z - d_3_z*t139;
    M[3][3] =
        D_p_rx_4*h_rx_l_4 + D_p_ry_4*h_ry_l_4 + D_p_rz_4*h_rz_l_4 + D_p_x_4*h_x_l_4 + D_p_y_4*h_y_l_4
        + D_p_z_4*h_z_l_4 - m_perp_4 + m_r_4;
    M[3][4] = M[4][3] =
        D_p_rx_4*h_rx_l_5 + D_p_ry_4*h_ry_l_5 + D_p_rz_4*h_rz_l_5 + D_p_x_4*h_x_l_5 + D_p_y_4*h_y_l_5
        + D_p_z_4*h_z_l_5;
    M[3][5] = M[5][3] =
        D_p_rx_4*h_rx_l_6 + D_p_ry_4*h_ry_l_6 + D_p_rz_4*h_rz_l_6 + D_p_x_4*h_x_l_6 + D_p_y_4*h_y_l_6
        + D_p_z_4*h_z_l_6;
    M[3][12] = M[12][3] = D_p_ry_4*h_ry_u_x + D_p_rz_4*h_rz_u_x + D_p_x_4*h_x_u_x - d_4_x*t141;
    M[3][13] = M[13][3] = D_p_rx_4*h_rx_u_y + D_p_rz_4*h_rz_u_y + D_p_y_4*h_y_u_y - d_4_y*t141;
    M[3][14] = M[14][3] = D_p_rx_4*h_rx_u_z + D_p_ry_4*h_ry_u_z + D_p_z_4*h_z_u_z - d_4_z*t141;
    M[4][4] =
        D_p_rx_5*h_rx_l_5 + D_p_ry_5*h_ry_l_5 + D_p_rz_5*h_rz_l_5 + D_p_x_5*h_x_l_5 + D_p_y_5*h_y_l_5
        + D_p_z_5*h_z_l_5 - m_perp_5 + m_r_5;
    M[4][5] = M[5][4] =
        D_p_rx_5*h_rx_l_6 + D_p_ry_5*h_ry_l_6 + D_p_rz_5*h_rz_l_6 + D_p_x_5*h_x_l_6 + D_p_y_5*h_y_l_6
        + D_p_z_5*h_z_l_6;
    M[4][12] = M[12][4] = D_p_ry_5*h_ry_u_x + D_p_rz_5*h_rz_u_x + D_p_x_5*h_x_u_x - d_5_x*t143;
    M[4][13] = M[13][4] = D_p_rx_5*h_rx_u_y + D_p_rz_5*h_rz_u_y + D_p_y_5*h_y_u_y - d_5_y*t143;
    M[4][14] = M[14][4] = D_p_rx_5*h_rx_u_z + D_p_ry_5*h_ry_u_z + D_p_z_5*h_z_u_z - d_5_z*t143;
    M[5][5] =
        D_p_rx_6*h_rx_l_6 + D_p_ry_6*h_ry_l_6 + D_p_rz_6*h_rz_l_6 + D_p_x_6*h_x_l_6 + D_p_y_6*h_y_l_6
        + D_p_z_6*h_z_l_6 - m_perp_6 + m_r_6;
    M[5][12] = M[12][5] = D_p_ry_6*h_ry_u_x + D_p_rz_6*h_rz_u_x + D_p_x_6*h_x_u_x - d_6_x*t145;
    M[5][13] = M[13][5] = D_p_rx_6*h_rx_u_y + D_p_rz_6*h_rz_u_y + D_p_y_6*h_y_u_y - d_6_y*t145;
    M[5][14] = M[14][5] = D_p_rx_6*h_rx_u_z + D_p_ry_6*h_ry_u_z + D_p_z_6*h_z_u_z - d_6_z*t145;
    M[6][6] = I_G + I_m_1/(h_m_1*h_m_1);
    M[7][7] = I_G + I_m_2/(h_m_2*h_m_2);
    M[8][8] = I_G + I_m_3/(h_m_3*h_m_3);
    M[9][9] = I_G + I_m_4/(h_m_4*h_m_4);
    M[10][10] = I_G + I_m_5/(h_m_5*h_m_5);
    M[11][11] = I_G + I_m_6/(h_m_6*h_m_6);
    M[12][12] = h_x_u_x + t235;
    M[13][13] = h_y_u_y + t235;
    M[14][14] = h_z_u_z + t235;
    memset(K_el, 0, sizeof(pkmodes_real[15][15]));
    K_el[0][0] = (D_p_x_1*D_p_x_1)*k_C + (D_p_y_1*D_p_y_1)*k_C + (D_p_z_1*D_p_z_1)*k_C + k_1;
    K_el[0][1] = K_el[1][0] = D_p_x_2*t236 + D_p_y_2*t237 + D_p_z_2*t238;
    K_el[0][2] = K_el[2][0] = D_p_x_3*t236 + D_p_y_3*t237 + D_p_z_3*t238;
    K_el[0][3] = K_el[3][0] = D_p_x_4*t236 + D_p_y_4*t237 + D_p_z_4*t238;
    K_el[0][4] = K_el[4][0] = D_p_x_5*t236 + D_p_y_5*t237 + D_p_z_5*t238;
    K_el[0][5] = K_el[5][0] = D_p_x_6*t236 + D_p_y_6*t237 + D_p_z_6*t238;
    K_el[0][6] = K_el[6][0] = -k_1;
    K_el[0][12] = K_el[12][0] = t236;
    K_el[0][13] = K_el[13][0] = t237;
    K_el[0][14] = K_el[14][0] = t238;
    K_el[1][1] = (D_p_x_2*D_p_x_2)*k_C + (D_p_y_2*D_p_y_2)*k_C + (D_p_z_2*D_p_z_2)*k_C + k_2;
    K_el[1][2] = K_el[2][1] = D_p_x_3*t239 + D_p_y_3*t240 + D_p_z_3*t241;
    K_el[1][3] = K_el[3][1] = D_p_x_4*t239 + D_p_y_4*t240 + D_p_z_4*t241;
    K_el[1][4] = K_el[4][1] = D_p_x_5*t239 + D_p_y_5*t240 + D_p_z_5*t241;
    K_el[1][5] = K_el[5][1] = D_p_x_6*t239 + D_p_y_6*t240 + D_p_z_6*t241;
    K_el[1][7] = K_el[7][1] = -k_2;
    K_el[1][12] = K_el[12][1] = t239;
    K_el[1][13] = K_el[13][1] = t240;
    K_el[1][14] = K_el[14][1] = t241;
    K_el[2][2] = (D_p_x_3*D_p_x_3)*k_C + (D_p_y_3*D_p_y_3)*k_C + (D_p_z_3*D_p_z_3)*k_C + k_3;
    K_el[2][3] = K_el[3][2] = D_p_x_4*t242 + D_p_y_4*t243 + D_p_z_4*t244;
    K_el[2][4] = K_el[4][2] = D_p_x_5*t242 + D_p_y_5*t243 + D_p_z_5*t244;
    K_el[2][5] = K_el[5][2] = D_p_x_6*t242 + D_p_y_6*t243 + D_p_z_6*t244;
    K_el[2][8] = K_el[8][2] = -k_3;
    K_el[2][12] = K_el[12][2] = t242;
    K_el[2][13] = K_el[13][2] = t243;
    K_el[2][14] = K_el[14][2] = t244;
    K_el[3][3] = (D_p_x_4*D_p_x_4)*k_C + (D_p_y_4*D_p_y_4)*k_C + (D_p_z_4*D_p_z_4)*k_C + k_4;
    K_el[3][4] = K_el[4][3] = D_p_x_5*t245 + D_p_y_5*t246 + D_p_z_5*t247;
    K_el[3][5] = K_el[5][3] = D_p_x_6*t245 + D_p_y_6*t246 + D_p_z_6*t247;
    K_el[3][9] = K_el[9][3] = -k_4;
    K_el[3][12] = K_el[12][3] = t245;
    K_el[3][13] = K_el[13][3] = t246;
    K_el[3][14] = K_el[14][3] = t247;
    K_el[4][4] = (D_p_x_5*D_p_x_5)*k_C + (D_p_y_5*D_p_y_5)*k_C + (D_p_z_5*D_p_z_5)*k_C + k_5;
    K_el[4][5] = K_el[5][4] = D_p_x_6*t248 + D_p_y_6*t249 + D_p_z_6*t250;
    K_el[4][10] = K_el[10][4] = -k_5;
    K_el[4][12] = K_el[12][4] = t248;
    K_el[4][13] = K_el[13][4] = t249;
    K_el[4][14] = K_el[14][4] = t250;
    K_el[5][5] = (D_p_x_6*D_p_x_6)*k_C + (D_p_y_6*D_p_y_6)*k_C + (D_p_z_6*D_p_z_6)*k_C + k_6;
    K_el[5][11] = K_el[11][5] = -k_6;
    K_el[5][12] = K_el[12][5] = D_p_x_6*k_C;
    K_el[5][13] = K_el[13][5] = D_p_y_6*k_C;
    K_el[5][14] = K_el[14][5] = D_p_z_6*k_C;
    K_el[6][6] = k_1 + k_S;
    K_el[7][7] = k_2 + k_S;
    K_el[8][8] = k_3 + k_S;
    K_el[9][9] = k_4 + k_S;
    K_el[10][10] = k_5 + k_S;
    K_el[11][11] = k_6 + k_S;
    K_el[12][12] = k_C;
    K_el[13][13] = k_C;
    K_el[14][14] = k_C;
    memset(K_g, 0, sizeof(pkmodes_real[15][15]));
    K_g[0][0] =
        D_p_rx_1*f_rx_l_1 - D_p_rx_1*t159 + D_p_ry_1*f_ry_l_1 - D_p_ry_1*t165 + D_p_rz_1*f_rz_l_1
        - D_p_rz_1*t171 + D_p_x_1*f_x_l_1 + D_p_x_1*t136 + D_p_y_1*f_y_l_1 + D_p_y_1*t147 + D_p_z_1*f_z_l_1
        + D_p_z_1*t153 + mu_1 + 2*t32*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1*l_1);
    K_g[0][1] = K_g[1][0] =
        D_p_rx_1*f_rx_l_2 - D_p_rx_2*t159 + D_p_ry_1*f_ry_l_2 - D_p_ry_2*t165 + D_p_rz_1*f_rz_l_2
        - D_p_rz_2*t171 + D_p_x_1*f_x_l_2 + D_p_x_2*t136 + D_p_y_1*f_y_l_2 + D_p_y_2*t147 + D_p_z_1*f_z_l_2
        + D_p_z_2*t153;
    K_g[0][2] = K_g[2][0] =
        D_p_rx_1*f_rx_l_3 - D_p_rx_3*t159 + D_p_ry_1*f_ry_l_3 - D_p_ry_3*t165 + D_p_rz_1*f_rz_l_3
        - D_p_rz_3*t171 + D_p_x_1*f_x_l_3 + D_p_x_3*t136 + D_p_y_1*f_y_l_3 + D_p_y_3*t147 + D_p_z_1*f_z_l_3
        + D_p_z_3*t153;
    K_g[0][3] = K_g[3][0] =
        D_p_rx_1*f_rx_l_4 - D_p_rx_4*t159 + D_p_ry_1*f_ry_l_4 - D_p_ry_4*t165 + D_p_rz_1*f_rz_l_4
        - D_p_rz_4*t171 + D_p_x_1*f_x_l_4 + D_p_x_4*t136 + D_p_y_1*f_y_l_4 + D_p_y_4*t147 + D_p_z_1*f_z_l_4
        + D_p_z_4*t153;
    K_g[0][4] = K_g[4][0] =
        D_p_rx_1*f_rx_l_5 - D_p_rx_5*t159 + D_p_ry_1*f_ry_l_5 - D_p_ry_5*t165 + D_p_rz_1*f_rz_l_5
        - D_p_rz_5*t171 + D_p_x_1*f_x_l_5 + D_p_x_5*t136 + D_p_y_1*f_y_l_5 + D_p_y_5*t147 + D_p_z_1*f_z_l_5
        + D_p_z_5*t153;
    K_g[0][5] = K_g[5][0] =
        D_p_rx_1*f_rx_l_6 - D_p_rx_6*t159 + D_p_ry_1*f_ry_l_6 - D_p_ry_6*t165 + D_p_rz_1*f_rz_l_6
        - D_p_rz_6*t171 + D_p_x_1*f_x_l_6 + D_p_x_6*t136 + D_p_y_1*f_y_l_6 + D_p_y_6*t147 + D_p_z_1*f_z_l_6
        + D_p_z_6*t153;
    K_g[1][1] =
        D_p_rx_2*f_rx_l_2 - D_p_rx_2*t160 + D_p_ry_2*f_ry_l_2 - D_p_ry_2*t166 + D_p_rz_2*f_rz_l_2
        - D_p_rz_2*t172 + D_p_x_2*f_x_l_2 + D_p_x_2*t138 + D_p_y_2*f_y_l_2 + D_p_y_2*t148 + D_p_z_2*f_z_l_2
        + D_p_z_2*t154 + mu_2 + 2*t36*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2*l_2);
    K_g[1][2] = K_g[2][1] =
        D_p_rx_2*f_rx_l_3 - D_p_rx_3*t160 + D_p_ry_2*f_ry_l_3 - D_p_ry_3*t166 + D_p_rz_2*f_rz_l_3
        - D_p_rz_3*t172 + D_p_x_2*f_x_l_3 + D_p_x_3*t138 + D_p_y_2*f_y_l_3 + D_p_y_3*t148 + D_p_z_2*f_z_l_3
        + D_p_z_3*t154;
    K_g[1][3] = K_g[3][1] =
        D_p_rx_2*f_rx_l_4 - D_p_rx_4*t160 + D_p_ry_2*f_ry_l_4 - D_p_ry_4*t166 + D_p_rz_2*f_rz_l_4
        - D_p_rz_4*t172 + D_p_x_2*f_x_l_4 + D_p_x_4*t138 + D_p_y_2*f_y_l_4 + D_p_y_4*t148 + D_p_z_2*f_z_l_4
        + D_p_z_4*t154;
    K_g[1][4] = K_g[4][1] =
        D_p_rx_2*f_rx_l_5 - D_p_rx_5*t160 + D_p_ry_2*f_ry_l_5 - D_p_ry_5*t166 + D_p_rz_2*f_rz_l_5
        - D_p_rz_5*t172 + D_p_x_2*f_x_l_5 + D_p_x_5*t138 + D_p_y_2*f_y_l_5 + D_p_y_5*t148 + D_p_z_2*f_z_l_5
        + D_p_z_5*t154;
    K_g[1][5] = K_g[5][1] =
        D_p_rx_2*f_rx_l_6 - D_p_rx_6*t160 + D_p_ry_2*f_ry_l_6 - D_p_ry_6*t166 + D_p_rz_2*f_rz_l_6
        - D_p_rz_6*t172 + D_p_x_2*f_x_l_6 + D_p_x_6*t138 + D_p_y_2*f_y_l_6 + D_p_y_6*t148 + D_p_z_2*f_z_l_6
        + D_p_z_6*t154;
    K_g[2][2] =
        D_p_rx_3*f_rx_l_3 - D_p_rx_3*t161 + D_p_ry_3*f_ry_l_3 - D_p_ry_3*t167 + D_p_rz_3*f_rz_l_3
        - D_p_rz_3*t173 + D_p_x_3*f_x_l_3 + D_p_x_3*t140 + D_p_y_3*f_y_l_3 + D_p_y_3*t149 + D_p_z_3*f_z_l_3
        + D_p_z_3*t155 + mu_3 + 2*t40*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3*l_3);
    K_g[2][3] = K_g[3][2] =
        D_p_rx_3*f_rx_l_4 - D_p_rx_4*t161 + D_p_ry_3*f_ry_l_4 - D_p_ry_4*t167 + D_p_rz_3*f_rz_l_4
        - D_p_rz_4*t173 + D_p_x_3*f_x_l_4 + D_p_x_4*t140 + D_p_y_3*f_y_l_4 + D_p_y_4*t149 + D_p_z_3*f_z_l_4
        + D_p_z_4*t155;
    K_g[2][4] = K_g[4][2] =
        D_p_rx_3*f_rx_l_5 - D_p_rx_5*t161 + D_p_ry_3*f_ry_l_5 - D_p_ry_5*t167 + D_p_rz_3*f_rz_l_5
        - D_p_rz_5*t173 + D_p_x_3*f_x_l_5 + D_p_x_5*t140 + D_p_y_3*f_y_l_5 + D_p_y_5*t149 + D_p_z_3*f_z_l_5
        + D_p_z_5*t155;
    K_g[2][5] = K_g[5][2] =
        D_p_rx_3*f_rx_l_6 - D_p_rx_6*t161 + D_p_ry_3*f_ry_l_6 - D_p_ry_6*t167 + D_p_rz_3*f_rz_l_6
        - D_p_rz_6*t173 + D_p_x_3*f_x_l_6 + D_p_x_6*t140 + D_p_y_3*f_y_l_6 + D_p_y_6*t149 + D_p_z_3*f_z_l_6
        + D_p_z_6*t155;
    K_g[3][3] =
        D_p_rx_4*f_rx_l_4 - D_p_rx_4*t162 + D_p_ry_4*f_ry_l_4 - D_p_ry_4*t168 + D_p_rz_4*f_rz_l_4
        - D_p_rz_4*t174 + D_p_x_4*f_x_l_4 + D_p_x_4*t142 + D_p_y_4*f_y_l_4 + D_p_y_4*t150 + D_p_z_4*f_z_l_4
        + D_p_z_4*t156 + mu_4 + 2*t44*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4*l_4);
    K_g[3][4] = K_g[4][3] =
        D_p_rx_4*f_rx_l_5 - D_p_rx_5*t162 + D_p_ry_4*f_ry_l_5 - D_p_ry_5*t168 + D_p_rz_4*f_rz_l_5
        - D_p_rz_5*t174 + D_p_x_4*f_x_l_5 + D_p_x_5*t142 + D_p_y_4*f_y_l_5 + D_p_y_5*t150 + D_p_z_4*f_z_l_5
        + D_p_z_5*t156;
    K_g[3][5] = K_g[5][3] =
        D_p_rx_4*f_rx_l_6 - D_p_rx_6*t162 + D_p_ry_4*f_ry_l_6 - D_p_ry_6*t168 + D_p_rz_4*f_rz_l_6
        - D_p_rz_6*t174 + D_p_x_4*f_x_l_6 + D_p_x_6*t142 + D_p_y_4*f_y_l_6 + D_p_y_6*t150 + D_p_z_4*f_z_l_6
        + D_p_z_6*t156;
    K_g[4][4] =
        D_p_rx_5*f_rx_l_5 - D_p_rx_5*t163 + D_p_ry_5*f_ry_l_5 - D_p_ry_5*t169 + D_p_rz_5*f_rz_l_5
        - D_p_rz_5*t175 + D_p_x_5*f_x_l_5 + D_p_x_5*t144 + D_p_y_5*f_y_l_5 + D_p_y_5*t151 + D_p_z_5*f_z_l_5
        + D_p_z_5*t157 + mu_5 + 2*t48*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5*l_5);
    K_g[4][5] = K_g[5][4] =
        D_p_rx_5*f_rx_l_6 - D_p_rx_6*t163 + D_p_ry_5*f_ry_l_6 - D_p_ry_6*t169 + D_p_rz_5*f_rz_l_6
        - D_p_rz_6*t175 + D_p_x_5*f_x_l_6 + D_p_x_6*t144 + D_p_y_5*f_y_l_6 + D_p_y_6*t151 + D_p_z_5*f_z_l_6
        + D_p_z_6*t157;
    K_g[5][5] =
        D_p_rx_6*f_rx_l_6 - D_p_rx_6*t164 + D_p_ry_6*f_ry_l_6 - D_p_ry_6*t170 + D_p_rz_6*f_rz_l_6
        - D_p_rz_6*t176 + D_p_x_6*f_x_l_6 + D_p_x_6*t146 + D_p_y_6*f_y_l_6 + D_p_y_6*t152 + D_p_z_6*f_z_l_6
        + D_p_z_6*t158 + mu_6 + 2*t52*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6*l_6);
}

void hexapod_extended_extended_platform_motion(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real J_p[6][15])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real a_1_x = parameters->base[0][0];
    const pkmodes_real a_1_y = parameters->base[0][1];
    const pkmodes_real a_1_z = parameters->base[0][2];
    const pkmodes_real a_2_x = parameters->base[1][0];
    const pkmodes_real a_2_y = parameters->base[1][1];
    const pkmodes_real a_2_z = parameters->base[1][2];
    const pkmodes_real a_3_x = parameters->base[2][0];
    const pkmodes_real a_3_y = parameters->base[2][1];
    const pkmodes_real a_3_z = parameters->base[2][2];
    const pkmodes_real a_4_x = parameters->base[3][0];
    const pkmodes_real a_4_y = parameters->base[3][1];
    const pkmodes_real a_4_z = parameters->base[3][2];
    const pkmodes_real a_5_x = parameters->base[4][0];
    const pkmodes_real a_5_y = parameters->base[4][1];
    const pkmodes_real a_5_z = parameters->base[4][2];
    const pkmodes_real a_6_x = parameters->base[5][0];
    const pkmodes_real a_6_y = parameters->base[5][1];
    const pkmodes_real a_6_z = parameters->base[5][2];
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
    const pkmodes_real d_1_x = B_1_x - a_1_x + p_x;
    const pkmodes_real R_y_x = rot_y*t10 + t8;
    const pkmodes_real R_y_y = t6*(-t1 - t3) + 1;
    const pkmodes_real t11 = rot_x*t7;
    const pkmodes_real R_y_z = (R(1.0)/R(2.0))*rot_y*rot_z*t5 - t11;
    const pkmodes_real B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const pkmodes_real d_1_y = B_1_y - a_1_y + p_y;
    const pkmodes_real R_z_x = (R(1.0)/R(2.0))*rot_x*rot_z*t5 - t9;
    const pkmodes_real R_z_y = rot_y*rot_z*t6 + t11;
    const pkmodes_real R_z_z = t6*(-t1 - t2) + 1;
    const pkmodes_real B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const pkmodes_real d_1_z = B_1_z - a_1_z + p_z;
    const pkmodes_real B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const pkmodes_real d_2_x = B_2_x - a_2_x + p_x;
    const pkmodes_real B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const pkmodes_real d_2_y = B_2_y - a_2_y + p_y;
    const pkmodes_real B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const pkmodes_real d_2_z = B_2_z - a_2_z + p_z;
    const pkmodes_real B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const pkmodes_real d_3_x = B_3_x - a_3_x + p_x;
    const pkmodes_real B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const pkmodes_real d_3_y = B_3_y - a_3_y + p_y;
    const pkmodes_real B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const pkmodes_real d_3_z = B_3_z - a_3_z + p_z;
    const pkmodes_real B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const pkmodes_real d_4_x = B_4_x - a_4_x + p_x;
    const pkmodes_real B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const pkmodes_real d_4_y = B_4_y - a_4_y + p_y;
    const pkmodes_real B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const pkmodes_real d_4_z = B_4_z - a_4_z + p_z;
    const pkmodes_real B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const pkmodes_real d_5_x = B_5_x - a_5_x + p_x;
    const pkmodes_real B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const pkmodes_real d_5_y = B_5_y - a_5_y + p_y;
    const pkmodes_real B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const pkmodes_real d_5_z = B_5_z - a_5_z + p_z;
    const pkmodes_real B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const pkmodes_real d_6_x = B_6_x - a_6_x + p_x;
    const pkmodes_real B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const pkmodes_real d_6_y = B_6_y - a_6_y + p_y;
    const pkmodes_real B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const pkmodes_real d_6_z = B_6_z - a_6_z + p_z;
    const pkmodes_real l_1 = R(sqrt)((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const pkmodes_real l_2 = R(sqrt)((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const pkmodes_real l_3 = R(sqrt)((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const pkmodes_real l_4 = R(sqrt)((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const pkmodes_real l_5 = R(sqrt)((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const pkmodes_real l_6 = R(sqrt)((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const pkmodes_real D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const pkmodes_real D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const pkmodes_real D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const pkmodes_real D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const pkmodes_real D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const pkmodes_real D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const pkmodes_real D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const pkmodes_real D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const pkmodes_real D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const pkmodes_real D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const pkmodes_real D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const pkmodes_real D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const pkmodes_real D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const pkmodes_real D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const pkmodes_real D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const pkmodes_real D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const pkmodes_real D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const pkmodes_real D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const pkmodes_real minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const pkmodes_real minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const pkmodes_real minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const pkmodes_real minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const pkmodes_real minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const pkmodes_real minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const pkmodes_real minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const pkmodes_real minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const pkmodes_real minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const pkmodes_real minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const pkmodes_real minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const pkmodes_real minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const pkmodes_real minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const pkmodes_real minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const pkmodes_real minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const pkmodes_real minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const pkmodes_real minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const pkmodes_real minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const pkmodes_real minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const pkmodes_real minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const pkmodes_real minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const pkmodes_real minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const pkmodes_real minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const pkmodes_real minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const pkmodes_real minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const pkmodes_real minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const pkmodes_real minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const pkmodes_real minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const pkmodes_real minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const pkmodes_real minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const pkmodes_real A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const pkmodes_real minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const pkmodes_real minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const pkmodes_real minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const pkmodes_real minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const pkmodes_real minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const pkmodes_real minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const pkmodes_real minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const pkmodes_real minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const pkmodes_real minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const pkmodes_real minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const pkmodes_real minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const pkmodes_real minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const pkmodes_real minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const pkmodes_real minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const pkmodes_real A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const pkmodes_real minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const pkmodes_real minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const pkmodes_real minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const pkmodes_real minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const pkmodes_real minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const pkmodes_real A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const pkmodes_real minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
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
    const pkmodes_real minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const pkmodes_real minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const pkmodes_real minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const pkmodes_real minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const pkmodes_real minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const pkmodes_real minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const pkmodes_real minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const pkmodes_real minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const pkmodes_real minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const pkmodes_real minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const pkmodes_real A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const pkmodes_real minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const pkmodes_real minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const pkmodes_real minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const pkmodes_real minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const pkmodes_real A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const pkmodes_real minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
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
    const pkmodes_real minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const pkmodes_real minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const pkmodes_real minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const pkmodes_real minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const pkmodes_real minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const pkmodes_real minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const pkmodes_real minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const pkmodes_real minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const pkmodes_real minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const pkmodes_real minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const pkmodes_real A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const pkmodes_real minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const pkmodes_real minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const pkmodes_real minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const pkmodes_real minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const pkmodes_real A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const pkmodes_real minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
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
    const pkmodes_real minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const pkmodes_real minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const pkmodes_real minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const pkmodes_real minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const pkmodes_real minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const pkmodes_real minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const pkmodes_real minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const pkmodes_real minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const pkmodes_real minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const pkmodes_real minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const pkmodes_real A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const pkmodes_real minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const pkmodes_real minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const pkmodes_real minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const pkmodes_real minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const pkmodes_real minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const pkmodes_real minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const pkmodes_real A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const pkmodes_real minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const pkmodes_real minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const pkmodes_real minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const pkmodes_real A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const pkmodes_real minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
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
    const pkmodes_real minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const pkmodes_real minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const pkmodes_real minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const pkmodes_real minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const pkmodes_real minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const pkmodes_real minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const pkmodes_real minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const pkmodes_real A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const pkmodes_real minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const pkmodes_real minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const pkmodes_real minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const pkmodes_real minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const pkmodes_real A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const pkmodes_real minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
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
    const pkmodes_real minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const pkmodes_real minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const pkmodes_real minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const pkmodes_real minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const pkmodes_real minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const pkmodes_real minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const pkmodes_real minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const pkmodes_real A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const pkmodes_real minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const pkmodes_real minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const pkmodes_real minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const pkmodes_real minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const pkmodes_real A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const pkmodes_real minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
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
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const pkmodes_real t12 = 1/det_D_l;
    const pkmodes_real t13 = l_1*t12;
    const pkmodes_real D_p_x_1 = A_x_1*t13;
    const pkmodes_real t14 = l_2*t12;
    const pkmodes_real D_p_x_2 = A_x_2*t14;
    const pkmodes_real t15 = l_3*t12;
    const pkmodes_real D_p_x_3 = A_x_3*t15;
    const pkmodes_real t16 = l_4*t12;
    const pkmodes_real D_p_x_4 = A_x_4*t16;
    const pkmodes_real t17 = l_5*t12;
    const pkmodes_real D_p_x_5 = A_x_5*t17;
    const pkmodes_real t18 = l_6*t12;
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
    memset(J_p, 0, sizeof(pkmodes_real[6][15]));
    J_p[0][0] = D_p_x_1;
    J_p[0][1] = D_p_x_2;
    J_p[0][2] = D_p_x_3;
    J_p[0][3] = D_p_x_4;
    J_p[0][4] = D_p_x_5;
    J_p[0][5] = D_p_x_6;
    J_p[0][12] = 1;
    J_p[1][0] = D_p_y_1;
    J_p[1][1] = D_p_y_2;
    J_p[1][2] = D_p_y_3;
    J_p[1][3] = D_p_y_4;
    J_p[1][4] = D_p_y_5;
    J_p[1][5] = D_p_y_6;
    J_p[1][13] = 1;
    J_p[2][0] = D_p_z_1;
    J_p[2][1] = D_p_z_2;
    J_p[2][2] = D_p_z_3;
    J_p[2][3] = D_p_z_4;
    J_p[2][4] = D_p_z_5;
    J_p[2][5] = D_p_z_6;
    J_p[2][14] = 1;
    J_p[3][0] = D_p_rx_1;
    J_p[3][1] = D_p_rx_2;
    J_p[3][2] = D_p_rx_3;
    J_p[3][3] = D_p_rx_4;
    J_p[3][4] = D_p_rx_5;
    J_p[3][5] = D_p_rx_6;
    J_p[4][0] = D_p_ry_1;
    J_p[4][1] = D_p_ry_2;
    J_p[4][2] = D_p_ry_3;
    J_p[4][3] = D_p_ry_4;
    J_p[4][4] = D_p_ry_5;
    J_p[4][5] = D_p_ry_6;
    J_p[5][0] = D_p_rz_1;
    J_p[5][1] = D_p_rz_2;
    J_p[5][2] = D_p_rz_3;
    J_p[5][3] = D_p_rz_4;
    J_p[5][4] = D_p_rz_5;
    J_p[5][5] = D_p_rz_6;
}

void hexapod_extended_joint_stiffness(const hexapod_effects *effects, pkmodes_real kappa[3],
    pkmodes_real kappa_c[3])
{
    const pkmodes_real c_F = effects->frame_compliance_compliance;
    const pkmodes_real c_F_x = effects->frame_compliance_compliance_x;
    const pkmodes_real c_F_y = effects->frame_compliance_compliance_y;
    const pkmodes_real c_F_z = effects->frame_compliance_compliance_z;
    const pkmodes_real t1 = c_F + c_F_x;
    const pkmodes_real t2 = c_F + c_F_y;
    const pkmodes_real t3 = c_F + c_F_z;
    kappa[0] = 1/t1;
    kappa[1] = 1/t2;
    kappa[2] = 1/t3;
    kappa_c[0] = -1/(t1*t1);
    kappa_c[1] = -1/(t2*t2);
    kappa_c[2] = -1/(t3*t3);
}

void hexapod_extended_extended_static_equilibrium(const pkmodes_real p[6],
    const hexapod_parameters *parameters, const hexapod_effects *effects, pkmodes_real tau_st[6],
    pkmodes_real theta_st[6])
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
    const pkmodes_real a_1_x = parameters->base[0][0];
    const pkmodes_real a_1_y = parameters->base[0][1];
    const pkmodes_real a_1_z = parameters->base[0][2];
    const pkmodes_real a_2_x = parameters->base[1][0];
    const pkmodes_real a_2_y = parameters->base[1][1];
    const pkmodes_real a_2_z = parameters->base[1][2];
    const pkmodes_real a_3_x = parameters->base[2][0];
    const pkmodes_real a_3_y = parameters->base[2][1];
    const pkmodes_real a_3_z = parameters->base[2][2];
    const pkmodes_real a_4_x = parameters->base[3][0];
    const pkmodes_real a_4_y = parameters->base[3][1];
    const pkmodes_real a_4_z = parameters->base[3][2];
    const pkmodes_real a_5_x = parameters->base[4][0];
    const pkmodes_real a_5_y = parameters->base[4][1];
    const pkmodes_real a_5_z = parameters->base[4][2];
    const pkmodes_real a_6_x = parameters->base[5][0];
    const pkmodes_real a_6_y = parameters->base[5][1];
    const pkmodes_real a_6_z = parameters->base[5][2];
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
    const pkmodes_real k_l_1 = parameters->leg_stiffness[0];
    const pkmodes_real k_l_2 = parameters->leg_stiffness[1];
    const pkmodes_real k_l_3 = parameters->leg_stiffness[2];
    const pkmodes_real k_l_4 = parameters->leg_stiffness[3];
    const pkmodes_real k_l_5 = parameters->leg_stiffness[4];
    const pkmodes_real k_l_6 = parameters->leg_stiffness[5];
    const pkmodes_real m_b_1 = parameters->leg_base_mass[0];
    const pkmodes_real m_b_2 = parameters->leg_base_mass[1];
    const pkmodes_real m_b_3 = parameters->leg_base_mass[2];
    const pkmodes_real m_b_4 = parameters->leg_base_mass[3];
    const pkmodes_real m_b_5 = parameters->leg_base_mass[4];
    const pkmodes_real m_b_6 = parameters->leg_base_mass[5];
    const pkmodes_real c_b_1 = parameters->leg_base_center[0];
    const pkmodes_real c_b_2 = parameters->leg_base_center[1];
    const pkmodes_real c_b_3 = parameters->leg_base_center[2];
    const pkmodes_real c_b_4 = parameters->leg_base_center[3];
    const pkmodes_real c_b_5 = parameters->leg_base_center[4];
    const pkmodes_real c_b_6 = parameters->leg_base_center[5];
    const pkmodes_real m_r_1 = parameters->leg_rod_mass[0];
    const pkmodes_real m_r_2 = parameters->leg_rod_mass[1];
    const pkmodes_real m_r_3 = parameters->leg_rod_mass[2];
    const pkmodes_real m_r_4 = parameters->leg_rod_mass[3];
    const pkmodes_real m_r_5 = parameters->leg_rod_mass[4];
    const pkmodes_real m_r_6 = parameters->leg_rod_mass[5];
    const pkmodes_real c_r_1 = parameters->leg_rod_center[0];
    const pkmodes_real c_r_2 = parameters->leg_rod_center[1];
    const pkmodes_real c_r_3 = parameters->leg_rod_center[2];
    const pkmodes_real c_r_4 = parameters->leg_rod_center[3];
    const pkmodes_real c_r_5 = parameters->leg_rod_center[4];
    const pkmodes_real c_r_6 = parameters->leg_rod_center[5];
    const pkmodes_real a_S_1 = effects->axis_leg_stiffness_factor_1;
    const pkmodes_real a_S_2 = effects->axis_leg_stiffness_factor_2;
    const pkmodes_real a_S_3 = effects->axis_leg_stiffness_factor_3;
    const pkmodes_real a_S_4 = effects->axis_leg_stiffness_factor_4;
    const pkmodes_real a_S_5 = effects->axis_leg_stiffness_factor_5;
    const pkmodes_real a_S_6 = effects->axis_leg_stiffness_factor_6;
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
    const pkmodes_real d_1_x = B_1_x - a_1_x + p_x;
    const pkmodes_real R_y_x = rot_y*t10 + t8;
    const pkmodes_real R_y_y = t6*(-t1 - t3) + 1;
    const pkmodes_real t11 = rot_x*t7;
    const pkmodes_real R_y_z = (R(1.0)/R(2.0))*rot_y*rot_z*t5 - t11;
    const pkmodes_real B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const pkmodes_real d_1_y = B_1_y - a_1_y + p_y;
    const pkmodes_real R_z_x = (R(1.0)/R(2.0))*rot_x*rot_z*t5 - t9;
    const pkmodes_real R_z_y = rot_y*rot_z*t6 + t11;
    const pkmodes_real R_z_z = t6*(-t1 - t2) + 1;
    const pkmodes_real B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const pkmodes_real d_1_z = B_1_z - a_1_z + p_z;
    const pkmodes_real B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const pkmodes_real d_2_x = B_2_x - a_2_x + p_x;
    const pkmodes_real B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const pkmodes_real d_2_y = B_2_y - a_2_y + p_y;
    const pkmodes_real B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const pkmodes_real d_2_z = B_2_z - a_2_z + p_z;
    const pkmodes_real B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const pkmodes_real d_3_x = B_3_x - a_3_x + p_x;
    const pkmodes_real B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const pkmodes_real d_3_y = B_3_y - a_3_y + p_y;
    const pkmodes_real B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const pkmodes_real d_3_z = B_3_z - a_3_z + p_z;
    const pkmodes_real B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const pkmodes_real d_4_x = B_4_x - a_4_x + p_x;
    const pkmodes_real B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const pkmodes_real d_4_y = B_4_y - a_4_y + p_y;
    const pkmodes_real B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const pkmodes_real d_4_z = B_4_z - a_4_z + p_z;
    const pkmodes_real B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const pkmodes_real d_5_x = B_5_x - a_5_x + p_x;
    const pkmodes_real B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const pkmodes_real d_5_y = B_5_y - a_5_y + p_y;
    const pkmodes_real B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const pkmodes_real d_5_z = B_5_z - a_5_z + p_z;
    const pkmodes_real B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const pkmodes_real d_6_x = B_6_x - a_6_x + p_x;
    const pkmodes_real B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const pkmodes_real d_6_y = B_6_y - a_6_y + p_y;
    const pkmodes_real B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const pkmodes_real d_6_z = B_6_z - a_6_z + p_z;
    const pkmodes_real l_1 = R(sqrt)((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const pkmodes_real l_2 = R(sqrt)((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const pkmodes_real l_3 = R(sqrt)((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const pkmodes_real l_4 = R(sqrt)((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const pkmodes_real l_5 = R(sqrt)((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const pkmodes_real l_6 = R(sqrt)((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const pkmodes_real c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const pkmodes_real c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const pkmodes_real c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const pkmodes_real t12 = c_b_1*m_b_1 - c_r_1*m_r_1;
    const pkmodes_real m_lift_1 = m_r_1 + t12/l_1;
    const pkmodes_real t13 = c_b_2*m_b_2 - c_r_2*m_r_2;
    const pkmodes_real m_lift_2 = m_r_2 + t13/l_2;
    const pkmodes_real t14 = c_b_3*m_b_3 - c_r_3*m_r_3;
    const pkmodes_real m_lift_3 = m_r_3 + t14/l_3;
    const pkmodes_real t15 = c_b_4*m_b_4 - c_r_4*m_r_4;
    const pkmodes_real m_lift_4 = m_r_4 + t15/l_4;
    const pkmodes_real t16 = c_b_5*m_b_5 - c_r_5*m_r_5;
    const pkmodes_real m_lift_5 = m_r_5 + t16/l_5;
    const pkmodes_real t17 = c_b_6*m_b_6 - c_r_6*m_r_6;
    const pkmodes_real m_lift_6 = m_r_6 + t17/l_6;
    const pkmodes_real o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const pkmodes_real o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const pkmodes_real o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const pkmodes_real D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const pkmodes_real D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const pkmodes_real D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const pkmodes_real D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const pkmodes_real D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const pkmodes_real D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const pkmodes_real D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const pkmodes_real D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const pkmodes_real D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const pkmodes_real D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const pkmodes_real D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const pkmodes_real D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const pkmodes_real D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const pkmodes_real D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const pkmodes_real D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const pkmodes_real D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const pkmodes_real D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const pkmodes_real D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const pkmodes_real minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const pkmodes_real minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const pkmodes_real minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const pkmodes_real minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const pkmodes_real minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const pkmodes_real minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const pkmodes_real minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const pkmodes_real minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const pkmodes_real minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const pkmodes_real minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const pkmodes_real minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const pkmodes_real minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const pkmodes_real minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const pkmodes_real minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const pkmodes_real minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const pkmodes_real minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const pkmodes_real minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const pkmodes_real minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const pkmodes_real minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const pkmodes_real minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const pkmodes_real minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const pkmodes_real minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const pkmodes_real minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const pkmodes_real minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const pkmodes_real minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const pkmodes_real minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const pkmodes_real minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const pkmodes_real minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const pkmodes_real minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const pkmodes_real minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const pkmodes_real A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const pkmodes_real minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const pkmodes_real minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const pkmodes_real minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const pkmodes_real minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const pkmodes_real minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const pkmodes_real minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const pkmodes_real minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const pkmodes_real minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const pkmodes_real minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const pkmodes_real minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const pkmodes_real minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const pkmodes_real minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const pkmodes_real minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const pkmodes_real minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const pkmodes_real A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const pkmodes_real minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const pkmodes_real minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const pkmodes_real minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const pkmodes_real minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const pkmodes_real minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const pkmodes_real A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const pkmodes_real minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
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
    const pkmodes_real minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const pkmodes_real minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const pkmodes_real minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const pkmodes_real minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const pkmodes_real minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const pkmodes_real minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const pkmodes_real minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const pkmodes_real minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const pkmodes_real minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const pkmodes_real minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const pkmodes_real A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const pkmodes_real minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const pkmodes_real minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const pkmodes_real minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const pkmodes_real minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const pkmodes_real A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const pkmodes_real minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
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
    const pkmodes_real minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const pkmodes_real minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const pkmodes_real minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const pkmodes_real minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const pkmodes_real minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const pkmodes_real minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const pkmodes_real minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const pkmodes_real minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const pkmodes_real minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const pkmodes_real minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const pkmodes_real A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const pkmodes_real minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const pkmodes_real minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const pkmodes_real minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const pkmodes_real minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const pkmodes_real A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const pkmodes_real minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
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
    const pkmodes_real minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const pkmodes_real minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const pkmodes_real minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const pkmodes_real minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const pkmodes_real minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const pkmodes_real minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const pkmodes_real minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const pkmodes_real minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const pkmodes_real minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const pkmodes_real minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const pkmodes_real A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const pkmodes_real minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const pkmodes_real minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const pkmodes_real minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const pkmodes_real minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const pkmodes_real minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const pkmodes_real minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const pkmodes_real A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const pkmodes_real minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const pkmodes_real minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const pkmodes_real minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const pkmodes_real A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const pkmodes_real minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
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
    const pkmodes_real minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const pkmodes_real minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const pkmodes_real minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const pkmodes_real minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const pkmodes_real minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const pkmodes_real minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const pkmodes_real minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const pkmodes_real A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const pkmodes_real minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const pkmodes_real minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const pkmodes_real minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const pkmodes_real minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const pkmodes_real A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const pkmodes_real minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
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
    const pkmodes_real minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const pkmodes_real minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const pkmodes_real minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const pkmodes_real minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const pkmodes_real minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const pkmodes_real minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const pkmodes_real minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const pkmodes_real A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const pkmodes_real minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const pkmodes_real minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const pkmodes_real minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const pkmodes_real minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const pkmodes_real A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const pkmodes_real minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
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
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const pkmodes_real t18 = 1/det_D_l;
    const pkmodes_real t19 = l_1*t18;
    const pkmodes_real D_p_x_1 = A_x_1*t19;
    const pkmodes_real t20 = l_2*t18;
    const pkmodes_real D_p_x_2 = A_x_2*t20;
    const pkmodes_real t21 = l_3*t18;
    const pkmodes_real D_p_x_3 = A_x_3*t21;
    const pkmodes_real t22 = l_4*t18;
    const pkmodes_real D_p_x_4 = A_x_4*t22;
    const pkmodes_real t23 = l_5*t18;
    const pkmodes_real D_p_x_5 = A_x_5*t23;
    const pkmodes_real t24 = l_6*t18;
    const pkmodes_real D_p_x_6 = A_x_6*t24;
    const pkmodes_real D_p_y_1 = A_y_1*t19;
    const pkmodes_real D_p_y_2 = A_y_2*t20;
    const pkmodes_real D_p_y_3 = A_y_3*t21;
    const pkmodes_real D_p_y_4 = A_y_4*t22;
    const pkmodes_real D_p_y_5 = A_y_5*t23;
    const pkmodes_real D_p_y_6 = A_y_6*t24;
    const pkmodes_real D_p_z_1 = A_z_1*t19;
    const pkmodes_real D_p_z_2 = A_z_2*t20;
    const pkmodes_real D_p_z_3 = A_z_3*t21;
    const pkmodes_real D_p_z_4 = A_z_4*t22;
    const pkmodes_real D_p_z_5 = A_z_5*t23;
    const pkmodes_real D_p_z_6 = A_z_6*t24;
    const pkmodes_real D_p_rx_1 = A_rx_1*t19;
    const pkmodes_real D_p_rx_2 = A_rx_2*t20;
    const pkmodes_real D_p_rx_3 = A_rx_3*t21;
    const pkmodes_real D_p_rx_4 = A_rx_4*t22;
    const pkmodes_real D_p_rx_5 = A_rx_5*t23;
    const pkmodes_real D_p_rx_6 = A_rx_6*t24;
    const pkmodes_real D_p_ry_1 = A_ry_1*t19;
    const pkmodes_real D_p_ry_2 = A_ry_2*t20;
    const pkmodes_real D_p_ry_3 = A_ry_3*t21;
    const pkmodes_real D_p_ry_4 = A_ry_4*t22;
    const pkmodes_real D_p_ry_5 = A_ry_5*t23;
    const pkmodes_real D_p_ry_6 = A_ry_6*t24;
    const pkmodes_real D_p_rz_1 = A_rz_1*t19;
    const pkmodes_real D_p_rz_2 = A_rz_2*t20;
    const pkmodes_real D_p_rz_3 = A_rz_3*t21;
    const pkmodes_real D_p_rz_4 = A_rz_4*t22;
    const pkmodes_real D_p_rz_5 = A_rz_5*t23;
    const pkmodes_real D_p_rz_6 = A_rz_6*t24;
    const pkmodes_real k_1 = k_l_1*(a_S_1 + 1);
    const pkmodes_real k_2 = k_l_2*(a_S_2 + 1);
    const pkmodes_real k_3 = k_l_3*(a_S_3 + 1);
    const pkmodes_real k_4 = k_l_4*(a_S_4 + 1);
    const pkmodes_real k_5 = k_l_5*(a_S_5 + 1);
    const pkmodes_real k_6 = k_l_6*(a_S_6 + 1);
    const pkmodes_real t25 = g_x*m_lift_1;
    const pkmodes_real t26 = g_x*m_lift_2;
    const pkmodes_real t27 = g_x*m_lift_3;
    const pkmodes_real t28 = g_x*m_lift_4;
    const pkmodes_real t29 = g_x*m_lift_5;
    const pkmodes_real t30 = g_x*m_lift_6;
    const pkmodes_real t31 = m_L + m_p;
    const pkmodes_real G_p_x = -g_x*t31 - t25 - t26 - t27 - t28 - t29 - t30;
    const pkmodes_real t32 = g_y*m_lift_1;
    const pkmodes_real t33 = g_y*m_lift_2;
    const pkmodes_real t34 = g_y*m_lift_3;
    const pkmodes_real t35 = g_y*m_lift_4;
    const pkmodes_real t36 = g_y*m_lift_5;
    const pkmodes_real t37 = g_y*m_lift_6;
    const pkmodes_real G_p_y = -g_y*t31 - t32 - t33 - t34 - t35 - t36 - t37;
    const pkmodes_real t38 = g_z*m_lift_1;
    const pkmodes_real t39 = g_z*m_lift_2;
    const pkmodes_real t40 = g_z*m_lift_3;
    const pkmodes_real t41 = g_z*m_lift_4;
    const pkmodes_real t42 = g_z*m_lift_5;
    const pkmodes_real t43 = g_z*m_lift_6;
    const pkmodes_real G_p_z = -g_z*t31 - t38 - t39 - t40 - t41 - t42 - t43;
    const pkmodes_real t44 = g_z*m_p;
    const pkmodes_real t45 = g_z*m_L;
    const pkmodes_real G_p_rx =
        -B_1_y*t38 + B_1_z*g_y*m_lift_1 - B_2_y*t39 + B_2_z*g_y*m_lift_2 - B_3_y*t40 + B_3_z*g_y*m_lift_3
        - B_4_y*t41 + B_4_z*g_y*m_lift_4 - B_5_y*t42 + B_5_z*g_y*m_lift_5 - B_6_y*t43 + B_6_z*g_y*m_lift_6
        - c_y*t44 + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t45;
    const pkmodes_real G_p_ry =
        B_1_x*t38 - B_1_z*t25 + B_2_x*t39 - B_2_z*t26 + B_3_x*t40 - B_3_z*t27 + B_4_x*t41 - B_4_z*t28
        + B_5_x*t42 - B_5_z*t29 + B_6_x*t43 - B_6_z*t30 + c_x*t44 - c_z*g_x*m_p - g_x*m_L*o_L_z + o_L_x*t45;
    const pkmodes_real G_p_rz =
        -B_1_x*t32 + B_1_y*g_x*m_lift_1 - B_2_x*t33 + B_2_y*g_x*m_lift_2 - B_3_x*t34 + B_3_y*g_x*m_lift_3
        - B_4_x*t35 + B_4_y*g_x*m_lift_4 - B_5_x*t36 + B_5_y*g_x*m_lift_5 - B_6_x*t37 + B_6_y*g_x*m_lift_6
        - c_x*g_y*m_p + c_y*g_x*m_p + g_x*m_L*o_L_y - g_y*m_L*o_L_x;
    const pkmodes_real G_1 =
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - t12*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1);
    const pkmodes_real G_2 =
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - t13*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2);
    const pkmodes_real G_3 =
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - t14*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3);
    const pkmodes_real G_4 =
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - t15*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4);
    const pkmodes_real G_5 =
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - t16*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5);
    const pkmodes_real G_6 =
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - t17*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6);
    const pkmodes_real s_1_st = G_1/k_1;
    const pkmodes_real s_2_st = G_2/k_2;
    const pkmodes_real s_3_st = G_3/k_3;
    const pkmodes_real s_4_st = G_4/k_4;
    const pkmodes_real s_5_st = G_5/k_5;
    const pkmodes_real s_6_st = G_6/k_6;
    const pkmodes_real f_st_1 = k_1*s_1_st;
    const pkmodes_real f_st_2 = k_2*s_2_st;
    const pkmodes_real f_st_3 = k_3*s_3_st;
    const pkmodes_real f_st_4 = k_4*s_4_st;
    const pkmodes_real f_st_5 = k_5*s_5_st;
    const pkmodes_real f_st_6 = k_6*s_6_st;
    tau_st[0] = f_st_1;
    tau_st[1] = f_st_2;
    tau_st[2] = f_st_3;
    tau_st[3] = f_st_4;
    tau_st[4] = f_st_5;
    tau_st[5] = f_st_6;
    theta_st[0] = s_1_st;
    theta_st[1] = s_2_st;
    theta_st[2] = s_3_st;
    theta_st[3] = s_4_st;
    theta_st[4] = s_5_st;
    theta_st[5] = s_6_st;
}
