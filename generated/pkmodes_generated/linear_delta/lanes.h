/* Generated from the derivation of linear_delta.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * The mechanism linear_delta for the compiled evaluator.
 *
 * A part of the compiled evaluator, which includes it once for each instruction set: `lane` is a vector of
 * doubles, one for each pose.  Matrices are row-major; everything is in SI units.
 *
 * Names in the code.  Indices: axis j; pulley k, or carriage k of a derivative; belt span s; component i = x,
 * y, z.  t1, t2, ... are subexpressions shared by several values.
 *   x_j [m]: position of carriage j along its rail
 *   r_j_i [m]: platform joint j relative to the origin of rail j, component i
 *   s_j_i [m]: linkage vector j, from carriage to platform joint, component i
 *   a_j [m]: coordinate of platform joint j along rail j
 *   w_j_i [m]: vector from rail j to platform joint j, perpendicular to it, component i
 *   w2_j [m^2]: squared distance of platform joint j from rail j
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
 */
#define LANES_POSE 3
#define LANES_INDEPENDENT 3
#define LANES_DIRECTIONS 3
#define LANES_BASE 9
#define LANES_ALL 21
#define LANES_RIGID 3
#define LANES_PARAMETERS 76
#define LANES_EFFECTS 16
#define LANES_MARGINS 13

/* How many numbers each margin of a pose has, and how they must compare. */
static const struct lanes_rule LANES_RULES[] = {
    {3, LANES_AT_LEAST_ZERO}, {1, LANES_AT_MOST_LIMIT}, {9, LANES_ABOVE_ZERO},
};

/* Carriage positions at a pose, and the margins of a pose.
 *
 * Source: inverse_kinematics and reach_margin, jacobian_condition, belt_spans.
 * 211 operations; 13773 with every named value expanded.
 */
static inline void lanes_position(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict q, lane *restrict margin)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane p_x = pose[0];
    const lane p_y = pose[1];
    const lane p_z = pose[2];
    const double o_1_x = parameters[4];
    const double o_1_y = parameters[5];
    const double o_1_z = parameters[6];
    const double o_2_x = parameters[7];
    const double o_2_y = parameters[8];
    const double o_2_z = parameters[9];
    const double o_3_x = parameters[10];
    const double o_3_y = parameters[11];
    const double o_3_z = parameters[12];
    const double n_1_x = parameters[13];
    const double n_1_y = parameters[14];
    const double n_1_z = parameters[15];
    const double n_2_x = parameters[16];
    const double n_2_y = parameters[17];
    const double n_2_z = parameters[18];
    const double n_3_x = parameters[19];
    const double n_3_y = parameters[20];
    const double n_3_z = parameters[21];
    const double b_1_x = parameters[22];
    const double b_1_y = parameters[23];
    const double b_1_z = parameters[24];
    const double b_2_x = parameters[25];
    const double b_2_y = parameters[26];
    const double b_2_z = parameters[27];
    const double b_3_x = parameters[28];
    const double b_3_y = parameters[29];
    const double b_3_z = parameters[30];
    const double l_d_1 = parameters[31];
    const double l_d_2 = parameters[32];
    const double l_d_3 = parameters[33];
    const double l_t_1 = parameters[40];
    const double l_t_2 = parameters[41];
    const double l_t_3 = parameters[42];
    const double x_min_1 = parameters[67];
    const double x_max_1 = parameters[68];
    const double x_min_2 = parameters[69];
    const double x_max_2 = parameters[70];
    const double x_min_3 = parameters[71];
    const double x_max_3 = parameters[72];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z;
    const lane w_1_x = -a_1*n_1_x + r_1_x;
    const lane w_1_y = -a_1*n_1_y + r_1_y;
    const lane w_1_z = -a_1*n_1_z + r_1_z;
    const lane w2_1 = (w_1_x*w_1_x) + (w_1_y*w_1_y) + (w_1_z*w_1_z);
    const lane x_1 = a_1 + sigma_1*lanes_sqrt((l_d_1*l_d_1) - w2_1);
    const lane a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const lane w_2_x = -a_2*n_2_x + r_2_x;
    const lane w_2_y = -a_2*n_2_y + r_2_y;
    const lane w_2_z = -a_2*n_2_z + r_2_z;
    const lane w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const lane x_2 = a_2 + sigma_2*lanes_sqrt((l_d_2*l_d_2) - w2_2);
    const lane a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const lane w_3_x = -a_3*n_3_x + r_3_x;
    const lane w_3_y = -a_3*n_3_y + r_3_y;
    const lane w_3_z = -a_3*n_3_z + r_3_z;
    const lane w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const lane x_3 = a_3 + sigma_3*lanes_sqrt((l_d_3*l_d_3) - w2_3);
    const lane s_1_x = -n_1_x*x_1 + r_1_x;
    const lane s_1_y = -n_1_y*x_1 + r_1_y;
    const lane s_1_z = -n_1_z*x_1 + r_1_z;
    const lane s_2_x = -n_2_x*x_2 + r_2_x;
    const lane s_2_y = -n_2_y*x_2 + r_2_y;
    const lane s_2_z = -n_2_z*x_2 + r_2_z;
    const lane s_3_x = -n_3_x*x_3 + r_3_x;
    const lane s_3_y = -n_3_y*x_3 + r_3_y;
    const lane s_3_z = -n_3_z*x_3 + r_3_z;
    const lane A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y;
    const lane A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x;
    const lane A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x;
    const lane A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y;
    const lane A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x;
    const lane A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x;
    const lane A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y;
    const lane A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x;
    const lane A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x;
    const lane det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double t1 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -t1 + x_1 - x_min_1;
    const lane l_f_1_3 = -t1 - x_1 + x_max_1;
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double t2 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -t2 + x_2 - x_min_2;
    const lane l_f_2_3 = -t2 - x_2 + x_max_2;
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double t3 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -t3 + x_3 - x_min_3;
    const lane l_f_3_3 = -t3 - x_3 + x_max_3;
    const lane t4 = 1.0/((det_D_l*det_D_l));
    q[0] = LANES(x_1);
    q[1] = LANES(x_2);
    q[2] = LANES(x_3);
    margin[0] = LANES(l_d_1 - lanes_sqrt(w2_1));
    margin[1] = LANES(l_d_2 - lanes_sqrt(w2_2));
    margin[2] = LANES(l_d_3 - lanes_sqrt(w2_3));
    margin[3] =
        LANES(lanes_sqrt((s_1_x*s_1_x) + (s_1_y*s_1_y) + (s_1_z*s_1_z) + (s_2_x*s_2_x) + (s_2_y*s_2_y)
        + (s_2_z*s_2_z) + (s_3_x*s_3_x) + (s_3_y*s_3_y) + (s_3_z*s_3_z))*lanes_sqrt((A_x_1*A_x_1)*t4
        + (A_x_2*A_x_2)*t4 + (A_x_3*A_x_3)*t4 + (A_y_1*A_y_1)*t4 + (A_y_2*A_y_2)*t4 + (A_y_3*A_y_3)*t4
        + (A_z_1*A_z_1)*t4 + (A_z_2*A_z_2)*t4 + (A_z_3*A_z_3)*t4));
    margin[4] = LANES(l_f_1_1);
    margin[5] = LANES(l_f_1_2);
    margin[6] = LANES(l_f_1_3);
    margin[7] = LANES(l_f_2_1);
    margin[8] = LANES(l_f_2_2);
    margin[9] = LANES(l_f_2_3);
    margin[10] = LANES(l_f_3_1);
    margin[11] = LANES(l_f_3_2);
    margin[12] = LANES(l_f_3_3);
}

/* Mass and stiffness matrices without effects, and the motion of the platform.
 *
 * Source: modal_matrices and platform_jacobian.
 * 537 operations; 518841 with every named value expanded.
 */
