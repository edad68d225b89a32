/* Generated from the derivation of bed_slinger.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism bed_slinger, for a robot given by its parameters.
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

#include "bed_slinger.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void bed_slinger_inverse_kinematics(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real xy[2])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    (void)parameters;
    xy[0] = x;
    xy[1] = y;
}

void bed_slinger_travel_margin(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real margin[2][2])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real travel_min_x = parameters->workspace[0][0];
    const pkmodes_real travel_max_x = parameters->workspace[0][1];
    const pkmodes_real travel_min_y = parameters->workspace[1][0];
    const pkmodes_real travel_max_y = parameters->workspace[1][1];
    margin[0][0] = -travel_min_x + x;
    margin[0][1] = travel_max_x - x;
    margin[1][0] = -travel_min_y + y;
    margin[1][1] = travel_max_y - y;
}

void bed_slinger_run_margin(const bed_slinger_parameters *parameters, pkmodes_real margin[2][2])
{
    const pkmodes_real l_0_1_1 = parameters->axis_lengths[0][0];
    const pkmodes_real l_0_1_2 = parameters->axis_lengths[0][1];
    const pkmodes_real l_0_2_1 = parameters->axis_lengths[1][0];
    const pkmodes_real l_0_2_2 = parameters->axis_lengths[1][1];
    const pkmodes_real travel_min_x = parameters->workspace[0][0];
    const pkmodes_real travel_max_x = parameters->workspace[0][1];
    const pkmodes_real travel_min_y = parameters->workspace[1][0];
    const pkmodes_real travel_max_y = parameters->workspace[1][1];
    margin[0][0] = l_0_1_1 + travel_min_x;
    margin[0][1] = l_0_1_2 - travel_max_x;
    margin[1][0] = l_0_2_1 + travel_min_y;
    margin[1][1] = l_0_2_2 - travel_max_y;
}

void bed_slinger_belt_spans(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real l_f[2][2])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real l_0_1_1 = parameters->axis_lengths[0][0];
    const pkmodes_real l_0_1_2 = parameters->axis_lengths[0][1];
    const pkmodes_real l_0_2_1 = parameters->axis_lengths[1][0];
    const pkmodes_real l_0_2_2 = parameters->axis_lengths[1][1];
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    l_f[0][0] = l_f_1_1;
    l_f[0][1] = l_f_1_2;
    l_f[1][0] = l_f_2_1;
    l_f[1][1] = l_f_2_2;
}

void bed_slinger_platform_jacobian(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real D_p[2][2])
{
    (void)p;
    (void)parameters;
    memset(D_p, 0, sizeof(pkmodes_real[2][2]));
    D_p[0][0] = 1;
    D_p[1][1] = 1;
}

void bed_slinger_platform_jacobian_rate(const pkmodes_real p[2], const pkmodes_real xy_dot[2],
    const bed_slinger_parameters *parameters, pkmodes_real D_p_dot[2][2])
{
    (void)p;
    (void)xy_dot;
    (void)parameters;
    memset(D_p_dot, 0, sizeof(pkmodes_real[2][2]));
}

void bed_slinger_platform_second_derivatives(const pkmodes_real p[2],
    const bed_slinger_parameters *parameters, pkmodes_real P[2][2][2])
{
    (void)p;
    (void)parameters;
    memset(P, 0, sizeof(pkmodes_real[2][2][2]));
}

void bed_slinger_kinetic_energy(const pkmodes_real p[2], const pkmodes_real q_dot[4],
    const bed_slinger_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t)
{
    (void)p;
    const pkmodes_real x_dot = q_dot[0];
    const pkmodes_real y_dot = q_dot[1];
    const pkmodes_real theta_1_dot = q_dot[2];
    const pkmodes_real theta_2_dot = q_dot[3];
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_b = parameters->bed_mass;
    const pkmodes_real I_p_1 = parameters->pulley_inertia[0];
    const pkmodes_real I_p_2 = parameters->pulley_inertia[1];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real I_1 = I_m_1*(i_g_1*i_g_1) + I_p_1;
    const pkmodes_real I_2 = I_m_2*(i_g_2*i_g_2) + I_p_2;
    *T_ss = (R(1.0)/R(2.0))*m_b*(y_dot*y_dot) + (R(1.0)/R(2.0))*m_h*(x_dot*x_dot);
    *T_t = (R(1.0)/R(2.0))*I_1*(theta_1_dot*theta_1_dot) + (R(1.0)/R(2.0))*I_2*(theta_2_dot*theta_2_dot);
}

void bed_slinger_mass_matrix(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real M[4][4])
{
    (void)p;
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_b = parameters->bed_mass;
    const pkmodes_real I_p_1 = parameters->pulley_inertia[0];
    const pkmodes_real I_p_2 = parameters->pulley_inertia[1];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real I_1 = I_m_1*(i_g_1*i_g_1) + I_p_1;
    const pkmodes_real I_2 = I_m_2*(i_g_2*i_g_2) + I_p_2;
    memset(M, 0, sizeof(pkmodes_real[4][4]));
    M[0][0] = m_h;
    M[1][1] = m_b;
    M[2][2] = I_1;
    M[3][3] = I_2;
}

void bed_slinger_velocity_forces(const pkmodes_real p[2], const pkmodes_real xy_dot[2],
    const bed_slinger_parameters *parameters, pkmodes_real h[2])
{
    (void)p;
    (void)xy_dot;
    (void)parameters;
    memset(h, 0, sizeof(pkmodes_real[2]));
}

void bed_slinger_gravity_potential(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real *V_g)
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_b = parameters->bed_mass;
    const pkmodes_real g_x = parameters->gravity[0];
    const pkmodes_real g_y = parameters->gravity[1];
    *V_g = -g_x*m_h*x - g_y*m_b*y;
}

void bed_slinger_gravity_gradient(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real G[2])
{
    (void)p;
    const pkmodes_real m_h = parameters->toolhead_mass;
    const pkmodes_real m_b = parameters->bed_mass;
    const pkmodes_real g_x = parameters->gravity[0];
    const pkmodes_real g_y = parameters->gravity[1];
    G[0] = -g_x*m_h;
    G[1] = -g_y*m_b;
}

void bed_slinger_gravity_hessian(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real H_g[2][2])
{
    (void)p;
    (void)parameters;
    memset(H_g, 0, sizeof(pkmodes_real[2][2]));
}

void bed_slinger_belt_stiffness(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real k[2][2])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real l_0_1_1 = parameters->axis_lengths[0][0];
    const pkmodes_real l_0_1_2 = parameters->axis_lengths[0][1];
    const pkmodes_real l_0_2_1 = parameters->axis_lengths[1][0];
    const pkmodes_real l_0_2_2 = parameters->axis_lengths[1][1];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t2 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t2/l_f_2_1;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t2/l_f_2_2;
    k[0][0] = k_1_1;
    k[0][1] = k_1_2;
    k[1][0] = k_2_1;
    k[1][1] = k_2_2;
}

void bed_slinger_elastic_potential(const pkmodes_real p[2], const pkmodes_real delta_q[4],
    const bed_slinger_parameters *parameters, pkmodes_real *V_el)
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real delta_x = delta_q[0];
    const pkmodes_real delta_y = delta_q[1];
    const pkmodes_real delta_theta_1 = delta_q[2];
    const pkmodes_real delta_theta_2 = delta_q[3];
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
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t2 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t2/l_f_2_1;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t2/l_f_2_2;
    const pkmodes_real t3 = (R(1.0)/R(2.0))*((R_p_1*delta_theta_1 + delta_x)*(R_p_1*delta_theta_1 + delta_x));
    const pkmodes_real t4 = (R(1.0)/R(2.0))*((R_p_2*delta_theta_2 + delta_y)*(R_p_2*delta_theta_2 + delta_y));
    *V_el = k_1_1*t3 + k_1_2*t3 + k_2_1*t4 + k_2_2*t4;
}

void bed_slinger_elastic_gradient(const pkmodes_real p[2], const pkmodes_real delta_q[4],
    const bed_slinger_parameters *parameters, pkmodes_real E[4])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
    const pkmodes_real delta_x = delta_q[0];
    const pkmodes_real delta_y = delta_q[1];
    const pkmodes_real delta_theta_1 = delta_q[2];
    const pkmodes_real delta_theta_2 = delta_q[3];
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
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t2 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t2/l_f_2_1;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t2/l_f_2_2;
    const pkmodes_real t3 = R_p_1*delta_theta_1;
    const pkmodes_real t4 = delta_x + t3;
    const pkmodes_real t5 = R_p_2*delta_theta_2;
    const pkmodes_real t6 = delta_y + t5;
    const pkmodes_real t7 = R_p_1*(delta_x + t3);
    const pkmodes_real t8 = R_p_2*(delta_y + t5);
    E[0] = k_1_1*t4 + k_1_2*t4;
    E[1] = k_2_1*t6 + k_2_2*t6;
    E[2] = k_1_1*t7 + k_1_2*t7;
    E[3] = k_2_1*t8 + k_2_2*t8;
}

void bed_slinger_elastic_hessian(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real H_el[4][4])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
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
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t2 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t2/l_f_2_1;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t2/l_f_2_2;
    const pkmodes_real t3 = (R_p_1*R_p_1);
    const pkmodes_real t4 = (R_p_2*R_p_2);
    memset(H_el, 0, sizeof(pkmodes_real[4][4]));
    H_el[0][0] = k_1_1 + k_1_2;
    H_el[0][2] = H_el[2][0] = R_p_1*k_1_1 + R_p_1*k_1_2;
    H_el[1][1] = k_2_1 + k_2_2;
    H_el[1][3] = H_el[3][1] = R_p_2*k_2_1 + R_p_2*k_2_2;
    H_el[2][2] = k_1_1*t3 + k_1_2*t3;
    H_el[3][3] = k_2_1*t4 + k_2_2*t4;
}

void bed_slinger_static_equilibrium(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real tau_st[2], pkmodes_real theta_st[2])
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
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t2 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t2/l_f_2_1;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t2/l_f_2_2;
    const pkmodes_real G_1 = -g_x*m_h;
    const pkmodes_real G_2 = -g_y*m_b;
    const pkmodes_real theta_1_st = -G_1/(R_p_1*k_1_1 + R_p_1*k_1_2);
    const pkmodes_real theta_2_st = -G_2/(R_p_2*k_2_1 + R_p_2*k_2_2);
    const pkmodes_real t3 = (R_p_1*R_p_1)*theta_1_st;
    const pkmodes_real tau_st_1 = k_1_1*t3 + k_1_2*t3;
    const pkmodes_real t4 = (R_p_2*R_p_2)*theta_2_st;
    const pkmodes_real tau_st_2 = k_2_1*t4 + k_2_2*t4;
    tau_st[0] = tau_st_1;
    tau_st[1] = tau_st_2;
    theta_st[0] = theta_1_st;
    theta_st[1] = theta_2_st;
}

void bed_slinger_stiffness_matrix(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real K[4][4])
{
    const pkmodes_real x = p[0];
    const pkmodes_real y = p[1];
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
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t2 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t2/l_f_2_1;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t2/l_f_2_2;
    const pkmodes_real t3 = (R_p_1*R_p_1);
    const pkmodes_real t4 = (R_p_2*R_p_2);
    memset(K, 0, sizeof(pkmodes_real[4][4]));
    K[0][0] = k_1_1 + k_1_2;
    K[0][2] = K[2][0] = R_p_1*k_1_1 + R_p_1*k_1_2;
    K[1][1] = k_2_1 + k_2_2;
    K[1][3] = K[3][1] = R_p_2*k_2_1 + R_p_2*k_2_2;
    K[2][2] = k_1_1*t3 + k_1_2*t3;
    K[3][3] = k_2_1*t4 + k_2_2*t4;
}

void bed_slinger_modal_matrices(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real M[4][4], pkmodes_real K[4][4])
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
    const pkmodes_real I_1 = I_m_1*(i_g_1*i_g_1) + I_p_1;
    const pkmodes_real I_2 = I_m_2*(i_g_2*i_g_2) + I_p_2;
    const pkmodes_real l_f_1_1 = l_0_1_1 + x;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real l_f_1_2 = l_0_1_2 - x;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_2_1 = l_0_2_1 + y;
    const pkmodes_real t2 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t2/l_f_2_1;
    const pkmodes_real l_f_2_2 = l_0_2_2 - y;
    const pkmodes_real k_2_2 = t2/l_f_2_2;
    const pkmodes_real t3 = (R_p_1*R_p_1);
    const pkmodes_real t4 = (R_p_2*R_p_2);
    memset(M, 0, sizeof(pkmodes_real[4][4]));
    M[0][0] = m_h;
    M[1][1] = m_b;
    M[2][2] = I_1;
    M[3][3] = I_2;
    memset(K, 0, sizeof(pkmodes_real[4][4]));
    K[0][0] = k_1_1 + k_1_2;
    K[0][2] = K[2][0] = R_p_1*k_1_1 + R_p_1*k_1_2;
    K[1][1] = k_2_1 + k_2_2;
    K[1][3] = K[3][1] = R_p_2*k_2_1 + R_p_2*k_2_2;
    K[2][2] = k_1_1*t3 + k_1_2*t3;
    K[3][3] = k_2_1*t4 + k_2_2*t4;
}

/* Coordinates, and the most iterations for one eigenvalue; two are usual. */
enum { N = BED_SLINGER_COORDINATES, EIGEN_ITERATIONS = 60 };

