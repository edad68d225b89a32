/* Generated from the derivation of linear_delta.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism linear_delta, for a robot given by its parameters.
 * The header describes every function.
 *
 * Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; coordinate l of a second
 * derivative; belt span s; component i = x, y, z.  t1, t2, ... are subexpressions shared by several values.
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
 *   S_j_i [m]: centre of sphere j, on which the platform centre lies, component i
 *   alpha_i [m]: vector from sphere centre 1 to sphere centre 2, component i
 *   beta_i [m]: vector from sphere centre 1 to sphere centre 3, component i
 *   nu_i [m^2]: normal to the plane of the sphere centres, component i
 *   nu2 [m^4]: squared length of nu
 *   h_j [m^2]: scalar product of p - S_1 with the vector from sphere centre 1 to sphere centre j
 *   q_i [m]: projection of p onto the plane of the sphere centres, relative to S_1, component i
 *   v_p_i [m/s]: velocity of the platform, component i
 *   D_r_j [m]: entry of D_r for axis j: component of linkage vector along the motion of its joint
 *   A_i_j [m^2]: adjugate of D_l, entry i, j
 *   det_D_l [m^3]: determinant of D_l
 *   D_p_i_k [1]: platform Jacobian, dp_i/dx_k
 *   U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
 *   f_j_kl [1]: right-hand side of closure j, differentiated with respect to x_k and x_l
 *   P_i_kl [1/m]: second derivative of p_i with respect to x_k and x_l
 *   s_dot_j_i [m/s]: rate of change of linkage vector j, component i
 *   D_p_dot_i_k [1/s]: time derivative of dp_i/dx_k
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 *   G_j [N]: gradient of the gravitational potential energy with respect to x_j
 *   det_j [N^2 m]: determinant of the equilibrium equations of axis j
 *   theta_j_k_st [rad]: static rotation of pulley k of axis j, relative to the unstrained transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "linear_delta.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void linear_delta_inverse_kinematics(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real x[3])
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
    x[0] = x_1;
    x[1] = x_2;
    x[2] = x_3;
}

void linear_delta_reach_margin(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real margin[3])
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
    const pkmodes_real a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const pkmodes_real w_2_x = -a_2*n_2_x + r_2_x;
    const pkmodes_real w_2_y = -a_2*n_2_y + r_2_y;
    const pkmodes_real w_2_z = -a_2*n_2_z + r_2_z;
    const pkmodes_real w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const pkmodes_real a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const pkmodes_real w_3_x = -a_3*n_3_x + r_3_x;
    const pkmodes_real w_3_y = -a_3*n_3_y + r_3_y;
    const pkmodes_real w_3_z = -a_3*n_3_z + r_3_z;
    const pkmodes_real w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    margin[0] = l_d_1 - R(sqrt)(w2_1);
    margin[1] = l_d_2 - R(sqrt)(w2_2);
    margin[2] = l_d_3 - R(sqrt)(w2_3);
}

void linear_delta_travel_margin(const linear_delta_parameters *parameters, pkmodes_real margin[3])
{
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
    margin[0] = -l_t_1 + x_max_1 - x_min_1;
    margin[1] = -l_t_2 + x_max_2 - x_min_2;
    margin[2] = -l_t_3 + x_max_3 - x_min_3;
}

void linear_delta_direct_kinematics(const pkmodes_real x[3], pkmodes_real assembly,
    const linear_delta_parameters *parameters, pkmodes_real p[3])
{
    const pkmodes_real x_1 = x[0];
    const pkmodes_real x_2 = x[1];
    const pkmodes_real x_3 = x[2];
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
    const pkmodes_real S_1_x = -b_1_x + n_1_x*x_1 + o_1_x;
    const pkmodes_real S_1_y = -b_1_y + n_1_y*x_1 + o_1_y;
    const pkmodes_real S_1_z = -b_1_z + n_1_z*x_1 + o_1_z;
    const pkmodes_real S_2_x = -b_2_x + n_2_x*x_2 + o_2_x;
    const pkmodes_real S_2_y = -b_2_y + n_2_y*x_2 + o_2_y;
    const pkmodes_real S_2_z = -b_2_z + n_2_z*x_2 + o_2_z;
    const pkmodes_real S_3_x = -b_3_x + n_3_x*x_3 + o_3_x;
    const pkmodes_real S_3_y = -b_3_y + n_3_y*x_3 + o_3_y;
    const pkmodes_real S_3_z = -b_3_z + n_3_z*x_3 + o_3_z;
    const pkmodes_real alpha_x = -S_1_x + S_2_x;
    const pkmodes_real alpha_y = -S_1_y + S_2_y;
    const pkmodes_real alpha_z = -S_1_z + S_2_z;
    const pkmodes_real beta_x = -S_1_x + S_3_x;
    const pkmodes_real beta_y = -S_1_y + S_3_y;
    const pkmodes_real beta_z = -S_1_z + S_3_z;
    const pkmodes_real nu_x = alpha_y*beta_z - alpha_z*beta_y;
    const pkmodes_real nu_y = -alpha_x*beta_z + alpha_z*beta_x;
    const pkmodes_real nu_z = alpha_x*beta_y - alpha_y*beta_x;
    const pkmodes_real nu2 = (nu_x*nu_x) + (nu_y*nu_y) + (nu_z*nu_z);
    const pkmodes_real t1 = (l_d_1*l_d_1);
    const pkmodes_real t2 = (R(1.0)/R(2.0))*t1;
    const pkmodes_real h_2 =
        (R(1.0)/R(2.0))*(alpha_x*alpha_x) + (R(1.0)/R(2.0))*(alpha_y*alpha_y)
        + (R(1.0)/R(2.0))*(alpha_z*alpha_z) - R(1.0)/R(2.0)*(l_d_2*l_d_2) + t2;
    const pkmodes_real h_3 =
        (R(1.0)/R(2.0))*(beta_x*beta_x) + (R(1.0)/R(2.0))*(beta_y*beta_y) + (R(1.0)/R(2.0))*(beta_z*beta_z)
        - R(1.0)/R(2.0)*(l_d_3*l_d_3) + t2;
    const pkmodes_real t3 = 1/nu2;
    const pkmodes_real q_x = t3*(h_2*(beta_y*nu_z - beta_z*nu_y) + h_3*(-alpha_y*nu_z + alpha_z*nu_y));
    const pkmodes_real q_y = t3*(h_2*(-beta_x*nu_z + beta_z*nu_x) + h_3*(alpha_x*nu_z - alpha_z*nu_x));
    const pkmodes_real q_z = t3*(h_2*(beta_x*nu_y - beta_y*nu_x) + h_3*(-alpha_x*nu_y + alpha_y*nu_x));
    const pkmodes_real t4 = assembly*R(sqrt)(t3*(-(q_x*q_x) - (q_y*q_y) - (q_z*q_z) + t1));
    p[0] = S_1_x + nu_x*t4 + q_x;
    p[1] = S_1_y + nu_y*t4 + q_y;
    p[2] = S_1_z + nu_z*t4 + q_z;
}

void linear_delta_belt_spans(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real l_f[3][3])
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
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t1 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t1 + x_1 - x_min_1;
    const pkmodes_real l_f_1_3 = -t1 - x_1 + x_max_1;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t2 + x_2 - x_min_2;
    const pkmodes_real l_f_2_3 = -t2 - x_2 + x_max_2;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t3 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t3 + x_3 - x_min_3;
    const pkmodes_real l_f_3_3 = -t3 - x_3 + x_max_3;
    l_f[0][0] = l_f_1_1;
    l_f[0][1] = l_f_1_2;
    l_f[0][2] = l_f_1_3;
    l_f[1][0] = l_f_2_1;
    l_f[1][1] = l_f_2_2;
    l_f[1][2] = l_f_2_3;
    l_f[2][0] = l_f_3_1;
    l_f[2][1] = l_f_3_2;
    l_f[2][2] = l_f_3_3;
}

void linear_delta_constraint_jacobians(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real D_l[3][3], pkmodes_real D_r[3][3])
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
    D_l[0][0] = s_1_x;
    D_l[0][1] = s_1_y;
    D_l[0][2] = s_1_z;
    D_l[1][0] = s_2_x;
    D_l[1][1] = s_2_y;
    D_l[1][2] = s_2_z;
    D_l[2][0] = s_3_x;
    D_l[2][1] = s_3_y;
    D_l[2][2] = s_3_z;
    memset(D_r, 0, sizeof(pkmodes_real[3][3]));
    D_r[0][0] = D_r_1;
    D_r[1][1] = D_r_2;
    D_r[2][2] = D_r_3;
}

void linear_delta_jacobian_condition(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real *determinant, pkmodes_real *condition)
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
    const pkmodes_real t1 = 1/((det_D_l*det_D_l));
    *determinant = det_D_l;
    *condition =
        R(sqrt)((s_1_x*s_1_x) + (s_1_y*s_1_y) + (s_1_z*s_1_z) + (s_2_x*s_2_x) + (s_2_y*s_2_y) + (s_2_z*s_2_z)
        + (s_3_x*s_3_x) + (s_3_y*s_3_y) + (s_3_z*s_3_z))*R(sqrt)((A_x_1*A_x_1)*t1 + (A_x_2*A_x_2)*t1
        + (A_x_3*A_x_3)*t1 + (A_y_1*A_y_1)*t1 + (A_y_2*A_y_2)*t1 + (A_y_3*A_y_3)*t1 + (A_z_1*A_z_1)*t1
        + (A_z_2*A_z_2)*t1 + (A_z_3*A_z_3)*t1);
}

void linear_delta_platform_jacobian(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real D_p[3][3])
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
    D_p[0][0] = D_p_x_1;
    D_p[0][1] = D_p_x_2;
    D_p[0][2] = D_p_x_3;
    D_p[1][0] = D_p_y_1;
    D_p[1][1] = D_p_y_2;
    D_p[1][2] = D_p_y_3;
    D_p[2][0] = D_p_z_1;
    D_p[2][1] = D_p_z_2;
    D_p[2][2] = D_p_z_3;
}

void linear_delta_platform_jacobian_rate(const pkmodes_real p[3], const pkmodes_real x_dot[3],
    const linear_delta_parameters *parameters, pkmodes_real D_p_dot[3][3])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real x_1_dot = x_dot[0];
    const pkmodes_real x_2_dot = x_dot[1];
    const pkmodes_real x_3_dot = x_dot[2];
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
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real t5 = D_p_x_2*x_2_dot;
    const pkmodes_real t6 = D_p_x_3*x_3_dot;
    const pkmodes_real s_dot_1_x = U_1_x_1*x_1_dot + t5 + t6;
    const pkmodes_real t7 = D_p_y_2*x_2_dot;
    const pkmodes_real t8 = D_p_y_3*x_3_dot;
    const pkmodes_real s_dot_1_y = U_1_y_1*x_1_dot + t7 + t8;
    const pkmodes_real t9 = D_p_z_2*x_2_dot;
    const pkmodes_real t10 = D_p_z_3*x_3_dot;
    const pkmodes_real s_dot_1_z = U_1_z_1*x_1_dot + t10 + t9;
    const pkmodes_real t11 = D_p_x_1*x_1_dot;
    const pkmodes_real s_dot_2_x = U_2_x_2*x_2_dot + t11 + t6;
    const pkmodes_real t12 = D_p_y_1*x_1_dot;
    const pkmodes_real s_dot_2_y = U_2_y_2*x_2_dot + t12 + t8;
    const pkmodes_real t13 = D_p_z_1*x_1_dot;
    const pkmodes_real s_dot_2_z = U_2_z_2*x_2_dot + t10 + t13;
    const pkmodes_real s_dot_3_x = U_3_x_3*x_3_dot + t11 + t5;
    const pkmodes_real s_dot_3_y = U_3_y_3*x_3_dot + t12 + t7;
    const pkmodes_real s_dot_3_z = U_3_z_3*x_3_dot + t13 + t9;
    const pkmodes_real t14 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t15 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t16 =
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y
        + n_1_z*s_dot_1_z;
    const pkmodes_real D_p_dot_x_1 = t1*(A_x_1*t16 + A_x_2*t14 + A_x_3*t15);
    const pkmodes_real D_p_dot_y_1 = t1*(A_y_1*t16 + A_y_2*t14 + A_y_3*t15);
    const pkmodes_real D_p_dot_z_1 = t1*(A_z_1*t16 + A_z_2*t14 + A_z_3*t15);
    const pkmodes_real t17 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t18 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t19 =
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y
        + n_2_z*s_dot_2_z;
    const pkmodes_real D_p_dot_x_2 = t1*(A_x_1*t17 + A_x_2*t19 + A_x_3*t18);
    const pkmodes_real D_p_dot_y_2 = t1*(A_y_1*t17 + A_y_2*t19 + A_y_3*t18);
    const pkmodes_real D_p_dot_z_2 = t1*(A_z_1*t17 + A_z_2*t19 + A_z_3*t18);
    const pkmodes_real t20 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t21 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t22 =
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y
        + n_3_z*s_dot_3_z;
    const pkmodes_real D_p_dot_x_3 = t1*(A_x_1*t20 + A_x_2*t21 + A_x_3*t22);
    const pkmodes_real D_p_dot_y_3 = t1*(A_y_1*t20 + A_y_2*t21 + A_y_3*t22);
    const pkmodes_real D_p_dot_z_3 = t1*(A_z_1*t20 + A_z_2*t21 + A_z_3*t22);
    D_p_dot[0][0] = D_p_dot_x_1;
    D_p_dot[0][1] = D_p_dot_x_2;
    D_p_dot[0][2] = D_p_dot_x_3;
    D_p_dot[1][0] = D_p_dot_y_1;
    D_p_dot[1][1] = D_p_dot_y_2;
    D_p_dot[1][2] = D_p_dot_y_3;
    D_p_dot[2][0] = D_p_dot_z_1;
    D_p_dot[2][1] = D_p_dot_z_2;
    D_p_dot[2][2] = D_p_dot_z_3;
}

void linear_delta_platform_second_derivatives(const pkmodes_real p[3],
    const linear_delta_parameters *parameters, pkmodes_real P[3][3][3])
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
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real f_1_11 = -(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1);
    const pkmodes_real f_2_11 = -(D_p_x_1*D_p_x_1) - (D_p_y_1*D_p_y_1) - (D_p_z_1*D_p_z_1);
    const pkmodes_real P_x_11 = t1*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11);
    const pkmodes_real P_y_11 = t1*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11);
    const pkmodes_real P_z_11 = t1*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11);
    const pkmodes_real f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1;
    const pkmodes_real f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2;
    const pkmodes_real f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2;
    const pkmodes_real P_x_12 = t1*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12);
    const pkmodes_real P_y_12 = t1*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12);
    const pkmodes_real P_z_12 = t1*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12);
    const pkmodes_real f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1;
    const pkmodes_real f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3;
    const pkmodes_real f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3;
    const pkmodes_real P_x_13 = t1*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13);
    const pkmodes_real P_y_13 = t1*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13);
    const pkmodes_real P_z_13 = t1*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13);
    const pkmodes_real f_1_22 = -(D_p_x_2*D_p_x_2) - (D_p_y_2*D_p_y_2) - (D_p_z_2*D_p_z_2);
    const pkmodes_real f_2_22 = -(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2);
    const pkmodes_real P_x_22 = t1*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22);
    const pkmodes_real P_y_22 = t1*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22);
    const pkmodes_real P_z_22 = t1*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22);
    const pkmodes_real f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3;
    const pkmodes_real f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2;
    const pkmodes_real f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3;
    const pkmodes_real P_x_23 = t1*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23);
    const pkmodes_real P_y_23 = t1*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23);
    const pkmodes_real P_z_23 = t1*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23);
    const pkmodes_real f_1_33 = -(D_p_x_3*D_p_x_3) - (D_p_y_3*D_p_y_3) - (D_p_z_3*D_p_z_3);
    const pkmodes_real f_3_33 = -(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3);
    const pkmodes_real P_x_33 = t1*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33);
    const pkmodes_real P_y_33 = t1*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33);
    const pkmodes_real P_z_33 = t1*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33);
    P[0][0][0] = P_x_11;
    P[0][0][1] = P[0][1][0] = P_x_12;
    P[0][0][2] = P[0][2][0] = P_x_13;
    P[0][1][1] = P_x_22;
    P[0][1][2] = P[0][2][1] = P_x_23;
    P[0][2][2] = P_x_33;
    P[1][0][0] = P_y_11;
    P[1][0][1] = P[1][1][0] = P_y_12;
    P[1][0][2] = P[1][2][0] = P_y_13;
    P[1][1][1] = P_y_22;
    P[1][1][2] = P[1][2][1] = P_y_23;
    P[1][2][2] = P_y_33;
    P[2][0][0] = P_z_11;
    P[2][0][1] = P[2][1][0] = P_z_12;
    P[2][0][2] = P[2][2][0] = P_z_13;
    P[2][1][1] = P_z_22;
    P[2][1][2] = P[2][2][1] = P_z_23;
    P[2][2][2] = P_z_33;
}

void linear_delta_link_jacobians(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real D_d[3][3][3], pkmodes_real D_omega[3][3][3])
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
    const pkmodes_real t1 = (l_d_1*l_d_1);
    const pkmodes_real x_1 = a_1 + sigma_1*R(sqrt)(t1 - w2_1);
    const pkmodes_real a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const pkmodes_real w_2_x = -a_2*n_2_x + r_2_x;
    const pkmodes_real w_2_y = -a_2*n_2_y + r_2_y;
    const pkmodes_real w_2_z = -a_2*n_2_z + r_2_z;
    const pkmodes_real w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const pkmodes_real t2 = (l_d_2*l_d_2);
    const pkmodes_real x_2 = a_2 + sigma_2*R(sqrt)(t2 - w2_2);
    const pkmodes_real a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const pkmodes_real w_3_x = -a_3*n_3_x + r_3_x;
    const pkmodes_real w_3_y = -a_3*n_3_y + r_3_y;
    const pkmodes_real w_3_z = -a_3*n_3_z + r_3_z;
    const pkmodes_real w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const pkmodes_real t3 = (l_d_3*l_d_3);
    const pkmodes_real x_3 = a_3 + sigma_3*R(sqrt)(t3 - w2_3);
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
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real t8 = (R(1.0)/R(2.0))*D_p_x_1;
    const pkmodes_real t9 = (R(1.0)/R(2.0))*D_p_x_2;
    const pkmodes_real t10 = (R(1.0)/R(2.0))*D_p_x_3;
    const pkmodes_real t11 = (R(1.0)/R(2.0))*D_p_y_1;
    const pkmodes_real t12 = (R(1.0)/R(2.0))*D_p_y_2;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*D_p_y_3;
    const pkmodes_real t14 = (R(1.0)/R(2.0))*D_p_z_1;
    const pkmodes_real t15 = (R(1.0)/R(2.0))*D_p_z_2;
    const pkmodes_real t16 = (R(1.0)/R(2.0))*D_p_z_3;
    const pkmodes_real t17 = 1/t1;
    const pkmodes_real t18 = 1/t2;
    const pkmodes_real t19 = 1/t3;
    D_d[0][0][0] = (R(1.0)/R(2.0))*n_1_x + t8;
    D_d[0][0][1] = t9;
    D_d[0][0][2] = t10;
    D_d[0][1][0] = (R(1.0)/R(2.0))*n_1_y + t11;
    D_d[0][1][1] = t12;
    D_d[0][1][2] = t13;
    D_d[0][2][0] = (R(1.0)/R(2.0))*n_1_z + t14;
    D_d[0][2][1] = t15;
    D_d[0][2][2] = t16;
    D_d[1][0][0] = t8;
    D_d[1][0][1] = (R(1.0)/R(2.0))*n_2_x + t9;
    D_d[1][0][2] = t10;
    D_d[1][1][0] = t11;
    D_d[1][1][1] = (R(1.0)/R(2.0))*n_2_y + t12;
    D_d[1][1][2] = t13;
    D_d[1][2][0] = t14;
    D_d[1][2][1] = (R(1.0)/R(2.0))*n_2_z + t15;
    D_d[1][2][2] = t16;
    D_d[2][0][0] = t8;
    D_d[2][0][1] = t9;
    D_d[2][0][2] = (R(1.0)/R(2.0))*n_3_x + t10;
    D_d[2][1][0] = t11;
    D_d[2][1][1] = t12;
    D_d[2][1][2] = (R(1.0)/R(2.0))*n_3_y + t13;
    D_d[2][2][0] = t14;
    D_d[2][2][1] = t15;
    D_d[2][2][2] = (R(1.0)/R(2.0))*n_3_z + t16;
    D_omega[0][0][0] = t17*(-U_1_y_1*s_1_z + U_1_z_1*s_1_y);
    D_omega[0][0][1] = t17*(-D_p_y_2*s_1_z + D_p_z_2*s_1_y);
    D_omega[0][0][2] = t17*(-D_p_y_3*s_1_z + D_p_z_3*s_1_y);
    D_omega[0][1][0] = t17*(U_1_x_1*s_1_z - U_1_z_1*s_1_x);
    D_omega[0][1][1] = t17*(D_p_x_2*s_1_z - D_p_z_2*s_1_x);
    D_omega[0][1][2] = t17*(D_p_x_3*s_1_z - D_p_z_3*s_1_x);
    D_omega[0][2][0] = t17*(-U_1_x_1*s_1_y + U_1_y_1*s_1_x);
    D_omega[0][2][1] = t17*(-D_p_x_2*s_1_y + D_p_y_2*s_1_x);
    D_omega[0][2][2] = t17*(-D_p_x_3*s_1_y + D_p_y_3*s_1_x);
    D_omega[1][0][0] = t18*(-D_p_y_1*s_2_z + D_p_z_1*s_2_y);
    D_omega[1][0][1] = t18*(-U_2_y_2*s_2_z + U_2_z_2*s_2_y);
    D_omega[1][0][2] = t18*(-D_p_y_3*s_2_z + D_p_z_3*s_2_y);
    D_omega[1][1][0] = t18*(D_p_x_1*s_2_z - D_p_z_1*s_2_x);
    D_omega[1][1][1] = t18*(U_2_x_2*s_2_z - U_2_z_2*s_2_x);
    D_omega[1][1][2] = t18*(D_p_x_3*s_2_z - D_p_z_3*s_2_x);
    D_omega[1][2][0] = t18*(-D_p_x_1*s_2_y + D_p_y_1*s_2_x);
    D_omega[1][2][1] = t18*(-U_2_x_2*s_2_y + U_2_y_2*s_2_x);
    D_omega[1][2][2] = t18*(-D_p_x_3*s_2_y + D_p_y_3*s_2_x);
    D_omega[2][0][0] = t19*(-D_p_y_1*s_3_z + D_p_z_1*s_3_y);
    D_omega[2][0][1] = t19*(-D_p_y_2*s_3_z + D_p_z_2*s_3_y);
    D_omega[2][0][2] = t19*(-U_3_y_3*s_3_z + U_3_z_3*s_3_y);
    D_omega[2][1][0] = t19*(D_p_x_1*s_3_z - D_p_z_1*s_3_x);
    D_omega[2][1][1] = t19*(D_p_x_2*s_3_z - D_p_z_2*s_3_x);
    D_omega[2][1][2] = t19*(U_3_x_3*s_3_z - U_3_z_3*s_3_x);
    D_omega[2][2][0] = t19*(-D_p_x_1*s_3_y + D_p_y_1*s_3_x);
    D_omega[2][2][1] = t19*(-D_p_x_2*s_3_y + D_p_y_2*s_3_x);
    D_omega[2][2][2] = t19*(-U_3_x_3*s_3_y + U_3_y_3*s_3_x);
}

void linear_delta_kinetic_energy(const pkmodes_real p[3], const pkmodes_real q_dot[9],
    const linear_delta_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t)
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real x_1_dot = q_dot[0];
    const pkmodes_real x_2_dot = q_dot[1];
    const pkmodes_real x_3_dot = q_dot[2];
    const pkmodes_real theta_1_1_dot = q_dot[3];
    const pkmodes_real theta_2_1_dot = q_dot[4];
    const pkmodes_real theta_3_1_dot = q_dot[5];
    const pkmodes_real theta_1_2_dot = q_dot[6];
    const pkmodes_real theta_2_2_dot = q_dot[7];
    const pkmodes_real theta_3_2_dot = q_dot[8];
    const pkmodes_real m_p = parameters->platform_mass;
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
    const pkmodes_real t5 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t5;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t5;
    const pkmodes_real t6 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t6;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t6;
    const pkmodes_real t7 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t7;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t7;
    const pkmodes_real v_p_x = D_p_x_1*x_1_dot + D_p_x_2*x_2_dot + D_p_x_3*x_3_dot;
    const pkmodes_real v_p_y = D_p_y_1*x_1_dot + D_p_y_2*x_2_dot + D_p_y_3*x_3_dot;
    const pkmodes_real v_p_z = D_p_z_1*x_1_dot + D_p_z_2*x_2_dot + D_p_z_3*x_3_dot;
    const pkmodes_real t8 = (x_1_dot*x_1_dot);
    const pkmodes_real t9 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t10 = (x_2_dot*x_2_dot);
    const pkmodes_real t11 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t12 = (x_3_dot*x_3_dot);
    const pkmodes_real t13 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t14 = (R(1.0)/R(2.0))*m_p + t11 + t13 + t9;
    const pkmodes_real t15 = t9*x_1_dot;
    const pkmodes_real t16 = t11*x_2_dot;
    const pkmodes_real t17 = t13*x_3_dot;
    *T_ss =
        (R(1.0)/R(2.0))*m_t_1*t8 + (R(1.0)/R(2.0))*m_t_2*t10 + (R(1.0)/R(2.0))*m_t_3*t12 + t10*t11 + t12*t13
        + t14*(v_p_x*v_p_x) + t14*(v_p_y*v_p_y) + t14*(v_p_z*v_p_z) + t8*t9 + v_p_x*(n_1_x*t15 + n_2_x*t16
        + n_3_x*t17) + v_p_y*(n_1_y*t15 + n_2_y*t16 + n_3_y*t17) + v_p_z*(n_1_z*t15 + n_2_z*t16 + n_3_z*t17);
    *T_t =
        (R(1.0)/R(2.0))*I_1_1*(theta_1_1_dot*theta_1_1_dot)
        + (R(1.0)/R(2.0))*I_1_2*(theta_1_2_dot*theta_1_2_dot)
        + (R(1.0)/R(2.0))*I_2_1*(theta_2_1_dot*theta_2_1_dot)
        + (R(1.0)/R(2.0))*I_2_2*(theta_2_2_dot*theta_2_2_dot)
        + (R(1.0)/R(2.0))*I_3_1*(theta_3_1_dot*theta_3_1_dot)
        + (R(1.0)/R(2.0))*I_3_2*(theta_3_2_dot*theta_3_2_dot);
}

void linear_delta_mass_matrix(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real M[9][9])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real m_p = parameters->platform_mass;
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
    const pkmodes_real t5 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t5;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t5;
    const pkmodes_real t6 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t6;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t6;
    const pkmodes_real t7 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t7;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t7;
    const pkmodes_real t8 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t9 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t10 = n_1_x*t9;
    const pkmodes_real t11 = n_1_y*t9;
    const pkmodes_real t12 = n_1_z*t9;
    const pkmodes_real t13 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t14 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t15 = m_p + t13 + t14 + t8;
    const pkmodes_real t16 = D_p_x_1*t15 + t10;
    const pkmodes_real t17 = D_p_y_1*t15 + t11;
    const pkmodes_real t18 = D_p_z_1*t15 + t12;
    const pkmodes_real t19 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t20 = n_2_x*t19;
    const pkmodes_real t21 = n_2_y*t19;
    const pkmodes_real t22 = n_2_z*t19;
    const pkmodes_real t23 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t24 = n_3_x*t23;
    const pkmodes_real t25 = n_3_y*t23;
    const pkmodes_real t26 = n_3_z*t23;
    const pkmodes_real t27 = D_p_x_2*t15 + t20;
    const pkmodes_real t28 = D_p_y_2*t15 + t21;
    const pkmodes_real t29 = D_p_z_2*t15 + t22;
    memset(M, 0, sizeof(pkmodes_real[9][9]));
    M[0][0] = D_p_x_1*t10 + D_p_x_1*t16 + D_p_y_1*t11 + D_p_y_1*t17 + D_p_z_1*t12 + D_p_z_1*t18 + m_t_1 + t8;
    M[0][1] = M[1][0] = D_p_x_1*t20 + D_p_x_2*t16 + D_p_y_1*t21 + D_p_y_2*t17 + D_p_z_1*t22 + D_p_z_2*t18;
    M[0][2] = M[2][0] = D_p_x_1*t24 + D_p_x_3*t16 + D_p_y_1*t25 + D_p_y_3*t17 + D_p_z_1*t26 + D_p_z_3*t18;
    M[1][1] = D_p_x_2*t20 + D_p_x_2*t27 + D_p_y_2*t21 + D_p_y_2*t28 + D_p_z_2*t22 + D_p_z_2*t29 + m_t_2 + t13;
    M[1][2] = M[2][1] = D_p_x_2*t24 + D_p_x_3*t27 + D_p_y_2*t25 + D_p_y_3*t28 + D_p_z_2*t26 + D_p_z_3*t29;
    M[2][2] =
        D_p_x_3*t24 + D_p_x_3*(D_p_x_3*t15 + t24) + D_p_y_3*t25 + D_p_y_3*(D_p_y_3*t15 + t25) + D_p_z_3*t26
        + D_p_z_3*(D_p_z_3*t15 + t26) + m_t_3 + t14;
    M[3][3] = I_1_1;
    M[4][4] = I_2_1;
    M[5][5] = I_3_1;
    M[6][6] = I_1_2;
    M[7][7] = I_2_2;
    M[8][8] = I_3_2;
}

void linear_delta_velocity_forces(const pkmodes_real p[3], const pkmodes_real x_dot[3],
    const linear_delta_parameters *parameters, pkmodes_real h[3])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real x_1_dot = x_dot[0];
    const pkmodes_real x_2_dot = x_dot[1];
    const pkmodes_real x_3_dot = x_dot[2];
    const pkmodes_real m_p = parameters->platform_mass;
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
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real f_1_11 = -(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1);
    const pkmodes_real f_2_11 = -(D_p_x_1*D_p_x_1) - (D_p_y_1*D_p_y_1) - (D_p_z_1*D_p_z_1);
    const pkmodes_real P_x_11 = t1*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11);
    const pkmodes_real P_y_11 = t1*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11);
    const pkmodes_real P_z_11 = t1*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11);
    const pkmodes_real f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1;
    const pkmodes_real f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2;
    const pkmodes_real f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2;
    const pkmodes_real P_x_12 = t1*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12);
    const pkmodes_real P_y_12 = t1*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12);
    const pkmodes_real P_z_12 = t1*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12);
    const pkmodes_real f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1;
    const pkmodes_real f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3;
    const pkmodes_real f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3;
    const pkmodes_real P_x_13 = t1*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13);
    const pkmodes_real P_y_13 = t1*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13);
    const pkmodes_real P_z_13 = t1*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13);
    const pkmodes_real f_1_22 = -(D_p_x_2*D_p_x_2) - (D_p_y_2*D_p_y_2) - (D_p_z_2*D_p_z_2);
    const pkmodes_real f_2_22 = -(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2);
    const pkmodes_real P_x_22 = t1*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22);
    const pkmodes_real P_y_22 = t1*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22);
    const pkmodes_real P_z_22 = t1*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22);
    const pkmodes_real f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3;
    const pkmodes_real f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2;
    const pkmodes_real f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3;
    const pkmodes_real P_x_23 = t1*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23);
    const pkmodes_real P_y_23 = t1*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23);
    const pkmodes_real P_z_23 = t1*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23);
    const pkmodes_real f_1_33 = -(D_p_x_3*D_p_x_3) - (D_p_y_3*D_p_y_3) - (D_p_z_3*D_p_z_3);
    const pkmodes_real f_3_33 = -(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3);
    const pkmodes_real P_x_33 = t1*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33);
    const pkmodes_real P_y_33 = t1*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33);
    const pkmodes_real P_z_33 = t1*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33);
    const pkmodes_real t5 = D_p_x_1*x_1_dot;
    const pkmodes_real t6 = D_p_x_2*x_2_dot;
    const pkmodes_real t7 = D_p_x_3*x_3_dot;
    const pkmodes_real t8 = t6 + t7;
    const pkmodes_real v_p_x = t5 + t8;
    const pkmodes_real t9 = D_p_y_1*x_1_dot;
    const pkmodes_real t10 = D_p_y_2*x_2_dot;
    const pkmodes_real t11 = D_p_y_3*x_3_dot;
    const pkmodes_real t12 = t10 + t11;
    const pkmodes_real v_p_y = t12 + t9;
    const pkmodes_real t13 = D_p_z_1*x_1_dot;
    const pkmodes_real t14 = D_p_z_2*x_2_dot;
    const pkmodes_real t15 = D_p_z_3*x_3_dot;
    const pkmodes_real t16 = t14 + t15;
    const pkmodes_real v_p_z = t13 + t16;
    const pkmodes_real s_dot_1_x = U_1_x_1*x_1_dot + t8;
    const pkmodes_real s_dot_1_y = U_1_y_1*x_1_dot + t12;
    const pkmodes_real s_dot_1_z = U_1_z_1*x_1_dot + t16;
    const pkmodes_real s_dot_2_x = U_2_x_2*x_2_dot + t5 + t7;
    const pkmodes_real s_dot_2_y = U_2_y_2*x_2_dot + t11 + t9;
    const pkmodes_real s_dot_2_z = U_2_z_2*x_2_dot + t13 + t15;
    const pkmodes_real s_dot_3_x = U_3_x_3*x_3_dot + t5 + t6;
    const pkmodes_real s_dot_3_y = U_3_y_3*x_3_dot + t10 + t9;
    const pkmodes_real s_dot_3_z = U_3_z_3*x_3_dot + t13 + t14;
    const pkmodes_real t17 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t18 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t19 =
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y
        + n_1_z*s_dot_1_z;
    const pkmodes_real D_p_dot_x_1 = t1*(A_x_1*t19 + A_x_2*t17 + A_x_3*t18);
    const pkmodes_real D_p_dot_y_1 = t1*(A_y_1*t19 + A_y_2*t17 + A_y_3*t18);
    const pkmodes_real D_p_dot_z_1 = t1*(A_z_1*t19 + A_z_2*t17 + A_z_3*t18);
    const pkmodes_real t20 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t21 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t22 =
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y
        + n_2_z*s_dot_2_z;
    const pkmodes_real D_p_dot_x_2 = t1*(A_x_1*t20 + A_x_2*t22 + A_x_3*t21);
    const pkmodes_real D_p_dot_y_2 = t1*(A_y_1*t20 + A_y_2*t22 + A_y_3*t21);
    const pkmodes_real D_p_dot_z_2 = t1*(A_z_1*t20 + A_z_2*t22 + A_z_3*t21);
    const pkmodes_real t23 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t24 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t25 =
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y
        + n_3_z*s_dot_3_z;
    const pkmodes_real D_p_dot_x_3 = t1*(A_x_1*t23 + A_x_2*t24 + A_x_3*t25);
    const pkmodes_real D_p_dot_y_3 = t1*(A_y_1*t23 + A_y_2*t24 + A_y_3*t25);
    const pkmodes_real D_p_dot_z_3 = t1*(A_z_1*t23 + A_z_2*t24 + A_z_3*t25);
    const pkmodes_real t26 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t27 = n_1_x*t26;
    const pkmodes_real t28 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t29 = n_2_x*t28;
    const pkmodes_real t30 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t31 = n_3_x*t30;
    const pkmodes_real t32 = m_p + 2*t26 + 2*t28 + 2*t30;
    const pkmodes_real t33 = t27*x_1_dot + t29*x_2_dot + t31*x_3_dot + t32*v_p_x;
    const pkmodes_real t34 = n_1_y*t26;
    const pkmodes_real t35 = n_2_y*t28;
    const pkmodes_real t36 = n_3_y*t30;
    const pkmodes_real t37 = t32*v_p_y + t34*x_1_dot + t35*x_2_dot + t36*x_3_dot;
    const pkmodes_real t38 = n_1_z*t26;
    const pkmodes_real t39 = n_2_z*t28;
    const pkmodes_real t40 = n_3_z*t30;
    const pkmodes_real t41 = t32*v_p_z + t38*x_1_dot + t39*x_2_dot + t40*x_3_dot;
    const pkmodes_real t42 = (R(1.0)/R(3.0))*m_d_1 + (R(1.0)/R(3.0))*m_d_2 + (R(1.0)/R(3.0))*m_d_3 + m_p;
    const pkmodes_real t43 = D_p_x_1*t42 + t27;
    const pkmodes_real t44 = D_p_y_1*t42 + t34;
    const pkmodes_real t45 = D_p_z_1*t42 + t38;
    const pkmodes_real t46 = P_x_12*t33 + P_y_12*t37 + P_z_12*t41;
    const pkmodes_real t47 = P_x_13*t33 + P_y_13*t37 + P_z_13*t41;
    const pkmodes_real t48 = D_p_x_2*t42 + t29;
    const pkmodes_real t49 = D_p_y_2*t42 + t35;
    const pkmodes_real t50 = D_p_z_2*t42 + t39;
    const pkmodes_real t51 = P_x_23*t33 + P_y_23*t37 + P_z_23*t41;
    const pkmodes_real t52 = D_p_x_3*t42 + t31;
    const pkmodes_real t53 = D_p_y_3*t42 + t36;
    const pkmodes_real t54 = D_p_z_3*t42 + t40;
    h[0] =
        -D_p_dot_x_1*t33 - D_p_dot_y_1*t37 - D_p_dot_z_1*t41 + x_1_dot*(D_p_dot_x_1*t43 + D_p_dot_y_1*t44
        + D_p_dot_z_1*t45 + P_x_11*t33 + P_y_11*t37 + P_z_11*t41) + x_2_dot*(D_p_dot_x_2*t43
        + D_p_dot_y_2*t44 + D_p_dot_z_2*t45 + t46) + x_3_dot*(D_p_dot_x_3*t43 + D_p_dot_y_3*t44
        + D_p_dot_z_3*t45 + t47);
    h[1] =
        -D_p_dot_x_2*t33 - D_p_dot_y_2*t37 - D_p_dot_z_2*t41 + x_1_dot*(D_p_dot_x_1*t48 + D_p_dot_y_1*t49
        + D_p_dot_z_1*t50 + t46) + x_2_dot*(D_p_dot_x_2*t48 + D_p_dot_y_2*t49 + D_p_dot_z_2*t50 + P_x_22*t33
        + P_y_22*t37 + P_z_22*t41) + x_3_dot*(D_p_dot_x_3*t48 + D_p_dot_y_3*t49 + D_p_dot_z_3*t50 + t51);
    h[2] =
        -D_p_dot_x_3*t33 - D_p_dot_y_3*t37 - D_p_dot_z_3*t41 + x_1_dot*(D_p_dot_x_1*t52 + D_p_dot_y_1*t53
        + D_p_dot_z_1*t54 + t47) + x_2_dot*(D_p_dot_x_2*t52 + D_p_dot_y_2*t53 + D_p_dot_z_2*t54 + t51)
        + x_3_dot*(D_p_dot_x_3*t52 + D_p_dot_y_3*t53 + D_p_dot_z_3*t54 + P_x_33*t33 + P_y_33*t37
        + P_z_33*t41);
}

void linear_delta_gravity_potential(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real *V_g)
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
    const pkmodes_real t1 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t3 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t4 = m_t_1*x_1;
    const pkmodes_real t5 = m_t_2*x_2;
    const pkmodes_real t6 = m_t_3*x_3;
    const pkmodes_real t7 = t1*x_1;
    const pkmodes_real t8 = t2*x_2;
    const pkmodes_real t9 = t3*x_3;
    const pkmodes_real t10 = m_p + t1 + t2 + t3;
    *V_g =
        -g_x*(b_1_x*t1 + b_2_x*t2 + b_3_x*t3 + m_t_1*o_1_x + m_t_2*o_2_x + m_t_3*o_3_x + n_1_x*t4 + n_1_x*t7
        + n_2_x*t5 + n_2_x*t8 + n_3_x*t6 + n_3_x*t9 + o_1_x*t1 + o_2_x*t2 + o_3_x*t3 + p_x*t10)
        - g_y*(b_1_y*t1 + b_2_y*t2 + b_3_y*t3 + m_t_1*o_1_y + m_t_2*o_2_y + m_t_3*o_3_y + n_1_y*t4 + n_1_y*t7
        + n_2_y*t5 + n_2_y*t8 + n_3_y*t6 + n_3_y*t9 + o_1_y*t1 + o_2_y*t2 + o_3_y*t3 + p_y*t10)
        - g_z*(b_1_z*t1 + b_2_z*t2 + b_3_z*t3 + m_t_1*o_1_z + m_t_2*o_2_z + m_t_3*o_3_z + n_1_z*t4 + n_1_z*t7
        + n_2_z*t5 + n_2_z*t8 + n_3_z*t6 + n_3_z*t9 + o_1_z*t1 + o_2_z*t2 + o_3_z*t3 + p_z*t10);
}

void linear_delta_gravity_gradient(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real G[3])
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
    const pkmodes_real t5 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t7 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t8 = m_p + t5 + t6 + t7;
    const pkmodes_real t9 = g_x*t8;
    const pkmodes_real t10 = g_y*t8;
    const pkmodes_real t11 = g_z*t8;
    G[0] =
        -D_p_x_1*t9 - D_p_y_1*t10 - D_p_z_1*t11 - g_x*(m_t_1*n_1_x + n_1_x*t5) - g_y*(m_t_1*n_1_y + n_1_y*t5)
        - g_z*(m_t_1*n_1_z + n_1_z*t5);
    G[1] =
        -D_p_x_2*t9 - D_p_y_2*t10 - D_p_z_2*t11 - g_x*(m_t_2*n_2_x + n_2_x*t6) - g_y*(m_t_2*n_2_y + n_2_y*t6)
        - g_z*(m_t_2*n_2_z + n_2_z*t6);
    G[2] =
        -D_p_x_3*t9 - D_p_y_3*t10 - D_p_z_3*t11 - g_x*(m_t_3*n_3_x + n_3_x*t7) - g_y*(m_t_3*n_3_y + n_3_y*t7)
        - g_z*(m_t_3*n_3_z + n_3_z*t7);
}

void linear_delta_gravity_hessian(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real H_g[3][3])
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
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real t5 = (R(1.0)/R(2.0))*m_d_1 + (R(1.0)/R(2.0))*m_d_2 + (R(1.0)/R(2.0))*m_d_3 + m_p;
    const pkmodes_real t6 = g_x*t5;
    const pkmodes_real t7 = g_y*t5;
    const pkmodes_real t8 = g_z*t5;
    const pkmodes_real mu_1 = t1*(-A_x_1*t6 - A_y_1*t7 - A_z_1*t8);
    const pkmodes_real mu_2 = t1*(-A_x_2*t6 - A_y_2*t7 - A_z_2*t8);
    const pkmodes_real mu_3 = t1*(-A_x_3*t6 - A_y_3*t7 - A_z_3*t8);
    const pkmodes_real t9 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t10 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t11 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t12 = D_p_x_1*mu_3;
    const pkmodes_real t13 = D_p_x_1*mu_2;
    const pkmodes_real t14 = U_1_x_1*mu_1;
    const pkmodes_real t15 = D_p_y_1*mu_3;
    const pkmodes_real t16 = D_p_y_1*mu_2;
    const pkmodes_real t17 = U_1_y_1*mu_1;
    const pkmodes_real t18 = D_p_z_1*mu_3;
    const pkmodes_real t19 = D_p_z_1*mu_2;
    const pkmodes_real t20 = U_1_z_1*mu_1;
    const pkmodes_real t21 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t22 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t23 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t24 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t25 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t26 = (D_p_z_3*D_p_z_3);
    H_g[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 - mu_2*t10 - mu_2*t11
        - mu_2*t9 - mu_3*t10 - mu_3*t11 - mu_3*t9;
    H_g[0][1] = H_g[1][0] =
        -D_p_x_2*t12 - D_p_x_2*t14 - D_p_y_2*t15 - D_p_y_2*t17 - D_p_z_2*t18 - D_p_z_2*t20 - U_2_x_2*t13
        - U_2_y_2*t16 - U_2_z_2*t19;
    H_g[0][2] = H_g[2][0] =
        -D_p_x_3*t13 - D_p_x_3*t14 - D_p_y_3*t16 - D_p_y_3*t17 - D_p_z_3*t19 - D_p_z_3*t20 - U_3_x_3*t12
        - U_3_y_3*t15 - U_3_z_3*t18;
    H_g[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 - mu_1*t21 - mu_1*t22
        - mu_1*t23 - mu_3*t21 - mu_3*t22 - mu_3*t23;
    H_g[1][2] = H_g[2][1] =
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2;
    H_g[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 - mu_1*t24 - mu_1*t25
        - mu_1*t26 - mu_2*t24 - mu_2*t25 - mu_2*t26;
}

void linear_delta_belt_stiffness(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real k[3][3])
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
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real k_sp_1 = parameters->belt_specific_stiffness[0];
    const pkmodes_real k_sp_2 = parameters->belt_specific_stiffness[1];
    const pkmodes_real k_sp_3 = parameters->belt_specific_stiffness[2];
    const pkmodes_real w_b_1 = parameters->belt_width[0];
    const pkmodes_real w_b_2 = parameters->belt_width[1];
    const pkmodes_real w_b_3 = parameters->belt_width[2];
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t2 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t2 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t1/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t3 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t3/l_f_2_1;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t4 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t3/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t4 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t3/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t5 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t5/l_f_3_1;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t6 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t5/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t6 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t5/l_f_3_3;
    k[0][0] = k_1_1;
    k[0][1] = k_1_2;
    k[0][2] = k_1_3;
    k[1][0] = k_2_1;
    k[1][1] = k_2_2;
    k[1][2] = k_2_3;
    k[2][0] = k_3_1;
    k[2][1] = k_3_2;
    k[2][2] = k_3_3;
}

void linear_delta_elastic_potential(const pkmodes_real p[3], const pkmodes_real delta_q[9],
    const linear_delta_parameters *parameters, pkmodes_real *V_el)
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real delta_x_1 = delta_q[0];
    const pkmodes_real delta_x_2 = delta_q[1];
    const pkmodes_real delta_x_3 = delta_q[2];
    const pkmodes_real delta_theta_1_1 = delta_q[3];
    const pkmodes_real delta_theta_2_1 = delta_q[4];
    const pkmodes_real delta_theta_3_1 = delta_q[5];
    const pkmodes_real delta_theta_1_2 = delta_q[6];
    const pkmodes_real delta_theta_2_2 = delta_q[7];
    const pkmodes_real delta_theta_3_2 = delta_q[8];
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
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t2 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t2 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t1/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t3 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t3/l_f_2_1;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t4 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t3/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t4 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t3/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t5 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t5/l_f_3_1;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t6 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t5/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t6 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t5/l_f_3_3;
    const pkmodes_real t7 = R_p_3*delta_theta_3_2;
    const pkmodes_real t8 = R_p_1*delta_theta_1_1;
    const pkmodes_real t9 = R_p_2*delta_theta_2_1;
    const pkmodes_real t10 = R_p_3*delta_theta_3_1;
    const pkmodes_real t11 = R_p_1*delta_theta_1_2;
    const pkmodes_real t12 = R_p_2*delta_theta_2_2;
    *V_el =
        (R(1.0)/R(2.0))*k_1_1*((t11 - t8)*(t11 - t8)) + (R(1.0)/R(2.0))*k_1_2*((delta_x_1 - t11)*(delta_x_1
        - t11)) + (R(1.0)/R(2.0))*k_1_3*((-delta_x_1 + t8)*(-delta_x_1 + t8)) + (R(1.0)/R(2.0))*k_2_1*((t12
        - t9)*(t12 - t9)) + (R(1.0)/R(2.0))*k_2_2*((delta_x_2 - t12)*(delta_x_2 - t12))
        + (R(1.0)/R(2.0))*k_2_3*((-delta_x_2 + t9)*(-delta_x_2 + t9)) + (R(1.0)/R(2.0))*k_3_1*((-t10
        + t7)*(-t10 + t7)) + (R(1.0)/R(2.0))*k_3_2*((delta_x_3 - t7)*(delta_x_3 - t7))
        + (R(1.0)/R(2.0))*k_3_3*((-delta_x_3 + t10)*(-delta_x_3 + t10));
}

void linear_delta_elastic_gradient(const pkmodes_real p[3], const pkmodes_real delta_q[9],
    const linear_delta_parameters *parameters, pkmodes_real E[9])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real delta_x_1 = delta_q[0];
    const pkmodes_real delta_x_2 = delta_q[1];
    const pkmodes_real delta_x_3 = delta_q[2];
    const pkmodes_real delta_theta_1_1 = delta_q[3];
    const pkmodes_real delta_theta_2_1 = delta_q[4];
    const pkmodes_real delta_theta_3_1 = delta_q[5];
    const pkmodes_real delta_theta_1_2 = delta_q[6];
    const pkmodes_real delta_theta_2_2 = delta_q[7];
    const pkmodes_real delta_theta_3_2 = delta_q[8];
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
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t2 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t2 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t1/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t3 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t3/l_f_2_1;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t4 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t3/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t4 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t3/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t5 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t5/l_f_3_1;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t6 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t5/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t6 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t5/l_f_3_3;
    const pkmodes_real t7 = -2*delta_x_1;
    const pkmodes_real t8 = R_p_1*delta_theta_1_2;
    const pkmodes_real t9 = R_p_1*delta_theta_1_1;
    const pkmodes_real t10 = R_p_2*delta_theta_2_2;
    const pkmodes_real t11 = R_p_2*delta_theta_2_1;
    const pkmodes_real t12 = -2*delta_x_2;
    const pkmodes_real t13 = -2*delta_x_3;
    const pkmodes_real t14 = R_p_3*delta_theta_3_2;
    const pkmodes_real t15 = R_p_3*delta_theta_3_1;
    const pkmodes_real t16 = R_p_1*k_1_1*(t8 - t9);
    const pkmodes_real t17 = R_p_2*k_2_1*(t10 - t11);
    const pkmodes_real t18 = R_p_3*k_3_1*(t14 - t15);
    E[0] = (R(1.0)/R(2.0))*k_1_2*(-t7 - 2*t8) + (R(1.0)/R(2.0))*k_1_3*(-t7 - 2*t9);
    E[1] = (R(1.0)/R(2.0))*k_2_2*(-2*t10 - t12) + (R(1.0)/R(2.0))*k_2_3*(-2*t11 - t12);
    E[2] = (R(1.0)/R(2.0))*k_3_2*(-t13 - 2*t14) + (R(1.0)/R(2.0))*k_3_3*(-t13 - 2*t15);
    E[3] = R_p_1*k_1_3*(-delta_x_1 + t9) - t16;
    E[4] = R_p_2*k_2_3*(-delta_x_2 + t11) - t17;
    E[5] = R_p_3*k_3_3*(-delta_x_3 + t15) - t18;
    E[6] = -R_p_1*k_1_2*(delta_x_1 - t8) + t16;
    E[7] = -R_p_2*k_2_2*(delta_x_2 - t10) + t17;
    E[8] = -R_p_3*k_3_2*(delta_x_3 - t14) + t18;
}

void linear_delta_elastic_hessian(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real H_el[9][9])
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
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t1 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t1/l_f_1_1;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t2 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t1/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t2 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t1/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t3 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t3/l_f_2_1;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t4 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t3/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t4 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t3/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t5 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t5/l_f_3_1;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t6 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t5/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t6 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t5/l_f_3_3;
    const pkmodes_real t7 = (R_p_1*R_p_1);
    const pkmodes_real t8 = k_1_1*t7;
    const pkmodes_real t9 = (R_p_2*R_p_2);
    const pkmodes_real t10 = k_2_1*t9;
    const pkmodes_real t11 = (R_p_3*R_p_3);
    const pkmodes_real t12 = k_3_1*t11;
    memset(H_el, 0, sizeof(pkmodes_real[9][9]));
    H_el[0][0] = k_1_2 + k_1_3;
    H_el[0][3] = H_el[3][0] = -R_p_1*k_1_3;
    H_el[0][6] = H_el[6][0] = -R_p_1*k_1_2;
    H_el[1][1] = k_2_2 + k_2_3;
    H_el[1][4] = H_el[4][1] = -R_p_2*k_2_3;
    H_el[1][7] = H_el[7][1] = -R_p_2*k_2_2;
    H_el[2][2] = k_3_2 + k_3_3;
    H_el[2][5] = H_el[5][2] = -R_p_3*k_3_3;
    H_el[2][8] = H_el[8][2] = -R_p_3*k_3_2;
    H_el[3][3] = k_1_3*t7 + t8;
    H_el[3][6] = H_el[6][3] = -t8;
    H_el[4][4] = k_2_3*t9 + t10;
    H_el[4][7] = H_el[7][4] = -t10;
    H_el[5][5] = k_3_3*t11 + t12;
    H_el[5][8] = H_el[8][5] = -t12;
    H_el[6][6] = k_1_2*t7 + t8;
    H_el[7][7] = k_2_2*t9 + t10;
    H_el[8][8] = k_3_2*t11 + t12;
}

void linear_delta_static_equilibrium(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real tau_st[3], pkmodes_real theta_st[6])
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
    const pkmodes_real t5 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t5/l_f_1_1;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t6 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t5/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t6 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t5/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t7 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t7/l_f_2_1;
    const pkmodes_real t8 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t8 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t7/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t8 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t7/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t9 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t9/l_f_3_1;
    const pkmodes_real t10 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t10 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t9/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t10 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t9/l_f_3_3;
    const pkmodes_real t11 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t12 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t14 = m_p + t11 + t12 + t13;
    const pkmodes_real t15 = g_x*t14;
    const pkmodes_real t16 = g_y*t14;
    const pkmodes_real t17 = g_z*t14;
    const pkmodes_real G_1 =
        -D_p_x_1*t15 - D_p_y_1*t16 - D_p_z_1*t17 - g_x*(m_t_1*n_1_x + n_1_x*t11) - g_y*(m_t_1*n_1_y
        + n_1_y*t11) - g_z*(m_t_1*n_1_z + n_1_z*t11);
    const pkmodes_real G_2 =
        -D_p_x_2*t15 - D_p_y_2*t16 - D_p_z_2*t17 - g_x*(m_t_2*n_2_x + n_2_x*t12) - g_y*(m_t_2*n_2_y
        + n_2_y*t12) - g_z*(m_t_2*n_2_z + n_2_z*t12);
    const pkmodes_real G_3 =
        -D_p_x_3*t15 - D_p_y_3*t16 - D_p_z_3*t17 - g_x*(m_t_3*n_3_x + n_3_x*t13) - g_y*(m_t_3*n_3_y
        + n_3_y*t13) - g_z*(m_t_3*n_3_z + n_3_z*t13);
    const pkmodes_real t18 = (R_p_1*R_p_1);
    const pkmodes_real t19 = k_1_1*t18;
    const pkmodes_real t20 = k_1_3*t18;
    const pkmodes_real t21 = -d_1_1*t19 + d_1_2*(t19 + t20);
    const pkmodes_real t22 = k_1_2*t18;
    const pkmodes_real t23 = d_1_1*(t19 + t22) - d_1_2*t19;
    const pkmodes_real det_1 = R_p_1*k_1_2*t21 - R_p_1*k_1_3*t23;
    const pkmodes_real t24 = G_1/det_1;
    const pkmodes_real theta_1_1_st = -t23*t24;
    const pkmodes_real theta_1_2_st = t21*t24;
    const pkmodes_real t25 = (R_p_2*R_p_2);
    const pkmodes_real t26 = k_2_1*t25;
    const pkmodes_real t27 = k_2_3*t25;
    const pkmodes_real t28 = -d_2_1*t26 + d_2_2*(t26 + t27);
    const pkmodes_real t29 = k_2_2*t25;
    const pkmodes_real t30 = d_2_1*(t26 + t29) - d_2_2*t26;
    const pkmodes_real det_2 = R_p_2*k_2_2*t28 - R_p_2*k_2_3*t30;
    const pkmodes_real t31 = G_2/det_2;
    const pkmodes_real theta_2_1_st = -t30*t31;
    const pkmodes_real theta_2_2_st = t28*t31;
    const pkmodes_real t32 = (R_p_3*R_p_3);
    const pkmodes_real t33 = k_3_1*t32;
    const pkmodes_real t34 = k_3_3*t32;
    const pkmodes_real t35 = -d_3_1*t33 + d_3_2*(t33 + t34);
    const pkmodes_real t36 = k_3_2*t32;
    const pkmodes_real t37 = d_3_1*(t33 + t36) - d_3_2*t33;
    const pkmodes_real det_3 = R_p_3*k_3_2*t35 - R_p_3*k_3_3*t37;
    const pkmodes_real t38 = G_3/det_3;
    const pkmodes_real theta_3_1_st = -t37*t38;
    const pkmodes_real theta_3_2_st = t35*t38;
    const pkmodes_real t39 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st);
    const pkmodes_real tau_st_1 = d_1_1*(t20*theta_1_1_st - t39) + d_1_2*(t22*theta_1_2_st + t39);
    const pkmodes_real t40 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st);
    const pkmodes_real tau_st_2 = d_2_1*(t27*theta_2_1_st - t40) + d_2_2*(t29*theta_2_2_st + t40);
    const pkmodes_real t41 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st);
    const pkmodes_real tau_st_3 = d_3_1*(t34*theta_3_1_st - t41) + d_3_2*(t36*theta_3_2_st + t41);
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

void linear_delta_stiffness_matrix(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real K[9][9])
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
    const pkmodes_real x_min_1 = parameters->limits[0][0];
    const pkmodes_real x_max_1 = parameters->limits[0][1];
    const pkmodes_real x_min_2 = parameters->limits[1][0];
    const pkmodes_real x_max_2 = parameters->limits[1][1];
    const pkmodes_real x_min_3 = parameters->limits[2][0];
    const pkmodes_real x_max_3 = parameters->limits[2][1];
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
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t5 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t5/l_f_1_1;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t6 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t5/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t6 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t5/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t7 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t7/l_f_2_1;
    const pkmodes_real t8 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t8 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t7/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t8 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t7/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t9 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t9/l_f_3_1;
    const pkmodes_real t10 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t10 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t9/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t10 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t9/l_f_3_3;
    const pkmodes_real t11 = (R(1.0)/R(2.0))*m_d_1 + (R(1.0)/R(2.0))*m_d_2 + (R(1.0)/R(2.0))*m_d_3 + m_p;
    const pkmodes_real t12 = g_x*t11;
    const pkmodes_real t13 = g_y*t11;
    const pkmodes_real t14 = g_z*t11;
    const pkmodes_real mu_1 = t1*(-A_x_1*t12 - A_y_1*t13 - A_z_1*t14);
    const pkmodes_real mu_2 = t1*(-A_x_2*t12 - A_y_2*t13 - A_z_2*t14);
    const pkmodes_real mu_3 = t1*(-A_x_3*t12 - A_y_3*t13 - A_z_3*t14);
    const pkmodes_real t15 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t16 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t17 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t18 = D_p_x_1*mu_3;
    const pkmodes_real t19 = D_p_x_1*mu_2;
    const pkmodes_real t20 = U_1_x_1*mu_1;
    const pkmodes_real t21 = D_p_y_1*mu_3;
    const pkmodes_real t22 = D_p_y_1*mu_2;
    const pkmodes_real t23 = U_1_y_1*mu_1;
    const pkmodes_real t24 = D_p_z_1*mu_3;
    const pkmodes_real t25 = D_p_z_1*mu_2;
    const pkmodes_real t26 = U_1_z_1*mu_1;
    const pkmodes_real t27 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t28 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t29 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t30 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t31 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t32 = (D_p_z_3*D_p_z_3);
    const pkmodes_real t33 = (R_p_1*R_p_1);
    const pkmodes_real t34 = k_1_1*t33;
    const pkmodes_real t35 = (R_p_2*R_p_2);
    const pkmodes_real t36 = k_2_1*t35;
    const pkmodes_real t37 = (R_p_3*R_p_3);
    const pkmodes_real t38 = k_3_1*t37;
    memset(K, 0, sizeof(pkmodes_real[9][9]));
    K[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + k_1_2 + k_1_3 - mu_2*t15
        - mu_2*t16 - mu_2*t17 - mu_3*t15 - mu_3*t16 - mu_3*t17;
    K[0][1] = K[1][0] =
        -D_p_x_2*t18 - D_p_x_2*t20 - D_p_y_2*t21 - D_p_y_2*t23 - D_p_z_2*t24 - D_p_z_2*t26 - U_2_x_2*t19
        - U_2_y_2*t22 - U_2_z_2*t25;
    K[0][2] = K[2][0] =
        -D_p_x_3*t19 - D_p_x_3*t20 - D_p_y_3*t22 - D_p_y_3*t23 - D_p_z_3*t25 - D_p_z_3*t26 - U_3_x_3*t18
        - U_3_y_3*t21 - U_3_z_3*t24;
    K[0][3] = K[3][0] = -R_p_1*k_1_3;
    K[0][6] = K[6][0] = -R_p_1*k_1_2;
    K[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + k_2_2 + k_2_3 - mu_1*t27
        - mu_1*t28 - mu_1*t29 - mu_3*t27 - mu_3*t28 - mu_3*t29;
    K[1][2] = K[2][1] =
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2;
    K[1][4] = K[4][1] = -R_p_2*k_2_3;
    K[1][7] = K[7][1] = -R_p_2*k_2_2;
    K[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + k_3_2 + k_3_3 - mu_1*t30
        - mu_1*t31 - mu_1*t32 - mu_2*t30 - mu_2*t31 - mu_2*t32;
    K[2][5] = K[5][2] = -R_p_3*k_3_3;
    K[2][8] = K[8][2] = -R_p_3*k_3_2;
    K[3][3] = k_1_3*t33 + t34;
    K[3][6] = K[6][3] = -t34;
    K[4][4] = k_2_3*t35 + t36;
    K[4][7] = K[7][4] = -t36;
    K[5][5] = k_3_3*t37 + t38;
    K[5][8] = K[8][5] = -t38;
    K[6][6] = k_1_2*t33 + t34;
    K[7][7] = k_2_2*t35 + t36;
    K[8][8] = k_3_2*t37 + t38;
}

void linear_delta_modal_matrices(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real M[9][9], pkmodes_real K[9][9])
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
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z;
    const pkmodes_real t5 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t5;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t5;
    const pkmodes_real t6 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t6;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t6;
    const pkmodes_real t7 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t7;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t7;
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t8 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t8/l_f_1_1;
    const pkmodes_real t9 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t9 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t8/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t9 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t8/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t10 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t10/l_f_2_1;
    const pkmodes_real t11 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t11 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t10/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t11 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t10/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t12 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t12/l_f_3_1;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t13 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t12/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t13 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t12/l_f_3_3;
    const pkmodes_real t14 = (R(1.0)/R(2.0))*m_d_1 + (R(1.0)/R(2.0))*m_d_2 + (R(1.0)/R(2.0))*m_d_3 + m_p;
    const pkmodes_real t15 = g_x*t14;
    const pkmodes_real t16 = g_y*t14;
    const pkmodes_real t17 = g_z*t14;
    const pkmodes_real mu_1 = t1*(-A_x_1*t15 - A_y_1*t16 - A_z_1*t17);
    const pkmodes_real mu_2 = t1*(-A_x_2*t15 - A_y_2*t16 - A_z_2*t17);
    const pkmodes_real mu_3 = t1*(-A_x_3*t15 - A_y_3*t16 - A_z_3*t17);
    const pkmodes_real t18 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t19 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t20 = n_1_x*t19;
    const pkmodes_real t21 = n_1_y*t19;
    const pkmodes_real t22 = n_1_z*t19;
    const pkmodes_real t23 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t24 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t25 = m_p + t18 + t23 + t24;
    const pkmodes_real t26 = D_p_x_1*t25 + t20;
    const pkmodes_real t27 = D_p_y_1*t25 + t21;
    const pkmodes_real t28 = D_p_z_1*t25 + t22;
    const pkmodes_real t29 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t30 = n_2_x*t29;
    const pkmodes_real t31 = n_2_y*t29;
    const pkmodes_real t32 = n_2_z*t29;
    const pkmodes_real t33 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t34 = n_3_x*t33;
    const pkmodes_real t35 = n_3_y*t33;
    const pkmodes_real t36 = n_3_z*t33;
    const pkmodes_real t37 = D_p_x_2*t25 + t30;
    const pkmodes_real t38 = D_p_y_2*t25 + t31;
    const pkmodes_real t39 = D_p_z_2*t25 + t32;
    const pkmodes_real t40 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t41 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t42 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t43 = D_p_x_1*mu_3;
    const pkmodes_real t44 = D_p_x_1*mu_2;
    const pkmodes_real t45 = U_1_x_1*mu_1;
    const pkmodes_real t46 = D_p_y_1*mu_3;
    const pkmodes_real t47 = D_p_y_1*mu_2;
    const pkmodes_real t48 = U_1_y_1*mu_1;
    const pkmodes_real t49 = D_p_z_1*mu_3;
    const pkmodes_real t50 = D_p_z_1*mu_2;
    const pkmodes_real t51 = U_1_z_1*mu_1;
    const pkmodes_real t52 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t53 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t54 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t55 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t56 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t57 = (D_p_z_3*D_p_z_3);
    const pkmodes_real t58 = (R_p_1*R_p_1);
    const pkmodes_real t59 = k_1_1*t58;
    const pkmodes_real t60 = (R_p_2*R_p_2);
    const pkmodes_real t61 = k_2_1*t60;
    const pkmodes_real t62 = (R_p_3*R_p_3);
    const pkmodes_real t63 = k_3_1*t62;
    memset(M, 0, sizeof(pkmodes_real[9][9]));
    M[0][0] = D_p_x_1*t20 + D_p_x_1*t26 + D_p_y_1*t21 + D_p_y_1*t27 + D_p_z_1*t22 + D_p_z_1*t28 + m_t_1 + t18;
    M[0][1] = M[1][0] = D_p_x_1*t30 + D_p_x_2*t26 + D_p_y_1*t31 + D_p_y_2*t27 + D_p_z_1*t32 + D_p_z_2*t28;
    M[0][2] = M[2][0] = D_p_x_1*t34 + D_p_x_3*t26 + D_p_y_1*t35 + D_p_y_3*t27 + D_p_z_1*t36 + D_p_z_3*t28;
    M[1][1] = D_p_x_2*t30 + D_p_x_2*t37 + D_p_y_2*t31 + D_p_y_2*t38 + D_p_z_2*t32 + D_p_z_2*t39 + m_t_2 + t23;
    M[1][2] = M[2][1] = D_p_x_2*t34 + D_p_x_3*t37 + D_p_y_2*t35 + D_p_y_3*t38 + D_p_z_2*t36 + D_p_z_3*t39;
    M[2][2] =
        D_p_x_3*t34 + D_p_x_3*(D_p_x_3*t25 + t34) + D_p_y_3*t35 + D_p_y_3*(D_p_y_3*t25 + t35) + D_p_z_3*t36
        + D_p_z_3*(D_p_z_3*t25 + t36) + m_t_3 + t24;
    M[3][3] = I_1_1;
    M[4][4] = I_2_1;
    M[5][5] = I_3_1;
    M[6][6] = I_1_2;
    M[7][7] = I_2_2;
    M[8][8] = I_3_2;
    memset(K, 0, sizeof(pkmodes_real[9][9]));
    K[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + k_1_2 + k_1_3 - mu_2*t40
        - mu_2*t41 - mu_2*t42 - mu_3*t40 - mu_3*t41 - mu_3*t42;
    K[0][1] = K[1][0] =
        -D_p_x_2*t43 - D_p_x_2*t45 - D_p_y_2*t46 - D_p_y_2*t48 - D_p_z_2*t49 - D_p_z_2*t51 - U_2_x_2*t44
        - U_2_y_2*t47 - U_2_z_2*t50;
    K[0][2] = K[2][0] =
        -D_p_x_3*t44 - D_p_x_3*t45 - D_p_y_3*t47 - D_p_y_3*t48 - D_p_z_3*t50 - D_p_z_3*t51 - U_3_x_3*t43
        - U_3_y_3*t46 - U_3_z_3*t49;
    K[0][3] = K[3][0] = -R_p_1*k_1_3;
    K[0][6] = K[6][0] = -R_p_1*k_1_2;
    K[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + k_2_2 + k_2_3 - mu_1*t52
        - mu_1*t53 - mu_1*t54 - mu_3*t52 - mu_3*t53 - mu_3*t54;
    K[1][2] = K[2][1] =
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2;
    K[1][4] = K[4][1] = -R_p_2*k_2_3;
    K[1][7] = K[7][1] = -R_p_2*k_2_2;
    K[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + k_3_2 + k_3_3 - mu_1*t55
        - mu_1*t56 - mu_1*t57 - mu_2*t55 - mu_2*t56 - mu_2*t57;
    K[2][5] = K[5][2] = -R_p_3*k_3_3;
    K[2][8] = K[8][2] = -R_p_3*k_3_2;
    K[3][3] = k_1_3*t58 + t59;
    K[3][6] = K[6][3] = -t59;
    K[4][4] = k_2_3*t60 + t61;
    K[4][7] = K[7][4] = -t61;
    K[5][5] = k_3_3*t62 + t63;
    K[5][8] = K[8][5] = -t63;
    K[6][6] = k_1_2*t58 + t59;
    K[7][7] = k_2_2*t60 + t61;
    K[8][8] = k_3_2*t62 + t63;
}

/* Coordinates, and the most iterations for one eigenvalue; two are usual. */
enum { N = LINEAR_DELTA_COORDINATES, EIGEN_ITERATIONS = 60 };

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
int linear_delta_status(const pkmodes_real p[3], const linear_delta_parameters *parameters)
{
    int i;
    for (i = 0; i < LINEAR_DELTA_POSE; ++i)
        if (!isfinite(p[i]))
            return LINEAR_DELTA_NOT_FINITE;
    {
        pkmodes_real margin[3];
        linear_delta_reach_margin(p, parameters, margin);
        for (i = 0; i < 3; ++i)
            if (!(((const pkmodes_real *)margin)[i] >= 0))
                return LINEAR_DELTA_BEYOND_REACHABLE;
    }
    {
        pkmodes_real determinant, condition;
        linear_delta_jacobian_condition(p, parameters, &determinant, &condition);
        for (i = 0; i < 1; ++i)
            if (!(((const pkmodes_real *)&condition)[i] <= LINEAR_DELTA_MAX_CONDITION))
                return LINEAR_DELTA_BEYOND_SINGULAR;
    }
    {
        pkmodes_real l_f[3][3];
        linear_delta_belt_spans(p, parameters, l_f);
        for (i = 0; i < 9; ++i)
            if (!(((const pkmodes_real *)l_f)[i] > 0))
                return LINEAR_DELTA_BEYOND_LIMITS;
    }
    return 0;
}

int linear_delta_modes(
    const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real f[9], pkmodes_real phi[9][9])
{
    pkmodes_real M[N][N], K[N][N];
    const int status = linear_delta_status(p, parameters);
    if (status)
        return status;
    linear_delta_modal_matrices(p, parameters, M, K);
    if (eigen_solve(N, M, K, f, phi) || eigen_lost(N, f, LINEAR_DELTA_RIGID_MODES))
        return LINEAR_DELTA_UNSOLVED;
    eigen_frequencies(N, f);
    return 0;
}

int linear_delta_natural_frequencies(
    const pkmodes_real p[3], const linear_delta_parameters *parameters, pkmodes_real f[9])
{
    return linear_delta_modes(p, parameters, f, NULL);
}
