/* Generated from the derivation of hexapod.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism hexapod, for a robot given by its parameters.
 * The header describes every function.
 *
 * Names in the code.  Indices: leg j; coordinate k of a derivative; coordinate l of a second derivative;
 * component i = x, y, z; rows r of a minor; columns c of a minor; axis a of the platform.  t1, t2, ... are
 * subexpressions shared by several values.
 *   w_p_i [rad/s]: angular velocity of the platform, component i
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
 *   v_p_i [m/s]: velocity of the platform, component i
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
 *   U_j_i_k [1]: derivative of linkage vector j, component i, with respect to l_k
 *   f_j_kl [1]: right-hand side of closure j, differentiated with respect to l_k and l_l
 *   P_i_kl [1/m]: second derivative of p_i with respect to l_k and l_l
 *   P_i_kl [1/m^2]: second derivative of p_i with respect to l_k and l_l
 *   s_dot_j_i [m/s]: rate of change of linkage vector j, component i
 *   D_p_dot_i_k [1/s]: time derivative of dp_i/dl_k
 *   D_p_dot_i_k [1/(m s)]: time derivative of dp_i/dl_k
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
 *   G_j [N]: gradient of the gravitational potential energy with respect to l_j
 *   s_j_st [m]: static length that motor j commands, relative to the unstrained transmissions
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

#include "hexapod.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Numbers and functions of the C library: in single precision, R(0.5) is 0.5f and R(sqrt) is sqrtf. */
#ifdef PKMODES_FLOAT
#define R(name) name##f
#else
#define R(name) name
#endif

void hexapod_inverse_kinematics(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real l[6])
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
    l[0] = l_1;
    l[1] = l_2;
    l[2] = l_3;
    l[3] = l_4;
    l[4] = l_5;
    l[5] = l_6;
}

void hexapod_inertia_margin(const hexapod_parameters *parameters, pkmodes_real margin[7])
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

void hexapod_travel_margin(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real margin[6][2])
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
    const pkmodes_real l_min_1 = parameters->limits[0][0];
    const pkmodes_real l_max_1 = parameters->limits[0][1];
    const pkmodes_real l_min_2 = parameters->limits[1][0];
    const pkmodes_real l_max_2 = parameters->limits[1][1];
    const pkmodes_real l_min_3 = parameters->limits[2][0];
    const pkmodes_real l_max_3 = parameters->limits[2][1];
    const pkmodes_real l_min_4 = parameters->limits[3][0];
    const pkmodes_real l_max_4 = parameters->limits[3][1];
    const pkmodes_real l_min_5 = parameters->limits[4][0];
    const pkmodes_real l_max_5 = parameters->limits[4][1];
    const pkmodes_real l_min_6 = parameters->limits[5][0];
    const pkmodes_real l_max_6 = parameters->limits[5][1];
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
    margin[0][0] = l_1 - l_min_1;
    margin[0][1] = -l_1 + l_max_1;
    margin[1][0] = l_2 - l_min_2;
    margin[1][1] = -l_2 + l_max_2;
    margin[2][0] = l_3 - l_min_3;
    margin[2][1] = -l_3 + l_max_3;
    margin[3][0] = l_4 - l_min_4;
    margin[3][1] = -l_4 + l_max_4;
    margin[4][0] = l_5 - l_min_5;
    margin[4][1] = -l_5 + l_max_5;
    margin[5][0] = l_6 - l_min_6;
    margin[5][1] = -l_6 + l_max_6;
}

void hexapod_rotation_margin(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real *margin)
{
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    (void)parameters;
    *margin = -R(sqrt)((rot_x*rot_x) + (rot_y*rot_y) + (rot_z*rot_z)) + (R(1.0)/R(2.0))*R(3.141592653589793);
}

void hexapod_joint_line_margin(const hexapod_parameters *parameters, pkmodes_real *margin)
{
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
    const pkmodes_real t1 = (R(1.0)/R(6.0))*b_3_x;
    const pkmodes_real t2 = (R(1.0)/R(6.0))*b_5_x;
    const pkmodes_real t3 = (R(1.0)/R(6.0))*b_1_x;
    const pkmodes_real t4 = (R(1.0)/R(6.0))*b_2_x;
    const pkmodes_real t5 = (R(1.0)/R(6.0))*b_6_x;
    const pkmodes_real t6 = t2 + t3 + t4 + t5;
    const pkmodes_real t7 = (R(5.0)/R(6.0))*b_4_x - t1 - t6;
    const pkmodes_real t8 = (R(1.0)/R(6.0))*b_4_x;
    const pkmodes_real t9 = (R(5.0)/R(6.0))*b_3_x - t6 - t8;
    const pkmodes_real t10 = t1 + t2 + t5 + t8;
    const pkmodes_real t11 = (R(5.0)/R(6.0))*b_2_x - t10 - t3;
    const pkmodes_real t12 = (R(5.0)/R(6.0))*b_1_x - t10 - t4;
    const pkmodes_real t13 = t1 + t3 + t4 + t8;
    const pkmodes_real t14 = (R(5.0)/R(6.0))*b_6_x - t13 - t2;
    const pkmodes_real t15 = (R(5.0)/R(6.0))*b_5_x - t13 - t5;
    const pkmodes_real t16 = (t11*t11) + (t12*t12) + (t14*t14) + (t15*t15) + (t7*t7) + (t9*t9);
    const pkmodes_real t17 = (R(1.0)/R(6.0))*b_5_y;
    const pkmodes_real t18 = (R(1.0)/R(6.0))*b_1_y;
    const pkmodes_real t19 = (R(1.0)/R(6.0))*b_2_y;
    const pkmodes_real t20 = (R(1.0)/R(6.0))*b_3_y;
    const pkmodes_real t21 = (R(1.0)/R(6.0))*b_4_y;
    const pkmodes_real t22 = t18 + t19 + t20 + t21;
    const pkmodes_real t23 = (R(5.0)/R(6.0))*b_6_y - t17 - t22;
    const pkmodes_real t24 = (R(1.0)/R(6.0))*b_6_y;
    const pkmodes_real t25 = (R(5.0)/R(6.0))*b_5_y - t22 - t24;
    const pkmodes_real t26 = t17 + t18 + t19 + t24;
    const pkmodes_real t27 = (R(5.0)/R(6.0))*b_4_y - t20 - t26;
    const pkmodes_real t28 = (R(5.0)/R(6.0))*b_3_y - t21 - t26;
    const pkmodes_real t29 = t17 + t20 + t21 + t24;
    const pkmodes_real t30 = (R(5.0)/R(6.0))*b_2_y - t18 - t29;
    const pkmodes_real t31 = (R(5.0)/R(6.0))*b_1_y - t19 - t29;
    const pkmodes_real t32 = (t23*t23) + (t25*t25) + (t27*t27) + (t28*t28) + (t30*t30) + (t31*t31);
    const pkmodes_real t33 = (R(1.0)/R(6.0))*b_5_z;
    const pkmodes_real t34 = (R(1.0)/R(6.0))*b_1_z;
    const pkmodes_real t35 = (R(1.0)/R(6.0))*b_2_z;
    const pkmodes_real t36 = (R(1.0)/R(6.0))*b_3_z;
    const pkmodes_real t37 = (R(1.0)/R(6.0))*b_4_z;
    const pkmodes_real t38 = t34 + t35 + t36 + t37;
    const pkmodes_real t39 = (R(5.0)/R(6.0))*b_6_z - t33 - t38;
    const pkmodes_real t40 = (R(1.0)/R(6.0))*b_6_z;
    const pkmodes_real t41 = (R(5.0)/R(6.0))*b_5_z - t38 - t40;
    const pkmodes_real t42 = t33 + t34 + t35 + t40;
    const pkmodes_real t43 = (R(5.0)/R(6.0))*b_4_z - t36 - t42;
    const pkmodes_real t44 = (R(5.0)/R(6.0))*b_3_z - t37 - t42;
    const pkmodes_real t45 = t33 + t36 + t37 + t40;
    const pkmodes_real t46 = (R(5.0)/R(6.0))*b_2_z - t34 - t45;
    const pkmodes_real t47 = (R(5.0)/R(6.0))*b_1_z - t35 - t45;
    const pkmodes_real t48 = (t39*t39) + (t41*t41) + (t43*t43) + (t44*t44) + (t46*t46) + (t47*t47);
    *margin =
        -R(1.0)/R(2.0)*(t16*t16) - R(1.0)/R(2.0)*(t32*t32) - R(1.0)/R(2.0)*(t48*t48) + R(0.499999)*((t16
        + t32 + t48)*(t16 + t32 + t48)) - ((t11*t30 + t12*t31 + t14*t23 + t15*t25 + t27*t7 + t28*t9)*(t11*t30
        + t12*t31 + t14*t23 + t15*t25 + t27*t7 + t28*t9)) - ((t11*t46 + t12*t47 + t14*t39 + t15*t41 + t43*t7
        + t44*t9)*(t11*t46 + t12*t47 + t14*t39 + t15*t41 + t43*t7 + t44*t9)) - ((t23*t39 + t25*t41 + t27*t43
        + t28*t44 + t30*t46 + t31*t47)*(t23*t39 + t25*t41 + t27*t43 + t28*t44 + t30*t46 + t31*t47));
}

void hexapod_base_line_margin(const hexapod_parameters *parameters, pkmodes_real *margin)
{
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
    const pkmodes_real t1 = (R(1.0)/R(6.0))*a_3_x;
    const pkmodes_real t2 = (R(1.0)/R(6.0))*a_5_x;
    const pkmodes_real t3 = (R(1.0)/R(6.0))*a_1_x;
    const pkmodes_real t4 = (R(1.0)/R(6.0))*a_2_x;
    const pkmodes_real t5 = (R(1.0)/R(6.0))*a_6_x;
    const pkmodes_real t6 = t2 + t3 + t4 + t5;
    const pkmodes_real t7 = (R(5.0)/R(6.0))*a_4_x - t1 - t6;
    const pkmodes_real t8 = (R(1.0)/R(6.0))*a_4_x;
    const pkmodes_real t9 = (R(5.0)/R(6.0))*a_3_x - t6 - t8;
    const pkmodes_real t10 = t1 + t2 + t5 + t8;
    const pkmodes_real t11 = (R(5.0)/R(6.0))*a_2_x - t10 - t3;
    const pkmodes_real t12 = (R(5.0)/R(6.0))*a_1_x - t10 - t4;
    const pkmodes_real t13 = t1 + t3 + t4 + t8;
    const pkmodes_real t14 = (R(5.0)/R(6.0))*a_6_x - t13 - t2;
    const pkmodes_real t15 = (R(5.0)/R(6.0))*a_5_x - t13 - t5;
    const pkmodes_real t16 = (t11*t11) + (t12*t12) + (t14*t14) + (t15*t15) + (t7*t7) + (t9*t9);
    const pkmodes_real t17 = (R(1.0)/R(6.0))*a_5_y;
    const pkmodes_real t18 = (R(1.0)/R(6.0))*a_1_y;
    const pkmodes_real t19 = (R(1.0)/R(6.0))*a_2_y;
    const pkmodes_real t20 = (R(1.0)/R(6.0))*a_3_y;
    const pkmodes_real t21 = (R(1.0)/R(6.0))*a_4_y;
    const pkmodes_real t22 = t18 + t19 + t20 + t21;
    const pkmodes_real t23 = (R(5.0)/R(6.0))*a_6_y - t17 - t22;
    const pkmodes_real t24 = (R(1.0)/R(6.0))*a_6_y;
    const pkmodes_real t25 = (R(5.0)/R(6.0))*a_5_y - t22 - t24;
    const pkmodes_real t26 = t17 + t18 + t19 + t24;
    const pkmodes_real t27 = (R(5.0)/R(6.0))*a_4_y - t20 - t26;
    const pkmodes_real t28 = (R(5.0)/R(6.0))*a_3_y - t21 - t26;
    const pkmodes_real t29 = t17 + t20 + t21 + t24;
    const pkmodes_real t30 = (R(5.0)/R(6.0))*a_2_y - t18 - t29;
    const pkmodes_real t31 = (R(5.0)/R(6.0))*a_1_y - t19 - t29;
    const pkmodes_real t32 = (t23*t23) + (t25*t25) + (t27*t27) + (t28*t28) + (t30*t30) + (t31*t31);
    const pkmodes_real t33 = (R(1.0)/R(6.0))*a_5_z;
    const pkmodes_real t34 = (R(1.0)/R(6.0))*a_1_z;
    const pkmodes_real t35 = (R(1.0)/R(6.0))*a_2_z;
    const pkmodes_real t36 = (R(1.0)/R(6.0))*a_3_z;
    const pkmodes_real t37 = (R(1.0)/R(6.0))*a_4_z;
    const pkmodes_real t38 = t34 + t35 + t36 + t37;
    const pkmodes_real t39 = (R(5.0)/R(6.0))*a_6_z - t33 - t38;
    const pkmodes_real t40 = (R(1.0)/R(6.0))*a_6_z;
    const pkmodes_real t41 = (R(5.0)/R(6.0))*a_5_z - t38 - t40;
    const pkmodes_real t42 = t33 + t34 + t35 + t40;
    const pkmodes_real t43 = (R(5.0)/R(6.0))*a_4_z - t36 - t42;
    const pkmodes_real t44 = (R(5.0)/R(6.0))*a_3_z - t37 - t42;
    const pkmodes_real t45 = t33 + t36 + t37 + t40;
    const pkmodes_real t46 = (R(5.0)/R(6.0))*a_2_z - t34 - t45;
    const pkmodes_real t47 = (R(5.0)/R(6.0))*a_1_z - t35 - t45;
    const pkmodes_real t48 = (t39*t39) + (t41*t41) + (t43*t43) + (t44*t44) + (t46*t46) + (t47*t47);
    *margin =
        -R(1.0)/R(2.0)*(t16*t16) - R(1.0)/R(2.0)*(t32*t32) - R(1.0)/R(2.0)*(t48*t48) + R(0.499999)*((t16
        + t32 + t48)*(t16 + t32 + t48)) - ((t11*t30 + t12*t31 + t14*t23 + t15*t25 + t27*t7 + t28*t9)*(t11*t30
        + t12*t31 + t14*t23 + t15*t25 + t27*t7 + t28*t9)) - ((t11*t46 + t12*t47 + t14*t39 + t15*t41 + t43*t7
        + t44*t9)*(t11*t46 + t12*t47 + t14*t39 + t15*t41 + t43*t7 + t44*t9)) - ((t23*t39 + t25*t41 + t27*t43
        + t28*t44 + t30*t46 + t31*t47)*(t23*t39 + t25*t41 + t27*t43 + t28*t44 + t30*t46 + t31*t47));
}

void hexapod_leg_margin(const hexapod_parameters *parameters, pkmodes_real margin[15])
{
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
    const pkmodes_real t1 =
        R(1.6666666666666667e-11)*(b_1_x*b_1_x) + R(1.6666666666666667e-11)*(b_1_y*b_1_y)
        + R(1.6666666666666667e-11)*(b_1_z*b_1_z) + R(1.6666666666666667e-11)*(b_2_x*b_2_x)
        + R(1.6666666666666667e-11)*(b_2_y*b_2_y) + R(1.6666666666666667e-11)*(b_2_z*b_2_z)
        + R(1.6666666666666667e-11)*(b_3_x*b_3_x) + R(1.6666666666666667e-11)*(b_3_y*b_3_y)
        + R(1.6666666666666667e-11)*(b_3_z*b_3_z) + R(1.6666666666666667e-11)*(b_4_x*b_4_x)
        + R(1.6666666666666667e-11)*(b_4_y*b_4_y) + R(1.6666666666666667e-11)*(b_4_z*b_4_z)
        + R(1.6666666666666667e-11)*(b_5_x*b_5_x) + R(1.6666666666666667e-11)*(b_5_y*b_5_y)
        + R(1.6666666666666667e-11)*(b_5_z*b_5_z) + R(1.6666666666666667e-11)*(b_6_x*b_6_x)
        + R(1.6666666666666667e-11)*(b_6_y*b_6_y) + R(1.6666666666666667e-11)*(b_6_z*b_6_z);
    margin[0] =
        -t1 + ((a_1_x - a_2_x)*(a_1_x - a_2_x)) + ((a_1_y - a_2_y)*(a_1_y - a_2_y)) + ((a_1_z - a_2_z)*(a_1_z
        - a_2_z)) + ((b_1_x - b_2_x)*(b_1_x - b_2_x)) + ((b_1_y - b_2_y)*(b_1_y - b_2_y)) + ((b_1_z
        - b_2_z)*(b_1_z - b_2_z));
    margin[1] =
        -t1 + ((a_1_x - a_3_x)*(a_1_x - a_3_x)) + ((a_1_y - a_3_y)*(a_1_y - a_3_y)) + ((a_1_z - a_3_z)*(a_1_z
        - a_3_z)) + ((b_1_x - b_3_x)*(b_1_x - b_3_x)) + ((b_1_y - b_3_y)*(b_1_y - b_3_y)) + ((b_1_z
        - b_3_z)*(b_1_z - b_3_z));
    margin[2] =
        -t1 + ((a_1_x - a_4_x)*(a_1_x - a_4_x)) + ((a_1_y - a_4_y)*(a_1_y - a_4_y)) + ((a_1_z - a_4_z)*(a_1_z
        - a_4_z)) + ((b_1_x - b_4_x)*(b_1_x - b_4_x)) + ((b_1_y - b_4_y)*(b_1_y - b_4_y)) + ((b_1_z
        - b_4_z)*(b_1_z - b_4_z));
    margin[3] =
        -t1 + ((a_1_x - a_5_x)*(a_1_x - a_5_x)) + ((a_1_y - a_5_y)*(a_1_y - a_5_y)) + ((a_1_z - a_5_z)*(a_1_z
        - a_5_z)) + ((b_1_x - b_5_x)*(b_1_x - b_5_x)) + ((b_1_y - b_5_y)*(b_1_y - b_5_y)) + ((b_1_z
        - b_5_z)*(b_1_z - b_5_z));
    margin[4] =
        -t1 + ((a_1_x - a_6_x)*(a_1_x - a_6_x)) + ((a_1_y - a_6_y)*(a_1_y - a_6_y)) + ((a_1_z - a_6_z)*(a_1_z
        - a_6_z)) + ((b_1_x - b_6_x)*(b_1_x - b_6_x)) + ((b_1_y - b_6_y)*(b_1_y - b_6_y)) + ((b_1_z
        - b_6_z)*(b_1_z - b_6_z));
    margin[5] =
        -t1 + ((a_2_x - a_3_x)*(a_2_x - a_3_x)) + ((a_2_y - a_3_y)*(a_2_y - a_3_y)) + ((a_2_z - a_3_z)*(a_2_z
        - a_3_z)) + ((b_2_x - b_3_x)*(b_2_x - b_3_x)) + ((b_2_y - b_3_y)*(b_2_y - b_3_y)) + ((b_2_z
        - b_3_z)*(b_2_z - b_3_z));
    margin[6] =
        -t1 + ((a_2_x - a_4_x)*(a_2_x - a_4_x)) + ((a_2_y - a_4_y)*(a_2_y - a_4_y)) + ((a_2_z - a_4_z)*(a_2_z
        - a_4_z)) + ((b_2_x - b_4_x)*(b_2_x - b_4_x)) + ((b_2_y - b_4_y)*(b_2_y - b_4_y)) + ((b_2_z
        - b_4_z)*(b_2_z - b_4_z));
    margin[7] =
        -t1 + ((a_2_x - a_5_x)*(a_2_x - a_5_x)) + ((a_2_y - a_5_y)*(a_2_y - a_5_y)) + ((a_2_z - a_5_z)*(a_2_z
        - a_5_z)) + ((b_2_x - b_5_x)*(b_2_x - b_5_x)) + ((b_2_y - b_5_y)*(b_2_y - b_5_y)) + ((b_2_z
        - b_5_z)*(b_2_z - b_5_z));
    margin[8] =
        -t1 + ((a_2_x - a_6_x)*(a_2_x - a_6_x)) + ((a_2_y - a_6_y)*(a_2_y - a_6_y)) + ((a_2_z - a_6_z)*(a_2_z
        - a_6_z)) + ((b_2_x - b_6_x)*(b_2_x - b_6_x)) + ((b_2_y - b_6_y)*(b_2_y - b_6_y)) + ((b_2_z
        - b_6_z)*(b_2_z - b_6_z));
    margin[9] =
        -t1 + ((a_3_x - a_4_x)*(a_3_x - a_4_x)) + ((a_3_y - a_4_y)*(a_3_y - a_4_y)) + ((a_3_z - a_4_z)*(a_3_z
        - a_4_z)) + ((b_3_x - b_4_x)*(b_3_x - b_4_x)) + ((b_3_y - b_4_y)*(b_3_y - b_4_y)) + ((b_3_z
        - b_4_z)*(b_3_z - b_4_z));
    margin[10] =
        -t1 + ((a_3_x - a_5_x)*(a_3_x - a_5_x)) + ((a_3_y - a_5_y)*(a_3_y - a_5_y)) + ((a_3_z - a_5_z)*(a_3_z
        - a_5_z)) + ((b_3_x - b_5_x)*(b_3_x - b_5_x)) + ((b_3_y - b_5_y)*(b_3_y - b_5_y)) + ((b_3_z
        - b_5_z)*(b_3_z - b_5_z));
    margin[11] =
        -t1 + ((a_3_x - a_6_x)*(a_3_x - a_6_x)) + ((a_3_y - a_6_y)*(a_3_y - a_6_y)) + ((a_3_z - a_6_z)*(a_3_z
        - a_6_z)) + ((b_3_x - b_6_x)*(b_3_x - b_6_x)) + ((b_3_y - b_6_y)*(b_3_y - b_6_y)) + ((b_3_z
        - b_6_z)*(b_3_z - b_6_z));
    margin[12] =
        -t1 + ((a_4_x - a_5_x)*(a_4_x - a_5_x)) + ((a_4_y - a_5_y)*(a_4_y - a_5_y)) + ((a_4_z - a_5_z)*(a_4_z
        - a_5_z)) + ((b_4_x - b_5_x)*(b_4_x - b_5_x)) + ((b_4_y - b_5_y)*(b_4_y - b_5_y)) + ((b_4_z
        - b_5_z)*(b_4_z - b_5_z));
    margin[13] =
        -t1 + ((a_4_x - a_6_x)*(a_4_x - a_6_x)) + ((a_4_y - a_6_y)*(a_4_y - a_6_y)) + ((a_4_z - a_6_z)*(a_4_z
        - a_6_z)) + ((b_4_x - b_6_x)*(b_4_x - b_6_x)) + ((b_4_y - b_6_y)*(b_4_y - b_6_y)) + ((b_4_z
        - b_6_z)*(b_4_z - b_6_z));
    margin[14] =
        -t1 + ((a_5_x - a_6_x)*(a_5_x - a_6_x)) + ((a_5_y - a_6_y)*(a_5_y - a_6_y)) + ((a_5_z - a_6_z)*(a_5_z
        - a_6_z)) + ((b_5_x - b_6_x)*(b_5_x - b_6_x)) + ((b_5_y - b_6_y)*(b_5_y - b_6_y)) + ((b_5_z
        - b_6_z)*(b_5_z - b_6_z));
}

void hexapod_crossing_margin(const hexapod_parameters *parameters, pkmodes_real margin[15])
{
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
    const pkmodes_real t1 = a_1_x - a_2_x;
    const pkmodes_real t2 = b_1_x - b_2_x;
    const pkmodes_real t3 = a_1_y - a_2_y;
    const pkmodes_real t4 = b_1_y - b_2_y;
    const pkmodes_real t5 = a_1_z - a_2_z;
    const pkmodes_real t6 = b_1_z - b_2_z;
    const pkmodes_real t7 =
        R(1.6666666666666667e-11)*(b_1_x*b_1_x) + R(1.6666666666666667e-11)*(b_1_y*b_1_y)
        + R(1.6666666666666667e-11)*(b_1_z*b_1_z) + R(1.6666666666666667e-11)*(b_2_x*b_2_x)
        + R(1.6666666666666667e-11)*(b_2_y*b_2_y) + R(1.6666666666666667e-11)*(b_2_z*b_2_z)
        + R(1.6666666666666667e-11)*(b_3_x*b_3_x) + R(1.6666666666666667e-11)*(b_3_y*b_3_y)
        + R(1.6666666666666667e-11)*(b_3_z*b_3_z) + R(1.6666666666666667e-11)*(b_4_x*b_4_x)
        + R(1.6666666666666667e-11)*(b_4_y*b_4_y) + R(1.6666666666666667e-11)*(b_4_z*b_4_z)
        + R(1.6666666666666667e-11)*(b_5_x*b_5_x) + R(1.6666666666666667e-11)*(b_5_y*b_5_y)
        + R(1.6666666666666667e-11)*(b_5_z*b_5_z) + R(1.6666666666666667e-11)*(b_6_x*b_6_x)
        + R(1.6666666666666667e-11)*(b_6_y*b_6_y) + R(1.6666666666666667e-11)*(b_6_z*b_6_z);
    const pkmodes_real t8 = b_1_x - b_3_x;
    const pkmodes_real t9 = a_1_y - a_3_y;
    const pkmodes_real t10 = b_1_y - b_3_y;
    const pkmodes_real t11 = a_1_z - a_3_z;
    const pkmodes_real t12 = b_1_z - b_3_z;
    const pkmodes_real t13 = a_1_x - a_3_x;
    const pkmodes_real t14 = a_1_x - a_4_x;
    const pkmodes_real t15 = b_1_x - b_4_x;
    const pkmodes_real t16 = a_1_y - a_4_y;
    const pkmodes_real t17 = b_1_y - b_4_y;
    const pkmodes_real t18 = a_1_z - a_4_z;
    const pkmodes_real t19 = b_1_z - b_4_z;
    const pkmodes_real t20 = a_1_x - a_5_x;
    const pkmodes_real t21 = b_1_x - b_5_x;
    const pkmodes_real t22 = a_1_y - a_5_y;
    const pkmodes_real t23 = b_1_y - b_5_y;
    const pkmodes_real t24 = a_1_z - a_5_z;
    const pkmodes_real t25 = b_1_z - b_5_z;
    const pkmodes_real t26 = a_1_x - a_6_x;
    const pkmodes_real t27 = b_1_x - b_6_x;
    const pkmodes_real t28 = a_1_y - a_6_y;
    const pkmodes_real t29 = b_1_y - b_6_y;
    const pkmodes_real t30 = a_1_z - a_6_z;
    const pkmodes_real t31 = b_1_z - b_6_z;
    const pkmodes_real t32 = a_2_x - a_3_x;
    const pkmodes_real t33 = b_2_x - b_3_x;
    const pkmodes_real t34 = a_2_y - a_3_y;
    const pkmodes_real t35 = b_2_y - b_3_y;
    const pkmodes_real t36 = a_2_z - a_3_z;
    const pkmodes_real t37 = b_2_z - b_3_z;
    const pkmodes_real t38 = a_2_x - a_4_x;
    const pkmodes_real t39 = b_2_x - b_4_x;
    const pkmodes_real t40 = a_2_y - a_4_y;
    const pkmodes_real t41 = b_2_y - b_4_y;
    const pkmodes_real t42 = a_2_z - a_4_z;
    const pkmodes_real t43 = b_2_z - b_4_z;
    const pkmodes_real t44 = a_2_x - a_5_x;
    const pkmodes_real t45 = b_2_x - b_5_x;
    const pkmodes_real t46 = a_2_y - a_5_y;
    const pkmodes_real t47 = b_2_y - b_5_y;
    const pkmodes_real t48 = a_2_z - a_5_z;
    const pkmodes_real t49 = b_2_z - b_5_z;
    const pkmodes_real t50 = a_2_x - a_6_x;
    const pkmodes_real t51 = b_2_x - b_6_x;
    const pkmodes_real t52 = a_2_y - a_6_y;
    const pkmodes_real t53 = b_2_y - b_6_y;
    const pkmodes_real t54 = a_2_z - a_6_z;
    const pkmodes_real t55 = b_2_z - b_6_z;
    const pkmodes_real t56 = a_3_x - a_4_x;
    const pkmodes_real t57 = b_3_x - b_4_x;
    const pkmodes_real t58 = a_3_y - a_4_y;
    const pkmodes_real t59 = b_3_y - b_4_y;
    const pkmodes_real t60 = a_3_z - a_4_z;
    const pkmodes_real t61 = b_3_z - b_4_z;
    const pkmodes_real t62 = a_3_x - a_5_x;
    const pkmodes_real t63 = b_3_x - b_5_x;
    const pkmodes_real t64 = a_3_y - a_5_y;
    const pkmodes_real t65 = b_3_y - b_5_y;
    const pkmodes_real t66 = a_3_z - a_5_z;
    const pkmodes_real t67 = b_3_z - b_5_z;
    const pkmodes_real t68 = a_3_x - a_6_x;
    const pkmodes_real t69 = b_3_x - b_6_x;
    const pkmodes_real t70 = a_3_y - a_6_y;
    const pkmodes_real t71 = b_3_y - b_6_y;
    const pkmodes_real t72 = a_3_z - a_6_z;
    const pkmodes_real t73 = b_3_z - b_6_z;
    const pkmodes_real t74 = b_4_y - b_5_y;
    const pkmodes_real t75 = a_4_z - a_5_z;
    const pkmodes_real t76 = b_4_z - b_5_z;
    const pkmodes_real t77 = a_4_x - a_5_x;
    const pkmodes_real t78 = b_4_x - b_5_x;
    const pkmodes_real t79 = a_4_y - a_5_y;
    const pkmodes_real t80 = a_4_x - a_6_x;
    const pkmodes_real t81 = b_4_x - b_6_x;
    const pkmodes_real t82 = a_4_y - a_6_y;
    const pkmodes_real t83 = b_4_y - b_6_y;
    const pkmodes_real t84 = a_4_z - a_6_z;
    const pkmodes_real t85 = b_4_z - b_6_z;
    const pkmodes_real t86 = a_5_x - a_6_x;
    const pkmodes_real t87 = b_5_x - b_6_x;
    const pkmodes_real t88 = a_5_y - a_6_y;
    const pkmodes_real t89 = b_5_y - b_6_y;
    const pkmodes_real t90 = a_5_z - a_6_z;
    const pkmodes_real t91 = b_5_z - b_6_z;
    margin[0] =
        t1*t2 + t3*t4 + t5*t6 + t7 + R(0.9999995)*R(sqrt)((t1*t1) + (t3*t3) + (t5*t5))*R(sqrt)((t2*t2)
        + (t4*t4) + (t6*t6));
    margin[1] =
        t10*t9 + t11*t12 + t13*t8 + t7 + R(0.9999995)*R(sqrt)((t10*t10) + (t12*t12)
        + (t8*t8))*R(sqrt)((t11*t11) + (t13*t13) + (t9*t9));
    margin[2] =
        t14*t15 + t16*t17 + t18*t19 + t7 + R(0.9999995)*R(sqrt)((t14*t14) + (t16*t16)
        + (t18*t18))*R(sqrt)((t15*t15) + (t17*t17) + (t19*t19));
    margin[3] =
        t20*t21 + t22*t23 + t24*t25 + t7 + R(0.9999995)*R(sqrt)((t20*t20) + (t22*t22)
        + (t24*t24))*R(sqrt)((t21*t21) + (t23*t23) + (t25*t25));
    margin[4] =
        t26*t27 + t28*t29 + t30*t31 + t7 + R(0.9999995)*R(sqrt)((t26*t26) + (t28*t28)
        + (t30*t30))*R(sqrt)((t27*t27) + (t29*t29) + (t31*t31));
    margin[5] =
        t32*t33 + t34*t35 + t36*t37 + t7 + R(0.9999995)*R(sqrt)((t32*t32) + (t34*t34)
        + (t36*t36))*R(sqrt)((t33*t33) + (t35*t35) + (t37*t37));
    margin[6] =
        t38*t39 + t40*t41 + t42*t43 + t7 + R(0.9999995)*R(sqrt)((t38*t38) + (t40*t40)
        + (t42*t42))*R(sqrt)((t39*t39) + (t41*t41) + (t43*t43));
    margin[7] =
        t44*t45 + t46*t47 + t48*t49 + t7 + R(0.9999995)*R(sqrt)((t44*t44) + (t46*t46)
        + (t48*t48))*R(sqrt)((t45*t45) + (t47*t47) + (t49*t49));
    margin[8] =
        t50*t51 + t52*t53 + t54*t55 + t7 + R(0.9999995)*R(sqrt)((t50*t50) + (t52*t52)
        + (t54*t54))*R(sqrt)((t51*t51) + (t53*t53) + (t55*t55));
    margin[9] =
        t56*t57 + t58*t59 + t60*t61 + t7 + R(0.9999995)*R(sqrt)((t56*t56) + (t58*t58)
        + (t60*t60))*R(sqrt)((t57*t57) + (t59*t59) + (t61*t61));
    margin[10] =
        t62*t63 + t64*t65 + t66*t67 + t7 + R(0.9999995)*R(sqrt)((t62*t62) + (t64*t64)
        + (t66*t66))*R(sqrt)((t63*t63) + (t65*t65) + (t67*t67));
    margin[11] =
        t68*t69 + t7 + t70*t71 + t72*t73 + R(0.9999995)*R(sqrt)((t68*t68) + (t70*t70)
        + (t72*t72))*R(sqrt)((t69*t69) + (t71*t71) + (t73*t73));
    margin[12] =
        t7 + t74*t79 + t75*t76 + t77*t78 + R(0.9999995)*R(sqrt)((t74*t74) + (t76*t76)
        + (t78*t78))*R(sqrt)((t75*t75) + (t77*t77) + (t79*t79));
    margin[13] =
        t7 + t80*t81 + t82*t83 + t84*t85 + R(0.9999995)*R(sqrt)((t80*t80) + (t82*t82)
        + (t84*t84))*R(sqrt)((t81*t81) + (t83*t83) + (t85*t85));
    margin[14] =
        t7 + t86*t87 + t88*t89 + t90*t91 + R(0.9999995)*R(sqrt)((t86*t86) + (t88*t88)
        + (t90*t90))*R(sqrt)((t87*t87) + (t89*t89) + (t91*t91));
}

void hexapod_platform_joints(const hexapod_parameters *parameters, pkmodes_real *length,
    pkmodes_real middle[3])
{
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
    *length =
        R(sqrt)((R(1.0)/R(6.0))*(b_1_x*b_1_x) + (R(1.0)/R(6.0))*(b_1_y*b_1_y) + (R(1.0)/R(6.0))*(b_1_z*b_1_z)
        + (R(1.0)/R(6.0))*(b_2_x*b_2_x) + (R(1.0)/R(6.0))*(b_2_y*b_2_y) + (R(1.0)/R(6.0))*(b_2_z*b_2_z)
        + (R(1.0)/R(6.0))*(b_3_x*b_3_x) + (R(1.0)/R(6.0))*(b_3_y*b_3_y) + (R(1.0)/R(6.0))*(b_3_z*b_3_z)
        + (R(1.0)/R(6.0))*(b_4_x*b_4_x) + (R(1.0)/R(6.0))*(b_4_y*b_4_y) + (R(1.0)/R(6.0))*(b_4_z*b_4_z)
        + (R(1.0)/R(6.0))*(b_5_x*b_5_x) + (R(1.0)/R(6.0))*(b_5_y*b_5_y) + (R(1.0)/R(6.0))*(b_5_z*b_5_z)
        + (R(1.0)/R(6.0))*(b_6_x*b_6_x) + (R(1.0)/R(6.0))*(b_6_y*b_6_y) + (R(1.0)/R(6.0))*(b_6_z*b_6_z));
    middle[0] =
        (R(1.0)/R(6.0))*b_1_x + (R(1.0)/R(6.0))*b_2_x + (R(1.0)/R(6.0))*b_3_x + (R(1.0)/R(6.0))*b_4_x
        + (R(1.0)/R(6.0))*b_5_x + (R(1.0)/R(6.0))*b_6_x;
    middle[1] =
        (R(1.0)/R(6.0))*b_1_y + (R(1.0)/R(6.0))*b_2_y + (R(1.0)/R(6.0))*b_3_y + (R(1.0)/R(6.0))*b_4_y
        + (R(1.0)/R(6.0))*b_5_y + (R(1.0)/R(6.0))*b_6_y;
    middle[2] =
        (R(1.0)/R(6.0))*b_1_z + (R(1.0)/R(6.0))*b_2_z + (R(1.0)/R(6.0))*b_3_z + (R(1.0)/R(6.0))*b_4_z
        + (R(1.0)/R(6.0))*b_5_z + (R(1.0)/R(6.0))*b_6_z;
}

void hexapod_constraint_jacobians(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real D_l[6][6], pkmodes_real D_r[6][6])
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
    D_l[0][0] = d_1_x;
    D_l[0][1] = d_1_y;
    D_l[0][2] = d_1_z;
    D_l[0][3] = D_l_1_rx;
    D_l[0][4] = D_l_1_ry;
    D_l[0][5] = D_l_1_rz;
    D_l[1][0] = d_2_x;
    D_l[1][1] = d_2_y;
    D_l[1][2] = d_2_z;
    D_l[1][3] = D_l_2_rx;
    D_l[1][4] = D_l_2_ry;
    D_l[1][5] = D_l_2_rz;
    D_l[2][0] = d_3_x;
    D_l[2][1] = d_3_y;
    D_l[2][2] = d_3_z;
    D_l[2][3] = D_l_3_rx;
    D_l[2][4] = D_l_3_ry;
    D_l[2][5] = D_l_3_rz;
    D_l[3][0] = d_4_x;
    D_l[3][1] = d_4_y;
    D_l[3][2] = d_4_z;
    D_l[3][3] = D_l_4_rx;
    D_l[3][4] = D_l_4_ry;
    D_l[3][5] = D_l_4_rz;
    D_l[4][0] = d_5_x;
    D_l[4][1] = d_5_y;
    D_l[4][2] = d_5_z;
    D_l[4][3] = D_l_5_rx;
    D_l[4][4] = D_l_5_ry;
    D_l[4][5] = D_l_5_rz;
    D_l[5][0] = d_6_x;
    D_l[5][1] = d_6_y;
    D_l[5][2] = d_6_z;
    D_l[5][3] = D_l_6_rx;
    D_l[5][4] = D_l_6_ry;
    D_l[5][5] = D_l_6_rz;
    memset(D_r, 0, sizeof(pkmodes_real[6][6]));
    D_r[0][0] = l_1;
    D_r[1][1] = l_2;
    D_r[2][2] = l_3;
    D_r[3][3] = l_4;
    D_r[4][4] = l_5;
    D_r[5][5] = l_6;
}

void hexapod_jacobian_condition(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real *determinant, pkmodes_real *condition)
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
        + (D_l_6_rx*D_l_6_rx)*t13 + (D_l_6_ry*D_l_6_ry)*t13 + (D_l_6_rz*D_l_6_rz)*t13 + (d_1_x*d_1_x)
        + (d_1_y*d_1_y) + (d_1_z*d_1_z) + (d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z) + (d_3_x*d_3_x)
        + (d_3_y*d_3_y) + (d_3_z*d_3_z) + (d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z) + (d_5_x*d_5_x)
        + (d_5_y*d_5_y) + (d_5_z*d_5_z) + (d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z)));
}

void hexapod_platform_jacobian(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real D_p[6][6])
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

void hexapod_platform_jacobian_rate(const pkmodes_real p[6], const pkmodes_real l_dot[6],
    const hexapod_parameters *parameters, pkmodes_real D_p_dot[6][6])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real l_1_dot = l_dot[0];
    const pkmodes_real l_2_dot = l_dot[1];
    const pkmodes_real l_3_dot = l_dot[2];
    const pkmodes_real l_4_dot = l_dot[3];
    const pkmodes_real l_5_dot = l_dot[4];
    const pkmodes_real l_6_dot = l_dot[5];
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
    const pkmodes_real t19 = B_1_y*D_p_rz_1;
    const pkmodes_real U_1_x_1 = B_1_z*D_p_ry_1 + D_p_x_1 - t19;
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
    const pkmodes_real U_1_y_1 = D_p_y_1 + t25;
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
    const pkmodes_real t31 = B_1_x*D_p_ry_1;
    const pkmodes_real U_1_z_1 = B_1_y*D_p_rx_1 + D_p_z_1 - t31;
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
    const pkmodes_real t38 = B_2_y*D_p_rz_2;
    const pkmodes_real U_2_x_2 = B_2_z*D_p_ry_2 + D_p_x_2 - t38;
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
    const pkmodes_real U_2_y_2 = D_p_y_2 + t44;
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
    const pkmodes_real t50 = B_2_x*D_p_ry_2;
    const pkmodes_real U_2_z_2 = B_2_y*D_p_rx_2 + D_p_z_2 - t50;
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
    const pkmodes_real t57 = B_3_y*D_p_rz_3;
    const pkmodes_real U_3_x_3 = B_3_z*D_p_ry_3 + D_p_x_3 - t57;
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
    const pkmodes_real U_3_y_3 = D_p_y_3 + t63;
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
    const pkmodes_real t69 = B_3_x*D_p_ry_3;
    const pkmodes_real U_3_z_3 = B_3_y*D_p_rx_3 + D_p_z_3 - t69;
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
    const pkmodes_real t76 = B_4_y*D_p_rz_4;
    const pkmodes_real U_4_x_4 = B_4_z*D_p_ry_4 + D_p_x_4 - t76;
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
    const pkmodes_real U_4_y_4 = D_p_y_4 + t82;
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
    const pkmodes_real t88 = B_4_x*D_p_ry_4;
    const pkmodes_real U_4_z_4 = B_4_y*D_p_rx_4 + D_p_z_4 - t88;
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
    const pkmodes_real t95 = B_5_y*D_p_rz_5;
    const pkmodes_real U_5_x_5 = B_5_z*D_p_ry_5 + D_p_x_5 - t95;
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
    const pkmodes_real U_5_y_5 = D_p_y_5 + t101;
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
    const pkmodes_real t107 = B_5_x*D_p_ry_5;
    const pkmodes_real U_5_z_5 = B_5_y*D_p_rx_5 + D_p_z_5 - t107;
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
    const pkmodes_real t114 = B_6_y*D_p_rz_6;
    const pkmodes_real U_6_x_6 = B_6_z*D_p_ry_6 + D_p_x_6 - t114;
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
    const pkmodes_real U_6_y_6 = D_p_y_6 + t120;
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
    const pkmodes_real t126 = B_6_x*D_p_ry_6;
    const pkmodes_real U_6_z_6 = B_6_y*D_p_rx_6 + D_p_z_6 - t126;
    const pkmodes_real s_dot_1_x =
        U_1_x_1*l_1_dot + U_1_x_2*l_2_dot + U_1_x_3*l_3_dot + U_1_x_4*l_4_dot + U_1_x_5*l_5_dot
        + U_1_x_6*l_6_dot;
    const pkmodes_real s_dot_1_y =
        U_1_y_1*l_1_dot + U_1_y_2*l_2_dot + U_1_y_3*l_3_dot + U_1_y_4*l_4_dot + U_1_y_5*l_5_dot
        + U_1_y_6*l_6_dot;
    const pkmodes_real s_dot_1_z =
        U_1_z_1*l_1_dot + U_1_z_2*l_2_dot + U_1_z_3*l_3_dot + U_1_z_4*l_4_dot + U_1_z_5*l_5_dot
        + U_1_z_6*l_6_dot;
    const pkmodes_real s_dot_2_x =
        U_2_x_1*l_1_dot + U_2_x_2*l_2_dot + U_2_x_3*l_3_dot + U_2_x_4*l_4_dot + U_2_x_5*l_5_dot
        + U_2_x_6*l_6_dot;
    const pkmodes_real s_dot_2_y =
        U_2_y_1*l_1_dot + U_2_y_2*l_2_dot + U_2_y_3*l_3_dot + U_2_y_4*l_4_dot + U_2_y_5*l_5_dot
        + U_2_y_6*l_6_dot;
    const pkmodes_real s_dot_2_z =
        U_2_z_1*l_1_dot + U_2_z_2*l_2_dot + U_2_z_3*l_3_dot + U_2_z_4*l_4_dot + U_2_z_5*l_5_dot
        + U_2_z_6*l_6_dot;
    const pkmodes_real s_dot_3_x =
        U_3_x_1*l_1_dot + U_3_x_2*l_2_dot + U_3_x_3*l_3_dot + U_3_x_4*l_4_dot + U_3_x_5*l_5_dot
        + U_3_x_6*l_6_dot;
    const pkmodes_real s_dot_3_y =
        U_3_y_1*l_1_dot + U_3_y_2*l_2_dot + U_3_y_3*l_3_dot + U_3_y_4*l_4_dot + U_3_y_5*l_5_dot
        + U_3_y_6*l_6_dot;
    const pkmodes_real s_dot_3_z =
        U_3_z_1*l_1_dot + U_3_z_2*l_2_dot + U_3_z_3*l_3_dot + U_3_z_4*l_4_dot + U_3_z_5*l_5_dot
        + U_3_z_6*l_6_dot;
    const pkmodes_real s_dot_4_x =
        U_4_x_1*l_1_dot + U_4_x_2*l_2_dot + U_4_x_3*l_3_dot + U_4_x_4*l_4_dot + U_4_x_5*l_5_dot
        + U_4_x_6*l_6_dot;
    const pkmodes_real s_dot_4_y =
        U_4_y_1*l_1_dot + U_4_y_2*l_2_dot + U_4_y_3*l_3_dot + U_4_y_4*l_4_dot + U_4_y_5*l_5_dot
        + U_4_y_6*l_6_dot;
    const pkmodes_real s_dot_4_z =
        U_4_z_1*l_1_dot + U_4_z_2*l_2_dot + U_4_z_3*l_3_dot + U_4_z_4*l_4_dot + U_4_z_5*l_5_dot
        + U_4_z_6*l_6_dot;
    const pkmodes_real s_dot_5_x =
        U_5_x_1*l_1_dot + U_5_x_2*l_2_dot + U_5_x_3*l_3_dot + U_5_x_4*l_4_dot + U_5_x_5*l_5_dot
        + U_5_x_6*l_6_dot;
    const pkmodes_real s_dot_5_y =
        U_5_y_1*l_1_dot + U_5_y_2*l_2_dot + U_5_y_3*l_3_dot + U_5_y_4*l_4_dot + U_5_y_5*l_5_dot
        + U_5_y_6*l_6_dot;
    const pkmodes_real s_dot_5_z =
        U_5_z_1*l_1_dot + U_5_z_2*l_2_dot + U_5_z_3*l_3_dot + U_5_z_4*l_4_dot + U_5_z_5*l_5_dot
        + U_5_z_6*l_6_dot;
    const pkmodes_real s_dot_6_x =
        U_6_x_1*l_1_dot + U_6_x_2*l_2_dot + U_6_x_3*l_3_dot + U_6_x_4*l_4_dot + U_6_x_5*l_5_dot
        + U_6_x_6*l_6_dot;
    const pkmodes_real s_dot_6_y =
        U_6_y_1*l_1_dot + U_6_y_2*l_2_dot + U_6_y_3*l_3_dot + U_6_y_4*l_4_dot + U_6_y_5*l_5_dot
        + U_6_y_6*l_6_dot;
    const pkmodes_real s_dot_6_z =
        U_6_z_1*l_1_dot + U_6_z_2*l_2_dot + U_6_z_3*l_3_dot + U_6_z_4*l_4_dot + U_6_z_5*l_5_dot
        + U_6_z_6*l_6_dot;
    const pkmodes_real t127 = B_1_y*D_p_rx_1 - t31;
    const pkmodes_real t128 = B_1_y*D_p_rx_2 - t32;
    const pkmodes_real t129 = B_1_y*D_p_rx_3 - t33;
    const pkmodes_real t130 = B_1_y*D_p_rx_4 - t34;
    const pkmodes_real t131 = B_1_y*D_p_rx_5 - t35;
    const pkmodes_real t132 = B_1_y*D_p_rx_6 - t36;
    const pkmodes_real D_l_dot_1_rx =
        l_1_dot*(B_1_y*U_1_z_1 - B_1_z*U_1_y_1 - d_1_y*t127 + d_1_z*t25) + l_2_dot*(B_1_y*U_1_z_2
        - B_1_z*U_1_y_2 - d_1_y*t128 + d_1_z*t26) + l_3_dot*(B_1_y*U_1_z_3 - B_1_z*U_1_y_3 - d_1_y*t129
        + d_1_z*t27) + l_4_dot*(B_1_y*U_1_z_4 - B_1_z*U_1_y_4 - d_1_y*t130 + d_1_z*t28)
        + l_5_dot*(B_1_y*U_1_z_5 - B_1_z*U_1_y_5 - d_1_y*t131 + d_1_z*t29) + l_6_dot*(B_1_y*U_1_z_6
        - B_1_z*U_1_y_6 - d_1_y*t132 + d_1_z*t30);
    const pkmodes_real t133 = B_1_z*D_p_ry_1 - t19;
    const pkmodes_real t134 = B_1_z*D_p_ry_2 - t20;
    const pkmodes_real t135 = B_1_z*D_p_ry_3 - t21;
    const pkmodes_real t136 = B_1_z*D_p_ry_4 - t22;
    const pkmodes_real t137 = B_1_z*D_p_ry_5 - t23;
    const pkmodes_real t138 = B_1_z*D_p_ry_6 - t24;
    const pkmodes_real D_l_dot_1_ry =
        l_1_dot*(-B_1_x*U_1_z_1 + B_1_z*U_1_x_1 + d_1_x*t127 - d_1_z*t133) + l_2_dot*(-B_1_x*U_1_z_2
        + B_1_z*U_1_x_2 + d_1_x*t128 - d_1_z*t134) + l_3_dot*(-B_1_x*U_1_z_3 + B_1_z*U_1_x_3 + d_1_x*t129
        - d_1_z*t135) + l_4_dot*(-B_1_x*U_1_z_4 + B_1_z*U_1_x_4 + d_1_x*t130 - d_1_z*t136)
        + l_5_dot*(-B_1_x*U_1_z_5 + B_1_z*U_1_x_5 + d_1_x*t131 - d_1_z*t137) + l_6_dot*(-B_1_x*U_1_z_6
        + B_1_z*U_1_x_6 + d_1_x*t132 - d_1_z*t138);
    const pkmodes_real D_l_dot_1_rz =
        l_1_dot*(B_1_x*U_1_y_1 - B_1_y*U_1_x_1 - d_1_x*t25 + d_1_y*t133) + l_2_dot*(B_1_x*U_1_y_2
        - B_1_y*U_1_x_2 - d_1_x*t26 + d_1_y*t134) + l_3_dot*(B_1_x*U_1_y_3 - B_1_y*U_1_x_3 - d_1_x*t27
        + d_1_y*t135) + l_4_dot*(B_1_x*U_1_y_4 - B_1_y*U_1_x_4 - d_1_x*t28 + d_1_y*t136)
        + l_5_dot*(B_1_x*U_1_y_5 - B_1_y*U_1_x_5 - d_1_x*t29 + d_1_y*t137) + l_6_dot*(B_1_x*U_1_y_6
        - B_1_y*U_1_x_6 - d_1_x*t30 + d_1_y*t138);
    const pkmodes_real t139 = B_2_y*D_p_rx_1 - t49;
    const pkmodes_real t140 = B_2_y*D_p_rx_2 - t50;
    const pkmodes_real t141 = B_2_y*D_p_rx_3 - t51;
    const pkmodes_real t142 = B_2_y*D_p_rx_4 - t52;
    const pkmodes_real t143 = B_2_y*D_p_rx_5 - t53;
    const pkmodes_real t144 = B_2_y*D_p_rx_6 - t54;
    const pkmodes_real D_l_dot_2_rx =
        l_1_dot*(B_2_y*U_2_z_1 - B_2_z*U_2_y_1 - d_2_y*t139 + d_2_z*t43) + l_2_dot*(B_2_y*U_2_z_2
        - B_2_z*U_2_y_2 - d_2_y*t140 + d_2_z*t44) + l_3_dot*(B_2_y*U_2_z_3 - B_2_z*U_2_y_3 - d_2_y*t141
        + d_2_z*t45) + l_4_dot*(B_2_y*U_2_z_4 - B_2_z*U_2_y_4 - d_2_y*t142 + d_2_z*t46)
        + l_5_dot*(B_2_y*U_2_z_5 - B_2_z*U_2_y_5 - d_2_y*t143 + d_2_z*t47) + l_6_dot*(B_2_y*U_2_z_6
        - B_2_z*U_2_y_6 - d_2_y*t144 + d_2_z*t48);
    const pkmodes_real t145 = B_2_z*D_p_ry_1 - t37;
    const pkmodes_real t146 = B_2_z*D_p_ry_2 - t38;
    const pkmodes_real t147 = B_2_z*D_p_ry_3 - t39;
    const pkmodes_real t148 = B_2_z*D_p_ry_4 - t40;
    const pkmodes_real t149 = B_2_z*D_p_ry_5 - t41;
    const pkmodes_real t150 = B_2_z*D_p_ry_6 - t42;
    const pkmodes_real D_l_dot_2_ry =
        l_1_dot*(-B_2_x*U_2_z_1 + B_2_z*U_2_x_1 + d_2_x*t139 - d_2_z*t145) + l_2_dot*(-B_2_x*U_2_z_2
        + B_2_z*U_2_x_2 + d_2_x*t140 - d_2_z*t146) + l_3_dot*(-B_2_x*U_2_z_3 + B_2_z*U_2_x_3 + d_2_x*t141
        - d_2_z*t147) + l_4_dot*(-B_2_x*U_2_z_4 + B_2_z*U_2_x_4 + d_2_x*t142 - d_2_z*t148)
        + l_5_dot*(-B_2_x*U_2_z_5 + B_2_z*U_2_x_5 + d_2_x*t143 - d_2_z*t149) + l_6_dot*(-B_2_x*U_2_z_6
        + B_2_z*U_2_x_6 + d_2_x*t144 - d_2_z*t150);
    const pkmodes_real D_l_dot_2_rz =
        l_1_dot*(B_2_x*U_2_y_1 - B_2_y*U_2_x_1 - d_2_x*t43 + d_2_y*t145) + l_2_dot*(B_2_x*U_2_y_2
        - B_2_y*U_2_x_2 - d_2_x*t44 + d_2_y*t146) + l_3_dot*(B_2_x*U_2_y_3 - B_2_y*U_2_x_3 - d_2_x*t45
        + d_2_y*t147) + l_4_dot*(B_2_x*U_2_y_4 - B_2_y*U_2_x_4 - d_2_x*t46 + d_2_y*t148)
        + l_5_dot*(B_2_x*U_2_y_5 - B_2_y*U_2_x_5 - d_2_x*t47 + d_2_y*t149) + l_6_dot*(B_2_x*U_2_y_6
        - B_2_y*U_2_x_6 - d_2_x*t48 + d_2_y*t150);
    const pkmodes_real t151 = B_3_y*D_p_rx_1 - t67;
    const pkmodes_real t152 = B_3_y*D_p_rx_2 - t68;
    const pkmodes_real t153 = B_3_y*D_p_rx_3 - t69;
    const pkmodes_real t154 = B_3_y*D_p_rx_4 - t70;
    const pkmodes_real t155 = B_3_y*D_p_rx_5 - t71;
    const pkmodes_real t156 = B_3_y*D_p_rx_6 - t72;
    const pkmodes_real D_l_dot_3_rx =
        l_1_dot*(B_3_y*U_3_z_1 - B_3_z*U_3_y_1 - d_3_y*t151 + d_3_z*t61) + l_2_dot*(B_3_y*U_3_z_2
        - B_3_z*U_3_y_2 - d_3_y*t152 + d_3_z*t62) + l_3_dot*(B_3_y*U_3_z_3 - B_3_z*U_3_y_3 - d_3_y*t153
        + d_3_z*t63) + l_4_dot*(B_3_y*U_3_z_4 - B_3_z*U_3_y_4 - d_3_y*t154 + d_3_z*t64)
        + l_5_dot*(B_3_y*U_3_z_5 - B_3_z*U_3_y_5 - d_3_y*t155 + d_3_z*t65) + l_6_dot*(B_3_y*U_3_z_6
        - B_3_z*U_3_y_6 - d_3_y*t156 + d_3_z*t66);
    const pkmodes_real t157 = B_3_z*D_p_ry_1 - t55;
    const pkmodes_real t158 = B_3_z*D_p_ry_2 - t56;
    const pkmodes_real t159 = B_3_z*D_p_ry_3 - t57;
    const pkmodes_real t160 = B_3_z*D_p_ry_4 - t58;
    const pkmodes_real t161 = B_3_z*D_p_ry_5 - t59;
    const pkmodes_real t162 = B_3_z*D_p_ry_6 - t60;
    const pkmodes_real D_l_dot_3_ry =
        l_1_dot*(-B_3_x*U_3_z_1 + B_3_z*U_3_x_1 + d_3_x*t151 - d_3_z*t157) + l_2_dot*(-B_3_x*U_3_z_2
        + B_3_z*U_3_x_2 + d_3_x*t152 - d_3_z*t158) + l_3_dot*(-B_3_x*U_3_z_3 + B_3_z*U_3_x_3 + d_3_x*t153
        - d_3_z*t159) + l_4_dot*(-B_3_x*U_3_z_4 + B_3_z*U_3_x_4 + d_3_x*t154 - d_3_z*t160)
        + l_5_dot*(-B_3_x*U_3_z_5 + B_3_z*U_3_x_5 + d_3_x*t155 - d_3_z*t161) + l_6_dot*(-B_3_x*U_3_z_6
        + B_3_z*U_3_x_6 + d_3_x*t156 - d_3_z*t162);
    const pkmodes_real D_l_dot_3_rz =
        l_1_dot*(B_3_x*U_3_y_1 - B_3_y*U_3_x_1 - d_3_x*t61 + d_3_y*t157) + l_2_dot*(B_3_x*U_3_y_2
        - B_3_y*U_3_x_2 - d_3_x*t62 + d_3_y*t158) + l_3_dot*(B_3_x*U_3_y_3 - B_3_y*U_3_x_3 - d_3_x*t63
        + d_3_y*t159) + l_4_dot*(B_3_x*U_3_y_4 - B_3_y*U_3_x_4 - d_3_x*t64 + d_3_y*t160)
        + l_5_dot*(B_3_x*U_3_y_5 - B_3_y*U_3_x_5 - d_3_x*t65 + d_3_y*t161) + l_6_dot*(B_3_x*U_3_y_6
        - B_3_y*U_3_x_6 - d_3_x*t66 + d_3_y*t162);
    const pkmodes_real t163 = B_4_y*D_p_rx_1 - t85;
    const pkmodes_real t164 = B_4_y*D_p_rx_2 - t86;
    const pkmodes_real t165 = B_4_y*D_p_rx_3 - t87;
    const pkmodes_real t166 = B_4_y*D_p_rx_4 - t88;
    const pkmodes_real t167 = B_4_y*D_p_rx_5 - t89;
    const pkmodes_real t168 = B_4_y*D_p_rx_6 - t90;
    const pkmodes_real D_l_dot_4_rx =
        l_1_dot*(B_4_y*U_4_z_1 - B_4_z*U_4_y_1 - d_4_y*t163 + d_4_z*t79) + l_2_dot*(B_4_y*U_4_z_2
        - B_4_z*U_4_y_2 - d_4_y*t164 + d_4_z*t80) + l_3_dot*(B_4_y*U_4_z_3 - B_4_z*U_4_y_3 - d_4_y*t165
        + d_4_z*t81) + l_4_dot*(B_4_y*U_4_z_4 - B_4_z*U_4_y_4 - d_4_y*t166 + d_4_z*t82)
        + l_5_dot*(B_4_y*U_4_z_5 - B_4_z*U_4_y_5 - d_4_y*t167 + d_4_z*t83) + l_6_dot*(B_4_y*U_4_z_6
        - B_4_z*U_4_y_6 - d_4_y*t168 + d_4_z*t84);
    const pkmodes_real t169 = B_4_z*D_p_ry_1 - t73;
    const pkmodes_real t170 = B_4_z*D_p_ry_2 - t74;
    const pkmodes_real t171 = B_4_z*D_p_ry_3 - t75;
    const pkmodes_real t172 = B_4_z*D_p_ry_4 - t76;
    const pkmodes_real t173 = B_4_z*D_p_ry_5 - t77;
    const pkmodes_real t174 = B_4_z*D_p_ry_6 - t78;
    const pkmodes_real D_l_dot_4_ry =
        l_1_dot*(-B_4_x*U_4_z_1 + B_4_z*U_4_x_1 + d_4_x*t163 - d_4_z*t169) + l_2_dot*(-B_4_x*U_4_z_2
        + B_4_z*U_4_x_2 + d_4_x*t164 - d_4_z*t170) + l_3_dot*(-B_4_x*U_4_z_3 + B_4_z*U_4_x_3 + d_4_x*t165
        - d_4_z*t171) + l_4_dot*(-B_4_x*U_4_z_4 + B_4_z*U_4_x_4 + d_4_x*t166 - d_4_z*t172)
        + l_5_dot*(-B_4_x*U_4_z_5 + B_4_z*U_4_x_5 + d_4_x*t167 - d_4_z*t173) + l_6_dot*(-B_4_x*U_4_z_6
        + B_4_z*U_4_x_6 + d_4_x*t168 - d_4_z*t174);
    const pkmodes_real D_l_dot_4_rz =
        l_1_dot*(B_4_x*U_4_y_1 - B_4_y*U_4_x_1 - d_4_x*t79 + d_4_y*t169) + l_2_dot*(B_4_x*U_4_y_2
        - B_4_y*U_4_x_2 - d_4_x*t80 + d_4_y*t170) + l_3_dot*(B_4_x*U_4_y_3 - B_4_y*U_4_x_3 - d_4_x*t81
        + d_4_y*t171) + l_4_dot*(B_4_x*U_4_y_4 - B_4_y*U_4_x_4 - d_4_x*t82 + d_4_y*t172)
        + l_5_dot*(B_4_x*U_4_y_5 - B_4_y*U_4_x_5 - d_4_x*t83 + d_4_y*t173) + l_6_dot*(B_4_x*U_4_y_6
        - B_4_y*U_4_x_6 - d_4_x*t84 + d_4_y*t174);
    const pkmodes_real t175 = B_5_y*D_p_rx_1 - t103;
    const pkmodes_real t176 = B_5_y*D_p_rx_2 - t104;
    const pkmodes_real t177 = B_5_y*D_p_rx_3 - t105;
    const pkmodes_real t178 = B_5_y*D_p_rx_4 - t106;
    const pkmodes_real t179 = B_5_y*D_p_rx_5 - t107;
    const pkmodes_real t180 = B_5_y*D_p_rx_6 - t108;
    const pkmodes_real D_l_dot_5_rx =
        l_1_dot*(B_5_y*U_5_z_1 - B_5_z*U_5_y_1 - d_5_y*t175 + d_5_z*t97) + l_2_dot*(B_5_y*U_5_z_2
        - B_5_z*U_5_y_2 - d_5_y*t176 + d_5_z*t98) + l_3_dot*(B_5_y*U_5_z_3 - B_5_z*U_5_y_3 - d_5_y*t177
        + d_5_z*t99) + l_4_dot*(B_5_y*U_5_z_4 - B_5_z*U_5_y_4 - d_5_y*t178 + d_5_z*t100)
        + l_5_dot*(B_5_y*U_5_z_5 - B_5_z*U_5_y_5 - d_5_y*t179 + d_5_z*t101) + l_6_dot*(B_5_y*U_5_z_6
        - B_5_z*U_5_y_6 - d_5_y*t180 + d_5_z*t102);
    const pkmodes_real t181 = B_5_z*D_p_ry_1 - t91;
    const pkmodes_real t182 = B_5_z*D_p_ry_2 - t92;
    const pkmodes_real t183 = B_5_z*D_p_ry_3 - t93;
    const pkmodes_real t184 = B_5_z*D_p_ry_4 - t94;
    const pkmodes_real t185 = B_5_z*D_p_ry_5 - t95;
    const pkmodes_real t186 = B_5_z*D_p_ry_6 - t96;
    const pkmodes_real D_l_dot_5_ry =
        l_1_dot*(-B_5_x*U_5_z_1 + B_5_z*U_5_x_1 + d_5_x*t175 - d_5_z*t181) + l_2_dot*(-B_5_x*U_5_z_2
        + B_5_z*U_5_x_2 + d_5_x*t176 - d_5_z*t182) + l_3_dot*(-B_5_x*U_5_z_3 + B_5_z*U_5_x_3 + d_5_x*t177
        - d_5_z*t183) + l_4_dot*(-B_5_x*U_5_z_4 + B_5_z*U_5_x_4 + d_5_x*t178 - d_5_z*t184)
        + l_5_dot*(-B_5_x*U_5_z_5 + B_5_z*U_5_x_5 + d_5_x*t179 - d_5_z*t185) + l_6_dot*(-B_5_x*U_5_z_6
        + B_5_z*U_5_x_6 + d_5_x*t180 - d_5_z*t186);
    const pkmodes_real D_l_dot_5_rz =
        l_1_dot*(B_5_x*U_5_y_1 - B_5_y*U_5_x_1 - d_5_x*t97 + d_5_y*t181) + l_2_dot*(B_5_x*U_5_y_2
        - B_5_y*U_5_x_2 - d_5_x*t98 + d_5_y*t182) + l_3_dot*(B_5_x*U_5_y_3 - B_5_y*U_5_x_3 - d_5_x*t99
        + d_5_y*t183) + l_4_dot*(B_5_x*U_5_y_4 - B_5_y*U_5_x_4 - d_5_x*t100 + d_5_y*t184)
        + l_5_dot*(B_5_x*U_5_y_5 - B_5_y*U_5_x_5 - d_5_x*t101 + d_5_y*t185) + l_6_dot*(B_5_x*U_5_y_6
        - B_5_y*U_5_x_6 - d_5_x*t102 + d_5_y*t186);
    const pkmodes_real t187 = B_6_y*D_p_rx_1 - t121;
    const pkmodes_real t188 = B_6_y*D_p_rx_2 - t122;
    const pkmodes_real t189 = B_6_y*D_p_rx_3 - t123;
    const pkmodes_real t190 = B_6_y*D_p_rx_4 - t124;
    const pkmodes_real t191 = B_6_y*D_p_rx_5 - t125;
    const pkmodes_real t192 = B_6_y*D_p_rx_6 - t126;
    const pkmodes_real D_l_dot_6_rx =
        l_1_dot*(B_6_y*U_6_z_1 - B_6_z*U_6_y_1 - d_6_y*t187 + d_6_z*t115) + l_2_dot*(B_6_y*U_6_z_2
        - B_6_z*U_6_y_2 - d_6_y*t188 + d_6_z*t116) + l_3_dot*(B_6_y*U_6_z_3 - B_6_z*U_6_y_3 - d_6_y*t189
        + d_6_z*t117) + l_4_dot*(B_6_y*U_6_z_4 - B_6_z*U_6_y_4 - d_6_y*t190 + d_6_z*t118)
        + l_5_dot*(B_6_y*U_6_z_5 - B_6_z*U_6_y_5 - d_6_y*t191 + d_6_z*t119) + l_6_dot*(B_6_y*U_6_z_6
        - B_6_z*U_6_y_6 - d_6_y*t192 + d_6_z*t120);
    const pkmodes_real t193 = B_6_z*D_p_ry_1 - t109;
    const pkmodes_real t194 = B_6_z*D_p_ry_2 - t110;
    const pkmodes_real t195 = B_6_z*D_p_ry_3 - t111;
    const pkmodes_real t196 = B_6_z*D_p_ry_4 - t112;
    const pkmodes_real t197 = B_6_z*D_p_ry_5 - t113;
    const pkmodes_real t198 = B_6_z*D_p_ry_6 - t114;
    const pkmodes_real D_l_dot_6_ry =
        l_1_dot*(-B_6_x*U_6_z_1 + B_6_z*U_6_x_1 + d_6_x*t187 - d_6_z*t193) + l_2_dot*(-B_6_x*U_6_z_2
        + B_6_z*U_6_x_2 + d_6_x*t188 - d_6_z*t194) + l_3_dot*(-B_6_x*U_6_z_3 + B_6_z*U_6_x_3 + d_6_x*t189
        - d_6_z*t195) + l_4_dot*(-B_6_x*U_6_z_4 + B_6_z*U_6_x_4 + d_6_x*t190 - d_6_z*t196)
        + l_5_dot*(-B_6_x*U_6_z_5 + B_6_z*U_6_x_5 + d_6_x*t191 - d_6_z*t197) + l_6_dot*(-B_6_x*U_6_z_6
        + B_6_z*U_6_x_6 + d_6_x*t192 - d_6_z*t198);
    const pkmodes_real D_l_dot_6_rz =
        l_1_dot*(B_6_x*U_6_y_1 - B_6_y*U_6_x_1 - d_6_x*t115 + d_6_y*t193) + l_2_dot*(B_6_x*U_6_y_2
        - B_6_y*U_6_x_2 - d_6_x*t116 + d_6_y*t194) + l_3_dot*(B_6_x*U_6_y_3 - B_6_y*U_6_x_3 - d_6_x*t117
        + d_6_y*t195) + l_4_dot*(B_6_x*U_6_y_4 - B_6_y*U_6_x_4 - d_6_x*t118 + d_6_y*t196)
        + l_5_dot*(B_6_x*U_6_y_5 - B_6_y*U_6_x_5 - d_6_x*t119 + d_6_y*t197) + l_6_dot*(B_6_x*U_6_y_6
        - B_6_y*U_6_x_6 - d_6_x*t120 + d_6_y*t198);
    const pkmodes_real t199 =
        -D_l_dot_2_rx*D_p_rx_1 - D_l_dot_2_ry*D_p_ry_1 - D_l_dot_2_rz*D_p_rz_1 - D_p_x_1*s_dot_2_x
        - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t200 =
        -D_l_dot_3_rx*D_p_rx_1 - D_l_dot_3_ry*D_p_ry_1 - D_l_dot_3_rz*D_p_rz_1 - D_p_x_1*s_dot_3_x
        - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t201 =
        -D_l_dot_4_rx*D_p_rx_1 - D_l_dot_4_ry*D_p_ry_1 - D_l_dot_4_rz*D_p_rz_1 - D_p_x_1*s_dot_4_x
        - D_p_y_1*s_dot_4_y - D_p_z_1*s_dot_4_z;
    const pkmodes_real t202 =
        -D_l_dot_5_rx*D_p_rx_1 - D_l_dot_5_ry*D_p_ry_1 - D_l_dot_5_rz*D_p_rz_1 - D_p_x_1*s_dot_5_x
        - D_p_y_1*s_dot_5_y - D_p_z_1*s_dot_5_z;
    const pkmodes_real t203 =
        -D_l_dot_6_rx*D_p_rx_1 - D_l_dot_6_ry*D_p_ry_1 - D_l_dot_6_rz*D_p_rz_1 - D_p_x_1*s_dot_6_x
        - D_p_y_1*s_dot_6_y - D_p_z_1*s_dot_6_z;
    const pkmodes_real t204 =
        -D_l_dot_1_rx*D_p_rx_1 - D_l_dot_1_ry*D_p_ry_1 - D_l_dot_1_rz*D_p_rz_1 - D_p_x_1*s_dot_1_x
        - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + l_1_dot;
    const pkmodes_real D_p_dot_x_1 =
        t12*(A_x_1*t204 + A_x_2*t199 + A_x_3*t200 + A_x_4*t201 + A_x_5*t202 + A_x_6*t203);
    const pkmodes_real D_p_dot_y_1 =
        t12*(A_y_1*t204 + A_y_2*t199 + A_y_3*t200 + A_y_4*t201 + A_y_5*t202 + A_y_6*t203);
    const pkmodes_real D_p_dot_z_1 =
        t12*(A_z_1*t204 + A_z_2*t199 + A_z_3*t200 + A_z_4*t201 + A_z_5*t202 + A_z_6*t203);
    const pkmodes_real D_p_dot_rx_1 =
        t12*(A_rx_1*t204 + A_rx_2*t199 + A_rx_3*t200 + A_rx_4*t201 + A_rx_5*t202 + A_rx_6*t203);
    const pkmodes_real D_p_dot_ry_1 =
        t12*(A_ry_1*t204 + A_ry_2*t199 + A_ry_3*t200 + A_ry_4*t201 + A_ry_5*t202 + A_ry_6*t203);
    const pkmodes_real D_p_dot_rz_1 =
        t12*(A_rz_1*t204 + A_rz_2*t199 + A_rz_3*t200 + A_rz_4*t201 + A_rz_5*t202 + A_rz_6*t203);
    const pkmodes_real t205 =
        -D_l_dot_1_rx*D_p_rx_2 - D_l_dot_1_ry*D_p_ry_2 - D_l_dot_1_rz*D_p_rz_2 - D_p_x_2*s_dot_1_x
        - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t206 =
        -D_l_dot_3_rx*D_p_rx_2 - D_l_dot_3_ry*D_p_ry_2 - D_l_dot_3_rz*D_p_rz_2 - D_p_x_2*s_dot_3_x
        - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t207 =
        -D_l_dot_4_rx*D_p_rx_2 - D_l_dot_4_ry*D_p_ry_2 - D_l_dot_4_rz*D_p_rz_2 - D_p_x_2*s_dot_4_x
        - D_p_y_2*s_dot_4_y - D_p_z_2*s_dot_4_z;
    const pkmodes_real t208 =
        -D_l_dot_5_rx*D_p_rx_2 - D_l_dot_5_ry*D_p_ry_2 - D_l_dot_5_rz*D_p_rz_2 - D_p_x_2*s_dot_5_x
        - D_p_y_2*s_dot_5_y - D_p_z_2*s_dot_5_z;
    const pkmodes_real t209 =
        -D_l_dot_6_rx*D_p_rx_2 - D_l_dot_6_ry*D_p_ry_2 - D_l_dot_6_rz*D_p_rz_2 - D_p_x_2*s_dot_6_x
        - D_p_y_2*s_dot_6_y - D_p_z_2*s_dot_6_z;
    const pkmodes_real t210 =
        -D_l_dot_2_rx*D_p_rx_2 - D_l_dot_2_ry*D_p_ry_2 - D_l_dot_2_rz*D_p_rz_2 - D_p_x_2*s_dot_2_x
        - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + l_2_dot;
    const pkmodes_real D_p_dot_x_2 =
        t12*(A_x_1*t205 + A_x_2*t210 + A_x_3*t206 + A_x_4*t207 + A_x_5*t208 + A_x_6*t209);
    const pkmodes_real D_p_dot_y_2 =
        t12*(A_y_1*t205 + A_y_2*t210 + A_y_3*t206 + A_y_4*t207 + A_y_5*t208 + A_y_6*t209);
    const pkmodes_real D_p_dot_z_2 =
        t12*(A_z_1*t205 + A_z_2*t210 + A_z_3*t206 + A_z_4*t207 + A_z_5*t208 + A_z_6*t209);
    const pkmodes_real D_p_dot_rx_2 =
        t12*(A_rx_1*t205 + A_rx_2*t210 + A_rx_3*t206 + A_rx_4*t207 + A_rx_5*t208 + A_rx_6*t209);
    const pkmodes_real D_p_dot_ry_2 =
        t12*(A_ry_1*t205 + A_ry_2*t210 + A_ry_3*t206 + A_ry_4*t207 + A_ry_5*t208 + A_ry_6*t209);
    const pkmodes_real D_p_dot_rz_2 =
        t12*(A_rz_1*t205 + A_rz_2*t210 + A_rz_3*t206 + A_rz_4*t207 + A_rz_5*t208 + A_rz_6*t209);
    const pkmodes_real t211 =
        -D_l_dot_1_rx*D_p_rx_3 - D_l_dot_1_ry*D_p_ry_3 - D_l_dot_1_rz*D_p_rz_3 - D_p_x_3*s_dot_1_x
        - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t212 =
        -D_l_dot_2_rx*D_p_rx_3 - D_l_dot_2_ry*D_p_ry_3 - D_l_dot_2_rz*D_p_rz_3 - D_p_x_3*s_dot_2_x
        - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t213 =
        -D_l_dot_4_rx*D_p_rx_3 - D_l_dot_4_ry*D_p_ry_3 - D_l_dot_4_rz*D_p_rz_3 - D_p_x_3*s_dot_4_x
        - D_p_y_3*s_dot_4_y - D_p_z_3*s_dot_4_z;
    const pkmodes_real t214 =
        -D_l_dot_5_rx*D_p_rx_3 - D_l_dot_5_ry*D_p_ry_3 - D_l_dot_5_rz*D_p_rz_3 - D_p_x_3*s_dot_5_x
        - D_p_y_3*s_dot_5_y - D_p_z_3*s_dot_5_z;
    const pkmodes_real t215 =
        -D_l_dot_6_rx*D_p_rx_3 - D_l_dot_6_ry*D_p_ry_3 - D_l_dot_6_rz*D_p_rz_3 - D_p_x_3*s_dot_6_x
        - D_p_y_3*s_dot_6_y - D_p_z_3*s_dot_6_z;
    const pkmodes_real t216 =
        -D_l_dot_3_rx*D_p_rx_3 - D_l_dot_3_ry*D_p_ry_3 - D_l_dot_3_rz*D_p_rz_3 - D_p_x_3*s_dot_3_x
        - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + l_3_dot;
    const pkmodes_real D_p_dot_x_3 =
        t12*(A_x_1*t211 + A_x_2*t212 + A_x_3*t216 + A_x_4*t213 + A_x_5*t214 + A_x_6*t215);
    const pkmodes_real D_p_dot_y_3 =
        t12*(A_y_1*t211 + A_y_2*t212 + A_y_3*t216 + A_y_4*t213 + A_y_5*t214 + A_y_6*t215);
    const pkmodes_real D_p_dot_z_3 =
        t12*(A_z_1*t211 + A_z_2*t212 + A_z_3*t216 + A_z_4*t213 + A_z_5*t214 + A_z_6*t215);
    const pkmodes_real D_p_dot_rx_3 =
        t12*(A_rx_1*t211 + A_rx_2*t212 + A_rx_3*t216 + A_rx_4*t213 + A_rx_5*t214 + A_rx_6*t215);
    const pkmodes_real D_p_dot_ry_3 =
        t12*(A_ry_1*t211 + A_ry_2*t212 + A_ry_3*t216 + A_ry_4*t213 + A_ry_5*t214 + A_ry_6*t215);
    const pkmodes_real D_p_dot_rz_3 =
        t12*(A_rz_1*t211 + A_rz_2*t212 + A_rz_3*t216 + A_rz_4*t213 + A_rz_5*t214 + A_rz_6*t215);
    const pkmodes_real t217 =
        -D_l_dot_1_rx*D_p_rx_4 - D_l_dot_1_ry*D_p_ry_4 - D_l_dot_1_rz*D_p_rz_4 - D_p_x_4*s_dot_1_x
        - D_p_y_4*s_dot_1_y - D_p_z_4*s_dot_1_z;
    const pkmodes_real t218 =
        -D_l_dot_2_rx*D_p_rx_4 - D_l_dot_2_ry*D_p_ry_4 - D_l_dot_2_rz*D_p_rz_4 - D_p_x_4*s_dot_2_x
        - D_p_y_4*s_dot_2_y - D_p_z_4*s_dot_2_z;
    const pkmodes_real t219 =
        -D_l_dot_3_rx*D_p_rx_4 - D_l_dot_3_ry*D_p_ry_4 - D_l_dot_3_rz*D_p_rz_4 - D_p_x_4*s_dot_3_x
        - D_p_y_4*s_dot_3_y - D_p_z_4*s_dot_3_z;
    const pkmodes_real t220 =
        -D_l_dot_5_rx*D_p_rx_4 - D_l_dot_5_ry*D_p_ry_4 - D_l_dot_5_rz*D_p_rz_4 - D_p_x_4*s_dot_5_x
        - D_p_y_4*s_dot_5_y - D_p_z_4*s_dot_5_z;
    const pkmodes_real t221 =
        -D_l_dot_6_rx*D_p_rx_4 - D_l_dot_6_ry*D_p_ry_4 - D_l_dot_6_rz*D_p_rz_4 - D_p_x_4*s_dot_6_x
        - D_p_y_4*s_dot_6_y - D_p_z_4*s_dot_6_z;
    const pkmodes_real t222 =
        -D_l_dot_4_rx*D_p_rx_4 - D_l_dot_4_ry*D_p_ry_4 - D_l_dot_4_rz*D_p_rz_4 - D_p_x_4*s_dot_4_x
        - D_p_y_4*s_dot_4_y - D_p_z_4*s_dot_4_z + l_4_dot;
    const pkmodes_real D_p_dot_x_4 =
        t12*(A_x_1*t217 + A_x_2*t218 + A_x_3*t219 + A_x_4*t222 + A_x_5*t220 + A_x_6*t221);
    const pkmodes_real D_p_dot_y_4 =
        t12*(A_y_1*t217 + A_y_2*t218 + A_y_3*t219 + A_y_4*t222 + A_y_5*t220 + A_y_6*t221);
    const pkmodes_real D_p_dot_z_4 =
        t12*(A_z_1*t217 + A_z_2*t218 + A_z_3*t219 + A_z_4*t222 + A_z_5*t220 + A_z_6*t221);
    const pkmodes_real D_p_dot_rx_4 =
        t12*(A_rx_1*t217 + A_rx_2*t218 + A_rx_3*t219 + A_rx_4*t222 + A_rx_5*t220 + A_rx_6*t221);
    const pkmodes_real D_p_dot_ry_4 =
        t12*(A_ry_1*t217 + A_ry_2*t218 + A_ry_3*t219 + A_ry_4*t222 + A_ry_5*t220 + A_ry_6*t221);
    const pkmodes_real D_p_dot_rz_4 =
        t12*(A_rz_1*t217 + A_rz_2*t218 + A_rz_3*t219 + A_rz_4*t222 + A_rz_5*t220 + A_rz_6*t221);
    const pkmodes_real t223 =
        -D_l_dot_1_rx*D_p_rx_5 - D_l_dot_1_ry*D_p_ry_5 - D_l_dot_1_rz*D_p_rz_5 - D_p_x_5*s_dot_1_x
        - D_p_y_5*s_dot_1_y - D_p_z_5*s_dot_1_z;
    const pkmodes_real t224 =
        -D_l_dot_2_rx*D_p_rx_5 - D_l_dot_2_ry*D_p_ry_5 - D_l_dot_2_rz*D_p_rz_5 - D_p_x_5*s_dot_2_x
        - D_p_y_5*s_dot_2_y - D_p_z_5*s_dot_2_z;
    const pkmodes_real t225 =
        -D_l_dot_3_rx*D_p_rx_5 - D_l_dot_3_ry*D_p_ry_5 - D_l_dot_3_rz*D_p_rz_5 - D_p_x_5*s_dot_3_x
        - D_p_y_5*s_dot_3_y - D_p_z_5*s_dot_3_z;
    const pkmodes_real t226 =
        -D_l_dot_4_rx*D_p_rx_5 - D_l_dot_4_ry*D_p_ry_5 - D_l_dot_4_rz*D_p_rz_5 - D_p_x_5*s_dot_4_x
        - D_p_y_5*s_dot_4_y - D_p_z_5*s_dot_4_z;
    const pkmodes_real t227 =
        -D_l_dot_6_rx*D_p_rx_5 - D_l_dot_6_ry*D_p_ry_5 - D_l_dot_6_rz*D_p_rz_5 - D_p_x_5*s_dot_6_x
        - D_p_y_5*s_dot_6_y - D_p_z_5*s_dot_6_z;
    const pkmodes_real t228 =
        -D_l_dot_5_rx*D_p_rx_5 - D_l_dot_5_ry*D_p_ry_5 - D_l_dot_5_rz*D_p_rz_5 - D_p_x_5*s_dot_5_x
        - D_p_y_5*s_dot_5_y - D_p_z_5*s_dot_5_z + l_5_dot;
    const pkmodes_real D_p_dot_x_5 =
        t12*(A_x_1*t223 + A_x_2*t224 + A_x_3*t225 + A_x_4*t226 + A_x_5*t228 + A_x_6*t227);
    const pkmodes_real D_p_dot_y_5 =
        t12*(A_y_1*t223 + A_y_2*t224 + A_y_3*t225 + A_y_4*t226 + A_y_5*t228 + A_y_6*t227);
    const pkmodes_real D_p_dot_z_5 =
        t12*(A_z_1*t223 + A_z_2*t224 + A_z_3*t225 + A_z_4*t226 + A_z_5*t228 + A_z_6*t227);
    const pkmodes_real D_p_dot_rx_5 =
        t12*(A_rx_1*t223 + A_rx_2*t224 + A_rx_3*t225 + A_rx_4*t226 + A_rx_5*t228 + A_rx_6*t227);
    const pkmodes_real D_p_dot_ry_5 =
        t12*(A_ry_1*t223 + A_ry_2*t224 + A_ry_3*t225 + A_ry_4*t226 + A_ry_5*t228 + A_ry_6*t227);
    const pkmodes_real D_p_dot_rz_5 =
        t12*(A_rz_1*t223 + A_rz_2*t224 + A_rz_3*t225 + A_rz_4*t226 + A_rz_5*t228 + A_rz_6*t227);
    const pkmodes_real t229 =
        -D_l_dot_1_rx*D_p_rx_6 - D_l_dot_1_ry*D_p_ry_6 - D_l_dot_1_rz*D_p_rz_6 - D_p_x_6*s_dot_1_x
        - D_p_y_6*s_dot_1_y - D_p_z_6*s_dot_1_z;
    const pkmodes_real t230 =
        -D_l_dot_2_rx*D_p_rx_6 - D_l_dot_2_ry*D_p_ry_6 - D_l_dot_2_rz*D_p_rz_6 - D_p_x_6*s_dot_2_x
        - D_p_y_6*s_dot_2_y - D_p_z_6*s_dot_2_z;
    const pkmodes_real t231 =
        -D_l_dot_3_rx*D_p_rx_6 - D_l_dot_3_ry*D_p_ry_6 - D_l_dot_3_rz*D_p_rz_6 - D_p_x_6*s_dot_3_x
        - D_p_y_6*s_dot_3_y - D_p_z_6*s_dot_3_z;
    const pkmodes_real t232 =
        -D_l_dot_4_rx*D_p_rx_6 - D_l_dot_4_ry*D_p_ry_6 - D_l_dot_4_rz*D_p_rz_6 - D_p_x_6*s_dot_4_x
        - D_p_y_6*s_dot_4_y - D_p_z_6*s_dot_4_z;
    const pkmodes_real t233 =
        -D_l_dot_5_rx*D_p_rx_6 - D_l_dot_5_ry*D_p_ry_6 - D_l_dot_5_rz*D_p_rz_6 - D_p_x_6*s_dot_5_x
        - D_p_y_6*s_dot_5_y - D_p_z_6*s_dot_5_z;
    const pkmodes_real t234 =
        -D_l_dot_6_rx*D_p_rx_6 - D_l_dot_6_ry*D_p_ry_6 - D_l_dot_6_rz*D_p_rz_6 - D_p_x_6*s_dot_6_x
        - D_p_y_6*s_dot_6_y - D_p_z_6*s_dot_6_z + l_6_dot;
    const pkmodes_real D_p_dot_x_6 =
        t12*(A_x_1*t229 + A_x_2*t230 + A_x_3*t231 + A_x_4*t232 + A_x_5*t233 + A_x_6*t234);
    const pkmodes_real D_p_dot_y_6 =
        t12*(A_y_1*t229 + A_y_2*t230 + A_y_3*t231 + A_y_4*t232 + A_y_5*t233 + A_y_6*t234);
    const pkmodes_real D_p_dot_z_6 =
        t12*(A_z_1*t229 + A_z_2*t230 + A_z_3*t231 + A_z_4*t232 + A_z_5*t233 + A_z_6*t234);
    const pkmodes_real D_p_dot_rx_6 =
        t12*(A_rx_1*t229 + A_rx_2*t230 + A_rx_3*t231 + A_rx_4*t232 + A_rx_5*t233 + A_rx_6*t234);
    const pkmodes_real D_p_dot_ry_6 =
        t12*(A_ry_1*t229 + A_ry_2*t230 + A_ry_3*t231 + A_ry_4*t232 + A_ry_5*t233 + A_ry_6*t234);
    const pkmodes_real D_p_dot_rz_6 =
        t12*(A_rz_1*t229 + A_rz_2*t230 + A_rz_3*t231 + A_rz_4*t232 + A_rz_5*t233 + A_rz_6*t234);
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

void hexapod_platform_second_derivatives(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real P[6][6][6])
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
    const pkmodes_real t19 = B_1_y*D_p_rz_1;
    const pkmodes_real U_1_x_1 = B_1_z*D_p_ry_1 + D_p_x_1 - t19;
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
    const pkmodes_real U_1_y_1 = D_p_y_1 + t25;
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
    const pkmodes_real t31 = B_1_x*D_p_ry_1;
    const pkmodes_real U_1_z_1 = B_1_y*D_p_rx_1 + D_p_z_1 - t31;
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
    const pkmodes_real t38 = B_2_y*D_p_rz_2;
    const pkmodes_real U_2_x_2 = B_2_z*D_p_ry_2 + D_p_x_2 - t38;
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
    const pkmodes_real U_2_y_2 = D_p_y_2 + t44;
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
    const pkmodes_real t50 = B_2_x*D_p_ry_2;
    const pkmodes_real U_2_z_2 = B_2_y*D_p_rx_2 + D_p_z_2 - t50;
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
    const pkmodes_real t57 = B_3_y*D_p_rz_3;
    const pkmodes_real U_3_x_3 = B_3_z*D_p_ry_3 + D_p_x_3 - t57;
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
    const pkmodes_real U_3_y_3 = D_p_y_3 + t63;
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
    const pkmodes_real t69 = B_3_x*D_p_ry_3;
    const pkmodes_real U_3_z_3 = B_3_y*D_p_rx_3 + D_p_z_3 - t69;
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
    const pkmodes_real t76 = B_4_y*D_p_rz_4;
    const pkmodes_real U_4_x_4 = B_4_z*D_p_ry_4 + D_p_x_4 - t76;
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
    const pkmodes_real U_4_y_4 = D_p_y_4 + t82;
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
    const pkmodes_real t88 = B_4_x*D_p_ry_4;
    const pkmodes_real U_4_z_4 = B_4_y*D_p_rx_4 + D_p_z_4 - t88;
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
    const pkmodes_real t95 = B_5_y*D_p_rz_5;
    const pkmodes_real U_5_x_5 = B_5_z*D_p_ry_5 + D_p_x_5 - t95;
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
    const pkmodes_real U_5_y_5 = D_p_y_5 + t101;
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
    const pkmodes_real t107 = B_5_x*D_p_ry_5;
    const pkmodes_real U_5_z_5 = B_5_y*D_p_rx_5 + D_p_z_5 - t107;
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
    const pkmodes_real t114 = B_6_y*D_p_rz_6;
    const pkmodes_real U_6_x_6 = B_6_z*D_p_ry_6 + D_p_x_6 - t114;
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
    const pkmodes_real U_6_y_6 = D_p_y_6 + t120;
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
    const pkmodes_real t126 = B_6_x*D_p_ry_6;
    const pkmodes_real U_6_z_6 = B_6_y*D_p_rx_6 + D_p_z_6 - t126;
    const pkmodes_real t127 = B_1_y*D_p_rx_1 - t31;
    const pkmodes_real t128 = B_1_z*D_p_ry_1 - t19;
    const pkmodes_real f_1_11 =
        -(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1) - d_1_x*(D_p_ry_1*t127 - D_p_rz_1*t25)
        - d_1_y*(-D_p_rx_1*t127 + D_p_rz_1*t128) - d_1_z*(D_p_rx_1*t25 - D_p_ry_1*t128) + 1;
    const pkmodes_real t129 = B_2_y*D_p_rx_1 - t49;
    const pkmodes_real t130 = B_2_z*D_p_ry_1 - t37;
    const pkmodes_real f_2_11 =
        -(U_2_x_1*U_2_x_1) - (U_2_y_1*U_2_y_1) - (U_2_z_1*U_2_z_1) - d_2_x*(D_p_ry_1*t129 - D_p_rz_1*t43)
        - d_2_y*(-D_p_rx_1*t129 + D_p_rz_1*t130) - d_2_z*(D_p_rx_1*t43 - D_p_ry_1*t130);
    const pkmodes_real t131 = B_3_y*D_p_rx_1 - t67;
    const pkmodes_real t132 = B_3_z*D_p_ry_1 - t55;
    const pkmodes_real f_3_11 =
        -(U_3_x_1*U_3_x_1) - (U_3_y_1*U_3_y_1) - (U_3_z_1*U_3_z_1) - d_3_x*(D_p_ry_1*t131 - D_p_rz_1*t61)
        - d_3_y*(-D_p_rx_1*t131 + D_p_rz_1*t132) - d_3_z*(D_p_rx_1*t61 - D_p_ry_1*t132);
    const pkmodes_real t133 = B_4_y*D_p_rx_1 - t85;
    const pkmodes_real t134 = B_4_z*D_p_ry_1 - t73;
    const pkmodes_real f_4_11 =
        -(U_4_x_1*U_4_x_1) - (U_4_y_1*U_4_y_1) - (U_4_z_1*U_4_z_1) - d_4_x*(D_p_ry_1*t133 - D_p_rz_1*t79)
        - d_4_y*(-D_p_rx_1*t133 + D_p_rz_1*t134) - d_4_z*(D_p_rx_1*t79 - D_p_ry_1*t134);
    const pkmodes_real t135 = B_5_y*D_p_rx_1 - t103;
    const pkmodes_real t136 = B_5_z*D_p_ry_1 - t91;
    const pkmodes_real f_5_11 =
        -(U_5_x_1*U_5_x_1) - (U_5_y_1*U_5_y_1) - (U_5_z_1*U_5_z_1) - d_5_x*(D_p_ry_1*t135 - D_p_rz_1*t97)
        - d_5_y*(-D_p_rx_1*t135 + D_p_rz_1*t136) - d_5_z*(D_p_rx_1*t97 - D_p_ry_1*t136);
    const pkmodes_real t137 = B_6_y*D_p_rx_1 - t121;
    const pkmodes_real t138 = B_6_z*D_p_ry_1 - t109;
    const pkmodes_real f_6_11 =
        -(U_6_x_1*U_6_x_1) - (U_6_y_1*U_6_y_1) - (U_6_z_1*U_6_z_1) - d_6_x*(D_p_ry_1*t137 - D_p_rz_1*t115)
        - d_6_y*(-D_p_rx_1*t137 + D_p_rz_1*t138) - d_6_z*(D_p_rx_1*t115 - D_p_ry_1*t138);
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
    const pkmodes_real t139 = B_1_y*D_p_rx_2 - t32;
    const pkmodes_real t140 = (R(1.0)/R(2.0))*d_1_x;
    const pkmodes_real t141 = B_1_z*D_p_ry_2 - t20;
    const pkmodes_real t142 = (R(1.0)/R(2.0))*d_1_y;
    const pkmodes_real t143 = (R(1.0)/R(2.0))*d_1_z;
    const pkmodes_real f_1_12 =
        -U_1_x_1*U_1_x_2 - U_1_y_1*U_1_y_2 - U_1_z_1*U_1_z_2 - t140*(D_p_ry_1*t139 - D_p_rz_1*t26)
        - t140*(D_p_ry_2*t127 - D_p_rz_2*t25) - t142*(-D_p_rx_1*t139 + D_p_rz_1*t141) - t142*(-D_p_rx_2*t127
        + D_p_rz_2*t128) - t143*(D_p_rx_1*t26 - D_p_ry_1*t141) - t143*(D_p_rx_2*t25 - D_p_ry_2*t128);
    const pkmodes_real t144 = B_2_y*D_p_rx_2 - t50;
    const pkmodes_real t145 = (R(1.0)/R(2.0))*d_2_x;
    const pkmodes_real t146 = B_2_z*D_p_ry_2 - t38;
    const pkmodes_real t147 = (R(1.0)/R(2.0))*d_2_y;
    const pkmodes_real t148 = (R(1.0)/R(2.0))*d_2_z;
    const pkmodes_real f_2_12 =
        -U_2_x_1*U_2_x_2 - U_2_y_1*U_2_y_2 - U_2_z_1*U_2_z_2 - t145*(D_p_ry_1*t144 - D_p_rz_1*t44)
        - t145*(D_p_ry_2*t129 - D_p_rz_2*t43) - t147*(-D_p_rx_1*t144 + D_p_rz_1*t146) - t147*(-D_p_rx_2*t129
        + D_p_rz_2*t130) - t148*(D_p_rx_1*t44 - D_p_ry_1*t146) - t148*(D_p_rx_2*t43 - D_p_ry_2*t130);
    const pkmodes_real t149 = B_3_y*D_p_rx_2 - t68;
    const pkmodes_real t150 = (R(1.0)/R(2.0))*d_3_x;
    const pkmodes_real t151 = B_3_z*D_p_ry_2 - t56;
    const pkmodes_real t152 = (R(1.0)/R(2.0))*d_3_y;
    const pkmodes_real t153 = (R(1.0)/R(2.0))*d_3_z;
    const pkmodes_real f_3_12 =
        -U_3_x_1*U_3_x_2 - U_3_y_1*U_3_y_2 - U_3_z_1*U_3_z_2 - t150*(D_p_ry_1*t149 - D_p_rz_1*t62)
        - t150*(D_p_ry_2*t131 - D_p_rz_2*t61) - t152*(-D_p_rx_1*t149 + D_p_rz_1*t151) - t152*(-D_p_rx_2*t131
        + D_p_rz_2*t132) - t153*(D_p_rx_1*t62 - D_p_ry_1*t151) - t153*(D_p_rx_2*t61 - D_p_ry_2*t132);
    const pkmodes_real t154 = B_4_y*D_p_rx_2 - t86;
    const pkmodes_real t155 = (R(1.0)/R(2.0))*d_4_x;
    const pkmodes_real t156 = B_4_z*D_p_ry_2 - t74;
    const pkmodes_real t157 = (R(1.0)/R(2.0))*d_4_y;
    const pkmodes_real t158 = (R(1.0)/R(2.0))*d_4_z;
    const pkmodes_real f_4_12 =
        -U_4_x_1*U_4_x_2 - U_4_y_1*U_4_y_2 - U_4_z_1*U_4_z_2 - t155*(D_p_ry_1*t154 - D_p_rz_1*t80)
        - t155*(D_p_ry_2*t133 - D_p_rz_2*t79) - t157*(-D_p_rx_1*t154 + D_p_rz_1*t156) - t157*(-D_p_rx_2*t133
        + D_p_rz_2*t134) - t158*(D_p_rx_1*t80 - D_p_ry_1*t156) - t158*(D_p_rx_2*t79 - D_p_ry_2*t134);
    const pkmodes_real t159 = B_5_y*D_p_rx_2 - t104;
    const pkmodes_real t160 = (R(1.0)/R(2.0))*d_5_x;
    const pkmodes_real t161 = B_5_z*D_p_ry_2 - t92;
    const pkmodes_real t162 = (R(1.0)/R(2.0))*d_5_y;
    const pkmodes_real t163 = (R(1.0)/R(2.0))*d_5_z;
    const pkmodes_real f_5_12 =
        -U_5_x_1*U_5_x_2 - U_5_y_1*U_5_y_2 - U_5_z_1*U_5_z_2 - t160*(D_p_ry_1*t159 - D_p_rz_1*t98)
        - t160*(D_p_ry_2*t135 - D_p_rz_2*t97) - t162*(-D_p_rx_1*t159 + D_p_rz_1*t161) - t162*(-D_p_rx_2*t135
        + D_p_rz_2*t136) - t163*(D_p_rx_1*t98 - D_p_ry_1*t161) - t163*(D_p_rx_2*t97 - D_p_ry_2*t136);
    const pkmodes_real t164 = B_6_y*D_p_rx_2 - t122;
    const pkmodes_real t165 = (R(1.0)/R(2.0))*d_6_x;
    const pkmodes_real t166 = B_6_z*D_p_ry_2 - t110;
    const pkmodes_real t167 = (R(1.0)/R(2.0))*d_6_y;
    const pkmodes_real t168 = (R(1.0)/R(2.0))*d_6_z;
    const pkmodes_real f_6_12 =
        -U_6_x_1*U_6_x_2 - U_6_y_1*U_6_y_2 - U_6_z_1*U_6_z_2 - t165*(D_p_ry_1*t164 - D_p_rz_1*t116)
        - t165*(D_p_ry_2*t137 - D_p_rz_2*t115) - t167*(-D_p_rx_1*t164 + D_p_rz_1*t166) - t167*(-D_p_rx_2*t137
        + D_p_rz_2*t138) - t168*(D_p_rx_1*t116 - D_p_ry_1*t166) - t168*(D_p_rx_2*t115 - D_p_ry_2*t138);
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
    const pkmodes_real t169 = B_1_y*D_p_rx_3 - t33;
    const pkmodes_real t170 = B_1_z*D_p_ry_3 - t21;
    const pkmodes_real f_1_13 =
        -U_1_x_1*U_1_x_3 - U_1_y_1*U_1_y_3 - U_1_z_1*U_1_z_3 - t140*(D_p_ry_1*t169 - D_p_rz_1*t27)
        - t140*(D_p_ry_3*t127 - D_p_rz_3*t25) - t142*(-D_p_rx_1*t169 + D_p_rz_1*t170) - t142*(-D_p_rx_3*t127
        + D_p_rz_3*t128) - t143*(D_p_rx_1*t27 - D_p_ry_1*t170) - t143*(D_p_rx_3*t25 - D_p_ry_3*t128);
    const pkmodes_real t171 = B_2_y*D_p_rx_3 - t51;
    const pkmodes_real t172 = B_2_z*D_p_ry_3 - t39;
    const pkmodes_real f_2_13 =
        -U_2_x_1*U_2_x_3 - U_2_y_1*U_2_y_3 - U_2_z_1*U_2_z_3 - t145*(D_p_ry_1*t171 - D_p_rz_1*t45)
        - t145*(D_p_ry_3*t129 - D_p_rz_3*t43) - t147*(-D_p_rx_1*t171 + D_p_rz_1*t172) - t147*(-D_p_rx_3*t129
        + D_p_rz_3*t130) - t148*(D_p_rx_1*t45 - D_p_ry_1*t172) - t148*(D_p_rx_3*t43 - D_p_ry_3*t130);
    const pkmodes_real t173 = B_3_y*D_p_rx_3 - t69;
    const pkmodes_real t174 = B_3_z*D_p_ry_3 - t57;
    const pkmodes_real f_3_13 =
        -U_3_x_1*U_3_x_3 - U_3_y_1*U_3_y_3 - U_3_z_1*U_3_z_3 - t150*(D_p_ry_1*t173 - D_p_rz_1*t63)
        - t150*(D_p_ry_3*t131 - D_p_rz_3*t61) - t152*(-D_p_rx_1*t173 + D_p_rz_1*t174) - t152*(-D_p_rx_3*t131
        + D_p_rz_3*t132) - t153*(D_p_rx_1*t63 - D_p_ry_1*t174) - t153*(D_p_rx_3*t61 - D_p_ry_3*t132);
    const pkmodes_real t175 = B_4_y*D_p_rx_3 - t87;
    const pkmodes_real t176 = B_4_z*D_p_ry_3 - t75;
    const pkmodes_real f_4_13 =
        -U_4_x_1*U_4_x_3 - U_4_y_1*U_4_y_3 - U_4_z_1*U_4_z_3 - t155*(D_p_ry_1*t175 - D_p_rz_1*t81)
        - t155*(D_p_ry_3*t133 - D_p_rz_3*t79) - t157*(-D_p_rx_1*t175 + D_p_rz_1*t176) - t157*(-D_p_rx_3*t133
        + D_p_rz_3*t134) - t158*(D_p_rx_1*t81 - D_p_ry_1*t176) - t158*(D_p_rx_3*t79 - D_p_ry_3*t134);
    const pkmodes_real t177 = B_5_y*D_p_rx_3 - t105;
    const pkmodes_real t178 = B_5_z*D_p_ry_3 - t93;
    const pkmodes_real f_5_13 =
        -U_5_x_1*U_5_x_3 - U_5_y_1*U_5_y_3 - U_5_z_1*U_5_z_3 - t160*(D_p_ry_1*t177 - D_p_rz_1*t99)
        - t160*(D_p_ry_3*t135 - D_p_rz_3*t97) - t162*(-D_p_rx_1*t177 + D_p_rz_1*t178) - t162*(-D_p_rx_3*t135
        + D_p_rz_3*t136) - t163*(D_p_rx_1*t99 - D_p_ry_1*t178) - t163*(D_p_rx_3*t97 - D_p_ry_3*t136);
    const pkmodes_real t179 = B_6_y*D_p_rx_3 - t123;
    const pkmodes_real t180 = B_6_z*D_p_ry_3 - t111;
    const pkmodes_real f_6_13 =
        -U_6_x_1*U_6_x_3 - U_6_y_1*U_6_y_3 - U_6_z_1*U_6_z_3 - t165*(D_p_ry_1*t179 - D_p_rz_1*t117)
        - t165*(D_p_ry_3*t137 - D_p_rz_3*t115) - t167*(-D_p_rx_1*t179 + D_p_rz_1*t180) - t167*(-D_p_rx_3*t137
        + D_p_rz_3*t138) - t168*(D_p_rx_1*t117 - D_p_ry_1*t180) - t168*(D_p_rx_3*t115 - D_p_ry_3*t138);
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
    const pkmodes_real t181 = B_1_y*D_p_rx_4 - t34;
    const pkmodes_real t182 = B_1_z*D_p_ry_4 - t22;
    const pkmodes_real f_1_14 =
        -U_1_x_1*U_1_x_4 - U_1_y_1*U_1_y_4 - U_1_z_1*U_1_z_4 - t140*(D_p_ry_1*t181 - D_p_rz_1*t28)
        - t140*(D_p_ry_4*t127 - D_p_rz_4*t25) - t142*(-D_p_rx_1*t181 + D_p_rz_1*t182) - t142*(-D_p_rx_4*t127
        + D_p_rz_4*t128) - t143*(D_p_rx_1*t28 - D_p_ry_1*t182) - t143*(D_p_rx_4*t25 - D_p_ry_4*t128);
    const pkmodes_real t183 = B_2_y*D_p_rx_4 - t52;
    const pkmodes_real t184 = B_2_z*D_p_ry_4 - t40;
    const pkmodes_real f_2_14 =
        -U_2_x_1*U_2_x_4 - U_2_y_1*U_2_y_4 - U_2_z_1*U_2_z_4 - t145*(D_p_ry_1*t183 - D_p_rz_1*t46)
        - t145*(D_p_ry_4*t129 - D_p_rz_4*t43) - t147*(-D_p_rx_1*t183 + D_p_rz_1*t184) - t147*(-D_p_rx_4*t129
        + D_p_rz_4*t130) - t148*(D_p_rx_1*t46 - D_p_ry_1*t184) - t148*(D_p_rx_4*t43 - D_p_ry_4*t130);
    const pkmodes_real t185 = B_3_y*D_p_rx_4 - t70;
    const pkmodes_real t186 = B_3_z*D_p_ry_4 - t58;
    const pkmodes_real f_3_14 =
        -U_3_x_1*U_3_x_4 - U_3_y_1*U_3_y_4 - U_3_z_1*U_3_z_4 - t150*(D_p_ry_1*t185 - D_p_rz_1*t64)
        - t150*(D_p_ry_4*t131 - D_p_rz_4*t61) - t152*(-D_p_rx_1*t185 + D_p_rz_1*t186) - t152*(-D_p_rx_4*t131
        + D_p_rz_4*t132) - t153*(D_p_rx_1*t64 - D_p_ry_1*t186) - t153*(D_p_rx_4*t61 - D_p_ry_4*t132);
    const pkmodes_real t187 = B_4_y*D_p_rx_4 - t88;
    const pkmodes_real t188 = B_4_z*D_p_ry_4 - t76;
    const pkmodes_real f_4_14 =
        -U_4_x_1*U_4_x_4 - U_4_y_1*U_4_y_4 - U_4_z_1*U_4_z_4 - t155*(D_p_ry_1*t187 - D_p_rz_1*t82)
        - t155*(D_p_ry_4*t133 - D_p_rz_4*t79) - t157*(-D_p_rx_1*t187 + D_p_rz_1*t188) - t157*(-D_p_rx_4*t133
        + D_p_rz_4*t134) - t158*(D_p_rx_1*t82 - D_p_ry_1*t188) - t158*(D_p_rx_4*t79 - D_p_ry_4*t134);
    const pkmodes_real t189 = B_5_y*D_p_rx_4 - t106;
    const pkmodes_real t190 = B_5_z*D_p_ry_4 - t94;
    const pkmodes_real f_5_14 =
        -U_5_x_1*U_5_x_4 - U_5_y_1*U_5_y_4 - U_5_z_1*U_5_z_4 - t160*(D_p_ry_1*t189 - D_p_rz_1*t100)
        - t160*(D_p_ry_4*t135 - D_p_rz_4*t97) - t162*(-D_p_rx_1*t189 + D_p_rz_1*t190) - t162*(-D_p_rx_4*t135
        + D_p_rz_4*t136) - t163*(D_p_rx_1*t100 - D_p_ry_1*t190) - t163*(D_p_rx_4*t97 - D_p_ry_4*t136);
    const pkmodes_real t191 = B_6_y*D_p_rx_4 - t124;
    const pkmodes_real t192 = B_6_z*D_p_ry_4 - t112;
    const pkmodes_real f_6_14 =
        -U_6_x_1*U_6_x_4 - U_6_y_1*U_6_y_4 - U_6_z_1*U_6_z_4 - t165*(D_p_ry_1*t191 - D_p_rz_1*t118)
        - t165*(D_p_ry_4*t137 - D_p_rz_4*t115) - t167*(-D_p_rx_1*t191 + D_p_rz_1*t192) - t167*(-D_p_rx_4*t137
        + D_p_rz_4*t138) - t168*(D_p_rx_1*t118 - D_p_ry_1*t192) - t168*(D_p_rx_4*t115 - D_p_ry_4*t138);
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
    const pkmodes_real t193 = B_1_y*D_p_rx_5 - t35;
    const pkmodes_real t194 = B_1_z*D_p_ry_5 - t23;
    const pkmodes_real f_1_15 =
        -U_1_x_1*U_1_x_5 - U_1_y_1*U_1_y_5 - U_1_z_1*U_1_z_5 - t140*(D_p_ry_1*t193 - D_p_rz_1*t29)
        - t140*(D_p_ry_5*t127 - D_p_rz_5*t25) - t142*(-D_p_rx_1*t193 + D_p_rz_1*t194) - t142*(-D_p_rx_5*t127
        + D_p_rz_5*t128) - t143*(D_p_rx_1*t29 - D_p_ry_1*t194) - t143*(D_p_rx_5*t25 - D_p_ry_5*t128);
    const pkmodes_real t195 = B_2_y*D_p_rx_5 - t53;
    const pkmodes_real t196 = B_2_z*D_p_ry_5 - t41;
    const pkmodes_real f_2_15 =
        -U_2_x_1*U_2_x_5 - U_2_y_1*U_2_y_5 - U_2_z_1*U_2_z_5 - t145*(D_p_ry_1*t195 - D_p_rz_1*t47)
        - t145*(D_p_ry_5*t129 - D_p_rz_5*t43) - t147*(-D_p_rx_1*t195 + D_p_rz_1*t196) - t147*(-D_p_rx_5*t129
        + D_p_rz_5*t130) - t148*(D_p_rx_1*t47 - D_p_ry_1*t196) - t148*(D_p_rx_5*t43 - D_p_ry_5*t130);
    const pkmodes_real t197 = B_3_y*D_p_rx_5 - t71;
    const pkmodes_real t198 = B_3_z*D_p_ry_5 - t59;
    const pkmodes_real f_3_15 =
        -U_3_x_1*U_3_x_5 - U_3_y_1*U_3_y_5 - U_3_z_1*U_3_z_5 - t150*(D_p_ry_1*t197 - D_p_rz_1*t65)
        - t150*(D_p_ry_5*t131 - D_p_rz_5*t61) - t152*(-D_p_rx_1*t197 + D_p_rz_1*t198) - t152*(-D_p_rx_5*t131
        + D_p_rz_5*t132) - t153*(D_p_rx_1*t65 - D_p_ry_1*t198) - t153*(D_p_rx_5*t61 - D_p_ry_5*t132);
    const pkmodes_real t199 = B_4_y*D_p_rx_5 - t89;
    const pkmodes_real t200 = B_4_z*D_p_ry_5 - t77;
    const pkmodes_real f_4_15 =
        -U_4_x_1*U_4_x_5 - U_4_y_1*U_4_y_5 - U_4_z_1*U_4_z_5 - t155*(D_p_ry_1*t199 - D_p_rz_1*t83)
        - t155*(D_p_ry_5*t133 - D_p_rz_5*t79) - t157*(-D_p_rx_1*t199 + D_p_rz_1*t200) - t157*(-D_p_rx_5*t133
        + D_p_rz_5*t134) - t158*(D_p_rx_1*t83 - D_p_ry_1*t200) - t158*(D_p_rx_5*t79 - D_p_ry_5*t134);
    const pkmodes_real t201 = B_5_y*D_p_rx_5 - t107;
    const pkmodes_real t202 = B_5_z*D_p_ry_5 - t95;
    const pkmodes_real f_5_15 =
        -U_5_x_1*U_5_x_5 - U_5_y_1*U_5_y_5 - U_5_z_1*U_5_z_5 - t160*(D_p_ry_1*t201 - D_p_rz_1*t101)
        - t160*(D_p_ry_5*t135 - D_p_rz_5*t97) - t162*(-D_p_rx_1*t201 + D_p_rz_1*t202) - t162*(-D_p_rx_5*t135
        + D_p_rz_5*t136) - t163*(D_p_rx_1*t101 - D_p_ry_1*t202) - t163*(D_p_rx_5*t97 - D_p_ry_5*t136);
    const pkmodes_real t203 = B_6_y*D_p_rx_5 - t125;
    const pkmodes_real t204 = B_6_z*D_p_ry_5 - t113;
    const pkmodes_real f_6_15 =
        -U_6_x_1*U_6_x_5 - U_6_y_1*U_6_y_5 - U_6_z_1*U_6_z_5 - t165*(D_p_ry_1*t203 - D_p_rz_1*t119)
        - t165*(D_p_ry_5*t137 - D_p_rz_5*t115) - t167*(-D_p_rx_1*t203 + D_p_rz_1*t204) - t167*(-D_p_rx_5*t137
        + D_p_rz_5*t138) - t168*(D_p_rx_1*t119 - D_p_ry_1*t204) - t168*(D_p_rx_5*t115 - D_p_ry_5*t138);
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
    const pkmodes_real t205 = B_1_y*D_p_rx_6 - t36;
    const pkmodes_real t206 = B_1_z*D_p_ry_6 - t24;
    const pkmodes_real f_1_16 =
        -U_1_x_1*U_1_x_6 - U_1_y_1*U_1_y_6 - U_1_z_1*U_1_z_6 - t140*(D_p_ry_1*t205 - D_p_rz_1*t30)
        - t140*(D_p_ry_6*t127 - D_p_rz_6*t25) - t142*(-D_p_rx_1*t205 + D_p_rz_1*t206) - t142*(-D_p_rx_6*t127
        + D_p_rz_6*t128) - t143*(D_p_rx_1*t30 - D_p_ry_1*t206) - t143*(D_p_rx_6*t25 - D_p_ry_6*t128);
    const pkmodes_real t207 = B_2_y*D_p_rx_6 - t54;
    const pkmodes_real t208 = B_2_z*D_p_ry_6 - t42;
    const pkmodes_real f_2_16 =
        -U_2_x_1*U_2_x_6 - U_2_y_1*U_2_y_6 - U_2_z_1*U_2_z_6 - t145*(D_p_ry_1*t207 - D_p_rz_1*t48)
        - t145*(D_p_ry_6*t129 - D_p_rz_6*t43) - t147*(-D_p_rx_1*t207 + D_p_rz_1*t208) - t147*(-D_p_rx_6*t129
        + D_p_rz_6*t130) - t148*(D_p_rx_1*t48 - D_p_ry_1*t208) - t148*(D_p_rx_6*t43 - D_p_ry_6*t130);
    const pkmodes_real t209 = B_3_y*D_p_rx_6 - t72;
    const pkmodes_real t210 = B_3_z*D_p_ry_6 - t60;
    const pkmodes_real f_3_16 =
        -U_3_x_1*U_3_x_6 - U_3_y_1*U_3_y_6 - U_3_z_1*U_3_z_6 - t150*(D_p_ry_1*t209 - D_p_rz_1*t66)
        - t150*(D_p_ry_6*t131 - D_p_rz_6*t61) - t152*(-D_p_rx_1*t209 + D_p_rz_1*t210) - t152*(-D_p_rx_6*t131
        + D_p_rz_6*t132) - t153*(D_p_rx_1*t66 - D_p_ry_1*t210) - t153*(D_p_rx_6*t61 - D_p_ry_6*t132);
    const pkmodes_real t211 = B_4_y*D_p_rx_6 - t90;
    const pkmodes_real t212 = B_4_z*D_p_ry_6 - t78;
    const pkmodes_real f_4_16 =
        -U_4_x_1*U_4_x_6 - U_4_y_1*U_4_y_6 - U_4_z_1*U_4_z_6 - t155*(D_p_ry_1*t211 - D_p_rz_1*t84)
        - t155*(D_p_ry_6*t133 - D_p_rz_6*t79) - t157*(-D_p_rx_1*t211 + D_p_rz_1*t212) - t157*(-D_p_rx_6*t133
        + D_p_rz_6*t134) - t158*(D_p_rx_1*t84 - D_p_ry_1*t212) - t158*(D_p_rx_6*t79 - D_p_ry_6*t134);
    const pkmodes_real t213 = B_5_y*D_p_rx_6 - t108;
    const pkmodes_real t214 = B_5_z*D_p_ry_6 - t96;
    const pkmodes_real f_5_16 =
        -U_5_x_1*U_5_x_6 - U_5_y_1*U_5_y_6 - U_5_z_1*U_5_z_6 - t160*(D_p_ry_1*t213 - D_p_rz_1*t102)
        - t160*(D_p_ry_6*t135 - D_p_rz_6*t97) - t162*(-D_p_rx_1*t213 + D_p_rz_1*t214) - t162*(-D_p_rx_6*t135
        + D_p_rz_6*t136) - t163*(D_p_rx_1*t102 - D_p_ry_1*t214) - t163*(D_p_rx_6*t97 - D_p_ry_6*t136);
    const pkmodes_real t215 = B_6_y*D_p_rx_6 - t126;
    const pkmodes_real t216 = B_6_z*D_p_ry_6 - t114;
    const pkmodes_real f_6_16 =
        -U_6_x_1*U_6_x_6 - U_6_y_1*U_6_y_6 - U_6_z_1*U_6_z_6 - t165*(D_p_ry_1*t215 - D_p_rz_1*t120)
        - t165*(D_p_ry_6*t137 - D_p_rz_6*t115) - t167*(-D_p_rx_1*t215 + D_p_rz_1*t216) - t167*(-D_p_rx_6*t137
        + D_p_rz_6*t138) - t168*(D_p_rx_1*t120 - D_p_ry_1*t216) - t168*(D_p_rx_6*t115 - D_p_ry_6*t138);
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
        -(U_1_x_2*U_1_x_2) - (U_1_y_2*U_1_y_2) - (U_1_z_2*U_1_z_2) - d_1_x*(D_p_ry_2*t139 - D_p_rz_2*t26)
        - d_1_y*(-D_p_rx_2*t139 + D_p_rz_2*t141) - d_1_z*(D_p_rx_2*t26 - D_p_ry_2*t141);
    const pkmodes_real f_2_22 =
        -(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2) - d_2_x*(D_p_ry_2*t144 - D_p_rz_2*t44)
        - d_2_y*(-D_p_rx_2*t144 + D_p_rz_2*t146) - d_2_z*(D_p_rx_2*t44 - D_p_ry_2*t146) + 1;
    const pkmodes_real f_3_22 =
        -(U_3_x_2*U_3_x_2) - (U_3_y_2*U_3_y_2) - (U_3_z_2*U_3_z_2) - d_3_x*(D_p_ry_2*t149 - D_p_rz_2*t62)
        - d_3_y*(-D_p_rx_2*t149 + D_p_rz_2*t151) - d_3_z*(D_p_rx_2*t62 - D_p_ry_2*t151);
    const pkmodes_real f_4_22 =
        -(U_4_x_2*U_4_x_2) - (U_4_y_2*U_4_y_2) - (U_4_z_2*U_4_z_2) - d_4_x*(D_p_ry_2*t154 - D_p_rz_2*t80)
        - d_4_y*(-D_p_rx_2*t154 + D_p_rz_2*t156) - d_4_z*(D_p_rx_2*t80 - D_p_ry_2*t156);
    const pkmodes_real f_5_22 =
        -(U_5_x_2*U_5_x_2) - (U_5_y_2*U_5_y_2) - (U_5_z_2*U_5_z_2) - d_5_x*(D_p_ry_2*t159 - D_p_rz_2*t98)
        - d_5_y*(-D_p_rx_2*t159 + D_p_rz_2*t161) - d_5_z*(D_p_rx_2*t98 - D_p_ry_2*t161);
    const pkmodes_real f_6_22 =
        -(U_6_x_2*U_6_x_2) - (U_6_y_2*U_6_y_2) - (U_6_z_2*U_6_z_2) - d_6_x*(D_p_ry_2*t164 - D_p_rz_2*t116)
        - d_6_y*(-D_p_rx_2*t164 + D_p_rz_2*t166) - d_6_z*(D_p_rx_2*t116 - D_p_ry_2*t166);
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
        -U_1_x_2*U_1_x_3 - U_1_y_2*U_1_y_3 - U_1_z_2*U_1_z_3 - t140*(D_p_ry_2*t169 - D_p_rz_2*t27)
        - t140*(D_p_ry_3*t139 - D_p_rz_3*t26) - t142*(-D_p_rx_2*t169 + D_p_rz_2*t170) - t142*(-D_p_rx_3*t139
        + D_p_rz_3*t141) - t143*(D_p_rx_2*t27 - D_p_ry_2*t170) - t143*(D_p_rx_3*t26 - D_p_ry_3*t141);
    const pkmodes_real f_2_23 =
        -U_2_x_2*U_2_x_3 - U_2_y_2*U_2_y_3 - U_2_z_2*U_2_z_3 - t145*(D_p_ry_2*t171 - D_p_rz_2*t45)
        - t145*(D_p_ry_3*t144 - D_p_rz_3*t44) - t147*(-D_p_rx_2*t171 + D_p_rz_2*t172) - t147*(-D_p_rx_3*t144
        + D_p_rz_3*t146) - t148*(D_p_rx_2*t45 - D_p_ry_2*t172) - t148*(D_p_rx_3*t44 - D_p_ry_3*t146);
    const pkmodes_real f_3_23 =
        -U_3_x_2*U_3_x_3 - U_3_y_2*U_3_y_3 - U_3_z_2*U_3_z_3 - t150*(D_p_ry_2*t173 - D_p_rz_2*t63)
        - t150*(D_p_ry_3*t149 - D_p_rz_3*t62) - t152*(-D_p_rx_2*t173 + D_p_rz_2*t174) - t152*(-D_p_rx_3*t149
        + D_p_rz_3*t151) - t153*(D_p_rx_2*t63 - D_p_ry_2*t174) - t153*(D_p_rx_3*t62 - D_p_ry_3*t151);
    const pkmodes_real f_4_23 =
        -U_4_x_2*U_4_x_3 - U_4_y_2*U_4_y_3 - U_4_z_2*U_4_z_3 - t155*(D_p_ry_2*t175 - D_p_rz_2*t81)
        - t155*(D_p_ry_3*t154 - D_p_rz_3*t80) - t157*(-D_p_rx_2*t175 + D_p_rz_2*t176) - t157*(-D_p_rx_3*t154
        + D_p_rz_3*t156) - t158*(D_p_rx_2*t81 - D_p_ry_2*t176) - t158*(D_p_rx_3*t80 - D_p_ry_3*t156);
    const pkmodes_real f_5_23 =
        -U_5_x_2*U_5_x_3 - U_5_y_2*U_5_y_3 - U_5_z_2*U_5_z_3 - t160*(D_p_ry_2*t177 - D_p_rz_2*t99)
        - t160*(D_p_ry_3*t159 - D_p_rz_3*t98) - t162*(-D_p_rx_2*t177 + D_p_rz_2*t178) - t162*(-D_p_rx_3*t159
        + D_p_rz_3*t161) - t163*(D_p_rx_2*t99 - D_p_ry_2*t178) - t163*(D_p_rx_3*t98 - D_p_ry_3*t161);
    const pkmodes_real f_6_23 =
        -U_6_x_2*U_6_x_3 - U_6_y_2*U_6_y_3 - U_6_z_2*U_6_z_3 - t165*(D_p_ry_2*t179 - D_p_rz_2*t117)
        - t165*(D_p_ry_3*t164 - D_p_rz_3*t116) - t167*(-D_p_rx_2*t179 + D_p_rz_2*t180) - t167*(-D_p_rx_3*t164
        + D_p_rz_3*t166) - t168*(D_p_rx_2*t117 - D_p_ry_2*t180) - t168*(D_p_rx_3*t116 - D_p_ry_3*t166);
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
        -U_1_x_2*U_1_x_4 - U_1_y_2*U_1_y_4 - U_1_z_2*U_1_z_4 - t140*(D_p_ry_2*t181 - D_p_rz_2*t28)
        - t140*(D_p_ry_4*t139 - D_p_rz_4*t26) - t142*(-D_p_rx_2*t181 + D_p_rz_2*t182) - t142*(-D_p_rx_4*t139
        + D_p_rz_4*t141) - t143*(D_p_rx_2*t28 - D_p_ry_2*t182) - t143*(D_p_rx_4*t26 - D_p_ry_4*t141);
    const pkmodes_real f_2_24 =
        -U_2_x_2*U_2_x_4 - U_2_y_2*U_2_y_4 - U_2_z_2*U_2_z_4 - t145*(D_p_ry_2*t183 - D_p_rz_2*t46)
        - t145*(D_p_ry_4*t144 - D_p_rz_4*t44) - t147*(-D_p_rx_2*t183 + D_p_rz_2*t184) - t147*(-D_p_rx_4*t144
        + D_p_rz_4*t146) - t148*(D_p_rx_2*t46 - D_p_ry_2*t184) - t148*(D_p_rx_4*t44 - D_p_ry_4*t146);
    const pkmodes_real f_3_24 =
        -U_3_x_2*U_3_x_4 - U_3_y_2*U_3_y_4 - U_3_z_2*U_3_z_4 - t150*(D_p_ry_2*t185 - D_p_rz_2*t64)
        - t150*(D_p_ry_4*t149 - D_p_rz_4*t62) - t152*(-D_p_rx_2*t185 + D_p_rz_2*t186) - t152*(-D_p_rx_4*t149
        + D_p_rz_4*t151) - t153*(D_p_rx_2*t64 - D_p_ry_2*t186) - t153*(D_p_rx_4*t62 - D_p_ry_4*t151);
    const pkmodes_real f_4_24 =
        -U_4_x_2*U_4_x_4 - U_4_y_2*U_4_y_4 - U_4_z_2*U_4_z_4 - t155*(D_p_ry_2*t187 - D_p_rz_2*t82)
        - t155*(D_p_ry_4*t154 - D_p_rz_4*t80) - t157*(-D_p_rx_2*t187 + D_p_rz_2*t188) - t157*(-D_p_rx_4*t154
        + D_p_rz_4*t156) - t158*(D_p_rx_2*t82 - D_p_ry_2*t188) - t158*(D_p_rx_4*t80 - D_p_ry_4*t156);
    const pkmodes_real f_5_24 =
        -U_5_x_2*U_5_x_4 - U_5_y_2*U_5_y_4 - U_5_z_2*U_5_z_4 - t160*(D_p_ry_2*t189 - D_p_rz_2*t100)
        - t160*(D_p_ry_4*t159 - D_p_rz_4*t98) - t162*(-D_p_rx_2*t189 + D_p_rz_2*t190) - t162*(-D_p_rx_4*t159
        + D_p_rz_4*t161) - t163*(D_p_rx_2*t100 - D_p_ry_2*t190) - t163*(D_p_rx_4*t98 - D_p_ry_4*t161);
    const pkmodes_real f_6_24 =
        -U_6_x_2*U_6_x_4 - U_6_y_2*U_6_y_4 - U_6_z_2*U_6_z_4 - t165*(D_p_ry_2*t191 - D_p_rz_2*t118)
        - t165*(D_p_ry_4*t164 - D_p_rz_4*t116) - t167*(-D_p_rx_2*t191 + D_p_rz_2*t192) - t167*(-D_p_rx_4*t164
        + D_p_rz_4*t166) - t168*(D_p_rx_2*t118 - D_p_ry_2*t192) - t168*(D_p_rx_4*t116 - D_p_ry_4*t166);
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
        -U_1_x_2*U_1_x_5 - U_1_y_2*U_1_y_5 - U_1_z_2*U_1_z_5 - t140*(D_p_ry_2*t193 - D_p_rz_2*t29)
        - t140*(D_p_ry_5*t139 - D_p_rz_5*t26) - t142*(-D_p_rx_2*t193 + D_p_rz_2*t194) - t142*(-D_p_rx_5*t139
        + D_p_rz_5*t141) - t143*(D_p_rx_2*t29 - D_p_ry_2*t194) - t143*(D_p_rx_5*t26 - D_p_ry_5*t141);
    const pkmodes_real f_2_25 =
        -U_2_x_2*U_2_x_5 - U_2_y_2*U_2_y_5 - U_2_z_2*U_2_z_5 - t145*(D_p_ry_2*t195 - D_p_rz_2*t47)
        - t145*(D_p_ry_5*t144 - D_p_rz_5*t44) - t147*(-D_p_rx_2*t195 + D_p_rz_2*t196) - t147*(-D_p_rx_5*t144
        + D_p_rz_5*t146) - t148*(D_p_rx_2*t47 - D_p_ry_2*t196) - t148*(D_p_rx_5*t44 - D_p_ry_5*t146);
    const pkmodes_real f_3_25 =
        -U_3_x_2*U_3_x_5 - U_3_y_2*U_3_y_5 - U_3_z_2*U_3_z_5 - t150*(D_p_ry_2*t197 - D_p_rz_2*t65)
        - t150*(D_p_ry_5*t149 - D_p_rz_5*t62) - t152*(-D_p_rx_2*t197 + D_p_rz_2*t198) - t152*(-D_p_rx_5*t149
        + D_p_rz_5*t151) - t153*(D_p_rx_2*t65 - D_p_ry_2*t198) - t153*(D_p_rx_5*t62 - D_p_ry_5*t151);
    const pkmodes_real f_4_25 =
        -U_4_x_2*U_4_x_5 - U_4_y_2*U_4_y_5 - U_4_z_2*U_4_z_5 - t155*(D_p_ry_2*t199 - D_p_rz_2*t83)
        - t155*(D_p_ry_5*t154 - D_p_rz_5*t80) - t157*(-D_p_rx_2*t199 + D_p_rz_2*t200) - t157*(-D_p_rx_5*t154
        + D_p_rz_5*t156) - t158*(D_p_rx_2*t83 - D_p_ry_2*t200) - t158*(D_p_rx_5*t80 - D_p_ry_5*t156);
    const pkmodes_real f_5_25 =
        -U_5_x_2*U_5_x_5 - U_5_y_2*U_5_y_5 - U_5_z_2*U_5_z_5 - t160*(D_p_ry_2*t201 - D_p_rz_2*t101)
        - t160*(D_p_ry_5*t159 - D_p_rz_5*t98) - t162*(-D_p_rx_2*t201 + D_p_rz_2*t202) - t162*(-D_p_rx_5*t159
        + D_p_rz_5*t161) - t163*(D_p_rx_2*t101 - D_p_ry_2*t202) - t163*(D_p_rx_5*t98 - D_p_ry_5*t161);
    const pkmodes_real f_6_25 =
        -U_6_x_2*U_6_x_5 - U_6_y_2*U_6_y_5 - U_6_z_2*U_6_z_5 - t165*(D_p_ry_2*t203 - D_p_rz_2*t119)
        - t165*(D_p_ry_5*t164 - D_p_rz_5*t116) - t167*(-D_p_rx_2*t203 + D_p_rz_2*t204) - t167*(-D_p_rx_5*t164
        + D_p_rz_5*t166) - t168*(D_p_rx_2*t119 - D_p_ry_2*t204) - t168*(D_p_rx_5*t116 - D_p_ry_5*t166);
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
        -U_1_x_2*U_1_x_6 - U_1_y_2*U_1_y_6 - U_1_z_2*U_1_z_6 - t140*(D_p_ry_2*t205 - D_p_rz_2*t30)
        - t140*(D_p_ry_6*t139 - D_p_rz_6*t26) - t142*(-D_p_rx_2*t205 + D_p_rz_2*t206) - t142*(-D_p_rx_6*t139
        + D_p_rz_6*t141) - t143*(D_p_rx_2*t30 - D_p_ry_2*t206) - t143*(D_p_rx_6*t26 - D_p_ry_6*t141);
    const pkmodes_real f_2_26 =
        -U_2_x_2*U_2_x_6 - U_2_y_2*U_2_y_6 - U_2_z_2*U_2_z_6 - t145*(D_p_ry_2*t207 - D_p_rz_2*t48)
        - t145*(D_p_ry_6*t144 - D_p_rz_6*t44) - t147*(-D_p_rx_2*t207 + D_p_rz_2*t208) - t147*(-D_p_rx_6*t144
        + D_p_rz_6*t146) - t148*(D_p_rx_2*t48 - D_p_ry_2*t208) - t148*(D_p_rx_6*t44 - D_p_ry_6*t146);
    const pkmodes_real f_3_26 =
        -U_3_x_2*U_3_x_6 - U_3_y_2*U_3_y_6 - U_3_z_2*U_3_z_6 - t150*(D_p_ry_2*t209 - D_p_rz_2*t66)
        - t150*(D_p_ry_6*t149 - D_p_rz_6*t62) - t152*(-D_p_rx_2*t209 + D_p_rz_2*t210) - t152*(-D_p_rx_6*t149
        + D_p_rz_6*t151) - t153*(D_p_rx_2*t66 - D_p_ry_2*t210) - t153*(D_p_rx_6*t62 - D_p_ry_6*t151);
    const pkmodes_real f_4_26 =
        -U_4_x_2*U_4_x_6 - U_4_y_2*U_4_y_6 - U_4_z_2*U_4_z_6 - t155*(D_p_ry_2*t211 - D_p_rz_2*t84)
        - t155*(D_p_ry_6*t154 - D_p_rz_6*t80) - t157*(-D_p_rx_2*t211 + D_p_rz_2*t212) - t157*(-D_p_rx_6*t154
        + D_p_rz_6*t156) - t158*(D_p_rx_2*t84 - D_p_ry_2*t212) - t158*(D_p_rx_6*t80 - D_p_ry_6*t156);
    const pkmodes_real f_5_26 =
        -U_5_x_2*U_5_x_6 - U_5_y_2*U_5_y_6 - U_5_z_2*U_5_z_6 - t160*(D_p_ry_2*t213 - D_p_rz_2*t102)
        - t160*(D_p_ry_6*t159 - D_p_rz_6*t98) - t162*(-D_p_rx_2*t213 + D_p_rz_2*t214) - t162*(-D_p_rx_6*t159
        + D_p_rz_6*t161) - t163*(D_p_rx_2*t102 - D_p_ry_2*t214) - t163*(D_p_rx_6*t98 - D_p_ry_6*t161);
    const pkmodes_real f_6_26 =
        -U_6_x_2*U_6_x_6 - U_6_y_2*U_6_y_6 - U_6_z_2*U_6_z_6 - t165*(D_p_ry_2*t215 - D_p_rz_2*t120)
        - t165*(D_p_ry_6*t164 - D_p_rz_6*t116) - t167*(-D_p_rx_2*t215 + D_p_rz_2*t216) - t167*(-D_p_rx_6*t164
        + D_p_rz_6*t166) - t168*(D_p_rx_2*t120 - D_p_ry_2*t216) - t168*(D_p_rx_6*t116 - D_p_ry_6*t166);
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
        -(U_1_x_3*U_1_x_3) - (U_1_y_3*U_1_y_3) - (U_1_z_3*U_1_z_3) - d_1_x*(D_p_ry_3*t169 - D_p_rz_3*t27)
        - d_1_y*(-D_p_rx_3*t169 + D_p_rz_3*t170) - d_1_z*(D_p_rx_3*t27 - D_p_ry_3*t170);
    const pkmodes_real f_2_33 =
        -(U_2_x_3*U_2_x_3) - (U_2_y_3*U_2_y_3) - (U_2_z_3*U_2_z_3) - d_2_x*(D_p_ry_3*t171 - D_p_rz_3*t45)
        - d_2_y*(-D_p_rx_3*t171 + D_p_rz_3*t172) - d_2_z*(D_p_rx_3*t45 - D_p_ry_3*t172);
    const pkmodes_real f_3_33 =
        -(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3) - d_3_x*(D_p_ry_3*t173 - D_p_rz_3*t63)
        - d_3_y*(-D_p_rx_3*t173 + D_p_rz_3*t174) - d_3_z*(D_p_rx_3*t63 - D_p_ry_3*t174) + 1;
    const pkmodes_real f_4_33 =
        -(U_4_x_3*U_4_x_3) - (U_4_y_3*U_4_y_3) - (U_4_z_3*U_4_z_3) - d_4_x*(D_p_ry_3*t175 - D_p_rz_3*t81)
        - d_4_y*(-D_p_rx_3*t175 + D_p_rz_3*t176) - d_4_z*(D_p_rx_3*t81 - D_p_ry_3*t176);
    const pkmodes_real f_5_33 =
        -(U_5_x_3*U_5_x_3) - (U_5_y_3*U_5_y_3) - (U_5_z_3*U_5_z_3) - d_5_x*(D_p_ry_3*t177 - D_p_rz_3*t99)
        - d_5_y*(-D_p_rx_3*t177 + D_p_rz_3*t178) - d_5_z*(D_p_rx_3*t99 - D_p_ry_3*t178);
    const pkmodes_real f_6_33 =
        -(U_6_x_3*U_6_x_3) - (U_6_y_3*U_6_y_3) - (U_6_z_3*U_6_z_3) - d_6_x*(D_p_ry_3*t179 - D_p_rz_3*t117)
        - d_6_y*(-D_p_rx_3*t179 + D_p_rz_3*t180) - d_6_z*(D_p_rx_3*t117 - D_p_ry_3*t180);
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
        -U_1_x_3*U_1_x_4 - U_1_y_3*U_1_y_4 - U_1_z_3*U_1_z_4 - t140*(D_p_ry_3*t181 - D_p_rz_3*t28)
        - t140*(D_p_ry_4*t169 - D_p_rz_4*t27) - t142*(-D_p_rx_3*t181 + D_p_rz_3*t182) - t142*(-D_p_rx_4*t169
        + D_p_rz_4*t170) - t143*(D_p_rx_3*t28 - D_p_ry_3*t182) - t143*(D_p_rx_4*t27 - D_p_ry_4*t170);
    const pkmodes_real f_2_34 =
        -U_2_x_3*U_2_x_4 - U_2_y_3*U_2_y_4 - U_2_z_3*U_2_z_4 - t145*(D_p_ry_3*t183 - D_p_rz_3*t46)
        - t145*(D_p_ry_4*t171 - D_p_rz_4*t45) - t147*(-D_p_rx_3*t183 + D_p_rz_3*t184) - t147*(-D_p_rx_4*t171
        + D_p_rz_4*t172) - t148*(D_p_rx_3*t46 - D_p_ry_3*t184) - t148*(D_p_rx_4*t45 - D_p_ry_4*t172);
    const pkmodes_real f_3_34 =
        -U_3_x_3*U_3_x_4 - U_3_y_3*U_3_y_4 - U_3_z_3*U_3_z_4 - t150*(D_p_ry_3*t185 - D_p_rz_3*t64)
        - t150*(D_p_ry_4*t173 - D_p_rz_4*t63) - t152*(-D_p_rx_3*t185 + D_p_rz_3*t186) - t152*(-D_p_rx_4*t173
        + D_p_rz_4*t174) - t153*(D_p_rx_3*t64 - D_p_ry_3*t186) - t153*(D_p_rx_4*t63 - D_p_ry_4*t174);
    const pkmodes_real f_4_34 =
        -U_4_x_3*U_4_x_4 - U_4_y_3*U_4_y_4 - U_4_z_3*U_4_z_4 - t155*(D_p_ry_3*t187 - D_p_rz_3*t82)
        - t155*(D_p_ry_4*t175 - D_p_rz_4*t81) - t157*(-D_p_rx_3*t187 + D_p_rz_3*t188) - t157*(-D_p_rx_4*t175
        + D_p_rz_4*t176) - t158*(D_p_rx_3*t82 - D_p_ry_3*t188) - t158*(D_p_rx_4*t81 - D_p_ry_4*t176);
    const pkmodes_real f_5_34 =
        -U_5_x_3*U_5_x_4 - U_5_y_3*U_5_y_4 - U_5_z_3*U_5_z_4 - t160*(D_p_ry_3*t189 - D_p_rz_3*t100)
        - t160*(D_p_ry_4*t177 - D_p_rz_4*t99) - t162*(-D_p_rx_3*t189 + D_p_rz_3*t190) - t162*(-D_p_rx_4*t177
        + D_p_rz_4*t178) - t163*(D_p_rx_3*t100 - D_p_ry_3*t190) - t163*(D_p_rx_4*t99 - D_p_ry_4*t178);
    const pkmodes_real f_6_34 =
        -U_6_x_3*U_6_x_4 - U_6_y_3*U_6_y_4 - U_6_z_3*U_6_z_4 - t165*(D_p_ry_3*t191 - D_p_rz_3*t118)
        - t165*(D_p_ry_4*t179 - D_p_rz_4*t117) - t167*(-D_p_rx_3*t191 + D_p_rz_3*t192) - t167*(-D_p_rx_4*t179
        + D_p_rz_4*t180) - t168*(D_p_rx_3*t118 - D_p_ry_3*t192) - t168*(D_p_rx_4*t117 - D_p_ry_4*t180);
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
        -U_1_x_3*U_1_x_5 - U_1_y_3*U_1_y_5 - U_1_z_3*U_1_z_5 - t140*(D_p_ry_3*t193 - D_p_rz_3*t29)
        - t140*(D_p_ry_5*t169 - D_p_rz_5*t27) - t142*(-D_p_rx_3*t193 + D_p_rz_3*t194) - t142*(-D_p_rx_5*t169
        + D_p_rz_5*t170) - t143*(D_p_rx_3*t29 - D_p_ry_3*t194) - t143*(D_p_rx_5*t27 - D_p_ry_5*t170);
    const pkmodes_real f_2_35 =
        -U_2_x_3*U_2_x_5 - U_2_y_3*U_2_y_5 - U_2_z_3*U_2_z_5 - t145*(D_p_ry_3*t195 - D_p_rz_3*t47)
        - t145*(D_p_ry_5*t171 - D_p_rz_5*t45) - t147*(-D_p_rx_3*t195 + D_p_rz_3*t196) - t147*(-D_p_rx_5*t171
        + D_p_rz_5*t172) - t148*(D_p_rx_3*t47 - D_p_ry_3*t196) - t148*(D_p_rx_5*t45 - D_p_ry_5*t172);
    const pkmodes_real f_3_35 =
        -U_3_x_3*U_3_x_5 - U_3_y_3*U_3_y_5 - U_3_z_3*U_3_z_5 - t150*(D_p_ry_3*t197 - D_p_rz_3*t65)
        - t150*(D_p_ry_5*t173 - D_p_rz_5*t63) - t152*(-D_p_rx_3*t197 + D_p_rz_3*t198) - t152*(-D_p_rx_5*t173
        + D_p_rz_5*t174) - t153*(D_p_rx_3*t65 - D_p_ry_3*t198) - t153*(D_p_rx_5*t63 - D_p_ry_5*t174);
    const pkmodes_real f_4_35 =
        -U_4_x_3*U_4_x_5 - U_4_y_3*U_4_y_5 - U_4_z_3*U_4_z_5 - t155*(D_p_ry_3*t199 - D_p_rz_3*t83)
        - t155*(D_p_ry_5*t175 - D_p_rz_5*t81) - t157*(-D_p_rx_3*t199 + D_p_rz_3*t200) - t157*(-D_p_rx_5*t175
        + D_p_rz_5*t176) - t158*(D_p_rx_3*t83 - D_p_ry_3*t200) - t158*(D_p_rx_5*t81 - D_p_ry_5*t176);
    const pkmodes_real f_5_35 =
        -U_5_x_3*U_5_x_5 - U_5_y_3*U_5_y_5 - U_5_z_3*U_5_z_5 - t160*(D_p_ry_3*t201 - D_p_rz_3*t101)
        - t160*(D_p_ry_5*t177 - D_p_rz_5*t99) - t162*(-D_p_rx_3*t201 + D_p_rz_3*t202) - t162*(-D_p_rx_5*t177
        + D_p_rz_5*t178) - t163*(D_p_rx_3*t101 - D_p_ry_3*t202) - t163*(D_p_rx_5*t99 - D_p_ry_5*t178);
    const pkmodes_real f_6_35 =
        -U_6_x_3*U_6_x_5 - U_6_y_3*U_6_y_5 - U_6_z_3*U_6_z_5 - t165*(D_p_ry_3*t203 - D_p_rz_3*t119)
        - t165*(D_p_ry_5*t179 - D_p_rz_5*t117) - t167*(-D_p_rx_3*t203 + D_p_rz_3*t204) - t167*(-D_p_rx_5*t179
        + D_p_rz_5*t180) - t168*(D_p_rx_3*t119 - D_p_ry_3*t204) - t168*(D_p_rx_5*t117 - D_p_ry_5*t180);
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
        -U_1_x_3*U_1_x_6 - U_1_y_3*U_1_y_6 - U_1_z_3*U_1_z_6 - t140*(D_p_ry_3*t205 - D_p_rz_3*t30)
        - t140*(D_p_ry_6*t169 - D_p_rz_6*t27) - t142*(-D_p_rx_3*t205 + D_p_rz_3*t206) - t142*(-D_p_rx_6*t169
        + D_p_rz_6*t170) - t143*(D_p_rx_3*t30 - D_p_ry_3*t206) - t143*(D_p_rx_6*t27 - D_p_ry_6*t170);
    const pkmodes_real f_2_36 =
        -U_2_x_3*U_2_x_6 - U_2_y_3*U_2_y_6 - U_2_z_3*U_2_z_6 - t145*(D_p_ry_3*t207 - D_p_rz_3*t48)
        - t145*(D_p_ry_6*t171 - D_p_rz_6*t45) - t147*(-D_p_rx_3*t207 + D_p_rz_3*t208) - t147*(-D_p_rx_6*t171
        + D_p_rz_6*t172) - t148*(D_p_rx_3*t48 - D_p_ry_3*t208) - t148*(D_p_rx_6*t45 - D_p_ry_6*t172);
    const pkmodes_real f_3_36 =
        -U_3_x_3*U_3_x_6 - U_3_y_3*U_3_y_6 - U_3_z_3*U_3_z_6 - t150*(D_p_ry_3*t209 - D_p_rz_3*t66)
        - t150*(D_p_ry_6*t173 - D_p_rz_6*t63) - t152*(-D_p_rx_3*t209 + D_p_rz_3*t210) - t152*(-D_p_rx_6*t173
        + D_p_rz_6*t174) - t153*(D_p_rx_3*t66 - D_p_ry_3*t210) - t153*(D_p_rx_6*t63 - D_p_ry_6*t174);
    const pkmodes_real f_4_36 =
        -U_4_x_3*U_4_x_6 - U_4_y_3*U_4_y_6 - U_4_z_3*U_4_z_6 - t155*(D_p_ry_3*t211 - D_p_rz_3*t84)
        - t155*(D_p_ry_6*t175 - D_p_rz_6*t81) - t157*(-D_p_rx_3*t211 + D_p_rz_3*t212) - t157*(-D_p_rx_6*t175
        + D_p_rz_6*t176) - t158*(D_p_rx_3*t84 - D_p_ry_3*t212) - t158*(D_p_rx_6*t81 - D_p_ry_6*t176);
    const pkmodes_real f_5_36 =
        -U_5_x_3*U_5_x_6 - U_5_y_3*U_5_y_6 - U_5_z_3*U_5_z_6 - t160*(D_p_ry_3*t213 - D_p_rz_3*t102)
        - t160*(D_p_ry_6*t177 - D_p_rz_6*t99) - t162*(-D_p_rx_3*t213 + D_p_rz_3*t214) - t162*(-D_p_rx_6*t177
        + D_p_rz_6*t178) - t163*(D_p_rx_3*t102 - D_p_ry_3*t214) - t163*(D_p_rx_6*t99 - D_p_ry_6*t178);
    const pkmodes_real f_6_36 =
        -U_6_x_3*U_6_x_6 - U_6_y_3*U_6_y_6 - U_6_z_3*U_6_z_6 - t165*(D_p_ry_3*t215 - D_p_rz_3*t120)
        - t165*(D_p_ry_6*t179 - D_p_rz_6*t117) - t167*(-D_p_rx_3*t215 + D_p_rz_3*t216) - t167*(-D_p_rx_6*t179
        + D_p_rz_6*t180) - t168*(D_p_rx_3*t120 - D_p_ry_3*t216) - t168*(D_p_rx_6*t117 - D_p_ry_6*t180);
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
        -(U_1_x_4*U_1_x_4) - (U_1_y_4*U_1_y_4) - (U_1_z_4*U_1_z_4) - d_1_x*(D_p_ry_4*t181 - D_p_rz_4*t28)
        - d_1_y*(-D_p_rx_4*t181 + D_p_rz_4*t182) - d_1_z*(D_p_rx_4*t28 - D_p_ry_4*t182);
    const pkmodes_real f_2_44 =
        -(U_2_x_4*U_2_x_4) - (U_2_y_4*U_2_y_4) - (U_2_z_4*U_2_z_4) - d_2_x*(D_p_ry_4*t183 - D_p_rz_4*t46)
        - d_2_y*(-D_p_rx_4*t183 + D_p_rz_4*t184) - d_2_z*(D_p_rx_4*t46 - D_p_ry_4*t184);
    const pkmodes_real f_3_44 =
        -(U_3_x_4*U_3_x_4) - (U_3_y_4*U_3_y_4) - (U_3_z_4*U_3_z_4) - d_3_x*(D_p_ry_4*t185 - D_p_rz_4*t64)
        - d_3_y*(-D_p_rx_4*t185 + D_p_rz_4*t186) - d_3_z*(D_p_rx_4*t64 - D_p_ry_4*t186);
    const pkmodes_real f_4_44 =
        -(U_4_x_4*U_4_x_4) - (U_4_y_4*U_4_y_4) - (U_4_z_4*U_4_z_4) - d_4_x*(D_p_ry_4*t187 - D_p_rz_4*t82)
        - d_4_y*(-D_p_rx_4*t187 + D_p_rz_4*t188) - d_4_z*(D_p_rx_4*t82 - D_p_ry_4*t188) + 1;
    const pkmodes_real f_5_44 =
        -(U_5_x_4*U_5_x_4) - (U_5_y_4*U_5_y_4) - (U_5_z_4*U_5_z_4) - d_5_x*(D_p_ry_4*t189 - D_p_rz_4*t100)
        - d_5_y*(-D_p_rx_4*t189 + D_p_rz_4*t190) - d_5_z*(D_p_rx_4*t100 - D_p_ry_4*t190);
    const pkmodes_real f_6_44 =
        -(U_6_x_4*U_6_x_4) - (U_6_y_4*U_6_y_4) - (U_6_z_4*U_6_z_4) - d_6_x*(D_p_ry_4*t191 - D_p_rz_4*t118)
        - d_6_y*(-D_p_rx_4*t191 + D_p_rz_4*t192) - d_6_z*(D_p_rx_4*t118 - D_p_ry_4*t192);
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
        -U_1_x_4*U_1_x_5 - U_1_y_4*U_1_y_5 - U_1_z_4*U_1_z_5 - t140*(D_p_ry_4*t193 - D_p_rz_4*t29)
        - t140*(D_p_ry_5*t181 - D_p_rz_5*t28) - t142*(-D_p_rx_4*t193 + D_p_rz_4*t194) - t142*(-D_p_rx_5*t181
        + D_p_rz_5*t182) - t143*(D_p_rx_4*t29 - D_p_ry_4*t194) - t143*(D_p_rx_5*t28 - D_p_ry_5*t182);
    const pkmodes_real f_2_45 =
        -U_2_x_4*U_2_x_5 - U_2_y_4*U_2_y_5 - U_2_z_4*U_2_z_5 - t145*(D_p_ry_4*t195 - D_p_rz_4*t47)
        - t145*(D_p_ry_5*t183 - D_p_rz_5*t46) - t147*(-D_p_rx_4*t195 + D_p_rz_4*t196) - t147*(-D_p_rx_5*t183
        + D_p_rz_5*t184) - t148*(D_p_rx_4*t47 - D_p_ry_4*t196) - t148*(D_p_rx_5*t46 - D_p_ry_5*t184);
    const pkmodes_real f_3_45 =
        -U_3_x_4*U_3_x_5 - U_3_y_4*U_3_y_5 - U_3_z_4*U_3_z_5 - t150*(D_p_ry_4*t197 - D_p_rz_4*t65)
        - t150*(D_p_ry_5*t185 - D_p_rz_5*t64) - t152*(-D_p_rx_4*t197 + D_p_rz_4*t198) - t152*(-D_p_rx_5*t185
        + D_p_rz_5*t186) - t153*(D_p_rx_4*t65 - D_p_ry_4*t198) - t153*(D_p_rx_5*t64 - D_p_ry_5*t186);
    const pkmodes_real f_4_45 =
        -U_4_x_4*U_4_x_5 - U_4_y_4*U_4_y_5 - U_4_z_4*U_4_z_5 - t155*(D_p_ry_4*t199 - D_p_rz_4*t83)
        - t155*(D_p_ry_5*t187 - D_p_rz_5*t82) - t157*(-D_p_rx_4*t199 + D_p_rz_4*t200) - t157*(-D_p_rx_5*t187
        + D_p_rz_5*t188) - t158*(D_p_rx_4*t83 - D_p_ry_4*t200) - t158*(D_p_rx_5*t82 - D_p_ry_5*t188);
    const pkmodes_real f_5_45 =
        -U_5_x_4*U_5_x_5 - U_5_y_4*U_5_y_5 - U_5_z_4*U_5_z_5 - t160*(D_p_ry_4*t201 - D_p_rz_4*t101)
        - t160*(D_p_ry_5*t189 - D_p_rz_5*t100) - t162*(-D_p_rx_4*t201 + D_p_rz_4*t202) - t162*(-D_p_rx_5*t189
        + D_p_rz_5*t190) - t163*(D_p_rx_4*t101 - D_p_ry_4*t202) - t163*(D_p_rx_5*t100 - D_p_ry_5*t190);
    const pkmodes_real f_6_45 =
        -U_6_x_4*U_6_x_5 - U_6_y_4*U_6_y_5 - U_6_z_4*U_6_z_5 - t165*(D_p_ry_4*t203 - D_p_rz_4*t119)
        - t165*(D_p_ry_5*t191 - D_p_rz_5*t118) - t167*(-D_p_rx_4*t203 + D_p_rz_4*t204) - t167*(-D_p_rx_5*t191
        + D_p_rz_5*t192) - t168*(D_p_rx_4*t119 - D_p_ry_4*t204) - t168*(D_p_rx_5*t118 - D_p_ry_5*t192);
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
        -U_1_x_4*U_1_x_6 - U_1_y_4*U_1_y_6 - U_1_z_4*U_1_z_6 - t140*(D_p_ry_4*t205 - D_p_rz_4*t30)
        - t140*(D_p_ry_6*t181 - D_p_rz_6*t28) - t142*(-D_p_rx_4*t205 + D_p_rz_4*t206) - t142*(-D_p_rx_6*t181
        + D_p_rz_6*t182) - t143*(D_p_rx_4*t30 - D_p_ry_4*t206) - t143*(D_p_rx_6*t28 - D_p_ry_6*t182);
    const pkmodes_real f_2_46 =
        -U_2_x_4*U_2_x_6 - U_2_y_4*U_2_y_6 - U_2_z_4*U_2_z_6 - t145*(D_p_ry_4*t207 - D_p_rz_4*t48)
        - t145*(D_p_ry_6*t183 - D_p_rz_6*t46) - t147*(-D_p_rx_4*t207 + D_p_rz_4*t208) - t147*(-D_p_rx_6*t183
        + D_p_rz_6*t184) - t148*(D_p_rx_4*t48 - D_p_ry_4*t208) - t148*(D_p_rx_6*t46 - D_p_ry_6*t184);
    const pkmodes_real f_3_46 =
        -U_3_x_4*U_3_x_6 - U_3_y_4*U_3_y_6 - U_3_z_4*U_3_z_6 - t150*(D_p_ry_4*t209 - D_p_rz_4*t66)
        - t150*(D_p_ry_6*t185 - D_p_rz_6*t64) - t152*(-D_p_rx_4*t209 + D_p_rz_4*t210) - t152*(-D_p_rx_6*t185
        + D_p_rz_6*t186) - t153*(D_p_rx_4*t66 - D_p_ry_4*t210) - t153*(D_p_rx_6*t64 - D_p_ry_6*t186);
    const pkmodes_real f_4_46 =
        -U_4_x_4*U_4_x_6 - U_4_y_4*U_4_y_6 - U_4_z_4*U_4_z_6 - t155*(D_p_ry_4*t211 - D_p_rz_4*t84)
        - t155*(D_p_ry_6*t187 - D_p_rz_6*t82) - t157*(-D_p_rx_4*t211 + D_p_rz_4*t212) - t157*(-D_p_rx_6*t187
        + D_p_rz_6*t188) - t158*(D_p_rx_4*t84 - D_p_ry_4*t212) - t158*(D_p_rx_6*t82 - D_p_ry_6*t188);
    const pkmodes_real f_5_46 =
        -U_5_x_4*U_5_x_6 - U_5_y_4*U_5_y_6 - U_5_z_4*U_5_z_6 - t160*(D_p_ry_4*t213 - D_p_rz_4*t102)
        - t160*(D_p_ry_6*t189 - D_p_rz_6*t100) - t162*(-D_p_rx_4*t213 + D_p_rz_4*t214) - t162*(-D_p_rx_6*t189
        + D_p_rz_6*t190) - t163*(D_p_rx_4*t102 - D_p_ry_4*t214) - t163*(D_p_rx_6*t100 - D_p_ry_6*t190);
    const pkmodes_real f_6_46 =
        -U_6_x_4*U_6_x_6 - U_6_y_4*U_6_y_6 - U_6_z_4*U_6_z_6 - t165*(D_p_ry_4*t215 - D_p_rz_4*t120)
        - t165*(D_p_ry_6*t191 - D_p_rz_6*t118) - t167*(-D_p_rx_4*t215 + D_p_rz_4*t216) - t167*(-D_p_rx_6*t191
        + D_p_rz_6*t192) - t168*(D_p_rx_4*t120 - D_p_ry_4*t216) - t168*(D_p_rx_6*t118 - D_p_ry_6*t192);
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
        -(U_1_x_5*U_1_x_5) - (U_1_y_5*U_1_y_5) - (U_1_z_5*U_1_z_5) - d_1_x*(D_p_ry_5*t193 - D_p_rz_5*t29)
        - d_1_y*(-D_p_rx_5*t193 + D_p_rz_5*t194) - d_1_z*(D_p_rx_5*t29 - D_p_ry_5*t194);
    const pkmodes_real f_2_55 =
        -(U_2_x_5*U_2_x_5) - (U_2_y_5*U_2_y_5) - (U_2_z_5*U_2_z_5) - d_2_x*(D_p_ry_5*t195 - D_p_rz_5*t47)
        - d_2_y*(-D_p_rx_5*t195 + D_p_rz_5*t196) - d_2_z*(D_p_rx_5*t47 - D_p_ry_5*t196);
    const pkmodes_real f_3_55 =
        -(U_3_x_5*U_3_x_5) - (U_3_y_5*U_3_y_5) - (U_3_z_5*U_3_z_5) - d_3_x*(D_p_ry_5*t197 - D_p_rz_5*t65)
        - d_3_y*(-D_p_rx_5*t197 + D_p_rz_5*t198) - d_3_z*(D_p_rx_5*t65 - D_p_ry_5*t198);
    const pkmodes_real f_4_55 =
        -(U_4_x_5*U_4_x_5) - (U_4_y_5*U_4_y_5) - (U_4_z_5*U_4_z_5) - d_4_x*(D_p_ry_5*t199 - D_p_rz_5*t83)
        - d_4_y*(-D_p_rx_5*t199 + D_p_rz_5*t200) - d_4_z*(D_p_rx_5*t83 - D_p_ry_5*t200);
    const pkmodes_real f_5_55 =
        -(U_5_x_5*U_5_x_5) - (U_5_y_5*U_5_y_5) - (U_5_z_5*U_5_z_5) - d_5_x*(D_p_ry_5*t201 - D_p_rz_5*t101)
        - d_5_y*(-D_p_rx_5*t201 + D_p_rz_5*t202) - d_5_z*(D_p_rx_5*t101 - D_p_ry_5*t202) + 1;
    const pkmodes_real f_6_55 =
        -(U_6_x_5*U_6_x_5) - (U_6_y_5*U_6_y_5) - (U_6_z_5*U_6_z_5) - d_6_x*(D_p_ry_5*t203 - D_p_rz_5*t119)
        - d_6_y*(-D_p_rx_5*t203 + D_p_rz_5*t204) - d_6_z*(D_p_rx_5*t119 - D_p_ry_5*t204);
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
        -U_1_x_5*U_1_x_6 - U_1_y_5*U_1_y_6 - U_1_z_5*U_1_z_6 - t140*(D_p_ry_5*t205 - D_p_rz_5*t30)
        - t140*(D_p_ry_6*t193 - D_p_rz_6*t29) - t142*(-D_p_rx_5*t205 + D_p_rz_5*t206) - t142*(-D_p_rx_6*t193
        + D_p_rz_6*t194) - t143*(D_p_rx_5*t30 - D_p_ry_5*t206) - t143*(D_p_rx_6*t29 - D_p_ry_6*t194);
    const pkmodes_real f_2_56 =
        -U_2_x_5*U_2_x_6 - U_2_y_5*U_2_y_6 - U_2_z_5*U_2_z_6 - t145*(D_p_ry_5*t207 - D_p_rz_5*t48)
        - t145*(D_p_ry_6*t195 - D_p_rz_6*t47) - t147*(-D_p_rx_5*t207 + D_p_rz_5*t208) - t147*(-D_p_rx_6*t195
        + D_p_rz_6*t196) - t148*(D_p_rx_5*t48 - D_p_ry_5*t208) - t148*(D_p_rx_6*t47 - D_p_ry_6*t196);
    const pkmodes_real f_3_56 =
        -U_3_x_5*U_3_x_6 - U_3_y_5*U_3_y_6 - U_3_z_5*U_3_z_6 - t150*(D_p_ry_5*t209 - D_p_rz_5*t66)
        - t150*(D_p_ry_6*t197 - D_p_rz_6*t65) - t152*(-D_p_rx_5*t209 + D_p_rz_5*t210) - t152*(-D_p_rx_6*t197
        + D_p_rz_6*t198) - t153*(D_p_rx_5*t66 - D_p_ry_5*t210) - t153*(D_p_rx_6*t65 - D_p_ry_6*t198);
    const pkmodes_real f_4_56 =
        -U_4_x_5*U_4_x_6 - U_4_y_5*U_4_y_6 - U_4_z_5*U_4_z_6 - t155*(D_p_ry_5*t211 - D_p_rz_5*t84)
        - t155*(D_p_ry_6*t199 - D_p_rz_6*t83) - t157*(-D_p_rx_5*t211 + D_p_rz_5*t212) - t157*(-D_p_rx_6*t199
        + D_p_rz_6*t200) - t158*(D_p_rx_5*t84 - D_p_ry_5*t212) - t158*(D_p_rx_6*t83 - D_p_ry_6*t200);
    const pkmodes_real f_5_56 =
        -U_5_x_5*U_5_x_6 - U_5_y_5*U_5_y_6 - U_5_z_5*U_5_z_6 - t160*(D_p_ry_5*t213 - D_p_rz_5*t102)
        - t160*(D_p_ry_6*t201 - D_p_rz_6*t101) - t162*(-D_p_rx_5*t213 + D_p_rz_5*t214) - t162*(-D_p_rx_6*t201
        + D_p_rz_6*t202) - t163*(D_p_rx_5*t102 - D_p_ry_5*t214) - t163*(D_p_rx_6*t101 - D_p_ry_6*t202);
    const pkmodes_real f_6_56 =
        -U_6_x_5*U_6_x_6 - U_6_y_5*U_6_y_6 - U_6_z_5*U_6_z_6 - t165*(D_p_ry_5*t215 - D_p_rz_5*t120)
        - t165*(D_p_ry_6*t203 - D_p_rz_6*t119) - t167*(-D_p_rx_5*t215 + D_p_rz_5*t216) - t167*(-D_p_rx_6*t203
        + D_p_rz_6*t204) - t168*(D_p_rx_5*t120 - D_p_ry_5*t216) - t168*(D_p_rx_6*t119 - D_p_ry_6*t204);
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
        -(U_1_x_6*U_1_x_6) - (U_1_y_6*U_1_y_6) - (U_1_z_6*U_1_z_6) - d_1_x*(D_p_ry_6*t205 - D_p_rz_6*t30)
        - d_1_y*(-D_p_rx_6*t205 + D_p_rz_6*t206) - d_1_z*(D_p_rx_6*t30 - D_p_ry_6*t206);
    const pkmodes_real f_2_66 =
        -(U_2_x_6*U_2_x_6) - (U_2_y_6*U_2_y_6) - (U_2_z_6*U_2_z_6) - d_2_x*(D_p_ry_6*t207 - D_p_rz_6*t48)
        - d_2_y*(-D_p_rx_6*t207 + D_p_rz_6*t208) - d_2_z*(D_p_rx_6*t48 - D_p_ry_6*t208);
    const pkmodes_real f_3_66 =
        -(U_3_x_6*U_3_x_6) - (U_3_y_6*U_3_y_6) - (U_3_z_6*U_3_z_6) - d_3_x*(D_p_ry_6*t209 - D_p_rz_6*t66)
        - d_3_y*(-D_p_rx_6*t209 + D_p_rz_6*t210) - d_3_z*(D_p_rx_6*t66 - D_p_ry_6*t210);
    const pkmodes_real f_4_66 =
        -(U_4_x_6*U_4_x_6) - (U_4_y_6*U_4_y_6) - (U_4_z_6*U_4_z_6) - d_4_x*(D_p_ry_6*t211 - D_p_rz_6*t84)
        - d_4_y*(-D_p_rx_6*t211 + D_p_rz_6*t212) - d_4_z*(D_p_rx_6*t84 - D_p_ry_6*t212);
    const pkmodes_real f_5_66 =
        -(U_5_x_6*U_5_x_6) - (U_5_y_6*U_5_y_6) - (U_5_z_6*U_5_z_6) - d_5_x*(D_p_ry_6*t213 - D_p_rz_6*t102)
        - d_5_y*(-D_p_rx_6*t213 + D_p_rz_6*t214) - d_5_z*(D_p_rx_6*t102 - D_p_ry_6*t214);
    const pkmodes_real f_6_66 =
        -(U_6_x_6*U_6_x_6) - (U_6_y_6*U_6_y_6) - (U_6_z_6*U_6_z_6) - d_6_x*(D_p_ry_6*t215 - D_p_rz_6*t120)
        - d_6_y*(-D_p_rx_6*t215 + D_p_rz_6*t216) - d_6_z*(D_p_rx_6*t120 - D_p_ry_6*t216) + 1;
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

void hexapod_kinetic_energy(const pkmodes_real p[6], const pkmodes_real q_dot[12],
    const hexapod_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t)
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real l_1_dot = q_dot[0];
    const pkmodes_real l_2_dot = q_dot[1];
    const pkmodes_real l_3_dot = q_dot[2];
    const pkmodes_real l_4_dot = q_dot[3];
    const pkmodes_real l_5_dot = q_dot[4];
    const pkmodes_real l_6_dot = q_dot[5];
    const pkmodes_real s_1_dot = q_dot[6];
    const pkmodes_real s_2_dot = q_dot[7];
    const pkmodes_real s_3_dot = q_dot[8];
    const pkmodes_real s_4_dot = q_dot[9];
    const pkmodes_real s_5_dot = q_dot[10];
    const pkmodes_real s_6_dot = q_dot[11];
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
    const pkmodes_real m_perp_1 =
        I_b_1*t30 + I_r_1*t30 + (c_b_1*c_b_1)*m_b_1*t30 + m_r_1*((-c_r_1/l_1 + 1)*(-c_r_1/l_1 + 1));
    const pkmodes_real t31 = 1/((l_2*l_2));
    const pkmodes_real m_perp_2 =
        I_b_2*t31 + I_r_2*t31 + (c_b_2*c_b_2)*m_b_2*t31 + m_r_2*((-c_r_2/l_2 + 1)*(-c_r_2/l_2 + 1));
    const pkmodes_real t32 = 1/((l_3*l_3));
    const pkmodes_real m_perp_3 =
        I_b_3*t32 + I_r_3*t32 + (c_b_3*c_b_3)*m_b_3*t32 + m_r_3*((-c_r_3/l_3 + 1)*(-c_r_3/l_3 + 1));
    const pkmodes_real t33 = 1/((l_4*l_4));
    const pkmodes_real m_perp_4 =
        I_b_4*t33 + I_r_4*t33 + (c_b_4*c_b_4)*m_b_4*t33 + m_r_4*((-c_r_4/l_4 + 1)*(-c_r_4/l_4 + 1));
    const pkmodes_real t34 = 1/((l_5*l_5));
    const pkmodes_real m_perp_5 =
        I_b_5*t34 + I_r_5*t34 + (c_b_5*c_b_5)*m_b_5*t34 + m_r_5*((-c_r_5/l_5 + 1)*(-c_r_5/l_5 + 1));
    const pkmodes_real t35 = 1/((l_6*l_6));
    const pkmodes_real m_perp_6 =
        I_b_6*t35 + I_r_6*t35 + (c_b_6*c_b_6)*m_b_6*t35 + m_r_6*((-c_r_6/l_6 + 1)*(-c_r_6/l_6 + 1));
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
    const pkmodes_real t36 = 1/det_D_l;
    const pkmodes_real t37 = l_1*t36;
    const pkmodes_real D_p_x_1 = A_x_1*t37;
    const pkmodes_real t38 = l_2*t36;
    const pkmodes_real D_p_x_2 = A_x_2*t38;
    const pkmodes_real t39 = l_3*t36;
    const pkmodes_real D_p_x_3 = A_x_3*t39;
    const pkmodes_real t40 = l_4*t36;
    const pkmodes_real D_p_x_4 = A_x_4*t40;
    const pkmodes_real t41 = l_5*t36;
    const pkmodes_real D_p_x_5 = A_x_5*t41;
    const pkmodes_real t42 = l_6*t36;
    const pkmodes_real D_p_x_6 = A_x_6*t42;
    const pkmodes_real D_p_y_1 = A_y_1*t37;
    const pkmodes_real D_p_y_2 = A_y_2*t38;
    const pkmodes_real D_p_y_3 = A_y_3*t39;
    const pkmodes_real D_p_y_4 = A_y_4*t40;
    const pkmodes_real D_p_y_5 = A_y_5*t41;
    const pkmodes_real D_p_y_6 = A_y_6*t42;
    const pkmodes_real D_p_z_1 = A_z_1*t37;
    const pkmodes_real D_p_z_2 = A_z_2*t38;
    const pkmodes_real D_p_z_3 = A_z_3*t39;
    const pkmodes_real D_p_z_4 = A_z_4*t40;
    const pkmodes_real D_p_z_5 = A_z_5*t41;
    const pkmodes_real D_p_z_6 = A_z_6*t42;
    const pkmodes_real D_p_rx_1 = A_rx_1*t37;
    const pkmodes_real D_p_rx_2 = A_rx_2*t38;
    const pkmodes_real D_p_rx_3 = A_rx_3*t39;
    const pkmodes_real D_p_rx_4 = A_rx_4*t40;
    const pkmodes_real D_p_rx_5 = A_rx_5*t41;
    const pkmodes_real D_p_rx_6 = A_rx_6*t42;
    const pkmodes_real D_p_ry_1 = A_ry_1*t37;
    const pkmodes_real D_p_ry_2 = A_ry_2*t38;
    const pkmodes_real D_p_ry_3 = A_ry_3*t39;
    const pkmodes_real D_p_ry_4 = A_ry_4*t40;
    const pkmodes_real D_p_ry_5 = A_ry_5*t41;
    const pkmodes_real D_p_ry_6 = A_ry_6*t42;
    const pkmodes_real D_p_rz_1 = A_rz_1*t37;
    const pkmodes_real D_p_rz_2 = A_rz_2*t38;
    const pkmodes_real D_p_rz_3 = A_rz_3*t39;
    const pkmodes_real D_p_rz_4 = A_rz_4*t40;
    const pkmodes_real D_p_rz_5 = A_rz_5*t41;
    const pkmodes_real D_p_rz_6 = A_rz_6*t42;
    const pkmodes_real v_p_x =
        D_p_x_1*l_1_dot + D_p_x_2*l_2_dot + D_p_x_3*l_3_dot + D_p_x_4*l_4_dot + D_p_x_5*l_5_dot
        + D_p_x_6*l_6_dot;
    const pkmodes_real v_p_y =
        D_p_y_1*l_1_dot + D_p_y_2*l_2_dot + D_p_y_3*l_3_dot + D_p_y_4*l_4_dot + D_p_y_5*l_5_dot
        + D_p_y_6*l_6_dot;
    const pkmodes_real v_p_z =
        D_p_z_1*l_1_dot + D_p_z_2*l_2_dot + D_p_z_3*l_3_dot + D_p_z_4*l_4_dot + D_p_z_5*l_5_dot
        + D_p_z_6*l_6_dot;
    const pkmodes_real w_p_x =
        D_p_rx_1*l_1_dot + D_p_rx_2*l_2_dot + D_p_rx_3*l_3_dot + D_p_rx_4*l_4_dot + D_p_rx_5*l_5_dot
        + D_p_rx_6*l_6_dot;
    const pkmodes_real w_p_y =
        D_p_ry_1*l_1_dot + D_p_ry_2*l_2_dot + D_p_ry_3*l_3_dot + D_p_ry_4*l_4_dot + D_p_ry_5*l_5_dot
        + D_p_ry_6*l_6_dot;
    const pkmodes_real w_p_z =
        D_p_rz_1*l_1_dot + D_p_rz_2*l_2_dot + D_p_rz_3*l_3_dot + D_p_rz_4*l_4_dot + D_p_rz_5*l_5_dot
        + D_p_rz_6*l_6_dot;
    const pkmodes_real t43 = 2*B_6_x;
    const pkmodes_real t44 = 2*B_6_y;
    const pkmodes_real t45 = 2*B_6_z;
    const pkmodes_real t46 = w_p_x*w_p_y;
    const pkmodes_real t47 = w_p_x*w_p_z;
    const pkmodes_real t48 = w_p_y*w_p_z;
    const pkmodes_real t49 = (w_p_x*w_p_x);
    const pkmodes_real t50 = (w_p_y*w_p_y);
    const pkmodes_real t51 = (w_p_z*w_p_z);
    const pkmodes_real t52 = (R(1.0)/R(2.0))*m_perp_1;
    const pkmodes_real t53 = (R(1.0)/R(2.0))*m_perp_2;
    const pkmodes_real t54 = (R(1.0)/R(2.0))*m_perp_3;
    const pkmodes_real t55 = (R(1.0)/R(2.0))*m_perp_4;
    const pkmodes_real t56 = (R(1.0)/R(2.0))*m_perp_5;
    const pkmodes_real t57 = (R(1.0)/R(2.0))*m_perp_6;
    const pkmodes_real t58 = (c_y*c_y);
    const pkmodes_real t59 = (c_z*c_z);
    const pkmodes_real t60 = (c_x*c_x);
    const pkmodes_real t61 = 2*c_x;
    const pkmodes_real t62 = v_p_z*w_p_y;
    const pkmodes_real t63 = 2*c_y;
    const pkmodes_real t64 = v_p_x*w_p_z;
    const pkmodes_real t65 = 2*c_z;
    const pkmodes_real t66 = v_p_y*w_p_x;
    const pkmodes_real t67 = v_p_y*w_p_z;
    const pkmodes_real t68 = v_p_z*w_p_x;
    const pkmodes_real t69 = v_p_x*w_p_y;
    const pkmodes_real t70 = (v_p_x*v_p_x) + (v_p_y*v_p_y) + (v_p_z*v_p_z);
    const pkmodes_real t71 = (B_1_y*B_1_y);
    const pkmodes_real t72 = (B_1_z*B_1_z);
    const pkmodes_real t73 = (B_1_x*B_1_x);
    const pkmodes_real t74 = 2*B_1_x;
    const pkmodes_real t75 = 2*B_1_y;
    const pkmodes_real t76 = 2*B_1_z;
    const pkmodes_real t77 = (B_2_y*B_2_y);
    const pkmodes_real t78 = (B_2_z*B_2_z);
    const pkmodes_real t79 = (B_2_x*B_2_x);
    const pkmodes_real t80 = 2*B_2_x;
    const pkmodes_real t81 = 2*B_2_y;
    const pkmodes_real t82 = 2*B_2_z;
    const pkmodes_real t83 = (B_3_y*B_3_y);
    const pkmodes_real t84 = (B_3_z*B_3_z);
    const pkmodes_real t85 = (B_3_x*B_3_x);
    const pkmodes_real t86 = 2*B_3_x;
    const pkmodes_real t87 = 2*B_3_y;
    const pkmodes_real t88 = 2*B_3_z;
    const pkmodes_real t89 = (B_4_y*B_4_y);
    const pkmodes_real t90 = (B_4_z*B_4_z);
    const pkmodes_real t91 = (B_4_x*B_4_x);
    const pkmodes_real t92 = 2*B_4_x;
    const pkmodes_real t93 = 2*B_4_y;
    const pkmodes_real t94 = 2*B_4_z;
    const pkmodes_real t95 = (B_5_y*B_5_y);
    const pkmodes_real t96 = (B_5_z*B_5_z);
    const pkmodes_real t97 = (B_5_x*B_5_x);
    const pkmodes_real t98 = 2*B_5_x;
    const pkmodes_real t99 = 2*B_5_y;
    const pkmodes_real t100 = 2*B_5_z;
    const pkmodes_real t101 = (B_6_y*B_6_y);
    const pkmodes_real t102 = (B_6_z*B_6_z);
    const pkmodes_real t103 = (B_6_x*B_6_x);
    *T_ss =
        (R(1.0)/R(2.0))*J_x_x*t49 + J_x_y*t46 + J_x_z*t47 + (R(1.0)/R(2.0))*J_y_y*t50 + J_y_z*t48
        + (R(1.0)/R(2.0))*J_z_z*t51 + (l_1_dot*l_1_dot)*((R(1.0)/R(2.0))*m_r_1 - t52)
        + (l_2_dot*l_2_dot)*((R(1.0)/R(2.0))*m_r_2 - t53) + (l_3_dot*l_3_dot)*((R(1.0)/R(2.0))*m_r_3 - t54)
        + (l_4_dot*l_4_dot)*((R(1.0)/R(2.0))*m_r_4 - t55) + (l_5_dot*l_5_dot)*((R(1.0)/R(2.0))*m_r_5 - t56)
        + (l_6_dot*l_6_dot)*((R(1.0)/R(2.0))*m_r_6 - t57) + (R(1.0)/R(2.0))*m_p*(-c_y*t46*t61 - c_z*t47*t61
        - c_z*t48*t63 + t49*(t58 + t59) + t50*(t59 + t60) + t51*(t58 + t60) - t61*t62 + t61*t67 - t63*t64
        + t63*t68 - t65*t66 + t65*t69 + t70) + t52*(-B_1_y*t46*t74 - B_1_z*t47*t74 - B_1_z*t48*t75 + t49*(t71
        + t72) + t50*(t72 + t73) + t51*(t71 + t73) - t62*t74 - t64*t75 - t66*t76 + t67*t74 + t68*t75
        + t69*t76 + t70) + t53*(-B_2_y*t46*t80 - B_2_z*t47*t80 - B_2_z*t48*t81 + t49*(t77 + t78) + t50*(t78
        + t79) + t51*(t77 + t79) - t62*t80 - t64*t81 - t66*t82 + t67*t80 + t68*t81 + t69*t82 + t70)
        + t54*(-B_3_y*t46*t86 - B_3_z*t47*t86 - B_3_z*t48*t87 + t49*(t83 + t84) + t50*(t84 + t85) + t51*(t83
        + t85) - t62*t86 - t64*t87 - t66*t88 + t67*t86 + t68*t87 + t69*t88 + t70) + t55*(-B_4_y*t46*t92
        - B_4_z*t47*t92 - B_4_z*t48*t93 + t49*(t89 + t90) + t50*(t90 + t91) + t51*(t89 + t91) - t62*t92
        - t64*t93 - t66*t94 + t67*t92 + t68*t93 + t69*t94 + t70) + t56*(-B_5_y*t46*t98 - B_5_z*t47*t98
        - B_5_z*t48*t99 - t100*t66 + t100*t69 + t49*(t95 + t96) + t50*(t96 + t97) + t51*(t95 + t97) - t62*t98
        - t64*t99 + t67*t98 + t68*t99 + t70) + t57*(-B_6_y*t43*t46 - B_6_z*t43*t47 - B_6_z*t44*t48 - t43*t62
        + t43*t67 - t44*t64 + t44*t68 - t45*t66 + t45*t69 + t49*(t101 + t102) + t50*(t102 + t103) + t51*(t101
        + t103) + t70);
    *T_t =
        (R(1.0)/R(2.0))*I_m_1*(s_1_dot*s_1_dot)/(h_m_1*h_m_1)
        + (R(1.0)/R(2.0))*I_m_2*(s_2_dot*s_2_dot)/(h_m_2*h_m_2)
        + (R(1.0)/R(2.0))*I_m_3*(s_3_dot*s_3_dot)/(h_m_3*h_m_3)
        + (R(1.0)/R(2.0))*I_m_4*(s_4_dot*s_4_dot)/(h_m_4*h_m_4)
        + (R(1.0)/R(2.0))*I_m_5*(s_5_dot*s_5_dot)/(h_m_5*h_m_5)
        + (R(1.0)/R(2.0))*I_m_6*(s_6_dot*s_6_dot)/(h_m_6*h_m_6);
}

void hexapod_mass_matrix(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real M[12][12])
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
    const pkmodes_real m_perp_1 =
        I_b_1*t30 + I_r_1*t30 + (c_b_1*c_b_1)*m_b_1*t30 + m_r_1*((-c_r_1/l_1 + 1)*(-c_r_1/l_1 + 1));
    const pkmodes_real t31 = 1/((l_2*l_2));
    const pkmodes_real m_perp_2 =
        I_b_2*t31 + I_r_2*t31 + (c_b_2*c_b_2)*m_b_2*t31 + m_r_2*((-c_r_2/l_2 + 1)*(-c_r_2/l_2 + 1));
    const pkmodes_real t32 = 1/((l_3*l_3));
    const pkmodes_real m_perp_3 =
        I_b_3*t32 + I_r_3*t32 + (c_b_3*c_b_3)*m_b_3*t32 + m_r_3*((-c_r_3/l_3 + 1)*(-c_r_3/l_3 + 1));
    const pkmodes_real t33 = 1/((l_4*l_4));
    const pkmodes_real m_perp_4 =
        I_b_4*t33 + I_r_4*t33 + (c_b_4*c_b_4)*m_b_4*t33 + m_r_4*((-c_r_4/l_4 + 1)*(-c_r_4/l_4 + 1));
    const pkmodes_real t34 = 1/((l_5*l_5));
    const pkmodes_real m_perp_5 =
        I_b_5*t34 + I_r_5*t34 + (c_b_5*c_b_5)*m_b_5*t34 + m_r_5*((-c_r_5/l_5 + 1)*(-c_r_5/l_5 + 1));
    const pkmodes_real t35 = 1/((l_6*l_6));
    const pkmodes_real m_perp_6 =
        I_b_6*t35 + I_r_6*t35 + (c_b_6*c_b_6)*m_b_6*t35 + m_r_6*((-c_r_6/l_6 + 1)*(-c_r_6/l_6 + 1));
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
    const pkmodes_real t36 = 1/det_D_l;
    const pkmodes_real t37 = l_1*t36;
    const pkmodes_real D_p_x_1 = A_x_1*t37;
    const pkmodes_real t38 = l_2*t36;
    const pkmodes_real D_p_x_2 = A_x_2*t38;
    const pkmodes_real t39 = l_3*t36;
    const pkmodes_real D_p_x_3 = A_x_3*t39;
    const pkmodes_real t40 = l_4*t36;
    const pkmodes_real D_p_x_4 = A_x_4*t40;
    const pkmodes_real t41 = l_5*t36;
    const pkmodes_real D_p_x_5 = A_x_5*t41;
    const pkmodes_real t42 = l_6*t36;
    const pkmodes_real D_p_x_6 = A_x_6*t42;
    const pkmodes_real D_p_y_1 = A_y_1*t37;
    const pkmodes_real D_p_y_2 = A_y_2*t38;
    const pkmodes_real D_p_y_3 = A_y_3*t39;
    const pkmodes_real D_p_y_4 = A_y_4*t40;
    const pkmodes_real D_p_y_5 = A_y_5*t41;
    const pkmodes_real D_p_y_6 = A_y_6*t42;
    const pkmodes_real D_p_z_1 = A_z_1*t37;
    const pkmodes_real D_p_z_2 = A_z_2*t38;
    const pkmodes_real D_p_z_3 = A_z_3*t39;
    const pkmodes_real D_p_z_4 = A_z_4*t40;
    const pkmodes_real D_p_z_5 = A_z_5*t41;
    const pkmodes_real D_p_z_6 = A_z_6*t42;
    const pkmodes_real D_p_rx_1 = A_rx_1*t37;
    const pkmodes_real D_p_rx_2 = A_rx_2*t38;
    const pkmodes_real D_p_rx_3 = A_rx_3*t39;
    const pkmodes_real D_p_rx_4 = A_rx_4*t40;
    const pkmodes_real D_p_rx_5 = A_rx_5*t41;
    const pkmodes_real D_p_rx_6 = A_rx_6*t42;
    const pkmodes_real D_p_ry_1 = A_ry_1*t37;
    const pkmodes_real D_p_ry_2 = A_ry_2*t38;
    const pkmodes_real D_p_ry_3 = A_ry_3*t39;
    const pkmodes_real D_p_ry_4 = A_ry_4*t40;
    const pkmodes_real D_p_ry_5 = A_ry_5*t41;
    const pkmodes_real D_p_ry_6 = A_ry_6*t42;
    const pkmodes_real D_p_rz_1 = A_rz_1*t37;
    const pkmodes_real D_p_rz_2 = A_rz_2*t38;
    const pkmodes_real D_p_rz_3 = A_rz_3*t39;
    const pkmodes_real D_p_rz_4 = A_rz_4*t40;
    const pkmodes_real D_p_rz_5 = A_rz_5*t41;
    const pkmodes_real D_p_rz_6 = A_rz_6*t42;
    const pkmodes_real M_p_x_x = m_p + m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6;
    const pkmodes_real t43 = B_1_z*m_perp_1;
    const pkmodes_real t44 = B_2_z*m_perp_2;
    const pkmodes_real t45 = B_3_z*m_perp_3;
    const pkmodes_real t46 = B_4_z*m_perp_4;
    const pkmodes_real t47 = B_5_z*m_perp_5;
    const pkmodes_real t48 = B_6_z*m_perp_6;
    const pkmodes_real t49 = c_z*m_p;
    const pkmodes_real M_p_x_ry = t43 + t44 + t45 + t46 + t47 + t48 + t49;
    const pkmodes_real t50 = B_1_y*m_perp_1;
    const pkmodes_real t51 = B_2_y*m_perp_2;
    const pkmodes_real t52 = B_3_y*m_perp_3;
    const pkmodes_real t53 = B_4_y*m_perp_4;
    const pkmodes_real t54 = B_5_y*m_perp_5;
    const pkmodes_real t55 = B_6_y*m_perp_6;
    const pkmodes_real t56 = c_y*m_p;
    const pkmodes_real M_p_z_rx = t50 + t51 + t52 + t53 + t54 + t55 + t56;
    const pkmodes_real M_p_x_rz = -M_p_z_rx;
    const pkmodes_real M_p_y_rx = -M_p_x_ry;
    const pkmodes_real M_p_y_rz =
        B_1_x*m_perp_1 + B_2_x*m_perp_2 + B_3_x*m_perp_3 + B_4_x*m_perp_4 + B_5_x*m_perp_5 + B_6_x*m_perp_6
        + c_x*m_p;
    const pkmodes_real M_p_z_ry = -M_p_y_rz;
    const pkmodes_real t57 = 2*(c_y*c_y);
    const pkmodes_real t58 = 2*(c_z*c_z);
    const pkmodes_real t59 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real t60 = 2*(B_1_y*B_1_y);
    const pkmodes_real t61 = 2*(B_1_z*B_1_z);
    const pkmodes_real t62 = (R(1.0)/R(2.0))*m_perp_1;
    const pkmodes_real t63 = 2*(B_2_y*B_2_y);
    const pkmodes_real t64 = 2*(B_2_z*B_2_z);
    const pkmodes_real t65 = (R(1.0)/R(2.0))*m_perp_2;
    const pkmodes_real t66 = 2*(B_3_y*B_3_y);
    const pkmodes_real t67 = 2*(B_3_z*B_3_z);
    const pkmodes_real t68 = (R(1.0)/R(2.0))*m_perp_3;
    const pkmodes_real t69 = 2*(B_4_y*B_4_y);
    const pkmodes_real t70 = 2*(B_4_z*B_4_z);
    const pkmodes_real t71 = (R(1.0)/R(2.0))*m_perp_4;
    const pkmodes_real t72 = 2*(B_5_y*B_5_y);
    const pkmodes_real t73 = 2*(B_5_z*B_5_z);
    const pkmodes_real t74 = (R(1.0)/R(2.0))*m_perp_5;
    const pkmodes_real t75 = 2*(B_6_y*B_6_y);
    const pkmodes_real t76 = 2*(B_6_z*B_6_z);
    const pkmodes_real t77 = (R(1.0)/R(2.0))*m_perp_6;
    const pkmodes_real M_p_rx_rx =
        J_x_x + t59*(t57 + t58) + t62*(t60 + t61) + t65*(t63 + t64) + t68*(t66 + t67) + t71*(t69 + t70)
        + t74*(t72 + t73) + t77*(t75 + t76);
    const pkmodes_real M_p_rx_ry =
        -B_1_x*t50 - B_2_x*t51 - B_3_x*t52 - B_4_x*t53 - B_5_x*t54 - B_6_x*t55 + J_x_y - c_x*t56;
    const pkmodes_real M_p_rx_rz =
        -B_1_x*t43 - B_2_x*t44 - B_3_x*t45 - B_4_x*t46 - B_5_x*t47 - B_6_x*t48 + J_x_z - c_x*t49;
    const pkmodes_real t78 = 2*(c_x*c_x);
    const pkmodes_real t79 = 2*(B_1_x*B_1_x);
    const pkmodes_real t80 = 2*(B_2_x*B_2_x);
    const pkmodes_real t81 = 2*(B_3_x*B_3_x);
    const pkmodes_real t82 = 2*(B_4_x*B_4_x);
    const pkmodes_real t83 = 2*(B_5_x*B_5_x);
    const pkmodes_real t84 = 2*(B_6_x*B_6_x);
    const pkmodes_real M_p_ry_ry =
        J_y_y + t59*(t58 + t78) + t62*(t61 + t79) + t65*(t64 + t80) + t68*(t67 + t81) + t71*(t70 + t82)
        + t74*(t73 + t83) + t77*(t76 + t84);
    const pkmodes_real M_p_ry_rz =
        -B_1_y*t43 - B_2_y*t44 - B_3_y*t45 - B_4_y*t46 - B_5_y*t47 - B_6_y*t48 + J_y_z - c_y*t49;
    const pkmodes_real M_p_rz_rz =
        J_z_z + t59*(t57 + t78) + t62*(t60 + t79) + t65*(t63 + t80) + t68*(t66 + t81) + t71*(t69 + t82)
        + t74*(t72 + t83) + t77*(t75 + t84);
    const pkmodes_real h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const pkmodes_real h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const pkmodes_real h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const pkmodes_real h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const pkmodes_real h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const pkmodes_real h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const pkmodes_real h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const pkmodes_real h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const pkmodes_real h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const pkmodes_real h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const pkmodes_real h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const pkmodes_real h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const pkmodes_real h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const pkmodes_real h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const pkmodes_real h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const pkmodes_real h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const pkmodes_real h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const pkmodes_real h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
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
    memset(M, 0, sizeof(pkmodes_real[12][12]));
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
    M[3][3] =
        D_p_rx_4*h_rx_l_4 + D_p_ry_4*h_ry_l_4 + D_p_rz_4*h_rz_l_4 + D_p_x_4*h_x_l_4 + D_p_y_4*h_y_l_4
        + D_p_z_4*h_z_l_4 - m_perp_4 + m_r_4;
    M[3][4] = M[4][3] =
        D_p_rx_4*h_rx_l_5 + D_p_ry_4*h_ry_l_5 + D_p_rz_4*h_rz_l_5 + D_p_x_4*h_x_l_5 + D_p_y_4*h_y_l_5
        + D_p_z_4*h_z_l_5;
    M[3][5] = M[5][3] =
        D_p_rx_4*h_rx_l_6 + D_p_ry_4*h_ry_l_6 + D_p_rz_4*h_rz_l_6 + D_p_x_4*h_x_l_6 + D_p_y_4*h_y_l_6
        + D_p_z_4*h_z_l_6;
    M[4][4] =
        D_p_rx_5*h_rx_l_5 + D_p_ry_5*h_ry_l_5 + D_p_rz_5*h_rz_l_5 + D_p_x_5*h_x_l_5 + D_p_y_5*h_y_l_5
        + D_p_z_5*h_z_l_5 - m_perp_5 + m_r_5;
    M[4][5] = M[5][4] =
        D_p_rx_5*h_rx_l_6 + D_p_ry_5*h_ry_l_6 + D_p_rz_5*h_rz_l_6 + D_p_x_5*h_x_l_6 + D_p_y_5*h_y_l_6
        + D_p_z_5*h_z_l_6;
    M[5][5] =
        D_p_rx_6*h_rx_l_6 + D_p_ry_6*h_ry_l_6 + D_p_rz_6*h_rz_l_6 + D_p_x_6*h_x_l_6 + D_p_y_6*h_y_l_6
        + D_p_z_6*h_z_l_6 - m_perp_6 + m_r_6;
    M[6][6] = I_m_1/(h_m_1*h_m_1);
    M[7][7] = I_m_2/(h_m_2*h_m_2);
    M[8][8] = I_m_3/(h_m_3*h_m_3);
    M[9][9] = I_m_4/(h_m_4*h_m_4);
    M[10][10] = I_m_5/(h_m_5*h_m_5);
    M[11][11] = I_m_6/(h_m_6*h_m_6);
}

void hexapod_velocity_forces(const pkmodes_real p[6], const pkmodes_real l_dot[6],
    const hexapod_parameters *parameters, pkmodes_real h[6])
{
    const pkmodes_real p_x = p[0];
    const pkmodes_real p_y = p[1];
    const pkmodes_real p_z = p[2];
    const pkmodes_real rot_x = p[3];
    const pkmodes_real rot_y = p[4];
    const pkmodes_real rot_z = p[5];
    const pkmodes_real l_1_dot = l_dot[0];
    const pkmodes_real l_2_dot = l_dot[1];
    const pkmodes_real l_3_dot = l_dot[2];
    const pkmodes_real l_4_dot = l_dot[3];
    const pkmodes_real l_5_dot = l_dot[4];
    const pkmodes_real l_6_dot = l_dot[5];
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
    const pkmodes_real t42 = 1/((l_1*l_1));
    const pkmodes_real t43 = (c_b_1*c_b_1)*m_b_1;
    const pkmodes_real t44 = -c_r_1/l_1 + 1;
    const pkmodes_real m_perp_1 = I_b_1*t42 + I_r_1*t42 + m_r_1*(t44*t44) + t42*t43;
    const pkmodes_real t45 = 1/((l_2*l_2));
    const pkmodes_real t46 = (c_b_2*c_b_2)*m_b_2;
    const pkmodes_real t47 = -c_r_2/l_2 + 1;
    const pkmodes_real m_perp_2 = I_b_2*t45 + I_r_2*t45 + m_r_2*(t47*t47) + t45*t46;
    const pkmodes_real t48 = 1/((l_3*l_3));
    const pkmodes_real t49 = (c_b_3*c_b_3)*m_b_3;
    const pkmodes_real t50 = -c_r_3/l_3 + 1;
    const pkmodes_real m_perp_3 = I_b_3*t48 + I_r_3*t48 + m_r_3*(t50*t50) + t48*t49;
    const pkmodes_real t51 = 1/((l_4*l_4));
    const pkmodes_real t52 = (c_b_4*c_b_4)*m_b_4;
    const pkmodes_real t53 = -c_r_4/l_4 + 1;
    const pkmodes_real m_perp_4 = I_b_4*t51 + I_r_4*t51 + m_r_4*(t53*t53) + t51*t52;
    const pkmodes_real t54 = 1/((l_5*l_5));
    const pkmodes_real t55 = (c_b_5*c_b_5)*m_b_5;
    const pkmodes_real t56 = -c_r_5/l_5 + 1;
    const pkmodes_real m_perp_5 = I_b_5*t54 + I_r_5*t54 + m_r_5*(t56*t56) + t54*t55;
    const pkmodes_real t57 = 1/((l_6*l_6));
    const pkmodes_real t58 = (c_b_6*c_b_6)*m_b_6;
    const pkmodes_real t59 = -c_r_6/l_6 + 1;
    const pkmodes_real m_perp_6 = I_b_6*t57 + I_r_6*t57 + m_r_6*(t59*t59) + t57*t58;
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
    const pkmodes_real t60 = 1/det_D_l;
    const pkmodes_real t61 = l_1*t60;
    const pkmodes_real D_p_x_1 = A_x_1*t61;
    const pkmodes_real t62 = l_2*t60;
    const pkmodes_real D_p_x_2 = A_x_2*t62;
    const pkmodes_real t63 = l_3*t60;
    const pkmodes_real D_p_x_3 = A_x_3*t63;
    const pkmodes_real t64 = l_4*t60;
    const pkmodes_real D_p_x_4 = A_x_4*t64;
    const pkmodes_real t65 = l_5*t60;
    const pkmodes_real D_p_x_5 = A_x_5*t65;
    const pkmodes_real t66 = l_6*t60;
    const pkmodes_real D_p_x_6 = A_x_6*t66;
    const pkmodes_real D_p_y_1 = A_y_1*t61;
    const pkmodes_real D_p_y_2 = A_y_2*t62;
    const pkmodes_real D_p_y_3 = A_y_3*t63;
    const pkmodes_real D_p_y_4 = A_y_4*t64;
    const pkmodes_real D_p_y_5 = A_y_5*t65;
    const pkmodes_real D_p_y_6 = A_y_6*t66;
    const pkmodes_real D_p_z_1 = A_z_1*t61;
    const pkmodes_real D_p_z_2 = A_z_2*t62;
    const pkmodes_real D_p_z_3 = A_z_3*t63;
    const pkmodes_real D_p_z_4 = A_z_4*t64;
    const pkmodes_real D_p_z_5 = A_z_5*t65;
    const pkmodes_real D_p_z_6 = A_z_6*t66;
    const pkmodes_real D_p_rx_1 = A_rx_1*t61;
    const pkmodes_real D_p_rx_2 = A_rx_2*t62;
    const pkmodes_real D_p_rx_3 = A_rx_3*t63;
    const pkmodes_real D_p_rx_4 = A_rx_4*t64;
    const pkmodes_real D_p_rx_5 = A_rx_5*t65;
    const pkmodes_real D_p_rx_6 = A_rx_6*t66;
    const pkmodes_real D_p_ry_1 = A_ry_1*t61;
    const pkmodes_real D_p_ry_2 = A_ry_2*t62;
    const pkmodes_real D_p_ry_3 = A_ry_3*t63;
    const pkmodes_real D_p_ry_4 = A_ry_4*t64;
    const pkmodes_real D_p_ry_5 = A_ry_5*t65;
    const pkmodes_real D_p_ry_6 = A_ry_6*t66;
    const pkmodes_real D_p_rz_1 = A_rz_1*t61;
    const pkmodes_real D_p_rz_2 = A_rz_2*t62;
    const pkmodes_real D_p_rz_3 = A_rz_3*t63;
    const pkmodes_real D_p_rz_4 = A_rz_4*t64;
    const pkmodes_real D_p_rz_5 = A_rz_5*t65;
    const pkmodes_real D_p_rz_6 = A_rz_6*t66;
    const pkmodes_real t67 = B_1_y*D_p_rz_1;
    const pkmodes_real U_1_x_1 = B_1_z*D_p_ry_1 + D_p_x_1 - t67;
    const pkmodes_real t68 = B_1_y*D_p_rz_2;
    const pkmodes_real U_1_x_2 = B_1_z*D_p_ry_2 + D_p_x_2 - t68;
    const pkmodes_real t69 = B_1_y*D_p_rz_3;
    const pkmodes_real U_1_x_3 = B_1_z*D_p_ry_3 + D_p_x_3 - t69;
    const pkmodes_real t70 = B_1_y*D_p_rz_4;
    const pkmodes_real U_1_x_4 = B_1_z*D_p_ry_4 + D_p_x_4 - t70;
    const pkmodes_real t71 = B_1_y*D_p_rz_5;
    const pkmodes_real U_1_x_5 = B_1_z*D_p_ry_5 + D_p_x_5 - t71;
    const pkmodes_real t72 = B_1_y*D_p_rz_6;
    const pkmodes_real U_1_x_6 = B_1_z*D_p_ry_6 + D_p_x_6 - t72;
    const pkmodes_real t73 = B_1_x*D_p_rz_1 - B_1_z*D_p_rx_1;
    const pkmodes_real U_1_y_1 = D_p_y_1 + t73;
    const pkmodes_real t74 = B_1_x*D_p_rz_2 - B_1_z*D_p_rx_2;
    const pkmodes_real U_1_y_2 = D_p_y_2 + t74;
    const pkmodes_real t75 = B_1_x*D_p_rz_3 - B_1_z*D_p_rx_3;
    const pkmodes_real U_1_y_3 = D_p_y_3 + t75;
    const pkmodes_real t76 = B_1_x*D_p_rz_4 - B_1_z*D_p_rx_4;
    const pkmodes_real U_1_y_4 = D_p_y_4 + t76;
    const pkmodes_real t77 = B_1_x*D_p_rz_5 - B_1_z*D_p_rx_5;
    const pkmodes_real U_1_y_5 = D_p_y_5 + t77;
    const pkmodes_real t78 = B_1_x*D_p_rz_6 - B_1_z*D_p_rx_6;
    const pkmodes_real U_1_y_6 = D_p_y_6 + t78;
    const pkmodes_real t79 = B_1_x*D_p_ry_1;
    const pkmodes_real U_1_z_1 = B_1_y*D_p_rx_1 + D_p_z_1 - t79;
    const pkmodes_real t80 = B_1_x*D_p_ry_2;
    const pkmodes_real U_1_z_2 = B_1_y*D_p_rx_2 + D_p_z_2 - t80;
    const pkmodes_real t81 = B_1_x*D_p_ry_3;
    const pkmodes_real U_1_z_3 = B_1_y*D_p_rx_3 + D_p_z_3 - t81;
    const pkmodes_real t82 = B_1_x*D_p_ry_4;
    const pkmodes_real U_1_z_4 = B_1_y*D_p_rx_4 + D_p_z_4 - t82;
    const pkmodes_real t83 = B_1_x*D_p_ry_5;
    const pkmodes_real U_1_z_5 = B_1_y*D_p_rx_5 + D_p_z_5 - t83;
    const pkmodes_real t84 = B_1_x*D_p_ry_6;
    const pkmodes_real U_1_z_6 = B_1_y*D_p_rx_6 + D_p_z_6 - t84;
    const pkmodes_real t85 = B_2_y*D_p_rz_1;
    const pkmodes_real U_2_x_1 = B_2_z*D_p_ry_1 + D_p_x_1 - t85;
    const pkmodes_real t86 = B_2_y*D_p_rz_2;
    const pkmodes_real U_2_x_2 = B_2_z*D_p_ry_2 + D_p_x_2 - t86;
    const pkmodes_real t87 = B_2_y*D_p_rz_3;
    const pkmodes_real U_2_x_3 = B_2_z*D_p_ry_3 + D_p_x_3 - t87;
    const pkmodes_real t88 = B_2_y*D_p_rz_4;
    const pkmodes_real U_2_x_4 = B_2_z*D_p_ry_4 + D_p_x_4 - t88;
    const pkmodes_real t89 = B_2_y*D_p_rz_5;
    const pkmodes_real U_2_x_5 = B_2_z*D_p_ry_5 + D_p_x_5 - t89;
    const pkmodes_real t90 = B_2_y*D_p_rz_6;
    const pkmodes_real U_2_x_6 = B_2_z*D_p_ry_6 + D_p_x_6 - t90;
    const pkmodes_real t91 = B_2_x*D_p_rz_1 - B_2_z*D_p_rx_1;
    const pkmodes_real U_2_y_1 = D_p_y_1 + t91;
    const pkmodes_real t92 = B_2_x*D_p_rz_2 - B_2_z*D_p_rx_2;
    const pkmodes_real U_2_y_2 = D_p_y_2 + t92;
    const pkmodes_real t93 = B_2_x*D_p_rz_3 - B_2_z*D_p_rx_3;
    const pkmodes_real U_2_y_3 = D_p_y_3 + t93;
    const pkmodes_real t94 = B_2_x*D_p_rz_4 - B_2_z*D_p_rx_4;
    const pkmodes_real U_2_y_4 = D_p_y_4 + t94;
    const pkmodes_real t95 = B_2_x*D_p_rz_5 - B_2_z*D_p_rx_5;
    const pkmodes_real U_2_y_5 = D_p_y_5 + t95;
    const pkmodes_real t96 = B_2_x*D_p_rz_6 - B_2_z*D_p_rx_6;
    const pkmodes_real U_2_y_6 = D_p_y_6 + t96;
    const pkmodes_real t97 = B_2_x*D_p_ry_1;
    const pkmodes_real U_2_z_1 = B_2_y*D_p_rx_1 + D_p_z_1 - t97;
    const pkmodes_real t98 = B_2_x*D_p_ry_2;
    const pkmodes_real U_2_z_2 = B_2_y*D_p_rx_2 + D_p_z_2 - t98;
    const pkmodes_real t99 = B_2_x*D_p_ry_3;
    const pkmodes_real U_2_z_3 = B_2_y*D_p_rx_3 + D_p_z_3 - t99;
    const pkmodes_real t100 = B_2_x*D_p_ry_4;
    const pkmodes_real U_2_z_4 = B_2_y*D_p_rx_4 + D_p_z_4 - t100;
    const pkmodes_real t101 = B_2_x*D_p_ry_5;
    const pkmodes_real U_2_z_5 = B_2_y*D_p_rx_5 + D_p_z_5 - t101;
    const pkmodes_real t102 = B_2_x*D_p_ry_6;
    const pkmodes_real U_2_z_6 = B_2_y*D_p_rx_6 + D_p_z_6 - t102;
    const pkmodes_real t103 = B_3_y*D_p_rz_1;
    const pkmodes_real U_3_x_1 = B_3_z*D_p_ry_1 + D_p_x_1 - t103;
    const pkmodes_real t104 = B_3_y*D_p_rz_2;
    const pkmodes_real U_3_x_2 = B_3_z*D_p_ry_2 + D_p_x_2 - t104;
    const pkmodes_real t105 = B_3_y*D_p_rz_3;
    const pkmodes_real U_3_x_3 = B_3_z*D_p_ry_3 + D_p_x_3 - t105;
    const pkmodes_real t106 = B_3_y*D_p_rz_4;
    const pkmodes_real U_3_x_4 = B_3_z*D_p_ry_4 + D_p_x_4 - t106;
    const pkmodes_real t107 = B_3_y*D_p_rz_5;
    const pkmodes_real U_3_x_5 = B_3_z*D_p_ry_5 + D_p_x_5 - t107;
    const pkmodes_real t108 = B_3_y*D_p_rz_6;
    const pkmodes_real U_3_x_6 = B_3_z*D_p_ry_6 + D_p_x_6 - t108;
    const pkmodes_real t109 = B_3_x*D_p_rz_1 - B_3_z*D_p_rx_1;
    const pkmodes_real U_3_y_1 = D_p_y_1 + t109;
    const pkmodes_real t110 = B_3_x*D_p_rz_2 - B_3_z*D_p_rx_2;
    const pkmodes_real U_3_y_2 = D_p_y_2 + t110;
    const pkmodes_real t111 = B_3_x*D_p_rz_3 - B_3_z*D_p_rx_3;
    const pkmodes_real U_3_y_3 = D_p_y_3 + t111;
    const pkmodes_real t112 = B_3_x*D_p_rz_4 - B_3_z*D_p_rx_4;
    const pkmodes_real U_3_y_4 = D_p_y_4 + t112;
    const pkmodes_real t113 = B_3_x*D_p_rz_5 - B_3_z*D_p_rx_5;
    const pkmodes_real U_3_y_5 = D_p_y_5 + t113;
    const pkmodes_real t114 = B_3_x*D_p_rz_6 - B_3_z*D_p_rx_6;
    const pkmodes_real U_3_y_6 = D_p_y_6 + t114;
    const pkmodes_real t115 = B_3_x*D_p_ry_1;
    const pkmodes_real U_3_z_1 = B_3_y*D_p_rx_1 + D_p_z_1 - t115;
    const pkmodes_real t116 = B_3_x*D_p_ry_2;
    const pkmodes_real U_3_z_2 = B_3_y*D_p_rx_2 + D_p_z_2 - t116;
    const pkmodes_real t117 = B_3_x*D_p_ry_3;
    const pkmodes_real U_3_z_3 = B_3_y*D_p_rx_3 + D_p_z_3 - t117;
    const pkmodes_real t118 = B_3_x*D_p_ry_4;
    const pkmodes_real U_3_z_4 = B_3_y*D_p_rx_4 + D_p_z_4 - t118;
    const pkmodes_real t119 = B_3_x*D_p_ry_5;
    const pkmodes_real U_3_z_5 = B_3_y*D_p_rx_5 + D_p_z_5 - t119;
    const pkmodes_real t120 = B_3_x*D_p_ry_6;
    const pkmodes_real U_3_z_6 = B_3_y*D_p_rx_6 + D_p_z_6 - t120;
    const pkmodes_real t121 = B_4_y*D_p_rz_1;
    const pkmodes_real U_4_x_1 = B_4_z*D_p_ry_1 + D_p_x_1 - t121;
    const pkmodes_real t122 = B_4_y*D_p_rz_2;
    const pkmodes_real U_4_x_2 = B_4_z*D_p_ry_2 + D_p_x_2 - t122;
    const pkmodes_real t123 = B_4_y*D_p_rz_3;
    const pkmodes_real U_4_x_3 = B_4_z*D_p_ry_3 + D_p_x_3 - t123;
    const pkmodes_real t124 = B_4_y*D_p_rz_4;
    const pkmodes_real U_4_x_4 = B_4_z*D_p_ry_4 + D_p_x_4 - t124;
    const pkmodes_real t125 = B_4_y*D_p_rz_5;
    const pkmodes_real U_4_x_5 = B_4_z*D_p_ry_5 + D_p_x_5 - t125;
    const pkmodes_real t126 = B_4_y*D_p_rz_6;
    const pkmodes_real U_4_x_6 = B_4_z*D_p_ry_6 + D_p_x_6 - t126;
    const pkmodes_real t127 = B_4_x*D_p_rz_1 - B_4_z*D_p_rx_1;
    const pkmodes_real U_4_y_1 = D_p_y_1 + t127;
    const pkmodes_real t128 = B_4_x*D_p_rz_2 - B_4_z*D_p_rx_2;
    const pkmodes_real U_4_y_2 = D_p_y_2 + t128;
    const pkmodes_real t129 = B_4_x*D_p_rz_3 - B_4_z*D_p_rx_3;
    const pkmodes_real U_4_y_3 = D_p_y_3 + t129;
    const pkmodes_real t130 = B_4_x*D_p_rz_4 - B_4_z*D_p_rx_4;
    const pkmodes_real U_4_y_4 = D_p_y_4 + t130;
    const pkmodes_real t131 = B_4_x*D_p_rz_5 - B_4_z*D_p_rx_5;
    const pkmodes_real U_4_y_5 = D_p_y_5 + t131;
    const pkmodes_real t132 = B_4_x*D_p_rz_6 - B_4_z*D_p_rx_6;
    const pkmodes_real U_4_y_6 = D_p_y_6 + t132;
    const pkmodes_real t133 = B_4_x*D_p_ry_1;
    const pkmodes_real U_4_z_1 = B_4_y*D_p_rx_1 + D_p_z_1 - t133;
    const pkmodes_real t134 = B_4_x*D_p_ry_2;
    const pkmodes_real U_4_z_2 = B_4_y*D_p_rx_2 + D_p_z_2 - t134;
    const pkmodes_real t135 = B_4_x*D_p_ry_3;
    const pkmodes_real U_4_z_3 = B_4_y*D_p_rx_3 + D_p_z_3 - t135;
    const pkmodes_real t136 = B_4_x*D_p_ry_4;
    const pkmodes_real U_4_z_4 = B_4_y*D_p_rx_4 + D_p_z_4 - t136;
    const pkmodes_real t137 = B_4_x*D_p_ry_5;
    const pkmodes_real U_4_z_5 = B_4_y*D_p_rx_5 + D_p_z_5 - t137;
    const pkmodes_real t138 = B_4_x*D_p_ry_6;
    const pkmodes_real U_4_z_6 = B_4_y*D_p_rx_6 + D_p_z_6 - t138;
    const pkmodes_real t139 = B_5_y*D_p_rz_1;
    const pkmodes_real U_5_x_1 = B_5_z*D_p_ry_1 + D_p_x_1 - t139;
    const pkmodes_real t140 = B_5_y*D_p_rz_2;
    const pkmodes_real U_5_x_2 = B_5_z*D_p_ry_2 + D_p_x_2 - t140;
    const pkmodes_real t141 = B_5_y*D_p_rz_3;
    const pkmodes_real U_5_x_3 = B_5_z*D_p_ry_3 + D_p_x_3 - t141;
    const pkmodes_real t142 = B_5_y*D_p_rz_4;
    const pkmodes_real U_5_x_4 = B_5_z*D_p_ry_4 + D_p_x_4 - t142;
    const pkmodes_real t143 = B_5_y*D_p_rz_5;
    const pkmodes_real U_5_x_5 = B_5_z*D_p_ry_5 + D_p_x_5 - t143;
    const pkmodes_real t144 = B_5_y*D_p_rz_6;
    const pkmodes_real U_5_x_6 = B_5_z*D_p_ry_6 + D_p_x_6 - t144;
    const pkmodes_real t145 = B_5_x*D_p_rz_1 - B_5_z*D_p_rx_1;
    const pkmodes_real U_5_y_1 = D_p_y_1 + t145;
    const pkmodes_real t146 = B_5_x*D_p_rz_2 - B_5_z*D_p_rx_2;
    const pkmodes_real U_5_y_2 = D_p_y_2 + t146;
    const pkmodes_real t147 = B_5_x*D_p_rz_3 - B_5_z*D_p_rx_3;
    const pkmodes_real U_5_y_3 = D_p_y_3 + t147;
    const pkmodes_real t148 = B_5_x*D_p_rz_4 - B_5_z*D_p_rx_4;
    const pkmodes_real U_5_y_4 = D_p_y_4 + t148;
    const pkmodes_real t149 = B_5_x*D_p_rz_5 - B_5_z*D_p_rx_5;
    const pkmodes_real U_5_y_5 = D_p_y_5 + t149;
    const pkmodes_real t150 = B_5_x*D_p_rz_6 - B_5_z*D_p_rx_6;
    const pkmodes_real U_5_y_6 = D_p_y_6 + t150;
    const pkmodes_real t151 = B_5_x*D_p_ry_1;
    const pkmodes_real U_5_z_1 = B_5_y*D_p_rx_1 + D_p_z_1 - t151;
    const pkmodes_real t152 = B_5_x*D_p_ry_2;
    const pkmodes_real U_5_z_2 = B_5_y*D_p_rx_2 + D_p_z_2 - t152;
    const pkmodes_real t153 = B_5_x*D_p_ry_3;
    const pkmodes_real U_5_z_3 = B_5_y*D_p_rx_3 + D_p_z_3 - t153;
    const pkmodes_real t154 = B_5_x*D_p_ry_4;
    const pkmodes_real U_5_z_4 = B_5_y*D_p_rx_4 + D_p_z_4 - t154;
    const pkmodes_real t155 = B_5_x*D_p_ry_5;
    const pkmodes_real U_5_z_5 = B_5_y*D_p_rx_5 + D_p_z_5 - t155;
    const pkmodes_real t156 = B_5_x*D_p_ry_6;
    const pkmodes_real U_5_z_6 = B_5_y*D_p_rx_6 + D_p_z_6 - t156;
    const pkmodes_real t157 = B_6_y*D_p_rz_1;
    const pkmodes_real U_6_x_1 = B_6_z*D_p_ry_1 + D_p_x_1 - t157;
    const pkmodes_real t158 = B_6_y*D_p_rz_2;
    const pkmodes_real U_6_x_2 = B_6_z*D_p_ry_2 + D_p_x_2 - t158;
    const pkmodes_real t159 = B_6_y*D_p_rz_3;
    const pkmodes_real U_6_x_3 = B_6_z*D_p_ry_3 + D_p_x_3 - t159;
    const pkmodes_real t160 = B_6_y*D_p_rz_4;
    const pkmodes_real U_6_x_4 = B_6_z*D_p_ry_4 + D_p_x_4 - t160;
    const pkmodes_real t161 = B_6_y*D_p_rz_5;
    const pkmodes_real U_6_x_5 = B_6_z*D_p_ry_5 + D_p_x_5 - t161;
    const pkmodes_real t162 = B_6_y*D_p_rz_6;
    const pkmodes_real U_6_x_6 = B_6_z*D_p_ry_6 + D_p_x_6 - t162;
    const pkmodes_real t163 = B_6_x*D_p_rz_1 - B_6_z*D_p_rx_1;
    const pkmodes_real U_6_y_1 = D_p_y_1 + t163;
    const pkmodes_real t164 = B_6_x*D_p_rz_2 - B_6_z*D_p_rx_2;
    const pkmodes_real U_6_y_2 = D_p_y_2 + t164;
    const pkmodes_real t165 = B_6_x*D_p_rz_3 - B_6_z*D_p_rx_3;
    const pkmodes_real U_6_y_3 = D_p_y_3 + t165;
    const pkmodes_real t166 = B_6_x*D_p_rz_4 - B_6_z*D_p_rx_4;
    const pkmodes_real U_6_y_4 = D_p_y_4 + t166;
    const pkmodes_real t167 = B_6_x*D_p_rz_5 - B_6_z*D_p_rx_5;
    const pkmodes_real U_6_y_5 = D_p_y_5 + t167;
    const pkmodes_real t168 = B_6_x*D_p_rz_6 - B_6_z*D_p_rx_6;
    const pkmodes_real U_6_y_6 = D_p_y_6 + t168;
    const pkmodes_real t169 = B_6_x*D_p_ry_1;
    const pkmodes_real U_6_z_1 = B_6_y*D_p_rx_1 + D_p_z_1 - t169;
    const pkmodes_real t170 = B_6_x*D_p_ry_2;
    const pkmodes_real U_6_z_2 = B_6_y*D_p_rx_2 + D_p_z_2 - t170;
    const pkmodes_real t171 = B_6_x*D_p_ry_3;
    const pkmodes_real U_6_z_3 = B_6_y*D_p_rx_3 + D_p_z_3 - t171;
    const pkmodes_real t172 = B_6_x*D_p_ry_4;
    const pkmodes_real U_6_z_4 = B_6_y*D_p_rx_4 + D_p_z_4 - t172;
    const pkmodes_real t173 = B_6_x*D_p_ry_5;
    const pkmodes_real U_6_z_5 = B_6_y*D_p_rx_5 + D_p_z_5 - t173;
    const pkmodes_real t174 = B_6_x*D_p_ry_6;
    const pkmodes_real U_6_z_6 = B_6_y*D_p_rx_6 + D_p_z_6 - t174;
    const pkmodes_real v_p_x =
        D_p_x_1*l_1_dot + D_p_x_2*l_2_dot + D_p_x_3*l_3_dot + D_p_x_4*l_4_dot + D_p_x_5*l_5_dot
        + D_p_x_6*l_6_dot;
    const pkmodes_real v_p_y =
        D_p_y_1*l_1_dot + D_p_y_2*l_2_dot + D_p_y_3*l_3_dot + D_p_y_4*l_4_dot + D_p_y_5*l_5_dot
        + D_p_y_6*l_6_dot;
    const pkmodes_real v_p_z =
        D_p_z_1*l_1_dot + D_p_z_2*l_2_dot + D_p_z_3*l_3_dot + D_p_z_4*l_4_dot + D_p_z_5*l_5_dot
        + D_p_z_6*l_6_dot;
    const pkmodes_real w_p_x =
        D_p_rx_1*l_1_dot + D_p_rx_2*l_2_dot + D_p_rx_3*l_3_dot + D_p_rx_4*l_4_dot + D_p_rx_5*l_5_dot
        + D_p_rx_6*l_6_dot;
    const pkmodes_real w_p_y =
        D_p_ry_1*l_1_dot + D_p_ry_2*l_2_dot + D_p_ry_3*l_3_dot + D_p_ry_4*l_4_dot + D_p_ry_5*l_5_dot
        + D_p_ry_6*l_6_dot;
    const pkmodes_real w_p_z =
        D_p_rz_1*l_1_dot + D_p_rz_2*l_2_dot + D_p_rz_3*l_3_dot + D_p_rz_4*l_4_dot + D_p_rz_5*l_5_dot
        + D_p_rz_6*l_6_dot;
    const pkmodes_real s_dot_1_x =
        U_1_x_1*l_1_dot + U_1_x_2*l_2_dot + U_1_x_3*l_3_dot + U_1_x_4*l_4_dot + U_1_x_5*l_5_dot
        + U_1_x_6*l_6_dot;
    const pkmodes_real s_dot_1_y =
        U_1_y_1*l_1_dot + U_1_y_2*l_2_dot + U_1_y_3*l_3_dot + U_1_y_4*l_4_dot + U_1_y_5*l_5_dot
        + U_1_y_6*l_6_dot;
    const pkmodes_real s_dot_1_z =
        U_1_z_1*l_1_dot + U_1_z_2*l_2_dot + U_1_z_3*l_3_dot + U_1_z_4*l_4_dot + U_1_z_5*l_5_dot
        + U_1_z_6*l_6_dot;
    const pkmodes_real s_dot_2_x =
        U_2_x_1*l_1_dot + U_2_x_2*l_2_dot + U_2_x_3*l_3_dot + U_2_x_4*l_4_dot + U_2_x_5*l_5_dot
        + U_2_x_6*l_6_dot;
    const pkmodes_real s_dot_2_y =
        U_2_y_1*l_1_dot + U_2_y_2*l_2_dot + U_2_y_3*l_3_dot + U_2_y_4*l_4_dot + U_2_y_5*l_5_dot
        + U_2_y_6*l_6_dot;
    const pkmodes_real s_dot_2_z =
        U_2_z_1*l_1_dot + U_2_z_2*l_2_dot + U_2_z_3*l_3_dot + U_2_z_4*l_4_dot + U_2_z_5*l_5_dot
        + U_2_z_6*l_6_dot;
    const pkmodes_real s_dot_3_x =
        U_3_x_1*l_1_dot + U_3_x_2*l_2_dot + U_3_x_3*l_3_dot + U_3_x_4*l_4_dot + U_3_x_5*l_5_dot
        + U_3_x_6*l_6_dot;
    const pkmodes_real s_dot_3_y =
        U_3_y_1*l_1_dot + U_3_y_2*l_2_dot + U_3_y_3*l_3_dot + U_3_y_4*l_4_dot + U_3_y_5*l_5_dot
        + U_3_y_6*l_6_dot;
    const pkmodes_real s_dot_3_z =
        U_3_z_1*l_1_dot + U_3_z_2*l_2_dot + U_3_z_3*l_3_dot + U_3_z_4*l_4_dot + U_3_z_5*l_5_dot
        + U_3_z_6*l_6_dot;
    const pkmodes_real s_dot_4_x =
        U_4_x_1*l_1_dot + U_4_x_2*l_2_dot + U_4_x_3*l_3_dot + U_4_x_4*l_4_dot + U_4_x_5*l_5_dot
        + U_4_x_6*l_6_dot;
    const pkmodes_real s_dot_4_y =
        U_4_y_1*l_1_dot + U_4_y_2*l_2_dot + U_4_y_3*l_3_dot + U_4_y_4*l_4_dot + U_4_y_5*l_5_dot
        + U_4_y_6*l_6_dot;
    const pkmodes_real s_dot_4_z =
        U_4_z_1*l_1_dot + U_4_z_2*l_2_dot + U_4_z_3*l_3_dot + U_4_z_4*l_4_dot + U_4_z_5*l_5_dot
        + U_4_z_6*l_6_dot;
    const pkmodes_real s_dot_5_x =
        U_5_x_1*l_1_dot + U_5_x_2*l_2_dot + U_5_x_3*l_3_dot + U_5_x_4*l_4_dot + U_5_x_5*l_5_dot
        + U_5_x_6*l_6_dot;
    const pkmodes_real s_dot_5_y =
        U_5_y_1*l_1_dot + U_5_y_2*l_2_dot + U_5_y_3*l_3_dot + U_5_y_4*l_4_dot + U_5_y_5*l_5_dot
        + U_5_y_6*l_6_dot;
    const pkmodes_real s_dot_5_z =
        U_5_z_1*l_1_dot + U_5_z_2*l_2_dot + U_5_z_3*l_3_dot + U_5_z_4*l_4_dot + U_5_z_5*l_5_dot
        + U_5_z_6*l_6_dot;
    const pkmodes_real s_dot_6_x =
        U_6_x_1*l_1_dot + U_6_x_2*l_2_dot + U_6_x_3*l_3_dot + U_6_x_4*l_4_dot + U_6_x_5*l_5_dot
        + U_6_x_6*l_6_dot;
    const pkmodes_real s_dot_6_y =
        U_6_y_1*l_1_dot + U_6_y_2*l_2_dot + U_6_y_3*l_3_dot + U_6_y_4*l_4_dot + U_6_y_5*l_5_dot
        + U_6_y_6*l_6_dot;
    const pkmodes_real s_dot_6_z =
        U_6_z_1*l_1_dot + U_6_z_2*l_2_dot + U_6_z_3*l_3_dot + U_6_z_4*l_4_dot + U_6_z_5*l_5_dot
        + U_6_z_6*l_6_dot;
    const pkmodes_real t175 = B_1_y*D_p_rx_1 - t79;
    const pkmodes_real t176 = B_1_y*D_p_rx_2 - t80;
    const pkmodes_real t177 = B_1_y*D_p_rx_3 - t81;
    const pkmodes_real t178 = B_1_y*D_p_rx_4 - t82;
    const pkmodes_real t179 = B_1_y*D_p_rx_5 - t83;
    const pkmodes_real t180 = B_1_y*D_p_rx_6 - t84;
    const pkmodes_real D_l_dot_1_rx =
        l_1_dot*(B_1_y*U_1_z_1 - B_1_z*U_1_y_1 - d_1_y*t175 + d_1_z*t73) + l_2_dot*(B_1_y*U_1_z_2
        - B_1_z*U_1_y_2 - d_1_y*t176 + d_1_z*t74) + l_3_dot*(B_1_y*U_1_z_3 - B_1_z*U_1_y_3 - d_1_y*t177
        + d_1_z*t75) + l_4_dot*(B_1_y*U_1_z_4 - B_1_z*U_1_y_4 - d_1_y*t178 + d_1_z*t76)
        + l_5_dot*(B_1_y*U_1_z_5 - B_1_z*U_1_y_5 - d_1_y*t179 + d_1_z*t77) + l_6_dot*(B_1_y*U_1_z_6
        - B_1_z*U_1_y_6 - d_1_y*t180 + d_1_z*t78);
    const pkmodes_real t181 = B_1_z*D_p_ry_1 - t67;
    const pkmodes_real t182 = B_1_z*D_p_ry_2 - t68;
    const pkmodes_real t183 = B_1_z*D_p_ry_3 - t69;
    const pkmodes_real t184 = B_1_z*D_p_ry_4 - t70;
    const pkmodes_real t185 = B_1_z*D_p_ry_5 - t71;
    const pkmodes_real t186 = B_1_z*D_p_ry_6 - t72;
    const pkmodes_real D_l_dot_1_ry =
        l_1_dot*(-B_1_x*U_1_z_1 + B_1_z*U_1_x_1 + d_1_x*t175 - d_1_z*t181) + l_2_dot*(-B_1_x*U_1_z_2
        + B_1_z*U_1_x_2 + d_1_x*t176 - d_1_z*t182) + l_3_dot*(-B_1_x*U_1_z_3 + B_1_z*U_1_x_3 + d_1_x*t177
        - d_1_z*t183) + l_4_dot*(-B_1_x*U_1_z_4 + B_1_z*U_1_x_4 + d_1_x*t178 - d_1_z*t184)
        + l_5_dot*(-B_1_x*U_1_z_5 + B_1_z*U_1_x_5 + d_1_x*t179 - d_1_z*t185) + l_6_dot*(-B_1_x*U_1_z_6
        + B_1_z*U_1_x_6 + d_1_x*t180 - d_1_z*t186);
    const pkmodes_real D_l_dot_1_rz =
        l_1_dot*(B_1_x*U_1_y_1 - B_1_y*U_1_x_1 - d_1_x*t73 + d_1_y*t181) + l_2_dot*(B_1_x*U_1_y_2
        - B_1_y*U_1_x_2 - d_1_x*t74 + d_1_y*t182) + l_3_dot*(B_1_x*U_1_y_3 - B_1_y*U_1_x_3 - d_1_x*t75
        + d_1_y*t183) + l_4_dot*(B_1_x*U_1_y_4 - B_1_y*U_1_x_4 - d_1_x*t76 + d_1_y*t184)
        + l_5_dot*(B_1_x*U_1_y_5 - B_1_y*U_1_x_5 - d_1_x*t77 + d_1_y*t185) + l_6_dot*(B_1_x*U_1_y_6
        - B_1_y*U_1_x_6 - d_1_x*t78 + d_1_y*t186);
    const pkmodes_real t187 = B_2_y*D_p_rx_1 - t97;
    const pkmodes_real t188 = B_2_y*D_p_rx_2 - t98;
    const pkmodes_real t189 = B_2_y*D_p_rx_3 - t99;
    const pkmodes_real t190 = B_2_y*D_p_rx_4 - t100;
    const pkmodes_real t191 = B_2_y*D_p_rx_5 - t101;
    const pkmodes_real t192 = B_2_y*D_p_rx_6 - t102;
    const pkmodes_real D_l_dot_2_rx =
        l_1_dot*(B_2_y*U_2_z_1 - B_2_z*U_2_y_1 - d_2_y*t187 + d_2_z*t91) + l_2_dot*(B_2_y*U_2_z_2
        - B_2_z*U_2_y_2 - d_2_y*t188 + d_2_z*t92) + l_3_dot*(B_2_y*U_2_z_3 - B_2_z*U_2_y_3 - d_2_y*t189
        + d_2_z*t93) + l_4_dot*(B_2_y*U_2_z_4 - B_2_z*U_2_y_4 - d_2_y*t190 + d_2_z*t94)
        + l_5_dot*(B_2_y*U_2_z_5 - B_2_z*U_2_y_5 - d_2_y*t191 + d_2_z*t95) + l_6_dot*(B_2_y*U_2_z_6
        - B_2_z*U_2_y_6 - d_2_y*t192 + d_2_z*t96);
    const pkmodes_real t193 = B_2_z*D_p_ry_1 - t85;
    const pkmodes_real t194 = B_2_z*D_p_ry_2 - t86;
    const pkmodes_real t195 = B_2_z*D_p_ry_3 - t87;
    const pkmodes_real t196 = B_2_z*D_p_ry_4 - t88;
    const pkmodes_real t197 = B_2_z*D_p_ry_5 - t89;
    const pkmodes_real t198 = B_2_z*D_p_ry_6 - t90;
    const pkmodes_real D_l_dot_2_ry =
        l_1_dot*(-B_2_x*U_2_z_1 + B_2_z*U_2_x_1 + d_2_x*t187 - d_2_z*t193) + l_2_dot*(-B_2_x*U_2_z_2
        + B_2_z*U_2_x_2 + d_2_x*t188 - d_2_z*t194) + l_3_dot*(-B_2_x*U_2_z_3 + B_2_z*U_2_x_3 + d_2_x*t189
        - d_2_z*t195) + l_4_dot*(-B_2_x*U_2_z_4 + B_2_z*U_2_x_4 + d_2_x*t190 - d_2_z*t196)
        + l_5_dot*(-B_2_x*U_2_z_5 + B_2_z*U_2_x_5 + d_2_x*t191 - d_2_z*t197) + l_6_dot*(-B_2_x*U_2_z_6
        + B_2_z*U_2_x_6 + d_2_x*t192 - d_2_z*t198);
    const pkmodes_real D_l_dot_2_rz =
        l_1_dot*(B_2_x*U_2_y_1 - B_2_y*U_2_x_1 - d_2_x*t91 + d_2_y*t193) + l_2_dot*(B_2_x*U_2_y_2
        - B_2_y*U_2_x_2 - d_2_x*t92 + d_2_y*t194) + l_3_dot*(B_2_x*U_2_y_3 - B_2_y*U_2_x_3 - d_2_x*t93
        + d_2_y*t195) + l_4_dot*(B_2_x*U_2_y_4 - B_2_y*U_2_x_4 - d_2_x*t94 + d_2_y*t196)
        + l_5_dot*(B_2_x*U_2_y_5 - B_2_y*U_2_x_5 - d_2_x*t95 + d_2_y*t197) + l_6_dot*(B_2_x*U_2_y_6
        - B_2_y*U_2_x_6 - d_2_x*t96 + d_2_y*t198);
    const pkmodes_real t199 = B_3_y*D_p_rx_1 - t115;
    const pkmodes_real t200 = B_3_y*D_p_rx_2 - t116;
    const pkmodes_real t201 = B_3_y*D_p_rx_3 - t117;
    const pkmodes_real t202 = B_3_y*D_p_rx_4 - t118;
    const pkmodes_real t203 = B_3_y*D_p_rx_5 - t119;
    const pkmodes_real t204 = B_3_y*D_p_rx_6 - t120;
    const pkmodes_real D_l_dot_3_rx =
        l_1_dot*(B_3_y*U_3_z_1 - B_3_z*U_3_y_1 - d_3_y*t199 + d_3_z*t109) + l_2_dot*(B_3_y*U_3_z_2
        - B_3_z*U_3_y_2 - d_3_y*t200 + d_3_z*t110) + l_3_dot*(B_3_y*U_3_z_3 - B_3_z*U_3_y_3 - d_3_y*t201
        + d_3_z*t111) + l_4_dot*(B_3_y*U_3_z_4 - B_3_z*U_3_y_4 - d_3_y*t202 + d_3_z*t112)
        + l_5_dot*(B_3_y*U_3_z_5 - B_3_z*U_3_y_5 - d_3_y*t203 + d_3_z*t113) + l_6_dot*(B_3_y*U_3_z_6
        - B_3_z*U_3_y_6 - d_3_y*t204 + d_3_z*t114);
    const pkmodes_real t205 = B_3_z*D_p_ry_1 - t103;
    const pkmodes_real t206 = B_3_z*D_p_ry_2 - t104;
    const pkmodes_real t207 = B_3_z*D_p_ry_3 - t105;
    const pkmodes_real t208 = B_3_z*D_p_ry_4 - t106;
    const pkmodes_real t209 = B_3_z*D_p_ry_5 - t107;
    const pkmodes_real t210 = B_3_z*D_p_ry_6 - t108;
    const pkmodes_real D_l_dot_3_ry =
        l_1_dot*(-B_3_x*U_3_z_1 + B_3_z*U_3_x_1 + d_3_x*t199 - d_3_z*t205) + l_2_dot*(-B_3_x*U_3_z_2
        + B_3_z*U_3_x_2 + d_3_x*t200 - d_3_z*t206) + l_3_dot*(-B_3_x*U_3_z_3 + B_3_z*U_3_x_3 + d_3_x*t201
        - d_3_z*t207) + l_4_dot*(-B_3_x*U_3_z_4 + B_3_z*U_3_x_4 + d_3_x*t202 - d_3_z*t208)
        + l_5_dot*(-B_3_x*U_3_z_5 + B_3_z*U_3_x_5 + d_3_x*t203 - d_3_z*t209) + l_6_dot*(-B_3_x*U_3_z_6
        + B_3_z*U_3_x_6 + d_3_x*t204 - d_3_z*t210);
    const pkmodes_real D_l_dot_3_rz =
        l_1_dot*(B_3_x*U_3_y_1 - B_3_y*U_3_x_1 - d_3_x*t109 + d_3_y*t205) + l_2_dot*(B_3_x*U_3_y_2
        - B_3_y*U_3_x_2 - d_3_x*t110 + d_3_y*t206) + l_3_dot*(B_3_x*U_3_y_3 - B_3_y*U_3_x_3 - d_3_x*t111
        + d_3_y*t207) + l_4_dot*(B_3_x*U_3_y_4 - B_3_y*U_3_x_4 - d_3_x*t112 + d_3_y*t208)
        + l_5_dot*(B_3_x*U_3_y_5 - B_3_y*U_3_x_5 - d_3_x*t113 + d_3_y*t209) + l_6_dot*(B_3_x*U_3_y_6
        - B_3_y*U_3_x_6 - d_3_x*t114 + d_3_y*t210);
    const pkmodes_real t211 = B_4_y*D_p_rx_1 - t133;
    const pkmodes_real t212 = B_4_y*D_p_rx_2 - t134;
    const pkmodes_real t213 = B_4_y*D_p_rx_3 - t135;
    const pkmodes_real t214 = B_4_y*D_p_rx_4 - t136;
    const pkmodes_real t215 = B_4_y*D_p_rx_5 - t137;
    const pkmodes_real t216 = B_4_y*D_p_rx_6 - t138;
    const pkmodes_real D_l_dot_4_rx =
        l_1_dot*(B_4_y*U_4_z_1 - B_4_z*U_4_y_1 - d_4_y*t211 + d_4_z*t127) + l_2_dot*(B_4_y*U_4_z_2
        - B_4_z*U_4_y_2 - d_4_y*t212 + d_4_z*t128) + l_3_dot*(B_4_y*U_4_z_3 - B_4_z*U_4_y_3 - d_4_y*t213
        + d_4_z*t129) + l_4_dot*(B_4_y*U_4_z_4 - B_4_z*U_4_y_4 - d_4_y*t214 + d_4_z*t130)
        + l_5_dot*(B_4_y*U_4_z_5 - B_4_z*U_4_y_5 - d_4_y*t215 + d_4_z*t131) + l_6_dot*(B_4_y*U_4_z_6
        - B_4_z*U_4_y_6 - d_4_y*t216 + d_4_z*t132);
    const pkmodes_real t217 = B_4_z*D_p_ry_1 - t121;
    const pkmodes_real t218 = B_4_z*D_p_ry_2 - t122;
    const pkmodes_real t219 = B_4_z*D_p_ry_3 - t123;
    const pkmodes_real t220 = B_4_z*D_p_ry_4 - t124;
    const pkmodes_real t221 = B_4_z*D_p_ry_5 - t125;
    const pkmodes_real t222 = B_4_z*D_p_ry_6 - t126;
    const pkmodes_real D_l_dot_4_ry =
        l_1_dot*(-B_4_x*U_4_z_1 + B_4_z*U_4_x_1 + d_4_x*t211 - d_4_z*t217) + l_2_dot*(-B_4_x*U_4_z_2
        + B_4_z*U_4_x_2 + d_4_x*t212 - d_4_z*t218) + l_3_dot*(-B_4_x*U_4_z_3 + B_4_z*U_4_x_3 + d_4_x*t213
        - d_4_z*t219) + l_4_dot*(-B_4_x*U_4_z_4 + B_4_z*U_4_x_4 + d_4_x*t214 - d_4_z*t220)
        + l_5_dot*(-B_4_x*U_4_z_5 + B_4_z*U_4_x_5 + d_4_x*t215 - d_4_z*t221) + l_6_dot*(-B_4_x*U_4_z_6
        + B_4_z*U_4_x_6 + d_4_x*t216 - d_4_z*t222);
    const pkmodes_real D_l_dot_4_rz =
        l_1_dot*(B_4_x*U_4_y_1 - B_4_y*U_4_x_1 - d_4_x*t127 + d_4_y*t217) + l_2_dot*(B_4_x*U_4_y_2
        - B_4_y*U_4_x_2 - d_4_x*t128 + d_4_y*t218) + l_3_dot*(B_4_x*U_4_y_3 - B_4_y*U_4_x_3 - d_4_x*t129
        + d_4_y*t219) + l_4_dot*(B_4_x*U_4_y_4 - B_4_y*U_4_x_4 - d_4_x*t130 + d_4_y*t220)
        + l_5_dot*(B_4_x*U_4_y_5 - B_4_y*U_4_x_5 - d_4_x*t131 + d_4_y*t221) + l_6_dot*(B_4_x*U_4_y_6
        - B_4_y*U_4_x_6 - d_4_x*t132 + d_4_y*t222);
    const pkmodes_real t223 = B_5_y*D_p_rx_1 - t151;
    const pkmodes_real t224 = B_5_y*D_p_rx_2 - t152;
    const pkmodes_real t225 = B_5_y*D_p_rx_3 - t153;
    const pkmodes_real t226 = B_5_y*D_p_rx_4 - t154;
    const pkmodes_real t227 = B_5_y*D_p_rx_5 - t155;
    const pkmodes_real t228 = B_5_y*D_p_rx_6 - t156;
    const pkmodes_real D_l_dot_5_rx =
        l_1_dot*(B_5_y*U_5_z_1 - B_5_z*U_5_y_1 - d_5_y*t223 + d_5_z*t145) + l_2_dot*(B_5_y*U_5_z_2
        - B_5_z*U_5_y_2 - d_5_y*t224 + d_5_z*t146) + l_3_dot*(B_5_y*U_5_z_3 - B_5_z*U_5_y_3 - d_5_y*t225
        + d_5_z*t147) + l_4_dot*(B_5_y*U_5_z_4 - B_5_z*U_5_y_4 - d_5_y*t226 + d_5_z*t148)
        + l_5_dot*(B_5_y*U_5_z_5 - B_5_z*U_5_y_5 - d_5_y*t227 + d_5_z*t149) + l_6_dot*(B_5_y*U_5_z_6
        - B_5_z*U_5_y_6 - d_5_y*t228 + d_5_z*t150);
    const pkmodes_real t229 = B_5_z*D_p_ry_1 - t139;
    const pkmodes_real t230 = B_5_z*D_p_ry_2 - t140;
    const pkmodes_real t231 = B_5_z*D_p_ry_3 - t141;
    const pkmodes_real t232 = B_5_z*D_p_ry_4 - t142;
    const pkmodes_real t233 = B_5_z*D_p_ry_5 - t143;
    const pkmodes_real t234 = B_5_z*D_p_ry_6 - t144;
    const pkmodes_real D_l_dot_5_ry =
        l_1_dot*(-B_5_x*U_5_z_1 + B_5_z*U_5_x_1 + d_5_x*t223 - d_5_z*t229) + l_2_dot*(-B_5_x*U_5_z_2
        + B_5_z*U_5_x_2 + d_5_x*t224 - d_5_z*t230) + l_3_dot*(-B_5_x*U_5_z_3 + B_5_z*U_5_x_3 + d_5_x*t225
        - d_5_z*t231) + l_4_dot*(-B_5_x*U_5_z_4 + B_5_z*U_5_x_4 + d_5_x*t226 - d_5_z*t232)
        + l_5_dot*(-B_5_x*U_5_z_5 + B_5_z*U_5_x_5 + d_5_x*t227 - d_5_z*t233) + l_6_dot*(-B_5_x*U_5_z_6
        + B_5_z*U_5_x_6 + d_5_x*t228 - d_5_z*t234);
    const pkmodes_real D_l_dot_5_rz =
        l_1_dot*(B_5_x*U_5_y_1 - B_5_y*U_5_x_1 - d_5_x*t145 + d_5_y*t229) + l_2_dot*(B_5_x*U_5_y_2
        - B_5_y*U_5_x_2 - d_5_x*t146 + d_5_y*t230) + l_3_dot*(B_5_x*U_5_y_3 - B_5_y*U_5_x_3 - d_5_x*t147
        + d_5_y*t231) + l_4_dot*(B_5_x*U_5_y_4 - B_5_y*U_5_x_4 - d_5_x*t148 + d_5_y*t232)
        + l_5_dot*(B_5_x*U_5_y_5 - B_5_y*U_5_x_5 - d_5_x*t149 + d_5_y*t233) + l_6_dot*(B_5_x*U_5_y_6
        - B_5_y*U_5_x_6 - d_5_x*t150 + d_5_y*t234);
    const pkmodes_real t235 = B_6_y*D_p_rx_1 - t169;
    const pkmodes_real t236 = B_6_y*D_p_rx_2 - t170;
    const pkmodes_real t237 = B_6_y*D_p_rx_3 - t171;
    const pkmodes_real t238 = B_6_y*D_p_rx_4 - t172;
    const pkmodes_real t239 = B_6_y*D_p_rx_5 - t173;
    const pkmodes_real t240 = B_6_y*D_p_rx_6 - t174;
    const pkmodes_real D_l_dot_6_rx =
        l_1_dot*(B_6_y*U_6_z_1 - B_6_z*U_6_y_1 - d_6_y*t235 + d_6_z*t163) + l_2_dot*(B_6_y*U_6_z_2
        - B_6_z*U_6_y_2 - d_6_y*t236 + d_6_z*t164) + l_3_dot*(B_6_y*U_6_z_3 - B_6_z*U_6_y_3 - d_6_y*t237
        + d_6_z*t165) + l_4_dot*(B_6_y*U_6_z_4 - B_6_z*U_6_y_4 - d_6_y*t238 + d_6_z*t166)
        + l_5_dot*(B_6_y*U_6_z_5 - B_6_z*U_6_y_5 - d_6_y*t239 + d_6_z*t167) + l_6_dot*(B_6_y*U_6_z_6
        - B_6_z*U_6_y_6 - d_6_y*t240 + d_6_z*t168);
    const pkmodes_real t241 = B_6_z*D_p_ry_1 - t157;
    const pkmodes_real t242 = B_6_z*D_p_ry_2 - t158;
    const pkmodes_real t243 = B_6_z*D_p_ry_3 - t159;
    const pkmodes_real t244 = B_6_z*D_p_ry_4 - t160;
    const pkmodes_real t245 = B_6_z*D_p_ry_5 - t161;
    const pkmodes_real t246 = B_6_z*D_p_ry_6 - t162;
    const pkmodes_real D_l_dot_6_ry =
        l_1_dot*(-B_6_x*U_6_z_1 + B_6_z*U_6_x_1 + d_6_x*t235 - d_6_z*t241) + l_2_dot*(-B_6_x*U_6_z_2
        + B_6_z*U_6_x_2 + d_6_x*t236 - d_6_z*t242) + l_3_dot*(-B_6_x*U_6_z_3 + B_6_z*U_6_x_3 + d_6_x*t237
        - d_6_z*t243) + l_4_dot*(-B_6_x*U_6_z_4 + B_6_z*U_6_x_4 + d_6_x*t238 - d_6_z*t244)
        + l_5_dot*(-B_6_x*U_6_z_5 + B_6_z*U_6_x_5 + d_6_x*t239 - d_6_z*t245) + l_6_dot*(-B_6_x*U_6_z_6
        + B_6_z*U_6_x_6 + d_6_x*t240 - d_6_z*t246);
    const pkmodes_real D_l_dot_6_rz =
        l_1_dot*(B_6_x*U_6_y_1 - B_6_y*U_6_x_1 - d_6_x*t163 + d_6_y*t241) + l_2_dot*(B_6_x*U_6_y_2
        - B_6_y*U_6_x_2 - d_6_x*t164 + d_6_y*t242) + l_3_dot*(B_6_x*U_6_y_3 - B_6_y*U_6_x_3 - d_6_x*t165
        + d_6_y*t243) + l_4_dot*(B_6_x*U_6_y_4 - B_6_y*U_6_x_4 - d_6_x*t166 + d_6_y*t244)
        + l_5_dot*(B_6_x*U_6_y_5 - B_6_y*U_6_x_5 - d_6_x*t167 + d_6_y*t245) + l_6_dot*(B_6_x*U_6_y_6
        - B_6_y*U_6_x_6 - d_6_x*t168 + d_6_y*t246);
    const pkmodes_real t247 =
        -D_l_dot_2_rx*D_p_rx_1 - D_l_dot_2_ry*D_p_ry_1 - D_l_dot_2_rz*D_p_rz_1 - D_p_x_1*s_dot_2_x
        - D_p_y_1*s_dot_2_y - D_p_z_1*s_dot_2_z;
    const pkmodes_real t248 =
        -D_l_dot_3_rx*D_p_rx_1 - D_l_dot_3_ry*D_p_ry_1 - D_l_dot_3_rz*D_p_rz_1 - D_p_x_1*s_dot_3_x
        - D_p_y_1*s_dot_3_y - D_p_z_1*s_dot_3_z;
    const pkmodes_real t249 =
        -D_l_dot_4_rx*D_p_rx_1 - D_l_dot_4_ry*D_p_ry_1 - D_l_dot_4_rz*D_p_rz_1 - D_p_x_1*s_dot_4_x
        - D_p_y_1*s_dot_4_y - D_p_z_1*s_dot_4_z;
    const pkmodes_real t250 =
        -D_l_dot_5_rx*D_p_rx_1 - D_l_dot_5_ry*D_p_ry_1 - D_l_dot_5_rz*D_p_rz_1 - D_p_x_1*s_dot_5_x
        - D_p_y_1*s_dot_5_y - D_p_z_1*s_dot_5_z;
    const pkmodes_real t251 =
        -D_l_dot_6_rx*D_p_rx_1 - D_l_dot_6_ry*D_p_ry_1 - D_l_dot_6_rz*D_p_rz_1 - D_p_x_1*s_dot_6_x
        - D_p_y_1*s_dot_6_y - D_p_z_1*s_dot_6_z;
    const pkmodes_real t252 =
        -D_l_dot_1_rx*D_p_rx_1 - D_l_dot_1_ry*D_p_ry_1 - D_l_dot_1_rz*D_p_rz_1 - D_p_x_1*s_dot_1_x
        - D_p_y_1*s_dot_1_y - D_p_z_1*s_dot_1_z + l_1_dot;
    const pkmodes_real D_p_dot_x_1 =
        t60*(A_x_1*t252 + A_x_2*t247 + A_x_3*t248 + A_x_4*t249 + A_x_5*t250 + A_x_6*t251);
    const pkmodes_real D_p_dot_y_1 =
        t60*(A_y_1*t252 + A_y_2*t247 + A_y_3*t248 + A_y_4*t249 + A_y_5*t250 + A_y_6*t251);
    const pkmodes_real D_p_dot_z_1 =
        t60*(A_z_1*t252 + A_z_2*t247 + A_z_3*t248 + A_z_4*t249 + A_z_5*t250 + A_z_6*t251);
    const pkmodes_real D_p_dot_rx_1 =
        t60*(A_rx_1*t252 + A_rx_2*t247 + A_rx_3*t248 + A_rx_4*t249 + A_rx_5*t250 + A_rx_6*t251);
    const pkmodes_real D_p_dot_ry_1 =
        t60*(A_ry_1*t252 + A_ry_2*t247 + A_ry_3*t248 + A_ry_4*t249 + A_ry_5*t250 + A_ry_6*t251);
    const pkmodes_real D_p_dot_rz_1 =
        t60*(A_rz_1*t252 + A_rz_2*t247 + A_rz_3*t248 + A_rz_4*t249 + A_rz_5*t250 + A_rz_6*t251);
    const pkmodes_real t253 =
        -D_l_dot_1_rx*D_p_rx_2 - D_l_dot_1_ry*D_p_ry_2 - D_l_dot_1_rz*D_p_rz_2 - D_p_x_2*s_dot_1_x
        - D_p_y_2*s_dot_1_y - D_p_z_2*s_dot_1_z;
    const pkmodes_real t254 =
        -D_l_dot_3_rx*D_p_rx_2 - D_l_dot_3_ry*D_p_ry_2 - D_l_dot_3_rz*D_p_rz_2 - D_p_x_2*s_dot_3_x
        - D_p_y_2*s_dot_3_y - D_p_z_2*s_dot_3_z;
    const pkmodes_real t255 =
        -D_l_dot_4_rx*D_p_rx_2 - D_l_dot_4_ry*D_p_ry_2 - D_l_dot_4_rz*D_p_rz_2 - D_p_x_2*s_dot_4_x
        - D_p_y_2*s_dot_4_y - D_p_z_2*s_dot_4_z;
    const pkmodes_real t256 =
        -D_l_dot_5_rx*D_p_rx_2 - D_l_dot_5_ry*D_p_ry_2 - D_l_dot_5_rz*D_p_rz_2 - D_p_x_2*s_dot_5_x
        - D_p_y_2*s_dot_5_y - D_p_z_2*s_dot_5_z;
    const pkmodes_real t257 =
        -D_l_dot_6_rx*D_p_rx_2 - D_l_dot_6_ry*D_p_ry_2 - D_l_dot_6_rz*D_p_rz_2 - D_p_x_2*s_dot_6_x
        - D_p_y_2*s_dot_6_y - D_p_z_2*s_dot_6_z;
    const pkmodes_real t258 =
        -D_l_dot_2_rx*D_p_rx_2 - D_l_dot_2_ry*D_p_ry_2 - D_l_dot_2_rz*D_p_rz_2 - D_p_x_2*s_dot_2_x
        - D_p_y_2*s_dot_2_y - D_p_z_2*s_dot_2_z + l_2_dot;
    const pkmodes_real D_p_dot_x_2 =
        t60*(A_x_1*t253 + A_x_2*t258 + A_x_3*t254 + A_x_4*t255 + A_x_5*t256 + A_x_6*t257);
    const pkmodes_real D_p_dot_y_2 =
        t60*(A_y_1*t253 + A_y_2*t258 + A_y_3*t254 + A_y_4*t255 + A_y_5*t256 + A_y_6*t257);
    const pkmodes_real D_p_dot_z_2 =
        t60*(A_z_1*t253 + A_z_2*t258 + A_z_3*t254 + A_z_4*t255 + A_z_5*t256 + A_z_6*t257);
    const pkmodes_real D_p_dot_rx_2 =
        t60*(A_rx_1*t253 + A_rx_2*t258 + A_rx_3*t254 + A_rx_4*t255 + A_rx_5*t256 + A_rx_6*t257);
    const pkmodes_real D_p_dot_ry_2 =
        t60*(A_ry_1*t253 + A_ry_2*t258 + A_ry_3*t254 + A_ry_4*t255 + A_ry_5*t256 + A_ry_6*t257);
    const pkmodes_real D_p_dot_rz_2 =
        t60*(A_rz_1*t253 + A_rz_2*t258 + A_rz_3*t254 + A_rz_4*t255 + A_rz_5*t256 + A_rz_6*t257);
    const pkmodes_real t259 =
        -D_l_dot_1_rx*D_p_rx_3 - D_l_dot_1_ry*D_p_ry_3 - D_l_dot_1_rz*D_p_rz_3 - D_p_x_3*s_dot_1_x
        - D_p_y_3*s_dot_1_y - D_p_z_3*s_dot_1_z;
    const pkmodes_real t260 =
        -D_l_dot_2_rx*D_p_rx_3 - D_l_dot_2_ry*D_p_ry_3 - D_l_dot_2_rz*D_p_rz_3 - D_p_x_3*s_dot_2_x
        - D_p_y_3*s_dot_2_y - D_p_z_3*s_dot_2_z;
    const pkmodes_real t261 =
        -D_l_dot_4_rx*D_p_rx_3 - D_l_dot_4_ry*D_p_ry_3 - D_l_dot_4_rz*D_p_rz_3 - D_p_x_3*s_dot_4_x
        - D_p_y_3*s_dot_4_y - D_p_z_3*s_dot_4_z;
    const pkmodes_real t262 =
        -D_l_dot_5_rx*D_p_rx_3 - D_l_dot_5_ry*D_p_ry_3 - D_l_dot_5_rz*D_p_rz_3 - D_p_x_3*s_dot_5_x
        - D_p_y_3*s_dot_5_y - D_p_z_3*s_dot_5_z;
    const pkmodes_real t263 =
        -D_l_dot_6_rx*D_p_rx_3 - D_l_dot_6_ry*D_p_ry_3 - D_l_dot_6_rz*D_p_rz_3 - D_p_x_3*s_dot_6_x
        - D_p_y_3*s_dot_6_y - D_p_z_3*s_dot_6_z;
    const pkmodes_real t264 =
        -D_l_dot_3_rx*D_p_rx_3 - D_l_dot_3_ry*D_p_ry_3 - D_l_dot_3_rz*D_p_rz_3 - D_p_x_3*s_dot_3_x
        - D_p_y_3*s_dot_3_y - D_p_z_3*s_dot_3_z + l_3_dot;
    const pkmodes_real D_p_dot_x_3 =
        t60*(A_x_1*t259 + A_x_2*t260 + A_x_3*t264 + A_x_4*t261 + A_x_5*t262 + A_x_6*t263);
    const pkmodes_real D_p_dot_y_3 =
        t60*(A_y_1*t259 + A_y_2*t260 + A_y_3*t264 + A_y_4*t261 + A_y_5*t262 + A_y_6*t263);
    const pkmodes_real D_p_dot_z_3 =
        t60*(A_z_1*t259 + A_z_2*t260 + A_z_3*t264 + A_z_4*t261 + A_z_5*t262 + A_z_6*t263);
    const pkmodes_real D_p_dot_rx_3 =
        t60*(A_rx_1*t259 + A_rx_2*t260 + A_rx_3*t264 + A_rx_4*t261 + A_rx_5*t262 + A_rx_6*t263);
    const pkmodes_real D_p_dot_ry_3 =
        t60*(A_ry_1*t259 + A_ry_2*t260 + A_ry_3*t264 + A_ry_4*t261 + A_ry_5*t262 + A_ry_6*t263);
    const pkmodes_real D_p_dot_rz_3 =
        t60*(A_rz_1*t259 + A_rz_2*t260 + A_rz_3*t264 + A_rz_4*t261 + A_rz_5*t262 + A_rz_6*t263);
    const pkmodes_real t265 =
        -D_l_dot_1_rx*D_p_rx_4 - D_l_dot_1_ry*D_p_ry_4 - D_l_dot_1_rz*D_p_rz_4 - D_p_x_4*s_dot_1_x
        - D_p_y_4*s_dot_1_y - D_p_z_4*s_dot_1_z;
    const pkmodes_real t266 =
        -D_l_dot_2_rx*D_p_rx_4 - D_l_dot_2_ry*D_p_ry_4 - D_l_dot_2_rz*D_p_rz_4 - D_p_x_4*s_dot_2_x
        - D_p_y_4*s_dot_2_y - D_p_z_4*s_dot_2_z;
    const pkmodes_real t267 =
        -D_l_dot_3_rx*D_p_rx_4 - D_l_dot_3_ry*D_p_ry_4 - D_l_dot_3_rz*D_p_rz_4 - D_p_x_4*s_dot_3_x
        - D_p_y_4*s_dot_3_y - D_p_z_4*s_dot_3_z;
    const pkmodes_real t268 =
        -D_l_dot_5_rx*D_p_rx_4 - D_l_dot_5_ry*D_p_ry_4 - D_l_dot_5_rz*D_p_rz_4 - D_p_x_4*s_dot_5_x
        - D_p_y_4*s_dot_5_y - D_p_z_4*s_dot_5_z;
    const pkmodes_real t269 =
        -D_l_dot_6_rx*D_p_rx_4 - D_l_dot_6_ry*D_p_ry_4 - D_l_dot_6_rz*D_p_rz_4 - D_p_x_4*s_dot_6_x
        - D_p_y_4*s_dot_6_y - D_p_z_4*s_dot_6_z;
    const pkmodes_real t270 =
        -D_l_dot_4_rx*D_p_rx_4 - D_l_dot_4_ry*D_p_ry_4 - D_l_dot_4_rz*D_p_rz_4 - D_p_x_4*s_dot_4_x
        - D_p_y_4*s_dot_4_y - D_p_z_4*s_dot_4_z + l_4_dot;
    const pkmodes_real D_p_dot_x_4 =
        t60*(A_x_1*t265 + A_x_2*t266 + A_x_3*t267 + A_x_4*t270 + A_x_5*t268 + A_x_6*t269);
    const pkmodes_real D_p_dot_y_4 =
        t60*(A_y_1*t265 + A_y_2*t266 + A_y_3*t267 + A_y_4*t270 + A_y_5*t268 + A_y_6*t269);
    const pkmodes_real D_p_dot_z_4 =
        t60*(A_z_1*t265 + A_z_2*t266 + A_z_3*t267 + A_z_4*t270 + A_z_5*t268 + A_z_6*t269);
    const pkmodes_real D_p_dot_rx_4 =
        t60*(A_rx_1*t265 + A_rx_2*t266 + A_rx_3*t267 + A_rx_4*t270 + A_rx_5*t268 + A_rx_6*t269);
    const pkmodes_real D_p_dot_ry_4 =
        t60*(A_ry_1*t265 + A_ry_2*t266 + A_ry_3*t267 + A_ry_4*t270 + A_ry_5*t268 + A_ry_6*t269);
    const pkmodes_real D_p_dot_rz_4 =
        t60*(A_rz_1*t265 + A_rz_2*t266 + A_rz_3*t267 + A_rz_4*t270 + A_rz_5*t268 + A_rz_6*t269);
    const pkmodes_real t271 =
        -D_l_dot_1_rx*D_p_rx_5 - D_l_dot_1_ry*D_p_ry_5 - D_l_dot_1_rz*D_p_rz_5 - D_p_x_5*s_dot_1_x
        - D_p_y_5*s_dot_1_y - D_p_z_5*s_dot_1_z;
    const pkmodes_real t272 =
        -D_l_dot_2_rx*D_p_rx_5 - D_l_dot_2_ry*D_p_ry_5 - D_l_dot_2_rz*D_p_rz_5 - D_p_x_5*s_dot_2_x
        - D_p_y_5*s_dot_2_y - D_p_z_5*s_dot_2_z;
    const pkmodes_real t273 =
        -D_l_dot_3_rx*D_p_rx_5 - D_l_dot_3_ry*D_p_ry_5 - D_l_dot_3_rz*D_p_rz_5 - D_p_x_5*s_dot_3_x
        - D_p_y_5*s_dot_3_y - D_p_z_5*s_dot_3_z;
    const pkmodes_real t274 =
        -D_l_dot_4_rx*D_p_rx_5 - D_l_dot_4_ry*D_p_ry_5 - D_l_dot_4_rz*D_p_rz_5 - D_p_x_5*s_dot_4_x
        - D_p_y_5*s_dot_4_y - D_p_z_5*s_dot_4_z;
    const pkmodes_real t275 =
        -D_l_dot_6_rx*D_p_rx_5 - D_l_dot_6_ry*D_p_ry_5 - D_l_dot_6_rz*D_p_rz_5 - D_p_x_5*s_dot_6_x
        - D_p_y_5*s_dot_6_y - D_p_z_5*s_dot_6_z;
    const pkmodes_real t276 =
        -D_l_dot_5_rx*D_p_rx_5 - D_l_dot_5_ry*D_p_ry_5 - D_l_dot_5_rz*D_p_rz_5 - D_p_x_5*s_dot_5_x
        - D_p_y_5*s_dot_5_y - D_p_z_5*s_dot_5_z + l_5_dot;
    const pkmodes_real D_p_dot_x_5 =
        t60*(A_x_1*t271 + A_x_2*t272 + A_x_3*t273 + A_x_4*t274 + A_x_5*t276 + A_x_6*t275);
    const pkmodes_real D_p_dot_y_5 =
        t60*(A_y_1*t271 + A_y_2*t272 + A_y_3*t273 + A_y_4*t274 + A_y_5*t276 + A_y_6*t275);
    const pkmodes_real D_p_dot_z_5 =
        t60*(A_z_1*t271 + A_z_2*t272 + A_z_3*t273 + A_z_4*t274 + A_z_5*t276 + A_z_6*t275);
    const pkmodes_real D_p_dot_rx_5 =
        t60*(A_rx_1*t271 + A_rx_2*t272 + A_rx_3*t273 + A_rx_4*t274 + A_rx_5*t276 + A_rx_6*t275);
    const pkmodes_real D_p_dot_ry_5 =
        t60*(A_ry_1*t271 + A_ry_2*t272 + A_ry_3*t273 + A_ry_4*t274 + A_ry_5*t276 + A_ry_6*t275);
    const pkmodes_real D_p_dot_rz_5 =
        t60*(A_rz_1*t271 + A_rz_2*t272 + A_rz_3*t273 + A_rz_4*t274 + A_rz_5*t276 + A_rz_6*t275);
    const pkmodes_real t277 =
        -D_l_dot_1_rx*D_p_rx_6 - D_l_dot_1_ry*D_p_ry_6 - D_l_dot_1_rz*D_p_rz_6 - D_p_x_6*s_dot_1_x
        - D_p_y_6*s_dot_1_y - D_p_z_6*s_dot_1_z;
    const pkmodes_real t278 =
        -D_l_dot_2_rx*D_p_rx_6 - D_l_dot_2_ry*D_p_ry_6 - D_l_dot_2_rz*D_p_rz_6 - D_p_x_6*s_dot_2_x
        - D_p_y_6*s_dot_2_y - D_p_z_6*s_dot_2_z;
    const pkmodes_real t279 =
        -D_l_dot_3_rx*D_p_rx_6 - D_l_dot_3_ry*D_p_ry_6 - D_l_dot_3_rz*D_p_rz_6 - D_p_x_6*s_dot_3_x
        - D_p_y_6*s_dot_3_y - D_p_z_6*s_dot_3_z;
    const pkmodes_real t280 =
        -D_l_dot_4_rx*D_p_rx_6 - D_l_dot_4_ry*D_p_ry_6 - D_l_dot_4_rz*D_p_rz_6 - D_p_x_6*s_dot_4_x
        - D_p_y_6*s_dot_4_y - D_p_z_6*s_dot_4_z;
    const pkmodes_real t281 =
        -D_l_dot_5_rx*D_p_rx_6 - D_l_dot_5_ry*D_p_ry_6 - D_l_dot_5_rz*D_p_rz_6 - D_p_x_6*s_dot_5_x
        - D_p_y_6*s_dot_5_y - D_p_z_6*s_dot_5_z;
    const pkmodes_real t282 =
        -D_l_dot_6_rx*D_p_rx_6 - D_l_dot_6_ry*D_p_ry_6 - D_l_dot_6_rz*D_p_rz_6 - D_p_x_6*s_dot_6_x
        - D_p_y_6*s_dot_6_y - D_p_z_6*s_dot_6_z + l_6_dot;
    const pkmodes_real D_p_dot_x_6 =
        t60*(A_x_1*t277 + A_x_2*t278 + A_x_3*t279 + A_x_4*t280 + A_x_5*t281 + A_x_6*t282);
    const pkmodes_real D_p_dot_y_6 =
        t60*(A_y_1*t277 + A_y_2*t278 + A_y_3*t279 + A_y_4*t280 + A_y_5*t281 + A_y_6*t282);
    const pkmodes_real D_p_dot_z_6 =
        t60*(A_z_1*t277 + A_z_2*t278 + A_z_3*t279 + A_z_4*t280 + A_z_5*t281 + A_z_6*t282);
    const pkmodes_real D_p_dot_rx_6 =
        t60*(A_rx_1*t277 + A_rx_2*t278 + A_rx_3*t279 + A_rx_4*t280 + A_rx_5*t281 + A_rx_6*t282);
    const pkmodes_real D_p_dot_ry_6 =
        t60*(A_ry_1*t277 + A_ry_2*t278 + A_ry_3*t279 + A_ry_4*t280 + A_ry_5*t281 + A_ry_6*t282);
    const pkmodes_real D_p_dot_rz_6 =
        t60*(A_rz_1*t277 + A_rz_2*t278 + A_rz_3*t279 + A_rz_4*t280 + A_rz_5*t281 + A_rz_6*t282);
    const pkmodes_real a_p_x =
        D_p_dot_x_1*l_1_dot + D_p_dot_x_2*l_2_dot + D_p_dot_x_3*l_3_dot + D_p_dot_x_4*l_4_dot
        + D_p_dot_x_5*l_5_dot + D_p_dot_x_6*l_6_dot;
    const pkmodes_real a_p_y =
        D_p_dot_y_1*l_1_dot + D_p_dot_y_2*l_2_dot + D_p_dot_y_3*l_3_dot + D_p_dot_y_4*l_4_dot
        + D_p_dot_y_5*l_5_dot + D_p_dot_y_6*l_6_dot;
    const pkmodes_real a_p_z =
        D_p_dot_z_1*l_1_dot + D_p_dot_z_2*l_2_dot + D_p_dot_z_3*l_3_dot + D_p_dot_z_4*l_4_dot
        + D_p_dot_z_5*l_5_dot + D_p_dot_z_6*l_6_dot;
    const pkmodes_real a_p_rx =
        D_p_dot_rx_1*l_1_dot + D_p_dot_rx_2*l_2_dot + D_p_dot_rx_3*l_3_dot + D_p_dot_rx_4*l_4_dot
        + D_p_dot_rx_5*l_5_dot + D_p_dot_rx_6*l_6_dot;
    const pkmodes_real a_p_ry =
        D_p_dot_ry_1*l_1_dot + D_p_dot_ry_2*l_2_dot + D_p_dot_ry_3*l_3_dot + D_p_dot_ry_4*l_4_dot
        + D_p_dot_ry_5*l_5_dot + D_p_dot_ry_6*l_6_dot;
    const pkmodes_real a_p_rz =
        D_p_dot_rz_1*l_1_dot + D_p_dot_rz_2*l_2_dot + D_p_dot_rz_3*l_3_dot + D_p_dot_rz_4*l_4_dot
        + D_p_dot_rz_5*l_5_dot + D_p_dot_rz_6*l_6_dot;
    const pkmodes_real t283 = 2*v_p_y;
    const pkmodes_real t284 = c_x*w_p_y;
    const pkmodes_real t285 = 2*c_y;
    const pkmodes_real t286 = c_x*w_p_z;
    const pkmodes_real t287 = 2*t286;
    const pkmodes_real t288 = (c_y*c_y);
    const pkmodes_real t289 = (c_z*c_z);
    const pkmodes_real t290 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real t291 = B_1_z*v_p_y;
    const pkmodes_real t292 = B_1_x*w_p_y;
    const pkmodes_real t293 = B_1_y*t292;
    const pkmodes_real t294 = B_1_x*w_p_z;
    const pkmodes_real t295 = B_1_z*t294;
    const pkmodes_real t296 = (B_1_y*B_1_y);
    const pkmodes_real t297 = (B_1_z*B_1_z);
    const pkmodes_real t298 = t296 + t297;
    const pkmodes_real t299 = (R(1.0)/R(2.0))*m_perp_1;
    const pkmodes_real t300 = B_2_z*v_p_y;
    const pkmodes_real t301 = B_2_x*w_p_y;
    const pkmodes_real t302 = B_2_y*t301;
    const pkmodes_real t303 = B_2_x*w_p_z;
    const pkmodes_real t304 = B_2_z*t303;
    const pkmodes_real t305 = (B_2_y*B_2_y);
    const pkmodes_real t306 = (B_2_z*B_2_z);
    const pkmodes_real t307 = t305 + t306;
    const pkmodes_real t308 = (R(1.0)/R(2.0))*m_perp_2;
    const pkmodes_real t309 = B_3_z*v_p_y;
    const pkmodes_real t310 = B_3_x*w_p_y;
    const pkmodes_real t311 = B_3_y*t310;
    const pkmodes_real t312 = B_3_x*w_p_z;
    const pkmodes_real t313 = B_3_z*t312;
    const pkmodes_real t314 = (B_3_y*B_3_y);
    const pkmodes_real t315 = (B_3_z*B_3_z);
    const pkmodes_real t316 = t314 + t315;
    const pkmodes_real t317 = (R(1.0)/R(2.0))*m_perp_3;
    const pkmodes_real t318 = B_4_z*v_p_y;
    const pkmodes_real t319 = B_4_x*w_p_y;
    const pkmodes_real t320 = B_4_y*t319;
    const pkmodes_real t321 = B_4_x*w_p_z;
    const pkmodes_real t322 = B_4_z*t321;
    const pkmodes_real t323 = (B_4_y*B_4_y);
    const pkmodes_real t324 = (B_4_z*B_4_z);
    const pkmodes_real t325 = t323 + t324;
    const pkmodes_real t326 = (R(1.0)/R(2.0))*m_perp_4;
    const pkmodes_real t327 = B_5_z*v_p_y;
    const pkmodes_real t328 = B_5_x*w_p_y;
    const pkmodes_real t329 = B_5_y*t328;
    const pkmodes_real t330 = B_5_x*w_p_z;
    const pkmodes_real t331 = B_5_z*t330;
    const pkmodes_real t332 = (B_5_y*B_5_y);
    const pkmodes_real t333 = (B_5_z*B_5_z);
    const pkmodes_real t334 = t332 + t333;
    const pkmodes_real t335 = (R(1.0)/R(2.0))*m_perp_5;
    const pkmodes_real t336 = B_6_z*v_p_y;
    const pkmodes_real t337 = B_6_x*w_p_y;
    const pkmodes_real t338 = B_6_y*t337;
    const pkmodes_real t339 = B_6_x*w_p_z;
    const pkmodes_real t340 = B_6_z*t339;
    const pkmodes_real t341 = (B_6_y*B_6_y);
    const pkmodes_real t342 = (B_6_z*B_6_z);
    const pkmodes_real t343 = t341 + t342;
    const pkmodes_real t344 = (R(1.0)/R(2.0))*m_perp_6;
    const pkmodes_real pi_rx =
        J_x_x*w_p_x + J_x_y*w_p_y + J_x_z*w_p_z + t290*(2*c_y*v_p_z - c_z*t283 - c_z*t287 - t284*t285
        + 2*w_p_x*(t288 + t289)) + t299*(2*B_1_y*v_p_z - 2*t291 - 2*t293 - 2*t295 + 2*t298*w_p_x)
        + t308*(2*B_2_y*v_p_z - 2*t300 - 2*t302 - 2*t304 + 2*t307*w_p_x) + t317*(2*B_3_y*v_p_z - 2*t309
        - 2*t311 - 2*t313 + 2*t316*w_p_x) + t326*(2*B_4_y*v_p_z - 2*t318 - 2*t320 - 2*t322 + 2*t325*w_p_x)
        + t335*(2*B_5_y*v_p_z - 2*t327 - 2*t329 - 2*t331 + 2*t334*w_p_x) + t344*(2*B_6_y*v_p_z - 2*t336
        - 2*t338 - 2*t340 + 2*t343*w_p_x);
    const pkmodes_real t345 = 2*v_p_z;
    const pkmodes_real t346 = c_y*w_p_x;
    const pkmodes_real t347 = 2*t346;
    const pkmodes_real t348 = c_y*w_p_z;
    const pkmodes_real t349 = (c_x*c_x);
    const pkmodes_real t350 = B_1_y*w_p_x;
    const pkmodes_real t351 = B_1_x*t350;
    const pkmodes_real t352 = B_1_y*w_p_z;
    const pkmodes_real t353 = (B_1_x*B_1_x);
    const pkmodes_real t354 = t297 + t353;
    const pkmodes_real t355 = B_2_y*w_p_x;
    const pkmodes_real t356 = B_2_x*t355;
    const pkmodes_real t357 = B_2_y*w_p_z;
    const pkmodes_real t358 = (B_2_x*B_2_x);
    const pkmodes_real t359 = t306 + t358;
    const pkmodes_real t360 = B_3_y*w_p_x;
    const pkmodes_real t361 = B_3_x*t360;
    const pkmodes_real t362 = B_3_y*w_p_z;
    const pkmodes_real t363 = (B_3_x*B_3_x);
    const pkmodes_real t364 = t315 + t363;
    const pkmodes_real t365 = B_4_y*w_p_x;
    const pkmodes_real t366 = B_4_x*t365;
    const pkmodes_real t367 = B_4_y*w_p_z;
    const pkmodes_real t368 = (B_4_x*B_4_x);
    const pkmodes_real t369 = t324 + t368;
    const pkmodes_real t370 = B_5_y*w_p_x;
    const pkmodes_real t371 = B_5_x*t370;
    const pkmodes_real t372 = B_5_y*w_p_z;
    const pkmodes_real t373 = (B_5_x*B_5_x);
    const pkmodes_real t374 = t333 + t373;
    const pkmodes_real t375 = B_6_y*w_p_x;
    const pkmodes_real t376 = B_6_x*t375;
    const pkmodes_real t377 = B_6_y*w_p_z;
    const pkmodes_real t378 = (B_6_x*B_6_x);
    const pkmodes_real t379 = t342 + t378;
    const pkmodes_real pi_ry =
        J_x_y*w_p_x + J_y_y*w_p_y + J_y_z*w_p_z + t290*(-c_x*t345 - c_x*t347 - 2*c_z*t348 + 2*c_z*v_p_x
        + 2*w_p_y*(t289 + t349)) + t299*(-B_1_x*t345 - 2*B_1_z*t352 + 2*B_1_z*v_p_x - 2*t351 + 2*t354*w_p_y)
        + t308*(-B_2_x*t345 - 2*B_2_z*t357 + 2*B_2_z*v_p_x - 2*t356 + 2*t359*w_p_y) + t317*(-B_3_x*t345
        - 2*B_3_z*t362 + 2*B_3_z*v_p_x - 2*t361 + 2*t364*w_p_y) + t326*(-B_4_x*t345 - 2*B_4_z*t367
        + 2*B_4_z*v_p_x - 2*t366 + 2*t369*w_p_y) + t335*(-B_5_x*t345 - 2*B_5_z*t372 + 2*B_5_z*v_p_x - 2*t371
        + 2*t374*w_p_y) + t344*(-B_6_x*t345 - 2*B_6_z*t377 + 2*B_6_z*v_p_x - 2*t376 + 2*t379*w_p_y);
    const pkmodes_real t380 = 2*v_p_x;
    const pkmodes_real t381 = c_z*w_p_x;
    const pkmodes_real t382 = 2*c_x;
    const pkmodes_real t383 = c_z*w_p_y;
    const pkmodes_real t384 = B_1_z*w_p_x;
    const pkmodes_real t385 = 2*B_1_x;
    const pkmodes_real t386 = B_1_z*w_p_y;
    const pkmodes_real t387 = t296 + t353;
    const pkmodes_real t388 = B_2_z*w_p_x;
    const pkmodes_real t389 = 2*B_2_x;
    const pkmodes_real t390 = B_2_z*w_p_y;
    const pkmodes_real t391 = t305 + t358;
    const pkmodes_real t392 = B_3_z*w_p_x;
    const pkmodes_real t393 = 2*B_3_x;
    const pkmodes_real t394 = B_3_z*w_p_y;
    const pkmodes_real t395 = t314 + t363;
    const pkmodes_real t396 = B_4_z*w_p_x;
    const pkmodes_real t397 = 2*B_4_x;
    const pkmodes_real t398 = B_4_z*w_p_y;
    const pkmodes_real t399 = t323 + t368;
    const pkmodes_real t400 = B_5_z*w_p_x;
    const pkmodes_real t401 = 2*B_5_x;
    const pkmodes_real t402 = B_5_z*w_p_y;
    const pkmodes_real t403 = t332 + t373;
    const pkmodes_real t404 = B_6_z*w_p_x;
    const pkmodes_real t405 = 2*B_6_x;
    const pkmodes_real t406 = B_6_z*w_p_y;
    const pkmodes_real t407 = t341 + t378;
    const pkmodes_real pi_rz =
        J_x_z*w_p_x + J_y_z*w_p_y + J_z_z*w_p_z + t290*(2*c_x*v_p_y - c_y*t380 - t285*t383 - t381*t382
        + 2*w_p_z*(t288 + t349)) + t299*(2*B_1_x*v_p_y - B_1_y*t380 - 2*B_1_y*t386 - t384*t385
        + 2*t387*w_p_z) + t308*(2*B_2_x*v_p_y - B_2_y*t380 - 2*B_2_y*t390 - t388*t389 + 2*t391*w_p_z)
        + t317*(2*B_3_x*v_p_y - B_3_y*t380 - 2*B_3_y*t394 - t392*t393 + 2*t395*w_p_z) + t326*(2*B_4_x*v_p_y
        - B_4_y*t380 - 2*B_4_y*t398 - t396*t397 + 2*t399*w_p_z) + t335*(2*B_5_x*v_p_y - B_5_y*t380
        - 2*B_5_y*t402 - t400*t401 + 2*t403*w_p_z) + t344*(2*B_6_x*v_p_y - B_6_y*t380 - 2*B_6_y*t406
        - t404*t405 + 2*t407*w_p_z);
    const pkmodes_real t408 = m_p + m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6;
    const pkmodes_real t409 = c_y*w_p_x - t284;
    const pkmodes_real t410 = m_p*t409;
    const pkmodes_real t411 = B_1_y*w_p_x - t292;
    const pkmodes_real t412 = m_perp_1*t411;
    const pkmodes_real t413 = B_2_y*w_p_x - t301;
    const pkmodes_real t414 = m_perp_2*t413;
    const pkmodes_real t415 = B_3_y*w_p_x - t310;
    const pkmodes_real t416 = m_perp_3*t415;
    const pkmodes_real t417 = B_4_y*w_p_x - t319;
    const pkmodes_real t418 = m_perp_4*t417;
    const pkmodes_real t419 = B_5_y*w_p_x - t328;
    const pkmodes_real t420 = m_perp_5*t419;
    const pkmodes_real t421 = B_6_y*w_p_x - t337;
    const pkmodes_real t422 = m_perp_6*t421;
    const pkmodes_real t423 = t286 - t381;
    const pkmodes_real t424 = m_p*w_p_z;
    const pkmodes_real t425 = t294 - t384;
    const pkmodes_real t426 = m_perp_1*w_p_z;
    const pkmodes_real t427 = t303 - t388;
    const pkmodes_real t428 = m_perp_2*w_p_z;
    const pkmodes_real t429 = t312 - t392;
    const pkmodes_real t430 = m_perp_3*w_p_z;
    const pkmodes_real t431 = t321 - t396;
    const pkmodes_real t432 = m_perp_4*w_p_z;
    const pkmodes_real t433 = t330 - t400;
    const pkmodes_real t434 = m_perp_5*w_p_z;
    const pkmodes_real t435 = t339 - t404;
    const pkmodes_real t436 = m_perp_6*w_p_z;
    const pkmodes_real t437 = B_1_z*m_perp_1;
    const pkmodes_real t438 = B_2_z*m_perp_2;
    const pkmodes_real t439 = B_3_z*m_perp_3;
    const pkmodes_real t440 = B_4_z*m_perp_4;
    const pkmodes_real t441 = B_5_z*m_perp_5;
    const pkmodes_real t442 = B_6_z*m_perp_6;
    const pkmodes_real t443 = c_z*m_p;
    const pkmodes_real t444 = t437 + t438 + t439 + t440 + t441 + t442 + t443;
    const pkmodes_real t445 = B_1_y*m_perp_1;
    const pkmodes_real t446 = B_2_y*m_perp_2;
    const pkmodes_real t447 = B_3_y*m_perp_3;
    const pkmodes_real t448 = B_4_y*m_perp_4;
    const pkmodes_real t449 = B_5_y*m_perp_5;
    const pkmodes_real t450 = B_6_y*m_perp_6;
    const pkmodes_real t451 = c_y*m_p;
    const pkmodes_real t452 = t445 + t446 + t447 + t448 + t449 + t450 + t451;
    const pkmodes_real t453 = 2/(l_1*l_1*l_1);
    const pkmodes_real t454 = -I_b_1*t453 - I_r_1*t453 + 2*c_r_1*m_r_1*t42*t44 - t43*t453;
    const pkmodes_real t455 = l_1_dot*t454;
    const pkmodes_real t456 = 2/(l_2*l_2*l_2);
    const pkmodes_real t457 = -I_b_2*t456 - I_r_2*t456 + 2*c_r_2*m_r_2*t45*t47 - t456*t46;
    const pkmodes_real t458 = l_2_dot*t457;
    const pkmodes_real t459 = 2/(l_3*l_3*l_3);
    const pkmodes_real t460 = -I_b_3*t459 - I_r_3*t459 + 2*c_r_3*m_r_3*t48*t50 - t459*t49;
    const pkmodes_real t461 = l_3_dot*t460;
    const pkmodes_real t462 = 2/(l_4*l_4*l_4);
    const pkmodes_real t463 = -I_b_4*t462 - I_r_4*t462 + 2*c_r_4*m_r_4*t51*t53 - t462*t52;
    const pkmodes_real t464 = l_4_dot*t463;
    const pkmodes_real t465 = 2/(l_5*l_5*l_5);
    const pkmodes_real t466 = -I_b_5*t465 - I_r_5*t465 + 2*c_r_5*m_r_5*t54*t56 - t465*t55;
    const pkmodes_real t467 = l_5_dot*t466;
    const pkmodes_real t468 = 2/(l_6*l_6*l_6);
    const pkmodes_real t469 = -I_b_6*t468 - I_r_6*t468 + 2*c_r_6*m_r_6*t57*t59 - t468*t58;
    const pkmodes_real t470 = l_6_dot*t469;
    const pkmodes_real z_x =
        a_p_ry*t444 - a_p_rz*t452 + a_p_x*t408 + t410*w_p_y + t412*w_p_y + t414*w_p_y + t416*w_p_y
        + t418*w_p_y + t420*w_p_y + t422*w_p_y - t423*t424 - t425*t426 - t427*t428 - t429*t430 - t431*t432
        - t433*t434 - t435*t436 + t455*(-t352 + t386 + v_p_x) + t458*(-t357 + t390 + v_p_x) + t461*(-t362
        + t394 + v_p_x) + t464*(-t367 + t398 + v_p_x) + t467*(-t372 + t402 + v_p_x) + t470*(-t377 + t406
        + v_p_x);
    const pkmodes_real t471 = c_z*w_p_y - t348;
    const pkmodes_real t472 = B_1_z*w_p_y - t352;
    const pkmodes_real t473 = B_2_z*w_p_y - t357;
    const pkmodes_real t474 = B_3_z*w_p_y - t362;
    const pkmodes_real t475 = B_4_z*w_p_y - t367;
    const pkmodes_real t476 = B_5_z*w_p_y - t372;
    const pkmodes_real t477 = B_6_z*w_p_y - t377;
    const pkmodes_real t478 = B_1_x*m_perp_1;
    const pkmodes_real t479 = B_2_x*m_perp_2;
    const pkmodes_real t480 = B_3_x*m_perp_3;
    const pkmodes_real t481 = B_4_x*m_perp_4;
    const pkmodes_real t482 = B_5_x*m_perp_5;
    const pkmodes_real t483 = B_6_x*m_perp_6;
    const pkmodes_real t484 = c_x*m_p;
    const pkmodes_real t485 = t478 + t479 + t480 + t481 + t482 + t483 + t484;
    const pkmodes_real z_y =
        -a_p_rx*t444 + a_p_rz*t485 + a_p_y*t408 - t410*w_p_x - t412*w_p_x - t414*w_p_x - t416*w_p_x
        - t418*w_p_x - t420*w_p_x - t422*w_p_x + t424*t471 + t426*t472 + t428*t473 + t430*t474 + t432*t475
        + t434*t476 + t436*t477 + t455*(t425 + v_p_y) + t458*(t427 + v_p_y) + t461*(t429 + v_p_y)
        + t464*(t431 + v_p_y) + t467*(t433 + v_p_y) + t470*(t435 + v_p_y);
    const pkmodes_real z_z =
        a_p_rx*t452 - a_p_ry*t485 + a_p_z*t408 + m_p*t423*w_p_x - m_p*t471*w_p_y + m_perp_1*t425*w_p_x
        - m_perp_1*t472*w_p_y + m_perp_2*t427*w_p_x - m_perp_2*t473*w_p_y + m_perp_3*t429*w_p_x
        - m_perp_3*t474*w_p_y + m_perp_4*t431*w_p_x - m_perp_4*t475*w_p_y + m_perp_5*t433*w_p_x
        - m_perp_5*t476*w_p_y + m_perp_6*t435*w_p_x - m_perp_6*t477*w_p_y + t455*(-t292 + t350 + v_p_z)
        + t458*(-t301 + t355 + v_p_z) + t461*(-t310 + t360 + v_p_z) + t464*(-t319 + t365 + v_p_z)
        + t467*(-t328 + t370 + v_p_z) + t470*(-t337 + t375 + v_p_z);
    const pkmodes_real t486 = 2*w_p_y;
    const pkmodes_real t487 = c_y*t486;
    const pkmodes_real t488 = 2*w_p_z;
    const pkmodes_real t489 = c_z*t488;
    const pkmodes_real t490 = t290*t471;
    const pkmodes_real t491 = B_1_y*t486;
    const pkmodes_real t492 = B_1_z*t488;
    const pkmodes_real t493 = t299*t472;
    const pkmodes_real t494 = B_2_y*t486;
    const pkmodes_real t495 = B_2_z*t488;
    const pkmodes_real t496 = t308*t473;
    const pkmodes_real t497 = B_3_y*t486;
    const pkmodes_real t498 = B_3_z*t488;
    const pkmodes_real t499 = t317*t474;
    const pkmodes_real t500 = B_4_y*t486;
    const pkmodes_real t501 = B_4_z*t488;
    const pkmodes_real t502 = t326*t475;
    const pkmodes_real t503 = B_5_y*t486;
    const pkmodes_real t504 = B_5_z*t488;
    const pkmodes_real t505 = t335*t476;
    const pkmodes_real t506 = B_6_y*t486;
    const pkmodes_real t507 = B_6_z*t488;
    const pkmodes_real t508 = t344*t477;
    const pkmodes_real t509 = t290*t409;
    const pkmodes_real t510 = t290*t423;
    const pkmodes_real t511 = t299*t411;
    const pkmodes_real t512 = t299*t425;
    const pkmodes_real t513 = t308*t413;
    const pkmodes_real t514 = t308*t427;
    const pkmodes_real t515 = t317*t415;
    const pkmodes_real t516 = t317*t429;
    const pkmodes_real t517 = t326*t417;
    const pkmodes_real t518 = t326*t431;
    const pkmodes_real t519 = t335*t419;
    const pkmodes_real t520 = t335*t433;
    const pkmodes_real t521 = t344*t421;
    const pkmodes_real t522 = t344*t435;
    const pkmodes_real t523 = (w_p_x*w_p_x);
    const pkmodes_real t524 = (w_p_y*w_p_y);
    const pkmodes_real t525 = 2*w_p_x;
    const pkmodes_real t526 = t283*w_p_x - 2*v_p_x*w_p_y;
    const pkmodes_real t527 =
        B_1_z*t523 + B_1_z*t524 - R(1.0)/R(2.0)*t294*t525 - R(1.0)/R(2.0)*t352*t486 - R(1.0)/R(2.0)*t526;
    const pkmodes_real t528 = (w_p_z*w_p_z);
    const pkmodes_real t529 = t380*w_p_z - 2*v_p_z*w_p_x;
    const pkmodes_real t530 = 2*B_1_y*t523 + 2*B_1_y*t528 - t292*t525 - t386*t488 - t529;
    const pkmodes_real t531 = (R(1.0)/R(2.0))*t437;
    const pkmodes_real t532 =
        B_2_z*t523 + B_2_z*t524 - R(1.0)/R(2.0)*t303*t525 - R(1.0)/R(2.0)*t357*t486 - R(1.0)/R(2.0)*t526;
    const pkmodes_real t533 = 2*B_2_y*t523 + 2*B_2_y*t528 - t301*t525 - t390*t488 - t529;
    const pkmodes_real t534 = (R(1.0)/R(2.0))*t438;
    const pkmodes_real t535 =
        B_3_z*t523 + B_3_z*t524 - R(1.0)/R(2.0)*t312*t525 - R(1.0)/R(2.0)*t362*t486 - R(1.0)/R(2.0)*t526;
    const pkmodes_real t536 = 2*B_3_y*t523 + 2*B_3_y*t528 - t310*t525 - t394*t488 - t529;
    const pkmodes_real t537 = (R(1.0)/R(2.0))*t439;
    const pkmodes_real t538 =
        B_4_z*t523 + B_4_z*t524 - R(1.0)/R(2.0)*t321*t525 - R(1.0)/R(2.0)*t367*t486 - R(1.0)/R(2.0)*t526;
    const pkmodes_real t539 = 2*B_4_y*t523 + 2*B_4_y*t528 - t319*t525 - t398*t488 - t529;
    const pkmodes_real t540 = (R(1.0)/R(2.0))*t440;
    const pkmodes_real t541 =
        B_5_z*t523 + B_5_z*t524 - R(1.0)/R(2.0)*t330*t525 - R(1.0)/R(2.0)*t372*t486 - R(1.0)/R(2.0)*t526;
    const pkmodes_real t542 = 2*B_5_y*t523 + 2*B_5_y*t528 - t328*t525 - t402*t488 - t529;
    const pkmodes_real t543 = (R(1.0)/R(2.0))*t441;
    const pkmodes_real t544 =
        B_6_z*t523 + B_6_z*t524 - R(1.0)/R(2.0)*t339*t525 - R(1.0)/R(2.0)*t377*t486 - R(1.0)/R(2.0)*t526;
    const pkmodes_real t545 = 2*B_6_y*t523 + 2*B_6_y*t528 - t337*t525 - t406*t488 - t529;
    const pkmodes_real t546 = (R(1.0)/R(2.0))*t442;
    const pkmodes_real t547 =
        c_z*t523 + c_z*t524 - R(1.0)/R(2.0)*t286*t525 - R(1.0)/R(2.0)*t348*t486 - R(1.0)/R(2.0)*t526;
    const pkmodes_real t548 = 2*c_y*t523 + 2*c_y*t528 - t284*t525 - t383*t488 - t529;
    const pkmodes_real t549 = (R(1.0)/R(2.0))*t443;
    const pkmodes_real t550 =
        -B_1_x*t445 - B_2_x*t446 - B_3_x*t447 - B_4_x*t448 - B_5_x*t449 - B_6_x*t450 + J_x_y - c_x*t451;
    const pkmodes_real t551 =
        -B_1_x*t437 - B_2_x*t438 - B_3_x*t439 - B_4_x*t440 - B_5_x*t441 - B_6_x*t442 + J_x_z - c_x*t443;
    const pkmodes_real t552 = t12 + t14 + t18;
    const pkmodes_real t553 = w_p_x*w_p_y;
    const pkmodes_real t554 = t24 + t25 + t33;
    const pkmodes_real t555 = w_p_y*w_p_z;
    const pkmodes_real t556 = I_p_x*R_y_x;
    const pkmodes_real t557 = t28 + t30 + 2*t556;
    const pkmodes_real t558 = (R(1.0)/R(2.0))*t524;
    const pkmodes_real t559 = t552*t553 + t554*t555 + t557*t558;
    const pkmodes_real t560 = t16 + t19 + t21;
    const pkmodes_real t561 = t26 + t34 + t36;
    const pkmodes_real t562 = I_p_xy*R_y_x;
    const pkmodes_real t563 = I_p_y*R_y_y;
    const pkmodes_real t564 = t32 + 2*t562 + 2*t563;
    const pkmodes_real t565 = t553*t560 + t555*t561 + t558*t564;
    const pkmodes_real t566 = t20 + t22 + t23;
    const pkmodes_real t567 = t35 + t37 + t38;
    const pkmodes_real t568 = I_p_xz*R_y_x;
    const pkmodes_real t569 = I_p_yz*R_y_y;
    const pkmodes_real t570 = I_p_z*R_y_z;
    const pkmodes_real t571 = 2*t568 + 2*t569 + 2*t570;
    const pkmodes_real t572 = t553*t566 + t555*t567 + t558*t571;
    const pkmodes_real t573 = w_p_x*w_p_z;
    const pkmodes_real t574 = t27 + t29 + t556;
    const pkmodes_real t575 = 2*t33 + t39 + t40;
    const pkmodes_real t576 = (R(1.0)/R(2.0))*t528;
    const pkmodes_real t577 = t552*t573 + t555*t574 + t575*t576;
    const pkmodes_real t578 = t31 + t562 + t563;
    const pkmodes_real t579 = 2*t34 + 2*t36 + t41;
    const pkmodes_real t580 = t555*t578 + t560*t573 + t576*t579;
    const pkmodes_real t581 = t568 + t569 + t570;
    const pkmodes_real t582 = 2*t35 + 2*t37 + 2*t38;
    const pkmodes_real t583 = t555*t581 + t566*t573 + t576*t582;
    const pkmodes_real t584 = -R_y_x*w_p_z + R_z_x*w_p_y;
    const pkmodes_real t585 = t13 + t15 + 2*t18;
    const pkmodes_real t586 = -R_y_y*w_p_z + R_z_y*w_p_y;
    const pkmodes_real t587 = t17 + 2*t19 + 2*t21;
    const pkmodes_real t588 = -R_y_z*w_p_z + R_z_z*w_p_y;
    const pkmodes_real t589 = 2*t20 + 2*t22 + 2*t23;
    const pkmodes_real t590 = 2*t288;
    const pkmodes_real t591 = 2*t289;
    const pkmodes_real t592 = 2*t296;
    const pkmodes_real t593 = 2*t297;
    const pkmodes_real t594 = 2*t305;
    const pkmodes_real t595 = 2*t306;
    const pkmodes_real t596 = 2*t314;
    const pkmodes_real t597 = 2*t315;
    const pkmodes_real t598 = 2*t323;
    const pkmodes_real t599 = 2*t324;
    const pkmodes_real t600 = 2*t332;
    const pkmodes_real t601 = 2*t333;
    const pkmodes_real t602 = 2*t341;
    const pkmodes_real t603 = 2*t342;
    const pkmodes_real t604 = R_x_x*w_p_z - R_z_x*w_p_x;
    const pkmodes_real t605 = R_x_y*w_p_z - R_z_y*w_p_x;
    const pkmodes_real t606 = R_x_z*w_p_z - R_z_z*w_p_x;
    const pkmodes_real t607 = t552*t604 + t560*t605 + t566*t606 + t574*t584 + t578*t586 + t581*t588;
    const pkmodes_real t608 = -R_x_x*w_p_y + R_y_x*w_p_x;
    const pkmodes_real t609 = -R_x_y*w_p_y + R_y_y*w_p_x;
    const pkmodes_real t610 = -R_x_z*w_p_y + R_y_z*w_p_x;
    const pkmodes_real t611 = t552*t608 + t554*t584 + t560*t609 + t561*t586 + t566*t610 + t567*t588;
    const pkmodes_real z_rx =
        -R_y_x*t577 - R_y_y*t580 - R_y_z*t583 + R_z_x*t559 + R_z_y*t565 + R_z_z*t572 + a_p_rx*(J_x_x
        + t290*(t590 + t591) + t299*(t592 + t593) + t308*(t594 + t595) + t317*(t596 + t597) + t326*(t598
        + t599) + t335*(t600 + t601) + t344*(t602 + t603)) + a_p_ry*t550 + a_p_rz*t551 - a_p_y*t444
        + a_p_z*t452 + pi_ry*w_p_z - pi_rz*w_p_y - t445*t527 - t446*t532 - t447*t535 - t448*t538 - t449*t541
        - t450*t544 - t451*t547 + t455*(B_1_y*v_p_z - t291 - t293 - t295 + t298*w_p_x) + t458*(B_2_y*v_p_z
        - t300 - t302 - t304 + t307*w_p_x) + t461*(B_3_y*v_p_z - t309 - t311 - t313 + t316*w_p_x)
        + t464*(B_4_y*v_p_z - t318 - t320 - t322 + t325*w_p_x) + t467*(B_5_y*v_p_z - t327 - t329 - t331
        + t334*w_p_x) + t470*(B_6_y*v_p_z - t336 - t338 - t340 + t343*w_p_x) + t490*(-t487 - t489)
        + t493*(-t491 - t492) + t496*(-t494 - t495) + t499*(-t497 - t498) + t502*(-t500 - t501) + t505*(-t503
        - t504) + t508*(-t506 - t507) + t509*(4*c_z*w_p_x - t283 - t287) + t510*(-2*t284 + t345 + 4*t346)
        + t511*(4*B_1_z*w_p_x - t283 - 2*t294) + t512*(-2*t292 + t345 + 4*t350) + t513*(4*B_2_z*w_p_x - t283
        - 2*t303) + t514*(-2*t301 + t345 + 4*t355) + t515*(4*B_3_z*w_p_x - t283 - 2*t312) + t516*(-2*t310
        + t345 + 4*t360) + t517*(4*B_4_z*w_p_x - t283 - 2*t321) + t518*(-2*t319 + t345 + 4*t365)
        + t519*(4*B_5_z*w_p_x - t283 - 2*t330) + t520*(-2*t328 + t345 + 4*t370) + t521*(4*B_6_z*w_p_x - t283
        - 2*t339) + t522*(-2*t337 + t345 + 4*t375) + t530*t531 + t533*t534 + t536*t537 + t539*t540
        + t542*t543 + t545*t546 + t548*t549 + t607*w_p_y + t611*w_p_z + w_p_x*(t584*t585 + t586*t587
        + t588*t589);
    const pkmodes_real t612 = c_x*t525;
    const pkmodes_real t613 = B_1_x*t525;
    const pkmodes_real t614 = B_2_x*t525;
    const pkmodes_real t615 = B_3_x*t525;
    const pkmodes_real t616 = B_4_x*t525;
    const pkmodes_real t617 = B_5_x*t525;
    const pkmodes_real t618 = B_6_x*t525;
    const pkmodes_real t619 = t283*w_p_z - t345*w_p_y;
    const pkmodes_real t620 = -t350*t486 - t384*t488 + t385*t524 + t385*t528 + t619;
    const pkmodes_real t621 = -t355*t486 - t388*t488 + t389*t524 + t389*t528 + t619;
    const pkmodes_real t622 = -t360*t486 - t392*t488 + t393*t524 + t393*t528 + t619;
    const pkmodes_real t623 = -t365*t486 - t396*t488 + t397*t524 + t397*t528 + t619;
    const pkmodes_real t624 = -t370*t486 - t400*t488 + t401*t524 + t401*t528 + t619;
    const pkmodes_real t625 = -t375*t486 - t404*t488 + t405*t524 + t405*t528 + t619;
    const pkmodes_real t626 = -t346*t486 - t381*t488 + t382*t524 + t382*t528 + t619;
    const pkmodes_real t627 =
        -B_1_y*t437 - B_2_y*t438 - B_3_y*t439 - B_4_y*t440 - B_5_y*t441 - B_6_y*t442 + J_y_z - c_y*t443;
    const pkmodes_real t628 = (R(1.0)/R(2.0))*t523;
    const pkmodes_real t629 = t553*t574 + t554*t573 + t585*t628;
    const pkmodes_real t630 = t553*t578 + t561*t573 + t587*t628;
    const pkmodes_real t631 = t553*t581 + t567*t573 + t589*t628;
    const pkmodes_real t632 = 2*t349;
    const pkmodes_real t633 = 2*t353;
    const pkmodes_real t634 = 2*t358;
    const pkmodes_real t635 = 2*t363;
    const pkmodes_real t636 = 2*t368;
    const pkmodes_real t637 = 2*t373;
    const pkmodes_real t638 = 2*t378;
    const pkmodes_real t639 = t554*t604 + t561*t605 + t567*t606 + t574*t608 + t578*t609 + t581*t610;
    const pkmodes_real z_ry =
        R_x_x*t577 + R_x_y*t580 + R_x_z*t583 - R_z_x*t629 - R_z_y*t630 - R_z_z*t631 + a_p_rx*t550
        + a_p_ry*(J_y_y + t290*(t591 + t632) + t299*(t593 + t633) + t308*(t595 + t634) + t317*(t597 + t635)
        + t326*(t599 + t636) + t335*(t601 + t637) + t344*(t603 + t638)) + a_p_rz*t627 + a_p_x*t444
        - a_p_z*t485 - pi_rx*w_p_z + pi_rz*w_p_x + t455*(-B_1_x*v_p_z - B_1_z*t352 + B_1_z*v_p_x - t351
        + t354*w_p_y) + t458*(-B_2_x*v_p_z - B_2_z*t357 + B_2_z*v_p_x - t356 + t359*w_p_y)
        + t461*(-B_3_x*v_p_z - B_3_z*t362 + B_3_z*v_p_x - t361 + t364*w_p_y) + t464*(-B_4_x*v_p_z
        - B_4_z*t367 + B_4_z*v_p_x - t366 + t369*w_p_y) + t467*(-B_5_x*v_p_z - B_5_z*t372 + B_5_z*v_p_x
        - t371 + t374*w_p_y) + t470*(-B_6_x*v_p_z - B_6_z*t377 + B_6_z*v_p_x - t376 + t379*w_p_y) + t478*t527
        + t479*t532 + t480*t535 + t481*t538 + t482*t541 + t483*t544 + t484*t547 + t490*(4*c_x*w_p_y - t345
        - t347) + t493*(4*B_1_x*w_p_y - t345 - 2*t350) + t496*(4*B_2_x*w_p_y - t345 - 2*t355)
        + t499*(4*B_3_x*w_p_y - t345 - 2*t360) + t502*(4*B_4_x*w_p_y - t345 - 2*t365) + t505*(4*B_5_x*w_p_y
        - t345 - 2*t370) + t508*(4*B_6_x*w_p_y - t345 - 2*t375) + t509*(-2*t348 + t380 + 4*t383)
        + t510*(-t489 - t612) + t511*(-2*t352 + t380 + 4*t386) + t512*(-t492 - t613) + t513*(-2*t357 + t380
        + 4*t390) + t514*(-t495 - t614) + t515*(-2*t362 + t380 + 4*t394) + t516*(-t498 - t615)
        + t517*(-2*t367 + t380 + 4*t398) + t518*(-t501 - t616) + t519*(-2*t372 + t380 + 4*t402) + t520*(-t504
        - t617) + t521*(-2*t377 + t380 + 4*t406) + t522*(-t507 - t618) - t531*t620 - t534*t621 - t537*t622
        - t540*t623 - t543*t624 - t546*t625 - t549*t626 + t607*w_p_x + t639*w_p_z + w_p_y*(t557*t604
        + t564*t605 + t571*t606);
    const pkmodes_real z_rz =
        -R_x_x*t559 - R_x_y*t565 - R_x_z*t572 + R_y_x*t629 + R_y_y*t630 + R_y_z*t631 + a_p_rx*t551
        + a_p_ry*t627 + a_p_rz*(J_z_z + t290*(t590 + t632) + t299*(t592 + t633) + t308*(t594 + t634)
        + t317*(t596 + t635) + t326*(t598 + t636) + t335*(t600 + t637) + t344*(t602 + t638)) - a_p_x*t452
        + a_p_y*t485 + pi_rx*w_p_y - pi_ry*w_p_x + (R(1.0)/R(2.0))*t445*t620 + (R(1.0)/R(2.0))*t446*t621
        + (R(1.0)/R(2.0))*t447*t622 + (R(1.0)/R(2.0))*t448*t623 + (R(1.0)/R(2.0))*t449*t624
        + (R(1.0)/R(2.0))*t450*t625 + (R(1.0)/R(2.0))*t451*t626 + t455*(-B_1_x*t384 + B_1_x*v_p_y
        - B_1_y*t386 - B_1_y*v_p_x + t387*w_p_z) + t458*(-B_2_x*t388 + B_2_x*v_p_y - B_2_y*t390 - B_2_y*v_p_x
        + t391*w_p_z) + t461*(-B_3_x*t392 + B_3_x*v_p_y - B_3_y*t394 - B_3_y*v_p_x + t395*w_p_z)
        + t464*(-B_4_x*t396 + B_4_x*v_p_y - B_4_y*t398 - B_4_y*v_p_x + t399*w_p_z) + t467*(-B_5_x*t400
        + B_5_x*v_p_y - B_5_y*t402 - B_5_y*v_p_x + t403*w_p_z) + t470*(-B_6_x*t404 + B_6_x*v_p_y - B_6_y*t406
        - B_6_y*v_p_x + t407*w_p_z) - R(1.0)/R(2.0)*t478*t530 - R(1.0)/R(2.0)*t479*t533
        - R(1.0)/R(2.0)*t480*t536 - R(1.0)/R(2.0)*t481*t539 - R(1.0)/R(2.0)*t482*t542
        - R(1.0)/R(2.0)*t483*t545 - R(1.0)/R(2.0)*t484*t548 + t490*(t283 + 4*t286 - 2*t381) + t493*(t283
        + 4*t294 - 2*t384) + t496*(t283 + 4*t303 - 2*t388) + t499*(t283 + 4*t312 - 2*t392) + t502*(t283
        + 4*t321 - 2*t396) + t505*(t283 + 4*t330 - 2*t400) + t508*(t283 + 4*t339 - 2*t404) + t509*(-t487
        - t612) + t510*(4*c_y*w_p_z - t380 - 2*t383) + t511*(-t491 - t613) + t512*(4*B_1_y*w_p_z - t380
        - 2*t386) + t513*(-t494 - t614) + t514*(4*B_2_y*w_p_z - t380 - 2*t390) + t515*(-t497 - t615)
        + t516*(4*B_3_y*w_p_z - t380 - 2*t394) + t517*(-t500 - t616) + t518*(4*B_4_y*w_p_z - t380 - 2*t398)
        + t519*(-t503 - t617) + t520*(4*B_5_y*w_p_z - t380 - 2*t402) + t521*(-t506 - t618)
        + t522*(4*B_6_y*w_p_z - t380 - 2*t406) + t611*w_p_x + t639*w_p_y + w_p_z*(t575*t608 + t579*t609
        + t582*t610);
    const pkmodes_real t640 = (l_1_dot*l_1_dot);
    const pkmodes_real t641 =
        (R(1.0)/R(2.0))*(v_p_x*v_p_x) + (R(1.0)/R(2.0))*(v_p_y*v_p_y) + (R(1.0)/R(2.0))*(v_p_z*v_p_z);
    const pkmodes_real t642 = (l_2_dot*l_2_dot);
    const pkmodes_real t643 = (l_3_dot*l_3_dot);
    const pkmodes_real t644 = (l_4_dot*l_4_dot);
    const pkmodes_real t645 = (l_5_dot*l_5_dot);
    const pkmodes_real t646 = (l_6_dot*l_6_dot);
    h[0] =
        D_p_rx_1*z_rx + D_p_ry_1*z_ry + D_p_rz_1*z_rz + D_p_x_1*z_x + D_p_y_1*z_y + D_p_z_1*z_z - t454*t640
        - t454*(-t292*t350 - t292*v_p_z - t294*t384 + t294*v_p_y + t298*t628 + t350*v_p_z - t352*t386
        - t352*v_p_x + t354*t558 - t384*v_p_y + t386*v_p_x + t387*t576 - R(1.0)/R(2.0)*t640 + t641);
    h[1] =
        D_p_rx_2*z_rx + D_p_ry_2*z_ry + D_p_rz_2*z_rz + D_p_x_2*z_x + D_p_y_2*z_y + D_p_z_2*z_z - t457*t642
        - t457*(-t301*t355 - t301*v_p_z - t303*t388 + t303*v_p_y + t307*t628 + t355*v_p_z - t357*t390
        - t357*v_p_x + t359*t558 - t388*v_p_y + t390*v_p_x + t391*t576 + t641 - R(1.0)/R(2.0)*t642);
    h[2] =
        D_p_rx_3*z_rx + D_p_ry_3*z_ry + D_p_rz_3*z_rz + D_p_x_3*z_x + D_p_y_3*z_y + D_p_z_3*z_z - t460*t643
        - t460*(-t310*t360 - t310*v_p_z - t312*t392 + t312*v_p_y + t316*t628 + t360*v_p_z - t362*t394
        - t362*v_p_x + t364*t558 - t392*v_p_y + t394*v_p_x + t395*t576 + t641 - R(1.0)/R(2.0)*t643);
    h[3] =
        D_p_rx_4*z_rx + D_p_ry_4*z_ry + D_p_rz_4*z_rz + D_p_x_4*z_x + D_p_y_4*z_y + D_p_z_4*z_z - t463*t644
        - t463*(-t319*t365 - t319*v_p_z - t321*t396 + t321*v_p_y + t325*t628 + t365*v_p_z - t367*t398
        - t367*v_p_x + t369*t558 - t396*v_p_y + t398*v_p_x + t399*t576 + t641 - R(1.0)/R(2.0)*t644);
    h[4] =
        D_p_rx_5*z_rx + D_p_ry_5*z_ry + D_p_rz_5*z_rz + D_p_x_5*z_x + D_p_y_5*z_y + D_p_z_5*z_z - t466*t645
        - t466*(-t328*t370 - t328*v_p_z - t330*t400 + t330*v_p_y + t334*t628 + t370*v_p_z - t372*t402
        - t372*v_p_x + t374*t558 - t400*v_p_y + t402*v_p_x + t403*t576 + t641 - R(1.0)/R(2.0)*t645);
    h[5] =
        D_p_rx_6*z_rx + D_p_ry_6*z_ry + D_p_rz_6*z_rz + D_p_x_6*z_x + D_p_y_6*z_y + D_p_z_6*z_z - t469*t646
        - t469*(-t337*t375 - t337*v_p_z - t339*t404 + t339*v_p_y + t343*t628 + t375*v_p_z - t377*t406
        - t377*v_p_x + t379*t558 - t404*v_p_y + t406*v_p_x + t407*t576 + t641 - R(1.0)/R(2.0)*t646);
}

void hexapod_gravity_potential(const pkmodes_real p[6], const hexapod_parameters *parameters,
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
    const pkmodes_real m_lift_1 = m_r_1 + (c_b_1*m_b_1 - c_r_1*m_r_1)/l_1;
    const pkmodes_real m_lift_2 = m_r_2 + (c_b_2*m_b_2 - c_r_2*m_r_2)/l_2;
    const pkmodes_real m_lift_3 = m_r_3 + (c_b_3*m_b_3 - c_r_3*m_r_3)/l_3;
    const pkmodes_real m_lift_4 = m_r_4 + (c_b_4*m_b_4 - c_r_4*m_r_4)/l_4;
    const pkmodes_real m_lift_5 = m_r_5 + (c_b_5*m_b_5 - c_r_5*m_r_5)/l_5;
    const pkmodes_real m_lift_6 = m_r_6 + (c_b_6*m_b_6 - c_r_6*m_r_6)/l_6;
    *V_g =
        -g_x*(a_1_x*m_b_1 + a_1_x*m_r_1 + a_2_x*m_b_2 + a_2_x*m_r_2 + a_3_x*m_b_3 + a_3_x*m_r_3 + a_4_x*m_b_4
        + a_4_x*m_r_4 + a_5_x*m_b_5 + a_5_x*m_r_5 + a_6_x*m_b_6 + a_6_x*m_r_6 + c_x*m_p + d_1_x*m_lift_1
        + d_2_x*m_lift_2 + d_3_x*m_lift_3 + d_4_x*m_lift_4 + d_5_x*m_lift_5 + d_6_x*m_lift_6 + m_p*p_x)
        - g_y*(a_1_y*m_b_1 + a_1_y*m_r_1 + a_2_y*m_b_2 + a_2_y*m_r_2 + a_3_y*m_b_3 + a_3_y*m_r_3
        + a_4_y*m_b_4 + a_4_y*m_r_4 + a_5_y*m_b_5 + a_5_y*m_r_5 + a_6_y*m_b_6 + a_6_y*m_r_6 + c_y*m_p
        + d_1_y*m_lift_1 + d_2_y*m_lift_2 + d_3_y*m_lift_3 + d_4_y*m_lift_4 + d_5_y*m_lift_5 + d_6_y*m_lift_6
        + m_p*p_y) - g_z*(a_1_z*m_b_1 + a_1_z*m_r_1 + a_2_z*m_b_2 + a_2_z*m_r_2 + a_3_z*m_b_3 + a_3_z*m_r_3
        + a_4_z*m_b_4 + a_4_z*m_r_4 + a_5_z*m_b_5 + a_5_z*m_r_5 + a_6_z*m_b_6 + a_6_z*m_r_6 + c_z*m_p
        + d_1_z*m_lift_1 + d_2_z*m_lift_2 + d_3_z*m_lift_3 + d_4_z*m_lift_4 + d_5_z*m_lift_5 + d_6_z*m_lift_6
        + m_p*p_z);
}

void hexapod_gravity_gradient(const pkmodes_real p[6], const hexapod_parameters *parameters,
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
    const pkmodes_real t25 = g_x*m_lift_1;
    const pkmodes_real t26 = g_x*m_lift_2;
    const pkmodes_real t27 = g_x*m_lift_3;
    const pkmodes_real t28 = g_x*m_lift_4;
    const pkmodes_real t29 = g_x*m_lift_5;
    const pkmodes_real t30 = g_x*m_lift_6;
    const pkmodes_real t31 = g_x*m_p;
    const pkmodes_real G_p_x = -t25 - t26 - t27 - t28 - t29 - t30 - t31;
    const pkmodes_real t32 = g_y*m_lift_1;
    const pkmodes_real t33 = g_y*m_lift_2;
    const pkmodes_real t34 = g_y*m_lift_3;
    const pkmodes_real t35 = g_y*m_lift_4;
    const pkmodes_real t36 = g_y*m_lift_5;
    const pkmodes_real t37 = g_y*m_lift_6;
    const pkmodes_real t38 = g_y*m_p;
    const pkmodes_real G_p_y = -t32 - t33 - t34 - t35 - t36 - t37 - t38;
    const pkmodes_real t39 = g_z*m_lift_1;
    const pkmodes_real t40 = g_z*m_lift_2;
    const pkmodes_real t41 = g_z*m_lift_3;
    const pkmodes_real t42 = g_z*m_lift_4;
    const pkmodes_real t43 = g_z*m_lift_5;
    const pkmodes_real t44 = g_z*m_lift_6;
    const pkmodes_real t45 = g_z*m_p;
    const pkmodes_real G_p_z = -t39 - t40 - t41 - t42 - t43 - t44 - t45;
    const pkmodes_real G_p_rx =
        -B_1_y*t39 + B_1_z*g_y*m_lift_1 - B_2_y*t40 + B_2_z*g_y*m_lift_2 - B_3_y*t41 + B_3_z*g_y*m_lift_3
        - B_4_y*t42 + B_4_z*g_y*m_lift_4 - B_5_y*t43 + B_5_z*g_y*m_lift_5 - B_6_y*t44 + B_6_z*g_y*m_lift_6
        - c_y*t45 + c_z*g_y*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t39 - B_1_z*t25 + B_2_x*t40 - B_2_z*t26 + B_3_x*t41 - B_3_z*t27 + B_4_x*t42 - B_4_z*t28
        + B_5_x*t43 - B_5_z*t29 + B_6_x*t44 - B_6_z*t30 + c_x*t45 - c_z*t31;
    const pkmodes_real G_p_rz =
        -B_1_x*t32 + B_1_y*g_x*m_lift_1 - B_2_x*t33 + B_2_y*g_x*m_lift_2 - B_3_x*t34 + B_3_y*g_x*m_lift_3
        - B_4_x*t35 + B_4_y*g_x*m_lift_4 - B_5_x*t36 + B_5_y*g_x*m_lift_5 - B_6_x*t37 + B_6_y*g_x*m_lift_6
        - c_x*t38 + c_y*g_x*m_p;
    G[0] =
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - t12*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1);
    G[1] =
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - t13*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2);
    G[2] =
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - t14*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3);
    G[3] =
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - t15*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4);
    G[4] =
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - t16*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5);
    G[5] =
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - t17*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6);
}

void hexapod_gravity_hessian(const pkmodes_real p[6], const hexapod_parameters *parameters,
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
    const pkmodes_real t25 = g_x*m_lift_1;
    const pkmodes_real t26 = g_x*m_lift_2;
    const pkmodes_real t27 = g_x*m_lift_3;
    const pkmodes_real t28 = g_x*m_lift_4;
    const pkmodes_real t29 = g_x*m_lift_5;
    const pkmodes_real t30 = g_x*m_lift_6;
    const pkmodes_real t31 = g_x*m_p;
    const pkmodes_real G_p_x = -t25 - t26 - t27 - t28 - t29 - t30 - t31;
    const pkmodes_real t32 = g_y*m_lift_1;
    const pkmodes_real t33 = g_y*m_lift_2;
    const pkmodes_real t34 = g_y*m_lift_3;
    const pkmodes_real t35 = g_y*m_lift_4;
    const pkmodes_real t36 = g_y*m_lift_5;
    const pkmodes_real t37 = g_y*m_lift_6;
    const pkmodes_real t38 = g_y*m_p;
    const pkmodes_real G_p_y = -t32 - t33 - t34 - t35 - t36 - t37 - t38;
    const pkmodes_real t39 = g_z*m_lift_1;
    const pkmodes_real t40 = g_z*m_lift_2;
    const pkmodes_real t41 = g_z*m_lift_3;
    const pkmodes_real t42 = g_z*m_lift_4;
    const pkmodes_real t43 = g_z*m_lift_5;
    const pkmodes_real t44 = g_z*m_lift_6;
    const pkmodes_real t45 = g_z*m_p;
    const pkmodes_real G_p_z = -t39 - t40 - t41 - t42 - t43 - t44 - t45;
    const pkmodes_real G_p_rx =
        -B_1_y*t39 + B_1_z*g_y*m_lift_1 - B_2_y*t40 + B_2_z*g_y*m_lift_2 - B_3_y*t41 + B_3_z*g_y*m_lift_3
        - B_4_y*t42 + B_4_z*g_y*m_lift_4 - B_5_y*t43 + B_5_z*g_y*m_lift_5 - B_6_y*t44 + B_6_z*g_y*m_lift_6
        - c_y*t45 + c_z*g_y*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t39 - B_1_z*t25 + B_2_x*t40 - B_2_z*t26 + B_3_x*t41 - B_3_z*t27 + B_4_x*t42 - B_4_z*t28
        + B_5_x*t43 - B_5_z*t29 + B_6_x*t44 - B_6_z*t30 + c_x*t45 - c_z*t31;
    const pkmodes_real G_p_rz =
        -B_1_x*t32 + B_1_y*g_x*m_lift_1 - B_2_x*t33 + B_2_y*g_x*m_lift_2 - B_3_x*t34 + B_3_y*g_x*m_lift_3
        - B_4_x*t35 + B_4_y*g_x*m_lift_4 - B_5_x*t36 + B_5_y*g_x*m_lift_5 - B_6_x*t37 + B_6_y*g_x*m_lift_6
        - c_x*t38 + c_y*g_x*m_p;
    const pkmodes_real mu_1 =
        t18*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const pkmodes_real mu_2 =
        t18*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const pkmodes_real mu_3 =
        t18*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const pkmodes_real mu_4 =
        t18*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const pkmodes_real mu_5 =
        t18*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const pkmodes_real mu_6 =
        t18*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const pkmodes_real g_4_x = -d_1_x*mu_1 - t25;
    const pkmodes_real g_4_y = -d_1_y*mu_1 - t32;
    const pkmodes_real g_4_z = -d_1_z*mu_1 - t39;
    const pkmodes_real g_5_x = -d_2_x*mu_2 - t26;
    const pkmodes_real g_5_y = -d_2_y*mu_2 - t33;
    const pkmodes_real g_5_z = -d_2_z*mu_2 - t40;
    const pkmodes_real g_6_x = -d_3_x*mu_3 - t27;
    const pkmodes_real g_6_y = -d_3_y*mu_3 - t34;
    const pkmodes_real g_6_z = -d_3_z*mu_3 - t41;
    const pkmodes_real g_7_x = -d_4_x*mu_4 - t28;
    const pkmodes_real g_7_y = -d_4_y*mu_4 - t35;
    const pkmodes_real g_7_z = -d_4_z*mu_4 - t42;
    const pkmodes_real g_8_x = -d_5_x*mu_5 - t29;
    const pkmodes_real g_8_y = -d_5_y*mu_5 - t36;
    const pkmodes_real g_8_z = -d_5_z*mu_5 - t43;
    const pkmodes_real g_9_x = -d_6_x*mu_6 - t30;
    const pkmodes_real g_9_y = -d_6_y*mu_6 - t37;
    const pkmodes_real g_9_z = -d_6_z*mu_6 - t44;
    const pkmodes_real g_10_x = -t31;
    const pkmodes_real g_10_y = -t38;
    const pkmodes_real g_10_z = -t45;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t46 = B_1_z*mu_1;
    const pkmodes_real t47 = B_2_z*mu_2;
    const pkmodes_real t48 = B_3_z*mu_3;
    const pkmodes_real t49 = B_4_z*mu_4;
    const pkmodes_real t50 = B_5_z*mu_5;
    const pkmodes_real t51 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t46 + t47 + t48 + t49 + t50 + t51;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t52 = B_1_y*mu_1;
    const pkmodes_real t53 = B_2_y*mu_2;
    const pkmodes_real t54 = B_3_y*mu_3;
    const pkmodes_real t55 = B_4_y*mu_4;
    const pkmodes_real t56 = B_5_y*mu_5;
    const pkmodes_real t57 = B_6_y*mu_6;
    const pkmodes_real L_x_rz = t52 + t53 + t54 + t55 + t56 + t57;
    const pkmodes_real L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t58 =
        (B_1_z*B_1_z)*mu_1 + B_1_z*g_4_z + (B_2_z*B_2_z)*mu_2 + B_2_z*g_5_z + (B_3_z*B_3_z)*mu_3
        + B_3_z*g_6_z + (B_4_z*B_4_z)*mu_4 + B_4_z*g_7_z + (B_5_z*B_5_z)*mu_5 + B_5_z*g_8_z
        + (B_6_z*B_6_z)*mu_6 + B_6_z*g_9_z + c_z*g_10_z;
    const pkmodes_real t59 =
        (B_1_y*B_1_y)*mu_1 + B_1_y*g_4_y + (B_2_y*B_2_y)*mu_2 + B_2_y*g_5_y + (B_3_y*B_3_y)*mu_3
        + B_3_y*g_6_y + (B_4_y*B_4_y)*mu_4 + B_4_y*g_7_y + (B_5_y*B_5_y)*mu_5 + B_5_y*g_8_y
        + (B_6_y*B_6_y)*mu_6 + B_6_y*g_9_y + c_y*g_10_y;
    const pkmodes_real L_rx_rx = -t58 - t59;
    const pkmodes_real t60 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t61 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t62 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t63 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t64 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t65 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t66 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t67 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t68 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t69 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t70 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t71 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real t72 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t73 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t52 + B_1_y*t61 + B_2_x*t53 + B_2_y*t63 + B_3_x*t54 + B_3_y*t65 + B_4_x*t55 + B_4_y*t67
        + B_5_x*t56 + B_5_y*t69 + B_6_x*t57 + B_6_y*t71 + c_y*t73 + g_10_y*t72 + g_4_y*t60 + g_5_y*t62
        + g_6_y*t64 + g_7_y*t66 + g_8_y*t68 + g_9_y*t70;
    const pkmodes_real L_rx_rz =
        B_1_x*t46 + B_1_z*t61 + B_2_x*t47 + B_2_z*t63 + B_3_x*t48 + B_3_z*t65 + B_4_x*t49 + B_4_z*t67
        + B_5_x*t50 + B_5_z*t69 + B_6_x*t51 + B_6_z*t71 + c_z*t73 + g_10_z*t72 + g_4_z*t60 + g_5_z*t62
        + g_6_z*t64 + g_7_z*t66 + g_8_z*t68 + g_9_z*t70;
    const pkmodes_real t74 =
        (B_1_x*B_1_x)*mu_1 + B_1_x*g_4_x + (B_2_x*B_2_x)*mu_2 + B_2_x*g_5_x + (B_3_x*B_3_x)*mu_3
        + B_3_x*g_6_x + (B_4_x*B_4_x)*mu_4 + B_4_x*g_7_x + (B_5_x*B_5_x)*mu_5 + B_5_x*g_8_x
        + (B_6_x*B_6_x)*mu_6 + B_6_x*g_9_x + c_x*g_10_x;
    const pkmodes_real L_ry_ry = -t58 - t74;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t46 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t47 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t48
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t49 + (R(1.0)/R(2.0))*B_4_z*g_7_y
        + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t50 + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z
        + B_6_y*t51 + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y;
    const pkmodes_real L_rz_rz = -t59 - t74;
    const pkmodes_real t75 = t12/(l_1*l_1);
    const pkmodes_real t76 = g_x*t75;
    const pkmodes_real f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t76;
    const pkmodes_real t77 = t13/(l_2*l_2);
    const pkmodes_real t78 = g_x*t77;
    const pkmodes_real f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t78;
    const pkmodes_real t79 = t14/(l_3*l_3);
    const pkmodes_real t80 = g_x*t79;
    const pkmodes_real f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t80;
    const pkmodes_real t81 = t15/(l_4*l_4);
    const pkmodes_real t82 = g_x*t81;
    const pkmodes_real f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t82;
    const pkmodes_real t83 = t16/(l_5*l_5);
    const pkmodes_real t84 = g_x*t83;
    const pkmodes_real f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t84;
    const pkmodes_real t85 = t17/(l_6*l_6);
    const pkmodes_real t86 = g_x*t85;
    const pkmodes_real f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t86;
    const pkmodes_real t87 = g_y*t75;
    const pkmodes_real f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t87;
    const pkmodes_real t88 = g_y*t77;
    const pkmodes_real f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t88;
    const pkmodes_real t89 = g_y*t79;
    const pkmodes_real f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t89;
    const pkmodes_real t90 = g_y*t81;
    const pkmodes_real f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t90;
    const pkmodes_real t91 = g_y*t83;
    const pkmodes_real f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t91;
    const pkmodes_real t92 = g_y*t85;
    const pkmodes_real f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t92;
    const pkmodes_real t93 = g_z*t75;
    const pkmodes_real f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t93;
    const pkmodes_real t94 = g_z*t77;
    const pkmodes_real f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t94;
    const pkmodes_real t95 = g_z*t79;
    const pkmodes_real f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t95;
    const pkmodes_real t96 = g_z*t81;
    const pkmodes_real f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t96;
    const pkmodes_real t97 = g_z*t83;
    const pkmodes_real f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t97;
    const pkmodes_real t98 = g_z*t85;
    const pkmodes_real f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t98;
    const pkmodes_real t99 = t75*(-B_1_y*g_z + B_1_z*g_y);
    const pkmodes_real f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx - t99;
    const pkmodes_real t100 = t77*(-B_2_y*g_z + B_2_z*g_y);
    const pkmodes_real f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx - t100;
    const pkmodes_real t101 = t79*(-B_3_y*g_z + B_3_z*g_y);
    const pkmodes_real f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx - t101;
    const pkmodes_real t102 = t81*(-B_4_y*g_z + B_4_z*g_y);
    const pkmodes_real f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx - t102;
    const pkmodes_real t103 = t83*(-B_5_y*g_z + B_5_z*g_y);
    const pkmodes_real f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx - t103;
    const pkmodes_real t104 = t85*(-B_6_y*g_z + B_6_z*g_y);
    const pkmodes_real f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx - t104;
    const pkmodes_real t105 = t75*(B_1_x*g_z - B_1_z*g_x);
    const pkmodes_real f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry - t105;
    const pkmodes_real t106 = t77*(B_2_x*g_z - B_2_z*g_x);
    const pkmodes_real f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry - t106;
    const pkmodes_real t107 = t79*(B_3_x*g_z - B_3_z*g_x);
    const pkmodes_real f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry - t107;
    const pkmodes_real t108 = t81*(B_4_x*g_z - B_4_z*g_x);
    const pkmodes_real f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry - t108;
    const pkmodes_real t109 = t83*(B_5_x*g_z - B_5_z*g_x);
    const pkmodes_real f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry - t109;
    const pkmodes_real t110 = t85*(B_6_x*g_z - B_6_z*g_x);
    const pkmodes_real f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry - t110;
    const pkmodes_real t111 = t75*(-B_1_x*g_y + B_1_y*g_x);
    const pkmodes_real f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz - t111;
    const pkmodes_real t112 = t77*(-B_2_x*g_y + B_2_y*g_x);
    const pkmodes_real f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz - t112;
    const pkmodes_real t113 = t79*(-B_3_x*g_y + B_3_y*g_x);
    const pkmodes_real f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz - t113;
    const pkmodes_real t114 = t81*(-B_4_x*g_y + B_4_y*g_x);
    const pkmodes_real f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz - t114;
    const pkmodes_real t115 = t83*(-B_5_x*g_y + B_5_y*g_x);
    const pkmodes_real f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz - t115;
    const pkmodes_real t116 = t85*(-B_6_x*g_y + B_6_y*g_x);
    const pkmodes_real f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz - t116;
    H_g[0][0] =
        D_p_rx_1*f_rx_l_1 - D_p_rx_1*t99 + D_p_ry_1*f_ry_l_1 - D_p_ry_1*t105 + D_p_rz_1*f_rz_l_1
        - D_p_rz_1*t111 + D_p_x_1*f_x_l_1 + D_p_x_1*t76 + D_p_y_1*f_y_l_1 + D_p_y_1*t87 + D_p_z_1*f_z_l_1
        + D_p_z_1*t93 + mu_1 + 2*t12*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1*l_1);
    H_g[0][1] = H_g[1][0] =
        D_p_rx_1*f_rx_l_2 - D_p_rx_2*t99 + D_p_ry_1*f_ry_l_2 - D_p_ry_2*t105 + D_p_rz_1*f_rz_l_2
        - D_p_rz_2*t111 + D_p_x_1*f_x_l_2 + D_p_x_2*t76 + D_p_y_1*f_y_l_2 + D_p_y_2*t87 + D_p_z_1*f_z_l_2
        + D_p_z_2*t93;
    H_g[0][2] = H_g[2][0] =
        D_p_rx_1*f_rx_l_3 - D_p_rx_3*t99 + D_p_ry_1*f_ry_l_3 - D_p_ry_3*t105 + D_p_rz_1*f_rz_l_3
        - D_p_rz_3*t111 + D_p_x_1*f_x_l_3 + D_p_x_3*t76 + D_p_y_1*f_y_l_3 + D_p_y_3*t87 + D_p_z_1*f_z_l_3
        + D_p_z_3*t93;
    H_g[0][3] = H_g[3][0] =
        D_p_rx_1*f_rx_l_4 - D_p_rx_4*t99 + D_p_ry_1*f_ry_l_4 - D_p_ry_4*t105 + D_p_rz_1*f_rz_l_4
        - D_p_rz_4*t111 + D_p_x_1*f_x_l_4 + D_p_x_4*t76 + D_p_y_1*f_y_l_4 + D_p_y_4*t87 + D_p_z_1*f_z_l_4
        + D_p_z_4*t93;
    H_g[0][4] = H_g[4][0] =
        D_p_rx_1*f_rx_l_5 - D_p_rx_5*t99 + D_p_ry_1*f_ry_l_5 - D_p_ry_5*t105 + D_p_rz_1*f_rz_l_5
        - D_p_rz_5*t111 + D_p_x_1*f_x_l_5 + D_p_x_5*t76 + D_p_y_1*f_y_l_5 + D_p_y_5*t87 + D_p_z_1*f_z_l_5
        + D_p_z_5*t93;
    H_g[0][5] = H_g[5][0] =
        D_p_rx_1*f_rx_l_6 - D_p_rx_6*t99 + D_p_ry_1*f_ry_l_6 - D_p_ry_6*t105 + D_p_rz_1*f_rz_l_6
        - D_p_rz_6*t111 + D_p_x_1*f_x_l_6 + D_p_x_6*t76 + D_p_y_1*f_y_l_6 + D_p_y_6*t87 + D_p_z_1*f_z_l_6
        + D_p_z_6*t93;
    H_g[1][1] =
        D_p_rx_2*f_rx_l_2 - D_p_rx_2*t100 + D_p_ry_2*f_ry_l_2 - D_p_ry_2*t106 + D_p_rz_2*f_rz_l_2
        - D_p_rz_2*t112 + D_p_x_2*f_x_l_2 + D_p_x_2*t78 + D_p_y_2*f_y_l_2 + D_p_y_2*t88 + D_p_z_2*f_z_l_2
        + D_p_z_2*t94 + mu_2 + 2*t13*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2*l_2);
    H_g[1][2] = H_g[2][1] =
        D_p_rx_2*f_rx_l_3 - D_p_rx_3*t100 + D_p_ry_2*f_ry_l_3 - D_p_ry_3*t106 + D_p_rz_2*f_rz_l_3
        - D_p_rz_3*t112 + D_p_x_2*f_x_l_3 + D_p_x_3*t78 + D_p_y_2*f_y_l_3 + D_p_y_3*t88 + D_p_z_2*f_z_l_3
        + D_p_z_3*t94;
    H_g[1][3] = H_g[3][1] =
        D_p_rx_2*f_rx_l_4 - D_p_rx_4*t100 + D_p_ry_2*f_ry_l_4 - D_p_ry_4*t106 + D_p_rz_2*f_rz_l_4
        - D_p_rz_4*t112 + D_p_x_2*f_x_l_4 + D_p_x_4*t78 + D_p_y_2*f_y_l_4 + D_p_y_4*t88 + D_p_z_2*f_z_l_4
        + D_p_z_4*t94;
    H_g[1][4] = H_g[4][1] =
        D_p_rx_2*f_rx_l_5 - D_p_rx_5*t100 + D_p_ry_2*f_ry_l_5 - D_p_ry_5*t106 + D_p_rz_2*f_rz_l_5
        - D_p_rz_5*t112 + D_p_x_2*f_x_l_5 + D_p_x_5*t78 + D_p_y_2*f_y_l_5 + D_p_y_5*t88 + D_p_z_2*f_z_l_5
        + D_p_z_5*t94;
    H_g[1][5] = H_g[5][1] =
        D_p_rx_2*f_rx_l_6 - D_p_rx_6*t100 + D_p_ry_2*f_ry_l_6 - D_p_ry_6*t106 + D_p_rz_2*f_rz_l_6
        - D_p_rz_6*t112 + D_p_x_2*f_x_l_6 + D_p_x_6*t78 + D_p_y_2*f_y_l_6 + D_p_y_6*t88 + D_p_z_2*f_z_l_6
        + D_p_z_6*t94;
    H_g[2][2] =
        D_p_rx_3*f_rx_l_3 - D_p_rx_3*t101 + D_p_ry_3*f_ry_l_3 - D_p_ry_3*t107 + D_p_rz_3*f_rz_l_3
        - D_p_rz_3*t113 + D_p_x_3*f_x_l_3 + D_p_x_3*t80 + D_p_y_3*f_y_l_3 + D_p_y_3*t89 + D_p_z_3*f_z_l_3
        + D_p_z_3*t95 + mu_3 + 2*t14*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3*l_3);
    H_g[2][3] = H_g[3][2] =
        D_p_rx_3*f_rx_l_4 - D_p_rx_4*t101 + D_p_ry_3*f_ry_l_4 - D_p_ry_4*t107 + D_p_rz_3*f_rz_l_4
        - D_p_rz_4*t113 + D_p_x_3*f_x_l_4 + D_p_x_4*t80 + D_p_y_3*f_y_l_4 + D_p_y_4*t89 + D_p_z_3*f_z_l_4
        + D_p_z_4*t95;
    H_g[2][4] = H_g[4][2] =
        D_p_rx_3*f_rx_l_5 - D_p_rx_5*t101 + D_p_ry_3*f_ry_l_5 - D_p_ry_5*t107 + D_p_rz_3*f_rz_l_5
        - D_p_rz_5*t113 + D_p_x_3*f_x_l_5 + D_p_x_5*t80 + D_p_y_3*f_y_l_5 + D_p_y_5*t89 + D_p_z_3*f_z_l_5
        + D_p_z_5*t95;
    H_g[2][5] = H_g[5][2] =
        D_p_rx_3*f_rx_l_6 - D_p_rx_6*t101 + D_p_ry_3*f_ry_l_6 - D_p_ry_6*t107 + D_p_rz_3*f_rz_l_6
        - D_p_rz_6*t113 + D_p_x_3*f_x_l_6 + D_p_x_6*t80 + D_p_y_3*f_y_l_6 + D_p_y_6*t89 + D_p_z_3*f_z_l_6
        + D_p_z_6*t95;
    H_g[3][3] =
        D_p_rx_4*f_rx_l_4 - D_p_rx_4*t102 + D_p_ry_4*f_ry_l_4 - D_p_ry_4*t108 + D_p_rz_4*f_rz_l_4
        - D_p_rz_4*t114 + D_p_x_4*f_x_l_4 + D_p_x_4*t82 + D_p_y_4*f_y_l_4 + D_p_y_4*t90 + D_p_z_4*f_z_l_4
        + D_p_z_4*t96 + mu_4 + 2*t15*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4*l_4);
    H_g[3][4] = H_g[4][3] =
        D_p_rx_4*f_rx_l_5 - D_p_rx_5*t102 + D_p_ry_4*f_ry_l_5 - D_p_ry_5*t108 + D_p_rz_4*f_rz_l_5
        - D_p_rz_5*t114 + D_p_x_4*f_x_l_5 + D_p_x_5*t82 + D_p_y_4*f_y_l_5 + D_p_y_5*t90 + D_p_z_4*f_z_l_5
        + D_p_z_5*t96;
    H_g[3][5] = H_g[5][3] =
        D_p_rx_4*f_rx_l_6 - D_p_rx_6*t102 + D_p_ry_4*f_ry_l_6 - D_p_ry_6*t108 + D_p_rz_4*f_rz_l_6
        - D_p_rz_6*t114 + D_p_x_4*f_x_l_6 + D_p_x_6*t82 + D_p_y_4*f_y_l_6 + D_p_y_6*t90 + D_p_z_4*f_z_l_6
        + D_p_z_6*t96;
    H_g[4][4] =
        D_p_rx_5*f_rx_l_5 - D_p_rx_5*t103 + D_p_ry_5*f_ry_l_5 - D_p_ry_5*t109 + D_p_rz_5*f_rz_l_5
        - D_p_rz_5*t115 + D_p_x_5*f_x_l_5 + D_p_x_5*t84 + D_p_y_5*f_y_l_5 + D_p_y_5*t91 + D_p_z_5*f_z_l_5
        + D_p_z_5*t97 + mu_5 + 2*t16*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5*l_5);
    H_g[4][5] = H_g[5][4] =
        D_p_rx_5*f_rx_l_6 - D_p_rx_6*t103 + D_p_ry_5*f_ry_l_6 - D_p_ry_6*t109 + D_p_rz_5*f_rz_l_6
        - D_p_rz_6*t115 + D_p_x_5*f_x_l_6 + D_p_x_6*t84 + D_p_y_5*f_y_l_6 + D_p_y_6*t91 + D_p_z_5*f_z_l_6
        + D_p_z_6*t97;
    H_g[5][5] =
        D_p_rx_6*f_rx_l_6 - D_p_rx_6*t104 + D_p_ry_6*f_ry_l_6 - D_p_ry_6*t110 + D_p_rz_6*f_rz_l_6
        - D_p_rz_6*t116 + D_p_x_6*f_x_l_6 + D_p_x_6*t86 + D_p_y_6*f_y_l_6 + D_p_y_6*t92 + D_p_z_6*f_z_l_6
        + D_p_z_6*t98 + mu_6 + 2*t17*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6*l_6);
}

void hexapod_elastic_potential(const pkmodes_real p[6], const pkmodes_real delta_q[12],
    const hexapod_parameters *parameters, pkmodes_real *V_el)
{
    (void)p;
    const pkmodes_real delta_l_1 = delta_q[0];
    const pkmodes_real delta_l_2 = delta_q[1];
    const pkmodes_real delta_l_3 = delta_q[2];
    const pkmodes_real delta_l_4 = delta_q[3];
    const pkmodes_real delta_l_5 = delta_q[4];
    const pkmodes_real delta_l_6 = delta_q[5];
    const pkmodes_real delta_s_1 = delta_q[6];
    const pkmodes_real delta_s_2 = delta_q[7];
    const pkmodes_real delta_s_3 = delta_q[8];
    const pkmodes_real delta_s_4 = delta_q[9];
    const pkmodes_real delta_s_5 = delta_q[10];
    const pkmodes_real delta_s_6 = delta_q[11];
    const pkmodes_real k_l_1 = parameters->leg_stiffness[0];
    const pkmodes_real k_l_2 = parameters->leg_stiffness[1];
    const pkmodes_real k_l_3 = parameters->leg_stiffness[2];
    const pkmodes_real k_l_4 = parameters->leg_stiffness[3];
    const pkmodes_real k_l_5 = parameters->leg_stiffness[4];
    const pkmodes_real k_l_6 = parameters->leg_stiffness[5];
    *V_el =
        (R(1.0)/R(2.0))*k_l_1*((delta_l_1 - delta_s_1)*(delta_l_1 - delta_s_1))
        + (R(1.0)/R(2.0))*k_l_2*((delta_l_2 - delta_s_2)*(delta_l_2 - delta_s_2))
        + (R(1.0)/R(2.0))*k_l_3*((delta_l_3 - delta_s_3)*(delta_l_3 - delta_s_3))
        + (R(1.0)/R(2.0))*k_l_4*((delta_l_4 - delta_s_4)*(delta_l_4 - delta_s_4))
        + (R(1.0)/R(2.0))*k_l_5*((delta_l_5 - delta_s_5)*(delta_l_5 - delta_s_5))
        + (R(1.0)/R(2.0))*k_l_6*((delta_l_6 - delta_s_6)*(delta_l_6 - delta_s_6));
}

void hexapod_elastic_gradient(const pkmodes_real p[6], const pkmodes_real delta_q[12],
    const hexapod_parameters *parameters, pkmodes_real E[12])
{
    (void)p;
    const pkmodes_real delta_l_1 = delta_q[0];
    const pkmodes_real delta_l_2 = delta_q[1];
    const pkmodes_real delta_l_3 = delta_q[2];
    const pkmodes_real delta_l_4 = delta_q[3];
    const pkmodes_real delta_l_5 = delta_q[4];
    const pkmodes_real delta_l_6 = delta_q[5];
    const pkmodes_real delta_s_1 = delta_q[6];
    const pkmodes_real delta_s_2 = delta_q[7];
    const pkmodes_real delta_s_3 = delta_q[8];
    const pkmodes_real delta_s_4 = delta_q[9];
    const pkmodes_real delta_s_5 = delta_q[10];
    const pkmodes_real delta_s_6 = delta_q[11];
    const pkmodes_real k_l_1 = parameters->leg_stiffness[0];
    const pkmodes_real k_l_2 = parameters->leg_stiffness[1];
    const pkmodes_real k_l_3 = parameters->leg_stiffness[2];
    const pkmodes_real k_l_4 = parameters->leg_stiffness[3];
    const pkmodes_real k_l_5 = parameters->leg_stiffness[4];
    const pkmodes_real k_l_6 = parameters->leg_stiffness[5];
    const pkmodes_real t1 = 2*delta_l_1 - 2*delta_s_1;
    const pkmodes_real t2 = (R(1.0)/R(2.0))*k_l_1;
    const pkmodes_real t3 = 2*delta_l_2 - 2*delta_s_2;
    const pkmodes_real t4 = (R(1.0)/R(2.0))*k_l_2;
    const pkmodes_real t5 = 2*delta_l_3 - 2*delta_s_3;
    const pkmodes_real t6 = (R(1.0)/R(2.0))*k_l_3;
    const pkmodes_real t7 = 2*delta_l_4 - 2*delta_s_4;
    const pkmodes_real t8 = (R(1.0)/R(2.0))*k_l_4;
    const pkmodes_real t9 = 2*delta_l_5 - 2*delta_s_5;
    const pkmodes_real t10 = (R(1.0)/R(2.0))*k_l_5;
    const pkmodes_real t11 = 2*delta_l_6 - 2*delta_s_6;
    const pkmodes_real t12 = (R(1.0)/R(2.0))*k_l_6;
    E[0] = t1*t2;
    E[1] = t3*t4;
    E[2] = t5*t6;
    E[3] = t7*t8;
    E[4] = t10*t9;
    E[5] = t11*t12;
    E[6] = -t1*t2;
    E[7] = -t3*t4;
    E[8] = -t5*t6;
    E[9] = -t7*t8;
    E[10] = -t10*t9;
    E[11] = -t11*t12;
}

void hexapod_elastic_hessian(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real H_el[12][12])
{
    (void)p;
    const pkmodes_real k_l_1 = parameters->leg_stiffness[0];
    const pkmodes_real k_l_2 = parameters->leg_stiffness[1];
    const pkmodes_real k_l_3 = parameters->leg_stiffness[2];
    const pkmodes_real k_l_4 = parameters->leg_stiffness[3];
    const pkmodes_real k_l_5 = parameters->leg_stiffness[4];
    const pkmodes_real k_l_6 = parameters->leg_stiffness[5];
    memset(H_el, 0, sizeof(pkmodes_real[12][12]));
    H_el[0][0] = k_l_1;
    H_el[0][6] = H_el[6][0] = -k_l_1;
    H_el[1][1] = k_l_2;
    H_el[1][7] = H_el[7][1] = -k_l_2;
    H_el[2][2] = k_l_3;
    H_el[2][8] = H_el[8][2] = -k_l_3;
    H_el[3][3] = k_l_4;
    H_el[3][9] = H_el[9][3] = -k_l_4;
    H_el[4][4] = k_l_5;
    H_el[4][10] = H_el[10][4] = -k_l_5;
    H_el[5][5] = k_l_6;
    H_el[5][11] = H_el[11][5] = -k_l_6;
    H_el[6][6] = k_l_1;
    H_el[7][7] = k_l_2;
    H_el[8][8] = k_l_3;
    H_el[9][9] = k_l_4;
    H_el[10][10] = k_l_5;
    H_el[11][11] = k_l_6;
}

void hexapod_static_equilibrium(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real tau_st[6], pkmodes_real theta_st[6])
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
    const pkmodes_real t25 = g_x*m_lift_1;
    const pkmodes_real t26 = g_x*m_lift_2;
    const pkmodes_real t27 = g_x*m_lift_3;
    const pkmodes_real t28 = g_x*m_lift_4;
    const pkmodes_real t29 = g_x*m_lift_5;
    const pkmodes_real t30 = g_x*m_lift_6;
    const pkmodes_real t31 = g_x*m_p;
    const pkmodes_real G_p_x = -t25 - t26 - t27 - t28 - t29 - t30 - t31;
    const pkmodes_real t32 = g_y*m_lift_1;
    const pkmodes_real t33 = g_y*m_lift_2;
    const pkmodes_real t34 = g_y*m_lift_3;
    const pkmodes_real t35 = g_y*m_lift_4;
    const pkmodes_real t36 = g_y*m_lift_5;
    const pkmodes_real t37 = g_y*m_lift_6;
    const pkmodes_real t38 = g_y*m_p;
    const pkmodes_real G_p_y = -t32 - t33 - t34 - t35 - t36 - t37 - t38;
    const pkmodes_real t39 = g_z*m_lift_1;
    const pkmodes_real t40 = g_z*m_lift_2;
    const pkmodes_real t41 = g_z*m_lift_3;
    const pkmodes_real t42 = g_z*m_lift_4;
    const pkmodes_real t43 = g_z*m_lift_5;
    const pkmodes_real t44 = g_z*m_lift_6;
    const pkmodes_real t45 = g_z*m_p;
    const pkmodes_real G_p_z = -t39 - t40 - t41 - t42 - t43 - t44 - t45;
    const pkmodes_real G_p_rx =
        -B_1_y*t39 + B_1_z*g_y*m_lift_1 - B_2_y*t40 + B_2_z*g_y*m_lift_2 - B_3_y*t41 + B_3_z*g_y*m_lift_3
        - B_4_y*t42 + B_4_z*g_y*m_lift_4 - B_5_y*t43 + B_5_z*g_y*m_lift_5 - B_6_y*t44 + B_6_z*g_y*m_lift_6
        - c_y*t45 + c_z*g_y*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t39 - B_1_z*t25 + B_2_x*t40 - B_2_z*t26 + B_3_x*t41 - B_3_z*t27 + B_4_x*t42 - B_4_z*t28
        + B_5_x*t43 - B_5_z*t29 + B_6_x*t44 - B_6_z*t30 + c_x*t45 - c_z*t31;
    const pkmodes_real G_p_rz =
        -B_1_x*t32 + B_1_y*g_x*m_lift_1 - B_2_x*t33 + B_2_y*g_x*m_lift_2 - B_3_x*t34 + B_3_y*g_x*m_lift_3
        - B_4_x*t35 + B_4_y*g_x*m_lift_4 - B_5_x*t36 + B_5_y*g_x*m_lift_5 - B_6_x*t37 + B_6_y*g_x*m_lift_6
        - c_x*t38 + c_y*g_x*m_p;
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
    const pkmodes_real s_1_st = G_1/k_l_1;
    const pkmodes_real s_2_st = G_2/k_l_2;
    const pkmodes_real s_3_st = G_3/k_l_3;
    const pkmodes_real s_4_st = G_4/k_l_4;
    const pkmodes_real s_5_st = G_5/k_l_5;
    const pkmodes_real s_6_st = G_6/k_l_6;
    const pkmodes_real f_st_1 = k_l_1*s_1_st;
    const pkmodes_real f_st_2 = k_l_2*s_2_st;
    const pkmodes_real f_st_3 = k_l_3*s_3_st;
    const pkmodes_real f_st_4 = k_l_4*s_4_st;
    const pkmodes_real f_st_5 = k_l_5*s_5_st;
    const pkmodes_real f_st_6 = k_l_6*s_6_st;
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

void hexapod_stiffness_matrix(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real K[12][12])
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
    const pkmodes_real t25 = g_x*m_lift_1;
    const pkmodes_real t26 = g_x*m_lift_2;
    const pkmodes_real t27 = g_x*m_lift_3;
    const pkmodes_real t28 = g_x*m_lift_4;
    const pkmodes_real t29 = g_x*m_lift_5;
    const pkmodes_real t30 = g_x*m_lift_6;
    const pkmodes_real t31 = g_x*m_p;
    const pkmodes_real G_p_x = -t25 - t26 - t27 - t28 - t29 - t30 - t31;
    const pkmodes_real t32 = g_y*m_lift_1;
    const pkmodes_real t33 = g_y*m_lift_2;
    const pkmodes_real t34 = g_y*m_lift_3;
    const pkmodes_real t35 = g_y*m_lift_4;
    const pkmodes_real t36 = g_y*m_lift_5;
    const pkmodes_real t37 = g_y*m_lift_6;
    const pkmodes_real t38 = g_y*m_p;
    const pkmodes_real G_p_y = -t32 - t33 - t34 - t35 - t36 - t37 - t38;
    const pkmodes_real t39 = g_z*m_lift_1;
    const pkmodes_real t40 = g_z*m_lift_2;
    const pkmodes_real t41 = g_z*m_lift_3;
    const pkmodes_real t42 = g_z*m_lift_4;
    const pkmodes_real t43 = g_z*m_lift_5;
    const pkmodes_real t44 = g_z*m_lift_6;
    const pkmodes_real t45 = g_z*m_p;
    const pkmodes_real G_p_z = -t39 - t40 - t41 - t42 - t43 - t44 - t45;
    const pkmodes_real G_p_rx =
        -B_1_y*t39 + B_1_z*g_y*m_lift_1 - B_2_y*t40 + B_2_z*g_y*m_lift_2 - B_3_y*t41 + B_3_z*g_y*m_lift_3
        - B_4_y*t42 + B_4_z*g_y*m_lift_4 - B_5_y*t43 + B_5_z*g_y*m_lift_5 - B_6_y*t44 + B_6_z*g_y*m_lift_6
        - c_y*t45 + c_z*g_y*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t39 - B_1_z*t25 + B_2_x*t40 - B_2_z*t26 + B_3_x*t41 - B_3_z*t27 + B_4_x*t42 - B_4_z*t28
        + B_5_x*t43 - B_5_z*t29 + B_6_x*t44 - B_6_z*t30 + c_x*t45 - c_z*t31;
    const pkmodes_real G_p_rz =
        -B_1_x*t32 + B_1_y*g_x*m_lift_1 - B_2_x*t33 + B_2_y*g_x*m_lift_2 - B_3_x*t34 + B_3_y*g_x*m_lift_3
        - B_4_x*t35 + B_4_y*g_x*m_lift_4 - B_5_x*t36 + B_5_y*g_x*m_lift_5 - B_6_x*t37 + B_6_y*g_x*m_lift_6
        - c_x*t38 + c_y*g_x*m_p;
    const pkmodes_real mu_1 =
        t18*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const pkmodes_real mu_2 =
        t18*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const pkmodes_real mu_3 =
        t18*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const pkmodes_real mu_4 =
        t18*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const pkmodes_real mu_5 =
        t18*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const pkmodes_real mu_6 =
        t18*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const pkmodes_real g_4_x = -d_1_x*mu_1 - t25;
    const pkmodes_real g_4_y = -d_1_y*mu_1 - t32;
    const pkmodes_real g_4_z = -d_1_z*mu_1 - t39;
    const pkmodes_real g_5_x = -d_2_x*mu_2 - t26;
    const pkmodes_real g_5_y = -d_2_y*mu_2 - t33;
    const pkmodes_real g_5_z = -d_2_z*mu_2 - t40;
    const pkmodes_real g_6_x = -d_3_x*mu_3 - t27;
    const pkmodes_real g_6_y = -d_3_y*mu_3 - t34;
    const pkmodes_real g_6_z = -d_3_z*mu_3 - t41;
    const pkmodes_real g_7_x = -d_4_x*mu_4 - t28;
    const pkmodes_real g_7_y = -d_4_y*mu_4 - t35;
    const pkmodes_real g_7_z = -d_4_z*mu_4 - t42;
    const pkmodes_real g_8_x = -d_5_x*mu_5 - t29;
    const pkmodes_real g_8_y = -d_5_y*mu_5 - t36;
    const pkmodes_real g_8_z = -d_5_z*mu_5 - t43;
    const pkmodes_real g_9_x = -d_6_x*mu_6 - t30;
    const pkmodes_real g_9_y = -d_6_y*mu_6 - t37;
    const pkmodes_real g_9_z = -d_6_z*mu_6 - t44;
    const pkmodes_real g_10_x = -t31;
    const pkmodes_real g_10_y = -t38;
    const pkmodes_real g_10_z = -t45;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t46 = B_1_z*mu_1;
    const pkmodes_real t47 = B_2_z*mu_2;
    const pkmodes_real t48 = B_3_z*mu_3;
    const pkmodes_real t49 = B_4_z*mu_4;
    const pkmodes_real t50 = B_5_z*mu_5;
    const pkmodes_real t51 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t46 + t47 + t48 + t49 + t50 + t51;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t52 = B_1_y*mu_1;
    const pkmodes_real t53 = B_2_y*mu_2;
    const pkmodes_real t54 = B_3_y*mu_3;
    const pkmodes_real t55 = B_4_y*mu_4;
    const pkmodes_real t56 = B_5_y*mu_5;
    const pkmodes_real t57 = B_6_y*mu_6;
    const pkmodes_real L_x_rz = t52 + t53 + t54 + t55 + t56 + t57;
    const pkmodes_real L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t58 =
        (B_1_z*B_1_z)*mu_1 + B_1_z*g_4_z + (B_2_z*B_2_z)*mu_2 + B_2_z*g_5_z + (B_3_z*B_3_z)*mu_3
        + B_3_z*g_6_z + (B_4_z*B_4_z)*mu_4 + B_4_z*g_7_z + (B_5_z*B_5_z)*mu_5 + B_5_z*g_8_z
        + (B_6_z*B_6_z)*mu_6 + B_6_z*g_9_z + c_z*g_10_z;
    const pkmodes_real t59 =
        (B_1_y*B_1_y)*mu_1 + B_1_y*g_4_y + (B_2_y*B_2_y)*mu_2 + B_2_y*g_5_y + (B_3_y*B_3_y)*mu_3
        + B_3_y*g_6_y + (B_4_y*B_4_y)*mu_4 + B_4_y*g_7_y + (B_5_y*B_5_y)*mu_5 + B_5_y*g_8_y
        + (B_6_y*B_6_y)*mu_6 + B_6_y*g_9_y + c_y*g_10_y;
    const pkmodes_real L_rx_rx = -t58 - t59;
    const pkmodes_real t60 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t61 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t62 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t63 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t64 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t65 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t66 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t67 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t68 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t69 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t70 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t71 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real t72 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t73 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t52 + B_1_y*t61 + B_2_x*t53 + B_2_y*t63 + B_3_x*t54 + B_3_y*t65 + B_4_x*t55 + B_4_y*t67
        + B_5_x*t56 + B_5_y*t69 + B_6_x*t57 + B_6_y*t71 + c_y*t73 + g_10_y*t72 + g_4_y*t60 + g_5_y*t62
        + g_6_y*t64 + g_7_y*t66 + g_8_y*t68 + g_9_y*t70;
    const pkmodes_real L_rx_rz =
        B_1_x*t46 + B_1_z*t61 + B_2_x*t47 + B_2_z*t63 + B_3_x*t48 + B_3_z*t65 + B_4_x*t49 + B_4_z*t67
        + B_5_x*t50 + B_5_z*t69 + B_6_x*t51 + B_6_z*t71 + c_z*t73 + g_10_z*t72 + g_4_z*t60 + g_5_z*t62
        + g_6_z*t64 + g_7_z*t66 + g_8_z*t68 + g_9_z*t70;
    const pkmodes_real t74 =
        (B_1_x*B_1_x)*mu_1 + B_1_x*g_4_x + (B_2_x*B_2_x)*mu_2 + B_2_x*g_5_x + (B_3_x*B_3_x)*mu_3
        + B_3_x*g_6_x + (B_4_x*B_4_x)*mu_4 + B_4_x*g_7_x + (B_5_x*B_5_x)*mu_5 + B_5_x*g_8_x
        + (B_6_x*B_6_x)*mu_6 + B_6_x*g_9_x + c_x*g_10_x;
    const pkmodes_real L_ry_ry = -t58 - t74;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t46 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t47 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t48
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t49 + (R(1.0)/R(2.0))*B_4_z*g_7_y
        + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t50 + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z
        + B_6_y*t51 + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y;
    const pkmodes_real L_rz_rz = -t59 - t74;
    const pkmodes_real t75 = t12/(l_1*l_1);
    const pkmodes_real t76 = g_x*t75;
    const pkmodes_real f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t76;
    const pkmodes_real t77 = t13/(l_2*l_2);
    const pkmodes_real t78 = g_x*t77;
    const pkmodes_real f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t78;
    const pkmodes_real t79 = t14/(l_3*l_3);
    const pkmodes_real t80 = g_x*t79;
    const pkmodes_real f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t80;
    const pkmodes_real t81 = t15/(l_4*l_4);
    const pkmodes_real t82 = g_x*t81;
    const pkmodes_real f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t82;
    const pkmodes_real t83 = t16/(l_5*l_5);
    const pkmodes_real t84 = g_x*t83;
    const pkmodes_real f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t84;
    const pkmodes_real t85 = t17/(l_6*l_6);
    const pkmodes_real t86 = g_x*t85;
    const pkmodes_real f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t86;
    const pkmodes_real t87 = g_y*t75;
    const pkmodes_real f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t87;
    const pkmodes_real t88 = g_y*t77;
    const pkmodes_real f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t88;
    const pkmodes_real t89 = g_y*t79;
    const pkmodes_real f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t89;
    const pkmodes_real t90 = g_y*t81;
    const pkmodes_real f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t90;
    const pkmodes_real t91 = g_y*t83;
    const pkmodes_real f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t91;
    const pkmodes_real t92 = g_y*t85;
    const pkmodes_real f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t92;
    const pkmodes_real t93 = g_z*t75;
    const pkmodes_real f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t93;
    const pkmodes_real t94 = g_z*t77;
    const pkmodes_real f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t94;
    const pkmodes_real t95 = g_z*t79;
    const pkmodes_real f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t95;
    const pkmodes_real t96 = g_z*t81;
    const pkmodes_real f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t96;
    const pkmodes_real t97 = g_z*t83;
    const pkmodes_real f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t97;
    const pkmodes_real t98 = g_z*t85;
    const pkmodes_real f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t98;
    const pkmodes_real t99 = t75*(-B_1_y*g_z + B_1_z*g_y);
    const pkmodes_real f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx - t99;
    const pkmodes_real t100 = t77*(-B_2_y*g_z + B_2_z*g_y);
    const pkmodes_real f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx - t100;
    const pkmodes_real t101 = t79*(-B_3_y*g_z + B_3_z*g_y);
    const pkmodes_real f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx - t101;
    const pkmodes_real t102 = t81*(-B_4_y*g_z + B_4_z*g_y);
    const pkmodes_real f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx - t102;
    const pkmodes_real t103 = t83*(-B_5_y*g_z + B_5_z*g_y);
    const pkmodes_real f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx - t103;
    const pkmodes_real t104 = t85*(-B_6_y*g_z + B_6_z*g_y);
    const pkmodes_real f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx - t104;
    const pkmodes_real t105 = t75*(B_1_x*g_z - B_1_z*g_x);
    const pkmodes_real f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry - t105;
    const pkmodes_real t106 = t77*(B_2_x*g_z - B_2_z*g_x);
    const pkmodes_real f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry - t106;
    const pkmodes_real t107 = t79*(B_3_x*g_z - B_3_z*g_x);
    const pkmodes_real f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry - t107;
    const pkmodes_real t108 = t81*(B_4_x*g_z - B_4_z*g_x);
    const pkmodes_real f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry - t108;
    const pkmodes_real t109 = t83*(B_5_x*g_z - B_5_z*g_x);
    const pkmodes_real f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry - t109;
    const pkmodes_real t110 = t85*(B_6_x*g_z - B_6_z*g_x);
    const pkmodes_real f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry - t110;
    const pkmodes_real t111 = t75*(-B_1_x*g_y + B_1_y*g_x);
    const pkmodes_real f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz - t111;
    const pkmodes_real t112 = t77*(-B_2_x*g_y + B_2_y*g_x);
    const pkmodes_real f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz - t112;
    const pkmodes_real t113 = t79*(-B_3_x*g_y + B_3_y*g_x);
    const pkmodes_real f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz - t113;
    const pkmodes_real t114 = t81*(-B_4_x*g_y + B_4_y*g_x);
    const pkmodes_real f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz - t114;
    const pkmodes_real t115 = t83*(-B_5_x*g_y + B_5_y*g_x);
    const pkmodes_real f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz - t115;
    const pkmodes_real t116 = t85*(-B_6_x*g_y + B_6_y*g_x);
    const pkmodes_real f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz - t116;
    memset(K, 0, sizeof(pkmodes_real[12][12]));
    K[0][0] =
        D_p_rx_1*f_rx_l_1 - D_p_rx_1*t99 + D_p_ry_1*f_ry_l_1 - D_p_ry_1*t105 + D_p_rz_1*f_rz_l_1
        - D_p_rz_1*t111 + D_p_x_1*f_x_l_1 + D_p_x_1*t76 + D_p_y_1*f_y_l_1 + D_p_y_1*t87 + D_p_z_1*f_z_l_1
        + D_p_z_1*t93 + k_l_1 + mu_1 + 2*t12*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1*l_1);
    K[0][1] = K[1][0] =
        D_p_rx_1*f_rx_l_2 - D_p_rx_2*t99 + D_p_ry_1*f_ry_l_2 - D_p_ry_2*t105 + D_p_rz_1*f_rz_l_2
        - D_p_rz_2*t111 + D_p_x_1*f_x_l_2 + D_p_x_2*t76 + D_p_y_1*f_y_l_2 + D_p_y_2*t87 + D_p_z_1*f_z_l_2
        + D_p_z_2*t93;
    K[0][2] = K[2][0] =
        D_p_rx_1*f_rx_l_3 - D_p_rx_3*t99 + D_p_ry_1*f_ry_l_3 - D_p_ry_3*t105 + D_p_rz_1*f_rz_l_3
        - D_p_rz_3*t111 + D_p_x_1*f_x_l_3 + D_p_x_3*t76 + D_p_y_1*f_y_l_3 + D_p_y_3*t87 + D_p_z_1*f_z_l_3
        + D_p_z_3*t93;
    K[0][3] = K[3][0] =
        D_p_rx_1*f_rx_l_4 - D_p_rx_4*t99 + D_p_ry_1*f_ry_l_4 - D_p_ry_4*t105 + D_p_rz_1*f_rz_l_4
        - D_p_rz_4*t111 + D_p_x_1*f_x_l_4 + D_p_x_4*t76 + D_p_y_1*f_y_l_4 + D_p_y_4*t87 + D_p_z_1*f_z_l_4
        + D_p_z_4*t93;
    K[0][4] = K[4][0] =
        D_p_rx_1*f_rx_l_5 - D_p_rx_5*t99 + D_p_ry_1*f_ry_l_5 - D_p_ry_5*t105 + D_p_rz_1*f_rz_l_5
        - D_p_rz_5*t111 + D_p_x_1*f_x_l_5 + D_p_x_5*t76 + D_p_y_1*f_y_l_5 + D_p_y_5*t87 + D_p_z_1*f_z_l_5
        + D_p_z_5*t93;
    K[0][5] = K[5][0] =
        D_p_rx_1*f_rx_l_6 - D_p_rx_6*t99 + D_p_ry_1*f_ry_l_6 - D_p_ry_6*t105 + D_p_rz_1*f_rz_l_6
        - D_p_rz_6*t111 + D_p_x_1*f_x_l_6 + D_p_x_6*t76 + D_p_y_1*f_y_l_6 + D_p_y_6*t87 + D_p_z_1*f_z_l_6
        + D_p_z_6*t93;
    K[0][6] = K[6][0] = -k_l_1;
    K[1][1] =
        D_p_rx_2*f_rx_l_2 - D_p_rx_2*t100 + D_p_ry_2*f_ry_l_2 - D_p_ry_2*t106 + D_p_rz_2*f_rz_l_2
        - D_p_rz_2*t112 + D_p_x_2*f_x_l_2 + D_p_x_2*t78 + D_p_y_2*f_y_l_2 + D_p_y_2*t88 + D_p_z_2*f_z_l_2
        + D_p_z_2*t94 + k_l_2 + mu_2 + 2*t13*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2*l_2);
    K[1][2] = K[2][1] =
        D_p_rx_2*f_rx_l_3 - D_p_rx_3*t100 + D_p_ry_2*f_ry_l_3 - D_p_ry_3*t106 + D_p_rz_2*f_rz_l_3
        - D_p_rz_3*t112 + D_p_x_2*f_x_l_3 + D_p_x_3*t78 + D_p_y_2*f_y_l_3 + D_p_y_3*t88 + D_p_z_2*f_z_l_3
        + D_p_z_3*t94;
    K[1][3] = K[3][1] =
        D_p_rx_2*f_rx_l_4 - D_p_rx_4*t100 + D_p_ry_2*f_ry_l_4 - D_p_ry_4*t106 + D_p_rz_2*f_rz_l_4
        - D_p_rz_4*t112 + D_p_x_2*f_x_l_4 + D_p_x_4*t78 + D_p_y_2*f_y_l_4 + D_p_y_4*t88 + D_p_z_2*f_z_l_4
        + D_p_z_4*t94;
    K[1][4] = K[4][1] =
        D_p_rx_2*f_rx_l_5 - D_p_rx_5*t100 + D_p_ry_2*f_ry_l_5 - D_p_ry_5*t106 + D_p_rz_2*f_rz_l_5
        - D_p_rz_5*t112 + D_p_x_2*f_x_l_5 + D_p_x_5*t78 + D_p_y_2*f_y_l_5 + D_p_y_5*t88 + D_p_z_2*f_z_l_5
        + D_p_z_5*t94;
    K[1][5] = K[5][1] =
        D_p_rx_2*f_rx_l_6 - D_p_rx_6*t100 + D_p_ry_2*f_ry_l_6 - D_p_ry_6*t106 + D_p_rz_2*f_rz_l_6
        - D_p_rz_6*t112 + D_p_x_2*f_x_l_6 + D_p_x_6*t78 + D_p_y_2*f_y_l_6 + D_p_y_6*t88 + D_p_z_2*f_z_l_6
        + D_p_z_6*t94;
    K[1][7] = K[7][1] = -k_l_2;
    K[2][2] =
        D_p_rx_3*f_rx_l_3 - D_p_rx_3*t101 + D_p_ry_3*f_ry_l_3 - D_p_ry_3*t107 + D_p_rz_3*f_rz_l_3
        - D_p_rz_3*t113 + D_p_x_3*f_x_l_3 + D_p_x_3*t80 + D_p_y_3*f_y_l_3 + D_p_y_3*t89 + D_p_z_3*f_z_l_3
        + D_p_z_3*t95 + k_l_3 + mu_3 + 2*t14*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3*l_3);
    K[2][3] = K[3][2] =
        D_p_rx_3*f_rx_l_4 - D_p_rx_4*t101 + D_p_ry_3*f_ry_l_4 - D_p_ry_4*t107 + D_p_rz_3*f_rz_l_4
        - D_p_rz_4*t113 + D_p_x_3*f_x_l_4 + D_p_x_4*t80 + D_p_y_3*f_y_l_4 + D_p_y_4*t89 + D_p_z_3*f_z_l_4
        + D_p_z_4*t95;
    K[2][4] = K[4][2] =
        D_p_rx_3*f_rx_l_5 - D_p_rx_5*t101 + D_p_ry_3*f_ry_l_5 - D_p_ry_5*t107 + D_p_rz_3*f_rz_l_5
        - D_p_rz_5*t113 + D_p_x_3*f_x_l_5 + D_p_x_5*t80 + D_p_y_3*f_y_l_5 + D_p_y_5*t89 + D_p_z_3*f_z_l_5
        + D_p_z_5*t95;
    K[2][5] = K[5][2] =
        D_p_rx_3*f_rx_l_6 - D_p_rx_6*t101 + D_p_ry_3*f_ry_l_6 - D_p_ry_6*t107 + D_p_rz_3*f_rz_l_6
        - D_p_rz_6*t113 + D_p_x_3*f_x_l_6 + D_p_x_6*t80 + D_p_y_3*f_y_l_6 + D_p_y_6*t89 + D_p_z_3*f_z_l_6
        + D_p_z_6*t95;
    K[2][8] = K[8][2] = -k_l_3;
    K[3][3] =
        D_p_rx_4*f_rx_l_4 - D_p_rx_4*t102 + D_p_ry_4*f_ry_l_4 - D_p_ry_4*t108 + D_p_rz_4*f_rz_l_4
        - D_p_rz_4*t114 + D_p_x_4*f_x_l_4 + D_p_x_4*t82 + D_p_y_4*f_y_l_4 + D_p_y_4*t90 + D_p_z_4*f_z_l_4
        + D_p_z_4*t96 + k_l_4 + mu_4 + 2*t15*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4*l_4);
    K[3][4] = K[4][3] =
        D_p_rx_4*f_rx_l_5 - D_p_rx_5*t102 + D_p_ry_4*f_ry_l_5 - D_p_ry_5*t108 + D_p_rz_4*f_rz_l_5
        - D_p_rz_5*t114 + D_p_x_4*f_x_l_5 + D_p_x_5*t82 + D_p_y_4*f_y_l_5 + D_p_y_5*t90 + D_p_z_4*f_z_l_5
        + D_p_z_5*t96;
    K[3][5] = K[5][3] =
        D_p_rx_4*f_rx_l_6 - D_p_rx_6*t102 + D_p_ry_4*f_ry_l_6 - D_p_ry_6*t108 + D_p_rz_4*f_rz_l_6
        - D_p_rz_6*t114 + D_p_x_4*f_x_l_6 + D_p_x_6*t82 + D_p_y_4*f_y_l_6 + D_p_y_6*t90 + D_p_z_4*f_z_l_6
        + D_p_z_6*t96;
    K[3][9] = K[9][3] = -k_l_4;
    K[4][4] =
        D_p_rx_5*f_rx_l_5 - D_p_rx_5*t103 + D_p_ry_5*f_ry_l_5 - D_p_ry_5*t109 + D_p_rz_5*f_rz_l_5
        - D_p_rz_5*t115 + D_p_x_5*f_x_l_5 + D_p_x_5*t84 + D_p_y_5*f_y_l_5 + D_p_y_5*t91 + D_p_z_5*f_z_l_5
        + D_p_z_5*t97 + k_l_5 + mu_5 + 2*t16*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5*l_5);
    K[4][5] = K[5][4] =
        D_p_rx_5*f_rx_l_6 - D_p_rx_6*t103 + D_p_ry_5*f_ry_l_6 - D_p_ry_6*t109 + D_p_rz_5*f_rz_l_6
        - D_p_rz_6*t115 + D_p_x_5*f_x_l_6 + D_p_x_6*t84 + D_p_y_5*f_y_l_6 + D_p_y_6*t91 + D_p_z_5*f_z_l_6
        + D_p_z_6*t97;
    K[4][10] = K[10][4] = -k_l_5;
    K[5][5] =
        D_p_rx_6*f_rx_l_6 - D_p_rx_6*t104 + D_p_ry_6*f_ry_l_6 - D_p_ry_6*t110 + D_p_rz_6*f_rz_l_6
        - D_p_rz_6*t116 + D_p_x_6*f_x_l_6 + D_p_x_6*t86 + D_p_y_6*f_y_l_6 + D_p_y_6*t92 + D_p_z_6*f_z_l_6
        + D_p_z_6*t98 + k_l_6 + mu_6 + 2*t17*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6*l_6);
    K[5][11] = K[11][5] = -k_l_6;
    K[6][6] = k_l_1;
    K[7][7] = k_l_2;
    K[8][8] = k_l_3;
    K[9][9] = k_l_4;
    K[10][10] = k_l_5;
    K[11][11] = k_l_6;
}

void hexapod_modal_matrices(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real M[12][12], pkmodes_real K[12][12])
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
    const pkmodes_real m_lift_1 = m_r_1 + t31*t32;
    const pkmodes_real t33 = 1/((l_2*l_2));
    const pkmodes_real t34 = 1/l_2;
    const pkmodes_real m_perp_2 =
        I_b_2*t33 + I_r_2*t33 + (c_b_2*c_b_2)*m_b_2*t33 + m_r_2*((-c_r_2*t34 + 1)*(-c_r_2*t34 + 1));
    const pkmodes_real t35 = c_b_2*m_b_2 - c_r_2*m_r_2;
    const pkmodes_real m_lift_2 = m_r_2 + t34*t35;
    const pkmodes_real t36 = 1/((l_3*l_3));
    const pkmodes_real t37 = 1/l_3;
    const pkmodes_real m_perp_3 =
        I_b_3*t36 + I_r_3*t36 + (c_b_3*c_b_3)*m_b_3*t36 + m_r_3*((-c_r_3*t37 + 1)*(-c_r_3*t37 + 1));
    const pkmodes_real t38 = c_b_3*m_b_3 - c_r_3*m_r_3;
    const pkmodes_real m_lift_3 = m_r_3 + t37*t38;
    const pkmodes_real t39 = 1/((l_4*l_4));
    const pkmodes_real t40 = 1/l_4;
    const pkmodes_real m_perp_4 =
        I_b_4*t39 + I_r_4*t39 + (c_b_4*c_b_4)*m_b_4*t39 + m_r_4*((-c_r_4*t40 + 1)*(-c_r_4*t40 + 1));
    const pkmodes_real t41 = c_b_4*m_b_4 - c_r_4*m_r_4;
    const pkmodes_real m_lift_4 = m_r_4 + t40*t41;
    const pkmodes_real t42 = 1/((l_5*l_5));
    const pkmodes_real t43 = 1/l_5;
    const pkmodes_real m_perp_5 =
        I_b_5*t42 + I_r_5*t42 + (c_b_5*c_b_5)*m_b_5*t42 + m_r_5*((-c_r_5*t43 + 1)*(-c_r_5*t43 + 1));
    const pkmodes_real t44 = c_b_5*m_b_5 - c_r_5*m_r_5;
    const pkmodes_real m_lift_5 = m_r_5 + t43*t44;
    const pkmodes_real t45 = 1/((l_6*l_6));
    const pkmodes_real t46 = 1/l_6;
    const pkmodes_real m_perp_6 =
        I_b_6*t45 + I_r_6*t45 + (c_b_6*c_b_6)*m_b_6*t45 + m_r_6*((-c_r_6*t46 + 1)*(-c_r_6*t46 + 1));
    const pkmodes_real t47 = c_b_6*m_b_6 - c_r_6*m_r_6;
    const pkmodes_real m_lift_6 = m_r_6 + t46*t47;
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
    const pkmodes_real t48 = 1/det_D_l;
    const pkmodes_real t49 = l_1*t48;
    const pkmodes_real D_p_x_1 = A_x_1*t49;
    const pkmodes_real t50 = l_2*t48;
    const pkmodes_real D_p_x_2 = A_x_2*t50;
    const pkmodes_real t51 = l_3*t48;
    const pkmodes_real D_p_x_3 = A_x_3*t51;
    const pkmodes_real t52 = l_4*t48;
    const pkmodes_real D_p_x_4 = A_x_4*t52;
    const pkmodes_real t53 = l_5*t48;
    const pkmodes_real D_p_x_5 = A_x_5*t53;
    const pkmodes_real t54 = l_6*t48;
    const pkmodes_real D_p_x_6 = A_x_6*t54;
    const pkmodes_real D_p_y_1 = A_y_1*t49;
    const pkmodes_real D_p_y_2 = A_y_2*t50;
    const pkmodes_real D_p_y_3 = A_y_3*t51;
    const pkmodes_real D_p_y_4 = A_y_4*t52;
    const pkmodes_real D_p_y_5 = A_y_5*t53;
    const pkmodes_real D_p_y_6 = A_y_6*t54;
    const pkmodes_real D_p_z_1 = A_z_1*t49;
    const pkmodes_real D_p_z_2 = A_z_2*t50;
    const pkmodes_real D_p_z_3 = A_z_3*t51;
    const pkmodes_real D_p_z_4 = A_z_4*t52;
    const pkmodes_real D_p_z_5 = A_z_5*t53;
    const pkmodes_real D_p_z_6 = A_z_6*t54;
    const pkmodes_real D_p_rx_1 = A_rx_1*t49;
    const pkmodes_real D_p_rx_2 = A_rx_2*t50;
    const pkmodes_real D_p_rx_3 = A_rx_3*t51;
    const pkmodes_real D_p_rx_4 = A_rx_4*t52;
    const pkmodes_real D_p_rx_5 = A_rx_5*t53;
    const pkmodes_real D_p_rx_6 = A_rx_6*t54;
    const pkmodes_real D_p_ry_1 = A_ry_1*t49;
    const pkmodes_real D_p_ry_2 = A_ry_2*t50;
    const pkmodes_real D_p_ry_3 = A_ry_3*t51;
    const pkmodes_real D_p_ry_4 = A_ry_4*t52;
    const pkmodes_real D_p_ry_5 = A_ry_5*t53;
    const pkmodes_real D_p_ry_6 = A_ry_6*t54;
    const pkmodes_real D_p_rz_1 = A_rz_1*t49;
    const pkmodes_real D_p_rz_2 = A_rz_2*t50;
    const pkmodes_real D_p_rz_3 = A_rz_3*t51;
    const pkmodes_real D_p_rz_4 = A_rz_4*t52;
    const pkmodes_real D_p_rz_5 = A_rz_5*t53;
    const pkmodes_real D_p_rz_6 = A_rz_6*t54;
    const pkmodes_real t55 = g_x*m_lift_1;
    const pkmodes_real t56 = g_x*m_lift_2;
    const pkmodes_real t57 = g_x*m_lift_3;
    const pkmodes_real t58 = g_x*m_lift_4;
    const pkmodes_real t59 = g_x*m_lift_5;
    const pkmodes_real t60 = g_x*m_lift_6;
    const pkmodes_real t61 = g_x*m_p;
    const pkmodes_real G_p_x = -t55 - t56 - t57 - t58 - t59 - t60 - t61;
    const pkmodes_real t62 = g_y*m_lift_1;
    const pkmodes_real t63 = g_y*m_lift_2;
    const pkmodes_real t64 = g_y*m_lift_3;
    const pkmodes_real t65 = g_y*m_lift_4;
    const pkmodes_real t66 = g_y*m_lift_5;
    const pkmodes_real t67 = g_y*m_lift_6;
    const pkmodes_real t68 = g_y*m_p;
    const pkmodes_real G_p_y = -t62 - t63 - t64 - t65 - t66 - t67 - t68;
    const pkmodes_real t69 = g_z*m_lift_1;
    const pkmodes_real t70 = g_z*m_lift_2;
    const pkmodes_real t71 = g_z*m_lift_3;
    const pkmodes_real t72 = g_z*m_lift_4;
    const pkmodes_real t73 = g_z*m_lift_5;
    const pkmodes_real t74 = g_z*m_lift_6;
    const pkmodes_real t75 = g_z*m_p;
    const pkmodes_real G_p_z = -t69 - t70 - t71 - t72 - t73 - t74 - t75;
    const pkmodes_real G_p_rx =
        -B_1_y*t69 + B_1_z*g_y*m_lift_1 - B_2_y*t70 + B_2_z*g_y*m_lift_2 - B_3_y*t71 + B_3_z*g_y*m_lift_3
        - B_4_y*t72 + B_4_z*g_y*m_lift_4 - B_5_y*t73 + B_5_z*g_y*m_lift_5 - B_6_y*t74 + B_6_z*g_y*m_lift_6
        - c_y*t75 + c_z*g_y*m_p;
    const pkmodes_real G_p_ry =
        B_1_x*t69 - B_1_z*t55 + B_2_x*t70 - B_2_z*t56 + B_3_x*t71 - B_3_z*t57 + B_4_x*t72 - B_4_z*t58
        + B_5_x*t73 - B_5_z*t59 + B_6_x*t74 - B_6_z*t60 + c_x*t75 - c_z*t61;
    const pkmodes_real G_p_rz =
        -B_1_x*t62 + B_1_y*g_x*m_lift_1 - B_2_x*t63 + B_2_y*g_x*m_lift_2 - B_3_x*t64 + B_3_y*g_x*m_lift_3
        - B_4_x*t65 + B_4_y*g_x*m_lift_4 - B_5_x*t66 + B_5_y*g_x*m_lift_5 - B_6_x*t67 + B_6_y*g_x*m_lift_6
        - c_x*t68 + c_y*g_x*m_p;
    const pkmodes_real mu_1 =
        t48*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const pkmodes_real mu_2 =
        t48*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const pkmodes_real mu_3 =
        t48*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const pkmodes_real mu_4 =
        t48*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const pkmodes_real mu_5 =
        t48*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const pkmodes_real mu_6 =
        t48*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const pkmodes_real g_4_x = -d_1_x*mu_1 - t55;
    const pkmodes_real g_4_y = -d_1_y*mu_1 - t62;
    const pkmodes_real g_4_z = -d_1_z*mu_1 - t69;
    const pkmodes_real g_5_x = -d_2_x*mu_2 - t56;
    const pkmodes_real g_5_y = -d_2_y*mu_2 - t63;
    const pkmodes_real g_5_z = -d_2_z*mu_2 - t70;
    const pkmodes_real g_6_x = -d_3_x*mu_3 - t57;
    const pkmodes_real g_6_y = -d_3_y*mu_3 - t64;
    const pkmodes_real g_6_z = -d_3_z*mu_3 - t71;
    const pkmodes_real g_7_x = -d_4_x*mu_4 - t58;
    const pkmodes_real g_7_y = -d_4_y*mu_4 - t65;
    const pkmodes_real g_7_z = -d_4_z*mu_4 - t72;
    const pkmodes_real g_8_x = -d_5_x*mu_5 - t59;
    const pkmodes_real g_8_y = -d_5_y*mu_5 - t66;
    const pkmodes_real g_8_z = -d_5_z*mu_5 - t73;
    const pkmodes_real g_9_x = -d_6_x*mu_6 - t60;
    const pkmodes_real g_9_y = -d_6_y*mu_6 - t67;
    const pkmodes_real g_9_z = -d_6_z*mu_6 - t74;
    const pkmodes_real g_10_x = -t61;
    const pkmodes_real g_10_y = -t68;
    const pkmodes_real g_10_z = -t75;
    const pkmodes_real L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const pkmodes_real t76 = B_1_z*mu_1;
    const pkmodes_real t77 = B_2_z*mu_2;
    const pkmodes_real t78 = B_3_z*mu_3;
    const pkmodes_real t79 = B_4_z*mu_4;
    const pkmodes_real t80 = B_5_z*mu_5;
    const pkmodes_real t81 = B_6_z*mu_6;
    const pkmodes_real L_y_rx = t76 + t77 + t78 + t79 + t80 + t81;
    const pkmodes_real L_x_ry = -L_y_rx;
    const pkmodes_real t82 = B_1_y*mu_1;
    const pkmodes_real t83 = B_2_y*mu_2;
    const pkmodes_real t84 = B_3_y*mu_3;
    const pkmodes_real t85 = B_4_y*mu_4;
    const pkmodes_real t86 = B_5_y*mu_5;
    const pkmodes_real t87 = B_6_y*mu_6;
    const pkmodes_real L_x_rz = t82 + t83 + t84 + t85 + t86 + t87;
    const pkmodes_real L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const pkmodes_real L_y_rz = -L_z_ry;
    const pkmodes_real L_z_rx = -L_x_rz;
    const pkmodes_real t88 = (B_3_y*B_3_y);
    const pkmodes_real t89 = (B_4_y*B_4_y);
    const pkmodes_real t90 = (B_5_y*B_5_y);
    const pkmodes_real t91 = (B_6_y*B_6_y);
    const pkmodes_real t92 = (B_1_y*B_1_y);
    const pkmodes_real t93 = (B_2_y*B_2_y);
    const pkmodes_real t94 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + mu_1*t92 + mu_2*t93 + mu_3*t88 + mu_4*t89 + mu_5*t90 + mu_6*t91;
    const pkmodes_real t95 = (B_1_z*B_1_z);
    const pkmodes_real t96 = (B_2_z*B_2_z);
    const pkmodes_real t97 = (B_3_z*B_3_z);
    const pkmodes_real t98 = (B_4_z*B_4_z);
    const pkmodes_real t99 = (B_5_z*B_5_z);
    const pkmodes_real t100 = (B_6_z*B_6_z);
    const pkmodes_real t101 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + mu_1*t95 + mu_2*t96 + mu_3*t97 + mu_4*t98 + mu_5*t99 + mu_6*t100;
    const pkmodes_real L_rx_rx = -t101 - t94;
    const pkmodes_real t102 = (R(1.0)/R(2.0))*B_1_x;
    const pkmodes_real t103 = (R(1.0)/R(2.0))*g_4_x;
    const pkmodes_real t104 = (R(1.0)/R(2.0))*B_2_x;
    const pkmodes_real t105 = (R(1.0)/R(2.0))*g_5_x;
    const pkmodes_real t106 = (R(1.0)/R(2.0))*B_3_x;
    const pkmodes_real t107 = (R(1.0)/R(2.0))*g_6_x;
    const pkmodes_real t108 = (R(1.0)/R(2.0))*B_4_x;
    const pkmodes_real t109 = (R(1.0)/R(2.0))*g_7_x;
    const pkmodes_real t110 = (R(1.0)/R(2.0))*B_5_x;
    const pkmodes_real t111 = (R(1.0)/R(2.0))*g_8_x;
    const pkmodes_real t112 = (R(1.0)/R(2.0))*B_6_x;
    const pkmodes_real t113 = (R(1.0)/R(2.0))*g_9_x;
    const pkmodes_real t114 = (R(1.0)/R(2.0))*c_x;
    const pkmodes_real t115 = (R(1.0)/R(2.0))*g_10_x;
    const pkmodes_real L_rx_ry =
        B_1_x*t82 + B_1_y*t103 + B_2_x*t83 + B_2_y*t105 + B_3_x*t84 + B_3_y*t107 + B_4_x*t85 + B_4_y*t109
        + B_5_x*t86 + B_5_y*t111 + B_6_x*t87 + B_6_y*t113 + c_y*t115 + g_10_y*t114 + g_4_y*t102 + g_5_y*t104
        + g_6_y*t106 + g_7_y*t108 + g_8_y*t110 + g_9_y*t112;
    const pkmodes_real L_rx_rz =
        B_1_x*t76 + B_1_z*t103 + B_2_x*t77 + B_2_z*t105 + B_3_x*t78 + B_3_z*t107 + B_4_x*t79 + B_4_z*t109
        + B_5_x*t80 + B_5_z*t111 + B_6_x*t81 + B_6_z*t113 + c_z*t115 + g_10_z*t114 + g_4_z*t102 + g_5_z*t104
        + g_6_z*t106 + g_7_z*t108 + g_8_z*t110 + g_9_z*t112;
    const pkmodes_real t116 = (B_1_x*B_1_x);
    const pkmodes_real t117 = (B_2_x*B_2_x);
    const pkmodes_real t118 = (B_3_x*B_3_x);
    const pkmodes_real t119 = (B_4_x*B_4_x);
    const pkmodes_real t120 = (B_5_x*B_5_x);
    const pkmodes_real t121 = (B_6_x*B_6_x);
    const pkmodes_real t122 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + mu_1*t116 + mu_2*t117 + mu_3*t118 + mu_4*t119 + mu_5*t120 + mu_6*t121;
    const pkmodes_real L_ry_ry = -t101 - t122;
    const pkmodes_real L_ry_rz =
        (R(1.0)/R(2.0))*B_1_y*g_4_z + B_1_y*t76 + (R(1.0)/R(2.0))*B_1_z*g_4_y + (R(1.0)/R(2.0))*B_2_y*g_5_z
        + B_2_y*t77 + (R(1.0)/R(2.0))*B_2_z*g_5_y + (R(1.0)/R(2.0))*B_3_y*g_6_z + B_3_y*t78
        + (R(1.0)/R(2.0))*B_3_z*g_6_y + (R(1.0)/R(2.0))*B_4_y*g_7_z + B_4_y*t79 + (R(1.0)/R(2.0))*B_4_z*g_7_y
        + (R(1.0)/R(2.0))*B_5_y*g_8_z + B_5_y*t80 + (R(1.0)/R(2.0))*B_5_z*g_8_y + (R(1.0)/R(2.0))*B_6_y*g_9_z
        + B_6_y*t81 + (R(1.0)/R(2.0))*B_6_z*g_9_y + (R(1.0)/R(2.0))*c_y*g_10_z + (R(1.0)/R(2.0))*c_z*g_10_y;
    const pkmodes_real L_rz_rz = -t122 - t94;
    const pkmodes_real t123 = t30*t32;
    const pkmodes_real t124 = g_x*t123;
    const pkmodes_real f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t124;
    const pkmodes_real t125 = t33*t35;
    const pkmodes_real t126 = g_x*t125;
    const pkmodes_real f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t126;
    const pkmodes_real t127 = t36*t38;
    const pkmodes_real t128 = g_x*t127;
    const pkmodes_real f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t128;
    const pkmodes_real t129 = t39*t41;
    const pkmodes_real t130 = g_x*t129;
    const pkmodes_real f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t130;
    const pkmodes_real t131 = t42*t44;
    const pkmodes_real t132 = g_x*t131;
    const pkmodes_real f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t132;
    const pkmodes_real t133 = t45*t47;
    const pkmodes_real t134 = g_x*t133;
    const pkmodes_real f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t134;
    const pkmodes_real t135 = g_y*t123;
    const pkmodes_real f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t135;
    const pkmodes_real t136 = g_y*t125;
    const pkmodes_real f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t136;
    const pkmodes_real t137 = g_y*t127;
    const pkmodes_real f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t137;
    const pkmodes_real t138 = g_y*t129;
    const pkmodes_real f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t138;
    const pkmodes_real t139 = g_y*t131;
    const pkmodes_real f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t139;
    const pkmodes_real t140 = g_y*t133;
    const pkmodes_real f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t140;
    const pkmodes_real t141 = g_z*t123;
    const pkmodes_real f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t141;
    const pkmodes_real t142 = g_z*t125;
    const pkmodes_real f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t142;
    const pkmodes_real t143 = g_z*t127;
    const pkmodes_real f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t143;
    const pkmodes_real t144 = g_z*t129;
    const pkmodes_real f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t144;
    const pkmodes_real t145 = g_z*t131;
    const pkmodes_real f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t145;
    const pkmodes_real t146 = g_z*t133;
    const pkmodes_real f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t146;
    const pkmodes_real t147 = t123*(-B_1_y*g_z + B_1_z*g_y);
    const pkmodes_real f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx - t147;
    const pkmodes_real t148 = t125*(-B_2_y*g_z + B_2_z*g_y);
    const pkmodes_real f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx - t148;
    const pkmodes_real t149 = t127*(-B_3_y*g_z + B_3_z*g_y);
    const pkmodes_real f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx - t149;
    const pkmodes_real t150 = t129*(-B_4_y*g_z + B_4_z*g_y);
    const pkmodes_real f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx - t150;
    const pkmodes_real t151 = t131*(-B_5_y*g_z + B_5_z*g_y);
    const pkmodes_real f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx - t151;
    const pkmodes_real t152 = t133*(-B_6_y*g_z + B_6_z*g_y);
    const pkmodes_real f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx - t152;
    const pkmodes_real t153 = t123*(B_1_x*g_z - B_1_z*g_x);
    const pkmodes_real f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry - t153;
    const pkmodes_real t154 = t125*(B_2_x*g_z - B_2_z*g_x);
    const pkmodes_real f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry - t154;
    const pkmodes_real t155 = t127*(B_3_x*g_z - B_3_z*g_x);
    const pkmodes_real f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry - t155;
    const pkmodes_real t156 = t129*(B_4_x*g_z - B_4_z*g_x);
    const pkmodes_real f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry - t156;
    const pkmodes_real t157 = t131*(B_5_x*g_z - B_5_z*g_x);
    const pkmodes_real f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry - t157;
    const pkmodes_real t158 = t133*(B_6_x*g_z - B_6_z*g_x);
    const pkmodes_real f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry - t158;
    const pkmodes_real t159 = t123*(-B_1_x*g_y + B_1_y*g_x);
    const pkmodes_real f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz - t159;
    const pkmodes_real t160 = t125*(-B_2_x*g_y + B_2_y*g_x);
    const pkmodes_real f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz - t160;
    const pkmodes_real t161 = t127*(-B_3_x*g_y + B_3_y*g_x);
    const pkmodes_real f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz - t161;
    const pkmodes_real t162 = t129*(-B_4_x*g_y + B_4_y*g_x);
    const pkmodes_real f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz - t162;
    const pkmodes_real t163 = t131*(-B_5_x*g_y + B_5_y*g_x);
    const pkmodes_real f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz - t163;
    const pkmodes_real t164 = t133*(-B_6_x*g_y + B_6_y*g_x);
    const pkmodes_real f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz - t164;
    const pkmodes_real M_p_x_x = m_p + m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6;
    const pkmodes_real t165 = B_1_z*m_perp_1;
    const pkmodes_real t166 = B_2_z*m_perp_2;
    const pkmodes_real t167 = B_3_z*m_perp_3;
    const pkmodes_real t168 = B_4_z*m_perp_4;
    const pkmodes_real t169 = B_5_z*m_perp_5;
    const pkmodes_real t170 = B_6_z*m_perp_6;
    const pkmodes_real t171 = c_z*m_p;
    const pkmodes_real M_p_x_ry = t165 + t166 + t167 + t168 + t169 + t170 + t171;
    const pkmodes_real t172 = B_1_y*m_perp_1;
    const pkmodes_real t173 = B_2_y*m_perp_2;
    const pkmodes_real t174 = B_3_y*m_perp_3;
    const pkmodes_real t175 = B_4_y*m_perp_4;
    const pkmodes_real t176 = B_5_y*m_perp_5;
    const pkmodes_real t177 = B_6_y*m_perp_6;
    const pkmodes_real t178 = c_y*m_p;
    const pkmodes_real M_p_z_rx = t172 + t173 + t174 + t175 + t176 + t177 + t178;
    const pkmodes_real M_p_x_rz = -M_p_z_rx;
    const pkmodes_real M_p_y_rx = -M_p_x_ry;
    const pkmodes_real M_p_y_rz =
        B_1_x*m_perp_1 + B_2_x*m_perp_2 + B_3_x*m_perp_3 + B_4_x*m_perp_4 + B_5_x*m_perp_5 + B_6_x*m_perp_6
        + c_x*m_p;
    const pkmodes_real M_p_z_ry = -M_p_y_rz;
    const pkmodes_real t179 = 2*(c_y*c_y);
    const pkmodes_real t180 = 2*(c_z*c_z);
    const pkmodes_real t181 = (R(1.0)/R(2.0))*m_p;
    const pkmodes_real t182 = 2*t92;
    const pkmodes_real t183 = 2*t95;
    const pkmodes_real t184 = (R(1.0)/R(2.0))*m_perp_1;
    const pkmodes_real t185 = 2*t93;
    const pkmodes_real t186 = 2*t96;
    const pkmodes_real t187 = (R(1.0)/R(2.0))*m_perp_2;
    const pkmodes_real t188 = 2*t88;
    const pkmodes_real t189 = 2*t97;
    const pkmodes_real t190 = (R(1.0)/R(2.0))*m_perp_3;
    const pkmodes_real t191 = 2*t89;
    const pkmodes_real t192 = 2*t98;
    const pkmodes_real t193 = (R(1.0)/R(2.0))*m_perp_4;
    const pkmodes_real t194 = 2*t90;
    const pkmodes_real t195 = 2*t99;
    const pkmodes_real t196 = (R(1.0)/R(2.0))*m_perp_5;
    const pkmodes_real t197 = 2*t91;
    const pkmodes_real t198 = 2*t100;
    const pkmodes_real t199 = (R(1.0)/R(2.0))*m_perp_6;
    const pkmodes_real M_p_rx_rx =
        J_x_x + t181*(t179 + t180) + t184*(t182 + t183) + t187*(t185 + t186) + t190*(t188 + t189)
        + t193*(t191 + t192) + t196*(t194 + t195) + t199*(t197 + t198);
    const pkmodes_real M_p_rx_ry =
        -B_1_x*t172 - B_2_x*t173 - B_3_x*t174 - B_4_x*t175 - B_5_x*t176 - B_6_x*t177 + J_x_y - c_x*t178;
    const pkmodes_real M_p_rx_rz =
        -B_1_x*t165 - B_2_x*t166 - B_3_x*t167 - B_4_x*t168 - B_5_x*t169 - B_6_x*t170 + J_x_z - c_x*t171;
    const pkmodes_real t200 = 2*(c_x*c_x);
    const pkmodes_real t201 = 2*t116;
    const pkmodes_real t202 = 2*t117;
    const pkmodes_real t203 = 2*t118;
    const pkmodes_real t204 = 2*t119;
    const pkmodes_real t205 = 2*t120;
    const pkmodes_real t206 = 2*t121;
    const pkmodes_real M_p_ry_ry =
        J_y_y + t181*(t180 + t200) + t184*(t183 + t201) + t187*(t186 + t202) + t190*(t189 + t203)
        + t193*(t192 + t204) + t196*(t195 + t205) + t199*(t198 + t206);
    const pkmodes_real M_p_ry_rz =
        -B_1_y*t165 - B_2_y*t166 - B_3_y*t167 - B_4_y*t168 - B_5_y*t169 - B_6_y*t170 + J_y_z - c_y*t171;
    const pkmodes_real M_p_rz_rz =
        J_z_z + t181*(t179 + t200) + t184*(t182 + t201) + t187*(t185 + t202) + t190*(t188 + t203)
        + t193*(t191 + t204) + t196*(t194 + t205) + t199*(t197 + t206);
    const pkmodes_real h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const pkmodes_real h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const pkmodes_real h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const pkmodes_real h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const pkmodes_real h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const pkmodes_real h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const pkmodes_real h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const pkmodes_real h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const pkmodes_real h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const pkmodes_real h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const pkmodes_real h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const pkmodes_real h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const pkmodes_real h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const pkmodes_real h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const pkmodes_real h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const pkmodes_real h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const pkmodes_real h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const pkmodes_real h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
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
    memset(M, 0, sizeof(pkmodes_real[12][12]));
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
    M[3][3] =
        D_p_rx_4*h_rx_l_4 + D_p_ry_4*h_ry_l_4 + D_p_rz_4*h_rz_l_4 + D_p_x_4*h_x_l_4 + D_p_y_4*h_y_l_4
        + D_p_z_4*h_z_l_4 - m_perp_4 + m_r_4;
    M[3][4] = M[4][3] =
        D_p_rx_4*h_rx_l_5 + D_p_ry_4*h_ry_l_5 + D_p_rz_4*h_rz_l_5 + D_p_x_4*h_x_l_5 + D_p_y_4*h_y_l_5
        + D_p_z_4*h_z_l_5;
    M[3][5] = M[5][3] =
        D_p_rx_4*h_rx_l_6 + D_p_ry_4*h_ry_l_6 + D_p_rz_4*h_rz_l_6 + D_p_x_4*h_x_l_6 + D_p_y_4*h_y_l_6
        + D_p_z_4*h_z_l_6;
    M[4][4] =
        D_p_rx_5*h_rx_l_5 + D_p_ry_5*h_ry_l_5 + D_p_rz_5*h_rz_l_5 + D_p_x_5*h_x_l_5 + D_p_y_5*h_y_l_5
        + D_p_z_5*h_z_l_5 - m_perp_5 + m_r_5;
    M[4][5] = M[5][4] =
        D_p_rx_5*h_rx_l_6 + D_p_ry_5*h_ry_l_6 + D_p_rz_5*h_rz_l_6 + D_p_x_5*h_x_l_6 + D_p_y_5*h_y_l_6
        + D_p_z_5*h_z_l_6;
    M[5][5] =
        D_p_rx_6*h_rx_l_6 + D_p_ry_6*h_ry_l_6 + D_p_rz_6*h_rz_l_6 + D_p_x_6*h_x_l_6 + D_p_y_6*h_y_l_6
        + D_p_z_6*h_z_l_6 - m_perp_6 + m_r_6;
    M[6][6] = I_m_1/(h_m_1*h_m_1);
    M[7][7] = I_m_2/(h_m_2*h_m_2);
    M[8][8] = I_m_3/(h_m_3*h_m_3);
    M[9][9] = I_m_4/(h_m_4*h_m_4);
    M[10][10] = I_m_5/(h_m_5*h_m_5);
    M[11][11] = I_m_6/(h_m_6*h_m_6);
    memset(K, 0, sizeof(pkmodes_real[12][12]));
    K[0][0] =
        D_p_rx_1*f_rx_l_1 - D_p_rx_1*t147 + D_p_ry_1*f_ry_l_1 - D_p_ry_1*t153 + D_p_rz_1*f_rz_l_1
        - D_p_rz_1*t159 + D_p_x_1*f_x_l_1 + D_p_x_1*t124 + D_p_y_1*f_y_l_1 + D_p_y_1*t135 + D_p_z_1*f_z_l_1
        + D_p_z_1*t141 + k_l_1 + mu_1 + 2*t32*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1*l_1);
    K[0][1] = K[1][0] =
        D_p_rx_1*f_rx_l_2 - D_p_rx_2*t147 + D_p_ry_1*f_ry_l_2 - D_p_ry_2*t153 + D_p_rz_1*f_rz_l_2
        - D_p_rz_2*t159 + D_p_x_1*f_x_l_2 + D_p_x_2*t124 + D_p_y_1*f_y_l_2 + D_p_y_2*t135 + D_p_z_1*f_z_l_2
        + D_p_z_2*t141;
    K[0][2] = K[2][0] =
        D_p_rx_1*f_rx_l_3 - D_p_rx_3*t147 + D_p_ry_1*f_ry_l_3 - D_p_ry_3*t153 + D_p_rz_1*f_rz_l_3
        - D_p_rz_3*t159 + D_p_x_1*f_x_l_3 + D_p_x_3*t124 + D_p_y_1*f_y_l_3 + D_p_y_3*t135 + D_p_z_1*f_z_l_3
        + D_p_z_3*t141;
    K[0][3] = K[3][0] =
        D_p_rx_1*f_rx_l_4 - D_p_rx_4*t147 + D_p_ry_1*f_ry_l_4 - D_p_ry_4*t153 + D_p_rz_1*f_rz_l_4
        - D_p_rz_4*t159 + D_p_x_1*f_x_l_4 + D_p_x_4*t124 + D_p_y_1*f_y_l_4 + D_p_y_4*t135 + D_p_z_1*f_z_l_4
        + D_p_z_4*t141;
    K[0][4] = K[4][0] =
        D_p_rx_1*f_rx_l_5 - D_p_rx_5*t147 + D_p_ry_1*f_ry_l_5 - D_p_ry_5*t153 + D_p_rz_1*f_rz_l_5
        - D_p_rz_5*t159 + D_p_x_1*f_x_l_5 + D_p_x_5*t124 + D_p_y_1*f_y_l_5 + D_p_y_5*t135 + D_p_z_1*f_z_l_5
        + D_p_z_5*t141;
    K[0][5] = K[5][0] =
        D_p_rx_1*f_rx_l_6 - D_p_rx_6*t147 + D_p_ry_1*f_ry_l_6 - D_p_ry_6*t153 + D_p_rz_1*f_rz_l_6
        - D_p_rz_6*t159 + D_p_x_1*f_x_l_6 + D_p_x_6*t124 + D_p_y_1*f_y_l_6 + D_p_y_6*t135 + D_p_z_1*f_z_l_6
        + D_p_z_6*t141;
    K[0][6] = K[6][0] = -k_l_1;
    K[1][1] =
        D_p_rx_2*f_rx_l_2 - D_p_rx_2*t148 + D_p_ry_2*f_ry_l_2 - D_p_ry_2*t154 + D_p_rz_2*f_rz_l_2
        - D_p_rz_2*t160 + D_p_x_2*f_x_l_2 + D_p_x_2*t126 + D_p_y_2*f_y_l_2 + D_p_y_2*t136 + D_p_z_2*f_z_l_2
        + D_p_z_2*t142 + k_l_2 + mu_2 + 2*t35*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2*l_2);
    K[1][2] = K[2][1] =
        D_p_rx_2*f_rx_l_3 - D_p_rx_3*t148 + D_p_ry_2*f_ry_l_3 - D_p_ry_3*t154 + D_p_rz_2*f_rz_l_3
        - D_p_rz_3*t160 + D_p_x_2*f_x_l_3 + D_p_x_3*t126 + D_p_y_2*f_y_l_3 + D_p_y_3*t136 + D_p_z_2*f_z_l_3
        + D_p_z_3*t142;
    K[1][3] = K[3][1] =
        D_p_rx_2*f_rx_l_4 - D_p_rx_4*t148 + D_p_ry_2*f_ry_l_4 - D_p_ry_4*t154 + D_p_rz_2*f_rz_l_4
        - D_p_rz_4*t160 + D_p_x_2*f_x_l_4 + D_p_x_4*t126 + D_p_y_2*f_y_l_4 + D_p_y_4*t136 + D_p_z_2*f_z_l_4
        + D_p_z_4*t142;
    K[1][4] = K[4][1] =
        D_p_rx_2*f_rx_l_5 - D_p_rx_5*t148 + D_p_ry_2*f_ry_l_5 - D_p_ry_5*t154 + D_p_rz_2*f_rz_l_5
        - D_p_rz_5*t160 + D_p_x_2*f_x_l_5 + D_p_x_5*t126 + D_p_y_2*f_y_l_5 + D_p_y_5*t136 + D_p_z_2*f_z_l_5
        + D_p_z_5*t142;
    K[1][5] = K[5][1] =
        D_p_rx_2*f_rx_l_6 - D_p_rx_6*t148 + D_p_ry_2*f_ry_l_6 - D_p_ry_6*t154 + D_p_rz_2*f_rz_l_6
        - D_p_rz_6*t160 + D_p_x_2*f_x_l_6 + D_p_x_6*t126 + D_p_y_2*f_y_l_6 + D_p_y_6*t136 + D_p_z_2*f_z_l_6
        + D_p_z_6*t142;
    K[1][7] = K[7][1] = -k_l_2;
    K[2][2] =
        D_p_rx_3*f_rx_l_3 - D_p_rx_3*t149 + D_p_ry_3*f_ry_l_3 - D_p_ry_3*t155 + D_p_rz_3*f_rz_l_3
        - D_p_rz_3*t161 + D_p_x_3*f_x_l_3 + D_p_x_3*t128 + D_p_y_3*f_y_l_3 + D_p_y_3*t137 + D_p_z_3*f_z_l_3
        + D_p_z_3*t143 + k_l_3 + mu_3 + 2*t38*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3*l_3);
    K[2][3] = K[3][2] =
        D_p_rx_3*f_rx_l_4 - D_p_rx_4*t149 + D_p_ry_3*f_ry_l_4 - D_p_ry_4*t155 + D_p_rz_3*f_rz_l_4
        - D_p_rz_4*t161 + D_p_x_3*f_x_l_4 + D_p_x_4*t128 + D_p_y_3*f_y_l_4 + D_p_y_4*t137 + D_p_z_3*f_z_l_4
        + D_p_z_4*t143;
    K[2][4] = K[4][2] =
        D_p_rx_3*f_rx_l_5 - D_p_rx_5*t149 + D_p_ry_3*f_ry_l_5 - D_p_ry_5*t155 + D_p_rz_3*f_rz_l_5
        - D_p_rz_5*t161 + D_p_x_3*f_x_l_5 + D_p_x_5*t128 + D_p_y_3*f_y_l_5 + D_p_y_5*t137 + D_p_z_3*f_z_l_5
        + D_p_z_5*t143;
    K[2][5] = K[5][2] =
        D_p_rx_3*f_rx_l_6 - D_p_rx_6*t149 + D_p_ry_3*f_ry_l_6 - D_p_ry_6*t155 + D_p_rz_3*f_rz_l_6
        - D_p_rz_6*t161 + D_p_x_3*f_x_l_6 + D_p_x_6*t128 + D_p_y_3*f_y_l_6 + D_p_y_6*t137 + D_p_z_3*f_z_l_6
        + D_p_z_6*t143;
    K[2][8] = K[8][2] = -k_l_3;
    K[3][3] =
        D_p_rx_4*f_rx_l_4 - D_p_rx_4*t150 + D_p_ry_4*f_ry_l_4 - D_p_ry_4*t156 + D_p_rz_4*f_rz_l_4
        - D_p_rz_4*t162 + D_p_x_4*f_x_l_4 + D_p_x_4*t130 + D_p_y_4*f_y_l_4 + D_p_y_4*t138 + D_p_z_4*f_z_l_4
        + D_p_z_4*t144 + k_l_4 + mu_4 + 2*t41*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4*l_4);
    K[3][4] = K[4][3] =
        D_p_rx_4*f_rx_l_5 - D_p_rx_5*t150 + D_p_ry_4*f_ry_l_5 - D_p_ry_5*t156 + D_p_rz_4*f_rz_l_5
        - D_p_rz_5*t162 + D_p_x_4*f_x_l_5 + D_p_x_5*t130 + D_p_y_4*f_y_l_5 + D_p_y_5*t138 + D_p_z_4*f_z_l_5
        + D_p_z_5*t144;
    K[3][5] = K[5][3] =
        D_p_rx_4*f_rx_l_6 - D_p_rx_6*t150 + D_p_ry_4*f_ry_l_6 - D_p_ry_6*t156 + D_p_rz_4*f_rz_l_6
        - D_p_rz_6*t162 + D_p_x_4*f_x_l_6 + D_p_x_6*t130 + D_p_y_4*f_y_l_6 + D_p_y_6*t138 + D_p_z_4*f_z_l_6
        + D_p_z_6*t144;
    K[3][9] = K[9][3] = -k_l_4;
    K[4][4] =
        D_p_rx_5*f_rx_l_5 - D_p_rx_5*t151 + D_p_ry_5*f_ry_l_5 - D_p_ry_5*t157 + D_p_rz_5*f_rz_l_5
        - D_p_rz_5*t163 + D_p_x_5*f_x_l_5 + D_p_x_5*t132 + D_p_y_5*f_y_l_5 + D_p_y_5*t139 + D_p_z_5*f_z_l_5
        + D_p_z_5*t145 + k_l_5 + mu_5 + 2*t44*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5*l_5);
    K[4][5] = K[5][4] =
        D_p_rx_5*f_rx_l_6 - D_p_rx_6*t151 + D_p_ry_5*f_ry_l_6 - D_p_ry_6*t157 + D_p_rz_5*f_rz_l_6
        - D_p_rz_6*t163 + D_p_x_5*f_x_l_6 + D_p_x_6*t132 + D_p_y_5*f_y_l_6 + D_p_y_6*t139 + D_p_z_5*f_z_l_6
        + D_p_z_6*t145;
    K[4][10] = K[10][4] = -k_l_5;
    K[5][5] =
        D_p_rx_6*f_rx_l_6 - D_p_rx_6*t152 + D_p_ry_6*f_ry_l_6 - D_p_ry_6*t158 + D_p_rz_6*f_rz_l_6
        - D_p_rz_6*t164 + D_p_x_6*f_x_l_6 + D_p_x_6*t134 + D_p_y_6*f_y_l_6 + D_p_y_6*t140 + D_p_z_6*f_z_l_6
        + D_p_z_6*t146 + k_l_6 + mu_6 + 2*t47*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6*l_6);
    K[5][11] = K[11][5] = -k_l_6;
    K[6][6] = k_l_1;
    K[7][7] = k_l_2;
    K[8][8] = k_l_3;
    K[9][9] = k_l_4;
    K[10][10] = k_l_5;
    K[11][11] = k_l_6;
}

/* Coordinates, and the most iterations for one eigenvalue; two are usual. */
enum { N = HEXAPOD_COORDINATES, EIGEN_ITERATIONS = 60 };

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
int hexapod_status(const pkmodes_real p[6], const hexapod_parameters *parameters)
{
    int i;
    for (i = 0; i < HEXAPOD_POSE; ++i)
        if (!isfinite(p[i]))
            return HEXAPOD_NOT_FINITE;
    {
        pkmodes_real margin;
        hexapod_rotation_margin(p, parameters, &margin);
        for (i = 0; i < 1; ++i)
            if (!(((const pkmodes_real *)&margin)[i] > 0))
                return HEXAPOD_BEYOND_ROTATION;
    }
    {
        pkmodes_real determinant, condition;
        hexapod_jacobian_condition(p, parameters, &determinant, &condition);
        for (i = 0; i < 1; ++i)
            if (!(((const pkmodes_real *)&condition)[i] <= HEXAPOD_MAX_CONDITION))
                return HEXAPOD_BEYOND_SINGULAR;
    }
    {
        pkmodes_real margin[6][2];
        hexapod_travel_margin(p, parameters, margin);
        for (i = 0; i < 12; ++i)
            if (!(((const pkmodes_real *)margin)[i] >= 0))
                return HEXAPOD_BEYOND_LIMITS;
    }
    return 0;
}

int hexapod_modes(
    const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real f[12], pkmodes_real phi[12][12])
{
    pkmodes_real M[N][N], K[N][N];
    const int status = hexapod_status(p, parameters);
    if (status)
        return status;
    hexapod_modal_matrices(p, parameters, M, K);
    if (eigen_solve(N, M, K, f, phi) || eigen_lost(N, f, HEXAPOD_RIGID_MODES))
        return HEXAPOD_UNSOLVED;
    eigen_frequencies(N, f);
    return 0;
}

int hexapod_natural_frequencies(
    const pkmodes_real p[6], const hexapod_parameters *parameters, pkmodes_real f[12])
{
    return hexapod_modes(p, parameters, f, NULL);
}