/* Rounding, the relative difference up to which components of a shape count as equal, and the fraction of the
 * largest eigenvalue that those of vibrations must have: below it, rounding leaves a frequency fewer than six
 * digits, in single precision hardly two. */
#ifdef PKMODES_FLOAT
#define EIGEN_EPSILON 1.1920929e-07f
#define EIGEN_TIE 1e-4f
#define EIGEN_RESOLVED 1e-5f
#else
#define EIGEN_EPSILON 2.220446049250313e-16
#define EIGEN_TIE 1e-6
#define EIGEN_RESOLVED 1e-9
#endif

/* The symmetric eigenproblem K phi = lambda M phi: M is scaled and factored (Cholesky), K reduced to a
 * tridiagonal matrix by Householder reflections, and that diagonalised by the implicit QL method.  The lower
 * triangle of symmetric matrices is used, and of all arrays the first n <= N rows and columns.  Functions
 * that can fail return -1. */
static int eigen_factor(int n, pkmodes_real M[N][N], pkmodes_real scale[])
{
    int i, j, k;
    for (i = 0; i < n; ++i) {
        if (!(M[i][i] > 0))
            return -1;
        scale[i] = 1/R(sqrt)(M[i][i]);
    }
    for (i = 0; i < n; ++i)
        for (j = 0; j <= i; ++j)
            M[i][j] *= scale[i]*scale[j];
    for (j = 0; j < n; ++j) { /* the diagonal of the factor is inverted */
        pkmodes_real pivot = M[j][j];
        for (k = 0; k < j; ++k)
            pivot -= M[j][k]*M[j][k];
        if (!(pivot > 0))
            return -1;
        M[j][j] = 1/R(sqrt)(pivot);
        for (i = j + 1; i < n; ++i) {
            for (k = 0; k < j; ++k)
                M[i][j] -= M[i][k]*M[j][k];
            M[i][j] *= M[j][j];
        }
    }
    return 0;
}

