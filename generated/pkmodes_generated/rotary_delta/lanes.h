/* Generated from the derivation of rotary_delta.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * The mechanism rotary_delta for the compiled evaluator.
 *
 * A part of the compiled evaluator, which includes it once for each instruction set: `lane` is a vector of
 * doubles, one for each pose.  Matrices are row-major; everything is in SI units.
 *
 * Names in the code.  Indices: axis j; coordinate k of a derivative; component i = x, y, z.  t1, t2, ... are
 * subexpressions shared by several values.
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
 *   k_j [N m/rad]: stiffness of reducer j
 *   D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
 *   A_i_j [m^2]: adjugate of D_l, entry i, j
 *   det_D_l [m^3]: determinant of D_l
 *   D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
 *   D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
 *   U_j_i_k [m]: derivative of linkage vector j, component i, with respect to theta_k
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 *   G_j [N m]: gradient of the gravitational potential energy with respect to theta_j
 *   phi_j_st [rad]: static angle of motor j divided by the gear ratio, relative to the unstrained
 *     transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#define LANES_POSE 3
#define LANES_INDEPENDENT 3
#define LANES_DIRECTIONS 3
#define LANES_LINEAR 3
#define LANES_DRIVES 3
#define LANES_DEPENDENT 3
#define LANES_BASE 6
#define LANES_ALL 12
#define LANES_GRADIENT 94
#define LANES_MARGINS 13

/* How many numbers each margin of a pose has, and how they must compare. */
static const struct lanes_rule LANES_RULES[] = {
    {6, LANES_AT_LEAST_ZERO}, {1, LANES_AT_MOST_LIMIT}, {6, LANES_AT_LEAST_ZERO},
};

/* Which of the base coordinates the pose determines, and which depend on these. */
static const int LANES_INDEPENDENT_INDICES[] = {0, 1, 2};
static const int LANES_DEPENDENT_INDICES[] = {3, 4, 5};

