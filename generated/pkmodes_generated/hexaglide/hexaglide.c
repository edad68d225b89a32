/* Generated from the derivation of hexaglide.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism hexaglide, for a robot given by its parameters.
 * The header describes every function.
 *
 * Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; coordinate l of a second
 * derivative; belt span s; component i = x, y, z; rows r of a minor; columns c of a minor; axis a of the
 * platform.  t1, t2, ... are subexpressions shared by several values.
 *   w_p_i [rad/s]: angular velocity of the platform, component i
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
 *   v_p_i [m/s]: velocity of the platform, component i
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
 *   D_p_i_k [1/m]: platform Jacobian, dp_i/dx_k
 *   U_j_i_k [1]: derivative of linkage vector j, component i, with respect to x_k
 *   f_j_kl [1]: right-hand side of closure j, differentiated with respect to x_k and x_l
 *   P_i_kl [1/m]: second derivative of p_i with respect to x_k and x_l
 *   P_i_kl [1/m^2]: second derivative of p_i with respect to x_k and x_l
 *   s_dot_j_i [m/s]: rate of change of linkage vector j, component i
 *   D_p_dot_i_k [1/s]: time derivative of dp_i/dx_k
 *   D_p_dot_i_k [1/(m s)]: time derivative of dp_i/dx_k
 *   D_l_dot_j_i [m^2/s]: rate of change of the moment of linkage vector j, component i
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
 *   a_p_i [m/s^2]: acceleration of the platform at constant rates of the coordinates, component i
 *   a_p_i [rad/s^2]: acceleration of the platform at constant rates of the coordinates, component i
 *   pi_i [kg m^2/s]: momentum of the moving bodies, component i
 *   z_i [N]: force of the moving bodies, component i
 *   z_i [N m]: force of the moving bodies, component i
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#include "hexaglide.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void hexaglide_inverse_kinematics(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real x[6])
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
    x[0] = x_1;
    x[1] = x_2;
    x[2] = x_3;
    x[3] = x_4;
    x[4] = x_5;
    x[5] = x_6;
}

void hexaglide_inertia_margin(const hexaglide_parameters *parameters, pkmodes_real margin[7])
{
    const pkmodes_real I_p_x = parameters->platform_inertia[0];
    const pkmodes_real I_p_y = parameters->platform_inertia[1];
    const pkmodes_real I_p_z = parameters->platform_inertia[2];
    const pkmodes_real I_p_xy = parameters->platform_products[0];
    const pkmodes_real I_p_xz = parameters->platform_products[1];
    const pkmodes_real I_p_yz = parameters->platform_products[2];
    const pkmodes_real t1 = I_p_x + I_p_y + I_p_z;
    const pkmodes_real t2 = 1/t1;
    const pkmodes_real t3 = (R(1.0)/R(2.0))*I_p_x;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*I_p_y;
    const pkmodes_real t5 = (R(1.0)/R(2.0))*I_p_z;
    const pkmodes_real t6 = -t3 + t4 + t5;
    const pkmodes_real t7 = t3 - t4 + t5;
    const pkmodes_real t8 = t3 + t4 - t5;
    const pkmodes_real t9 = 1/((t1*t1));
    const pkmodes_real t10 = (I_p_xy*I_p_xy);
    const pkmodes_real t11 = (I_p_xz*I_p_xz);
    const pkmodes_real t12 = (I_p_yz*I_p_yz);
    const pkmodes_real t13 = (I_p_y*I_p_y);
    const pkmodes_real t14 = (I_p_z*I_p_z);
    const pkmodes_real t15 = (I_p_x*I_p_x);
    margin[0] = t2*t6 + R(1e-09);
    margin[1] = t2*t7 + R(1e-09);
    margin[2] = t2*t8 + R(1e-09);
    margin[3] = t9*(-t10 + t6*t7) + R(1e-09);
    margin[4] = t9*(-t11 + t6*t8) + R(1e-09);
    margin[5] = t9*(-t12 + t7*t8) + R(1e-09);
    margin[6] =
        R(1e-09) + (-R(1.0)/R(8.0)*(I_p_x*I_p_x*I_p_x) - R(1.0)/R(4.0)*I_p_x*I_p_y*I_p_z
        + (R(1.0)/R(2.0))*I_p_x*t12 + (R(1.0)/R(8.0))*I_p_x*t13 + (R(1.0)/R(8.0))*I_p_x*t14
        - 2*I_p_xy*I_p_xz*I_p_yz - R(1.0)/R(8.0)*(I_p_y*I_p_y*I_p_y) + (R(1.0)/R(2.0))*I_p_y*t11
        + (R(1.0)/R(8.0))*I_p_y*t14 + (R(1.0)/R(8.0))*I_p_y*t15 - R(1.0)/R(8.0)*(I_p_z*I_p_z*I_p_z)
        + (R(1.0)/R(2.0))*I_p_z*t10 + (R(1.0)/R(8.0))*I_p_z*t13 + (R(1.0)/R(8.0))*I_p_z*t15 - t10*t3 - t10*t4
        - t11*t3 - t11*t5 - t12*t4 - t12*t5)/(t1*t1*t1);
}

void hexaglide_rotation_margin(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real *margin)
{
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    (void)parameters;
    *margin = -R(sqrt)((rot_x*rot_x) + (rot_y*rot_y) + (rot_z*rot_z)) + (R(1.0)/R(2.0))*R(3.141592653589793);
}

void hexaglide_reach_margin(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real margin[6])
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
    const pkmodes_real a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z;
    const pkmodes_real w_4_x = -a_4*n_4_x + r_4_x;
    const pkmodes_real w_4_y = -a_4*n_4_y + r_4_y;
    const pkmodes_real w_4_z = -a_4*n_4_z + r_4_z;
    const pkmodes_real w2_4 = (w_4_x*w_4_x) + (w_4_y*w_4_y) + (w_4_z*w_4_z);
    const pkmodes_real a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z;
    const pkmodes_real w_5_x = -a_5*n_5_x + r_5_x;
    const pkmodes_real w_5_y = -a_5*n_5_y + r_5_y;
    const pkmodes_real w_5_z = -a_5*n_5_z + r_5_z;
    const pkmodes_real w2_5 = (w_5_x*w_5_x) + (w_5_y*w_5_y) + (w_5_z*w_5_z);
    const pkmodes_real a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z;
    const pkmodes_real w_6_x = -a_6*n_6_x + r_6_x;
    const pkmodes_real w_6_y = -a_6*n_6_y + r_6_y;
    const pkmodes_real w_6_z = -a_6*n_6_z + r_6_z;
    const pkmodes_real w2_6 = (w_6_x*w_6_x) + (w_6_y*w_6_y) + (w_6_z*w_6_z);
    margin[0] = l_d_1 - R(sqrt)(w2_1);
    margin[1] = l_d_2 - R(sqrt)(w2_2);
    margin[2] = l_d_3 - R(sqrt)(w2_3);
    margin[3] = l_d_4 - R(sqrt)(w2_4);
    margin[4] = l_d_5 - R(sqrt)(w2_5);
    margin[5] = l_d_6 - R(sqrt)(w2_6);
}

void hexaglide_travel_margin(const hexaglide_parameters *parameters, pkmodes_real margin[6])
{
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real l_t_4 = parameters->carriage_length[3];
    const pkmodes_real l_t_5 = parameters->carriage_length[4];
    const pkmodes_real l_t_6 = parameters->carriage_length[5];
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
    margin[0] = -l_t_1 + x_max_1 - x_min_1;
    margin[1] = -l_t_2 + x_max_2 - x_min_2;
    margin[2] = -l_t_3 + x_max_3 - x_min_3;
    margin[3] = -l_t_4 + x_max_4 - x_min_4;
    margin[4] = -l_t_5 + x_max_5 - x_min_5;
    margin[5] = -l_t_6 + x_max_6 - x_min_6;
}

void hexaglide_belt_spans(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real l_f[6][3])
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
    const pkmodes_real l_t_1 = parameters->carriage_length[0];
    const pkmodes_real l_t_2 = parameters->carriage_length[1];
    const pkmodes_real l_t_3 = parameters->carriage_length[2];
    const pkmodes_real l_t_4 = parameters->carriage_length[3];
    const pkmodes_real l_t_5 = parameters->carriage_length[4];
    const pkmodes_real l_t_6 = parameters->carriage_length[5];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t12 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t12 + x_1 - x_min_1;
    const pkmodes_real l_f_1_3 = -t12 - x_1 + x_max_1;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t13 + x_2 - x_min_2;
    const pkmodes_real l_f_2_3 = -t13 - x_2 + x_max_2;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t14 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t14 + x_3 - x_min_3;
    const pkmodes_real l_f_3_3 = -t14 - x_3 + x_max_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t15 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t15 + x_4 - x_min_4;
    const pkmodes_real l_f_4_3 = -t15 - x_4 + x_max_4;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t16 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t16 + x_5 - x_min_5;
    const pkmodes_real l_f_5_3 = -t16 - x_5 + x_max_5;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t17 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t17 + x_6 - x_min_6;
    const pkmodes_real l_f_6_3 = -t17 - x_6 + x_max_6;
    l_f[0][0] = l_f_1_1;
    l_f[0][1] = l_f_1_2;
    l_f[0][2] = l_f_1_3;
    l_f[1][0] = l_f_2_1;
    l_f[1][1] = l_f_2_2;
    l_f[1][2] = l_f_2_3;
    l_f[2][0] = l_f_3_1;
    l_f[2][1] = l_f_3_2;
    l_f[2][2] = l_f_3_3;
    l_f[3][0] = l_f_4_1;
    l_f[3][1] = l_f_4_2;
    l_f[3][2] = l_f_4_3;
    l_f[4][0] = l_f_5_1;
    l_f[4][1] = l_f_5_2;
    l_f[4][2] = l_f_5_3;
    l_f[5][0] = l_f_6_1;
    l_f[5][1] = l_f_6_2;
    l_f[5][2] = l_f_6_3;
}

void hexaglide_constraint_jacobians(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real D_l[6][6], pkmodes_real D_r[6][6])
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
    D_l[0][0] = s_1_x;
    D_l[0][1] = s_1_y;
    D_l[0][2] = s_1_z;
    D_l[0][3] = D_l_1_rx;
    D_l[0][4] = D_l_1_ry;
    D_l[0][5] = D_l_1_rz;
    D_l[1][0] = s_2_x;
    D_l[1][1] = s_2_y;
    D_l[1][2] = s_2_z;
    D_l[1][3] = D_l_2_rx;
    D_l[1][4] = D_l_2_ry;
    D_l[1][5] = D_l_2_rz;
    D_l[2][0] = s_3_x;
    D_l[2][1] = s_3_y;
    D_l[2][2] = s_3_z;
    D_l[2][3] = D_l_3_rx;
    D_l[2][4] = D_l_3_ry;
    D_l[2][5] = D_l_3_rz;
    D_l[3][0] = s_4_x;
    D_l[3][1] = s_4_y;
    D_l[3][2] = s_4_z;
    D_l[3][3] = D_l_4_rx;
    D_l[3][4] = D_l_4_ry;
    D_l[3][5] = D_l_4_rz;
    D_l[4][0] = s_5_x;
    D_l[4][1] = s_5_y;
    D_l[4][2] = s_5_z;
    D_l[4][3] = D_l_5_rx;
    D_l[4][4] = D_l_5_ry;
    D_l[4][5] = D_l_5_rz;
    D_l[5][0] = s_6_x;
    D_l[5][1] = s_6_y;
    D_l[5][2] = s_6_z;
    D_l[5][3] = D_l_6_rx;
    D_l[5][4] = D_l_6_ry;
    D_l[5][5] = D_l_6_rz;
    memset(D_r, 0, sizeof(pkmodes_real[6][6]));
    D_r[0][0] = D_r_1;
    D_r[1][1] = D_r_2;
    D_r[2][2] = D_r_3;
    D_r[3][3] = D_r_4;
    D_r[4][4] = D_r_5;
    D_r[5][5] = D_r_6;
}

void hexaglide_jacobian_condition(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real *determinant, pkmodes_real *condition)
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
    const pkmodes_real t12 =
        (R(1.0)/R(6.0))*(B_1_x*B_1_x) + (R(1.0)/R(6.0))*(B_1_y*B_1_y) + (R(1.0)/R(6.0))*(B_1_z*B_1_z)
        + (R(1.0)/R(6.0))*(B_2_x*B_2_x) + (R(1.0)/R(6.0))*(B_2_y*B_2_y) + (R(1.0)/R(6.0))*(B_2_z*B_2_z)
        + (R(1.0)/R(6.0))*(B_3_x*B_3_x) + (R(1.0)/R(6.0))*(B_3_y*B_3_y) + (R(1.0)/R(6.0))*(B_3_z*B_3_z)
        + (R(1.0)/R(6.0))*(B_4_x*B_4_x) + (R(1.0)/R(6.0))*(B_4_y*B_4_y) + (R(1.0)/R(6.0))*(B_4_z*B_4_z)
        + (R(1.0)/R(6.0))*(B_5_x*B_5_x) + (R(1.0)/R(6.0))*(B_5_y*B_5_y) + (R(1.0)/R(6.0))*(B_5_z*B_5_z)
        + (R(1.0)/R(6.0))*(B_6_x*B_6_x) + (R(1.0)/R(6.0))*(B_6_y*B_6_y) + (R(1.0)/R(6.0))*(B_6_z*B_6_z);
    const pkmodes_real t13 = 1/t12;
    const pkmodes_real t14 = 1/((det_D_l*det_D_l));
    const pkmodes_real t15 = t12*t14;
    *determinant = det_D_l;
    *condition =
        R(sqrt)(((A_rx_1*A_rx_1)*t15 + (A_rx_2*A_rx_2)*t15 + (A_rx_3*A_rx_3)*t15 + (A_rx_4*A_rx_4)*t15
        + (A_rx_5*A_rx_5)*t15 + (A_rx_6*A_rx_6)*t15 + (A_ry_1*A_ry_1)*t15 + (A_ry_2*A_ry_2)*t15
        + (A_ry_3*A_ry_3)*t15 + (A_ry_4*A_ry_4)*t15 + (A_ry_5*A_ry_5)*t15 + (A_ry_6*A_ry_6)*t15
        + (A_rz_1*A_rz_1)*t15 + (A_rz_2*A_rz_2)*t15 + (A_rz_3*A_rz_3)*t15 + (A_rz_4*A_rz_4)*t15
        + (A_rz_5*A_rz_5)*t15 + (A_rz_6*A_rz_6)*t15 + (A_x_1*A_x_1)*t14 + (A_x_2*A_x_2)*t14
        + (A_x_3*A_x_3)*t14 + (A_x_4*A_x_4)*t14 + (A_x_5*A_x_5)*t14 + (A_x_6*A_x_6)*t14 + (A_y_1*A_y_1)*t14
        + (A_y_2*A_y_2)*t14 + (A_y_3*A_y_3)*t14 + (A_y_4*A_y_4)*t14 + (A_y_5*A_y_5)*t14 + (A_y_6*A_y_6)*t14
        + (A_z_1*A_z_1)*t14 + (A_z_2*A_z_2)*t14 + (A_z_3*A_z_3)*t14 + (A_z_4*A_z_4)*t14 + (A_z_5*A_z_5)*t14
        + (A_z_6*A_z_6)*t14)*((D_l_1_rx*D_l_1_rx)*t13 + (D_l_1_ry*D_l_1_ry)*t13 + (D_l_1_rz*D_l_1_rz)*t13
        + (D_l_2_rx*D_l_2_rx)*t13 + (D_l_2_ry*D_l_2_ry)*t13 + (D_l_2_rz*D_l_2_rz)*t13
        + (D_l_3_rx*D_l_3_rx)*t13 + (D_l_3_ry*D_l_3_ry)*t13 + (D_l_3_rz*D_l_3_rz)*t13
        + (D_l_4_rx*D_l_4_rx)*t13 + (D_l_4_ry*D_l_4_ry)*t13 + (D_l_4_rz*D_l_4_rz)*t13
        + (D_l_5_rx*D_l_5_rx)*t13 + (D_l_5_ry*D_l_5_ry)*t13 + (D_l_5_rz*D_l_5_rz)*t13
        + (D_l_6_rx*D_l_6_rx)*t13 + (D_l_6_ry*D_l_6_ry)*t13 + (D_l_6_rz*D_l_6_rz)*t13 + (s_1_x*s_1_x)
        + (s_1_y*s_1_y) + (s_1_z*s_1_z) + (s_2_x*s_2_x) + (s_2_y*s_2_y) + (s_2_z*s_2_z) + (s_3_x*s_3_x)
        + (s_3_y*s_3_y) + (s_3_z*s_3_z) + (s_4_x*s_4_x) + (s_4_y*s_4_y) + (s_4_z*s_4_z) + (s_5_x*s_5_x)
        + (s_5_y*s_5_y) + (s_5_z*s_5_z) + (s_6_x*s_6_x) + (s_6_y*s_6_y) + (s_6_z*s_6_z)));
}

void hexaglide_platform_jacobian(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real D_p[6][6])
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
    D_p[0][0] = D_p_x_1;
    D_p[0][1] = D_p_x_2;
    D_p[0][2] = D_p_x_3;
    D_p[0][3] = D_p_x_4;
    D_p[0][4] = D_p_x_5;
    D_p[0][5] = D_p_x_6;
    D_p[1][0] = D_p_y_1;
    D_p[1][1] = D_p_y_2;
    D_p[1][2] = D_p_y_3;
    D_p[1][3] = D_p_y_4;
    D_p[1][4] = D_p_y_5;
    D_p[1][5] = D_p_y_6;
    D_p[2][0] = D_p_z_1;
    D_p[2][1] = D_p_z_2;
    D_p[2][2] = D_p_z_3;
    D_p[2][3] = D_p_z_4;
    D_p[2][4] = D_p_z_5;
    D_p[2][5] = D_p_z_6;
    D_p[3][0] = D_p_rx_1;
    D_p[3][1] = D_p_rx_2;
    D_p[3][2] = D_p_rx_3;
    D_p[3][3] = D_p_rx_4;
    D_p[3][4] = D_p_rx_5;
    D_p[3][5] = D_p_rx_6;
    D_p[4][0] = D_p_ry_1;
    D_p[4][1] = D_p_ry_2;
    D_p[4][2] = D_p_ry_3;
    D_p[4][3] = D_p_ry_4;
    D_p[4][4] = D_p_ry_5;
    D_p[4][5] = D_p_ry_6;
    D_p[5][0] = D_p_rz_1;
    D_p[5][1] = D_p_rz_2;
    D_p[5][2] = D_p_rz_3;
    D_p[5][3] = D_p_rz_4;
    D_p[5][4] = D_p_rz_5;
    D_p[5][5] = D_p_rz_6;
}

void hexaglide_platform_jacobian_rate(const pkmodes_real p[6], const pkmodes_real x_dot[6],
    const hexaglide_parameters *parameters, pkmodes_real D_p_dot[6][6])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real x_1_dot = x_dot[0];
    const pkmodes_real x_2_dot = x_dot[1];
    const pkmodes_real x_3_dot = x_dot[2];
    const pkmodes_real x_4_dot = x_dot[3];
    const pkmodes_real x_5_dot = x_dot[4];
    const pkmodes_real x_6_dot = x_dot[5];
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
    const pkmodes_real t19 = B_1_y*D_p_rz_1 - B_1_z*D_p_ry_1;
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x - t19;
    const pkmodes_real t20 = B_1_y*D_p_rz_2;
    const pkmodes_real U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t20;
    const pkmodes_real t21 = B_1_y*D_p_rz_3;
    const pkmodes_real U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t21;
    const pkmodes_real t22 = B_1_y*D_p_rz_4;
    const pkmodes_real U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t22;
    const pkmodes_real t23 = B_1_y*D_p_rz_5;
    const pkmodes_real U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t23;
    const pkmodes_real t24 = B_1_y*D_p_rz_6;
    const pkmodes_real U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t24;
    const pkmodes_real t25 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y + t25;
    const pkmodes_real t26 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2;
    const pkmodes_real U_1_y_2 = D_p_y_2 + t26;
    const pkmodes_real t27 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3;
    const pkmodes_real U_1_y_3 = D_p_y_3 + t27;
    const pkmodes_real t28 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4;
    const pkmodes_real U_1_y_4 = D_p_y_4 + t28;
    const pkmodes_real t29 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5;
    const pkmodes_real U_1_y_5 = D_p_y_5 + t29;
    const pkmodes_real t30 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6;
    const pkmodes_real U_1_y_6 = D_p_y_6 + t30;
    const pkmodes_real t31 = B_1_x*D_p_ry_1 - B_1_y*D_p_rx_1;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z - t31;
    const pkmodes_real t32 = B_1_x*D_p_ry_2;
    const pkmodes_real U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t32;
    const pkmodes_real t33 = B_1_x*D_p_ry_3;
    const pkmodes_real U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t33;
    const pkmodes_real t34 = B_1_x*D_p_ry_4;
    const pkmodes_real U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t34;
    const pkmodes_real t35 = B_1_x*D_p_ry_5;
    const pkmodes_real U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t35;
    const pkmodes_real t36 = B_1_x*D_p_ry_6;
    const pkmodes_real U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t36;
    const pkmodes_real t37 = B_2_y*D_p_rz_1;
    const pkmodes_real U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t37;
    const pkmodes_real t38 = B_2_y*D_p_rz_2 - B_2_z*D_p_ry_2;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x - t38;
    const pkmodes_real t39 = B_2_y*D_p_rz_3;
    const pkmodes_real U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t39;
    const pkmodes_real t40 = B_2_y*D_p_rz_4;
    const pkmodes_real U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t40;
    const pkmodes_real t41 = B_2_y*D_p_rz_5;
    const pkmodes_real U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t41;
    const pkmodes_real t42 = B_2_y*D_p_rz_6;
    const pkmodes_real U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t42;
    const pkmodes_real t43 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1;
    const pkmodes_real U_2_y_1 = D_p_y_1 + t43;
    const pkmodes_real t44 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y + t44;
    const pkmodes_real t45 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3;
    const pkmodes_real U_2_y_3 = D_p_y_3 + t45;
    const pkmodes_real t46 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4;
    const pkmodes_real U_2_y_4 = D_p_y_4 + t46;
    const pkmodes_real t47 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5;
    const pkmodes_real U_2_y_5 = D_p_y_5 + t47;
    const pkmodes_real t48 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6;
    const pkmodes_real U_2_y_6 = D_p_y_6 + t48;
    const pkmodes_real t49 = B_2_x*D_p_ry_1;
    const pkmodes_real U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t49;
    const pkmodes_real t50 = B_2_x*D_p_ry_2 - B_2_y*D_p_rx_2;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z - t50;
    const pkmodes_real t51 = B_2_x*D_p_ry_3;
    const pkmodes_real U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t51;
    const pkmodes_real t52 = B_2_x*D_p_ry_4;
    const pkmodes_real U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t52;
    const pkmodes_real t53 = B_2_x*D_p_ry_5;
    const pkmodes_real U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t53;
    const pkmodes_real t54 = B_2_x*D_p_ry_6;
    const pkmodes_real U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t54;
    const pkmodes_real t55 = B_3_y*D_p_rz_1;
    const pkmodes_real U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t55;
    const pkmodes_real t56 = B_3_y*D_p_rz_2;
    const pkmodes_real U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t56;
    const pkmodes_real t57 = B_3_y*D_p_rz_3 - B_3_z*D_p_ry_3;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x - t57;
    const pkmodes_real t58 = B_3_y*D_p_rz_4;
    const pkmodes_real U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t58;
    const pkmodes_real t59 = B_3_y*D_p_rz_5;
    const pkmodes_real U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t59;
    const pkmodes_real t60 = B_3_y*D_p_rz_6;
    const pkmodes_real U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t60;
    const pkmodes_real t61 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1;
    const pkmodes_real U_3_y_1 = D_p_y_1 + t61;
    const pkmodes_real t62 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2;
    const pkmodes_real U_3_y_2 = D_p_y_2 + t62;
    const pkmodes_real t63 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y + t63;
    const pkmodes_real t64 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4;
    const pkmodes_real U_3_y_4 = D_p_y_4 + t64;
    const pkmodes_real t65 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5;
    const pkmodes_real U_3_y_5 = D_p_y_5 + t65;
    const pkmodes_real t66 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6;
    const pkmodes_real U_3_y_6 = D_p_y_6 + t66;
    const pkmodes_real t67 = B_3_x*D_p_ry_1;
    const pkmodes_real U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t67;
    const pkmodes_real t68 = B_3_x*D_p_ry_2;
    const pkmodes_real U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t68;
    const pkmodes_real t69 = B_3_x*D_p_ry_3 - B_3_y*D_p_rx_3;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z - t69;
    const pkmodes_real t70 = B_3_x*D_p_ry_4;
    const pkmodes_real U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t70;
    const pkmodes_real t71 = B_3_x*D_p_ry_5;
    const pkmodes_real U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t71;
    const pkmodes_real t72 = B_3_x*D_p_ry_6;
    const pkmodes_real U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t72;
    const pkmodes_real t73 = B_4_y*D_p_rz_1;
    const pkmodes_real U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t73;
    const pkmodes_real t74 = B_4_y*D_p_rz_2;
    const pkmodes_real U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t74;
    const pkmodes_real t75 = B_4_y*D_p_rz_3;
    const pkmodes_real U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t75;
    const pkmodes_real t76 = B_4_y*D_p_rz_4 - B_4_z*D_p_ry_4;
    const pkmodes_real U_4_x_4 = D_p_x_4 - n_4_x - t76;
    const pkmodes_real t77 = B_4_y*D_p_rz_5;
    const pkmodes_real U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t77;
    const pkmodes_real t78 = B_4_y*D_p_rz_6;
    const pkmodes_real U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t78;
    const pkmodes_real t79 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1;
    const pkmodes_real U_4_y_1 = D_p_y_1 + t79;
    const pkmodes_real t80 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2;
    const pkmodes_real U_4_y_2 = D_p_y_2 + t80;
    const pkmodes_real t81 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3;
    const pkmodes_real U_4_y_3 = D_p_y_3 + t81;
    const pkmodes_real t82 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4;
    const pkmodes_real U_4_y_4 = D_p_y_4 - n_4_y + t82;
    const pkmodes_real t83 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5;
    const pkmodes_real U_4_y_5 = D_p_y_5 + t83;
    const pkmodes_real t84 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6;
    const pkmodes_real U_4_y_6 = D_p_y_6 + t84;
    const pkmodes_real t85 = B_4_x*D_p_ry_1;
    const pkmodes_real U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t85;
    const pkmodes_real t86 = B_4_x*D_p_ry_2;
    const pkmodes_real U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t86;
    const pkmodes_real t87 = B_4_x*D_p_ry_3;
    const pkmodes_real U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t87;
    const pkmodes_real t88 = B_4_x*D_p_ry_4 - B_4_y*D_p_rx_4;
    const pkmodes_real U_4_z_4 = D_p_z_4 - n_4_z - t88;
    const pkmodes_real t89 = B_4_x*D_p_ry_5;
    const pkmodes_real U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t89;
    const pkmodes_real t90 = B_4_x*D_p_ry_6;
    const pkmodes_real U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t90;
    const pkmodes_real t91 = B_5_y*D_p_rz_1;
    const pkmodes_real U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t91;
    const pkmodes_real t92 = B_5_y*D_p_rz_2;
    const pkmodes_real U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t92;
    const pkmodes_real t93 = B_5_y*D_p_rz_3;
    const pkmodes_real U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t93;
    const pkmodes_real t94 = B_5_y*D_p_rz_4;
    const pkmodes_real U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t94;
    const pkmodes_real t95 = B_5_y*D_p_rz_5 - B_5_z*D_p_ry_5;
    const pkmodes_real U_5_x_5 = D_p_x_5 - n_5_x - t95;
    const pkmodes_real t96 = B_5_y*D_p_rz_6;
    const pkmodes_real U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t96;
    const pkmodes_real t97 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1;
    const pkmodes_real U_5_y_1 = D_p_y_1 + t97;
    const pkmodes_real t98 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2;
    const pkmodes_real U_5_y_2 = D_p_y_2 + t98;
    const pkmodes_real t99 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3;
    const pkmodes_real U_5_y_3 = D_p_y_3 + t99;
    const pkmodes_real t100 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4;
    const pkmodes_real U_5_y_4 = D_p_y_4 + t100;
    const pkmodes_real t101 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5;
    const pkmodes_real U_5_y_5 = D_p_y_5 - n_5_y + t101;
    const pkmodes_real t102 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6;
    const pkmodes_real U_5_y_6 = D_p_y_6 + t102;
    const pkmodes_real t103 = B_5_x*D_p_ry_1;
    const pkmodes_real U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t103;
    const pkmodes_real t104 = B_5_x*D_p_ry_2;
    const pkmodes_real U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t104;
    const pkmodes_real t105 = B_5_x*D_p_ry_3;
    const pkmodes_real U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t105;
    const pkmodes_real t106 = B_5_x*D_p_ry_4;
    const pkmodes_real U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t106;
    const pkmodes_real t107 = B_5_x*D_p_ry_5 - B_5_y*D_p_rx_5;
    const pkmodes_real U_5_z_5 = D_p_z_5 - n_5_z - t107;
    const pkmodes_real t108 = B_5_x*D_p_ry_6;
    const pkmodes_real U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t108;
    const pkmodes_real t109 = B_6_y*D_p_rz_1;
    const pkmodes_real U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t109;
    const pkmodes_real t110 = B_6_y*D_p_rz_2;
    const pkmodes_real U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t110;
    const pkmodes_real t111 = B_6_y*D_p_rz_3;
    const pkmodes_real U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t111;
    const pkmodes_real t112 = B_6_y*D_p_rz_4;
    const pkmodes_real U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t112;
    const pkmodes_real t113 = B_6_y*D_p_rz_5;
    const pkmodes_real U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t113;
    const pkmodes_real t114 = B_6_y*D_p_rz_6 - B_6_z*D_p_ry_6;
    const pkmodes_real U_6_x_6 = D_p_x_6 - n_6_x - t114;
    const pkmodes_real t115 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1;
    const pkmodes_real U_6_y_1 = D_p_y_1 + t115;
    const pkmodes_real t116 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2;
    const pkmodes_real U_6_y_2 = D_p_y_2 + t116;
    const pkmodes_real t117 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3;
    const pkmodes_real U_6_y_3 = D_p_y_3 + t117;
    const pkmodes_real t118 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4;
    const pkmodes_real U_6_y_4 = D_p_y_4 + t118;
    const pkmodes_real t119 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5;
    const pkmodes_real U_6_y_5 = D_p_y_5 + t119;
    const pkmodes_real t120 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6;
    const pkmodes_real U_6_y_6 = D_p_y_6 - n_6_y + t120;
    const pkmodes_real t121 = B_6_x*D_p_ry_1;
    const pkmodes_real U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t121;
    const pkmodes_real t122 = B_6_x*D_p_ry_2;
    const pkmodes_real U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t122;
    const pkmodes_real t123 = B_6_x*D_p_ry_3;
    const pkmodes_real U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t123;
    const pkmodes_real t124 = B_6_x*D_p_ry_4;
    const pkmodes_real U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t124;
    const pkmodes_real t125 = B_6_x*D_p_ry_5;
    const pkmodes_real U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t125;
    const pkmodes_real t126 = B_6_x*D_p_ry_6 - B_6_y*D_p_rx_6;
    const pkmodes_real U_6_z_6 = D_p_z_6 - n_6_z - t126;
    const pkmodes_real s_dot_1_x =
        U_1_x_1*x_1_dot + U_1_x_2*x_2_dot + U_1_x_3*x_3_dot + U_1_x_4*x_4_dot + U_1_x_5*x_5_dot
        + U_1_x_6*x_6_dot;
    const pkmodes_real s_dot_1_y =
        U_1_y_1*x_1_dot + U_1_y_2*x_2_dot + U_1_y_3*x_3_dot + U_1_y_4*x_4_dot + U_1_y_5*x_5_dot
        + U_1_y_6*x_6_dot;
    const pkmodes_real s_dot_1_z =
        U_1_z_1*x_1_dot + U_1_z_2*x_2_dot + U_1_z_3*x_3_dot + U_1_z_4*x_4_dot + U_1_z_5*x_5_dot
        + U_1_z_6*x_6_dot;
    const pkmodes_real s_dot_2_x =
        U_2_x_1*x_1_dot + U_2_x_2*x_2_dot + U_2_x_3*x_3_dot + U_2_x_4*x_4_dot + U_2_x_5*x_5_dot
        + U_2_x_6*x_6_dot;
    const pkmodes_real s_dot_2_y =
        U_2_y_1*x_1_dot + U_2_y_2*x_2_dot + U_2_y_3*x_3_dot + U_2_y_4*x_4_dot + U_2_y_5*x_5_dot
        + U_2_y_6*x_6_dot;
    const pkmodes_real s_dot_2_z =
        U_2_z_1*x_1_dot + U_2_z_2*x_2_dot + U_2_z_3*x_3_dot + U_2_z_4*x_4_dot + U_2_z_5*x_5_dot
        + U_2_z_6*x_6_dot;
    const pkmodes_real s_dot_3_x =
        U_3_x_1*x_1_dot + U_3_x_2*x_2_dot + U_3_x_3*x_3_dot + U_3_x_4*x_4_dot + U_3_x_5*x_5_dot
        + U_3_x_6*x_6_dot;
    const pkmodes_real s_dot_3_y =
        U_3_y_1*x_1_dot + U_3_y_2*x_2_dot + U_3_y_3*x_3_dot + U_3_y_4*x_4_dot + U_3_y_5*x_5_dot
        + U_3_y_6*x_6_dot;
    const pkmodes_real s_dot_3_z =
        U_3_z_1*x_1_dot + U_3_z_2*x_2_dot + U_3_z_3*x_3_dot + U_3_z_4*x_4_dot + U_3_z_5*x_5_dot
        + U_3_z_6*x_6_dot;
    const pkmodes_real s_dot_4_x =
        U_4_x_1*x_1_dot + U_4_x_2*x_2_dot + U_4_x_3*x_3_dot + U_4_x_4*x_4_dot + U_4_x_5*x_5_dot
        + U_4_x_6*x_6_dot;
    const pkmodes_real s_dot_4_y =
        U_4_y_1*x_1_dot + U_4_y_2*x_2_dot + U_4_y_3*x_3_dot + U_4_y_4*x_4_dot + U_4_y_5*x_5_dot
        + U_4_y_6*x_6_dot;
    const pkmodes_real s_dot_4_z =
        U_4_z_1*x_1_dot + U_4_z_2*x_2_dot + U_4_z_3*x_3_dot + U_4_z_4*x_4_dot + U_4_z_5*x_5_dot
        + U_4_z_6*x_6_dot;
    const pkmodes_real s_dot_5_x =
        U_5_x_1*x_1_dot + U_5_x_2*x_2_dot + U_5_x_3*x_3_dot + U_5_x_4*x_4_dot + U_5_x_5*x_5_dot
        + U_5_x_6*x_6_dot;
    const pkmodes_real s_dot_5_y =
        U_5_y_1*x_1_dot + U_5_y_2*x_2_dot + U_5_y_3*x_3_dot + U_5_y_4*x_4_dot + U_5_y_5*x_5_dot
        + U_5_y_6*x_6_dot;
    const pkmodes_real s_dot_5_z =
        U_5_z_1*x_1_dot + U_5_z_2*x_2_dot + U_5_z_3*x_3_dot + U_5_z_4*x_4_dot + U_5_z_5*x_5_dot
        + U_5_z_6*x_6_dot;
    const pkmodes_real s_dot_6_x =
        U_6_x_1*x_1_dot + U_6_x_2*x_2_dot + U_6_x_3*x_3_dot + U_6_x_4*x_4_dot + U_6_x_5*x_5_dot
        + U_6_x_6*x_6_dot;
    const pkmodes_real s_dot_6_y =
        U_6_y_1*x_1_dot + U_6_y_2*x_2_dot + U_6_y_3*x_3_dot + U_6_y_4*x_4_dot + U_6_y_5*x_5_dot
        + U_6_y_6*x_6_dot;
    const pkmodes_real s_dot_6_z =
        U_6_z_1*x_1_dot + U_6_z_2*x_2_dot + U_6_z_3*x_3_dot + U_6_z_4*x_4_dot + U_6_z_5*x_5_dot
        + U_6_z_6*x_6_dot;
    const pkmodes_real t127 = B_1_y*D_p_rx_2 - t32;
    const pkmodes_real t128 = B_1_y*D_p_rx_3 - t33;
    const pkmodes_real t129 = B_1_y*D_p_rx_4 - t34;
    const pkmodes_real t130 = B_1_y*D_p_rx_5 - t35;
    const pkmodes_real t131 = B_1_y*D_p_rx_6 - t36;
    const pkmodes_real D_l_dot_1_rx =
        x_1_dot*(B_1_y*U_1_z_1 - B_1_z*U_1_y_1 + s_1_y*t31 + s_1_z*t25) + x_2_dot*(B_1_y*U_1_z_2
        - B_1_z*U_1_y_2 - s_1_y*t127 + s_1_z*t26) + x_3_dot*(B_1_y*U_1_z_3 - B_1_z*U_1_y_3 - s_1_y*t128
        + s_1_z*t27) + x_4_dot*(B_1_y*U_1_z_4 - B_1_z*U_1_y_4 - s_1_y*t129 + s_1_z*t28)
        + x_5_dot*(B_1_y*U_1_z_5 - B_1_z*U_1_y_5 - s_1_y*t130 + s_1_z*t29) + x_6_dot*(B_1_y*U_1_z_6
        - B_1_z*U_1_y_6 - s_1_y*t131 + s_1_z*t30);
    const pkmodes_real t132 = B_1_z*D_p_ry_2 - t20;
    const pkmodes_real t133 = B_1_z*D_p_ry_3 - t21;
    const pkmodes_real t134 = B_1_z*D_p_ry_4 - t22;
    const pkmodes_real t135 = B_1_z*D_p_ry_5 - t23;
    const pkmodes_real t136 = B_1_z*D_p_ry_6 - t24;
    const pkmodes_real D_l_dot_1_ry =
        x_1_dot*(-B_1_x*U_1_z_1 + B_1_z*U_1_x_1 - s_1_x*t31 + s_1_z*t19) + x_2_dot*(-B_1_x*U_1_z_2
        + B_1_z*U_1_x_2 + s_1_x*t127 - s_1_z*t132) + x_3_dot*(-B_1_x*U_1_z_3 + B_1_z*U_1_x_3 + s_1_x*t128
        - s_1_z*t133) + x_4_dot*(-B_1_x*U_1_z_4 + B_1_z*U_1_x_4 + s_1_x*t129 - s_1_z*t134)
        + x_5_dot*(-B_1_x*U_1_z_5 + B_1_z*U_1_x_5 + s_1_x*t130 - s_1_z*t135) + x_6_dot*(-B_1_x*U_1_z_6
        + B_1_z*U_1_x_6 + s_1_x*t131 - s_1_z*t136);
    const pkmodes_real D_l_dot_1_rz =
        x_1_dot*(B_1_x*U_1_y_1 - B_1_y*U_1_x_1 - s_1_x*t25 - s_1_y*t19) + x_2_dot*(B_1_x*U_1_y_2
        - B_1_y*U_1_x_2 - s_1_x*t26 + s_1_y*t132) + x_3_dot*(B_1_x*U_1_y_3 - B_1_y*U_1_x_3 - s_1_x*t27
        + s_1_y*t133) + x_4_dot*(B_1_x*U_1_y_4 - B_1_y*U_1_x_4 - s_1_x*t28 + s_1_y*t134)
        + x_5_dot*(B_1_x*U_1_y_5 - B_1_y*U_1_x_5 - s_1_x*t29 + s_1_y*t135) + x_6_dot*(B_1_x*U_1_y_6
        - B_1_y*U_1_x_6 - s_1_x*t30 + s_1_y*t136);
    const pkmodes_real t137 = B_2_y*D_p_rx_1 - t49;
    const pkmodes_real t138 = B_2_y*D_p_rx_3 - t51;
    const pkmodes_real t139 = B_2_y*D_p_rx_4 - t52;
    const pkmodes_real t140 = B_2_y*D_p_rx_5 - t53;
    const pkmodes_real t141 = B_2_y*D_p_rx_6 - t54;
    const pkmodes_real D_l_dot_2_rx =
        x_1_dot*(B_2_y*U_2_z_1 - B_2_z*U_2_y_1 - s_2_y*t137 + s_2_z*t43) + x_2_dot*(B_2_y*U_2_z_2
        - B_2_z*U_2_y_2 + s_2_y*t50 + s_2_z*t44) + x_3_dot*(B_2_y*U_2_z_3 - B_2_z*U_2_y_3 - s_2_y*t138
        + s_2_z*t45) + x_4_dot*(B_2_y*U_2_z_4 - B_2_z*U_2_y_4 - s_2_y*t139 + s_2_z*t46)
        + x_5_dot*(B_2_y*U_2_z_5 - B_2_z*U_2_y_5 - s_2_y*t140 + s_2_z*t47) + x_6_dot*(B_2_y*U_2_z_6
        - B_2_z*U_2_y_6 - s_2_y*t141 + s_2_z*t48);
    const pkmodes_real t142 = B_2_z*D_p_ry_1 - t37;
    const pkmodes_real t143 = B_2_z*D_p_ry_3 - t39;
    const pkmodes_real t144 = B_2_z*D_p_ry_4 - t40;
    const pkmodes_real t145 = B_2_z*D_p_ry_5 - t41;
    const pkmodes_real t146 = B_2_z*D_p_ry_6 - t42;
    const pkmodes_real D_l_dot_2_ry =
        x_1_dot*(-B_2_x*U_2_z_1 + B_2_z*U_2_x_1 + s_2_x*t137 - s_2_z*t142) + x_2_dot*(-B_2_x*U_2_z_2
        + B_2_z*U_2_x_2 - s_2_x*t50 + s_2_z*t38) + x_3_dot*(-B_2_x*U_2_z_3 + B_2_z*U_2_x_3 + s_2_x*t138
        - s_2_z*t143) + x_4_dot*(-B_2_x*U_2_z_4 + B_2_z*U_2_x_4 + s_2_x*t139 - s_2_z*t144)
        + x_5_dot*(-B_2_x*U_2_z_5 + B_2_z*U_2_x_5 + s_2_x*t140 - s_2_z*t145) + x_6_dot*(-B_2_x*U_2_z_6
        + B_2_z*U_2_x_6 + s_2_x*t141 - s_2_z*t146);
    const pkmodes_real D_l_dot_2_rz =
        x_1_dot*(B_2_x*U_2_y_1 - B_2_y*U_2_x_1 - s_2_x*t43 + s_2_y*t142) + x_2_dot*(B_2_x*U_2_y_2
        - B_2_y*U_2_x_2 - s_2_x*t44 - s_2_y*t38) + x_3_dot*(B_2_x*U_2_y_3 - B_2_y*U_2_x_3 - s_2_x*t45
        + s_2_y*t143) + x_4_dot*(B_2_x*U_2_y_4 - B_2_y*U_2_x_4 - s_2_x*t46 + s_2_y*t144)
        + x_5_dot*(B_2_x*U_2_y_5 - B_2_y*U_2_x_5 - s_2_x*t47 + s_2_y*t145) + x_6_dot*(B_2_x*U_2_y_6
        - B_2_y*U_2_x_6 - s_2_x*t48 + s_2_y*t146);
    const pkmodes_real t147 = B_3_y*D_p_rx_1 - t67;
    const pkmodes_real t148 = B_3_y*D_p_rx_2 - t68;
    const pkmodes_real t149 = B_3_y*D_p_rx_4 - t70;
    const pkmodes_real t150 = B_3_y*D_p_rx_5 - t71;
    const pkmodes_real t151 = B_3_y*D_p_rx_6 - t72;
    const pkmodes_real D_l_dot_3_rx =
        x_1_dot*(B_3_y*U_3_z_1 - B_3_z*U_3_y_1 - s_3_y*t147 + s_3_z*t61) + x_2_dot*(B_3_y*U_3_z_2
        - B_3_z*U_3_y_2 - s_3_y*t148 + s_3_z*t62) + x_3_dot*(B_3_y*U_3_z_3 - B_3_z*U_3_y_3 + s_3_y*t69
        + s_3_z*t63) + x_4_dot*(B_3_y*U_3_z_4 - B_3_z*U_3_y_4 - s_3_y*t149 + s_3_z*t64)
        + x_5_dot*(B_3_y*U_3_z_5 - B_3_z*U_3_y_5 - s_3_y*t150 + s_3_z*t65) + x_6_dot*(B_3_y*U_3_z_6
        - B_3_z*U_3_y_6 - s_3_y*t151 + s_3_z*t66);
    const pkmodes_real t152 = B_3_z*D_p_ry_1 - t55;
    const pkmodes_real t153 = B_3_z*D_p_ry_2 - t56;
    const pkmodes_real t154 = B_3_z*D_p_ry_4 - t58;
    const pkmodes_real t155 = B_3_z*D_p_ry_5 - t59;
    const pkmodes_real t156 = B_3_z*D_p_ry_6 - t60;
    const pkmodes_real D_l_dot_3_ry =
        x_1_dot*(-B_3_x*U_3_z_1 + B_3_z*U_3_x_1 + s_3_x*t147 - s_3_z*t152) + x_2_dot*(-B_3_x*U_3_z_2
        + B_3_z*U_3_x_2 + s_3_x*t148 - s_3_z*t153) + x_3_dot*(-B_3_x*U_3_z_3 + B_3_z*U_3_x_3 - s_3_x*t69
        + s_3_z*t57) + x_4_dot*(-B_3_x*U_3_z_4 + B_3_z*U_3_x_4 + s_3_x*t149 - s_3_z*t154)
        + x_5_dot*(-B_3_x*U_3_z_5 + B_3_z*U_3_x_5 + s_3_x*t150 - s_3_z*t155) + x_6_dot*(-B_3_x*U_3_z_6
        + B_3_z*U_3_x_6 + s_3_x*t151 - s_3_z*t156);
    const pkmodes_real D_l_dot_3_rz =
        x_1_dot*(B_3_x*U_3_y_1 - B_3_y*U_3_x_1 - s_3_x*t61 + s_3_y*t152) + x_2_dot*(B_3_x*U_3_y_2
        - B_3_y*U_3_x_2 - s_3_x*t62 + s_3_y*t153) + x_3_dot*(B_3_x*U_3_y_3 - B_3_y*U_3_x_3 - s_3_x*t63
        - s_3_y*t57) + x_4_dot*(B_3_x*U_3_y_4 - B_3_y*U_3_x_4 - s_3_x*t64 + s_3_y*t154)
        + x_5_dot*(B_3_x*U_3_y_5 - B_3_y*U_3_x_5 - s_3_x*t65 + s_3_y*t155) + x_6_dot*(B_3_x*U_3_y_6
        - B_3_y*U_3_x_6 - s_3_x*t66 + s_3_y*t156);
    const pkmodes_real t157 = B_4_y*D_p_rx_1 - t85;
    const pkmodes_real t158 = B_4_y*D_p_rx_2 - t86;
    const pkmodes_real t159 = B_4_y*D_p_rx_3 - t87;
    const pkmodes_real t160 = B_4_y*D_p_rx_5 - t89;
    const pkmodes_real t161 = B_4_y*D_p_rx_6 - t90;
    const pkmodes_real D_l_dot_4_rx =
        x_1_dot*(B_4_y*U_4_z_1 - B_4_z*U_4_y_1 - s_4_y*t157 + s_4_z*t79) + x_2_dot*(B_4_y*U_4_z_2
        - B_4_z*U_4_y_2 - s_4_y*t158 + s_4_z*t80) + x_3_dot*(B_4_y*U_4_z_3 - B_4_z*U_4_y_3 - s_4_y*t159
        + s_4_z*t81) + x_4_dot*(B_4_y*U_4_z_4 - B_4_z*U_4_y_4 + s_4_y*t88 + s_4_z*t82)
        + x_5_dot*(B_4_y*U_4_z_5 - B_4_z*U_4_y_5 - s_4_y*t160 + s_4_z*t83) + x_6_dot*(B_4_y*U_4_z_6
        - B_4_z*U_4_y_6 - s_4_y*t161 + s_4_z*t84);
    const pkmodes_real t162 = B_4_z*D_p_ry_1 - t73;
    const pkmodes_real t163 = B_4_z*D_p_ry_2 - t74;
    const pkmodes_real t164 = B_4_z*D_p_ry_3 - t75;
    const pkmodes_real t165 = B_4_z*D_p_ry_5 - t77;
    const pkmodes_real t166 = B_4_z*D_p_ry_6 - t78;
    const pkmodes_real D_l_dot_4_ry =
        x_1_dot*(-B_4_x*U_4_z_1 + B_4_z*U_4_x_1 + s_4_x*t157 - s_4_z*t162) + x_2_dot*(-B_4_x*U_4_z_2
        + B_4_z*U_4_x_2 + s_4_x*t158 - s_4_z*t163) + x_3_dot*(-B_4_x*U_4_z_3 + B_4_z*U_4_x_3 + s_4_x*t159
        - s_4_z*t164) + x_4_dot*(-B_4_x*U_4_z_4 + B_4_z*U_4_x_4 - s_4_x*t88 + s_4_z*t76)
        + x_5_dot*(-B_4_x*U_4_z_5 + B_4_z*U_4_x_5 + s_4_x*t160 - s_4_z*t165) + x_6_dot*(-B_4_x*U_4_z_6
        + B_4_z*U_4_x_6 + s_4_x*t161 - s_4_z*t166);
    const pkmodes_real D_l_dot_4_rz =
        x_1_dot*(B_4_x*U_4_y_1 - B_4_y*U_4_x_1 - s_4_x*t79 + s_4_y*t162) + x_2_dot*(B_4_x*U_4_y_2
        - B_4_y*U_4_x_2 - s_4_x*t80 + s_4_y*t163) + x_3_dot*(B_4_x*U_4_y_3 - B_4_y*U_4_x_3 - s_4_x*t81
        + s_4_y*t164) + x_4_dot*(B_4_x*U_4_y_4 - B_4_y*U_4_x_4 - s_4_x*t82 - s_4_y*t76)
        + x_5_dot*(B_4_x*U_4_y_5 - B_4_y*U_4_x_5 - s_4_x*t83 + s_4_y*t165) + x_6_dot*(B_4_x*U_4_y_6
        - B_4_y*U_4_x_6 - s_4_x*t84 + s_4_y*t166);
    const pkmodes_real t167 = B_5_y*D_p_rx_1 - t103;
    const pkmodes_real t168 = B_5_y*D_p_rx_2 - t104;
    const pkmodes_real t169 = B_5_y*D_p_rx_3 - t105;
    const pkmodes_real t170 = B_5_y*D_p_rx_4 - t106;
    const pkmodes_real t171 = B_5_y*D_p_rx_6 - t108;
    const pkmodes_real D_l_dot_5_rx =
        x_1_dot*(B_5_y*U_5_z_1 - B_5_z*U_5_y_1 - s_5_y*t167 + s_5_z*t97) + x_2_dot*(B_5_y*U_5_z_2
        - B_5_z*U_5_y_2 - s_5_y*t168 + s_5_z*t98) + x_3_dot*(B_5_y*U_5_z_3 - B_5_z*U_5_y_3 - s_5_y*t169
        + s_5_z*t99) + x_4_dot*(B_5_y*U_5_z_4 - B_5_z*U_5_y_4 - s_5_y*t170 + s_5_z*t100)
        + x_5_dot*(B_5_y*U_5_z_5 - B_5_z*U_5_y_5 + s_5_y*t107 + s_5_z*t101) + x_6_dot*(B_5_y*U_5_z_6
        - B_5_z*U_5_y_6 - s_5_y*t171 + s_5_z*t102);
    const pkmodes_real t172 = B_5_z*D_p_ry_1 - t91;
    const pkmodes_real t173 = B_5_z*D_p_ry_2 - t92;
    const pkmodes_real t174 = B_5_z*D_p_ry_3 - t93;
    const pkmodes_real t175 = B_5_z*D_p_ry_4 - t94;
    const pkmodes_real t176 = B_5_z*D_p_ry_6 - t96;
    const pkmodes_real D_l_dot_5_ry =
        x_1_dot*(-B_5_x*U_5_z_1 + B_5_z*U_5_x_1 + s_5_x*t167 - s_5_z*t172) + x_2_dot*(-B_5_x*U_5_z_2
        + B_5_z*U_5_x_2 + s_5_x*t168 - s_5_z*t173) + x_3_dot*(-B_5_x*U_5_z_3 + B_5_z*U_5_x_3 + s_5_x*t169
        - s_5_z*t174) + x_4_dot*(-B_5_x*U_5_z_4 + B_5_z*U_5_x_4 + s_5_x*t170 - s_5_z*t175)
        + x_5_dot*(-B_5_x*U_5_z_5 + B_5_z*U_5_x_5 - s_5_x*t107 + s_5_z*t95) + x_6_dot*(-B_5_x*U_5_z_6
        + B_5_z*U_5_x_6 + s_5_x*t171 - s_5_z*t176);
    const pkmodes_real D_l_dot_5_rz =
        x_1_dot*(B_5_x*U_5_y_1 - B_5_y*U_5_x_1 - s_5_x*t97 + s_5_y*t172) + x_2_dot*(B_5_x*U_5_y_2
        - B_5_y*U_5_x_2 - s_5_x*t98 + s_5_y*t173) + x_3_dot*(B_5_x*U_5_y_3 - B_5_y*U_5_x_3 - s_5_x*t99
        + s_5_y*t174) + x_4_dot*(B_5_x*U_5_y_4 - B_5_y*U_5_x_4 - s_5_x*t100 + s_5_y*t175)
        + x_5_dot*(B_5_x*U_5_y_5 - B_5_y*U_5_x_5 - s_5_x*t101 - s_5_y*t95) + x_6_dot*(B_5_x*U_5_y_6
        - B_5_y*U_5_x_6 - s_5_x*t102 + s_5_y*t176);
    const pkmodes_real t177 = B_6_y*D_p_rx_1 - t121;
    const pkmodes_real t178 = B_6_y*D_p_rx_2 - t122;
    const pkmodes_real t179 = B_6_y*D_p_rx_3 - t123;
    const pkmodes_real t180 = B_6_y*D_p_rx_4 - t124;
    const pkmodes_real t181 = B_6_y*D_p_rx_5 - t125;
    const pkmodes_real D_l_dot_6_rx =
        x_1_dot*(B_6_y*U_6_z_1 - B_6_z*U_6_y_1 - s_6_y*t177 + s_6_z*t115) + x_2_dot*(B_6_y*U_6_z_2
        - B_6_z*U_6_y_2 - s_6_y*t178 + s_6_z*t116) + x_3_dot*(B_6_y*U_6_z_3 - B_6_z*U_6_y_3 - s_6_y*t179
        + s_6_z*t117) + x_4_dot*(B_6_y*U_6_z_4 - B_6_z*U_6_y_4 - s_6_y*t180 + s_6_z*t118)
        + x_5_dot*(B_6_y*U_6_z_5 - B_6_z*U_6_y_5 - s_6_y*t181 + s_6_z*t119) + x_6_dot*(B_6_y*U_6_z_6
        - B_6_z*U_6_y_6 + s_6_y*t126 + s_6_z*t120);
    const pkmodes_real t182 = B_6_z*D_p_ry_1 - t109;
    const pkmodes_real t183 = B_6_z*D_p_ry_2 - t110;
    const pkmodes_real t184 = B_6_z*D_p_ry_3 - t111;
    const pkmodes_real t185 = B_6_z*D_p_ry_4 - t112;
    const pkmodes_real t186 = B_6_z*D_p_ry_5 - t113;
    const pkmodes_real D_l_dot_6_ry =
        x_1_dot*(-B_6_x*U_6_z_1 + B_6_z*U_6_x_1 + s_6_x*t177 - s_6_z*t182) + x_2_dot*(-B_6_x*U_6_z_2
        + B_6_z*U_6_x_2 + s_6_x*t178 - s_6_z*t183) + x_3_dot*(-B_6_x*U_6_z_3 + B_6_z*U_6_x_3 + s_6_x*t179
        - s_6_z*t184) + x_4_dot*(-B_6_x*U_6_z_4 + B_6_z*U_6_x_4 + s_6_x*t180 - s_6_z*t185)
        + x_5_dot*(-B_6_x*U_6_z_5 + B_6_z*U_6_x_5 + s_6_x*t181 - s_6_z*t186) + x_6_dot*(-B_6_x*U_6_z_6
        + B_6_z*U_6_x_6 - s_6_x*t126 + s_6_z*t114);
    const pkmodes_real D_l_dot_6_rz =
        x_1_dot*(B_6_x*U_6_y_1 - B_6_y*U_6_x_1 - s_6_x*t115 + s_6_y*t182) + x_2_dot*(B_6_x*U_6_y_2
        - B_6_y*U_6_x_2 - s_6_x*t116 + s_6_y*t183) + x_3_dot*(B_6_x*U_6_y_3 - B_6_y*U_6_x_3 - s_6_x*t117
        + s_6_y*t184) + x_4_dot*(B_6_x*U_6_y_4 - B_6_y*U_6_x_4 - s_6_x*t118 + s_6_y*t185)
        + x_5_dot*(B_6_x*U_6_y_5 - B_6_y*U_6_x_5 - s_6_x*t119 + s_6_y*t186) + x_6_dot*(B_6_x*U_6_y_6
        - B_6_y*U_6_x_6 - s_6_x*t120 - s_6_y*t114);
    const pkmodes_real t187 =
        -D_l_dot_2_rx*D_p_rx_1 - D_l_dot_2_ry*D_p_ry_1 - D_l_dot_2_rz*D_p_rz_1 - D_p_x_1*s_dot_2_x
        - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t188 =
        -D_l_dot_3_rx*D_p_rx_1 - D_l_dot_3_ry*D_p_ry_1 - D_l_dot_3_rz*D_p_rz_1 - D_p_x_1*s_dot_3_x
        - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t189 =
        -D_l_dot_4_rx*D_p_rx_1 - D_l_dot_4_ry*D_p_ry_1 - D_l_dot_4_rz*D_p_rz_1 - D_p_x_1*s_dot_4_x
        - D_p_y_1*s_dot_4_y - D_p_z_1*s_dot_4_z;
    const pkmodes_real t190 =
        -D_l_dot_5_rx*D_p_rx_1 - D_l_dot_5_ry*D_p_ry_1 - D_l_dot_5_rz*D_p_rz_1 - D_p_x_1*s_dot_5_x
        - D_p_y_1*s_dot_5_y - D_p_z_1*s_dot_5_z;
    const pkmodes_real t191 =
        -D_l_dot_6_rx*D_p_rx_1 - D_l_dot_6_ry*D_p_ry_1 - D_l_dot_6_rz*D_p_rz_1 - D_p_x_1*s_dot_6_x
        - D_p_y_1*s_dot_6_y - D_p_z_1*s_dot_6_z;
    const pkmodes_real t192 =
        -D_l_dot_1_rx*D_p_rx_1 - D_l_dot_1_ry*D_p_ry_1 - D_l_dot_1_rz*D_p_rz_1 - D_p_x_1*s_dot_1_x
        - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y + n_1_z*s_dot_1_z;
    const pkmodes_real D_p_dot_x_1 =
        t12*(A_x_1*t192 + A_x_2*t187 + A_x_3*t188 + A_x_4*t189 + A_x_5*t190 + A_x_6*t191);
    const pkmodes_real D_p_dot_y_1 =
        t12*(A_y_1*t192 + A_y_2*t187 + A_y_3*t188 + A_y_4*t189 + A_y_5*t190 + A_y_6*t191);
    const pkmodes_real D_p_dot_z_1 =
        t12*(A_z_1*t192 + A_z_2*t187 + A_z_3*t188 + A_z_4*t189 + A_z_5*t190 + A_z_6*t191);
    const pkmodes_real D_p_dot_rx_1 =
        t12*(A_rx_1*t192 + A_rx_2*t187 + A_rx_3*t188 + A_rx_4*t189 + A_rx_5*t190 + A_rx_6*t191);
    const pkmodes_real D_p_dot_ry_1 =
        t12*(A_ry_1*t192 + A_ry_2*t187 + A_ry_3*t188 + A_ry_4*t189 + A_ry_5*t190 + A_ry_6*t191);
    const pkmodes_real D_p_dot_rz_1 =
        t12*(A_rz_1*t192 + A_rz_2*t187 + A_rz_3*t188 + A_rz_4*t189 + A_rz_5*t190 + A_rz_6*t191);
    const pkmodes_real t193 =
        -D_l_dot_1_rx*D_p_rx_2 - D_l_dot_1_ry*D_p_ry_2 - D_l_dot_1_rz*D_p_rz_2 - D_p_x_2*s_dot_1_x
        - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t194 =
        -D_l_dot_3_rx*D_p_rx_2 - D_l_dot_3_ry*D_p_ry_2 - D_l_dot_3_rz*D_p_rz_2 - D_p_x_2*s_dot_3_x
        - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t195 =
        -D_l_dot_4_rx*D_p_rx_2 - D_l_dot_4_ry*D_p_ry_2 - D_l_dot_4_rz*D_p_rz_2 - D_p_x_2*s_dot_4_x
        - D_p_y_2*s_dot_4_y - D_p_z_2*s_dot_4_z;
    const pkmodes_real t196 =
        -D_l_dot_5_rx*D_p_rx_2 - D_l_dot_5_ry*D_p_ry_2 - D_l_dot_5_rz*D_p_rz_2 - D_p_x_2*s_dot_5_x
        - D_p_y_2*s_dot_5_y - D_p_z_2*s_dot_5_z;
    const pkmodes_real t197 =
        -D_l_dot_6_rx*D_p_rx_2 - D_l_dot_6_ry*D_p_ry_2 - D_l_dot_6_rz*D_p_rz_2 - D_p_x_2*s_dot_6_x
        - D_p_y_2*s_dot_6_y - D_p_z_2*s_dot_6_z;
    const pkmodes_real t198 =
        -D_l_dot_2_rx*D_p_rx_2 - D_l_dot_2_ry*D_p_ry_2 - D_l_dot_2_rz*D_p_rz_2 - D_p_x_2*s_dot_2_x
        - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y + n_2_z*s_dot_2_z;
    const pkmodes_real D_p_dot_x_2 =
        t12*(A_x_1*t193 + A_x_2*t198 + A_x_3*t194 + A_x_4*t195 + A_x_5*t196 + A_x_6*t197);
    const pkmodes_real D_p_dot_y_2 =
        t12*(A_y_1*t193 + A_y_2*t198 + A_y_3*t194 + A_y_4*t195 + A_y_5*t196 + A_y_6*t197);
    const pkmodes_real D_p_dot_z_2 =
        t12*(A_z_1*t193 + A_z_2*t198 + A_z_3*t194 + A_z_4*t195 + A_z_5*t196 + A_z_6*t197);
    const pkmodes_real D_p_dot_rx_2 =
        t12*(A_rx_1*t193 + A_rx_2*t198 + A_rx_3*t194 + A_rx_4*t195 + A_rx_5*t196 + A_rx_6*t197);
    const pkmodes_real D_p_dot_ry_2 =
        t12*(A_ry_1*t193 + A_ry_2*t198 + A_ry_3*t194 + A_ry_4*t195 + A_ry_5*t196 + A_ry_6*t197);
    const pkmodes_real D_p_dot_rz_2 =
        t12*(A_rz_1*t193 + A_rz_2*t198 + A_rz_3*t194 + A_rz_4*t195 + A_rz_5*t196 + A_rz_6*t197);
    const pkmodes_real t199 =
        -D_l_dot_1_rx*D_p_rx_3 - D_l_dot_1_ry*D_p_ry_3 - D_l_dot_1_rz*D_p_rz_3 - D_p_x_3*s_dot_1_x
        - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t200 =
        -D_l_dot_2_rx*D_p_rx_3 - D_l_dot_2_ry*D_p_ry_3 - D_l_dot_2_rz*D_p_rz_3 - D_p_x_3*s_dot_2_x
        - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t201 =
        -D_l_dot_4_rx*D_p_rx_3 - D_l_dot_4_ry*D_p_ry_3 - D_l_dot_4_rz*D_p_rz_3 - D_p_x_3*s_dot_4_x
        - D_p_y_3*s_dot_4_y - D_p_z_3*s_dot_4_z;
    const pkmodes_real t202 =
        -D_l_dot_5_rx*D_p_rx_3 - D_l_dot_5_ry*D_p_ry_3 - D_l_dot_5_rz*D_p_rz_3 - D_p_x_3*s_dot_5_x
        - D_p_y_3*s_dot_5_y - D_p_z_3*s_dot_5_z;
    const pkmodes_real t203 =
        -D_l_dot_6_rx*D_p_rx_3 - D_l_dot_6_ry*D_p_ry_3 - D_l_dot_6_rz*D_p_rz_3 - D_p_x_3*s_dot_6_x
        - D_p_y_3*s_dot_6_y - D_p_z_3*s_dot_6_z;
    const pkmodes_real t204 =
        -D_l_dot_3_rx*D_p_rx_3 - D_l_dot_3_ry*D_p_ry_3 - D_l_dot_3_rz*D_p_rz_3 - D_p_x_3*s_dot_3_x
        - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y + n_3_z*s_dot_3_z;
    const pkmodes_real D_p_dot_x_3 =
        t12*(A_x_1*t199 + A_x_2*t200 + A_x_3*t204 + A_x_4*t201 + A_x_5*t202 + A_x_6*t203);
    const pkmodes_real D_p_dot_y_3 =
        t12*(A_y_1*t199 + A_y_2*t200 + A_y_3*t204 + A_y_4*t201 + A_y_5*t202 + A_y_6*t203);
    const pkmodes_real D_p_dot_z_3 =
        t12*(A_z_1*t199 + A_z_2*t200 + A_z_3*t204 + A_z_4*t201 + A_z_5*t202 + A_z_6*t203);
    const pkmodes_real D_p_dot_rx_3 =
        t12*(A_rx_1*t199 + A_rx_2*t200 + A_rx_3*t204 + A_rx_4*t201 + A_rx_5*t202 + A_rx_6*t203);
    const pkmodes_real D_p_dot_ry_3 =
        t12*(A_ry_1*t199 + A_ry_2*t200 + A_ry_3*t204 + A_ry_4*t201 + A_ry_5*t202 + A_ry_6*t203);
    const pkmodes_real D_p_dot_rz_3 =
        t12*(A_rz_1*t199 + A_rz_2*t200 + A_rz_3*t204 + A_rz_4*t201 + A_rz_5*t202 + A_rz_6*t203);
    const pkmodes_real t205 =
        -D_l_dot_1_rx*D_p_rx_4 - D_l_dot_1_ry*D_p_ry_4 - D_l_dot_1_rz*D_p_rz_4 - D_p_x_4*s_dot_1_x
        - D_p_y_4*s_dot_1_y - D_p_z_4*s_dot_1_z;
    const pkmodes_real t206 =
        -D_l_dot_2_rx*D_p_rx_4 - D_l_dot_2_ry*D_p_ry_4 - D_l_dot_2_rz*D_p_rz_4 - D_p_x_4*s_dot_2_x
        - D_p_y_4*s_dot_2_y - D_p_z_4*s_dot_2_z;
    const pkmodes_real t207 =
        -D_l_dot_3_rx*D_p_rx_4 - D_l_dot_3_ry*D_p_ry_4 - D_l_dot_3_rz*D_p_rz_4 - D_p_x_4*s_dot_3_x
        - D_p_y_4*s_dot_3_y - D_p_z_4*s_dot_3_z;
    const pkmodes_real t208 =
        -D_l_dot_5_rx*D_p_rx_4 - D_l_dot_5_ry*D_p_ry_4 - D_l_dot_5_rz*D_p_rz_4 - D_p_x_4*s_dot_5_x
        - D_p_y_4*s_dot_5_y - D_p_z_4*s_dot_5_z;
    const pkmodes_real t209 =
        -D_l_dot_6_rx*D_p_rx_4 - D_l_dot_6_ry*D_p_ry_4 - D_l_dot_6_rz*D_p_rz_4 - D_p_x_4*s_dot_6_x
        - D_p_y_4*s_dot_6_y - D_p_z_4*s_dot_6_z;
    const pkmodes_real t210 =
        -D_l_dot_4_rx*D_p_rx_4 - D_l_dot_4_ry*D_p_ry_4 - D_l_dot_4_rz*D_p_rz_4 - D_p_x_4*s_dot_4_x
        - D_p_y_4*s_dot_4_y - D_p_z_4*s_dot_4_z + n_4_x*s_dot_4_x + n_4_y*s_dot_4_y + n_4_z*s_dot_4_z;
    const pkmodes_real D_p_dot_x_4 =
        t12*(A_x_1*t205 + A_x_2*t206 + A_x_3*t207 + A_x_4*t210 + A_x_5*t208 + A_x_6*t209);
    const pkmodes_real D_p_dot_y_4 =
        t12*(A_y_1*t205 + A_y_2*t206 + A_y_3*t207 + A_y_4*t210 + A_y_5*t208 + A_y_6*t209);
    const pkmodes_real D_p_dot_z_4 =
        t12*(A_z_1*t205 + A_z_2*t206 + A_z_3*t207 + A_z_4*t210 + A_z_5*t208 + A_z_6*t209);
    const pkmodes_real D_p_dot_rx_4 =
        t12*(A_rx_1*t205 + A_rx_2*t206 + A_rx_3*t207 + A_rx_4*t210 + A_rx_5*t208 + A_rx_6*t209);
    const pkmodes_real D_p_dot_ry_4 =
        t12*(A_ry_1*t205 + A_ry_2*t206 + A_ry_3*t207 + A_ry_4*t210 + A_ry_5*t208 + A_ry_6*t209);
    const pkmodes_real D_p_dot_rz_4 =
        t12*(A_rz_1*t205 + A_rz_2*t206 + A_rz_3*t207 + A_rz_4*t210 + A_rz_5*t208 + A_rz_6*t209);
    const pkmodes_real t211 =
        -D_l_dot_1_rx*D_p_rx_5 - D_l_dot_1_ry*D_p_ry_5 - D_l_dot_1_rz*D_p_rz_5 - D_p_x_5*s_dot_1_x
        - D_p_y_5*s_dot_1_y - D_p_z_5*s_dot_1_z;
    const pkmodes_real t212 =
        -D_l_dot_2_rx*D_p_rx_5 - D_l_dot_2_ry*D_p_ry_5 - D_l_dot_2_rz*D_p_rz_5 - D_p_x_5*s_dot_2_x
        - D_p_y_5*s_dot_2_y - D_p_z_5*s_dot_2_z;
    const pkmodes_real t213 =
        -D_l_dot_3_rx*D_p_rx_5 - D_l_dot_3_ry*D_p_ry_5 - D_l_dot_3_rz*D_p_rz_5 - D_p_x_5*s_dot_3_x
        - D_p_y_5*s_dot_3_y - D_p_z_5*s_dot_3_z;
    const pkmodes_real t214 =
        -D_l_dot_4_rx*D_p_rx_5 - D_l_dot_4_ry*D_p_ry_5 - D_l_dot_4_rz*D_p_rz_5 - D_p_x_5*s_dot_4_x
        - D_p_y_5*s_dot_4_y - D_p_z_5*s_dot_4_z;
    const pkmodes_real t215 =
        -D_l_dot_6_rx*D_p_rx_5 - D_l_dot_6_ry*D_p_ry_5 - D_l_dot_6_rz*D_p_rz_5 - D_p_x_5*s_dot_6_x
        - D_p_y_5*s_dot_6_y - D_p_z_5*s_dot_6_z;
    const pkmodes_real t216 =
        -D_l_dot_5_rx*D_p_rx_5 - D_l_dot_5_ry*D_p_ry_5 - D_l_dot_5_rz*D_p_rz_5 - D_p_x_5*s_dot_5_x
        - D_p_y_5*s_dot_5_y - D_p_z_5*s_dot_5_z + n_5_x*s_dot_5_x + n_5_y*s_dot_5_y + n_5_z*s_dot_5_z;
    const pkmodes_real D_p_dot_x_5 =
        t12*(A_x_1*t211 + A_x_2*t212 + A_x_3*t213 + A_x_4*t214 + A_x_5*t216 + A_x_6*t215);
    const pkmodes_real D_p_dot_y_5 =
        t12*(A_y_1*t211 + A_y_2*t212 + A_y_3*t213 + A_y_4*t214 + A_y_5*t216 + A_y_6*t215);
    const pkmodes_real D_p_dot_z_5 =
        t12*(A_z_1*t211 + A_z_2*t212 + A_z_3*t213 + A_z_4*t214 + A_z_5*t216 + A_z_6*t215);
    const pkmodes_real D_p_dot_rx_5 =
        t12*(A_rx_1*t211 + A_rx_2*t212 + A_rx_3*t213 + A_rx_4*t214 + A_rx_5*t216 + A_rx_6*t215);
    const pkmodes_real D_p_dot_ry_5 =
        t12*(A_ry_1*t211 + A_ry_2*t212 + A_ry_3*t213 + A_ry_4*t214 + A_ry_5*t216 + A_ry_6*t215);
    const pkmodes_real D_p_dot_rz_5 =
        t12*(A_rz_1*t211 + A_rz_2*t212 + A_rz_3*t213 + A_rz_4*t214 + A_rz_5*t216 + A_rz_6*t215);
    const pkmodes_real t217 =
        -D_l_dot_1_rx*D_p_rx_6 - D_l_dot_1_ry*D_p_ry_6 - D_l_dot_1_rz*D_p_rz_6 - D_p_x_6*s_dot_1_x
        - D_p_y_6*s_dot_1_y - D_p_z_6*s_dot_1_z;
    const pkmodes_real t218 =
        -D_l_dot_2_rx*D_p_rx_6 - D_l_dot_2_ry*D_p_ry_6 - D_l_dot_2_rz*D_p_rz_6 - D_p_x_6*s_dot_2_x
        - D_p_y_6*s_dot_2_y - D_p_z_6*s_dot_2_z;
    const pkmodes_real t219 =
        -D_l_dot_3_rx*D_p_rx_6 - D_l_dot_3_ry*D_p_ry_6 - D_l_dot_3_rz*D_p_rz_6 - D_p_x_6*s_dot_3_x
        - D_p_y_6*s_dot_3_y - D_p_z_6*s_dot_3_z;
    const pkmodes_real t220 =
        -D_l_dot_4_rx*D_p_rx_6 - D_l_dot_4_ry*D_p_ry_6 - D_l_dot_4_rz*D_p_rz_6 - D_p_x_6*s_dot_4_x
        - D_p_y_6*s_dot_4_y - D_p_z_6*s_dot_4_z;
    const pkmodes_real t221 =
        -D_l_dot_5_rx*D_p_rx_6 - D_l_dot_5_ry*D_p_ry_6 - D_l_dot_5_rz*D_p_rz_6 - D_p_x_6*s_dot_5_x
        - D_p_y_6*s_dot_5_y - D_p_z_6*s_dot_5_z;
    const pkmodes_real t222 =
        -D_l_dot_6_rx*D_p_rx_6 - D_l_dot_6_ry*D_p_ry_6 - D_l_dot_6_rz*D_p_rz_6 - D_p_x_6*s_dot_6_x
        - D_p_y_6*s_dot_6_y - D_p_z_6*s_dot_6_z + n_6_x*s_dot_6_x + n_6_y*s_dot_6_y + n_6_z*s_dot_6_z;
    const pkmodes_real D_p_dot_x_6 =
        t12*(A_x_1*t217 + A_x_2*t218 + A_x_3*t219 + A_x_4*t220 + A_x_5*t221 + A_x_6*t222);
    const pkmodes_real D_p_dot_y_6 =
        t12*(A_y_1*t217 + A_y_2*t218 + A_y_3*t219 + A_y_4*t220 + A_y_5*t221 + A_y_6*t222);
    const pkmodes_real D_p_dot_z_6 =
        t12*(A_z_1*t217 + A_z_2*t218 + A_z_3*t219 + A_z_4*t220 + A_z_5*t221 + A_z_6*t222);
    const pkmodes_real D_p_dot_rx_6 =
        t12*(A_rx_1*t217 + A_rx_2*t218 + A_rx_3*t219 + A_rx_4*t220 + A_rx_5*t221 + A_rx_6*t222);
    const pkmodes_real D_p_dot_ry_6 =
        t12*(A_ry_1*t217 + A_ry_2*t218 + A_ry_3*t219 + A_ry_4*t220 + A_ry_5*t221 + A_ry_6*t222);
    const pkmodes_real D_p_dot_rz_6 =
        t12*(A_rz_1*t217 + A_rz_2*t218 + A_rz_3*t219 + A_rz_4*t220 + A_rz_5*t221 + A_rz_6*t222);
    D_p_dot[0][0] = D_p_dot_x_1;
    D_p_dot[0][1] = D_p_dot_x_2;
    D_p_dot[0][2] = D_p_dot_x_3;
    D_p_dot[0][3] = D_p_dot_x_4;
    D_p_dot[0][4] = D_p_dot_x_5;
    D_p_dot[0][5] = D_p_dot_x_6;
    D_p_dot[1][0] = D_p_dot_y_1;
    D_p_dot[1][1] = D_p_dot_y_2;
    D_p_dot[1][2] = D_p_dot_y_3;
    D_p_dot[1][3] = D_p_dot_y_4;
    D_p_dot[1][4] = D_p_dot_y_5;
    D_p_dot[1][5] = D_p_dot_y_6;
    D_p_dot[2][0] = D_p_dot_z_1;
    D_p_dot[2][1] = D_p_dot_z_2;
    D_p_dot[2][2] = D_p_dot_z_3;
    D_p_dot[2][3] = D_p_dot_z_4;
    D_p_dot[2][4] = D_p_dot_z_5;
    D_p_dot[2][5] = D_p_dot_z_6;
    D_p_dot[3][0] = D_p_dot_rx_1;
    D_p_dot[3][1] = D_p_dot_rx_2;
    D_p_dot[3][2] = D_p_dot_rx_3;
    D_p_dot[3][3] = D_p_dot_rx_4;
    D_p_dot[3][4] = D_p_dot_rx_5;
    D_p_dot[3][5] = D_p_dot_rx_6;
    D_p_dot[4][0] = D_p_dot_ry_1;
    D_p_dot[4][1] = D_p_dot_ry_2;
    D_p_dot[4][2] = D_p_dot_ry_3;
    D_p_dot[4][3] = D_p_dot_ry_4;
    D_p_dot[4][4] = D_p_dot_ry_5;
    D_p_dot[4][5] = D_p_dot_ry_6;
    D_p_dot[5][0] = D_p_dot_rz_1;
    D_p_dot[5][1] = D_p_dot_rz_2;
    D_p_dot[5][2] = D_p_dot_rz_3;
    D_p_dot[5][3] = D_p_dot_rz_4;
    D_p_dot[5][4] = D_p_dot_rz_5;
    D_p_dot[5][5] = D_p_dot_rz_6;
}

void hexaglide_platform_second_derivatives(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real P[6][6][6])
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
    const pkmodes_real t19 = B_1_y*D_p_rz_1 - B_1_z*D_p_ry_1;
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x - t19;
    const pkmodes_real t20 = B_1_y*D_p_rz_2;
    const pkmodes_real U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t20;
    const pkmodes_real t21 = B_1_y*D_p_rz_3;
    const pkmodes_real U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t21;
    const pkmodes_real t22 = B_1_y*D_p_rz_4;
    const pkmodes_real U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t22;
    const pkmodes_real t23 = B_1_y*D_p_rz_5;
    const pkmodes_real U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t23;
    const pkmodes_real t24 = B_1_y*D_p_rz_6;
    const pkmodes_real U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t24;
    const pkmodes_real t25 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y + t25;
    const pkmodes_real t26 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2;
    const pkmodes_real U_1_y_2 = D_p_y_2 + t26;
    const pkmodes_real t27 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3;
    const pkmodes_real U_1_y_3 = D_p_y_3 + t27;
    const pkmodes_real t28 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4;
    const pkmodes_real U_1_y_4 = D_p_y_4 + t28;
    const pkmodes_real t29 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5;
    const pkmodes_real U_1_y_5 = D_p_y_5 + t29;
    const pkmodes_real t30 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6;
    const pkmodes_real U_1_y_6 = D_p_y_6 + t30;
    const pkmodes_real t31 = B_1_x*D_p_ry_1 - B_1_y*D_p_rx_1;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z - t31;
    const pkmodes_real t32 = B_1_x*D_p_ry_2;
    const pkmodes_real U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t32;
    const pkmodes_real t33 = B_1_x*D_p_ry_3;
    const pkmodes_real U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t33;
    const pkmodes_real t34 = B_1_x*D_p_ry_4;
    const pkmodes_real U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t34;
    const pkmodes_real t35 = B_1_x*D_p_ry_5;
    const pkmodes_real U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t35;
    const pkmodes_real t36 = B_1_x*D_p_ry_6;
    const pkmodes_real U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t36;
    const pkmodes_real t37 = B_2_y*D_p_rz_1;
    const pkmodes_real U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t37;
    const pkmodes_real t38 = B_2_y*D_p_rz_2 - B_2_z*D_p_ry_2;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x - t38;
    const pkmodes_real t39 = B_2_y*D_p_rz_3;
    const pkmodes_real U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t39;
    const pkmodes_real t40 = B_2_y*D_p_rz_4;
    const pkmodes_real U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t40;
    const pkmodes_real t41 = B_2_y*D_p_rz_5;
    const pkmodes_real U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t41;
    const pkmodes_real t42 = B_2_y*D_p_rz_6;
    const pkmodes_real U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t42;
    const pkmodes_real t43 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1;
    const pkmodes_real U_2_y_1 = D_p_y_1 + t43;
    const pkmodes_real t44 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y + t44;
    const pkmodes_real t45 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3;
    const pkmodes_real U_2_y_3 = D_p_y_3 + t45;
    const pkmodes_real t46 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4;
    const pkmodes_real U_2_y_4 = D_p_y_4 + t46;
    const pkmodes_real t47 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5;
    const pkmodes_real U_2_y_5 = D_p_y_5 + t47;
    const pkmodes_real t48 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6;
    const pkmodes_real U_2_y_6 = D_p_y_6 + t48;
    const pkmodes_real t49 = B_2_x*D_p_ry_1;
    const pkmodes_real U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t49;
    const pkmodes_real t50 = B_2_x*D_p_ry_2 - B_2_y*D_p_rx_2;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z - t50;
    const pkmodes_real t51 = B_2_x*D_p_ry_3;
    const pkmodes_real U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t51;
    const pkmodes_real t52 = B_2_x*D_p_ry_4;
    const pkmodes_real U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t52;
    const pkmodes_real t53 = B_2_x*D_p_ry_5;
    const pkmodes_real U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t53;
    const pkmodes_real t54 = B_2_x*D_p_ry_6;
    const pkmodes_real U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t54;
    const pkmodes_real t55 = B_3_y*D_p_rz_1;
    const pkmodes_real U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t55;
    const pkmodes_real t56 = B_3_y*D_p_rz_2;
    const pkmodes_real U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t56;
    const pkmodes_real t57 = B_3_y*D_p_rz_3 - B_3_z*D_p_ry_3;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x - t57;
    const pkmodes_real t58 = B_3_y*D_p_rz_4;
    const pkmodes_real U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t58;
    const pkmodes_real t59 = B_3_y*D_p_rz_5;
    const pkmodes_real U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t59;
    const pkmodes_real t60 = B_3_y*D_p_rz_6;
    const pkmodes_real U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t60;
    const pkmodes_real t61 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1;
    const pkmodes_real U_3_y_1 = D_p_y_1 + t61;
    const pkmodes_real t62 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2;
    const pkmodes_real U_3_y_2 = D_p_y_2 + t62;
    const pkmodes_real t63 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y + t63;
    const pkmodes_real t64 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4;
    const pkmodes_real U_3_y_4 = D_p_y_4 + t64;
    const pkmodes_real t65 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5;
    const pkmodes_real U_3_y_5 = D_p_y_5 + t65;
    const pkmodes_real t66 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6;
    const pkmodes_real U_3_y_6 = D_p_y_6 + t66;
    const pkmodes_real t67 = B_3_x*D_p_ry_1;
    const pkmodes_real U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t67;
    const pkmodes_real t68 = B_3_x*D_p_ry_2;
    const pkmodes_real U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t68;
    const pkmodes_real t69 = B_3_x*D_p_ry_3 - B_3_y*D_p_rx_3;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z - t69;
    const pkmodes_real t70 = B_3_x*D_p_ry_4;
    const pkmodes_real U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t70;
    const pkmodes_real t71 = B_3_x*D_p_ry_5;
    const pkmodes_real U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t71;
    const pkmodes_real t72 = B_3_x*D_p_ry_6;
    const pkmodes_real U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t72;
    const pkmodes_real t73 = B_4_y*D_p_rz_1;
    const pkmodes_real U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t73;
    const pkmodes_real t74 = B_4_y*D_p_rz_2;
    const pkmodes_real U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t74;
    const pkmodes_real t75 = B_4_y*D_p_rz_3;
    const pkmodes_real U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t75;
    const pkmodes_real t76 = B_4_y*D_p_rz_4 - B_4_z*D_p_ry_4;
    const pkmodes_real U_4_x_4 = D_p_x_4 - n_4_x - t76;
    const pkmodes_real t77 = B_4_y*D_p_rz_5;
    const pkmodes_real U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t77;
    const pkmodes_real t78 = B_4_y*D_p_rz_6;
    const pkmodes_real U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t78;
    const pkmodes_real t79 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1;
    const pkmodes_real U_4_y_1 = D_p_y_1 + t79;
    const pkmodes_real t80 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2;
    const pkmodes_real U_4_y_2 = D_p_y_2 + t80;
    const pkmodes_real t81 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3;
    const pkmodes_real U_4_y_3 = D_p_y_3 + t81;
    const pkmodes_real t82 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4;
    const pkmodes_real U_4_y_4 = D_p_y_4 - n_4_y + t82;
    const pkmodes_real t83 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5;
    const pkmodes_real U_4_y_5 = D_p_y_5 + t83;
    const pkmodes_real t84 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6;
    const pkmodes_real U_4_y_6 = D_p_y_6 + t84;
    const pkmodes_real t85 = B_4_x*D_p_ry_1;
    const pkmodes_real U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t85;
    const pkmodes_real t86 = B_4_x*D_p_ry_2;
    const pkmodes_real U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t86;
    const pkmodes_real t87 = B_4_x*D_p_ry_3;
    const pkmodes_real U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t87;
    const pkmodes_real t88 = B_4_x*D_p_ry_4 - B_4_y*D_p_rx_4;
    const pkmodes_real U_4_z_4 = D_p_z_4 - n_4_z - t88;
    const pkmodes_real t89 = B_4_x*D_p_ry_5;
    const pkmodes_real U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t89;
    const pkmodes_real t90 = B_4_x*D_p_ry_6;
    const pkmodes_real U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t90;
    const pkmodes_real t91 = B_5_y*D_p_rz_1;
    const pkmodes_real U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t91;
    const pkmodes_real t92 = B_5_y*D_p_rz_2;
    const pkmodes_real U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t92;
    const pkmodes_real t93 = B_5_y*D_p_rz_3;
    const pkmodes_real U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t93;
    const pkmodes_real t94 = B_5_y*D_p_rz_4;
    const pkmodes_real U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t94;
    const pkmodes_real t95 = B_5_y*D_p_rz_5 - B_5_z*D_p_ry_5;
    const pkmodes_real U_5_x_5 = D_p_x_5 - n_5_x - t95;
    const pkmodes_real t96 = B_5_y*D_p_rz_6;
    const pkmodes_real U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t96;
    const pkmodes_real t97 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1;
    const pkmodes_real U_5_y_1 = D_p_y_1 + t97;
    const pkmodes_real t98 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2;
    const pkmodes_real U_5_y_2 = D_p_y_2 + t98;
    const pkmodes_real t99 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3;
    const pkmodes_real U_5_y_3 = D_p_y_3 + t99;
    const pkmodes_real t100 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4;
    const pkmodes_real U_5_y_4 = D_p_y_4 + t100;
    const pkmodes_real t101 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5;
    const pkmodes_real U_5_y_5 = D_p_y_5 - n_5_y + t101;
    const pkmodes_real t102 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6;
    const pkmodes_real U_5_y_6 = D_p_y_6 + t102;
    const pkmodes_real t103 = B_5_x*D_p_ry_1;
    const pkmodes_real U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t103;
    const pkmodes_real t104 = B_5_x*D_p_ry_2;
    const pkmodes_real U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t104;
    const pkmodes_real t105 = B_5_x*D_p_ry_3;
    const pkmodes_real U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t105;
    const pkmodes_real t106 = B_5_x*D_p_ry_4;
    const pkmodes_real U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t106;
    const pkmodes_real t107 = B_5_x*D_p_ry_5 - B_5_y*D_p_rx_5;
    const pkmodes_real U_5_z_5 = D_p_z_5 - n_5_z - t107;
    const pkmodes_real t108 = B_5_x*D_p_ry_6;
    const pkmodes_real U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t108;
    const pkmodes_real t109 = B_6_y*D_p_rz_1;
    const pkmodes_real U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t109;
    const pkmodes_real t110 = B_6_y*D_p_rz_2;
    const pkmodes_real U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t110;
    const pkmodes_real t111 = B_6_y*D_p_rz_3;
    const pkmodes_real U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t111;
    const pkmodes_real t112 = B_6_y*D_p_rz_4;
    const pkmodes_real U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t112;
    const pkmodes_real t113 = B_6_y*D_p_rz_5;
    const pkmodes_real U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t113;
    const pkmodes_real t114 = B_6_y*D_p_rz_6 - B_6_z*D_p_ry_6;
    const pkmodes_real U_6_x_6 = D_p_x_6 - n_6_x - t114;
    const pkmodes_real t115 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1;
    const pkmodes_real U_6_y_1 = D_p_y_1 + t115;
    const pkmodes_real t116 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2;
    const pkmodes_real U_6_y_2 = D_p_y_2 + t116;
    const pkmodes_real t117 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3;
    const pkmodes_real U_6_y_3 = D_p_y_3 + t117;
    const pkmodes_real t118 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4;
    const pkmodes_real U_6_y_4 = D_p_y_4 + t118;
    const pkmodes_real t119 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5;
    const pkmodes_real U_6_y_5 = D_p_y_5 + t119;
    const pkmodes_real t120 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6;
    const pkmodes_real U_6_y_6 = D_p_y_6 - n_6_y + t120;
    const pkmodes_real t121 = B_6_x*D_p_ry_1;
    const pkmodes_real U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t121;
    const pkmodes_real t122 = B_6_x*D_p_ry_2;
    const pkmodes_real U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t122;
    const pkmodes_real t123 = B_6_x*D_p_ry_3;
    const pkmodes_real U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t123;
    const pkmodes_real t124 = B_6_x*D_p_ry_4;
    const pkmodes_real U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t124;
    const pkmodes_real t125 = B_6_x*D_p_ry_5;
    const pkmodes_real U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t125;
    const pkmodes_real t126 = B_6_x*D_p_ry_6 - B_6_y*D_p_rx_6;
    const pkmodes_real U_6_z_6 = D_p_z_6 - n_6_z - t126;
    const pkmodes_real f_1_11 =
        -(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1) - s_1_x*(-D_p_ry_1*t31 - D_p_rz_1*t25)
        - s_1_y*(D_p_rx_1*t31 - D_p_rz_1*t19) - s_1_z*(D_p_rx_1*t25 + D_p_ry_1*t19);
    const pkmodes_real t127 = B_2_y*D_p_rx_1 - t49;
    const pkmodes_real t128 = B_2_z*D_p_ry_1 - t37;
    const pkmodes_real f_2_11 =
        -(U_2_x_1*U_2_x_1) - (U_2_y_1*U_2_y_1) - (U_2_z_1*U_2_z_1) - s_2_x*(D_p_ry_1*t127 - D_p_rz_1*t43)
        - s_2_y*(-D_p_rx_1*t127 + D_p_rz_1*t128) - s_2_z*(D_p_rx_1*t43 - D_p_ry_1*t128);
    const pkmodes_real t129 = B_3_y*D_p_rx_1 - t67;
    const pkmodes_real t130 = B_3_z*D_p_ry_1 - t55;
    const pkmodes_real f_3_11 =
        -(U_3_x_1*U_3_x_1) - (U_3_y_1*U_3_y_1) - (U_3_z_1*U_3_z_1) - s_3_x*(D_p_ry_1*t129 - D_p_rz_1*t61)
        - s_3_y*(-D_p_rx_1*t129 + D_p_rz_1*t130) - s_3_z*(D_p_rx_1*t61 - D_p_ry_1*t130);
    const pkmodes_real t131 = B_4_y*D_p_rx_1 - t85;
    const pkmodes_real t132 = B_4_z*D_p_ry_1 - t73;
    const pkmodes_real f_4_11 =
        -(U_4_x_1*U_4_x_1) - (U_4_y_1*U_4_y_1) - (U_4_z_1*U_4_z_1) - s_4_x*(D_p_ry_1*t131 - D_p_rz_1*t79)
        - s_4_y*(-D_p_rx_1*t131 + D_p_rz_1*t132) - s_4_z*(D_p_rx_1*t79 - D_p_ry_1*t132);
    const pkmodes_real t133 = B_5_y*D_p_rx_1 - t103;
    const pkmodes_real t134 = B_5_z*D_p_ry_1 - t91;
    const pkmodes_real f_5_11 =
        -(U_5_x_1*U_5_x_1) - (U_5_y_1*U_5_y_1) - (U_5_z_1*U_5_z_1) - s_5_x*(D_p_ry_1*t133 - D_p_rz_1*t97)
        - s_5_y*(-D_p_rx_1*t133 + D_p_rz_1*t134) - s_5_z*(D_p_rx_1*t97 - D_p_ry_1*t134);
    const pkmodes_real t135 = B_6_y*D_p_rx_1 - t121;
    const pkmodes_real t136 = B_6_z*D_p_ry_1 - t109;
    const pkmodes_real f_6_11 =
        -(U_6_x_1*U_6_x_1) - (U_6_y_1*U_6_y_1) - (U_6_z_1*U_6_z_1) - s_6_x*(D_p_ry_1*t135 - D_p_rz_1*t115)
        - s_6_y*(-D_p_rx_1*t135 + D_p_rz_1*t136) - s_6_z*(D_p_rx_1*t115 - D_p_ry_1*t136);
    const pkmodes_real P_x_11 =
        t12*(A_x_1*f_1_11 + A_x_2*f_2_11 + A_x_3*f_3_11 + A_x_4*f_4_11 + A_x_5*f_5_11 + A_x_6*f_6_11);
    const pkmodes_real P_y_11 =
        t12*(A_y_1*f_1_11 + A_y_2*f_2_11 + A_y_3*f_3_11 + A_y_4*f_4_11 + A_y_5*f_5_11 + A_y_6*f_6_11);
    const pkmodes_real P_z_11 =
        t12*(A_z_1*f_1_11 + A_z_2*f_2_11 + A_z_3*f_3_11 + A_z_4*f_4_11 + A_z_5*f_5_11 + A_z_6*f_6_11);
    const pkmodes_real P_rx_11 =
        t12*(A_rx_1*f_1_11 + A_rx_2*f_2_11 + A_rx_3*f_3_11 + A_rx_4*f_4_11 + A_rx_5*f_5_11 + A_rx_6*f_6_11);
    const pkmodes_real P_ry_11 =
        t12*(A_ry_1*f_1_11 + A_ry_2*f_2_11 + A_ry_3*f_3_11 + A_ry_4*f_4_11 + A_ry_5*f_5_11 + A_ry_6*f_6_11);
    const pkmodes_real P_rz_11 =
        t12*(A_rz_1*f_1_11 + A_rz_2*f_2_11 + A_rz_3*f_3_11 + A_rz_4*f_4_11 + A_rz_5*f_5_11 + A_rz_6*f_6_11);
    const pkmodes_real t137 = B_1_y*D_p_rx_2 - t32;
    const pkmodes_real t138 = (R(1.0)/R(2.0))*s_1_x;
    const pkmodes_real t139 = B_1_z*D_p_ry_2 - t20;
    const pkmodes_real t140 = (R(1.0)/R(2.0))*s_1_y;
    const pkmodes_real t141 = (R(1.0)/R(2.0))*s_1_z;
    const pkmodes_real f_1_12 =
        -U_1_x_1*U_1_x_2 - U_1_y_1*U_1_y_2 - U_1_z_1*U_1_z_2 - t138*(D_p_ry_1*t137 - D_p_rz_1*t26)
        - t138*(-D_p_ry_2*t31 - D_p_rz_2*t25) - t140*(-D_p_rx_1*t137 + D_p_rz_1*t139) - t140*(D_p_rx_2*t31
        - D_p_rz_2*t19) - t141*(D_p_rx_1*t26 - D_p_ry_1*t139) - t141*(D_p_rx_2*t25 + D_p_ry_2*t19);
    const pkmodes_real t142 = (R(1.0)/R(2.0))*s_2_x;
    const pkmodes_real t143 = (R(1.0)/R(2.0))*s_2_y;
    const pkmodes_real t144 = (R(1.0)/R(2.0))*s_2_z;
    const pkmodes_real f_2_12 =
        -U_2_x_1*U_2_x_2 - U_2_y_1*U_2_y_2 - U_2_z_1*U_2_z_2 - t142*(-D_p_ry_1*t50 - D_p_rz_1*t44)
        - t142*(D_p_ry_2*t127 - D_p_rz_2*t43) - t143*(D_p_rx_1*t50 - D_p_rz_1*t38) - t143*(-D_p_rx_2*t127
        + D_p_rz_2*t128) - t144*(D_p_rx_1*t44 + D_p_ry_1*t38) - t144*(D_p_rx_2*t43 - D_p_ry_2*t128);
    const pkmodes_real t145 = B_3_y*D_p_rx_2 - t68;
    const pkmodes_real t146 = (R(1.0)/R(2.0))*s_3_x;
    const pkmodes_real t147 = B_3_z*D_p_ry_2 - t56;
    const pkmodes_real t148 = (R(1.0)/R(2.0))*s_3_y;
    const pkmodes_real t149 = (R(1.0)/R(2.0))*s_3_z;
    const pkmodes_real f_3_12 =
        -U_3_x_1*U_3_x_2 - U_3_y_1*U_3_y_2 - U_3_z_1*U_3_z_2 - t146*(D_p_ry_1*t145 - D_p_rz_1*t62)
        - t146*(D_p_ry_2*t129 - D_p_rz_2*t61) - t148*(-D_p_rx_1*t145 + D_p_rz_1*t147) - t148*(-D_p_rx_2*t129
        + D_p_rz_2*t130) - t149*(D_p_rx_1*t62 - D_p_ry_1*t147) - t149*(D_p_rx_2*t61 - D_p_ry_2*t130);
    const pkmodes_real t150 = B_4_y*D_p_rx_2 - t86;
    const pkmodes_real t151 = (R(1.0)/R(2.0))*s_4_x;
    const pkmodes_real t152 = B_4_z*D_p_ry_2 - t74;
    const pkmodes_real t153 = (R(1.0)/R(2.0))*s_4_y;
    const pkmodes_real t154 = (R(1.0)/R(2.0))*s_4_z;
    const pkmodes_real f_4_12 =
        -U_4_x_1*U_4_x_2 - U_4_y_1*U_4_y_2 - U_4_z_1*U_4_z_2 - t151*(D_p_ry_1*t150 - D_p_rz_1*t80)
        - t151*(D_p_ry_2*t131 - D_p_rz_2*t79) - t153*(-D_p_rx_1*t150 + D_p_rz_1*t152) - t153*(-D_p_rx_2*t131
        + D_p_rz_2*t132) - t154*(D_p_rx_1*t80 - D_p_ry_1*t152) - t154*(D_p_rx_2*t79 - D_p_ry_2*t132);
    const pkmodes_real t155 = B_5_y*D_p_rx_2 - t104;
    const pkmodes_real t156 = (R(1.0)/R(2.0))*s_5_x;
    const pkmodes_real t157 = B_5_z*D_p_ry_2 - t92;
    const pkmodes_real t158 = (R(1.0)/R(2.0))*s_5_y;
    const pkmodes_real t159 = (R(1.0)/R(2.0))*s_5_z;
    const pkmodes_real f_5_12 =
        -U_5_x_1*U_5_x_2 - U_5_y_1*U_5_y_2 - U_5_z_1*U_5_z_2 - t156*(D_p_ry_1*t155 - D_p_rz_1*t98)
        - t156*(D_p_ry_2*t133 - D_p_rz_2*t97) - t158*(-D_p_rx_1*t155 + D_p_rz_1*t157) - t158*(-D_p_rx_2*t133
        + D_p_rz_2*t134) - t159*(D_p_rx_1*t98 - D_p_ry_1*t157) - t159*(D_p_rx_2*t97 - D_p_ry_2*t134);
    const pkmodes_real t160 = B_6_y*D_p_rx_2 - t122;
    const pkmodes_real t161 = (R(1.0)/R(2.0))*s_6_x;
    const pkmodes_real t162 = B_6_z*D_p_ry_2 - t110;
    const pkmodes_real t163 = (R(1.0)/R(2.0))*s_6_y;
    const pkmodes_real t164 = (R(1.0)/R(2.0))*s_6_z;
    const pkmodes_real f_6_12 =
        -U_6_x_1*U_6_x_2 - U_6_y_1*U_6_y_2 - U_6_z_1*U_6_z_2 - t161*(D_p_ry_1*t160 - D_p_rz_1*t116)
        - t161*(D_p_ry_2*t135 - D_p_rz_2*t115) - t163*(-D_p_rx_1*t160 + D_p_rz_1*t162) - t163*(-D_p_rx_2*t135
        + D_p_rz_2*t136) - t164*(D_p_rx_1*t116 - D_p_ry_1*t162) - t164*(D_p_rx_2*t115 - D_p_ry_2*t136);
    const pkmodes_real P_x_12 =
        t12*(A_x_1*f_1_12 + A_x_2*f_2_12 + A_x_3*f_3_12 + A_x_4*f_4_12 + A_x_5*f_5_12 + A_x_6*f_6_12);
    const pkmodes_real P_y_12 =
        t12*(A_y_1*f_1_12 + A_y_2*f_2_12 + A_y_3*f_3_12 + A_y_4*f_4_12 + A_y_5*f_5_12 + A_y_6*f_6_12);
    const pkmodes_real P_z_12 =
        t12*(A_z_1*f_1_12 + A_z_2*f_2_12 + A_z_3*f_3_12 + A_z_4*f_4_12 + A_z_5*f_5_12 + A_z_6*f_6_12);
    const pkmodes_real P_rx_12 =
        t12*(A_rx_1*f_1_12 + A_rx_2*f_2_12 + A_rx_3*f_3_12 + A_rx_4*f_4_12 + A_rx_5*f_5_12 + A_rx_6*f_6_12);
    const pkmodes_real P_ry_12 =
        t12*(A_ry_1*f_1_12 + A_ry_2*f_2_12 + A_ry_3*f_3_12 + A_ry_4*f_4_12 + A_ry_5*f_5_12 + A_ry_6*f_6_12);
    const pkmodes_real P_rz_12 =
        t12*(A_rz_1*f_1_12 + A_rz_2*f_2_12 + A_rz_3*f_3_12 + A_rz_4*f_4_12 + A_rz_5*f_5_12 + A_rz_6*f_6_12);
    const pkmodes_real t165 = B_1_y*D_p_rx_3 - t33;
    const pkmodes_real t166 = B_1_z*D_p_ry_3 - t21;
    const pkmodes_real f_1_13 =
        -U_1_x_1*U_1_x_3 - U_1_y_1*U_1_y_3 - U_1_z_1*U_1_z_3 - t138*(D_p_ry_1*t165 - D_p_rz_1*t27)
        - t138*(-D_p_ry_3*t31 - D_p_rz_3*t25) - t140*(-D_p_rx_1*t165 + D_p_rz_1*t166) - t140*(D_p_rx_3*t31
        - D_p_rz_3*t19) - t141*(D_p_rx_1*t27 - D_p_ry_1*t166) - t141*(D_p_rx_3*t25 + D_p_ry_3*t19);
    const pkmodes_real t167 = B_2_y*D_p_rx_3 - t51;
    const pkmodes_real t168 = B_2_z*D_p_ry_3 - t39;
    const pkmodes_real f_2_13 =
        -U_2_x_1*U_2_x_3 - U_2_y_1*U_2_y_3 - U_2_z_1*U_2_z_3 - t142*(D_p_ry_1*t167 - D_p_rz_1*t45)
        - t142*(D_p_ry_3*t127 - D_p_rz_3*t43) - t143*(-D_p_rx_1*t167 + D_p_rz_1*t168) - t143*(-D_p_rx_3*t127
        + D_p_rz_3*t128) - t144*(D_p_rx_1*t45 - D_p_ry_1*t168) - t144*(D_p_rx_3*t43 - D_p_ry_3*t128);
    const pkmodes_real f_3_13 =
        -U_3_x_1*U_3_x_3 - U_3_y_1*U_3_y_3 - U_3_z_1*U_3_z_3 - t146*(-D_p_ry_1*t69 - D_p_rz_1*t63)
        - t146*(D_p_ry_3*t129 - D_p_rz_3*t61) - t148*(D_p_rx_1*t69 - D_p_rz_1*t57) - t148*(-D_p_rx_3*t129
        + D_p_rz_3*t130) - t149*(D_p_rx_1*t63 + D_p_ry_1*t57) - t149*(D_p_rx_3*t61 - D_p_ry_3*t130);
    const pkmodes_real t169 = B_4_y*D_p_rx_3 - t87;
    const pkmodes_real t170 = B_4_z*D_p_ry_3 - t75;
    const pkmodes_real f_4_13 =
        -U_4_x_1*U_4_x_3 - U_4_y_1*U_4_y_3 - U_4_z_1*U_4_z_3 - t151*(D_p_ry_1*t169 - D_p_rz_1*t81)
        - t151*(D_p_ry_3*t131 - D_p_rz_3*t79) - t153*(-D_p_rx_1*t169 + D_p_rz_1*t170) - t153*(-D_p_rx_3*t131
        + D_p_rz_3*t132) - t154*(D_p_rx_1*t81 - D_p_ry_1*t170) - t154*(D_p_rx_3*t79 - D_p_ry_3*t132);
    const pkmodes_real t171 = B_5_y*D_p_rx_3 - t105;
    const pkmodes_real t172 = B_5_z*D_p_ry_3 - t93;
    const pkmodes_real f_5_13 =
        -U_5_x_1*U_5_x_3 - U_5_y_1*U_5_y_3 - U_5_z_1*U_5_z_3 - t156*(D_p_ry_1*t171 - D_p_rz_1*t99)
        - t156*(D_p_ry_3*t133 - D_p_rz_3*t97) - t158*(-D_p_rx_1*t171 + D_p_rz_1*t172) - t158*(-D_p_rx_3*t133
        + D_p_rz_3*t134) - t159*(D_p_rx_1*t99 - D_p_ry_1*t172) - t159*(D_p_rx_3*t97 - D_p_ry_3*t134);
    const pkmodes_real t173 = B_6_y*D_p_rx_3 - t123;
    const pkmodes_real t174 = B_6_z*D_p_ry_3 - t111;
    const pkmodes_real f_6_13 =
        -U_6_x_1*U_6_x_3 - U_6_y_1*U_6_y_3 - U_6_z_1*U_6_z_3 - t161*(D_p_ry_1*t173 - D_p_rz_1*t117)
        - t161*(D_p_ry_3*t135 - D_p_rz_3*t115) - t163*(-D_p_rx_1*t173 + D_p_rz_1*t174) - t163*(-D_p_rx_3*t135
        + D_p_rz_3*t136) - t164*(D_p_rx_1*t117 - D_p_ry_1*t174) - t164*(D_p_rx_3*t115 - D_p_ry_3*t136);
    const pkmodes_real P_x_13 =
        t12*(A_x_1*f_1_13 + A_x_2*f_2_13 + A_x_3*f_3_13 + A_x_4*f_4_13 + A_x_5*f_5_13 + A_x_6*f_6_13);
    const pkmodes_real P_y_13 =
        t12*(A_y_1*f_1_13 + A_y_2*f_2_13 + A_y_3*f_3_13 + A_y_4*f_4_13 + A_y_5*f_5_13 + A_y_6*f_6_13);
    const pkmodes_real P_z_13 =
        t12*(A_z_1*f_1_13 + A_z_2*f_2_13 + A_z_3*f_3_13 + A_z_4*f_4_13 + A_z_5*f_5_13 + A_z_6*f_6_13);
    const pkmodes_real P_rx_13 =
        t12*(A_rx_1*f_1_13 + A_rx_2*f_2_13 + A_rx_3*f_3_13 + A_rx_4*f_4_13 + A_rx_5*f_5_13 + A_rx_6*f_6_13);
    const pkmodes_real P_ry_13 =
        t12*(A_ry_1*f_1_13 + A_ry_2*f_2_13 + A_ry_3*f_3_13 + A_ry_4*f_4_13 + A_ry_5*f_5_13 + A_ry_6*f_6_13);
    const pkmodes_real P_rz_13 =
        t12*(A_rz_1*f_1_13 + A_rz_2*f_2_13 + A_rz_3*f_3_13 + A_rz_4*f_4_13 + A_rz_5*f_5_13 + A_rz_6*f_6_13);
    const pkmodes_real t175 = B_1_y*D_p_rx_4 - t34;
    const pkmodes_real t176 = B_1_z*D_p_ry_4 - t22;
    const pkmodes_real f_1_14 =
        -U_1_x_1*U_1_x_4 - U_1_y_1*U_1_y_4 - U_1_z_1*U_1_z_4 - t138*(D_p_ry_1*t175 - D_p_rz_1*t28)
        - t138*(-D_p_ry_4*t31 - D_p_rz_4*t25) - t140*(-D_p_rx_1*t175 + D_p_rz_1*t176) - t140*(D_p_rx_4*t31
        - D_p_rz_4*t19) - t141*(D_p_rx_1*t28 - D_p_ry_1*t176) - t141*(D_p_rx_4*t25 + D_p_ry_4*t19);
    const pkmodes_real t177 = B_2_y*D_p_rx_4 - t52;
    const pkmodes_real t178 = B_2_z*D_p_ry_4 - t40;
    const pkmodes_real f_2_14 =
        -U_2_x_1*U_2_x_4 - U_2_y_1*U_2_y_4 - U_2_z_1*U_2_z_4 - t142*(D_p_ry_1*t177 - D_p_rz_1*t46)
        - t142*(D_p_ry_4*t127 - D_p_rz_4*t43) - t143*(-D_p_rx_1*t177 + D_p_rz_1*t178) - t143*(-D_p_rx_4*t127
        + D_p_rz_4*t128) - t144*(D_p_rx_1*t46 - D_p_ry_1*t178) - t144*(D_p_rx_4*t43 - D_p_ry_4*t128);
    const pkmodes_real t179 = B_3_y*D_p_rx_4 - t70;
    const pkmodes_real t180 = B_3_z*D_p_ry_4 - t58;
    const pkmodes_real f_3_14 =
        -U_3_x_1*U_3_x_4 - U_3_y_1*U_3_y_4 - U_3_z_1*U_3_z_4 - t146*(D_p_ry_1*t179 - D_p_rz_1*t64)
        - t146*(D_p_ry_4*t129 - D_p_rz_4*t61) - t148*(-D_p_rx_1*t179 + D_p_rz_1*t180) - t148*(-D_p_rx_4*t129
        + D_p_rz_4*t130) - t149*(D_p_rx_1*t64 - D_p_ry_1*t180) - t149*(D_p_rx_4*t61 - D_p_ry_4*t130);
    const pkmodes_real f_4_14 =
        -U_4_x_1*U_4_x_4 - U_4_y_1*U_4_y_4 - U_4_z_1*U_4_z_4 - t151*(-D_p_ry_1*t88 - D_p_rz_1*t82)
        - t151*(D_p_ry_4*t131 - D_p_rz_4*t79) - t153*(D_p_rx_1*t88 - D_p_rz_1*t76) - t153*(-D_p_rx_4*t131
        + D_p_rz_4*t132) - t154*(D_p_rx_1*t82 + D_p_ry_1*t76) - t154*(D_p_rx_4*t79 - D_p_ry_4*t132);
    const pkmodes_real t181 = B_5_y*D_p_rx_4 - t106;
    const pkmodes_real t182 = B_5_z*D_p_ry_4 - t94;
    const pkmodes_real f_5_14 =
        -U_5_x_1*U_5_x_4 - U_5_y_1*U_5_y_4 - U_5_z_1*U_5_z_4 - t156*(D_p_ry_1*t181 - D_p_rz_1*t100)
        - t156*(D_p_ry_4*t133 - D_p_rz_4*t97) - t158*(-D_p_rx_1*t181 + D_p_rz_1*t182) - t158*(-D_p_rx_4*t133
        + D_p_rz_4*t134) - t159*(D_p_rx_1*t100 - D_p_ry_1*t182) - t159*(D_p_rx_4*t97 - D_p_ry_4*t134);
    const pkmodes_real t183 = B_6_y*D_p_rx_4 - t124;
    const pkmodes_real t184 = B_6_z*D_p_ry_4 - t112;
    const pkmodes_real f_6_14 =
        -U_6_x_1*U_6_x_4 - U_6_y_1*U_6_y_4 - U_6_z_1*U_6_z_4 - t161*(D_p_ry_1*t183 - D_p_rz_1*t118)
        - t161*(D_p_ry_4*t135 - D_p_rz_4*t115) - t163*(-D_p_rx_1*t183 + D_p_rz_1*t184) - t163*(-D_p_rx_4*t135
        + D_p_rz_4*t136) - t164*(D_p_rx_1*t118 - D_p_ry_1*t184) - t164*(D_p_rx_4*t115 - D_p_ry_4*t136);
    const pkmodes_real P_x_14 =
        t12*(A_x_1*f_1_14 + A_x_2*f_2_14 + A_x_3*f_3_14 + A_x_4*f_4_14 + A_x_5*f_5_14 + A_x_6*f_6_14);
    const pkmodes_real P_y_14 =
        t12*(A_y_1*f_1_14 + A_y_2*f_2_14 + A_y_3*f_3_14 + A_y_4*f_4_14 + A_y_5*f_5_14 + A_y_6*f_6_14);
    const pkmodes_real P_z_14 =
        t12*(A_z_1*f_1_14 + A_z_2*f_2_14 + A_z_3*f_3_14 + A_z_4*f_4_14 + A_z_5*f_5_14 + A_z_6*f_6_14);
    const pkmodes_real P_rx_14 =
        t12*(A_rx_1*f_1_14 + A_rx_2*f_2_14 + A_rx_3*f_3_14 + A_rx_4*f_4_14 + A_rx_5*f_5_14 + A_rx_6*f_6_14);
    const pkmodes_real P_ry_14 =
        t12*(A_ry_1*f_1_14 + A_ry_2*f_2_14 + A_ry_3*f_3_14 + A_ry_4*f_4_14 + A_ry_5*f_5_14 + A_ry_6*f_6_14);
    const pkmodes_real P_rz_14 =
        t12*(A_rz_1*f_1_14 + A_rz_2*f_2_14 + A_rz_3*f_3_14 + A_rz_4*f_4_14 + A_rz_5*f_5_14 + A_rz_6*f_6_14);
    const pkmodes_real t185 = B_1_y*D_p_rx_5 - t35;
    const pkmodes_real t186 = B_1_z*D_p_ry_5 - t23;
    const pkmodes_real f_1_15 =
        -U_1_x_1*U_1_x_5 - U_1_y_1*U_1_y_5 - U_1_z_1*U_1_z_5 - t138*(D_p_ry_1*t185 - D_p_rz_1*t29)
        - t138*(-D_p_ry_5*t31 - D_p_rz_5*t25) - t140*(-D_p_rx_1*t185 + D_p_rz_1*t186) - t140*(D_p_rx_5*t31
        - D_p_rz_5*t19) - t141*(D_p_rx_1*t29 - D_p_ry_1*t186) - t141*(D_p_rx_5*t25 + D_p_ry_5*t19);
    const pkmodes_real t187 = B_2_y*D_p_rx_5 - t53;
    const pkmodes_real t188 = B_2_z*D_p_ry_5 - t41;
    const pkmodes_real f_2_15 =
        -U_2_x_1*U_2_x_5 - U_2_y_1*U_2_y_5 - U_2_z_1*U_2_z_5 - t142*(D_p_ry_1*t187 - D_p_rz_1*t47)
        - t142*(D_p_ry_5*t127 - D_p_rz_5*t43) - t143*(-D_p_rx_1*t187 + D_p_rz_1*t188) - t143*(-D_p_rx_5*t127
        + D_p_rz_5*t128) - t144*(D_p_rx_1*t47 - D_p_ry_1*t188) - t144*(D_p_rx_5*t43 - D_p_ry_5*t128);
    const pkmodes_real t189 = B_3_y*D_p_rx_5 - t71;
    const pkmodes_real t190 = B_3_z*D_p_ry_5 - t59;
    const pkmodes_real f_3_15 =
        -U_3_x_1*U_3_x_5 - U_3_y_1*U_3_y_5 - U_3_z_1*U_3_z_5 - t146*(D_p_ry_1*t189 - D_p_rz_1*t65)
        - t146*(D_p_ry_5*t129 - D_p_rz_5*t61) - t148*(-D_p_rx_1*t189 + D_p_rz_1*t190) - t148*(-D_p_rx_5*t129
        + D_p_rz_5*t130) - t149*(D_p_rx_1*t65 - D_p_ry_1*t190) - t149*(D_p_rx_5*t61 - D_p_ry_5*t130);
    const pkmodes_real t191 = B_4_y*D_p_rx_5 - t89;
    const pkmodes_real t192 = B_4_z*D_p_ry_5 - t77;
    const pkmodes_real f_4_15 =
        -U_4_x_1*U_4_x_5 - U_4_y_1*U_4_y_5 - U_4_z_1*U_4_z_5 - t151*(D_p_ry_1*t191 - D_p_rz_1*t83)
        - t151*(D_p_ry_5*t131 - D_p_rz_5*t79) - t153*(-D_p_rx_1*t191 + D_p_rz_1*t192) - t153*(-D_p_rx_5*t131
        + D_p_rz_5*t132) - t154*(D_p_rx_1*t83 - D_p_ry_1*t192) - t154*(D_p_rx_5*t79 - D_p_ry_5*t132);
    const pkmodes_real f_5_15 =
        -U_5_x_1*U_5_x_5 - U_5_y_1*U_5_y_5 - U_5_z_1*U_5_z_5 - t156*(-D_p_ry_1*t107 - D_p_rz_1*t101)
        - t156*(D_p_ry_5*t133 - D_p_rz_5*t97) - t158*(D_p_rx_1*t107 - D_p_rz_1*t95) - t158*(-D_p_rx_5*t133
        + D_p_rz_5*t134) - t159*(D_p_rx_1*t101 + D_p_ry_1*t95) - t159*(D_p_rx_5*t97 - D_p_ry_5*t134);
    const pkmodes_real t193 = B_6_y*D_p_rx_5 - t125;
    const pkmodes_real t194 = B_6_z*D_p_ry_5 - t113;
    const pkmodes_real f_6_15 =
        -U_6_x_1*U_6_x_5 - U_6_y_1*U_6_y_5 - U_6_z_1*U_6_z_5 - t161*(D_p_ry_1*t193 - D_p_rz_1*t119)
        - t161*(D_p_ry_5*t135 - D_p_rz_5*t115) - t163*(-D_p_rx_1*t193 + D_p_rz_1*t194) - t163*(-D_p_rx_5*t135
        + D_p_rz_5*t136) - t164*(D_p_rx_1*t119 - D_p_ry_1*t194) - t164*(D_p_rx_5*t115 - D_p_ry_5*t136);
    const pkmodes_real P_x_15 =
        t12*(A_x_1*f_1_15 + A_x_2*f_2_15 + A_x_3*f_3_15 + A_x_4*f_4_15 + A_x_5*f_5_15 + A_x_6*f_6_15);
    const pkmodes_real P_y_15 =
        t12*(A_y_1*f_1_15 + A_y_2*f_2_15 + A_y_3*f_3_15 + A_y_4*f_4_15 + A_y_5*f_5_15 + A_y_6*f_6_15);
    const pkmodes_real P_z_15 =
        t12*(A_z_1*f_1_15 + A_z_2*f_2_15 + A_z_3*f_3_15 + A_z_4*f_4_15 + A_z_5*f_5_15 + A_z_6*f_6_15);
    const pkmodes_real P_rx_15 =
        t12*(A_rx_1*f_1_15 + A_rx_2*f_2_15 + A_rx_3*f_3_15 + A_rx_4*f_4_15 + A_rx_5*f_5_15 + A_rx_6*f_6_15);
    const pkmodes_real P_ry_15 =
        t12*(A_ry_1*f_1_15 + A_ry_2*f_2_15 + A_ry_3*f_3_15 + A_ry_4*f_4_15 + A_ry_5*f_5_15 + A_ry_6*f_6_15);
    const pkmodes_real P_rz_15 =
        t12*(A_rz_1*f_1_15 + A_rz_2*f_2_15 + A_rz_3*f_3_15 + A_rz_4*f_4_15 + A_rz_5*f_5_15 + A_rz_6*f_6_15);
    const pkmodes_real t195 = B_1_y*D_p_rx_6 - t36;
    const pkmodes_real t196 = B_1_z*D_p_ry_6 - t24;
    const pkmodes_real f_1_16 =
        -U_1_x_1*U_1_x_6 - U_1_y_1*U_1_y_6 - U_1_z_1*U_1_z_6 - t138*(D_p_ry_1*t195 - D_p_rz_1*t30)
        - t138*(-D_p_ry_6*t31 - D_p_rz_6*t25) - t140*(-D_p_rx_1*t195 + D_p_rz_1*t196) - t140*(D_p_rx_6*t31
        - D_p_rz_6*t19) - t141*(D_p_rx_1*t30 - D_p_ry_1*t196) - t141*(D_p_rx_6*t25 + D_p_ry_6*t19);
    const pkmodes_real t197 = B_2_y*D_p_rx_6 - t54;
    const pkmodes_real t198 = B_2_z*D_p_ry_6 - t42;
    const pkmodes_real f_2_16 =
        -U_2_x_1*U_2_x_6 - U_2_y_1*U_2_y_6 - U_2_z_1*U_2_z_6 - t142*(D_p_ry_1*t197 - D_p_rz_1*t48)
        - t142*(D_p_ry_6*t127 - D_p_rz_6*t43) - t143*(-D_p_rx_1*t197 + D_p_rz_1*t198) - t143*(-D_p_rx_6*t127
        + D_p_rz_6*t128) - t144*(D_p_rx_1*t48 - D_p_ry_1*t198) - t144*(D_p_rx_6*t43 - D_p_ry_6*t128);
    const pkmodes_real t199 = B_3_y*D_p_rx_6 - t72;
    const pkmodes_real t200 = B_3_z*D_p_ry_6 - t60;
    const pkmodes_real f_3_16 =
        -U_3_x_1*U_3_x_6 - U_3_y_1*U_3_y_6 - U_3_z_1*U_3_z_6 - t146*(D_p_ry_1*t199 - D_p_rz_1*t66)
        - t146*(D_p_ry_6*t129 - D_p_rz_6*t61) - t148*(-D_p_rx_1*t199 + D_p_rz_1*t200) - t148*(-D_p_rx_6*t129
        + D_p_rz_6*t130) - t149*(D_p_rx_1*t66 - D_p_ry_1*t200) - t149*(D_p_rx_6*t61 - D_p_ry_6*t130);
    const pkmodes_real t201 = B_4_y*D_p_rx_6 - t90;
    const pkmodes_real t202 = B_4_z*D_p_ry_6 - t78;
    const pkmodes_real f_4_16 =
        -U_4_x_1*U_4_x_6 - U_4_y_1*U_4_y_6 - U_4_z_1*U_4_z_6 - t151*(D_p_ry_1*t201 - D_p_rz_1*t84)
        - t151*(D_p_ry_6*t131 - D_p_rz_6*t79) - t153*(-D_p_rx_1*t201 + D_p_rz_1*t202) - t153*(-D_p_rx_6*t131
        + D_p_rz_6*t132) - t154*(D_p_rx_1*t84 - D_p_ry_1*t202) - t154*(D_p_rx_6*t79 - D_p_ry_6*t132);
    const pkmodes_real t203 = B_5_y*D_p_rx_6 - t108;
    const pkmodes_real t204 = B_5_z*D_p_ry_6 - t96;
    const pkmodes_real f_5_16 =
        -U_5_x_1*U_5_x_6 - U_5_y_1*U_5_y_6 - U_5_z_1*U_5_z_6 - t156*(D_p_ry_1*t203 - D_p_rz_1*t102)
        - t156*(D_p_ry_6*t133 - D_p_rz_6*t97) - t158*(-D_p_rx_1*t203 + D_p_rz_1*t204) - t158*(-D_p_rx_6*t133
        + D_p_rz_6*t134) - t159*(D_p_rx_1*t102 - D_p_ry_1*t204) - t159*(D_p_rx_6*t97 - D_p_ry_6*t134);
    const pkmodes_real f_6_16 =
        -U_6_x_1*U_6_x_6 - U_6_y_1*U_6_y_6 - U_6_z_1*U_6_z_6 - t161*(-D_p_ry_1*t126 - D_p_rz_1*t120)
        - t161*(D_p_ry_6*t135 - D_p_rz_6*t115) - t163*(D_p_rx_1*t126 - D_p_rz_1*t114) - t163*(-D_p_rx_6*t135
        + D_p_rz_6*t136) - t164*(D_p_rx_1*t120 + D_p_ry_1*t114) - t164*(D_p_rx_6*t115 - D_p_ry_6*t136);
    const pkmodes_real P_x_16 =
        t12*(A_x_1*f_1_16 + A_x_2*f_2_16 + A_x_3*f_3_16 + A_x_4*f_4_16 + A_x_5*f_5_16 + A_x_6*f_6_16);
    const pkmodes_real P_y_16 =
        t12*(A_y_1*f_1_16 + A_y_2*f_2_16 + A_y_3*f_3_16 + A_y_4*f_4_16 + A_y_5*f_5_16 + A_y_6*f_6_16);
    const pkmodes_real P_z_16 =
        t12*(A_z_1*f_1_16 + A_z_2*f_2_16 + A_z_3*f_3_16 + A_z_4*f_4_16 + A_z_5*f_5_16 + A_z_6*f_6_16);
    const pkmodes_real P_rx_16 =
        t12*(A_rx_1*f_1_16 + A_rx_2*f_2_16 + A_rx_3*f_3_16 + A_rx_4*f_4_16 + A_rx_5*f_5_16 + A_rx_6*f_6_16);
    const pkmodes_real P_ry_16 =
        t12*(A_ry_1*f_1_16 + A_ry_2*f_2_16 + A_ry_3*f_3_16 + A_ry_4*f_4_16 + A_ry_5*f_5_16 + A_ry_6*f_6_16);
    const pkmodes_real P_rz_16 =
        t12*(A_rz_1*f_1_16 + A_rz_2*f_2_16 + A_rz_3*f_3_16 + A_rz_4*f_4_16 + A_rz_5*f_5_16 + A_rz_6*f_6_16);
    const pkmodes_real f_1_22 =
        -(U_1_x_2*U_1_x_2) - (U_1_y_2*U_1_y_2) - (U_1_z_2*U_1_z_2) - s_1_x*(D_p_ry_2*t137 - D_p_rz_2*t26)
        - s_1_y*(-D_p_rx_2*t137 + D_p_rz_2*t139) - s_1_z*(D_p_rx_2*t26 - D_p_ry_2*t139);
    const pkmodes_real f_2_22 =
        -(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2) - s_2_x*(-D_p_ry_2*t50 - D_p_rz_2*t44)
        - s_2_y*(D_p_rx_2*t50 - D_p_rz_2*t38) - s_2_z*(D_p_rx_2*t44 + D_p_ry_2*t38);
    const pkmodes_real f_3_22 =
        -(U_3_x_2*U_3_x_2) - (U_3_y_2*U_3_y_2) - (U_3_z_2*U_3_z_2) - s_3_x*(D_p_ry_2*t145 - D_p_rz_2*t62)
        - s_3_y*(-D_p_rx_2*t145 + D_p_rz_2*t147) - s_3_z*(D_p_rx_2*t62 - D_p_ry_2*t147);
    const pkmodes_real f_4_22 =
        -(U_4_x_2*U_4_x_2) - (U_4_y_2*U_4_y_2) - (U_4_z_2*U_4_z_2) - s_4_x*(D_p_ry_2*t150 - D_p_rz_2*t80)
        - s_4_y*(-D_p_rx_2*t150 + D_p_rz_2*t152) - s_4_z*(D_p_rx_2*t80 - D_p_ry_2*t152);
    const pkmodes_real f_5_22 =
        -(U_5_x_2*U_5_x_2) - (U_5_y_2*U_5_y_2) - (U_5_z_2*U_5_z_2) - s_5_x*(D_p_ry_2*t155 - D_p_rz_2*t98)
        - s_5_y*(-D_p_rx_2*t155 + D_p_rz_2*t157) - s_5_z*(D_p_rx_2*t98 - D_p_ry_2*t157);
    const pkmodes_real f_6_22 =
        -(U_6_x_2*U_6_x_2) - (U_6_y_2*U_6_y_2) - (U_6_z_2*U_6_z_2) - s_6_x*(D_p_ry_2*t160 - D_p_rz_2*t116)
        - s_6_y*(-D_p_rx_2*t160 + D_p_rz_2*t162) - s_6_z*(D_p_rx_2*t116 - D_p_ry_2*t162);
    const pkmodes_real P_x_22 =
        t12*(A_x_1*f_1_22 + A_x_2*f_2_22 + A_x_3*f_3_22 + A_x_4*f_4_22 + A_x_5*f_5_22 + A_x_6*f_6_22);
    const pkmodes_real P_y_22 =
        t12*(A_y_1*f_1_22 + A_y_2*f_2_22 + A_y_3*f_3_22 + A_y_4*f_4_22 + A_y_5*f_5_22 + A_y_6*f_6_22);
    const pkmodes_real P_z_22 =
        t12*(A_z_1*f_1_22 + A_z_2*f_2_22 + A_z_3*f_3_22 + A_z_4*f_4_22 + A_z_5*f_5_22 + A_z_6*f_6_22);
    const pkmodes_real P_rx_22 =
        t12*(A_rx_1*f_1_22 + A_rx_2*f_2_22 + A_rx_3*f_3_22 + A_rx_4*f_4_22 + A_rx_5*f_5_22 + A_rx_6*f_6_22);
    const pkmodes_real P_ry_22 =
        t12*(A_ry_1*f_1_22 + A_ry_2*f_2_22 + A_ry_3*f_3_22 + A_ry_4*f_4_22 + A_ry_5*f_5_22 + A_ry_6*f_6_22);
    const pkmodes_real P_rz_22 =
        t12*(A_rz_1*f_1_22 + A_rz_2*f_2_22 + A_rz_3*f_3_22 + A_rz_4*f_4_22 + A_rz_5*f_5_22 + A_rz_6*f_6_22);
    const pkmodes_real f_1_23 =
        -U_1_x_2*U_1_x_3 - U_1_y_2*U_1_y_3 - U_1_z_2*U_1_z_3 - t138*(D_p_ry_2*t165 - D_p_rz_2*t27)
        - t138*(D_p_ry_3*t137 - D_p_rz_3*t26) - t140*(-D_p_rx_2*t165 + D_p_rz_2*t166) - t140*(-D_p_rx_3*t137
        + D_p_rz_3*t139) - t141*(D_p_rx_2*t27 - D_p_ry_2*t166) - t141*(D_p_rx_3*t26 - D_p_ry_3*t139);
    const pkmodes_real f_2_23 =
        -U_2_x_2*U_2_x_3 - U_2_y_2*U_2_y_3 - U_2_z_2*U_2_z_3 - t142*(D_p_ry_2*t167 - D_p_rz_2*t45)
        - t142*(-D_p_ry_3*t50 - D_p_rz_3*t44) - t143*(-D_p_rx_2*t167 + D_p_rz_2*t168) - t143*(D_p_rx_3*t50
        - D_p_rz_3*t38) - t144*(D_p_rx_2*t45 - D_p_ry_2*t168) - t144*(D_p_rx_3*t44 + D_p_ry_3*t38);
    const pkmodes_real f_3_23 =
        -U_3_x_2*U_3_x_3 - U_3_y_2*U_3_y_3 - U_3_z_2*U_3_z_3 - t146*(-D_p_ry_2*t69 - D_p_rz_2*t63)
        - t146*(D_p_ry_3*t145 - D_p_rz_3*t62) - t148*(D_p_rx_2*t69 - D_p_rz_2*t57) - t148*(-D_p_rx_3*t145
        + D_p_rz_3*t147) - t149*(D_p_rx_2*t63 + D_p_ry_2*t57) - t149*(D_p_rx_3*t62 - D_p_ry_3*t147);
    const pkmodes_real f_4_23 =
        -U_4_x_2*U_4_x_3 - U_4_y_2*U_4_y_3 - U_4_z_2*U_4_z_3 - t151*(D_p_ry_2*t169 - D_p_rz_2*t81)
        - t151*(D_p_ry_3*t150 - D_p_rz_3*t80) - t153*(-D_p_rx_2*t169 + D_p_rz_2*t170) - t153*(-D_p_rx_3*t150
        + D_p_rz_3*t152) - t154*(D_p_rx_2*t81 - D_p_ry_2*t170) - t154*(D_p_rx_3*t80 - D_p_ry_3*t152);
    const pkmodes_real f_5_23 =
        -U_5_x_2*U_5_x_3 - U_5_y_2*U_5_y_3 - U_5_z_2*U_5_z_3 - t156*(D_p_ry_2*t171 - D_p_rz_2*t99)
        - t156*(D_p_ry_3*t155 - D_p_rz_3*t98) - t158*(-D_p_rx_2*t171 + D_p_rz_2*t172) - t158*(-D_p_rx_3*t155
        + D_p_rz_3*t157) - t159*(D_p_rx_2*t99 - D_p_ry_2*t172) - t159*(D_p_rx_3*t98 - D_p_ry_3*t157);
    const pkmodes_real f_6_23 =
        -U_6_x_2*U_6_x_3 - U_6_y_2*U_6_y_3 - U_6_z_2*U_6_z_3 - t161*(D_p_ry_2*t173 - D_p_rz_2*t117)
        - t161*(D_p_ry_3*t160 - D_p_rz_3*t116) - t163*(-D_p_rx_2*t173 + D_p_rz_2*t174) - t163*(-D_p_rx_3*t160
        + D_p_rz_3*t162) - t164*(D_p_rx_2*t117 - D_p_ry_2*t174) - t164*(D_p_rx_3*t116 - D_p_ry_3*t162);
    const pkmodes_real P_x_23 =
        t12*(A_x_1*f_1_23 + A_x_2*f_2_23 + A_x_3*f_3_23 + A_x_4*f_4_23 + A_x_5*f_5_23 + A_x_6*f_6_23);
    const pkmodes_real P_y_23 =
        t12*(A_y_1*f_1_23 + A_y_2*f_2_23 + A_y_3*f_3_23 + A_y_4*f_4_23 + A_y_5*f_5_23 + A_y_6*f_6_23);
    const pkmodes_real P_z_23 =
        t12*(A_z_1*f_1_23 + A_z_2*f_2_23 + A_z_3*f_3_23 + A_z_4*f_4_23 + A_z_5*f_5_23 + A_z_6*f_6_23);
    const pkmodes_real P_rx_23 =
        t12*(A_rx_1*f_1_23 + A_rx_2*f_2_23 + A_rx_3*f_3_23 + A_rx_4*f_4_23 + A_rx_5*f_5_23 + A_rx_6*f_6_23);
    const pkmodes_real P_ry_23 =
        t12*(A_ry_1*f_1_23 + A_ry_2*f_2_23 + A_ry_3*f_3_23 + A_ry_4*f_4_23 + A_ry_5*f_5_23 + A_ry_6*f_6_23);
    const pkmodes_real P_rz_23 =
        t12*(A_rz_1*f_1_23 + A_rz_2*f_2_23 + A_rz_3*f_3_23 + A_rz_4*f_4_23 + A_rz_5*f_5_23 + A_rz_6*f_6_23);
    const pkmodes_real f_1_24 =
        -U_1_x_2*U_1_x_4 - U_1_y_2*U_1_y_4 - U_1_z_2*U_1_z_4 - t138*(D_p_ry_2*t175 - D_p_rz_2*t28)
        - t138*(D_p_ry_4*t137 - D_p_rz_4*t26) - t140*(-D_p_rx_2*t175 + D_p_rz_2*t176) - t140*(-D_p_rx_4*t137
        + D_p_rz_4*t139) - t141*(D_p_rx_2*t28 - D_p_ry_2*t176) - t141*(D_p_rx_4*t26 - D_p_ry_4*t139);
    const pkmodes_real f_2_24 =
        -U_2_x_2*U_2_x_4 - U_2_y_2*U_2_y_4 - U_2_z_2*U_2_z_4 - t142*(D_p_ry_2*t177 - D_p_rz_2*t46)
        - t142*(-D_p_ry_4*t50 - D_p_rz_4*t44) - t143*(-D_p_rx_2*t177 + D_p_rz_2*t178) - t143*(D_p_rx_4*t50
        - D_p_rz_4*t38) - t144*(D_p_rx_2*t46 - D_p_ry_2*t178) - t144*(D_p_rx_4*t44 + D_p_ry_4*t38);
    const pkmodes_real f_3_24 =
        -U_3_x_2*U_3_x_4 - U_3_y_2*U_3_y_4 - U_3_z_2*U_3_z_4 - t146*(D_p_ry_2*t179 - D_p_rz_2*t64)
        - t146*(D_p_ry_4*t145 - D_p_rz_4*t62) - t148*(-D_p_rx_2*t179 + D_p_rz_2*t180) - t148*(-D_p_rx_4*t145
        + D_p_rz_4*t147) - t149*(D_p_rx_2*t64 - D_p_ry_2*t180) - t149*(D_p_rx_4*t62 - D_p_ry_4*t147);
    const pkmodes_real f_4_24 =
        -U_4_x_2*U_4_x_4 - U_4_y_2*U_4_y_4 - U_4_z_2*U_4_z_4 - t151*(-D_p_ry_2*t88 - D_p_rz_2*t82)
        - t151*(D_p_ry_4*t150 - D_p_rz_4*t80) - t153*(D_p_rx_2*t88 - D_p_rz_2*t76) - t153*(-D_p_rx_4*t150
        + D_p_rz_4*t152) - t154*(D_p_rx_2*t82 + D_p_ry_2*t76) - t154*(D_p_rx_4*t80 - D_p_ry_4*t152);
    const pkmodes_real f_5_24 =
        -U_5_x_2*U_5_x_4 - U_5_y_2*U_5_y_4 - U_5_z_2*U_5_z_4 - t156*(D_p_ry_2*t181 - D_p_rz_2*t100)
        - t156*(D_p_ry_4*t155 - D_p_rz_4*t98) - t158*(-D_p_rx_2*t181 + D_p_rz_2*t182) - t158*(-D_p_rx_4*t155
        + D_p_rz_4*t157) - t159*(D_p_rx_2*t100 - D_p_ry_2*t182) - t159*(D_p_rx_4*t98 - D_p_ry_4*t157);
    const pkmodes_real f_6_24 =
        -U_6_x_2*U_6_x_4 - U_6_y_2*U_6_y_4 - U_6_z_2*U_6_z_4 - t161*(D_p_ry_2*t183 - D_p_rz_2*t118)
        - t161*(D_p_ry_4*t160 - D_p_rz_4*t116) - t163*(-D_p_rx_2*t183 + D_p_rz_2*t184) - t163*(-D_p_rx_4*t160
        + D_p_rz_4*t162) - t164*(D_p_rx_2*t118 - D_p_ry_2*t184) - t164*(D_p_rx_4*t116 - D_p_ry_4*t162);
    const pkmodes_real P_x_24 =
        t12*(A_x_1*f_1_24 + A_x_2*f_2_24 + A_x_3*f_3_24 + A_x_4*f_4_24 + A_x_5*f_5_24 + A_x_6*f_6_24);
    const pkmodes_real P_y_24 =
        t12*(A_y_1*f_1_24 + A_y_2*f_2_24 + A_y_3*f_3_24 + A_y_4*f_4_24 + A_y_5*f_5_24 + A_y_6*f_6_24);
    const pkmodes_real P_z_24 =
        t12*(A_z_1*f_1_24 + A_z_2*f_2_24 + A_z_3*f_3_24 + A_z_4*f_4_24 + A_z_5*f_5_24 + A_z_6*f_6_24);
    const pkmodes_real P_rx_24 =
        t12*(A_rx_1*f_1_24 + A_rx_2*f_2_24 + A_rx_3*f_3_24 + A_rx_4*f_4_24 + A_rx_5*f_5_24 + A_rx_6*f_6_24);
    const pkmodes_real P_ry_24 =
        t12*(A_ry_1*f_1_24 + A_ry_2*f_2_24 + A_ry_3*f_3_24 + A_ry_4*f_4_24 + A_ry_5*f_5_24 + A_ry_6*f_6_24);
    const pkmodes_real P_rz_24 =
        t12*(A_rz_1*f_1_24 + A_rz_2*f_2_24 + A_rz_3*f_3_24 + A_rz_4*f_4_24 + A_rz_5*f_5_24 + A_rz_6*f_6_24);
    const pkmodes_real f_1_25 =
        -U_1_x_2*U_1_x_5 - U_1_y_2*U_1_y_5 - U_1_z_2*U_1_z_5 - t138*(D_p_ry_2*t185 - D_p_rz_2*t29)
        - t138*(D_p_ry_5*t137 - D_p_rz_5*t26) - t140*(-D_p_rx_2*t185 + D_p_rz_2*t186) - t140*(-D_p_rx_5*t137
        + D_p_rz_5*t139) - t141*(D_p_rx_2*t29 - D_p_ry_2*t186) - t141*(D_p_rx_5*t26 - D_p_ry_5*t139);
    const pkmodes_real f_2_25 =
        -U_2_x_2*U_2_x_5 - U_2_y_2*U_2_y_5 - U_2_z_2*U_2_z_5 - t142*(D_p_ry_2*t187 - D_p_rz_2*t47)
        - t142*(-D_p_ry_5*t50 - D_p_rz_5*t44) - t143*(-D_p_rx_2*t187 + D_p_rz_2*t188) - t143*(D_p_rx_5*t50
        - D_p_rz_5*t38) - t144*(D_p_rx_2*t47 - D_p_ry_2*t188) - t144*(D_p_rx_5*t44 + D_p_ry_5*t38);
    const pkmodes_real f_3_25 =
        -U_3_x_2*U_3_x_5 - U_3_y_2*U_3_y_5 - U_3_z_2*U_3_z_5 - t146*(D_p_ry_2*t189 - D_p_rz_2*t65)
        - t146*(D_p_ry_5*t145 - D_p_rz_5*t62) - t148*(-D_p_rx_2*t189 + D_p_rz_2*t190) - t148*(-D_p_rx_5*t145
        + D_p_rz_5*t147) - t149*(D_p_rx_2*t65 - D_p_ry_2*t190) - t149*(D_p_rx_5*t62 - D_p_ry_5*t147);
    const pkmodes_real f_4_25 =
        -U_4_x_2*U_4_x_5 - U_4_y_2*U_4_y_5 - U_4_z_2*U_4_z_5 - t151*(D_p_ry_2*t191 - D_p_rz_2*t83)
        - t151*(D_p_ry_5*t150 - D_p_rz_5*t80) - t153*(-D_p_rx_2*t191 + D_p_rz_2*t192) - t153*(-D_p_rx_5*t150
        + D_p_rz_5*t152) - t154*(D_p_rx_2*t83 - D_p_ry_2*t192) - t154*(D_p_rx_5*t80 - D_p_ry_5*t152);
    const pkmodes_real f_5_25 =
        -U_5_x_2*U_5_x_5 - U_5_y_2*U_5_y_5 - U_5_z_2*U_5_z_5 - t156*(-D_p_ry_2*t107 - D_p_rz_2*t101)
        - t156*(D_p_ry_5*t155 - D_p_rz_5*t98) - t158*(D_p_rx_2*t107 - D_p_rz_2*t95) - t158*(-D_p_rx_5*t155
        + D_p_rz_5*t157) - t159*(D_p_rx_2*t101 + D_p_ry_2*t95) - t159*(D_p_rx_5*t98 - D_p_ry_5*t157);
    const pkmodes_real f_6_25 =
        -U_6_x_2*U_6_x_5 - U_6_y_2*U_6_y_5 - U_6_z_2*U_6_z_5 - t161*(D_p_ry_2*t193 - D_p_rz_2*t119)
        - t161*(D_p_ry_5*t160 - D_p_rz_5*t116) - t163*(-D_p_rx_2*t193 + D_p_rz_2*t194) - t163*(-D_p_rx_5*t160
        + D_p_rz_5*t162) - t164*(D_p_rx_2*t119 - D_p_ry_2*t194) - t164*(D_p_rx_5*t116 - D_p_ry_5*t162);
    const pkmodes_real P_x_25 =
        t12*(A_x_1*f_1_25 + A_x_2*f_2_25 + A_x_3*f_3_25 + A_x_4*f_4_25 + A_x_5*f_5_25 + A_x_6*f_6_25);
    const pkmodes_real P_y_25 =
        t12*(A_y_1*f_1_25 + A_y_2*f_2_25 + A_y_3*f_3_25 + A_y_4*f_4_25 + A_y_5*f_5_25 + A_y_6*f_6_25);
    const pkmodes_real P_z_25 =
        t12*(A_z_1*f_1_25 + A_z_2*f_2_25 + A_z_3*f_3_25 + A_z_4*f_4_25 + A_z_5*f_5_25 + A_z_6*f_6_25);
    const pkmodes_real P_rx_25 =
        t12*(A_rx_1*f_1_25 + A_rx_2*f_2_25 + A_rx_3*f_3_25 + A_rx_4*f_4_25 + A_rx_5*f_5_25 + A_rx_6*f_6_25);
    const pkmodes_real P_ry_25 =
        t12*(A_ry_1*f_1_25 + A_ry_2*f_2_25 + A_ry_3*f_3_25 + A_ry_4*f_4_25 + A_ry_5*f_5_25 + A_ry_6*f_6_25);
    const pkmodes_real P_rz_25 =
        t12*(A_rz_1*f_1_25 + A_rz_2*f_2_25 + A_rz_3*f_3_25 + A_rz_4*f_4_25 + A_rz_5*f_5_25 + A_rz_6*f_6_25);
    const pkmodes_real f_1_26 =
        -U_1_x_2*U_1_x_6 - U_1_y_2*U_1_y_6 - U_1_z_2*U_1_z_6 - t138*(D_p_ry_2*t195 - D_p_rz_2*t30)
        - t138*(D_p_ry_6*t137 - D_p_rz_6*t26) - t140*(-D_p_rx_2*t195 + D_p_rz_2*t196) - t140*(-D_p_rx_6*t137
        + D_p_rz_6*t139) - t141*(D_p_rx_2*t30 - D_p_ry_2*t196) - t141*(D_p_rx_6*t26 - D_p_ry_6*t139);
    const pkmodes_real f_2_26 =
        -U_2_x_2*U_2_x_6 - U_2_y_2*U_2_y_6 - U_2_z_2*U_2_z_6 - t142*(D_p_ry_2*t197 - D_p_rz_2*t48)
        - t142*(-D_p_ry_6*t50 - D_p_rz_6*t44) - t143*(-D_p_rx_2*t197 + D_p_rz_2*t198) - t143*(D_p_rx_6*t50
        - D_p_rz_6*t38) - t144*(D_p_rx_2*t48 - D_p_ry_2*t198) - t144*(D_p_rx_6*t44 + D_p_ry_6*t38);
    const pkmodes_real f_3_26 =
        -U_3_x_2*U_3_x_6 - U_3_y_2*U_3_y_6 - U_3_z_2*U_3_z_6 - t146*(D_p_ry_2*t199 - D_p_rz_2*t66)
        - t146*(D_p_ry_6*t145 - D_p_rz_6*t62) - t148*(-D_p_rx_2*t199 + D_p_rz_2*t200) - t148*(-D_p_rx_6*t145
        + D_p_rz_6*t147) - t149*(D_p_rx_2*t66 - D_p_ry_2*t200) - t149*(D_p_rx_6*t62 - D_p_ry_6*t147);
    const pkmodes_real f_4_26 =
        -U_4_x_2*U_4_x_6 - U_4_y_2*U_4_y_6 - U_4_z_2*U_4_z_6 - t151*(D_p_ry_2*t201 - D_p_rz_2*t84)
        - t151*(D_p_ry_6*t150 - D_p_rz_6*t80) - t153*(-D_p_rx_2*t201 + D_p_rz_2*t202) - t153*(-D_p_rx_6*t150
        + D_p_rz_6*t152) - t154*(D_p_rx_2*t84 - D_p_ry_2*t202) - t154*(D_p_rx_6*t80 - D_p_ry_6*t152);
    const pkmodes_real f_5_26 =
        -U_5_x_2*U_5_x_6 - U_5_y_2*U_5_y_6 - U_5_z_2*U_5_z_6 - t156*(D_p_ry_2*t203 - D_p_rz_2*t102)
        - t156*(D_p_ry_6*t155 - D_p_rz_6*t98) - t158*(-D_p_rx_2*t203 + D_p_rz_2*t204) - t158*(-D_p_rx_6*t155
        + D_p_rz_6*t157) - t159*(D_p_rx_2*t102 - D_p_ry_2*t204) - t159*(D_p_rx_6*t98 - D_p_ry_6*t157);
    const pkmodes_real f_6_26 =
        -U_6_x_2*U_6_x_6 - U_6_y_2*U_6_y_6 - U_6_z_2*U_6_z_6 - t161*(-D_p_ry_2*t126 - D_p_rz_2*t120)
        - t161*(D_p_ry_6*t160 - D_p_rz_6*t116) - t163*(D_p_rx_2*t126 - D_p_rz_2*t114) - t163*(-D_p_rx_6*t160
        + D_p_rz_6*t162) - t164*(D_p_rx_2*t120 + D_p_ry_2*t114) - t164*(D_p_rx_6*t116 - D_p_ry_6*t162);
    const pkmodes_real P_x_26 =
        t12*(A_x_1*f_1_26 + A_x_2*f_2_26 + A_x_3*f_3_26 + A_x_4*f_4_26 + A_x_5*f_5_26 + A_x_6*f_6_26);
    const pkmodes_real P_y_26 =
        t12*(A_y_1*f_1_26 + A_y_2*f_2_26 + A_y_3*f_3_26 + A_y_4*f_4_26 + A_y_5*f_5_26 + A_y_6*f_6_26);
    const pkmodes_real P_z_26 =
        t12*(A_z_1*f_1_26 + A_z_2*f_2_26 + A_z_3*f_3_26 + A_z_4*f_4_26 + A_z_5*f_5_26 + A_z_6*f_6_26);
    const pkmodes_real P_rx_26 =
        t12*(A_rx_1*f_1_26 + A_rx_2*f_2_26 + A_rx_3*f_3_26 + A_rx_4*f_4_26 + A_rx_5*f_5_26 + A_rx_6*f_6_26);
    const pkmodes_real P_ry_26 =
        t12*(A_ry_1*f_1_26 + A_ry_2*f_2_26 + A_ry_3*f_3_26 + A_ry_4*f_4_26 + A_ry_5*f_5_26 + A_ry_6*f_6_26);
    const pkmodes_real P_rz_26 =
        t12*(A_rz_1*f_1_26 + A_rz_2*f_2_26 + A_rz_3*f_3_26 + A_rz_4*f_4_26 + A_rz_5*f_5_26 + A_rz_6*f_6_26);
    const pkmodes_real f_1_33 =
        -(U_1_x_3*U_1_x_3) - (U_1_y_3*U_1_y_3) - (U_1_z_3*U_1_z_3) - s_1_x*(D_p_ry_3*t165 - D_p_rz_3*t27)
        - s_1_y*(-D_p_rx_3*t165 + D_p_rz_3*t166) - s_1_z*(D_p_rx_3*t27 - D_p_ry_3*t166);
    const pkmodes_real f_2_33 =
        -(U_2_x_3*U_2_x_3) - (U_2_y_3*U_2_y_3) - (U_2_z_3*U_2_z_3) - s_2_x*(D_p_ry_3*t167 - D_p_rz_3*t45)
        - s_2_y*(-D_p_rx_3*t167 + D_p_rz_3*t168) - s_2_z*(D_p_rx_3*t45 - D_p_ry_3*t168);
    const pkmodes_real f_3_33 =
        -(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3) - s_3_x*(-D_p_ry_3*t69 - D_p_rz_3*t63)
        - s_3_y*(D_p_rx_3*t69 - D_p_rz_3*t57) - s_3_z*(D_p_rx_3*t63 + D_p_ry_3*t57);
    const pkmodes_real f_4_33 =
        -(U_4_x_3*U_4_x_3) - (U_4_y_3*U_4_y_3) - (U_4_z_3*U_4_z_3) - s_4_x*(D_p_ry_3*t169 - D_p_rz_3*t81)
        - s_4_y*(-D_p_rx_3*t169 + D_p_rz_3*t170) - s_4_z*(D_p_rx_3*t81 - D_p_ry_3*t170);
    const pkmodes_real f_5_33 =
        -(U_5_x_3*U_5_x_3) - (U_5_y_3*U_5_y_3) - (U_5_z_3*U_5_z_3) - s_5_x*(D_p_ry_3*t171 - D_p_rz_3*t99)
        - s_5_y*(-D_p_rx_3*t171 + D_p_rz_3*t172) - s_5_z*(D_p_rx_3*t99 - D_p_ry_3*t172);
    const pkmodes_real f_6_33 =
        -(U_6_x_3*U_6_x_3) - (U_6_y_3*U_6_y_3) - (U_6_z_3*U_6_z_3) - s_6_x*(D_p_ry_3*t173 - D_p_rz_3*t117)
        - s_6_y*(-D_p_rx_3*t173 + D_p_rz_3*t174) - s_6_z*(D_p_rx_3*t117 - D_p_ry_3*t174);
    const pkmodes_real P_x_33 =
        t12*(A_x_1*f_1_33 + A_x_2*f_2_33 + A_x_3*f_3_33 + A_x_4*f_4_33 + A_x_5*f_5_33 + A_x_6*f_6_33);
    const pkmodes_real P_y_33 =
        t12*(A_y_1*f_1_33 + A_y_2*f_2_33 + A_y_3*f_3_33 + A_y_4*f_4_33 + A_y_5*f_5_33 + A_y_6*f_6_33);
    const pkmodes_real P_z_33 =
        t12*(A_z_1*f_1_33 + A_z_2*f_2_33 + A_z_3*f_3_33 + A_z_4*f_4_33 + A_z_5*f_5_33 + A_z_6*f_6_33);
    const pkmodes_real P_rx_33 =
        t12*(A_rx_1*f_1_33 + A_rx_2*f_2_33 + A_rx_3*f_3_33 + A_rx_4*f_4_33 + A_rx_5*f_5_33 + A_rx_6*f_6_33);
    const pkmodes_real P_ry_33 =
        t12*(A_ry_1*f_1_33 + A_ry_2*f_2_33 + A_ry_3*f_3_33 + A_ry_4*f_4_33 + A_ry_5*f_5_33 + A_ry_6*f_6_33);
    const pkmodes_real P_rz_33 =
        t12*(A_rz_1*f_1_33 + A_rz_2*f_2_33 + A_rz_3*f_3_33 + A_rz_4*f_4_33 + A_rz_5*f_5_33 + A_rz_6*f_6_33);
    const pkmodes_real f_1_34 =
        -U_1_x_3*U_1_x_4 - U_1_y_3*U_1_y_4 - U_1_z_3*U_1_z_4 - t138*(D_p_ry_3*t175 - D_p_rz_3*t28)
        - t138*(D_p_ry_4*t165 - D_p_rz_4*t27) - t140*(-D_p_rx_3*t175 + D_p_rz_3*t176) - t140*(-D_p_rx_4*t165
        + D_p_rz_4*t166) - t141*(D_p_rx_3*t28 - D_p_ry_3*t176) - t141*(D_p_rx_4*t27 - D_p_ry_4*t166);
    const pkmodes_real f_2_34 =
        -U_2_x_3*U_2_x_4 - U_2_y_3*U_2_y_4 - U_2_z_3*U_2_z_4 - t142*(D_p_ry_3*t177 - D_p_rz_3*t46)
        - t142*(D_p_ry_4*t167 - D_p_rz_4*t45) - t143*(-D_p_rx_3*t177 + D_p_rz_3*t178) - t143*(-D_p_rx_4*t167
        + D_p_rz_4*t168) - t144*(D_p_rx_3*t46 - D_p_ry_3*t178) - t144*(D_p_rx_4*t45 - D_p_ry_4*t168);
    const pkmodes_real f_3_34 =
        -U_3_x_3*U_3_x_4 - U_3_y_3*U_3_y_4 - U_3_z_3*U_3_z_4 - t146*(D_p_ry_3*t179 - D_p_rz_3*t64)
        - t146*(-D_p_ry_4*t69 - D_p_rz_4*t63) - t148*(-D_p_rx_3*t179 + D_p_rz_3*t180) - t148*(D_p_rx_4*t69
        - D_p_rz_4*t57) - t149*(D_p_rx_3*t64 - D_p_ry_3*t180) - t149*(D_p_rx_4*t63 + D_p_ry_4*t57);
    const pkmodes_real f_4_34 =
        -U_4_x_3*U_4_x_4 - U_4_y_3*U_4_y_4 - U_4_z_3*U_4_z_4 - t151*(-D_p_ry_3*t88 - D_p_rz_3*t82)
        - t151*(D_p_ry_4*t169 - D_p_rz_4*t81) - t153*(D_p_rx_3*t88 - D_p_rz_3*t76) - t153*(-D_p_rx_4*t169
        + D_p_rz_4*t170) - t154*(D_p_rx_3*t82 + D_p_ry_3*t76) - t154*(D_p_rx_4*t81 - D_p_ry_4*t170);
    const pkmodes_real f_5_34 =
        -U_5_x_3*U_5_x_4 - U_5_y_3*U_5_y_4 - U_5_z_3*U_5_z_4 - t156*(D_p_ry_3*t181 - D_p_rz_3*t100)
        - t156*(D_p_ry_4*t171 - D_p_rz_4*t99) - t158*(-D_p_rx_3*t181 + D_p_rz_3*t182) - t158*(-D_p_rx_4*t171
        + D_p_rz_4*t172) - t159*(D_p_rx_3*t100 - D_p_ry_3*t182) - t159*(D_p_rx_4*t99 - D_p_ry_4*t172);
    const pkmodes_real f_6_34 =
        -U_6_x_3*U_6_x_4 - U_6_y_3*U_6_y_4 - U_6_z_3*U_6_z_4 - t161*(D_p_ry_3*t183 - D_p_rz_3*t118)
        - t161*(D_p_ry_4*t173 - D_p_rz_4*t117) - t163*(-D_p_rx_3*t183 + D_p_rz_3*t184) - t163*(-D_p_rx_4*t173
        + D_p_rz_4*t174) - t164*(D_p_rx_3*t118 - D_p_ry_3*t184) - t164*(D_p_rx_4*t117 - D_p_ry_4*t174);
    const pkmodes_real P_x_34 =
        t12*(A_x_1*f_1_34 + A_x_2*f_2_34 + A_x_3*f_3_34 + A_x_4*f_4_34 + A_x_5*f_5_34 + A_x_6*f_6_34);
    const pkmodes_real P_y_34 =
        t12*(A_y_1*f_1_34 + A_y_2*f_2_34 + A_y_3*f_3_34 + A_y_4*f_4_34 + A_y_5*f_5_34 + A_y_6*f_6_34);
    const pkmodes_real P_z_34 =
        t12*(A_z_1*f_1_34 + A_z_2*f_2_34 + A_z_3*f_3_34 + A_z_4*f_4_34 + A_z_5*f_5_34 + A_z_6*f_6_34);
    const pkmodes_real P_rx_34 =
        t12*(A_rx_1*f_1_34 + A_rx_2*f_2_34 + A_rx_3*f_3_34 + A_rx_4*f_4_34 + A_rx_5*f_5_34 + A_rx_6*f_6_34);
    const pkmodes_real P_ry_34 =
        t12*(A_ry_1*f_1_34 + A_ry_2*f_2_34 + A_ry_3*f_3_34 + A_ry_4*f_4_34 + A_ry_5*f_5_34 + A_ry_6*f_6_34);
    const pkmodes_real P_rz_34 =
        t12*(A_rz_1*f_1_34 + A_rz_2*f_2_34 + A_rz_3*f_3_34 + A_rz_4*f_4_34 + A_rz_5*f_5_34 + A_rz_6*f_6_34);
    const pkmodes_real f_1_35 =
        -U_1_x_3*U_1_x_5 - U_1_y_3*U_1_y_5 - U_1_z_3*U_1_z_5 - t138*(D_p_ry_3*t185 - D_p_rz_3*t29)
        - t138*(D_p_ry_5*t165 - D_p_rz_5*t27) - t140*(-D_p_rx_3*t185 + D_p_rz_3*t186) - t140*(-D_p_rx_5*t165
        + D_p_rz_5*t166) - t141*(D_p_rx_3*t29 - D_p_ry_3*t186) - t141*(D_p_rx_5*t27 - D_p_ry_5*t166);
    const pkmodes_real f_2_35 =
        -U_2_x_3*U_2_x_5 - U_2_y_3*U_2_y_5 - U_2_z_3*U_2_z_5 - t142*(D_p_ry_3*t187 - D_p_rz_3*t47)
        - t142*(D_p_ry_5*t167 - D_p_rz_5*t45) - t143*(-D_p_rx_3*t187 + D_p_rz_3*t188) - t143*(-D_p_rx_5*t167
        + D_p_rz_5*t168) - t144*(D_p_rx_3*t47 - D_p_ry_3*t188) - t144*(D_p_rx_5*t45 - D_p_ry_5*t168);
    const pkmodes_real f_3_35 =
        -U_3_x_3*U_3_x_5 - U_3_y_3*U_3_y_5 - U_3_z_3*U_3_z_5 - t146*(D_p_ry_3*t189 - D_p_rz_3*t65)
        - t146*(-D_p_ry_5*t69 - D_p_rz_5*t63) - t148*(-D_p_rx_3*t189 + D_p_rz_3*t190) - t148*(D_p_rx_5*t69
        - D_p_rz_5*t57) - t149*(D_p_rx_3*t65 - D_p_ry_3*t190) - t149*(D_p_rx_5*t63 + D_p_ry_5*t57);
    const pkmodes_real f_4_35 =
        -U_4_x_3*U_4_x_5 - U_4_y_3*U_4_y_5 - U_4_z_3*U_4_z_5 - t151*(D_p_ry_3*t191 - D_p_rz_3*t83)
        - t151*(D_p_ry_5*t169 - D_p_rz_5*t81) - t153*(-D_p_rx_3*t191 + D_p_rz_3*t192) - t153*(-D_p_rx_5*t169
        + D_p_rz_5*t170) - t154*(D_p_rx_3*t83 - D_p_ry_3*t192) - t154*(D_p_rx_5*t81 - D_p_ry_5*t170);
    const pkmodes_real f_5_35 =
        -U_5_x_3*U_5_x_5 - U_5_y_3*U_5_y_5 - U_5_z_3*U_5_z_5 - t156*(-D_p_ry_3*t107 - D_p_rz_3*t101)
        - t156*(D_p_ry_5*t171 - D_p_rz_5*t99) - t158*(D_p_rx_3*t107 - D_p_rz_3*t95) - t158*(-D_p_rx_5*t171
        + D_p_rz_5*t172) - t159*(D_p_rx_3*t101 + D_p_ry_3*t95) - t159*(D_p_rx_5*t99 - D_p_ry_5*t172);
    const pkmodes_real f_6_35 =
        -U_6_x_3*U_6_x_5 - U_6_y_3*U_6_y_5 - U_6_z_3*U_6_z_5 - t161*(D_p_ry_3*t193 - D_p_rz_3*t119)
        - t161*(D_p_ry_5*t173 - D_p_rz_5*t117) - t163*(-D_p_rx_3*t193 + D_p_rz_3*t194) - t163*(-D_p_rx_5*t173
        + D_p_rz_5*t174) - t164*(D_p_rx_3*t119 - D_p_ry_3*t194) - t164*(D_p_rx_5*t117 - D_p_ry_5*t174);
    const pkmodes_real P_x_35 =
        t12*(A_x_1*f_1_35 + A_x_2*f_2_35 + A_x_3*f_3_35 + A_x_4*f_4_35 + A_x_5*f_5_35 + A_x_6*f_6_35);
    const pkmodes_real P_y_35 =
        t12*(A_y_1*f_1_35 + A_y_2*f_2_35 + A_y_3*f_3_35 + A_y_4*f_4_35 + A_y_5*f_5_35 + A_y_6*f_6_35);
    const pkmodes_real P_z_35 =
        t12*(A_z_1*f_1_35 + A_z_2*f_2_35 + A_z_3*f_3_35 + A_z_4*f_4_35 + A_z_5*f_5_35 + A_z_6*f_6_35);
    const pkmodes_real P_rx_35 =
        t12*(A_rx_1*f_1_35 + A_rx_2*f_2_35 + A_rx_3*f_3_35 + A_rx_4*f_4_35 + A_rx_5*f_5_35 + A_rx_6*f_6_35);
    const pkmodes_real P_ry_35 =
        t12*(A_ry_1*f_1_35 + A_ry_2*f_2_35 + A_ry_3*f_3_35 + A_ry_4*f_4_35 + A_ry_5*f_5_35 + A_ry_6*f_6_35);
    const pkmodes_real P_rz_35 =
        t12*(A_rz_1*f_1_35 + A_rz_2*f_2_35 + A_rz_3*f_3_35 + A_rz_4*f_4_35 + A_rz_5*f_5_35 + A_rz_6*f_6_35);
    const pkmodes_real f_1_36 =
        -U_1_x_3*U_1_x_6 - U_1_y_3*U_1_y_6 - U_1_z_3*U_1_z_6 - t138*(D_p_ry_3*t195 - D_p_rz_3*t30)
        - t138*(D_p_ry_6*t165 - D_p_rz_6*t27) - t140*(-D_p_rx_3*t195 + D_p_rz_3*t196) - t140*(-D_p_rx_6*t165
        + D_p_rz_6*t166) - t141*(D_p_rx_3*t30 - D_p_ry_3*t196) - t141*(D_p_rx_6*t27 - D_p_ry_6*t166);
    const pkmodes_real f_2_36 =
        -U_2_x_3*U_2_x_6 - U_2_y_3*U_2_y_6 - U_2_z_3*U_2_z_6 - t142*(D_p_ry_3*t197 - D_p_rz_3*t48)
        - t142*(D_p_ry_6*t167 - D_p_rz_6*t45) - t143*(-D_p_rx_3*t197 + D_p_rz_3*t198) - t143*(-D_p_rx_6*t167
        + D_p_rz_6*t168) - t144*(D_p_rx_3*t48 - D_p_ry_3*t198) - t144*(D_p_rx_6*t45 - D_p_ry_6*t168);
    const pkmodes_real f_3_36 =
        -U_3_x_3*U_3_x_6 - U_3_y_3*U_3_y_6 - U_3_z_3*U_3_z_6 - t146*(D_p_ry_3*t199 - D_p_rz_3*t66)
        - t146*(-D_p_ry_6*t69 - D_p_rz_6*t63) - t148*(-D_p_rx_3*t199 + D_p_rz_3*t200) - t148*(D_p_rx_6*t69
        - D_p_rz_6*t57) - t149*(D_p_rx_3*t66 - D_p_ry_3*t200) - t149*(D_p_rx_6*t63 + D_p_ry_6*t57);
    const pkmodes_real f_4_36 =
        -U_4_x_3*U_4_x_6 - U_4_y_3*U_4_y_6 - U_4_z_3*U_4_z_6 - t151*(D_p_ry_3*t201 - D_p_rz_3*t84)
        - t151*(D_p_ry_6*t169 - D_p_rz_6*t81) - t153*(-D_p_rx_3*t201 + D_p_rz_3*t202) - t153*(-D_p_rx_6*t169
        + D_p_rz_6*t170) - t154*(D_p_rx_3*t84 - D_p_ry_3*t202) - t154*(D_p_rx_6*t81 - D_p_ry_6*t170);
    const pkmodes_real f_5_36 =
        -U_5_x_3*U_5_x_6 - U_5_y_3*U_5_y_6 - U_5_z_3*U_5_z_6 - t156*(D_p_ry_3*t203 - D_p_rz_3*t102)
        - t156*(D_p_ry_6*t171 - D_p_rz_6*t99) - t158*(-D_p_rx_3*t203 + D_p_rz_3*t204) - t158*(-D_p_rx_6*t171
        + D_p_rz_6*t172) - t159*(D_p_rx_3*t102 - D_p_ry_3*t204) - t159*(D_p_rx_6*t99 - D_p_ry_6*t172);
    const pkmodes_real f_6_36 =
        -U_6_x_3*U_6_x_6 - U_6_y_3*U_6_y_6 - U_6_z_3*U_6_z_6 - t161*(-D_p_ry_3*t126 - D_p_rz_3*t120)
        - t161*(D_p_ry_6*t173 - D_p_rz_6*t117) - t163*(D_p_rx_3*t126 - D_p_rz_3*t114) - t163*(-D_p_rx_6*t173
        + D_p_rz_6*t174) - t164*(D_p_rx_3*t120 + D_p_ry_3*t114) - t164*(D_p_rx_6*t117 - D_p_ry_6*t174);
    const pkmodes_real P_x_36 =
        t12*(A_x_1*f_1_36 + A_x_2*f_2_36 + A_x_3*f_3_36 + A_x_4*f_4_36 + A_x_5*f_5_36 + A_x_6*f_6_36);
    const pkmodes_real P_y_36 =
        t12*(A_y_1*f_1_36 + A_y_2*f_2_36 + A_y_3*f_3_36 + A_y_4*f_4_36 + A_y_5*f_5_36 + A_y_6*f_6_36);
    const pkmodes_real P_z_36 =
        t12*(A_z_1*f_1_36 + A_z_2*f_2_36 + A_z_3*f_3_36 + A_z_4*f_4_36 + A_z_5*f_5_36 + A_z_6*f_6_36);
    const pkmodes_real P_rx_36 =
        t12*(A_rx_1*f_1_36 + A_rx_2*f_2_36 + A_rx_3*f_3_36 + A_rx_4*f_4_36 + A_rx_5*f_5_36 + A_rx_6*f_6_36);
    const pkmodes_real P_ry_36 =
        t12*(A_ry_1*f_1_36 + A_ry_2*f_2_36 + A_ry_3*f_3_36 + A_ry_4*f_4_36 + A_ry_5*f_5_36 + A_ry_6*f_6_36);
    const pkmodes_real P_rz_36 =
        t12*(A_rz_1*f_1_36 + A_rz_2*f_2_36 + A_rz_3*f_3_36 + A_rz_4*f_4_36 + A_rz_5*f_5_36 + A_rz_6*f_6_36);
    const pkmodes_real f_1_44 =
        -(U_1_x_4*U_1_x_4) - (U_1_y_4*U_1_y_4) - (U_1_z_4*U_1_z_4) - s_1_x*(D_p_ry_4*t175 - D_p_rz_4*t28)
        - s_1_y*(-D_p_rx_4*t175 + D_p_rz_4*t176) - s_1_z*(D_p_rx_4*t28 - D_p_ry_4*t176);
    const pkmodes_real f_2_44 =
        -(U_2_x_4*U_2_x_4) - (U_2_y_4*U_2_y_4) - (U_2_z_4*U_2_z_4) - s_2_x*(D_p_ry_4*t177 - D_p_rz_4*t46)
        - s_2_y*(-D_p_rx_4*t177 + D_p_rz_4*t178) - s_2_z*(D_p_rx_4*t46 - D_p_ry_4*t178);
    const pkmodes_real f_3_44 =
        -(U_3_x_4*U_3_x_4) - (U_3_y_4*U_3_y_4) - (U_3_z_4*U_3_z_4) - s_3_x*(D_p_ry_4*t179 - D_p_rz_4*t64)
        - s_3_y*(-D_p_rx_4*t179 + D_p_rz_4*t180) - s_3_z*(D_p_rx_4*t64 - D_p_ry_4*t180);
    const pkmodes_real f_4_44 =
        -(U_4_x_4*U_4_x_4) - (U_4_y_4*U_4_y_4) - (U_4_z_4*U_4_z_4) - s_4_x*(-D_p_ry_4*t88 - D_p_rz_4*t82)
        - s_4_y*(D_p_rx_4*t88 - D_p_rz_4*t76) - s_4_z*(D_p_rx_4*t82 + D_p_ry_4*t76);
    const pkmodes_real f_5_44 =
        -(U_5_x_4*U_5_x_4) - (U_5_y_4*U_5_y_4) - (U_5_z_4*U_5_z_4) - s_5_x*(D_p_ry_4*t181 - D_p_rz_4*t100)
        - s_5_y*(-D_p_rx_4*t181 + D_p_rz_4*t182) - s_5_z*(D_p_rx_4*t100 - D_p_ry_4*t182);
    const pkmodes_real f_6_44 =
        -(U_6_x_4*U_6_x_4) - (U_6_y_4*U_6_y_4) - (U_6_z_4*U_6_z_4) - s_6_x*(D_p_ry_4*t183 - D_p_rz_4*t118)
        - s_6_y*(-D_p_rx_4*t183 + D_p_rz_4*t184) - s_6_z*(D_p_rx_4*t118 - D_p_ry_4*t184);
    const pkmodes_real P_x_44 =
        t12*(A_x_1*f_1_44 + A_x_2*f_2_44 + A_x_3*f_3_44 + A_x_4*f_4_44 + A_x_5*f_5_44 + A_x_6*f_6_44);
    const pkmodes_real P_y_44 =
        t12*(A_y_1*f_1_44 + A_y_2*f_2_44 + A_y_3*f_3_44 + A_y_4*f_4_44 + A_y_5*f_5_44 + A_y_6*f_6_44);
    const pkmodes_real P_z_44 =
        t12*(A_z_1*f_1_44 + A_z_2*f_2_44 + A_z_3*f_3_44 + A_z_4*f_4_44 + A_z_5*f_5_44 + A_z_6*f_6_44);
    const pkmodes_real P_rx_44 =
        t12*(A_rx_1*f_1_44 + A_rx_2*f_2_44 + A_rx_3*f_3_44 + A_rx_4*f_4_44 + A_rx_5*f_5_44 + A_rx_6*f_6_44);
    const pkmodes_real P_ry_44 =
        t12*(A_ry_1*f_1_44 + A_ry_2*f_2_44 + A_ry_3*f_3_44 + A_ry_4*f_4_44 + A_ry_5*f_5_44 + A_ry_6*f_6_44);
    const pkmodes_real P_rz_44 =
        t12*(A_rz_1*f_1_44 + A_rz_2*f_2_44 + A_rz_3*f_3_44 + A_rz_4*f_4_44 + A_rz_5*f_5_44 + A_rz_6*f_6_44);
    const pkmodes_real f_1_45 =
        -U_1_x_4*U_1_x_5 - U_1_y_4*U_1_y_5 - U_1_z_4*U_1_z_5 - t138*(D_p_ry_4*t185 - D_p_rz_4*t29)
        - t138*(D_p_ry_5*t175 - D_p_rz_5*t28) - t140*(-D_p_rx_4*t185 + D_p_rz_4*t186) - t140*(-D_p_rx_5*t175
        + D_p_rz_5*t176) - t141*(D_p_rx_4*t29 - D_p_ry_4*t186) - t141*(D_p_rx_5*t28 - D_p_ry_5*t176);
    const pkmodes_real f_2_45 =
        -U_2_x_4*U_2_x_5 - U_2_y_4*U_2_y_5 - U_2_z_4*U_2_z_5 - t142*(D_p_ry_4*t187 - D_p_rz_4*t47)
        - t142*(D_p_ry_5*t177 - D_p_rz_5*t46) - t143*(-D_p_rx_4*t187 + D_p_rz_4*t188) - t143*(-D_p_rx_5*t177
        + D_p_rz_5*t178) - t144*(D_p_rx_4*t47 - D_p_ry_4*t188) - t144*(D_p_rx_5*t46 - D_p_ry_5*t178);
    const pkmodes_real f_3_45 =
        -U_3_x_4*U_3_x_5 - U_3_y_4*U_3_y_5 - U_3_z_4*U_3_z_5 - t146*(D_p_ry_4*t189 - D_p_rz_4*t65)
        - t146*(D_p_ry_5*t179 - D_p_rz_5*t64) - t148*(-D_p_rx_4*t189 + D_p_rz_4*t190) - t148*(-D_p_rx_5*t179
        + D_p_rz_5*t180) - t149*(D_p_rx_4*t65 - D_p_ry_4*t190) - t149*(D_p_rx_5*t64 - D_p_ry_5*t180);
    const pkmodes_real f_4_45 =
        -U_4_x_4*U_4_x_5 - U_4_y_4*U_4_y_5 - U_4_z_4*U_4_z_5 - t151*(D_p_ry_4*t191 - D_p_rz_4*t83)
        - t151*(-D_p_ry_5*t88 - D_p_rz_5*t82) - t153*(-D_p_rx_4*t191 + D_p_rz_4*t192) - t153*(D_p_rx_5*t88
        - D_p_rz_5*t76) - t154*(D_p_rx_4*t83 - D_p_ry_4*t192) - t154*(D_p_rx_5*t82 + D_p_ry_5*t76);
    const pkmodes_real f_5_45 =
        -U_5_x_4*U_5_x_5 - U_5_y_4*U_5_y_5 - U_5_z_4*U_5_z_5 - t156*(-D_p_ry_4*t107 - D_p_rz_4*t101)
        - t156*(D_p_ry_5*t181 - D_p_rz_5*t100) - t158*(D_p_rx_4*t107 - D_p_rz_4*t95) - t158*(-D_p_rx_5*t181
        + D_p_rz_5*t182) - t159*(D_p_rx_4*t101 + D_p_ry_4*t95) - t159*(D_p_rx_5*t100 - D_p_ry_5*t182);
    const pkmodes_real f_6_45 =
        -U_6_x_4*U_6_x_5 - U_6_y_4*U_6_y_5 - U_6_z_4*U_6_z_5 - t161*(D_p_ry_4*t193 - D_p_rz_4*t119)
        - t161*(D_p_ry_5*t183 - D_p_rz_5*t118) - t163*(-D_p_rx_4*t193 + D_p_rz_4*t194) - t163*(-D_p_rx_5*t183
        + D_p_rz_5*t184) - t164*(D_p_rx_4*t119 - D_p_ry_4*t194) - t164*(D_p_rx_5*t118 - D_p_ry_5*t184);
    const pkmodes_real P_x_45 =
        t12*(A_x_1*f_1_45 + A_x_2*f_2_45 + A_x_3*f_3_45 + A_x_4*f_4_45 + A_x_5*f_5_45 + A_x_6*f_6_45);
    const pkmodes_real P_y_45 =
        t12*(A_y_1*f_1_45 + A_y_2*f_2_45 + A_y_3*f_3_45 + A_y_4*f_4_45 + A_y_5*f_5_45 + A_y_6*f_6_45);
    const pkmodes_real P_z_45 =
        t12*(A_z_1*f_1_45 + A_z_2*f_2_45 + A_z_3*f_3_45 + A_z_4*f_4_45 + A_z_5*f_5_45 + A_z_6*f_6_45);
    const pkmodes_real P_rx_45 =
        t12*(A_rx_1*f_1_45 + A_rx_2*f_2_45 + A_rx_3*f_3_45 + A_rx_4*f_4_45 + A_rx_5*f_5_45 + A_rx_6*f_6_45);
    const pkmodes_real P_ry_45 =
        t12*(A_ry_1*f_1_45 + A_ry_2*f_2_45 + A_ry_3*f_3_45 + A_ry_4*f_4_45 + A_ry_5*f_5_45 + A_ry_6*f_6_45);
    const pkmodes_real P_rz_45 =
        t12*(A_rz_1*f_1_45 + A_rz_2*f_2_45 + A_rz_3*f_3_45 + A_rz_4*f_4_45 + A_rz_5*f_5_45 + A_rz_6*f_6_45);
    const pkmodes_real f_1_46 =
        -U_1_x_4*U_1_x_6 - U_1_y_4*U_1_y_6 - U_1_z_4*U_1_z_6 - t138*(D_p_ry_4*t195 - D_p_rz_4*t30)
        - t138*(D_p_ry_6*t175 - D_p_rz_6*t28) - t140*(-D_p_rx_4*t195 + D_p_rz_4*t196) - t140*(-D_p_rx_6*t175
        + D_p_rz_6*t176) - t141*(D_p_rx_4*t30 - D_p_ry_4*t196) - t141*(D_p_rx_6*t28 - D_p_ry_6*t176);
    const pkmodes_real f_2_46 =
        -U_2_x_4*U_2_x_6 - U_2_y_4*U_2_y_6 - U_2_z_4*U_2_z_6 - t142*(D_p_ry_4*t197 - D_p_rz_4*t48)
        - t142*(D_p_ry_6*t177 - D_p_rz_6*t46) - t143*(-D_p_rx_4*t197 + D_p_rz_4*t198) - t143*(-D_p_rx_6*t177
        + D_p_rz_6*t178) - t144*(D_p_rx_4*t48 - D_p_ry_4*t198) - t144*(D_p_rx_6*t46 - D_p_ry_6*t178);
    const pkmodes_real f_3_46 =
        -U_3_x_4*U_3_x_6 - U_3_y_4*U_3_y_6 - U_3_z_4*U_3_z_6 - t146*(D_p_ry_4*t199 - D_p_rz_4*t66)
        - t146*(D_p_ry_6*t179 - D_p_rz_6*t64) - t148*(-D_p_rx_4*t199 + D_p_rz_4*t200) - t148*(-D_p_rx_6*t179
        + D_p_rz_6*t180) - t149*(D_p_rx_4*t66 - D_p_ry_4*t200) - t149*(D_p_rx_6*t64 - D_p_ry_6*t180);
    const pkmodes_real f_4_46 =
        -U_4_x_4*U_4_x_6 - U_4_y_4*U_4_y_6 - U_4_z_4*U_4_z_6 - t151*(D_p_ry_4*t201 - D_p_rz_4*t84)
        - t151*(-D_p_ry_6*t88 - D_p_rz_6*t82) - t153*(-D_p_rx_4*t201 + D_p_rz_4*t202) - t153*(D_p_rx_6*t88
        - D_p_rz_6*t76) - t154*(D_p_rx_4*t84 - D_p_ry_4*t202) - t154*(D_p_rx_6*t82 + D_p_ry_6*t76);
    const pkmodes_real f_5_46 =
        -U_5_x_4*U_5_x_6 - U_5_y_4*U_5_y_6 - U_5_z_4*U_5_z_6 - t156*(D_p_ry_4*t203 - D_p_rz_4*t102)
        - t156*(D_p_ry_6*t181 - D_p_rz_6*t100) - t158*(-D_p_rx_4*t203 + D_p_rz_4*t204) - t158*(-D_p_rx_6*t181
        + D_p_rz_6*t182) - t159*(D_p_rx_4*t102 - D_p_ry_4*t204) - t159*(D_p_rx_6*t100 - D_p_ry_6*t182);
    const pkmodes_real f_6_46 =
        -U_6_x_4*U_6_x_6 - U_6_y_4*U_6_y_6 - U_6_z_4*U_6_z_6 - t161*(-D_p_ry_4*t126 - D_p_rz_4*t120)
        - t161*(D_p_ry_6*t183 - D_p_rz_6*t118) - t163*(D_p_rx_4*t126 - D_p_rz_4*t114) - t163*(-D_p_rx_6*t183
        + D_p_rz_6*t184) - t164*(D_p_rx_4*t120 + D_p_ry_4*t114) - t164*(D_p_rx_6*t118 - D_p_ry_6*t184);
    const pkmodes_real P_x_46 =
        t12*(A_x_1*f_1_46 + A_x_2*f_2_46 + A_x_3*f_3_46 + A_x_4*f_4_46 + A_x_5*f_5_46 + A_x_6*f_6_46);
    const pkmodes_real P_y_46 =
        t12*(A_y_1*f_1_46 + A_y_2*f_2_46 + A_y_3*f_3_46 + A_y_4*f_4_46 + A_y_5*f_5_46 + A_y_6*f_6_46);
    const pkmodes_real P_z_46 =
        t12*(A_z_1*f_1_46 + A_z_2*f_2_46 + A_z_3*f_3_46 + A_z_4*f_4_46 + A_z_5*f_5_46 + A_z_6*f_6_46);
    const pkmodes_real P_rx_46 =
        t12*(A_rx_1*f_1_46 + A_rx_2*f_2_46 + A_rx_3*f_3_46 + A_rx_4*f_4_46 + A_rx_5*f_5_46 + A_rx_6*f_6_46);
    const pkmodes_real P_ry_46 =
        t12*(A_ry_1*f_1_46 + A_ry_2*f_2_46 + A_ry_3*f_3_46 + A_ry_4*f_4_46 + A_ry_5*f_5_46 + A_ry_6*f_6_46);
    const pkmodes_real P_rz_46 =
        t12*(A_rz_1*f_1_46 + A_rz_2*f_2_46 + A_rz_3*f_3_46 + A_rz_4*f_4_46 + A_rz_5*f_5_46 + A_rz_6*f_6_46);
    const pkmodes_real f_1_55 =
        -(U_1_x_5*U_1_x_5) - (U_1_y_5*U_1_y_5) - (U_1_z_5*U_1_z_5) - s_1_x*(D_p_ry_5*t185 - D_p_rz_5*t29)
        - s_1_y*(-D_p_rx_5*t185 + D_p_rz_5*t186) - s_1_z*(D_p_rx_5*t29 - D_p_ry_5*t186);
    const pkmodes_real f_2_55 =
        -(U_2_x_5*U_2_x_5) - (U_2_y_5*U_2_y_5) - (U_2_z_5*U_2_z_5) - s_2_x*(D_p_ry_5*t187 - D_p_rz_5*t47)
        - s_2_y*(-D_p_rx_5*t187 + D_p_rz_5*t188) - s_2_z*(D_p_rx_5*t47 - D_p_ry_5*t188);
    const pkmodes_real f_3_55 =
        -(U_3_x_5*U_3_x_5) - (U_3_y_5*U_3_y_5) - (U_3_z_5*U_3_z_5) - s_3_x*(D_p_ry_5*t189 - D_p_rz_5*t65)
        - s_3_y*(-D_p_rx_5*t189 + D_p_rz_5*t190) - s_3_z*(D_p_rx_5*t65 - D_p_ry_5*t190);
    const pkmodes_real f_4_55 =
        -(U_4_x_5*U_4_x_5) - (U_4_y_5*U_4_y_5) - (U_4_z_5*U_4_z_5) - s_4_x*(D_p_ry_5*t191 - D_p_rz_5*t83)
        - s_4_y*(-D_p_rx_5*t191 + D_p_rz_5*t192) - s_4_z*(D_p_rx_5*t83 - D_p_ry_5*t192);
    const pkmodes_real f_5_55 =
        -(U_5_x_5*U_5_x_5) - (U_5_y_5*U_5_y_5) - (U_5_z_5*U_5_z_5) - s_5_x*(-D_p_ry_5*t107 - D_p_rz_5*t101)
        - s_5_y*(D_p_rx_5*t107 - D_p_rz_5*t95) - s_5_z*(D_p_rx_5*t101 + D_p_ry_5*t95);
    const pkmodes_real f_6_55 =
        -(U_6_x_5*U_6_x_5) - (U_6_y_5*U_6_y_5) - (U_6_z_5*U_6_z_5) - s_6_x*(D_p_ry_5*t193 - D_p_rz_5*t119)
        - s_6_y*(-D_p_rx_5*t193 + D_p_rz_5*t194) - s_6_z*(D_p_rx_5*t119 - D_p_ry_5*t194);
    const pkmodes_real P_x_55 =
        t12*(A_x_1*f_1_55 + A_x_2*f_2_55 + A_x_3*f_3_55 + A_x_4*f_4_55 + A_x_5*f_5_55 + A_x_6*f_6_55);
    const pkmodes_real P_y_55 =
        t12*(A_y_1*f_1_55 + A_y_2*f_2_55 + A_y_3*f_3_55 + A_y_4*f_4_55 + A_y_5*f_5_55 + A_y_6*f_6_55);
    const pkmodes_real P_z_55 =
        t12*(A_z_1*f_1_55 + A_z_2*f_2_55 + A_z_3*f_3_55 + A_z_4*f_4_55 + A_z_5*f_5_55 + A_z_6*f_6_55);
    const pkmodes_real P_rx_55 =
        t12*(A_rx_1*f_1_55 + A_rx_2*f_2_55 + A_rx_3*f_3_55 + A_rx_4*f_4_55 + A_rx_5*f_5_55 + A_rx_6*f_6_55);
    const pkmodes_real P_ry_55 =
        t12*(A_ry_1*f_1_55 + A_ry_2*f_2_55 + A_ry_3*f_3_55 + A_ry_4*f_4_55 + A_ry_5*f_5_55 + A_ry_6*f_6_55);
    const pkmodes_real P_rz_55 =
        t12*(A_rz_1*f_1_55 + A_rz_2*f_2_55 + A_rz_3*f_3_55 + A_rz_4*f_4_55 + A_rz_5*f_5_55 + A_rz_6*f_6_55);
    const pkmodes_real f_1_56 =
        -U_1_x_5*U_1_x_6 - U_1_y_5*U_1_y_6 - U_1_z_5*U_1_z_6 - t138*(D_p_ry_5*t195 - D_p_rz_5*t30)
        - t138*(D_p_ry_6*t185 - D_p_rz_6*t29) - t140*(-D_p_rx_5*t195 + D_p_rz_5*t196) - t140*(-D_p_rx_6*t185
        + D_p_rz_6*t186) - t141*(D_p_rx_5*t30 - D_p_ry_5*t196) - t141*(D_p_rx_6*t29 - D_p_ry_6*t186);
    const pkmodes_real f_2_56 =
        -U_2_x_5*U_2_x_6 - U_2_y_5*U_2_y_6 - U_2_z_5*U_2_z_6 - t142*(D_p_ry_5*t197 - D_p_rz_5*t48)
        - t142*(D_p_ry_6*t187 - D_p_rz_6*t47) - t143*(-D_p_rx_5*t197 + D_p_rz_5*t198) - t143*(-D_p_rx_6*t187
        + D_p_rz_6*t188) - t144*(D_p_rx_5*t48 - D_p_ry_5*t198) - t144*(D_p_rx_6*t47 - D_p_ry_6*t188);
    const pkmodes_real f_3_56 =
        -U_3_x_5*U_3_x_6 - U_3_y_5*U_3_y_6 - U_3_z_5*U_3_z_6 - t146*(D_p_ry_5*t199 - D_p_rz_5*t66)
        - t146*(D_p_ry_6*t189 - D_p_rz_6*t65) - t148*(-D_p_rx_5*t199 + D_p_rz_5*t200) - t148*(-D_p_rx_6*t189
        + D_p_rz_6*t190) - t149*(D_p_rx_5*t66 - D_p_ry_5*t200) - t149*(D_p_rx_6*t65 - D_p_ry_6*t190);
    const pkmodes_real f_4_56 =
        -U_4_x_5*U_4_x_6 - U_4_y_5*U_4_y_6 - U_4_z_5*U_4_z_6 - t151*(D_p_ry_5*t201 - D_p_rz_5*t84)
        - t151*(D_p_ry_6*t191 - D_p_rz_6*t83) - t153*(-D_p_rx_5*t201 + D_p_rz_5*t202) - t153*(-D_p_rx_6*t191
        + D_p_rz_6*t192) - t154*(D_p_rx_5*t84 - D_p_ry_5*t202) - t154*(D_p_rx_6*t83 - D_p_ry_6*t192);
    const pkmodes_real f_5_56 =
        -U_5_x_5*U_5_x_6 - U_5_y_5*U_5_y_6 - U_5_z_5*U_5_z_6 - t156*(D_p_ry_5*t203 - D_p_rz_5*t102)
        - t156*(-D_p_ry_6*t107 - D_p_rz_6*t101) - t158*(-D_p_rx_5*t203 + D_p_rz_5*t204) - t158*(D_p_rx_6*t107
        - D_p_rz_6*t95) - t159*(D_p_rx_5*t102 - D_p_ry_5*t204) - t159*(D_p_rx_6*t101 + D_p_ry_6*t95);
    const pkmodes_real f_6_56 =
        -U_6_x_5*U_6_x_6 - U_6_y_5*U_6_y_6 - U_6_z_5*U_6_z_6 - t161*(-D_p_ry_5*t126 - D_p_rz_5*t120)
        - t161*(D_p_ry_6*t193 - D_p_rz_6*t119) - t163*(D_p_rx_5*t126 - D_p_rz_5*t114) - t163*(-D_p_rx_6*t193
        + D_p_rz_6*t194) - t164*(D_p_rx_5*t120 + D_p_ry_5*t114) - t164*(D_p_rx_6*t119 - D_p_ry_6*t194);
    const pkmodes_real P_x_56 =
        t12*(A_x_1*f_1_56 + A_x_2*f_2_56 + A_x_3*f_3_56 + A_x_4*f_4_56 + A_x_5*f_5_56 + A_x_6*f_6_56);
    const pkmodes_real P_y_56 =
        t12*(A_y_1*f_1_56 + A_y_2*f_2_56 + A_y_3*f_3_56 + A_y_4*f_4_56 + A_y_5*f_5_56 + A_y_6*f_6_56);
    const pkmodes_real P_z_56 =
        t12*(A_z_1*f_1_56 + A_z_2*f_2_56 + A_z_3*f_3_56 + A_z_4*f_4_56 + A_z_5*f_5_56 + A_z_6*f_6_56);
    const pkmodes_real P_rx_56 =
        t12*(A_rx_1*f_1_56 + A_rx_2*f_2_56 + A_rx_3*f_3_56 + A_rx_4*f_4_56 + A_rx_5*f_5_56 + A_rx_6*f_6_56);
    const pkmodes_real P_ry_56 =
        t12*(A_ry_1*f_1_56 + A_ry_2*f_2_56 + A_ry_3*f_3_56 + A_ry_4*f_4_56 + A_ry_5*f_5_56 + A_ry_6*f_6_56);
    const pkmodes_real P_rz_56 =
        t12*(A_rz_1*f_1_56 + A_rz_2*f_2_56 + A_rz_3*f_3_56 + A_rz_4*f_4_56 + A_rz_5*f_5_56 + A_rz_6*f_6_56);
    const pkmodes_real f_1_66 =
        -(U_1_x_6*U_1_x_6) - (U_1_y_6*U_1_y_6) - (U_1_z_6*U_1_z_6) - s_1_x*(D_p_ry_6*t195 - D_p_rz_6*t30)
        - s_1_y*(-D_p_rx_6*t195 + D_p_rz_6*t196) - s_1_z*(D_p_rx_6*t30 - D_p_ry_6*t196);
    const pkmodes_real f_2_66 =
        -(U_2_x_6*U_2_x_6) - (U_2_y_6*U_2_y_6) - (U_2_z_6*U_2_z_6) - s_2_x*(D_p_ry_6*t197 - D_p_rz_6*t48)
        - s_2_y*(-D_p_rx_6*t197 + D_p_rz_6*t198) - s_2_z*(D_p_rx_6*t48 - D_p_ry_6*t198);
    const pkmodes_real f_3_66 =
        -(U_3_x_6*U_3_x_6) - (U_3_y_6*U_3_y_6) - (U_3_z_6*U_3_z_6) - s_3_x*(D_p_ry_6*t199 - D_p_rz_6*t66)
        - s_3_y*(-D_p_rx_6*t199 + D_p_rz_6*t200) - s_3_z*(D_p_rx_6*t66 - D_p_ry_6*t200);
    const pkmodes_real f_4_66 =
        -(U_4_x_6*U_4_x_6) - (U_4_y_6*U_4_y_6) - (U_4_z_6*U_4_z_6) - s_4_x*(D_p_ry_6*t201 - D_p_rz_6*t84)
        - s_4_y*(-D_p_rx_6*t201 + D_p_rz_6*t202) - s_4_z*(D_p_rx_6*t84 - D_p_ry_6*t202);
    const pkmodes_real f_5_66 =
        -(U_5_x_6*U_5_x_6) - (U_5_y_6*U_5_y_6) - (U_5_z_6*U_5_z_6) - s_5_x*(D_p_ry_6*t203 - D_p_rz_6*t102)
        - s_5_y*(-D_p_rx_6*t203 + D_p_rz_6*t204) - s_5_z*(D_p_rx_6*t102 - D_p_ry_6*t204);
    const pkmodes_real f_6_66 =
        -(U_6_x_6*U_6_x_6) - (U_6_y_6*U_6_y_6) - (U_6_z_6*U_6_z_6) - s_6_x*(-D_p_ry_6*t126 - D_p_rz_6*t120)
        - s_6_y*(D_p_rx_6*t126 - D_p_rz_6*t114) - s_6_z*(D_p_rx_6*t120 + D_p_ry_6*t114);
    const pkmodes_real P_x_66 =
        t12*(A_x_1*f_1_66 + A_x_2*f_2_66 + A_x_3*f_3_66 + A_x_4*f_4_66 + A_x_5*f_5_66 + A_x_6*f_6_66);
    const pkmodes_real P_y_66 =
        t12*(A_y_1*f_1_66 + A_y_2*f_2_66 + A_y_3*f_3_66 + A_y_4*f_4_66 + A_y_5*f_5_66 + A_y_6*f_6_66);
    const pkmodes_real P_z_66 =
        t12*(A_z_1*f_1_66 + A_z_2*f_2_66 + A_z_3*f_3_66 + A_z_4*f_4_66 + A_z_5*f_5_66 + A_z_6*f_6_66);
    const pkmodes_real P_rx_66 =
        t12*(A_rx_1*f_1_66 + A_rx_2*f_2_66 + A_rx_3*f_3_66 + A_rx_4*f_4_66 + A_rx_5*f_5_66 + A_rx_6*f_6_66);
    const pkmodes_real P_ry_66 =
        t12*(A_ry_1*f_1_66 + A_ry_2*f_2_66 + A_ry_3*f_3_66 + A_ry_4*f_4_66 + A_ry_5*f_5_66 + A_ry_6*f_6_66);
    const pkmodes_real P_rz_66 =
        t12*(A_rz_1*f_1_66 + A_rz_2*f_2_66 + A_rz_3*f_3_66 + A_rz_4*f_4_66 + A_rz_5*f_5_66 + A_rz_6*f_6_66);
    P[0][0][0] = P_x_11;
    P[0][0][1] = P[0][1][0] = P_x_12;
    P[0][0][2] = P[0][2][0] = P_x_13;
    P[0][0][3] = P[0][3][0] = P_x_14;
    P[0][0][4] = P[0][4][0] = P_x_15;
    P[0][0][5] = P[0][5][0] = P_x_16;
    P[0][1][1] = P_x_22;
    P[0][1][2] = P[0][2][1] = P_x_23;
    P[0][1][3] = P[0][3][1] = P_x_24;
    P[0][1][4] = P[0][4][1] = P_x_25;
    P[0][1][5] = P[0][5][1] = P_x_26;
    P[0][2][2] = P_x_33;
    P[0][2][3] = P[0][3][2] = P_x_34;
    P[0][2][4] = P[0][4][2] = P_x_35;
    P[0][2][5] = P[0][5][2] = P_x_36;
    P[0][3][3] = P_x_44;
    P[0][3][4] = P[0][4][3] = P_x_45;
    P[0][3][5] = P[0][5][3] = P_x_46;
    P[0][4][4] = P_x_55;
    P[0][4][5] = P[0][5][4] = P_x_56;
    P[0][5][5] = P_x_66;
    P[1][0][0] = P_y_11;
    P[1][0][1] = P[1][1][0] = P_y_12;
    P[1][0][2] = P[1][2][0] = P_y_13;
    P[1][0][3] = P[1][3][0] = P_y_14;
    P[1][0][4] = P[1][4][0] = P_y_15;
    P[1][0][5] = P[1][5][0] = P_y_16;
    P[1][1][1] = P_y_22;
    P[1][1][2] = P[1][2][1] = P_y_23;
    P[1][1][3] = P[1][3][1] = P_y_24;
    P[1][1][4] = P[1][4][1] = P_y_25;
    P[1][1][5] = P[1][5][1] = P_y_26;
    P[1][2][2] = P_y_33;
    P[1][2][3] = P[1][3][2] = P_y_34;
    P[1][2][4] = P[1][4][2] = P_y_35;
    P[1][2][5] = P[1][5][2] = P_y_36;
    P[1][3][3] = P_y_44;
    P[1][3][4] = P[1][4][3] = P_y_45;
    P[1][3][5] = P[1][5][3] = P_y_46;
    P[1][4][4] = P_y_55;
    P[1][4][5] = P[1][5][4] = P_y_56;
    P[1][5][5] = P_y_66;
    P[2][0][0] = P_z_11;
    P[2][0][1] = P[2][1][0] = P_z_12;
    P[2][0][2] = P[2][2][0] = P_z_13;
    P[2][0][3] = P[2][3][0] = P_z_14;
    P[2][0][4] = P[2][4][0] = P_z_15;
    P[2][0][5] = P[2][5][0] = P_z_16;
    P[2][1][1] = P_z_22;
    P[2][1][2] = P[2][2][1] = P_z_23;
    P[2][1][3] = P[2][3][1] = P_z_24;
    P[2][1][4] = P[2][4][1] = P_z_25;
    P[2][1][5] = P[2][5][1] = P_z_26;
    P[2][2][2] = P_z_33;
    P[2][2][3] = P[2][3][2] = P_z_34;
    P[2][2][4] = P[2][4][2] = P_z_35;
    P[2][2][5] = P[2][5][2] = P_z_36;
    P[2][3][3] = P_z_44;
    P[2][3][4] = P[2][4][3] = P_z_45;
    P[2][3][5] = P[2][5][3] = P_z_46;
    P[2][4][4] = P_z_55;
    P[2][4][5] = P[2][5][4] = P_z_56;
    P[2][5][5] = P_z_66;
    P[3][0][0] = P_rx_11;
    P[3][0][1] = P[3][1][0] = P_rx_12;
    P[3][0][2] = P[3][2][0] = P_rx_13;
    P[3][0][3] = P[3][3][0] = P_rx_14;
    P[3][0][4] = P[3][4][0] = P_rx_15;
    P[3][0][5] = P[3][5][0] = P_rx_16;
    P[3][1][1] = P_rx_22;
    P[3][1][2] = P[3][2][1] = P_rx_23;
    P[3][1][3] = P[3][3][1] = P_rx_24;
    P[3][1][4] = P[3][4][1] = P_rx_25;
    P[3][1][5] = P[3][5][1] = P_rx_26;
    P[3][2][2] = P_rx_33;
    P[3][2][3] = P[3][3][2] = P_rx_34;
    P[3][2][4] = P[3][4][2] = P_rx_35;
    P[3][2][5] = P[3][5][2] = P_rx_36;
    P[3][3][3] = P_rx_44;
    P[3][3][4] = P[3][4][3] = P_rx_45;
    P[3][3][5] = P[3][5][3] = P_rx_46;
    P[3][4][4] = P_rx_55;
    P[3][4][5] = P[3][5][4] = P_rx_56;
    P[3][5][5] = P_rx_66;
    P[4][0][0] = P_ry_11;
    P[4][0][1] = P[4][1][0] = P_ry_12;
    P[4][0][2] = P[4][2][0] = P_ry_13;
    P[4][0][3] = P[4][3][0] = P_ry_14;
    P[4][0][4] = P[4][4][0] = P_ry_15;
    P[4][0][5] = P[4][5][0] = P_ry_16;
    P[4][1][1] = P_ry_22;
    P[4][1][2] = P[4][2][1] = P_ry_23;
    P[4][1][3] = P[4][3][1] = P_ry_24;
    P[4][1][4] = P[4][4][1] = P_ry_25;
    P[4][1][5] = P[4][5][1] = P_ry_26;
    P[4][2][2] = P_ry_33;
    P[4][2][3] = P[4][3][2] = P_ry_34;
    P[4][2][4] = P[4][4][2] = P_ry_35;
    P[4][2][5] = P[4][5][2] = P_ry_36;
    P[4][3][3] = P_ry_44;
    P[4][3][4] = P[4][4][3] = P_ry_45;
    P[4][3][5] = P[4][5][3] = P_ry_46;
    P[4][4][4] = P_ry_55;
    P[4][4][5] = P[4][5][4] = P_ry_56;
    P[4][5][5] = P_ry_66;
    P[5][0][0] = P_rz_11;
    P[5][0][1] = P[5][1][0] = P_rz_12;
    P[5][0][2] = P[5][2][0] = P_rz_13;
    P[5][0][3] = P[5][3][0] = P_rz_14;
    P[5][0][4] = P[5][4][0] = P_rz_15;
    P[5][0][5] = P[5][5][0] = P_rz_16;
    P[5][1][1] = P_rz_22;
    P[5][1][2] = P[5][2][1] = P_rz_23;
    P[5][1][3] = P[5][3][1] = P_rz_24;
    P[5][1][4] = P[5][4][1] = P_rz_25;
    P[5][1][5] = P[5][5][1] = P_rz_26;
    P[5][2][2] = P_rz_33;
    P[5][2][3] = P[5][3][2] = P_rz_34;
    P[5][2][4] = P[5][4][2] = P_rz_35;
    P[5][2][5] = P[5][5][2] = P_rz_36;
    P[5][3][3] = P_rz_44;
    P[5][3][4] = P[5][4][3] = P_rz_45;
    P[5][3][5] = P[5][5][3] = P_rz_46;
    P[5][4][4] = P_rz_55;
    P[5][4][5] = P[5][5][4] = P_rz_56;
    P[5][5][5] = P_rz_66;
}

void hexaglide_link_jacobians(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real D_d[6][3][6], pkmodes_real D_omega[6][3][6])
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
    const pkmodes_real t12 = (l_d_1*l_d_1);
    const pkmodes_real x_1 = a_1 + sigma_1*R(sqrt)(t12 - w2_1);
    const pkmodes_real a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const pkmodes_real w_2_x = -a_2*n_2_x + r_2_x;
    const pkmodes_real w_2_y = -a_2*n_2_y + r_2_y;
    const pkmodes_real w_2_z = -a_2*n_2_z + r_2_z;
    const pkmodes_real w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const pkmodes_real t13 = (l_d_2*l_d_2);
    const pkmodes_real x_2 = a_2 + sigma_2*R(sqrt)(t13 - w2_2);
    const pkmodes_real a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const pkmodes_real w_3_x = -a_3*n_3_x + r_3_x;
    const pkmodes_real w_3_y = -a_3*n_3_y + r_3_y;
    const pkmodes_real w_3_z = -a_3*n_3_z + r_3_z;
    const pkmodes_real w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const pkmodes_real t14 = (l_d_3*l_d_3);
    const pkmodes_real x_3 = a_3 + sigma_3*R(sqrt)(t14 - w2_3);
    const pkmodes_real a_4 = n_4_x*r_4_x + n_4_y*r_4_y + n_4_z*r_4_z;
    const pkmodes_real w_4_x = -a_4*n_4_x + r_4_x;
    const pkmodes_real w_4_y = -a_4*n_4_y + r_4_y;
    const pkmodes_real w_4_z = -a_4*n_4_z + r_4_z;
    const pkmodes_real w2_4 = (w_4_x*w_4_x) + (w_4_y*w_4_y) + (w_4_z*w_4_z);
    const pkmodes_real t15 = (l_d_4*l_d_4);
    const pkmodes_real x_4 = a_4 + sigma_4*R(sqrt)(t15 - w2_4);
    const pkmodes_real a_5 = n_5_x*r_5_x + n_5_y*r_5_y + n_5_z*r_5_z;
    const pkmodes_real w_5_x = -a_5*n_5_x + r_5_x;
    const pkmodes_real w_5_y = -a_5*n_5_y + r_5_y;
    const pkmodes_real w_5_z = -a_5*n_5_z + r_5_z;
    const pkmodes_real w2_5 = (w_5_x*w_5_x) + (w_5_y*w_5_y) + (w_5_z*w_5_z);
    const pkmodes_real t16 = (l_d_5*l_d_5);
    const pkmodes_real x_5 = a_5 + sigma_5*R(sqrt)(t16 - w2_5);
    const pkmodes_real a_6 = n_6_x*r_6_x + n_6_y*r_6_y + n_6_z*r_6_z;
    const pkmodes_real w_6_x = -a_6*n_6_x + r_6_x;
    const pkmodes_real w_6_y = -a_6*n_6_y + r_6_y;
    const pkmodes_real w_6_z = -a_6*n_6_z + r_6_z;
    const pkmodes_real w2_6 = (w_6_x*w_6_x) + (w_6_y*w_6_y) + (w_6_z*w_6_z);
    const pkmodes_real t17 = (l_d_6*l_d_6);
    const pkmodes_real x_6 = a_6 + sigma_6*R(sqrt)(t17 - w2_6);
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
    const pkmodes_real t18 = 1/det_D_l;
    const pkmodes_real t19 = D_r_1*t18;
    const pkmodes_real D_p_x_1 = A_x_1*t19;
    const pkmodes_real t20 = D_r_2*t18;
    const pkmodes_real D_p_x_2 = A_x_2*t20;
    const pkmodes_real t21 = D_r_3*t18;
    const pkmodes_real D_p_x_3 = A_x_3*t21;
    const pkmodes_real t22 = D_r_4*t18;
    const pkmodes_real D_p_x_4 = A_x_4*t22;
    const pkmodes_real t23 = D_r_5*t18;
    const pkmodes_real D_p_x_5 = A_x_5*t23;
    const pkmodes_real t24 = D_r_6*t18;
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
    const pkmodes_real U_1_x_1 = -B_1_y*D_p_rz_1 + B_1_z*D_p_ry_1 + D_p_x_1 - n_1_x;
    const pkmodes_real U_1_x_2 = -B_1_y*D_p_rz_2 + B_1_z*D_p_ry_2 + D_p_x_2;
    const pkmodes_real U_1_x_3 = -B_1_y*D_p_rz_3 + B_1_z*D_p_ry_3 + D_p_x_3;
    const pkmodes_real U_1_x_4 = -B_1_y*D_p_rz_4 + B_1_z*D_p_ry_4 + D_p_x_4;
    const pkmodes_real U_1_x_5 = -B_1_y*D_p_rz_5 + B_1_z*D_p_ry_5 + D_p_x_5;
    const pkmodes_real U_1_x_6 = -B_1_y*D_p_rz_6 + B_1_z*D_p_ry_6 + D_p_x_6;
    const pkmodes_real U_1_y_1 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1 + D_p_y_1 - n_1_y;
    const pkmodes_real U_1_y_2 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2 + D_p_y_2;
    const pkmodes_real U_1_y_3 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3 + D_p_y_3;
    const pkmodes_real U_1_y_4 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4 + D_p_y_4;
    const pkmodes_real U_1_y_5 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5 + D_p_y_5;
    const pkmodes_real U_1_y_6 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6 + D_p_y_6;
    const pkmodes_real U_1_z_1 = -B_1_x*D_p_ry_1 + B_1_y*D_p_rx_1 + D_p_z_1 - n_1_z;
    const pkmodes_real U_1_z_2 = -B_1_x*D_p_ry_2 + B_1_y*D_p_rx_2 + D_p_z_2;
    const pkmodes_real U_1_z_3 = -B_1_x*D_p_ry_3 + B_1_y*D_p_rx_3 + D_p_z_3;
    const pkmodes_real U_1_z_4 = -B_1_x*D_p_ry_4 + B_1_y*D_p_rx_4 + D_p_z_4;
    const pkmodes_real U_1_z_5 = -B_1_x*D_p_ry_5 + B_1_y*D_p_rx_5 + D_p_z_5;
    const pkmodes_real U_1_z_6 = -B_1_x*D_p_ry_6 + B_1_y*D_p_rx_6 + D_p_z_6;
    const pkmodes_real U_2_x_1 = -B_2_y*D_p_rz_1 + B_2_z*D_p_ry_1 + D_p_x_1;
    const pkmodes_real U_2_x_2 = -B_2_y*D_p_rz_2 + B_2_z*D_p_ry_2 + D_p_x_2 - n_2_x;
    const pkmodes_real U_2_x_3 = -B_2_y*D_p_rz_3 + B_2_z*D_p_ry_3 + D_p_x_3;
    const pkmodes_real U_2_x_4 = -B_2_y*D_p_rz_4 + B_2_z*D_p_ry_4 + D_p_x_4;
    const pkmodes_real U_2_x_5 = -B_2_y*D_p_rz_5 + B_2_z*D_p_ry_5 + D_p_x_5;
    const pkmodes_real U_2_x_6 = -B_2_y*D_p_rz_6 + B_2_z*D_p_ry_6 + D_p_x_6;
    const pkmodes_real U_2_y_1 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1 + D_p_y_1;
    const pkmodes_real U_2_y_2 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2 + D_p_y_2 - n_2_y;
    const pkmodes_real U_2_y_3 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3 + D_p_y_3;
    const pkmodes_real U_2_y_4 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4 + D_p_y_4;
    const pkmodes_real U_2_y_5 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5 + D_p_y_5;
    const pkmodes_real U_2_y_6 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6 + D_p_y_6;
    const pkmodes_real U_2_z_1 = -B_2_x*D_p_ry_1 + B_2_y*D_p_rx_1 + D_p_z_1;
    const pkmodes_real U_2_z_2 = -B_2_x*D_p_ry_2 + B_2_y*D_p_rx_2 + D_p_z_2 - n_2_z;
    const pkmodes_real U_2_z_3 = -B_2_x*D_p_ry_3 + B_2_y*D_p_rx_3 + D_p_z_3;
    const pkmodes_real U_2_z_4 = -B_2_x*D_p_ry_4 + B_2_y*D_p_rx_4 + D_p_z_4;
    const pkmodes_real U_2_z_5 = -B_2_x*D_p_ry_5 + B_2_y*D_p_rx_5 + D_p_z_5;
    const pkmodes_real U_2_z_6 = -B_2_x*D_p_ry_6 + B_2_y*D_p_rx_6 + D_p_z_6;
    const pkmodes_real U_3_x_1 = -B_3_y*D_p_rz_1 + B_3_z*D_p_ry_1 + D_p_x_1;
    const pkmodes_real U_3_x_2 = -B_3_y*D_p_rz_2 + B_3_z*D_p_ry_2 + D_p_x_2;
    const pkmodes_real U_3_x_3 = -B_3_y*D_p_rz_3 + B_3_z*D_p_ry_3 + D_p_x_3 - n_3_x;
    const pkmodes_real U_3_x_4 = -B_3_y*D_p_rz_4 + B_3_z*D_p_ry_4 + D_p_x_4;
    const pkmodes_real U_3_x_5 = -B_3_y*D_p_rz_5 + B_3_z*D_p_ry_5 + D_p_x_5;
    const pkmodes_real U_3_x_6 = -B_3_y*D_p_rz_6 + B_3_z*D_p_ry_6 + D_p_x_6;
    const pkmodes_real U_3_y_1 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1 + D_p_y_1;
    const pkmodes_real U_3_y_2 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2 + D_p_y_2;
    const pkmodes_real U_3_y_3 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3 + D_p_y_3 - n_3_y;
    const pkmodes_real U_3_y_4 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4 + D_p_y_4;
    const pkmodes_real U_3_y_5 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5 + D_p_y_5;
    const pkmodes_real U_3_y_6 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6 + D_p_y_6;
    const pkmodes_real U_3_z_1 = -B_3_x*D_p_ry_1 + B_3_y*D_p_rx_1 + D_p_z_1;
    const pkmodes_real U_3_z_2 = -B_3_x*D_p_ry_2 + B_3_y*D_p_rx_2 + D_p_z_2;
    const pkmodes_real U_3_z_3 = -B_3_x*D_p_ry_3 + B_3_y*D_p_rx_3 + D_p_z_3 - n_3_z;
    const pkmodes_real U_3_z_4 = -B_3_x*D_p_ry_4 + B_3_y*D_p_rx_4 + D_p_z_4;
    const pkmodes_real U_3_z_5 = -B_3_x*D_p_ry_5 + B_3_y*D_p_rx_5 + D_p_z_5;
    const pkmodes_real U_3_z_6 = -B_3_x*D_p_ry_6 + B_3_y*D_p_rx_6 + D_p_z_6;
    const pkmodes_real U_4_x_1 = -B_4_y*D_p_rz_1 + B_4_z*D_p_ry_1 + D_p_x_1;
    const pkmodes_real U_4_x_2 = -B_4_y*D_p_rz_2 + B_4_z*D_p_ry_2 + D_p_x_2;
    const pkmodes_real U_4_x_3 = -B_4_y*D_p_rz_3 + B_4_z*D_p_ry_3 + D_p_x_3;
    const pkmodes_real U_4_x_4 = -B_4_y*D_p_rz_4 + B_4_z*D_p_ry_4 + D_p_x_4 - n_4_x;
    const pkmodes_real U_4_x_5 = -B_4_y*D_p_rz_5 + B_4_z*D_p_ry_5 + D_p_x_5;
    const pkmodes_real U_4_x_6 = -B_4_y*D_p_rz_6 + B_4_z*D_p_ry_6 + D_p_x_6;
    const pkmodes_real U_4_y_1 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1 + D_p_y_1;
    const pkmodes_real U_4_y_2 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2 + D_p_y_2;
    const pkmodes_real U_4_y_3 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3 + D_p_y_3;
    const pkmodes_real U_4_y_4 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4 + D_p_y_4 - n_4_y;
    const pkmodes_real U_4_y_5 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5 + D_p_y_5;
    const pkmodes_real U_4_y_6 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6 + D_p_y_6;
    const pkmodes_real U_4_z_1 = -B_4_x*D_p_ry_1 + B_4_y*D_p_rx_1 + D_p_z_1;
    const pkmodes_real U_4_z_2 = -B_4_x*D_p_ry_2 + B_4_y*D_p_rx_2 + D_p_z_2;
    const pkmodes_real U_4_z_3 = -B_4_x*D_p_ry_3 + B_4_y*D_p_rx_3 + D_p_z_3;
    const pkmodes_real U_4_z_4 = -B_4_x*D_p_ry_4 + B_4_y*D_p_rx_4 + D_p_z_4 - n_4_z;
    const pkmodes_real U_4_z_5 = -B_4_x*D_p_ry_5 + B_4_y*D_p_rx_5 + D_p_z_5;
    const pkmodes_real U_4_z_6 = -B_4_x*D_p_ry_6 + B_4_y*D_p_rx_6 + D_p_z_6;
    const pkmodes_real U_5_x_1 = -B_5_y*D_p_rz_1 + B_5_z*D_p_ry_1 + D_p_x_1;
    const pkmodes_real U_5_x_2 = -B_5_y*D_p_rz_2 + B_5_z*D_p_ry_2 + D_p_x_2;
    const pkmodes_real U_5_x_3 = -B_5_y*D_p_rz_3 + B_5_z*D_p_ry_3 + D_p_x_3;
    const pkmodes_real U_5_x_4 = -B_5_y*D_p_rz_4 + B_5_z*D_p_ry_4 + D_p_x_4;
    const pkmodes_real U_5_x_5 = -B_5_y*D_p_rz_5 + B_5_z*D_p_ry_5 + D_p_x_5 - n_5_x;
    const pkmodes_real U_5_x_6 = -B_5_y*D_p_rz_6 + B_5_z*D_p_ry_6 + D_p_x_6;
    const pkmodes_real U_5_y_1 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1 + D_p_y_1;
    const pkmodes_real U_5_y_2 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2 + D_p_y_2;
    const pkmodes_real U_5_y_3 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3 + D_p_y_3;
    const pkmodes_real U_5_y_4 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4 + D_p_y_4;
    const pkmodes_real U_5_y_5 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5 + D_p_y_5 - n_5_y;
    const pkmodes_real U_5_y_6 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6 + D_p_y_6;
    const pkmodes_real U_5_z_1 = -B_5_x*D_p_ry_1 + B_5_y*D_p_rx_1 + D_p_z_1;
    const pkmodes_real U_5_z_2 = -B_5_x*D_p_ry_2 + B_5_y*D_p_rx_2 + D_p_z_2;
    const pkmodes_real U_5_z_3 = -B_5_x*D_p_ry_3 + B_5_y*D_p_rx_3 + D_p_z_3;
    const pkmodes_real U_5_z_4 = -B_5_x*D_p_ry_4 + B_5_y*D_p_rx_4 + D_p_z_4;
    const pkmodes_real U_5_z_5 = -B_5_x*D_p_ry_5 + B_5_y*D_p_rx_5 + D_p_z_5 - n_5_z;
    const pkmodes_real U_5_z_6 = -B_5_x*D_p_ry_6 + B_5_y*D_p_rx_6 + D_p_z_6;
    const pkmodes_real U_6_x_1 = -B_6_y*D_p_rz_1 + B_6_z*D_p_ry_1 + D_p_x_1;
    const pkmodes_real U_6_x_2 = -B_6_y*D_p_rz_2 + B_6_z*D_p_ry_2 + D_p_x_2;
    const pkmodes_real U_6_x_3 = -B_6_y*D_p_rz_3 + B_6_z*D_p_ry_3 + D_p_x_3;
    const pkmodes_real U_6_x_4 = -B_6_y*D_p_rz_4 + B_6_z*D_p_ry_4 + D_p_x_4;
    const pkmodes_real U_6_x_5 = -B_6_y*D_p_rz_5 + B_6_z*D_p_ry_5 + D_p_x_5;
    const pkmodes_real U_6_x_6 = -B_6_y*D_p_rz_6 + B_6_z*D_p_ry_6 + D_p_x_6 - n_6_x;
    const pkmodes_real U_6_y_1 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1 + D_p_y_1;
    const pkmodes_real U_6_y_2 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2 + D_p_y_2;
    const pkmodes_real U_6_y_3 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3 + D_p_y_3;
    const pkmodes_real U_6_y_4 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4 + D_p_y_4;
    const pkmodes_real U_6_y_5 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5 + D_p_y_5;
    const pkmodes_real U_6_y_6 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6 + D_p_y_6 - n_6_y;
    const pkmodes_real U_6_z_1 = -B_6_x*D_p_ry_1 + B_6_y*D_p_rx_1 + D_p_z_1;
    const pkmodes_real U_6_z_2 = -B_6_x*D_p_ry_2 + B_6_y*D_p_rx_2 + D_p_z_2;
    const pkmodes_real U_6_z_3 = -B_6_x*D_p_ry_3 + B_6_y*D_p_rx_3 + D_p_z_3;
    const pkmodes_real U_6_z_4 = -B_6_x*D_p_ry_4 + B_6_y*D_p_rx_4 + D_p_z_4;
    const pkmodes_real U_6_z_5 = -B_6_x*D_p_ry_5 + B_6_y*D_p_rx_5 + D_p_z_5;
    const pkmodes_real U_6_z_6 = -B_6_x*D_p_ry_6 + B_6_y*D_p_rx_6 + D_p_z_6 - n_6_z;
    const pkmodes_real t25 = 1/t12;
    const pkmodes_real t26 = 1/t13;
    const pkmodes_real t27 = 1/t14;
    const pkmodes_real t28 = 1/t15;
    const pkmodes_real t29 = 1/t16;
    const pkmodes_real t30 = 1/t17;
    D_d[0][0][0] = (R(1.0)/R(2.0))*U_1_x_1 + n_1_x;
    D_d[0][0][1] = (R(1.0)/R(2.0))*U_1_x_2;
    D_d[0][0][2] = (R(1.0)/R(2.0))*U_1_x_3;
    D_d[0][0][3] = (R(1.0)/R(2.0))*U_1_x_4;
    D_d[0][0][4] = (R(1.0)/R(2.0))*U_1_x_5;
    D_d[0][0][5] = (R(1.0)/R(2.0))*U_1_x_6;
    D_d[0][1][0] = (R(1.0)/R(2.0))*U_1_y_1 + n_1_y;
    D_d[0][1][1] = (R(1.0)/R(2.0))*U_1_y_2;
    D_d[0][1][2] = (R(1.0)/R(2.0))*U_1_y_3;
    D_d[0][1][3] = (R(1.0)/R(2.0))*U_1_y_4;
    D_d[0][1][4] = (R(1.0)/R(2.0))*U_1_y_5;
    D_d[0][1][5] = (R(1.0)/R(2.0))*U_1_y_6;
    D_d[0][2][0] = (R(1.0)/R(2.0))*U_1_z_1 + n_1_z;
    D_d[0][2][1] = (R(1.0)/R(2.0))*U_1_z_2;
    D_d[0][2][2] = (R(1.0)/R(2.0))*U_1_z_3;
    D_d[0][2][3] = (R(1.0)/R(2.0))*U_1_z_4;
    D_d[0][2][4] = (R(1.0)/R(2.0))*U_1_z_5;
    D_d[0][2][5] = (R(1.0)/R(2.0))*U_1_z_6;
    D_d[1][0][0] = (R(1.0)/R(2.0))*U_2_x_1;
    D_d[1][0][1] = (R(1.0)/R(2.0))*U_2_x_2 + n_2_x;
    D_d[1][0][2] = (R(1.0)/R(2.0))*U_2_x_3;
    D_d[1][0][3] = (R(1.0)/R(2.0))*U_2_x_4;
    D_d[1][0][4] = (R(1.0)/R(2.0))*U_2_x_5;
    D_d[1][0][5] = (R(1.0)/R(2.0))*U_2_x_6;
    D_d[1][1][0] = (R(1.0)/R(2.0))*U_2_y_1;
    D_d[1][1][1] = (R(1.0)/R(2.0))*U_2_y_2 + n_2_y;
    D_d[1][1][2] = (R(1.0)/R(2.0))*U_2_y_3;
    D_d[1][1][3] = (R(1.0)/R(2.0))*U_2_y_4;
    D_d[1][1][4] = (R(1.0)/R(2.0))*U_2_y_5;
    D_d[1][1][5] = (R(1.0)/R(2.0))*U_2_y_6;
    D_d[1][2][0] = (R(1.0)/R(2.0))*U_2_z_1;
    D_d[1][2][1] = (R(1.0)/R(2.0))*U_2_z_2 + n_2_z;
    D_d[1][2][2] = (R(1.0)/R(2.0))*U_2_z_3;
    D_d[1][2][3] = (R(1.0)/R(2.0))*U_2_z_4;
    D_d[1][2][4] = (R(1.0)/R(2.0))*U_2_z_5;
    D_d[1][2][5] = (R(1.0)/R(2.0))*U_2_z_6;
    D_d[2][0][0] = (R(1.0)/R(2.0))*U_3_x_1;
    D_d[2][0][1] = (R(1.0)/R(2.0))*U_3_x_2;
    D_d[2][0][2] = (R(1.0)/R(2.0))*U_3_x_3 + n_3_x;
    D_d[2][0][3] = (R(1.0)/R(2.0))*U_3_x_4;
    D_d[2][0][4] = (R(1.0)/R(2.0))*U_3_x_5;
    D_d[2][0][5] = (R(1.0)/R(2.0))*U_3_x_6;
    D_d[2][1][0] = (R(1.0)/R(2.0))*U_3_y_1;
    D_d[2][1][1] = (R(1.0)/R(2.0))*U_3_y_2;
    D_d[2][1][2] = (R(1.0)/R(2.0))*U_3_y_3 + n_3_y;
    D_d[2][1][3] = (R(1.0)/R(2.0))*U_3_y_4;
    D_d[2][1][4] = (R(1.0)/R(2.0))*U_3_y_5;
    D_d[2][1][5] = (R(1.0)/R(2.0))*U_3_y_6;
    D_d[2][2][0] = (R(1.0)/R(2.0))*U_3_z_1;
    D_d[2][2][1] = (R(1.0)/R(2.0))*U_3_z_2;
    D_d[2][2][2] = (R(1.0)/R(2.0))*U_3_z_3 + n_3_z;
    D_d[2][2][3] = (R(1.0)/R(2.0))*U_3_z_4;
    D_d[2][2][4] = (R(1.0)/R(2.0))*U_3_z_5;
    D_d[2][2][5] = (R(1.0)/R(2.0))*U_3_z_6;
    D_d[3][0][0] = (R(1.0)/R(2.0))*U_4_x_1;
    D_d[3][0][1] = (R(1.0)/R(2.0))*U_4_x_2;
    D_d[3][0][2] = (R(1.0)/R(2.0))*U_4_x_3;
    D_d[3][0][3] = (R(1.0)/R(2.0))*U_4_x_4 + n_4_x;
    D_d[3][0][4] = (R(1.0)/R(2.0))*U_4_x_5;
    D_d[3][0][5] = (R(1.0)/R(2.0))*U_4_x_6;
    D_d[3][1][0] = (R(1.0)/R(2.0))*U_4_y_1;
    D_d[3][1][1] = (R(1.0)/R(2.0))*U_4_y_2;
    D_d[3][1][2] = (R(1.0)/R(2.0))*U_4_y_3;
    D_d[3][1][3] = (R(1.0)/R(2.0))*U_4_y_4 + n_4_y;
    D_d[3][1][4] = (R(1.0)/R(2.0))*U_4_y_5;
    D_d[3][1][5] = (R(1.0)/R(2.0))*U_4_y_6;
    D_d[3][2][0] = (R(1.0)/R(2.0))*U_4_z_1;
    D_d[3][2][1] = (R(1.0)/R(2.0))*U_4_z_2;
    D_d[3][2][2] = (R(1.0)/R(2.0))*U_4_z_3;
    D_d[3][2][3] = (R(1.0)/R(2.0))*U_4_z_4 + n_4_z;
    D_d[3][2][4] = (R(1.0)/R(2.0))*U_4_z_5;
    D_d[3][2][5] = (R(1.0)/R(2.0))*U_4_z_6;
    D_d[4][0][0] = (R(1.0)/R(2.0))*U_5_x_1;
    D_d[4][0][1] = (R(1.0)/R(2.0))*U_5_x_2;
    D_d[4][0][2] = (R(1.0)/R(2.0))*U_5_x_3;
    D_d[4][0][3] = (R(1.0)/R(2.0))*U_5_x_4;
    D_d[4][0][4] = (R(1.0)/R(2.0))*U_5_x_5 + n_5_x;
    D_d[4][0][5] = (R(1.0)/R(2.0))*U_5_x_6;
    D_d[4][1][0] = (R(1.0)/R(2.0))*U_5_y_1;
    D_d[4][1][1] = (R(1.0)/R(2.0))*U_5_y_2;
    D_d[4][1][2] = (R(1.0)/R(2.0))*U_5_y_3;
    D_d[4][1][3] = (R(1.0)/R(2.0))*U_5_y_4;
    D_d[4][1][4] = (R(1.0)/R(2.0))*U_5_y_5 + n_5_y;
    D_d[4][1][5] = (R(1.0)/R(2.0))*U_5_y_6;
    D_d[4][2][0] = (R(1.0)/R(2.0))*U_5_z_1;
    D_d[4][2][1] = (R(1.0)/R(2.0))*U_5_z_2;
    D_d[4][2][2] = (R(1.0)/R(2.0))*U_5_z_3;
    D_d[4][2][3] = (R(1.0)/R(2.0))*U_5_z_4;
    D_d[4][2][4] = (R(1.0)/R(2.0))*U_5_z_5 + n_5_z;
    D_d[4][2][5] = (R(1.0)/R(2.0))*U_5_z_6;
    D_d[5][0][0] = (R(1.0)/R(2.0))*U_6_x_1;
    D_d[5][0][1] = (R(1.0)/R(2.0))*U_6_x_2;
    D_d[5][0][2] = (R(1.0)/R(2.0))*U_6_x_3;
    D_d[5][0][3] = (R(1.0)/R(2.0))*U_6_x_4;
    D_d[5][0][4] = (R(1.0)/R(2.0))*U_6_x_5;
    D_d[5][0][5] = (R(1.0)/R(2.0))*U_6_x_6 + n_6_x;
    D_d[5][1][0] = (R(1.0)/R(2.0))*U_6_y_1;
    D_d[5][1][1] = (R(1.0)/R(2.0))*U_6_y_2;
    D_d[5][1][2] = (R(1.0)/R(2.0))*U_6_y_3;
    D_d[5][1][3] = (R(1.0)/R(2.0))*U_6_y_4;
    D_d[5][1][4] = (R(1.0)/R(2.0))*U_6_y_5;
    D_d[5][1][5] = (R(1.0)/R(2.0))*U_6_y_6 + n_6_y;
    D_d[5][2][0] = (R(1.0)/R(2.0))*U_6_z_1;
    D_d[5][2][1] = (R(1.0)/R(2.0))*U_6_z_2;
    D_d[5][2][2] = (R(1.0)/R(2.0))*U_6_z_3;
    D_d[5][2][3] = (R(1.0)/R(2.0))*U_6_z_4;
    D_d[5][2][4] = (R(1.0)/R(2.0))*U_6_z_5;
    D_d[5][2][5] = (R(1.0)/R(2.0))*U_6_z_6 + n_6_z;
    D_omega[0][0][0] = t25*(-U_1_y_1*s_1_z + U_1_z_1*s_1_y);
    D_omega[0][0][1] = t25*(-U_1_y_2*s_1_z + U_1_z_2*s_1_y);
    D_omega[0][0][2] = t25*(-U_1_y_3*s_1_z + U_1_z_3*s_1_y);
    D_omega[0][0][3] = t25*(-U_1_y_4*s_1_z + U_1_z_4*s_1_y);
    D_omega[0][0][4] = t25*(-U_1_y_5*s_1_z + U_1_z_5*s_1_y);
    D_omega[0][0][5] = t25*(-U_1_y_6*s_1_z + U_1_z_6*s_1_y);
    D_omega[0][1][0] = t25*(U_1_x_1*s_1_z - U_1_z_1*s_1_x);
    D_omega[0][1][1] = t25*(U_1_x_2*s_1_z - U_1_z_2*s_1_x);
    D_omega[0][1][2] = t25*(U_1_x_3*s_1_z - U_1_z_3*s_1_x);
    D_omega[0][1][3] = t25*(U_1_x_4*s_1_z - U_1_z_4*s_1_x);
    D_omega[0][1][4] = t25*(U_1_x_5*s_1_z - U_1_z_5*s_1_x);
    D_omega[0][1][5] = t25*(U_1_x_6*s_1_z - U_1_z_6*s_1_x);
    D_omega[0][2][0] = t25*(-U_1_x_1*s_1_y + U_1_y_1*s_1_x);
    D_omega[0][2][1] = t25*(-U_1_x_2*s_1_y + U_1_y_2*s_1_x);
    D_omega[0][2][2] = t25*(-U_1_x_3*s_1_y + U_1_y_3*s_1_x);
    D_omega[0][2][3] = t25*(-U_1_x_4*s_1_y + U_1_y_4*s_1_x);
    D_omega[0][2][4] = t25*(-U_1_x_5*s_1_y + U_1_y_5*s_1_x);
    D_omega[0][2][5] = t25*(-U_1_x_6*s_1_y + U_1_y_6*s_1_x);
    D_omega[1][0][0] = t26*(-U_2_y_1*s_2_z + U_2_z_1*s_2_y);
    D_omega[1][0][1] = t26*(-U_2_y_2*s_2_z + U_2_z_2*s_2_y);
    D_omega[1][0][2] = t26*(-U_2_y_3*s_2_z + U_2_z_3*s_2_y);
    D_omega[1][0][3] = t26*(-U_2_y_4*s_2_z + U_2_z_4*s_2_y);
    D_omega[1][0][4] = t26*(-U_2_y_5*s_2_z + U_2_z_5*s_2_y);
    D_omega[1][0][5] = t26*(-U_2_y_6*s_2_z + U_2_z_6*s_2_y);
    D_omega[1][1][0] = t26*(U_2_x_1*s_2_z - U_2_z_1*s_2_x);
    D_omega[1][1][1] = t26*(U_2_x_2*s_2_z - U_2_z_2*s_2_x);
    D_omega[1][1][2] = t26*(U_2_x_3*s_2_z - U_2_z_3*s_2_x);
    D_omega[1][1][3] = t26*(U_2_x_4*s_2_z - U_2_z_4*s_2_x);
    D_omega[1][1][4] = t26*(U_2_x_5*s_2_z - U_2_z_5*s_2_x);
    D_omega[1][1][5] = t26*(U_2_x_6*s_2_z - U_2_z_6*s_2_x);
    D_omega[1][2][0] = t26*(-U_2_x_1*s_2_y + U_2_y_1*s_2_x);
    D_omega[1][2][1] = t26*(-U_2_x_2*s_2_y + U_2_y_2*s_2_x);
    D_omega[1][2][2] = t26*(-U_2_x_3*s_2_y + U_2_y_3*s_2_x);
    D_omega[1][2][3] = t26*(-U_2_x_4*s_2_y + U_2_y_4*s_2_x);
    D_omega[1][2][4] = t26*(-U_2_x_5*s_2_y + U_2_y_5*s_2_x);
    D_omega[1][2][5] = t26*(-U_2_x_6*s_2_y + U_2_y_6*s_2_x);
    D_omega[2][0][0] = t27*(-U_3_y_1*s_3_z + U_3_z_1*s_3_y);
    D_omega[2][0][1] = t27*(-U_3_y_2*s_3_z + U_3_z_2*s_3_y);
    D_omega[2][0][2] = t27*(-U_3_y_3*s_3_z + U_3_z_3*s_3_y);
    D_omega[2][0][3] = t27*(-U_3_y_4*s_3_z + U_3_z_4*s_3_y);
    D_omega[2][0][4] = t27*(-U_3_y_5*s_3_z + U_3_z_5*s_3_y);
    D_omega[2][0][5] = t27*(-U_3_y_6*s_3_z + U_3_z_6*s_3_y);
    D_omega[2][1][0] = t27*(U_3_x_1*s_3_z - U_3_z_1*s_3_x);
    D_omega[2][1][1] = t27*(U_3_x_2*s_3_z - U_3_z_2*s_3_x);
    D_omega[2][1][2] = t27*(U_3_x_3*s_3_z - U_3_z_3*s_3_x);
    D_omega[2][1][3] = t27*(U_3_x_4*s_3_z - U_3_z_4*s_3_x);
    D_omega[2][1][4] = t27*(U_3_x_5*s_3_z - U_3_z_5*s_3_x);
    D_omega[2][1][5] = t27*(U_3_x_6*s_3_z - U_3_z_6*s_3_x);
    D_omega[2][2][0] = t27*(-U_3_x_1*s_3_y + U_3_y_1*s_3_x);
    D_omega[2][2][1] = t27*(-U_3_x_2*s_3_y + U_3_y_2*s_3_x);
    D_omega[2][2][2] = t27*(-U_3_x_3*s_3_y + U_3_y_3*s_3_x);
    D_omega[2][2][3] = t27*(-U_3_x_4*s_3_y + U_3_y_4*s_3_x);
    D_omega[2][2][4] = t27*(-U_3_x_5*s_3_y + U_3_y_5*s_3_x);
    D_omega[2][2][5] = t27*(-U_3_x_6*s_3_y + U_3_y_6*s_3_x);
    D_omega[3][0][0] = t28*(-U_4_y_1*s_4_z + U_4_z_1*s_4_y);
    D_omega[3][0][1] = t28*(-U_4_y_2*s_4_z + U_4_z_2*s_4_y);
    D_omega[3][0][2] = t28*(-U_4_y_3*s_4_z + U_4_z_3*s_4_y);
    D_omega[3][0][3] = t28*(-U_4_y_4*s_4_z + U_4_z_4*s_4_y);
    D_omega[3][0][4] = t28*(-U_4_y_5*s_4_z + U_4_z_5*s_4_y);
    D_omega[3][0][5] = t28*(-U_4_y_6*s_4_z + U_4_z_6*s_4_y);
    D_omega[3][1][0] = t28*(U_4_x_1*s_4_z - U_4_z_1*s_4_x);
    D_omega[3][1][1] = t28*(U_4_x_2*s_4_z - U_4_z_2*s_4_x);
    D_omega[3][1][2] = t28*(U_4_x_3*s_4_z - U_4_z_3*s_4_x);
    D_omega[3][1][3] = t28*(U_4_x_4*s_4_z - U_4_z_4*s_4_x);
    D_omega[3][1][4] = t28*(U_4_x_5*s_4_z - U_4_z_5*s_4_x);
    D_omega[3][1][5] = t28*(U_4_x_6*s_4_z - U_4_z_6*s_4_x);
    D_omega[3][2][0] = t28*(-U_4_x_1*s_4_y + U_4_y_1*s_4_x);
    D_omega[3][2][1] = t28*(-U_4_x_2*s_4_y + U_4_y_2*s_4_x);
    D_omega[3][2][2] = t28*(-U_4_x_3*s_4_y + U_4_y_3*s_4_x);
    D_omega[3][2][3] = t28*(-U_4_x_4*s_4_y + U_4_y_4*s_4_x);
    D_omega[3][2][4] = t28*(-U_4_x_5*s_4_y + U_4_y_5*s_4_x);
    D_omega[3][2][5] = t28*(-U_4_x_6*s_4_y + U_4_y_6*s_4_x);
    D_omega[4][0][0] = t29*(-U_5_y_1*s_5_z + U_5_z_1*s_5_y);
    D_omega[4][0][1] = t29*(-U_5_y_2*s_5_z + U_5_z_2*s_5_y);
    D_omega[4][0][2] = t29*(-U_5_y_3*s_5_z + U_5_z_3*s_5_y);
    D_omega[4][0][3] = t29*(-U_5_y_4*s_5_z + U_5_z_4*s_5_y);
    D_omega[4][0][4] = t29*(-U_5_y_5*s_5_z + U_5_z_5*s_5_y);
    D_omega[4][0][5] = t29*(-U_5_y_6*s_5_z + U_5_z_6*s_5_y);
    D_omega[4][1][0] = t29*(U_5_x_1*s_5_z - U_5_z_1*s_5_x);
    D_omega[4][1][1] = t29*(U_5_x_2*s_5_z - U_5_z_2*s_5_x);
    D_omega[4][1][2] = t29*(U_5_x_3*s_5_z - U_5_z_3*s_5_x);
    D_omega[4][1][3] = t29*(U_5_x_4*s_5_z - U_5_z_4*s_5_x);
    D_omega[4][1][4] = t29*(U_5_x_5*s_5_z - U_5_z_5*s_5_x);
    D_omega[4][1][5] = t29*(U_5_x_6*s_5_z - U_5_z_6*s_5_x);
    D_omega[4][2][0] = t29*(-U_5_x_1*s_5_y + U_5_y_1*s_5_x);
    D_omega[4][2][1] = t29*(-U_5_x_2*s_5_y + U_5_y_2*s_5_x);
    D_omega[4][2][2] = t29*(-U_5_x_3*s_5_y + U_5_y_3*s_5_x);
    D_omega[4][2][3] = t29*(-U_5_x_4*s_5_y + U_5_y_4*s_5_x);
    D_omega[4][2][4] = t29*(-U_5_x_5*s_5_y + U_5_y_5*s_5_x);
    D_omega[4][2][5] = t29*(-U_5_x_6*s_5_y + U_5_y_6*s_5_x);
    D_omega[5][0][0] = t30*(-U_6_y_1*s_6_z + U_6_z_1*s_6_y);
    D_omega[5][0][1] = t30*(-U_6_y_2*s_6_z + U_6_z_2*s_6_y);
    D_omega[5][0][2] = t30*(-U_6_y_3*s_6_z + U_6_z_3*s_6_y);
    D_omega[5][0][3] = t30*(-U_6_y_4*s_6_z + U_6_z_4*s_6_y);
    D_omega[5][0][4] = t30*(-U_6_y_5*s_6_z + U_6_z_5*s_6_y);
    D_omega[5][0][5] = t30*(-U_6_y_6*s_6_z + U_6_z_6*s_6_y);
    D_omega[5][1][0] = t30*(U_6_x_1*s_6_z - U_6_z_1*s_6_x);
    D_omega[5][1][1] = t30*(U_6_x_2*s_6_z - U_6_z_2*s_6_x);
    D_omega[5][1][2] = t30*(U_6_x_3*s_6_z - U_6_z_3*s_6_x);
    D_omega[5][1][3] = t30*(U_6_x_4*s_6_z - U_6_z_4*s_6_x);
    D_omega[5][1][4] = t30*(U_6_x_5*s_6_z - U_6_z_5*s_6_x);
    D_omega[5][1][5] = t30*(U_6_x_6*s_6_z - U_6_z_6*s_6_x);
    D_omega[5][2][0] = t30*(-U_6_x_1*s_6_y + U_6_y_1*s_6_x);
    D_omega[5][2][1] = t30*(-U_6_x_2*s_6_y + U_6_y_2*s_6_x);
    D_omega[5][2][2] = t30*(-U_6_x_3*s_6_y + U_6_y_3*s_6_x);
    D_omega[5][2][3] = t30*(-U_6_x_4*s_6_y + U_6_y_4*s_6_x);
    D_omega[5][2][4] = t30*(-U_6_x_5*s_6_y + U_6_y_5*s_6_x);
    D_omega[5][2][5] = t30*(-U_6_x_6*s_6_y + U_6_y_6*s_6_x);
}

void hexaglide_kinetic_energy(const pkmodes_real p[6], const pkmodes_real q_dot[18],
    const hexaglide_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t)
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real x_1_dot = q_dot[0];
    const pkmodes_real x_2_dot = q_dot[1];
    const pkmodes_real x_3_dot = q_dot[2];
    const pkmodes_real x_4_dot = q_dot[3];
    const pkmodes_real x_5_dot = q_dot[4];
    const pkmodes_real x_6_dot = q_dot[5];
    const pkmodes_real theta_1_1_dot = q_dot[6];
    const pkmodes_real theta_2_1_dot = q_dot[7];
    const pkmodes_real theta_3_1_dot = q_dot[8];
    const pkmodes_real theta_4_1_dot = q_dot[9];
    const pkmodes_real theta_5_1_dot = q_dot[10];
    const pkmodes_real theta_6_1_dot = q_dot[11];
    const pkmodes_real theta_1_2_dot = q_dot[12];
    const pkmodes_real theta_2_2_dot = q_dot[13];
    const pkmodes_real theta_3_2_dot = q_dot[14];
    const pkmodes_real theta_4_2_dot = q_dot[15];
    const pkmodes_real theta_5_2_dot = q_dot[16];
    const pkmodes_real theta_6_2_dot = q_dot[17];
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
    const pkmodes_real t31 = D_r_1*t30;
    const pkmodes_real D_p_x_1 = A_x_1*t31;
    const pkmodes_real t32 = D_r_2*t30;
    const pkmodes_real D_p_x_2 = A_x_2*t32;
    const pkmodes_real t33 = D_r_3*t30;
    const pkmodes_real D_p_x_3 = A_x_3*t33;
    const pkmodes_real t34 = D_r_4*t30;
    const pkmodes_real D_p_x_4 = A_x_4*t34;
    const pkmodes_real t35 = D_r_5*t30;
    const pkmodes_real D_p_x_5 = A_x_5*t35;
    const pkmodes_real t36 = D_r_6*t30;
    const pkmodes_real D_p_x_6 = A_x_6*t36;
    const pkmodes_real D_p_y_1 = A_y_1*t31;
    const pkmodes_real D_p_y_2 = A_y_2*t32;
    const pkmodes_real D_p_y_3 = A_y_3*t33;
    const pkmodes_real D_p_y_4 = A_y_4*t34;
    const pkmodes_real D_p_y_5 = A_y_5*t35;
    const pkmodes_real D_p_y_6 = A_y_6*t36;
    const pkmodes_real D_p_z_1 = A_z_1*t31;
    const pkmodes_real D_p_z_2 = A_z_2*t32;
    const pkmodes_real D_p_z_3 = A_z_3*t33;
    const pkmodes_real D_p_z_4 = A_z_4*t34;
    const pkmodes_real D_p_z_5 = A_z_5*t35;
    const pkmodes_real D_p_z_6 = A_z_6*t36;
    const pkmodes_real D_p_rx_1 = A_rx_1*t31;
    const pkmodes_real D_p_rx_2 = A_rx_2*t32;
    const pkmodes_real D_p_rx_3 = A_rx_3*t33;
    const pkmodes_real D_p_rx_4 = A_rx_4*t34;
    const pkmodes_real D_p_rx_5 = A_rx_5*t35;
    const pkmodes_real D_p_rx_6 = A_rx_6*t36;
    const pkmodes_real D_p_ry_1 = A_ry_1*t31;
    const pkmodes_real D_p_ry_2 = A_ry_2*t32;
    const pkmodes_real D_p_ry_3 = A_ry_3*t33;
    const pkmodes_real D_p_ry_4 = A_ry_4*t34;
    const pkmodes_real D_p_ry_5 = A_ry_5*t35;
    const pkmodes_real D_p_ry_6 = A_ry_6*t36;
    const pkmodes_real D_p_rz_1 = A_rz_1*t31;
    const pkmodes_real D_p_rz_2 = A_rz_2*t32;
    const pkmodes_real D_p_rz_3 = A_rz_3*t33;
    const pkmodes_real D_p_rz_4 = A_rz_4*t34;
    const pkmodes_real D_p_rz_5 = A_rz_5*t35;
    const pkmodes_real D_p_rz_6 = A_rz_6*t36;
    const pkmodes_real t37 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t37;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t37;
    const pkmodes_real t38 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t38;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t38;
    const pkmodes_real t39 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t39;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t39;
    const pkmodes_real t40 = I_m_4*(i_g_4*i_g_4);
    const pkmodes_real I_4_1 = I_p_4 + d_4_1*t40;
    const pkmodes_real I_4_2 = I_p_4 + d_4_2*t40;
    const pkmodes_real t41 = I_m_5*(i_g_5*i_g_5);
    const pkmodes_real I_5_1 = I_p_5 + d_5_1*t41;
    const pkmodes_real I_5_2 = I_p_5 + d_5_2*t41;
    const pkmodes_real t42 = I_m_6*(i_g_6*i_g_6);
    const pkmodes_real I_6_1 = I_p_6 + d_6_1*t42;
    const pkmodes_real I_6_2 = I_p_6 + d_6_2*t42;
    const pkmodes_real v_p_x =
        D_p_x_1*x_1_dot + D_p_x_2*x_2_dot + D_p_x_3*x_3_dot + D_p_x_4*x_4_dot + D_p_x_5*x_5_dot
        + D_p_x_6*x_6_dot;
    const pkmodes_real v_p_y =
        D_p_y_1*x_1_dot + D_p_y_2*x_2_dot + D_p_y_3*x_3_dot + D_p_y_4*x_4_dot + D_p_y_5*x_5_dot
        + D_p_y_6*x_6_dot;
    const pkmodes_real v_p_z =
        D_p_z_1*x_1_dot + D_p_z_2*x_2_dot + D_p_z_3*x_3_dot + D_p_z_4*x_4_dot + D_p_z_5*x_5_dot
        + D_p_z_6*x_6_dot;
    const pkmodes_real w_p_x =
        D_p_rx_1*x_1_dot + D_p_rx_2*x_2_dot + D_p_rx_3*x_3_dot + D_p_rx_4*x_4_dot + D_p_rx_5*x_5_dot
        + D_p_rx_6*x_6_dot;
    const pkmodes_real w_p_y =
        D_p_ry_1*x_1_dot + D_p_ry_2*x_2_dot + D_p_ry_3*x_3_dot + D_p_ry_4*x_4_dot + D_p_ry_5*x_5_dot
        + D_p_ry_6*x_6_dot;
    const pkmodes_real w_p_z =
        D_p_rz_1*x_1_dot + D_p_rz_2*x_2_dot + D_p_rz_3*x_3_dot + D_p_rz_4*x_4_dot + D_p_rz_5*x_5_dot
        + D_p_rz_6*x_6_dot;
    const pkmodes_real t43 = 2*B_3_x;
    const pkmodes_real t44 = 2*B_3_y;
    const pkmodes_real t45 = 2*B_3_z;
    const pkmodes_real t46 = (B_4_y*B_4_y);
    const pkmodes_real t47 = (B_4_z*B_4_z);
    const pkmodes_real t48 = (B_4_x*B_4_x);
    const pkmodes_real t49 = 2*B_4_x;
    const pkmodes_real t50 = 2*B_4_y;
    const pkmodes_real t51 = 2*B_4_z;
    const pkmodes_real t52 = (B_5_y*B_5_y);
    const pkmodes_real t53 = (B_5_z*B_5_z);
    const pkmodes_real t54 = (B_5_x*B_5_x);
    const pkmodes_real t55 = 2*B_5_x;
    const pkmodes_real t56 = 2*B_5_y;
    const pkmodes_real t57 = 2*B_5_z;
    const pkmodes_real t58 = (B_6_y*B_6_y);
    const pkmodes_real t59 = (B_6_z*B_6_z);
    const pkmodes_real t60 = (B_6_x*B_6_x);
    const pkmodes_real t61 = 2*B_6_x;
    const pkmodes_real t62 = 2*B_6_y;
    const pkmodes_real t63 = 2*B_6_z;
    const pkmodes_real t64 = w_p_x*w_p_y;
    const pkmodes_real t65 = w_p_x*w_p_z;
    const pkmodes_real t66 = w_p_y*w_p_z;
    const pkmodes_real t67 = (w_p_x*w_p_x);
    const pkmodes_real t68 = (w_p_y*w_p_y);
    const pkmodes_real t69 = (w_p_z*w_p_z);
    const pkmodes_real t70 = (x_1_dot*x_1_dot);
    const pkmodes_real t71 = (x_2_dot*x_2_dot);
    const pkmodes_real t72 = (x_3_dot*x_3_dot);
    const pkmodes_real t73 = (x_4_dot*x_4_dot);
    const pkmodes_real t74 = (x_5_dot*x_5_dot);
    const pkmodes_real t75 = (x_6_dot*x_6_dot);
    const pkmodes_real t76 = (c_y*c_y);
    const pkmodes_real t77 = (c_z*c_z);
    const pkmodes_real t78 = (c_x*c_x);
    const pkmodes_real t79 = 2*c_x;
    const pkmodes_real t80 = v_p_z*w_p_y;
    const pkmodes_real t81 = 2*c_y;
    const pkmodes_real t82 = v_p_x*w_p_z;
    const pkmodes_real t83 = 2*c_z;
    const pkmodes_real t84 = v_p_y*w_p_x;
    const pkmodes_real t85 = v_p_y*w_p_z;
    const pkmodes_real t86 = v_p_z*w_p_x;
    const pkmodes_real t87 = v_p_x*w_p_y;
    const pkmodes_real t88 = (v_p_x*v_p_x) + (v_p_y*v_p_y) + (v_p_z*v_p_z);
    const pkmodes_real t89 = (B_1_y*B_1_y);
    const pkmodes_real t90 = (B_1_z*B_1_z);
    const pkmodes_real t91 = (B_1_x*B_1_x);
    const pkmodes_real t92 = 2*B_1_x;
    const pkmodes_real t93 = 2*B_1_y;
    const pkmodes_real t94 = 2*B_1_z;
    const pkmodes_real t95 = (B_2_y*B_2_y);
    const pkmodes_real t96 = (B_2_z*B_2_z);
    const pkmodes_real t97 = (B_2_x*B_2_x);
    const pkmodes_real t98 = 2*B_2_x;
    const pkmodes_real t99 = 2*B_2_y;
    const pkmodes_real t100 = 2*B_2_z;
    const pkmodes_real t101 = (B_3_y*B_3_y);
    const pkmodes_real t102 = (B_3_z*B_3_z);
    const pkmodes_real t103 = (B_3_x*B_3_x);
    *T_ss =
        (R(1.0)/R(2.0))*J_x_x*t67 + J_x_y*t64 + J_x_z*t65 + (R(1.0)/R(2.0))*J_y_y*t68 + J_y_z*t66
        + (R(1.0)/R(2.0))*J_z_z*t69 + (R(1.0)/R(6.0))*m_d_1*(-B_1_y*t64*t92 - B_1_z*t65*t92 - B_1_z*t66*t93
        + n_1_x*v_p_x*x_1_dot + n_1_y*v_p_y*x_1_dot + n_1_z*v_p_z*x_1_dot + t67*(t89 + t90) + t68*(t90 + t91)
        + t69*(t89 + t91) + t70 - t80*t92 - t82*t93 - t84*t94 + t85*t92 + t86*t93 + t87*t94 + t88
        + w_p_x*x_1_dot*(B_1_y*n_1_z - B_1_z*n_1_y) + w_p_y*x_1_dot*(-B_1_x*n_1_z + B_1_z*n_1_x)
        + w_p_z*x_1_dot*(B_1_x*n_1_y - B_1_y*n_1_x)) + (R(1.0)/R(6.0))*m_d_2*(-B_2_y*t64*t98 - B_2_z*t65*t98
        - B_2_z*t66*t99 + n_2_x*v_p_x*x_2_dot + n_2_y*v_p_y*x_2_dot + n_2_z*v_p_z*x_2_dot - t100*t84
        + t100*t87 + t67*(t95 + t96) + t68*(t96 + t97) + t69*(t95 + t97) + t71 - t80*t98 - t82*t99 + t85*t98
        + t86*t99 + t88 + w_p_x*x_2_dot*(B_2_y*n_2_z - B_2_z*n_2_y) + w_p_y*x_2_dot*(-B_2_x*n_2_z
        + B_2_z*n_2_x) + w_p_z*x_2_dot*(B_2_x*n_2_y - B_2_y*n_2_x)) + (R(1.0)/R(6.0))*m_d_3*(-B_3_y*t43*t64
        - B_3_z*t43*t65 - B_3_z*t44*t66 + n_3_x*v_p_x*x_3_dot + n_3_y*v_p_y*x_3_dot + n_3_z*v_p_z*x_3_dot
        - t43*t80 + t43*t85 - t44*t82 + t44*t86 - t45*t84 + t45*t87 + t67*(t101 + t102) + t68*(t102 + t103)
        + t69*(t101 + t103) + t72 + t88 + w_p_x*x_3_dot*(B_3_y*n_3_z - B_3_z*n_3_y)
        + w_p_y*x_3_dot*(-B_3_x*n_3_z + B_3_z*n_3_x) + w_p_z*x_3_dot*(B_3_x*n_3_y - B_3_y*n_3_x))
        + (R(1.0)/R(6.0))*m_d_4*(-B_4_y*t49*t64 - B_4_z*t49*t65 - B_4_z*t50*t66 + n_4_x*v_p_x*x_4_dot
        + n_4_y*v_p_y*x_4_dot + n_4_z*v_p_z*x_4_dot - t49*t80 + t49*t85 - t50*t82 + t50*t86 - t51*t84
        + t51*t87 + t67*(t46 + t47) + t68*(t47 + t48) + t69*(t46 + t48) + t73 + t88
        + w_p_x*x_4_dot*(B_4_y*n_4_z - B_4_z*n_4_y) + w_p_y*x_4_dot*(-B_4_x*n_4_z + B_4_z*n_4_x)
        + w_p_z*x_4_dot*(B_4_x*n_4_y - B_4_y*n_4_x)) + (R(1.0)/R(6.0))*m_d_5*(-B_5_y*t55*t64 - B_5_z*t55*t65
        - B_5_z*t56*t66 + n_5_x*v_p_x*x_5_dot + n_5_y*v_p_y*x_5_dot + n_5_z*v_p_z*x_5_dot - t55*t80 + t55*t85
        - t56*t82 + t56*t86 - t57*t84 + t57*t87 + t67*(t52 + t53) + t68*(t53 + t54) + t69*(t52 + t54) + t74
        + t88 + w_p_x*x_5_dot*(B_5_y*n_5_z - B_5_z*n_5_y) + w_p_y*x_5_dot*(-B_5_x*n_5_z + B_5_z*n_5_x)
        + w_p_z*x_5_dot*(B_5_x*n_5_y - B_5_y*n_5_x)) + (R(1.0)/R(6.0))*m_d_6*(-B_6_y*t61*t64 - B_6_z*t61*t65
        - B_6_z*t62*t66 + n_6_x*v_p_x*x_6_dot + n_6_y*v_p_y*x_6_dot + n_6_z*v_p_z*x_6_dot - t61*t80 + t61*t85
        - t62*t82 + t62*t86 - t63*t84 + t63*t87 + t67*(t58 + t59) + t68*(t59 + t60) + t69*(t58 + t60) + t75
        + t88 + w_p_x*x_6_dot*(B_6_y*n_6_z - B_6_z*n_6_y) + w_p_y*x_6_dot*(-B_6_x*n_6_z + B_6_z*n_6_x)
        + w_p_z*x_6_dot*(B_6_x*n_6_y - B_6_y*n_6_x)) + (R(1.0)/R(2.0))*m_p*(-c_y*t64*t79 - c_z*t65*t79
        - c_z*t66*t81 + t67*(t76 + t77) + t68*(t77 + t78) + t69*(t76 + t78) - t79*t80 + t79*t85 - t81*t82
        + t81*t86 - t83*t84 + t83*t87 + t88) + (R(1.0)/R(2.0))*m_t_1*t70 + (R(1.0)/R(2.0))*m_t_2*t71
        + (R(1.0)/R(2.0))*m_t_3*t72 + (R(1.0)/R(2.0))*m_t_4*t73 + (R(1.0)/R(2.0))*m_t_5*t74
        + (R(1.0)/R(2.0))*m_t_6*t75;
    *T_t =
        (R(1.0)/R(2.0))*I_1_1*(theta_1_1_dot*theta_1_1_dot)
        + (R(1.0)/R(2.0))*I_1_2*(theta_1_2_dot*theta_1_2_dot)
        + (R(1.0)/R(2.0))*I_2_1*(theta_2_1_dot*theta_2_1_dot)
        + (R(1.0)/R(2.0))*I_2_2*(theta_2_2_dot*theta_2_2_dot)
        + (R(1.0)/R(2.0))*I_3_1*(theta_3_1_dot*theta_3_1_dot)
        + (R(1.0)/R(2.0))*I_3_2*(theta_3_2_dot*theta_3_2_dot)
        + (R(1.0)/R(2.0))*I_4_1*(theta_4_1_dot*theta_4_1_dot)
        + (R(1.0)/R(2.0))*I_4_2*(theta_4_2_dot*theta_4_2_dot)
        + (R(1.0)/R(2.0))*I_5_1*(theta_5_1_dot*theta_5_1_dot)
        + (R(1.0)/R(2.0))*I_5_2*(theta_5_2_dot*theta_5_2_dot)
        + (R(1.0)/R(2.0))*I_6_1*(theta_6_1_dot*theta_6_1_dot)
        + (R(1.0)/R(2.0))*I_6_2*(theta_6_2_dot*theta_6_2_dot);
}

void hexaglide_mass_matrix(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real M[18][18])
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
    const pkmodes_real t31 = D_r_1*t30;
    const pkmodes_real D_p_x_1 = A_x_1*t31;
    const pkmodes_real t32 = D_r_2*t30;
    const pkmodes_real D_p_x_2 = A_x_2*t32;
    const pkmodes_real t33 = D_r_3*t30;
    const pkmodes_real D_p_x_3 = A_x_3*t33;
    const pkmodes_real t34 = D_r_4*t30;
    const pkmodes_real D_p_x_4 = A_x_4*t34;
    const pkmodes_real t35 = D_r_5*t30;
    const pkmodes_real D_p_x_5 = A_x_5*t35;
    const pkmodes_real t36 = D_r_6*t30;
    const pkmodes_real D_p_x_6 = A_x_6*t36;
    const pkmodes_real D_p_y_1 = A_y_1*t31;
    const pkmodes_real D_p_y_2 = A_y_2*t32;
    const pkmodes_real D_p_y_3 = A_y_3*t33;
    const pkmodes_real D_p_y_4 = A_y_4*t34;
    const pkmodes_real D_p_y_5 = A_y_5*t35;
    const pkmodes_real D_p_y_6 = A_y_6*t36;
    const pkmodes_real D_p_z_1 = A_z_1*t31;
    const pkmodes_real D_p_z_2 = A_z_2*t32;
    const pkmodes_real D_p_z_3 = A_z_3*t33;
    const pkmodes_real D_p_z_4 = A_z_4*t34;
    const pkmodes_real D_p_z_5 = A_z_5*t35;
    const pkmodes_real D_p_z_6 = A_z_6*t36;
    const pkmodes_real D_p_rx_1 = A_rx_1*t31;
    const pkmodes_real D_p_rx_2 = A_rx_2*t32;
    const pkmodes_real D_p_rx_3 = A_rx_3*t33;
    const pkmodes_real D_p_rx_4 = A_rx_4*t34;
    const pkmodes_real D_p_rx_5 = A_rx_5*t35;
    const pkmodes_real D_p_rx_6 = A_rx_6*t36;
    const pkmodes_real D_p_ry_1 = A_ry_1*t31;
    const pkmodes_real D_p_ry_2 = A_ry_2*t32;
    const pkmodes_real D_p_ry_3 = A_ry_3*t33;
    const pkmodes_real D_p_ry_4 = A_ry_4*t34;
    const pkmodes_real D_p_ry_5 = A_ry_5*t35;
    const pkmodes_real D_p_ry_6 = A_ry_6*t36;
    const pkmodes_real D_p_rz_1 = A_rz_1*t31;
    const pkmodes_real D_p_rz_2 = A_rz_2*t32;
    const pkmodes_real D_p_rz_3 = A_rz_3*t33;
    const pkmodes_real D_p_rz_4 = A_rz_4*t34;
    const pkmodes_real D_p_rz_5 = A_rz_5*t35;
    const pkmodes_real D_p_rz_6 = A_rz_6*t36;
    const pkmodes_real t37 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t37;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t37;
    const pkmodes_real t38 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t38;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t38;
    const pkmodes_real t39 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t39;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t39;
    const pkmodes_real t40 = I_m_4*(i_g_4*i_g_4);
    const pkmodes_real I_4_1 = I_p_4 + d_4_1*t40;
    const pkmodes_real I_4_2 = I_p_4 + d_4_2*t40;
    const pkmodes_real t41 = I_m_5*(i_g_5*i_g_5);
    const pkmodes_real I_5_1 = I_p_5 + d_5_1*t41;
    const pkmodes_real I_5_2 = I_p_5 + d_5_2*t41;
    const pkmodes_real t42 = I_m_6*(i_g_6*i_g_6);
    const pkmodes_real I_6_1 = I_p_6 + d_6_1*t42;
    const pkmodes_real I_6_2 = I_p_6 + d_6_2*t42;
    const pkmodes_real t43 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t44 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t45 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t46 = (R(1.0)/R(3.0))*m_d_4;
    const pkmodes_real t47 = (R(1.0)/R(3.0))*m_d_5;
    const pkmodes_real t48 = (R(1.0)/R(3.0))*m_d_6;
    const pkmodes_real M_p_x_x = m_p + t43 + t44 + t45 + t46 + t47 + t48;
    const pkmodes_real t49 = c_z*m_p;
    const pkmodes_real t50 = B_1_z*t43;
    const pkmodes_real t51 = B_2_z*t44;
    const pkmodes_real t52 = B_3_z*t45;
    const pkmodes_real t53 = B_4_z*t46;
    const pkmodes_real t54 = B_5_z*t47;
    const pkmodes_real t55 = B_6_z*t48;
    const pkmodes_real M_p_x_ry = t49 + t50 + t51 + t52 + t53 + t54 + t55;
    const pkmodes_real t56 = c_y*m_p;
    const pkmodes_real t57 = B_1_y*t43;
    const pkmodes_real t58 = B_2_y*t44;
    const pkmodes_real t59 = B_3_y*t45;
    const pkmodes_real t60 = B_4_y*t46;
    const pkmodes_real t61 = B_5_y*t47;
    const pkmodes_real t62 = B_6_y*t48;
    const pkmodes_real M_p_z_rx = t56 + t57 + t58 + t59 + t60 + t61 + t62;
    const pkmodes_real M_p_x_rz = -M_p_z_rx;
    const pkmodes_real M_p_y_rx = -M_p_x_ry;
    const pkmodes_real M_p_y_rz =
        B_1_x*t43 + B_2_x*t44 + B_3_x*t45 + B_4_x*t46 + B_5_x*t47 + B_6_x*t48 + c_x*m_p;
    const pkmodes_real M_p_z_ry = -M_p_y_rz;
    const pkmodes_real t63 = 2*(B_6_z*B_6_z);
    const pkmodes_real t64 = (R(1.0)/R(6.0))*m_d_6;
    const pkmodes_real t65 = 2*(c_y*c_y);
    const pkmodes_real t66 = 2*(c_z*c_z);
    const pkmodes_real t67 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real t68 = 2*(B_1_y*B_1_y);
    const pkmodes_real t69 = 2*(B_1_z*B_1_z);
    const pkmodes_real t70 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t71 = 2*(B_2_y*B_2_y);
    const pkmodes_real t72 = 2*(B_2_z*B_2_z);
    const pkmodes_real t73 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t74 = 2*(B_3_y*B_3_y);
    const pkmodes_real t75 = 2*(B_3_z*B_3_z);
    const pkmodes_real t76 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t77 = 2*(B_4_y*B_4_y);
    const pkmodes_real t78 = 2*(B_4_z*B_4_z);
    const pkmodes_real t79 = (R(1.0)/R(6.0))*m_d_4;
    const pkmodes_real t80 = 2*(B_5_y*B_5_y);
    const pkmodes_real t81 = 2*(B_5_z*B_5_z);
    const pkmodes_real t82 = (R(1.0)/R(6.0))*m_d_5;
    const pkmodes_real t83 = 2*(B_6_y*B_6_y);
    const pkmodes_real M_p_rx_rx =
        J_x_x + t64*(t63 + t83) + t67*(t65 + t66) + t70*(t68 + t69) + t73*(t71 + t72) + t76*(t74 + t75)
        + t79*(t77 + t78) + t82*(t80 + t81);
    const pkmodes_real M_p_rx_ry =
        -B_1_x*t57 - B_2_x*t58 - B_3_x*t59 - B_4_x*t60 - B_5_x*t61 - B_6_x*t62 + J_x_y - c_x*t56;
    const pkmodes_real M_p_rx_rz =
        -B_1_x*t50 - B_2_x*t51 - B_3_x*t52 - B_4_x*t53 - B_5_x*t54 - B_6_x*t55 + J_x_z - c_x*t49;
    const pkmodes_real t84 = 2*(B_1_x*B_1_x);
    const pkmodes_real t85 = 2*(B_2_x*B_2_x);
    const pkmodes_real t86 = 2*(B_3_x*B_3_x);
    const pkmodes_real t87 = 2*(B_4_x*B_4_x);
    const pkmodes_real t88 = 2*(B_5_x*B_5_x);
    const pkmodes_real t89 = 2*(B_6_x*B_6_x);
    const pkmodes_real t90 = 2*(c_x*c_x);
    const pkmodes_real M_p_ry_ry =
        J_y_y + t64*(t63 + t89) + t67*(t66 + t90) + t70*(t69 + t84) + t73*(t72 + t85) + t76*(t75 + t86)
        + t79*(t78 + t87) + t82*(t81 + t88);
    const pkmodes_real M_p_ry_rz =
        -B_1_y*t50 - B_2_y*t51 - B_3_y*t52 - B_4_y*t53 - B_5_y*t54 - B_6_y*t55 + J_y_z - c_y*t49;
    const pkmodes_real M_p_rz_rz =
        J_z_z + t64*(t83 + t89) + t67*(t65 + t90) + t70*(t68 + t84) + t73*(t71 + t85) + t76*(t74 + t86)
        + t79*(t77 + t87) + t82*(t80 + t88);
    const pkmodes_real t91 = n_1_x*t70;
    const pkmodes_real h_x_x_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x + t91;
    const pkmodes_real t92 = n_2_x*t73;
    const pkmodes_real h_x_x_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x + t92;
    const pkmodes_real t93 = n_3_x*t76;
    const pkmodes_real h_x_x_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x + t93;
    const pkmodes_real t94 = n_4_x*t79;
    const pkmodes_real h_x_x_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x + t94;
    const pkmodes_real t95 = n_5_x*t82;
    const pkmodes_real h_x_x_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x + t95;
    const pkmodes_real t96 = n_6_x*t64;
    const pkmodes_real h_x_x_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x + t96;
    const pkmodes_real t97 = n_1_y*t70;
    const pkmodes_real h_y_x_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x + t97;
    const pkmodes_real t98 = n_2_y*t73;
    const pkmodes_real h_y_x_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x + t98;
    const pkmodes_real t99 = n_3_y*t76;
    const pkmodes_real h_y_x_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x + t99;
    const pkmodes_real t100 = n_4_y*t79;
    const pkmodes_real h_y_x_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x + t100;
    const pkmodes_real t101 = n_5_y*t82;
    const pkmodes_real h_y_x_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x + t101;
    const pkmodes_real t102 = n_6_y*t64;
    const pkmodes_real h_y_x_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x + t102;
    const pkmodes_real t103 = n_1_z*t70;
    const pkmodes_real h_z_x_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x + t103;
    const pkmodes_real t104 = n_2_z*t73;
    const pkmodes_real h_z_x_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x + t104;
    const pkmodes_real t105 = n_3_z*t76;
    const pkmodes_real h_z_x_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x + t105;
    const pkmodes_real t106 = n_4_z*t79;
    const pkmodes_real h_z_x_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x + t106;
    const pkmodes_real t107 = n_5_z*t82;
    const pkmodes_real h_z_x_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x + t107;
    const pkmodes_real t108 = n_6_z*t64;
    const pkmodes_real h_z_x_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x + t108;
    const pkmodes_real t109 = t70*(B_1_y*n_1_z - B_1_z*n_1_y);
    const pkmodes_real h_rx_x_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx
        + t109;
    const pkmodes_real t110 = t73*(B_2_y*n_2_z - B_2_z*n_2_y);
    const pkmodes_real h_rx_x_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx
        + t110;
    const pkmodes_real t111 = t76*(B_3_y*n_3_z - B_3_z*n_3_y);
    const pkmodes_real h_rx_x_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx
        + t111;
    const pkmodes_real t112 = t79*(B_4_y*n_4_z - B_4_z*n_4_y);
    const pkmodes_real h_rx_x_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx
        + t112;
    const pkmodes_real t113 = t82*(B_5_y*n_5_z - B_5_z*n_5_y);
    const pkmodes_real h_rx_x_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx
        + t113;
    const pkmodes_real t114 = t64*(B_6_y*n_6_z - B_6_z*n_6_y);
    const pkmodes_real h_rx_x_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx
        + t114;
    const pkmodes_real t115 = t70*(-B_1_x*n_1_z + B_1_z*n_1_x);
    const pkmodes_real h_ry_x_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry
        + t115;
    const pkmodes_real t116 = t73*(-B_2_x*n_2_z + B_2_z*n_2_x);
    const pkmodes_real h_ry_x_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry
        + t116;
    const pkmodes_real t117 = t76*(-B_3_x*n_3_z + B_3_z*n_3_x);
    const pkmodes_real h_ry_x_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry
        + t117;
    const pkmodes_real t118 = t79*(-B_4_x*n_4_z + B_4_z*n_4_x);
    const pkmodes_real h_ry_x_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry
        + t118;
    const pkmodes_real t119 = t82*(-B_5_x*n_5_z + B_5_z*n_5_x);
    const pkmodes_real h_ry_x_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry
        + t119;
    const pkmodes_real t120 = t64*(-B_6_x*n_6_z + B_6_z*n_6_x);
    const pkmodes_real h_ry_x_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry
        + t120;
    const pkmodes_real t121 = t70*(B_1_x*n_1_y - B_1_y*n_1_x);
    const pkmodes_real h_rz_x_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz
        + t121;
    const pkmodes_real t122 = t73*(B_2_x*n_2_y - B_2_y*n_2_x);
    const pkmodes_real h_rz_x_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz
        + t122;
    const pkmodes_real t123 = t76*(B_3_x*n_3_y - B_3_y*n_3_x);
    const pkmodes_real h_rz_x_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz
        + t123;
    const pkmodes_real t124 = t79*(B_4_x*n_4_y - B_4_y*n_4_x);
    const pkmodes_real h_rz_x_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz
        + t124;
    const pkmodes_real t125 = t82*(B_5_x*n_5_y - B_5_y*n_5_x);
    const pkmodes_real h_rz_x_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz
        + t125;
    const pkmodes_real t126 = t64*(B_6_x*n_6_y - B_6_y*n_6_x);
    const pkmodes_real h_rz_x_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz
        + t126;
    memset(M, 0, sizeof(pkmodes_real[18][18]));
    M[0][0] =
        D_p_rx_1*h_rx_x_1 + D_p_rx_1*t109 + D_p_ry_1*h_ry_x_1 + D_p_ry_1*t115 + D_p_rz_1*h_rz_x_1
        + D_p_rz_1*t121 + D_p_x_1*h_x_x_1 + D_p_x_1*t91 + D_p_y_1*h_y_x_1 + D_p_y_1*t97 + D_p_z_1*h_z_x_1
        + D_p_z_1*t103 + m_t_1 + t43;
    M[0][1] = M[1][0] =
        D_p_rx_1*h_rx_x_2 + D_p_rx_2*t109 + D_p_ry_1*h_ry_x_2 + D_p_ry_2*t115 + D_p_rz_1*h_rz_x_2
        + D_p_rz_2*t121 + D_p_x_1*h_x_x_2 + D_p_x_2*t91 + D_p_y_1*h_y_x_2 + D_p_y_2*t97 + D_p_z_1*h_z_x_2
        + D_p_z_2*t103;
    M[0][2] = M[2][0] =
        D_p_rx_1*h_rx_x_3 + D_p_rx_3*t109 + D_p_ry_1*h_ry_x_3 + D_p_ry_3*t115 + D_p_rz_1*h_rz_x_3
        + D_p_rz_3*t121 + D_p_x_1*h_x_x_3 + D_p_x_3*t91 + D_p_y_1*h_y_x_3 + D_p_y_3*t97 + D_p_z_1*h_z_x_3
        + D_p_z_3*t103;
    M[0][3] = M[3][0] =
        D_p_rx_1*h_rx_x_4 + D_p_rx_4*t109 + D_p_ry_1*h_ry_x_4 + D_p_ry_4*t115 + D_p_rz_1*h_rz_x_4
        + D_p_rz_4*t121 + D_p_x_1*h_x_x_4 + D_p_x_4*t91 + D_p_y_1*h_y_x_4 + D_p_y_4*t97 + D_p_z_1*h_z_x_4
        + D_p_z_4*t103;
    M[0][4] = M[4][0] =
        D_p_rx_1*h_rx_x_5 + D_p_rx_5*t109 + D_p_ry_1*h_ry_x_5 + D_p_ry_5*t115 + D_p_rz_1*h_rz_x_5
        + D_p_rz_5*t121 + D_p_x_1*h_x_x_5 + D_p_x_5*t91 + D_p_y_1*h_y_x_5 + D_p_y_5*t97 + D_p_z_1*h_z_x_5
        + D_p_z_5*t103;
    M[0][5] = M[5][0] =
        D_p_rx_1*h_rx_x_6 + D_p_rx_6*t109 + D_p_ry_1*h_ry_x_6 + D_p_ry_6*t115 + D_p_rz_1*h_rz_x_6
        + D_p_rz_6*t121 + D_p_x_1*h_x_x_6 + D_p_x_6*t91 + D_p_y_1*h_y_x_6 + D_p_y_6*t97 + D_p_z_1*h_z_x_6
        + D_p_z_6*t103;
    M[1][1] =
        D_p_rx_2*h_rx_x_2 + D_p_rx_2*t110 + D_p_ry_2*h_ry_x_2 + D_p_ry_2*t116 + D_p_rz_2*h_rz_x_2
        + D_p_rz_2*t122 + D_p_x_2*h_x_x_2 + D_p_x_2*t92 + D_p_y_2*h_y_x_2 + D_p_y_2*t98 + D_p_z_2*h_z_x_2
        + D_p_z_2*t104 + m_t_2 + t44;
    M[1][2] = M[2][1] =
        D_p_rx_2*h_rx_x_3 + D_p_rx_3*t110 + D_p_ry_2*h_ry_x_3 + D_p_ry_3*t116 + D_p_rz_2*h_rz_x_3
        + D_p_rz_3*t122 + D_p_x_2*h_x_x_3 + D_p_x_3*t92 + D_p_y_2*h_y_x_3 + D_p_y_3*t98 + D_p_z_2*h_z_x_3
        + D_p_z_3*t104;
    M[1][3] = M[3][1] =
        D_p_rx_2*h_rx_x_4 + D_p_rx_4*t110 + D_p_ry_2*h_ry_x_4 + D_p_ry_4*t116 + D_p_rz_2*h_rz_x_4
        + D_p_rz_4*t122 + D_p_x_2*h_x_x_4 + D_p_x_4*t92 + D_p_y_2*h_y_x_4 + D_p_y_4*t98 + D_p_z_2*h_z_x_4
        + D_p_z_4*t104;
    M[1][4] = M[4][1] =
        D_p_rx_2*h_rx_x_5 + D_p_rx_5*t110 + D_p_ry_2*h_ry_x_5 + D_p_ry_5*t116 + D_p_rz_2*h_rz_x_5
        + D_p_rz_5*t122 + D_p_x_2*h_x_x_5 + D_p_x_5*t92 + D_p_y_2*h_y_x_5 + D_p_y_5*t98 + D_p_z_2*h_z_x_5
        + D_p_z_5*t104;
    M[1][5] = M[5][1] =
        D_p_rx_2*h_rx_x_6 + D_p_rx_6*t110 + D_p_ry_2*h_ry_x_6 + D_p_ry_6*t116 + D_p_rz_2*h_rz_x_6
        + D_p_rz_6*t122 + D_p_x_2*h_x_x_6 + D_p_x_6*t92 + D_p_y_2*h_y_x_6 + D_p_y_6*t98 + D_p_z_2*h_z_x_6
        + D_p_z_6*t104;
    M[2][2] =
        D_p_rx_3*h_rx_x_3 + D_p_rx_3*t111 + D_p_ry_3*h_ry_x_3 + D_p_ry_3*t117 + D_p_rz_3*h_rz_x_3
        + D_p_rz_3*t123 + D_p_x_3*h_x_x_3 + D_p_x_3*t93 + D_p_y_3*h_y_x_3 + D_p_y_3*t99 + D_p_z_3*h_z_x_3
        + D_p_z_3*t105 + m_t_3 + t45;
    M[2][3] = M[3][2] =
        D_p_rx_3*h_rx_x_4 + D_p_rx_4*t111 + D_p_ry_3*h_ry_x_4 + D_p_ry_4*t117 + D_p_rz_3*h_rz_x_4
        + D_p_rz_4*t123 + D_p_x_3*h_x_x_4 + D_p_x_4*t93 + D_p_y_3*h_y_x_4 + D_p_y_4*t99 + D_p_z_3*h_z_x_4
        + D_p_z_4*t105;
    M[2][4] = M[4][2] =
        D_p_rx_3*h_rx_x_5 + D_p_rx_5*t111 + D_p_ry_3*h_ry_x_5 + D_p_ry_5*t117 + D_p_rz_3*h_rz_x_5
        + D_p_rz_5*t123 + D_p_x_3*h_x_x_5 + D_p_x_5*t93 + D_p_y_3*h_y_x_5 + D_p_y_5*t99 + D_p_z_3*h_z_x_5
        + D_p_z_5*t105;
    M[2][5] = M[5][2] =
        D_p_rx_3*h_rx_x_6 + D_p_rx_6*t111 + D_p_ry_3*h_ry_x_6 + D_p_ry_6*t117 + D_p_rz_3*h_rz_x_6
        + D_p_rz_6*t123 + D_p_x_3*h_x_x_6 + D_p_x_6*t93 + D_p_y_3*h_y_x_6 + D_p_y_6*t99 + D_p_z_3*h_z_x_6
        + D_p_z_6*t105;
    M[3][3] =
        D_p_rx_4*h_rx_x_4 + D_p_rx_4*t112 + D_p_ry_4*h_ry_x_4 + D_p_ry_4*t118 + D_p_rz_4*h_rz_x_4
        + D_p_rz_4*t124 + D_p_x_4*h_x_x_4 + D_p_x_4*t94 + D_p_y_4*h_y_x_4 + D_p_y_4*t100 + D_p_z_4*h_z_x_4
        + D_p_z_4*t106 + m_t_4 + t46;
    M[3][4] = M[4][3] =
        D_p_rx_4*h_rx_x_5 + D_p_rx_5*t112 + D_p_ry_4*h_ry_x_5 + D_p_ry_5*t118 + D_p_rz_4*h_rz_x_5
        + D_p_rz_5*t124 + D_p_x_4*h_x_x_5 + D_p_x_5*t94 + D_p_y_4*h_y_x_5 + D_p_y_5*t100 + D_p_z_4*h_z_x_5
        + D_p_z_5*t106;
    M[3][5] = M[5][3] =
        D_p_rx_4*h_rx_x_6 + D_p_rx_6*t112 + D_p_ry_4*h_ry_x_6 + D_p_ry_6*t118 + D_p_rz_4*h_rz_x_6
        + D_p_rz_6*t124 + D_p_x_4*h_x_x_6 + D_p_x_6*t94 + D_p_y_4*h_y_x_6 + D_p_y_6*t100 + D_p_z_4*h_z_x_6
        + D_p_z_6*t106;
    M[4][4] =
        D_p_rx_5*h_rx_x_5 + D_p_rx_5*t113 + D_p_ry_5*h_ry_x_5 + D_p_ry_5*t119 + D_p_rz_5*h_rz_x_5
        + D_p_rz_5*t125 + D_p_x_5*h_x_x_5 + D_p_x_5*t95 + D_p_y_5*h_y_x_5 + D_p_y_5*t101 + D_p_z_5*h_z_x_5
        + D_p_z_5*t107 + m_t_5 + t47;
    M[4][5] = M[5][4] =
        D_p_rx_5*h_rx_x_6 + D_p_rx_6*t113 + D_p_ry_5*h_ry_x_6 + D_p_ry_6*t119 + D_p_rz_5*h_rz_x_6
        + D_p_rz_6*t125 + D_p_x_5*h_x_x_6 + D_p_x_6*t95 + D_p_y_5*h_y_x_6 + D_p_y_6*t101 + D_p_z_5*h_z_x_6
        + D_p_z_6*t107;
    M[5][5] =
        D_p_rx_6*h_rx_x_6 + D_p_rx_6*t114 + D_p_ry_6*h_ry_x_6 + D_p_ry_6*t120 + D_p_rz_6*h_rz_x_6
        + D_p_rz_6*t126 + D_p_x_6*h_x_x_6 + D_p_x_6*t96 + D_p_y_6*h_y_x_6 + D_p_y_6*t102 + D_p_z_6*h_z_x_6
        + D_p_z_6*t108 + m_t_6 + t48;
    M[6][6] = I_1_1;
    M[7][7] = I_2_1;
    M[8][8] = I_3_1;
    M[9][9] = I_4_1;
    M[10][10] = I_5_1;
    M[11][11] = I_6_1;
    M[12][12] = I_1_2;
    M[13][13] = I_2_2;
    M[14][14] = I_3_2;
    M[15][15] = I_4_2;
    M[16][16] = I_5_2;
    M[17][17] = I_6_2;
}

void hexaglide_velocity_forces(const pkmodes_real p[6], const pkmodes_real x_dot[6],
    const hexaglide_parameters *parameters, pkmodes_real h[6])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real x_1_dot = x_dot[0];
    const pkmodes_real x_2_dot = x_dot[1];
    const pkmodes_real x_3_dot = x_dot[2];
    const pkmodes_real x_4_dot = x_dot[3];
    const pkmodes_real x_5_dot = x_dot[4];
    const pkmodes_real x_6_dot = x_dot[5];
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
    const pkmodes_real c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const pkmodes_real c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const pkmodes_real c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const pkmodes_real t12 = I_p_xy*R_x_y;
    const pkmodes_real t13 = 2*t12;
    const pkmodes_real t14 = I_p_xz*R_x_z;
    const pkmodes_real t15 = 2*t14;
    const pkmodes_real t16 = I_p_yz*R_x_z;
    const pkmodes_real t17 = 2*t16;
    const pkmodes_real J_x_x =
        I_p_x*(R_x_x*R_x_x) + I_p_y*(R_x_y*R_x_y) + I_p_z*(R_x_z*R_x_z) + R_x_x*t13 + R_x_x*t15 + R_x_y*t17;
    const pkmodes_real t18 = I_p_x*R_x_x;
    const pkmodes_real t19 = I_p_xy*R_x_x;
    const pkmodes_real t20 = I_p_xz*R_x_x;
    const pkmodes_real t21 = I_p_y*R_x_y;
    const pkmodes_real t22 = I_p_yz*R_x_y;
    const pkmodes_real t23 = I_p_z*R_x_z;
    const pkmodes_real J_x_y =
        R_y_x*t12 + R_y_x*t14 + R_y_x*t18 + R_y_y*t16 + R_y_y*t19 + R_y_y*t21 + R_y_z*t20 + R_y_z*t22
        + R_y_z*t23;
    const pkmodes_real t24 = I_p_xy*R_z_y;
    const pkmodes_real t25 = I_p_xz*R_z_z;
    const pkmodes_real t26 = I_p_yz*R_z_z;
    const pkmodes_real J_x_z =
        R_x_x*t24 + R_x_x*t25 + R_x_y*t26 + R_z_x*t12 + R_z_x*t14 + R_z_x*t18 + R_z_y*t16 + R_z_y*t21
        + R_z_z*t23;
    const pkmodes_real t27 = I_p_xy*R_y_y;
    const pkmodes_real t28 = 2*t27;
    const pkmodes_real t29 = I_p_xz*R_y_z;
    const pkmodes_real t30 = 2*t29;
    const pkmodes_real t31 = I_p_yz*R_y_z;
    const pkmodes_real t32 = 2*t31;
    const pkmodes_real J_y_y =
        I_p_x*(R_y_x*R_y_x) + I_p_y*(R_y_y*R_y_y) + I_p_z*(R_y_z*R_y_z) + R_y_x*t28 + R_y_x*t30 + R_y_y*t32;
    const pkmodes_real t33 = I_p_x*R_z_x;
    const pkmodes_real t34 = I_p_xy*R_z_x;
    const pkmodes_real t35 = I_p_xz*R_z_x;
    const pkmodes_real t36 = I_p_y*R_z_y;
    const pkmodes_real t37 = I_p_yz*R_z_y;
    const pkmodes_real t38 = I_p_z*R_z_z;
    const pkmodes_real J_y_z =
        R_y_x*t24 + R_y_x*t25 + R_y_x*t33 + R_y_y*t26 + R_y_y*t34 + R_y_y*t36 + R_y_z*t35 + R_y_z*t37
        + R_y_z*t38;
    const pkmodes_real t39 = 2*t24;
    const pkmodes_real t40 = 2*t25;
    const pkmodes_real t41 = 2*t26;
    const pkmodes_real J_z_z =
        I_p_x*(R_z_x*R_z_x) + I_p_y*(R_z_y*R_z_y) + I_p_z*(R_z_z*R_z_z) + R_z_x*t39 + R_z_x*t40 + R_z_y*t41;
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
    const pkmodes_real t42 = 1/det_D_l;
    const pkmodes_real t43 = D_r_1*t42;
    const pkmodes_real D_p_x_1 = A_x_1*t43;
    const pkmodes_real t44 = D_r_2*t42;
    const pkmodes_real D_p_x_2 = A_x_2*t44;
    const pkmodes_real t45 = D_r_3*t42;
    const pkmodes_real D_p_x_3 = A_x_3*t45;
    const pkmodes_real t46 = D_r_4*t42;
    const pkmodes_real D_p_x_4 = A_x_4*t46;
    const pkmodes_real t47 = D_r_5*t42;
    const pkmodes_real D_p_x_5 = A_x_5*t47;
    const pkmodes_real t48 = D_r_6*t42;
    const pkmodes_real D_p_x_6 = A_x_6*t48;
    const pkmodes_real D_p_y_1 = A_y_1*t43;
    const pkmodes_real D_p_y_2 = A_y_2*t44;
    const pkmodes_real D_p_y_3 = A_y_3*t45;
    const pkmodes_real D_p_y_4 = A_y_4*t46;
    const pkmodes_real D_p_y_5 = A_y_5*t47;
    const pkmodes_real D_p_y_6 = A_y_6*t48;
    const pkmodes_real D_p_z_1 = A_z_1*t43;
    const pkmodes_real D_p_z_2 = A_z_2*t44;
    const pkmodes_real D_p_z_3 = A_z_3*t45;
    const pkmodes_real D_p_z_4 = A_z_4*t46;
    const pkmodes_real D_p_z_5 = A_z_5*t47;
    const pkmodes_real D_p_z_6 = A_z_6*t48;
    const pkmodes_real D_p_rx_1 = A_rx_1*t43;
    const pkmodes_real D_p_rx_2 = A_rx_2*t44;
    const pkmodes_real D_p_rx_3 = A_rx_3*t45;
    const pkmodes_real D_p_rx_4 = A_rx_4*t46;
    const pkmodes_real D_p_rx_5 = A_rx_5*t47;
    const pkmodes_real D_p_rx_6 = A_rx_6*t48;
    const pkmodes_real D_p_ry_1 = A_ry_1*t43;
    const pkmodes_real D_p_ry_2 = A_ry_2*t44;
    const pkmodes_real D_p_ry_3 = A_ry_3*t45;
    const pkmodes_real D_p_ry_4 = A_ry_4*t46;
    const pkmodes_real D_p_ry_5 = A_ry_5*t47;
    const pkmodes_real D_p_ry_6 = A_ry_6*t48;
    const pkmodes_real D_p_rz_1 = A_rz_1*t43;
    const pkmodes_real D_p_rz_2 = A_rz_2*t44;
    const pkmodes_real D_p_rz_3 = A_rz_3*t45;
    const pkmodes_real D_p_rz_4 = A_rz_4*t46;
    const pkmodes_real D_p_rz_5 = A_rz_5*t47;
    const pkmodes_real D_p_rz_6 = A_rz_6*t48;
    const pkmodes_real t49 = B_1_y*D_p_rz_1 - B_1_z*D_p_ry_1;
    const pkmodes_real U_1_x_1 = D_p_x_1 - n_1_x - t49;
    const pkmodes_real t50 = B_1_y*D_p_rz_2;
    const pkmodes_real U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t50;
    const pkmodes_real t51 = B_1_y*D_p_rz_3;
    const pkmodes_real U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t51;
    const pkmodes_real t52 = B_1_y*D_p_rz_4;
    const pkmodes_real U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t52;
    const pkmodes_real t53 = B_1_y*D_p_rz_5;
    const pkmodes_real U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t53;
    const pkmodes_real t54 = B_1_y*D_p_rz_6;
    const pkmodes_real U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t54;
    const pkmodes_real t55 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1;
    const pkmodes_real U_1_y_1 = D_p_y_1 - n_1_y + t55;
    const pkmodes_real t56 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2;
    const pkmodes_real U_1_y_2 = D_p_y_2 + t56;
    const pkmodes_real t57 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3;
    const pkmodes_real U_1_y_3 = D_p_y_3 + t57;
    const pkmodes_real t58 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4;
    const pkmodes_real U_1_y_4 = D_p_y_4 + t58;
    const pkmodes_real t59 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5;
    const pkmodes_real U_1_y_5 = D_p_y_5 + t59;
    const pkmodes_real t60 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6;
    const pkmodes_real U_1_y_6 = D_p_y_6 + t60;
    const pkmodes_real t61 = B_1_x*D_p_ry_1 - B_1_y*D_p_rx_1;
    const pkmodes_real U_1_z_1 = D_p_z_1 - n_1_z - t61;
    const pkmodes_real t62 = B_1_x*D_p_ry_2;
    const pkmodes_real U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t62;
    const pkmodes_real t63 = B_1_x*D_p_ry_3;
    const pkmodes_real U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t63;
    const pkmodes_real t64 = B_1_x*D_p_ry_4;
    const pkmodes_real U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t64;
    const pkmodes_real t65 = B_1_x*D_p_ry_5;
    const pkmodes_real U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t65;
    const pkmodes_real t66 = B_1_x*D_p_ry_6;
    const pkmodes_real U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t66;
    const pkmodes_real t67 = B_2_y*D_p_rz_1;
    const pkmodes_real U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t67;
    const pkmodes_real t68 = B_2_y*D_p_rz_2 - B_2_z*D_p_ry_2;
    const pkmodes_real U_2_x_2 = D_p_x_2 - n_2_x - t68;
    const pkmodes_real t69 = B_2_y*D_p_rz_3;
    const pkmodes_real U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t69;
    const pkmodes_real t70 = B_2_y*D_p_rz_4;
    const pkmodes_real U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t70;
    const pkmodes_real t71 = B_2_y*D_p_rz_5;
    const pkmodes_real U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t71;
    const pkmodes_real t72 = B_2_y*D_p_rz_6;
    const pkmodes_real U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t72;
    const pkmodes_real t73 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1;
    const pkmodes_real U_2_y_1 = D_p_y_1 + t73;
    const pkmodes_real t74 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2;
    const pkmodes_real U_2_y_2 = D_p_y_2 - n_2_y + t74;
    const pkmodes_real t75 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3;
    const pkmodes_real U_2_y_3 = D_p_y_3 + t75;
    const pkmodes_real t76 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4;
    const pkmodes_real U_2_y_4 = D_p_y_4 + t76;
    const pkmodes_real t77 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5;
    const pkmodes_real U_2_y_5 = D_p_y_5 + t77;
    const pkmodes_real t78 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6;
    const pkmodes_real U_2_y_6 = D_p_y_6 + t78;
    const pkmodes_real t79 = B_2_x*D_p_ry_1;
    const pkmodes_real U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t79;
    const pkmodes_real t80 = B_2_x*D_p_ry_2 - B_2_y*D_p_rx_2;
    const pkmodes_real U_2_z_2 = D_p_z_2 - n_2_z - t80;
    const pkmodes_real t81 = B_2_x*D_p_ry_3;
    const pkmodes_real U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t81;
    const pkmodes_real t82 = B_2_x*D_p_ry_4;
    const pkmodes_real U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t82;
    const pkmodes_real t83 = B_2_x*D_p_ry_5;
    const pkmodes_real U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t83;
    const pkmodes_real t84 = B_2_x*D_p_ry_6;
    const pkmodes_real U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t84;
    const pkmodes_real t85 = B_3_y*D_p_rz_1;
    const pkmodes_real U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t85;
    const pkmodes_real t86 = B_3_y*D_p_rz_2;
    const pkmodes_real U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t86;
    const pkmodes_real t87 = B_3_y*D_p_rz_3 - B_3_z*D_p_ry_3;
    const pkmodes_real U_3_x_3 = D_p_x_3 - n_3_x - t87;
    const pkmodes_real t88 = B_3_y*D_p_rz_4;
    const pkmodes_real U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t88;
    const pkmodes_real t89 = B_3_y*D_p_rz_5;
    const pkmodes_real U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t89;
    const pkmodes_real t90 = B_3_y*D_p_rz_6;
    const pkmodes_real U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t90;
    const pkmodes_real t91 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1;
    const pkmodes_real U_3_y_1 = D_p_y_1 + t91;
    const pkmodes_real t92 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2;
    const pkmodes_real U_3_y_2 = D_p_y_2 + t92;
    const pkmodes_real t93 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3;
    const pkmodes_real U_3_y_3 = D_p_y_3 - n_3_y + t93;
    const pkmodes_real t94 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4;
    const pkmodes_real U_3_y_4 = D_p_y_4 + t94;
    const pkmodes_real t95 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5;
    const pkmodes_real U_3_y_5 = D_p_y_5 + t95;
    const pkmodes_real t96 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6;
    const pkmodes_real U_3_y_6 = D_p_y_6 + t96;
    const pkmodes_real t97 = B_3_x*D_p_ry_1;
    const pkmodes_real U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t97;
    const pkmodes_real t98 = B_3_x*D_p_ry_2;
    const pkmodes_real U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t98;
    const pkmodes_real t99 = B_3_x*D_p_ry_3 - B_3_y*D_p_rx_3;
    const pkmodes_real U_3_z_3 = D_p_z_3 - n_3_z - t99;
    const pkmodes_real t100 = B_3_x*D_p_ry_4;
    const pkmodes_real U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t100;
    const pkmodes_real t101 = B_3_x*D_p_ry_5;
    const pkmodes_real U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t101;
    const pkmodes_real t102 = B_3_x*D_p_ry_6;
    const pkmodes_real U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t102;
    const pkmodes_real t103 = B_4_y*D_p_rz_1;
    const pkmodes_real U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t103;
    const pkmodes_real t104 = B_4_y*D_p_rz_2;
    const pkmodes_real U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t104;
    const pkmodes_real t105 = B_4_y*D_p_rz_3;
    const pkmodes_real U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t105;
    const pkmodes_real t106 = B_4_y*D_p_rz_4 - B_4_z*D_p_ry_4;
    const pkmodes_real U_4_x_4 = D_p_x_4 - n_4_x - t106;
    const pkmodes_real t107 = B_4_y*D_p_rz_5;
    const pkmodes_real U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t107;
    const pkmodes_real t108 = B_4_y*D_p_rz_6;
    const pkmodes_real U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t108;
    const pkmodes_real t109 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1;
    const pkmodes_real U_4_y_1 = D_p_y_1 + t109;
    const pkmodes_real t110 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2;
    const pkmodes_real U_4_y_2 = D_p_y_2 + t110;
    const pkmodes_real t111 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3;
    const pkmodes_real U_4_y_3 = D_p_y_3 + t111;
    const pkmodes_real t112 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4;
    const pkmodes_real U_4_y_4 = D_p_y_4 - n_4_y + t112;
    const pkmodes_real t113 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5;
    const pkmodes_real U_4_y_5 = D_p_y_5 + t113;
    const pkmodes_real t114 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6;
    const pkmodes_real U_4_y_6 = D_p_y_6 + t114;
    const pkmodes_real t115 = B_4_x*D_p_ry_1;
    const pkmodes_real U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t115;
    const pkmodes_real t116 = B_4_x*D_p_ry_2;
    const pkmodes_real U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t116;
    const pkmodes_real t117 = B_4_x*D_p_ry_3;
    const pkmodes_real U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t117;
    const pkmodes_real t118 = B_4_x*D_p_ry_4 - B_4_y*D_p_rx_4;
    const pkmodes_real U_4_z_4 = D_p_z_4 - n_4_z - t118;
    const pkmodes_real t119 = B_4_x*D_p_ry_5;
    const pkmodes_real U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t119;
    const pkmodes_real t120 = B_4_x*D_p_ry_6;
    const pkmodes_real U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t120;
    const pkmodes_real t121 = B_5_y*D_p_rz_1;
    const pkmodes_real U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t121;
    const pkmodes_real t122 = B_5_y*D_p_rz_2;
    const pkmodes_real U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t122;
    const pkmodes_real t123 = B_5_y*D_p_rz_3;
    const pkmodes_real U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t123;
    const pkmodes_real t124 = B_5_y*D_p_rz_4;
    const pkmodes_real U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t124;
    const pkmodes_real t125 = B_5_y*D_p_rz_5 - B_5_z*D_p_ry_5;
    const pkmodes_real U_5_x_5 = D_p_x_5 - n_5_x - t125;
    const pkmodes_real t126 = B_5_y*D_p_rz_6;
    const pkmodes_real U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t126;
    const pkmodes_real t127 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1;
    const pkmodes_real U_5_y_1 = D_p_y_1 + t127;
    const pkmodes_real t128 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2;
    const pkmodes_real U_5_y_2 = D_p_y_2 + t128;
    const pkmodes_real t129 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3;
    const pkmodes_real U_5_y_3 = D_p_y_3 + t129;
    const pkmodes_real t130 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4;
    const pkmodes_real U_5_y_4 = D_p_y_4 + t130;
    const pkmodes_real t131 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5;
    const pkmodes_real U_5_y_5 = D_p_y_5 - n_5_y + t131;
    const pkmodes_real t132 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6;
    const pkmodes_real U_5_y_6 = D_p_y_6 + t132;
    const pkmodes_real t133 = B_5_x*D_p_ry_1;
    const pkmodes_real U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t133;
    const pkmodes_real t134 = B_5_x*D_p_ry_2;
    const pkmodes_real U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t134;
    const pkmodes_real t135 = B_5_x*D_p_ry_3;
    const pkmodes_real U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t135;
    const pkmodes_real t136 = B_5_x*D_p_ry_4;
    const pkmodes_real U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t136;
    const pkmodes_real t137 = B_5_x*D_p_ry_5 - B_5_y*D_p_rx_5;
    const pkmodes_real U_5_z_5 = D_p_z_5 - n_5_z - t137;
    const pkmodes_real t138 = B_5_x*D_p_ry_6;
    const pkmodes_real U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t138;
    const pkmodes_real t139 = B_6_y*D_p_rz_1;
    const pkmodes_real U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t139;
    const pkmodes_real t140 = B_6_y*D_p_rz_2;
    const pkmodes_real U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t140;
    const pkmodes_real t141 = B_6_y*D_p_rz_3;
    const pkmodes_real U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t141;
    const pkmodes_real t142 = B_6_y*D_p_rz_4;
    const pkmodes_real U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t142;
    const pkmodes_real t143 = B_6_y*D_p_rz_5;
    const pkmodes_real U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t143;
    const pkmodes_real t144 = B_6_y*D_p_rz_6 - B_6_z*D_p_ry_6;
    const pkmodes_real U_6_x_6 = D_p_x_6 - n_6_x - t144;
    const pkmodes_real t145 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1;
    const pkmodes_real U_6_y_1 = D_p_y_1 + t145;
    const pkmodes_real t146 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2;
    const pkmodes_real U_6_y_2 = D_p_y_2 + t146;
    const pkmodes_real t147 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3;
    const pkmodes_real U_6_y_3 = D_p_y_3 + t147;
    const pkmodes_real t148 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4;
    const pkmodes_real U_6_y_4 = D_p_y_4 + t148;
    const pkmodes_real t149 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5;
    const pkmodes_real U_6_y_5 = D_p_y_5 + t149;
    const pkmodes_real t150 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6;
    const pkmodes_real U_6_y_6 = D_p_y_6 - n_6_y + t150;
    const pkmodes_real t151 = B_6_x*D_p_ry_1;
    const pkmodes_real U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t151;
    const pkmodes_real t152 = B_6_x*D_p_ry_2;
    const pkmodes_real U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t152;
    const pkmodes_real t153 = B_6_x*D_p_ry_3;
    const pkmodes_real U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t153;
    const pkmodes_real t154 = B_6_x*D_p_ry_4;
    const pkmodes_real U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t154;
    const pkmodes_real t155 = B_6_x*D_p_ry_5;
    const pkmodes_real U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t155;
    const pkmodes_real t156 = B_6_x*D_p_ry_6 - B_6_y*D_p_rx_6;
    const pkmodes_real U_6_z_6 = D_p_z_6 - n_6_z - t156;
    const pkmodes_real v_p_x =
        D_p_x_1*x_1_dot + D_p_x_2*x_2_dot + D_p_x_3*x_3_dot + D_p_x_4*x_4_dot + D_p_x_5*x_5_dot
        + D_p_x_6*x_6_dot;
    const pkmodes_real v_p_y =
        D_p_y_1*x_1_dot + D_p_y_2*x_2_dot + D_p_y_3*x_3_dot + D_p_y_4*x_4_dot + D_p_y_5*x_5_dot
        + D_p_y_6*x_6_dot;
    const pkmodes_real v_p_z =
        D_p_z_1*x_1_dot + D_p_z_2*x_2_dot + D_p_z_3*x_3_dot + D_p_z_4*x_4_dot + D_p_z_5*x_5_dot
        + D_p_z_6*x_6_dot;
    const pkmodes_real w_p_x =
        D_p_rx_1*x_1_dot + D_p_rx_2*x_2_dot + D_p_rx_3*x_3_dot + D_p_rx_4*x_4_dot + D_p_rx_5*x_5_dot
        + D_p_rx_6*x_6_dot;
    const pkmodes_real w_p_y =
        D_p_ry_1*x_1_dot + D_p_ry_2*x_2_dot + D_p_ry_3*x_3_dot + D_p_ry_4*x_4_dot + D_p_ry_5*x_5_dot
        + D_p_ry_6*x_6_dot;
    const pkmodes_real w_p_z =
        D_p_rz_1*x_1_dot + D_p_rz_2*x_2_dot + D_p_rz_3*x_3_dot + D_p_rz_4*x_4_dot + D_p_rz_5*x_5_dot
        + D_p_rz_6*x_6_dot;
    const pkmodes_real s_dot_1_x =
        U_1_x_1*x_1_dot + U_1_x_2*x_2_dot + U_1_x_3*x_3_dot + U_1_x_4*x_4_dot + U_1_x_5*x_5_dot
        + U_1_x_6*x_6_dot;
    const pkmodes_real s_dot_1_y =
        U_1_y_1*x_1_dot + U_1_y_2*x_2_dot + U_1_y_3*x_3_dot + U_1_y_4*x_4_dot + U_1_y_5*x_5_dot
        + U_1_y_6*x_6_dot;
    const pkmodes_real s_dot_1_z =
        U_1_z_1*x_1_dot + U_1_z_2*x_2_dot + U_1_z_3*x_3_dot + U_1_z_4*x_4_dot + U_1_z_5*x_5_dot
        + U_1_z_6*x_6_dot;
    const pkmodes_real s_dot_2_x =
        U_2_x_1*x_1_dot + U_2_x_2*x_2_dot + U_2_x_3*x_3_dot + U_2_x_4*x_4_dot + U_2_x_5*x_5_dot
        + U_2_x_6*x_6_dot;
    const pkmodes_real s_dot_2_y =
        U_2_y_1*x_1_dot + U_2_y_2*x_2_dot + U_2_y_3*x_3_dot + U_2_y_4*x_4_dot + U_2_y_5*x_5_dot
        + U_2_y_6*x_6_dot;
    const pkmodes_real s_dot_2_z =
        U_2_z_1*x_1_dot + U_2_z_2*x_2_dot + U_2_z_3*x_3_dot + U_2_z_4*x_4_dot + U_2_z_5*x_5_dot
        + U_2_z_6*x_6_dot;
    const pkmodes_real s_dot_3_x =
        U_3_x_1*x_1_dot + U_3_x_2*x_2_dot + U_3_x_3*x_3_dot + U_3_x_4*x_4_dot + U_3_x_5*x_5_dot
        + U_3_x_6*x_6_dot;
    const pkmodes_real s_dot_3_y =
        U_3_y_1*x_1_dot + U_3_y_2*x_2_dot + U_3_y_3*x_3_dot + U_3_y_4*x_4_dot + U_3_y_5*x_5_dot
        + U_3_y_6*x_6_dot;
    const pkmodes_real s_dot_3_z =
        U_3_z_1*x_1_dot + U_3_z_2*x_2_dot + U_3_z_3*x_3_dot + U_3_z_4*x_4_dot + U_3_z_5*x_5_dot
        + U_3_z_6*x_6_dot;
    const pkmodes_real s_dot_4_x =
        U_4_x_1*x_1_dot + U_4_x_2*x_2_dot + U_4_x_3*x_3_dot + U_4_x_4*x_4_dot + U_4_x_5*x_5_dot
        + U_4_x_6*x_6_dot;
    const pkmodes_real s_dot_4_y =
        U_4_y_1*x_1_dot + U_4_y_2*x_2_dot + U_4_y_3*x_3_dot + U_4_y_4*x_4_dot + U_4_y_5*x_5_dot
        + U_4_y_6*x_6_dot;
    const pkmodes_real s_dot_4_z =
        U_4_z_1*x_1_dot + U_4_z_2*x_2_dot + U_4_z_3*x_3_dot + U_4_z_4*x_4_dot + U_4_z_5*x_5_dot
        + U_4_z_6*x_6_dot;
    const pkmodes_real s_dot_5_x =
        U_5_x_1*x_1_dot + U_5_x_2*x_2_dot + U_5_x_3*x_3_dot + U_5_x_4*x_4_dot + U_5_x_5*x_5_dot
        + U_5_x_6*x_6_dot;
    const pkmodes_real s_dot_5_y =
        U_5_y_1*x_1_dot + U_5_y_2*x_2_dot + U_5_y_3*x_3_dot + U_5_y_4*x_4_dot + U_5_y_5*x_5_dot
        + U_5_y_6*x_6_dot;
    const pkmodes_real s_dot_5_z =
        U_5_z_1*x_1_dot + U_5_z_2*x_2_dot + U_5_z_3*x_3_dot + U_5_z_4*x_4_dot + U_5_z_5*x_5_dot
        + U_5_z_6*x_6_dot;
    const pkmodes_real s_dot_6_x =
        U_6_x_1*x_1_dot + U_6_x_2*x_2_dot + U_6_x_3*x_3_dot + U_6_x_4*x_4_dot + U_6_x_5*x_5_dot
        + U_6_x_6*x_6_dot;
    const pkmodes_real s_dot_6_y =
        U_6_y_1*x_1_dot + U_6_y_2*x_2_dot + U_6_y_3*x_3_dot + U_6_y_4*x_4_dot + U_6_y_5*x_5_dot
        + U_6_y_6*x_6_dot;
    const pkmodes_real s_dot_6_z =
        U_6_z_1*x_1_dot + U_6_z_2*x_2_dot + U_6_z_3*x_3_dot + U_6_z_4*x_4_dot + U_6_z_5*x_5_dot
        + U_6_z_6*x_6_dot;
    const pkmodes_real t157 = B_1_y*D_p_rx_2 - t62;
    const pkmodes_real t158 = B_1_y*D_p_rx_3 - t63;
    const pkmodes_real t159 = B_1_y*D_p_rx_4 - t64;
    const pkmodes_real t160 = B_1_y*D_p_rx_5 - t65;
    const pkmodes_real t161 = B_1_y*D_p_rx_6 - t66;
    const pkmodes_real D_l_dot_1_rx =
        x_1_dot*(B_1_y*U_1_z_1 - B_1_z*U_1_y_1 + s_1_y*t61 + s_1_z*t55) + x_2_dot*(B_1_y*U_1_z_2
        - B_1_z*U_1_y_2 - s_1_y*t157 + s_1_z*t56) + x_3_dot*(B_1_y*U_1_z_3 - B_1_z*U_1_y_3 - s_1_y*t158
        + s_1_z*t57) + x_4_dot*(B_1_y*U_1_z_4 - B_1_z*U_1_y_4 - s_1_y*t159 + s_1_z*t58)
        + x_5_dot*(B_1_y*U_1_z_5 - B_1_z*U_1_y_5 - s_1_y*t160 + s_1_z*t59) + x_6_dot*(B_1_y*U_1_z_6
        - B_1_z*U_1_y_6 - s_1_y*t161 + s_1_z*t60);
    const pkmodes_real t162 = B_1_z*D_p_ry_2 - t50;
    const pkmodes_real t163 = B_1_z*D_p_ry_3 - t51;
    const pkmodes_real t164 = B_1_z*D_p_ry_4 - t52;
    const pkmodes_real t165 = B_1_z*D_p_ry_5 - t53;
    const pkmodes_real t166 = B_1_z*D_p_ry_6 - t54;
    const pkmodes_real D_l_dot_1_ry =
        x_1_dot*(-B_1_x*U_1_z_1 + B_1_z*U_1_x_1 - s_1_x*t61 + s_1_z*t49) + x_2_dot*(-B_1_x*U_1_z_2
        + B_1_z*U_1_x_2 + s_1_x*t157 - s_1_z*t162) + x_3_dot*(-B_1_x*U_1_z_3 + B_1_z*U_1_x_3 + s_1_x*t158
        - s_1_z*t163) + x_4_dot*(-B_1_x*U_1_z_4 + B_1_z*U_1_x_4 + s_1_x*t159 - s_1_z*t164)
        + x_5_dot*(-B_1_x*U_1_z_5 + B_1_z*U_1_x_5 + s_1_x*t160 - s_1_z*t165) + x_6_dot*(-B_1_x*U_1_z_6
        + B_1_z*U_1_x_6 + s_1_x*t161 - s_1_z*t166);
    const pkmodes_real D_l_dot_1_rz =
        x_1_dot*(B_1_x*U_1_y_1 - B_1_y*U_1_x_1 - s_1_x*t55 - s_1_y*t49) + x_2_dot*(B_1_x*U_1_y_2
        - B_1_y*U_1_x_2 - s_1_x*t56 + s_1_y*t162) + x_3_dot*(B_1_x*U_1_y_3 - B_1_y*U_1_x_3 - s_1_x*t57
        + s_1_y*t163) + x_4_dot*(B_1_x*U_1_y_4 - B_1_y*U_1_x_4 - s_1_x*t58 + s_1_y*t164)
        + x_5_dot*(B_1_x*U_1_y_5 - B_1_y*U_1_x_5 - s_1_x*t59 + s_1_y*t165) + x_6_dot*(B_1_x*U_1_y_6
        - B_1_y*U_1_x_6 - s_1_x*t60 + s_1_y*t166);
    const pkmodes_real t167 = B_2_y*D_p_rx_1 - t79;
    const pkmodes_real t168 = B_2_y*D_p_rx_3 - t81;
    const pkmodes_real t169 = B_2_y*D_p_rx_4 - t82;
    const pkmodes_real t170 = B_2_y*D_p_rx_5 - t83;
    const pkmodes_real t171 = B_2_y*D_p_rx_6 - t84;
    const pkmodes_real D_l_dot_2_rx =
        x_1_dot*(B_2_y*U_2_z_1 - B_2_z*U_2_y_1 - s_2_y*t167 + s_2_z*t73) + x_2_dot*(B_2_y*U_2_z_2
        - B_2_z*U_2_y_2 + s_2_y*t80 + s_2_z*t74) + x_3_dot*(B_2_y*U_2_z_3 - B_2_z*U_2_y_3 - s_2_y*t168
        + s_2_z*t75) + x_4_dot*(B_2_y*U_2_z_4 - B_2_z*U_2_y_4 - s_2_y*t169 + s_2_z*t76)
        + x_5_dot*(B_2_y*U_2_z_5 - B_2_z*U_2_y_5 - s_2_y*t170 + s_2_z*t77) + x_6_dot*(B_2_y*U_2_z_6
        - B_2_z*U_2_y_6 - s_2_y*t171 + s_2_z*t78);
    const pkmodes_real t172 = B_2_z*D_p_ry_1 - t67;
    const pkmodes_real t173 = B_2_z*D_p_ry_3 - t69;
    const pkmodes_real t174 = B_2_z*D_p_ry_4 - t70;
    const pkmodes_real t175 = B_2_z*D_p_ry_5 - t71;
    const pkmodes_real t176 = B_2_z*D_p_ry_6 - t72;
    const pkmodes_real D_l_dot_2_ry =
        x_1_dot*(-B_2_x*U_2_z_1 + B_2_z*U_2_x_1 + s_2_x*t167 - s_2_z*t172) + x_2_dot*(-B_2_x*U_2_z_2
        + B_2_z*U_2_x_2 - s_2_x*t80 + s_2_z*t68) + x_3_dot*(-B_2_x*U_2_z_3 + B_2_z*U_2_x_3 + s_2_x*t168
        - s_2_z*t173) + x_4_dot*(-B_2_x*U_2_z_4 + B_2_z*U_2_x_4 + s_2_x*t169 - s_2_z*t174)
        + x_5_dot*(-B_2_x*U_2_z_5 + B_2_z*U_2_x_5 + s_2_x*t170 - s_2_z*t175) + x_6_dot*(-B_2_x*U_2_z_6
        + B_2_z*U_2_x_6 + s_2_x*t171 - s_2_z*t176);
    const pkmodes_real D_l_dot_2_rz =
        x_1_dot*(B_2_x*U_2_y_1 - B_2_y*U_2_x_1 - s_2_x*t73 + s_2_y*t172) + x_2_dot*(B_2_x*U_2_y_2
        - B_2_y*U_2_x_2 - s_2_x*t74 - s_2_y*t68) + x_3_dot*(B_2_x*U_2_y_3 - B_2_y*U_2_x_3 - s_2_x*t75
        + s_2_y*t173) + x_4_dot*(B_2_x*U_2_y_4 - B_2_y*U_2_x_4 - s_2_x*t76 + s_2_y*t174)
        + x_5_dot*(B_2_x*U_2_y_5 - B_2_y*U_2_x_5 - s_2_x*t77 + s_2_y*t175) + x_6_dot*(B_2_x*U_2_y_6
        - B_2_y*U_2_x_6 - s_2_x*t78 + s_2_y*t176);
    const pkmodes_real t177 = B_3_y*D_p_rx_1 - t97;
    const pkmodes_real t178 = B_3_y*D_p_rx_2 - t98;
    const pkmodes_real t179 = B_3_y*D_p_rx_4 - t100;
    const pkmodes_real t180 = B_3_y*D_p_rx_5 - t101;
    const pkmodes_real t181 = B_3_y*D_p_rx_6 - t102;
    const pkmodes_real D_l_dot_3_rx =
        x_1_dot*(B_3_y*U_3_z_1 - B_3_z*U_3_y_1 - s_3_y*t177 + s_3_z*t91) + x_2_dot*(B_3_y*U_3_z_2
        - B_3_z*U_3_y_2 - s_3_y*t178 + s_3_z*t92) + x_3_dot*(B_3_y*U_3_z_3 - B_3_z*U_3_y_3 + s_3_y*t99
        + s_3_z*t93) + x_4_dot*(B_3_y*U_3_z_4 - B_3_z*U_3_y_4 - s_3_y*t179 + s_3_z*t94)
        + x_5_dot*(B_3_y*U_3_z_5 - B_3_z*U_3_y_5 - s_3_y*t180 + s_3_z*t95) + x_6_dot*(B_3_y*U_3_z_6
        - B_3_z*U_3_y_6 - s_3_y*t181 + s_3_z*t96);
    const pkmodes_real t182 = B_3_z*D_p_ry_1 - t85;
    const pkmodes_real t183 = B_3_z*D_p_ry_2 - t86;
    const pkmodes_real t184 = B_3_z*D_p_ry_4 - t88;
    const pkmodes_real t185 = B_3_z*D_p_ry_5 - t89;
    const pkmodes_real t186 = B_3_z*D_p_ry_6 - t90;
    const pkmodes_real D_l_dot_3_ry =
        x_1_dot*(-B_3_x*U_3_z_1 + B_3_z*U_3_x_1 + s_3_x*t177 - s_3_z*t182) + x_2_dot*(-B_3_x*U_3_z_2
        + B_3_z*U_3_x_2 + s_3_x*t178 - s_3_z*t183) + x_3_dot*(-B_3_x*U_3_z_3 + B_3_z*U_3_x_3 - s_3_x*t99
        + s_3_z*t87) + x_4_dot*(-B_3_x*U_3_z_4 + B_3_z*U_3_x_4 + s_3_x*t179 - s_3_z*t184)
        + x_5_dot*(-B_3_x*U_3_z_5 + B_3_z*U_3_x_5 + s_3_x*t180 - s_3_z*t185) + x_6_dot*(-B_3_x*U_3_z_6
        + B_3_z*U_3_x_6 + s_3_x*t181 - s_3_z*t186);
    const pkmodes_real D_l_dot_3_rz =
        x_1_dot*(B_3_x*U_3_y_1 - B_3_y*U_3_x_1 - s_3_x*t91 + s_3_y*t182) + x_2_dot*(B_3_x*U_3_y_2
        - B_3_y*U_3_x_2 - s_3_x*t92 + s_3_y*t183) + x_3_dot*(B_3_x*U_3_y_3 - B_3_y*U_3_x_3 - s_3_x*t93
        - s_3_y*t87) + x_4_dot*(B_3_x*U_3_y_4 - B_3_y*U_3_x_4 - s_3_x*t94 + s_3_y*t184)
        + x_5_dot*(B_3_x*U_3_y_5 - B_3_y*U_3_x_5 - s_3_x*t95 + s_3_y*t185) + x_6_dot*(B_3_x*U_3_y_6
        - B_3_y*U_3_x_6 - s_3_x*t96 + s_3_y*t186);
    const pkmodes_real t187 = B_4_y*D_p_rx_1 - t115;
    const pkmodes_real t188 = B_4_y*D_p_rx_2 - t116;
    const pkmodes_real t189 = B_4_y*D_p_rx_3 - t117;
    const pkmodes_real t190 = B_4_y*D_p_rx_5 - t119;
    const pkmodes_real t191 = B_4_y*D_p_rx_6 - t120;
    const pkmodes_real D_l_dot_4_rx =
        x_1_dot*(B_4_y*U_4_z_1 - B_4_z*U_4_y_1 - s_4_y*t187 + s_4_z*t109) + x_2_dot*(B_4_y*U_4_z_2
        - B_4_z*U_4_y_2 - s_4_y*t188 + s_4_z*t110) + x_3_dot*(B_4_y*U_4_z_3 - B_4_z*U_4_y_3 - s_4_y*t189
        + s_4_z*t111) + x_4_dot*(B_4_y*U_4_z_4 - B_4_z*U_4_y_4 + s_4_y*t118 + s_4_z*t112)
        + x_5_dot*(B_4_y*U_4_z_5 - B_4_z*U_4_y_5 - s_4_y*t190 + s_4_z*t113) + x_6_dot*(B_4_y*U_4_z_6
        - B_4_z*U_4_y_6 - s_4_y*t191 + s_4_z*t114);
    const pkmodes_real t192 = B_4_z*D_p_ry_1 - t103;
    const pkmodes_real t193 = B_4_z*D_p_ry_2 - t104;
    const pkmodes_real t194 = B_4_z*D_p_ry_3 - t105;
    const pkmodes_real t195 = B_4_z*D_p_ry_5 - t107;
    const pkmodes_real t196 = B_4_z*D_p_ry_6 - t108;
    const pkmodes_real D_l_dot_4_ry =
        x_1_dot*(-B_4_x*U_4_z_1 + B_4_z*U_4_x_1 + s_4_x*t187 - s_4_z*t192) + x_2_dot*(-B_4_x*U_4_z_2
        + B_4_z*U_4_x_2 + s_4_x*t188 - s_4_z*t193) + x_3_dot*(-B_4_x*U_4_z_3 + B_4_z*U_4_x_3 + s_4_x*t189
        - s_4_z*t194) + x_4_dot*(-B_4_x*U_4_z_4 + B_4_z*U_4_x_4 - s_4_x*t118 + s_4_z*t106)
        + x_5_dot*(-B_4_x*U_4_z_5 + B_4_z*U_4_x_5 + s_4_x*t190 - s_4_z*t195) + x_6_dot*(-B_4_x*U_4_z_6
        + B_4_z*U_4_x_6 + s_4_x*t191 - s_4_z*t196);
    const pkmodes_real D_l_dot_4_rz =
        x_1_dot*(B_4_x*U_4_y_1 - B_4_y*U_4_x_1 - s_4_x*t109 + s_4_y*t192) + x_2_dot*(B_4_x*U_4_y_2
        - B_4_y*U_4_x_2 - s_4_x*t110 + s_4_y*t193) + x_3_dot*(B_4_x*U_4_y_3 - B_4_y*U_4_x_3 - s_4_x*t111
        + s_4_y*t194) + x_4_dot*(B_4_x*U_4_y_4 - B_4_y*U_4_x_4 - s_4_x*t112 - s_4_y*t106)
        + x_5_dot*(B_4_x*U_4_y_5 - B_4_y*U_4_x_5 - s_4_x*t113 + s_4_y*t195) + x_6_dot*(B_4_x*U_4_y_6
        - B_4_y*U_4_x_6 - s_4_x*t114 + s_4_y*t196);
    const pkmodes_real t197 = B_5_y*D_p_rx_1 - t133;
    const pkmodes_real t198 = B_5_y*D_p_rx_2 - t134;
    const pkmodes_real t199 = B_5_y*D_p_rx_3 - t135;
    const pkmodes_real t200 = B_5_y*D_p_rx_4 - t136;
    const pkmodes_real t201 = B_5_y*D_p_rx_6 - t138;
    const pkmodes_real D_l_dot_5_rx =
        x_1_dot*(B_5_y*U_5_z_1 - B_5_z*U_5_y_1 - s_5_y*t197 + s_5_z*t127) + x_2_dot*(B_5_y*U_5_z_2
        - B_5_z*U_5_y_2 - s_5_y*t198 + s_5_z*t128) + x_3_dot*(B_5_y*U_5_z_3 - B_5_z*U_5_y_3 - s_5_y*t199
        + s_5_z*t129) + x_4_dot*(B_5_y*U_5_z_4 - B_5_z*U_5_y_4 - s_5_y*t200 + s_5_z*t130)
        + x_5_dot*(B_5_y*U_5_z_5 - B_5_z*U_5_y_5 + s_5_y*t137 + s_5_z*t131) + x_6_dot*(B_5_y*U_5_z_6
        - B_5_z*U_5_y_6 - s_5_y*t201 + s_5_z*t132);
    const pkmodes_real t202 = B_5_z*D_p_ry_1 - t121;
    const pkmodes_real t203 = B_5_z*D_p_ry_2 - t122;
    const pkmodes_real t204 = B_5_z*D_p_ry_3 - t123;
    const pkmodes_real t205 = B_5_z*D_p_ry_4 - t124;
    const pkmodes_real t206 = B_5_z*D_p_ry_6 - t126;
    const pkmodes_real D_l_dot_5_ry =
        x_1_dot*(-B_5_x*U_5_z_1 + B_5_z*U_5_x_1 + s_5_x*t197 - s_5_z*t202) + x_2_dot*(-B_5_x*U_5_z_2
        + B_5_z*U_5_x_2 + s_5_x*t198 - s_5_z*t203) + x_3_dot*(-B_5_x*U_5_z_3 + B_5_z*U_5_x_3 + s_5_x*t199
        - s_5_z*t204) + x_4_dot*(-B_5_x*U_5_z_4 + B_5_z*U_5_x_4 + s_5_x*t200 - s_5_z*t205)
        + x_5_dot*(-B_5_x*U_5_z_5 + B_5_z*U_5_x_5 - s_5_x*t137 + s_5_z*t125) + x_6_dot*(-B_5_x*U_5_z_6
        + B_5_z*U_5_x_6 + s_5_x*t201 - s_5_z*t206);
    const pkmodes_real D_l_dot_5_rz =
        x_1_dot*(B_5_x*U_5_y_1 - B_5_y*U_5_x_1 - s_5_x*t127 + s_5_y*t202) + x_2_dot*(B_5_x*U_5_y_2
        - B_5_y*U_5_x_2 - s_5_x*t128 + s_5_y*t203) + x_3_dot*(B_5_x*U_5_y_3 - B_5_y*U_5_x_3 - s_5_x*t129
        + s_5_y*t204) + x_4_dot*(B_5_x*U_5_y_4 - B_5_y*U_5_x_4 - s_5_x*t130 + s_5_y*t205)
        + x_5_dot*(B_5_x*U_5_y_5 - B_5_y*U_5_x_5 - s_5_x*t131 - s_5_y*t125) + x_6_dot*(B_5_x*U_5_y_6
        - B_5_y*U_5_x_6 - s_5_x*t132 + s_5_y*t206);
    const pkmodes_real t207 = B_6_y*D_p_rx_1 - t151;
    const pkmodes_real t208 = B_6_y*D_p_rx_2 - t152;
    const pkmodes_real t209 = B_6_y*D_p_rx_3 - t153;
    const pkmodes_real t210 = B_6_y*D_p_rx_4 - t154;
    const pkmodes_real t211 = B_6_y*D_p_rx_5 - t155;
    const pkmodes_real D_l_dot_6_rx =
        x_1_dot*(B_6_y*U_6_z_1 - B_6_z*U_6_y_1 - s_6_y*t207 + s_6_z*t145) + x_2_dot*(B_6_y*U_6_z_2
        - B_6_z*U_6_y_2 - s_6_y*t208 + s_6_z*t146) + x_3_dot*(B_6_y*U_6_z_3 - B_6_z*U_6_y_3 - s_6_y*t209
        + s_6_z*t147) + x_4_dot*(B_6_y*U_6_z_4 - B_6_z*U_6_y_4 - s_6_y*t210 + s_6_z*t148)
        + x_5_dot*(B_6_y*U_6_z_5 - B_6_z*U_6_y_5 - s_6_y*t211 + s_6_z*t149) + x_6_dot*(B_6_y*U_6_z_6
        - B_6_z*U_6_y_6 + s_6_y*t156 + s_6_z*t150);
    const pkmodes_real t212 = B_6_z*D_p_ry_1 - t139;
    const pkmodes_real t213 = B_6_z*D_p_ry_2 - t140;
    const pkmodes_real t214 = B_6_z*D_p_ry_3 - t141;
    const pkmodes_real t215 = B_6_z*D_p_ry_4 - t142;
    const pkmodes_real t216 = B_6_z*D_p_ry_5 - t143;
    const pkmodes_real D_l_dot_6_ry =
        x_1_dot*(-B_6_x*U_6_z_1 + B_6_z*U_6_x_1 + s_6_x*t207 - s_6_z*t212) + x_2_dot*(-B_6_x*U_6_z_2
        + B_6_z*U_6_x_2 + s_6_x*t208 - s_6_z*t213) + x_3_dot*(-B_6_x*U_6_z_3 + B_6_z*U_6_x_3 + s_6_x*t209
        - s_6_z*t214) + x_4_dot*(-B_6_x*U_6_z_4 + B_6_z*U_6_x_4 + s_6_x*t210 - s_6_z*t215)
        + x_5_dot*(-B_6_x*U_6_z_5 + B_6_z*U_6_x_5 + s_6_x*t211 - s_6_z*t216) + x_6_dot*(-B_6_x*U_6_z_6
        + B_6_z*U_6_x_6 - s_6_x*t156 + s_6_z*t144);
    const pkmodes_real D_l_dot_6_rz =
        x_1_dot*(B_6_x*U_6_y_1 - B_6_y*U_6_x_1 - s_6_x*t145 + s_6_y*t212) + x_2_dot*(B_6_x*U_6_y_2
        - B_6_y*U_6_x_2 - s_6_x*t146 + s_6_y*t213) + x_3_dot*(B_6_x*U_6_y_3 - B_6_y*U_6_x_3 - s_6_x*t147
        + s_6_y*t214) + x_4_dot*(B_6_x*U_6_y_4 - B_6_y*U_6_x_4 - s_6_x*t148 + s_6_y*t215)
        + x_5_dot*(B_6_x*U_6_y_5 - B_6_y*U_6_x_5 - s_6_x*t149 + s_6_y*t216) + x_6_dot*(B_6_x*U_6_y_6
        - B_6_y*U_6_x_6 - s_6_x*t150 - s_6_y*t144);
    const pkmodes_real t217 =
        -D_l_dot_2_rx*D_p_rx_1 - D_l_dot_2_ry*D_p_ry_1 - D_l_dot_2_rz*D_p_rz_1 - D_p_x_1*s_dot_2_x
        - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t218 =
        -D_l_dot_3_rx*D_p_rx_1 - D_l_dot_3_ry*D_p_ry_1 - D_l_dot_3_rz*D_p_rz_1 - D_p_x_1*s_dot_3_x
        - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t219 =
        -D_l_dot_4_rx*D_p_rx_1 - D_l_dot_4_ry*D_p_ry_1 - D_l_dot_4_rz*D_p_rz_1 - D_p_x_1*s_dot_4_x
        - D_p_y_1*s_dot_4_y - D_p_z_1*s_dot_4_z;
    const pkmodes_real t220 =
        -D_l_dot_5_rx*D_p_rx_1 - D_l_dot_5_ry*D_p_ry_1 - D_l_dot_5_rz*D_p_rz_1 - D_p_x_1*s_dot_5_x
        - D_p_y_1*s_dot_5_y - D_p_z_1*s_dot_5_z;
    const pkmodes_real t221 =
        -D_l_dot_6_rx*D_p_rx_1 - D_l_dot_6_ry*D_p_ry_1 - D_l_dot_6_rz*D_p_rz_1 - D_p_x_1*s_dot_6_x
        - D_p_y_1*s_dot_6_y - D_p_z_1*s_dot_6_z;
    const pkmodes_real t222 =
        -D_l_dot_1_rx*D_p_rx_1 - D_l_dot_1_ry*D_p_ry_1 - D_l_dot_1_rz*D_p_rz_1 - D_p_x_1*s_dot_1_x
        - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + n_1_x*s_dot_1_x + n_1_y*s_dot_1_y + n_1_z*s_dot_1_z;
    const pkmodes_real D_p_dot_x_1 =
        t42*(A_x_1*t222 + A_x_2*t217 + A_x_3*t218 + A_x_4*t219 + A_x_5*t220 + A_x_6*t221);
    const pkmodes_real D_p_dot_y_1 =
        t42*(A_y_1*t222 + A_y_2*t217 + A_y_3*t218 + A_y_4*t219 + A_y_5*t220 + A_y_6*t221);
    const pkmodes_real D_p_dot_z_1 =
        t42*(A_z_1*t222 + A_z_2*t217 + A_z_3*t218 + A_z_4*t219 + A_z_5*t220 + A_z_6*t221);
    const pkmodes_real D_p_dot_rx_1 =
        t42*(A_rx_1*t222 + A_rx_2*t217 + A_rx_3*t218 + A_rx_4*t219 + A_rx_5*t220 + A_rx_6*t221);
    const pkmodes_real D_p_dot_ry_1 =
        t42*(A_ry_1*t222 + A_ry_2*t217 + A_ry_3*t218 + A_ry_4*t219 + A_ry_5*t220 + A_ry_6*t221);
    const pkmodes_real D_p_dot_rz_1 =
        t42*(A_rz_1*t222 + A_rz_2*t217 + A_rz_3*t218 + A_rz_4*t219 + A_rz_5*t220 + A_rz_6*t221);
    const pkmodes_real t223 =
        -D_l_dot_1_rx*D_p_rx_2 - D_l_dot_1_ry*D_p_ry_2 - D_l_dot_1_rz*D_p_rz_2 - D_p_x_2*s_dot_1_x
        - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t224 =
        -D_l_dot_3_rx*D_p_rx_2 - D_l_dot_3_ry*D_p_ry_2 - D_l_dot_3_rz*D_p_rz_2 - D_p_x_2*s_dot_3_x
        - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t225 =
        -D_l_dot_4_rx*D_p_rx_2 - D_l_dot_4_ry*D_p_ry_2 - D_l_dot_4_rz*D_p_rz_2 - D_p_x_2*s_dot_4_x
        - D_p_y_2*s_dot_4_y - D_p_z_2*s_dot_4_z;
    const pkmodes_real t226 =
        -D_l_dot_5_rx*D_p_rx_2 - D_l_dot_5_ry*D_p_ry_2 - D_l_dot_5_rz*D_p_rz_2 - D_p_x_2*s_dot_5_x
        - D_p_y_2*s_dot_5_y - D_p_z_2*s_dot_5_z;
    const pkmodes_real t227 =
        -D_l_dot_6_rx*D_p_rx_2 - D_l_dot_6_ry*D_p_ry_2 - D_l_dot_6_rz*D_p_rz_2 - D_p_x_2*s_dot_6_x
        - D_p_y_2*s_dot_6_y - D_p_z_2*s_dot_6_z;
    const pkmodes_real t228 =
        -D_l_dot_2_rx*D_p_rx_2 - D_l_dot_2_ry*D_p_ry_2 - D_l_dot_2_rz*D_p_rz_2 - D_p_x_2*s_dot_2_x
        - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + n_2_x*s_dot_2_x + n_2_y*s_dot_2_y + n_2_z*s_dot_2_z;
    const pkmodes_real D_p_dot_x_2 =
        t42*(A_x_1*t223 + A_x_2*t228 + A_x_3*t224 + A_x_4*t225 + A_x_5*t226 + A_x_6*t227);
    const pkmodes_real D_p_dot_y_2 =
        t42*(A_y_1*t223 + A_y_2*t228 + A_y_3*t224 + A_y_4*t225 + A_y_5*t226 + A_y_6*t227);
    const pkmodes_real D_p_dot_z_2 =
        t42*(A_z_1*t223 + A_z_2*t228 + A_z_3*t224 + A_z_4*t225 + A_z_5*t226 + A_z_6*t227);
    const pkmodes_real D_p_dot_rx_2 =
        t42*(A_rx_1*t223 + A_rx_2*t228 + A_rx_3*t224 + A_rx_4*t225 + A_rx_5*t226 + A_rx_6*t227);
    const pkmodes_real D_p_dot_ry_2 =
        t42*(A_ry_1*t223 + A_ry_2*t228 + A_ry_3*t224 + A_ry_4*t225 + A_ry_5*t226 + A_ry_6*t227);
    const pkmodes_real D_p_dot_rz_2 =
        t42*(A_rz_1*t223 + A_rz_2*t228 + A_rz_3*t224 + A_rz_4*t225 + A_rz_5*t226 + A_rz_6*t227);
    const pkmodes_real t229 =
        -D_l_dot_1_rx*D_p_rx_3 - D_l_dot_1_ry*D_p_ry_3 - D_l_dot_1_rz*D_p_rz_3 - D_p_x_3*s_dot_1_x
        - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t230 =
        -D_l_dot_2_rx*D_p_rx_3 - D_l_dot_2_ry*D_p_ry_3 - D_l_dot_2_rz*D_p_rz_3 - D_p_x_3*s_dot_2_x
        - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t231 =
        -D_l_dot_4_rx*D_p_rx_3 - D_l_dot_4_ry*D_p_ry_3 - D_l_dot_4_rz*D_p_rz_3 - D_p_x_3*s_dot_4_x
        - D_p_y_3*s_dot_4_y - D_p_z_3*s_dot_4_z;
    const pkmodes_real t232 =
        -D_l_dot_5_rx*D_p_rx_3 - D_l_dot_5_ry*D_p_ry_3 - D_l_dot_5_rz*D_p_rz_3 - D_p_x_3*s_dot_5_x
        - D_p_y_3*s_dot_5_y - D_p_z_3*s_dot_5_z;
    const pkmodes_real t233 =
        -D_l_dot_6_rx*D_p_rx_3 - D_l_dot_6_ry*D_p_ry_3 - D_l_dot_6_rz*D_p_rz_3 - D_p_x_3*s_dot_6_x
        - D_p_y_3*s_dot_6_y - D_p_z_3*s_dot_6_z;
    const pkmodes_real t234 =
        -D_l_dot_3_rx*D_p_rx_3 - D_l_dot_3_ry*D_p_ry_3 - D_l_dot_3_rz*D_p_rz_3 - D_p_x_3*s_dot_3_x
        - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + n_3_x*s_dot_3_x + n_3_y*s_dot_3_y + n_3_z*s_dot_3_z;
    const pkmodes_real D_p_dot_x_3 =
        t42*(A_x_1*t229 + A_x_2*t230 + A_x_3*t234 + A_x_4*t231 + A_x_5*t232 + A_x_6*t233);
    const pkmodes_real D_p_dot_y_3 =
        t42*(A_y_1*t229 + A_y_2*t230 + A_y_3*t234 + A_y_4*t231 + A_y_5*t232 + A_y_6*t233);
    const pkmodes_real D_p_dot_z_3 =
        t42*(A_z_1*t229 + A_z_2*t230 + A_z_3*t234 + A_z_4*t231 + A_z_5*t232 + A_z_6*t233);
    const pkmodes_real D_p_dot_rx_3 =
        t42*(A_rx_1*t229 + A_rx_2*t230 + A_rx_3*t234 + A_rx_4*t231 + A_rx_5*t232 + A_rx_6*t233);
    const pkmodes_real D_p_dot_ry_3 =
        t42*(A_ry_1*t229 + A_ry_2*t230 + A_ry_3*t234 + A_ry_4*t231 + A_ry_5*t232 + A_ry_6*t233);
    const pkmodes_real D_p_dot_rz_3 =
        t42*(A_rz_1*t229 + A_rz_2*t230 + A_rz_3*t234 + A_rz_4*t231 + A_rz_5*t232 + A_rz_6*t233);
    const pkmodes_real t235 =
        -D_l_dot_1_rx*D_p_rx_4 - D_l_dot_1_ry*D_p_ry_4 - D_l_dot_1_rz*D_p_rz_4 - D_p_x_4*s_dot_1_x
        - D_p_y_4*s_dot_1_y - D_p_z_4*s_dot_1_z;
    const pkmodes_real t236 =
        -D_l_dot_2_rx*D_p_rx_4 - D_l_dot_2_ry*D_p_ry_4 - D_l_dot_2_rz*D_p_rz_4 - D_p_x_4*s_dot_2_x
        - D_p_y_4*s_dot_2_y - D_p_z_4*s_dot_2_z;
    const pkmodes_real t237 =
        -D_l_dot_3_rx*D_p_rx_4 - D_l_dot_3_ry*D_p_ry_4 - D_l_dot_3_rz*D_p_rz_4 - D_p_x_4*s_dot_3_x
        - D_p_y_4*s_dot_3_y - D_p_z_4*s_dot_3_z;
    const pkmodes_real t238 =
        -D_l_dot_5_rx*D_p_rx_4 - D_l_dot_5_ry*D_p_ry_4 - D_l_dot_5_rz*D_p_rz_4 - D_p_x_4*s_dot_5_x
        - D_p_y_4*s_dot_5_y - D_p_z_4*s_dot_5_z;
    const pkmodes_real t239 =
        -D_l_dot_6_rx*D_p_rx_4 - D_l_dot_6_ry*D_p_ry_4 - D_l_dot_6_rz*D_p_rz_4 - D_p_x_4*s_dot_6_x
        - D_p_y_4*s_dot_6_y - D_p_z_4*s_dot_6_z;
    const pkmodes_real t240 =
        -D_l_dot_4_rx*D_p_rx_4 - D_l_dot_4_ry*D_p_ry_4 - D_l_dot_4_rz*D_p_rz_4 - D_p_x_4*s_dot_4_x
        - D_p_y_4*s_dot_4_y - D_p_z_4*s_dot_4_z + n_4_x*s_dot_4_x + n_4_y*s_dot_4_y + n_4_z*s_dot_4_z;
    const pkmodes_real D_p_dot_x_4 =
        t42*(A_x_1*t235 + A_x_2*t236 + A_x_3*t237 + A_x_4*t240 + A_x_5*t238 + A_x_6*t239);
    const pkmodes_real D_p_dot_y_4 =
        t42*(A_y_1*t235 + A_y_2*t236 + A_y_3*t237 + A_y_4*t240 + A_y_5*t238 + A_y_6*t239);
    const pkmodes_real D_p_dot_z_4 =
        t42*(A_z_1*t235 + A_z_2*t236 + A_z_3*t237 + A_z_4*t240 + A_z_5*t238 + A_z_6*t239);
    const pkmodes_real D_p_dot_rx_4 =
        t42*(A_rx_1*t235 + A_rx_2*t236 + A_rx_3*t237 + A_rx_4*t240 + A_rx_5*t238 + A_rx_6*t239);
    const pkmodes_real D_p_dot_ry_4 =
        t42*(A_ry_1*t235 + A_ry_2*t236 + A_ry_3*t237 + A_ry_4*t240 + A_ry_5*t238 + A_ry_6*t239);
    const pkmodes_real D_p_dot_rz_4 =
        t42*(A_rz_1*t235 + A_rz_2*t236 + A_rz_3*t237 + A_rz_4*t240 + A_rz_5*t238 + A_rz_6*t239);
    const pkmodes_real t241 =
        -D_l_dot_1_rx*D_p_rx_5 - D_l_dot_1_ry*D_p_ry_5 - D_l_dot_1_rz*D_p_rz_5 - D_p_x_5*s_dot_1_x
        - D_p_y_5*s_dot_1_y - D_p_z_5*s_dot_1_z;
    const pkmodes_real t242 =
        -D_l_dot_2_rx*D_p_rx_5 - D_l_dot_2_ry*D_p_ry_5 - D_l_dot_2_rz*D_p_rz_5 - D_p_x_5*s_dot_2_x
        - D_p_y_5*s_dot_2_y - D_p_z_5*s_dot_2_z;
    const pkmodes_real t243 =
        -D_l_dot_3_rx*D_p_rx_5 - D_l_dot_3_ry*D_p_ry_5 - D_l_dot_3_rz*D_p_rz_5 - D_p_x_5*s_dot_3_x
        - D_p_y_5*s_dot_3_y - D_p_z_5*s_dot_3_z;
    const pkmodes_real t244 =
        -D_l_dot_4_rx*D_p_rx_5 - D_l_dot_4_ry*D_p_ry_5 - D_l_dot_4_rz*D_p_rz_5 - D_p_x_5*s_dot_4_x
        - D_p_y_5*s_dot_4_y - D_p_z_5*s_dot_4_z;
    const pkmodes_real t245 =
        -D_l_dot_6_rx*D_p_rx_5 - D_l_dot_6_ry*D_p_ry_5 - D_l_dot_6_rz*D_p_rz_5 - D_p_x_5*s_dot_6_x
        - D_p_y_5*s_dot_6_y - D_p_z_5*s_dot_6_z;
    const pkmodes_real t246 =
        -D_l_dot_5_rx*D_p_rx_5 - D_l_dot_5_ry*D_p_ry_5 - D_l_dot_5_rz*D_p_rz_5 - D_p_x_5*s_dot_5_x
        - D_p_y_5*s_dot_5_y - D_p_z_5*s_dot_5_z + n_5_x*s_dot_5_x + n_5_y*s_dot_5_y + n_5_z*s_dot_5_z;
    const pkmodes_real D_p_dot_x_5 =
        t42*(A_x_1*t241 + A_x_2*t242 + A_x_3*t243 + A_x_4*t244 + A_x_5*t246 + A_x_6*t245);
    const pkmodes_real D_p_dot_y_5 =
        t42*(A_y_1*t241 + A_y_2*t242 + A_y_3*t243 + A_y_4*t244 + A_y_5*t246 + A_y_6*t245);
    const pkmodes_real D_p_dot_z_5 =
        t42*(A_z_1*t241 + A_z_2*t242 + A_z_3*t243 + A_z_4*t244 + A_z_5*t246 + A_z_6*t245);
    const pkmodes_real D_p_dot_rx_5 =
        t42*(A_rx_1*t241 + A_rx_2*t242 + A_rx_3*t243 + A_rx_4*t244 + A_rx_5*t246 + A_rx_6*t245);
    const pkmodes_real D_p_dot_ry_5 =
        t42*(A_ry_1*t241 + A_ry_2*t242 + A_ry_3*t243 + A_ry_4*t244 + A_ry_5*t246 + A_ry_6*t245);
    const pkmodes_real D_p_dot_rz_5 =
        t42*(A_rz_1*t241 + A_rz_2*t242 + A_rz_3*t243 + A_rz_4*t244 + A_rz_5*t246 + A_rz_6*t245);
    const pkmodes_real t247 =
        -D_l_dot_1_rx*D_p_rx_6 - D_l_dot_1_ry*D_p_ry_6 - D_l_dot_1_rz*D_p_rz_6 - D_p_x_6*s_dot_1_x
        - D_p_y_6*s_dot_1_y - D_p_z_6*s_dot_1_z;
    const pkmodes_real t248 =
        -D_l_dot_2_rx*D_p_rx_6 - D_l_dot_2_ry*D_p_ry_6 - D_l_dot_2_rz*D_p_rz_6 - D_p_x_6*s_dot_2_x
        - D_p_y_6*s_dot_2_y - D_p_z_6*s_dot_2_z;
    const pkmodes_real t249 =
        -D_l_dot_3_rx*D_p_rx_6 - D_l_dot_3_ry*D_p_ry_6 - D_l_dot_3_rz*D_p_rz_6 - D_p_x_6*s_dot_3_x
        - D_p_y_6*s_dot_3_y - D_p_z_6*s_dot_3_z;
    const pkmodes_real t250 =
        -D_l_dot_4_rx*D_p_rx_6 - D_l_dot_4_ry*D_p_ry_6 - D_l_dot_4_rz*D_p_rz_6 - D_p_x_6*s_dot_4_x
        - D_p_y_6*s_dot_4_y - D_p_z_6*s_dot_4_z;
    const pkmodes_real t251 =
        -D_l_dot_5_rx*D_p_rx_6 - D_l_dot_5_ry*D_p_ry_6 - D_l_dot_5_rz*D_p_rz_6 - D_p_x_6*s_dot_5_x
        - D_p_y_6*s_dot_5_y - D_p_z_6*s_dot_5_z;
    const pkmodes_real t252 =
        -D_l_dot_6_rx*D_p_rx_6 - D_l_dot_6_ry*D_p_ry_6 - D_l_dot_6_rz*D_p_rz_6 - D_p_x_6*s_dot_6_x
        - D_p_y_6*s_dot_6_y - D_p_z_6*s_dot_6_z + n_6_x*s_dot_6_x + n_6_y*s_dot_6_y + n_6_z*s_dot_6_z;
    const pkmodes_real D_p_dot_x_6 =
        t42*(A_x_1*t247 + A_x_2*t248 + A_x_3*t249 + A_x_4*t250 + A_x_5*t251 + A_x_6*t252);
    const pkmodes_real D_p_dot_y_6 =
        t42*(A_y_1*t247 + A_y_2*t248 + A_y_3*t249 + A_y_4*t250 + A_y_5*t251 + A_y_6*t252);
    const pkmodes_real D_p_dot_z_6 =
        t42*(A_z_1*t247 + A_z_2*t248 + A_z_3*t249 + A_z_4*t250 + A_z_5*t251 + A_z_6*t252);
    const pkmodes_real D_p_dot_rx_6 =
        t42*(A_rx_1*t247 + A_rx_2*t248 + A_rx_3*t249 + A_rx_4*t250 + A_rx_5*t251 + A_rx_6*t252);
    const pkmodes_real D_p_dot_ry_6 =
        t42*(A_ry_1*t247 + A_ry_2*t248 + A_ry_3*t249 + A_ry_4*t250 + A_ry_5*t251 + A_ry_6*t252);
    const pkmodes_real D_p_dot_rz_6 =
        t42*(A_rz_1*t247 + A_rz_2*t248 + A_rz_3*t249 + A_rz_4*t250 + A_rz_5*t251 + A_rz_6*t252);
    const pkmodes_real a_p_x =
        D_p_dot_x_1*x_1_dot + D_p_dot_x_2*x_2_dot + D_p_dot_x_3*x_3_dot + D_p_dot_x_4*x_4_dot
        + D_p_dot_x_5*x_5_dot + D_p_dot_x_6*x_6_dot;
    const pkmodes_real a_p_y =
        D_p_dot_y_1*x_1_dot + D_p_dot_y_2*x_2_dot + D_p_dot_y_3*x_3_dot + D_p_dot_y_4*x_4_dot
        + D_p_dot_y_5*x_5_dot + D_p_dot_y_6*x_6_dot;
    const pkmodes_real a_p_z =
        D_p_dot_z_1*x_1_dot + D_p_dot_z_2*x_2_dot + D_p_dot_z_3*x_3_dot + D_p_dot_z_4*x_4_dot
        + D_p_dot_z_5*x_5_dot + D_p_dot_z_6*x_6_dot;
    const pkmodes_real a_p_rx =
        D_p_dot_rx_1*x_1_dot + D_p_dot_rx_2*x_2_dot + D_p_dot_rx_3*x_3_dot + D_p_dot_rx_4*x_4_dot
        + D_p_dot_rx_5*x_5_dot + D_p_dot_rx_6*x_6_dot;
    const pkmodes_real a_p_ry =
        D_p_dot_ry_1*x_1_dot + D_p_dot_ry_2*x_2_dot + D_p_dot_ry_3*x_3_dot + D_p_dot_ry_4*x_4_dot
        + D_p_dot_ry_5*x_5_dot + D_p_dot_ry_6*x_6_dot;
    const pkmodes_real a_p_rz =
        D_p_dot_rz_1*x_1_dot + D_p_dot_rz_2*x_2_dot + D_p_dot_rz_3*x_3_dot + D_p_dot_rz_4*x_4_dot
        + D_p_dot_rz_5*x_5_dot + D_p_dot_rz_6*x_6_dot;
    const pkmodes_real t253 = 2*v_p_y;
    const pkmodes_real t254 = c_x*w_p_y;
    const pkmodes_real t255 = 2*c_y;
    const pkmodes_real t256 = c_x*w_p_z;
    const pkmodes_real t257 = 2*t256;
    const pkmodes_real t258 = (c_y*c_y);
    const pkmodes_real t259 = (c_z*c_z);
    const pkmodes_real t260 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real t261 = B_1_x*w_p_y;
    const pkmodes_real t262 = 2*B_1_y;
    const pkmodes_real t263 = B_1_x*w_p_z;
    const pkmodes_real t264 = 2*B_1_z;
    const pkmodes_real t265 = (B_1_y*B_1_y);
    const pkmodes_real t266 = (B_1_z*B_1_z);
    const pkmodes_real t267 = B_1_y*n_1_z - B_1_z*n_1_y;
    const pkmodes_real t268 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t269 = B_2_x*w_p_y;
    const pkmodes_real t270 = 2*B_2_y;
    const pkmodes_real t271 = B_2_x*w_p_z;
    const pkmodes_real t272 = 2*B_2_z;
    const pkmodes_real t273 = (B_2_y*B_2_y);
    const pkmodes_real t274 = (B_2_z*B_2_z);
    const pkmodes_real t275 = B_2_y*n_2_z - B_2_z*n_2_y;
    const pkmodes_real t276 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t277 = B_3_x*w_p_y;
    const pkmodes_real t278 = 2*B_3_y;
    const pkmodes_real t279 = B_3_x*w_p_z;
    const pkmodes_real t280 = 2*B_3_z;
    const pkmodes_real t281 = (B_3_y*B_3_y);
    const pkmodes_real t282 = (B_3_z*B_3_z);
    const pkmodes_real t283 = B_3_y*n_3_z - B_3_z*n_3_y;
    const pkmodes_real t284 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t285 = B_4_x*w_p_y;
    const pkmodes_real t286 = 2*B_4_y;
    const pkmodes_real t287 = B_4_x*w_p_z;
    const pkmodes_real t288 = 2*B_4_z;
    const pkmodes_real t289 = (B_4_y*B_4_y);
    const pkmodes_real t290 = (B_4_z*B_4_z);
    const pkmodes_real t291 = B_4_y*n_4_z - B_4_z*n_4_y;
    const pkmodes_real t292 = (R(1.0)/R(6.0))*m_d_4;
    const pkmodes_real t293 = B_5_x*w_p_y;
    const pkmodes_real t294 = 2*B_5_y;
    const pkmodes_real t295 = B_5_x*w_p_z;
    const pkmodes_real t296 = 2*B_5_z;
    const pkmodes_real t297 = (B_5_y*B_5_y);
    const pkmodes_real t298 = (B_5_z*B_5_z);
    const pkmodes_real t299 = B_5_y*n_5_z - B_5_z*n_5_y;
    const pkmodes_real t300 = (R(1.0)/R(6.0))*m_d_5;
    const pkmodes_real t301 = B_6_x*w_p_y;
    const pkmodes_real t302 = 2*B_6_y;
    const pkmodes_real t303 = B_6_x*w_p_z;
    const pkmodes_real t304 = 2*B_6_z;
    const pkmodes_real t305 = (B_6_y*B_6_y);
    const pkmodes_real t306 = (B_6_z*B_6_z);
    const pkmodes_real t307 = B_6_y*n_6_z - B_6_z*n_6_y;
    const pkmodes_real t308 = (R(1.0)/R(6.0))*m_d_6;
    const pkmodes_real pi_rx =
        J_x_x*w_p_x + J_x_y*w_p_y + J_x_z*w_p_z + t260*(2*c_y*v_p_z - c_z*t253 - c_z*t257 - t254*t255
        + 2*w_p_x*(t258 + t259)) + t268*(2*B_1_y*v_p_z - B_1_z*t253 - t261*t262 - t263*t264 + t267*x_1_dot
        + 2*w_p_x*(t265 + t266)) + t276*(2*B_2_y*v_p_z - B_2_z*t253 - t269*t270 - t271*t272 + t275*x_2_dot
        + 2*w_p_x*(t273 + t274)) + t284*(2*B_3_y*v_p_z - B_3_z*t253 - t277*t278 - t279*t280 + t283*x_3_dot
        + 2*w_p_x*(t281 + t282)) + t292*(2*B_4_y*v_p_z - B_4_z*t253 - t285*t286 - t287*t288 + t291*x_4_dot
        + 2*w_p_x*(t289 + t290)) + t300*(2*B_5_y*v_p_z - B_5_z*t253 - t293*t294 - t295*t296 + t299*x_5_dot
        + 2*w_p_x*(t297 + t298)) + t308*(2*B_6_y*v_p_z - B_6_z*t253 - t301*t302 - t303*t304 + t307*x_6_dot
        + 2*w_p_x*(t305 + t306));
    const pkmodes_real t309 = 2*v_p_z;
    const pkmodes_real t310 = c_y*w_p_x;
    const pkmodes_real t311 = 2*t310;
    const pkmodes_real t312 = c_y*w_p_z;
    const pkmodes_real t313 = (c_x*c_x);
    const pkmodes_real t314 = B_1_y*w_p_x;
    const pkmodes_real t315 = 2*B_1_x;
    const pkmodes_real t316 = B_1_y*w_p_z;
    const pkmodes_real t317 = (B_1_x*B_1_x);
    const pkmodes_real t318 = -B_1_x*n_1_z + B_1_z*n_1_x;
    const pkmodes_real t319 = B_2_y*w_p_x;
    const pkmodes_real t320 = 2*B_2_x;
    const pkmodes_real t321 = B_2_y*w_p_z;
    const pkmodes_real t322 = (B_2_x*B_2_x);
    const pkmodes_real t323 = -B_2_x*n_2_z + B_2_z*n_2_x;
    const pkmodes_real t324 = B_3_y*w_p_x;
    const pkmodes_real t325 = 2*B_3_x;
    const pkmodes_real t326 = B_3_y*w_p_z;
    const pkmodes_real t327 = (B_3_x*B_3_x);
    const pkmodes_real t328 = -B_3_x*n_3_z + B_3_z*n_3_x;
    const pkmodes_real t329 = B_4_y*w_p_x;
    const pkmodes_real t330 = 2*B_4_x;
    const pkmodes_real t331 = B_4_y*w_p_z;
    const pkmodes_real t332 = (B_4_x*B_4_x);
    const pkmodes_real t333 = -B_4_x*n_4_z + B_4_z*n_4_x;
    const pkmodes_real t334 = B_5_y*w_p_x;
    const pkmodes_real t335 = 2*B_5_x;
    const pkmodes_real t336 = B_5_y*w_p_z;
    const pkmodes_real t337 = (B_5_x*B_5_x);
    const pkmodes_real t338 = -B_5_x*n_5_z + B_5_z*n_5_x;
    const pkmodes_real t339 = B_6_y*w_p_x;
    const pkmodes_real t340 = 2*B_6_x;
    const pkmodes_real t341 = B_6_y*w_p_z;
    const pkmodes_real t342 = (B_6_x*B_6_x);
    const pkmodes_real t343 = -B_6_x*n_6_z + B_6_z*n_6_x;
    const pkmodes_real pi_ry =
        J_x_y*w_p_x + J_y_y*w_p_y + J_y_z*w_p_z + t260*(-c_x*t309 - c_x*t311 - 2*c_z*t312 + 2*c_z*v_p_x
        + 2*w_p_y*(t259 + t313)) + t268*(-B_1_x*t309 + 2*B_1_z*v_p_x - t264*t316 - t314*t315 + t318*x_1_dot
        + 2*w_p_y*(t266 + t317)) + t276*(-B_2_x*t309 + 2*B_2_z*v_p_x - t272*t321 - t319*t320 + t323*x_2_dot
        + 2*w_p_y*(t274 + t322)) + t284*(-B_3_x*t309 + 2*B_3_z*v_p_x - t280*t326 - t324*t325 + t328*x_3_dot
        + 2*w_p_y*(t282 + t327)) + t292*(-B_4_x*t309 + 2*B_4_z*v_p_x - t288*t331 - t329*t330 + t333*x_4_dot
        + 2*w_p_y*(t290 + t332)) + t300*(-B_5_x*t309 + 2*B_5_z*v_p_x - t296*t336 - t334*t335 + t338*x_5_dot
        + 2*w_p_y*(t298 + t337)) + t308*(-B_6_x*t309 + 2*B_6_z*v_p_x - t304*t341 - t339*t340 + t343*x_6_dot
        + 2*w_p_y*(t306 + t342));
    const pkmodes_real t344 = 2*v_p_x;
    const pkmodes_real t345 = c_z*w_p_x;
    const pkmodes_real t346 = 2*c_x;
    const pkmodes_real t347 = c_z*w_p_y;
    const pkmodes_real t348 = B_1_z*w_p_x;
    const pkmodes_real t349 = B_1_z*w_p_y;
    const pkmodes_real t350 = B_1_x*n_1_y - B_1_y*n_1_x;
    const pkmodes_real t351 = B_2_z*w_p_x;
    const pkmodes_real t352 = B_2_z*w_p_y;
    const pkmodes_real t353 = B_2_x*n_2_y - B_2_y*n_2_x;
    const pkmodes_real t354 = B_3_z*w_p_x;
    const pkmodes_real t355 = B_3_z*w_p_y;
    const pkmodes_real t356 = B_3_x*n_3_y - B_3_y*n_3_x;
    const pkmodes_real t357 = B_4_z*w_p_x;
    const pkmodes_real t358 = B_4_z*w_p_y;
    const pkmodes_real t359 = B_4_x*n_4_y - B_4_y*n_4_x;
    const pkmodes_real t360 = B_5_z*w_p_x;
    const pkmodes_real t361 = B_5_z*w_p_y;
    const pkmodes_real t362 = B_5_x*n_5_y - B_5_y*n_5_x;
    const pkmodes_real t363 = B_6_z*w_p_x;
    const pkmodes_real t364 = B_6_z*w_p_y;
    const pkmodes_real t365 = B_6_x*n_6_y - B_6_y*n_6_x;
    const pkmodes_real pi_rz =
        J_x_z*w_p_x + J_y_z*w_p_y + J_z_z*w_p_z + t260*(2*c_x*v_p_y - c_y*t344 - t255*t347 - t345*t346
        + 2*w_p_z*(t258 + t313)) + t268*(2*B_1_x*v_p_y - B_1_y*t344 - t262*t349 - t315*t348 + t350*x_1_dot
        + 2*w_p_z*(t265 + t317)) + t276*(2*B_2_x*v_p_y - B_2_y*t344 - t270*t352 - t320*t351 + t353*x_2_dot
        + 2*w_p_z*(t273 + t322)) + t284*(2*B_3_x*v_p_y - B_3_y*t344 - t278*t355 - t325*t354 + t356*x_3_dot
        + 2*w_p_z*(t281 + t327)) + t292*(2*B_4_x*v_p_y - B_4_y*t344 - t286*t358 - t330*t357 + t359*x_4_dot
        + 2*w_p_z*(t289 + t332)) + t300*(2*B_5_x*v_p_y - B_5_y*t344 - t294*t361 - t335*t360 + t362*x_5_dot
        + 2*w_p_z*(t297 + t337)) + t308*(2*B_6_x*v_p_y - B_6_y*t344 - t302*t364 - t340*t363 + t365*x_6_dot
        + 2*w_p_z*(t305 + t342));
    const pkmodes_real t366 = c_y*w_p_x - t254;
    const pkmodes_real t367 = m_p*t366;
    const pkmodes_real t368 = B_1_y*w_p_x - t261;
    const pkmodes_real t369 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t370 = t368*t369;
    const pkmodes_real t371 = t263 - t348;
    const pkmodes_real t372 = t369*w_p_z;
    const pkmodes_real t373 = B_2_y*w_p_x - t269;
    const pkmodes_real t374 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t375 = t373*t374;
    const pkmodes_real t376 = t271 - t351;
    const pkmodes_real t377 = t374*w_p_z;
    const pkmodes_real t378 = B_3_y*w_p_x - t277;
    const pkmodes_real t379 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t380 = t378*t379;
    const pkmodes_real t381 = t279 - t354;
    const pkmodes_real t382 = t379*w_p_z;
    const pkmodes_real t383 = B_4_y*w_p_x - t285;
    const pkmodes_real t384 = (R(1.0)/R(3.0))*m_d_4;
    const pkmodes_real t385 = t383*t384;
    const pkmodes_real t386 = t287 - t357;
    const pkmodes_real t387 = t384*w_p_z;
    const pkmodes_real t388 = B_5_y*w_p_x - t293;
    const pkmodes_real t389 = (R(1.0)/R(3.0))*m_d_5;
    const pkmodes_real t390 = t388*t389;
    const pkmodes_real t391 = t295 - t360;
    const pkmodes_real t392 = t389*w_p_z;
    const pkmodes_real t393 = B_6_y*w_p_x - t301;
    const pkmodes_real t394 = (R(1.0)/R(3.0))*m_d_6;
    const pkmodes_real t395 = t393*t394;
    const pkmodes_real t396 = t303 - t363;
    const pkmodes_real t397 = t394*w_p_z;
    const pkmodes_real t398 = t256 - t345;
    const pkmodes_real t399 = m_p*w_p_z;
    const pkmodes_real t400 = m_p + t369 + t374 + t379 + t384 + t389 + t394;
    const pkmodes_real t401 = c_z*m_p;
    const pkmodes_real t402 = B_1_z*t369;
    const pkmodes_real t403 = B_2_z*t374;
    const pkmodes_real t404 = B_3_z*t379;
    const pkmodes_real t405 = B_4_z*t384;
    const pkmodes_real t406 = B_5_z*t389;
    const pkmodes_real t407 = B_6_z*t394;
    const pkmodes_real t408 = t401 + t402 + t403 + t404 + t405 + t406 + t407;
    const pkmodes_real t409 = c_y*m_p;
    const pkmodes_real t410 = B_1_y*t369;
    const pkmodes_real t411 = B_2_y*t374;
    const pkmodes_real t412 = B_3_y*t379;
    const pkmodes_real t413 = B_4_y*t384;
    const pkmodes_real t414 = B_5_y*t389;
    const pkmodes_real t415 = B_6_y*t394;
    const pkmodes_real t416 = t409 + t410 + t411 + t412 + t413 + t414 + t415;
    const pkmodes_real z_x =
        a_p_ry*t408 - a_p_rz*t416 + a_p_x*t400 + t367*w_p_y + t370*w_p_y - t371*t372 + t375*w_p_y - t376*t377
        + t380*w_p_y - t381*t382 + t385*w_p_y - t386*t387 + t390*w_p_y - t391*t392 + t395*w_p_y - t396*t397
        - t398*t399;
    const pkmodes_real t417 = c_z*w_p_y - t312;
    const pkmodes_real t418 = B_1_z*w_p_y - t316;
    const pkmodes_real t419 = B_2_z*w_p_y - t321;
    const pkmodes_real t420 = B_3_z*w_p_y - t326;
    const pkmodes_real t421 = B_4_z*w_p_y - t331;
    const pkmodes_real t422 = B_5_z*w_p_y - t336;
    const pkmodes_real t423 = B_6_z*w_p_y - t341;
    const pkmodes_real t424 = c_x*m_p;
    const pkmodes_real t425 =
        B_1_x*t369 + B_2_x*t374 + B_3_x*t379 + B_4_x*t384 + B_5_x*t389 + B_6_x*t394 + t424;
    const pkmodes_real z_y =
        -a_p_rx*t408 + a_p_rz*t425 + a_p_y*t400 - t367*w_p_x - t370*w_p_x + t372*t418 - t375*w_p_x
        + t377*t419 - t380*w_p_x + t382*t420 - t385*w_p_x + t387*t421 - t390*w_p_x + t392*t422 - t395*w_p_x
        + t397*t423 + t399*t417;
    const pkmodes_real z_z =
        a_p_rx*t416 - a_p_ry*t425 + a_p_z*t400 + m_p*t398*w_p_x - m_p*t417*w_p_y + t369*t371*w_p_x
        - t369*t418*w_p_y + t374*t376*w_p_x - t374*t419*w_p_y + t379*t381*w_p_x - t379*t420*w_p_y
        + t384*t386*w_p_x - t384*t421*w_p_y + t389*t391*w_p_x - t389*t422*w_p_y + t394*t396*w_p_x
        - t394*t423*w_p_y;
    const pkmodes_real t426 = 2*w_p_y;
    const pkmodes_real t427 = B_1_y*t426;
    const pkmodes_real t428 = 2*w_p_z;
    const pkmodes_real t429 = B_1_z*t428;
    const pkmodes_real t430 = t268*t418;
    const pkmodes_real t431 = B_2_y*t426;
    const pkmodes_real t432 = B_2_z*t428;
    const pkmodes_real t433 = t276*t419;
    const pkmodes_real t434 = B_3_y*t426;
    const pkmodes_real t435 = B_3_z*t428;
    const pkmodes_real t436 = t284*t420;
    const pkmodes_real t437 = B_4_y*t426;
    const pkmodes_real t438 = B_4_z*t428;
    const pkmodes_real t439 = t292*t421;
    const pkmodes_real t440 = B_5_y*t426;
    const pkmodes_real t441 = B_5_z*t428;
    const pkmodes_real t442 = t300*t422;
    const pkmodes_real t443 = B_6_y*t426;
    const pkmodes_real t444 = B_6_z*t428;
    const pkmodes_real t445 = t308*t423;
    const pkmodes_real t446 = c_y*t426;
    const pkmodes_real t447 = c_z*t428;
    const pkmodes_real t448 = t260*t417;
    const pkmodes_real t449 = t260*t366;
    const pkmodes_real t450 = t260*t398;
    const pkmodes_real t451 = n_1_z*x_1_dot;
    const pkmodes_real t452 = t309 + t451;
    const pkmodes_real t453 = t268*t371;
    const pkmodes_real t454 = n_2_z*x_2_dot;
    const pkmodes_real t455 = t309 + t454;
    const pkmodes_real t456 = t276*t376;
    const pkmodes_real t457 = n_3_z*x_3_dot;
    const pkmodes_real t458 = t309 + t457;
    const pkmodes_real t459 = t284*t381;
    const pkmodes_real t460 = n_4_z*x_4_dot;
    const pkmodes_real t461 = t309 + t460;
    const pkmodes_real t462 = t292*t386;
    const pkmodes_real t463 = n_5_z*x_5_dot;
    const pkmodes_real t464 = t309 + t463;
    const pkmodes_real t465 = t300*t391;
    const pkmodes_real t466 = n_6_z*x_6_dot;
    const pkmodes_real t467 = t309 + t466;
    const pkmodes_real t468 = t308*t396;
    const pkmodes_real t469 = n_1_y*x_1_dot;
    const pkmodes_real t470 = t253 + t469;
    const pkmodes_real t471 = t268*t368;
    const pkmodes_real t472 = n_2_y*x_2_dot;
    const pkmodes_real t473 = t253 + t472;
    const pkmodes_real t474 = t276*t373;
    const pkmodes_real t475 = n_3_y*x_3_dot;
    const pkmodes_real t476 = t253 + t475;
    const pkmodes_real t477 = t284*t378;
    const pkmodes_real t478 = n_4_y*x_4_dot;
    const pkmodes_real t479 = t253 + t478;
    const pkmodes_real t480 = t292*t383;
    const pkmodes_real t481 = n_5_y*x_5_dot;
    const pkmodes_real t482 = t253 + t481;
    const pkmodes_real t483 = t300*t388;
    const pkmodes_real t484 = n_6_y*x_6_dot;
    const pkmodes_real t485 = t253 + t484;
    const pkmodes_real t486 = t308*t393;
    const pkmodes_real t487 = (w_p_x*w_p_x);
    const pkmodes_real t488 = (w_p_y*w_p_y);
    const pkmodes_real t489 = 2*w_p_x;
    const pkmodes_real t490 = t253*w_p_x - 2*v_p_x*w_p_y;
    const pkmodes_real t491 =
        c_z*t487 + c_z*t488 - R(1.0)/R(2.0)*t256*t489 - R(1.0)/R(2.0)*t312*t426 - R(1.0)/R(2.0)*t490;
    const pkmodes_real t492 = (w_p_z*w_p_z);
    const pkmodes_real t493 = t344*w_p_z - 2*v_p_z*w_p_x;
    const pkmodes_real t494 = 2*c_y*t487 + 2*c_y*t492 - t254*t489 - t347*t428 - t493;
    const pkmodes_real t495 = (R(1.0)/R(2.0))*t401;
    const pkmodes_real t496 =
        -B_1_x*t410 - B_2_x*t411 - B_3_x*t412 - B_4_x*t413 - B_5_x*t414 - B_6_x*t415 + J_x_y - c_x*t409;
    const pkmodes_real t497 =
        -B_1_x*t402 - B_2_x*t403 - B_3_x*t404 - B_4_x*t405 - B_5_x*t406 - B_6_x*t407 + J_x_z - c_x*t401;
    const pkmodes_real t498 =
        t268*(2*B_1_z*t487 + 2*B_1_z*t488 + n_1_x*w_p_y*x_1_dot - t263*t489 - t316*t426 - t469*w_p_x - t490);
    const pkmodes_real t499 = n_1_x*x_1_dot;
    const pkmodes_real t500 =
        2*B_1_y*t487 + 2*B_1_y*t492 + n_1_z*w_p_x*x_1_dot - t261*t489 - t349*t428 - t493 - t499*w_p_z;
    const pkmodes_real t501 = B_1_z*t268;
    const pkmodes_real t502 =
        t276*(2*B_2_z*t487 + 2*B_2_z*t488 + n_2_x*w_p_y*x_2_dot - t271*t489 - t321*t426 - t472*w_p_x - t490);
    const pkmodes_real t503 = n_2_x*x_2_dot;
    const pkmodes_real t504 =
        2*B_2_y*t487 + 2*B_2_y*t492 + n_2_z*w_p_x*x_2_dot - t269*t489 - t352*t428 - t493 - t503*w_p_z;
    const pkmodes_real t505 = B_2_z*t276;
    const pkmodes_real t506 =
        t284*(2*B_3_z*t487 + 2*B_3_z*t488 + n_3_x*w_p_y*x_3_dot - t279*t489 - t326*t426 - t475*w_p_x - t490);
    const pkmodes_real t507 = n_3_x*x_3_dot;
    const pkmodes_real t508 =
        2*B_3_y*t487 + 2*B_3_y*t492 + n_3_z*w_p_x*x_3_dot - t277*t489 - t355*t428 - t493 - t507*w_p_z;
    const pkmodes_real t509 = B_3_z*t284;
    const pkmodes_real t510 =
        t292*(2*B_4_z*t487 + 2*B_4_z*t488 + n_4_x*w_p_y*x_4_dot - t287*t489 - t331*t426 - t478*w_p_x - t490);
    const pkmodes_real t511 = n_4_x*x_4_dot;
    const pkmodes_real t512 =
        2*B_4_y*t487 + 2*B_4_y*t492 + n_4_z*w_p_x*x_4_dot - t285*t489 - t358*t428 - t493 - t511*w_p_z;
    const pkmodes_real t513 = B_4_z*t292;
    const pkmodes_real t514 =
        t300*(2*B_5_z*t487 + 2*B_5_z*t488 + n_5_x*w_p_y*x_5_dot - t295*t489 - t336*t426 - t481*w_p_x - t490);
    const pkmodes_real t515 = n_5_x*x_5_dot;
    const pkmodes_real t516 =
        2*B_5_y*t487 + 2*B_5_y*t492 + n_5_z*w_p_x*x_5_dot - t293*t489 - t361*t428 - t493 - t515*w_p_z;
    const pkmodes_real t517 = B_5_z*t300;
    const pkmodes_real t518 =
        t308*(2*B_6_z*t487 + 2*B_6_z*t488 + n_6_x*w_p_y*x_6_dot - t303*t489 - t341*t426 - t484*w_p_x - t490);
    const pkmodes_real t519 = n_6_x*x_6_dot;
    const pkmodes_real t520 =
        2*B_6_y*t487 + 2*B_6_y*t492 + n_6_z*w_p_x*x_6_dot - t301*t489 - t364*t428 - t493 - t519*w_p_z;
    const pkmodes_real t521 = B_6_z*t308;
    const pkmodes_real t522 = t12 + t14 + t18;
    const pkmodes_real t523 = w_p_x*w_p_y;
    const pkmodes_real t524 = t24 + t25 + t33;
    const pkmodes_real t525 = w_p_y*w_p_z;
    const pkmodes_real t526 = I_p_x*R_y_x;
    const pkmodes_real t527 = t28 + t30 + 2*t526;
    const pkmodes_real t528 = (R(1.0)/R(2.0))*t488;
    const pkmodes_real t529 = t522*t523 + t524*t525 + t527*t528;
    const pkmodes_real t530 = t16 + t19 + t21;
    const pkmodes_real t531 = t26 + t34 + t36;
    const pkmodes_real t532 = I_p_xy*R_y_x;
    const pkmodes_real t533 = I_p_y*R_y_y;
    const pkmodes_real t534 = t32 + 2*t532 + 2*t533;
    const pkmodes_real t535 = t523*t530 + t525*t531 + t528*t534;
    const pkmodes_real t536 = t20 + t22 + t23;
    const pkmodes_real t537 = t35 + t37 + t38;
    const pkmodes_real t538 = I_p_xz*R_y_x;
    const pkmodes_real t539 = I_p_yz*R_y_y;
    const pkmodes_real t540 = I_p_z*R_y_z;
    const pkmodes_real t541 = 2*t538 + 2*t539 + 2*t540;
    const pkmodes_real t542 = t523*t536 + t525*t537 + t528*t541;
    const pkmodes_real t543 = w_p_x*w_p_z;
    const pkmodes_real t544 = t27 + t29 + t526;
    const pkmodes_real t545 = 2*t33 + t39 + t40;
    const pkmodes_real t546 = (R(1.0)/R(2.0))*t492;
    const pkmodes_real t547 = t522*t543 + t525*t544 + t545*t546;
    const pkmodes_real t548 = t31 + t532 + t533;
    const pkmodes_real t549 = 2*t34 + 2*t36 + t41;
    const pkmodes_real t550 = t525*t548 + t530*t543 + t546*t549;
    const pkmodes_real t551 = t538 + t539 + t540;
    const pkmodes_real t552 = 2*t35 + 2*t37 + 2*t38;
    const pkmodes_real t553 = t525*t551 + t536*t543 + t546*t552;
    const pkmodes_real t554 = -R_y_x*w_p_z + R_z_x*w_p_y;
    const pkmodes_real t555 = t13 + t15 + 2*t18;
    const pkmodes_real t556 = -R_y_y*w_p_z + R_z_y*w_p_y;
    const pkmodes_real t557 = t17 + 2*t19 + 2*t21;
    const pkmodes_real t558 = -R_y_z*w_p_z + R_z_z*w_p_y;
    const pkmodes_real t559 = 2*t20 + 2*t22 + 2*t23;
    const pkmodes_real t560 = 2*t265;
    const pkmodes_real t561 = 2*t266;
    const pkmodes_real t562 = 2*t273;
    const pkmodes_real t563 = 2*t274;
    const pkmodes_real t564 = 2*t281;
    const pkmodes_real t565 = 2*t282;
    const pkmodes_real t566 = 2*t289;
    const pkmodes_real t567 = 2*t290;
    const pkmodes_real t568 = 2*t297;
    const pkmodes_real t569 = 2*t298;
    const pkmodes_real t570 = 2*t305;
    const pkmodes_real t571 = 2*t306;
    const pkmodes_real t572 = 2*t258;
    const pkmodes_real t573 = 2*t259;
    const pkmodes_real t574 = R_x_x*w_p_z - R_z_x*w_p_x;
    const pkmodes_real t575 = R_x_y*w_p_z - R_z_y*w_p_x;
    const pkmodes_real t576 = R_x_z*w_p_z - R_z_z*w_p_x;
    const pkmodes_real t577 = t522*t574 + t530*t575 + t536*t576 + t544*t554 + t548*t556 + t551*t558;
    const pkmodes_real t578 = -R_x_x*w_p_y + R_y_x*w_p_x;
    const pkmodes_real t579 = -R_x_y*w_p_y + R_y_y*w_p_x;
    const pkmodes_real t580 = -R_x_z*w_p_y + R_y_z*w_p_x;
    const pkmodes_real t581 = t522*t578 + t524*t554 + t530*t579 + t531*t556 + t536*t580 + t537*t558;
    const pkmodes_real z_rx =
        -B_1_y*t498 - B_2_y*t502 - B_3_y*t506 - B_4_y*t510 - B_5_y*t514 - B_6_y*t518 - R_y_x*t547
        - R_y_y*t550 - R_y_z*t553 + R_z_x*t529 + R_z_y*t535 + R_z_z*t542 + a_p_rx*(J_x_x + t260*(t572 + t573)
        + t268*(t560 + t561) + t276*(t562 + t563) + t284*(t564 + t565) + t292*(t566 + t567) + t300*(t568
        + t569) + t308*(t570 + t571)) + a_p_ry*t496 + a_p_rz*t497 - a_p_y*t408 + a_p_z*t416 + pi_ry*w_p_z
        - pi_rz*w_p_y - t409*t491 + t430*(-t427 - t429) + t433*(-t431 - t432) + t436*(-t434 - t435)
        + t439*(-t437 - t438) + t442*(-t440 - t441) + t445*(-t443 - t444) + t448*(-t446 - t447)
        + t449*(4*c_z*w_p_x - t253 - t257) + t450*(-2*t254 + t309 + 4*t310) + t453*(-2*t261 + 4*t314 + t452)
        + t456*(-2*t269 + 4*t319 + t455) + t459*(-2*t277 + 4*t324 + t458) + t462*(-2*t285 + 4*t329 + t461)
        + t465*(-2*t293 + 4*t334 + t464) + t468*(-2*t301 + 4*t339 + t467) + t471*(4*B_1_z*w_p_x - 2*t263
        - t470) + t474*(4*B_2_z*w_p_x - 2*t271 - t473) + t477*(4*B_3_z*w_p_x - 2*t279 - t476)
        + t480*(4*B_4_z*w_p_x - 2*t287 - t479) + t483*(4*B_5_z*w_p_x - 2*t295 - t482) + t486*(4*B_6_z*w_p_x
        - 2*t303 - t485) + t494*t495 + t500*t501 + t504*t505 + t508*t509 + t512*t513 + t516*t517 + t520*t521
        + t577*w_p_y + t581*w_p_z + w_p_x*(t554*t555 + t556*t557 + t558*t559);
    const pkmodes_real t582 = B_1_x*t489;
    const pkmodes_real t583 = B_2_x*t489;
    const pkmodes_real t584 = B_3_x*t489;
    const pkmodes_real t585 = B_4_x*t489;
    const pkmodes_real t586 = B_5_x*t489;
    const pkmodes_real t587 = B_6_x*t489;
    const pkmodes_real t588 = c_x*t489;
    const pkmodes_real t589 = t344 + t499;
    const pkmodes_real t590 = t344 + t503;
    const pkmodes_real t591 = t344 + t507;
    const pkmodes_real t592 = t344 + t511;
    const pkmodes_real t593 = t344 + t515;
    const pkmodes_real t594 = t344 + t519;
    const pkmodes_real t595 = t253*w_p_z - t309*w_p_y;
    const pkmodes_real t596 = -t310*t426 - t345*t428 + t346*t488 + t346*t492 + t595;
    const pkmodes_real t597 =
        -B_1_y*t402 - B_2_y*t403 - B_3_y*t404 - B_4_y*t405 - B_5_y*t406 - B_6_y*t407 + J_y_z - c_y*t401;
    const pkmodes_real t598 = -t314*t426 + t315*t488 + t315*t492 - t348*t428 - t451*w_p_y + t469*w_p_z + t595;
    const pkmodes_real t599 = -t319*t426 + t320*t488 + t320*t492 - t351*t428 - t454*w_p_y + t472*w_p_z + t595;
    const pkmodes_real t600 = -t324*t426 + t325*t488 + t325*t492 - t354*t428 - t457*w_p_y + t475*w_p_z + t595;
    const pkmodes_real t601 = -t329*t426 + t330*t488 + t330*t492 - t357*t428 - t460*w_p_y + t478*w_p_z + t595;
    const pkmodes_real t602 = -t334*t426 + t335*t488 + t335*t492 - t360*t428 - t463*w_p_y + t481*w_p_z + t595;
    const pkmodes_real t603 = -t339*t426 + t340*t488 + t340*t492 - t363*t428 - t466*w_p_y + t484*w_p_z + t595;
    const pkmodes_real t604 = (R(1.0)/R(2.0))*t487;
    const pkmodes_real t605 = t523*t544 + t524*t543 + t555*t604;
    const pkmodes_real t606 = t523*t548 + t531*t543 + t557*t604;
    const pkmodes_real t607 = t523*t551 + t537*t543 + t559*t604;
    const pkmodes_real t608 = 2*t317;
    const pkmodes_real t609 = 2*t322;
    const pkmodes_real t610 = 2*t327;
    const pkmodes_real t611 = 2*t332;
    const pkmodes_real t612 = 2*t337;
    const pkmodes_real t613 = 2*t342;
    const pkmodes_real t614 = 2*t313;
    const pkmodes_real t615 = t524*t574 + t531*t575 + t537*t576 + t544*t578 + t548*t579 + t551*t580;
    const pkmodes_real z_ry =
        B_1_x*t498 + B_2_x*t502 + B_3_x*t506 + B_4_x*t510 + B_5_x*t514 + B_6_x*t518 + R_x_x*t547 + R_x_y*t550
        + R_x_z*t553 - R_z_x*t605 - R_z_y*t606 - R_z_z*t607 + a_p_rx*t496 + a_p_ry*(J_y_y + t260*(t573
        + t614) + t268*(t561 + t608) + t276*(t563 + t609) + t284*(t565 + t610) + t292*(t567 + t611)
        + t300*(t569 + t612) + t308*(t571 + t613)) + a_p_rz*t597 + a_p_x*t408 - a_p_z*t425 - pi_rx*w_p_z
        + pi_rz*w_p_x + t424*t491 + t430*(4*B_1_x*w_p_y - 2*t314 - t452) + t433*(4*B_2_x*w_p_y - 2*t319
        - t455) + t436*(4*B_3_x*w_p_y - 2*t324 - t458) + t439*(4*B_4_x*w_p_y - 2*t329 - t461)
        + t442*(4*B_5_x*w_p_y - 2*t334 - t464) + t445*(4*B_6_x*w_p_y - 2*t339 - t467) + t448*(4*c_x*w_p_y
        - t309 - t311) + t449*(-2*t312 + t344 + 4*t347) + t450*(-t447 - t588) + t453*(-t429 - t582)
        + t456*(-t432 - t583) + t459*(-t435 - t584) + t462*(-t438 - t585) + t465*(-t441 - t586) + t468*(-t444
        - t587) + t471*(-2*t316 + 4*t349 + t589) + t474*(-2*t321 + 4*t352 + t590) + t477*(-2*t326 + 4*t355
        + t591) + t480*(-2*t331 + 4*t358 + t592) + t483*(-2*t336 + 4*t361 + t593) + t486*(-2*t341 + 4*t364
        + t594) - t495*t596 - t501*t598 - t505*t599 - t509*t600 - t513*t601 - t517*t602 - t521*t603
        + t577*w_p_x + t615*w_p_z + w_p_y*(t527*t574 + t534*t575 + t541*t576);
    const pkmodes_real z_rz =
        -B_1_x*t268*t500 + B_1_y*t268*t598 - B_2_x*t276*t504 + B_2_y*t276*t599 - B_3_x*t284*t508
        + B_3_y*t284*t600 - B_4_x*t292*t512 + B_4_y*t292*t601 - B_5_x*t300*t516 + B_5_y*t300*t602
        - B_6_x*t308*t520 + B_6_y*t308*t603 - R_x_x*t529 - R_x_y*t535 - R_x_z*t542 + R_y_x*t605 + R_y_y*t606
        + R_y_z*t607 + a_p_rx*t497 + a_p_ry*t597 + a_p_rz*(J_z_z + t260*(t572 + t614) + t268*(t560 + t608)
        + t276*(t562 + t609) + t284*(t564 + t610) + t292*(t566 + t611) + t300*(t568 + t612) + t308*(t570
        + t613)) - a_p_x*t416 + a_p_y*t425 + pi_rx*w_p_y - pi_ry*w_p_x + (R(1.0)/R(2.0))*t409*t596
        - R(1.0)/R(2.0)*t424*t494 + t430*(4*t263 - 2*t348 + t470) + t433*(4*t271 - 2*t351 + t473)
        + t436*(4*t279 - 2*t354 + t476) + t439*(4*t287 - 2*t357 + t479) + t442*(4*t295 - 2*t360 + t482)
        + t445*(4*t303 - 2*t363 + t485) + t448*(t253 + 4*t256 - 2*t345) + t449*(-t446 - t588)
        + t450*(4*c_y*w_p_z - t344 - 2*t347) + t453*(4*B_1_y*w_p_z - 2*t349 - t589) + t456*(4*B_2_y*w_p_z
        - 2*t352 - t590) + t459*(4*B_3_y*w_p_z - 2*t355 - t591) + t462*(4*B_4_y*w_p_z - 2*t358 - t592)
        + t465*(4*B_5_y*w_p_z - 2*t361 - t593) + t468*(4*B_6_y*w_p_z - 2*t364 - t594) + t471*(-t427 - t582)
        + t474*(-t431 - t583) + t477*(-t434 - t584) + t480*(-t437 - t585) + t483*(-t440 - t586) + t486*(-t443
        - t587) + t581*w_p_x + t615*w_p_y + w_p_z*(t545*t578 + t549*t579 + t552*t580);
    h[0] =
        D_p_rx_1*z_rx + D_p_ry_1*z_ry + D_p_rz_1*z_rz + D_p_x_1*z_x + D_p_y_1*z_y + D_p_z_1*z_z
        + a_p_rx*t267*t268 + a_p_ry*t268*t318 + a_p_rz*t268*t350 + a_p_x*n_1_x*t268 + a_p_y*n_1_y*t268
        + a_p_z*n_1_z*t268 + t430*(n_1_y*w_p_z - n_1_z*w_p_y) + t453*(-n_1_x*w_p_z + n_1_z*w_p_x)
        + t471*(n_1_x*w_p_y - n_1_y*w_p_x);
    h[1] =
        D_p_rx_2*z_rx + D_p_ry_2*z_ry + D_p_rz_2*z_rz + D_p_x_2*z_x + D_p_y_2*z_y + D_p_z_2*z_z
        + a_p_rx*t275*t276 + a_p_ry*t276*t323 + a_p_rz*t276*t353 + a_p_x*n_2_x*t276 + a_p_y*n_2_y*t276
        + a_p_z*n_2_z*t276 + t433*(n_2_y*w_p_z - n_2_z*w_p_y) + t456*(-n_2_x*w_p_z + n_2_z*w_p_x)
        + t474*(n_2_x*w_p_y - n_2_y*w_p_x);
    h[2] =
        D_p_rx_3*z_rx + D_p_ry_3*z_ry + D_p_rz_3*z_rz + D_p_x_3*z_x + D_p_y_3*z_y + D_p_z_3*z_z
        + a_p_rx*t283*t284 + a_p_ry*t284*t328 + a_p_rz*t284*t356 + a_p_x*n_3_x*t284 + a_p_y*n_3_y*t284
        + a_p_z*n_3_z*t284 + t436*(n_3_y*w_p_z - n_3_z*w_p_y) + t459*(-n_3_x*w_p_z + n_3_z*w_p_x)
        + t477*(n_3_x*w_p_y - n_3_y*w_p_x);
    h[3] =
        D_p_rx_4*z_rx + D_p_ry_4*z_ry + D_p_rz_4*z_rz + D_p_x_4*z_x + D_p_y_4*z_y + D_p_z_4*z_z
        + a_p_rx*t291*t292 + a_p_ry*t292*t333 + a_p_rz*t292*t359 + a_p_x*n_4_x*t292 + a_p_y*n_4_y*t292
        + a_p_z*n_4_z*t292 + t439*(n_4_y*w_p_z - n_4_z*w_p_y) + t462*(-n_4_x*w_p_z + n_4_z*w_p_x)
        + t480*(n_4_x*w_p_y - n_4_y*w_p_x);
    h[4] =
        D_p_rx_5*z_rx + D_p_ry_5*z_ry + D_p_rz_5*z_rz + D_p_x_5*z_x + D_p_y_5*z_y + D_p_z_5*z_z
        + a_p_rx*t299*t300 + a_p_ry*t300*t338 + a_p_rz*t300*t362 + a_p_x*n_5_x*t300 + a_p_y*n_5_y*t300
        + a_p_z*n_5_z*t300 + t442*(n_5_y*w_p_z - n_5_z*w_p_y) + t465*(-n_5_x*w_p_z + n_5_z*w_p_x)
        + t483*(n_5_x*w_p_y - n_5_y*w_p_x);
    h[5] =
        D_p_rx_6*z_rx + D_p_ry_6*z_ry + D_p_rz_6*z_rz + D_p_x_6*z_x + D_p_y_6*z_y + D_p_z_6*z_z
        + a_p_rx*t307*t308 + a_p_ry*t308*t343 + a_p_rz*t308*t365 + a_p_x*n_6_x*t308 + a_p_y*n_6_y*t308
        + a_p_z*n_6_z*t308 + t445*(n_6_y*w_p_z - n_6_z*w_p_y) + t468*(-n_6_x*w_p_z + n_6_z*w_p_x)
        + t486*(n_6_x*w_p_y - n_6_y*w_p_x);
}

void hexaglide_gravity_potential(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real *V_g)
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
    const pkmodes_real c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const pkmodes_real c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const pkmodes_real c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const pkmodes_real t12 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t14 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t15 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t16 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t17 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t18 = m_t_1*x_1;
    const pkmodes_real t19 = m_t_2*x_2;
    const pkmodes_real t20 = m_t_3*x_3;
    const pkmodes_real t21 = m_t_4*x_4;
    const pkmodes_real t22 = m_t_5*x_5;
    const pkmodes_real t23 = m_t_6*x_6;
    const pkmodes_real t24 = t12*x_1;
    const pkmodes_real t25 = t13*x_2;
    const pkmodes_real t26 = t14*x_3;
    const pkmodes_real t27 = t15*x_4;
    const pkmodes_real t28 = t16*x_5;
    const pkmodes_real t29 = t17*x_6;
    const pkmodes_real t30 = m_p + t12 + t13 + t14 + t15 + t16 + t17;
    *V_g =
        -g_x*(B_1_x*t12 + B_2_x*t13 + B_3_x*t14 + B_4_x*t15 + B_5_x*t16 + B_6_x*t17 + c_x*m_p + m_t_1*o_1_x
        + m_t_2*o_2_x + m_t_3*o_3_x + m_t_4*o_4_x + m_t_5*o_5_x + m_t_6*o_6_x + n_1_x*t18 + n_1_x*t24
        + n_2_x*t19 + n_2_x*t25 + n_3_x*t20 + n_3_x*t26 + n_4_x*t21 + n_4_x*t27 + n_5_x*t22 + n_5_x*t28
        + n_6_x*t23 + n_6_x*t29 + o_1_x*t12 + o_2_x*t13 + o_3_x*t14 + o_4_x*t15 + o_5_x*t16 + o_6_x*t17
        + p_x*t30) - g_y*(B_1_y*t12 + B_2_y*t13 + B_3_y*t14 + B_4_y*t15 + B_5_y*t16 + B_6_y*t17 + c_y*m_p
        + m_t_1*o_1_y + m_t_2*o_2_y + m_t_3*o_3_y + m_t_4*o_4_y + m_t_5*o_5_y + m_t_6*o_6_y + n_1_y*t18
        + n_1_y*t24 + n_2_y*t19 + n_2_y*t25 + n_3_y*t20 + n_3_y*t26 + n_4_y*t21 + n_4_y*t27 + n_5_y*t22
        + n_5_y*t28 + n_6_y*t23 + n_6_y*t29 + o_1_y*t12 + o_2_y*t13 + o_3_y*t14 + o_4_y*t15 + o_5_y*t16
        + o_6_y*t17 + p_y*t30) - g_z*(B_1_z*t12 + B_2_z*t13 + B_3_z*t14 + B_4_z*t15 + B_5_z*t16 + B_6_z*t17
        + c_z*m_p + m_t_1*o_1_z + m_t_2*o_2_z + m_t_3*o_3_z + m_t_4*o_4_z + m_t_5*o_5_z + m_t_6*o_6_z
        + n_1_z*t18 + n_1_z*t24 + n_2_z*t19 + n_2_z*t25 + n_3_z*t20 + n_3_z*t26 + n_4_z*t21 + n_4_z*t27
        + n_5_z*t22 + n_5_z*t28 + n_6_z*t23 + n_6_z*t29 + o_1_z*t12 + o_2_z*t13 + o_3_z*t14 + o_4_z*t15
        + o_5_z*t16 + o_6_z*t17 + p_z*t30);
}

void hexaglide_gravity_gradient(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real G[6])
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
    const pkmodes_real c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const pkmodes_real c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const pkmodes_real c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
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
    const pkmodes_real t19 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t20 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t22 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t23 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t24 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t25 = m_p + t19 + t20 + t21 + t22 + t23 + t24;
    const pkmodes_real G_p_x = -g_x*t25;
    const pkmodes_real G_p_y = -g_y*t25;
    const pkmodes_real G_p_z = -g_z*t25;
    const pkmodes_real t26 = g_z*m_p;
    const pkmodes_real t27 = g_z*t19;
    const pkmodes_real t28 = g_z*t20;
    const pkmodes_real t29 = g_z*t21;
    const pkmodes_real t30 = g_z*t22;
    const pkmodes_real t31 = g_z*t23;
    const pkmodes_real t32 = g_z*t24;
    const pkmodes_real G_p_rx =
        -B_1_y*t27 + (R(1.0)/R(2.0))*B_1_z*g_y*m_d_1 - B_2_y*t28 + (R(1.0)/R(2.0))*B_2_z*g_y*m_d_2
        - B_3_y*t29 + (R(1.0)/R(2.0))*B_3_z*g_y*m_d_3 - B_4_y*t30 + (R(1.0)/R(2.0))*B_4_z*g_y*m_d_4
        - B_5_y*t31 + (R(1.0)/R(2.0))*B_5_z*g_y*m_d_5 - B_6_y*t32 + (R(1.0)/R(2.0))*B_6_z*g_y*m_d_6 - c_y*t26
        + c_z*g_y*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t27 - B_1_z*g_x*t19 + B_2_x*t28 - B_2_z*g_x*t20 + B_3_x*t29 - B_3_z*g_x*t21 + B_4_x*t30
        - B_4_z*g_x*t22 + B_5_x*t31 - B_5_z*g_x*t23 + B_6_x*t32 - B_6_z*g_x*t24 + c_x*t26 - c_z*g_x*m_p;
    const pkmodes_real G_p_rz =
        -B_1_x*g_y*t19 + (R(1.0)/R(2.0))*B_1_y*g_x*m_d_1 - B_2_x*g_y*t20 + (R(1.0)/R(2.0))*B_2_y*g_x*m_d_2
        - B_3_x*g_y*t21 + (R(1.0)/R(2.0))*B_3_y*g_x*m_d_3 - B_4_x*g_y*t22 + (R(1.0)/R(2.0))*B_4_y*g_x*m_d_4
        - B_5_x*g_y*t23 + (R(1.0)/R(2.0))*B_5_y*g_x*m_d_5 - B_6_x*g_y*t24 + (R(1.0)/R(2.0))*B_6_y*g_x*m_d_6
        - c_x*g_y*m_p + c_y*g_x*m_p;
    G[0] =
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - g_x*(m_t_1*n_1_x + n_1_x*t19) - g_y*(m_t_1*n_1_y + n_1_y*t19) - g_z*(m_t_1*n_1_z + n_1_z*t19);
    G[1] =
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - g_x*(m_t_2*n_2_x + n_2_x*t20) - g_y*(m_t_2*n_2_y + n_2_y*t20) - g_z*(m_t_2*n_2_z + n_2_z*t20);
    G[2] =
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - g_x*(m_t_3*n_3_x + n_3_x*t21) - g_y*(m_t_3*n_3_y + n_3_y*t21) - g_z*(m_t_3*n_3_z + n_3_z*t21);
    G[3] =
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - g_x*(m_t_4*n_4_x + n_4_x*t22) - g_y*(m_t_4*n_4_y + n_4_y*t22) - g_z*(m_t_4*n_4_z + n_4_z*t22);
    G[4] =
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - g_x*(m_t_5*n_5_x + n_5_x*t23) - g_y*(m_t_5*n_5_y + n_5_y*t23) - g_z*(m_t_5*n_5_z + n_5_z*t23);
    G[5] =
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - g_x*(m_t_6*n_6_x + n_6_x*t24) - g_y*(m_t_6*n_6_y + n_6_y*t24) - g_z*(m_t_6*n_6_z + n_6_z*t24);
}

void hexaglide_gravity_hessian(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real H_g[6][6])
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
    const pkmodes_real c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const pkmodes_real c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const pkmodes_real c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
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
    const pkmodes_real t19 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t20 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t22 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t23 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t24 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t25 = m_p + t19 + t20 + t21 + t22 + t23 + t24;
    const pkmodes_real G_p_x = -g_x*t25;
    const pkmodes_real G_p_y = -g_y*t25;
    const pkmodes_real G_p_z = -g_z*t25;
    const pkmodes_real t26 = g_z*m_p;
    const pkmodes_real t27 = g_z*t19;
    const pkmodes_real t28 = g_z*t20;
    const pkmodes_real t29 = g_z*t21;
    const pkmodes_real t30 = g_z*t22;
    const pkmodes_real t31 = g_z*t23;
    const pkmodes_real t32 = g_z*t24;
    const pkmodes_real G_p_rx =
        -B_1_y*t27 + (R(1.0)/R(2.0))*B_1_z*g_y*m_d_1 - B_2_y*t28 + (R(1.0)/R(2.0))*B_2_z*g_y*m_d_2
        - B_3_y*t29 + (R(1.0)/R(2.0))*B_3_z*g_y*m_d_3 - B_4_y*t30 + (R(1.0)/R(2.0))*B_4_z*g_y*m_d_4
        - B_5_y*t31 + (R(1.0)/R(2.0))*B_5_z*g_y*m_d_5 - B_6_y*t32 + (R(1.0)/R(2.0))*B_6_z*g_y*m_d_6 - c_y*t26
        + c_z*g_y*m_p;
    const pkmodes_real t33 = g_x*t19;
    const pkmodes_real t34 = g_x*t20;
    const pkmodes_real t35 = g_x*t21;
    const pkmodes_real t36 = g_x*t22;
    const pkmodes_real t37 = g_x*t23;
    const pkmodes_real t38 = g_x*t24;
    const pkmodes_real t39 = g_x*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t27 - B_1_z*t33 + B_2_x*t28 - B_2_z*t34 + B_3_x*t29 - B_3_z*t35 + B_4_x*t30 - B_4_z*t36
        + B_5_x*t31 - B_5_z*t37 + B_6_x*t32 - B_6_z*t38 + c_x*t26 - c_z*t39;
    const pkmodes_real t40 = g_y*m_p;
    const pkmodes_real t41 = g_y*t19;
    const pkmodes_real t42 = g_y*t20;
    const pkmodes_real t43 = g_y*t21;
    const pkmodes_real t44 = g_y*t22;
    const pkmodes_real t45 = g_y*t23;
    const pkmodes_real t46 = g_y*t24;
    const pkmodes_real G_p_rz =
        -B_1_x*t41 + (R(1.0)/R(2.0))*B_1_y*g_x*m_d_1 - B_2_x*t42 + (R(1.0)/R(2.0))*B_2_y*g_x*m_d_2
        - B_3_x*t43 + (R(1.0)/R(2.0))*B_3_y*g_x*m_d_3 - B_4_x*t44 + (R(1.0)/R(2.0))*B_4_y*g_x*m_d_4
        - B_5_x*t45 + (R(1.0)/R(2.0))*B_5_y*g_x*m_d_5 - B_6_x*t46 + (R(1.0)/R(2.0))*B_6_y*g_x*m_d_6 - c_x*t40
        + c_y*g_x*m_p;
    const pkmodes_real mu_1 =
        t12*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const pkmodes_real mu_2 =
        t12*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const pkmodes_real mu_3 =
        t12*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const pkmodes_real mu_4 =
        t12*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const pkmodes_real mu_5 =
        t12*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const pkmodes_real mu_6 =
        t12*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const pkmodes_real g_4_x = -mu_1*s_1_x - t33;
    const pkmodes_real g_4_y = -mu_1*s_1_y - t41;
    const pkmodes_real g_4_z = -mu_1*s_1_z - t27;
    const pkmodes_real g_5_x = -mu_2*s_2_x - t34;
    const pkmodes_real g_5_y = -mu_2*s_2_y - t42;
    const pkmodes_real g_5_z = -mu_2*s_2_z - t28;
    const pkmodes_real g_6_x = -mu_3*s_3_x - t35;
    const pkmodes_real g_6_y = -mu_3*s_3_y - t43;
    const pkmodes_real g_6_z = -mu_3*s_3_z - t29;
    const pkmodes_real g_7_x = -mu_4*s_4_x - t36;
    const pkmodes_real g_7_y = -mu_4*s_4_y - t44;
    const pkmodes_real g_7_z = -mu_4*s_4_z - t30;
    const pkmodes_real g_8_x = -mu_5*s_5_x - t37;
    const pkmodes_real g_8_y = -mu_5*s_5_y - t45;
    const pkmodes_real g_8_z = -mu_5*s_5_z - t31;
    const pkmodes_real g_9_x = -mu_6*s_6_x - t38;
    const pkmodes_real g_9_y = -mu_6*s_6_y - t46;
    const pkmodes_real g_9_z = -mu_6*s_6_z - t32;
    const pkmodes_real g_10_x = -t39;
    const pkmodes_real g_10_y = -t40;
    const pkmodes_real g_10_z = -t26;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t47 = B_1_z*mu_1;
    const pkmodes_real t48 = B_2_z*mu_2;
    const pkmodes_real t49 = B_3_z*mu_3;
    const pkmodes_real t50 = B_4_z*mu_4;
    const pkmodes_real t51 = B_5_z*mu_5;
    const pkmodes_real t52 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t47 + t48 + t49 + t50 + t51 + t52;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t53 = B_1_y*mu_1;
    const pkmodes_real t54 = B_2_y*mu_2;
    const pkmodes_real t55 = B_3_y*mu_3;
    const pkmodes_real t56 = B_4_y*mu_4;
    const pkmodes_real t57 = B_5_y*mu_5;
    const pkmodes_real t58 = B_6_y*mu_6;
    const pkmodes_real L_x_rz = t53 + t54 + t55 + t56 + t57 + t58;
    const pkmodes_real t59 = B_1_x*mu_1;
    const pkmodes_real t60 = B_2_x*mu_2;
    const pkmodes_real t61 = B_3_x*mu_3;
    const pkmodes_real t62 = B_4_x*mu_4;
    const pkmodes_real t63 = B_5_x*mu_5;
    const pkmodes_real t64 = B_6_x*mu_6;
    const pkmodes_real L_z_ry = t59 + t60 + t61 + t62 + t63 + t64;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t65 =
        (B_1_z*B_1_z)*mu_1 + B_1_z*g_4_z + (B_2_z*B_2_z)*mu_2 + B_2_z*g_5_z + (B_3_z*B_3_z)*mu_3
        + B_3_z*g_6_z + (B_4_z*B_4_z)*mu_4 + B_4_z*g_7_z + (B_5_z*B_5_z)*mu_5 + B_5_z*g_8_z
        + (B_6_z*B_6_z)*mu_6 + B_6_z*g_9_z + c_z*g_10_z;
    const pkmodes_real t66 =
        (B_1_y*B_1_y)*mu_1 + B_1_y*g_4_y + (B_2_y*B_2_y)*mu_2 + B_2_y*g_5_y + (B_3_y*B_3_y)*mu_3
        + B_3_y*g_6_y + (B_4_y*B_4_y)*mu_4 + B_4_y*g_7_y + (B_5_y*B_5_y)*mu_5 + B_5_y*g_8_y
        + (B_6_y*B_6_y)*mu_6 + B_6_y*g_9_y + c_y*g_10_y;
    const pkmodes_real L_rx_rx = -t65 - t66;
    const pkmodes_real t67 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t68 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real t69 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t70 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t71 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t72 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t73 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t74 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t75 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t76 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t77 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t78 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t79 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t80 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t53 + B_1_y*t70 + B_2_x*t54 + B_2_y*t72 + B_3_x*t55 + B_3_y*t74 + B_4_x*t56 + B_4_y*t76
        + B_5_x*t57 + B_5_y*t78 + B_6_x*t58 + B_6_y*t80 + c_y*t68 + g_10_y*t67 + g_4_y*t69 + g_5_y*t71
        + g_6_y*t73 + g_7_y*t75 + g_8_y*t77 + g_9_y*t79;
    const pkmodes_real L_rx_rz =
        B_1_x*t47 + B_1_z*t70 + B_2_x*t48 + B_2_z*t72 + B_3_x*t49 + B_3_z*t74 + B_4_x*t50 + B_4_z*t76
        + B_5_x*t51 + B_5_z*t78 + B_6_x*t52 + B_6_z*t80 + c_z*t68 + g_10_z*t67 + g_4_z*t69 + g_5_z*t71
        + g_6_z*t73 + g_7_z*t75 + g_8_z*t77 + g_9_z*t79;
    const pkmodes_real t81 =
        (B_1_x*B_1_x)*mu_1 + B_1_x*g_4_x + (B_2_x*B_2_x)*mu_2 + B_2_x*g_5_x + (B_3_x*B_3_x)*mu_3
        + B_3_x*g_6_x + (B_4_x*B_4_x)*mu_4 + B_4_x*g_7_x + (B_5_x*B_5_x)*mu_5 + B_5_x*g_8_x
        + (B_6_x*B_6_x)*mu_6 + B_6_x*g_9_x + c_x*g_10_x;
    const pkmodes_real L_ry_ry = -t65 - t81;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t47 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t48 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t49
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t50 + (R(1.0)/R(2.0))*B_4_z*g_7_y
        + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t51 + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z
        + B_6_y*t52 + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y;
    const pkmodes_real L_rz_rz = -t66 - t81;
    const pkmodes_real t82 = mu_1*n_1_x;
    const pkmodes_real f_x_x_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t82;
    const pkmodes_real t83 = mu_2*n_2_x;
    const pkmodes_real f_x_x_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t83;
    const pkmodes_real t84 = mu_3*n_3_x;
    const pkmodes_real f_x_x_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t84;
    const pkmodes_real t85 = mu_4*n_4_x;
    const pkmodes_real f_x_x_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t85;
    const pkmodes_real t86 = mu_5*n_5_x;
    const pkmodes_real f_x_x_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t86;
    const pkmodes_real t87 = mu_6*n_6_x;
    const pkmodes_real f_x_x_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t87;
    const pkmodes_real t88 = mu_1*n_1_y;
    const pkmodes_real f_y_x_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t88;
    const pkmodes_real t89 = mu_2*n_2_y;
    const pkmodes_real f_y_x_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t89;
    const pkmodes_real t90 = mu_3*n_3_y;
    const pkmodes_real f_y_x_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t90;
    const pkmodes_real t91 = mu_4*n_4_y;
    const pkmodes_real f_y_x_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t91;
    const pkmodes_real t92 = mu_5*n_5_y;
    const pkmodes_real f_y_x_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t92;
    const pkmodes_real t93 = mu_6*n_6_y;
    const pkmodes_real f_y_x_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t93;
    const pkmodes_real t94 = mu_1*n_1_z;
    const pkmodes_real f_z_x_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t94;
    const pkmodes_real t95 = mu_2*n_2_z;
    const pkmodes_real f_z_x_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t95;
    const pkmodes_real t96 = mu_3*n_3_z;
    const pkmodes_real f_z_x_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t96;
    const pkmodes_real t97 = mu_4*n_4_z;
    const pkmodes_real f_z_x_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t97;
    const pkmodes_real t98 = mu_5*n_5_z;
    const pkmodes_real f_z_x_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t98;
    const pkmodes_real t99 = mu_6*n_6_z;
    const pkmodes_real f_z_x_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t99;
    const pkmodes_real t100 = -n_1_y*t47 + n_1_z*t53;
    const pkmodes_real f_rx_x_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx + t100;
    const pkmodes_real t101 = -n_2_y*t48 + n_2_z*t54;
    const pkmodes_real f_rx_x_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx + t101;
    const pkmodes_real t102 = -n_3_y*t49 + n_3_z*t55;
    const pkmodes_real f_rx_x_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx + t102;
    const pkmodes_real t103 = -n_4_y*t50 + n_4_z*t56;
    const pkmodes_real f_rx_x_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx + t103;
    const pkmodes_real t104 = -n_5_y*t51 + n_5_z*t57;
    const pkmodes_real f_rx_x_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx + t104;
    const pkmodes_real t105 = -n_6_y*t52 + n_6_z*t58;
    const pkmodes_real f_rx_x_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx + t105;
    const pkmodes_real t106 = n_1_z*t59;
    const pkmodes_real f_ry_x_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry + n_1_x*t47
        - t106;
    const pkmodes_real t107 = n_2_z*t60;
    const pkmodes_real f_ry_x_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry + n_2_x*t48
        - t107;
    const pkmodes_real t108 = n_3_z*t61;
    const pkmodes_real f_ry_x_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry + n_3_x*t49
        - t108;
    const pkmodes_real t109 = n_4_z*t62;
    const pkmodes_real f_ry_x_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry + n_4_x*t50
        - t109;
    const pkmodes_real t110 = n_5_z*t63;
    const pkmodes_real f_ry_x_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry + n_5_x*t51
        - t110;
    const pkmodes_real t111 = n_6_z*t64;
    const pkmodes_real f_ry_x_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry + n_6_x*t52
        - t111;
    const pkmodes_real t112 = -n_1_x*t53 + n_1_y*t59;
    const pkmodes_real f_rz_x_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz + t112;
    const pkmodes_real t113 = -n_2_x*t54 + n_2_y*t60;
    const pkmodes_real f_rz_x_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz + t113;
    const pkmodes_real t114 = -n_3_x*t55 + n_3_y*t61;
    const pkmodes_real f_rz_x_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz + t114;
    const pkmodes_real t115 = -n_4_x*t56 + n_4_y*t62;
    const pkmodes_real f_rz_x_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz + t115;
    const pkmodes_real t116 = -n_5_x*t57 + n_5_y*t63;
    const pkmodes_real f_rz_x_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz + t116;
    const pkmodes_real t117 = -n_6_x*t58 + n_6_y*t64;
    const pkmodes_real f_rz_x_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz + t117;
    const pkmodes_real t118 = B_1_z*mu_1*n_1_x - t106;
    const pkmodes_real t119 = B_2_z*mu_2*n_2_x - t107;
    const pkmodes_real t120 = B_3_z*mu_3*n_3_x - t108;
    const pkmodes_real t121 = B_4_z*mu_4*n_4_x - t109;
    const pkmodes_real t122 = B_5_z*mu_5*n_5_x - t110;
    H_g[0][0] =
        D_p_rx_1*f_rx_x_1 + D_p_rx_1*t100 + D_p_ry_1*f_ry_x_1 + D_p_ry_1*t118 + D_p_rz_1*f_rz_x_1
        + D_p_rz_1*t112 + D_p_x_1*f_x_x_1 + D_p_x_1*t82 + D_p_y_1*f_y_x_1 + D_p_y_1*t88 + D_p_z_1*f_z_x_1
        + D_p_z_1*t94 - mu_1*(n_1_x*n_1_x) - mu_1*(n_1_y*n_1_y) - mu_1*(n_1_z*n_1_z);
    H_g[0][1] = H_g[1][0] =
        D_p_rx_1*f_rx_x_2 + D_p_rx_2*t100 + D_p_ry_1*f_ry_x_2 + D_p_ry_2*t118 + D_p_rz_1*f_rz_x_2
        + D_p_rz_2*t112 + D_p_x_1*f_x_x_2 + D_p_x_2*t82 + D_p_y_1*f_y_x_2 + D_p_y_2*t88 + D_p_z_1*f_z_x_2
        + D_p_z_2*t94;
    H_g[0][2] = H_g[2][0] =
        D_p_rx_1*f_rx_x_3 + D_p_rx_3*t100 + D_p_ry_1*f_ry_x_3 + D_p_ry_3*t118 + D_p_rz_1*f_rz_x_3
        + D_p_rz_3*t112 + D_p_x_1*f_x_x_3 + D_p_x_3*t82 + D_p_y_1*f_y_x_3 + D_p_y_3*t88 + D_p_z_1*f_z_x_3
        + D_p_z_3*t94;
    H_g[0][3] = H_g[3][0] =
        D_p_rx_1*f_rx_x_4 + D_p_rx_4*t100 + D_p_ry_1*f_ry_x_4 + D_p_ry_4*t118 + D_p_rz_1*f_rz_x_4
        + D_p_rz_4*t112 + D_p_x_1*f_x_x_4 + D_p_x_4*t82 + D_p_y_1*f_y_x_4 + D_p_y_4*t88 + D_p_z_1*f_z_x_4
        + D_p_z_4*t94;
    H_g[0][4] = H_g[4][0] =
        D_p_rx_1*f_rx_x_5 + D_p_rx_5*t100 + D_p_ry_1*f_ry_x_5 + D_p_ry_5*t118 + D_p_rz_1*f_rz_x_5
        + D_p_rz_5*t112 + D_p_x_1*f_x_x_5 + D_p_x_5*t82 + D_p_y_1*f_y_x_5 + D_p_y_5*t88 + D_p_z_1*f_z_x_5
        + D_p_z_5*t94;
    H_g[0][5] = H_g[5][0] =
        D_p_rx_1*f_rx_x_6 + D_p_rx_6*t100 + D_p_ry_1*f_ry_x_6 + D_p_ry_6*t118 + D_p_rz_1*f_rz_x_6
        + D_p_rz_6*t112 + D_p_x_1*f_x_x_6 + D_p_x_6*t82 + D_p_y_1*f_y_x_6 + D_p_y_6*t88 + D_p_z_1*f_z_x_6
        + D_p_z_6*t94;
    H_g[1][1] =
        D_p_rx_2*f_rx_x_2 + D_p_rx_2*t101 + D_p_ry_2*f_ry_x_2 + D_p_ry_2*t119 + D_p_rz_2*f_rz_x_2
        + D_p_rz_2*t113 + D_p_x_2*f_x_x_2 + D_p_x_2*t83 + D_p_y_2*f_y_x_2 + D_p_y_2*t89 + D_p_z_2*f_z_x_2
        + D_p_z_2*t95 - mu_2*(n_2_x*n_2_x) - mu_2*(n_2_y*n_2_y) - mu_2*(n_2_z*n_2_z);
    H_g[1][2] = H_g[2][1] =
        D_p_rx_2*f_rx_x_3 + D_p_rx_3*t101 + D_p_ry_2*f_ry_x_3 + D_p_ry_3*t119 + D_p_rz_2*f_rz_x_3
        + D_p_rz_3*t113 + D_p_x_2*f_x_x_3 + D_p_x_3*t83 + D_p_y_2*f_y_x_3 + D_p_y_3*t89 + D_p_z_2*f_z_x_3
        + D_p_z_3*t95;
    H_g[1][3] = H_g[3][1] =
        D_p_rx_2*f_rx_x_4 + D_p_rx_4*t101 + D_p_ry_2*f_ry_x_4 + D_p_ry_4*t119 + D_p_rz_2*f_rz_x_4
        + D_p_rz_4*t113 + D_p_x_2*f_x_x_4 + D_p_x_4*t83 + D_p_y_2*f_y_x_4 + D_p_y_4*t89 + D_p_z_2*f_z_x_4
        + D_p_z_4*t95;
    H_g[1][4] = H_g[4][1] =
        D_p_rx_2*f_rx_x_5 + D_p_rx_5*t101 + D_p_ry_2*f_ry_x_5 + D_p_ry_5*t119 + D_p_rz_2*f_rz_x_5
        + D_p_rz_5*t113 + D_p_x_2*f_x_x_5 + D_p_x_5*t83 + D_p_y_2*f_y_x_5 + D_p_y_5*t89 + D_p_z_2*f_z_x_5
        + D_p_z_5*t95;
    H_g[1][5] = H_g[5][1] =
        D_p_rx_2*f_rx_x_6 + D_p_rx_6*t101 + D_p_ry_2*f_ry_x_6 + D_p_ry_6*t119 + D_p_rz_2*f_rz_x_6
        + D_p_rz_6*t113 + D_p_x_2*f_x_x_6 + D_p_x_6*t83 + D_p_y_2*f_y_x_6 + D_p_y_6*t89 + D_p_z_2*f_z_x_6
        + D_p_z_6*t95;
    H_g[2][2] =
        D_p_rx_3*f_rx_x_3 + D_p_rx_3*t102 + D_p_ry_3*f_ry_x_3 + D_p_ry_3*t120 + D_p_rz_3*f_rz_x_3
        + D_p_rz_3*t114 + D_p_x_3*f_x_x_3 + D_p_x_3*t84 + D_p_y_3*f_y_x_3 + D_p_y_3*t90 + D_p_z_3*f_z_x_3
        + D_p_z_3*t96 - mu_3*(n_3_x*n_3_x) - mu_3*(n_3_y*n_3_y) - mu_3*(n_3_z*n_3_z);
    H_g[2][3] = H_g[3][2] =
        D_p_rx_3*f_rx_x_4 + D_p_rx_4*t102 + D_p_ry_3*f_ry_x_4 + D_p_ry_4*t120 + D_p_rz_3*f_rz_x_4
        + D_p_rz_4*t114 + D_p_x_3*f_x_x_4 + D_p_x_4*t84 + D_p_y_3*f_y_x_4 + D_p_y_4*t90 + D_p_z_3*f_z_x_4
        + D_p_z_4*t96;
    H_g[2][4] = H_g[4][2] =
        D_p_rx_3*f_rx_x_5 + D_p_rx_5*t102 + D_p_ry_3*f_ry_x_5 + D_p_ry_5*t120 + D_p_rz_3*f_rz_x_5
        + D_p_rz_5*t114 + D_p_x_3*f_x_x_5 + D_p_x_5*t84 + D_p_y_3*f_y_x_5 + D_p_y_5*t90 + D_p_z_3*f_z_x_5
        + D_p_z_5*t96;
    H_g[2][5] = H_g[5][2] =
        D_p_rx_3*f_rx_x_6 + D_p_rx_6*t102 + D_p_ry_3*f_ry_x_6 + D_p_ry_6*t120 + D_p_rz_3*f_rz_x_6
        + D_p_rz_6*t114 + D_p_x_3*f_x_x_6 + D_p_x_6*t84 + D_p_y_3*f_y_x_6 + D_p_y_6*t90 + D_p_z_3*f_z_x_6
        + D_p_z_6*t96;
    H_g[3][3] =
        D_p_rx_4*f_rx_x_4 + D_p_rx_4*t103 + D_p_ry_4*f_ry_x_4 + D_p_ry_4*t121 + D_p_rz_4*f_rz_x_4
        + D_p_rz_4*t115 + D_p_x_4*f_x_x_4 + D_p_x_4*t85 + D_p_y_4*f_y_x_4 + D_p_y_4*t91 + D_p_z_4*f_z_x_4
        + D_p_z_4*t97 - mu_4*(n_4_x*n_4_x) - mu_4*(n_4_y*n_4_y) - mu_4*(n_4_z*n_4_z);
    H_g[3][4] = H_g[4][3] =
        D_p_rx_4*f_rx_x_5 + D_p_rx_5*t103 + D_p_ry_4*f_ry_x_5 + D_p_ry_5*t121 + D_p_rz_4*f_rz_x_5
        + D_p_rz_5*t115 + D_p_x_4*f_x_x_5 + D_p_x_5*t85 + D_p_y_4*f_y_x_5 + D_p_y_5*t91 + D_p_z_4*f_z_x_5
        + D_p_z_5*t97;
    H_g[3][5] = H_g[5][3] =
        D_p_rx_4*f_rx_x_6 + D_p_rx_6*t103 + D_p_ry_4*f_ry_x_6 + D_p_ry_6*t121 + D_p_rz_4*f_rz_x_6
        + D_p_rz_6*t115 + D_p_x_4*f_x_x_6 + D_p_x_6*t85 + D_p_y_4*f_y_x_6 + D_p_y_6*t91 + D_p_z_4*f_z_x_6
        + D_p_z_6*t97;
    H_g[4][4] =
        D_p_rx_5*f_rx_x_5 + D_p_rx_5*t104 + D_p_ry_5*f_ry_x_5 + D_p_ry_5*t122 + D_p_rz_5*f_rz_x_5
        + D_p_rz_5*t116 + D_p_x_5*f_x_x_5 + D_p_x_5*t86 + D_p_y_5*f_y_x_5 + D_p_y_5*t92 + D_p_z_5*f_z_x_5
        + D_p_z_5*t98 - mu_5*(n_5_x*n_5_x) - mu_5*(n_5_y*n_5_y) - mu_5*(n_5_z*n_5_z);
    H_g[4][5] = H_g[5][4] =
        D_p_rx_5*f_rx_x_6 + D_p_rx_6*t104 + D_p_ry_5*f_ry_x_6 + D_p_ry_6*t122 + D_p_rz_5*f_rz_x_6
        + D_p_rz_6*t116 + D_p_x_5*f_x_x_6 + D_p_x_6*t86 + D_p_y_5*f_y_x_6 + D_p_y_6*t92 + D_p_z_5*f_z_x_6
        + D_p_z_6*t98;
    H_g[5][5] =
        D_p_rx_6*f_rx_x_6 + D_p_rx_6*t105 + D_p_ry_6*f_ry_x_6 + D_p_ry_6*(B_6_z*mu_6*n_6_x - t111)
        + D_p_rz_6*f_rz_x_6 + D_p_rz_6*t117 + D_p_x_6*f_x_x_6 + D_p_x_6*t87 + D_p_y_6*f_y_x_6 + D_p_y_6*t93
        + D_p_z_6*f_z_x_6 + D_p_z_6*t99 - mu_6*(n_6_x*n_6_x) - mu_6*(n_6_y*n_6_y) - mu_6*(n_6_z*n_6_z);
}

void hexaglide_belt_stiffness(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real k[6][3])
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t12 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t12/l_f_1_1;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t13 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t12/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t13 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t12/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t14 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t14/l_f_2_1;
    const pkmodes_real t15 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t15 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t14/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t15 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t14/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t16 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t16/l_f_3_1;
    const pkmodes_real t17 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t17 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t16/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t17 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t16/l_f_3_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t18 = k_sp_4*w_b_4;
    const pkmodes_real k_4_1 = t18/l_f_4_1;
    const pkmodes_real t19 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t19 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t18/l_f_4_2;
    const pkmodes_real l_f_4_3 = -t19 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t18/l_f_4_3;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t20 = k_sp_5*w_b_5;
    const pkmodes_real k_5_1 = t20/l_f_5_1;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t21 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t20/l_f_5_2;
    const pkmodes_real l_f_5_3 = -t21 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t20/l_f_5_3;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t22 = k_sp_6*w_b_6;
    const pkmodes_real k_6_1 = t22/l_f_6_1;
    const pkmodes_real t23 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t23 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t22/l_f_6_2;
    const pkmodes_real l_f_6_3 = -t23 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t22/l_f_6_3;
    k[0][0] = k_1_1;
    k[0][1] = k_1_2;
    k[0][2] = k_1_3;
    k[1][0] = k_2_1;
    k[1][1] = k_2_2;
    k[1][2] = k_2_3;
    k[2][0] = k_3_1;
    k[2][1] = k_3_2;
    k[2][2] = k_3_3;
    k[3][0] = k_4_1;
    k[3][1] = k_4_2;
    k[3][2] = k_4_3;
    k[4][0] = k_5_1;
    k[4][1] = k_5_2;
    k[4][2] = k_5_3;
    k[5][0] = k_6_1;
    k[5][1] = k_6_2;
    k[5][2] = k_6_3;
}

void hexaglide_elastic_potential(const pkmodes_real p[6], const pkmodes_real delta_q[18],
    const hexaglide_parameters *parameters, pkmodes_real *V_el)
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real delta_x_1 = delta_q[0];
    const pkmodes_real delta_x_2 = delta_q[1];
    const pkmodes_real delta_x_3 = delta_q[2];
    const pkmodes_real delta_x_4 = delta_q[3];
    const pkmodes_real delta_x_5 = delta_q[4];
    const pkmodes_real delta_x_6 = delta_q[5];
    const pkmodes_real delta_theta_1_1 = delta_q[6];
    const pkmodes_real delta_theta_2_1 = delta_q[7];
    const pkmodes_real delta_theta_3_1 = delta_q[8];
    const pkmodes_real delta_theta_4_1 = delta_q[9];
    const pkmodes_real delta_theta_5_1 = delta_q[10];
    const pkmodes_real delta_theta_6_1 = delta_q[11];
    const pkmodes_real delta_theta_1_2 = delta_q[12];
    const pkmodes_real delta_theta_2_2 = delta_q[13];
    const pkmodes_real delta_theta_3_2 = delta_q[14];
    const pkmodes_real delta_theta_4_2 = delta_q[15];
    const pkmodes_real delta_theta_5_2 = delta_q[16];
    const pkmodes_real delta_theta_6_2 = delta_q[17];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t12 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t12/l_f_1_1;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t13 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t12/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t13 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t12/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t14 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t14/l_f_2_1;
    const pkmodes_real t15 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t15 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t14/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t15 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t14/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t16 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t16/l_f_3_1;
    const pkmodes_real t17 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t17 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t16/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t17 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t16/l_f_3_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t18 = k_sp_4*w_b_4;
    const pkmodes_real k_4_1 = t18/l_f_4_1;
    const pkmodes_real t19 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t19 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t18/l_f_4_2;
    const pkmodes_real l_f_4_3 = -t19 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t18/l_f_4_3;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t20 = k_sp_5*w_b_5;
    const pkmodes_real k_5_1 = t20/l_f_5_1;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t21 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t20/l_f_5_2;
    const pkmodes_real l_f_5_3 = -t21 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t20/l_f_5_3;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t22 = k_sp_6*w_b_6;
    const pkmodes_real k_6_1 = t22/l_f_6_1;
    const pkmodes_real t23 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t23 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t22/l_f_6_2;
    const pkmodes_real l_f_6_3 = -t23 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t22/l_f_6_3;
    const pkmodes_real t24 = R_p_1*delta_theta_1_2;
    const pkmodes_real t25 = R_p_2*delta_theta_2_2;
    const pkmodes_real t26 = R_p_3*delta_theta_3_2;
    const pkmodes_real t27 = R_p_4*delta_theta_4_2;
    const pkmodes_real t28 = R_p_5*delta_theta_5_2;
    const pkmodes_real t29 = R_p_6*delta_theta_6_2;
    const pkmodes_real t30 = R_p_1*delta_theta_1_1;
    const pkmodes_real t31 = R_p_2*delta_theta_2_1;
    const pkmodes_real t32 = R_p_3*delta_theta_3_1;
    const pkmodes_real t33 = R_p_4*delta_theta_4_1;
    const pkmodes_real t34 = R_p_5*delta_theta_5_1;
    const pkmodes_real t35 = R_p_6*delta_theta_6_1;
    *V_el =
        (R(1.0)/R(2.0))*k_1_1*((t24 - t30)*(t24 - t30)) + (R(1.0)/R(2.0))*k_1_2*((delta_x_1 - t24)*(delta_x_1
        - t24)) + (R(1.0)/R(2.0))*k_1_3*((-delta_x_1 + t30)*(-delta_x_1 + t30)) + (R(1.0)/R(2.0))*k_2_1*((t25
        - t31)*(t25 - t31)) + (R(1.0)/R(2.0))*k_2_2*((delta_x_2 - t25)*(delta_x_2 - t25))
        + (R(1.0)/R(2.0))*k_2_3*((-delta_x_2 + t31)*(-delta_x_2 + t31)) + (R(1.0)/R(2.0))*k_3_1*((t26
        - t32)*(t26 - t32)) + (R(1.0)/R(2.0))*k_3_2*((delta_x_3 - t26)*(delta_x_3 - t26))
        + (R(1.0)/R(2.0))*k_3_3*((-delta_x_3 + t32)*(-delta_x_3 + t32)) + (R(1.0)/R(2.0))*k_4_1*((t27
        - t33)*(t27 - t33)) + (R(1.0)/R(2.0))*k_4_2*((delta_x_4 - t27)*(delta_x_4 - t27))
        + (R(1.0)/R(2.0))*k_4_3*((-delta_x_4 + t33)*(-delta_x_4 + t33)) + (R(1.0)/R(2.0))*k_5_1*((t28
        - t34)*(t28 - t34)) + (R(1.0)/R(2.0))*k_5_2*((delta_x_5 - t28)*(delta_x_5 - t28))
        + (R(1.0)/R(2.0))*k_5_3*((-delta_x_5 + t34)*(-delta_x_5 + t34)) + (R(1.0)/R(2.0))*k_6_1*((t29
        - t35)*(t29 - t35)) + (R(1.0)/R(2.0))*k_6_2*((delta_x_6 - t29)*(delta_x_6 - t29))
        + (R(1.0)/R(2.0))*k_6_3*((-delta_x_6 + t35)*(-delta_x_6 + t35));
}

void hexaglide_elastic_gradient(const pkmodes_real p[6], const pkmodes_real delta_q[18],
    const hexaglide_parameters *parameters, pkmodes_real E[18])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real delta_x_1 = delta_q[0];
    const pkmodes_real delta_x_2 = delta_q[1];
    const pkmodes_real delta_x_3 = delta_q[2];
    const pkmodes_real delta_x_4 = delta_q[3];
    const pkmodes_real delta_x_5 = delta_q[4];
    const pkmodes_real delta_x_6 = delta_q[5];
    const pkmodes_real delta_theta_1_1 = delta_q[6];
    const pkmodes_real delta_theta_2_1 = delta_q[7];
    const pkmodes_real delta_theta_3_1 = delta_q[8];
    const pkmodes_real delta_theta_4_1 = delta_q[9];
    const pkmodes_real delta_theta_5_1 = delta_q[10];
    const pkmodes_real delta_theta_6_1 = delta_q[11];
    const pkmodes_real delta_theta_1_2 = delta_q[12];
    const pkmodes_real delta_theta_2_2 = delta_q[13];
    const pkmodes_real delta_theta_3_2 = delta_q[14];
    const pkmodes_real delta_theta_4_2 = delta_q[15];
    const pkmodes_real delta_theta_5_2 = delta_q[16];
    const pkmodes_real delta_theta_6_2 = delta_q[17];
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t12 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t12/l_f_1_1;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t13 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t12/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t13 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t12/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t14 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t14/l_f_2_1;
    const pkmodes_real t15 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t15 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t14/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t15 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t14/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t16 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t16/l_f_3_1;
    const pkmodes_real t17 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t17 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t16/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t17 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t16/l_f_3_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t18 = k_sp_4*w_b_4;
    const pkmodes_real k_4_1 = t18/l_f_4_1;
    const pkmodes_real t19 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t19 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t18/l_f_4_2;
    const pkmodes_real l_f_4_3 = -t19 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t18/l_f_4_3;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t20 = k_sp_5*w_b_5;
    const pkmodes_real k_5_1 = t20/l_f_5_1;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t21 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t20/l_f_5_2;
    const pkmodes_real l_f_5_3 = -t21 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t20/l_f_5_3;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t22 = k_sp_6*w_b_6;
    const pkmodes_real k_6_1 = t22/l_f_6_1;
    const pkmodes_real t23 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t23 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t22/l_f_6_2;
    const pkmodes_real l_f_6_3 = -t23 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t22/l_f_6_3;
    const pkmodes_real t24 = -2*delta_x_1;
    const pkmodes_real t25 = R_p_1*delta_theta_1_2;
    const pkmodes_real t26 = R_p_1*delta_theta_1_1;
    const pkmodes_real t27 = -2*delta_x_2;
    const pkmodes_real t28 = R_p_2*delta_theta_2_2;
    const pkmodes_real t29 = R_p_2*delta_theta_2_1;
    const pkmodes_real t30 = -2*delta_x_3;
    const pkmodes_real t31 = R_p_3*delta_theta_3_2;
    const pkmodes_real t32 = R_p_3*delta_theta_3_1;
    const pkmodes_real t33 = -2*delta_x_4;
    const pkmodes_real t34 = R_p_4*delta_theta_4_2;
    const pkmodes_real t35 = R_p_4*delta_theta_4_1;
    const pkmodes_real t36 = -2*delta_x_5;
    const pkmodes_real t37 = R_p_5*delta_theta_5_2;
    const pkmodes_real t38 = R_p_5*delta_theta_5_1;
    const pkmodes_real t39 = -2*delta_x_6;
    const pkmodes_real t40 = R_p_6*delta_theta_6_2;
    const pkmodes_real t41 = R_p_6*delta_theta_6_1;
    const pkmodes_real t42 = R_p_1*k_1_1*(t25 - t26);
    const pkmodes_real t43 = R_p_2*k_2_1*(t28 - t29);
    const pkmodes_real t44 = R_p_3*k_3_1*(t31 - t32);
    const pkmodes_real t45 = R_p_4*k_4_1*(t34 - t35);
    const pkmodes_real t46 = R_p_5*k_5_1*(t37 - t38);
    const pkmodes_real t47 = R_p_6*k_6_1*(t40 - t41);
    E[0] = (R(1.0)/R(2.0))*k_1_2*(-t24 - 2*t25) + (R(1.0)/R(2.0))*k_1_3*(-t24 - 2*t26);
    E[1] = (R(1.0)/R(2.0))*k_2_2*(-t27 - 2*t28) + (R(1.0)/R(2.0))*k_2_3*(-t27 - 2*t29);
    E[2] = (R(1.0)/R(2.0))*k_3_2*(-t30 - 2*t31) + (R(1.0)/R(2.0))*k_3_3*(-t30 - 2*t32);
    E[3] = (R(1.0)/R(2.0))*k_4_2*(-t33 - 2*t34) + (R(1.0)/R(2.0))*k_4_3*(-t33 - 2*t35);
    E[4] = (R(1.0)/R(2.0))*k_5_2*(-t36 - 2*t37) + (R(1.0)/R(2.0))*k_5_3*(-t36 - 2*t38);
    E[5] = (R(1.0)/R(2.0))*k_6_2*(-t39 - 2*t40) + (R(1.0)/R(2.0))*k_6_3*(-t39 - 2*t41);
    E[6] = R_p_1*k_1_3*(-delta_x_1 + t26) - t42;
    E[7] = R_p_2*k_2_3*(-delta_x_2 + t29) - t43;
    E[8] = R_p_3*k_3_3*(-delta_x_3 + t32) - t44;
    E[9] = R_p_4*k_4_3*(-delta_x_4 + t35) - t45;
    E[10] = R_p_5*k_5_3*(-delta_x_5 + t38) - t46;
    E[11] = R_p_6*k_6_3*(-delta_x_6 + t41) - t47;
    E[12] = -R_p_1*k_1_2*(delta_x_1 - t25) + t42;
    E[13] = -R_p_2*k_2_2*(delta_x_2 - t28) + t43;
    E[14] = -R_p_3*k_3_2*(delta_x_3 - t31) + t44;
    E[15] = -R_p_4*k_4_2*(delta_x_4 - t34) + t45;
    E[16] = -R_p_5*k_5_2*(delta_x_5 - t37) + t46;
    E[17] = -R_p_6*k_6_2*(delta_x_6 - t40) + t47;
}

void hexaglide_elastic_hessian(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real H_el[18][18])
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
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t12 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t12/l_f_1_1;
    const pkmodes_real t13 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t13 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t12/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t13 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t12/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t14 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t14/l_f_2_1;
    const pkmodes_real t15 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t15 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t14/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t15 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t14/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t16 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t16/l_f_3_1;
    const pkmodes_real t17 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t17 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t16/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t17 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t16/l_f_3_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t18 = k_sp_4*w_b_4;
    const pkmodes_real k_4_1 = t18/l_f_4_1;
    const pkmodes_real t19 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t19 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t18/l_f_4_2;
    const pkmodes_real l_f_4_3 = -t19 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t18/l_f_4_3;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t20 = k_sp_5*w_b_5;
    const pkmodes_real k_5_1 = t20/l_f_5_1;
    const pkmodes_real t21 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t21 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t20/l_f_5_2;
    const pkmodes_real l_f_5_3 = -t21 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t20/l_f_5_3;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t22 = k_sp_6*w_b_6;
    const pkmodes_real k_6_1 = t22/l_f_6_1;
    const pkmodes_real t23 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t23 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t22/l_f_6_2;
    const pkmodes_real l_f_6_3 = -t23 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t22/l_f_6_3;
    const pkmodes_real t24 = (R_p_1*R_p_1);
    const pkmodes_real t25 = k_1_1*t24;
    const pkmodes_real t26 = (R_p_2*R_p_2);
    const pkmodes_real t27 = k_2_1*t26;
    const pkmodes_real t28 = (R_p_3*R_p_3);
    const pkmodes_real t29 = k_3_1*t28;
    const pkmodes_real t30 = (R_p_4*R_p_4);
    const pkmodes_real t31 = k_4_1*t30;
    const pkmodes_real t32 = (R_p_5*R_p_5);
    const pkmodes_real t33 = k_5_1*t32;
    const pkmodes_real t34 = (R_p_6*R_p_6);
    const pkmodes_real t35 = k_6_1*t34;
    memset(H_el, 0, sizeof(pkmodes_real[18][18]));
    H_el[0][0] = k_1_2 + k_1_3;
    H_el[0][6] = H_el[6][0] = -R_p_1*k_1_3;
    H_el[0][12] = H_el[12][0] = -R_p_1*k_1_2;
    H_el[1][1] = k_2_2 + k_2_3;
    H_el[1][7] = H_el[7][1] = -R_p_2*k_2_3;
    H_el[1][13] = H_el[13][1] = -R_p_2*k_2_2;
    H_el[2][2] = k_3_2 + k_3_3;
    H_el[2][8] = H_el[8][2] = -R_p_3*k_3_3;
    H_el[2][14] = H_el[14][2] = -R_p_3*k_3_2;
    H_el[3][3] = k_4_2 + k_4_3;
    H_el[3][9] = H_el[9][3] = -R_p_4*k_4_3;
    H_el[3][15] = H_el[15][3] = -R_p_4*k_4_2;
    H_el[4][4] = k_5_2 + k_5_3;
    H_el[4][10] = H_el[10][4] = -R_p_5*k_5_3;
    H_el[4][16] = H_el[16][4] = -R_p_5*k_5_2;
    H_el[5][5] = k_6_2 + k_6_3;
    H_el[5][11] = H_el[11][5] = -R_p_6*k_6_3;
    H_el[5][17] = H_el[17][5] = -R_p_6*k_6_2;
    H_el[6][6] = k_1_3*t24 + t25;
    H_el[6][12] = H_el[12][6] = -t25;
    H_el[7][7] = k_2_3*t26 + t27;
    H_el[7][13] = H_el[13][7] = -t27;
    H_el[8][8] = k_3_3*t28 + t29;
    H_el[8][14] = H_el[14][8] = -t29;
    H_el[9][9] = k_4_3*t30 + t31;
    H_el[9][15] = H_el[15][9] = -t31;
    H_el[10][10] = k_5_3*t32 + t33;
    H_el[10][16] = H_el[16][10] = -t33;
    H_el[11][11] = k_6_3*t34 + t35;
    H_el[11][17] = H_el[17][11] = -t35;
    H_el[12][12] = k_1_2*t24 + t25;
    H_el[13][13] = k_2_2*t26 + t27;
    H_el[14][14] = k_3_2*t28 + t29;
    H_el[15][15] = k_4_2*t30 + t31;
    H_el[16][16] = k_5_2*t32 + t33;
    H_el[17][17] = k_6_2*t34 + t35;
}

void hexaglide_static_equilibrium(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real tau_st[6], pkmodes_real theta_st[12])
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
    const pkmodes_real t19 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t19/l_f_1_1;
    const pkmodes_real t20 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t20 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t19/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t20 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t19/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t21 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t21/l_f_2_1;
    const pkmodes_real t22 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t22 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t21/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t22 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t21/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t23 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t23/l_f_3_1;
    const pkmodes_real t24 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t24 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t23/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t24 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t23/l_f_3_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t25 = k_sp_4*w_b_4;
    const pkmodes_real k_4_1 = t25/l_f_4_1;
    const pkmodes_real t26 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t26 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t25/l_f_4_2;
    const pkmodes_real l_f_4_3 = -t26 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t25/l_f_4_3;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t27 = k_sp_5*w_b_5;
    const pkmodes_real k_5_1 = t27/l_f_5_1;
    const pkmodes_real t28 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t28 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t27/l_f_5_2;
    const pkmodes_real l_f_5_3 = -t28 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t27/l_f_5_3;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t29 = k_sp_6*w_b_6;
    const pkmodes_real k_6_1 = t29/l_f_6_1;
    const pkmodes_real t30 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t30 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t29/l_f_6_2;
    const pkmodes_real l_f_6_3 = -t30 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t29/l_f_6_3;
    const pkmodes_real t31 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t32 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t33 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t34 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t35 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t36 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t37 = m_p + t31 + t32 + t33 + t34 + t35 + t36;
    const pkmodes_real G_p_x = -g_x*t37;
    const pkmodes_real G_p_y = -g_y*t37;
    const pkmodes_real G_p_z = -g_z*t37;
    const pkmodes_real t38 = g_z*m_p;
    const pkmodes_real t39 = g_z*t31;
    const pkmodes_real t40 = g_z*t32;
    const pkmodes_real t41 = g_z*t33;
    const pkmodes_real t42 = g_z*t34;
    const pkmodes_real t43 = g_z*t35;
    const pkmodes_real t44 = g_z*t36;
    const pkmodes_real G_p_rx =
        -B_1_y*t39 + (R(1.0)/R(2.0))*B_1_z*g_y*m_d_1 - B_2_y*t40 + (R(1.0)/R(2.0))*B_2_z*g_y*m_d_2
        - B_3_y*t41 + (R(1.0)/R(2.0))*B_3_z*g_y*m_d_3 - B_4_y*t42 + (R(1.0)/R(2.0))*B_4_z*g_y*m_d_4
        - B_5_y*t43 + (R(1.0)/R(2.0))*B_5_z*g_y*m_d_5 - B_6_y*t44 + (R(1.0)/R(2.0))*B_6_z*g_y*m_d_6 - c_y*t38
        + c_z*g_y*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t39 - B_1_z*g_x*t31 + B_2_x*t40 - B_2_z*g_x*t32 + B_3_x*t41 - B_3_z*g_x*t33 + B_4_x*t42
        - B_4_z*g_x*t34 + B_5_x*t43 - B_5_z*g_x*t35 + B_6_x*t44 - B_6_z*g_x*t36 + c_x*t38 - c_z*g_x*m_p;
    const pkmodes_real G_p_rz =
        -B_1_x*g_y*t31 + (R(1.0)/R(2.0))*B_1_y*g_x*m_d_1 - B_2_x*g_y*t32 + (R(1.0)/R(2.0))*B_2_y*g_x*m_d_2
        - B_3_x*g_y*t33 + (R(1.0)/R(2.0))*B_3_y*g_x*m_d_3 - B_4_x*g_y*t34 + (R(1.0)/R(2.0))*B_4_y*g_x*m_d_4
        - B_5_x*g_y*t35 + (R(1.0)/R(2.0))*B_5_y*g_x*m_d_5 - B_6_x*g_y*t36 + (R(1.0)/R(2.0))*B_6_y*g_x*m_d_6
        - c_x*g_y*m_p + c_y*g_x*m_p;
    const pkmodes_real G_1 =
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - g_x*(m_t_1*n_1_x + n_1_x*t31) - g_y*(m_t_1*n_1_y + n_1_y*t31) - g_z*(m_t_1*n_1_z + n_1_z*t31);
    const pkmodes_real G_2 =
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - g_x*(m_t_2*n_2_x + n_2_x*t32) - g_y*(m_t_2*n_2_y + n_2_y*t32) - g_z*(m_t_2*n_2_z + n_2_z*t32);
    const pkmodes_real G_3 =
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - g_x*(m_t_3*n_3_x + n_3_x*t33) - g_y*(m_t_3*n_3_y + n_3_y*t33) - g_z*(m_t_3*n_3_z + n_3_z*t33);
    const pkmodes_real G_4 =
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - g_x*(m_t_4*n_4_x + n_4_x*t34) - g_y*(m_t_4*n_4_y + n_4_y*t34) - g_z*(m_t_4*n_4_z + n_4_z*t34);
    const pkmodes_real G_5 =
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - g_x*(m_t_5*n_5_x + n_5_x*t35) - g_y*(m_t_5*n_5_y + n_5_y*t35) - g_z*(m_t_5*n_5_z + n_5_z*t35);
    const pkmodes_real G_6 =
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - g_x*(m_t_6*n_6_x + n_6_x*t36) - g_y*(m_t_6*n_6_y + n_6_y*t36) - g_z*(m_t_6*n_6_z + n_6_z*t36);
    const pkmodes_real t45 = (R_p_1*R_p_1);
    const pkmodes_real t46 = k_1_1*t45;
    const pkmodes_real t47 = k_1_3*t45;
    const pkmodes_real t48 = -d_1_1*t46 + d_1_2*(t46 + t47);
    const pkmodes_real t49 = k_1_2*t45;
    const pkmodes_real t50 = d_1_1*(t46 + t49) - d_1_2*t46;
    const pkmodes_real det_1 = R_p_1*k_1_2*t48 - R_p_1*k_1_3*t50;
    const pkmodes_real t51 = G_1/det_1;
    const pkmodes_real theta_1_1_st = -t50*t51;
    const pkmodes_real theta_1_2_st = t48*t51;
    const pkmodes_real t52 = (R_p_2*R_p_2);
    const pkmodes_real t53 = k_2_1*t52;
    const pkmodes_real t54 = k_2_3*t52;
    const pkmodes_real t55 = -d_2_1*t53 + d_2_2*(t53 + t54);
    const pkmodes_real t56 = k_2_2*t52;
    const pkmodes_real t57 = d_2_1*(t53 + t56) - d_2_2*t53;
    const pkmodes_real det_2 = R_p_2*k_2_2*t55 - R_p_2*k_2_3*t57;
    const pkmodes_real t58 = G_2/det_2;
    const pkmodes_real theta_2_1_st = -t57*t58;
    const pkmodes_real theta_2_2_st = t55*t58;
    const pkmodes_real t59 = (R_p_3*R_p_3);
    const pkmodes_real t60 = k_3_1*t59;
    const pkmodes_real t61 = k_3_3*t59;
    const pkmodes_real t62 = -d_3_1*t60 + d_3_2*(t60 + t61);
    const pkmodes_real t63 = k_3_2*t59;
    const pkmodes_real t64 = d_3_1*(t60 + t63) - d_3_2*t60;
    const pkmodes_real det_3 = R_p_3*k_3_2*t62 - R_p_3*k_3_3*t64;
    const pkmodes_real t65 = G_3/det_3;
    const pkmodes_real theta_3_1_st = -t64*t65;
    const pkmodes_real theta_3_2_st = t62*t65;
    const pkmodes_real t66 = (R_p_4*R_p_4);
    const pkmodes_real t67 = k_4_1*t66;
    const pkmodes_real t68 = k_4_3*t66;
    const pkmodes_real t69 = -d_4_1*t67 + d_4_2*(t67 + t68);
    const pkmodes_real t70 = k_4_2*t66;
    const pkmodes_real t71 = d_4_1*(t67 + t70) - d_4_2*t67;
    const pkmodes_real det_4 = R_p_4*k_4_2*t69 - R_p_4*k_4_3*t71;
    const pkmodes_real t72 = G_4/det_4;
    const pkmodes_real theta_4_1_st = -t71*t72;
    const pkmodes_real theta_4_2_st = t69*t72;
    const pkmodes_real t73 = (R_p_5*R_p_5);
    const pkmodes_real t74 = k_5_1*t73;
    const pkmodes_real t75 = k_5_3*t73;
    const pkmodes_real t76 = -d_5_1*t74 + d_5_2*(t74 + t75);
    const pkmodes_real t77 = k_5_2*t73;
    const pkmodes_real t78 = d_5_1*(t74 + t77) - d_5_2*t74;
    const pkmodes_real det_5 = R_p_5*k_5_2*t76 - R_p_5*k_5_3*t78;
    const pkmodes_real t79 = G_5/det_5;
    const pkmodes_real theta_5_1_st = -t78*t79;
    const pkmodes_real theta_5_2_st = t76*t79;
    const pkmodes_real t80 = (R_p_6*R_p_6);
    const pkmodes_real t81 = k_6_1*t80;
    const pkmodes_real t82 = k_6_3*t80;
    const pkmodes_real t83 = -d_6_1*t81 + d_6_2*(t81 + t82);
    const pkmodes_real t84 = k_6_2*t80;
    const pkmodes_real t85 = d_6_1*(t81 + t84) - d_6_2*t81;
    const pkmodes_real det_6 = R_p_6*k_6_2*t83 - R_p_6*k_6_3*t85;
    const pkmodes_real t86 = G_6/det_6;
    const pkmodes_real theta_6_1_st = -t85*t86;
    const pkmodes_real theta_6_2_st = t83*t86;
    const pkmodes_real t87 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st);
    const pkmodes_real tau_st_1 = d_1_1*(t47*theta_1_1_st - t87) + d_1_2*(t49*theta_1_2_st + t87);
    const pkmodes_real t88 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st);
    const pkmodes_real tau_st_2 = d_2_1*(t54*theta_2_1_st - t88) + d_2_2*(t56*theta_2_2_st + t88);
    const pkmodes_real t89 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st);
    const pkmodes_real tau_st_3 = d_3_1*(t61*theta_3_1_st - t89) + d_3_2*(t63*theta_3_2_st + t89);
    const pkmodes_real t90 = R_p_4*k_4_1*(-R_p_4*theta_4_1_st + R_p_4*theta_4_2_st);
    const pkmodes_real tau_st_4 = d_4_1*(t68*theta_4_1_st - t90) + d_4_2*(t70*theta_4_2_st + t90);
    const pkmodes_real t91 = R_p_5*k_5_1*(-R_p_5*theta_5_1_st + R_p_5*theta_5_2_st);
    const pkmodes_real tau_st_5 = d_5_1*(t75*theta_5_1_st - t91) + d_5_2*(t77*theta_5_2_st + t91);
    const pkmodes_real t92 = R_p_6*k_6_1*(-R_p_6*theta_6_1_st + R_p_6*theta_6_2_st);
    const pkmodes_real tau_st_6 = d_6_1*(t82*theta_6_1_st - t92) + d_6_2*(t84*theta_6_2_st + t92);
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

void hexaglide_stiffness_matrix(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real K[18][18])
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
    const pkmodes_real t19 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t19/l_f_1_1;
    const pkmodes_real t20 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t20 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t19/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t20 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t19/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t21 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t21/l_f_2_1;
    const pkmodes_real t22 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t22 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t21/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t22 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t21/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t23 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t23/l_f_3_1;
    const pkmodes_real t24 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t24 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t23/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t24 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t23/l_f_3_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t25 = k_sp_4*w_b_4;
    const pkmodes_real k_4_1 = t25/l_f_4_1;
    const pkmodes_real t26 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t26 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t25/l_f_4_2;
    const pkmodes_real l_f_4_3 = -t26 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t25/l_f_4_3;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t27 = k_sp_5*w_b_5;
    const pkmodes_real k_5_1 = t27/l_f_5_1;
    const pkmodes_real t28 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t28 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t27/l_f_5_2;
    const pkmodes_real l_f_5_3 = -t28 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t27/l_f_5_3;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t29 = k_sp_6*w_b_6;
    const pkmodes_real k_6_1 = t29/l_f_6_1;
    const pkmodes_real t30 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t30 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t29/l_f_6_2;
    const pkmodes_real l_f_6_3 = -t30 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t29/l_f_6_3;
    const pkmodes_real t31 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t32 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t33 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t34 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t35 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t36 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t37 = m_p + t31 + t32 + t33 + t34 + t35 + t36;
    const pkmodes_real G_p_x = -g_x*t37;
    const pkmodes_real G_p_y = -g_y*t37;
    const pkmodes_real G_p_z = -g_z*t37;
    const pkmodes_real t38 = g_z*m_p;
    const pkmodes_real t39 = g_z*t31;
    const pkmodes_real t40 = g_z*t32;
    const pkmodes_real t41 = g_z*t33;
    const pkmodes_real t42 = g_z*t34;
    const pkmodes_real t43 = g_z*t35;
    const pkmodes_real t44 = g_z*t36;
    const pkmodes_real G_p_rx =
        -B_1_y*t39 + (R(1.0)/R(2.0))*B_1_z*g_y*m_d_1 - B_2_y*t40 + (R(1.0)/R(2.0))*B_2_z*g_y*m_d_2
        - B_3_y*t41 + (R(1.0)/R(2.0))*B_3_z*g_y*m_d_3 - B_4_y*t42 + (R(1.0)/R(2.0))*B_4_z*g_y*m_d_4
        - B_5_y*t43 + (R(1.0)/R(2.0))*B_5_z*g_y*m_d_5 - B_6_y*t44 + (R(1.0)/R(2.0))*B_6_z*g_y*m_d_6 - c_y*t38
        + c_z*g_y*m_p;
    const pkmodes_real t45 = g_x*t31;
    const pkmodes_real t46 = g_x*t32;
    const pkmodes_real t47 = g_x*t33;
    const pkmodes_real t48 = g_x*t34;
    const pkmodes_real t49 = g_x*t35;
    const pkmodes_real t50 = g_x*t36;
    const pkmodes_real t51 = g_x*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t39 - B_1_z*t45 + B_2_x*t40 - B_2_z*t46 + B_3_x*t41 - B_3_z*t47 + B_4_x*t42 - B_4_z*t48
        + B_5_x*t43 - B_5_z*t49 + B_6_x*t44 - B_6_z*t50 + c_x*t38 - c_z*t51;
    const pkmodes_real t52 = g_y*m_p;
    const pkmodes_real t53 = g_y*t31;
    const pkmodes_real t54 = g_y*t32;
    const pkmodes_real t55 = g_y*t33;
    const pkmodes_real t56 = g_y*t34;
    const pkmodes_real t57 = g_y*t35;
    const pkmodes_real t58 = g_y*t36;
    const pkmodes_real G_p_rz =
        -B_1_x*t53 + (R(1.0)/R(2.0))*B_1_y*g_x*m_d_1 - B_2_x*t54 + (R(1.0)/R(2.0))*B_2_y*g_x*m_d_2
        - B_3_x*t55 + (R(1.0)/R(2.0))*B_3_y*g_x*m_d_3 - B_4_x*t56 + (R(1.0)/R(2.0))*B_4_y*g_x*m_d_4
        - B_5_x*t57 + (R(1.0)/R(2.0))*B_5_y*g_x*m_d_5 - B_6_x*t58 + (R(1.0)/R(2.0))*B_6_y*g_x*m_d_6 - c_x*t52
        + c_y*g_x*m_p;
    const pkmodes_real mu_1 =
        t12*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const pkmodes_real mu_2 =
        t12*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const pkmodes_real mu_3 =
        t12*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const pkmodes_real mu_4 =
        t12*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const pkmodes_real mu_5 =
        t12*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const pkmodes_real mu_6 =
        t12*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const pkmodes_real g_4_x = -mu_1*s_1_x - t45;
    const pkmodes_real g_4_y = -mu_1*s_1_y - t53;
    const pkmodes_real g_4_z = -mu_1*s_1_z - t39;
    const pkmodes_real g_5_x = -mu_2*s_2_x - t46;
    const pkmodes_real g_5_y = -mu_2*s_2_y - t54;
    const pkmodes_real g_5_z = -mu_2*s_2_z - t40;
    const pkmodes_real g_6_x = -mu_3*s_3_x - t47;
    const pkmodes_real g_6_y = -mu_3*s_3_y - t55;
    const pkmodes_real g_6_z = -mu_3*s_3_z - t41;
    const pkmodes_real g_7_x = -mu_4*s_4_x - t48;
    const pkmodes_real g_7_y = -mu_4*s_4_y - t56;
    const pkmodes_real g_7_z = -mu_4*s_4_z - t42;
    const pkmodes_real g_8_x = -mu_5*s_5_x - t49;
    const pkmodes_real g_8_y = -mu_5*s_5_y - t57;
    const pkmodes_real g_8_z = -mu_5*s_5_z - t43;
    const pkmodes_real g_9_x = -mu_6*s_6_x - t50;
    const pkmodes_real g_9_y = -mu_6*s_6_y - t58;
    const pkmodes_real g_9_z = -mu_6*s_6_z - t44;
    const pkmodes_real g_10_x = -t51;
    const pkmodes_real g_10_y = -t52;
    const pkmodes_real g_10_z = -t38;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t59 = B_1_z*mu_1;
    const pkmodes_real t60 = B_2_z*mu_2;
    const pkmodes_real t61 = B_3_z*mu_3;
    const pkmodes_real t62 = B_4_z*mu_4;
    const pkmodes_real t63 = B_5_z*mu_5;
    const pkmodes_real t64 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t59 + t60 + t61 + t62 + t63 + t64;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t65 = B_1_y*mu_1;
    const pkmodes_real t66 = B_2_y*mu_2;
    const pkmodes_real t67 = B_3_y*mu_3;
    const pkmodes_real t68 = B_4_y*mu_4;
    const pkmodes_real t69 = B_5_y*mu_5;
    const pkmodes_real t70 = B_6_y*mu_6;
    const pkmodes_real L_x_rz = t65 + t66 + t67 + t68 + t69 + t70;
    const pkmodes_real t71 = B_1_x*mu_1;
    const pkmodes_real t72 = B_2_x*mu_2;
    const pkmodes_real t73 = B_3_x*mu_3;
    const pkmodes_real t74 = B_4_x*mu_4;
    const pkmodes_real t75 = B_5_x*mu_5;
    const pkmodes_real t76 = B_6_x*mu_6;
    const pkmodes_real L_z_ry = t71 + t72 + t73 + t74 + t75 + t76;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t77 =
        (B_1_z*B_1_z)*mu_1 + B_1_z*g_4_z + (B_2_z*B_2_z)*mu_2 + B_2_z*g_5_z + (B_3_z*B_3_z)*mu_3
        + B_3_z*g_6_z + (B_4_z*B_4_z)*mu_4 + B_4_z*g_7_z + (B_5_z*B_5_z)*mu_5 + B_5_z*g_8_z
        + (B_6_z*B_6_z)*mu_6 + B_6_z*g_9_z + c_z*g_10_z;
    const pkmodes_real t78 =
        (B_1_y*B_1_y)*mu_1 + B_1_y*g_4_y + (B_2_y*B_2_y)*mu_2 + B_2_y*g_5_y + (B_3_y*B_3_y)*mu_3
        + B_3_y*g_6_y + (B_4_y*B_4_y)*mu_4 + B_4_y*g_7_y + (B_5_y*B_5_y)*mu_5 + B_5_y*g_8_y
        + (B_6_y*B_6_y)*mu_6 + B_6_y*g_9_y + c_y*g_10_y;
    const pkmodes_real L_rx_rx = -t77 - t78;
    const pkmodes_real t79 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t80 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t81 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t82 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t83 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t84 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t85 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t86 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t87 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t88 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t89 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t90 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real t91 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t92 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t65 + B_1_y*t80 + B_2_x*t66 + B_2_y*t82 + B_3_x*t67 + B_3_y*t84 + B_4_x*t68 + B_4_y*t86
        + B_5_x*t69 + B_5_y*t88 + B_6_x*t70 + B_6_y*t90 + c_y*t92 + g_10_y*t91 + g_4_y*t79 + g_5_y*t81
        + g_6_y*t83 + g_7_y*t85 + g_8_y*t87 + g_9_y*t89;
    const pkmodes_real L_rx_rz =
        B_1_x*t59 + B_1_z*t80 + B_2_x*t60 + B_2_z*t82 + B_3_x*t61 + B_3_z*t84 + B_4_x*t62 + B_4_z*t86
        + B_5_x*t63 + B_5_z*t88 + B_6_x*t64 + B_6_z*t90 + c_z*t92 + g_10_z*t91 + g_4_z*t79 + g_5_z*t81
        + g_6_z*t83 + g_7_z*t85 + g_8_z*t87 + g_9_z*t89;
    const pkmodes_real t93 =
        (B_1_x*B_1_x)*mu_1 + B_1_x*g_4_x + (B_2_x*B_2_x)*mu_2 + B_2_x*g_5_x + (B_3_x*B_3_x)*mu_3
        + B_3_x*g_6_x + (B_4_x*B_4_x)*mu_4 + B_4_x*g_7_x + (B_5_x*B_5_x)*mu_5 + B_5_x*g_8_x
        + (B_6_x*B_6_x)*mu_6 + B_6_x*g_9_x + c_x*g_10_x;
    const pkmodes_real L_ry_ry = -t77 - t93;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t59 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t60 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t61
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t62 + (R(1.0)/R(2.0))*B_4_z*g_7_y
        + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t63 + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z
        + B_6_y*t64 + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y;
    const pkmodes_real L_rz_rz = -t78 - t93;
    const pkmodes_real t94 = mu_1*n_1_x;
    const pkmodes_real f_x_x_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t94;
    const pkmodes_real t95 = mu_2*n_2_x;
    const pkmodes_real f_x_x_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t95;
    const pkmodes_real t96 = mu_3*n_3_x;
    const pkmodes_real f_x_x_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t96;
    const pkmodes_real t97 = mu_4*n_4_x;
    const pkmodes_real f_x_x_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t97;
    const pkmodes_real t98 = mu_5*n_5_x;
    const pkmodes_real f_x_x_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t98;
    const pkmodes_real t99 = mu_6*n_6_x;
    const pkmodes_real f_x_x_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t99;
    const pkmodes_real t100 = mu_1*n_1_y;
    const pkmodes_real f_y_x_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t100;
    const pkmodes_real t101 = mu_2*n_2_y;
    const pkmodes_real f_y_x_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t101;
    const pkmodes_real t102 = mu_3*n_3_y;
    const pkmodes_real f_y_x_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t102;
    const pkmodes_real t103 = mu_4*n_4_y;
    const pkmodes_real f_y_x_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t103;
    const pkmodes_real t104 = mu_5*n_5_y;
    const pkmodes_real f_y_x_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t104;
    const pkmodes_real t105 = mu_6*n_6_y;
    const pkmodes_real f_y_x_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t105;
    const pkmodes_real t106 = mu_1*n_1_z;
    const pkmodes_real f_z_x_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t106;
    const pkmodes_real t107 = mu_2*n_2_z;
    const pkmodes_real f_z_x_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t107;
    const pkmodes_real t108 = mu_3*n_3_z;
    const pkmodes_real f_z_x_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t108;
    const pkmodes_real t109 = mu_4*n_4_z;
    const pkmodes_real f_z_x_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t109;
    const pkmodes_real t110 = mu_5*n_5_z;
    const pkmodes_real f_z_x_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t110;
    const pkmodes_real t111 = mu_6*n_6_z;
    const pkmodes_real f_z_x_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t111;
    const pkmodes_real t112 = -n_1_y*t59 + n_1_z*t65;
    const pkmodes_real f_rx_x_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx + t112;
    const pkmodes_real t113 = -n_2_y*t60 + n_2_z*t66;
    const pkmodes_real f_rx_x_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx + t113;
    const pkmodes_real t114 = -n_3_y*t61 + n_3_z*t67;
    const pkmodes_real f_rx_x_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx + t114;
    const pkmodes_real t115 = -n_4_y*t62 + n_4_z*t68;
    const pkmodes_real f_rx_x_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx + t115;
    const pkmodes_real t116 = -n_5_y*t63 + n_5_z*t69;
    const pkmodes_real f_rx_x_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx + t116;
    const pkmodes_real t117 = -n_6_y*t64 + n_6_z*t70;
    const pkmodes_real f_rx_x_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx + t117;
    const pkmodes_real t118 = n_1_z*t71;
    const pkmodes_real f_ry_x_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry + n_1_x*t59
        - t118;
    const pkmodes_real t119 = n_2_z*t72;
    const pkmodes_real f_ry_x_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry + n_2_x*t60
        - t119;
    const pkmodes_real t120 = n_3_z*t73;
    const pkmodes_real f_ry_x_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry + n_3_x*t61
        - t120;
    const pkmodes_real t121 = n_4_z*t74;
    const pkmodes_real f_ry_x_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry + n_4_x*t62
        - t121;
    const pkmodes_real t122 = n_5_z*t75;
    const pkmodes_real f_ry_x_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry + n_5_x*t63
        - t122;
    const pkmodes_real t123 = n_6_z*t76;
    const pkmodes_real f_ry_x_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry + n_6_x*t64
        - t123;
    const pkmodes_real t124 = -n_1_x*t65 + n_1_y*t71;
    const pkmodes_real f_rz_x_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz + t124;
    const pkmodes_real t125 = -n_2_x*t66 + n_2_y*t72;
    const pkmodes_real f_rz_x_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz + t125;
    const pkmodes_real t126 = -n_3_x*t67 + n_3_y*t73;
    const pkmodes_real f_rz_x_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz + t126;
    const pkmodes_real t127 = -n_4_x*t68 + n_4_y*t74;
    const pkmodes_real f_rz_x_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz + t127;
    const pkmodes_real t128 = -n_5_x*t69 + n_5_y*t75;
    const pkmodes_real f_rz_x_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz + t128;
    const pkmodes_real t129 = -n_6_x*t70 + n_6_y*t76;
    const pkmodes_real f_rz_x_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz + t129;
    const pkmodes_real t130 = B_1_z*mu_1*n_1_x - t118;
    const pkmodes_real t131 = B_2_z*mu_2*n_2_x - t119;
    const pkmodes_real t132 = B_3_z*mu_3*n_3_x - t120;
    const pkmodes_real t133 = B_4_z*mu_4*n_4_x - t121;
    const pkmodes_real t134 = B_5_z*mu_5*n_5_x - t122;
    const pkmodes_real t135 = (R_p_1*R_p_1);
    const pkmodes_real t136 = k_1_1*t135;
    const pkmodes_real t137 = (R_p_2*R_p_2);
    const pkmodes_real t138 = k_2_1*t137;
    const pkmodes_real t139 = (R_p_3*R_p_3);
    const pkmodes_real t140 = k_3_1*t139;
    const pkmodes_real t141 = (R_p_4*R_p_4);
    const pkmodes_real t142 = k_4_1*t141;
    const pkmodes_real t143 = (R_p_5*R_p_5);
    const pkmodes_real t144 = k_5_1*t143;
    const pkmodes_real t145 = (R_p_6*R_p_6);
    const pkmodes_real t146 = k_6_1*t145;
    memset(K, 0, sizeof(pkmodes_real[18][18]));
    K[0][0] =
        D_p_rx_1*f_rx_x_1 + D_p_rx_1*t112 + D_p_ry_1*f_ry_x_1 + D_p_ry_1*t130 + D_p_rz_1*f_rz_x_1
        + D_p_rz_1*t124 + D_p_x_1*f_x_x_1 + D_p_x_1*t94 + D_p_y_1*f_y_x_1 + D_p_y_1*t100 + D_p_z_1*f_z_x_1
        + D_p_z_1*t106 + k_1_2 + k_1_3 - mu_1*(n_1_x*n_1_x) - mu_1*(n_1_y*n_1_y) - mu_1*(n_1_z*n_1_z);
    K[0][1] = K[1][0] =
        D_p_rx_1*f_rx_x_2 + D_p_rx_2*t112 + D_p_ry_1*f_ry_x_2 + D_p_ry_2*t130 + D_p_rz_1*f_rz_x_2
        + D_p_rz_2*t124 + D_p_x_1*f_x_x_2 + D_p_x_2*t94 + D_p_y_1*f_y_x_2 + D_p_y_2*t100 + D_p_z_1*f_z_x_2
        + D_p_z_2*t106;
    K[0][2] = K[2][0] =
        D_p_rx_1*f_rx_x_3 + D_p_rx_3*t112 + D_p_ry_1*f_ry_x_3 + D_p_ry_3*t130 + D_p_rz_1*f_rz_x_3
        + D_p_rz_3*t124 + D_p_x_1*f_x_x_3 + D_p_x_3*t94 + D_p_y_1*f_y_x_3 + D_p_y_3*t100 + D_p_z_1*f_z_x_3
        + D_p_z_3*t106;
    K[0][3] = K[3][0] =
        D_p_rx_1*f_rx_x_4 + D_p_rx_4*t112 + D_p_ry_1*f_ry_x_4 + D_p_ry_4*t130 + D_p_rz_1*f_rz_x_4
        + D_p_rz_4*t124 + D_p_x_1*f_x_x_4 + D_p_x_4*t94 + D_p_y_1*f_y_x_4 + D_p_y_4*t100 + D_p_z_1*f_z_x_4
        + D_p_z_4*t106;
    K[0][4] = K[4][0] =
        D_p_rx_1*f_rx_x_5 + D_p_rx_5*t112 + D_p_ry_1*f_ry_x_5 + D_p_ry_5*t130 + D_p_rz_1*f_rz_x_5
        + D_p_rz_5*t124 + D_p_x_1*f_x_x_5 + D_p_x_5*t94 + D_p_y_1*f_y_x_5 + D_p_y_5*t100 + D_p_z_1*f_z_x_5
        + D_p_z_5*t106;
    K[0][5] = K[5][0] =
        D_p_rx_1*f_rx_x_6 + D_p_rx_6*t112 + D_p_ry_1*f_ry_x_6 + D_p_ry_6*t130 + D_p_rz_1*f_rz_x_6
        + D_p_rz_6*t124 + D_p_x_1*f_x_x_6 + D_p_x_6*t94 + D_p_y_1*f_y_x_6 + D_p_y_6*t100 + D_p_z_1*f_z_x_6
        + D_p_z_6*t106;
    K[0][6] = K[6][0] = -R_p_1*k_1_3;
    K[0][12] = K[12][0] = -R_p_1*k_1_2;
    K[1][1] =
        D_p_rx_2*f_rx_x_2 + D_p_rx_2*t113 + D_p_ry_2*f_ry_x_2 + D_p_ry_2*t131 + D_p_rz_2*f_rz_x_2
        + D_p_rz_2*t125 + D_p_x_2*f_x_x_2 + D_p_x_2*t95 + D_p_y_2*f_y_x_2 + D_p_y_2*t101 + D_p_z_2*f_z_x_2
        + D_p_z_2*t107 + k_2_2 + k_2_3 - mu_2*(n_2_x*n_2_x) - mu_2*(n_2_y*n_2_y) - mu_2*(n_2_z*n_2_z);
    K[1][2] = K[2][1] =
        D_p_rx_2*f_rx_x_3 + D_p_rx_3*t113 + D_p_ry_2*f_ry_x_3 + D_p_ry_3*t131 + D_p_rz_2*f_rz_x_3
        + D_p_rz_3*t125 + D_p_x_2*f_x_x_3 + D_p_x_3*t95 + D_p_y_2*f_y_x_3 + D_p_y_3*t101 + D_p_z_2*f_z_x_3
        + D_p_z_3*t107;
    K[1][3] = K[3][1] =
        D_p_rx_2*f_rx_x_4 + D_p_rx_4*t113 + D_p_ry_2*f_ry_x_4 + D_p_ry_4*t131 + D_p_rz_2*f_rz_x_4
        + D_p_rz_4*t125 + D_p_x_2*f_x_x_4 + D_p_x_4*t95 + D_p_y_2*f_y_x_4 + D_p_y_4*t101 + D_p_z_2*f_z_x_4
        + D_p_z_4*t107;
    K[1][4] = K[4][1] =
        D_p_rx_2*f_rx_x_5 + D_p_rx_5*t113 + D_p_ry_2*f_ry_x_5 + D_p_ry_5*t131 + D_p_rz_2*f_rz_x_5
        + D_p_rz_5*t125 + D_p_x_2*f_x_x_5 + D_p_x_5*t95 + D_p_y_2*f_y_x_5 + D_p_y_5*t101 + D_p_z_2*f_z_x_5
        + D_p_z_5*t107;
    K[1][5] = K[5][1] =
        D_p_rx_2*f_rx_x_6 + D_p_rx_6*t113 + D_p_ry_2*f_ry_x_6 + D_p_ry_6*t131 + D_p_rz_2*f_rz_x_6
        + D_p_rz_6*t125 + D_p_x_2*f_x_x_6 + D_p_x_6*t95 + D_p_y_2*f_y_x_6 + D_p_y_6*t101 + D_p_z_2*f_z_x_6
        + D_p_z_6*t107;
    K[1][7] = K[7][1] = -R_p_2*k_2_3;
    K[1][13] = K[13][1] = -R_p_2*k_2_2;
    K[2][2] =
        D_p_rx_3*f_rx_x_3 + D_p_rx_3*t114 + D_p_ry_3*f_ry_x_3 + D_p_ry_3*t132 + D_p_rz_3*f_rz_x_3
        + D_p_rz_3*t126 + D_p_x_3*f_x_x_3 + D_p_x_3*t96 + D_p_y_3*f_y_x_3 + D_p_y_3*t102 + D_p_z_3*f_z_x_3
        + D_p_z_3*t108 + k_3_2 + k_3_3 - mu_3*(n_3_x*n_3_x) - mu_3*(n_3_y*n_3_y) - mu_3*(n_3_z*n_3_z);
    K[2][3] = K[3][2] =
        D_p_rx_3*f_rx_x_4 + D_p_rx_4*t114 + D_p_ry_3*f_ry_x_4 + D_p_ry_4*t132 + D_p_rz_3*f_rz_x_4
        + D_p_rz_4*t126 + D_p_x_3*f_x_x_4 + D_p_x_4*t96 + D_p_y_3*f_y_x_4 + D_p_y_4*t102 + D_p_z_3*f_z_x_4
        + D_p_z_4*t108;
    K[2][4] = K[4][2] =
        D_p_rx_3*f_rx_x_5 + D_p_rx_5*t114 + D_p_ry_3*f_ry_x_5 + D_p_ry_5*t132 + D_p_rz_3*f_rz_x_5
        + D_p_rz_5*t126 + D_p_x_3*f_x_x_5 + D_p_x_5*t96 + D_p_y_3*f_y_x_5 + D_p_y_5*t102 + D_p_z_3*f_z_x_5
        + D_p_z_5*t108;
    K[2][5] = K[5][2] =
        D_p_rx_3*f_rx_x_6 + D_p_rx_6*t114 + D_p_ry_3*f_ry_x_6 + D_p_ry_6*t132 + D_p_rz_3*f_rz_x_6
        + D_p_rz_6*t126 + D_p_x_3*f_x_x_6 + D_p_x_6*t96 + D_p_y_3*f_y_x_6 + D_p_y_6*t102 + D_p_z_3*f_z_x_6
        + D_p_z_6*t108;
    K[2][8] = K[8][2] = -R_p_3*k_3_3;
    K[2][14] = K[14][2] = -R_p_3*k_3_2;
    K[3][3] =
        D_p_rx_4*f_rx_x_4 + D_p_rx_4*t115 + D_p_ry_4*f_ry_x_4 + D_p_ry_4*t133 + D_p_rz_4*f_rz_x_4
        + D_p_rz_4*t127 + D_p_x_4*f_x_x_4 + D_p_x_4*t97 + D_p_y_4*f_y_x_4 + D_p_y_4*t103 + D_p_z_4*f_z_x_4
        + D_p_z_4*t109 + k_4_2 + k_4_3 - mu_4*(n_4_x*n_4_x) - mu_4*(n_4_y*n_4_y) - mu_4*(n_4_z*n_4_z);
    K[3][4] = K[4][3] =
        D_p_rx_4*f_rx_x_5 + D_p_rx_5*t115 + D_p_ry_4*f_ry_x_5 + D_p_ry_5*t133 + D_p_rz_4*f_rz_x_5
        + D_p_rz_5*t127 + D_p_x_4*f_x_x_5 + D_p_x_5*t97 + D_p_y_4*f_y_x_5 + D_p_y_5*t103 + D_p_z_4*f_z_x_5
        + D_p_z_5*t109;
    K[3][5] = K[5][3] =
        D_p_rx_4*f_rx_x_6 + D_p_rx_6*t115 + D_p_ry_4*f_ry_x_6 + D_p_ry_6*t133 + D_p_rz_4*f_rz_x_6
        + D_p_rz_6*t127 + D_p_x_4*f_x_x_6 + D_p_x_6*t97 + D_p_y_4*f_y_x_6 + D_p_y_6*t103 + D_p_z_4*f_z_x_6
        + D_p_z_6*t109;
    K[3][9] = K[9][3] = -R_p_4*k_4_3;
    K[3][15] = K[15][3] = -R_p_4*k_4_2;
    K[4][4] =
        D_p_rx_5*f_rx_x_5 + D_p_rx_5*t116 + D_p_ry_5*f_ry_x_5 + D_p_ry_5*t134 + D_p_rz_5*f_rz_x_5
        + D_p_rz_5*t128 + D_p_x_5*f_x_x_5 + D_p_x_5*t98 + D_p_y_5*f_y_x_5 + D_p_y_5*t104 + D_p_z_5*f_z_x_5
        + D_p_z_5*t110 + k_5_2 + k_5_3 - mu_5*(n_5_x*n_5_x) - mu_5*(n_5_y*n_5_y) - mu_5*(n_5_z*n_5_z);
    K[4][5] = K[5][4] =
        D_p_rx_5*f_rx_x_6 + D_p_rx_6*t116 + D_p_ry_5*f_ry_x_6 + D_p_ry_6*t134 + D_p_rz_5*f_rz_x_6
        + D_p_rz_6*t128 + D_p_x_5*f_x_x_6 + D_p_x_6*t98 + D_p_y_5*f_y_x_6 + D_p_y_6*t104 + D_p_z_5*f_z_x_6
        + D_p_z_6*t110;
    K[4][10] = K[10][4] = -R_p_5*k_5_3;
    K[4][16] = K[16][4] = -R_p_5*k_5_2;
    K[5][5] =
        D_p_rx_6*f_rx_x_6 + D_p_rx_6*t117 + D_p_ry_6*f_ry_x_6 + D_p_ry_6*(B_6_z*mu_6*n_6_x - t123)
        + D_p_rz_6*f_rz_x_6 + D_p_rz_6*t129 + D_p_x_6*f_x_x_6 + D_p_x_6*t99 + D_p_y_6*f_y_x_6 + D_p_y_6*t105
        + D_p_z_6*f_z_x_6 + D_p_z_6*t111 + k_6_2 + k_6_3 - mu_6*(n_6_x*n_6_x) - mu_6*(n_6_y*n_6_y)
        - mu_6*(n_6_z*n_6_z);
    K[5][11] = K[11][5] = -R_p_6*k_6_3;
    K[5][17] = K[17][5] = -R_p_6*k_6_2;
    K[6][6] = k_1_3*t135 + t136;
    K[6][12] = K[12][6] = -t136;
    K[7][7] = k_2_3*t137 + t138;
    K[7][13] = K[13][7] = -t138;
    K[8][8] = k_3_3*t139 + t140;
    K[8][14] = K[14][8] = -t140;
    K[9][9] = k_4_3*t141 + t142;
    K[9][15] = K[15][9] = -t142;
    K[10][10] = k_5_3*t143 + t144;
    K[10][16] = K[16][10] = -t144;
    K[11][11] = k_6_3*t145 + t146;
    K[11][17] = K[17][11] = -t146;
    K[12][12] = k_1_2*t135 + t136;
    K[13][13] = k_2_2*t137 + t138;
    K[14][14] = k_3_2*t139 + t140;
    K[15][15] = k_4_2*t141 + t142;
    K[16][16] = k_5_2*t143 + t144;
    K[17][17] = k_6_2*t145 + t146;
}

void hexaglide_modal_matrices(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real M[18][18], pkmodes_real K[18][18])
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
    const pkmodes_real t31 = D_r_1*t30;
    const pkmodes_real D_p_x_1 = A_x_1*t31;
    const pkmodes_real t32 = D_r_2*t30;
    const pkmodes_real D_p_x_2 = A_x_2*t32;
    const pkmodes_real t33 = D_r_3*t30;
    const pkmodes_real D_p_x_3 = A_x_3*t33;
    const pkmodes_real t34 = D_r_4*t30;
    const pkmodes_real D_p_x_4 = A_x_4*t34;
    const pkmodes_real t35 = D_r_5*t30;
    const pkmodes_real D_p_x_5 = A_x_5*t35;
    const pkmodes_real t36 = D_r_6*t30;
    const pkmodes_real D_p_x_6 = A_x_6*t36;
    const pkmodes_real D_p_y_1 = A_y_1*t31;
    const pkmodes_real D_p_y_2 = A_y_2*t32;
    const pkmodes_real D_p_y_3 = A_y_3*t33;
    const pkmodes_real D_p_y_4 = A_y_4*t34;
    const pkmodes_real D_p_y_5 = A_y_5*t35;
    const pkmodes_real D_p_y_6 = A_y_6*t36;
    const pkmodes_real D_p_z_1 = A_z_1*t31;
    const pkmodes_real D_p_z_2 = A_z_2*t32;
    const pkmodes_real D_p_z_3 = A_z_3*t33;
    const pkmodes_real D_p_z_4 = A_z_4*t34;
    const pkmodes_real D_p_z_5 = A_z_5*t35;
    const pkmodes_real D_p_z_6 = A_z_6*t36;
    const pkmodes_real D_p_rx_1 = A_rx_1*t31;
    const pkmodes_real D_p_rx_2 = A_rx_2*t32;
    const pkmodes_real D_p_rx_3 = A_rx_3*t33;
    const pkmodes_real D_p_rx_4 = A_rx_4*t34;
    const pkmodes_real D_p_rx_5 = A_rx_5*t35;
    const pkmodes_real D_p_rx_6 = A_rx_6*t36;
    const pkmodes_real D_p_ry_1 = A_ry_1*t31;
    const pkmodes_real D_p_ry_2 = A_ry_2*t32;
    const pkmodes_real D_p_ry_3 = A_ry_3*t33;
    const pkmodes_real D_p_ry_4 = A_ry_4*t34;
    const pkmodes_real D_p_ry_5 = A_ry_5*t35;
    const pkmodes_real D_p_ry_6 = A_ry_6*t36;
    const pkmodes_real D_p_rz_1 = A_rz_1*t31;
    const pkmodes_real D_p_rz_2 = A_rz_2*t32;
    const pkmodes_real D_p_rz_3 = A_rz_3*t33;
    const pkmodes_real D_p_rz_4 = A_rz_4*t34;
    const pkmodes_real D_p_rz_5 = A_rz_5*t35;
    const pkmodes_real D_p_rz_6 = A_rz_6*t36;
    const pkmodes_real t37 = I_m_1*(i_g_1*i_g_1);
    const pkmodes_real I_1_1 = I_p_1 + d_1_1*t37;
    const pkmodes_real I_1_2 = I_p_1 + d_1_2*t37;
    const pkmodes_real t38 = I_m_2*(i_g_2*i_g_2);
    const pkmodes_real I_2_1 = I_p_2 + d_2_1*t38;
    const pkmodes_real I_2_2 = I_p_2 + d_2_2*t38;
    const pkmodes_real t39 = I_m_3*(i_g_3*i_g_3);
    const pkmodes_real I_3_1 = I_p_3 + d_3_1*t39;
    const pkmodes_real I_3_2 = I_p_3 + d_3_2*t39;
    const pkmodes_real t40 = I_m_4*(i_g_4*i_g_4);
    const pkmodes_real I_4_1 = I_p_4 + d_4_1*t40;
    const pkmodes_real I_4_2 = I_p_4 + d_4_2*t40;
    const pkmodes_real t41 = I_m_5*(i_g_5*i_g_5);
    const pkmodes_real I_5_1 = I_p_5 + d_5_1*t41;
    const pkmodes_real I_5_2 = I_p_5 + d_5_2*t41;
    const pkmodes_real t42 = I_m_6*(i_g_6*i_g_6);
    const pkmodes_real I_6_1 = I_p_6 + d_6_1*t42;
    const pkmodes_real I_6_2 = I_p_6 + d_6_2*t42;
    const pkmodes_real l_f_1_1 = x_max_1 - x_min_1;
    const pkmodes_real t43 = k_sp_1*w_b_1;
    const pkmodes_real k_1_1 = t43/l_f_1_1;
    const pkmodes_real t44 = (R(1.0)/R(2.0))*l_t_1;
    const pkmodes_real l_f_1_2 = -t44 + x_1 - x_min_1;
    const pkmodes_real k_1_2 = t43/l_f_1_2;
    const pkmodes_real l_f_1_3 = -t44 - x_1 + x_max_1;
    const pkmodes_real k_1_3 = t43/l_f_1_3;
    const pkmodes_real l_f_2_1 = x_max_2 - x_min_2;
    const pkmodes_real t45 = k_sp_2*w_b_2;
    const pkmodes_real k_2_1 = t45/l_f_2_1;
    const pkmodes_real t46 = (R(1.0)/R(2.0))*l_t_2;
    const pkmodes_real l_f_2_2 = -t46 + x_2 - x_min_2;
    const pkmodes_real k_2_2 = t45/l_f_2_2;
    const pkmodes_real l_f_2_3 = -t46 - x_2 + x_max_2;
    const pkmodes_real k_2_3 = t45/l_f_2_3;
    const pkmodes_real l_f_3_1 = x_max_3 - x_min_3;
    const pkmodes_real t47 = k_sp_3*w_b_3;
    const pkmodes_real k_3_1 = t47/l_f_3_1;
    const pkmodes_real t48 = (R(1.0)/R(2.0))*l_t_3;
    const pkmodes_real l_f_3_2 = -t48 + x_3 - x_min_3;
    const pkmodes_real k_3_2 = t47/l_f_3_2;
    const pkmodes_real l_f_3_3 = -t48 - x_3 + x_max_3;
    const pkmodes_real k_3_3 = t47/l_f_3_3;
    const pkmodes_real l_f_4_1 = x_max_4 - x_min_4;
    const pkmodes_real t49 = k_sp_4*w_b_4;
    const pkmodes_real k_4_1 = t49/l_f_4_1;
    const pkmodes_real t50 = (R(1.0)/R(2.0))*l_t_4;
    const pkmodes_real l_f_4_2 = -t50 + x_4 - x_min_4;
    const pkmodes_real k_4_2 = t49/l_f_4_2;
    const pkmodes_real l_f_4_3 = -t50 - x_4 + x_max_4;
    const pkmodes_real k_4_3 = t49/l_f_4_3;
    const pkmodes_real l_f_5_1 = x_max_5 - x_min_5;
    const pkmodes_real t51 = k_sp_5*w_b_5;
    const pkmodes_real k_5_1 = t51/l_f_5_1;
    const pkmodes_real t52 = (R(1.0)/R(2.0))*l_t_5;
    const pkmodes_real l_f_5_2 = -t52 + x_5 - x_min_5;
    const pkmodes_real k_5_2 = t51/l_f_5_2;
    const pkmodes_real l_f_5_3 = -t52 - x_5 + x_max_5;
    const pkmodes_real k_5_3 = t51/l_f_5_3;
    const pkmodes_real l_f_6_1 = x_max_6 - x_min_6;
    const pkmodes_real t53 = k_sp_6*w_b_6;
    const pkmodes_real k_6_1 = t53/l_f_6_1;
    const pkmodes_real t54 = (R(1.0)/R(2.0))*l_t_6;
    const pkmodes_real l_f_6_2 = -t54 + x_6 - x_min_6;
    const pkmodes_real k_6_2 = t53/l_f_6_2;
    const pkmodes_real l_f_6_3 = -t54 - x_6 + x_max_6;
    const pkmodes_real k_6_3 = t53/l_f_6_3;
    const pkmodes_real t55 = (R(1.0)/R(2.0))*m_d_1;
    const pkmodes_real t56 = (R(1.0)/R(2.0))*m_d_2;
    const pkmodes_real t57 = (R(1.0)/R(2.0))*m_d_3;
    const pkmodes_real t58 = (R(1.0)/R(2.0))*m_d_4;
    const pkmodes_real t59 = (R(1.0)/R(2.0))*m_d_5;
    const pkmodes_real t60 = (R(1.0)/R(2.0))*m_d_6;
    const pkmodes_real t61 = m_p + t55 + t56 + t57 + t58 + t59 + t60;
    const pkmodes_real G_p_x = -g_x*t61;
    const pkmodes_real G_p_y = -g_y*t61;
    const pkmodes_real G_p_z = -g_z*t61;
    const pkmodes_real t62 = g_z*m_p;
    const pkmodes_real t63 = g_z*t55;
    const pkmodes_real t64 = g_z*t56;
    const pkmodes_real t65 = g_z*t57;
    const pkmodes_real t66 = g_z*t58;
    const pkmodes_real t67 = g_z*t59;
    const pkmodes_real t68 = g_z*t60;
    const pkmodes_real G_p_rx =
        -B_1_y*t63 + (R(1.0)/R(2.0))*B_1_z*g_y*m_d_1 - B_2_y*t64 + (R(1.0)/R(2.0))*B_2_z*g_y*m_d_2
        - B_3_y*t65 + (R(1.0)/R(2.0))*B_3_z*g_y*m_d_3 - B_4_y*t66 + (R(1.0)/R(2.0))*B_4_z*g_y*m_d_4
        - B_5_y*t67 + (R(1.0)/R(2.0))*B_5_z*g_y*m_d_5 - B_6_y*t68 + (R(1.0)/R(2.0))*B_6_z*g_y*m_d_6 - c_y*t62
        + c_z*g_y*m_p;
    const pkmodes_real t69 = g_x*t55;
    const pkmodes_real t70 = g_x*t56;
    const pkmodes_real t71 = g_x*t57;
    const pkmodes_real t72 = g_x*t58;
    const pkmodes_real t73 = g_x*t59;
    const pkmodes_real t74 = g_x*t60;
    const pkmodes_real t75 = g_x*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t63 - B_1_z*t69 + B_2_x*t64 - B_2_z*t70 + B_3_x*t65 - B_3_z*t71 + B_4_x*t66 - B_4_z*t72
        + B_5_x*t67 - B_5_z*t73 + B_6_x*t68 - B_6_z*t74 + c_x*t62 - c_z*t75;
    const pkmodes_real t76 = g_y*m_p;
    const pkmodes_real t77 = g_y*t55;
    const pkmodes_real t78 = g_y*t56;
    const pkmodes_real t79 = g_y*t57;
    const pkmodes_real t80 = g_y*t58;
    const pkmodes_real t81 = g_y*t59;
    const pkmodes_real t82 = g_y*t60;
    const pkmodes_real G_p_rz =
        -B_1_x*t77 + (R(1.0)/R(2.0))*B_1_y*g_x*m_d_1 - B_2_x*t78 + (R(1.0)/R(2.0))*B_2_y*g_x*m_d_2
        - B_3_x*t79 + (R(1.0)/R(2.0))*B_3_y*g_x*m_d_3 - B_4_x*t80 + (R(1.0)/R(2.0))*B_4_y*g_x*m_d_4
        - B_5_x*t81 + (R(1.0)/R(2.0))*B_5_y*g_x*m_d_5 - B_6_x*t82 + (R(1.0)/R(2.0))*B_6_y*g_x*m_d_6 - c_x*t76
        + c_y*g_x*m_p;
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
    const pkmodes_real g_4_x = -mu_1*s_1_x - t69;
    const pkmodes_real g_4_y = -mu_1*s_1_y - t77;
    const pkmodes_real g_4_z = -mu_1*s_1_z - t63;
    const pkmodes_real g_5_x = -mu_2*s_2_x - t70;
    const pkmodes_real g_5_y = -mu_2*s_2_y - t78;
    const pkmodes_real g_5_z = -mu_2*s_2_z - t64;
    const pkmodes_real g_6_x = -mu_3*s_3_x - t71;
    const pkmodes_real g_6_y = -mu_3*s_3_y - t79;
    const pkmodes_real g_6_z = -mu_3*s_3_z - t65;
    const pkmodes_real g_7_x = -mu_4*s_4_x - t72;
    const pkmodes_real g_7_y = -mu_4*s_4_y - t80;
    const pkmodes_real g_7_z = -mu_4*s_4_z - t66;
    const pkmodes_real g_8_x = -mu_5*s_5_x - t73;
    const pkmodes_real g_8_y = -mu_5*s_5_y - t81;
    const pkmodes_real g_8_z = -mu_5*s_5_z - t67;
    const pkmodes_real g_9_x = -mu_6*s_6_x - t74;
    const pkmodes_real g_9_y = -mu_6*s_6_y - t82;
    const pkmodes_real g_9_z = -mu_6*s_6_z - t68;
    const pkmodes_real g_10_x = -t75;
    const pkmodes_real g_10_y = -t76;
    const pkmodes_real g_10_z = -t62;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t83 = B_1_z*mu_1;
    const pkmodes_real t84 = B_2_z*mu_2;
    const pkmodes_real t85 = B_3_z*mu_3;
    const pkmodes_real t86 = B_4_z*mu_4;
    const pkmodes_real t87 = B_5_z*mu_5;
    const pkmodes_real t88 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t83 + t84 + t85 + t86 + t87 + t88;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t89 = B_1_y*mu_1;
    const pkmodes_real t90 = B_2_y*mu_2;
    const pkmodes_real t91 = B_3_y*mu_3;
    const pkmodes_real t92 = B_4_y*mu_4;
    const pkmodes_real t93 = B_5_y*mu_5;
    const pkmodes_real t94 = B_6_y*mu_6;
    const pkmodes_real L_x_rz = t89 + t90 + t91 + t92 + t93 + t94;
    const pkmodes_real t95 = B_1_x*mu_1;
    const pkmodes_real t96 = B_2_x*mu_2;
    const pkmodes_real t97 = B_3_x*mu_3;
    const pkmodes_real t98 = B_4_x*mu_4;
    const pkmodes_real t99 = B_5_x*mu_5;
    const pkmodes_real t100 = B_6_x*mu_6;
    const pkmodes_real L_z_ry = t100 + t95 + t96 + t97 + t98 + t99;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t101 = (B_1_z*B_1_z);
    const pkmodes_real t102 = (B_2_z*B_2_z);
    const pkmodes_real t103 = (B_3_z*B_3_z);
    const pkmodes_real t104 = (B_4_z*B_4_z);
    const pkmodes_real t105 = (B_5_z*B_5_z);
    const pkmodes_real t106 = (B_6_z*B_6_z);
    const pkmodes_real t107 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + mu_1*t101 + mu_2*t102 + mu_3*t103 + mu_4*t104 + mu_5*t105 + mu_6*t106;
    const pkmodes_real t108 = (B_1_y*B_1_y);
    const pkmodes_real t109 = (B_2_y*B_2_y);
    const pkmodes_real t110 = (B_3_y*B_3_y);
    const pkmodes_real t111 = (B_4_y*B_4_y);
    const pkmodes_real t112 = (B_5_y*B_5_y);
    const pkmodes_real t113 = (B_6_y*B_6_y);
    const pkmodes_real t114 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + mu_1*t108 + mu_2*t109 + mu_3*t110 + mu_4*t111 + mu_5*t112 + mu_6*t113;
    const pkmodes_real L_rx_rx = -t107 - t114;
    const pkmodes_real t115 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t116 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t117 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t118 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t119 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t120 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t121 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t122 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t123 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t124 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t125 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t126 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real t127 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t128 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t89 + B_1_y*t116 + B_2_x*t90 + B_2_y*t118 + B_3_x*t91 + B_3_y*t120 + B_4_x*t92 + B_4_y*t122
        + B_5_x*t93 + B_5_y*t124 + B_6_x*t94 + B_6_y*t126 + c_y*t128 + g_10_y*t127 + g_4_y*t115 + g_5_y*t117
        + g_6_y*t119 + g_7_y*t121 + g_8_y*t123 + g_9_y*t125;
    const pkmodes_real L_rx_rz =
        B_1_x*t83 + B_1_z*t116 + B_2_x*t84 + B_2_z*t118 + B_3_x*t85 + B_3_z*t120 + B_4_x*t86 + B_4_z*t122
        + B_5_x*t87 + B_5_z*t124 + B_6_x*t88 + B_6_z*t126 + c_z*t128 + g_10_z*t127 + g_4_z*t115 + g_5_z*t117
        + g_6_z*t119 + g_7_z*t121 + g_8_z*t123 + g_9_z*t125;
    const pkmodes_real t129 = (B_1_x*B_1_x);
    const pkmodes_real t130 = (B_2_x*B_2_x);
    const pkmodes_real t131 = (B_3_x*B_3_x);
    const pkmodes_real t132 = (B_4_x*B_4_x);
    const pkmodes_real t133 = (B_5_x*B_5_x);
    const pkmodes_real t134 = (B_6_x*B_6_x);
    const pkmodes_real t135 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + mu_1*t129 + mu_2*t130 + mu_3*t131 + mu_4*t132 + mu_5*t133 + mu_6*t134;
    const pkmodes_real L_ry_ry = -t107 - t135;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t83 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t84 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t85
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t86 + (R(1.0)/R(2.0))*B_4_z*g_7_y
        + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t87 + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z
        + B_6_y*t88 + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y;
    const pkmodes_real L_rz_rz = -t114 - t135;
    const pkmodes_real t136 = mu_1*n_1_x;
    const pkmodes_real f_x_x_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t136;
    const pkmodes_real t137 = mu_2*n_2_x;
    const pkmodes_real f_x_x_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t137;
    const pkmodes_real t138 = mu_3*n_3_x;
    const pkmodes_real f_x_x_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t138;
    const pkmodes_real t139 = mu_4*n_4_x;
    const pkmodes_real f_x_x_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t139;
    const pkmodes_real t140 = mu_5*n_5_x;
    const pkmodes_real f_x_x_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t140;
    const pkmodes_real t141 = mu_6*n_6_x;
    const pkmodes_real f_x_x_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t141;
    const pkmodes_real t142 = mu_1*n_1_y;
    const pkmodes_real f_y_x_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t142;
    const pkmodes_real t143 = mu_2*n_2_y;
    const pkmodes_real f_y_x_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t143;
    const pkmodes_real t144 = mu_3*n_3_y;
    const pkmodes_real f_y_x_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t144;
    const pkmodes_real t145 = mu_4*n_4_y;
    const pkmodes_real f_y_x_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t145;
    const pkmodes_real t146 = mu_5*n_5_y;
    const pkmodes_real f_y_x_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t146;
    const pkmodes_real t147 = mu_6*n_6_y;
    const pkmodes_real f_y_x_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t147;
    const pkmodes_real t148 = mu_1*n_1_z;
    const pkmodes_real f_z_x_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t148;
    const pkmodes_real t149 = mu_2*n_2_z;
    const pkmodes_real f_z_x_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t149;
    const pkmodes_real t150 = mu_3*n_3_z;
    const pkmodes_real f_z_x_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t150;
    const pkmodes_real t151 = mu_4*n_4_z;
    const pkmodes_real f_z_x_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t151;
    const pkmodes_real t152 = mu_5*n_5_z;
    const pkmodes_real f_z_x_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t152;
    const pkmodes_real t153 = mu_6*n_6_z;
    const pkmodes_real f_z_x_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t153;
    const pkmodes_real t154 = -n_1_y*t83 + n_1_z*t89;
    const pkmodes_real f_rx_x_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx + t154;
    const pkmodes_real t155 = -n_2_y*t84 + n_2_z*t90;
    const pkmodes_real f_rx_x_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx + t155;
    const pkmodes_real t156 = -n_3_y*t85 + n_3_z*t91;
    const pkmodes_real f_rx_x_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx + t156;
    const pkmodes_real t157 = -n_4_y*t86 + n_4_z*t92;
    const pkmodes_real f_rx_x_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx + t157;
    const pkmodes_real t158 = -n_5_y*t87 + n_5_z*t93;
    const pkmodes_real f_rx_x_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx + t158;
    const pkmodes_real t159 = -n_6_y*t88 + n_6_z*t94;
    const pkmodes_real f_rx_x_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx + t159;
    const pkmodes_real t160 = n_1_z*t95;
    const pkmodes_real f_ry_x_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry + n_1_x*t83
        - t160;
    const pkmodes_real t161 = n_2_z*t96;
    const pkmodes_real f_ry_x_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry + n_2_x*t84
        - t161;
    const pkmodes_real t162 = n_3_z*t97;
    const pkmodes_real f_ry_x_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry + n_3_x*t85
        - t162;
    const pkmodes_real t163 = n_4_z*t98;
    const pkmodes_real f_ry_x_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry + n_4_x*t86
        - t163;
    const pkmodes_real t164 = n_5_z*t99;
    const pkmodes_real f_ry_x_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry + n_5_x*t87
        - t164;
    const pkmodes_real t165 = n_6_z*t100;
    const pkmodes_real f_ry_x_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry + n_6_x*t88
        - t165;
    const pkmodes_real t166 = -n_1_x*t89 + n_1_y*t95;
    const pkmodes_real f_rz_x_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz + t166;
    const pkmodes_real t167 = -n_2_x*t90 + n_2_y*t96;
    const pkmodes_real f_rz_x_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz + t167;
    const pkmodes_real t168 = -n_3_x*t91 + n_3_y*t97;
    const pkmodes_real f_rz_x_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz + t168;
    const pkmodes_real t169 = -n_4_x*t92 + n_4_y*t98;
    const pkmodes_real f_rz_x_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz + t169;
    const pkmodes_real t170 = -n_5_x*t93 + n_5_y*t99;
    const pkmodes_real f_rz_x_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz + t170;
    const pkmodes_real t171 = -n_6_x*t94 + n_6_y*t100;
    const pkmodes_real f_rz_x_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz + t171;
    const pkmodes_real t172 = (R(1.0)/R(3.0))*m_d_1;
    const pkmodes_real t173 = (R(1.0)/R(3.0))*m_d_2;
    const pkmodes_real t174 = (R(1.0)/R(3.0))*m_d_3;
    const pkmodes_real t175 = (R(1.0)/R(3.0))*m_d_4;
    const pkmodes_real t176 = (R(1.0)/R(3.0))*m_d_5;
    const pkmodes_real t177 = (R(1.0)/R(3.0))*m_d_6;
    const pkmodes_real M_p_x_x = m_p + t172 + t173 + t174 + t175 + t176 + t177;
    const pkmodes_real t178 = c_z*m_p;
    const pkmodes_real t179 = B_1_z*t172;
    const pkmodes_real t180 = B_2_z*t173;
    const pkmodes_real t181 = B_3_z*t174;
    const pkmodes_real t182 = B_4_z*t175;
    const pkmodes_real t183 = B_5_z*t176;
    const pkmodes_real t184 = B_6_z*t177;
    const pkmodes_real M_p_x_ry = t178 + t179 + t180 + t181 + t182 + t183 + t184;
    const pkmodes_real t185 = c_y*m_p;
    const pkmodes_real t186 = B_1_y*t172;
    const pkmodes_real t187 = B_2_y*t173;
    const pkmodes_real t188 = B_3_y*t174;
    const pkmodes_real t189 = B_4_y*t175;
    const pkmodes_real t190 = B_5_y*t176;
    const pkmodes_real t191 = B_6_y*t177;
    const pkmodes_real M_p_z_rx = t185 + t186 + t187 + t188 + t189 + t190 + t191;
    const pkmodes_real M_p_x_rz = -M_p_z_rx;
    const pkmodes_real M_p_y_rx = -M_p_x_ry;
    const pkmodes_real M_p_y_rz =
        B_1_x*t172 + B_2_x*t173 + B_3_x*t174 + B_4_x*t175 + B_5_x*t176 + B_6_x*t177 + c_x*m_p;
    const pkmodes_real M_p_z_ry = -M_p_y_rz;
    const pkmodes_real t192 = 2*t108;
    const pkmodes_real t193 = 2*t101;
    const pkmodes_real t194 = (R(1.0)/R(6.0))*m_d_1;
    const pkmodes_real t195 = 2*t109;
    const pkmodes_real t196 = 2*t102;
    const pkmodes_real t197 = (R(1.0)/R(6.0))*m_d_2;
    const pkmodes_real t198 = 2*t110;
    const pkmodes_real t199 = 2*t103;
    const pkmodes_real t200 = (R(1.0)/R(6.0))*m_d_3;
    const pkmodes_real t201 = 2*t111;
    const pkmodes_real t202 = 2*t104;
    const pkmodes_real t203 = (R(1.0)/R(6.0))*m_d_4;
    const pkmodes_real t204 = 2*t112;
    const pkmodes_real t205 = 2*t105;
    const pkmodes_real t206 = (R(1.0)/R(6.0))*m_d_5;
    const pkmodes_real t207 = 2*t113;
    const pkmodes_real t208 = 2*t106;
    const pkmodes_real t209 = (R(1.0)/R(6.0))*m_d_6;
    const pkmodes_real t210 = 2*(c_y*c_y);
    const pkmodes_real t211 = 2*(c_z*c_z);
    const pkmodes_real t212 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real M_p_rx_rx =
        J_x_x + t194*(t192 + t193) + t197*(t195 + t196) + t200*(t198 + t199) + t203*(t201 + t202)
        + t206*(t204 + t205) + t209*(t207 + t208) + t212*(t210 + t211);
    const pkmodes_real M_p_rx_ry =
        -B_1_x*t186 - B_2_x*t187 - B_3_x*t188 - B_4_x*t189 - B_5_x*t190 - B_6_x*t191 + J_x_y - c_x*t185;
    const pkmodes_real M_p_rx_rz =
        -B_1_x*t179 - B_2_x*t180 - B_3_x*t181 - B_4_x*t182 - B_5_x*t183 - B_6_x*t184 + J_x_z - c_x*t178;
    const pkmodes_real t213 = 2*t129;
    const pkmodes_real t214 = 2*t130;
    const pkmodes_real t215 = 2*t131;
    const pkmodes_real t216 = 2*t132;
    const pkmodes_real t217 = 2*t133;
    const pkmodes_real t218 = 2*t134;
    const pkmodes_real t219 = 2*(c_x*c_x);
    const pkmodes_real M_p_ry_ry =
        J_y_y + t194*(t193 + t213) + t197*(t196 + t214) + t200*(t199 + t215) + t203*(t202 + t216)
        + t206*(t205 + t217) + t209*(t208 + t218) + t212*(t211 + t219);
    const pkmodes_real M_p_ry_rz =
        -B_1_y*t179 - B_2_y*t180 - B_3_y*t181 - B_4_y*t182 - B_5_y*t183 - B_6_y*t184 + J_y_z - c_y*t178;
    const pkmodes_real M_p_rz_rz =
        J_z_z + t194*(t192 + t213) + t197*(t195 + t214) + t200*(t198 + t215) + t203*(t201 + t216)
        + t206*(t204 + t217) + t209*(t207 + t218) + t212*(t210 + t219);
    const pkmodes_real t220 = n_1_x*t194;
    const pkmodes_real h_x_x_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x + t220;
    const pkmodes_real t221 = n_2_x*t197;
    const pkmodes_real h_x_x_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x + t221;
    const pkmodes_real t222 = n_3_x*t200;
    const pkmodes_real h_x_x_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x + t222;
    const pkmodes_real t223 = n_4_x*t203;
    const pkmodes_real h_x_x_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x + t223;
    const pkmodes_real t224 = n_5_x*t206;
    const pkmodes_real h_x_x_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x + t224;
    const pkmodes_real t225 = n_6_x*t209;
    const pkmodes_real h_x_x_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x + t225;
    const pkmodes_real t226 = n_1_y*t194;
    const pkmodes_real h_y_x_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x + t226;
    const pkmodes_real t227 = n_2_y*t197;
    const pkmodes_real h_y_x_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x + t227;
    const pkmodes_real t228 = n_3_y*t200;
    const pkmodes_real h_y_x_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x + t228;
    const pkmodes_real t229 = n_4_y*t203;
    const pkmodes_real h_y_x_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x + t229;
    const pkmodes_real t230 = n_5_y*t206;
    const pkmodes_real h_y_x_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x + t230;
    const pkmodes_real t231 = n_6_y*t209;
    const pkmodes_real h_y_x_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x + t231;
    const pkmodes_real t232 = n_1_z*t194;
    const pkmodes_real h_z_x_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x + t232;
    const pkmodes_real t233 = n_2_z*t197;
    const pkmodes_real h_z_x_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x + t233;
    const pkmodes_real t234 = n_3_z*t200;
    const pkmodes_real h_z_x_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x + t234;
    const pkmodes_real t235 = n_4_z*t203;
    const pkmodes_real h_z_x_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x + t235;
    const pkmodes_real t236 = n_5_z*t206;
    const pkmodes_real h_z_x_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x + t236;
    const pkmodes_real t237 = n_6_z*t209;
    const pkmodes_real h_z_x_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x + t237;
    const pkmodes_real t238 = t194*(B_1_y*n_1_z - B_1_z*n_1_y);
    const pkmodes_real h_rx_x_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx
        + t238;
    const pkmodes_real t239 = t197*(B_2_y*n_2_z - B_2_z*n_2_y);
    const pkmodes_real h_rx_x_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx
        + t239;
    const pkmodes_real t240 = t200*(B_3_y*n_3_z - B_3_z*n_3_y);
    const pkmodes_real h_rx_x_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx
        + t240;
    const pkmodes_real t241 = t203*(B_4_y*n_4_z - B_4_z*n_4_y);
    const pkmodes_real h_rx_x_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx
        + t241;
    const pkmodes_real t242 = t206*(B_5_y*n_5_z - B_5_z*n_5_y);
    const pkmodes_real h_rx_x_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx
        + t242;
    const pkmodes_real t243 = t209*(B_6_y*n_6_z - B_6_z*n_6_y);
    const pkmodes_real h_rx_x_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx
        + t243;
    const pkmodes_real t244 = t194*(-B_1_x*n_1_z + B_1_z*n_1_x);
    const pkmodes_real h_ry_x_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry
        + t244;
    const pkmodes_real t245 = t197*(-B_2_x*n_2_z + B_2_z*n_2_x);
    const pkmodes_real h_ry_x_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry
        + t245;
    const pkmodes_real t246 = t200*(-B_3_x*n_3_z + B_3_z*n_3_x);
    const pkmodes_real h_ry_x_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry
        + t246;
    const pkmodes_real t247 = t203*(-B_4_x*n_4_z + B_4_z*n_4_x);
    const pkmodes_real h_ry_x_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry
        + t247;
    const pkmodes_real t248 = t206*(-B_5_x*n_5_z + B_5_z*n_5_x);
    const pkmodes_real h_ry_x_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry
        + t248;
    const pkmodes_real t249 = t209*(-B_6_x*n_6_z + B_6_z*n_6_x);
    const pkmodes_real h_ry_x_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry
        + t249;
    const pkmodes_real t250 = t194*(B_1_x*n_1_y - B_1_y*n_1_x);
    const pkmodes_real h_rz_x_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz
        + t250;
    const pkmodes_real t251 = t197*(B_2_x*n_2_y - B_2_y*n_2_x);
    const pkmodes_real h_rz_x_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz
        + t251;
    const pkmodes_real t252 = t200*(B_3_x*n_3_y - B_3_y*n_3_x);
    const pkmodes_real h_rz_x_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz
        + t252;
    const pkmodes_real t253 = t203*(B_4_x*n_4_y - B_4_y*n_4_x);
    const pkmodes_real h_rz_x_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz
        + t253;
    const pkmodes_real t254 = t206*(B_5_x*n_5_y - B_5_y*n_5_x);
    const pkmodes_real h_rz_x_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz
        + t254;
    const pkmodes_real t255 = t209*(B_6_x*n_6_y - B_6_y*n_6_x);
    const pkmodes_real h_rz_x_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz
        + t255;
    const pkmodes_real t256 = B_1_z*mu_1*n_1_x - t160;
    const pkmodes_real t257 = B_2_z*mu_2*n_2_x - t161;
    const pkmodes_real t258 = B_3_z*mu_3*n_3_x - t162;
    const pkmodes_real t259 = B_4_z*mu_4*n_4_x - t163;
    const pkmodes_real t260 = B_5_z*mu_5*n_5_x - t164;
    const pkmodes_real t261 = (R_p_1*R_p_1);
    const pkmodes_real t262 = k_1_1*t261;
    const pkmodes_real t263 = (R_p_2*R_p_2);
    const pkmodes_real t264 = k_2_1*t263;
    const pkmodes_real t265 = (R_p_3*R_p_3);
    const pkmodes_real t266 = k_3_1*t265;
    const pkmodes_real t267 = (R_p_4*R_p_4);
    const pkmodes_real t268 = k_4_1*t267;
    const pkmodes_real t269 = (R_p_5*R_p_5);
    const pkmodes_real t270 = k_5_1*t269;
    const pkmodes_real t271 = (R_p_6*R_p_6);
    const pkmodes_real t272 = k_6_1*t271;
    memset(M, 0, sizeof(pkmodes_real[18][18]));
    M[0][0] =
        D_p_rx_1*h_rx_x_1 + D_p_rx_1*t238 + D_p_ry_1*h_ry_x_1 + D_p_ry_1*t244 + D_p_rz_1*h_rz_x_1
        + D_p_rz_1*t250 + D_p_x_1*h_x_x_1 + D_p_x_1*t220 + D_p_y_1*h_y_x_1 + D_p_y_1*t226 + D_p_z_1*h_z_x_1
        + D_p_z_1*t232 + m_t_1 + t172;
    M[0][1] = M[1][0] =
        D_p_rx_1*h_rx_x_2 + D_p_rx_2*t238 + D_p_ry_1*h_ry_x_2 + D_p_ry_2*t244 + D_p_rz_1*h_rz_x_2
        + D_p_rz_2*t250 + D_p_x_1*h_x_x_2 + D_p_x_2*t220 + D_p_y_1*h_y_x_2 + D_p_y_2*t226 + D_p_z_1*h_z_x_2
        + D_p_z_2*t232;
    M[0][2] = M[2][0] =
        D_p_rx_1*h_rx_x_3 + D_p_rx_3*t238 + D_p_ry_1*h_ry_x_3 + D_p_ry_3*t244 + D_p_rz_1*h_rz_x_3
        + D_p_rz_3*t250 + D_p_x_1*h_x_x_3 + D_p_x_3*t220 + D_p_y_1*h_y_x_3 + D_p_y_3*t226 + D_p_z_1*h_z_x_3
        + D_p_z_3*t232;
    M[0][3] = M[3][0] =
        D_p_rx_1*h_rx_x_4 + D_p_rx_4*t238 + D_p_ry_1*h_ry_x_4 + D_p_ry_4*t244 + D_p_rz_1*h_rz_x_4
        + D_p_rz_4*t250 + D_p_x_1*h_x_x_4 + D_p_x_4*t220 + D_p_y_1*h_y_x_4 + D_p_y_4*t226 + D_p_z_1*h_z_x_4
        + D_p_z_4*t232;
    M[0][4] = M[4][0] =
        D_p_rx_1*h_rx_x_5 + D_p_rx_5*t238 + D_p_ry_1*h_ry_x_5 + D_p_ry_5*t244 + D_p_rz_1*h_rz_x_5
        + D_p_rz_5*t250 + D_p_x_1*h_x_x_5 + D_p_x_5*t220 + D_p_y_1*h_y_x_5 + D_p_y_5*t226 + D_p_z_1*h_z_x_5
        + D_p_z_5*t232;
    M[0][5] = M[5][0] =
        D_p_rx_1*h_rx_x_6 + D_p_rx_6*t238 + D_p_ry_1*h_ry_x_6 + D_p_ry_6*t244 + D_p_rz_1*h_rz_x_6
        + D_p_rz_6*t250 + D_p_x_1*h_x_x_6 + D_p_x_6*t220 + D_p_y_1*h_y_x_6 + D_p_y_6*t226 + D_p_z_1*h_z_x_6
        + D_p_z_6*t232;
    M[1][1] =
        D_p_rx_2*h_rx_x_2 + D_p_rx_2*t239 + D_p_ry_2*h_ry_x_2 + D_p_ry_2*t245 + D_p_rz_2*h_rz_x_2
        + D_p_rz_2*t251 + D_p_x_2*h_x_x_2 + D_p_x_2*t221 + D_p_y_2*h_y_x_2 + D_p_y_2*t227 + D_p_z_2*h_z_x_2
        + D_p_z_2*t233 + m_t_2 + t173;
    M[1][2] = M[2][1] =
        D_p_rx_2*h_rx_x_3 + D_p_rx_3*t239 + D_p_ry_2*h_ry_x_3 + D_p_ry_3*t245 + D_p_rz_2*h_rz_x_3
        + D_p_rz_3*t251 + D_p_x_2*h_x_x_3 + D_p_x_3*t221 + D_p_y_2*h_y_x_3 + D_p_y_3*t227 + D_p_z_2*h_z_x_3
        + D_p_z_3*t233;
    M[1][3] = M[3][1] =
        D_p_rx_2*h_rx_x_4 + D_p_rx_4*t239 + D_p_ry_2*h_ry_x_4 + D_p_ry_4*t245 + D_p_rz_2*h_rz_x_4
        + D_p_rz_4*t251 + D_p_x_2*h_x_x_4 + D_p_x_4*t221 + D_p_y_2*h_y_x_4 + D_p_y_4*t227 + D_p_z_2*h_z_x_4
        + D_p_z_4*t233;
    M[1][4] = M[4][1] =
        D_p_rx_2*h_rx_x_5 + D_p_rx_5*t239 + D_p_ry_2*h_ry_x_5 + D_p_ry_5*t245 + D_p_rz_2*h_rz_x_5
        + D_p_rz_5*t251 + D_p_x_2*h_x_x_5 + D_p_x_5*t221 + D_p_y_2*h_y_x_5 + D_p_y_5*t227 + D_p_z_2*h_z_x_5
        + D_p_z_5*t233;
    M[1][5] = M[5][1] =
        D_p_rx_2*h_rx_x_6 + D_p_rx_6*t239 + D_p_ry_2*h_ry_x_6 + D_p_ry_6*t245 + D_p_rz_2*h_rz_x_6
        + D_p_rz_6*t251 + D_p_x_2*h_x_x_6 + D_p_x_6*t221 + D_p_y_2*h_y_x_6 + D_p_y_6*t227 + D_p_z_2*h_z_x_6
        + D_p_z_6*t233;
    M[2][2] =
        D_p_rx_3*h_rx_x_3 + D_p_rx_3*t240 + D_p_ry_3*h_ry_x_3 + D_p_ry_3*t246 + D_p_rz_3*h_rz_x_3
        + D_p_rz_3*t252 + D_p_x_3*h_x_x_3 + D_p_x_3*t222 + D_p_y_3*h_y_x_3 + D_p_y_3*t228 + D_p_z_3*h_z_x_3
        + D_p_z_3*t234 + m_t_3 + t174;
    M[2][3] = M[3][2] =
        D_p_rx_3*h_rx_x_4 + D_p_rx_4*t240 + D_p_ry_3*h_ry_x_4 + D_p_ry_4*t246 + D_p_rz_3*h_rz_x_4
        + D_p_rz_4*t252 + D_p_x_3*h_x_x_4 + D_p_x_4*t222 + D_p_y_3*h_y_x_4 + D_p_y_4*t228 + D_p_z_3*h_z_x_4
        + D_p_z_4*t234;
    M[2][4] = M[4][2] =
        D_p_rx_3*h_rx_x_5 + D_p_rx_5*t240 + D_p_ry_3*h_ry_x_5 + D_p_ry_5*t246 + D_p_rz_3*h_rz_x_5
        + D_p_rz_5*t252 + D_p_x_3*h_x_x_5 + D_p_x_5*t222 + D_p_y_3*h_y_x_5 + D_p_y_5*t228 + D_p_z_3*h_z_x_5
        + D_p_z_5*t234;
    M[2][5] = M[5][2] =
        D_p_rx_3*h_rx_x_6 + D_p_rx_6*t240 + D_p_ry_3*h_ry_x_6 + D_p_ry_6*t246 + D_p_rz_3*h_rz_x_6
        + D_p_rz_6*t252 + D_p_x_3*h_x_x_6 + D_p_x_6*t222 + D_p_y_3*h_y_x_6 + D_p_y_6*t228 + D_p_z_3*h_z_x_6
        + D_p_z_6*t234;
    M[3][3] =
        D_p_rx_4*h_rx_x_4 + D_p_rx_4*t241 + D_p_ry_4*h_ry_x_4 + D_p_ry_4*t247 + D_p_rz_4*h_rz_x_4
        + D_p_rz_4*t253 + D_p_x_4*h_x_x_4 + D_p_x_4*t223 + D_p_y_4*h_y_x_4 + D_p_y_4*t229 + D_p_z_4*h_z_x_4
        + D_p_z_4*t235 + m_t_4 + t175;
    M[3][4] = M[4][3] =
        D_p_rx_4*h_rx_x_5 + D_p_rx_5*t241 + D_p_ry_4*h_ry_x_5 + D_p_ry_5*t247 + D_p_rz_4*h_rz_x_5
        + D_p_rz_5*t253 + D_p_x_4*h_x_x_5 + D_p_x_5*t223 + D_p_y_4*h_y_x_5 + D_p_y_5*t229 + D_p_z_4*h_z_x_5
        + D_p_z_5*t235;
    M[3][5] = M[5][3] =
        D_p_rx_4*h_rx_x_6 + D_p_rx_6*t241 + D_p_ry_4*h_ry_x_6 + D_p_ry_6*t247 + D_p_rz_4*h_rz_x_6
        + D_p_rz_6*t253 + D_p_x_4*h_x_x_6 + D_p_x_6*t223 + D_p_y_4*h_y_x_6 + D_p_y_6*t229 + D_p_z_4*h_z_x_6
        + D_p_z_6*t235;
    M[4][4] =
        D_p_rx_5*h_rx_x_5 + D_p_rx_5*t242 + D_p_ry_5*h_ry_x_5 + D_p_ry_5*t248 + D_p_rz_5*h_rz_x_5
        + D_p_rz_5*t254 + D_p_x_5*h_x_x_5 + D_p_x_5*t224 + D_p_y_5*h_y_x_5 + D_p_y_5*t230 + D_p_z_5*h_z_x_5
        + D_p_z_5*t236 + m_t_5 + t176;
    M[4][5] = M[5][4] =
        D_p_rx_5*h_rx_x_6 + D_p_rx_6*t242 + D_p_ry_5*h_ry_x_6 + D_p_ry_6*t248 + D_p_rz_5*h_rz_x_6
        + D_p_rz_6*t254 + D_p_x_5*h_x_x_6 + D_p_x_6*t224 + D_p_y_5*h_y_x_6 + D_p_y_6*t230 + D_p_z_5*h_z_x_6
        + D_p_z_6*t236;
    M[5][5] =
        D_p_rx_6*h_rx_x_6 + D_p_rx_6*t243 + D_p_ry_6*h_ry_x_6 + D_p_ry_6*t249 + D_p_rz_6*h_rz_x_6
        + D_p_rz_6*t255 + D_p_x_6*h_x_x_6 + D_p_x_6*t225 + D_p_y_6*h_y_x_6 + D_p_y_6*t231 + D_p_z_6*h_z_x_6
        + D_p_z_6*t237 + m_t_6 + t177;
    M[6][6] = I_1_1;
    M[7][7] = I_2_1;
    M[8][8] = I_3_1;
    M[9][9] = I_4_1;
    M[10][10] = I_5_1;
    M[11][11] = I_6_1;
    M[12][12] = I_1_2;
    M[13][13] = I_2_2;
    M[14][14] = I_3_2;
    M[15][15] = I_4_2;
    M[16][16] = I_5_2;
    M[17][17] = I_6_2;
    memset(K, 0, sizeof(pkmodes_real[18][18]));
    K[0][0] =
        D_p_rx_1*f_rx_x_1 + D_p_rx_1*t154 + D_p_ry_1*f_ry_x_1 + D_p_ry_1*t256 + D_p_rz_1*f_rz_x_1
        + D_p_rz_1*t166 + D_p_x_1*f_x_x_1 + D_p_x_1*t136 + D_p_y_1*f_y_x_1 + D_p_y_1*t142 + D_p_z_1*f_z_x_1
        + D_p_z_1*t148 + k_1_2 + k_1_3 - mu_1*(n_1_x*n_1_x) - mu_1*(n_1_y*n_1_y) - mu_1*(n_1_z*n_1_z);
    K[0][1] = K[1][0] =
        D_p_rx_1*f_rx_x_2 + D_p_rx_2*t154 + D_p_ry_1*f_ry_x_2 + D_p_ry_2*t256 + D_p_rz_1*f_rz_x_2
        + D_p_rz_2*t166 + D_p_x_1*f_x_x_2 + D_p_x_2*t136 + D_p_y_1*f_y_x_2 + D_p_y_2*t142 + D_p_z_1*f_z_x_2
        + D_p_z_2*t148;
    K[0][2] = K[2][0] =
        D_p_rx_1*f_rx_x_3 + D_p_rx_3*t154 + D_p_ry_1*f_ry_x_3 + D_p_ry_3*t256 + D_p_rz_1*f_rz_x_3
        + D_p_rz_3*t166 + D_p_x_1*f_x_x_3 + D_p_x_3*t136 + D_p_y_1*f_y_x_3 + D_p_y_3*t142 + D_p_z_1*f_z_x_3
        + D_p_z_3*t148;
    K[0][3] = K[3][0] =
        D_p_rx_1*f_rx_x_4 + D_p_rx_4*t154 + D_p_ry_1*f_ry_x_4 + D_p_ry_4*t256 + D_p_rz_1*f_rz_x_4
        + D_p_rz_4*t166 + D_p_x_1*f_x_x_4 + D_p_x_4*t136 + D_p_y_1*f_y_x_4 + D_p_y_4*t142 + D_p_z_1*f_z_x_4
        + D_p_z_4*t148;
    K[0][4] = K[4][0] =
        D_p_rx_1*f_rx_x_5 + D_p_rx_5*t154 + D_p_ry_1*f_ry_x_5 + D_p_ry_5*t256 + D_p_rz_1*f_rz_x_5
        + D_p_rz_5*t166 + D_p_x_1*f_x_x_5 + D_p_x_5*t136 + D_p_y_1*f_y_x_5 + D_p_y_5*t142 + D_p_z_1*f_z_x_5
        + D_p_z_5*t148;
    K[0][5] = K[5][0] =
        D_p_rx_1*f_rx_x_6 + D_p_rx_6*t154 + D_p_ry_1*f_ry_x_6 + D_p_ry_6*t256 + D_p_rz_1*f_rz_x_6
        + D_p_rz_6*t166 + D_p_x_1*f_x_x_6 + D_p_x_6*t136 + D_p_y_1*f_y_x_6 + D_p_y_6*t142 + D_p_z_1*f_z_x_6
        + D_p_z_6*t148;
    K[0][6] = K[6][0] = -R_p_1*k_1_3;
    K[0][12] = K[12][0] = -R_p_1*k_1_2;
    K[1][1] =
        D_p_rx_2*f_rx_x_2 + D_p_rx_2*t155 + D_p_ry_2*f_ry_x_2 + D_p_ry_2*t257 + D_p_rz_2*f_rz_x_2
        + D_p_rz_2*t167 + D_p_x_2*f_x_x_2 + D_p_x_2*t137 + D_p_y_2*f_y_x_2 + D_p_y_2*t143 + D_p_z_2*f_z_x_2
        + D_p_z_2*t149 + k_2_2 + k_2_3 - mu_2*(n_2_x*n_2_x) - mu_2*(n_2_y*n_2_y) - mu_2*(n_2_z*n_2_z);
    K[1][2] = K[2][1] =
        D_p_rx_2*f_rx_x_3 + D_p_rx_3*t155 + D_p_ry_2*f_ry_x_3 + D_p_ry_3*t257 + D_p_rz_2*f_rz_x_3
        + D_p_rz_3*t167 + D_p_x_2*f_x_x_3 + D_p_x_3*t137 + D_p_y_2*f_y_x_3 + D_p_y_3*t143 + D_p_z_2*f_z_x_3
        + D_p_z_3*t149;
    K[1][3] = K[3][1] =
        D_p_rx_2*f_rx_x_4 + D_p_rx_4*t155 + D_p_ry_2*f_ry_x_4 + D_p_ry_4*t257 + D_p_rz_2*f_rz_x_4
        + D_p_rz_4*t167 + D_p_x_2*f_x_x_4 + D_p_x_4*t137 + D_p_y_2*f_y_x_4 + D_p_y_4*t143 + D_p_z_2*f_z_x_4
        + D_p_z_4*t149;
    K[1][4] = K[4][1] =
        D_p_rx_2*f_rx_x_5 + D_p_rx_5*t155 + D_p_ry_2*f_ry_x_5 + D_p_ry_5*t257 + D_p_rz_2*f_rz_x_5
        + D_p_rz_5*t167 + D_p_x_2*f_x_x_5 + D_p_x_5*t137 + D_p_y_2*f_y_x_5 + D_p_y_5*t143 + D_p_z_2*f_z_x_5
        + D_p_z_5*t149;
    K[1][5] = K[5][1] =
        D_p_rx_2*f_rx_x_6 + D_p_rx_6*t155 + D_p_ry_2*f_ry_x_6 + D_p_ry_6*t257 + D_p_rz_2*f_rz_x_6
        + D_p_rz_6*t167 + D_p_x_2*f_x_x_6 + D_p_x_6*t137 + D_p_y_2*f_y_x_6 + D_p_y_6*t143 + D_p_z_2*f_z_x_6
        + D_p_z_6*t149;
    K[1][7] = K[7][1] = -R_p_2*k_2_3;
    K[1][13] = K[13][1] = -R_p_2*k_2_2;
    K[2][2] =
        D_p_rx_3*f_rx_x_3 + D_p_rx_3*t156 + D_p_ry_3*f_ry_x_3 + D_p_ry_3*t258 + D_p_rz_3*f_rz_x_3
        + D_p_rz_3*t168 + D_p_x_3*f_x_x_3 + D_p_x_3*t138 + D_p_y_3*f_y_x_3 + D_p_y_3*t144 + D_p_z_3*f_z_x_3
        + D_p_z_3*t150 + k_3_2 + k_3_3 - mu_3*(n_3_x*n_3_x) - mu_3*(n_3_y*n_3_y) - mu_3*(n_3_z*n_3_z);
    K[2][3] = K[3][2] =
        D_p_rx_3*f_rx_x_4 + D_p_rx_4*t156 + D_p_ry_3*f_ry_x_4 + D_p_ry_4*t258 + D_p_rz_3*f_rz_x_4
        + D_p_rz_4*t168 + D_p_x_3*f_x_x_4 + D_p_x_4*t138 + D_p_y_3*f_y_x_4 + D_p_y_4*t144 + D_p_z_3*f_z_x_4
        + D_p_z_4*t150;
    K[2][4] = K[4][2] =
        D_p_rx_3*f_rx_x_5 + D_p_rx_5*t156 + D_p_ry_3*f_ry_x_5 + D_p_ry_5*t258 + D_p_rz_3*f_rz_x_5
        + D_p_rz_5*t168 + D_p_x_3*f_x_x_5 + D_p_x_5*t138 + D_p_y_3*f_y_x_5 + D_p_y_5*t144 + D_p_z_3*f_z_x_5
        + D_p_z_5*t150;
    K[2][5] = K[5][2] =
        D_p_rx_3*f_rx_x_6 + D_p_rx_6*t156 + D_p_ry_3*f_ry_x_6 + D_p_ry_6*t258 + D_p_rz_3*f_rz_x_6
        + D_p_rz_6*t168 + D_p_x_3*f_x_x_6 + D_p_x_6*t138 + D_p_y_3*f_y_x_6 + D_p_y_6*t144 + D_p_z_3*f_z_x_6
        + D_p_z_6*t150;
    K[2][8] = K[8][2] = -R_p_3*k_3_3;
    K[2][14] = K[14][2] = -R_p_3*k_3_2;
    K[3][3] =
        D_p_rx_4*f_rx_x_4 + D_p_rx_4*t157 + D_p_ry_4*f_ry_x_4 + D_p_ry_4*t259 + D_p_rz_4*f_rz_x_4
        + D_p_rz_4*t169 + D_p_x_4*f_x_x_4 + D_p_x_4*t139 + D_p_y_4*f_y_x_4 + D_p_y_4*t145 + D_p_z_4*f_z_x_4
        + D_p_z_4*t151 + k_4_2 + k_4_3 - mu_4*(n_4_x*n_4_x) - mu_4*(n_4_y*n_4_y) - mu_4*(n_4_z*n_4_z);
    K[3][4] = K[4][3] =
        D_p_rx_4*f_rx_x_5 + D_p_rx_5*t157 + D_p_ry_4*f_ry_x_5 + D_p_ry_5*t259 + D_p_rz_4*f_rz_x_5
        + D_p_rz_5*t169 + D_p_x_4*f_x_x_5 + D_p_x_5*t139 + D_p_y_4*f_y_x_5 + D_p_y_5*t145 + D_p_z_4*f_z_x_5
        + D_p_z_5*t151;
    K[3][5] = K[5][3] =
        D_p_rx_4*f_rx_x_6 + D_p_rx_6*t157 + D_p_ry_4*f_ry_x_6 + D_p_ry_6*t259 + D_p_rz_4*f_rz_x_6
        + D_p_rz_6*t169 + D_p_x_4*f_x_x_6 + D_p_x_6*t139 + D_p_y_4*f_y_x_6 + D_p_y_6*t145 + D_p_z_4*f_z_x_6
        + D_p_z_6*t151;
    K[3][9] = K[9][3] = -R_p_4*k_4_3;
    K[3][15] = K[15][3] = -R_p_4*k_4_2;
    K[4][4] =
        D_p_rx_5*f_rx_x_5 + D_p_rx_5*t158 + D_p_ry_5*f_ry_x_5 + D_p_ry_5*t260 + D_p_rz_5*f_rz_x_5
        + D_p_rz_5*t170 + D_p_x_5*f_x_x_5 + D_p_x_5*t140 + D_p_y_5*f_y_x_5 + D_p_y_5*t146 + D_p_z_5*f_z_x_5
        + D_p_z_5*t152 + k_5_2 + k_5_3 - mu_5*(n_5_x*n_5_x) - mu_5*(n_5_y*n_5_y) - mu_5*(n_5_z*n_5_z);
    K[4][5] = K[5][4] =
        D_p_rx_5*f_rx_x_6 + D_p_rx_6*t158 + D_p_ry_5*f_ry_x_6 + D_p_ry_6*t260 + D_p_rz_5*f_rz_x_6
        + D_p_rz_6*t170 + D_p_x_5*f_x_x_6 + D_p_x_6*t140 + D_p_y_5*f_y_x_6 + D_p_y_6*t146 + D_p_z_5*f_z_x_6
        + D_p_z_6*t152;
    K[4][10] = K[10][4] = -R_p_5*k_5_3;
    K[4][16] = K[16][4] = -R_p_5*k_5_2;
    K[5][5] =
        D_p_rx_6*f_rx_x_6 + D_p_rx_6*t159 + D_p_ry_6*f_ry_x_6 + D_p_ry_6*(B_6_z*mu_6*n_6_x - t165)
        + D_p_rz_6*f_rz_x_6 + D_p_rz_6*t171 + D_p_x_6*f_x_x_6 + D_p_x_6*t141 + D_p_y_6*f_y_x_6 + D_p_y_6*t147
        + D_p_z_6*f_z_x_6 + D_p_z_6*t153 + k_6_2 + k_6_3 - mu_6*(n_6_x*n_6_x) - mu_6*(n_6_y*n_6_y)
        - mu_6*(n_6_z*n_6_z);
    K[5][11] = K[11][5] = -R_p_6*k_6_3;
    K[5][17] = K[17][5] = -R_p_6*k_6_2;
    K[6][6] = k_1_3*t261 + t262;
    K[6][12] = K[12][6] = -t262;
    K[7][7] = k_2_3*t263 + t264;
    K[7][13] = K[13][7] = -t264;
    K[8][8] = k_3_3*t265 + t266;
    K[8][14] = K[14][8] = -t266;
    K[9][9] = k_4_3*t267 + t268;
    K[9][15] = K[15][9] = -t268;
    K[10][10] = k_5_3*t269 + t270;
    K[10][16] = K[16][10] = -t270;
    K[11][11] = k_6_3*t271 + t272;
    K[11][17] = K[17][11] = -t272;
    K[12][12] = k_1_2*t261 + t262;
    K[13][13] = k_2_2*t263 + t264;
    K[14][14] = k_3_2*t265 + t266;
    K[15][15] = k_4_2*t267 + t268;
    K[16][16] = k_5_2*t269 + t270;
    K[17][17] = k_6_2*t271 + t272;
}

/* Coordinates, and the most iterations for one eigenvalue; two are usual. */
enum { N = HEXAGLIDE_COORDINATES, EIGEN_ITERATIONS = 60 };

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
int hexaglide_status(const pkmodes_real p[6], const hexaglide_parameters *parameters)
{
    int i;
    for (i = 0; i < HEXAGLIDE_POSE; ++i)
        if (!isfinite(p[i]))
            return HEXAGLIDE_NOT_FINITE;
    {
        pkmodes_real margin;
        hexaglide_rotation_margin(p, parameters, &margin);
        for (i = 0; i < 1; ++i)
            if (!(((const pkmodes_real *)&margin)[i] > 0))
                return HEXAGLIDE_BEYOND_ROTATION;
    }
    {
        pkmodes_real margin[6];
        hexaglide_reach_margin(p, parameters, margin);
        for (i = 0; i < 6; ++i)
            if (!(((const pkmodes_real *)margin)[i] >= 0))
                return HEXAGLIDE_BEYOND_REACHABLE;
    }
    {
        pkmodes_real determinant, condition;
        hexaglide_jacobian_condition(p, parameters, &determinant, &condition);
        for (i = 0; i < 1; ++i)
            if (!(((const pkmodes_real *)&condition)[i] <= HEXAGLIDE_MAX_CONDITION))
                return HEXAGLIDE_BEYOND_SINGULAR;
    }
    {
        pkmodes_real l_f[6][3];
        hexaglide_belt_spans(p, parameters, l_f);
        for (i = 0; i < 18; ++i)
            if (!(((const pkmodes_real *)l_f)[i] > 0))
                return HEXAGLIDE_BEYOND_LIMITS;
    }
    return 0;
}

int hexaglide_modes(
    const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real f[18], pkmodes_real phi[18][18])
{
    pkmodes_real M[N][N], K[N][N];
    const int status = hexaglide_status(p, parameters);
    if (status)
        return status;
    hexaglide_modal_matrices(p, parameters, M, K);
    if (eigen_solve(N, M, K, f, phi) || eigen_lost(N, f, HEXAGLIDE_RIGID_MODES))
        return HEXAGLIDE_UNSOLVED;
    eigen_frequencies(N, f);
    return 0;
}

int hexaglide_natural_frequencies(
    const pkmodes_real p[6], const hexaglide_parameters *parameters, pkmodes_real f[18])
{
    return hexaglide_modes(p, parameters, f, NULL);
}
