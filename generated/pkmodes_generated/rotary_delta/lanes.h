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
 *   I_j [kg m^2]: moment of inertia of motor j, seen at the arm
 *   k_j [N m/rad]: stiffness of reducer j
 *   D_r_j [m^2]: entry of D_r for axis j: component of linkage vector along the motion of its joint
 *   A_i_j [m^2]: adjugate of D_l, entry i, j
 *   det_D_l [m^3]: determinant of D_l
 *   D_p_i_k [m]: platform Jacobian, dp_i/dtheta_k
 *   D_delta_i_k [1]: platform Jacobian, dp_i/ddelta_k
 *   U_j_i_k [m]: derivative of linkage vector j, component i, with respect to theta_k
 *   mu_j [N/m]: static force in linkage j divided by its length, positive in compression
 */
#define LANES_POSE 3
#define LANES_INDEPENDENT 3
#define LANES_DIRECTIONS 3
#define LANES_BASE 6
#define LANES_ALL 12
#define LANES_RIGID 3
#define LANES_PARAMETERS 76
#define LANES_EFFECTS 10
#define LANES_MARGINS 13

/* How many numbers each margin of a pose has, and how they must compare. */
static const struct lanes_rule LANES_RULES[] = {
    {6, LANES_AT_LEAST_ZERO}, {1, LANES_AT_MOST_LIMIT}, {6, LANES_AT_LEAST_ZERO},
};

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
    const double I_G = effects[4];
    const double m_L = effects[5];
    const double k_S = effects[6];
    const double m_F = effects[9];
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