/* Arm angles at a pose, and the margins of a pose.
 *
 * Source: inverse_kinematics and reach_margin, jacobian_condition, limit_margin.
 * 331 operations; 56031 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double theta_min_1 = parameters[67];
    const double theta_max_1 = parameters[68];
    const double theta_min_2 = parameters[69];
    const double theta_max_2 = parameters[70];
    const double theta_min_3 = parameters[71];
    const double theta_max_3 = parameters[72];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const lane t1 = (L_a_1*L_a_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z);
    const lane C_1 = (1.0/2.0)*(-(l_d_1*l_d_1) + t1)/L_a_1;
    const lane S_1 = sigma_1*lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane t2 = 1.0/rho2_1;
    const lane c_1 = t2*(A_1*C_1 - B_1*S_1);
    const lane sn_1 = t2*(A_1*S_1 + B_1*C_1);
    const lane theta_1 = lanes_atan2(sn_1, c_1);
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const lane t3 = (L_a_2*L_a_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z);
    const lane C_2 = (1.0/2.0)*(-(l_d_2*l_d_2) + t3)/L_a_2;
    const lane S_2 = sigma_2*lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane t4 = 1.0/rho2_2;
    const lane c_2 = t4*(A_2*C_2 - B_2*S_2);
    const lane sn_2 = t4*(A_2*S_2 + B_2*C_2);
    const lane theta_2 = lanes_atan2(sn_2, c_2);
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const lane t5 = (L_a_3*L_a_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z);
    const lane C_3 = (1.0/2.0)*(-(l_d_3*l_d_3) + t5)/L_a_3;
    const lane S_3 = sigma_3*lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane t6 = 1.0/rho2_3;
    const lane c_3 = t6*(A_3*C_3 - B_3*S_3);
    const lane sn_3 = t6*(A_3*S_3 + B_3*C_3);
    const lane theta_3 = lanes_atan2(sn_3, c_3);
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane s_1_x = -L_a_1*d_1_x + r_1_x;
    const lane s_1_y = -L_a_1*d_1_y + r_1_y;
    const lane s_1_z = -L_a_1*d_1_z + r_1_z;
    const lane s_2_x = -L_a_2*d_2_x + r_2_x;
    const lane s_2_y = -L_a_2*d_2_y + r_2_y;
    const lane s_2_z = -L_a_2*d_2_z + r_2_z;
    const lane s_3_x = -L_a_3*d_3_x + r_3_x;
    const lane s_3_y = -L_a_3*d_3_y + r_3_y;
    const lane s_3_z = -L_a_3*d_3_z + r_3_z;
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
    const lane t7 = 2.0*L_a_1*lanes_sqrt(rho2_1);
    const lane t8 = 2.0*L_a_2*lanes_sqrt(rho2_2);
    const lane t9 = 2.0*L_a_3*lanes_sqrt(rho2_3);
    const lane t10 = 1.0/((det_D_l*det_D_l));
    q[0] = LANES(theta_1);
    q[1] = LANES(theta_2);
    q[2] = LANES(theta_3);
    margin[0] = LANES(l_d_1 - lanes_sqrt(t1 - t7));
    margin[1] = LANES(-l_d_1 + lanes_sqrt(t1 + t7));
    margin[2] = LANES(l_d_2 - lanes_sqrt(t3 - t8));
    margin[3] = LANES(-l_d_2 + lanes_sqrt(t3 + t8));
    margin[4] = LANES(l_d_3 - lanes_sqrt(t5 - t9));
    margin[5] = LANES(-l_d_3 + lanes_sqrt(t5 + t9));
    margin[6] =
        LANES(lanes_sqrt((s_1_x*s_1_x) + (s_1_y*s_1_y) + (s_1_z*s_1_z) + (s_2_x*s_2_x) + (s_2_y*s_2_y)
        + (s_2_z*s_2_z) + (s_3_x*s_3_x) + (s_3_y*s_3_y) + (s_3_z*s_3_z))*lanes_sqrt((A_x_1*A_x_1)*t10
        + (A_x_2*A_x_2)*t10 + (A_x_3*A_x_3)*t10 + (A_y_1*A_y_1)*t10 + (A_y_2*A_y_2)*t10 + (A_y_3*A_y_3)*t10
        + (A_z_1*A_z_1)*t10 + (A_z_2*A_z_2)*t10 + (A_z_3*A_z_3)*t10));
    margin[7] = LANES(theta_1 - theta_min_1);
    margin[8] = LANES(-theta_1 + theta_max_1);
    margin[9] = LANES(theta_2 - theta_min_2);
    margin[10] = LANES(-theta_2 + theta_max_2);
    margin[11] = LANES(theta_3 - theta_min_3);
    margin[12] = LANES(-theta_3 + theta_max_3);
}

/* Mass and stiffness matrices without effects, and the motion of the platform.
 *
 * Source: modal_matrices and platform_jacobian.
 * 666 operations; 2413647 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double m_a_1 = parameters[43];
    const double m_a_2 = parameters[44];
    const double m_a_3 = parameters[45];
    const double r_a_1 = parameters[46];
    const double r_a_2 = parameters[47];
    const double r_a_3 = parameters[48];
    const double I_a_1 = parameters[49];
    const double I_a_2 = parameters[50];
    const double I_a_3 = parameters[51];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double m_d_1 = parameters[55];
    const double m_d_2 = parameters[56];
    const double m_d_3 = parameters[57];
    const double k_r_1 = parameters[58];
    const double k_r_2 = parameters[59];
    const double k_r_3 = parameters[60];
    const double I_m_1 = parameters[61];
    const double I_m_2 = parameters[62];
    const double I_m_3 = parameters[63];
    const double i_g_1 = parameters[64];
    const double i_g_2 = parameters[65];
    const double i_g_3 = parameters[66];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const double t1 = (L_a_1*L_a_1);
    const lane C_1 = (1.0/2.0)*(-(l_d_1*l_d_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z) + t1)/L_a_1;
    const lane S_1 = sigma_1*lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane t2 = 1.0/rho2_1;
    const lane c_1 = t2*(A_1*C_1 - B_1*S_1);
    const lane sn_1 = t2*(A_1*S_1 + B_1*C_1);
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const double t3 = (L_a_2*L_a_2);
    const lane C_2 = (1.0/2.0)*(-(l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z) + t3)/L_a_2;
    const lane S_2 = sigma_2*lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane t4 = 1.0/rho2_2;
    const lane c_2 = t4*(A_2*C_2 - B_2*S_2);
    const lane sn_2 = t4*(A_2*S_2 + B_2*C_2);
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const double t5 = (L_a_3*L_a_3);
    const lane C_3 = (1.0/2.0)*(-(l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z) + t5)/L_a_3;
    const lane S_3 = sigma_3*lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane t6 = 1.0/rho2_3;
    const lane c_3 = t6*(A_3*C_3 - B_3*S_3);
    const lane sn_3 = t6*(A_3*S_3 + B_3*C_3);
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const lane t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const lane t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const lane t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const lane t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const lane t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const lane t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const lane t7 = L_a_1*d_1_x;
    const lane s_1_x = r_1_x - t7;
    const lane t8 = L_a_1*d_1_y;
    const lane s_1_y = r_1_y - t8;
    const lane t9 = L_a_1*d_1_z;
    const lane s_1_z = r_1_z - t9;
    const lane t10 = L_a_2*d_2_x;
    const lane s_2_x = r_2_x - t10;
    const lane t11 = L_a_2*d_2_y;
    const lane s_2_y = r_2_y - t11;
    const lane t12 = L_a_2*d_2_z;
    const lane s_2_z = r_2_z - t12;
    const lane t13 = L_a_3*d_3_x;
    const lane s_3_x = r_3_x - t13;
    const lane t14 = L_a_3*d_3_y;
    const lane s_3_y = r_3_y - t14;
    const lane t15 = L_a_3*d_3_z;
    const lane s_3_z = r_3_z - t15;
    const lane t16 = L_a_1*t_1_x;
    const lane t17 = L_a_1*t_1_y;
    const lane t18 = L_a_1*t_1_z;
    const lane D_r_1 = s_1_x*t16 + s_1_y*t17 + s_1_z*t18;
    const lane t19 = L_a_2*t_2_x;
    const lane t20 = L_a_2*t_2_y;
    const lane t21 = L_a_2*t_2_z;
    const lane D_r_2 = s_2_x*t19 + s_2_y*t20 + s_2_z*t21;
    const lane t22 = L_a_3*t_3_x;
    const lane t23 = L_a_3*t_3_y;
    const lane t24 = L_a_3*t_3_z;
    const lane D_r_3 = s_3_x*t22 + s_3_y*t23 + s_3_z*t24;
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
    const lane t25 = 1.0/det_D_l;
    const lane t26 = D_r_1*t25;
    const lane D_p_x_1 = A_x_1*t26;
    const lane t27 = D_r_2*t25;
    const lane D_p_x_2 = A_x_2*t27;
    const lane t28 = D_r_3*t25;
    const lane D_p_x_3 = A_x_3*t28;
    const lane D_p_y_1 = A_y_1*t26;
    const lane D_p_y_2 = A_y_2*t27;
    const lane D_p_y_3 = A_y_3*t28;
    const lane D_p_z_1 = A_z_1*t26;
    const lane D_p_z_2 = A_z_2*t27;
    const lane D_p_z_3 = A_z_3*t28;
    const lane U_1_x_1 = D_p_x_1 - t16;
    const lane U_1_y_1 = D_p_y_1 - t17;
    const lane U_1_z_1 = D_p_z_1 - t18;
    const lane U_2_x_2 = D_p_x_2 - t19;
    const lane U_2_y_2 = D_p_y_2 - t20;
    const lane U_2_z_2 = D_p_z_2 - t21;
    const lane U_3_x_3 = D_p_x_3 - t22;
    const lane U_3_y_3 = D_p_y_3 - t23;
    const lane U_3_z_3 = D_p_z_3 - t24;
    const double I_1 = I_m_1*(i_g_1*i_g_1);
    const double I_2 = I_m_2*(i_g_2*i_g_2);
    const double I_3 = I_m_3*(i_g_3*i_g_3);
    const double t29 = (1.0/2.0)*m_d_1;
    const double t30 = (1.0/2.0)*m_d_2;
    const double t31 = (1.0/2.0)*m_d_3;
    const double t32 = m_p + t29 + t30 + t31;
    const double t33 = g_x*t32;
    const double t34 = g_y*t32;
    const double t35 = g_z*t32;
    const lane mu_1 = t25*(-A_x_1*t33 - A_y_1*t34 - A_z_1*t35);
    const lane mu_2 = t25*(-A_x_2*t33 - A_y_2*t34 - A_z_2*t35);
    const lane mu_3 = t25*(-A_x_3*t33 - A_y_3*t34 - A_z_3*t35);
    const double t36 = (1.0/3.0)*m_d_1;
    const double t37 = (1.0/6.0)*m_d_1;
    const lane t38 = t16*t37;
    const lane t39 = t17*t37;
    const lane t40 = t18*t37;
    const double t41 = (1.0/3.0)*m_d_2;
    const double t42 = (1.0/3.0)*m_d_3;
    const double t43 = m_p + t36 + t41 + t42;
    const lane t44 = D_p_x_1*t43 + t38;
    const lane t45 = D_p_y_1*t43 + t39;
    const lane t46 = D_p_z_1*t43 + t40;
    const double t47 = (1.0/6.0)*m_d_2;
    const lane t48 = t19*t47;
    const lane t49 = t20*t47;
    const lane t50 = t21*t47;
    const double t51 = (1.0/6.0)*m_d_3;
    const lane t52 = t22*t51;
    const lane t53 = t23*t51;
    const lane t54 = t24*t51;
    const lane t55 = D_p_x_2*t43 + t48;
    const lane t56 = D_p_y_2*t43 + t49;
    const lane t57 = D_p_z_2*t43 + t50;
    const lane t58 = (D_p_x_1*D_p_x_1);
    const lane t59 = (D_p_y_1*D_p_y_1);
    const lane t60 = (D_p_z_1*D_p_z_1);
    const double t61 = L_a_1*t29 + m_a_1*r_a_1;
    const lane t62 = D_p_x_1*mu_3;
    const lane t63 = D_p_x_1*mu_2;
    const lane t64 = U_1_x_1*mu_1;
    const lane t65 = D_p_y_1*mu_3;
    const lane t66 = D_p_y_1*mu_2;
    const lane t67 = U_1_y_1*mu_1;
    const lane t68 = D_p_z_1*mu_3;
    const lane t69 = D_p_z_1*mu_2;
    const lane t70 = U_1_z_1*mu_1;
    const lane t71 = (D_p_x_2*D_p_x_2);
    const lane t72 = (D_p_y_2*D_p_y_2);
    const lane t73 = (D_p_z_2*D_p_z_2);
    const double t74 = L_a_2*t30 + m_a_2*r_a_2;
    const lane t75 = (D_p_x_3*D_p_x_3);
    const lane t76 = (D_p_y_3*D_p_y_3);
    const lane t77 = (D_p_z_3*D_p_z_3);
    const double t78 = L_a_3*t31 + m_a_3*r_a_3;
    lanes_clear(M, 36);
    M[0] =
        LANES(D_p_x_1*t38 + D_p_x_1*t44 + D_p_y_1*t39 + D_p_y_1*t45 + D_p_z_1*t40 + D_p_z_1*t46 + I_a_1
        + t1*t36);
    M[1] = M[6] = LANES(D_p_x_1*t48 + D_p_x_2*t44 + D_p_y_1*t49 + D_p_y_2*t45 + D_p_z_1*t50 + D_p_z_2*t46);
    M[2] = M[12] = LANES(D_p_x_1*t52 + D_p_x_3*t44 + D_p_y_1*t53 + D_p_y_3*t45 + D_p_z_1*t54 + D_p_z_3*t46);
    M[7] =
        LANES(D_p_x_2*t48 + D_p_x_2*t55 + D_p_y_2*t49 + D_p_y_2*t56 + D_p_z_2*t50 + D_p_z_2*t57 + I_a_2
        + t3*t41);
    M[8] = M[13] = LANES(D_p_x_2*t52 + D_p_x_3*t55 + D_p_y_2*t53 + D_p_y_3*t56 + D_p_z_2*t54 + D_p_z_3*t57);
    M[14] =
        LANES(D_p_x_3*t52 + D_p_x_3*(D_p_x_3*t43 + t52) + D_p_y_3*t53 + D_p_y_3*(D_p_y_3*t43 + t53)
        + D_p_z_3*t54 + D_p_z_3*(D_p_z_3*t43 + t54) + I_a_3 + t42*t5);
    M[21] = LANES(I_1);
    M[28] = LANES(I_2);
    M[35] = LANES(I_3);
    lanes_clear(K, 36);
    K[0] =
        LANES(-(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + d_1_x*g_x*t61
        + d_1_y*g_y*t61 + d_1_z*g_z*t61 + k_r_1 - mu_1*s_1_x*t7 - mu_1*s_1_y*t8 - mu_1*s_1_z*t9 - mu_2*t58
        - mu_2*t59 - mu_2*t60 - mu_3*t58 - mu_3*t59 - mu_3*t60);
    K[1] = K[6] =
        LANES(-D_p_x_2*t62 - D_p_x_2*t64 - D_p_y_2*t65 - D_p_y_2*t67 - D_p_z_2*t68 - D_p_z_2*t70
        - U_2_x_2*t63 - U_2_y_2*t66 - U_2_z_2*t69);
    K[2] = K[12] =
        LANES(-D_p_x_3*t63 - D_p_x_3*t64 - D_p_y_3*t66 - D_p_y_3*t67 - D_p_z_3*t69 - D_p_z_3*t70
        - U_3_x_3*t62 - U_3_y_3*t65 - U_3_z_3*t68);
    K[3] = K[18] = LANES(-k_r_1);
    K[7] =
        LANES(-(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + d_2_x*g_x*t74
        + d_2_y*g_y*t74 + d_2_z*g_z*t74 + k_r_2 - mu_1*t71 - mu_1*t72 - mu_1*t73 - mu_2*s_2_x*t10
        - mu_2*s_2_y*t11 - mu_2*s_2_z*t12 - mu_3*t71 - mu_3*t72 - mu_3*t73);
    K[8] = K[13] =
        LANES(-D_p_x_2*D_p_x_3*mu_1 - D_p_x_2*U_3_x_3*mu_3 - D_p_x_3*U_2_x_2*mu_2 - D_p_y_2*D_p_y_3*mu_1
        - D_p_y_2*U_3_y_3*mu_3 - D_p_y_3*U_2_y_2*mu_2 - D_p_z_2*D_p_z_3*mu_1 - D_p_z_2*U_3_z_3*mu_3
        - D_p_z_3*U_2_z_2*mu_2);
    K[10] = K[25] = LANES(-k_r_2);
    K[14] =
        LANES(-(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + d_3_x*g_x*t78
        + d_3_y*g_y*t78 + d_3_z*g_z*t78 + k_r_3 - mu_1*t75 - mu_1*t76 - mu_1*t77 - mu_2*t75 - mu_2*t76
        - mu_2*t77 - mu_3*s_3_x*t13 - mu_3*s_3_y*t14 - mu_3*s_3_z*t15);
    K[17] = K[32] = LANES(-k_r_3);
    K[21] = LANES(k_r_1);
    K[28] = LANES(k_r_2);
    K[35] = LANES(k_r_3);
    lanes_clear(J_p, 18);
    J_p[0] = LANES(D_p_x_1);
    J_p[1] = LANES(D_p_x_2);
    J_p[2] = LANES(D_p_x_3);
    J_p[6] = LANES(D_p_y_1);
    J_p[7] = LANES(D_p_y_2);
    J_p[8] = LANES(D_p_y_3);
    J_p[12] = LANES(D_p_z_1);
    J_p[13] = LANES(D_p_z_2);
    J_p[14] = LANES(D_p_z_3);
}

/* Mass and stiffness matrices with all released joints free, and the motion of the platform.
 *
 * Source: extended_matrices and extended_platform_motion.
 * 1333 operations; 10269897 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double m_a_1 = parameters[43];
    const double m_a_2 = parameters[44];
    const double m_a_3 = parameters[45];
    const double r_a_1 = parameters[46];
    const double r_a_2 = parameters[47];
    const double r_a_3 = parameters[48];
    const double I_a_1 = parameters[49];
    const double I_a_2 = parameters[50];
    const double I_a_3 = parameters[51];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double m_d_1 = parameters[55];
    const double m_d_2 = parameters[56];
    const double m_d_3 = parameters[57];
    const double k_r_1 = parameters[58];
    const double k_r_2 = parameters[59];
    const double k_r_3 = parameters[60];
    const double I_m_1 = parameters[61];
    const double I_m_2 = parameters[62];
    const double I_m_3 = parameters[63];
    const double i_g_1 = parameters[64];
    const double i_g_2 = parameters[65];
    const double i_g_3 = parameters[66];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double a_R_1 = effects[0];
    const double a_R_2 = effects[1];
    const double a_R_3 = effects[2];
    const double k_C = effects[3];
    const double I_G = effects[5];
    const double m_L = effects[6];
    const double k_S = effects[8];
    const double m_F = effects[11];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const double t1 = (L_a_1*L_a_1);
    const lane C_1 = (1.0/2.0)*(-(l_d_1*l_d_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z) + t1)/L_a_1;
    const lane S_1 = sigma_1*lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane t2 = 1.0/rho2_1;
    const lane c_1 = t2*(A_1*C_1 - B_1*S_1);
    const lane sn_1 = t2*(A_1*S_1 + B_1*C_1);
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const double t3 = (L_a_2*L_a_2);
    const lane C_2 = (1.0/2.0)*(-(l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z) + t3)/L_a_2;
    const lane S_2 = sigma_2*lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane t4 = 1.0/rho2_2;
    const lane c_2 = t4*(A_2*C_2 - B_2*S_2);
    const lane sn_2 = t4*(A_2*S_2 + B_2*C_2);
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const double t5 = (L_a_3*L_a_3);
    const lane C_3 = (1.0/2.0)*(-(l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z) + t5)/L_a_3;
    const lane S_3 = sigma_3*lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane t6 = 1.0/rho2_3;
    const lane c_3 = t6*(A_3*C_3 - B_3*S_3);
    const lane sn_3 = t6*(A_3*S_3 + B_3*C_3);
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const lane t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const lane t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const lane t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const lane t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const lane t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const lane t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const lane t7 = L_a_1*d_1_x;
    const lane s_1_x = r_1_x - t7;
    const lane t8 = L_a_1*d_1_y;
    const lane s_1_y = r_1_y - t8;
    const lane t9 = L_a_1*d_1_z;
    const lane s_1_z = r_1_z - t9;
    const lane t10 = L_a_2*d_2_x;
    const lane s_2_x = r_2_x - t10;
    const lane t11 = L_a_2*d_2_y;
    const lane s_2_y = r_2_y - t11;
    const lane t12 = L_a_2*d_2_z;
    const lane s_2_z = r_2_z - t12;
    const lane t13 = L_a_3*d_3_x;
    const lane s_3_x = r_3_x - t13;
    const lane t14 = L_a_3*d_3_y;
    const lane s_3_y = r_3_y - t14;
    const lane t15 = L_a_3*d_3_z;
    const lane s_3_z = r_3_z - t15;
    const lane t16 = L_a_1*t_1_x;
    const lane t17 = L_a_1*t_1_y;
    const lane t18 = L_a_1*t_1_z;
    const lane D_r_1 = s_1_x*t16 + s_1_y*t17 + s_1_z*t18;
    const lane t19 = L_a_2*t_2_x;
    const lane t20 = L_a_2*t_2_y;
    const lane t21 = L_a_2*t_2_z;
    const lane D_r_2 = s_2_x*t19 + s_2_y*t20 + s_2_z*t21;
    const lane t22 = L_a_3*t_3_x;
    const lane t23 = L_a_3*t_3_y;
    const lane t24 = L_a_3*t_3_z;
    const lane D_r_3 = s_3_x*t22 + s_3_y*t23 + s_3_z*t24;
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
    const lane t25 = 1.0/det_D_l;
    const lane t26 = A_x_1*t25;
    const lane D_p_x_1 = D_r_1*t26;
    const lane t27 = A_x_2*t25;
    const lane D_p_x_2 = D_r_2*t27;
    const lane t28 = A_x_3*t25;
    const lane D_p_x_3 = D_r_3*t28;
    const lane D_delta_x_1 = l_d_1*t26;
    const lane D_delta_x_2 = l_d_2*t27;
    const lane D_delta_x_3 = l_d_3*t28;
    const lane t29 = A_y_1*t25;
    const lane D_p_y_1 = D_r_1*t29;
    const lane t30 = A_y_2*t25;
    const lane D_p_y_2 = D_r_2*t30;
    const lane t31 = A_y_3*t25;
    const lane D_p_y_3 = D_r_3*t31;
    const lane D_delta_y_1 = l_d_1*t29;
    const lane D_delta_y_2 = l_d_2*t30;
    const lane D_delta_y_3 = l_d_3*t31;
    const lane t32 = A_z_1*t25;
    const lane D_p_z_1 = D_r_1*t32;
    const lane t33 = A_z_2*t25;
    const lane D_p_z_2 = D_r_2*t33;
    const lane t34 = A_z_3*t25;
    const lane D_p_z_3 = D_r_3*t34;
    const lane D_delta_z_1 = l_d_1*t32;
    const lane D_delta_z_2 = l_d_2*t33;
    const lane D_delta_z_3 = l_d_3*t34;
    const lane U_1_x_1 = D_p_x_1 - t16;
    const lane U_1_y_1 = D_p_y_1 - t17;
    const lane U_1_z_1 = D_p_z_1 - t18;
    const lane U_2_x_2 = D_p_x_2 - t19;
    const lane U_2_y_2 = D_p_y_2 - t20;
    const lane U_2_z_2 = D_p_z_2 - t21;
    const lane U_3_x_3 = D_p_x_3 - t22;
    const lane U_3_y_3 = D_p_y_3 - t23;
    const lane U_3_z_3 = D_p_z_3 - t24;
    const double I_1 = I_G + I_m_1*(i_g_1*i_g_1);
    const double I_2 = I_G + I_m_2*(i_g_2*i_g_2);
    const double I_3 = I_G + I_m_3*(i_g_3*i_g_3);
    const double k_1 = k_r_1*(a_R_1 + 1.0);
    const double k_2 = k_r_2*(a_R_2 + 1.0);
    const double k_3 = k_r_3*(a_R_3 + 1.0);
    const double t35 = (1.0/2.0)*m_d_1;
    const double t36 = (1.0/2.0)*m_d_2;
    const double t37 = (1.0/2.0)*m_d_3;
    const double t38 = m_L + m_p;
    const double t39 = t35 + t36 + t37 + t38;
    const double t40 = g_x*t39;
    const double t41 = g_y*t39;
    const double t42 = g_z*t39;
    const lane mu_1 = t25*(-A_x_1*t40 - A_y_1*t41 - A_z_1*t42);
    const lane mu_2 = t25*(-A_x_2*t40 - A_y_2*t41 - A_z_2*t42);
    const lane mu_3 = t25*(-A_x_3*t40 - A_y_3*t41 - A_z_3*t42);
    const double t43 = (1.0/3.0)*m_d_1;
    const double t44 = (1.0/6.0)*m_d_1;
    const lane t45 = t16*t44;
    const lane t46 = t17*t44;
    const lane t47 = t18*t44;
    const double t48 = (1.0/3.0)*m_d_2;
    const double t49 = (1.0/3.0)*m_d_3;
    const double t50 = t38 + t43 + t48 + t49;
    const lane t51 = D_p_x_1*t50;
    const lane t52 = t45 + t51;
    const lane t53 = D_p_y_1*t50;
    const lane t54 = t46 + t53;
    const lane t55 = D_p_z_1*t50;
    const lane t56 = t47 + t55;
    const double t57 = (1.0/6.0)*m_d_2;
    const lane t58 = t19*t57;
    const lane t59 = t20*t57;
    const lane t60 = t21*t57;
    const double t61 = (1.0/6.0)*m_d_3;
    const lane t62 = t22*t61;
    const lane t63 = t23*t61;
    const lane t64 = t24*t61;
    const double t65 = m_a_1*r_a_1;
    const double t66 = t44 + t57 + t61;
    const lane t67 = D_p_x_2*t50;
    const lane t68 = t58 + t67;
    const lane t69 = D_p_y_2*t50;
    const lane t70 = t59 + t69;
    const lane t71 = D_p_z_2*t50;
    const lane t72 = t60 + t71;
    const double t73 = m_a_2*r_a_2;
    const lane t74 = D_p_x_3*t50;
    const lane t75 = t62 + t74;
    const lane t76 = D_p_y_3*t50;
    const lane t77 = t63 + t76;
    const lane t78 = D_p_z_3*t50;
    const lane t79 = t64 + t78;
    const double t80 = m_a_3*r_a_3;
    const lane t81 = (D_delta_x_1*D_delta_x_1);
    const lane t82 = (D_delta_y_1*D_delta_y_1);
    const lane t83 = (D_delta_z_1*D_delta_z_1);
    const lane t84 = D_delta_x_1*t50;
    const lane t85 = D_delta_y_1*t50;
    const lane t86 = D_delta_z_1*t50;
    const lane t87 = (D_delta_x_2*D_delta_x_2);
    const lane t88 = (D_delta_y_2*D_delta_y_2);
    const lane t89 = (D_delta_z_2*D_delta_z_2);
    const lane t90 = D_delta_x_2*t50;
    const lane t91 = D_delta_y_2*t50;
    const lane t92 = D_delta_z_2*t50;
    const lane t93 = (D_delta_x_3*D_delta_x_3);
    const lane t94 = (D_delta_y_3*D_delta_y_3);
    const lane t95 = (D_delta_z_3*D_delta_z_3);
    const double t96 = m_F + m_a_1 + m_a_2 + m_a_3 + m_d_1 + m_d_2 + m_d_3 + t38;
    const double t97 = L_a_1*t35 + t65;
    const lane t98 = (D_p_x_1*D_p_x_1);
    const lane t99 = (D_p_y_1*D_p_y_1);
    const lane t100 = (D_p_z_1*D_p_z_1);
    const lane t101 = D_p_x_1*mu_3;
    const lane t102 = D_p_x_1*mu_2;
    const lane t103 = U_1_x_1*mu_1;
    const lane t104 = D_p_y_1*mu_3;
    const lane t105 = D_p_y_1*mu_2;
    const lane t106 = U_1_y_1*mu_1;
    const lane t107 = D_p_z_1*mu_3;
    const lane t108 = D_p_z_1*mu_2;
    const lane t109 = U_1_z_1*mu_1;
    const lane t110 = (D_p_x_2*D_p_x_2);
    const lane t111 = (D_p_y_2*D_p_y_2);
    const lane t112 = (D_p_z_2*D_p_z_2);
    const double t113 = L_a_2*t36 + t73;
    const lane t114 = D_p_x_2*mu_1;
    const lane t115 = D_p_x_2*mu_3;
    const lane t116 = U_2_x_2*mu_2;
    const lane t117 = D_p_y_2*mu_1;
    const lane t118 = D_p_y_2*mu_3;
    const lane t119 = U_2_y_2*mu_2;
    const lane t120 = D_p_z_2*mu_1;
    const lane t121 = D_p_z_2*mu_3;
    const lane t122 = U_2_z_2*mu_2;
    const lane t123 = (D_p_x_3*D_p_x_3);
    const lane t124 = (D_p_y_3*D_p_y_3);
    const lane t125 = (D_p_z_3*D_p_z_3);
    const double t126 = L_a_3*t37 + t80;
    const lane t127 = D_delta_x_1*D_p_x_3;
    const lane t128 = U_3_x_3*mu_3;
    const lane t129 = D_delta_y_1*D_p_y_3;
    const lane t130 = U_3_y_3*mu_3;
    const lane t131 = D_delta_z_1*D_p_z_3;
    const lane t132 = U_3_z_3*mu_3;
    const lane t133 = D_delta_x_2*D_p_x_3;
    const lane t134 = D_delta_y_2*D_p_y_3;
    const lane t135 = D_delta_z_2*D_p_z_3;
    const lane t136 = D_delta_x_3*D_p_x_3;
    const lane t137 = D_delta_y_3*D_p_y_3;
    const lane t138 = D_delta_z_3*D_p_z_3;
    const lane t139 = D_delta_x_1*D_delta_x_2;
    const lane t140 = D_delta_y_1*D_delta_y_2;
    const lane t141 = D_delta_z_1*D_delta_z_2;
    const lane t142 = D_delta_x_1*D_delta_x_3;
    const lane t143 = D_delta_y_1*D_delta_y_3;
    const lane t144 = D_delta_z_1*D_delta_z_3;
    const lane t145 = D_delta_x_2*D_delta_x_3;
    const lane t146 = D_delta_y_2*D_delta_y_3;
    const lane t147 = D_delta_z_2*D_delta_z_3;
    lanes_clear(M, 144);
    M[0] =
        LANES(D_p_x_1*t45 + D_p_x_1*t52 + D_p_y_1*t46 + D_p_y_1*t54 + D_p_z_1*t47 + D_p_z_1*t56 + I_a_1
        + t1*t43);
    M[1] = M[12] = LANES(D_p_x_1*t58 + D_p_x_2*t52 + D_p_y_1*t59 + D_p_y_2*t54 + D_p_z_1*t60 + D_p_z_2*t56);
    M[2] = M[24] = LANES(D_p_x_1*t62 + D_p_x_3*t52 + D_p_y_1*t63 + D_p_y_3*t54 + D_p_z_1*t64 + D_p_z_3*t56);
    M[6] = M[72] = LANES(D_delta_x_1*t52 + D_delta_y_1*t54 + D_delta_z_1*t56);
    M[7] = M[84] = LANES(D_delta_x_2*t52 + D_delta_y_2*t54 + D_delta_z_2*t56);
    M[8] = M[96] = LANES(D_delta_x_3*t52 + D_delta_y_3*t54 + D_delta_z_3*t56);
    M[9] = M[108] = LANES(D_p_x_1*t66 + t16*t35 + t51 + t65*t_1_x);
    M[10] = M[120] = LANES(D_p_y_1*t66 + t17*t35 + t53 + t65*t_1_y);
    M[11] = M[132] = LANES(D_p_z_1*t66 + t18*t35 + t55 + t65*t_1_z);
    M[13] =
        LANES(D_p_x_2*t58 + D_p_x_2*t68 + D_p_y_2*t59 + D_p_y_2*t70 + D_p_z_2*t60 + D_p_z_2*t72 + I_a_2
        + t3*t48);
    M[14] = M[25] = LANES(D_p_x_2*t62 + D_p_x_3*t68 + D_p_y_2*t63 + D_p_y_3*t70 + D_p_z_2*t64 + D_p_z_3*t72);
    M[18] = M[73] = LANES(D_delta_x_1*t68 + D_delta_y_1*t70 + D_delta_z_1*t72);
    M[19] = M[85] = LANES(D_delta_x_2*t68 + D_delta_y_2*t70 + D_delta_z_2*t72);
    M[20] = M[97] = LANES(D_delta_x_3*t68 + D_delta_y_3*t70 + D_delta_z_3*t72);
    M[21] = M[109] = LANES(D_p_x_2*t66 + t19*t36 + t67 + t73*t_2_x);
    M[22] = M[121] = LANES(D_p_y_2*t66 + t20*t36 + t69 + t73*t_2_y);
    M[23] = M[133] = LANES(D_p_z_2*t66 + t21*t36 + t71 + t73*t_2_z);
    M[26] =
        LANES(D_p_x_3*t62 + D_p_x_3*t75 + D_p_y_3*t63 + D_p_y_3*t77 + D_p_z_3*t64 + D_p_z_3*t79 + I_a_3
        + t49*t5);
    M[30] = M[74] = LANES(D_delta_x_1*t75 + D_delta_y_1*t77 + D_delta_z_1*t79);
    M[31] = M[86] = LANES(D_delta_x_2*t75 + D_delta_y_2*t77 + D_delta_z_2*t79);
    M[32] = M[98] = LANES(D_delta_x_3*t75 + D_delta_y_3*t77 + D_delta_z_3*t79);
    M[33] = M[110] = LANES(D_p_x_3*t66 + t22*t37 + t74 + t80*t_3_x);
    M[34] = M[122] = LANES(D_p_y_3*t66 + t23*t37 + t76 + t80*t_3_y);
    M[35] = M[134] = LANES(D_p_z_3*t66 + t24*t37 + t78 + t80*t_3_z);
    M[39] = LANES(I_1);
    M[52] = LANES(I_2);
    M[65] = LANES(I_3);
    M[78] = LANES(t50*t81 + t50*t82 + t50*t83);
    M[79] = M[90] = LANES(D_delta_x_2*t84 + D_delta_y_2*t85 + D_delta_z_2*t86);
    M[80] = M[102] = LANES(D_delta_x_3*t84 + D_delta_y_3*t85 + D_delta_z_3*t86);
    M[81] = M[114] = LANES(D_delta_x_1*t66 + t84);
    M[82] = M[126] = LANES(D_delta_y_1*t66 + t85);
    M[83] = M[138] = LANES(D_delta_z_1*t66 + t86);
    M[91] = LANES(t50*t87 + t50*t88 + t50*t89);
    M[92] = M[103] = LANES(D_delta_x_3*t90 + D_delta_y_3*t91 + D_delta_z_3*t92);
    M[93] = M[115] = LANES(D_delta_x_2*t66 + t90);
    M[94] = M[127] = LANES(D_delta_y_2*t66 + t91);
    M[95] = M[139] = LANES(D_delta_z_2*t66 + t92);
    M[104] = LANES(t50*t93 + t50*t94 + t50*t95);
    M[105] = M[116] = LANES(D_delta_x_3*t50 + D_delta_x_3*t66);
    M[106] = M[128] = LANES(D_delta_y_3*t50 + D_delta_y_3*t66);
    M[107] = M[140] = LANES(D_delta_z_3*t50 + D_delta_z_3*t66);
    M[117] = LANES(t96);
    M[130] = LANES(t96);
    M[143] = LANES(t96);
    lanes_clear(K, 144);
    K[0] =
        LANES(-(U_1_x_1*U_1_x_1)*mu_1 - (U_1_y_1*U_1_y_1)*mu_1 - (U_1_z_1*U_1_z_1)*mu_1 + d_1_x*g_x*t97
        + d_1_y*g_y*t97 + d_1_z*g_z*t97 + k_1 + k_C*t100 + k_C*t98 + k_C*t99 - mu_1*s_1_x*t7 - mu_1*s_1_y*t8
        - mu_1*s_1_z*t9 - mu_2*t100 - mu_2*t98 - mu_2*t99 - mu_3*t100 - mu_3*t98 - mu_3*t99);
    K[1] = K[12] =
        LANES(D_p_x_1*D_p_x_2*k_C - D_p_x_2*t101 - D_p_x_2*t103 + D_p_y_1*D_p_y_2*k_C - D_p_y_2*t104
        - D_p_y_2*t106 + D_p_z_1*D_p_z_2*k_C - D_p_z_2*t107 - D_p_z_2*t109 - U_2_x_2*t102 - U_2_y_2*t105
        - U_2_z_2*t108);
    K[2] = K[24] =
        LANES(D_p_x_1*D_p_x_3*k_C - D_p_x_3*t102 - D_p_x_3*t103 + D_p_y_1*D_p_y_3*k_C - D_p_y_3*t105
        - D_p_y_3*t106 + D_p_z_1*D_p_z_3*k_C - D_p_z_3*t108 - D_p_z_3*t109 - U_3_x_3*t101 - U_3_y_3*t104
        - U_3_z_3*t107);
    K[3] = K[36] = LANES(-k_1);
    K[6] = K[72] =
        LANES(D_delta_x_1*D_p_x_1*k_C - D_delta_x_1*t101 - D_delta_x_1*t102 - D_delta_x_1*t103
        + D_delta_y_1*D_p_y_1*k_C - D_delta_y_1*t104 - D_delta_y_1*t105 - D_delta_y_1*t106
        + D_delta_z_1*D_p_z_1*k_C - D_delta_z_1*t107 - D_delta_z_1*t108 - D_delta_z_1*t109);
    K[7] = K[84] =
        LANES(D_delta_x_2*D_p_x_1*k_C - D_delta_x_2*t101 - D_delta_x_2*t102 - D_delta_x_2*t103
        + D_delta_y_2*D_p_y_1*k_C - D_delta_y_2*t104 - D_delta_y_2*t105 - D_delta_y_2*t106
        + D_delta_z_2*D_p_z_1*k_C - D_delta_z_2*t107 - D_delta_z_2*t108 - D_delta_z_2*t109);
    K[8] = K[96] =
        LANES(D_delta_x_3*D_p_x_1*k_C - D_delta_x_3*t101 - D_delta_x_3*t102 - D_delta_x_3*t103
        + D_delta_y_3*D_p_y_1*k_C - D_delta_y_3*t104 - D_delta_y_3*t105 - D_delta_y_3*t106
        + D_delta_z_3*D_p_z_1*k_C - D_delta_z_3*t107 - D_delta_z_3*t108 - D_delta_z_3*t109);
    K[9] = K[108] = LANES(D_p_x_1*k_C);
    K[10] = K[120] = LANES(D_p_y_1*k_C);
    K[11] = K[132] = LANES(D_p_z_1*k_C);
    K[13] =
        LANES(-(U_2_x_2*U_2_x_2)*mu_2 - (U_2_y_2*U_2_y_2)*mu_2 - (U_2_z_2*U_2_z_2)*mu_2 + d_2_x*g_x*t113
        + d_2_y*g_y*t113 + d_2_z*g_z*t113 + k_2 + k_C*t110 + k_C*t111 + k_C*t112 - mu_1*t110 - mu_1*t111
        - mu_1*t112 - mu_2*s_2_x*t10 - mu_2*s_2_y*t11 - mu_2*s_2_z*t12 - mu_3*t110 - mu_3*t111 - mu_3*t112);
    K[14] = K[25] =
        LANES(D_p_x_2*D_p_x_3*k_C - D_p_x_3*t114 - D_p_x_3*t116 + D_p_y_2*D_p_y_3*k_C - D_p_y_3*t117
        - D_p_y_3*t119 + D_p_z_2*D_p_z_3*k_C - D_p_z_3*t120 - D_p_z_3*t122 - U_3_x_3*t115 - U_3_y_3*t118
        - U_3_z_3*t121);
    K[16] = K[49] = LANES(-k_2);
    K[18] = K[73] =
        LANES(D_delta_x_1*D_p_x_2*k_C - D_delta_x_1*t114 - D_delta_x_1*t115 - D_delta_x_1*t116
        + D_delta_y_1*D_p_y_2*k_C - D_delta_y_1*t117 - D_delta_y_1*t118 - D_delta_y_1*t119
        + D_delta_z_1*D_p_z_2*k_C - D_delta_z_1*t120 - D_delta_z_1*t121 - D_delta_z_1*t122);
    K[19] = K[85] =
        LANES(D_delta_x_2*D_p_x_2*k_C - D_delta_x_2*t114 - D_delta_x_2*t115 - D_delta_x_2*t116
        + D_delta_y_2*D_p_y_2*k_C - D_delta_y_2*t117 - D_delta_y_2*t118 - D_delta_y_2*t119
        + D_delta_z_2*D_p_z_2*k_C - D_delta_z_2*t120 - D_delta_z_2*t121 - D_delta_z_2*t122);
    K[20] = K[97] =
        LANES(D_delta_x_3*D_p_x_2*k_C - D_delta_x_3*t114 - D_delta_x_3*t115 - D_delta_x_3*t116
        + D_delta_y_3*D_p_y_2*k_C - D_delta_y_3*t117 - D_delta_y_3*t118 - D_delta_y_3*t119
        + D_delta_z_3*D_p_z_2*k_C - D_delta_z_3*t120 - D_delta_z_3*t121 - D_delta_z_3*t122);
    K[21] = K[109] = LANES(D_p_x_2*k_C);
    K[22] = K[121] = LANES(D_p_y_2*k_C);
    K[23] = K[133] = LANES(D_p_z_2*k_C);
    K[26] =
        LANES(-(U_3_x_3*U_3_x_3)*mu_3 - (U_3_y_3*U_3_y_3)*mu_3 - (U_3_z_3*U_3_z_3)*mu_3 + d_3_x*g_x*t126
        + d_3_y*g_y*t126 + d_3_z*g_z*t126 + k_3 + k_C*t123 + k_C*t124 + k_C*t125 - mu_1*t123 - mu_1*t124
        - mu_1*t125 - mu_2*t123 - mu_2*t124 - mu_2*t125 - mu_3*s_3_x*t13 - mu_3*s_3_y*t14 - mu_3*s_3_z*t15);
    K[29] = K[62] = LANES(-k_3);
    K[30] = K[74] =
        LANES(D_delta_x_1*D_p_x_3*k_C - D_delta_x_1*t128 + D_delta_y_1*D_p_y_3*k_C - D_delta_y_1*t130
        + D_delta_z_1*D_p_z_3*k_C - D_delta_z_1*t132 - mu_1*t127 - mu_1*t129 - mu_1*t131 - mu_2*t127
        - mu_2*t129 - mu_2*t131);
    K[31] = K[86] =
        LANES(D_delta_x_2*D_p_x_3*k_C - D_delta_x_2*t128 + D_delta_y_2*D_p_y_3*k_C - D_delta_y_2*t130
        + D_delta_z_2*D_p_z_3*k_C - D_delta_z_2*t132 - mu_1*t133 - mu_1*t134 - mu_1*t135 - mu_2*t133
        - mu_2*t134 - mu_2*t135);
    K[32] = K[98] =
        LANES(D_delta_x_3*D_p_x_3*k_C - D_delta_x_3*t128 + D_delta_y_3*D_p_y_3*k_C - D_delta_y_3*t130
        + D_delta_z_3*D_p_z_3*k_C - D_delta_z_3*t132 - mu_1*t136 - mu_1*t137 - mu_1*t138 - mu_2*t136
        - mu_2*t137 - mu_2*t138);
    K[33] = K[110] = LANES(D_p_x_3*k_C);
    K[34] = K[122] = LANES(D_p_y_3*k_C);
    K[35] = K[134] = LANES(D_p_z_3*k_C);
    K[39] = LANES(k_1 + k_S);
    K[52] = LANES(k_2 + k_S);
    K[65] = LANES(k_3 + k_S);
    K[78] =
        LANES(k_C*t81 + k_C*t82 + k_C*t83 - mu_1*t81 - mu_1*t82 - mu_1*t83 + mu_1 - mu_2*t81 - mu_2*t82
        - mu_2*t83 - mu_3*t81 - mu_3*t82 - mu_3*t83);
    K[79] = K[90] =
        LANES(D_delta_x_1*D_delta_x_2*k_C + D_delta_y_1*D_delta_y_2*k_C + D_delta_z_1*D_delta_z_2*k_C
        - mu_1*t139 - mu_1*t140 - mu_1*t141 - mu_2*t139 - mu_2*t140 - mu_2*t141 - mu_3*t139 - mu_3*t140
        - mu_3*t141);
    K[80] = K[102] =
        LANES(D_delta_x_1*D_delta_x_3*k_C + D_delta_y_1*D_delta_y_3*k_C + D_delta_z_1*D_delta_z_3*k_C
        - mu_1*t142 - mu_1*t143 - mu_1*t144 - mu_2*t142 - mu_2*t143 - mu_2*t144 - mu_3*t142 - mu_3*t143
        - mu_3*t144);
    K[81] = K[114] = LANES(D_delta_x_1*k_C);
    K[82] = K[126] = LANES(D_delta_y_1*k_C);
    K[83] = K[138] = LANES(D_delta_z_1*k_C);
    K[91] =
        LANES(k_C*t87 + k_C*t88 + k_C*t89 - mu_1*t87 - mu_1*t88 - mu_1*t89 - mu_2*t87 - mu_2*t88 - mu_2*t89
        + mu_2 - mu_3*t87 - mu_3*t88 - mu_3*t89);
    K[92] = K[103] =
        LANES(D_delta_x_2*D_delta_x_3*k_C + D_delta_y_2*D_delta_y_3*k_C + D_delta_z_2*D_delta_z_3*k_C
        - mu_1*t145 - mu_1*t146 - mu_1*t147 - mu_2*t145 - mu_2*t146 - mu_2*t147 - mu_3*t145 - mu_3*t146
        - mu_3*t147);
    K[93] = K[115] = LANES(D_delta_x_2*k_C);
    K[94] = K[127] = LANES(D_delta_y_2*k_C);
    K[95] = K[139] = LANES(D_delta_z_2*k_C);
    K[104] =
        LANES(k_C*t93 + k_C*t94 + k_C*t95 - mu_1*t93 - mu_1*t94 - mu_1*t95 - mu_2*t93 - mu_2*t94 - mu_2*t95
        - mu_3*t93 - mu_3*t94 - mu_3*t95 + mu_3);
    K[105] = K[116] = LANES(D_delta_x_3*k_C);
    K[106] = K[128] = LANES(D_delta_y_3*k_C);
    K[107] = K[140] = LANES(D_delta_z_3*k_C);
    K[117] = LANES(k_C);
    K[130] = LANES(k_C);
    K[143] = LANES(k_C);
    lanes_clear(J_p, 36);
    J_p[0] = LANES(D_p_x_1);
    J_p[1] = LANES(D_p_x_2);
    J_p[2] = LANES(D_p_x_3);
    J_p[6] = LANES(D_delta_x_1);
    J_p[7] = LANES(D_delta_x_2);
    J_p[8] = LANES(D_delta_x_3);
    J_p[9] = LANES(1.0);
    J_p[12] = LANES(D_p_y_1);
    J_p[13] = LANES(D_p_y_2);
    J_p[14] = LANES(D_p_y_3);
    J_p[18] = LANES(D_delta_y_1);
    J_p[19] = LANES(D_delta_y_2);
    J_p[20] = LANES(D_delta_y_3);
    J_p[22] = LANES(1.0);
    J_p[24] = LANES(D_p_z_1);
    J_p[25] = LANES(D_p_z_2);
    J_p[26] = LANES(D_p_z_3);
    J_p[30] = LANES(D_delta_z_1);
    J_p[31] = LANES(D_delta_z_2);
    J_p[32] = LANES(D_delta_z_3);
    J_p[35] = LANES(1.0);
}

/* Platform Jacobian, static equilibrium and elastic stiffness without effects.
 *
 * Source: platform_jacobian, static_equilibrium, elastic_hessian.
 * 372 operations; 204378 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double m_a_1 = parameters[43];
    const double m_a_2 = parameters[44];
    const double m_a_3 = parameters[45];
    const double r_a_1 = parameters[46];
    const double r_a_2 = parameters[47];
    const double r_a_3 = parameters[48];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double m_d_1 = parameters[55];
    const double m_d_2 = parameters[56];
    const double m_d_3 = parameters[57];
    const double k_r_1 = parameters[58];
    const double k_r_2 = parameters[59];
    const double k_r_3 = parameters[60];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const lane C_1 =
        (1.0/2.0)*((L_a_1*L_a_1) - (l_d_1*l_d_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z))/L_a_1;
    const lane S_1 = sigma_1*lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane t1 = 1.0/rho2_1;
    const lane c_1 = t1*(A_1*C_1 - B_1*S_1);
    const lane sn_1 = t1*(A_1*S_1 + B_1*C_1);
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const lane C_2 =
        (1.0/2.0)*((L_a_2*L_a_2) - (l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z))/L_a_2;
    const lane S_2 = sigma_2*lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane t2 = 1.0/rho2_2;
    const lane c_2 = t2*(A_2*C_2 - B_2*S_2);
    const lane sn_2 = t2*(A_2*S_2 + B_2*C_2);
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const lane C_3 =
        (1.0/2.0)*((L_a_3*L_a_3) - (l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z))/L_a_3;
    const lane S_3 = sigma_3*lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane t3 = 1.0/rho2_3;
    const lane c_3 = t3*(A_3*C_3 - B_3*S_3);
    const lane sn_3 = t3*(A_3*S_3 + B_3*C_3);
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const lane t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const lane t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const lane t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const lane t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const lane t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const lane t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const lane s_1_x = -L_a_1*d_1_x + r_1_x;
    const lane s_1_y = -L_a_1*d_1_y + r_1_y;
    const lane s_1_z = -L_a_1*d_1_z + r_1_z;
    const lane s_2_x = -L_a_2*d_2_x + r_2_x;
    const lane s_2_y = -L_a_2*d_2_y + r_2_y;
    const lane s_2_z = -L_a_2*d_2_z + r_2_z;
    const lane s_3_x = -L_a_3*d_3_x + r_3_x;
    const lane s_3_y = -L_a_3*d_3_y + r_3_y;
    const lane s_3_z = -L_a_3*d_3_z + r_3_z;
    const lane D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z;
    const lane D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z;
    const lane D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z;
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
    const lane t4 = 1.0/det_D_l;
    const lane t5 = D_r_1*t4;
    const lane D_p_x_1 = A_x_1*t5;
    const lane t6 = D_r_2*t4;
    const lane D_p_x_2 = A_x_2*t6;
    const lane t7 = D_r_3*t4;
    const lane D_p_x_3 = A_x_3*t7;
    const lane D_p_y_1 = A_y_1*t5;
    const lane D_p_y_2 = A_y_2*t6;
    const lane D_p_y_3 = A_y_3*t7;
    const lane D_p_z_1 = A_z_1*t5;
    const lane D_p_z_2 = A_z_2*t6;
    const lane D_p_z_3 = A_z_3*t7;
    const double t8 = (1.0/2.0)*m_d_3;
    const double t9 = (1.0/2.0)*m_d_1;
    const double t10 = (1.0/2.0)*m_d_2;
    const double t11 = m_p + t10 + t8 + t9;
    const double t12 = g_x*t11;
    const double t13 = g_y*t11;
    const double t14 = g_z*t11;
    const double t15 = L_a_1*t9 + m_a_1*r_a_1;
    const lane G_1 = -D_p_x_1*t12 - D_p_y_1*t13 - D_p_z_1*t14 - g_x*t15*t_1_x - g_y*t15*t_1_y - g_z*t15*t_1_z;
    const double t16 = L_a_2*t10 + m_a_2*r_a_2;
    const lane G_2 = -D_p_x_2*t12 - D_p_y_2*t13 - D_p_z_2*t14 - g_x*t16*t_2_x - g_y*t16*t_2_y - g_z*t16*t_2_z;
    const double t17 = L_a_3*t8 + m_a_3*r_a_3;
    const lane G_3 = -D_p_x_3*t12 - D_p_y_3*t13 - D_p_z_3*t14 - g_x*t17*t_3_x - g_y*t17*t_3_y - g_z*t17*t_3_z;
    const lane phi_1_st = G_1/k_r_1;
    const lane phi_2_st = G_2/k_r_2;
    const lane phi_3_st = G_3/k_r_3;
    const lane tau_st_1 = k_r_1*phi_1_st;
    const lane tau_st_2 = k_r_2*phi_2_st;
    const lane tau_st_3 = k_r_3*phi_3_st;
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
    theta_st[0] = LANES(phi_1_st);
    theta_st[1] = LANES(phi_2_st);
    theta_st[2] = LANES(phi_3_st);
    lanes_clear(H_el, 36);
    H_el[0] = LANES(k_r_1);
    H_el[3] = H_el[18] = LANES(-k_r_1);
    H_el[7] = LANES(k_r_2);
    H_el[10] = H_el[25] = LANES(-k_r_2);
    H_el[14] = LANES(k_r_3);
    H_el[17] = H_el[32] = LANES(-k_r_3);
    H_el[21] = LANES(k_r_1);
    H_el[28] = LANES(k_r_2);
    H_el[35] = LANES(k_r_3);
}

/* Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 376 operations; 138123 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double m_a_1 = parameters[43];
    const double m_a_2 = parameters[44];
    const double m_a_3 = parameters[45];
    const double r_a_1 = parameters[46];
    const double r_a_2 = parameters[47];
    const double r_a_3 = parameters[48];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double m_d_1 = parameters[55];
    const double m_d_2 = parameters[56];
    const double m_d_3 = parameters[57];
    const double k_r_1 = parameters[58];
    const double k_r_2 = parameters[59];
    const double k_r_3 = parameters[60];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double a_R_1 = effects[0];
    const double a_R_2 = effects[1];
    const double a_R_3 = effects[2];
    const double m_L = effects[6];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const lane C_1 =
        (1.0/2.0)*((L_a_1*L_a_1) - (l_d_1*l_d_1) + (r_1_x*r_1_x) + (r_1_y*r_1_y) + (r_1_z*r_1_z))/L_a_1;
    const lane S_1 = sigma_1*lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane t1 = 1.0/rho2_1;
    const lane c_1 = t1*(A_1*C_1 - B_1*S_1);
    const lane sn_1 = t1*(A_1*S_1 + B_1*C_1);
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const lane C_2 =
        (1.0/2.0)*((L_a_2*L_a_2) - (l_d_2*l_d_2) + (r_2_x*r_2_x) + (r_2_y*r_2_y) + (r_2_z*r_2_z))/L_a_2;
    const lane S_2 = sigma_2*lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane t2 = 1.0/rho2_2;
    const lane c_2 = t2*(A_2*C_2 - B_2*S_2);
    const lane sn_2 = t2*(A_2*S_2 + B_2*C_2);
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const lane C_3 =
        (1.0/2.0)*((L_a_3*L_a_3) - (l_d_3*l_d_3) + (r_3_x*r_3_x) + (r_3_y*r_3_y) + (r_3_z*r_3_z))/L_a_3;
    const lane S_3 = sigma_3*lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane t3 = 1.0/rho2_3;
    const lane c_3 = t3*(A_3*C_3 - B_3*S_3);
    const lane sn_3 = t3*(A_3*S_3 + B_3*C_3);
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const lane t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const lane t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const lane t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const lane t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const lane t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const lane t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const lane s_1_x = -L_a_1*d_1_x + r_1_x;
    const lane s_1_y = -L_a_1*d_1_y + r_1_y;
    const lane s_1_z = -L_a_1*d_1_z + r_1_z;
    const lane s_2_x = -L_a_2*d_2_x + r_2_x;
    const lane s_2_y = -L_a_2*d_2_y + r_2_y;
    const lane s_2_z = -L_a_2*d_2_z + r_2_z;
    const lane s_3_x = -L_a_3*d_3_x + r_3_x;
    const lane s_3_y = -L_a_3*d_3_y + r_3_y;
    const lane s_3_z = -L_a_3*d_3_z + r_3_z;
    const lane D_r_1 = L_a_1*s_1_x*t_1_x + L_a_1*s_1_y*t_1_y + L_a_1*s_1_z*t_1_z;
    const lane D_r_2 = L_a_2*s_2_x*t_2_x + L_a_2*s_2_y*t_2_y + L_a_2*s_2_z*t_2_z;
    const lane D_r_3 = L_a_3*s_3_x*t_3_x + L_a_3*s_3_y*t_3_y + L_a_3*s_3_z*t_3_z;
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
    const lane t4 = 1.0/det_D_l;
    const lane t5 = D_r_1*t4;
    const lane D_p_x_1 = A_x_1*t5;
    const lane t6 = D_r_2*t4;
    const lane D_p_x_2 = A_x_2*t6;
    const lane t7 = D_r_3*t4;
    const lane D_p_x_3 = A_x_3*t7;
    const lane D_p_y_1 = A_y_1*t5;
    const lane D_p_y_2 = A_y_2*t6;
    const lane D_p_y_3 = A_y_3*t7;
    const lane D_p_z_1 = A_z_1*t5;
    const lane D_p_z_2 = A_z_2*t6;
    const lane D_p_z_3 = A_z_3*t7;
    const double k_1 = k_r_1*(a_R_1 + 1.0);
    const double k_2 = k_r_2*(a_R_2 + 1.0);
    const double k_3 = k_r_3*(a_R_3 + 1.0);
    const double t8 = (1.0/2.0)*m_d_3;
    const double t9 = (1.0/2.0)*m_d_1;
    const double t10 = (1.0/2.0)*m_d_2;
    const double t11 = m_L + m_p + t10 + t8 + t9;
    const double t12 = g_x*t11;
    const double t13 = g_y*t11;
    const double t14 = g_z*t11;
    const double t15 = L_a_1*t9 + m_a_1*r_a_1;
    const lane G_1 = -D_p_x_1*t12 - D_p_y_1*t13 - D_p_z_1*t14 - g_x*t15*t_1_x - g_y*t15*t_1_y - g_z*t15*t_1_z;
    const double t16 = L_a_2*t10 + m_a_2*r_a_2;
    const lane G_2 = -D_p_x_2*t12 - D_p_y_2*t13 - D_p_z_2*t14 - g_x*t16*t_2_x - g_y*t16*t_2_y - g_z*t16*t_2_z;
    const double t17 = L_a_3*t8 + m_a_3*r_a_3;
    const lane G_3 = -D_p_x_3*t12 - D_p_y_3*t13 - D_p_z_3*t14 - g_x*t17*t_3_x - g_y*t17*t_3_y - g_z*t17*t_3_z;
    const lane phi_1_st = G_1/k_1;
    const lane phi_2_st = G_2/k_2;
    const lane phi_3_st = G_3/k_3;
    const lane tau_st_1 = k_1*phi_1_st;
    const lane tau_st_2 = k_2*phi_2_st;
    const lane tau_st_3 = k_3*phi_3_st;
    tau_st[0] = LANES(tau_st_1);
    tau_st[1] = LANES(tau_st_2);
    tau_st[2] = LANES(tau_st_3);
    theta_st[0] = LANES(phi_1_st);
    theta_st[1] = LANES(phi_2_st);
    theta_st[2] = LANES(phi_3_st);
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through base.
 * 1625 operations; 8260522340 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double m_a_1 = parameters[43];
    const double m_a_2 = parameters[44];
    const double m_a_3 = parameters[45];
    const double r_a_1 = parameters[46];
    const double r_a_2 = parameters[47];
    const double r_a_3 = parameters[48];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double m_d_1 = parameters[55];
    const double m_d_2 = parameters[56];
    const double m_d_3 = parameters[57];
    const double I_m_1 = parameters[61];
    const double I_m_2 = parameters[62];
    const double I_m_3 = parameters[63];
    const double i_g_1 = parameters[64];
    const double i_g_2 = parameters[65];
    const double i_g_3 = parameters[66];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const double forward_t1 = (L_a_1*L_a_1);
    const double forward_0 = 1.0/L_a_1;
    const lane t1 = (r_1_x*r_1_x);
    const lane t2 = (r_1_y*r_1_y);
    const lane t3 = (r_1_z*r_1_z);
    const double t4 = (l_d_1*l_d_1);
    const double t5 = (1.0/2.0)*forward_0;
    const lane C_1 = t5*(forward_t1 + t1 + t2 + t3 - t4);
    const lane forward_1 = lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane S_1 = forward_1*sigma_1;
    const lane forward_2 = 1.0/rho2_1;
    const lane t6 = A_1*C_1 - B_1*S_1;
    const lane c_1 = forward_2*t6;
    const lane t7 = A_1*S_1 + B_1*C_1;
    const lane sn_1 = forward_2*t7;
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const double forward_t3 = (L_a_2*L_a_2);
    const double forward_3 = 1.0/L_a_2;
    const lane t8 = (r_2_z*r_2_z);
    const double t9 = (l_d_2*l_d_2);
    const double t10 = (1.0/2.0)*forward_3;
    const lane t11 = (r_2_x*r_2_x);
    const lane t12 = (r_2_y*r_2_y);
    const lane C_2 = t10*(forward_t3 + t11 + t12 + t8 - t9);
    const lane forward_4 = lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane S_2 = forward_4*sigma_2;
    const lane forward_5 = 1.0/rho2_2;
    const lane t13 = A_2*C_2 - B_2*S_2;
    const lane c_2 = forward_5*t13;
    const lane t14 = A_2*S_2 + B_2*C_2;
    const lane sn_2 = forward_5*t14;
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const double forward_t5 = (L_a_3*L_a_3);
    const double forward_6 = 1.0/L_a_3;
    const lane t15 = (r_3_x*r_3_x);
    const lane t16 = (r_3_y*r_3_y);
    const lane t17 = (r_3_z*r_3_z);
    const double t18 = (l_d_3*l_d_3);
    const double t19 = (1.0/2.0)*forward_6;
    const lane C_3 = t19*(forward_t5 + t15 + t16 + t17 - t18);
    const lane forward_7 = lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane S_3 = forward_7*sigma_3;
    const lane forward_8 = 1.0/rho2_3;
    const lane t20 = A_3*C_3 - B_3*S_3;
    const lane c_3 = forward_8*t20;
    const lane t21 = A_3*S_3 + B_3*C_3;
    const lane sn_3 = forward_8*t21;
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const lane t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const lane t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const lane t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const lane t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const lane t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const lane t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const lane forward_t7 = L_a_1*d_1_x;
    const lane s_1_x = -forward_t7 + r_1_x;
    const lane forward_t8 = L_a_1*d_1_y;
    const lane s_1_y = -forward_t8 + r_1_y;
    const lane forward_t9 = L_a_1*d_1_z;
    const lane s_1_z = -forward_t9 + r_1_z;
    const lane forward_t10 = L_a_2*d_2_x;
    const lane s_2_x = -forward_t10 + r_2_x;
    const lane forward_t11 = L_a_2*d_2_y;
    const lane s_2_y = -forward_t11 + r_2_y;
    const lane forward_t12 = L_a_2*d_2_z;
    const lane s_2_z = -forward_t12 + r_2_z;
    const lane forward_t13 = L_a_3*d_3_x;
    const lane s_3_x = -forward_t13 + r_3_x;
    const lane forward_t14 = L_a_3*d_3_y;
    const lane s_3_y = -forward_t14 + r_3_y;
    const lane forward_t15 = L_a_3*d_3_z;
    const lane s_3_z = -forward_t15 + r_3_z;
    const lane forward_t16 = L_a_1*t_1_x;
    const lane forward_t17 = L_a_1*t_1_y;
    const lane forward_t18 = L_a_1*t_1_z;
    const lane D_r_1 = forward_t16*s_1_x + forward_t17*s_1_y + forward_t18*s_1_z;
    const lane forward_t19 = L_a_2*t_2_x;
    const lane forward_t20 = L_a_2*t_2_y;
    const lane forward_t21 = L_a_2*t_2_z;
    const lane D_r_2 = forward_t19*s_2_x + forward_t20*s_2_y + forward_t21*s_2_z;
    const lane forward_t22 = L_a_3*t_3_x;
    const lane forward_t23 = L_a_3*t_3_y;
    const lane forward_t24 = L_a_3*t_3_z;
    const lane D_r_3 = forward_t22*s_3_x + forward_t23*s_3_y + forward_t24*s_3_z;
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
    const lane forward_9 = 1.0/det_D_l;
    const lane forward_t26 = D_r_1*forward_9;
    const lane D_p_x_1 = A_x_1*forward_t26;
    const lane forward_t27 = D_r_2*forward_9;
    const lane D_p_x_2 = A_x_2*forward_t27;
    const lane forward_t28 = D_r_3*forward_9;
    const lane D_p_x_3 = A_x_3*forward_t28;
    const lane D_p_y_1 = A_y_1*forward_t26;
    const lane D_p_y_2 = A_y_2*forward_t27;
    const lane D_p_y_3 = A_y_3*forward_t28;
    const lane D_p_z_1 = A_z_1*forward_t26;
    const lane D_p_z_2 = A_z_2*forward_t27;
    const lane D_p_z_3 = A_z_3*forward_t28;
    const lane U_1_x_1 = D_p_x_1 - forward_t16;
    const lane U_1_y_1 = D_p_y_1 - forward_t17;
    const lane U_1_z_1 = D_p_z_1 - forward_t18;
    const lane U_2_x_2 = D_p_x_2 - forward_t19;
    const lane U_2_y_2 = D_p_y_2 - forward_t20;
    const lane U_2_z_2 = D_p_z_2 - forward_t21;
    const lane U_3_x_3 = D_p_x_3 - forward_t22;
    const lane U_3_y_3 = D_p_y_3 - forward_t23;
    const lane U_3_z_3 = D_p_z_3 - forward_t24;
    const double forward_t29 = (1.0/2.0)*m_d_1;
    const double forward_t30 = (1.0/2.0)*m_d_2;
    const double forward_t31 = (1.0/2.0)*m_d_3;
    const double forward_t32 = forward_t29 + forward_t30 + forward_t31 + m_p;
    const double forward_t33 = forward_t32*g_x;
    const double forward_t34 = forward_t32*g_y;
    const double forward_t35 = forward_t32*g_z;
    const lane t22 = -A_x_1*forward_t33 - A_y_1*forward_t34 - A_z_1*forward_t35;
    const lane mu_1 = forward_9*t22;
    const lane t23 = -A_x_2*forward_t33 - A_y_2*forward_t34 - A_z_2*forward_t35;
    const lane mu_2 = forward_9*t23;
    const lane t24 = -A_x_3*forward_t33 - A_y_3*forward_t34 - A_z_3*forward_t35;
    const lane mu_3 = forward_9*t24;
    const double forward_t36 = (1.0/3.0)*m_d_1;
    const double forward_t37 = (1.0/6.0)*m_d_1;
    const lane forward_t38 = forward_t16*forward_t37;
    const lane forward_t39 = forward_t17*forward_t37;
    const lane forward_t40 = forward_t18*forward_t37;
    const double forward_t41 = (1.0/3.0)*m_d_2;
    const double forward_t42 = (1.0/3.0)*m_d_3;
    const double forward_t43 = forward_t36 + forward_t41 + forward_t42 + m_p;
    const lane forward_t44 = D_p_x_1*forward_t43 + forward_t38;
    const lane forward_t45 = D_p_y_1*forward_t43 + forward_t39;
    const lane forward_t46 = D_p_z_1*forward_t43 + forward_t40;
    const double forward_t47 = (1.0/6.0)*m_d_2;
    const lane forward_t48 = forward_t19*forward_t47;
    const lane forward_t49 = forward_t20*forward_t47;
    const lane forward_t50 = forward_t21*forward_t47;
    const double forward_t51 = (1.0/6.0)*m_d_3;
    const lane forward_t52 = forward_t22*forward_t51;
    const lane forward_t53 = forward_t23*forward_t51;
    const lane forward_t54 = forward_t24*forward_t51;
    const lane forward_t55 = D_p_x_2*forward_t43 + forward_t48;
    const lane forward_t56 = D_p_y_2*forward_t43 + forward_t49;
    const lane forward_t57 = D_p_z_2*forward_t43 + forward_t50;
    const lane forward_t58 = (D_p_x_1*D_p_x_1);
    const lane forward_t59 = (D_p_y_1*D_p_y_1);
    const lane forward_t60 = (D_p_z_1*D_p_z_1);
    const double forward_t61 = L_a_1*forward_t29 + m_a_1*r_a_1;
    const lane forward_t62 = D_p_x_1*mu_3;
    const lane forward_t63 = D_p_x_1*mu_2;
    const lane forward_t64 = U_1_x_1*mu_1;
    const lane forward_t65 = D_p_y_1*mu_3;
    const lane forward_t66 = D_p_y_1*mu_2;
    const lane forward_t67 = U_1_y_1*mu_1;
    const lane forward_t68 = D_p_z_1*mu_3;
    const lane forward_t69 = D_p_z_1*mu_2;
    const lane forward_t70 = U_1_z_1*mu_1;
    const lane forward_t71 = (D_p_x_2*D_p_x_2);
    const lane forward_t72 = (D_p_y_2*D_p_y_2);
    const lane forward_t73 = (D_p_z_2*D_p_z_2);
    const double forward_t74 = L_a_2*forward_t30 + m_a_2*r_a_2;
    const lane forward_t75 = (D_p_x_3*D_p_x_3);
    const lane forward_t76 = (D_p_y_3*D_p_y_3);
    const lane forward_t77 = (D_p_z_3*D_p_z_3);
    const double forward_t78 = L_a_3*forward_t31 + m_a_3*r_a_3;
    const lane t27 = 2.0*D_p_z_2;
    const lane t30 = 2.0*D_p_z_3;
    const lane t36 = 2.0*D_p_y_2;
    const lane t38 = 2.0*D_p_y_3;
    const lane t40 = 2.0*D_p_x_2;
    const lane t42 = 2.0*D_p_x_3;
    const lane t51 = 2.0*D_p_z_1;
    const lane t54 = 2.0*D_p_y_1;
    const lane t55 = 2.0*D_p_x_1;
    const lane t73 = U_3_z_3*mu_3;
    const lane t75 = U_3_y_3*mu_3;
    const lane t76 = U_3_x_3*mu_3;
    const lane t78 = U_2_z_2*mu_2;
    const lane t80 = U_2_y_2*mu_2;
    const lane t81 = U_2_x_2*mu_2;
    const lane t85 = 2.0*forward_t54;
    const lane t88 = 2.0*forward_t53;
    const lane t89 = 2.0*forward_t52;
    const lane t96 = A_3*forward_8;
    const lane t97 = B_3*forward_8;
    const lane t100 = C_3*forward_8;
    const lane t101 = S_3*forward_8;
    const lane t102 = A_2*forward_5;
    const lane t103 = B_2*forward_5;
    const lane t106 = C_2*forward_5;
    const lane t107 = S_2*forward_5;
    const lane t108 = A_1*forward_2;
    const lane t109 = B_1*forward_2;
    const lane t112 = C_1*forward_2;
    const lane t113 = S_1*forward_2;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 6;
        const lane eigenvalue = eigenvalues[mode];
        lane *restrict gradient = gradients + mode * stride;
        const lane shape_1 = shape[0];
        const lane shape_2 = shape[1];
        const lane shape_3 = shape[2];
        const lane shape_4 = shape[3];
        const lane shape_5 = shape[4];
        const lane shape_6 = shape[5];
        const lane t25 = (shape_3*shape_3);
        const lane adjoint_forward_t78 = t25*(d_3_x*g_x + d_3_y*g_y + d_3_z*g_z);
        const lane adjoint_forward_t77 = t25*(-mu_1 - mu_2);
        const lane t26 = (shape_2*shape_2);
        const lane adjoint_forward_t74 = t26*(d_2_x*g_x + d_2_y*g_y + d_2_z*g_z);
        const lane adjoint_forward_t73 = t26*(-mu_1 - mu_3);
        const lane t28 = shape_1*shape_2;
        const lane t29 = t27*t28;
        const lane t31 = shape_1*shape_3;
        const lane t32 = t30*t31;
        const lane adjoint_forward_t70 = -t29 - t32;
        const lane t33 = 2.0*shape_1;
        const lane t34 = shape_2*t33;
        const lane adjoint_forward_t69 = -U_2_z_2*t34 - t32;
        const lane t35 = shape_3*t33;
        const lane adjoint_forward_t68 = -U_3_z_3*t35 - t29;
        const lane t37 = t28*t36;
        const lane t39 = t31*t38;
        const lane adjoint_forward_t67 = -t37 - t39;
        const lane adjoint_forward_t66 = -U_2_y_2*t34 - t39;
        const lane adjoint_forward_t65 = -U_3_y_3*t35 - t37;
        const lane t41 = t28*t40;
        const lane t43 = t31*t42;
        const lane adjoint_forward_t64 = -t41 - t43;
        const lane adjoint_forward_t63 = -U_2_x_2*t34 - t43;
        const lane adjoint_forward_t62 = -U_3_x_3*t35 - t41;
        const lane t44 = (shape_1*shape_1);
        const lane adjoint_forward_t61 = t44*(d_1_x*g_x + d_1_y*g_y + d_1_z*g_z);
        const lane adjoint_forward_t60 = t44*(-mu_2 - mu_3);
        const lane t45 = eigenvalue*t26;
        const lane t46 = D_p_z_2*t45;
        const lane t47 = shape_2*shape_3;
        const lane t48 = eigenvalue*t47;
        const lane adjoint_forward_t57 = -t30*t48 - t46;
        const lane t49 = D_p_y_2*t45;
        const lane adjoint_forward_t56 = -t38*t48 - t49;
        const lane t50 = D_p_x_2*t45;
        const lane adjoint_forward_t55 = -t42*t48 - t50;
        const lane t52 = eigenvalue*t31;
        const lane t53 = eigenvalue*t25;
        const lane adjoint_forward_t54 = -t27*t48 - t30*t53 - t51*t52;
        const lane adjoint_forward_t53 = -t36*t48 - t38*t53 - t52*t54;
        const lane adjoint_forward_t52 = -t40*t48 - t42*t53 - t52*t55;
        const lane adjoint_forward_t51 =
            adjoint_forward_t52*forward_t22 + adjoint_forward_t53*forward_t23
            + adjoint_forward_t54*forward_t24;
        const lane t56 = eigenvalue*t28;
        const lane adjoint_forward_t50 = adjoint_forward_t57 - t46 - t51*t56;
        const lane adjoint_forward_t49 = adjoint_forward_t56 - t49 - t54*t56;
        const lane adjoint_forward_t48 = adjoint_forward_t55 - t50 - t55*t56;
        const lane adjoint_forward_t47 =
            adjoint_forward_t48*forward_t19 + adjoint_forward_t49*forward_t20
            + adjoint_forward_t50*forward_t21;
        const lane t57 = eigenvalue*t44;
        const lane t58 = D_p_z_1*t57;
        const lane adjoint_forward_t46 = -eigenvalue*t29 - eigenvalue*t32 - t58;
        const lane t59 = D_p_y_1*t57;
        const lane adjoint_forward_t45 = -eigenvalue*t37 - eigenvalue*t39 - t59;
        const lane t60 = D_p_x_1*t57;
        const lane adjoint_forward_t44 = -eigenvalue*t41 - eigenvalue*t43 - t60;
        const lane adjoint_forward_t43 =
            D_p_x_1*adjoint_forward_t44 + D_p_x_2*adjoint_forward_t55 + D_p_y_1*adjoint_forward_t45
            + D_p_y_2*adjoint_forward_t56 + D_p_z_1*adjoint_forward_t46 + D_p_z_2*adjoint_forward_t57
            - t53*(forward_t75 + forward_t76 + forward_t77);
        const lane adjoint_forward_t42 = adjoint_forward_t43 - forward_t5*t53;
        const lane adjoint_forward_t41 = adjoint_forward_t43 - forward_t3*t45;
        const lane adjoint_forward_t40 = adjoint_forward_t46 - t58;
        const lane adjoint_forward_t39 = adjoint_forward_t45 - t59;
        const lane adjoint_forward_t38 = adjoint_forward_t44 - t60;
        const lane adjoint_forward_t37 =
            adjoint_forward_t38*forward_t16 + adjoint_forward_t39*forward_t17
            + adjoint_forward_t40*forward_t18;
        const lane adjoint_forward_t36 = adjoint_forward_t43 - forward_t1*t57;
        const lane t61 = t44*(-forward_t58 - forward_t59 - forward_t60);
        const lane t62 = t26*(-forward_t71 - forward_t72 - forward_t73);
        const lane t63 = 2.0*shape_2;
        const lane t64 = shape_3*t63;
        const lane adjoint_mu_3 =
            D_p_x_1*adjoint_forward_t62 + D_p_y_1*adjoint_forward_t65 + D_p_z_1*adjoint_forward_t68
            + t25*(-(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3) - forward_t13*s_3_x
            - forward_t14*s_3_y - forward_t15*s_3_z) + t61 + t62 + t64*(-D_p_x_2*U_3_x_3 - D_p_y_2*U_3_y_3
            - D_p_z_2*U_3_z_3);
        const lane t65 = t25*(-forward_t75 - forward_t76 - forward_t77);
        const lane adjoint_mu_2 =
            D_p_x_1*adjoint_forward_t63 + D_p_y_1*adjoint_forward_t66 + D_p_z_1*adjoint_forward_t69
            + t26*(-(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2) - forward_t10*s_2_x
            - forward_t11*s_2_y - forward_t12*s_2_z) + t61 + t64*(-D_p_x_3*U_2_x_2 - D_p_y_3*U_2_y_2
            - D_p_z_3*U_2_z_2) + t65;
        const lane adjoint_mu_1 =
            U_1_x_1*adjoint_forward_t64 + U_1_y_1*adjoint_forward_t67 + U_1_z_1*adjoint_forward_t70
            + t44*(-(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1) - forward_t7*s_1_x
            - forward_t8*s_1_y - forward_t9*s_1_z) + t62 + t64*(-D_p_x_2*D_p_x_3 - D_p_y_2*D_p_y_3
            - D_p_z_2*D_p_z_3) + t65;
        const lane t66 = adjoint_mu_1*forward_9;
        const lane t67 = adjoint_mu_2*forward_9;
        const lane t68 = adjoint_mu_3*forward_9;
        const lane adjoint_forward_t35 = -A_z_1*t66 - A_z_2*t67 - A_z_3*t68;
        const lane adjoint_forward_t34 = -A_y_1*t66 - A_y_2*t67 - A_y_3*t68;
        const lane adjoint_forward_t33 = -A_x_1*t66 - A_x_2*t67 - A_x_3*t68;
        const lane adjoint_forward_t32 =
            adjoint_forward_t33*g_x + adjoint_forward_t34*g_y + adjoint_forward_t35*g_z;
        const lane adjoint_forward_t31 = L_a_3*adjoint_forward_t78 + adjoint_forward_t32;
        const lane adjoint_forward_t30 = L_a_2*adjoint_forward_t74 + adjoint_forward_t32;
        const lane adjoint_forward_t29 = L_a_1*adjoint_forward_t61 + adjoint_forward_t32;
        const lane t69 = (shape_6*shape_6);
        const lane adjoint_I_3 = -eigenvalue*t69;
        const lane t70 = (shape_5*shape_5);
        const lane adjoint_I_2 = -eigenvalue*t70;
        const lane t71 = (shape_4*shape_4);
        const lane adjoint_I_1 = -eigenvalue*t71;
        const lane t72 = mu_3*t47;
        const lane t74 = 2.0*t25;
        const lane adjoint_U_3_z_3 = -forward_t68*t35 - t27*t72 - t73*t74;
        const lane adjoint_U_3_y_3 = -forward_t65*t35 - t36*t72 - t74*t75;
        const lane adjoint_U_3_x_3 = -forward_t62*t35 - t40*t72 - t74*t76;
        const lane t77 = mu_2*t47;
        const lane t79 = 2.0*t26;
        const lane adjoint_U_2_z_2 = -forward_t69*t34 - t30*t77 - t78*t79;
        const lane adjoint_U_2_y_2 = -forward_t66*t34 - t38*t77 - t79*t80;
        const lane adjoint_U_2_x_2 = -forward_t63*t34 - t42*t77 - t79*t81;
        const lane t82 = 2.0*t44;
        const lane adjoint_U_1_z_1 = adjoint_forward_t70*mu_1 - forward_t70*t82;
        const lane adjoint_U_1_y_1 = adjoint_forward_t67*mu_1 - forward_t67*t82;
        const lane adjoint_U_1_x_1 = adjoint_forward_t64*mu_1 - forward_t64*t82;
        const lane t83 = eigenvalue*forward_t46;
        const lane t84 = eigenvalue*t64;
        const lane adjoint_D_p_z_3 =
            adjoint_U_3_z_3 + adjoint_forward_t77*t30 - forward_t57*t84 - t35*t83 + t35*(-forward_t69
            - forward_t70) - t53*(forward_t43*t30 + t85) + t64*(-D_p_z_2*mu_1 - t78);
        const lane adjoint_D_p_z_2 =
            adjoint_U_2_z_2 + adjoint_forward_t57*forward_t43 + adjoint_forward_t73*t27 - t34*t83
            + t34*(-forward_t68 - forward_t70) - t45*(forward_t50 + forward_t57) - t48*t85
            + t64*(-D_p_z_3*mu_1 - t73);
        const lane t86 = eigenvalue*t34;
        const lane adjoint_D_p_z_1 =
            adjoint_U_1_z_1 + adjoint_forward_t46*forward_t43 + adjoint_forward_t60*t51
            + adjoint_forward_t68*mu_3 + adjoint_forward_t69*mu_2 - forward_t50*t86 - t52*t85
            - t57*(forward_t40 + forward_t46);
        const lane t87 = eigenvalue*t35;
        const lane adjoint_D_p_y_3 =
            adjoint_U_3_y_3 + adjoint_forward_t77*t38 - forward_t45*t87 - forward_t56*t84 + t35*(-forward_t66
            - forward_t67) - t53*(forward_t43*t38 + t88) + t64*(-D_p_y_2*mu_1 - t80);
        const lane adjoint_D_p_y_2 =
            adjoint_U_2_y_2 + adjoint_forward_t56*forward_t43 + adjoint_forward_t73*t36 - forward_t45*t86
            + t34*(-forward_t65 - forward_t67) - t45*(forward_t49 + forward_t56) - t48*t88
            + t64*(-D_p_y_3*mu_1 - t75);
        const lane adjoint_D_p_y_1 =
            adjoint_U_1_y_1 + adjoint_forward_t45*forward_t43 + adjoint_forward_t60*t54
            + adjoint_forward_t65*mu_3 + adjoint_forward_t66*mu_2 - forward_t49*t86 - t52*t88
            - t57*(forward_t39 + forward_t45);
        const lane adjoint_D_p_x_3 =
            adjoint_U_3_x_3 + adjoint_forward_t77*t42 - forward_t44*t87 - forward_t55*t84 + t35*(-forward_t63
            - forward_t64) - t53*(forward_t43*t42 + t89) + t64*(-D_p_x_2*mu_1 - t81);
        const lane adjoint_forward_t28 =
            A_x_3*adjoint_D_p_x_3 + A_y_3*adjoint_D_p_y_3 + A_z_3*adjoint_D_p_z_3;
        const lane adjoint_D_p_x_2 =
            adjoint_U_2_x_2 + adjoint_forward_t55*forward_t43 + adjoint_forward_t73*t40 - forward_t44*t86
            + t34*(-forward_t62 - forward_t64) - t45*(forward_t48 + forward_t55) - t48*t89
            + t64*(-D_p_x_3*mu_1 - t76);
        const lane adjoint_forward_t27 =
            A_x_2*adjoint_D_p_x_2 + A_y_2*adjoint_D_p_y_2 + A_z_2*adjoint_D_p_z_2;
        const lane adjoint_D_p_x_1 =
            adjoint_U_1_x_1 + adjoint_forward_t44*forward_t43 + adjoint_forward_t60*t55
            + adjoint_forward_t62*mu_3 + adjoint_forward_t63*mu_2 - forward_t48*t86 - t52*t89
            - t57*(forward_t38 + forward_t44);
        const lane adjoint_forward_t26 =
            A_x_1*adjoint_D_p_x_1 + A_y_1*adjoint_D_p_y_1 + A_z_1*adjoint_D_p_z_1;
        const lane adjoint_forward_t25 =
            D_r_1*adjoint_forward_t26 + D_r_2*adjoint_forward_t27 + D_r_3*adjoint_forward_t28
            + adjoint_mu_1*t22 + adjoint_mu_2*t23 + adjoint_mu_3*t24;
        const lane adjoint_det_D_l = -adjoint_forward_t25*(forward_9*forward_9);
        const lane adjoint_A_z_3 = adjoint_D_p_z_3*forward_t28 - forward_t35*t68;
        const lane adjoint_A_y_3 = adjoint_D_p_y_3*forward_t28 - forward_t34*t68;
        const lane adjoint_A_x_3 = adjoint_D_p_x_3*forward_t28 - forward_t33*t68;
        const lane adjoint_A_z_2 = adjoint_D_p_z_2*forward_t27 - forward_t35*t67;
        const lane adjoint_A_y_2 = adjoint_D_p_y_2*forward_t27 - forward_t34*t67;
        const lane adjoint_A_x_2 = adjoint_D_p_x_2*forward_t27 - forward_t33*t67;
        const lane adjoint_A_z_1 = adjoint_D_p_z_1*forward_t26 + adjoint_det_D_l*s_1_z - forward_t35*t66;
        const lane adjoint_A_y_1 = adjoint_D_p_y_1*forward_t26 + adjoint_det_D_l*s_1_y - forward_t34*t66;
        const lane adjoint_A_x_1 = adjoint_D_p_x_1*forward_t26 + adjoint_det_D_l*s_1_x - forward_t33*t66;
        const lane adjoint_D_r_3 = adjoint_forward_t28*forward_9;
        const lane adjoint_forward_t24 =
            adjoint_D_r_3*s_3_z - adjoint_U_3_z_3 + adjoint_forward_t54*forward_t51;
        const lane adjoint_forward_t23 =
            adjoint_D_r_3*s_3_y - adjoint_U_3_y_3 + adjoint_forward_t53*forward_t51;
        const lane adjoint_forward_t22 =
            adjoint_D_r_3*s_3_x - adjoint_U_3_x_3 + adjoint_forward_t52*forward_t51;
        const lane adjoint_D_r_2 = adjoint_forward_t27*forward_9;
        const lane adjoint_forward_t21 =
            adjoint_D_r_2*s_2_z - adjoint_U_2_z_2 + adjoint_forward_t50*forward_t47;
        const lane adjoint_forward_t20 =
            adjoint_D_r_2*s_2_y - adjoint_U_2_y_2 + adjoint_forward_t49*forward_t47;
        const lane adjoint_forward_t19 =
            adjoint_D_r_2*s_2_x - adjoint_U_2_x_2 + adjoint_forward_t48*forward_t47;
        const lane adjoint_D_r_1 = adjoint_forward_t26*forward_9;
        const lane adjoint_forward_t18 =
            adjoint_D_r_1*s_1_z - adjoint_U_1_z_1 + adjoint_forward_t40*forward_t37;
        const lane adjoint_forward_t17 =
            adjoint_D_r_1*s_1_y - adjoint_U_1_y_1 + adjoint_forward_t39*forward_t37;
        const lane adjoint_forward_t16 =
            adjoint_D_r_1*s_1_x - adjoint_U_1_x_1 + adjoint_forward_t38*forward_t37;
        const lane t90 = mu_3*t25;
        const lane adjoint_s_3_z =
            adjoint_A_x_1*s_2_y - adjoint_A_x_2*s_1_y - adjoint_A_y_1*s_2_x + adjoint_A_y_2*s_1_x
            + adjoint_D_r_3*forward_t24 - forward_t15*t90;
        const lane adjoint_forward_t15 = -adjoint_s_3_z - s_3_z*t90;
        const lane adjoint_s_3_y =
            -adjoint_A_x_1*s_2_z + adjoint_A_x_2*s_1_z + adjoint_A_z_1*s_2_x - adjoint_A_z_2*s_1_x
            + adjoint_D_r_3*forward_t23 - forward_t14*t90;
        const lane adjoint_forward_t14 = -adjoint_s_3_y - s_3_y*t90;
        const lane adjoint_s_3_x =
            adjoint_A_y_1*s_2_z - adjoint_A_y_2*s_1_z - adjoint_A_z_1*s_2_y + adjoint_A_z_2*s_1_y
            + adjoint_D_r_3*forward_t22 - forward_t13*t90;
        const lane adjoint_forward_t13 = -adjoint_s_3_x - s_3_x*t90;
        const lane t91 = mu_2*t26;
        const lane adjoint_s_2_z =
            -adjoint_A_x_1*s_3_y + adjoint_A_x_3*s_1_y + adjoint_A_y_1*s_3_x - adjoint_A_y_3*s_1_x
            + adjoint_D_r_2*forward_t21 - forward_t12*t91;
        const lane adjoint_forward_t12 = -adjoint_s_2_z - s_2_z*t91;
        const lane adjoint_s_2_y =
            adjoint_A_x_1*s_3_z - adjoint_A_x_3*s_1_z - adjoint_A_z_1*s_3_x + adjoint_A_z_3*s_1_x
            + adjoint_D_r_2*forward_t20 - forward_t11*t91;
        const lane adjoint_forward_t11 = -adjoint_s_2_y - s_2_y*t91;
        const lane adjoint_s_2_x =
            -adjoint_A_y_1*s_3_z + adjoint_A_y_3*s_1_z + adjoint_A_z_1*s_3_y - adjoint_A_z_3*s_1_y
            + adjoint_D_r_2*forward_t19 - forward_t10*t91;
        const lane adjoint_forward_t10 = -adjoint_s_2_x - s_2_x*t91;
        const lane t92 = mu_1*t44;
        const lane adjoint_s_1_z =
            A_z_1*adjoint_det_D_l + adjoint_A_x_2*s_3_y - adjoint_A_x_3*s_2_y - adjoint_A_y_2*s_3_x
            + adjoint_A_y_3*s_2_x + adjoint_D_r_1*forward_t18 - forward_t9*t92;
        const lane adjoint_forward_t9 = -adjoint_s_1_z - s_1_z*t92;
        const lane adjoint_s_1_y =
            A_y_1*adjoint_det_D_l - adjoint_A_x_2*s_3_z + adjoint_A_x_3*s_2_z + adjoint_A_z_2*s_3_x
            - adjoint_A_z_3*s_2_x + adjoint_D_r_1*forward_t17 - forward_t8*t92;
        const lane adjoint_forward_t8 = -adjoint_s_1_y - s_1_y*t92;
        const lane adjoint_s_1_x =
            A_x_1*adjoint_det_D_l + adjoint_A_y_2*s_3_z - adjoint_A_y_3*s_2_z - adjoint_A_z_2*s_3_y
            + adjoint_A_z_3*s_2_y + adjoint_D_r_1*forward_t16 - forward_t7*t92;
        const lane adjoint_forward_t7 = -adjoint_s_1_x - s_1_x*t92;
        const lane adjoint_t_3_z = L_a_3*adjoint_forward_t24;
        const lane adjoint_t_3_y = L_a_3*adjoint_forward_t23;
        const lane adjoint_t_3_x = L_a_3*adjoint_forward_t22;
        const lane t93 = forward_t78*t25;
        const lane adjoint_d_3_z = L_a_3*adjoint_forward_t15 + g_z*t93;
        const lane adjoint_d_3_y = L_a_3*adjoint_forward_t14 + g_y*t93;
        const lane adjoint_d_3_x = L_a_3*adjoint_forward_t13 + g_x*t93;
        const lane adjoint_t_2_z = L_a_2*adjoint_forward_t21;
        const lane adjoint_t_2_y = L_a_2*adjoint_forward_t20;
        const lane adjoint_t_2_x = L_a_2*adjoint_forward_t19;
        const lane t94 = forward_t74*t26;
        const lane adjoint_d_2_z = L_a_2*adjoint_forward_t12 + g_z*t94;
        const lane adjoint_d_2_y = L_a_2*adjoint_forward_t11 + g_y*t94;
        const lane adjoint_d_2_x = L_a_2*adjoint_forward_t10 + g_x*t94;
        const lane adjoint_t_1_z = L_a_1*adjoint_forward_t18;
        const lane adjoint_t_1_y = L_a_1*adjoint_forward_t17;
        const lane adjoint_t_1_x = L_a_1*adjoint_forward_t16;
        const lane t95 = forward_t61*t44;
        const lane adjoint_d_1_z = L_a_1*adjoint_forward_t9 + g_z*t95;
        const lane adjoint_d_1_y = L_a_1*adjoint_forward_t8 + g_y*t95;
        const lane adjoint_d_1_x = L_a_1*adjoint_forward_t7 + g_x*t95;
        const lane adjoint_sn_3 =
            adjoint_d_3_x*y_3_x + adjoint_d_3_y*y_3_y + adjoint_d_3_z*y_3_z - adjoint_t_3_x*z_3_x
            - adjoint_t_3_y*z_3_y - adjoint_t_3_z*z_3_z;
        const lane adjoint_c_3 =
            adjoint_d_3_x*z_3_x + adjoint_d_3_y*z_3_y + adjoint_d_3_z*z_3_z + adjoint_t_3_x*y_3_x
            + adjoint_t_3_y*y_3_y + adjoint_t_3_z*y_3_z;
        const lane adjoint_forward_t6 = adjoint_c_3*t20 + adjoint_sn_3*t21;
        const lane adjoint_S_3 = -adjoint_c_3*t97 + adjoint_sn_3*t96;
        const lane adjoint_forward_7 = adjoint_S_3*sigma_3;
        const lane t98 = adjoint_forward_7/forward_7;
        const lane adjoint_C_3 = -C_3*t98 + adjoint_c_3*t96 + adjoint_sn_3*t97;
        const lane adjoint_forward_6 =
            adjoint_C_3*((1.0/2.0)*forward_t5 + (1.0/2.0)*t15 + (1.0/2.0)*t16 + (1.0/2.0)*t17 - 1.0/2.0*t18);
        const lane adjoint_forward_t5 = adjoint_C_3*t19 - forward_t42*t53;
        const lane adjoint_rho2_3 = -adjoint_forward_t6*(forward_8*forward_8) + (1.0/2.0)*t98;
        const lane t99 = 2.0*adjoint_rho2_3;
        const lane adjoint_B_3 = B_3*t99 - adjoint_c_3*t101 + adjoint_sn_3*t100;
        const lane adjoint_A_3 = A_3*t99 + adjoint_c_3*t100 + adjoint_sn_3*t101;
        const lane adjoint_sn_2 =
            adjoint_d_2_x*y_2_x + adjoint_d_2_y*y_2_y + adjoint_d_2_z*y_2_z - adjoint_t_2_x*z_2_x
            - adjoint_t_2_y*z_2_y - adjoint_t_2_z*z_2_z;
        const lane adjoint_c_2 =
            adjoint_d_2_x*z_2_x + adjoint_d_2_y*z_2_y + adjoint_d_2_z*z_2_z + adjoint_t_2_x*y_2_x
            + adjoint_t_2_y*y_2_y + adjoint_t_2_z*y_2_z;
        const lane adjoint_forward_t4 = adjoint_c_2*t13 + adjoint_sn_2*t14;
        const lane adjoint_S_2 = -adjoint_c_2*t103 + adjoint_sn_2*t102;
        const lane adjoint_forward_4 = adjoint_S_2*sigma_2;
        const lane t104 = adjoint_forward_4/forward_4;
        const lane adjoint_C_2 = -C_2*t104 + adjoint_c_2*t102 + adjoint_sn_2*t103;
        const lane adjoint_forward_3 =
            adjoint_C_2*((1.0/2.0)*forward_t3 + (1.0/2.0)*t11 + (1.0/2.0)*t12 + (1.0/2.0)*t8 - 1.0/2.0*t9);
        const lane adjoint_forward_t3 = adjoint_C_2*t10 - forward_t41*t45;
        const lane adjoint_rho2_2 = -adjoint_forward_t4*(forward_5*forward_5) + (1.0/2.0)*t104;
        const lane t105 = 2.0*adjoint_rho2_2;
        const lane adjoint_B_2 = B_2*t105 - adjoint_c_2*t107 + adjoint_sn_2*t106;
        const lane adjoint_A_2 = A_2*t105 + adjoint_c_2*t106 + adjoint_sn_2*t107;
        const lane adjoint_sn_1 =
            adjoint_d_1_x*y_1_x + adjoint_d_1_y*y_1_y + adjoint_d_1_z*y_1_z - adjoint_t_1_x*z_1_x
            - adjoint_t_1_y*z_1_y - adjoint_t_1_z*z_1_z;
        const lane adjoint_c_1 =
            adjoint_d_1_x*z_1_x + adjoint_d_1_y*z_1_y + adjoint_d_1_z*z_1_z + adjoint_t_1_x*y_1_x
            + adjoint_t_1_y*y_1_y + adjoint_t_1_z*y_1_z;
        const lane adjoint_forward_t2 = adjoint_c_1*t6 + adjoint_sn_1*t7;
        const lane adjoint_S_1 = -adjoint_c_1*t109 + adjoint_sn_1*t108;
        const lane adjoint_forward_1 = adjoint_S_1*sigma_1;
        const lane t110 = adjoint_forward_1/forward_1;
        const lane adjoint_C_1 = -C_1*t110 + adjoint_c_1*t108 + adjoint_sn_1*t109;
        const lane adjoint_forward_0 =
            adjoint_C_1*((1.0/2.0)*forward_t1 + (1.0/2.0)*t1 + (1.0/2.0)*t2 + (1.0/2.0)*t3 - 1.0/2.0*t4);
        const lane adjoint_forward_t1 = adjoint_C_1*t5 - forward_t36*t57;
        const lane adjoint_rho2_1 = -adjoint_forward_t2*(forward_2*forward_2) + (1.0/2.0)*t110;
        const lane t111 = 2.0*adjoint_rho2_1;
        const lane adjoint_B_1 = B_1*t111 - adjoint_c_1*t113 + adjoint_sn_1*t112;
        const lane adjoint_A_1 = A_1*t111 + adjoint_c_1*t112 + adjoint_sn_1*t113;
        const lane t114 = adjoint_C_3*forward_6;
        const lane adjoint_r_3_z = adjoint_A_3*z_3_z + adjoint_B_3*y_3_z + adjoint_s_3_z + r_3_z*t114;
        const lane adjoint_r_3_y = adjoint_A_3*z_3_y + adjoint_B_3*y_3_y + adjoint_s_3_y + r_3_y*t114;
        const lane adjoint_r_3_x = adjoint_A_3*z_3_x + adjoint_B_3*y_3_x + adjoint_s_3_x + r_3_x*t114;
        const lane t115 = adjoint_C_2*forward_3;
        const lane adjoint_r_2_z = adjoint_A_2*z_2_z + adjoint_B_2*y_2_z + adjoint_s_2_z + r_2_z*t115;
        const lane adjoint_r_2_y = adjoint_A_2*z_2_y + adjoint_B_2*y_2_y + adjoint_s_2_y + r_2_y*t115;
        const lane adjoint_r_2_x = adjoint_A_2*z_2_x + adjoint_B_2*y_2_x + adjoint_s_2_x + r_2_x*t115;
        const lane t116 = adjoint_C_1*forward_0;
        const lane adjoint_r_1_z = adjoint_A_1*z_1_z + adjoint_B_1*y_1_z + adjoint_s_1_z + r_1_z*t116;
        const lane adjoint_r_1_y = adjoint_A_1*z_1_y + adjoint_B_1*y_1_y + adjoint_s_1_y + r_1_y*t116;
        const lane adjoint_r_1_x = adjoint_A_1*z_1_x + adjoint_B_1*y_1_x + adjoint_s_1_x + r_1_x*t116;
        lanes_clear(gradient, 94);
        gradient[0] = LANES(adjoint_forward_t32 + adjoint_forward_t43);
        gradient[1] = LANES(adjoint_forward_t33*forward_t32 + d_1_x*t95 + d_2_x*t94 + d_3_x*t93);
        gradient[2] = LANES(adjoint_forward_t34*forward_t32 + d_1_y*t95 + d_2_y*t94 + d_3_y*t93);
        gradient[3] = LANES(adjoint_forward_t35*forward_t32 + d_1_z*t95 + d_2_z*t94 + d_3_z*t93);
        gradient[4] = LANES(-adjoint_r_1_x);
        gradient[5] = LANES(-adjoint_r_1_y);
        gradient[6] = LANES(-adjoint_r_1_z);
        gradient[7] = LANES(-adjoint_r_2_x);
        gradient[8] = LANES(-adjoint_r_2_y);
        gradient[9] = LANES(-adjoint_r_2_z);
        gradient[10] = LANES(-adjoint_r_3_x);
        gradient[11] = LANES(-adjoint_r_3_y);
        gradient[12] = LANES(-adjoint_r_3_z);
        gradient[31] = LANES(adjoint_r_1_x);
        gradient[32] = LANES(adjoint_r_1_y);
        gradient[33] = LANES(adjoint_r_1_z);
        gradient[34] = LANES(adjoint_r_2_x);
        gradient[35] = LANES(adjoint_r_2_y);
        gradient[36] = LANES(adjoint_r_2_z);
        gradient[37] = LANES(adjoint_r_3_x);
        gradient[38] = LANES(adjoint_r_3_y);
        gradient[39] = LANES(adjoint_r_3_z);
        gradient[40] =
            LANES(2.0*L_a_1*adjoint_forward_t1 - adjoint_forward_0*(forward_0*forward_0)
            + adjoint_forward_t16*t_1_x + adjoint_forward_t17*t_1_y + adjoint_forward_t18*t_1_z
            + adjoint_forward_t61*forward_t29 + adjoint_forward_t7*d_1_x + adjoint_forward_t8*d_1_y
            + adjoint_forward_t9*d_1_z);
        gradient[41] =
            LANES(2.0*L_a_2*adjoint_forward_t3 - adjoint_forward_3*(forward_3*forward_3)
            + adjoint_forward_t10*d_2_x + adjoint_forward_t11*d_2_y + adjoint_forward_t12*d_2_z
            + adjoint_forward_t19*t_2_x + adjoint_forward_t20*t_2_y + adjoint_forward_t21*t_2_z
            + adjoint_forward_t74*forward_t30);
        gradient[42] =
            LANES(2.0*L_a_3*adjoint_forward_t5 - adjoint_forward_6*(forward_6*forward_6)
            + adjoint_forward_t13*d_3_x + adjoint_forward_t14*d_3_y + adjoint_forward_t15*d_3_z
            + adjoint_forward_t22*t_3_x + adjoint_forward_t23*t_3_y + adjoint_forward_t24*t_3_z
            + adjoint_forward_t78*forward_t31);
        gradient[43] = LANES(adjoint_forward_t61*r_a_1);
        gradient[44] = LANES(adjoint_forward_t74*r_a_2);
        gradient[45] = LANES(adjoint_forward_t78*r_a_3);
        gradient[46] = LANES(adjoint_forward_t61*m_a_1);
        gradient[47] = LANES(adjoint_forward_t74*m_a_2);
        gradient[48] = LANES(adjoint_forward_t78*m_a_3);
        gradient[49] = LANES(-t57);
        gradient[50] = LANES(-t45);
        gradient[51] = LANES(-t53);
        gradient[52] = LANES(-l_d_1*t116);
        gradient[53] = LANES(-l_d_2*t115);
        gradient[54] = LANES(-l_d_3*t114);
        gradient[55] =
            LANES((1.0/2.0)*adjoint_forward_t29 + (1.0/3.0)*adjoint_forward_t36
            + (1.0/6.0)*adjoint_forward_t37);
        gradient[56] =
            LANES((1.0/2.0)*adjoint_forward_t30 + (1.0/3.0)*adjoint_forward_t41
            + (1.0/6.0)*adjoint_forward_t47);
        gradient[57] =
            LANES((1.0/2.0)*adjoint_forward_t31 + (1.0/3.0)*adjoint_forward_t42
            + (1.0/6.0)*adjoint_forward_t51);
        gradient[58] = LANES(-shape_4*t33 + t44 + t71);
        gradient[59] = LANES(-shape_5*t63 + t26 + t70);
        gradient[60] = LANES(-2.0*shape_3*shape_6 + t25 + t69);
        gradient[61] = LANES(adjoint_I_1*(i_g_1*i_g_1));
        gradient[62] = LANES(adjoint_I_2*(i_g_2*i_g_2));
        gradient[63] = LANES(adjoint_I_3*(i_g_3*i_g_3));
        gradient[64] = LANES(2.0*I_m_1*adjoint_I_1*i_g_1);
        gradient[65] = LANES(2.0*I_m_2*adjoint_I_2*i_g_2);
        gradient[66] = LANES(2.0*I_m_3*adjoint_I_3*i_g_3);
        gradient[91] = LANES(adjoint_r_1_x + adjoint_r_2_x + adjoint_r_3_x);
        gradient[92] = LANES(adjoint_r_1_y + adjoint_r_2_y + adjoint_r_3_y);
        gradient[93] = LANES(adjoint_r_1_z + adjoint_r_2_z + adjoint_r_3_z);
    }
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through extended.
 * 2782 operations; 25328245548 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double m_a_1 = parameters[43];
    const double m_a_2 = parameters[44];
    const double m_a_3 = parameters[45];
    const double r_a_1 = parameters[46];
    const double r_a_2 = parameters[47];
    const double r_a_3 = parameters[48];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double m_d_1 = parameters[55];
    const double m_d_2 = parameters[56];
    const double m_d_3 = parameters[57];
    const double k_r_1 = parameters[58];
    const double k_r_2 = parameters[59];
    const double k_r_3 = parameters[60];
    const double I_m_1 = parameters[61];
    const double I_m_2 = parameters[62];
    const double I_m_3 = parameters[63];
    const double i_g_1 = parameters[64];
    const double i_g_2 = parameters[65];
    const double i_g_3 = parameters[66];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double a_R_1 = effects[0];
    const double a_R_2 = effects[1];
    const double a_R_3 = effects[2];
    const double k_C = effects[3];
    const double m_L = effects[6];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const double forward_t1 = (L_a_1*L_a_1);
    const double forward_0 = 1.0/L_a_1;
    const lane t1 = (r_1_x*r_1_x);
    const lane t2 = (r_1_y*r_1_y);
    const lane t3 = (r_1_z*r_1_z);
    const double t4 = (l_d_1*l_d_1);
    const double t5 = (1.0/2.0)*forward_0;
    const lane C_1 = t5*(forward_t1 + t1 + t2 + t3 - t4);
    const lane forward_1 = lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane S_1 = forward_1*sigma_1;
    const lane forward_2 = 1.0/rho2_1;
    const lane t6 = A_1*C_1 - B_1*S_1;
    const lane c_1 = forward_2*t6;
    const lane t7 = A_1*S_1 + B_1*C_1;
    const lane sn_1 = forward_2*t7;
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const double forward_t3 = (L_a_2*L_a_2);
    const double forward_3 = 1.0/L_a_2;
    const lane t8 = (r_2_z*r_2_z);
    const double t9 = (l_d_2*l_d_2);
    const double t10 = (1.0/2.0)*forward_3;
    const lane t11 = (r_2_x*r_2_x);
    const lane t12 = (r_2_y*r_2_y);
    const lane C_2 = t10*(forward_t3 + t11 + t12 + t8 - t9);
    const lane forward_4 = lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane S_2 = forward_4*sigma_2;
    const lane forward_5 = 1.0/rho2_2;
    const lane t13 = A_2*C_2 - B_2*S_2;
    const lane c_2 = forward_5*t13;
    const lane t14 = A_2*S_2 + B_2*C_2;
    const lane sn_2 = forward_5*t14;
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const double forward_t5 = (L_a_3*L_a_3);
    const double forward_6 = 1.0/L_a_3;
    const lane t15 = (r_3_x*r_3_x);
    const lane t16 = (r_3_y*r_3_y);
    const lane t17 = (r_3_z*r_3_z);
    const double t18 = (l_d_3*l_d_3);
    const double t19 = (1.0/2.0)*forward_6;
    const lane C_3 = t19*(forward_t5 + t15 + t16 + t17 - t18);
    const lane forward_7 = lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane S_3 = forward_7*sigma_3;
    const lane forward_8 = 1.0/rho2_3;
    const lane t20 = A_3*C_3 - B_3*S_3;
    const lane c_3 = forward_8*t20;
    const lane t21 = A_3*S_3 + B_3*C_3;
    const lane sn_3 = forward_8*t21;
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const lane t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const lane t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const lane t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const lane t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const lane t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const lane t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const lane forward_t7 = L_a_1*d_1_x;
    const lane s_1_x = -forward_t7 + r_1_x;
    const lane forward_t8 = L_a_1*d_1_y;
    const lane s_1_y = -forward_t8 + r_1_y;
    const lane forward_t9 = L_a_1*d_1_z;
    const lane s_1_z = -forward_t9 + r_1_z;
    const lane forward_t10 = L_a_2*d_2_x;
    const lane s_2_x = -forward_t10 + r_2_x;
    const lane forward_t11 = L_a_2*d_2_y;
    const lane s_2_y = -forward_t11 + r_2_y;
    const lane forward_t12 = L_a_2*d_2_z;
    const lane s_2_z = -forward_t12 + r_2_z;
    const lane forward_t13 = L_a_3*d_3_x;
    const lane s_3_x = -forward_t13 + r_3_x;
    const lane forward_t14 = L_a_3*d_3_y;
    const lane s_3_y = -forward_t14 + r_3_y;
    const lane forward_t15 = L_a_3*d_3_z;
    const lane s_3_z = -forward_t15 + r_3_z;
    const lane forward_t16 = L_a_1*t_1_x;
    const lane forward_t17 = L_a_1*t_1_y;
    const lane forward_t18 = L_a_1*t_1_z;
    const lane D_r_1 = forward_t16*s_1_x + forward_t17*s_1_y + forward_t18*s_1_z;
    const lane forward_t19 = L_a_2*t_2_x;
    const lane forward_t20 = L_a_2*t_2_y;
    const lane forward_t21 = L_a_2*t_2_z;
    const lane D_r_2 = forward_t19*s_2_x + forward_t20*s_2_y + forward_t21*s_2_z;
    const lane forward_t22 = L_a_3*t_3_x;
    const lane forward_t23 = L_a_3*t_3_y;
    const lane forward_t24 = L_a_3*t_3_z;
    const lane D_r_3 = forward_t22*s_3_x + forward_t23*s_3_y + forward_t24*s_3_z;
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
    const lane forward_9 = 1.0/det_D_l;
    const lane forward_t26 = A_x_1*forward_9;
    const lane D_p_x_1 = D_r_1*forward_t26;
    const lane forward_t27 = A_x_2*forward_9;
    const lane D_p_x_2 = D_r_2*forward_t27;
    const lane forward_t28 = A_x_3*forward_9;
    const lane D_p_x_3 = D_r_3*forward_t28;
    const lane D_delta_x_1 = forward_t26*l_d_1;
    const lane D_delta_x_2 = forward_t27*l_d_2;
    const lane D_delta_x_3 = forward_t28*l_d_3;
    const lane forward_t29 = A_y_1*forward_9;
    const lane D_p_y_1 = D_r_1*forward_t29;
    const lane forward_t30 = A_y_2*forward_9;
    const lane D_p_y_2 = D_r_2*forward_t30;
    const lane forward_t31 = A_y_3*forward_9;
    const lane D_p_y_3 = D_r_3*forward_t31;
    const lane D_delta_y_1 = forward_t29*l_d_1;
    const lane D_delta_y_2 = forward_t30*l_d_2;
    const lane D_delta_y_3 = forward_t31*l_d_3;
    const lane forward_t32 = A_z_1*forward_9;
    const lane D_p_z_1 = D_r_1*forward_t32;
    const lane forward_t33 = A_z_2*forward_9;
    const lane D_p_z_2 = D_r_2*forward_t33;
    const lane forward_t34 = A_z_3*forward_9;
    const lane D_p_z_3 = D_r_3*forward_t34;
    const lane D_delta_z_1 = forward_t32*l_d_1;
    const lane D_delta_z_2 = forward_t33*l_d_2;
    const lane D_delta_z_3 = forward_t34*l_d_3;
    const lane U_1_x_1 = D_p_x_1 - forward_t16;
    const lane U_1_y_1 = D_p_y_1 - forward_t17;
    const lane U_1_z_1 = D_p_z_1 - forward_t18;
    const lane U_2_x_2 = D_p_x_2 - forward_t19;
    const lane U_2_y_2 = D_p_y_2 - forward_t20;
    const lane U_2_z_2 = D_p_z_2 - forward_t21;
    const lane U_3_x_3 = D_p_x_3 - forward_t22;
    const lane U_3_y_3 = D_p_y_3 - forward_t23;
    const lane U_3_z_3 = D_p_z_3 - forward_t24;
    const double forward_t35 = (1.0/2.0)*m_d_1;
    const double forward_t36 = (1.0/2.0)*m_d_2;
    const double forward_t37 = (1.0/2.0)*m_d_3;
    const double forward_t38 = m_L + m_p;
    const double forward_t39 = forward_t35 + forward_t36 + forward_t37 + forward_t38;
    const double forward_t40 = forward_t39*g_x;
    const double forward_t41 = forward_t39*g_y;
    const double forward_t42 = forward_t39*g_z;
    const lane t22 = -A_x_1*forward_t40 - A_y_1*forward_t41 - A_z_1*forward_t42;
    const lane mu_1 = forward_9*t22;
    const lane t23 = -A_x_2*forward_t40 - A_y_2*forward_t41 - A_z_2*forward_t42;
    const lane mu_2 = forward_9*t23;
    const lane t24 = -A_x_3*forward_t40 - A_y_3*forward_t41 - A_z_3*forward_t42;
    const lane mu_3 = forward_9*t24;
    const double forward_t43 = (1.0/3.0)*m_d_1;
    const double forward_t44 = (1.0/6.0)*m_d_1;
    const lane forward_t45 = forward_t16*forward_t44;
    const lane forward_t46 = forward_t17*forward_t44;
    const lane forward_t47 = forward_t18*forward_t44;
    const double forward_t48 = (1.0/3.0)*m_d_2;
    const double forward_t49 = (1.0/3.0)*m_d_3;
    const double forward_t50 = forward_t38 + forward_t43 + forward_t48 + forward_t49;
    const lane forward_t51 = D_p_x_1*forward_t50;
    const lane forward_t52 = forward_t45 + forward_t51;
    const lane forward_t53 = D_p_y_1*forward_t50;
    const lane forward_t54 = forward_t46 + forward_t53;
    const lane forward_t55 = D_p_z_1*forward_t50;
    const lane forward_t56 = forward_t47 + forward_t55;
    const double forward_t57 = (1.0/6.0)*m_d_2;
    const lane forward_t58 = forward_t19*forward_t57;
    const lane forward_t59 = forward_t20*forward_t57;
    const lane forward_t60 = forward_t21*forward_t57;
    const double forward_t61 = (1.0/6.0)*m_d_3;
    const lane forward_t62 = forward_t22*forward_t61;
    const lane forward_t63 = forward_t23*forward_t61;
    const lane forward_t64 = forward_t24*forward_t61;
    const double forward_t65 = m_a_1*r_a_1;
    const double forward_t66 = forward_t44 + forward_t57 + forward_t61;
    const lane forward_t67 = D_p_x_2*forward_t50;
    const lane forward_t68 = forward_t58 + forward_t67;
    const lane forward_t69 = D_p_y_2*forward_t50;
    const lane forward_t70 = forward_t59 + forward_t69;
    const lane forward_t71 = D_p_z_2*forward_t50;
    const lane forward_t72 = forward_t60 + forward_t71;
    const double forward_t73 = m_a_2*r_a_2;
    const lane forward_t74 = D_p_x_3*forward_t50;
    const lane forward_t75 = forward_t62 + forward_t74;
    const lane forward_t76 = D_p_y_3*forward_t50;
    const lane forward_t77 = forward_t63 + forward_t76;
    const lane forward_t78 = D_p_z_3*forward_t50;
    const lane forward_t79 = forward_t64 + forward_t78;
    const double forward_t80 = m_a_3*r_a_3;
    const lane forward_t81 = (D_delta_x_1*D_delta_x_1);
    const lane forward_t82 = (D_delta_y_1*D_delta_y_1);
    const lane forward_t83 = (D_delta_z_1*D_delta_z_1);
    const lane forward_t84 = D_delta_x_1*forward_t50;
    const lane forward_t85 = D_delta_y_1*forward_t50;
    const lane forward_t86 = D_delta_z_1*forward_t50;
    const lane forward_t87 = (D_delta_x_2*D_delta_x_2);
    const lane forward_t88 = (D_delta_y_2*D_delta_y_2);
    const lane forward_t89 = (D_delta_z_2*D_delta_z_2);
    const lane forward_t90 = D_delta_x_2*forward_t50;
    const lane forward_t91 = D_delta_y_2*forward_t50;
    const lane forward_t92 = D_delta_z_2*forward_t50;
    const lane forward_t93 = (D_delta_x_3*D_delta_x_3);
    const lane forward_t94 = (D_delta_y_3*D_delta_y_3);
    const lane forward_t95 = (D_delta_z_3*D_delta_z_3);
    const double forward_t97 = L_a_1*forward_t35 + forward_t65;
    const lane forward_t98 = (D_p_x_1*D_p_x_1);
    const lane forward_t99 = (D_p_y_1*D_p_y_1);
    const lane forward_t100 = (D_p_z_1*D_p_z_1);
    const lane forward_t101 = D_p_x_1*mu_3;
    const lane forward_t102 = D_p_x_1*mu_2;
    const lane forward_t103 = U_1_x_1*mu_1;
    const lane forward_t104 = D_p_y_1*mu_3;
    const lane forward_t105 = D_p_y_1*mu_2;
    const lane forward_t106 = U_1_y_1*mu_1;
    const lane forward_t107 = D_p_z_1*mu_3;
    const lane forward_t108 = D_p_z_1*mu_2;
    const lane forward_t109 = U_1_z_1*mu_1;
    const lane forward_t110 = (D_p_x_2*D_p_x_2);
    const lane forward_t111 = (D_p_y_2*D_p_y_2);
    const lane forward_t112 = (D_p_z_2*D_p_z_2);
    const double forward_t113 = L_a_2*forward_t36 + forward_t73;
    const lane forward_t114 = D_p_x_2*mu_1;
    const lane forward_t115 = D_p_x_2*mu_3;
    const lane forward_t116 = U_2_x_2*mu_2;
    const lane forward_t117 = D_p_y_2*mu_1;
    const lane forward_t118 = D_p_y_2*mu_3;
    const lane forward_t119 = U_2_y_2*mu_2;
    const lane forward_t120 = D_p_z_2*mu_1;
    const lane forward_t121 = D_p_z_2*mu_3;
    const lane forward_t122 = U_2_z_2*mu_2;
    const lane forward_t123 = (D_p_x_3*D_p_x_3);
    const lane forward_t124 = (D_p_y_3*D_p_y_3);
    const lane forward_t125 = (D_p_z_3*D_p_z_3);
    const double forward_t126 = L_a_3*forward_t37 + forward_t80;
    const lane forward_t127 = D_delta_x_1*D_p_x_3;
    const lane forward_t128 = U_3_x_3*mu_3;
    const lane forward_t129 = D_delta_y_1*D_p_y_3;
    const lane forward_t130 = U_3_y_3*mu_3;
    const lane forward_t131 = D_delta_z_1*D_p_z_3;
    const lane forward_t132 = U_3_z_3*mu_3;
    const lane forward_t133 = D_delta_x_2*D_p_x_3;
    const lane forward_t134 = D_delta_y_2*D_p_y_3;
    const lane forward_t135 = D_delta_z_2*D_p_z_3;
    const lane forward_t136 = D_delta_x_3*D_p_x_3;
    const lane forward_t137 = D_delta_y_3*D_p_y_3;
    const lane forward_t138 = D_delta_z_3*D_p_z_3;
    const lane forward_t139 = D_delta_x_1*D_delta_x_2;
    const lane forward_t140 = D_delta_y_1*D_delta_y_2;
    const lane forward_t141 = D_delta_z_1*D_delta_z_2;
    const lane forward_t142 = D_delta_x_1*D_delta_x_3;
    const lane forward_t143 = D_delta_y_1*D_delta_y_3;
    const lane forward_t144 = D_delta_z_1*D_delta_z_3;
    const lane forward_t145 = D_delta_x_2*D_delta_x_3;
    const lane forward_t146 = D_delta_y_2*D_delta_y_3;
    const lane forward_t147 = D_delta_z_2*D_delta_z_3;
    const lane t26 = mu_1 + mu_2;
    const lane t27 = mu_3 + t26;
    const lane t67 = -k_C + mu_3;
    const lane t98 = k_C - t27;
    const lane t101 = 2.0*D_delta_z_3;
    const lane t105 = 2.0*D_delta_y_3;
    const lane t108 = 2.0*D_delta_x_3;
    const lane t113 = 2.0*D_delta_z_2;
    const lane t117 = 2.0*D_delta_y_2;
    const lane t120 = 2.0*D_delta_x_2;
    const lane t139 = 2.0*D_delta_x_1;
    const lane t145 = 2.0*D_delta_y_1;
    const lane t151 = 2.0*D_delta_z_1;
    const lane t168 = forward_t81 + forward_t82 + forward_t83;
    const lane t170 = forward_t87 + forward_t88 + forward_t89;
    const lane t172 = forward_t93 + forward_t94 + forward_t95;
    const lane t174 = forward_t100 + forward_t98 + forward_t99;
    const lane t181 = forward_t110 + forward_t111 + forward_t112;
    const lane t183 = forward_t123 + forward_t124 + forward_t125;
    const lane t200 = D_p_z_3*k_C;
    const lane t201 = -forward_t132 + t200;
    const lane t202 = -D_p_z_1*k_C + forward_t109;
    const lane t203 = forward_t108 + t202;
    const lane t204 = -forward_t107 - t203;
    const lane t205 = -D_p_z_2*k_C + forward_t120 + forward_t122;
    const lane t206 = -forward_t121 - t205;
    const lane t214 = D_p_y_3*k_C;
    const lane t215 = -forward_t130 + t214;
    const lane t216 = -D_p_y_1*k_C + forward_t106;
    const lane t217 = forward_t105 + t216;
    const lane t218 = -forward_t104 - t217;
    const lane t219 = -D_p_y_2*k_C + forward_t117 + forward_t119;
    const lane t220 = -forward_t118 - t219;
    const lane t225 = D_p_x_3*k_C;
    const lane t226 = -forward_t128 + t225;
    const lane t227 = -D_p_x_1*k_C + forward_t103;
    const lane t228 = forward_t102 + t227;
    const lane t229 = -forward_t101 - t228;
    const lane t230 = -D_p_x_2*k_C + forward_t114 + forward_t116;
    const lane t231 = -forward_t115 - t230;
    const lane t241 = A_3*forward_8;
    const lane t242 = B_3*forward_8;
    const lane t245 = C_3*forward_8;
    const lane t246 = S_3*forward_8;
    const lane t247 = A_2*forward_5;
    const lane t248 = B_2*forward_5;
    const lane t251 = C_2*forward_5;
    const lane t252 = S_2*forward_5;
    const lane t253 = A_1*forward_2;
    const lane t254 = B_1*forward_2;
    const lane t257 = C_1*forward_2;
    const lane t258 = S_1*forward_2;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 12;
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
        const lane t25 = 2.0*shape_8;
        const lane t28 = -shape_9*t27;
        const lane adjoint_forward_t147 = t25*t28;
        const lane t29 = 2.0*shape_7;
        const lane adjoint_forward_t144 = t28*t29;
        const lane t30 = shape_7*t25;
        const lane adjoint_forward_t141 = -t27*t30;
        const lane t31 = 2.0*shape_3;
        const lane t32 = -t26*t31;
        const lane adjoint_forward_t138 = shape_9*t32;
        const lane adjoint_forward_t135 = shape_8*t32;
        const lane t33 = shape_7*t31;
        const lane t34 = D_delta_z_1*t33;
        const lane t35 = shape_8*t31;
        const lane t36 = D_delta_z_2*t35;
        const lane t37 = shape_9*t31;
        const lane t38 = D_delta_z_3*t37;
        const lane adjoint_forward_t132 = -t34 - t36 - t38;
        const lane adjoint_forward_t131 = shape_7*t32;
        const lane t39 = D_delta_y_1*t33;
        const lane t40 = D_delta_y_2*t35;
        const lane t41 = D_delta_y_3*t37;
        const lane adjoint_forward_t130 = -t39 - t40 - t41;
        const lane t42 = D_delta_x_1*t33;
        const lane t43 = D_delta_x_2*t35;
        const lane t44 = D_delta_x_3*t37;
        const lane adjoint_forward_t128 = -t42 - t43 - t44;
        const lane t45 = (shape_3*shape_3);
        const lane adjoint_forward_t126 = t45*(d_3_x*g_x + d_3_y*g_y + d_3_z*g_z);
        const lane adjoint_forward_t125 = t45*(k_C - t26);
        const lane t46 = 2.0*shape_2;
        const lane t47 = shape_9*t46;
        const lane t48 = D_delta_z_3*t47;
        const lane t49 = shape_7*t46;
        const lane t50 = D_delta_z_1*t49;
        const lane t51 = shape_8*t46;
        const lane t52 = D_delta_z_2*t51;
        const lane t53 = t48 + t50 + t52;
        const lane t54 = shape_2*t31;
        const lane t55 = D_p_z_3*t54;
        const lane adjoint_forward_t122 = -t53 - t55;
        const lane adjoint_forward_t121 = -U_3_z_3*t54 - t53;
        const lane t56 = D_p_y_3*t54;
        const lane t57 = D_delta_y_1*t49;
        const lane t58 = D_delta_y_2*t51;
        const lane t59 = D_delta_y_3*t47;
        const lane t60 = t57 + t58 + t59;
        const lane adjoint_forward_t119 = -t56 - t60;
        const lane adjoint_forward_t118 = -U_3_y_3*t54 - t60;
        const lane t61 = D_p_x_3*t54;
        const lane t62 = D_delta_x_1*t49;
        const lane t63 = D_delta_x_2*t51;
        const lane t64 = D_delta_x_3*t47;
        const lane t65 = t62 + t63 + t64;
        const lane adjoint_forward_t116 = -t61 - t65;
        const lane adjoint_forward_t115 = -U_3_x_3*t54 - t65;
        const lane t66 = (shape_2*shape_2);
        const lane adjoint_forward_t113 = t66*(d_2_x*g_x + d_2_y*g_y + d_2_z*g_z);
        const lane adjoint_forward_t112 = t66*(-mu_1 - t67);
        const lane t68 = shape_1*t46;
        const lane t69 = D_p_z_2*t68;
        const lane t70 = 2.0*shape_1;
        const lane t71 = shape_7*t70;
        const lane t72 = D_delta_z_1*t71;
        const lane t73 = shape_8*t70;
        const lane t74 = D_delta_z_2*t73;
        const lane t75 = shape_9*t70;
        const lane t76 = D_delta_z_3*t75;
        const lane t77 = shape_1*t31;
        const lane t78 = D_p_z_3*t77;
        const lane t79 = t72 + t74 + t76 + t78;
        const lane adjoint_forward_t109 = -t69 - t79;
        const lane adjoint_forward_t108 = -U_2_z_2*t68 - t79;
        const lane adjoint_forward_t107 = -U_3_z_3*t77 - t69 - t72 - t74 - t76;
        const lane t80 = D_p_y_2*t68;
        const lane t81 = D_delta_y_1*t71;
        const lane t82 = D_delta_y_2*t73;
        const lane t83 = D_delta_y_3*t75;
        const lane t84 = D_p_y_3*t77;
        const lane t85 = t81 + t82 + t83 + t84;
        const lane adjoint_forward_t106 = -t80 - t85;
        const lane adjoint_forward_t105 = -U_2_y_2*t68 - t85;
        const lane adjoint_forward_t104 = -U_3_y_3*t77 - t80 - t81 - t82 - t83;
        const lane t86 = D_p_x_2*t68;
        const lane t87 = D_delta_x_1*t71;
        const lane t88 = D_delta_x_2*t73;
        const lane t89 = D_delta_x_3*t75;
        const lane t90 = D_p_x_3*t77;
        const lane t91 = t87 + t88 + t89 + t90;
        const lane adjoint_forward_t103 = -t86 - t91;
        const lane adjoint_forward_t102 = -U_2_x_2*t68 - t91;
        const lane adjoint_forward_t101 = -U_3_x_3*t77 - t86 - t87 - t88 - t89;
        const lane t92 = (shape_1*shape_1);
        const lane adjoint_forward_t100 = t92*(-mu_2 - t67);
        const lane adjoint_forward_t97 = t92*(d_1_x*g_x + d_1_y*g_y + d_1_z*g_z);
        const lane t93 = (shape_10*shape_10);
        const lane t94 = (shape_11*shape_11);
        const lane t95 = (shape_12*shape_12);
        const lane adjoint_forward_t96 = -eigenvalue*t93 - eigenvalue*t94 - eigenvalue*t95;
        const lane t96 = (shape_9*shape_9);
        const lane t97 = eigenvalue*forward_t50;
        const lane adjoint_forward_t95 = -t96*t97 + t96*t98;
        const lane t99 = eigenvalue*t25;
        const lane t100 = shape_12*t99;
        const lane t102 = shape_9*t101;
        const lane t103 = eigenvalue*shape_8;
        const lane adjoint_forward_t92 = -t100 - t102*t103;
        const lane t104 = shape_11*t99;
        const lane t106 = shape_9*t105;
        const lane adjoint_forward_t91 = -t103*t106 - t104;
        const lane t107 = shape_10*t99;
        const lane t109 = shape_9*t108;
        const lane adjoint_forward_t90 = -t103*t109 - t107;
        const lane t110 = (shape_8*shape_8);
        const lane adjoint_forward_t89 = -t110*t97 + t110*t98;
        const lane t111 = eigenvalue*t29;
        const lane t112 = shape_12*t111;
        const lane t114 = shape_8*t113;
        const lane t115 = eigenvalue*shape_7;
        const lane adjoint_forward_t86 = -t102*t115 - t112 - t114*t115;
        const lane t116 = shape_11*t111;
        const lane t118 = shape_8*t117;
        const lane adjoint_forward_t85 = -t106*t115 - t115*t118 - t116;
        const lane t119 = shape_10*t111;
        const lane t121 = shape_8*t120;
        const lane adjoint_forward_t84 = -t109*t115 - t115*t121 - t119;
        const lane t122 = (shape_7*shape_7);
        const lane adjoint_forward_t83 = -t122*t97 + t122*t98;
        const lane t123 = eigenvalue*t31;
        const lane t124 = shape_10*t123;
        const lane t125 = shape_11*t123;
        const lane t126 = shape_12*t123;
        const lane adjoint_forward_t80 = adjoint_forward_t126 - t124*t_3_x - t125*t_3_y - t126*t_3_z;
        const lane t127 = eigenvalue*t45;
        const lane t128 = D_p_z_3*t127;
        const lane adjoint_forward_t79 = -eigenvalue*t34 - eigenvalue*t36 - eigenvalue*t38 - t128;
        const lane adjoint_forward_t78 = adjoint_forward_t79 - t126;
        const lane t129 = D_p_y_3*t127;
        const lane adjoint_forward_t77 = -eigenvalue*t39 - eigenvalue*t40 - eigenvalue*t41 - t129;
        const lane adjoint_forward_t76 = adjoint_forward_t77 - t125;
        const lane t130 = D_p_x_3*t127;
        const lane adjoint_forward_t75 = -eigenvalue*t42 - eigenvalue*t43 - eigenvalue*t44 - t130;
        const lane adjoint_forward_t74 = adjoint_forward_t75 - t124;
        const lane t131 = eigenvalue*t46;
        const lane t132 = shape_10*t131;
        const lane t133 = shape_11*t131;
        const lane t134 = shape_12*t131;
        const lane adjoint_forward_t73 = adjoint_forward_t113 - t132*t_2_x - t133*t_2_y - t134*t_2_z;
        const lane t135 = eigenvalue*t66;
        const lane t136 = D_p_z_2*t135;
        const lane adjoint_forward_t72 =
            -eigenvalue*t48 - eigenvalue*t50 - eigenvalue*t52 - eigenvalue*t55 - t136;
        const lane adjoint_forward_t71 = adjoint_forward_t72 - t134;
        const lane t137 = D_p_y_2*t135;
        const lane adjoint_forward_t70 =
            -eigenvalue*t56 - eigenvalue*t57 - eigenvalue*t58 - eigenvalue*t59 - t137;
        const lane adjoint_forward_t69 = adjoint_forward_t70 - t133;
        const lane t138 = D_p_x_2*t135;
        const lane adjoint_forward_t68 =
            -eigenvalue*t61 - eigenvalue*t62 - eigenvalue*t63 - eigenvalue*t64 - t138;
        const lane adjoint_forward_t67 = adjoint_forward_t68 - t132;
        const lane t140 = shape_7*t139;
        const lane t141 = shape_10*t140;
        const lane t142 = shape_10*t121;
        const lane t143 = shape_10*t109;
        const lane t144 = eigenvalue*t143;
        const lane t146 = shape_7*t145;
        const lane t147 = shape_11*t146;
        const lane t148 = shape_11*t118;
        const lane t149 = shape_11*t106;
        const lane t150 = eigenvalue*t149;
        const lane t152 = shape_7*t151;
        const lane t153 = shape_12*t152;
        const lane t154 = shape_12*t114;
        const lane t155 = shape_12*t102;
        const lane t156 = eigenvalue*t155;
        const lane t157 = eigenvalue*t70;
        const lane t158 = shape_10*t157;
        const lane t159 = shape_11*t157;
        const lane t160 = shape_12*t157;
        const lane adjoint_forward_t66 =
            -D_p_x_1*t158 - D_p_x_2*t132 - D_p_x_3*t124 - D_p_y_1*t159 - D_p_y_2*t133 - D_p_y_3*t125
            - D_p_z_1*t160 - D_p_z_2*t134 - D_p_z_3*t126 - eigenvalue*t141 - eigenvalue*t142
            - eigenvalue*t147 - eigenvalue*t148 - eigenvalue*t153 - eigenvalue*t154 - t144 - t150 - t156;
        const lane adjoint_forward_t65 = adjoint_forward_t97 - t158*t_1_x - t159*t_1_y - t160*t_1_z;
        const lane t161 = eigenvalue*t77;
        const lane t162 = eigenvalue*t54;
        const lane adjoint_forward_t64 = -D_p_z_1*t161 - D_p_z_2*t162 + adjoint_forward_t79 - t128;
        const lane adjoint_forward_t63 = -D_p_y_1*t161 - D_p_y_2*t162 + adjoint_forward_t77 - t129;
        const lane adjoint_forward_t62 = -D_p_x_1*t161 - D_p_x_2*t162 + adjoint_forward_t75 - t130;
        const lane adjoint_forward_t61 =
            adjoint_forward_t62*forward_t22 + adjoint_forward_t63*forward_t23
            + adjoint_forward_t64*forward_t24 + adjoint_forward_t66;
        const lane t163 = eigenvalue*t68;
        const lane adjoint_forward_t60 = -D_p_z_1*t163 + adjoint_forward_t72 - t136;
        const lane adjoint_forward_t59 = -D_p_y_1*t163 + adjoint_forward_t70 - t137;
        const lane adjoint_forward_t58 = -D_p_x_1*t163 + adjoint_forward_t68 - t138;
        const lane adjoint_forward_t57 =
            adjoint_forward_t58*forward_t19 + adjoint_forward_t59*forward_t20
            + adjoint_forward_t60*forward_t21 + adjoint_forward_t66;
        const lane t164 = eigenvalue*t92;
        const lane t165 = D_p_z_1*t164;
        const lane adjoint_forward_t56 =
            -eigenvalue*t69 - eigenvalue*t72 - eigenvalue*t74 - eigenvalue*t76 - eigenvalue*t78 - t165;
        const lane adjoint_forward_t55 = adjoint_forward_t56 - t160;
        const lane t166 = D_p_y_1*t164;
        const lane adjoint_forward_t54 =
            -eigenvalue*t80 - eigenvalue*t81 - eigenvalue*t82 - eigenvalue*t83 - eigenvalue*t84 - t166;
        const lane adjoint_forward_t53 = adjoint_forward_t54 - t159;
        const lane t167 = D_p_x_1*t164;
        const lane adjoint_forward_t52 =
            -eigenvalue*t86 - eigenvalue*t87 - eigenvalue*t88 - eigenvalue*t89 - eigenvalue*t90 - t167;
        const lane adjoint_forward_t51 = adjoint_forward_t52 - t158;
        const lane t169 = t122*t168;
        const lane t171 = t110*t170;
        const lane t173 = t172*t96;
        const lane adjoint_forward_t50 =
            D_delta_x_1*adjoint_forward_t84 + D_delta_x_2*adjoint_forward_t90
            + D_delta_y_1*adjoint_forward_t85 + D_delta_y_2*adjoint_forward_t91
            + D_delta_z_1*adjoint_forward_t86 + D_delta_z_2*adjoint_forward_t92 + D_p_x_1*adjoint_forward_t51
            + D_p_x_2*adjoint_forward_t67 + D_p_x_3*adjoint_forward_t74 + D_p_y_1*adjoint_forward_t53
            + D_p_y_2*adjoint_forward_t69 + D_p_y_3*adjoint_forward_t76 + D_p_z_1*adjoint_forward_t55
            + D_p_z_2*adjoint_forward_t71 + D_p_z_3*adjoint_forward_t78 - eigenvalue*t169 - eigenvalue*t171
            - eigenvalue*t173 - t144 - t150 - t156;
        const lane adjoint_forward_t49 = adjoint_forward_t50 - forward_t5*t127;
        const lane adjoint_forward_t48 = adjoint_forward_t50 - forward_t3*t135;
        const lane adjoint_forward_t47 = adjoint_forward_t56 - t165;
        const lane adjoint_forward_t46 = adjoint_forward_t54 - t166;
        const lane adjoint_forward_t45 = adjoint_forward_t52 - t167;
        const lane adjoint_forward_t44 =
            adjoint_forward_t45*forward_t16 + adjoint_forward_t46*forward_t17
            + adjoint_forward_t47*forward_t18 + adjoint_forward_t66;
        const lane adjoint_forward_t43 = adjoint_forward_t50 - forward_t1*t164;
        const lane t175 = t30*(-forward_t139 - forward_t140 - forward_t141);
        const lane t176 = shape_9*t29;
        const lane t177 = t176*(-forward_t142 - forward_t143 - forward_t144);
        const lane t178 = shape_9*t25;
        const lane t179 = t178*(-forward_t145 - forward_t146 - forward_t147);
        const lane t180 = -t122*t168 - t174*t92 + t175 + t177 + t179;
        const lane t182 = -t110*t170 - t181*t66;
        const lane adjoint_mu_3 =
            D_p_x_1*adjoint_forward_t101 + D_p_x_2*adjoint_forward_t115 + D_p_y_1*adjoint_forward_t104
            + D_p_y_2*adjoint_forward_t118 + D_p_z_1*adjoint_forward_t107 + D_p_z_2*adjoint_forward_t121
            + U_3_x_3*adjoint_forward_t128 + U_3_y_3*adjoint_forward_t130 + U_3_z_3*adjoint_forward_t132
            + t180 + t182 + t45*(-(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3)
            - forward_t13*s_3_x - forward_t14*s_3_y - forward_t15*s_3_z) + t96*(1.0 - t172);
        const lane t184 =
            -t172*t96 - t183*t45 + t33*(-forward_t127 - forward_t129 - forward_t131) + t35*(-forward_t133
            - forward_t134 - forward_t135) + t37*(-forward_t136 - forward_t137 - forward_t138);
        const lane adjoint_mu_2 =
            D_p_x_1*adjoint_forward_t102 + D_p_y_1*adjoint_forward_t105 + D_p_z_1*adjoint_forward_t108
            + U_2_x_2*adjoint_forward_t116 + U_2_y_2*adjoint_forward_t119 + U_2_z_2*adjoint_forward_t122
            + t110*(1.0 - t170) + t180 + t184 + t66*(-(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2)
            - (U_2_z_2*U_2_z_2) - forward_t10*s_2_x - forward_t11*s_2_y - forward_t12*s_2_z);
        const lane adjoint_mu_1 =
            D_p_x_2*adjoint_forward_t116 + D_p_y_2*adjoint_forward_t119 + D_p_z_2*adjoint_forward_t122
            + U_1_x_1*adjoint_forward_t103 + U_1_y_1*adjoint_forward_t106 + U_1_z_1*adjoint_forward_t109
            + t122*(1.0 - t168) + t175 + t177 + t179 + t182 + t184 + t92*(-(U_1_x_1*U_1_x_1)
            - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1) - forward_t7*s_1_x - forward_t8*s_1_y - forward_t9*s_1_z);
        const lane adjoint_forward_t42 =
            -adjoint_mu_1*forward_t32 - adjoint_mu_2*forward_t33 - adjoint_mu_3*forward_t34;
        const lane adjoint_forward_t41 =
            -adjoint_mu_1*forward_t29 - adjoint_mu_2*forward_t30 - adjoint_mu_3*forward_t31;
        const lane adjoint_forward_t40 =
            -adjoint_mu_1*forward_t26 - adjoint_mu_2*forward_t27 - adjoint_mu_3*forward_t28;
        const lane adjoint_forward_t39 =
            adjoint_forward_t40*g_x + adjoint_forward_t41*g_y + adjoint_forward_t42*g_z;
        const lane adjoint_forward_t38 = adjoint_forward_t39 + adjoint_forward_t50 + adjoint_forward_t96;
        const lane adjoint_forward_t37 =
            L_a_3*adjoint_forward_t126 + adjoint_forward_t39 - forward_t22*t124 - forward_t23*t125
            - forward_t24*t126;
        const lane adjoint_forward_t36 =
            L_a_2*adjoint_forward_t113 + adjoint_forward_t39 - forward_t19*t132 - forward_t20*t133
            - forward_t21*t134;
        const lane adjoint_forward_t35 =
            L_a_1*adjoint_forward_t97 + adjoint_forward_t39 - forward_t16*t158 - forward_t17*t159
            - forward_t18*t160;
        const lane t185 = (shape_6*shape_6);
        const lane adjoint_k_3 = -shape_6*t31 + t185 + t45;
        const lane t186 = (shape_5*shape_5);
        const lane adjoint_k_2 = -shape_5*t46 + t186 + t66;
        const lane t187 = (shape_4*shape_4);
        const lane adjoint_k_1 = -shape_4*t70 + t187 + t92;
        const lane adjoint_I_3 = -eigenvalue*t185;
        const lane adjoint_I_2 = -eigenvalue*t186;
        const lane adjoint_I_1 = -eigenvalue*t187;
        const lane t188 = 2.0*t45;
        const lane adjoint_U_3_z_3 =
            adjoint_forward_t132*mu_3 - forward_t107*t77 - forward_t121*t54 - forward_t132*t188;
        const lane adjoint_U_3_y_3 =
            adjoint_forward_t130*mu_3 - forward_t104*t77 - forward_t118*t54 - forward_t130*t188;
        const lane adjoint_U_3_x_3 =
            adjoint_forward_t128*mu_3 - forward_t101*t77 - forward_t115*t54 - forward_t128*t188;
        const lane t189 = 2.0*t66;
        const lane adjoint_U_2_z_2 = adjoint_forward_t122*mu_2 - forward_t108*t68 - forward_t122*t189;
        const lane adjoint_U_2_y_2 = adjoint_forward_t119*mu_2 - forward_t105*t68 - forward_t119*t189;
        const lane adjoint_U_2_x_2 = adjoint_forward_t116*mu_2 - forward_t102*t68 - forward_t116*t189;
        const lane t190 = 2.0*t92;
        const lane adjoint_U_1_z_1 = adjoint_forward_t109*mu_1 - forward_t109*t190;
        const lane adjoint_U_1_y_1 = adjoint_forward_t106*mu_1 - forward_t106*t190;
        const lane adjoint_U_1_x_1 = adjoint_forward_t103*mu_1 - forward_t103*t190;
        const lane t191 = k_C*shape_12;
        const lane t192 = 2.0*shape_9;
        const lane t193 = k_C*shape_9;
        const lane t194 = eigenvalue*forward_t56;
        const lane t195 = eigenvalue*forward_t72;
        const lane t196 = eigenvalue*forward_t79;
        const lane t197 = shape_9*t111;
        const lane t198 = shape_9*t99;
        const lane t199 = eigenvalue*t192*(forward_t50 + forward_t66);
        const lane adjoint_D_delta_z_3 =
            D_delta_z_1*adjoint_forward_t144 + D_delta_z_2*adjoint_forward_t147
            + D_p_z_3*adjoint_forward_t138 + adjoint_forward_t95*t101 - forward_t86*t197 - forward_t92*t198
            - shape_12*t199 + t114*t193 + t152*t193 + t191*t192 - t194*t75 - t195*t47 - t196*t37 + t201*t37
            + t204*t75 + t206*t47;
        const lane t207 = k_C*shape_8;
        const lane t208 = eigenvalue*t30;
        const lane adjoint_D_delta_z_2 =
            D_delta_z_1*adjoint_forward_t141 + D_delta_z_3*adjoint_forward_t147
            + D_p_z_3*adjoint_forward_t135 + adjoint_forward_t89*t113 + adjoint_forward_t92*forward_t50
            - forward_t66*t100 - forward_t86*t208 + t102*t207 + t152*t207 + t191*t25 - t194*t73 - t195*t51
            - t196*t35 + t201*t35 + t204*t73 + t206*t51;
        const lane t209 = k_C*shape_7;
        const lane adjoint_D_delta_z_1 =
            D_delta_z_2*adjoint_forward_t141 + D_delta_z_3*adjoint_forward_t144
            + D_p_z_3*adjoint_forward_t131 + adjoint_forward_t83*t151 + adjoint_forward_t86*forward_t50
            - forward_t66*t112 + t102*t209 + t114*t209 + t191*t29 - t194*t71 - t195*t49 - t196*t33 + t201*t33
            + t204*t71 + t206*t49;
        const lane adjoint_D_p_z_3 =
            D_delta_z_1*adjoint_forward_t131 + D_delta_z_2*adjoint_forward_t135
            + D_delta_z_3*adjoint_forward_t138 + 2.0*D_p_z_3*adjoint_forward_t125 + adjoint_U_3_z_3
            + adjoint_forward_t78*forward_t50 - forward_t56*t161 - forward_t66*t126 - forward_t72*t162
            + k_C*t34 + k_C*t36 + k_C*t38 - t127*(forward_t64 + forward_t79) + t191*t31 - t203*t77 - t205*t54;
        const lane adjoint_forward_t34 = D_r_3*adjoint_D_p_z_3 + adjoint_D_delta_z_3*l_d_3;
        const lane adjoint_D_p_z_2 =
            2.0*D_p_z_2*adjoint_forward_t112 + adjoint_U_2_z_2 + adjoint_forward_t121*mu_3
            + adjoint_forward_t122*mu_1 + adjoint_forward_t71*forward_t50 - forward_t56*t163
            - forward_t64*t162 - forward_t66*t134 + k_C*t48 + k_C*t50 + k_C*t52 - t135*(forward_t60
            + forward_t72) + t191*t46 + t200*t54 + t68*(-forward_t107 - t202);
        const lane adjoint_forward_t33 = D_r_2*adjoint_D_p_z_2 + adjoint_D_delta_z_2*l_d_2;
        const lane adjoint_D_p_z_1 =
            2.0*D_p_z_1*adjoint_forward_t100 + D_p_z_2*k_C*t68 + adjoint_U_1_z_1 + adjoint_forward_t107*mu_3
            + adjoint_forward_t108*mu_2 + adjoint_forward_t55*forward_t50 - forward_t60*t163
            - forward_t64*t161 - forward_t66*t160 + k_C*t72 + k_C*t74 + k_C*t76 - t164*(forward_t47
            + forward_t56) + t191*t70 + t200*t77;
        const lane adjoint_forward_t32 = D_r_1*adjoint_D_p_z_1 + adjoint_D_delta_z_1*l_d_1;
        const lane t210 = k_C*shape_11;
        const lane t211 = eigenvalue*forward_t54;
        const lane t212 = eigenvalue*forward_t70;
        const lane t213 = eigenvalue*forward_t77;
        const lane adjoint_D_delta_y_3 =
            D_delta_y_1*adjoint_forward_t144 + D_delta_y_2*adjoint_forward_t147
            + D_p_y_3*adjoint_forward_t138 + adjoint_forward_t95*t105 - forward_t85*t197 - forward_t91*t198
            - shape_11*t199 + t118*t193 + t146*t193 + t192*t210 - t211*t75 - t212*t47 - t213*t37 + t215*t37
            + t218*t75 + t220*t47;
        const lane adjoint_D_delta_y_2 =
            D_delta_y_1*adjoint_forward_t141 + D_delta_y_3*adjoint_forward_t147
            + D_p_y_3*adjoint_forward_t135 + adjoint_forward_t89*t117 + adjoint_forward_t91*forward_t50
            - forward_t66*t104 - forward_t85*t208 + t106*t207 + t146*t207 + t210*t25 - t211*t73 - t212*t51
            - t213*t35 + t215*t35 + t218*t73 + t220*t51;
        const lane adjoint_D_delta_y_1 =
            D_delta_y_2*adjoint_forward_t141 + D_delta_y_3*adjoint_forward_t144
            + D_p_y_3*adjoint_forward_t131 + adjoint_forward_t83*t145 + adjoint_forward_t85*forward_t50
            - forward_t66*t116 + t106*t209 + t118*t209 + t210*t29 - t211*t71 - t212*t49 - t213*t33 + t215*t33
            + t218*t71 + t220*t49;
        const lane adjoint_D_p_y_3 =
            D_delta_y_1*adjoint_forward_t131 + D_delta_y_2*adjoint_forward_t135
            + D_delta_y_3*adjoint_forward_t138 + 2.0*D_p_y_3*adjoint_forward_t125 + adjoint_U_3_y_3
            + adjoint_forward_t76*forward_t50 - forward_t54*t161 - forward_t66*t125 - forward_t70*t162
            + k_C*t39 + k_C*t40 + k_C*t41 - t127*(forward_t63 + forward_t77) + t210*t31 - t217*t77 - t219*t54;
        const lane adjoint_forward_t31 = D_r_3*adjoint_D_p_y_3 + adjoint_D_delta_y_3*l_d_3;
        const lane adjoint_D_p_y_2 =
            2.0*D_p_y_2*adjoint_forward_t112 + adjoint_U_2_y_2 + adjoint_forward_t118*mu_3
            + adjoint_forward_t119*mu_1 + adjoint_forward_t69*forward_t50 - forward_t54*t163
            - forward_t63*t162 - forward_t66*t133 + k_C*t57 + k_C*t58 + k_C*t59 - t135*(forward_t59
            + forward_t70) + t210*t46 + t214*t54 + t68*(-forward_t104 - t216);
        const lane adjoint_forward_t30 = D_r_2*adjoint_D_p_y_2 + adjoint_D_delta_y_2*l_d_2;
        const lane adjoint_D_p_y_1 =
            2.0*D_p_y_1*adjoint_forward_t100 + D_p_y_2*k_C*t68 + adjoint_U_1_y_1 + adjoint_forward_t104*mu_3
            + adjoint_forward_t105*mu_2 + adjoint_forward_t53*forward_t50 - forward_t59*t163
            - forward_t63*t161 - forward_t66*t159 + k_C*t81 + k_C*t82 + k_C*t83 - t164*(forward_t46
            + forward_t54) + t210*t70 + t214*t77;
        const lane adjoint_forward_t29 = D_r_1*adjoint_D_p_y_1 + adjoint_D_delta_y_1*l_d_1;
        const lane t221 = k_C*shape_10;
        const lane t222 = eigenvalue*forward_t52;
        const lane t223 = eigenvalue*forward_t68;
        const lane t224 = eigenvalue*forward_t75;
        const lane adjoint_D_delta_x_3 =
            D_delta_x_1*adjoint_forward_t144 + D_delta_x_2*adjoint_forward_t147
            + D_p_x_3*adjoint_forward_t138 + adjoint_forward_t95*t108 - forward_t84*t197 - forward_t90*t198
            - shape_10*t199 + t121*t193 + t140*t193 + t192*t221 - t222*t75 - t223*t47 - t224*t37 + t226*t37
            + t229*t75 + t231*t47;
        const lane adjoint_D_delta_x_2 =
            D_delta_x_1*adjoint_forward_t141 + D_delta_x_3*adjoint_forward_t147
            + D_p_x_3*adjoint_forward_t135 + adjoint_forward_t89*t120 + adjoint_forward_t90*forward_t50
            - forward_t66*t107 - forward_t84*t208 + t109*t207 + t140*t207 + t221*t25 - t222*t73 - t223*t51
            - t224*t35 + t226*t35 + t229*t73 + t231*t51;
        const lane adjoint_D_delta_x_1 =
            D_delta_x_2*adjoint_forward_t141 + D_delta_x_3*adjoint_forward_t144
            + D_p_x_3*adjoint_forward_t131 + adjoint_forward_t83*t139 + adjoint_forward_t84*forward_t50
            - forward_t66*t119 + t109*t209 + t121*t209 + t221*t29 - t222*t71 - t223*t49 - t224*t33 + t226*t33
            + t229*t71 + t231*t49;
        const lane adjoint_D_p_x_3 =
            D_delta_x_1*adjoint_forward_t131 + D_delta_x_2*adjoint_forward_t135
            + D_delta_x_3*adjoint_forward_t138 + 2.0*D_p_x_3*adjoint_forward_t125 + adjoint_U_3_x_3
            + adjoint_forward_t74*forward_t50 - forward_t52*t161 - forward_t66*t124 - forward_t68*t162
            + k_C*t42 + k_C*t43 + k_C*t44 - t127*(forward_t62 + forward_t75) + t221*t31 - t228*t77 - t230*t54;
        const lane adjoint_forward_t28 = D_r_3*adjoint_D_p_x_3 + adjoint_D_delta_x_3*l_d_3;
        const lane adjoint_D_p_x_2 =
            2.0*D_p_x_2*adjoint_forward_t112 + adjoint_U_2_x_2 + adjoint_forward_t115*mu_3
            + adjoint_forward_t116*mu_1 + adjoint_forward_t67*forward_t50 - forward_t52*t163
            - forward_t62*t162 - forward_t66*t132 + k_C*t62 + k_C*t63 + k_C*t64 - t135*(forward_t58
            + forward_t68) + t221*t46 + t225*t54 + t68*(-forward_t101 - t227);
        const lane adjoint_forward_t27 = D_r_2*adjoint_D_p_x_2 + adjoint_D_delta_x_2*l_d_2;
        const lane adjoint_D_p_x_1 =
            2.0*D_p_x_1*adjoint_forward_t100 + D_p_x_2*k_C*t68 + adjoint_U_1_x_1 + adjoint_forward_t101*mu_3
            + adjoint_forward_t102*mu_2 + adjoint_forward_t51*forward_t50 - forward_t58*t163
            - forward_t62*t161 - forward_t66*t158 + k_C*t87 + k_C*t88 + k_C*t89 - t164*(forward_t45
            + forward_t52) + t221*t70 + t225*t77;
        const lane adjoint_forward_t26 = D_r_1*adjoint_D_p_x_1 + adjoint_D_delta_x_1*l_d_1;
        const lane adjoint_forward_t25 =
            A_x_1*adjoint_forward_t26 + A_x_2*adjoint_forward_t27 + A_x_3*adjoint_forward_t28
            + A_y_1*adjoint_forward_t29 + A_y_2*adjoint_forward_t30 + A_y_3*adjoint_forward_t31
            + A_z_1*adjoint_forward_t32 + A_z_2*adjoint_forward_t33 + A_z_3*adjoint_forward_t34
            + adjoint_mu_1*t22 + adjoint_mu_2*t23 + adjoint_mu_3*t24;
        const lane adjoint_det_D_l = -adjoint_forward_t25*(forward_9*forward_9);
        const lane t232 = adjoint_mu_3*forward_9;
        const lane adjoint_A_z_3 = adjoint_forward_t34*forward_9 - forward_t42*t232;
        const lane adjoint_A_y_3 = adjoint_forward_t31*forward_9 - forward_t41*t232;
        const lane adjoint_A_x_3 = adjoint_forward_t28*forward_9 - forward_t40*t232;
        const lane t233 = adjoint_mu_2*forward_9;
        const lane adjoint_A_z_2 = adjoint_forward_t33*forward_9 - forward_t42*t233;
        const lane adjoint_A_y_2 = adjoint_forward_t30*forward_9 - forward_t41*t233;
        const lane adjoint_A_x_2 = adjoint_forward_t27*forward_9 - forward_t40*t233;
        const lane t234 = adjoint_mu_1*forward_9;
        const lane adjoint_A_z_1 = adjoint_det_D_l*s_1_z + adjoint_forward_t32*forward_9 - forward_t42*t234;
        const lane adjoint_A_y_1 = adjoint_det_D_l*s_1_y + adjoint_forward_t29*forward_9 - forward_t41*t234;
        const lane adjoint_A_x_1 = adjoint_det_D_l*s_1_x + adjoint_forward_t26*forward_9 - forward_t40*t234;
        const lane adjoint_D_r_3 =
            adjoint_D_p_x_3*forward_t28 + adjoint_D_p_y_3*forward_t31 + adjoint_D_p_z_3*forward_t34;
        const lane adjoint_forward_t24 =
            adjoint_D_r_3*s_3_z - adjoint_U_3_z_3 + adjoint_forward_t64*forward_t61 - forward_t37*t126;
        const lane adjoint_forward_t23 =
            adjoint_D_r_3*s_3_y - adjoint_U_3_y_3 + adjoint_forward_t63*forward_t61 - forward_t37*t125;
        const lane adjoint_forward_t22 =
            adjoint_D_r_3*s_3_x - adjoint_U_3_x_3 + adjoint_forward_t62*forward_t61 - forward_t37*t124;
        const lane adjoint_D_r_2 =
            adjoint_D_p_x_2*forward_t27 + adjoint_D_p_y_2*forward_t30 + adjoint_D_p_z_2*forward_t33;
        const lane adjoint_forward_t21 =
            adjoint_D_r_2*s_2_z - adjoint_U_2_z_2 + adjoint_forward_t60*forward_t57 - forward_t36*t134;
        const lane adjoint_forward_t20 =
            adjoint_D_r_2*s_2_y - adjoint_U_2_y_2 + adjoint_forward_t59*forward_t57 - forward_t36*t133;
        const lane adjoint_forward_t19 =
            adjoint_D_r_2*s_2_x - adjoint_U_2_x_2 + adjoint_forward_t58*forward_t57 - forward_t36*t132;
        const lane adjoint_D_r_1 =
            adjoint_D_p_x_1*forward_t26 + adjoint_D_p_y_1*forward_t29 + adjoint_D_p_z_1*forward_t32;
        const lane adjoint_forward_t18 =
            adjoint_D_r_1*s_1_z - adjoint_U_1_z_1 + adjoint_forward_t47*forward_t44 - forward_t35*t160;
        const lane adjoint_forward_t17 =
            adjoint_D_r_1*s_1_y - adjoint_U_1_y_1 + adjoint_forward_t46*forward_t44 - forward_t35*t159;
        const lane adjoint_forward_t16 =
            adjoint_D_r_1*s_1_x - adjoint_U_1_x_1 + adjoint_forward_t45*forward_t44 - forward_t35*t158;
        const lane t235 = mu_3*t45;
        const lane adjoint_s_3_z =
            adjoint_A_x_1*s_2_y - adjoint_A_x_2*s_1_y - adjoint_A_y_1*s_2_x + adjoint_A_y_2*s_1_x
            + adjoint_D_r_3*forward_t24 - forward_t15*t235;
        const lane adjoint_forward_t15 = -adjoint_s_3_z - s_3_z*t235;
        const lane adjoint_s_3_y =
            -adjoint_A_x_1*s_2_z + adjoint_A_x_2*s_1_z + adjoint_A_z_1*s_2_x - adjoint_A_z_2*s_1_x
            + adjoint_D_r_3*forward_t23 - forward_t14*t235;
        const lane adjoint_forward_t14 = -adjoint_s_3_y - s_3_y*t235;
        const lane adjoint_s_3_x =
            adjoint_A_y_1*s_2_z - adjoint_A_y_2*s_1_z - adjoint_A_z_1*s_2_y + adjoint_A_z_2*s_1_y
            + adjoint_D_r_3*forward_t22 - forward_t13*t235;
        const lane adjoint_forward_t13 = -adjoint_s_3_x - s_3_x*t235;
        const lane t236 = mu_2*t66;
        const lane adjoint_s_2_z =
            -adjoint_A_x_1*s_3_y + adjoint_A_x_3*s_1_y + adjoint_A_y_1*s_3_x - adjoint_A_y_3*s_1_x
            + adjoint_D_r_2*forward_t21 - forward_t12*t236;
        const lane adjoint_forward_t12 = -adjoint_s_2_z - s_2_z*t236;
        const lane adjoint_s_2_y =
            adjoint_A_x_1*s_3_z - adjoint_A_x_3*s_1_z - adjoint_A_z_1*s_3_x + adjoint_A_z_3*s_1_x
            + adjoint_D_r_2*forward_t20 - forward_t11*t236;
        const lane adjoint_forward_t11 = -adjoint_s_2_y - s_2_y*t236;
        const lane adjoint_s_2_x =
            -adjoint_A_y_1*s_3_z + adjoint_A_y_3*s_1_z + adjoint_A_z_1*s_3_y - adjoint_A_z_3*s_1_y
            + adjoint_D_r_2*forward_t19 - forward_t10*t236;
        const lane adjoint_forward_t10 = -adjoint_s_2_x - s_2_x*t236;
        const lane t237 = mu_1*t92;
        const lane adjoint_s_1_z =
            A_z_1*adjoint_det_D_l + adjoint_A_x_2*s_3_y - adjoint_A_x_3*s_2_y - adjoint_A_y_2*s_3_x
            + adjoint_A_y_3*s_2_x + adjoint_D_r_1*forward_t18 - forward_t9*t237;
        const lane adjoint_forward_t9 = -adjoint_s_1_z - s_1_z*t237;
        const lane adjoint_s_1_y =
            A_y_1*adjoint_det_D_l - adjoint_A_x_2*s_3_z + adjoint_A_x_3*s_2_z + adjoint_A_z_2*s_3_x
            - adjoint_A_z_3*s_2_x + adjoint_D_r_1*forward_t17 - forward_t8*t237;
        const lane adjoint_forward_t8 = -adjoint_s_1_y - s_1_y*t237;
        const lane adjoint_s_1_x =
            A_x_1*adjoint_det_D_l + adjoint_A_y_2*s_3_z - adjoint_A_y_3*s_2_z - adjoint_A_z_2*s_3_y
            + adjoint_A_z_3*s_2_y + adjoint_D_r_1*forward_t16 - forward_t7*t237;
        const lane adjoint_forward_t7 = -adjoint_s_1_x - s_1_x*t237;
        const lane adjoint_t_3_z = L_a_3*adjoint_forward_t24 - forward_t80*t126;
        const lane adjoint_t_3_y = L_a_3*adjoint_forward_t23 - forward_t80*t125;
        const lane adjoint_t_3_x = L_a_3*adjoint_forward_t22 - forward_t80*t124;
        const lane t238 = forward_t126*t45;
        const lane adjoint_d_3_z = L_a_3*adjoint_forward_t15 + g_z*t238;
        const lane adjoint_d_3_y = L_a_3*adjoint_forward_t14 + g_y*t238;
        const lane adjoint_d_3_x = L_a_3*adjoint_forward_t13 + g_x*t238;
        const lane adjoint_t_2_z = L_a_2*adjoint_forward_t21 - forward_t73*t134;
        const lane adjoint_t_2_y = L_a_2*adjoint_forward_t20 - forward_t73*t133;
        const lane adjoint_t_2_x = L_a_2*adjoint_forward_t19 - forward_t73*t132;
        const lane t239 = forward_t113*t66;
        const lane adjoint_d_2_z = L_a_2*adjoint_forward_t12 + g_z*t239;
        const lane adjoint_d_2_y = L_a_2*adjoint_forward_t11 + g_y*t239;
        const lane adjoint_d_2_x = L_a_2*adjoint_forward_t10 + g_x*t239;
        const lane adjoint_t_1_z = L_a_1*adjoint_forward_t18 - forward_t65*t160;
        const lane adjoint_t_1_y = L_a_1*adjoint_forward_t17 - forward_t65*t159;
        const lane adjoint_t_1_x = L_a_1*adjoint_forward_t16 - forward_t65*t158;
        const lane t240 = forward_t97*t92;
        const lane adjoint_d_1_z = L_a_1*adjoint_forward_t9 + g_z*t240;
        const lane adjoint_d_1_y = L_a_1*adjoint_forward_t8 + g_y*t240;
        const lane adjoint_d_1_x = L_a_1*adjoint_forward_t7 + g_x*t240;
        const lane adjoint_sn_3 =
            adjoint_d_3_x*y_3_x + adjoint_d_3_y*y_3_y + adjoint_d_3_z*y_3_z - adjoint_t_3_x*z_3_x
            - adjoint_t_3_y*z_3_y - adjoint_t_3_z*z_3_z;
        const lane adjoint_c_3 =
            adjoint_d_3_x*z_3_x + adjoint_d_3_y*z_3_y + adjoint_d_3_z*z_3_z + adjoint_t_3_x*y_3_x
            + adjoint_t_3_y*y_3_y + adjoint_t_3_z*y_3_z;
        const lane adjoint_forward_t6 = adjoint_c_3*t20 + adjoint_sn_3*t21;
        const lane adjoint_S_3 = -adjoint_c_3*t242 + adjoint_sn_3*t241;
        const lane adjoint_forward_7 = adjoint_S_3*sigma_3;
        const lane t243 = adjoint_forward_7/forward_7;
        const lane adjoint_C_3 = -C_3*t243 + adjoint_c_3*t241 + adjoint_sn_3*t242;
        const lane adjoint_forward_6 =
            adjoint_C_3*((1.0/2.0)*forward_t5 + (1.0/2.0)*t15 + (1.0/2.0)*t16 + (1.0/2.0)*t17 - 1.0/2.0*t18);
        const lane adjoint_forward_t5 = adjoint_C_3*t19 - forward_t49*t127;
        const lane adjoint_rho2_3 = -adjoint_forward_t6*(forward_8*forward_8) + (1.0/2.0)*t243;
        const lane t244 = 2.0*adjoint_rho2_3;
        const lane adjoint_B_3 = B_3*t244 - adjoint_c_3*t246 + adjoint_sn_3*t245;
        const lane adjoint_A_3 = A_3*t244 + adjoint_c_3*t245 + adjoint_sn_3*t246;
        const lane adjoint_sn_2 =
            adjoint_d_2_x*y_2_x + adjoint_d_2_y*y_2_y + adjoint_d_2_z*y_2_z - adjoint_t_2_x*z_2_x
            - adjoint_t_2_y*z_2_y - adjoint_t_2_z*z_2_z;
        const lane adjoint_c_2 =
            adjoint_d_2_x*z_2_x + adjoint_d_2_y*z_2_y + adjoint_d_2_z*z_2_z + adjoint_t_2_x*y_2_x
            + adjoint_t_2_y*y_2_y + adjoint_t_2_z*y_2_z;
        const lane adjoint_forward_t4 = adjoint_c_2*t13 + adjoint_sn_2*t14;
        const lane adjoint_S_2 = -adjoint_c_2*t248 + adjoint_sn_2*t247;
        const lane adjoint_forward_4 = adjoint_S_2*sigma_2;
        const lane t249 = adjoint_forward_4/forward_4;
        const lane adjoint_C_2 = -C_2*t249 + adjoint_c_2*t247 + adjoint_sn_2*t248;
        const lane adjoint_forward_3 =
            adjoint_C_2*((1.0/2.0)*forward_t3 + (1.0/2.0)*t11 + (1.0/2.0)*t12 + (1.0/2.0)*t8 - 1.0/2.0*t9);
        const lane adjoint_forward_t3 = adjoint_C_2*t10 - forward_t48*t135;
        const lane adjoint_rho2_2 = -adjoint_forward_t4*(forward_5*forward_5) + (1.0/2.0)*t249;
        const lane t250 = 2.0*adjoint_rho2_2;
        const lane adjoint_B_2 = B_2*t250 - adjoint_c_2*t252 + adjoint_sn_2*t251;
        const lane adjoint_A_2 = A_2*t250 + adjoint_c_2*t251 + adjoint_sn_2*t252;
        const lane adjoint_sn_1 =
            adjoint_d_1_x*y_1_x + adjoint_d_1_y*y_1_y + adjoint_d_1_z*y_1_z - adjoint_t_1_x*z_1_x
            - adjoint_t_1_y*z_1_y - adjoint_t_1_z*z_1_z;
        const lane adjoint_c_1 =
            adjoint_d_1_x*z_1_x + adjoint_d_1_y*z_1_y + adjoint_d_1_z*z_1_z + adjoint_t_1_x*y_1_x
            + adjoint_t_1_y*y_1_y + adjoint_t_1_z*y_1_z;
        const lane adjoint_forward_t2 = adjoint_c_1*t6 + adjoint_sn_1*t7;
        const lane adjoint_S_1 = -adjoint_c_1*t254 + adjoint_sn_1*t253;
        const lane adjoint_forward_1 = adjoint_S_1*sigma_1;
        const lane t255 = adjoint_forward_1/forward_1;
        const lane adjoint_C_1 = -C_1*t255 + adjoint_c_1*t253 + adjoint_sn_1*t254;
        const lane adjoint_forward_0 =
            adjoint_C_1*((1.0/2.0)*forward_t1 + (1.0/2.0)*t1 + (1.0/2.0)*t2 + (1.0/2.0)*t3 - 1.0/2.0*t4);
        const lane adjoint_forward_t1 = adjoint_C_1*t5 - forward_t43*t164;
        const lane adjoint_rho2_1 = -adjoint_forward_t2*(forward_2*forward_2) + (1.0/2.0)*t255;
        const lane t256 = 2.0*adjoint_rho2_1;
        const lane adjoint_B_1 = B_1*t256 - adjoint_c_1*t258 + adjoint_sn_1*t257;
        const lane adjoint_A_1 = A_1*t256 + adjoint_c_1*t257 + adjoint_sn_1*t258;
        const lane t259 = adjoint_C_3*forward_6;
        const lane adjoint_r_3_z = adjoint_A_3*z_3_z + adjoint_B_3*y_3_z + adjoint_s_3_z + r_3_z*t259;
        const lane adjoint_r_3_y = adjoint_A_3*z_3_y + adjoint_B_3*y_3_y + adjoint_s_3_y + r_3_y*t259;
        const lane adjoint_r_3_x = adjoint_A_3*z_3_x + adjoint_B_3*y_3_x + adjoint_s_3_x + r_3_x*t259;
        const lane t260 = adjoint_C_2*forward_3;
        const lane adjoint_r_2_z = adjoint_A_2*z_2_z + adjoint_B_2*y_2_z + adjoint_s_2_z + r_2_z*t260;
        const lane adjoint_r_2_y = adjoint_A_2*z_2_y + adjoint_B_2*y_2_y + adjoint_s_2_y + r_2_y*t260;
        const lane adjoint_r_2_x = adjoint_A_2*z_2_x + adjoint_B_2*y_2_x + adjoint_s_2_x + r_2_x*t260;
        const lane t261 = adjoint_C_1*forward_0;
        const lane adjoint_r_1_z = adjoint_A_1*z_1_z + adjoint_B_1*y_1_z + adjoint_s_1_z + r_1_z*t261;
        const lane adjoint_r_1_y = adjoint_A_1*z_1_y + adjoint_B_1*y_1_y + adjoint_s_1_y + r_1_y*t261;
        const lane adjoint_r_1_x = adjoint_A_1*z_1_x + adjoint_B_1*y_1_x + adjoint_s_1_x + r_1_x*t261;
        lanes_clear(gradient, 94);
        gradient[0] = LANES(adjoint_forward_t38);
        gradient[1] = LANES(adjoint_forward_t40*forward_t39 + d_1_x*t240 + d_2_x*t239 + d_3_x*t238);
        gradient[2] = LANES(adjoint_forward_t41*forward_t39 + d_1_y*t240 + d_2_y*t239 + d_3_y*t238);
        gradient[3] = LANES(adjoint_forward_t42*forward_t39 + d_1_z*t240 + d_2_z*t239 + d_3_z*t238);
        gradient[4] = LANES(-adjoint_r_1_x);
        gradient[5] = LANES(-adjoint_r_1_y);
        gradient[6] = LANES(-adjoint_r_1_z);
        gradient[7] = LANES(-adjoint_r_2_x);
        gradient[8] = LANES(-adjoint_r_2_y);
        gradient[9] = LANES(-adjoint_r_2_z);
        gradient[10] = LANES(-adjoint_r_3_x);
        gradient[11] = LANES(-adjoint_r_3_y);
        gradient[12] = LANES(-adjoint_r_3_z);
        gradient[31] = LANES(adjoint_r_1_x);
        gradient[32] = LANES(adjoint_r_1_y);
        gradient[33] = LANES(adjoint_r_1_z);
        gradient[34] = LANES(adjoint_r_2_x);
        gradient[35] = LANES(adjoint_r_2_y);
        gradient[36] = LANES(adjoint_r_2_z);
        gradient[37] = LANES(adjoint_r_3_x);
        gradient[38] = LANES(adjoint_r_3_y);
        gradient[39] = LANES(adjoint_r_3_z);
        gradient[40] =
            LANES(2.0*L_a_1*adjoint_forward_t1 - adjoint_forward_0*(forward_0*forward_0)
            + adjoint_forward_t16*t_1_x + adjoint_forward_t17*t_1_y + adjoint_forward_t18*t_1_z
            + adjoint_forward_t7*d_1_x + adjoint_forward_t8*d_1_y + adjoint_forward_t9*d_1_z
            + adjoint_forward_t97*forward_t35);
        gradient[41] =
            LANES(2.0*L_a_2*adjoint_forward_t3 - adjoint_forward_3*(forward_3*forward_3)
            + adjoint_forward_t10*d_2_x + adjoint_forward_t11*d_2_y + adjoint_forward_t113*forward_t36
            + adjoint_forward_t12*d_2_z + adjoint_forward_t19*t_2_x + adjoint_forward_t20*t_2_y
            + adjoint_forward_t21*t_2_z);
        gradient[42] =
            LANES(2.0*L_a_3*adjoint_forward_t5 - adjoint_forward_6*(forward_6*forward_6)
            + adjoint_forward_t126*forward_t37 + adjoint_forward_t13*d_3_x + adjoint_forward_t14*d_3_y
            + adjoint_forward_t15*d_3_z + adjoint_forward_t22*t_3_x + adjoint_forward_t23*t_3_y
            + adjoint_forward_t24*t_3_z);
        gradient[43] = LANES(adjoint_forward_t65*r_a_1 + adjoint_forward_t96);
        gradient[44] = LANES(adjoint_forward_t73*r_a_2 + adjoint_forward_t96);
        gradient[45] = LANES(adjoint_forward_t80*r_a_3 + adjoint_forward_t96);
        gradient[46] = LANES(adjoint_forward_t65*m_a_1);
        gradient[47] = LANES(adjoint_forward_t73*m_a_2);
        gradient[48] = LANES(adjoint_forward_t80*m_a_3);
        gradient[49] = LANES(-t164);
        gradient[50] = LANES(-t135);
        gradient[51] = LANES(-t127);
        gradient[52] =
            LANES(adjoint_D_delta_x_1*forward_t26 + adjoint_D_delta_y_1*forward_t29
            + adjoint_D_delta_z_1*forward_t32 - l_d_1*t261);
        gradient[53] =
            LANES(adjoint_D_delta_x_2*forward_t27 + adjoint_D_delta_y_2*forward_t30
            + adjoint_D_delta_z_2*forward_t33 - l_d_2*t260);
        gradient[54] =
            LANES(adjoint_D_delta_x_3*forward_t28 + adjoint_D_delta_y_3*forward_t31
            + adjoint_D_delta_z_3*forward_t34 - l_d_3*t259);
        gradient[55] =
            LANES((1.0/2.0)*adjoint_forward_t35 + (1.0/3.0)*adjoint_forward_t43
            + (1.0/6.0)*adjoint_forward_t44 + adjoint_forward_t96);
        gradient[56] =
            LANES((1.0/2.0)*adjoint_forward_t36 + (1.0/3.0)*adjoint_forward_t48
            + (1.0/6.0)*adjoint_forward_t57 + adjoint_forward_t96);
        gradient[57] =
            LANES((1.0/2.0)*adjoint_forward_t37 + (1.0/3.0)*adjoint_forward_t49
            + (1.0/6.0)*adjoint_forward_t61 + adjoint_forward_t96);
        gradient[58] = LANES(adjoint_k_1*(a_R_1 + 1.0));
        gradient[59] = LANES(adjoint_k_2*(a_R_2 + 1.0));
        gradient[60] = LANES(adjoint_k_3*(a_R_3 + 1.0));
        gradient[61] = LANES(adjoint_I_1*(i_g_1*i_g_1));
        gradient[62] = LANES(adjoint_I_2*(i_g_2*i_g_2));
        gradient[63] = LANES(adjoint_I_3*(i_g_3*i_g_3));
        gradient[64] = LANES(2.0*I_m_1*adjoint_I_1*i_g_1);
        gradient[65] = LANES(2.0*I_m_2*adjoint_I_2*i_g_2);
        gradient[66] = LANES(2.0*I_m_3*adjoint_I_3*i_g_3);
        gradient[76] = LANES(adjoint_k_1*k_r_1);
        gradient[77] = LANES(adjoint_k_2*k_r_2);
        gradient[78] = LANES(adjoint_k_3*k_r_3);
        gradient[79] =
            LANES(D_p_x_1*shape_10*t70 + D_p_x_2*shape_10*t46 + D_p_x_3*shape_10*t31 + D_p_y_1*shape_11*t70
            + D_p_y_2*shape_11*t46 + D_p_y_3*shape_11*t31 + D_p_z_1*shape_12*t70 + D_p_z_2*shape_12*t46
            + D_p_z_3*shape_12*t31 + t141 + t142 + t143 + t147 + t148 + t149 + t153 + t154 + t155 + t169
            + t171 + t173 + t174*t92 + t176*(forward_t142 + forward_t143 + forward_t144) + t178*(forward_t145
            + forward_t146 + forward_t147) + t181*t66 + t183*t45 + t30*(forward_t139 + forward_t140
            + forward_t141) + t33*(forward_t127 + forward_t129 + forward_t131) + t35*(forward_t133
            + forward_t134 + forward_t135) + t37*(forward_t136 + forward_t137 + forward_t138)
            + t47*(D_delta_x_3*D_p_x_2 + D_delta_y_3*D_p_y_2 + D_delta_z_3*D_p_z_2)
            + t49*(D_delta_x_1*D_p_x_2 + D_delta_y_1*D_p_y_2 + D_delta_z_1*D_p_z_2)
            + t51*(D_delta_x_2*D_p_x_2 + D_delta_y_2*D_p_y_2 + D_delta_z_2*D_p_z_2) + t54*(D_p_x_2*D_p_x_3
            + D_p_y_2*D_p_y_3 + D_p_z_2*D_p_z_3) + t68*(D_p_x_1*D_p_x_2 + D_p_y_1*D_p_y_2 + D_p_z_1*D_p_z_2)
            + t71*(D_delta_x_1*D_p_x_1 + D_delta_y_1*D_p_y_1 + D_delta_z_1*D_p_z_1)
            + t73*(D_delta_x_2*D_p_x_1 + D_delta_y_2*D_p_y_1 + D_delta_z_2*D_p_z_1)
            + t75*(D_delta_x_3*D_p_x_1 + D_delta_y_3*D_p_y_1 + D_delta_z_3*D_p_z_1) + t77*(D_p_x_1*D_p_x_3
            + D_p_y_1*D_p_y_3 + D_p_z_1*D_p_z_3) + t93 + t94 + t95);
        gradient[81] = LANES(adjoint_I_1 + adjoint_I_2 + adjoint_I_3);
        gradient[82] = LANES(adjoint_forward_t38);
        gradient[84] = LANES(t185 + t186 + t187);
        gradient[87] = LANES(adjoint_forward_t96);
        gradient[91] = LANES(adjoint_r_1_x + adjoint_r_2_x + adjoint_r_3_x);
        gradient[92] = LANES(adjoint_r_1_y + adjoint_r_2_y + adjoint_r_3_y);
        gradient[93] = LANES(adjoint_r_1_z + adjoint_r_2_z + adjoint_r_3_z);
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
 * 2799 operations; 99273177 with every named value expanded.
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
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double z_1_x = parameters[22];
    const double z_1_y = parameters[23];
    const double z_1_z = parameters[24];
    const double z_2_x = parameters[25];
    const double z_2_y = parameters[26];
    const double z_2_z = parameters[27];
    const double z_3_x = parameters[28];
    const double z_3_y = parameters[29];
    const double z_3_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double L_a_1 = parameters[40];
    const double L_a_2 = parameters[41];
    const double L_a_3 = parameters[42];
    const double m_a_1 = parameters[43];
    const double m_a_2 = parameters[44];
    const double m_a_3 = parameters[45];
    const double r_a_1 = parameters[46];
    const double r_a_2 = parameters[47];
    const double r_a_3 = parameters[48];
    const double l_d_1 = parameters[52];
    const double l_d_2 = parameters[53];
    const double l_d_3 = parameters[54];
    const double m_d_1 = parameters[55];
    const double m_d_2 = parameters[56];
    const double m_d_3 = parameters[57];
    const double k_r_1 = parameters[58];
    const double k_r_2 = parameters[59];
    const double k_r_3 = parameters[60];
    const double I_m_1 = parameters[61];
    const double I_m_2 = parameters[62];
    const double I_m_3 = parameters[63];
    const double i_g_1 = parameters[64];
    const double i_g_2 = parameters[65];
    const double i_g_3 = parameters[66];
    const double sigma_1 = parameters[73];
    const double sigma_2 = parameters[74];
    const double sigma_3 = parameters[75];
    const double a_R_1 = effects[0];
    const double a_R_2 = effects[1];
    const double a_R_3 = effects[2];
    const double k_C = effects[3];
    const double m_L = effects[6];
    const double y_1_x = a_1_y*z_1_z - a_1_z*z_1_y;
    const double y_1_y = -a_1_x*z_1_z + a_1_z*z_1_x;
    const double y_1_z = a_1_x*z_1_y - a_1_y*z_1_x;
    const double y_2_x = a_2_y*z_2_z - a_2_z*z_2_y;
    const double y_2_y = -a_2_x*z_2_z + a_2_z*z_2_x;
    const double y_2_z = a_2_x*z_2_y - a_2_y*z_2_x;
    const double y_3_x = a_3_y*z_3_z - a_3_z*z_3_y;
    const double y_3_y = -a_3_x*z_3_z + a_3_z*z_3_x;
    const double y_3_z = a_3_x*z_3_y - a_3_y*z_3_x;
    const lane r_1_x = b_1_x - o_1_x + p_x;
    const lane r_1_y = b_1_y - o_1_y + p_y;
    const lane r_1_z = b_1_z - o_1_z + p_z;
    const lane r_2_x = b_2_x - o_2_x + p_x;
    const lane r_2_y = b_2_y - o_2_y + p_y;
    const lane r_2_z = b_2_z - o_2_z + p_z;
    const lane r_3_x = b_3_x - o_3_x + p_x;
    const lane r_3_y = b_3_y - o_3_y + p_y;
    const lane r_3_z = b_3_z - o_3_z + p_z;
    const lane A_1 = r_1_x*z_1_x + r_1_y*z_1_y + r_1_z*z_1_z;
    const lane B_1 = r_1_x*y_1_x + r_1_y*y_1_y + r_1_z*y_1_z;
    const lane rho2_1 = (A_1*A_1) + (B_1*B_1);
    const double forward_t1 = (L_a_1*L_a_1);
    const double forward_0 = 1.0/L_a_1;
    const lane t1 = (r_1_x*r_1_x);
    const lane t2 = (r_1_y*r_1_y);
    const lane t3 = (r_1_z*r_1_z);
    const double t4 = (l_d_1*l_d_1);
    const double t5 = (1.0/2.0)*forward_0;
    const lane C_1 = t5*(forward_t1 + t1 + t2 + t3 - t4);
    const lane forward_1 = lanes_sqrt(-(C_1*C_1) + rho2_1);
    const lane S_1 = forward_1*sigma_1;
    const lane forward_2 = 1.0/rho2_1;
    const lane t6 = A_1*C_1 - B_1*S_1;
    const lane c_1 = forward_2*t6;
    const lane t7 = A_1*S_1 + B_1*C_1;
    const lane sn_1 = forward_2*t7;
    const lane A_2 = r_2_x*z_2_x + r_2_y*z_2_y + r_2_z*z_2_z;
    const lane B_2 = r_2_x*y_2_x + r_2_y*y_2_y + r_2_z*y_2_z;
    const lane rho2_2 = (A_2*A_2) + (B_2*B_2);
    const double forward_t3 = (L_a_2*L_a_2);
    const double forward_3 = 1.0/L_a_2;
    const lane t8 = (r_2_z*r_2_z);
    const double t9 = (l_d_2*l_d_2);
    const double t10 = (1.0/2.0)*forward_3;
    const lane t11 = (r_2_x*r_2_x);
    const lane t12 = (r_2_y*r_2_y);
    const lane C_2 = t10*(forward_t3 + t11 + t12 + t8 - t9);
    const lane forward_4 = lanes_sqrt(-(C_2*C_2) + rho2_2);
    const lane S_2 = forward_4*sigma_2;
    const lane forward_5 = 1.0/rho2_2;
    const lane t13 = A_2*C_2 - B_2*S_2;
    const lane c_2 = forward_5*t13;
    const lane t14 = A_2*S_2 + B_2*C_2;
    const lane sn_2 = forward_5*t14;
    const lane A_3 = r_3_x*z_3_x + r_3_y*z_3_y + r_3_z*z_3_z;
    const lane B_3 = r_3_x*y_3_x + r_3_y*y_3_y + r_3_z*y_3_z;
    const lane rho2_3 = (A_3*A_3) + (B_3*B_3);
    const double forward_t5 = (L_a_3*L_a_3);
    const double forward_6 = 1.0/L_a_3;
    const lane t15 = (r_3_x*r_3_x);
    const lane t16 = (r_3_y*r_3_y);
    const lane t17 = (r_3_z*r_3_z);
    const double t18 = (l_d_3*l_d_3);
    const double t19 = (1.0/2.0)*forward_6;
    const lane C_3 = t19*(forward_t5 + t15 + t16 + t17 - t18);
    const lane forward_7 = lanes_sqrt(-(C_3*C_3) + rho2_3);
    const lane S_3 = forward_7*sigma_3;
    const lane forward_8 = 1.0/rho2_3;
    const lane t20 = A_3*C_3 - B_3*S_3;
    const lane c_3 = forward_8*t20;
    const lane t21 = A_3*S_3 + B_3*C_3;
    const lane sn_3 = forward_8*t21;
    const lane d_1_x = c_1*z_1_x + sn_1*y_1_x;
    const lane d_1_y = c_1*z_1_y + sn_1*y_1_y;
    const lane d_1_z = c_1*z_1_z + sn_1*y_1_z;
    const lane t_1_x = c_1*y_1_x - sn_1*z_1_x;
    const lane t_1_y = c_1*y_1_y - sn_1*z_1_y;
    const lane t_1_z = c_1*y_1_z - sn_1*z_1_z;
    const lane d_2_x = c_2*z_2_x + sn_2*y_2_x;
    const lane d_2_y = c_2*z_2_y + sn_2*y_2_y;
    const lane d_2_z = c_2*z_2_z + sn_2*y_2_z;
    const lane t_2_x = c_2*y_2_x - sn_2*z_2_x;
    const lane t_2_y = c_2*y_2_y - sn_2*z_2_y;
    const lane t_2_z = c_2*y_2_z - sn_2*z_2_z;
    const lane d_3_x = c_3*z_3_x + sn_3*y_3_x;
    const lane d_3_y = c_3*z_3_y + sn_3*y_3_y;
    const lane d_3_z = c_3*z_3_z + sn_3*y_3_z;
    const lane t_3_x = c_3*y_3_x - sn_3*z_3_x;
    const lane t_3_y = c_3*y_3_y - sn_3*z_3_y;
    const lane t_3_z = c_3*y_3_z - sn_3*z_3_z;
    const lane forward_t7 = L_a_1*d_1_x;
    const lane s_1_x = -forward_t7 + r_1_x;
    const lane forward_t8 = L_a_1*d_1_y;
    const lane s_1_y = -forward_t8 + r_1_y;
    const lane forward_t9 = L_a_1*d_1_z;
    const lane s_1_z = -forward_t9 + r_1_z;
    const lane forward_t10 = L_a_2*d_2_x;
    const lane s_2_x = -forward_t10 + r_2_x;
    const lane forward_t11 = L_a_2*d_2_y;
    const lane s_2_y = -forward_t11 + r_2_y;
    const lane forward_t12 = L_a_2*d_2_z;
    const lane s_2_z = -forward_t12 + r_2_z;
    const lane forward_t13 = L_a_3*d_3_x;
    const lane s_3_x = -forward_t13 + r_3_x;
    const lane forward_t14 = L_a_3*d_3_y;
    const lane s_3_y = -forward_t14 + r_3_y;
    const lane forward_t15 = L_a_3*d_3_z;
    const lane s_3_z = -forward_t15 + r_3_z;
    const lane forward_t16 = L_a_1*t_1_x;
    const lane forward_t17 = L_a_1*t_1_y;
    const lane forward_t18 = L_a_1*t_1_z;
    const lane D_r_1 = forward_t16*s_1_x + forward_t17*s_1_y + forward_t18*s_1_z;
    const lane forward_t19 = L_a_2*t_2_x;
    const lane forward_t20 = L_a_2*t_2_y;
    const lane forward_t21 = L_a_2*t_2_z;
    const lane D_r_2 = forward_t19*s_2_x + forward_t20*s_2_y + forward_t21*s_2_z;
    const lane forward_t22 = L_a_3*t_3_x;
    const lane forward_t23 = L_a_3*t_3_y;
    const lane forward_t24 = L_a_3*t_3_z;
    const lane D_r_3 = forward_t22*s_3_x + forward_t23*s_3_y + forward_t24*s_3_z;
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
    const lane forward_9 = 1.0/det_D_l;
    const lane forward_t26 = A_x_1*forward_9;
    const lane D_p_x_1 = D_r_1*forward_t26;
    const lane forward_t27 = A_x_2*forward_9;
    const lane D_p_x_2 = D_r_2*forward_t27;
    const lane forward_t28 = A_x_3*forward_9;
    const lane D_p_x_3 = D_r_3*forward_t28;
    const lane D_delta_x_1 = forward_t26*l_d_1;
    const lane D_delta_x_2 = forward_t27*l_d_2;
    const lane D_delta_x_3 = forward_t28*l_d_3;
    const lane forward_t29 = A_y_1*forward_9;
    const lane D_p_y_1 = D_r_1*forward_t29;
    const lane forward_t30 = A_y_2*forward_9;
    const lane D_p_y_2 = D_r_2*forward_t30;
    const lane forward_t31 = A_y_3*forward_9;
    const lane D_p_y_3 = D_r_3*forward_t31;
    const lane D_delta_y_1 = forward_t29*l_d_1;
    const lane D_delta_y_2 = forward_t30*l_d_2;
    const lane D_delta_y_3 = forward_t31*l_d_3;
    const lane forward_t32 = A_z_1*forward_9;
    const lane D_p_z_1 = D_r_1*forward_t32;
    const lane forward_t33 = A_z_2*forward_9;
    const lane D_p_z_2 = D_r_2*forward_t33;
    const lane forward_t34 = A_z_3*forward_9;
    const lane D_p_z_3 = D_r_3*forward_t34;
    const lane D_delta_z_1 = forward_t32*l_d_1;
    const lane D_delta_z_2 = forward_t33*l_d_2;
    const lane D_delta_z_3 = forward_t34*l_d_3;
    const lane U_1_x_1 = D_p_x_1 - forward_t16;
    const lane U_1_y_1 = D_p_y_1 - forward_t17;
    const lane U_1_z_1 = D_p_z_1 - forward_t18;
    const lane U_2_x_2 = D_p_x_2 - forward_t19;
    const lane U_2_y_2 = D_p_y_2 - forward_t20;
    const lane U_2_z_2 = D_p_z_2 - forward_t21;
    const lane U_3_x_3 = D_p_x_3 - forward_t22;
    const lane U_3_y_3 = D_p_y_3 - forward_t23;
    const lane U_3_z_3 = D_p_z_3 - forward_t24;
    const double forward_t35 = (1.0/2.0)*m_d_1;
    const double forward_t36 = (1.0/2.0)*m_d_2;
    const double forward_t37 = (1.0/2.0)*m_d_3;
    const double forward_t38 = m_L + m_p;
    const double forward_t39 = forward_t35 + forward_t36 + forward_t37 + forward_t38;
    const double forward_t40 = forward_t39*g_x;
    const double forward_t41 = forward_t39*g_y;
    const double forward_t42 = forward_t39*g_z;
    const lane t22 = -A_x_1*forward_t40 - A_y_1*forward_t41 - A_z_1*forward_t42;
    const lane mu_1 = forward_9*t22;
    const lane t23 = -A_x_2*forward_t40 - A_y_2*forward_t41 - A_z_2*forward_t42;
    const lane mu_2 = forward_9*t23;
    const lane t24 = -A_x_3*forward_t40 - A_y_3*forward_t41 - A_z_3*forward_t42;
    const lane mu_3 = forward_9*t24;
    const double forward_t43 = (1.0/3.0)*m_d_1;
    const double forward_t44 = (1.0/6.0)*m_d_1;
    const lane forward_t45 = forward_t16*forward_t44;
    const lane forward_t46 = forward_t17*forward_t44;
    const lane forward_t47 = forward_t18*forward_t44;
    const double forward_t48 = (1.0/3.0)*m_d_2;
    const double forward_t49 = (1.0/3.0)*m_d_3;
    const double forward_t50 = forward_t38 + forward_t43 + forward_t48 + forward_t49;
    const lane forward_t51 = D_p_x_1*forward_t50;
    const lane forward_t52 = forward_t45 + forward_t51;
    const lane forward_t53 = D_p_y_1*forward_t50;
    const lane forward_t54 = forward_t46 + forward_t53;
    const lane forward_t55 = D_p_z_1*forward_t50;
    const lane forward_t56 = forward_t47 + forward_t55;
    const double forward_t57 = (1.0/6.0)*m_d_2;
    const lane forward_t58 = forward_t19*forward_t57;
    const lane forward_t59 = forward_t20*forward_t57;
    const lane forward_t60 = forward_t21*forward_t57;
    const double forward_t61 = (1.0/6.0)*m_d_3;
    const lane forward_t62 = forward_t22*forward_t61;
    const lane forward_t63 = forward_t23*forward_t61;
    const lane forward_t64 = forward_t24*forward_t61;
    const double forward_t65 = m_a_1*r_a_1;
    const double forward_t66 = forward_t44 + forward_t57 + forward_t61;
    const lane forward_t67 = D_p_x_2*forward_t50;
    const lane forward_t68 = forward_t58 + forward_t67;
    const lane forward_t69 = D_p_y_2*forward_t50;
    const lane forward_t70 = forward_t59 + forward_t69;
    const lane forward_t71 = D_p_z_2*forward_t50;
    const lane forward_t72 = forward_t60 + forward_t71;
    const double forward_t73 = m_a_2*r_a_2;
    const lane forward_t74 = D_p_x_3*forward_t50;
    const lane forward_t75 = forward_t62 + forward_t74;
    const lane forward_t76 = D_p_y_3*forward_t50;
    const lane forward_t77 = forward_t63 + forward_t76;
    const lane forward_t78 = D_p_z_3*forward_t50;
    const lane forward_t79 = forward_t64 + forward_t78;
    const double forward_t80 = m_a_3*r_a_3;
    const lane forward_t81 = (D_delta_x_1*D_delta_x_1);
    const lane forward_t82 = (D_delta_y_1*D_delta_y_1);
    const lane forward_t83 = (D_delta_z_1*D_delta_z_1);
    const lane forward_t84 = D_delta_x_1*forward_t50;
    const lane forward_t85 = D_delta_y_1*forward_t50;
    const lane forward_t86 = D_delta_z_1*forward_t50;
    const lane forward_t87 = (D_delta_x_2*D_delta_x_2);
    const lane forward_t88 = (D_delta_y_2*D_delta_y_2);
    const lane forward_t89 = (D_delta_z_2*D_delta_z_2);
    const lane forward_t90 = D_delta_x_2*forward_t50;
    const lane forward_t91 = D_delta_y_2*forward_t50;
    const lane forward_t92 = D_delta_z_2*forward_t50;
    const lane forward_t93 = (D_delta_x_3*D_delta_x_3);
    const lane forward_t94 = (D_delta_y_3*D_delta_y_3);
    const lane forward_t95 = (D_delta_z_3*D_delta_z_3);
    const double forward_t97 = L_a_1*forward_t35 + forward_t65;
    const lane forward_t98 = (D_p_x_1*D_p_x_1);
    const lane forward_t99 = (D_p_y_1*D_p_y_1);
    const lane forward_t100 = (D_p_z_1*D_p_z_1);
    const lane forward_t101 = D_p_x_1*mu_3;
    const lane forward_t102 = D_p_x_1*mu_2;
    const lane forward_t103 = U_1_x_1*mu_1;
    const lane forward_t104 = D_p_y_1*mu_3;
    const lane forward_t105 = D_p_y_1*mu_2;
    const lane forward_t106 = U_1_y_1*mu_1;
    const lane forward_t107 = D_p_z_1*mu_3;
    const lane forward_t108 = D_p_z_1*mu_2;
    const lane forward_t109 = U_1_z_1*mu_1;
    const lane forward_t110 = (D_p_x_2*D_p_x_2);
    const lane forward_t111 = (D_p_y_2*D_p_y_2);
    const lane forward_t112 = (D_p_z_2*D_p_z_2);
    const double forward_t113 = L_a_2*forward_t36 + forward_t73;
    const lane forward_t114 = D_p_x_2*mu_1;
    const lane forward_t115 = D_p_x_2*mu_3;
    const lane forward_t116 = U_2_x_2*mu_2;
    const lane forward_t117 = D_p_y_2*mu_1;
    const lane forward_t118 = D_p_y_2*mu_3;
    const lane forward_t119 = U_2_y_2*mu_2;
    const lane forward_t120 = D_p_z_2*mu_1;
    const lane forward_t121 = D_p_z_2*mu_3;
    const lane forward_t122 = U_2_z_2*mu_2;
    const lane forward_t123 = (D_p_x_3*D_p_x_3);
    const lane forward_t124 = (D_p_y_3*D_p_y_3);
    const lane forward_t125 = (D_p_z_3*D_p_z_3);
    const double forward_t126 = L_a_3*forward_t37 + forward_t80;
    const lane forward_t127 = D_delta_x_1*D_p_x_3;
    const lane forward_t128 = U_3_x_3*mu_3;
    const lane forward_t129 = D_delta_y_1*D_p_y_3;
    const lane forward_t130 = U_3_y_3*mu_3;
    const lane forward_t131 = D_delta_z_1*D_p_z_3;
    const lane forward_t132 = U_3_z_3*mu_3;
    const lane forward_t133 = D_delta_x_2*D_p_x_3;
    const lane forward_t134 = D_delta_y_2*D_p_y_3;
    const lane forward_t135 = D_delta_z_2*D_p_z_3;
    const lane forward_t136 = D_delta_x_3*D_p_x_3;
    const lane forward_t137 = D_delta_y_3*D_p_y_3;
    const lane forward_t138 = D_delta_z_3*D_p_z_3;
    const lane forward_t139 = D_delta_x_1*D_delta_x_2;
    const lane forward_t140 = D_delta_y_1*D_delta_y_2;
    const lane forward_t141 = D_delta_z_1*D_delta_z_2;
    const lane forward_t142 = D_delta_x_1*D_delta_x_3;
    const lane forward_t143 = D_delta_y_1*D_delta_y_3;
    const lane forward_t144 = D_delta_z_1*D_delta_z_3;
    const lane forward_t145 = D_delta_x_2*D_delta_x_3;
    const lane forward_t146 = D_delta_y_2*D_delta_y_3;
    const lane forward_t147 = D_delta_z_2*D_delta_z_3;
    const lane t25 = 1.0/forward_1;
    const lane t26 = A_1*forward_2;
    const lane t27 = C_1*forward_2;
    const lane t28 = B_1*forward_2;
    const lane t29 = S_1*forward_2;
    const lane t30 = 1.0/forward_4;
    const lane t31 = A_2*forward_5;
    const lane t32 = C_2*forward_5;
    const lane t33 = B_2*forward_5;
    const lane t34 = S_2*forward_5;
    const lane t35 = 1.0/forward_7;
    const lane t36 = A_3*forward_8;
    const lane t37 = C_3*forward_8;
    const lane t38 = B_3*forward_8;
    const lane t39 = S_3*forward_8;
    const lane t76 = forward_t81 + forward_t82 + forward_t83;
    const lane t77 = forward_t87 + forward_t88 + forward_t89;
    const lane t78 = forward_t93 + forward_t94 + forward_t95;
    const double t79 = forward_t50 + forward_t66;
    const lane t80 = forward_t100 + forward_t98 + forward_t99;
    const lane t81 = -k_C + mu_3;
    const lane t82 = -mu_2 - t81;
    const lane t83 = -D_p_x_1*k_C + forward_t103;
    const lane t84 = forward_t101 + t83;
    const lane t85 = -D_p_y_1*k_C + forward_t106;
    const lane t86 = forward_t104 + t85;
    const lane t87 = -D_p_z_1*k_C + forward_t109;
    const lane t88 = forward_t107 + t87;
    const lane t89 = -forward_t102 - t84;
    const lane t90 = -forward_t105 - t86;
    const lane t91 = -forward_t108 - t88;
    const lane t92 = forward_t110 + forward_t111 + forward_t112;
    const lane t93 = -mu_1 - t81;
    const lane t94 = -D_p_x_2*k_C + forward_t114 + forward_t116;
    const lane t95 = -D_p_y_2*k_C + forward_t117 + forward_t119;
    const lane t96 = -D_p_z_2*k_C + forward_t120 + forward_t122;
    const lane t97 = -forward_t115 - t94;
    const lane t98 = -forward_t118 - t95;
    const lane t99 = -forward_t121 - t96;
    const lane t100 = forward_t123 + forward_t124 + forward_t125;
    const lane t101 = mu_1 + mu_2;
    const lane t102 = k_C - t101;
    const lane t103 = D_p_x_3*k_C - forward_t128;
    const lane t104 = D_p_y_3*k_C - forward_t130;
    const lane t105 = D_p_z_3*k_C - forward_t132;
    const lane t106 = -forward_t127 - forward_t129 - forward_t131;
    const lane t107 = -forward_t133 - forward_t134 - forward_t135;
    const lane t108 = -forward_t136 - forward_t137 - forward_t138;
    const lane t109 = -t101 - t81;
    const lane t110 = -mu_3 - t101;
    const lane t111 = -forward_t139 - forward_t140 - forward_t141;
    const lane t112 = -forward_t142 - forward_t143 - forward_t144;
    const lane t113 = -forward_t145 - forward_t146 - forward_t147;
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
        const lane along_62 = direction[61];
        const lane along_63 = direction[62];
        const lane along_64 = direction[63];
        const lane along_65 = direction[64];
        const lane along_66 = direction[65];
        const lane along_67 = direction[66];
        const lane along_77 = direction[76];
        const lane along_78 = direction[77];
        const lane along_79 = direction[78];
        const lane along_80 = direction[79];
        const lane along_82 = direction[81];
        const lane along_83 = direction[82];
        const lane along_85 = direction[84];
        const lane along_88 = direction[87];
        const lane along_92 = direction[91];
        const lane along_93 = direction[92];
        const lane along_94 = direction[93];
        const lane tangent_r_1_x = along_32 - along_5 + along_92;
        const lane tangent_r_1_y = along_33 - along_6 + along_93;
        const lane tangent_r_1_z = along_34 - along_7 + along_94;
        const lane tangent_r_2_x = along_35 - along_8 + along_92;
        const lane tangent_r_2_y = along_36 - along_9 + along_93;
        const lane tangent_r_2_z = -along_10 + along_37 + along_94;
        const lane tangent_r_3_x = -along_11 + along_38 + along_92;
        const lane tangent_r_3_y = -along_12 + along_39 + along_93;
        const lane tangent_r_3_z = -along_13 + along_40 + along_94;
        const lane tangent_A_1 = tangent_r_1_x*z_1_x + tangent_r_1_y*z_1_y + tangent_r_1_z*z_1_z;
        const lane tangent_B_1 = tangent_r_1_x*y_1_x + tangent_r_1_y*y_1_y + tangent_r_1_z*y_1_z;
        const lane tangent_rho2_1 = 2.0*A_1*tangent_A_1 + 2.0*B_1*tangent_B_1;
        const lane tangent_forward_t1 = 2.0*L_a_1*along_41;
        const lane tangent_forward_0 = -along_41*(forward_0*forward_0);
        const lane tangent_C_1 =
            -along_53*forward_0*l_d_1 + forward_0*r_1_x*tangent_r_1_x + forward_0*r_1_y*tangent_r_1_y
            + forward_0*r_1_z*tangent_r_1_z + t5*tangent_forward_t1 + tangent_forward_0*((1.0/2.0)*forward_t1
            + (1.0/2.0)*t1 + (1.0/2.0)*t2 + (1.0/2.0)*t3 - 1.0/2.0*t4);
        const lane tangent_forward_1 = -C_1*t25*tangent_C_1 + (1.0/2.0)*t25*tangent_rho2_1;
        const lane tangent_S_1 = sigma_1*tangent_forward_1;
        const lane tangent_forward_2 = -(forward_2*forward_2)*tangent_rho2_1;
        const lane tangent_c_1 =
            t26*tangent_C_1 + t27*tangent_A_1 - t28*tangent_S_1 - t29*tangent_B_1 + t6*tangent_forward_2;
        const lane tangent_sn_1 =
            t26*tangent_S_1 + t27*tangent_B_1 + t28*tangent_C_1 + t29*tangent_A_1 + t7*tangent_forward_2;
        const lane tangent_A_2 = tangent_r_2_x*z_2_x + tangent_r_2_y*z_2_y + tangent_r_2_z*z_2_z;
        const lane tangent_B_2 = tangent_r_2_x*y_2_x + tangent_r_2_y*y_2_y + tangent_r_2_z*y_2_z;
        const lane tangent_rho2_2 = 2.0*A_2*tangent_A_2 + 2.0*B_2*tangent_B_2;
        const lane tangent_forward_t3 = 2.0*L_a_2*along_42;
        const lane tangent_forward_3 = -along_42*(forward_3*forward_3);
        const lane tangent_C_2 =
            -along_54*forward_3*l_d_2 + forward_3*r_2_x*tangent_r_2_x + forward_3*r_2_y*tangent_r_2_y
            + forward_3*r_2_z*tangent_r_2_z + t10*tangent_forward_t3
            + tangent_forward_3*((1.0/2.0)*forward_t3 + (1.0/2.0)*t11 + (1.0/2.0)*t12 + (1.0/2.0)*t8
            - 1.0/2.0*t9);
        const lane tangent_forward_4 = -C_2*t30*tangent_C_2 + (1.0/2.0)*t30*tangent_rho2_2;
        const lane tangent_S_2 = sigma_2*tangent_forward_4;
        const lane tangent_forward_5 = -(forward_5*forward_5)*tangent_rho2_2;
        const lane tangent_c_2 =
            t13*tangent_forward_5 + t31*tangent_C_2 + t32*tangent_A_2 - t33*tangent_S_2 - t34*tangent_B_2;
        const lane tangent_sn_2 =
            t14*tangent_forward_5 + t31*tangent_S_2 + t32*tangent_B_2 + t33*tangent_C_2 + t34*tangent_A_2;
        const lane tangent_A_3 = tangent_r_3_x*z_3_x + tangent_r_3_y*z_3_y + tangent_r_3_z*z_3_z;
        const lane tangent_B_3 = tangent_r_3_x*y_3_x + tangent_r_3_y*y_3_y + tangent_r_3_z*y_3_z;
        const lane tangent_rho2_3 = 2.0*A_3*tangent_A_3 + 2.0*B_3*tangent_B_3;
        const lane tangent_forward_t5 = 2.0*L_a_3*along_43;
        const lane tangent_forward_6 = -along_43*(forward_6*forward_6);
        const lane tangent_C_3 =
            -along_55*forward_6*l_d_3 + forward_6*r_3_x*tangent_r_3_x + forward_6*r_3_y*tangent_r_3_y
            + forward_6*r_3_z*tangent_r_3_z + t19*tangent_forward_t5
            + tangent_forward_6*((1.0/2.0)*forward_t5 + (1.0/2.0)*t15 + (1.0/2.0)*t16 + (1.0/2.0)*t17
            - 1.0/2.0*t18);
        const lane tangent_forward_7 = -C_3*t35*tangent_C_3 + (1.0/2.0)*t35*tangent_rho2_3;
        const lane tangent_S_3 = sigma_3*tangent_forward_7;
        const lane tangent_forward_8 = -(forward_8*forward_8)*tangent_rho2_3;
        const lane tangent_c_3 =
            t20*tangent_forward_8 + t36*tangent_C_3 + t37*tangent_A_3 - t38*tangent_S_3 - t39*tangent_B_3;
        const lane tangent_sn_3 =
            t21*tangent_forward_8 + t36*tangent_S_3 + t37*tangent_B_3 + t38*tangent_C_3 + t39*tangent_A_3;
        const lane tangent_d_1_x = tangent_c_1*z_1_x + tangent_sn_1*y_1_x;
        const lane tangent_d_1_y = tangent_c_1*z_1_y + tangent_sn_1*y_1_y;
        const lane tangent_d_1_z = tangent_c_1*z_1_z + tangent_sn_1*y_1_z;
        const lane tangent_t_1_x = tangent_c_1*y_1_x - tangent_sn_1*z_1_x;
        const lane tangent_t_1_y = tangent_c_1*y_1_y - tangent_sn_1*z_1_y;
        const lane tangent_t_1_z = tangent_c_1*y_1_z - tangent_sn_1*z_1_z;
        const lane tangent_d_2_x = tangent_c_2*z_2_x + tangent_sn_2*y_2_x;
        const lane tangent_d_2_y = tangent_c_2*z_2_y + tangent_sn_2*y_2_y;
        const lane tangent_d_2_z = tangent_c_2*z_2_z + tangent_sn_2*y_2_z;
        const lane tangent_t_2_x = tangent_c_2*y_2_x - tangent_sn_2*z_2_x;
        const lane tangent_t_2_y = tangent_c_2*y_2_y - tangent_sn_2*z_2_y;
        const lane tangent_t_2_z = tangent_c_2*y_2_z - tangent_sn_2*z_2_z;
        const lane tangent_d_3_x = tangent_c_3*z_3_x + tangent_sn_3*y_3_x;
        const lane tangent_d_3_y = tangent_c_3*z_3_y + tangent_sn_3*y_3_y;
        const lane tangent_d_3_z = tangent_c_3*z_3_z + tangent_sn_3*y_3_z;
        const lane tangent_t_3_x = tangent_c_3*y_3_x - tangent_sn_3*z_3_x;
        const lane tangent_t_3_y = tangent_c_3*y_3_y - tangent_sn_3*z_3_y;
        const lane tangent_t_3_z = tangent_c_3*y_3_z - tangent_sn_3*z_3_z;
        const lane tangent_forward_t7 = L_a_1*tangent_d_1_x + along_41*d_1_x;
        const lane tangent_s_1_x = -tangent_forward_t7 + tangent_r_1_x;
        const lane tangent_forward_t8 = L_a_1*tangent_d_1_y + along_41*d_1_y;
        const lane tangent_s_1_y = -tangent_forward_t8 + tangent_r_1_y;
        const lane tangent_forward_t9 = L_a_1*tangent_d_1_z + along_41*d_1_z;
        const lane tangent_s_1_z = -tangent_forward_t9 + tangent_r_1_z;
        const lane tangent_forward_t10 = L_a_2*tangent_d_2_x + along_42*d_2_x;
        const lane tangent_s_2_x = -tangent_forward_t10 + tangent_r_2_x;
        const lane tangent_forward_t11 = L_a_2*tangent_d_2_y + along_42*d_2_y;
        const lane tangent_s_2_y = -tangent_forward_t11 + tangent_r_2_y;
        const lane tangent_forward_t12 = L_a_2*tangent_d_2_z + along_42*d_2_z;
        const lane tangent_s_2_z = -tangent_forward_t12 + tangent_r_2_z;
        const lane tangent_forward_t13 = L_a_3*tangent_d_3_x + along_43*d_3_x;
        const lane tangent_s_3_x = -tangent_forward_t13 + tangent_r_3_x;
        const lane tangent_forward_t14 = L_a_3*tangent_d_3_y + along_43*d_3_y;
        const lane tangent_s_3_y = -tangent_forward_t14 + tangent_r_3_y;
        const lane tangent_forward_t15 = L_a_3*tangent_d_3_z + along_43*d_3_z;
        const lane tangent_s_3_z = -tangent_forward_t15 + tangent_r_3_z;
        const lane tangent_forward_t16 = L_a_1*tangent_t_1_x + along_41*t_1_x;
        const lane tangent_forward_t17 = L_a_1*tangent_t_1_y + along_41*t_1_y;
        const lane tangent_forward_t18 = L_a_1*tangent_t_1_z + along_41*t_1_z;
        const lane tangent_D_r_1 =
            forward_t16*tangent_s_1_x + forward_t17*tangent_s_1_y + forward_t18*tangent_s_1_z
            + s_1_x*tangent_forward_t16 + s_1_y*tangent_forward_t17 + s_1_z*tangent_forward_t18;
        const lane tangent_forward_t19 = L_a_2*tangent_t_2_x + along_42*t_2_x;
        const lane tangent_forward_t20 = L_a_2*tangent_t_2_y + along_42*t_2_y;
        const lane tangent_forward_t21 = L_a_2*tangent_t_2_z + along_42*t_2_z;
        const lane tangent_D_r_2 =
            forward_t19*tangent_s_2_x + forward_t20*tangent_s_2_y + forward_t21*tangent_s_2_z
            + s_2_x*tangent_forward_t19 + s_2_y*tangent_forward_t20 + s_2_z*tangent_forward_t21;
        const lane tangent_forward_t22 = L_a_3*tangent_t_3_x + along_43*t_3_x;
        const lane tangent_forward_t23 = L_a_3*tangent_t_3_y + along_43*t_3_y;
        const lane tangent_forward_t24 = L_a_3*tangent_t_3_z + along_43*t_3_z;
        const lane tangent_D_r_3 =
            forward_t22*tangent_s_3_x + forward_t23*tangent_s_3_y + forward_t24*tangent_s_3_z
            + s_3_x*tangent_forward_t22 + s_3_y*tangent_forward_t23 + s_3_z*tangent_forward_t24;
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
        const lane tangent_forward_9 = -(forward_9*forward_9)*tangent_det_D_l;
        const lane t40 = forward_9*tangent_A_x_1;
        const lane tangent_forward_t26 = A_x_1*tangent_forward_9 + t40;
        const lane tangent_D_p_x_1 = D_r_1*tangent_forward_t26 + forward_t26*tangent_D_r_1;
        const lane t41 = forward_9*tangent_A_x_2;
        const lane tangent_forward_t27 = A_x_2*tangent_forward_9 + t41;
        const lane tangent_D_p_x_2 = D_r_2*tangent_forward_t27 + forward_t27*tangent_D_r_2;
        const lane t42 = forward_9*tangent_A_x_3;
        const lane tangent_forward_t28 = A_x_3*tangent_forward_9 + t42;
        const lane tangent_D_p_x_3 = D_r_3*tangent_forward_t28 + forward_t28*tangent_D_r_3;
        const lane tangent_D_delta_x_1 = along_53*forward_t26 + l_d_1*tangent_forward_t26;
        const lane tangent_D_delta_x_2 = along_54*forward_t27 + l_d_2*tangent_forward_t27;
        const lane tangent_D_delta_x_3 = along_55*forward_t28 + l_d_3*tangent_forward_t28;
        const lane t43 = forward_9*tangent_A_y_1;
        const lane tangent_forward_t29 = A_y_1*tangent_forward_9 + t43;
        const lane tangent_D_p_y_1 = D_r_1*tangent_forward_t29 + forward_t29*tangent_D_r_1;
        const lane t44 = forward_9*tangent_A_y_2;
        const lane tangent_forward_t30 = A_y_2*tangent_forward_9 + t44;
        const lane tangent_D_p_y_2 = D_r_2*tangent_forward_t30 + forward_t30*tangent_D_r_2;
        const lane t45 = forward_9*tangent_A_y_3;
        const lane tangent_forward_t31 = A_y_3*tangent_forward_9 + t45;
        const lane tangent_D_p_y_3 = D_r_3*tangent_forward_t31 + forward_t31*tangent_D_r_3;
        const lane tangent_D_delta_y_1 = along_53*forward_t29 + l_d_1*tangent_forward_t29;
        const lane tangent_D_delta_y_2 = along_54*forward_t30 + l_d_2*tangent_forward_t30;
        const lane tangent_D_delta_y_3 = along_55*forward_t31 + l_d_3*tangent_forward_t31;
        const lane t46 = forward_9*tangent_A_z_1;
        const lane tangent_forward_t32 = A_z_1*tangent_forward_9 + t46;
        const lane tangent_D_p_z_1 = D_r_1*tangent_forward_t32 + forward_t32*tangent_D_r_1;
        const lane t47 = forward_9*tangent_A_z_2;
        const lane tangent_forward_t33 = A_z_2*tangent_forward_9 + t47;
        const lane tangent_D_p_z_2 = D_r_2*tangent_forward_t33 + forward_t33*tangent_D_r_2;
        const lane t48 = forward_9*tangent_A_z_3;
        const lane tangent_forward_t34 = A_z_3*tangent_forward_9 + t48;
        const lane tangent_D_p_z_3 = D_r_3*tangent_forward_t34 + forward_t34*tangent_D_r_3;
        const lane tangent_D_delta_z_1 = along_53*forward_t32 + l_d_1*tangent_forward_t32;
        const lane tangent_D_delta_z_2 = along_54*forward_t33 + l_d_2*tangent_forward_t33;
        const lane tangent_D_delta_z_3 = along_55*forward_t34 + l_d_3*tangent_forward_t34;
        const lane tangent_U_1_x_1 = tangent_D_p_x_1 - tangent_forward_t16;
        const lane tangent_U_1_y_1 = tangent_D_p_y_1 - tangent_forward_t17;
        const lane tangent_U_1_z_1 = tangent_D_p_z_1 - tangent_forward_t18;
        const lane tangent_U_2_x_2 = tangent_D_p_x_2 - tangent_forward_t19;
        const lane tangent_U_2_y_2 = tangent_D_p_y_2 - tangent_forward_t20;
        const lane tangent_U_2_z_2 = tangent_D_p_z_2 - tangent_forward_t21;
        const lane tangent_U_3_x_3 = tangent_D_p_x_3 - tangent_forward_t22;
        const lane tangent_U_3_y_3 = tangent_D_p_y_3 - tangent_forward_t23;
        const lane tangent_U_3_z_3 = tangent_D_p_z_3 - tangent_forward_t24;
        const lane tangent_I_1 = 2.0*I_m_1*along_65*i_g_1 + along_62*(i_g_1*i_g_1) + along_82;
        const lane tangent_I_2 = 2.0*I_m_2*along_66*i_g_2 + along_63*(i_g_2*i_g_2) + along_82;
        const lane tangent_I_3 = 2.0*I_m_3*along_67*i_g_3 + along_64*(i_g_3*i_g_3) + along_82;
        const lane tangent_k_1 = along_59*(a_R_1 + 1.0) + along_77*k_r_1;
        const lane tangent_k_2 = along_60*(a_R_2 + 1.0) + along_78*k_r_2;
        const lane tangent_k_3 = along_61*(a_R_3 + 1.0) + along_79*k_r_3;
        const lane tangent_forward_t35 = (1.0/2.0)*along_56;
        const lane tangent_forward_t36 = (1.0/2.0)*along_57;
        const lane tangent_forward_t37 = (1.0/2.0)*along_58;
        const lane tangent_forward_t38 = along_1 + along_83;
        const lane tangent_forward_t39 =
            tangent_forward_t35 + tangent_forward_t36 + tangent_forward_t37 + tangent_forward_t38;
        const lane tangent_forward_t40 = along_2*forward_t39 + g_x*tangent_forward_t39;
        const lane tangent_forward_t41 = along_3*forward_t39 + g_y*tangent_forward_t39;
        const lane tangent_forward_t42 = along_4*forward_t39 + g_z*tangent_forward_t39;
        const lane tangent_mu_1 =
            -forward_t26*tangent_forward_t40 - forward_t29*tangent_forward_t41
            - forward_t32*tangent_forward_t42 - forward_t40*t40 - forward_t41*t43 - forward_t42*t46
            + t22*tangent_forward_9;
        const lane tangent_mu_2 =
            -forward_t27*tangent_forward_t40 - forward_t30*tangent_forward_t41
            - forward_t33*tangent_forward_t42 - forward_t40*t41 - forward_t41*t44 - forward_t42*t47
            + t23*tangent_forward_9;
        const lane tangent_mu_3 =
            -forward_t28*tangent_forward_t40 - forward_t31*tangent_forward_t41
            - forward_t34*tangent_forward_t42 - forward_t40*t42 - forward_t41*t45 - forward_t42*t48
            + t24*tangent_forward_9;
        const lane tangent_forward_t43 = (1.0/3.0)*along_56;
        const lane tangent_forward_t44 = (1.0/6.0)*along_56;
        const lane tangent_forward_t45 = forward_t16*tangent_forward_t44 + forward_t44*tangent_forward_t16;
        const lane tangent_forward_t46 = forward_t17*tangent_forward_t44 + forward_t44*tangent_forward_t17;
        const lane tangent_forward_t47 = forward_t18*tangent_forward_t44 + forward_t44*tangent_forward_t18;
        const lane tangent_forward_t48 = (1.0/3.0)*along_57;
        const lane tangent_forward_t49 = (1.0/3.0)*along_58;
        const lane tangent_forward_t50 =
            tangent_forward_t38 + tangent_forward_t43 + tangent_forward_t48 + tangent_forward_t49;
        const lane tangent_forward_t51 = D_p_x_1*tangent_forward_t50 + forward_t50*tangent_D_p_x_1;
        const lane tangent_forward_t52 = tangent_forward_t45 + tangent_forward_t51;
        const lane tangent_forward_t53 = D_p_y_1*tangent_forward_t50 + forward_t50*tangent_D_p_y_1;
        const lane tangent_forward_t54 = tangent_forward_t46 + tangent_forward_t53;
        const lane tangent_forward_t55 = D_p_z_1*tangent_forward_t50 + forward_t50*tangent_D_p_z_1;
        const lane tangent_forward_t56 = tangent_forward_t47 + tangent_forward_t55;
        const lane tangent_forward_t57 = (1.0/6.0)*along_57;
        const lane tangent_forward_t58 = forward_t19*tangent_forward_t57 + forward_t57*tangent_forward_t19;
        const lane tangent_forward_t59 = forward_t20*tangent_forward_t57 + forward_t57*tangent_forward_t20;
        const lane tangent_forward_t60 = forward_t21*tangent_forward_t57 + forward_t57*tangent_forward_t21;
        const lane tangent_forward_t61 = (1.0/6.0)*along_58;
        const lane tangent_forward_t62 = forward_t22*tangent_forward_t61 + forward_t61*tangent_forward_t22;
        const lane tangent_forward_t63 = forward_t23*tangent_forward_t61 + forward_t61*tangent_forward_t23;
        const lane tangent_forward_t64 = forward_t24*tangent_forward_t61 + forward_t61*tangent_forward_t24;
        const lane tangent_forward_t65 = along_44*r_a_1 + along_47*m_a_1;
        const lane tangent_forward_t66 = tangent_forward_t44 + tangent_forward_t57 + tangent_forward_t61;
        const lane tangent_forward_t67 = D_p_x_2*tangent_forward_t50 + forward_t50*tangent_D_p_x_2;
        const lane tangent_forward_t68 = tangent_forward_t58 + tangent_forward_t67;
        const lane tangent_forward_t69 = D_p_y_2*tangent_forward_t50 + forward_t50*tangent_D_p_y_2;
        const lane tangent_forward_t70 = tangent_forward_t59 + tangent_forward_t69;
        const lane tangent_forward_t71 = D_p_z_2*tangent_forward_t50 + forward_t50*tangent_D_p_z_2;
        const lane tangent_forward_t72 = tangent_forward_t60 + tangent_forward_t71;
        const lane tangent_forward_t73 = along_45*r_a_2 + along_48*m_a_2;
        const lane tangent_forward_t74 = D_p_x_3*tangent_forward_t50 + forward_t50*tangent_D_p_x_3;
        const lane tangent_forward_t75 = tangent_forward_t62 + tangent_forward_t74;
        const lane tangent_forward_t76 = D_p_y_3*tangent_forward_t50 + forward_t50*tangent_D_p_y_3;
        const lane tangent_forward_t77 = tangent_forward_t63 + tangent_forward_t76;
        const lane tangent_forward_t78 = D_p_z_3*tangent_forward_t50 + forward_t50*tangent_D_p_z_3;
        const lane tangent_forward_t79 = tangent_forward_t64 + tangent_forward_t78;
        const lane tangent_forward_t80 = along_46*r_a_3 + along_49*m_a_3;
        const lane tangent_forward_t81 = 2.0*D_delta_x_1*tangent_D_delta_x_1;
        const lane tangent_forward_t82 = 2.0*D_delta_y_1*tangent_D_delta_y_1;
        const lane tangent_forward_t83 = 2.0*D_delta_z_1*tangent_D_delta_z_1;
        const lane tangent_forward_t84 = D_delta_x_1*tangent_forward_t50 + forward_t50*tangent_D_delta_x_1;
        const lane tangent_forward_t85 = D_delta_y_1*tangent_forward_t50 + forward_t50*tangent_D_delta_y_1;
        const lane tangent_forward_t86 = D_delta_z_1*tangent_forward_t50 + forward_t50*tangent_D_delta_z_1;
        const lane tangent_forward_t87 = 2.0*D_delta_x_2*tangent_D_delta_x_2;
        const lane tangent_forward_t88 = 2.0*D_delta_y_2*tangent_D_delta_y_2;
        const lane tangent_forward_t89 = 2.0*D_delta_z_2*tangent_D_delta_z_2;
        const lane tangent_forward_t90 = D_delta_x_2*tangent_forward_t50 + forward_t50*tangent_D_delta_x_2;
        const lane tangent_forward_t91 = D_delta_y_2*tangent_forward_t50 + forward_t50*tangent_D_delta_y_2;
        const lane tangent_forward_t92 = D_delta_z_2*tangent_forward_t50 + forward_t50*tangent_D_delta_z_2;
        const lane tangent_forward_t93 = 2.0*D_delta_x_3*tangent_D_delta_x_3;
        const lane tangent_forward_t94 = 2.0*D_delta_y_3*tangent_D_delta_y_3;
        const lane tangent_forward_t95 = 2.0*D_delta_z_3*tangent_D_delta_z_3;
        const lane tangent_forward_t96 =
            along_44 + along_45 + along_46 + along_56 + along_57 + along_58 + along_88 + tangent_forward_t38;
        const lane tangent_forward_t97 =
            L_a_1*tangent_forward_t35 + along_41*forward_t35 + tangent_forward_t65;
        const lane tangent_forward_t98 = 2.0*D_p_x_1*tangent_D_p_x_1;
        const lane tangent_forward_t99 = 2.0*D_p_y_1*tangent_D_p_y_1;
        const lane tangent_forward_t100 = 2.0*D_p_z_1*tangent_D_p_z_1;
        const lane tangent_forward_t101 = D_p_x_1*tangent_mu_3 + mu_3*tangent_D_p_x_1;
        const lane tangent_forward_t102 = D_p_x_1*tangent_mu_2 + mu_2*tangent_D_p_x_1;
        const lane tangent_forward_t103 = U_1_x_1*tangent_mu_1 + mu_1*tangent_U_1_x_1;
        const lane tangent_forward_t104 = D_p_y_1*tangent_mu_3 + mu_3*tangent_D_p_y_1;
        const lane tangent_forward_t105 = D_p_y_1*tangent_mu_2 + mu_2*tangent_D_p_y_1;
        const lane tangent_forward_t106 = U_1_y_1*tangent_mu_1 + mu_1*tangent_U_1_y_1;
        const lane tangent_forward_t107 = D_p_z_1*tangent_mu_3 + mu_3*tangent_D_p_z_1;
        const lane tangent_forward_t108 = D_p_z_1*tangent_mu_2 + mu_2*tangent_D_p_z_1;
        const lane tangent_forward_t109 = U_1_z_1*tangent_mu_1 + mu_1*tangent_U_1_z_1;
        const lane tangent_forward_t110 = 2.0*D_p_x_2*tangent_D_p_x_2;
        const lane tangent_forward_t111 = 2.0*D_p_y_2*tangent_D_p_y_2;
        const lane tangent_forward_t112 = 2.0*D_p_z_2*tangent_D_p_z_2;
        const lane tangent_forward_t113 =
            L_a_2*tangent_forward_t36 + along_42*forward_t36 + tangent_forward_t73;
        const lane tangent_forward_t114 = D_p_x_2*tangent_mu_1 + mu_1*tangent_D_p_x_2;
        const lane tangent_forward_t115 = D_p_x_2*tangent_mu_3 + mu_3*tangent_D_p_x_2;
        const lane tangent_forward_t116 = U_2_x_2*tangent_mu_2 + mu_2*tangent_U_2_x_2;
        const lane tangent_forward_t117 = D_p_y_2*tangent_mu_1 + mu_1*tangent_D_p_y_2;
        const lane tangent_forward_t118 = D_p_y_2*tangent_mu_3 + mu_3*tangent_D_p_y_2;
        const lane tangent_forward_t119 = U_2_y_2*tangent_mu_2 + mu_2*tangent_U_2_y_2;
        const lane tangent_forward_t120 = D_p_z_2*tangent_mu_1 + mu_1*tangent_D_p_z_2;
        const lane tangent_forward_t121 = D_p_z_2*tangent_mu_3 + mu_3*tangent_D_p_z_2;
        const lane tangent_forward_t122 = U_2_z_2*tangent_mu_2 + mu_2*tangent_U_2_z_2;
        const lane tangent_forward_t123 = 2.0*D_p_x_3*tangent_D_p_x_3;
        const lane tangent_forward_t124 = 2.0*D_p_y_3*tangent_D_p_y_3;
        const lane tangent_forward_t125 = 2.0*D_p_z_3*tangent_D_p_z_3;
        const lane tangent_forward_t126 =
            L_a_3*tangent_forward_t37 + along_43*forward_t37 + tangent_forward_t80;
        const lane t49 = D_delta_x_1*tangent_D_p_x_3;
        const lane tangent_forward_t127 = D_p_x_3*tangent_D_delta_x_1 + t49;
        const lane tangent_forward_t128 = U_3_x_3*tangent_mu_3 + mu_3*tangent_U_3_x_3;
        const lane t50 = D_delta_y_1*tangent_D_p_y_3;
        const lane tangent_forward_t129 = D_p_y_3*tangent_D_delta_y_1 + t50;
        const lane tangent_forward_t130 = U_3_y_3*tangent_mu_3 + mu_3*tangent_U_3_y_3;
        const lane t51 = D_delta_z_1*tangent_D_p_z_3;
        const lane tangent_forward_t131 = D_p_z_3*tangent_D_delta_z_1 + t51;
        const lane tangent_forward_t132 = U_3_z_3*tangent_mu_3 + mu_3*tangent_U_3_z_3;
        const lane t52 = D_delta_x_2*tangent_D_p_x_3;
        const lane tangent_forward_t133 = D_p_x_3*tangent_D_delta_x_2 + t52;
        const lane t53 = D_delta_y_2*tangent_D_p_y_3;
        const lane tangent_forward_t134 = D_p_y_3*tangent_D_delta_y_2 + t53;
        const lane t54 = D_delta_z_2*tangent_D_p_z_3;
        const lane tangent_forward_t135 = D_p_z_3*tangent_D_delta_z_2 + t54;
        const lane t55 = D_delta_x_3*tangent_D_p_x_3;
        const lane tangent_forward_t136 = D_p_x_3*tangent_D_delta_x_3 + t55;
        const lane t56 = D_delta_y_3*tangent_D_p_y_3;
        const lane tangent_forward_t137 = D_p_y_3*tangent_D_delta_y_3 + t56;
        const lane t57 = D_delta_z_3*tangent_D_p_z_3;
        const lane tangent_forward_t138 = D_p_z_3*tangent_D_delta_z_3 + t57;
        const lane t58 = D_delta_x_1*tangent_D_delta_x_2;
        const lane t59 = D_delta_x_2*tangent_D_delta_x_1;
        const lane tangent_forward_t139 = t58 + t59;
        const lane t60 = D_delta_y_1*tangent_D_delta_y_2;
        const lane t61 = D_delta_y_2*tangent_D_delta_y_1;
        const lane tangent_forward_t140 = t60 + t61;
        const lane t62 = D_delta_z_1*tangent_D_delta_z_2;
        const lane t63 = D_delta_z_2*tangent_D_delta_z_1;
        const lane tangent_forward_t141 = t62 + t63;
        const lane t64 = D_delta_x_1*tangent_D_delta_x_3;
        const lane t65 = D_delta_x_3*tangent_D_delta_x_1;
        const lane tangent_forward_t142 = t64 + t65;
        const lane t66 = D_delta_y_1*tangent_D_delta_y_3;
        const lane t67 = D_delta_y_3*tangent_D_delta_y_1;
        const lane tangent_forward_t143 = t66 + t67;
        const lane t68 = D_delta_z_1*tangent_D_delta_z_3;
        const lane t69 = D_delta_z_3*tangent_D_delta_z_1;
        const lane tangent_forward_t144 = t68 + t69;
        const lane t70 = D_delta_x_2*tangent_D_delta_x_3;
        const lane t71 = D_delta_x_3*tangent_D_delta_x_2;
        const lane tangent_forward_t145 = t70 + t71;
        const lane t72 = D_delta_y_2*tangent_D_delta_y_3;
        const lane t73 = D_delta_y_3*tangent_D_delta_y_2;
        const lane tangent_forward_t146 = t72 + t73;
        const lane t74 = D_delta_z_2*tangent_D_delta_z_3;
        const lane t75 = D_delta_z_3*tangent_D_delta_z_2;
        const lane tangent_forward_t147 = t74 + t75;
        lanes_clear(mass_rate, 144);
        mass_rate[0] =
            LANES(D_p_x_1*tangent_forward_t45 + D_p_x_1*tangent_forward_t52 + D_p_y_1*tangent_forward_t46
            + D_p_y_1*tangent_forward_t54 + D_p_z_1*tangent_forward_t47 + D_p_z_1*tangent_forward_t56
            + along_50 + forward_t1*tangent_forward_t43 + forward_t43*tangent_forward_t1
            + tangent_D_p_x_1*(forward_t45 + forward_t52) + tangent_D_p_y_1*(forward_t46 + forward_t54)
            + tangent_D_p_z_1*(forward_t47 + forward_t56));
        mass_rate[1] = mass_rate[12] =
            LANES(D_p_x_1*tangent_forward_t58 + D_p_x_2*tangent_forward_t52 + D_p_y_1*tangent_forward_t59
            + D_p_y_2*tangent_forward_t54 + D_p_z_1*tangent_forward_t60 + D_p_z_2*tangent_forward_t56
            + forward_t52*tangent_D_p_x_2 + forward_t54*tangent_D_p_y_2 + forward_t56*tangent_D_p_z_2
            + forward_t58*tangent_D_p_x_1 + forward_t59*tangent_D_p_y_1 + forward_t60*tangent_D_p_z_1);
        mass_rate[2] = mass_rate[24] =
            LANES(D_p_x_1*tangent_forward_t62 + D_p_x_3*tangent_forward_t52 + D_p_y_1*tangent_forward_t63
            + D_p_y_3*tangent_forward_t54 + D_p_z_1*tangent_forward_t64 + D_p_z_3*tangent_forward_t56
            + forward_t52*tangent_D_p_x_3 + forward_t54*tangent_D_p_y_3 + forward_t56*tangent_D_p_z_3
            + forward_t62*tangent_D_p_x_1 + forward_t63*tangent_D_p_y_1 + forward_t64*tangent_D_p_z_1);
        mass_rate[6] = mass_rate[72] =
            LANES(D_delta_x_1*tangent_forward_t52 + D_delta_y_1*tangent_forward_t54
            + D_delta_z_1*tangent_forward_t56 + forward_t52*tangent_D_delta_x_1
            + forward_t54*tangent_D_delta_y_1 + forward_t56*tangent_D_delta_z_1);
        mass_rate[7] = mass_rate[84] =
            LANES(D_delta_x_2*tangent_forward_t52 + D_delta_y_2*tangent_forward_t54
            + D_delta_z_2*tangent_forward_t56 + forward_t52*tangent_D_delta_x_2
            + forward_t54*tangent_D_delta_y_2 + forward_t56*tangent_D_delta_z_2);
        mass_rate[8] = mass_rate[96] =
            LANES(D_delta_x_3*tangent_forward_t52 + D_delta_y_3*tangent_forward_t54
            + D_delta_z_3*tangent_forward_t56 + forward_t52*tangent_D_delta_x_3
            + forward_t54*tangent_D_delta_y_3 + forward_t56*tangent_D_delta_z_3);
        mass_rate[9] = mass_rate[108] =
            LANES(D_p_x_1*tangent_forward_t66 + forward_t16*tangent_forward_t35
            + forward_t35*tangent_forward_t16 + forward_t65*tangent_t_1_x + forward_t66*tangent_D_p_x_1
            + t_1_x*tangent_forward_t65 + tangent_forward_t51);
        mass_rate[10] = mass_rate[120] =
            LANES(D_p_y_1*tangent_forward_t66 + forward_t17*tangent_forward_t35
            + forward_t35*tangent_forward_t17 + forward_t65*tangent_t_1_y + forward_t66*tangent_D_p_y_1
            + t_1_y*tangent_forward_t65 + tangent_forward_t53);
        mass_rate[11] = mass_rate[132] =
            LANES(D_p_z_1*tangent_forward_t66 + forward_t18*tangent_forward_t35
            + forward_t35*tangent_forward_t18 + forward_t65*tangent_t_1_z + forward_t66*tangent_D_p_z_1
            + t_1_z*tangent_forward_t65 + tangent_forward_t55);
        mass_rate[13] =
            LANES(D_p_x_2*tangent_forward_t58 + D_p_x_2*tangent_forward_t68 + D_p_y_2*tangent_forward_t59
            + D_p_y_2*tangent_forward_t70 + D_p_z_2*tangent_forward_t60 + D_p_z_2*tangent_forward_t72
            + along_51 + forward_t3*tangent_forward_t48 + forward_t48*tangent_forward_t3
            + tangent_D_p_x_2*(forward_t58 + forward_t68) + tangent_D_p_y_2*(forward_t59 + forward_t70)
            + tangent_D_p_z_2*(forward_t60 + forward_t72));
        mass_rate[14] = mass_rate[25] =
            LANES(D_p_x_2*tangent_forward_t62 + D_p_x_3*tangent_forward_t68 + D_p_y_2*tangent_forward_t63
            + D_p_y_3*tangent_forward_t70 + D_p_z_2*tangent_forward_t64 + D_p_z_3*tangent_forward_t72
            + forward_t62*tangent_D_p_x_2 + forward_t63*tangent_D_p_y_2 + forward_t64*tangent_D_p_z_2
            + forward_t68*tangent_D_p_x_3 + forward_t70*tangent_D_p_y_3 + forward_t72*tangent_D_p_z_3);
        mass_rate[18] = mass_rate[73] =
            LANES(D_delta_x_1*tangent_forward_t68 + D_delta_y_1*tangent_forward_t70
            + D_delta_z_1*tangent_forward_t72 + forward_t68*tangent_D_delta_x_1
            + forward_t70*tangent_D_delta_y_1 + forward_t72*tangent_D_delta_z_1);
        mass_rate[19] = mass_rate[85] =
            LANES(D_delta_x_2*tangent_forward_t68 + D_delta_y_2*tangent_forward_t70
            + D_delta_z_2*tangent_forward_t72 + forward_t68*tangent_D_delta_x_2
            + forward_t70*tangent_D_delta_y_2 + forward_t72*tangent_D_delta_z_2);
        mass_rate[20] = mass_rate[97] =
            LANES(D_delta_x_3*tangent_forward_t68 + D_delta_y_3*tangent_forward_t70
            + D_delta_z_3*tangent_forward_t72 + forward_t68*tangent_D_delta_x_3
            + forward_t70*tangent_D_delta_y_3 + forward_t72*tangent_D_delta_z_3);
        mass_rate[21] = mass_rate[109] =
            LANES(D_p_x_2*tangent_forward_t66 + forward_t19*tangent_forward_t36
            + forward_t36*tangent_forward_t19 + forward_t66*tangent_D_p_x_2 + forward_t73*tangent_t_2_x
            + t_2_x*tangent_forward_t73 + tangent_forward_t67);
        mass_rate[22] = mass_rate[121] =
            LANES(D_p_y_2*tangent_forward_t66 + forward_t20*tangent_forward_t36
            + forward_t36*tangent_forward_t20 + forward_t66*tangent_D_p_y_2 + forward_t73*tangent_t_2_y
            + t_2_y*tangent_forward_t73 + tangent_forward_t69);
        mass_rate[23] = mass_rate[133] =
            LANES(D_p_z_2*tangent_forward_t66 + forward_t21*tangent_forward_t36
            + forward_t36*tangent_forward_t21 + forward_t66*tangent_D_p_z_2 + forward_t73*tangent_t_2_z
            + t_2_z*tangent_forward_t73 + tangent_forward_t71);
        mass_rate[26] =
            LANES(D_p_x_3*tangent_forward_t62 + D_p_x_3*tangent_forward_t75 + D_p_y_3*tangent_forward_t63
            + D_p_y_3*tangent_forward_t77 + D_p_z_3*tangent_forward_t64 + D_p_z_3*tangent_forward_t79
            + along_52 + forward_t49*tangent_forward_t5 + forward_t5*tangent_forward_t49
            + tangent_D_p_x_3*(forward_t62 + forward_t75) + tangent_D_p_y_3*(forward_t63 + forward_t77)
            + tangent_D_p_z_3*(forward_t64 + forward_t79));
        mass_rate[30] = mass_rate[74] =
            LANES(D_delta_x_1*tangent_forward_t75 + D_delta_y_1*tangent_forward_t77
            + D_delta_z_1*tangent_forward_t79 + forward_t75*tangent_D_delta_x_1
            + forward_t77*tangent_D_delta_y_1 + forward_t79*tangent_D_delta_z_1);
        mass_rate[31] = mass_rate[86] =
            LANES(D_delta_x_2*tangent_forward_t75 + D_delta_y_2*tangent_forward_t77
            + D_delta_z_2*tangent_forward_t79 + forward_t75*tangent_D_delta_x_2
            + forward_t77*tangent_D_delta_y_2 + forward_t79*tangent_D_delta_z_2);
        mass_rate[32] = mass_rate[98] =
            LANES(D_delta_x_3*tangent_forward_t75 + D_delta_y_3*tangent_forward_t77
            + D_delta_z_3*tangent_forward_t79 + forward_t75*tangent_D_delta_x_3
            + forward_t77*tangent_D_delta_y_3 + forward_t79*tangent_D_delta_z_3);
        mass_rate[33] = mass_rate[110] =
            LANES(D_p_x_3*tangent_forward_t66 + forward_t22*tangent_forward_t37
            + forward_t37*tangent_forward_t22 + forward_t66*tangent_D_p_x_3 + forward_t80*tangent_t_3_x
            + t_3_x*tangent_forward_t80 + tangent_forward_t74);
        mass_rate[34] = mass_rate[122] =
            LANES(D_p_y_3*tangent_forward_t66 + forward_t23*tangent_forward_t37
            + forward_t37*tangent_forward_t23 + forward_t66*tangent_D_p_y_3 + forward_t80*tangent_t_3_y
            + t_3_y*tangent_forward_t80 + tangent_forward_t76);
        mass_rate[35] = mass_rate[134] =
            LANES(D_p_z_3*tangent_forward_t66 + forward_t24*tangent_forward_t37
            + forward_t37*tangent_forward_t24 + forward_t66*tangent_D_p_z_3 + forward_t80*tangent_t_3_z
            + t_3_z*tangent_forward_t80 + tangent_forward_t78);
        mass_rate[39] = LANES(tangent_I_1);
        mass_rate[52] = LANES(tangent_I_2);
        mass_rate[65] = LANES(tangent_I_3);
        mass_rate[78] =
            LANES(forward_t50*tangent_forward_t81 + forward_t50*tangent_forward_t82
            + forward_t50*tangent_forward_t83 + t76*tangent_forward_t50);
        mass_rate[79] = mass_rate[90] =
            LANES(D_delta_x_2*tangent_forward_t84 + D_delta_y_2*tangent_forward_t85
            + D_delta_z_2*tangent_forward_t86 + forward_t84*tangent_D_delta_x_2
            + forward_t85*tangent_D_delta_y_2 + forward_t86*tangent_D_delta_z_2);
        mass_rate[80] = mass_rate[102] =
            LANES(D_delta_x_3*tangent_forward_t84 + D_delta_y_3*tangent_forward_t85
            + D_delta_z_3*tangent_forward_t86 + forward_t84*tangent_D_delta_x_3
            + forward_t85*tangent_D_delta_y_3 + forward_t86*tangent_D_delta_z_3);
        mass_rate[81] = mass_rate[114] =
            LANES(D_delta_x_1*tangent_forward_t66 + forward_t66*tangent_D_delta_x_1 + tangent_forward_t84);
        mass_rate[82] = mass_rate[126] =
            LANES(D_delta_y_1*tangent_forward_t66 + forward_t66*tangent_D_delta_y_1 + tangent_forward_t85);
        mass_rate[83] = mass_rate[138] =
            LANES(D_delta_z_1*tangent_forward_t66 + forward_t66*tangent_D_delta_z_1 + tangent_forward_t86);
        mass_rate[91] =
            LANES(forward_t50*tangent_forward_t87 + forward_t50*tangent_forward_t88
            + forward_t50*tangent_forward_t89 + t77*tangent_forward_t50);
        mass_rate[92] = mass_rate[103] =
            LANES(D_delta_x_3*tangent_forward_t90 + D_delta_y_3*tangent_forward_t91
            + D_delta_z_3*tangent_forward_t92 + forward_t90*tangent_D_delta_x_3
            + forward_t91*tangent_D_delta_y_3 + forward_t92*tangent_D_delta_z_3);
        mass_rate[93] = mass_rate[115] =
            LANES(D_delta_x_2*tangent_forward_t66 + forward_t66*tangent_D_delta_x_2 + tangent_forward_t90);
        mass_rate[94] = mass_rate[127] =
            LANES(D_delta_y_2*tangent_forward_t66 + forward_t66*tangent_D_delta_y_2 + tangent_forward_t91);
        mass_rate[95] = mass_rate[139] =
            LANES(D_delta_z_2*tangent_forward_t66 + forward_t66*tangent_D_delta_z_2 + tangent_forward_t92);
        mass_rate[104] =
            LANES(forward_t50*tangent_forward_t93 + forward_t50*tangent_forward_t94
            + forward_t50*tangent_forward_t95 + t78*tangent_forward_t50);
        mass_rate[105] = mass_rate[116] =
            LANES(D_delta_x_3*tangent_forward_t50 + D_delta_x_3*tangent_forward_t66
            + t79*tangent_D_delta_x_3);
        mass_rate[106] = mass_rate[128] =
            LANES(D_delta_y_3*tangent_forward_t50 + D_delta_y_3*tangent_forward_t66
            + t79*tangent_D_delta_y_3);
        mass_rate[107] = mass_rate[140] =
            LANES(D_delta_z_3*tangent_forward_t50 + D_delta_z_3*tangent_forward_t66
            + t79*tangent_D_delta_z_3);
        mass_rate[117] = LANES(tangent_forward_t96);
        mass_rate[130] = LANES(tangent_forward_t96);
        mass_rate[143] = LANES(tangent_forward_t96);
        lanes_clear(stiffness_rate, 144);
        stiffness_rate[0] =
            LANES(along_2*d_1_x*forward_t97 + along_3*d_1_y*forward_t97 + along_4*d_1_z*forward_t97
            + along_80*t80 - 2.0*forward_t103*tangent_U_1_x_1 - 2.0*forward_t106*tangent_U_1_y_1
            - 2.0*forward_t109*tangent_U_1_z_1 - forward_t7*mu_1*tangent_s_1_x
            - forward_t8*mu_1*tangent_s_1_y - forward_t9*mu_1*tangent_s_1_z + forward_t97*g_x*tangent_d_1_x
            + forward_t97*g_y*tangent_d_1_y + forward_t97*g_z*tangent_d_1_z - mu_1*s_1_x*tangent_forward_t7
            - mu_1*s_1_y*tangent_forward_t8 - mu_1*s_1_z*tangent_forward_t9 - t80*tangent_mu_2
            - t80*tangent_mu_3 + t82*tangent_forward_t100 + t82*tangent_forward_t98 + t82*tangent_forward_t99
            + tangent_forward_t97*(d_1_x*g_x + d_1_y*g_y + d_1_z*g_z) + tangent_k_1
            + tangent_mu_1*(-(U_1_x_1*U_1_x_1) - (U_1_y_1*U_1_y_1) - (U_1_z_1*U_1_z_1) - forward_t7*s_1_x
            - forward_t8*s_1_y - forward_t9*s_1_z));
        stiffness_rate[1] = stiffness_rate[12] =
            LANES(D_p_x_2*k_C*tangent_D_p_x_1 - D_p_x_2*tangent_forward_t101 - D_p_x_2*tangent_forward_t103
            + D_p_y_2*k_C*tangent_D_p_y_1 - D_p_y_2*tangent_forward_t104 - D_p_y_2*tangent_forward_t106
            + D_p_z_2*k_C*tangent_D_p_z_1 - D_p_z_2*tangent_forward_t107 - D_p_z_2*tangent_forward_t109
            - U_2_x_2*tangent_forward_t102 - U_2_y_2*tangent_forward_t105 - U_2_z_2*tangent_forward_t108
            + along_80*(D_p_x_1*D_p_x_2 + D_p_y_1*D_p_y_2 + D_p_z_1*D_p_z_2) - forward_t102*tangent_U_2_x_2
            - forward_t105*tangent_U_2_y_2 - forward_t108*tangent_U_2_z_2 - t84*tangent_D_p_x_2
            - t86*tangent_D_p_y_2 - t88*tangent_D_p_z_2);
        stiffness_rate[2] = stiffness_rate[24] =
            LANES(D_p_x_3*k_C*tangent_D_p_x_1 - D_p_x_3*tangent_forward_t102 - D_p_x_3*tangent_forward_t103
            + D_p_y_3*k_C*tangent_D_p_y_1 - D_p_y_3*tangent_forward_t105 - D_p_y_3*tangent_forward_t106
            + D_p_z_3*k_C*tangent_D_p_z_1 - D_p_z_3*tangent_forward_t108 - D_p_z_3*tangent_forward_t109
            - U_3_x_3*tangent_forward_t101 - U_3_y_3*tangent_forward_t104 - U_3_z_3*tangent_forward_t107
            + along_80*(D_p_x_1*D_p_x_3 + D_p_y_1*D_p_y_3 + D_p_z_1*D_p_z_3) - forward_t101*tangent_U_3_x_3
            - forward_t104*tangent_U_3_y_3 - forward_t107*tangent_U_3_z_3 + tangent_D_p_x_3*(-forward_t102
            - t83) + tangent_D_p_y_3*(-forward_t105 - t85) + tangent_D_p_z_3*(-forward_t108 - t87));
        stiffness_rate[3] = stiffness_rate[36] = LANES(-tangent_k_1);
        stiffness_rate[6] = stiffness_rate[72] =
            LANES(D_delta_x_1*k_C*tangent_D_p_x_1 - D_delta_x_1*tangent_forward_t101
            - D_delta_x_1*tangent_forward_t102 - D_delta_x_1*tangent_forward_t103
            + D_delta_y_1*k_C*tangent_D_p_y_1 - D_delta_y_1*tangent_forward_t104
            - D_delta_y_1*tangent_forward_t105 - D_delta_y_1*tangent_forward_t106
            + D_delta_z_1*k_C*tangent_D_p_z_1 - D_delta_z_1*tangent_forward_t107
            - D_delta_z_1*tangent_forward_t108 - D_delta_z_1*tangent_forward_t109
            + along_80*(D_delta_x_1*D_p_x_1 + D_delta_y_1*D_p_y_1 + D_delta_z_1*D_p_z_1)
            + t89*tangent_D_delta_x_1 + t90*tangent_D_delta_y_1 + t91*tangent_D_delta_z_1);
        stiffness_rate[7] = stiffness_rate[84] =
            LANES(D_delta_x_2*k_C*tangent_D_p_x_1 - D_delta_x_2*tangent_forward_t101
            - D_delta_x_2*tangent_forward_t102 - D_delta_x_2*tangent_forward_t103
            + D_delta_y_2*k_C*tangent_D_p_y_1 - D_delta_y_2*tangent_forward_t104
            - D_delta_y_2*tangent_forward_t105 - D_delta_y_2*tangent_forward_t106
            + D_delta_z_2*k_C*tangent_D_p_z_1 - D_delta_z_2*tangent_forward_t107
            - D_delta_z_2*tangent_forward_t108 - D_delta_z_2*tangent_forward_t109
            + along_80*(D_delta_x_2*D_p_x_1 + D_delta_y_2*D_p_y_1 + D_delta_z_2*D_p_z_1)
            + t89*tangent_D_delta_x_2 + t90*tangent_D_delta_y_2 + t91*tangent_D_delta_z_2);
        stiffness_rate[8] = stiffness_rate[96] =
            LANES(D_delta_x_3*k_C*tangent_D_p_x_1 - D_delta_x_3*tangent_forward_t101
            - D_delta_x_3*tangent_forward_t102 - D_delta_x_3*tangent_forward_t103
            + D_delta_y_3*k_C*tangent_D_p_y_1 - D_delta_y_3*tangent_forward_t104
            - D_delta_y_3*tangent_forward_t105 - D_delta_y_3*tangent_forward_t106
            + D_delta_z_3*k_C*tangent_D_p_z_1 - D_delta_z_3*tangent_forward_t107
            - D_delta_z_3*tangent_forward_t108 - D_delta_z_3*tangent_forward_t109
            + along_80*(D_delta_x_3*D_p_x_1 + D_delta_y_3*D_p_y_1 + D_delta_z_3*D_p_z_1)
            + t89*tangent_D_delta_x_3 + t90*tangent_D_delta_y_3 + t91*tangent_D_delta_z_3);
        stiffness_rate[9] = stiffness_rate[108] = LANES(D_p_x_1*along_80 + k_C*tangent_D_p_x_1);
        stiffness_rate[10] = stiffness_rate[120] = LANES(D_p_y_1*along_80 + k_C*tangent_D_p_y_1);
        stiffness_rate[11] = stiffness_rate[132] = LANES(D_p_z_1*along_80 + k_C*tangent_D_p_z_1);
        stiffness_rate[13] =
            LANES(along_2*d_2_x*forward_t113 + along_3*d_2_y*forward_t113 + along_4*d_2_z*forward_t113
            + along_80*t92 - forward_t10*mu_2*tangent_s_2_x - forward_t11*mu_2*tangent_s_2_y
            + forward_t113*g_x*tangent_d_2_x + forward_t113*g_y*tangent_d_2_y
            + forward_t113*g_z*tangent_d_2_z - 2.0*forward_t116*tangent_U_2_x_2
            - 2.0*forward_t119*tangent_U_2_y_2 - forward_t12*mu_2*tangent_s_2_z
            - 2.0*forward_t122*tangent_U_2_z_2 - mu_2*s_2_x*tangent_forward_t10
            - mu_2*s_2_y*tangent_forward_t11 - mu_2*s_2_z*tangent_forward_t12 - t92*tangent_mu_1
            - t92*tangent_mu_3 + t93*tangent_forward_t110 + t93*tangent_forward_t111
            + t93*tangent_forward_t112 + tangent_forward_t113*(d_2_x*g_x + d_2_y*g_y + d_2_z*g_z)
            + tangent_k_2 + tangent_mu_2*(-(U_2_x_2*U_2_x_2) - (U_2_y_2*U_2_y_2) - (U_2_z_2*U_2_z_2)
            - forward_t10*s_2_x - forward_t11*s_2_y - forward_t12*s_2_z));
        stiffness_rate[14] = stiffness_rate[25] =
            LANES(D_p_x_3*k_C*tangent_D_p_x_2 - D_p_x_3*tangent_forward_t114 - D_p_x_3*tangent_forward_t116
            + D_p_y_3*k_C*tangent_D_p_y_2 - D_p_y_3*tangent_forward_t117 - D_p_y_3*tangent_forward_t119
            + D_p_z_3*k_C*tangent_D_p_z_2 - D_p_z_3*tangent_forward_t120 - D_p_z_3*tangent_forward_t122
            - U_3_x_3*tangent_forward_t115 - U_3_y_3*tangent_forward_t118 - U_3_z_3*tangent_forward_t121
            + along_80*(D_p_x_2*D_p_x_3 + D_p_y_2*D_p_y_3 + D_p_z_2*D_p_z_3) - forward_t115*tangent_U_3_x_3
            - forward_t118*tangent_U_3_y_3 - forward_t121*tangent_U_3_z_3 - t94*tangent_D_p_x_3
            - t95*tangent_D_p_y_3 - t96*tangent_D_p_z_3);
        stiffness_rate[16] = stiffness_rate[49] = LANES(-tangent_k_2);
        stiffness_rate[18] = stiffness_rate[73] =
            LANES(D_delta_x_1*k_C*tangent_D_p_x_2 - D_delta_x_1*tangent_forward_t114
            - D_delta_x_1*tangent_forward_t115 - D_delta_x_1*tangent_forward_t116
            + D_delta_y_1*k_C*tangent_D_p_y_2 - D_delta_y_1*tangent_forward_t117
            - D_delta_y_1*tangent_forward_t118 - D_delta_y_1*tangent_forward_t119
            + D_delta_z_1*k_C*tangent_D_p_z_2 - D_delta_z_1*tangent_forward_t120
            - D_delta_z_1*tangent_forward_t121 - D_delta_z_1*tangent_forward_t122
            + along_80*(D_delta_x_1*D_p_x_2 + D_delta_y_1*D_p_y_2 + D_delta_z_1*D_p_z_2)
            + t97*tangent_D_delta_x_1 + t98*tangent_D_delta_y_1 + t99*tangent_D_delta_z_1);
        stiffness_rate[19] = stiffness_rate[85] =
            LANES(D_delta_x_2*k_C*tangent_D_p_x_2 - D_delta_x_2*tangent_forward_t114
            - D_delta_x_2*tangent_forward_t115 - D_delta_x_2*tangent_forward_t116
            + D_delta_y_2*k_C*tangent_D_p_y_2 - D_delta_y_2*tangent_forward_t117
            - D_delta_y_2*tangent_forward_t118 - D_delta_y_2*tangent_forward_t119
            + D_delta_z_2*k_C*tangent_D_p_z_2 - D_delta_z_2*tangent_forward_t120
            - D_delta_z_2*tangent_forward_t121 - D_delta_z_2*tangent_forward_t122
            + along_80*(D_delta_x_2*D_p_x_2 + D_delta_y_2*D_p_y_2 + D_delta_z_2*D_p_z_2)
            + t97*tangent_D_delta_x_2 + t98*tangent_D_delta_y_2 + t99*tangent_D_delta_z_2);
        stiffness_rate[20] = stiffness_rate[97] =
            LANES(D_delta_x_3*k_C*tangent_D_p_x_2 - D_delta_x_3*tangent_forward_t114
            - D_delta_x_3*tangent_forward_t115 - D_delta_x_3*tangent_forward_t116
            + D_delta_y_3*k_C*tangent_D_p_y_2 - D_delta_y_3*tangent_forward_t117
            - D_delta_y_3*tangent_forward_t118 - D_delta_y_3*tangent_forward_t119
            + D_delta_z_3*k_C*tangent_D_p_z_2 - D_delta_z_3*tangent_forward_t120
            - D_delta_z_3*tangent_forward_t121 - D_delta_z_3*tangent_forward_t122
            + along_80*(D_delta_x_3*D_p_x_2 + D_delta_y_3*D_p_y_2 + D_delta_z_3*D_p_z_2)
            + t97*tangent_D_delta_x_3 + t98*tangent_D_delta_y_3 + t99*tangent_D_delta_z_3);
        stiffness_rate[21] = stiffness_rate[109] = LANES(D_p_x_2*along_80 + k_C*tangent_D_p_x_2);
        stiffness_rate[22] = stiffness_rate[121] = LANES(D_p_y_2*along_80 + k_C*tangent_D_p_y_2);
        stiffness_rate[23] = stiffness_rate[133] = LANES(D_p_z_2*along_80 + k_C*tangent_D_p_z_2);
        stiffness_rate[26] =
            LANES(along_2*d_3_x*forward_t126 + along_3*d_3_y*forward_t126 + along_4*d_3_z*forward_t126
            + along_80*t100 + forward_t126*g_x*tangent_d_3_x + forward_t126*g_y*tangent_d_3_y
            + forward_t126*g_z*tangent_d_3_z - 2.0*forward_t128*tangent_U_3_x_3
            - forward_t13*mu_3*tangent_s_3_x - 2.0*forward_t130*tangent_U_3_y_3
            - 2.0*forward_t132*tangent_U_3_z_3 - forward_t14*mu_3*tangent_s_3_y
            - forward_t15*mu_3*tangent_s_3_z - mu_3*s_3_x*tangent_forward_t13
            - mu_3*s_3_y*tangent_forward_t14 - mu_3*s_3_z*tangent_forward_t15 - t100*tangent_mu_1
            - t100*tangent_mu_2 + t102*tangent_forward_t123 + t102*tangent_forward_t124
            + t102*tangent_forward_t125 + tangent_forward_t126*(d_3_x*g_x + d_3_y*g_y + d_3_z*g_z)
            + tangent_k_3 + tangent_mu_3*(-(U_3_x_3*U_3_x_3) - (U_3_y_3*U_3_y_3) - (U_3_z_3*U_3_z_3)
            - forward_t13*s_3_x - forward_t14*s_3_y - forward_t15*s_3_z));
        stiffness_rate[29] = stiffness_rate[62] = LANES(-tangent_k_3);
        stiffness_rate[30] = stiffness_rate[74] =
            LANES(-D_delta_x_1*tangent_forward_t128 - D_delta_y_1*tangent_forward_t130
            - D_delta_z_1*tangent_forward_t132 + along_80*(forward_t127 + forward_t129 + forward_t131)
            + k_C*t49 + k_C*t50 + k_C*t51 - t101*tangent_forward_t127 - t101*tangent_forward_t129
            - t101*tangent_forward_t131 + t103*tangent_D_delta_x_1 + t104*tangent_D_delta_y_1
            + t105*tangent_D_delta_z_1 + t106*tangent_mu_1 + t106*tangent_mu_2);
        stiffness_rate[31] = stiffness_rate[86] =
            LANES(-D_delta_x_2*tangent_forward_t128 - D_delta_y_2*tangent_forward_t130
            - D_delta_z_2*tangent_forward_t132 + along_80*(forward_t133 + forward_t134 + forward_t135)
            + k_C*t52 + k_C*t53 + k_C*t54 - t101*tangent_forward_t133 - t101*tangent_forward_t134
            - t101*tangent_forward_t135 + t103*tangent_D_delta_x_2 + t104*tangent_D_delta_y_2
            + t105*tangent_D_delta_z_2 + t107*tangent_mu_1 + t107*tangent_mu_2);
        stiffness_rate[32] = stiffness_rate[98] =
            LANES(-D_delta_x_3*tangent_forward_t128 - D_delta_y_3*tangent_forward_t130
            - D_delta_z_3*tangent_forward_t132 + along_80*(forward_t136 + forward_t137 + forward_t138)
            + k_C*t55 + k_C*t56 + k_C*t57 - t101*tangent_forward_t136 - t101*tangent_forward_t137
            - t101*tangent_forward_t138 + t103*tangent_D_delta_x_3 + t104*tangent_D_delta_y_3
            + t105*tangent_D_delta_z_3 + t108*tangent_mu_1 + t108*tangent_mu_2);
        stiffness_rate[33] = stiffness_rate[110] = LANES(D_p_x_3*along_80 + k_C*tangent_D_p_x_3);
        stiffness_rate[34] = stiffness_rate[122] = LANES(D_p_y_3*along_80 + k_C*tangent_D_p_y_3);
        stiffness_rate[35] = stiffness_rate[134] = LANES(D_p_z_3*along_80 + k_C*tangent_D_p_z_3);
        stiffness_rate[39] = LANES(along_85 + tangent_k_1);
        stiffness_rate[52] = LANES(along_85 + tangent_k_2);
        stiffness_rate[65] = LANES(along_85 + tangent_k_3);
        stiffness_rate[78] =
            LANES(along_80*t76 + t109*tangent_forward_t81 + t109*tangent_forward_t82
            + t109*tangent_forward_t83 - t76*tangent_mu_2 - t76*tangent_mu_3 + tangent_mu_1*(1.0 - t76));
        stiffness_rate[79] = stiffness_rate[90] =
            LANES(along_80*(forward_t139 + forward_t140 + forward_t141) + k_C*t58 + k_C*t59 + k_C*t60
            + k_C*t61 + k_C*t62 + k_C*t63 + t110*tangent_forward_t139 + t110*tangent_forward_t140
            + t110*tangent_forward_t141 + t111*tangent_mu_1 + t111*tangent_mu_2 + t111*tangent_mu_3);
        stiffness_rate[80] = stiffness_rate[102] =
            LANES(along_80*(forward_t142 + forward_t143 + forward_t144) + k_C*t64 + k_C*t65 + k_C*t66
            + k_C*t67 + k_C*t68 + k_C*t69 + t110*tangent_forward_t142 + t110*tangent_forward_t143
            + t110*tangent_forward_t144 + t112*tangent_mu_1 + t112*tangent_mu_2 + t112*tangent_mu_3);
        stiffness_rate[81] = stiffness_rate[114] = LANES(D_delta_x_1*along_80 + k_C*tangent_D_delta_x_1);
        stiffness_rate[82] = stiffness_rate[126] = LANES(D_delta_y_1*along_80 + k_C*tangent_D_delta_y_1);
        stiffness_rate[83] = stiffness_rate[138] = LANES(D_delta_z_1*along_80 + k_C*tangent_D_delta_z_1);
        stiffness_rate[91] =
            LANES(along_80*t77 + t109*tangent_forward_t87 + t109*tangent_forward_t88
            + t109*tangent_forward_t89 - t77*tangent_mu_1 - t77*tangent_mu_3 + tangent_mu_2*(1.0 - t77));
        stiffness_rate[92] = stiffness_rate[103] =
            LANES(along_80*(forward_t145 + forward_t146 + forward_t147) + k_C*t70 + k_C*t71 + k_C*t72
            + k_C*t73 + k_C*t74 + k_C*t75 + t110*tangent_forward_t145 + t110*tangent_forward_t146
            + t110*tangent_forward_t147 + t113*tangent_mu_1 + t113*tangent_mu_2 + t113*tangent_mu_3);
        stiffness_rate[93] = stiffness_rate[115] = LANES(D_delta_x_2*along_80 + k_C*tangent_D_delta_x_2);
        stiffness_rate[94] = stiffness_rate[127] = LANES(D_delta_y_2*along_80 + k_C*tangent_D_delta_y_2);
        stiffness_rate[95] = stiffness_rate[139] = LANES(D_delta_z_2*along_80 + k_C*tangent_D_delta_z_2);
        stiffness_rate[104] =
            LANES(along_80*t78 + t109*tangent_forward_t93 + t109*tangent_forward_t94
            + t109*tangent_forward_t95 - t78*tangent_mu_1 - t78*tangent_mu_2 + tangent_mu_3*(1.0 - t78));
        stiffness_rate[105] = stiffness_rate[116] = LANES(D_delta_x_3*along_80 + k_C*tangent_D_delta_x_3);
        stiffness_rate[106] = stiffness_rate[128] = LANES(D_delta_y_3*along_80 + k_C*tangent_D_delta_y_3);
        stiffness_rate[107] = stiffness_rate[140] = LANES(D_delta_z_3*along_80 + k_C*tangent_D_delta_z_3);
        stiffness_rate[117] = LANES(along_80);
        stiffness_rate[130] = LANES(along_80);
        stiffness_rate[143] = LANES(along_80);
        lanes_clear(motion_rate, 36);
        motion_rate[0] = LANES(tangent_D_p_x_1);
        motion_rate[1] = LANES(tangent_D_p_x_2);
        motion_rate[2] = LANES(tangent_D_p_x_3);
        motion_rate[6] = LANES(tangent_D_delta_x_1);
        motion_rate[7] = LANES(tangent_D_delta_x_2);
        motion_rate[8] = LANES(tangent_D_delta_x_3);
        motion_rate[12] = LANES(tangent_D_p_y_1);
        motion_rate[13] = LANES(tangent_D_p_y_2);
        motion_rate[14] = LANES(tangent_D_p_y_3);
        motion_rate[18] = LANES(tangent_D_delta_y_1);
        motion_rate[19] = LANES(tangent_D_delta_y_2);
        motion_rate[20] = LANES(tangent_D_delta_y_3);
        motion_rate[24] = LANES(tangent_D_p_z_1);
        motion_rate[25] = LANES(tangent_D_p_z_2);
        motion_rate[26] = LANES(tangent_D_p_z_3);
        motion_rate[30] = LANES(tangent_D_delta_z_1);
        motion_rate[31] = LANES(tangent_D_delta_z_2);
        motion_rate[32] = LANES(tangent_D_delta_z_3);
        lanes_take(paths, path, mass_rate, stiffness_rate, motion_rate);
    }
}
