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
 *   tau_st_j [N m]: static torque on the driven pulley of axis j
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
 *   G_j [N]: gradient of the gravitational potential energy with respect to x_j
 *   det_j [N^2 m]: determinant of the equilibrium equations of axis j
 *   theta_j_k_st [rad]: static rotation of pulley k of axis j, relative to the unstrained transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#define LANES_POSE 3
#define LANES_INDEPENDENT 3
#define LANES_DIRECTIONS 3
#define LANES_LINEAR 3
#define LANES_DRIVES 3
#define LANES_DEPENDENT 6
#define LANES_BASE 9
#define LANES_ALL 21
#define LANES_GRADIENT 102
#define LANES_MARGINS 13

/* How many numbers each margin of a pose has, and how they must compare. */
static const struct lanes_rule LANES_RULES[] = {
    {3, LANES_AT_LEAST_ZERO}, {1, LANES_AT_MOST_LIMIT}, {9, LANES_ABOVE_ZERO},
};

/* Which of the base coordinates the pose determines, and which depend on these. */
static const int LANES_INDEPENDENT_INDICES[] = {0, 1, 2};
static const int LANES_DEPENDENT_INDICES[] = {3, 4, 5, 6, 7, 8};

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
 * 1296 operations; 2362425 with every named value expanded.
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
    const double rho_b = effects[5];
    const double c_T = effects[6];
    const double F_T = effects[7];
    const double k_C = effects[8];
    const double I_G = effects[10];
    const double m_L = effects[11];
    const double k_S = effects[14];
    const double m_F = effects[19];
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
    const double t173 = d_1_1*k_S;
    const double t174 = k_1_1*t94;
    const double t175 = d_2_1*k_S;
    const double t176 = k_2_1*t98;
    const double t177 = d_3_1*k_S;
    const double t178 = k_3_1*t102;
    const double t179 = d_1_2*k_S;
    const double t180 = d_2_2*k_S;
    const double t181 = d_3_2*k_S;
    const lane t182 = D_delta_x_1*D_delta_x_2;
    const lane t183 = D_delta_y_1*D_delta_y_2;
    const lane t184 = D_delta_z_1*D_delta_z_2;
    const lane t185 = D_delta_x_1*D_delta_x_3;
    const lane t186 = D_delta_y_1*D_delta_y_3;
    const lane t187 = D_delta_z_1*D_delta_z_3;
    const lane t188 = D_delta_x_2*D_delta_x_3;
    const lane t189 = D_delta_y_2*D_delta_y_3;
    const lane t190 = D_delta_z_2*D_delta_z_3;
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
    K[66] = LANES(k_1_3*t94 + t173 + t174);
    K[69] = K[129] = LANES(-t174);
    K[72] = K[192] = LANES(t173);
    K[78] = K[318] = LANES(t137);
    K[88] = LANES(k_2_3*t98 + t175 + t176);
    K[91] = K[151] = LANES(-t176);
    K[94] = K[214] = LANES(t175);
    K[100] = K[340] = LANES(t152);
    K[110] = LANES(k_3_3*t102 + t177 + t178);
    K[113] = K[173] = LANES(-t178);
    K[116] = K[236] = LANES(t177);
    K[122] = K[362] = LANES(t158);
    K[132] = LANES(k_1_2*t94 + t174 + t179);
    K[135] = K[195] = LANES(t179);
    K[141] = K[321] = LANES(t138);
    K[154] = LANES(k_2_2*t98 + t176 + t180);
    K[157] = K[217] = LANES(t180);
    K[163] = K[343] = LANES(t153);
    K[176] = LANES(k_3_2*t102 + t178 + t181);
    K[179] = K[239] = LANES(t181);
    K[185] = K[365] = LANES(t159);
    K[198] = LANES(t173 + t179);
    K[220] = LANES(t175 + t180);
    K[242] = LANES(t177 + t181);
    K[264] =
        LANES(k_C*t109 + k_C*t110 + k_C*t111 - mu_1*t109 - mu_1*t110 - mu_1*t111 + mu_1 - mu_2*t109
        - mu_2*t110 - mu_2*t111 - mu_3*t109 - mu_3*t110 - mu_3*t111);
    K[265] = K[285] =
        LANES(D_delta_x_1*D_delta_x_2*k_C + D_delta_y_1*D_delta_y_2*k_C + D_delta_z_1*D_delta_z_2*k_C
        - mu_1*t182 - mu_1*t183 - mu_1*t184 - mu_2*t182 - mu_2*t183 - mu_2*t184 - mu_3*t182 - mu_3*t183
        - mu_3*t184);
    K[266] = K[306] =
        LANES(D_delta_x_1*D_delta_x_3*k_C + D_delta_y_1*D_delta_y_3*k_C + D_delta_z_1*D_delta_z_3*k_C
        - mu_1*t185 - mu_1*t186 - mu_1*t187 - mu_2*t185 - mu_2*t186 - mu_2*t187 - mu_3*t185 - mu_3*t186
        - mu_3*t187);
    K[270] = K[390] = LANES(D_delta_x_1*k_C);
    K[271] = K[411] = LANES(D_delta_y_1*k_C);
    K[272] = K[432] = LANES(D_delta_z_1*k_C);
    K[286] =
        LANES(k_C*t115 + k_C*t116 + k_C*t117 - mu_1*t115 - mu_1*t116 - mu_1*t117 - mu_2*t115 - mu_2*t116
        - mu_2*t117 + mu_2 - mu_3*t115 - mu_3*t116 - mu_3*t117);
    K[287] = K[307] =
        LANES(D_delta_x_2*D_delta_x_3*k_C + D_delta_y_2*D_delta_y_3*k_C + D_delta_z_2*D_delta_z_3*k_C
        - mu_1*t188 - mu_1*t189 - mu_1*t190 - mu_2*t188 - mu_2*t189 - mu_2*t190 - mu_3*t188 - mu_3*t189
        - mu_3*t190);
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

/* Platform Jacobian, static equilibrium and elastic stiffness without effects.
 *
 * Source: platform_jacobian, static_equilibrium, elastic_hessian.
 * 375 operations; 141870 with every named value expanded.
 */
static inline void lanes_statics(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict D_p, lane *restrict tau_st, lane *restrict theta_st,
    lane *restrict H_el)
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
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double t5 = k_sp_1*w_b_1;
    const double k_1_1 = t5/l_f_1_1;
    const double t6 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -t6 + x_1 - x_min_1;
    const lane k_1_2 = t5/l_f_1_2;
    const lane l_f_1_3 = -t6 - x_1 + x_max_1;
    const lane k_1_3 = t5/l_f_1_3;
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double t7 = k_sp_2*w_b_2;
    const double k_2_1 = t7/l_f_2_1;
    const double t8 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -t8 + x_2 - x_min_2;
    const lane k_2_2 = t7/l_f_2_2;
    const lane l_f_2_3 = -t8 - x_2 + x_max_2;
    const lane k_2_3 = t7/l_f_2_3;
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double t9 = k_sp_3*w_b_3;
    const double k_3_1 = t9/l_f_3_1;
    const double t10 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -t10 + x_3 - x_min_3;
    const lane k_3_2 = t9/l_f_3_2;
    const lane l_f_3_3 = -t10 - x_3 + x_max_3;
    const lane k_3_3 = t9/l_f_3_3;
    const double t11 = (1.0/2.0)*m_d_1;
    const double t12 = (1.0/2.0)*m_d_2;
    const double t13 = (1.0/2.0)*m_d_3;
    const double t14 = m_p + t11 + t12 + t13;
    const double t15 = g_x*t14;
    const double t16 = g_y*t14;
    const double t17 = g_z*t14;
    const lane G_1 =
        -D_p_x_1*t15 - D_p_y_1*t16 - D_p_z_1*t17 - g_x*(m_t_1*n_1_x + n_1_x*t11) - g_y*(m_t_1*n_1_y
        + n_1_y*t11) - g_z*(m_t_1*n_1_z + n_1_z*t11);
    const lane G_2 =
        -D_p_x_2*t15 - D_p_y_2*t16 - D_p_z_2*t17 - g_x*(m_t_2*n_2_x + n_2_x*t12) - g_y*(m_t_2*n_2_y
        + n_2_y*t12) - g_z*(m_t_2*n_2_z + n_2_z*t12);
    const lane G_3 =
        -D_p_x_3*t15 - D_p_y_3*t16 - D_p_z_3*t17 - g_x*(m_t_3*n_3_x + n_3_x*t13) - g_y*(m_t_3*n_3_y
        + n_3_y*t13) - g_z*(m_t_3*n_3_z + n_3_z*t13);
    const double t18 = (R_p_1*R_p_1);
    const double t19 = k_1_1*t18;
    const lane t20 = k_1_3*t18;
    const lane t21 = t19 + t20;
    const lane t22 = -d_1_1*t19 + d_1_2*t21;
    const lane t23 = R_p_1*k_1_2;
    const lane t24 = k_1_2*t18;
    const lane t25 = t19 + t24;
    const lane t26 = d_1_1*t25 - d_1_2*t19;
    const lane t27 = R_p_1*k_1_3;
    const lane det_1 = t22*t23 - t26*t27;
    const lane t28 = G_1/det_1;
    const lane theta_1_1_st = -t26*t28;
    const lane theta_1_2_st = t22*t28;
    const double t29 = (R_p_2*R_p_2);
    const double t30 = k_2_1*t29;
    const lane t31 = k_2_3*t29;
    const lane t32 = t30 + t31;
    const lane t33 = -d_2_1*t30 + d_2_2*t32;
    const lane t34 = R_p_2*k_2_2;
    const lane t35 = k_2_2*t29;
    const lane t36 = t30 + t35;
    const lane t37 = d_2_1*t36 - d_2_2*t30;
    const lane t38 = R_p_2*k_2_3;
    const lane det_2 = t33*t34 - t37*t38;
    const lane t39 = G_2/det_2;
    const lane theta_2_1_st = -t37*t39;
    const lane theta_2_2_st = t33*t39;
    const double t40 = (R_p_3*R_p_3);
    const double t41 = k_3_1*t40;
    const lane t42 = k_3_3*t40;
    const lane t43 = t41 + t42;
    const lane t44 = -d_3_1*t41 + d_3_2*t43;
    const lane t45 = R_p_3*k_3_2;
    const lane t46 = k_3_2*t40;
    const lane t47 = t41 + t46;
    const lane t48 = d_3_1*t47 - d_3_2*t41;
    const lane t49 = R_p_3*k_3_3;
    const lane det_3 = t44*t45 - t48*t49;
    const lane t50 = G_3/det_3;
    const lane theta_3_1_st = -t48*t50;
    const lane theta_3_2_st = t44*t50;
    const lane t51 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st);
    const lane tau_st_1 = d_1_1*(t20*theta_1_1_st - t51) + d_1_2*(t24*theta_1_2_st + t51);
    const lane t52 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st);
    const lane tau_st_2 = d_2_1*(t31*theta_2_1_st - t52) + d_2_2*(t35*theta_2_2_st + t52);
    const lane t53 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st);
    const lane tau_st_3 = d_3_1*(t42*theta_3_1_st - t53) + d_3_2*(t46*theta_3_2_st + t53);
    D_p[0] = LANES(D_p_x_1);
    D_p[1] = LANES(D_p_x_2);
    D_p[2] = LANES(D_p_x_3);
    D_p[3] = LANES(D_p_y_1);
    D_p[4] = LANES(D_p_y_2);
    D_p[5] = LANES(D_p_y_3);
    D_p[6] = LANES(D_p_z_1);
    D_p[7] = LANES(D_p_z_2);
    D_p[8] = LANES(D_p_z_3);
    tau_st[0] = LANES(tau_st_1);
    tau_st[1] = LANES(tau_st_2);
    tau_st[2] = LANES(tau_st_3);
    theta_st[0] = LANES(theta_1_1_st);
    theta_st[1] = LANES(theta_2_1_st);
    theta_st[2] = LANES(theta_3_1_st);
    theta_st[3] = LANES(theta_1_2_st);
    theta_st[4] = LANES(theta_2_2_st);
    theta_st[5] = LANES(theta_3_2_st);
    lanes_clear(H_el, 81);
    H_el[0] = LANES(k_1_2 + k_1_3);
    H_el[3] = H_el[27] = LANES(-t27);
    H_el[6] = H_el[54] = LANES(-t23);
    H_el[10] = LANES(k_2_2 + k_2_3);
    H_el[13] = H_el[37] = LANES(-t38);
    H_el[16] = H_el[64] = LANES(-t34);
    H_el[20] = LANES(k_3_2 + k_3_3);
    H_el[23] = H_el[47] = LANES(-t49);
    H_el[26] = H_el[74] = LANES(-t45);
    H_el[30] = LANES(t21);
    H_el[33] = H_el[57] = LANES(-t19);
    H_el[40] = LANES(t32);
    H_el[43] = H_el[67] = LANES(-t30);
    H_el[50] = LANES(t43);
    H_el[53] = H_el[77] = LANES(-t41);
    H_el[60] = LANES(t25);
    H_el[70] = LANES(t36);
    H_el[80] = LANES(t47);
}

/* Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 388 operations; 129417 with every named value expanded.
 */
