/* Generated from the derivation of rotary_delta.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism rotary_delta, for a robot given by its parameters.
 * The header describes every function.
 *
 * Names in the code.  Indices: axis j; coordinate k of a derivative; coordinate l of a second derivative;
 * component i = x, y, z.  t1, t2, ... are subexpressions shared by several values.
 *   theta_j [rad]: angle of arm j
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
 *   S_j_i [m]: centre of sphere j, on which the platform centre lies, component i
 *   alpha_i [m]: vector from sphere centre 1 to sphere centre 2, component i
 *   beta_i [m]: vector from sphere centre 1 to sphere centre 3, component i
 *   nu_i [m^2]: normal to the plane of the sphere centres, component i
 *   nu2 [m^4]: squared length of nu
 *   h_j [m^2]: scalar product of p - S_1 with the vector from sphere centre 1 to sphere centre j
 *   q_i [m]: projection of p onto the plane of the sphere centres, relative to S_1, component i
 *   v_p_i [m/s]: velocity of the platform, component i
 *   D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
 *   A_i_j [m^2]: adjugate of D_l, entry i, j
 *   det_D_l [m^3]: determinant of D_l
 *   D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
 *   U_j_i_k [m]: derivative of linkage vector j, component i, with respect to theta_k
 *   f_j_kl [m^2]: right-hand side of closure j, differentiated with respect to theta_k and theta_l
 *   P_i_kl [m]: second derivative of p_i with respect to theta_k and theta_l
 *   s_dot_j_i [m/s]: rate of change of linkage vector j, component i
 *   D_p_dot_i_k [m/s]: time derivative of dp_i/dtheta_k
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 *   G_j [N m]: gradient of the gravitational potential energy with respect to theta_j
 *   phi_j_st [rad]: static angle of motor j divided by the gear ratio, relative to the unstrained
 *     transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "rotary_delta.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void rotary_delta_inverse_kinematics(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real theta[3])
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
    const pkmodes_real theta_1 = R(atan2)(sn_1, c_1);
    const pkmodes_real A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const pkmodes_real B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const pkmodes_real rho2_2 = (A_2*A_2) + (B_2*B_2);
    const pkmodes_real C_2 =
        (R(1.0)/R(2.0))*((L_a_2*L_a_2) - (l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z))/L_a_2;
    const pkmodes_real S_2 = sigma_2*R(sqrt)(-(C_2*C_2) + rho2_2);
    const pkmodes_real t2 = 1/rho2_2;
    const pkmodes_real c_2 = t2*(A_2*C_2 - B_2*S_2);
    const pkmodes_real sn_2 = t2*(A_2*S_2 + B_2*C_2);
    const pkmodes_real theta_2 = R(atan2)(sn_2, c_2);
    const pkmodes_real A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const pkmodes_real B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const pkmodes_real rho2_3 = (A_3*A_3) + (B_3*B_3);
    const pkmodes_real C_3 =
        (R(1.0)/R(2.0))*((L_a_3*L_a_3) - (l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z))/L_a_3;
    const pkmodes_real S_3 = sigma_3*R(sqrt)(-(C_3*C_3) + rho2_3);
    const pkmodes_real t3 = 1/rho2_3;
    const pkmodes_real c_3 = t3*(A_3*C_3 - B_3*S_3);
    const pkmodes_real sn_3 = t3*(A_3*S_3 + B_3*C_3);
    const pkmodes_real theta_3 = R(atan2)(sn_3, c_3);
    theta[0] = theta_1;
    theta[1] = theta_2;
    theta[2] = theta_3;
}

void rotary_delta_reach_margin(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real margin[3][2])
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
    const pkmodes_real A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const pkmodes_real B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const pkmodes_real rho2_2 = (A_2*A_2) + (B_2*B_2);
    const pkmodes_real A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const pkmodes_real B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const pkmodes_real rho2_3 = (A_3*A_3) + (B_3*B_3);
    const pkmodes_real t1 = 2*L_a_1*R(sqrt)(rho2_1);
    const pkmodes_real t2 = (L_a_1*L_a_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z);
    const pkmodes_real t3 = 2*L_a_2*R(sqrt)(rho2_2);
    const pkmodes_real t4 = (L_a_2*L_a_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z);
    const pkmodes_real t5 = 2*L_a_3*R(sqrt)(rho2_3);
    const pkmodes_real t6 = (L_a_3*L_a_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z);
    margin[0][0] = l_d_1 - R(sqrt)(-t1 + t2);
    margin[0][1] = -l_d_1 + R(sqrt)(t1 + t2);
    margin[1][0] = l_d_2 - R(sqrt)(-t3 + t4);
    margin[1][1] = -l_d_2 + R(sqrt)(t3 + t4);
    margin[2][0] = l_d_3 - R(sqrt)(-t5 + t6);
    margin[2][1] = -l_d_3 + R(sqrt)(t5 + t6);
}

void rotary_delta_limit_margin(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real margin[3][2])
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
    const pkmodes_real theta_min_1 = parameters->limits[0][0];
    const pkmodes_real theta_max_1 = parameters->limits[0][1];
    const pkmodes_real theta_min_2 = parameters->limits[1][0];
    const pkmodes_real theta_max_2 = parameters->limits[1][1];
    const pkmodes_real theta_min_3 = parameters->limits[2][0];
    const pkmodes_real theta_max_3 = parameters->limits[2][1];
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
    const pkmodes_real theta_1 = R(atan2)(sn_1, c_1);
    const pkmodes_real A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const pkmodes_real B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const pkmodes_real rho2_2 = (A_2*A_2) + (B_2*B_2);
    const pkmodes_real C_2 =
        (R(1.0)/R(2.0))*((L_a_2*L_a_2) - (l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z))/L_a_2;
    const pkmodes_real S_2 = sigma_2*R(sqrt)(-(C_2*C_2) + rho2_2);
    const pkmodes_real t2 = 1/rho2_2;
    const pkmodes_real c_2 = t2*(A_2*C_2 - B_2*S_2);
    const pkmodes_real sn_2 = t2*(A_2*S_2 + B_2*C_2);
    const pkmodes_real theta_2 = R(atan2)(sn_2, c_2);
    const pkmodes_real A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const pkmodes_real B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const pkmodes_real rho2_3 = (A_3*A_3) + (B_3*B_3);
    const pkmodes_real C_3 =
        (R(1.0)/R(2.0))*((L_a_3*L_a_3) - (l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z))/L_a_3;
    const pkmodes_real S_3 = sigma_3*R(sqrt)(-(C_3*C_3) + rho2_3);
    const pkmodes_real t3 = 1/rho2_3;
    const pkmodes_real c_3 = t3*(A_3*C_3 - B_3*S_3);
    const pkmodes_real sn_3 = t3*(A_3*S_3 + B_3*C_3);
    const pkmodes_real theta_3 = R(atan2)(sn_3, c_3);
    margin[0][0] = theta_1 - theta_min_1;
    margin[0][1] = -theta_1 + theta_max_1;
    margin[1][0] = theta_2 - theta_min_2;
    margin[1][1] = -theta_2 + theta_max_2;
    margin[2][0] = theta_3 - theta_min_3;
    margin[2][1] = -theta_3 + theta_max_3;
}

void rotary_delta_perpendicular_margin(const rotary_delta_parameters *parameters, pkmodes_real margin[3])
{
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
    margin[0] =
        R(1.0)/R(1000000000000.0) - ((a_1_x*z_1_x + a_1_y*z_1_y + a_1_z*z_1_z)*(a_1_x*z_1_x + a_1_y*z_1_y
        + a_1_z*z_1_z));
    margin[1] =
        R(1.0)/R(1000000000000.0) - ((a_2_x*z_2_x + a_2_y*z_2_y + a_2_z*z_2_z)*(a_2_x*z_2_x + a_2_y*z_2_y
        + a_2_z*z_2_z));
    margin[2] =
        R(1.0)/R(1000000000000.0) - ((a_3_x*z_3_x + a_3_y*z_3_y + a_3_z*z_3_z)*(a_3_x*z_3_x + a_3_y*z_3_y
        + a_3_z*z_3_z));
}

void rotary_delta_inertia_margin(const rotary_delta_parameters *parameters, pkmodes_real margin[3])
{
    const pkmodes_real m_a_1 = parameters->arm_mass[0];
    const pkmodes_real m_a_2 = parameters->arm_mass[1];
    const pkmodes_real m_a_3 = parameters->arm_mass[2];
    const pkmodes_real r_a_1 = parameters->arm_center[0];
    const pkmodes_real r_a_2 = parameters->arm_center[1];
    const pkmodes_real r_a_3 = parameters->arm_center[2];
    const pkmodes_real I_a_1 = parameters->arm_inertia[0];
    const pkmodes_real I_a_2 = parameters->arm_inertia[1];
    const pkmodes_real I_a_3 = parameters->arm_inertia[2];
    margin[0] = I_a_1 - m_a_1*(r_a_1*r_a_1);
    margin[1] = I_a_2 - m_a_2*(r_a_2*r_a_2);
    margin[2] = I_a_3 - m_a_3*(r_a_3*r_a_3);
}

void rotary_delta_direct_kinematics(const pkmodes_real theta[3], pkmodes_real assembly,
    const rotary_delta_parameters *parameters, pkmodes_real p[3])
{
    const pkmodes_real theta_1 = theta[0];
    const pkmodes_real theta_2 = theta[1];
    const pkmodes_real theta_3 = theta[2];
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
    const pkmodes_real t1 = R(cos)(theta_1);
    const pkmodes_real t2 = R(sin)(theta_1);
    const pkmodes_real S_1_x = L_a_1*(t1*z_1_x + t2*(a_1_y*z_1_z - a_1_z*z_1_y)) - b_1_x + o_1_x;
    const pkmodes_real S_1_y = L_a_1*(t1*z_1_y + t2*(-a_1_x*z_1_z + a_1_z*z_1_x)) - b_1_y + o_1_y;
    const pkmodes_real S_1_z = L_a_1*(t1*z_1_z + t2*(a_1_x*z_1_y - a_1_y*z_1_x)) - b_1_z + o_1_z;
    const pkmodes_real t3 = R(cos)(theta_2);
    const pkmodes_real t4 = R(sin)(theta_2);
    const pkmodes_real S_2_x = L_a_2*(t3*z_2_x + t4*(a_2_y*z_2_z - a_2_z*z_2_y)) - b_2_x + o_2_x;
    const pkmodes_real S_2_y = L_a_2*(t3*z_2_y + t4*(-a_2_x*z_2_z + a_2_z*z_2_x)) - b_2_y + o_2_y;
    const pkmodes_real S_2_z = L_a_2*(t3*z_2_z + t4*(a_2_x*z_2_y - a_2_y*z_2_x)) - b_2_z + o_2_z;
    const pkmodes_real t5 = R(cos)(theta_3);
    const pkmodes_real t6 = R(sin)(theta_3);
    const pkmodes_real S_3_x = L_a_3*(t5*z_3_x + t6*(a_3_y*z_3_z - a_3_z*z_3_y)) - b_3_x + o_3_x;
    const pkmodes_real S_3_y = L_a_3*(t5*z_3_y + t6*(-a_3_x*z_3_z + a_3_z*z_3_x)) - b_3_y + o_3_y;
    const pkmodes_real S_3_z = L_a_3*(t5*z_3_z + t6*(a_3_x*z_3_y - a_3_y*z_3_x)) - b_3_z + o_3_z;
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
    const pkmodes_real t7 = (l_d_1*l_d_1);
    const pkmodes_real t8 = (R(1.0)/R(2.0))*t7;
    const pkmodes_real h_2 =
        (R(1.0)/R(2.0))*(alpha_x*alpha_x) + (R(1.0)/R(2.0))*(alpha_y*alpha_y)
        + (R(1.0)/R(2.0))*(alpha_z*alpha_z) - R(1.0)/R(2.0)*(l_d_2*l_d_2) + t8;
    const pkmodes_real h_3 =
        (R(1.0)/R(2.0))*(beta_x*beta_x) + (R(1.0)/R(2.0))*(beta_y*beta_y) + (R(1.0)/R(2.0))*(beta_z*beta_z)
        - R(1.0)/R(2.0)*(l_d_3*l_d_3) + t8;
    const pkmodes_real t9 = 1/nu2;
    const pkmodes_real q_x = t9*(h_2*(beta_y*nu_z - beta_z*nu_y) + h_3*(-alpha_y*nu_z + alpha_z*nu_y));
    const pkmodes_real q_y = t9*(h_2*(-beta_x*nu_z + beta_z*nu_x) + h_3*(alpha_x*nu_z - alpha_z*nu_x));
    const pkmodes_real q_z = t9*(h_2*(beta_x*nu_y - beta_y*nu_x) + h_3*(-alpha_x*nu_y + alpha_y*nu_x));
    const pkmodes_real t10 = assembly*R(sqrt)(t9*(-(q_x*q_x) - (q_y*q_y) - (q_z*q_z) + t7));
    p[0] = S_1_x + nu_x*t10 + q_x;
    p[1] = S_1_y + nu_y*t10 + q_y;
    p[2] = S_1_z + nu_z*t10 + q_z;
}

void rotary_delta_constraint_jacobians(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
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

void rotary_delta_jacobian_condition(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
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
    const pkmodes_real d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const pkmodes_real d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const pkmodes_real d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const pkmodes_real d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const pkmodes_real d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const pkmodes_real d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const pkmodes_real s_1_x = -L_a_1*d_1_x + r_1_x;
    const pkmodes_real s_1_y = -L_a_1*d_1_y + r_1_y;
    const pkmodes_real s_1_z = -L_a_1*d_1_z + r_1_z;
    const pkmodes_real s_2_x = -L_a_2*d_2_x + r_2_x;
    const pkmodes_real s_2_y = -L_a_2*d_2_y + r_2_y;
    const pkmodes_real s_2_z = -L_a_2*d_2_z + r_2_z;
    const pkmodes_real s_3_x = -L_a_3*d_3_x + r_3_x;
    const pkmodes_real s_3_y = -L_a_3*d_3_y + r_3_y;
    const pkmodes_real s_3_z = -L_a_3*d_3_z + r_3_z;
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
    const pkmodes_real t4 = 1/((det_D_l*det_D_l));
    *determinant = det_D_l;
    *condition =
        R(sqrt)((s_1_x*s_1_x) + (s_1_y*s_1_y) + (s_1_z*s_1_z) + (s_2_x*s_2_x) + (s_2_y*s_2_y) + (s_2_z*s_2_z)
        + (s_3_x*s_3_x) + (s_3_y*s_3_y) + (s_3_z*s_3_z))*R(sqrt)((A_x_1*A_x_1)*t4 + (A_x_2*A_x_2)*t4
        + (A_x_3*A_x_3)*t4 + (A_y_1*A_y_1)*t4 + (A_y_2*A_y_2)*t4 + (A_y_3*A_y_3)*t4 + (A_z_1*A_z_1)*t4
        + (A_z_2*A_z_2)*t4 + (A_z_3*A_z_3)*t4);
}

void rotary_delta_platform_jacobian(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
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

void rotary_delta_platform_jacobian_rate(const pkmodes_real p[3], const pkmodes_real theta_dot[3],
    const rotary_delta_parameters *parameters, pkmodes_real D_p_dot[3][3])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real theta_1_dot = theta_dot[0];
    const pkmodes_real theta_2_dot = theta_dot[1];
    const pkmodes_real theta_3_dot = theta_dot[2];
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
    const pkmodes_real t4 = L_a_1*d_1_x;
    const pkmodes_real s_1_x = r_1_x - t4;
    const pkmodes_real t5 = L_a_1*d_1_y;
    const pkmodes_real s_1_y = r_1_y - t5;
    const pkmodes_real t6 = L_a_1*d_1_z;
    const pkmodes_real s_1_z = r_1_z - t6;
    const pkmodes_real t7 = L_a_2*d_2_x;
    const pkmodes_real s_2_x = r_2_x - t7;
    const pkmodes_real t8 = L_a_2*d_2_y;
    const pkmodes_real s_2_y = r_2_y - t8;
    const pkmodes_real t9 = L_a_2*d_2_z;
    const pkmodes_real s_2_z = r_2_z - t9;
    const pkmodes_real t10 = L_a_3*d_3_x;
    const pkmodes_real s_3_x = r_3_x - t10;
    const pkmodes_real t11 = L_a_3*d_3_y;
    const pkmodes_real s_3_y = r_3_y - t11;
    const pkmodes_real t12 = L_a_3*d_3_z;
    const pkmodes_real s_3_z = r_3_z - t12;
    const pkmodes_real t13 = L_a_1*t_1_x;
    const pkmodes_real t14 = L_a_1*t_1_y;
    const pkmodes_real t15 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15;
    const pkmodes_real t16 = L_a_2*t_2_x;
    const pkmodes_real t17 = L_a_2*t_2_y;
    const pkmodes_real t18 = L_a_2*t_2_z;
    const pkmodes_real D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18;
    const pkmodes_real t19 = L_a_3*t_3_x;
    const pkmodes_real t20 = L_a_3*t_3_y;
    const pkmodes_real t21 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21;
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
    const pkmodes_real t22 = 1/det_D_l;
    const pkmodes_real t23 = D_r_1*t22;
    const pkmodes_real D_p_x_1 = A_x_1*t23;
    const pkmodes_real t24 = D_r_2*t22;
    const pkmodes_real D_p_x_2 = A_x_2*t24;
    const pkmodes_real t25 = D_r_3*t22;
    const pkmodes_real D_p_x_3 = A_x_3*t25;
    const pkmodes_real D_p_y_1 = A_y_1*t23;
    const pkmodes_real D_p_y_2 = A_y_2*t24;
    const pkmodes_real D_p_y_3 = A_y_3*t25;
    const pkmodes_real D_p_z_1 = A_z_1*t23;
    const pkmodes_real D_p_z_2 = A_z_2*t24;
    const pkmodes_real D_p_z_3 = A_z_3*t25;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t13;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t14;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t15;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t16;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t17;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t18;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t19;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t20;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t21;
    const pkmodes_real t26 = D_p_x_2*theta_2_dot;
    const pkmodes_real t27 = D_p_x_3*theta_3_dot;
    const pkmodes_real s_dot_1_x = U_1_x_1*theta_1_dot + t26 + t27;
    const pkmodes_real t28 = D_p_y_2*theta_2_dot;
    const pkmodes_real t29 = D_p_y_3*theta_3_dot;
    const pkmodes_real s_dot_1_y = U_1_y_1*theta_1_dot + t28 + t29;
    const pkmodes_real t30 = D_p_z_2*theta_2_dot;
    const pkmodes_real t31 = D_p_z_3*theta_3_dot;
    const pkmodes_real s_dot_1_z = U_1_z_1*theta_1_dot + t30 + t31;
    const pkmodes_real t32 = D_p_x_1*theta_1_dot;
    const pkmodes_real s_dot_2_x = U_2_x_2*theta_2_dot + t27 + t32;
    const pkmodes_real t33 = D_p_y_1*theta_1_dot;
    const pkmodes_real s_dot_2_y = U_2_y_2*theta_2_dot + t29 + t33;
    const pkmodes_real t34 = D_p_z_1*theta_1_dot;
    const pkmodes_real s_dot_2_z = U_2_z_2*theta_2_dot + t31 + t34;
    const pkmodes_real s_dot_3_x = U_3_x_3*theta_3_dot + t26 + t32;
    const pkmodes_real s_dot_3_y = U_3_y_3*theta_3_dot + t28 + t33;
    const pkmodes_real s_dot_3_z = U_3_z_3*theta_3_dot + t30 + t34;
    const pkmodes_real t35 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t36 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t37 =
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + s_dot_1_x*t13 + s_dot_1_y*t14
        + s_dot_1_z*t15 + theta_1_dot*(-s_1_x*t4 - s_1_y*t5 - s_1_z*t6);
    const pkmodes_real D_p_dot_x_1 = t22*(A_x_1*t37 + A_x_2*t35 + A_x_3*t36);
    const pkmodes_real D_p_dot_y_1 = t22*(A_y_1*t37 + A_y_2*t35 + A_y_3*t36);
    const pkmodes_real D_p_dot_z_1 = t22*(A_z_1*t37 + A_z_2*t35 + A_z_3*t36);
    const pkmodes_real t38 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t39 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t40 =
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + s_dot_2_x*t16 + s_dot_2_y*t17
        + s_dot_2_z*t18 + theta_2_dot*(-s_2_x*t7 - s_2_y*t8 - s_2_z*t9);
    const pkmodes_real D_p_dot_x_2 = t22*(A_x_1*t38 + A_x_2*t40 + A_x_3*t39);
    const pkmodes_real D_p_dot_y_2 = t22*(A_y_1*t38 + A_y_2*t40 + A_y_3*t39);
    const pkmodes_real D_p_dot_z_2 = t22*(A_z_1*t38 + A_z_2*t40 + A_z_3*t39);
    const pkmodes_real t41 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t42 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t43 =
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + s_dot_3_x*t19 + s_dot_3_y*t20
        + s_dot_3_z*t21 + theta_3_dot*(-s_3_x*t10 - s_3_y*t11 - s_3_z*t12);
    const pkmodes_real D_p_dot_x_3 = t22*(A_x_1*t41 + A_x_2*t42 + A_x_3*t43);
    const pkmodes_real D_p_dot_y_3 = t22*(A_y_1*t41 + A_y_2*t42 + A_y_3*t43);
    const pkmodes_real D_p_dot_z_3 = t22*(A_z_1*t41 + A_z_2*t42 + A_z_3*t43);
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

void rotary_delta_platform_second_derivatives(const pkmodes_real p[3],
    const rotary_delta_parameters *parameters, pkmodes_real P[3][3][3])
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
    const pkmodes_real t4 = L_a_1*d_1_x;
    const pkmodes_real s_1_x = r_1_x - t4;
    const pkmodes_real t5 = L_a_1*d_1_y;
    const pkmodes_real s_1_y = r_1_y - t5;
    const pkmodes_real t6 = L_a_1*d_1_z;
    const pkmodes_real s_1_z = r_1_z - t6;
    const pkmodes_real t7 = L_a_2*d_2_x;
    const pkmodes_real s_2_x = r_2_x - t7;
    const pkmodes_real t8 = L_a_2*d_2_y;
    const pkmodes_real s_2_y = r_2_y - t8;
    const pkmodes_real t9 = L_a_2*d_2_z;
    const pkmodes_real s_2_z = r_2_z - t9;
    const pkmodes_real t10 = L_a_3*d_3_x;
    const pkmodes_real s_3_x = r_3_x - t10;
    const pkmodes_real t11 = L_a_3*d_3_y;
    const pkmodes_real s_3_y = r_3_y - t11;
    const pkmodes_real t12 = L_a_3*d_3_z;
    const pkmodes_real s_3_z = r_3_z - t12;
    const pkmodes_real t13 = L_a_1*t_1_x;
    const pkmodes_real t14 = L_a_1*t_1_y;
    const pkmodes_real t15 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15;
    const pkmodes_real t16 = L_a_2*t_2_x;
    const pkmodes_real t17 = L_a_2*t_2_y;
    const pkmodes_real t18 = L_a_2*t_2_z;
    const pkmodes_real D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18;
    const pkmodes_real t19 = L_a_3*t_3_x;
    const pkmodes_real t20 = L_a_3*t_3_y;
    const pkmodes_real t21 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21;
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
    const pkmodes_real t22 = 1/det_D_l;
    const pkmodes_real t23 = D_r_1*t22;
    const pkmodes_real D_p_x_1 = A_x_1*t23;
    const pkmodes_real t24 = D_r_2*t22;
    const pkmodes_real D_p_x_2 = A_x_2*t24;
    const pkmodes_real t25 = D_r_3*t22;
    const pkmodes_real D_p_x_3 = A_x_3*t25;
    const pkmodes_real D_p_y_1 = A_y_1*t23;
    const pkmodes_real D_p_y_2 = A_y_2*t24;
    const pkmodes_real D_p_y_3 = A_y_3*t25;
    const pkmodes_real D_p_z_1 = A_z_1*t23;
    const pkmodes_real D_p_z_2 = A_z_2*t24;
    const pkmodes_real D_p_z_3 = A_z_3*t25;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t13;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t14;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t15;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t16;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t17;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t18;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t19;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t20;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t21;
    const pkmodes_real f_1_11 =
        -(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1) - s_1_x*t4 - s_1_y*t5 - s_1_z*t6;
    const pkmodes_real f_2_11 = -(D_p_x_1*D_p_x_1) - (D_p_y_1*D_p_y_1) - (D_p_z_1*D_p_z_1);
    const pkmodes_real P_x_11 = t22*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11);
    const pkmodes_real P_y_11 = t22*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11);
    const pkmodes_real P_z_11 = t22*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11);
    const pkmodes_real f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1;
    const pkmodes_real f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2;
    const pkmodes_real f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2;
    const pkmodes_real P_x_12 = t22*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12);
    const pkmodes_real P_y_12 = t22*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12);
    const pkmodes_real P_z_12 = t22*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12);
    const pkmodes_real f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1;
    const pkmodes_real f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3;
    const pkmodes_real f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3;
    const pkmodes_real P_x_13 = t22*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13);
    const pkmodes_real P_y_13 = t22*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13);
    const pkmodes_real P_z_13 = t22*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13);
    const pkmodes_real f_1_22 = -(D_p_x_2*D_p_x_2) - (D_p_y_2*D_p_y_2) - (D_p_z_2*D_p_z_2);
    const pkmodes_real f_2_22 =
        -(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2) - s_2_x*t7 - s_2_y*t8 - s_2_z*t9;
    const pkmodes_real P_x_22 = t22*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22);
    const pkmodes_real P_y_22 = t22*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22);
    const pkmodes_real P_z_22 = t22*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22);
    const pkmodes_real f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3;
    const pkmodes_real f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2;
    const pkmodes_real f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3;
    const pkmodes_real P_x_23 = t22*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23);
    const pkmodes_real P_y_23 = t22*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23);
    const pkmodes_real P_z_23 = t22*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23);
    const pkmodes_real f_1_33 = -(D_p_x_3*D_p_x_3) - (D_p_y_3*D_p_y_3) - (D_p_z_3*D_p_z_3);
    const pkmodes_real f_3_33 =
        -(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3) - s_3_x*t10 - s_3_y*t11 - s_3_z*t12;
    const pkmodes_real P_x_33 = t22*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33);
    const pkmodes_real P_y_33 = t22*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33);
    const pkmodes_real P_z_33 = t22*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33);
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

void rotary_delta_link_jacobians(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
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
    const pkmodes_real t1 = (l_d_1*l_d_1);
    const pkmodes_real C_1 =
        (R(1.0)/R(2.0))*((L_a_1*L_a_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z) - t1)/L_a_1;
    const pkmodes_real S_1 = sigma_1*R(sqrt)(-(C_1*C_1) + rho2_1);
    const pkmodes_real t2 = 1/rho2_1;
    const pkmodes_real c_1 = t2*(A_1*C_1 - B_1*S_1);
    const pkmodes_real sn_1 = t2*(A_1*S_1 + B_1*C_1);
    const pkmodes_real A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const pkmodes_real B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const pkmodes_real rho2_2 = (A_2*A_2) + (B_2*B_2);
    const pkmodes_real t3 = (l_d_2*l_d_2);
    const pkmodes_real C_2 =
        (R(1.0)/R(2.0))*((L_a_2*L_a_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z) - t3)/L_a_2;
    const pkmodes_real S_2 = sigma_2*R(sqrt)(-(C_2*C_2) + rho2_2);
    const pkmodes_real t4 = 1/rho2_2;
    const pkmodes_real c_2 = t4*(A_2*C_2 - B_2*S_2);
    const pkmodes_real sn_2 = t4*(A_2*S_2 + B_2*C_2);
    const pkmodes_real A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const pkmodes_real B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const pkmodes_real rho2_3 = (A_3*A_3) + (B_3*B_3);
    const pkmodes_real t5 = (l_d_3*l_d_3);
    const pkmodes_real C_3 =
        (R(1.0)/R(2.0))*((L_a_3*L_a_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z) - t5)/L_a_3;
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
    const pkmodes_real s_1_x = -L_a_1*d_1_x + r_1_x;
    const pkmodes_real s_1_y = -L_a_1*d_1_y + r_1_y;
    const pkmodes_real s_1_z = -L_a_1*d_1_z + r_1_z;
    const pkmodes_real s_2_x = -L_a_2*d_2_x + r_2_x;
    const pkmodes_real s_2_y = -L_a_2*d_2_y + r_2_y;
    const pkmodes_real s_2_z = -L_a_2*d_2_z + r_2_z;
    const pkmodes_real s_3_x = -L_a_3*d_3_x + r_3_x;
    const pkmodes_real s_3_y = -L_a_3*d_3_y + r_3_y;
    const pkmodes_real s_3_z = -L_a_3*d_3_z + r_3_z;
    const pkmodes_real t7 = L_a_1*t_1_x;
    const pkmodes_real t8 = L_a_1*t_1_y;
    const pkmodes_real t9 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t7 + s_1_y*t8 + s_1_z*t9;
    const pkmodes_real t10 = L_a_2*t_2_y;
    const pkmodes_real t11 = L_a_2*t_2_z;
    const pkmodes_real t12 = L_a_2*t_2_x;
    const pkmodes_real D_r_2 = s_2_x*t12 + s_2_y*t10 + s_2_z*t11;
    const pkmodes_real t13 = L_a_3*t_3_x;
    const pkmodes_real t14 = L_a_3*t_3_y;
    const pkmodes_real t15 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t13 + s_3_y*t14 + s_3_z*t15;
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
    const pkmodes_real t16 = 1/det_D_l;
    const pkmodes_real t17 = D_r_1*t16;
    const pkmodes_real D_p_x_1 = A_x_1*t17;
    const pkmodes_real t18 = D_r_2*t16;
    const pkmodes_real D_p_x_2 = A_x_2*t18;
    const pkmodes_real t19 = D_r_3*t16;
    const pkmodes_real D_p_x_3 = A_x_3*t19;
    const pkmodes_real D_p_y_1 = A_y_1*t17;
    const pkmodes_real D_p_y_2 = A_y_2*t18;
    const pkmodes_real D_p_y_3 = A_y_3*t19;
    const pkmodes_real D_p_z_1 = A_z_1*t17;
    const pkmodes_real D_p_z_2 = A_z_2*t18;
    const pkmodes_real D_p_z_3 = A_z_3*t19;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t7;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t8;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t9;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t12;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t10;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t11;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t13;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t14;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t15;
    const pkmodes_real t20 = (R(1.0)/R(2.0))*D_p_x_1;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*D_p_x_2;
    const pkmodes_real t22 = (R(1.0)/R(2.0))*D_p_x_3;
    const pkmodes_real t23 = (R(1.0)/R(2.0))*D_p_y_1;
    const pkmodes_real t24 = (R(1.0)/R(2.0))*D_p_y_2;
    const pkmodes_real t25 = (R(1.0)/R(2.0))*D_p_y_3;
    const pkmodes_real t26 = (R(1.0)/R(2.0))*D_p_z_1;
    const pkmodes_real t27 = (R(1.0)/R(2.0))*D_p_z_2;
    const pkmodes_real t28 = (R(1.0)/R(2.0))*D_p_z_3;
    const pkmodes_real t29 = 1/t1;
    const pkmodes_real t30 = 1/t3;
    const pkmodes_real t31 = 1/t5;
    D_d[0][0][0] = t20 + (R(1.0)/R(2.0))*t7;
    D_d[0][0][1] = t21;
    D_d[0][0][2] = t22;
    D_d[0][1][0] = t23 + (R(1.0)/R(2.0))*t8;
    D_d[0][1][1] = t24;
    D_d[0][1][2] = t25;
    D_d[0][2][0] = t26 + (R(1.0)/R(2.0))*t9;
    D_d[0][2][1] = t27;
    D_d[0][2][2] = t28;
    D_d[1][0][0] = t20;
    D_d[1][0][1] = (R(1.0)/R(2.0))*t12 + t21;
    D_d[1][0][2] = t22;
    D_d[1][1][0] = t23;
    D_d[1][1][1] = (R(1.0)/R(2.0))*t10 + t24;
    D_d[1][1][2] = t25;
    D_d[1][2][0] = t26;
    D_d[1][2][1] = (R(1.0)/R(2.0))*t11 + t27;
    D_d[1][2][2] = t28;
    D_d[2][0][0] = t20;
    D_d[2][0][1] = t21;
    D_d[2][0][2] = (R(1.0)/R(2.0))*t13 + t22;
    D_d[2][1][0] = t23;
    D_d[2][1][1] = t24;
    D_d[2][1][2] = (R(1.0)/R(2.0))*t14 + t25;
    D_d[2][2][0] = t26;
    D_d[2][2][1] = t27;
    D_d[2][2][2] = (R(1.0)/R(2.0))*t15 + t28;
    D_omega[0][0][0] = t29*(-U_1_y_1*s_1_z + U_1_z_1*s_1_y);
    D_omega[0][0][1] = t29*(-D_p_y_2*s_1_z + D_p_z_2*s_1_y);
    D_omega[0][0][2] = t29*(-D_p_y_3*s_1_z + D_p_z_3*s_1_y);
    D_omega[0][1][0] = t29*(U_1_x_1*s_1_z - U_1_z_1*s_1_x);
    D_omega[0][1][1] = t29*(D_p_x_2*s_1_z - D_p_z_2*s_1_x);
    D_omega[0][1][2] = t29*(D_p_x_3*s_1_z - D_p_z_3*s_1_x);
    D_omega[0][2][0] = t29*(-U_1_x_1*s_1_y + U_1_y_1*s_1_x);
    D_omega[0][2][1] = t29*(-D_p_x_2*s_1_y + D_p_y_2*s_1_x);
    D_omega[0][2][2] = t29*(-D_p_x_3*s_1_y + D_p_y_3*s_1_x);
    D_omega[1][0][0] = t30*(-D_p_y_1*s_2_z + D_p_z_1*s_2_y);
    D_omega[1][0][1] = t30*(-U_2_y_2*s_2_z + U_2_z_2*s_2_y);
    D_omega[1][0][2] = t30*(-D_p_y_3*s_2_z + D_p_z_3*s_2_y);
    D_omega[1][1][0] = t30*(D_p_x_1*s_2_z - D_p_z_1*s_2_x);
    D_omega[1][1][1] = t30*(U_2_x_2*s_2_z - U_2_z_2*s_2_x);
    D_omega[1][1][2] = t30*(D_p_x_3*s_2_z - D_p_z_3*s_2_x);
    D_omega[1][2][0] = t30*(-D_p_x_1*s_2_y + D_p_y_1*s_2_x);
    D_omega[1][2][1] = t30*(-U_2_x_2*s_2_y + U_2_y_2*s_2_x);
    D_omega[1][2][2] = t30*(-D_p_x_3*s_2_y + D_p_y_3*s_2_x);
    D_omega[2][0][0] = t31*(-D_p_y_1*s_3_z + D_p_z_1*s_3_y);
    D_omega[2][0][1] = t31*(-D_p_y_2*s_3_z + D_p_z_2*s_3_y);
    D_omega[2][0][2] = t31*(-U_3_y_3*s_3_z + U_3_z_3*s_3_y);
    D_omega[2][1][0] = t31*(D_p_x_1*s_3_z - D_p_z_1*s_3_x);
    D_omega[2][1][1] = t31*(D_p_x_2*s_3_z - D_p_z_2*s_3_x);
    D_omega[2][1][2] = t31*(U_3_x_3*s_3_z - U_3_z_3*s_3_x);
    D_omega[2][2][0] = t31*(-D_p_x_1*s_3_y + D_p_y_1*s_3_x);
    D_omega[2][2][1] = t31*(-D_p_x_2*s_3_y + D_p_y_2*s_3_x);
    D_omega[2][2][2] = t31*(-U_3_x_3*s_3_y + U_3_y_3*s_3_x);
}

void rotary_delta_kinetic_energy(const pkmodes_real p[3], const pkmodes_real q_dot[6],
    const rotary_delta_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t)
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real theta_1_dot = q_dot[0];
    const pkmodes_real theta_2_dot = q_dot[1];
    const pkmodes_real theta_3_dot = q_dot[2];
    const pkmodes_real phi_1_dot = q_dot[3];
    const pkmodes_real phi_2_dot = q_dot[4];
    const pkmodes_real phi_3_dot = q_dot[5];
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
    const pkmodes_real I_a_1 = parameters->arm_inertia[0];
    const pkmodes_real I_a_2 = parameters->arm_inertia[1];
    const pkmodes_real I_a_3 = parameters->arm_inertia[2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real I_m_3 = parameters->motor_inertia[2];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real i_g_3 = parameters->gear_ratio[2];
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
    const pkmodes_real s_1_x = -L_a_1*d_1_x + r_1_x;
    const pkmodes_real s_1_y = -L_a_1*d_1_y + r_1_y;
    const pkmodes_real s_1_z = -L_a_1*d_1_z + r_1_z;
    const pkmodes_real s_2_x = -L_a_2*d_2_x + r_2_x;
    const pkmodes_real s_2_y = -L_a_2*d_2_y + r_2_y;
    const pkmodes_real s_2_z = -L_a_2*d_2_z + r_2_z;
    const pkmodes_real s_3_x = -L_a_3*d_3_x + r_3_x;
    const pkmodes_real s_3_y = -L_a_3*d_3_y + r_3_y;
    const pkmodes_real s_3_z = -L_a_3*d_3_z + r_3_z;
    const pkmodes_real t7 = L_a_1*t_1_x;
    const pkmodes_real t8 = L_a_1*t_1_y;
    const pkmodes_real t9 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t7 + s_1_y*t8 + s_1_z*t9;
    const pkmodes_real t10 = L_a_2*t_2_y;
    const pkmodes_real t11 = L_a_2*t_2_z;
    const pkmodes_real t12 = L_a_2*t_2_x;
    const pkmodes_real D_r_2 = s_2_x*t12 + s_2_y*t10 + s_2_z*t11;
    const pkmodes_real t13 = L_a_3*t_3_x;
    const pkmodes_real t14 = L_a_3*t_3_y;
    const pkmodes_real t15 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t13 + s_3_y*t14 + s_3_z*t15;
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
    const pkmodes_real t16 = 1/det_D_l;
    const pkmodes_real t17 = D_r_1*t16;
    const pkmodes_real D_p_x_1 = A_x_1*t17;
    const pkmodes_real t18 = D_r_2*t16;
    const pkmodes_real D_p_x_2 = A_x_2*t18;
    const pkmodes_real t19 = D_r_3*t16;
    const pkmodes_real D_p_x_3 = A_x_3*t19;
    const pkmodes_real D_p_y_1 = A_y_1*t17;
    const pkmodes_real D_p_y_2 = A_y_2*t18;
    const pkmodes_real D_p_y_3 = A_y_3*t19;
    const pkmodes_real D_p_z_1 = A_z_1*t17;
    const pkmodes_real D_p_z_2 = A_z_2*t18;
    const pkmodes_real D_p_z_3 = A_z_3*t19;
    const pkmodes_real I_1 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_2 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_3 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real v_p_x = D_p_x_1*theta_1_dot + D_p_x_2*theta_2_dot + D_p_x_3*theta_3_dot;
    const pkmodes_real v_p_y = D_p_y_1*theta_1_dot + D_p_y_2*theta_2_dot + D_p_y_3*theta_3_dot;
    const pkmodes_real v_p_z = D_p_z_1*theta_1_dot + D_p_z_2*theta_2_dot + D_p_z_3*theta_3_dot;
    const pkmodes_real t20 = (theta_1_dot*theta_1_dot);
    const pkmodes_real t21 = (theta_2_dot*theta_2_dot);
    const pkmodes_real t22 = (theta_3_dot*theta_3_dot);
    const pkmodes_real t23 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t24 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t25 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t26 = (R(1.0)/R(2.0))*m_p + t23 + t24 + t25;
    const pkmodes_real t27 = t23*theta_1_dot;
    const pkmodes_real t28 = t24*theta_2_dot;
    const pkmodes_real t29 = t25*theta_3_dot;
    *T_ss =
        (R(1.0)/R(2.0))*I_a_1*t20 + (R(1.0)/R(2.0))*I_a_2*t21 + (R(1.0)/R(2.0))*I_a_3*t22 + t1*t20*t23
        + t21*t24*t3 + t22*t25*t5 + t26*(v_p_x*v_p_x) + t26*(v_p_y*v_p_y) + t26*(v_p_z*v_p_z)
        + v_p_x*(t12*t28 + t13*t29 + t27*t7) + v_p_y*(t10*t28 + t14*t29 + t27*t8) + v_p_z*(t11*t28 + t15*t29
        + t27*t9);
    *T_t =
        (R(1.0)/R(2.0))*I_1*(phi_1_dot*phi_1_dot) + (R(1.0)/R(2.0))*I_2*(phi_2_dot*phi_2_dot)
        + (R(1.0)/R(2.0))*I_3*(phi_3_dot*phi_3_dot);
}

void rotary_delta_mass_matrix(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real M[6][6])
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
    const pkmodes_real I_a_1 = parameters->arm_inertia[0];
    const pkmodes_real I_a_2 = parameters->arm_inertia[1];
    const pkmodes_real I_a_3 = parameters->arm_inertia[2];
    const pkmodes_real l_d_1 = parameters->link_length[0];
    const pkmodes_real l_d_2 = parameters->link_length[1];
    const pkmodes_real l_d_3 = parameters->link_length[2];
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
    const pkmodes_real I_m_1 = parameters->motor_inertia[0];
    const pkmodes_real I_m_2 = parameters->motor_inertia[1];
    const pkmodes_real I_m_3 = parameters->motor_inertia[2];
    const pkmodes_real i_g_1 = parameters->gear_ratio[0];
    const pkmodes_real i_g_2 = parameters->gear_ratio[1];
    const pkmodes_real i_g_3 = parameters->gear_ratio[2];
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
    const pkmodes_real s_1_x = -L_a_1*d_1_x + r_1_x;
    const pkmodes_real s_1_y = -L_a_1*d_1_y + r_1_y;
    const pkmodes_real s_1_z = -L_a_1*d_1_z + r_1_z;
    const pkmodes_real s_2_x = -L_a_2*d_2_x + r_2_x;
    const pkmodes_real s_2_y = -L_a_2*d_2_y + r_2_y;
    const pkmodes_real s_2_z = -L_a_2*d_2_z + r_2_z;
    const pkmodes_real s_3_x = -L_a_3*d_3_x + r_3_x;
    const pkmodes_real s_3_y = -L_a_3*d_3_y + r_3_y;
    const pkmodes_real s_3_z = -L_a_3*d_3_z + r_3_z;
    const pkmodes_real t7 = L_a_1*t_1_x;
    const pkmodes_real t8 = L_a_1*t_1_y;
    const pkmodes_real t9 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t7 + s_1_y*t8 + s_1_z*t9;
    const pkmodes_real t10 = L_a_2*t_2_y;
    const pkmodes_real t11 = L_a_2*t_2_z;
    const pkmodes_real t12 = L_a_2*t_2_x;
    const pkmodes_real D_r_2 = s_2_x*t12 + s_2_y*t10 + s_2_z*t11;
    const pkmodes_real t13 = L_a_3*t_3_x;
    const pkmodes_real t14 = L_a_3*t_3_y;
    const pkmodes_real t15 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t13 + s_3_y*t14 + s_3_z*t15;
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
    const pkmodes_real t16 = 1/det_D_l;
    const pkmodes_real t17 = D_r_1*t16;
    const pkmodes_real D_p_x_1 = A_x_1*t17;
    const pkmodes_real t18 = D_r_2*t16;
    const pkmodes_real D_p_x_2 = A_x_2*t18;
    const pkmodes_real t19 = D_r_3*t16;
    const pkmodes_real D_p_x_3 = A_x_3*t19;
    const pkmodes_real D_p_y_1 = A_y_1*t17;
    const pkmodes_real D_p_y_2 = A_y_2*t18;
    const pkmodes_real D_p_y_3 = A_y_3*t19;
    const pkmodes_real D_p_z_1 = A_z_1*t17;
    const pkmodes_real D_p_z_2 = A_z_2*t18;
    const pkmodes_real D_p_z_3 = A_z_3*t19;
    const pkmodes_real I_1 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_2 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_3 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real t20 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t21 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t22 = t21*t7;
    const pkmodes_real t23 = t21*t8;
    const pkmodes_real t24 = t21*t9;
    const pkmodes_real t25 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t26 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t27 = m_p + t20 + t25 + t26;
    const pkmodes_real t28 = D_p_x_1*t27 + t22;
    const pkmodes_real t29 = D_p_y_1*t27 + t23;
    const pkmodes_real t30 = D_p_z_1*t27 + t24;
    const pkmodes_real t31 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t32 = t12*t31;
    const pkmodes_real t33 = t10*t31;
    const pkmodes_real t34 = t11*t31;
    const pkmodes_real t35 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t36 = t13*t35;
    const pkmodes_real t37 = t14*t35;
    const pkmodes_real t38 = t15*t35;
    const pkmodes_real t39 = D_p_x_2*t27 + t32;
    const pkmodes_real t40 = D_p_y_2*t27 + t33;
    const pkmodes_real t41 = D_p_z_2*t27 + t34;
    memset(M, 0, sizeof(pkmodes_real[6][6]));
    M[0][0] =
        D_p_x_1*t22 + D_p_x_1*t28 + D_p_y_1*t23 + D_p_y_1*t29 + D_p_z_1*t24 + D_p_z_1*t30 + I_a_1 + t1*t20;
    M[0][1] = M[1][0] = D_p_x_1*t32 + D_p_x_2*t28 + D_p_y_1*t33 + D_p_y_2*t29 + D_p_z_1*t34 + D_p_z_2*t30;
    M[0][2] = M[2][0] = D_p_x_1*t36 + D_p_x_3*t28 + D_p_y_1*t37 + D_p_y_3*t29 + D_p_z_1*t38 + D_p_z_3*t30;
    M[1][1] =
        D_p_x_2*t32 + D_p_x_2*t39 + D_p_y_2*t33 + D_p_y_2*t40 + D_p_z_2*t34 + D_p_z_2*t41 + I_a_2 + t25*t3;
    M[1][2] = M[2][1] = D_p_x_2*t36 + D_p_x_3*t39 + D_p_y_2*t37 + D_p_y_3*t40 + D_p_z_2*t38 + D_p_z_3*t41;
    M[2][2] =
        D_p_x_3*t36 + D_p_x_3*(D_p_x_3*t27 + t36) + D_p_y_3*t37 + D_p_y_3*(D_p_y_3*t27 + t37) + D_p_z_3*t38
        + D_p_z_3*(D_p_z_3*t27 + t38) + I_a_3 + t26*t5;
    M[3][3] = I_1;
    M[4][4] = I_2;
    M[5][5] = I_3;
}

void rotary_delta_velocity_forces(const pkmodes_real p[3], const pkmodes_real theta_dot[3],
    const rotary_delta_parameters *parameters, pkmodes_real h[3])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real theta_1_dot = theta_dot[0];
    const pkmodes_real theta_2_dot = theta_dot[1];
    const pkmodes_real theta_3_dot = theta_dot[2];
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
    const pkmodes_real m_d_1 = parameters->link_mass[0];
    const pkmodes_real m_d_2 = parameters->link_mass[1];
    const pkmodes_real m_d_3 = parameters->link_mass[2];
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
    const pkmodes_real t4 = L_a_1*d_1_x;
    const pkmodes_real s_1_x = r_1_x - t4;
    const pkmodes_real t5 = L_a_1*d_1_y;
    const pkmodes_real s_1_y = r_1_y - t5;
    const pkmodes_real t6 = L_a_1*d_1_z;
    const pkmodes_real s_1_z = r_1_z - t6;
    const pkmodes_real t7 = L_a_2*d_2_x;
    const pkmodes_real s_2_x = r_2_x - t7;
    const pkmodes_real t8 = L_a_2*d_2_y;
    const pkmodes_real s_2_y = r_2_y - t8;
    const pkmodes_real t9 = L_a_2*d_2_z;
    const pkmodes_real s_2_z = r_2_z - t9;
    const pkmodes_real t10 = L_a_3*d_3_x;
    const pkmodes_real s_3_x = r_3_x - t10;
    const pkmodes_real t11 = L_a_3*d_3_y;
    const pkmodes_real s_3_y = r_3_y - t11;
    const pkmodes_real t12 = L_a_3*d_3_z;
    const pkmodes_real s_3_z = r_3_z - t12;
    const pkmodes_real t13 = L_a_1*t_1_x;
    const pkmodes_real t14 = L_a_1*t_1_y;
    const pkmodes_real t15 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15;
    const pkmodes_real t16 = L_a_2*t_2_x;
    const pkmodes_real t17 = L_a_2*t_2_y;
    const pkmodes_real t18 = L_a_2*t_2_z;
    const pkmodes_real D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18;
    const pkmodes_real t19 = L_a_3*t_3_x;
    const pkmodes_real t20 = L_a_3*t_3_y;
    const pkmodes_real t21 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21;
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
    const pkmodes_real t22 = 1/det_D_l;
    const pkmodes_real t23 = D_r_1*t22;
    const pkmodes_real D_p_x_1 = A_x_1*t23;
    const pkmodes_real t24 = D_r_2*t22;
    const pkmodes_real D_p_x_2 = A_x_2*t24;
    const pkmodes_real t25 = D_r_3*t22;
    const pkmodes_real D_p_x_3 = A_x_3*t25;
    const pkmodes_real D_p_y_1 = A_y_1*t23;
    const pkmodes_real D_p_y_2 = A_y_2*t24;
    const pkmodes_real D_p_y_3 = A_y_3*t25;
    const pkmodes_real D_p_z_1 = A_z_1*t23;
    const pkmodes_real D_p_z_2 = A_z_2*t24;
    const pkmodes_real D_p_z_3 = A_z_3*t25;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t13;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t14;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t15;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t16;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t17;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t18;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t19;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t20;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t21;
    const pkmodes_real t26 = s_1_x*t4 + s_1_y*t5 + s_1_z*t6;
    const pkmodes_real f_1_11 = -(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1) - t26;
    const pkmodes_real f_2_11 = -(D_p_x_1*D_p_x_1) - (D_p_y_1*D_p_y_1) - (D_p_z_1*D_p_z_1);
    const pkmodes_real P_x_11 = t22*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_2_11);
    const pkmodes_real P_y_11 = t22*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_2_11);
    const pkmodes_real P_z_11 = t22*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_2_11);
    const pkmodes_real f_1_12 = -D_p_x_2*U_1_x_1 - D_p_y_2*U_1_y_1 - D_p_z_2*U_1_z_1;
    const pkmodes_real f_2_12 = -D_p_x_1*U_2_x_2 - D_p_y_1*U_2_y_2 - D_p_z_1*U_2_z_2;
    const pkmodes_real f_3_12 = -D_p_x_1*D_p_x_2 - D_p_y_1*D_p_y_2 - D_p_z_1*D_p_z_2;
    const pkmodes_real P_x_12 = t22*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12);
    const pkmodes_real P_y_12 = t22*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12);
    const pkmodes_real P_z_12 = t22*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12);
    const pkmodes_real f_1_13 = -D_p_x_3*U_1_x_1 - D_p_y_3*U_1_y_1 - D_p_z_3*U_1_z_1;
    const pkmodes_real f_2_13 = -D_p_x_1*D_p_x_3 - D_p_y_1*D_p_y_3 - D_p_z_1*D_p_z_3;
    const pkmodes_real f_3_13 = -D_p_x_1*U_3_x_3 - D_p_y_1*U_3_y_3 - D_p_z_1*U_3_z_3;
    const pkmodes_real P_x_13 = t22*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13);
    const pkmodes_real P_y_13 = t22*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13);
    const pkmodes_real P_z_13 = t22*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13);
    const pkmodes_real f_1_22 = -(D_p_x_2*D_p_x_2) - (D_p_y_2*D_p_y_2) - (D_p_z_2*D_p_z_2);
    const pkmodes_real t27 = s_2_x*t7 + s_2_y*t8 + s_2_z*t9;
    const pkmodes_real f_2_22 = -(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2) - t27;
    const pkmodes_real P_x_22 = t22*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_1_22);
    const pkmodes_real P_y_22 = t22*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_1_22);
    const pkmodes_real P_z_22 = t22*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_1_22);
    const pkmodes_real f_1_23 = -D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3;
    const pkmodes_real f_2_23 = -D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2;
    const pkmodes_real f_3_23 = -D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3;
    const pkmodes_real P_x_23 = t22*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23);
    const pkmodes_real P_y_23 = t22*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23);
    const pkmodes_real P_z_23 = t22*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23);
    const pkmodes_real f_1_33 = -(D_p_x_3*D_p_x_3) - (D_p_y_3*D_p_y_3) - (D_p_z_3*D_p_z_3);
    const pkmodes_real t28 = s_3_x*t10 + s_3_y*t11 + s_3_z*t12;
    const pkmodes_real f_3_33 = -(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3) - t28;
    const pkmodes_real P_x_33 = t22*(A_x_1*f_1_33 + A_x_2*f_1_33 + A_x_3*f_3_33);
    const pkmodes_real P_y_33 = t22*(A_y_1*f_1_33 + A_y_2*f_1_33 + A_y_3*f_3_33);
    const pkmodes_real P_z_33 = t22*(A_z_1*f_1_33 + A_z_2*f_1_33 + A_z_3*f_3_33);
    const pkmodes_real t29 = D_p_x_1*theta_1_dot;
    const pkmodes_real t30 = D_p_x_2*theta_2_dot;
    const pkmodes_real t31 = D_p_x_3*theta_3_dot;
    const pkmodes_real t32 = t30 + t31;
    const pkmodes_real v_p_x = t29 + t32;
    const pkmodes_real t33 = D_p_y_1*theta_1_dot;
    const pkmodes_real t34 = D_p_y_2*theta_2_dot;
    const pkmodes_real t35 = D_p_y_3*theta_3_dot;
    const pkmodes_real t36 = t34 + t35;
    const pkmodes_real v_p_y = t33 + t36;
    const pkmodes_real t37 = D_p_z_1*theta_1_dot;
    const pkmodes_real t38 = D_p_z_2*theta_2_dot;
    const pkmodes_real t39 = D_p_z_3*theta_3_dot;
    const pkmodes_real t40 = t38 + t39;
    const pkmodes_real v_p_z = t37 + t40;
    const pkmodes_real s_dot_1_x = U_1_x_1*theta_1_dot + t32;
    const pkmodes_real s_dot_1_y = U_1_y_1*theta_1_dot + t36;
    const pkmodes_real s_dot_1_z = U_1_z_1*theta_1_dot + t40;
    const pkmodes_real s_dot_2_x = U_2_x_2*theta_2_dot + t29 + t31;
    const pkmodes_real s_dot_2_y = U_2_y_2*theta_2_dot + t33 + t35;
    const pkmodes_real s_dot_2_z = U_2_z_2*theta_2_dot + t37 + t39;
    const pkmodes_real s_dot_3_x = U_3_x_3*theta_3_dot + t29 + t30;
    const pkmodes_real s_dot_3_y = U_3_y_3*theta_3_dot + t33 + t34;
    const pkmodes_real s_dot_3_z = U_3_z_3*theta_3_dot + t37 + t38;
    const pkmodes_real t41 = -D_p_x_1*s_dot_2_x - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t42 = -D_p_x_1*s_dot_3_x - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t43 =
        -D_p_x_1*s_dot_1_x - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + s_dot_1_x*t13 + s_dot_1_y*t14
        + s_dot_1_z*t15 - t26*theta_1_dot;
    const pkmodes_real D_p_dot_x_1 = t22*(A_x_1*t43 + A_x_2*t41 + A_x_3*t42);
    const pkmodes_real D_p_dot_y_1 = t22*(A_y_1*t43 + A_y_2*t41 + A_y_3*t42);
    const pkmodes_real D_p_dot_z_1 = t22*(A_z_1*t43 + A_z_2*t41 + A_z_3*t42);
    const pkmodes_real t44 = -D_p_x_2*s_dot_1_x - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t45 = -D_p_x_2*s_dot_3_x - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t46 =
        -D_p_x_2*s_dot_2_x - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + s_dot_2_x*t16 + s_dot_2_y*t17
        + s_dot_2_z*t18 - t27*theta_2_dot;
    const pkmodes_real D_p_dot_x_2 = t22*(A_x_1*t44 + A_x_2*t46 + A_x_3*t45);
    const pkmodes_real D_p_dot_y_2 = t22*(A_y_1*t44 + A_y_2*t46 + A_y_3*t45);
    const pkmodes_real D_p_dot_z_2 = t22*(A_z_1*t44 + A_z_2*t46 + A_z_3*t45);
    const pkmodes_real t47 = -D_p_x_3*s_dot_1_x - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t48 = -D_p_x_3*s_dot_2_x - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t49 =
        -D_p_x_3*s_dot_3_x - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + s_dot_3_x*t19 + s_dot_3_y*t20
        + s_dot_3_z*t21 - t28*theta_3_dot;
    const pkmodes_real D_p_dot_x_3 = t22*(A_x_1*t47 + A_x_2*t48 + A_x_3*t49);
    const pkmodes_real D_p_dot_y_3 = t22*(A_y_1*t47 + A_y_2*t48 + A_y_3*t49);
    const pkmodes_real D_p_dot_z_3 = t22*(A_z_1*t47 + A_z_2*t48 + A_z_3*t49);
    const pkmodes_real t50 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t51 = t50*theta_1_dot;
    const pkmodes_real t52 = t4*t51;
    const pkmodes_real t53 = t5*t51;
    const pkmodes_real t54 = t51*t6;
    const pkmodes_real t55 = t13*t50;
    const pkmodes_real t56 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t57 = t16*t56;
    const pkmodes_real t58 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t59 = t19*t58;
    const pkmodes_real t60 = m_p + 2*t50 + 2*t56 + 2*t58;
    const pkmodes_real t61 = t55*theta_1_dot + t57*theta_2_dot + t59*theta_3_dot + t60*v_p_x;
    const pkmodes_real t62 = t14*t50;
    const pkmodes_real t63 = t17*t56;
    const pkmodes_real t64 = t20*t58;
    const pkmodes_real t65 = t60*v_p_y + t62*theta_1_dot + t63*theta_2_dot + t64*theta_3_dot;
    const pkmodes_real t66 = t15*t50;
    const pkmodes_real t67 = t18*t56;
    const pkmodes_real t68 = t21*t58;
    const pkmodes_real t69 = t60*v_p_z + t66*theta_1_dot + t67*theta_2_dot + t68*theta_3_dot;
    const pkmodes_real t70 = (R(1.0)/R(3.0))*m_d_1 + (R(1.0)/R(3.0))*m_d_2 + (R(1.0)/R(3.0))*m_d_3 + m_p;
    const pkmodes_real t71 = D_p_x_1*t70 + t55;
    const pkmodes_real t72 = D_p_y_1*t70 + t62;
    const pkmodes_real t73 = D_p_z_1*t70 + t66;
    const pkmodes_real t74 = t56*theta_2_dot;
    const pkmodes_real t75 = t7*t74;
    const pkmodes_real t76 = t74*t8;
    const pkmodes_real t77 = t74*t9;
    const pkmodes_real t78 = P_x_12*t61 + P_y_12*t65 + P_z_12*t69;
    const pkmodes_real t79 = t58*theta_3_dot;
    const pkmodes_real t80 = t10*t79;
    const pkmodes_real t81 = t11*t79;
    const pkmodes_real t82 = t12*t79;
    const pkmodes_real t83 = P_x_13*t61 + P_y_13*t65 + P_z_13*t69;
    const pkmodes_real t84 = L_a_1*t50;
    const pkmodes_real t85 = D_p_x_2*t70 + t57;
    const pkmodes_real t86 = D_p_y_2*t70 + t63;
    const pkmodes_real t87 = D_p_z_2*t70 + t67;
    const pkmodes_real t88 = P_x_23*t61 + P_y_23*t65 + P_z_23*t69;
    const pkmodes_real t89 = L_a_2*t56;
    const pkmodes_real t90 = D_p_x_3*t70 + t59;
    const pkmodes_real t91 = D_p_y_3*t70 + t64;
    const pkmodes_real t92 = D_p_z_3*t70 + t68;
    const pkmodes_real t93 = L_a_3*t58;
    h[0] =
        -D_p_dot_x_1*t61 - D_p_dot_y_1*t65 - D_p_dot_z_1*t69 + t52*v_p_x + t53*v_p_y + t54*v_p_z
        + theta_1_dot*(D_p_dot_x_1*t71 + D_p_dot_y_1*t72 + D_p_dot_z_1*t73 + P_x_11*t61 + P_y_11*t65
        + P_z_11*t69 - d_1_x*(t29*t84 + t84*v_p_x) - d_1_y*(t33*t84 + t84*v_p_y) - d_1_z*(t37*t84
        + t84*v_p_z)) + theta_2_dot*(D_p_dot_x_2*t71 + D_p_dot_y_2*t72 + D_p_dot_z_2*t73 - D_p_x_1*t75
        - D_p_y_1*t76 - D_p_z_1*t77 + t78) + theta_3_dot*(D_p_dot_x_3*t71 + D_p_dot_y_3*t72 + D_p_dot_z_3*t73
        - D_p_x_1*t80 - D_p_y_1*t81 - D_p_z_1*t82 + t83);
    h[1] =
        -D_p_dot_x_2*t61 - D_p_dot_y_2*t65 - D_p_dot_z_2*t69 + t75*v_p_x + t76*v_p_y + t77*v_p_z
        + theta_1_dot*(D_p_dot_x_1*t85 + D_p_dot_y_1*t86 + D_p_dot_z_1*t87 - D_p_x_2*t52 - D_p_y_2*t53
        - D_p_z_2*t54 + t78) + theta_2_dot*(D_p_dot_x_2*t85 + D_p_dot_y_2*t86 + D_p_dot_z_2*t87 + P_x_22*t61
        + P_y_22*t65 + P_z_22*t69 - d_2_x*(t30*t89 + t89*v_p_x) - d_2_y*(t34*t89 + t89*v_p_y)
        - d_2_z*(t38*t89 + t89*v_p_z)) + theta_3_dot*(D_p_dot_x_3*t85 + D_p_dot_y_3*t86 + D_p_dot_z_3*t87
        - D_p_x_2*t80 - D_p_y_2*t81 - D_p_z_2*t82 + t88);
    h[2] =
        -D_p_dot_x_3*t61 - D_p_dot_y_3*t65 - D_p_dot_z_3*t69 + t80*v_p_x + t81*v_p_y + t82*v_p_z
        + theta_1_dot*(D_p_dot_x_1*t90 + D_p_dot_y_1*t91 + D_p_dot_z_1*t92 - D_p_x_3*t52 - D_p_y_3*t53
        - D_p_z_3*t54 + t83) + theta_2_dot*(D_p_dot_x_2*t90 + D_p_dot_y_2*t91 + D_p_dot_z_2*t92 - D_p_x_3*t75
        - D_p_y_3*t76 - D_p_z_3*t77 + t88) + theta_3_dot*(D_p_dot_x_3*t90 + D_p_dot_y_3*t91 + D_p_dot_z_3*t92
        + P_x_33*t61 + P_y_33*t65 + P_z_33*t69 - d_3_x*(t31*t93 + t93*v_p_x) - d_3_y*(t35*t93 + t93*v_p_y)
        - d_3_z*(t39*t93 + t93*v_p_z));
}

void rotary_delta_gravity_potential(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
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
    const pkmodes_real d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const pkmodes_real d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const pkmodes_real d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const pkmodes_real d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const pkmodes_real d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const pkmodes_real d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t5 = L_a_2*t4;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t7 = L_a_3*t6;
    const pkmodes_real t8 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t9 = m_p + t4 + t6 + t8;
    const pkmodes_real t10 = m_a_1*r_a_1;
    const pkmodes_real t11 = m_a_2*r_a_2;
    const pkmodes_real t12 = m_a_3*r_a_3;
    const pkmodes_real t13 = L_a_1*t8;
    *V_g =
        -g_x*(b_1_x*t8 + b_2_x*t4 + b_3_x*t6 + d_1_x*t10 + d_1_x*t13 + d_2_x*t11 + d_2_x*t5 + d_3_x*t12
        + d_3_x*t7 + m_a_1*o_1_x + m_a_2*o_2_x + m_a_3*o_3_x + o_1_x*t8 + o_2_x*t4 + o_3_x*t6 + p_x*t9)
        - g_y*(b_1_y*t8 + b_2_y*t4 + b_3_y*t6 + d_1_y*t10 + d_1_y*t13 + d_2_y*t11 + d_2_y*t5 + d_3_y*t12
        + d_3_y*t7 + m_a_1*o_1_y + m_a_2*o_2_y + m_a_3*o_3_y + o_1_y*t8 + o_2_y*t4 + o_3_y*t6 + p_y*t9)
        - g_z*(b_1_z*t8 + b_2_z*t4 + b_3_z*t6 + d_1_z*t10 + d_1_z*t13 + d_2_z*t11 + d_2_z*t5 + d_3_z*t12
        + d_3_z*t7 + m_a_1*o_1_z + m_a_2*o_2_z + m_a_3*o_3_z + o_1_z*t8 + o_2_z*t4 + o_3_z*t6 + p_z*t9);
}

void rotary_delta_gravity_gradient(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
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
    const pkmodes_real t8 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t9 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t10 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t11 = m_p + t10 + t8 + t9;
    const pkmodes_real t12 = g_x*t11;
    const pkmodes_real t13 = g_y*t11;
    const pkmodes_real t14 = g_z*t11;
    const pkmodes_real t15 = L_a_1*t9 + m_a_1*r_a_1;
    const pkmodes_real t16 = L_a_2*t10 + m_a_2*r_a_2;
    const pkmodes_real t17 = L_a_3*t8 + m_a_3*r_a_3;
    G[0] = -D_p_x_1*t12 - D_p_y_1*t13 - D_p_z_1*t14 - g_x*t15*t_1_x - g_y*t15*t_1_y - g_z*t15*t_1_z;
    G[1] = -D_p_x_2*t12 - D_p_y_2*t13 - D_p_z_2*t14 - g_x*t16*t_2_x - g_y*t16*t_2_y - g_z*t16*t_2_z;
    G[2] = -D_p_x_3*t12 - D_p_y_3*t13 - D_p_z_3*t14 - g_x*t17*t_3_x - g_y*t17*t_3_y - g_z*t17*t_3_z;
}

void rotary_delta_gravity_hessian(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
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
    const pkmodes_real t4 = L_a_1*d_1_x;
    const pkmodes_real s_1_x = r_1_x - t4;
    const pkmodes_real t5 = L_a_1*d_1_y;
    const pkmodes_real s_1_y = r_1_y - t5;
    const pkmodes_real t6 = L_a_1*d_1_z;
    const pkmodes_real s_1_z = r_1_z - t6;
    const pkmodes_real t7 = L_a_2*d_2_x;
    const pkmodes_real s_2_x = r_2_x - t7;
    const pkmodes_real t8 = L_a_2*d_2_y;
    const pkmodes_real s_2_y = r_2_y - t8;
    const pkmodes_real t9 = L_a_2*d_2_z;
    const pkmodes_real s_2_z = r_2_z - t9;
    const pkmodes_real t10 = L_a_3*d_3_x;
    const pkmodes_real s_3_x = r_3_x - t10;
    const pkmodes_real t11 = L_a_3*d_3_y;
    const pkmodes_real s_3_y = r_3_y - t11;
    const pkmodes_real t12 = L_a_3*d_3_z;
    const pkmodes_real s_3_z = r_3_z - t12;
    const pkmodes_real t13 = L_a_1*t_1_x;
    const pkmodes_real t14 = L_a_1*t_1_y;
    const pkmodes_real t15 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15;
    const pkmodes_real t16 = L_a_2*t_2_x;
    const pkmodes_real t17 = L_a_2*t_2_y;
    const pkmodes_real t18 = L_a_2*t_2_z;
    const pkmodes_real D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18;
    const pkmodes_real t19 = L_a_3*t_3_x;
    const pkmodes_real t20 = L_a_3*t_3_y;
    const pkmodes_real t21 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21;
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
    const pkmodes_real t22 = 1/det_D_l;
    const pkmodes_real t23 = D_r_1*t22;
    const pkmodes_real D_p_x_1 = A_x_1*t23;
    const pkmodes_real t24 = D_r_2*t22;
    const pkmodes_real D_p_x_2 = A_x_2*t24;
    const pkmodes_real t25 = D_r_3*t22;
    const pkmodes_real D_p_x_3 = A_x_3*t25;
    const pkmodes_real D_p_y_1 = A_y_1*t23;
    const pkmodes_real D_p_y_2 = A_y_2*t24;
    const pkmodes_real D_p_y_3 = A_y_3*t25;
    const pkmodes_real D_p_z_1 = A_z_1*t23;
    const pkmodes_real D_p_z_2 = A_z_2*t24;
    const pkmodes_real D_p_z_3 = A_z_3*t25;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t13;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t14;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t15;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t16;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t17;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t18;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t19;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t20;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t21;
    const pkmodes_real t26 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t27 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t28 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t29 = m_p + t26 + t27 + t28;
    const pkmodes_real t30 = g_x*t29;
    const pkmodes_real t31 = g_y*t29;
    const pkmodes_real t32 = g_z*t29;
    const pkmodes_real mu_1 = t22*(-A_x_1*t30 - A_y_1*t31 - A_z_1*t32);
    const pkmodes_real mu_2 = t22*(-A_x_2*t30 - A_y_2*t31 - A_z_2*t32);
    const pkmodes_real mu_3 = t22*(-A_x_3*t30 - A_y_3*t31 - A_z_3*t32);
    const pkmodes_real t33 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t34 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t35 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t36 = L_a_1*t26 + m_a_1*r_a_1;
    const pkmodes_real t37 = D_p_x_1*mu_3;
    const pkmodes_real t38 = D_p_x_1*mu_2;
    const pkmodes_real t39 = U_1_x_1*mu_1;
    const pkmodes_real t40 = D_p_y_1*mu_3;
    const pkmodes_real t41 = D_p_y_1*mu_2;
    const pkmodes_real t42 = U_1_y_1*mu_1;
    const pkmodes_real t43 = D_p_z_1*mu_3;
    const pkmodes_real t44 = D_p_z_1*mu_2;
    const pkmodes_real t45 = U_1_z_1*mu_1;
    const pkmodes_real t46 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t47 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t48 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t49 = L_a_2*t27 + m_a_2*r_a_2;
    const pkmodes_real t50 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t51 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t52 = (D_p_z_3*D_p_z_3);
    const pkmodes_real t53 = L_a_3*t28 + m_a_3*r_a_3;
    H_g[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + d_1_x*g_x*t36
        + d_1_y*g_y*t36 + d_1_z*g_z*t36 - mu_1*s_1_x*t4 - mu_1*s_1_y*t5 - mu_1*s_1_z*t6 - mu_2*t33 - mu_2*t34
        - mu_2*t35 - mu_3*t33 - mu_3*t34 - mu_3*t35;
    H_g[0][1] = H_g[1][0] =
        -D_p_x_2*t37 - D_p_x_2*t39 - D_p_y_2*t40 - D_p_y_2*t42 - D_p_z_2*t43 - D_p_z_2*t45 - U_2_x_2*t38
        - U_2_y_2*t41 - U_2_z_2*t44;
    H_g[0][2] = H_g[2][0] =
        -D_p_x_3*t38 - D_p_x_3*t39 - D_p_y_3*t41 - D_p_y_3*t42 - D_p_z_3*t44 - D_p_z_3*t45 - U_3_x_3*t37
        - U_3_y_3*t40 - U_3_z_3*t43;
    H_g[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + d_2_x*g_x*t49
        + d_2_y*g_y*t49 + d_2_z*g_z*t49 - mu_1*t46 - mu_1*t47 - mu_1*t48 - mu_2*s_2_x*t7 - mu_2*s_2_y*t8
        - mu_2*s_2_z*t9 - mu_3*t46 - mu_3*t47 - mu_3*t48;
    H_g[1][2] = H_g[2][1] =
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2;
    H_g[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + d_3_x*g_x*t53
        + d_3_y*g_y*t53 + d_3_z*g_z*t53 - mu_1*t50 - mu_1*t51 - mu_1*t52 - mu_2*t50 - mu_2*t51 - mu_2*t52
        - mu_3*s_3_x*t10 - mu_3*s_3_y*t11 - mu_3*s_3_z*t12;
}

void rotary_delta_elastic_potential(const pkmodes_real p[3], const pkmodes_real delta_q[6],
    const rotary_delta_parameters *parameters, pkmodes_real *V_el)
{
    (void)p;
    const pkmodes_real delta_theta_1 = delta_q[0];
    const pkmodes_real delta_theta_2 = delta_q[1];
    const pkmodes_real delta_theta_3 = delta_q[2];
    const pkmodes_real delta_phi_1 = delta_q[3];
    const pkmodes_real delta_phi_2 = delta_q[4];
    const pkmodes_real delta_phi_3 = delta_q[5];
    const pkmodes_real k_r_1 = parameters->reducer_stiffness[0];
    const pkmodes_real k_r_2 = parameters->reducer_stiffness[1];
    const pkmodes_real k_r_3 = parameters->reducer_stiffness[2];
    *V_el =
        (R(1.0)/R(2.0))*k_r_1*((-delta_phi_1 + delta_theta_1)*(-delta_phi_1 + delta_theta_1))
        + (R(1.0)/R(2.0))*k_r_2*((-delta_phi_2 + delta_theta_2)*(-delta_phi_2 + delta_theta_2))
        + (R(1.0)/R(2.0))*k_r_3*((-delta_phi_3 + delta_theta_3)*(-delta_phi_3 + delta_theta_3));
}

void rotary_delta_elastic_gradient(const pkmodes_real p[3], const pkmodes_real delta_q[6],
    const rotary_delta_parameters *parameters, pkmodes_real E[6])
{
    (void)p;
    const pkmodes_real delta_theta_1 = delta_q[0];
    const pkmodes_real delta_theta_2 = delta_q[1];
    const pkmodes_real delta_theta_3 = delta_q[2];
    const pkmodes_real delta_phi_1 = delta_q[3];
    const pkmodes_real delta_phi_2 = delta_q[4];
    const pkmodes_real delta_phi_3 = delta_q[5];
    const pkmodes_real k_r_1 = parameters->reducer_stiffness[0];
    const pkmodes_real k_r_2 = parameters->reducer_stiffness[1];
    const pkmodes_real k_r_3 = parameters->reducer_stiffness[2];
    const pkmodes_real t1 = 2*delta_phi_1 - 2*delta_theta_1;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*k_r_1;
    const pkmodes_real t3 = 2*delta_phi_2 - 2*delta_theta_2;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*k_r_2;
    const pkmodes_real t5 = 2*delta_phi_3 - 2*delta_theta_3;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*k_r_3;
    E[0] = -t1*t2;
    E[1] = -t3*t4;
    E[2] = -t5*t6;
    E[3] = t1*t2;
    E[4] = t3*t4;
    E[5] = t5*t6;
}

void rotary_delta_elastic_hessian(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real H_el[6][6])
{
    (void)p;
    const pkmodes_real k_r_1 = parameters->reducer_stiffness[0];
    const pkmodes_real k_r_2 = parameters->reducer_stiffness[1];
    const pkmodes_real k_r_3 = parameters->reducer_stiffness[2];
    memset(H_el, 0, sizeof(pkmodes_real[6][6]));
    H_el[0][0] = k_r_1;
    H_el[0][3] = H_el[3][0] = -k_r_1;
    H_el[1][1] = k_r_2;
    H_el[1][4] = H_el[4][1] = -k_r_2;
    H_el[2][2] = k_r_3;
    H_el[2][5] = H_el[5][2] = -k_r_3;
    H_el[3][3] = k_r_1;
    H_el[4][4] = k_r_2;
    H_el[5][5] = k_r_3;
}

void rotary_delta_static_equilibrium(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real tau_st[3], pkmodes_real theta_st[3])
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
    const pkmodes_real t8 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t9 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t10 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t11 = m_p + t10 + t8 + t9;
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
    const pkmodes_real phi_1_st = G_1/k_r_1;
    const pkmodes_real phi_2_st = G_2/k_r_2;
    const pkmodes_real phi_3_st = G_3/k_r_3;
    const pkmodes_real tau_st_1 = k_r_1*phi_1_st;
    const pkmodes_real tau_st_2 = k_r_2*phi_2_st;
    const pkmodes_real tau_st_3 = k_r_3*phi_3_st;
    tau_st[0] = tau_st_1;
    tau_st[1] = tau_st_2;
    tau_st[2] = tau_st_3;
    theta_st[0] = phi_1_st;
    theta_st[1] = phi_2_st;
    theta_st[2] = phi_3_st;
}

void rotary_delta_stiffness_matrix(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real K[6][6])
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
    const pkmodes_real t4 = L_a_1*d_1_x;
    const pkmodes_real s_1_x = r_1_x - t4;
    const pkmodes_real t5 = L_a_1*d_1_y;
    const pkmodes_real s_1_y = r_1_y - t5;
    const pkmodes_real t6 = L_a_1*d_1_z;
    const pkmodes_real s_1_z = r_1_z - t6;
    const pkmodes_real t7 = L_a_2*d_2_x;
    const pkmodes_real s_2_x = r_2_x - t7;
    const pkmodes_real t8 = L_a_2*d_2_y;
    const pkmodes_real s_2_y = r_2_y - t8;
    const pkmodes_real t9 = L_a_2*d_2_z;
    const pkmodes_real s_2_z = r_2_z - t9;
    const pkmodes_real t10 = L_a_3*d_3_x;
    const pkmodes_real s_3_x = r_3_x - t10;
    const pkmodes_real t11 = L_a_3*d_3_y;
    const pkmodes_real s_3_y = r_3_y - t11;
    const pkmodes_real t12 = L_a_3*d_3_z;
    const pkmodes_real s_3_z = r_3_z - t12;
    const pkmodes_real t13 = L_a_1*t_1_x;
    const pkmodes_real t14 = L_a_1*t_1_y;
    const pkmodes_real t15 = L_a_1*t_1_z;
    const pkmodes_real D_r_1 = s_1_x*t13 + s_1_y*t14 + s_1_z*t15;
    const pkmodes_real t16 = L_a_2*t_2_x;
    const pkmodes_real t17 = L_a_2*t_2_y;
    const pkmodes_real t18 = L_a_2*t_2_z;
    const pkmodes_real D_r_2 = s_2_x*t16 + s_2_y*t17 + s_2_z*t18;
    const pkmodes_real t19 = L_a_3*t_3_x;
    const pkmodes_real t20 = L_a_3*t_3_y;
    const pkmodes_real t21 = L_a_3*t_3_z;
    const pkmodes_real D_r_3 = s_3_x*t19 + s_3_y*t20 + s_3_z*t21;
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
    const pkmodes_real t22 = 1/det_D_l;
    const pkmodes_real t23 = D_r_1*t22;
    const pkmodes_real D_p_x_1 = A_x_1*t23;
    const pkmodes_real t24 = D_r_2*t22;
    const pkmodes_real D_p_x_2 = A_x_2*t24;
    const pkmodes_real t25 = D_r_3*t22;
    const pkmodes_real D_p_x_3 = A_x_3*t25;
    const pkmodes_real D_p_y_1 = A_y_1*t23;
    const pkmodes_real D_p_y_2 = A_y_2*t24;
    const pkmodes_real D_p_y_3 = A_y_3*t25;
    const pkmodes_real D_p_z_1 = A_z_1*t23;
    const pkmodes_real D_p_z_2 = A_z_2*t24;
    const pkmodes_real D_p_z_3 = A_z_3*t25;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t13;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t14;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t15;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t16;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t17;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t18;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t19;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t20;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t21;
    const pkmodes_real t26 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t27 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t28 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t29 = m_p + t26 + t27 + t28;
    const pkmodes_real t30 = g_x*t29;
    const pkmodes_real t31 = g_y*t29;
    const pkmodes_real t32 = g_z*t29;
    const pkmodes_real mu_1 = t22*(-A_x_1*t30 - A_y_1*t31 - A_z_1*t32);
    const pkmodes_real mu_2 = t22*(-A_x_2*t30 - A_y_2*t31 - A_z_2*t32);
    const pkmodes_real mu_3 = t22*(-A_x_3*t30 - A_y_3*t31 - A_z_3*t32);
    const pkmodes_real t33 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t34 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t35 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t36 = L_a_1*t26 + m_a_1*r_a_1;
    const pkmodes_real t37 = D_p_x_1*mu_3;
    const pkmodes_real t38 = D_p_x_1*mu_2;
    const pkmodes_real t39 = U_1_x_1*mu_1;
    const pkmodes_real t40 = D_p_y_1*mu_3;
    const pkmodes_real t41 = D_p_y_1*mu_2;
    const pkmodes_real t42 = U_1_y_1*mu_1;
    const pkmodes_real t43 = D_p_z_1*mu_3;
    const pkmodes_real t44 = D_p_z_1*mu_2;
    const pkmodes_real t45 = U_1_z_1*mu_1;
    const pkmodes_real t46 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t47 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t48 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t49 = L_a_2*t27 + m_a_2*r_a_2;
    const pkmodes_real t50 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t51 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t52 = (D_p_z_3*D_p_z_3);
    const pkmodes_real t53 = L_a_3*t28 + m_a_3*r_a_3;
    memset(K, 0, sizeof(pkmodes_real[6][6]));
    K[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + d_1_x*g_x*t36
        + d_1_y*g_y*t36 + d_1_z*g_z*t36 + k_r_1 - mu_1*s_1_x*t4 - mu_1*s_1_y*t5 - mu_1*s_1_z*t6 - mu_2*t33
        - mu_2*t34 - mu_2*t35 - mu_3*t33 - mu_3*t34 - mu_3*t35;
    K[0][1] = K[1][0] =
        -D_p_x_2*t37 - D_p_x_2*t39 - D_p_y_2*t40 - D_p_y_2*t42 - D_p_z_2*t43 - D_p_z_2*t45 - U_2_x_2*t38
        - U_2_y_2*t41 - U_2_z_2*t44;
    K[0][2] = K[2][0] =
        -D_p_x_3*t38 - D_p_x_3*t39 - D_p_y_3*t41 - D_p_y_3*t42 - D_p_z_3*t44 - D_p_z_3*t45 - U_3_x_3*t37
        - U_3_y_3*t40 - U_3_z_3*t43;
    K[0][3] = K[3][0] = -k_r_1;
    K[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + d_2_x*g_x*t49
        + d_2_y*g_y*t49 + d_2_z*g_z*t49 + k_r_2 - mu_1*t46 - mu_1*t47 - mu_1*t48 - mu_2*s_2_x*t7
        - mu_2*s_2_y*t8 - mu_2*s_2_z*t9 - mu_3*t46 - mu_3*t47 - mu_3*t48;
    K[1][2] = K[2][1] =
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2;
    K[1][4] = K[4][1] = -k_r_2;
    K[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + d_3_x*g_x*t53
        + d_3_y*g_y*t53 + d_3_z*g_z*t53 + k_r_3 - mu_1*t50 - mu_1*t51 - mu_1*t52 - mu_2*t50 - mu_2*t51
        - mu_2*t52 - mu_3*s_3_x*t10 - mu_3*s_3_y*t11 - mu_3*s_3_z*t12;
    K[2][5] = K[5][2] = -k_r_3;
    K[3][3] = k_r_1;
    K[4][4] = k_r_2;
    K[5][5] = k_r_3;
}

void rotary_delta_modal_matrices(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real M[6][6], pkmodes_real K[6][6])
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
    const pkmodes_real t26 = D_r_1*t25;
    const pkmodes_real D_p_x_1 = A_x_1*t26;
    const pkmodes_real t27 = D_r_2*t25;
    const pkmodes_real D_p_x_2 = A_x_2*t27;
    const pkmodes_real t28 = D_r_3*t25;
    const pkmodes_real D_p_x_3 = A_x_3*t28;
    const pkmodes_real D_p_y_1 = A_y_1*t26;
    const pkmodes_real D_p_y_2 = A_y_2*t27;
    const pkmodes_real D_p_y_3 = A_y_3*t28;
    const pkmodes_real D_p_z_1 = A_z_1*t26;
    const pkmodes_real D_p_z_2 = A_z_2*t27;
    const pkmodes_real D_p_z_3 = A_z_3*t28;
    const pkmodes_real U_1_x_1 = D_p_x_1 - t16;
    const pkmodes_real U_1_y_1 = D_p_y_1 - t17;
    const pkmodes_real U_1_z_1 = D_p_z_1 - t18;
    const pkmodes_real U_2_x_2 = D_p_x_2 - t19;
    const pkmodes_real U_2_y_2 = D_p_y_2 - t20;
    const pkmodes_real U_2_z_2 = D_p_z_2 - t21;
    const pkmodes_real U_3_x_3 = D_p_x_3 - t22;
    const pkmodes_real U_3_y_3 = D_p_y_3 - t23;
    const pkmodes_real U_3_z_3 = D_p_z_3 - t24;
    const pkmodes_real I_1 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_2 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_3 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real t29 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t30 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t31 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t32 = m_p + t29 + t30 + t31;
    const pkmodes_real t33 = g_x*t32;
    const pkmodes_real t34 = g_y*t32;
    const pkmodes_real t35 = g_z*t32;
    const pkmodes_real mu_1 = t25*(-A_x_1*t33 - A_y_1*t34 - A_z_1*t35);
    const pkmodes_real mu_2 = t25*(-A_x_2*t33 - A_y_2*t34 - A_z_2*t35);
    const pkmodes_real mu_3 = t25*(-A_x_3*t33 - A_y_3*t34 - A_z_3*t35);
    const pkmodes_real t36 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t37 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t38 = t16*t37;
    const pkmodes_real t39 = t17*t37;
    const pkmodes_real t40 = t18*t37;
    const pkmodes_real t41 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t42 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t43 = m_p + t36 + t41 + t42;
    const pkmodes_real t44 = D_p_x_1*t43 + t38;
    const pkmodes_real t45 = D_p_y_1*t43 + t39;
    const pkmodes_real t46 = D_p_z_1*t43 + t40;
    const pkmodes_real t47 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t48 = t19*t47;
    const pkmodes_real t49 = t20*t47;
    const pkmodes_real t50 = t21*t47;
    const pkmodes_real t51 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t52 = t22*t51;
    const pkmodes_real t53 = t23*t51;
    const pkmodes_real t54 = t24*t51;
    const pkmodes_real t55 = D_p_x_2*t43 + t48;
    const pkmodes_real t56 = D_p_y_2*t43 + t49;
    const pkmodes_real t57 = D_p_z_2*t43 + t50;
    const pkmodes_real t58 = (D_p_x_1*D_p_x_1);
    const pkmodes_real t59 = (D_p_y_1*D_p_y_1);
    const pkmodes_real t60 = (D_p_z_1*D_p_z_1);
    const pkmodes_real t61 = L_a_1*t29 + m_a_1*r_a_1;
    const pkmodes_real t62 = D_p_x_1*mu_3;
    const pkmodes_real t63 = D_p_x_1*mu_2;
    const pkmodes_real t64 = U_1_x_1*mu_1;
    const pkmodes_real t65 = D_p_y_1*mu_3;
    const pkmodes_real t66 = D_p_y_1*mu_2;
    const pkmodes_real t67 = U_1_y_1*mu_1;
    const pkmodes_real t68 = D_p_z_1*mu_3;
    const pkmodes_real t69 = D_p_z_1*mu_2;
    const pkmodes_real t70 = U_1_z_1*mu_1;
    const pkmodes_real t71 = (D_p_x_2*D_p_x_2);
    const pkmodes_real t72 = (D_p_y_2*D_p_y_2);
    const pkmodes_real t73 = (D_p_z_2*D_p_z_2);
    const pkmodes_real t74 = L_a_2*t30 + m_a_2*r_a_2;
    const pkmodes_real t75 = (D_p_x_3*D_p_x_3);
    const pkmodes_real t76 = (D_p_y_3*D_p_y_3);
    const pkmodes_real t77 = (D_p_z_3*D_p_z_3);
    const pkmodes_real t78 = L_a_3*t31 + m_a_3*r_a_3;
    memset(M, 0, sizeof(pkmodes_real[6][6]));
    M[0][0] =
        D_p_x_1*t38 + D_p_x_1*t44 + D_p_y_1*t39 + D_p_y_1*t45 + D_p_z_1*t40 + D_p_z_1*t46 + I_a_1 + t1*t36;
    M[0][1] = M[1][0] = D_p_x_1*t48 + D_p_x_2*t44 + D_p_y_1*t49 + D_p_y_2*t45 + D_p_z_1*t50 + D_p_z_2*t46;
    M[0][2] = M[2][0] = D_p_x_1*t52 + D_p_x_3*t44 + D_p_y_1*t53 + D_p_y_3*t45 + D_p_z_1*t54 + D_p_z_3*t46;
    M[1][1] =
        D_p_x_2*t48 + D_p_x_2*t55 + D_p_y_2*t49 + D_p_y_2*t56 + D_p_z_2*t50 + D_p_z_2*t57 + I_a_2 + t3*t41;
    M[1][2] = M[2][1] = D_p_x_2*t52 + D_p_x_3*t55 + D_p_y_2*t53 + D_p_y_3*t56 + D_p_z_2*t54 + D_p_z_3*t57;
    M[2][2] =
        D_p_x_3*t52 + D_p_x_3*(D_p_x_3*t43 + t52) + D_p_y_3*t53 + D_p_y_3*(D_p_y_3*t43 + t53) + D_p_z_3*t54
        + D_p_z_3*(D_p_z_3*t43 + t54) + I_a_3 + t42*t5;
    M[3][3] = I_1;
    M[4][4] = I_2;
    M[5][5] = I_3;
    memset(K, 0, sizeof(pkmodes_real[6][6]));
    K[0][0] =
        -(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + d_1_x*g_x*t61
        + d_1_y*g_y*t61 + d_1_z*g_z*t61 + k_r_1 - mu_1*s_1_x*t7 - mu_1*s_1_y*t8 - mu_1*s_1_z*t9 - mu_2*t58
        - mu_2*t59 - mu_2*t60 - mu_3*t58 - mu_3*t59 - mu_3*t60;
    K[0][1] = K[1][0] =
        -D_p_x_2*t62 - D_p_x_2*t64 - D_p_y_2*t65 - D_p_y_2*t67 - D_p_z_2*t68 - D_p_z_2*t70 - U_2_x_2*t63
        - U_2_y_2*t66 - U_2_z_2*t69;
    K[0][2] = K[2][0] =
        -D_p_x_3*t63 - D_p_x_3*t64 - D_p_y_3*t66 - D_p_y_3*t67 - D_p_z_3*t69 - D_p_z_3*t70 - U_3_x_3*t62
        - U_3_y_3*t65 - U_3_z_3*t68;
    K[0][3] = K[3][0] = -k_r_1;
    K[1][1] =
        -(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + d_2_x*g_x*t74
        + d_2_y*g_y*t74 + d_2_z*g_z*t74 + k_r_2 - mu_1*t71 - mu_1*t72 - mu_1*t73 - mu_2*s_2_x*t10
        - mu_2*s_2_y*t11 - mu_2*s_2_z*t12 - mu_3*t71 - mu_3*t72 - mu_3*t73;
    K[1][2] = K[2][1] =
        -D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2;
    K[1][4] = K[4][1] = -k_r_2;
    K[2][2] =
        -(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + d_3_x*g_x*t78
        + d_3_y*g_y*t78 + d_3_z*g_z*t78 + k_r_3 - mu_1*t75 - mu_1*t76 - mu_1*t77 - mu_2*t75 - mu_2*t76
        - mu_2*t77 - mu_3*s_3_x*t13 - mu_3*s_3_y*t14 - mu_3*s_3_z*t15;
    K[2][5] = K[5][2] = -k_r_3;
    K[3][3] = k_r_1;
    K[4][4] = k_r_2;
    K[5][5] = k_r_3;
}

/* Coordinates, and the most iterations for one eigenvalue; two are usual. */
enum { N = ROTARY_DELTA_COORDINATES, EIGEN_ITERATIONS = 60 };

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
int rotary_delta_status(const pkmodes_real p[3], const rotary_delta_parameters *parameters)
{
    int i;
    for (i = 0; i < ROTARY_DELTA_POSE; ++i)
        if (!isfinite(p[i]))
            return ROTARY_DELTA_NOT_FINITE;
    {
        pkmodes_real margin[3][2];
        rotary_delta_reach_margin(p, parameters, margin);
        for (i = 0; i < 6; ++i)
            if (!(((const pkmodes_real *)margin)[i] >= 0))
                return ROTARY_DELTA_BEYOND_REACHABLE;
    }
    {
        pkmodes_real determinant, condition;
        rotary_delta_jacobian_condition(p, parameters, &determinant, &condition);
        for (i = 0; i < 1; ++i)
            if (!(((const pkmodes_real *)&condition)[i] <= ROTARY_DELTA_MAX_CONDITION))
                return ROTARY_DELTA_BEYOND_SINGULAR;
    }
    {
        pkmodes_real margin[3][2];
        rotary_delta_limit_margin(p, parameters, margin);
        for (i = 0; i < 6; ++i)
            if (!(((const pkmodes_real *)margin)[i] >= 0))
                return ROTARY_DELTA_BEYOND_LIMITS;
    }
    return 0;
}

int rotary_delta_modes(
    const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real f[6], pkmodes_real phi[6][6])
{
    pkmodes_real M[N][N], K[N][N];
    const int status = rotary_delta_status(p, parameters);
    if (status)
        return status;
    rotary_delta_modal_matrices(p, parameters, M, K);
    if (eigen_solve(N, M, K, f, phi) || eigen_lost(N, f, ROTARY_DELTA_RIGID_MODES))
        return ROTARY_DELTA_UNSOLVED;
    eigen_frequencies(N, f);
    return 0;
}

int rotary_delta_natural_frequencies(
    const pkmodes_real p[3], const rotary_delta_parameters *parameters, pkmodes_real f[6])
{
    return rotary_delta_modes(p, parameters, f, NULL);
}