static void eigen_reduce(int n, pkmodes_real L[N][N], const pkmodes_real scale[], pkmodes_real K[N][N])
{
    int i, j, k;
    for (i = 0; i < n; ++i)
        for (j = 0; j <= i; ++j)
            K[i][j] *= scale[i]*scale[j];
    for (j = 0; j < n; ++j)
        for (i = j; i < n; ++i) {
            for (k = 0; k < j; ++k)
                K[i][j] -= L[j][k]*K[i][k];
            K[i][j] *= L[j][j];
        }
    for (j = 0; j < n; ++j)
        for (i = j; i < n; ++i) {
            for (k = 0; k < j; ++k)
                K[i][j] -= L[i][k]*K[j][k];
            for (k = j; k < i; ++k)
                K[i][j] -= L[i][k]*K[k][j];
            K[i][j] *= L[i][i];
        }
}

static void eigen_tridiagonal(
    int n, pkmodes_real A[N][N], pkmodes_real d[], pkmodes_real e[], pkmodes_real beta[])
{
    pkmodes_real w[N];
    int i, j, k;
    for (k = 0; k + 2 < n; ++k) {
        const pkmodes_real first = A[k + 1][k];
        pkmodes_real rest = 0, along = 0, norm;
        for (i = k + 2; i < n; ++i)
            rest += A[i][k]*A[i][k];
        norm = R(copysign)(R(sqrt)(first*first + rest), first);
        d[k] = A[k][k];
        e[k] = rest > 0 ? -norm : first;
        beta[k] = rest > 0 ? 1/(norm*(first + norm)) : 0;
        A[k + 1][k] = first + norm;
        for (i = k + 1; i < n; ++i) {
            w[i] = 0;
            for (j = k + 1; j < n; ++j)
                w[i] += (j < i ? A[i][j] : A[j][i])*A[j][k];
            w[i] *= beta[k];
            along += w[i]*A[i][k];
        }
        for (i = k + 1; i < n; ++i)
            w[i] -= R(0.5)*beta[k]*along*A[i][k];
        for (i = k + 1; i < n; ++i)
            for (j = k + 1; j <= i; ++j)
                A[i][j] -= A[i][k]*w[j] + w[i]*A[j][k];
    }
    for (k = n > 2 ? n - 2 : 0; k < n; ++k)
        d[k] = A[k][k];
    for (k = n > 2 ? n - 2 : 0; k < n; ++k)
        e[k] = k + 1 < n ? A[k + 1][k] : 0;
}