static inline void lanes_extended_statics(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict tau_st, lane *restrict theta_st)
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
    const double c_T = effects[6];
    const double F_T = effects[7];
    const double m_L = effects[11];
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
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double t5 = F_T*c_T + 1.0;
    const double t6 = c_E*t5;
    const double t7 = k_sp_1*w_b_1*(a_B_1 + 1.0);
    const double t8 = t6*t7;
    const double t9 = t5*t7;
    const double k_1_1 = t9/(l_f_1_1 + t8);
    const double t10 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -t10 + x_1 - x_min_1;
    const lane k_1_2 = t9/(l_f_1_2 + t8);
    const lane l_f_1_3 = -t10 - x_1 + x_max_1;
    const lane k_1_3 = t9/(l_f_1_3 + t8);
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double t11 = k_sp_2*w_b_2*(a_B_2 + 1.0);
    const double t12 = t11*t6;
    const double t13 = t11*t5;
    const double k_2_1 = t13/(l_f_2_1 + t12);
    const double t14 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -t14 + x_2 - x_min_2;
    const lane k_2_2 = t13/(l_f_2_2 + t12);
    const lane l_f_2_3 = -t14 - x_2 + x_max_2;
    const lane k_2_3 = t13/(l_f_2_3 + t12);
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double t15 = k_sp_3*w_b_3*(a_B_3 + 1.0);
    const double t16 = t15*t6;
    const double t17 = t15*t5;
    const double k_3_1 = t17/(l_f_3_1 + t16);
    const double t18 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -t18 + x_3 - x_min_3;
    const lane k_3_2 = t17/(l_f_3_2 + t16);
    const lane l_f_3_3 = -t18 - x_3 + x_max_3;
    const lane k_3_3 = t17/(l_f_3_3 + t16);
    const double t19 = (1.0/2.0)*m_d_1;
    const double t20 = (1.0/2.0)*m_d_2;
    const double t21 = (1.0/2.0)*m_d_3;
    const double t22 = m_L + m_p + t19 + t20 + t21;
    const double t23 = g_x*t22;
    const double t24 = g_y*t22;
    const double t25 = g_z*t22;
    const lane G_1 =
        -D_p_x_1*t23 - D_p_y_1*t24 - D_p_z_1*t25 - g_x*(m_t_1*n_1_x + n_1_x*t19) - g_y*(m_t_1*n_1_y
        + n_1_y*t19) - g_z*(m_t_1*n_1_z + n_1_z*t19);
    const lane G_2 =
        -D_p_x_2*t23 - D_p_y_2*t24 - D_p_z_2*t25 - g_x*(m_t_2*n_2_x + n_2_x*t20) - g_y*(m_t_2*n_2_y
        + n_2_y*t20) - g_z*(m_t_2*n_2_z + n_2_z*t20);
    const lane G_3 =
        -D_p_x_3*t23 - D_p_y_3*t24 - D_p_z_3*t25 - g_x*(m_t_3*n_3_x + n_3_x*t21) - g_y*(m_t_3*n_3_y
        + n_3_y*t21) - g_z*(m_t_3*n_3_z + n_3_z*t21);
    const double t26 = (R_p_1*R_p_1);
    const double t27 = k_1_1*t26;
    const lane t28 = k_1_3*t26;
    const lane t29 = -d_1_1*t27 + d_1_2*(t27 + t28);
    const lane t30 = k_1_2*t26;
    const lane t31 = d_1_1*(t27 + t30) - d_1_2*t27;
    const lane det_1 = R_p_1*k_1_2*t29 - R_p_1*k_1_3*t31;
    const lane t32 = G_1/det_1;
    const lane theta_1_1_st = -t31*t32;
    const lane theta_1_2_st = t29*t32;
    const double t33 = (R_p_2*R_p_2);
    const double t34 = k_2_1*t33;
    const lane t35 = k_2_3*t33;
    const lane t36 = -d_2_1*t34 + d_2_2*(t34 + t35);
    const lane t37 = k_2_2*t33;
    const lane t38 = d_2_1*(t34 + t37) - d_2_2*t34;
    const lane det_2 = R_p_2*k_2_2*t36 - R_p_2*k_2_3*t38;
    const lane t39 = G_2/det_2;
    const lane theta_2_1_st = -t38*t39;
    const lane theta_2_2_st = t36*t39;
    const double t40 = (R_p_3*R_p_3);
    const double t41 = k_3_1*t40;
    const lane t42 = k_3_3*t40;
    const lane t43 = -d_3_1*t41 + d_3_2*(t41 + t42);
    const lane t44 = k_3_2*t40;
    const lane t45 = d_3_1*(t41 + t44) - d_3_2*t41;
    const lane det_3 = R_p_3*k_3_2*t43 - R_p_3*k_3_3*t45;
    const lane t46 = G_3/det_3;
    const lane theta_3_1_st = -t45*t46;
    const lane theta_3_2_st = t43*t46;
    const lane t47 = R_p_1*k_1_1*(-R_p_1*theta_1_1_st + R_p_1*theta_1_2_st);
    const lane tau_st_1 = d_1_1*(t28*theta_1_1_st - t47) + d_1_2*(t30*theta_1_2_st + t47);
    const lane t48 = R_p_2*k_2_1*(-R_p_2*theta_2_1_st + R_p_2*theta_2_2_st);
    const lane tau_st_2 = d_2_1*(t35*theta_2_1_st - t48) + d_2_2*(t37*theta_2_2_st + t48);
    const lane t49 = R_p_3*k_3_1*(-R_p_3*theta_3_1_st + R_p_3*theta_3_2_st);
    const lane tau_st_3 = d_3_1*(t42*theta_3_1_st - t49) + d_3_2*(t44*theta_3_2_st + t49);
    tau_st[0] = LANES(tau_st_1);
    tau_st[1] = LANES(tau_st_2);
    tau_st[2] = LANES(tau_st_3);
    theta_st[0] = LANES(theta_1_1_st);
    theta_st[1] = LANES(theta_2_1_st);
    theta_st[2] = LANES(theta_3_1_st);
    theta_st[3] = LANES(theta_1_2_st);
    theta_st[4] = LANES(theta_2_2_st);
    theta_st[5] = LANES(theta_3_2_st);
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through base.
 * 1264 operations; 497294171 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_base_gradient(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int modes, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
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
    const lane forward_0 = lanes_sqrt((l_d_1*l_d_1) - w2_1);
    const lane x_1 = a_1 + forward_0*sigma_1;
    const lane a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const lane w_2_x = -a_2*n_2_x + r_2_x;
    const lane w_2_y = -a_2*n_2_y + r_2_y;
    const lane w_2_z = -a_2*n_2_z + r_2_z;
    const lane w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const lane forward_1 = lanes_sqrt((l_d_2*l_d_2) - w2_2);
    const lane x_2 = a_2 + forward_1*sigma_2;
    const lane a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const lane w_3_x = -a_3*n_3_x + r_3_x;
    const lane w_3_y = -a_3*n_3_y + r_3_y;
    const lane w_3_z = -a_3*n_3_z + r_3_z;
    const lane w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const lane forward_2 = lanes_sqrt((l_d_3*l_d_3) - w2_3);
    const lane x_3 = a_3 + forward_2*sigma_3;
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
    const lane forward_3 = 1.0/det_D_l;
    const lane forward_t2 = D_r_1*forward_3;
    const lane D_p_x_1 = A_x_1*forward_t2;
    const lane forward_t3 = D_r_2*forward_3;
    const lane D_p_x_2 = A_x_2*forward_t3;
    const lane forward_t4 = D_r_3*forward_3;
    const lane D_p_x_3 = A_x_3*forward_t4;
    const lane D_p_y_1 = A_y_1*forward_t2;
    const lane D_p_y_2 = A_y_2*forward_t3;
    const lane D_p_y_3 = A_y_3*forward_t4;
    const lane D_p_z_1 = A_z_1*forward_t2;
    const lane D_p_z_2 = A_z_2*forward_t3;
    const lane D_p_z_3 = A_z_3*forward_t4;
    const lane U_1_x_1 = D_p_x_1 - n_1_x;
    const lane U_1_y_1 = D_p_y_1 - n_1_y;
    const lane U_1_z_1 = D_p_z_1 - n_1_z;
    const lane U_2_x_2 = D_p_x_2 - n_2_x;
    const lane U_2_y_2 = D_p_y_2 - n_2_y;
    const lane U_2_z_2 = D_p_z_2 - n_2_z;
    const lane U_3_x_3 = D_p_x_3 - n_3_x;
    const lane U_3_y_3 = D_p_y_3 - n_3_y;
    const lane U_3_z_3 = D_p_z_3 - n_3_z;
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double forward_t8 = k_sp_1*w_b_1;
    const double forward_4 = 1.0/l_f_1_1;
    const double k_1_1 = forward_4*forward_t8;
    const double forward_t9 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -forward_t9 + x_1 - x_min_1;
    const lane forward_5 = 1.0/l_f_1_2;
    const lane k_1_2 = forward_5*forward_t8;
    const lane l_f_1_3 = -forward_t9 - x_1 + x_max_1;
    const lane forward_6 = 1.0/l_f_1_3;
    const lane k_1_3 = forward_6*forward_t8;
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double forward_t10 = k_sp_2*w_b_2;
    const double forward_7 = 1.0/l_f_2_1;
    const double k_2_1 = forward_7*forward_t10;
    const double forward_t11 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -forward_t11 + x_2 - x_min_2;
    const lane forward_8 = 1.0/l_f_2_2;
    const lane k_2_2 = forward_8*forward_t10;
    const lane l_f_2_3 = -forward_t11 - x_2 + x_max_2;
    const lane forward_9 = 1.0/l_f_2_3;
    const lane k_2_3 = forward_9*forward_t10;
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double forward_t12 = k_sp_3*w_b_3;
    const double forward_10 = 1.0/l_f_3_1;
    const double k_3_1 = forward_10*forward_t12;
    const double forward_t13 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -forward_t13 + x_3 - x_min_3;
    const lane forward_11 = 1.0/l_f_3_2;
    const lane k_3_2 = forward_11*forward_t12;
    const lane l_f_3_3 = -forward_t13 - x_3 + x_max_3;
    const lane forward_12 = 1.0/l_f_3_3;
    const lane k_3_3 = forward_12*forward_t12;
    const double forward_t14 = (1.0/2.0)*m_d_1 + (1.0/2.0)*m_d_2 + (1.0/2.0)*m_d_3 + m_p;
    const double forward_t15 = forward_t14*g_x;
    const double forward_t16 = forward_t14*g_y;
    const double forward_t17 = forward_t14*g_z;
    const lane t1 = -A_x_1*forward_t15 - A_y_1*forward_t16 - A_z_1*forward_t17;
    const lane mu_1 = forward_3*t1;
    const lane t2 = -A_x_2*forward_t15 - A_y_2*forward_t16 - A_z_2*forward_t17;
    const lane mu_2 = forward_3*t2;
    const lane t3 = -A_x_3*forward_t15 - A_y_3*forward_t16 - A_z_3*forward_t17;
    const lane mu_3 = forward_3*t3;
    const double forward_t18 = (1.0/3.0)*m_d_1;
    const double forward_t19 = (1.0/6.0)*m_d_1;
    const double forward_t20 = forward_t19*n_1_x;
    const double forward_t21 = forward_t19*n_1_y;
    const double forward_t22 = forward_t19*n_1_z;
    const double forward_t23 = (1.0/3.0)*m_d_2;
    const double forward_t24 = (1.0/3.0)*m_d_3;
    const double forward_t25 = forward_t18 + forward_t23 + forward_t24 + m_p;
    const lane forward_t26 = D_p_x_1*forward_t25 + forward_t20;
    const lane forward_t27 = D_p_y_1*forward_t25 + forward_t21;
    const lane forward_t28 = D_p_z_1*forward_t25 + forward_t22;
    const double forward_t29 = (1.0/6.0)*m_d_2;
    const double forward_t30 = forward_t29*n_2_x;
    const double forward_t31 = forward_t29*n_2_y;
    const double forward_t32 = forward_t29*n_2_z;
    const double forward_t33 = (1.0/6.0)*m_d_3;
    const double forward_t34 = forward_t33*n_3_x;
    const double forward_t35 = forward_t33*n_3_y;
    const double forward_t36 = forward_t33*n_3_z;
    const lane forward_t37 = D_p_x_2*forward_t25 + forward_t30;
    const lane forward_t38 = D_p_y_2*forward_t25 + forward_t31;
    const lane forward_t39 = D_p_z_2*forward_t25 + forward_t32;
    const lane forward_t40 = (D_p_x_1*D_p_x_1);
    const lane forward_t41 = (D_p_y_1*D_p_y_1);
    const lane forward_t42 = (D_p_z_1*D_p_z_1);
    const lane forward_t43 = D_p_x_1*mu_3;
    const lane forward_t44 = D_p_x_1*mu_2;
    const lane forward_t45 = U_1_x_1*mu_1;
    const lane forward_t46 = D_p_y_1*mu_3;
    const lane forward_t47 = D_p_y_1*mu_2;
    const lane forward_t48 = U_1_y_1*mu_1;
    const lane forward_t49 = D_p_z_1*mu_3;
    const lane forward_t50 = D_p_z_1*mu_2;
    const lane forward_t51 = U_1_z_1*mu_1;
    const lane forward_t52 = (D_p_x_2*D_p_x_2);
    const lane forward_t53 = (D_p_y_2*D_p_y_2);
    const lane forward_t54 = (D_p_z_2*D_p_z_2);
    const lane forward_t55 = (D_p_x_3*D_p_x_3);
    const lane forward_t56 = (D_p_y_3*D_p_y_3);
    const lane forward_t57 = (D_p_z_3*D_p_z_3);
    const double forward_t58 = (R_p_1*R_p_1);
    const double forward_t60 = (R_p_2*R_p_2);
    const double forward_t62 = (R_p_3*R_p_3);
    const lane t15 = 2.0*D_p_z_2;
    const lane t18 = 2.0*D_p_z_3;
    const lane t23 = 2.0*D_p_y_2;
    const lane t25 = 2.0*D_p_y_3;
    const lane t27 = 2.0*D_p_x_2;
    const lane t29 = 2.0*D_p_x_3;
    const lane t38 = 2.0*D_p_z_1;
    const lane t41 = 2.0*D_p_y_1;
    const lane t42 = 2.0*D_p_x_1;
    const lane t62 = U_3_z_3*mu_3;
    const lane t64 = U_3_y_3*mu_3;
    const lane t65 = U_3_x_3*mu_3;
    const lane t67 = U_2_z_2*mu_2;
    const lane t69 = U_2_y_2*mu_2;
    const lane t70 = U_2_x_2*mu_2;
    const double t74 = 2.0*forward_t36;
    const double t76 = 2.0*forward_t35;
    const double t78 = 2.0*forward_t34;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 9;
        const lane eigenvalue = eigenvalues[mode];
        lane *restrict gradient = gradients + mode * stride;
        const lane shape_1 = shape[0];
        const lane shape_2 = shape[1];
        const lane shape_3 = shape[2];
        const lane shape_4 = shape[3];
        const lane shape_5 = shape[4];
        const lane shape_6 = shape[5];
        const lane shape_7 = shape[6];
        const lane shape_8 = shape[7];
        const lane shape_9 = shape[8];
        const lane t4 = (shape_6*shape_6);
        const lane t5 = (shape_9*shape_9);
        const lane t6 = 2.0*shape_6;
        const lane adjoint_forward_t63 = -shape_9*t6 + t4 + t5;
        const lane adjoint_forward_t62 = adjoint_forward_t63*k_3_1 + k_3_2*t5 + k_3_3*t4;
        const lane t7 = (shape_5*shape_5);
        const lane t8 = (shape_8*shape_8);
        const lane t9 = 2.0*shape_5;
        const lane adjoint_forward_t61 = -shape_8*t9 + t7 + t8;
        const lane adjoint_forward_t60 = adjoint_forward_t61*k_2_1 + k_2_2*t8 + k_2_3*t7;
        const lane t10 = (shape_4*shape_4);
        const lane t11 = (shape_7*shape_7);
        const lane t12 = 2.0*shape_4;
        const lane adjoint_forward_t59 = -shape_7*t12 + t10 + t11;
        const lane adjoint_forward_t58 = adjoint_forward_t59*k_1_1 + k_1_2*t11 + k_1_3*t10;
        const lane t13 = (shape_3*shape_3);
        const lane adjoint_forward_t57 = t13*(-mu_1 - mu_2);
        const lane t14 = (shape_2*shape_2);
        const lane adjoint_forward_t54 = t14*(-mu_1 - mu_3);
        const lane t16 = shape_1*shape_2;
        const lane t17 = t15*t16;
        const lane t19 = shape_1*shape_3;
        const lane t20 = t18*t19;
        const lane adjoint_forward_t51 = -t17 - t20;
        const lane t21 = 2.0*t16;
        const lane adjoint_forward_t50 = -U_2_z_2*t21 - t20;
        const lane t22 = 2.0*t19;
        const lane adjoint_forward_t49 = -U_3_z_3*t22 - t17;
        const lane t24 = t16*t23;
        const lane t26 = t19*t25;
        const lane adjoint_forward_t48 = -t24 - t26;
        const lane adjoint_forward_t47 = -U_2_y_2*t21 - t26;
        const lane adjoint_forward_t46 = -U_3_y_3*t22 - t24;
        const lane t28 = t16*t27;
        const lane t30 = t19*t29;
        const lane adjoint_forward_t45 = -t28 - t30;
        const lane adjoint_forward_t44 = -U_2_x_2*t21 - t30;
        const lane adjoint_forward_t43 = -U_3_x_3*t22 - t28;
        const lane t31 = (shape_1*shape_1);
        const lane adjoint_forward_t42 = t31*(-mu_2 - mu_3);
        const lane t32 = eigenvalue*t14;
        const lane t33 = D_p_z_2*t32;
        const lane t34 = shape_2*shape_3;
        const lane t35 = eigenvalue*t34;
        const lane adjoint_forward_t39 = -t18*t35 - t33;
        const lane t36 = D_p_y_2*t32;
        const lane adjoint_forward_t38 = -t25*t35 - t36;
        const lane t37 = D_p_x_2*t32;
        const lane adjoint_forward_t37 = -t29*t35 - t37;
        const lane t39 = eigenvalue*t19;
        const lane t40 = eigenvalue*t13;
        const lane adjoint_forward_t36 = -t15*t35 - t18*t40 - t38*t39;
        const lane adjoint_forward_t35 = -t23*t35 - t25*t40 - t39*t41;
        const lane adjoint_forward_t34 = -t27*t35 - t29*t40 - t39*t42;
        const lane adjoint_forward_t33 =
            adjoint_forward_t34*n_3_x + adjoint_forward_t35*n_3_y + adjoint_forward_t36*n_3_z;
        const lane t43 = eigenvalue*t16;
        const lane adjoint_forward_t32 = adjoint_forward_t39 - t33 - t38*t43;
        const lane adjoint_forward_t31 = adjoint_forward_t38 - t36 - t41*t43;
        const lane adjoint_forward_t30 = adjoint_forward_t37 - t37 - t42*t43;
        const lane adjoint_forward_t29 =
            adjoint_forward_t30*n_2_x + adjoint_forward_t31*n_2_y + adjoint_forward_t32*n_2_z;
        const lane t44 = eigenvalue*t31;
        const lane t45 = D_p_z_1*t44;
        const lane adjoint_forward_t28 = -eigenvalue*t17 - eigenvalue*t20 - t45;
        const lane t46 = D_p_y_1*t44;
        const lane adjoint_forward_t27 = -eigenvalue*t24 - eigenvalue*t26 - t46;
        const lane t47 = D_p_x_1*t44;
        const lane adjoint_forward_t26 = -eigenvalue*t28 - eigenvalue*t30 - t47;
        const lane adjoint_forward_t25 =
            D_p_x_1*adjoint_forward_t26 + D_p_x_2*adjoint_forward_t37 + D_p_y_1*adjoint_forward_t27
            + D_p_y_2*adjoint_forward_t38 + D_p_z_1*adjoint_forward_t28 + D_p_z_2*adjoint_forward_t39
            - t40*(forward_t55 + forward_t56 + forward_t57);
        const lane adjoint_forward_t24 = adjoint_forward_t25 - t40;
        const lane adjoint_forward_t23 = adjoint_forward_t25 - t32;
        const lane adjoint_forward_t22 = adjoint_forward_t28 - t45;
        const lane adjoint_forward_t21 = adjoint_forward_t27 - t46;
        const lane adjoint_forward_t20 = adjoint_forward_t26 - t47;
        const lane adjoint_forward_t19 =
            adjoint_forward_t20*n_1_x + adjoint_forward_t21*n_1_y + adjoint_forward_t22*n_1_z;
        const lane adjoint_forward_t18 = adjoint_forward_t25 - t44;
        const lane t48 = t31*(-forward_t40 - forward_t41 - forward_t42);
        const lane t49 = t14*(-forward_t52 - forward_t53 - forward_t54);
        const lane t50 = 2.0*shape_2;
        const lane t51 = shape_3*t50;
        const lane adjoint_mu_3 =
            D_p_x_1*adjoint_forward_t43 + D_p_y_1*adjoint_forward_t46 + D_p_z_1*adjoint_forward_t49
            + t13*(-(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3)) + t48 + t49
            + t51*(-D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3 - D_p_z_2*U_3_z_3);
        const lane t52 = t13*(-forward_t55 - forward_t56 - forward_t57);
        const lane adjoint_mu_2 =
            D_p_x_1*adjoint_forward_t44 + D_p_y_1*adjoint_forward_t47 + D_p_z_1*adjoint_forward_t50
            + t14*(-(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2)) + t48 + t51*(-D_p_x_3*U_2_x_2
            - D_p_y_3*U_2_y_2 - D_p_z_3*U_2_z_2) + t52;
        const lane adjoint_mu_1 =
            U_1_x_1*adjoint_forward_t45 + U_1_y_1*adjoint_forward_t48 + U_1_z_1*adjoint_forward_t51
            + t31*(-(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1)) + t49 + t51*(-D_p_x_2*D_p_x_3
            - D_p_y_2*D_p_y_3 - D_p_z_2*D_p_z_3) + t52;
        const lane t53 = adjoint_mu_1*forward_3;
        const lane t54 = adjoint_mu_2*forward_3;
        const lane t55 = adjoint_mu_3*forward_3;
        const lane adjoint_forward_t17 = -A_z_1*t53 - A_z_2*t54 - A_z_3*t55;
        const lane adjoint_forward_t16 = -A_y_1*t53 - A_y_2*t54 - A_y_3*t55;
        const lane adjoint_forward_t15 = -A_x_1*t53 - A_x_2*t54 - A_x_3*t55;
        const lane adjoint_forward_t14 =
            adjoint_forward_t15*g_x + adjoint_forward_t16*g_y + adjoint_forward_t17*g_z;
        const lane t56 = shape_3*t6;
        const lane adjoint_k_3_3 = -R_p_3*t56 + forward_t62*t4 + t13;
        const lane adjoint_forward_12 = adjoint_k_3_3*forward_t12;
        const lane adjoint_l_f_3_3 = -adjoint_forward_12*(forward_12*forward_12);
        const lane t57 = shape_3*shape_9;
        const lane adjoint_k_3_2 = -2.0*R_p_3*t57 + forward_t62*t5 + t13;
        const lane adjoint_forward_11 = adjoint_k_3_2*forward_t12;
        const lane adjoint_l_f_3_2 = -adjoint_forward_11*(forward_11*forward_11);
        const lane adjoint_forward_t13 = -adjoint_l_f_3_2 - adjoint_l_f_3_3;
        const lane adjoint_k_3_1 = adjoint_forward_t63*forward_t62;
        const lane adjoint_forward_10 = adjoint_k_3_1*forward_t12;
        const lane adjoint_forward_t12 =
            adjoint_k_3_1*forward_10 + adjoint_k_3_2*forward_11 + adjoint_k_3_3*forward_12;
        const lane adjoint_l_f_3_1 = -adjoint_forward_10*(forward_10*forward_10);
        const lane t58 = shape_2*t9;
        const lane adjoint_k_2_3 = -R_p_2*t58 + forward_t60*t7 + t14;
        const lane adjoint_forward_9 = adjoint_k_2_3*forward_t10;
        const lane adjoint_l_f_2_3 = -adjoint_forward_9*(forward_9*forward_9);
        const lane adjoint_k_2_2 = -2.0*R_p_2*shape_2*shape_8 + forward_t60*t8 + t14;
        const lane adjoint_forward_8 = adjoint_k_2_2*forward_t10;
        const lane adjoint_l_f_2_2 = -adjoint_forward_8*(forward_8*forward_8);
        const lane adjoint_forward_t11 = -adjoint_l_f_2_2 - adjoint_l_f_2_3;
        const lane adjoint_k_2_1 = adjoint_forward_t61*forward_t60;
        const lane adjoint_forward_7 = adjoint_k_2_1*forward_t10;
        const lane adjoint_forward_t10 =
            adjoint_k_2_1*forward_7 + adjoint_k_2_2*forward_8 + adjoint_k_2_3*forward_9;
        const lane adjoint_l_f_2_1 = -adjoint_forward_7*(forward_7*forward_7);
        const lane t59 = shape_1*t12;
        const lane adjoint_k_1_3 = -R_p_1*t59 + forward_t58*t10 + t31;
        const lane adjoint_forward_6 = adjoint_k_1_3*forward_t8;
        const lane adjoint_l_f_1_3 = -adjoint_forward_6*(forward_6*forward_6);
        const lane t60 = shape_1*shape_7;
        const lane adjoint_k_1_2 = -2.0*R_p_1*t60 + forward_t58*t11 + t31;
        const lane adjoint_forward_5 = adjoint_k_1_2*forward_t8;
        const lane adjoint_l_f_1_2 = -adjoint_forward_5*(forward_5*forward_5);
        const lane adjoint_forward_t9 = -adjoint_l_f_1_2 - adjoint_l_f_1_3;
        const lane adjoint_k_1_1 = adjoint_forward_t59*forward_t58;
        const lane adjoint_forward_4 = adjoint_k_1_1*forward_t8;
        const lane adjoint_forward_t8 =
            adjoint_k_1_1*forward_4 + adjoint_k_1_2*forward_5 + adjoint_k_1_3*forward_6;
        const lane adjoint_l_f_1_1 = -adjoint_forward_4*(forward_4*forward_4);
        const lane adjoint_I_3_2 = -eigenvalue*t5;
        const lane adjoint_I_3_1 = -eigenvalue*t4;
        const lane adjoint_forward_t7 = adjoint_I_3_1*d_3_1 + adjoint_I_3_2*d_3_2;
        const lane adjoint_I_2_2 = -eigenvalue*t8;
        const lane adjoint_I_2_1 = -eigenvalue*t7;
        const lane adjoint_forward_t6 = adjoint_I_2_1*d_2_1 + adjoint_I_2_2*d_2_2;
        const lane adjoint_I_1_2 = -eigenvalue*t11;
        const lane adjoint_I_1_1 = -eigenvalue*t10;
        const lane adjoint_forward_t5 = adjoint_I_1_1*d_1_1 + adjoint_I_1_2*d_1_2;
        const lane t61 = mu_3*t34;
        const lane t63 = 2.0*t13;
        const lane adjoint_U_3_z_3 = -forward_t49*t22 - t15*t61 - t62*t63;
        const lane adjoint_U_3_y_3 = -forward_t46*t22 - t23*t61 - t63*t64;
        const lane adjoint_U_3_x_3 = -forward_t43*t22 - t27*t61 - t63*t65;
        const lane t66 = mu_2*t34;
        const lane t68 = 2.0*t14;
        const lane adjoint_U_2_z_2 = -forward_t50*t21 - t18*t66 - t67*t68;
        const lane adjoint_U_2_y_2 = -forward_t47*t21 - t25*t66 - t68*t69;
        const lane adjoint_U_2_x_2 = -forward_t44*t21 - t29*t66 - t68*t70;
        const lane t71 = 2.0*t31;
        const lane adjoint_U_1_z_1 = adjoint_forward_t51*mu_1 - forward_t51*t71;
        const lane adjoint_U_1_y_1 = adjoint_forward_t48*mu_1 - forward_t48*t71;
        const lane adjoint_U_1_x_1 = adjoint_forward_t45*mu_1 - forward_t45*t71;
        const lane t72 = eigenvalue*forward_t28;
        const lane t73 = eigenvalue*t51;
        const lane adjoint_D_p_z_3 =
            adjoint_U_3_z_3 + adjoint_forward_t57*t18 - forward_t39*t73 - t22*t72 + t22*(-forward_t50
            - forward_t51) - t40*(forward_t25*t18 + t74) + t51*(-D_p_z_2*mu_1 - t67);
        const lane adjoint_D_p_z_2 =
            adjoint_U_2_z_2 + adjoint_forward_t39*forward_t25 + adjoint_forward_t54*t15 - t21*t72
            + t21*(-forward_t49 - forward_t51) - t32*(forward_t32 + forward_t39) - t35*t74
            + t51*(-D_p_z_3*mu_1 - t62);
        const lane t75 = eigenvalue*t21;
        const lane adjoint_D_p_z_1 =
            adjoint_U_1_z_1 + adjoint_forward_t28*forward_t25 + adjoint_forward_t42*t38
            + adjoint_forward_t49*mu_3 + adjoint_forward_t50*mu_2 - forward_t32*t75 - t39*t74
            - t44*(forward_t22 + forward_t28);
        const lane t77 = eigenvalue*t22;
        const lane adjoint_D_p_y_3 =
            adjoint_U_3_y_3 + adjoint_forward_t57*t25 - forward_t27*t77 - forward_t38*t73 + t22*(-forward_t47
            - forward_t48) - t40*(forward_t25*t25 + t76) + t51*(-D_p_y_2*mu_1 - t69);
        const lane adjoint_D_p_y_2 =
            adjoint_U_2_y_2 + adjoint_forward_t38*forward_t25 + adjoint_forward_t54*t23 - forward_t27*t75
            + t21*(-forward_t46 - forward_t48) - t32*(forward_t31 + forward_t38) - t35*t76
            + t51*(-D_p_y_3*mu_1 - t64);
        const lane adjoint_D_p_y_1 =
            adjoint_U_1_y_1 + adjoint_forward_t27*forward_t25 + adjoint_forward_t42*t41
            + adjoint_forward_t46*mu_3 + adjoint_forward_t47*mu_2 - forward_t31*t75 - t39*t76
            - t44*(forward_t21 + forward_t27);
        const lane adjoint_D_p_x_3 =
            adjoint_U_3_x_3 + adjoint_forward_t57*t29 - forward_t26*t77 - forward_t37*t73 + t22*(-forward_t44
            - forward_t45) - t40*(forward_t25*t29 + t78) + t51*(-D_p_x_2*mu_1 - t70);
        const lane adjoint_forward_t4 = A_x_3*adjoint_D_p_x_3 + A_y_3*adjoint_D_p_y_3 + A_z_3*adjoint_D_p_z_3;
        const lane adjoint_D_p_x_2 =
            adjoint_U_2_x_2 + adjoint_forward_t37*forward_t25 + adjoint_forward_t54*t27 - forward_t26*t75
            + t21*(-forward_t43 - forward_t45) - t32*(forward_t30 + forward_t37) - t35*t78
            + t51*(-D_p_x_3*mu_1 - t65);
        const lane adjoint_forward_t3 = A_x_2*adjoint_D_p_x_2 + A_y_2*adjoint_D_p_y_2 + A_z_2*adjoint_D_p_z_2;
        const lane adjoint_D_p_x_1 =
            adjoint_U_1_x_1 + adjoint_forward_t26*forward_t25 + adjoint_forward_t42*t42
            + adjoint_forward_t43*mu_3 + adjoint_forward_t44*mu_2 - forward_t30*t75 - t39*t78
            - t44*(forward_t20 + forward_t26);
        const lane adjoint_forward_t2 = A_x_1*adjoint_D_p_x_1 + A_y_1*adjoint_D_p_y_1 + A_z_1*adjoint_D_p_z_1;
        const lane adjoint_forward_t1 =
            D_r_1*adjoint_forward_t2 + D_r_2*adjoint_forward_t3 + D_r_3*adjoint_forward_t4 + adjoint_mu_1*t1
            + adjoint_mu_2*t2 + adjoint_mu_3*t3;
        const lane adjoint_det_D_l = -adjoint_forward_t1*(forward_3*forward_3);
        const lane adjoint_A_z_3 = adjoint_D_p_z_3*forward_t4 - forward_t17*t55;
        const lane adjoint_A_y_3 = adjoint_D_p_y_3*forward_t4 - forward_t16*t55;
        const lane adjoint_A_x_3 = adjoint_D_p_x_3*forward_t4 - forward_t15*t55;
        const lane adjoint_A_z_2 = adjoint_D_p_z_2*forward_t3 - forward_t17*t54;
        const lane adjoint_A_y_2 = adjoint_D_p_y_2*forward_t3 - forward_t16*t54;
        const lane adjoint_A_x_2 = adjoint_D_p_x_2*forward_t3 - forward_t15*t54;
        const lane adjoint_A_z_1 = adjoint_D_p_z_1*forward_t2 + adjoint_det_D_l*s_1_z - forward_t17*t53;
        const lane adjoint_A_y_1 = adjoint_D_p_y_1*forward_t2 + adjoint_det_D_l*s_1_y - forward_t16*t53;
        const lane adjoint_A_x_1 = adjoint_D_p_x_1*forward_t2 + adjoint_det_D_l*s_1_x - forward_t15*t53;
        const lane adjoint_D_r_3 = adjoint_forward_t4*forward_3;
        const lane adjoint_D_r_2 = adjoint_forward_t3*forward_3;
        const lane adjoint_D_r_1 = adjoint_forward_t2*forward_3;
        const lane adjoint_s_3_z =
            adjoint_A_x_1*s_2_y - adjoint_A_x_2*s_1_y - adjoint_A_y_1*s_2_x + adjoint_A_y_2*s_1_x
            + adjoint_D_r_3*n_3_z;
        const lane adjoint_s_3_y =
            -adjoint_A_x_1*s_2_z + adjoint_A_x_2*s_1_z + adjoint_A_z_1*s_2_x - adjoint_A_z_2*s_1_x
            + adjoint_D_r_3*n_3_y;
        const lane adjoint_s_3_x =
            adjoint_A_y_1*s_2_z - adjoint_A_y_2*s_1_z - adjoint_A_z_1*s_2_y + adjoint_A_z_2*s_1_y
            + adjoint_D_r_3*n_3_x;
        const lane adjoint_s_2_z =
            -adjoint_A_x_1*s_3_y + adjoint_A_x_3*s_1_y + adjoint_A_y_1*s_3_x - adjoint_A_y_3*s_1_x
            + adjoint_D_r_2*n_2_z;
        const lane adjoint_s_2_y =
            adjoint_A_x_1*s_3_z - adjoint_A_x_3*s_1_z - adjoint_A_z_1*s_3_x + adjoint_A_z_3*s_1_x
            + adjoint_D_r_2*n_2_y;
        const lane adjoint_s_2_x =
            -adjoint_A_y_1*s_3_z + adjoint_A_y_3*s_1_z + adjoint_A_z_1*s_3_y - adjoint_A_z_3*s_1_y
            + adjoint_D_r_2*n_2_x;
        const lane adjoint_s_1_z =
            A_z_1*adjoint_det_D_l + adjoint_A_x_2*s_3_y - adjoint_A_x_3*s_2_y - adjoint_A_y_2*s_3_x
            + adjoint_A_y_3*s_2_x + adjoint_D_r_1*n_1_z;
        const lane adjoint_s_1_y =
            A_y_1*adjoint_det_D_l - adjoint_A_x_2*s_3_z + adjoint_A_x_3*s_2_z + adjoint_A_z_2*s_3_x
            - adjoint_A_z_3*s_2_x + adjoint_D_r_1*n_1_y;
        const lane adjoint_s_1_x =
            A_x_1*adjoint_det_D_l + adjoint_A_y_2*s_3_z - adjoint_A_y_3*s_2_z - adjoint_A_z_2*s_3_y
            + adjoint_A_z_3*s_2_y + adjoint_D_r_1*n_1_x;
        const lane adjoint_x_3 =
            adjoint_l_f_3_2 - adjoint_l_f_3_3 - adjoint_s_3_x*n_3_x - adjoint_s_3_y*n_3_y
            - adjoint_s_3_z*n_3_z;
        const lane adjoint_forward_2 = adjoint_x_3*sigma_3;
        const lane t79 = adjoint_forward_2/forward_2;
        const lane adjoint_w2_3 = -1.0/2.0*t79;
        const lane t80 = 2.0*adjoint_w2_3;
        const lane adjoint_w_3_z = t80*w_3_z;
        const lane adjoint_w_3_y = t80*w_3_y;
        const lane adjoint_w_3_x = t80*w_3_x;
        const lane adjoint_a_3 =
            -adjoint_w_3_x*n_3_x - adjoint_w_3_y*n_3_y - adjoint_w_3_z*n_3_z + adjoint_x_3;
        const lane adjoint_x_2 =
            adjoint_l_f_2_2 - adjoint_l_f_2_3 - adjoint_s_2_x*n_2_x - adjoint_s_2_y*n_2_y
            - adjoint_s_2_z*n_2_z;
        const lane adjoint_forward_1 = adjoint_x_2*sigma_2;
        const lane t81 = adjoint_forward_1/forward_1;
        const lane adjoint_w2_2 = -1.0/2.0*t81;
        const lane t82 = 2.0*adjoint_w2_2;
        const lane adjoint_w_2_z = t82*w_2_z;
        const lane adjoint_w_2_y = t82*w_2_y;
        const lane adjoint_w_2_x = t82*w_2_x;
        const lane adjoint_a_2 =
            -adjoint_w_2_x*n_2_x - adjoint_w_2_y*n_2_y - adjoint_w_2_z*n_2_z + adjoint_x_2;
        const lane adjoint_x_1 =
            adjoint_l_f_1_2 - adjoint_l_f_1_3 - adjoint_s_1_x*n_1_x - adjoint_s_1_y*n_1_y
            - adjoint_s_1_z*n_1_z;
        const lane adjoint_forward_0 = adjoint_x_1*sigma_1;
        const lane t83 = adjoint_forward_0/forward_0;
        const lane adjoint_w2_1 = -1.0/2.0*t83;
        const lane t84 = 2.0*adjoint_w2_1;
        const lane adjoint_w_1_z = t84*w_1_z;
        const lane adjoint_w_1_y = t84*w_1_y;
        const lane adjoint_w_1_x = t84*w_1_x;
        const lane adjoint_a_1 =
            -adjoint_w_1_x*n_1_x - adjoint_w_1_y*n_1_y - adjoint_w_1_z*n_1_z + adjoint_x_1;
        const lane adjoint_r_3_z = adjoint_a_3*n_3_z + adjoint_s_3_z + adjoint_w_3_z;
        const lane adjoint_r_3_y = adjoint_a_3*n_3_y + adjoint_s_3_y + adjoint_w_3_y;
        const lane adjoint_r_3_x = adjoint_a_3*n_3_x + adjoint_s_3_x + adjoint_w_3_x;
        const lane adjoint_r_2_z = adjoint_a_2*n_2_z + adjoint_s_2_z + adjoint_w_2_z;
        const lane adjoint_r_2_y = adjoint_a_2*n_2_y + adjoint_s_2_y + adjoint_w_2_y;
        const lane adjoint_r_2_x = adjoint_a_2*n_2_x + adjoint_s_2_x + adjoint_w_2_x;
        const lane adjoint_r_1_z = adjoint_a_1*n_1_z + adjoint_s_1_z + adjoint_w_1_z;
        const lane adjoint_r_1_y = adjoint_a_1*n_1_y + adjoint_s_1_y + adjoint_w_1_y;
        const lane adjoint_r_1_x = adjoint_a_1*n_1_x + adjoint_s_1_x + adjoint_w_1_x;
        const lane t85 = (1.0/2.0)*adjoint_forward_t14;
        lanes_clear(gradient, 102);
        gradient[0] = LANES(adjoint_forward_t14 + adjoint_forward_t25);
        gradient[1] = LANES(adjoint_forward_t15*forward_t14);
        gradient[2] = LANES(adjoint_forward_t16*forward_t14);
        gradient[3] = LANES(adjoint_forward_t17*forward_t14);
        gradient[4] = LANES(-adjoint_r_1_x);
        gradient[5] = LANES(-adjoint_r_1_y);
        gradient[6] = LANES(-adjoint_r_1_z);
        gradient[7] = LANES(-adjoint_r_2_x);
        gradient[8] = LANES(-adjoint_r_2_y);
        gradient[9] = LANES(-adjoint_r_2_z);
        gradient[10] = LANES(-adjoint_r_3_x);
        gradient[11] = LANES(-adjoint_r_3_y);
        gradient[12] = LANES(-adjoint_r_3_z);
        gradient[22] = LANES(adjoint_r_1_x);
        gradient[23] = LANES(adjoint_r_1_y);
        gradient[24] = LANES(adjoint_r_1_z);
        gradient[25] = LANES(adjoint_r_2_x);
        gradient[26] = LANES(adjoint_r_2_y);
        gradient[27] = LANES(adjoint_r_2_z);
        gradient[28] = LANES(adjoint_r_3_x);
        gradient[29] = LANES(adjoint_r_3_y);
        gradient[30] = LANES(adjoint_r_3_z);
        gradient[31] = LANES(l_d_1*t83);
        gradient[32] = LANES(l_d_2*t81);
        gradient[33] = LANES(l_d_3*t79);
        gradient[34] = LANES((1.0/3.0)*adjoint_forward_t18 + (1.0/6.0)*adjoint_forward_t19 + t85);
        gradient[35] = LANES((1.0/3.0)*adjoint_forward_t23 + (1.0/6.0)*adjoint_forward_t29 + t85);
        gradient[36] = LANES((1.0/3.0)*adjoint_forward_t24 + (1.0/6.0)*adjoint_forward_t33 + t85);
        gradient[37] = LANES(-t44);
        gradient[38] = LANES(-t32);
        gradient[39] = LANES(-t40);
        gradient[40] = LANES((1.0/2.0)*adjoint_forward_t9);
        gradient[41] = LANES((1.0/2.0)*adjoint_forward_t11);
        gradient[42] = LANES((1.0/2.0)*adjoint_forward_t13);
        gradient[43] = LANES(adjoint_forward_t8*w_b_1);
        gradient[44] = LANES(adjoint_forward_t10*w_b_2);
        gradient[45] = LANES(adjoint_forward_t12*w_b_3);
        gradient[46] = LANES(adjoint_forward_t8*k_sp_1);
        gradient[47] = LANES(adjoint_forward_t10*k_sp_2);
        gradient[48] = LANES(adjoint_forward_t12*k_sp_3);
        gradient[49] = LANES(2.0*R_p_1*adjoint_forward_t58 - 2.0*k_1_2*t60 - k_1_3*t59);
        gradient[50] = LANES(2.0*R_p_2*adjoint_forward_t60 - k_2_2*shape_8*t50 - k_2_3*t58);
        gradient[51] = LANES(2.0*R_p_3*adjoint_forward_t62 - 2.0*k_3_2*t57 - k_3_3*t56);
        gradient[52] = LANES(adjoint_I_1_1 + adjoint_I_1_2);
        gradient[53] = LANES(adjoint_I_2_1 + adjoint_I_2_2);
        gradient[54] = LANES(adjoint_I_3_1 + adjoint_I_3_2);
        gradient[55] = LANES(adjoint_forward_t5*(i_g_1*i_g_1));
        gradient[56] = LANES(adjoint_forward_t6*(i_g_2*i_g_2));
        gradient[57] = LANES(adjoint_forward_t7*(i_g_3*i_g_3));
        gradient[58] = LANES(2.0*I_m_1*adjoint_forward_t5*i_g_1);
        gradient[59] = LANES(2.0*I_m_2*adjoint_forward_t6*i_g_2);
        gradient[60] = LANES(2.0*I_m_3*adjoint_forward_t7*i_g_3);
        gradient[67] = LANES(-adjoint_l_f_1_1 - adjoint_l_f_1_2);
        gradient[68] = LANES(adjoint_l_f_1_1 + adjoint_l_f_1_3);
        gradient[69] = LANES(-adjoint_l_f_2_1 - adjoint_l_f_2_2);
        gradient[70] = LANES(adjoint_l_f_2_1 + adjoint_l_f_2_3);
        gradient[71] = LANES(-adjoint_l_f_3_1 - adjoint_l_f_3_2);
        gradient[72] = LANES(adjoint_l_f_3_1 + adjoint_l_f_3_3);
        gradient[99] = LANES(adjoint_r_1_x + adjoint_r_2_x + adjoint_r_3_x);
        gradient[100] = LANES(adjoint_r_1_y + adjoint_r_2_y + adjoint_r_3_y);
        gradient[101] = LANES(adjoint_r_1_z + adjoint_r_2_z + adjoint_r_3_z);
    }
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through extended.
 * 2681 operations; 1676809877 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_gradient(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int modes, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
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
    const double rho_b = effects[5];
    const double c_T = effects[6];
    const double F_T = effects[7];
    const double k_C = effects[8];
    const double m_L = effects[11];
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
    const lane forward_0 = lanes_sqrt((l_d_1*l_d_1) - w2_1);
    const lane x_1 = a_1 + forward_0*sigma_1;
    const lane a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const lane w_2_x = -a_2*n_2_x + r_2_x;
    const lane w_2_y = -a_2*n_2_y + r_2_y;
    const lane w_2_z = -a_2*n_2_z + r_2_z;
    const lane w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const lane forward_1 = lanes_sqrt((l_d_2*l_d_2) - w2_2);
    const lane x_2 = a_2 + forward_1*sigma_2;
    const lane a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const lane w_3_x = -a_3*n_3_x + r_3_x;
    const lane w_3_y = -a_3*n_3_y + r_3_y;
    const lane w_3_z = -a_3*n_3_z + r_3_z;
    const lane w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const lane forward_2 = lanes_sqrt((l_d_3*l_d_3) - w2_3);
    const lane x_3 = a_3 + forward_2*sigma_3;
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
    const lane forward_3 = 1.0/det_D_l;
    const lane forward_t2 = A_x_1*forward_3;
    const lane D_p_x_1 = D_r_1*forward_t2;
    const lane forward_t3 = A_x_2*forward_3;
    const lane D_p_x_2 = D_r_2*forward_t3;
    const lane forward_t4 = A_x_3*forward_3;
    const lane D_p_x_3 = D_r_3*forward_t4;
    const lane D_delta_x_1 = forward_t2*l_d_1;
    const lane D_delta_x_2 = forward_t3*l_d_2;
    const lane D_delta_x_3 = forward_t4*l_d_3;
    const lane forward_t5 = A_y_1*forward_3;
    const lane D_p_y_1 = D_r_1*forward_t5;
    const lane forward_t6 = A_y_2*forward_3;
    const lane D_p_y_2 = D_r_2*forward_t6;
    const lane forward_t7 = A_y_3*forward_3;
    const lane D_p_y_3 = D_r_3*forward_t7;
    const lane D_delta_y_1 = forward_t5*l_d_1;
    const lane D_delta_y_2 = forward_t6*l_d_2;
    const lane D_delta_y_3 = forward_t7*l_d_3;
    const lane forward_t8 = A_z_1*forward_3;
    const lane D_p_z_1 = D_r_1*forward_t8;
    const lane forward_t9 = A_z_2*forward_3;
    const lane D_p_z_2 = D_r_2*forward_t9;
    const lane forward_t10 = A_z_3*forward_3;
    const lane D_p_z_3 = D_r_3*forward_t10;
    const lane D_delta_z_1 = forward_t8*l_d_1;
    const lane D_delta_z_2 = forward_t9*l_d_2;
    const lane D_delta_z_3 = forward_t10*l_d_3;
    const lane U_1_x_1 = D_p_x_1 - n_1_x;
    const lane U_1_y_1 = D_p_y_1 - n_1_y;
    const lane U_1_z_1 = D_p_z_1 - n_1_z;
    const lane U_2_x_2 = D_p_x_2 - n_2_x;
    const lane U_2_y_2 = D_p_y_2 - n_2_y;
    const lane U_2_z_2 = D_p_z_2 - n_2_z;
    const lane U_3_x_3 = D_p_x_3 - n_3_x;
    const lane U_3_y_3 = D_p_y_3 - n_3_y;
    const lane U_3_z_3 = D_p_z_3 - n_3_z;
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double forward_t17 = F_T*c_T + 1.0;
    const double forward_t18 = c_E*forward_t17;
    const double t1 = a_B_1 + 1.0;
    const double t2 = t1*w_b_1;
    const double forward_t19 = k_sp_1*t2;
    const double forward_t20 = forward_t18*forward_t19;
    const double forward_t21 = forward_t17*forward_t19;
    const double t3 = forward_t20 + l_f_1_1;
    const double forward_4 = 1.0/t3;
    const double k_1_1 = forward_4*forward_t21;
    const double forward_t22 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -forward_t22 + x_1 - x_min_1;
    const lane t4 = forward_t20 + l_f_1_2;
    const lane forward_5 = 1.0/t4;
    const lane k_1_2 = forward_5*forward_t21;
    const lane l_f_1_3 = -forward_t22 - x_1 + x_max_1;
    const lane t5 = forward_t20 + l_f_1_3;
    const lane forward_6 = 1.0/t5;
    const lane k_1_3 = forward_6*forward_t21;
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double t6 = a_B_2 + 1.0;
    const double t7 = t6*w_b_2;
    const double forward_t23 = k_sp_2*t7;
    const double forward_t24 = forward_t18*forward_t23;
    const double forward_t25 = forward_t17*forward_t23;
    const double t8 = forward_t24 + l_f_2_1;
    const double forward_7 = 1.0/t8;
    const double k_2_1 = forward_7*forward_t25;
    const double forward_t26 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -forward_t26 + x_2 - x_min_2;
    const lane t9 = forward_t24 + l_f_2_2;
    const lane forward_8 = 1.0/t9;
    const lane k_2_2 = forward_8*forward_t25;
    const lane l_f_2_3 = -forward_t26 - x_2 + x_max_2;
    const lane t10 = forward_t24 + l_f_2_3;
    const lane forward_9 = 1.0/t10;
    const lane k_2_3 = forward_9*forward_t25;
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double t11 = a_B_3 + 1.0;
    const double t12 = t11*w_b_3;
    const double forward_t27 = k_sp_3*t12;
    const double forward_t28 = forward_t18*forward_t27;
    const double forward_t29 = forward_t17*forward_t27;
    const double t13 = forward_t28 + l_f_3_1;
    const double forward_10 = 1.0/t13;
    const double k_3_1 = forward_10*forward_t29;
    const double forward_t30 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -forward_t30 + x_3 - x_min_3;
    const lane t14 = forward_t28 + l_f_3_2;
    const lane forward_11 = 1.0/t14;
    const lane k_3_2 = forward_11*forward_t29;
    const lane l_f_3_3 = -forward_t30 - x_3 + x_max_3;
    const lane t15 = forward_t28 + l_f_3_3;
    const lane forward_12 = 1.0/t15;
    const lane k_3_3 = forward_12*forward_t29;
    const double forward_t31 = (1.0/2.0)*m_d_1;
    const double forward_t32 = (1.0/2.0)*m_d_2;
    const double forward_t33 = (1.0/2.0)*m_d_3;
    const double forward_t34 = m_L + m_p;
    const double forward_t35 = forward_t31 + forward_t32 + forward_t33 + forward_t34;
    const double forward_t36 = forward_t35*g_x;
    const double forward_t37 = forward_t35*g_y;
    const double forward_t38 = forward_t35*g_z;
    const lane t16 = -A_x_1*forward_t36 - A_y_1*forward_t37 - A_z_1*forward_t38;
    const lane mu_1 = forward_3*t16;
    const lane t17 = -A_x_2*forward_t36 - A_y_2*forward_t37 - A_z_2*forward_t38;
    const lane mu_2 = forward_3*t17;
    const lane t18 = -A_x_3*forward_t36 - A_y_3*forward_t37 - A_z_3*forward_t38;
    const lane mu_3 = forward_3*t18;
    const double forward_t39 = (1.0/3.0)*m_d_1;
    const double forward_t40 = (1.0/6.0)*m_d_1;
    const double forward_t41 = forward_t40*n_1_x;
    const double forward_t42 = (1.0/3.0)*m_d_2;
    const double forward_t43 = (1.0/3.0)*m_d_3;
    const double forward_t44 = forward_t34 + forward_t39 + forward_t42 + forward_t43;
    const lane forward_t45 = D_p_x_1*forward_t44;
    const lane forward_t46 = forward_t41 + forward_t45;
    const double forward_t47 = forward_t40*n_1_y;
    const lane forward_t48 = D_p_y_1*forward_t44;
    const lane forward_t49 = forward_t47 + forward_t48;
    const double forward_t50 = forward_t40*n_1_z;
    const lane forward_t51 = D_p_z_1*forward_t44;
    const lane forward_t52 = forward_t50 + forward_t51;
    const double forward_t53 = (1.0/3.0)*rho_b;
    const lane forward_t54 = forward_t53*l_f_1_2;
    const lane forward_t55 = forward_t53*l_f_1_3;
    const double forward_t57 = (1.0/6.0)*m_d_2;
    const double forward_t58 = forward_t57*n_2_x;
    const double forward_t59 = forward_t57*n_2_y;
    const double forward_t60 = forward_t57*n_2_z;
    const double forward_t61 = (1.0/6.0)*m_d_3;
    const double forward_t62 = forward_t61*n_3_x;
    const double forward_t63 = forward_t61*n_3_y;
    const double forward_t64 = forward_t61*n_3_z;
    const double forward_t65 = (1.0/6.0)*rho_b;
    const double forward_t66 = R_p_1*forward_t65;
    const double forward_t69 = forward_t40 + forward_t57 + forward_t61;
    const lane forward_t70 = D_p_x_2*forward_t44;
    const lane forward_t71 = forward_t58 + forward_t70;
    const lane forward_t72 = D_p_y_2*forward_t44;
    const lane forward_t73 = forward_t59 + forward_t72;
    const lane forward_t74 = D_p_z_2*forward_t44;
    const lane forward_t75 = forward_t60 + forward_t74;
    const lane forward_t76 = forward_t53*l_f_2_2;
    const lane forward_t77 = forward_t53*l_f_2_3;
    const double forward_t79 = R_p_2*forward_t65;
    const lane forward_t82 = D_p_x_3*forward_t44;
    const lane forward_t83 = forward_t62 + forward_t82;
    const lane forward_t84 = D_p_y_3*forward_t44;
    const lane forward_t85 = forward_t63 + forward_t84;
    const lane forward_t86 = D_p_z_3*forward_t44;
    const lane forward_t87 = forward_t64 + forward_t86;
    const lane forward_t88 = forward_t53*l_f_3_2;
    const lane forward_t89 = forward_t53*l_f_3_3;
    const double forward_t91 = R_p_3*forward_t65;
    const double forward_t94 = (R_p_1*R_p_1);
    const double forward_t95 = forward_t94*l_f_1_1;
    const double forward_t98 = (R_p_2*R_p_2);
    const double forward_t99 = forward_t98*l_f_2_1;
    const double forward_t102 = (R_p_3*R_p_3);
    const double forward_t103 = forward_t102*l_f_3_1;
    const lane forward_t109 = (D_delta_x_1*D_delta_x_1);
    const lane forward_t110 = (D_delta_y_1*D_delta_y_1);
    const lane forward_t111 = (D_delta_z_1*D_delta_z_1);
    const lane forward_t112 = D_delta_x_1*forward_t44;
    const lane forward_t113 = D_delta_y_1*forward_t44;
    const lane forward_t114 = D_delta_z_1*forward_t44;
    const lane forward_t115 = (D_delta_x_2*D_delta_x_2);
    const lane forward_t116 = (D_delta_y_2*D_delta_y_2);
    const lane forward_t117 = (D_delta_z_2*D_delta_z_2);
    const lane forward_t118 = D_delta_x_2*forward_t44;
    const lane forward_t119 = D_delta_y_2*forward_t44;
    const lane forward_t120 = D_delta_z_2*forward_t44;
    const lane forward_t121 = (D_delta_x_3*D_delta_x_3);
    const lane forward_t122 = (D_delta_y_3*D_delta_y_3);
    const lane forward_t123 = (D_delta_z_3*D_delta_z_3);
    const lane forward_t125 = (D_p_x_1*D_p_x_1);
    const lane forward_t126 = (D_p_y_1*D_p_y_1);
    const lane forward_t127 = (D_p_z_1*D_p_z_1);
    const lane forward_t128 = D_p_x_1*mu_3;
    const lane forward_t129 = D_p_x_1*mu_2;
    const lane forward_t130 = U_1_x_1*mu_1;
    const lane forward_t131 = D_p_y_1*mu_3;
    const lane forward_t132 = D_p_y_1*mu_2;
    const lane forward_t133 = U_1_y_1*mu_1;
    const lane forward_t134 = D_p_z_1*mu_3;
    const lane forward_t135 = D_p_z_1*mu_2;
    const lane forward_t136 = U_1_z_1*mu_1;
    const lane forward_t140 = (D_p_x_2*D_p_x_2);
    const lane forward_t141 = (D_p_y_2*D_p_y_2);
    const lane forward_t142 = (D_p_z_2*D_p_z_2);
    const lane forward_t143 = D_p_x_2*mu_1;
    const lane forward_t144 = D_p_x_2*mu_3;
    const lane forward_t145 = U_2_x_2*mu_2;
    const lane forward_t146 = D_p_y_2*mu_1;
    const lane forward_t147 = D_p_y_2*mu_3;
    const lane forward_t148 = U_2_y_2*mu_2;
    const lane forward_t149 = D_p_z_2*mu_1;
    const lane forward_t150 = D_p_z_2*mu_3;
    const lane forward_t151 = U_2_z_2*mu_2;
    const lane forward_t155 = (D_p_x_3*D_p_x_3);
    const lane forward_t156 = (D_p_y_3*D_p_y_3);
    const lane forward_t157 = (D_p_z_3*D_p_z_3);
    const lane forward_t160 = D_delta_x_1*D_p_x_3;
    const lane forward_t161 = U_3_x_3*mu_3;
    const lane forward_t162 = D_delta_y_1*D_p_y_3;
    const lane forward_t163 = U_3_y_3*mu_3;
    const lane forward_t164 = D_delta_z_1*D_p_z_3;
    const lane forward_t165 = U_3_z_3*mu_3;
    const lane forward_t166 = D_delta_x_2*D_p_x_3;
    const lane forward_t167 = D_delta_y_2*D_p_y_3;
    const lane forward_t168 = D_delta_z_2*D_p_z_3;
    const lane forward_t169 = D_delta_x_3*D_p_x_3;
    const lane forward_t170 = D_delta_y_3*D_p_y_3;
    const lane forward_t171 = D_delta_z_3*D_p_z_3;
    const lane forward_t182 = D_delta_x_1*D_delta_x_2;
    const lane forward_t183 = D_delta_y_1*D_delta_y_2;
    const lane forward_t184 = D_delta_z_1*D_delta_z_2;
    const lane forward_t185 = D_delta_x_1*D_delta_x_3;
    const lane forward_t186 = D_delta_y_1*D_delta_y_3;
    const lane forward_t187 = D_delta_z_1*D_delta_z_3;
    const lane forward_t188 = D_delta_x_2*D_delta_x_3;
    const lane forward_t189 = D_delta_y_2*D_delta_y_3;
    const lane forward_t190 = D_delta_z_2*D_delta_z_3;
    const lane t20 = mu_1 + mu_2;
    const lane t21 = mu_3 + t20;
    const lane t97 = -k_C + mu_3;
    const lane t134 = k_C - t21;
    const lane t137 = 2.0*D_delta_z_3;
    const lane t141 = 2.0*D_delta_y_3;
    const lane t144 = 2.0*D_delta_x_3;
    const lane t149 = 2.0*D_delta_z_2;
    const lane t153 = 2.0*D_delta_y_2;
    const lane t156 = 2.0*D_delta_x_2;
    const lane t185 = 2.0*D_delta_x_1;
    const lane t191 = 2.0*D_delta_y_1;
    const lane t197 = 2.0*D_delta_z_1;
    const lane t214 = forward_t109 + forward_t110 + forward_t111;
    const lane t216 = forward_t115 + forward_t116 + forward_t117;
    const lane t218 = forward_t121 + forward_t122 + forward_t123;
    const lane t220 = forward_t125 + forward_t126 + forward_t127;
    const lane t227 = forward_t140 + forward_t141 + forward_t142;
    const lane t229 = forward_t155 + forward_t156 + forward_t157;
    const lane t258 = D_p_z_3*k_C;
    const lane t259 = -forward_t165 + t258;
    const lane t260 = -D_p_z_1*k_C + forward_t136;
    const lane t261 = forward_t135 + t260;
    const lane t262 = -forward_t134 - t261;
    const lane t263 = -D_p_z_2*k_C + forward_t149 + forward_t151;
    const lane t264 = -forward_t150 - t263;
    const lane t272 = D_p_y_3*k_C;
    const lane t273 = -forward_t163 + t272;
    const lane t274 = -D_p_y_1*k_C + forward_t133;
    const lane t275 = forward_t132 + t274;
    const lane t276 = -forward_t131 - t275;
    const lane t277 = -D_p_y_2*k_C + forward_t146 + forward_t148;
    const lane t278 = -forward_t147 - t277;
    const lane t283 = D_p_x_3*k_C;
    const lane t284 = -forward_t161 + t283;
    const lane t285 = -D_p_x_1*k_C + forward_t130;
    const lane t286 = forward_t129 + t285;
    const lane t287 = -forward_t128 - t286;
    const lane t288 = -D_p_x_2*k_C + forward_t143 + forward_t145;
    const lane t289 = -forward_t144 - t288;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 21;
        const lane eigenvalue = eigenvalues[mode];
        lane *restrict gradient = gradients + mode * stride;
        const lane shape_1 = shape[0];
        const lane shape_2 = shape[1];
        const lane shape_3 = shape[2];
        const lane shape_4 = shape[3];
        const lane shape_5 = shape[4];
        const lane shape_6 = shape[5];
        const lane shape_7 = shape[6];
        const lane shape_8 = shape[7];
        const lane shape_9 = shape[8];
        const lane shape_10 = shape[9];
        const lane shape_11 = shape[10];
        const lane shape_12 = shape[11];
        const lane shape_13 = shape[12];
        const lane shape_14 = shape[13];
        const lane shape_15 = shape[14];
        const lane shape_16 = shape[15];
        const lane shape_17 = shape[16];
        const lane shape_18 = shape[17];
        const lane shape_19 = shape[18];
        const lane shape_20 = shape[19];
        const lane shape_21 = shape[20];
        const lane t19 = 2.0*shape_14;
        const lane t22 = -shape_15*t21;
        const lane adjoint_forward_t190 = t19*t22;
        const lane t23 = 2.0*shape_13;
        const lane adjoint_forward_t187 = t22*t23;
        const lane t24 = shape_13*t19;
        const lane adjoint_forward_t184 = -t21*t24;
        const lane t25 = (shape_12*shape_12);
        const lane t26 = (shape_9*shape_9);
        const lane t27 = 2.0*shape_9;
        const lane t28 = shape_12*t27;
        const lane adjoint_forward_t181 = t25 + t26 + t28;
        const lane t29 = (shape_11*shape_11);
        const lane t30 = (shape_8*shape_8);
        const lane t31 = 2.0*shape_8;
        const lane t32 = shape_11*t31;
        const lane adjoint_forward_t180 = t29 + t30 + t32;
        const lane t33 = (shape_10*shape_10);
        const lane t34 = (shape_7*shape_7);
        const lane t35 = 2.0*shape_7;
        const lane t36 = shape_10*t35;
        const lane adjoint_forward_t179 = t33 + t34 + t36;
        const lane t37 = (shape_6*shape_6);
        const lane t38 = shape_6*t27;
        const lane adjoint_forward_t178 = t26 + t37 - t38;
        const lane t39 = 2.0*shape_6;
        const lane t40 = shape_12*t39;
        const lane adjoint_forward_t177 = t25 + t37 + t40;
        const lane t41 = (shape_5*shape_5);
        const lane t42 = shape_5*t31;
        const lane adjoint_forward_t176 = t30 + t41 - t42;
        const lane t43 = 2.0*shape_5;
        const lane t44 = shape_11*t43;
        const lane adjoint_forward_t175 = t29 + t41 + t44;
        const lane t45 = (shape_4*shape_4);
        const lane t46 = shape_4*t35;
        const lane adjoint_forward_t174 = t34 + t45 - t46;
        const lane t47 = 2.0*shape_4;
        const lane t48 = shape_10*t47;
        const lane adjoint_forward_t173 = t33 + t45 + t48;
        const lane t49 = (shape_18*shape_18);
        const lane t50 = 2.0*shape_3;
        const lane t51 = shape_18*t50;
        const lane adjoint_forward_t172 = t49 + t51;
        const lane t52 = -t20*t50;
        const lane adjoint_forward_t171 = shape_15*t52;
        const lane adjoint_forward_t168 = shape_14*t52;
        const lane t53 = shape_13*t50;
        const lane t54 = D_delta_z_1*t53;
        const lane t55 = shape_14*t50;
        const lane t56 = D_delta_z_2*t55;
        const lane t57 = shape_15*t50;
        const lane t58 = D_delta_z_3*t57;
        const lane adjoint_forward_t165 = -t54 - t56 - t58;
        const lane adjoint_forward_t164 = shape_13*t52;
        const lane t59 = D_delta_y_1*t53;
        const lane t60 = D_delta_y_2*t55;
        const lane t61 = D_delta_y_3*t57;
        const lane adjoint_forward_t163 = -t59 - t60 - t61;
        const lane t62 = D_delta_x_1*t53;
        const lane t63 = D_delta_x_2*t55;
        const lane t64 = D_delta_x_3*t57;
        const lane adjoint_forward_t161 = -t62 - t63 - t64;
        const lane t65 = shape_18*t27;
        const lane t66 = shape_3*t27;
        const lane adjoint_forward_t159 = t65 + t66;
        const lane t67 = shape_18*t39;
        const lane t68 = shape_3*t39;
        const lane adjoint_forward_t158 = t67 + t68;
        const lane t69 = (shape_3*shape_3);
        const lane adjoint_forward_t157 = t69*(k_C - t20);
        const lane t70 = (shape_17*shape_17);
        const lane t71 = 2.0*shape_2;
        const lane t72 = shape_17*t71;
        const lane adjoint_forward_t154 = t70 + t72;
        const lane t73 = shape_17*t31;
        const lane t74 = shape_2*t31;
        const lane adjoint_forward_t153 = t73 + t74;
        const lane t75 = shape_17*t43;
        const lane t76 = shape_2*t43;
        const lane adjoint_forward_t152 = t75 + t76;
        const lane t77 = shape_2*t50;
        const lane t78 = D_p_z_3*t77;
        const lane t79 = shape_13*t71;
        const lane t80 = D_delta_z_1*t79;
        const lane t81 = shape_14*t71;
        const lane t82 = D_delta_z_2*t81;
        const lane t83 = shape_15*t71;
        const lane t84 = D_delta_z_3*t83;
        const lane t85 = t80 + t82 + t84;
        const lane adjoint_forward_t151 = -t78 - t85;
        const lane adjoint_forward_t150 = -U_3_z_3*t77 - t85;
        const lane t86 = D_p_y_3*t77;
        const lane t87 = D_delta_y_1*t79;
        const lane t88 = D_delta_y_2*t81;
        const lane t89 = D_delta_y_3*t83;
        const lane t90 = t87 + t88 + t89;
        const lane adjoint_forward_t148 = -t86 - t90;
        const lane adjoint_forward_t147 = -U_3_y_3*t77 - t90;
        const lane t91 = D_p_x_3*t77;
        const lane t92 = D_delta_x_1*t79;
        const lane t93 = D_delta_x_2*t81;
        const lane t94 = D_delta_x_3*t83;
        const lane t95 = t92 + t93 + t94;
        const lane adjoint_forward_t145 = -t91 - t95;
        const lane adjoint_forward_t144 = -U_3_x_3*t77 - t95;
        const lane t96 = (shape_2*shape_2);
        const lane adjoint_forward_t142 = t96*(-mu_1 - t97);
        const lane t98 = (shape_16*shape_16);
        const lane t99 = 2.0*shape_1;
        const lane t100 = shape_16*t99;
        const lane adjoint_forward_t139 = t100 + t98;
        const lane t101 = shape_1*t35;
        const lane t102 = shape_16*t35;
        const lane adjoint_forward_t138 = t101 + t102;
        const lane t103 = shape_1*t47;
        const lane t104 = shape_16*t47;
        const lane adjoint_forward_t137 = t103 + t104;
        const lane t105 = shape_1*t71;
        const lane t106 = D_p_z_2*t105;
        const lane t107 = shape_13*t99;
        const lane t108 = D_delta_z_1*t107;
        const lane t109 = shape_14*t99;
        const lane t110 = D_delta_z_2*t109;
        const lane t111 = shape_15*t99;
        const lane t112 = D_delta_z_3*t111;
        const lane t113 = shape_1*t50;
        const lane t114 = D_p_z_3*t113;
        const lane t115 = t108 + t110 + t112 + t114;
        const lane adjoint_forward_t136 = -t106 - t115;
        const lane adjoint_forward_t135 = -U_2_z_2*t105 - t115;
        const lane adjoint_forward_t134 = -U_3_z_3*t113 - t106 - t108 - t110 - t112;
        const lane t116 = D_p_y_2*t105;
        const lane t117 = D_delta_y_1*t107;
        const lane t118 = D_delta_y_2*t109;
        const lane t119 = D_delta_y_3*t111;
        const lane t120 = D_p_y_3*t113;
        const lane t121 = t117 + t118 + t119 + t120;
        const lane adjoint_forward_t133 = -t116 - t121;
        const lane adjoint_forward_t132 = -U_2_y_2*t105 - t121;
        const lane adjoint_forward_t131 = -U_3_y_3*t113 - t116 - t117 - t118 - t119;
        const lane t122 = D_p_x_2*t105;
        const lane t123 = D_delta_x_1*t107;
        const lane t124 = D_delta_x_2*t109;
        const lane t125 = D_delta_x_3*t111;
        const lane t126 = D_p_x_3*t113;
        const lane t127 = t123 + t124 + t125 + t126;
        const lane adjoint_forward_t130 = -t122 - t127;
        const lane adjoint_forward_t129 = -U_2_x_2*t105 - t127;
        const lane adjoint_forward_t128 = -U_3_x_3*t113 - t122 - t123 - t124 - t125;
        const lane t128 = (shape_1*shape_1);
        const lane adjoint_forward_t127 = t128*(-mu_2 - t97);
        const lane t129 = (shape_19*shape_19);
        const lane t130 = (shape_20*shape_20);
        const lane t131 = (shape_21*shape_21);
        const lane adjoint_forward_t124 = -eigenvalue*t129 - eigenvalue*t130 - eigenvalue*t131;
        const lane t132 = (shape_15*shape_15);
        const lane t133 = eigenvalue*forward_t44;
        const lane adjoint_forward_t123 = -t132*t133 + t132*t134;
        const lane t135 = eigenvalue*t19;
        const lane t136 = shape_21*t135;
        const lane t138 = shape_15*t137;
        const lane t139 = eigenvalue*shape_14;
        const lane adjoint_forward_t120 = -t136 - t138*t139;
        const lane t140 = shape_20*t135;
        const lane t142 = shape_15*t141;
        const lane adjoint_forward_t119 = -t139*t142 - t140;
        const lane t143 = shape_19*t135;
        const lane t145 = shape_15*t144;
        const lane adjoint_forward_t118 = -t139*t145 - t143;
        const lane t146 = (shape_14*shape_14);
        const lane adjoint_forward_t117 = -t133*t146 + t134*t146;
        const lane t147 = eigenvalue*t23;
        const lane t148 = shape_21*t147;
        const lane t150 = shape_14*t149;
        const lane t151 = eigenvalue*shape_13;
        const lane adjoint_forward_t114 = -t138*t151 - t148 - t150*t151;
        const lane t152 = shape_20*t147;
        const lane t154 = shape_14*t153;
        const lane adjoint_forward_t113 = -t142*t151 - t151*t154 - t152;
        const lane t155 = shape_19*t147;
        const lane t157 = shape_14*t156;
        const lane adjoint_forward_t112 = -t145*t151 - t151*t157 - t155;
        const lane t158 = (shape_13*shape_13);
        const lane adjoint_forward_t111 = -t133*t158 + t134*t158;
        const lane t159 = eigenvalue*t25;
        const lane adjoint_forward_t108 = -eigenvalue*t28 - t159;
        const lane t160 = eigenvalue*t29;
        const lane adjoint_forward_t107 = -eigenvalue*t32 - t160;
        const lane t161 = eigenvalue*t33;
        const lane adjoint_forward_t106 = -eigenvalue*t36 - t161;
        const lane adjoint_forward_t105 = -eigenvalue*t40 - t159;
        const lane t162 = eigenvalue*t37;
        const lane t163 = eigenvalue*t26;
        const lane adjoint_forward_t104 = -t162 - t163;
        const lane t164 = eigenvalue*forward_t65;
        const lane adjoint_forward_t103 = adjoint_forward_t104*forward_t53 - t164*t38;
        const lane adjoint_forward_t102 =
            adjoint_forward_t103*l_f_3_1 + adjoint_forward_t178*k_3_1 - forward_t88*t163 - forward_t89*t162
            + k_3_2*t26 + k_3_3*t37;
        const lane adjoint_forward_t101 = -eigenvalue*t44 - t160;
        const lane t165 = eigenvalue*t41;
        const lane t166 = eigenvalue*t30;
        const lane adjoint_forward_t100 = -t165 - t166;
        const lane adjoint_forward_t99 = adjoint_forward_t100*forward_t53 - t164*t42;
        const lane adjoint_forward_t98 =
            adjoint_forward_t176*k_2_1 + adjoint_forward_t99*l_f_2_1 - forward_t76*t166 - forward_t77*t165
            + k_2_2*t30 + k_2_3*t41;
        const lane adjoint_forward_t97 = -eigenvalue*t48 - t161;
        const lane t167 = eigenvalue*t45;
        const lane t168 = eigenvalue*t34;
        const lane adjoint_forward_t96 = -t167 - t168;
        const lane adjoint_forward_t95 = adjoint_forward_t96*forward_t53 - t164*t46;
        const lane adjoint_forward_t94 =
            adjoint_forward_t174*k_1_1 + adjoint_forward_t95*l_f_1_1 - forward_t54*t168 - forward_t55*t167
            + k_1_2*t34 + k_1_3*t45;
        const lane adjoint_forward_t93 = -eigenvalue*t65 - eigenvalue*t66;
        const lane adjoint_forward_t92 = -eigenvalue*t67 - eigenvalue*t68;
        const lane adjoint_forward_t91 = adjoint_forward_t92*l_f_3_3 + adjoint_forward_t93*l_f_3_2;
        const lane t169 = eigenvalue*t69;
        const lane adjoint_forward_t90 = -eigenvalue*t49 - eigenvalue*t51 - t169;
        const lane adjoint_forward_t89 = adjoint_forward_t90 - forward_t102*t162;
        const lane adjoint_forward_t88 = adjoint_forward_t90 - forward_t102*t163;
        const lane t170 = D_p_z_3*t169;
        const lane adjoint_forward_t87 = -eigenvalue*t54 - eigenvalue*t56 - eigenvalue*t58 - t170;
        const lane t171 = eigenvalue*t50;
        const lane t172 = shape_21*t171;
        const lane adjoint_forward_t86 = adjoint_forward_t87 - t172;
        const lane t173 = D_p_y_3*t169;
        const lane adjoint_forward_t85 = -eigenvalue*t59 - eigenvalue*t60 - eigenvalue*t61 - t173;
        const lane t174 = shape_20*t171;
        const lane adjoint_forward_t84 = adjoint_forward_t85 - t174;
        const lane t175 = D_p_x_3*t169;
        const lane adjoint_forward_t83 = -eigenvalue*t62 - eigenvalue*t63 - eigenvalue*t64 - t175;
        const lane t176 = shape_19*t171;
        const lane adjoint_forward_t82 = adjoint_forward_t83 - t176;
        const lane adjoint_forward_t81 = -eigenvalue*t73 - eigenvalue*t74;
        const lane adjoint_forward_t80 = -eigenvalue*t75 - eigenvalue*t76;
        const lane adjoint_forward_t79 = adjoint_forward_t80*l_f_2_3 + adjoint_forward_t81*l_f_2_2;
        const lane t177 = eigenvalue*t96;
        const lane adjoint_forward_t78 = -eigenvalue*t70 - eigenvalue*t72 - t177;
        const lane adjoint_forward_t77 = adjoint_forward_t78 - forward_t98*t165;
        const lane adjoint_forward_t76 = adjoint_forward_t78 - forward_t98*t166;
        const lane t178 = D_p_z_2*t177;
        const lane adjoint_forward_t75 =
            -eigenvalue*t78 - eigenvalue*t80 - eigenvalue*t82 - eigenvalue*t84 - t178;
        const lane t179 = eigenvalue*t71;
        const lane t180 = shape_21*t179;
        const lane adjoint_forward_t74 = adjoint_forward_t75 - t180;
        const lane t181 = D_p_y_2*t177;
        const lane adjoint_forward_t73 =
            -eigenvalue*t86 - eigenvalue*t87 - eigenvalue*t88 - eigenvalue*t89 - t181;
        const lane t182 = shape_20*t179;
        const lane adjoint_forward_t72 = adjoint_forward_t73 - t182;
        const lane t183 = D_p_x_2*t177;
        const lane adjoint_forward_t71 =
            -eigenvalue*t91 - eigenvalue*t92 - eigenvalue*t93 - eigenvalue*t94 - t183;
        const lane t184 = shape_19*t179;
        const lane adjoint_forward_t70 = adjoint_forward_t71 - t184;
        const lane t186 = shape_13*t185;
        const lane t187 = shape_19*t186;
        const lane t188 = shape_19*t157;
        const lane t189 = shape_19*t145;
        const lane t190 = eigenvalue*t189;
        const lane t192 = shape_13*t191;
        const lane t193 = shape_20*t192;
        const lane t194 = shape_20*t154;
        const lane t195 = shape_20*t142;
        const lane t196 = eigenvalue*t195;
        const lane t198 = shape_13*t197;
        const lane t199 = shape_21*t198;
        const lane t200 = shape_21*t150;
        const lane t201 = shape_21*t138;
        const lane t202 = eigenvalue*t201;
        const lane t203 = eigenvalue*t99;
        const lane t204 = shape_19*t203;
        const lane t205 = shape_20*t203;
        const lane t206 = shape_21*t203;
        const lane adjoint_forward_t69 =
            -D_p_x_1*t204 - D_p_x_2*t184 - D_p_x_3*t176 - D_p_y_1*t205 - D_p_y_2*t182 - D_p_y_3*t174
            - D_p_z_1*t206 - D_p_z_2*t180 - D_p_z_3*t172 - eigenvalue*t187 - eigenvalue*t188
            - eigenvalue*t193 - eigenvalue*t194 - eigenvalue*t199 - eigenvalue*t200 - t190 - t196 - t202;
        const lane adjoint_forward_t68 = -eigenvalue*t101 - eigenvalue*t102;
        const lane adjoint_forward_t67 = -eigenvalue*t103 - eigenvalue*t104;
        const lane adjoint_forward_t66 = adjoint_forward_t67*l_f_1_3 + adjoint_forward_t68*l_f_1_2;
        const lane adjoint_forward_t65 =
            R_p_1*adjoint_forward_t66 + R_p_2*adjoint_forward_t79 + R_p_3*adjoint_forward_t91
            - eigenvalue*forward_t103*t38 - eigenvalue*forward_t95*t46 - eigenvalue*forward_t99*t42;
        const lane t207 = eigenvalue*t113;
        const lane t208 = eigenvalue*t77;
        const lane adjoint_forward_t64 = -D_p_z_1*t207 - D_p_z_2*t208 + adjoint_forward_t87 - t170;
        const lane adjoint_forward_t63 = -D_p_y_1*t207 - D_p_y_2*t208 + adjoint_forward_t85 - t173;
        const lane adjoint_forward_t62 = -D_p_x_1*t207 - D_p_x_2*t208 + adjoint_forward_t83 - t175;
        const lane adjoint_forward_t61 =
            adjoint_forward_t62*n_3_x + adjoint_forward_t63*n_3_y + adjoint_forward_t64*n_3_z
            + adjoint_forward_t69;
        const lane t209 = eigenvalue*t105;
        const lane adjoint_forward_t60 = -D_p_z_1*t209 + adjoint_forward_t75 - t178;
        const lane adjoint_forward_t59 = -D_p_y_1*t209 + adjoint_forward_t73 - t181;
        const lane adjoint_forward_t58 = -D_p_x_1*t209 + adjoint_forward_t71 - t183;
        const lane adjoint_forward_t57 =
            adjoint_forward_t58*n_2_x + adjoint_forward_t59*n_2_y + adjoint_forward_t60*n_2_z
            + adjoint_forward_t69;
        const lane t210 = eigenvalue*t128;
        const lane adjoint_forward_t56 = -eigenvalue*t100 - eigenvalue*t98 - t210;
        const lane adjoint_forward_t55 = adjoint_forward_t56 - forward_t94*t167;
        const lane adjoint_forward_t54 = adjoint_forward_t56 - forward_t94*t168;
        const lane adjoint_forward_t53 =
            adjoint_forward_t100*forward_t99 + adjoint_forward_t104*forward_t103
            + adjoint_forward_t54*l_f_1_2 + adjoint_forward_t55*l_f_1_3 + adjoint_forward_t76*l_f_2_2
            + adjoint_forward_t77*l_f_2_3 + adjoint_forward_t88*l_f_3_2 + adjoint_forward_t89*l_f_3_3
            + adjoint_forward_t96*forward_t95;
        const lane t211 = D_p_z_1*t210;
        const lane adjoint_forward_t52 =
            -eigenvalue*t106 - eigenvalue*t108 - eigenvalue*t110 - eigenvalue*t112 - eigenvalue*t114 - t211;
        const lane adjoint_forward_t51 = adjoint_forward_t52 - t206;
        const lane adjoint_forward_t50 = adjoint_forward_t52 - t211;
        const lane t212 = D_p_y_1*t210;
        const lane adjoint_forward_t49 =
            -eigenvalue*t116 - eigenvalue*t117 - eigenvalue*t118 - eigenvalue*t119 - eigenvalue*t120 - t212;
        const lane adjoint_forward_t48 = adjoint_forward_t49 - t205;
        const lane adjoint_forward_t47 = adjoint_forward_t49 - t212;
        const lane t213 = D_p_x_1*t210;
        const lane adjoint_forward_t46 =
            -eigenvalue*t122 - eigenvalue*t123 - eigenvalue*t124 - eigenvalue*t125 - eigenvalue*t126 - t213;
        const lane adjoint_forward_t45 = adjoint_forward_t46 - t204;
        const lane t215 = t158*t214;
        const lane t217 = t146*t216;
        const lane t219 = t132*t218;
        const lane adjoint_forward_t44 =
            D_delta_x_1*adjoint_forward_t112 + D_delta_x_2*adjoint_forward_t118
            + D_delta_y_1*adjoint_forward_t113 + D_delta_y_2*adjoint_forward_t119
            + D_delta_z_1*adjoint_forward_t114 + D_delta_z_2*adjoint_forward_t120
            + D_p_x_1*adjoint_forward_t45 + D_p_x_2*adjoint_forward_t70 + D_p_x_3*adjoint_forward_t82
            + D_p_y_1*adjoint_forward_t48 + D_p_y_2*adjoint_forward_t72 + D_p_y_3*adjoint_forward_t84
            + D_p_z_1*adjoint_forward_t51 + D_p_z_2*adjoint_forward_t74 + D_p_z_3*adjoint_forward_t86
            - eigenvalue*t215 - eigenvalue*t217 - eigenvalue*t219 - t190 - t196 - t202;
        const lane adjoint_forward_t43 = adjoint_forward_t44 - t169;
        const lane adjoint_forward_t42 = adjoint_forward_t44 - t177;
        const lane adjoint_forward_t41 = adjoint_forward_t46 - t213;
        const lane adjoint_forward_t40 =
            adjoint_forward_t41*n_1_x + adjoint_forward_t47*n_1_y + adjoint_forward_t50*n_1_z
            + adjoint_forward_t69;
        const lane adjoint_forward_t39 = adjoint_forward_t44 - t210;
        const lane t221 = t24*(-forward_t182 - forward_t183 - forward_t184);
        const lane t222 = shape_15*t23;
        const lane t223 = t222*(-forward_t185 - forward_t186 - forward_t187);
        const lane t224 = shape_15*t19;
        const lane t225 = t224*(-forward_t188 - forward_t189 - forward_t190);
        const lane t226 = -t128*t220 - t158*t214 + t221 + t223 + t225;
        const lane t228 = -t146*t216 - t227*t96;
        const lane adjoint_mu_3 =
            D_p_x_1*adjoint_forward_t128 + D_p_x_2*adjoint_forward_t144 + D_p_y_1*adjoint_forward_t131
            + D_p_y_2*adjoint_forward_t147 + D_p_z_1*adjoint_forward_t134 + D_p_z_2*adjoint_forward_t150
            + U_3_x_3*adjoint_forward_t161 + U_3_y_3*adjoint_forward_t163 + U_3_z_3*adjoint_forward_t165
            + t132*(1.0 - t218) + t226 + t228 + t69*(-(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3)
            - (U_3_z_3*U_3_z_3));
        const lane t230 =
            -t132*t218 - t229*t69 + t53*(-forward_t160 - forward_t162 - forward_t164) + t55*(-forward_t166
            - forward_t167 - forward_t168) + t57*(-forward_t169 - forward_t170 - forward_t171);
        const lane adjoint_mu_2 =
            D_p_x_1*adjoint_forward_t129 + D_p_y_1*adjoint_forward_t132 + D_p_z_1*adjoint_forward_t135
            + U_2_x_2*adjoint_forward_t145 + U_2_y_2*adjoint_forward_t148 + U_2_z_2*adjoint_forward_t151
            + t146*(1.0 - t216) + t226 + t230 + t96*(-(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2)
            - (U_2_z_2*U_2_z_2));
        const lane adjoint_mu_1 =
            D_p_x_2*adjoint_forward_t145 + D_p_y_2*adjoint_forward_t148 + D_p_z_2*adjoint_forward_t151
            + U_1_x_1*adjoint_forward_t130 + U_1_y_1*adjoint_forward_t133 + U_1_z_1*adjoint_forward_t136
            + t128*(-(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1)) + t158*(1.0 - t214) + t221
            + t223 + t225 + t228 + t230;
        const lane adjoint_forward_t38 =
            -adjoint_mu_1*forward_t8 - adjoint_mu_2*forward_t9 - adjoint_mu_3*forward_t10;
        const lane adjoint_forward_t37 =
            -adjoint_mu_1*forward_t5 - adjoint_mu_2*forward_t6 - adjoint_mu_3*forward_t7;
        const lane adjoint_forward_t36 =
            -adjoint_mu_1*forward_t2 - adjoint_mu_2*forward_t3 - adjoint_mu_3*forward_t4;
        const lane adjoint_forward_t35 =
            adjoint_forward_t36*g_x + adjoint_forward_t37*g_y + adjoint_forward_t38*g_z;
        const lane adjoint_forward_t34 = adjoint_forward_t124 + adjoint_forward_t35 + adjoint_forward_t44;
        const lane t231 = n_3_x*t176 + n_3_y*t174 + n_3_z*t172;
        const lane adjoint_forward_t33 = adjoint_forward_t35 - t231;
        const lane t232 = n_2_x*t184 + n_2_y*t182 + n_2_z*t180;
        const lane adjoint_forward_t32 = adjoint_forward_t35 - t232;
        const lane t233 = n_1_x*t204 + n_1_y*t205 + n_1_z*t206;
        const lane adjoint_forward_t31 = adjoint_forward_t35 - t233;
        const lane t234 = adjoint_forward_t172 + t69;
        const lane adjoint_k_3_3 = -R_p_3*adjoint_forward_t158 + forward_t102*t37 + t234;
        const lane adjoint_forward_12 = adjoint_k_3_3*forward_t29;
        const lane t235 = adjoint_forward_12/(t15*t15);
        const lane adjoint_l_f_3_3 = adjoint_forward_t89*forward_t53 + adjoint_forward_t92*forward_t91 - t235;
        const lane adjoint_k_3_2 = -R_p_3*adjoint_forward_t159 + forward_t102*t26 + t234;
        const lane adjoint_forward_11 = adjoint_k_3_2*forward_t29;
        const lane t236 = adjoint_forward_11/(t14*t14);
        const lane adjoint_l_f_3_2 = adjoint_forward_t88*forward_t53 + adjoint_forward_t93*forward_t91 - t236;
        const lane adjoint_forward_t30 = -adjoint_l_f_3_2 - adjoint_l_f_3_3;
        const lane adjoint_k_3_1 = adjoint_forward_t178*forward_t102;
        const lane adjoint_forward_10 = adjoint_k_3_1*forward_t29;
        const lane adjoint_forward_t29 =
            adjoint_k_3_1*forward_10 + adjoint_k_3_2*forward_11 + adjoint_k_3_3*forward_12;
        const lane t237 = adjoint_forward_10/(t13*t13);
        const lane adjoint_forward_t28 = -t235 - t236 - t237;
        const lane adjoint_forward_t27 = adjoint_forward_t28*forward_t18 + adjoint_forward_t29*forward_t17;
        const lane adjoint_l_f_3_1 = adjoint_forward_t103*forward_t102 - t237;
        const lane t238 = adjoint_forward_t154 + t96;
        const lane adjoint_k_2_3 = -R_p_2*adjoint_forward_t152 + forward_t98*t41 + t238;
        const lane adjoint_forward_9 = adjoint_k_2_3*forward_t25;
        const lane t239 = adjoint_forward_9/(t10*t10);
        const lane adjoint_l_f_2_3 = adjoint_forward_t77*forward_t53 + adjoint_forward_t80*forward_t79 - t239;
        const lane adjoint_k_2_2 = -R_p_2*adjoint_forward_t153 + forward_t98*t30 + t238;
        const lane adjoint_forward_8 = adjoint_k_2_2*forward_t25;
        const lane t240 = adjoint_forward_8/(t9*t9);
        const lane adjoint_l_f_2_2 = adjoint_forward_t76*forward_t53 + adjoint_forward_t81*forward_t79 - t240;
        const lane adjoint_forward_t26 = -adjoint_l_f_2_2 - adjoint_l_f_2_3;
        const lane adjoint_k_2_1 = adjoint_forward_t176*forward_t98;
        const lane adjoint_forward_7 = adjoint_k_2_1*forward_t25;
        const lane adjoint_forward_t25 =
            adjoint_k_2_1*forward_7 + adjoint_k_2_2*forward_8 + adjoint_k_2_3*forward_9;
        const lane t241 = adjoint_forward_7/(t8*t8);
        const lane adjoint_forward_t24 = -t239 - t240 - t241;
        const lane adjoint_forward_t23 = adjoint_forward_t24*forward_t18 + adjoint_forward_t25*forward_t17;
        const lane adjoint_l_f_2_1 = adjoint_forward_t99*forward_t98 - t241;
        const lane t242 = adjoint_forward_t139 + t128;
        const lane adjoint_k_1_3 = -R_p_1*adjoint_forward_t137 + forward_t94*t45 + t242;
        const lane adjoint_forward_6 = adjoint_k_1_3*forward_t21;
        const lane t243 = adjoint_forward_6/(t5*t5);
        const lane adjoint_l_f_1_3 = adjoint_forward_t55*forward_t53 + adjoint_forward_t67*forward_t66 - t243;
        const lane adjoint_k_1_2 = -R_p_1*adjoint_forward_t138 + forward_t94*t34 + t242;
        const lane adjoint_forward_5 = adjoint_k_1_2*forward_t21;
        const lane t244 = adjoint_forward_5/(t4*t4);
        const lane adjoint_l_f_1_2 = adjoint_forward_t54*forward_t53 + adjoint_forward_t68*forward_t66 - t244;
        const lane adjoint_forward_t22 = -adjoint_l_f_1_2 - adjoint_l_f_1_3;
        const lane adjoint_k_1_1 = adjoint_forward_t174*forward_t94;
        const lane adjoint_forward_4 = adjoint_k_1_1*forward_t21;
        const lane adjoint_forward_t21 =
            adjoint_k_1_1*forward_4 + adjoint_k_1_2*forward_5 + adjoint_k_1_3*forward_6;
        const lane t245 = adjoint_forward_4/(t3*t3);
        const lane adjoint_forward_t20 = -t243 - t244 - t245;
        const lane adjoint_forward_t19 = adjoint_forward_t20*forward_t18 + adjoint_forward_t21*forward_t17;
        const lane adjoint_forward_t18 =
            adjoint_forward_t20*forward_t19 + adjoint_forward_t24*forward_t23
            + adjoint_forward_t28*forward_t27;
        const lane adjoint_forward_t17 =
            adjoint_forward_t18*c_E + adjoint_forward_t21*forward_t19 + adjoint_forward_t25*forward_t23
            + adjoint_forward_t29*forward_t27;
        const lane adjoint_l_f_1_1 = adjoint_forward_t95*forward_t94 - t245;
        const lane adjoint_I_3_2 = -t163;
        const lane adjoint_I_3_1 = -t162;
        const lane adjoint_forward_t16 = adjoint_I_3_1*d_3_1 + adjoint_I_3_2*d_3_2;
        const lane adjoint_forward_t15 =
            adjoint_forward_t105*d_3_1 + adjoint_forward_t108*d_3_2 + adjoint_forward_t16;
        const lane adjoint_I_2_2 = -t166;
        const lane adjoint_I_2_1 = -t165;
        const lane adjoint_forward_t14 = adjoint_I_2_1*d_2_1 + adjoint_I_2_2*d_2_2;
        const lane adjoint_forward_t13 =
            adjoint_forward_t101*d_2_1 + adjoint_forward_t107*d_2_2 + adjoint_forward_t14;
        const lane adjoint_I_1_2 = -t168;
        const lane adjoint_I_1_1 = -t167;
        const lane adjoint_forward_t12 = adjoint_I_1_1*d_1_1 + adjoint_I_1_2*d_1_2;
        const lane adjoint_forward_t11 =
            adjoint_forward_t106*d_1_2 + adjoint_forward_t12 + adjoint_forward_t97*d_1_1;
        const lane t246 = 2.0*t69;
        const lane adjoint_U_3_z_3 =
            adjoint_forward_t165*mu_3 - forward_t134*t113 - forward_t150*t77 - forward_t165*t246;
        const lane adjoint_U_3_y_3 =
            adjoint_forward_t163*mu_3 - forward_t131*t113 - forward_t147*t77 - forward_t163*t246;
        const lane adjoint_U_3_x_3 =
            adjoint_forward_t161*mu_3 - forward_t128*t113 - forward_t144*t77 - forward_t161*t246;
        const lane t247 = 2.0*t96;
        const lane adjoint_U_2_z_2 = adjoint_forward_t151*mu_2 - forward_t135*t105 - forward_t151*t247;
        const lane adjoint_U_2_y_2 = adjoint_forward_t148*mu_2 - forward_t132*t105 - forward_t148*t247;
        const lane adjoint_U_2_x_2 = adjoint_forward_t145*mu_2 - forward_t129*t105 - forward_t145*t247;
        const lane t248 = 2.0*t128;
        const lane adjoint_U_1_z_1 = adjoint_forward_t136*mu_1 - forward_t136*t248;
        const lane adjoint_U_1_y_1 = adjoint_forward_t133*mu_1 - forward_t133*t248;
        const lane adjoint_U_1_x_1 = adjoint_forward_t130*mu_1 - forward_t130*t248;
        const lane t249 = k_C*shape_21;
        const lane t250 = 2.0*shape_15;
        const lane t251 = k_C*shape_15;
        const lane t252 = shape_15*t147;
        const lane t253 = shape_15*t135;
        const lane t254 = eigenvalue*forward_t52;
        const lane t255 = eigenvalue*forward_t75;
        const lane t256 = eigenvalue*forward_t87;
        const lane t257 = eigenvalue*t250*(forward_t44 + forward_t69);
        const lane adjoint_D_delta_z_3 =
            D_delta_z_1*adjoint_forward_t187 + D_delta_z_2*adjoint_forward_t190
            + D_p_z_3*adjoint_forward_t171 + adjoint_forward_t123*t137 - forward_t114*t252
            - forward_t120*t253 - shape_21*t257 - t111*t254 + t111*t262 + t150*t251 + t198*t251 + t249*t250
            - t255*t83 - t256*t57 + t259*t57 + t264*t83;
        const lane t265 = k_C*shape_14;
        const lane t266 = eigenvalue*t24;
        const lane adjoint_D_delta_z_2 =
            D_delta_z_1*adjoint_forward_t184 + D_delta_z_3*adjoint_forward_t190
            + D_p_z_3*adjoint_forward_t168 + adjoint_forward_t117*t149 + adjoint_forward_t120*forward_t44
            - forward_t114*t266 - forward_t69*t136 - t109*t254 + t109*t262 + t138*t265 + t19*t249 + t198*t265
            - t255*t81 - t256*t55 + t259*t55 + t264*t81;
        const lane t267 = k_C*shape_13;
        const lane adjoint_D_delta_z_1 =
            D_delta_z_2*adjoint_forward_t184 + D_delta_z_3*adjoint_forward_t187
            + D_p_z_3*adjoint_forward_t164 + adjoint_forward_t111*t197 + adjoint_forward_t114*forward_t44
            - forward_t69*t148 - t107*t254 + t107*t262 + t138*t267 + t150*t267 + t23*t249 - t255*t79
            - t256*t53 + t259*t53 + t264*t79;
        const lane adjoint_D_p_z_3 =
            D_delta_z_1*adjoint_forward_t164 + D_delta_z_2*adjoint_forward_t168
            + D_delta_z_3*adjoint_forward_t171 + 2.0*D_p_z_3*adjoint_forward_t157 + adjoint_U_3_z_3
            + adjoint_forward_t86*forward_t44 - forward_t52*t207 - forward_t69*t172 - forward_t75*t208
            + k_C*t54 + k_C*t56 + k_C*t58 - t113*t261 - t169*(forward_t64 + forward_t87) + t249*t50
            - t263*t77;
        const lane adjoint_forward_t10 = D_r_3*adjoint_D_p_z_3 + adjoint_D_delta_z_3*l_d_3;
        const lane adjoint_D_p_z_2 =
            2.0*D_p_z_2*adjoint_forward_t142 + adjoint_U_2_z_2 + adjoint_forward_t150*mu_3
            + adjoint_forward_t151*mu_1 + adjoint_forward_t74*forward_t44 - forward_t52*t209
            - forward_t64*t208 - forward_t69*t180 + k_C*t80 + k_C*t82 + k_C*t84 + t105*(-forward_t134 - t260)
            - t177*(forward_t60 + forward_t75) + t249*t71 + t258*t77;
        const lane adjoint_forward_t9 = D_r_2*adjoint_D_p_z_2 + adjoint_D_delta_z_2*l_d_2;
        const lane adjoint_D_p_z_1 =
            2.0*D_p_z_1*adjoint_forward_t127 + D_p_z_2*k_C*t105 + adjoint_U_1_z_1 + adjoint_forward_t134*mu_3
            + adjoint_forward_t135*mu_2 + adjoint_forward_t51*forward_t44 - forward_t60*t209
            - forward_t64*t207 - forward_t69*t206 + k_C*t108 + k_C*t110 + k_C*t112 + t113*t258
            - t210*(forward_t50 + forward_t52) + t249*t99;
        const lane adjoint_forward_t8 = D_r_1*adjoint_D_p_z_1 + adjoint_D_delta_z_1*l_d_1;
        const lane t268 = k_C*shape_20;
        const lane t269 = eigenvalue*forward_t49;
        const lane t270 = eigenvalue*forward_t73;
        const lane t271 = eigenvalue*forward_t85;
        const lane adjoint_D_delta_y_3 =
            D_delta_y_1*adjoint_forward_t187 + D_delta_y_2*adjoint_forward_t190
            + D_p_y_3*adjoint_forward_t171 + adjoint_forward_t123*t141 - forward_t113*t252
            - forward_t119*t253 - shape_20*t257 - t111*t269 + t111*t276 + t154*t251 + t192*t251 + t250*t268
            - t270*t83 - t271*t57 + t273*t57 + t278*t83;
        const lane adjoint_D_delta_y_2 =
            D_delta_y_1*adjoint_forward_t184 + D_delta_y_3*adjoint_forward_t190
            + D_p_y_3*adjoint_forward_t168 + adjoint_forward_t117*t153 + adjoint_forward_t119*forward_t44
            - forward_t113*t266 - forward_t69*t140 - t109*t269 + t109*t276 + t142*t265 + t19*t268 + t192*t265
            - t270*t81 - t271*t55 + t273*t55 + t278*t81;
        const lane adjoint_D_delta_y_1 =
            D_delta_y_2*adjoint_forward_t184 + D_delta_y_3*adjoint_forward_t187
            + D_p_y_3*adjoint_forward_t164 + adjoint_forward_t111*t191 + adjoint_forward_t113*forward_t44
            - forward_t69*t152 - t107*t269 + t107*t276 + t142*t267 + t154*t267 + t23*t268 - t270*t79
            - t271*t53 + t273*t53 + t278*t79;
        const lane adjoint_D_p_y_3 =
            D_delta_y_1*adjoint_forward_t164 + D_delta_y_2*adjoint_forward_t168
            + D_delta_y_3*adjoint_forward_t171 + 2.0*D_p_y_3*adjoint_forward_t157 + adjoint_U_3_y_3
            + adjoint_forward_t84*forward_t44 - forward_t49*t207 - forward_t69*t174 - forward_t73*t208
            + k_C*t59 + k_C*t60 + k_C*t61 - t113*t275 - t169*(forward_t63 + forward_t85) + t268*t50
            - t277*t77;
        const lane adjoint_forward_t7 = D_r_3*adjoint_D_p_y_3 + adjoint_D_delta_y_3*l_d_3;
        const lane adjoint_D_p_y_2 =
            2.0*D_p_y_2*adjoint_forward_t142 + adjoint_U_2_y_2 + adjoint_forward_t147*mu_3
            + adjoint_forward_t148*mu_1 + adjoint_forward_t72*forward_t44 - forward_t49*t209
            - forward_t63*t208 - forward_t69*t182 + k_C*t87 + k_C*t88 + k_C*t89 + t105*(-forward_t131 - t274)
            - t177*(forward_t59 + forward_t73) + t268*t71 + t272*t77;
        const lane adjoint_forward_t6 = D_r_2*adjoint_D_p_y_2 + adjoint_D_delta_y_2*l_d_2;
        const lane adjoint_D_p_y_1 =
            2.0*D_p_y_1*adjoint_forward_t127 + D_p_y_2*k_C*t105 + adjoint_U_1_y_1 + adjoint_forward_t131*mu_3
            + adjoint_forward_t132*mu_2 + adjoint_forward_t48*forward_t44 - forward_t59*t209
            - forward_t63*t207 - forward_t69*t205 + k_C*t117 + k_C*t118 + k_C*t119 + t113*t272
            - t210*(forward_t47 + forward_t49) + t268*t99;
        const lane adjoint_forward_t5 = D_r_1*adjoint_D_p_y_1 + adjoint_D_delta_y_1*l_d_1;
        const lane t279 = k_C*shape_19;
        const lane t280 = eigenvalue*forward_t46;
        const lane t281 = eigenvalue*forward_t71;
        const lane t282 = eigenvalue*forward_t83;
        const lane adjoint_D_delta_x_3 =
            D_delta_x_1*adjoint_forward_t187 + D_delta_x_2*adjoint_forward_t190
            + D_p_x_3*adjoint_forward_t171 + adjoint_forward_t123*t144 - forward_t112*t252
            - forward_t118*t253 - shape_19*t257 - t111*t280 + t111*t287 + t157*t251 + t186*t251 + t250*t279
            - t281*t83 - t282*t57 + t284*t57 + t289*t83;
        const lane adjoint_D_delta_x_2 =
            D_delta_x_1*adjoint_forward_t184 + D_delta_x_3*adjoint_forward_t190
            + D_p_x_3*adjoint_forward_t168 + adjoint_forward_t117*t156 + adjoint_forward_t118*forward_t44
            - forward_t112*t266 - forward_t69*t143 - t109*t280 + t109*t287 + t145*t265 + t186*t265 + t19*t279
            - t281*t81 - t282*t55 + t284*t55 + t289*t81;
        const lane adjoint_D_delta_x_1 =
            D_delta_x_2*adjoint_forward_t184 + D_delta_x_3*adjoint_forward_t187
            + D_p_x_3*adjoint_forward_t164 + adjoint_forward_t111*t185 + adjoint_forward_t112*forward_t44
            - forward_t69*t155 - t107*t280 + t107*t287 + t145*t267 + t157*t267 + t23*t279 - t281*t79
            - t282*t53 + t284*t53 + t289*t79;
        const lane adjoint_D_p_x_3 =
            D_delta_x_1*adjoint_forward_t164 + D_delta_x_2*adjoint_forward_t168
            + D_delta_x_3*adjoint_forward_t171 + 2.0*D_p_x_3*adjoint_forward_t157 + adjoint_U_3_x_3
            + adjoint_forward_t82*forward_t44 - forward_t46*t207 - forward_t69*t176 - forward_t71*t208
            + k_C*t62 + k_C*t63 + k_C*t64 - t113*t286 - t169*(forward_t62 + forward_t83) + t279*t50
            - t288*t77;
        const lane adjoint_forward_t4 = D_r_3*adjoint_D_p_x_3 + adjoint_D_delta_x_3*l_d_3;
        const lane adjoint_D_p_x_2 =
            2.0*D_p_x_2*adjoint_forward_t142 + adjoint_U_2_x_2 + adjoint_forward_t144*mu_3
            + adjoint_forward_t145*mu_1 + adjoint_forward_t70*forward_t44 - forward_t46*t209
            - forward_t62*t208 - forward_t69*t184 + k_C*t92 + k_C*t93 + k_C*t94 + t105*(-forward_t128 - t285)
            - t177*(forward_t58 + forward_t71) + t279*t71 + t283*t77;
        const lane adjoint_forward_t3 = D_r_2*adjoint_D_p_x_2 + adjoint_D_delta_x_2*l_d_2;
        const lane adjoint_D_p_x_1 =
            2.0*D_p_x_1*adjoint_forward_t127 + D_p_x_2*k_C*t105 + adjoint_U_1_x_1 + adjoint_forward_t128*mu_3
            + adjoint_forward_t129*mu_2 + adjoint_forward_t45*forward_t44 - forward_t58*t209
            - forward_t62*t207 - forward_t69*t204 + k_C*t123 + k_C*t124 + k_C*t125 + t113*t283
            - t210*(forward_t41 + forward_t46) + t279*t99;
        const lane adjoint_forward_t2 = D_r_1*adjoint_D_p_x_1 + adjoint_D_delta_x_1*l_d_1;
        const lane adjoint_forward_t1 =
            A_x_1*adjoint_forward_t2 + A_x_2*adjoint_forward_t3 + A_x_3*adjoint_forward_t4
            + A_y_1*adjoint_forward_t5 + A_y_2*adjoint_forward_t6 + A_y_3*adjoint_forward_t7
            + A_z_1*adjoint_forward_t8 + A_z_2*adjoint_forward_t9 + A_z_3*adjoint_forward_t10
            + adjoint_mu_1*t16 + adjoint_mu_2*t17 + adjoint_mu_3*t18;
        const lane adjoint_det_D_l = -adjoint_forward_t1*(forward_3*forward_3);
        const lane t290 = adjoint_mu_3*forward_3;
        const lane adjoint_A_z_3 = adjoint_forward_t10*forward_3 - forward_t38*t290;
        const lane adjoint_A_y_3 = adjoint_forward_t7*forward_3 - forward_t37*t290;
        const lane adjoint_A_x_3 = adjoint_forward_t4*forward_3 - forward_t36*t290;
        const lane t291 = adjoint_mu_2*forward_3;
        const lane adjoint_A_z_2 = adjoint_forward_t9*forward_3 - forward_t38*t291;
        const lane adjoint_A_y_2 = adjoint_forward_t6*forward_3 - forward_t37*t291;
        const lane adjoint_A_x_2 = adjoint_forward_t3*forward_3 - forward_t36*t291;
        const lane t292 = adjoint_mu_1*forward_3;
        const lane adjoint_A_z_1 = adjoint_det_D_l*s_1_z + adjoint_forward_t8*forward_3 - forward_t38*t292;
        const lane adjoint_A_y_1 = adjoint_det_D_l*s_1_y + adjoint_forward_t5*forward_3 - forward_t37*t292;
        const lane adjoint_A_x_1 = adjoint_det_D_l*s_1_x + adjoint_forward_t2*forward_3 - forward_t36*t292;
        const lane adjoint_D_r_3 =
            adjoint_D_p_x_3*forward_t4 + adjoint_D_p_y_3*forward_t7 + adjoint_D_p_z_3*forward_t10;
        const lane adjoint_D_r_2 =
            adjoint_D_p_x_2*forward_t3 + adjoint_D_p_y_2*forward_t6 + adjoint_D_p_z_2*forward_t9;
        const lane adjoint_D_r_1 =
            adjoint_D_p_x_1*forward_t2 + adjoint_D_p_y_1*forward_t5 + adjoint_D_p_z_1*forward_t8;
        const lane adjoint_s_3_z =
            adjoint_A_x_1*s_2_y - adjoint_A_x_2*s_1_y - adjoint_A_y_1*s_2_x + adjoint_A_y_2*s_1_x
            + adjoint_D_r_3*n_3_z;
        const lane adjoint_s_3_y =
            -adjoint_A_x_1*s_2_z + adjoint_A_x_2*s_1_z + adjoint_A_z_1*s_2_x - adjoint_A_z_2*s_1_x
            + adjoint_D_r_3*n_3_y;
        const lane adjoint_s_3_x =
            adjoint_A_y_1*s_2_z - adjoint_A_y_2*s_1_z - adjoint_A_z_1*s_2_y + adjoint_A_z_2*s_1_y
            + adjoint_D_r_3*n_3_x;
        const lane adjoint_s_2_z =
            -adjoint_A_x_1*s_3_y + adjoint_A_x_3*s_1_y + adjoint_A_y_1*s_3_x - adjoint_A_y_3*s_1_x
            + adjoint_D_r_2*n_2_z;
        const lane adjoint_s_2_y =
            adjoint_A_x_1*s_3_z - adjoint_A_x_3*s_1_z - adjoint_A_z_1*s_3_x + adjoint_A_z_3*s_1_x
            + adjoint_D_r_2*n_2_y;
        const lane adjoint_s_2_x =
            -adjoint_A_y_1*s_3_z + adjoint_A_y_3*s_1_z + adjoint_A_z_1*s_3_y - adjoint_A_z_3*s_1_y
            + adjoint_D_r_2*n_2_x;
        const lane adjoint_s_1_z =
            A_z_1*adjoint_det_D_l + adjoint_A_x_2*s_3_y - adjoint_A_x_3*s_2_y - adjoint_A_y_2*s_3_x
            + adjoint_A_y_3*s_2_x + adjoint_D_r_1*n_1_z;
        const lane adjoint_s_1_y =
            A_y_1*adjoint_det_D_l - adjoint_A_x_2*s_3_z + adjoint_A_x_3*s_2_z + adjoint_A_z_2*s_3_x
            - adjoint_A_z_3*s_2_x + adjoint_D_r_1*n_1_y;
        const lane adjoint_s_1_x =
            A_x_1*adjoint_det_D_l + adjoint_A_y_2*s_3_z - adjoint_A_y_3*s_2_z - adjoint_A_z_2*s_3_y
            + adjoint_A_z_3*s_2_y + adjoint_D_r_1*n_1_x;
        const lane adjoint_x_3 =
            adjoint_l_f_3_2 - adjoint_l_f_3_3 - adjoint_s_3_x*n_3_x - adjoint_s_3_y*n_3_y
            - adjoint_s_3_z*n_3_z;
        const lane adjoint_forward_2 = adjoint_x_3*sigma_3;
        const lane t293 = adjoint_forward_2/forward_2;
        const lane adjoint_w2_3 = -1.0/2.0*t293;
        const lane t294 = 2.0*adjoint_w2_3;
        const lane adjoint_w_3_z = t294*w_3_z;
        const lane adjoint_w_3_y = t294*w_3_y;
        const lane adjoint_w_3_x = t294*w_3_x;
        const lane adjoint_a_3 =
            -adjoint_w_3_x*n_3_x - adjoint_w_3_y*n_3_y - adjoint_w_3_z*n_3_z + adjoint_x_3;
        const lane adjoint_x_2 =
            adjoint_l_f_2_2 - adjoint_l_f_2_3 - adjoint_s_2_x*n_2_x - adjoint_s_2_y*n_2_y
            - adjoint_s_2_z*n_2_z;
        const lane adjoint_forward_1 = adjoint_x_2*sigma_2;
        const lane t295 = adjoint_forward_1/forward_1;
        const lane adjoint_w2_2 = -1.0/2.0*t295;
        const lane t296 = 2.0*adjoint_w2_2;
        const lane adjoint_w_2_z = t296*w_2_z;
        const lane adjoint_w_2_y = t296*w_2_y;
        const lane adjoint_w_2_x = t296*w_2_x;
        const lane adjoint_a_2 =
            -adjoint_w_2_x*n_2_x - adjoint_w_2_y*n_2_y - adjoint_w_2_z*n_2_z + adjoint_x_2;
        const lane adjoint_x_1 =
            adjoint_l_f_1_2 - adjoint_l_f_1_3 - adjoint_s_1_x*n_1_x - adjoint_s_1_y*n_1_y
            - adjoint_s_1_z*n_1_z;
        const lane adjoint_forward_0 = adjoint_x_1*sigma_1;
        const lane t297 = adjoint_forward_0/forward_0;
        const lane adjoint_w2_1 = -1.0/2.0*t297;
        const lane t298 = 2.0*adjoint_w2_1;
        const lane adjoint_w_1_z = t298*w_1_z;
        const lane adjoint_w_1_y = t298*w_1_y;
        const lane adjoint_w_1_x = t298*w_1_x;
        const lane adjoint_a_1 =
            -adjoint_w_1_x*n_1_x - adjoint_w_1_y*n_1_y - adjoint_w_1_z*n_1_z + adjoint_x_1;
        const lane adjoint_r_3_z = adjoint_a_3*n_3_z + adjoint_s_3_z + adjoint_w_3_z;
        const lane adjoint_r_3_y = adjoint_a_3*n_3_y + adjoint_s_3_y + adjoint_w_3_y;
        const lane adjoint_r_3_x = adjoint_a_3*n_3_x + adjoint_s_3_x + adjoint_w_3_x;
        const lane adjoint_r_2_z = adjoint_a_2*n_2_z + adjoint_s_2_z + adjoint_w_2_z;
        const lane adjoint_r_2_y = adjoint_a_2*n_2_y + adjoint_s_2_y + adjoint_w_2_y;
        const lane adjoint_r_2_x = adjoint_a_2*n_2_x + adjoint_s_2_x + adjoint_w_2_x;
        const lane adjoint_r_1_z = adjoint_a_1*n_1_z + adjoint_s_1_z + adjoint_w_1_z;
        const lane adjoint_r_1_y = adjoint_a_1*n_1_y + adjoint_s_1_y + adjoint_w_1_y;
        const lane adjoint_r_1_x = adjoint_a_1*n_1_x + adjoint_s_1_x + adjoint_w_1_x;
        const lane t299 = adjoint_forward_t19*k_sp_1;
        const lane t300 = adjoint_forward_t23*k_sp_2;
        const lane t301 = adjoint_forward_t27*k_sp_3;
        lanes_clear(gradient, 102);
        gradient[0] = LANES(adjoint_forward_t34);
        gradient[1] = LANES(adjoint_forward_t36*forward_t35);
        gradient[2] = LANES(adjoint_forward_t37*forward_t35);
        gradient[3] = LANES(adjoint_forward_t38*forward_t35);
        gradient[4] = LANES(-adjoint_r_1_x);
        gradient[5] = LANES(-adjoint_r_1_y);
        gradient[6] = LANES(-adjoint_r_1_z);
        gradient[7] = LANES(-adjoint_r_2_x);
        gradient[8] = LANES(-adjoint_r_2_y);
        gradient[9] = LANES(-adjoint_r_2_z);
        gradient[10] = LANES(-adjoint_r_3_x);
        gradient[11] = LANES(-adjoint_r_3_y);
        gradient[12] = LANES(-adjoint_r_3_z);
        gradient[22] = LANES(adjoint_r_1_x);
        gradient[23] = LANES(adjoint_r_1_y);
        gradient[24] = LANES(adjoint_r_1_z);
        gradient[25] = LANES(adjoint_r_2_x);
        gradient[26] = LANES(adjoint_r_2_y);
        gradient[27] = LANES(adjoint_r_2_z);
        gradient[28] = LANES(adjoint_r_3_x);
        gradient[29] = LANES(adjoint_r_3_y);
        gradient[30] = LANES(adjoint_r_3_z);
        gradient[31] =
            LANES(adjoint_D_delta_x_1*forward_t2 + adjoint_D_delta_y_1*forward_t5
            + adjoint_D_delta_z_1*forward_t8 + l_d_1*t297);
        gradient[32] =
            LANES(adjoint_D_delta_x_2*forward_t3 + adjoint_D_delta_y_2*forward_t6
            + adjoint_D_delta_z_2*forward_t9 + l_d_2*t295);
        gradient[33] =
            LANES(adjoint_D_delta_x_3*forward_t4 + adjoint_D_delta_y_3*forward_t7
            + adjoint_D_delta_z_3*forward_t10 + l_d_3*t293);
        gradient[34] =
            LANES(adjoint_forward_t124 + (1.0/2.0)*adjoint_forward_t31 + (1.0/3.0)*adjoint_forward_t39
            + (1.0/6.0)*adjoint_forward_t40);
        gradient[35] =
            LANES(adjoint_forward_t124 + (1.0/2.0)*adjoint_forward_t32 + (1.0/3.0)*adjoint_forward_t42
            + (1.0/6.0)*adjoint_forward_t57);
        gradient[36] =
            LANES(adjoint_forward_t124 + (1.0/2.0)*adjoint_forward_t33 + (1.0/3.0)*adjoint_forward_t43
            + (1.0/6.0)*adjoint_forward_t61);
        gradient[37] = LANES(adjoint_forward_t124 - t210 - t233);
        gradient[38] = LANES(adjoint_forward_t124 - t177 - t232);
        gradient[39] = LANES(adjoint_forward_t124 - t169 - t231);
        gradient[40] = LANES((1.0/2.0)*adjoint_forward_t22);
        gradient[41] = LANES((1.0/2.0)*adjoint_forward_t26);
        gradient[42] = LANES((1.0/2.0)*adjoint_forward_t30);
        gradient[43] = LANES(adjoint_forward_t19*t2);
        gradient[44] = LANES(adjoint_forward_t23*t7);
        gradient[45] = LANES(adjoint_forward_t27*t12);
        gradient[46] = LANES(t1*t299);
        gradient[47] = LANES(t300*t6);
        gradient[48] = LANES(t11*t301);
        gradient[49] =
            LANES(2.0*R_p_1*adjoint_forward_t94 - adjoint_forward_t137*k_1_3 - adjoint_forward_t138*k_1_2
            + adjoint_forward_t66*forward_t65);
        gradient[50] =
            LANES(2.0*R_p_2*adjoint_forward_t98 - adjoint_forward_t152*k_2_3 - adjoint_forward_t153*k_2_2
            + adjoint_forward_t79*forward_t65);
        gradient[51] =
            LANES(2.0*R_p_3*adjoint_forward_t102 - adjoint_forward_t158*k_3_3 - adjoint_forward_t159*k_3_2
            + adjoint_forward_t91*forward_t65);
        gradient[52] = LANES(adjoint_I_1_1 + adjoint_I_1_2);
        gradient[53] = LANES(adjoint_I_2_1 + adjoint_I_2_2);
        gradient[54] = LANES(adjoint_I_3_1 + adjoint_I_3_2);
        gradient[55] = LANES(adjoint_forward_t11*(i_g_1*i_g_1));
        gradient[56] = LANES(adjoint_forward_t13*(i_g_2*i_g_2));
        gradient[57] = LANES(adjoint_forward_t15*(i_g_3*i_g_3));
        gradient[58] = LANES(2.0*I_m_1*adjoint_forward_t11*i_g_1);
        gradient[59] = LANES(2.0*I_m_2*adjoint_forward_t13*i_g_2);
        gradient[60] = LANES(2.0*I_m_3*adjoint_forward_t15*i_g_3);
        gradient[67] = LANES(-adjoint_l_f_1_1 - adjoint_l_f_1_2);
        gradient[68] = LANES(adjoint_l_f_1_1 + adjoint_l_f_1_3);
        gradient[69] = LANES(-adjoint_l_f_2_1 - adjoint_l_f_2_2);
        gradient[70] = LANES(adjoint_l_f_2_1 + adjoint_l_f_2_3);
        gradient[71] = LANES(-adjoint_l_f_3_1 - adjoint_l_f_3_2);
        gradient[72] = LANES(adjoint_l_f_3_1 + adjoint_l_f_3_3);
        gradient[76] = LANES(t299*w_b_1);
        gradient[77] = LANES(t300*w_b_2);
        gradient[78] = LANES(t301*w_b_3);
        gradient[79] = LANES(adjoint_forward_t18*forward_t17);
        gradient[81] = LANES((1.0/3.0)*adjoint_forward_t53 + (1.0/6.0)*adjoint_forward_t65);
        gradient[82] = LANES(F_T*adjoint_forward_t17);
        gradient[83] = LANES(adjoint_forward_t17*c_T);
        gradient[84] =
            LANES(D_p_x_1*shape_19*t99 + D_p_x_2*shape_19*t71 + D_p_x_3*shape_19*t50 + D_p_y_1*shape_20*t99
            + D_p_y_2*shape_20*t71 + D_p_y_3*shape_20*t50 + D_p_z_1*shape_21*t99 + D_p_z_2*shape_21*t71
            + D_p_z_3*shape_21*t50 + t105*(D_p_x_1*D_p_x_2 + D_p_y_1*D_p_y_2 + D_p_z_1*D_p_z_2)
            + t107*(D_delta_x_1*D_p_x_1 + D_delta_y_1*D_p_y_1 + D_delta_z_1*D_p_z_1)
            + t109*(D_delta_x_2*D_p_x_1 + D_delta_y_2*D_p_y_1 + D_delta_z_2*D_p_z_1)
            + t111*(D_delta_x_3*D_p_x_1 + D_delta_y_3*D_p_y_1 + D_delta_z_3*D_p_z_1) + t113*(D_p_x_1*D_p_x_3
            + D_p_y_1*D_p_y_3 + D_p_z_1*D_p_z_3) + t128*t220 + t129 + t130 + t131 + t187 + t188 + t189 + t193
            + t194 + t195 + t199 + t200 + t201 + t215 + t217 + t219 + t222*(forward_t185 + forward_t186
            + forward_t187) + t224*(forward_t188 + forward_t189 + forward_t190) + t227*t96 + t229*t69
            + t24*(forward_t182 + forward_t183 + forward_t184) + t53*(forward_t160 + forward_t162
            + forward_t164) + t55*(forward_t166 + forward_t167 + forward_t168) + t57*(forward_t169
            + forward_t170 + forward_t171) + t77*(D_p_x_2*D_p_x_3 + D_p_y_2*D_p_y_3 + D_p_z_2*D_p_z_3)
            + t79*(D_delta_x_1*D_p_x_2 + D_delta_y_1*D_p_y_2 + D_delta_z_1*D_p_z_2)
            + t81*(D_delta_x_2*D_p_x_2 + D_delta_y_2*D_p_y_2 + D_delta_z_2*D_p_z_2)
            + t83*(D_delta_x_3*D_p_x_2 + D_delta_y_3*D_p_y_2 + D_delta_z_3*D_p_z_2));
        gradient[86] = LANES(adjoint_forward_t12 + adjoint_forward_t14 + adjoint_forward_t16);
        gradient[87] = LANES(adjoint_forward_t34);
        gradient[90] =
            LANES(adjoint_forward_t173*d_1_1 + adjoint_forward_t175*d_2_1 + adjoint_forward_t177*d_3_1
            + adjoint_forward_t179*d_1_2 + adjoint_forward_t180*d_2_2 + adjoint_forward_t181*d_3_2);
        gradient[95] = LANES(adjoint_forward_t124);
        gradient[99] = LANES(adjoint_r_1_x + adjoint_r_2_x + adjoint_r_3_x);
        gradient[100] = LANES(adjoint_r_1_y + adjoint_r_2_y + adjoint_r_3_y);
        gradient[101] = LANES(adjoint_r_1_z + adjoint_r_2_z + adjoint_r_3_z);
    }
}