static inline void lanes_base(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict M, lane *restrict K, lane *restrict J_p)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane p_x = pose[0];
    const lane p_y = pose[1];
    const lane p_z = pose[2];
    const double m_p = parameters[0];
    const double g_x = parameters[1];
    const double g_y = parameters[2];
    const double g_z = parameters[3];
    const double o_1_x = parameters[4];
    const double o_1_y = parameters[5];
    const double o_1_z = parameters[6];
    const double o_2_x = parameters[7];
    const double o_2_y = parameters[8];
    const double o_2_z = parameters[9];
    const double o_3_x = parameters[10];
    const double o_3_y = parameters[11];
    const double o_3_z = parameters[12];
    const double n_1_x = parameters[13];
    const double n_1_y = parameters[14];
    const double n_1_z = parameters[15];
    const double n_2_x = parameters[16];
    const double n_2_y = parameters[17];
    const double n_2_z = parameters[18];
    const double n_3_x = parameters[19];
    const double n_3_y = parameters[20];
    const double n_3_z = parameters[21];
    const double b_1_x = parameters[22];
    const double b_1_y = parameters[23];
    const double b_1_z = parameters[24];
    const double b_2_x = parameters[25];
    const double b_2_y = parameters[26];
    const double b_2_z = parameters[27];
    const double b_3_x = parameters[28];
    const double b_3_y = parameters[29];
    const double b_3_z = parameters[30];
    const double l_d_1 = parameters[31];
    const double l_d_2 = parameters[32];
    const double l_d_3 = parameters[33];
    const double m_d_1 = parameters[34];
    const double m_d_2 = parameters[35];
    const double m_d_3 = parameters[36];
    const double m_t_1 = parameters[37];
    const double m_t_2 = parameters[38];
    const double m_t_3 = parameters[39];
    const double l_t_1 = parameters[40];
    const double l_t_2 = parameters[41];
    const double l_t_3 = parameters[42];
    const double k_sp_1 = parameters[43];
    const double k_sp_2 = parameters[44];
    const double k_sp_3 = parameters[45];
    const double w_b_1 = parameters[46];
    const double w_b_2 = parameters[47];
    const double w_b_3 = parameters[48];
    const double R_p_1 = parameters[49];
    const double R_p_2 = parameters[50];
    const double R_p_3 = parameters[51];
    const double I_p_1 = parameters[52];
    const double I_p_2 = parameters[53];
    const double I_p_3 = parameters[54];
    const double I_m_1 = parameters[55];
    const double I_m_2 = parameters[56];
    const double I_m_3 = parameters[57];
    const double i_g_1 = parameters[58];
    const double i_g_2 = parameters[59];
    const double i_g_3 = parameters[60];
    const double d_1_1 = parameters[61];
    const double d_1_2 = parameters[62];
    const double d_2_1 = parameters[63];
    const double d_2_2 = parameters[64];
    const double d_3_1 = parameters[65];
    const double d_3_2 = parameters[66];
    const double x_min_1 = parameters[67];
    const double x_max_1 = parameters[68];
    const double x_min_2 = parameters[69];
    const double x_max_2 = parameters[70];
    const double x_min_3 = parameters[71];
    const double x_max_3 = parameters[72];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z;
    const lane w_1_x = -a_1*n_1_x + r_1_x;
    const lane w_1_y = -a_1*n_1_y + r_1_y;
    const lane w_1_z = -a_1*n_1_z + r_1_z;
    const lane w2_1 = (w_1_x*w_1_x) + (w_1_y*w_1_y) + (w_1_z*w_1_z);
    const lane x_1 = a_1 + sigma_1*lanes_sqrt((l_d_1*l_d_1) - w2_1);
    const lane a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const lane w_2_x = -a_2*n_2_x + r_2_x;
    const lane w_2_y = -a_2*n_2_y + r_2_y;
    const lane w_2_z = -a_2*n_2_z + r_2_z;
    const lane w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const lane x_2 = a_2 + sigma_2*lanes_sqrt((l_d_2*l_d_2) - w2_2);
    const lane a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const lane w_3_x = -a_3*n_3_x + r_3_x;
    const lane w_3_y = -a_3*n_3_y + r_3_y;
    const lane w_3_z = -a_3*n_3_z + r_3_z;
    const lane w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const lane x_3 = a_3 + sigma_3*lanes_sqrt((l_d_3*l_d_3) - w2_3);
    const lane s_1_x = -n_1_x*x_1 + r_1_x;
    const lane s_1_y = -n_1_y*x_1 + r_1_y;
    const lane s_1_z = -n_1_z*x_1 + r_1_z;
    const lane s_2_x = -n_2_x*x_2 + r_2_x;
    const lane s_2_y = -n_2_y*x_2 + r_2_y;
    const lane s_2_z = -n_2_z*x_2 + r_2_z;
    const lane s_3_x = -n_3_x*x_3 + r_3_x;
    const lane s_3_y = -n_3_y*x_3 + r_3_y;
    const lane s_3_z = -n_3_z*x_3 + r_3_z;
    const lane D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const lane D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const lane D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const lane A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y;
    const lane A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x;
    const lane A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x;
    const lane A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y;
    const lane A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x;
    const lane A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x;
    const lane A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y;
    const lane A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x;
    const lane A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x;
    const lane det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const lane t1 = 1.0/det_D_l;
    const lane t2 = D_r_1*t1;
    const lane D_p_x_1 = A_x_1*t2;
    const lane t3 = D_r_2*t1;
    const lane D_p_x_2 = A_x_2*t3;
    const lane t4 = D_r_3*t1;
    const lane D_p_x_3 = A_x_3*t4;
    const lane D_p_y_1 = A_y_1*t2;
    const lane D_p_y_2 = A_y_2*t3;
    const lane D_p_y_3 = A_y_3*t4;
    const lane D_p_z_1 = A_z_1*t2;
    const lane D_p_z_2 = A_z_2*t3;
    const lane D_p_z_3 = A_z_3*t4;
    const lane U_1_x_1 = D_p_x_1 - n_1_x;
    const lane U_1_y_1 = D_p_y_1 - n_1_y;
    const lane U_1_z_1 = D_p_z_1 - n_1_z;
    const lane U_2_x_2 = D_p_x_2 - n_2_x;
    const lane U_2_y_2 = D_p_y_2 - n_2_y;
    const lane U_2_z_2 = D_p_z_2 - n_2_z;
    const lane U_3_x_3 = D_p_x_3 - n_3_x;
    const lane U_3_y_3 = D_p_y_3 - n_3_y;
    const lane U_3_z_3 = D_p_z_3 - n_3_z;
    const double t5 = I_m_1*(i_g_1*i_g_1);
    const double I_1_1 = I_p_1 + d_1_1*t5;
    const double I_1_2 = I_p_1 + d_1_2*t5;
    const double t6 = I_m_2*(i_g_2*i_g_2);
    const double I_2_1 = I_p_2 + d_2_1*t6;
    const double I_2_2 = I_p_2 + d_2_2*t6;
    const double t7 = I_m_3*(i_g_3*i_g_3);
    const double I_3_1 = I_p_3 + d_3_1*t7;
    const double I_3_2 = I_p_3 + d_3_2*t7;
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double t8 = k_sp_1*w_b_1;
    const double k_1_1 = t8/l_f_1_1;
    const double t9 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -t9 + x_1 - x_min_1;
    const lane k_1_2 = t8/l_f_1_2;
    const lane l_f_1_3 = -t9 - x_1 + x_max_1;
    const lane k_1_3 = t8/l_f_1_3;
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double t10 = k_sp_2*w_b_2;
    const double k_2_1 = t10/l_f_2_1;
    const double t11 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -t11 + x_2 - x_min_2;
    const lane k_2_2 = t10/l_f_2_2;
    const lane l_f_2_3 = -t11 - x_2 + x_max_2;
    const lane k_2_3 = t10/l_f_2_3;
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double t12 = k_sp_3*w_b_3;
    const double k_3_1 = t12/l_f_3_1;
    const double t13 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -t13 + x_3 - x_min_3;
    const lane k_3_2 = t12/l_f_3_2;
    const lane l_f_3_3 = -t13 - x_3 + x_max_3;
    const lane k_3_3 = t12/l_f_3_3;
    const double t14 = (1.0/2.0)*m_d_1 + (1.0/2.0)*m_d_2 + (1.0/2.0)*m_d_3 + m_p;
    const double t15 = g_x*t14;
    const double t16 = g_y*t14;
    const double t17 = g_z*t14;
    const lane mu_1 = t1*(-A_x_1*t15 - A_y_1*t16 - A_z_1*t17);
    const lane mu_2 = t1*(-A_x_2*t15 - A_y_2*t16 - A_z_2*t17);
    const lane mu_3 = t1*(-A_x_3*t15 - A_y_3*t16 - A_z_3*t17);
    const double t18 = (1.0/3.0)*m_d_1;
    const double t19 = (1.0/6.0)*m_d_1;
    const double t20 = n_1_x*t19;
    const double t21 = n_1_y*t19;
    const double t22 = n_1_z*t19;
    const double t23 = (1.0/3.0)*m_d_2;
    const double t24 = (1.0/3.0)*m_d_3;
    const double t25 = m_p + t18 + t23 + t24;
    const lane t26 = D_p_x_1*t25 + t20;
    const lane t27 = D_p_y_1*t25 + t21;
    const lane t28 = D_p_z_1*t25 + t22;
    const double t29 = (1.0/6.0)*m_d_2;
    const double t30 = n_2_x*t29;
    const double t31 = n_2_y*t29;
    const double t32 = n_2_z*t29;
    const double t33 = (1.0/6.0)*m_d_3;
    const double t34 = n_3_x*t33;
    const double t35 = n_3_y*t33;
    const double t36 = n_3_z*t33;
    const lane t37 = D_p_x_2*t25 + t30;
    const lane t38 = D_p_y_2*t25 + t31;
    const lane t39 = D_p_z_2*t25 + t32;
    const lane t40 = (D_p_x_1*D_p_x_1);
    const lane t41 = (D_p_y_1*D_p_y_1);
    const lane t42 = (D_p_z_1*D_p_z_1);
    const lane t43 = D_p_x_1*mu_3;
    const lane t44 = D_p_x_1*mu_2;
    const lane t45 = U_1_x_1*mu_1;
    const lane t46 = D_p_y_1*mu_3;
    const lane t47 = D_p_y_1*mu_2;
    const lane t48 = U_1_y_1*mu_1;
    const lane t49 = D_p_z_1*mu_3;
    const lane t50 = D_p_z_1*mu_2;
    const lane t51 = U_1_z_1*mu_1;
    const lane t52 = (D_p_x_2*D_p_x_2);
    const lane t53 = (D_p_y_2*D_p_y_2);
    const lane t54 = (D_p_z_2*D_p_z_2);
    const lane t55 = (D_p_x_3*D_p_x_3);
    const lane t56 = (D_p_y_3*D_p_y_3);
    const lane t57 = (D_p_z_3*D_p_z_3);
    const double t58 = (R_p_1*R_p_1);
    const double t59 = k_1_1*t58;
    const double t60 = (R_p_2*R_p_2);
    const double t61 = k_2_1*t60;
    const double t62 = (R_p_3*R_p_3);
    const double t63 = k_3_1*t62;
    lanes_clear(M, 81);
    M[0] =
        LANES(D_p_x_1*t20 + D_p_x_1*t26 + D_p_y_1*t21 + D_p_y_1*t27 + D_p_z_1*t22 + D_p_z_1*t28 + m_t_1
        + t18);
    M[1] = M[9] = LANES(D_p_x_1*t30 + D_p_x_2*t26 + D_p_y_1*t31 + D_p_y_2*t27 + D_p_z_1*t32 + D_p_z_2*t28);
    M[2] = M[18] = LANES(D_p_x_1*t34 + D_p_x_3*t26 + D_p_y_1*t35 + D_p_y_3*t27 + D_p_z_1*t36 + D_p_z_3*t28);
    M[10] =
        LANES(D_p_x_2*t30 + D_p_x_2*t37 + D_p_y_2*t31 + D_p_y_2*t38 + D_p_z_2*t32 + D_p_z_2*t39 + m_t_2
        + t23);
    M[11] = M[19] = LANES(D_p_x_2*t34 + D_p_x_3*t37 + D_p_y_2*t35 + D_p_y_3*t38 + D_p_z_2*t36 + D_p_z_3*t39);
    M[20] =
        LANES(D_p_x_3*t34 + D_p_x_3*(D_p_x_3*t25 + t34) + D_p_y_3*t35 + D_p_y_3*(D_p_y_3*t25 + t35)
        + D_p_z_3*t36 + D_p_z_3*(D_p_z_3*t25 + t36) + m_t_3 + t24);
    M[30] = LANES(I_1_1);
    M[40] = LANES(I_2_1);
    M[50] = LANES(I_3_1);
    M[60] = LANES(I_1_2);
    M[70] = LANES(I_2_2);
    M[80] = LANES(I_3_2);
    lanes_clear(K, 81);
    K[0] =
        LANES(-(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + k_1_2 + k_1_3
        - mu_2*t40 - mu_2*t41 - mu_2*t42 - mu_3*t40 - mu_3*t41 - mu_3*t42);
    K[1] = K[9] =
        LANES(-D_p_x_2*t43 - D_p_x_2*t45 - D_p_y_2*t46 - D_p_y_2*t48 - D_p_z_2*t49 - D_p_z_2*t51
        - U_2_x_2*t44 - U_2_y_2*t47 - U_2_z_2*t50);
    K[2] = K[18] =
        LANES(-D_p_x_3*t44 - D_p_x_3*t45 - D_p_y_3*t47 - D_p_y_3*t48 - D_p_z_3*t50 - D_p_z_3*t51
        - U_3_x_3*t43 - U_3_y_3*t46 - U_3_z_3*t49);
    K[3] = K[27] = LANES(-R_p_1*k_1_3);
    K[6] = K[54] = LANES(-R_p_1*k_1_2);
    K[10] =
        LANES(-(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + k_2_2 + k_2_3
        - mu_1*t52 - mu_1*t53 - mu_1*t54 - mu_3*t52 - mu_3*t53 - mu_3*t54);
    K[11] = K[19] =
        LANES(-D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2);
    K[13] = K[37] = LANES(-R_p_2*k_2_3);
    K[16] = K[64] = LANES(-R_p_2*k_2_2);
    K[20] =
        LANES(-(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + k_3_2 + k_3_3
        - mu_1*t55 - mu_1*t56 - mu_1*t57 - mu_2*t55 - mu_2*t56 - mu_2*t57);
    K[23] = K[47] = LANES(-R_p_3*k_3_3);
    K[26] = K[74] = LANES(-R_p_3*k_3_2);
    K[30] = LANES(k_1_3*t58 + t59);
    K[33] = K[57] = LANES(-t59);
    K[40] = LANES(k_2_3*t60 + t61);
    K[43] = K[67] = LANES(-t61);
    K[50] = LANES(k_3_3*t62 + t63);
    K[53] = K[77] = LANES(-t63);
    K[60] = LANES(k_1_2*t58 + t59);
    K[70] = LANES(k_2_2*t60 + t61);
    K[80] = LANES(k_3_2*t62 + t63);
    lanes_clear(J_p, 27);
    J_p[0] = LANES(D_p_x_1);
    J_p[1] = LANES(D_p_x_2);
    J_p[2] = LANES(D_p_x_3);
    J_p[9] = LANES(D_p_y_1);
    J_p[10] = LANES(D_p_y_2);
    J_p[11] = LANES(D_p_y_3);
    J_p[18] = LANES(D_p_z_1);
    J_p[19] = LANES(D_p_z_2);
    J_p[20] = LANES(D_p_z_3);
}

/* Mass and stiffness matrices with all released joints free, and the motion of the platform.
 *
 * Source: extended_matrices and extended_platform_motion.
 * 1293 operations; 2362404 with every named value expanded.
 */
static inline void lanes_extended(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict M, lane *restrict K, lane *restrict J_p)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane p_x = pose[0];
    const lane p_y = pose[1];
    const lane p_z = pose[2];
    const double m_p = parameters[0];
    const double g_x = parameters[1];
    const double g_y = parameters[2];
    const double g_z = parameters[3];
    const double o_1_x = parameters[4];
    const double o_1_y = parameters[5];
    const double o_1_z = parameters[6];
    const double o_2_x = parameters[7];
    const double o_2_y = parameters[8];
    const double o_2_z = parameters[9];
    const double o_3_x = parameters[10];
    const double o_3_y = parameters[11];
    const double o_3_z = parameters[12];
    const double n_1_x = parameters[13];
    const double n_1_y = parameters[14];
    const double n_1_z = parameters[15];
    const double n_2_x = parameters[16];
    const double n_2_y = parameters[17];
    const double n_2_z = parameters[18];
    const double n_3_x = parameters[19];
    const double n_3_y = parameters[20];
    const double n_3_z = parameters[21];
    const double b_1_x = parameters[22];
    const double b_1_y = parameters[23];
    const double b_1_z = parameters[24];
    const double b_2_x = parameters[25];
    const double b_2_y = parameters[26];
    const double b_2_z = parameters[27];
    const double b_3_x = parameters[28];
    const double b_3_y = parameters[29];
    const double b_3_z = parameters[30];
    const double l_d_1 = parameters[31];
    const double l_d_2 = parameters[32];
    const double l_d_3 = parameters[33];
    const double m_d_1 = parameters[34];
    const double m_d_2 = parameters[35];
    const double m_d_3 = parameters[36];
    const double m_t_1 = parameters[37];
    const double m_t_2 = parameters[38];
    const double m_t_3 = parameters[39];
    const double l_t_1 = parameters[40];
    const double l_t_2 = parameters[41];
    const double l_t_3 = parameters[42];
    const double k_sp_1 = parameters[43];
    const double k_sp_2 = parameters[44];
    const double k_sp_3 = parameters[45];
    const double w_b_1 = parameters[46];
    const double w_b_2 = parameters[47];
    const double w_b_3 = parameters[48];
    const double R_p_1 = parameters[49];
    const double R_p_2 = parameters[50];
    const double R_p_3 = parameters[51];
    const double I_p_1 = parameters[52];
    const double I_p_2 = parameters[53];
    const double I_p_3 = parameters[54];
    const double I_m_1 = parameters[55];
    const double I_m_2 = parameters[56];
    const double I_m_3 = parameters[57];
    const double i_g_1 = parameters[58];
    const double i_g_2 = parameters[59];
    const double i_g_3 = parameters[60];
    const double d_1_1 = parameters[61];
    const double d_1_2 = parameters[62];
    const double d_2_1 = parameters[63];
    const double d_2_2 = parameters[64];
    const double d_3_1 = parameters[65];
    const double d_3_2 = parameters[66];
    const double x_min_1 = parameters[67];
    const double x_max_1 = parameters[68];
    const double x_min_2 = parameters[69];
    const double x_max_2 = parameters[70];
    const double x_min_3 = parameters[71];
    const double x_max_3 = parameters[72];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double a_B_3 = effects[2];
    const double c_E = effects[3];
    const double rho_b = effects[4];
    const double c_T = effects[5];
    const double F_T = effects[6];
    const double k_C = effects[7];
    const double I_G = effects[8];
    const double m_L = effects[9];
    const double k_S = effects[10];
    const double m_F = effects[15];
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane a_1 = n_1_x*r_1_x + n_1_y*r_1_y + n_1_z*r_1_z;
    const lane w_1_x = -a_1*n_1_x + r_1_x;
    const lane w_1_y = -a_1*n_1_y + r_1_y;
    const lane w_1_z = -a_1*n_1_z + r_1_z;
    const lane w2_1 = (w_1_x*w_1_x) + (w_1_y*w_1_y) + (w_1_z*w_1_z);
    const lane x_1 = a_1 + sigma_1*lanes_sqrt((l_d_1*l_d_1) - w2_1);
    const lane a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const lane w_2_x = -a_2*n_2_x + r_2_x;
    const lane w_2_y = -a_2*n_2_y + r_2_y;
    const lane w_2_z = -a_2*n_2_z + r_2_z;
    const lane w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const lane x_2 = a_2 + sigma_2*lanes_sqrt((l_d_2*l_d_2) - w2_2);
    const lane a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const lane w_3_x = -a_3*n_3_x + r_3_x;
    const lane w_3_y = -a_3*n_3_y + r_3_y;
    const lane w_3_z = -a_3*n_3_z + r_3_z;
    const lane w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const lane x_3 = a_3 + sigma_3*lanes_sqrt((l_d_3*l_d_3) - w2_3);
    const lane s_1_x = -n_1_x*x_1 + r_1_x;
    const lane s_1_y = -n_1_y*x_1 + r_1_y;
    const lane s_1_z = -n_1_z*x_1 + r_1_z;
    const lane s_2_x = -n_2_x*x_2 + r_2_x;
    const lane s_2_y = -n_2_y*x_2 + r_2_y;
    const lane s_2_z = -n_2_z*x_2 + r_2_z;
    const lane s_3_x = -n_3_x*x_3 + r_3_x;
    const lane s_3_y = -n_3_y*x_3 + r_3_y;
    const lane s_3_z = -n_3_z*x_3 + r_3_z;
    const lane D_r_1 = n_1_x*s_1_x + n_1_y*s_1_y + n_1_z*s_1_z;
    const lane D_r_2 = n_2_x*s_2_x + n_2_y*s_2_y + n_2_z*s_2_z;
    const lane D_r_3 = n_3_x*s_3_x + n_3_y*s_3_y + n_3_z*s_3_z;
    const lane A_x_1 = s_2_y*s_3_z - s_2_z*s_3_y;
    const lane A_y_1 = -s_2_x*s_3_z + s_2_z*s_3_x;
    const lane A_z_1 = s_2_x*s_3_y - s_2_y*s_3_x;
    const lane A_x_2 = -s_1_y*s_3_z + s_1_z*s_3_y;
    const lane A_y_2 = s_1_x*s_3_z - s_1_z*s_3_x;
    const lane A_z_2 = -s_1_x*s_3_y + s_1_y*s_3_x;
    const lane A_x_3 = s_1_y*s_2_z - s_1_z*s_2_y;
    const lane A_y_3 = -s_1_x*s_2_z + s_1_z*s_2_x;
    const lane A_z_3 = s_1_x*s_2_y - s_1_y*s_2_x;
    const lane det_D_l = A_x_1*s_1_x + A_y_1*s_1_y + A_z_1*s_1_z;
    const lane t1 = 1.0/det_D_l;
    const lane t2 = A_x_1*t1;
    const lane D_p_x_1 = D_r_1*t2;
    const lane t3 = A_x_2*t1;
    const lane D_p_x_2 = D_r_2*t3;
    const lane t4 = A_x_3*t1;
    const lane D_p_x_3 = D_r_3*t4;
    const lane D_delta_x_1 = l_d_1*t2;
    const lane D_delta_x_2 = l_d_2*t3;
    const lane D_delta_x_3 = l_d_3*t4;
    const lane t5 = A_y_1*t1;
    const lane D_p_y_1 = D_r_1*t5;
    const lane t6 = A_y_2*t1;
    const lane D_p_y_2 = D_r_2*t6;
    const lane t7 = A_y_3*t1;
    const lane D_p_y_3 = D_r_3*t7;
    const lane D_delta_y_1 = l_d_1*t5;
    const lane D_delta_y_2 = l_d_2*t6;
    const lane D_delta_y_3 = l_d_3*t7;
    const lane t8 = A_z_1*t1;
    const lane D_p_z_1 = D_r_1*t8;
    const lane t9 = A_z_2*t1;
    const lane D_p_z_2 = D_r_2*t9;
    const lane t10 = A_z_3*t1;
    const lane D_p_z_3 = D_r_3*t10;
    const lane D_delta_z_1 = l_d_1*t8;
    const lane D_delta_z_2 = l_d_2*t9;
    const lane D_delta_z_3 = l_d_3*t10;
    const lane U_1_x_1 = D_p_x_1 - n_1_x;
    const lane U_1_y_1 = D_p_y_1 - n_1_y;
    const lane U_1_z_1 = D_p_z_1 - n_1_z;
    const lane U_2_x_2 = D_p_x_2 - n_2_x;
    const lane U_2_y_2 = D_p_y_2 - n_2_y;
    const lane U_2_z_2 = D_p_z_2 - n_2_z;
    const lane U_3_x_3 = D_p_x_3 - n_3_x;
    const lane U_3_y_3 = D_p_y_3 - n_3_y;
    const lane U_3_z_3 = D_p_z_3 - n_3_z;
    const double t11 = I_m_1*(i_g_1*i_g_1);
    const double t12 = I_G + t11;
    const double I_1_1 = I_p_1 + d_1_1*t12;
    const double I_1_2 = I_p_1 + d_1_2*t12;
    const double t13 = I_m_2*(i_g_2*i_g_2);
    const double t14 = I_G + t13;
    const double I_2_1 = I_p_2 + d_2_1*t14;
    const double I_2_2 = I_p_2 + d_2_2*t14;
    const double t15 = I_m_3*(i_g_3*i_g_3);
    const double t16 = I_G + t15;
    const double I_3_1 = I_p_3 + d_3_1*t16;
    const double I_3_2 = I_p_3 + d_3_2*t16;
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double t17 = F_T*c_T + 1.0;
    const double t18 = c_E*t17;
    const double t19 = k_sp_1*w_b_1*(a_B_1 + 1.0);
    const double t20 = t18*t19;
    const double t21 = t17*t19;
    const double k_1_1 = t21/(l_f_1_1 + t20);
    const double t22 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -t22 + x_1 - x_min_1;
    const lane k_1_2 = t21/(l_f_1_2 + t20);
    const lane l_f_1_3 = -t22 - x_1 + x_max_1;
    const lane k_1_3 = t21/(l_f_1_3 + t20);
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double t23 = k_sp_2*w_b_2*(a_B_2 + 1.0);
    const double t24 = t18*t23;
    const double t25 = t17*t23;
    const double k_2_1 = t25/(l_f_2_1 + t24);
    const double t26 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -t26 + x_2 - x_min_2;
    const lane k_2_2 = t25/(l_f_2_2 + t24);
    const lane l_f_2_3 = -t26 - x_2 + x_max_2;
    const lane k_2_3 = t25/(l_f_2_3 + t24);
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double t27 = k_sp_3*w_b_3*(a_B_3 + 1.0);
    const double t28 = t18*t27;
    const double t29 = t17*t27;
    const double k_3_1 = t29/(l_f_3_1 + t28);
    const double t30 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -t30 + x_3 - x_min_3;
    const lane k_3_2 = t29/(l_f_3_2 + t28);
    const lane l_f_3_3 = -t30 - x_3 + x_max_3;
    const lane k_3_3 = t29/(l_f_3_3 + t28);
    const double t31 = (1.0/2.0)*m_d_1;
    const double t32 = (1.0/2.0)*m_d_2;
    const double t33 = (1.0/2.0)*m_d_3;
    const double t34 = m_L + m_p;
    const double t35 = t31 + t32 + t33 + t34;
    const double t36 = g_x*t35;
    const double t37 = g_y*t35;
    const double t38 = g_z*t35;
    const lane mu_1 = t1*(-A_x_1*t36 - A_y_1*t37 - A_z_1*t38);
    const lane mu_2 = t1*(-A_x_2*t36 - A_y_2*t37 - A_z_2*t38);
    const lane mu_3 = t1*(-A_x_3*t36 - A_y_3*t37 - A_z_3*t38);
    const double t39 = (1.0/3.0)*m_d_1;
    const double t40 = (1.0/6.0)*m_d_1;
    const double t41 = n_1_x*t40;
    const double t42 = (1.0/3.0)*m_d_2;
    const double t43 = (1.0/3.0)*m_d_3;
    const double t44 = t34 + t39 + t42 + t43;
    const lane t45 = D_p_x_1*t44;
    const lane t46 = t41 + t45;
    const double t47 = n_1_y*t40;
    const lane t48 = D_p_y_1*t44;
    const lane t49 = t47 + t48;
    const double t50 = n_1_z*t40;
    const lane t51 = D_p_z_1*t44;
    const lane t52 = t50 + t51;
    const double t53 = (1.0/3.0)*rho_b;
    const lane t54 = l_f_1_2*t53;
    const lane t55 = l_f_1_3*t53;
    const lane t56 = t54 + t55;
    const double t57 = (1.0/6.0)*m_d_2;
    const double t58 = n_2_x*t57;
    const double t59 = n_2_y*t57;
    const double t60 = n_2_z*t57;
    const double t61 = (1.0/6.0)*m_d_3;
    const double t62 = n_3_x*t61;
    const double t63 = n_3_y*t61;
    const double t64 = n_3_z*t61;
    const double t65 = (1.0/6.0)*rho_b;
    const double t66 = R_p_1*t65;
    const lane t67 = l_f_1_3*t66;
    const lane t68 = l_f_1_2*t66;
    const double t69 = t40 + t57 + t61;
    const lane t70 = D_p_x_2*t44;
    const lane t71 = t58 + t70;
    const lane t72 = D_p_y_2*t44;
    const lane t73 = t59 + t72;
    const lane t74 = D_p_z_2*t44;
    const lane t75 = t60 + t74;
    const lane t76 = l_f_2_2*t53;
    const lane t77 = l_f_2_3*t53;
    const lane t78 = t76 + t77;
    const double t79 = R_p_2*t65;
    const lane t80 = l_f_2_3*t79;
    const lane t81 = l_f_2_2*t79;
    const lane t82 = D_p_x_3*t44;
    const lane t83 = t62 + t82;
    const lane t84 = D_p_y_3*t44;
    const lane t85 = t63 + t84;
    const lane t86 = D_p_z_3*t44;
    const lane t87 = t64 + t86;
    const lane t88 = l_f_3_2*t53;
    const lane t89 = l_f_3_3*t53;
    const lane t90 = t88 + t89;
    const double t91 = R_p_3*t65;
    const lane t92 = l_f_3_3*t91;
    const lane t93 = l_f_3_2*t91;
    const double t94 = (R_p_1*R_p_1);
    const double t95 = l_f_1_1*t94;
    const double t96 = t53*t95;
    const double t97 = d_1_1*t11;
    const double t98 = (R_p_2*R_p_2);
    const double t99 = l_f_2_1*t98;
    const double t100 = t53*t99;
    const double t101 = d_2_1*t13;
    const double t102 = (R_p_3*R_p_3);
    const double t103 = l_f_3_1*t102;
    const double t104 = t103*t53;
    const double t105 = d_3_1*t15;
    const double t106 = d_1_2*t11;
    const double t107 = d_2_2*t13;
    const double t108 = d_3_2*t15;
    const lane t109 = (D_delta_x_1*D_delta_x_1);
    const lane t110 = (D_delta_y_1*D_delta_y_1);
    const lane t111 = (D_delta_z_1*D_delta_z_1);
    const lane t112 = D_delta_x_1*t44;
    const lane t113 = D_delta_y_1*t44;
    const lane t114 = D_delta_z_1*t44;
    const lane t115 = (D_delta_x_2*D_delta_x_2);
    const lane t116 = (D_delta_y_2*D_delta_y_2);
    const lane t117 = (D_delta_z_2*D_delta_z_2);
    const lane t118 = D_delta_x_2*t44;
    const lane t119 = D_delta_y_2*t44;
    const lane t120 = D_delta_z_2*t44;
    const lane t121 = (D_delta_x_3*D_delta_x_3);
    const lane t122 = (D_delta_y_3*D_delta_y_3);
    const lane t123 = (D_delta_z_3*D_delta_z_3);
    const double t124 = m_F + m_d_1 + m_d_2 + m_d_3 + m_t_1 + m_t_2 + m_t_3 + t34;
    const lane t125 = (D_p_x_1*D_p_x_1);
    const lane t126 = (D_p_y_1*D_p_y_1);
    const lane t127 = (D_p_z_1*D_p_z_1);
    const lane t128 = D_p_x_1*mu_3;
    const lane t129 = D_p_x_1*mu_2;
    const lane t130 = U_1_x_1*mu_1;
    const lane t131 = D_p_y_1*mu_3;
    const lane t132 = D_p_y_1*mu_2;
    const lane t133 = U_1_y_1*mu_1;
    const lane t134 = D_p_z_1*mu_3;
    const lane t135 = D_p_z_1*mu_2;
    const lane t136 = U_1_z_1*mu_1;
    const lane t137 = -R_p_1*k_1_3;
    const lane t138 = -R_p_1*k_1_2;
    const lane t139 = k_1_2 + k_1_3;
    const lane t140 = (D_p_x_2*D_p_x_2);
    const lane t141 = (D_p_y_2*D_p_y_2);
    const lane t142 = (D_p_z_2*D_p_z_2);
    const lane t143 = D_p_x_2*mu_1;
    const lane t144 = D_p_x_2*mu_3;
    const lane t145 = U_2_x_2*mu_2;
    const lane t146 = D_p_y_2*mu_1;
    const lane t147 = D_p_y_2*mu_3;
    const lane t148 = U_2_y_2*mu_2;
    const lane t149 = D_p_z_2*mu_1;
    const lane t150 = D_p_z_2*mu_3;
    const lane t151 = U_2_z_2*mu_2;
    const lane t152 = -R_p_2*k_2_3;
    const lane t153 = -R_p_2*k_2_2;
    const lane t154 = k_2_2 + k_2_3;
    const lane t155 = (D_p_x_3*D_p_x_3);
    const lane t156 = (D_p_y_3*D_p_y_3);
    const lane t157 = (D_p_z_3*D_p_z_3);
    const lane t158 = -R_p_3*k_3_3;
    const lane t159 = -R_p_3*k_3_2;
    const lane t160 = D_delta_x_1*D_p_x_3;
    const lane t161 = U_3_x_3*mu_3;
    const lane t162 = D_delta_y_1*D_p_y_3;
    const lane t163 = U_3_y_3*mu_3;
    const lane t164 = D_delta_z_1*D_p_z_3;
    const lane t165 = U_3_z_3*mu_3;
    const lane t166 = D_delta_x_2*D_p_x_3;
    const lane t167 = D_delta_y_2*D_p_y_3;
    const lane t168 = D_delta_z_2*D_p_z_3;
    const lane t169 = D_delta_x_3*D_p_x_3;
    const lane t170 = D_delta_y_3*D_p_y_3;
    const lane t171 = D_delta_z_3*D_p_z_3;
    const lane t172 = k_3_2 + k_3_3;
    const double t173 = k_1_1*t94;
    const double t174 = k_2_1*t98;
    const double t175 = k_3_1*t102;
    const lane t176 = D_delta_x_1*D_delta_x_2;
    const lane t177 = D_delta_y_1*D_delta_y_2;
    const lane t178 = D_delta_z_1*D_delta_z_2;
    const lane t179 = D_delta_x_1*D_delta_x_3;
    const lane t180 = D_delta_y_1*D_delta_y_3;
    const lane t181 = D_delta_z_1*D_delta_z_3;
    const lane t182 = D_delta_x_2*D_delta_x_3;
    const lane t183 = D_delta_y_2*D_delta_y_3;
    const lane t184 = D_delta_z_2*D_delta_z_3;
    lanes_clear(M, 441);
    M[0] =
        LANES(D_p_x_1*t41 + D_p_x_1*t46 + D_p_y_1*t47 + D_p_y_1*t49 + D_p_z_1*t50 + D_p_z_1*t52 + m_t_1 + t39
        + t56);
    M[1] = M[21] = LANES(D_p_x_1*t58 + D_p_x_2*t46 + D_p_y_1*t59 + D_p_y_2*t49 + D_p_z_1*t60 + D_p_z_2*t52);
    M[2] = M[42] = LANES(D_p_x_1*t62 + D_p_x_3*t46 + D_p_y_1*t63 + D_p_y_3*t49 + D_p_z_1*t64 + D_p_z_3*t52);
    M[3] = M[63] = LANES(t67);
    M[6] = M[126] = LANES(t68);
    M[12] = M[252] = LANES(D_delta_x_1*t46 + D_delta_y_1*t49 + D_delta_z_1*t52);
    M[13] = M[273] = LANES(D_delta_x_2*t46 + D_delta_y_2*t49 + D_delta_z_2*t52);
    M[14] = M[294] = LANES(D_delta_x_3*t46 + D_delta_y_3*t49 + D_delta_z_3*t52);
    M[15] = M[315] = LANES(t56);
    M[18] = M[378] = LANES(D_p_x_1*t69 + m_t_1*n_1_x + n_1_x*t31 + t45);
    M[19] = M[399] = LANES(D_p_y_1*t69 + m_t_1*n_1_y + n_1_y*t31 + t48);
    M[20] = M[420] = LANES(D_p_z_1*t69 + m_t_1*n_1_z + n_1_z*t31 + t51);
    M[22] =
        LANES(D_p_x_2*t58 + D_p_x_2*t71 + D_p_y_2*t59 + D_p_y_2*t73 + D_p_z_2*t60 + D_p_z_2*t75 + m_t_2 + t42
        + t78);
    M[23] = M[43] = LANES(D_p_x_2*t62 + D_p_x_3*t71 + D_p_y_2*t63 + D_p_y_3*t73 + D_p_z_2*t64 + D_p_z_3*t75);
    M[25] = M[85] = LANES(t80);
    M[28] = M[148] = LANES(t81);
    M[33] = M[253] = LANES(D_delta_x_1*t71 + D_delta_y_1*t73 + D_delta_z_1*t75);
    M[34] = M[274] = LANES(D_delta_x_2*t71 + D_delta_y_2*t73 + D_delta_z_2*t75);
    M[35] = M[295] = LANES(D_delta_x_3*t71 + D_delta_y_3*t73 + D_delta_z_3*t75);
    M[37] = M[337] = LANES(t78);
    M[39] = M[379] = LANES(D_p_x_2*t69 + m_t_2*n_2_x + n_2_x*t32 + t70);
    M[40] = M[400] = LANES(D_p_y_2*t69 + m_t_2*n_2_y + n_2_y*t32 + t72);
    M[41] = M[421] = LANES(D_p_z_2*t69 + m_t_2*n_2_z + n_2_z*t32 + t74);
    M[44] =
        LANES(D_p_x_3*t62 + D_p_x_3*t83 + D_p_y_3*t63 + D_p_y_3*t85 + D_p_z_3*t64 + D_p_z_3*t87 + m_t_3 + t43
        + t90);
    M[47] = M[107] = LANES(t92);
    M[50] = M[170] = LANES(t93);
    M[54] = M[254] = LANES(D_delta_x_1*t83 + D_delta_y_1*t85 + D_delta_z_1*t87);
    M[55] = M[275] = LANES(D_delta_x_2*t83 + D_delta_y_2*t85 + D_delta_z_2*t87);
    M[56] = M[296] = LANES(D_delta_x_3*t83 + D_delta_y_3*t85 + D_delta_z_3*t87);
    M[59] = M[359] = LANES(t90);
    M[60] = M[380] = LANES(D_p_x_3*t69 + m_t_3*n_3_x + n_3_x*t33 + t82);
    M[61] = M[401] = LANES(D_p_y_3*t69 + m_t_3*n_3_y + n_3_y*t33 + t84);
    M[62] = M[422] = LANES(D_p_z_3*t69 + m_t_3*n_3_z + n_3_z*t33 + t86);
    M[66] = LANES(I_1_1 + t55*t94 + t96);
    M[69] = M[129] = LANES(t65*t95);
    M[72] = M[192] = LANES(t97);
    M[78] = M[318] = LANES(t67);
    M[88] = LANES(I_2_1 + t100 + t77*t98);
    M[91] = M[151] = LANES(t65*t99);
    M[94] = M[214] = LANES(t101);
    M[100] = M[340] = LANES(t80);
    M[110] = LANES(I_3_1 + t102*t89 + t104);
    M[113] = M[173] = LANES(t103*t65);
    M[116] = M[236] = LANES(t105);
    M[122] = M[362] = LANES(t92);
    M[132] = LANES(I_1_2 + t54*t94 + t96);
    M[135] = M[195] = LANES(t106);
    M[141] = M[321] = LANES(t68);
    M[154] = LANES(I_2_2 + t100 + t76*t98);
    M[157] = M[217] = LANES(t107);
    M[163] = M[343] = LANES(t81);
    M[176] = LANES(I_3_2 + t102*t88 + t104);
    M[179] = M[239] = LANES(t108);
    M[185] = M[365] = LANES(t93);
    M[198] = LANES(t106 + t97);
    M[220] = LANES(t101 + t107);
    M[242] = LANES(t105 + t108);
    M[264] = LANES(t109*t44 + t110*t44 + t111*t44);
    M[265] = M[285] = LANES(D_delta_x_2*t112 + D_delta_y_2*t113 + D_delta_z_2*t114);
    M[266] = M[306] = LANES(D_delta_x_3*t112 + D_delta_y_3*t113 + D_delta_z_3*t114);
    M[270] = M[390] = LANES(D_delta_x_1*t69 + t112);
    M[271] = M[411] = LANES(D_delta_y_1*t69 + t113);
    M[272] = M[432] = LANES(D_delta_z_1*t69 + t114);
    M[286] = LANES(t115*t44 + t116*t44 + t117*t44);
    M[287] = M[307] = LANES(D_delta_x_3*t118 + D_delta_y_3*t119 + D_delta_z_3*t120);
    M[291] = M[391] = LANES(D_delta_x_2*t69 + t118);
    M[292] = M[412] = LANES(D_delta_y_2*t69 + t119);
    M[293] = M[433] = LANES(D_delta_z_2*t69 + t120);
    M[308] = LANES(t121*t44 + t122*t44 + t123*t44);
    M[312] = M[392] = LANES(D_delta_x_3*t44 + D_delta_x_3*t69);
    M[313] = M[413] = LANES(D_delta_y_3*t44 + D_delta_y_3*t69);
    M[314] = M[434] = LANES(D_delta_z_3*t44 + D_delta_z_3*t69);
    M[330] = LANES(t56);
    M[352] = LANES(t78);
    M[374] = LANES(t90);
    M[396] = LANES(t124);
    M[418] = LANES(t124);
    M[440] = LANES(t124);
    lanes_clear(K, 441);
    K[0] =
        LANES(-(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + k_1_2 + k_1_3
        + k_C*t125 + k_C*t126 + k_C*t127 - mu_2*t125 - mu_2*t126 - mu_2*t127 - mu_3*t125 - mu_3*t126
        - mu_3*t127);
    K[1] = K[21] =
        LANES(D_p_x_1*D_p_x_2*k_C - D_p_x_2*t128 - D_p_x_2*t130 + D_p_y_1*D_p_y_2*k_C - D_p_y_2*t131
        - D_p_y_2*t133 + D_p_z_1*D_p_z_2*k_C - D_p_z_2*t134 - D_p_z_2*t136 - U_2_x_2*t129 - U_2_y_2*t132
        - U_2_z_2*t135);
    K[2] = K[42] =
        LANES(D_p_x_1*D_p_x_3*k_C - D_p_x_3*t129 - D_p_x_3*t130 + D_p_y_1*D_p_y_3*k_C - D_p_y_3*t132
        - D_p_y_3*t133 + D_p_z_1*D_p_z_3*k_C - D_p_z_3*t135 - D_p_z_3*t136 - U_3_x_3*t128 - U_3_y_3*t131
        - U_3_z_3*t134);
    K[3] = K[63] = LANES(t137);
    K[6] = K[126] = LANES(t138);
    K[12] = K[252] =
        LANES(D_delta_x_1*D_p_x_1*k_C - D_delta_x_1*t128 - D_delta_x_1*t129 - D_delta_x_1*t130
        + D_delta_y_1*D_p_y_1*k_C - D_delta_y_1*t131 - D_delta_y_1*t132 - D_delta_y_1*t133
        + D_delta_z_1*D_p_z_1*k_C - D_delta_z_1*t134 - D_delta_z_1*t135 - D_delta_z_1*t136);
    K[13] = K[273] =
        LANES(D_delta_x_2*D_p_x_1*k_C - D_delta_x_2*t128 - D_delta_x_2*t129 - D_delta_x_2*t130
        + D_delta_y_2*D_p_y_1*k_C - D_delta_y_2*t131 - D_delta_y_2*t132 - D_delta_y_2*t133
        + D_delta_z_2*D_p_z_1*k_C - D_delta_z_2*t134 - D_delta_z_2*t135 - D_delta_z_2*t136);
    K[14] = K[294] =
        LANES(D_delta_x_3*D_p_x_1*k_C - D_delta_x_3*t128 - D_delta_x_3*t129 - D_delta_x_3*t130
        + D_delta_y_3*D_p_y_1*k_C - D_delta_y_3*t131 - D_delta_y_3*t132 - D_delta_y_3*t133
        + D_delta_z_3*D_p_z_1*k_C - D_delta_z_3*t134 - D_delta_z_3*t135 - D_delta_z_3*t136);
    K[15] = K[315] = LANES(t139);
    K[18] = K[378] = LANES(D_p_x_1*k_C);
    K[19] = K[399] = LANES(D_p_y_1*k_C);
    K[20] = K[420] = LANES(D_p_z_1*k_C);
    K[22] =
        LANES(-(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + k_2_2 + k_2_3
        + k_C*t140 + k_C*t141 + k_C*t142 - mu_1*t140 - mu_1*t141 - mu_1*t142 - mu_3*t140 - mu_3*t141
        - mu_3*t142);
    K[23] = K[43] =
        LANES(D_p_x_2*D_p_x_3*k_C - D_p_x_3*t143 - D_p_x_3*t145 + D_p_y_2*D_p_y_3*k_C - D_p_y_3*t146
        - D_p_y_3*t148 + D_p_z_2*D_p_z_3*k_C - D_p_z_3*t149 - D_p_z_3*t151 - U_3_x_3*t144 - U_3_y_3*t147
        - U_3_z_3*t150);
    K[25] = K[85] = LANES(t152);
    K[28] = K[148] = LANES(t153);
    K[33] = K[253] =
        LANES(D_delta_x_1*D_p_x_2*k_C - D_delta_x_1*t143 - D_delta_x_1*t144 - D_delta_x_1*t145
        + D_delta_y_1*D_p_y_2*k_C - D_delta_y_1*t146 - D_delta_y_1*t147 - D_delta_y_1*t148
        + D_delta_z_1*D_p_z_2*k_C - D_delta_z_1*t149 - D_delta_z_1*t150 - D_delta_z_1*t151);
    K[34] = K[274] =
        LANES(D_delta_x_2*D_p_x_2*k_C - D_delta_x_2*t143 - D_delta_x_2*t144 - D_delta_x_2*t145
        + D_delta_y_2*D_p_y_2*k_C - D_delta_y_2*t146 - D_delta_y_2*t147 - D_delta_y_2*t148
        + D_delta_z_2*D_p_z_2*k_C - D_delta_z_2*t149 - D_delta_z_2*t150 - D_delta_z_2*t151);
    K[35] = K[295] =
        LANES(D_delta_x_3*D_p_x_2*k_C - D_delta_x_3*t143 - D_delta_x_3*t144 - D_delta_x_3*t145
        + D_delta_y_3*D_p_y_2*k_C - D_delta_y_3*t146 - D_delta_y_3*t147 - D_delta_y_3*t148
        + D_delta_z_3*D_p_z_2*k_C - D_delta_z_3*t149 - D_delta_z_3*t150 - D_delta_z_3*t151);
    K[37] = K[337] = LANES(t154);
    K[39] = K[379] = LANES(D_p_x_2*k_C);
    K[40] = K[400] = LANES(D_p_y_2*k_C);
    K[41] = K[421] = LANES(D_p_z_2*k_C);
    K[44] =
        LANES(-(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + k_3_2 + k_3_3
        + k_C*t155 + k_C*t156 + k_C*t157 - mu_1*t155 - mu_1*t156 - mu_1*t157 - mu_2*t155 - mu_2*t156
        - mu_2*t157);
    K[47] = K[107] = LANES(t158);
    K[50] = K[170] = LANES(t159);
    K[54] = K[254] =
        LANES(D_delta_x_1*D_p_x_3*k_C - D_delta_x_1*t161 + D_delta_y_1*D_p_y_3*k_C - D_delta_y_1*t163
        + D_delta_z_1*D_p_z_3*k_C - D_delta_z_1*t165 - mu_1*t160 - mu_1*t162 - mu_1*t164 - mu_2*t160
        - mu_2*t162 - mu_2*t164);
    K[55] = K[275] =
        LANES(D_delta_x_2*D_p_x_3*k_C - D_delta_x_2*t161 + D_delta_y_2*D_p_y_3*k_C - D_delta_y_2*t163
        + D_delta_z_2*D_p_z_3*k_C - D_delta_z_2*t165 - mu_1*t166 - mu_1*t167 - mu_1*t168 - mu_2*t166
        - mu_2*t167 - mu_2*t168);
    K[56] = K[296] =
        LANES(D_delta_x_3*D_p_x_3*k_C - D_delta_x_3*t161 + D_delta_y_3*D_p_y_3*k_C - D_delta_y_3*t163
        + D_delta_z_3*D_p_z_3*k_C - D_delta_z_3*t165 - mu_1*t169 - mu_1*t170 - mu_1*t171 - mu_2*t169
        - mu_2*t170 - mu_2*t171);
    K[59] = K[359] = LANES(t172);
    K[60] = K[380] = LANES(D_p_x_3*k_C);
    K[61] = K[401] = LANES(D_p_y_3*k_C);
    K[62] = K[422] = LANES(D_p_z_3*k_C);
    K[66] = LANES(d_1_1*k_S + k_1_3*t94 + t173);
    K[69] = K[129] = LANES(-t173);
    K[78] = K[318] = LANES(t137);
    K[88] = LANES(d_2_1*k_S + k_2_3*t98 + t174);
    K[91] = K[151] = LANES(-t174);
    K[100] = K[340] = LANES(t152);
    K[110] = LANES(d_3_1*k_S + k_3_3*t102 + t175);
    K[113] = K[173] = LANES(-t175);
    K[122] = K[362] = LANES(t158);
    K[132] = LANES(d_1_2*k_S + k_1_2*t94 + t173);
    K[141] = K[321] = LANES(t138);
    K[154] = LANES(d_2_2*k_S + k_2_2*t98 + t174);
    K[163] = K[343] = LANES(t153);
    K[176] = LANES(d_3_2*k_S + k_3_2*t102 + t175);
    K[185] = K[365] = LANES(t159);
    K[264] =
        LANES(k_C*t109 + k_C*t110 + k_C*t111 - mu_1*t109 - mu_1*t110 - mu_1*t111 + mu_1 - mu_2*t109
        - mu_2*t110 - mu_2*t111 - mu_3*t109 - mu_3*t110 - mu_3*t111);
    K[265] = K[285] =
        LANES(D_delta_x_1*D_delta_x_2*k_C + D_delta_y_1*D_delta_y_2*k_C + D_delta_z_1*D_delta_z_2*k_C
        - mu_1*t176 - mu_1*t177 - mu_1*t178 - mu_2*t176 - mu_2*t177 - mu_2*t178 - mu_3*t176 - mu_3*t177
        - mu_3*t178);
    K[266] = K[306] =
        LANES(D_delta_x_1*D_delta_x_3*k_C + D_delta_y_1*D_delta_y_3*k_C + D_delta_z_1*D_delta_z_3*k_C
        - mu_1*t179 - mu_1*t180 - mu_1*t181 - mu_2*t179 - mu_2*t180 - mu_2*t181 - mu_3*t179 - mu_3*t180
        - mu_3*t181);
    K[270] = K[390] = LANES(D_delta_x_1*k_C);
    K[271] = K[411] = LANES(D_delta_y_1*k_C);
    K[272] = K[432] = LANES(D_delta_z_1*k_C);
    K[286] =
        LANES(k_C*t115 + k_C*t116 + k_C*t117 - mu_1*t115 - mu_1*t116 - mu_1*t117 - mu_2*t115 - mu_2*t116
        - mu_2*t117 + mu_2 - mu_3*t115 - mu_3*t116 - mu_3*t117);
    K[287] = K[307] =
        LANES(D_delta_x_2*D_delta_x_3*k_C + D_delta_y_2*D_delta_y_3*k_C + D_delta_z_2*D_delta_z_3*k_C
        - mu_1*t182 - mu_1*t183 - mu_1*t184 - mu_2*t182 - mu_2*t183 - mu_2*t184 - mu_3*t182 - mu_3*t183
        - mu_3*t184);
    K[291] = K[391] = LANES(D_delta_x_2*k_C);
    K[292] = K[412] = LANES(D_delta_y_2*k_C);
    K[293] = K[433] = LANES(D_delta_z_2*k_C);
    K[308] =
        LANES(k_C*t121 + k_C*t122 + k_C*t123 - mu_1*t121 - mu_1*t122 - mu_1*t123 - mu_2*t121 - mu_2*t122
        - mu_2*t123 - mu_3*t121 - mu_3*t122 - mu_3*t123 + mu_3);
    K[312] = K[392] = LANES(D_delta_x_3*k_C);
    K[313] = K[413] = LANES(D_delta_y_3*k_C);
    K[314] = K[434] = LANES(D_delta_z_3*k_C);
    K[330] = LANES(t139);
    K[352] = LANES(t154);
    K[374] = LANES(t172);
    K[396] = LANES(k_C);
    K[418] = LANES(k_C);
    K[440] = LANES(k_C);
    lanes_clear(J_p, 63);
    J_p[0] = LANES(D_p_x_1);
    J_p[1] = LANES(D_p_x_2);
    J_p[2] = LANES(D_p_x_3);
    J_p[12] = LANES(D_delta_x_1);
    J_p[13] = LANES(D_delta_x_2);
    J_p[14] = LANES(D_delta_x_3);
    J_p[18] = LANES(1.0);
    J_p[21] = LANES(D_p_y_1);
    J_p[22] = LANES(D_p_y_2);
    J_p[23] = LANES(D_p_y_3);
    J_p[33] = LANES(D_delta_y_1);
    J_p[34] = LANES(D_delta_y_2);
    J_p[35] = LANES(D_delta_y_3);
    J_p[40] = LANES(1.0);
    J_p[42] = LANES(D_p_z_1);
    J_p[43] = LANES(D_p_z_2);
    J_p[44] = LANES(D_p_z_3);
    J_p[54] = LANES(D_delta_z_1);
    J_p[55] = LANES(D_delta_z_2);
    J_p[56] = LANES(D_delta_z_3);
    J_p[62] = LANES(1.0);
}