/* Columns of the inverse factor, transposed, times the reflections: rows of Z. */
static void eigen_vectors(
    int n, pkmodes_real L[N][N], pkmodes_real A[N][N], const pkmodes_real beta[], pkmodes_real Z[N][N])
{
    int c, i, k;
    for (c = 0; c < n; ++c)
        for (i = n - 1; i >= 0; --i) {
            Z[c][i] = i == c ? 1 : 0;
            for (k = i + 1; k <= c; ++k)
                Z[c][i] -= L[k][i]*Z[c][k];
            Z[c][i] *= i <= c ? L[i][i] : 0;
        }
    for (k = 0; k + 2 < n; ++k)
        for (i = 0; i < n; ++i) {
            pkmodes_real sum = 0;
            for (c = k + 1; c < n; ++c)
                sum += Z[c][i]*A[c][k];
            for (c = k + 1; c < n; ++c)
                Z[c][i] -= beta[k]*sum*A[c][k];
        }
}

static int eigen_ql(int n, pkmodes_real d[], pkmodes_real e[], pkmodes_real (*Z)[N])
{
    int i, k, l, m, iteration;
    for (l = 0; l < n; ++l)
        for (iteration = 0;; ++iteration) {
            pkmodes_real g, s = 1, c = 1, p = 0, half;
            for (m = l; m < n - 1; ++m)
                if (!(R(fabs)(e[m]) > EIGEN_EPSILON*(R(fabs)(d[m]) + R(fabs)(d[m + 1]))))
                    break;
            if (m == l)
                break;
            if (iteration == EIGEN_ITERATIONS)
                return -1;
            half = (d[l + 1] - d[l])/(2*e[l]);
            g = d[m] - d[l] + e[l]/(half + R(copysign)(R(sqrt)(half*half + 1), half));
            for (i = m - 1; i >= l; --i) {
                const pkmodes_real f = s*e[i], b = c*e[i], r = R(sqrt)(f*f + g*g);
                pkmodes_real h, t;
                if (i + 1 < m)
                    e[i + 1] = r;
                if (r == 0) { /* the matrix splits here */
                    d[i + 1] -= p;
                    break;
                }
                s = f/r;
                c = g/r;
                h = d[i + 1] - p;
                t = (d[i] - h)*s + 2*c*b;
                p = s*t;
                d[i + 1] = h + p;
                g = c*t - b;
                for (k = 0; Z && k < n; ++k) {
                    const pkmodes_real x = Z[i + 1][k], y = Z[i][k];
                    Z[i + 1][k] = s*y + c*x;
                    Z[i][k] = c*y - s*x;
                }
            }
            if (i < l) {
                d[l] -= p;
                e[l] = g;
            }
            e[m] = 0;
        }
    return 0;
}