/* What is done with the derivatives along each path: the compiled evaluator defines it. */
struct lanes_paths;
static void lanes_direction(const struct lanes_paths *paths, int path, lane *restrict direction);
static void lanes_take(const struct lanes_paths *paths, int path, const lane *restrict mass_rate,
    const lane *restrict stiffness_rate, const lane *restrict motion_rate);

/* Derivatives of the matrices and of the motion of the platform along a direction.
 *
 * Source: forward accumulation through extended.
 * 2557 operations; 16804773 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_tangent(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int count,
    const struct lanes_paths *paths)
{
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
    const double rho_b = effects[5];
    const double c_T = effects[6];
    const double F_T = effects[7];
    const double k_C = effects[8];
    const double m_L = effects[11];
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
    const lane forward_0 = lanes_sqrt((l_d_1*l_d_1) - w2_1);
    const lane x_1 = a_1 + forward_0*sigma_1;
    const lane a_2 = n_2_x*r_2_x + n_2_y*r_2_y + n_2_z*r_2_z;
    const lane w_2_x = -a_2*n_2_x + r_2_x;
    const lane w_2_y = -a_2*n_2_y + r_2_y;
    const lane w_2_z = -a_2*n_2_z + r_2_z;
    const lane w2_2 = (w_2_x*w_2_x) + (w_2_y*w_2_y) + (w_2_z*w_2_z);
    const lane forward_1 = lanes_sqrt((l_d_2*l_d_2) - w2_2);
    const lane x_2 = a_2 + forward_1*sigma_2;
    const lane a_3 = n_3_x*r_3_x + n_3_y*r_3_y + n_3_z*r_3_z;
    const lane w_3_x = -a_3*n_3_x + r_3_x;
    const lane w_3_y = -a_3*n_3_y + r_3_y;
    const lane w_3_z = -a_3*n_3_z + r_3_z;
    const lane w2_3 = (w_3_x*w_3_x) + (w_3_y*w_3_y) + (w_3_z*w_3_z);
    const lane forward_2 = lanes_sqrt((l_d_3*l_d_3) - w2_3);
    const lane x_3 = a_3 + forward_2*sigma_3;
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
    const lane forward_3 = 1.0/det_D_l;
    const lane forward_t2 = A_x_1*forward_3;
    const lane D_p_x_1 = D_r_1*forward_t2;
    const lane forward_t3 = A_x_2*forward_3;
    const lane D_p_x_2 = D_r_2*forward_t3;
    const lane forward_t4 = A_x_3*forward_3;
    const lane D_p_x_3 = D_r_3*forward_t4;
    const lane D_delta_x_1 = forward_t2*l_d_1;
    const lane D_delta_x_2 = forward_t3*l_d_2;
    const lane D_delta_x_3 = forward_t4*l_d_3;
    const lane forward_t5 = A_y_1*forward_3;
    const lane D_p_y_1 = D_r_1*forward_t5;
    const lane forward_t6 = A_y_2*forward_3;
    const lane D_p_y_2 = D_r_2*forward_t6;
    const lane forward_t7 = A_y_3*forward_3;
    const lane D_p_y_3 = D_r_3*forward_t7;
    const lane D_delta_y_1 = forward_t5*l_d_1;
    const lane D_delta_y_2 = forward_t6*l_d_2;
    const lane D_delta_y_3 = forward_t7*l_d_3;
    const lane forward_t8 = A_z_1*forward_3;
    const lane D_p_z_1 = D_r_1*forward_t8;
    const lane forward_t9 = A_z_2*forward_3;
    const lane D_p_z_2 = D_r_2*forward_t9;
    const lane forward_t10 = A_z_3*forward_3;
    const lane D_p_z_3 = D_r_3*forward_t10;
    const lane D_delta_z_1 = forward_t8*l_d_1;
    const lane D_delta_z_2 = forward_t9*l_d_2;
    const lane D_delta_z_3 = forward_t10*l_d_3;
    const lane U_1_x_1 = D_p_x_1 - n_1_x;
    const lane U_1_y_1 = D_p_y_1 - n_1_y;
    const lane U_1_z_1 = D_p_z_1 - n_1_z;
    const lane U_2_x_2 = D_p_x_2 - n_2_x;
    const lane U_2_y_2 = D_p_y_2 - n_2_y;
    const lane U_2_z_2 = D_p_z_2 - n_2_z;
    const lane U_3_x_3 = D_p_x_3 - n_3_x;
    const lane U_3_y_3 = D_p_y_3 - n_3_y;
    const lane U_3_z_3 = D_p_z_3 - n_3_z;
    const double l_f_1_1 = x_max_1 - x_min_1;
    const double forward_t17 = F_T*c_T + 1.0;
    const double forward_t18 = c_E*forward_t17;
    const double t1 = a_B_1 + 1.0;
    const double t2 = t1*w_b_1;
    const double forward_t19 = k_sp_1*t2;
    const double forward_t20 = forward_t18*forward_t19;
    const double forward_t21 = forward_t17*forward_t19;
    const double t3 = forward_t20 + l_f_1_1;
    const double forward_4 = 1.0/t3;
    const double k_1_1 = forward_4*forward_t21;
    const double forward_t22 = (1.0/2.0)*l_t_1;
    const lane l_f_1_2 = -forward_t22 + x_1 - x_min_1;
    const lane t4 = forward_t20 + l_f_1_2;
    const lane forward_5 = 1.0/t4;
    const lane k_1_2 = forward_5*forward_t21;
    const lane l_f_1_3 = -forward_t22 - x_1 + x_max_1;
    const lane t5 = forward_t20 + l_f_1_3;
    const lane forward_6 = 1.0/t5;
    const lane k_1_3 = forward_6*forward_t21;
    const double l_f_2_1 = x_max_2 - x_min_2;
    const double t6 = a_B_2 + 1.0;
    const double t7 = t6*w_b_2;
    const double forward_t23 = k_sp_2*t7;
    const double forward_t24 = forward_t18*forward_t23;
    const double forward_t25 = forward_t17*forward_t23;
    const double t8 = forward_t24 + l_f_2_1;
    const double forward_7 = 1.0/t8;
    const double k_2_1 = forward_7*forward_t25;
    const double forward_t26 = (1.0/2.0)*l_t_2;
    const lane l_f_2_2 = -forward_t26 + x_2 - x_min_2;
    const lane t9 = forward_t24 + l_f_2_2;
    const lane forward_8 = 1.0/t9;
    const lane k_2_2 = forward_8*forward_t25;
    const lane l_f_2_3 = -forward_t26 - x_2 + x_max_2;
    const lane t10 = forward_t24 + l_f_2_3;
    const lane forward_9 = 1.0/t10;
    const lane k_2_3 = forward_9*forward_t25;
    const double l_f_3_1 = x_max_3 - x_min_3;
    const double t11 = a_B_3 + 1.0;
    const double t12 = t11*w_b_3;
    const double forward_t27 = k_sp_3*t12;
    const double forward_t28 = forward_t18*forward_t27;
    const double forward_t29 = forward_t17*forward_t27;
    const double t13 = forward_t28 + l_f_3_1;
    const double forward_10 = 1.0/t13;
    const double k_3_1 = forward_10*forward_t29;
    const double forward_t30 = (1.0/2.0)*l_t_3;
    const lane l_f_3_2 = -forward_t30 + x_3 - x_min_3;
    const lane t14 = forward_t28 + l_f_3_2;
    const lane forward_11 = 1.0/t14;
    const lane k_3_2 = forward_11*forward_t29;
    const lane l_f_3_3 = -forward_t30 - x_3 + x_max_3;
    const lane t15 = forward_t28 + l_f_3_3;
    const lane forward_12 = 1.0/t15;
    const lane k_3_3 = forward_12*forward_t29;
    const double forward_t31 = (1.0/2.0)*m_d_1;
    const double forward_t32 = (1.0/2.0)*m_d_2;
    const double forward_t33 = (1.0/2.0)*m_d_3;
    const double forward_t34 = m_L + m_p;
    const double forward_t35 = forward_t31 + forward_t32 + forward_t33 + forward_t34;
    const double forward_t36 = forward_t35*g_x;
    const double forward_t37 = forward_t35*g_y;
    const double forward_t38 = forward_t35*g_z;
    const lane t16 = -A_x_1*forward_t36 - A_y_1*forward_t37 - A_z_1*forward_t38;
    const lane mu_1 = forward_3*t16;
    const lane t17 = -A_x_2*forward_t36 - A_y_2*forward_t37 - A_z_2*forward_t38;
    const lane mu_2 = forward_3*t17;
    const lane t18 = -A_x_3*forward_t36 - A_y_3*forward_t37 - A_z_3*forward_t38;
    const lane mu_3 = forward_3*t18;
    const double forward_t39 = (1.0/3.0)*m_d_1;
    const double forward_t40 = (1.0/6.0)*m_d_1;
    const double forward_t41 = forward_t40*n_1_x;
    const double forward_t42 = (1.0/3.0)*m_d_2;
    const double forward_t43 = (1.0/3.0)*m_d_3;
    const double forward_t44 = forward_t34 + forward_t39 + forward_t42 + forward_t43;
    const lane forward_t45 = D_p_x_1*forward_t44;
    const lane forward_t46 = forward_t41 + forward_t45;
    const double forward_t47 = forward_t40*n_1_y;
    const lane forward_t48 = D_p_y_1*forward_t44;
    const lane forward_t49 = forward_t47 + forward_t48;
    const double forward_t50 = forward_t40*n_1_z;
    const lane forward_t51 = D_p_z_1*forward_t44;
    const lane forward_t52 = forward_t50 + forward_t51;
    const double forward_t53 = (1.0/3.0)*rho_b;
    const lane forward_t54 = forward_t53*l_f_1_2;
    const lane forward_t55 = forward_t53*l_f_1_3;
    const double forward_t57 = (1.0/6.0)*m_d_2;
    const double forward_t58 = forward_t57*n_2_x;
    const double forward_t59 = forward_t57*n_2_y;
    const double forward_t60 = forward_t57*n_2_z;
    const double forward_t61 = (1.0/6.0)*m_d_3;
    const double forward_t62 = forward_t61*n_3_x;
    const double forward_t63 = forward_t61*n_3_y;
    const double forward_t64 = forward_t61*n_3_z;
    const double forward_t65 = (1.0/6.0)*rho_b;
    const double forward_t66 = R_p_1*forward_t65;
    const double forward_t69 = forward_t40 + forward_t57 + forward_t61;
    const lane forward_t70 = D_p_x_2*forward_t44;
    const lane forward_t71 = forward_t58 + forward_t70;
    const lane forward_t72 = D_p_y_2*forward_t44;
    const lane forward_t73 = forward_t59 + forward_t72;
    const lane forward_t74 = D_p_z_2*forward_t44;
    const lane forward_t75 = forward_t60 + forward_t74;
    const lane forward_t76 = forward_t53*l_f_2_2;
    const lane forward_t77 = forward_t53*l_f_2_3;
    const double forward_t79 = R_p_2*forward_t65;
    const lane forward_t82 = D_p_x_3*forward_t44;
    const lane forward_t83 = forward_t62 + forward_t82;
    const lane forward_t84 = D_p_y_3*forward_t44;
    const lane forward_t85 = forward_t63 + forward_t84;
    const lane forward_t86 = D_p_z_3*forward_t44;
    const lane forward_t87 = forward_t64 + forward_t86;
    const lane forward_t88 = forward_t53*l_f_3_2;
    const lane forward_t89 = forward_t53*l_f_3_3;
    const double forward_t91 = R_p_3*forward_t65;
    const double forward_t94 = (R_p_1*R_p_1);
    const double forward_t95 = forward_t94*l_f_1_1;
    const double forward_t98 = (R_p_2*R_p_2);
    const double forward_t99 = forward_t98*l_f_2_1;
    const double forward_t102 = (R_p_3*R_p_3);
    const double forward_t103 = forward_t102*l_f_3_1;
    const lane forward_t109 = (D_delta_x_1*D_delta_x_1);
    const lane forward_t110 = (D_delta_y_1*D_delta_y_1);
    const lane forward_t111 = (D_delta_z_1*D_delta_z_1);
    const lane forward_t112 = D_delta_x_1*forward_t44;
    const lane forward_t113 = D_delta_y_1*forward_t44;
    const lane forward_t114 = D_delta_z_1*forward_t44;
    const lane forward_t115 = (D_delta_x_2*D_delta_x_2);
    const lane forward_t116 = (D_delta_y_2*D_delta_y_2);
    const lane forward_t117 = (D_delta_z_2*D_delta_z_2);
    const lane forward_t118 = D_delta_x_2*forward_t44;
    const lane forward_t119 = D_delta_y_2*forward_t44;
    const lane forward_t120 = D_delta_z_2*forward_t44;
    const lane forward_t121 = (D_delta_x_3*D_delta_x_3);
    const lane forward_t122 = (D_delta_y_3*D_delta_y_3);
    const lane forward_t123 = (D_delta_z_3*D_delta_z_3);
    const lane forward_t125 = (D_p_x_1*D_p_x_1);
    const lane forward_t126 = (D_p_y_1*D_p_y_1);
    const lane forward_t127 = (D_p_z_1*D_p_z_1);
    const lane forward_t128 = D_p_x_1*mu_3;
    const lane forward_t129 = D_p_x_1*mu_2;
    const lane forward_t130 = U_1_x_1*mu_1;
    const lane forward_t131 = D_p_y_1*mu_3;
    const lane forward_t132 = D_p_y_1*mu_2;
    const lane forward_t133 = U_1_y_1*mu_1;
    const lane forward_t134 = D_p_z_1*mu_3;
    const lane forward_t135 = D_p_z_1*mu_2;
    const lane forward_t136 = U_1_z_1*mu_1;
    const lane forward_t140 = (D_p_x_2*D_p_x_2);
    const lane forward_t141 = (D_p_y_2*D_p_y_2);
    const lane forward_t142 = (D_p_z_2*D_p_z_2);
    const lane forward_t143 = D_p_x_2*mu_1;
    const lane forward_t144 = D_p_x_2*mu_3;
    const lane forward_t145 = U_2_x_2*mu_2;
    const lane forward_t146 = D_p_y_2*mu_1;
    const lane forward_t147 = D_p_y_2*mu_3;
    const lane forward_t148 = U_2_y_2*mu_2;
    const lane forward_t149 = D_p_z_2*mu_1;
    const lane forward_t150 = D_p_z_2*mu_3;
    const lane forward_t151 = U_2_z_2*mu_2;
    const lane forward_t155 = (D_p_x_3*D_p_x_3);
    const lane forward_t156 = (D_p_y_3*D_p_y_3);
    const lane forward_t157 = (D_p_z_3*D_p_z_3);
    const lane forward_t160 = D_delta_x_1*D_p_x_3;
    const lane forward_t161 = U_3_x_3*mu_3;
    const lane forward_t162 = D_delta_y_1*D_p_y_3;
    const lane forward_t163 = U_3_y_3*mu_3;
    const lane forward_t164 = D_delta_z_1*D_p_z_3;
    const lane forward_t165 = U_3_z_3*mu_3;
    const lane forward_t166 = D_delta_x_2*D_p_x_3;
    const lane forward_t167 = D_delta_y_2*D_p_y_3;
    const lane forward_t168 = D_delta_z_2*D_p_z_3;
    const lane forward_t169 = D_delta_x_3*D_p_x_3;
    const lane forward_t170 = D_delta_y_3*D_p_y_3;
    const lane forward_t171 = D_delta_z_3*D_p_z_3;
    const lane forward_t182 = D_delta_x_1*D_delta_x_2;
    const lane forward_t183 = D_delta_y_1*D_delta_y_2;
    const lane forward_t184 = D_delta_z_1*D_delta_z_2;
    const lane forward_t185 = D_delta_x_1*D_delta_x_3;
    const lane forward_t186 = D_delta_y_1*D_delta_y_3;
    const lane forward_t187 = D_delta_z_1*D_delta_z_3;
    const lane forward_t188 = D_delta_x_2*D_delta_x_3;
    const lane forward_t189 = D_delta_y_2*D_delta_y_3;
    const lane forward_t190 = D_delta_z_2*D_delta_z_3;
    const lane t19 = 1.0/forward_0;
    const lane t20 = 1.0/forward_1;
    const lane t21 = 1.0/forward_2;
    const double t31 = 1.0/((t3*t3));
    const lane t32 = 1.0/((t4*t4));
    const lane t33 = 1.0/((t5*t5));
    const double t34 = 1.0/((t8*t8));
    const lane t35 = 1.0/((t9*t9));
    const lane t36 = 1.0/((t10*t10));
    const double t37 = 1.0/((t13*t13));
    const lane t38 = 1.0/((t14*t14));
    const lane t39 = 1.0/((t15*t15));
    const lane t76 = forward_t109 + forward_t110 + forward_t111;
    const lane t77 = forward_t115 + forward_t116 + forward_t117;
    const lane t78 = forward_t121 + forward_t122 + forward_t123;
    const double t79 = forward_t44 + forward_t69;
    const lane t80 = forward_t125 + forward_t126 + forward_t127;
    const lane t81 = -k_C + mu_3;
    const lane t82 = -mu_2 - t81;
    const lane t83 = -D_p_x_1*k_C + forward_t130;
    const lane t84 = forward_t128 + t83;
    const lane t85 = -D_p_y_1*k_C + forward_t133;
    const lane t86 = forward_t131 + t85;
    const lane t87 = -D_p_z_1*k_C + forward_t136;
    const lane t88 = forward_t134 + t87;
    const lane t89 = -forward_t129 - t84;
    const lane t90 = -forward_t132 - t86;
    const lane t91 = -forward_t135 - t88;
    const lane t92 = forward_t140 + forward_t141 + forward_t142;
    const lane t93 = -mu_1 - t81;
    const lane t94 = -D_p_x_2*k_C + forward_t143 + forward_t145;
    const lane t95 = -D_p_y_2*k_C + forward_t146 + forward_t148;
    const lane t96 = -D_p_z_2*k_C + forward_t149 + forward_t151;
    const lane t97 = -forward_t144 - t94;
    const lane t98 = -forward_t147 - t95;
    const lane t99 = -forward_t150 - t96;
    const lane t100 = forward_t155 + forward_t156 + forward_t157;
    const lane t101 = mu_1 + mu_2;
    const lane t102 = k_C - t101;
    const lane t103 = D_p_x_3*k_C - forward_t161;
    const lane t104 = D_p_y_3*k_C - forward_t163;
    const lane t105 = D_p_z_3*k_C - forward_t165;
    const lane t106 = -forward_t160 - forward_t162 - forward_t164;
    const lane t107 = -forward_t166 - forward_t167 - forward_t168;
    const lane t108 = -forward_t169 - forward_t170 - forward_t171;
    const lane t109 = -t101 - t81;
    const lane t110 = -mu_3 - t101;
    const lane t111 = -forward_t182 - forward_t183 - forward_t184;
    const lane t112 = -forward_t185 - forward_t186 - forward_t187;
    const lane t113 = -forward_t188 - forward_t189 - forward_t190;
    for (int path = 0; path < count; path++) {
        lane direction[LANES_GRADIENT], motion_rate[LANES_DIRECTIONS * LANES_ALL];
        lane mass_rate[LANES_ALL * LANES_ALL], stiffness_rate[LANES_ALL * LANES_ALL];
        lanes_direction(paths, path, direction);
        const lane along_1 = direction[0];
        const lane along_2 = direction[1];
        const lane along_3 = direction[2];
        const lane along_4 = direction[3];
        const lane along_5 = direction[4];
        const lane along_6 = direction[5];
        const lane along_7 = direction[6];
        const lane along_8 = direction[7];
        const lane along_9 = direction[8];
        const lane along_10 = direction[9];
        const lane along_11 = direction[10];
        const lane along_12 = direction[11];
        const lane along_13 = direction[12];
        const lane along_23 = direction[22];
        const lane along_24 = direction[23];
        const lane along_25 = direction[24];
        const lane along_26 = direction[25];
        const lane along_27 = direction[26];
        const lane along_28 = direction[27];
        const lane along_29 = direction[28];
        const lane along_30 = direction[29];
        const lane along_31 = direction[30];
        const lane along_32 = direction[31];
        const lane along_33 = direction[32];
        const lane along_34 = direction[33];
        const lane along_35 = direction[34];
        const lane along_36 = direction[35];
        const lane along_37 = direction[36];
        const lane along_38 = direction[37];
        const lane along_39 = direction[38];
        const lane along_40 = direction[39];
        const lane along_41 = direction[40];
        const lane along_42 = direction[41];
        const lane along_43 = direction[42];
        const lane along_44 = direction[43];
        const lane along_45 = direction[44];
        const lane along_46 = direction[45];
        const lane along_47 = direction[46];
        const lane along_48 = direction[47];
        const lane along_49 = direction[48];
        const lane along_50 = direction[49];
        const lane along_51 = direction[50];
        const lane along_52 = direction[51];
        const lane along_53 = direction[52];
        const lane along_54 = direction[53];
        const lane along_55 = direction[54];
        const lane along_56 = direction[55];
        const lane along_57 = direction[56];
        const lane along_58 = direction[57];
        const lane along_59 = direction[58];
        const lane along_60 = direction[59];
        const lane along_61 = direction[60];
        const lane along_68 = direction[67];
        const lane along_69 = direction[68];
        const lane along_70 = direction[69];
        const lane along_71 = direction[70];
        const lane along_72 = direction[71];
        const lane along_73 = direction[72];
        const lane along_77 = direction[76];
        const lane along_78 = direction[77];
        const lane along_79 = direction[78];
        const lane along_80 = direction[79];
        const lane along_82 = direction[81];
        const lane along_83 = direction[82];
        const lane along_84 = direction[83];
        const lane along_85 = direction[84];
        const lane along_87 = direction[86];
        const lane along_88 = direction[87];
        const lane along_91 = direction[90];
        const lane along_96 = direction[95];
        const lane along_100 = direction[99];
        const lane along_101 = direction[100];
        const lane along_102 = direction[101];
        const lane tangent_r_1_x = along_100 + along_23 - along_5;
        const lane tangent_r_1_y = along_101 + along_24 - along_6;
        const lane tangent_r_1_z = along_102 + along_25 - along_7;
        const lane tangent_r_2_x = along_100 + along_26 - along_8;
        const lane tangent_r_2_y = along_101 + along_27 - along_9;
        const lane tangent_r_2_z = -along_10 + along_102 + along_28;
        const lane tangent_r_3_x = along_100 - along_11 + along_29;
        const lane tangent_r_3_y = along_101 - along_12 + along_30;
        const lane tangent_r_3_z = along_102 - along_13 + along_31;
        const lane tangent_a_1 = n_1_x*tangent_r_1_x + n_1_y*tangent_r_1_y + n_1_z*tangent_r_1_z;
        const lane tangent_w_1_x = -n_1_x*tangent_a_1 + tangent_r_1_x;
        const lane tangent_w_1_y = -n_1_y*tangent_a_1 + tangent_r_1_y;
        const lane tangent_w_1_z = -n_1_z*tangent_a_1 + tangent_r_1_z;
        const lane tangent_w2_1 = 2.0*tangent_w_1_x*w_1_x + 2.0*tangent_w_1_y*w_1_y + 2.0*tangent_w_1_z*w_1_z;
        const lane tangent_forward_0 = along_32*l_d_1*t19 - 1.0/2.0*t19*tangent_w2_1;
        const lane tangent_x_1 = sigma_1*tangent_forward_0 + tangent_a_1;
        const lane tangent_a_2 = n_2_x*tangent_r_2_x + n_2_y*tangent_r_2_y + n_2_z*tangent_r_2_z;
        const lane tangent_w_2_x = -n_2_x*tangent_a_2 + tangent_r_2_x;
        const lane tangent_w_2_y = -n_2_y*tangent_a_2 + tangent_r_2_y;
        const lane tangent_w_2_z = -n_2_z*tangent_a_2 + tangent_r_2_z;
        const lane tangent_w2_2 = 2.0*tangent_w_2_x*w_2_x + 2.0*tangent_w_2_y*w_2_y + 2.0*tangent_w_2_z*w_2_z;
        const lane tangent_forward_1 = along_33*l_d_2*t20 - 1.0/2.0*t20*tangent_w2_2;
        const lane tangent_x_2 = sigma_2*tangent_forward_1 + tangent_a_2;
        const lane tangent_a_3 = n_3_x*tangent_r_3_x + n_3_y*tangent_r_3_y + n_3_z*tangent_r_3_z;
        const lane tangent_w_3_x = -n_3_x*tangent_a_3 + tangent_r_3_x;
        const lane tangent_w_3_y = -n_3_y*tangent_a_3 + tangent_r_3_y;
        const lane tangent_w_3_z = -n_3_z*tangent_a_3 + tangent_r_3_z;
        const lane tangent_w2_3 = 2.0*tangent_w_3_x*w_3_x + 2.0*tangent_w_3_y*w_3_y + 2.0*tangent_w_3_z*w_3_z;
        const lane tangent_forward_2 = along_34*l_d_3*t21 - 1.0/2.0*t21*tangent_w2_3;
        const lane tangent_x_3 = sigma_3*tangent_forward_2 + tangent_a_3;
        const lane tangent_s_1_x = -n_1_x*tangent_x_1 + tangent_r_1_x;
        const lane tangent_s_1_y = -n_1_y*tangent_x_1 + tangent_r_1_y;
        const lane tangent_s_1_z = -n_1_z*tangent_x_1 + tangent_r_1_z;
        const lane tangent_s_2_x = -n_2_x*tangent_x_2 + tangent_r_2_x;
        const lane tangent_s_2_y = -n_2_y*tangent_x_2 + tangent_r_2_y;
        const lane tangent_s_2_z = -n_2_z*tangent_x_2 + tangent_r_2_z;
        const lane tangent_s_3_x = -n_3_x*tangent_x_3 + tangent_r_3_x;
        const lane tangent_s_3_y = -n_3_y*tangent_x_3 + tangent_r_3_y;
        const lane tangent_s_3_z = -n_3_z*tangent_x_3 + tangent_r_3_z;
        const lane tangent_D_r_1 = n_1_x*tangent_s_1_x + n_1_y*tangent_s_1_y + n_1_z*tangent_s_1_z;
        const lane tangent_D_r_2 = n_2_x*tangent_s_2_x + n_2_y*tangent_s_2_y + n_2_z*tangent_s_2_z;
        const lane tangent_D_r_3 = n_3_x*tangent_s_3_x + n_3_y*tangent_s_3_y + n_3_z*tangent_s_3_z;
        const lane tangent_A_x_1 =
            s_2_y*tangent_s_3_z - s_2_z*tangent_s_3_y - s_3_y*tangent_s_2_z + s_3_z*tangent_s_2_y;
        const lane tangent_A_y_1 =
            -s_2_x*tangent_s_3_z + s_2_z*tangent_s_3_x + s_3_x*tangent_s_2_z - s_3_z*tangent_s_2_x;
        const lane tangent_A_z_1 =
            s_2_x*tangent_s_3_y - s_2_y*tangent_s_3_x - s_3_x*tangent_s_2_y + s_3_y*tangent_s_2_x;
        const lane tangent_A_x_2 =
            -s_1_y*tangent_s_3_z + s_1_z*tangent_s_3_y + s_3_y*tangent_s_1_z - s_3_z*tangent_s_1_y;
        const lane tangent_A_y_2 =
            s_1_x*tangent_s_3_z - s_1_z*tangent_s_3_x - s_3_x*tangent_s_1_z + s_3_z*tangent_s_1_x;
        const lane tangent_A_z_2 =
            -s_1_x*tangent_s_3_y + s_1_y*tangent_s_3_x + s_3_x*tangent_s_1_y - s_3_y*tangent_s_1_x;
        const lane tangent_A_x_3 =
            s_1_y*tangent_s_2_z - s_1_z*tangent_s_2_y - s_2_y*tangent_s_1_z + s_2_z*tangent_s_1_y;
        const lane tangent_A_y_3 =
            -s_1_x*tangent_s_2_z + s_1_z*tangent_s_2_x + s_2_x*tangent_s_1_z - s_2_z*tangent_s_1_x;
        const lane tangent_A_z_3 =
            s_1_x*tangent_s_2_y - s_1_y*tangent_s_2_x - s_2_x*tangent_s_1_y + s_2_y*tangent_s_1_x;
        const lane tangent_det_D_l =
            A_x_1*tangent_s_1_x + A_y_1*tangent_s_1_y + A_z_1*tangent_s_1_z + s_1_x*tangent_A_x_1
            + s_1_y*tangent_A_y_1 + s_1_z*tangent_A_z_1;
        const lane tangent_forward_3 = -(forward_3*forward_3)*tangent_det_D_l;
        const lane t22 = forward_3*tangent_A_x_1;
        const lane tangent_forward_t2 = A_x_1*tangent_forward_3 + t22;
        const lane tangent_D_p_x_1 = D_r_1*tangent_forward_t2 + forward_t2*tangent_D_r_1;
        const lane t23 = forward_3*tangent_A_x_2;
        const lane tangent_forward_t3 = A_x_2*tangent_forward_3 + t23;
        const lane tangent_D_p_x_2 = D_r_2*tangent_forward_t3 + forward_t3*tangent_D_r_2;
        const lane t24 = forward_3*tangent_A_x_3;
        const lane tangent_forward_t4 = A_x_3*tangent_forward_3 + t24;
        const lane tangent_D_p_x_3 = D_r_3*tangent_forward_t4 + forward_t4*tangent_D_r_3;
        const lane tangent_D_delta_x_1 = along_32*forward_t2 + l_d_1*tangent_forward_t2;
        const lane tangent_D_delta_x_2 = along_33*forward_t3 + l_d_2*tangent_forward_t3;
        const lane tangent_D_delta_x_3 = along_34*forward_t4 + l_d_3*tangent_forward_t4;
        const lane t25 = forward_3*tangent_A_y_1;
        const lane tangent_forward_t5 = A_y_1*tangent_forward_3 + t25;
        const lane tangent_D_p_y_1 = D_r_1*tangent_forward_t5 + forward_t5*tangent_D_r_1;
        const lane t26 = forward_3*tangent_A_y_2;
        const lane tangent_forward_t6 = A_y_2*tangent_forward_3 + t26;
        const lane tangent_D_p_y_2 = D_r_2*tangent_forward_t6 + forward_t6*tangent_D_r_2;
        const lane t27 = forward_3*tangent_A_y_3;
        const lane tangent_forward_t7 = A_y_3*tangent_forward_3 + t27;
        const lane tangent_D_p_y_3 = D_r_3*tangent_forward_t7 + forward_t7*tangent_D_r_3;
        const lane tangent_D_delta_y_1 = along_32*forward_t5 + l_d_1*tangent_forward_t5;
        const lane tangent_D_delta_y_2 = along_33*forward_t6 + l_d_2*tangent_forward_t6;
        const lane tangent_D_delta_y_3 = along_34*forward_t7 + l_d_3*tangent_forward_t7;
        const lane t28 = forward_3*tangent_A_z_1;
        const lane tangent_forward_t8 = A_z_1*tangent_forward_3 + t28;
        const lane tangent_D_p_z_1 = D_r_1*tangent_forward_t8 + forward_t8*tangent_D_r_1;
        const lane t29 = forward_3*tangent_A_z_2;
        const lane tangent_forward_t9 = A_z_2*tangent_forward_3 + t29;
        const lane tangent_D_p_z_2 = D_r_2*tangent_forward_t9 + forward_t9*tangent_D_r_2;
        const lane t30 = forward_3*tangent_A_z_3;
        const lane tangent_forward_t10 = A_z_3*tangent_forward_3 + t30;
        const lane tangent_D_p_z_3 = D_r_3*tangent_forward_t10 + forward_t10*tangent_D_r_3;
        const lane tangent_D_delta_z_1 = along_32*forward_t8 + l_d_1*tangent_forward_t8;
        const lane tangent_D_delta_z_2 = along_33*forward_t9 + l_d_2*tangent_forward_t9;
        const lane tangent_D_delta_z_3 = along_34*forward_t10 + l_d_3*tangent_forward_t10;
        const lane tangent_forward_t11 = 2.0*I_m_1*along_59*i_g_1 + along_56*(i_g_1*i_g_1);
        const lane tangent_forward_t12 = along_87 + tangent_forward_t11;
        const lane tangent_I_1_1 = along_53 + d_1_1*tangent_forward_t12;
        const lane tangent_I_1_2 = along_53 + d_1_2*tangent_forward_t12;
        const lane tangent_forward_t13 = 2.0*I_m_2*along_60*i_g_2 + along_57*(i_g_2*i_g_2);
        const lane tangent_forward_t14 = along_87 + tangent_forward_t13;
        const lane tangent_I_2_1 = along_54 + d_2_1*tangent_forward_t14;
        const lane tangent_I_2_2 = along_54 + d_2_2*tangent_forward_t14;
        const lane tangent_forward_t15 = 2.0*I_m_3*along_61*i_g_3 + along_58*(i_g_3*i_g_3);
        const lane tangent_forward_t16 = along_87 + tangent_forward_t15;
        const lane tangent_I_3_1 = along_55 + d_3_1*tangent_forward_t16;
        const lane tangent_I_3_2 = along_55 + d_3_2*tangent_forward_t16;
        const lane tangent_l_f_1_1 = -along_68 + along_69;
        const lane tangent_forward_t17 = F_T*along_83 + along_84*c_T;
        const lane tangent_forward_t18 = along_80*forward_t17 + c_E*tangent_forward_t17;
        const lane tangent_forward_t19 = along_44*t2 + along_47*k_sp_1*t1 + along_77*k_sp_1*w_b_1;
        const lane tangent_forward_t20 = forward_t18*tangent_forward_t19 + forward_t19*tangent_forward_t18;
        const lane tangent_forward_t21 = forward_t17*tangent_forward_t19 + forward_t19*tangent_forward_t17;
        const lane tangent_forward_4 = -t31*tangent_forward_t20 - t31*tangent_l_f_1_1;
        const lane tangent_k_1_1 = forward_4*tangent_forward_t21 + forward_t21*tangent_forward_4;
        const lane tangent_forward_t22 = (1.0/2.0)*along_41;
        const lane tangent_l_f_1_2 = -along_68 - tangent_forward_t22 + tangent_x_1;
        const lane tangent_forward_5 = -t32*tangent_forward_t20 - t32*tangent_l_f_1_2;
        const lane tangent_k_1_2 = forward_5*tangent_forward_t21 + forward_t21*tangent_forward_5;
        const lane tangent_l_f_1_3 = along_69 - tangent_forward_t22 - tangent_x_1;
        const lane tangent_forward_6 = -t33*tangent_forward_t20 - t33*tangent_l_f_1_3;
        const lane tangent_k_1_3 = forward_6*tangent_forward_t21 + forward_t21*tangent_forward_6;
        const lane tangent_l_f_2_1 = -along_70 + along_71;
        const lane tangent_forward_t23 = along_45*t7 + along_48*k_sp_2*t6 + along_78*k_sp_2*w_b_2;
        const lane tangent_forward_t24 = forward_t18*tangent_forward_t23 + forward_t23*tangent_forward_t18;
        const lane tangent_forward_t25 = forward_t17*tangent_forward_t23 + forward_t23*tangent_forward_t17;
        const lane tangent_forward_7 = -t34*tangent_forward_t24 - t34*tangent_l_f_2_1;
        const lane tangent_k_2_1 = forward_7*tangent_forward_t25 + forward_t25*tangent_forward_7;
        const lane tangent_forward_t26 = (1.0/2.0)*along_42;
        const lane tangent_l_f_2_2 = -along_70 - tangent_forward_t26 + tangent_x_2;
        const lane tangent_forward_8 = -t35*tangent_forward_t24 - t35*tangent_l_f_2_2;
        const lane tangent_k_2_2 = forward_8*tangent_forward_t25 + forward_t25*tangent_forward_8;
        const lane tangent_l_f_2_3 = along_71 - tangent_forward_t26 - tangent_x_2;
        const lane tangent_forward_9 = -t36*tangent_forward_t24 - t36*tangent_l_f_2_3;
        const lane tangent_k_2_3 = forward_9*tangent_forward_t25 + forward_t25*tangent_forward_9;
        const lane tangent_l_f_3_1 = -along_72 + along_73;
        const lane tangent_forward_t27 = along_46*t12 + along_49*k_sp_3*t11 + along_79*k_sp_3*w_b_3;
        const lane tangent_forward_t28 = forward_t18*tangent_forward_t27 + forward_t27*tangent_forward_t18;
        const lane tangent_forward_t29 = forward_t17*tangent_forward_t27 + forward_t27*tangent_forward_t17;
        const lane tangent_forward_10 = -t37*tangent_forward_t28 - t37*tangent_l_f_3_1;
        const lane tangent_k_3_1 = forward_10*tangent_forward_t29 + forward_t29*tangent_forward_10;
        const lane tangent_forward_t30 = (1.0/2.0)*along_43;
        const lane tangent_l_f_3_2 = -along_72 - tangent_forward_t30 + tangent_x_3;
        const lane tangent_forward_11 = -t38*tangent_forward_t28 - t38*tangent_l_f_3_2;
        const lane tangent_k_3_2 = forward_11*tangent_forward_t29 + forward_t29*tangent_forward_11;
        const lane tangent_l_f_3_3 = along_73 - tangent_forward_t30 - tangent_x_3;
        const lane tangent_forward_12 = -t39*tangent_forward_t28 - t39*tangent_l_f_3_3;
        const lane tangent_k_3_3 = forward_12*tangent_forward_t29 + forward_t29*tangent_forward_12;
        const lane tangent_forward_t31 = (1.0/2.0)*along_35;
        const lane tangent_forward_t32 = (1.0/2.0)*along_36;
        const lane tangent_forward_t33 = (1.0/2.0)*along_37;
        const lane tangent_forward_t34 = along_1 + along_88;
        const lane tangent_forward_t35 =
            tangent_forward_t31 + tangent_forward_t32 + tangent_forward_t33 + tangent_forward_t34;
        const lane tangent_forward_t36 = along_2*forward_t35 + g_x*tangent_forward_t35;
        const lane tangent_forward_t37 = along_3*forward_t35 + g_y*tangent_forward_t35;
        const lane tangent_forward_t38 = along_4*forward_t35 + g_z*tangent_forward_t35;
        const lane tangent_mu_1 =
            -forward_t2*tangent_forward_t36 - forward_t36*t22 - forward_t37*t25 - forward_t38*t28
            - forward_t5*tangent_forward_t37 - forward_t8*tangent_forward_t38 + t16*tangent_forward_3;
        const lane tangent_mu_2 =
            -forward_t3*tangent_forward_t36 - forward_t36*t23 - forward_t37*t26 - forward_t38*t29
            - forward_t6*tangent_forward_t37 - forward_t9*tangent_forward_t38 + t17*tangent_forward_3;
        const lane tangent_mu_3 =
            -forward_t10*tangent_forward_t38 - forward_t36*t24 - forward_t37*t27 - forward_t38*t30
            - forward_t4*tangent_forward_t36 - forward_t7*tangent_forward_t37 + t18*tangent_forward_3;
        const lane tangent_forward_t39 = (1.0/3.0)*along_35;
        const lane tangent_forward_t40 = (1.0/6.0)*along_35;
        const lane tangent_forward_t41 = n_1_x*tangent_forward_t40;
        const lane tangent_forward_t42 = (1.0/3.0)*along_36;
        const lane tangent_forward_t43 = (1.0/3.0)*along_37;
        const lane tangent_forward_t44 =
            tangent_forward_t34 + tangent_forward_t39 + tangent_forward_t42 + tangent_forward_t43;
        const lane tangent_forward_t45 = D_p_x_1*tangent_forward_t44 + forward_t44*tangent_D_p_x_1;
        const lane tangent_forward_t46 = tangent_forward_t41 + tangent_forward_t45;
        const lane tangent_forward_t47 = n_1_y*tangent_forward_t40;
        const lane tangent_forward_t48 = D_p_y_1*tangent_forward_t44 + forward_t44*tangent_D_p_y_1;
        const lane tangent_forward_t49 = tangent_forward_t47 + tangent_forward_t48;
        const lane tangent_forward_t50 = n_1_z*tangent_forward_t40;
        const lane tangent_forward_t51 = D_p_z_1*tangent_forward_t44 + forward_t44*tangent_D_p_z_1;
        const lane tangent_forward_t52 = tangent_forward_t50 + tangent_forward_t51;
        const lane tangent_forward_t53 = (1.0/3.0)*along_82;
        const lane tangent_forward_t54 = forward_t53*tangent_l_f_1_2 + l_f_1_2*tangent_forward_t53;
        const lane tangent_forward_t55 = forward_t53*tangent_l_f_1_3 + l_f_1_3*tangent_forward_t53;
        const lane tangent_forward_t56 = tangent_forward_t54 + tangent_forward_t55;
        const lane tangent_forward_t57 = (1.0/6.0)*along_36;
        const lane tangent_forward_t58 = n_2_x*tangent_forward_t57;
        const lane tangent_forward_t59 = n_2_y*tangent_forward_t57;
        const lane tangent_forward_t60 = n_2_z*tangent_forward_t57;
        const lane tangent_forward_t61 = (1.0/6.0)*along_37;
        const lane tangent_forward_t62 = n_3_x*tangent_forward_t61;
        const lane tangent_forward_t63 = n_3_y*tangent_forward_t61;
        const lane tangent_forward_t64 = n_3_z*tangent_forward_t61;
        const lane tangent_forward_t65 = (1.0/6.0)*along_82;
        const lane tangent_forward_t66 = R_p_1*tangent_forward_t65 + along_50*forward_t65;
        const lane tangent_forward_t67 = forward_t66*tangent_l_f_1_3 + l_f_1_3*tangent_forward_t66;
        const lane tangent_forward_t68 = forward_t66*tangent_l_f_1_2 + l_f_1_2*tangent_forward_t66;
        const lane tangent_forward_t69 = tangent_forward_t40 + tangent_forward_t57 + tangent_forward_t61;
        const lane tangent_forward_t70 = D_p_x_2*tangent_forward_t44 + forward_t44*tangent_D_p_x_2;
        const lane tangent_forward_t71 = tangent_forward_t58 + tangent_forward_t70;
        const lane tangent_forward_t72 = D_p_y_2*tangent_forward_t44 + forward_t44*tangent_D_p_y_2;
        const lane tangent_forward_t73 = tangent_forward_t59 + tangent_forward_t72;
        const lane tangent_forward_t74 = D_p_z_2*tangent_forward_t44 + forward_t44*tangent_D_p_z_2;
        const lane tangent_forward_t75 = tangent_forward_t60 + tangent_forward_t74;
        const lane tangent_forward_t76 = forward_t53*tangent_l_f_2_2 + l_f_2_2*tangent_forward_t53;
        const lane tangent_forward_t77 = forward_t53*tangent_l_f_2_3 + l_f_2_3*tangent_forward_t53;
        const lane tangent_forward_t78 = tangent_forward_t76 + tangent_forward_t77;
        const lane tangent_forward_t79 = R_p_2*tangent_forward_t65 + along_51*forward_t65;
        const lane tangent_forward_t80 = forward_t79*tangent_l_f_2_3 + l_f_2_3*tangent_forward_t79;
        const lane tangent_forward_t81 = forward_t79*tangent_l_f_2_2 + l_f_2_2*tangent_forward_t79;
        const lane tangent_forward_t82 = D_p_x_3*tangent_forward_t44 + forward_t44*tangent_D_p_x_3;
        const lane tangent_forward_t83 = tangent_forward_t62 + tangent_forward_t82;
        const lane tangent_forward_t84 = D_p_y_3*tangent_forward_t44 + forward_t44*tangent_D_p_y_3;
        const lane tangent_forward_t85 = tangent_forward_t63 + tangent_forward_t84;
        const lane tangent_forward_t86 = D_p_z_3*tangent_forward_t44 + forward_t44*tangent_D_p_z_3;
        const lane tangent_forward_t87 = tangent_forward_t64 + tangent_forward_t86;
        const lane tangent_forward_t88 = forward_t53*tangent_l_f_3_2 + l_f_3_2*tangent_forward_t53;
        const lane tangent_forward_t89 = forward_t53*tangent_l_f_3_3 + l_f_3_3*tangent_forward_t53;
        const lane tangent_forward_t90 = tangent_forward_t88 + tangent_forward_t89;
        const lane tangent_forward_t91 = R_p_3*tangent_forward_t65 + along_52*forward_t65;
        const lane tangent_forward_t92 = forward_t91*tangent_l_f_3_3 + l_f_3_3*tangent_forward_t91;
        const lane tangent_forward_t93 = forward_t91*tangent_l_f_3_2 + l_f_3_2*tangent_forward_t91;
        const lane tangent_forward_t94 = 2.0*R_p_1*along_50;
        const lane tangent_forward_t95 = forward_t94*tangent_l_f_1_1 + l_f_1_1*tangent_forward_t94;
        const lane tangent_forward_t96 = forward_t53*tangent_forward_t95 + forward_t95*tangent_forward_t53;
        const lane tangent_forward_t97 = d_1_1*tangent_forward_t11;
        const lane tangent_forward_t98 = 2.0*R_p_2*along_51;
        const lane tangent_forward_t99 = forward_t98*tangent_l_f_2_1 + l_f_2_1*tangent_forward_t98;
        const lane tangent_forward_t100 = forward_t53*tangent_forward_t99 + forward_t99*tangent_forward_t53;
        const lane tangent_forward_t101 = d_2_1*tangent_forward_t13;
        const lane tangent_forward_t102 = 2.0*R_p_3*along_52;
        const lane tangent_forward_t103 = forward_t102*tangent_l_f_3_1 + l_f_3_1*tangent_forward_t102;
        const lane tangent_forward_t104 = forward_t103*tangent_forward_t53 + forward_t53*tangent_forward_t103;
        const lane tangent_forward_t105 = d_3_1*tangent_forward_t15;
        const lane tangent_forward_t106 = d_1_2*tangent_forward_t11;
        const lane tangent_forward_t107 = d_2_2*tangent_forward_t13;
        const lane tangent_forward_t108 = d_3_2*tangent_forward_t15;
        const lane tangent_forward_t109 = 2.0*D_delta_x_1*tangent_D_delta_x_1;
        const lane tangent_forward_t110 = 2.0*D_delta_y_1*tangent_D_delta_y_1;
        const lane tangent_forward_t111 = 2.0*D_delta_z_1*tangent_D_delta_z_1;
        const lane tangent_forward_t112 = D_delta_x_1*tangent_forward_t44 + forward_t44*tangent_D_delta_x_1;
        const lane tangent_forward_t113 = D_delta_y_1*tangent_forward_t44 + forward_t44*tangent_D_delta_y_1;
        const lane tangent_forward_t114 = D_delta_z_1*tangent_forward_t44 + forward_t44*tangent_D_delta_z_1;
        const lane tangent_forward_t115 = 2.0*D_delta_x_2*tangent_D_delta_x_2;
        const lane tangent_forward_t116 = 2.0*D_delta_y_2*tangent_D_delta_y_2;
        const lane tangent_forward_t117 = 2.0*D_delta_z_2*tangent_D_delta_z_2;
        const lane tangent_forward_t118 = D_delta_x_2*tangent_forward_t44 + forward_t44*tangent_D_delta_x_2;
        const lane tangent_forward_t119 = D_delta_y_2*tangent_forward_t44 + forward_t44*tangent_D_delta_y_2;
        const lane tangent_forward_t120 = D_delta_z_2*tangent_forward_t44 + forward_t44*tangent_D_delta_z_2;
        const lane tangent_forward_t121 = 2.0*D_delta_x_3*tangent_D_delta_x_3;
        const lane tangent_forward_t122 = 2.0*D_delta_y_3*tangent_D_delta_y_3;
        const lane tangent_forward_t123 = 2.0*D_delta_z_3*tangent_D_delta_z_3;
        const lane tangent_forward_t124 =
            along_35 + along_36 + along_37 + along_38 + along_39 + along_40 + along_96 + tangent_forward_t34;
        const lane t40 = 2.0*tangent_D_p_x_1;
        const lane tangent_forward_t125 = D_p_x_1*t40;
        const lane t41 = 2.0*tangent_D_p_y_1;
        const lane tangent_forward_t126 = D_p_y_1*t41;
        const lane t42 = 2.0*tangent_D_p_z_1;
        const lane tangent_forward_t127 = D_p_z_1*t42;
        const lane tangent_forward_t128 = D_p_x_1*tangent_mu_3 + mu_3*tangent_D_p_x_1;
        const lane tangent_forward_t129 = D_p_x_1*tangent_mu_2 + mu_2*tangent_D_p_x_1;
        const lane tangent_forward_t130 = U_1_x_1*tangent_mu_1 + mu_1*tangent_D_p_x_1;
        const lane tangent_forward_t131 = D_p_y_1*tangent_mu_3 + mu_3*tangent_D_p_y_1;
        const lane tangent_forward_t132 = D_p_y_1*tangent_mu_2 + mu_2*tangent_D_p_y_1;
        const lane tangent_forward_t133 = U_1_y_1*tangent_mu_1 + mu_1*tangent_D_p_y_1;
        const lane tangent_forward_t134 = D_p_z_1*tangent_mu_3 + mu_3*tangent_D_p_z_1;
        const lane tangent_forward_t135 = D_p_z_1*tangent_mu_2 + mu_2*tangent_D_p_z_1;
        const lane tangent_forward_t136 = U_1_z_1*tangent_mu_1 + mu_1*tangent_D_p_z_1;
        const lane tangent_forward_t137 = -R_p_1*tangent_k_1_3 - along_50*k_1_3;
        const lane tangent_forward_t138 = -R_p_1*tangent_k_1_2 - along_50*k_1_2;
        const lane tangent_forward_t139 = tangent_k_1_2 + tangent_k_1_3;
        const lane t43 = 2.0*tangent_D_p_x_2;
        const lane tangent_forward_t140 = D_p_x_2*t43;
        const lane t44 = 2.0*tangent_D_p_y_2;
        const lane tangent_forward_t141 = D_p_y_2*t44;
        const lane t45 = 2.0*tangent_D_p_z_2;
        const lane tangent_forward_t142 = D_p_z_2*t45;
        const lane tangent_forward_t143 = D_p_x_2*tangent_mu_1 + mu_1*tangent_D_p_x_2;
        const lane tangent_forward_t144 = D_p_x_2*tangent_mu_3 + mu_3*tangent_D_p_x_2;
        const lane tangent_forward_t145 = U_2_x_2*tangent_mu_2 + mu_2*tangent_D_p_x_2;
        const lane tangent_forward_t146 = D_p_y_2*tangent_mu_1 + mu_1*tangent_D_p_y_2;
        const lane tangent_forward_t147 = D_p_y_2*tangent_mu_3 + mu_3*tangent_D_p_y_2;
        const lane tangent_forward_t148 = U_2_y_2*tangent_mu_2 + mu_2*tangent_D_p_y_2;
        const lane tangent_forward_t149 = D_p_z_2*tangent_mu_1 + mu_1*tangent_D_p_z_2;
        const lane tangent_forward_t150 = D_p_z_2*tangent_mu_3 + mu_3*tangent_D_p_z_2;
        const lane tangent_forward_t151 = U_2_z_2*tangent_mu_2 + mu_2*tangent_D_p_z_2;
        const lane tangent_forward_t152 = -R_p_2*tangent_k_2_3 - along_51*k_2_3;
        const lane tangent_forward_t153 = -R_p_2*tangent_k_2_2 - along_51*k_2_2;
        const lane tangent_forward_t154 = tangent_k_2_2 + tangent_k_2_3;
        const lane t46 = 2.0*tangent_D_p_x_3;
        const lane tangent_forward_t155 = D_p_x_3*t46;
        const lane t47 = 2.0*tangent_D_p_y_3;
        const lane tangent_forward_t156 = D_p_y_3*t47;
        const lane t48 = 2.0*tangent_D_p_z_3;
        const lane tangent_forward_t157 = D_p_z_3*t48;
        const lane tangent_forward_t158 = -R_p_3*tangent_k_3_3 - along_52*k_3_3;
        const lane tangent_forward_t159 = -R_p_3*tangent_k_3_2 - along_52*k_3_2;
        const lane t49 = D_delta_x_1*tangent_D_p_x_3;
        const lane tangent_forward_t160 = D_p_x_3*tangent_D_delta_x_1 + t49;
        const lane tangent_forward_t161 = U_3_x_3*tangent_mu_3 + mu_3*tangent_D_p_x_3;
        const lane t50 = D_delta_y_1*tangent_D_p_y_3;
        const lane tangent_forward_t162 = D_p_y_3*tangent_D_delta_y_1 + t50;
        const lane tangent_forward_t163 = U_3_y_3*tangent_mu_3 + mu_3*tangent_D_p_y_3;
        const lane t51 = D_delta_z_1*tangent_D_p_z_3;
        const lane tangent_forward_t164 = D_p_z_3*tangent_D_delta_z_1 + t51;
        const lane tangent_forward_t165 = U_3_z_3*tangent_mu_3 + mu_3*tangent_D_p_z_3;
        const lane t52 = D_delta_x_2*tangent_D_p_x_3;
        const lane tangent_forward_t166 = D_p_x_3*tangent_D_delta_x_2 + t52;
        const lane t53 = D_delta_y_2*tangent_D_p_y_3;
        const lane tangent_forward_t167 = D_p_y_3*tangent_D_delta_y_2 + t53;
        const lane t54 = D_delta_z_2*tangent_D_p_z_3;
        const lane tangent_forward_t168 = D_p_z_3*tangent_D_delta_z_2 + t54;
        const lane t55 = D_delta_x_3*tangent_D_p_x_3;
        const lane tangent_forward_t169 = D_p_x_3*tangent_D_delta_x_3 + t55;
        const lane t56 = D_delta_y_3*tangent_D_p_y_3;
        const lane tangent_forward_t170 = D_p_y_3*tangent_D_delta_y_3 + t56;
        const lane t57 = D_delta_z_3*tangent_D_p_z_3;
        const lane tangent_forward_t171 = D_p_z_3*tangent_D_delta_z_3 + t57;
        const lane tangent_forward_t172 = tangent_k_3_2 + tangent_k_3_3;
        const lane tangent_forward_t173 = along_91*d_1_1;
        const lane tangent_forward_t174 = forward_t94*tangent_k_1_1 + k_1_1*tangent_forward_t94;
        const lane tangent_forward_t175 = along_91*d_2_1;
        const lane tangent_forward_t176 = forward_t98*tangent_k_2_1 + k_2_1*tangent_forward_t98;
        const lane tangent_forward_t177 = along_91*d_3_1;
        const lane tangent_forward_t178 = forward_t102*tangent_k_3_1 + k_3_1*tangent_forward_t102;
        const lane tangent_forward_t179 = along_91*d_1_2;
        const lane tangent_forward_t180 = along_91*d_2_2;
        const lane tangent_forward_t181 = along_91*d_3_2;
        const lane t58 = D_delta_x_1*tangent_D_delta_x_2;
        const lane t59 = D_delta_x_2*tangent_D_delta_x_1;
        const lane tangent_forward_t182 = t58 + t59;
        const lane t60 = D_delta_y_1*tangent_D_delta_y_2;
        const lane t61 = D_delta_y_2*tangent_D_delta_y_1;
        const lane tangent_forward_t183 = t60 + t61;
        const lane t62 = D_delta_z_1*tangent_D_delta_z_2;
        const lane t63 = D_delta_z_2*tangent_D_delta_z_1;
        const lane tangent_forward_t184 = t62 + t63;
        const lane t64 = D_delta_x_1*tangent_D_delta_x_3;
        const lane t65 = D_delta_x_3*tangent_D_delta_x_1;
        const lane tangent_forward_t185 = t64 + t65;
        const lane t66 = D_delta_y_1*tangent_D_delta_y_3;
        const lane t67 = D_delta_y_3*tangent_D_delta_y_1;
        const lane tangent_forward_t186 = t66 + t67;
        const lane t68 = D_delta_z_1*tangent_D_delta_z_3;
        const lane t69 = D_delta_z_3*tangent_D_delta_z_1;
        const lane tangent_forward_t187 = t68 + t69;
        const lane t70 = D_delta_x_2*tangent_D_delta_x_3;
        const lane t71 = D_delta_x_3*tangent_D_delta_x_2;
        const lane tangent_forward_t188 = t70 + t71;
        const lane t72 = D_delta_y_2*tangent_D_delta_y_3;
        const lane t73 = D_delta_y_3*tangent_D_delta_y_2;
        const lane tangent_forward_t189 = t72 + t73;
        const lane t74 = D_delta_z_2*tangent_D_delta_z_3;
        const lane t75 = D_delta_z_3*tangent_D_delta_z_2;
        const lane tangent_forward_t190 = t74 + t75;
        lanes_clear(mass_rate, 441);
        mass_rate[0] =
            LANES(D_p_x_1*tangent_forward_t41 + D_p_x_1*tangent_forward_t46 + D_p_y_1*tangent_forward_t47
            + D_p_y_1*tangent_forward_t49 + D_p_z_1*tangent_forward_t50 + D_p_z_1*tangent_forward_t52
            + along_38 + tangent_D_p_x_1*(forward_t41 + forward_t46) + tangent_D_p_y_1*(forward_t47
            + forward_t49) + tangent_D_p_z_1*(forward_t50 + forward_t52) + tangent_forward_t39
            + tangent_forward_t56);
        mass_rate[1] = mass_rate[21] =
            LANES(D_p_x_1*tangent_forward_t58 + D_p_x_2*tangent_forward_t46 + D_p_y_1*tangent_forward_t59
            + D_p_y_2*tangent_forward_t49 + D_p_z_1*tangent_forward_t60 + D_p_z_2*tangent_forward_t52
            + forward_t46*tangent_D_p_x_2 + forward_t49*tangent_D_p_y_2 + forward_t52*tangent_D_p_z_2
            + forward_t58*tangent_D_p_x_1 + forward_t59*tangent_D_p_y_1 + forward_t60*tangent_D_p_z_1);
        mass_rate[2] = mass_rate[42] =
            LANES(D_p_x_1*tangent_forward_t62 + D_p_x_3*tangent_forward_t46 + D_p_y_1*tangent_forward_t63
            + D_p_y_3*tangent_forward_t49 + D_p_z_1*tangent_forward_t64 + D_p_z_3*tangent_forward_t52
            + forward_t46*tangent_D_p_x_3 + forward_t49*tangent_D_p_y_3 + forward_t52*tangent_D_p_z_3
            + forward_t62*tangent_D_p_x_1 + forward_t63*tangent_D_p_y_1 + forward_t64*tangent_D_p_z_1);
        mass_rate[3] = mass_rate[63] = LANES(tangent_forward_t67);
        mass_rate[6] = mass_rate[126] = LANES(tangent_forward_t68);
        mass_rate[12] = mass_rate[252] =
            LANES(D_delta_x_1*tangent_forward_t46 + D_delta_y_1*tangent_forward_t49
            + D_delta_z_1*tangent_forward_t52 + forward_t46*tangent_D_delta_x_1
            + forward_t49*tangent_D_delta_y_1 + forward_t52*tangent_D_delta_z_1);
        mass_rate[13] = mass_rate[273] =
            LANES(D_delta_x_2*tangent_forward_t46 + D_delta_y_2*tangent_forward_t49
            + D_delta_z_2*tangent_forward_t52 + forward_t46*tangent_D_delta_x_2
            + forward_t49*tangent_D_delta_y_2 + forward_t52*tangent_D_delta_z_2);
        mass_rate[14] = mass_rate[294] =
            LANES(D_delta_x_3*tangent_forward_t46 + D_delta_y_3*tangent_forward_t49
            + D_delta_z_3*tangent_forward_t52 + forward_t46*tangent_D_delta_x_3
            + forward_t49*tangent_D_delta_y_3 + forward_t52*tangent_D_delta_z_3);
        mass_rate[15] = mass_rate[315] = LANES(tangent_forward_t56);
        mass_rate[18] = mass_rate[378] =
            LANES(D_p_x_1*tangent_forward_t69 + along_38*n_1_x + forward_t69*tangent_D_p_x_1
            + n_1_x*tangent_forward_t31 + tangent_forward_t45);
        mass_rate[19] = mass_rate[399] =
            LANES(D_p_y_1*tangent_forward_t69 + along_38*n_1_y + forward_t69*tangent_D_p_y_1
            + n_1_y*tangent_forward_t31 + tangent_forward_t48);
        mass_rate[20] = mass_rate[420] =
            LANES(D_p_z_1*tangent_forward_t69 + along_38*n_1_z + forward_t69*tangent_D_p_z_1
            + n_1_z*tangent_forward_t31 + tangent_forward_t51);
        mass_rate[22] =
            LANES(D_p_x_2*tangent_forward_t58 + D_p_x_2*tangent_forward_t71 + D_p_y_2*tangent_forward_t59
            + D_p_y_2*tangent_forward_t73 + D_p_z_2*tangent_forward_t60 + D_p_z_2*tangent_forward_t75
            + along_39 + tangent_D_p_x_2*(forward_t58 + forward_t71) + tangent_D_p_y_2*(forward_t59
            + forward_t73) + tangent_D_p_z_2*(forward_t60 + forward_t75) + tangent_forward_t42
            + tangent_forward_t78);
        mass_rate[23] = mass_rate[43] =
            LANES(D_p_x_2*tangent_forward_t62 + D_p_x_3*tangent_forward_t71 + D_p_y_2*tangent_forward_t63
            + D_p_y_3*tangent_forward_t73 + D_p_z_2*tangent_forward_t64 + D_p_z_3*tangent_forward_t75
            + forward_t62*tangent_D_p_x_2 + forward_t63*tangent_D_p_y_2 + forward_t64*tangent_D_p_z_2
            + forward_t71*tangent_D_p_x_3 + forward_t73*tangent_D_p_y_3 + forward_t75*tangent_D_p_z_3);
        mass_rate[25] = mass_rate[85] = LANES(tangent_forward_t80);
        mass_rate[28] = mass_rate[148] = LANES(tangent_forward_t81);
        mass_rate[33] = mass_rate[253] =
            LANES(D_delta_x_1*tangent_forward_t71 + D_delta_y_1*tangent_forward_t73
            + D_delta_z_1*tangent_forward_t75 + forward_t71*tangent_D_delta_x_1
            + forward_t73*tangent_D_delta_y_1 + forward_t75*tangent_D_delta_z_1);
        mass_rate[34] = mass_rate[274] =
            LANES(D_delta_x_2*tangent_forward_t71 + D_delta_y_2*tangent_forward_t73
            + D_delta_z_2*tangent_forward_t75 + forward_t71*tangent_D_delta_x_2
            + forward_t73*tangent_D_delta_y_2 + forward_t75*tangent_D_delta_z_2);
        mass_rate[35] = mass_rate[295] =
            LANES(D_delta_x_3*tangent_forward_t71 + D_delta_y_3*tangent_forward_t73
            + D_delta_z_3*tangent_forward_t75 + forward_t71*tangent_D_delta_x_3
            + forward_t73*tangent_D_delta_y_3 + forward_t75*tangent_D_delta_z_3);
        mass_rate[37] = mass_rate[337] = LANES(tangent_forward_t78);
        mass_rate[39] = mass_rate[379] =
            LANES(D_p_x_2*tangent_forward_t69 + along_39*n_2_x + forward_t69*tangent_D_p_x_2
            + n_2_x*tangent_forward_t32 + tangent_forward_t70);
        mass_rate[40] = mass_rate[400] =
            LANES(D_p_y_2*tangent_forward_t69 + along_39*n_2_y + forward_t69*tangent_D_p_y_2
            + n_2_y*tangent_forward_t32 + tangent_forward_t72);
        mass_rate[41] = mass_rate[421] =
            LANES(D_p_z_2*tangent_forward_t69 + along_39*n_2_z + forward_t69*tangent_D_p_z_2
            + n_2_z*tangent_forward_t32 + tangent_forward_t74);
        mass_rate[44] =
            LANES(D_p_x_3*tangent_forward_t62 + D_p_x_3*tangent_forward_t83 + D_p_y_3*tangent_forward_t63
            + D_p_y_3*tangent_forward_t85 + D_p_z_3*tangent_forward_t64 + D_p_z_3*tangent_forward_t87
            + along_40 + tangent_D_p_x_3*(forward_t62 + forward_t83) + tangent_D_p_y_3*(forward_t63
            + forward_t85) + tangent_D_p_z_3*(forward_t64 + forward_t87) + tangent_forward_t43
            + tangent_forward_t90);
        mass_rate[47] = mass_rate[107] = LANES(tangent_forward_t92);
        mass_rate[50] = mass_rate[170] = LANES(tangent_forward_t93);
        mass_rate[54] = mass_rate[254] =
            LANES(D_delta_x_1*tangent_forward_t83 + D_delta_y_1*tangent_forward_t85
            + D_delta_z_1*tangent_forward_t87 + forward_t83*tangent_D_delta_x_1
            + forward_t85*tangent_D_delta_y_1 + forward_t87*tangent_D_delta_z_1);
        mass_rate[55] = mass_rate[275] =
            LANES(D_delta_x_2*tangent_forward_t83 + D_delta_y_2*tangent_forward_t85
            + D_delta_z_2*tangent_forward_t87 + forward_t83*tangent_D_delta_x_2
            + forward_t85*tangent_D_delta_y_2 + forward_t87*tangent_D_delta_z_2);
        mass_rate[56] = mass_rate[296] =
            LANES(D_delta_x_3*tangent_forward_t83 + D_delta_y_3*tangent_forward_t85
            + D_delta_z_3*tangent_forward_t87 + forward_t83*tangent_D_delta_x_3
            + forward_t85*tangent_D_delta_y_3 + forward_t87*tangent_D_delta_z_3);
        mass_rate[59] = mass_rate[359] = LANES(tangent_forward_t90);
        mass_rate[60] = mass_rate[380] =
            LANES(D_p_x_3*tangent_forward_t69 + along_40*n_3_x + forward_t69*tangent_D_p_x_3
            + n_3_x*tangent_forward_t33 + tangent_forward_t82);
        mass_rate[61] = mass_rate[401] =
            LANES(D_p_y_3*tangent_forward_t69 + along_40*n_3_y + forward_t69*tangent_D_p_y_3
            + n_3_y*tangent_forward_t33 + tangent_forward_t84);
        mass_rate[62] = mass_rate[422] =
            LANES(D_p_z_3*tangent_forward_t69 + along_40*n_3_z + forward_t69*tangent_D_p_z_3
            + n_3_z*tangent_forward_t33 + tangent_forward_t86);
        mass_rate[66] =
            LANES(forward_t55*tangent_forward_t94 + forward_t94*tangent_forward_t55 + tangent_I_1_1
            + tangent_forward_t96);
        mass_rate[69] = mass_rate[129] =
            LANES(forward_t65*tangent_forward_t95 + forward_t95*tangent_forward_t65);
        mass_rate[72] = mass_rate[192] = LANES(tangent_forward_t97);
        mass_rate[78] = mass_rate[318] = LANES(tangent_forward_t67);
        mass_rate[88] =
            LANES(forward_t77*tangent_forward_t98 + forward_t98*tangent_forward_t77 + tangent_I_2_1
            + tangent_forward_t100);
        mass_rate[91] = mass_rate[151] =
            LANES(forward_t65*tangent_forward_t99 + forward_t99*tangent_forward_t65);
        mass_rate[94] = mass_rate[214] = LANES(tangent_forward_t101);
        mass_rate[100] = mass_rate[340] = LANES(tangent_forward_t80);
        mass_rate[110] =
            LANES(forward_t102*tangent_forward_t89 + forward_t89*tangent_forward_t102 + tangent_I_3_1
            + tangent_forward_t104);
        mass_rate[113] = mass_rate[173] =
            LANES(forward_t103*tangent_forward_t65 + forward_t65*tangent_forward_t103);
        mass_rate[116] = mass_rate[236] = LANES(tangent_forward_t105);
        mass_rate[122] = mass_rate[362] = LANES(tangent_forward_t92);
        mass_rate[132] =
            LANES(forward_t54*tangent_forward_t94 + forward_t94*tangent_forward_t54 + tangent_I_1_2
            + tangent_forward_t96);
        mass_rate[135] = mass_rate[195] = LANES(tangent_forward_t106);
        mass_rate[141] = mass_rate[321] = LANES(tangent_forward_t68);
        mass_rate[154] =
            LANES(forward_t76*tangent_forward_t98 + forward_t98*tangent_forward_t76 + tangent_I_2_2
            + tangent_forward_t100);
        mass_rate[157] = mass_rate[217] = LANES(tangent_forward_t107);
        mass_rate[163] = mass_rate[343] = LANES(tangent_forward_t81);
        mass_rate[176] =
            LANES(forward_t102*tangent_forward_t88 + forward_t88*tangent_forward_t102 + tangent_I_3_2
            + tangent_forward_t104);
        mass_rate[179] = mass_rate[239] = LANES(tangent_forward_t108);
        mass_rate[185] = mass_rate[365] = LANES(tangent_forward_t93);
        mass_rate[198] = LANES(tangent_forward_t106 + tangent_forward_t97);
        mass_rate[220] = LANES(tangent_forward_t101 + tangent_forward_t107);
        mass_rate[242] = LANES(tangent_forward_t105 + tangent_forward_t108);
        mass_rate[264] =
            LANES(forward_t44*tangent_forward_t109 + forward_t44*tangent_forward_t110
            + forward_t44*tangent_forward_t111 + t76*tangent_forward_t44);
        mass_rate[265] = mass_rate[285] =
            LANES(D_delta_x_2*tangent_forward_t112 + D_delta_y_2*tangent_forward_t113
            + D_delta_z_2*tangent_forward_t114 + forward_t112*tangent_D_delta_x_2
            + forward_t113*tangent_D_delta_y_2 + forward_t114*tangent_D_delta_z_2);
        mass_rate[266] = mass_rate[306] =
            LANES(D_delta_x_3*tangent_forward_t112 + D_delta_y_3*tangent_forward_t113
            + D_delta_z_3*tangent_forward_t114 + forward_t112*tangent_D_delta_x_3
            + forward_t113*tangent_D_delta_y_3 + forward_t114*tangent_D_delta_z_3);
        mass_rate[270] = mass_rate[390] =
            LANES(D_delta_x_1*tangent_forward_t69 + forward_t69*tangent_D_delta_x_1 + tangent_forward_t112);
        mass_rate[271] = mass_rate[411] =
            LANES(D_delta_y_1*tangent_forward_t69 + forward_t69*tangent_D_delta_y_1 + tangent_forward_t113);
        mass_rate[272] = mass_rate[432] =
            LANES(D_delta_z_1*tangent_forward_t69 + forward_t69*tangent_D_delta_z_1 + tangent_forward_t114);
        mass_rate[286] =
            LANES(forward_t44*tangent_forward_t115 + forward_t44*tangent_forward_t116
            + forward_t44*tangent_forward_t117 + t77*tangent_forward_t44);
        mass_rate[287] = mass_rate[307] =
            LANES(D_delta_x_3*tangent_forward_t118 + D_delta_y_3*tangent_forward_t119
            + D_delta_z_3*tangent_forward_t120 + forward_t118*tangent_D_delta_x_3
            + forward_t119*tangent_D_delta_y_3 + forward_t120*tangent_D_delta_z_3);
        mass_rate[291] = mass_rate[391] =
            LANES(D_delta_x_2*tangent_forward_t69 + forward_t69*tangent_D_delta_x_2 + tangent_forward_t118);
        mass_rate[292] = mass_rate[412] =
            LANES(D_delta_y_2*tangent_forward_t69 + forward_t69*tangent_D_delta_y_2 + tangent_forward_t119);
        mass_rate[293] = mass_rate[433] =
            LANES(D_delta_z_2*tangent_forward_t69 + forward_t69*tangent_D_delta_z_2 + tangent_forward_t120);
        mass_rate[308] =
            LANES(forward_t44*tangent_forward_t121 + forward_t44*tangent_forward_t122
            + forward_t44*tangent_forward_t123 + t78*tangent_forward_t44);
        mass_rate[312] = mass_rate[392] =
            LANES(D_delta_x_3*tangent_forward_t44 + D_delta_x_3*tangent_forward_t69
            + t79*tangent_D_delta_x_3);
        mass_rate[313] = mass_rate[413] =
            LANES(D_delta_y_3*tangent_forward_t44 + D_delta_y_3*tangent_forward_t69
            + t79*tangent_D_delta_y_3);
        mass_rate[314] = mass_rate[434] =
            LANES(D_delta_z_3*tangent_forward_t44 + D_delta_z_3*tangent_forward_t69
            + t79*tangent_D_delta_z_3);
        mass_rate[330] = LANES(tangent_forward_t56);
        mass_rate[352] = LANES(tangent_forward_t78);
        mass_rate[374] = LANES(tangent_forward_t90);
        mass_rate[396] = LANES(tangent_forward_t124);
        mass_rate[418] = LANES(tangent_forward_t124);
        mass_rate[440] = LANES(tangent_forward_t124);
        lanes_clear(stiffness_rate, 441);
        stiffness_rate[0] =
            LANES(along_85*t80 - forward_t130*t40 - forward_t133*t41 - forward_t136*t42 - t80*tangent_mu_2
            - t80*tangent_mu_3 + t82*tangent_forward_t125 + t82*tangent_forward_t126
            + t82*tangent_forward_t127 + tangent_forward_t139 + tangent_mu_1*(-(U_1_x_1*U_1_x_1)
            - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1)));
        stiffness_rate[1] = stiffness_rate[21] =
            LANES(D_p_x_2*k_C*tangent_D_p_x_1 - D_p_x_2*tangent_forward_t128 - D_p_x_2*tangent_forward_t130
            + D_p_y_2*k_C*tangent_D_p_y_1 - D_p_y_2*tangent_forward_t131 - D_p_y_2*tangent_forward_t133
            + D_p_z_2*k_C*tangent_D_p_z_1 - D_p_z_2*tangent_forward_t134 - D_p_z_2*tangent_forward_t136
            - U_2_x_2*tangent_forward_t129 - U_2_y_2*tangent_forward_t132 - U_2_z_2*tangent_forward_t135
            + along_85*(D_p_x_1*D_p_x_2 + D_p_y_1*D_p_y_2 + D_p_z_1*D_p_z_2) - forward_t129*tangent_D_p_x_2
            - forward_t132*tangent_D_p_y_2 - forward_t135*tangent_D_p_z_2 - t84*tangent_D_p_x_2
            - t86*tangent_D_p_y_2 - t88*tangent_D_p_z_2);
        stiffness_rate[2] = stiffness_rate[42] =
            LANES(D_p_x_3*k_C*tangent_D_p_x_1 - D_p_x_3*tangent_forward_t129 - D_p_x_3*tangent_forward_t130
            + D_p_y_3*k_C*tangent_D_p_y_1 - D_p_y_3*tangent_forward_t132 - D_p_y_3*tangent_forward_t133
            + D_p_z_3*k_C*tangent_D_p_z_1 - D_p_z_3*tangent_forward_t135 - D_p_z_3*tangent_forward_t136
            - U_3_x_3*tangent_forward_t128 - U_3_y_3*tangent_forward_t131 - U_3_z_3*tangent_forward_t134
            + along_85*(D_p_x_1*D_p_x_3 + D_p_y_1*D_p_y_3 + D_p_z_1*D_p_z_3) - forward_t128*tangent_D_p_x_3
            - forward_t131*tangent_D_p_y_3 - forward_t134*tangent_D_p_z_3 + tangent_D_p_x_3*(-forward_t129
            - t83) + tangent_D_p_y_3*(-forward_t132 - t85) + tangent_D_p_z_3*(-forward_t135 - t87));
        stiffness_rate[3] = stiffness_rate[63] = LANES(tangent_forward_t137);
        stiffness_rate[6] = stiffness_rate[126] = LANES(tangent_forward_t138);
        stiffness_rate[12] = stiffness_rate[252] =
            LANES(D_delta_x_1*k_C*tangent_D_p_x_1 - D_delta_x_1*tangent_forward_t128
            - D_delta_x_1*tangent_forward_t129 - D_delta_x_1*tangent_forward_t130
            + D_delta_y_1*k_C*tangent_D_p_y_1 - D_delta_y_1*tangent_forward_t131
            - D_delta_y_1*tangent_forward_t132 - D_delta_y_1*tangent_forward_t133
            + D_delta_z_1*k_C*tangent_D_p_z_1 - D_delta_z_1*tangent_forward_t134
            - D_delta_z_1*tangent_forward_t135 - D_delta_z_1*tangent_forward_t136
            + along_85*(D_delta_x_1*D_p_x_1 + D_delta_y_1*D_p_y_1 + D_delta_z_1*D_p_z_1)
            + t89*tangent_D_delta_x_1 + t90*tangent_D_delta_y_1 + t91*tangent_D_delta_z_1);
        stiffness_rate[13] = stiffness_rate[273] =
            LANES(D_delta_x_2*k_C*tangent_D_p_x_1 - D_delta_x_2*tangent_forward_t128
            - D_delta_x_2*tangent_forward_t129 - D_delta_x_2*tangent_forward_t130
            + D_delta_y_2*k_C*tangent_D_p_y_1 - D_delta_y_2*tangent_forward_t131
            - D_delta_y_2*tangent_forward_t132 - D_delta_y_2*tangent_forward_t133
            + D_delta_z_2*k_C*tangent_D_p_z_1 - D_delta_z_2*tangent_forward_t134
            - D_delta_z_2*tangent_forward_t135 - D_delta_z_2*tangent_forward_t136
            + along_85*(D_delta_x_2*D_p_x_1 + D_delta_y_2*D_p_y_1 + D_delta_z_2*D_p_z_1)
            + t89*tangent_D_delta_x_2 + t90*tangent_D_delta_y_2 + t91*tangent_D_delta_z_2);
        stiffness_rate[14] = stiffness_rate[294] =
            LANES(D_delta_x_3*k_C*tangent_D_p_x_1 - D_delta_x_3*tangent_forward_t128
            - D_delta_x_3*tangent_forward_t129 - D_delta_x_3*tangent_forward_t130
            + D_delta_y_3*k_C*tangent_D_p_y_1 - D_delta_y_3*tangent_forward_t131
            - D_delta_y_3*tangent_forward_t132 - D_delta_y_3*tangent_forward_t133
            + D_delta_z_3*k_C*tangent_D_p_z_1 - D_delta_z_3*tangent_forward_t134
            - D_delta_z_3*tangent_forward_t135 - D_delta_z_3*tangent_forward_t136
            + along_85*(D_delta_x_3*D_p_x_1 + D_delta_y_3*D_p_y_1 + D_delta_z_3*D_p_z_1)
            + t89*tangent_D_delta_x_3 + t90*tangent_D_delta_y_3 + t91*tangent_D_delta_z_3);
        stiffness_rate[15] = stiffness_rate[315] = LANES(tangent_forward_t139);
        stiffness_rate[18] = stiffness_rate[378] = LANES(D_p_x_1*along_85 + k_C*tangent_D_p_x_1);
        stiffness_rate[19] = stiffness_rate[399] = LANES(D_p_y_1*along_85 + k_C*tangent_D_p_y_1);
        stiffness_rate[20] = stiffness_rate[420] = LANES(D_p_z_1*along_85 + k_C*tangent_D_p_z_1);
        stiffness_rate[22] =
            LANES(along_85*t92 - forward_t145*t43 - forward_t148*t44 - forward_t151*t45 - t92*tangent_mu_1
            - t92*tangent_mu_3 + t93*tangent_forward_t140 + t93*tangent_forward_t141
            + t93*tangent_forward_t142 + tangent_forward_t154 + tangent_mu_2*(-(U_2_x_2*U_2_x_2)
            - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2)));
        stiffness_rate[23] = stiffness_rate[43] =
            LANES(D_p_x_3*k_C*tangent_D_p_x_2 - D_p_x_3*tangent_forward_t143 - D_p_x_3*tangent_forward_t145
            + D_p_y_3*k_C*tangent_D_p_y_2 - D_p_y_3*tangent_forward_t146 - D_p_y_3*tangent_forward_t148
            + D_p_z_3*k_C*tangent_D_p_z_2 - D_p_z_3*tangent_forward_t149 - D_p_z_3*tangent_forward_t151
            - U_3_x_3*tangent_forward_t144 - U_3_y_3*tangent_forward_t147 - U_3_z_3*tangent_forward_t150
            + along_85*(D_p_x_2*D_p_x_3 + D_p_y_2*D_p_y_3 + D_p_z_2*D_p_z_3) - forward_t144*tangent_D_p_x_3
            - forward_t147*tangent_D_p_y_3 - forward_t150*tangent_D_p_z_3 - t94*tangent_D_p_x_3
            - t95*tangent_D_p_y_3 - t96*tangent_D_p_z_3);
        stiffness_rate[25] = stiffness_rate[85] = LANES(tangent_forward_t152);
        stiffness_rate[28] = stiffness_rate[148] = LANES(tangent_forward_t153);
        stiffness_rate[33] = stiffness_rate[253] =
            LANES(D_delta_x_1*k_C*tangent_D_p_x_2 - D_delta_x_1*tangent_forward_t143
            - D_delta_x_1*tangent_forward_t144 - D_delta_x_1*tangent_forward_t145
            + D_delta_y_1*k_C*tangent_D_p_y_2 - D_delta_y_1*tangent_forward_t146
            - D_delta_y_1*tangent_forward_t147 - D_delta_y_1*tangent_forward_t148
            + D_delta_z_1*k_C*tangent_D_p_z_2 - D_delta_z_1*tangent_forward_t149
            - D_delta_z_1*tangent_forward_t150 - D_delta_z_1*tangent_forward_t151
            + along_85*(D_delta_x_1*D_p_x_2 + D_delta_y_1*D_p_y_2 + D_delta_z_1*D_p_z_2)
            + t97*tangent_D_delta_x_1 + t98*tangent_D_delta_y_1 + t99*tangent_D_delta_z_1);
        stiffness_rate[34] = stiffness_rate[274] =
            LANES(D_delta_x_2*k_C*tangent_D_p_x_2 - D_delta_x_2*tangent_forward_t143
            - D_delta_x_2*tangent_forward_t144 - D_delta_x_2*tangent_forward_t145
            + D_delta_y_2*k_C*tangent_D_p_y_2 - D_delta_y_2*tangent_forward_t146
            - D_delta_y_2*tangent_forward_t147 - D_delta_y_2*tangent_forward_t148
            + D_delta_z_2*k_C*tangent_D_p_z_2 - D_delta_z_2*tangent_forward_t149
            - D_delta_z_2*tangent_forward_t150 - D_delta_z_2*tangent_forward_t151
            + along_85*(D_delta_x_2*D_p_x_2 + D_delta_y_2*D_p_y_2 + D_delta_z_2*D_p_z_2)
            + t97*tangent_D_delta_x_2 + t98*tangent_D_delta_y_2 + t99*tangent_D_delta_z_2);
        stiffness_rate[35] = stiffness_rate[295] =
            LANES(D_delta_x_3*k_C*tangent_D_p_x_2 - D_delta_x_3*tangent_forward_t143
            - D_delta_x_3*tangent_forward_t144 - D_delta_x_3*tangent_forward_t145
            + D_delta_y_3*k_C*tangent_D_p_y_2 - D_delta_y_3*tangent_forward_t146
            - D_delta_y_3*tangent_forward_t147 - D_delta_y_3*tangent_forward_t148
            + D_delta_z_3*k_C*tangent_D_p_z_2 - D_delta_z_3*tangent_forward_t149
            - D_delta_z_3*tangent_forward_t150 - D_delta_z_3*tangent_forward_t151
            + along_85*(D_delta_x_3*D_p_x_2 + D_delta_y_3*D_p_y_2 + D_delta_z_3*D_p_z_2)
            + t97*tangent_D_delta_x_3 + t98*tangent_D_delta_y_3 + t99*tangent_D_delta_z_3);
        stiffness_rate[37] = stiffness_rate[337] = LANES(tangent_forward_t154);
        stiffness_rate[39] = stiffness_rate[379] = LANES(D_p_x_2*along_85 + k_C*tangent_D_p_x_2);
        stiffness_rate[40] = stiffness_rate[400] = LANES(D_p_y_2*along_85 + k_C*tangent_D_p_y_2);
        stiffness_rate[41] = stiffness_rate[421] = LANES(D_p_z_2*along_85 + k_C*tangent_D_p_z_2);
        stiffness_rate[44] =
            LANES(along_85*t100 - forward_t161*t46 - forward_t163*t47 - forward_t165*t48 - t100*tangent_mu_1
            - t100*tangent_mu_2 + t102*tangent_forward_t155 + t102*tangent_forward_t156
            + t102*tangent_forward_t157 + tangent_forward_t172 + tangent_mu_3*(-(U_3_x_3*U_3_x_3)
            - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3)));
        stiffness_rate[47] = stiffness_rate[107] = LANES(tangent_forward_t158);
        stiffness_rate[50] = stiffness_rate[170] = LANES(tangent_forward_t159);
        stiffness_rate[54] = stiffness_rate[254] =
            LANES(-D_delta_x_1*tangent_forward_t161 - D_delta_y_1*tangent_forward_t163
            - D_delta_z_1*tangent_forward_t165 + along_85*(forward_t160 + forward_t162 + forward_t164)
            + k_C*t49 + k_C*t50 + k_C*t51 - t101*tangent_forward_t160 - t101*tangent_forward_t162
            - t101*tangent_forward_t164 + t103*tangent_D_delta_x_1 + t104*tangent_D_delta_y_1
            + t105*tangent_D_delta_z_1 + t106*tangent_mu_1 + t106*tangent_mu_2);
        stiffness_rate[55] = stiffness_rate[275] =
            LANES(-D_delta_x_2*tangent_forward_t161 - D_delta_y_2*tangent_forward_t163
            - D_delta_z_2*tangent_forward_t165 + along_85*(forward_t166 + forward_t167 + forward_t168)
            + k_C*t52 + k_C*t53 + k_C*t54 - t101*tangent_forward_t166 - t101*tangent_forward_t167
            - t101*tangent_forward_t168 + t103*tangent_D_delta_x_2 + t104*tangent_D_delta_y_2
            + t105*tangent_D_delta_z_2 + t107*tangent_mu_1 + t107*tangent_mu_2);
        stiffness_rate[56] = stiffness_rate[296] =
            LANES(-D_delta_x_3*tangent_forward_t161 - D_delta_y_3*tangent_forward_t163
            - D_delta_z_3*tangent_forward_t165 + along_85*(forward_t169 + forward_t170 + forward_t171)
            + k_C*t55 + k_C*t56 + k_C*t57 - t101*tangent_forward_t169 - t101*tangent_forward_t170
            - t101*tangent_forward_t171 + t103*tangent_D_delta_x_3 + t104*tangent_D_delta_y_3
            + t105*tangent_D_delta_z_3 + t108*tangent_mu_1 + t108*tangent_mu_2);
        stiffness_rate[59] = stiffness_rate[359] = LANES(tangent_forward_t172);
        stiffness_rate[60] = stiffness_rate[380] = LANES(D_p_x_3*along_85 + k_C*tangent_D_p_x_3);
        stiffness_rate[61] = stiffness_rate[401] = LANES(D_p_y_3*along_85 + k_C*tangent_D_p_y_3);
        stiffness_rate[62] = stiffness_rate[422] = LANES(D_p_z_3*along_85 + k_C*tangent_D_p_z_3);
        stiffness_rate[66] =
            LANES(forward_t94*tangent_k_1_3 + k_1_3*tangent_forward_t94 + tangent_forward_t173
            + tangent_forward_t174);
        stiffness_rate[69] = stiffness_rate[129] = LANES(-tangent_forward_t174);
        stiffness_rate[72] = stiffness_rate[192] = LANES(tangent_forward_t173);
        stiffness_rate[78] = stiffness_rate[318] = LANES(tangent_forward_t137);
        stiffness_rate[88] =
            LANES(forward_t98*tangent_k_2_3 + k_2_3*tangent_forward_t98 + tangent_forward_t175
            + tangent_forward_t176);
        stiffness_rate[91] = stiffness_rate[151] = LANES(-tangent_forward_t176);
        stiffness_rate[94] = stiffness_rate[214] = LANES(tangent_forward_t175);
        stiffness_rate[100] = stiffness_rate[340] = LANES(tangent_forward_t152);
        stiffness_rate[110] =
            LANES(forward_t102*tangent_k_3_3 + k_3_3*tangent_forward_t102 + tangent_forward_t177
            + tangent_forward_t178);
        stiffness_rate[113] = stiffness_rate[173] = LANES(-tangent_forward_t178);
        stiffness_rate[116] = stiffness_rate[236] = LANES(tangent_forward_t177);
        stiffness_rate[122] = stiffness_rate[362] = LANES(tangent_forward_t158);
        stiffness_rate[132] =
            LANES(forward_t94*tangent_k_1_2 + k_1_2*tangent_forward_t94 + tangent_forward_t174
            + tangent_forward_t179);
        stiffness_rate[135] = stiffness_rate[195] = LANES(tangent_forward_t179);
        stiffness_rate[141] = stiffness_rate[321] = LANES(tangent_forward_t138);
        stiffness_rate[154] =
            LANES(forward_t98*tangent_k_2_2 + k_2_2*tangent_forward_t98 + tangent_forward_t176
            + tangent_forward_t180);
        stiffness_rate[157] = stiffness_rate[217] = LANES(tangent_forward_t180);
        stiffness_rate[163] = stiffness_rate[343] = LANES(tangent_forward_t153);
        stiffness_rate[176] =
            LANES(forward_t102*tangent_k_3_2 + k_3_2*tangent_forward_t102 + tangent_forward_t178
            + tangent_forward_t181);
        stiffness_rate[179] = stiffness_rate[239] = LANES(tangent_forward_t181);
        stiffness_rate[185] = stiffness_rate[365] = LANES(tangent_forward_t159);
        stiffness_rate[198] = LANES(tangent_forward_t173 + tangent_forward_t179);
        stiffness_rate[220] = LANES(tangent_forward_t175 + tangent_forward_t180);
        stiffness_rate[242] = LANES(tangent_forward_t177 + tangent_forward_t181);
        stiffness_rate[264] =
            LANES(along_85*t76 + t109*tangent_forward_t109 + t109*tangent_forward_t110
            + t109*tangent_forward_t111 - t76*tangent_mu_2 - t76*tangent_mu_3 + tangent_mu_1*(1.0 - t76));
        stiffness_rate[265] = stiffness_rate[285] =
            LANES(along_85*(forward_t182 + forward_t183 + forward_t184) + k_C*t58 + k_C*t59 + k_C*t60
            + k_C*t61 + k_C*t62 + k_C*t63 + t110*tangent_forward_t182 + t110*tangent_forward_t183
            + t110*tangent_forward_t184 + t111*tangent_mu_1 + t111*tangent_mu_2 + t111*tangent_mu_3);
        stiffness_rate[266] = stiffness_rate[306] =
            LANES(along_85*(forward_t185 + forward_t186 + forward_t187) + k_C*t64 + k_C*t65 + k_C*t66
            + k_C*t67 + k_C*t68 + k_C*t69 + t110*tangent_forward_t185 + t110*tangent_forward_t186
            + t110*tangent_forward_t187 + t112*tangent_mu_1 + t112*tangent_mu_2 + t112*tangent_mu_3);
        stiffness_rate[270] = stiffness_rate[390] = LANES(D_delta_x_1*along_85 + k_C*tangent_D_delta_x_1);
        stiffness_rate[271] = stiffness_rate[411] = LANES(D_delta_y_1*along_85 + k_C*tangent_D_delta_y_1);
        stiffness_rate[272] = stiffness_rate[432] = LANES(D_delta_z_1*along_85 + k_C*tangent_D_delta_z_1);
        stiffness_rate[286] =
            LANES(along_85*t77 + t109*tangent_forward_t115 + t109*tangent_forward_t116
            + t109*tangent_forward_t117 - t77*tangent_mu_1 - t77*tangent_mu_3 + tangent_mu_2*(1.0 - t77));
        stiffness_rate[287] = stiffness_rate[307] =
            LANES(along_85*(forward_t188 + forward_t189 + forward_t190) + k_C*t70 + k_C*t71 + k_C*t72
            + k_C*t73 + k_C*t74 + k_C*t75 + t110*tangent_forward_t188 + t110*tangent_forward_t189
            + t110*tangent_forward_t190 + t113*tangent_mu_1 + t113*tangent_mu_2 + t113*tangent_mu_3);
        stiffness_rate[291] = stiffness_rate[391] = LANES(D_delta_x_2*along_85 + k_C*tangent_D_delta_x_2);
        stiffness_rate[292] = stiffness_rate[412] = LANES(D_delta_y_2*along_85 + k_C*tangent_D_delta_y_2);
        stiffness_rate[293] = stiffness_rate[433] = LANES(D_delta_z_2*along_85 + k_C*tangent_D_delta_z_2);
        stiffness_rate[308] =
            LANES(along_85*t78 + t109*tangent_forward_t121 + t109*tangent_forward_t122
            + t109*tangent_forward_t123 - t78*tangent_mu_1 - t78*tangent_mu_2 + tangent_mu_3*(1.0 - t78));
        stiffness_rate[312] = stiffness_rate[392] = LANES(D_delta_x_3*along_85 + k_C*tangent_D_delta_x_3);
        stiffness_rate[313] = stiffness_rate[413] = LANES(D_delta_y_3*along_85 + k_C*tangent_D_delta_y_3);
        stiffness_rate[314] = stiffness_rate[434] = LANES(D_delta_z_3*along_85 + k_C*tangent_D_delta_z_3);
        stiffness_rate[330] = LANES(tangent_forward_t139);
        stiffness_rate[352] = LANES(tangent_forward_t154);
        stiffness_rate[374] = LANES(tangent_forward_t172);
        stiffness_rate[396] = LANES(along_85);
        stiffness_rate[418] = LANES(along_85);
        stiffness_rate[440] = LANES(along_85);
        lanes_clear(motion_rate, 63);
        motion_rate[0] = LANES(tangent_D_p_x_1);
        motion_rate[1] = LANES(tangent_D_p_x_2);
        motion_rate[2] = LANES(tangent_D_p_x_3);
        motion_rate[12] = LANES(tangent_D_delta_x_1);
        motion_rate[13] = LANES(tangent_D_delta_x_2);
        motion_rate[14] = LANES(tangent_D_delta_x_3);
        motion_rate[21] = LANES(tangent_D_p_y_1);
        motion_rate[22] = LANES(tangent_D_p_y_2);
        motion_rate[23] = LANES(tangent_D_p_y_3);
        motion_rate[33] = LANES(tangent_D_delta_y_1);
        motion_rate[34] = LANES(tangent_D_delta_y_2);
        motion_rate[35] = LANES(tangent_D_delta_y_3);
        motion_rate[42] = LANES(tangent_D_p_z_1);
        motion_rate[43] = LANES(tangent_D_p_z_2);
        motion_rate[44] = LANES(tangent_D_p_z_3);
        motion_rate[54] = LANES(tangent_D_delta_z_1);
        motion_rate[55] = LANES(tangent_D_delta_z_2);
        motion_rate[56] = LANES(tangent_D_delta_z_3);
        lanes_take(paths, path, mass_rate, stiffness_rate, motion_rate);
    }
}