/* Sort, and choose signs: the first of a shape's largest components, in units of the scale, is positive. */
static void eigen_order(int n, pkmodes_real d[], pkmodes_real (*Z)[N], const pkmodes_real scale[])
{
    int i, j, k;
    for (i = 1; i < n; ++i)
        for (j = i; j > 0 && d[j] < d[j - 1]; --j) {
            const pkmodes_real value = d[j];
            d[j] = d[j - 1];
            d[j - 1] = value;
            for (k = 0; Z && k < n; ++k) {
                const pkmodes_real x = Z[j][k];
                Z[j][k] = Z[j - 1][k];
                Z[j - 1][k] = x;
            }
        }
    for (i = 0; Z && i < n; ++i) {
        pkmodes_real largest = 0, sign = 1;
        for (k = 0; k < n; ++k)
            largest = R(fmax)(largest, R(fabs)(Z[i][k]));
        for (k = n - 1; k >= 0; --k)
            if (R(fabs)(Z[i][k]) >= (1 - EIGEN_TIE)*largest)
                sign = Z[i][k];
        for (k = 0; k < n; ++k)
            Z[i][k] *= R(copysign)(1, sign)*scale[k];
    }
}

/* Eigenvalues d, ascending, and unless Z is NULL the shapes as its rows; M and K are overwritten. */
static int eigen_solve(
    int n, pkmodes_real M[N][N], pkmodes_real K[N][N], pkmodes_real d[], pkmodes_real (*Z)[N])
{
    pkmodes_real scale[N], e[N], beta[N];
    if (eigen_factor(n, M, scale))
        return -1;
    eigen_reduce(n, M, scale, K);
    eigen_tridiagonal(n, K, d, e, beta);
    if (Z)
        eigen_vectors(n, M, K, beta, Z);
    if (eigen_ql(n, d, e, Z))
        return -1;
    eigen_order(n, d, Z, scale);
    return 0;
}

/* Find vibrations, from the given mode on, that are lost in the rounding of the largest eigenvalue. */
static int eigen_lost(int n, const pkmodes_real d[], int vibration)
{
    int i;
    for (i = vibration; i < n; ++i)
        if (!(R(fabs)(d[i]) >= EIGEN_RESOLVED*R(fabs)(d[n - 1])))
            return -1;
    return 0;
}

/* Replace eigenvalues by natural frequencies sqrt(|lambda|)/(2 pi) with the sign of lambda [Hz]. */
static void eigen_frequencies(int n, pkmodes_real d[])
{
    int i;
    for (i = 0; i < n; ++i)
        d[i] = R(copysign)(R(sqrt)(R(fabs)(d[i])), d[i])/R(6.283185307179586);
}
int bed_slinger_status(const pkmodes_real p[2], const bed_slinger_parameters *parameters)
{
    int i;
    for (i = 0; i < BED_SLINGER_POSE; ++i)
        if (!isfinite(p[i]))
            return BED_SLINGER_NOT_FINITE;
    {
        pkmodes_real margin[2][2];
        bed_slinger_travel_margin(p, parameters, margin);
        for (i = 0; i < 4; ++i)
            if (!(((const pkmodes_real *)margin)[i] >= 0))
                return BED_SLINGER_BEYOND_LIMITS;
    }
    return 0;
}

int bed_slinger_modes(
    const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real f[4], pkmodes_real phi[4][4])
{
    pkmodes_real M[N][N], K[N][N];
    const int status = bed_slinger_status(p, parameters);
    if (status)
        return status;
    bed_slinger_modal_matrices(p, parameters, M, K);
    if (eigen_solve(N, M, K, f, phi) || eigen_lost(N, f, BED_SLINGER_RIGID_MODES))
        return BED_SLINGER_UNSOLVED;
    eigen_frequencies(N, f);
    return 0;
}

int bed_slinger_natural_frequencies(
    const pkmodes_real p[2], const bed_slinger_parameters *parameters, pkmodes_real f[4])
{
    return bed_slinger_modes(p, parameters, f, NULL);
}
