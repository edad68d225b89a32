/* Generated from the derivation of hexapod.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * The mechanism hexapod for the compiled evaluator.
 *
 * A part of the compiled evaluator, which includes it once for each instruction set: `lane` is a vector of
 * doubles, one for each pose.  Matrices are row-major; everything is in SI units.
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

#define LANES_POSE 6
#define LANES_INDEPENDENT 6
#define LANES_DIRECTIONS 6
#define LANES_LINEAR 3
#define LANES_DRIVES 6
#define LANES_DEPENDENT 6
#define LANES_BASE 12
#define LANES_ALL 15
#define LANES_GRADIENT 140
#define LANES_MARGINS 14

/* How many numbers each margin of a pose has, and how they must compare. */
static const struct lanes_rule LANES_RULES[] = {
    {1, LANES_ABOVE_ZERO}, {1, LANES_AT_MOST_LIMIT}, {12, LANES_AT_LEAST_ZERO},
};

/* Which of the base coordinates the pose determines, and which depend on these. */
static const int LANES_INDEPENDENT_INDICES[] = {0, 1, 2, 3, 4, 5};
static const int LANES_DEPENDENT_INDICES[] = {6, 7, 8, 9, 10, 11};

/* Leg lengths at a pose, and the margins of a pose.
 *
 * Source: inverse_kinematics and rotation_margin, jacobian_condition, travel_margin.
 * 1677 operations; 18058738 with every named value expanded.
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
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double l_min_1 = parameters[49];
    const double l_max_1 = parameters[50];
    const double l_min_2 = parameters[51];
    const double l_max_2 = parameters[52];
    const double l_min_3 = parameters[53];
    const double l_max_3 = parameters[54];
    const double l_min_4 = parameters[55];
    const double l_max_4 = parameters[56];
    const double l_min_5 = parameters[57];
    const double l_max_5 = parameters[58];
    const double l_min_6 = parameters[59];
    const double l_max_6 = parameters[60];
    const lane t1 = (rot_x*rot_x);
    const lane t2 = (rot_y*rot_y);
    const lane t3 = (rot_z*rot_z);
    const lane t4 = t2 + t3;
    const lane t5 = t1 + t4;
    const lane half_angle = (1.0/2.0)*lanes_sqrt(t5 + 1e-30);
    const lane s_half = lanes_sin(half_angle)/half_angle;
    const lane t6 = (s_half*s_half);
    const lane t7 = (1.0/2.0)*t6;
    const lane R_x_x = -t4*t7 + 1.0;
    const lane c_half = lanes_cos(half_angle);
    const lane t8 = c_half*s_half;
    const lane t9 = rot_z*t8;
    const lane R_x_y = (1.0/2.0)*rot_x*rot_y*t6 - t9;
    const lane t10 = rot_x*t7;
    const lane t11 = rot_y*t8;
    const lane R_x_z = rot_z*t10 + t11;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = rot_y*t10 + t9;
    const lane R_y_y = t7*(-t1 - t3) + 1.0;
    const lane t12 = rot_x*t8;
    const lane R_y_z = (1.0/2.0)*rot_y*rot_z*t6 - t12;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = (1.0/2.0)*rot_x*rot_z*t6 - t11;
    const lane R_z_y = rot_y*rot_z*t7 + t12;
    const lane R_z_z = t7*(-t1 - t2) + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane t13 = (d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z);
    const lane l_1 = lanes_sqrt(t13);
    const lane t14 = (d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z);
    const lane l_2 = lanes_sqrt(t14);
    const lane t15 = (d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z);
    const lane l_3 = lanes_sqrt(t15);
    const lane t16 = (d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z);
    const lane l_4 = lanes_sqrt(t16);
    const lane t17 = (d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z);
    const lane l_5 = lanes_sqrt(t17);
    const lane t18 = (d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z);
    const lane l_6 = lanes_sqrt(t18);
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane t19 =
        (1.0/6.0)*(B_1_x*B_1_x) + (1.0/6.0)*(B_1_y*B_1_y) + (1.0/6.0)*(B_1_z*B_1_z) + (1.0/6.0)*(B_2_x*B_2_x)
        + (1.0/6.0)*(B_2_y*B_2_y) + (1.0/6.0)*(B_2_z*B_2_z) + (1.0/6.0)*(B_3_x*B_3_x)
        + (1.0/6.0)*(B_3_y*B_3_y) + (1.0/6.0)*(B_3_z*B_3_z) + (1.0/6.0)*(B_4_x*B_4_x)
        + (1.0/6.0)*(B_4_y*B_4_y) + (1.0/6.0)*(B_4_z*B_4_z) + (1.0/6.0)*(B_5_x*B_5_x)
        + (1.0/6.0)*(B_5_y*B_5_y) + (1.0/6.0)*(B_5_z*B_5_z) + (1.0/6.0)*(B_6_x*B_6_x)
        + (1.0/6.0)*(B_6_y*B_6_y) + (1.0/6.0)*(B_6_z*B_6_z);
    const lane t20 = 1.0/t19;
    const lane t21 = 1.0/((det_D_l*det_D_l));
    const lane t22 = t19*t21;
    q[0] = LANES(l_1);
    q[1] = LANES(l_2);
    q[2] = LANES(l_3);
    q[3] = LANES(l_4);
    q[4] = LANES(l_5);
    q[5] = LANES(l_6);
    margin[0] = LANES(-lanes_sqrt(t5) + (1.0/2.0)*3.141592653589793);
    margin[1] =
        LANES(lanes_sqrt(((D_l_1_rx*D_l_1_rx)*t20 + (D_l_1_ry*D_l_1_ry)*t20 + (D_l_1_rz*D_l_1_rz)*t20
        + (D_l_2_rx*D_l_2_rx)*t20 + (D_l_2_ry*D_l_2_ry)*t20 + (D_l_2_rz*D_l_2_rz)*t20
        + (D_l_3_rx*D_l_3_rx)*t20 + (D_l_3_ry*D_l_3_ry)*t20 + (D_l_3_rz*D_l_3_rz)*t20
        + (D_l_4_rx*D_l_4_rx)*t20 + (D_l_4_ry*D_l_4_ry)*t20 + (D_l_4_rz*D_l_4_rz)*t20
        + (D_l_5_rx*D_l_5_rx)*t20 + (D_l_5_ry*D_l_5_ry)*t20 + (D_l_5_rz*D_l_5_rz)*t20
        + (D_l_6_rx*D_l_6_rx)*t20 + (D_l_6_ry*D_l_6_ry)*t20 + (D_l_6_rz*D_l_6_rz)*t20 + t13 + t14 + t15 + t16
        + t17 + t18)*((A_rx_1*A_rx_1)*t22 + (A_rx_2*A_rx_2)*t22 + (A_rx_3*A_rx_3)*t22 + (A_rx_4*A_rx_4)*t22
        + (A_rx_5*A_rx_5)*t22 + (A_rx_6*A_rx_6)*t22 + (A_ry_1*A_ry_1)*t22 + (A_ry_2*A_ry_2)*t22
        + (A_ry_3*A_ry_3)*t22 + (A_ry_4*A_ry_4)*t22 + (A_ry_5*A_ry_5)*t22 + (A_ry_6*A_ry_6)*t22
        + (A_rz_1*A_rz_1)*t22 + (A_rz_2*A_rz_2)*t22 + (A_rz_3*A_rz_3)*t22 + (A_rz_4*A_rz_4)*t22
        + (A_rz_5*A_rz_5)*t22 + (A_rz_6*A_rz_6)*t22 + (A_x_1*A_x_1)*t21 + (A_x_2*A_x_2)*t21
        + (A_x_3*A_x_3)*t21 + (A_x_4*A_x_4)*t21 + (A_x_5*A_x_5)*t21 + (A_x_6*A_x_6)*t21 + (A_y_1*A_y_1)*t21
        + (A_y_2*A_y_2)*t21 + (A_y_3*A_y_3)*t21 + (A_y_4*A_y_4)*t21 + (A_y_5*A_y_5)*t21 + (A_y_6*A_y_6)*t21
        + (A_z_1*A_z_1)*t21 + (A_z_2*A_z_2)*t21 + (A_z_3*A_z_3)*t21 + (A_z_4*A_z_4)*t21 + (A_z_5*A_z_5)*t21
        + (A_z_6*A_z_6)*t21)));
    margin[2] = LANES(l_1 - l_min_1);
    margin[3] = LANES(-l_1 + l_max_1);
    margin[4] = LANES(l_2 - l_min_2);
    margin[5] = LANES(-l_2 + l_max_2);
    margin[6] = LANES(l_3 - l_min_3);
    margin[7] = LANES(-l_3 + l_max_3);
    margin[8] = LANES(l_4 - l_min_4);
    margin[9] = LANES(-l_4 + l_max_4);
    margin[10] = LANES(l_5 - l_min_5);
    margin[11] = LANES(-l_5 + l_max_5);
    margin[12] = LANES(l_6 - l_min_6);
    margin[13] = LANES(-l_6 + l_max_6);
}

/* Mass and stiffness matrices without effects, and the motion of the platform.
 *
 * Source: modal_matrices and platform_jacobian.
 * 3924 operations; 9810485364 with every named value expanded.
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
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double m_p = parameters[0];
    const double c_p_x = parameters[1];
    const double c_p_y = parameters[2];
    const double c_p_z = parameters[3];
    const double I_p_x = parameters[4];
    const double I_p_y = parameters[5];
    const double I_p_z = parameters[6];
    const double I_p_xy = parameters[7];
    const double I_p_xz = parameters[8];
    const double I_p_yz = parameters[9];
    const double g_x = parameters[10];
    const double g_y = parameters[11];
    const double g_z = parameters[12];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double k_l_1 = parameters[61];
    const double k_l_2 = parameters[62];
    const double k_l_3 = parameters[63];
    const double k_l_4 = parameters[64];
    const double k_l_5 = parameters[65];
    const double k_l_6 = parameters[66];
    const double m_b_1 = parameters[67];
    const double m_b_2 = parameters[68];
    const double m_b_3 = parameters[69];
    const double m_b_4 = parameters[70];
    const double m_b_5 = parameters[71];
    const double m_b_6 = parameters[72];
    const double c_b_1 = parameters[73];
    const double c_b_2 = parameters[74];
    const double c_b_3 = parameters[75];
    const double c_b_4 = parameters[76];
    const double c_b_5 = parameters[77];
    const double c_b_6 = parameters[78];
    const double I_b_1 = parameters[79];
    const double I_b_2 = parameters[80];
    const double I_b_3 = parameters[81];
    const double I_b_4 = parameters[82];
    const double I_b_5 = parameters[83];
    const double I_b_6 = parameters[84];
    const double m_r_1 = parameters[85];
    const double m_r_2 = parameters[86];
    const double m_r_3 = parameters[87];
    const double m_r_4 = parameters[88];
    const double m_r_5 = parameters[89];
    const double m_r_6 = parameters[90];
    const double c_r_1 = parameters[91];
    const double c_r_2 = parameters[92];
    const double c_r_3 = parameters[93];
    const double c_r_4 = parameters[94];
    const double c_r_5 = parameters[95];
    const double c_r_6 = parameters[96];
    const double I_r_1 = parameters[97];
    const double I_r_2 = parameters[98];
    const double I_r_3 = parameters[99];
    const double I_r_4 = parameters[100];
    const double I_r_5 = parameters[101];
    const double I_r_6 = parameters[102];
    const double I_m_1 = parameters[103];
    const double I_m_2 = parameters[104];
    const double I_m_3 = parameters[105];
    const double I_m_4 = parameters[106];
    const double I_m_5 = parameters[107];
    const double I_m_6 = parameters[108];
    const double h_m_1 = parameters[109];
    const double h_m_2 = parameters[110];
    const double h_m_3 = parameters[111];
    const double h_m_4 = parameters[112];
    const double h_m_5 = parameters[113];
    const double h_m_6 = parameters[114];
    const lane t1 = (rot_x*rot_x);
    const lane t2 = (rot_y*rot_y);
    const lane t3 = (rot_z*rot_z);
    const lane t4 = t2 + t3;
    const lane half_angle = (1.0/2.0)*lanes_sqrt(t1 + t4 + 1e-30);
    const lane s_half = lanes_sin(half_angle)/half_angle;
    const lane t5 = (s_half*s_half);
    const lane t6 = (1.0/2.0)*t5;
    const lane R_x_x = -t4*t6 + 1.0;
    const lane c_half = lanes_cos(half_angle);
    const lane t7 = c_half*s_half;
    const lane t8 = rot_z*t7;
    const lane R_x_y = (1.0/2.0)*rot_x*rot_y*t5 - t8;
    const lane t9 = rot_y*t7;
    const lane t10 = rot_x*t6;
    const lane R_x_z = rot_z*t10 + t9;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = rot_y*t10 + t8;
    const lane R_y_y = t6*(-t1 - t3) + 1.0;
    const lane t11 = rot_x*t7;
    const lane R_y_z = (1.0/2.0)*rot_y*rot_z*t5 - t11;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = (1.0/2.0)*rot_x*rot_z*t5 - t9;
    const lane R_z_y = rot_y*rot_z*t6 + t11;
    const lane R_z_z = t6*(-t1 - t2) + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane l_1 = lanes_sqrt((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const lane l_2 = lanes_sqrt((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const lane l_3 = lanes_sqrt((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const lane l_4 = lanes_sqrt((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const lane l_5 = lanes_sqrt((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const lane l_6 = lanes_sqrt((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const lane c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const lane c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const lane c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const lane t12 = I_p_xy*R_x_x;
    const lane t13 = I_p_xz*R_x_x;
    const lane t14 = 2.0*R_x_z;
    const lane t15 = I_p_yz*R_x_y;
    const lane J_x_x =
        I_p_x*(R_x_x*R_x_x) + I_p_y*(R_x_y*R_x_y) + I_p_z*(R_x_z*R_x_z) + 2.0*R_x_y*t12 + t13*t14 + t14*t15;
    const lane t16 = I_p_x*R_x_x;
    const lane t17 = I_p_xy*R_x_y;
    const lane t18 = I_p_xz*R_x_z;
    const lane t19 = I_p_y*R_x_y;
    const lane t20 = I_p_yz*R_x_z;
    const lane t21 = I_p_z*R_x_z;
    const lane J_x_y =
        R_y_x*t16 + R_y_x*t17 + R_y_x*t18 + R_y_y*t12 + R_y_y*t19 + R_y_y*t20 + R_y_z*t13 + R_y_z*t15
        + R_y_z*t21;
    const lane J_x_z =
        R_z_x*t16 + R_z_x*t17 + R_z_x*t18 + R_z_y*t12 + R_z_y*t19 + R_z_y*t20 + R_z_z*t13 + R_z_z*t15
        + R_z_z*t21;
    const lane t22 = I_p_xy*R_y_x;
    const lane t23 = I_p_xz*R_y_x;
    const lane t24 = 2.0*R_y_z;
    const lane t25 = I_p_yz*R_y_y;
    const lane J_y_y =
        I_p_x*(R_y_x*R_y_x) + I_p_y*(R_y_y*R_y_y) + I_p_z*(R_y_z*R_y_z) + 2.0*R_y_y*t22 + t23*t24 + t24*t25;
    const lane t26 = I_p_xy*R_z_x;
    const lane t27 = I_p_xz*R_z_x;
    const lane t28 = I_p_yz*R_z_y;
    const lane J_y_z =
        I_p_x*R_y_x*R_z_x + I_p_y*R_y_y*R_z_y + I_p_z*R_y_z*R_z_z + R_y_y*t26 + R_y_z*t27 + R_y_z*t28
        + R_z_y*t22 + R_z_z*t23 + R_z_z*t25;
    const lane t29 = 2.0*R_z_z;
    const lane J_z_z =
        I_p_x*(R_z_x*R_z_x) + I_p_y*(R_z_y*R_z_y) + I_p_z*(R_z_z*R_z_z) + 2.0*R_z_y*t26 + t27*t29 + t28*t29;
    const lane t30 = 1.0/((l_1*l_1));
    const lane t31 = 1.0/l_1;
    const lane m_perp_1 =
        I_b_1*t30 + I_r_1*t30 + (c_b_1*c_b_1)*m_b_1*t30 + m_r_1*((-c_r_1*t31 + 1.0)*(-c_r_1*t31 + 1.0));
    const double t32 = c_b_1*m_b_1 - c_r_1*m_r_1;
    const lane m_lift_1 = m_r_1 + t31*t32;
    const lane t33 = 1.0/((l_2*l_2));
    const lane t34 = 1.0/l_2;
    const lane m_perp_2 =
        I_b_2*t33 + I_r_2*t33 + (c_b_2*c_b_2)*m_b_2*t33 + m_r_2*((-c_r_2*t34 + 1.0)*(-c_r_2*t34 + 1.0));
    const double t35 = c_b_2*m_b_2 - c_r_2*m_r_2;
    const lane m_lift_2 = m_r_2 + t34*t35;
    const lane t36 = 1.0/((l_3*l_3));
    const lane t37 = 1.0/l_3;
    const lane m_perp_3 =
        I_b_3*t36 + I_r_3*t36 + (c_b_3*c_b_3)*m_b_3*t36 + m_r_3*((-c_r_3*t37 + 1.0)*(-c_r_3*t37 + 1.0));
    const double t38 = c_b_3*m_b_3 - c_r_3*m_r_3;
    const lane m_lift_3 = m_r_3 + t37*t38;
    const lane t39 = 1.0/((l_4*l_4));
    const lane t40 = 1.0/l_4;
    const lane m_perp_4 =
        I_b_4*t39 + I_r_4*t39 + (c_b_4*c_b_4)*m_b_4*t39 + m_r_4*((-c_r_4*t40 + 1.0)*(-c_r_4*t40 + 1.0));
    const double t41 = c_b_4*m_b_4 - c_r_4*m_r_4;
    const lane m_lift_4 = m_r_4 + t40*t41;
    const lane t42 = 1.0/((l_5*l_5));
    const lane t43 = 1.0/l_5;
    const lane m_perp_5 =
        I_b_5*t42 + I_r_5*t42 + (c_b_5*c_b_5)*m_b_5*t42 + m_r_5*((-c_r_5*t43 + 1.0)*(-c_r_5*t43 + 1.0));
    const double t44 = c_b_5*m_b_5 - c_r_5*m_r_5;
    const lane m_lift_5 = m_r_5 + t43*t44;
    const lane t45 = 1.0/((l_6*l_6));
    const lane t46 = 1.0/l_6;
    const lane m_perp_6 =
        I_b_6*t45 + I_r_6*t45 + (c_b_6*c_b_6)*m_b_6*t45 + m_r_6*((-c_r_6*t46 + 1.0)*(-c_r_6*t46 + 1.0));
    const double t47 = c_b_6*m_b_6 - c_r_6*m_r_6;
    const lane m_lift_6 = m_r_6 + t46*t47;
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane t48 = 1.0/det_D_l;
    const lane t49 = l_1*t48;
    const lane D_p_x_1 = A_x_1*t49;
    const lane t50 = l_2*t48;
    const lane D_p_x_2 = A_x_2*t50;
    const lane t51 = l_3*t48;
    const lane D_p_x_3 = A_x_3*t51;
    const lane t52 = l_4*t48;
    const lane D_p_x_4 = A_x_4*t52;
    const lane t53 = l_5*t48;
    const lane D_p_x_5 = A_x_5*t53;
    const lane t54 = l_6*t48;
    const lane D_p_x_6 = A_x_6*t54;
    const lane D_p_y_1 = A_y_1*t49;
    const lane D_p_y_2 = A_y_2*t50;
    const lane D_p_y_3 = A_y_3*t51;
    const lane D_p_y_4 = A_y_4*t52;
    const lane D_p_y_5 = A_y_5*t53;
    const lane D_p_y_6 = A_y_6*t54;
    const lane D_p_z_1 = A_z_1*t49;
    const lane D_p_z_2 = A_z_2*t50;
    const lane D_p_z_3 = A_z_3*t51;
    const lane D_p_z_4 = A_z_4*t52;
    const lane D_p_z_5 = A_z_5*t53;
    const lane D_p_z_6 = A_z_6*t54;
    const lane D_p_rx_1 = A_rx_1*t49;
    const lane D_p_rx_2 = A_rx_2*t50;
    const lane D_p_rx_3 = A_rx_3*t51;
    const lane D_p_rx_4 = A_rx_4*t52;
    const lane D_p_rx_5 = A_rx_5*t53;
    const lane D_p_rx_6 = A_rx_6*t54;
    const lane D_p_ry_1 = A_ry_1*t49;
    const lane D_p_ry_2 = A_ry_2*t50;
    const lane D_p_ry_3 = A_ry_3*t51;
    const lane D_p_ry_4 = A_ry_4*t52;
    const lane D_p_ry_5 = A_ry_5*t53;
    const lane D_p_ry_6 = A_ry_6*t54;
    const lane D_p_rz_1 = A_rz_1*t49;
    const lane D_p_rz_2 = A_rz_2*t50;
    const lane D_p_rz_3 = A_rz_3*t51;
    const lane D_p_rz_4 = A_rz_4*t52;
    const lane D_p_rz_5 = A_rz_5*t53;
    const lane D_p_rz_6 = A_rz_6*t54;
    const lane t55 = g_x*m_lift_1;
    const lane t56 = g_x*m_lift_2;
    const lane t57 = g_x*m_lift_3;
    const lane t58 = g_x*m_lift_4;
    const lane t59 = g_x*m_lift_5;
    const lane t60 = g_x*m_lift_6;
    const double t61 = g_x*m_p;
    const lane G_p_x = -t55 - t56 - t57 - t58 - t59 - t60 - t61;
    const lane t62 = g_y*m_lift_1;
    const lane t63 = g_y*m_lift_2;
    const lane t64 = g_y*m_lift_3;
    const lane t65 = g_y*m_lift_4;
    const lane t66 = g_y*m_lift_5;
    const lane t67 = g_y*m_lift_6;
    const double t68 = g_y*m_p;
    const lane G_p_y = -t62 - t63 - t64 - t65 - t66 - t67 - t68;
    const lane t69 = g_z*m_lift_1;
    const lane t70 = g_z*m_lift_2;
    const lane t71 = g_z*m_lift_3;
    const lane t72 = g_z*m_lift_4;
    const lane t73 = g_z*m_lift_5;
    const lane t74 = g_z*m_lift_6;
    const double t75 = g_z*m_p;
    const lane G_p_z = -t69 - t70 - t71 - t72 - t73 - t74 - t75;
    const lane G_p_rx =
        -B_1_y*t69 + B_1_z*g_y*m_lift_1 - B_2_y*t70 + B_2_z*g_y*m_lift_2 - B_3_y*t71 + B_3_z*g_y*m_lift_3
        - B_4_y*t72 + B_4_z*g_y*m_lift_4 - B_5_y*t73 + B_5_z*g_y*m_lift_5 - B_6_y*t74 + B_6_z*g_y*m_lift_6
        - c_y*t75 + c_z*g_y*m_p;
    const lane G_p_ry =
        B_1_x*t69 - B_1_z*t55 + B_2_x*t70 - B_2_z*t56 + B_3_x*t71 - B_3_z*t57 + B_4_x*t72 - B_4_z*t58
        + B_5_x*t73 - B_5_z*t59 + B_6_x*t74 - B_6_z*t60 + c_x*t75 - c_z*t61;
    const lane G_p_rz =
        -B_1_x*t62 + B_1_y*g_x*m_lift_1 - B_2_x*t63 + B_2_y*g_x*m_lift_2 - B_3_x*t64 + B_3_y*g_x*m_lift_3
        - B_4_x*t65 + B_4_y*g_x*m_lift_4 - B_5_x*t66 + B_5_y*g_x*m_lift_5 - B_6_x*t67 + B_6_y*g_x*m_lift_6
        - c_x*t68 + c_y*g_x*m_p;
    const lane mu_1 =
        t48*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const lane mu_2 =
        t48*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const lane mu_3 =
        t48*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const lane mu_4 =
        t48*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const lane mu_5 =
        t48*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const lane mu_6 =
        t48*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const lane g_4_x = -d_1_x*mu_1 - t55;
    const lane g_4_y = -d_1_y*mu_1 - t62;
    const lane g_4_z = -d_1_z*mu_1 - t69;
    const lane g_5_x = -d_2_x*mu_2 - t56;
    const lane g_5_y = -d_2_y*mu_2 - t63;
    const lane g_5_z = -d_2_z*mu_2 - t70;
    const lane g_6_x = -d_3_x*mu_3 - t57;
    const lane g_6_y = -d_3_y*mu_3 - t64;
    const lane g_6_z = -d_3_z*mu_3 - t71;
    const lane g_7_x = -d_4_x*mu_4 - t58;
    const lane g_7_y = -d_4_y*mu_4 - t65;
    const lane g_7_z = -d_4_z*mu_4 - t72;
    const lane g_8_x = -d_5_x*mu_5 - t59;
    const lane g_8_y = -d_5_y*mu_5 - t66;
    const lane g_8_z = -d_5_z*mu_5 - t73;
    const lane g_9_x = -d_6_x*mu_6 - t60;
    const lane g_9_y = -d_6_y*mu_6 - t67;
    const lane g_9_z = -d_6_z*mu_6 - t74;
    const double g_10_x = -t61;
    const double g_10_y = -t68;
    const double g_10_z = -t75;
    const lane L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const lane t76 = B_1_z*mu_1;
    const lane t77 = B_2_z*mu_2;
    const lane t78 = B_3_z*mu_3;
    const lane t79 = B_4_z*mu_4;
    const lane t80 = B_5_z*mu_5;
    const lane t81 = B_6_z*mu_6;
    const lane L_y_rx = t76 + t77 + t78 + t79 + t80 + t81;
    const lane L_x_ry = -L_y_rx;
    const lane t82 = B_1_y*mu_1;
    const lane t83 = B_2_y*mu_2;
    const lane t84 = B_3_y*mu_3;
    const lane t85 = B_4_y*mu_4;
    const lane t86 = B_5_y*mu_5;
    const lane t87 = B_6_y*mu_6;
    const lane L_x_rz = t82 + t83 + t84 + t85 + t86 + t87;
    const lane L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const lane L_y_rz = -L_z_ry;
    const lane L_z_rx = -L_x_rz;
    const lane t88 = (B_3_y*B_3_y);
    const lane t89 = (B_4_y*B_4_y);
    const lane t90 = (B_5_y*B_5_y);
    const lane t91 = (B_6_y*B_6_y);
    const lane t92 = (B_1_y*B_1_y);
    const lane t93 = (B_2_y*B_2_y);
    const lane t94 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + mu_1*t92 + mu_2*t93 + mu_3*t88 + mu_4*t89 + mu_5*t90 + mu_6*t91;
    const lane t95 = (B_1_z*B_1_z);
    const lane t96 = (B_2_z*B_2_z);
    const lane t97 = (B_3_z*B_3_z);
    const lane t98 = (B_4_z*B_4_z);
    const lane t99 = (B_5_z*B_5_z);
    const lane t100 = (B_6_z*B_6_z);
    const lane t101 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + mu_1*t95 + mu_2*t96 + mu_3*t97 + mu_4*t98 + mu_5*t99 + mu_6*t100;
    const lane L_rx_rx = -t101 - t94;
    const lane t102 = (1.0/2.0)*B_1_x;
    const lane t103 = (1.0/2.0)*g_4_x;
    const lane t104 = (1.0/2.0)*B_2_x;
    const lane t105 = (1.0/2.0)*g_5_x;
    const lane t106 = (1.0/2.0)*B_3_x;
    const lane t107 = (1.0/2.0)*g_6_x;
    const lane t108 = (1.0/2.0)*B_4_x;
    const lane t109 = (1.0/2.0)*g_7_x;
    const lane t110 = (1.0/2.0)*B_5_x;
    const lane t111 = (1.0/2.0)*g_8_x;
    const lane t112 = (1.0/2.0)*B_6_x;
    const lane t113 = (1.0/2.0)*g_9_x;
    const lane t114 = (1.0/2.0)*c_x;
    const double t115 = (1.0/2.0)*g_10_x;
    const lane L_rx_ry =
        B_1_x*t82 + B_1_y*t103 + B_2_x*t83 + B_2_y*t105 + B_3_x*t84 + B_3_y*t107 + B_4_x*t85 + B_4_y*t109
        + B_5_x*t86 + B_5_y*t111 + B_6_x*t87 + B_6_y*t113 + c_y*t115 + g_10_y*t114 + g_4_y*t102 + g_5_y*t104
        + g_6_y*t106 + g_7_y*t108 + g_8_y*t110 + g_9_y*t112;
    const lane L_rx_rz =
        B_1_x*t76 + B_1_z*t103 + B_2_x*t77 + B_2_z*t105 + B_3_x*t78 + B_3_z*t107 + B_4_x*t79 + B_4_z*t109
        + B_5_x*t80 + B_5_z*t111 + B_6_x*t81 + B_6_z*t113 + c_z*t115 + g_10_z*t114 + g_4_z*t102 + g_5_z*t104
        + g_6_z*t106 + g_7_z*t108 + g_8_z*t110 + g_9_z*t112;
    const lane t116 = (B_1_x*B_1_x);
    const lane t117 = (B_2_x*B_2_x);
    const lane t118 = (B_3_x*B_3_x);
    const lane t119 = (B_4_x*B_4_x);
    const lane t120 = (B_5_x*B_5_x);
    const lane t121 = (B_6_x*B_6_x);
    const lane t122 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + mu_1*t116 + mu_2*t117 + mu_3*t118 + mu_4*t119 + mu_5*t120 + mu_6*t121;
    const lane L_ry_ry = -t101 - t122;
    const lane L_ry_rz =
        (1.0/2.0)*B_1_y*g_4_z + B_1_y*t76 + (1.0/2.0)*B_1_z*g_4_y + (1.0/2.0)*B_2_y*g_5_z + B_2_y*t77
        + (1.0/2.0)*B_2_z*g_5_y + (1.0/2.0)*B_3_y*g_6_z + B_3_y*t78 + (1.0/2.0)*B_3_z*g_6_y
        + (1.0/2.0)*B_4_y*g_7_z + B_4_y*t79 + (1.0/2.0)*B_4_z*g_7_y + (1.0/2.0)*B_5_y*g_8_z + B_5_y*t80
        + (1.0/2.0)*B_5_z*g_8_y + (1.0/2.0)*B_6_y*g_9_z + B_6_y*t81 + (1.0/2.0)*B_6_z*g_9_y
        + (1.0/2.0)*c_y*g_10_z + (1.0/2.0)*c_z*g_10_y;
    const lane L_rz_rz = -t122 - t94;
    const lane t123 = t30*t32;
    const lane t124 = g_x*t123;
    const lane f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t124;
    const lane t125 = t33*t35;
    const lane t126 = g_x*t125;
    const lane f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t126;
    const lane t127 = t36*t38;
    const lane t128 = g_x*t127;
    const lane f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t128;
    const lane t129 = t39*t41;
    const lane t130 = g_x*t129;
    const lane f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t130;
    const lane t131 = t42*t44;
    const lane t132 = g_x*t131;
    const lane f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t132;
    const lane t133 = t45*t47;
    const lane t134 = g_x*t133;
    const lane f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t134;
    const lane t135 = g_y*t123;
    const lane f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t135;
    const lane t136 = g_y*t125;
    const lane f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t136;
    const lane t137 = g_y*t127;
    const lane f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t137;
    const lane t138 = g_y*t129;
    const lane f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t138;
    const lane t139 = g_y*t131;
    const lane f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t139;
    const lane t140 = g_y*t133;
    const lane f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t140;
    const lane t141 = g_z*t123;
    const lane f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t141;
    const lane t142 = g_z*t125;
    const lane f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t142;
    const lane t143 = g_z*t127;
    const lane f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t143;
    const lane t144 = g_z*t129;
    const lane f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t144;
    const lane t145 = g_z*t131;
    const lane f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t145;
    const lane t146 = g_z*t133;
    const lane f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t146;
    const lane t147 = t123*(-B_1_y*g_z + B_1_z*g_y);
    const lane f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx - t147;
    const lane t148 = t125*(-B_2_y*g_z + B_2_z*g_y);
    const lane f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx - t148;
    const lane t149 = t127*(-B_3_y*g_z + B_3_z*g_y);
    const lane f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx - t149;
    const lane t150 = t129*(-B_4_y*g_z + B_4_z*g_y);
    const lane f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx - t150;
    const lane t151 = t131*(-B_5_y*g_z + B_5_z*g_y);
    const lane f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx - t151;
    const lane t152 = t133*(-B_6_y*g_z + B_6_z*g_y);
    const lane f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx - t152;
    const lane t153 = t123*(B_1_x*g_z - B_1_z*g_x);
    const lane f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry - t153;
    const lane t154 = t125*(B_2_x*g_z - B_2_z*g_x);
    const lane f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry - t154;
    const lane t155 = t127*(B_3_x*g_z - B_3_z*g_x);
    const lane f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry - t155;
    const lane t156 = t129*(B_4_x*g_z - B_4_z*g_x);
    const lane f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry - t156;
    const lane t157 = t131*(B_5_x*g_z - B_5_z*g_x);
    const lane f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry - t157;
    const lane t158 = t133*(B_6_x*g_z - B_6_z*g_x);
    const lane f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry - t158;
    const lane t159 = t123*(-B_1_x*g_y + B_1_y*g_x);
    const lane f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz - t159;
    const lane t160 = t125*(-B_2_x*g_y + B_2_y*g_x);
    const lane f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz - t160;
    const lane t161 = t127*(-B_3_x*g_y + B_3_y*g_x);
    const lane f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz - t161;
    const lane t162 = t129*(-B_4_x*g_y + B_4_y*g_x);
    const lane f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz - t162;
    const lane t163 = t131*(-B_5_x*g_y + B_5_y*g_x);
    const lane f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz - t163;
    const lane t164 = t133*(-B_6_x*g_y + B_6_y*g_x);
    const lane f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz - t164;
    const lane M_p_x_x = m_p + m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6;
    const lane t165 = B_1_z*m_perp_1;
    const lane t166 = B_2_z*m_perp_2;
    const lane t167 = B_3_z*m_perp_3;
    const lane t168 = B_4_z*m_perp_4;
    const lane t169 = B_5_z*m_perp_5;
    const lane t170 = B_6_z*m_perp_6;
    const lane t171 = c_z*m_p;
    const lane M_p_x_ry = t165 + t166 + t167 + t168 + t169 + t170 + t171;
    const lane t172 = B_1_y*m_perp_1;
    const lane t173 = B_2_y*m_perp_2;
    const lane t174 = B_3_y*m_perp_3;
    const lane t175 = B_4_y*m_perp_4;
    const lane t176 = B_5_y*m_perp_5;
    const lane t177 = B_6_y*m_perp_6;
    const lane t178 = c_y*m_p;
    const lane M_p_z_rx = t172 + t173 + t174 + t175 + t176 + t177 + t178;
    const lane M_p_x_rz = -M_p_z_rx;
    const lane M_p_y_rx = -M_p_x_ry;
    const lane M_p_y_rz =
        B_1_x*m_perp_1 + B_2_x*m_perp_2 + B_3_x*m_perp_3 + B_4_x*m_perp_4 + B_5_x*m_perp_5 + B_6_x*m_perp_6
        + c_x*m_p;
    const lane M_p_z_ry = -M_p_y_rz;
    const lane t179 = 2.0*(c_y*c_y);
    const lane t180 = 2.0*(c_z*c_z);
    const double t181 = (1.0/2.0)*m_p;
    const lane t182 = 2.0*t92;
    const lane t183 = 2.0*t95;
    const lane t184 = (1.0/2.0)*m_perp_1;
    const lane t185 = 2.0*t93;
    const lane t186 = 2.0*t96;
    const lane t187 = (1.0/2.0)*m_perp_2;
    const lane t188 = 2.0*t88;
    const lane t189 = 2.0*t97;
    const lane t190 = (1.0/2.0)*m_perp_3;
    const lane t191 = 2.0*t89;
    const lane t192 = 2.0*t98;
    const lane t193 = (1.0/2.0)*m_perp_4;
    const lane t194 = 2.0*t90;
    const lane t195 = 2.0*t99;
    const lane t196 = (1.0/2.0)*m_perp_5;
    const lane t197 = 2.0*t91;
    const lane t198 = 2.0*t100;
    const lane t199 = (1.0/2.0)*m_perp_6;
    const lane M_p_rx_rx =
        J_x_x + t181*(t179 + t180) + t184*(t182 + t183) + t187*(t185 + t186) + t190*(t188 + t189)
        + t193*(t191 + t192) + t196*(t194 + t195) + t199*(t197 + t198);
    const lane M_p_rx_ry =
        -B_1_x*t172 - B_2_x*t173 - B_3_x*t174 - B_4_x*t175 - B_5_x*t176 - B_6_x*t177 + J_x_y - c_x*t178;
    const lane M_p_rx_rz =
        -B_1_x*t165 - B_2_x*t166 - B_3_x*t167 - B_4_x*t168 - B_5_x*t169 - B_6_x*t170 + J_x_z - c_x*t171;
    const lane t200 = 2.0*(c_x*c_x);
    const lane t201 = 2.0*t116;
    const lane t202 = 2.0*t117;
    const lane t203 = 2.0*t118;
    const lane t204 = 2.0*t119;
    const lane t205 = 2.0*t120;
    const lane t206 = 2.0*t121;
    const lane M_p_ry_ry =
        J_y_y + t181*(t180 + t200) + t184*(t183 + t201) + t187*(t186 + t202) + t190*(t189 + t203)
        + t193*(t192 + t204) + t196*(t195 + t205) + t199*(t198 + t206);
    const lane M_p_ry_rz =
        -B_1_y*t165 - B_2_y*t166 - B_3_y*t167 - B_4_y*t168 - B_5_y*t169 - B_6_y*t170 + J_y_z - c_y*t171;
    const lane M_p_rz_rz =
        J_z_z + t181*(t179 + t200) + t184*(t182 + t201) + t187*(t185 + t202) + t190*(t188 + t203)
        + t193*(t191 + t204) + t196*(t194 + t205) + t199*(t197 + t206);
    const lane h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const lane h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const lane h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const lane h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const lane h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const lane h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const lane h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const lane h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const lane h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const lane h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const lane h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const lane h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const lane h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const lane h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const lane h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const lane h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const lane h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const lane h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
    const lane h_rx_l_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx;
    const lane h_rx_l_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx;
    const lane h_rx_l_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx;
    const lane h_rx_l_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx;
    const lane h_rx_l_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx;
    const lane h_rx_l_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx;
    const lane h_ry_l_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry;
    const lane h_ry_l_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry;
    const lane h_ry_l_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry;
    const lane h_ry_l_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry;
    const lane h_ry_l_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry;
    const lane h_ry_l_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry;
    const lane h_rz_l_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz;
    const lane h_rz_l_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz;
    const lane h_rz_l_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz;
    const lane h_rz_l_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz;
    const lane h_rz_l_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz;
    const lane h_rz_l_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz;
    lanes_clear(M, 144);
    M[0] =
        LANES(D_p_rx_1*h_rx_l_1 + D_p_ry_1*h_ry_l_1 + D_p_rz_1*h_rz_l_1 + D_p_x_1*h_x_l_1 + D_p_y_1*h_y_l_1
        + D_p_z_1*h_z_l_1 - m_perp_1 + m_r_1);
    M[1] = M[12] =
        LANES(D_p_rx_1*h_rx_l_2 + D_p_ry_1*h_ry_l_2 + D_p_rz_1*h_rz_l_2 + D_p_x_1*h_x_l_2 + D_p_y_1*h_y_l_2
        + D_p_z_1*h_z_l_2);
    M[2] = M[24] =
        LANES(D_p_rx_1*h_rx_l_3 + D_p_ry_1*h_ry_l_3 + D_p_rz_1*h_rz_l_3 + D_p_x_1*h_x_l_3 + D_p_y_1*h_y_l_3
        + D_p_z_1*h_z_l_3);
    M[3] = M[36] =
        LANES(D_p_rx_1*h_rx_l_4 + D_p_ry_1*h_ry_l_4 + D_p_rz_1*h_rz_l_4 + D_p_x_1*h_x_l_4 + D_p_y_1*h_y_l_4
        + D_p_z_1*h_z_l_4);
    M[4] = M[48] =
        LANES(D_p_rx_1*h_rx_l_5 + D_p_ry_1*h_ry_l_5 + D_p_rz_1*h_rz_l_5 + D_p_x_1*h_x_l_5 + D_p_y_1*h_y_l_5
        + D_p_z_1*h_z_l_5);
    M[5] = M[60] =
        LANES(D_p_rx_1*h_rx_l_6 + D_p_ry_1*h_ry_l_6 + D_p_rz_1*h_rz_l_6 + D_p_x_1*h_x_l_6 + D_p_y_1*h_y_l_6
        + D_p_z_1*h_z_l_6);
    M[13] =
        LANES(D_p_rx_2*h_rx_l_2 + D_p_ry_2*h_ry_l_2 + D_p_rz_2*h_rz_l_2 + D_p_x_2*h_x_l_2 + D_p_y_2*h_y_l_2
        + D_p_z_2*h_z_l_2 - m_perp_2 + m_r_2);
    M[14] = M[25] =
        LANES(D_p_rx_2*h_rx_l_3 + D_p_ry_2*h_ry_l_3 + D_p_rz_2*h_rz_l_3 + D_p_x_2*h_x_l_3 + D_p_y_2*h_y_l_3
        + D_p_z_2*h_z_l_3);
    M[15] = M[37] =
        LANES(D_p_rx_2*h_rx_l_4 + D_p_ry_2*h_ry_l_4 + D_p_rz_2*h_rz_l_4 + D_p_x_2*h_x_l_4 + D_p_y_2*h_y_l_4
        + D_p_z_2*h_z_l_4);
    M[16] = M[49] =
        LANES(D_p_rx_2*h_rx_l_5 + D_p_ry_2*h_ry_l_5 + D_p_rz_2*h_rz_l_5 + D_p_x_2*h_x_l_5 + D_p_y_2*h_y_l_5
        + D_p_z_2*h_z_l_5);
    M[17] = M[61] =
        LANES(D_p_rx_2*h_rx_l_6 + D_p_ry_2*h_ry_l_6 + D_p_rz_2*h_rz_l_6 + D_p_x_2*h_x_l_6 + D_p_y_2*h_y_l_6
        + D_p_z_2*h_z_l_6);
    M[26] =
        LANES(D_p_rx_3*h_rx_l_3 + D_p_ry_3*h_ry_l_3 + D_p_rz_3*h_rz_l_3 + D_p_x_3*h_x_l_3 + D_p_y_3*h_y_l_3
        + D_p_z_3*h_z_l_3 - m_perp_3 + m_r_3);
    M[27] = M[38] =
        LANES(D_p_rx_3*h_rx_l_4 + D_p_ry_3*h_ry_l_4 + D_p_rz_3*h_rz_l_4 + D_p_x_3*h_x_l_4 + D_p_y_3*h_y_l_4
        + D_p_z_3*h_z_l_4);
    M[28] = M[50] =
        LANES(D_p_rx_3*h_rx_l_5 + D_p_ry_3*h_ry_l_5 + D_p_rz_3*h_rz_l_5 + D_p_x_3*h_x_l_5 + D_p_y_3*h_y_l_5
        + D_p_z_3*h_z_l_5);
    M[29] = M[62] =
        LANES(D_p_rx_3*h_rx_l_6 + D_p_ry_3*h_ry_l_6 + D_p_rz_3*h_rz_l_6 + D_p_x_3*h_x_l_6 + D_p_y_3*h_y_l_6
        + D_p_z_3*h_z_l_6);
    M[39] =
        LANES(D_p_rx_4*h_rx_l_4 + D_p_ry_4*h_ry_l_4 + D_p_rz_4*h_rz_l_4 + D_p_x_4*h_x_l_4 + D_p_y_4*h_y_l_4
        + D_p_z_4*h_z_l_4 - m_perp_4 + m_r_4);
    M[40] = M[51] =
        LANES(D_p_rx_4*h_rx_l_5 + D_p_ry_4*h_ry_l_5 + D_p_rz_4*h_rz_l_5 + D_p_x_4*h_x_l_5 + D_p_y_4*h_y_l_5
        + D_p_z_4*h_z_l_5);
    M[41] = M[63] =
        LANES(D_p_rx_4*h_rx_l_6 + D_p_ry_4*h_ry_l_6 + D_p_rz_4*h_rz_l_6 + D_p_x_4*h_x_l_6 + D_p_y_4*h_y_l_6
        + D_p_z_4*h_z_l_6);
    M[52] =
        LANES(D_p_rx_5*h_rx_l_5 + D_p_ry_5*h_ry_l_5 + D_p_rz_5*h_rz_l_5 + D_p_x_5*h_x_l_5 + D_p_y_5*h_y_l_5
        + D_p_z_5*h_z_l_5 - m_perp_5 + m_r_5);
    M[53] = M[64] =
        LANES(D_p_rx_5*h_rx_l_6 + D_p_ry_5*h_ry_l_6 + D_p_rz_5*h_rz_l_6 + D_p_x_5*h_x_l_6 + D_p_y_5*h_y_l_6
        + D_p_z_5*h_z_l_6);
    M[65] =
        LANES(D_p_rx_6*h_rx_l_6 + D_p_ry_6*h_ry_l_6 + D_p_rz_6*h_rz_l_6 + D_p_x_6*h_x_l_6 + D_p_y_6*h_y_l_6
        + D_p_z_6*h_z_l_6 - m_perp_6 + m_r_6);
    M[78] = LANES(I_m_1/(h_m_1*h_m_1));
    M[91] = LANES(I_m_2/(h_m_2*h_m_2));
    M[104] = LANES(I_m_3/(h_m_3*h_m_3));
    M[117] = LANES(I_m_4/(h_m_4*h_m_4));
    M[130] = LANES(I_m_5/(h_m_5*h_m_5));
    M[143] = LANES(I_m_6/(h_m_6*h_m_6));
    lanes_clear(K, 144);
    K[0] =
        LANES(D_p_rx_1*f_rx_l_1 - D_p_rx_1*t147 + D_p_ry_1*f_ry_l_1 - D_p_ry_1*t153 + D_p_rz_1*f_rz_l_1
        - D_p_rz_1*t159 + D_p_x_1*f_x_l_1 + D_p_x_1*t124 + D_p_y_1*f_y_l_1 + D_p_y_1*t135 + D_p_z_1*f_z_l_1
        + D_p_z_1*t141 + k_l_1 + mu_1 + 2.0*t32*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1*l_1));
    K[1] = K[12] =
        LANES(D_p_rx_1*f_rx_l_2 - D_p_rx_2*t147 + D_p_ry_1*f_ry_l_2 - D_p_ry_2*t153 + D_p_rz_1*f_rz_l_2
        - D_p_rz_2*t159 + D_p_x_1*f_x_l_2 + D_p_x_2*t124 + D_p_y_1*f_y_l_2 + D_p_y_2*t135 + D_p_z_1*f_z_l_2
        + D_p_z_2*t141);
    K[2] = K[24] =
        LANES(D_p_rx_1*f_rx_l_3 - D_p_rx_3*t147 + D_p_ry_1*f_ry_l_3 - D_p_ry_3*t153 + D_p_rz_1*f_rz_l_3
        - D_p_rz_3*t159 + D_p_x_1*f_x_l_3 + D_p_x_3*t124 + D_p_y_1*f_y_l_3 + D_p_y_3*t135 + D_p_z_1*f_z_l_3
        + D_p_z_3*t141);
    K[3] = K[36] =
        LANES(D_p_rx_1*f_rx_l_4 - D_p_rx_4*t147 + D_p_ry_1*f_ry_l_4 - D_p_ry_4*t153 + D_p_rz_1*f_rz_l_4
        - D_p_rz_4*t159 + D_p_x_1*f_x_l_4 + D_p_x_4*t124 + D_p_y_1*f_y_l_4 + D_p_y_4*t135 + D_p_z_1*f_z_l_4
        + D_p_z_4*t141);
    K[4] = K[48] =
        LANES(D_p_rx_1*f_rx_l_5 - D_p_rx_5*t147 + D_p_ry_1*f_ry_l_5 - D_p_ry_5*t153 + D_p_rz_1*f_rz_l_5
        - D_p_rz_5*t159 + D_p_x_1*f_x_l_5 + D_p_x_5*t124 + D_p_y_1*f_y_l_5 + D_p_y_5*t135 + D_p_z_1*f_z_l_5
        + D_p_z_5*t141);
    K[5] = K[60] =
        LANES(D_p_rx_1*f_rx_l_6 - D_p_rx_6*t147 + D_p_ry_1*f_ry_l_6 - D_p_ry_6*t153 + D_p_rz_1*f_rz_l_6
        - D_p_rz_6*t159 + D_p_x_1*f_x_l_6 + D_p_x_6*t124 + D_p_y_1*f_y_l_6 + D_p_y_6*t135 + D_p_z_1*f_z_l_6
        + D_p_z_6*t141);
    K[6] = K[72] = LANES(-k_l_1);
    K[13] =
        LANES(D_p_rx_2*f_rx_l_2 - D_p_rx_2*t148 + D_p_ry_2*f_ry_l_2 - D_p_ry_2*t154 + D_p_rz_2*f_rz_l_2
        - D_p_rz_2*t160 + D_p_x_2*f_x_l_2 + D_p_x_2*t126 + D_p_y_2*f_y_l_2 + D_p_y_2*t136 + D_p_z_2*f_z_l_2
        + D_p_z_2*t142 + k_l_2 + mu_2 + 2.0*t35*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2*l_2));
    K[14] = K[25] =
        LANES(D_p_rx_2*f_rx_l_3 - D_p_rx_3*t148 + D_p_ry_2*f_ry_l_3 - D_p_ry_3*t154 + D_p_rz_2*f_rz_l_3
        - D_p_rz_3*t160 + D_p_x_2*f_x_l_3 + D_p_x_3*t126 + D_p_y_2*f_y_l_3 + D_p_y_3*t136 + D_p_z_2*f_z_l_3
        + D_p_z_3*t142);
    K[15] = K[37] =
        LANES(D_p_rx_2*f_rx_l_4 - D_p_rx_4*t148 + D_p_ry_2*f_ry_l_4 - D_p_ry_4*t154 + D_p_rz_2*f_rz_l_4
        - D_p_rz_4*t160 + D_p_x_2*f_x_l_4 + D_p_x_4*t126 + D_p_y_2*f_y_l_4 + D_p_y_4*t136 + D_p_z_2*f_z_l_4
        + D_p_z_4*t142);
    K[16] = K[49] =
        LANES(D_p_rx_2*f_rx_l_5 - D_p_rx_5*t148 + D_p_ry_2*f_ry_l_5 - D_p_ry_5*t154 + D_p_rz_2*f_rz_l_5
        - D_p_rz_5*t160 + D_p_x_2*f_x_l_5 + D_p_x_5*t126 + D_p_y_2*f_y_l_5 + D_p_y_5*t136 + D_p_z_2*f_z_l_5
        + D_p_z_5*t142);
    K[17] = K[61] =
        LANES(D_p_rx_2*f_rx_l_6 - D_p_rx_6*t148 + D_p_ry_2*f_ry_l_6 - D_p_ry_6*t154 + D_p_rz_2*f_rz_l_6
        - D_p_rz_6*t160 + D_p_x_2*f_x_l_6 + D_p_x_6*t126 + D_p_y_2*f_y_l_6 + D_p_y_6*t136 + D_p_z_2*f_z_l_6
        + D_p_z_6*t142);
    K[19] = K[85] = LANES(-k_l_2);
    K[26] =
        LANES(D_p_rx_3*f_rx_l_3 - D_p_rx_3*t149 + D_p_ry_3*f_ry_l_3 - D_p_ry_3*t155 + D_p_rz_3*f_rz_l_3
        - D_p_rz_3*t161 + D_p_x_3*f_x_l_3 + D_p_x_3*t128 + D_p_y_3*f_y_l_3 + D_p_y_3*t137 + D_p_z_3*f_z_l_3
        + D_p_z_3*t143 + k_l_3 + mu_3 + 2.0*t38*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3*l_3));
    K[27] = K[38] =
        LANES(D_p_rx_3*f_rx_l_4 - D_p_rx_4*t149 + D_p_ry_3*f_ry_l_4 - D_p_ry_4*t155 + D_p_rz_3*f_rz_l_4
        - D_p_rz_4*t161 + D_p_x_3*f_x_l_4 + D_p_x_4*t128 + D_p_y_3*f_y_l_4 + D_p_y_4*t137 + D_p_z_3*f_z_l_4
        + D_p_z_4*t143);
    K[28] = K[50] =
        LANES(D_p_rx_3*f_rx_l_5 - D_p_rx_5*t149 + D_p_ry_3*f_ry_l_5 - D_p_ry_5*t155 + D_p_rz_3*f_rz_l_5
        - D_p_rz_5*t161 + D_p_x_3*f_x_l_5 + D_p_x_5*t128 + D_p_y_3*f_y_l_5 + D_p_y_5*t137 + D_p_z_3*f_z_l_5
        + D_p_z_5*t143);
    K[29] = K[62] =
        LANES(D_p_rx_3*f_rx_l_6 - D_p_rx_6*t149 + D_p_ry_3*f_ry_l_6 - D_p_ry_6*t155 + D_p_rz_3*f_rz_l_6
        - D_p_rz_6*t161 + D_p_x_3*f_x_l_6 + D_p_x_6*t128 + D_p_y_3*f_y_l_6 + D_p_y_6*t137 + D_p_z_3*f_z_l_6
        + D_p_z_6*t143);
    K[32] = K[98] = LANES(-k_l_3);
    K[39] =
        LANES(D_p_rx_4*f_rx_l_4 - D_p_rx_4*t150 + D_p_ry_4*f_ry_l_4 - D_p_ry_4*t156 + D_p_rz_4*f_rz_l_4
        - D_p_rz_4*t162 + D_p_x_4*f_x_l_4 + D_p_x_4*t130 + D_p_y_4*f_y_l_4 + D_p_y_4*t138 + D_p_z_4*f_z_l_4
        + D_p_z_4*t144 + k_l_4 + mu_4 + 2.0*t41*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4*l_4));
    K[40] = K[51] =
        LANES(D_p_rx_4*f_rx_l_5 - D_p_rx_5*t150 + D_p_ry_4*f_ry_l_5 - D_p_ry_5*t156 + D_p_rz_4*f_rz_l_5
        - D_p_rz_5*t162 + D_p_x_4*f_x_l_5 + D_p_x_5*t130 + D_p_y_4*f_y_l_5 + D_p_y_5*t138 + D_p_z_4*f_z_l_5
        + D_p_z_5*t144);
    K[41] = K[63] =
        LANES(D_p_rx_4*f_rx_l_6 - D_p_rx_6*t150 + D_p_ry_4*f_ry_l_6 - D_p_ry_6*t156 + D_p_rz_4*f_rz_l_6
        - D_p_rz_6*t162 + D_p_x_4*f_x_l_6 + D_p_x_6*t130 + D_p_y_4*f_y_l_6 + D_p_y_6*t138 + D_p_z_4*f_z_l_6
        + D_p_z_6*t144);
    K[45] = K[111] = LANES(-k_l_4);
    K[52] =
        LANES(D_p_rx_5*f_rx_l_5 - D_p_rx_5*t151 + D_p_ry_5*f_ry_l_5 - D_p_ry_5*t157 + D_p_rz_5*f_rz_l_5
        - D_p_rz_5*t163 + D_p_x_5*f_x_l_5 + D_p_x_5*t132 + D_p_y_5*f_y_l_5 + D_p_y_5*t139 + D_p_z_5*f_z_l_5
        + D_p_z_5*t145 + k_l_5 + mu_5 + 2.0*t44*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5*l_5));
    K[53] = K[64] =
        LANES(D_p_rx_5*f_rx_l_6 - D_p_rx_6*t151 + D_p_ry_5*f_ry_l_6 - D_p_ry_6*t157 + D_p_rz_5*f_rz_l_6
        - D_p_rz_6*t163 + D_p_x_5*f_x_l_6 + D_p_x_6*t132 + D_p_y_5*f_y_l_6 + D_p_y_6*t139 + D_p_z_5*f_z_l_6
        + D_p_z_6*t145);
    K[58] = K[124] = LANES(-k_l_5);
    K[65] =
        LANES(D_p_rx_6*f_rx_l_6 - D_p_rx_6*t152 + D_p_ry_6*f_ry_l_6 - D_p_ry_6*t158 + D_p_rz_6*f_rz_l_6
        - D_p_rz_6*t164 + D_p_x_6*f_x_l_6 + D_p_x_6*t134 + D_p_y_6*f_y_l_6 + D_p_y_6*t140 + D_p_z_6*f_z_l_6
        + D_p_z_6*t146 + k_l_6 + mu_6 + 2.0*t47*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6*l_6));
    K[71] = K[137] = LANES(-k_l_6);
    K[78] = LANES(k_l_1);
    K[91] = LANES(k_l_2);
    K[104] = LANES(k_l_3);
    K[117] = LANES(k_l_4);
    K[130] = LANES(k_l_5);
    K[143] = LANES(k_l_6);
    lanes_clear(J_p, 72);
    J_p[0] = LANES(D_p_x_1);
    J_p[1] = LANES(D_p_x_2);
    J_p[2] = LANES(D_p_x_3);
    J_p[3] = LANES(D_p_x_4);
    J_p[4] = LANES(D_p_x_5);
    J_p[5] = LANES(D_p_x_6);
    J_p[12] = LANES(D_p_y_1);
    J_p[13] = LANES(D_p_y_2);
    J_p[14] = LANES(D_p_y_3);
    J_p[15] = LANES(D_p_y_4);
    J_p[16] = LANES(D_p_y_5);
    J_p[17] = LANES(D_p_y_6);
    J_p[24] = LANES(D_p_z_1);
    J_p[25] = LANES(D_p_z_2);
    J_p[26] = LANES(D_p_z_3);
    J_p[27] = LANES(D_p_z_4);
    J_p[28] = LANES(D_p_z_5);
    J_p[29] = LANES(D_p_z_6);
    J_p[36] = LANES(D_p_rx_1);
    J_p[37] = LANES(D_p_rx_2);
    J_p[38] = LANES(D_p_rx_3);
    J_p[39] = LANES(D_p_rx_4);
    J_p[40] = LANES(D_p_rx_5);
    J_p[41] = LANES(D_p_rx_6);
    J_p[48] = LANES(D_p_ry_1);
    J_p[49] = LANES(D_p_ry_2);
    J_p[50] = LANES(D_p_ry_3);
    J_p[51] = LANES(D_p_ry_4);
    J_p[52] = LANES(D_p_ry_5);
    J_p[53] = LANES(D_p_ry_6);
    J_p[60] = LANES(D_p_rz_1);
    J_p[61] = LANES(D_p_rz_2);
    J_p[62] = LANES(D_p_rz_3);
    J_p[63] = LANES(D_p_rz_4);
    J_p[64] = LANES(D_p_rz_5);
    J_p[65] = LANES(D_p_rz_6);
}

/* Mass and stiffness matrices with all released joints free, and the motion of the platform.
 *
 * Source: extended_matrices and extended_platform_motion.
 * 4447 operations; 9994843392 with every named value expanded.
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
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double m_p = parameters[0];
    const double c_p_x = parameters[1];
    const double c_p_y = parameters[2];
    const double c_p_z = parameters[3];
    const double I_p_x = parameters[4];
    const double I_p_y = parameters[5];
    const double I_p_z = parameters[6];
    const double I_p_xy = parameters[7];
    const double I_p_xz = parameters[8];
    const double I_p_yz = parameters[9];
    const double g_x = parameters[10];
    const double g_y = parameters[11];
    const double g_z = parameters[12];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double k_l_1 = parameters[61];
    const double k_l_2 = parameters[62];
    const double k_l_3 = parameters[63];
    const double k_l_4 = parameters[64];
    const double k_l_5 = parameters[65];
    const double k_l_6 = parameters[66];
    const double m_b_1 = parameters[67];
    const double m_b_2 = parameters[68];
    const double m_b_3 = parameters[69];
    const double m_b_4 = parameters[70];
    const double m_b_5 = parameters[71];
    const double m_b_6 = parameters[72];
    const double c_b_1 = parameters[73];
    const double c_b_2 = parameters[74];
    const double c_b_3 = parameters[75];
    const double c_b_4 = parameters[76];
    const double c_b_5 = parameters[77];
    const double c_b_6 = parameters[78];
    const double I_b_1 = parameters[79];
    const double I_b_2 = parameters[80];
    const double I_b_3 = parameters[81];
    const double I_b_4 = parameters[82];
    const double I_b_5 = parameters[83];
    const double I_b_6 = parameters[84];
    const double m_r_1 = parameters[85];
    const double m_r_2 = parameters[86];
    const double m_r_3 = parameters[87];
    const double m_r_4 = parameters[88];
    const double m_r_5 = parameters[89];
    const double m_r_6 = parameters[90];
    const double c_r_1 = parameters[91];
    const double c_r_2 = parameters[92];
    const double c_r_3 = parameters[93];
    const double c_r_4 = parameters[94];
    const double c_r_5 = parameters[95];
    const double c_r_6 = parameters[96];
    const double I_r_1 = parameters[97];
    const double I_r_2 = parameters[98];
    const double I_r_3 = parameters[99];
    const double I_r_4 = parameters[100];
    const double I_r_5 = parameters[101];
    const double I_r_6 = parameters[102];
    const double I_m_1 = parameters[103];
    const double I_m_2 = parameters[104];
    const double I_m_3 = parameters[105];
    const double I_m_4 = parameters[106];
    const double I_m_5 = parameters[107];
    const double I_m_6 = parameters[108];
    const double h_m_1 = parameters[109];
    const double h_m_2 = parameters[110];
    const double h_m_3 = parameters[111];
    const double h_m_4 = parameters[112];
    const double h_m_5 = parameters[113];
    const double h_m_6 = parameters[114];
    const double a_S_1 = effects[0];
    const double a_S_2 = effects[1];
    const double a_S_3 = effects[2];
    const double a_S_4 = effects[3];
    const double a_S_5 = effects[4];
    const double a_S_6 = effects[5];
    const double k_C = effects[6];
    const double I_G = effects[8];
    const double m_L = effects[9];
    const double b_L_x = effects[10];
    const double b_L_y = effects[11];
    const double b_L_z = effects[12];
    const double k_S = effects[13];
    const double m_F = effects[15];
    const lane t1 = (rot_x*rot_x);
    const lane t2 = (rot_y*rot_y);
    const lane t3 = (rot_z*rot_z);
    const lane t4 = t2 + t3;
    const lane half_angle = (1.0/2.0)*lanes_sqrt(t1 + t4 + 1e-30);
    const lane s_half = lanes_sin(half_angle)/half_angle;
    const lane t5 = (s_half*s_half);
    const lane t6 = (1.0/2.0)*t5;
    const lane R_x_x = -t4*t6 + 1.0;
    const lane c_half = lanes_cos(half_angle);
    const lane t7 = c_half*s_half;
    const lane t8 = rot_z*t7;
    const lane R_x_y = (1.0/2.0)*rot_x*rot_y*t5 - t8;
    const lane t9 = rot_y*t7;
    const lane t10 = rot_x*t6;
    const lane R_x_z = rot_z*t10 + t9;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = rot_y*t10 + t8;
    const lane R_y_y = t6*(-t1 - t3) + 1.0;
    const lane t11 = rot_x*t7;
    const lane R_y_z = (1.0/2.0)*rot_y*rot_z*t5 - t11;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = (1.0/2.0)*rot_x*rot_z*t5 - t9;
    const lane R_z_y = rot_y*rot_z*t6 + t11;
    const lane R_z_z = t6*(-t1 - t2) + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane l_1 = lanes_sqrt((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const lane l_2 = lanes_sqrt((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const lane l_3 = lanes_sqrt((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const lane l_4 = lanes_sqrt((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const lane l_5 = lanes_sqrt((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const lane l_6 = lanes_sqrt((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const lane c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const lane c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const lane c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const lane t12 = I_p_xy*R_x_x;
    const lane t13 = I_p_xz*R_x_x;
    const lane t14 = 2.0*R_x_z;
    const lane t15 = I_p_yz*R_x_y;
    const lane J_x_x =
        I_p_x*(R_x_x*R_x_x) + I_p_y*(R_x_y*R_x_y) + I_p_z*(R_x_z*R_x_z) + 2.0*R_x_y*t12 + t13*t14 + t14*t15;
    const lane t16 = I_p_x*R_x_x;
    const lane t17 = I_p_xy*R_x_y;
    const lane t18 = I_p_xz*R_x_z;
    const lane t19 = I_p_y*R_x_y;
    const lane t20 = I_p_yz*R_x_z;
    const lane t21 = I_p_z*R_x_z;
    const lane J_x_y =
        R_y_x*t16 + R_y_x*t17 + R_y_x*t18 + R_y_y*t12 + R_y_y*t19 + R_y_y*t20 + R_y_z*t13 + R_y_z*t15
        + R_y_z*t21;
    const lane J_x_z =
        R_z_x*t16 + R_z_x*t17 + R_z_x*t18 + R_z_y*t12 + R_z_y*t19 + R_z_y*t20 + R_z_z*t13 + R_z_z*t15
        + R_z_z*t21;
    const lane t22 = I_p_xy*R_y_x;
    const lane t23 = I_p_xz*R_y_x;
    const lane t24 = 2.0*R_y_z;
    const lane t25 = I_p_yz*R_y_y;
    const lane J_y_y =
        I_p_x*(R_y_x*R_y_x) + I_p_y*(R_y_y*R_y_y) + I_p_z*(R_y_z*R_y_z) + 2.0*R_y_y*t22 + t23*t24 + t24*t25;
    const lane t26 = I_p_xy*R_z_x;
    const lane t27 = I_p_xz*R_z_x;
    const lane t28 = I_p_yz*R_z_y;
    const lane J_y_z =
        I_p_x*R_y_x*R_z_x + I_p_y*R_y_y*R_z_y + I_p_z*R_y_z*R_z_z + R_y_y*t26 + R_y_z*t27 + R_y_z*t28
        + R_z_y*t22 + R_z_z*t23 + R_z_z*t25;
    const lane t29 = 2.0*R_z_z;
    const lane J_z_z =
        I_p_x*(R_z_x*R_z_x) + I_p_y*(R_z_y*R_z_y) + I_p_z*(R_z_z*R_z_z) + 2.0*R_z_y*t26 + t27*t29 + t28*t29;
    const lane t30 = 1.0/((l_1*l_1));
    const lane t31 = 1.0/l_1;
    const lane m_perp_1 =
        I_b_1*t30 + I_r_1*t30 + (c_b_1*c_b_1)*m_b_1*t30 + m_r_1*((-c_r_1*t31 + 1.0)*(-c_r_1*t31 + 1.0));
    const double t32 = c_b_1*m_b_1 - c_r_1*m_r_1;
    const lane t33 = t31*t32;
    const lane m_lift_1 = m_r_1 + t33;
    const lane t34 = 1.0/((l_2*l_2));
    const lane t35 = 1.0/l_2;
    const lane m_perp_2 =
        I_b_2*t34 + I_r_2*t34 + (c_b_2*c_b_2)*m_b_2*t34 + m_r_2*((-c_r_2*t35 + 1.0)*(-c_r_2*t35 + 1.0));
    const double t36 = c_b_2*m_b_2 - c_r_2*m_r_2;
    const lane t37 = t35*t36;
    const lane m_lift_2 = m_r_2 + t37;
    const lane t38 = 1.0/((l_3*l_3));
    const lane t39 = 1.0/l_3;
    const lane m_perp_3 =
        I_b_3*t38 + I_r_3*t38 + (c_b_3*c_b_3)*m_b_3*t38 + m_r_3*((-c_r_3*t39 + 1.0)*(-c_r_3*t39 + 1.0));
    const double t40 = c_b_3*m_b_3 - c_r_3*m_r_3;
    const lane t41 = t39*t40;
    const lane m_lift_3 = m_r_3 + t41;
    const lane t42 = 1.0/((l_4*l_4));
    const lane t43 = 1.0/l_4;
    const lane m_perp_4 =
        I_b_4*t42 + I_r_4*t42 + (c_b_4*c_b_4)*m_b_4*t42 + m_r_4*((-c_r_4*t43 + 1.0)*(-c_r_4*t43 + 1.0));
    const double t44 = c_b_4*m_b_4 - c_r_4*m_r_4;
    const lane t45 = t43*t44;
    const lane m_lift_4 = m_r_4 + t45;
    const lane t46 = 1.0/((l_5*l_5));
    const lane t47 = 1.0/l_5;
    const lane m_perp_5 =
        I_b_5*t46 + I_r_5*t46 + (c_b_5*c_b_5)*m_b_5*t46 + m_r_5*((-c_r_5*t47 + 1.0)*(-c_r_5*t47 + 1.0));
    const double t48 = c_b_5*m_b_5 - c_r_5*m_r_5;
    const lane t49 = t47*t48;
    const lane m_lift_5 = m_r_5 + t49;
    const lane t50 = 1.0/((l_6*l_6));
    const lane t51 = 1.0/l_6;
    const lane m_perp_6 =
        I_b_6*t50 + I_r_6*t50 + (c_b_6*c_b_6)*m_b_6*t50 + m_r_6*((-c_r_6*t51 + 1.0)*(-c_r_6*t51 + 1.0));
    const double t52 = c_b_6*m_b_6 - c_r_6*m_r_6;
    const lane t53 = t51*t52;
    const lane m_lift_6 = m_r_6 + t53;
    const lane o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const lane o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const lane o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane t54 = 1.0/det_D_l;
    const lane t55 = l_1*t54;
    const lane D_p_x_1 = A_x_1*t55;
    const lane t56 = l_2*t54;
    const lane D_p_x_2 = A_x_2*t56;
    const lane t57 = l_3*t54;
    const lane D_p_x_3 = A_x_3*t57;
    const lane t58 = l_4*t54;
    const lane D_p_x_4 = A_x_4*t58;
    const lane t59 = l_5*t54;
    const lane D_p_x_5 = A_x_5*t59;
    const lane t60 = l_6*t54;
    const lane D_p_x_6 = A_x_6*t60;
    const lane D_p_y_1 = A_y_1*t55;
    const lane D_p_y_2 = A_y_2*t56;
    const lane D_p_y_3 = A_y_3*t57;
    const lane D_p_y_4 = A_y_4*t58;
    const lane D_p_y_5 = A_y_5*t59;
    const lane D_p_y_6 = A_y_6*t60;
    const lane D_p_z_1 = A_z_1*t55;
    const lane D_p_z_2 = A_z_2*t56;
    const lane D_p_z_3 = A_z_3*t57;
    const lane D_p_z_4 = A_z_4*t58;
    const lane D_p_z_5 = A_z_5*t59;
    const lane D_p_z_6 = A_z_6*t60;
    const lane D_p_rx_1 = A_rx_1*t55;
    const lane D_p_rx_2 = A_rx_2*t56;
    const lane D_p_rx_3 = A_rx_3*t57;
    const lane D_p_rx_4 = A_rx_4*t58;
    const lane D_p_rx_5 = A_rx_5*t59;
    const lane D_p_rx_6 = A_rx_6*t60;
    const lane D_p_ry_1 = A_ry_1*t55;
    const lane D_p_ry_2 = A_ry_2*t56;
    const lane D_p_ry_3 = A_ry_3*t57;
    const lane D_p_ry_4 = A_ry_4*t58;
    const lane D_p_ry_5 = A_ry_5*t59;
    const lane D_p_ry_6 = A_ry_6*t60;
    const lane D_p_rz_1 = A_rz_1*t55;
    const lane D_p_rz_2 = A_rz_2*t56;
    const lane D_p_rz_3 = A_rz_3*t57;
    const lane D_p_rz_4 = A_rz_4*t58;
    const lane D_p_rz_5 = A_rz_5*t59;
    const lane D_p_rz_6 = A_rz_6*t60;
    const double k_1 = k_l_1*(a_S_1 + 1.0);
    const double k_2 = k_l_2*(a_S_2 + 1.0);
    const double k_3 = k_l_3*(a_S_3 + 1.0);
    const double k_4 = k_l_4*(a_S_4 + 1.0);
    const double k_5 = k_l_5*(a_S_5 + 1.0);
    const double k_6 = k_l_6*(a_S_6 + 1.0);
    const lane t61 = g_x*m_lift_1;
    const lane t62 = g_x*m_lift_2;
    const lane t63 = g_x*m_lift_3;
    const lane t64 = g_x*m_lift_4;
    const lane t65 = g_x*m_lift_5;
    const lane t66 = g_x*m_lift_6;
    const double t67 = m_L + m_p;
    const lane G_p_x = -g_x*t67 - t61 - t62 - t63 - t64 - t65 - t66;
    const lane t68 = g_y*m_lift_1;
    const lane t69 = g_y*m_lift_2;
    const lane t70 = g_y*m_lift_3;
    const lane t71 = g_y*m_lift_4;
    const lane t72 = g_y*m_lift_5;
    const lane t73 = g_y*m_lift_6;
    const lane G_p_y = -g_y*t67 - t68 - t69 - t70 - t71 - t72 - t73;
    const lane t74 = g_z*m_lift_1;
    const lane t75 = g_z*m_lift_2;
    const lane t76 = g_z*m_lift_3;
    const lane t77 = g_z*m_lift_4;
    const lane t78 = g_z*m_lift_5;
    const lane t79 = g_z*m_lift_6;
    const lane G_p_z = -g_z*t67 - t74 - t75 - t76 - t77 - t78 - t79;
    const double t80 = g_z*m_p;
    const double t81 = g_z*m_L;
    const lane G_p_rx =
        -B_1_y*t74 + B_1_z*g_y*m_lift_1 - B_2_y*t75 + B_2_z*g_y*m_lift_2 - B_3_y*t76 + B_3_z*g_y*m_lift_3
        - B_4_y*t77 + B_4_z*g_y*m_lift_4 - B_5_y*t78 + B_5_z*g_y*m_lift_5 - B_6_y*t79 + B_6_z*g_y*m_lift_6
        - c_y*t80 + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t81;
    const double t82 = g_x*m_p;
    const double t83 = g_x*m_L;
    const lane G_p_ry =
        B_1_x*t74 - B_1_z*t61 + B_2_x*t75 - B_2_z*t62 + B_3_x*t76 - B_3_z*t63 + B_4_x*t77 - B_4_z*t64
        + B_5_x*t78 - B_5_z*t65 + B_6_x*t79 - B_6_z*t66 + c_x*t80 - c_z*t82 + o_L_x*t81 - o_L_z*t83;
    const double t84 = g_y*m_p;
    const double t85 = g_y*m_L;
    const lane G_p_rz =
        -B_1_x*t68 + B_1_y*g_x*m_lift_1 - B_2_x*t69 + B_2_y*g_x*m_lift_2 - B_3_x*t70 + B_3_y*g_x*m_lift_3
        - B_4_x*t71 + B_4_y*g_x*m_lift_4 - B_5_x*t72 + B_5_y*g_x*m_lift_5 - B_6_x*t73 + B_6_y*g_x*m_lift_6
        - c_x*t84 + c_y*g_x*m_p + g_x*m_L*o_L_y - o_L_x*t85;
    const lane mu_1 =
        t54*(A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z);
    const lane mu_2 =
        t54*(A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z);
    const lane mu_3 =
        t54*(A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z);
    const lane mu_4 =
        t54*(A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z);
    const lane mu_5 =
        t54*(A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z);
    const lane mu_6 =
        t54*(A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z);
    const lane g_4_x = -d_1_x*mu_1 - t61;
    const lane g_4_y = -d_1_y*mu_1 - t68;
    const lane g_4_z = -d_1_z*mu_1 - t74;
    const lane g_5_x = -d_2_x*mu_2 - t62;
    const lane g_5_y = -d_2_y*mu_2 - t69;
    const lane g_5_z = -d_2_z*mu_2 - t75;
    const lane g_6_x = -d_3_x*mu_3 - t63;
    const lane g_6_y = -d_3_y*mu_3 - t70;
    const lane g_6_z = -d_3_z*mu_3 - t76;
    const lane g_7_x = -d_4_x*mu_4 - t64;
    const lane g_7_y = -d_4_y*mu_4 - t71;
    const lane g_7_z = -d_4_z*mu_4 - t77;
    const lane g_8_x = -d_5_x*mu_5 - t65;
    const lane g_8_y = -d_5_y*mu_5 - t72;
    const lane g_8_z = -d_5_z*mu_5 - t78;
    const lane g_9_x = -d_6_x*mu_6 - t66;
    const lane g_9_y = -d_6_y*mu_6 - t73;
    const lane g_9_z = -d_6_z*mu_6 - t79;
    const double g_10_x = -t82;
    const double g_10_y = -t84;
    const double g_10_z = -t80;
    const double g_11_x = -t83;
    const double g_11_y = -t85;
    const double g_11_z = -t81;
    const lane L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const lane t86 = B_1_z*mu_1;
    const lane t87 = B_2_z*mu_2;
    const lane t88 = B_3_z*mu_3;
    const lane t89 = B_4_z*mu_4;
    const lane t90 = B_5_z*mu_5;
    const lane t91 = B_6_z*mu_6;
    const lane L_y_rx = t86 + t87 + t88 + t89 + t90 + t91;
    const lane L_x_ry = -L_y_rx;
    const lane t92 = B_2_y*mu_2;
    const lane t93 = B_3_y*mu_3;
    const lane t94 = B_4_y*mu_4;
    const lane t95 = B_5_y*mu_5;
    const lane t96 = B_6_y*mu_6;
    const lane t97 = B_1_y*mu_1;
    const lane L_x_rz = t92 + t93 + t94 + t95 + t96 + t97;
    const lane L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const lane L_y_rz = -L_z_ry;
    const lane L_z_rx = -L_x_rz;
    const lane t98 = (B_1_z*B_1_z);
    const lane t99 = (B_2_z*B_2_z);
    const lane t100 = (B_3_z*B_3_z);
    const lane t101 = (B_4_z*B_4_z);
    const lane t102 = (B_5_z*B_5_z);
    const lane t103 = (B_6_z*B_6_z);
    const lane t104 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + g_11_z*o_L_z + mu_1*t98 + mu_2*t99 + mu_3*t100 + mu_4*t101 + mu_5*t102 + mu_6*t103;
    const lane t105 = (B_1_y*B_1_y);
    const lane t106 = (B_2_y*B_2_y);
    const lane t107 = (B_3_y*B_3_y);
    const lane t108 = (B_4_y*B_4_y);
    const lane t109 = (B_5_y*B_5_y);
    const lane t110 = (B_6_y*B_6_y);
    const lane t111 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + g_11_y*o_L_y + mu_1*t105 + mu_2*t106 + mu_3*t107 + mu_4*t108 + mu_5*t109 + mu_6*t110;
    const lane L_rx_rx = -t104 - t111;
    const lane t112 = (1.0/2.0)*B_1_x;
    const lane t113 = (1.0/2.0)*g_4_x;
    const lane t114 = (1.0/2.0)*B_2_x;
    const lane t115 = (1.0/2.0)*g_5_x;
    const lane t116 = (1.0/2.0)*B_3_x;
    const lane t117 = (1.0/2.0)*g_6_x;
    const lane t118 = (1.0/2.0)*B_4_x;
    const lane t119 = (1.0/2.0)*g_7_x;
    const lane t120 = (1.0/2.0)*B_5_x;
    const lane t121 = (1.0/2.0)*g_8_x;
    const lane t122 = (1.0/2.0)*B_6_x;
    const lane t123 = (1.0/2.0)*g_9_x;
    const lane t124 = (1.0/2.0)*c_x;
    const double t125 = (1.0/2.0)*g_10_x;
    const double t126 = (1.0/2.0)*g_11_x;
    const lane t127 = (1.0/2.0)*o_L_x;
    const lane L_rx_ry =
        B_1_x*t97 + B_1_y*t113 + B_2_x*t92 + B_2_y*t115 + B_3_x*t93 + B_3_y*t117 + B_4_x*t94 + B_4_y*t119
        + B_5_x*t95 + B_5_y*t121 + B_6_x*t96 + B_6_y*t123 + c_y*t125 + g_10_y*t124 + g_11_y*t127 + g_4_y*t112
        + g_5_y*t114 + g_6_y*t116 + g_7_y*t118 + g_8_y*t120 + g_9_y*t122 + o_L_y*t126;
    const lane L_rx_rz =
        B_1_x*t86 + B_1_z*t113 + B_2_x*t87 + B_2_z*t115 + B_3_x*t88 + B_3_z*t117 + B_4_x*t89 + B_4_z*t119
        + B_5_x*t90 + B_5_z*t121 + B_6_x*t91 + B_6_z*t123 + c_z*t125 + g_10_z*t124 + g_11_z*t127 + g_4_z*t112
        + g_5_z*t114 + g_6_z*t116 + g_7_z*t118 + g_8_z*t120 + g_9_z*t122 + o_L_z*t126;
    const lane t128 = (B_1_x*B_1_x);
    const lane t129 = (B_2_x*B_2_x);
    const lane t130 = (B_3_x*B_3_x);
    const lane t131 = (B_4_x*B_4_x);
    const lane t132 = (B_5_x*B_5_x);
    const lane t133 = (B_6_x*B_6_x);
    const lane t134 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + g_11_x*o_L_x + mu_1*t128 + mu_2*t129 + mu_3*t130 + mu_4*t131 + mu_5*t132 + mu_6*t133;
    const lane L_ry_ry = -t104 - t134;
    const lane L_ry_rz =
        (1.0/2.0)*B_1_y*g_4_z + B_1_y*t86 + (1.0/2.0)*B_1_z*g_4_y + (1.0/2.0)*B_2_y*g_5_z + B_2_y*t87
        + (1.0/2.0)*B_2_z*g_5_y + (1.0/2.0)*B_3_y*g_6_z + B_3_y*t88 + (1.0/2.0)*B_3_z*g_6_y
        + (1.0/2.0)*B_4_y*g_7_z + B_4_y*t89 + (1.0/2.0)*B_4_z*g_7_y + (1.0/2.0)*B_5_y*g_8_z + B_5_y*t90
        + (1.0/2.0)*B_5_z*g_8_y + (1.0/2.0)*B_6_y*g_9_z + B_6_y*t91 + (1.0/2.0)*B_6_z*g_9_y
        + (1.0/2.0)*c_y*g_10_z + (1.0/2.0)*c_z*g_10_y + (1.0/2.0)*g_11_y*o_L_z + (1.0/2.0)*g_11_z*o_L_y;
    const lane L_rz_rz = -t111 - t134;
    const lane t135 = t30*t32;
    const lane t136 = g_x*t135;
    const lane f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + t136;
    const lane t137 = t34*t36;
    const lane t138 = g_x*t137;
    const lane f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + t138;
    const lane t139 = t38*t40;
    const lane t140 = g_x*t139;
    const lane f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + t140;
    const lane t141 = t42*t44;
    const lane t142 = g_x*t141;
    const lane f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + t142;
    const lane t143 = t46*t48;
    const lane t144 = g_x*t143;
    const lane f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + t144;
    const lane t145 = t50*t52;
    const lane t146 = g_x*t145;
    const lane f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + t146;
    const lane t147 = g_y*t135;
    const lane f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + t147;
    const lane t148 = g_y*t137;
    const lane f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + t148;
    const lane t149 = g_y*t139;
    const lane f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + t149;
    const lane t150 = g_y*t141;
    const lane f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + t150;
    const lane t151 = g_y*t143;
    const lane f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + t151;
    const lane t152 = g_y*t145;
    const lane f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + t152;
    const lane t153 = g_z*t135;
    const lane f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + t153;
    const lane t154 = g_z*t137;
    const lane f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + t154;
    const lane t155 = g_z*t139;
    const lane f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + t155;
    const lane t156 = g_z*t141;
    const lane f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + t156;
    const lane t157 = g_z*t143;
    const lane f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + t157;
    const lane t158 = g_z*t145;
    const lane f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + t158;
    const lane t159 = t135*(-B_1_y*g_z + B_1_z*g_y);
    const lane f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx - t159;
    const lane t160 = t137*(-B_2_y*g_z + B_2_z*g_y);
    const lane f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx - t160;
    const lane t161 = t139*(-B_3_y*g_z + B_3_z*g_y);
    const lane f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx - t161;
    const lane t162 = t141*(-B_4_y*g_z + B_4_z*g_y);
    const lane f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx - t162;
    const lane t163 = t143*(-B_5_y*g_z + B_5_z*g_y);
    const lane f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx - t163;
    const lane t164 = t145*(-B_6_y*g_z + B_6_z*g_y);
    const lane f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx - t164;
    const lane t165 = t135*(B_1_x*g_z - B_1_z*g_x);
    const lane f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry - t165;
    const lane t166 = t137*(B_2_x*g_z - B_2_z*g_x);
    const lane f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry - t166;
    const lane t167 = t139*(B_3_x*g_z - B_3_z*g_x);
    const lane f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry - t167;
    const lane t168 = t141*(B_4_x*g_z - B_4_z*g_x);
    const lane f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry - t168;
    const lane t169 = t143*(B_5_x*g_z - B_5_z*g_x);
    const lane f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry - t169;
    const lane t170 = t145*(B_6_x*g_z - B_6_z*g_x);
    const lane f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry - t170;
    const lane t171 = t135*(-B_1_x*g_y + B_1_y*g_x);
    const lane f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz - t171;
    const lane t172 = t137*(-B_2_x*g_y + B_2_y*g_x);
    const lane f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz - t172;
    const lane t173 = t139*(-B_3_x*g_y + B_3_y*g_x);
    const lane f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz - t173;
    const lane t174 = t141*(-B_4_x*g_y + B_4_y*g_x);
    const lane f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz - t174;
    const lane t175 = t143*(-B_5_x*g_y + B_5_y*g_x);
    const lane f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz - t175;
    const lane t176 = t145*(-B_6_x*g_y + B_6_y*g_x);
    const lane f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz - t176;
    const lane M_p_x_x = m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6 + t67;
    const lane t177 = B_1_z*m_perp_1;
    const lane t178 = B_2_z*m_perp_2;
    const lane t179 = B_3_z*m_perp_3;
    const lane t180 = B_4_z*m_perp_4;
    const lane t181 = B_5_z*m_perp_5;
    const lane t182 = B_6_z*m_perp_6;
    const lane t183 = c_z*m_p;
    const lane t184 = m_L*o_L_z;
    const lane M_p_x_ry = t177 + t178 + t179 + t180 + t181 + t182 + t183 + t184;
    const lane t185 = B_1_y*m_perp_1;
    const lane t186 = B_2_y*m_perp_2;
    const lane t187 = B_3_y*m_perp_3;
    const lane t188 = B_4_y*m_perp_4;
    const lane t189 = B_5_y*m_perp_5;
    const lane t190 = B_6_y*m_perp_6;
    const lane t191 = c_y*m_p;
    const lane t192 = m_L*o_L_y;
    const lane M_p_z_rx = t185 + t186 + t187 + t188 + t189 + t190 + t191 + t192;
    const lane M_p_x_rz = -M_p_z_rx;
    const lane M_p_y_rx = -M_p_x_ry;
    const lane t193 = B_1_x*m_perp_1;
    const lane t194 = B_2_x*m_perp_2;
    const lane t195 = B_3_x*m_perp_3;
    const lane t196 = B_4_x*m_perp_4;
    const lane t197 = B_5_x*m_perp_5;
    const lane t198 = B_6_x*m_perp_6;
    const lane M_p_y_rz = c_x*m_p + m_L*o_L_x + t193 + t194 + t195 + t196 + t197 + t198;
    const lane M_p_z_ry = -M_p_y_rz;
    const lane t199 = 2.0*(o_L_y*o_L_y);
    const lane t200 = 2.0*(o_L_z*o_L_z);
    const double t201 = (1.0/2.0)*m_L;
    const lane t202 = 2.0*(c_y*c_y);
    const lane t203 = 2.0*(c_z*c_z);
    const double t204 = (1.0/2.0)*m_p;
    const lane t205 = 2.0*t105;
    const lane t206 = 2.0*t98;
    const lane t207 = (1.0/2.0)*m_perp_1;
    const lane t208 = 2.0*t106;
    const lane t209 = 2.0*t99;
    const lane t210 = (1.0/2.0)*m_perp_2;
    const lane t211 = 2.0*t107;
    const lane t212 = 2.0*t100;
    const lane t213 = (1.0/2.0)*m_perp_3;
    const lane t214 = 2.0*t108;
    const lane t215 = 2.0*t101;
    const lane t216 = (1.0/2.0)*m_perp_4;
    const lane t217 = 2.0*t109;
    const lane t218 = 2.0*t102;
    const lane t219 = (1.0/2.0)*m_perp_5;
    const lane t220 = 2.0*t110;
    const lane t221 = 2.0*t103;
    const lane t222 = (1.0/2.0)*m_perp_6;
    const lane M_p_rx_rx =
        J_x_x + t201*(t199 + t200) + t204*(t202 + t203) + t207*(t205 + t206) + t210*(t208 + t209)
        + t213*(t211 + t212) + t216*(t214 + t215) + t219*(t217 + t218) + t222*(t220 + t221);
    const lane M_p_rx_ry =
        -B_1_x*t185 - B_2_x*t186 - B_3_x*t187 - B_4_x*t188 - B_5_x*t189 - B_6_x*t190 + J_x_y - c_x*t191
        - o_L_x*t192;
    const lane M_p_rx_rz =
        -B_1_x*t177 - B_2_x*t178 - B_3_x*t179 - B_4_x*t180 - B_5_x*t181 - B_6_x*t182 + J_x_z - c_x*t183
        - o_L_x*t184;
    const lane t223 = 2.0*(o_L_x*o_L_x);
    const lane t224 = 2.0*(c_x*c_x);
    const lane t225 = 2.0*t128;
    const lane t226 = 2.0*t129;
    const lane t227 = 2.0*t130;
    const lane t228 = 2.0*t131;
    const lane t229 = 2.0*t132;
    const lane t230 = 2.0*t133;
    const lane M_p_ry_ry =
        J_y_y + t201*(t200 + t223) + t204*(t203 + t224) + t207*(t206 + t225) + t210*(t209 + t226)
        + t213*(t212 + t227) + t216*(t215 + t228) + t219*(t218 + t229) + t222*(t221 + t230);
    const lane M_p_ry_rz =
        -B_1_y*t177 - B_2_y*t178 - B_3_y*t179 - B_4_y*t180 - B_5_y*t181 - B_6_y*t182 + J_y_z - c_y*t183
        - o_L_y*t184;
    const lane M_p_rz_rz =
        J_z_z + t201*(t199 + t223) + t204*(t202 + t224) + t207*(t205 + t225) + t210*(t208 + t226)
        + t213*(t211 + t227) + t216*(t214 + t228) + t219*(t217 + t229) + t222*(t220 + t230);
    const lane h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const lane h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const lane h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const lane h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const lane h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const lane h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const lane t231 =
        m_lift_1 + m_lift_2 + m_lift_3 + m_lift_4 + m_lift_5 + m_lift_6 - m_perp_1 - m_perp_2 - m_perp_3
        - m_perp_4 - m_perp_5 - m_perp_6;
    const lane h_x_u_x = M_p_x_x + t231;
    const lane h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const lane h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const lane h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const lane h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const lane h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const lane h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const lane h_y_u_y = M_p_x_x + t231;
    const lane h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const lane h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const lane h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const lane h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const lane h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const lane h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
    const lane h_z_u_z = M_p_x_x + t231;
    const lane h_rx_l_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx;
    const lane h_rx_l_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx;
    const lane h_rx_l_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx;
    const lane h_rx_l_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx;
    const lane h_rx_l_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx;
    const lane h_rx_l_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx;
    const lane t232 =
        B_1_z*m_r_1 + B_1_z*t33 + B_2_z*m_r_2 + B_2_z*t37 + B_3_z*m_r_3 + B_3_z*t41 + B_4_z*m_r_4 + B_4_z*t45
        + B_5_z*m_r_5 + B_5_z*t49 + B_6_z*m_r_6 + B_6_z*t53 - t177 - t178 - t179 - t180 - t181 - t182;
    const lane h_rx_u_y = M_p_y_rx - t232;
    const lane t233 =
        B_1_y*m_r_1 + B_1_y*t33 + B_2_y*m_r_2 + B_2_y*t37 + B_3_y*m_r_3 + B_3_y*t41 + B_4_y*m_r_4 + B_4_y*t45
        + B_5_y*m_r_5 + B_5_y*t49 + B_6_y*m_r_6 + B_6_y*t53 - t185 - t186 - t187 - t188 - t189 - t190;
    const lane h_rx_u_z = M_p_z_rx + t233;
    const lane h_ry_l_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry;
    const lane h_ry_l_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry;
    const lane h_ry_l_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry;
    const lane h_ry_l_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry;
    const lane h_ry_l_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry;
    const lane h_ry_l_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry;
    const lane h_ry_u_x = M_p_x_ry + t232;
    const lane t234 =
        B_1_x*m_r_1 + B_1_x*t33 + B_2_x*m_r_2 + B_2_x*t37 + B_3_x*m_r_3 + B_3_x*t41 + B_4_x*m_r_4 + B_4_x*t45
        + B_5_x*m_r_5 + B_5_x*t49 + B_6_x*m_r_6 + B_6_x*t53 - t193 - t194 - t195 - t196 - t197 - t198;
    const lane h_ry_u_z = M_p_z_ry - t234;
    const lane h_rz_l_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz;
    const lane h_rz_l_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz;
    const lane h_rz_l_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz;
    const lane h_rz_l_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz;
    const lane h_rz_l_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz;
    const lane h_rz_l_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz;
    const lane h_rz_u_x = M_p_x_rz - t233;
    const lane h_rz_u_y = M_p_y_rz + t234;
    const lane t235 = m_F + m_b_1 + m_b_2 + m_b_3 + m_b_4 + m_b_5 + m_b_6 - t33 - t37 - t41 - t45 - t49 - t53;
    const lane t236 = D_p_x_1*k_C;
    const lane t237 = D_p_y_1*k_C;
    const lane t238 = D_p_z_1*k_C;
    const lane t239 = D_p_x_2*k_C;
    const lane t240 = D_p_y_2*k_C;
    const lane t241 = D_p_z_2*k_C;
    const lane t242 = D_p_x_3*k_C;
    const lane t243 = D_p_y_3*k_C;
    const lane t244 = D_p_z_3*k_C;
    const lane t245 = D_p_x_4*k_C;
    const lane t246 = D_p_y_4*k_C;
    const lane t247 = D_p_z_4*k_C;
    const lane t248 = D_p_x_5*k_C;
    const lane t249 = D_p_y_5*k_C;
    const lane t250 = D_p_z_5*k_C;
    lanes_clear(M, 225);
    M[0] =
        LANES(D_p_rx_1*h_rx_l_1 + D_p_ry_1*h_ry_l_1 + D_p_rz_1*h_rz_l_1 + D_p_x_1*h_x_l_1 + D_p_y_1*h_y_l_1
        + D_p_z_1*h_z_l_1 - m_perp_1 + m_r_1);
    M[1] = M[15] =
        LANES(D_p_rx_1*h_rx_l_2 + D_p_ry_1*h_ry_l_2 + D_p_rz_1*h_rz_l_2 + D_p_x_1*h_x_l_2 + D_p_y_1*h_y_l_2
        + D_p_z_1*h_z_l_2);
    M[2] = M[30] =
        LANES(D_p_rx_1*h_rx_l_3 + D_p_ry_1*h_ry_l_3 + D_p_rz_1*h_rz_l_3 + D_p_x_1*h_x_l_3 + D_p_y_1*h_y_l_3
        + D_p_z_1*h_z_l_3);
    M[3] = M[45] =
        LANES(D_p_rx_1*h_rx_l_4 + D_p_ry_1*h_ry_l_4 + D_p_rz_1*h_rz_l_4 + D_p_x_1*h_x_l_4 + D_p_y_1*h_y_l_4
        + D_p_z_1*h_z_l_4);
    M[4] = M[60] =
        LANES(D_p_rx_1*h_rx_l_5 + D_p_ry_1*h_ry_l_5 + D_p_rz_1*h_rz_l_5 + D_p_x_1*h_x_l_5 + D_p_y_1*h_y_l_5
        + D_p_z_1*h_z_l_5);
    M[5] = M[75] =
        LANES(D_p_rx_1*h_rx_l_6 + D_p_ry_1*h_ry_l_6 + D_p_rz_1*h_rz_l_6 + D_p_x_1*h_x_l_6 + D_p_y_1*h_y_l_6
        + D_p_z_1*h_z_l_6);
    M[12] = M[180] = LANES(D_p_ry_1*h_ry_u_x + D_p_rz_1*h_rz_u_x + D_p_x_1*h_x_u_x - d_1_x*t135);
    M[13] = M[195] = LANES(D_p_rx_1*h_rx_u_y + D_p_rz_1*h_rz_u_y + D_p_y_1*h_y_u_y - d_1_y*t135);
    M[14] = M[210] = LANES(D_p_rx_1*h_rx_u_z + D_p_ry_1*h_ry_u_z + D_p_z_1*h_z_u_z - d_1_z*t135);
    M[16] =
        LANES(D_p_rx_2*h_rx_l_2 + D_p_ry_2*h_ry_l_2 + D_p_rz_2*h_rz_l_2 + D_p_x_2*h_x_l_2 + D_p_y_2*h_y_l_2
        + D_p_z_2*h_z_l_2 - m_perp_2 + m_r_2);
    M[17] = M[31] =
        LANES(D_p_rx_2*h_rx_l_3 + D_p_ry_2*h_ry_l_3 + D_p_rz_2*h_rz_l_3 + D_p_x_2*h_x_l_3 + D_p_y_2*h_y_l_3
        + D_p_z_2*h_z_l_3);
    M[18] = M[46] =
        LANES(D_p_rx_2*h_rx_l_4 + D_p_ry_2*h_ry_l_4 + D_p_rz_2*h_rz_l_4 + D_p_x_2*h_x_l_4 + D_p_y_2*h_y_l_4
        + D_p_z_2*h_z_l_4);
    M[19] = M[61] =
        LANES(D_p_rx_2*h_rx_l_5 + D_p_ry_2*h_ry_l_5 + D_p_rz_2*h_rz_l_5 + D_p_x_2*h_x_l_5 + D_p_y_2*h_y_l_5
        + D_p_z_2*h_z_l_5);
    M[20] = M[76] =
        LANES(D_p_rx_2*h_rx_l_6 + D_p_ry_2*h_ry_l_6 + D_p_rz_2*h_rz_l_6 + D_p_x_2*h_x_l_6 + D_p_y_2*h_y_l_6
        + D_p_z_2*h_z_l_6);
    M[27] = M[181] = LANES(D_p_ry_2*h_ry_u_x + D_p_rz_2*h_rz_u_x + D_p_x_2*h_x_u_x - d_2_x*t137);
    M[28] = M[196] = LANES(D_p_rx_2*h_rx_u_y + D_p_rz_2*h_rz_u_y + D_p_y_2*h_y_u_y - d_2_y*t137);
    M[29] = M[211] = LANES(D_p_rx_2*h_rx_u_z + D_p_ry_2*h_ry_u_z + D_p_z_2*h_z_u_z - d_2_z*t137);
    M[32] =
        LANES(D_p_rx_3*h_rx_l_3 + D_p_ry_3*h_ry_l_3 + D_p_rz_3*h_rz_l_3 + D_p_x_3*h_x_l_3 + D_p_y_3*h_y_l_3
        + D_p_z_3*h_z_l_3 - m_perp_3 + m_r_3);
    M[33] = M[47] =
        LANES(D_p_rx_3*h_rx_l_4 + D_p_ry_3*h_ry_l_4 + D_p_rz_3*h_rz_l_4 + D_p_x_3*h_x_l_4 + D_p_y_3*h_y_l_4
        + D_p_z_3*h_z_l_4);
    M[34] = M[62] =
        LANES(D_p_rx_3*h_rx_l_5 + D_p_ry_3*h_ry_l_5 + D_p_rz_3*h_rz_l_5 + D_p_x_3*h_x_l_5 + D_p_y_3*h_y_l_5
        + D_p_z_3*h_z_l_5);
    M[35] = M[77] =
        LANES(D_p_rx_3*h_rx_l_6 + D_p_ry_3*h_ry_l_6 + D_p_rz_3*h_rz_l_6 + D_p_x_3*h_x_l_6 + D_p_y_3*h_y_l_6
        + D_p_z_3*h_z_l_6);
    M[42] = M[182] = LANES(D_p_ry_3*h_ry_u_x + D_p_rz_3*h_rz_u_x + D_p_x_3*h_x_u_x - d_3_x*t139);
    M[43] = M[197] = LANES(D_p_rx_3*h_rx_u_y + D_p_rz_3*h_rz_u_y + D_p_y_3*h_y_u_y - d_3_y*t139);
    M[44] = M[212] = LANES(D_p_rx_3*h_rx_u_z + D_p_ry_3*h_ry_u_z + D_p_z_3*h_z_u_z - d_3_z*t139);
    M[48] =
        LANES(D_p_rx_4*h_rx_l_4 + D_p_ry_4*h_ry_l_4 + D_p_rz_4*h_rz_l_4 + D_p_x_4*h_x_l_4 + D_p_y_4*h_y_l_4
        + D_p_z_4*h_z_l_4 - m_perp_4 + m_r_4);
    M[49] = M[63] =
        LANES(D_p_rx_4*h_rx_l_5 + D_p_ry_4*h_ry_l_5 + D_p_rz_4*h_rz_l_5 + D_p_x_4*h_x_l_5 + D_p_y_4*h_y_l_5
        + D_p_z_4*h_z_l_5);
    M[50] = M[78] =
        LANES(D_p_rx_4*h_rx_l_6 + D_p_ry_4*h_ry_l_6 + D_p_rz_4*h_rz_l_6 + D_p_x_4*h_x_l_6 + D_p_y_4*h_y_l_6
        + D_p_z_4*h_z_l_6);
    M[57] = M[183] = LANES(D_p_ry_4*h_ry_u_x + D_p_rz_4*h_rz_u_x + D_p_x_4*h_x_u_x - d_4_x*t141);
    M[58] = M[198] = LANES(D_p_rx_4*h_rx_u_y + D_p_rz_4*h_rz_u_y + D_p_y_4*h_y_u_y - d_4_y*t141);
    M[59] = M[213] = LANES(D_p_rx_4*h_rx_u_z + D_p_ry_4*h_ry_u_z + D_p_z_4*h_z_u_z - d_4_z*t141);
    M[64] =
        LANES(D_p_rx_5*h_rx_l_5 + D_p_ry_5*h_ry_l_5 + D_p_rz_5*h_rz_l_5 + D_p_x_5*h_x_l_5 + D_p_y_5*h_y_l_5
        + D_p_z_5*h_z_l_5 - m_perp_5 + m_r_5);
    M[65] = M[79] =
        LANES(D_p_rx_5*h_rx_l_6 + D_p_ry_5*h_ry_l_6 + D_p_rz_5*h_rz_l_6 + D_p_x_5*h_x_l_6 + D_p_y_5*h_y_l_6
        + D_p_z_5*h_z_l_6);
    M[72] = M[184] = LANES(D_p_ry_5*h_ry_u_x + D_p_rz_5*h_rz_u_x + D_p_x_5*h_x_u_x - d_5_x*t143);
    M[73] = M[199] = LANES(D_p_rx_5*h_rx_u_y + D_p_rz_5*h_rz_u_y + D_p_y_5*h_y_u_y - d_5_y*t143);
    M[74] = M[214] = LANES(D_p_rx_5*h_rx_u_z + D_p_ry_5*h_ry_u_z + D_p_z_5*h_z_u_z - d_5_z*t143);
    M[80] =
        LANES(D_p_rx_6*h_rx_l_6 + D_p_ry_6*h_ry_l_6 + D_p_rz_6*h_rz_l_6 + D_p_x_6*h_x_l_6 + D_p_y_6*h_y_l_6
        + D_p_z_6*h_z_l_6 - m_perp_6 + m_r_6);
    M[87] = M[185] = LANES(D_p_ry_6*h_ry_u_x + D_p_rz_6*h_rz_u_x + D_p_x_6*h_x_u_x - d_6_x*t145);
    M[88] = M[200] = LANES(D_p_rx_6*h_rx_u_y + D_p_rz_6*h_rz_u_y + D_p_y_6*h_y_u_y - d_6_y*t145);
    M[89] = M[215] = LANES(D_p_rx_6*h_rx_u_z + D_p_ry_6*h_ry_u_z + D_p_z_6*h_z_u_z - d_6_z*t145);
    M[96] = LANES(I_G + I_m_1/(h_m_1*h_m_1));
    M[112] = LANES(I_G + I_m_2/(h_m_2*h_m_2));
    M[128] = LANES(I_G + I_m_3/(h_m_3*h_m_3));
    M[144] = LANES(I_G + I_m_4/(h_m_4*h_m_4));
    M[160] = LANES(I_G + I_m_5/(h_m_5*h_m_5));
    M[176] = LANES(I_G + I_m_6/(h_m_6*h_m_6));
    M[192] = LANES(h_x_u_x + t235);
    M[208] = LANES(h_y_u_y + t235);
    M[224] = LANES(h_z_u_z + t235);
    lanes_clear(K, 225);
    K[0] =
        LANES(D_p_rx_1*f_rx_l_1 - D_p_rx_1*t159 + D_p_ry_1*f_ry_l_1 - D_p_ry_1*t165 + D_p_rz_1*f_rz_l_1
        - D_p_rz_1*t171 + (D_p_x_1*D_p_x_1)*k_C + D_p_x_1*f_x_l_1 + D_p_x_1*t136 + (D_p_y_1*D_p_y_1)*k_C
        + D_p_y_1*f_y_l_1 + D_p_y_1*t147 + (D_p_z_1*D_p_z_1)*k_C + D_p_z_1*f_z_l_1 + D_p_z_1*t153 + k_1
        + mu_1 + 2.0*t32*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1*l_1));
    K[1] = K[15] =
        LANES(D_p_rx_1*f_rx_l_2 - D_p_rx_2*t159 + D_p_ry_1*f_ry_l_2 - D_p_ry_2*t165 + D_p_rz_1*f_rz_l_2
        - D_p_rz_2*t171 + D_p_x_1*f_x_l_2 + D_p_x_2*t136 + D_p_x_2*t236 + D_p_y_1*f_y_l_2 + D_p_y_2*t147
        + D_p_y_2*t237 + D_p_z_1*f_z_l_2 + D_p_z_2*t153 + D_p_z_2*t238);
    K[2] = K[30] =
        LANES(D_p_rx_1*f_rx_l_3 - D_p_rx_3*t159 + D_p_ry_1*f_ry_l_3 - D_p_ry_3*t165 + D_p_rz_1*f_rz_l_3
        - D_p_rz_3*t171 + D_p_x_1*f_x_l_3 + D_p_x_3*t136 + D_p_x_3*t236 + D_p_y_1*f_y_l_3 + D_p_y_3*t147
        + D_p_y_3*t237 + D_p_z_1*f_z_l_3 + D_p_z_3*t153 + D_p_z_3*t238);
    K[3] = K[45] =
        LANES(D_p_rx_1*f_rx_l_4 - D_p_rx_4*t159 + D_p_ry_1*f_ry_l_4 - D_p_ry_4*t165 + D_p_rz_1*f_rz_l_4
        - D_p_rz_4*t171 + D_p_x_1*f_x_l_4 + D_p_x_4*t136 + D_p_x_4*t236 + D_p_y_1*f_y_l_4 + D_p_y_4*t147
        + D_p_y_4*t237 + D_p_z_1*f_z_l_4 + D_p_z_4*t153 + D_p_z_4*t238);
    K[4] = K[60] =
        LANES(D_p_rx_1*f_rx_l_5 - D_p_rx_5*t159 + D_p_ry_1*f_ry_l_5 - D_p_ry_5*t165 + D_p_rz_1*f_rz_l_5
        - D_p_rz_5*t171 + D_p_x_1*f_x_l_5 + D_p_x_5*t136 + D_p_x_5*t236 + D_p_y_1*f_y_l_5 + D_p_y_5*t147
        + D_p_y_5*t237 + D_p_z_1*f_z_l_5 + D_p_z_5*t153 + D_p_z_5*t238);
    K[5] = K[75] =
        LANES(D_p_rx_1*f_rx_l_6 - D_p_rx_6*t159 + D_p_ry_1*f_ry_l_6 - D_p_ry_6*t165 + D_p_rz_1*f_rz_l_6
        - D_p_rz_6*t171 + D_p_x_1*f_x_l_6 + D_p_x_6*t136 + D_p_x_6*t236 + D_p_y_1*f_y_l_6 + D_p_y_6*t147
        + D_p_y_6*t237 + D_p_z_1*f_z_l_6 + D_p_z_6*t153 + D_p_z_6*t238);
    K[6] = K[90] = LANES(-k_1);
    K[12] = K[180] = LANES(t236);
    K[13] = K[195] = LANES(t237);
    K[14] = K[210] = LANES(t238);
    K[16] =
        LANES(D_p_rx_2*f_rx_l_2 - D_p_rx_2*t160 + D_p_ry_2*f_ry_l_2 - D_p_ry_2*t166 + D_p_rz_2*f_rz_l_2
        - D_p_rz_2*t172 + (D_p_x_2*D_p_x_2)*k_C + D_p_x_2*f_x_l_2 + D_p_x_2*t138 + (D_p_y_2*D_p_y_2)*k_C
        + D_p_y_2*f_y_l_2 + D_p_y_2*t148 + (D_p_z_2*D_p_z_2)*k_C + D_p_z_2*f_z_l_2 + D_p_z_2*t154 + k_2
        + mu_2 + 2.0*t36*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2*l_2));
    K[17] = K[31] =
        LANES(D_p_rx_2*f_rx_l_3 - D_p_rx_3*t160 + D_p_ry_2*f_ry_l_3 - D_p_ry_3*t166 + D_p_rz_2*f_rz_l_3
        - D_p_rz_3*t172 + D_p_x_2*f_x_l_3 + D_p_x_3*t138 + D_p_x_3*t239 + D_p_y_2*f_y_l_3 + D_p_y_3*t148
        + D_p_y_3*t240 + D_p_z_2*f_z_l_3 + D_p_z_3*t154 + D_p_z_3*t241);
    K[18] = K[46] =
        LANES(D_p_rx_2*f_rx_l_4 - D_p_rx_4*t160 + D_p_ry_2*f_ry_l_4 - D_p_ry_4*t166 + D_p_rz_2*f_rz_l_4
        - D_p_rz_4*t172 + D_p_x_2*f_x_l_4 + D_p_x_4*t138 + D_p_x_4*t239 + D_p_y_2*f_y_l_4 + D_p_y_4*t148
        + D_p_y_4*t240 + D_p_z_2*f_z_l_4 + D_p_z_4*t154 + D_p_z_4*t241);
    K[19] = K[61] =
        LANES(D_p_rx_2*f_rx_l_5 - D_p_rx_5*t160 + D_p_ry_2*f_ry_l_5 - D_p_ry_5*t166 + D_p_rz_2*f_rz_l_5
        - D_p_rz_5*t172 + D_p_x_2*f_x_l_5 + D_p_x_5*t138 + D_p_x_5*t239 + D_p_y_2*f_y_l_5 + D_p_y_5*t148
        + D_p_y_5*t240 + D_p_z_2*f_z_l_5 + D_p_z_5*t154 + D_p_z_5*t241);
    K[20] = K[76] =
        LANES(D_p_rx_2*f_rx_l_6 - D_p_rx_6*t160 + D_p_ry_2*f_ry_l_6 - D_p_ry_6*t166 + D_p_rz_2*f_rz_l_6
        - D_p_rz_6*t172 + D_p_x_2*f_x_l_6 + D_p_x_6*t138 + D_p_x_6*t239 + D_p_y_2*f_y_l_6 + D_p_y_6*t148
        + D_p_y_6*t240 + D_p_z_2*f_z_l_6 + D_p_z_6*t154 + D_p_z_6*t241);
    K[22] = K[106] = LANES(-k_2);
    K[27] = K[181] = LANES(t239);
    K[28] = K[196] = LANES(t240);
    K[29] = K[211] = LANES(t241);
    K[32] =
        LANES(D_p_rx_3*f_rx_l_3 - D_p_rx_3*t161 + D_p_ry_3*f_ry_l_3 - D_p_ry_3*t167 + D_p_rz_3*f_rz_l_3
        - D_p_rz_3*t173 + (D_p_x_3*D_p_x_3)*k_C + D_p_x_3*f_x_l_3 + D_p_x_3*t140 + (D_p_y_3*D_p_y_3)*k_C
        + D_p_y_3*f_y_l_3 + D_p_y_3*t149 + (D_p_z_3*D_p_z_3)*k_C + D_p_z_3*f_z_l_3 + D_p_z_3*t155 + k_3
        + mu_3 + 2.0*t40*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3*l_3));
    K[33] = K[47] =
        LANES(D_p_rx_3*f_rx_l_4 - D_p_rx_4*t161 + D_p_ry_3*f_ry_l_4 - D_p_ry_4*t167 + D_p_rz_3*f_rz_l_4
        - D_p_rz_4*t173 + D_p_x_3*f_x_l_4 + D_p_x_4*t140 + D_p_x_4*t242 + D_p_y_3*f_y_l_4 + D_p_y_4*t149
        + D_p_y_4*t243 + D_p_z_3*f_z_l_4 + D_p_z_4*t155 + D_p_z_4*t244);
    K[34] = K[62] =
        LANES(D_p_rx_3*f_rx_l_5 - D_p_rx_5*t161 + D_p_ry_3*f_ry_l_5 - D_p_ry_5*t167 + D_p_rz_3*f_rz_l_5
        - D_p_rz_5*t173 + D_p_x_3*f_x_l_5 + D_p_x_5*t140 + D_p_x_5*t242 + D_p_y_3*f_y_l_5 + D_p_y_5*t149
        + D_p_y_5*t243 + D_p_z_3*f_z_l_5 + D_p_z_5*t155 + D_p_z_5*t244);
    K[35] = K[77] =
        LANES(D_p_rx_3*f_rx_l_6 - D_p_rx_6*t161 + D_p_ry_3*f_ry_l_6 - D_p_ry_6*t167 + D_p_rz_3*f_rz_l_6
        - D_p_rz_6*t173 + D_p_x_3*f_x_l_6 + D_p_x_6*t140 + D_p_x_6*t242 + D_p_y_3*f_y_l_6 + D_p_y_6*t149
        + D_p_y_6*t243 + D_p_z_3*f_z_l_6 + D_p_z_6*t155 + D_p_z_6*t244);
    K[38] = K[122] = LANES(-k_3);
    K[42] = K[182] = LANES(t242);
    K[43] = K[197] = LANES(t243);
    K[44] = K[212] = LANES(t244);
    K[48] =
        LANES(D_p_rx_4*f_rx_l_4 - D_p_rx_4*t162 + D_p_ry_4*f_ry_l_4 - D_p_ry_4*t168 + D_p_rz_4*f_rz_l_4
        - D_p_rz_4*t174 + (D_p_x_4*D_p_x_4)*k_C + D_p_x_4*f_x_l_4 + D_p_x_4*t142 + (D_p_y_4*D_p_y_4)*k_C
        + D_p_y_4*f_y_l_4 + D_p_y_4*t150 + (D_p_z_4*D_p_z_4)*k_C + D_p_z_4*f_z_l_4 + D_p_z_4*t156 + k_4
        + mu_4 + 2.0*t44*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4*l_4));
    K[49] = K[63] =
        LANES(D_p_rx_4*f_rx_l_5 - D_p_rx_5*t162 + D_p_ry_4*f_ry_l_5 - D_p_ry_5*t168 + D_p_rz_4*f_rz_l_5
        - D_p_rz_5*t174 + D_p_x_4*f_x_l_5 + D_p_x_5*t142 + D_p_x_5*t245 + D_p_y_4*f_y_l_5 + D_p_y_5*t150
        + D_p_y_5*t246 + D_p_z_4*f_z_l_5 + D_p_z_5*t156 + D_p_z_5*t247);
    K[50] = K[78] =
        LANES(D_p_rx_4*f_rx_l_6 - D_p_rx_6*t162 + D_p_ry_4*f_ry_l_6 - D_p_ry_6*t168 + D_p_rz_4*f_rz_l_6
        - D_p_rz_6*t174 + D_p_x_4*f_x_l_6 + D_p_x_6*t142 + D_p_x_6*t245 + D_p_y_4*f_y_l_6 + D_p_y_6*t150
        + D_p_y_6*t246 + D_p_z_4*f_z_l_6 + D_p_z_6*t156 + D_p_z_6*t247);
    K[54] = K[138] = LANES(-k_4);
    K[57] = K[183] = LANES(t245);
    K[58] = K[198] = LANES(t246);
    K[59] = K[213] = LANES(t247);
    K[64] =
        LANES(D_p_rx_5*f_rx_l_5 - D_p_rx_5*t163 + D_p_ry_5*f_ry_l_5 - D_p_ry_5*t169 + D_p_rz_5*f_rz_l_5
        - D_p_rz_5*t175 + (D_p_x_5*D_p_x_5)*k_C + D_p_x_5*f_x_l_5 + D_p_x_5*t144 + (D_p_y_5*D_p_y_5)*k_C
        + D_p_y_5*f_y_l_5 + D_p_y_5*t151 + (D_p_z_5*D_p_z_5)*k_C + D_p_z_5*f_z_l_5 + D_p_z_5*t157 + k_5
        + mu_5 + 2.0*t48*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5*l_5));
    K[65] = K[79] =
        LANES(D_p_rx_5*f_rx_l_6 - D_p_rx_6*t163 + D_p_ry_5*f_ry_l_6 - D_p_ry_6*t169 + D_p_rz_5*f_rz_l_6
        - D_p_rz_6*t175 + D_p_x_5*f_x_l_6 + D_p_x_6*t144 + D_p_x_6*t248 + D_p_y_5*f_y_l_6 + D_p_y_6*t151
        + D_p_y_6*t249 + D_p_z_5*f_z_l_6 + D_p_z_6*t157 + D_p_z_6*t250);
    K[70] = K[154] = LANES(-k_5);
    K[72] = K[184] = LANES(t248);
    K[73] = K[199] = LANES(t249);
    K[74] = K[214] = LANES(t250);
    K[80] =
        LANES(D_p_rx_6*f_rx_l_6 - D_p_rx_6*t164 + D_p_ry_6*f_ry_l_6 - D_p_ry_6*t170 + D_p_rz_6*f_rz_l_6
        - D_p_rz_6*t176 + (D_p_x_6*D_p_x_6)*k_C + D_p_x_6*f_x_l_6 + D_p_x_6*t146 + (D_p_y_6*D_p_y_6)*k_C
        + D_p_y_6*f_y_l_6 + D_p_y_6*t152 + (D_p_z_6*D_p_z_6)*k_C + D_p_z_6*f_z_l_6 + D_p_z_6*t158 + k_6
        + mu_6 + 2.0*t52*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6*l_6));
    K[86] = K[170] = LANES(-k_6);
    K[87] = K[185] = LANES(D_p_x_6*k_C);
    K[88] = K[200] = LANES(D_p_y_6*k_C);
    K[89] = K[215] = LANES(D_p_z_6*k_C);
    K[96] = LANES(k_1 + k_S);
    K[112] = LANES(k_2 + k_S);
    K[128] = LANES(k_3 + k_S);
    K[144] = LANES(k_4 + k_S);
    K[160] = LANES(k_5 + k_S);
    K[176] = LANES(k_6 + k_S);
    K[192] = LANES(k_C);
    K[208] = LANES(k_C);
    K[224] = LANES(k_C);
    lanes_clear(J_p, 90);
    J_p[0] = LANES(D_p_x_1);
    J_p[1] = LANES(D_p_x_2);
    J_p[2] = LANES(D_p_x_3);
    J_p[3] = LANES(D_p_x_4);
    J_p[4] = LANES(D_p_x_5);
    J_p[5] = LANES(D_p_x_6);
    J_p[12] = LANES(1.0);
    J_p[15] = LANES(D_p_y_1);
    J_p[16] = LANES(D_p_y_2);
    J_p[17] = LANES(D_p_y_3);
    J_p[18] = LANES(D_p_y_4);
    J_p[19] = LANES(D_p_y_5);
    J_p[20] = LANES(D_p_y_6);
    J_p[28] = LANES(1.0);
    J_p[30] = LANES(D_p_z_1);
    J_p[31] = LANES(D_p_z_2);
    J_p[32] = LANES(D_p_z_3);
    J_p[33] = LANES(D_p_z_4);
    J_p[34] = LANES(D_p_z_5);
    J_p[35] = LANES(D_p_z_6);
    J_p[44] = LANES(1.0);
    J_p[45] = LANES(D_p_rx_1);
    J_p[46] = LANES(D_p_rx_2);
    J_p[47] = LANES(D_p_rx_3);
    J_p[48] = LANES(D_p_rx_4);
    J_p[49] = LANES(D_p_rx_5);
    J_p[50] = LANES(D_p_rx_6);
    J_p[60] = LANES(D_p_ry_1);
    J_p[61] = LANES(D_p_ry_2);
    J_p[62] = LANES(D_p_ry_3);
    J_p[63] = LANES(D_p_ry_4);
    J_p[64] = LANES(D_p_ry_5);
    J_p[65] = LANES(D_p_ry_6);
    J_p[75] = LANES(D_p_rz_1);
    J_p[76] = LANES(D_p_rz_2);
    J_p[77] = LANES(D_p_rz_3);
    J_p[78] = LANES(D_p_rz_4);
    J_p[79] = LANES(D_p_rz_5);
    J_p[80] = LANES(D_p_rz_6);
}

/* Platform Jacobian, static equilibrium and elastic stiffness without effects.
 *
 * Source: platform_jacobian, static_equilibrium, elastic_hessian.
 * 1804 operations; 54253086 with every named value expanded.
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
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double m_p = parameters[0];
    const double c_p_x = parameters[1];
    const double c_p_y = parameters[2];
    const double c_p_z = parameters[3];
    const double g_x = parameters[10];
    const double g_y = parameters[11];
    const double g_z = parameters[12];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double k_l_1 = parameters[61];
    const double k_l_2 = parameters[62];
    const double k_l_3 = parameters[63];
    const double k_l_4 = parameters[64];
    const double k_l_5 = parameters[65];
    const double k_l_6 = parameters[66];
    const double m_b_1 = parameters[67];
    const double m_b_2 = parameters[68];
    const double m_b_3 = parameters[69];
    const double m_b_4 = parameters[70];
    const double m_b_5 = parameters[71];
    const double m_b_6 = parameters[72];
    const double c_b_1 = parameters[73];
    const double c_b_2 = parameters[74];
    const double c_b_3 = parameters[75];
    const double c_b_4 = parameters[76];
    const double c_b_5 = parameters[77];
    const double c_b_6 = parameters[78];
    const double m_r_1 = parameters[85];
    const double m_r_2 = parameters[86];
    const double m_r_3 = parameters[87];
    const double m_r_4 = parameters[88];
    const double m_r_5 = parameters[89];
    const double m_r_6 = parameters[90];
    const double c_r_1 = parameters[91];
    const double c_r_2 = parameters[92];
    const double c_r_3 = parameters[93];
    const double c_r_4 = parameters[94];
    const double c_r_5 = parameters[95];
    const double c_r_6 = parameters[96];
    const lane t1 = (rot_x*rot_x);
    const lane t2 = (rot_y*rot_y);
    const lane t3 = (rot_z*rot_z);
    const lane t4 = t2 + t3;
    const lane half_angle = (1.0/2.0)*lanes_sqrt(t1 + t4 + 1e-30);
    const lane s_half = lanes_sin(half_angle)/half_angle;
    const lane t5 = (s_half*s_half);
    const lane t6 = (1.0/2.0)*t5;
    const lane R_x_x = -t4*t6 + 1.0;
    const lane c_half = lanes_cos(half_angle);
    const lane t7 = c_half*s_half;
    const lane t8 = rot_z*t7;
    const lane R_x_y = (1.0/2.0)*rot_x*rot_y*t5 - t8;
    const lane t9 = rot_y*t7;
    const lane t10 = rot_x*t6;
    const lane R_x_z = rot_z*t10 + t9;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = rot_y*t10 + t8;
    const lane R_y_y = t6*(-t1 - t3) + 1.0;
    const lane t11 = rot_x*t7;
    const lane R_y_z = (1.0/2.0)*rot_y*rot_z*t5 - t11;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = (1.0/2.0)*rot_x*rot_z*t5 - t9;
    const lane R_z_y = rot_y*rot_z*t6 + t11;
    const lane R_z_z = t6*(-t1 - t2) + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane l_1 = lanes_sqrt((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const lane l_2 = lanes_sqrt((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const lane l_3 = lanes_sqrt((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const lane l_4 = lanes_sqrt((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const lane l_5 = lanes_sqrt((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const lane l_6 = lanes_sqrt((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const lane c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const lane c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const lane c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const double t12 = c_b_1*m_b_1 - c_r_1*m_r_1;
    const lane m_lift_1 = m_r_1 + t12/l_1;
    const double t13 = c_b_2*m_b_2 - c_r_2*m_r_2;
    const lane m_lift_2 = m_r_2 + t13/l_2;
    const double t14 = c_b_3*m_b_3 - c_r_3*m_r_3;
    const lane m_lift_3 = m_r_3 + t14/l_3;
    const double t15 = c_b_4*m_b_4 - c_r_4*m_r_4;
    const lane m_lift_4 = m_r_4 + t15/l_4;
    const double t16 = c_b_5*m_b_5 - c_r_5*m_r_5;
    const lane m_lift_5 = m_r_5 + t16/l_5;
    const double t17 = c_b_6*m_b_6 - c_r_6*m_r_6;
    const lane m_lift_6 = m_r_6 + t17/l_6;
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane t18 = 1.0/det_D_l;
    const lane t19 = l_1*t18;
    const lane D_p_x_1 = A_x_1*t19;
    const lane t20 = l_2*t18;
    const lane D_p_x_2 = A_x_2*t20;
    const lane t21 = l_3*t18;
    const lane D_p_x_3 = A_x_3*t21;
    const lane t22 = l_4*t18;
    const lane D_p_x_4 = A_x_4*t22;
    const lane t23 = l_5*t18;
    const lane D_p_x_5 = A_x_5*t23;
    const lane t24 = l_6*t18;
    const lane D_p_x_6 = A_x_6*t24;
    const lane D_p_y_1 = A_y_1*t19;
    const lane D_p_y_2 = A_y_2*t20;
    const lane D_p_y_3 = A_y_3*t21;
    const lane D_p_y_4 = A_y_4*t22;
    const lane D_p_y_5 = A_y_5*t23;
    const lane D_p_y_6 = A_y_6*t24;
    const lane D_p_z_1 = A_z_1*t19;
    const lane D_p_z_2 = A_z_2*t20;
    const lane D_p_z_3 = A_z_3*t21;
    const lane D_p_z_4 = A_z_4*t22;
    const lane D_p_z_5 = A_z_5*t23;
    const lane D_p_z_6 = A_z_6*t24;
    const lane D_p_rx_1 = A_rx_1*t19;
    const lane D_p_rx_2 = A_rx_2*t20;
    const lane D_p_rx_3 = A_rx_3*t21;
    const lane D_p_rx_4 = A_rx_4*t22;
    const lane D_p_rx_5 = A_rx_5*t23;
    const lane D_p_rx_6 = A_rx_6*t24;
    const lane D_p_ry_1 = A_ry_1*t19;
    const lane D_p_ry_2 = A_ry_2*t20;
    const lane D_p_ry_3 = A_ry_3*t21;
    const lane D_p_ry_4 = A_ry_4*t22;
    const lane D_p_ry_5 = A_ry_5*t23;
    const lane D_p_ry_6 = A_ry_6*t24;
    const lane D_p_rz_1 = A_rz_1*t19;
    const lane D_p_rz_2 = A_rz_2*t20;
    const lane D_p_rz_3 = A_rz_3*t21;
    const lane D_p_rz_4 = A_rz_4*t22;
    const lane D_p_rz_5 = A_rz_5*t23;
    const lane D_p_rz_6 = A_rz_6*t24;
    const lane t25 = g_x*m_lift_1;
    const lane t26 = g_x*m_lift_2;
    const lane t27 = g_x*m_lift_3;
    const lane t28 = g_x*m_lift_4;
    const lane t29 = g_x*m_lift_5;
    const lane t30 = g_x*m_lift_6;
    const double t31 = g_x*m_p;
    const lane G_p_x = -t25 - t26 - t27 - t28 - t29 - t30 - t31;
    const lane t32 = g_y*m_lift_1;
    const lane t33 = g_y*m_lift_2;
    const lane t34 = g_y*m_lift_3;
    const lane t35 = g_y*m_lift_4;
    const lane t36 = g_y*m_lift_5;
    const lane t37 = g_y*m_lift_6;
    const double t38 = g_y*m_p;
    const lane G_p_y = -t32 - t33 - t34 - t35 - t36 - t37 - t38;
    const lane t39 = g_z*m_lift_1;
    const lane t40 = g_z*m_lift_2;
    const lane t41 = g_z*m_lift_3;
    const lane t42 = g_z*m_lift_4;
    const lane t43 = g_z*m_lift_5;
    const lane t44 = g_z*m_lift_6;
    const double t45 = g_z*m_p;
    const lane G_p_z = -t39 - t40 - t41 - t42 - t43 - t44 - t45;
    const lane G_p_rx =
        -B_1_y*t39 + B_1_z*g_y*m_lift_1 - B_2_y*t40 + B_2_z*g_y*m_lift_2 - B_3_y*t41 + B_3_z*g_y*m_lift_3
        - B_4_y*t42 + B_4_z*g_y*m_lift_4 - B_5_y*t43 + B_5_z*g_y*m_lift_5 - B_6_y*t44 + B_6_z*g_y*m_lift_6
        - c_y*t45 + c_z*g_y*m_p;
    const lane G_p_ry =
        B_1_x*t39 - B_1_z*t25 + B_2_x*t40 - B_2_z*t26 + B_3_x*t41 - B_3_z*t27 + B_4_x*t42 - B_4_z*t28
        + B_5_x*t43 - B_5_z*t29 + B_6_x*t44 - B_6_z*t30 + c_x*t45 - c_z*t31;
    const lane G_p_rz =
        -B_1_x*t32 + B_1_y*g_x*m_lift_1 - B_2_x*t33 + B_2_y*g_x*m_lift_2 - B_3_x*t34 + B_3_y*g_x*m_lift_3
        - B_4_x*t35 + B_4_y*g_x*m_lift_4 - B_5_x*t36 + B_5_y*g_x*m_lift_5 - B_6_x*t37 + B_6_y*g_x*m_lift_6
        - c_x*t38 + c_y*g_x*m_p;
    const lane G_1 =
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - t12*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1);
    const lane G_2 =
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - t13*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2);
    const lane G_3 =
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - t14*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3);
    const lane G_4 =
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - t15*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4);
    const lane G_5 =
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - t16*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5);
    const lane G_6 =
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - t17*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6);
    const lane s_1_st = G_1/k_l_1;
    const lane s_2_st = G_2/k_l_2;
    const lane s_3_st = G_3/k_l_3;
    const lane s_4_st = G_4/k_l_4;
    const lane s_5_st = G_5/k_l_5;
    const lane s_6_st = G_6/k_l_6;
    const lane f_st_1 = k_l_1*s_1_st;
    const lane f_st_2 = k_l_2*s_2_st;
    const lane f_st_3 = k_l_3*s_3_st;
    const lane f_st_4 = k_l_4*s_4_st;
    const lane f_st_5 = k_l_5*s_5_st;
    const lane f_st_6 = k_l_6*s_6_st;
    D_p[0] = LANES(D_p_x_1);
    D_p[1] = LANES(D_p_x_2);
    D_p[2] = LANES(D_p_x_3);
    D_p[3] = LANES(D_p_x_4);
    D_p[4] = LANES(D_p_x_5);
    D_p[5] = LANES(D_p_x_6);
    D_p[6] = LANES(D_p_y_1);
    D_p[7] = LANES(D_p_y_2);
    D_p[8] = LANES(D_p_y_3);
    D_p[9] = LANES(D_p_y_4);
    D_p[10] = LANES(D_p_y_5);
    D_p[11] = LANES(D_p_y_6);
    D_p[12] = LANES(D_p_z_1);
    D_p[13] = LANES(D_p_z_2);
    D_p[14] = LANES(D_p_z_3);
    D_p[15] = LANES(D_p_z_4);
    D_p[16] = LANES(D_p_z_5);
    D_p[17] = LANES(D_p_z_6);
    D_p[18] = LANES(D_p_rx_1);
    D_p[19] = LANES(D_p_rx_2);
    D_p[20] = LANES(D_p_rx_3);
    D_p[21] = LANES(D_p_rx_4);
    D_p[22] = LANES(D_p_rx_5);
    D_p[23] = LANES(D_p_rx_6);
    D_p[24] = LANES(D_p_ry_1);
    D_p[25] = LANES(D_p_ry_2);
    D_p[26] = LANES(D_p_ry_3);
    D_p[27] = LANES(D_p_ry_4);
    D_p[28] = LANES(D_p_ry_5);
    D_p[29] = LANES(D_p_ry_6);
    D_p[30] = LANES(D_p_rz_1);
    D_p[31] = LANES(D_p_rz_2);
    D_p[32] = LANES(D_p_rz_3);
    D_p[33] = LANES(D_p_rz_4);
    D_p[34] = LANES(D_p_rz_5);
    D_p[35] = LANES(D_p_rz_6);
    tau_st[0] = LANES(f_st_1);
    tau_st[1] = LANES(f_st_2);
    tau_st[2] = LANES(f_st_3);
    tau_st[3] = LANES(f_st_4);
    tau_st[4] = LANES(f_st_5);
    tau_st[5] = LANES(f_st_6);
    theta_st[0] = LANES(s_1_st);
    theta_st[1] = LANES(s_2_st);
    theta_st[2] = LANES(s_3_st);
    theta_st[3] = LANES(s_4_st);
    theta_st[4] = LANES(s_5_st);
    theta_st[5] = LANES(s_6_st);
    lanes_clear(H_el, 144);
    H_el[0] = LANES(k_l_1);
    H_el[6] = H_el[72] = LANES(-k_l_1);
    H_el[13] = LANES(k_l_2);
    H_el[19] = H_el[85] = LANES(-k_l_2);
    H_el[26] = LANES(k_l_3);
    H_el[32] = H_el[98] = LANES(-k_l_3);
    H_el[39] = LANES(k_l_4);
    H_el[45] = H_el[111] = LANES(-k_l_4);
    H_el[52] = LANES(k_l_5);
    H_el[58] = H_el[124] = LANES(-k_l_5);
    H_el[65] = LANES(k_l_6);
    H_el[71] = H_el[137] = LANES(-k_l_6);
    H_el[78] = LANES(k_l_1);
    H_el[91] = LANES(k_l_2);
    H_el[104] = LANES(k_l_3);
    H_el[117] = LANES(k_l_4);
    H_el[130] = LANES(k_l_5);
    H_el[143] = LANES(k_l_6);
}

/* Drive forces and displacements that hold the pose, with the weights and stiffness changes of effects.
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 1846 operations; 36307794 with every named value expanded.
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
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double m_p = parameters[0];
    const double c_p_x = parameters[1];
    const double c_p_y = parameters[2];
    const double c_p_z = parameters[3];
    const double g_x = parameters[10];
    const double g_y = parameters[11];
    const double g_z = parameters[12];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double k_l_1 = parameters[61];
    const double k_l_2 = parameters[62];
    const double k_l_3 = parameters[63];
    const double k_l_4 = parameters[64];
    const double k_l_5 = parameters[65];
    const double k_l_6 = parameters[66];
    const double m_b_1 = parameters[67];
    const double m_b_2 = parameters[68];
    const double m_b_3 = parameters[69];
    const double m_b_4 = parameters[70];
    const double m_b_5 = parameters[71];
    const double m_b_6 = parameters[72];
    const double c_b_1 = parameters[73];
    const double c_b_2 = parameters[74];
    const double c_b_3 = parameters[75];
    const double c_b_4 = parameters[76];
    const double c_b_5 = parameters[77];
    const double c_b_6 = parameters[78];
    const double m_r_1 = parameters[85];
    const double m_r_2 = parameters[86];
    const double m_r_3 = parameters[87];
    const double m_r_4 = parameters[88];
    const double m_r_5 = parameters[89];
    const double m_r_6 = parameters[90];
    const double c_r_1 = parameters[91];
    const double c_r_2 = parameters[92];
    const double c_r_3 = parameters[93];
    const double c_r_4 = parameters[94];
    const double c_r_5 = parameters[95];
    const double c_r_6 = parameters[96];
    const double a_S_1 = effects[0];
    const double a_S_2 = effects[1];
    const double a_S_3 = effects[2];
    const double a_S_4 = effects[3];
    const double a_S_5 = effects[4];
    const double a_S_6 = effects[5];
    const double m_L = effects[9];
    const double b_L_x = effects[10];
    const double b_L_y = effects[11];
    const double b_L_z = effects[12];
    const lane t1 = (rot_x*rot_x);
    const lane t2 = (rot_y*rot_y);
    const lane t3 = (rot_z*rot_z);
    const lane t4 = t2 + t3;
    const lane half_angle = (1.0/2.0)*lanes_sqrt(t1 + t4 + 1e-30);
    const lane s_half = lanes_sin(half_angle)/half_angle;
    const lane t5 = (s_half*s_half);
    const lane t6 = (1.0/2.0)*t5;
    const lane R_x_x = -t4*t6 + 1.0;
    const lane c_half = lanes_cos(half_angle);
    const lane t7 = c_half*s_half;
    const lane t8 = rot_z*t7;
    const lane R_x_y = (1.0/2.0)*rot_x*rot_y*t5 - t8;
    const lane t9 = rot_y*t7;
    const lane t10 = rot_x*t6;
    const lane R_x_z = rot_z*t10 + t9;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = rot_y*t10 + t8;
    const lane R_y_y = t6*(-t1 - t3) + 1.0;
    const lane t11 = rot_x*t7;
    const lane R_y_z = (1.0/2.0)*rot_y*rot_z*t5 - t11;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = (1.0/2.0)*rot_x*rot_z*t5 - t9;
    const lane R_z_y = rot_y*rot_z*t6 + t11;
    const lane R_z_z = t6*(-t1 - t2) + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane l_1 = lanes_sqrt((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const lane l_2 = lanes_sqrt((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const lane l_3 = lanes_sqrt((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const lane l_4 = lanes_sqrt((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const lane l_5 = lanes_sqrt((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const lane l_6 = lanes_sqrt((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const lane c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const lane c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const lane c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const double t12 = c_b_1*m_b_1 - c_r_1*m_r_1;
    const lane m_lift_1 = m_r_1 + t12/l_1;
    const double t13 = c_b_2*m_b_2 - c_r_2*m_r_2;
    const lane m_lift_2 = m_r_2 + t13/l_2;
    const double t14 = c_b_3*m_b_3 - c_r_3*m_r_3;
    const lane m_lift_3 = m_r_3 + t14/l_3;
    const double t15 = c_b_4*m_b_4 - c_r_4*m_r_4;
    const lane m_lift_4 = m_r_4 + t15/l_4;
    const double t16 = c_b_5*m_b_5 - c_r_5*m_r_5;
    const lane m_lift_5 = m_r_5 + t16/l_5;
    const double t17 = c_b_6*m_b_6 - c_r_6*m_r_6;
    const lane m_lift_6 = m_r_6 + t17/l_6;
    const lane o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const lane o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const lane o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane t18 = 1.0/det_D_l;
    const lane t19 = l_1*t18;
    const lane D_p_x_1 = A_x_1*t19;
    const lane t20 = l_2*t18;
    const lane D_p_x_2 = A_x_2*t20;
    const lane t21 = l_3*t18;
    const lane D_p_x_3 = A_x_3*t21;
    const lane t22 = l_4*t18;
    const lane D_p_x_4 = A_x_4*t22;
    const lane t23 = l_5*t18;
    const lane D_p_x_5 = A_x_5*t23;
    const lane t24 = l_6*t18;
    const lane D_p_x_6 = A_x_6*t24;
    const lane D_p_y_1 = A_y_1*t19;
    const lane D_p_y_2 = A_y_2*t20;
    const lane D_p_y_3 = A_y_3*t21;
    const lane D_p_y_4 = A_y_4*t22;
    const lane D_p_y_5 = A_y_5*t23;
    const lane D_p_y_6 = A_y_6*t24;
    const lane D_p_z_1 = A_z_1*t19;
    const lane D_p_z_2 = A_z_2*t20;
    const lane D_p_z_3 = A_z_3*t21;
    const lane D_p_z_4 = A_z_4*t22;
    const lane D_p_z_5 = A_z_5*t23;
    const lane D_p_z_6 = A_z_6*t24;
    const lane D_p_rx_1 = A_rx_1*t19;
    const lane D_p_rx_2 = A_rx_2*t20;
    const lane D_p_rx_3 = A_rx_3*t21;
    const lane D_p_rx_4 = A_rx_4*t22;
    const lane D_p_rx_5 = A_rx_5*t23;
    const lane D_p_rx_6 = A_rx_6*t24;
    const lane D_p_ry_1 = A_ry_1*t19;
    const lane D_p_ry_2 = A_ry_2*t20;
    const lane D_p_ry_3 = A_ry_3*t21;
    const lane D_p_ry_4 = A_ry_4*t22;
    const lane D_p_ry_5 = A_ry_5*t23;
    const lane D_p_ry_6 = A_ry_6*t24;
    const lane D_p_rz_1 = A_rz_1*t19;
    const lane D_p_rz_2 = A_rz_2*t20;
    const lane D_p_rz_3 = A_rz_3*t21;
    const lane D_p_rz_4 = A_rz_4*t22;
    const lane D_p_rz_5 = A_rz_5*t23;
    const lane D_p_rz_6 = A_rz_6*t24;
    const double k_1 = k_l_1*(a_S_1 + 1.0);
    const double k_2 = k_l_2*(a_S_2 + 1.0);
    const double k_3 = k_l_3*(a_S_3 + 1.0);
    const double k_4 = k_l_4*(a_S_4 + 1.0);
    const double k_5 = k_l_5*(a_S_5 + 1.0);
    const double k_6 = k_l_6*(a_S_6 + 1.0);
    const lane t25 = g_x*m_lift_1;
    const lane t26 = g_x*m_lift_2;
    const lane t27 = g_x*m_lift_3;
    const lane t28 = g_x*m_lift_4;
    const lane t29 = g_x*m_lift_5;
    const lane t30 = g_x*m_lift_6;
    const double t31 = m_L + m_p;
    const lane G_p_x = -g_x*t31 - t25 - t26 - t27 - t28 - t29 - t30;
    const lane t32 = g_y*m_lift_1;
    const lane t33 = g_y*m_lift_2;
    const lane t34 = g_y*m_lift_3;
    const lane t35 = g_y*m_lift_4;
    const lane t36 = g_y*m_lift_5;
    const lane t37 = g_y*m_lift_6;
    const lane G_p_y = -g_y*t31 - t32 - t33 - t34 - t35 - t36 - t37;
    const lane t38 = g_z*m_lift_1;
    const lane t39 = g_z*m_lift_2;
    const lane t40 = g_z*m_lift_3;
    const lane t41 = g_z*m_lift_4;
    const lane t42 = g_z*m_lift_5;
    const lane t43 = g_z*m_lift_6;
    const lane G_p_z = -g_z*t31 - t38 - t39 - t40 - t41 - t42 - t43;
    const double t44 = g_z*m_p;
    const double t45 = g_z*m_L;
    const lane G_p_rx =
        -B_1_y*t38 + B_1_z*g_y*m_lift_1 - B_2_y*t39 + B_2_z*g_y*m_lift_2 - B_3_y*t40 + B_3_z*g_y*m_lift_3
        - B_4_y*t41 + B_4_z*g_y*m_lift_4 - B_5_y*t42 + B_5_z*g_y*m_lift_5 - B_6_y*t43 + B_6_z*g_y*m_lift_6
        - c_y*t44 + c_z*g_y*m_p + g_y*m_L*o_L_z - o_L_y*t45;
    const lane G_p_ry =
        B_1_x*t38 - B_1_z*t25 + B_2_x*t39 - B_2_z*t26 + B_3_x*t40 - B_3_z*t27 + B_4_x*t41 - B_4_z*t28
        + B_5_x*t42 - B_5_z*t29 + B_6_x*t43 - B_6_z*t30 + c_x*t44 - c_z*g_x*m_p - g_x*m_L*o_L_z + o_L_x*t45;
    const lane G_p_rz =
        -B_1_x*t32 + B_1_y*g_x*m_lift_1 - B_2_x*t33 + B_2_y*g_x*m_lift_2 - B_3_x*t34 + B_3_y*g_x*m_lift_3
        - B_4_x*t35 + B_4_y*g_x*m_lift_4 - B_5_x*t36 + B_5_y*g_x*m_lift_5 - B_6_x*t37 + B_6_y*g_x*m_lift_6
        - c_x*g_y*m_p + c_y*g_x*m_p + g_x*m_L*o_L_y - g_y*m_L*o_L_x;
    const lane G_1 =
        D_p_rx_1*G_p_rx + D_p_ry_1*G_p_ry + D_p_rz_1*G_p_rz + D_p_x_1*G_p_x + D_p_y_1*G_p_y + D_p_z_1*G_p_z
        - t12*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z)/(l_1*l_1);
    const lane G_2 =
        D_p_rx_2*G_p_rx + D_p_ry_2*G_p_ry + D_p_rz_2*G_p_rz + D_p_x_2*G_p_x + D_p_y_2*G_p_y + D_p_z_2*G_p_z
        - t13*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z)/(l_2*l_2);
    const lane G_3 =
        D_p_rx_3*G_p_rx + D_p_ry_3*G_p_ry + D_p_rz_3*G_p_rz + D_p_x_3*G_p_x + D_p_y_3*G_p_y + D_p_z_3*G_p_z
        - t14*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z)/(l_3*l_3);
    const lane G_4 =
        D_p_rx_4*G_p_rx + D_p_ry_4*G_p_ry + D_p_rz_4*G_p_rz + D_p_x_4*G_p_x + D_p_y_4*G_p_y + D_p_z_4*G_p_z
        - t15*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z)/(l_4*l_4);
    const lane G_5 =
        D_p_rx_5*G_p_rx + D_p_ry_5*G_p_ry + D_p_rz_5*G_p_rz + D_p_x_5*G_p_x + D_p_y_5*G_p_y + D_p_z_5*G_p_z
        - t16*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z)/(l_5*l_5);
    const lane G_6 =
        D_p_rx_6*G_p_rx + D_p_ry_6*G_p_ry + D_p_rz_6*G_p_rz + D_p_x_6*G_p_x + D_p_y_6*G_p_y + D_p_z_6*G_p_z
        - t17*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z)/(l_6*l_6);
    const lane s_1_st = G_1/k_1;
    const lane s_2_st = G_2/k_2;
    const lane s_3_st = G_3/k_3;
    const lane s_4_st = G_4/k_4;
    const lane s_5_st = G_5/k_5;
    const lane s_6_st = G_6/k_6;
    const lane f_st_1 = k_1*s_1_st;
    const lane f_st_2 = k_2*s_2_st;
    const lane f_st_3 = k_3*s_3_st;
    const lane f_st_4 = k_4*s_4_st;
    const lane f_st_5 = k_5*s_5_st;
    const lane f_st_6 = k_6*s_6_st;
    tau_st[0] = LANES(f_st_1);
    tau_st[1] = LANES(f_st_2);
    tau_st[2] = LANES(f_st_3);
    tau_st[3] = LANES(f_st_4);
    tau_st[4] = LANES(f_st_5);
    tau_st[5] = LANES(f_st_6);
    theta_st[0] = LANES(s_1_st);
    theta_st[1] = LANES(s_2_st);
    theta_st[2] = LANES(s_3_st);
    theta_st[3] = LANES(s_4_st);
    theta_st[4] = LANES(s_5_st);
    theta_st[5] = LANES(s_6_st);
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through base.
 * 11250 operations; 2290712066528190 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_base_gradient(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int modes, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
    (void)effects;
    const lane p_x = pose[0];
    const lane p_y = pose[1];
    const lane p_z = pose[2];
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double m_p = parameters[0];
    const double c_p_x = parameters[1];
    const double c_p_y = parameters[2];
    const double c_p_z = parameters[3];
    const double I_p_x = parameters[4];
    const double I_p_y = parameters[5];
    const double I_p_z = parameters[6];
    const double I_p_xy = parameters[7];
    const double I_p_xz = parameters[8];
    const double I_p_yz = parameters[9];
    const double g_x = parameters[10];
    const double g_y = parameters[11];
    const double g_z = parameters[12];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double m_b_1 = parameters[67];
    const double m_b_2 = parameters[68];
    const double m_b_3 = parameters[69];
    const double m_b_4 = parameters[70];
    const double m_b_5 = parameters[71];
    const double m_b_6 = parameters[72];
    const double c_b_1 = parameters[73];
    const double c_b_2 = parameters[74];
    const double c_b_3 = parameters[75];
    const double c_b_4 = parameters[76];
    const double c_b_5 = parameters[77];
    const double c_b_6 = parameters[78];
    const double I_b_1 = parameters[79];
    const double I_b_2 = parameters[80];
    const double I_b_3 = parameters[81];
    const double I_b_4 = parameters[82];
    const double I_b_5 = parameters[83];
    const double I_b_6 = parameters[84];
    const double m_r_1 = parameters[85];
    const double m_r_2 = parameters[86];
    const double m_r_3 = parameters[87];
    const double m_r_4 = parameters[88];
    const double m_r_5 = parameters[89];
    const double m_r_6 = parameters[90];
    const double c_r_1 = parameters[91];
    const double c_r_2 = parameters[92];
    const double c_r_3 = parameters[93];
    const double c_r_4 = parameters[94];
    const double c_r_5 = parameters[95];
    const double c_r_6 = parameters[96];
    const double I_r_1 = parameters[97];
    const double I_r_2 = parameters[98];
    const double I_r_3 = parameters[99];
    const double I_r_4 = parameters[100];
    const double I_r_5 = parameters[101];
    const double I_r_6 = parameters[102];
    const double I_m_1 = parameters[103];
    const double I_m_2 = parameters[104];
    const double I_m_3 = parameters[105];
    const double I_m_4 = parameters[106];
    const double I_m_5 = parameters[107];
    const double I_m_6 = parameters[108];
    const double h_m_1 = parameters[109];
    const double h_m_2 = parameters[110];
    const double h_m_3 = parameters[111];
    const double h_m_4 = parameters[112];
    const double h_m_5 = parameters[113];
    const double h_m_6 = parameters[114];
    const lane forward_t1 = (rot_x*rot_x);
    const lane forward_t2 = (rot_y*rot_y);
    const lane forward_t3 = (rot_z*rot_z);
    const lane forward_t4 = forward_t2 + forward_t3;
    const lane forward_0 = lanes_sqrt(forward_t1 + forward_t4 + 1e-30);
    const lane half_angle = (1.0/2.0)*forward_0;
    const lane forward_1 = 1.0/half_angle;
    const lane forward_2 = lanes_sin(half_angle);
    const lane s_half = forward_1*forward_2;
    const lane forward_t5 = (s_half*s_half);
    const lane forward_t6 = (1.0/2.0)*forward_t5;
    const lane R_x_x = -forward_t4*forward_t6 + 1.0;
    const lane forward_3 = lanes_cos(half_angle);
    const lane forward_t7 = forward_3*s_half;
    const lane forward_t8 = forward_t7*rot_z;
    const lane t1 = forward_t6*rot_x;
    const lane R_x_y = -forward_t8 + rot_y*t1;
    const lane forward_t9 = forward_t7*rot_y;
    const lane forward_t10 = forward_t6*rot_x;
    const lane R_x_z = forward_t10*rot_z + forward_t9;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = forward_t10*rot_y + forward_t8;
    const lane t2 = -forward_t1 - forward_t3;
    const lane R_y_y = forward_t6*t2 + 1.0;
    const lane forward_t11 = forward_t7*rot_x;
    const lane R_y_z = -forward_t11 + (1.0/2.0)*forward_t5*rot_y*rot_z;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = -forward_t9 + rot_z*t1;
    const lane t3 = rot_y*rot_z;
    const lane R_z_y = forward_t11 + forward_t6*t3;
    const lane t4 = -forward_t1 - forward_t2;
    const lane R_z_z = forward_t6*t4 + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane forward_4 = lanes_sqrt((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const lane forward_5 = lanes_sqrt((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const lane forward_6 = lanes_sqrt((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const lane forward_7 = lanes_sqrt((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const lane forward_8 = lanes_sqrt((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const lane forward_9 = lanes_sqrt((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const lane c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const lane c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const lane c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const lane forward_t12 = I_p_xy*R_x_x;
    const lane forward_t13 = I_p_xz*R_x_x;
    const lane forward_t14 = 2.0*R_x_z;
    const lane forward_t15 = I_p_yz*R_x_y;
    const lane t5 = 2.0*forward_t12;
    const lane t6 = (R_x_x*R_x_x);
    const lane t7 = (R_x_y*R_x_y);
    const lane t8 = (R_x_z*R_x_z);
    const lane J_x_x =
        I_p_x*t6 + I_p_y*t7 + I_p_z*t8 + R_x_y*t5 + forward_t13*forward_t14 + forward_t14*forward_t15;
    const lane forward_t16 = I_p_x*R_x_x;
    const lane forward_t17 = I_p_xy*R_x_y;
    const lane forward_t18 = I_p_xz*R_x_z;
    const lane forward_t19 = I_p_y*R_x_y;
    const lane forward_t20 = I_p_yz*R_x_z;
    const lane forward_t21 = I_p_z*R_x_z;
    const lane J_x_y =
        R_y_x*forward_t16 + R_y_x*forward_t17 + R_y_x*forward_t18 + R_y_y*forward_t12 + R_y_y*forward_t19
        + R_y_y*forward_t20 + R_y_z*forward_t13 + R_y_z*forward_t15 + R_y_z*forward_t21;
    const lane J_x_z =
        R_z_x*forward_t16 + R_z_x*forward_t17 + R_z_x*forward_t18 + R_z_y*forward_t12 + R_z_y*forward_t19
        + R_z_y*forward_t20 + R_z_z*forward_t13 + R_z_z*forward_t15 + R_z_z*forward_t21;
    const lane forward_t22 = I_p_xy*R_y_x;
    const lane forward_t23 = I_p_xz*R_y_x;
    const lane forward_t24 = 2.0*R_y_z;
    const lane forward_t25 = I_p_yz*R_y_y;
    const lane t9 = 2.0*forward_t22;
    const lane t10 = (R_y_x*R_y_x);
    const lane t11 = (R_y_y*R_y_y);
    const lane t12 = (R_y_z*R_y_z);
    const lane J_y_y =
        I_p_x*t10 + I_p_y*t11 + I_p_z*t12 + R_y_y*t9 + forward_t23*forward_t24 + forward_t24*forward_t25;
    const lane forward_t26 = I_p_xy*R_z_x;
    const lane forward_t27 = I_p_xz*R_z_x;
    const lane forward_t28 = I_p_yz*R_z_y;
    const lane t13 = I_p_x*R_y_x;
    const lane t14 = I_p_y*R_y_y;
    const lane t15 = I_p_z*R_y_z;
    const lane J_y_z =
        R_y_y*forward_t26 + R_y_z*forward_t27 + R_y_z*forward_t28 + R_z_x*t13 + R_z_y*forward_t22 + R_z_y*t14
        + R_z_z*forward_t23 + R_z_z*forward_t25 + R_z_z*t15;
    const lane forward_t29 = 2.0*R_z_z;
    const lane t16 = 2.0*forward_t26;
    const lane t17 = (R_z_x*R_z_x);
    const lane t18 = (R_z_y*R_z_y);
    const lane t19 = (R_z_z*R_z_z);
    const lane J_z_z =
        I_p_x*t17 + I_p_y*t18 + I_p_z*t19 + R_z_y*t16 + forward_t27*forward_t29 + forward_t28*forward_t29;
    const lane forward_10 = 1.0/((forward_4*forward_4));
    const lane forward_11 = 1.0/forward_4;
    const double t20 = (c_b_1*c_b_1);
    const double t21 = m_b_1*t20;
    const lane t22 = -c_r_1*forward_11 + 1.0;
    const lane t23 = (t22*t22);
    const lane m_perp_1 = I_b_1*forward_10 + I_r_1*forward_10 + forward_10*t21 + m_r_1*t23;
    const double t24 = c_b_1*m_b_1;
    const double t25 = c_r_1*m_r_1;
    const double forward_t32 = t24 - t25;
    const lane m_lift_1 = forward_11*forward_t32 + m_r_1;
    const lane forward_12 = 1.0/((forward_5*forward_5));
    const lane forward_13 = 1.0/forward_5;
    const double t26 = (c_b_2*c_b_2);
    const double t27 = m_b_2*t26;
    const lane t28 = -c_r_2*forward_13 + 1.0;
    const lane t29 = (t28*t28);
    const lane m_perp_2 = I_b_2*forward_12 + I_r_2*forward_12 + forward_12*t27 + m_r_2*t29;
    const double t30 = c_b_2*m_b_2;
    const double t31 = c_r_2*m_r_2;
    const double forward_t35 = t30 - t31;
    const lane m_lift_2 = forward_13*forward_t35 + m_r_2;
    const lane forward_14 = 1.0/((forward_6*forward_6));
    const lane forward_15 = 1.0/forward_6;
    const double t32 = (c_b_3*c_b_3);
    const double t33 = m_b_3*t32;
    const lane t34 = -c_r_3*forward_15 + 1.0;
    const lane t35 = (t34*t34);
    const lane m_perp_3 = I_b_3*forward_14 + I_r_3*forward_14 + forward_14*t33 + m_r_3*t35;
    const double t36 = c_b_3*m_b_3;
    const double t37 = c_r_3*m_r_3;
    const double forward_t38 = t36 - t37;
    const lane m_lift_3 = forward_15*forward_t38 + m_r_3;
    const lane forward_16 = 1.0/((forward_7*forward_7));
    const lane forward_17 = 1.0/forward_7;
    const double t38 = (c_b_4*c_b_4);
    const double t39 = m_b_4*t38;
    const lane t40 = -c_r_4*forward_17 + 1.0;
    const lane t41 = (t40*t40);
    const lane m_perp_4 = I_b_4*forward_16 + I_r_4*forward_16 + forward_16*t39 + m_r_4*t41;
    const double t42 = c_b_4*m_b_4;
    const double t43 = c_r_4*m_r_4;
    const double forward_t41 = t42 - t43;
    const lane m_lift_4 = forward_17*forward_t41 + m_r_4;
    const lane forward_18 = 1.0/((forward_8*forward_8));
    const lane forward_19 = 1.0/forward_8;
    const double t44 = (c_b_5*c_b_5);
    const double t45 = m_b_5*t44;
    const lane t46 = -c_r_5*forward_19 + 1.0;
    const lane t47 = (t46*t46);
    const lane m_perp_5 = I_b_5*forward_18 + I_r_5*forward_18 + forward_18*t45 + m_r_5*t47;
    const double t48 = c_b_5*m_b_5;
    const double t49 = c_r_5*m_r_5;
    const double forward_t44 = t48 - t49;
    const lane m_lift_5 = forward_19*forward_t44 + m_r_5;
    const lane forward_20 = 1.0/((forward_9*forward_9));
    const lane forward_21 = 1.0/forward_9;
    const double t50 = (c_b_6*c_b_6);
    const double t51 = m_b_6*t50;
    const lane t52 = -c_r_6*forward_21 + 1.0;
    const lane t53 = (t52*t52);
    const lane m_perp_6 = I_b_6*forward_20 + I_r_6*forward_20 + forward_20*t51 + m_r_6*t53;
    const double t54 = c_b_6*m_b_6;
    const double t55 = c_r_6*m_r_6;
    const double forward_t47 = t54 - t55;
    const lane m_lift_6 = forward_21*forward_t47 + m_r_6;
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane forward_22 = 1.0/det_D_l;
    const lane forward_t49 = forward_22*forward_4;
    const lane D_p_x_1 = A_x_1*forward_t49;
    const lane forward_t50 = forward_22*forward_5;
    const lane D_p_x_2 = A_x_2*forward_t50;
    const lane forward_t51 = forward_22*forward_6;
    const lane D_p_x_3 = A_x_3*forward_t51;
    const lane forward_t52 = forward_22*forward_7;
    const lane D_p_x_4 = A_x_4*forward_t52;
    const lane forward_t53 = forward_22*forward_8;
    const lane D_p_x_5 = A_x_5*forward_t53;
    const lane forward_t54 = forward_22*forward_9;
    const lane D_p_x_6 = A_x_6*forward_t54;
    const lane D_p_y_1 = A_y_1*forward_t49;
    const lane D_p_y_2 = A_y_2*forward_t50;
    const lane D_p_y_3 = A_y_3*forward_t51;
    const lane D_p_y_4 = A_y_4*forward_t52;
    const lane D_p_y_5 = A_y_5*forward_t53;
    const lane D_p_y_6 = A_y_6*forward_t54;
    const lane D_p_z_1 = A_z_1*forward_t49;
    const lane D_p_z_2 = A_z_2*forward_t50;
    const lane D_p_z_3 = A_z_3*forward_t51;
    const lane D_p_z_4 = A_z_4*forward_t52;
    const lane D_p_z_5 = A_z_5*forward_t53;
    const lane D_p_z_6 = A_z_6*forward_t54;
    const lane D_p_rx_1 = A_rx_1*forward_t49;
    const lane D_p_rx_2 = A_rx_2*forward_t50;
    const lane D_p_rx_3 = A_rx_3*forward_t51;
    const lane D_p_rx_4 = A_rx_4*forward_t52;
    const lane D_p_rx_5 = A_rx_5*forward_t53;
    const lane D_p_rx_6 = A_rx_6*forward_t54;
    const lane D_p_ry_1 = A_ry_1*forward_t49;
    const lane D_p_ry_2 = A_ry_2*forward_t50;
    const lane D_p_ry_3 = A_ry_3*forward_t51;
    const lane D_p_ry_4 = A_ry_4*forward_t52;
    const lane D_p_ry_5 = A_ry_5*forward_t53;
    const lane D_p_ry_6 = A_ry_6*forward_t54;
    const lane D_p_rz_1 = A_rz_1*forward_t49;
    const lane D_p_rz_2 = A_rz_2*forward_t50;
    const lane D_p_rz_3 = A_rz_3*forward_t51;
    const lane D_p_rz_4 = A_rz_4*forward_t52;
    const lane D_p_rz_5 = A_rz_5*forward_t53;
    const lane D_p_rz_6 = A_rz_6*forward_t54;
    const lane forward_t55 = g_x*m_lift_1;
    const lane forward_t56 = g_x*m_lift_2;
    const lane forward_t57 = g_x*m_lift_3;
    const lane forward_t58 = g_x*m_lift_4;
    const lane forward_t59 = g_x*m_lift_5;
    const lane forward_t60 = g_x*m_lift_6;
    const double forward_t61 = g_x*m_p;
    const lane G_p_x =
        -forward_t55 - forward_t56 - forward_t57 - forward_t58 - forward_t59 - forward_t60 - forward_t61;
    const lane forward_t62 = g_y*m_lift_1;
    const lane forward_t63 = g_y*m_lift_2;
    const lane forward_t64 = g_y*m_lift_3;
    const lane forward_t65 = g_y*m_lift_4;
    const lane forward_t66 = g_y*m_lift_5;
    const lane forward_t67 = g_y*m_lift_6;
    const double forward_t68 = g_y*m_p;
    const lane G_p_y =
        -forward_t62 - forward_t63 - forward_t64 - forward_t65 - forward_t66 - forward_t67 - forward_t68;
    const lane forward_t69 = g_z*m_lift_1;
    const lane forward_t70 = g_z*m_lift_2;
    const lane forward_t71 = g_z*m_lift_3;
    const lane forward_t72 = g_z*m_lift_4;
    const lane forward_t73 = g_z*m_lift_5;
    const lane forward_t74 = g_z*m_lift_6;
    const double forward_t75 = g_z*m_p;
    const lane G_p_z =
        -forward_t69 - forward_t70 - forward_t71 - forward_t72 - forward_t73 - forward_t74 - forward_t75;
    const lane G_p_rx =
        -B_1_y*forward_t69 + B_1_z*g_y*m_lift_1 - B_2_y*forward_t70 + B_2_z*g_y*m_lift_2 - B_3_y*forward_t71
        + B_3_z*g_y*m_lift_3 - B_4_y*forward_t72 + B_4_z*g_y*m_lift_4 - B_5_y*forward_t73
        + B_5_z*g_y*m_lift_5 - B_6_y*forward_t74 + B_6_z*g_y*m_lift_6 - c_y*forward_t75 + c_z*g_y*m_p;
    const lane G_p_ry =
        B_1_x*forward_t69 - B_1_z*forward_t55 + B_2_x*forward_t70 - B_2_z*forward_t56 + B_3_x*forward_t71
        - B_3_z*forward_t57 + B_4_x*forward_t72 - B_4_z*forward_t58 + B_5_x*forward_t73 - B_5_z*forward_t59
        + B_6_x*forward_t74 - B_6_z*forward_t60 + c_x*forward_t75 - c_z*forward_t61;
    const lane G_p_rz =
        -B_1_x*forward_t62 + B_1_y*g_x*m_lift_1 - B_2_x*forward_t63 + B_2_y*g_x*m_lift_2 - B_3_x*forward_t64
        + B_3_y*g_x*m_lift_3 - B_4_x*forward_t65 + B_4_y*g_x*m_lift_4 - B_5_x*forward_t66
        + B_5_y*g_x*m_lift_5 - B_6_x*forward_t67 + B_6_y*g_x*m_lift_6 - c_x*forward_t68 + c_y*g_x*m_p;
    const lane t56 = A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z;
    const lane mu_1 = forward_22*t56;
    const lane t57 = A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z;
    const lane mu_2 = forward_22*t57;
    const lane t58 = A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z;
    const lane mu_3 = forward_22*t58;
    const lane t59 = A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z;
    const lane mu_4 = forward_22*t59;
    const lane t60 = A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z;
    const lane mu_5 = forward_22*t60;
    const lane t61 = A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z;
    const lane mu_6 = forward_22*t61;
    const lane g_4_x = -d_1_x*mu_1 - forward_t55;
    const lane g_4_y = -d_1_y*mu_1 - forward_t62;
    const lane g_4_z = -d_1_z*mu_1 - forward_t69;
    const lane g_5_x = -d_2_x*mu_2 - forward_t56;
    const lane g_5_y = -d_2_y*mu_2 - forward_t63;
    const lane g_5_z = -d_2_z*mu_2 - forward_t70;
    const lane g_6_x = -d_3_x*mu_3 - forward_t57;
    const lane g_6_y = -d_3_y*mu_3 - forward_t64;
    const lane g_6_z = -d_3_z*mu_3 - forward_t71;
    const lane g_7_x = -d_4_x*mu_4 - forward_t58;
    const lane g_7_y = -d_4_y*mu_4 - forward_t65;
    const lane g_7_z = -d_4_z*mu_4 - forward_t72;
    const lane g_8_x = -d_5_x*mu_5 - forward_t59;
    const lane g_8_y = -d_5_y*mu_5 - forward_t66;
    const lane g_8_z = -d_5_z*mu_5 - forward_t73;
    const lane g_9_x = -d_6_x*mu_6 - forward_t60;
    const lane g_9_y = -d_6_y*mu_6 - forward_t67;
    const lane g_9_z = -d_6_z*mu_6 - forward_t74;
    const double g_10_x = -forward_t61;
    const double g_10_y = -forward_t68;
    const double g_10_z = -forward_t75;
    const lane L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const lane forward_t76 = B_1_z*mu_1;
    const lane forward_t77 = B_2_z*mu_2;
    const lane forward_t78 = B_3_z*mu_3;
    const lane forward_t79 = B_4_z*mu_4;
    const lane forward_t80 = B_5_z*mu_5;
    const lane forward_t81 = B_6_z*mu_6;
    const lane L_y_rx = forward_t76 + forward_t77 + forward_t78 + forward_t79 + forward_t80 + forward_t81;
    const lane L_x_ry = -L_y_rx;
    const lane forward_t82 = B_1_y*mu_1;
    const lane forward_t83 = B_2_y*mu_2;
    const lane forward_t84 = B_3_y*mu_3;
    const lane forward_t85 = B_4_y*mu_4;
    const lane forward_t86 = B_5_y*mu_5;
    const lane forward_t87 = B_6_y*mu_6;
    const lane L_x_rz = forward_t82 + forward_t83 + forward_t84 + forward_t85 + forward_t86 + forward_t87;
    const lane L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const lane L_y_rz = -L_z_ry;
    const lane L_z_rx = -L_x_rz;
    const lane forward_t88 = (B_3_y*B_3_y);
    const lane forward_t89 = (B_4_y*B_4_y);
    const lane forward_t90 = (B_5_y*B_5_y);
    const lane forward_t91 = (B_6_y*B_6_y);
    const lane forward_t92 = (B_1_y*B_1_y);
    const lane forward_t93 = (B_2_y*B_2_y);
    const lane forward_t94 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + forward_t88*mu_3 + forward_t89*mu_4 + forward_t90*mu_5 + forward_t91*mu_6 + forward_t92*mu_1
        + forward_t93*mu_2;
    const lane forward_t95 = (B_1_z*B_1_z);
    const lane forward_t96 = (B_2_z*B_2_z);
    const lane forward_t97 = (B_3_z*B_3_z);
    const lane forward_t98 = (B_4_z*B_4_z);
    const lane forward_t99 = (B_5_z*B_5_z);
    const lane forward_t100 = (B_6_z*B_6_z);
    const lane forward_t101 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + forward_t100*mu_6 + forward_t95*mu_1 + forward_t96*mu_2 + forward_t97*mu_3 + forward_t98*mu_4
        + forward_t99*mu_5;
    const lane L_rx_rx = -forward_t101 - forward_t94;
    const lane forward_t102 = (1.0/2.0)*B_1_x;
    const lane forward_t103 = (1.0/2.0)*g_4_x;
    const lane forward_t104 = (1.0/2.0)*B_2_x;
    const lane forward_t105 = (1.0/2.0)*g_5_x;
    const lane forward_t106 = (1.0/2.0)*B_3_x;
    const lane forward_t107 = (1.0/2.0)*g_6_x;
    const lane forward_t108 = (1.0/2.0)*B_4_x;
    const lane forward_t109 = (1.0/2.0)*g_7_x;
    const lane forward_t110 = (1.0/2.0)*B_5_x;
    const lane forward_t111 = (1.0/2.0)*g_8_x;
    const lane forward_t112 = (1.0/2.0)*B_6_x;
    const lane forward_t113 = (1.0/2.0)*g_9_x;
    const lane forward_t114 = (1.0/2.0)*c_x;
    const double forward_t115 = (1.0/2.0)*g_10_x;
    const lane L_rx_ry =
        B_1_x*forward_t82 + B_1_y*forward_t103 + B_2_x*forward_t83 + B_2_y*forward_t105 + B_3_x*forward_t84
        + B_3_y*forward_t107 + B_4_x*forward_t85 + B_4_y*forward_t109 + B_5_x*forward_t86
        + B_5_y*forward_t111 + B_6_x*forward_t87 + B_6_y*forward_t113 + c_y*forward_t115 + forward_t102*g_4_y
        + forward_t104*g_5_y + forward_t106*g_6_y + forward_t108*g_7_y + forward_t110*g_8_y
        + forward_t112*g_9_y + forward_t114*g_10_y;
    const lane L_rx_rz =
        B_1_x*forward_t76 + B_1_z*forward_t103 + B_2_x*forward_t77 + B_2_z*forward_t105 + B_3_x*forward_t78
        + B_3_z*forward_t107 + B_4_x*forward_t79 + B_4_z*forward_t109 + B_5_x*forward_t80
        + B_5_z*forward_t111 + B_6_x*forward_t81 + B_6_z*forward_t113 + c_z*forward_t115 + forward_t102*g_4_z
        + forward_t104*g_5_z + forward_t106*g_6_z + forward_t108*g_7_z + forward_t110*g_8_z
        + forward_t112*g_9_z + forward_t114*g_10_z;
    const lane forward_t116 = (B_1_x*B_1_x);
    const lane forward_t117 = (B_2_x*B_2_x);
    const lane forward_t118 = (B_3_x*B_3_x);
    const lane forward_t119 = (B_4_x*B_4_x);
    const lane forward_t120 = (B_5_x*B_5_x);
    const lane forward_t121 = (B_6_x*B_6_x);
    const lane forward_t122 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + forward_t116*mu_1 + forward_t117*mu_2 + forward_t118*mu_3 + forward_t119*mu_4 + forward_t120*mu_5
        + forward_t121*mu_6;
    const lane L_ry_ry = -forward_t101 - forward_t122;
    const lane t62 = (1.0/2.0)*g_9_z;
    const lane t63 = (1.0/2.0)*B_6_z;
    const lane t64 = (1.0/2.0)*c_y;
    const lane t65 = (1.0/2.0)*c_z;
    const lane t66 = (1.0/2.0)*g_4_z;
    const lane t67 = (1.0/2.0)*B_1_z;
    const lane t68 = (1.0/2.0)*g_5_z;
    const lane t69 = (1.0/2.0)*B_2_z;
    const lane t70 = (1.0/2.0)*g_6_z;
    const lane t71 = (1.0/2.0)*B_3_z;
    const lane t72 = (1.0/2.0)*g_7_z;
    const lane t73 = (1.0/2.0)*B_4_z;
    const lane t74 = (1.0/2.0)*g_8_z;
    const lane t75 = (1.0/2.0)*B_5_z;
    const lane L_ry_rz =
        B_1_y*forward_t76 + B_1_y*t66 + B_2_y*forward_t77 + B_2_y*t68 + B_3_y*forward_t78 + B_3_y*t70
        + B_4_y*forward_t79 + B_4_y*t72 + B_5_y*forward_t80 + B_5_y*t74 + B_6_y*forward_t81 + B_6_y*t62
        + g_10_y*t65 + g_10_z*t64 + g_4_y*t67 + g_5_y*t69 + g_6_y*t71 + g_7_y*t73 + g_8_y*t75 + g_9_y*t63;
    const lane L_rz_rz = -forward_t122 - forward_t94;
    const lane forward_t123 = forward_10*forward_t32;
    const lane forward_t124 = forward_t123*g_x;
    const lane f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + forward_t124;
    const lane forward_t125 = forward_12*forward_t35;
    const lane forward_t126 = forward_t125*g_x;
    const lane f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + forward_t126;
    const lane forward_t127 = forward_14*forward_t38;
    const lane forward_t128 = forward_t127*g_x;
    const lane f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + forward_t128;
    const lane forward_t129 = forward_16*forward_t41;
    const lane forward_t130 = forward_t129*g_x;
    const lane f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + forward_t130;
    const lane forward_t131 = forward_18*forward_t44;
    const lane forward_t132 = forward_t131*g_x;
    const lane f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + forward_t132;
    const lane forward_t133 = forward_20*forward_t47;
    const lane forward_t134 = forward_t133*g_x;
    const lane f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + forward_t134;
    const lane forward_t135 = forward_t123*g_y;
    const lane f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + forward_t135;
    const lane forward_t136 = forward_t125*g_y;
    const lane f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + forward_t136;
    const lane forward_t137 = forward_t127*g_y;
    const lane f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + forward_t137;
    const lane forward_t138 = forward_t129*g_y;
    const lane f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + forward_t138;
    const lane forward_t139 = forward_t131*g_y;
    const lane f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + forward_t139;
    const lane forward_t140 = forward_t133*g_y;
    const lane f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + forward_t140;
    const lane forward_t141 = forward_t123*g_z;
    const lane f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + forward_t141;
    const lane forward_t142 = forward_t125*g_z;
    const lane f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + forward_t142;
    const lane forward_t143 = forward_t127*g_z;
    const lane f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + forward_t143;
    const lane forward_t144 = forward_t129*g_z;
    const lane f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + forward_t144;
    const lane forward_t145 = forward_t131*g_z;
    const lane f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + forward_t145;
    const lane forward_t146 = forward_t133*g_z;
    const lane f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + forward_t146;
    const lane t76 = -B_1_y*g_z + B_1_z*g_y;
    const lane forward_t147 = forward_t123*t76;
    const lane f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx
        - forward_t147;
    const lane t77 = -B_2_y*g_z + B_2_z*g_y;
    const lane forward_t148 = forward_t125*t77;
    const lane f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx
        - forward_t148;
    const lane t78 = -B_3_y*g_z + B_3_z*g_y;
    const lane forward_t149 = forward_t127*t78;
    const lane f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx
        - forward_t149;
    const lane t79 = -B_4_y*g_z + B_4_z*g_y;
    const lane forward_t150 = forward_t129*t79;
    const lane f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx
        - forward_t150;
    const lane t80 = -B_5_y*g_z + B_5_z*g_y;
    const lane forward_t151 = forward_t131*t80;
    const lane f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx
        - forward_t151;
    const lane t81 = -B_6_y*g_z + B_6_z*g_y;
    const lane forward_t152 = forward_t133*t81;
    const lane f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx
        - forward_t152;
    const lane t82 = B_1_x*g_z - B_1_z*g_x;
    const lane forward_t153 = forward_t123*t82;
    const lane f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry
        - forward_t153;
    const lane t83 = B_2_x*g_z - B_2_z*g_x;
    const lane forward_t154 = forward_t125*t83;
    const lane f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry
        - forward_t154;
    const lane t84 = B_3_x*g_z - B_3_z*g_x;
    const lane forward_t155 = forward_t127*t84;
    const lane f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry
        - forward_t155;
    const lane t85 = B_4_x*g_z - B_4_z*g_x;
    const lane forward_t156 = forward_t129*t85;
    const lane f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry
        - forward_t156;
    const lane t86 = B_5_x*g_z - B_5_z*g_x;
    const lane forward_t157 = forward_t131*t86;
    const lane f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry
        - forward_t157;
    const lane t87 = B_6_x*g_z - B_6_z*g_x;
    const lane forward_t158 = forward_t133*t87;
    const lane f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry
        - forward_t158;
    const lane t88 = -B_1_x*g_y + B_1_y*g_x;
    const lane forward_t159 = forward_t123*t88;
    const lane f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz
        - forward_t159;
    const lane t89 = -B_2_x*g_y + B_2_y*g_x;
    const lane forward_t160 = forward_t125*t89;
    const lane f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz
        - forward_t160;
    const lane t90 = -B_3_x*g_y + B_3_y*g_x;
    const lane forward_t161 = forward_t127*t90;
    const lane f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz
        - forward_t161;
    const lane t91 = -B_4_x*g_y + B_4_y*g_x;
    const lane forward_t162 = forward_t129*t91;
    const lane f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz
        - forward_t162;
    const lane t92 = -B_5_x*g_y + B_5_y*g_x;
    const lane forward_t163 = forward_t131*t92;
    const lane f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz
        - forward_t163;
    const lane t93 = -B_6_x*g_y + B_6_y*g_x;
    const lane forward_t164 = forward_t133*t93;
    const lane f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz
        - forward_t164;
    const lane M_p_x_x = m_p + m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6;
    const lane forward_t165 = B_1_z*m_perp_1;
    const lane forward_t166 = B_2_z*m_perp_2;
    const lane forward_t167 = B_3_z*m_perp_3;
    const lane forward_t168 = B_4_z*m_perp_4;
    const lane forward_t169 = B_5_z*m_perp_5;
    const lane forward_t170 = B_6_z*m_perp_6;
    const lane forward_t171 = c_z*m_p;
    const lane M_p_x_ry =
        forward_t165 + forward_t166 + forward_t167 + forward_t168 + forward_t169 + forward_t170
        + forward_t171;
    const lane forward_t172 = B_1_y*m_perp_1;
    const lane forward_t173 = B_2_y*m_perp_2;
    const lane forward_t174 = B_3_y*m_perp_3;
    const lane forward_t175 = B_4_y*m_perp_4;
    const lane forward_t176 = B_5_y*m_perp_5;
    const lane forward_t177 = B_6_y*m_perp_6;
    const lane forward_t178 = c_y*m_p;
    const lane M_p_z_rx =
        forward_t172 + forward_t173 + forward_t174 + forward_t175 + forward_t176 + forward_t177
        + forward_t178;
    const lane M_p_x_rz = -M_p_z_rx;
    const lane M_p_y_rx = -M_p_x_ry;
    const lane M_p_y_rz =
        B_1_x*m_perp_1 + B_2_x*m_perp_2 + B_3_x*m_perp_3 + B_4_x*m_perp_4 + B_5_x*m_perp_5 + B_6_x*m_perp_6
        + c_x*m_p;
    const lane M_p_z_ry = -M_p_y_rz;
    const lane forward_t179 = 2.0*(c_y*c_y);
    const lane forward_t180 = 2.0*(c_z*c_z);
    const double forward_t181 = (1.0/2.0)*m_p;
    const lane forward_t182 = 2.0*forward_t92;
    const lane forward_t183 = 2.0*forward_t95;
    const lane forward_t184 = (1.0/2.0)*m_perp_1;
    const lane forward_t185 = 2.0*forward_t93;
    const lane forward_t186 = 2.0*forward_t96;
    const lane forward_t187 = (1.0/2.0)*m_perp_2;
    const lane forward_t188 = 2.0*forward_t88;
    const lane forward_t189 = 2.0*forward_t97;
    const lane forward_t190 = (1.0/2.0)*m_perp_3;
    const lane forward_t191 = 2.0*forward_t89;
    const lane forward_t192 = 2.0*forward_t98;
    const lane forward_t193 = (1.0/2.0)*m_perp_4;
    const lane forward_t194 = 2.0*forward_t90;
    const lane forward_t195 = 2.0*forward_t99;
    const lane forward_t196 = (1.0/2.0)*m_perp_5;
    const lane forward_t197 = 2.0*forward_t91;
    const lane forward_t198 = 2.0*forward_t100;
    const lane forward_t199 = (1.0/2.0)*m_perp_6;
    const lane t94 = forward_t179 + forward_t180;
    const lane t95 = forward_t182 + forward_t183;
    const lane t96 = forward_t185 + forward_t186;
    const lane t97 = forward_t188 + forward_t189;
    const lane t98 = forward_t191 + forward_t192;
    const lane t99 = forward_t194 + forward_t195;
    const lane t100 = forward_t197 + forward_t198;
    const lane M_p_rx_rx =
        J_x_x + forward_t181*t94 + forward_t184*t95 + forward_t187*t96 + forward_t190*t97 + forward_t193*t98
        + forward_t196*t99 + forward_t199*t100;
    const lane M_p_rx_ry =
        -B_1_x*forward_t172 - B_2_x*forward_t173 - B_3_x*forward_t174 - B_4_x*forward_t175
        - B_5_x*forward_t176 - B_6_x*forward_t177 + J_x_y - c_x*forward_t178;
    const lane M_p_rx_rz =
        -B_1_x*forward_t165 - B_2_x*forward_t166 - B_3_x*forward_t167 - B_4_x*forward_t168
        - B_5_x*forward_t169 - B_6_x*forward_t170 + J_x_z - c_x*forward_t171;
    const lane forward_t200 = 2.0*(c_x*c_x);
    const lane forward_t201 = 2.0*forward_t116;
    const lane forward_t202 = 2.0*forward_t117;
    const lane forward_t203 = 2.0*forward_t118;
    const lane forward_t204 = 2.0*forward_t119;
    const lane forward_t205 = 2.0*forward_t120;
    const lane forward_t206 = 2.0*forward_t121;
    const lane t101 = forward_t180 + forward_t200;
    const lane t102 = forward_t183 + forward_t201;
    const lane t103 = forward_t186 + forward_t202;
    const lane t104 = forward_t189 + forward_t203;
    const lane t105 = forward_t192 + forward_t204;
    const lane t106 = forward_t195 + forward_t205;
    const lane t107 = forward_t198 + forward_t206;
    const lane M_p_ry_ry =
        J_y_y + forward_t181*t101 + forward_t184*t102 + forward_t187*t103 + forward_t190*t104
        + forward_t193*t105 + forward_t196*t106 + forward_t199*t107;
    const lane M_p_ry_rz =
        -B_1_y*forward_t165 - B_2_y*forward_t166 - B_3_y*forward_t167 - B_4_y*forward_t168
        - B_5_y*forward_t169 - B_6_y*forward_t170 + J_y_z - c_y*forward_t171;
    const lane t108 = forward_t179 + forward_t200;
    const lane t109 = forward_t182 + forward_t201;
    const lane t110 = forward_t185 + forward_t202;
    const lane t111 = forward_t188 + forward_t203;
    const lane t112 = forward_t191 + forward_t204;
    const lane t113 = forward_t194 + forward_t205;
    const lane t114 = forward_t197 + forward_t206;
    const lane M_p_rz_rz =
        J_z_z + forward_t181*t108 + forward_t184*t109 + forward_t187*t110 + forward_t190*t111
        + forward_t193*t112 + forward_t196*t113 + forward_t199*t114;
    const lane h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const lane h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const lane h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const lane h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const lane h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const lane h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const lane h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const lane h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const lane h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const lane h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const lane h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const lane h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const lane h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const lane h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const lane h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const lane h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const lane h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const lane h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
    const lane h_rx_l_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx;
    const lane h_rx_l_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx;
    const lane h_rx_l_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx;
    const lane h_rx_l_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx;
    const lane h_rx_l_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx;
    const lane h_rx_l_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx;
    const lane h_ry_l_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry;
    const lane h_ry_l_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry;
    const lane h_ry_l_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry;
    const lane h_ry_l_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry;
    const lane h_ry_l_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry;
    const lane h_ry_l_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry;
    const lane h_rz_l_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz;
    const lane h_rz_l_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz;
    const lane h_rz_l_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz;
    const lane h_rz_l_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz;
    const lane h_rz_l_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz;
    const lane h_rz_l_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz;
    const double forward_23 = 1.0/((h_m_1*h_m_1));
    const double forward_24 = 1.0/((h_m_2*h_m_2));
    const double forward_25 = 1.0/((h_m_3*h_m_3));
    const double forward_26 = 1.0/((h_m_4*h_m_4));
    const double forward_27 = 1.0/((h_m_5*h_m_5));
    const double forward_28 = 1.0/((h_m_6*h_m_6));
    const lane forward_29 = 1.0/((forward_4*forward_4*forward_4));
    const lane forward_30 = 1.0/((forward_5*forward_5*forward_5));
    const lane forward_31 = 1.0/((forward_6*forward_6*forward_6));
    const lane forward_32 = 1.0/((forward_7*forward_7*forward_7));
    const lane forward_33 = 1.0/((forward_8*forward_8*forward_8));
    const lane forward_34 = 1.0/((forward_9*forward_9*forward_9));
    const lane t438 = forward_t27 + forward_t28;
    const lane t442 = forward_t23 + forward_t25;
    const lane t444 = forward_t13 + forward_t15;
    const double t447 = 2.0*g_z;
    const lane t449 = 1.0/forward_9;
    const lane t452 = 1.0/forward_8;
    const lane t455 = 1.0/forward_7;
    const lane t459 = 1.0/forward_6;
    const lane t462 = 1.0/forward_5;
    const lane t466 = forward_t21 + t444;
    const lane t467 = forward_t12 + forward_t19 + forward_t20;
    const lane t468 = I_p_y*R_z_y;
    const lane t469 = forward_t16 + forward_t17 + forward_t18;
    const lane t472 = (1.0/2.0)*rot_x;
    const lane t484 = B_1_z*forward_t123;
    const lane t485 = B_2_z*forward_t125;
    const lane t486 = B_3_z*forward_t127;
    const lane t487 = B_4_z*forward_t129;
    const lane t488 = B_5_z*forward_t131;
    const lane t489 = B_6_z*forward_t133;
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
        const lane t115 = (shape_6*shape_6);
        const lane t116 = 2.0*t115*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z);
        const lane adjoint_forward_34 = forward_t47*t116;
        const lane t117 = (shape_5*shape_5);
        const lane t118 = 2.0*t117*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z);
        const lane adjoint_forward_33 = forward_t44*t118;
        const lane t119 = (shape_4*shape_4);
        const lane t120 = 2.0*t119*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z);
        const lane adjoint_forward_32 = forward_t41*t120;
        const lane t121 = (shape_3*shape_3);
        const lane t122 = 2.0*t121*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z);
        const lane adjoint_forward_31 = forward_t38*t122;
        const lane t123 = (shape_2*shape_2);
        const lane t124 = 2.0*t123*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z);
        const lane adjoint_forward_30 = forward_t35*t124;
        const lane t125 = (shape_1*shape_1);
        const lane t126 = 2.0*t125*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z);
        const lane adjoint_forward_29 = forward_t32*t126;
        const lane t127 = (shape_12*shape_12);
        const lane t128 = eigenvalue*t127;
        const lane adjoint_forward_28 = -I_m_6*t128;
        const lane t129 = (shape_11*shape_11);
        const lane t130 = eigenvalue*t129;
        const lane adjoint_forward_27 = -I_m_5*t130;
        const lane t131 = (shape_10*shape_10);
        const lane t132 = eigenvalue*t131;
        const lane adjoint_forward_26 = -I_m_4*t132;
        const lane t133 = (shape_9*shape_9);
        const lane t134 = eigenvalue*t133;
        const lane adjoint_forward_25 = -I_m_3*t134;
        const lane t135 = (shape_8*shape_8);
        const lane t136 = eigenvalue*t135;
        const lane adjoint_forward_24 = -I_m_2*t136;
        const lane t137 = (shape_7*shape_7);
        const lane t138 = eigenvalue*t137;
        const lane adjoint_forward_23 = -I_m_1*t138;
        const lane t139 = D_p_rz_6*t115;
        const lane t140 = 2.0*shape_1;
        const lane t141 = D_p_rz_1*t140;
        const lane t142 = shape_6*t141;
        const lane t143 = 2.0*shape_2;
        const lane t144 = D_p_rz_2*t143;
        const lane t145 = shape_6*t144;
        const lane t146 = 2.0*shape_3;
        const lane t147 = D_p_rz_3*t146;
        const lane t148 = shape_6*t147;
        const lane t149 = 2.0*shape_4;
        const lane t150 = D_p_rz_4*t149;
        const lane t151 = shape_6*t150;
        const lane t152 = 2.0*shape_5;
        const lane t153 = shape_6*t152;
        const lane t154 = D_p_rz_5*t153;
        const lane adjoint_h_rz_l_6 =
            -eigenvalue*t139 - eigenvalue*t142 - eigenvalue*t145 - eigenvalue*t148 - eigenvalue*t151
            - eigenvalue*t154;
        const lane t155 = D_p_rz_5*t117;
        const lane t156 = shape_5*t141;
        const lane t157 = shape_5*t144;
        const lane t158 = shape_5*t147;
        const lane t159 = shape_5*t150;
        const lane adjoint_h_rz_l_5 =
            -eigenvalue*t155 - eigenvalue*t156 - eigenvalue*t157 - eigenvalue*t158 - eigenvalue*t159;
        const lane t160 = D_p_rz_4*t119;
        const lane t161 = shape_4*t141;
        const lane t162 = shape_4*t144;
        const lane t163 = shape_4*t147;
        const lane adjoint_h_rz_l_4 = -eigenvalue*t160 - eigenvalue*t161 - eigenvalue*t162 - eigenvalue*t163;
        const lane t164 = D_p_rz_3*t121;
        const lane t165 = shape_3*t141;
        const lane t166 = shape_3*t144;
        const lane adjoint_h_rz_l_3 = -eigenvalue*t164 - eigenvalue*t165 - eigenvalue*t166;
        const lane t167 = D_p_rz_2*t123;
        const lane t168 = shape_2*t141;
        const lane adjoint_h_rz_l_2 = -eigenvalue*t167 - eigenvalue*t168;
        const lane adjoint_f_rz_l_1 = D_p_rz_1*t125;
        const lane adjoint_h_rz_l_1 = -adjoint_f_rz_l_1*eigenvalue;
        const lane t169 = D_p_ry_6*t115;
        const lane t170 = D_p_ry_1*t140;
        const lane t171 = shape_6*t170;
        const lane t172 = D_p_ry_2*t143;
        const lane t173 = shape_6*t172;
        const lane t174 = D_p_ry_3*t146;
        const lane t175 = shape_6*t174;
        const lane t176 = D_p_ry_4*t149;
        const lane t177 = shape_6*t176;
        const lane t178 = D_p_ry_5*t153;
        const lane adjoint_h_ry_l_6 =
            -eigenvalue*t169 - eigenvalue*t171 - eigenvalue*t173 - eigenvalue*t175 - eigenvalue*t177
            - eigenvalue*t178;
        const lane t179 = D_p_ry_5*t117;
        const lane t180 = shape_5*t170;
        const lane t181 = shape_5*t172;
        const lane t182 = shape_5*t174;
        const lane t183 = shape_5*t176;
        const lane adjoint_h_ry_l_5 =
            -eigenvalue*t179 - eigenvalue*t180 - eigenvalue*t181 - eigenvalue*t182 - eigenvalue*t183;
        const lane t184 = D_p_ry_4*t119;
        const lane t185 = shape_4*t170;
        const lane t186 = shape_4*t172;
        const lane t187 = shape_4*t174;
        const lane adjoint_h_ry_l_4 = -eigenvalue*t184 - eigenvalue*t185 - eigenvalue*t186 - eigenvalue*t187;
        const lane t188 = D_p_ry_3*t121;
        const lane t189 = shape_3*t170;
        const lane t190 = shape_3*t172;
        const lane adjoint_h_ry_l_3 = -eigenvalue*t188 - eigenvalue*t189 - eigenvalue*t190;
        const lane t191 = D_p_ry_2*t123;
        const lane t192 = shape_2*t140;
        const lane t193 = D_p_ry_1*t192;
        const lane adjoint_h_ry_l_2 = -eigenvalue*t191 - eigenvalue*t193;
        const lane adjoint_f_ry_l_1 = D_p_ry_1*t125;
        const lane adjoint_h_ry_l_1 = -adjoint_f_ry_l_1*eigenvalue;
        const lane t194 = D_p_rx_6*t115;
        const lane t195 = D_p_rx_1*t140;
        const lane t196 = shape_6*t195;
        const lane t197 = D_p_rx_2*t143;
        const lane t198 = shape_6*t197;
        const lane t199 = D_p_rx_3*t146;
        const lane t200 = shape_6*t199;
        const lane t201 = D_p_rx_4*t149;
        const lane t202 = shape_6*t201;
        const lane t203 = D_p_rx_5*t153;
        const lane adjoint_h_rx_l_6 =
            -eigenvalue*t194 - eigenvalue*t196 - eigenvalue*t198 - eigenvalue*t200 - eigenvalue*t202
            - eigenvalue*t203;
        const lane t204 = D_p_rx_5*t117;
        const lane t205 = shape_5*t195;
        const lane t206 = shape_5*t197;
        const lane t207 = shape_5*t199;
        const lane t208 = shape_5*t201;
        const lane adjoint_h_rx_l_5 =
            -eigenvalue*t204 - eigenvalue*t205 - eigenvalue*t206 - eigenvalue*t207 - eigenvalue*t208;
        const lane t209 = D_p_rx_4*t119;
        const lane t210 = shape_4*t195;
        const lane t211 = shape_4*t197;
        const lane t212 = shape_4*t199;
        const lane adjoint_h_rx_l_4 = -eigenvalue*t209 - eigenvalue*t210 - eigenvalue*t211 - eigenvalue*t212;
        const lane t213 = D_p_rx_3*t121;
        const lane t214 = shape_3*t195;
        const lane t215 = shape_3*t197;
        const lane adjoint_h_rx_l_3 = -eigenvalue*t213 - eigenvalue*t214 - eigenvalue*t215;
        const lane t216 = D_p_rx_2*t123;
        const lane t217 = D_p_rx_1*t192;
        const lane adjoint_h_rx_l_2 = -eigenvalue*t216 - eigenvalue*t217;
        const lane adjoint_f_rx_l_1 = D_p_rx_1*t125;
        const lane adjoint_h_rx_l_1 = -adjoint_f_rx_l_1*eigenvalue;
        const lane t218 = D_p_z_6*t115;
        const lane t219 = D_p_z_1*t140;
        const lane t220 = shape_6*t219;
        const lane t221 = D_p_z_2*t143;
        const lane t222 = shape_6*t221;
        const lane t223 = D_p_z_3*t146;
        const lane t224 = shape_6*t223;
        const lane t225 = D_p_z_4*t149;
        const lane t226 = shape_6*t225;
        const lane t227 = D_p_z_5*t153;
        const lane adjoint_h_z_l_6 =
            -eigenvalue*t218 - eigenvalue*t220 - eigenvalue*t222 - eigenvalue*t224 - eigenvalue*t226
            - eigenvalue*t227;
        const lane t228 = D_p_z_5*t117;
        const lane t229 = shape_5*t219;
        const lane t230 = shape_5*t221;
        const lane t231 = shape_5*t223;
        const lane t232 = shape_5*t225;
        const lane adjoint_h_z_l_5 =
            -eigenvalue*t228 - eigenvalue*t229 - eigenvalue*t230 - eigenvalue*t231 - eigenvalue*t232;
        const lane t233 = D_p_z_4*t119;
        const lane t234 = shape_4*t219;
        const lane t235 = shape_4*t221;
        const lane t236 = shape_4*t223;
        const lane adjoint_h_z_l_4 = -eigenvalue*t233 - eigenvalue*t234 - eigenvalue*t235 - eigenvalue*t236;
        const lane t237 = D_p_z_3*t121;
        const lane t238 = shape_3*t219;
        const lane t239 = shape_3*t221;
        const lane adjoint_h_z_l_3 = -eigenvalue*t237 - eigenvalue*t238 - eigenvalue*t239;
        const lane t240 = D_p_z_2*t123;
        const lane t241 = D_p_z_1*t192;
        const lane adjoint_h_z_l_2 = -eigenvalue*t240 - eigenvalue*t241;
        const lane adjoint_f_z_l_1 = D_p_z_1*t125;
        const lane adjoint_h_z_l_1 = -adjoint_f_z_l_1*eigenvalue;
        const lane t242 = D_p_y_6*t115;
        const lane t243 = D_p_y_1*t140;
        const lane t244 = shape_6*t243;
        const lane t245 = D_p_y_2*t143;
        const lane t246 = shape_6*t245;
        const lane t247 = D_p_y_3*t146;
        const lane t248 = shape_6*t247;
        const lane t249 = D_p_y_4*t149;
        const lane t250 = shape_6*t249;
        const lane t251 = D_p_y_5*t153;
        const lane adjoint_h_y_l_6 =
            -eigenvalue*t242 - eigenvalue*t244 - eigenvalue*t246 - eigenvalue*t248 - eigenvalue*t250
            - eigenvalue*t251;
        const lane t252 = D_p_y_5*t117;
        const lane t253 = shape_5*t243;
        const lane t254 = shape_5*t245;
        const lane t255 = shape_5*t247;
        const lane t256 = shape_5*t249;
        const lane adjoint_h_y_l_5 =
            -eigenvalue*t252 - eigenvalue*t253 - eigenvalue*t254 - eigenvalue*t255 - eigenvalue*t256;
        const lane t257 = D_p_y_4*t119;
        const lane t258 = shape_4*t243;
        const lane t259 = shape_4*t245;
        const lane t260 = shape_4*t247;
        const lane adjoint_h_y_l_4 = -eigenvalue*t257 - eigenvalue*t258 - eigenvalue*t259 - eigenvalue*t260;
        const lane t261 = D_p_y_3*t121;
        const lane t262 = shape_3*t243;
        const lane t263 = shape_3*t245;
        const lane adjoint_h_y_l_3 = -eigenvalue*t261 - eigenvalue*t262 - eigenvalue*t263;
        const lane t264 = D_p_y_2*t123;
        const lane t265 = D_p_y_1*t192;
        const lane adjoint_h_y_l_2 = -eigenvalue*t264 - eigenvalue*t265;
        const lane adjoint_f_y_l_1 = D_p_y_1*t125;
        const lane adjoint_h_y_l_1 = -adjoint_f_y_l_1*eigenvalue;
        const lane t266 = D_p_x_6*t115;
        const lane t267 = D_p_x_1*t140;
        const lane t268 = shape_6*t267;
        const lane t269 = D_p_x_2*t143;
        const lane t270 = shape_6*t269;
        const lane t271 = D_p_x_3*t146;
        const lane t272 = shape_6*t271;
        const lane t273 = D_p_x_4*t149;
        const lane t274 = shape_6*t273;
        const lane t275 = D_p_x_5*t153;
        const lane adjoint_h_x_l_6 =
            -eigenvalue*t266 - eigenvalue*t268 - eigenvalue*t270 - eigenvalue*t272 - eigenvalue*t274
            - eigenvalue*t275;
        const lane t276 = D_p_x_5*t117;
        const lane t277 = shape_5*t267;
        const lane t278 = shape_5*t269;
        const lane t279 = shape_5*t271;
        const lane t280 = shape_5*t273;
        const lane adjoint_h_x_l_5 =
            -eigenvalue*t276 - eigenvalue*t277 - eigenvalue*t278 - eigenvalue*t279 - eigenvalue*t280;
        const lane t281 = D_p_x_4*t119;
        const lane t282 = shape_4*t267;
        const lane t283 = shape_4*t269;
        const lane t284 = shape_4*t271;
        const lane adjoint_h_x_l_4 = -eigenvalue*t281 - eigenvalue*t282 - eigenvalue*t283 - eigenvalue*t284;
        const lane t285 = D_p_x_3*t121;
        const lane t286 = shape_3*t267;
        const lane t287 = shape_3*t269;
        const lane adjoint_h_x_l_3 = -eigenvalue*t285 - eigenvalue*t286 - eigenvalue*t287;
        const lane t288 = D_p_x_2*t123;
        const lane t289 = D_p_x_1*t192;
        const lane adjoint_h_x_l_2 = -eigenvalue*t288 - eigenvalue*t289;
        const lane adjoint_f_x_l_1 = D_p_x_1*t125;
        const lane adjoint_h_x_l_1 = -adjoint_f_x_l_1*eigenvalue;
        const lane adjoint_M_p_rz_rz =
            D_p_rz_1*adjoint_h_rz_l_1 + D_p_rz_2*adjoint_h_rz_l_2 + D_p_rz_3*adjoint_h_rz_l_3
            + D_p_rz_4*adjoint_h_rz_l_4 + D_p_rz_5*adjoint_h_rz_l_5 + D_p_rz_6*adjoint_h_rz_l_6;
        const lane adjoint_M_p_ry_rz =
            D_p_ry_1*adjoint_h_rz_l_1 + D_p_ry_2*adjoint_h_rz_l_2 + D_p_ry_3*adjoint_h_rz_l_3
            + D_p_ry_4*adjoint_h_rz_l_4 + D_p_ry_5*adjoint_h_rz_l_5 + D_p_ry_6*adjoint_h_rz_l_6
            + D_p_rz_1*adjoint_h_ry_l_1 + D_p_rz_2*adjoint_h_ry_l_2 + D_p_rz_3*adjoint_h_ry_l_3
            + D_p_rz_4*adjoint_h_ry_l_4 + D_p_rz_5*adjoint_h_ry_l_5 + D_p_rz_6*adjoint_h_ry_l_6;
        const lane adjoint_M_p_ry_ry =
            D_p_ry_1*adjoint_h_ry_l_1 + D_p_ry_2*adjoint_h_ry_l_2 + D_p_ry_3*adjoint_h_ry_l_3
            + D_p_ry_4*adjoint_h_ry_l_4 + D_p_ry_5*adjoint_h_ry_l_5 + D_p_ry_6*adjoint_h_ry_l_6;
        const lane t290 = adjoint_M_p_ry_ry*forward_t199;
        const lane t291 = adjoint_M_p_rz_rz*forward_t199;
        const lane adjoint_forward_t206 = t290 + t291;
        const lane t292 = adjoint_M_p_ry_ry*forward_t196;
        const lane t293 = adjoint_M_p_rz_rz*forward_t196;
        const lane adjoint_forward_t205 = t292 + t293;
        const lane t294 = adjoint_M_p_ry_ry*forward_t193;
        const lane t295 = adjoint_M_p_rz_rz*forward_t193;
        const lane adjoint_forward_t204 = t294 + t295;
        const lane t296 = adjoint_M_p_ry_ry*forward_t190;
        const lane t297 = adjoint_M_p_rz_rz*forward_t190;
        const lane adjoint_forward_t203 = t296 + t297;
        const lane t298 = adjoint_M_p_ry_ry*forward_t187;
        const lane t299 = adjoint_M_p_rz_rz*forward_t187;
        const lane adjoint_forward_t202 = t298 + t299;
        const lane t300 = adjoint_M_p_ry_ry*forward_t184;
        const lane t301 = adjoint_M_p_rz_rz*forward_t184;
        const lane adjoint_forward_t201 = t300 + t301;
        const lane t302 = adjoint_M_p_ry_ry*forward_t181;
        const lane t303 = adjoint_M_p_rz_rz*forward_t181;
        const lane adjoint_forward_t200 = t302 + t303;
        const lane adjoint_M_p_rx_rz =
            D_p_rx_1*adjoint_h_rz_l_1 + D_p_rx_2*adjoint_h_rz_l_2 + D_p_rx_3*adjoint_h_rz_l_3
            + D_p_rx_4*adjoint_h_rz_l_4 + D_p_rx_5*adjoint_h_rz_l_5 + D_p_rx_6*adjoint_h_rz_l_6
            + D_p_rz_1*adjoint_h_rx_l_1 + D_p_rz_2*adjoint_h_rx_l_2 + D_p_rz_3*adjoint_h_rx_l_3
            + D_p_rz_4*adjoint_h_rx_l_4 + D_p_rz_5*adjoint_h_rx_l_5 + D_p_rz_6*adjoint_h_rx_l_6;
        const lane adjoint_M_p_rx_ry =
            D_p_rx_1*adjoint_h_ry_l_1 + D_p_rx_2*adjoint_h_ry_l_2 + D_p_rx_3*adjoint_h_ry_l_3
            + D_p_rx_4*adjoint_h_ry_l_4 + D_p_rx_5*adjoint_h_ry_l_5 + D_p_rx_6*adjoint_h_ry_l_6
            + D_p_ry_1*adjoint_h_rx_l_1 + D_p_ry_2*adjoint_h_rx_l_2 + D_p_ry_3*adjoint_h_rx_l_3
            + D_p_ry_4*adjoint_h_rx_l_4 + D_p_ry_5*adjoint_h_rx_l_5 + D_p_ry_6*adjoint_h_rx_l_6;
        const lane adjoint_M_p_rx_rx =
            D_p_rx_1*adjoint_h_rx_l_1 + D_p_rx_2*adjoint_h_rx_l_2 + D_p_rx_3*adjoint_h_rx_l_3
            + D_p_rx_4*adjoint_h_rx_l_4 + D_p_rx_5*adjoint_h_rx_l_5 + D_p_rx_6*adjoint_h_rx_l_6;
        const lane adjoint_forward_t199 =
            adjoint_M_p_rx_rx*t100 + adjoint_M_p_ry_ry*t107 + adjoint_M_p_rz_rz*t114;
        const lane t304 = adjoint_M_p_rx_rx*forward_t199;
        const lane adjoint_forward_t198 = t290 + t304;
        const lane adjoint_forward_t197 = t291 + t304;
        const lane adjoint_forward_t196 =
            adjoint_M_p_rx_rx*t99 + adjoint_M_p_ry_ry*t106 + adjoint_M_p_rz_rz*t113;
        const lane t305 = adjoint_M_p_rx_rx*forward_t196;
        const lane adjoint_forward_t195 = t292 + t305;
        const lane adjoint_forward_t194 = t293 + t305;
        const lane adjoint_forward_t193 =
            adjoint_M_p_rx_rx*t98 + adjoint_M_p_ry_ry*t105 + adjoint_M_p_rz_rz*t112;
        const lane t306 = adjoint_M_p_rx_rx*forward_t193;
        const lane adjoint_forward_t192 = t294 + t306;
        const lane adjoint_forward_t191 = t295 + t306;
        const lane adjoint_forward_t190 =
            adjoint_M_p_rx_rx*t97 + adjoint_M_p_ry_ry*t104 + adjoint_M_p_rz_rz*t111;
        const lane t307 = adjoint_M_p_rx_rx*forward_t190;
        const lane adjoint_forward_t189 = t296 + t307;
        const lane adjoint_forward_t188 = t297 + t307;
        const lane adjoint_forward_t187 =
            adjoint_M_p_rx_rx*t96 + adjoint_M_p_ry_ry*t103 + adjoint_M_p_rz_rz*t110;
        const lane t308 = adjoint_M_p_rx_rx*forward_t187;
        const lane adjoint_forward_t186 = t298 + t308;
        const lane adjoint_forward_t185 = t299 + t308;
        const lane adjoint_forward_t184 =
            adjoint_M_p_rx_rx*t95 + adjoint_M_p_ry_ry*t102 + adjoint_M_p_rz_rz*t109;
        const lane t309 = adjoint_M_p_rx_rx*forward_t184;
        const lane adjoint_forward_t183 = t300 + t309;
        const lane adjoint_forward_t182 = t301 + t309;
        const lane adjoint_forward_t181 =
            adjoint_M_p_rx_rx*t94 + adjoint_M_p_ry_ry*t101 + adjoint_M_p_rz_rz*t108;
        const lane t310 = adjoint_M_p_rx_rx*forward_t181;
        const lane adjoint_forward_t180 = t302 + t310;
        const lane adjoint_forward_t179 = t303 + t310;
        const lane adjoint_M_p_z_ry =
            D_p_ry_1*adjoint_h_z_l_1 + D_p_ry_2*adjoint_h_z_l_2 + D_p_ry_3*adjoint_h_z_l_3
            + D_p_ry_4*adjoint_h_z_l_4 + D_p_ry_5*adjoint_h_z_l_5 + D_p_ry_6*adjoint_h_z_l_6
            + D_p_z_1*adjoint_h_ry_l_1 + D_p_z_2*adjoint_h_ry_l_2 + D_p_z_3*adjoint_h_ry_l_3
            + D_p_z_4*adjoint_h_ry_l_4 + D_p_z_5*adjoint_h_ry_l_5 + D_p_z_6*adjoint_h_ry_l_6;
        const lane adjoint_M_p_y_rz =
            D_p_rz_1*adjoint_h_y_l_1 + D_p_rz_2*adjoint_h_y_l_2 + D_p_rz_3*adjoint_h_y_l_3
            + D_p_rz_4*adjoint_h_y_l_4 + D_p_rz_5*adjoint_h_y_l_5 + D_p_rz_6*adjoint_h_y_l_6
            + D_p_y_1*adjoint_h_rz_l_1 + D_p_y_2*adjoint_h_rz_l_2 + D_p_y_3*adjoint_h_rz_l_3
            + D_p_y_4*adjoint_h_rz_l_4 + D_p_y_5*adjoint_h_rz_l_5 + D_p_y_6*adjoint_h_rz_l_6
            - adjoint_M_p_z_ry;
        const lane adjoint_M_p_y_rx =
            D_p_rx_1*adjoint_h_y_l_1 + D_p_rx_2*adjoint_h_y_l_2 + D_p_rx_3*adjoint_h_y_l_3
            + D_p_rx_4*adjoint_h_y_l_4 + D_p_rx_5*adjoint_h_y_l_5 + D_p_rx_6*adjoint_h_y_l_6
            + D_p_y_1*adjoint_h_rx_l_1 + D_p_y_2*adjoint_h_rx_l_2 + D_p_y_3*adjoint_h_rx_l_3
            + D_p_y_4*adjoint_h_rx_l_4 + D_p_y_5*adjoint_h_rx_l_5 + D_p_y_6*adjoint_h_rx_l_6;
        const lane adjoint_M_p_x_rz =
            D_p_rz_1*adjoint_h_x_l_1 + D_p_rz_2*adjoint_h_x_l_2 + D_p_rz_3*adjoint_h_x_l_3
            + D_p_rz_4*adjoint_h_x_l_4 + D_p_rz_5*adjoint_h_x_l_5 + D_p_rz_6*adjoint_h_x_l_6
            + D_p_x_1*adjoint_h_rz_l_1 + D_p_x_2*adjoint_h_rz_l_2 + D_p_x_3*adjoint_h_rz_l_3
            + D_p_x_4*adjoint_h_rz_l_4 + D_p_x_5*adjoint_h_rz_l_5 + D_p_x_6*adjoint_h_rz_l_6;
        const lane adjoint_M_p_z_rx =
            D_p_rx_1*adjoint_h_z_l_1 + D_p_rx_2*adjoint_h_z_l_2 + D_p_rx_3*adjoint_h_z_l_3
            + D_p_rx_4*adjoint_h_z_l_4 + D_p_rx_5*adjoint_h_z_l_5 + D_p_rx_6*adjoint_h_z_l_6
            + D_p_z_1*adjoint_h_rx_l_1 + D_p_z_2*adjoint_h_rx_l_2 + D_p_z_3*adjoint_h_rx_l_3
            + D_p_z_4*adjoint_h_rx_l_4 + D_p_z_5*adjoint_h_rx_l_5 + D_p_z_6*adjoint_h_rx_l_6
            - adjoint_M_p_x_rz;
        const lane adjoint_forward_t178 = -adjoint_M_p_rx_ry*c_x + adjoint_M_p_z_rx;
        const lane adjoint_forward_t177 = -B_6_x*adjoint_M_p_rx_ry + adjoint_M_p_z_rx;
        const lane adjoint_forward_t176 = -B_5_x*adjoint_M_p_rx_ry + adjoint_M_p_z_rx;
        const lane adjoint_forward_t175 = -B_4_x*adjoint_M_p_rx_ry + adjoint_M_p_z_rx;
        const lane adjoint_forward_t174 = -B_3_x*adjoint_M_p_rx_ry + adjoint_M_p_z_rx;
        const lane adjoint_forward_t173 = -B_2_x*adjoint_M_p_rx_ry + adjoint_M_p_z_rx;
        const lane adjoint_forward_t172 = -B_1_x*adjoint_M_p_rx_ry + adjoint_M_p_z_rx;
        const lane adjoint_M_p_x_ry =
            D_p_ry_1*adjoint_h_x_l_1 + D_p_ry_2*adjoint_h_x_l_2 + D_p_ry_3*adjoint_h_x_l_3
            + D_p_ry_4*adjoint_h_x_l_4 + D_p_ry_5*adjoint_h_x_l_5 + D_p_ry_6*adjoint_h_x_l_6
            + D_p_x_1*adjoint_h_ry_l_1 + D_p_x_2*adjoint_h_ry_l_2 + D_p_x_3*adjoint_h_ry_l_3
            + D_p_x_4*adjoint_h_ry_l_4 + D_p_x_5*adjoint_h_ry_l_5 + D_p_x_6*adjoint_h_ry_l_6
            - adjoint_M_p_y_rx;
        const lane adjoint_forward_t171 = -adjoint_M_p_rx_rz*c_x - adjoint_M_p_ry_rz*c_y + adjoint_M_p_x_ry;
        const lane adjoint_forward_t170 =
            -B_6_x*adjoint_M_p_rx_rz - B_6_y*adjoint_M_p_ry_rz + adjoint_M_p_x_ry;
        const lane adjoint_forward_t169 =
            -B_5_x*adjoint_M_p_rx_rz - B_5_y*adjoint_M_p_ry_rz + adjoint_M_p_x_ry;
        const lane adjoint_forward_t168 =
            -B_4_x*adjoint_M_p_rx_rz - B_4_y*adjoint_M_p_ry_rz + adjoint_M_p_x_ry;
        const lane adjoint_forward_t167 =
            -B_3_x*adjoint_M_p_rx_rz - B_3_y*adjoint_M_p_ry_rz + adjoint_M_p_x_ry;
        const lane adjoint_forward_t166 =
            -B_2_x*adjoint_M_p_rx_rz - B_2_y*adjoint_M_p_ry_rz + adjoint_M_p_x_ry;
        const lane adjoint_forward_t165 =
            -B_1_x*adjoint_M_p_rx_rz - B_1_y*adjoint_M_p_ry_rz + adjoint_M_p_x_ry;
        const lane adjoint_M_p_x_x =
            D_p_x_1*adjoint_h_x_l_1 + D_p_x_2*adjoint_h_x_l_2 + D_p_x_3*adjoint_h_x_l_3
            + D_p_x_4*adjoint_h_x_l_4 + D_p_x_5*adjoint_h_x_l_5 + D_p_x_6*adjoint_h_x_l_6
            + D_p_y_1*adjoint_h_y_l_1 + D_p_y_2*adjoint_h_y_l_2 + D_p_y_3*adjoint_h_y_l_3
            + D_p_y_4*adjoint_h_y_l_4 + D_p_y_5*adjoint_h_y_l_5 + D_p_y_6*adjoint_h_y_l_6
            + D_p_z_1*adjoint_h_z_l_1 + D_p_z_2*adjoint_h_z_l_2 + D_p_z_3*adjoint_h_z_l_3
            + D_p_z_4*adjoint_h_z_l_4 + D_p_z_5*adjoint_h_z_l_5 + D_p_z_6*adjoint_h_z_l_6;
        const lane adjoint_f_rz_l_6 = t139 + t142 + t145 + t148 + t151 + t154;
        const lane adjoint_forward_t164 = -adjoint_f_rz_l_6 - t139;
        const lane adjoint_f_rz_l_5 = t155 + t156 + t157 + t158 + t159;
        const lane adjoint_forward_t163 = -D_p_rz_6*t153 - adjoint_f_rz_l_5 - t155;
        const lane adjoint_f_rz_l_4 = t160 + t161 + t162 + t163;
        const lane t311 = D_p_rz_5*shape_5;
        const lane t312 = D_p_rz_6*shape_6;
        const lane adjoint_forward_t162 = -adjoint_f_rz_l_4 - t149*t311 - t149*t312 - t160;
        const lane adjoint_f_rz_l_3 = t164 + t165 + t166;
        const lane t313 = D_p_rz_4*shape_4;
        const lane adjoint_forward_t161 = -adjoint_f_rz_l_3 - t146*t311 - t146*t312 - t146*t313 - t164;
        const lane adjoint_f_rz_l_2 = t167 + t168;
        const lane t314 = D_p_rz_3*shape_3;
        const lane adjoint_forward_t160 =
            -adjoint_f_rz_l_2 - t143*t311 - t143*t312 - t143*t313 - t143*t314 - t167;
        const lane adjoint_forward_t159 =
            -D_p_rz_2*t192 - 2.0*adjoint_f_rz_l_1 - t140*t311 - t140*t312 - t140*t313 - t140*t314;
        const lane adjoint_f_ry_l_6 = t169 + t171 + t173 + t175 + t177 + t178;
        const lane adjoint_forward_t158 = -adjoint_f_ry_l_6 - t169;
        const lane adjoint_f_ry_l_5 = t179 + t180 + t181 + t182 + t183;
        const lane adjoint_forward_t157 = -D_p_ry_6*t153 - adjoint_f_ry_l_5 - t179;
        const lane adjoint_f_ry_l_4 = t184 + t185 + t186 + t187;
        const lane t315 = D_p_ry_5*shape_5;
        const lane t316 = D_p_ry_6*shape_6;
        const lane adjoint_forward_t156 = -adjoint_f_ry_l_4 - t149*t315 - t149*t316 - t184;
        const lane adjoint_f_ry_l_3 = t188 + t189 + t190;
        const lane t317 = D_p_ry_4*shape_4;
        const lane adjoint_forward_t155 = -adjoint_f_ry_l_3 - t146*t315 - t146*t316 - t146*t317 - t188;
        const lane adjoint_f_ry_l_2 = t191 + t193;
        const lane t318 = D_p_ry_3*shape_3;
        const lane adjoint_forward_t154 =
            -adjoint_f_ry_l_2 - t143*t315 - t143*t316 - t143*t317 - t143*t318 - t191;
        const lane adjoint_forward_t153 =
            -D_p_ry_2*t192 - 2.0*adjoint_f_ry_l_1 - t140*t315 - t140*t316 - t140*t317 - t140*t318;
        const lane adjoint_f_rx_l_6 = t194 + t196 + t198 + t200 + t202 + t203;
        const lane adjoint_forward_t152 = -adjoint_f_rx_l_6 - t194;
        const lane adjoint_f_rx_l_5 = t204 + t205 + t206 + t207 + t208;
        const lane adjoint_forward_t151 = -D_p_rx_6*t153 - adjoint_f_rx_l_5 - t204;
        const lane adjoint_f_rx_l_4 = t209 + t210 + t211 + t212;
        const lane t319 = D_p_rx_5*shape_5;
        const lane t320 = D_p_rx_6*shape_6;
        const lane adjoint_forward_t150 = -adjoint_f_rx_l_4 - t149*t319 - t149*t320 - t209;
        const lane adjoint_f_rx_l_3 = t213 + t214 + t215;
        const lane t321 = D_p_rx_4*shape_4;
        const lane adjoint_forward_t149 = -adjoint_f_rx_l_3 - t146*t319 - t146*t320 - t146*t321 - t213;
        const lane adjoint_f_rx_l_2 = t216 + t217;
        const lane t322 = D_p_rx_3*shape_3;
        const lane adjoint_forward_t148 =
            -adjoint_f_rx_l_2 - t143*t319 - t143*t320 - t143*t321 - t143*t322 - t216;
        const lane adjoint_forward_t147 =
            -D_p_rx_2*t192 - 2.0*adjoint_f_rx_l_1 - t140*t319 - t140*t320 - t140*t321 - t140*t322;
        const lane adjoint_f_z_l_6 = t218 + t220 + t222 + t224 + t226 + t227;
        const lane adjoint_forward_t146 = adjoint_f_z_l_6 + t218;
        const lane adjoint_f_z_l_5 = t228 + t229 + t230 + t231 + t232;
        const lane adjoint_forward_t145 = D_p_z_6*t153 + adjoint_f_z_l_5 + t228;
        const lane adjoint_f_z_l_4 = t233 + t234 + t235 + t236;
        const lane t323 = D_p_z_5*shape_5;
        const lane t324 = D_p_z_6*shape_6;
        const lane adjoint_forward_t144 = adjoint_f_z_l_4 + t149*t323 + t149*t324 + t233;
        const lane adjoint_f_z_l_3 = t237 + t238 + t239;
        const lane t325 = D_p_z_4*shape_4;
        const lane adjoint_forward_t143 = adjoint_f_z_l_3 + t146*t323 + t146*t324 + t146*t325 + t237;
        const lane adjoint_f_z_l_2 = t240 + t241;
        const lane t326 = D_p_z_3*shape_3;
        const lane adjoint_forward_t142 =
            adjoint_f_z_l_2 + t143*t323 + t143*t324 + t143*t325 + t143*t326 + t240;
        const lane adjoint_forward_t141 =
            D_p_z_2*t192 + 2.0*adjoint_f_z_l_1 + t140*t323 + t140*t324 + t140*t325 + t140*t326;
        const lane adjoint_f_y_l_6 = t242 + t244 + t246 + t248 + t250 + t251;
        const lane adjoint_forward_t140 = adjoint_f_y_l_6 + t242;
        const lane adjoint_f_y_l_5 = t252 + t253 + t254 + t255 + t256;
        const lane adjoint_forward_t139 = D_p_y_6*t153 + adjoint_f_y_l_5 + t252;
        const lane adjoint_f_y_l_4 = t257 + t258 + t259 + t260;
        const lane t327 = D_p_y_5*shape_5;
        const lane t328 = D_p_y_6*shape_6;
        const lane adjoint_forward_t138 = adjoint_f_y_l_4 + t149*t327 + t149*t328 + t257;
        const lane adjoint_f_y_l_3 = t261 + t262 + t263;
        const lane t329 = D_p_y_4*shape_4;
        const lane adjoint_forward_t137 = adjoint_f_y_l_3 + t146*t327 + t146*t328 + t146*t329 + t261;
        const lane adjoint_f_y_l_2 = t264 + t265;
        const lane t330 = D_p_y_3*shape_3;
        const lane adjoint_forward_t136 =
            adjoint_f_y_l_2 + t143*t327 + t143*t328 + t143*t329 + t143*t330 + t264;
        const lane adjoint_forward_t135 =
            D_p_y_2*t192 + 2.0*adjoint_f_y_l_1 + t140*t327 + t140*t328 + t140*t329 + t140*t330;
        const lane adjoint_f_x_l_6 = t266 + t268 + t270 + t272 + t274 + t275;
        const lane adjoint_forward_t134 = adjoint_f_x_l_6 + t266;
        const lane adjoint_forward_t133 =
            adjoint_forward_t134*g_x + adjoint_forward_t140*g_y + adjoint_forward_t146*g_z
            + adjoint_forward_t152*t81 + adjoint_forward_t158*t87 + adjoint_forward_t164*t93;
        const lane adjoint_f_x_l_5 = t276 + t277 + t278 + t279 + t280;
        const lane adjoint_forward_t132 = D_p_x_6*t153 + adjoint_f_x_l_5 + t276;
        const lane adjoint_forward_t131 =
            adjoint_forward_t132*g_x + adjoint_forward_t139*g_y + adjoint_forward_t145*g_z
            + adjoint_forward_t151*t80 + adjoint_forward_t157*t86 + adjoint_forward_t163*t92;
        const lane adjoint_f_x_l_4 = t281 + t282 + t283 + t284;
        const lane t331 = D_p_x_5*shape_5;
        const lane t332 = D_p_x_6*shape_6;
        const lane adjoint_forward_t130 = adjoint_f_x_l_4 + t149*t331 + t149*t332 + t281;
        const lane adjoint_forward_t129 =
            adjoint_forward_t130*g_x + adjoint_forward_t138*g_y + adjoint_forward_t144*g_z
            + adjoint_forward_t150*t79 + adjoint_forward_t156*t85 + adjoint_forward_t162*t91;
        const lane adjoint_f_x_l_3 = t285 + t286 + t287;
        const lane t333 = D_p_x_4*shape_4;
        const lane adjoint_forward_t128 = adjoint_f_x_l_3 + t146*t331 + t146*t332 + t146*t333 + t285;
        const lane adjoint_forward_t127 =
            adjoint_forward_t128*g_x + adjoint_forward_t137*g_y + adjoint_forward_t143*g_z
            + adjoint_forward_t149*t78 + adjoint_forward_t155*t84 + adjoint_forward_t161*t90;
        const lane adjoint_f_x_l_2 = t288 + t289;
        const lane t334 = D_p_x_3*shape_3;
        const lane adjoint_forward_t126 =
            adjoint_f_x_l_2 + t143*t331 + t143*t332 + t143*t333 + t143*t334 + t288;
        const lane adjoint_forward_t125 =
            adjoint_forward_t126*g_x + adjoint_forward_t136*g_y + adjoint_forward_t142*g_z
            + adjoint_forward_t148*t77 + adjoint_forward_t154*t83 + adjoint_forward_t160*t89;
        const lane adjoint_forward_t124 =
            D_p_x_2*t192 + 2.0*adjoint_f_x_l_1 + t140*t331 + t140*t332 + t140*t333 + t140*t334;
        const lane adjoint_forward_t123 =
            adjoint_forward_t124*g_x + adjoint_forward_t135*g_y + adjoint_forward_t141*g_z
            + adjoint_forward_t147*t76 + adjoint_forward_t153*t82 + adjoint_forward_t159*t88;
        const lane adjoint_L_rz_rz =
            D_p_rz_1*adjoint_f_rz_l_1 + D_p_rz_2*adjoint_f_rz_l_2 + D_p_rz_3*adjoint_f_rz_l_3
            + D_p_rz_4*adjoint_f_rz_l_4 + D_p_rz_5*adjoint_f_rz_l_5 + D_p_rz_6*adjoint_f_rz_l_6;
        const lane adjoint_L_ry_rz =
            D_p_ry_1*adjoint_f_rz_l_1 + D_p_ry_2*adjoint_f_rz_l_2 + D_p_ry_3*adjoint_f_rz_l_3
            + D_p_ry_4*adjoint_f_rz_l_4 + D_p_ry_5*adjoint_f_rz_l_5 + D_p_ry_6*adjoint_f_rz_l_6
            + D_p_rz_1*adjoint_f_ry_l_1 + D_p_rz_2*adjoint_f_ry_l_2 + D_p_rz_3*adjoint_f_ry_l_3
            + D_p_rz_4*adjoint_f_ry_l_4 + D_p_rz_5*adjoint_f_ry_l_5 + D_p_rz_6*adjoint_f_ry_l_6;
        const lane adjoint_L_ry_ry =
            D_p_ry_1*adjoint_f_ry_l_1 + D_p_ry_2*adjoint_f_ry_l_2 + D_p_ry_3*adjoint_f_ry_l_3
            + D_p_ry_4*adjoint_f_ry_l_4 + D_p_ry_5*adjoint_f_ry_l_5 + D_p_ry_6*adjoint_f_ry_l_6;
        const lane adjoint_forward_t122 = -adjoint_L_ry_ry - adjoint_L_rz_rz;
        const lane adjoint_forward_t121 = adjoint_forward_t122*mu_6 + 2.0*adjoint_forward_t206;
        const lane adjoint_forward_t120 = adjoint_forward_t122*mu_5 + 2.0*adjoint_forward_t205;
        const lane adjoint_forward_t119 = adjoint_forward_t122*mu_4 + 2.0*adjoint_forward_t204;
        const lane adjoint_forward_t118 = adjoint_forward_t122*mu_3 + 2.0*adjoint_forward_t203;
        const lane adjoint_forward_t117 = adjoint_forward_t122*mu_2 + 2.0*adjoint_forward_t202;
        const lane adjoint_forward_t116 = adjoint_forward_t122*mu_1 + 2.0*adjoint_forward_t201;
        const lane adjoint_L_rx_rz =
            D_p_rx_1*adjoint_f_rz_l_1 + D_p_rx_2*adjoint_f_rz_l_2 + D_p_rx_3*adjoint_f_rz_l_3
            + D_p_rx_4*adjoint_f_rz_l_4 + D_p_rx_5*adjoint_f_rz_l_5 + D_p_rx_6*adjoint_f_rz_l_6
            + D_p_rz_1*adjoint_f_rx_l_1 + D_p_rz_2*adjoint_f_rx_l_2 + D_p_rz_3*adjoint_f_rx_l_3
            + D_p_rz_4*adjoint_f_rx_l_4 + D_p_rz_5*adjoint_f_rx_l_5 + D_p_rz_6*adjoint_f_rx_l_6;
        const lane adjoint_L_rx_ry =
            D_p_rx_1*adjoint_f_ry_l_1 + D_p_rx_2*adjoint_f_ry_l_2 + D_p_rx_3*adjoint_f_ry_l_3
            + D_p_rx_4*adjoint_f_ry_l_4 + D_p_rx_5*adjoint_f_ry_l_5 + D_p_rx_6*adjoint_f_ry_l_6
            + D_p_ry_1*adjoint_f_rx_l_1 + D_p_ry_2*adjoint_f_rx_l_2 + D_p_ry_3*adjoint_f_rx_l_3
            + D_p_ry_4*adjoint_f_rx_l_4 + D_p_ry_5*adjoint_f_rx_l_5 + D_p_ry_6*adjoint_f_rx_l_6;
        const lane adjoint_forward_t115 = adjoint_L_rx_ry*c_y + adjoint_L_rx_rz*c_z;
        const lane adjoint_forward_t114 = adjoint_L_rx_ry*g_10_y + adjoint_L_rx_rz*g_10_z;
        const lane adjoint_forward_t113 = B_6_y*adjoint_L_rx_ry + B_6_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t112 = adjoint_L_rx_ry*g_9_y + adjoint_L_rx_rz*g_9_z;
        const lane adjoint_forward_t111 = B_5_y*adjoint_L_rx_ry + B_5_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t110 = adjoint_L_rx_ry*g_8_y + adjoint_L_rx_rz*g_8_z;
        const lane adjoint_forward_t109 = B_4_y*adjoint_L_rx_ry + B_4_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t108 = adjoint_L_rx_ry*g_7_y + adjoint_L_rx_rz*g_7_z;
        const lane adjoint_forward_t107 = B_3_y*adjoint_L_rx_ry + B_3_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t106 = adjoint_L_rx_ry*g_6_y + adjoint_L_rx_rz*g_6_z;
        const lane adjoint_forward_t105 = B_2_y*adjoint_L_rx_ry + B_2_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t104 = adjoint_L_rx_ry*g_5_y + adjoint_L_rx_rz*g_5_z;
        const lane adjoint_forward_t103 = B_1_y*adjoint_L_rx_ry + B_1_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t102 = adjoint_L_rx_ry*g_4_y + adjoint_L_rx_rz*g_4_z;
        const lane adjoint_L_rx_rx =
            D_p_rx_1*adjoint_f_rx_l_1 + D_p_rx_2*adjoint_f_rx_l_2 + D_p_rx_3*adjoint_f_rx_l_3
            + D_p_rx_4*adjoint_f_rx_l_4 + D_p_rx_5*adjoint_f_rx_l_5 + D_p_rx_6*adjoint_f_rx_l_6;
        const lane adjoint_forward_t101 = -adjoint_L_rx_rx - adjoint_L_ry_ry;
        const lane adjoint_forward_t100 = adjoint_forward_t101*mu_6 + 2.0*adjoint_forward_t198;
        const lane adjoint_forward_t99 = adjoint_forward_t101*mu_5 + 2.0*adjoint_forward_t195;
        const lane adjoint_forward_t98 = adjoint_forward_t101*mu_4 + 2.0*adjoint_forward_t192;
        const lane adjoint_forward_t97 = adjoint_forward_t101*mu_3 + 2.0*adjoint_forward_t189;
        const lane adjoint_forward_t96 = adjoint_forward_t101*mu_2 + 2.0*adjoint_forward_t186;
        const lane adjoint_forward_t95 = adjoint_forward_t101*mu_1 + 2.0*adjoint_forward_t183;
        const lane adjoint_forward_t94 = -adjoint_L_rx_rx - adjoint_L_rz_rz;
        const lane adjoint_forward_t93 = 2.0*adjoint_forward_t185 + adjoint_forward_t94*mu_2;
        const lane adjoint_forward_t92 = 2.0*adjoint_forward_t182 + adjoint_forward_t94*mu_1;
        const lane adjoint_forward_t91 = 2.0*adjoint_forward_t197 + adjoint_forward_t94*mu_6;
        const lane adjoint_forward_t90 = 2.0*adjoint_forward_t194 + adjoint_forward_t94*mu_5;
        const lane adjoint_forward_t89 = 2.0*adjoint_forward_t191 + adjoint_forward_t94*mu_4;
        const lane adjoint_forward_t88 = 2.0*adjoint_forward_t188 + adjoint_forward_t94*mu_3;
        const lane adjoint_L_z_rx =
            D_p_rx_1*adjoint_f_z_l_1 + D_p_rx_2*adjoint_f_z_l_2 + D_p_rx_3*adjoint_f_z_l_3
            + D_p_rx_4*adjoint_f_z_l_4 + D_p_rx_5*adjoint_f_z_l_5 + D_p_rx_6*adjoint_f_z_l_6
            + D_p_z_1*adjoint_f_rx_l_1 + D_p_z_2*adjoint_f_rx_l_2 + D_p_z_3*adjoint_f_rx_l_3
            + D_p_z_4*adjoint_f_rx_l_4 + D_p_z_5*adjoint_f_rx_l_5 + D_p_z_6*adjoint_f_rx_l_6;
        const lane adjoint_L_y_rz =
            D_p_rz_1*adjoint_f_y_l_1 + D_p_rz_2*adjoint_f_y_l_2 + D_p_rz_3*adjoint_f_y_l_3
            + D_p_rz_4*adjoint_f_y_l_4 + D_p_rz_5*adjoint_f_y_l_5 + D_p_rz_6*adjoint_f_y_l_6
            + D_p_y_1*adjoint_f_rz_l_1 + D_p_y_2*adjoint_f_rz_l_2 + D_p_y_3*adjoint_f_rz_l_3
            + D_p_y_4*adjoint_f_rz_l_4 + D_p_y_5*adjoint_f_rz_l_5 + D_p_y_6*adjoint_f_rz_l_6;
        const lane adjoint_L_z_ry =
            D_p_ry_1*adjoint_f_z_l_1 + D_p_ry_2*adjoint_f_z_l_2 + D_p_ry_3*adjoint_f_z_l_3
            + D_p_ry_4*adjoint_f_z_l_4 + D_p_ry_5*adjoint_f_z_l_5 + D_p_ry_6*adjoint_f_z_l_6
            + D_p_z_1*adjoint_f_ry_l_1 + D_p_z_2*adjoint_f_ry_l_2 + D_p_z_3*adjoint_f_ry_l_3
            + D_p_z_4*adjoint_f_ry_l_4 + D_p_z_5*adjoint_f_ry_l_5 + D_p_z_6*adjoint_f_ry_l_6 - adjoint_L_y_rz;
        const lane adjoint_L_x_rz =
            D_p_rz_1*adjoint_f_x_l_1 + D_p_rz_2*adjoint_f_x_l_2 + D_p_rz_3*adjoint_f_x_l_3
            + D_p_rz_4*adjoint_f_x_l_4 + D_p_rz_5*adjoint_f_x_l_5 + D_p_rz_6*adjoint_f_x_l_6
            + D_p_x_1*adjoint_f_rz_l_1 + D_p_x_2*adjoint_f_rz_l_2 + D_p_x_3*adjoint_f_rz_l_3
            + D_p_x_4*adjoint_f_rz_l_4 + D_p_x_5*adjoint_f_rz_l_5 + D_p_x_6*adjoint_f_rz_l_6 - adjoint_L_z_rx;
        const lane adjoint_forward_t87 = B_6_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t86 = B_5_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t85 = B_4_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t84 = B_3_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t83 = B_2_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t82 = B_1_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_L_x_ry =
            D_p_ry_1*adjoint_f_x_l_1 + D_p_ry_2*adjoint_f_x_l_2 + D_p_ry_3*adjoint_f_x_l_3
            + D_p_ry_4*adjoint_f_x_l_4 + D_p_ry_5*adjoint_f_x_l_5 + D_p_ry_6*adjoint_f_x_l_6
            + D_p_x_1*adjoint_f_ry_l_1 + D_p_x_2*adjoint_f_ry_l_2 + D_p_x_3*adjoint_f_ry_l_3
            + D_p_x_4*adjoint_f_ry_l_4 + D_p_x_5*adjoint_f_ry_l_5 + D_p_x_6*adjoint_f_ry_l_6;
        const lane adjoint_L_y_rx =
            D_p_rx_1*adjoint_f_y_l_1 + D_p_rx_2*adjoint_f_y_l_2 + D_p_rx_3*adjoint_f_y_l_3
            + D_p_rx_4*adjoint_f_y_l_4 + D_p_rx_5*adjoint_f_y_l_5 + D_p_rx_6*adjoint_f_y_l_6
            + D_p_y_1*adjoint_f_rx_l_1 + D_p_y_2*adjoint_f_rx_l_2 + D_p_y_3*adjoint_f_rx_l_3
            + D_p_y_4*adjoint_f_rx_l_4 + D_p_y_5*adjoint_f_rx_l_5 + D_p_y_6*adjoint_f_rx_l_6 - adjoint_L_x_ry;
        const lane t335 = B_6_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t81 = B_6_x*adjoint_L_rx_rz + adjoint_L_y_rx + t335;
        const lane t336 = B_5_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t80 = B_5_x*adjoint_L_rx_rz + adjoint_L_y_rx + t336;
        const lane t337 = B_4_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t79 = B_4_x*adjoint_L_rx_rz + adjoint_L_y_rx + t337;
        const lane t338 = B_3_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t78 = B_3_x*adjoint_L_rx_rz + adjoint_L_y_rx + t338;
        const lane t339 = B_2_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t77 = B_2_x*adjoint_L_rx_rz + adjoint_L_y_rx + t339;
        const lane t340 = B_1_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t76 = B_1_x*adjoint_L_rx_rz + adjoint_L_y_rx + t340;
        const lane adjoint_L_x_x =
            D_p_x_1*adjoint_f_x_l_1 + D_p_x_2*adjoint_f_x_l_2 + D_p_x_3*adjoint_f_x_l_3
            + D_p_x_4*adjoint_f_x_l_4 + D_p_x_5*adjoint_f_x_l_5 + D_p_x_6*adjoint_f_x_l_6
            + D_p_y_1*adjoint_f_y_l_1 + D_p_y_2*adjoint_f_y_l_2 + D_p_y_3*adjoint_f_y_l_3
            + D_p_y_4*adjoint_f_y_l_4 + D_p_y_5*adjoint_f_y_l_5 + D_p_y_6*adjoint_f_y_l_6
            + D_p_z_1*adjoint_f_z_l_1 + D_p_z_2*adjoint_f_z_l_2 + D_p_z_3*adjoint_f_z_l_3
            + D_p_z_4*adjoint_f_z_l_4 + D_p_z_5*adjoint_f_z_l_5 + D_p_z_6*adjoint_f_z_l_6;
        const lane adjoint_g_10_z =
            adjoint_L_rx_rz*forward_t114 + adjoint_L_ry_rz*t64 + adjoint_forward_t101*c_z;
        const lane adjoint_g_10_y =
            adjoint_L_rx_ry*forward_t114 + adjoint_L_ry_rz*t65 + adjoint_forward_t94*c_y;
        const lane adjoint_g_10_x = (1.0/2.0)*adjoint_forward_t115 + adjoint_forward_t122*c_x;
        const lane adjoint_g_9_z = B_6_z*adjoint_forward_t101 + adjoint_L_rx_rz*forward_t112 + (1.0/2.0)*t335;
        const lane adjoint_g_9_y =
            B_6_y*adjoint_forward_t94 + adjoint_L_rx_ry*forward_t112 + adjoint_L_ry_rz*t63;
        const lane adjoint_g_9_x = B_6_x*adjoint_forward_t122 + (1.0/2.0)*adjoint_forward_t113;
        const lane adjoint_g_8_z = B_5_z*adjoint_forward_t101 + adjoint_L_rx_rz*forward_t110 + (1.0/2.0)*t336;
        const lane adjoint_g_8_y =
            B_5_y*adjoint_forward_t94 + adjoint_L_rx_ry*forward_t110 + adjoint_L_ry_rz*t75;
        const lane adjoint_g_8_x = B_5_x*adjoint_forward_t122 + (1.0/2.0)*adjoint_forward_t111;
        const lane adjoint_g_7_z = B_4_z*adjoint_forward_t101 + adjoint_L_rx_rz*forward_t108 + (1.0/2.0)*t337;
        const lane adjoint_g_7_y =
            B_4_y*adjoint_forward_t94 + adjoint_L_rx_ry*forward_t108 + adjoint_L_ry_rz*t73;
        const lane adjoint_g_7_x = B_4_x*adjoint_forward_t122 + (1.0/2.0)*adjoint_forward_t109;
        const lane adjoint_g_6_z = B_3_z*adjoint_forward_t101 + adjoint_L_rx_rz*forward_t106 + (1.0/2.0)*t338;
        const lane adjoint_g_6_y =
            B_3_y*adjoint_forward_t94 + adjoint_L_rx_ry*forward_t106 + adjoint_L_ry_rz*t71;
        const lane adjoint_g_6_x = B_3_x*adjoint_forward_t122 + (1.0/2.0)*adjoint_forward_t107;
        const lane adjoint_g_5_z = B_2_z*adjoint_forward_t101 + adjoint_L_rx_rz*forward_t104 + (1.0/2.0)*t339;
        const lane adjoint_g_5_y =
            B_2_y*adjoint_forward_t94 + adjoint_L_rx_ry*forward_t104 + adjoint_L_ry_rz*t69;
        const lane adjoint_g_5_x = B_2_x*adjoint_forward_t122 + (1.0/2.0)*adjoint_forward_t105;
        const lane adjoint_g_4_z = B_1_z*adjoint_forward_t101 + adjoint_L_rx_rz*forward_t102 + (1.0/2.0)*t340;
        const lane adjoint_g_4_y =
            B_1_y*adjoint_forward_t94 + adjoint_L_rx_ry*forward_t102 + adjoint_L_ry_rz*t67;
        const lane adjoint_g_4_x = B_1_x*adjoint_forward_t122 + (1.0/2.0)*adjoint_forward_t103;
        const lane adjoint_mu_6 =
            B_6_x*adjoint_L_z_ry + B_6_y*adjoint_forward_t87 + B_6_z*adjoint_forward_t81 - adjoint_L_x_x
            + adjoint_forward_t101*forward_t100 + adjoint_forward_t122*forward_t121
            + adjoint_forward_t94*forward_t91 - adjoint_g_9_x*d_6_x - adjoint_g_9_y*d_6_y
            - adjoint_g_9_z*d_6_z + t115;
        const lane adjoint_mu_5 =
            B_5_x*adjoint_L_z_ry + B_5_y*adjoint_forward_t86 + B_5_z*adjoint_forward_t80 - adjoint_L_x_x
            + adjoint_forward_t101*forward_t99 + adjoint_forward_t122*forward_t120
            + adjoint_forward_t94*forward_t90 - adjoint_g_8_x*d_5_x - adjoint_g_8_y*d_5_y
            - adjoint_g_8_z*d_5_z + t117;
        const lane adjoint_mu_4 =
            B_4_x*adjoint_L_z_ry + B_4_y*adjoint_forward_t85 + B_4_z*adjoint_forward_t79 - adjoint_L_x_x
            + adjoint_forward_t101*forward_t98 + adjoint_forward_t122*forward_t119
            + adjoint_forward_t94*forward_t89 - adjoint_g_7_x*d_4_x - adjoint_g_7_y*d_4_y
            - adjoint_g_7_z*d_4_z + t119;
        const lane adjoint_mu_3 =
            B_3_x*adjoint_L_z_ry + B_3_y*adjoint_forward_t84 + B_3_z*adjoint_forward_t78 - adjoint_L_x_x
            + adjoint_forward_t101*forward_t97 + adjoint_forward_t122*forward_t118
            + adjoint_forward_t94*forward_t88 - adjoint_g_6_x*d_3_x - adjoint_g_6_y*d_3_y
            - adjoint_g_6_z*d_3_z + t121;
        const lane adjoint_mu_2 =
            B_2_x*adjoint_L_z_ry + B_2_y*adjoint_forward_t83 + B_2_z*adjoint_forward_t77 - adjoint_L_x_x
            + adjoint_forward_t101*forward_t96 + adjoint_forward_t122*forward_t117
            + adjoint_forward_t94*forward_t93 - adjoint_g_5_x*d_2_x - adjoint_g_5_y*d_2_y
            - adjoint_g_5_z*d_2_z + t123;
        const lane adjoint_mu_1 =
            B_1_x*adjoint_L_z_ry + B_1_y*adjoint_forward_t82 + B_1_z*adjoint_forward_t76 - adjoint_L_x_x
            + adjoint_forward_t101*forward_t95 + adjoint_forward_t122*forward_t116
            + adjoint_forward_t94*forward_t92 - adjoint_g_4_x*d_1_x - adjoint_g_4_y*d_1_y
            - adjoint_g_4_z*d_1_z + t125;
        const lane t341 = adjoint_mu_1*forward_22;
        const lane t342 = adjoint_mu_2*forward_22;
        const lane t343 = adjoint_mu_3*forward_22;
        const lane t344 = adjoint_mu_4*forward_22;
        const lane t345 = adjoint_mu_5*forward_22;
        const lane t346 = adjoint_mu_6*forward_22;
        const lane adjoint_G_p_rz =
            A_rz_1*t341 + A_rz_2*t342 + A_rz_3*t343 + A_rz_4*t344 + A_rz_5*t345 + A_rz_6*t346;
        const lane adjoint_G_p_ry =
            A_ry_1*t341 + A_ry_2*t342 + A_ry_3*t343 + A_ry_4*t344 + A_ry_5*t345 + A_ry_6*t346;
        const lane adjoint_G_p_rx =
            A_rx_1*t341 + A_rx_2*t342 + A_rx_3*t343 + A_rx_4*t344 + A_rx_5*t345 + A_rx_6*t346;
        const lane adjoint_G_p_z =
            A_z_1*t341 + A_z_2*t342 + A_z_3*t343 + A_z_4*t344 + A_z_5*t345 + A_z_6*t346;
        const lane adjoint_forward_t75 =
            -adjoint_G_p_rx*c_y + adjoint_G_p_ry*c_x - adjoint_G_p_z - adjoint_g_10_z;
        const lane adjoint_forward_t74 =
            B_6_x*adjoint_G_p_ry - B_6_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_9_z;
        const lane adjoint_forward_t73 =
            B_5_x*adjoint_G_p_ry - B_5_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_8_z;
        const lane adjoint_forward_t72 =
            B_4_x*adjoint_G_p_ry - B_4_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_7_z;
        const lane adjoint_forward_t71 =
            B_3_x*adjoint_G_p_ry - B_3_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_6_z;
        const lane adjoint_forward_t70 =
            B_2_x*adjoint_G_p_ry - B_2_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_5_z;
        const lane adjoint_forward_t69 =
            B_1_x*adjoint_G_p_ry - B_1_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_4_z;
        const lane adjoint_G_p_y =
            A_y_1*t341 + A_y_2*t342 + A_y_3*t343 + A_y_4*t344 + A_y_5*t345 + A_y_6*t346;
        const lane adjoint_forward_t68 = -adjoint_G_p_rz*c_x - adjoint_G_p_y - adjoint_g_10_y;
        const lane adjoint_forward_t67 = -B_6_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_9_y;
        const lane adjoint_forward_t66 = -B_5_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_8_y;
        const lane adjoint_forward_t65 = -B_4_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_7_y;
        const lane adjoint_forward_t64 = -B_3_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_6_y;
        const lane adjoint_forward_t63 = -B_2_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_5_y;
        const lane adjoint_forward_t62 = -B_1_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_4_y;
        const lane adjoint_G_p_x =
            A_x_1*t341 + A_x_2*t342 + A_x_3*t343 + A_x_4*t344 + A_x_5*t345 + A_x_6*t346;
        const lane adjoint_forward_t61 = -adjoint_G_p_ry*c_z - adjoint_G_p_x - adjoint_g_10_x;
        const lane adjoint_forward_t60 = -B_6_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_9_x;
        const lane adjoint_forward_t59 = -B_5_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_8_x;
        const lane adjoint_forward_t58 = -B_4_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_7_x;
        const lane adjoint_forward_t57 = -B_3_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_6_x;
        const lane adjoint_forward_t56 = -B_2_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_5_x;
        const lane adjoint_forward_t55 = -B_1_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_4_x;
        const lane t347 = forward_t159*t140;
        const lane t348 = forward_t160*t143;
        const lane t349 = forward_t161*t146;
        const lane t350 = forward_t162*t149;
        const lane t351 = eigenvalue*t115;
        const lane adjoint_D_p_rz_6 =
            L_rx_rz*adjoint_f_rx_l_6 + L_ry_rz*adjoint_f_ry_l_6 + L_rz_rz*adjoint_f_rz_l_6
            + L_x_rz*adjoint_f_x_l_6 + L_y_rz*adjoint_f_y_l_6 + M_p_rx_rz*adjoint_h_rx_l_6
            + M_p_ry_rz*adjoint_h_ry_l_6 + M_p_rz_rz*adjoint_h_rz_l_6 + M_p_x_rz*adjoint_h_x_l_6
            + M_p_y_rz*adjoint_h_y_l_6 - forward_t163*t153 - h_rz_l_6*t351 - shape_6*t347 - shape_6*t348
            - shape_6*t349 - shape_6*t350 + t115*(f_rz_l_6 - forward_t164);
        const lane t352 = eigenvalue*h_rz_l_6;
        const lane t353 = eigenvalue*t117;
        const lane adjoint_D_p_rz_5 =
            L_rx_rz*adjoint_f_rx_l_5 + L_ry_rz*adjoint_f_ry_l_5 + L_rz_rz*adjoint_f_rz_l_5
            + L_x_rz*adjoint_f_x_l_5 + L_y_rz*adjoint_f_y_l_5 + M_p_rx_rz*adjoint_h_rx_l_5
            + M_p_ry_rz*adjoint_h_ry_l_5 + M_p_rz_rz*adjoint_h_rz_l_5 + M_p_x_rz*adjoint_h_x_l_5
            + M_p_y_rz*adjoint_h_y_l_5 + f_rz_l_6*t153 - h_rz_l_5*t353 - shape_5*t347 - shape_5*t348
            - shape_5*t349 - shape_5*t350 + t117*(f_rz_l_5 - forward_t163) - t153*t352;
        const lane t354 = f_rz_l_5*shape_5;
        const lane t355 = f_rz_l_6*shape_6;
        const lane t356 = eigenvalue*t149;
        const lane t357 = h_rz_l_5*shape_5;
        const lane t358 = shape_6*t352;
        const lane t359 = eigenvalue*t119;
        const lane adjoint_D_p_rz_4 =
            L_rx_rz*adjoint_f_rx_l_4 + L_ry_rz*adjoint_f_ry_l_4 + L_rz_rz*adjoint_f_rz_l_4
            + L_x_rz*adjoint_f_x_l_4 + L_y_rz*adjoint_f_y_l_4 + M_p_rx_rz*adjoint_h_rx_l_4
            + M_p_ry_rz*adjoint_h_ry_l_4 + M_p_rz_rz*adjoint_h_rz_l_4 + M_p_x_rz*adjoint_h_x_l_4
            + M_p_y_rz*adjoint_h_y_l_4 - h_rz_l_4*t359 - shape_4*t347 - shape_4*t348 - shape_4*t349
            + t119*(f_rz_l_4 - forward_t162) + t149*t354 + t149*t355 - t149*t358 - t356*t357;
        const lane t360 = f_rz_l_4*shape_4;
        const lane t361 = eigenvalue*t146;
        const lane t362 = h_rz_l_4*shape_4;
        const lane t363 = eigenvalue*t121;
        const lane adjoint_D_p_rz_3 =
            L_rx_rz*adjoint_f_rx_l_3 + L_ry_rz*adjoint_f_ry_l_3 + L_rz_rz*adjoint_f_rz_l_3
            + L_x_rz*adjoint_f_x_l_3 + L_y_rz*adjoint_f_y_l_3 + M_p_rx_rz*adjoint_h_rx_l_3
            + M_p_ry_rz*adjoint_h_ry_l_3 + M_p_rz_rz*adjoint_h_rz_l_3 + M_p_x_rz*adjoint_h_x_l_3
            + M_p_y_rz*adjoint_h_y_l_3 - h_rz_l_3*t363 - shape_3*t347 - shape_3*t348 + t121*(f_rz_l_3
            - forward_t161) + t146*t354 + t146*t355 - t146*t358 + t146*t360 - t357*t361 - t361*t362;
        const lane t364 = f_rz_l_3*shape_3;
        const lane t365 = eigenvalue*t143;
        const lane t366 = h_rz_l_3*shape_3;
        const lane t367 = eigenvalue*t123;
        const lane adjoint_D_p_rz_2 =
            L_rx_rz*adjoint_f_rx_l_2 + L_ry_rz*adjoint_f_ry_l_2 + L_rz_rz*adjoint_f_rz_l_2
            + L_x_rz*adjoint_f_x_l_2 + L_y_rz*adjoint_f_y_l_2 + M_p_rx_rz*adjoint_h_rx_l_2
            + M_p_ry_rz*adjoint_h_ry_l_2 + M_p_rz_rz*adjoint_h_rz_l_2 + M_p_x_rz*adjoint_h_x_l_2
            + M_p_y_rz*adjoint_h_y_l_2 - forward_t159*t192 - h_rz_l_2*t367 + t123*(f_rz_l_2 - forward_t160)
            + t143*t354 + t143*t355 - t143*t358 + t143*t360 + t143*t364 - t357*t365 - t362*t365 - t365*t366;
        const lane t368 = eigenvalue*t192;
        const lane t369 = eigenvalue*t140;
        const lane t370 = eigenvalue*t125;
        const lane adjoint_D_p_rz_1 =
            L_rx_rz*adjoint_f_rx_l_1 + L_ry_rz*adjoint_f_ry_l_1 + L_rz_rz*adjoint_f_rz_l_1
            + L_x_rz*adjoint_f_x_l_1 + L_y_rz*adjoint_f_y_l_1 + M_p_rx_rz*adjoint_h_rx_l_1
            + M_p_ry_rz*adjoint_h_ry_l_1 + M_p_rz_rz*adjoint_h_rz_l_1 + M_p_x_rz*adjoint_h_x_l_1
            + M_p_y_rz*adjoint_h_y_l_1 + f_rz_l_2*t192 - h_rz_l_1*t370 - h_rz_l_2*t368 + t125*(f_rz_l_1
            - forward_t159) + t140*t354 + t140*t355 - t140*t358 + t140*t360 + t140*t364 - t357*t369
            - t362*t369 - t366*t369;
        const lane t371 = forward_t153*t140;
        const lane t372 = forward_t154*t143;
        const lane t373 = forward_t155*t146;
        const lane t374 = forward_t156*t149;
        const lane adjoint_D_p_ry_6 =
            L_rx_ry*adjoint_f_rx_l_6 + L_ry_ry*adjoint_f_ry_l_6 + L_ry_rz*adjoint_f_rz_l_6
            + L_x_ry*adjoint_f_x_l_6 + L_z_ry*adjoint_f_z_l_6 + M_p_rx_ry*adjoint_h_rx_l_6
            + M_p_ry_ry*adjoint_h_ry_l_6 + M_p_ry_rz*adjoint_h_rz_l_6 + M_p_x_ry*adjoint_h_x_l_6
            + M_p_z_ry*adjoint_h_z_l_6 - forward_t157*t153 - h_ry_l_6*t351 - shape_6*t371 - shape_6*t372
            - shape_6*t373 - shape_6*t374 + t115*(f_ry_l_6 - forward_t158);
        const lane t375 = eigenvalue*t153;
        const lane adjoint_D_p_ry_5 =
            L_rx_ry*adjoint_f_rx_l_5 + L_ry_ry*adjoint_f_ry_l_5 + L_ry_rz*adjoint_f_rz_l_5
            + L_x_ry*adjoint_f_x_l_5 + L_z_ry*adjoint_f_z_l_5 + M_p_rx_ry*adjoint_h_rx_l_5
            + M_p_ry_ry*adjoint_h_ry_l_5 + M_p_ry_rz*adjoint_h_rz_l_5 + M_p_x_ry*adjoint_h_x_l_5
            + M_p_z_ry*adjoint_h_z_l_5 + f_ry_l_6*t153 - h_ry_l_5*t353 - h_ry_l_6*t375 - shape_5*t371
            - shape_5*t372 - shape_5*t373 - shape_5*t374 + t117*(f_ry_l_5 - forward_t157);
        const lane t376 = f_ry_l_5*shape_5;
        const lane t377 = f_ry_l_6*shape_6;
        const lane t378 = h_ry_l_5*shape_5;
        const lane t379 = h_ry_l_6*shape_6;
        const lane adjoint_D_p_ry_4 =
            L_rx_ry*adjoint_f_rx_l_4 + L_ry_ry*adjoint_f_ry_l_4 + L_ry_rz*adjoint_f_rz_l_4
            + L_x_ry*adjoint_f_x_l_4 + L_z_ry*adjoint_f_z_l_4 + M_p_rx_ry*adjoint_h_rx_l_4
            + M_p_ry_ry*adjoint_h_ry_l_4 + M_p_ry_rz*adjoint_h_rz_l_4 + M_p_x_ry*adjoint_h_x_l_4
            + M_p_z_ry*adjoint_h_z_l_4 - h_ry_l_4*t359 - shape_4*t371 - shape_4*t372 - shape_4*t373
            + t119*(f_ry_l_4 - forward_t156) + t149*t376 + t149*t377 - t356*t378 - t356*t379;
        const lane t380 = f_ry_l_4*shape_4;
        const lane t381 = h_ry_l_4*shape_4;
        const lane adjoint_D_p_ry_3 =
            L_rx_ry*adjoint_f_rx_l_3 + L_ry_ry*adjoint_f_ry_l_3 + L_ry_rz*adjoint_f_rz_l_3
            + L_x_ry*adjoint_f_x_l_3 + L_z_ry*adjoint_f_z_l_3 + M_p_rx_ry*adjoint_h_rx_l_3
            + M_p_ry_ry*adjoint_h_ry_l_3 + M_p_ry_rz*adjoint_h_rz_l_3 + M_p_x_ry*adjoint_h_x_l_3
            + M_p_z_ry*adjoint_h_z_l_3 - h_ry_l_3*t363 - shape_3*t371 - shape_3*t372 + t121*(f_ry_l_3
            - forward_t155) + t146*t376 + t146*t377 + t146*t380 - t361*t378 - t361*t379 - t361*t381;
        const lane t382 = f_ry_l_3*shape_3;
        const lane t383 = h_ry_l_3*shape_3;
        const lane adjoint_D_p_ry_2 =
            L_rx_ry*adjoint_f_rx_l_2 + L_ry_ry*adjoint_f_ry_l_2 + L_ry_rz*adjoint_f_rz_l_2
            + L_x_ry*adjoint_f_x_l_2 + L_z_ry*adjoint_f_z_l_2 + M_p_rx_ry*adjoint_h_rx_l_2
            + M_p_ry_ry*adjoint_h_ry_l_2 + M_p_ry_rz*adjoint_h_rz_l_2 + M_p_x_ry*adjoint_h_x_l_2
            + M_p_z_ry*adjoint_h_z_l_2 - forward_t153*t192 - h_ry_l_2*t367 + t123*(f_ry_l_2 - forward_t154)
            + t143*t376 + t143*t377 + t143*t380 + t143*t382 - t365*t378 - t365*t379 - t365*t381 - t365*t383;
        const lane adjoint_D_p_ry_1 =
            L_rx_ry*adjoint_f_rx_l_1 + L_ry_ry*adjoint_f_ry_l_1 + L_ry_rz*adjoint_f_rz_l_1
            + L_x_ry*adjoint_f_x_l_1 + L_z_ry*adjoint_f_z_l_1 + M_p_rx_ry*adjoint_h_rx_l_1
            + M_p_ry_ry*adjoint_h_ry_l_1 + M_p_ry_rz*adjoint_h_rz_l_1 + M_p_x_ry*adjoint_h_x_l_1
            + M_p_z_ry*adjoint_h_z_l_1 + f_ry_l_2*t192 - h_ry_l_1*t370 - h_ry_l_2*t368 + t125*(f_ry_l_1
            - forward_t153) + t140*t376 + t140*t377 + t140*t380 + t140*t382 - t369*t378 - t369*t379
            - t369*t381 - t369*t383;
        const lane t384 = forward_t147*t140;
        const lane t385 = forward_t148*t143;
        const lane t386 = forward_t149*t146;
        const lane t387 = forward_t150*t149;
        const lane adjoint_D_p_rx_6 =
            L_rx_rx*adjoint_f_rx_l_6 + L_rx_ry*adjoint_f_ry_l_6 + L_rx_rz*adjoint_f_rz_l_6
            + L_y_rx*adjoint_f_y_l_6 + L_z_rx*adjoint_f_z_l_6 + M_p_rx_rx*adjoint_h_rx_l_6
            + M_p_rx_ry*adjoint_h_ry_l_6 + M_p_rx_rz*adjoint_h_rz_l_6 + M_p_y_rx*adjoint_h_y_l_6
            + M_p_z_rx*adjoint_h_z_l_6 - forward_t151*t153 - h_rx_l_6*t351 - shape_6*t384 - shape_6*t385
            - shape_6*t386 - shape_6*t387 + t115*(f_rx_l_6 - forward_t152);
        const lane adjoint_D_p_rx_5 =
            L_rx_rx*adjoint_f_rx_l_5 + L_rx_ry*adjoint_f_ry_l_5 + L_rx_rz*adjoint_f_rz_l_5
            + L_y_rx*adjoint_f_y_l_5 + L_z_rx*adjoint_f_z_l_5 + M_p_rx_rx*adjoint_h_rx_l_5
            + M_p_rx_ry*adjoint_h_ry_l_5 + M_p_rx_rz*adjoint_h_rz_l_5 + M_p_y_rx*adjoint_h_y_l_5
            + M_p_z_rx*adjoint_h_z_l_5 + f_rx_l_6*t153 - h_rx_l_5*t353 - h_rx_l_6*t375 - shape_5*t384
            - shape_5*t385 - shape_5*t386 - shape_5*t387 + t117*(f_rx_l_5 - forward_t151);
        const lane t388 = f_rx_l_5*shape_5;
        const lane t389 = f_rx_l_6*shape_6;
        const lane t390 = h_rx_l_5*shape_5;
        const lane t391 = h_rx_l_6*shape_6;
        const lane adjoint_D_p_rx_4 =
            L_rx_rx*adjoint_f_rx_l_4 + L_rx_ry*adjoint_f_ry_l_4 + L_rx_rz*adjoint_f_rz_l_4
            + L_y_rx*adjoint_f_y_l_4 + L_z_rx*adjoint_f_z_l_4 + M_p_rx_rx*adjoint_h_rx_l_4
            + M_p_rx_ry*adjoint_h_ry_l_4 + M_p_rx_rz*adjoint_h_rz_l_4 + M_p_y_rx*adjoint_h_y_l_4
            + M_p_z_rx*adjoint_h_z_l_4 - h_rx_l_4*t359 - shape_4*t384 - shape_4*t385 - shape_4*t386
            + t119*(f_rx_l_4 - forward_t150) + t149*t388 + t149*t389 - t356*t390 - t356*t391;
        const lane t392 = f_rx_l_4*shape_4;
        const lane t393 = h_rx_l_4*shape_4;
        const lane adjoint_D_p_rx_3 =
            L_rx_rx*adjoint_f_rx_l_3 + L_rx_ry*adjoint_f_ry_l_3 + L_rx_rz*adjoint_f_rz_l_3
            + L_y_rx*adjoint_f_y_l_3 + L_z_rx*adjoint_f_z_l_3 + M_p_rx_rx*adjoint_h_rx_l_3
            + M_p_rx_ry*adjoint_h_ry_l_3 + M_p_rx_rz*adjoint_h_rz_l_3 + M_p_y_rx*adjoint_h_y_l_3
            + M_p_z_rx*adjoint_h_z_l_3 - h_rx_l_3*t363 - shape_3*t384 - shape_3*t385 + t121*(f_rx_l_3
            - forward_t149) + t146*t388 + t146*t389 + t146*t392 - t361*t390 - t361*t391 - t361*t393;
        const lane t394 = f_rx_l_3*shape_3;
        const lane t395 = h_rx_l_3*shape_3;
        const lane adjoint_D_p_rx_2 =
            L_rx_rx*adjoint_f_rx_l_2 + L_rx_ry*adjoint_f_ry_l_2 + L_rx_rz*adjoint_f_rz_l_2
            + L_y_rx*adjoint_f_y_l_2 + L_z_rx*adjoint_f_z_l_2 + M_p_rx_rx*adjoint_h_rx_l_2
            + M_p_rx_ry*adjoint_h_ry_l_2 + M_p_rx_rz*adjoint_h_rz_l_2 + M_p_y_rx*adjoint_h_y_l_2
            + M_p_z_rx*adjoint_h_z_l_2 - forward_t147*t192 - h_rx_l_2*t367 + t123*(f_rx_l_2 - forward_t148)
            + t143*t388 + t143*t389 + t143*t392 + t143*t394 - t365*t390 - t365*t391 - t365*t393 - t365*t395;
        const lane adjoint_D_p_rx_1 =
            L_rx_rx*adjoint_f_rx_l_1 + L_rx_ry*adjoint_f_ry_l_1 + L_rx_rz*adjoint_f_rz_l_1
            + L_y_rx*adjoint_f_y_l_1 + L_z_rx*adjoint_f_z_l_1 + M_p_rx_rx*adjoint_h_rx_l_1
            + M_p_rx_ry*adjoint_h_ry_l_1 + M_p_rx_rz*adjoint_h_rz_l_1 + M_p_y_rx*adjoint_h_y_l_1
            + M_p_z_rx*adjoint_h_z_l_1 + f_rx_l_2*t192 - h_rx_l_1*t370 - h_rx_l_2*t368 + t125*(f_rx_l_1
            - forward_t147) + t140*t388 + t140*t389 + t140*t392 + t140*t394 - t369*t390 - t369*t391
            - t369*t393 - t369*t395;
        const lane t396 = forward_t141*t140;
        const lane t397 = forward_t142*t143;
        const lane t398 = forward_t143*t146;
        const lane t399 = forward_t144*t149;
        const lane adjoint_D_p_z_6 =
            L_x_x*adjoint_f_z_l_6 + L_z_rx*adjoint_f_rx_l_6 + L_z_ry*adjoint_f_ry_l_6
            + M_p_x_x*adjoint_h_z_l_6 + M_p_z_rx*adjoint_h_rx_l_6 + M_p_z_ry*adjoint_h_ry_l_6
            + forward_t145*t153 - h_z_l_6*t351 + shape_6*t396 + shape_6*t397 + shape_6*t398 + shape_6*t399
            + t115*(f_z_l_6 + forward_t146);
        const lane adjoint_D_p_z_5 =
            L_x_x*adjoint_f_z_l_5 + L_z_rx*adjoint_f_rx_l_5 + L_z_ry*adjoint_f_ry_l_5
            + M_p_x_x*adjoint_h_z_l_5 + M_p_z_rx*adjoint_h_rx_l_5 + M_p_z_ry*adjoint_h_ry_l_5 + f_z_l_6*t153
            - h_z_l_5*t353 - h_z_l_6*t375 + shape_5*t396 + shape_5*t397 + shape_5*t398 + shape_5*t399
            + t117*(f_z_l_5 + forward_t145);
        const lane t400 = f_z_l_5*shape_5;
        const lane t401 = f_z_l_6*shape_6;
        const lane t402 = h_z_l_5*shape_5;
        const lane t403 = h_z_l_6*shape_6;
        const lane adjoint_D_p_z_4 =
            L_x_x*adjoint_f_z_l_4 + L_z_rx*adjoint_f_rx_l_4 + L_z_ry*adjoint_f_ry_l_4
            + M_p_x_x*adjoint_h_z_l_4 + M_p_z_rx*adjoint_h_rx_l_4 + M_p_z_ry*adjoint_h_ry_l_4 - h_z_l_4*t359
            + shape_4*t396 + shape_4*t397 + shape_4*t398 + t119*(f_z_l_4 + forward_t144) + t149*t400
            + t149*t401 - t356*t402 - t356*t403;
        const lane t404 = f_z_l_4*shape_4;
        const lane t405 = h_z_l_4*shape_4;
        const lane adjoint_D_p_z_3 =
            L_x_x*adjoint_f_z_l_3 + L_z_rx*adjoint_f_rx_l_3 + L_z_ry*adjoint_f_ry_l_3
            + M_p_x_x*adjoint_h_z_l_3 + M_p_z_rx*adjoint_h_rx_l_3 + M_p_z_ry*adjoint_h_ry_l_3 - h_z_l_3*t363
            + shape_3*t396 + shape_3*t397 + t121*(f_z_l_3 + forward_t143) + t146*t400 + t146*t401 + t146*t404
            - t361*t402 - t361*t403 - t361*t405;
        const lane t406 = f_z_l_3*shape_3;
        const lane t407 = h_z_l_3*shape_3;
        const lane adjoint_D_p_z_2 =
            L_x_x*adjoint_f_z_l_2 + L_z_rx*adjoint_f_rx_l_2 + L_z_ry*adjoint_f_ry_l_2
            + M_p_x_x*adjoint_h_z_l_2 + M_p_z_rx*adjoint_h_rx_l_2 + M_p_z_ry*adjoint_h_ry_l_2
            + forward_t141*t192 - h_z_l_2*t367 + t123*(f_z_l_2 + forward_t142) + t143*t400 + t143*t401
            + t143*t404 + t143*t406 - t365*t402 - t365*t403 - t365*t405 - t365*t407;
        const lane adjoint_D_p_z_1 =
            L_x_x*adjoint_f_z_l_1 + L_z_rx*adjoint_f_rx_l_1 + L_z_ry*adjoint_f_ry_l_1
            + M_p_x_x*adjoint_h_z_l_1 + M_p_z_rx*adjoint_h_rx_l_1 + M_p_z_ry*adjoint_h_ry_l_1 + f_z_l_2*t192
            - h_z_l_1*t370 - h_z_l_2*t368 + t125*(f_z_l_1 + forward_t141) + t140*t400 + t140*t401 + t140*t404
            + t140*t406 - t369*t402 - t369*t403 - t369*t405 - t369*t407;
        const lane t408 = forward_t135*t140;
        const lane t409 = forward_t136*t143;
        const lane t410 = forward_t137*t146;
        const lane t411 = forward_t138*t149;
        const lane adjoint_D_p_y_6 =
            L_x_x*adjoint_f_y_l_6 + L_y_rx*adjoint_f_rx_l_6 + L_y_rz*adjoint_f_rz_l_6
            + M_p_x_x*adjoint_h_y_l_6 + M_p_y_rx*adjoint_h_rx_l_6 + M_p_y_rz*adjoint_h_rz_l_6
            + forward_t139*t153 - h_y_l_6*t351 + shape_6*t408 + shape_6*t409 + shape_6*t410 + shape_6*t411
            + t115*(f_y_l_6 + forward_t140);
        const lane adjoint_D_p_y_5 =
            L_x_x*adjoint_f_y_l_5 + L_y_rx*adjoint_f_rx_l_5 + L_y_rz*adjoint_f_rz_l_5
            + M_p_x_x*adjoint_h_y_l_5 + M_p_y_rx*adjoint_h_rx_l_5 + M_p_y_rz*adjoint_h_rz_l_5 + f_y_l_6*t153
            - h_y_l_5*t353 - h_y_l_6*t375 + shape_5*t408 + shape_5*t409 + shape_5*t410 + shape_5*t411
            + t117*(f_y_l_5 + forward_t139);
        const lane t412 = f_y_l_5*shape_5;
        const lane t413 = f_y_l_6*shape_6;
        const lane t414 = h_y_l_5*shape_5;
        const lane t415 = h_y_l_6*shape_6;
        const lane adjoint_D_p_y_4 =
            L_x_x*adjoint_f_y_l_4 + L_y_rx*adjoint_f_rx_l_4 + L_y_rz*adjoint_f_rz_l_4
            + M_p_x_x*adjoint_h_y_l_4 + M_p_y_rx*adjoint_h_rx_l_4 + M_p_y_rz*adjoint_h_rz_l_4 - h_y_l_4*t359
            + shape_4*t408 + shape_4*t409 + shape_4*t410 + t119*(f_y_l_4 + forward_t138) + t149*t412
            + t149*t413 - t356*t414 - t356*t415;
        const lane t416 = f_y_l_4*shape_4;
        const lane t417 = h_y_l_4*shape_4;
        const lane adjoint_D_p_y_3 =
            L_x_x*adjoint_f_y_l_3 + L_y_rx*adjoint_f_rx_l_3 + L_y_rz*adjoint_f_rz_l_3
            + M_p_x_x*adjoint_h_y_l_3 + M_p_y_rx*adjoint_h_rx_l_3 + M_p_y_rz*adjoint_h_rz_l_3 - h_y_l_3*t363
            + shape_3*t408 + shape_3*t409 + t121*(f_y_l_3 + forward_t137) + t146*t412 + t146*t413 + t146*t416
            - t361*t414 - t361*t415 - t361*t417;
        const lane t418 = f_y_l_3*shape_3;
        const lane t419 = h_y_l_3*shape_3;
        const lane adjoint_D_p_y_2 =
            L_x_x*adjoint_f_y_l_2 + L_y_rx*adjoint_f_rx_l_2 + L_y_rz*adjoint_f_rz_l_2
            + M_p_x_x*adjoint_h_y_l_2 + M_p_y_rx*adjoint_h_rx_l_2 + M_p_y_rz*adjoint_h_rz_l_2
            + forward_t135*t192 - h_y_l_2*t367 + t123*(f_y_l_2 + forward_t136) + t143*t412 + t143*t413
            + t143*t416 + t143*t418 - t365*t414 - t365*t415 - t365*t417 - t365*t419;
        const lane adjoint_D_p_y_1 =
            L_x_x*adjoint_f_y_l_1 + L_y_rx*adjoint_f_rx_l_1 + L_y_rz*adjoint_f_rz_l_1
            + M_p_x_x*adjoint_h_y_l_1 + M_p_y_rx*adjoint_h_rx_l_1 + M_p_y_rz*adjoint_h_rz_l_1 + f_y_l_2*t192
            - h_y_l_1*t370 - h_y_l_2*t368 + t125*(f_y_l_1 + forward_t135) + t140*t412 + t140*t413 + t140*t416
            + t140*t418 - t369*t414 - t369*t415 - t369*t417 - t369*t419;
        const lane t420 = forward_t124*t140;
        const lane t421 = forward_t126*t143;
        const lane t422 = forward_t128*t146;
        const lane t423 = forward_t130*t149;
        const lane adjoint_D_p_x_6 =
            L_x_ry*adjoint_f_ry_l_6 + L_x_rz*adjoint_f_rz_l_6 + L_x_x*adjoint_f_x_l_6
            + M_p_x_ry*adjoint_h_ry_l_6 + M_p_x_rz*adjoint_h_rz_l_6 + M_p_x_x*adjoint_h_x_l_6
            + forward_t132*t153 - h_x_l_6*t351 + shape_6*t420 + shape_6*t421 + shape_6*t422 + shape_6*t423
            + t115*(f_x_l_6 + forward_t134);
        const lane adjoint_forward_t54 =
            A_rx_6*adjoint_D_p_rx_6 + A_ry_6*adjoint_D_p_ry_6 + A_rz_6*adjoint_D_p_rz_6
            + A_x_6*adjoint_D_p_x_6 + A_y_6*adjoint_D_p_y_6 + A_z_6*adjoint_D_p_z_6;
        const lane adjoint_D_p_x_5 =
            L_x_ry*adjoint_f_ry_l_5 + L_x_rz*adjoint_f_rz_l_5 + L_x_x*adjoint_f_x_l_5
            + M_p_x_ry*adjoint_h_ry_l_5 + M_p_x_rz*adjoint_h_rz_l_5 + M_p_x_x*adjoint_h_x_l_5 + f_x_l_6*t153
            - h_x_l_5*t353 - h_x_l_6*t375 + shape_5*t420 + shape_5*t421 + shape_5*t422 + shape_5*t423
            + t117*(f_x_l_5 + forward_t132);
        const lane adjoint_forward_t53 =
            A_rx_5*adjoint_D_p_rx_5 + A_ry_5*adjoint_D_p_ry_5 + A_rz_5*adjoint_D_p_rz_5
            + A_x_5*adjoint_D_p_x_5 + A_y_5*adjoint_D_p_y_5 + A_z_5*adjoint_D_p_z_5;
        const lane t424 = f_x_l_5*shape_5;
        const lane t425 = f_x_l_6*shape_6;
        const lane t426 = h_x_l_5*shape_5;
        const lane t427 = h_x_l_6*shape_6;
        const lane adjoint_D_p_x_4 =
            L_x_ry*adjoint_f_ry_l_4 + L_x_rz*adjoint_f_rz_l_4 + L_x_x*adjoint_f_x_l_4
            + M_p_x_ry*adjoint_h_ry_l_4 + M_p_x_rz*adjoint_h_rz_l_4 + M_p_x_x*adjoint_h_x_l_4 - h_x_l_4*t359
            + shape_4*t420 + shape_4*t421 + shape_4*t422 + t119*(f_x_l_4 + forward_t130) + t149*t424
            + t149*t425 - t356*t426 - t356*t427;
        const lane adjoint_forward_t52 =
            A_rx_4*adjoint_D_p_rx_4 + A_ry_4*adjoint_D_p_ry_4 + A_rz_4*adjoint_D_p_rz_4
            + A_x_4*adjoint_D_p_x_4 + A_y_4*adjoint_D_p_y_4 + A_z_4*adjoint_D_p_z_4;
        const lane t428 = f_x_l_4*shape_4;
        const lane t429 = h_x_l_4*shape_4;
        const lane adjoint_D_p_x_3 =
            L_x_ry*adjoint_f_ry_l_3 + L_x_rz*adjoint_f_rz_l_3 + L_x_x*adjoint_f_x_l_3
            + M_p_x_ry*adjoint_h_ry_l_3 + M_p_x_rz*adjoint_h_rz_l_3 + M_p_x_x*adjoint_h_x_l_3 - h_x_l_3*t363
            + shape_3*t420 + shape_3*t421 + t121*(f_x_l_3 + forward_t128) + t146*t424 + t146*t425 + t146*t428
            - t361*t426 - t361*t427 - t361*t429;
        const lane adjoint_forward_t51 =
            A_rx_3*adjoint_D_p_rx_3 + A_ry_3*adjoint_D_p_ry_3 + A_rz_3*adjoint_D_p_rz_3
            + A_x_3*adjoint_D_p_x_3 + A_y_3*adjoint_D_p_y_3 + A_z_3*adjoint_D_p_z_3;
        const lane t430 = f_x_l_3*shape_3;
        const lane t431 = h_x_l_3*shape_3;
        const lane adjoint_D_p_x_2 =
            L_x_ry*adjoint_f_ry_l_2 + L_x_rz*adjoint_f_rz_l_2 + L_x_x*adjoint_f_x_l_2
            + M_p_x_ry*adjoint_h_ry_l_2 + M_p_x_rz*adjoint_h_rz_l_2 + M_p_x_x*adjoint_h_x_l_2
            + forward_t124*t192 - h_x_l_2*t367 + t123*(f_x_l_2 + forward_t126) + t143*t424 + t143*t425
            + t143*t428 + t143*t430 - t365*t426 - t365*t427 - t365*t429 - t365*t431;
        const lane adjoint_forward_t50 =
            A_rx_2*adjoint_D_p_rx_2 + A_ry_2*adjoint_D_p_ry_2 + A_rz_2*adjoint_D_p_rz_2
            + A_x_2*adjoint_D_p_x_2 + A_y_2*adjoint_D_p_y_2 + A_z_2*adjoint_D_p_z_2;
        const lane adjoint_D_p_x_1 =
            L_x_ry*adjoint_f_ry_l_1 + L_x_rz*adjoint_f_rz_l_1 + L_x_x*adjoint_f_x_l_1
            + M_p_x_ry*adjoint_h_ry_l_1 + M_p_x_rz*adjoint_h_rz_l_1 + M_p_x_x*adjoint_h_x_l_1 + f_x_l_2*t192
            - h_x_l_1*t370 - h_x_l_2*t368 + t125*(f_x_l_1 + forward_t124) + t140*t424 + t140*t425 + t140*t428
            + t140*t430 - t369*t426 - t369*t427 - t369*t429 - t369*t431;
        const lane adjoint_forward_t49 =
            A_rx_1*adjoint_D_p_rx_1 + A_ry_1*adjoint_D_p_ry_1 + A_rz_1*adjoint_D_p_rz_1
            + A_x_1*adjoint_D_p_x_1 + A_y_1*adjoint_D_p_y_1 + A_z_1*adjoint_D_p_z_1;
        const lane adjoint_forward_t48 =
            adjoint_forward_t49*forward_4 + adjoint_forward_t50*forward_5 + adjoint_forward_t51*forward_6
            + adjoint_forward_t52*forward_7 + adjoint_forward_t53*forward_8 + adjoint_forward_t54*forward_9
            + adjoint_mu_1*t56 + adjoint_mu_2*t57 + adjoint_mu_3*t58 + adjoint_mu_4*t59 + adjoint_mu_5*t60
            + adjoint_mu_6*t61;
        const lane adjoint_det_D_l = -adjoint_forward_t48*(forward_22*forward_22);
        const lane adjoint_A_rz_6 = G_p_rz*t346 + adjoint_D_p_rz_6*forward_t54;
        const lane adjoint_A_ry_6 = G_p_ry*t346 + adjoint_D_p_ry_6*forward_t54;
        const lane adjoint_A_rx_6 = G_p_rx*t346 + adjoint_D_p_rx_6*forward_t54;
        const lane adjoint_A_z_6 = G_p_z*t346 + adjoint_D_p_z_6*forward_t54;
        const lane adjoint_minor_45_12 =
            adjoint_A_rx_6*minor_123_356 - adjoint_A_ry_6*minor_123_346 + adjoint_A_rz_6*minor_123_345
            - adjoint_A_z_6*minor_123_456;
        const lane adjoint_A_y_6 = G_p_y*t346 + adjoint_D_p_y_6*forward_t54;
        const lane adjoint_minor_45_13 =
            -adjoint_A_rx_6*minor_123_256 + adjoint_A_ry_6*minor_123_246 - adjoint_A_rz_6*minor_123_245
            + adjoint_A_y_6*minor_123_456;
        const lane adjoint_minor_45_14 =
            -adjoint_A_ry_6*minor_123_236 + adjoint_A_rz_6*minor_123_235 - adjoint_A_y_6*minor_123_356
            + adjoint_A_z_6*minor_123_256;
        const lane adjoint_minor_45_15 =
            adjoint_A_rx_6*minor_123_236 - adjoint_A_rz_6*minor_123_234 + adjoint_A_y_6*minor_123_346
            - adjoint_A_z_6*minor_123_246;
        const lane adjoint_minor_45_16 =
            -adjoint_A_rx_6*minor_123_235 + adjoint_A_ry_6*minor_123_234 - adjoint_A_y_6*minor_123_345
            + adjoint_A_z_6*minor_123_245;
        const lane adjoint_A_x_6 = G_p_x*t346 + adjoint_D_p_x_6*forward_t54;
        const lane adjoint_minor_45_23 =
            adjoint_A_rx_6*minor_123_156 - adjoint_A_ry_6*minor_123_146 + adjoint_A_rz_6*minor_123_145
            - adjoint_A_x_6*minor_123_456;
        const lane adjoint_minor_45_24 =
            adjoint_A_ry_6*minor_123_136 - adjoint_A_rz_6*minor_123_135 + adjoint_A_x_6*minor_123_356
            - adjoint_A_z_6*minor_123_156;
        const lane adjoint_minor_45_25 =
            -adjoint_A_rx_6*minor_123_136 + adjoint_A_rz_6*minor_123_134 - adjoint_A_x_6*minor_123_346
            + adjoint_A_z_6*minor_123_146;
        const lane adjoint_minor_45_26 =
            adjoint_A_rx_6*minor_123_135 - adjoint_A_ry_6*minor_123_134 + adjoint_A_x_6*minor_123_345
            - adjoint_A_z_6*minor_123_145;
        const lane adjoint_minor_45_34 =
            -adjoint_A_ry_6*minor_123_126 + adjoint_A_rz_6*minor_123_125 - adjoint_A_x_6*minor_123_256
            + adjoint_A_y_6*minor_123_156;
        const lane adjoint_minor_45_35 =
            adjoint_A_rx_6*minor_123_126 - adjoint_A_rz_6*minor_123_124 + adjoint_A_x_6*minor_123_246
            - adjoint_A_y_6*minor_123_146;
        const lane adjoint_minor_45_36 =
            -adjoint_A_rx_6*minor_123_125 + adjoint_A_ry_6*minor_123_124 - adjoint_A_x_6*minor_123_245
            + adjoint_A_y_6*minor_123_145;
        const lane adjoint_minor_45_45 =
            adjoint_A_rz_6*minor_123_123 - adjoint_A_x_6*minor_123_236 + adjoint_A_y_6*minor_123_136
            - adjoint_A_z_6*minor_123_126;
        const lane adjoint_minor_45_46 =
            -adjoint_A_ry_6*minor_123_123 + adjoint_A_x_6*minor_123_235 - adjoint_A_y_6*minor_123_135
            + adjoint_A_z_6*minor_123_125;
        const lane adjoint_minor_45_56 =
            adjoint_A_rx_6*minor_123_123 - adjoint_A_x_6*minor_123_234 + adjoint_A_y_6*minor_123_134
            - adjoint_A_z_6*minor_123_124;
        const lane adjoint_A_rz_5 = G_p_rz*t345 + adjoint_D_p_rz_5*forward_t53;
        const lane adjoint_A_ry_5 = G_p_ry*t345 + adjoint_D_p_ry_5*forward_t53;
        const lane adjoint_A_rx_5 = G_p_rx*t345 + adjoint_D_p_rx_5*forward_t53;
        const lane adjoint_A_z_5 = G_p_z*t345 + adjoint_D_p_z_5*forward_t53;
        const lane adjoint_minor_46_12 =
            -adjoint_A_rx_5*minor_123_356 + adjoint_A_ry_5*minor_123_346 - adjoint_A_rz_5*minor_123_345
            + adjoint_A_z_5*minor_123_456;
        const lane adjoint_A_y_5 = G_p_y*t345 + adjoint_D_p_y_5*forward_t53;
        const lane adjoint_minor_46_13 =
            adjoint_A_rx_5*minor_123_256 - adjoint_A_ry_5*minor_123_246 + adjoint_A_rz_5*minor_123_245
            - adjoint_A_y_5*minor_123_456;
        const lane adjoint_minor_46_14 =
            adjoint_A_ry_5*minor_123_236 - adjoint_A_rz_5*minor_123_235 + adjoint_A_y_5*minor_123_356
            - adjoint_A_z_5*minor_123_256;
        const lane adjoint_minor_46_15 =
            -adjoint_A_rx_5*minor_123_236 + adjoint_A_rz_5*minor_123_234 - adjoint_A_y_5*minor_123_346
            + adjoint_A_z_5*minor_123_246;
        const lane adjoint_minor_46_16 =
            adjoint_A_rx_5*minor_123_235 - adjoint_A_ry_5*minor_123_234 + adjoint_A_y_5*minor_123_345
            - adjoint_A_z_5*minor_123_245;
        const lane adjoint_A_x_5 = G_p_x*t345 + adjoint_D_p_x_5*forward_t53;
        const lane adjoint_minor_46_23 =
            -adjoint_A_rx_5*minor_123_156 + adjoint_A_ry_5*minor_123_146 - adjoint_A_rz_5*minor_123_145
            + adjoint_A_x_5*minor_123_456;
        const lane adjoint_minor_46_24 =
            -adjoint_A_ry_5*minor_123_136 + adjoint_A_rz_5*minor_123_135 - adjoint_A_x_5*minor_123_356
            + adjoint_A_z_5*minor_123_156;
        const lane adjoint_minor_46_25 =
            adjoint_A_rx_5*minor_123_136 - adjoint_A_rz_5*minor_123_134 + adjoint_A_x_5*minor_123_346
            - adjoint_A_z_5*minor_123_146;
        const lane adjoint_minor_46_26 =
            -adjoint_A_rx_5*minor_123_135 + adjoint_A_ry_5*minor_123_134 - adjoint_A_x_5*minor_123_345
            + adjoint_A_z_5*minor_123_145;
        const lane adjoint_minor_46_34 =
            adjoint_A_ry_5*minor_123_126 - adjoint_A_rz_5*minor_123_125 + adjoint_A_x_5*minor_123_256
            - adjoint_A_y_5*minor_123_156;
        const lane adjoint_minor_46_35 =
            -adjoint_A_rx_5*minor_123_126 + adjoint_A_rz_5*minor_123_124 - adjoint_A_x_5*minor_123_246
            + adjoint_A_y_5*minor_123_146;
        const lane adjoint_minor_46_36 =
            adjoint_A_rx_5*minor_123_125 - adjoint_A_ry_5*minor_123_124 + adjoint_A_x_5*minor_123_245
            - adjoint_A_y_5*minor_123_145;
        const lane adjoint_minor_46_45 =
            -adjoint_A_rz_5*minor_123_123 + adjoint_A_x_5*minor_123_236 - adjoint_A_y_5*minor_123_136
            + adjoint_A_z_5*minor_123_126;
        const lane adjoint_minor_46_46 =
            adjoint_A_ry_5*minor_123_123 - adjoint_A_x_5*minor_123_235 + adjoint_A_y_5*minor_123_135
            - adjoint_A_z_5*minor_123_125;
        const lane adjoint_minor_46_56 =
            -adjoint_A_rx_5*minor_123_123 + adjoint_A_x_5*minor_123_234 - adjoint_A_y_5*minor_123_134
            + adjoint_A_z_5*minor_123_124;
        const lane adjoint_A_rz_4 = G_p_rz*t344 + adjoint_D_p_rz_4*forward_t52;
        const lane adjoint_A_ry_4 = G_p_ry*t344 + adjoint_D_p_ry_4*forward_t52;
        const lane adjoint_A_rx_4 = G_p_rx*t344 + adjoint_D_p_rx_4*forward_t52;
        const lane adjoint_minor_123_123 =
            adjoint_A_rx_4*minor_56_56 - adjoint_A_rx_5*minor_46_56 + adjoint_A_rx_6*minor_45_56
            - adjoint_A_ry_4*minor_56_46 + adjoint_A_ry_5*minor_46_46 - adjoint_A_ry_6*minor_45_46
            + adjoint_A_rz_4*minor_56_45 - adjoint_A_rz_5*minor_46_45 + adjoint_A_rz_6*minor_45_45;
        const lane adjoint_A_z_4 = G_p_z*t344 + adjoint_D_p_z_4*forward_t52;
        const lane adjoint_minor_123_126 =
            adjoint_A_rx_4*minor_56_35 - adjoint_A_rx_5*minor_46_35 + adjoint_A_rx_6*minor_45_35
            - adjoint_A_ry_4*minor_56_34 + adjoint_A_ry_5*minor_46_34 - adjoint_A_ry_6*minor_45_34
            - adjoint_A_z_4*minor_56_45 + adjoint_A_z_5*minor_46_45 - adjoint_A_z_6*minor_45_45;
        const lane adjoint_minor_123_125 =
            -adjoint_A_rx_4*minor_56_36 + adjoint_A_rx_5*minor_46_36 - adjoint_A_rx_6*minor_45_36
            + adjoint_A_rz_4*minor_56_34 - adjoint_A_rz_5*minor_46_34 + adjoint_A_rz_6*minor_45_34
            + adjoint_A_z_4*minor_56_46 - adjoint_A_z_5*minor_46_46 + adjoint_A_z_6*minor_45_46;
        const lane adjoint_minor_123_124 =
            adjoint_A_ry_4*minor_56_36 - adjoint_A_ry_5*minor_46_36 + adjoint_A_ry_6*minor_45_36
            - adjoint_A_rz_4*minor_56_35 + adjoint_A_rz_5*minor_46_35 - adjoint_A_rz_6*minor_45_35
            - adjoint_A_z_4*minor_56_56 + adjoint_A_z_5*minor_46_56 - adjoint_A_z_6*minor_45_56;
        const lane adjoint_A_y_4 = G_p_y*t344 + adjoint_D_p_y_4*forward_t52;
        const lane adjoint_minor_123_156 =
            adjoint_A_rx_4*minor_56_23 - adjoint_A_rx_5*minor_46_23 + adjoint_A_rx_6*minor_45_23
            + adjoint_A_y_4*minor_56_34 - adjoint_A_y_5*minor_46_34 + adjoint_A_y_6*minor_45_34
            - adjoint_A_z_4*minor_56_24 + adjoint_A_z_5*minor_46_24 - adjoint_A_z_6*minor_45_24;
        const lane adjoint_minor_123_146 =
            -adjoint_A_ry_4*minor_56_23 + adjoint_A_ry_5*minor_46_23 - adjoint_A_ry_6*minor_45_23
            - adjoint_A_y_4*minor_56_35 + adjoint_A_y_5*minor_46_35 - adjoint_A_y_6*minor_45_35
            + adjoint_A_z_4*minor_56_25 - adjoint_A_z_5*minor_46_25 + adjoint_A_z_6*minor_45_25;
        const lane adjoint_minor_123_145 =
            adjoint_A_rz_4*minor_56_23 - adjoint_A_rz_5*minor_46_23 + adjoint_A_rz_6*minor_45_23
            + adjoint_A_y_4*minor_56_36 - adjoint_A_y_5*minor_46_36 + adjoint_A_y_6*minor_45_36
            - adjoint_A_z_4*minor_56_26 + adjoint_A_z_5*minor_46_26 - adjoint_A_z_6*minor_45_26;
        const lane adjoint_minor_123_136 =
            -adjoint_A_rx_4*minor_56_25 + adjoint_A_rx_5*minor_46_25 - adjoint_A_rx_6*minor_45_25
            + adjoint_A_ry_4*minor_56_24 - adjoint_A_ry_5*minor_46_24 + adjoint_A_ry_6*minor_45_24
            + adjoint_A_y_4*minor_56_45 - adjoint_A_y_5*minor_46_45 + adjoint_A_y_6*minor_45_45;
        const lane adjoint_minor_123_135 =
            adjoint_A_rx_4*minor_56_26 - adjoint_A_rx_5*minor_46_26 + adjoint_A_rx_6*minor_45_26
            - adjoint_A_rz_4*minor_56_24 + adjoint_A_rz_5*minor_46_24 - adjoint_A_rz_6*minor_45_24
            - adjoint_A_y_4*minor_56_46 + adjoint_A_y_5*minor_46_46 - adjoint_A_y_6*minor_45_46;
        const lane adjoint_minor_123_134 =
            -adjoint_A_ry_4*minor_56_26 + adjoint_A_ry_5*minor_46_26 - adjoint_A_ry_6*minor_45_26
            + adjoint_A_rz_4*minor_56_25 - adjoint_A_rz_5*minor_46_25 + adjoint_A_rz_6*minor_45_25
            + adjoint_A_y_4*minor_56_56 - adjoint_A_y_5*minor_46_56 + adjoint_A_y_6*minor_45_56;
        const lane adjoint_A_x_4 = G_p_x*t344 + adjoint_D_p_x_4*forward_t52;
        const lane adjoint_minor_123_456 =
            -adjoint_A_x_4*minor_56_23 + adjoint_A_x_5*minor_46_23 - adjoint_A_x_6*minor_45_23
            + adjoint_A_y_4*minor_56_13 - adjoint_A_y_5*minor_46_13 + adjoint_A_y_6*minor_45_13
            - adjoint_A_z_4*minor_56_12 + adjoint_A_z_5*minor_46_12 - adjoint_A_z_6*minor_45_12;
        const lane adjoint_minor_123_356 =
            adjoint_A_rx_4*minor_56_12 - adjoint_A_rx_5*minor_46_12 + adjoint_A_rx_6*minor_45_12
            + adjoint_A_x_4*minor_56_24 - adjoint_A_x_5*minor_46_24 + adjoint_A_x_6*minor_45_24
            - adjoint_A_y_4*minor_56_14 + adjoint_A_y_5*minor_46_14 - adjoint_A_y_6*minor_45_14;
        const lane adjoint_minor_123_346 =
            -adjoint_A_ry_4*minor_56_12 + adjoint_A_ry_5*minor_46_12 - adjoint_A_ry_6*minor_45_12
            - adjoint_A_x_4*minor_56_25 + adjoint_A_x_5*minor_46_25 - adjoint_A_x_6*minor_45_25
            + adjoint_A_y_4*minor_56_15 - adjoint_A_y_5*minor_46_15 + adjoint_A_y_6*minor_45_15;
        const lane adjoint_minor_123_345 =
            adjoint_A_rz_4*minor_56_12 - adjoint_A_rz_5*minor_46_12 + adjoint_A_rz_6*minor_45_12
            + adjoint_A_x_4*minor_56_26 - adjoint_A_x_5*minor_46_26 + adjoint_A_x_6*minor_45_26
            - adjoint_A_y_4*minor_56_16 + adjoint_A_y_5*minor_46_16 - adjoint_A_y_6*minor_45_16;
        const lane adjoint_minor_123_256 =
            -adjoint_A_rx_4*minor_56_13 + adjoint_A_rx_5*minor_46_13 - adjoint_A_rx_6*minor_45_13
            - adjoint_A_x_4*minor_56_34 + adjoint_A_x_5*minor_46_34 - adjoint_A_x_6*minor_45_34
            + adjoint_A_z_4*minor_56_14 - adjoint_A_z_5*minor_46_14 + adjoint_A_z_6*minor_45_14;
        const lane adjoint_minor_123_246 =
            adjoint_A_ry_4*minor_56_13 - adjoint_A_ry_5*minor_46_13 + adjoint_A_ry_6*minor_45_13
            + adjoint_A_x_4*minor_56_35 - adjoint_A_x_5*minor_46_35 + adjoint_A_x_6*minor_45_35
            - adjoint_A_z_4*minor_56_15 + adjoint_A_z_5*minor_46_15 - adjoint_A_z_6*minor_45_15;
        const lane adjoint_minor_123_245 =
            -adjoint_A_rz_4*minor_56_13 + adjoint_A_rz_5*minor_46_13 - adjoint_A_rz_6*minor_45_13
            - adjoint_A_x_4*minor_56_36 + adjoint_A_x_5*minor_46_36 - adjoint_A_x_6*minor_45_36
            + adjoint_A_z_4*minor_56_16 - adjoint_A_z_5*minor_46_16 + adjoint_A_z_6*minor_45_16;
        const lane adjoint_minor_123_236 =
            adjoint_A_rx_4*minor_56_15 - adjoint_A_rx_5*minor_46_15 + adjoint_A_rx_6*minor_45_15
            - adjoint_A_ry_4*minor_56_14 + adjoint_A_ry_5*minor_46_14 - adjoint_A_ry_6*minor_45_14
            - adjoint_A_x_4*minor_56_45 + adjoint_A_x_5*minor_46_45 - adjoint_A_x_6*minor_45_45;
        const lane adjoint_minor_123_235 =
            -adjoint_A_rx_4*minor_56_16 + adjoint_A_rx_5*minor_46_16 - adjoint_A_rx_6*minor_45_16
            + adjoint_A_rz_4*minor_56_14 - adjoint_A_rz_5*minor_46_14 + adjoint_A_rz_6*minor_45_14
            + adjoint_A_x_4*minor_56_46 - adjoint_A_x_5*minor_46_46 + adjoint_A_x_6*minor_45_46;
        const lane adjoint_minor_123_234 =
            adjoint_A_ry_4*minor_56_16 - adjoint_A_ry_5*minor_46_16 + adjoint_A_ry_6*minor_45_16
            - adjoint_A_rz_4*minor_56_15 + adjoint_A_rz_5*minor_46_15 - adjoint_A_rz_6*minor_45_15
            - adjoint_A_x_4*minor_56_56 + adjoint_A_x_5*minor_46_56 - adjoint_A_x_6*minor_45_56;
        const lane adjoint_A_rz_3 = G_p_rz*t343 + adjoint_D_p_rz_3*forward_t51;
        const lane adjoint_A_ry_3 = G_p_ry*t343 + adjoint_D_p_ry_3*forward_t51;
        const lane adjoint_A_rx_3 = G_p_rx*t343 + adjoint_D_p_rx_3*forward_t51;
        const lane adjoint_A_z_3 = G_p_z*t343 + adjoint_D_p_z_3*forward_t51;
        const lane adjoint_minor_12_12 =
            -adjoint_A_rx_3*minor_456_356 + adjoint_A_ry_3*minor_456_346 - adjoint_A_rz_3*minor_456_345
            + adjoint_A_z_3*minor_456_456;
        const lane adjoint_A_y_3 = G_p_y*t343 + adjoint_D_p_y_3*forward_t51;
        const lane adjoint_minor_12_16 =
            adjoint_A_rx_3*minor_456_235 - adjoint_A_ry_3*minor_456_234 + adjoint_A_y_3*minor_456_345
            - adjoint_A_z_3*minor_456_245;
        const lane adjoint_minor_12_15 =
            -adjoint_A_rx_3*minor_456_236 + adjoint_A_rz_3*minor_456_234 - adjoint_A_y_3*minor_456_346
            + adjoint_A_z_3*minor_456_246;
        const lane adjoint_minor_12_14 =
            adjoint_A_ry_3*minor_456_236 - adjoint_A_rz_3*minor_456_235 + adjoint_A_y_3*minor_456_356
            - adjoint_A_z_3*minor_456_256;
        const lane adjoint_minor_12_13 =
            adjoint_A_rx_3*minor_456_256 - adjoint_A_ry_3*minor_456_246 + adjoint_A_rz_3*minor_456_245
            - adjoint_A_y_3*minor_456_456;
        const lane adjoint_A_x_3 = G_p_x*t343 + adjoint_D_p_x_3*forward_t51;
        const lane adjoint_minor_12_56 =
            -adjoint_A_rx_3*minor_456_123 + adjoint_A_x_3*minor_456_234 - adjoint_A_y_3*minor_456_134
            + adjoint_A_z_3*minor_456_124;
        const lane adjoint_minor_12_46 =
            adjoint_A_ry_3*minor_456_123 - adjoint_A_x_3*minor_456_235 + adjoint_A_y_3*minor_456_135
            - adjoint_A_z_3*minor_456_125;
        const lane adjoint_minor_12_45 =
            -adjoint_A_rz_3*minor_456_123 + adjoint_A_x_3*minor_456_236 - adjoint_A_y_3*minor_456_136
            + adjoint_A_z_3*minor_456_126;
        const lane adjoint_minor_12_36 =
            adjoint_A_rx_3*minor_456_125 - adjoint_A_ry_3*minor_456_124 + adjoint_A_x_3*minor_456_245
            - adjoint_A_y_3*minor_456_145;
        const lane adjoint_minor_12_35 =
            -adjoint_A_rx_3*minor_456_126 + adjoint_A_rz_3*minor_456_124 - adjoint_A_x_3*minor_456_246
            + adjoint_A_y_3*minor_456_146;
        const lane adjoint_minor_12_34 =
            adjoint_A_ry_3*minor_456_126 - adjoint_A_rz_3*minor_456_125 + adjoint_A_x_3*minor_456_256
            - adjoint_A_y_3*minor_456_156;
        const lane adjoint_minor_12_26 =
            -adjoint_A_rx_3*minor_456_135 + adjoint_A_ry_3*minor_456_134 - adjoint_A_x_3*minor_456_345
            + adjoint_A_z_3*minor_456_145;
        const lane adjoint_minor_12_25 =
            adjoint_A_rx_3*minor_456_136 - adjoint_A_rz_3*minor_456_134 + adjoint_A_x_3*minor_456_346
            - adjoint_A_z_3*minor_456_146;
        const lane adjoint_minor_12_24 =
            -adjoint_A_ry_3*minor_456_136 + adjoint_A_rz_3*minor_456_135 - adjoint_A_x_3*minor_456_356
            + adjoint_A_z_3*minor_456_156;
        const lane adjoint_minor_12_23 =
            -adjoint_A_rx_3*minor_456_156 + adjoint_A_ry_3*minor_456_146 - adjoint_A_rz_3*minor_456_145
            + adjoint_A_x_3*minor_456_456;
        const lane adjoint_A_rz_2 = G_p_rz*t342 + adjoint_D_p_rz_2*forward_t50;
        const lane adjoint_A_ry_2 = G_p_ry*t342 + adjoint_D_p_ry_2*forward_t50;
        const lane adjoint_A_rx_2 = G_p_rx*t342 + adjoint_D_p_rx_2*forward_t50;
        const lane adjoint_A_z_2 = G_p_z*t342 + adjoint_D_p_z_2*forward_t50;
        const lane adjoint_minor_13_12 =
            adjoint_A_rx_2*minor_456_356 - adjoint_A_ry_2*minor_456_346 + adjoint_A_rz_2*minor_456_345
            - adjoint_A_z_2*minor_456_456;
        const lane adjoint_A_y_2 = G_p_y*t342 + adjoint_D_p_y_2*forward_t50;
        const lane adjoint_minor_13_16 =
            -adjoint_A_rx_2*minor_456_235 + adjoint_A_ry_2*minor_456_234 - adjoint_A_y_2*minor_456_345
            + adjoint_A_z_2*minor_456_245;
        const lane adjoint_minor_13_15 =
            adjoint_A_rx_2*minor_456_236 - adjoint_A_rz_2*minor_456_234 + adjoint_A_y_2*minor_456_346
            - adjoint_A_z_2*minor_456_246;
        const lane adjoint_minor_13_14 =
            -adjoint_A_ry_2*minor_456_236 + adjoint_A_rz_2*minor_456_235 - adjoint_A_y_2*minor_456_356
            + adjoint_A_z_2*minor_456_256;
        const lane adjoint_minor_13_13 =
            -adjoint_A_rx_2*minor_456_256 + adjoint_A_ry_2*minor_456_246 - adjoint_A_rz_2*minor_456_245
            + adjoint_A_y_2*minor_456_456;
        const lane adjoint_A_x_2 = G_p_x*t342 + adjoint_D_p_x_2*forward_t50;
        const lane adjoint_minor_13_56 =
            adjoint_A_rx_2*minor_456_123 - adjoint_A_x_2*minor_456_234 + adjoint_A_y_2*minor_456_134
            - adjoint_A_z_2*minor_456_124;
        const lane adjoint_minor_13_46 =
            -adjoint_A_ry_2*minor_456_123 + adjoint_A_x_2*minor_456_235 - adjoint_A_y_2*minor_456_135
            + adjoint_A_z_2*minor_456_125;
        const lane adjoint_minor_13_45 =
            adjoint_A_rz_2*minor_456_123 - adjoint_A_x_2*minor_456_236 + adjoint_A_y_2*minor_456_136
            - adjoint_A_z_2*minor_456_126;
        const lane adjoint_minor_13_36 =
            -adjoint_A_rx_2*minor_456_125 + adjoint_A_ry_2*minor_456_124 - adjoint_A_x_2*minor_456_245
            + adjoint_A_y_2*minor_456_145;
        const lane adjoint_minor_13_35 =
            adjoint_A_rx_2*minor_456_126 - adjoint_A_rz_2*minor_456_124 + adjoint_A_x_2*minor_456_246
            - adjoint_A_y_2*minor_456_146;
        const lane adjoint_minor_13_34 =
            -adjoint_A_ry_2*minor_456_126 + adjoint_A_rz_2*minor_456_125 - adjoint_A_x_2*minor_456_256
            + adjoint_A_y_2*minor_456_156;
        const lane adjoint_minor_13_26 =
            adjoint_A_rx_2*minor_456_135 - adjoint_A_ry_2*minor_456_134 + adjoint_A_x_2*minor_456_345
            - adjoint_A_z_2*minor_456_145;
        const lane adjoint_minor_13_25 =
            -adjoint_A_rx_2*minor_456_136 + adjoint_A_rz_2*minor_456_134 - adjoint_A_x_2*minor_456_346
            + adjoint_A_z_2*minor_456_146;
        const lane adjoint_minor_13_24 =
            adjoint_A_ry_2*minor_456_136 - adjoint_A_rz_2*minor_456_135 + adjoint_A_x_2*minor_456_356
            - adjoint_A_z_2*minor_456_156;
        const lane adjoint_minor_13_23 =
            adjoint_A_rx_2*minor_456_156 - adjoint_A_ry_2*minor_456_146 + adjoint_A_rz_2*minor_456_145
            - adjoint_A_x_2*minor_456_456;
        const lane adjoint_A_rz_1 = D_l_1_rz*adjoint_det_D_l + G_p_rz*t341 + adjoint_D_p_rz_1*forward_t49;
        const lane adjoint_A_ry_1 = D_l_1_ry*adjoint_det_D_l + G_p_ry*t341 + adjoint_D_p_ry_1*forward_t49;
        const lane adjoint_A_rx_1 = D_l_1_rx*adjoint_det_D_l + G_p_rx*t341 + adjoint_D_p_rx_1*forward_t49;
        const lane adjoint_minor_456_123 =
            -adjoint_A_rx_1*minor_23_56 + adjoint_A_rx_2*minor_13_56 - adjoint_A_rx_3*minor_12_56
            + adjoint_A_ry_1*minor_23_46 - adjoint_A_ry_2*minor_13_46 + adjoint_A_ry_3*minor_12_46
            - adjoint_A_rz_1*minor_23_45 + adjoint_A_rz_2*minor_13_45 - adjoint_A_rz_3*minor_12_45;
        const lane adjoint_A_z_1 = G_p_z*t341 + adjoint_D_p_z_1*forward_t49 + adjoint_det_D_l*d_1_z;
        const lane adjoint_minor_456_124 =
            -adjoint_A_ry_1*minor_23_36 + adjoint_A_ry_2*minor_13_36 - adjoint_A_ry_3*minor_12_36
            + adjoint_A_rz_1*minor_23_35 - adjoint_A_rz_2*minor_13_35 + adjoint_A_rz_3*minor_12_35
            + adjoint_A_z_1*minor_23_56 - adjoint_A_z_2*minor_13_56 + adjoint_A_z_3*minor_12_56;
        const lane adjoint_minor_456_125 =
            adjoint_A_rx_1*minor_23_36 - adjoint_A_rx_2*minor_13_36 + adjoint_A_rx_3*minor_12_36
            - adjoint_A_rz_1*minor_23_34 + adjoint_A_rz_2*minor_13_34 - adjoint_A_rz_3*minor_12_34
            - adjoint_A_z_1*minor_23_46 + adjoint_A_z_2*minor_13_46 - adjoint_A_z_3*minor_12_46;
        const lane adjoint_minor_456_126 =
            -adjoint_A_rx_1*minor_23_35 + adjoint_A_rx_2*minor_13_35 - adjoint_A_rx_3*minor_12_35
            + adjoint_A_ry_1*minor_23_34 - adjoint_A_ry_2*minor_13_34 + adjoint_A_ry_3*minor_12_34
            + adjoint_A_z_1*minor_23_45 - adjoint_A_z_2*minor_13_45 + adjoint_A_z_3*minor_12_45;
        const lane adjoint_minor_56_12 =
            D_l_4_rx*adjoint_minor_456_124 + D_l_4_ry*adjoint_minor_456_125 + D_l_4_rz*adjoint_minor_456_126
            + adjoint_A_rx_4*minor_123_356 - adjoint_A_ry_4*minor_123_346 + adjoint_A_rz_4*minor_123_345
            - adjoint_A_z_4*minor_123_456 + adjoint_minor_456_123*d_4_z;
        const lane adjoint_minor_23_12 =
            D_l_1_rx*adjoint_minor_123_124 + D_l_1_ry*adjoint_minor_123_125 + D_l_1_rz*adjoint_minor_123_126
            - adjoint_A_rx_1*minor_456_356 + adjoint_A_ry_1*minor_456_346 - adjoint_A_rz_1*minor_456_345
            + adjoint_A_z_1*minor_456_456 + adjoint_minor_123_123*d_1_z;
        const lane adjoint_A_y_1 = G_p_y*t341 + adjoint_D_p_y_1*forward_t49 + adjoint_det_D_l*d_1_y;
        const lane adjoint_minor_456_134 =
            adjoint_A_ry_1*minor_23_26 - adjoint_A_ry_2*minor_13_26 + adjoint_A_ry_3*minor_12_26
            - adjoint_A_rz_1*minor_23_25 + adjoint_A_rz_2*minor_13_25 - adjoint_A_rz_3*minor_12_25
            - adjoint_A_y_1*minor_23_56 + adjoint_A_y_2*minor_13_56 - adjoint_A_y_3*minor_12_56;
        const lane adjoint_minor_456_135 =
            -adjoint_A_rx_1*minor_23_26 + adjoint_A_rx_2*minor_13_26 - adjoint_A_rx_3*minor_12_26
            + adjoint_A_rz_1*minor_23_24 - adjoint_A_rz_2*minor_13_24 + adjoint_A_rz_3*minor_12_24
            + adjoint_A_y_1*minor_23_46 - adjoint_A_y_2*minor_13_46 + adjoint_A_y_3*minor_12_46;
        const lane adjoint_minor_456_136 =
            adjoint_A_rx_1*minor_23_25 - adjoint_A_rx_2*minor_13_25 + adjoint_A_rx_3*minor_12_25
            - adjoint_A_ry_1*minor_23_24 + adjoint_A_ry_2*minor_13_24 - adjoint_A_ry_3*minor_12_24
            - adjoint_A_y_1*minor_23_45 + adjoint_A_y_2*minor_13_45 - adjoint_A_y_3*minor_12_45;
        const lane adjoint_minor_56_13 =
            D_l_4_rx*adjoint_minor_456_134 + D_l_4_ry*adjoint_minor_456_135 + D_l_4_rz*adjoint_minor_456_136
            - adjoint_A_rx_4*minor_123_256 + adjoint_A_ry_4*minor_123_246 - adjoint_A_rz_4*minor_123_245
            + adjoint_A_y_4*minor_123_456 - adjoint_minor_456_123*d_4_y;
        const lane adjoint_minor_456_145 =
            -adjoint_A_rz_1*minor_23_23 + adjoint_A_rz_2*minor_13_23 - adjoint_A_rz_3*minor_12_23
            - adjoint_A_y_1*minor_23_36 + adjoint_A_y_2*minor_13_36 - adjoint_A_y_3*minor_12_36
            + adjoint_A_z_1*minor_23_26 - adjoint_A_z_2*minor_13_26 + adjoint_A_z_3*minor_12_26;
        const lane adjoint_minor_456_146 =
            adjoint_A_ry_1*minor_23_23 - adjoint_A_ry_2*minor_13_23 + adjoint_A_ry_3*minor_12_23
            + adjoint_A_y_1*minor_23_35 - adjoint_A_y_2*minor_13_35 + adjoint_A_y_3*minor_12_35
            - adjoint_A_z_1*minor_23_25 + adjoint_A_z_2*minor_13_25 - adjoint_A_z_3*minor_12_25;
        const lane adjoint_minor_56_14 =
            D_l_4_ry*adjoint_minor_456_145 + D_l_4_rz*adjoint_minor_456_146 - adjoint_A_ry_4*minor_123_236
            + adjoint_A_rz_4*minor_123_235 - adjoint_A_y_4*minor_123_356 + adjoint_A_z_4*minor_123_256
            - adjoint_minor_456_124*d_4_y - adjoint_minor_456_134*d_4_z;
        const lane adjoint_minor_456_156 =
            -adjoint_A_rx_1*minor_23_23 + adjoint_A_rx_2*minor_13_23 - adjoint_A_rx_3*minor_12_23
            - adjoint_A_y_1*minor_23_34 + adjoint_A_y_2*minor_13_34 - adjoint_A_y_3*minor_12_34
            + adjoint_A_z_1*minor_23_24 - adjoint_A_z_2*minor_13_24 + adjoint_A_z_3*minor_12_24;
        const lane adjoint_minor_56_15 =
            -D_l_4_rx*adjoint_minor_456_145 + D_l_4_rz*adjoint_minor_456_156 + adjoint_A_rx_4*minor_123_236
            - adjoint_A_rz_4*minor_123_234 + adjoint_A_y_4*minor_123_346 - adjoint_A_z_4*minor_123_246
            - adjoint_minor_456_125*d_4_y - adjoint_minor_456_135*d_4_z;
        const lane adjoint_minor_56_16 =
            -D_l_4_rx*adjoint_minor_456_146 - D_l_4_ry*adjoint_minor_456_156 - adjoint_A_rx_4*minor_123_235
            + adjoint_A_ry_4*minor_123_234 - adjoint_A_y_4*minor_123_345 + adjoint_A_z_4*minor_123_245
            - adjoint_minor_456_126*d_4_y - adjoint_minor_456_136*d_4_z;
        const lane adjoint_minor_23_16 =
            -D_l_1_rx*adjoint_minor_123_146 - D_l_1_ry*adjoint_minor_123_156 + adjoint_A_rx_1*minor_456_235
            - adjoint_A_ry_1*minor_456_234 + adjoint_A_y_1*minor_456_345 - adjoint_A_z_1*minor_456_245
            - adjoint_minor_123_126*d_1_y - adjoint_minor_123_136*d_1_z;
        const lane adjoint_minor_23_15 =
            -D_l_1_rx*adjoint_minor_123_145 + D_l_1_rz*adjoint_minor_123_156 - adjoint_A_rx_1*minor_456_236
            + adjoint_A_rz_1*minor_456_234 - adjoint_A_y_1*minor_456_346 + adjoint_A_z_1*minor_456_246
            - adjoint_minor_123_125*d_1_y - adjoint_minor_123_135*d_1_z;
        const lane adjoint_minor_23_14 =
            D_l_1_ry*adjoint_minor_123_145 + D_l_1_rz*adjoint_minor_123_146 + adjoint_A_ry_1*minor_456_236
            - adjoint_A_rz_1*minor_456_235 + adjoint_A_y_1*minor_456_356 - adjoint_A_z_1*minor_456_256
            - adjoint_minor_123_124*d_1_y - adjoint_minor_123_134*d_1_z;
        const lane adjoint_minor_23_13 =
            D_l_1_rx*adjoint_minor_123_134 + D_l_1_ry*adjoint_minor_123_135 + D_l_1_rz*adjoint_minor_123_136
            + adjoint_A_rx_1*minor_456_256 - adjoint_A_ry_1*minor_456_246 + adjoint_A_rz_1*minor_456_245
            - adjoint_A_y_1*minor_456_456 - adjoint_minor_123_123*d_1_y;
        const lane adjoint_A_x_1 = G_p_x*t341 + adjoint_D_p_x_1*forward_t49 + adjoint_det_D_l*d_1_x;
        const lane adjoint_minor_456_234 =
            -adjoint_A_ry_1*minor_23_16 + adjoint_A_ry_2*minor_13_16 - adjoint_A_ry_3*minor_12_16
            + adjoint_A_rz_1*minor_23_15 - adjoint_A_rz_2*minor_13_15 + adjoint_A_rz_3*minor_12_15
            + adjoint_A_x_1*minor_23_56 - adjoint_A_x_2*minor_13_56 + adjoint_A_x_3*minor_12_56;
        const lane adjoint_minor_23_56 =
            D_l_1_rx*adjoint_minor_123_456 - adjoint_A_rx_1*minor_456_123 + adjoint_A_x_1*minor_456_234
            - adjoint_A_y_1*minor_456_134 + adjoint_A_z_1*minor_456_124 + adjoint_minor_123_156*d_1_x
            + adjoint_minor_123_256*d_1_y + adjoint_minor_123_356*d_1_z;
        const lane adjoint_minor_456_235 =
            adjoint_A_rx_1*minor_23_16 - adjoint_A_rx_2*minor_13_16 + adjoint_A_rx_3*minor_12_16
            - adjoint_A_rz_1*minor_23_14 + adjoint_A_rz_2*minor_13_14 - adjoint_A_rz_3*minor_12_14
            - adjoint_A_x_1*minor_23_46 + adjoint_A_x_2*minor_13_46 - adjoint_A_x_3*minor_12_46;
        const lane adjoint_minor_23_46 =
            -D_l_1_ry*adjoint_minor_123_456 + adjoint_A_ry_1*minor_456_123 - adjoint_A_x_1*minor_456_235
            + adjoint_A_y_1*minor_456_135 - adjoint_A_z_1*minor_456_125 + adjoint_minor_123_146*d_1_x
            + adjoint_minor_123_246*d_1_y + adjoint_minor_123_346*d_1_z;
        const lane adjoint_minor_456_236 =
            -adjoint_A_rx_1*minor_23_15 + adjoint_A_rx_2*minor_13_15 - adjoint_A_rx_3*minor_12_15
            + adjoint_A_ry_1*minor_23_14 - adjoint_A_ry_2*minor_13_14 + adjoint_A_ry_3*minor_12_14
            + adjoint_A_x_1*minor_23_45 - adjoint_A_x_2*minor_13_45 + adjoint_A_x_3*minor_12_45;
        const lane adjoint_minor_56_23 =
            D_l_4_rx*adjoint_minor_456_234 + D_l_4_ry*adjoint_minor_456_235 + D_l_4_rz*adjoint_minor_456_236
            + adjoint_A_rx_4*minor_123_156 - adjoint_A_ry_4*minor_123_146 + adjoint_A_rz_4*minor_123_145
            - adjoint_A_x_4*minor_123_456 + adjoint_minor_456_123*d_4_x;
        const lane adjoint_minor_23_45 =
            D_l_1_rz*adjoint_minor_123_456 - adjoint_A_rz_1*minor_456_123 + adjoint_A_x_1*minor_456_236
            - adjoint_A_y_1*minor_456_136 + adjoint_A_z_1*minor_456_126 + adjoint_minor_123_145*d_1_x
            + adjoint_minor_123_245*d_1_y + adjoint_minor_123_345*d_1_z;
        const lane adjoint_minor_456_245 =
            adjoint_A_rz_1*minor_23_13 - adjoint_A_rz_2*minor_13_13 + adjoint_A_rz_3*minor_12_13
            + adjoint_A_x_1*minor_23_36 - adjoint_A_x_2*minor_13_36 + adjoint_A_x_3*minor_12_36
            - adjoint_A_z_1*minor_23_16 + adjoint_A_z_2*minor_13_16 - adjoint_A_z_3*minor_12_16;
        const lane adjoint_minor_23_36 =
            -D_l_1_rx*adjoint_minor_123_346 - D_l_1_ry*adjoint_minor_123_356 + adjoint_A_rx_1*minor_456_125
            - adjoint_A_ry_1*minor_456_124 + adjoint_A_x_1*minor_456_245 - adjoint_A_y_1*minor_456_145
            + adjoint_minor_123_136*d_1_x + adjoint_minor_123_236*d_1_y;
        const lane adjoint_minor_456_246 =
            -adjoint_A_ry_1*minor_23_13 + adjoint_A_ry_2*minor_13_13 - adjoint_A_ry_3*minor_12_13
            - adjoint_A_x_1*minor_23_35 + adjoint_A_x_2*minor_13_35 - adjoint_A_x_3*minor_12_35
            + adjoint_A_z_1*minor_23_15 - adjoint_A_z_2*minor_13_15 + adjoint_A_z_3*minor_12_15;
        const lane adjoint_minor_56_24 =
            D_l_4_ry*adjoint_minor_456_245 + D_l_4_rz*adjoint_minor_456_246 + adjoint_A_ry_4*minor_123_136
            - adjoint_A_rz_4*minor_123_135 + adjoint_A_x_4*minor_123_356 - adjoint_A_z_4*minor_123_156
            + adjoint_minor_456_124*d_4_x - adjoint_minor_456_234*d_4_z;
        const lane adjoint_minor_23_35 =
            -D_l_1_rx*adjoint_minor_123_345 + D_l_1_rz*adjoint_minor_123_356 - adjoint_A_rx_1*minor_456_126
            + adjoint_A_rz_1*minor_456_124 - adjoint_A_x_1*minor_456_246 + adjoint_A_y_1*minor_456_146
            + adjoint_minor_123_135*d_1_x + adjoint_minor_123_235*d_1_y;
        const lane adjoint_minor_456_256 =
            adjoint_A_rx_1*minor_23_13 - adjoint_A_rx_2*minor_13_13 + adjoint_A_rx_3*minor_12_13
            + adjoint_A_x_1*minor_23_34 - adjoint_A_x_2*minor_13_34 + adjoint_A_x_3*minor_12_34
            - adjoint_A_z_1*minor_23_14 + adjoint_A_z_2*minor_13_14 - adjoint_A_z_3*minor_12_14;
        const lane adjoint_minor_56_25 =
            -D_l_4_rx*adjoint_minor_456_245 + D_l_4_rz*adjoint_minor_456_256 - adjoint_A_rx_4*minor_123_136
            + adjoint_A_rz_4*minor_123_134 - adjoint_A_x_4*minor_123_346 + adjoint_A_z_4*minor_123_146
            + adjoint_minor_456_125*d_4_x - adjoint_minor_456_235*d_4_z;
        const lane adjoint_minor_56_26 =
            -D_l_4_rx*adjoint_minor_456_246 - D_l_4_ry*adjoint_minor_456_256 + adjoint_A_rx_4*minor_123_135
            - adjoint_A_ry_4*minor_123_134 + adjoint_A_x_4*minor_123_345 - adjoint_A_z_4*minor_123_145
            + adjoint_minor_456_126*d_4_x - adjoint_minor_456_236*d_4_z;
        const lane adjoint_minor_23_34 =
            D_l_1_ry*adjoint_minor_123_345 + D_l_1_rz*adjoint_minor_123_346 + adjoint_A_ry_1*minor_456_126
            - adjoint_A_rz_1*minor_456_125 + adjoint_A_x_1*minor_456_256 - adjoint_A_y_1*minor_456_156
            + adjoint_minor_123_134*d_1_x + adjoint_minor_123_234*d_1_y;
        const lane adjoint_minor_456_345 =
            -adjoint_A_rz_1*minor_23_12 + adjoint_A_rz_2*minor_13_12 - adjoint_A_rz_3*minor_12_12
            - adjoint_A_x_1*minor_23_26 + adjoint_A_x_2*minor_13_26 - adjoint_A_x_3*minor_12_26
            + adjoint_A_y_1*minor_23_16 - adjoint_A_y_2*minor_13_16 + adjoint_A_y_3*minor_12_16;
        const lane adjoint_minor_23_26 =
            -D_l_1_rx*adjoint_minor_123_246 - D_l_1_ry*adjoint_minor_123_256 - adjoint_A_rx_1*minor_456_135
            + adjoint_A_ry_1*minor_456_134 - adjoint_A_x_1*minor_456_345 + adjoint_A_z_1*minor_456_145
            + adjoint_minor_123_126*d_1_x - adjoint_minor_123_236*d_1_z;
        const lane adjoint_minor_456_346 =
            adjoint_A_ry_1*minor_23_12 - adjoint_A_ry_2*minor_13_12 + adjoint_A_ry_3*minor_12_12
            + adjoint_A_x_1*minor_23_25 - adjoint_A_x_2*minor_13_25 + adjoint_A_x_3*minor_12_25
            - adjoint_A_y_1*minor_23_15 + adjoint_A_y_2*minor_13_15 - adjoint_A_y_3*minor_12_15;
        const lane adjoint_minor_56_34 =
            D_l_4_ry*adjoint_minor_456_345 + D_l_4_rz*adjoint_minor_456_346 - adjoint_A_ry_4*minor_123_126
            + adjoint_A_rz_4*minor_123_125 - adjoint_A_x_4*minor_123_256 + adjoint_A_y_4*minor_123_156
            + adjoint_minor_456_134*d_4_x + adjoint_minor_456_234*d_4_y;
        const lane adjoint_minor_23_25 =
            -D_l_1_rx*adjoint_minor_123_245 + D_l_1_rz*adjoint_minor_123_256 + adjoint_A_rx_1*minor_456_136
            - adjoint_A_rz_1*minor_456_134 + adjoint_A_x_1*minor_456_346 - adjoint_A_z_1*minor_456_146
            + adjoint_minor_123_125*d_1_x - adjoint_minor_123_235*d_1_z;
        const lane adjoint_minor_456_356 =
            -adjoint_A_rx_1*minor_23_12 + adjoint_A_rx_2*minor_13_12 - adjoint_A_rx_3*minor_12_12
            - adjoint_A_x_1*minor_23_24 + adjoint_A_x_2*minor_13_24 - adjoint_A_x_3*minor_12_24
            + adjoint_A_y_1*minor_23_14 - adjoint_A_y_2*minor_13_14 + adjoint_A_y_3*minor_12_14;
        const lane adjoint_minor_56_35 =
            -D_l_4_rx*adjoint_minor_456_345 + D_l_4_rz*adjoint_minor_456_356 + adjoint_A_rx_4*minor_123_126
            - adjoint_A_rz_4*minor_123_124 + adjoint_A_x_4*minor_123_246 - adjoint_A_y_4*minor_123_146
            + adjoint_minor_456_135*d_4_x + adjoint_minor_456_235*d_4_y;
        const lane adjoint_minor_56_36 =
            -D_l_4_rx*adjoint_minor_456_346 - D_l_4_ry*adjoint_minor_456_356 - adjoint_A_rx_4*minor_123_125
            + adjoint_A_ry_4*minor_123_124 - adjoint_A_x_4*minor_123_245 + adjoint_A_y_4*minor_123_145
            + adjoint_minor_456_136*d_4_x + adjoint_minor_456_236*d_4_y;
        const lane adjoint_minor_23_24 =
            D_l_1_ry*adjoint_minor_123_245 + D_l_1_rz*adjoint_minor_123_246 - adjoint_A_ry_1*minor_456_136
            + adjoint_A_rz_1*minor_456_135 - adjoint_A_x_1*minor_456_356 + adjoint_A_z_1*minor_456_156
            + adjoint_minor_123_124*d_1_x - adjoint_minor_123_234*d_1_z;
        const lane adjoint_minor_456_456 =
            adjoint_A_x_1*minor_23_23 - adjoint_A_x_2*minor_13_23 + adjoint_A_x_3*minor_12_23
            - adjoint_A_y_1*minor_23_13 + adjoint_A_y_2*minor_13_13 - adjoint_A_y_3*minor_12_13
            + adjoint_A_z_1*minor_23_12 - adjoint_A_z_2*minor_13_12 + adjoint_A_z_3*minor_12_12;
        const lane adjoint_minor_56_45 =
            D_l_4_rz*adjoint_minor_456_456 + adjoint_A_rz_4*minor_123_123 - adjoint_A_x_4*minor_123_236
            + adjoint_A_y_4*minor_123_136 - adjoint_A_z_4*minor_123_126 + adjoint_minor_456_145*d_4_x
            + adjoint_minor_456_245*d_4_y + adjoint_minor_456_345*d_4_z;
        const lane adjoint_minor_56_46 =
            -D_l_4_ry*adjoint_minor_456_456 - adjoint_A_ry_4*minor_123_123 + adjoint_A_x_4*minor_123_235
            - adjoint_A_y_4*minor_123_135 + adjoint_A_z_4*minor_123_125 + adjoint_minor_456_146*d_4_x
            + adjoint_minor_456_246*d_4_y + adjoint_minor_456_346*d_4_z;
        const lane adjoint_minor_56_56 =
            D_l_4_rx*adjoint_minor_456_456 + adjoint_A_rx_4*minor_123_123 - adjoint_A_x_4*minor_123_234
            + adjoint_A_y_4*minor_123_134 - adjoint_A_z_4*minor_123_124 + adjoint_minor_456_156*d_4_x
            + adjoint_minor_456_256*d_4_y + adjoint_minor_456_356*d_4_z;
        const lane adjoint_minor_23_23 =
            D_l_1_rx*adjoint_minor_123_234 + D_l_1_ry*adjoint_minor_123_235 + D_l_1_rz*adjoint_minor_123_236
            - adjoint_A_rx_1*minor_456_156 + adjoint_A_ry_1*minor_456_146 - adjoint_A_rz_1*minor_456_145
            + adjoint_A_x_1*minor_456_456 + adjoint_minor_123_123*d_1_x;
        const lane adjoint_D_l_6_rz =
            D_l_4_rx*adjoint_minor_46_46 + D_l_4_ry*adjoint_minor_46_56 + D_l_5_rx*adjoint_minor_56_46
            + D_l_5_ry*adjoint_minor_56_56 + adjoint_minor_46_16*d_4_x + adjoint_minor_46_26*d_4_y
            + adjoint_minor_46_36*d_4_z + adjoint_minor_56_16*d_5_x + adjoint_minor_56_26*d_5_y
            + adjoint_minor_56_36*d_5_z;
        const lane adjoint_D_l_6_ry =
            D_l_4_rx*adjoint_minor_46_45 - D_l_4_rz*adjoint_minor_46_56 + D_l_5_rx*adjoint_minor_56_45
            - D_l_5_rz*adjoint_minor_56_56 + adjoint_minor_46_15*d_4_x + adjoint_minor_46_25*d_4_y
            + adjoint_minor_46_35*d_4_z + adjoint_minor_56_15*d_5_x + adjoint_minor_56_25*d_5_y
            + adjoint_minor_56_35*d_5_z;
        const lane adjoint_D_l_6_rx =
            -D_l_4_ry*adjoint_minor_46_45 - D_l_4_rz*adjoint_minor_46_46 - D_l_5_ry*adjoint_minor_56_45
            - D_l_5_rz*adjoint_minor_56_46 + adjoint_minor_46_14*d_4_x + adjoint_minor_46_24*d_4_y
            + adjoint_minor_46_34*d_4_z + adjoint_minor_56_14*d_5_x + adjoint_minor_56_24*d_5_y
            + adjoint_minor_56_34*d_5_z;
        const lane adjoint_D_l_5_rz =
            D_l_4_rx*adjoint_minor_45_46 + D_l_4_ry*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_56_46
            - D_l_6_ry*adjoint_minor_56_56 + adjoint_minor_45_16*d_4_x + adjoint_minor_45_26*d_4_y
            + adjoint_minor_45_36*d_4_z - adjoint_minor_56_16*d_6_x - adjoint_minor_56_26*d_6_y
            - adjoint_minor_56_36*d_6_z;
        const lane adjoint_D_l_5_ry =
            D_l_4_rx*adjoint_minor_45_45 - D_l_4_rz*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_56_45
            + D_l_6_rz*adjoint_minor_56_56 + adjoint_minor_45_15*d_4_x + adjoint_minor_45_25*d_4_y
            + adjoint_minor_45_35*d_4_z - adjoint_minor_56_15*d_6_x - adjoint_minor_56_25*d_6_y
            - adjoint_minor_56_35*d_6_z;
        const lane adjoint_D_l_5_rx =
            -D_l_4_ry*adjoint_minor_45_45 - D_l_4_rz*adjoint_minor_45_46 + D_l_6_ry*adjoint_minor_56_45
            + D_l_6_rz*adjoint_minor_56_46 + adjoint_minor_45_14*d_4_x + adjoint_minor_45_24*d_4_y
            + adjoint_minor_45_34*d_4_z - adjoint_minor_56_14*d_6_x - adjoint_minor_56_24*d_6_y
            - adjoint_minor_56_34*d_6_z;
        const lane adjoint_D_l_4_rz =
            -D_l_5_rx*adjoint_minor_45_46 - D_l_5_ry*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_46_46
            - D_l_6_ry*adjoint_minor_46_56 + adjoint_minor_456_126*minor_56_12
            + adjoint_minor_456_136*minor_56_13 + adjoint_minor_456_146*minor_56_14
            + adjoint_minor_456_156*minor_56_15 + adjoint_minor_456_236*minor_56_23
            + adjoint_minor_456_246*minor_56_24 + adjoint_minor_456_256*minor_56_25
            + adjoint_minor_456_346*minor_56_34 + adjoint_minor_456_356*minor_56_35
            + adjoint_minor_456_456*minor_56_45 - adjoint_minor_45_16*d_5_x - adjoint_minor_45_26*d_5_y
            - adjoint_minor_45_36*d_5_z - adjoint_minor_46_16*d_6_x - adjoint_minor_46_26*d_6_y
            - adjoint_minor_46_36*d_6_z;
        const lane adjoint_D_l_4_ry =
            -D_l_5_rx*adjoint_minor_45_45 + D_l_5_rz*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_46_45
            + D_l_6_rz*adjoint_minor_46_56 + adjoint_minor_456_125*minor_56_12
            + adjoint_minor_456_135*minor_56_13 + adjoint_minor_456_145*minor_56_14
            - adjoint_minor_456_156*minor_56_16 + adjoint_minor_456_235*minor_56_23
            + adjoint_minor_456_245*minor_56_24 - adjoint_minor_456_256*minor_56_26
            + adjoint_minor_456_345*minor_56_34 - adjoint_minor_456_356*minor_56_36
            - adjoint_minor_456_456*minor_56_46 - adjoint_minor_45_15*d_5_x - adjoint_minor_45_25*d_5_y
            - adjoint_minor_45_35*d_5_z - adjoint_minor_46_15*d_6_x - adjoint_minor_46_25*d_6_y
            - adjoint_minor_46_35*d_6_z;
        const lane adjoint_D_l_4_rx =
            D_l_5_ry*adjoint_minor_45_45 + D_l_5_rz*adjoint_minor_45_46 + D_l_6_ry*adjoint_minor_46_45
            + D_l_6_rz*adjoint_minor_46_46 + adjoint_minor_456_124*minor_56_12
            + adjoint_minor_456_134*minor_56_13 - adjoint_minor_456_145*minor_56_15
            - adjoint_minor_456_146*minor_56_16 + adjoint_minor_456_234*minor_56_23
            - adjoint_minor_456_245*minor_56_25 - adjoint_minor_456_246*minor_56_26
            - adjoint_minor_456_345*minor_56_35 - adjoint_minor_456_346*minor_56_36
            + adjoint_minor_456_456*minor_56_56 - adjoint_minor_45_14*d_5_x - adjoint_minor_45_24*d_5_y
            - adjoint_minor_45_34*d_5_z - adjoint_minor_46_14*d_6_x - adjoint_minor_46_24*d_6_y
            - adjoint_minor_46_34*d_6_z;
        const lane adjoint_D_l_3_rz =
            D_l_1_rx*adjoint_minor_13_46 + D_l_1_ry*adjoint_minor_13_56 + D_l_2_rx*adjoint_minor_23_46
            + D_l_2_ry*adjoint_minor_23_56 + adjoint_minor_13_16*d_1_x + adjoint_minor_13_26*d_1_y
            + adjoint_minor_13_36*d_1_z + adjoint_minor_23_16*d_2_x + adjoint_minor_23_26*d_2_y
            + adjoint_minor_23_36*d_2_z;
        const lane adjoint_D_l_3_ry =
            D_l_1_rx*adjoint_minor_13_45 - D_l_1_rz*adjoint_minor_13_56 + D_l_2_rx*adjoint_minor_23_45
            - D_l_2_rz*adjoint_minor_23_56 + adjoint_minor_13_15*d_1_x + adjoint_minor_13_25*d_1_y
            + adjoint_minor_13_35*d_1_z + adjoint_minor_23_15*d_2_x + adjoint_minor_23_25*d_2_y
            + adjoint_minor_23_35*d_2_z;
        const lane adjoint_D_l_3_rx =
            -D_l_1_ry*adjoint_minor_13_45 - D_l_1_rz*adjoint_minor_13_46 - D_l_2_ry*adjoint_minor_23_45
            - D_l_2_rz*adjoint_minor_23_46 + adjoint_minor_13_14*d_1_x + adjoint_minor_13_24*d_1_y
            + adjoint_minor_13_34*d_1_z + adjoint_minor_23_14*d_2_x + adjoint_minor_23_24*d_2_y
            + adjoint_minor_23_34*d_2_z;
        const lane adjoint_D_l_2_rz =
            D_l_1_rx*adjoint_minor_12_46 + D_l_1_ry*adjoint_minor_12_56 - D_l_3_rx*adjoint_minor_23_46
            - D_l_3_ry*adjoint_minor_23_56 + adjoint_minor_12_16*d_1_x + adjoint_minor_12_26*d_1_y
            + adjoint_minor_12_36*d_1_z - adjoint_minor_23_16*d_3_x - adjoint_minor_23_26*d_3_y
            - adjoint_minor_23_36*d_3_z;
        const lane adjoint_D_l_2_ry =
            D_l_1_rx*adjoint_minor_12_45 - D_l_1_rz*adjoint_minor_12_56 - D_l_3_rx*adjoint_minor_23_45
            + D_l_3_rz*adjoint_minor_23_56 + adjoint_minor_12_15*d_1_x + adjoint_minor_12_25*d_1_y
            + adjoint_minor_12_35*d_1_z - adjoint_minor_23_15*d_3_x - adjoint_minor_23_25*d_3_y
            - adjoint_minor_23_35*d_3_z;
        const lane adjoint_D_l_2_rx =
            -D_l_1_ry*adjoint_minor_12_45 - D_l_1_rz*adjoint_minor_12_46 + D_l_3_ry*adjoint_minor_23_45
            + D_l_3_rz*adjoint_minor_23_46 + adjoint_minor_12_14*d_1_x + adjoint_minor_12_24*d_1_y
            + adjoint_minor_12_34*d_1_z - adjoint_minor_23_14*d_3_x - adjoint_minor_23_24*d_3_y
            - adjoint_minor_23_34*d_3_z;
        const lane adjoint_D_l_1_rz =
            A_rz_1*adjoint_det_D_l - D_l_2_rx*adjoint_minor_12_46 - D_l_2_ry*adjoint_minor_12_56
            - D_l_3_rx*adjoint_minor_13_46 - D_l_3_ry*adjoint_minor_13_56 + adjoint_minor_123_126*minor_23_12
            + adjoint_minor_123_136*minor_23_13 + adjoint_minor_123_146*minor_23_14
            + adjoint_minor_123_156*minor_23_15 + adjoint_minor_123_236*minor_23_23
            + adjoint_minor_123_246*minor_23_24 + adjoint_minor_123_256*minor_23_25
            + adjoint_minor_123_346*minor_23_34 + adjoint_minor_123_356*minor_23_35
            + adjoint_minor_123_456*minor_23_45 - adjoint_minor_12_16*d_2_x - adjoint_minor_12_26*d_2_y
            - adjoint_minor_12_36*d_2_z - adjoint_minor_13_16*d_3_x - adjoint_minor_13_26*d_3_y
            - adjoint_minor_13_36*d_3_z;
        const lane adjoint_D_l_1_ry =
            A_ry_1*adjoint_det_D_l - D_l_2_rx*adjoint_minor_12_45 + D_l_2_rz*adjoint_minor_12_56
            - D_l_3_rx*adjoint_minor_13_45 + D_l_3_rz*adjoint_minor_13_56 + adjoint_minor_123_125*minor_23_12
            + adjoint_minor_123_135*minor_23_13 + adjoint_minor_123_145*minor_23_14
            - adjoint_minor_123_156*minor_23_16 + adjoint_minor_123_235*minor_23_23
            + adjoint_minor_123_245*minor_23_24 - adjoint_minor_123_256*minor_23_26
            + adjoint_minor_123_345*minor_23_34 - adjoint_minor_123_356*minor_23_36
            - adjoint_minor_123_456*minor_23_46 - adjoint_minor_12_15*d_2_x - adjoint_minor_12_25*d_2_y
            - adjoint_minor_12_35*d_2_z - adjoint_minor_13_15*d_3_x - adjoint_minor_13_25*d_3_y
            - adjoint_minor_13_35*d_3_z;
        const lane adjoint_D_l_1_rx =
            A_rx_1*adjoint_det_D_l + D_l_2_ry*adjoint_minor_12_45 + D_l_2_rz*adjoint_minor_12_46
            + D_l_3_ry*adjoint_minor_13_45 + D_l_3_rz*adjoint_minor_13_46 + adjoint_minor_123_124*minor_23_12
            + adjoint_minor_123_134*minor_23_13 - adjoint_minor_123_145*minor_23_15
            - adjoint_minor_123_146*minor_23_16 + adjoint_minor_123_234*minor_23_23
            - adjoint_minor_123_245*minor_23_25 - adjoint_minor_123_246*minor_23_26
            - adjoint_minor_123_345*minor_23_35 - adjoint_minor_123_346*minor_23_36
            + adjoint_minor_123_456*minor_23_56 - adjoint_minor_12_14*d_2_x - adjoint_minor_12_24*d_2_y
            - adjoint_minor_12_34*d_2_z - adjoint_minor_13_14*d_3_x - adjoint_minor_13_24*d_3_y
            - adjoint_minor_13_34*d_3_z;
        const lane adjoint_m_lift_6 =
            B_6_y*adjoint_G_p_rz*g_x + B_6_z*adjoint_G_p_rx*g_y + adjoint_forward_t60*g_x
            + adjoint_forward_t67*g_y + adjoint_forward_t74*g_z;
        const lane adjoint_forward_t47 =
            adjoint_forward_t133*forward_20 + adjoint_m_lift_6*forward_21 + forward_34*t116;
        const lane adjoint_m_perp_6 =
            B_6_x*adjoint_M_p_y_rz + B_6_y*adjoint_forward_t177 + B_6_z*adjoint_forward_t170
            + adjoint_M_p_x_x + (1.0/2.0)*adjoint_forward_t199 + t351;
        const lane t432 = 2.0*adjoint_m_perp_6*t52;
        const lane adjoint_forward_t46 = adjoint_m_lift_6*forward_t47 - t432*t55;
        const lane adjoint_forward_t45 =
            adjoint_forward_t133*forward_t47 + adjoint_m_perp_6*(I_b_6 + I_r_6 + t51);
        const lane adjoint_m_lift_5 =
            B_5_y*adjoint_G_p_rz*g_x + B_5_z*adjoint_G_p_rx*g_y + adjoint_forward_t59*g_x
            + adjoint_forward_t66*g_y + adjoint_forward_t73*g_z;
        const lane adjoint_forward_t44 =
            adjoint_forward_t131*forward_18 + adjoint_m_lift_5*forward_19 + forward_33*t118;
        const lane adjoint_m_perp_5 =
            B_5_x*adjoint_M_p_y_rz + B_5_y*adjoint_forward_t176 + B_5_z*adjoint_forward_t169
            + adjoint_M_p_x_x + (1.0/2.0)*adjoint_forward_t196 + t353;
        const lane t433 = 2.0*adjoint_m_perp_5*t46;
        const lane adjoint_forward_t43 = adjoint_m_lift_5*forward_t44 - t433*t49;
        const lane adjoint_forward_t42 =
            adjoint_forward_t131*forward_t44 + adjoint_m_perp_5*(I_b_5 + I_r_5 + t45);
        const lane adjoint_m_lift_4 =
            B_4_y*adjoint_G_p_rz*g_x + B_4_z*adjoint_G_p_rx*g_y + adjoint_forward_t58*g_x
            + adjoint_forward_t65*g_y + adjoint_forward_t72*g_z;
        const lane adjoint_forward_t41 =
            adjoint_forward_t129*forward_16 + adjoint_m_lift_4*forward_17 + forward_32*t120;
        const lane adjoint_m_perp_4 =
            B_4_x*adjoint_M_p_y_rz + B_4_y*adjoint_forward_t175 + B_4_z*adjoint_forward_t168
            + adjoint_M_p_x_x + (1.0/2.0)*adjoint_forward_t193 + t359;
        const lane t434 = 2.0*adjoint_m_perp_4*t40;
        const lane adjoint_forward_t40 = adjoint_m_lift_4*forward_t41 - t43*t434;
        const lane adjoint_forward_t39 =
            adjoint_forward_t129*forward_t41 + adjoint_m_perp_4*(I_b_4 + I_r_4 + t39);
        const lane adjoint_m_lift_3 =
            B_3_y*adjoint_G_p_rz*g_x + B_3_z*adjoint_G_p_rx*g_y + adjoint_forward_t57*g_x
            + adjoint_forward_t64*g_y + adjoint_forward_t71*g_z;
        const lane adjoint_forward_t38 =
            adjoint_forward_t127*forward_14 + adjoint_m_lift_3*forward_15 + forward_31*t122;
        const lane adjoint_m_perp_3 =
            B_3_x*adjoint_M_p_y_rz + B_3_y*adjoint_forward_t174 + B_3_z*adjoint_forward_t167
            + adjoint_M_p_x_x + (1.0/2.0)*adjoint_forward_t190 + t363;
        const lane t435 = 2.0*adjoint_m_perp_3*t34;
        const lane adjoint_forward_t37 = adjoint_m_lift_3*forward_t38 - t37*t435;
        const lane adjoint_forward_t36 =
            adjoint_forward_t127*forward_t38 + adjoint_m_perp_3*(I_b_3 + I_r_3 + t33);
        const lane adjoint_m_lift_2 =
            B_2_y*adjoint_G_p_rz*g_x + B_2_z*adjoint_G_p_rx*g_y + adjoint_forward_t56*g_x
            + adjoint_forward_t63*g_y + adjoint_forward_t70*g_z;
        const lane adjoint_forward_t35 =
            adjoint_forward_t125*forward_12 + adjoint_m_lift_2*forward_13 + forward_30*t124;
        const lane adjoint_m_perp_2 =
            B_2_x*adjoint_M_p_y_rz + B_2_y*adjoint_forward_t173 + B_2_z*adjoint_forward_t166
            + adjoint_M_p_x_x + (1.0/2.0)*adjoint_forward_t187 + t367;
        const lane t436 = 2.0*adjoint_m_perp_2*t28;
        const lane adjoint_forward_t34 = adjoint_m_lift_2*forward_t35 - t31*t436;
        const lane adjoint_forward_t33 =
            adjoint_forward_t125*forward_t35 + adjoint_m_perp_2*(I_b_2 + I_r_2 + t27);
        const lane adjoint_m_lift_1 =
            B_1_y*adjoint_G_p_rz*g_x + B_1_z*adjoint_G_p_rx*g_y + adjoint_forward_t55*g_x
            + adjoint_forward_t62*g_y + adjoint_forward_t69*g_z;
        const lane adjoint_forward_t32 =
            adjoint_forward_t123*forward_10 + adjoint_m_lift_1*forward_11 + forward_29*t126;
        const lane adjoint_m_perp_1 =
            B_1_x*adjoint_M_p_y_rz + B_1_y*adjoint_forward_t172 + B_1_z*adjoint_forward_t165
            + adjoint_M_p_x_x + (1.0/2.0)*adjoint_forward_t184 + t370;
        const lane t437 = 2.0*adjoint_m_perp_1*t22;
        const lane adjoint_forward_t31 = adjoint_m_lift_1*forward_t32 - t25*t437;
        const lane adjoint_forward_t30 =
            adjoint_forward_t123*forward_t32 + adjoint_m_perp_1*(I_b_1 + I_r_1 + t21);
        const lane adjoint_forward_t29 = adjoint_M_p_rz_rz*t438;
        const lane t439 = R_y_z*adjoint_M_p_ry_rz;
        const lane adjoint_forward_t28 = adjoint_M_p_rz_rz*forward_t29 + t439;
        const lane t440 = R_y_y*adjoint_M_p_ry_rz;
        const lane t441 = 2.0*adjoint_M_p_rz_rz;
        const lane adjoint_forward_t26 = R_z_y*t441 + t440;
        const lane adjoint_forward_t25 = R_z_z*adjoint_M_p_ry_rz + adjoint_M_p_ry_ry*forward_t24;
        const lane adjoint_forward_t24 = adjoint_M_p_ry_ry*t442;
        const lane t443 = 2.0*adjoint_M_p_ry_ry;
        const lane adjoint_forward_t22 = R_y_y*t443 + R_z_y*adjoint_M_p_ry_rz;
        const lane adjoint_forward_t21 = R_y_z*adjoint_M_p_rx_ry + R_z_z*adjoint_M_p_rx_rz;
        const lane adjoint_forward_t20 = R_y_y*adjoint_M_p_rx_ry + R_z_y*adjoint_M_p_rx_rz;
        const lane adjoint_forward_t18 = R_y_x*adjoint_M_p_rx_ry + R_z_x*adjoint_M_p_rx_rz;
        const lane adjoint_forward_t15 = adjoint_M_p_rx_rx*forward_t14 + adjoint_forward_t21;
        const lane adjoint_forward_t14 = adjoint_M_p_rx_rx*t444;
        const lane t445 = 2.0*adjoint_M_p_rx_rx;
        const lane adjoint_forward_t12 = R_x_y*t445 + adjoint_forward_t20;
        const lane t446 = (1.0/2.0)*adjoint_L_ry_rz;
        const lane adjoint_c_z =
            adjoint_G_p_rx*forward_t68 - adjoint_G_p_ry*forward_t61 + adjoint_L_rx_rz*forward_t115
            + adjoint_forward_t101*g_10_z + adjoint_forward_t171*m_p + 4.0*adjoint_forward_t180*c_z
            + g_10_y*t446;
        const lane adjoint_c_y =
            -adjoint_G_p_rx*forward_t75 + adjoint_G_p_rz*forward_t61 + adjoint_L_rx_ry*forward_t115
            - adjoint_M_p_ry_rz*forward_t171 + adjoint_forward_t178*m_p + 4.0*adjoint_forward_t179*c_y
            + adjoint_forward_t94*g_10_y + g_10_z*t446;
        const lane adjoint_c_x =
            adjoint_G_p_ry*forward_t75 - adjoint_G_p_rz*forward_t68 - adjoint_M_p_rx_ry*forward_t178
            - adjoint_M_p_rx_rz*forward_t171 + adjoint_M_p_y_rz*m_p + (1.0/2.0)*adjoint_forward_t114
            + adjoint_forward_t122*g_10_x + 4.0*adjoint_forward_t200*c_x;
        const lane adjoint_l_6 =
            -3.0*adjoint_forward_34/(forward_9*forward_9*forward_9*forward_9)
            - 2.0*adjoint_forward_t45*forward_34 - adjoint_forward_t46*(forward_21*forward_21)
            + adjoint_forward_t54*forward_22;
        const lane adjoint_l_5 =
            -3.0*adjoint_forward_33/(forward_8*forward_8*forward_8*forward_8)
            - 2.0*adjoint_forward_t42*forward_33 - adjoint_forward_t43*(forward_19*forward_19)
            + adjoint_forward_t53*forward_22;
        const lane adjoint_l_4 =
            -3.0*adjoint_forward_32/(forward_7*forward_7*forward_7*forward_7)
            - 2.0*adjoint_forward_t39*forward_32 - adjoint_forward_t40*(forward_17*forward_17)
            + adjoint_forward_t52*forward_22;
        const lane adjoint_l_3 =
            -3.0*adjoint_forward_31/(forward_6*forward_6*forward_6*forward_6)
            - 2.0*adjoint_forward_t36*forward_31 - adjoint_forward_t37*(forward_15*forward_15)
            + adjoint_forward_t51*forward_22;
        const lane adjoint_l_2 =
            -3.0*adjoint_forward_30/(forward_5*forward_5*forward_5*forward_5)
            - 2.0*adjoint_forward_t33*forward_30 - adjoint_forward_t34*(forward_13*forward_13)
            + adjoint_forward_t50*forward_22;
        const lane adjoint_l_1 =
            -3.0*adjoint_forward_29/(forward_4*forward_4*forward_4*forward_4)
            - 2.0*adjoint_forward_t30*forward_29 - adjoint_forward_t31*(forward_11*forward_11)
            + adjoint_forward_t49*forward_22;
        const lane t448 = forward_34*forward_t47*t115;
        const lane adjoint_d_6_z =
            -B_6_x*adjoint_D_l_6_ry + B_6_y*adjoint_D_l_6_rx - D_l_4_rx*adjoint_minor_46_34
            - D_l_4_ry*adjoint_minor_46_35 - D_l_4_rz*adjoint_minor_46_36 - D_l_5_rx*adjoint_minor_56_34
            - D_l_5_ry*adjoint_minor_56_35 - D_l_5_rz*adjoint_minor_56_36 - adjoint_g_9_z*mu_6
            + adjoint_l_6*d_6_z*t449 + adjoint_minor_46_13*d_4_x + adjoint_minor_46_23*d_4_y
            + adjoint_minor_56_13*d_5_x + adjoint_minor_56_23*d_5_y - t447*t448;
        const lane adjoint_B_6_z =
            2.0*B_6_z*adjoint_forward_t100 - adjoint_D_l_6_rx*d_6_y + adjoint_D_l_6_ry*d_6_x
            + adjoint_G_p_rx*forward_t67 - adjoint_G_p_ry*forward_t60 + adjoint_L_rx_rz*forward_t113
            + adjoint_d_6_z + adjoint_forward_t101*g_9_z + adjoint_forward_t152*forward_t140
            - adjoint_forward_t158*forward_t134 + adjoint_forward_t170*m_perp_6 + adjoint_forward_t81*mu_6
            + g_9_y*t446;
        const lane t450 = 2.0*t448;
        const lane adjoint_d_6_y =
            B_6_x*adjoint_D_l_6_rz - B_6_z*adjoint_D_l_6_rx - D_l_4_rx*adjoint_minor_46_24
            - D_l_4_ry*adjoint_minor_46_25 - D_l_4_rz*adjoint_minor_46_26 - D_l_5_rx*adjoint_minor_56_24
            - D_l_5_ry*adjoint_minor_56_25 - D_l_5_rz*adjoint_minor_56_26 - adjoint_g_9_y*mu_6
            + adjoint_l_6*d_6_y*t449 + adjoint_minor_46_12*d_4_x - adjoint_minor_46_23*d_4_z
            + adjoint_minor_56_12*d_5_x - adjoint_minor_56_23*d_5_z - g_y*t450;
        const lane adjoint_B_6_y =
            2.0*B_6_y*adjoint_forward_t91 + adjoint_D_l_6_rx*d_6_z - adjoint_D_l_6_rz*d_6_x
            - adjoint_G_p_rx*forward_t74 + adjoint_G_p_rz*forward_t60 + adjoint_L_rx_ry*forward_t113
            + adjoint_L_ry_rz*(forward_t81 + t62) - adjoint_M_p_ry_rz*forward_t170 + adjoint_d_6_y
            - adjoint_forward_t152*forward_t146 + adjoint_forward_t164*forward_t134
            + adjoint_forward_t177*m_perp_6 + adjoint_forward_t87*mu_6 + adjoint_forward_t94*g_9_y;
        const lane adjoint_d_6_x =
            -B_6_y*adjoint_D_l_6_rz + B_6_z*adjoint_D_l_6_ry - D_l_4_rx*adjoint_minor_46_14
            - D_l_4_ry*adjoint_minor_46_15 - D_l_4_rz*adjoint_minor_46_16 - D_l_5_rx*adjoint_minor_56_14
            - D_l_5_ry*adjoint_minor_56_15 - D_l_5_rz*adjoint_minor_56_16 - adjoint_g_9_x*mu_6
            + adjoint_l_6*d_6_x*t449 - adjoint_minor_46_12*d_4_y - adjoint_minor_46_13*d_4_z
            - adjoint_minor_56_12*d_5_y - adjoint_minor_56_13*d_5_z - g_x*t450;
        const lane adjoint_B_6_x =
            2.0*B_6_x*adjoint_forward_t121 - adjoint_D_l_6_ry*d_6_z + adjoint_D_l_6_rz*d_6_y
            + adjoint_G_p_ry*forward_t74 - adjoint_G_p_rz*forward_t67 + adjoint_L_rx_ry*forward_t87
            + adjoint_L_rx_rz*forward_t81 + adjoint_L_z_ry*mu_6 - adjoint_M_p_rx_ry*forward_t177
            - adjoint_M_p_rx_rz*forward_t170 + adjoint_M_p_y_rz*m_perp_6 + adjoint_d_6_x
            + (1.0/2.0)*adjoint_forward_t112 + adjoint_forward_t122*g_9_x + adjoint_forward_t158*forward_t146
            - adjoint_forward_t164*forward_t140;
        const lane t451 = forward_33*forward_t44*t117;
        const lane adjoint_d_5_z =
            -B_5_x*adjoint_D_l_5_ry + B_5_y*adjoint_D_l_5_rx - D_l_4_rx*adjoint_minor_45_34
            - D_l_4_ry*adjoint_minor_45_35 - D_l_4_rz*adjoint_minor_45_36 + D_l_6_rx*adjoint_minor_56_34
            + D_l_6_ry*adjoint_minor_56_35 + D_l_6_rz*adjoint_minor_56_36 - adjoint_g_8_z*mu_5
            + adjoint_l_5*d_5_z*t452 + adjoint_minor_45_13*d_4_x + adjoint_minor_45_23*d_4_y
            - adjoint_minor_56_13*d_6_x - adjoint_minor_56_23*d_6_y - t447*t451;
        const lane adjoint_B_5_z =
            2.0*B_5_z*adjoint_forward_t99 - adjoint_D_l_5_rx*d_5_y + adjoint_D_l_5_ry*d_5_x
            + adjoint_G_p_rx*forward_t66 - adjoint_G_p_ry*forward_t59 + adjoint_L_rx_rz*forward_t111
            + adjoint_d_5_z + adjoint_forward_t101*g_8_z + adjoint_forward_t151*forward_t139
            - adjoint_forward_t157*forward_t132 + adjoint_forward_t169*m_perp_5 + adjoint_forward_t80*mu_5
            + g_8_y*t446;
        const lane t453 = 2.0*t451;
        const lane adjoint_d_5_y =
            B_5_x*adjoint_D_l_5_rz - B_5_z*adjoint_D_l_5_rx - D_l_4_rx*adjoint_minor_45_24
            - D_l_4_ry*adjoint_minor_45_25 - D_l_4_rz*adjoint_minor_45_26 + D_l_6_rx*adjoint_minor_56_24
            + D_l_6_ry*adjoint_minor_56_25 + D_l_6_rz*adjoint_minor_56_26 - adjoint_g_8_y*mu_5
            + adjoint_l_5*d_5_y*t452 + adjoint_minor_45_12*d_4_x - adjoint_minor_45_23*d_4_z
            - adjoint_minor_56_12*d_6_x + adjoint_minor_56_23*d_6_z - g_y*t453;
        const lane adjoint_B_5_y =
            2.0*B_5_y*adjoint_forward_t90 + adjoint_D_l_5_rx*d_5_z - adjoint_D_l_5_rz*d_5_x
            - adjoint_G_p_rx*forward_t73 + adjoint_G_p_rz*forward_t59 + adjoint_L_rx_ry*forward_t111
            + adjoint_L_ry_rz*(forward_t80 + t74) - adjoint_M_p_ry_rz*forward_t169 + adjoint_d_5_y
            - adjoint_forward_t151*forward_t145 + adjoint_forward_t163*forward_t132
            + adjoint_forward_t176*m_perp_5 + adjoint_forward_t86*mu_5 + adjoint_forward_t94*g_8_y;
        const lane adjoint_d_5_x =
            -B_5_y*adjoint_D_l_5_rz + B_5_z*adjoint_D_l_5_ry - D_l_4_rx*adjoint_minor_45_14
            - D_l_4_ry*adjoint_minor_45_15 - D_l_4_rz*adjoint_minor_45_16 + D_l_6_rx*adjoint_minor_56_14
            + D_l_6_ry*adjoint_minor_56_15 + D_l_6_rz*adjoint_minor_56_16 - adjoint_g_8_x*mu_5
            + adjoint_l_5*d_5_x*t452 - adjoint_minor_45_12*d_4_y - adjoint_minor_45_13*d_4_z
            + adjoint_minor_56_12*d_6_y + adjoint_minor_56_13*d_6_z - g_x*t453;
        const lane adjoint_B_5_x =
            2.0*B_5_x*adjoint_forward_t120 - adjoint_D_l_5_ry*d_5_z + adjoint_D_l_5_rz*d_5_y
            + adjoint_G_p_ry*forward_t73 - adjoint_G_p_rz*forward_t66 + adjoint_L_rx_ry*forward_t86
            + adjoint_L_rx_rz*forward_t80 + adjoint_L_z_ry*mu_5 - adjoint_M_p_rx_ry*forward_t176
            - adjoint_M_p_rx_rz*forward_t169 + adjoint_M_p_y_rz*m_perp_5 + adjoint_d_5_x
            + (1.0/2.0)*adjoint_forward_t110 + adjoint_forward_t122*g_8_x + adjoint_forward_t157*forward_t145
            - adjoint_forward_t163*forward_t139;
        const lane t454 = forward_32*forward_t41*t119;
        const lane adjoint_d_4_z =
            -B_4_x*adjoint_D_l_4_ry + B_4_y*adjoint_D_l_4_rx + D_l_5_rx*adjoint_minor_45_34
            + D_l_5_ry*adjoint_minor_45_35 + D_l_5_rz*adjoint_minor_45_36 + D_l_6_rx*adjoint_minor_46_34
            + D_l_6_ry*adjoint_minor_46_35 + D_l_6_rz*adjoint_minor_46_36 - adjoint_g_7_z*mu_4
            + adjoint_l_4*d_4_z*t455 + adjoint_minor_456_123*minor_56_12 - adjoint_minor_456_134*minor_56_14
            - adjoint_minor_456_135*minor_56_15 - adjoint_minor_456_136*minor_56_16
            - adjoint_minor_456_234*minor_56_24 - adjoint_minor_456_235*minor_56_25
            - adjoint_minor_456_236*minor_56_26 + adjoint_minor_456_345*minor_56_45
            + adjoint_minor_456_346*minor_56_46 + adjoint_minor_456_356*minor_56_56
            - adjoint_minor_45_13*d_5_x - adjoint_minor_45_23*d_5_y - adjoint_minor_46_13*d_6_x
            - adjoint_minor_46_23*d_6_y - t447*t454;
        const lane adjoint_B_4_z =
            2.0*B_4_z*adjoint_forward_t98 - adjoint_D_l_4_rx*d_4_y + adjoint_D_l_4_ry*d_4_x
            + adjoint_G_p_rx*forward_t65 - adjoint_G_p_ry*forward_t58 + adjoint_L_rx_rz*forward_t109
            + adjoint_d_4_z + adjoint_forward_t101*g_7_z + adjoint_forward_t150*forward_t138
            - adjoint_forward_t156*forward_t130 + adjoint_forward_t168*m_perp_4 + adjoint_forward_t79*mu_4
            + g_7_y*t446;
        const lane t456 = 2.0*t454;
        const lane t457 = adjoint_l_4*t455;
        const lane adjoint_d_4_y =
            B_4_x*adjoint_D_l_4_rz - B_4_z*adjoint_D_l_4_rx + D_l_5_rx*adjoint_minor_45_24
            + D_l_5_ry*adjoint_minor_45_25 + D_l_5_rz*adjoint_minor_45_26 + D_l_6_rx*adjoint_minor_46_24
            + D_l_6_ry*adjoint_minor_46_25 + D_l_6_rz*adjoint_minor_46_26 - adjoint_g_7_y*mu_4
            - adjoint_minor_456_123*minor_56_13 - adjoint_minor_456_124*minor_56_14
            - adjoint_minor_456_125*minor_56_15 - adjoint_minor_456_126*minor_56_16
            + adjoint_minor_456_234*minor_56_34 + adjoint_minor_456_235*minor_56_35
            + adjoint_minor_456_236*minor_56_36 + adjoint_minor_456_245*minor_56_45
            + adjoint_minor_456_246*minor_56_46 + adjoint_minor_456_256*minor_56_56
            - adjoint_minor_45_12*d_5_x + adjoint_minor_45_23*d_5_z - adjoint_minor_46_12*d_6_x
            + adjoint_minor_46_23*d_6_z + d_4_y*t457 - g_y*t456;
        const lane adjoint_B_4_y =
            2.0*B_4_y*adjoint_forward_t89 + adjoint_D_l_4_rx*d_4_z - adjoint_D_l_4_rz*d_4_x
            - adjoint_G_p_rx*forward_t72 + adjoint_G_p_rz*forward_t58 + adjoint_L_rx_ry*forward_t109
            + adjoint_L_ry_rz*(forward_t79 + t72) - adjoint_M_p_ry_rz*forward_t168 + adjoint_d_4_y
            - adjoint_forward_t150*forward_t144 + adjoint_forward_t162*forward_t130
            + adjoint_forward_t175*m_perp_4 + adjoint_forward_t85*mu_4 + adjoint_forward_t94*g_7_y;
        const lane adjoint_d_4_x =
            -B_4_y*adjoint_D_l_4_rz + B_4_z*adjoint_D_l_4_ry + D_l_5_rx*adjoint_minor_45_14
            + D_l_5_ry*adjoint_minor_45_15 + D_l_5_rz*adjoint_minor_45_16 + D_l_6_rx*adjoint_minor_46_14
            + D_l_6_ry*adjoint_minor_46_15 + D_l_6_rz*adjoint_minor_46_16 - adjoint_g_7_x*mu_4
            + adjoint_minor_456_123*minor_56_23 + adjoint_minor_456_124*minor_56_24
            + adjoint_minor_456_125*minor_56_25 + adjoint_minor_456_126*minor_56_26
            + adjoint_minor_456_134*minor_56_34 + adjoint_minor_456_135*minor_56_35
            + adjoint_minor_456_136*minor_56_36 + adjoint_minor_456_145*minor_56_45
            + adjoint_minor_456_146*minor_56_46 + adjoint_minor_456_156*minor_56_56
            + adjoint_minor_45_12*d_5_y + adjoint_minor_45_13*d_5_z + adjoint_minor_46_12*d_6_y
            + adjoint_minor_46_13*d_6_z + d_4_x*t457 - g_x*t456;
        const lane adjoint_B_4_x =
            2.0*B_4_x*adjoint_forward_t119 - adjoint_D_l_4_ry*d_4_z + adjoint_D_l_4_rz*d_4_y
            + adjoint_G_p_ry*forward_t72 - adjoint_G_p_rz*forward_t65 + adjoint_L_rx_ry*forward_t85
            + adjoint_L_rx_rz*forward_t79 + adjoint_L_z_ry*mu_4 - adjoint_M_p_rx_ry*forward_t175
            - adjoint_M_p_rx_rz*forward_t168 + adjoint_M_p_y_rz*m_perp_4 + adjoint_d_4_x
            + (1.0/2.0)*adjoint_forward_t108 + adjoint_forward_t122*g_7_x + adjoint_forward_t156*forward_t144
            - adjoint_forward_t162*forward_t138;
        const lane t458 = forward_31*forward_t38*t121;
        const lane adjoint_d_3_z =
            -B_3_x*adjoint_D_l_3_ry + B_3_y*adjoint_D_l_3_rx - D_l_1_rx*adjoint_minor_13_34
            - D_l_1_ry*adjoint_minor_13_35 - D_l_1_rz*adjoint_minor_13_36 - D_l_2_rx*adjoint_minor_23_34
            - D_l_2_ry*adjoint_minor_23_35 - D_l_2_rz*adjoint_minor_23_36 - adjoint_g_6_z*mu_3
            + adjoint_l_3*d_3_z*t459 + adjoint_minor_13_13*d_1_x + adjoint_minor_13_23*d_1_y
            + adjoint_minor_23_13*d_2_x + adjoint_minor_23_23*d_2_y - t447*t458;
        const lane adjoint_B_3_z =
            2.0*B_3_z*adjoint_forward_t97 - adjoint_D_l_3_rx*d_3_y + adjoint_D_l_3_ry*d_3_x
            + adjoint_G_p_rx*forward_t64 - adjoint_G_p_ry*forward_t57 + adjoint_L_rx_rz*forward_t107
            + adjoint_d_3_z + adjoint_forward_t101*g_6_z + adjoint_forward_t149*forward_t137
            - adjoint_forward_t155*forward_t128 + adjoint_forward_t167*m_perp_3 + adjoint_forward_t78*mu_3
            + g_6_y*t446;
        const lane t460 = 2.0*t458;
        const lane adjoint_d_3_y =
            B_3_x*adjoint_D_l_3_rz - B_3_z*adjoint_D_l_3_rx - D_l_1_rx*adjoint_minor_13_24
            - D_l_1_ry*adjoint_minor_13_25 - D_l_1_rz*adjoint_minor_13_26 - D_l_2_rx*adjoint_minor_23_24
            - D_l_2_ry*adjoint_minor_23_25 - D_l_2_rz*adjoint_minor_23_26 - adjoint_g_6_y*mu_3
            + adjoint_l_3*d_3_y*t459 + adjoint_minor_13_12*d_1_x - adjoint_minor_13_23*d_1_z
            + adjoint_minor_23_12*d_2_x - adjoint_minor_23_23*d_2_z - g_y*t460;
        const lane adjoint_B_3_y =
            2.0*B_3_y*adjoint_forward_t88 + adjoint_D_l_3_rx*d_3_z - adjoint_D_l_3_rz*d_3_x
            - adjoint_G_p_rx*forward_t71 + adjoint_G_p_rz*forward_t57 + adjoint_L_rx_ry*forward_t107
            + adjoint_L_ry_rz*(forward_t78 + t70) - adjoint_M_p_ry_rz*forward_t167 + adjoint_d_3_y
            - adjoint_forward_t149*forward_t143 + adjoint_forward_t161*forward_t128
            + adjoint_forward_t174*m_perp_3 + adjoint_forward_t84*mu_3 + adjoint_forward_t94*g_6_y;
        const lane adjoint_d_3_x =
            -B_3_y*adjoint_D_l_3_rz + B_3_z*adjoint_D_l_3_ry - D_l_1_rx*adjoint_minor_13_14
            - D_l_1_ry*adjoint_minor_13_15 - D_l_1_rz*adjoint_minor_13_16 - D_l_2_rx*adjoint_minor_23_14
            - D_l_2_ry*adjoint_minor_23_15 - D_l_2_rz*adjoint_minor_23_16 - adjoint_g_6_x*mu_3
            + adjoint_l_3*d_3_x*t459 - adjoint_minor_13_12*d_1_y - adjoint_minor_13_13*d_1_z
            - adjoint_minor_23_12*d_2_y - adjoint_minor_23_13*d_2_z - g_x*t460;
        const lane adjoint_B_3_x =
            2.0*B_3_x*adjoint_forward_t118 - adjoint_D_l_3_ry*d_3_z + adjoint_D_l_3_rz*d_3_y
            + adjoint_G_p_ry*forward_t71 - adjoint_G_p_rz*forward_t64 + adjoint_L_rx_ry*forward_t84
            + adjoint_L_rx_rz*forward_t78 + adjoint_L_z_ry*mu_3 - adjoint_M_p_rx_ry*forward_t174
            - adjoint_M_p_rx_rz*forward_t167 + adjoint_M_p_y_rz*m_perp_3 + adjoint_d_3_x
            + (1.0/2.0)*adjoint_forward_t106 + adjoint_forward_t122*g_6_x + adjoint_forward_t155*forward_t143
            - adjoint_forward_t161*forward_t137;
        const lane t461 = forward_30*forward_t35*t123;
        const lane adjoint_d_2_z =
            -B_2_x*adjoint_D_l_2_ry + B_2_y*adjoint_D_l_2_rx - D_l_1_rx*adjoint_minor_12_34
            - D_l_1_ry*adjoint_minor_12_35 - D_l_1_rz*adjoint_minor_12_36 + D_l_3_rx*adjoint_minor_23_34
            + D_l_3_ry*adjoint_minor_23_35 + D_l_3_rz*adjoint_minor_23_36 - adjoint_g_5_z*mu_2
            + adjoint_l_2*d_2_z*t462 + adjoint_minor_12_13*d_1_x + adjoint_minor_12_23*d_1_y
            - adjoint_minor_23_13*d_3_x - adjoint_minor_23_23*d_3_y - t447*t461;
        const lane adjoint_B_2_z =
            2.0*B_2_z*adjoint_forward_t96 - adjoint_D_l_2_rx*d_2_y + adjoint_D_l_2_ry*d_2_x
            + adjoint_G_p_rx*forward_t63 - adjoint_G_p_ry*forward_t56 + adjoint_L_rx_rz*forward_t105
            + adjoint_d_2_z + adjoint_forward_t101*g_5_z + adjoint_forward_t148*forward_t136
            - adjoint_forward_t154*forward_t126 + adjoint_forward_t166*m_perp_2 + adjoint_forward_t77*mu_2
            + g_5_y*t446;
        const lane t463 = 2.0*t461;
        const lane adjoint_d_2_y =
            B_2_x*adjoint_D_l_2_rz - B_2_z*adjoint_D_l_2_rx - D_l_1_rx*adjoint_minor_12_24
            - D_l_1_ry*adjoint_minor_12_25 - D_l_1_rz*adjoint_minor_12_26 + D_l_3_rx*adjoint_minor_23_24
            + D_l_3_ry*adjoint_minor_23_25 + D_l_3_rz*adjoint_minor_23_26 - adjoint_g_5_y*mu_2
            + adjoint_l_2*d_2_y*t462 + adjoint_minor_12_12*d_1_x - adjoint_minor_12_23*d_1_z
            - adjoint_minor_23_12*d_3_x + adjoint_minor_23_23*d_3_z - g_y*t463;
        const lane adjoint_B_2_y =
            2.0*B_2_y*adjoint_forward_t93 + adjoint_D_l_2_rx*d_2_z - adjoint_D_l_2_rz*d_2_x
            - adjoint_G_p_rx*forward_t70 + adjoint_G_p_rz*forward_t56 + adjoint_L_rx_ry*forward_t105
            + adjoint_L_ry_rz*(forward_t77 + t68) - adjoint_M_p_ry_rz*forward_t166 + adjoint_d_2_y
            - adjoint_forward_t148*forward_t142 + adjoint_forward_t160*forward_t126
            + adjoint_forward_t173*m_perp_2 + adjoint_forward_t83*mu_2 + adjoint_forward_t94*g_5_y;
        const lane adjoint_d_2_x =
            -B_2_y*adjoint_D_l_2_rz + B_2_z*adjoint_D_l_2_ry - D_l_1_rx*adjoint_minor_12_14
            - D_l_1_ry*adjoint_minor_12_15 - D_l_1_rz*adjoint_minor_12_16 + D_l_3_rx*adjoint_minor_23_14
            + D_l_3_ry*adjoint_minor_23_15 + D_l_3_rz*adjoint_minor_23_16 - adjoint_g_5_x*mu_2
            + adjoint_l_2*d_2_x*t462 - adjoint_minor_12_12*d_1_y - adjoint_minor_12_13*d_1_z
            + adjoint_minor_23_12*d_3_y + adjoint_minor_23_13*d_3_z - g_x*t463;
        const lane adjoint_B_2_x =
            2.0*B_2_x*adjoint_forward_t117 - adjoint_D_l_2_ry*d_2_z + adjoint_D_l_2_rz*d_2_y
            + adjoint_G_p_ry*forward_t70 - adjoint_G_p_rz*forward_t63 + adjoint_L_rx_ry*forward_t83
            + adjoint_L_rx_rz*forward_t77 + adjoint_L_z_ry*mu_2 - adjoint_M_p_rx_ry*forward_t173
            - adjoint_M_p_rx_rz*forward_t166 + adjoint_M_p_y_rz*m_perp_2 + adjoint_d_2_x
            + (1.0/2.0)*adjoint_forward_t104 + adjoint_forward_t122*g_5_x + adjoint_forward_t154*forward_t142
            - adjoint_forward_t160*forward_t136;
        const lane t464 = forward_29*forward_t32*t125;
        const lane t465 = adjoint_l_1/forward_4;
        const lane adjoint_d_1_z =
            A_z_1*adjoint_det_D_l - B_1_x*adjoint_D_l_1_ry + B_1_y*adjoint_D_l_1_rx
            + D_l_2_rx*adjoint_minor_12_34 + D_l_2_ry*adjoint_minor_12_35 + D_l_2_rz*adjoint_minor_12_36
            + D_l_3_rx*adjoint_minor_13_34 + D_l_3_ry*adjoint_minor_13_35 + D_l_3_rz*adjoint_minor_13_36
            - adjoint_g_4_z*mu_1 + adjoint_minor_123_123*minor_23_12 - adjoint_minor_123_134*minor_23_14
            - adjoint_minor_123_135*minor_23_15 - adjoint_minor_123_136*minor_23_16
            - adjoint_minor_123_234*minor_23_24 - adjoint_minor_123_235*minor_23_25
            - adjoint_minor_123_236*minor_23_26 + adjoint_minor_123_345*minor_23_45
            + adjoint_minor_123_346*minor_23_46 + adjoint_minor_123_356*minor_23_56
            - adjoint_minor_12_13*d_2_x - adjoint_minor_12_23*d_2_y - adjoint_minor_13_13*d_3_x
            - adjoint_minor_13_23*d_3_y + d_1_z*t465 - t447*t464;
        const lane adjoint_B_1_z =
            2.0*B_1_z*adjoint_forward_t95 - adjoint_D_l_1_rx*d_1_y + adjoint_D_l_1_ry*d_1_x
            + adjoint_G_p_rx*forward_t62 - adjoint_G_p_ry*forward_t55 + adjoint_L_rx_rz*forward_t103
            + adjoint_d_1_z + adjoint_forward_t101*g_4_z + adjoint_forward_t147*forward_t135
            - adjoint_forward_t153*forward_t124 + adjoint_forward_t165*m_perp_1 + adjoint_forward_t76*mu_1
            + g_4_y*t446;
        const lane adjoint_R_z_z =
            I_p_z*adjoint_M_p_rz_rz*forward_t29 + adjoint_B_1_z*b_1_z + adjoint_B_2_z*b_2_z
            + adjoint_B_3_z*b_3_z + adjoint_B_4_z*b_4_z + adjoint_B_5_z*b_5_z + adjoint_B_6_z*b_6_z
            + adjoint_M_p_rx_rz*t466 + adjoint_M_p_ry_rz*(t15 + t442) + adjoint_c_z*c_p_z
            + 2.0*adjoint_forward_t29;
        const lane adjoint_R_z_y =
            I_p_yz*adjoint_forward_t28 + adjoint_B_1_z*b_1_y + adjoint_B_2_z*b_2_y + adjoint_B_3_z*b_3_y
            + adjoint_B_4_z*b_4_y + adjoint_B_5_z*b_5_y + adjoint_B_6_z*b_6_y + adjoint_M_p_rx_rz*t467
            + adjoint_M_p_ry_rz*(forward_t22 + t14) + adjoint_M_p_rz_rz*(t16 + 2.0*t468) + adjoint_c_z*c_p_y;
        const lane adjoint_R_z_x =
            I_p_x*R_z_x*t441 + I_p_xy*adjoint_forward_t26 + I_p_xz*adjoint_forward_t28 + adjoint_B_1_z*b_1_x
            + adjoint_B_2_z*b_2_x + adjoint_B_3_z*b_3_x + adjoint_B_4_z*b_4_x + adjoint_B_5_z*b_5_x
            + adjoint_B_6_z*b_6_x + adjoint_M_p_rx_rz*t469 + adjoint_M_p_ry_rz*t13 + adjoint_c_z*c_p_x;
        const lane t470 = 2.0*t464;
        const lane adjoint_d_1_y =
            A_y_1*adjoint_det_D_l + B_1_x*adjoint_D_l_1_rz - B_1_z*adjoint_D_l_1_rx
            + D_l_2_rx*adjoint_minor_12_24 + D_l_2_ry*adjoint_minor_12_25 + D_l_2_rz*adjoint_minor_12_26
            + D_l_3_rx*adjoint_minor_13_24 + D_l_3_ry*adjoint_minor_13_25 + D_l_3_rz*adjoint_minor_13_26
            - adjoint_g_4_y*mu_1 - adjoint_minor_123_123*minor_23_13 - adjoint_minor_123_124*minor_23_14
            - adjoint_minor_123_125*minor_23_15 - adjoint_minor_123_126*minor_23_16
            + adjoint_minor_123_234*minor_23_34 + adjoint_minor_123_235*minor_23_35
            + adjoint_minor_123_236*minor_23_36 + adjoint_minor_123_245*minor_23_45
            + adjoint_minor_123_246*minor_23_46 + adjoint_minor_123_256*minor_23_56
            - adjoint_minor_12_12*d_2_x + adjoint_minor_12_23*d_2_z - adjoint_minor_13_12*d_3_x
            + adjoint_minor_13_23*d_3_z + d_1_y*t465 - g_y*t470;
        const lane adjoint_B_1_y =
            2.0*B_1_y*adjoint_forward_t92 + adjoint_D_l_1_rx*d_1_z - adjoint_D_l_1_rz*d_1_x
            - adjoint_G_p_rx*forward_t69 + adjoint_G_p_rz*forward_t55 + adjoint_L_rx_ry*forward_t103
            + adjoint_L_ry_rz*(forward_t76 + t66) - adjoint_M_p_ry_rz*forward_t165 + adjoint_d_1_y
            - adjoint_forward_t147*forward_t141 + adjoint_forward_t159*forward_t124
            + adjoint_forward_t172*m_perp_1 + adjoint_forward_t82*mu_1 + adjoint_forward_t94*g_4_y;
        const lane adjoint_R_y_z =
            I_p_z*adjoint_M_p_ry_ry*forward_t24 + adjoint_B_1_y*b_1_z + adjoint_B_2_y*b_2_z
            + adjoint_B_3_y*b_3_z + adjoint_B_4_y*b_4_z + adjoint_B_5_y*b_5_z + adjoint_B_6_y*b_6_z
            + adjoint_M_p_rx_ry*t466 + adjoint_M_p_ry_rz*(I_p_z*R_z_z + t438) + adjoint_c_y*c_p_z
            + 2.0*adjoint_forward_t24;
        const lane adjoint_forward_t11 = -adjoint_R_y_z + adjoint_R_z_y;
        const lane adjoint_R_y_y =
            I_p_yz*adjoint_forward_t25 + adjoint_B_1_y*b_1_y + adjoint_B_2_y*b_2_y + adjoint_B_3_y*b_3_y
            + adjoint_B_4_y*b_4_y + adjoint_B_5_y*b_5_y + adjoint_B_6_y*b_6_y + adjoint_M_p_rx_ry*t467
            + adjoint_M_p_ry_ry*(2.0*t14 + t9) + adjoint_M_p_ry_rz*(forward_t26 + t468) + adjoint_c_y*c_p_y;
        const lane t471 = R_z_x*adjoint_M_p_ry_rz;
        const lane adjoint_R_y_x =
            I_p_x*t471 + I_p_xy*adjoint_forward_t22 + I_p_xz*adjoint_forward_t25 + adjoint_B_1_y*b_1_x
            + adjoint_B_2_y*b_2_x + adjoint_B_3_y*b_3_x + adjoint_B_4_y*b_4_x + adjoint_B_5_y*b_5_x
            + adjoint_B_6_y*b_6_x + adjoint_M_p_rx_ry*t469 + adjoint_c_y*c_p_x + t13*t443;
        const lane adjoint_d_1_x =
            A_x_1*adjoint_det_D_l - B_1_y*adjoint_D_l_1_rz + B_1_z*adjoint_D_l_1_ry
            + D_l_2_rx*adjoint_minor_12_14 + D_l_2_ry*adjoint_minor_12_15 + D_l_2_rz*adjoint_minor_12_16
            + D_l_3_rx*adjoint_minor_13_14 + D_l_3_ry*adjoint_minor_13_15 + D_l_3_rz*adjoint_minor_13_16
            - adjoint_g_4_x*mu_1 + adjoint_minor_123_123*minor_23_23 + adjoint_minor_123_124*minor_23_24
            + adjoint_minor_123_125*minor_23_25 + adjoint_minor_123_126*minor_23_26
            + adjoint_minor_123_134*minor_23_34 + adjoint_minor_123_135*minor_23_35
            + adjoint_minor_123_136*minor_23_36 + adjoint_minor_123_145*minor_23_45
            + adjoint_minor_123_146*minor_23_46 + adjoint_minor_123_156*minor_23_56
            + adjoint_minor_12_12*d_2_y + adjoint_minor_12_13*d_2_z + adjoint_minor_13_12*d_3_y
            + adjoint_minor_13_13*d_3_z + d_1_x*t465 - g_x*t470;
        const lane adjoint_B_1_x =
            2.0*B_1_x*adjoint_forward_t116 - adjoint_D_l_1_ry*d_1_z + adjoint_D_l_1_rz*d_1_y
            + adjoint_G_p_ry*forward_t69 - adjoint_G_p_rz*forward_t62 + adjoint_L_rx_ry*forward_t82
            + adjoint_L_rx_rz*forward_t76 + adjoint_L_z_ry*mu_1 - adjoint_M_p_rx_ry*forward_t172
            - adjoint_M_p_rx_rz*forward_t165 + adjoint_M_p_y_rz*m_perp_1 + adjoint_d_1_x
            + (1.0/2.0)*adjoint_forward_t102 + adjoint_forward_t122*g_4_x + adjoint_forward_t153*forward_t141
            - adjoint_forward_t159*forward_t135;
        const lane adjoint_R_x_z =
            I_p_xz*adjoint_forward_t18 + I_p_yz*adjoint_forward_t20 + I_p_z*adjoint_M_p_rx_rx*forward_t14
            + I_p_z*adjoint_forward_t21 + adjoint_B_1_x*b_1_z + adjoint_B_2_x*b_2_z + adjoint_B_3_x*b_3_z
            + adjoint_B_4_x*b_4_z + adjoint_B_5_x*b_5_z + adjoint_B_6_x*b_6_z + adjoint_c_x*c_p_z
            + 2.0*adjoint_forward_t14;
        const lane adjoint_forward_t10 = adjoint_R_x_z*rot_z + adjoint_R_y_x*rot_y;
        const lane adjoint_forward_t9 = adjoint_R_x_z - adjoint_R_z_x;
        const lane adjoint_R_x_y =
            I_p_xy*adjoint_forward_t18 + I_p_y*adjoint_forward_t20 + I_p_yz*adjoint_forward_t15
            + adjoint_B_1_x*b_1_y + adjoint_B_2_x*b_2_y + adjoint_B_3_x*b_3_y + adjoint_B_4_x*b_4_y
            + adjoint_B_5_x*b_5_y + adjoint_B_6_x*b_6_y + adjoint_M_p_rx_rx*(2.0*forward_t19 + t5)
            + adjoint_c_x*c_p_y;
        const lane adjoint_forward_t8 = -adjoint_R_x_y + adjoint_R_y_x;
        const lane adjoint_forward_t7 =
            adjoint_forward_t11*rot_x + adjoint_forward_t8*rot_z + adjoint_forward_t9*rot_y;
        const lane adjoint_c_half = adjoint_forward_t7*s_half;
        const lane adjoint_R_x_x =
            I_p_x*adjoint_forward_t18 + I_p_xy*adjoint_forward_t12 + I_p_xz*adjoint_forward_t15
            + adjoint_B_1_x*b_1_x + adjoint_B_2_x*b_2_x + adjoint_B_3_x*b_3_x + adjoint_B_4_x*b_4_x
            + adjoint_B_5_x*b_5_x + adjoint_B_6_x*b_6_x + adjoint_c_x*c_p_x + forward_t16*t445;
        const lane adjoint_forward_t6 =
            -adjoint_R_x_x*forward_t4 + adjoint_R_y_y*t2 + adjoint_R_z_y*t3 + adjoint_R_z_z*t4
            + adjoint_forward_t10*rot_x;
        const lane t473 = adjoint_R_x_y*rot_y;
        const lane t474 = adjoint_R_z_x*rot_z;
        const lane adjoint_forward_t5 =
            (1.0/2.0)*adjoint_R_y_z*t3 + (1.0/2.0)*adjoint_forward_t6 + t472*t473 + t472*t474;
        const lane adjoint_s_half = 2.0*adjoint_forward_t5*s_half + adjoint_forward_t7*forward_3;
        const lane adjoint_forward_2 = adjoint_s_half*forward_1;
        const lane adjoint_forward_1 = adjoint_s_half*forward_2;
        const lane adjoint_half_angle =
            -adjoint_c_half*forward_2 - adjoint_forward_1*(forward_1*forward_1) + adjoint_forward_2*forward_3;
        const lane adjoint_forward_0 = (1.0/2.0)*adjoint_half_angle;
        const lane t475 = -1.0/2.0*adjoint_forward_0/forward_0;
        const lane adjoint_forward_t4 = -adjoint_R_x_x*forward_t6 - t475;
        const lane t476 = adjoint_R_y_y*forward_t6;
        const lane adjoint_forward_t3 = adjoint_forward_t4 - t476;
        const lane t477 = adjoint_R_z_z*forward_t6;
        const lane adjoint_forward_t2 = adjoint_forward_t4 - t477;
        const lane adjoint_forward_t1 = -t475 - t476 - t477;
        const lane t478 = adjoint_forward_t159*forward_t123;
        const lane t479 = adjoint_forward_t160*forward_t125;
        const lane t480 = adjoint_forward_t161*forward_t127;
        const lane t481 = adjoint_forward_t162*forward_t129;
        const lane t482 = adjoint_forward_t163*forward_t131;
        const lane t483 = adjoint_forward_t164*forward_t133;
        const lane t490 = adjoint_m_perp_1*forward_10;
        const lane t491 = adjoint_m_perp_2*forward_12;
        const lane t492 = adjoint_m_perp_3*forward_14;
        const lane t493 = adjoint_m_perp_4*forward_16;
        const lane t494 = adjoint_m_perp_5*forward_18;
        const lane t495 = adjoint_m_perp_6*forward_20;
        const lane t496 = adjoint_R_z_y*forward_t6;
        const lane t497 = adjoint_R_y_z*forward_t6;
        lanes_clear(gradient, 140);
        gradient[0] =
            LANES(adjoint_G_p_rx*c_z*g_y + adjoint_G_p_rz*c_y*g_x + adjoint_M_p_x_x + adjoint_M_p_y_rz*c_x
            + adjoint_forward_t171*c_z + adjoint_forward_t178*c_y + (1.0/2.0)*adjoint_forward_t181
            + adjoint_forward_t61*g_x + adjoint_forward_t68*g_y + adjoint_forward_t75*g_z);
        gradient[1] = LANES(R_x_x*adjoint_c_x + R_y_x*adjoint_c_y + R_z_x*adjoint_c_z);
        gradient[2] = LANES(R_x_y*adjoint_c_x + R_y_y*adjoint_c_y + R_z_y*adjoint_c_z);
        gradient[3] = LANES(R_x_z*adjoint_c_x + R_y_z*adjoint_c_y + R_z_z*adjoint_c_z);
        gradient[4] =
            LANES(R_x_x*adjoint_forward_t18 + R_y_x*t471 + adjoint_M_p_rx_rx*t6 + adjoint_M_p_ry_ry*t10
            + adjoint_M_p_rz_rz*t17);
        gradient[5] =
            LANES(R_x_y*adjoint_forward_t20 + R_z_y*t440 + adjoint_M_p_rx_rx*t7 + adjoint_M_p_ry_ry*t11
            + adjoint_M_p_rz_rz*t18);
        gradient[6] =
            LANES(R_x_z*adjoint_forward_t21 + R_z_z*t439 + adjoint_M_p_rx_rx*t8 + adjoint_M_p_ry_ry*t12
            + adjoint_M_p_rz_rz*t19);
        gradient[7] =
            LANES(R_x_x*adjoint_forward_t12 + R_x_y*adjoint_forward_t18 + R_y_x*adjoint_forward_t22
            + R_z_x*adjoint_forward_t26);
        gradient[8] =
            LANES(R_x_x*adjoint_forward_t15 + R_x_z*adjoint_forward_t18 + R_y_x*adjoint_forward_t25
            + R_z_x*adjoint_forward_t28);
        gradient[9] =
            LANES(R_x_y*adjoint_forward_t15 + R_x_z*adjoint_forward_t20 + R_y_y*adjoint_forward_t25
            + R_z_y*adjoint_forward_t28);
        gradient[10] =
            LANES(B_1_y*t478 + B_2_y*t479 + B_3_y*t480 + B_4_y*t481 + B_5_y*t482 + B_6_y*t483
            + adjoint_G_p_rz*(B_1_y*m_lift_1 + B_2_y*m_lift_2 + B_3_y*m_lift_3 + B_4_y*m_lift_4
            + B_5_y*m_lift_5 + B_6_y*m_lift_6 + forward_t178) + adjoint_forward_t124*forward_t123
            + adjoint_forward_t126*forward_t125 + adjoint_forward_t128*forward_t127
            + adjoint_forward_t130*forward_t129 + adjoint_forward_t132*forward_t131
            + adjoint_forward_t134*forward_t133 - adjoint_forward_t153*t484 - adjoint_forward_t154*t485
            - adjoint_forward_t155*t486 - adjoint_forward_t156*t487 - adjoint_forward_t157*t488
            - adjoint_forward_t158*t489 + adjoint_forward_t55*m_lift_1 + adjoint_forward_t56*m_lift_2
            + adjoint_forward_t57*m_lift_3 + adjoint_forward_t58*m_lift_4 + adjoint_forward_t59*m_lift_5
            + adjoint_forward_t60*m_lift_6 + adjoint_forward_t61*m_p - d_1_x*t470 - d_2_x*t463 - d_3_x*t460
            - d_4_x*t456 - d_5_x*t453 - d_6_x*t450);
        gradient[11] =
            LANES(-B_1_x*t478 - B_2_x*t479 - B_3_x*t480 - B_4_x*t481 - B_5_x*t482 - B_6_x*t483
            + adjoint_G_p_rx*(B_1_z*m_lift_1 + B_2_z*m_lift_2 + B_3_z*m_lift_3 + B_4_z*m_lift_4
            + B_5_z*m_lift_5 + B_6_z*m_lift_6 + forward_t171) + adjoint_forward_t135*forward_t123
            + adjoint_forward_t136*forward_t125 + adjoint_forward_t137*forward_t127
            + adjoint_forward_t138*forward_t129 + adjoint_forward_t139*forward_t131
            + adjoint_forward_t140*forward_t133 + adjoint_forward_t147*t484 + adjoint_forward_t148*t485
            + adjoint_forward_t149*t486 + adjoint_forward_t150*t487 + adjoint_forward_t151*t488
            + adjoint_forward_t152*t489 + adjoint_forward_t62*m_lift_1 + adjoint_forward_t63*m_lift_2
            + adjoint_forward_t64*m_lift_3 + adjoint_forward_t65*m_lift_4 + adjoint_forward_t66*m_lift_5
            + adjoint_forward_t67*m_lift_6 + adjoint_forward_t68*m_p - d_1_y*t470 - d_2_y*t463 - d_3_y*t460
            - d_4_y*t456 - d_5_y*t453 - d_6_y*t450);
        gradient[12] =
            LANES(B_1_x*adjoint_forward_t153*forward_t123 - B_1_y*adjoint_forward_t147*forward_t123
            + B_2_x*adjoint_forward_t154*forward_t125 - B_2_y*adjoint_forward_t148*forward_t125
            + B_3_x*adjoint_forward_t155*forward_t127 - B_3_y*adjoint_forward_t149*forward_t127
            + B_4_x*adjoint_forward_t156*forward_t129 - B_4_y*adjoint_forward_t150*forward_t129
            + B_5_x*adjoint_forward_t157*forward_t131 - B_5_y*adjoint_forward_t151*forward_t131
            + B_6_x*adjoint_forward_t158*forward_t133 - B_6_y*adjoint_forward_t152*forward_t133
            + adjoint_forward_t141*forward_t123 + adjoint_forward_t142*forward_t125
            + adjoint_forward_t143*forward_t127 + adjoint_forward_t144*forward_t129
            + adjoint_forward_t145*forward_t131 + adjoint_forward_t146*forward_t133
            + adjoint_forward_t69*m_lift_1 + adjoint_forward_t70*m_lift_2 + adjoint_forward_t71*m_lift_3
            + adjoint_forward_t72*m_lift_4 + adjoint_forward_t73*m_lift_5 + adjoint_forward_t74*m_lift_6
            + adjoint_forward_t75*m_p - d_1_z*t470 - d_2_z*t463 - d_3_z*t460 - d_4_z*t456 - d_5_z*t453
            - d_6_z*t450);
        gradient[13] = LANES(-adjoint_d_1_x);
        gradient[14] = LANES(-adjoint_d_1_y);
        gradient[15] = LANES(-adjoint_d_1_z);
        gradient[16] = LANES(-adjoint_d_2_x);
        gradient[17] = LANES(-adjoint_d_2_y);
        gradient[18] = LANES(-adjoint_d_2_z);
        gradient[19] = LANES(-adjoint_d_3_x);
        gradient[20] = LANES(-adjoint_d_3_y);
        gradient[21] = LANES(-adjoint_d_3_z);
        gradient[22] = LANES(-adjoint_d_4_x);
        gradient[23] = LANES(-adjoint_d_4_y);
        gradient[24] = LANES(-adjoint_d_4_z);
        gradient[25] = LANES(-adjoint_d_5_x);
        gradient[26] = LANES(-adjoint_d_5_y);
        gradient[27] = LANES(-adjoint_d_5_z);
        gradient[28] = LANES(-adjoint_d_6_x);
        gradient[29] = LANES(-adjoint_d_6_y);
        gradient[30] = LANES(-adjoint_d_6_z);
        gradient[31] = LANES(R_x_x*adjoint_B_1_x + R_y_x*adjoint_B_1_y + R_z_x*adjoint_B_1_z);
        gradient[32] = LANES(R_x_y*adjoint_B_1_x + R_y_y*adjoint_B_1_y + R_z_y*adjoint_B_1_z);
        gradient[33] = LANES(R_x_z*adjoint_B_1_x + R_y_z*adjoint_B_1_y + R_z_z*adjoint_B_1_z);
        gradient[34] = LANES(R_x_x*adjoint_B_2_x + R_y_x*adjoint_B_2_y + R_z_x*adjoint_B_2_z);
        gradient[35] = LANES(R_x_y*adjoint_B_2_x + R_y_y*adjoint_B_2_y + R_z_y*adjoint_B_2_z);
        gradient[36] = LANES(R_x_z*adjoint_B_2_x + R_y_z*adjoint_B_2_y + R_z_z*adjoint_B_2_z);
        gradient[37] = LANES(R_x_x*adjoint_B_3_x + R_y_x*adjoint_B_3_y + R_z_x*adjoint_B_3_z);
        gradient[38] = LANES(R_x_y*adjoint_B_3_x + R_y_y*adjoint_B_3_y + R_z_y*adjoint_B_3_z);
        gradient[39] = LANES(R_x_z*adjoint_B_3_x + R_y_z*adjoint_B_3_y + R_z_z*adjoint_B_3_z);
        gradient[40] = LANES(R_x_x*adjoint_B_4_x + R_y_x*adjoint_B_4_y + R_z_x*adjoint_B_4_z);
        gradient[41] = LANES(R_x_y*adjoint_B_4_x + R_y_y*adjoint_B_4_y + R_z_y*adjoint_B_4_z);
        gradient[42] = LANES(R_x_z*adjoint_B_4_x + R_y_z*adjoint_B_4_y + R_z_z*adjoint_B_4_z);
        gradient[43] = LANES(R_x_x*adjoint_B_5_x + R_y_x*adjoint_B_5_y + R_z_x*adjoint_B_5_z);
        gradient[44] = LANES(R_x_y*adjoint_B_5_x + R_y_y*adjoint_B_5_y + R_z_y*adjoint_B_5_z);
        gradient[45] = LANES(R_x_z*adjoint_B_5_x + R_y_z*adjoint_B_5_y + R_z_z*adjoint_B_5_z);
        gradient[46] = LANES(R_x_x*adjoint_B_6_x + R_y_x*adjoint_B_6_y + R_z_x*adjoint_B_6_z);
        gradient[47] = LANES(R_x_y*adjoint_B_6_x + R_y_y*adjoint_B_6_y + R_z_y*adjoint_B_6_z);
        gradient[48] = LANES(R_x_z*adjoint_B_6_x + R_y_z*adjoint_B_6_y + R_z_z*adjoint_B_6_z);
        gradient[61] = LANES(-shape_7*t140 + t125 + t137);
        gradient[62] = LANES(-shape_8*t143 + t123 + t135);
        gradient[63] = LANES(-shape_9*t146 + t121 + t133);
        gradient[64] = LANES(-shape_10*t149 + t119 + t131);
        gradient[65] = LANES(-shape_11*t152 + t117 + t129);
        gradient[66] = LANES(-2.0*shape_12*shape_6 + t115 + t127);
        gradient[67] = LANES(adjoint_forward_t32*c_b_1 + t20*t490);
        gradient[68] = LANES(adjoint_forward_t35*c_b_2 + t26*t491);
        gradient[69] = LANES(adjoint_forward_t38*c_b_3 + t32*t492);
        gradient[70] = LANES(adjoint_forward_t41*c_b_4 + t38*t493);
        gradient[71] = LANES(adjoint_forward_t44*c_b_5 + t44*t494);
        gradient[72] = LANES(adjoint_forward_t47*c_b_6 + t495*t50);
        gradient[73] = LANES(adjoint_forward_t32*m_b_1 + 2.0*t24*t490);
        gradient[74] = LANES(adjoint_forward_t35*m_b_2 + 2.0*t30*t491);
        gradient[75] = LANES(adjoint_forward_t38*m_b_3 + 2.0*t36*t492);
        gradient[76] = LANES(adjoint_forward_t41*m_b_4 + 2.0*t42*t493);
        gradient[77] = LANES(adjoint_forward_t44*m_b_5 + 2.0*t48*t494);
        gradient[78] = LANES(adjoint_forward_t47*m_b_6 + 2.0*t495*t54);
        gradient[79] = LANES(t490);
        gradient[80] = LANES(t491);
        gradient[81] = LANES(t492);
        gradient[82] = LANES(t493);
        gradient[83] = LANES(t494);
        gradient[84] = LANES(t495);
        gradient[85] = LANES(-adjoint_forward_t32*c_r_1 + adjoint_m_lift_1 + adjoint_m_perp_1*t23 - t370);
        gradient[86] = LANES(-adjoint_forward_t35*c_r_2 + adjoint_m_lift_2 + adjoint_m_perp_2*t29 - t367);
        gradient[87] = LANES(-adjoint_forward_t38*c_r_3 + adjoint_m_lift_3 + adjoint_m_perp_3*t35 - t363);
        gradient[88] = LANES(-adjoint_forward_t41*c_r_4 + adjoint_m_lift_4 + adjoint_m_perp_4*t41 - t359);
        gradient[89] = LANES(-adjoint_forward_t44*c_r_5 + adjoint_m_lift_5 + adjoint_m_perp_5*t47 - t353);
        gradient[90] = LANES(-adjoint_forward_t47*c_r_6 + adjoint_m_lift_6 + adjoint_m_perp_6*t53 - t351);
        gradient[91] = LANES(-adjoint_forward_t32*m_r_1 - forward_11*m_r_1*t437);
        gradient[92] = LANES(-adjoint_forward_t35*m_r_2 - forward_13*m_r_2*t436);
        gradient[93] = LANES(-adjoint_forward_t38*m_r_3 - forward_15*m_r_3*t435);
        gradient[94] = LANES(-adjoint_forward_t41*m_r_4 - forward_17*m_r_4*t434);
        gradient[95] = LANES(-adjoint_forward_t44*m_r_5 - forward_19*m_r_5*t433);
        gradient[96] = LANES(-adjoint_forward_t47*m_r_6 - forward_21*m_r_6*t432);
        gradient[97] = LANES(t490);
        gradient[98] = LANES(t491);
        gradient[99] = LANES(t492);
        gradient[100] = LANES(t493);
        gradient[101] = LANES(t494);
        gradient[102] = LANES(t495);
        gradient[103] = LANES(-forward_23*t138);
        gradient[104] = LANES(-forward_24*t136);
        gradient[105] = LANES(-forward_25*t134);
        gradient[106] = LANES(-forward_26*t132);
        gradient[107] = LANES(-forward_27*t130);
        gradient[108] = LANES(-forward_28*t128);
        gradient[109] = LANES(-2.0*adjoint_forward_23/(h_m_1*h_m_1*h_m_1));
        gradient[110] = LANES(-2.0*adjoint_forward_24/(h_m_2*h_m_2*h_m_2));
        gradient[111] = LANES(-2.0*adjoint_forward_25/(h_m_3*h_m_3*h_m_3));
        gradient[112] = LANES(-2.0*adjoint_forward_26/(h_m_4*h_m_4*h_m_4));
        gradient[113] = LANES(-2.0*adjoint_forward_27/(h_m_5*h_m_5*h_m_5));
        gradient[114] = LANES(-2.0*adjoint_forward_28/(h_m_6*h_m_6*h_m_6));
        gradient[134] =
            LANES(adjoint_d_1_x + adjoint_d_2_x + adjoint_d_3_x + adjoint_d_4_x + adjoint_d_5_x
            + adjoint_d_6_x);
        gradient[135] =
            LANES(adjoint_d_1_y + adjoint_d_2_y + adjoint_d_3_y + adjoint_d_4_y + adjoint_d_5_y
            + adjoint_d_6_y);
        gradient[136] =
            LANES(adjoint_d_1_z + adjoint_d_2_z + adjoint_d_3_z + adjoint_d_4_z + adjoint_d_5_z
            + adjoint_d_6_z);
        gradient[137] =
            LANES(2.0*adjoint_forward_t1*rot_x + adjoint_forward_t10*forward_t6
            + adjoint_forward_t11*forward_t7 + forward_t6*t473 + forward_t6*t474);
        gradient[138] =
            LANES(adjoint_R_x_y*t1 + adjoint_R_y_x*forward_t10 + 2.0*adjoint_forward_t2*rot_y
            + adjoint_forward_t9*forward_t7 + rot_z*t496 + rot_z*t497);
        gradient[139] =
            LANES(adjoint_R_x_z*forward_t10 + adjoint_R_z_x*t1 + 2.0*adjoint_forward_t3*rot_z
            + adjoint_forward_t8*forward_t7 + rot_y*t496 + rot_y*t497);
    }
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through extended.
 * 12248 operations; 2302597931505445 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_gradient(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int modes, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
    (void)effects;
    const lane p_x = pose[0];
    const lane p_y = pose[1];
    const lane p_z = pose[2];
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double m_p = parameters[0];
    const double c_p_x = parameters[1];
    const double c_p_y = parameters[2];
    const double c_p_z = parameters[3];
    const double I_p_x = parameters[4];
    const double I_p_y = parameters[5];
    const double I_p_z = parameters[6];
    const double I_p_xy = parameters[7];
    const double I_p_xz = parameters[8];
    const double I_p_yz = parameters[9];
    const double g_x = parameters[10];
    const double g_y = parameters[11];
    const double g_z = parameters[12];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double k_l_1 = parameters[61];
    const double k_l_2 = parameters[62];
    const double k_l_3 = parameters[63];
    const double k_l_4 = parameters[64];
    const double k_l_5 = parameters[65];
    const double k_l_6 = parameters[66];
    const double m_b_1 = parameters[67];
    const double m_b_2 = parameters[68];
    const double m_b_3 = parameters[69];
    const double m_b_4 = parameters[70];
    const double m_b_5 = parameters[71];
    const double m_b_6 = parameters[72];
    const double c_b_1 = parameters[73];
    const double c_b_2 = parameters[74];
    const double c_b_3 = parameters[75];
    const double c_b_4 = parameters[76];
    const double c_b_5 = parameters[77];
    const double c_b_6 = parameters[78];
    const double I_b_1 = parameters[79];
    const double I_b_2 = parameters[80];
    const double I_b_3 = parameters[81];
    const double I_b_4 = parameters[82];
    const double I_b_5 = parameters[83];
    const double I_b_6 = parameters[84];
    const double m_r_1 = parameters[85];
    const double m_r_2 = parameters[86];
    const double m_r_3 = parameters[87];
    const double m_r_4 = parameters[88];
    const double m_r_5 = parameters[89];
    const double m_r_6 = parameters[90];
    const double c_r_1 = parameters[91];
    const double c_r_2 = parameters[92];
    const double c_r_3 = parameters[93];
    const double c_r_4 = parameters[94];
    const double c_r_5 = parameters[95];
    const double c_r_6 = parameters[96];
    const double I_r_1 = parameters[97];
    const double I_r_2 = parameters[98];
    const double I_r_3 = parameters[99];
    const double I_r_4 = parameters[100];
    const double I_r_5 = parameters[101];
    const double I_r_6 = parameters[102];
    const double I_m_1 = parameters[103];
    const double I_m_2 = parameters[104];
    const double I_m_3 = parameters[105];
    const double I_m_4 = parameters[106];
    const double I_m_5 = parameters[107];
    const double I_m_6 = parameters[108];
    const double h_m_1 = parameters[109];
    const double h_m_2 = parameters[110];
    const double h_m_3 = parameters[111];
    const double h_m_4 = parameters[112];
    const double h_m_5 = parameters[113];
    const double h_m_6 = parameters[114];
    const double a_S_1 = effects[0];
    const double a_S_2 = effects[1];
    const double a_S_3 = effects[2];
    const double a_S_4 = effects[3];
    const double a_S_5 = effects[4];
    const double a_S_6 = effects[5];
    const double k_C = effects[6];
    const double m_L = effects[9];
    const double b_L_x = effects[10];
    const double b_L_y = effects[11];
    const double b_L_z = effects[12];
    const lane forward_t1 = (rot_x*rot_x);
    const lane forward_t2 = (rot_y*rot_y);
    const lane forward_t3 = (rot_z*rot_z);
    const lane forward_t4 = forward_t2 + forward_t3;
    const lane forward_0 = lanes_sqrt(forward_t1 + forward_t4 + 1e-30);
    const lane half_angle = (1.0/2.0)*forward_0;
    const lane forward_1 = 1.0/half_angle;
    const lane forward_2 = lanes_sin(half_angle);
    const lane s_half = forward_1*forward_2;
    const lane forward_t5 = (s_half*s_half);
    const lane forward_t6 = (1.0/2.0)*forward_t5;
    const lane R_x_x = -forward_t4*forward_t6 + 1.0;
    const lane forward_3 = lanes_cos(half_angle);
    const lane forward_t7 = forward_3*s_half;
    const lane forward_t8 = forward_t7*rot_z;
    const lane t1 = forward_t6*rot_x;
    const lane R_x_y = -forward_t8 + rot_y*t1;
    const lane forward_t9 = forward_t7*rot_y;
    const lane forward_t10 = forward_t6*rot_x;
    const lane R_x_z = forward_t10*rot_z + forward_t9;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = forward_t10*rot_y + forward_t8;
    const lane t2 = -forward_t1 - forward_t3;
    const lane R_y_y = forward_t6*t2 + 1.0;
    const lane forward_t11 = forward_t7*rot_x;
    const lane R_y_z = -forward_t11 + (1.0/2.0)*forward_t5*rot_y*rot_z;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = -forward_t9 + rot_z*t1;
    const lane t3 = rot_y*rot_z;
    const lane R_z_y = forward_t11 + forward_t6*t3;
    const lane t4 = -forward_t1 - forward_t2;
    const lane R_z_z = forward_t6*t4 + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane forward_4 = lanes_sqrt((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const lane forward_5 = lanes_sqrt((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const lane forward_6 = lanes_sqrt((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const lane forward_7 = lanes_sqrt((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const lane forward_8 = lanes_sqrt((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const lane forward_9 = lanes_sqrt((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const lane c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const lane c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const lane c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const lane forward_t12 = I_p_xy*R_x_x;
    const lane forward_t13 = I_p_xz*R_x_x;
    const lane forward_t14 = 2.0*R_x_z;
    const lane forward_t15 = I_p_yz*R_x_y;
    const lane t5 = 2.0*forward_t12;
    const lane t6 = (R_x_x*R_x_x);
    const lane t7 = (R_x_y*R_x_y);
    const lane t8 = (R_x_z*R_x_z);
    const lane J_x_x =
        I_p_x*t6 + I_p_y*t7 + I_p_z*t8 + R_x_y*t5 + forward_t13*forward_t14 + forward_t14*forward_t15;
    const lane forward_t16 = I_p_x*R_x_x;
    const lane forward_t17 = I_p_xy*R_x_y;
    const lane forward_t18 = I_p_xz*R_x_z;
    const lane forward_t19 = I_p_y*R_x_y;
    const lane forward_t20 = I_p_yz*R_x_z;
    const lane forward_t21 = I_p_z*R_x_z;
    const lane J_x_y =
        R_y_x*forward_t16 + R_y_x*forward_t17 + R_y_x*forward_t18 + R_y_y*forward_t12 + R_y_y*forward_t19
        + R_y_y*forward_t20 + R_y_z*forward_t13 + R_y_z*forward_t15 + R_y_z*forward_t21;
    const lane J_x_z =
        R_z_x*forward_t16 + R_z_x*forward_t17 + R_z_x*forward_t18 + R_z_y*forward_t12 + R_z_y*forward_t19
        + R_z_y*forward_t20 + R_z_z*forward_t13 + R_z_z*forward_t15 + R_z_z*forward_t21;
    const lane forward_t22 = I_p_xy*R_y_x;
    const lane forward_t23 = I_p_xz*R_y_x;
    const lane forward_t24 = 2.0*R_y_z;
    const lane forward_t25 = I_p_yz*R_y_y;
    const lane t9 = 2.0*forward_t22;
    const lane t10 = (R_y_x*R_y_x);
    const lane t11 = (R_y_y*R_y_y);
    const lane t12 = (R_y_z*R_y_z);
    const lane J_y_y =
        I_p_x*t10 + I_p_y*t11 + I_p_z*t12 + R_y_y*t9 + forward_t23*forward_t24 + forward_t24*forward_t25;
    const lane forward_t26 = I_p_xy*R_z_x;
    const lane forward_t27 = I_p_xz*R_z_x;
    const lane forward_t28 = I_p_yz*R_z_y;
    const lane t13 = I_p_x*R_y_x;
    const lane t14 = I_p_y*R_y_y;
    const lane t15 = I_p_z*R_y_z;
    const lane J_y_z =
        R_y_y*forward_t26 + R_y_z*forward_t27 + R_y_z*forward_t28 + R_z_x*t13 + R_z_y*forward_t22 + R_z_y*t14
        + R_z_z*forward_t23 + R_z_z*forward_t25 + R_z_z*t15;
    const lane forward_t29 = 2.0*R_z_z;
    const lane t16 = 2.0*forward_t26;
    const lane t17 = (R_z_x*R_z_x);
    const lane t18 = (R_z_y*R_z_y);
    const lane t19 = (R_z_z*R_z_z);
    const lane J_z_z =
        I_p_x*t17 + I_p_y*t18 + I_p_z*t19 + R_z_y*t16 + forward_t27*forward_t29 + forward_t28*forward_t29;
    const lane forward_10 = 1.0/((forward_4*forward_4));
    const lane forward_11 = 1.0/forward_4;
    const double t20 = (c_b_1*c_b_1);
    const double t21 = m_b_1*t20;
    const lane t22 = -c_r_1*forward_11 + 1.0;
    const lane t23 = (t22*t22);
    const lane m_perp_1 = I_b_1*forward_10 + I_r_1*forward_10 + forward_10*t21 + m_r_1*t23;
    const double t24 = c_b_1*m_b_1;
    const double t25 = c_r_1*m_r_1;
    const double forward_t32 = t24 - t25;
    const lane forward_t33 = forward_11*forward_t32;
    const lane m_lift_1 = forward_t33 + m_r_1;
    const lane forward_12 = 1.0/((forward_5*forward_5));
    const lane forward_13 = 1.0/forward_5;
    const double t26 = (c_b_2*c_b_2);
    const double t27 = m_b_2*t26;
    const lane t28 = -c_r_2*forward_13 + 1.0;
    const lane t29 = (t28*t28);
    const lane m_perp_2 = I_b_2*forward_12 + I_r_2*forward_12 + forward_12*t27 + m_r_2*t29;
    const double t30 = c_b_2*m_b_2;
    const double t31 = c_r_2*m_r_2;
    const double forward_t36 = t30 - t31;
    const lane forward_t37 = forward_13*forward_t36;
    const lane m_lift_2 = forward_t37 + m_r_2;
    const lane forward_14 = 1.0/((forward_6*forward_6));
    const lane forward_15 = 1.0/forward_6;
    const double t32 = (c_b_3*c_b_3);
    const double t33 = m_b_3*t32;
    const lane t34 = -c_r_3*forward_15 + 1.0;
    const lane t35 = (t34*t34);
    const lane m_perp_3 = I_b_3*forward_14 + I_r_3*forward_14 + forward_14*t33 + m_r_3*t35;
    const double t36 = c_b_3*m_b_3;
    const double t37 = c_r_3*m_r_3;
    const double forward_t40 = t36 - t37;
    const lane forward_t41 = forward_15*forward_t40;
    const lane m_lift_3 = forward_t41 + m_r_3;
    const lane forward_16 = 1.0/((forward_7*forward_7));
    const lane forward_17 = 1.0/forward_7;
    const double t38 = (c_b_4*c_b_4);
    const double t39 = m_b_4*t38;
    const lane t40 = -c_r_4*forward_17 + 1.0;
    const lane t41 = (t40*t40);
    const lane m_perp_4 = I_b_4*forward_16 + I_r_4*forward_16 + forward_16*t39 + m_r_4*t41;
    const double t42 = c_b_4*m_b_4;
    const double t43 = c_r_4*m_r_4;
    const double forward_t44 = t42 - t43;
    const lane forward_t45 = forward_17*forward_t44;
    const lane m_lift_4 = forward_t45 + m_r_4;
    const lane forward_18 = 1.0/((forward_8*forward_8));
    const lane forward_19 = 1.0/forward_8;
    const double t44 = (c_b_5*c_b_5);
    const double t45 = m_b_5*t44;
    const lane t46 = -c_r_5*forward_19 + 1.0;
    const lane t47 = (t46*t46);
    const lane m_perp_5 = I_b_5*forward_18 + I_r_5*forward_18 + forward_18*t45 + m_r_5*t47;
    const double t48 = c_b_5*m_b_5;
    const double t49 = c_r_5*m_r_5;
    const double forward_t48 = t48 - t49;
    const lane forward_t49 = forward_19*forward_t48;
    const lane m_lift_5 = forward_t49 + m_r_5;
    const lane forward_20 = 1.0/((forward_9*forward_9));
    const lane forward_21 = 1.0/forward_9;
    const double t50 = (c_b_6*c_b_6);
    const double t51 = m_b_6*t50;
    const lane t52 = -c_r_6*forward_21 + 1.0;
    const lane t53 = (t52*t52);
    const lane m_perp_6 = I_b_6*forward_20 + I_r_6*forward_20 + forward_20*t51 + m_r_6*t53;
    const double t54 = c_b_6*m_b_6;
    const double t55 = c_r_6*m_r_6;
    const double forward_t52 = t54 - t55;
    const lane forward_t53 = forward_21*forward_t52;
    const lane m_lift_6 = forward_t53 + m_r_6;
    const lane o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const lane o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const lane o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane forward_22 = 1.0/det_D_l;
    const lane forward_t55 = forward_22*forward_4;
    const lane D_p_x_1 = A_x_1*forward_t55;
    const lane forward_t56 = forward_22*forward_5;
    const lane D_p_x_2 = A_x_2*forward_t56;
    const lane forward_t57 = forward_22*forward_6;
    const lane D_p_x_3 = A_x_3*forward_t57;
    const lane forward_t58 = forward_22*forward_7;
    const lane D_p_x_4 = A_x_4*forward_t58;
    const lane forward_t59 = forward_22*forward_8;
    const lane D_p_x_5 = A_x_5*forward_t59;
    const lane forward_t60 = forward_22*forward_9;
    const lane D_p_x_6 = A_x_6*forward_t60;
    const lane D_p_y_1 = A_y_1*forward_t55;
    const lane D_p_y_2 = A_y_2*forward_t56;
    const lane D_p_y_3 = A_y_3*forward_t57;
    const lane D_p_y_4 = A_y_4*forward_t58;
    const lane D_p_y_5 = A_y_5*forward_t59;
    const lane D_p_y_6 = A_y_6*forward_t60;
    const lane D_p_z_1 = A_z_1*forward_t55;
    const lane D_p_z_2 = A_z_2*forward_t56;
    const lane D_p_z_3 = A_z_3*forward_t57;
    const lane D_p_z_4 = A_z_4*forward_t58;
    const lane D_p_z_5 = A_z_5*forward_t59;
    const lane D_p_z_6 = A_z_6*forward_t60;
    const lane D_p_rx_1 = A_rx_1*forward_t55;
    const lane D_p_rx_2 = A_rx_2*forward_t56;
    const lane D_p_rx_3 = A_rx_3*forward_t57;
    const lane D_p_rx_4 = A_rx_4*forward_t58;
    const lane D_p_rx_5 = A_rx_5*forward_t59;
    const lane D_p_rx_6 = A_rx_6*forward_t60;
    const lane D_p_ry_1 = A_ry_1*forward_t55;
    const lane D_p_ry_2 = A_ry_2*forward_t56;
    const lane D_p_ry_3 = A_ry_3*forward_t57;
    const lane D_p_ry_4 = A_ry_4*forward_t58;
    const lane D_p_ry_5 = A_ry_5*forward_t59;
    const lane D_p_ry_6 = A_ry_6*forward_t60;
    const lane D_p_rz_1 = A_rz_1*forward_t55;
    const lane D_p_rz_2 = A_rz_2*forward_t56;
    const lane D_p_rz_3 = A_rz_3*forward_t57;
    const lane D_p_rz_4 = A_rz_4*forward_t58;
    const lane D_p_rz_5 = A_rz_5*forward_t59;
    const lane D_p_rz_6 = A_rz_6*forward_t60;
    const lane forward_t61 = g_x*m_lift_1;
    const lane forward_t62 = g_x*m_lift_2;
    const lane forward_t63 = g_x*m_lift_3;
    const lane forward_t64 = g_x*m_lift_4;
    const lane forward_t65 = g_x*m_lift_5;
    const lane forward_t66 = g_x*m_lift_6;
    const double forward_t67 = m_L + m_p;
    const lane G_p_x =
        -forward_t61 - forward_t62 - forward_t63 - forward_t64 - forward_t65 - forward_t66 - forward_t67*g_x;
    const lane forward_t68 = g_y*m_lift_1;
    const lane forward_t69 = g_y*m_lift_2;
    const lane forward_t70 = g_y*m_lift_3;
    const lane forward_t71 = g_y*m_lift_4;
    const lane forward_t72 = g_y*m_lift_5;
    const lane forward_t73 = g_y*m_lift_6;
    const lane G_p_y =
        -forward_t67*g_y - forward_t68 - forward_t69 - forward_t70 - forward_t71 - forward_t72 - forward_t73;
    const lane forward_t74 = g_z*m_lift_1;
    const lane forward_t75 = g_z*m_lift_2;
    const lane forward_t76 = g_z*m_lift_3;
    const lane forward_t77 = g_z*m_lift_4;
    const lane forward_t78 = g_z*m_lift_5;
    const lane forward_t79 = g_z*m_lift_6;
    const lane G_p_z =
        -forward_t67*g_z - forward_t74 - forward_t75 - forward_t76 - forward_t77 - forward_t78 - forward_t79;
    const double forward_t80 = g_z*m_p;
    const double forward_t81 = g_z*m_L;
    const lane G_p_rx =
        -B_1_y*forward_t74 + B_1_z*g_y*m_lift_1 - B_2_y*forward_t75 + B_2_z*g_y*m_lift_2 - B_3_y*forward_t76
        + B_3_z*g_y*m_lift_3 - B_4_y*forward_t77 + B_4_z*g_y*m_lift_4 - B_5_y*forward_t78
        + B_5_z*g_y*m_lift_5 - B_6_y*forward_t79 + B_6_z*g_y*m_lift_6 - c_y*forward_t80 + c_z*g_y*m_p
        - forward_t81*o_L_y + g_y*m_L*o_L_z;
    const double forward_t82 = g_x*m_p;
    const double forward_t83 = g_x*m_L;
    const lane G_p_ry =
        B_1_x*forward_t74 - B_1_z*forward_t61 + B_2_x*forward_t75 - B_2_z*forward_t62 + B_3_x*forward_t76
        - B_3_z*forward_t63 + B_4_x*forward_t77 - B_4_z*forward_t64 + B_5_x*forward_t78 - B_5_z*forward_t65
        + B_6_x*forward_t79 - B_6_z*forward_t66 + c_x*forward_t80 - c_z*forward_t82 + forward_t81*o_L_x
        - forward_t83*o_L_z;
    const double forward_t84 = g_y*m_p;
    const double forward_t85 = g_y*m_L;
    const lane G_p_rz =
        -B_1_x*forward_t68 + B_1_y*g_x*m_lift_1 - B_2_x*forward_t69 + B_2_y*g_x*m_lift_2 - B_3_x*forward_t70
        + B_3_y*g_x*m_lift_3 - B_4_x*forward_t71 + B_4_y*g_x*m_lift_4 - B_5_x*forward_t72
        + B_5_y*g_x*m_lift_5 - B_6_x*forward_t73 + B_6_y*g_x*m_lift_6 - c_x*forward_t84 + c_y*g_x*m_p
        - forward_t85*o_L_x + g_x*m_L*o_L_y;
    const lane t56 = A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z;
    const lane mu_1 = forward_22*t56;
    const lane t57 = A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z;
    const lane mu_2 = forward_22*t57;
    const lane t58 = A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z;
    const lane mu_3 = forward_22*t58;
    const lane t59 = A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z;
    const lane mu_4 = forward_22*t59;
    const lane t60 = A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z;
    const lane mu_5 = forward_22*t60;
    const lane t61 = A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z;
    const lane mu_6 = forward_22*t61;
    const lane g_4_x = -d_1_x*mu_1 - forward_t61;
    const lane g_4_y = -d_1_y*mu_1 - forward_t68;
    const lane g_4_z = -d_1_z*mu_1 - forward_t74;
    const lane g_5_x = -d_2_x*mu_2 - forward_t62;
    const lane g_5_y = -d_2_y*mu_2 - forward_t69;
    const lane g_5_z = -d_2_z*mu_2 - forward_t75;
    const lane g_6_x = -d_3_x*mu_3 - forward_t63;
    const lane g_6_y = -d_3_y*mu_3 - forward_t70;
    const lane g_6_z = -d_3_z*mu_3 - forward_t76;
    const lane g_7_x = -d_4_x*mu_4 - forward_t64;
    const lane g_7_y = -d_4_y*mu_4 - forward_t71;
    const lane g_7_z = -d_4_z*mu_4 - forward_t77;
    const lane g_8_x = -d_5_x*mu_5 - forward_t65;
    const lane g_8_y = -d_5_y*mu_5 - forward_t72;
    const lane g_8_z = -d_5_z*mu_5 - forward_t78;
    const lane g_9_x = -d_6_x*mu_6 - forward_t66;
    const lane g_9_y = -d_6_y*mu_6 - forward_t73;
    const lane g_9_z = -d_6_z*mu_6 - forward_t79;
    const double g_10_x = -forward_t82;
    const double g_10_y = -forward_t84;
    const double g_10_z = -forward_t80;
    const double g_11_x = -forward_t83;
    const double g_11_y = -forward_t85;
    const double g_11_z = -forward_t81;
    const lane L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const lane forward_t86 = B_1_z*mu_1;
    const lane forward_t87 = B_2_z*mu_2;
    const lane forward_t88 = B_3_z*mu_3;
    const lane forward_t89 = B_4_z*mu_4;
    const lane forward_t90 = B_5_z*mu_5;
    const lane forward_t91 = B_6_z*mu_6;
    const lane L_y_rx = forward_t86 + forward_t87 + forward_t88 + forward_t89 + forward_t90 + forward_t91;
    const lane L_x_ry = -L_y_rx;
    const lane forward_t92 = B_2_y*mu_2;
    const lane forward_t93 = B_3_y*mu_3;
    const lane forward_t94 = B_4_y*mu_4;
    const lane forward_t95 = B_5_y*mu_5;
    const lane forward_t96 = B_6_y*mu_6;
    const lane forward_t97 = B_1_y*mu_1;
    const lane L_x_rz = forward_t92 + forward_t93 + forward_t94 + forward_t95 + forward_t96 + forward_t97;
    const lane L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const lane L_y_rz = -L_z_ry;
    const lane L_z_rx = -L_x_rz;
    const lane forward_t98 = (B_1_z*B_1_z);
    const lane forward_t99 = (B_2_z*B_2_z);
    const lane forward_t100 = (B_3_z*B_3_z);
    const lane forward_t101 = (B_4_z*B_4_z);
    const lane forward_t102 = (B_5_z*B_5_z);
    const lane forward_t103 = (B_6_z*B_6_z);
    const lane forward_t104 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + forward_t100*mu_3 + forward_t101*mu_4 + forward_t102*mu_5 + forward_t103*mu_6 + forward_t98*mu_1
        + forward_t99*mu_2 + g_11_z*o_L_z;
    const lane forward_t105 = (B_1_y*B_1_y);
    const lane forward_t106 = (B_2_y*B_2_y);
    const lane forward_t107 = (B_3_y*B_3_y);
    const lane forward_t108 = (B_4_y*B_4_y);
    const lane forward_t109 = (B_5_y*B_5_y);
    const lane forward_t110 = (B_6_y*B_6_y);
    const lane forward_t111 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + forward_t105*mu_1 + forward_t106*mu_2 + forward_t107*mu_3 + forward_t108*mu_4 + forward_t109*mu_5
        + forward_t110*mu_6 + g_11_y*o_L_y;
    const lane L_rx_rx = -forward_t104 - forward_t111;
    const lane forward_t112 = (1.0/2.0)*B_1_x;
    const lane forward_t113 = (1.0/2.0)*g_4_x;
    const lane forward_t114 = (1.0/2.0)*B_2_x;
    const lane forward_t115 = (1.0/2.0)*g_5_x;
    const lane forward_t116 = (1.0/2.0)*B_3_x;
    const lane forward_t117 = (1.0/2.0)*g_6_x;
    const lane forward_t118 = (1.0/2.0)*B_4_x;
    const lane forward_t119 = (1.0/2.0)*g_7_x;
    const lane forward_t120 = (1.0/2.0)*B_5_x;
    const lane forward_t121 = (1.0/2.0)*g_8_x;
    const lane forward_t122 = (1.0/2.0)*B_6_x;
    const lane forward_t123 = (1.0/2.0)*g_9_x;
    const lane forward_t124 = (1.0/2.0)*c_x;
    const double forward_t125 = (1.0/2.0)*g_10_x;
    const double forward_t126 = (1.0/2.0)*g_11_x;
    const lane forward_t127 = (1.0/2.0)*o_L_x;
    const lane L_rx_ry =
        B_1_x*forward_t97 + B_1_y*forward_t113 + B_2_x*forward_t92 + B_2_y*forward_t115 + B_3_x*forward_t93
        + B_3_y*forward_t117 + B_4_x*forward_t94 + B_4_y*forward_t119 + B_5_x*forward_t95
        + B_5_y*forward_t121 + B_6_x*forward_t96 + B_6_y*forward_t123 + c_y*forward_t125 + forward_t112*g_4_y
        + forward_t114*g_5_y + forward_t116*g_6_y + forward_t118*g_7_y + forward_t120*g_8_y
        + forward_t122*g_9_y + forward_t124*g_10_y + forward_t126*o_L_y + forward_t127*g_11_y;
    const lane L_rx_rz =
        B_1_x*forward_t86 + B_1_z*forward_t113 + B_2_x*forward_t87 + B_2_z*forward_t115 + B_3_x*forward_t88
        + B_3_z*forward_t117 + B_4_x*forward_t89 + B_4_z*forward_t119 + B_5_x*forward_t90
        + B_5_z*forward_t121 + B_6_x*forward_t91 + B_6_z*forward_t123 + c_z*forward_t125 + forward_t112*g_4_z
        + forward_t114*g_5_z + forward_t116*g_6_z + forward_t118*g_7_z + forward_t120*g_8_z
        + forward_t122*g_9_z + forward_t124*g_10_z + forward_t126*o_L_z + forward_t127*g_11_z;
    const lane forward_t128 = (B_1_x*B_1_x);
    const lane forward_t129 = (B_2_x*B_2_x);
    const lane forward_t130 = (B_3_x*B_3_x);
    const lane forward_t131 = (B_4_x*B_4_x);
    const lane forward_t132 = (B_5_x*B_5_x);
    const lane forward_t133 = (B_6_x*B_6_x);
    const lane forward_t134 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + forward_t128*mu_1 + forward_t129*mu_2 + forward_t130*mu_3 + forward_t131*mu_4 + forward_t132*mu_5
        + forward_t133*mu_6 + g_11_x*o_L_x;
    const lane L_ry_ry = -forward_t104 - forward_t134;
    const lane t62 = (1.0/2.0)*g_5_z;
    const lane t63 = (1.0/2.0)*B_2_z;
    const lane t64 = (1.0/2.0)*g_6_z;
    const lane t65 = (1.0/2.0)*B_3_z;
    const lane t66 = (1.0/2.0)*g_7_z;
    const lane t67 = (1.0/2.0)*B_4_z;
    const lane t68 = (1.0/2.0)*g_8_z;
    const lane t69 = (1.0/2.0)*B_5_z;
    const lane t70 = (1.0/2.0)*g_9_z;
    const lane t71 = (1.0/2.0)*B_6_z;
    const lane t72 = (1.0/2.0)*c_y;
    const lane t73 = (1.0/2.0)*c_z;
    const lane t74 = (1.0/2.0)*o_L_z;
    const lane t75 = (1.0/2.0)*o_L_y;
    const lane t76 = (1.0/2.0)*g_4_z;
    const lane t77 = (1.0/2.0)*B_1_z;
    const lane L_ry_rz =
        B_1_y*forward_t86 + B_1_y*t76 + B_2_y*forward_t87 + B_2_y*t62 + B_3_y*forward_t88 + B_3_y*t64
        + B_4_y*forward_t89 + B_4_y*t66 + B_5_y*forward_t90 + B_5_y*t68 + B_6_y*forward_t91 + B_6_y*t70
        + g_10_y*t73 + g_10_z*t72 + g_11_y*t74 + g_11_z*t75 + g_4_y*t77 + g_5_y*t63 + g_6_y*t65 + g_7_y*t67
        + g_8_y*t69 + g_9_y*t71;
    const lane L_rz_rz = -forward_t111 - forward_t134;
    const lane forward_t135 = forward_10*forward_t32;
    const lane forward_t136 = forward_t135*g_x;
    const lane f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + forward_t136;
    const lane forward_t137 = forward_12*forward_t36;
    const lane forward_t138 = forward_t137*g_x;
    const lane f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + forward_t138;
    const lane forward_t139 = forward_14*forward_t40;
    const lane forward_t140 = forward_t139*g_x;
    const lane f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + forward_t140;
    const lane forward_t141 = forward_16*forward_t44;
    const lane forward_t142 = forward_t141*g_x;
    const lane f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + forward_t142;
    const lane forward_t143 = forward_18*forward_t48;
    const lane forward_t144 = forward_t143*g_x;
    const lane f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + forward_t144;
    const lane forward_t145 = forward_20*forward_t52;
    const lane forward_t146 = forward_t145*g_x;
    const lane f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + forward_t146;
    const lane forward_t147 = forward_t135*g_y;
    const lane f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + forward_t147;
    const lane forward_t148 = forward_t137*g_y;
    const lane f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + forward_t148;
    const lane forward_t149 = forward_t139*g_y;
    const lane f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + forward_t149;
    const lane forward_t150 = forward_t141*g_y;
    const lane f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + forward_t150;
    const lane forward_t151 = forward_t143*g_y;
    const lane f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + forward_t151;
    const lane forward_t152 = forward_t145*g_y;
    const lane f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + forward_t152;
    const lane forward_t153 = forward_t135*g_z;
    const lane f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + forward_t153;
    const lane forward_t154 = forward_t137*g_z;
    const lane f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + forward_t154;
    const lane forward_t155 = forward_t139*g_z;
    const lane f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + forward_t155;
    const lane forward_t156 = forward_t141*g_z;
    const lane f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + forward_t156;
    const lane forward_t157 = forward_t143*g_z;
    const lane f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + forward_t157;
    const lane forward_t158 = forward_t145*g_z;
    const lane f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + forward_t158;
    const lane t78 = -B_1_y*g_z + B_1_z*g_y;
    const lane forward_t159 = forward_t135*t78;
    const lane f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx
        - forward_t159;
    const lane t79 = -B_2_y*g_z + B_2_z*g_y;
    const lane forward_t160 = forward_t137*t79;
    const lane f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx
        - forward_t160;
    const lane t80 = -B_3_y*g_z + B_3_z*g_y;
    const lane forward_t161 = forward_t139*t80;
    const lane f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx
        - forward_t161;
    const lane t81 = -B_4_y*g_z + B_4_z*g_y;
    const lane forward_t162 = forward_t141*t81;
    const lane f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx
        - forward_t162;
    const lane t82 = -B_5_y*g_z + B_5_z*g_y;
    const lane forward_t163 = forward_t143*t82;
    const lane f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx
        - forward_t163;
    const lane t83 = -B_6_y*g_z + B_6_z*g_y;
    const lane forward_t164 = forward_t145*t83;
    const lane f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx
        - forward_t164;
    const lane t84 = B_1_x*g_z - B_1_z*g_x;
    const lane forward_t165 = forward_t135*t84;
    const lane f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry
        - forward_t165;
    const lane t85 = B_2_x*g_z - B_2_z*g_x;
    const lane forward_t166 = forward_t137*t85;
    const lane f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry
        - forward_t166;
    const lane t86 = B_3_x*g_z - B_3_z*g_x;
    const lane forward_t167 = forward_t139*t86;
    const lane f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry
        - forward_t167;
    const lane t87 = B_4_x*g_z - B_4_z*g_x;
    const lane forward_t168 = forward_t141*t87;
    const lane f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry
        - forward_t168;
    const lane t88 = B_5_x*g_z - B_5_z*g_x;
    const lane forward_t169 = forward_t143*t88;
    const lane f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry
        - forward_t169;
    const lane t89 = B_6_x*g_z - B_6_z*g_x;
    const lane forward_t170 = forward_t145*t89;
    const lane f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry
        - forward_t170;
    const lane t90 = -B_1_x*g_y + B_1_y*g_x;
    const lane forward_t171 = forward_t135*t90;
    const lane f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz
        - forward_t171;
    const lane t91 = -B_2_x*g_y + B_2_y*g_x;
    const lane forward_t172 = forward_t137*t91;
    const lane f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz
        - forward_t172;
    const lane t92 = -B_3_x*g_y + B_3_y*g_x;
    const lane forward_t173 = forward_t139*t92;
    const lane f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz
        - forward_t173;
    const lane t93 = -B_4_x*g_y + B_4_y*g_x;
    const lane forward_t174 = forward_t141*t93;
    const lane f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz
        - forward_t174;
    const lane t94 = -B_5_x*g_y + B_5_y*g_x;
    const lane forward_t175 = forward_t143*t94;
    const lane f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz
        - forward_t175;
    const lane t95 = -B_6_x*g_y + B_6_y*g_x;
    const lane forward_t176 = forward_t145*t95;
    const lane f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz
        - forward_t176;
    const lane M_p_x_x = forward_t67 + m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6;
    const lane forward_t177 = B_1_z*m_perp_1;
    const lane forward_t178 = B_2_z*m_perp_2;
    const lane forward_t179 = B_3_z*m_perp_3;
    const lane forward_t180 = B_4_z*m_perp_4;
    const lane forward_t181 = B_5_z*m_perp_5;
    const lane forward_t182 = B_6_z*m_perp_6;
    const lane forward_t183 = c_z*m_p;
    const lane forward_t184 = m_L*o_L_z;
    const lane M_p_x_ry =
        forward_t177 + forward_t178 + forward_t179 + forward_t180 + forward_t181 + forward_t182
        + forward_t183 + forward_t184;
    const lane forward_t185 = B_1_y*m_perp_1;
    const lane forward_t186 = B_2_y*m_perp_2;
    const lane forward_t187 = B_3_y*m_perp_3;
    const lane forward_t188 = B_4_y*m_perp_4;
    const lane forward_t189 = B_5_y*m_perp_5;
    const lane forward_t190 = B_6_y*m_perp_6;
    const lane forward_t191 = c_y*m_p;
    const lane forward_t192 = m_L*o_L_y;
    const lane M_p_z_rx =
        forward_t185 + forward_t186 + forward_t187 + forward_t188 + forward_t189 + forward_t190
        + forward_t191 + forward_t192;
    const lane M_p_x_rz = -M_p_z_rx;
    const lane M_p_y_rx = -M_p_x_ry;
    const lane forward_t193 = B_1_x*m_perp_1;
    const lane forward_t194 = B_2_x*m_perp_2;
    const lane forward_t195 = B_3_x*m_perp_3;
    const lane forward_t196 = B_4_x*m_perp_4;
    const lane forward_t197 = B_5_x*m_perp_5;
    const lane forward_t198 = B_6_x*m_perp_6;
    const lane M_p_y_rz =
        c_x*m_p + forward_t193 + forward_t194 + forward_t195 + forward_t196 + forward_t197 + forward_t198
        + m_L*o_L_x;
    const lane M_p_z_ry = -M_p_y_rz;
    const lane forward_t199 = 2.0*(o_L_y*o_L_y);
    const lane forward_t200 = 2.0*(o_L_z*o_L_z);
    const double forward_t201 = (1.0/2.0)*m_L;
    const lane forward_t202 = 2.0*(c_y*c_y);
    const lane forward_t203 = 2.0*(c_z*c_z);
    const double forward_t204 = (1.0/2.0)*m_p;
    const lane forward_t205 = 2.0*forward_t105;
    const lane forward_t206 = 2.0*forward_t98;
    const lane forward_t207 = (1.0/2.0)*m_perp_1;
    const lane forward_t208 = 2.0*forward_t106;
    const lane forward_t209 = 2.0*forward_t99;
    const lane forward_t210 = (1.0/2.0)*m_perp_2;
    const lane forward_t211 = 2.0*forward_t107;
    const lane forward_t212 = 2.0*forward_t100;
    const lane forward_t213 = (1.0/2.0)*m_perp_3;
    const lane forward_t214 = 2.0*forward_t108;
    const lane forward_t215 = 2.0*forward_t101;
    const lane forward_t216 = (1.0/2.0)*m_perp_4;
    const lane forward_t217 = 2.0*forward_t109;
    const lane forward_t218 = 2.0*forward_t102;
    const lane forward_t219 = (1.0/2.0)*m_perp_5;
    const lane forward_t220 = 2.0*forward_t110;
    const lane forward_t221 = 2.0*forward_t103;
    const lane forward_t222 = (1.0/2.0)*m_perp_6;
    const lane t96 = forward_t199 + forward_t200;
    const lane t97 = forward_t202 + forward_t203;
    const lane t98 = forward_t205 + forward_t206;
    const lane t99 = forward_t208 + forward_t209;
    const lane t100 = forward_t211 + forward_t212;
    const lane t101 = forward_t214 + forward_t215;
    const lane t102 = forward_t217 + forward_t218;
    const lane t103 = forward_t220 + forward_t221;
    const lane M_p_rx_rx =
        J_x_x + forward_t201*t96 + forward_t204*t97 + forward_t207*t98 + forward_t210*t99 + forward_t213*t100
        + forward_t216*t101 + forward_t219*t102 + forward_t222*t103;
    const lane M_p_rx_ry =
        -B_1_x*forward_t185 - B_2_x*forward_t186 - B_3_x*forward_t187 - B_4_x*forward_t188
        - B_5_x*forward_t189 - B_6_x*forward_t190 + J_x_y - c_x*forward_t191 - forward_t192*o_L_x;
    const lane M_p_rx_rz =
        -B_1_x*forward_t177 - B_2_x*forward_t178 - B_3_x*forward_t179 - B_4_x*forward_t180
        - B_5_x*forward_t181 - B_6_x*forward_t182 + J_x_z - c_x*forward_t183 - forward_t184*o_L_x;
    const lane forward_t223 = 2.0*(o_L_x*o_L_x);
    const lane forward_t224 = 2.0*(c_x*c_x);
    const lane forward_t225 = 2.0*forward_t128;
    const lane forward_t226 = 2.0*forward_t129;
    const lane forward_t227 = 2.0*forward_t130;
    const lane forward_t228 = 2.0*forward_t131;
    const lane forward_t229 = 2.0*forward_t132;
    const lane forward_t230 = 2.0*forward_t133;
    const lane t104 = forward_t200 + forward_t223;
    const lane t105 = forward_t203 + forward_t224;
    const lane t106 = forward_t206 + forward_t225;
    const lane t107 = forward_t209 + forward_t226;
    const lane t108 = forward_t212 + forward_t227;
    const lane t109 = forward_t215 + forward_t228;
    const lane t110 = forward_t218 + forward_t229;
    const lane t111 = forward_t221 + forward_t230;
    const lane M_p_ry_ry =
        J_y_y + forward_t201*t104 + forward_t204*t105 + forward_t207*t106 + forward_t210*t107
        + forward_t213*t108 + forward_t216*t109 + forward_t219*t110 + forward_t222*t111;
    const lane M_p_ry_rz =
        -B_1_y*forward_t177 - B_2_y*forward_t178 - B_3_y*forward_t179 - B_4_y*forward_t180
        - B_5_y*forward_t181 - B_6_y*forward_t182 + J_y_z - c_y*forward_t183 - forward_t184*o_L_y;
    const lane t112 = forward_t199 + forward_t223;
    const lane t113 = forward_t202 + forward_t224;
    const lane t114 = forward_t205 + forward_t225;
    const lane t115 = forward_t208 + forward_t226;
    const lane t116 = forward_t211 + forward_t227;
    const lane t117 = forward_t214 + forward_t228;
    const lane t118 = forward_t217 + forward_t229;
    const lane t119 = forward_t220 + forward_t230;
    const lane M_p_rz_rz =
        J_z_z + forward_t201*t112 + forward_t204*t113 + forward_t207*t114 + forward_t210*t115
        + forward_t213*t116 + forward_t216*t117 + forward_t219*t118 + forward_t222*t119;
    const lane h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const lane h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const lane h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const lane h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const lane h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const lane h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const lane forward_t231 =
        m_lift_1 + m_lift_2 + m_lift_3 + m_lift_4 + m_lift_5 + m_lift_6 - m_perp_1 - m_perp_2 - m_perp_3
        - m_perp_4 - m_perp_5 - m_perp_6;
    const lane h_x_u_x = M_p_x_x + forward_t231;
    const lane h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const lane h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const lane h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const lane h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const lane h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const lane h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const lane h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const lane h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const lane h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const lane h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const lane h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const lane h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
    const lane h_rx_l_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx;
    const lane h_rx_l_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx;
    const lane h_rx_l_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx;
    const lane h_rx_l_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx;
    const lane h_rx_l_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx;
    const lane h_rx_l_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx;
    const lane forward_t232 =
        B_1_z*forward_t33 + B_1_z*m_r_1 + B_2_z*forward_t37 + B_2_z*m_r_2 + B_3_z*forward_t41 + B_3_z*m_r_3
        + B_4_z*forward_t45 + B_4_z*m_r_4 + B_5_z*forward_t49 + B_5_z*m_r_5 + B_6_z*forward_t53 + B_6_z*m_r_6
        - forward_t177 - forward_t178 - forward_t179 - forward_t180 - forward_t181 - forward_t182;
    const lane h_rx_u_y = M_p_y_rx - forward_t232;
    const lane forward_t233 =
        B_1_y*forward_t33 + B_1_y*m_r_1 + B_2_y*forward_t37 + B_2_y*m_r_2 + B_3_y*forward_t41 + B_3_y*m_r_3
        + B_4_y*forward_t45 + B_4_y*m_r_4 + B_5_y*forward_t49 + B_5_y*m_r_5 + B_6_y*forward_t53 + B_6_y*m_r_6
        - forward_t185 - forward_t186 - forward_t187 - forward_t188 - forward_t189 - forward_t190;
    const lane h_rx_u_z = M_p_z_rx + forward_t233;
    const lane h_ry_l_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry;
    const lane h_ry_l_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry;
    const lane h_ry_l_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry;
    const lane h_ry_l_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry;
    const lane h_ry_l_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry;
    const lane h_ry_l_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry;
    const lane h_ry_u_x = M_p_x_ry + forward_t232;
    const lane forward_t234 =
        B_1_x*forward_t33 + B_1_x*m_r_1 + B_2_x*forward_t37 + B_2_x*m_r_2 + B_3_x*forward_t41 + B_3_x*m_r_3
        + B_4_x*forward_t45 + B_4_x*m_r_4 + B_5_x*forward_t49 + B_5_x*m_r_5 + B_6_x*forward_t53 + B_6_x*m_r_6
        - forward_t193 - forward_t194 - forward_t195 - forward_t196 - forward_t197 - forward_t198;
    const lane h_ry_u_z = M_p_z_ry - forward_t234;
    const lane h_rz_l_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz;
    const lane h_rz_l_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz;
    const lane h_rz_l_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz;
    const lane h_rz_l_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz;
    const lane h_rz_l_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz;
    const lane h_rz_l_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz;
    const lane h_rz_u_x = M_p_x_rz - forward_t233;
    const lane h_rz_u_y = M_p_y_rz + forward_t234;
    const lane forward_t236 = D_p_x_1*k_C;
    const lane forward_t237 = D_p_y_1*k_C;
    const lane forward_t238 = D_p_z_1*k_C;
    const lane forward_t239 = D_p_x_2*k_C;
    const lane forward_t240 = D_p_y_2*k_C;
    const lane forward_t241 = D_p_z_2*k_C;
    const lane forward_t242 = D_p_x_3*k_C;
    const lane forward_t243 = D_p_y_3*k_C;
    const lane forward_t244 = D_p_z_3*k_C;
    const lane forward_t245 = D_p_x_4*k_C;
    const lane forward_t246 = D_p_y_4*k_C;
    const lane forward_t247 = D_p_z_4*k_C;
    const lane forward_t248 = D_p_x_5*k_C;
    const lane forward_t249 = D_p_y_5*k_C;
    const lane forward_t250 = D_p_z_5*k_C;
    const double forward_23 = 1.0/((h_m_1*h_m_1));
    const double forward_24 = 1.0/((h_m_2*h_m_2));
    const double forward_25 = 1.0/((h_m_3*h_m_3));
    const double forward_26 = 1.0/((h_m_4*h_m_4));
    const double forward_27 = 1.0/((h_m_5*h_m_5));
    const double forward_28 = 1.0/((h_m_6*h_m_6));
    const lane forward_29 = 1.0/((forward_4*forward_4*forward_4));
    const lane forward_30 = 1.0/((forward_5*forward_5*forward_5));
    const lane forward_31 = 1.0/((forward_6*forward_6*forward_6));
    const lane forward_32 = 1.0/((forward_7*forward_7*forward_7));
    const lane forward_33 = 1.0/((forward_8*forward_8*forward_8));
    const lane forward_34 = 1.0/((forward_9*forward_9*forward_9));
    const lane t421 = forward_t153 + forward_t238;
    const lane t422 = forward_t154 + forward_t241;
    const lane t423 = forward_t155 + forward_t244;
    const lane t424 = forward_t156 + forward_t247;
    const double t425 = 2.0*k_C;
    const lane t430 = forward_t147 + forward_t237;
    const lane t431 = forward_t148 + forward_t240;
    const lane t432 = forward_t149 + forward_t243;
    const lane t433 = forward_t150 + forward_t246;
    const lane t438 = forward_t136 + forward_t236;
    const lane t439 = forward_t138 + forward_t239;
    const lane t440 = forward_t140 + forward_t242;
    const lane t441 = forward_t142 + forward_t245;
    const lane t460 = forward_t27 + forward_t28;
    const lane t464 = forward_t23 + forward_t25;
    const lane t466 = forward_t13 + forward_t15;
    const double t468 = 2.0*g_z;
    const lane t470 = 1.0/forward_9;
    const lane t473 = 1.0/forward_8;
    const lane t476 = 1.0/forward_7;
    const lane t480 = 1.0/forward_6;
    const lane t483 = 1.0/forward_5;
    const lane t487 = forward_t21 + t466;
    const lane t488 = forward_t12 + forward_t19 + forward_t20;
    const lane t489 = I_p_y*R_z_y;
    const lane t490 = forward_t16 + forward_t17 + forward_t18;
    const lane t493 = (1.0/2.0)*rot_x;
    const lane t507 = B_1_z*forward_t135;
    const lane t508 = B_2_z*forward_t137;
    const lane t509 = B_3_z*forward_t139;
    const lane t510 = B_4_z*forward_t141;
    const lane t511 = B_5_z*forward_t143;
    const lane t512 = B_6_z*forward_t145;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 15;
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
        const lane t120 = (shape_6*shape_6);
        const lane t121 = 2.0*t120*(-d_6_x*g_x - d_6_y*g_y - d_6_z*g_z);
        const lane adjoint_forward_34 = forward_t52*t121;
        const lane t122 = (shape_5*shape_5);
        const lane t123 = 2.0*t122*(-d_5_x*g_x - d_5_y*g_y - d_5_z*g_z);
        const lane adjoint_forward_33 = forward_t48*t123;
        const lane t124 = (shape_4*shape_4);
        const lane t125 = 2.0*t124*(-d_4_x*g_x - d_4_y*g_y - d_4_z*g_z);
        const lane adjoint_forward_32 = forward_t44*t125;
        const lane t126 = (shape_3*shape_3);
        const lane t127 = 2.0*t126*(-d_3_x*g_x - d_3_y*g_y - d_3_z*g_z);
        const lane adjoint_forward_31 = forward_t40*t127;
        const lane t128 = (shape_2*shape_2);
        const lane t129 = 2.0*t128*(-d_2_x*g_x - d_2_y*g_y - d_2_z*g_z);
        const lane adjoint_forward_30 = forward_t36*t129;
        const lane t130 = (shape_1*shape_1);
        const lane t131 = 2.0*t130*(-d_1_x*g_x - d_1_y*g_y - d_1_z*g_z);
        const lane adjoint_forward_29 = forward_t32*t131;
        const lane t132 = (shape_12*shape_12);
        const lane t133 = eigenvalue*t132;
        const lane adjoint_forward_28 = -I_m_6*t133;
        const lane t134 = (shape_11*shape_11);
        const lane t135 = eigenvalue*t134;
        const lane adjoint_forward_27 = -I_m_5*t135;
        const lane t136 = (shape_10*shape_10);
        const lane t137 = eigenvalue*t136;
        const lane adjoint_forward_26 = -I_m_4*t137;
        const lane t138 = (shape_9*shape_9);
        const lane t139 = eigenvalue*t138;
        const lane adjoint_forward_25 = -I_m_3*t139;
        const lane t140 = (shape_8*shape_8);
        const lane t141 = eigenvalue*t140;
        const lane adjoint_forward_24 = -I_m_2*t141;
        const lane t142 = (shape_7*shape_7);
        const lane t143 = eigenvalue*t142;
        const lane adjoint_forward_23 = -I_m_1*t143;
        const lane t144 = 2.0*shape_5;
        const lane t145 = shape_15*t144;
        const lane t146 = shape_6*t144;
        const lane t147 = D_p_z_6*t146;
        const lane adjoint_forward_t250 = t145 + t147;
        const lane t148 = shape_14*t144;
        const lane t149 = D_p_y_6*t146;
        const lane adjoint_forward_t249 = t148 + t149;
        const lane t150 = shape_13*t144;
        const lane t151 = D_p_x_6*t146;
        const lane adjoint_forward_t248 = t150 + t151;
        const lane t152 = 2.0*shape_4;
        const lane t153 = shape_15*t152;
        const lane t154 = shape_4*t144;
        const lane t155 = shape_6*t152;
        const lane t156 = D_p_z_5*t154 + D_p_z_6*t155;
        const lane adjoint_forward_t247 = t153 + t156;
        const lane t157 = shape_14*t152;
        const lane t158 = D_p_y_5*t154 + D_p_y_6*t155;
        const lane adjoint_forward_t246 = t157 + t158;
        const lane t159 = shape_13*t152;
        const lane t160 = D_p_x_5*t154 + D_p_x_6*t155;
        const lane adjoint_forward_t245 = t159 + t160;
        const lane t161 = 2.0*shape_3;
        const lane t162 = shape_15*t161;
        const lane t163 = shape_3*t152;
        const lane t164 = shape_3*t144;
        const lane t165 = shape_6*t161;
        const lane t166 = D_p_z_4*t163 + D_p_z_5*t164 + D_p_z_6*t165;
        const lane adjoint_forward_t244 = t162 + t166;
        const lane t167 = shape_14*t161;
        const lane t168 = D_p_y_4*t163 + D_p_y_5*t164 + D_p_y_6*t165;
        const lane adjoint_forward_t243 = t167 + t168;
        const lane t169 = shape_13*t161;
        const lane t170 = D_p_x_4*t163 + D_p_x_5*t164 + D_p_x_6*t165;
        const lane adjoint_forward_t242 = t169 + t170;
        const lane t171 = 2.0*shape_2;
        const lane t172 = shape_15*t171;
        const lane t173 = shape_2*t161;
        const lane t174 = shape_2*t152;
        const lane t175 = shape_2*t144;
        const lane t176 = shape_6*t171;
        const lane t177 = D_p_z_3*t173 + D_p_z_4*t174 + D_p_z_5*t175 + D_p_z_6*t176;
        const lane adjoint_forward_t241 = t172 + t177;
        const lane t178 = shape_14*t171;
        const lane t179 = D_p_y_3*t173 + D_p_y_4*t174 + D_p_y_5*t175 + D_p_y_6*t176;
        const lane adjoint_forward_t240 = t178 + t179;
        const lane t180 = shape_13*t171;
        const lane t181 = D_p_x_3*t173 + D_p_x_4*t174 + D_p_x_5*t175 + D_p_x_6*t176;
        const lane adjoint_forward_t239 = t180 + t181;
        const lane t182 = 2.0*shape_1;
        const lane t183 = shape_15*t182;
        const lane t184 = shape_1*t171;
        const lane t185 = shape_1*t161;
        const lane t186 = shape_1*t152;
        const lane t187 = shape_1*t144;
        const lane t188 = shape_6*t182;
        const lane t189 = D_p_z_2*t184 + D_p_z_3*t185 + D_p_z_4*t186 + D_p_z_5*t187 + D_p_z_6*t188;
        const lane adjoint_forward_t238 = t183 + t189;
        const lane t190 = shape_14*t182;
        const lane t191 = D_p_y_2*t184 + D_p_y_3*t185 + D_p_y_4*t186 + D_p_y_5*t187 + D_p_y_6*t188;
        const lane adjoint_forward_t237 = t190 + t191;
        const lane t192 = shape_13*t182;
        const lane t193 = D_p_x_2*t184 + D_p_x_3*t185 + D_p_x_4*t186 + D_p_x_5*t187 + D_p_x_6*t188;
        const lane adjoint_forward_t236 = t192 + t193;
        const lane t194 = (shape_13*shape_13);
        const lane t195 = eigenvalue*t194;
        const lane t196 = (shape_14*shape_14);
        const lane t197 = eigenvalue*t196;
        const lane t198 = (shape_15*shape_15);
        const lane t199 = eigenvalue*t198;
        const lane adjoint_forward_t235 = -t195 - t197 - t199;
        const lane t200 = D_p_rz_1*eigenvalue;
        const lane t201 = D_p_rz_2*eigenvalue;
        const lane t202 = D_p_rz_3*eigenvalue;
        const lane t203 = D_p_rz_4*eigenvalue;
        const lane t204 = D_p_rz_5*eigenvalue;
        const lane t205 = 2.0*shape_6;
        const lane t206 = shape_14*t205;
        const lane t207 = D_p_rz_6*eigenvalue;
        const lane adjoint_h_rz_u_y = -t148*t204 - t157*t203 - t167*t202 - t178*t201 - t190*t200 - t206*t207;
        const lane t208 = shape_13*t205;
        const lane adjoint_h_rz_u_x = -t150*t204 - t159*t203 - t169*t202 - t180*t201 - t192*t200 - t207*t208;
        const lane t209 = D_p_rz_6*t120;
        const lane t210 = D_p_rz_1*t188;
        const lane t211 = D_p_rz_2*t176;
        const lane t212 = D_p_rz_3*t165;
        const lane t213 = D_p_rz_4*t155;
        const lane t214 = D_p_rz_5*t146;
        const lane adjoint_h_rz_l_6 =
            -eigenvalue*t209 - eigenvalue*t210 - eigenvalue*t211 - eigenvalue*t212 - eigenvalue*t213
            - eigenvalue*t214;
        const lane t215 = D_p_rz_5*t122;
        const lane t216 = D_p_rz_1*t187;
        const lane t217 = D_p_rz_2*t175;
        const lane t218 = D_p_rz_3*t164;
        const lane t219 = D_p_rz_4*t154;
        const lane adjoint_h_rz_l_5 =
            -eigenvalue*t215 - eigenvalue*t216 - eigenvalue*t217 - eigenvalue*t218 - eigenvalue*t219;
        const lane t220 = D_p_rz_4*t124;
        const lane t221 = D_p_rz_1*t186;
        const lane t222 = D_p_rz_2*t174;
        const lane t223 = D_p_rz_3*t163;
        const lane adjoint_h_rz_l_4 = -eigenvalue*t220 - eigenvalue*t221 - eigenvalue*t222 - eigenvalue*t223;
        const lane t224 = D_p_rz_3*t126;
        const lane t225 = D_p_rz_1*t185;
        const lane t226 = D_p_rz_2*t173;
        const lane adjoint_h_rz_l_3 = -eigenvalue*t224 - eigenvalue*t225 - eigenvalue*t226;
        const lane t227 = D_p_rz_2*t128;
        const lane t228 = D_p_rz_1*t184;
        const lane adjoint_h_rz_l_2 = -eigenvalue*t227 - eigenvalue*t228;
        const lane adjoint_f_rz_l_1 = D_p_rz_1*t130;
        const lane adjoint_h_rz_l_1 = -adjoint_f_rz_l_1*eigenvalue;
        const lane t229 = D_p_ry_1*eigenvalue;
        const lane t230 = D_p_ry_2*eigenvalue;
        const lane t231 = D_p_ry_3*eigenvalue;
        const lane t232 = D_p_ry_4*eigenvalue;
        const lane t233 = D_p_ry_5*eigenvalue;
        const lane t234 = shape_15*t205;
        const lane t235 = D_p_ry_6*eigenvalue;
        const lane adjoint_h_ry_u_z = -t145*t233 - t153*t232 - t162*t231 - t172*t230 - t183*t229 - t234*t235;
        const lane adjoint_forward_t234 = -adjoint_h_ry_u_z + adjoint_h_rz_u_y;
        const lane adjoint_h_ry_u_x = -t150*t233 - t159*t232 - t169*t231 - t180*t230 - t192*t229 - t208*t235;
        const lane t236 = D_p_ry_6*t120;
        const lane t237 = D_p_ry_1*t188;
        const lane t238 = D_p_ry_2*t176;
        const lane t239 = D_p_ry_3*t165;
        const lane t240 = D_p_ry_4*t155;
        const lane t241 = D_p_ry_5*t146;
        const lane adjoint_h_ry_l_6 =
            -eigenvalue*t236 - eigenvalue*t237 - eigenvalue*t238 - eigenvalue*t239 - eigenvalue*t240
            - eigenvalue*t241;
        const lane t242 = D_p_ry_5*t122;
        const lane t243 = D_p_ry_1*t187;
        const lane t244 = D_p_ry_2*t175;
        const lane t245 = D_p_ry_3*t164;
        const lane t246 = D_p_ry_4*t154;
        const lane adjoint_h_ry_l_5 =
            -eigenvalue*t242 - eigenvalue*t243 - eigenvalue*t244 - eigenvalue*t245 - eigenvalue*t246;
        const lane t247 = D_p_ry_4*t124;
        const lane t248 = D_p_ry_1*t186;
        const lane t249 = D_p_ry_2*t174;
        const lane t250 = D_p_ry_3*t163;
        const lane adjoint_h_ry_l_4 = -eigenvalue*t247 - eigenvalue*t248 - eigenvalue*t249 - eigenvalue*t250;
        const lane t251 = D_p_ry_3*t126;
        const lane t252 = D_p_ry_1*t185;
        const lane t253 = D_p_ry_2*t173;
        const lane adjoint_h_ry_l_3 = -eigenvalue*t251 - eigenvalue*t252 - eigenvalue*t253;
        const lane t254 = D_p_ry_2*t128;
        const lane t255 = D_p_ry_1*t184;
        const lane adjoint_h_ry_l_2 = -eigenvalue*t254 - eigenvalue*t255;
        const lane adjoint_f_ry_l_1 = D_p_ry_1*t130;
        const lane adjoint_h_ry_l_1 = -adjoint_f_ry_l_1*eigenvalue;
        const lane t256 = D_p_rx_1*eigenvalue;
        const lane t257 = D_p_rx_2*eigenvalue;
        const lane t258 = D_p_rx_3*eigenvalue;
        const lane t259 = D_p_rx_4*eigenvalue;
        const lane t260 = D_p_rx_5*eigenvalue;
        const lane t261 = D_p_rx_6*eigenvalue;
        const lane adjoint_h_rx_u_z = -t145*t260 - t153*t259 - t162*t258 - t172*t257 - t183*t256 - t234*t261;
        const lane adjoint_forward_t233 = adjoint_h_rx_u_z - adjoint_h_rz_u_x;
        const lane adjoint_h_rx_u_y = -t148*t260 - t157*t259 - t167*t258 - t178*t257 - t190*t256 - t206*t261;
        const lane adjoint_forward_t232 = -adjoint_h_rx_u_y + adjoint_h_ry_u_x;
        const lane t262 = D_p_rx_6*t120;
        const lane t263 = D_p_rx_1*t188;
        const lane t264 = D_p_rx_2*t176;
        const lane t265 = D_p_rx_3*t165;
        const lane t266 = D_p_rx_4*t155;
        const lane t267 = D_p_rx_5*t146;
        const lane adjoint_h_rx_l_6 =
            -eigenvalue*t262 - eigenvalue*t263 - eigenvalue*t264 - eigenvalue*t265 - eigenvalue*t266
            - eigenvalue*t267;
        const lane t268 = D_p_rx_5*t122;
        const lane t269 = D_p_rx_1*t187;
        const lane t270 = D_p_rx_2*t175;
        const lane t271 = D_p_rx_3*t164;
        const lane t272 = D_p_rx_4*t154;
        const lane adjoint_h_rx_l_5 =
            -eigenvalue*t268 - eigenvalue*t269 - eigenvalue*t270 - eigenvalue*t271 - eigenvalue*t272;
        const lane t273 = D_p_rx_4*t124;
        const lane t274 = D_p_rx_1*t186;
        const lane t275 = D_p_rx_2*t174;
        const lane t276 = D_p_rx_3*t163;
        const lane adjoint_h_rx_l_4 = -eigenvalue*t273 - eigenvalue*t274 - eigenvalue*t275 - eigenvalue*t276;
        const lane t277 = D_p_rx_3*t126;
        const lane t278 = D_p_rx_1*t185;
        const lane t279 = D_p_rx_2*t173;
        const lane adjoint_h_rx_l_3 = -eigenvalue*t277 - eigenvalue*t278 - eigenvalue*t279;
        const lane t280 = D_p_rx_2*t128;
        const lane t281 = D_p_rx_1*t184;
        const lane adjoint_h_rx_l_2 = -eigenvalue*t280 - eigenvalue*t281;
        const lane adjoint_f_rx_l_1 = D_p_rx_1*t130;
        const lane adjoint_h_rx_l_1 = -adjoint_f_rx_l_1*eigenvalue;
        const lane t282 = eigenvalue*t183;
        const lane t283 = eigenvalue*t172;
        const lane t284 = eigenvalue*t162;
        const lane t285 = eigenvalue*t153;
        const lane t286 = eigenvalue*t145;
        const lane t287 = D_p_z_6*t234;
        const lane adjoint_h_z_u_z =
            -D_p_z_1*t282 - D_p_z_2*t283 - D_p_z_3*t284 - D_p_z_4*t285 - D_p_z_5*t286 - eigenvalue*t287
            - t199;
        const lane t288 = D_p_z_6*t120;
        const lane t289 = D_p_z_1*t188;
        const lane t290 = D_p_z_2*t176;
        const lane t291 = D_p_z_3*t165;
        const lane t292 = D_p_z_4*t155;
        const lane t293 = D_p_z_5*t146;
        const lane adjoint_h_z_l_6 =
            -eigenvalue*t288 - eigenvalue*t289 - eigenvalue*t290 - eigenvalue*t291 - eigenvalue*t292
            - eigenvalue*t293;
        const lane t294 = D_p_z_5*t122;
        const lane t295 = D_p_z_1*t187;
        const lane t296 = D_p_z_2*t175;
        const lane t297 = D_p_z_3*t164;
        const lane t298 = D_p_z_4*t154;
        const lane adjoint_h_z_l_5 =
            -eigenvalue*t294 - eigenvalue*t295 - eigenvalue*t296 - eigenvalue*t297 - eigenvalue*t298;
        const lane t299 = D_p_z_4*t124;
        const lane t300 = D_p_z_1*t186;
        const lane t301 = D_p_z_2*t174;
        const lane t302 = D_p_z_3*t163;
        const lane adjoint_h_z_l_4 = -eigenvalue*t299 - eigenvalue*t300 - eigenvalue*t301 - eigenvalue*t302;
        const lane t303 = D_p_z_3*t126;
        const lane t304 = D_p_z_1*t185;
        const lane t305 = D_p_z_2*t173;
        const lane adjoint_h_z_l_3 = -eigenvalue*t303 - eigenvalue*t304 - eigenvalue*t305;
        const lane t306 = D_p_z_2*t128;
        const lane t307 = D_p_z_1*t184;
        const lane adjoint_h_z_l_2 = -eigenvalue*t306 - eigenvalue*t307;
        const lane adjoint_f_z_l_1 = D_p_z_1*t130;
        const lane adjoint_h_z_l_1 = -adjoint_f_z_l_1*eigenvalue;
        const lane t308 = eigenvalue*t190;
        const lane t309 = eigenvalue*t178;
        const lane t310 = eigenvalue*t167;
        const lane t311 = eigenvalue*t157;
        const lane t312 = eigenvalue*t148;
        const lane t313 = D_p_y_6*t206;
        const lane adjoint_h_y_u_y =
            -D_p_y_1*t308 - D_p_y_2*t309 - D_p_y_3*t310 - D_p_y_4*t311 - D_p_y_5*t312 - eigenvalue*t313
            - t197;
        const lane t314 = D_p_y_6*t120;
        const lane t315 = D_p_y_1*t188;
        const lane t316 = D_p_y_2*t176;
        const lane t317 = D_p_y_3*t165;
        const lane t318 = D_p_y_4*t155;
        const lane t319 = D_p_y_5*t146;
        const lane adjoint_h_y_l_6 =
            -eigenvalue*t314 - eigenvalue*t315 - eigenvalue*t316 - eigenvalue*t317 - eigenvalue*t318
            - eigenvalue*t319;
        const lane t320 = D_p_y_5*t122;
        const lane t321 = D_p_y_1*t187;
        const lane t322 = D_p_y_2*t175;
        const lane t323 = D_p_y_3*t164;
        const lane t324 = D_p_y_4*t154;
        const lane adjoint_h_y_l_5 =
            -eigenvalue*t320 - eigenvalue*t321 - eigenvalue*t322 - eigenvalue*t323 - eigenvalue*t324;
        const lane t325 = D_p_y_4*t124;
        const lane t326 = D_p_y_1*t186;
        const lane t327 = D_p_y_2*t174;
        const lane t328 = D_p_y_3*t163;
        const lane adjoint_h_y_l_4 = -eigenvalue*t325 - eigenvalue*t326 - eigenvalue*t327 - eigenvalue*t328;
        const lane t329 = D_p_y_3*t126;
        const lane t330 = D_p_y_1*t185;
        const lane t331 = D_p_y_2*t173;
        const lane adjoint_h_y_l_3 = -eigenvalue*t329 - eigenvalue*t330 - eigenvalue*t331;
        const lane t332 = D_p_y_2*t128;
        const lane t333 = D_p_y_1*t184;
        const lane adjoint_h_y_l_2 = -eigenvalue*t332 - eigenvalue*t333;
        const lane adjoint_f_y_l_1 = D_p_y_1*t130;
        const lane adjoint_h_y_l_1 = -adjoint_f_y_l_1*eigenvalue;
        const lane t334 = eigenvalue*t192;
        const lane t335 = eigenvalue*t180;
        const lane t336 = eigenvalue*t169;
        const lane t337 = eigenvalue*t159;
        const lane t338 = eigenvalue*t150;
        const lane t339 = D_p_x_6*t208;
        const lane adjoint_h_x_u_x =
            -D_p_x_1*t334 - D_p_x_2*t335 - D_p_x_3*t336 - D_p_x_4*t337 - D_p_x_5*t338 - eigenvalue*t339
            - t195;
        const lane adjoint_forward_t231 = adjoint_h_x_u_x + adjoint_h_y_u_y + adjoint_h_z_u_z;
        const lane t340 = D_p_x_6*t120;
        const lane t341 = D_p_x_1*t188;
        const lane t342 = D_p_x_2*t176;
        const lane t343 = D_p_x_3*t165;
        const lane t344 = D_p_x_4*t155;
        const lane t345 = D_p_x_5*t146;
        const lane adjoint_h_x_l_6 =
            -eigenvalue*t340 - eigenvalue*t341 - eigenvalue*t342 - eigenvalue*t343 - eigenvalue*t344
            - eigenvalue*t345;
        const lane t346 = D_p_x_5*t122;
        const lane t347 = D_p_x_1*t187;
        const lane t348 = D_p_x_2*t175;
        const lane t349 = D_p_x_3*t164;
        const lane t350 = D_p_x_4*t154;
        const lane adjoint_h_x_l_5 =
            -eigenvalue*t346 - eigenvalue*t347 - eigenvalue*t348 - eigenvalue*t349 - eigenvalue*t350;
        const lane t351 = D_p_x_4*t124;
        const lane t352 = D_p_x_1*t186;
        const lane t353 = D_p_x_2*t174;
        const lane t354 = D_p_x_3*t163;
        const lane adjoint_h_x_l_4 = -eigenvalue*t351 - eigenvalue*t352 - eigenvalue*t353 - eigenvalue*t354;
        const lane t355 = D_p_x_3*t126;
        const lane t356 = D_p_x_1*t185;
        const lane t357 = D_p_x_2*t173;
        const lane adjoint_h_x_l_3 = -eigenvalue*t355 - eigenvalue*t356 - eigenvalue*t357;
        const lane t358 = D_p_x_2*t128;
        const lane t359 = D_p_x_1*t184;
        const lane adjoint_h_x_l_2 = -eigenvalue*t358 - eigenvalue*t359;
        const lane adjoint_f_x_l_1 = D_p_x_1*t130;
        const lane adjoint_h_x_l_1 = -adjoint_f_x_l_1*eigenvalue;
        const lane adjoint_M_p_rz_rz =
            D_p_rz_1*adjoint_h_rz_l_1 + D_p_rz_2*adjoint_h_rz_l_2 + D_p_rz_3*adjoint_h_rz_l_3
            + D_p_rz_4*adjoint_h_rz_l_4 + D_p_rz_5*adjoint_h_rz_l_5 + D_p_rz_6*adjoint_h_rz_l_6;
        const lane adjoint_M_p_ry_rz =
            D_p_ry_1*adjoint_h_rz_l_1 + D_p_ry_2*adjoint_h_rz_l_2 + D_p_ry_3*adjoint_h_rz_l_3
            + D_p_ry_4*adjoint_h_rz_l_4 + D_p_ry_5*adjoint_h_rz_l_5 + D_p_ry_6*adjoint_h_rz_l_6
            + D_p_rz_1*adjoint_h_ry_l_1 + D_p_rz_2*adjoint_h_ry_l_2 + D_p_rz_3*adjoint_h_ry_l_3
            + D_p_rz_4*adjoint_h_ry_l_4 + D_p_rz_5*adjoint_h_ry_l_5 + D_p_rz_6*adjoint_h_ry_l_6;
        const lane adjoint_M_p_ry_ry =
            D_p_ry_1*adjoint_h_ry_l_1 + D_p_ry_2*adjoint_h_ry_l_2 + D_p_ry_3*adjoint_h_ry_l_3
            + D_p_ry_4*adjoint_h_ry_l_4 + D_p_ry_5*adjoint_h_ry_l_5 + D_p_ry_6*adjoint_h_ry_l_6;
        const lane t360 = adjoint_M_p_ry_ry*forward_t222;
        const lane t361 = adjoint_M_p_rz_rz*forward_t222;
        const lane adjoint_forward_t230 = t360 + t361;
        const lane t362 = adjoint_M_p_ry_ry*forward_t219;
        const lane t363 = adjoint_M_p_rz_rz*forward_t219;
        const lane adjoint_forward_t229 = t362 + t363;
        const lane t364 = adjoint_M_p_ry_ry*forward_t216;
        const lane t365 = adjoint_M_p_rz_rz*forward_t216;
        const lane adjoint_forward_t228 = t364 + t365;
        const lane t366 = adjoint_M_p_ry_ry*forward_t213;
        const lane t367 = adjoint_M_p_rz_rz*forward_t213;
        const lane adjoint_forward_t227 = t366 + t367;
        const lane t368 = adjoint_M_p_ry_ry*forward_t210;
        const lane t369 = adjoint_M_p_rz_rz*forward_t210;
        const lane adjoint_forward_t226 = t368 + t369;
        const lane t370 = adjoint_M_p_ry_ry*forward_t207;
        const lane t371 = adjoint_M_p_rz_rz*forward_t207;
        const lane adjoint_forward_t225 = t370 + t371;
        const lane t372 = adjoint_M_p_ry_ry*forward_t204;
        const lane t373 = adjoint_M_p_rz_rz*forward_t204;
        const lane adjoint_forward_t224 = t372 + t373;
        const lane t374 = adjoint_M_p_ry_ry*forward_t201;
        const lane t375 = adjoint_M_p_rz_rz*forward_t201;
        const lane adjoint_forward_t223 = t374 + t375;
        const lane adjoint_M_p_rx_rz =
            D_p_rx_1*adjoint_h_rz_l_1 + D_p_rx_2*adjoint_h_rz_l_2 + D_p_rx_3*adjoint_h_rz_l_3
            + D_p_rx_4*adjoint_h_rz_l_4 + D_p_rx_5*adjoint_h_rz_l_5 + D_p_rx_6*adjoint_h_rz_l_6
            + D_p_rz_1*adjoint_h_rx_l_1 + D_p_rz_2*adjoint_h_rx_l_2 + D_p_rz_3*adjoint_h_rx_l_3
            + D_p_rz_4*adjoint_h_rx_l_4 + D_p_rz_5*adjoint_h_rx_l_5 + D_p_rz_6*adjoint_h_rx_l_6;
        const lane adjoint_M_p_rx_ry =
            D_p_rx_1*adjoint_h_ry_l_1 + D_p_rx_2*adjoint_h_ry_l_2 + D_p_rx_3*adjoint_h_ry_l_3
            + D_p_rx_4*adjoint_h_ry_l_4 + D_p_rx_5*adjoint_h_ry_l_5 + D_p_rx_6*adjoint_h_ry_l_6
            + D_p_ry_1*adjoint_h_rx_l_1 + D_p_ry_2*adjoint_h_rx_l_2 + D_p_ry_3*adjoint_h_rx_l_3
            + D_p_ry_4*adjoint_h_rx_l_4 + D_p_ry_5*adjoint_h_rx_l_5 + D_p_ry_6*adjoint_h_rx_l_6;
        const lane adjoint_M_p_rx_rx =
            D_p_rx_1*adjoint_h_rx_l_1 + D_p_rx_2*adjoint_h_rx_l_2 + D_p_rx_3*adjoint_h_rx_l_3
            + D_p_rx_4*adjoint_h_rx_l_4 + D_p_rx_5*adjoint_h_rx_l_5 + D_p_rx_6*adjoint_h_rx_l_6;
        const lane adjoint_forward_t222 =
            adjoint_M_p_rx_rx*t103 + adjoint_M_p_ry_ry*t111 + adjoint_M_p_rz_rz*t119;
        const lane t376 = adjoint_M_p_rx_rx*forward_t222;
        const lane adjoint_forward_t221 = t360 + t376;
        const lane adjoint_forward_t220 = t361 + t376;
        const lane adjoint_forward_t219 =
            adjoint_M_p_rx_rx*t102 + adjoint_M_p_ry_ry*t110 + adjoint_M_p_rz_rz*t118;
        const lane t377 = adjoint_M_p_rx_rx*forward_t219;
        const lane adjoint_forward_t218 = t362 + t377;
        const lane adjoint_forward_t217 = t363 + t377;
        const lane adjoint_forward_t216 =
            adjoint_M_p_rx_rx*t101 + adjoint_M_p_ry_ry*t109 + adjoint_M_p_rz_rz*t117;
        const lane t378 = adjoint_M_p_rx_rx*forward_t216;
        const lane adjoint_forward_t215 = t364 + t378;
        const lane adjoint_forward_t214 = t365 + t378;
        const lane adjoint_forward_t213 =
            adjoint_M_p_rx_rx*t100 + adjoint_M_p_ry_ry*t108 + adjoint_M_p_rz_rz*t116;
        const lane t379 = adjoint_M_p_rx_rx*forward_t213;
        const lane adjoint_forward_t212 = t366 + t379;
        const lane adjoint_forward_t211 = t367 + t379;
        const lane adjoint_forward_t210 =
            adjoint_M_p_rx_rx*t99 + adjoint_M_p_ry_ry*t107 + adjoint_M_p_rz_rz*t115;
        const lane t380 = adjoint_M_p_rx_rx*forward_t210;
        const lane adjoint_forward_t209 = t368 + t380;
        const lane adjoint_forward_t208 = t369 + t380;
        const lane adjoint_forward_t207 =
            adjoint_M_p_rx_rx*t98 + adjoint_M_p_ry_ry*t106 + adjoint_M_p_rz_rz*t114;
        const lane t381 = adjoint_M_p_rx_rx*forward_t207;
        const lane adjoint_forward_t206 = t370 + t381;
        const lane adjoint_forward_t205 = t371 + t381;
        const lane adjoint_forward_t204 =
            adjoint_M_p_rx_rx*t97 + adjoint_M_p_ry_ry*t105 + adjoint_M_p_rz_rz*t113;
        const lane t382 = adjoint_M_p_rx_rx*forward_t204;
        const lane adjoint_forward_t203 = t372 + t382;
        const lane adjoint_forward_t202 = t373 + t382;
        const lane adjoint_forward_t201 =
            adjoint_M_p_rx_rx*t96 + adjoint_M_p_ry_ry*t104 + adjoint_M_p_rz_rz*t112;
        const lane t383 = adjoint_M_p_rx_rx*forward_t201;
        const lane adjoint_forward_t200 = t374 + t383;
        const lane adjoint_forward_t199 = t375 + t383;
        const lane adjoint_M_p_z_ry =
            D_p_ry_1*adjoint_h_z_l_1 + D_p_ry_2*adjoint_h_z_l_2 + D_p_ry_3*adjoint_h_z_l_3
            + D_p_ry_4*adjoint_h_z_l_4 + D_p_ry_5*adjoint_h_z_l_5 + D_p_ry_6*adjoint_h_z_l_6
            + D_p_z_1*adjoint_h_ry_l_1 + D_p_z_2*adjoint_h_ry_l_2 + D_p_z_3*adjoint_h_ry_l_3
            + D_p_z_4*adjoint_h_ry_l_4 + D_p_z_5*adjoint_h_ry_l_5 + D_p_z_6*adjoint_h_ry_l_6
            + adjoint_h_ry_u_z;
        const lane adjoint_M_p_y_rz =
            D_p_rz_1*adjoint_h_y_l_1 + D_p_rz_2*adjoint_h_y_l_2 + D_p_rz_3*adjoint_h_y_l_3
            + D_p_rz_4*adjoint_h_y_l_4 + D_p_rz_5*adjoint_h_y_l_5 + D_p_rz_6*adjoint_h_y_l_6
            + D_p_y_1*adjoint_h_rz_l_1 + D_p_y_2*adjoint_h_rz_l_2 + D_p_y_3*adjoint_h_rz_l_3
            + D_p_y_4*adjoint_h_rz_l_4 + D_p_y_5*adjoint_h_rz_l_5 + D_p_y_6*adjoint_h_rz_l_6
            - adjoint_M_p_z_ry + adjoint_h_rz_u_y;
        const lane adjoint_forward_t198 = adjoint_M_p_y_rz - adjoint_forward_t234;
        const lane adjoint_M_p_y_rx =
            D_p_rx_1*adjoint_h_y_l_1 + D_p_rx_2*adjoint_h_y_l_2 + D_p_rx_3*adjoint_h_y_l_3
            + D_p_rx_4*adjoint_h_y_l_4 + D_p_rx_5*adjoint_h_y_l_5 + D_p_rx_6*adjoint_h_y_l_6
            + D_p_y_1*adjoint_h_rx_l_1 + D_p_y_2*adjoint_h_rx_l_2 + D_p_y_3*adjoint_h_rx_l_3
            + D_p_y_4*adjoint_h_rx_l_4 + D_p_y_5*adjoint_h_rx_l_5 + D_p_y_6*adjoint_h_rx_l_6
            + adjoint_h_rx_u_y;
        const lane adjoint_M_p_x_rz =
            D_p_rz_1*adjoint_h_x_l_1 + D_p_rz_2*adjoint_h_x_l_2 + D_p_rz_3*adjoint_h_x_l_3
            + D_p_rz_4*adjoint_h_x_l_4 + D_p_rz_5*adjoint_h_x_l_5 + D_p_rz_6*adjoint_h_x_l_6
            + D_p_x_1*adjoint_h_rz_l_1 + D_p_x_2*adjoint_h_rz_l_2 + D_p_x_3*adjoint_h_rz_l_3
            + D_p_x_4*adjoint_h_rz_l_4 + D_p_x_5*adjoint_h_rz_l_5 + D_p_x_6*adjoint_h_rz_l_6
            + adjoint_h_rz_u_x;
        const lane adjoint_M_p_z_rx =
            D_p_rx_1*adjoint_h_z_l_1 + D_p_rx_2*adjoint_h_z_l_2 + D_p_rx_3*adjoint_h_z_l_3
            + D_p_rx_4*adjoint_h_z_l_4 + D_p_rx_5*adjoint_h_z_l_5 + D_p_rx_6*adjoint_h_z_l_6
            + D_p_z_1*adjoint_h_rx_l_1 + D_p_z_2*adjoint_h_rx_l_2 + D_p_z_3*adjoint_h_rx_l_3
            + D_p_z_4*adjoint_h_rx_l_4 + D_p_z_5*adjoint_h_rx_l_5 + D_p_z_6*adjoint_h_rx_l_6
            - adjoint_M_p_x_rz + adjoint_h_rx_u_z;
        const lane adjoint_forward_t192 = -adjoint_M_p_rx_ry*o_L_x + adjoint_M_p_z_rx;
        const lane adjoint_forward_t191 = -adjoint_M_p_rx_ry*c_x + adjoint_M_p_z_rx;
        const lane t384 = -adjoint_M_p_z_rx + adjoint_forward_t233;
        const lane adjoint_forward_t190 = -B_6_x*adjoint_M_p_rx_ry - t384;
        const lane adjoint_forward_t189 = -B_5_x*adjoint_M_p_rx_ry - t384;
        const lane adjoint_forward_t188 = -B_4_x*adjoint_M_p_rx_ry - t384;
        const lane adjoint_forward_t187 = -B_3_x*adjoint_M_p_rx_ry - t384;
        const lane adjoint_forward_t186 = -B_2_x*adjoint_M_p_rx_ry - t384;
        const lane adjoint_forward_t185 = -B_1_x*adjoint_M_p_rx_ry - t384;
        const lane adjoint_M_p_x_ry =
            D_p_ry_1*adjoint_h_x_l_1 + D_p_ry_2*adjoint_h_x_l_2 + D_p_ry_3*adjoint_h_x_l_3
            + D_p_ry_4*adjoint_h_x_l_4 + D_p_ry_5*adjoint_h_x_l_5 + D_p_ry_6*adjoint_h_x_l_6
            + D_p_x_1*adjoint_h_ry_l_1 + D_p_x_2*adjoint_h_ry_l_2 + D_p_x_3*adjoint_h_ry_l_3
            + D_p_x_4*adjoint_h_ry_l_4 + D_p_x_5*adjoint_h_ry_l_5 + D_p_x_6*adjoint_h_ry_l_6
            - adjoint_M_p_y_rx + adjoint_h_ry_u_x;
        const lane adjoint_forward_t184 =
            -adjoint_M_p_rx_rz*o_L_x - adjoint_M_p_ry_rz*o_L_y + adjoint_M_p_x_ry;
        const lane adjoint_forward_t183 = -adjoint_M_p_rx_rz*c_x - adjoint_M_p_ry_rz*c_y + adjoint_M_p_x_ry;
        const lane t385 = -adjoint_M_p_x_ry + adjoint_forward_t232;
        const lane adjoint_forward_t182 = -B_6_x*adjoint_M_p_rx_rz - B_6_y*adjoint_M_p_ry_rz - t385;
        const lane adjoint_forward_t181 = -B_5_x*adjoint_M_p_rx_rz - B_5_y*adjoint_M_p_ry_rz - t385;
        const lane adjoint_forward_t180 = -B_4_x*adjoint_M_p_rx_rz - B_4_y*adjoint_M_p_ry_rz - t385;
        const lane adjoint_forward_t179 = -B_3_x*adjoint_M_p_rx_rz - B_3_y*adjoint_M_p_ry_rz - t385;
        const lane adjoint_forward_t178 = -B_2_x*adjoint_M_p_rx_rz - B_2_y*adjoint_M_p_ry_rz - t385;
        const lane adjoint_forward_t177 = -B_1_x*adjoint_M_p_rx_rz - B_1_y*adjoint_M_p_ry_rz - t385;
        const lane adjoint_M_p_x_x =
            D_p_x_1*adjoint_h_x_l_1 + D_p_x_2*adjoint_h_x_l_2 + D_p_x_3*adjoint_h_x_l_3
            + D_p_x_4*adjoint_h_x_l_4 + D_p_x_5*adjoint_h_x_l_5 + D_p_x_6*adjoint_h_x_l_6
            + D_p_y_1*adjoint_h_y_l_1 + D_p_y_2*adjoint_h_y_l_2 + D_p_y_3*adjoint_h_y_l_3
            + D_p_y_4*adjoint_h_y_l_4 + D_p_y_5*adjoint_h_y_l_5 + D_p_y_6*adjoint_h_y_l_6
            + D_p_z_1*adjoint_h_z_l_1 + D_p_z_2*adjoint_h_z_l_2 + D_p_z_3*adjoint_h_z_l_3
            + D_p_z_4*adjoint_h_z_l_4 + D_p_z_5*adjoint_h_z_l_5 + D_p_z_6*adjoint_h_z_l_6
            + adjoint_forward_t231;
        const lane adjoint_f_rz_l_6 = t209 + t210 + t211 + t212 + t213 + t214;
        const lane adjoint_forward_t176 = -adjoint_f_rz_l_6 - t209;
        const lane adjoint_f_rz_l_5 = t215 + t216 + t217 + t218 + t219;
        const lane adjoint_forward_t175 = -D_p_rz_6*t146 - adjoint_f_rz_l_5 - t215;
        const lane adjoint_f_rz_l_4 = t220 + t221 + t222 + t223;
        const lane adjoint_forward_t174 = -D_p_rz_5*t154 - D_p_rz_6*t155 - adjoint_f_rz_l_4 - t220;
        const lane adjoint_f_rz_l_3 = t224 + t225 + t226;
        const lane adjoint_forward_t173 =
            -D_p_rz_4*t163 - D_p_rz_5*t164 - D_p_rz_6*t165 - adjoint_f_rz_l_3 - t224;
        const lane adjoint_f_rz_l_2 = t227 + t228;
        const lane adjoint_forward_t172 =
            -D_p_rz_3*t173 - D_p_rz_4*t174 - D_p_rz_5*t175 - D_p_rz_6*t176 - adjoint_f_rz_l_2 - t227;
        const lane adjoint_forward_t171 =
            -D_p_rz_2*t184 - D_p_rz_3*t185 - D_p_rz_4*t186 - D_p_rz_5*t187 - D_p_rz_6*t188
            - 2.0*adjoint_f_rz_l_1;
        const lane adjoint_f_ry_l_6 = t236 + t237 + t238 + t239 + t240 + t241;
        const lane adjoint_forward_t170 = -adjoint_f_ry_l_6 - t236;
        const lane adjoint_f_ry_l_5 = t242 + t243 + t244 + t245 + t246;
        const lane adjoint_forward_t169 = -D_p_ry_6*t146 - adjoint_f_ry_l_5 - t242;
        const lane adjoint_f_ry_l_4 = t247 + t248 + t249 + t250;
        const lane adjoint_forward_t168 = -D_p_ry_5*t154 - D_p_ry_6*t155 - adjoint_f_ry_l_4 - t247;
        const lane adjoint_f_ry_l_3 = t251 + t252 + t253;
        const lane adjoint_forward_t167 =
            -D_p_ry_4*t163 - D_p_ry_5*t164 - D_p_ry_6*t165 - adjoint_f_ry_l_3 - t251;
        const lane adjoint_f_ry_l_2 = t254 + t255;
        const lane adjoint_forward_t166 =
            -D_p_ry_3*t173 - D_p_ry_4*t174 - D_p_ry_5*t175 - D_p_ry_6*t176 - adjoint_f_ry_l_2 - t254;
        const lane adjoint_forward_t165 =
            -D_p_ry_2*t184 - D_p_ry_3*t185 - D_p_ry_4*t186 - D_p_ry_5*t187 - D_p_ry_6*t188
            - 2.0*adjoint_f_ry_l_1;
        const lane adjoint_f_rx_l_6 = t262 + t263 + t264 + t265 + t266 + t267;
        const lane adjoint_forward_t164 = -adjoint_f_rx_l_6 - t262;
        const lane adjoint_f_rx_l_5 = t268 + t269 + t270 + t271 + t272;
        const lane adjoint_forward_t163 = -D_p_rx_6*t146 - adjoint_f_rx_l_5 - t268;
        const lane adjoint_f_rx_l_4 = t273 + t274 + t275 + t276;
        const lane adjoint_forward_t162 = -D_p_rx_5*t154 - D_p_rx_6*t155 - adjoint_f_rx_l_4 - t273;
        const lane adjoint_f_rx_l_3 = t277 + t278 + t279;
        const lane adjoint_forward_t161 =
            -D_p_rx_4*t163 - D_p_rx_5*t164 - D_p_rx_6*t165 - adjoint_f_rx_l_3 - t277;
        const lane adjoint_f_rx_l_2 = t280 + t281;
        const lane adjoint_forward_t160 =
            -D_p_rx_3*t173 - D_p_rx_4*t174 - D_p_rx_5*t175 - D_p_rx_6*t176 - adjoint_f_rx_l_2 - t280;
        const lane adjoint_forward_t159 =
            -D_p_rx_2*t184 - D_p_rx_3*t185 - D_p_rx_4*t186 - D_p_rx_5*t187 - D_p_rx_6*t188
            - 2.0*adjoint_f_rx_l_1;
        const lane adjoint_f_z_l_6 = t288 + t289 + t290 + t291 + t292 + t293;
        const lane adjoint_forward_t158 = adjoint_f_z_l_6 + t288;
        const lane adjoint_f_z_l_5 = t294 + t295 + t296 + t297 + t298;
        const lane adjoint_forward_t157 = adjoint_f_z_l_5 + t147 + t294;
        const lane adjoint_f_z_l_4 = t299 + t300 + t301 + t302;
        const lane adjoint_forward_t156 = adjoint_f_z_l_4 + t156 + t299;
        const lane adjoint_f_z_l_3 = t303 + t304 + t305;
        const lane adjoint_forward_t155 = adjoint_f_z_l_3 + t166 + t303;
        const lane adjoint_f_z_l_2 = t306 + t307;
        const lane adjoint_forward_t154 = adjoint_f_z_l_2 + t177 + t306;
        const lane adjoint_forward_t153 = 2.0*adjoint_f_z_l_1 + t189;
        const lane adjoint_f_y_l_6 = t314 + t315 + t316 + t317 + t318 + t319;
        const lane adjoint_forward_t152 = adjoint_f_y_l_6 + t314;
        const lane adjoint_f_y_l_5 = t320 + t321 + t322 + t323 + t324;
        const lane adjoint_forward_t151 = adjoint_f_y_l_5 + t149 + t320;
        const lane adjoint_f_y_l_4 = t325 + t326 + t327 + t328;
        const lane adjoint_forward_t150 = adjoint_f_y_l_4 + t158 + t325;
        const lane adjoint_f_y_l_3 = t329 + t330 + t331;
        const lane adjoint_forward_t149 = adjoint_f_y_l_3 + t168 + t329;
        const lane adjoint_f_y_l_2 = t332 + t333;
        const lane adjoint_forward_t148 = adjoint_f_y_l_2 + t179 + t332;
        const lane adjoint_forward_t147 = 2.0*adjoint_f_y_l_1 + t191;
        const lane adjoint_f_x_l_6 = t340 + t341 + t342 + t343 + t344 + t345;
        const lane adjoint_forward_t146 = adjoint_f_x_l_6 + t340;
        const lane t386 = eigenvalue*t208;
        const lane t387 = eigenvalue*t206;
        const lane t388 = eigenvalue*t234;
        const lane adjoint_forward_t145 =
            adjoint_forward_t146*g_x + adjoint_forward_t152*g_y + adjoint_forward_t158*g_z
            + adjoint_forward_t164*t83 + adjoint_forward_t170*t89 + adjoint_forward_t176*t95 + d_6_x*t386
            + d_6_y*t387 + d_6_z*t388;
        const lane adjoint_f_x_l_5 = t346 + t347 + t348 + t349 + t350;
        const lane adjoint_forward_t144 = adjoint_f_x_l_5 + t151 + t346;
        const lane adjoint_forward_t143 =
            adjoint_forward_t144*g_x + adjoint_forward_t151*g_y + adjoint_forward_t157*g_z
            + adjoint_forward_t163*t82 + adjoint_forward_t169*t88 + adjoint_forward_t175*t94 + d_5_x*t338
            + d_5_y*t312 + d_5_z*t286;
        const lane adjoint_f_x_l_4 = t351 + t352 + t353 + t354;
        const lane adjoint_forward_t142 = adjoint_f_x_l_4 + t160 + t351;
        const lane adjoint_forward_t141 =
            adjoint_forward_t142*g_x + adjoint_forward_t150*g_y + adjoint_forward_t156*g_z
            + adjoint_forward_t162*t81 + adjoint_forward_t168*t87 + adjoint_forward_t174*t93 + d_4_x*t337
            + d_4_y*t311 + d_4_z*t285;
        const lane adjoint_f_x_l_3 = t355 + t356 + t357;
        const lane adjoint_forward_t140 = adjoint_f_x_l_3 + t170 + t355;
        const lane adjoint_forward_t139 =
            adjoint_forward_t140*g_x + adjoint_forward_t149*g_y + adjoint_forward_t155*g_z
            + adjoint_forward_t161*t80 + adjoint_forward_t167*t86 + adjoint_forward_t173*t92 + d_3_x*t336
            + d_3_y*t310 + d_3_z*t284;
        const lane adjoint_f_x_l_2 = t358 + t359;
        const lane adjoint_forward_t138 = adjoint_f_x_l_2 + t181 + t358;
        const lane adjoint_forward_t137 =
            adjoint_forward_t138*g_x + adjoint_forward_t148*g_y + adjoint_forward_t154*g_z
            + adjoint_forward_t160*t79 + adjoint_forward_t166*t85 + adjoint_forward_t172*t91 + d_2_x*t335
            + d_2_y*t309 + d_2_z*t283;
        const lane adjoint_forward_t136 = 2.0*adjoint_f_x_l_1 + t193;
        const lane adjoint_forward_t135 =
            adjoint_forward_t136*g_x + adjoint_forward_t147*g_y + adjoint_forward_t153*g_z
            + adjoint_forward_t159*t78 + adjoint_forward_t165*t84 + adjoint_forward_t171*t90 + d_1_x*t334
            + d_1_y*t308 + d_1_z*t282;
        const lane adjoint_L_rz_rz =
            D_p_rz_1*adjoint_f_rz_l_1 + D_p_rz_2*adjoint_f_rz_l_2 + D_p_rz_3*adjoint_f_rz_l_3
            + D_p_rz_4*adjoint_f_rz_l_4 + D_p_rz_5*adjoint_f_rz_l_5 + D_p_rz_6*adjoint_f_rz_l_6;
        const lane adjoint_L_ry_rz =
            D_p_ry_1*adjoint_f_rz_l_1 + D_p_ry_2*adjoint_f_rz_l_2 + D_p_ry_3*adjoint_f_rz_l_3
            + D_p_ry_4*adjoint_f_rz_l_4 + D_p_ry_5*adjoint_f_rz_l_5 + D_p_ry_6*adjoint_f_rz_l_6
            + D_p_rz_1*adjoint_f_ry_l_1 + D_p_rz_2*adjoint_f_ry_l_2 + D_p_rz_3*adjoint_f_ry_l_3
            + D_p_rz_4*adjoint_f_ry_l_4 + D_p_rz_5*adjoint_f_ry_l_5 + D_p_rz_6*adjoint_f_ry_l_6;
        const lane adjoint_L_ry_ry =
            D_p_ry_1*adjoint_f_ry_l_1 + D_p_ry_2*adjoint_f_ry_l_2 + D_p_ry_3*adjoint_f_ry_l_3
            + D_p_ry_4*adjoint_f_ry_l_4 + D_p_ry_5*adjoint_f_ry_l_5 + D_p_ry_6*adjoint_f_ry_l_6;
        const lane adjoint_forward_t134 = -adjoint_L_ry_ry - adjoint_L_rz_rz;
        const lane adjoint_forward_t133 = adjoint_forward_t134*mu_6 + 2.0*adjoint_forward_t230;
        const lane adjoint_forward_t132 = adjoint_forward_t134*mu_5 + 2.0*adjoint_forward_t229;
        const lane adjoint_forward_t131 = adjoint_forward_t134*mu_4 + 2.0*adjoint_forward_t228;
        const lane adjoint_forward_t130 = adjoint_forward_t134*mu_3 + 2.0*adjoint_forward_t227;
        const lane adjoint_forward_t129 = adjoint_forward_t134*mu_2 + 2.0*adjoint_forward_t226;
        const lane adjoint_forward_t128 = adjoint_forward_t134*mu_1 + 2.0*adjoint_forward_t225;
        const lane adjoint_L_rx_rz =
            D_p_rx_1*adjoint_f_rz_l_1 + D_p_rx_2*adjoint_f_rz_l_2 + D_p_rx_3*adjoint_f_rz_l_3
            + D_p_rx_4*adjoint_f_rz_l_4 + D_p_rx_5*adjoint_f_rz_l_5 + D_p_rx_6*adjoint_f_rz_l_6
            + D_p_rz_1*adjoint_f_rx_l_1 + D_p_rz_2*adjoint_f_rx_l_2 + D_p_rz_3*adjoint_f_rx_l_3
            + D_p_rz_4*adjoint_f_rx_l_4 + D_p_rz_5*adjoint_f_rx_l_5 + D_p_rz_6*adjoint_f_rx_l_6;
        const lane adjoint_L_rx_ry =
            D_p_rx_1*adjoint_f_ry_l_1 + D_p_rx_2*adjoint_f_ry_l_2 + D_p_rx_3*adjoint_f_ry_l_3
            + D_p_rx_4*adjoint_f_ry_l_4 + D_p_rx_5*adjoint_f_ry_l_5 + D_p_rx_6*adjoint_f_ry_l_6
            + D_p_ry_1*adjoint_f_rx_l_1 + D_p_ry_2*adjoint_f_rx_l_2 + D_p_ry_3*adjoint_f_rx_l_3
            + D_p_ry_4*adjoint_f_rx_l_4 + D_p_ry_5*adjoint_f_rx_l_5 + D_p_ry_6*adjoint_f_rx_l_6;
        const lane adjoint_forward_t127 = adjoint_L_rx_ry*g_11_y + adjoint_L_rx_rz*g_11_z;
        const lane adjoint_forward_t126 = adjoint_L_rx_ry*o_L_y + adjoint_L_rx_rz*o_L_z;
        const lane adjoint_forward_t125 = adjoint_L_rx_ry*c_y + adjoint_L_rx_rz*c_z;
        const lane adjoint_forward_t124 = adjoint_L_rx_ry*g_10_y + adjoint_L_rx_rz*g_10_z;
        const lane adjoint_forward_t123 = B_6_y*adjoint_L_rx_ry + B_6_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t122 = adjoint_L_rx_ry*g_9_y + adjoint_L_rx_rz*g_9_z;
        const lane adjoint_forward_t121 = B_5_y*adjoint_L_rx_ry + B_5_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t120 = adjoint_L_rx_ry*g_8_y + adjoint_L_rx_rz*g_8_z;
        const lane adjoint_forward_t119 = B_4_y*adjoint_L_rx_ry + B_4_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t118 = adjoint_L_rx_ry*g_7_y + adjoint_L_rx_rz*g_7_z;
        const lane adjoint_forward_t117 = B_3_y*adjoint_L_rx_ry + B_3_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t116 = adjoint_L_rx_ry*g_6_y + adjoint_L_rx_rz*g_6_z;
        const lane adjoint_forward_t115 = B_2_y*adjoint_L_rx_ry + B_2_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t114 = adjoint_L_rx_ry*g_5_y + adjoint_L_rx_rz*g_5_z;
        const lane adjoint_forward_t113 = B_1_y*adjoint_L_rx_ry + B_1_z*adjoint_L_rx_rz;
        const lane adjoint_forward_t112 = adjoint_L_rx_ry*g_4_y + adjoint_L_rx_rz*g_4_z;
        const lane adjoint_L_rx_rx =
            D_p_rx_1*adjoint_f_rx_l_1 + D_p_rx_2*adjoint_f_rx_l_2 + D_p_rx_3*adjoint_f_rx_l_3
            + D_p_rx_4*adjoint_f_rx_l_4 + D_p_rx_5*adjoint_f_rx_l_5 + D_p_rx_6*adjoint_f_rx_l_6;
        const lane adjoint_forward_t111 = -adjoint_L_rx_rx - adjoint_L_rz_rz;
        const lane adjoint_forward_t110 = adjoint_forward_t111*mu_6 + 2.0*adjoint_forward_t220;
        const lane adjoint_forward_t109 = adjoint_forward_t111*mu_5 + 2.0*adjoint_forward_t217;
        const lane adjoint_forward_t108 = adjoint_forward_t111*mu_4 + 2.0*adjoint_forward_t214;
        const lane adjoint_forward_t107 = adjoint_forward_t111*mu_3 + 2.0*adjoint_forward_t211;
        const lane adjoint_forward_t106 = adjoint_forward_t111*mu_2 + 2.0*adjoint_forward_t208;
        const lane adjoint_forward_t105 = adjoint_forward_t111*mu_1 + 2.0*adjoint_forward_t205;
        const lane adjoint_forward_t104 = -adjoint_L_rx_rx - adjoint_L_ry_ry;
        const lane adjoint_forward_t103 = adjoint_forward_t104*mu_6 + 2.0*adjoint_forward_t221;
        const lane adjoint_forward_t102 = adjoint_forward_t104*mu_5 + 2.0*adjoint_forward_t218;
        const lane adjoint_forward_t101 = adjoint_forward_t104*mu_4 + 2.0*adjoint_forward_t215;
        const lane adjoint_forward_t100 = adjoint_forward_t104*mu_3 + 2.0*adjoint_forward_t212;
        const lane adjoint_forward_t99 = adjoint_forward_t104*mu_2 + 2.0*adjoint_forward_t209;
        const lane adjoint_forward_t98 = adjoint_forward_t104*mu_1 + 2.0*adjoint_forward_t206;
        const lane adjoint_L_z_rx =
            D_p_rx_1*adjoint_f_z_l_1 + D_p_rx_2*adjoint_f_z_l_2 + D_p_rx_3*adjoint_f_z_l_3
            + D_p_rx_4*adjoint_f_z_l_4 + D_p_rx_5*adjoint_f_z_l_5 + D_p_rx_6*adjoint_f_z_l_6
            + D_p_z_1*adjoint_f_rx_l_1 + D_p_z_2*adjoint_f_rx_l_2 + D_p_z_3*adjoint_f_rx_l_3
            + D_p_z_4*adjoint_f_rx_l_4 + D_p_z_5*adjoint_f_rx_l_5 + D_p_z_6*adjoint_f_rx_l_6;
        const lane adjoint_L_y_rz =
            D_p_rz_1*adjoint_f_y_l_1 + D_p_rz_2*adjoint_f_y_l_2 + D_p_rz_3*adjoint_f_y_l_3
            + D_p_rz_4*adjoint_f_y_l_4 + D_p_rz_5*adjoint_f_y_l_5 + D_p_rz_6*adjoint_f_y_l_6
            + D_p_y_1*adjoint_f_rz_l_1 + D_p_y_2*adjoint_f_rz_l_2 + D_p_y_3*adjoint_f_rz_l_3
            + D_p_y_4*adjoint_f_rz_l_4 + D_p_y_5*adjoint_f_rz_l_5 + D_p_y_6*adjoint_f_rz_l_6;
        const lane adjoint_L_z_ry =
            D_p_ry_1*adjoint_f_z_l_1 + D_p_ry_2*adjoint_f_z_l_2 + D_p_ry_3*adjoint_f_z_l_3
            + D_p_ry_4*adjoint_f_z_l_4 + D_p_ry_5*adjoint_f_z_l_5 + D_p_ry_6*adjoint_f_z_l_6
            + D_p_z_1*adjoint_f_ry_l_1 + D_p_z_2*adjoint_f_ry_l_2 + D_p_z_3*adjoint_f_ry_l_3
            + D_p_z_4*adjoint_f_ry_l_4 + D_p_z_5*adjoint_f_ry_l_5 + D_p_z_6*adjoint_f_ry_l_6 - adjoint_L_y_rz;
        const lane adjoint_L_x_rz =
            D_p_rz_1*adjoint_f_x_l_1 + D_p_rz_2*adjoint_f_x_l_2 + D_p_rz_3*adjoint_f_x_l_3
            + D_p_rz_4*adjoint_f_x_l_4 + D_p_rz_5*adjoint_f_x_l_5 + D_p_rz_6*adjoint_f_x_l_6
            + D_p_x_1*adjoint_f_rz_l_1 + D_p_x_2*adjoint_f_rz_l_2 + D_p_x_3*adjoint_f_rz_l_3
            + D_p_x_4*adjoint_f_rz_l_4 + D_p_x_5*adjoint_f_rz_l_5 + D_p_x_6*adjoint_f_rz_l_6 - adjoint_L_z_rx;
        const lane adjoint_forward_t97 = B_1_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t96 = B_6_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t95 = B_5_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t94 = B_4_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t93 = B_3_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_forward_t92 = B_2_x*adjoint_L_rx_ry + adjoint_L_x_rz;
        const lane adjoint_L_x_ry =
            D_p_ry_1*adjoint_f_x_l_1 + D_p_ry_2*adjoint_f_x_l_2 + D_p_ry_3*adjoint_f_x_l_3
            + D_p_ry_4*adjoint_f_x_l_4 + D_p_ry_5*adjoint_f_x_l_5 + D_p_ry_6*adjoint_f_x_l_6
            + D_p_x_1*adjoint_f_ry_l_1 + D_p_x_2*adjoint_f_ry_l_2 + D_p_x_3*adjoint_f_ry_l_3
            + D_p_x_4*adjoint_f_ry_l_4 + D_p_x_5*adjoint_f_ry_l_5 + D_p_x_6*adjoint_f_ry_l_6;
        const lane adjoint_L_y_rx =
            D_p_rx_1*adjoint_f_y_l_1 + D_p_rx_2*adjoint_f_y_l_2 + D_p_rx_3*adjoint_f_y_l_3
            + D_p_rx_4*adjoint_f_y_l_4 + D_p_rx_5*adjoint_f_y_l_5 + D_p_rx_6*adjoint_f_y_l_6
            + D_p_y_1*adjoint_f_rx_l_1 + D_p_y_2*adjoint_f_rx_l_2 + D_p_y_3*adjoint_f_rx_l_3
            + D_p_y_4*adjoint_f_rx_l_4 + D_p_y_5*adjoint_f_rx_l_5 + D_p_y_6*adjoint_f_rx_l_6 - adjoint_L_x_ry;
        const lane t389 = B_6_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t91 = B_6_x*adjoint_L_rx_rz + adjoint_L_y_rx + t389;
        const lane t390 = B_5_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t90 = B_5_x*adjoint_L_rx_rz + adjoint_L_y_rx + t390;
        const lane t391 = B_4_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t89 = B_4_x*adjoint_L_rx_rz + adjoint_L_y_rx + t391;
        const lane t392 = B_3_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t88 = B_3_x*adjoint_L_rx_rz + adjoint_L_y_rx + t392;
        const lane t393 = B_2_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t87 = B_2_x*adjoint_L_rx_rz + adjoint_L_y_rx + t393;
        const lane t394 = B_1_y*adjoint_L_ry_rz;
        const lane adjoint_forward_t86 = B_1_x*adjoint_L_rx_rz + adjoint_L_y_rx + t394;
        const lane adjoint_L_x_x =
            D_p_x_1*adjoint_f_x_l_1 + D_p_x_2*adjoint_f_x_l_2 + D_p_x_3*adjoint_f_x_l_3
            + D_p_x_4*adjoint_f_x_l_4 + D_p_x_5*adjoint_f_x_l_5 + D_p_x_6*adjoint_f_x_l_6
            + D_p_y_1*adjoint_f_y_l_1 + D_p_y_2*adjoint_f_y_l_2 + D_p_y_3*adjoint_f_y_l_3
            + D_p_y_4*adjoint_f_y_l_4 + D_p_y_5*adjoint_f_y_l_5 + D_p_y_6*adjoint_f_y_l_6
            + D_p_z_1*adjoint_f_z_l_1 + D_p_z_2*adjoint_f_z_l_2 + D_p_z_3*adjoint_f_z_l_3
            + D_p_z_4*adjoint_f_z_l_4 + D_p_z_5*adjoint_f_z_l_5 + D_p_z_6*adjoint_f_z_l_6;
        const lane adjoint_g_11_z =
            adjoint_L_rx_rz*forward_t127 + adjoint_L_ry_rz*t75 + adjoint_forward_t104*o_L_z;
        const lane adjoint_g_11_y =
            adjoint_L_rx_ry*forward_t127 + adjoint_L_ry_rz*t74 + adjoint_forward_t111*o_L_y;
        const lane adjoint_g_11_x = (1.0/2.0)*adjoint_forward_t126 + adjoint_forward_t134*o_L_x;
        const lane adjoint_g_10_z =
            adjoint_L_rx_rz*forward_t124 + adjoint_L_ry_rz*t72 + adjoint_forward_t104*c_z;
        const lane adjoint_g_10_y =
            adjoint_L_rx_ry*forward_t124 + adjoint_L_ry_rz*t73 + adjoint_forward_t111*c_y;
        const lane adjoint_g_10_x = (1.0/2.0)*adjoint_forward_t125 + adjoint_forward_t134*c_x;
        const lane adjoint_g_9_z = B_6_z*adjoint_forward_t104 + adjoint_L_rx_rz*forward_t122 + (1.0/2.0)*t389;
        const lane adjoint_g_9_y =
            B_6_y*adjoint_forward_t111 + adjoint_L_rx_ry*forward_t122 + adjoint_L_ry_rz*t71;
        const lane adjoint_g_9_x = B_6_x*adjoint_forward_t134 + (1.0/2.0)*adjoint_forward_t123;
        const lane adjoint_g_8_z = B_5_z*adjoint_forward_t104 + adjoint_L_rx_rz*forward_t120 + (1.0/2.0)*t390;
        const lane adjoint_g_8_y =
            B_5_y*adjoint_forward_t111 + adjoint_L_rx_ry*forward_t120 + adjoint_L_ry_rz*t69;
        const lane adjoint_g_8_x = B_5_x*adjoint_forward_t134 + (1.0/2.0)*adjoint_forward_t121;
        const lane adjoint_g_7_z = B_4_z*adjoint_forward_t104 + adjoint_L_rx_rz*forward_t118 + (1.0/2.0)*t391;
        const lane adjoint_g_7_y =
            B_4_y*adjoint_forward_t111 + adjoint_L_rx_ry*forward_t118 + adjoint_L_ry_rz*t67;
        const lane adjoint_g_7_x = B_4_x*adjoint_forward_t134 + (1.0/2.0)*adjoint_forward_t119;
        const lane adjoint_g_6_z = B_3_z*adjoint_forward_t104 + adjoint_L_rx_rz*forward_t116 + (1.0/2.0)*t392;
        const lane adjoint_g_6_y =
            B_3_y*adjoint_forward_t111 + adjoint_L_rx_ry*forward_t116 + adjoint_L_ry_rz*t65;
        const lane adjoint_g_6_x = B_3_x*adjoint_forward_t134 + (1.0/2.0)*adjoint_forward_t117;
        const lane adjoint_g_5_z = B_2_z*adjoint_forward_t104 + adjoint_L_rx_rz*forward_t114 + (1.0/2.0)*t393;
        const lane adjoint_g_5_y =
            B_2_y*adjoint_forward_t111 + adjoint_L_rx_ry*forward_t114 + adjoint_L_ry_rz*t63;
        const lane adjoint_g_5_x = B_2_x*adjoint_forward_t134 + (1.0/2.0)*adjoint_forward_t115;
        const lane adjoint_g_4_z = B_1_z*adjoint_forward_t104 + adjoint_L_rx_rz*forward_t112 + (1.0/2.0)*t394;
        const lane adjoint_g_4_y =
            B_1_y*adjoint_forward_t111 + adjoint_L_rx_ry*forward_t112 + adjoint_L_ry_rz*t77;
        const lane adjoint_g_4_x = B_1_x*adjoint_forward_t134 + (1.0/2.0)*adjoint_forward_t113;
        const lane adjoint_mu_6 =
            B_6_x*adjoint_L_z_ry + B_6_y*adjoint_forward_t96 + B_6_z*adjoint_forward_t91 - adjoint_L_x_x
            + adjoint_forward_t104*forward_t103 + adjoint_forward_t111*forward_t110
            + adjoint_forward_t134*forward_t133 - adjoint_g_9_x*d_6_x - adjoint_g_9_y*d_6_y
            - adjoint_g_9_z*d_6_z + t120;
        const lane adjoint_mu_5 =
            B_5_x*adjoint_L_z_ry + B_5_y*adjoint_forward_t95 + B_5_z*adjoint_forward_t90 - adjoint_L_x_x
            + adjoint_forward_t104*forward_t102 + adjoint_forward_t111*forward_t109
            + adjoint_forward_t134*forward_t132 - adjoint_g_8_x*d_5_x - adjoint_g_8_y*d_5_y
            - adjoint_g_8_z*d_5_z + t122;
        const lane adjoint_mu_4 =
            B_4_x*adjoint_L_z_ry + B_4_y*adjoint_forward_t94 + B_4_z*adjoint_forward_t89 - adjoint_L_x_x
            + adjoint_forward_t104*forward_t101 + adjoint_forward_t111*forward_t108
            + adjoint_forward_t134*forward_t131 - adjoint_g_7_x*d_4_x - adjoint_g_7_y*d_4_y
            - adjoint_g_7_z*d_4_z + t124;
        const lane adjoint_mu_3 =
            B_3_x*adjoint_L_z_ry + B_3_y*adjoint_forward_t93 + B_3_z*adjoint_forward_t88 - adjoint_L_x_x
            + adjoint_forward_t104*forward_t100 + adjoint_forward_t111*forward_t107
            + adjoint_forward_t134*forward_t130 - adjoint_g_6_x*d_3_x - adjoint_g_6_y*d_3_y
            - adjoint_g_6_z*d_3_z + t126;
        const lane adjoint_mu_2 =
            B_2_x*adjoint_L_z_ry + B_2_y*adjoint_forward_t92 + B_2_z*adjoint_forward_t87 - adjoint_L_x_x
            + adjoint_forward_t104*forward_t99 + adjoint_forward_t111*forward_t106
            + adjoint_forward_t134*forward_t129 - adjoint_g_5_x*d_2_x - adjoint_g_5_y*d_2_y
            - adjoint_g_5_z*d_2_z + t128;
        const lane adjoint_mu_1 =
            B_1_x*adjoint_L_z_ry + B_1_y*adjoint_forward_t97 + B_1_z*adjoint_forward_t86 - adjoint_L_x_x
            + adjoint_forward_t104*forward_t98 + adjoint_forward_t111*forward_t105
            + adjoint_forward_t134*forward_t128 - adjoint_g_4_x*d_1_x - adjoint_g_4_y*d_1_y
            - adjoint_g_4_z*d_1_z + t130;
        const lane t395 = adjoint_mu_1*forward_22;
        const lane t396 = adjoint_mu_2*forward_22;
        const lane t397 = adjoint_mu_3*forward_22;
        const lane t398 = adjoint_mu_4*forward_22;
        const lane t399 = adjoint_mu_5*forward_22;
        const lane t400 = adjoint_mu_6*forward_22;
        const lane adjoint_G_p_rz =
            A_rz_1*t395 + A_rz_2*t396 + A_rz_3*t397 + A_rz_4*t398 + A_rz_5*t399 + A_rz_6*t400;
        const lane adjoint_forward_t85 = -adjoint_G_p_rz*o_L_x - adjoint_g_11_y;
        const lane adjoint_forward_t84 = -adjoint_G_p_rz*c_x - adjoint_g_10_y;
        const lane adjoint_G_p_ry =
            A_ry_1*t395 + A_ry_2*t396 + A_ry_3*t397 + A_ry_4*t398 + A_ry_5*t399 + A_ry_6*t400;
        const lane adjoint_forward_t83 = -adjoint_G_p_ry*o_L_z - adjoint_g_11_x;
        const lane adjoint_forward_t82 = -adjoint_G_p_ry*c_z - adjoint_g_10_x;
        const lane adjoint_G_p_rx =
            A_rx_1*t395 + A_rx_2*t396 + A_rx_3*t397 + A_rx_4*t398 + A_rx_5*t399 + A_rx_6*t400;
        const lane adjoint_forward_t81 = -adjoint_G_p_rx*o_L_y + adjoint_G_p_ry*o_L_x - adjoint_g_11_z;
        const lane adjoint_forward_t80 = -adjoint_G_p_rx*c_y + adjoint_G_p_ry*c_x - adjoint_g_10_z;
        const lane adjoint_G_p_z =
            A_z_1*t395 + A_z_2*t396 + A_z_3*t397 + A_z_4*t398 + A_z_5*t399 + A_z_6*t400;
        const lane adjoint_forward_t79 =
            B_6_x*adjoint_G_p_ry - B_6_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_9_z;
        const lane adjoint_forward_t78 =
            B_5_x*adjoint_G_p_ry - B_5_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_8_z;
        const lane adjoint_forward_t77 =
            B_4_x*adjoint_G_p_ry - B_4_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_7_z;
        const lane adjoint_forward_t76 =
            B_3_x*adjoint_G_p_ry - B_3_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_6_z;
        const lane adjoint_forward_t75 =
            B_2_x*adjoint_G_p_ry - B_2_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_5_z;
        const lane adjoint_forward_t74 =
            B_1_x*adjoint_G_p_ry - B_1_y*adjoint_G_p_rx - adjoint_G_p_z - adjoint_g_4_z;
        const lane adjoint_G_p_y =
            A_y_1*t395 + A_y_2*t396 + A_y_3*t397 + A_y_4*t398 + A_y_5*t399 + A_y_6*t400;
        const lane adjoint_forward_t73 = -B_6_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_9_y;
        const lane adjoint_forward_t72 = -B_5_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_8_y;
        const lane adjoint_forward_t71 = -B_4_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_7_y;
        const lane adjoint_forward_t70 = -B_3_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_6_y;
        const lane adjoint_forward_t69 = -B_2_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_5_y;
        const lane adjoint_forward_t68 = -B_1_x*adjoint_G_p_rz - adjoint_G_p_y - adjoint_g_4_y;
        const lane adjoint_G_p_x =
            A_x_1*t395 + A_x_2*t396 + A_x_3*t397 + A_x_4*t398 + A_x_5*t399 + A_x_6*t400;
        const lane adjoint_forward_t67 =
            -adjoint_G_p_x*g_x - adjoint_G_p_y*g_y - adjoint_G_p_z*g_z + adjoint_M_p_x_x;
        const lane adjoint_forward_t66 = -B_6_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_9_x;
        const lane adjoint_forward_t65 = -B_5_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_8_x;
        const lane adjoint_forward_t64 = -B_4_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_7_x;
        const lane adjoint_forward_t63 = -B_3_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_6_x;
        const lane adjoint_forward_t62 = -B_2_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_5_x;
        const lane adjoint_forward_t61 = -B_1_z*adjoint_G_p_ry - adjoint_G_p_x - adjoint_g_4_x;
        const lane adjoint_k_6 = -shape_12*t205 + t120 + t132;
        const lane adjoint_k_5 = -shape_11*t144 + t122 + t134;
        const lane adjoint_k_4 = -shape_10*t152 + t124 + t136;
        const lane adjoint_k_3 = -shape_9*t161 + t126 + t138;
        const lane adjoint_k_2 = -shape_8*t171 + t128 + t140;
        const lane adjoint_k_1 = -shape_7*t182 + t130 + t142;
        const lane t401 = eigenvalue*t120;
        const lane adjoint_D_p_rz_6 =
            L_rx_rz*adjoint_f_rx_l_6 + L_ry_rz*adjoint_f_ry_l_6 + L_rz_rz*adjoint_f_rz_l_6
            + L_x_rz*adjoint_f_x_l_6 + L_y_rz*adjoint_f_y_l_6 + M_p_rx_rz*adjoint_h_rx_l_6
            + M_p_ry_rz*adjoint_h_ry_l_6 + M_p_rz_rz*adjoint_h_rz_l_6 + M_p_x_rz*adjoint_h_x_l_6
            + M_p_y_rz*adjoint_h_y_l_6 - forward_t171*t188 - forward_t172*t176 - forward_t173*t165
            - forward_t174*t155 - forward_t175*t146 - h_rz_l_6*t401 - h_rz_u_x*t386 - h_rz_u_y*t387
            + t120*(f_rz_l_6 - forward_t176);
        const lane t402 = eigenvalue*h_rz_l_6;
        const lane t403 = eigenvalue*t122;
        const lane adjoint_D_p_rz_5 =
            L_rx_rz*adjoint_f_rx_l_5 + L_ry_rz*adjoint_f_ry_l_5 + L_rz_rz*adjoint_f_rz_l_5
            + L_x_rz*adjoint_f_x_l_5 + L_y_rz*adjoint_f_y_l_5 + M_p_rx_rz*adjoint_h_rx_l_5
            + M_p_ry_rz*adjoint_h_ry_l_5 + M_p_rz_rz*adjoint_h_rz_l_5 + M_p_x_rz*adjoint_h_x_l_5
            + M_p_y_rz*adjoint_h_y_l_5 + f_rz_l_6*t146 - forward_t171*t187 - forward_t172*t175
            - forward_t173*t164 - forward_t174*t154 - h_rz_l_5*t403 - h_rz_u_x*t338 - h_rz_u_y*t312
            + t122*(f_rz_l_5 - forward_t175) - t146*t402;
        const lane t404 = eigenvalue*h_rz_l_5;
        const lane t405 = eigenvalue*t124;
        const lane adjoint_D_p_rz_4 =
            L_rx_rz*adjoint_f_rx_l_4 + L_ry_rz*adjoint_f_ry_l_4 + L_rz_rz*adjoint_f_rz_l_4
            + L_x_rz*adjoint_f_x_l_4 + L_y_rz*adjoint_f_y_l_4 + M_p_rx_rz*adjoint_h_rx_l_4
            + M_p_ry_rz*adjoint_h_ry_l_4 + M_p_rz_rz*adjoint_h_rz_l_4 + M_p_x_rz*adjoint_h_x_l_4
            + M_p_y_rz*adjoint_h_y_l_4 + f_rz_l_5*t154 + f_rz_l_6*t155 - forward_t171*t186
            - forward_t172*t174 - forward_t173*t163 - h_rz_l_4*t405 - h_rz_u_x*t337 - h_rz_u_y*t311
            + t124*(f_rz_l_4 - forward_t174) - t154*t404 - t155*t402;
        const lane t406 = eigenvalue*h_rz_l_4;
        const lane t407 = eigenvalue*t126;
        const lane adjoint_D_p_rz_3 =
            L_rx_rz*adjoint_f_rx_l_3 + L_ry_rz*adjoint_f_ry_l_3 + L_rz_rz*adjoint_f_rz_l_3
            + L_x_rz*adjoint_f_x_l_3 + L_y_rz*adjoint_f_y_l_3 + M_p_rx_rz*adjoint_h_rx_l_3
            + M_p_ry_rz*adjoint_h_ry_l_3 + M_p_rz_rz*adjoint_h_rz_l_3 + M_p_x_rz*adjoint_h_x_l_3
            + M_p_y_rz*adjoint_h_y_l_3 + f_rz_l_4*t163 + f_rz_l_5*t164 + f_rz_l_6*t165 - forward_t171*t185
            - forward_t172*t173 - h_rz_l_3*t407 - h_rz_u_x*t336 - h_rz_u_y*t310 + t126*(f_rz_l_3
            - forward_t173) - t163*t406 - t164*t404 - t165*t402;
        const lane t408 = eigenvalue*h_rz_l_3;
        const lane t409 = eigenvalue*t128;
        const lane adjoint_D_p_rz_2 =
            L_rx_rz*adjoint_f_rx_l_2 + L_ry_rz*adjoint_f_ry_l_2 + L_rz_rz*adjoint_f_rz_l_2
            + L_x_rz*adjoint_f_x_l_2 + L_y_rz*adjoint_f_y_l_2 + M_p_rx_rz*adjoint_h_rx_l_2
            + M_p_ry_rz*adjoint_h_ry_l_2 + M_p_rz_rz*adjoint_h_rz_l_2 + M_p_x_rz*adjoint_h_x_l_2
            + M_p_y_rz*adjoint_h_y_l_2 + f_rz_l_3*t173 + f_rz_l_4*t174 + f_rz_l_5*t175 + f_rz_l_6*t176
            - forward_t171*t184 - h_rz_l_2*t409 - h_rz_u_x*t335 - h_rz_u_y*t309 + t128*(f_rz_l_2
            - forward_t172) - t173*t408 - t174*t406 - t175*t404 - t176*t402;
        const lane t410 = eigenvalue*t184;
        const lane t411 = eigenvalue*t130;
        const lane adjoint_D_p_rz_1 =
            L_rx_rz*adjoint_f_rx_l_1 + L_ry_rz*adjoint_f_ry_l_1 + L_rz_rz*adjoint_f_rz_l_1
            + L_x_rz*adjoint_f_x_l_1 + L_y_rz*adjoint_f_y_l_1 + M_p_rx_rz*adjoint_h_rx_l_1
            + M_p_ry_rz*adjoint_h_ry_l_1 + M_p_rz_rz*adjoint_h_rz_l_1 + M_p_x_rz*adjoint_h_x_l_1
            + M_p_y_rz*adjoint_h_y_l_1 + f_rz_l_2*t184 + f_rz_l_3*t185 + f_rz_l_4*t186 + f_rz_l_5*t187
            + f_rz_l_6*t188 - h_rz_l_1*t411 - h_rz_l_2*t410 - h_rz_u_x*t334 - h_rz_u_y*t308 + t130*(f_rz_l_1
            - forward_t171) - t185*t408 - t186*t406 - t187*t404 - t188*t402;
        const lane adjoint_D_p_ry_6 =
            L_rx_ry*adjoint_f_rx_l_6 + L_ry_ry*adjoint_f_ry_l_6 + L_ry_rz*adjoint_f_rz_l_6
            + L_x_ry*adjoint_f_x_l_6 + L_z_ry*adjoint_f_z_l_6 + M_p_rx_ry*adjoint_h_rx_l_6
            + M_p_ry_ry*adjoint_h_ry_l_6 + M_p_ry_rz*adjoint_h_rz_l_6 + M_p_x_ry*adjoint_h_x_l_6
            + M_p_z_ry*adjoint_h_z_l_6 - forward_t165*t188 - forward_t166*t176 - forward_t167*t165
            - forward_t168*t155 - forward_t169*t146 - h_ry_l_6*t401 - h_ry_u_x*t386 - h_ry_u_z*t388
            + t120*(f_ry_l_6 - forward_t170);
        const lane t412 = eigenvalue*h_ry_l_6;
        const lane adjoint_D_p_ry_5 =
            L_rx_ry*adjoint_f_rx_l_5 + L_ry_ry*adjoint_f_ry_l_5 + L_ry_rz*adjoint_f_rz_l_5
            + L_x_ry*adjoint_f_x_l_5 + L_z_ry*adjoint_f_z_l_5 + M_p_rx_ry*adjoint_h_rx_l_5
            + M_p_ry_ry*adjoint_h_ry_l_5 + M_p_ry_rz*adjoint_h_rz_l_5 + M_p_x_ry*adjoint_h_x_l_5
            + M_p_z_ry*adjoint_h_z_l_5 + f_ry_l_6*t146 - forward_t165*t187 - forward_t166*t175
            - forward_t167*t164 - forward_t168*t154 - h_ry_l_5*t403 - h_ry_u_x*t338 - h_ry_u_z*t286
            + t122*(f_ry_l_5 - forward_t169) - t146*t412;
        const lane t413 = eigenvalue*h_ry_l_5;
        const lane adjoint_D_p_ry_4 =
            L_rx_ry*adjoint_f_rx_l_4 + L_ry_ry*adjoint_f_ry_l_4 + L_ry_rz*adjoint_f_rz_l_4
            + L_x_ry*adjoint_f_x_l_4 + L_z_ry*adjoint_f_z_l_4 + M_p_rx_ry*adjoint_h_rx_l_4
            + M_p_ry_ry*adjoint_h_ry_l_4 + M_p_ry_rz*adjoint_h_rz_l_4 + M_p_x_ry*adjoint_h_x_l_4
            + M_p_z_ry*adjoint_h_z_l_4 + f_ry_l_5*t154 + f_ry_l_6*t155 - forward_t165*t186
            - forward_t166*t174 - forward_t167*t163 - h_ry_l_4*t405 - h_ry_u_x*t337 - h_ry_u_z*t285
            + t124*(f_ry_l_4 - forward_t168) - t154*t413 - t155*t412;
        const lane t414 = eigenvalue*h_ry_l_4;
        const lane adjoint_D_p_ry_3 =
            L_rx_ry*adjoint_f_rx_l_3 + L_ry_ry*adjoint_f_ry_l_3 + L_ry_rz*adjoint_f_rz_l_3
            + L_x_ry*adjoint_f_x_l_3 + L_z_ry*adjoint_f_z_l_3 + M_p_rx_ry*adjoint_h_rx_l_3
            + M_p_ry_ry*adjoint_h_ry_l_3 + M_p_ry_rz*adjoint_h_rz_l_3 + M_p_x_ry*adjoint_h_x_l_3
            + M_p_z_ry*adjoint_h_z_l_3 + f_ry_l_4*t163 + f_ry_l_5*t164 + f_ry_l_6*t165 - forward_t165*t185
            - forward_t166*t173 - h_ry_l_3*t407 - h_ry_u_x*t336 - h_ry_u_z*t284 + t126*(f_ry_l_3
            - forward_t167) - t163*t414 - t164*t413 - t165*t412;
        const lane t415 = eigenvalue*h_ry_l_3;
        const lane adjoint_D_p_ry_2 =
            L_rx_ry*adjoint_f_rx_l_2 + L_ry_ry*adjoint_f_ry_l_2 + L_ry_rz*adjoint_f_rz_l_2
            + L_x_ry*adjoint_f_x_l_2 + L_z_ry*adjoint_f_z_l_2 + M_p_rx_ry*adjoint_h_rx_l_2
            + M_p_ry_ry*adjoint_h_ry_l_2 + M_p_ry_rz*adjoint_h_rz_l_2 + M_p_x_ry*adjoint_h_x_l_2
            + M_p_z_ry*adjoint_h_z_l_2 + f_ry_l_3*t173 + f_ry_l_4*t174 + f_ry_l_5*t175 + f_ry_l_6*t176
            - forward_t165*t184 - h_ry_l_2*t409 - h_ry_u_x*t335 - h_ry_u_z*t283 + t128*(f_ry_l_2
            - forward_t166) - t173*t415 - t174*t414 - t175*t413 - t176*t412;
        const lane adjoint_D_p_ry_1 =
            L_rx_ry*adjoint_f_rx_l_1 + L_ry_ry*adjoint_f_ry_l_1 + L_ry_rz*adjoint_f_rz_l_1
            + L_x_ry*adjoint_f_x_l_1 + L_z_ry*adjoint_f_z_l_1 + M_p_rx_ry*adjoint_h_rx_l_1
            + M_p_ry_ry*adjoint_h_ry_l_1 + M_p_ry_rz*adjoint_h_rz_l_1 + M_p_x_ry*adjoint_h_x_l_1
            + M_p_z_ry*adjoint_h_z_l_1 + f_ry_l_2*t184 + f_ry_l_3*t185 + f_ry_l_4*t186 + f_ry_l_5*t187
            + f_ry_l_6*t188 - h_ry_l_1*t411 - h_ry_l_2*t410 - h_ry_u_x*t334 - h_ry_u_z*t282 + t130*(f_ry_l_1
            - forward_t165) - t185*t415 - t186*t414 - t187*t413 - t188*t412;
        const lane adjoint_D_p_rx_6 =
            L_rx_rx*adjoint_f_rx_l_6 + L_rx_ry*adjoint_f_ry_l_6 + L_rx_rz*adjoint_f_rz_l_6
            + L_y_rx*adjoint_f_y_l_6 + L_z_rx*adjoint_f_z_l_6 + M_p_rx_rx*adjoint_h_rx_l_6
            + M_p_rx_ry*adjoint_h_ry_l_6 + M_p_rx_rz*adjoint_h_rz_l_6 + M_p_y_rx*adjoint_h_y_l_6
            + M_p_z_rx*adjoint_h_z_l_6 - forward_t159*t188 - forward_t160*t176 - forward_t161*t165
            - forward_t162*t155 - forward_t163*t146 - h_rx_l_6*t401 - h_rx_u_y*t387 - h_rx_u_z*t388
            + t120*(f_rx_l_6 - forward_t164);
        const lane t416 = eigenvalue*h_rx_l_6;
        const lane adjoint_D_p_rx_5 =
            L_rx_rx*adjoint_f_rx_l_5 + L_rx_ry*adjoint_f_ry_l_5 + L_rx_rz*adjoint_f_rz_l_5
            + L_y_rx*adjoint_f_y_l_5 + L_z_rx*adjoint_f_z_l_5 + M_p_rx_rx*adjoint_h_rx_l_5
            + M_p_rx_ry*adjoint_h_ry_l_5 + M_p_rx_rz*adjoint_h_rz_l_5 + M_p_y_rx*adjoint_h_y_l_5
            + M_p_z_rx*adjoint_h_z_l_5 + f_rx_l_6*t146 - forward_t159*t187 - forward_t160*t175
            - forward_t161*t164 - forward_t162*t154 - h_rx_l_5*t403 - h_rx_u_y*t312 - h_rx_u_z*t286
            + t122*(f_rx_l_5 - forward_t163) - t146*t416;
        const lane t417 = eigenvalue*h_rx_l_5;
        const lane adjoint_D_p_rx_4 =
            L_rx_rx*adjoint_f_rx_l_4 + L_rx_ry*adjoint_f_ry_l_4 + L_rx_rz*adjoint_f_rz_l_4
            + L_y_rx*adjoint_f_y_l_4 + L_z_rx*adjoint_f_z_l_4 + M_p_rx_rx*adjoint_h_rx_l_4
            + M_p_rx_ry*adjoint_h_ry_l_4 + M_p_rx_rz*adjoint_h_rz_l_4 + M_p_y_rx*adjoint_h_y_l_4
            + M_p_z_rx*adjoint_h_z_l_4 + f_rx_l_5*t154 + f_rx_l_6*t155 - forward_t159*t186
            - forward_t160*t174 - forward_t161*t163 - h_rx_l_4*t405 - h_rx_u_y*t311 - h_rx_u_z*t285
            + t124*(f_rx_l_4 - forward_t162) - t154*t417 - t155*t416;
        const lane t418 = eigenvalue*h_rx_l_4;
        const lane adjoint_D_p_rx_3 =
            L_rx_rx*adjoint_f_rx_l_3 + L_rx_ry*adjoint_f_ry_l_3 + L_rx_rz*adjoint_f_rz_l_3
            + L_y_rx*adjoint_f_y_l_3 + L_z_rx*adjoint_f_z_l_3 + M_p_rx_rx*adjoint_h_rx_l_3
            + M_p_rx_ry*adjoint_h_ry_l_3 + M_p_rx_rz*adjoint_h_rz_l_3 + M_p_y_rx*adjoint_h_y_l_3
            + M_p_z_rx*adjoint_h_z_l_3 + f_rx_l_4*t163 + f_rx_l_5*t164 + f_rx_l_6*t165 - forward_t159*t185
            - forward_t160*t173 - h_rx_l_3*t407 - h_rx_u_y*t310 - h_rx_u_z*t284 + t126*(f_rx_l_3
            - forward_t161) - t163*t418 - t164*t417 - t165*t416;
        const lane t419 = eigenvalue*h_rx_l_3;
        const lane adjoint_D_p_rx_2 =
            L_rx_rx*adjoint_f_rx_l_2 + L_rx_ry*adjoint_f_ry_l_2 + L_rx_rz*adjoint_f_rz_l_2
            + L_y_rx*adjoint_f_y_l_2 + L_z_rx*adjoint_f_z_l_2 + M_p_rx_rx*adjoint_h_rx_l_2
            + M_p_rx_ry*adjoint_h_ry_l_2 + M_p_rx_rz*adjoint_h_rz_l_2 + M_p_y_rx*adjoint_h_y_l_2
            + M_p_z_rx*adjoint_h_z_l_2 + f_rx_l_3*t173 + f_rx_l_4*t174 + f_rx_l_5*t175 + f_rx_l_6*t176
            - forward_t159*t184 - h_rx_l_2*t409 - h_rx_u_y*t309 - h_rx_u_z*t283 + t128*(f_rx_l_2
            - forward_t160) - t173*t419 - t174*t418 - t175*t417 - t176*t416;
        const lane adjoint_D_p_rx_1 =
            L_rx_rx*adjoint_f_rx_l_1 + L_rx_ry*adjoint_f_ry_l_1 + L_rx_rz*adjoint_f_rz_l_1
            + L_y_rx*adjoint_f_y_l_1 + L_z_rx*adjoint_f_z_l_1 + M_p_rx_rx*adjoint_h_rx_l_1
            + M_p_rx_ry*adjoint_h_ry_l_1 + M_p_rx_rz*adjoint_h_rz_l_1 + M_p_y_rx*adjoint_h_y_l_1
            + M_p_z_rx*adjoint_h_z_l_1 + f_rx_l_2*t184 + f_rx_l_3*t185 + f_rx_l_4*t186 + f_rx_l_5*t187
            + f_rx_l_6*t188 - h_rx_l_1*t411 - h_rx_l_2*t410 - h_rx_u_y*t308 - h_rx_u_z*t282 + t130*(f_rx_l_1
            - forward_t159) - t185*t419 - t186*t418 - t187*t417 - t188*t416;
        const lane t420 = k_C*t205;
        const lane adjoint_D_p_z_6 =
            L_x_x*adjoint_f_z_l_6 + L_z_rx*adjoint_f_rx_l_6 + L_z_ry*adjoint_f_ry_l_6
            + M_p_x_x*adjoint_h_z_l_6 + M_p_z_rx*adjoint_h_rx_l_6 + M_p_z_ry*adjoint_h_ry_l_6 - h_x_u_x*t388
            - h_z_l_6*t401 + shape_15*t420 + t120*(D_p_z_6*t425 + f_z_l_6 + forward_t158)
            + t146*(forward_t157 + forward_t250) + t155*t424 + t165*t423 + t176*t422 + t188*t421;
        const lane t426 = eigenvalue*h_z_l_6;
        const lane adjoint_D_p_z_5 =
            L_x_x*adjoint_f_z_l_5 + L_z_rx*adjoint_f_rx_l_5 + L_z_ry*adjoint_f_ry_l_5
            + M_p_x_x*adjoint_h_z_l_5 + M_p_z_rx*adjoint_h_rx_l_5 + M_p_z_ry*adjoint_h_ry_l_5
            + adjoint_forward_t250*k_C + f_z_l_6*t146 - h_x_u_x*t286 - h_z_l_5*t403 + t122*(f_z_l_5
            + forward_t157 + 2.0*forward_t250) - t146*t426 + t154*t424 + t164*t423 + t175*t422 + t187*t421;
        const lane t427 = eigenvalue*h_z_l_5;
        const lane adjoint_D_p_z_4 =
            L_x_x*adjoint_f_z_l_4 + L_z_rx*adjoint_f_rx_l_4 + L_z_ry*adjoint_f_ry_l_4
            + M_p_x_x*adjoint_h_z_l_4 + M_p_z_rx*adjoint_h_rx_l_4 + M_p_z_ry*adjoint_h_ry_l_4
            + adjoint_forward_t247*k_C + f_z_l_5*t154 + f_z_l_6*t155 - h_x_u_x*t285 - h_z_l_4*t405
            + t124*(f_z_l_4 + forward_t156 + 2.0*forward_t247) - t154*t427 - t155*t426 + t163*t423
            + t174*t422 + t186*t421;
        const lane t428 = eigenvalue*h_z_l_4;
        const lane adjoint_D_p_z_3 =
            L_x_x*adjoint_f_z_l_3 + L_z_rx*adjoint_f_rx_l_3 + L_z_ry*adjoint_f_ry_l_3
            + M_p_x_x*adjoint_h_z_l_3 + M_p_z_rx*adjoint_h_rx_l_3 + M_p_z_ry*adjoint_h_ry_l_3
            + adjoint_forward_t244*k_C + f_z_l_4*t163 + f_z_l_5*t164 + f_z_l_6*t165 - h_x_u_x*t284
            - h_z_l_3*t407 + t126*(f_z_l_3 + forward_t155 + 2.0*forward_t244) - t163*t428 - t164*t427
            - t165*t426 + t173*t422 + t185*t421;
        const lane t429 = eigenvalue*h_z_l_3;
        const lane adjoint_D_p_z_2 =
            L_x_x*adjoint_f_z_l_2 + L_z_rx*adjoint_f_rx_l_2 + L_z_ry*adjoint_f_ry_l_2
            + M_p_x_x*adjoint_h_z_l_2 + M_p_z_rx*adjoint_h_rx_l_2 + M_p_z_ry*adjoint_h_ry_l_2
            + adjoint_forward_t241*k_C + f_z_l_3*t173 + f_z_l_4*t174 + f_z_l_5*t175 + f_z_l_6*t176
            - h_x_u_x*t283 - h_z_l_2*t409 + t128*(f_z_l_2 + forward_t154 + 2.0*forward_t241) - t173*t429
            - t174*t428 - t175*t427 - t176*t426 + t184*t421;
        const lane adjoint_D_p_z_1 =
            L_x_x*adjoint_f_z_l_1 + L_z_rx*adjoint_f_rx_l_1 + L_z_ry*adjoint_f_ry_l_1
            + M_p_x_x*adjoint_h_z_l_1 + M_p_z_rx*adjoint_h_rx_l_1 + M_p_z_ry*adjoint_h_ry_l_1
            + adjoint_forward_t238*k_C + f_z_l_2*t184 + f_z_l_3*t185 + f_z_l_4*t186 + f_z_l_5*t187
            + f_z_l_6*t188 - h_x_u_x*t282 - h_z_l_1*t411 - h_z_l_2*t410 + t130*(f_z_l_1 + forward_t153
            + 2.0*forward_t238) - t185*t429 - t186*t428 - t187*t427 - t188*t426;
        const lane adjoint_D_p_y_6 =
            L_x_x*adjoint_f_y_l_6 + L_y_rx*adjoint_f_rx_l_6 + L_y_rz*adjoint_f_rz_l_6
            + M_p_x_x*adjoint_h_y_l_6 + M_p_y_rx*adjoint_h_rx_l_6 + M_p_y_rz*adjoint_h_rz_l_6 - h_x_u_x*t387
            - h_y_l_6*t401 + shape_14*t420 + t120*(D_p_y_6*t425 + f_y_l_6 + forward_t152)
            + t146*(forward_t151 + forward_t249) + t155*t433 + t165*t432 + t176*t431 + t188*t430;
        const lane t434 = eigenvalue*h_y_l_6;
        const lane adjoint_D_p_y_5 =
            L_x_x*adjoint_f_y_l_5 + L_y_rx*adjoint_f_rx_l_5 + L_y_rz*adjoint_f_rz_l_5
            + M_p_x_x*adjoint_h_y_l_5 + M_p_y_rx*adjoint_h_rx_l_5 + M_p_y_rz*adjoint_h_rz_l_5
            + adjoint_forward_t249*k_C + f_y_l_6*t146 - h_x_u_x*t312 - h_y_l_5*t403 + t122*(f_y_l_5
            + forward_t151 + 2.0*forward_t249) - t146*t434 + t154*t433 + t164*t432 + t175*t431 + t187*t430;
        const lane t435 = eigenvalue*h_y_l_5;
        const lane adjoint_D_p_y_4 =
            L_x_x*adjoint_f_y_l_4 + L_y_rx*adjoint_f_rx_l_4 + L_y_rz*adjoint_f_rz_l_4
            + M_p_x_x*adjoint_h_y_l_4 + M_p_y_rx*adjoint_h_rx_l_4 + M_p_y_rz*adjoint_h_rz_l_4
            + adjoint_forward_t246*k_C + f_y_l_5*t154 + f_y_l_6*t155 - h_x_u_x*t311 - h_y_l_4*t405
            + t124*(f_y_l_4 + forward_t150 + 2.0*forward_t246) - t154*t435 - t155*t434 + t163*t432
            + t174*t431 + t186*t430;
        const lane t436 = eigenvalue*h_y_l_4;
        const lane adjoint_D_p_y_3 =
            L_x_x*adjoint_f_y_l_3 + L_y_rx*adjoint_f_rx_l_3 + L_y_rz*adjoint_f_rz_l_3
            + M_p_x_x*adjoint_h_y_l_3 + M_p_y_rx*adjoint_h_rx_l_3 + M_p_y_rz*adjoint_h_rz_l_3
            + adjoint_forward_t243*k_C + f_y_l_4*t163 + f_y_l_5*t164 + f_y_l_6*t165 - h_x_u_x*t310
            - h_y_l_3*t407 + t126*(f_y_l_3 + forward_t149 + 2.0*forward_t243) - t163*t436 - t164*t435
            - t165*t434 + t173*t431 + t185*t430;
        const lane t437 = eigenvalue*h_y_l_3;
        const lane adjoint_D_p_y_2 =
            L_x_x*adjoint_f_y_l_2 + L_y_rx*adjoint_f_rx_l_2 + L_y_rz*adjoint_f_rz_l_2
            + M_p_x_x*adjoint_h_y_l_2 + M_p_y_rx*adjoint_h_rx_l_2 + M_p_y_rz*adjoint_h_rz_l_2
            + adjoint_forward_t240*k_C + f_y_l_3*t173 + f_y_l_4*t174 + f_y_l_5*t175 + f_y_l_6*t176
            - h_x_u_x*t309 - h_y_l_2*t409 + t128*(f_y_l_2 + forward_t148 + 2.0*forward_t240) - t173*t437
            - t174*t436 - t175*t435 - t176*t434 + t184*t430;
        const lane adjoint_D_p_y_1 =
            L_x_x*adjoint_f_y_l_1 + L_y_rx*adjoint_f_rx_l_1 + L_y_rz*adjoint_f_rz_l_1
            + M_p_x_x*adjoint_h_y_l_1 + M_p_y_rx*adjoint_h_rx_l_1 + M_p_y_rz*adjoint_h_rz_l_1
            + adjoint_forward_t237*k_C + f_y_l_2*t184 + f_y_l_3*t185 + f_y_l_4*t186 + f_y_l_5*t187
            + f_y_l_6*t188 - h_x_u_x*t308 - h_y_l_1*t411 - h_y_l_2*t410 + t130*(f_y_l_1 + forward_t147
            + 2.0*forward_t237) - t185*t437 - t186*t436 - t187*t435 - t188*t434;
        const lane adjoint_D_p_x_6 =
            L_x_ry*adjoint_f_ry_l_6 + L_x_rz*adjoint_f_rz_l_6 + L_x_x*adjoint_f_x_l_6
            + M_p_x_ry*adjoint_h_ry_l_6 + M_p_x_rz*adjoint_h_rz_l_6 + M_p_x_x*adjoint_h_x_l_6 - h_x_l_6*t401
            - h_x_u_x*t386 + shape_13*t420 + t120*(D_p_x_6*t425 + f_x_l_6 + forward_t146)
            + t146*(forward_t144 + forward_t248) + t155*t441 + t165*t440 + t176*t439 + t188*t438;
        const lane adjoint_forward_t60 =
            A_rx_6*adjoint_D_p_rx_6 + A_ry_6*adjoint_D_p_ry_6 + A_rz_6*adjoint_D_p_rz_6
            + A_x_6*adjoint_D_p_x_6 + A_y_6*adjoint_D_p_y_6 + A_z_6*adjoint_D_p_z_6;
        const lane t442 = eigenvalue*h_x_l_6;
        const lane adjoint_D_p_x_5 =
            L_x_ry*adjoint_f_ry_l_5 + L_x_rz*adjoint_f_rz_l_5 + L_x_x*adjoint_f_x_l_5
            + M_p_x_ry*adjoint_h_ry_l_5 + M_p_x_rz*adjoint_h_rz_l_5 + M_p_x_x*adjoint_h_x_l_5
            + adjoint_forward_t248*k_C + f_x_l_6*t146 - h_x_l_5*t403 - h_x_u_x*t338 + t122*(f_x_l_5
            + forward_t144 + 2.0*forward_t248) - t146*t442 + t154*t441 + t164*t440 + t175*t439 + t187*t438;
        const lane adjoint_forward_t59 =
            A_rx_5*adjoint_D_p_rx_5 + A_ry_5*adjoint_D_p_ry_5 + A_rz_5*adjoint_D_p_rz_5
            + A_x_5*adjoint_D_p_x_5 + A_y_5*adjoint_D_p_y_5 + A_z_5*adjoint_D_p_z_5;
        const lane t443 = eigenvalue*h_x_l_5;
        const lane adjoint_D_p_x_4 =
            L_x_ry*adjoint_f_ry_l_4 + L_x_rz*adjoint_f_rz_l_4 + L_x_x*adjoint_f_x_l_4
            + M_p_x_ry*adjoint_h_ry_l_4 + M_p_x_rz*adjoint_h_rz_l_4 + M_p_x_x*adjoint_h_x_l_4
            + adjoint_forward_t245*k_C + f_x_l_5*t154 + f_x_l_6*t155 - h_x_l_4*t405 - h_x_u_x*t337
            + t124*(f_x_l_4 + forward_t142 + 2.0*forward_t245) - t154*t443 - t155*t442 + t163*t440
            + t174*t439 + t186*t438;
        const lane adjoint_forward_t58 =
            A_rx_4*adjoint_D_p_rx_4 + A_ry_4*adjoint_D_p_ry_4 + A_rz_4*adjoint_D_p_rz_4
            + A_x_4*adjoint_D_p_x_4 + A_y_4*adjoint_D_p_y_4 + A_z_4*adjoint_D_p_z_4;
        const lane t444 = eigenvalue*h_x_l_4;
        const lane adjoint_D_p_x_3 =
            L_x_ry*adjoint_f_ry_l_3 + L_x_rz*adjoint_f_rz_l_3 + L_x_x*adjoint_f_x_l_3
            + M_p_x_ry*adjoint_h_ry_l_3 + M_p_x_rz*adjoint_h_rz_l_3 + M_p_x_x*adjoint_h_x_l_3
            + adjoint_forward_t242*k_C + f_x_l_4*t163 + f_x_l_5*t164 + f_x_l_6*t165 - h_x_l_3*t407
            - h_x_u_x*t336 + t126*(f_x_l_3 + forward_t140 + 2.0*forward_t242) - t163*t444 - t164*t443
            - t165*t442 + t173*t439 + t185*t438;
        const lane adjoint_forward_t57 =
            A_rx_3*adjoint_D_p_rx_3 + A_ry_3*adjoint_D_p_ry_3 + A_rz_3*adjoint_D_p_rz_3
            + A_x_3*adjoint_D_p_x_3 + A_y_3*adjoint_D_p_y_3 + A_z_3*adjoint_D_p_z_3;
        const lane t445 = eigenvalue*h_x_l_3;
        const lane adjoint_D_p_x_2 =
            L_x_ry*adjoint_f_ry_l_2 + L_x_rz*adjoint_f_rz_l_2 + L_x_x*adjoint_f_x_l_2
            + M_p_x_ry*adjoint_h_ry_l_2 + M_p_x_rz*adjoint_h_rz_l_2 + M_p_x_x*adjoint_h_x_l_2
            + adjoint_forward_t239*k_C + f_x_l_3*t173 + f_x_l_4*t174 + f_x_l_5*t175 + f_x_l_6*t176
            - h_x_l_2*t409 - h_x_u_x*t335 + t128*(f_x_l_2 + forward_t138 + 2.0*forward_t239) - t173*t445
            - t174*t444 - t175*t443 - t176*t442 + t184*t438;
        const lane adjoint_forward_t56 =
            A_rx_2*adjoint_D_p_rx_2 + A_ry_2*adjoint_D_p_ry_2 + A_rz_2*adjoint_D_p_rz_2
            + A_x_2*adjoint_D_p_x_2 + A_y_2*adjoint_D_p_y_2 + A_z_2*adjoint_D_p_z_2;
        const lane adjoint_D_p_x_1 =
            L_x_ry*adjoint_f_ry_l_1 + L_x_rz*adjoint_f_rz_l_1 + L_x_x*adjoint_f_x_l_1
            + M_p_x_ry*adjoint_h_ry_l_1 + M_p_x_rz*adjoint_h_rz_l_1 + M_p_x_x*adjoint_h_x_l_1
            + adjoint_forward_t236*k_C + f_x_l_2*t184 + f_x_l_3*t185 + f_x_l_4*t186 + f_x_l_5*t187
            + f_x_l_6*t188 - h_x_l_1*t411 - h_x_l_2*t410 - h_x_u_x*t334 + t130*(f_x_l_1 + forward_t136
            + 2.0*forward_t236) - t185*t445 - t186*t444 - t187*t443 - t188*t442;
        const lane adjoint_forward_t55 =
            A_rx_1*adjoint_D_p_rx_1 + A_ry_1*adjoint_D_p_ry_1 + A_rz_1*adjoint_D_p_rz_1
            + A_x_1*adjoint_D_p_x_1 + A_y_1*adjoint_D_p_y_1 + A_z_1*adjoint_D_p_z_1;
        const lane adjoint_forward_t54 =
            adjoint_forward_t55*forward_4 + adjoint_forward_t56*forward_5 + adjoint_forward_t57*forward_6
            + adjoint_forward_t58*forward_7 + adjoint_forward_t59*forward_8 + adjoint_forward_t60*forward_9
            + adjoint_mu_1*t56 + adjoint_mu_2*t57 + adjoint_mu_3*t58 + adjoint_mu_4*t59 + adjoint_mu_5*t60
            + adjoint_mu_6*t61;
        const lane adjoint_det_D_l = -adjoint_forward_t54*(forward_22*forward_22);
        const lane adjoint_A_rz_6 = G_p_rz*t400 + adjoint_D_p_rz_6*forward_t60;
        const lane adjoint_A_ry_6 = G_p_ry*t400 + adjoint_D_p_ry_6*forward_t60;
        const lane adjoint_A_rx_6 = G_p_rx*t400 + adjoint_D_p_rx_6*forward_t60;
        const lane adjoint_A_z_6 = G_p_z*t400 + adjoint_D_p_z_6*forward_t60;
        const lane adjoint_minor_45_12 =
            adjoint_A_rx_6*minor_123_356 - adjoint_A_ry_6*minor_123_346 + adjoint_A_rz_6*minor_123_345
            - adjoint_A_z_6*minor_123_456;
        const lane adjoint_A_y_6 = G_p_y*t400 + adjoint_D_p_y_6*forward_t60;
        const lane adjoint_minor_45_13 =
            -adjoint_A_rx_6*minor_123_256 + adjoint_A_ry_6*minor_123_246 - adjoint_A_rz_6*minor_123_245
            + adjoint_A_y_6*minor_123_456;
        const lane adjoint_minor_45_14 =
            -adjoint_A_ry_6*minor_123_236 + adjoint_A_rz_6*minor_123_235 - adjoint_A_y_6*minor_123_356
            + adjoint_A_z_6*minor_123_256;
        const lane adjoint_minor_45_15 =
            adjoint_A_rx_6*minor_123_236 - adjoint_A_rz_6*minor_123_234 + adjoint_A_y_6*minor_123_346
            - adjoint_A_z_6*minor_123_246;
        const lane adjoint_minor_45_16 =
            -adjoint_A_rx_6*minor_123_235 + adjoint_A_ry_6*minor_123_234 - adjoint_A_y_6*minor_123_345
            + adjoint_A_z_6*minor_123_245;
        const lane adjoint_A_x_6 = G_p_x*t400 + adjoint_D_p_x_6*forward_t60;
        const lane adjoint_minor_45_23 =
            adjoint_A_rx_6*minor_123_156 - adjoint_A_ry_6*minor_123_146 + adjoint_A_rz_6*minor_123_145
            - adjoint_A_x_6*minor_123_456;
        const lane adjoint_minor_45_24 =
            adjoint_A_ry_6*minor_123_136 - adjoint_A_rz_6*minor_123_135 + adjoint_A_x_6*minor_123_356
            - adjoint_A_z_6*minor_123_156;
        const lane adjoint_minor_45_25 =
            -adjoint_A_rx_6*minor_123_136 + adjoint_A_rz_6*minor_123_134 - adjoint_A_x_6*minor_123_346
            + adjoint_A_z_6*minor_123_146;
        const lane adjoint_minor_45_26 =
            adjoint_A_rx_6*minor_123_135 - adjoint_A_ry_6*minor_123_134 + adjoint_A_x_6*minor_123_345
            - adjoint_A_z_6*minor_123_145;
        const lane adjoint_minor_45_34 =
            -adjoint_A_ry_6*minor_123_126 + adjoint_A_rz_6*minor_123_125 - adjoint_A_x_6*minor_123_256
            + adjoint_A_y_6*minor_123_156;
        const lane adjoint_minor_45_35 =
            adjoint_A_rx_6*minor_123_126 - adjoint_A_rz_6*minor_123_124 + adjoint_A_x_6*minor_123_246
            - adjoint_A_y_6*minor_123_146;
        const lane adjoint_minor_45_36 =
            -adjoint_A_rx_6*minor_123_125 + adjoint_A_ry_6*minor_123_124 - adjoint_A_x_6*minor_123_245
            + adjoint_A_y_6*minor_123_145;
        const lane adjoint_minor_45_45 =
            adjoint_A_rz_6*minor_123_123 - adjoint_A_x_6*minor_123_236 + adjoint_A_y_6*minor_123_136
            - adjoint_A_z_6*minor_123_126;
        const lane adjoint_minor_45_46 =
            -adjoint_A_ry_6*minor_123_123 + adjoint_A_x_6*minor_123_235 - adjoint_A_y_6*minor_123_135
            + adjoint_A_z_6*minor_123_125;
        const lane adjoint_minor_45_56 =
            adjoint_A_rx_6*minor_123_123 - adjoint_A_x_6*minor_123_234 + adjoint_A_y_6*minor_123_134
            - adjoint_A_z_6*minor_123_124;
        const lane adjoint_A_rz_5 = G_p_rz*t399 + adjoint_D_p_rz_5*forward_t59;
        const lane adjoint_A_ry_5 = G_p_ry*t399 + adjoint_D_p_ry_5*forward_t59;
        const lane adjoint_A_rx_5 = G_p_rx*t399 + adjoint_D_p_rx_5*forward_t59;
        const lane adjoint_A_z_5 = G_p_z*t399 + adjoint_D_p_z_5*forward_t59;
        const lane adjoint_minor_46_12 =
            -adjoint_A_rx_5*minor_123_356 + adjoint_A_ry_5*minor_123_346 - adjoint_A_rz_5*minor_123_345
            + adjoint_A_z_5*minor_123_456;
        const lane adjoint_A_y_5 = G_p_y*t399 + adjoint_D_p_y_5*forward_t59;
        const lane adjoint_minor_46_13 =
            adjoint_A_rx_5*minor_123_256 - adjoint_A_ry_5*minor_123_246 + adjoint_A_rz_5*minor_123_245
            - adjoint_A_y_5*minor_123_456;
        const lane adjoint_minor_46_14 =
            adjoint_A_ry_5*minor_123_236 - adjoint_A_rz_5*minor_123_235 + adjoint_A_y_5*minor_123_356
            - adjoint_A_z_5*minor_123_256;
        const lane adjoint_minor_46_15 =
            -adjoint_A_rx_5*minor_123_236 + adjoint_A_rz_5*minor_123_234 - adjoint_A_y_5*minor_123_346
            + adjoint_A_z_5*minor_123_246;
        const lane adjoint_minor_46_16 =
            adjoint_A_rx_5*minor_123_235 - adjoint_A_ry_5*minor_123_234 + adjoint_A_y_5*minor_123_345
            - adjoint_A_z_5*minor_123_245;
        const lane adjoint_A_x_5 = G_p_x*t399 + adjoint_D_p_x_5*forward_t59;
        const lane adjoint_minor_46_23 =
            -adjoint_A_rx_5*minor_123_156 + adjoint_A_ry_5*minor_123_146 - adjoint_A_rz_5*minor_123_145
            + adjoint_A_x_5*minor_123_456;
        const lane adjoint_minor_46_24 =
            -adjoint_A_ry_5*minor_123_136 + adjoint_A_rz_5*minor_123_135 - adjoint_A_x_5*minor_123_356
            + adjoint_A_z_5*minor_123_156;
        const lane adjoint_minor_46_25 =
            adjoint_A_rx_5*minor_123_136 - adjoint_A_rz_5*minor_123_134 + adjoint_A_x_5*minor_123_346
            - adjoint_A_z_5*minor_123_146;
        const lane adjoint_minor_46_26 =
            -adjoint_A_rx_5*minor_123_135 + adjoint_A_ry_5*minor_123_134 - adjoint_A_x_5*minor_123_345
            + adjoint_A_z_5*minor_123_145;
        const lane adjoint_minor_46_34 =
            adjoint_A_ry_5*minor_123_126 - adjoint_A_rz_5*minor_123_125 + adjoint_A_x_5*minor_123_256
            - adjoint_A_y_5*minor_123_156;
        const lane adjoint_minor_46_35 =
            -adjoint_A_rx_5*minor_123_126 + adjoint_A_rz_5*minor_123_124 - adjoint_A_x_5*minor_123_246
            + adjoint_A_y_5*minor_123_146;
        const lane adjoint_minor_46_36 =
            adjoint_A_rx_5*minor_123_125 - adjoint_A_ry_5*minor_123_124 + adjoint_A_x_5*minor_123_245
            - adjoint_A_y_5*minor_123_145;
        const lane adjoint_minor_46_45 =
            -adjoint_A_rz_5*minor_123_123 + adjoint_A_x_5*minor_123_236 - adjoint_A_y_5*minor_123_136
            + adjoint_A_z_5*minor_123_126;
        const lane adjoint_minor_46_46 =
            adjoint_A_ry_5*minor_123_123 - adjoint_A_x_5*minor_123_235 + adjoint_A_y_5*minor_123_135
            - adjoint_A_z_5*minor_123_125;
        const lane adjoint_minor_46_56 =
            -adjoint_A_rx_5*minor_123_123 + adjoint_A_x_5*minor_123_234 - adjoint_A_y_5*minor_123_134
            + adjoint_A_z_5*minor_123_124;
        const lane adjoint_A_rz_4 = G_p_rz*t398 + adjoint_D_p_rz_4*forward_t58;
        const lane adjoint_A_ry_4 = G_p_ry*t398 + adjoint_D_p_ry_4*forward_t58;
        const lane adjoint_A_rx_4 = G_p_rx*t398 + adjoint_D_p_rx_4*forward_t58;
        const lane adjoint_minor_123_123 =
            adjoint_A_rx_4*minor_56_56 - adjoint_A_rx_5*minor_46_56 + adjoint_A_rx_6*minor_45_56
            - adjoint_A_ry_4*minor_56_46 + adjoint_A_ry_5*minor_46_46 - adjoint_A_ry_6*minor_45_46
            + adjoint_A_rz_4*minor_56_45 - adjoint_A_rz_5*minor_46_45 + adjoint_A_rz_6*minor_45_45;
        const lane adjoint_A_z_4 = G_p_z*t398 + adjoint_D_p_z_4*forward_t58;
        const lane adjoint_minor_123_126 =
            adjoint_A_rx_4*minor_56_35 - adjoint_A_rx_5*minor_46_35 + adjoint_A_rx_6*minor_45_35
            - adjoint_A_ry_4*minor_56_34 + adjoint_A_ry_5*minor_46_34 - adjoint_A_ry_6*minor_45_34
            - adjoint_A_z_4*minor_56_45 + adjoint_A_z_5*minor_46_45 - adjoint_A_z_6*minor_45_45;
        const lane adjoint_minor_123_125 =
            -adjoint_A_rx_4*minor_56_36 + adjoint_A_rx_5*minor_46_36 - adjoint_A_rx_6*minor_45_36
            + adjoint_A_rz_4*minor_56_34 - adjoint_A_rz_5*minor_46_34 + adjoint_A_rz_6*minor_45_34
            + adjoint_A_z_4*minor_56_46 - adjoint_A_z_5*minor_46_46 + adjoint_A_z_6*minor_45_46;
        const lane adjoint_minor_123_124 =
            adjoint_A_ry_4*minor_56_36 - adjoint_A_ry_5*minor_46_36 + adjoint_A_ry_6*minor_45_36
            - adjoint_A_rz_4*minor_56_35 + adjoint_A_rz_5*minor_46_35 - adjoint_A_rz_6*minor_45_35
            - adjoint_A_z_4*minor_56_56 + adjoint_A_z_5*minor_46_56 - adjoint_A_z_6*minor_45_56;
        const lane adjoint_A_y_4 = G_p_y*t398 + adjoint_D_p_y_4*forward_t58;
        const lane adjoint_minor_123_156 =
            adjoint_A_rx_4*minor_56_23 - adjoint_A_rx_5*minor_46_23 + adjoint_A_rx_6*minor_45_23
            + adjoint_A_y_4*minor_56_34 - adjoint_A_y_5*minor_46_34 + adjoint_A_y_6*minor_45_34
            - adjoint_A_z_4*minor_56_24 + adjoint_A_z_5*minor_46_24 - adjoint_A_z_6*minor_45_24;
        const lane adjoint_minor_123_146 =
            -adjoint_A_ry_4*minor_56_23 + adjoint_A_ry_5*minor_46_23 - adjoint_A_ry_6*minor_45_23
            - adjoint_A_y_4*minor_56_35 + adjoint_A_y_5*minor_46_35 - adjoint_A_y_6*minor_45_35
            + adjoint_A_z_4*minor_56_25 - adjoint_A_z_5*minor_46_25 + adjoint_A_z_6*minor_45_25;
        const lane adjoint_minor_123_145 =
            adjoint_A_rz_4*minor_56_23 - adjoint_A_rz_5*minor_46_23 + adjoint_A_rz_6*minor_45_23
            + adjoint_A_y_4*minor_56_36 - adjoint_A_y_5*minor_46_36 + adjoint_A_y_6*minor_45_36
            - adjoint_A_z_4*minor_56_26 + adjoint_A_z_5*minor_46_26 - adjoint_A_z_6*minor_45_26;
        const lane adjoint_minor_123_136 =
            -adjoint_A_rx_4*minor_56_25 + adjoint_A_rx_5*minor_46_25 - adjoint_A_rx_6*minor_45_25
            + adjoint_A_ry_4*minor_56_24 - adjoint_A_ry_5*minor_46_24 + adjoint_A_ry_6*minor_45_24
            + adjoint_A_y_4*minor_56_45 - adjoint_A_y_5*minor_46_45 + adjoint_A_y_6*minor_45_45;
        const lane adjoint_minor_123_135 =
            adjoint_A_rx_4*minor_56_26 - adjoint_A_rx_5*minor_46_26 + adjoint_A_rx_6*minor_45_26
            - adjoint_A_rz_4*minor_56_24 + adjoint_A_rz_5*minor_46_24 - adjoint_A_rz_6*minor_45_24
            - adjoint_A_y_4*minor_56_46 + adjoint_A_y_5*minor_46_46 - adjoint_A_y_6*minor_45_46;
        const lane adjoint_minor_123_134 =
            -adjoint_A_ry_4*minor_56_26 + adjoint_A_ry_5*minor_46_26 - adjoint_A_ry_6*minor_45_26
            + adjoint_A_rz_4*minor_56_25 - adjoint_A_rz_5*minor_46_25 + adjoint_A_rz_6*minor_45_25
            + adjoint_A_y_4*minor_56_56 - adjoint_A_y_5*minor_46_56 + adjoint_A_y_6*minor_45_56;
        const lane adjoint_A_x_4 = G_p_x*t398 + adjoint_D_p_x_4*forward_t58;
        const lane adjoint_minor_123_456 =
            -adjoint_A_x_4*minor_56_23 + adjoint_A_x_5*minor_46_23 - adjoint_A_x_6*minor_45_23
            + adjoint_A_y_4*minor_56_13 - adjoint_A_y_5*minor_46_13 + adjoint_A_y_6*minor_45_13
            - adjoint_A_z_4*minor_56_12 + adjoint_A_z_5*minor_46_12 - adjoint_A_z_6*minor_45_12;
        const lane adjoint_minor_123_356 =
            adjoint_A_rx_4*minor_56_12 - adjoint_A_rx_5*minor_46_12 + adjoint_A_rx_6*minor_45_12
            + adjoint_A_x_4*minor_56_24 - adjoint_A_x_5*minor_46_24 + adjoint_A_x_6*minor_45_24
            - adjoint_A_y_4*minor_56_14 + adjoint_A_y_5*minor_46_14 - adjoint_A_y_6*minor_45_14;
        const lane adjoint_minor_123_346 =
            -adjoint_A_ry_4*minor_56_12 + adjoint_A_ry_5*minor_46_12 - adjoint_A_ry_6*minor_45_12
            - adjoint_A_x_4*minor_56_25 + adjoint_A_x_5*minor_46_25 - adjoint_A_x_6*minor_45_25
            + adjoint_A_y_4*minor_56_15 - adjoint_A_y_5*minor_46_15 + adjoint_A_y_6*minor_45_15;
        const lane adjoint_minor_123_345 =
            adjoint_A_rz_4*minor_56_12 - adjoint_A_rz_5*minor_46_12 + adjoint_A_rz_6*minor_45_12
            + adjoint_A_x_4*minor_56_26 - adjoint_A_x_5*minor_46_26 + adjoint_A_x_6*minor_45_26
            - adjoint_A_y_4*minor_56_16 + adjoint_A_y_5*minor_46_16 - adjoint_A_y_6*minor_45_16;
        const lane adjoint_minor_123_256 =
            -adjoint_A_rx_4*minor_56_13 + adjoint_A_rx_5*minor_46_13 - adjoint_A_rx_6*minor_45_13
            - adjoint_A_x_4*minor_56_34 + adjoint_A_x_5*minor_46_34 - adjoint_A_x_6*minor_45_34
            + adjoint_A_z_4*minor_56_14 - adjoint_A_z_5*minor_46_14 + adjoint_A_z_6*minor_45_14;
        const lane adjoint_minor_123_246 =
            adjoint_A_ry_4*minor_56_13 - adjoint_A_ry_5*minor_46_13 + adjoint_A_ry_6*minor_45_13
            + adjoint_A_x_4*minor_56_35 - adjoint_A_x_5*minor_46_35 + adjoint_A_x_6*minor_45_35
            - adjoint_A_z_4*minor_56_15 + adjoint_A_z_5*minor_46_15 - adjoint_A_z_6*minor_45_15;
        const lane adjoint_minor_123_245 =
            -adjoint_A_rz_4*minor_56_13 + adjoint_A_rz_5*minor_46_13 - adjoint_A_rz_6*minor_45_13
            - adjoint_A_x_4*minor_56_36 + adjoint_A_x_5*minor_46_36 - adjoint_A_x_6*minor_45_36
            + adjoint_A_z_4*minor_56_16 - adjoint_A_z_5*minor_46_16 + adjoint_A_z_6*minor_45_16;
        const lane adjoint_minor_123_236 =
            adjoint_A_rx_4*minor_56_15 - adjoint_A_rx_5*minor_46_15 + adjoint_A_rx_6*minor_45_15
            - adjoint_A_ry_4*minor_56_14 + adjoint_A_ry_5*minor_46_14 - adjoint_A_ry_6*minor_45_14
            - adjoint_A_x_4*minor_56_45 + adjoint_A_x_5*minor_46_45 - adjoint_A_x_6*minor_45_45;
        const lane adjoint_minor_123_235 =
            -adjoint_A_rx_4*minor_56_16 + adjoint_A_rx_5*minor_46_16 - adjoint_A_rx_6*minor_45_16
            + adjoint_A_rz_4*minor_56_14 - adjoint_A_rz_5*minor_46_14 + adjoint_A_rz_6*minor_45_14
            + adjoint_A_x_4*minor_56_46 - adjoint_A_x_5*minor_46_46 + adjoint_A_x_6*minor_45_46;
        const lane adjoint_minor_123_234 =
            adjoint_A_ry_4*minor_56_16 - adjoint_A_ry_5*minor_46_16 + adjoint_A_ry_6*minor_45_16
            - adjoint_A_rz_4*minor_56_15 + adjoint_A_rz_5*minor_46_15 - adjoint_A_rz_6*minor_45_15
            - adjoint_A_x_4*minor_56_56 + adjoint_A_x_5*minor_46_56 - adjoint_A_x_6*minor_45_56;
        const lane adjoint_A_rz_3 = G_p_rz*t397 + adjoint_D_p_rz_3*forward_t57;
        const lane adjoint_A_ry_3 = G_p_ry*t397 + adjoint_D_p_ry_3*forward_t57;
        const lane adjoint_A_rx_3 = G_p_rx*t397 + adjoint_D_p_rx_3*forward_t57;
        const lane adjoint_A_z_3 = G_p_z*t397 + adjoint_D_p_z_3*forward_t57;
        const lane adjoint_minor_12_12 =
            -adjoint_A_rx_3*minor_456_356 + adjoint_A_ry_3*minor_456_346 - adjoint_A_rz_3*minor_456_345
            + adjoint_A_z_3*minor_456_456;
        const lane adjoint_A_y_3 = G_p_y*t397 + adjoint_D_p_y_3*forward_t57;
        const lane adjoint_minor_12_16 =
            adjoint_A_rx_3*minor_456_235 - adjoint_A_ry_3*minor_456_234 + adjoint_A_y_3*minor_456_345
            - adjoint_A_z_3*minor_456_245;
        const lane adjoint_minor_12_15 =
            -adjoint_A_rx_3*minor_456_236 + adjoint_A_rz_3*minor_456_234 - adjoint_A_y_3*minor_456_346
            + adjoint_A_z_3*minor_456_246;
        const lane adjoint_minor_12_14 =
            adjoint_A_ry_3*minor_456_236 - adjoint_A_rz_3*minor_456_235 + adjoint_A_y_3*minor_456_356
            - adjoint_A_z_3*minor_456_256;
        const lane adjoint_minor_12_13 =
            adjoint_A_rx_3*minor_456_256 - adjoint_A_ry_3*minor_456_246 + adjoint_A_rz_3*minor_456_245
            - adjoint_A_y_3*minor_456_456;
        const lane adjoint_A_x_3 = G_p_x*t397 + adjoint_D_p_x_3*forward_t57;
        const lane adjoint_minor_12_56 =
            -adjoint_A_rx_3*minor_456_123 + adjoint_A_x_3*minor_456_234 - adjoint_A_y_3*minor_456_134
            + adjoint_A_z_3*minor_456_124;
        const lane adjoint_minor_12_46 =
            adjoint_A_ry_3*minor_456_123 - adjoint_A_x_3*minor_456_235 + adjoint_A_y_3*minor_456_135
            - adjoint_A_z_3*minor_456_125;
        const lane adjoint_minor_12_45 =
            -adjoint_A_rz_3*minor_456_123 + adjoint_A_x_3*minor_456_236 - adjoint_A_y_3*minor_456_136
            + adjoint_A_z_3*minor_456_126;
        const lane adjoint_minor_12_36 =
            adjoint_A_rx_3*minor_456_125 - adjoint_A_ry_3*minor_456_124 + adjoint_A_x_3*minor_456_245
            - adjoint_A_y_3*minor_456_145;
        const lane adjoint_minor_12_35 =
            -adjoint_A_rx_3*minor_456_126 + adjoint_A_rz_3*minor_456_124 - adjoint_A_x_3*minor_456_246
            + adjoint_A_y_3*minor_456_146;
        const lane adjoint_minor_12_34 =
            adjoint_A_ry_3*minor_456_126 - adjoint_A_rz_3*minor_456_125 + adjoint_A_x_3*minor_456_256
            - adjoint_A_y_3*minor_456_156;
        const lane adjoint_minor_12_26 =
            -adjoint_A_rx_3*minor_456_135 + adjoint_A_ry_3*minor_456_134 - adjoint_A_x_3*minor_456_345
            + adjoint_A_z_3*minor_456_145;
        const lane adjoint_minor_12_25 =
            adjoint_A_rx_3*minor_456_136 - adjoint_A_rz_3*minor_456_134 + adjoint_A_x_3*minor_456_346
            - adjoint_A_z_3*minor_456_146;
        const lane adjoint_minor_12_24 =
            -adjoint_A_ry_3*minor_456_136 + adjoint_A_rz_3*minor_456_135 - adjoint_A_x_3*minor_456_356
            + adjoint_A_z_3*minor_456_156;
        const lane adjoint_minor_12_23 =
            -adjoint_A_rx_3*minor_456_156 + adjoint_A_ry_3*minor_456_146 - adjoint_A_rz_3*minor_456_145
            + adjoint_A_x_3*minor_456_456;
        const lane adjoint_A_rz_2 = G_p_rz*t396 + adjoint_D_p_rz_2*forward_t56;
        const lane adjoint_A_ry_2 = G_p_ry*t396 + adjoint_D_p_ry_2*forward_t56;
        const lane adjoint_A_rx_2 = G_p_rx*t396 + adjoint_D_p_rx_2*forward_t56;
        const lane adjoint_A_z_2 = G_p_z*t396 + adjoint_D_p_z_2*forward_t56;
        const lane adjoint_minor_13_12 =
            adjoint_A_rx_2*minor_456_356 - adjoint_A_ry_2*minor_456_346 + adjoint_A_rz_2*minor_456_345
            - adjoint_A_z_2*minor_456_456;
        const lane adjoint_A_y_2 = G_p_y*t396 + adjoint_D_p_y_2*forward_t56;
        const lane adjoint_minor_13_16 =
            -adjoint_A_rx_2*minor_456_235 + adjoint_A_ry_2*minor_456_234 - adjoint_A_y_2*minor_456_345
            + adjoint_A_z_2*minor_456_245;
        const lane adjoint_minor_13_15 =
            adjoint_A_rx_2*minor_456_236 - adjoint_A_rz_2*minor_456_234 + adjoint_A_y_2*minor_456_346
            - adjoint_A_z_2*minor_456_246;
        const lane adjoint_minor_13_14 =
            -adjoint_A_ry_2*minor_456_236 + adjoint_A_rz_2*minor_456_235 - adjoint_A_y_2*minor_456_356
            + adjoint_A_z_2*minor_456_256;
        const lane adjoint_minor_13_13 =
            -adjoint_A_rx_2*minor_456_256 + adjoint_A_ry_2*minor_456_246 - adjoint_A_rz_2*minor_456_245
            + adjoint_A_y_2*minor_456_456;
        const lane adjoint_A_x_2 = G_p_x*t396 + adjoint_D_p_x_2*forward_t56;
        const lane adjoint_minor_13_56 =
            adjoint_A_rx_2*minor_456_123 - adjoint_A_x_2*minor_456_234 + adjoint_A_y_2*minor_456_134
            - adjoint_A_z_2*minor_456_124;
        const lane adjoint_minor_13_46 =
            -adjoint_A_ry_2*minor_456_123 + adjoint_A_x_2*minor_456_235 - adjoint_A_y_2*minor_456_135
            + adjoint_A_z_2*minor_456_125;
        const lane adjoint_minor_13_45 =
            adjoint_A_rz_2*minor_456_123 - adjoint_A_x_2*minor_456_236 + adjoint_A_y_2*minor_456_136
            - adjoint_A_z_2*minor_456_126;
        const lane adjoint_minor_13_36 =
            -adjoint_A_rx_2*minor_456_125 + adjoint_A_ry_2*minor_456_124 - adjoint_A_x_2*minor_456_245
            + adjoint_A_y_2*minor_456_145;
        const lane adjoint_minor_13_35 =
            adjoint_A_rx_2*minor_456_126 - adjoint_A_rz_2*minor_456_124 + adjoint_A_x_2*minor_456_246
            - adjoint_A_y_2*minor_456_146;
        const lane adjoint_minor_13_34 =
            -adjoint_A_ry_2*minor_456_126 + adjoint_A_rz_2*minor_456_125 - adjoint_A_x_2*minor_456_256
            + adjoint_A_y_2*minor_456_156;
        const lane adjoint_minor_13_26 =
            adjoint_A_rx_2*minor_456_135 - adjoint_A_ry_2*minor_456_134 + adjoint_A_x_2*minor_456_345
            - adjoint_A_z_2*minor_456_145;
        const lane adjoint_minor_13_25 =
            -adjoint_A_rx_2*minor_456_136 + adjoint_A_rz_2*minor_456_134 - adjoint_A_x_2*minor_456_346
            + adjoint_A_z_2*minor_456_146;
        const lane adjoint_minor_13_24 =
            adjoint_A_ry_2*minor_456_136 - adjoint_A_rz_2*minor_456_135 + adjoint_A_x_2*minor_456_356
            - adjoint_A_z_2*minor_456_156;
        const lane adjoint_minor_13_23 =
            adjoint_A_rx_2*minor_456_156 - adjoint_A_ry_2*minor_456_146 + adjoint_A_rz_2*minor_456_145
            - adjoint_A_x_2*minor_456_456;
        const lane adjoint_A_rz_1 = D_l_1_rz*adjoint_det_D_l + G_p_rz*t395 + adjoint_D_p_rz_1*forward_t55;
        const lane adjoint_A_ry_1 = D_l_1_ry*adjoint_det_D_l + G_p_ry*t395 + adjoint_D_p_ry_1*forward_t55;
        const lane adjoint_A_rx_1 = D_l_1_rx*adjoint_det_D_l + G_p_rx*t395 + adjoint_D_p_rx_1*forward_t55;
        const lane adjoint_minor_456_123 =
            -adjoint_A_rx_1*minor_23_56 + adjoint_A_rx_2*minor_13_56 - adjoint_A_rx_3*minor_12_56
            + adjoint_A_ry_1*minor_23_46 - adjoint_A_ry_2*minor_13_46 + adjoint_A_ry_3*minor_12_46
            - adjoint_A_rz_1*minor_23_45 + adjoint_A_rz_2*minor_13_45 - adjoint_A_rz_3*minor_12_45;
        const lane adjoint_A_z_1 = G_p_z*t395 + adjoint_D_p_z_1*forward_t55 + adjoint_det_D_l*d_1_z;
        const lane adjoint_minor_456_124 =
            -adjoint_A_ry_1*minor_23_36 + adjoint_A_ry_2*minor_13_36 - adjoint_A_ry_3*minor_12_36
            + adjoint_A_rz_1*minor_23_35 - adjoint_A_rz_2*minor_13_35 + adjoint_A_rz_3*minor_12_35
            + adjoint_A_z_1*minor_23_56 - adjoint_A_z_2*minor_13_56 + adjoint_A_z_3*minor_12_56;
        const lane adjoint_minor_456_125 =
            adjoint_A_rx_1*minor_23_36 - adjoint_A_rx_2*minor_13_36 + adjoint_A_rx_3*minor_12_36
            - adjoint_A_rz_1*minor_23_34 + adjoint_A_rz_2*minor_13_34 - adjoint_A_rz_3*minor_12_34
            - adjoint_A_z_1*minor_23_46 + adjoint_A_z_2*minor_13_46 - adjoint_A_z_3*minor_12_46;
        const lane adjoint_minor_456_126 =
            -adjoint_A_rx_1*minor_23_35 + adjoint_A_rx_2*minor_13_35 - adjoint_A_rx_3*minor_12_35
            + adjoint_A_ry_1*minor_23_34 - adjoint_A_ry_2*minor_13_34 + adjoint_A_ry_3*minor_12_34
            + adjoint_A_z_1*minor_23_45 - adjoint_A_z_2*minor_13_45 + adjoint_A_z_3*minor_12_45;
        const lane adjoint_minor_56_12 =
            D_l_4_rx*adjoint_minor_456_124 + D_l_4_ry*adjoint_minor_456_125 + D_l_4_rz*adjoint_minor_456_126
            + adjoint_A_rx_4*minor_123_356 - adjoint_A_ry_4*minor_123_346 + adjoint_A_rz_4*minor_123_345
            - adjoint_A_z_4*minor_123_456 + adjoint_minor_456_123*d_4_z;
        const lane adjoint_minor_23_12 =
            D_l_1_rx*adjoint_minor_123_124 + D_l_1_ry*adjoint_minor_123_125 + D_l_1_rz*adjoint_minor_123_126
            - adjoint_A_rx_1*minor_456_356 + adjoint_A_ry_1*minor_456_346 - adjoint_A_rz_1*minor_456_345
            + adjoint_A_z_1*minor_456_456 + adjoint_minor_123_123*d_1_z;
        const lane adjoint_A_y_1 = G_p_y*t395 + adjoint_D_p_y_1*forward_t55 + adjoint_det_D_l*d_1_y;
        const lane adjoint_minor_456_134 =
            adjoint_A_ry_1*minor_23_26 - adjoint_A_ry_2*minor_13_26 + adjoint_A_ry_3*minor_12_26
            - adjoint_A_rz_1*minor_23_25 + adjoint_A_rz_2*minor_13_25 - adjoint_A_rz_3*minor_12_25
            - adjoint_A_y_1*minor_23_56 + adjoint_A_y_2*minor_13_56 - adjoint_A_y_3*minor_12_56;
        const lane adjoint_minor_456_135 =
            -adjoint_A_rx_1*minor_23_26 + adjoint_A_rx_2*minor_13_26 - adjoint_A_rx_3*minor_12_26
            + adjoint_A_rz_1*minor_23_24 - adjoint_A_rz_2*minor_13_24 + adjoint_A_rz_3*minor_12_24
            + adjoint_A_y_1*minor_23_46 - adjoint_A_y_2*minor_13_46 + adjoint_A_y_3*minor_12_46;
        const lane adjoint_minor_456_136 =
            adjoint_A_rx_1*minor_23_25 - adjoint_A_rx_2*minor_13_25 + adjoint_A_rx_3*minor_12_25
            - adjoint_A_ry_1*minor_23_24 + adjoint_A_ry_2*minor_13_24 - adjoint_A_ry_3*minor_12_24
            - adjoint_A_y_1*minor_23_45 + adjoint_A_y_2*minor_13_45 - adjoint_A_y_3*minor_12_45;
        const lane adjoint_minor_56_13 =
            D_l_4_rx*adjoint_minor_456_134 + D_l_4_ry*adjoint_minor_456_135 + D_l_4_rz*adjoint_minor_456_136
            - adjoint_A_rx_4*minor_123_256 + adjoint_A_ry_4*minor_123_246 - adjoint_A_rz_4*minor_123_245
            + adjoint_A_y_4*minor_123_456 - adjoint_minor_456_123*d_4_y;
        const lane adjoint_minor_456_145 =
            -adjoint_A_rz_1*minor_23_23 + adjoint_A_rz_2*minor_13_23 - adjoint_A_rz_3*minor_12_23
            - adjoint_A_y_1*minor_23_36 + adjoint_A_y_2*minor_13_36 - adjoint_A_y_3*minor_12_36
            + adjoint_A_z_1*minor_23_26 - adjoint_A_z_2*minor_13_26 + adjoint_A_z_3*minor_12_26;
        const lane adjoint_minor_456_146 =
            adjoint_A_ry_1*minor_23_23 - adjoint_A_ry_2*minor_13_23 + adjoint_A_ry_3*minor_12_23
            + adjoint_A_y_1*minor_23_35 - adjoint_A_y_2*minor_13_35 + adjoint_A_y_3*minor_12_35
            - adjoint_A_z_1*minor_23_25 + adjoint_A_z_2*minor_13_25 - adjoint_A_z_3*minor_12_25;
        const lane adjoint_minor_56_14 =
            D_l_4_ry*adjoint_minor_456_145 + D_l_4_rz*adjoint_minor_456_146 - adjoint_A_ry_4*minor_123_236
            + adjoint_A_rz_4*minor_123_235 - adjoint_A_y_4*minor_123_356 + adjoint_A_z_4*minor_123_256
            - adjoint_minor_456_124*d_4_y - adjoint_minor_456_134*d_4_z;
        const lane adjoint_minor_456_156 =
            -adjoint_A_rx_1*minor_23_23 + adjoint_A_rx_2*minor_13_23 - adjoint_A_rx_3*minor_12_23
            - adjoint_A_y_1*minor_23_34 + adjoint_A_y_2*minor_13_34 - adjoint_A_y_3*minor_12_34
            + adjoint_A_z_1*minor_23_24 - adjoint_A_z_2*minor_13_24 + adjoint_A_z_3*minor_12_24;
        const lane adjoint_minor_56_15 =
            -D_l_4_rx*adjoint_minor_456_145 + D_l_4_rz*adjoint_minor_456_156 + adjoint_A_rx_4*minor_123_236
            - adjoint_A_rz_4*minor_123_234 + adjoint_A_y_4*minor_123_346 - adjoint_A_z_4*minor_123_246
            - adjoint_minor_456_125*d_4_y - adjoint_minor_456_135*d_4_z;
        const lane adjoint_minor_56_16 =
            -D_l_4_rx*adjoint_minor_456_146 - D_l_4_ry*adjoint_minor_456_156 - adjoint_A_rx_4*minor_123_235
            + adjoint_A_ry_4*minor_123_234 - adjoint_A_y_4*minor_123_345 + adjoint_A_z_4*minor_123_245
            - adjoint_minor_456_126*d_4_y - adjoint_minor_456_136*d_4_z;
        const lane adjoint_minor_23_16 =
            -D_l_1_rx*adjoint_minor_123_146 - D_l_1_ry*adjoint_minor_123_156 + adjoint_A_rx_1*minor_456_235
            - adjoint_A_ry_1*minor_456_234 + adjoint_A_y_1*minor_456_345 - adjoint_A_z_1*minor_456_245
            - adjoint_minor_123_126*d_1_y - adjoint_minor_123_136*d_1_z;
        const lane adjoint_minor_23_15 =
            -D_l_1_rx*adjoint_minor_123_145 + D_l_1_rz*adjoint_minor_123_156 - adjoint_A_rx_1*minor_456_236
            + adjoint_A_rz_1*minor_456_234 - adjoint_A_y_1*minor_456_346 + adjoint_A_z_1*minor_456_246
            - adjoint_minor_123_125*d_1_y - adjoint_minor_123_135*d_1_z;
        const lane adjoint_minor_23_14 =
            D_l_1_ry*adjoint_minor_123_145 + D_l_1_rz*adjoint_minor_123_146 + adjoint_A_ry_1*minor_456_236
            - adjoint_A_rz_1*minor_456_235 + adjoint_A_y_1*minor_456_356 - adjoint_A_z_1*minor_456_256
            - adjoint_minor_123_124*d_1_y - adjoint_minor_123_134*d_1_z;
        const lane adjoint_minor_23_13 =
            D_l_1_rx*adjoint_minor_123_134 + D_l_1_ry*adjoint_minor_123_135 + D_l_1_rz*adjoint_minor_123_136
            + adjoint_A_rx_1*minor_456_256 - adjoint_A_ry_1*minor_456_246 + adjoint_A_rz_1*minor_456_245
            - adjoint_A_y_1*minor_456_456 - adjoint_minor_123_123*d_1_y;
        const lane adjoint_A_x_1 = G_p_x*t395 + adjoint_D_p_x_1*forward_t55 + adjoint_det_D_l*d_1_x;
        const lane adjoint_minor_456_234 =
            -adjoint_A_ry_1*minor_23_16 + adjoint_A_ry_2*minor_13_16 - adjoint_A_ry_3*minor_12_16
            + adjoint_A_rz_1*minor_23_15 - adjoint_A_rz_2*minor_13_15 + adjoint_A_rz_3*minor_12_15
            + adjoint_A_x_1*minor_23_56 - adjoint_A_x_2*minor_13_56 + adjoint_A_x_3*minor_12_56;
        const lane adjoint_minor_23_56 =
            D_l_1_rx*adjoint_minor_123_456 - adjoint_A_rx_1*minor_456_123 + adjoint_A_x_1*minor_456_234
            - adjoint_A_y_1*minor_456_134 + adjoint_A_z_1*minor_456_124 + adjoint_minor_123_156*d_1_x
            + adjoint_minor_123_256*d_1_y + adjoint_minor_123_356*d_1_z;
        const lane adjoint_minor_456_235 =
            adjoint_A_rx_1*minor_23_16 - adjoint_A_rx_2*minor_13_16 + adjoint_A_rx_3*minor_12_16
            - adjoint_A_rz_1*minor_23_14 + adjoint_A_rz_2*minor_13_14 - adjoint_A_rz_3*minor_12_14
            - adjoint_A_x_1*minor_23_46 + adjoint_A_x_2*minor_13_46 - adjoint_A_x_3*minor_12_46;
        const lane adjoint_minor_23_46 =
            -D_l_1_ry*adjoint_minor_123_456 + adjoint_A_ry_1*minor_456_123 - adjoint_A_x_1*minor_456_235
            + adjoint_A_y_1*minor_456_135 - adjoint_A_z_1*minor_456_125 + adjoint_minor_123_146*d_1_x
            + adjoint_minor_123_246*d_1_y + adjoint_minor_123_346*d_1_z;
        const lane adjoint_minor_456_236 =
            -adjoint_A_rx_1*minor_23_15 + adjoint_A_rx_2*minor_13_15 - adjoint_A_rx_3*minor_12_15
            + adjoint_A_ry_1*minor_23_14 - adjoint_A_ry_2*minor_13_14 + adjoint_A_ry_3*minor_12_14
            + adjoint_A_x_1*minor_23_45 - adjoint_A_x_2*minor_13_45 + adjoint_A_x_3*minor_12_45;
        const lane adjoint_minor_56_23 =
            D_l_4_rx*adjoint_minor_456_234 + D_l_4_ry*adjoint_minor_456_235 + D_l_4_rz*adjoint_minor_456_236
            + adjoint_A_rx_4*minor_123_156 - adjoint_A_ry_4*minor_123_146 + adjoint_A_rz_4*minor_123_145
            - adjoint_A_x_4*minor_123_456 + adjoint_minor_456_123*d_4_x;
        const lane adjoint_minor_23_45 =
            D_l_1_rz*adjoint_minor_123_456 - adjoint_A_rz_1*minor_456_123 + adjoint_A_x_1*minor_456_236
            - adjoint_A_y_1*minor_456_136 + adjoint_A_z_1*minor_456_126 + adjoint_minor_123_145*d_1_x
            + adjoint_minor_123_245*d_1_y + adjoint_minor_123_345*d_1_z;
        const lane adjoint_minor_456_245 =
            adjoint_A_rz_1*minor_23_13 - adjoint_A_rz_2*minor_13_13 + adjoint_A_rz_3*minor_12_13
            + adjoint_A_x_1*minor_23_36 - adjoint_A_x_2*minor_13_36 + adjoint_A_x_3*minor_12_36
            - adjoint_A_z_1*minor_23_16 + adjoint_A_z_2*minor_13_16 - adjoint_A_z_3*minor_12_16;
        const lane adjoint_minor_23_36 =
            -D_l_1_rx*adjoint_minor_123_346 - D_l_1_ry*adjoint_minor_123_356 + adjoint_A_rx_1*minor_456_125
            - adjoint_A_ry_1*minor_456_124 + adjoint_A_x_1*minor_456_245 - adjoint_A_y_1*minor_456_145
            + adjoint_minor_123_136*d_1_x + adjoint_minor_123_236*d_1_y;
        const lane adjoint_minor_456_246 =
            -adjoint_A_ry_1*minor_23_13 + adjoint_A_ry_2*minor_13_13 - adjoint_A_ry_3*minor_12_13
            - adjoint_A_x_1*minor_23_35 + adjoint_A_x_2*minor_13_35 - adjoint_A_x_3*minor_12_35
            + adjoint_A_z_1*minor_23_15 - adjoint_A_z_2*minor_13_15 + adjoint_A_z_3*minor_12_15;
        const lane adjoint_minor_56_24 =
            D_l_4_ry*adjoint_minor_456_245 + D_l_4_rz*adjoint_minor_456_246 + adjoint_A_ry_4*minor_123_136
            - adjoint_A_rz_4*minor_123_135 + adjoint_A_x_4*minor_123_356 - adjoint_A_z_4*minor_123_156
            + adjoint_minor_456_124*d_4_x - adjoint_minor_456_234*d_4_z;
        const lane adjoint_minor_23_35 =
            -D_l_1_rx*adjoint_minor_123_345 + D_l_1_rz*adjoint_minor_123_356 - adjoint_A_rx_1*minor_456_126
            + adjoint_A_rz_1*minor_456_124 - adjoint_A_x_1*minor_456_246 + adjoint_A_y_1*minor_456_146
            + adjoint_minor_123_135*d_1_x + adjoint_minor_123_235*d_1_y;
        const lane adjoint_minor_456_256 =
            adjoint_A_rx_1*minor_23_13 - adjoint_A_rx_2*minor_13_13 + adjoint_A_rx_3*minor_12_13
            + adjoint_A_x_1*minor_23_34 - adjoint_A_x_2*minor_13_34 + adjoint_A_x_3*minor_12_34
            - adjoint_A_z_1*minor_23_14 + adjoint_A_z_2*minor_13_14 - adjoint_A_z_3*minor_12_14;
        const lane adjoint_minor_56_25 =
            -D_l_4_rx*adjoint_minor_456_245 + D_l_4_rz*adjoint_minor_456_256 - adjoint_A_rx_4*minor_123_136
            + adjoint_A_rz_4*minor_123_134 - adjoint_A_x_4*minor_123_346 + adjoint_A_z_4*minor_123_146
            + adjoint_minor_456_125*d_4_x - adjoint_minor_456_235*d_4_z;
        const lane adjoint_minor_56_26 =
            -D_l_4_rx*adjoint_minor_456_246 - D_l_4_ry*adjoint_minor_456_256 + adjoint_A_rx_4*minor_123_135
            - adjoint_A_ry_4*minor_123_134 + adjoint_A_x_4*minor_123_345 - adjoint_A_z_4*minor_123_145
            + adjoint_minor_456_126*d_4_x - adjoint_minor_456_236*d_4_z;
        const lane adjoint_minor_23_34 =
            D_l_1_ry*adjoint_minor_123_345 + D_l_1_rz*adjoint_minor_123_346 + adjoint_A_ry_1*minor_456_126
            - adjoint_A_rz_1*minor_456_125 + adjoint_A_x_1*minor_456_256 - adjoint_A_y_1*minor_456_156
            + adjoint_minor_123_134*d_1_x + adjoint_minor_123_234*d_1_y;
        const lane adjoint_minor_456_345 =
            -adjoint_A_rz_1*minor_23_12 + adjoint_A_rz_2*minor_13_12 - adjoint_A_rz_3*minor_12_12
            - adjoint_A_x_1*minor_23_26 + adjoint_A_x_2*minor_13_26 - adjoint_A_x_3*minor_12_26
            + adjoint_A_y_1*minor_23_16 - adjoint_A_y_2*minor_13_16 + adjoint_A_y_3*minor_12_16;
        const lane adjoint_minor_23_26 =
            -D_l_1_rx*adjoint_minor_123_246 - D_l_1_ry*adjoint_minor_123_256 - adjoint_A_rx_1*minor_456_135
            + adjoint_A_ry_1*minor_456_134 - adjoint_A_x_1*minor_456_345 + adjoint_A_z_1*minor_456_145
            + adjoint_minor_123_126*d_1_x - adjoint_minor_123_236*d_1_z;
        const lane adjoint_minor_456_346 =
            adjoint_A_ry_1*minor_23_12 - adjoint_A_ry_2*minor_13_12 + adjoint_A_ry_3*minor_12_12
            + adjoint_A_x_1*minor_23_25 - adjoint_A_x_2*minor_13_25 + adjoint_A_x_3*minor_12_25
            - adjoint_A_y_1*minor_23_15 + adjoint_A_y_2*minor_13_15 - adjoint_A_y_3*minor_12_15;
        const lane adjoint_minor_56_34 =
            D_l_4_ry*adjoint_minor_456_345 + D_l_4_rz*adjoint_minor_456_346 - adjoint_A_ry_4*minor_123_126
            + adjoint_A_rz_4*minor_123_125 - adjoint_A_x_4*minor_123_256 + adjoint_A_y_4*minor_123_156
            + adjoint_minor_456_134*d_4_x + adjoint_minor_456_234*d_4_y;
        const lane adjoint_minor_23_25 =
            -D_l_1_rx*adjoint_minor_123_245 + D_l_1_rz*adjoint_minor_123_256 + adjoint_A_rx_1*minor_456_136
            - adjoint_A_rz_1*minor_456_134 + adjoint_A_x_1*minor_456_346 - adjoint_A_z_1*minor_456_146
            + adjoint_minor_123_125*d_1_x - adjoint_minor_123_235*d_1_z;
        const lane adjoint_minor_456_356 =
            -adjoint_A_rx_1*minor_23_12 + adjoint_A_rx_2*minor_13_12 - adjoint_A_rx_3*minor_12_12
            - adjoint_A_x_1*minor_23_24 + adjoint_A_x_2*minor_13_24 - adjoint_A_x_3*minor_12_24
            + adjoint_A_y_1*minor_23_14 - adjoint_A_y_2*minor_13_14 + adjoint_A_y_3*minor_12_14;
        const lane adjoint_minor_56_35 =
            -D_l_4_rx*adjoint_minor_456_345 + D_l_4_rz*adjoint_minor_456_356 + adjoint_A_rx_4*minor_123_126
            - adjoint_A_rz_4*minor_123_124 + adjoint_A_x_4*minor_123_246 - adjoint_A_y_4*minor_123_146
            + adjoint_minor_456_135*d_4_x + adjoint_minor_456_235*d_4_y;
        const lane adjoint_minor_56_36 =
            -D_l_4_rx*adjoint_minor_456_346 - D_l_4_ry*adjoint_minor_456_356 - adjoint_A_rx_4*minor_123_125
            + adjoint_A_ry_4*minor_123_124 - adjoint_A_x_4*minor_123_245 + adjoint_A_y_4*minor_123_145
            + adjoint_minor_456_136*d_4_x + adjoint_minor_456_236*d_4_y;
        const lane adjoint_minor_23_24 =
            D_l_1_ry*adjoint_minor_123_245 + D_l_1_rz*adjoint_minor_123_246 - adjoint_A_ry_1*minor_456_136
            + adjoint_A_rz_1*minor_456_135 - adjoint_A_x_1*minor_456_356 + adjoint_A_z_1*minor_456_156
            + adjoint_minor_123_124*d_1_x - adjoint_minor_123_234*d_1_z;
        const lane adjoint_minor_456_456 =
            adjoint_A_x_1*minor_23_23 - adjoint_A_x_2*minor_13_23 + adjoint_A_x_3*minor_12_23
            - adjoint_A_y_1*minor_23_13 + adjoint_A_y_2*minor_13_13 - adjoint_A_y_3*minor_12_13
            + adjoint_A_z_1*minor_23_12 - adjoint_A_z_2*minor_13_12 + adjoint_A_z_3*minor_12_12;
        const lane adjoint_minor_56_45 =
            D_l_4_rz*adjoint_minor_456_456 + adjoint_A_rz_4*minor_123_123 - adjoint_A_x_4*minor_123_236
            + adjoint_A_y_4*minor_123_136 - adjoint_A_z_4*minor_123_126 + adjoint_minor_456_145*d_4_x
            + adjoint_minor_456_245*d_4_y + adjoint_minor_456_345*d_4_z;
        const lane adjoint_minor_56_46 =
            -D_l_4_ry*adjoint_minor_456_456 - adjoint_A_ry_4*minor_123_123 + adjoint_A_x_4*minor_123_235
            - adjoint_A_y_4*minor_123_135 + adjoint_A_z_4*minor_123_125 + adjoint_minor_456_146*d_4_x
            + adjoint_minor_456_246*d_4_y + adjoint_minor_456_346*d_4_z;
        const lane adjoint_minor_56_56 =
            D_l_4_rx*adjoint_minor_456_456 + adjoint_A_rx_4*minor_123_123 - adjoint_A_x_4*minor_123_234
            + adjoint_A_y_4*minor_123_134 - adjoint_A_z_4*minor_123_124 + adjoint_minor_456_156*d_4_x
            + adjoint_minor_456_256*d_4_y + adjoint_minor_456_356*d_4_z;
        const lane adjoint_minor_23_23 =
            D_l_1_rx*adjoint_minor_123_234 + D_l_1_ry*adjoint_minor_123_235 + D_l_1_rz*adjoint_minor_123_236
            - adjoint_A_rx_1*minor_456_156 + adjoint_A_ry_1*minor_456_146 - adjoint_A_rz_1*minor_456_145
            + adjoint_A_x_1*minor_456_456 + adjoint_minor_123_123*d_1_x;
        const lane adjoint_D_l_6_rz =
            D_l_4_rx*adjoint_minor_46_46 + D_l_4_ry*adjoint_minor_46_56 + D_l_5_rx*adjoint_minor_56_46
            + D_l_5_ry*adjoint_minor_56_56 + adjoint_minor_46_16*d_4_x + adjoint_minor_46_26*d_4_y
            + adjoint_minor_46_36*d_4_z + adjoint_minor_56_16*d_5_x + adjoint_minor_56_26*d_5_y
            + adjoint_minor_56_36*d_5_z;
        const lane adjoint_D_l_6_ry =
            D_l_4_rx*adjoint_minor_46_45 - D_l_4_rz*adjoint_minor_46_56 + D_l_5_rx*adjoint_minor_56_45
            - D_l_5_rz*adjoint_minor_56_56 + adjoint_minor_46_15*d_4_x + adjoint_minor_46_25*d_4_y
            + adjoint_minor_46_35*d_4_z + adjoint_minor_56_15*d_5_x + adjoint_minor_56_25*d_5_y
            + adjoint_minor_56_35*d_5_z;
        const lane adjoint_D_l_6_rx =
            -D_l_4_ry*adjoint_minor_46_45 - D_l_4_rz*adjoint_minor_46_46 - D_l_5_ry*adjoint_minor_56_45
            - D_l_5_rz*adjoint_minor_56_46 + adjoint_minor_46_14*d_4_x + adjoint_minor_46_24*d_4_y
            + adjoint_minor_46_34*d_4_z + adjoint_minor_56_14*d_5_x + adjoint_minor_56_24*d_5_y
            + adjoint_minor_56_34*d_5_z;
        const lane adjoint_D_l_5_rz =
            D_l_4_rx*adjoint_minor_45_46 + D_l_4_ry*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_56_46
            - D_l_6_ry*adjoint_minor_56_56 + adjoint_minor_45_16*d_4_x + adjoint_minor_45_26*d_4_y
            + adjoint_minor_45_36*d_4_z - adjoint_minor_56_16*d_6_x - adjoint_minor_56_26*d_6_y
            - adjoint_minor_56_36*d_6_z;
        const lane adjoint_D_l_5_ry =
            D_l_4_rx*adjoint_minor_45_45 - D_l_4_rz*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_56_45
            + D_l_6_rz*adjoint_minor_56_56 + adjoint_minor_45_15*d_4_x + adjoint_minor_45_25*d_4_y
            + adjoint_minor_45_35*d_4_z - adjoint_minor_56_15*d_6_x - adjoint_minor_56_25*d_6_y
            - adjoint_minor_56_35*d_6_z;
        const lane adjoint_D_l_5_rx =
            -D_l_4_ry*adjoint_minor_45_45 - D_l_4_rz*adjoint_minor_45_46 + D_l_6_ry*adjoint_minor_56_45
            + D_l_6_rz*adjoint_minor_56_46 + adjoint_minor_45_14*d_4_x + adjoint_minor_45_24*d_4_y
            + adjoint_minor_45_34*d_4_z - adjoint_minor_56_14*d_6_x - adjoint_minor_56_24*d_6_y
            - adjoint_minor_56_34*d_6_z;
        const lane adjoint_D_l_4_rz =
            -D_l_5_rx*adjoint_minor_45_46 - D_l_5_ry*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_46_46
            - D_l_6_ry*adjoint_minor_46_56 + adjoint_minor_456_126*minor_56_12
            + adjoint_minor_456_136*minor_56_13 + adjoint_minor_456_146*minor_56_14
            + adjoint_minor_456_156*minor_56_15 + adjoint_minor_456_236*minor_56_23
            + adjoint_minor_456_246*minor_56_24 + adjoint_minor_456_256*minor_56_25
            + adjoint_minor_456_346*minor_56_34 + adjoint_minor_456_356*minor_56_35
            + adjoint_minor_456_456*minor_56_45 - adjoint_minor_45_16*d_5_x - adjoint_minor_45_26*d_5_y
            - adjoint_minor_45_36*d_5_z - adjoint_minor_46_16*d_6_x - adjoint_minor_46_26*d_6_y
            - adjoint_minor_46_36*d_6_z;
        const lane adjoint_D_l_4_ry =
            -D_l_5_rx*adjoint_minor_45_45 + D_l_5_rz*adjoint_minor_45_56 - D_l_6_rx*adjoint_minor_46_45
            + D_l_6_rz*adjoint_minor_46_56 + adjoint_minor_456_125*minor_56_12
            + adjoint_minor_456_135*minor_56_13 + adjoint_minor_456_145*minor_56_14
            - adjoint_minor_456_156*minor_56_16 + adjoint_minor_456_235*minor_56_23
            + adjoint_minor_456_245*minor_56_24 - adjoint_minor_456_256*minor_56_26
            + adjoint_minor_456_345*minor_56_34 - adjoint_minor_456_356*minor_56_36
            - adjoint_minor_456_456*minor_56_46 - adjoint_minor_45_15*d_5_x - adjoint_minor_45_25*d_5_y
            - adjoint_minor_45_35*d_5_z - adjoint_minor_46_15*d_6_x - adjoint_minor_46_25*d_6_y
            - adjoint_minor_46_35*d_6_z;
        const lane adjoint_D_l_4_rx =
            D_l_5_ry*adjoint_minor_45_45 + D_l_5_rz*adjoint_minor_45_46 + D_l_6_ry*adjoint_minor_46_45
            + D_l_6_rz*adjoint_minor_46_46 + adjoint_minor_456_124*minor_56_12
            + adjoint_minor_456_134*minor_56_13 - adjoint_minor_456_145*minor_56_15
            - adjoint_minor_456_146*minor_56_16 + adjoint_minor_456_234*minor_56_23
            - adjoint_minor_456_245*minor_56_25 - adjoint_minor_456_246*minor_56_26
            - adjoint_minor_456_345*minor_56_35 - adjoint_minor_456_346*minor_56_36
            + adjoint_minor_456_456*minor_56_56 - adjoint_minor_45_14*d_5_x - adjoint_minor_45_24*d_5_y
            - adjoint_minor_45_34*d_5_z - adjoint_minor_46_14*d_6_x - adjoint_minor_46_24*d_6_y
            - adjoint_minor_46_34*d_6_z;
        const lane adjoint_D_l_3_rz =
            D_l_1_rx*adjoint_minor_13_46 + D_l_1_ry*adjoint_minor_13_56 + D_l_2_rx*adjoint_minor_23_46
            + D_l_2_ry*adjoint_minor_23_56 + adjoint_minor_13_16*d_1_x + adjoint_minor_13_26*d_1_y
            + adjoint_minor_13_36*d_1_z + adjoint_minor_23_16*d_2_x + adjoint_minor_23_26*d_2_y
            + adjoint_minor_23_36*d_2_z;
        const lane adjoint_D_l_3_ry =
            D_l_1_rx*adjoint_minor_13_45 - D_l_1_rz*adjoint_minor_13_56 + D_l_2_rx*adjoint_minor_23_45
            - D_l_2_rz*adjoint_minor_23_56 + adjoint_minor_13_15*d_1_x + adjoint_minor_13_25*d_1_y
            + adjoint_minor_13_35*d_1_z + adjoint_minor_23_15*d_2_x + adjoint_minor_23_25*d_2_y
            + adjoint_minor_23_35*d_2_z;
        const lane adjoint_D_l_3_rx =
            -D_l_1_ry*adjoint_minor_13_45 - D_l_1_rz*adjoint_minor_13_46 - D_l_2_ry*adjoint_minor_23_45
            - D_l_2_rz*adjoint_minor_23_46 + adjoint_minor_13_14*d_1_x + adjoint_minor_13_24*d_1_y
            + adjoint_minor_13_34*d_1_z + adjoint_minor_23_14*d_2_x + adjoint_minor_23_24*d_2_y
            + adjoint_minor_23_34*d_2_z;
        const lane adjoint_D_l_2_rz =
            D_l_1_rx*adjoint_minor_12_46 + D_l_1_ry*adjoint_minor_12_56 - D_l_3_rx*adjoint_minor_23_46
            - D_l_3_ry*adjoint_minor_23_56 + adjoint_minor_12_16*d_1_x + adjoint_minor_12_26*d_1_y
            + adjoint_minor_12_36*d_1_z - adjoint_minor_23_16*d_3_x - adjoint_minor_23_26*d_3_y
            - adjoint_minor_23_36*d_3_z;
        const lane adjoint_D_l_2_ry =
            D_l_1_rx*adjoint_minor_12_45 - D_l_1_rz*adjoint_minor_12_56 - D_l_3_rx*adjoint_minor_23_45
            + D_l_3_rz*adjoint_minor_23_56 + adjoint_minor_12_15*d_1_x + adjoint_minor_12_25*d_1_y
            + adjoint_minor_12_35*d_1_z - adjoint_minor_23_15*d_3_x - adjoint_minor_23_25*d_3_y
            - adjoint_minor_23_35*d_3_z;
        const lane adjoint_D_l_2_rx =
            -D_l_1_ry*adjoint_minor_12_45 - D_l_1_rz*adjoint_minor_12_46 + D_l_3_ry*adjoint_minor_23_45
            + D_l_3_rz*adjoint_minor_23_46 + adjoint_minor_12_14*d_1_x + adjoint_minor_12_24*d_1_y
            + adjoint_minor_12_34*d_1_z - adjoint_minor_23_14*d_3_x - adjoint_minor_23_24*d_3_y
            - adjoint_minor_23_34*d_3_z;
        const lane adjoint_D_l_1_rz =
            A_rz_1*adjoint_det_D_l - D_l_2_rx*adjoint_minor_12_46 - D_l_2_ry*adjoint_minor_12_56
            - D_l_3_rx*adjoint_minor_13_46 - D_l_3_ry*adjoint_minor_13_56 + adjoint_minor_123_126*minor_23_12
            + adjoint_minor_123_136*minor_23_13 + adjoint_minor_123_146*minor_23_14
            + adjoint_minor_123_156*minor_23_15 + adjoint_minor_123_236*minor_23_23
            + adjoint_minor_123_246*minor_23_24 + adjoint_minor_123_256*minor_23_25
            + adjoint_minor_123_346*minor_23_34 + adjoint_minor_123_356*minor_23_35
            + adjoint_minor_123_456*minor_23_45 - adjoint_minor_12_16*d_2_x - adjoint_minor_12_26*d_2_y
            - adjoint_minor_12_36*d_2_z - adjoint_minor_13_16*d_3_x - adjoint_minor_13_26*d_3_y
            - adjoint_minor_13_36*d_3_z;
        const lane adjoint_D_l_1_ry =
            A_ry_1*adjoint_det_D_l - D_l_2_rx*adjoint_minor_12_45 + D_l_2_rz*adjoint_minor_12_56
            - D_l_3_rx*adjoint_minor_13_45 + D_l_3_rz*adjoint_minor_13_56 + adjoint_minor_123_125*minor_23_12
            + adjoint_minor_123_135*minor_23_13 + adjoint_minor_123_145*minor_23_14
            - adjoint_minor_123_156*minor_23_16 + adjoint_minor_123_235*minor_23_23
            + adjoint_minor_123_245*minor_23_24 - adjoint_minor_123_256*minor_23_26
            + adjoint_minor_123_345*minor_23_34 - adjoint_minor_123_356*minor_23_36
            - adjoint_minor_123_456*minor_23_46 - adjoint_minor_12_15*d_2_x - adjoint_minor_12_25*d_2_y
            - adjoint_minor_12_35*d_2_z - adjoint_minor_13_15*d_3_x - adjoint_minor_13_25*d_3_y
            - adjoint_minor_13_35*d_3_z;
        const lane adjoint_D_l_1_rx =
            A_rx_1*adjoint_det_D_l + D_l_2_ry*adjoint_minor_12_45 + D_l_2_rz*adjoint_minor_12_46
            + D_l_3_ry*adjoint_minor_13_45 + D_l_3_rz*adjoint_minor_13_46 + adjoint_minor_123_124*minor_23_12
            + adjoint_minor_123_134*minor_23_13 - adjoint_minor_123_145*minor_23_15
            - adjoint_minor_123_146*minor_23_16 + adjoint_minor_123_234*minor_23_23
            - adjoint_minor_123_245*minor_23_25 - adjoint_minor_123_246*minor_23_26
            - adjoint_minor_123_345*minor_23_35 - adjoint_minor_123_346*minor_23_36
            + adjoint_minor_123_456*minor_23_56 - adjoint_minor_12_14*d_2_x - adjoint_minor_12_24*d_2_y
            - adjoint_minor_12_34*d_2_z - adjoint_minor_13_14*d_3_x - adjoint_minor_13_24*d_3_y
            - adjoint_minor_13_34*d_3_z;
        const lane t446 = (1.0/2.0)*adjoint_L_ry_rz;
        const lane adjoint_o_L_z =
            adjoint_G_p_rx*forward_t85 - adjoint_G_p_ry*forward_t83 + adjoint_L_rx_rz*forward_t126
            + adjoint_forward_t104*g_11_z + adjoint_forward_t184*m_L + 4.0*adjoint_forward_t200*o_L_z
            + g_11_y*t446;
        const lane adjoint_o_L_y =
            -adjoint_G_p_rx*forward_t81 + adjoint_G_p_rz*forward_t83 + adjoint_L_rx_ry*forward_t126
            - adjoint_M_p_ry_rz*forward_t184 + adjoint_forward_t111*g_11_y + adjoint_forward_t192*m_L
            + 4.0*adjoint_forward_t199*o_L_y + g_11_z*t446;
        const lane adjoint_o_L_x =
            adjoint_G_p_ry*forward_t81 - adjoint_G_p_rz*forward_t85 - adjoint_M_p_rx_ry*forward_t192
            - adjoint_M_p_rx_rz*forward_t184 + adjoint_M_p_y_rz*m_L + (1.0/2.0)*adjoint_forward_t127
            + adjoint_forward_t134*g_11_x + 4.0*adjoint_forward_t223*o_L_x;
        const lane adjoint_m_lift_6 =
            B_6_y*adjoint_G_p_rz*g_x + B_6_z*adjoint_G_p_rx*g_y + adjoint_forward_t231
            + adjoint_forward_t66*g_x + adjoint_forward_t73*g_y + adjoint_forward_t79*g_z;
        const lane t447 =
            B_6_x*adjoint_forward_t234 + B_6_y*adjoint_forward_t233 + B_6_z*adjoint_forward_t232
            + adjoint_m_lift_6;
        const lane adjoint_forward_t53 = -adjoint_forward_t235 + t447;
        const lane adjoint_forward_t52 =
            adjoint_forward_t145*forward_20 + adjoint_forward_t53*forward_21 + forward_34*t121;
        const lane t448 = adjoint_M_p_x_x - adjoint_forward_t231;
        const lane adjoint_m_perp_6 =
            B_6_x*adjoint_forward_t198 + B_6_y*adjoint_forward_t190 + B_6_z*adjoint_forward_t182
            + (1.0/2.0)*adjoint_forward_t222 + t401 + t448;
        const lane t449 = 2.0*adjoint_m_perp_6*t52;
        const lane adjoint_forward_t51 = adjoint_forward_t53*forward_t52 - t449*t55;
        const lane adjoint_forward_t50 =
            adjoint_forward_t145*forward_t52 + adjoint_m_perp_6*(I_b_6 + I_r_6 + t51);
        const lane adjoint_m_lift_5 =
            B_5_y*adjoint_G_p_rz*g_x + B_5_z*adjoint_G_p_rx*g_y + adjoint_forward_t231
            + adjoint_forward_t65*g_x + adjoint_forward_t72*g_y + adjoint_forward_t78*g_z;
        const lane t450 =
            B_5_x*adjoint_forward_t234 + B_5_y*adjoint_forward_t233 + B_5_z*adjoint_forward_t232
            + adjoint_m_lift_5;
        const lane adjoint_forward_t49 = -adjoint_forward_t235 + t450;
        const lane adjoint_forward_t48 =
            adjoint_forward_t143*forward_18 + adjoint_forward_t49*forward_19 + forward_33*t123;
        const lane adjoint_m_perp_5 =
            B_5_x*adjoint_forward_t198 + B_5_y*adjoint_forward_t189 + B_5_z*adjoint_forward_t181
            + (1.0/2.0)*adjoint_forward_t219 + t403 + t448;
        const lane t451 = 2.0*adjoint_m_perp_5*t46;
        const lane adjoint_forward_t47 = adjoint_forward_t49*forward_t48 - t451*t49;
        const lane adjoint_forward_t46 =
            adjoint_forward_t143*forward_t48 + adjoint_m_perp_5*(I_b_5 + I_r_5 + t45);
        const lane adjoint_m_lift_4 =
            B_4_y*adjoint_G_p_rz*g_x + B_4_z*adjoint_G_p_rx*g_y + adjoint_forward_t231
            + adjoint_forward_t64*g_x + adjoint_forward_t71*g_y + adjoint_forward_t77*g_z;
        const lane t452 =
            B_4_x*adjoint_forward_t234 + B_4_y*adjoint_forward_t233 + B_4_z*adjoint_forward_t232
            + adjoint_m_lift_4;
        const lane adjoint_forward_t45 = -adjoint_forward_t235 + t452;
        const lane adjoint_forward_t44 =
            adjoint_forward_t141*forward_16 + adjoint_forward_t45*forward_17 + forward_32*t125;
        const lane adjoint_m_perp_4 =
            B_4_x*adjoint_forward_t198 + B_4_y*adjoint_forward_t188 + B_4_z*adjoint_forward_t180
            + (1.0/2.0)*adjoint_forward_t216 + t405 + t448;
        const lane t453 = 2.0*adjoint_m_perp_4*t40;
        const lane adjoint_forward_t43 = adjoint_forward_t45*forward_t44 - t43*t453;
        const lane adjoint_forward_t42 =
            adjoint_forward_t141*forward_t44 + adjoint_m_perp_4*(I_b_4 + I_r_4 + t39);
        const lane adjoint_m_lift_3 =
            B_3_y*adjoint_G_p_rz*g_x + B_3_z*adjoint_G_p_rx*g_y + adjoint_forward_t231
            + adjoint_forward_t63*g_x + adjoint_forward_t70*g_y + adjoint_forward_t76*g_z;
        const lane t454 =
            B_3_x*adjoint_forward_t234 + B_3_y*adjoint_forward_t233 + B_3_z*adjoint_forward_t232
            + adjoint_m_lift_3;
        const lane adjoint_forward_t41 = -adjoint_forward_t235 + t454;
        const lane adjoint_forward_t40 =
            adjoint_forward_t139*forward_14 + adjoint_forward_t41*forward_15 + forward_31*t127;
        const lane adjoint_m_perp_3 =
            B_3_x*adjoint_forward_t198 + B_3_y*adjoint_forward_t187 + B_3_z*adjoint_forward_t179
            + (1.0/2.0)*adjoint_forward_t213 + t407 + t448;
        const lane t455 = 2.0*adjoint_m_perp_3*t34;
        const lane adjoint_forward_t39 = adjoint_forward_t41*forward_t40 - t37*t455;
        const lane adjoint_forward_t38 =
            adjoint_forward_t139*forward_t40 + adjoint_m_perp_3*(I_b_3 + I_r_3 + t33);
        const lane adjoint_m_lift_2 =
            B_2_y*adjoint_G_p_rz*g_x + B_2_z*adjoint_G_p_rx*g_y + adjoint_forward_t231
            + adjoint_forward_t62*g_x + adjoint_forward_t69*g_y + adjoint_forward_t75*g_z;
        const lane t456 =
            B_2_x*adjoint_forward_t234 + B_2_y*adjoint_forward_t233 + B_2_z*adjoint_forward_t232
            + adjoint_m_lift_2;
        const lane adjoint_forward_t37 = -adjoint_forward_t235 + t456;
        const lane adjoint_forward_t36 =
            adjoint_forward_t137*forward_12 + adjoint_forward_t37*forward_13 + forward_30*t129;
        const lane adjoint_m_perp_2 =
            B_2_x*adjoint_forward_t198 + B_2_y*adjoint_forward_t186 + B_2_z*adjoint_forward_t178
            + (1.0/2.0)*adjoint_forward_t210 + t409 + t448;
        const lane t457 = 2.0*adjoint_m_perp_2*t28;
        const lane adjoint_forward_t35 = adjoint_forward_t37*forward_t36 - t31*t457;
        const lane adjoint_forward_t34 =
            adjoint_forward_t137*forward_t36 + adjoint_m_perp_2*(I_b_2 + I_r_2 + t27);
        const lane adjoint_m_lift_1 =
            B_1_y*adjoint_G_p_rz*g_x + B_1_z*adjoint_G_p_rx*g_y + adjoint_forward_t231
            + adjoint_forward_t61*g_x + adjoint_forward_t68*g_y + adjoint_forward_t74*g_z;
        const lane t458 =
            B_1_x*adjoint_forward_t234 + B_1_y*adjoint_forward_t233 + B_1_z*adjoint_forward_t232
            + adjoint_m_lift_1;
        const lane adjoint_forward_t33 = -adjoint_forward_t235 + t458;
        const lane adjoint_forward_t32 =
            adjoint_forward_t135*forward_10 + adjoint_forward_t33*forward_11 + forward_29*t131;
        const lane adjoint_m_perp_1 =
            B_1_x*adjoint_forward_t198 + B_1_y*adjoint_forward_t185 + B_1_z*adjoint_forward_t177
            + (1.0/2.0)*adjoint_forward_t207 + t411 + t448;
        const lane t459 = 2.0*adjoint_m_perp_1*t22;
        const lane adjoint_forward_t31 = adjoint_forward_t33*forward_t32 - t25*t459;
        const lane adjoint_forward_t30 =
            adjoint_forward_t135*forward_t32 + adjoint_m_perp_1*(I_b_1 + I_r_1 + t21);
        const lane adjoint_forward_t29 = adjoint_M_p_rz_rz*t460;
        const lane t461 = R_y_z*adjoint_M_p_ry_rz;
        const lane adjoint_forward_t28 = adjoint_M_p_rz_rz*forward_t29 + t461;
        const lane t462 = R_y_y*adjoint_M_p_ry_rz;
        const lane t463 = 2.0*adjoint_M_p_rz_rz;
        const lane adjoint_forward_t26 = R_z_y*t463 + t462;
        const lane adjoint_forward_t25 = R_z_z*adjoint_M_p_ry_rz + adjoint_M_p_ry_ry*forward_t24;
        const lane adjoint_forward_t24 = adjoint_M_p_ry_ry*t464;
        const lane t465 = 2.0*adjoint_M_p_ry_ry;
        const lane adjoint_forward_t22 = R_y_y*t465 + R_z_y*adjoint_M_p_ry_rz;
        const lane adjoint_forward_t21 = R_y_z*adjoint_M_p_rx_ry + R_z_z*adjoint_M_p_rx_rz;
        const lane adjoint_forward_t20 = R_y_y*adjoint_M_p_rx_ry + R_z_y*adjoint_M_p_rx_rz;
        const lane adjoint_forward_t18 = R_y_x*adjoint_M_p_rx_ry + R_z_x*adjoint_M_p_rx_rz;
        const lane adjoint_forward_t15 = adjoint_M_p_rx_rx*forward_t14 + adjoint_forward_t21;
        const lane adjoint_forward_t14 = adjoint_M_p_rx_rx*t466;
        const lane t467 = 2.0*adjoint_M_p_rx_rx;
        const lane adjoint_forward_t12 = R_x_y*t467 + adjoint_forward_t20;
        const lane adjoint_c_z =
            adjoint_G_p_rx*forward_t84 - adjoint_G_p_ry*forward_t82 + adjoint_L_rx_rz*forward_t125
            + adjoint_forward_t104*g_10_z + adjoint_forward_t183*m_p + 4.0*adjoint_forward_t203*c_z
            + g_10_y*t446;
        const lane adjoint_c_y =
            -adjoint_G_p_rx*forward_t80 + adjoint_G_p_rz*forward_t82 + adjoint_L_rx_ry*forward_t125
            - adjoint_M_p_ry_rz*forward_t183 + adjoint_forward_t111*g_10_y + adjoint_forward_t191*m_p
            + 4.0*adjoint_forward_t202*c_y + g_10_z*t446;
        const lane adjoint_c_x =
            adjoint_G_p_ry*forward_t80 - adjoint_G_p_rz*forward_t84 - adjoint_M_p_rx_ry*forward_t191
            - adjoint_M_p_rx_rz*forward_t183 + adjoint_M_p_y_rz*m_p + (1.0/2.0)*adjoint_forward_t124
            + adjoint_forward_t134*g_10_x + 4.0*adjoint_forward_t224*c_x;
        const lane adjoint_l_6 =
            -3.0*adjoint_forward_34/(forward_9*forward_9*forward_9*forward_9)
            - 2.0*adjoint_forward_t50*forward_34 - adjoint_forward_t51*(forward_21*forward_21)
            + adjoint_forward_t60*forward_22;
        const lane adjoint_l_5 =
            -3.0*adjoint_forward_33/(forward_8*forward_8*forward_8*forward_8)
            - 2.0*adjoint_forward_t46*forward_33 - adjoint_forward_t47*(forward_19*forward_19)
            + adjoint_forward_t59*forward_22;
        const lane adjoint_l_4 =
            -3.0*adjoint_forward_32/(forward_7*forward_7*forward_7*forward_7)
            - 2.0*adjoint_forward_t42*forward_32 - adjoint_forward_t43*(forward_17*forward_17)
            + adjoint_forward_t58*forward_22;
        const lane adjoint_l_3 =
            -3.0*adjoint_forward_31/(forward_6*forward_6*forward_6*forward_6)
            - 2.0*adjoint_forward_t38*forward_31 - adjoint_forward_t39*(forward_15*forward_15)
            + adjoint_forward_t57*forward_22;
        const lane adjoint_l_2 =
            -3.0*adjoint_forward_30/(forward_5*forward_5*forward_5*forward_5)
            - 2.0*adjoint_forward_t34*forward_30 - adjoint_forward_t35*(forward_13*forward_13)
            + adjoint_forward_t56*forward_22;
        const lane adjoint_l_1 =
            -3.0*adjoint_forward_29/(forward_4*forward_4*forward_4*forward_4)
            - 2.0*adjoint_forward_t30*forward_29 - adjoint_forward_t31*(forward_11*forward_11)
            + adjoint_forward_t55*forward_22;
        const lane t469 = forward_34*forward_t52*t120;
        const lane adjoint_d_6_z =
            -B_6_x*adjoint_D_l_6_ry + B_6_y*adjoint_D_l_6_rx - D_l_4_rx*adjoint_minor_46_34
            - D_l_4_ry*adjoint_minor_46_35 - D_l_4_rz*adjoint_minor_46_36 - D_l_5_rx*adjoint_minor_56_34
            - D_l_5_ry*adjoint_minor_56_35 - D_l_5_rz*adjoint_minor_56_36 - adjoint_g_9_z*mu_6
            + adjoint_l_6*d_6_z*t470 + adjoint_minor_46_13*d_4_x + adjoint_minor_46_23*d_4_y
            + adjoint_minor_56_13*d_5_x + adjoint_minor_56_23*d_5_y
            + 2.0*eigenvalue*forward_t145*shape_15*shape_6 - t468*t469;
        const lane adjoint_B_6_z =
            2.0*B_6_z*adjoint_forward_t103 - adjoint_D_l_6_rx*d_6_y + adjoint_D_l_6_ry*d_6_x
            + adjoint_G_p_rx*forward_t73 - adjoint_G_p_ry*forward_t66 + adjoint_L_rx_rz*forward_t123
            + adjoint_d_6_z + adjoint_forward_t104*g_9_z + adjoint_forward_t164*forward_t152
            - adjoint_forward_t170*forward_t146 + adjoint_forward_t182*m_perp_6
            + adjoint_forward_t232*m_lift_6 + adjoint_forward_t91*mu_6 + g_9_y*t446;
        const lane t471 = 2.0*t469;
        const lane adjoint_d_6_y =
            B_6_x*adjoint_D_l_6_rz - B_6_z*adjoint_D_l_6_rx - D_l_4_rx*adjoint_minor_46_24
            - D_l_4_ry*adjoint_minor_46_25 - D_l_4_rz*adjoint_minor_46_26 - D_l_5_rx*adjoint_minor_56_24
            - D_l_5_ry*adjoint_minor_56_25 - D_l_5_rz*adjoint_minor_56_26 - adjoint_g_9_y*mu_6
            + adjoint_l_6*d_6_y*t470 + adjoint_minor_46_12*d_4_x - adjoint_minor_46_23*d_4_z
            + adjoint_minor_56_12*d_5_x - adjoint_minor_56_23*d_5_z
            + 2.0*eigenvalue*forward_t145*shape_14*shape_6 - g_y*t471;
        const lane adjoint_B_6_y =
            2.0*B_6_y*adjoint_forward_t110 + adjoint_D_l_6_rx*d_6_z - adjoint_D_l_6_rz*d_6_x
            - adjoint_G_p_rx*forward_t79 + adjoint_G_p_rz*forward_t66 + adjoint_L_rx_ry*forward_t123
            + adjoint_L_ry_rz*(forward_t91 + t70) - adjoint_M_p_ry_rz*forward_t182 + adjoint_d_6_y
            + adjoint_forward_t111*g_9_y - adjoint_forward_t164*forward_t158
            + adjoint_forward_t176*forward_t146 + adjoint_forward_t190*m_perp_6
            + adjoint_forward_t233*m_lift_6 + adjoint_forward_t96*mu_6;
        const lane adjoint_d_6_x =
            -B_6_y*adjoint_D_l_6_rz + B_6_z*adjoint_D_l_6_ry - D_l_4_rx*adjoint_minor_46_14
            - D_l_4_ry*adjoint_minor_46_15 - D_l_4_rz*adjoint_minor_46_16 - D_l_5_rx*adjoint_minor_56_14
            - D_l_5_ry*adjoint_minor_56_15 - D_l_5_rz*adjoint_minor_56_16 - adjoint_g_9_x*mu_6
            + adjoint_l_6*d_6_x*t470 - adjoint_minor_46_12*d_4_y - adjoint_minor_46_13*d_4_z
            - adjoint_minor_56_12*d_5_y - adjoint_minor_56_13*d_5_z
            + 2.0*eigenvalue*forward_t145*shape_13*shape_6 - g_x*t471;
        const lane adjoint_B_6_x =
            2.0*B_6_x*adjoint_forward_t133 - adjoint_D_l_6_ry*d_6_z + adjoint_D_l_6_rz*d_6_y
            + adjoint_G_p_ry*forward_t79 - adjoint_G_p_rz*forward_t73 + adjoint_L_rx_ry*forward_t96
            + adjoint_L_rx_rz*forward_t91 + adjoint_L_z_ry*mu_6 - adjoint_M_p_rx_ry*forward_t190
            - adjoint_M_p_rx_rz*forward_t182 + adjoint_d_6_x + (1.0/2.0)*adjoint_forward_t122
            + adjoint_forward_t134*g_9_x + adjoint_forward_t170*forward_t158
            - adjoint_forward_t176*forward_t152 + adjoint_forward_t198*m_perp_6
            + adjoint_forward_t234*m_lift_6;
        const lane t472 = forward_33*forward_t48*t122;
        const lane adjoint_d_5_z =
            -B_5_x*adjoint_D_l_5_ry + B_5_y*adjoint_D_l_5_rx - D_l_4_rx*adjoint_minor_45_34
            - D_l_4_ry*adjoint_minor_45_35 - D_l_4_rz*adjoint_minor_45_36 + D_l_6_rx*adjoint_minor_56_34
            + D_l_6_ry*adjoint_minor_56_35 + D_l_6_rz*adjoint_minor_56_36 - adjoint_g_8_z*mu_5
            + adjoint_l_5*d_5_z*t473 + adjoint_minor_45_13*d_4_x + adjoint_minor_45_23*d_4_y
            - adjoint_minor_56_13*d_6_x - adjoint_minor_56_23*d_6_y
            + 2.0*eigenvalue*forward_t143*shape_15*shape_5 - t468*t472;
        const lane adjoint_B_5_z =
            2.0*B_5_z*adjoint_forward_t102 - adjoint_D_l_5_rx*d_5_y + adjoint_D_l_5_ry*d_5_x
            + adjoint_G_p_rx*forward_t72 - adjoint_G_p_ry*forward_t65 + adjoint_L_rx_rz*forward_t121
            + adjoint_d_5_z + adjoint_forward_t104*g_8_z + adjoint_forward_t163*forward_t151
            - adjoint_forward_t169*forward_t144 + adjoint_forward_t181*m_perp_5
            + adjoint_forward_t232*m_lift_5 + adjoint_forward_t90*mu_5 + g_8_y*t446;
        const lane t474 = 2.0*t472;
        const lane adjoint_d_5_y =
            B_5_x*adjoint_D_l_5_rz - B_5_z*adjoint_D_l_5_rx - D_l_4_rx*adjoint_minor_45_24
            - D_l_4_ry*adjoint_minor_45_25 - D_l_4_rz*adjoint_minor_45_26 + D_l_6_rx*adjoint_minor_56_24
            + D_l_6_ry*adjoint_minor_56_25 + D_l_6_rz*adjoint_minor_56_26 - adjoint_g_8_y*mu_5
            + adjoint_l_5*d_5_y*t473 + adjoint_minor_45_12*d_4_x - adjoint_minor_45_23*d_4_z
            - adjoint_minor_56_12*d_6_x + adjoint_minor_56_23*d_6_z + forward_t143*t312 - g_y*t474;
        const lane adjoint_B_5_y =
            2.0*B_5_y*adjoint_forward_t109 + adjoint_D_l_5_rx*d_5_z - adjoint_D_l_5_rz*d_5_x
            - adjoint_G_p_rx*forward_t78 + adjoint_G_p_rz*forward_t65 + adjoint_L_rx_ry*forward_t121
            + adjoint_L_ry_rz*(forward_t90 + t68) - adjoint_M_p_ry_rz*forward_t181 + adjoint_d_5_y
            + adjoint_forward_t111*g_8_y - adjoint_forward_t163*forward_t157
            + adjoint_forward_t175*forward_t144 + adjoint_forward_t189*m_perp_5
            + adjoint_forward_t233*m_lift_5 + adjoint_forward_t95*mu_5;
        const lane adjoint_d_5_x =
            -B_5_y*adjoint_D_l_5_rz + B_5_z*adjoint_D_l_5_ry - D_l_4_rx*adjoint_minor_45_14
            - D_l_4_ry*adjoint_minor_45_15 - D_l_4_rz*adjoint_minor_45_16 + D_l_6_rx*adjoint_minor_56_14
            + D_l_6_ry*adjoint_minor_56_15 + D_l_6_rz*adjoint_minor_56_16 - adjoint_g_8_x*mu_5
            + adjoint_l_5*d_5_x*t473 - adjoint_minor_45_12*d_4_y - adjoint_minor_45_13*d_4_z
            + adjoint_minor_56_12*d_6_y + adjoint_minor_56_13*d_6_z
            + 2.0*eigenvalue*forward_t143*shape_13*shape_5 - g_x*t474;
        const lane adjoint_B_5_x =
            2.0*B_5_x*adjoint_forward_t132 - adjoint_D_l_5_ry*d_5_z + adjoint_D_l_5_rz*d_5_y
            + adjoint_G_p_ry*forward_t78 - adjoint_G_p_rz*forward_t72 + adjoint_L_rx_ry*forward_t95
            + adjoint_L_rx_rz*forward_t90 + adjoint_L_z_ry*mu_5 - adjoint_M_p_rx_ry*forward_t189
            - adjoint_M_p_rx_rz*forward_t181 + adjoint_d_5_x + (1.0/2.0)*adjoint_forward_t120
            + adjoint_forward_t134*g_8_x + adjoint_forward_t169*forward_t157
            - adjoint_forward_t175*forward_t151 + adjoint_forward_t198*m_perp_5
            + adjoint_forward_t234*m_lift_5;
        const lane t475 = forward_32*forward_t44*t124;
        const lane adjoint_d_4_z =
            -B_4_x*adjoint_D_l_4_ry + B_4_y*adjoint_D_l_4_rx + D_l_5_rx*adjoint_minor_45_34
            + D_l_5_ry*adjoint_minor_45_35 + D_l_5_rz*adjoint_minor_45_36 + D_l_6_rx*adjoint_minor_46_34
            + D_l_6_ry*adjoint_minor_46_35 + D_l_6_rz*adjoint_minor_46_36 - adjoint_g_7_z*mu_4
            + adjoint_l_4*d_4_z*t476 + adjoint_minor_456_123*minor_56_12 - adjoint_minor_456_134*minor_56_14
            - adjoint_minor_456_135*minor_56_15 - adjoint_minor_456_136*minor_56_16
            - adjoint_minor_456_234*minor_56_24 - adjoint_minor_456_235*minor_56_25
            - adjoint_minor_456_236*minor_56_26 + adjoint_minor_456_345*minor_56_45
            + adjoint_minor_456_346*minor_56_46 + adjoint_minor_456_356*minor_56_56
            - adjoint_minor_45_13*d_5_x - adjoint_minor_45_23*d_5_y - adjoint_minor_46_13*d_6_x
            - adjoint_minor_46_23*d_6_y + 2.0*eigenvalue*forward_t141*shape_15*shape_4 - t468*t475;
        const lane adjoint_B_4_z =
            2.0*B_4_z*adjoint_forward_t101 - adjoint_D_l_4_rx*d_4_y + adjoint_D_l_4_ry*d_4_x
            + adjoint_G_p_rx*forward_t71 - adjoint_G_p_ry*forward_t64 + adjoint_L_rx_rz*forward_t119
            + adjoint_d_4_z + adjoint_forward_t104*g_7_z + adjoint_forward_t162*forward_t150
            - adjoint_forward_t168*forward_t142 + adjoint_forward_t180*m_perp_4
            + adjoint_forward_t232*m_lift_4 + adjoint_forward_t89*mu_4 + g_7_y*t446;
        const lane t477 = 2.0*t475;
        const lane t478 = adjoint_l_4*t476;
        const lane adjoint_d_4_y =
            B_4_x*adjoint_D_l_4_rz - B_4_z*adjoint_D_l_4_rx + D_l_5_rx*adjoint_minor_45_24
            + D_l_5_ry*adjoint_minor_45_25 + D_l_5_rz*adjoint_minor_45_26 + D_l_6_rx*adjoint_minor_46_24
            + D_l_6_ry*adjoint_minor_46_25 + D_l_6_rz*adjoint_minor_46_26 - adjoint_g_7_y*mu_4
            - adjoint_minor_456_123*minor_56_13 - adjoint_minor_456_124*minor_56_14
            - adjoint_minor_456_125*minor_56_15 - adjoint_minor_456_126*minor_56_16
            + adjoint_minor_456_234*minor_56_34 + adjoint_minor_456_235*minor_56_35
            + adjoint_minor_456_236*minor_56_36 + adjoint_minor_456_245*minor_56_45
            + adjoint_minor_456_246*minor_56_46 + adjoint_minor_456_256*minor_56_56
            - adjoint_minor_45_12*d_5_x + adjoint_minor_45_23*d_5_z - adjoint_minor_46_12*d_6_x
            + adjoint_minor_46_23*d_6_z + d_4_y*t478 + forward_t141*t311 - g_y*t477;
        const lane adjoint_B_4_y =
            2.0*B_4_y*adjoint_forward_t108 + adjoint_D_l_4_rx*d_4_z - adjoint_D_l_4_rz*d_4_x
            - adjoint_G_p_rx*forward_t77 + adjoint_G_p_rz*forward_t64 + adjoint_L_rx_ry*forward_t119
            + adjoint_L_ry_rz*(forward_t89 + t66) - adjoint_M_p_ry_rz*forward_t180 + adjoint_d_4_y
            + adjoint_forward_t111*g_7_y - adjoint_forward_t162*forward_t156
            + adjoint_forward_t174*forward_t142 + adjoint_forward_t188*m_perp_4
            + adjoint_forward_t233*m_lift_4 + adjoint_forward_t94*mu_4;
        const lane adjoint_d_4_x =
            -B_4_y*adjoint_D_l_4_rz + B_4_z*adjoint_D_l_4_ry + D_l_5_rx*adjoint_minor_45_14
            + D_l_5_ry*adjoint_minor_45_15 + D_l_5_rz*adjoint_minor_45_16 + D_l_6_rx*adjoint_minor_46_14
            + D_l_6_ry*adjoint_minor_46_15 + D_l_6_rz*adjoint_minor_46_16 - adjoint_g_7_x*mu_4
            + adjoint_minor_456_123*minor_56_23 + adjoint_minor_456_124*minor_56_24
            + adjoint_minor_456_125*minor_56_25 + adjoint_minor_456_126*minor_56_26
            + adjoint_minor_456_134*minor_56_34 + adjoint_minor_456_135*minor_56_35
            + adjoint_minor_456_136*minor_56_36 + adjoint_minor_456_145*minor_56_45
            + adjoint_minor_456_146*minor_56_46 + adjoint_minor_456_156*minor_56_56
            + adjoint_minor_45_12*d_5_y + adjoint_minor_45_13*d_5_z + adjoint_minor_46_12*d_6_y
            + adjoint_minor_46_13*d_6_z + d_4_x*t478 + forward_t141*t337 - g_x*t477;
        const lane adjoint_B_4_x =
            2.0*B_4_x*adjoint_forward_t131 - adjoint_D_l_4_ry*d_4_z + adjoint_D_l_4_rz*d_4_y
            + adjoint_G_p_ry*forward_t77 - adjoint_G_p_rz*forward_t71 + adjoint_L_rx_ry*forward_t94
            + adjoint_L_rx_rz*forward_t89 + adjoint_L_z_ry*mu_4 - adjoint_M_p_rx_ry*forward_t188
            - adjoint_M_p_rx_rz*forward_t180 + adjoint_d_4_x + (1.0/2.0)*adjoint_forward_t118
            + adjoint_forward_t134*g_7_x + adjoint_forward_t168*forward_t156
            - adjoint_forward_t174*forward_t150 + adjoint_forward_t198*m_perp_4
            + adjoint_forward_t234*m_lift_4;
        const lane t479 = forward_31*forward_t40*t126;
        const lane adjoint_d_3_z =
            -B_3_x*adjoint_D_l_3_ry + B_3_y*adjoint_D_l_3_rx - D_l_1_rx*adjoint_minor_13_34
            - D_l_1_ry*adjoint_minor_13_35 - D_l_1_rz*adjoint_minor_13_36 - D_l_2_rx*adjoint_minor_23_34
            - D_l_2_ry*adjoint_minor_23_35 - D_l_2_rz*adjoint_minor_23_36 - adjoint_g_6_z*mu_3
            + adjoint_l_3*d_3_z*t480 + adjoint_minor_13_13*d_1_x + adjoint_minor_13_23*d_1_y
            + adjoint_minor_23_13*d_2_x + adjoint_minor_23_23*d_2_y
            + 2.0*eigenvalue*forward_t139*shape_15*shape_3 - t468*t479;
        const lane adjoint_B_3_z =
            2.0*B_3_z*adjoint_forward_t100 - adjoint_D_l_3_rx*d_3_y + adjoint_D_l_3_ry*d_3_x
            + adjoint_G_p_rx*forward_t70 - adjoint_G_p_ry*forward_t63 + adjoint_L_rx_rz*forward_t117
            + adjoint_d_3_z + adjoint_forward_t104*g_6_z + adjoint_forward_t161*forward_t149
            - adjoint_forward_t167*forward_t140 + adjoint_forward_t179*m_perp_3
            + adjoint_forward_t232*m_lift_3 + adjoint_forward_t88*mu_3 + g_6_y*t446;
        const lane t481 = 2.0*t479;
        const lane adjoint_d_3_y =
            B_3_x*adjoint_D_l_3_rz - B_3_z*adjoint_D_l_3_rx - D_l_1_rx*adjoint_minor_13_24
            - D_l_1_ry*adjoint_minor_13_25 - D_l_1_rz*adjoint_minor_13_26 - D_l_2_rx*adjoint_minor_23_24
            - D_l_2_ry*adjoint_minor_23_25 - D_l_2_rz*adjoint_minor_23_26 - adjoint_g_6_y*mu_3
            + adjoint_l_3*d_3_y*t480 + adjoint_minor_13_12*d_1_x - adjoint_minor_13_23*d_1_z
            + adjoint_minor_23_12*d_2_x - adjoint_minor_23_23*d_2_z
            + 2.0*eigenvalue*forward_t139*shape_14*shape_3 - g_y*t481;
        const lane adjoint_B_3_y =
            2.0*B_3_y*adjoint_forward_t107 + adjoint_D_l_3_rx*d_3_z - adjoint_D_l_3_rz*d_3_x
            - adjoint_G_p_rx*forward_t76 + adjoint_G_p_rz*forward_t63 + adjoint_L_rx_ry*forward_t117
            + adjoint_L_ry_rz*(forward_t88 + t64) - adjoint_M_p_ry_rz*forward_t179 + adjoint_d_3_y
            + adjoint_forward_t111*g_6_y - adjoint_forward_t161*forward_t155
            + adjoint_forward_t173*forward_t140 + adjoint_forward_t187*m_perp_3
            + adjoint_forward_t233*m_lift_3 + adjoint_forward_t93*mu_3;
        const lane adjoint_d_3_x =
            -B_3_y*adjoint_D_l_3_rz + B_3_z*adjoint_D_l_3_ry - D_l_1_rx*adjoint_minor_13_14
            - D_l_1_ry*adjoint_minor_13_15 - D_l_1_rz*adjoint_minor_13_16 - D_l_2_rx*adjoint_minor_23_14
            - D_l_2_ry*adjoint_minor_23_15 - D_l_2_rz*adjoint_minor_23_16 - adjoint_g_6_x*mu_3
            + adjoint_l_3*d_3_x*t480 - adjoint_minor_13_12*d_1_y - adjoint_minor_13_13*d_1_z
            - adjoint_minor_23_12*d_2_y - adjoint_minor_23_13*d_2_z
            + 2.0*eigenvalue*forward_t139*shape_13*shape_3 - g_x*t481;
        const lane adjoint_B_3_x =
            2.0*B_3_x*adjoint_forward_t130 - adjoint_D_l_3_ry*d_3_z + adjoint_D_l_3_rz*d_3_y
            + adjoint_G_p_ry*forward_t76 - adjoint_G_p_rz*forward_t70 + adjoint_L_rx_ry*forward_t93
            + adjoint_L_rx_rz*forward_t88 + adjoint_L_z_ry*mu_3 - adjoint_M_p_rx_ry*forward_t187
            - adjoint_M_p_rx_rz*forward_t179 + adjoint_d_3_x + (1.0/2.0)*adjoint_forward_t116
            + adjoint_forward_t134*g_6_x + adjoint_forward_t167*forward_t155
            - adjoint_forward_t173*forward_t149 + adjoint_forward_t198*m_perp_3
            + adjoint_forward_t234*m_lift_3;
        const lane t482 = forward_30*forward_t36*t128;
        const lane adjoint_d_2_z =
            -B_2_x*adjoint_D_l_2_ry + B_2_y*adjoint_D_l_2_rx - D_l_1_rx*adjoint_minor_12_34
            - D_l_1_ry*adjoint_minor_12_35 - D_l_1_rz*adjoint_minor_12_36 + D_l_3_rx*adjoint_minor_23_34
            + D_l_3_ry*adjoint_minor_23_35 + D_l_3_rz*adjoint_minor_23_36 - adjoint_g_5_z*mu_2
            + adjoint_l_2*d_2_z*t483 + adjoint_minor_12_13*d_1_x + adjoint_minor_12_23*d_1_y
            - adjoint_minor_23_13*d_3_x - adjoint_minor_23_23*d_3_y
            + 2.0*eigenvalue*forward_t137*shape_15*shape_2 - t468*t482;
        const lane adjoint_B_2_z =
            2.0*B_2_z*adjoint_forward_t99 - adjoint_D_l_2_rx*d_2_y + adjoint_D_l_2_ry*d_2_x
            + adjoint_G_p_rx*forward_t69 - adjoint_G_p_ry*forward_t62 + adjoint_L_rx_rz*forward_t115
            + adjoint_d_2_z + adjoint_forward_t104*g_5_z + adjoint_forward_t160*forward_t148
            - adjoint_forward_t166*forward_t138 + adjoint_forward_t178*m_perp_2
            + adjoint_forward_t232*m_lift_2 + adjoint_forward_t87*mu_2 + g_5_y*t446;
        const lane t484 = 2.0*t482;
        const lane adjoint_d_2_y =
            B_2_x*adjoint_D_l_2_rz - B_2_z*adjoint_D_l_2_rx - D_l_1_rx*adjoint_minor_12_24
            - D_l_1_ry*adjoint_minor_12_25 - D_l_1_rz*adjoint_minor_12_26 + D_l_3_rx*adjoint_minor_23_24
            + D_l_3_ry*adjoint_minor_23_25 + D_l_3_rz*adjoint_minor_23_26 - adjoint_g_5_y*mu_2
            + adjoint_l_2*d_2_y*t483 + adjoint_minor_12_12*d_1_x - adjoint_minor_12_23*d_1_z
            - adjoint_minor_23_12*d_3_x + adjoint_minor_23_23*d_3_z + forward_t137*t309 - g_y*t484;
        const lane adjoint_B_2_y =
            2.0*B_2_y*adjoint_forward_t106 + adjoint_D_l_2_rx*d_2_z - adjoint_D_l_2_rz*d_2_x
            - adjoint_G_p_rx*forward_t75 + adjoint_G_p_rz*forward_t62 + adjoint_L_rx_ry*forward_t115
            + adjoint_L_ry_rz*(forward_t87 + t62) - adjoint_M_p_ry_rz*forward_t178 + adjoint_d_2_y
            + adjoint_forward_t111*g_5_y - adjoint_forward_t160*forward_t154
            + adjoint_forward_t172*forward_t138 + adjoint_forward_t186*m_perp_2
            + adjoint_forward_t233*m_lift_2 + adjoint_forward_t92*mu_2;
        const lane adjoint_d_2_x =
            -B_2_y*adjoint_D_l_2_rz + B_2_z*adjoint_D_l_2_ry - D_l_1_rx*adjoint_minor_12_14
            - D_l_1_ry*adjoint_minor_12_15 - D_l_1_rz*adjoint_minor_12_16 + D_l_3_rx*adjoint_minor_23_14
            + D_l_3_ry*adjoint_minor_23_15 + D_l_3_rz*adjoint_minor_23_16 - adjoint_g_5_x*mu_2
            + adjoint_l_2*d_2_x*t483 - adjoint_minor_12_12*d_1_y - adjoint_minor_12_13*d_1_z
            + adjoint_minor_23_12*d_3_y + adjoint_minor_23_13*d_3_z
            + 2.0*eigenvalue*forward_t137*shape_13*shape_2 - g_x*t484;
        const lane adjoint_B_2_x =
            2.0*B_2_x*adjoint_forward_t129 - adjoint_D_l_2_ry*d_2_z + adjoint_D_l_2_rz*d_2_y
            + adjoint_G_p_ry*forward_t75 - adjoint_G_p_rz*forward_t69 + adjoint_L_rx_ry*forward_t92
            + adjoint_L_rx_rz*forward_t87 + adjoint_L_z_ry*mu_2 - adjoint_M_p_rx_ry*forward_t186
            - adjoint_M_p_rx_rz*forward_t178 + adjoint_d_2_x + (1.0/2.0)*adjoint_forward_t114
            + adjoint_forward_t134*g_5_x + adjoint_forward_t166*forward_t154
            - adjoint_forward_t172*forward_t148 + adjoint_forward_t198*m_perp_2
            + adjoint_forward_t234*m_lift_2;
        const lane t485 = forward_29*forward_t32*t130;
        const lane t486 = adjoint_l_1/forward_4;
        const lane adjoint_d_1_z =
            A_z_1*adjoint_det_D_l - B_1_x*adjoint_D_l_1_ry + B_1_y*adjoint_D_l_1_rx
            + D_l_2_rx*adjoint_minor_12_34 + D_l_2_ry*adjoint_minor_12_35 + D_l_2_rz*adjoint_minor_12_36
            + D_l_3_rx*adjoint_minor_13_34 + D_l_3_ry*adjoint_minor_13_35 + D_l_3_rz*adjoint_minor_13_36
            - adjoint_g_4_z*mu_1 + adjoint_minor_123_123*minor_23_12 - adjoint_minor_123_134*minor_23_14
            - adjoint_minor_123_135*minor_23_15 - adjoint_minor_123_136*minor_23_16
            - adjoint_minor_123_234*minor_23_24 - adjoint_minor_123_235*minor_23_25
            - adjoint_minor_123_236*minor_23_26 + adjoint_minor_123_345*minor_23_45
            + adjoint_minor_123_346*minor_23_46 + adjoint_minor_123_356*minor_23_56
            - adjoint_minor_12_13*d_2_x - adjoint_minor_12_23*d_2_y - adjoint_minor_13_13*d_3_x
            - adjoint_minor_13_23*d_3_y + d_1_z*t486 + forward_t135*t282 - t468*t485;
        const lane adjoint_B_1_z =
            2.0*B_1_z*adjoint_forward_t98 - adjoint_D_l_1_rx*d_1_y + adjoint_D_l_1_ry*d_1_x
            + adjoint_G_p_rx*forward_t68 - adjoint_G_p_ry*forward_t61 + adjoint_L_rx_rz*forward_t113
            + adjoint_d_1_z + adjoint_forward_t104*g_4_z + adjoint_forward_t159*forward_t147
            - adjoint_forward_t165*forward_t136 + adjoint_forward_t177*m_perp_1
            + adjoint_forward_t232*m_lift_1 + adjoint_forward_t86*mu_1 + g_4_y*t446;
        const lane adjoint_R_z_z =
            I_p_z*adjoint_M_p_rz_rz*forward_t29 + adjoint_B_1_z*b_1_z + adjoint_B_2_z*b_2_z
            + adjoint_B_3_z*b_3_z + adjoint_B_4_z*b_4_z + adjoint_B_5_z*b_5_z + adjoint_B_6_z*b_6_z
            + adjoint_M_p_rx_rz*t487 + adjoint_M_p_ry_rz*(t15 + t464) + adjoint_c_z*c_p_z
            + 2.0*adjoint_forward_t29 + adjoint_o_L_z*b_L_z;
        const lane adjoint_R_z_y =
            I_p_yz*adjoint_forward_t28 + adjoint_B_1_z*b_1_y + adjoint_B_2_z*b_2_y + adjoint_B_3_z*b_3_y
            + adjoint_B_4_z*b_4_y + adjoint_B_5_z*b_5_y + adjoint_B_6_z*b_6_y + adjoint_M_p_rx_rz*t488
            + adjoint_M_p_ry_rz*(forward_t22 + t14) + adjoint_M_p_rz_rz*(t16 + 2.0*t489) + adjoint_c_z*c_p_y
            + adjoint_o_L_z*b_L_y;
        const lane adjoint_R_z_x =
            I_p_x*R_z_x*t463 + I_p_xy*adjoint_forward_t26 + I_p_xz*adjoint_forward_t28 + adjoint_B_1_z*b_1_x
            + adjoint_B_2_z*b_2_x + adjoint_B_3_z*b_3_x + adjoint_B_4_z*b_4_x + adjoint_B_5_z*b_5_x
            + adjoint_B_6_z*b_6_x + adjoint_M_p_rx_rz*t490 + adjoint_M_p_ry_rz*t13 + adjoint_c_z*c_p_x
            + adjoint_o_L_z*b_L_x;
        const lane t491 = 2.0*t485;
        const lane adjoint_d_1_y =
            A_y_1*adjoint_det_D_l + B_1_x*adjoint_D_l_1_rz - B_1_z*adjoint_D_l_1_rx
            + D_l_2_rx*adjoint_minor_12_24 + D_l_2_ry*adjoint_minor_12_25 + D_l_2_rz*adjoint_minor_12_26
            + D_l_3_rx*adjoint_minor_13_24 + D_l_3_ry*adjoint_minor_13_25 + D_l_3_rz*adjoint_minor_13_26
            - adjoint_g_4_y*mu_1 - adjoint_minor_123_123*minor_23_13 - adjoint_minor_123_124*minor_23_14
            - adjoint_minor_123_125*minor_23_15 - adjoint_minor_123_126*minor_23_16
            + adjoint_minor_123_234*minor_23_34 + adjoint_minor_123_235*minor_23_35
            + adjoint_minor_123_236*minor_23_36 + adjoint_minor_123_245*minor_23_45
            + adjoint_minor_123_246*minor_23_46 + adjoint_minor_123_256*minor_23_56
            - adjoint_minor_12_12*d_2_x + adjoint_minor_12_23*d_2_z - adjoint_minor_13_12*d_3_x
            + adjoint_minor_13_23*d_3_z + d_1_y*t486 + forward_t135*t308 - g_y*t491;
        const lane adjoint_B_1_y =
            2.0*B_1_y*adjoint_forward_t105 + adjoint_D_l_1_rx*d_1_z - adjoint_D_l_1_rz*d_1_x
            - adjoint_G_p_rx*forward_t74 + adjoint_G_p_rz*forward_t61 + adjoint_L_rx_ry*forward_t113
            + adjoint_L_ry_rz*(forward_t86 + t76) - adjoint_M_p_ry_rz*forward_t177 + adjoint_d_1_y
            + adjoint_forward_t111*g_4_y - adjoint_forward_t159*forward_t153
            + adjoint_forward_t171*forward_t136 + adjoint_forward_t185*m_perp_1
            + adjoint_forward_t233*m_lift_1 + adjoint_forward_t97*mu_1;
        const lane adjoint_R_y_z =
            I_p_z*adjoint_M_p_ry_ry*forward_t24 + adjoint_B_1_y*b_1_z + adjoint_B_2_y*b_2_z
            + adjoint_B_3_y*b_3_z + adjoint_B_4_y*b_4_z + adjoint_B_5_y*b_5_z + adjoint_B_6_y*b_6_z
            + adjoint_M_p_rx_ry*t487 + adjoint_M_p_ry_rz*(I_p_z*R_z_z + t460) + adjoint_c_y*c_p_z
            + 2.0*adjoint_forward_t24 + adjoint_o_L_y*b_L_z;
        const lane adjoint_forward_t11 = -adjoint_R_y_z + adjoint_R_z_y;
        const lane adjoint_R_y_y =
            I_p_yz*adjoint_forward_t25 + adjoint_B_1_y*b_1_y + adjoint_B_2_y*b_2_y + adjoint_B_3_y*b_3_y
            + adjoint_B_4_y*b_4_y + adjoint_B_5_y*b_5_y + adjoint_B_6_y*b_6_y + adjoint_M_p_rx_ry*t488
            + adjoint_M_p_ry_ry*(2.0*t14 + t9) + adjoint_M_p_ry_rz*(forward_t26 + t489) + adjoint_c_y*c_p_y
            + adjoint_o_L_y*b_L_y;
        const lane t492 = R_z_x*adjoint_M_p_ry_rz;
        const lane adjoint_R_y_x =
            I_p_x*t492 + I_p_xy*adjoint_forward_t22 + I_p_xz*adjoint_forward_t25 + adjoint_B_1_y*b_1_x
            + adjoint_B_2_y*b_2_x + adjoint_B_3_y*b_3_x + adjoint_B_4_y*b_4_x + adjoint_B_5_y*b_5_x
            + adjoint_B_6_y*b_6_x + adjoint_M_p_rx_ry*t490 + adjoint_c_y*c_p_x + adjoint_o_L_y*b_L_x
            + t13*t465;
        const lane adjoint_d_1_x =
            A_x_1*adjoint_det_D_l - B_1_y*adjoint_D_l_1_rz + B_1_z*adjoint_D_l_1_ry
            + D_l_2_rx*adjoint_minor_12_14 + D_l_2_ry*adjoint_minor_12_15 + D_l_2_rz*adjoint_minor_12_16
            + D_l_3_rx*adjoint_minor_13_14 + D_l_3_ry*adjoint_minor_13_15 + D_l_3_rz*adjoint_minor_13_16
            - adjoint_g_4_x*mu_1 + adjoint_minor_123_123*minor_23_23 + adjoint_minor_123_124*minor_23_24
            + adjoint_minor_123_125*minor_23_25 + adjoint_minor_123_126*minor_23_26
            + adjoint_minor_123_134*minor_23_34 + adjoint_minor_123_135*minor_23_35
            + adjoint_minor_123_136*minor_23_36 + adjoint_minor_123_145*minor_23_45
            + adjoint_minor_123_146*minor_23_46 + adjoint_minor_123_156*minor_23_56
            + adjoint_minor_12_12*d_2_y + adjoint_minor_12_13*d_2_z + adjoint_minor_13_12*d_3_y
            + adjoint_minor_13_13*d_3_z + d_1_x*t486 + forward_t135*t334 - g_x*t491;
        const lane adjoint_B_1_x =
            2.0*B_1_x*adjoint_forward_t128 - adjoint_D_l_1_ry*d_1_z + adjoint_D_l_1_rz*d_1_y
            + adjoint_G_p_ry*forward_t74 - adjoint_G_p_rz*forward_t68 + adjoint_L_rx_ry*forward_t97
            + adjoint_L_rx_rz*forward_t86 + adjoint_L_z_ry*mu_1 - adjoint_M_p_rx_ry*forward_t185
            - adjoint_M_p_rx_rz*forward_t177 + adjoint_d_1_x + (1.0/2.0)*adjoint_forward_t112
            + adjoint_forward_t134*g_4_x + adjoint_forward_t165*forward_t153
            - adjoint_forward_t171*forward_t147 + adjoint_forward_t198*m_perp_1
            + adjoint_forward_t234*m_lift_1;
        const lane adjoint_R_x_z =
            I_p_xz*adjoint_forward_t18 + I_p_yz*adjoint_forward_t20 + I_p_z*adjoint_M_p_rx_rx*forward_t14
            + I_p_z*adjoint_forward_t21 + adjoint_B_1_x*b_1_z + adjoint_B_2_x*b_2_z + adjoint_B_3_x*b_3_z
            + adjoint_B_4_x*b_4_z + adjoint_B_5_x*b_5_z + adjoint_B_6_x*b_6_z + adjoint_c_x*c_p_z
            + 2.0*adjoint_forward_t14 + adjoint_o_L_x*b_L_z;
        const lane adjoint_forward_t10 = adjoint_R_x_z*rot_z + adjoint_R_y_x*rot_y;
        const lane adjoint_forward_t9 = adjoint_R_x_z - adjoint_R_z_x;
        const lane adjoint_R_x_y =
            I_p_xy*adjoint_forward_t18 + I_p_y*adjoint_forward_t20 + I_p_yz*adjoint_forward_t15
            + adjoint_B_1_x*b_1_y + adjoint_B_2_x*b_2_y + adjoint_B_3_x*b_3_y + adjoint_B_4_x*b_4_y
            + adjoint_B_5_x*b_5_y + adjoint_B_6_x*b_6_y + adjoint_M_p_rx_rx*(2.0*forward_t19 + t5)
            + adjoint_c_x*c_p_y + adjoint_o_L_x*b_L_y;
        const lane adjoint_forward_t8 = -adjoint_R_x_y + adjoint_R_y_x;
        const lane adjoint_forward_t7 =
            adjoint_forward_t11*rot_x + adjoint_forward_t8*rot_z + adjoint_forward_t9*rot_y;
        const lane adjoint_c_half = adjoint_forward_t7*s_half;
        const lane adjoint_R_x_x =
            I_p_x*adjoint_forward_t18 + I_p_xy*adjoint_forward_t12 + I_p_xz*adjoint_forward_t15
            + adjoint_B_1_x*b_1_x + adjoint_B_2_x*b_2_x + adjoint_B_3_x*b_3_x + adjoint_B_4_x*b_4_x
            + adjoint_B_5_x*b_5_x + adjoint_B_6_x*b_6_x + adjoint_c_x*c_p_x + adjoint_o_L_x*b_L_x
            + forward_t16*t467;
        const lane adjoint_forward_t6 =
            -adjoint_R_x_x*forward_t4 + adjoint_R_y_y*t2 + adjoint_R_z_y*t3 + adjoint_R_z_z*t4
            + adjoint_forward_t10*rot_x;
        const lane t494 = adjoint_R_x_y*rot_y;
        const lane t495 = adjoint_R_z_x*rot_z;
        const lane adjoint_forward_t5 =
            (1.0/2.0)*adjoint_R_y_z*t3 + (1.0/2.0)*adjoint_forward_t6 + t493*t494 + t493*t495;
        const lane adjoint_s_half = 2.0*adjoint_forward_t5*s_half + adjoint_forward_t7*forward_3;
        const lane adjoint_forward_2 = adjoint_s_half*forward_1;
        const lane adjoint_forward_1 = adjoint_s_half*forward_2;
        const lane adjoint_half_angle =
            -adjoint_c_half*forward_2 - adjoint_forward_1*(forward_1*forward_1) + adjoint_forward_2*forward_3;
        const lane adjoint_forward_0 = (1.0/2.0)*adjoint_half_angle;
        const lane t496 = -1.0/2.0*adjoint_forward_0/forward_0;
        const lane adjoint_forward_t4 = -adjoint_R_x_x*forward_t6 - t496;
        const lane t497 = adjoint_R_y_y*forward_t6;
        const lane adjoint_forward_t3 = adjoint_forward_t4 - t497;
        const lane t498 = adjoint_R_z_z*forward_t6;
        const lane adjoint_forward_t2 = adjoint_forward_t4 - t498;
        const lane adjoint_forward_t1 = -t496 - t497 - t498;
        const lane t499 = adjoint_G_p_rx*g_y;
        const lane t500 = adjoint_G_p_rz*g_x;
        const lane t501 = adjoint_forward_t171*forward_t135;
        const lane t502 = adjoint_forward_t172*forward_t137;
        const lane t503 = adjoint_forward_t173*forward_t139;
        const lane t504 = adjoint_forward_t174*forward_t141;
        const lane t505 = adjoint_forward_t175*forward_t143;
        const lane t506 = adjoint_forward_t176*forward_t145;
        const lane t513 = adjoint_m_perp_1*forward_10;
        const lane t514 = adjoint_m_perp_2*forward_12;
        const lane t515 = adjoint_m_perp_3*forward_14;
        const lane t516 = adjoint_m_perp_4*forward_16;
        const lane t517 = adjoint_m_perp_5*forward_18;
        const lane t518 = adjoint_m_perp_6*forward_20;
        const lane t519 = adjoint_R_z_y*forward_t6;
        const lane t520 = adjoint_R_y_z*forward_t6;
        lanes_clear(gradient, 140);
        gradient[0] =
            LANES(adjoint_M_p_y_rz*c_x + adjoint_forward_t183*c_z + adjoint_forward_t191*c_y
            + (1.0/2.0)*adjoint_forward_t204 + adjoint_forward_t67 + adjoint_forward_t80*g_z
            + adjoint_forward_t82*g_x + adjoint_forward_t84*g_y + c_y*t500 + c_z*t499);
        gradient[1] = LANES(R_x_x*adjoint_c_x + R_y_x*adjoint_c_y + R_z_x*adjoint_c_z);
        gradient[2] = LANES(R_x_y*adjoint_c_x + R_y_y*adjoint_c_y + R_z_y*adjoint_c_z);
        gradient[3] = LANES(R_x_z*adjoint_c_x + R_y_z*adjoint_c_y + R_z_z*adjoint_c_z);
        gradient[4] =
            LANES(R_x_x*adjoint_forward_t18 + R_y_x*t492 + adjoint_M_p_rx_rx*t6 + adjoint_M_p_ry_ry*t10
            + adjoint_M_p_rz_rz*t17);
        gradient[5] =
            LANES(R_x_y*adjoint_forward_t20 + R_z_y*t462 + adjoint_M_p_rx_rx*t7 + adjoint_M_p_ry_ry*t11
            + adjoint_M_p_rz_rz*t18);
        gradient[6] =
            LANES(R_x_z*adjoint_forward_t21 + R_z_z*t461 + adjoint_M_p_rx_rx*t8 + adjoint_M_p_ry_ry*t12
            + adjoint_M_p_rz_rz*t19);
        gradient[7] =
            LANES(R_x_x*adjoint_forward_t12 + R_x_y*adjoint_forward_t18 + R_y_x*adjoint_forward_t22
            + R_z_x*adjoint_forward_t26);
        gradient[8] =
            LANES(R_x_x*adjoint_forward_t15 + R_x_z*adjoint_forward_t18 + R_y_x*adjoint_forward_t25
            + R_z_x*adjoint_forward_t28);
        gradient[9] =
            LANES(R_x_y*adjoint_forward_t15 + R_x_z*adjoint_forward_t20 + R_y_y*adjoint_forward_t25
            + R_z_y*adjoint_forward_t28);
        gradient[10] =
            LANES(B_1_y*t501 + B_2_y*t502 + B_3_y*t503 + B_4_y*t504 + B_5_y*t505 + B_6_y*t506
            + adjoint_G_p_rz*(B_1_y*m_lift_1 + B_2_y*m_lift_2 + B_3_y*m_lift_3 + B_4_y*m_lift_4
            + B_5_y*m_lift_5 + B_6_y*m_lift_6 + forward_t191 + forward_t192) - adjoint_G_p_x*forward_t67
            + adjoint_forward_t136*forward_t135 + adjoint_forward_t138*forward_t137
            + adjoint_forward_t140*forward_t139 + adjoint_forward_t142*forward_t141
            + adjoint_forward_t144*forward_t143 + adjoint_forward_t146*forward_t145
            - adjoint_forward_t165*t507 - adjoint_forward_t166*t508 - adjoint_forward_t167*t509
            - adjoint_forward_t168*t510 - adjoint_forward_t169*t511 - adjoint_forward_t170*t512
            + adjoint_forward_t61*m_lift_1 + adjoint_forward_t62*m_lift_2 + adjoint_forward_t63*m_lift_3
            + adjoint_forward_t64*m_lift_4 + adjoint_forward_t65*m_lift_5 + adjoint_forward_t66*m_lift_6
            + adjoint_forward_t82*m_p + adjoint_forward_t83*m_L - d_1_x*t491 - d_2_x*t484 - d_3_x*t481
            - d_4_x*t477 - d_5_x*t474 - d_6_x*t471);
        gradient[11] =
            LANES(-B_1_x*t501 - B_2_x*t502 - B_3_x*t503 - B_4_x*t504 - B_5_x*t505 - B_6_x*t506
            + adjoint_G_p_rx*(B_1_z*m_lift_1 + B_2_z*m_lift_2 + B_3_z*m_lift_3 + B_4_z*m_lift_4
            + B_5_z*m_lift_5 + B_6_z*m_lift_6 + forward_t183 + forward_t184) - adjoint_G_p_y*forward_t67
            + adjoint_forward_t147*forward_t135 + adjoint_forward_t148*forward_t137
            + adjoint_forward_t149*forward_t139 + adjoint_forward_t150*forward_t141
            + adjoint_forward_t151*forward_t143 + adjoint_forward_t152*forward_t145
            + adjoint_forward_t159*t507 + adjoint_forward_t160*t508 + adjoint_forward_t161*t509
            + adjoint_forward_t162*t510 + adjoint_forward_t163*t511 + adjoint_forward_t164*t512
            + adjoint_forward_t68*m_lift_1 + adjoint_forward_t69*m_lift_2 + adjoint_forward_t70*m_lift_3
            + adjoint_forward_t71*m_lift_4 + adjoint_forward_t72*m_lift_5 + adjoint_forward_t73*m_lift_6
            + adjoint_forward_t84*m_p + adjoint_forward_t85*m_L - d_1_y*t491 - d_2_y*t484 - d_3_y*t481
            - d_4_y*t477 - d_5_y*t474 - d_6_y*t471);
        gradient[12] =
            LANES(B_1_x*adjoint_forward_t165*forward_t135 - B_1_y*adjoint_forward_t159*forward_t135
            + B_2_x*adjoint_forward_t166*forward_t137 - B_2_y*adjoint_forward_t160*forward_t137
            + B_3_x*adjoint_forward_t167*forward_t139 - B_3_y*adjoint_forward_t161*forward_t139
            + B_4_x*adjoint_forward_t168*forward_t141 - B_4_y*adjoint_forward_t162*forward_t141
            + B_5_x*adjoint_forward_t169*forward_t143 - B_5_y*adjoint_forward_t163*forward_t143
            + B_6_x*adjoint_forward_t170*forward_t145 - B_6_y*adjoint_forward_t164*forward_t145
            - adjoint_G_p_z*forward_t67 + adjoint_forward_t153*forward_t135
            + adjoint_forward_t154*forward_t137 + adjoint_forward_t155*forward_t139
            + adjoint_forward_t156*forward_t141 + adjoint_forward_t157*forward_t143
            + adjoint_forward_t158*forward_t145 + adjoint_forward_t74*m_lift_1 + adjoint_forward_t75*m_lift_2
            + adjoint_forward_t76*m_lift_3 + adjoint_forward_t77*m_lift_4 + adjoint_forward_t78*m_lift_5
            + adjoint_forward_t79*m_lift_6 + adjoint_forward_t80*m_p + adjoint_forward_t81*m_L - d_1_z*t491
            - d_2_z*t484 - d_3_z*t481 - d_4_z*t477 - d_5_z*t474 - d_6_z*t471);
        gradient[13] = LANES(-adjoint_d_1_x);
        gradient[14] = LANES(-adjoint_d_1_y);
        gradient[15] = LANES(-adjoint_d_1_z);
        gradient[16] = LANES(-adjoint_d_2_x);
        gradient[17] = LANES(-adjoint_d_2_y);
        gradient[18] = LANES(-adjoint_d_2_z);
        gradient[19] = LANES(-adjoint_d_3_x);
        gradient[20] = LANES(-adjoint_d_3_y);
        gradient[21] = LANES(-adjoint_d_3_z);
        gradient[22] = LANES(-adjoint_d_4_x);
        gradient[23] = LANES(-adjoint_d_4_y);
        gradient[24] = LANES(-adjoint_d_4_z);
        gradient[25] = LANES(-adjoint_d_5_x);
        gradient[26] = LANES(-adjoint_d_5_y);
        gradient[27] = LANES(-adjoint_d_5_z);
        gradient[28] = LANES(-adjoint_d_6_x);
        gradient[29] = LANES(-adjoint_d_6_y);
        gradient[30] = LANES(-adjoint_d_6_z);
        gradient[31] = LANES(R_x_x*adjoint_B_1_x + R_y_x*adjoint_B_1_y + R_z_x*adjoint_B_1_z);
        gradient[32] = LANES(R_x_y*adjoint_B_1_x + R_y_y*adjoint_B_1_y + R_z_y*adjoint_B_1_z);
        gradient[33] = LANES(R_x_z*adjoint_B_1_x + R_y_z*adjoint_B_1_y + R_z_z*adjoint_B_1_z);
        gradient[34] = LANES(R_x_x*adjoint_B_2_x + R_y_x*adjoint_B_2_y + R_z_x*adjoint_B_2_z);
        gradient[35] = LANES(R_x_y*adjoint_B_2_x + R_y_y*adjoint_B_2_y + R_z_y*adjoint_B_2_z);
        gradient[36] = LANES(R_x_z*adjoint_B_2_x + R_y_z*adjoint_B_2_y + R_z_z*adjoint_B_2_z);
        gradient[37] = LANES(R_x_x*adjoint_B_3_x + R_y_x*adjoint_B_3_y + R_z_x*adjoint_B_3_z);
        gradient[38] = LANES(R_x_y*adjoint_B_3_x + R_y_y*adjoint_B_3_y + R_z_y*adjoint_B_3_z);
        gradient[39] = LANES(R_x_z*adjoint_B_3_x + R_y_z*adjoint_B_3_y + R_z_z*adjoint_B_3_z);
        gradient[40] = LANES(R_x_x*adjoint_B_4_x + R_y_x*adjoint_B_4_y + R_z_x*adjoint_B_4_z);
        gradient[41] = LANES(R_x_y*adjoint_B_4_x + R_y_y*adjoint_B_4_y + R_z_y*adjoint_B_4_z);
        gradient[42] = LANES(R_x_z*adjoint_B_4_x + R_y_z*adjoint_B_4_y + R_z_z*adjoint_B_4_z);
        gradient[43] = LANES(R_x_x*adjoint_B_5_x + R_y_x*adjoint_B_5_y + R_z_x*adjoint_B_5_z);
        gradient[44] = LANES(R_x_y*adjoint_B_5_x + R_y_y*adjoint_B_5_y + R_z_y*adjoint_B_5_z);
        gradient[45] = LANES(R_x_z*adjoint_B_5_x + R_y_z*adjoint_B_5_y + R_z_z*adjoint_B_5_z);
        gradient[46] = LANES(R_x_x*adjoint_B_6_x + R_y_x*adjoint_B_6_y + R_z_x*adjoint_B_6_z);
        gradient[47] = LANES(R_x_y*adjoint_B_6_x + R_y_y*adjoint_B_6_y + R_z_y*adjoint_B_6_z);
        gradient[48] = LANES(R_x_z*adjoint_B_6_x + R_y_z*adjoint_B_6_y + R_z_z*adjoint_B_6_z);
        gradient[61] = LANES(adjoint_k_1*(a_S_1 + 1.0));
        gradient[62] = LANES(adjoint_k_2*(a_S_2 + 1.0));
        gradient[63] = LANES(adjoint_k_3*(a_S_3 + 1.0));
        gradient[64] = LANES(adjoint_k_4*(a_S_4 + 1.0));
        gradient[65] = LANES(adjoint_k_5*(a_S_5 + 1.0));
        gradient[66] = LANES(adjoint_k_6*(a_S_6 + 1.0));
        gradient[67] = LANES(adjoint_forward_t235 + adjoint_forward_t32*c_b_1 + t20*t513);
        gradient[68] = LANES(adjoint_forward_t235 + adjoint_forward_t36*c_b_2 + t26*t514);
        gradient[69] = LANES(adjoint_forward_t235 + adjoint_forward_t40*c_b_3 + t32*t515);
        gradient[70] = LANES(adjoint_forward_t235 + adjoint_forward_t44*c_b_4 + t38*t516);
        gradient[71] = LANES(adjoint_forward_t235 + adjoint_forward_t48*c_b_5 + t44*t517);
        gradient[72] = LANES(adjoint_forward_t235 + adjoint_forward_t52*c_b_6 + t50*t518);
        gradient[73] = LANES(adjoint_forward_t32*m_b_1 + 2.0*t24*t513);
        gradient[74] = LANES(adjoint_forward_t36*m_b_2 + 2.0*t30*t514);
        gradient[75] = LANES(adjoint_forward_t40*m_b_3 + 2.0*t36*t515);
        gradient[76] = LANES(adjoint_forward_t44*m_b_4 + 2.0*t42*t516);
        gradient[77] = LANES(adjoint_forward_t48*m_b_5 + 2.0*t48*t517);
        gradient[78] = LANES(adjoint_forward_t52*m_b_6 + 2.0*t518*t54);
        gradient[79] = LANES(t513);
        gradient[80] = LANES(t514);
        gradient[81] = LANES(t515);
        gradient[82] = LANES(t516);
        gradient[83] = LANES(t517);
        gradient[84] = LANES(t518);
        gradient[85] = LANES(-adjoint_forward_t32*c_r_1 + adjoint_m_perp_1*t23 - t411 + t458);
        gradient[86] = LANES(-adjoint_forward_t36*c_r_2 + adjoint_m_perp_2*t29 - t409 + t456);
        gradient[87] = LANES(-adjoint_forward_t40*c_r_3 + adjoint_m_perp_3*t35 - t407 + t454);
        gradient[88] = LANES(-adjoint_forward_t44*c_r_4 + adjoint_m_perp_4*t41 - t405 + t452);
        gradient[89] = LANES(-adjoint_forward_t48*c_r_5 + adjoint_m_perp_5*t47 - t403 + t450);
        gradient[90] = LANES(-adjoint_forward_t52*c_r_6 + adjoint_m_perp_6*t53 - t401 + t447);
        gradient[91] = LANES(-adjoint_forward_t32*m_r_1 - forward_11*m_r_1*t459);
        gradient[92] = LANES(-adjoint_forward_t36*m_r_2 - forward_13*m_r_2*t457);
        gradient[93] = LANES(-adjoint_forward_t40*m_r_3 - forward_15*m_r_3*t455);
        gradient[94] = LANES(-adjoint_forward_t44*m_r_4 - forward_17*m_r_4*t453);
        gradient[95] = LANES(-adjoint_forward_t48*m_r_5 - forward_19*m_r_5*t451);
        gradient[96] = LANES(-adjoint_forward_t52*m_r_6 - forward_21*m_r_6*t449);
        gradient[97] = LANES(t513);
        gradient[98] = LANES(t514);
        gradient[99] = LANES(t515);
        gradient[100] = LANES(t516);
        gradient[101] = LANES(t517);
        gradient[102] = LANES(t518);
        gradient[103] = LANES(-forward_23*t143);
        gradient[104] = LANES(-forward_24*t141);
        gradient[105] = LANES(-forward_25*t139);
        gradient[106] = LANES(-forward_26*t137);
        gradient[107] = LANES(-forward_27*t135);
        gradient[108] = LANES(-forward_28*t133);
        gradient[109] = LANES(-2.0*adjoint_forward_23/(h_m_1*h_m_1*h_m_1));
        gradient[110] = LANES(-2.0*adjoint_forward_24/(h_m_2*h_m_2*h_m_2));
        gradient[111] = LANES(-2.0*adjoint_forward_25/(h_m_3*h_m_3*h_m_3));
        gradient[112] = LANES(-2.0*adjoint_forward_26/(h_m_4*h_m_4*h_m_4));
        gradient[113] = LANES(-2.0*adjoint_forward_27/(h_m_5*h_m_5*h_m_5));
        gradient[114] = LANES(-2.0*adjoint_forward_28/(h_m_6*h_m_6*h_m_6));
        gradient[115] = LANES(adjoint_k_1*k_l_1);
        gradient[116] = LANES(adjoint_k_2*k_l_2);
        gradient[117] = LANES(adjoint_k_3*k_l_3);
        gradient[118] = LANES(adjoint_k_4*k_l_4);
        gradient[119] = LANES(adjoint_k_5*k_l_5);
        gradient[120] = LANES(adjoint_k_6*k_l_6);
        gradient[121] =
            LANES(D_p_x_1*adjoint_forward_t236 + D_p_x_2*adjoint_forward_t239 + D_p_x_3*adjoint_forward_t242
            + D_p_x_4*adjoint_forward_t245 + D_p_x_5*adjoint_forward_t248 + D_p_y_1*adjoint_forward_t237
            + D_p_y_2*adjoint_forward_t240 + D_p_y_3*adjoint_forward_t243 + D_p_y_4*adjoint_forward_t246
            + D_p_y_5*adjoint_forward_t249 + D_p_z_1*adjoint_forward_t238 + D_p_z_2*adjoint_forward_t241
            + D_p_z_3*adjoint_forward_t244 + D_p_z_4*adjoint_forward_t247 + D_p_z_5*adjoint_forward_t250
            + t120*((D_p_x_6*D_p_x_6) + (D_p_y_6*D_p_y_6) + (D_p_z_6*D_p_z_6)) + t122*((D_p_x_5*D_p_x_5)
            + (D_p_y_5*D_p_y_5) + (D_p_z_5*D_p_z_5)) + t124*((D_p_x_4*D_p_x_4) + (D_p_y_4*D_p_y_4)
            + (D_p_z_4*D_p_z_4)) + t126*((D_p_x_3*D_p_x_3) + (D_p_y_3*D_p_y_3) + (D_p_z_3*D_p_z_3))
            + t128*((D_p_x_2*D_p_x_2) + (D_p_y_2*D_p_y_2) + (D_p_z_2*D_p_z_2)) + t130*((D_p_x_1*D_p_x_1)
            + (D_p_y_1*D_p_y_1) + (D_p_z_1*D_p_z_1)) + t194 + t196 + t198 + t287 + t313 + t339);
        gradient[123] = LANES(-t133 - t135 - t137 - t139 - t141 - t143);
        gradient[124] =
            LANES(adjoint_M_p_y_rz*o_L_x + adjoint_forward_t184*o_L_z + adjoint_forward_t192*o_L_y
            + (1.0/2.0)*adjoint_forward_t201 + adjoint_forward_t67 + adjoint_forward_t81*g_z
            + adjoint_forward_t83*g_x + adjoint_forward_t85*g_y + o_L_y*t500 + o_L_z*t499);
        gradient[125] = LANES(R_x_x*adjoint_o_L_x + R_y_x*adjoint_o_L_y + R_z_x*adjoint_o_L_z);
        gradient[126] = LANES(R_x_y*adjoint_o_L_x + R_y_y*adjoint_o_L_y + R_z_y*adjoint_o_L_z);
        gradient[127] = LANES(R_x_z*adjoint_o_L_x + R_y_z*adjoint_o_L_y + R_z_z*adjoint_o_L_z);
        gradient[128] = LANES(t132 + t134 + t136 + t138 + t140 + t142);
        gradient[130] = LANES(adjoint_forward_t235);
        gradient[134] =
            LANES(adjoint_d_1_x + adjoint_d_2_x + adjoint_d_3_x + adjoint_d_4_x + adjoint_d_5_x
            + adjoint_d_6_x);
        gradient[135] =
            LANES(adjoint_d_1_y + adjoint_d_2_y + adjoint_d_3_y + adjoint_d_4_y + adjoint_d_5_y
            + adjoint_d_6_y);
        gradient[136] =
            LANES(adjoint_d_1_z + adjoint_d_2_z + adjoint_d_3_z + adjoint_d_4_z + adjoint_d_5_z
            + adjoint_d_6_z);
        gradient[137] =
            LANES(2.0*adjoint_forward_t1*rot_x + adjoint_forward_t10*forward_t6
            + adjoint_forward_t11*forward_t7 + forward_t6*t494 + forward_t6*t495);
        gradient[138] =
            LANES(adjoint_R_x_y*t1 + adjoint_R_y_x*forward_t10 + 2.0*adjoint_forward_t2*rot_y
            + adjoint_forward_t9*forward_t7 + rot_z*t519 + rot_z*t520);
        gradient[139] =
            LANES(adjoint_R_x_z*forward_t10 + adjoint_R_z_x*t1 + 2.0*adjoint_forward_t3*rot_z
            + adjoint_forward_t8*forward_t7 + rot_y*t519 + rot_y*t520);
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
 * 12271 operations; 218584316598 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_tangent(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int count,
    const struct lanes_paths *paths)
{
    (void)effects;
    const lane p_x = pose[0];
    const lane p_y = pose[1];
    const lane p_z = pose[2];
    const lane rot_x = pose[3];
    const lane rot_y = pose[4];
    const lane rot_z = pose[5];
    const double m_p = parameters[0];
    const double c_p_x = parameters[1];
    const double c_p_y = parameters[2];
    const double c_p_z = parameters[3];
    const double I_p_x = parameters[4];
    const double I_p_y = parameters[5];
    const double I_p_z = parameters[6];
    const double I_p_xy = parameters[7];
    const double I_p_xz = parameters[8];
    const double I_p_yz = parameters[9];
    const double g_x = parameters[10];
    const double g_y = parameters[11];
    const double g_z = parameters[12];
    const double a_1_x = parameters[13];
    const double a_1_y = parameters[14];
    const double a_1_z = parameters[15];
    const double a_2_x = parameters[16];
    const double a_2_y = parameters[17];
    const double a_2_z = parameters[18];
    const double a_3_x = parameters[19];
    const double a_3_y = parameters[20];
    const double a_3_z = parameters[21];
    const double a_4_x = parameters[22];
    const double a_4_y = parameters[23];
    const double a_4_z = parameters[24];
    const double a_5_x = parameters[25];
    const double a_5_y = parameters[26];
    const double a_5_z = parameters[27];
    const double a_6_x = parameters[28];
    const double a_6_y = parameters[29];
    const double a_6_z = parameters[30];
    const double b_1_x = parameters[31];
    const double b_1_y = parameters[32];
    const double b_1_z = parameters[33];
    const double b_2_x = parameters[34];
    const double b_2_y = parameters[35];
    const double b_2_z = parameters[36];
    const double b_3_x = parameters[37];
    const double b_3_y = parameters[38];
    const double b_3_z = parameters[39];
    const double b_4_x = parameters[40];
    const double b_4_y = parameters[41];
    const double b_4_z = parameters[42];
    const double b_5_x = parameters[43];
    const double b_5_y = parameters[44];
    const double b_5_z = parameters[45];
    const double b_6_x = parameters[46];
    const double b_6_y = parameters[47];
    const double b_6_z = parameters[48];
    const double k_l_1 = parameters[61];
    const double k_l_2 = parameters[62];
    const double k_l_3 = parameters[63];
    const double k_l_4 = parameters[64];
    const double k_l_5 = parameters[65];
    const double k_l_6 = parameters[66];
    const double m_b_1 = parameters[67];
    const double m_b_2 = parameters[68];
    const double m_b_3 = parameters[69];
    const double m_b_4 = parameters[70];
    const double m_b_5 = parameters[71];
    const double m_b_6 = parameters[72];
    const double c_b_1 = parameters[73];
    const double c_b_2 = parameters[74];
    const double c_b_3 = parameters[75];
    const double c_b_4 = parameters[76];
    const double c_b_5 = parameters[77];
    const double c_b_6 = parameters[78];
    const double I_b_1 = parameters[79];
    const double I_b_2 = parameters[80];
    const double I_b_3 = parameters[81];
    const double I_b_4 = parameters[82];
    const double I_b_5 = parameters[83];
    const double I_b_6 = parameters[84];
    const double m_r_1 = parameters[85];
    const double m_r_2 = parameters[86];
    const double m_r_3 = parameters[87];
    const double m_r_4 = parameters[88];
    const double m_r_5 = parameters[89];
    const double m_r_6 = parameters[90];
    const double c_r_1 = parameters[91];
    const double c_r_2 = parameters[92];
    const double c_r_3 = parameters[93];
    const double c_r_4 = parameters[94];
    const double c_r_5 = parameters[95];
    const double c_r_6 = parameters[96];
    const double I_r_1 = parameters[97];
    const double I_r_2 = parameters[98];
    const double I_r_3 = parameters[99];
    const double I_r_4 = parameters[100];
    const double I_r_5 = parameters[101];
    const double I_r_6 = parameters[102];
    const double I_m_1 = parameters[103];
    const double I_m_2 = parameters[104];
    const double I_m_3 = parameters[105];
    const double I_m_4 = parameters[106];
    const double I_m_5 = parameters[107];
    const double I_m_6 = parameters[108];
    const double h_m_1 = parameters[109];
    const double h_m_2 = parameters[110];
    const double h_m_3 = parameters[111];
    const double h_m_4 = parameters[112];
    const double h_m_5 = parameters[113];
    const double h_m_6 = parameters[114];
    const double a_S_1 = effects[0];
    const double a_S_2 = effects[1];
    const double a_S_3 = effects[2];
    const double a_S_4 = effects[3];
    const double a_S_5 = effects[4];
    const double a_S_6 = effects[5];
    const double k_C = effects[6];
    const double m_L = effects[9];
    const double b_L_x = effects[10];
    const double b_L_y = effects[11];
    const double b_L_z = effects[12];
    const lane forward_t1 = (rot_x*rot_x);
    const lane forward_t2 = (rot_y*rot_y);
    const lane forward_t3 = (rot_z*rot_z);
    const lane forward_t4 = forward_t2 + forward_t3;
    const lane forward_0 = lanes_sqrt(forward_t1 + forward_t4 + 1e-30);
    const lane half_angle = (1.0/2.0)*forward_0;
    const lane forward_1 = 1.0/half_angle;
    const lane forward_2 = lanes_sin(half_angle);
    const lane s_half = forward_1*forward_2;
    const lane forward_t5 = (s_half*s_half);
    const lane forward_t6 = (1.0/2.0)*forward_t5;
    const lane R_x_x = -forward_t4*forward_t6 + 1.0;
    const lane forward_3 = lanes_cos(half_angle);
    const lane forward_t7 = forward_3*s_half;
    const lane forward_t8 = forward_t7*rot_z;
    const lane t1 = forward_t6*rot_x;
    const lane R_x_y = -forward_t8 + rot_y*t1;
    const lane forward_t9 = forward_t7*rot_y;
    const lane forward_t10 = forward_t6*rot_x;
    const lane R_x_z = forward_t10*rot_z + forward_t9;
    const lane B_1_x = R_x_x*b_1_x + R_x_y*b_1_y + R_x_z*b_1_z;
    const lane d_1_x = B_1_x - a_1_x + p_x;
    const lane R_y_x = forward_t10*rot_y + forward_t8;
    const lane t2 = -forward_t1 - forward_t3;
    const lane R_y_y = forward_t6*t2 + 1.0;
    const lane forward_t11 = forward_t7*rot_x;
    const lane R_y_z = -forward_t11 + (1.0/2.0)*forward_t5*rot_y*rot_z;
    const lane B_1_y = R_y_x*b_1_x + R_y_y*b_1_y + R_y_z*b_1_z;
    const lane d_1_y = B_1_y - a_1_y + p_y;
    const lane R_z_x = -forward_t9 + rot_z*t1;
    const lane t3 = forward_t6*rot_z;
    const lane R_z_y = forward_t11 + rot_y*t3;
    const lane t4 = -forward_t1 - forward_t2;
    const lane R_z_z = forward_t6*t4 + 1.0;
    const lane B_1_z = R_z_x*b_1_x + R_z_y*b_1_y + R_z_z*b_1_z;
    const lane d_1_z = B_1_z - a_1_z + p_z;
    const lane B_2_x = R_x_x*b_2_x + R_x_y*b_2_y + R_x_z*b_2_z;
    const lane d_2_x = B_2_x - a_2_x + p_x;
    const lane B_2_y = R_y_x*b_2_x + R_y_y*b_2_y + R_y_z*b_2_z;
    const lane d_2_y = B_2_y - a_2_y + p_y;
    const lane B_2_z = R_z_x*b_2_x + R_z_y*b_2_y + R_z_z*b_2_z;
    const lane d_2_z = B_2_z - a_2_z + p_z;
    const lane B_3_x = R_x_x*b_3_x + R_x_y*b_3_y + R_x_z*b_3_z;
    const lane d_3_x = B_3_x - a_3_x + p_x;
    const lane B_3_y = R_y_x*b_3_x + R_y_y*b_3_y + R_y_z*b_3_z;
    const lane d_3_y = B_3_y - a_3_y + p_y;
    const lane B_3_z = R_z_x*b_3_x + R_z_y*b_3_y + R_z_z*b_3_z;
    const lane d_3_z = B_3_z - a_3_z + p_z;
    const lane B_4_x = R_x_x*b_4_x + R_x_y*b_4_y + R_x_z*b_4_z;
    const lane d_4_x = B_4_x - a_4_x + p_x;
    const lane B_4_y = R_y_x*b_4_x + R_y_y*b_4_y + R_y_z*b_4_z;
    const lane d_4_y = B_4_y - a_4_y + p_y;
    const lane B_4_z = R_z_x*b_4_x + R_z_y*b_4_y + R_z_z*b_4_z;
    const lane d_4_z = B_4_z - a_4_z + p_z;
    const lane B_5_x = R_x_x*b_5_x + R_x_y*b_5_y + R_x_z*b_5_z;
    const lane d_5_x = B_5_x - a_5_x + p_x;
    const lane B_5_y = R_y_x*b_5_x + R_y_y*b_5_y + R_y_z*b_5_z;
    const lane d_5_y = B_5_y - a_5_y + p_y;
    const lane B_5_z = R_z_x*b_5_x + R_z_y*b_5_y + R_z_z*b_5_z;
    const lane d_5_z = B_5_z - a_5_z + p_z;
    const lane B_6_x = R_x_x*b_6_x + R_x_y*b_6_y + R_x_z*b_6_z;
    const lane d_6_x = B_6_x - a_6_x + p_x;
    const lane B_6_y = R_y_x*b_6_x + R_y_y*b_6_y + R_y_z*b_6_z;
    const lane d_6_y = B_6_y - a_6_y + p_y;
    const lane B_6_z = R_z_x*b_6_x + R_z_y*b_6_y + R_z_z*b_6_z;
    const lane d_6_z = B_6_z - a_6_z + p_z;
    const lane forward_4 = lanes_sqrt((d_1_x*d_1_x) + (d_1_y*d_1_y) + (d_1_z*d_1_z));
    const lane forward_5 = lanes_sqrt((d_2_x*d_2_x) + (d_2_y*d_2_y) + (d_2_z*d_2_z));
    const lane forward_6 = lanes_sqrt((d_3_x*d_3_x) + (d_3_y*d_3_y) + (d_3_z*d_3_z));
    const lane forward_7 = lanes_sqrt((d_4_x*d_4_x) + (d_4_y*d_4_y) + (d_4_z*d_4_z));
    const lane forward_8 = lanes_sqrt((d_5_x*d_5_x) + (d_5_y*d_5_y) + (d_5_z*d_5_z));
    const lane forward_9 = lanes_sqrt((d_6_x*d_6_x) + (d_6_y*d_6_y) + (d_6_z*d_6_z));
    const lane c_x = R_x_x*c_p_x + R_x_y*c_p_y + R_x_z*c_p_z;
    const lane c_y = R_y_x*c_p_x + R_y_y*c_p_y + R_y_z*c_p_z;
    const lane c_z = R_z_x*c_p_x + R_z_y*c_p_y + R_z_z*c_p_z;
    const lane forward_t12 = I_p_xy*R_x_x;
    const lane forward_t13 = I_p_xz*R_x_x;
    const lane forward_t14 = 2.0*R_x_z;
    const lane forward_t15 = I_p_yz*R_x_y;
    const lane t5 = 2.0*forward_t12;
    const lane t6 = (R_x_x*R_x_x);
    const lane t7 = (R_x_y*R_x_y);
    const lane t8 = (R_x_z*R_x_z);
    const lane J_x_x =
        I_p_x*t6 + I_p_y*t7 + I_p_z*t8 + R_x_y*t5 + forward_t13*forward_t14 + forward_t14*forward_t15;
    const lane forward_t16 = I_p_x*R_x_x;
    const lane forward_t17 = I_p_xy*R_x_y;
    const lane forward_t18 = I_p_xz*R_x_z;
    const lane forward_t19 = I_p_y*R_x_y;
    const lane forward_t20 = I_p_yz*R_x_z;
    const lane forward_t21 = I_p_z*R_x_z;
    const lane J_x_y =
        R_y_x*forward_t16 + R_y_x*forward_t17 + R_y_x*forward_t18 + R_y_y*forward_t12 + R_y_y*forward_t19
        + R_y_y*forward_t20 + R_y_z*forward_t13 + R_y_z*forward_t15 + R_y_z*forward_t21;
    const lane J_x_z =
        R_z_x*forward_t16 + R_z_x*forward_t17 + R_z_x*forward_t18 + R_z_y*forward_t12 + R_z_y*forward_t19
        + R_z_y*forward_t20 + R_z_z*forward_t13 + R_z_z*forward_t15 + R_z_z*forward_t21;
    const lane forward_t22 = I_p_xy*R_y_x;
    const lane forward_t23 = I_p_xz*R_y_x;
    const lane forward_t24 = 2.0*R_y_z;
    const lane forward_t25 = I_p_yz*R_y_y;
    const lane t9 = 2.0*forward_t22;
    const lane t10 = (R_y_x*R_y_x);
    const lane t11 = (R_y_y*R_y_y);
    const lane t12 = (R_y_z*R_y_z);
    const lane J_y_y =
        I_p_x*t10 + I_p_y*t11 + I_p_z*t12 + R_y_y*t9 + forward_t23*forward_t24 + forward_t24*forward_t25;
    const lane forward_t26 = I_p_xy*R_z_x;
    const lane forward_t27 = I_p_xz*R_z_x;
    const lane forward_t28 = I_p_yz*R_z_y;
    const lane t13 = I_p_x*R_y_x;
    const lane t14 = I_p_y*R_z_y;
    const lane t15 = I_p_z*R_z_z;
    const lane J_y_z =
        R_y_y*forward_t26 + R_y_y*t14 + R_y_z*forward_t27 + R_y_z*forward_t28 + R_y_z*t15 + R_z_x*t13
        + R_z_y*forward_t22 + R_z_z*forward_t23 + R_z_z*forward_t25;
    const lane forward_t29 = 2.0*R_z_z;
    const lane t16 = 2.0*forward_t26;
    const lane t17 = (R_z_x*R_z_x);
    const lane t18 = (R_z_y*R_z_y);
    const lane t19 = (R_z_z*R_z_z);
    const lane J_z_z =
        I_p_x*t17 + I_p_y*t18 + I_p_z*t19 + R_z_y*t16 + forward_t27*forward_t29 + forward_t28*forward_t29;
    const lane forward_10 = 1.0/((forward_4*forward_4));
    const lane forward_11 = 1.0/forward_4;
    const double t20 = (c_b_1*c_b_1);
    const double t21 = m_b_1*t20;
    const lane t22 = -c_r_1*forward_11 + 1.0;
    const lane t23 = (t22*t22);
    const lane m_perp_1 = I_b_1*forward_10 + I_r_1*forward_10 + forward_10*t21 + m_r_1*t23;
    const double t24 = c_b_1*m_b_1;
    const double t25 = c_r_1*m_r_1;
    const double forward_t32 = t24 - t25;
    const lane forward_t33 = forward_11*forward_t32;
    const lane m_lift_1 = forward_t33 + m_r_1;
    const lane forward_12 = 1.0/((forward_5*forward_5));
    const lane forward_13 = 1.0/forward_5;
    const double t26 = (c_b_2*c_b_2);
    const double t27 = m_b_2*t26;
    const lane t28 = -c_r_2*forward_13 + 1.0;
    const lane t29 = (t28*t28);
    const lane m_perp_2 = I_b_2*forward_12 + I_r_2*forward_12 + forward_12*t27 + m_r_2*t29;
    const double t30 = c_b_2*m_b_2;
    const double t31 = c_r_2*m_r_2;
    const double forward_t36 = t30 - t31;
    const lane forward_t37 = forward_13*forward_t36;
    const lane m_lift_2 = forward_t37 + m_r_2;
    const lane forward_14 = 1.0/((forward_6*forward_6));
    const lane forward_15 = 1.0/forward_6;
    const double t32 = (c_b_3*c_b_3);
    const double t33 = m_b_3*t32;
    const lane t34 = -c_r_3*forward_15 + 1.0;
    const lane t35 = (t34*t34);
    const lane m_perp_3 = I_b_3*forward_14 + I_r_3*forward_14 + forward_14*t33 + m_r_3*t35;
    const double t36 = c_b_3*m_b_3;
    const double t37 = c_r_3*m_r_3;
    const double forward_t40 = t36 - t37;
    const lane forward_t41 = forward_15*forward_t40;
    const lane m_lift_3 = forward_t41 + m_r_3;
    const lane forward_16 = 1.0/((forward_7*forward_7));
    const lane forward_17 = 1.0/forward_7;
    const double t38 = (c_b_4*c_b_4);
    const double t39 = m_b_4*t38;
    const lane t40 = -c_r_4*forward_17 + 1.0;
    const lane t41 = (t40*t40);
    const lane m_perp_4 = I_b_4*forward_16 + I_r_4*forward_16 + forward_16*t39 + m_r_4*t41;
    const double t42 = c_b_4*m_b_4;
    const double t43 = c_r_4*m_r_4;
    const double forward_t44 = t42 - t43;
    const lane forward_t45 = forward_17*forward_t44;
    const lane m_lift_4 = forward_t45 + m_r_4;
    const lane forward_18 = 1.0/((forward_8*forward_8));
    const lane forward_19 = 1.0/forward_8;
    const double t44 = (c_b_5*c_b_5);
    const double t45 = m_b_5*t44;
    const lane t46 = -c_r_5*forward_19 + 1.0;
    const lane t47 = (t46*t46);
    const lane m_perp_5 = I_b_5*forward_18 + I_r_5*forward_18 + forward_18*t45 + m_r_5*t47;
    const double t48 = c_b_5*m_b_5;
    const double t49 = c_r_5*m_r_5;
    const double forward_t48 = t48 - t49;
    const lane forward_t49 = forward_19*forward_t48;
    const lane m_lift_5 = forward_t49 + m_r_5;
    const lane forward_20 = 1.0/((forward_9*forward_9));
    const lane forward_21 = 1.0/forward_9;
    const double t50 = (c_b_6*c_b_6);
    const double t51 = m_b_6*t50;
    const lane t52 = -c_r_6*forward_21 + 1.0;
    const lane t53 = (t52*t52);
    const lane m_perp_6 = I_b_6*forward_20 + I_r_6*forward_20 + forward_20*t51 + m_r_6*t53;
    const double t54 = c_b_6*m_b_6;
    const double t55 = c_r_6*m_r_6;
    const double forward_t52 = t54 - t55;
    const lane forward_t53 = forward_21*forward_t52;
    const lane m_lift_6 = forward_t53 + m_r_6;
    const lane o_L_x = R_x_x*b_L_x + R_x_y*b_L_y + R_x_z*b_L_z;
    const lane o_L_y = R_y_x*b_L_x + R_y_y*b_L_y + R_y_z*b_L_z;
    const lane o_L_z = R_z_x*b_L_x + R_z_y*b_L_y + R_z_z*b_L_z;
    const lane D_l_1_rx = B_1_y*d_1_z - B_1_z*d_1_y;
    const lane D_l_1_ry = -B_1_x*d_1_z + B_1_z*d_1_x;
    const lane D_l_1_rz = B_1_x*d_1_y - B_1_y*d_1_x;
    const lane D_l_2_rx = B_2_y*d_2_z - B_2_z*d_2_y;
    const lane D_l_2_ry = -B_2_x*d_2_z + B_2_z*d_2_x;
    const lane D_l_2_rz = B_2_x*d_2_y - B_2_y*d_2_x;
    const lane D_l_3_rx = B_3_y*d_3_z - B_3_z*d_3_y;
    const lane D_l_3_ry = -B_3_x*d_3_z + B_3_z*d_3_x;
    const lane D_l_3_rz = B_3_x*d_3_y - B_3_y*d_3_x;
    const lane D_l_4_rx = B_4_y*d_4_z - B_4_z*d_4_y;
    const lane D_l_4_ry = -B_4_x*d_4_z + B_4_z*d_4_x;
    const lane D_l_4_rz = B_4_x*d_4_y - B_4_y*d_4_x;
    const lane D_l_5_rx = B_5_y*d_5_z - B_5_z*d_5_y;
    const lane D_l_5_ry = -B_5_x*d_5_z + B_5_z*d_5_x;
    const lane D_l_5_rz = B_5_x*d_5_y - B_5_y*d_5_x;
    const lane D_l_6_rx = B_6_y*d_6_z - B_6_z*d_6_y;
    const lane D_l_6_ry = -B_6_x*d_6_z + B_6_z*d_6_x;
    const lane D_l_6_rz = B_6_x*d_6_y - B_6_y*d_6_x;
    const lane minor_23_23 = d_2_y*d_3_z - d_2_z*d_3_y;
    const lane minor_56_56 = D_l_5_ry*D_l_6_rz - D_l_5_rz*D_l_6_ry;
    const lane minor_56_46 = D_l_5_rx*D_l_6_rz - D_l_5_rz*D_l_6_rx;
    const lane minor_56_45 = D_l_5_rx*D_l_6_ry - D_l_5_ry*D_l_6_rx;
    const lane minor_456_456 = D_l_4_rx*minor_56_56 - D_l_4_ry*minor_56_46 + D_l_4_rz*minor_56_45;
    const lane minor_23_24 = -D_l_2_rx*d_3_y + D_l_3_rx*d_2_y;
    const lane minor_56_36 = -D_l_5_rz*d_6_z + D_l_6_rz*d_5_z;
    const lane minor_56_35 = -D_l_5_ry*d_6_z + D_l_6_ry*d_5_z;
    const lane minor_456_356 = -D_l_4_ry*minor_56_36 + D_l_4_rz*minor_56_35 + d_4_z*minor_56_56;
    const lane minor_23_25 = -D_l_2_ry*d_3_y + D_l_3_ry*d_2_y;
    const lane minor_56_34 = -D_l_5_rx*d_6_z + D_l_6_rx*d_5_z;
    const lane minor_456_346 = -D_l_4_rx*minor_56_36 + D_l_4_rz*minor_56_34 + d_4_z*minor_56_46;
    const lane minor_23_26 = -D_l_2_rz*d_3_y + D_l_3_rz*d_2_y;
    const lane minor_456_345 = -D_l_4_rx*minor_56_35 + D_l_4_ry*minor_56_34 + d_4_z*minor_56_45;
    const lane minor_23_34 = -D_l_2_rx*d_3_z + D_l_3_rx*d_2_z;
    const lane minor_56_26 = -D_l_5_rz*d_6_y + D_l_6_rz*d_5_y;
    const lane minor_56_25 = -D_l_5_ry*d_6_y + D_l_6_ry*d_5_y;
    const lane minor_456_256 = -D_l_4_ry*minor_56_26 + D_l_4_rz*minor_56_25 + d_4_y*minor_56_56;
    const lane minor_23_35 = -D_l_2_ry*d_3_z + D_l_3_ry*d_2_z;
    const lane minor_56_24 = -D_l_5_rx*d_6_y + D_l_6_rx*d_5_y;
    const lane minor_456_246 = -D_l_4_rx*minor_56_26 + D_l_4_rz*minor_56_24 + d_4_y*minor_56_46;
    const lane minor_23_36 = -D_l_2_rz*d_3_z + D_l_3_rz*d_2_z;
    const lane minor_456_245 = -D_l_4_rx*minor_56_25 + D_l_4_ry*minor_56_24 + d_4_y*minor_56_45;
    const lane minor_23_45 = D_l_2_rx*D_l_3_ry - D_l_2_ry*D_l_3_rx;
    const lane minor_56_23 = d_5_y*d_6_z - d_5_z*d_6_y;
    const lane minor_456_236 = D_l_4_rz*minor_56_23 + d_4_y*minor_56_36 - d_4_z*minor_56_26;
    const lane minor_23_46 = D_l_2_rx*D_l_3_rz - D_l_2_rz*D_l_3_rx;
    const lane minor_456_235 = D_l_4_ry*minor_56_23 + d_4_y*minor_56_35 - d_4_z*minor_56_25;
    const lane minor_23_56 = D_l_2_ry*D_l_3_rz - D_l_2_rz*D_l_3_ry;
    const lane minor_456_234 = D_l_4_rx*minor_56_23 + d_4_y*minor_56_34 - d_4_z*minor_56_24;
    const lane A_x_1 =
        minor_23_23*minor_456_456 - minor_23_24*minor_456_356 + minor_23_25*minor_456_346
        - minor_23_26*minor_456_345 + minor_23_34*minor_456_256 - minor_23_35*minor_456_246
        + minor_23_36*minor_456_245 + minor_23_45*minor_456_236 - minor_23_46*minor_456_235
        + minor_23_56*minor_456_234;
    const lane minor_23_13 = d_2_x*d_3_z - d_2_z*d_3_x;
    const lane minor_23_14 = -D_l_2_rx*d_3_x + D_l_3_rx*d_2_x;
    const lane minor_23_15 = -D_l_2_ry*d_3_x + D_l_3_ry*d_2_x;
    const lane minor_23_16 = -D_l_2_rz*d_3_x + D_l_3_rz*d_2_x;
    const lane minor_56_16 = -D_l_5_rz*d_6_x + D_l_6_rz*d_5_x;
    const lane minor_56_15 = -D_l_5_ry*d_6_x + D_l_6_ry*d_5_x;
    const lane minor_456_156 = -D_l_4_ry*minor_56_16 + D_l_4_rz*minor_56_15 + d_4_x*minor_56_56;
    const lane minor_56_14 = -D_l_5_rx*d_6_x + D_l_6_rx*d_5_x;
    const lane minor_456_146 = -D_l_4_rx*minor_56_16 + D_l_4_rz*minor_56_14 + d_4_x*minor_56_46;
    const lane minor_456_145 = -D_l_4_rx*minor_56_15 + D_l_4_ry*minor_56_14 + d_4_x*minor_56_45;
    const lane minor_56_13 = d_5_x*d_6_z - d_5_z*d_6_x;
    const lane minor_456_136 = D_l_4_rz*minor_56_13 + d_4_x*minor_56_36 - d_4_z*minor_56_16;
    const lane minor_456_135 = D_l_4_ry*minor_56_13 + d_4_x*minor_56_35 - d_4_z*minor_56_15;
    const lane minor_456_134 = D_l_4_rx*minor_56_13 + d_4_x*minor_56_34 - d_4_z*minor_56_14;
    const lane A_y_1 =
        -minor_23_13*minor_456_456 + minor_23_14*minor_456_356 - minor_23_15*minor_456_346
        + minor_23_16*minor_456_345 - minor_23_34*minor_456_156 + minor_23_35*minor_456_146
        - minor_23_36*minor_456_145 - minor_23_45*minor_456_136 + minor_23_46*minor_456_135
        - minor_23_56*minor_456_134;
    const lane minor_23_12 = d_2_x*d_3_y - d_2_y*d_3_x;
    const lane minor_56_12 = d_5_x*d_6_y - d_5_y*d_6_x;
    const lane minor_456_126 = D_l_4_rz*minor_56_12 + d_4_x*minor_56_26 - d_4_y*minor_56_16;
    const lane minor_456_125 = D_l_4_ry*minor_56_12 + d_4_x*minor_56_25 - d_4_y*minor_56_15;
    const lane minor_456_124 = D_l_4_rx*minor_56_12 + d_4_x*minor_56_24 - d_4_y*minor_56_14;
    const lane A_z_1 =
        minor_23_12*minor_456_456 - minor_23_14*minor_456_256 + minor_23_15*minor_456_246
        - minor_23_16*minor_456_245 + minor_23_24*minor_456_156 - minor_23_25*minor_456_146
        + minor_23_26*minor_456_145 + minor_23_45*minor_456_126 - minor_23_46*minor_456_125
        + minor_23_56*minor_456_124;
    const lane minor_456_123 = d_4_x*minor_56_23 - d_4_y*minor_56_13 + d_4_z*minor_56_12;
    const lane A_rx_1 =
        -minor_23_12*minor_456_356 + minor_23_13*minor_456_256 - minor_23_15*minor_456_236
        + minor_23_16*minor_456_235 - minor_23_23*minor_456_156 + minor_23_25*minor_456_136
        - minor_23_26*minor_456_135 - minor_23_35*minor_456_126 + minor_23_36*minor_456_125
        - minor_23_56*minor_456_123;
    const lane A_ry_1 =
        minor_23_12*minor_456_346 - minor_23_13*minor_456_246 + minor_23_14*minor_456_236
        - minor_23_16*minor_456_234 + minor_23_23*minor_456_146 - minor_23_24*minor_456_136
        + minor_23_26*minor_456_134 + minor_23_34*minor_456_126 - minor_23_36*minor_456_124
        + minor_23_46*minor_456_123;
    const lane A_rz_1 =
        -minor_23_12*minor_456_345 + minor_23_13*minor_456_245 - minor_23_14*minor_456_235
        + minor_23_15*minor_456_234 - minor_23_23*minor_456_145 + minor_23_24*minor_456_135
        - minor_23_25*minor_456_134 - minor_23_34*minor_456_125 + minor_23_35*minor_456_124
        - minor_23_45*minor_456_123;
    const lane minor_13_23 = d_1_y*d_3_z - d_1_z*d_3_y;
    const lane minor_13_24 = -D_l_1_rx*d_3_y + D_l_3_rx*d_1_y;
    const lane minor_13_25 = -D_l_1_ry*d_3_y + D_l_3_ry*d_1_y;
    const lane minor_13_26 = -D_l_1_rz*d_3_y + D_l_3_rz*d_1_y;
    const lane minor_13_34 = -D_l_1_rx*d_3_z + D_l_3_rx*d_1_z;
    const lane minor_13_35 = -D_l_1_ry*d_3_z + D_l_3_ry*d_1_z;
    const lane minor_13_36 = -D_l_1_rz*d_3_z + D_l_3_rz*d_1_z;
    const lane minor_13_45 = D_l_1_rx*D_l_3_ry - D_l_1_ry*D_l_3_rx;
    const lane minor_13_46 = D_l_1_rx*D_l_3_rz - D_l_1_rz*D_l_3_rx;
    const lane minor_13_56 = D_l_1_ry*D_l_3_rz - D_l_1_rz*D_l_3_ry;
    const lane A_x_2 =
        -minor_13_23*minor_456_456 + minor_13_24*minor_456_356 - minor_13_25*minor_456_346
        + minor_13_26*minor_456_345 - minor_13_34*minor_456_256 + minor_13_35*minor_456_246
        - minor_13_36*minor_456_245 - minor_13_45*minor_456_236 + minor_13_46*minor_456_235
        - minor_13_56*minor_456_234;
    const lane minor_13_13 = d_1_x*d_3_z - d_1_z*d_3_x;
    const lane minor_13_14 = -D_l_1_rx*d_3_x + D_l_3_rx*d_1_x;
    const lane minor_13_15 = -D_l_1_ry*d_3_x + D_l_3_ry*d_1_x;
    const lane minor_13_16 = -D_l_1_rz*d_3_x + D_l_3_rz*d_1_x;
    const lane A_y_2 =
        minor_13_13*minor_456_456 - minor_13_14*minor_456_356 + minor_13_15*minor_456_346
        - minor_13_16*minor_456_345 + minor_13_34*minor_456_156 - minor_13_35*minor_456_146
        + minor_13_36*minor_456_145 + minor_13_45*minor_456_136 - minor_13_46*minor_456_135
        + minor_13_56*minor_456_134;
    const lane minor_13_12 = d_1_x*d_3_y - d_1_y*d_3_x;
    const lane A_z_2 =
        -minor_13_12*minor_456_456 + minor_13_14*minor_456_256 - minor_13_15*minor_456_246
        + minor_13_16*minor_456_245 - minor_13_24*minor_456_156 + minor_13_25*minor_456_146
        - minor_13_26*minor_456_145 - minor_13_45*minor_456_126 + minor_13_46*minor_456_125
        - minor_13_56*minor_456_124;
    const lane A_rx_2 =
        minor_13_12*minor_456_356 - minor_13_13*minor_456_256 + minor_13_15*minor_456_236
        - minor_13_16*minor_456_235 + minor_13_23*minor_456_156 - minor_13_25*minor_456_136
        + minor_13_26*minor_456_135 + minor_13_35*minor_456_126 - minor_13_36*minor_456_125
        + minor_13_56*minor_456_123;
    const lane A_ry_2 =
        -minor_13_12*minor_456_346 + minor_13_13*minor_456_246 - minor_13_14*minor_456_236
        + minor_13_16*minor_456_234 - minor_13_23*minor_456_146 + minor_13_24*minor_456_136
        - minor_13_26*minor_456_134 - minor_13_34*minor_456_126 + minor_13_36*minor_456_124
        - minor_13_46*minor_456_123;
    const lane A_rz_2 =
        minor_13_12*minor_456_345 - minor_13_13*minor_456_245 + minor_13_14*minor_456_235
        - minor_13_15*minor_456_234 + minor_13_23*minor_456_145 - minor_13_24*minor_456_135
        + minor_13_25*minor_456_134 + minor_13_34*minor_456_125 - minor_13_35*minor_456_124
        + minor_13_45*minor_456_123;
    const lane minor_12_23 = d_1_y*d_2_z - d_1_z*d_2_y;
    const lane minor_12_24 = -D_l_1_rx*d_2_y + D_l_2_rx*d_1_y;
    const lane minor_12_25 = -D_l_1_ry*d_2_y + D_l_2_ry*d_1_y;
    const lane minor_12_26 = -D_l_1_rz*d_2_y + D_l_2_rz*d_1_y;
    const lane minor_12_34 = -D_l_1_rx*d_2_z + D_l_2_rx*d_1_z;
    const lane minor_12_35 = -D_l_1_ry*d_2_z + D_l_2_ry*d_1_z;
    const lane minor_12_36 = -D_l_1_rz*d_2_z + D_l_2_rz*d_1_z;
    const lane minor_12_45 = D_l_1_rx*D_l_2_ry - D_l_1_ry*D_l_2_rx;
    const lane minor_12_46 = D_l_1_rx*D_l_2_rz - D_l_1_rz*D_l_2_rx;
    const lane minor_12_56 = D_l_1_ry*D_l_2_rz - D_l_1_rz*D_l_2_ry;
    const lane A_x_3 =
        minor_12_23*minor_456_456 - minor_12_24*minor_456_356 + minor_12_25*minor_456_346
        - minor_12_26*minor_456_345 + minor_12_34*minor_456_256 - minor_12_35*minor_456_246
        + minor_12_36*minor_456_245 + minor_12_45*minor_456_236 - minor_12_46*minor_456_235
        + minor_12_56*minor_456_234;
    const lane minor_12_13 = d_1_x*d_2_z - d_1_z*d_2_x;
    const lane minor_12_14 = -D_l_1_rx*d_2_x + D_l_2_rx*d_1_x;
    const lane minor_12_15 = -D_l_1_ry*d_2_x + D_l_2_ry*d_1_x;
    const lane minor_12_16 = -D_l_1_rz*d_2_x + D_l_2_rz*d_1_x;
    const lane A_y_3 =
        -minor_12_13*minor_456_456 + minor_12_14*minor_456_356 - minor_12_15*minor_456_346
        + minor_12_16*minor_456_345 - minor_12_34*minor_456_156 + minor_12_35*minor_456_146
        - minor_12_36*minor_456_145 - minor_12_45*minor_456_136 + minor_12_46*minor_456_135
        - minor_12_56*minor_456_134;
    const lane minor_12_12 = d_1_x*d_2_y - d_1_y*d_2_x;
    const lane A_z_3 =
        minor_12_12*minor_456_456 - minor_12_14*minor_456_256 + minor_12_15*minor_456_246
        - minor_12_16*minor_456_245 + minor_12_24*minor_456_156 - minor_12_25*minor_456_146
        + minor_12_26*minor_456_145 + minor_12_45*minor_456_126 - minor_12_46*minor_456_125
        + minor_12_56*minor_456_124;
    const lane A_rx_3 =
        -minor_12_12*minor_456_356 + minor_12_13*minor_456_256 - minor_12_15*minor_456_236
        + minor_12_16*minor_456_235 - minor_12_23*minor_456_156 + minor_12_25*minor_456_136
        - minor_12_26*minor_456_135 - minor_12_35*minor_456_126 + minor_12_36*minor_456_125
        - minor_12_56*minor_456_123;
    const lane A_ry_3 =
        minor_12_12*minor_456_346 - minor_12_13*minor_456_246 + minor_12_14*minor_456_236
        - minor_12_16*minor_456_234 + minor_12_23*minor_456_146 - minor_12_24*minor_456_136
        + minor_12_26*minor_456_134 + minor_12_34*minor_456_126 - minor_12_36*minor_456_124
        + minor_12_46*minor_456_123;
    const lane A_rz_3 =
        -minor_12_12*minor_456_345 + minor_12_13*minor_456_245 - minor_12_14*minor_456_235
        + minor_12_15*minor_456_234 - minor_12_23*minor_456_145 + minor_12_24*minor_456_135
        - minor_12_25*minor_456_134 - minor_12_34*minor_456_125 + minor_12_35*minor_456_124
        - minor_12_45*minor_456_123;
    const lane minor_123_234 = D_l_1_rx*minor_23_23 + d_1_y*minor_23_34 - d_1_z*minor_23_24;
    const lane minor_123_235 = D_l_1_ry*minor_23_23 + d_1_y*minor_23_35 - d_1_z*minor_23_25;
    const lane minor_123_236 = D_l_1_rz*minor_23_23 + d_1_y*minor_23_36 - d_1_z*minor_23_26;
    const lane minor_123_245 = -D_l_1_rx*minor_23_25 + D_l_1_ry*minor_23_24 + d_1_y*minor_23_45;
    const lane minor_123_246 = -D_l_1_rx*minor_23_26 + D_l_1_rz*minor_23_24 + d_1_y*minor_23_46;
    const lane minor_123_256 = -D_l_1_ry*minor_23_26 + D_l_1_rz*minor_23_25 + d_1_y*minor_23_56;
    const lane minor_123_345 = -D_l_1_rx*minor_23_35 + D_l_1_ry*minor_23_34 + d_1_z*minor_23_45;
    const lane minor_123_346 = -D_l_1_rx*minor_23_36 + D_l_1_rz*minor_23_34 + d_1_z*minor_23_46;
    const lane minor_123_356 = -D_l_1_ry*minor_23_36 + D_l_1_rz*minor_23_35 + d_1_z*minor_23_56;
    const lane minor_123_456 = D_l_1_rx*minor_23_56 - D_l_1_ry*minor_23_46 + D_l_1_rz*minor_23_45;
    const lane A_x_4 =
        -minor_123_234*minor_56_56 + minor_123_235*minor_56_46 - minor_123_236*minor_56_45
        - minor_123_245*minor_56_36 + minor_123_246*minor_56_35 - minor_123_256*minor_56_34
        + minor_123_345*minor_56_26 - minor_123_346*minor_56_25 + minor_123_356*minor_56_24
        - minor_123_456*minor_56_23;
    const lane minor_123_134 = D_l_1_rx*minor_23_13 + d_1_x*minor_23_34 - d_1_z*minor_23_14;
    const lane minor_123_135 = D_l_1_ry*minor_23_13 + d_1_x*minor_23_35 - d_1_z*minor_23_15;
    const lane minor_123_136 = D_l_1_rz*minor_23_13 + d_1_x*minor_23_36 - d_1_z*minor_23_16;
    const lane minor_123_145 = -D_l_1_rx*minor_23_15 + D_l_1_ry*minor_23_14 + d_1_x*minor_23_45;
    const lane minor_123_146 = -D_l_1_rx*minor_23_16 + D_l_1_rz*minor_23_14 + d_1_x*minor_23_46;
    const lane minor_123_156 = -D_l_1_ry*minor_23_16 + D_l_1_rz*minor_23_15 + d_1_x*minor_23_56;
    const lane A_y_4 =
        minor_123_134*minor_56_56 - minor_123_135*minor_56_46 + minor_123_136*minor_56_45
        + minor_123_145*minor_56_36 - minor_123_146*minor_56_35 + minor_123_156*minor_56_34
        - minor_123_345*minor_56_16 + minor_123_346*minor_56_15 - minor_123_356*minor_56_14
        + minor_123_456*minor_56_13;
    const lane minor_123_124 = D_l_1_rx*minor_23_12 + d_1_x*minor_23_24 - d_1_y*minor_23_14;
    const lane minor_123_125 = D_l_1_ry*minor_23_12 + d_1_x*minor_23_25 - d_1_y*minor_23_15;
    const lane minor_123_126 = D_l_1_rz*minor_23_12 + d_1_x*minor_23_26 - d_1_y*minor_23_16;
    const lane A_z_4 =
        -minor_123_124*minor_56_56 + minor_123_125*minor_56_46 - minor_123_126*minor_56_45
        - minor_123_145*minor_56_26 + minor_123_146*minor_56_25 - minor_123_156*minor_56_24
        + minor_123_245*minor_56_16 - minor_123_246*minor_56_15 + minor_123_256*minor_56_14
        - minor_123_456*minor_56_12;
    const lane minor_123_123 = d_1_x*minor_23_23 - d_1_y*minor_23_13 + d_1_z*minor_23_12;
    const lane A_rx_4 =
        minor_123_123*minor_56_56 - minor_123_125*minor_56_36 + minor_123_126*minor_56_35
        + minor_123_135*minor_56_26 - minor_123_136*minor_56_25 + minor_123_156*minor_56_23
        - minor_123_235*minor_56_16 + minor_123_236*minor_56_15 - minor_123_256*minor_56_13
        + minor_123_356*minor_56_12;
    const lane A_ry_4 =
        -minor_123_123*minor_56_46 + minor_123_124*minor_56_36 - minor_123_126*minor_56_34
        - minor_123_134*minor_56_26 + minor_123_136*minor_56_24 - minor_123_146*minor_56_23
        + minor_123_234*minor_56_16 - minor_123_236*minor_56_14 + minor_123_246*minor_56_13
        - minor_123_346*minor_56_12;
    const lane A_rz_4 =
        minor_123_123*minor_56_45 - minor_123_124*minor_56_35 + minor_123_125*minor_56_34
        + minor_123_134*minor_56_25 - minor_123_135*minor_56_24 + minor_123_145*minor_56_23
        - minor_123_234*minor_56_15 + minor_123_235*minor_56_14 - minor_123_245*minor_56_13
        + minor_123_345*minor_56_12;
    const lane minor_46_56 = D_l_4_ry*D_l_6_rz - D_l_4_rz*D_l_6_ry;
    const lane minor_46_46 = D_l_4_rx*D_l_6_rz - D_l_4_rz*D_l_6_rx;
    const lane minor_46_45 = D_l_4_rx*D_l_6_ry - D_l_4_ry*D_l_6_rx;
    const lane minor_46_36 = -D_l_4_rz*d_6_z + D_l_6_rz*d_4_z;
    const lane minor_46_35 = -D_l_4_ry*d_6_z + D_l_6_ry*d_4_z;
    const lane minor_46_34 = -D_l_4_rx*d_6_z + D_l_6_rx*d_4_z;
    const lane minor_46_26 = -D_l_4_rz*d_6_y + D_l_6_rz*d_4_y;
    const lane minor_46_25 = -D_l_4_ry*d_6_y + D_l_6_ry*d_4_y;
    const lane minor_46_24 = -D_l_4_rx*d_6_y + D_l_6_rx*d_4_y;
    const lane minor_46_23 = d_4_y*d_6_z - d_4_z*d_6_y;
    const lane A_x_5 =
        minor_123_234*minor_46_56 - minor_123_235*minor_46_46 + minor_123_236*minor_46_45
        + minor_123_245*minor_46_36 - minor_123_246*minor_46_35 + minor_123_256*minor_46_34
        - minor_123_345*minor_46_26 + minor_123_346*minor_46_25 - minor_123_356*minor_46_24
        + minor_123_456*minor_46_23;
    const lane minor_46_16 = -D_l_4_rz*d_6_x + D_l_6_rz*d_4_x;
    const lane minor_46_15 = -D_l_4_ry*d_6_x + D_l_6_ry*d_4_x;
    const lane minor_46_14 = -D_l_4_rx*d_6_x + D_l_6_rx*d_4_x;
    const lane minor_46_13 = d_4_x*d_6_z - d_4_z*d_6_x;
    const lane A_y_5 =
        -minor_123_134*minor_46_56 + minor_123_135*minor_46_46 - minor_123_136*minor_46_45
        - minor_123_145*minor_46_36 + minor_123_146*minor_46_35 - minor_123_156*minor_46_34
        + minor_123_345*minor_46_16 - minor_123_346*minor_46_15 + minor_123_356*minor_46_14
        - minor_123_456*minor_46_13;
    const lane minor_46_12 = d_4_x*d_6_y - d_4_y*d_6_x;
    const lane A_z_5 =
        minor_123_124*minor_46_56 - minor_123_125*minor_46_46 + minor_123_126*minor_46_45
        + minor_123_145*minor_46_26 - minor_123_146*minor_46_25 + minor_123_156*minor_46_24
        - minor_123_245*minor_46_16 + minor_123_246*minor_46_15 - minor_123_256*minor_46_14
        + minor_123_456*minor_46_12;
    const lane A_rx_5 =
        -minor_123_123*minor_46_56 + minor_123_125*minor_46_36 - minor_123_126*minor_46_35
        - minor_123_135*minor_46_26 + minor_123_136*minor_46_25 - minor_123_156*minor_46_23
        + minor_123_235*minor_46_16 - minor_123_236*minor_46_15 + minor_123_256*minor_46_13
        - minor_123_356*minor_46_12;
    const lane A_ry_5 =
        minor_123_123*minor_46_46 - minor_123_124*minor_46_36 + minor_123_126*minor_46_34
        + minor_123_134*minor_46_26 - minor_123_136*minor_46_24 + minor_123_146*minor_46_23
        - minor_123_234*minor_46_16 + minor_123_236*minor_46_14 - minor_123_246*minor_46_13
        + minor_123_346*minor_46_12;
    const lane A_rz_5 =
        -minor_123_123*minor_46_45 + minor_123_124*minor_46_35 - minor_123_125*minor_46_34
        - minor_123_134*minor_46_25 + minor_123_135*minor_46_24 - minor_123_145*minor_46_23
        + minor_123_234*minor_46_15 - minor_123_235*minor_46_14 + minor_123_245*minor_46_13
        - minor_123_345*minor_46_12;
    const lane minor_45_56 = D_l_4_ry*D_l_5_rz - D_l_4_rz*D_l_5_ry;
    const lane minor_45_46 = D_l_4_rx*D_l_5_rz - D_l_4_rz*D_l_5_rx;
    const lane minor_45_45 = D_l_4_rx*D_l_5_ry - D_l_4_ry*D_l_5_rx;
    const lane minor_45_36 = -D_l_4_rz*d_5_z + D_l_5_rz*d_4_z;
    const lane minor_45_35 = -D_l_4_ry*d_5_z + D_l_5_ry*d_4_z;
    const lane minor_45_34 = -D_l_4_rx*d_5_z + D_l_5_rx*d_4_z;
    const lane minor_45_26 = -D_l_4_rz*d_5_y + D_l_5_rz*d_4_y;
    const lane minor_45_25 = -D_l_4_ry*d_5_y + D_l_5_ry*d_4_y;
    const lane minor_45_24 = -D_l_4_rx*d_5_y + D_l_5_rx*d_4_y;
    const lane minor_45_23 = d_4_y*d_5_z - d_4_z*d_5_y;
    const lane A_x_6 =
        -minor_123_234*minor_45_56 + minor_123_235*minor_45_46 - minor_123_236*minor_45_45
        - minor_123_245*minor_45_36 + minor_123_246*minor_45_35 - minor_123_256*minor_45_34
        + minor_123_345*minor_45_26 - minor_123_346*minor_45_25 + minor_123_356*minor_45_24
        - minor_123_456*minor_45_23;
    const lane minor_45_16 = -D_l_4_rz*d_5_x + D_l_5_rz*d_4_x;
    const lane minor_45_15 = -D_l_4_ry*d_5_x + D_l_5_ry*d_4_x;
    const lane minor_45_14 = -D_l_4_rx*d_5_x + D_l_5_rx*d_4_x;
    const lane minor_45_13 = d_4_x*d_5_z - d_4_z*d_5_x;
    const lane A_y_6 =
        minor_123_134*minor_45_56 - minor_123_135*minor_45_46 + minor_123_136*minor_45_45
        + minor_123_145*minor_45_36 - minor_123_146*minor_45_35 + minor_123_156*minor_45_34
        - minor_123_345*minor_45_16 + minor_123_346*minor_45_15 - minor_123_356*minor_45_14
        + minor_123_456*minor_45_13;
    const lane minor_45_12 = d_4_x*d_5_y - d_4_y*d_5_x;
    const lane A_z_6 =
        -minor_123_124*minor_45_56 + minor_123_125*minor_45_46 - minor_123_126*minor_45_45
        - minor_123_145*minor_45_26 + minor_123_146*minor_45_25 - minor_123_156*minor_45_24
        + minor_123_245*minor_45_16 - minor_123_246*minor_45_15 + minor_123_256*minor_45_14
        - minor_123_456*minor_45_12;
    const lane A_rx_6 =
        minor_123_123*minor_45_56 - minor_123_125*minor_45_36 + minor_123_126*minor_45_35
        + minor_123_135*minor_45_26 - minor_123_136*minor_45_25 + minor_123_156*minor_45_23
        - minor_123_235*minor_45_16 + minor_123_236*minor_45_15 - minor_123_256*minor_45_13
        + minor_123_356*minor_45_12;
    const lane A_ry_6 =
        -minor_123_123*minor_45_46 + minor_123_124*minor_45_36 - minor_123_126*minor_45_34
        - minor_123_134*minor_45_26 + minor_123_136*minor_45_24 - minor_123_146*minor_45_23
        + minor_123_234*minor_45_16 - minor_123_236*minor_45_14 + minor_123_246*minor_45_13
        - minor_123_346*minor_45_12;
    const lane A_rz_6 =
        minor_123_123*minor_45_45 - minor_123_124*minor_45_35 + minor_123_125*minor_45_34
        + minor_123_134*minor_45_25 - minor_123_135*minor_45_24 + minor_123_145*minor_45_23
        - minor_123_234*minor_45_15 + minor_123_235*minor_45_14 - minor_123_245*minor_45_13
        + minor_123_345*minor_45_12;
    const lane det_D_l =
        A_rx_1*D_l_1_rx + A_ry_1*D_l_1_ry + A_rz_1*D_l_1_rz + A_x_1*d_1_x + A_y_1*d_1_y + A_z_1*d_1_z;
    const lane forward_22 = 1.0/det_D_l;
    const lane forward_t55 = forward_22*forward_4;
    const lane D_p_x_1 = A_x_1*forward_t55;
    const lane forward_t56 = forward_22*forward_5;
    const lane D_p_x_2 = A_x_2*forward_t56;
    const lane forward_t57 = forward_22*forward_6;
    const lane D_p_x_3 = A_x_3*forward_t57;
    const lane forward_t58 = forward_22*forward_7;
    const lane D_p_x_4 = A_x_4*forward_t58;
    const lane forward_t59 = forward_22*forward_8;
    const lane D_p_x_5 = A_x_5*forward_t59;
    const lane forward_t60 = forward_22*forward_9;
    const lane D_p_x_6 = A_x_6*forward_t60;
    const lane D_p_y_1 = A_y_1*forward_t55;
    const lane D_p_y_2 = A_y_2*forward_t56;
    const lane D_p_y_3 = A_y_3*forward_t57;
    const lane D_p_y_4 = A_y_4*forward_t58;
    const lane D_p_y_5 = A_y_5*forward_t59;
    const lane D_p_y_6 = A_y_6*forward_t60;
    const lane D_p_z_1 = A_z_1*forward_t55;
    const lane D_p_z_2 = A_z_2*forward_t56;
    const lane D_p_z_3 = A_z_3*forward_t57;
    const lane D_p_z_4 = A_z_4*forward_t58;
    const lane D_p_z_5 = A_z_5*forward_t59;
    const lane D_p_z_6 = A_z_6*forward_t60;
    const lane D_p_rx_1 = A_rx_1*forward_t55;
    const lane D_p_rx_2 = A_rx_2*forward_t56;
    const lane D_p_rx_3 = A_rx_3*forward_t57;
    const lane D_p_rx_4 = A_rx_4*forward_t58;
    const lane D_p_rx_5 = A_rx_5*forward_t59;
    const lane D_p_rx_6 = A_rx_6*forward_t60;
    const lane D_p_ry_1 = A_ry_1*forward_t55;
    const lane D_p_ry_2 = A_ry_2*forward_t56;
    const lane D_p_ry_3 = A_ry_3*forward_t57;
    const lane D_p_ry_4 = A_ry_4*forward_t58;
    const lane D_p_ry_5 = A_ry_5*forward_t59;
    const lane D_p_ry_6 = A_ry_6*forward_t60;
    const lane D_p_rz_1 = A_rz_1*forward_t55;
    const lane D_p_rz_2 = A_rz_2*forward_t56;
    const lane D_p_rz_3 = A_rz_3*forward_t57;
    const lane D_p_rz_4 = A_rz_4*forward_t58;
    const lane D_p_rz_5 = A_rz_5*forward_t59;
    const lane D_p_rz_6 = A_rz_6*forward_t60;
    const lane forward_t61 = g_x*m_lift_1;
    const lane forward_t62 = g_x*m_lift_2;
    const lane forward_t63 = g_x*m_lift_3;
    const lane forward_t64 = g_x*m_lift_4;
    const lane forward_t65 = g_x*m_lift_5;
    const lane forward_t66 = g_x*m_lift_6;
    const double forward_t67 = m_L + m_p;
    const lane G_p_x =
        -forward_t61 - forward_t62 - forward_t63 - forward_t64 - forward_t65 - forward_t66 - forward_t67*g_x;
    const lane forward_t68 = g_y*m_lift_1;
    const lane forward_t69 = g_y*m_lift_2;
    const lane forward_t70 = g_y*m_lift_3;
    const lane forward_t71 = g_y*m_lift_4;
    const lane forward_t72 = g_y*m_lift_5;
    const lane forward_t73 = g_y*m_lift_6;
    const lane G_p_y =
        -forward_t67*g_y - forward_t68 - forward_t69 - forward_t70 - forward_t71 - forward_t72 - forward_t73;
    const lane forward_t74 = g_z*m_lift_1;
    const lane forward_t75 = g_z*m_lift_2;
    const lane forward_t76 = g_z*m_lift_3;
    const lane forward_t77 = g_z*m_lift_4;
    const lane forward_t78 = g_z*m_lift_5;
    const lane forward_t79 = g_z*m_lift_6;
    const lane G_p_z =
        -forward_t67*g_z - forward_t74 - forward_t75 - forward_t76 - forward_t77 - forward_t78 - forward_t79;
    const double forward_t80 = g_z*m_p;
    const double forward_t81 = g_z*m_L;
    const lane G_p_rx =
        -B_1_y*forward_t74 + B_1_z*g_y*m_lift_1 - B_2_y*forward_t75 + B_2_z*g_y*m_lift_2 - B_3_y*forward_t76
        + B_3_z*g_y*m_lift_3 - B_4_y*forward_t77 + B_4_z*g_y*m_lift_4 - B_5_y*forward_t78
        + B_5_z*g_y*m_lift_5 - B_6_y*forward_t79 + B_6_z*g_y*m_lift_6 - c_y*forward_t80 + c_z*g_y*m_p
        - forward_t81*o_L_y + g_y*m_L*o_L_z;
    const double forward_t82 = g_x*m_p;
    const double forward_t83 = g_x*m_L;
    const lane G_p_ry =
        B_1_x*forward_t74 - B_1_z*forward_t61 + B_2_x*forward_t75 - B_2_z*forward_t62 + B_3_x*forward_t76
        - B_3_z*forward_t63 + B_4_x*forward_t77 - B_4_z*forward_t64 + B_5_x*forward_t78 - B_5_z*forward_t65
        + B_6_x*forward_t79 - B_6_z*forward_t66 + c_x*forward_t80 - c_z*forward_t82 + forward_t81*o_L_x
        - forward_t83*o_L_z;
    const double forward_t84 = g_y*m_p;
    const double forward_t85 = g_y*m_L;
    const lane G_p_rz =
        -B_1_x*forward_t68 + B_1_y*g_x*m_lift_1 - B_2_x*forward_t69 + B_2_y*g_x*m_lift_2 - B_3_x*forward_t70
        + B_3_y*g_x*m_lift_3 - B_4_x*forward_t71 + B_4_y*g_x*m_lift_4 - B_5_x*forward_t72
        + B_5_y*g_x*m_lift_5 - B_6_x*forward_t73 + B_6_y*g_x*m_lift_6 - c_x*forward_t84 + c_y*g_x*m_p
        - forward_t85*o_L_x + g_x*m_L*o_L_y;
    const lane t56 = A_rx_1*G_p_rx + A_ry_1*G_p_ry + A_rz_1*G_p_rz + A_x_1*G_p_x + A_y_1*G_p_y + A_z_1*G_p_z;
    const lane mu_1 = forward_22*t56;
    const lane t57 = A_rx_2*G_p_rx + A_ry_2*G_p_ry + A_rz_2*G_p_rz + A_x_2*G_p_x + A_y_2*G_p_y + A_z_2*G_p_z;
    const lane mu_2 = forward_22*t57;
    const lane t58 = A_rx_3*G_p_rx + A_ry_3*G_p_ry + A_rz_3*G_p_rz + A_x_3*G_p_x + A_y_3*G_p_y + A_z_3*G_p_z;
    const lane mu_3 = forward_22*t58;
    const lane t59 = A_rx_4*G_p_rx + A_ry_4*G_p_ry + A_rz_4*G_p_rz + A_x_4*G_p_x + A_y_4*G_p_y + A_z_4*G_p_z;
    const lane mu_4 = forward_22*t59;
    const lane t60 = A_rx_5*G_p_rx + A_ry_5*G_p_ry + A_rz_5*G_p_rz + A_x_5*G_p_x + A_y_5*G_p_y + A_z_5*G_p_z;
    const lane mu_5 = forward_22*t60;
    const lane t61 = A_rx_6*G_p_rx + A_ry_6*G_p_ry + A_rz_6*G_p_rz + A_x_6*G_p_x + A_y_6*G_p_y + A_z_6*G_p_z;
    const lane mu_6 = forward_22*t61;
    const lane g_4_x = -d_1_x*mu_1 - forward_t61;
    const lane g_4_y = -d_1_y*mu_1 - forward_t68;
    const lane g_4_z = -d_1_z*mu_1 - forward_t74;
    const lane g_5_x = -d_2_x*mu_2 - forward_t62;
    const lane g_5_y = -d_2_y*mu_2 - forward_t69;
    const lane g_5_z = -d_2_z*mu_2 - forward_t75;
    const lane g_6_x = -d_3_x*mu_3 - forward_t63;
    const lane g_6_y = -d_3_y*mu_3 - forward_t70;
    const lane g_6_z = -d_3_z*mu_3 - forward_t76;
    const lane g_7_x = -d_4_x*mu_4 - forward_t64;
    const lane g_7_y = -d_4_y*mu_4 - forward_t71;
    const lane g_7_z = -d_4_z*mu_4 - forward_t77;
    const lane g_8_x = -d_5_x*mu_5 - forward_t65;
    const lane g_8_y = -d_5_y*mu_5 - forward_t72;
    const lane g_8_z = -d_5_z*mu_5 - forward_t78;
    const lane g_9_x = -d_6_x*mu_6 - forward_t66;
    const lane g_9_y = -d_6_y*mu_6 - forward_t73;
    const lane g_9_z = -d_6_z*mu_6 - forward_t79;
    const double g_10_x = -forward_t82;
    const double g_10_y = -forward_t84;
    const double g_10_z = -forward_t80;
    const double g_11_x = -forward_t83;
    const double g_11_y = -forward_t85;
    const double g_11_z = -forward_t81;
    const lane L_x_x = -mu_1 - mu_2 - mu_3 - mu_4 - mu_5 - mu_6;
    const lane forward_t86 = B_1_z*mu_1;
    const lane forward_t87 = B_2_z*mu_2;
    const lane forward_t88 = B_3_z*mu_3;
    const lane forward_t89 = B_4_z*mu_4;
    const lane forward_t90 = B_5_z*mu_5;
    const lane forward_t91 = B_6_z*mu_6;
    const lane L_y_rx = forward_t86 + forward_t87 + forward_t88 + forward_t89 + forward_t90 + forward_t91;
    const lane L_x_ry = -L_y_rx;
    const lane forward_t92 = B_2_y*mu_2;
    const lane forward_t93 = B_3_y*mu_3;
    const lane forward_t94 = B_4_y*mu_4;
    const lane forward_t95 = B_5_y*mu_5;
    const lane forward_t96 = B_6_y*mu_6;
    const lane forward_t97 = B_1_y*mu_1;
    const lane L_x_rz = forward_t92 + forward_t93 + forward_t94 + forward_t95 + forward_t96 + forward_t97;
    const lane L_z_ry = B_1_x*mu_1 + B_2_x*mu_2 + B_3_x*mu_3 + B_4_x*mu_4 + B_5_x*mu_5 + B_6_x*mu_6;
    const lane L_y_rz = -L_z_ry;
    const lane L_z_rx = -L_x_rz;
    const lane forward_t98 = (B_1_z*B_1_z);
    const lane forward_t99 = (B_2_z*B_2_z);
    const lane forward_t100 = (B_3_z*B_3_z);
    const lane forward_t101 = (B_4_z*B_4_z);
    const lane forward_t102 = (B_5_z*B_5_z);
    const lane forward_t103 = (B_6_z*B_6_z);
    const lane forward_t104 =
        B_1_z*g_4_z + B_2_z*g_5_z + B_3_z*g_6_z + B_4_z*g_7_z + B_5_z*g_8_z + B_6_z*g_9_z + c_z*g_10_z
        + forward_t100*mu_3 + forward_t101*mu_4 + forward_t102*mu_5 + forward_t103*mu_6 + forward_t98*mu_1
        + forward_t99*mu_2 + g_11_z*o_L_z;
    const lane forward_t105 = (B_1_y*B_1_y);
    const lane forward_t106 = (B_2_y*B_2_y);
    const lane forward_t107 = (B_3_y*B_3_y);
    const lane forward_t108 = (B_4_y*B_4_y);
    const lane forward_t109 = (B_5_y*B_5_y);
    const lane forward_t110 = (B_6_y*B_6_y);
    const lane forward_t111 =
        B_1_y*g_4_y + B_2_y*g_5_y + B_3_y*g_6_y + B_4_y*g_7_y + B_5_y*g_8_y + B_6_y*g_9_y + c_y*g_10_y
        + forward_t105*mu_1 + forward_t106*mu_2 + forward_t107*mu_3 + forward_t108*mu_4 + forward_t109*mu_5
        + forward_t110*mu_6 + g_11_y*o_L_y;
    const lane L_rx_rx = -forward_t104 - forward_t111;
    const lane forward_t112 = (1.0/2.0)*B_1_x;
    const lane forward_t113 = (1.0/2.0)*g_4_x;
    const lane forward_t114 = (1.0/2.0)*B_2_x;
    const lane forward_t115 = (1.0/2.0)*g_5_x;
    const lane forward_t116 = (1.0/2.0)*B_3_x;
    const lane forward_t117 = (1.0/2.0)*g_6_x;
    const lane forward_t118 = (1.0/2.0)*B_4_x;
    const lane forward_t119 = (1.0/2.0)*g_7_x;
    const lane forward_t120 = (1.0/2.0)*B_5_x;
    const lane forward_t121 = (1.0/2.0)*g_8_x;
    const lane forward_t122 = (1.0/2.0)*B_6_x;
    const lane forward_t123 = (1.0/2.0)*g_9_x;
    const lane forward_t124 = (1.0/2.0)*c_x;
    const double forward_t125 = (1.0/2.0)*g_10_x;
    const double forward_t126 = (1.0/2.0)*g_11_x;
    const lane forward_t127 = (1.0/2.0)*o_L_x;
    const lane L_rx_ry =
        B_1_x*forward_t97 + B_1_y*forward_t113 + B_2_x*forward_t92 + B_2_y*forward_t115 + B_3_x*forward_t93
        + B_3_y*forward_t117 + B_4_x*forward_t94 + B_4_y*forward_t119 + B_5_x*forward_t95
        + B_5_y*forward_t121 + B_6_x*forward_t96 + B_6_y*forward_t123 + c_y*forward_t125 + forward_t112*g_4_y
        + forward_t114*g_5_y + forward_t116*g_6_y + forward_t118*g_7_y + forward_t120*g_8_y
        + forward_t122*g_9_y + forward_t124*g_10_y + forward_t126*o_L_y + forward_t127*g_11_y;
    const lane L_rx_rz =
        B_1_x*forward_t86 + B_1_z*forward_t113 + B_2_x*forward_t87 + B_2_z*forward_t115 + B_3_x*forward_t88
        + B_3_z*forward_t117 + B_4_x*forward_t89 + B_4_z*forward_t119 + B_5_x*forward_t90
        + B_5_z*forward_t121 + B_6_x*forward_t91 + B_6_z*forward_t123 + c_z*forward_t125 + forward_t112*g_4_z
        + forward_t114*g_5_z + forward_t116*g_6_z + forward_t118*g_7_z + forward_t120*g_8_z
        + forward_t122*g_9_z + forward_t124*g_10_z + forward_t126*o_L_z + forward_t127*g_11_z;
    const lane forward_t128 = (B_1_x*B_1_x);
    const lane forward_t129 = (B_2_x*B_2_x);
    const lane forward_t130 = (B_3_x*B_3_x);
    const lane forward_t131 = (B_4_x*B_4_x);
    const lane forward_t132 = (B_5_x*B_5_x);
    const lane forward_t133 = (B_6_x*B_6_x);
    const lane forward_t134 =
        B_1_x*g_4_x + B_2_x*g_5_x + B_3_x*g_6_x + B_4_x*g_7_x + B_5_x*g_8_x + B_6_x*g_9_x + c_x*g_10_x
        + forward_t128*mu_1 + forward_t129*mu_2 + forward_t130*mu_3 + forward_t131*mu_4 + forward_t132*mu_5
        + forward_t133*mu_6 + g_11_x*o_L_x;
    const lane L_ry_ry = -forward_t104 - forward_t134;
    const lane t62 = (1.0/2.0)*g_5_z;
    const lane t63 = (1.0/2.0)*B_2_z;
    const lane t64 = (1.0/2.0)*g_6_z;
    const lane t65 = (1.0/2.0)*B_3_z;
    const lane t66 = (1.0/2.0)*g_7_z;
    const lane t67 = (1.0/2.0)*B_4_z;
    const lane t68 = (1.0/2.0)*g_8_z;
    const lane t69 = (1.0/2.0)*B_5_z;
    const lane t70 = (1.0/2.0)*g_9_z;
    const lane t71 = (1.0/2.0)*B_6_z;
    const lane t72 = (1.0/2.0)*c_y;
    const lane t73 = (1.0/2.0)*c_z;
    const double t74 = (1.0/2.0)*g_11_y;
    const double t75 = (1.0/2.0)*g_11_z;
    const lane t76 = (1.0/2.0)*g_4_z;
    const lane t77 = (1.0/2.0)*B_1_z;
    const lane L_ry_rz =
        B_1_y*forward_t86 + B_1_y*t76 + B_2_y*forward_t87 + B_2_y*t62 + B_3_y*forward_t88 + B_3_y*t64
        + B_4_y*forward_t89 + B_4_y*t66 + B_5_y*forward_t90 + B_5_y*t68 + B_6_y*forward_t91 + B_6_y*t70
        + g_10_y*t73 + g_10_z*t72 + g_4_y*t77 + g_5_y*t63 + g_6_y*t65 + g_7_y*t67 + g_8_y*t69 + g_9_y*t71
        + o_L_y*t75 + o_L_z*t74;
    const lane L_rz_rz = -forward_t111 - forward_t134;
    const lane forward_t135 = forward_10*forward_t32;
    const lane forward_t136 = forward_t135*g_x;
    const lane f_x_l_1 = D_p_ry_1*L_x_ry + D_p_rz_1*L_x_rz + D_p_x_1*L_x_x + forward_t136;
    const lane forward_t137 = forward_12*forward_t36;
    const lane forward_t138 = forward_t137*g_x;
    const lane f_x_l_2 = D_p_ry_2*L_x_ry + D_p_rz_2*L_x_rz + D_p_x_2*L_x_x + forward_t138;
    const lane forward_t139 = forward_14*forward_t40;
    const lane forward_t140 = forward_t139*g_x;
    const lane f_x_l_3 = D_p_ry_3*L_x_ry + D_p_rz_3*L_x_rz + D_p_x_3*L_x_x + forward_t140;
    const lane forward_t141 = forward_16*forward_t44;
    const lane forward_t142 = forward_t141*g_x;
    const lane f_x_l_4 = D_p_ry_4*L_x_ry + D_p_rz_4*L_x_rz + D_p_x_4*L_x_x + forward_t142;
    const lane forward_t143 = forward_18*forward_t48;
    const lane forward_t144 = forward_t143*g_x;
    const lane f_x_l_5 = D_p_ry_5*L_x_ry + D_p_rz_5*L_x_rz + D_p_x_5*L_x_x + forward_t144;
    const lane forward_t145 = forward_20*forward_t52;
    const lane forward_t146 = forward_t145*g_x;
    const lane f_x_l_6 = D_p_ry_6*L_x_ry + D_p_rz_6*L_x_rz + D_p_x_6*L_x_x + forward_t146;
    const lane forward_t147 = forward_t135*g_y;
    const lane f_y_l_1 = D_p_rx_1*L_y_rx + D_p_rz_1*L_y_rz + D_p_y_1*L_x_x + forward_t147;
    const lane forward_t148 = forward_t137*g_y;
    const lane f_y_l_2 = D_p_rx_2*L_y_rx + D_p_rz_2*L_y_rz + D_p_y_2*L_x_x + forward_t148;
    const lane forward_t149 = forward_t139*g_y;
    const lane f_y_l_3 = D_p_rx_3*L_y_rx + D_p_rz_3*L_y_rz + D_p_y_3*L_x_x + forward_t149;
    const lane forward_t150 = forward_t141*g_y;
    const lane f_y_l_4 = D_p_rx_4*L_y_rx + D_p_rz_4*L_y_rz + D_p_y_4*L_x_x + forward_t150;
    const lane forward_t151 = forward_t143*g_y;
    const lane f_y_l_5 = D_p_rx_5*L_y_rx + D_p_rz_5*L_y_rz + D_p_y_5*L_x_x + forward_t151;
    const lane forward_t152 = forward_t145*g_y;
    const lane f_y_l_6 = D_p_rx_6*L_y_rx + D_p_rz_6*L_y_rz + D_p_y_6*L_x_x + forward_t152;
    const lane forward_t153 = forward_t135*g_z;
    const lane f_z_l_1 = D_p_rx_1*L_z_rx + D_p_ry_1*L_z_ry + D_p_z_1*L_x_x + forward_t153;
    const lane forward_t154 = forward_t137*g_z;
    const lane f_z_l_2 = D_p_rx_2*L_z_rx + D_p_ry_2*L_z_ry + D_p_z_2*L_x_x + forward_t154;
    const lane forward_t155 = forward_t139*g_z;
    const lane f_z_l_3 = D_p_rx_3*L_z_rx + D_p_ry_3*L_z_ry + D_p_z_3*L_x_x + forward_t155;
    const lane forward_t156 = forward_t141*g_z;
    const lane f_z_l_4 = D_p_rx_4*L_z_rx + D_p_ry_4*L_z_ry + D_p_z_4*L_x_x + forward_t156;
    const lane forward_t157 = forward_t143*g_z;
    const lane f_z_l_5 = D_p_rx_5*L_z_rx + D_p_ry_5*L_z_ry + D_p_z_5*L_x_x + forward_t157;
    const lane forward_t158 = forward_t145*g_z;
    const lane f_z_l_6 = D_p_rx_6*L_z_rx + D_p_ry_6*L_z_ry + D_p_z_6*L_x_x + forward_t158;
    const lane t78 = -B_1_y*g_z + B_1_z*g_y;
    const lane forward_t159 = forward_t135*t78;
    const lane f_rx_l_1 =
        D_p_rx_1*L_rx_rx + D_p_ry_1*L_rx_ry + D_p_rz_1*L_rx_rz + D_p_y_1*L_y_rx + D_p_z_1*L_z_rx
        - forward_t159;
    const lane t79 = -B_2_y*g_z + B_2_z*g_y;
    const lane forward_t160 = forward_t137*t79;
    const lane f_rx_l_2 =
        D_p_rx_2*L_rx_rx + D_p_ry_2*L_rx_ry + D_p_rz_2*L_rx_rz + D_p_y_2*L_y_rx + D_p_z_2*L_z_rx
        - forward_t160;
    const lane t80 = -B_3_y*g_z + B_3_z*g_y;
    const lane forward_t161 = forward_t139*t80;
    const lane f_rx_l_3 =
        D_p_rx_3*L_rx_rx + D_p_ry_3*L_rx_ry + D_p_rz_3*L_rx_rz + D_p_y_3*L_y_rx + D_p_z_3*L_z_rx
        - forward_t161;
    const lane t81 = -B_4_y*g_z + B_4_z*g_y;
    const lane forward_t162 = forward_t141*t81;
    const lane f_rx_l_4 =
        D_p_rx_4*L_rx_rx + D_p_ry_4*L_rx_ry + D_p_rz_4*L_rx_rz + D_p_y_4*L_y_rx + D_p_z_4*L_z_rx
        - forward_t162;
    const lane t82 = -B_5_y*g_z + B_5_z*g_y;
    const lane forward_t163 = forward_t143*t82;
    const lane f_rx_l_5 =
        D_p_rx_5*L_rx_rx + D_p_ry_5*L_rx_ry + D_p_rz_5*L_rx_rz + D_p_y_5*L_y_rx + D_p_z_5*L_z_rx
        - forward_t163;
    const lane t83 = -B_6_y*g_z + B_6_z*g_y;
    const lane forward_t164 = forward_t145*t83;
    const lane f_rx_l_6 =
        D_p_rx_6*L_rx_rx + D_p_ry_6*L_rx_ry + D_p_rz_6*L_rx_rz + D_p_y_6*L_y_rx + D_p_z_6*L_z_rx
        - forward_t164;
    const lane t84 = B_1_x*g_z - B_1_z*g_x;
    const lane forward_t165 = forward_t135*t84;
    const lane f_ry_l_1 =
        D_p_rx_1*L_rx_ry + D_p_ry_1*L_ry_ry + D_p_rz_1*L_ry_rz + D_p_x_1*L_x_ry + D_p_z_1*L_z_ry
        - forward_t165;
    const lane t85 = B_2_x*g_z - B_2_z*g_x;
    const lane forward_t166 = forward_t137*t85;
    const lane f_ry_l_2 =
        D_p_rx_2*L_rx_ry + D_p_ry_2*L_ry_ry + D_p_rz_2*L_ry_rz + D_p_x_2*L_x_ry + D_p_z_2*L_z_ry
        - forward_t166;
    const lane t86 = B_3_x*g_z - B_3_z*g_x;
    const lane forward_t167 = forward_t139*t86;
    const lane f_ry_l_3 =
        D_p_rx_3*L_rx_ry + D_p_ry_3*L_ry_ry + D_p_rz_3*L_ry_rz + D_p_x_3*L_x_ry + D_p_z_3*L_z_ry
        - forward_t167;
    const lane t87 = B_4_x*g_z - B_4_z*g_x;
    const lane forward_t168 = forward_t141*t87;
    const lane f_ry_l_4 =
        D_p_rx_4*L_rx_ry + D_p_ry_4*L_ry_ry + D_p_rz_4*L_ry_rz + D_p_x_4*L_x_ry + D_p_z_4*L_z_ry
        - forward_t168;
    const lane t88 = B_5_x*g_z - B_5_z*g_x;
    const lane forward_t169 = forward_t143*t88;
    const lane f_ry_l_5 =
        D_p_rx_5*L_rx_ry + D_p_ry_5*L_ry_ry + D_p_rz_5*L_ry_rz + D_p_x_5*L_x_ry + D_p_z_5*L_z_ry
        - forward_t169;
    const lane t89 = B_6_x*g_z - B_6_z*g_x;
    const lane forward_t170 = forward_t145*t89;
    const lane f_ry_l_6 =
        D_p_rx_6*L_rx_ry + D_p_ry_6*L_ry_ry + D_p_rz_6*L_ry_rz + D_p_x_6*L_x_ry + D_p_z_6*L_z_ry
        - forward_t170;
    const lane t90 = -B_1_x*g_y + B_1_y*g_x;
    const lane forward_t171 = forward_t135*t90;
    const lane f_rz_l_1 =
        D_p_rx_1*L_rx_rz + D_p_ry_1*L_ry_rz + D_p_rz_1*L_rz_rz + D_p_x_1*L_x_rz + D_p_y_1*L_y_rz
        - forward_t171;
    const lane t91 = -B_2_x*g_y + B_2_y*g_x;
    const lane forward_t172 = forward_t137*t91;
    const lane f_rz_l_2 =
        D_p_rx_2*L_rx_rz + D_p_ry_2*L_ry_rz + D_p_rz_2*L_rz_rz + D_p_x_2*L_x_rz + D_p_y_2*L_y_rz
        - forward_t172;
    const lane t92 = -B_3_x*g_y + B_3_y*g_x;
    const lane forward_t173 = forward_t139*t92;
    const lane f_rz_l_3 =
        D_p_rx_3*L_rx_rz + D_p_ry_3*L_ry_rz + D_p_rz_3*L_rz_rz + D_p_x_3*L_x_rz + D_p_y_3*L_y_rz
        - forward_t173;
    const lane t93 = -B_4_x*g_y + B_4_y*g_x;
    const lane forward_t174 = forward_t141*t93;
    const lane f_rz_l_4 =
        D_p_rx_4*L_rx_rz + D_p_ry_4*L_ry_rz + D_p_rz_4*L_rz_rz + D_p_x_4*L_x_rz + D_p_y_4*L_y_rz
        - forward_t174;
    const lane t94 = -B_5_x*g_y + B_5_y*g_x;
    const lane forward_t175 = forward_t143*t94;
    const lane f_rz_l_5 =
        D_p_rx_5*L_rx_rz + D_p_ry_5*L_ry_rz + D_p_rz_5*L_rz_rz + D_p_x_5*L_x_rz + D_p_y_5*L_y_rz
        - forward_t175;
    const lane t95 = -B_6_x*g_y + B_6_y*g_x;
    const lane forward_t176 = forward_t145*t95;
    const lane f_rz_l_6 =
        D_p_rx_6*L_rx_rz + D_p_ry_6*L_ry_rz + D_p_rz_6*L_rz_rz + D_p_x_6*L_x_rz + D_p_y_6*L_y_rz
        - forward_t176;
    const lane M_p_x_x = forward_t67 + m_perp_1 + m_perp_2 + m_perp_3 + m_perp_4 + m_perp_5 + m_perp_6;
    const lane forward_t177 = B_1_z*m_perp_1;
    const lane forward_t178 = B_2_z*m_perp_2;
    const lane forward_t179 = B_3_z*m_perp_3;
    const lane forward_t180 = B_4_z*m_perp_4;
    const lane forward_t181 = B_5_z*m_perp_5;
    const lane forward_t182 = B_6_z*m_perp_6;
    const lane forward_t183 = c_z*m_p;
    const lane forward_t184 = m_L*o_L_z;
    const lane M_p_x_ry =
        forward_t177 + forward_t178 + forward_t179 + forward_t180 + forward_t181 + forward_t182
        + forward_t183 + forward_t184;
    const lane forward_t185 = B_1_y*m_perp_1;
    const lane forward_t186 = B_2_y*m_perp_2;
    const lane forward_t187 = B_3_y*m_perp_3;
    const lane forward_t188 = B_4_y*m_perp_4;
    const lane forward_t189 = B_5_y*m_perp_5;
    const lane forward_t190 = B_6_y*m_perp_6;
    const lane forward_t191 = c_y*m_p;
    const lane forward_t192 = m_L*o_L_y;
    const lane M_p_z_rx =
        forward_t185 + forward_t186 + forward_t187 + forward_t188 + forward_t189 + forward_t190
        + forward_t191 + forward_t192;
    const lane M_p_x_rz = -M_p_z_rx;
    const lane M_p_y_rx = -M_p_x_ry;
    const lane forward_t193 = B_1_x*m_perp_1;
    const lane forward_t194 = B_2_x*m_perp_2;
    const lane forward_t195 = B_3_x*m_perp_3;
    const lane forward_t196 = B_4_x*m_perp_4;
    const lane forward_t197 = B_5_x*m_perp_5;
    const lane forward_t198 = B_6_x*m_perp_6;
    const lane M_p_y_rz =
        c_x*m_p + forward_t193 + forward_t194 + forward_t195 + forward_t196 + forward_t197 + forward_t198
        + m_L*o_L_x;
    const lane M_p_z_ry = -M_p_y_rz;
    const lane forward_t199 = 2.0*(o_L_y*o_L_y);
    const lane forward_t200 = 2.0*(o_L_z*o_L_z);
    const double forward_t201 = (1.0/2.0)*m_L;
    const lane forward_t202 = 2.0*(c_y*c_y);
    const lane forward_t203 = 2.0*(c_z*c_z);
    const double forward_t204 = (1.0/2.0)*m_p;
    const lane forward_t205 = 2.0*forward_t105;
    const lane forward_t206 = 2.0*forward_t98;
    const lane forward_t207 = (1.0/2.0)*m_perp_1;
    const lane forward_t208 = 2.0*forward_t106;
    const lane forward_t209 = 2.0*forward_t99;
    const lane forward_t210 = (1.0/2.0)*m_perp_2;
    const lane forward_t211 = 2.0*forward_t107;
    const lane forward_t212 = 2.0*forward_t100;
    const lane forward_t213 = (1.0/2.0)*m_perp_3;
    const lane forward_t214 = 2.0*forward_t108;
    const lane forward_t215 = 2.0*forward_t101;
    const lane forward_t216 = (1.0/2.0)*m_perp_4;
    const lane forward_t217 = 2.0*forward_t109;
    const lane forward_t218 = 2.0*forward_t102;
    const lane forward_t219 = (1.0/2.0)*m_perp_5;
    const lane forward_t220 = 2.0*forward_t110;
    const lane forward_t221 = 2.0*forward_t103;
    const lane forward_t222 = (1.0/2.0)*m_perp_6;
    const lane t96 = forward_t199 + forward_t200;
    const lane t97 = forward_t202 + forward_t203;
    const lane t98 = forward_t205 + forward_t206;
    const lane t99 = forward_t208 + forward_t209;
    const lane t100 = forward_t211 + forward_t212;
    const lane t101 = forward_t214 + forward_t215;
    const lane t102 = forward_t217 + forward_t218;
    const lane t103 = forward_t220 + forward_t221;
    const lane M_p_rx_rx =
        J_x_x + forward_t201*t96 + forward_t204*t97 + forward_t207*t98 + forward_t210*t99 + forward_t213*t100
        + forward_t216*t101 + forward_t219*t102 + forward_t222*t103;
    const lane M_p_rx_ry =
        -B_1_x*forward_t185 - B_2_x*forward_t186 - B_3_x*forward_t187 - B_4_x*forward_t188
        - B_5_x*forward_t189 - B_6_x*forward_t190 + J_x_y - c_x*forward_t191 - forward_t192*o_L_x;
    const lane M_p_rx_rz =
        -B_1_x*forward_t177 - B_2_x*forward_t178 - B_3_x*forward_t179 - B_4_x*forward_t180
        - B_5_x*forward_t181 - B_6_x*forward_t182 + J_x_z - c_x*forward_t183 - forward_t184*o_L_x;
    const lane forward_t223 = 2.0*(o_L_x*o_L_x);
    const lane forward_t224 = 2.0*(c_x*c_x);
    const lane forward_t225 = 2.0*forward_t128;
    const lane forward_t226 = 2.0*forward_t129;
    const lane forward_t227 = 2.0*forward_t130;
    const lane forward_t228 = 2.0*forward_t131;
    const lane forward_t229 = 2.0*forward_t132;
    const lane forward_t230 = 2.0*forward_t133;
    const lane t104 = forward_t200 + forward_t223;
    const lane t105 = forward_t203 + forward_t224;
    const lane t106 = forward_t206 + forward_t225;
    const lane t107 = forward_t209 + forward_t226;
    const lane t108 = forward_t212 + forward_t227;
    const lane t109 = forward_t215 + forward_t228;
    const lane t110 = forward_t218 + forward_t229;
    const lane t111 = forward_t221 + forward_t230;
    const lane M_p_ry_ry =
        J_y_y + forward_t201*t104 + forward_t204*t105 + forward_t207*t106 + forward_t210*t107
        + forward_t213*t108 + forward_t216*t109 + forward_t219*t110 + forward_t222*t111;
    const lane M_p_ry_rz =
        -B_1_y*forward_t177 - B_2_y*forward_t178 - B_3_y*forward_t179 - B_4_y*forward_t180
        - B_5_y*forward_t181 - B_6_y*forward_t182 + J_y_z - c_y*forward_t183 - forward_t184*o_L_y;
    const lane t112 = forward_t199 + forward_t223;
    const lane t113 = forward_t202 + forward_t224;
    const lane t114 = forward_t205 + forward_t225;
    const lane t115 = forward_t208 + forward_t226;
    const lane t116 = forward_t211 + forward_t227;
    const lane t117 = forward_t214 + forward_t228;
    const lane t118 = forward_t217 + forward_t229;
    const lane t119 = forward_t220 + forward_t230;
    const lane M_p_rz_rz =
        J_z_z + forward_t201*t112 + forward_t204*t113 + forward_t207*t114 + forward_t210*t115
        + forward_t213*t116 + forward_t216*t117 + forward_t219*t118 + forward_t222*t119;
    const lane h_x_l_1 = D_p_ry_1*M_p_x_ry + D_p_rz_1*M_p_x_rz + D_p_x_1*M_p_x_x;
    const lane h_x_l_2 = D_p_ry_2*M_p_x_ry + D_p_rz_2*M_p_x_rz + D_p_x_2*M_p_x_x;
    const lane h_x_l_3 = D_p_ry_3*M_p_x_ry + D_p_rz_3*M_p_x_rz + D_p_x_3*M_p_x_x;
    const lane h_x_l_4 = D_p_ry_4*M_p_x_ry + D_p_rz_4*M_p_x_rz + D_p_x_4*M_p_x_x;
    const lane h_x_l_5 = D_p_ry_5*M_p_x_ry + D_p_rz_5*M_p_x_rz + D_p_x_5*M_p_x_x;
    const lane h_x_l_6 = D_p_ry_6*M_p_x_ry + D_p_rz_6*M_p_x_rz + D_p_x_6*M_p_x_x;
    const lane forward_t231 =
        m_lift_1 + m_lift_2 + m_lift_3 + m_lift_4 + m_lift_5 + m_lift_6 - m_perp_1 - m_perp_2 - m_perp_3
        - m_perp_4 - m_perp_5 - m_perp_6;
    const lane h_x_u_x = M_p_x_x + forward_t231;
    const lane h_y_l_1 = D_p_rx_1*M_p_y_rx + D_p_rz_1*M_p_y_rz + D_p_y_1*M_p_x_x;
    const lane h_y_l_2 = D_p_rx_2*M_p_y_rx + D_p_rz_2*M_p_y_rz + D_p_y_2*M_p_x_x;
    const lane h_y_l_3 = D_p_rx_3*M_p_y_rx + D_p_rz_3*M_p_y_rz + D_p_y_3*M_p_x_x;
    const lane h_y_l_4 = D_p_rx_4*M_p_y_rx + D_p_rz_4*M_p_y_rz + D_p_y_4*M_p_x_x;
    const lane h_y_l_5 = D_p_rx_5*M_p_y_rx + D_p_rz_5*M_p_y_rz + D_p_y_5*M_p_x_x;
    const lane h_y_l_6 = D_p_rx_6*M_p_y_rx + D_p_rz_6*M_p_y_rz + D_p_y_6*M_p_x_x;
    const lane h_z_l_1 = D_p_rx_1*M_p_z_rx + D_p_ry_1*M_p_z_ry + D_p_z_1*M_p_x_x;
    const lane h_z_l_2 = D_p_rx_2*M_p_z_rx + D_p_ry_2*M_p_z_ry + D_p_z_2*M_p_x_x;
    const lane h_z_l_3 = D_p_rx_3*M_p_z_rx + D_p_ry_3*M_p_z_ry + D_p_z_3*M_p_x_x;
    const lane h_z_l_4 = D_p_rx_4*M_p_z_rx + D_p_ry_4*M_p_z_ry + D_p_z_4*M_p_x_x;
    const lane h_z_l_5 = D_p_rx_5*M_p_z_rx + D_p_ry_5*M_p_z_ry + D_p_z_5*M_p_x_x;
    const lane h_z_l_6 = D_p_rx_6*M_p_z_rx + D_p_ry_6*M_p_z_ry + D_p_z_6*M_p_x_x;
    const lane h_rx_l_1 =
        D_p_rx_1*M_p_rx_rx + D_p_ry_1*M_p_rx_ry + D_p_rz_1*M_p_rx_rz + D_p_y_1*M_p_y_rx + D_p_z_1*M_p_z_rx;
    const lane h_rx_l_2 =
        D_p_rx_2*M_p_rx_rx + D_p_ry_2*M_p_rx_ry + D_p_rz_2*M_p_rx_rz + D_p_y_2*M_p_y_rx + D_p_z_2*M_p_z_rx;
    const lane h_rx_l_3 =
        D_p_rx_3*M_p_rx_rx + D_p_ry_3*M_p_rx_ry + D_p_rz_3*M_p_rx_rz + D_p_y_3*M_p_y_rx + D_p_z_3*M_p_z_rx;
    const lane h_rx_l_4 =
        D_p_rx_4*M_p_rx_rx + D_p_ry_4*M_p_rx_ry + D_p_rz_4*M_p_rx_rz + D_p_y_4*M_p_y_rx + D_p_z_4*M_p_z_rx;
    const lane h_rx_l_5 =
        D_p_rx_5*M_p_rx_rx + D_p_ry_5*M_p_rx_ry + D_p_rz_5*M_p_rx_rz + D_p_y_5*M_p_y_rx + D_p_z_5*M_p_z_rx;
    const lane h_rx_l_6 =
        D_p_rx_6*M_p_rx_rx + D_p_ry_6*M_p_rx_ry + D_p_rz_6*M_p_rx_rz + D_p_y_6*M_p_y_rx + D_p_z_6*M_p_z_rx;
    const lane forward_t232 =
        B_1_z*forward_t33 + B_1_z*m_r_1 + B_2_z*forward_t37 + B_2_z*m_r_2 + B_3_z*forward_t41 + B_3_z*m_r_3
        + B_4_z*forward_t45 + B_4_z*m_r_4 + B_5_z*forward_t49 + B_5_z*m_r_5 + B_6_z*forward_t53 + B_6_z*m_r_6
        - forward_t177 - forward_t178 - forward_t179 - forward_t180 - forward_t181 - forward_t182;
    const lane h_rx_u_y = M_p_y_rx - forward_t232;
    const lane forward_t233 =
        B_1_y*forward_t33 + B_1_y*m_r_1 + B_2_y*forward_t37 + B_2_y*m_r_2 + B_3_y*forward_t41 + B_3_y*m_r_3
        + B_4_y*forward_t45 + B_4_y*m_r_4 + B_5_y*forward_t49 + B_5_y*m_r_5 + B_6_y*forward_t53 + B_6_y*m_r_6
        - forward_t185 - forward_t186 - forward_t187 - forward_t188 - forward_t189 - forward_t190;
    const lane h_rx_u_z = M_p_z_rx + forward_t233;
    const lane h_ry_l_1 =
        D_p_rx_1*M_p_rx_ry + D_p_ry_1*M_p_ry_ry + D_p_rz_1*M_p_ry_rz + D_p_x_1*M_p_x_ry + D_p_z_1*M_p_z_ry;
    const lane h_ry_l_2 =
        D_p_rx_2*M_p_rx_ry + D_p_ry_2*M_p_ry_ry + D_p_rz_2*M_p_ry_rz + D_p_x_2*M_p_x_ry + D_p_z_2*M_p_z_ry;
    const lane h_ry_l_3 =
        D_p_rx_3*M_p_rx_ry + D_p_ry_3*M_p_ry_ry + D_p_rz_3*M_p_ry_rz + D_p_x_3*M_p_x_ry + D_p_z_3*M_p_z_ry;
    const lane h_ry_l_4 =
        D_p_rx_4*M_p_rx_ry + D_p_ry_4*M_p_ry_ry + D_p_rz_4*M_p_ry_rz + D_p_x_4*M_p_x_ry + D_p_z_4*M_p_z_ry;
    const lane h_ry_l_5 =
        D_p_rx_5*M_p_rx_ry + D_p_ry_5*M_p_ry_ry + D_p_rz_5*M_p_ry_rz + D_p_x_5*M_p_x_ry + D_p_z_5*M_p_z_ry;
    const lane h_ry_l_6 =
        D_p_rx_6*M_p_rx_ry + D_p_ry_6*M_p_ry_ry + D_p_rz_6*M_p_ry_rz + D_p_x_6*M_p_x_ry + D_p_z_6*M_p_z_ry;
    const lane h_ry_u_x = M_p_x_ry + forward_t232;
    const lane forward_t234 =
        B_1_x*forward_t33 + B_1_x*m_r_1 + B_2_x*forward_t37 + B_2_x*m_r_2 + B_3_x*forward_t41 + B_3_x*m_r_3
        + B_4_x*forward_t45 + B_4_x*m_r_4 + B_5_x*forward_t49 + B_5_x*m_r_5 + B_6_x*forward_t53 + B_6_x*m_r_6
        - forward_t193 - forward_t194 - forward_t195 - forward_t196 - forward_t197 - forward_t198;
    const lane h_ry_u_z = M_p_z_ry - forward_t234;
    const lane h_rz_l_1 =
        D_p_rx_1*M_p_rx_rz + D_p_ry_1*M_p_ry_rz + D_p_rz_1*M_p_rz_rz + D_p_x_1*M_p_x_rz + D_p_y_1*M_p_y_rz;
    const lane h_rz_l_2 =
        D_p_rx_2*M_p_rx_rz + D_p_ry_2*M_p_ry_rz + D_p_rz_2*M_p_rz_rz + D_p_x_2*M_p_x_rz + D_p_y_2*M_p_y_rz;
    const lane h_rz_l_3 =
        D_p_rx_3*M_p_rx_rz + D_p_ry_3*M_p_ry_rz + D_p_rz_3*M_p_rz_rz + D_p_x_3*M_p_x_rz + D_p_y_3*M_p_y_rz;
    const lane h_rz_l_4 =
        D_p_rx_4*M_p_rx_rz + D_p_ry_4*M_p_ry_rz + D_p_rz_4*M_p_rz_rz + D_p_x_4*M_p_x_rz + D_p_y_4*M_p_y_rz;
    const lane h_rz_l_5 =
        D_p_rx_5*M_p_rx_rz + D_p_ry_5*M_p_ry_rz + D_p_rz_5*M_p_rz_rz + D_p_x_5*M_p_x_rz + D_p_y_5*M_p_y_rz;
    const lane h_rz_l_6 =
        D_p_rx_6*M_p_rx_rz + D_p_ry_6*M_p_ry_rz + D_p_rz_6*M_p_rz_rz + D_p_x_6*M_p_x_rz + D_p_y_6*M_p_y_rz;
    const lane h_rz_u_x = M_p_x_rz - forward_t233;
    const lane h_rz_u_y = M_p_y_rz + forward_t234;
    const lane forward_t236 = D_p_x_1*k_C;
    const lane forward_t237 = D_p_y_1*k_C;
    const lane forward_t238 = D_p_z_1*k_C;
    const lane forward_t239 = D_p_x_2*k_C;
    const lane forward_t240 = D_p_y_2*k_C;
    const lane forward_t241 = D_p_z_2*k_C;
    const lane forward_t242 = D_p_x_3*k_C;
    const lane forward_t243 = D_p_y_3*k_C;
    const lane forward_t244 = D_p_z_3*k_C;
    const lane forward_t245 = D_p_x_4*k_C;
    const lane forward_t246 = D_p_y_4*k_C;
    const lane forward_t247 = D_p_z_4*k_C;
    const lane forward_t248 = D_p_x_5*k_C;
    const lane forward_t249 = D_p_y_5*k_C;
    const lane forward_t250 = D_p_z_5*k_C;
    const double forward_23 = 1.0/((h_m_1*h_m_1));
    const double forward_24 = 1.0/((h_m_2*h_m_2));
    const double forward_25 = 1.0/((h_m_3*h_m_3));
    const double forward_26 = 1.0/((h_m_4*h_m_4));
    const double forward_27 = 1.0/((h_m_5*h_m_5));
    const double forward_28 = 1.0/((h_m_6*h_m_6));
    const lane forward_29 = 1.0/((forward_4*forward_4*forward_4));
    const lane forward_30 = 1.0/((forward_5*forward_5*forward_5));
    const lane forward_31 = 1.0/((forward_6*forward_6*forward_6));
    const lane forward_32 = 1.0/((forward_7*forward_7*forward_7));
    const lane forward_33 = 1.0/((forward_8*forward_8*forward_8));
    const lane forward_34 = 1.0/((forward_9*forward_9*forward_9));
    const lane t120 = (1.0/2.0)/forward_0;
    const lane t125 = rot_y*rot_z;
    const lane t126 = 1.0/forward_4;
    const lane t127 = 1.0/forward_5;
    const lane t128 = 1.0/forward_6;
    const lane t129 = 1.0/forward_7;
    const lane t130 = 1.0/forward_8;
    const lane t131 = 1.0/forward_9;
    const lane t132 = forward_t13 + forward_t15;
    const lane t134 = forward_t16 + forward_t17 + forward_t18;
    const lane t135 = forward_t12 + forward_t19 + forward_t20;
    const lane t136 = forward_t21 + t132;
    const lane t137 = forward_t23 + forward_t25;
    const lane t138 = I_p_y*R_y_y;
    const lane t139 = I_p_x*R_z_x;
    const lane t140 = forward_t27 + forward_t28;
    const lane t142 = 2.0*t22;
    const lane t144 = 2.0*t28;
    const lane t146 = 2.0*t34;
    const lane t148 = 2.0*t40;
    const lane t150 = 2.0*t46;
    const lane t152 = 2.0*t52;
    const lane t163 = G_p_rx*forward_22;
    const lane t164 = G_p_ry*forward_22;
    const lane t165 = G_p_rz*forward_22;
    const lane t166 = G_p_x*forward_22;
    const lane t167 = G_p_y*forward_22;
    const lane t168 = G_p_z*forward_22;
    const lane t191 = forward_29*forward_t32;
    const lane t192 = 2.0*t191;
    const lane t193 = -2.0*d_1_x*g_x - 2.0*d_1_y*g_y - 2.0*d_1_z*g_z;
    const lane t194 = forward_t136 + forward_t236;
    const lane t195 = forward_t147 + forward_t237;
    const lane t196 = forward_t153 + forward_t238;
    const lane t197 = forward_30*forward_t36;
    const lane t198 = 2.0*t197;
    const lane t199 = -2.0*d_2_x*g_x - 2.0*d_2_y*g_y - 2.0*d_2_z*g_z;
    const lane t200 = forward_t138 + forward_t239;
    const lane t201 = forward_t148 + forward_t240;
    const lane t202 = forward_t154 + forward_t241;
    const lane t203 = forward_31*forward_t40;
    const lane t204 = 2.0*t203;
    const lane t205 = -2.0*d_3_x*g_x - 2.0*d_3_y*g_y - 2.0*d_3_z*g_z;
    const lane t206 = forward_t140 + forward_t242;
    const lane t207 = forward_t149 + forward_t243;
    const lane t208 = forward_t155 + forward_t244;
    const lane t209 = forward_32*forward_t44;
    const lane t210 = 2.0*t209;
    const lane t211 = -2.0*d_4_x*g_x - 2.0*d_4_y*g_y - 2.0*d_4_z*g_z;
    const lane t212 = forward_t142 + forward_t245;
    const lane t213 = forward_t150 + forward_t246;
    const lane t214 = forward_t156 + forward_t247;
    const lane t215 = forward_33*forward_t48;
    const lane t216 = 2.0*t215;
    const lane t217 = -2.0*d_5_x*g_x - 2.0*d_5_y*g_y - 2.0*d_5_z*g_z;
    const lane t218 = forward_34*forward_t52;
    const lane t219 = 2.0*t218;
    const double t220 = 2.0*k_C;
    const lane t221 = -2.0*d_6_x*g_x - 2.0*d_6_y*g_y - 2.0*d_6_z*g_z;
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
        const lane along_14 = direction[13];
        const lane along_15 = direction[14];
        const lane along_16 = direction[15];
        const lane along_17 = direction[16];
        const lane along_18 = direction[17];
        const lane along_19 = direction[18];
        const lane along_20 = direction[19];
        const lane along_21 = direction[20];
        const lane along_22 = direction[21];
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
        const lane along_62 = direction[61];
        const lane along_63 = direction[62];
        const lane along_64 = direction[63];
        const lane along_65 = direction[64];
        const lane along_66 = direction[65];
        const lane along_67 = direction[66];
        const lane along_68 = direction[67];
        const lane along_69 = direction[68];
        const lane along_70 = direction[69];
        const lane along_71 = direction[70];
        const lane along_72 = direction[71];
        const lane along_73 = direction[72];
        const lane along_74 = direction[73];
        const lane along_75 = direction[74];
        const lane along_76 = direction[75];
        const lane along_77 = direction[76];
        const lane along_78 = direction[77];
        const lane along_79 = direction[78];
        const lane along_80 = direction[79];
        const lane along_81 = direction[80];
        const lane along_82 = direction[81];
        const lane along_83 = direction[82];
        const lane along_84 = direction[83];
        const lane along_85 = direction[84];
        const lane along_86 = direction[85];
        const lane along_87 = direction[86];
        const lane along_88 = direction[87];
        const lane along_89 = direction[88];
        const lane along_90 = direction[89];
        const lane along_91 = direction[90];
        const lane along_92 = direction[91];
        const lane along_93 = direction[92];
        const lane along_94 = direction[93];
        const lane along_95 = direction[94];
        const lane along_96 = direction[95];
        const lane along_97 = direction[96];
        const lane along_98 = direction[97];
        const lane along_99 = direction[98];
        const lane along_100 = direction[99];
        const lane along_101 = direction[100];
        const lane along_102 = direction[101];
        const lane along_103 = direction[102];
        const lane along_104 = direction[103];
        const lane along_105 = direction[104];
        const lane along_106 = direction[105];
        const lane along_107 = direction[106];
        const lane along_108 = direction[107];
        const lane along_109 = direction[108];
        const lane along_110 = direction[109];
        const lane along_111 = direction[110];
        const lane along_112 = direction[111];
        const lane along_113 = direction[112];
        const lane along_114 = direction[113];
        const lane along_115 = direction[114];
        const lane along_116 = direction[115];
        const lane along_117 = direction[116];
        const lane along_118 = direction[117];
        const lane along_119 = direction[118];
        const lane along_120 = direction[119];
        const lane along_121 = direction[120];
        const lane along_122 = direction[121];
        const lane along_124 = direction[123];
        const lane along_125 = direction[124];
        const lane along_126 = direction[125];
        const lane along_127 = direction[126];
        const lane along_128 = direction[127];
        const lane along_129 = direction[128];
        const lane along_131 = direction[130];
        const lane along_135 = direction[134];
        const lane along_136 = direction[135];
        const lane along_137 = direction[136];
        const lane along_138 = direction[137];
        const lane along_139 = direction[138];
        const lane along_140 = direction[139];
        const lane tangent_forward_t1 = 2.0*along_138*rot_x;
        const lane tangent_forward_t2 = 2.0*along_139*rot_y;
        const lane tangent_forward_t3 = 2.0*along_140*rot_z;
        const lane tangent_forward_t4 = tangent_forward_t2 + tangent_forward_t3;
        const lane tangent_forward_0 = t120*tangent_forward_t1 + t120*tangent_forward_t4;
        const lane tangent_half_angle = (1.0/2.0)*tangent_forward_0;
        const lane tangent_forward_1 = -(forward_1*forward_1)*tangent_half_angle;
        const lane tangent_forward_2 = forward_3*tangent_half_angle;
        const lane tangent_s_half = forward_1*tangent_forward_2 + forward_2*tangent_forward_1;
        const lane tangent_forward_t5 = 2.0*s_half*tangent_s_half;
        const lane tangent_forward_t6 = (1.0/2.0)*tangent_forward_t5;
        const lane tangent_R_x_x = -forward_t4*tangent_forward_t6 - forward_t6*tangent_forward_t4;
        const lane tangent_forward_3 = -forward_2*tangent_half_angle;
        const lane tangent_forward_t7 = forward_3*tangent_s_half + s_half*tangent_forward_3;
        const lane tangent_forward_t8 = along_140*forward_t7 + rot_z*tangent_forward_t7;
        const lane t121 = along_138*forward_t6;
        const lane t122 = rot_x*tangent_forward_t6;
        const lane tangent_R_x_y = along_139*t1 + rot_y*t121 + rot_y*t122 - tangent_forward_t8;
        const lane tangent_forward_t9 = along_139*forward_t7 + rot_y*tangent_forward_t7;
        const lane tangent_forward_t10 = along_138*forward_t6 + rot_x*tangent_forward_t6;
        const lane tangent_R_x_z = along_140*forward_t10 + rot_z*tangent_forward_t10 + tangent_forward_t9;
        const lane tangent_B_1_x =
            R_x_x*along_32 + R_x_y*along_33 + R_x_z*along_34 + b_1_x*tangent_R_x_x + b_1_y*tangent_R_x_y
            + b_1_z*tangent_R_x_z;
        const lane tangent_d_1_x = along_135 - along_14 + tangent_B_1_x;
        const lane tangent_R_y_x = along_139*forward_t10 + rot_y*tangent_forward_t10 + tangent_forward_t8;
        const lane t123 = forward_t6*tangent_forward_t1;
        const lane tangent_R_y_y = -forward_t6*tangent_forward_t3 - t123 + t2*tangent_forward_t6;
        const lane tangent_forward_t11 = along_138*forward_t7 + rot_x*tangent_forward_t7;
        const lane t124 = along_140*rot_y;
        const lane tangent_R_y_z =
            along_139*forward_t6*rot_z + forward_t6*t124 + t125*tangent_forward_t6 - tangent_forward_t11;
        const lane tangent_B_1_y =
            R_y_x*along_32 + R_y_y*along_33 + R_y_z*along_34 + b_1_x*tangent_R_y_x + b_1_y*tangent_R_y_y
            + b_1_z*tangent_R_y_z;
        const lane tangent_d_1_y = along_136 - along_15 + tangent_B_1_y;
        const lane tangent_R_z_x = along_140*t1 + rot_z*t121 + rot_z*t122 - tangent_forward_t9;
        const lane tangent_R_z_y =
            along_139*t3 + forward_t6*t124 + t125*tangent_forward_t6 + tangent_forward_t11;
        const lane tangent_R_z_z = -forward_t6*tangent_forward_t2 - t123 + t4*tangent_forward_t6;
        const lane tangent_B_1_z =
            R_z_x*along_32 + R_z_y*along_33 + R_z_z*along_34 + b_1_x*tangent_R_z_x + b_1_y*tangent_R_z_y
            + b_1_z*tangent_R_z_z;
        const lane tangent_d_1_z = along_137 - along_16 + tangent_B_1_z;
        const lane tangent_B_2_x =
            R_x_x*along_35 + R_x_y*along_36 + R_x_z*along_37 + b_2_x*tangent_R_x_x + b_2_y*tangent_R_x_y
            + b_2_z*tangent_R_x_z;
        const lane tangent_d_2_x = along_135 - along_17 + tangent_B_2_x;
        const lane tangent_B_2_y =
            R_y_x*along_35 + R_y_y*along_36 + R_y_z*along_37 + b_2_x*tangent_R_y_x + b_2_y*tangent_R_y_y
            + b_2_z*tangent_R_y_z;
        const lane tangent_d_2_y = along_136 - along_18 + tangent_B_2_y;
        const lane tangent_B_2_z =
            R_z_x*along_35 + R_z_y*along_36 + R_z_z*along_37 + b_2_x*tangent_R_z_x + b_2_y*tangent_R_z_y
            + b_2_z*tangent_R_z_z;
        const lane tangent_d_2_z = along_137 - along_19 + tangent_B_2_z;
        const lane tangent_B_3_x =
            R_x_x*along_38 + R_x_y*along_39 + R_x_z*along_40 + b_3_x*tangent_R_x_x + b_3_y*tangent_R_x_y
            + b_3_z*tangent_R_x_z;
        const lane tangent_d_3_x = along_135 - along_20 + tangent_B_3_x;
        const lane tangent_B_3_y =
            R_y_x*along_38 + R_y_y*along_39 + R_y_z*along_40 + b_3_x*tangent_R_y_x + b_3_y*tangent_R_y_y
            + b_3_z*tangent_R_y_z;
        const lane tangent_d_3_y = along_136 - along_21 + tangent_B_3_y;
        const lane tangent_B_3_z =
            R_z_x*along_38 + R_z_y*along_39 + R_z_z*along_40 + b_3_x*tangent_R_z_x + b_3_y*tangent_R_z_y
            + b_3_z*tangent_R_z_z;
        const lane tangent_d_3_z = along_137 - along_22 + tangent_B_3_z;
        const lane tangent_B_4_x =
            R_x_x*along_41 + R_x_y*along_42 + R_x_z*along_43 + b_4_x*tangent_R_x_x + b_4_y*tangent_R_x_y
            + b_4_z*tangent_R_x_z;
        const lane tangent_d_4_x = along_135 - along_23 + tangent_B_4_x;
        const lane tangent_B_4_y =
            R_y_x*along_41 + R_y_y*along_42 + R_y_z*along_43 + b_4_x*tangent_R_y_x + b_4_y*tangent_R_y_y
            + b_4_z*tangent_R_y_z;
        const lane tangent_d_4_y = along_136 - along_24 + tangent_B_4_y;
        const lane tangent_B_4_z =
            R_z_x*along_41 + R_z_y*along_42 + R_z_z*along_43 + b_4_x*tangent_R_z_x + b_4_y*tangent_R_z_y
            + b_4_z*tangent_R_z_z;
        const lane tangent_d_4_z = along_137 - along_25 + tangent_B_4_z;
        const lane tangent_B_5_x =
            R_x_x*along_44 + R_x_y*along_45 + R_x_z*along_46 + b_5_x*tangent_R_x_x + b_5_y*tangent_R_x_y
            + b_5_z*tangent_R_x_z;
        const lane tangent_d_5_x = along_135 - along_26 + tangent_B_5_x;
        const lane tangent_B_5_y =
            R_y_x*along_44 + R_y_y*along_45 + R_y_z*along_46 + b_5_x*tangent_R_y_x + b_5_y*tangent_R_y_y
            + b_5_z*tangent_R_y_z;
        const lane tangent_d_5_y = along_136 - along_27 + tangent_B_5_y;
        const lane tangent_B_5_z =
            R_z_x*along_44 + R_z_y*along_45 + R_z_z*along_46 + b_5_x*tangent_R_z_x + b_5_y*tangent_R_z_y
            + b_5_z*tangent_R_z_z;
        const lane tangent_d_5_z = along_137 - along_28 + tangent_B_5_z;
        const lane tangent_B_6_x =
            R_x_x*along_47 + R_x_y*along_48 + R_x_z*along_49 + b_6_x*tangent_R_x_x + b_6_y*tangent_R_x_y
            + b_6_z*tangent_R_x_z;
        const lane tangent_d_6_x = along_135 - along_29 + tangent_B_6_x;
        const lane tangent_B_6_y =
            R_y_x*along_47 + R_y_y*along_48 + R_y_z*along_49 + b_6_x*tangent_R_y_x + b_6_y*tangent_R_y_y
            + b_6_z*tangent_R_y_z;
        const lane tangent_d_6_y = along_136 - along_30 + tangent_B_6_y;
        const lane tangent_B_6_z =
            R_z_x*along_47 + R_z_y*along_48 + R_z_z*along_49 + b_6_x*tangent_R_z_x + b_6_y*tangent_R_z_y
            + b_6_z*tangent_R_z_z;
        const lane tangent_d_6_z = along_137 - along_31 + tangent_B_6_z;
        const lane tangent_forward_4 =
            d_1_x*t126*tangent_d_1_x + d_1_y*t126*tangent_d_1_y + d_1_z*t126*tangent_d_1_z;
        const lane tangent_forward_5 =
            d_2_x*t127*tangent_d_2_x + d_2_y*t127*tangent_d_2_y + d_2_z*t127*tangent_d_2_z;
        const lane tangent_forward_6 =
            d_3_x*t128*tangent_d_3_x + d_3_y*t128*tangent_d_3_y + d_3_z*t128*tangent_d_3_z;
        const lane tangent_forward_7 =
            d_4_x*t129*tangent_d_4_x + d_4_y*t129*tangent_d_4_y + d_4_z*t129*tangent_d_4_z;
        const lane tangent_forward_8 =
            d_5_x*t130*tangent_d_5_x + d_5_y*t130*tangent_d_5_y + d_5_z*t130*tangent_d_5_z;
        const lane tangent_forward_9 =
            d_6_x*t131*tangent_d_6_x + d_6_y*t131*tangent_d_6_y + d_6_z*t131*tangent_d_6_z;
        const lane tangent_c_x =
            R_x_x*along_2 + R_x_y*along_3 + R_x_z*along_4 + c_p_x*tangent_R_x_x + c_p_y*tangent_R_x_y
            + c_p_z*tangent_R_x_z;
        const lane tangent_c_y =
            R_y_x*along_2 + R_y_y*along_3 + R_y_z*along_4 + c_p_x*tangent_R_y_x + c_p_y*tangent_R_y_y
            + c_p_z*tangent_R_y_z;
        const lane tangent_c_z =
            R_z_x*along_2 + R_z_y*along_3 + R_z_z*along_4 + c_p_x*tangent_R_z_x + c_p_y*tangent_R_z_y
            + c_p_z*tangent_R_z_z;
        const lane tangent_forward_t12 = I_p_xy*tangent_R_x_x + R_x_x*along_8;
        const lane tangent_forward_t13 = I_p_xz*tangent_R_x_x + R_x_x*along_9;
        const lane tangent_forward_t14 = 2.0*tangent_R_x_z;
        const lane tangent_forward_t15 = I_p_yz*tangent_R_x_y + R_x_y*along_10;
        const lane t133 = I_p_z*tangent_R_x_z;
        const lane tangent_J_x_x =
            2.0*R_x_y*tangent_forward_t12 + along_5*t6 + along_6*t7 + along_7*t8 + forward_t14*t133
            + forward_t14*tangent_forward_t13 + forward_t14*tangent_forward_t15
            + 2.0*forward_t16*tangent_R_x_x + t132*tangent_forward_t14 + tangent_R_x_y*(2.0*forward_t19 + t5);
        const lane tangent_forward_t16 = I_p_x*tangent_R_x_x + R_x_x*along_5;
        const lane tangent_forward_t17 = I_p_xy*tangent_R_x_y + R_x_y*along_8;
        const lane tangent_forward_t18 = I_p_xz*tangent_R_x_z + R_x_z*along_9;
        const lane tangent_forward_t19 = I_p_y*tangent_R_x_y + R_x_y*along_6;
        const lane tangent_forward_t20 = I_p_yz*tangent_R_x_z + R_x_z*along_10;
        const lane tangent_forward_t21 = R_x_z*along_7 + t133;
        const lane tangent_J_x_y =
            R_y_x*tangent_forward_t16 + R_y_x*tangent_forward_t17 + R_y_x*tangent_forward_t18
            + R_y_y*tangent_forward_t12 + R_y_y*tangent_forward_t19 + R_y_y*tangent_forward_t20
            + R_y_z*tangent_forward_t13 + R_y_z*tangent_forward_t15 + R_y_z*tangent_forward_t21
            + t134*tangent_R_y_x + t135*tangent_R_y_y + t136*tangent_R_y_z;
        const lane tangent_J_x_z =
            R_z_x*tangent_forward_t16 + R_z_x*tangent_forward_t17 + R_z_x*tangent_forward_t18
            + R_z_y*tangent_forward_t12 + R_z_y*tangent_forward_t19 + R_z_y*tangent_forward_t20
            + R_z_z*tangent_forward_t13 + R_z_z*tangent_forward_t15 + R_z_z*tangent_forward_t21
            + t134*tangent_R_z_x + t135*tangent_R_z_y + t136*tangent_R_z_z;
        const lane tangent_forward_t22 = I_p_xy*tangent_R_y_x + R_y_x*along_8;
        const lane tangent_forward_t23 = I_p_xz*tangent_R_y_x + R_y_x*along_9;
        const lane tangent_forward_t24 = 2.0*tangent_R_y_z;
        const lane tangent_forward_t25 = I_p_yz*tangent_R_y_y + R_y_y*along_10;
        const lane tangent_J_y_y =
            I_p_z*forward_t24*tangent_R_y_z + 2.0*R_y_y*tangent_forward_t22 + along_5*t10 + along_6*t11
            + along_7*t12 + forward_t24*tangent_forward_t23 + forward_t24*tangent_forward_t25
            + 2.0*t13*tangent_R_y_x + t137*tangent_forward_t24 + tangent_R_y_y*(2.0*t138 + t9);
        const lane tangent_forward_t26 = I_p_xy*tangent_R_z_x + R_z_x*along_8;
        const lane tangent_forward_t27 = I_p_xz*tangent_R_z_x + R_z_x*along_9;
        const lane tangent_forward_t28 = I_p_yz*tangent_R_z_y + R_z_y*along_10;
        const lane tangent_J_y_z =
            R_y_x*R_z_x*along_5 + R_y_y*R_z_y*along_6 + R_y_y*tangent_forward_t26 + R_y_z*R_z_z*along_7
            + R_y_z*tangent_forward_t27 + R_y_z*tangent_forward_t28 + R_z_y*tangent_forward_t22
            + R_z_z*tangent_forward_t23 + R_z_z*tangent_forward_t25 + t13*tangent_R_z_x + t139*tangent_R_y_x
            + tangent_R_y_y*(forward_t26 + t14) + tangent_R_y_z*(t140 + t15) + tangent_R_z_y*(forward_t22
            + t138) + tangent_R_z_z*(I_p_z*R_y_z + t137);
        const lane tangent_forward_t29 = 2.0*tangent_R_z_z;
        const lane tangent_J_z_z =
            I_p_z*forward_t29*tangent_R_z_z + 2.0*R_z_y*tangent_forward_t26 + along_5*t17 + along_6*t18
            + along_7*t19 + forward_t29*tangent_forward_t27 + forward_t29*tangent_forward_t28
            + 2.0*t139*tangent_R_z_x + t140*tangent_forward_t29 + tangent_R_z_y*(2.0*t14 + t16);
        const lane tangent_forward_10 = -2.0*forward_29*tangent_forward_4;
        const lane tangent_forward_11 = -(forward_11*forward_11)*tangent_forward_4;
        const lane t141 = along_92*m_r_1;
        const lane tangent_m_perp_1 =
            along_68*forward_10*t20 + 2.0*along_74*forward_10*t24 + along_80*forward_10 + along_86*t23
            + along_98*forward_10 - forward_11*t141*t142 - t142*t25*tangent_forward_11
            + tangent_forward_10*(I_b_1 + I_r_1 + t21);
        const lane tangent_forward_t32 = along_68*c_b_1 + along_74*m_b_1 - along_86*c_r_1 - t141;
        const lane tangent_forward_t33 = forward_11*tangent_forward_t32 + forward_t32*tangent_forward_11;
        const lane tangent_m_lift_1 = along_86 + tangent_forward_t33;
        const lane tangent_forward_12 = -2.0*forward_30*tangent_forward_5;
        const lane tangent_forward_13 = -(forward_13*forward_13)*tangent_forward_5;
        const lane t143 = along_93*m_r_2;
        const lane tangent_m_perp_2 =
            along_69*forward_12*t26 + 2.0*along_75*forward_12*t30 + along_81*forward_12 + along_87*t29
            + along_99*forward_12 - forward_13*t143*t144 - t144*t31*tangent_forward_13
            + tangent_forward_12*(I_b_2 + I_r_2 + t27);
        const lane tangent_forward_t36 = along_69*c_b_2 + along_75*m_b_2 - along_87*c_r_2 - t143;
        const lane tangent_forward_t37 = forward_13*tangent_forward_t36 + forward_t36*tangent_forward_13;
        const lane tangent_m_lift_2 = along_87 + tangent_forward_t37;
        const lane tangent_forward_14 = -2.0*forward_31*tangent_forward_6;
        const lane tangent_forward_15 = -(forward_15*forward_15)*tangent_forward_6;
        const lane t145 = along_94*m_r_3;
        const lane tangent_m_perp_3 =
            along_100*forward_14 + along_70*forward_14*t32 + 2.0*along_76*forward_14*t36
            + along_82*forward_14 + along_88*t35 - forward_15*t145*t146 - t146*t37*tangent_forward_15
            + tangent_forward_14*(I_b_3 + I_r_3 + t33);
        const lane tangent_forward_t40 = along_70*c_b_3 + along_76*m_b_3 - along_88*c_r_3 - t145;
        const lane tangent_forward_t41 = forward_15*tangent_forward_t40 + forward_t40*tangent_forward_15;
        const lane tangent_m_lift_3 = along_88 + tangent_forward_t41;
        const lane tangent_forward_16 = -2.0*forward_32*tangent_forward_7;
        const lane tangent_forward_17 = -(forward_17*forward_17)*tangent_forward_7;
        const lane t147 = along_95*m_r_4;
        const lane tangent_m_perp_4 =
            along_101*forward_16 + along_71*forward_16*t38 + 2.0*along_77*forward_16*t42
            + along_83*forward_16 + along_89*t41 - forward_17*t147*t148 - t148*t43*tangent_forward_17
            + tangent_forward_16*(I_b_4 + I_r_4 + t39);
        const lane tangent_forward_t44 = along_71*c_b_4 + along_77*m_b_4 - along_89*c_r_4 - t147;
        const lane tangent_forward_t45 = forward_17*tangent_forward_t44 + forward_t44*tangent_forward_17;
        const lane tangent_m_lift_4 = along_89 + tangent_forward_t45;
        const lane tangent_forward_18 = -2.0*forward_33*tangent_forward_8;
        const lane tangent_forward_19 = -(forward_19*forward_19)*tangent_forward_8;
        const lane t149 = along_96*m_r_5;
        const lane tangent_m_perp_5 =
            along_102*forward_18 + along_72*forward_18*t44 + 2.0*along_78*forward_18*t48
            + along_84*forward_18 + along_90*t47 - forward_19*t149*t150 - t150*t49*tangent_forward_19
            + tangent_forward_18*(I_b_5 + I_r_5 + t45);
        const lane tangent_forward_t48 = along_72*c_b_5 + along_78*m_b_5 - along_90*c_r_5 - t149;
        const lane tangent_forward_t49 = forward_19*tangent_forward_t48 + forward_t48*tangent_forward_19;
        const lane tangent_m_lift_5 = along_90 + tangent_forward_t49;
        const lane tangent_forward_20 = -2.0*forward_34*tangent_forward_9;
        const lane tangent_forward_21 = -(forward_21*forward_21)*tangent_forward_9;
        const lane t151 = along_97*m_r_6;
        const lane tangent_m_perp_6 =
            along_103*forward_20 + along_73*forward_20*t50 + 2.0*along_79*forward_20*t54
            + along_85*forward_20 + along_91*t53 - forward_21*t151*t152 - t152*t55*tangent_forward_21
            + tangent_forward_20*(I_b_6 + I_r_6 + t51);
        const lane tangent_forward_t52 = along_73*c_b_6 + along_79*m_b_6 - along_91*c_r_6 - t151;
        const lane tangent_forward_t53 = forward_21*tangent_forward_t52 + forward_t52*tangent_forward_21;
        const lane tangent_m_lift_6 = along_91 + tangent_forward_t53;
        const lane tangent_o_L_x =
            R_x_x*along_126 + R_x_y*along_127 + R_x_z*along_128 + b_L_x*tangent_R_x_x + b_L_y*tangent_R_x_y
            + b_L_z*tangent_R_x_z;
        const lane tangent_o_L_y =
            R_y_x*along_126 + R_y_y*along_127 + R_y_z*along_128 + b_L_x*tangent_R_y_x + b_L_y*tangent_R_y_y
            + b_L_z*tangent_R_y_z;
        const lane tangent_o_L_z =
            R_z_x*along_126 + R_z_y*along_127 + R_z_z*along_128 + b_L_x*tangent_R_z_x + b_L_y*tangent_R_z_y
            + b_L_z*tangent_R_z_z;
        const lane tangent_D_l_1_rx =
            B_1_y*tangent_d_1_z - B_1_z*tangent_d_1_y - d_1_y*tangent_B_1_z + d_1_z*tangent_B_1_y;
        const lane tangent_D_l_1_ry =
            -B_1_x*tangent_d_1_z + B_1_z*tangent_d_1_x + d_1_x*tangent_B_1_z - d_1_z*tangent_B_1_x;
        const lane tangent_D_l_1_rz =
            B_1_x*tangent_d_1_y - B_1_y*tangent_d_1_x - d_1_x*tangent_B_1_y + d_1_y*tangent_B_1_x;
        const lane tangent_D_l_2_rx =
            B_2_y*tangent_d_2_z - B_2_z*tangent_d_2_y - d_2_y*tangent_B_2_z + d_2_z*tangent_B_2_y;
        const lane tangent_D_l_2_ry =
            -B_2_x*tangent_d_2_z + B_2_z*tangent_d_2_x + d_2_x*tangent_B_2_z - d_2_z*tangent_B_2_x;
        const lane tangent_D_l_2_rz =
            B_2_x*tangent_d_2_y - B_2_y*tangent_d_2_x - d_2_x*tangent_B_2_y + d_2_y*tangent_B_2_x;
        const lane tangent_D_l_3_rx =
            B_3_y*tangent_d_3_z - B_3_z*tangent_d_3_y - d_3_y*tangent_B_3_z + d_3_z*tangent_B_3_y;
        const lane tangent_D_l_3_ry =
            -B_3_x*tangent_d_3_z + B_3_z*tangent_d_3_x + d_3_x*tangent_B_3_z - d_3_z*tangent_B_3_x;
        const lane tangent_D_l_3_rz =
            B_3_x*tangent_d_3_y - B_3_y*tangent_d_3_x - d_3_x*tangent_B_3_y + d_3_y*tangent_B_3_x;
        const lane tangent_D_l_4_rx =
            B_4_y*tangent_d_4_z - B_4_z*tangent_d_4_y - d_4_y*tangent_B_4_z + d_4_z*tangent_B_4_y;
        const lane tangent_D_l_4_ry =
            -B_4_x*tangent_d_4_z + B_4_z*tangent_d_4_x + d_4_x*tangent_B_4_z - d_4_z*tangent_B_4_x;
        const lane tangent_D_l_4_rz =
            B_4_x*tangent_d_4_y - B_4_y*tangent_d_4_x - d_4_x*tangent_B_4_y + d_4_y*tangent_B_4_x;
        const lane tangent_D_l_5_rx =
            B_5_y*tangent_d_5_z - B_5_z*tangent_d_5_y - d_5_y*tangent_B_5_z + d_5_z*tangent_B_5_y;
        const lane tangent_D_l_5_ry =
            -B_5_x*tangent_d_5_z + B_5_z*tangent_d_5_x + d_5_x*tangent_B_5_z - d_5_z*tangent_B_5_x;
        const lane tangent_D_l_5_rz =
            B_5_x*tangent_d_5_y - B_5_y*tangent_d_5_x - d_5_x*tangent_B_5_y + d_5_y*tangent_B_5_x;
        const lane tangent_D_l_6_rx =
            B_6_y*tangent_d_6_z - B_6_z*tangent_d_6_y - d_6_y*tangent_B_6_z + d_6_z*tangent_B_6_y;
        const lane tangent_D_l_6_ry =
            -B_6_x*tangent_d_6_z + B_6_z*tangent_d_6_x + d_6_x*tangent_B_6_z - d_6_z*tangent_B_6_x;
        const lane tangent_D_l_6_rz =
            B_6_x*tangent_d_6_y - B_6_y*tangent_d_6_x - d_6_x*tangent_B_6_y + d_6_y*tangent_B_6_x;
        const lane tangent_minor_23_23 =
            d_2_y*tangent_d_3_z - d_2_z*tangent_d_3_y - d_3_y*tangent_d_2_z + d_3_z*tangent_d_2_y;
        const lane tangent_minor_56_56 =
            D_l_5_ry*tangent_D_l_6_rz - D_l_5_rz*tangent_D_l_6_ry - D_l_6_ry*tangent_D_l_5_rz
            + D_l_6_rz*tangent_D_l_5_ry;
        const lane tangent_minor_56_46 =
            D_l_5_rx*tangent_D_l_6_rz - D_l_5_rz*tangent_D_l_6_rx - D_l_6_rx*tangent_D_l_5_rz
            + D_l_6_rz*tangent_D_l_5_rx;
        const lane tangent_minor_56_45 =
            D_l_5_rx*tangent_D_l_6_ry - D_l_5_ry*tangent_D_l_6_rx - D_l_6_rx*tangent_D_l_5_ry
            + D_l_6_ry*tangent_D_l_5_rx;
        const lane tangent_minor_456_456 =
            D_l_4_rx*tangent_minor_56_56 - D_l_4_ry*tangent_minor_56_46 + D_l_4_rz*tangent_minor_56_45
            + minor_56_45*tangent_D_l_4_rz - minor_56_46*tangent_D_l_4_ry + minor_56_56*tangent_D_l_4_rx;
        const lane tangent_minor_23_24 =
            -D_l_2_rx*tangent_d_3_y + D_l_3_rx*tangent_d_2_y + d_2_y*tangent_D_l_3_rx
            - d_3_y*tangent_D_l_2_rx;
        const lane tangent_minor_56_36 =
            -D_l_5_rz*tangent_d_6_z + D_l_6_rz*tangent_d_5_z + d_5_z*tangent_D_l_6_rz
            - d_6_z*tangent_D_l_5_rz;
        const lane tangent_minor_56_35 =
            -D_l_5_ry*tangent_d_6_z + D_l_6_ry*tangent_d_5_z + d_5_z*tangent_D_l_6_ry
            - d_6_z*tangent_D_l_5_ry;
        const lane tangent_minor_456_356 =
            -D_l_4_ry*tangent_minor_56_36 + D_l_4_rz*tangent_minor_56_35 + d_4_z*tangent_minor_56_56
            + minor_56_35*tangent_D_l_4_rz - minor_56_36*tangent_D_l_4_ry + minor_56_56*tangent_d_4_z;
        const lane tangent_minor_23_25 =
            -D_l_2_ry*tangent_d_3_y + D_l_3_ry*tangent_d_2_y + d_2_y*tangent_D_l_3_ry
            - d_3_y*tangent_D_l_2_ry;
        const lane tangent_minor_56_34 =
            -D_l_5_rx*tangent_d_6_z + D_l_6_rx*tangent_d_5_z + d_5_z*tangent_D_l_6_rx
            - d_6_z*tangent_D_l_5_rx;
        const lane tangent_minor_456_346 =
            -D_l_4_rx*tangent_minor_56_36 + D_l_4_rz*tangent_minor_56_34 + d_4_z*tangent_minor_56_46
            + minor_56_34*tangent_D_l_4_rz - minor_56_36*tangent_D_l_4_rx + minor_56_46*tangent_d_4_z;
        const lane tangent_minor_23_26 =
            -D_l_2_rz*tangent_d_3_y + D_l_3_rz*tangent_d_2_y + d_2_y*tangent_D_l_3_rz
            - d_3_y*tangent_D_l_2_rz;
        const lane tangent_minor_456_345 =
            -D_l_4_rx*tangent_minor_56_35 + D_l_4_ry*tangent_minor_56_34 + d_4_z*tangent_minor_56_45
            + minor_56_34*tangent_D_l_4_ry - minor_56_35*tangent_D_l_4_rx + minor_56_45*tangent_d_4_z;
        const lane tangent_minor_23_34 =
            -D_l_2_rx*tangent_d_3_z + D_l_3_rx*tangent_d_2_z + d_2_z*tangent_D_l_3_rx
            - d_3_z*tangent_D_l_2_rx;
        const lane tangent_minor_56_26 =
            -D_l_5_rz*tangent_d_6_y + D_l_6_rz*tangent_d_5_y + d_5_y*tangent_D_l_6_rz
            - d_6_y*tangent_D_l_5_rz;
        const lane tangent_minor_56_25 =
            -D_l_5_ry*tangent_d_6_y + D_l_6_ry*tangent_d_5_y + d_5_y*tangent_D_l_6_ry
            - d_6_y*tangent_D_l_5_ry;
        const lane tangent_minor_456_256 =
            -D_l_4_ry*tangent_minor_56_26 + D_l_4_rz*tangent_minor_56_25 + d_4_y*tangent_minor_56_56
            + minor_56_25*tangent_D_l_4_rz - minor_56_26*tangent_D_l_4_ry + minor_56_56*tangent_d_4_y;
        const lane tangent_minor_23_35 =
            -D_l_2_ry*tangent_d_3_z + D_l_3_ry*tangent_d_2_z + d_2_z*tangent_D_l_3_ry
            - d_3_z*tangent_D_l_2_ry;
        const lane tangent_minor_56_24 =
            -D_l_5_rx*tangent_d_6_y + D_l_6_rx*tangent_d_5_y + d_5_y*tangent_D_l_6_rx
            - d_6_y*tangent_D_l_5_rx;
        const lane tangent_minor_456_246 =
            -D_l_4_rx*tangent_minor_56_26 + D_l_4_rz*tangent_minor_56_24 + d_4_y*tangent_minor_56_46
            + minor_56_24*tangent_D_l_4_rz - minor_56_26*tangent_D_l_4_rx + minor_56_46*tangent_d_4_y;
        const lane tangent_minor_23_36 =
            -D_l_2_rz*tangent_d_3_z + D_l_3_rz*tangent_d_2_z + d_2_z*tangent_D_l_3_rz
            - d_3_z*tangent_D_l_2_rz;
        const lane tangent_minor_456_245 =
            -D_l_4_rx*tangent_minor_56_25 + D_l_4_ry*tangent_minor_56_24 + d_4_y*tangent_minor_56_45
            + minor_56_24*tangent_D_l_4_ry - minor_56_25*tangent_D_l_4_rx + minor_56_45*tangent_d_4_y;
        const lane tangent_minor_23_45 =
            D_l_2_rx*tangent_D_l_3_ry - D_l_2_ry*tangent_D_l_3_rx - D_l_3_rx*tangent_D_l_2_ry
            + D_l_3_ry*tangent_D_l_2_rx;
        const lane tangent_minor_56_23 =
            d_5_y*tangent_d_6_z - d_5_z*tangent_d_6_y - d_6_y*tangent_d_5_z + d_6_z*tangent_d_5_y;
        const lane tangent_minor_456_236 =
            D_l_4_rz*tangent_minor_56_23 + d_4_y*tangent_minor_56_36 - d_4_z*tangent_minor_56_26
            + minor_56_23*tangent_D_l_4_rz - minor_56_26*tangent_d_4_z + minor_56_36*tangent_d_4_y;
        const lane tangent_minor_23_46 =
            D_l_2_rx*tangent_D_l_3_rz - D_l_2_rz*tangent_D_l_3_rx - D_l_3_rx*tangent_D_l_2_rz
            + D_l_3_rz*tangent_D_l_2_rx;
        const lane tangent_minor_456_235 =
            D_l_4_ry*tangent_minor_56_23 + d_4_y*tangent_minor_56_35 - d_4_z*tangent_minor_56_25
            + minor_56_23*tangent_D_l_4_ry - minor_56_25*tangent_d_4_z + minor_56_35*tangent_d_4_y;
        const lane tangent_minor_23_56 =
            D_l_2_ry*tangent_D_l_3_rz - D_l_2_rz*tangent_D_l_3_ry - D_l_3_ry*tangent_D_l_2_rz
            + D_l_3_rz*tangent_D_l_2_ry;
        const lane tangent_minor_456_234 =
            D_l_4_rx*tangent_minor_56_23 + d_4_y*tangent_minor_56_34 - d_4_z*tangent_minor_56_24
            + minor_56_23*tangent_D_l_4_rx - minor_56_24*tangent_d_4_z + minor_56_34*tangent_d_4_y;
        const lane tangent_A_x_1 =
            minor_23_23*tangent_minor_456_456 - minor_23_24*tangent_minor_456_356
            + minor_23_25*tangent_minor_456_346 - minor_23_26*tangent_minor_456_345
            + minor_23_34*tangent_minor_456_256 - minor_23_35*tangent_minor_456_246
            + minor_23_36*tangent_minor_456_245 + minor_23_45*tangent_minor_456_236
            - minor_23_46*tangent_minor_456_235 + minor_23_56*tangent_minor_456_234
            + minor_456_234*tangent_minor_23_56 - minor_456_235*tangent_minor_23_46
            + minor_456_236*tangent_minor_23_45 + minor_456_245*tangent_minor_23_36
            - minor_456_246*tangent_minor_23_35 + minor_456_256*tangent_minor_23_34
            - minor_456_345*tangent_minor_23_26 + minor_456_346*tangent_minor_23_25
            - minor_456_356*tangent_minor_23_24 + minor_456_456*tangent_minor_23_23;
        const lane tangent_minor_23_13 =
            d_2_x*tangent_d_3_z - d_2_z*tangent_d_3_x - d_3_x*tangent_d_2_z + d_3_z*tangent_d_2_x;
        const lane tangent_minor_23_14 =
            -D_l_2_rx*tangent_d_3_x + D_l_3_rx*tangent_d_2_x + d_2_x*tangent_D_l_3_rx
            - d_3_x*tangent_D_l_2_rx;
        const lane tangent_minor_23_15 =
            -D_l_2_ry*tangent_d_3_x + D_l_3_ry*tangent_d_2_x + d_2_x*tangent_D_l_3_ry
            - d_3_x*tangent_D_l_2_ry;
        const lane tangent_minor_23_16 =
            -D_l_2_rz*tangent_d_3_x + D_l_3_rz*tangent_d_2_x + d_2_x*tangent_D_l_3_rz
            - d_3_x*tangent_D_l_2_rz;
        const lane tangent_minor_56_16 =
            -D_l_5_rz*tangent_d_6_x + D_l_6_rz*tangent_d_5_x + d_5_x*tangent_D_l_6_rz
            - d_6_x*tangent_D_l_5_rz;
        const lane tangent_minor_56_15 =
            -D_l_5_ry*tangent_d_6_x + D_l_6_ry*tangent_d_5_x + d_5_x*tangent_D_l_6_ry
            - d_6_x*tangent_D_l_5_ry;
        const lane tangent_minor_456_156 =
            -D_l_4_ry*tangent_minor_56_16 + D_l_4_rz*tangent_minor_56_15 + d_4_x*tangent_minor_56_56
            + minor_56_15*tangent_D_l_4_rz - minor_56_16*tangent_D_l_4_ry + minor_56_56*tangent_d_4_x;
        const lane tangent_minor_56_14 =
            -D_l_5_rx*tangent_d_6_x + D_l_6_rx*tangent_d_5_x + d_5_x*tangent_D_l_6_rx
            - d_6_x*tangent_D_l_5_rx;
        const lane tangent_minor_456_146 =
            -D_l_4_rx*tangent_minor_56_16 + D_l_4_rz*tangent_minor_56_14 + d_4_x*tangent_minor_56_46
            + minor_56_14*tangent_D_l_4_rz - minor_56_16*tangent_D_l_4_rx + minor_56_46*tangent_d_4_x;
        const lane tangent_minor_456_145 =
            -D_l_4_rx*tangent_minor_56_15 + D_l_4_ry*tangent_minor_56_14 + d_4_x*tangent_minor_56_45
            + minor_56_14*tangent_D_l_4_ry - minor_56_15*tangent_D_l_4_rx + minor_56_45*tangent_d_4_x;
        const lane tangent_minor_56_13 =
            d_5_x*tangent_d_6_z - d_5_z*tangent_d_6_x - d_6_x*tangent_d_5_z + d_6_z*tangent_d_5_x;
        const lane tangent_minor_456_136 =
            D_l_4_rz*tangent_minor_56_13 + d_4_x*tangent_minor_56_36 - d_4_z*tangent_minor_56_16
            + minor_56_13*tangent_D_l_4_rz - minor_56_16*tangent_d_4_z + minor_56_36*tangent_d_4_x;
        const lane tangent_minor_456_135 =
            D_l_4_ry*tangent_minor_56_13 + d_4_x*tangent_minor_56_35 - d_4_z*tangent_minor_56_15
            + minor_56_13*tangent_D_l_4_ry - minor_56_15*tangent_d_4_z + minor_56_35*tangent_d_4_x;
        const lane tangent_minor_456_134 =
            D_l_4_rx*tangent_minor_56_13 + d_4_x*tangent_minor_56_34 - d_4_z*tangent_minor_56_14
            + minor_56_13*tangent_D_l_4_rx - minor_56_14*tangent_d_4_z + minor_56_34*tangent_d_4_x;
        const lane tangent_A_y_1 =
            -minor_23_13*tangent_minor_456_456 + minor_23_14*tangent_minor_456_356
            - minor_23_15*tangent_minor_456_346 + minor_23_16*tangent_minor_456_345
            - minor_23_34*tangent_minor_456_156 + minor_23_35*tangent_minor_456_146
            - minor_23_36*tangent_minor_456_145 - minor_23_45*tangent_minor_456_136
            + minor_23_46*tangent_minor_456_135 - minor_23_56*tangent_minor_456_134
            - minor_456_134*tangent_minor_23_56 + minor_456_135*tangent_minor_23_46
            - minor_456_136*tangent_minor_23_45 - minor_456_145*tangent_minor_23_36
            + minor_456_146*tangent_minor_23_35 - minor_456_156*tangent_minor_23_34
            + minor_456_345*tangent_minor_23_16 - minor_456_346*tangent_minor_23_15
            + minor_456_356*tangent_minor_23_14 - minor_456_456*tangent_minor_23_13;
        const lane tangent_minor_23_12 =
            d_2_x*tangent_d_3_y - d_2_y*tangent_d_3_x - d_3_x*tangent_d_2_y + d_3_y*tangent_d_2_x;
        const lane tangent_minor_56_12 =
            d_5_x*tangent_d_6_y - d_5_y*tangent_d_6_x - d_6_x*tangent_d_5_y + d_6_y*tangent_d_5_x;
        const lane tangent_minor_456_126 =
            D_l_4_rz*tangent_minor_56_12 + d_4_x*tangent_minor_56_26 - d_4_y*tangent_minor_56_16
            + minor_56_12*tangent_D_l_4_rz - minor_56_16*tangent_d_4_y + minor_56_26*tangent_d_4_x;
        const lane tangent_minor_456_125 =
            D_l_4_ry*tangent_minor_56_12 + d_4_x*tangent_minor_56_25 - d_4_y*tangent_minor_56_15
            + minor_56_12*tangent_D_l_4_ry - minor_56_15*tangent_d_4_y + minor_56_25*tangent_d_4_x;
        const lane tangent_minor_456_124 =
            D_l_4_rx*tangent_minor_56_12 + d_4_x*tangent_minor_56_24 - d_4_y*tangent_minor_56_14
            + minor_56_12*tangent_D_l_4_rx - minor_56_14*tangent_d_4_y + minor_56_24*tangent_d_4_x;
        const lane tangent_A_z_1 =
            minor_23_12*tangent_minor_456_456 - minor_23_14*tangent_minor_456_256
            + minor_23_15*tangent_minor_456_246 - minor_23_16*tangent_minor_456_245
            + minor_23_24*tangent_minor_456_156 - minor_23_25*tangent_minor_456_146
            + minor_23_26*tangent_minor_456_145 + minor_23_45*tangent_minor_456_126
            - minor_23_46*tangent_minor_456_125 + minor_23_56*tangent_minor_456_124
            + minor_456_124*tangent_minor_23_56 - minor_456_125*tangent_minor_23_46
            + minor_456_126*tangent_minor_23_45 + minor_456_145*tangent_minor_23_26
            - minor_456_146*tangent_minor_23_25 + minor_456_156*tangent_minor_23_24
            - minor_456_245*tangent_minor_23_16 + minor_456_246*tangent_minor_23_15
            - minor_456_256*tangent_minor_23_14 + minor_456_456*tangent_minor_23_12;
        const lane tangent_minor_456_123 =
            d_4_x*tangent_minor_56_23 - d_4_y*tangent_minor_56_13 + d_4_z*tangent_minor_56_12
            + minor_56_12*tangent_d_4_z - minor_56_13*tangent_d_4_y + minor_56_23*tangent_d_4_x;
        const lane tangent_A_rx_1 =
            -minor_23_12*tangent_minor_456_356 + minor_23_13*tangent_minor_456_256
            - minor_23_15*tangent_minor_456_236 + minor_23_16*tangent_minor_456_235
            - minor_23_23*tangent_minor_456_156 + minor_23_25*tangent_minor_456_136
            - minor_23_26*tangent_minor_456_135 - minor_23_35*tangent_minor_456_126
            + minor_23_36*tangent_minor_456_125 - minor_23_56*tangent_minor_456_123
            - minor_456_123*tangent_minor_23_56 + minor_456_125*tangent_minor_23_36
            - minor_456_126*tangent_minor_23_35 - minor_456_135*tangent_minor_23_26
            + minor_456_136*tangent_minor_23_25 - minor_456_156*tangent_minor_23_23
            + minor_456_235*tangent_minor_23_16 - minor_456_236*tangent_minor_23_15
            + minor_456_256*tangent_minor_23_13 - minor_456_356*tangent_minor_23_12;
        const lane tangent_A_ry_1 =
            minor_23_12*tangent_minor_456_346 - minor_23_13*tangent_minor_456_246
            + minor_23_14*tangent_minor_456_236 - minor_23_16*tangent_minor_456_234
            + minor_23_23*tangent_minor_456_146 - minor_23_24*tangent_minor_456_136
            + minor_23_26*tangent_minor_456_134 + minor_23_34*tangent_minor_456_126
            - minor_23_36*tangent_minor_456_124 + minor_23_46*tangent_minor_456_123
            + minor_456_123*tangent_minor_23_46 - minor_456_124*tangent_minor_23_36
            + minor_456_126*tangent_minor_23_34 + minor_456_134*tangent_minor_23_26
            - minor_456_136*tangent_minor_23_24 + minor_456_146*tangent_minor_23_23
            - minor_456_234*tangent_minor_23_16 + minor_456_236*tangent_minor_23_14
            - minor_456_246*tangent_minor_23_13 + minor_456_346*tangent_minor_23_12;
        const lane tangent_A_rz_1 =
            -minor_23_12*tangent_minor_456_345 + minor_23_13*tangent_minor_456_245
            - minor_23_14*tangent_minor_456_235 + minor_23_15*tangent_minor_456_234
            - minor_23_23*tangent_minor_456_145 + minor_23_24*tangent_minor_456_135
            - minor_23_25*tangent_minor_456_134 - minor_23_34*tangent_minor_456_125
            + minor_23_35*tangent_minor_456_124 - minor_23_45*tangent_minor_456_123
            - minor_456_123*tangent_minor_23_45 + minor_456_124*tangent_minor_23_35
            - minor_456_125*tangent_minor_23_34 - minor_456_134*tangent_minor_23_25
            + minor_456_135*tangent_minor_23_24 - minor_456_145*tangent_minor_23_23
            + minor_456_234*tangent_minor_23_15 - minor_456_235*tangent_minor_23_14
            + minor_456_245*tangent_minor_23_13 - minor_456_345*tangent_minor_23_12;
        const lane tangent_minor_13_23 =
            d_1_y*tangent_d_3_z - d_1_z*tangent_d_3_y - d_3_y*tangent_d_1_z + d_3_z*tangent_d_1_y;
        const lane tangent_minor_13_24 =
            -D_l_1_rx*tangent_d_3_y + D_l_3_rx*tangent_d_1_y + d_1_y*tangent_D_l_3_rx
            - d_3_y*tangent_D_l_1_rx;
        const lane tangent_minor_13_25 =
            -D_l_1_ry*tangent_d_3_y + D_l_3_ry*tangent_d_1_y + d_1_y*tangent_D_l_3_ry
            - d_3_y*tangent_D_l_1_ry;
        const lane tangent_minor_13_26 =
            -D_l_1_rz*tangent_d_3_y + D_l_3_rz*tangent_d_1_y + d_1_y*tangent_D_l_3_rz
            - d_3_y*tangent_D_l_1_rz;
        const lane tangent_minor_13_34 =
            -D_l_1_rx*tangent_d_3_z + D_l_3_rx*tangent_d_1_z + d_1_z*tangent_D_l_3_rx
            - d_3_z*tangent_D_l_1_rx;
        const lane tangent_minor_13_35 =
            -D_l_1_ry*tangent_d_3_z + D_l_3_ry*tangent_d_1_z + d_1_z*tangent_D_l_3_ry
            - d_3_z*tangent_D_l_1_ry;
        const lane tangent_minor_13_36 =
            -D_l_1_rz*tangent_d_3_z + D_l_3_rz*tangent_d_1_z + d_1_z*tangent_D_l_3_rz
            - d_3_z*tangent_D_l_1_rz;
        const lane tangent_minor_13_45 =
            D_l_1_rx*tangent_D_l_3_ry - D_l_1_ry*tangent_D_l_3_rx - D_l_3_rx*tangent_D_l_1_ry
            + D_l_3_ry*tangent_D_l_1_rx;
        const lane tangent_minor_13_46 =
            D_l_1_rx*tangent_D_l_3_rz - D_l_1_rz*tangent_D_l_3_rx - D_l_3_rx*tangent_D_l_1_rz
            + D_l_3_rz*tangent_D_l_1_rx;
        const lane tangent_minor_13_56 =
            D_l_1_ry*tangent_D_l_3_rz - D_l_1_rz*tangent_D_l_3_ry - D_l_3_ry*tangent_D_l_1_rz
            + D_l_3_rz*tangent_D_l_1_ry;
        const lane tangent_A_x_2 =
            -minor_13_23*tangent_minor_456_456 + minor_13_24*tangent_minor_456_356
            - minor_13_25*tangent_minor_456_346 + minor_13_26*tangent_minor_456_345
            - minor_13_34*tangent_minor_456_256 + minor_13_35*tangent_minor_456_246
            - minor_13_36*tangent_minor_456_245 - minor_13_45*tangent_minor_456_236
            + minor_13_46*tangent_minor_456_235 - minor_13_56*tangent_minor_456_234
            - minor_456_234*tangent_minor_13_56 + minor_456_235*tangent_minor_13_46
            - minor_456_236*tangent_minor_13_45 - minor_456_245*tangent_minor_13_36
            + minor_456_246*tangent_minor_13_35 - minor_456_256*tangent_minor_13_34
            + minor_456_345*tangent_minor_13_26 - minor_456_346*tangent_minor_13_25
            + minor_456_356*tangent_minor_13_24 - minor_456_456*tangent_minor_13_23;
        const lane tangent_minor_13_13 =
            d_1_x*tangent_d_3_z - d_1_z*tangent_d_3_x - d_3_x*tangent_d_1_z + d_3_z*tangent_d_1_x;
        const lane tangent_minor_13_14 =
            -D_l_1_rx*tangent_d_3_x + D_l_3_rx*tangent_d_1_x + d_1_x*tangent_D_l_3_rx
            - d_3_x*tangent_D_l_1_rx;
        const lane tangent_minor_13_15 =
            -D_l_1_ry*tangent_d_3_x + D_l_3_ry*tangent_d_1_x + d_1_x*tangent_D_l_3_ry
            - d_3_x*tangent_D_l_1_ry;
        const lane tangent_minor_13_16 =
            -D_l_1_rz*tangent_d_3_x + D_l_3_rz*tangent_d_1_x + d_1_x*tangent_D_l_3_rz
            - d_3_x*tangent_D_l_1_rz;
        const lane tangent_A_y_2 =
            minor_13_13*tangent_minor_456_456 - minor_13_14*tangent_minor_456_356
            + minor_13_15*tangent_minor_456_346 - minor_13_16*tangent_minor_456_345
            + minor_13_34*tangent_minor_456_156 - minor_13_35*tangent_minor_456_146
            + minor_13_36*tangent_minor_456_145 + minor_13_45*tangent_minor_456_136
            - minor_13_46*tangent_minor_456_135 + minor_13_56*tangent_minor_456_134
            + minor_456_134*tangent_minor_13_56 - minor_456_135*tangent_minor_13_46
            + minor_456_136*tangent_minor_13_45 + minor_456_145*tangent_minor_13_36
            - minor_456_146*tangent_minor_13_35 + minor_456_156*tangent_minor_13_34
            - minor_456_345*tangent_minor_13_16 + minor_456_346*tangent_minor_13_15
            - minor_456_356*tangent_minor_13_14 + minor_456_456*tangent_minor_13_13;
        const lane tangent_minor_13_12 =
            d_1_x*tangent_d_3_y - d_1_y*tangent_d_3_x - d_3_x*tangent_d_1_y + d_3_y*tangent_d_1_x;
        const lane tangent_A_z_2 =
            -minor_13_12*tangent_minor_456_456 + minor_13_14*tangent_minor_456_256
            - minor_13_15*tangent_minor_456_246 + minor_13_16*tangent_minor_456_245
            - minor_13_24*tangent_minor_456_156 + minor_13_25*tangent_minor_456_146
            - minor_13_26*tangent_minor_456_145 - minor_13_45*tangent_minor_456_126
            + minor_13_46*tangent_minor_456_125 - minor_13_56*tangent_minor_456_124
            - minor_456_124*tangent_minor_13_56 + minor_456_125*tangent_minor_13_46
            - minor_456_126*tangent_minor_13_45 - minor_456_145*tangent_minor_13_26
            + minor_456_146*tangent_minor_13_25 - minor_456_156*tangent_minor_13_24
            + minor_456_245*tangent_minor_13_16 - minor_456_246*tangent_minor_13_15
            + minor_456_256*tangent_minor_13_14 - minor_456_456*tangent_minor_13_12;
        const lane tangent_A_rx_2 =
            minor_13_12*tangent_minor_456_356 - minor_13_13*tangent_minor_456_256
            + minor_13_15*tangent_minor_456_236 - minor_13_16*tangent_minor_456_235
            + minor_13_23*tangent_minor_456_156 - minor_13_25*tangent_minor_456_136
            + minor_13_26*tangent_minor_456_135 + minor_13_35*tangent_minor_456_126
            - minor_13_36*tangent_minor_456_125 + minor_13_56*tangent_minor_456_123
            + minor_456_123*tangent_minor_13_56 - minor_456_125*tangent_minor_13_36
            + minor_456_126*tangent_minor_13_35 + minor_456_135*tangent_minor_13_26
            - minor_456_136*tangent_minor_13_25 + minor_456_156*tangent_minor_13_23
            - minor_456_235*tangent_minor_13_16 + minor_456_236*tangent_minor_13_15
            - minor_456_256*tangent_minor_13_13 + minor_456_356*tangent_minor_13_12;
        const lane tangent_A_ry_2 =
            -minor_13_12*tangent_minor_456_346 + minor_13_13*tangent_minor_456_246
            - minor_13_14*tangent_minor_456_236 + minor_13_16*tangent_minor_456_234
            - minor_13_23*tangent_minor_456_146 + minor_13_24*tangent_minor_456_136
            - minor_13_26*tangent_minor_456_134 - minor_13_34*tangent_minor_456_126
            + minor_13_36*tangent_minor_456_124 - minor_13_46*tangent_minor_456_123
            - minor_456_123*tangent_minor_13_46 + minor_456_124*tangent_minor_13_36
            - minor_456_126*tangent_minor_13_34 - minor_456_134*tangent_minor_13_26
            + minor_456_136*tangent_minor_13_24 - minor_456_146*tangent_minor_13_23
            + minor_456_234*tangent_minor_13_16 - minor_456_236*tangent_minor_13_14
            + minor_456_246*tangent_minor_13_13 - minor_456_346*tangent_minor_13_12;
        const lane tangent_A_rz_2 =
            minor_13_12*tangent_minor_456_345 - minor_13_13*tangent_minor_456_245
            + minor_13_14*tangent_minor_456_235 - minor_13_15*tangent_minor_456_234
            + minor_13_23*tangent_minor_456_145 - minor_13_24*tangent_minor_456_135
            + minor_13_25*tangent_minor_456_134 + minor_13_34*tangent_minor_456_125
            - minor_13_35*tangent_minor_456_124 + minor_13_45*tangent_minor_456_123
            + minor_456_123*tangent_minor_13_45 - minor_456_124*tangent_minor_13_35
            + minor_456_125*tangent_minor_13_34 + minor_456_134*tangent_minor_13_25
            - minor_456_135*tangent_minor_13_24 + minor_456_145*tangent_minor_13_23
            - minor_456_234*tangent_minor_13_15 + minor_456_235*tangent_minor_13_14
            - minor_456_245*tangent_minor_13_13 + minor_456_345*tangent_minor_13_12;
        const lane tangent_minor_12_23 =
            d_1_y*tangent_d_2_z - d_1_z*tangent_d_2_y - d_2_y*tangent_d_1_z + d_2_z*tangent_d_1_y;
        const lane tangent_minor_12_24 =
            -D_l_1_rx*tangent_d_2_y + D_l_2_rx*tangent_d_1_y + d_1_y*tangent_D_l_2_rx
            - d_2_y*tangent_D_l_1_rx;
        const lane tangent_minor_12_25 =
            -D_l_1_ry*tangent_d_2_y + D_l_2_ry*tangent_d_1_y + d_1_y*tangent_D_l_2_ry
            - d_2_y*tangent_D_l_1_ry;
        const lane tangent_minor_12_26 =
            -D_l_1_rz*tangent_d_2_y + D_l_2_rz*tangent_d_1_y + d_1_y*tangent_D_l_2_rz
            - d_2_y*tangent_D_l_1_rz;
        const lane tangent_minor_12_34 =
            -D_l_1_rx*tangent_d_2_z + D_l_2_rx*tangent_d_1_z + d_1_z*tangent_D_l_2_rx
            - d_2_z*tangent_D_l_1_rx;
        const lane tangent_minor_12_35 =
            -D_l_1_ry*tangent_d_2_z + D_l_2_ry*tangent_d_1_z + d_1_z*tangent_D_l_2_ry
            - d_2_z*tangent_D_l_1_ry;
        const lane tangent_minor_12_36 =
            -D_l_1_rz*tangent_d_2_z + D_l_2_rz*tangent_d_1_z + d_1_z*tangent_D_l_2_rz
            - d_2_z*tangent_D_l_1_rz;
        const lane tangent_minor_12_45 =
            D_l_1_rx*tangent_D_l_2_ry - D_l_1_ry*tangent_D_l_2_rx - D_l_2_rx*tangent_D_l_1_ry
            + D_l_2_ry*tangent_D_l_1_rx;
        const lane tangent_minor_12_46 =
            D_l_1_rx*tangent_D_l_2_rz - D_l_1_rz*tangent_D_l_2_rx - D_l_2_rx*tangent_D_l_1_rz
            + D_l_2_rz*tangent_D_l_1_rx;
        const lane tangent_minor_12_56 =
            D_l_1_ry*tangent_D_l_2_rz - D_l_1_rz*tangent_D_l_2_ry - D_l_2_ry*tangent_D_l_1_rz
            + D_l_2_rz*tangent_D_l_1_ry;
        const lane tangent_A_x_3 =
            minor_12_23*tangent_minor_456_456 - minor_12_24*tangent_minor_456_356
            + minor_12_25*tangent_minor_456_346 - minor_12_26*tangent_minor_456_345
            + minor_12_34*tangent_minor_456_256 - minor_12_35*tangent_minor_456_246
            + minor_12_36*tangent_minor_456_245 + minor_12_45*tangent_minor_456_236
            - minor_12_46*tangent_minor_456_235 + minor_12_56*tangent_minor_456_234
            + minor_456_234*tangent_minor_12_56 - minor_456_235*tangent_minor_12_46
            + minor_456_236*tangent_minor_12_45 + minor_456_245*tangent_minor_12_36
            - minor_456_246*tangent_minor_12_35 + minor_456_256*tangent_minor_12_34
            - minor_456_345*tangent_minor_12_26 + minor_456_346*tangent_minor_12_25
            - minor_456_356*tangent_minor_12_24 + minor_456_456*tangent_minor_12_23;
        const lane tangent_minor_12_13 =
            d_1_x*tangent_d_2_z - d_1_z*tangent_d_2_x - d_2_x*tangent_d_1_z + d_2_z*tangent_d_1_x;
        const lane tangent_minor_12_14 =
            -D_l_1_rx*tangent_d_2_x + D_l_2_rx*tangent_d_1_x + d_1_x*tangent_D_l_2_rx
            - d_2_x*tangent_D_l_1_rx;
        const lane tangent_minor_12_15 =
            -D_l_1_ry*tangent_d_2_x + D_l_2_ry*tangent_d_1_x + d_1_x*tangent_D_l_2_ry
            - d_2_x*tangent_D_l_1_ry;
        const lane tangent_minor_12_16 =
            -D_l_1_rz*tangent_d_2_x + D_l_2_rz*tangent_d_1_x + d_1_x*tangent_D_l_2_rz
            - d_2_x*tangent_D_l_1_rz;
        const lane tangent_A_y_3 =
            -minor_12_13*tangent_minor_456_456 + minor_12_14*tangent_minor_456_356
            - minor_12_15*tangent_minor_456_346 + minor_12_16*tangent_minor_456_345
            - minor_12_34*tangent_minor_456_156 + minor_12_35*tangent_minor_456_146
            - minor_12_36*tangent_minor_456_145 - minor_12_45*tangent_minor_456_136
            + minor_12_46*tangent_minor_456_135 - minor_12_56*tangent_minor_456_134
            - minor_456_134*tangent_minor_12_56 + minor_456_135*tangent_minor_12_46
            - minor_456_136*tangent_minor_12_45 - minor_456_145*tangent_minor_12_36
            + minor_456_146*tangent_minor_12_35 - minor_456_156*tangent_minor_12_34
            + minor_456_345*tangent_minor_12_16 - minor_456_346*tangent_minor_12_15
            + minor_456_356*tangent_minor_12_14 - minor_456_456*tangent_minor_12_13;
        const lane tangent_minor_12_12 =
            d_1_x*tangent_d_2_y - d_1_y*tangent_d_2_x - d_2_x*tangent_d_1_y + d_2_y*tangent_d_1_x;
        const lane tangent_A_z_3 =
            minor_12_12*tangent_minor_456_456 - minor_12_14*tangent_minor_456_256
            + minor_12_15*tangent_minor_456_246 - minor_12_16*tangent_minor_456_245
            + minor_12_24*tangent_minor_456_156 - minor_12_25*tangent_minor_456_146
            + minor_12_26*tangent_minor_456_145 + minor_12_45*tangent_minor_456_126
            - minor_12_46*tangent_minor_456_125 + minor_12_56*tangent_minor_456_124
            + minor_456_124*tangent_minor_12_56 - minor_456_125*tangent_minor_12_46
            + minor_456_126*tangent_minor_12_45 + minor_456_145*tangent_minor_12_26
            - minor_456_146*tangent_minor_12_25 + minor_456_156*tangent_minor_12_24
            - minor_456_245*tangent_minor_12_16 + minor_456_246*tangent_minor_12_15
            - minor_456_256*tangent_minor_12_14 + minor_456_456*tangent_minor_12_12;
        const lane tangent_A_rx_3 =
            -minor_12_12*tangent_minor_456_356 + minor_12_13*tangent_minor_456_256
            - minor_12_15*tangent_minor_456_236 + minor_12_16*tangent_minor_456_235
            - minor_12_23*tangent_minor_456_156 + minor_12_25*tangent_minor_456_136
            - minor_12_26*tangent_minor_456_135 - minor_12_35*tangent_minor_456_126
            + minor_12_36*tangent_minor_456_125 - minor_12_56*tangent_minor_456_123
            - minor_456_123*tangent_minor_12_56 + minor_456_125*tangent_minor_12_36
            - minor_456_126*tangent_minor_12_35 - minor_456_135*tangent_minor_12_26
            + minor_456_136*tangent_minor_12_25 - minor_456_156*tangent_minor_12_23
            + minor_456_235*tangent_minor_12_16 - minor_456_236*tangent_minor_12_15
            + minor_456_256*tangent_minor_12_13 - minor_456_356*tangent_minor_12_12;
        const lane tangent_A_ry_3 =
            minor_12_12*tangent_minor_456_346 - minor_12_13*tangent_minor_456_246
            + minor_12_14*tangent_minor_456_236 - minor_12_16*tangent_minor_456_234
            + minor_12_23*tangent_minor_456_146 - minor_12_24*tangent_minor_456_136
            + minor_12_26*tangent_minor_456_134 + minor_12_34*tangent_minor_456_126
            - minor_12_36*tangent_minor_456_124 + minor_12_46*tangent_minor_456_123
            + minor_456_123*tangent_minor_12_46 - minor_456_124*tangent_minor_12_36
            + minor_456_126*tangent_minor_12_34 + minor_456_134*tangent_minor_12_26
            - minor_456_136*tangent_minor_12_24 + minor_456_146*tangent_minor_12_23
            - minor_456_234*tangent_minor_12_16 + minor_456_236*tangent_minor_12_14
            - minor_456_246*tangent_minor_12_13 + minor_456_346*tangent_minor_12_12;
        const lane tangent_A_rz_3 =
            -minor_12_12*tangent_minor_456_345 + minor_12_13*tangent_minor_456_245
            - minor_12_14*tangent_minor_456_235 + minor_12_15*tangent_minor_456_234
            - minor_12_23*tangent_minor_456_145 + minor_12_24*tangent_minor_456_135
            - minor_12_25*tangent_minor_456_134 - minor_12_34*tangent_minor_456_125
            + minor_12_35*tangent_minor_456_124 - minor_12_45*tangent_minor_456_123
            - minor_456_123*tangent_minor_12_45 + minor_456_124*tangent_minor_12_35
            - minor_456_125*tangent_minor_12_34 - minor_456_134*tangent_minor_12_25
            + minor_456_135*tangent_minor_12_24 - minor_456_145*tangent_minor_12_23
            + minor_456_234*tangent_minor_12_15 - minor_456_235*tangent_minor_12_14
            + minor_456_245*tangent_minor_12_13 - minor_456_345*tangent_minor_12_12;
        const lane tangent_minor_123_234 =
            D_l_1_rx*tangent_minor_23_23 + d_1_y*tangent_minor_23_34 - d_1_z*tangent_minor_23_24
            + minor_23_23*tangent_D_l_1_rx - minor_23_24*tangent_d_1_z + minor_23_34*tangent_d_1_y;
        const lane tangent_minor_123_235 =
            D_l_1_ry*tangent_minor_23_23 + d_1_y*tangent_minor_23_35 - d_1_z*tangent_minor_23_25
            + minor_23_23*tangent_D_l_1_ry - minor_23_25*tangent_d_1_z + minor_23_35*tangent_d_1_y;
        const lane tangent_minor_123_236 =
            D_l_1_rz*tangent_minor_23_23 + d_1_y*tangent_minor_23_36 - d_1_z*tangent_minor_23_26
            + minor_23_23*tangent_D_l_1_rz - minor_23_26*tangent_d_1_z + minor_23_36*tangent_d_1_y;
        const lane tangent_minor_123_245 =
            -D_l_1_rx*tangent_minor_23_25 + D_l_1_ry*tangent_minor_23_24 + d_1_y*tangent_minor_23_45
            + minor_23_24*tangent_D_l_1_ry - minor_23_25*tangent_D_l_1_rx + minor_23_45*tangent_d_1_y;
        const lane tangent_minor_123_246 =
            -D_l_1_rx*tangent_minor_23_26 + D_l_1_rz*tangent_minor_23_24 + d_1_y*tangent_minor_23_46
            + minor_23_24*tangent_D_l_1_rz - minor_23_26*tangent_D_l_1_rx + minor_23_46*tangent_d_1_y;
        const lane tangent_minor_123_256 =
            -D_l_1_ry*tangent_minor_23_26 + D_l_1_rz*tangent_minor_23_25 + d_1_y*tangent_minor_23_56
            + minor_23_25*tangent_D_l_1_rz - minor_23_26*tangent_D_l_1_ry + minor_23_56*tangent_d_1_y;
        const lane tangent_minor_123_345 =
            -D_l_1_rx*tangent_minor_23_35 + D_l_1_ry*tangent_minor_23_34 + d_1_z*tangent_minor_23_45
            + minor_23_34*tangent_D_l_1_ry - minor_23_35*tangent_D_l_1_rx + minor_23_45*tangent_d_1_z;
        const lane tangent_minor_123_346 =
            -D_l_1_rx*tangent_minor_23_36 + D_l_1_rz*tangent_minor_23_34 + d_1_z*tangent_minor_23_46
            + minor_23_34*tangent_D_l_1_rz - minor_23_36*tangent_D_l_1_rx + minor_23_46*tangent_d_1_z;
        const lane tangent_minor_123_356 =
            -D_l_1_ry*tangent_minor_23_36 + D_l_1_rz*tangent_minor_23_35 + d_1_z*tangent_minor_23_56
            + minor_23_35*tangent_D_l_1_rz - minor_23_36*tangent_D_l_1_ry + minor_23_56*tangent_d_1_z;
        const lane tangent_minor_123_456 =
            D_l_1_rx*tangent_minor_23_56 - D_l_1_ry*tangent_minor_23_46 + D_l_1_rz*tangent_minor_23_45
            + minor_23_45*tangent_D_l_1_rz - minor_23_46*tangent_D_l_1_ry + minor_23_56*tangent_D_l_1_rx;
        const lane tangent_A_x_4 =
            -minor_123_234*tangent_minor_56_56 + minor_123_235*tangent_minor_56_46
            - minor_123_236*tangent_minor_56_45 - minor_123_245*tangent_minor_56_36
            + minor_123_246*tangent_minor_56_35 - minor_123_256*tangent_minor_56_34
            + minor_123_345*tangent_minor_56_26 - minor_123_346*tangent_minor_56_25
            + minor_123_356*tangent_minor_56_24 - minor_123_456*tangent_minor_56_23
            - minor_56_23*tangent_minor_123_456 + minor_56_24*tangent_minor_123_356
            - minor_56_25*tangent_minor_123_346 + minor_56_26*tangent_minor_123_345
            - minor_56_34*tangent_minor_123_256 + minor_56_35*tangent_minor_123_246
            - minor_56_36*tangent_minor_123_245 - minor_56_45*tangent_minor_123_236
            + minor_56_46*tangent_minor_123_235 - minor_56_56*tangent_minor_123_234;
        const lane tangent_minor_123_134 =
            D_l_1_rx*tangent_minor_23_13 + d_1_x*tangent_minor_23_34 - d_1_z*tangent_minor_23_14
            + minor_23_13*tangent_D_l_1_rx - minor_23_14*tangent_d_1_z + minor_23_34*tangent_d_1_x;
        const lane tangent_minor_123_135 =
            D_l_1_ry*tangent_minor_23_13 + d_1_x*tangent_minor_23_35 - d_1_z*tangent_minor_23_15
            + minor_23_13*tangent_D_l_1_ry - minor_23_15*tangent_d_1_z + minor_23_35*tangent_d_1_x;
        const lane tangent_minor_123_136 =
            D_l_1_rz*tangent_minor_23_13 + d_1_x*tangent_minor_23_36 - d_1_z*tangent_minor_23_16
            + minor_23_13*tangent_D_l_1_rz - minor_23_16*tangent_d_1_z + minor_23_36*tangent_d_1_x;
        const lane tangent_minor_123_145 =
            -D_l_1_rx*tangent_minor_23_15 + D_l_1_ry*tangent_minor_23_14 + d_1_x*tangent_minor_23_45
            + minor_23_14*tangent_D_l_1_ry - minor_23_15*tangent_D_l_1_rx + minor_23_45*tangent_d_1_x;
        const lane tangent_minor_123_146 =
            -D_l_1_rx*tangent_minor_23_16 + D_l_1_rz*tangent_minor_23_14 + d_1_x*tangent_minor_23_46
            + minor_23_14*tangent_D_l_1_rz - minor_23_16*tangent_D_l_1_rx + minor_23_46*tangent_d_1_x;
        const lane tangent_minor_123_156 =
            -D_l_1_ry*tangent_minor_23_16 + D_l_1_rz*tangent_minor_23_15 + d_1_x*tangent_minor_23_56
            + minor_23_15*tangent_D_l_1_rz - minor_23_16*tangent_D_l_1_ry + minor_23_56*tangent_d_1_x;
        const lane tangent_A_y_4 =
            minor_123_134*tangent_minor_56_56 - minor_123_135*tangent_minor_56_46
            + minor_123_136*tangent_minor_56_45 + minor_123_145*tangent_minor_56_36
            - minor_123_146*tangent_minor_56_35 + minor_123_156*tangent_minor_56_34
            - minor_123_345*tangent_minor_56_16 + minor_123_346*tangent_minor_56_15
            - minor_123_356*tangent_minor_56_14 + minor_123_456*tangent_minor_56_13
            + minor_56_13*tangent_minor_123_456 - minor_56_14*tangent_minor_123_356
            + minor_56_15*tangent_minor_123_346 - minor_56_16*tangent_minor_123_345
            + minor_56_34*tangent_minor_123_156 - minor_56_35*tangent_minor_123_146
            + minor_56_36*tangent_minor_123_145 + minor_56_45*tangent_minor_123_136
            - minor_56_46*tangent_minor_123_135 + minor_56_56*tangent_minor_123_134;
        const lane tangent_minor_123_124 =
            D_l_1_rx*tangent_minor_23_12 + d_1_x*tangent_minor_23_24 - d_1_y*tangent_minor_23_14
            + minor_23_12*tangent_D_l_1_rx - minor_23_14*tangent_d_1_y + minor_23_24*tangent_d_1_x;
        const lane tangent_minor_123_125 =
            D_l_1_ry*tangent_minor_23_12 + d_1_x*tangent_minor_23_25 - d_1_y*tangent_minor_23_15
            + minor_23_12*tangent_D_l_1_ry - minor_23_15*tangent_d_1_y + minor_23_25*tangent_d_1_x;
        const lane tangent_minor_123_126 =
            D_l_1_rz*tangent_minor_23_12 + d_1_x*tangent_minor_23_26 - d_1_y*tangent_minor_23_16
            + minor_23_12*tangent_D_l_1_rz - minor_23_16*tangent_d_1_y + minor_23_26*tangent_d_1_x;
        const lane tangent_A_z_4 =
            -minor_123_124*tangent_minor_56_56 + minor_123_125*tangent_minor_56_46
            - minor_123_126*tangent_minor_56_45 - minor_123_145*tangent_minor_56_26
            + minor_123_146*tangent_minor_56_25 - minor_123_156*tangent_minor_56_24
            + minor_123_245*tangent_minor_56_16 - minor_123_246*tangent_minor_56_15
            + minor_123_256*tangent_minor_56_14 - minor_123_456*tangent_minor_56_12
            - minor_56_12*tangent_minor_123_456 + minor_56_14*tangent_minor_123_256
            - minor_56_15*tangent_minor_123_246 + minor_56_16*tangent_minor_123_245
            - minor_56_24*tangent_minor_123_156 + minor_56_25*tangent_minor_123_146
            - minor_56_26*tangent_minor_123_145 - minor_56_45*tangent_minor_123_126
            + minor_56_46*tangent_minor_123_125 - minor_56_56*tangent_minor_123_124;
        const lane tangent_minor_123_123 =
            d_1_x*tangent_minor_23_23 - d_1_y*tangent_minor_23_13 + d_1_z*tangent_minor_23_12
            + minor_23_12*tangent_d_1_z - minor_23_13*tangent_d_1_y + minor_23_23*tangent_d_1_x;
        const lane tangent_A_rx_4 =
            minor_123_123*tangent_minor_56_56 - minor_123_125*tangent_minor_56_36
            + minor_123_126*tangent_minor_56_35 + minor_123_135*tangent_minor_56_26
            - minor_123_136*tangent_minor_56_25 + minor_123_156*tangent_minor_56_23
            - minor_123_235*tangent_minor_56_16 + minor_123_236*tangent_minor_56_15
            - minor_123_256*tangent_minor_56_13 + minor_123_356*tangent_minor_56_12
            + minor_56_12*tangent_minor_123_356 - minor_56_13*tangent_minor_123_256
            + minor_56_15*tangent_minor_123_236 - minor_56_16*tangent_minor_123_235
            + minor_56_23*tangent_minor_123_156 - minor_56_25*tangent_minor_123_136
            + minor_56_26*tangent_minor_123_135 + minor_56_35*tangent_minor_123_126
            - minor_56_36*tangent_minor_123_125 + minor_56_56*tangent_minor_123_123;
        const lane tangent_A_ry_4 =
            -minor_123_123*tangent_minor_56_46 + minor_123_124*tangent_minor_56_36
            - minor_123_126*tangent_minor_56_34 - minor_123_134*tangent_minor_56_26
            + minor_123_136*tangent_minor_56_24 - minor_123_146*tangent_minor_56_23
            + minor_123_234*tangent_minor_56_16 - minor_123_236*tangent_minor_56_14
            + minor_123_246*tangent_minor_56_13 - minor_123_346*tangent_minor_56_12
            - minor_56_12*tangent_minor_123_346 + minor_56_13*tangent_minor_123_246
            - minor_56_14*tangent_minor_123_236 + minor_56_16*tangent_minor_123_234
            - minor_56_23*tangent_minor_123_146 + minor_56_24*tangent_minor_123_136
            - minor_56_26*tangent_minor_123_134 - minor_56_34*tangent_minor_123_126
            + minor_56_36*tangent_minor_123_124 - minor_56_46*tangent_minor_123_123;
        const lane tangent_A_rz_4 =
            minor_123_123*tangent_minor_56_45 - minor_123_124*tangent_minor_56_35
            + minor_123_125*tangent_minor_56_34 + minor_123_134*tangent_minor_56_25
            - minor_123_135*tangent_minor_56_24 + minor_123_145*tangent_minor_56_23
            - minor_123_234*tangent_minor_56_15 + minor_123_235*tangent_minor_56_14
            - minor_123_245*tangent_minor_56_13 + minor_123_345*tangent_minor_56_12
            + minor_56_12*tangent_minor_123_345 - minor_56_13*tangent_minor_123_245
            + minor_56_14*tangent_minor_123_235 - minor_56_15*tangent_minor_123_234
            + minor_56_23*tangent_minor_123_145 - minor_56_24*tangent_minor_123_135
            + minor_56_25*tangent_minor_123_134 + minor_56_34*tangent_minor_123_125
            - minor_56_35*tangent_minor_123_124 + minor_56_45*tangent_minor_123_123;
        const lane tangent_minor_46_56 =
            D_l_4_ry*tangent_D_l_6_rz - D_l_4_rz*tangent_D_l_6_ry - D_l_6_ry*tangent_D_l_4_rz
            + D_l_6_rz*tangent_D_l_4_ry;
        const lane tangent_minor_46_46 =
            D_l_4_rx*tangent_D_l_6_rz - D_l_4_rz*tangent_D_l_6_rx - D_l_6_rx*tangent_D_l_4_rz
            + D_l_6_rz*tangent_D_l_4_rx;
        const lane tangent_minor_46_45 =
            D_l_4_rx*tangent_D_l_6_ry - D_l_4_ry*tangent_D_l_6_rx - D_l_6_rx*tangent_D_l_4_ry
            + D_l_6_ry*tangent_D_l_4_rx;
        const lane tangent_minor_46_36 =
            -D_l_4_rz*tangent_d_6_z + D_l_6_rz*tangent_d_4_z + d_4_z*tangent_D_l_6_rz
            - d_6_z*tangent_D_l_4_rz;
        const lane tangent_minor_46_35 =
            -D_l_4_ry*tangent_d_6_z + D_l_6_ry*tangent_d_4_z + d_4_z*tangent_D_l_6_ry
            - d_6_z*tangent_D_l_4_ry;
        const lane tangent_minor_46_34 =
            -D_l_4_rx*tangent_d_6_z + D_l_6_rx*tangent_d_4_z + d_4_z*tangent_D_l_6_rx
            - d_6_z*tangent_D_l_4_rx;
        const lane tangent_minor_46_26 =
            -D_l_4_rz*tangent_d_6_y + D_l_6_rz*tangent_d_4_y + d_4_y*tangent_D_l_6_rz
            - d_6_y*tangent_D_l_4_rz;
        const lane tangent_minor_46_25 =
            -D_l_4_ry*tangent_d_6_y + D_l_6_ry*tangent_d_4_y + d_4_y*tangent_D_l_6_ry
            - d_6_y*tangent_D_l_4_ry;
        const lane tangent_minor_46_24 =
            -D_l_4_rx*tangent_d_6_y + D_l_6_rx*tangent_d_4_y + d_4_y*tangent_D_l_6_rx
            - d_6_y*tangent_D_l_4_rx;
        const lane tangent_minor_46_23 =
            d_4_y*tangent_d_6_z - d_4_z*tangent_d_6_y - d_6_y*tangent_d_4_z + d_6_z*tangent_d_4_y;
        const lane tangent_A_x_5 =
            minor_123_234*tangent_minor_46_56 - minor_123_235*tangent_minor_46_46
            + minor_123_236*tangent_minor_46_45 + minor_123_245*tangent_minor_46_36
            - minor_123_246*tangent_minor_46_35 + minor_123_256*tangent_minor_46_34
            - minor_123_345*tangent_minor_46_26 + minor_123_346*tangent_minor_46_25
            - minor_123_356*tangent_minor_46_24 + minor_123_456*tangent_minor_46_23
            + minor_46_23*tangent_minor_123_456 - minor_46_24*tangent_minor_123_356
            + minor_46_25*tangent_minor_123_346 - minor_46_26*tangent_minor_123_345
            + minor_46_34*tangent_minor_123_256 - minor_46_35*tangent_minor_123_246
            + minor_46_36*tangent_minor_123_245 + minor_46_45*tangent_minor_123_236
            - minor_46_46*tangent_minor_123_235 + minor_46_56*tangent_minor_123_234;
        const lane tangent_minor_46_16 =
            -D_l_4_rz*tangent_d_6_x + D_l_6_rz*tangent_d_4_x + d_4_x*tangent_D_l_6_rz
            - d_6_x*tangent_D_l_4_rz;
        const lane tangent_minor_46_15 =
            -D_l_4_ry*tangent_d_6_x + D_l_6_ry*tangent_d_4_x + d_4_x*tangent_D_l_6_ry
            - d_6_x*tangent_D_l_4_ry;
        const lane tangent_minor_46_14 =
            -D_l_4_rx*tangent_d_6_x + D_l_6_rx*tangent_d_4_x + d_4_x*tangent_D_l_6_rx
            - d_6_x*tangent_D_l_4_rx;
        const lane tangent_minor_46_13 =
            d_4_x*tangent_d_6_z - d_4_z*tangent_d_6_x - d_6_x*tangent_d_4_z + d_6_z*tangent_d_4_x;
        const lane tangent_A_y_5 =
            -minor_123_134*tangent_minor_46_56 + minor_123_135*tangent_minor_46_46
            - minor_123_136*tangent_minor_46_45 - minor_123_145*tangent_minor_46_36
            + minor_123_146*tangent_minor_46_35 - minor_123_156*tangent_minor_46_34
            + minor_123_345*tangent_minor_46_16 - minor_123_346*tangent_minor_46_15
            + minor_123_356*tangent_minor_46_14 - minor_123_456*tangent_minor_46_13
            - minor_46_13*tangent_minor_123_456 + minor_46_14*tangent_minor_123_356
            - minor_46_15*tangent_minor_123_346 + minor_46_16*tangent_minor_123_345
            - minor_46_34*tangent_minor_123_156 + minor_46_35*tangent_minor_123_146
            - minor_46_36*tangent_minor_123_145 - minor_46_45*tangent_minor_123_136
            + minor_46_46*tangent_minor_123_135 - minor_46_56*tangent_minor_123_134;
        const lane tangent_minor_46_12 =
            d_4_x*tangent_d_6_y - d_4_y*tangent_d_6_x - d_6_x*tangent_d_4_y + d_6_y*tangent_d_4_x;
        const lane tangent_A_z_5 =
            minor_123_124*tangent_minor_46_56 - minor_123_125*tangent_minor_46_46
            + minor_123_126*tangent_minor_46_45 + minor_123_145*tangent_minor_46_26
            - minor_123_146*tangent_minor_46_25 + minor_123_156*tangent_minor_46_24
            - minor_123_245*tangent_minor_46_16 + minor_123_246*tangent_minor_46_15
            - minor_123_256*tangent_minor_46_14 + minor_123_456*tangent_minor_46_12
            + minor_46_12*tangent_minor_123_456 - minor_46_14*tangent_minor_123_256
            + minor_46_15*tangent_minor_123_246 - minor_46_16*tangent_minor_123_245
            + minor_46_24*tangent_minor_123_156 - minor_46_25*tangent_minor_123_146
            + minor_46_26*tangent_minor_123_145 + minor_46_45*tangent_minor_123_126
            - minor_46_46*tangent_minor_123_125 + minor_46_56*tangent_minor_123_124;
        const lane tangent_A_rx_5 =
            -minor_123_123*tangent_minor_46_56 + minor_123_125*tangent_minor_46_36
            - minor_123_126*tangent_minor_46_35 - minor_123_135*tangent_minor_46_26
            + minor_123_136*tangent_minor_46_25 - minor_123_156*tangent_minor_46_23
            + minor_123_235*tangent_minor_46_16 - minor_123_236*tangent_minor_46_15
            + minor_123_256*tangent_minor_46_13 - minor_123_356*tangent_minor_46_12
            - minor_46_12*tangent_minor_123_356 + minor_46_13*tangent_minor_123_256
            - minor_46_15*tangent_minor_123_236 + minor_46_16*tangent_minor_123_235
            - minor_46_23*tangent_minor_123_156 + minor_46_25*tangent_minor_123_136
            - minor_46_26*tangent_minor_123_135 - minor_46_35*tangent_minor_123_126
            + minor_46_36*tangent_minor_123_125 - minor_46_56*tangent_minor_123_123;
        const lane tangent_A_ry_5 =
            minor_123_123*tangent_minor_46_46 - minor_123_124*tangent_minor_46_36
            + minor_123_126*tangent_minor_46_34 + minor_123_134*tangent_minor_46_26
            - minor_123_136*tangent_minor_46_24 + minor_123_146*tangent_minor_46_23
            - minor_123_234*tangent_minor_46_16 + minor_123_236*tangent_minor_46_14
            - minor_123_246*tangent_minor_46_13 + minor_123_346*tangent_minor_46_12
            + minor_46_12*tangent_minor_123_346 - minor_46_13*tangent_minor_123_246
            + minor_46_14*tangent_minor_123_236 - minor_46_16*tangent_minor_123_234
            + minor_46_23*tangent_minor_123_146 - minor_46_24*tangent_minor_123_136
            + minor_46_26*tangent_minor_123_134 + minor_46_34*tangent_minor_123_126
            - minor_46_36*tangent_minor_123_124 + minor_46_46*tangent_minor_123_123;
        const lane tangent_A_rz_5 =
            -minor_123_123*tangent_minor_46_45 + minor_123_124*tangent_minor_46_35
            - minor_123_125*tangent_minor_46_34 - minor_123_134*tangent_minor_46_25
            + minor_123_135*tangent_minor_46_24 - minor_123_145*tangent_minor_46_23
            + minor_123_234*tangent_minor_46_15 - minor_123_235*tangent_minor_46_14
            + minor_123_245*tangent_minor_46_13 - minor_123_345*tangent_minor_46_12
            - minor_46_12*tangent_minor_123_345 + minor_46_13*tangent_minor_123_245
            - minor_46_14*tangent_minor_123_235 + minor_46_15*tangent_minor_123_234
            - minor_46_23*tangent_minor_123_145 + minor_46_24*tangent_minor_123_135
            - minor_46_25*tangent_minor_123_134 - minor_46_34*tangent_minor_123_125
            + minor_46_35*tangent_minor_123_124 - minor_46_45*tangent_minor_123_123;
        const lane tangent_minor_45_56 =
            D_l_4_ry*tangent_D_l_5_rz - D_l_4_rz*tangent_D_l_5_ry - D_l_5_ry*tangent_D_l_4_rz
            + D_l_5_rz*tangent_D_l_4_ry;
        const lane tangent_minor_45_46 =
            D_l_4_rx*tangent_D_l_5_rz - D_l_4_rz*tangent_D_l_5_rx - D_l_5_rx*tangent_D_l_4_rz
            + D_l_5_rz*tangent_D_l_4_rx;
        const lane tangent_minor_45_45 =
            D_l_4_rx*tangent_D_l_5_ry - D_l_4_ry*tangent_D_l_5_rx - D_l_5_rx*tangent_D_l_4_ry
            + D_l_5_ry*tangent_D_l_4_rx;
        const lane tangent_minor_45_36 =
            -D_l_4_rz*tangent_d_5_z + D_l_5_rz*tangent_d_4_z + d_4_z*tangent_D_l_5_rz
            - d_5_z*tangent_D_l_4_rz;
        const lane tangent_minor_45_35 =
            -D_l_4_ry*tangent_d_5_z + D_l_5_ry*tangent_d_4_z + d_4_z*tangent_D_l_5_ry
            - d_5_z*tangent_D_l_4_ry;
        const lane tangent_minor_45_34 =
            -D_l_4_rx*tangent_d_5_z + D_l_5_rx*tangent_d_4_z + d_4_z*tangent_D_l_5_rx
            - d_5_z*tangent_D_l_4_rx;
        const lane tangent_minor_45_26 =
            -D_l_4_rz*tangent_d_5_y + D_l_5_rz*tangent_d_4_y + d_4_y*tangent_D_l_5_rz
            - d_5_y*tangent_D_l_4_rz;
        const lane tangent_minor_45_25 =
            -D_l_4_ry*tangent_d_5_y + D_l_5_ry*tangent_d_4_y + d_4_y*tangent_D_l_5_ry
            - d_5_y*tangent_D_l_4_ry;
        const lane tangent_minor_45_24 =
            -D_l_4_rx*tangent_d_5_y + D_l_5_rx*tangent_d_4_y + d_4_y*tangent_D_l_5_rx
            - d_5_y*tangent_D_l_4_rx;
        const lane tangent_minor_45_23 =
            d_4_y*tangent_d_5_z - d_4_z*tangent_d_5_y - d_5_y*tangent_d_4_z + d_5_z*tangent_d_4_y;
        const lane tangent_A_x_6 =
            -minor_123_234*tangent_minor_45_56 + minor_123_235*tangent_minor_45_46
            - minor_123_236*tangent_minor_45_45 - minor_123_245*tangent_minor_45_36
            + minor_123_246*tangent_minor_45_35 - minor_123_256*tangent_minor_45_34
            + minor_123_345*tangent_minor_45_26 - minor_123_346*tangent_minor_45_25
            + minor_123_356*tangent_minor_45_24 - minor_123_456*tangent_minor_45_23
            - minor_45_23*tangent_minor_123_456 + minor_45_24*tangent_minor_123_356
            - minor_45_25*tangent_minor_123_346 + minor_45_26*tangent_minor_123_345
            - minor_45_34*tangent_minor_123_256 + minor_45_35*tangent_minor_123_246
            - minor_45_36*tangent_minor_123_245 - minor_45_45*tangent_minor_123_236
            + minor_45_46*tangent_minor_123_235 - minor_45_56*tangent_minor_123_234;
        const lane tangent_minor_45_16 =
            -D_l_4_rz*tangent_d_5_x + D_l_5_rz*tangent_d_4_x + d_4_x*tangent_D_l_5_rz
            - d_5_x*tangent_D_l_4_rz;
        const lane tangent_minor_45_15 =
            -D_l_4_ry*tangent_d_5_x + D_l_5_ry*tangent_d_4_x + d_4_x*tangent_D_l_5_ry
            - d_5_x*tangent_D_l_4_ry;
        const lane tangent_minor_45_14 =
            -D_l_4_rx*tangent_d_5_x + D_l_5_rx*tangent_d_4_x + d_4_x*tangent_D_l_5_rx
            - d_5_x*tangent_D_l_4_rx;
        const lane tangent_minor_45_13 =
            d_4_x*tangent_d_5_z - d_4_z*tangent_d_5_x - d_5_x*tangent_d_4_z + d_5_z*tangent_d_4_x;
        const lane tangent_A_y_6 =
            minor_123_134*tangent_minor_45_56 - minor_123_135*tangent_minor_45_46
            + minor_123_136*tangent_minor_45_45 + minor_123_145*tangent_minor_45_36
            - minor_123_146*tangent_minor_45_35 + minor_123_156*tangent_minor_45_34
            - minor_123_345*tangent_minor_45_16 + minor_123_346*tangent_minor_45_15
            - minor_123_356*tangent_minor_45_14 + minor_123_456*tangent_minor_45_13
            + minor_45_13*tangent_minor_123_456 - minor_45_14*tangent_minor_123_356
            + minor_45_15*tangent_minor_123_346 - minor_45_16*tangent_minor_123_345
            + minor_45_34*tangent_minor_123_156 - minor_45_35*tangent_minor_123_146
            + minor_45_36*tangent_minor_123_145 + minor_45_45*tangent_minor_123_136
            - minor_45_46*tangent_minor_123_135 + minor_45_56*tangent_minor_123_134;
        const lane tangent_minor_45_12 =
            d_4_x*tangent_d_5_y - d_4_y*tangent_d_5_x - d_5_x*tangent_d_4_y + d_5_y*tangent_d_4_x;
        const lane tangent_A_z_6 =
            -minor_123_124*tangent_minor_45_56 + minor_123_125*tangent_minor_45_46
            - minor_123_126*tangent_minor_45_45 - minor_123_145*tangent_minor_45_26
            + minor_123_146*tangent_minor_45_25 - minor_123_156*tangent_minor_45_24
            + minor_123_245*tangent_minor_45_16 - minor_123_246*tangent_minor_45_15
            + minor_123_256*tangent_minor_45_14 - minor_123_456*tangent_minor_45_12
            - minor_45_12*tangent_minor_123_456 + minor_45_14*tangent_minor_123_256
            - minor_45_15*tangent_minor_123_246 + minor_45_16*tangent_minor_123_245
            - minor_45_24*tangent_minor_123_156 + minor_45_25*tangent_minor_123_146
            - minor_45_26*tangent_minor_123_145 - minor_45_45*tangent_minor_123_126
            + minor_45_46*tangent_minor_123_125 - minor_45_56*tangent_minor_123_124;
        const lane tangent_A_rx_6 =
            minor_123_123*tangent_minor_45_56 - minor_123_125*tangent_minor_45_36
            + minor_123_126*tangent_minor_45_35 + minor_123_135*tangent_minor_45_26
            - minor_123_136*tangent_minor_45_25 + minor_123_156*tangent_minor_45_23
            - minor_123_235*tangent_minor_45_16 + minor_123_236*tangent_minor_45_15
            - minor_123_256*tangent_minor_45_13 + minor_123_356*tangent_minor_45_12
            + minor_45_12*tangent_minor_123_356 - minor_45_13*tangent_minor_123_256
            + minor_45_15*tangent_minor_123_236 - minor_45_16*tangent_minor_123_235
            + minor_45_23*tangent_minor_123_156 - minor_45_25*tangent_minor_123_136
            + minor_45_26*tangent_minor_123_135 + minor_45_35*tangent_minor_123_126
            - minor_45_36*tangent_minor_123_125 + minor_45_56*tangent_minor_123_123;
        const lane tangent_A_ry_6 =
            -minor_123_123*tangent_minor_45_46 + minor_123_124*tangent_minor_45_36
            - minor_123_126*tangent_minor_45_34 - minor_123_134*tangent_minor_45_26
            + minor_123_136*tangent_minor_45_24 - minor_123_146*tangent_minor_45_23
            + minor_123_234*tangent_minor_45_16 - minor_123_236*tangent_minor_45_14
            + minor_123_246*tangent_minor_45_13 - minor_123_346*tangent_minor_45_12
            - minor_45_12*tangent_minor_123_346 + minor_45_13*tangent_minor_123_246
            - minor_45_14*tangent_minor_123_236 + minor_45_16*tangent_minor_123_234
            - minor_45_23*tangent_minor_123_146 + minor_45_24*tangent_minor_123_136
            - minor_45_26*tangent_minor_123_134 - minor_45_34*tangent_minor_123_126
            + minor_45_36*tangent_minor_123_124 - minor_45_46*tangent_minor_123_123;
        const lane tangent_A_rz_6 =
            minor_123_123*tangent_minor_45_45 - minor_123_124*tangent_minor_45_35
            + minor_123_125*tangent_minor_45_34 + minor_123_134*tangent_minor_45_25
            - minor_123_135*tangent_minor_45_24 + minor_123_145*tangent_minor_45_23
            - minor_123_234*tangent_minor_45_15 + minor_123_235*tangent_minor_45_14
            - minor_123_245*tangent_minor_45_13 + minor_123_345*tangent_minor_45_12
            + minor_45_12*tangent_minor_123_345 - minor_45_13*tangent_minor_123_245
            + minor_45_14*tangent_minor_123_235 - minor_45_15*tangent_minor_123_234
            + minor_45_23*tangent_minor_123_145 - minor_45_24*tangent_minor_123_135
            + minor_45_25*tangent_minor_123_134 + minor_45_34*tangent_minor_123_125
            - minor_45_35*tangent_minor_123_124 + minor_45_45*tangent_minor_123_123;
        const lane tangent_det_D_l =
            A_rx_1*tangent_D_l_1_rx + A_ry_1*tangent_D_l_1_ry + A_rz_1*tangent_D_l_1_rz + A_x_1*tangent_d_1_x
            + A_y_1*tangent_d_1_y + A_z_1*tangent_d_1_z + D_l_1_rx*tangent_A_rx_1 + D_l_1_ry*tangent_A_ry_1
            + D_l_1_rz*tangent_A_rz_1 + d_1_x*tangent_A_x_1 + d_1_y*tangent_A_y_1 + d_1_z*tangent_A_z_1;
        const lane tangent_forward_22 = -(forward_22*forward_22)*tangent_det_D_l;
        const lane tangent_forward_t55 = forward_22*tangent_forward_4 + forward_4*tangent_forward_22;
        const lane tangent_D_p_x_1 = A_x_1*tangent_forward_t55 + forward_t55*tangent_A_x_1;
        const lane tangent_forward_t56 = forward_22*tangent_forward_5 + forward_5*tangent_forward_22;
        const lane tangent_D_p_x_2 = A_x_2*tangent_forward_t56 + forward_t56*tangent_A_x_2;
        const lane tangent_forward_t57 = forward_22*tangent_forward_6 + forward_6*tangent_forward_22;
        const lane tangent_D_p_x_3 = A_x_3*tangent_forward_t57 + forward_t57*tangent_A_x_3;
        const lane tangent_forward_t58 = forward_22*tangent_forward_7 + forward_7*tangent_forward_22;
        const lane tangent_D_p_x_4 = A_x_4*tangent_forward_t58 + forward_t58*tangent_A_x_4;
        const lane tangent_forward_t59 = forward_22*tangent_forward_8 + forward_8*tangent_forward_22;
        const lane tangent_D_p_x_5 = A_x_5*tangent_forward_t59 + forward_t59*tangent_A_x_5;
        const lane tangent_forward_t60 = forward_22*tangent_forward_9 + forward_9*tangent_forward_22;
        const lane tangent_D_p_x_6 = A_x_6*tangent_forward_t60 + forward_t60*tangent_A_x_6;
        const lane tangent_D_p_y_1 = A_y_1*tangent_forward_t55 + forward_t55*tangent_A_y_1;
        const lane tangent_D_p_y_2 = A_y_2*tangent_forward_t56 + forward_t56*tangent_A_y_2;
        const lane tangent_D_p_y_3 = A_y_3*tangent_forward_t57 + forward_t57*tangent_A_y_3;
        const lane tangent_D_p_y_4 = A_y_4*tangent_forward_t58 + forward_t58*tangent_A_y_4;
        const lane tangent_D_p_y_5 = A_y_5*tangent_forward_t59 + forward_t59*tangent_A_y_5;
        const lane tangent_D_p_y_6 = A_y_6*tangent_forward_t60 + forward_t60*tangent_A_y_6;
        const lane tangent_D_p_z_1 = A_z_1*tangent_forward_t55 + forward_t55*tangent_A_z_1;
        const lane tangent_D_p_z_2 = A_z_2*tangent_forward_t56 + forward_t56*tangent_A_z_2;
        const lane tangent_D_p_z_3 = A_z_3*tangent_forward_t57 + forward_t57*tangent_A_z_3;
        const lane tangent_D_p_z_4 = A_z_4*tangent_forward_t58 + forward_t58*tangent_A_z_4;
        const lane tangent_D_p_z_5 = A_z_5*tangent_forward_t59 + forward_t59*tangent_A_z_5;
        const lane tangent_D_p_z_6 = A_z_6*tangent_forward_t60 + forward_t60*tangent_A_z_6;
        const lane tangent_D_p_rx_1 = A_rx_1*tangent_forward_t55 + forward_t55*tangent_A_rx_1;
        const lane tangent_D_p_rx_2 = A_rx_2*tangent_forward_t56 + forward_t56*tangent_A_rx_2;
        const lane tangent_D_p_rx_3 = A_rx_3*tangent_forward_t57 + forward_t57*tangent_A_rx_3;
        const lane tangent_D_p_rx_4 = A_rx_4*tangent_forward_t58 + forward_t58*tangent_A_rx_4;
        const lane tangent_D_p_rx_5 = A_rx_5*tangent_forward_t59 + forward_t59*tangent_A_rx_5;
        const lane tangent_D_p_rx_6 = A_rx_6*tangent_forward_t60 + forward_t60*tangent_A_rx_6;
        const lane tangent_D_p_ry_1 = A_ry_1*tangent_forward_t55 + forward_t55*tangent_A_ry_1;
        const lane tangent_D_p_ry_2 = A_ry_2*tangent_forward_t56 + forward_t56*tangent_A_ry_2;
        const lane tangent_D_p_ry_3 = A_ry_3*tangent_forward_t57 + forward_t57*tangent_A_ry_3;
        const lane tangent_D_p_ry_4 = A_ry_4*tangent_forward_t58 + forward_t58*tangent_A_ry_4;
        const lane tangent_D_p_ry_5 = A_ry_5*tangent_forward_t59 + forward_t59*tangent_A_ry_5;
        const lane tangent_D_p_ry_6 = A_ry_6*tangent_forward_t60 + forward_t60*tangent_A_ry_6;
        const lane tangent_D_p_rz_1 = A_rz_1*tangent_forward_t55 + forward_t55*tangent_A_rz_1;
        const lane tangent_D_p_rz_2 = A_rz_2*tangent_forward_t56 + forward_t56*tangent_A_rz_2;
        const lane tangent_D_p_rz_3 = A_rz_3*tangent_forward_t57 + forward_t57*tangent_A_rz_3;
        const lane tangent_D_p_rz_4 = A_rz_4*tangent_forward_t58 + forward_t58*tangent_A_rz_4;
        const lane tangent_D_p_rz_5 = A_rz_5*tangent_forward_t59 + forward_t59*tangent_A_rz_5;
        const lane tangent_D_p_rz_6 = A_rz_6*tangent_forward_t60 + forward_t60*tangent_A_rz_6;
        const lane tangent_k_1 = along_116*k_l_1 + along_62*(a_S_1 + 1.0);
        const lane tangent_k_2 = along_117*k_l_2 + along_63*(a_S_2 + 1.0);
        const lane tangent_k_3 = along_118*k_l_3 + along_64*(a_S_3 + 1.0);
        const lane tangent_k_4 = along_119*k_l_4 + along_65*(a_S_4 + 1.0);
        const lane tangent_k_5 = along_120*k_l_5 + along_66*(a_S_5 + 1.0);
        const lane tangent_k_6 = along_121*k_l_6 + along_67*(a_S_6 + 1.0);
        const lane tangent_forward_t61 = along_11*m_lift_1 + g_x*tangent_m_lift_1;
        const lane tangent_forward_t62 = along_11*m_lift_2 + g_x*tangent_m_lift_2;
        const lane tangent_forward_t63 = along_11*m_lift_3 + g_x*tangent_m_lift_3;
        const lane tangent_forward_t64 = along_11*m_lift_4 + g_x*tangent_m_lift_4;
        const lane tangent_forward_t65 = along_11*m_lift_5 + g_x*tangent_m_lift_5;
        const lane tangent_forward_t66 = along_11*m_lift_6 + g_x*tangent_m_lift_6;
        const lane tangent_forward_t67 = along_1 + along_125;
        const lane tangent_G_p_x =
            -along_11*forward_t67 - g_x*tangent_forward_t67 - tangent_forward_t61 - tangent_forward_t62
            - tangent_forward_t63 - tangent_forward_t64 - tangent_forward_t65 - tangent_forward_t66;
        const lane tangent_forward_t68 = along_12*m_lift_1 + g_y*tangent_m_lift_1;
        const lane tangent_forward_t69 = along_12*m_lift_2 + g_y*tangent_m_lift_2;
        const lane tangent_forward_t70 = along_12*m_lift_3 + g_y*tangent_m_lift_3;
        const lane tangent_forward_t71 = along_12*m_lift_4 + g_y*tangent_m_lift_4;
        const lane tangent_forward_t72 = along_12*m_lift_5 + g_y*tangent_m_lift_5;
        const lane tangent_forward_t73 = along_12*m_lift_6 + g_y*tangent_m_lift_6;
        const lane tangent_G_p_y =
            -along_12*forward_t67 - g_y*tangent_forward_t67 - tangent_forward_t68 - tangent_forward_t69
            - tangent_forward_t70 - tangent_forward_t71 - tangent_forward_t72 - tangent_forward_t73;
        const lane tangent_forward_t74 = along_13*m_lift_1 + g_z*tangent_m_lift_1;
        const lane tangent_forward_t75 = along_13*m_lift_2 + g_z*tangent_m_lift_2;
        const lane tangent_forward_t76 = along_13*m_lift_3 + g_z*tangent_m_lift_3;
        const lane tangent_forward_t77 = along_13*m_lift_4 + g_z*tangent_m_lift_4;
        const lane tangent_forward_t78 = along_13*m_lift_5 + g_z*tangent_m_lift_5;
        const lane tangent_forward_t79 = along_13*m_lift_6 + g_z*tangent_m_lift_6;
        const lane tangent_G_p_z =
            -along_13*forward_t67 - g_z*tangent_forward_t67 - tangent_forward_t74 - tangent_forward_t75
            - tangent_forward_t76 - tangent_forward_t77 - tangent_forward_t78 - tangent_forward_t79;
        const lane tangent_forward_t80 = along_1*g_z + along_13*m_p;
        const lane tangent_forward_t81 = along_125*g_z + along_13*m_L;
        const lane t153 = along_1*g_y;
        const lane t154 = along_125*g_y;
        const lane tangent_G_p_rx =
            -B_1_y*tangent_forward_t74 + B_1_z*g_y*tangent_m_lift_1 - B_2_y*tangent_forward_t75
            + B_2_z*g_y*tangent_m_lift_2 - B_3_y*tangent_forward_t76 + B_3_z*g_y*tangent_m_lift_3
            - B_4_y*tangent_forward_t77 + B_4_z*g_y*tangent_m_lift_4 - B_5_y*tangent_forward_t78
            + B_5_z*g_y*tangent_m_lift_5 - B_6_y*tangent_forward_t79 + B_6_z*g_y*tangent_m_lift_6
            + along_12*(B_1_z*m_lift_1 + B_2_z*m_lift_2 + B_3_z*m_lift_3 + B_4_z*m_lift_4 + B_5_z*m_lift_5
            + B_6_z*m_lift_6 + forward_t183 + forward_t184) - c_y*tangent_forward_t80 + c_z*t153
            + forward_t68*tangent_B_1_z + forward_t69*tangent_B_2_z + forward_t70*tangent_B_3_z
            + forward_t71*tangent_B_4_z + forward_t72*tangent_B_5_z + forward_t73*tangent_B_6_z
            - forward_t74*tangent_B_1_y - forward_t75*tangent_B_2_y - forward_t76*tangent_B_3_y
            - forward_t77*tangent_B_4_y - forward_t78*tangent_B_5_y - forward_t79*tangent_B_6_y
            - forward_t80*tangent_c_y - forward_t81*tangent_o_L_y + forward_t84*tangent_c_z
            + forward_t85*tangent_o_L_z - o_L_y*tangent_forward_t81 + o_L_z*t154;
        const lane t155 = along_1*g_x;
        const lane tangent_forward_t82 = along_11*m_p + t155;
        const lane t156 = along_125*g_x;
        const lane tangent_forward_t83 = along_11*m_L + t156;
        const lane tangent_G_p_ry =
            B_1_x*tangent_forward_t74 - B_1_z*tangent_forward_t61 + B_2_x*tangent_forward_t75
            - B_2_z*tangent_forward_t62 + B_3_x*tangent_forward_t76 - B_3_z*tangent_forward_t63
            + B_4_x*tangent_forward_t77 - B_4_z*tangent_forward_t64 + B_5_x*tangent_forward_t78
            - B_5_z*tangent_forward_t65 + B_6_x*tangent_forward_t79 - B_6_z*tangent_forward_t66
            + c_x*tangent_forward_t80 - c_z*tangent_forward_t82 - forward_t61*tangent_B_1_z
            - forward_t62*tangent_B_2_z - forward_t63*tangent_B_3_z - forward_t64*tangent_B_4_z
            - forward_t65*tangent_B_5_z - forward_t66*tangent_B_6_z + forward_t74*tangent_B_1_x
            + forward_t75*tangent_B_2_x + forward_t76*tangent_B_3_x + forward_t77*tangent_B_4_x
            + forward_t78*tangent_B_5_x + forward_t79*tangent_B_6_x + forward_t80*tangent_c_x
            + forward_t81*tangent_o_L_x - forward_t82*tangent_c_z - forward_t83*tangent_o_L_z
            + o_L_x*tangent_forward_t81 - o_L_z*tangent_forward_t83;
        const lane tangent_forward_t84 = along_12*m_p + t153;
        const lane tangent_forward_t85 = along_12*m_L + t154;
        const lane tangent_G_p_rz =
            -B_1_x*tangent_forward_t68 + B_1_y*g_x*tangent_m_lift_1 - B_2_x*tangent_forward_t69
            + B_2_y*g_x*tangent_m_lift_2 - B_3_x*tangent_forward_t70 + B_3_y*g_x*tangent_m_lift_3
            - B_4_x*tangent_forward_t71 + B_4_y*g_x*tangent_m_lift_4 - B_5_x*tangent_forward_t72
            + B_5_y*g_x*tangent_m_lift_5 - B_6_x*tangent_forward_t73 + B_6_y*g_x*tangent_m_lift_6
            + along_11*(B_1_y*m_lift_1 + B_2_y*m_lift_2 + B_3_y*m_lift_3 + B_4_y*m_lift_4 + B_5_y*m_lift_5
            + B_6_y*m_lift_6 + forward_t191 + forward_t192) - c_x*tangent_forward_t84 + c_y*t155
            + forward_t61*tangent_B_1_y + forward_t62*tangent_B_2_y + forward_t63*tangent_B_3_y
            + forward_t64*tangent_B_4_y + forward_t65*tangent_B_5_y + forward_t66*tangent_B_6_y
            - forward_t68*tangent_B_1_x - forward_t69*tangent_B_2_x - forward_t70*tangent_B_3_x
            - forward_t71*tangent_B_4_x - forward_t72*tangent_B_5_x - forward_t73*tangent_B_6_x
            + forward_t82*tangent_c_y + forward_t83*tangent_o_L_y - forward_t84*tangent_c_x
            - forward_t85*tangent_o_L_x - o_L_x*tangent_forward_t85 + o_L_y*t156;
        const lane t157 = forward_22*tangent_G_p_rx;
        const lane t158 = forward_22*tangent_G_p_ry;
        const lane t159 = forward_22*tangent_G_p_rz;
        const lane t160 = forward_22*tangent_G_p_x;
        const lane t161 = forward_22*tangent_G_p_y;
        const lane t162 = forward_22*tangent_G_p_z;
        const lane tangent_mu_1 =
            A_rx_1*t157 + A_ry_1*t158 + A_rz_1*t159 + A_x_1*t160 + A_y_1*t161 + A_z_1*t162
            + t163*tangent_A_rx_1 + t164*tangent_A_ry_1 + t165*tangent_A_rz_1 + t166*tangent_A_x_1
            + t167*tangent_A_y_1 + t168*tangent_A_z_1 + t56*tangent_forward_22;
        const lane tangent_mu_2 =
            A_rx_2*t157 + A_ry_2*t158 + A_rz_2*t159 + A_x_2*t160 + A_y_2*t161 + A_z_2*t162
            + t163*tangent_A_rx_2 + t164*tangent_A_ry_2 + t165*tangent_A_rz_2 + t166*tangent_A_x_2
            + t167*tangent_A_y_2 + t168*tangent_A_z_2 + t57*tangent_forward_22;
        const lane tangent_mu_3 =
            A_rx_3*t157 + A_ry_3*t158 + A_rz_3*t159 + A_x_3*t160 + A_y_3*t161 + A_z_3*t162
            + t163*tangent_A_rx_3 + t164*tangent_A_ry_3 + t165*tangent_A_rz_3 + t166*tangent_A_x_3
            + t167*tangent_A_y_3 + t168*tangent_A_z_3 + t58*tangent_forward_22;
        const lane tangent_mu_4 =
            A_rx_4*t157 + A_ry_4*t158 + A_rz_4*t159 + A_x_4*t160 + A_y_4*t161 + A_z_4*t162
            + t163*tangent_A_rx_4 + t164*tangent_A_ry_4 + t165*tangent_A_rz_4 + t166*tangent_A_x_4
            + t167*tangent_A_y_4 + t168*tangent_A_z_4 + t59*tangent_forward_22;
        const lane tangent_mu_5 =
            A_rx_5*t157 + A_ry_5*t158 + A_rz_5*t159 + A_x_5*t160 + A_y_5*t161 + A_z_5*t162
            + t163*tangent_A_rx_5 + t164*tangent_A_ry_5 + t165*tangent_A_rz_5 + t166*tangent_A_x_5
            + t167*tangent_A_y_5 + t168*tangent_A_z_5 + t60*tangent_forward_22;
        const lane tangent_mu_6 =
            A_rx_6*t157 + A_ry_6*t158 + A_rz_6*t159 + A_x_6*t160 + A_y_6*t161 + A_z_6*t162
            + t163*tangent_A_rx_6 + t164*tangent_A_ry_6 + t165*tangent_A_rz_6 + t166*tangent_A_x_6
            + t167*tangent_A_y_6 + t168*tangent_A_z_6 + t61*tangent_forward_22;
        const lane tangent_g_4_x = -d_1_x*tangent_mu_1 - mu_1*tangent_d_1_x - tangent_forward_t61;
        const lane tangent_g_4_y = -d_1_y*tangent_mu_1 - mu_1*tangent_d_1_y - tangent_forward_t68;
        const lane tangent_g_4_z = -d_1_z*tangent_mu_1 - mu_1*tangent_d_1_z - tangent_forward_t74;
        const lane tangent_g_5_x = -d_2_x*tangent_mu_2 - mu_2*tangent_d_2_x - tangent_forward_t62;
        const lane tangent_g_5_y = -d_2_y*tangent_mu_2 - mu_2*tangent_d_2_y - tangent_forward_t69;
        const lane tangent_g_5_z = -d_2_z*tangent_mu_2 - mu_2*tangent_d_2_z - tangent_forward_t75;
        const lane tangent_g_6_x = -d_3_x*tangent_mu_3 - mu_3*tangent_d_3_x - tangent_forward_t63;
        const lane tangent_g_6_y = -d_3_y*tangent_mu_3 - mu_3*tangent_d_3_y - tangent_forward_t70;
        const lane tangent_g_6_z = -d_3_z*tangent_mu_3 - mu_3*tangent_d_3_z - tangent_forward_t76;
        const lane tangent_g_7_x = -d_4_x*tangent_mu_4 - mu_4*tangent_d_4_x - tangent_forward_t64;
        const lane tangent_g_7_y = -d_4_y*tangent_mu_4 - mu_4*tangent_d_4_y - tangent_forward_t71;
        const lane tangent_g_7_z = -d_4_z*tangent_mu_4 - mu_4*tangent_d_4_z - tangent_forward_t77;
        const lane tangent_g_8_x = -d_5_x*tangent_mu_5 - mu_5*tangent_d_5_x - tangent_forward_t65;
        const lane tangent_g_8_y = -d_5_y*tangent_mu_5 - mu_5*tangent_d_5_y - tangent_forward_t72;
        const lane tangent_g_8_z = -d_5_z*tangent_mu_5 - mu_5*tangent_d_5_z - tangent_forward_t78;
        const lane tangent_g_9_x = -d_6_x*tangent_mu_6 - mu_6*tangent_d_6_x - tangent_forward_t66;
        const lane tangent_g_9_y = -d_6_y*tangent_mu_6 - mu_6*tangent_d_6_y - tangent_forward_t73;
        const lane tangent_g_9_z = -d_6_z*tangent_mu_6 - mu_6*tangent_d_6_z - tangent_forward_t79;
        const lane tangent_g_10_x = -tangent_forward_t82;
        const lane tangent_g_10_y = -tangent_forward_t84;
        const lane tangent_g_10_z = -tangent_forward_t80;
        const lane tangent_g_11_x = -tangent_forward_t83;
        const lane tangent_g_11_y = -tangent_forward_t85;
        const lane tangent_g_11_z = -tangent_forward_t81;
        const lane tangent_L_x_x =
            -tangent_mu_1 - tangent_mu_2 - tangent_mu_3 - tangent_mu_4 - tangent_mu_5 - tangent_mu_6;
        const lane tangent_forward_t86 = B_1_z*tangent_mu_1 + mu_1*tangent_B_1_z;
        const lane tangent_forward_t87 = B_2_z*tangent_mu_2 + mu_2*tangent_B_2_z;
        const lane tangent_forward_t88 = B_3_z*tangent_mu_3 + mu_3*tangent_B_3_z;
        const lane tangent_forward_t89 = B_4_z*tangent_mu_4 + mu_4*tangent_B_4_z;
        const lane tangent_forward_t90 = B_5_z*tangent_mu_5 + mu_5*tangent_B_5_z;
        const lane tangent_forward_t91 = B_6_z*tangent_mu_6 + mu_6*tangent_B_6_z;
        const lane tangent_L_y_rx =
            tangent_forward_t86 + tangent_forward_t87 + tangent_forward_t88 + tangent_forward_t89
            + tangent_forward_t90 + tangent_forward_t91;
        const lane tangent_L_x_ry = -tangent_L_y_rx;
        const lane tangent_forward_t92 = B_2_y*tangent_mu_2 + mu_2*tangent_B_2_y;
        const lane tangent_forward_t93 = B_3_y*tangent_mu_3 + mu_3*tangent_B_3_y;
        const lane tangent_forward_t94 = B_4_y*tangent_mu_4 + mu_4*tangent_B_4_y;
        const lane tangent_forward_t95 = B_5_y*tangent_mu_5 + mu_5*tangent_B_5_y;
        const lane tangent_forward_t96 = B_6_y*tangent_mu_6 + mu_6*tangent_B_6_y;
        const lane tangent_forward_t97 = B_1_y*tangent_mu_1 + mu_1*tangent_B_1_y;
        const lane tangent_L_x_rz =
            tangent_forward_t92 + tangent_forward_t93 + tangent_forward_t94 + tangent_forward_t95
            + tangent_forward_t96 + tangent_forward_t97;
        const lane tangent_L_z_ry =
            B_1_x*tangent_mu_1 + B_2_x*tangent_mu_2 + B_3_x*tangent_mu_3 + B_4_x*tangent_mu_4
            + B_5_x*tangent_mu_5 + B_6_x*tangent_mu_6 + mu_1*tangent_B_1_x + mu_2*tangent_B_2_x
            + mu_3*tangent_B_3_x + mu_4*tangent_B_4_x + mu_5*tangent_B_5_x + mu_6*tangent_B_6_x;
        const lane tangent_L_y_rz = -tangent_L_z_ry;
        const lane tangent_L_z_rx = -tangent_L_x_rz;
        const lane tangent_forward_t98 = 2.0*B_1_z*tangent_B_1_z;
        const lane tangent_forward_t99 = 2.0*B_2_z*tangent_B_2_z;
        const lane tangent_forward_t100 = 2.0*B_3_z*tangent_B_3_z;
        const lane tangent_forward_t101 = 2.0*B_4_z*tangent_B_4_z;
        const lane tangent_forward_t102 = 2.0*B_5_z*tangent_B_5_z;
        const lane tangent_forward_t103 = 2.0*B_6_z*tangent_B_6_z;
        const lane tangent_forward_t104 =
            B_1_z*tangent_g_4_z + B_2_z*tangent_g_5_z + B_3_z*tangent_g_6_z + B_4_z*tangent_g_7_z
            + B_5_z*tangent_g_8_z + B_6_z*tangent_g_9_z + c_z*tangent_g_10_z + forward_t100*tangent_mu_3
            + forward_t101*tangent_mu_4 + forward_t102*tangent_mu_5 + forward_t103*tangent_mu_6
            + forward_t98*tangent_mu_1 + forward_t99*tangent_mu_2 + g_10_z*tangent_c_z + g_11_z*tangent_o_L_z
            + g_4_z*tangent_B_1_z + g_5_z*tangent_B_2_z + g_6_z*tangent_B_3_z + g_7_z*tangent_B_4_z
            + g_8_z*tangent_B_5_z + g_9_z*tangent_B_6_z + mu_1*tangent_forward_t98 + mu_2*tangent_forward_t99
            + mu_3*tangent_forward_t100 + mu_4*tangent_forward_t101 + mu_5*tangent_forward_t102
            + mu_6*tangent_forward_t103 + o_L_z*tangent_g_11_z;
        const lane tangent_forward_t105 = 2.0*B_1_y*tangent_B_1_y;
        const lane tangent_forward_t106 = 2.0*B_2_y*tangent_B_2_y;
        const lane tangent_forward_t107 = 2.0*B_3_y*tangent_B_3_y;
        const lane tangent_forward_t108 = 2.0*B_4_y*tangent_B_4_y;
        const lane tangent_forward_t109 = 2.0*B_5_y*tangent_B_5_y;
        const lane tangent_forward_t110 = 2.0*B_6_y*tangent_B_6_y;
        const lane tangent_forward_t111 =
            B_1_y*tangent_g_4_y + B_2_y*tangent_g_5_y + B_3_y*tangent_g_6_y + B_4_y*tangent_g_7_y
            + B_5_y*tangent_g_8_y + B_6_y*tangent_g_9_y + c_y*tangent_g_10_y + forward_t105*tangent_mu_1
            + forward_t106*tangent_mu_2 + forward_t107*tangent_mu_3 + forward_t108*tangent_mu_4
            + forward_t109*tangent_mu_5 + forward_t110*tangent_mu_6 + g_10_y*tangent_c_y
            + g_11_y*tangent_o_L_y + g_4_y*tangent_B_1_y + g_5_y*tangent_B_2_y + g_6_y*tangent_B_3_y
            + g_7_y*tangent_B_4_y + g_8_y*tangent_B_5_y + g_9_y*tangent_B_6_y + mu_1*tangent_forward_t105
            + mu_2*tangent_forward_t106 + mu_3*tangent_forward_t107 + mu_4*tangent_forward_t108
            + mu_5*tangent_forward_t109 + mu_6*tangent_forward_t110 + o_L_y*tangent_g_11_y;
        const lane tangent_L_rx_rx = -tangent_forward_t104 - tangent_forward_t111;
        const lane tangent_forward_t112 = (1.0/2.0)*tangent_B_1_x;
        const lane tangent_forward_t113 = (1.0/2.0)*tangent_g_4_x;
        const lane tangent_forward_t114 = (1.0/2.0)*tangent_B_2_x;
        const lane tangent_forward_t115 = (1.0/2.0)*tangent_g_5_x;
        const lane tangent_forward_t116 = (1.0/2.0)*tangent_B_3_x;
        const lane tangent_forward_t117 = (1.0/2.0)*tangent_g_6_x;
        const lane tangent_forward_t118 = (1.0/2.0)*tangent_B_4_x;
        const lane tangent_forward_t119 = (1.0/2.0)*tangent_g_7_x;
        const lane tangent_forward_t120 = (1.0/2.0)*tangent_B_5_x;
        const lane tangent_forward_t121 = (1.0/2.0)*tangent_g_8_x;
        const lane tangent_forward_t122 = (1.0/2.0)*tangent_B_6_x;
        const lane tangent_forward_t123 = (1.0/2.0)*tangent_g_9_x;
        const lane tangent_forward_t124 = (1.0/2.0)*tangent_c_x;
        const lane tangent_forward_t125 = (1.0/2.0)*tangent_g_10_x;
        const lane tangent_forward_t126 = (1.0/2.0)*tangent_g_11_x;
        const lane tangent_forward_t127 = (1.0/2.0)*tangent_o_L_x;
        const lane tangent_L_rx_ry =
            B_1_x*tangent_forward_t97 + B_1_y*tangent_forward_t113 + B_2_x*tangent_forward_t92
            + B_2_y*tangent_forward_t115 + B_3_x*tangent_forward_t93 + B_3_y*tangent_forward_t117
            + B_4_x*tangent_forward_t94 + B_4_y*tangent_forward_t119 + B_5_x*tangent_forward_t95
            + B_5_y*tangent_forward_t121 + B_6_x*tangent_forward_t96 + B_6_y*tangent_forward_t123
            + c_y*tangent_forward_t125 + forward_t112*tangent_g_4_y + forward_t113*tangent_B_1_y
            + forward_t114*tangent_g_5_y + forward_t115*tangent_B_2_y + forward_t116*tangent_g_6_y
            + forward_t117*tangent_B_3_y + forward_t118*tangent_g_7_y + forward_t119*tangent_B_4_y
            + forward_t120*tangent_g_8_y + forward_t121*tangent_B_5_y + forward_t122*tangent_g_9_y
            + forward_t123*tangent_B_6_y + forward_t124*tangent_g_10_y + forward_t125*tangent_c_y
            + forward_t126*tangent_o_L_y + forward_t127*tangent_g_11_y + forward_t92*tangent_B_2_x
            + forward_t93*tangent_B_3_x + forward_t94*tangent_B_4_x + forward_t95*tangent_B_5_x
            + forward_t96*tangent_B_6_x + forward_t97*tangent_B_1_x + g_10_y*tangent_forward_t124
            + g_11_y*tangent_forward_t127 + g_4_y*tangent_forward_t112 + g_5_y*tangent_forward_t114
            + g_6_y*tangent_forward_t116 + g_7_y*tangent_forward_t118 + g_8_y*tangent_forward_t120
            + g_9_y*tangent_forward_t122 + o_L_y*tangent_forward_t126;
        const lane tangent_L_rx_rz =
            B_1_x*tangent_forward_t86 + B_1_z*tangent_forward_t113 + B_2_x*tangent_forward_t87
            + B_2_z*tangent_forward_t115 + B_3_x*tangent_forward_t88 + B_3_z*tangent_forward_t117
            + B_4_x*tangent_forward_t89 + B_4_z*tangent_forward_t119 + B_5_x*tangent_forward_t90
            + B_5_z*tangent_forward_t121 + B_6_x*tangent_forward_t91 + B_6_z*tangent_forward_t123
            + c_z*tangent_forward_t125 + forward_t112*tangent_g_4_z + forward_t113*tangent_B_1_z
            + forward_t114*tangent_g_5_z + forward_t115*tangent_B_2_z + forward_t116*tangent_g_6_z
            + forward_t117*tangent_B_3_z + forward_t118*tangent_g_7_z + forward_t119*tangent_B_4_z
            + forward_t120*tangent_g_8_z + forward_t121*tangent_B_5_z + forward_t122*tangent_g_9_z
            + forward_t123*tangent_B_6_z + forward_t124*tangent_g_10_z + forward_t125*tangent_c_z
            + forward_t126*tangent_o_L_z + forward_t127*tangent_g_11_z + forward_t86*tangent_B_1_x
            + forward_t87*tangent_B_2_x + forward_t88*tangent_B_3_x + forward_t89*tangent_B_4_x
            + forward_t90*tangent_B_5_x + forward_t91*tangent_B_6_x + g_10_z*tangent_forward_t124
            + g_11_z*tangent_forward_t127 + g_4_z*tangent_forward_t112 + g_5_z*tangent_forward_t114
            + g_6_z*tangent_forward_t116 + g_7_z*tangent_forward_t118 + g_8_z*tangent_forward_t120
            + g_9_z*tangent_forward_t122 + o_L_z*tangent_forward_t126;
        const lane tangent_forward_t128 = 2.0*B_1_x*tangent_B_1_x;
        const lane tangent_forward_t129 = 2.0*B_2_x*tangent_B_2_x;
        const lane tangent_forward_t130 = 2.0*B_3_x*tangent_B_3_x;
        const lane tangent_forward_t131 = 2.0*B_4_x*tangent_B_4_x;
        const lane tangent_forward_t132 = 2.0*B_5_x*tangent_B_5_x;
        const lane tangent_forward_t133 = 2.0*B_6_x*tangent_B_6_x;
        const lane tangent_forward_t134 =
            B_1_x*tangent_g_4_x + B_2_x*tangent_g_5_x + B_3_x*tangent_g_6_x + B_4_x*tangent_g_7_x
            + B_5_x*tangent_g_8_x + B_6_x*tangent_g_9_x + c_x*tangent_g_10_x + forward_t128*tangent_mu_1
            + forward_t129*tangent_mu_2 + forward_t130*tangent_mu_3 + forward_t131*tangent_mu_4
            + forward_t132*tangent_mu_5 + forward_t133*tangent_mu_6 + g_10_x*tangent_c_x
            + g_11_x*tangent_o_L_x + g_4_x*tangent_B_1_x + g_5_x*tangent_B_2_x + g_6_x*tangent_B_3_x
            + g_7_x*tangent_B_4_x + g_8_x*tangent_B_5_x + g_9_x*tangent_B_6_x + mu_1*tangent_forward_t128
            + mu_2*tangent_forward_t129 + mu_3*tangent_forward_t130 + mu_4*tangent_forward_t131
            + mu_5*tangent_forward_t132 + mu_6*tangent_forward_t133 + o_L_x*tangent_g_11_x;
        const lane tangent_L_ry_ry = -tangent_forward_t104 - tangent_forward_t134;
        const lane tangent_L_ry_rz =
            B_1_y*tangent_forward_t86 + (1.0/2.0)*B_1_y*tangent_g_4_z + B_2_y*tangent_forward_t87
            + (1.0/2.0)*B_2_y*tangent_g_5_z + B_3_y*tangent_forward_t88 + (1.0/2.0)*B_3_y*tangent_g_6_z
            + B_4_y*tangent_forward_t89 + (1.0/2.0)*B_4_y*tangent_g_7_z + B_5_y*tangent_forward_t90
            + (1.0/2.0)*B_5_y*tangent_g_8_z + B_6_y*tangent_forward_t91 + (1.0/2.0)*B_6_y*tangent_g_9_z
            + (1.0/2.0)*g_10_y*tangent_c_z + (1.0/2.0)*g_10_z*tangent_c_y + (1.0/2.0)*g_4_y*tangent_B_1_z
            + (1.0/2.0)*g_5_y*tangent_B_2_z + (1.0/2.0)*g_6_y*tangent_B_3_z + (1.0/2.0)*g_7_y*tangent_B_4_z
            + (1.0/2.0)*g_8_y*tangent_B_5_z + (1.0/2.0)*g_9_y*tangent_B_6_z + (1.0/2.0)*o_L_y*tangent_g_11_z
            + (1.0/2.0)*o_L_z*tangent_g_11_y + t63*tangent_g_5_y + t65*tangent_g_6_y + t67*tangent_g_7_y
            + t69*tangent_g_8_y + t71*tangent_g_9_y + t72*tangent_g_10_z + t73*tangent_g_10_y
            + t74*tangent_o_L_z + t75*tangent_o_L_y + t77*tangent_g_4_y + tangent_B_1_y*(forward_t86 + t76)
            + tangent_B_2_y*(forward_t87 + t62) + tangent_B_3_y*(forward_t88 + t64)
            + tangent_B_4_y*(forward_t89 + t66) + tangent_B_5_y*(forward_t90 + t68)
            + tangent_B_6_y*(forward_t91 + t70);
        const lane tangent_L_rz_rz = -tangent_forward_t111 - tangent_forward_t134;
        const lane tangent_forward_t135 = forward_10*tangent_forward_t32 + forward_t32*tangent_forward_10;
        const lane t169 = along_11*forward_t135;
        const lane tangent_forward_t136 = g_x*tangent_forward_t135 + t169;
        const lane tangent_f_x_l_1 =
            D_p_ry_1*tangent_L_x_ry + D_p_rz_1*tangent_L_x_rz + D_p_x_1*tangent_L_x_x
            + L_x_ry*tangent_D_p_ry_1 + L_x_rz*tangent_D_p_rz_1 + L_x_x*tangent_D_p_x_1
            + tangent_forward_t136;
        const lane tangent_forward_t137 = forward_12*tangent_forward_t36 + forward_t36*tangent_forward_12;
        const lane t170 = along_11*forward_t137;
        const lane tangent_forward_t138 = g_x*tangent_forward_t137 + t170;
        const lane tangent_f_x_l_2 =
            D_p_ry_2*tangent_L_x_ry + D_p_rz_2*tangent_L_x_rz + D_p_x_2*tangent_L_x_x
            + L_x_ry*tangent_D_p_ry_2 + L_x_rz*tangent_D_p_rz_2 + L_x_x*tangent_D_p_x_2
            + tangent_forward_t138;
        const lane tangent_forward_t139 = forward_14*tangent_forward_t40 + forward_t40*tangent_forward_14;
        const lane t171 = along_11*forward_t139;
        const lane tangent_forward_t140 = g_x*tangent_forward_t139 + t171;
        const lane tangent_f_x_l_3 =
            D_p_ry_3*tangent_L_x_ry + D_p_rz_3*tangent_L_x_rz + D_p_x_3*tangent_L_x_x
            + L_x_ry*tangent_D_p_ry_3 + L_x_rz*tangent_D_p_rz_3 + L_x_x*tangent_D_p_x_3
            + tangent_forward_t140;
        const lane tangent_forward_t141 = forward_16*tangent_forward_t44 + forward_t44*tangent_forward_16;
        const lane t172 = along_11*forward_t141;
        const lane tangent_forward_t142 = g_x*tangent_forward_t141 + t172;
        const lane tangent_f_x_l_4 =
            D_p_ry_4*tangent_L_x_ry + D_p_rz_4*tangent_L_x_rz + D_p_x_4*tangent_L_x_x
            + L_x_ry*tangent_D_p_ry_4 + L_x_rz*tangent_D_p_rz_4 + L_x_x*tangent_D_p_x_4
            + tangent_forward_t142;
        const lane tangent_forward_t143 = forward_18*tangent_forward_t48 + forward_t48*tangent_forward_18;
        const lane t173 = along_11*forward_t143;
        const lane tangent_forward_t144 = g_x*tangent_forward_t143 + t173;
        const lane tangent_f_x_l_5 =
            D_p_ry_5*tangent_L_x_ry + D_p_rz_5*tangent_L_x_rz + D_p_x_5*tangent_L_x_x
            + L_x_ry*tangent_D_p_ry_5 + L_x_rz*tangent_D_p_rz_5 + L_x_x*tangent_D_p_x_5
            + tangent_forward_t144;
        const lane tangent_forward_t145 = forward_20*tangent_forward_t52 + forward_t52*tangent_forward_20;
        const lane t174 = along_11*forward_t145;
        const lane tangent_forward_t146 = g_x*tangent_forward_t145 + t174;
        const lane tangent_f_x_l_6 =
            D_p_ry_6*tangent_L_x_ry + D_p_rz_6*tangent_L_x_rz + D_p_x_6*tangent_L_x_x
            + L_x_ry*tangent_D_p_ry_6 + L_x_rz*tangent_D_p_rz_6 + L_x_x*tangent_D_p_x_6
            + tangent_forward_t146;
        const lane t175 = along_12*forward_t135;
        const lane tangent_forward_t147 = g_y*tangent_forward_t135 + t175;
        const lane tangent_f_y_l_1 =
            D_p_rx_1*tangent_L_y_rx + D_p_rz_1*tangent_L_y_rz + D_p_y_1*tangent_L_x_x + L_x_x*tangent_D_p_y_1
            + L_y_rx*tangent_D_p_rx_1 + L_y_rz*tangent_D_p_rz_1 + tangent_forward_t147;
        const lane t176 = along_12*forward_t137;
        const lane tangent_forward_t148 = g_y*tangent_forward_t137 + t176;
        const lane tangent_f_y_l_2 =
            D_p_rx_2*tangent_L_y_rx + D_p_rz_2*tangent_L_y_rz + D_p_y_2*tangent_L_x_x + L_x_x*tangent_D_p_y_2
            + L_y_rx*tangent_D_p_rx_2 + L_y_rz*tangent_D_p_rz_2 + tangent_forward_t148;
        const lane t177 = along_12*forward_t139;
        const lane tangent_forward_t149 = g_y*tangent_forward_t139 + t177;
        const lane tangent_f_y_l_3 =
            D_p_rx_3*tangent_L_y_rx + D_p_rz_3*tangent_L_y_rz + D_p_y_3*tangent_L_x_x + L_x_x*tangent_D_p_y_3
            + L_y_rx*tangent_D_p_rx_3 + L_y_rz*tangent_D_p_rz_3 + tangent_forward_t149;
        const lane t178 = along_12*forward_t141;
        const lane tangent_forward_t150 = g_y*tangent_forward_t141 + t178;
        const lane tangent_f_y_l_4 =
            D_p_rx_4*tangent_L_y_rx + D_p_rz_4*tangent_L_y_rz + D_p_y_4*tangent_L_x_x + L_x_x*tangent_D_p_y_4
            + L_y_rx*tangent_D_p_rx_4 + L_y_rz*tangent_D_p_rz_4 + tangent_forward_t150;
        const lane t179 = along_12*forward_t143;
        const lane tangent_forward_t151 = g_y*tangent_forward_t143 + t179;
        const lane tangent_f_y_l_5 =
            D_p_rx_5*tangent_L_y_rx + D_p_rz_5*tangent_L_y_rz + D_p_y_5*tangent_L_x_x + L_x_x*tangent_D_p_y_5
            + L_y_rx*tangent_D_p_rx_5 + L_y_rz*tangent_D_p_rz_5 + tangent_forward_t151;
        const lane t180 = along_12*forward_t145;
        const lane tangent_forward_t152 = g_y*tangent_forward_t145 + t180;
        const lane tangent_f_y_l_6 =
            D_p_rx_6*tangent_L_y_rx + D_p_rz_6*tangent_L_y_rz + D_p_y_6*tangent_L_x_x + L_x_x*tangent_D_p_y_6
            + L_y_rx*tangent_D_p_rx_6 + L_y_rz*tangent_D_p_rz_6 + tangent_forward_t152;
        const lane t181 = along_13*forward_t135;
        const lane tangent_forward_t153 = g_z*tangent_forward_t135 + t181;
        const lane tangent_f_z_l_1 =
            D_p_rx_1*tangent_L_z_rx + D_p_ry_1*tangent_L_z_ry + D_p_z_1*tangent_L_x_x + L_x_x*tangent_D_p_z_1
            + L_z_rx*tangent_D_p_rx_1 + L_z_ry*tangent_D_p_ry_1 + tangent_forward_t153;
        const lane t182 = along_13*forward_t137;
        const lane tangent_forward_t154 = g_z*tangent_forward_t137 + t182;
        const lane tangent_f_z_l_2 =
            D_p_rx_2*tangent_L_z_rx + D_p_ry_2*tangent_L_z_ry + D_p_z_2*tangent_L_x_x + L_x_x*tangent_D_p_z_2
            + L_z_rx*tangent_D_p_rx_2 + L_z_ry*tangent_D_p_ry_2 + tangent_forward_t154;
        const lane t183 = along_13*forward_t139;
        const lane tangent_forward_t155 = g_z*tangent_forward_t139 + t183;
        const lane tangent_f_z_l_3 =
            D_p_rx_3*tangent_L_z_rx + D_p_ry_3*tangent_L_z_ry + D_p_z_3*tangent_L_x_x + L_x_x*tangent_D_p_z_3
            + L_z_rx*tangent_D_p_rx_3 + L_z_ry*tangent_D_p_ry_3 + tangent_forward_t155;
        const lane t184 = along_13*forward_t141;
        const lane tangent_forward_t156 = g_z*tangent_forward_t141 + t184;
        const lane tangent_f_z_l_4 =
            D_p_rx_4*tangent_L_z_rx + D_p_ry_4*tangent_L_z_ry + D_p_z_4*tangent_L_x_x + L_x_x*tangent_D_p_z_4
            + L_z_rx*tangent_D_p_rx_4 + L_z_ry*tangent_D_p_ry_4 + tangent_forward_t156;
        const lane t185 = along_13*forward_t143;
        const lane tangent_forward_t157 = g_z*tangent_forward_t143 + t185;
        const lane tangent_f_z_l_5 =
            D_p_rx_5*tangent_L_z_rx + D_p_ry_5*tangent_L_z_ry + D_p_z_5*tangent_L_x_x + L_x_x*tangent_D_p_z_5
            + L_z_rx*tangent_D_p_rx_5 + L_z_ry*tangent_D_p_ry_5 + tangent_forward_t157;
        const lane t186 = along_13*forward_t145;
        const lane tangent_forward_t158 = g_z*tangent_forward_t145 + t186;
        const lane tangent_f_z_l_6 =
            D_p_rx_6*tangent_L_z_rx + D_p_ry_6*tangent_L_z_ry + D_p_z_6*tangent_L_x_x + L_x_x*tangent_D_p_z_6
            + L_z_rx*tangent_D_p_rx_6 + L_z_ry*tangent_D_p_ry_6 + tangent_forward_t158;
        const lane tangent_forward_t159 =
            -B_1_y*t181 + B_1_z*t175 + forward_t147*tangent_B_1_z - forward_t153*tangent_B_1_y
            + t78*tangent_forward_t135;
        const lane tangent_f_rx_l_1 =
            D_p_rx_1*tangent_L_rx_rx + D_p_ry_1*tangent_L_rx_ry + D_p_rz_1*tangent_L_rx_rz
            + D_p_y_1*tangent_L_y_rx + D_p_z_1*tangent_L_z_rx + L_rx_rx*tangent_D_p_rx_1
            + L_rx_ry*tangent_D_p_ry_1 + L_rx_rz*tangent_D_p_rz_1 + L_y_rx*tangent_D_p_y_1
            + L_z_rx*tangent_D_p_z_1 - tangent_forward_t159;
        const lane tangent_forward_t160 =
            -B_2_y*t182 + B_2_z*t176 + forward_t148*tangent_B_2_z - forward_t154*tangent_B_2_y
            + t79*tangent_forward_t137;
        const lane tangent_f_rx_l_2 =
            D_p_rx_2*tangent_L_rx_rx + D_p_ry_2*tangent_L_rx_ry + D_p_rz_2*tangent_L_rx_rz
            + D_p_y_2*tangent_L_y_rx + D_p_z_2*tangent_L_z_rx + L_rx_rx*tangent_D_p_rx_2
            + L_rx_ry*tangent_D_p_ry_2 + L_rx_rz*tangent_D_p_rz_2 + L_y_rx*tangent_D_p_y_2
            + L_z_rx*tangent_D_p_z_2 - tangent_forward_t160;
        const lane tangent_forward_t161 =
            -B_3_y*t183 + B_3_z*t177 + forward_t149*tangent_B_3_z - forward_t155*tangent_B_3_y
            + t80*tangent_forward_t139;
        const lane tangent_f_rx_l_3 =
            D_p_rx_3*tangent_L_rx_rx + D_p_ry_3*tangent_L_rx_ry + D_p_rz_3*tangent_L_rx_rz
            + D_p_y_3*tangent_L_y_rx + D_p_z_3*tangent_L_z_rx + L_rx_rx*tangent_D_p_rx_3
            + L_rx_ry*tangent_D_p_ry_3 + L_rx_rz*tangent_D_p_rz_3 + L_y_rx*tangent_D_p_y_3
            + L_z_rx*tangent_D_p_z_3 - tangent_forward_t161;
        const lane tangent_forward_t162 =
            -B_4_y*t184 + B_4_z*t178 + forward_t150*tangent_B_4_z - forward_t156*tangent_B_4_y
            + t81*tangent_forward_t141;
        const lane tangent_f_rx_l_4 =
            D_p_rx_4*tangent_L_rx_rx + D_p_ry_4*tangent_L_rx_ry + D_p_rz_4*tangent_L_rx_rz
            + D_p_y_4*tangent_L_y_rx + D_p_z_4*tangent_L_z_rx + L_rx_rx*tangent_D_p_rx_4
            + L_rx_ry*tangent_D_p_ry_4 + L_rx_rz*tangent_D_p_rz_4 + L_y_rx*tangent_D_p_y_4
            + L_z_rx*tangent_D_p_z_4 - tangent_forward_t162;
        const lane tangent_forward_t163 =
            -B_5_y*t185 + B_5_z*t179 + forward_t151*tangent_B_5_z - forward_t157*tangent_B_5_y
            + t82*tangent_forward_t143;
        const lane tangent_f_rx_l_5 =
            D_p_rx_5*tangent_L_rx_rx + D_p_ry_5*tangent_L_rx_ry + D_p_rz_5*tangent_L_rx_rz
            + D_p_y_5*tangent_L_y_rx + D_p_z_5*tangent_L_z_rx + L_rx_rx*tangent_D_p_rx_5
            + L_rx_ry*tangent_D_p_ry_5 + L_rx_rz*tangent_D_p_rz_5 + L_y_rx*tangent_D_p_y_5
            + L_z_rx*tangent_D_p_z_5 - tangent_forward_t163;
        const lane tangent_forward_t164 =
            -B_6_y*t186 + B_6_z*t180 + forward_t152*tangent_B_6_z - forward_t158*tangent_B_6_y
            + t83*tangent_forward_t145;
        const lane tangent_f_rx_l_6 =
            D_p_rx_6*tangent_L_rx_rx + D_p_ry_6*tangent_L_rx_ry + D_p_rz_6*tangent_L_rx_rz
            + D_p_y_6*tangent_L_y_rx + D_p_z_6*tangent_L_z_rx + L_rx_rx*tangent_D_p_rx_6
            + L_rx_ry*tangent_D_p_ry_6 + L_rx_rz*tangent_D_p_rz_6 + L_y_rx*tangent_D_p_y_6
            + L_z_rx*tangent_D_p_z_6 - tangent_forward_t164;
        const lane tangent_forward_t165 =
            B_1_x*t181 - B_1_z*t169 - forward_t136*tangent_B_1_z + forward_t153*tangent_B_1_x
            + t84*tangent_forward_t135;
        const lane tangent_f_ry_l_1 =
            D_p_rx_1*tangent_L_rx_ry + D_p_ry_1*tangent_L_ry_ry + D_p_rz_1*tangent_L_ry_rz
            + D_p_x_1*tangent_L_x_ry + D_p_z_1*tangent_L_z_ry + L_rx_ry*tangent_D_p_rx_1
            + L_ry_ry*tangent_D_p_ry_1 + L_ry_rz*tangent_D_p_rz_1 + L_x_ry*tangent_D_p_x_1
            + L_z_ry*tangent_D_p_z_1 - tangent_forward_t165;
        const lane tangent_forward_t166 =
            B_2_x*t182 - B_2_z*t170 - forward_t138*tangent_B_2_z + forward_t154*tangent_B_2_x
            + t85*tangent_forward_t137;
        const lane tangent_f_ry_l_2 =
            D_p_rx_2*tangent_L_rx_ry + D_p_ry_2*tangent_L_ry_ry + D_p_rz_2*tangent_L_ry_rz
            + D_p_x_2*tangent_L_x_ry + D_p_z_2*tangent_L_z_ry + L_rx_ry*tangent_D_p_rx_2
            + L_ry_ry*tangent_D_p_ry_2 + L_ry_rz*tangent_D_p_rz_2 + L_x_ry*tangent_D_p_x_2
            + L_z_ry*tangent_D_p_z_2 - tangent_forward_t166;
        const lane tangent_forward_t167 =
            B_3_x*t183 - B_3_z*t171 - forward_t140*tangent_B_3_z + forward_t155*tangent_B_3_x
            + t86*tangent_forward_t139;
        const lane tangent_f_ry_l_3 =
            D_p_rx_3*tangent_L_rx_ry + D_p_ry_3*tangent_L_ry_ry + D_p_rz_3*tangent_L_ry_rz
            + D_p_x_3*tangent_L_x_ry + D_p_z_3*tangent_L_z_ry + L_rx_ry*tangent_D_p_rx_3
            + L_ry_ry*tangent_D_p_ry_3 + L_ry_rz*tangent_D_p_rz_3 + L_x_ry*tangent_D_p_x_3
            + L_z_ry*tangent_D_p_z_3 - tangent_forward_t167;
        const lane tangent_forward_t168 =
            B_4_x*t184 - B_4_z*t172 - forward_t142*tangent_B_4_z + forward_t156*tangent_B_4_x
            + t87*tangent_forward_t141;
        const lane tangent_f_ry_l_4 =
            D_p_rx_4*tangent_L_rx_ry + D_p_ry_4*tangent_L_ry_ry + D_p_rz_4*tangent_L_ry_rz
            + D_p_x_4*tangent_L_x_ry + D_p_z_4*tangent_L_z_ry + L_rx_ry*tangent_D_p_rx_4
            + L_ry_ry*tangent_D_p_ry_4 + L_ry_rz*tangent_D_p_rz_4 + L_x_ry*tangent_D_p_x_4
            + L_z_ry*tangent_D_p_z_4 - tangent_forward_t168;
        const lane tangent_forward_t169 =
            B_5_x*t185 - B_5_z*t173 - forward_t144*tangent_B_5_z + forward_t157*tangent_B_5_x
            + t88*tangent_forward_t143;
        const lane tangent_f_ry_l_5 =
            D_p_rx_5*tangent_L_rx_ry + D_p_ry_5*tangent_L_ry_ry + D_p_rz_5*tangent_L_ry_rz
            + D_p_x_5*tangent_L_x_ry + D_p_z_5*tangent_L_z_ry + L_rx_ry*tangent_D_p_rx_5
            + L_ry_ry*tangent_D_p_ry_5 + L_ry_rz*tangent_D_p_rz_5 + L_x_ry*tangent_D_p_x_5
            + L_z_ry*tangent_D_p_z_5 - tangent_forward_t169;
        const lane tangent_forward_t170 =
            B_6_x*t186 - B_6_z*t174 - forward_t146*tangent_B_6_z + forward_t158*tangent_B_6_x
            + t89*tangent_forward_t145;
        const lane tangent_f_ry_l_6 =
            D_p_rx_6*tangent_L_rx_ry + D_p_ry_6*tangent_L_ry_ry + D_p_rz_6*tangent_L_ry_rz
            + D_p_x_6*tangent_L_x_ry + D_p_z_6*tangent_L_z_ry + L_rx_ry*tangent_D_p_rx_6
            + L_ry_ry*tangent_D_p_ry_6 + L_ry_rz*tangent_D_p_rz_6 + L_x_ry*tangent_D_p_x_6
            + L_z_ry*tangent_D_p_z_6 - tangent_forward_t170;
        const lane tangent_forward_t171 =
            -B_1_x*t175 + B_1_y*t169 + forward_t136*tangent_B_1_y - forward_t147*tangent_B_1_x
            + t90*tangent_forward_t135;
        const lane tangent_f_rz_l_1 =
            D_p_rx_1*tangent_L_rx_rz + D_p_ry_1*tangent_L_ry_rz + D_p_rz_1*tangent_L_rz_rz
            + D_p_x_1*tangent_L_x_rz + D_p_y_1*tangent_L_y_rz + L_rx_rz*tangent_D_p_rx_1
            + L_ry_rz*tangent_D_p_ry_1 + L_rz_rz*tangent_D_p_rz_1 + L_x_rz*tangent_D_p_x_1
            + L_y_rz*tangent_D_p_y_1 - tangent_forward_t171;
        const lane tangent_forward_t172 =
            -B_2_x*t176 + B_2_y*t170 + forward_t138*tangent_B_2_y - forward_t148*tangent_B_2_x
            + t91*tangent_forward_t137;
        const lane tangent_f_rz_l_2 =
            D_p_rx_2*tangent_L_rx_rz + D_p_ry_2*tangent_L_ry_rz + D_p_rz_2*tangent_L_rz_rz
            + D_p_x_2*tangent_L_x_rz + D_p_y_2*tangent_L_y_rz + L_rx_rz*tangent_D_p_rx_2
            + L_ry_rz*tangent_D_p_ry_2 + L_rz_rz*tangent_D_p_rz_2 + L_x_rz*tangent_D_p_x_2
            + L_y_rz*tangent_D_p_y_2 - tangent_forward_t172;
        const lane tangent_forward_t173 =
            -B_3_x*t177 + B_3_y*t171 + forward_t140*tangent_B_3_y - forward_t149*tangent_B_3_x
            + t92*tangent_forward_t139;
        const lane tangent_f_rz_l_3 =
            D_p_rx_3*tangent_L_rx_rz + D_p_ry_3*tangent_L_ry_rz + D_p_rz_3*tangent_L_rz_rz
            + D_p_x_3*tangent_L_x_rz + D_p_y_3*tangent_L_y_rz + L_rx_rz*tangent_D_p_rx_3
            + L_ry_rz*tangent_D_p_ry_3 + L_rz_rz*tangent_D_p_rz_3 + L_x_rz*tangent_D_p_x_3
            + L_y_rz*tangent_D_p_y_3 - tangent_forward_t173;
        const lane tangent_forward_t174 =
            -B_4_x*t178 + B_4_y*t172 + forward_t142*tangent_B_4_y - forward_t150*tangent_B_4_x
            + t93*tangent_forward_t141;
        const lane tangent_f_rz_l_4 =
            D_p_rx_4*tangent_L_rx_rz + D_p_ry_4*tangent_L_ry_rz + D_p_rz_4*tangent_L_rz_rz
            + D_p_x_4*tangent_L_x_rz + D_p_y_4*tangent_L_y_rz + L_rx_rz*tangent_D_p_rx_4
            + L_ry_rz*tangent_D_p_ry_4 + L_rz_rz*tangent_D_p_rz_4 + L_x_rz*tangent_D_p_x_4
            + L_y_rz*tangent_D_p_y_4 - tangent_forward_t174;
        const lane tangent_forward_t175 =
            -B_5_x*t179 + B_5_y*t173 + forward_t144*tangent_B_5_y - forward_t151*tangent_B_5_x
            + t94*tangent_forward_t143;
        const lane tangent_f_rz_l_5 =
            D_p_rx_5*tangent_L_rx_rz + D_p_ry_5*tangent_L_ry_rz + D_p_rz_5*tangent_L_rz_rz
            + D_p_x_5*tangent_L_x_rz + D_p_y_5*tangent_L_y_rz + L_rx_rz*tangent_D_p_rx_5
            + L_ry_rz*tangent_D_p_ry_5 + L_rz_rz*tangent_D_p_rz_5 + L_x_rz*tangent_D_p_x_5
            + L_y_rz*tangent_D_p_y_5 - tangent_forward_t175;
        const lane tangent_forward_t176 =
            -B_6_x*t180 + B_6_y*t174 + forward_t146*tangent_B_6_y - forward_t152*tangent_B_6_x
            + t95*tangent_forward_t145;
        const lane tangent_f_rz_l_6 =
            D_p_rx_6*tangent_L_rx_rz + D_p_ry_6*tangent_L_ry_rz + D_p_rz_6*tangent_L_rz_rz
            + D_p_x_6*tangent_L_x_rz + D_p_y_6*tangent_L_y_rz + L_rx_rz*tangent_D_p_rx_6
            + L_ry_rz*tangent_D_p_ry_6 + L_rz_rz*tangent_D_p_rz_6 + L_x_rz*tangent_D_p_x_6
            + L_y_rz*tangent_D_p_y_6 - tangent_forward_t176;
        const lane tangent_M_p_x_x =
            tangent_forward_t67 + tangent_m_perp_1 + tangent_m_perp_2 + tangent_m_perp_3 + tangent_m_perp_4
            + tangent_m_perp_5 + tangent_m_perp_6;
        const lane tangent_forward_t177 = B_1_z*tangent_m_perp_1 + m_perp_1*tangent_B_1_z;
        const lane tangent_forward_t178 = B_2_z*tangent_m_perp_2 + m_perp_2*tangent_B_2_z;
        const lane tangent_forward_t179 = B_3_z*tangent_m_perp_3 + m_perp_3*tangent_B_3_z;
        const lane tangent_forward_t180 = B_4_z*tangent_m_perp_4 + m_perp_4*tangent_B_4_z;
        const lane tangent_forward_t181 = B_5_z*tangent_m_perp_5 + m_perp_5*tangent_B_5_z;
        const lane tangent_forward_t182 = B_6_z*tangent_m_perp_6 + m_perp_6*tangent_B_6_z;
        const lane tangent_forward_t183 = along_1*c_z + m_p*tangent_c_z;
        const lane tangent_forward_t184 = along_125*o_L_z + m_L*tangent_o_L_z;
        const lane tangent_M_p_x_ry =
            tangent_forward_t177 + tangent_forward_t178 + tangent_forward_t179 + tangent_forward_t180
            + tangent_forward_t181 + tangent_forward_t182 + tangent_forward_t183 + tangent_forward_t184;
        const lane tangent_forward_t185 = B_1_y*tangent_m_perp_1 + m_perp_1*tangent_B_1_y;
        const lane tangent_forward_t186 = B_2_y*tangent_m_perp_2 + m_perp_2*tangent_B_2_y;
        const lane tangent_forward_t187 = B_3_y*tangent_m_perp_3 + m_perp_3*tangent_B_3_y;
        const lane tangent_forward_t188 = B_4_y*tangent_m_perp_4 + m_perp_4*tangent_B_4_y;
        const lane tangent_forward_t189 = B_5_y*tangent_m_perp_5 + m_perp_5*tangent_B_5_y;
        const lane tangent_forward_t190 = B_6_y*tangent_m_perp_6 + m_perp_6*tangent_B_6_y;
        const lane tangent_forward_t191 = along_1*c_y + m_p*tangent_c_y;
        const lane tangent_forward_t192 = along_125*o_L_y + m_L*tangent_o_L_y;
        const lane tangent_M_p_z_rx =
            tangent_forward_t185 + tangent_forward_t186 + tangent_forward_t187 + tangent_forward_t188
            + tangent_forward_t189 + tangent_forward_t190 + tangent_forward_t191 + tangent_forward_t192;
        const lane tangent_M_p_x_rz = -tangent_M_p_z_rx;
        const lane tangent_M_p_y_rx = -tangent_M_p_x_ry;
        const lane tangent_forward_t193 = B_1_x*tangent_m_perp_1 + m_perp_1*tangent_B_1_x;
        const lane tangent_forward_t194 = B_2_x*tangent_m_perp_2 + m_perp_2*tangent_B_2_x;
        const lane tangent_forward_t195 = B_3_x*tangent_m_perp_3 + m_perp_3*tangent_B_3_x;
        const lane tangent_forward_t196 = B_4_x*tangent_m_perp_4 + m_perp_4*tangent_B_4_x;
        const lane tangent_forward_t197 = B_5_x*tangent_m_perp_5 + m_perp_5*tangent_B_5_x;
        const lane tangent_forward_t198 = B_6_x*tangent_m_perp_6 + m_perp_6*tangent_B_6_x;
        const lane tangent_M_p_y_rz =
            along_1*c_x + along_125*o_L_x + m_L*tangent_o_L_x + m_p*tangent_c_x + tangent_forward_t193
            + tangent_forward_t194 + tangent_forward_t195 + tangent_forward_t196 + tangent_forward_t197
            + tangent_forward_t198;
        const lane tangent_M_p_z_ry = -tangent_M_p_y_rz;
        const lane tangent_forward_t199 = 4.0*o_L_y*tangent_o_L_y;
        const lane tangent_forward_t200 = 4.0*o_L_z*tangent_o_L_z;
        const lane tangent_forward_t201 = (1.0/2.0)*along_125;
        const lane tangent_forward_t202 = 4.0*c_y*tangent_c_y;
        const lane tangent_forward_t203 = 4.0*c_z*tangent_c_z;
        const lane tangent_forward_t204 = (1.0/2.0)*along_1;
        const lane tangent_forward_t205 = 2.0*tangent_forward_t105;
        const lane tangent_forward_t206 = 2.0*tangent_forward_t98;
        const lane tangent_forward_t207 = (1.0/2.0)*tangent_m_perp_1;
        const lane tangent_forward_t208 = 2.0*tangent_forward_t106;
        const lane tangent_forward_t209 = 2.0*tangent_forward_t99;
        const lane tangent_forward_t210 = (1.0/2.0)*tangent_m_perp_2;
        const lane tangent_forward_t211 = 2.0*tangent_forward_t107;
        const lane tangent_forward_t212 = 2.0*tangent_forward_t100;
        const lane tangent_forward_t213 = (1.0/2.0)*tangent_m_perp_3;
        const lane tangent_forward_t214 = 2.0*tangent_forward_t108;
        const lane tangent_forward_t215 = 2.0*tangent_forward_t101;
        const lane tangent_forward_t216 = (1.0/2.0)*tangent_m_perp_4;
        const lane tangent_forward_t217 = 2.0*tangent_forward_t109;
        const lane tangent_forward_t218 = 2.0*tangent_forward_t102;
        const lane tangent_forward_t219 = (1.0/2.0)*tangent_m_perp_5;
        const lane tangent_forward_t220 = 2.0*tangent_forward_t110;
        const lane tangent_forward_t221 = 2.0*tangent_forward_t103;
        const lane tangent_forward_t222 = (1.0/2.0)*tangent_m_perp_6;
        const lane t187 =
            forward_t201*tangent_forward_t200 + forward_t204*tangent_forward_t203
            + forward_t207*tangent_forward_t206 + forward_t210*tangent_forward_t209
            + forward_t213*tangent_forward_t212 + forward_t216*tangent_forward_t215
            + forward_t219*tangent_forward_t218 + forward_t222*tangent_forward_t221;
        const lane t188 =
            forward_t201*tangent_forward_t199 + forward_t204*tangent_forward_t202
            + forward_t207*tangent_forward_t205 + forward_t210*tangent_forward_t208
            + forward_t213*tangent_forward_t211 + forward_t216*tangent_forward_t214
            + forward_t219*tangent_forward_t217 + forward_t222*tangent_forward_t220;
        const lane tangent_M_p_rx_rx =
            t100*tangent_forward_t213 + t101*tangent_forward_t216 + t102*tangent_forward_t219
            + t103*tangent_forward_t222 + t187 + t188 + t96*tangent_forward_t201 + t97*tangent_forward_t204
            + t98*tangent_forward_t207 + t99*tangent_forward_t210 + tangent_J_x_x;
        const lane tangent_M_p_rx_ry =
            -B_1_x*tangent_forward_t185 - B_2_x*tangent_forward_t186 - B_3_x*tangent_forward_t187
            - B_4_x*tangent_forward_t188 - B_5_x*tangent_forward_t189 - B_6_x*tangent_forward_t190
            - c_x*tangent_forward_t191 - forward_t185*tangent_B_1_x - forward_t186*tangent_B_2_x
            - forward_t187*tangent_B_3_x - forward_t188*tangent_B_4_x - forward_t189*tangent_B_5_x
            - forward_t190*tangent_B_6_x - forward_t191*tangent_c_x - forward_t192*tangent_o_L_x
            - o_L_x*tangent_forward_t192 + tangent_J_x_y;
        const lane tangent_M_p_rx_rz =
            -B_1_x*tangent_forward_t177 - B_2_x*tangent_forward_t178 - B_3_x*tangent_forward_t179
            - B_4_x*tangent_forward_t180 - B_5_x*tangent_forward_t181 - B_6_x*tangent_forward_t182
            - c_x*tangent_forward_t183 - forward_t177*tangent_B_1_x - forward_t178*tangent_B_2_x
            - forward_t179*tangent_B_3_x - forward_t180*tangent_B_4_x - forward_t181*tangent_B_5_x
            - forward_t182*tangent_B_6_x - forward_t183*tangent_c_x - forward_t184*tangent_o_L_x
            - o_L_x*tangent_forward_t184 + tangent_J_x_z;
        const lane tangent_forward_t223 = 4.0*o_L_x*tangent_o_L_x;
        const lane tangent_forward_t224 = 4.0*c_x*tangent_c_x;
        const lane tangent_forward_t225 = 2.0*tangent_forward_t128;
        const lane tangent_forward_t226 = 2.0*tangent_forward_t129;
        const lane tangent_forward_t227 = 2.0*tangent_forward_t130;
        const lane tangent_forward_t228 = 2.0*tangent_forward_t131;
        const lane tangent_forward_t229 = 2.0*tangent_forward_t132;
        const lane tangent_forward_t230 = 2.0*tangent_forward_t133;
        const lane t189 =
            forward_t201*tangent_forward_t223 + forward_t204*tangent_forward_t224
            + forward_t207*tangent_forward_t225 + forward_t210*tangent_forward_t226
            + forward_t213*tangent_forward_t227 + forward_t216*tangent_forward_t228
            + forward_t219*tangent_forward_t229 + forward_t222*tangent_forward_t230;
        const lane tangent_M_p_ry_ry =
            t104*tangent_forward_t201 + t105*tangent_forward_t204 + t106*tangent_forward_t207
            + t107*tangent_forward_t210 + t108*tangent_forward_t213 + t109*tangent_forward_t216
            + t110*tangent_forward_t219 + t111*tangent_forward_t222 + t187 + t189 + tangent_J_y_y;
        const lane tangent_M_p_ry_rz =
            -B_1_y*tangent_forward_t177 - B_2_y*tangent_forward_t178 - B_3_y*tangent_forward_t179
            - B_4_y*tangent_forward_t180 - B_5_y*tangent_forward_t181 - B_6_y*tangent_forward_t182
            - c_y*tangent_forward_t183 - forward_t177*tangent_B_1_y - forward_t178*tangent_B_2_y
            - forward_t179*tangent_B_3_y - forward_t180*tangent_B_4_y - forward_t181*tangent_B_5_y
            - forward_t182*tangent_B_6_y - forward_t183*tangent_c_y - forward_t184*tangent_o_L_y
            - o_L_y*tangent_forward_t184 + tangent_J_y_z;
        const lane tangent_M_p_rz_rz =
            t112*tangent_forward_t201 + t113*tangent_forward_t204 + t114*tangent_forward_t207
            + t115*tangent_forward_t210 + t116*tangent_forward_t213 + t117*tangent_forward_t216
            + t118*tangent_forward_t219 + t119*tangent_forward_t222 + t188 + t189 + tangent_J_z_z;
        const lane tangent_h_x_l_1 =
            D_p_ry_1*tangent_M_p_x_ry + D_p_rz_1*tangent_M_p_x_rz + D_p_x_1*tangent_M_p_x_x
            + M_p_x_ry*tangent_D_p_ry_1 + M_p_x_rz*tangent_D_p_rz_1 + M_p_x_x*tangent_D_p_x_1;
        const lane tangent_h_x_l_2 =
            D_p_ry_2*tangent_M_p_x_ry + D_p_rz_2*tangent_M_p_x_rz + D_p_x_2*tangent_M_p_x_x
            + M_p_x_ry*tangent_D_p_ry_2 + M_p_x_rz*tangent_D_p_rz_2 + M_p_x_x*tangent_D_p_x_2;
        const lane tangent_h_x_l_3 =
            D_p_ry_3*tangent_M_p_x_ry + D_p_rz_3*tangent_M_p_x_rz + D_p_x_3*tangent_M_p_x_x
            + M_p_x_ry*tangent_D_p_ry_3 + M_p_x_rz*tangent_D_p_rz_3 + M_p_x_x*tangent_D_p_x_3;
        const lane tangent_h_x_l_4 =
            D_p_ry_4*tangent_M_p_x_ry + D_p_rz_4*tangent_M_p_x_rz + D_p_x_4*tangent_M_p_x_x
            + M_p_x_ry*tangent_D_p_ry_4 + M_p_x_rz*tangent_D_p_rz_4 + M_p_x_x*tangent_D_p_x_4;
        const lane tangent_h_x_l_5 =
            D_p_ry_5*tangent_M_p_x_ry + D_p_rz_5*tangent_M_p_x_rz + D_p_x_5*tangent_M_p_x_x
            + M_p_x_ry*tangent_D_p_ry_5 + M_p_x_rz*tangent_D_p_rz_5 + M_p_x_x*tangent_D_p_x_5;
        const lane tangent_h_x_l_6 =
            D_p_ry_6*tangent_M_p_x_ry + D_p_rz_6*tangent_M_p_x_rz + D_p_x_6*tangent_M_p_x_x
            + M_p_x_ry*tangent_D_p_ry_6 + M_p_x_rz*tangent_D_p_rz_6 + M_p_x_x*tangent_D_p_x_6;
        const lane tangent_forward_t231 =
            tangent_m_lift_1 + tangent_m_lift_2 + tangent_m_lift_3 + tangent_m_lift_4 + tangent_m_lift_5
            + tangent_m_lift_6 - tangent_m_perp_1 - tangent_m_perp_2 - tangent_m_perp_3 - tangent_m_perp_4
            - tangent_m_perp_5 - tangent_m_perp_6;
        const lane tangent_h_x_u_x = tangent_M_p_x_x + tangent_forward_t231;
        const lane tangent_h_y_l_1 =
            D_p_rx_1*tangent_M_p_y_rx + D_p_rz_1*tangent_M_p_y_rz + D_p_y_1*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_y_1 + M_p_y_rx*tangent_D_p_rx_1 + M_p_y_rz*tangent_D_p_rz_1;
        const lane tangent_h_y_l_2 =
            D_p_rx_2*tangent_M_p_y_rx + D_p_rz_2*tangent_M_p_y_rz + D_p_y_2*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_y_2 + M_p_y_rx*tangent_D_p_rx_2 + M_p_y_rz*tangent_D_p_rz_2;
        const lane tangent_h_y_l_3 =
            D_p_rx_3*tangent_M_p_y_rx + D_p_rz_3*tangent_M_p_y_rz + D_p_y_3*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_y_3 + M_p_y_rx*tangent_D_p_rx_3 + M_p_y_rz*tangent_D_p_rz_3;
        const lane tangent_h_y_l_4 =
            D_p_rx_4*tangent_M_p_y_rx + D_p_rz_4*tangent_M_p_y_rz + D_p_y_4*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_y_4 + M_p_y_rx*tangent_D_p_rx_4 + M_p_y_rz*tangent_D_p_rz_4;
        const lane tangent_h_y_l_5 =
            D_p_rx_5*tangent_M_p_y_rx + D_p_rz_5*tangent_M_p_y_rz + D_p_y_5*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_y_5 + M_p_y_rx*tangent_D_p_rx_5 + M_p_y_rz*tangent_D_p_rz_5;
        const lane tangent_h_y_l_6 =
            D_p_rx_6*tangent_M_p_y_rx + D_p_rz_6*tangent_M_p_y_rz + D_p_y_6*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_y_6 + M_p_y_rx*tangent_D_p_rx_6 + M_p_y_rz*tangent_D_p_rz_6;
        const lane tangent_h_z_l_1 =
            D_p_rx_1*tangent_M_p_z_rx + D_p_ry_1*tangent_M_p_z_ry + D_p_z_1*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_z_1 + M_p_z_rx*tangent_D_p_rx_1 + M_p_z_ry*tangent_D_p_ry_1;
        const lane tangent_h_z_l_2 =
            D_p_rx_2*tangent_M_p_z_rx + D_p_ry_2*tangent_M_p_z_ry + D_p_z_2*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_z_2 + M_p_z_rx*tangent_D_p_rx_2 + M_p_z_ry*tangent_D_p_ry_2;
        const lane tangent_h_z_l_3 =
            D_p_rx_3*tangent_M_p_z_rx + D_p_ry_3*tangent_M_p_z_ry + D_p_z_3*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_z_3 + M_p_z_rx*tangent_D_p_rx_3 + M_p_z_ry*tangent_D_p_ry_3;
        const lane tangent_h_z_l_4 =
            D_p_rx_4*tangent_M_p_z_rx + D_p_ry_4*tangent_M_p_z_ry + D_p_z_4*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_z_4 + M_p_z_rx*tangent_D_p_rx_4 + M_p_z_ry*tangent_D_p_ry_4;
        const lane tangent_h_z_l_5 =
            D_p_rx_5*tangent_M_p_z_rx + D_p_ry_5*tangent_M_p_z_ry + D_p_z_5*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_z_5 + M_p_z_rx*tangent_D_p_rx_5 + M_p_z_ry*tangent_D_p_ry_5;
        const lane tangent_h_z_l_6 =
            D_p_rx_6*tangent_M_p_z_rx + D_p_ry_6*tangent_M_p_z_ry + D_p_z_6*tangent_M_p_x_x
            + M_p_x_x*tangent_D_p_z_6 + M_p_z_rx*tangent_D_p_rx_6 + M_p_z_ry*tangent_D_p_ry_6;
        const lane tangent_h_rx_l_1 =
            D_p_rx_1*tangent_M_p_rx_rx + D_p_ry_1*tangent_M_p_rx_ry + D_p_rz_1*tangent_M_p_rx_rz
            + D_p_y_1*tangent_M_p_y_rx + D_p_z_1*tangent_M_p_z_rx + M_p_rx_rx*tangent_D_p_rx_1
            + M_p_rx_ry*tangent_D_p_ry_1 + M_p_rx_rz*tangent_D_p_rz_1 + M_p_y_rx*tangent_D_p_y_1
            + M_p_z_rx*tangent_D_p_z_1;
        const lane tangent_h_rx_l_2 =
            D_p_rx_2*tangent_M_p_rx_rx + D_p_ry_2*tangent_M_p_rx_ry + D_p_rz_2*tangent_M_p_rx_rz
            + D_p_y_2*tangent_M_p_y_rx + D_p_z_2*tangent_M_p_z_rx + M_p_rx_rx*tangent_D_p_rx_2
            + M_p_rx_ry*tangent_D_p_ry_2 + M_p_rx_rz*tangent_D_p_rz_2 + M_p_y_rx*tangent_D_p_y_2
            + M_p_z_rx*tangent_D_p_z_2;
        const lane tangent_h_rx_l_3 =
            D_p_rx_3*tangent_M_p_rx_rx + D_p_ry_3*tangent_M_p_rx_ry + D_p_rz_3*tangent_M_p_rx_rz
            + D_p_y_3*tangent_M_p_y_rx + D_p_z_3*tangent_M_p_z_rx + M_p_rx_rx*tangent_D_p_rx_3
            + M_p_rx_ry*tangent_D_p_ry_3 + M_p_rx_rz*tangent_D_p_rz_3 + M_p_y_rx*tangent_D_p_y_3
            + M_p_z_rx*tangent_D_p_z_3;
        const lane tangent_h_rx_l_4 =
            D_p_rx_4*tangent_M_p_rx_rx + D_p_ry_4*tangent_M_p_rx_ry + D_p_rz_4*tangent_M_p_rx_rz
            + D_p_y_4*tangent_M_p_y_rx + D_p_z_4*tangent_M_p_z_rx + M_p_rx_rx*tangent_D_p_rx_4
            + M_p_rx_ry*tangent_D_p_ry_4 + M_p_rx_rz*tangent_D_p_rz_4 + M_p_y_rx*tangent_D_p_y_4
            + M_p_z_rx*tangent_D_p_z_4;
        const lane tangent_h_rx_l_5 =
            D_p_rx_5*tangent_M_p_rx_rx + D_p_ry_5*tangent_M_p_rx_ry + D_p_rz_5*tangent_M_p_rx_rz
            + D_p_y_5*tangent_M_p_y_rx + D_p_z_5*tangent_M_p_z_rx + M_p_rx_rx*tangent_D_p_rx_5
            + M_p_rx_ry*tangent_D_p_ry_5 + M_p_rx_rz*tangent_D_p_rz_5 + M_p_y_rx*tangent_D_p_y_5
            + M_p_z_rx*tangent_D_p_z_5;
        const lane tangent_h_rx_l_6 =
            D_p_rx_6*tangent_M_p_rx_rx + D_p_ry_6*tangent_M_p_rx_ry + D_p_rz_6*tangent_M_p_rx_rz
            + D_p_y_6*tangent_M_p_y_rx + D_p_z_6*tangent_M_p_z_rx + M_p_rx_rx*tangent_D_p_rx_6
            + M_p_rx_ry*tangent_D_p_ry_6 + M_p_rx_rz*tangent_D_p_rz_6 + M_p_y_rx*tangent_D_p_y_6
            + M_p_z_rx*tangent_D_p_z_6;
        const lane tangent_forward_t232 =
            B_1_z*along_86 + B_1_z*tangent_forward_t33 + B_2_z*along_87 + B_2_z*tangent_forward_t37
            + B_3_z*along_88 + B_3_z*tangent_forward_t41 + B_4_z*along_89 + B_4_z*tangent_forward_t45
            + B_5_z*along_90 + B_5_z*tangent_forward_t49 + B_6_z*along_91 + B_6_z*tangent_forward_t53
            + m_lift_1*tangent_B_1_z + m_lift_2*tangent_B_2_z + m_lift_3*tangent_B_3_z
            + m_lift_4*tangent_B_4_z + m_lift_5*tangent_B_5_z + m_lift_6*tangent_B_6_z - tangent_forward_t177
            - tangent_forward_t178 - tangent_forward_t179 - tangent_forward_t180 - tangent_forward_t181
            - tangent_forward_t182;
        const lane tangent_h_rx_u_y = tangent_M_p_y_rx - tangent_forward_t232;
        const lane tangent_forward_t233 =
            B_1_y*along_86 + B_1_y*tangent_forward_t33 + B_2_y*along_87 + B_2_y*tangent_forward_t37
            + B_3_y*along_88 + B_3_y*tangent_forward_t41 + B_4_y*along_89 + B_4_y*tangent_forward_t45
            + B_5_y*along_90 + B_5_y*tangent_forward_t49 + B_6_y*along_91 + B_6_y*tangent_forward_t53
            + m_lift_1*tangent_B_1_y + m_lift_2*tangent_B_2_y + m_lift_3*tangent_B_3_y
            + m_lift_4*tangent_B_4_y + m_lift_5*tangent_B_5_y + m_lift_6*tangent_B_6_y - tangent_forward_t185
            - tangent_forward_t186 - tangent_forward_t187 - tangent_forward_t188 - tangent_forward_t189
            - tangent_forward_t190;
        const lane tangent_h_rx_u_z = tangent_M_p_z_rx + tangent_forward_t233;
        const lane tangent_h_ry_l_1 =
            D_p_rx_1*tangent_M_p_rx_ry + D_p_ry_1*tangent_M_p_ry_ry + D_p_rz_1*tangent_M_p_ry_rz
            + D_p_x_1*tangent_M_p_x_ry + D_p_z_1*tangent_M_p_z_ry + M_p_rx_ry*tangent_D_p_rx_1
            + M_p_ry_ry*tangent_D_p_ry_1 + M_p_ry_rz*tangent_D_p_rz_1 + M_p_x_ry*tangent_D_p_x_1
            + M_p_z_ry*tangent_D_p_z_1;
        const lane tangent_h_ry_l_2 =
            D_p_rx_2*tangent_M_p_rx_ry + D_p_ry_2*tangent_M_p_ry_ry + D_p_rz_2*tangent_M_p_ry_rz
            + D_p_x_2*tangent_M_p_x_ry + D_p_z_2*tangent_M_p_z_ry + M_p_rx_ry*tangent_D_p_rx_2
            + M_p_ry_ry*tangent_D_p_ry_2 + M_p_ry_rz*tangent_D_p_rz_2 + M_p_x_ry*tangent_D_p_x_2
            + M_p_z_ry*tangent_D_p_z_2;
        const lane tangent_h_ry_l_3 =
            D_p_rx_3*tangent_M_p_rx_ry + D_p_ry_3*tangent_M_p_ry_ry + D_p_rz_3*tangent_M_p_ry_rz
            + D_p_x_3*tangent_M_p_x_ry + D_p_z_3*tangent_M_p_z_ry + M_p_rx_ry*tangent_D_p_rx_3
            + M_p_ry_ry*tangent_D_p_ry_3 + M_p_ry_rz*tangent_D_p_rz_3 + M_p_x_ry*tangent_D_p_x_3
            + M_p_z_ry*tangent_D_p_z_3;
        const lane tangent_h_ry_l_4 =
            D_p_rx_4*tangent_M_p_rx_ry + D_p_ry_4*tangent_M_p_ry_ry + D_p_rz_4*tangent_M_p_ry_rz
            + D_p_x_4*tangent_M_p_x_ry + D_p_z_4*tangent_M_p_z_ry + M_p_rx_ry*tangent_D_p_rx_4
            + M_p_ry_ry*tangent_D_p_ry_4 + M_p_ry_rz*tangent_D_p_rz_4 + M_p_x_ry*tangent_D_p_x_4
            + M_p_z_ry*tangent_D_p_z_4;
        const lane tangent_h_ry_l_5 =
            D_p_rx_5*tangent_M_p_rx_ry + D_p_ry_5*tangent_M_p_ry_ry + D_p_rz_5*tangent_M_p_ry_rz
            + D_p_x_5*tangent_M_p_x_ry + D_p_z_5*tangent_M_p_z_ry + M_p_rx_ry*tangent_D_p_rx_5
            + M_p_ry_ry*tangent_D_p_ry_5 + M_p_ry_rz*tangent_D_p_rz_5 + M_p_x_ry*tangent_D_p_x_5
            + M_p_z_ry*tangent_D_p_z_5;
        const lane tangent_h_ry_l_6 =
            D_p_rx_6*tangent_M_p_rx_ry + D_p_ry_6*tangent_M_p_ry_ry + D_p_rz_6*tangent_M_p_ry_rz
            + D_p_x_6*tangent_M_p_x_ry + D_p_z_6*tangent_M_p_z_ry + M_p_rx_ry*tangent_D_p_rx_6
            + M_p_ry_ry*tangent_D_p_ry_6 + M_p_ry_rz*tangent_D_p_rz_6 + M_p_x_ry*tangent_D_p_x_6
            + M_p_z_ry*tangent_D_p_z_6;
        const lane tangent_h_ry_u_x = tangent_M_p_x_ry + tangent_forward_t232;
        const lane tangent_forward_t234 =
            B_1_x*along_86 + B_1_x*tangent_forward_t33 + B_2_x*along_87 + B_2_x*tangent_forward_t37
            + B_3_x*along_88 + B_3_x*tangent_forward_t41 + B_4_x*along_89 + B_4_x*tangent_forward_t45
            + B_5_x*along_90 + B_5_x*tangent_forward_t49 + B_6_x*along_91 + B_6_x*tangent_forward_t53
            + m_lift_1*tangent_B_1_x + m_lift_2*tangent_B_2_x + m_lift_3*tangent_B_3_x
            + m_lift_4*tangent_B_4_x + m_lift_5*tangent_B_5_x + m_lift_6*tangent_B_6_x - tangent_forward_t193
            - tangent_forward_t194 - tangent_forward_t195 - tangent_forward_t196 - tangent_forward_t197
            - tangent_forward_t198;
        const lane tangent_h_ry_u_z = tangent_M_p_z_ry - tangent_forward_t234;
        const lane tangent_h_rz_l_1 =
            D_p_rx_1*tangent_M_p_rx_rz + D_p_ry_1*tangent_M_p_ry_rz + D_p_rz_1*tangent_M_p_rz_rz
            + D_p_x_1*tangent_M_p_x_rz + D_p_y_1*tangent_M_p_y_rz + M_p_rx_rz*tangent_D_p_rx_1
            + M_p_ry_rz*tangent_D_p_ry_1 + M_p_rz_rz*tangent_D_p_rz_1 + M_p_x_rz*tangent_D_p_x_1
            + M_p_y_rz*tangent_D_p_y_1;
        const lane tangent_h_rz_l_2 =
            D_p_rx_2*tangent_M_p_rx_rz + D_p_ry_2*tangent_M_p_ry_rz + D_p_rz_2*tangent_M_p_rz_rz
            + D_p_x_2*tangent_M_p_x_rz + D_p_y_2*tangent_M_p_y_rz + M_p_rx_rz*tangent_D_p_rx_2
            + M_p_ry_rz*tangent_D_p_ry_2 + M_p_rz_rz*tangent_D_p_rz_2 + M_p_x_rz*tangent_D_p_x_2
            + M_p_y_rz*tangent_D_p_y_2;
        const lane tangent_h_rz_l_3 =
            D_p_rx_3*tangent_M_p_rx_rz + D_p_ry_3*tangent_M_p_ry_rz + D_p_rz_3*tangent_M_p_rz_rz
            + D_p_x_3*tangent_M_p_x_rz + D_p_y_3*tangent_M_p_y_rz + M_p_rx_rz*tangent_D_p_rx_3
            + M_p_ry_rz*tangent_D_p_ry_3 + M_p_rz_rz*tangent_D_p_rz_3 + M_p_x_rz*tangent_D_p_x_3
            + M_p_y_rz*tangent_D_p_y_3;
        const lane tangent_h_rz_l_4 =
            D_p_rx_4*tangent_M_p_rx_rz + D_p_ry_4*tangent_M_p_ry_rz + D_p_rz_4*tangent_M_p_rz_rz
            + D_p_x_4*tangent_M_p_x_rz + D_p_y_4*tangent_M_p_y_rz + M_p_rx_rz*tangent_D_p_rx_4
            + M_p_ry_rz*tangent_D_p_ry_4 + M_p_rz_rz*tangent_D_p_rz_4 + M_p_x_rz*tangent_D_p_x_4
            + M_p_y_rz*tangent_D_p_y_4;
        const lane tangent_h_rz_l_5 =
            D_p_rx_5*tangent_M_p_rx_rz + D_p_ry_5*tangent_M_p_ry_rz + D_p_rz_5*tangent_M_p_rz_rz
            + D_p_x_5*tangent_M_p_x_rz + D_p_y_5*tangent_M_p_y_rz + M_p_rx_rz*tangent_D_p_rx_5
            + M_p_ry_rz*tangent_D_p_ry_5 + M_p_rz_rz*tangent_D_p_rz_5 + M_p_x_rz*tangent_D_p_x_5
            + M_p_y_rz*tangent_D_p_y_5;
        const lane tangent_h_rz_l_6 =
            D_p_rx_6*tangent_M_p_rx_rz + D_p_ry_6*tangent_M_p_ry_rz + D_p_rz_6*tangent_M_p_rz_rz
            + D_p_x_6*tangent_M_p_x_rz + D_p_y_6*tangent_M_p_y_rz + M_p_rx_rz*tangent_D_p_rx_6
            + M_p_ry_rz*tangent_D_p_ry_6 + M_p_rz_rz*tangent_D_p_rz_6 + M_p_x_rz*tangent_D_p_x_6
            + M_p_y_rz*tangent_D_p_y_6;
        const lane tangent_h_rz_u_x = tangent_M_p_x_rz - tangent_forward_t233;
        const lane tangent_h_rz_u_y = tangent_M_p_y_rz + tangent_forward_t234;
        const lane tangent_forward_t235 =
            along_131 + along_68 + along_69 + along_70 + along_71 + along_72 + along_73 - tangent_forward_t33
            - tangent_forward_t37 - tangent_forward_t41 - tangent_forward_t45 - tangent_forward_t49
            - tangent_forward_t53;
        const lane tangent_forward_t236 = D_p_x_1*along_122 + k_C*tangent_D_p_x_1;
        const lane tangent_forward_t237 = D_p_y_1*along_122 + k_C*tangent_D_p_y_1;
        const lane tangent_forward_t238 = D_p_z_1*along_122 + k_C*tangent_D_p_z_1;
        const lane tangent_forward_t239 = D_p_x_2*along_122 + k_C*tangent_D_p_x_2;
        const lane tangent_forward_t240 = D_p_y_2*along_122 + k_C*tangent_D_p_y_2;
        const lane tangent_forward_t241 = D_p_z_2*along_122 + k_C*tangent_D_p_z_2;
        const lane tangent_forward_t242 = D_p_x_3*along_122 + k_C*tangent_D_p_x_3;
        const lane tangent_forward_t243 = D_p_y_3*along_122 + k_C*tangent_D_p_y_3;
        const lane tangent_forward_t244 = D_p_z_3*along_122 + k_C*tangent_D_p_z_3;
        const lane tangent_forward_t245 = D_p_x_4*along_122 + k_C*tangent_D_p_x_4;
        const lane tangent_forward_t246 = D_p_y_4*along_122 + k_C*tangent_D_p_y_4;
        const lane tangent_forward_t247 = D_p_z_4*along_122 + k_C*tangent_D_p_z_4;
        const lane tangent_forward_t248 = D_p_x_5*along_122 + k_C*tangent_D_p_x_5;
        const lane tangent_forward_t249 = D_p_y_5*along_122 + k_C*tangent_D_p_y_5;
        const lane tangent_forward_t250 = D_p_z_5*along_122 + k_C*tangent_D_p_z_5;
        const lane tangent_forward_23 = -2.0*along_110/(h_m_1*h_m_1*h_m_1);
        const lane tangent_forward_24 = -2.0*along_111/(h_m_2*h_m_2*h_m_2);
        const lane tangent_forward_25 = -2.0*along_112/(h_m_3*h_m_3*h_m_3);
        const lane tangent_forward_26 = -2.0*along_113/(h_m_4*h_m_4*h_m_4);
        const lane tangent_forward_27 = -2.0*along_114/(h_m_5*h_m_5*h_m_5);
        const lane tangent_forward_28 = -2.0*along_115/(h_m_6*h_m_6*h_m_6);
        const lane tangent_forward_29 = -3.0*tangent_forward_4/(forward_4*forward_4*forward_4*forward_4);
        const lane tangent_forward_30 = -3.0*tangent_forward_5/(forward_5*forward_5*forward_5*forward_5);
        const lane tangent_forward_31 = -3.0*tangent_forward_6/(forward_6*forward_6*forward_6*forward_6);
        const lane tangent_forward_32 = -3.0*tangent_forward_7/(forward_7*forward_7*forward_7*forward_7);
        const lane tangent_forward_33 = -3.0*tangent_forward_8/(forward_8*forward_8*forward_8*forward_8);
        const lane tangent_forward_34 = -3.0*tangent_forward_9/(forward_9*forward_9*forward_9*forward_9);
        const lane t190 = 2.0*along_11;
        lanes_clear(mass_rate, 225);
        mass_rate[0] =
            LANES(D_p_rx_1*tangent_h_rx_l_1 + D_p_ry_1*tangent_h_ry_l_1 + D_p_rz_1*tangent_h_rz_l_1
            + D_p_x_1*tangent_h_x_l_1 + D_p_y_1*tangent_h_y_l_1 + D_p_z_1*tangent_h_z_l_1 + along_86
            + h_rx_l_1*tangent_D_p_rx_1 + h_ry_l_1*tangent_D_p_ry_1 + h_rz_l_1*tangent_D_p_rz_1
            + h_x_l_1*tangent_D_p_x_1 + h_y_l_1*tangent_D_p_y_1 + h_z_l_1*tangent_D_p_z_1 - tangent_m_perp_1);
        mass_rate[1] = mass_rate[15] =
            LANES(D_p_rx_1*tangent_h_rx_l_2 + D_p_ry_1*tangent_h_ry_l_2 + D_p_rz_1*tangent_h_rz_l_2
            + D_p_x_1*tangent_h_x_l_2 + D_p_y_1*tangent_h_y_l_2 + D_p_z_1*tangent_h_z_l_2
            + h_rx_l_2*tangent_D_p_rx_1 + h_ry_l_2*tangent_D_p_ry_1 + h_rz_l_2*tangent_D_p_rz_1
            + h_x_l_2*tangent_D_p_x_1 + h_y_l_2*tangent_D_p_y_1 + h_z_l_2*tangent_D_p_z_1);
        mass_rate[2] = mass_rate[30] =
            LANES(D_p_rx_1*tangent_h_rx_l_3 + D_p_ry_1*tangent_h_ry_l_3 + D_p_rz_1*tangent_h_rz_l_3
            + D_p_x_1*tangent_h_x_l_3 + D_p_y_1*tangent_h_y_l_3 + D_p_z_1*tangent_h_z_l_3
            + h_rx_l_3*tangent_D_p_rx_1 + h_ry_l_3*tangent_D_p_ry_1 + h_rz_l_3*tangent_D_p_rz_1
            + h_x_l_3*tangent_D_p_x_1 + h_y_l_3*tangent_D_p_y_1 + h_z_l_3*tangent_D_p_z_1);
        mass_rate[3] = mass_rate[45] =
            LANES(D_p_rx_1*tangent_h_rx_l_4 + D_p_ry_1*tangent_h_ry_l_4 + D_p_rz_1*tangent_h_rz_l_4
            + D_p_x_1*tangent_h_x_l_4 + D_p_y_1*tangent_h_y_l_4 + D_p_z_1*tangent_h_z_l_4
            + h_rx_l_4*tangent_D_p_rx_1 + h_ry_l_4*tangent_D_p_ry_1 + h_rz_l_4*tangent_D_p_rz_1
            + h_x_l_4*tangent_D_p_x_1 + h_y_l_4*tangent_D_p_y_1 + h_z_l_4*tangent_D_p_z_1);
        mass_rate[4] = mass_rate[60] =
            LANES(D_p_rx_1*tangent_h_rx_l_5 + D_p_ry_1*tangent_h_ry_l_5 + D_p_rz_1*tangent_h_rz_l_5
            + D_p_x_1*tangent_h_x_l_5 + D_p_y_1*tangent_h_y_l_5 + D_p_z_1*tangent_h_z_l_5
            + h_rx_l_5*tangent_D_p_rx_1 + h_ry_l_5*tangent_D_p_ry_1 + h_rz_l_5*tangent_D_p_rz_1
            + h_x_l_5*tangent_D_p_x_1 + h_y_l_5*tangent_D_p_y_1 + h_z_l_5*tangent_D_p_z_1);
        mass_rate[5] = mass_rate[75] =
            LANES(D_p_rx_1*tangent_h_rx_l_6 + D_p_ry_1*tangent_h_ry_l_6 + D_p_rz_1*tangent_h_rz_l_6
            + D_p_x_1*tangent_h_x_l_6 + D_p_y_1*tangent_h_y_l_6 + D_p_z_1*tangent_h_z_l_6
            + h_rx_l_6*tangent_D_p_rx_1 + h_ry_l_6*tangent_D_p_ry_1 + h_rz_l_6*tangent_D_p_rz_1
            + h_x_l_6*tangent_D_p_x_1 + h_y_l_6*tangent_D_p_y_1 + h_z_l_6*tangent_D_p_z_1);
        mass_rate[12] = mass_rate[180] =
            LANES(D_p_ry_1*tangent_h_ry_u_x + D_p_rz_1*tangent_h_rz_u_x + D_p_x_1*tangent_h_x_u_x
            - d_1_x*tangent_forward_t135 - forward_t135*tangent_d_1_x + h_ry_u_x*tangent_D_p_ry_1
            + h_rz_u_x*tangent_D_p_rz_1 + h_x_u_x*tangent_D_p_x_1);
        mass_rate[13] = mass_rate[195] =
            LANES(D_p_rx_1*tangent_h_rx_u_y + D_p_rz_1*tangent_h_rz_u_y + D_p_y_1*tangent_h_x_u_x
            - d_1_y*tangent_forward_t135 - forward_t135*tangent_d_1_y + h_rx_u_y*tangent_D_p_rx_1
            + h_rz_u_y*tangent_D_p_rz_1 + h_x_u_x*tangent_D_p_y_1);
        mass_rate[14] = mass_rate[210] =
            LANES(D_p_rx_1*tangent_h_rx_u_z + D_p_ry_1*tangent_h_ry_u_z + D_p_z_1*tangent_h_x_u_x
            - d_1_z*tangent_forward_t135 - forward_t135*tangent_d_1_z + h_rx_u_z*tangent_D_p_rx_1
            + h_ry_u_z*tangent_D_p_ry_1 + h_x_u_x*tangent_D_p_z_1);
        mass_rate[16] =
            LANES(D_p_rx_2*tangent_h_rx_l_2 + D_p_ry_2*tangent_h_ry_l_2 + D_p_rz_2*tangent_h_rz_l_2
            + D_p_x_2*tangent_h_x_l_2 + D_p_y_2*tangent_h_y_l_2 + D_p_z_2*tangent_h_z_l_2 + along_87
            + h_rx_l_2*tangent_D_p_rx_2 + h_ry_l_2*tangent_D_p_ry_2 + h_rz_l_2*tangent_D_p_rz_2
            + h_x_l_2*tangent_D_p_x_2 + h_y_l_2*tangent_D_p_y_2 + h_z_l_2*tangent_D_p_z_2 - tangent_m_perp_2);
        mass_rate[17] = mass_rate[31] =
            LANES(D_p_rx_2*tangent_h_rx_l_3 + D_p_ry_2*tangent_h_ry_l_3 + D_p_rz_2*tangent_h_rz_l_3
            + D_p_x_2*tangent_h_x_l_3 + D_p_y_2*tangent_h_y_l_3 + D_p_z_2*tangent_h_z_l_3
            + h_rx_l_3*tangent_D_p_rx_2 + h_ry_l_3*tangent_D_p_ry_2 + h_rz_l_3*tangent_D_p_rz_2
            + h_x_l_3*tangent_D_p_x_2 + h_y_l_3*tangent_D_p_y_2 + h_z_l_3*tangent_D_p_z_2);
        mass_rate[18] = mass_rate[46] =
            LANES(D_p_rx_2*tangent_h_rx_l_4 + D_p_ry_2*tangent_h_ry_l_4 + D_p_rz_2*tangent_h_rz_l_4
            + D_p_x_2*tangent_h_x_l_4 + D_p_y_2*tangent_h_y_l_4 + D_p_z_2*tangent_h_z_l_4
            + h_rx_l_4*tangent_D_p_rx_2 + h_ry_l_4*tangent_D_p_ry_2 + h_rz_l_4*tangent_D_p_rz_2
            + h_x_l_4*tangent_D_p_x_2 + h_y_l_4*tangent_D_p_y_2 + h_z_l_4*tangent_D_p_z_2);
        mass_rate[19] = mass_rate[61] =
            LANES(D_p_rx_2*tangent_h_rx_l_5 + D_p_ry_2*tangent_h_ry_l_5 + D_p_rz_2*tangent_h_rz_l_5
            + D_p_x_2*tangent_h_x_l_5 + D_p_y_2*tangent_h_y_l_5 + D_p_z_2*tangent_h_z_l_5
            + h_rx_l_5*tangent_D_p_rx_2 + h_ry_l_5*tangent_D_p_ry_2 + h_rz_l_5*tangent_D_p_rz_2
            + h_x_l_5*tangent_D_p_x_2 + h_y_l_5*tangent_D_p_y_2 + h_z_l_5*tangent_D_p_z_2);
        mass_rate[20] = mass_rate[76] =
            LANES(D_p_rx_2*tangent_h_rx_l_6 + D_p_ry_2*tangent_h_ry_l_6 + D_p_rz_2*tangent_h_rz_l_6
            + D_p_x_2*tangent_h_x_l_6 + D_p_y_2*tangent_h_y_l_6 + D_p_z_2*tangent_h_z_l_6
            + h_rx_l_6*tangent_D_p_rx_2 + h_ry_l_6*tangent_D_p_ry_2 + h_rz_l_6*tangent_D_p_rz_2
            + h_x_l_6*tangent_D_p_x_2 + h_y_l_6*tangent_D_p_y_2 + h_z_l_6*tangent_D_p_z_2);
        mass_rate[27] = mass_rate[181] =
            LANES(D_p_ry_2*tangent_h_ry_u_x + D_p_rz_2*tangent_h_rz_u_x + D_p_x_2*tangent_h_x_u_x
            - d_2_x*tangent_forward_t137 - forward_t137*tangent_d_2_x + h_ry_u_x*tangent_D_p_ry_2
            + h_rz_u_x*tangent_D_p_rz_2 + h_x_u_x*tangent_D_p_x_2);
        mass_rate[28] = mass_rate[196] =
            LANES(D_p_rx_2*tangent_h_rx_u_y + D_p_rz_2*tangent_h_rz_u_y + D_p_y_2*tangent_h_x_u_x
            - d_2_y*tangent_forward_t137 - forward_t137*tangent_d_2_y + h_rx_u_y*tangent_D_p_rx_2
            + h_rz_u_y*tangent_D_p_rz_2 + h_x_u_x*tangent_D_p_y_2);
        mass_rate[29] = mass_rate[211] =
            LANES(D_p_rx_2*tangent_h_rx_u_z + D_p_ry_2*tangent_h_ry_u_z + D_p_z_2*tangent_h_x_u_x
            - d_2_z*tangent_forward_t137 - forward_t137*tangent_d_2_z + h_rx_u_z*tangent_D_p_rx_2
            + h_ry_u_z*tangent_D_p_ry_2 + h_x_u_x*tangent_D_p_z_2);
        mass_rate[32] =
            LANES(D_p_rx_3*tangent_h_rx_l_3 + D_p_ry_3*tangent_h_ry_l_3 + D_p_rz_3*tangent_h_rz_l_3
            + D_p_x_3*tangent_h_x_l_3 + D_p_y_3*tangent_h_y_l_3 + D_p_z_3*tangent_h_z_l_3 + along_88
            + h_rx_l_3*tangent_D_p_rx_3 + h_ry_l_3*tangent_D_p_ry_3 + h_rz_l_3*tangent_D_p_rz_3
            + h_x_l_3*tangent_D_p_x_3 + h_y_l_3*tangent_D_p_y_3 + h_z_l_3*tangent_D_p_z_3 - tangent_m_perp_3);
        mass_rate[33] = mass_rate[47] =
            LANES(D_p_rx_3*tangent_h_rx_l_4 + D_p_ry_3*tangent_h_ry_l_4 + D_p_rz_3*tangent_h_rz_l_4
            + D_p_x_3*tangent_h_x_l_4 + D_p_y_3*tangent_h_y_l_4 + D_p_z_3*tangent_h_z_l_4
            + h_rx_l_4*tangent_D_p_rx_3 + h_ry_l_4*tangent_D_p_ry_3 + h_rz_l_4*tangent_D_p_rz_3
            + h_x_l_4*tangent_D_p_x_3 + h_y_l_4*tangent_D_p_y_3 + h_z_l_4*tangent_D_p_z_3);
        mass_rate[34] = mass_rate[62] =
            LANES(D_p_rx_3*tangent_h_rx_l_5 + D_p_ry_3*tangent_h_ry_l_5 + D_p_rz_3*tangent_h_rz_l_5
            + D_p_x_3*tangent_h_x_l_5 + D_p_y_3*tangent_h_y_l_5 + D_p_z_3*tangent_h_z_l_5
            + h_rx_l_5*tangent_D_p_rx_3 + h_ry_l_5*tangent_D_p_ry_3 + h_rz_l_5*tangent_D_p_rz_3
            + h_x_l_5*tangent_D_p_x_3 + h_y_l_5*tangent_D_p_y_3 + h_z_l_5*tangent_D_p_z_3);
        mass_rate[35] = mass_rate[77] =
            LANES(D_p_rx_3*tangent_h_rx_l_6 + D_p_ry_3*tangent_h_ry_l_6 + D_p_rz_3*tangent_h_rz_l_6
            + D_p_x_3*tangent_h_x_l_6 + D_p_y_3*tangent_h_y_l_6 + D_p_z_3*tangent_h_z_l_6
            + h_rx_l_6*tangent_D_p_rx_3 + h_ry_l_6*tangent_D_p_ry_3 + h_rz_l_6*tangent_D_p_rz_3
            + h_x_l_6*tangent_D_p_x_3 + h_y_l_6*tangent_D_p_y_3 + h_z_l_6*tangent_D_p_z_3);
        mass_rate[42] = mass_rate[182] =
            LANES(D_p_ry_3*tangent_h_ry_u_x + D_p_rz_3*tangent_h_rz_u_x + D_p_x_3*tangent_h_x_u_x
            - d_3_x*tangent_forward_t139 - forward_t139*tangent_d_3_x + h_ry_u_x*tangent_D_p_ry_3
            + h_rz_u_x*tangent_D_p_rz_3 + h_x_u_x*tangent_D_p_x_3);
        mass_rate[43] = mass_rate[197] =
            LANES(D_p_rx_3*tangent_h_rx_u_y + D_p_rz_3*tangent_h_rz_u_y + D_p_y_3*tangent_h_x_u_x
            - d_3_y*tangent_forward_t139 - forward_t139*tangent_d_3_y + h_rx_u_y*tangent_D_p_rx_3
            + h_rz_u_y*tangent_D_p_rz_3 + h_x_u_x*tangent_D_p_y_3);
        mass_rate[44] = mass_rate[212] =
            LANES(D_p_rx_3*tangent_h_rx_u_z + D_p_ry_3*tangent_h_ry_u_z + D_p_z_3*tangent_h_x_u_x
            - d_3_z*tangent_forward_t139 - forward_t139*tangent_d_3_z + h_rx_u_z*tangent_D_p_rx_3
            + h_ry_u_z*tangent_D_p_ry_3 + h_x_u_x*tangent_D_p_z_3);
        mass_rate[48] =
            LANES(D_p_rx_4*tangent_h_rx_l_4 + D_p_ry_4*tangent_h_ry_l_4 + D_p_rz_4*tangent_h_rz_l_4
            + D_p_x_4*tangent_h_x_l_4 + D_p_y_4*tangent_h_y_l_4 + D_p_z_4*tangent_h_z_l_4 + along_89
            + h_rx_l_4*tangent_D_p_rx_4 + h_ry_l_4*tangent_D_p_ry_4 + h_rz_l_4*tangent_D_p_rz_4
            + h_x_l_4*tangent_D_p_x_4 + h_y_l_4*tangent_D_p_y_4 + h_z_l_4*tangent_D_p_z_4 - tangent_m_perp_4);
        mass_rate[49] = mass_rate[63] =
            LANES(D_p_rx_4*tangent_h_rx_l_5 + D_p_ry_4*tangent_h_ry_l_5 + D_p_rz_4*tangent_h_rz_l_5
            + D_p_x_4*tangent_h_x_l_5 + D_p_y_4*tangent_h_y_l_5 + D_p_z_4*tangent_h_z_l_5
            + h_rx_l_5*tangent_D_p_rx_4 + h_ry_l_5*tangent_D_p_ry_4 + h_rz_l_5*tangent_D_p_rz_4
            + h_x_l_5*tangent_D_p_x_4 + h_y_l_5*tangent_D_p_y_4 + h_z_l_5*tangent_D_p_z_4);
        mass_rate[50] = mass_rate[78] =
            LANES(D_p_rx_4*tangent_h_rx_l_6 + D_p_ry_4*tangent_h_ry_l_6 + D_p_rz_4*tangent_h_rz_l_6
            + D_p_x_4*tangent_h_x_l_6 + D_p_y_4*tangent_h_y_l_6 + D_p_z_4*tangent_h_z_l_6
            + h_rx_l_6*tangent_D_p_rx_4 + h_ry_l_6*tangent_D_p_ry_4 + h_rz_l_6*tangent_D_p_rz_4
            + h_x_l_6*tangent_D_p_x_4 + h_y_l_6*tangent_D_p_y_4 + h_z_l_6*tangent_D_p_z_4);
        mass_rate[57] = mass_rate[183] =
            LANES(D_p_ry_4*tangent_h_ry_u_x + D_p_rz_4*tangent_h_rz_u_x + D_p_x_4*tangent_h_x_u_x
            - d_4_x*tangent_forward_t141 - forward_t141*tangent_d_4_x + h_ry_u_x*tangent_D_p_ry_4
            + h_rz_u_x*tangent_D_p_rz_4 + h_x_u_x*tangent_D_p_x_4);
        mass_rate[58] = mass_rate[198] =
            LANES(D_p_rx_4*tangent_h_rx_u_y + D_p_rz_4*tangent_h_rz_u_y + D_p_y_4*tangent_h_x_u_x
            - d_4_y*tangent_forward_t141 - forward_t141*tangent_d_4_y + h_rx_u_y*tangent_D_p_rx_4
            + h_rz_u_y*tangent_D_p_rz_4 + h_x_u_x*tangent_D_p_y_4);
        mass_rate[59] = mass_rate[213] =
            LANES(D_p_rx_4*tangent_h_rx_u_z + D_p_ry_4*tangent_h_ry_u_z + D_p_z_4*tangent_h_x_u_x
            - d_4_z*tangent_forward_t141 - forward_t141*tangent_d_4_z + h_rx_u_z*tangent_D_p_rx_4
            + h_ry_u_z*tangent_D_p_ry_4 + h_x_u_x*tangent_D_p_z_4);
        mass_rate[64] =
            LANES(D_p_rx_5*tangent_h_rx_l_5 + D_p_ry_5*tangent_h_ry_l_5 + D_p_rz_5*tangent_h_rz_l_5
            + D_p_x_5*tangent_h_x_l_5 + D_p_y_5*tangent_h_y_l_5 + D_p_z_5*tangent_h_z_l_5 + along_90
            + h_rx_l_5*tangent_D_p_rx_5 + h_ry_l_5*tangent_D_p_ry_5 + h_rz_l_5*tangent_D_p_rz_5
            + h_x_l_5*tangent_D_p_x_5 + h_y_l_5*tangent_D_p_y_5 + h_z_l_5*tangent_D_p_z_5 - tangent_m_perp_5);
        mass_rate[65] = mass_rate[79] =
            LANES(D_p_rx_5*tangent_h_rx_l_6 + D_p_ry_5*tangent_h_ry_l_6 + D_p_rz_5*tangent_h_rz_l_6
            + D_p_x_5*tangent_h_x_l_6 + D_p_y_5*tangent_h_y_l_6 + D_p_z_5*tangent_h_z_l_6
            + h_rx_l_6*tangent_D_p_rx_5 + h_ry_l_6*tangent_D_p_ry_5 + h_rz_l_6*tangent_D_p_rz_5
            + h_x_l_6*tangent_D_p_x_5 + h_y_l_6*tangent_D_p_y_5 + h_z_l_6*tangent_D_p_z_5);
        mass_rate[72] = mass_rate[184] =
            LANES(D_p_ry_5*tangent_h_ry_u_x + D_p_rz_5*tangent_h_rz_u_x + D_p_x_5*tangent_h_x_u_x
            - d_5_x*tangent_forward_t143 - forward_t143*tangent_d_5_x + h_ry_u_x*tangent_D_p_ry_5
            + h_rz_u_x*tangent_D_p_rz_5 + h_x_u_x*tangent_D_p_x_5);
        mass_rate[73] = mass_rate[199] =
            LANES(D_p_rx_5*tangent_h_rx_u_y + D_p_rz_5*tangent_h_rz_u_y + D_p_y_5*tangent_h_x_u_x
            - d_5_y*tangent_forward_t143 - forward_t143*tangent_d_5_y + h_rx_u_y*tangent_D_p_rx_5
            + h_rz_u_y*tangent_D_p_rz_5 + h_x_u_x*tangent_D_p_y_5);
        mass_rate[74] = mass_rate[214] =
            LANES(D_p_rx_5*tangent_h_rx_u_z + D_p_ry_5*tangent_h_ry_u_z + D_p_z_5*tangent_h_x_u_x
            - d_5_z*tangent_forward_t143 - forward_t143*tangent_d_5_z + h_rx_u_z*tangent_D_p_rx_5
            + h_ry_u_z*tangent_D_p_ry_5 + h_x_u_x*tangent_D_p_z_5);
        mass_rate[80] =
            LANES(D_p_rx_6*tangent_h_rx_l_6 + D_p_ry_6*tangent_h_ry_l_6 + D_p_rz_6*tangent_h_rz_l_6
            + D_p_x_6*tangent_h_x_l_6 + D_p_y_6*tangent_h_y_l_6 + D_p_z_6*tangent_h_z_l_6 + along_91
            + h_rx_l_6*tangent_D_p_rx_6 + h_ry_l_6*tangent_D_p_ry_6 + h_rz_l_6*tangent_D_p_rz_6
            + h_x_l_6*tangent_D_p_x_6 + h_y_l_6*tangent_D_p_y_6 + h_z_l_6*tangent_D_p_z_6 - tangent_m_perp_6);
        mass_rate[87] = mass_rate[185] =
            LANES(D_p_ry_6*tangent_h_ry_u_x + D_p_rz_6*tangent_h_rz_u_x + D_p_x_6*tangent_h_x_u_x
            - d_6_x*tangent_forward_t145 - forward_t145*tangent_d_6_x + h_ry_u_x*tangent_D_p_ry_6
            + h_rz_u_x*tangent_D_p_rz_6 + h_x_u_x*tangent_D_p_x_6);
        mass_rate[88] = mass_rate[200] =
            LANES(D_p_rx_6*tangent_h_rx_u_y + D_p_rz_6*tangent_h_rz_u_y + D_p_y_6*tangent_h_x_u_x
            - d_6_y*tangent_forward_t145 - forward_t145*tangent_d_6_y + h_rx_u_y*tangent_D_p_rx_6
            + h_rz_u_y*tangent_D_p_rz_6 + h_x_u_x*tangent_D_p_y_6);
        mass_rate[89] = mass_rate[215] =
            LANES(D_p_rx_6*tangent_h_rx_u_z + D_p_ry_6*tangent_h_ry_u_z + D_p_z_6*tangent_h_x_u_x
            - d_6_z*tangent_forward_t145 - forward_t145*tangent_d_6_z + h_rx_u_z*tangent_D_p_rx_6
            + h_ry_u_z*tangent_D_p_ry_6 + h_x_u_x*tangent_D_p_z_6);
        mass_rate[96] = LANES(I_m_1*tangent_forward_23 + along_104*forward_23 + along_124);
        mass_rate[112] = LANES(I_m_2*tangent_forward_24 + along_105*forward_24 + along_124);
        mass_rate[128] = LANES(I_m_3*tangent_forward_25 + along_106*forward_25 + along_124);
        mass_rate[144] = LANES(I_m_4*tangent_forward_26 + along_107*forward_26 + along_124);
        mass_rate[160] = LANES(I_m_5*tangent_forward_27 + along_108*forward_27 + along_124);
        mass_rate[176] = LANES(I_m_6*tangent_forward_28 + along_109*forward_28 + along_124);
        mass_rate[192] = LANES(tangent_forward_t235 + tangent_h_x_u_x);
        mass_rate[208] = LANES(tangent_forward_t235 + tangent_h_x_u_x);
        mass_rate[224] = LANES(tangent_forward_t235 + tangent_h_x_u_x);
        lanes_clear(stiffness_rate, 225);
        stiffness_rate[0] =
            LANES(D_p_rx_1*tangent_f_rx_l_1 - D_p_rx_1*tangent_forward_t159 + D_p_ry_1*tangent_f_ry_l_1
            - D_p_ry_1*tangent_forward_t165 + D_p_rz_1*tangent_f_rz_l_1 - D_p_rz_1*tangent_forward_t171
            + D_p_x_1*tangent_f_x_l_1 + D_p_x_1*tangent_forward_t136 + D_p_y_1*tangent_f_y_l_1
            + D_p_y_1*tangent_forward_t147 + D_p_z_1*tangent_f_z_l_1 + D_p_z_1*tangent_forward_t153
            - along_12*d_1_y*t192 + along_122*((D_p_x_1*D_p_x_1) + (D_p_y_1*D_p_y_1) + (D_p_z_1*D_p_z_1))
            - along_13*d_1_z*t192 - d_1_x*t190*t191 + forward_29*t193*tangent_forward_t32
            + forward_t32*t193*tangent_forward_29 - g_x*t192*tangent_d_1_x - g_y*t192*tangent_d_1_y
            - g_z*t192*tangent_d_1_z + tangent_D_p_rx_1*(f_rx_l_1 - forward_t159)
            + tangent_D_p_ry_1*(f_ry_l_1 - forward_t165) + tangent_D_p_rz_1*(f_rz_l_1 - forward_t171)
            + tangent_D_p_x_1*(f_x_l_1 + forward_t136 + 2.0*forward_t236) + tangent_D_p_y_1*(f_y_l_1
            + forward_t147 + 2.0*forward_t237) + tangent_D_p_z_1*(f_z_l_1 + forward_t153 + 2.0*forward_t238)
            + tangent_k_1 + tangent_mu_1);
        stiffness_rate[1] = stiffness_rate[15] =
            LANES(D_p_rx_1*tangent_f_rx_l_2 - D_p_rx_2*tangent_forward_t159 + D_p_ry_1*tangent_f_ry_l_2
            - D_p_ry_2*tangent_forward_t165 + D_p_rz_1*tangent_f_rz_l_2 - D_p_rz_2*tangent_forward_t171
            + D_p_x_1*tangent_f_x_l_2 + D_p_x_2*tangent_forward_t136 + D_p_x_2*tangent_forward_t236
            + D_p_y_1*tangent_f_y_l_2 + D_p_y_2*tangent_forward_t147 + D_p_y_2*tangent_forward_t237
            + D_p_z_1*tangent_f_z_l_2 + D_p_z_2*tangent_forward_t153 + D_p_z_2*tangent_forward_t238
            + f_rx_l_2*tangent_D_p_rx_1 + f_ry_l_2*tangent_D_p_ry_1 + f_rz_l_2*tangent_D_p_rz_1
            + f_x_l_2*tangent_D_p_x_1 + f_y_l_2*tangent_D_p_y_1 + f_z_l_2*tangent_D_p_z_1
            - forward_t159*tangent_D_p_rx_2 - forward_t165*tangent_D_p_ry_2 - forward_t171*tangent_D_p_rz_2
            + t194*tangent_D_p_x_2 + t195*tangent_D_p_y_2 + t196*tangent_D_p_z_2);
        stiffness_rate[2] = stiffness_rate[30] =
            LANES(D_p_rx_1*tangent_f_rx_l_3 - D_p_rx_3*tangent_forward_t159 + D_p_ry_1*tangent_f_ry_l_3
            - D_p_ry_3*tangent_forward_t165 + D_p_rz_1*tangent_f_rz_l_3 - D_p_rz_3*tangent_forward_t171
            + D_p_x_1*tangent_f_x_l_3 + D_p_x_3*tangent_forward_t136 + D_p_x_3*tangent_forward_t236
            + D_p_y_1*tangent_f_y_l_3 + D_p_y_3*tangent_forward_t147 + D_p_y_3*tangent_forward_t237
            + D_p_z_1*tangent_f_z_l_3 + D_p_z_3*tangent_forward_t153 + D_p_z_3*tangent_forward_t238
            + f_rx_l_3*tangent_D_p_rx_1 + f_ry_l_3*tangent_D_p_ry_1 + f_rz_l_3*tangent_D_p_rz_1
            + f_x_l_3*tangent_D_p_x_1 + f_y_l_3*tangent_D_p_y_1 + f_z_l_3*tangent_D_p_z_1
            - forward_t159*tangent_D_p_rx_3 - forward_t165*tangent_D_p_ry_3 - forward_t171*tangent_D_p_rz_3
            + t194*tangent_D_p_x_3 + t195*tangent_D_p_y_3 + t196*tangent_D_p_z_3);
        stiffness_rate[3] = stiffness_rate[45] =
            LANES(D_p_rx_1*tangent_f_rx_l_4 - D_p_rx_4*tangent_forward_t159 + D_p_ry_1*tangent_f_ry_l_4
            - D_p_ry_4*tangent_forward_t165 + D_p_rz_1*tangent_f_rz_l_4 - D_p_rz_4*tangent_forward_t171
            + D_p_x_1*tangent_f_x_l_4 + D_p_x_4*tangent_forward_t136 + D_p_x_4*tangent_forward_t236
            + D_p_y_1*tangent_f_y_l_4 + D_p_y_4*tangent_forward_t147 + D_p_y_4*tangent_forward_t237
            + D_p_z_1*tangent_f_z_l_4 + D_p_z_4*tangent_forward_t153 + D_p_z_4*tangent_forward_t238
            + f_rx_l_4*tangent_D_p_rx_1 + f_ry_l_4*tangent_D_p_ry_1 + f_rz_l_4*tangent_D_p_rz_1
            + f_x_l_4*tangent_D_p_x_1 + f_y_l_4*tangent_D_p_y_1 + f_z_l_4*tangent_D_p_z_1
            - forward_t159*tangent_D_p_rx_4 - forward_t165*tangent_D_p_ry_4 - forward_t171*tangent_D_p_rz_4
            + t194*tangent_D_p_x_4 + t195*tangent_D_p_y_4 + t196*tangent_D_p_z_4);
        stiffness_rate[4] = stiffness_rate[60] =
            LANES(D_p_rx_1*tangent_f_rx_l_5 - D_p_rx_5*tangent_forward_t159 + D_p_ry_1*tangent_f_ry_l_5
            - D_p_ry_5*tangent_forward_t165 + D_p_rz_1*tangent_f_rz_l_5 - D_p_rz_5*tangent_forward_t171
            + D_p_x_1*tangent_f_x_l_5 + D_p_x_5*tangent_forward_t136 + D_p_x_5*tangent_forward_t236
            + D_p_y_1*tangent_f_y_l_5 + D_p_y_5*tangent_forward_t147 + D_p_y_5*tangent_forward_t237
            + D_p_z_1*tangent_f_z_l_5 + D_p_z_5*tangent_forward_t153 + D_p_z_5*tangent_forward_t238
            + f_rx_l_5*tangent_D_p_rx_1 + f_ry_l_5*tangent_D_p_ry_1 + f_rz_l_5*tangent_D_p_rz_1
            + f_x_l_5*tangent_D_p_x_1 + f_y_l_5*tangent_D_p_y_1 + f_z_l_5*tangent_D_p_z_1
            - forward_t159*tangent_D_p_rx_5 - forward_t165*tangent_D_p_ry_5 - forward_t171*tangent_D_p_rz_5
            + t194*tangent_D_p_x_5 + t195*tangent_D_p_y_5 + t196*tangent_D_p_z_5);
        stiffness_rate[5] = stiffness_rate[75] =
            LANES(D_p_rx_1*tangent_f_rx_l_6 - D_p_rx_6*tangent_forward_t159 + D_p_ry_1*tangent_f_ry_l_6
            - D_p_ry_6*tangent_forward_t165 + D_p_rz_1*tangent_f_rz_l_6 - D_p_rz_6*tangent_forward_t171
            + D_p_x_1*tangent_f_x_l_6 + D_p_x_6*tangent_forward_t136 + D_p_x_6*tangent_forward_t236
            + D_p_y_1*tangent_f_y_l_6 + D_p_y_6*tangent_forward_t147 + D_p_y_6*tangent_forward_t237
            + D_p_z_1*tangent_f_z_l_6 + D_p_z_6*tangent_forward_t153 + D_p_z_6*tangent_forward_t238
            + f_rx_l_6*tangent_D_p_rx_1 + f_ry_l_6*tangent_D_p_ry_1 + f_rz_l_6*tangent_D_p_rz_1
            + f_x_l_6*tangent_D_p_x_1 + f_y_l_6*tangent_D_p_y_1 + f_z_l_6*tangent_D_p_z_1
            - forward_t159*tangent_D_p_rx_6 - forward_t165*tangent_D_p_ry_6 - forward_t171*tangent_D_p_rz_6
            + t194*tangent_D_p_x_6 + t195*tangent_D_p_y_6 + t196*tangent_D_p_z_6);
        stiffness_rate[6] = stiffness_rate[90] = LANES(-tangent_k_1);
        stiffness_rate[12] = stiffness_rate[180] = LANES(tangent_forward_t236);
        stiffness_rate[13] = stiffness_rate[195] = LANES(tangent_forward_t237);
        stiffness_rate[14] = stiffness_rate[210] = LANES(tangent_forward_t238);
        stiffness_rate[16] =
            LANES(D_p_rx_2*tangent_f_rx_l_2 - D_p_rx_2*tangent_forward_t160 + D_p_ry_2*tangent_f_ry_l_2
            - D_p_ry_2*tangent_forward_t166 + D_p_rz_2*tangent_f_rz_l_2 - D_p_rz_2*tangent_forward_t172
            + D_p_x_2*tangent_f_x_l_2 + D_p_x_2*tangent_forward_t138 + D_p_y_2*tangent_f_y_l_2
            + D_p_y_2*tangent_forward_t148 + D_p_z_2*tangent_f_z_l_2 + D_p_z_2*tangent_forward_t154
            - along_12*d_2_y*t198 + along_122*((D_p_x_2*D_p_x_2) + (D_p_y_2*D_p_y_2) + (D_p_z_2*D_p_z_2))
            - along_13*d_2_z*t198 - d_2_x*t190*t197 + forward_30*t199*tangent_forward_t36
            + forward_t36*t199*tangent_forward_30 - g_x*t198*tangent_d_2_x - g_y*t198*tangent_d_2_y
            - g_z*t198*tangent_d_2_z + tangent_D_p_rx_2*(f_rx_l_2 - forward_t160)
            + tangent_D_p_ry_2*(f_ry_l_2 - forward_t166) + tangent_D_p_rz_2*(f_rz_l_2 - forward_t172)
            + tangent_D_p_x_2*(f_x_l_2 + forward_t138 + 2.0*forward_t239) + tangent_D_p_y_2*(f_y_l_2
            + forward_t148 + 2.0*forward_t240) + tangent_D_p_z_2*(f_z_l_2 + forward_t154 + 2.0*forward_t241)
            + tangent_k_2 + tangent_mu_2);
        stiffness_rate[17] = stiffness_rate[31] =
            LANES(D_p_rx_2*tangent_f_rx_l_3 - D_p_rx_3*tangent_forward_t160 + D_p_ry_2*tangent_f_ry_l_3
            - D_p_ry_3*tangent_forward_t166 + D_p_rz_2*tangent_f_rz_l_3 - D_p_rz_3*tangent_forward_t172
            + D_p_x_2*tangent_f_x_l_3 + D_p_x_3*tangent_forward_t138 + D_p_x_3*tangent_forward_t239
            + D_p_y_2*tangent_f_y_l_3 + D_p_y_3*tangent_forward_t148 + D_p_y_3*tangent_forward_t240
            + D_p_z_2*tangent_f_z_l_3 + D_p_z_3*tangent_forward_t154 + D_p_z_3*tangent_forward_t241
            + f_rx_l_3*tangent_D_p_rx_2 + f_ry_l_3*tangent_D_p_ry_2 + f_rz_l_3*tangent_D_p_rz_2
            + f_x_l_3*tangent_D_p_x_2 + f_y_l_3*tangent_D_p_y_2 + f_z_l_3*tangent_D_p_z_2
            - forward_t160*tangent_D_p_rx_3 - forward_t166*tangent_D_p_ry_3 - forward_t172*tangent_D_p_rz_3
            + t200*tangent_D_p_x_3 + t201*tangent_D_p_y_3 + t202*tangent_D_p_z_3);
        stiffness_rate[18] = stiffness_rate[46] =
            LANES(D_p_rx_2*tangent_f_rx_l_4 - D_p_rx_4*tangent_forward_t160 + D_p_ry_2*tangent_f_ry_l_4
            - D_p_ry_4*tangent_forward_t166 + D_p_rz_2*tangent_f_rz_l_4 - D_p_rz_4*tangent_forward_t172
            + D_p_x_2*tangent_f_x_l_4 + D_p_x_4*tangent_forward_t138 + D_p_x_4*tangent_forward_t239
            + D_p_y_2*tangent_f_y_l_4 + D_p_y_4*tangent_forward_t148 + D_p_y_4*tangent_forward_t240
            + D_p_z_2*tangent_f_z_l_4 + D_p_z_4*tangent_forward_t154 + D_p_z_4*tangent_forward_t241
            + f_rx_l_4*tangent_D_p_rx_2 + f_ry_l_4*tangent_D_p_ry_2 + f_rz_l_4*tangent_D_p_rz_2
            + f_x_l_4*tangent_D_p_x_2 + f_y_l_4*tangent_D_p_y_2 + f_z_l_4*tangent_D_p_z_2
            - forward_t160*tangent_D_p_rx_4 - forward_t166*tangent_D_p_ry_4 - forward_t172*tangent_D_p_rz_4
            + t200*tangent_D_p_x_4 + t201*tangent_D_p_y_4 + t202*tangent_D_p_z_4);
        stiffness_rate[19] = stiffness_rate[61] =
            LANES(D_p_rx_2*tangent_f_rx_l_5 - D_p_rx_5*tangent_forward_t160 + D_p_ry_2*tangent_f_ry_l_5
            - D_p_ry_5*tangent_forward_t166 + D_p_rz_2*tangent_f_rz_l_5 - D_p_rz_5*tangent_forward_t172
            + D_p_x_2*tangent_f_x_l_5 + D_p_x_5*tangent_forward_t138 + D_p_x_5*tangent_forward_t239
            + D_p_y_2*tangent_f_y_l_5 + D_p_y_5*tangent_forward_t148 + D_p_y_5*tangent_forward_t240
            + D_p_z_2*tangent_f_z_l_5 + D_p_z_5*tangent_forward_t154 + D_p_z_5*tangent_forward_t241
            + f_rx_l_5*tangent_D_p_rx_2 + f_ry_l_5*tangent_D_p_ry_2 + f_rz_l_5*tangent_D_p_rz_2
            + f_x_l_5*tangent_D_p_x_2 + f_y_l_5*tangent_D_p_y_2 + f_z_l_5*tangent_D_p_z_2
            - forward_t160*tangent_D_p_rx_5 - forward_t166*tangent_D_p_ry_5 - forward_t172*tangent_D_p_rz_5
            + t200*tangent_D_p_x_5 + t201*tangent_D_p_y_5 + t202*tangent_D_p_z_5);
        stiffness_rate[20] = stiffness_rate[76] =
            LANES(D_p_rx_2*tangent_f_rx_l_6 - D_p_rx_6*tangent_forward_t160 + D_p_ry_2*tangent_f_ry_l_6
            - D_p_ry_6*tangent_forward_t166 + D_p_rz_2*tangent_f_rz_l_6 - D_p_rz_6*tangent_forward_t172
            + D_p_x_2*tangent_f_x_l_6 + D_p_x_6*tangent_forward_t138 + D_p_x_6*tangent_forward_t239
            + D_p_y_2*tangent_f_y_l_6 + D_p_y_6*tangent_forward_t148 + D_p_y_6*tangent_forward_t240
            + D_p_z_2*tangent_f_z_l_6 + D_p_z_6*tangent_forward_t154 + D_p_z_6*tangent_forward_t241
            + f_rx_l_6*tangent_D_p_rx_2 + f_ry_l_6*tangent_D_p_ry_2 + f_rz_l_6*tangent_D_p_rz_2
            + f_x_l_6*tangent_D_p_x_2 + f_y_l_6*tangent_D_p_y_2 + f_z_l_6*tangent_D_p_z_2
            - forward_t160*tangent_D_p_rx_6 - forward_t166*tangent_D_p_ry_6 - forward_t172*tangent_D_p_rz_6
            + t200*tangent_D_p_x_6 + t201*tangent_D_p_y_6 + t202*tangent_D_p_z_6);
        stiffness_rate[22] = stiffness_rate[106] = LANES(-tangent_k_2);
        stiffness_rate[27] = stiffness_rate[181] = LANES(tangent_forward_t239);
        stiffness_rate[28] = stiffness_rate[196] = LANES(tangent_forward_t240);
        stiffness_rate[29] = stiffness_rate[211] = LANES(tangent_forward_t241);
        stiffness_rate[32] =
            LANES(D_p_rx_3*tangent_f_rx_l_3 - D_p_rx_3*tangent_forward_t161 + D_p_ry_3*tangent_f_ry_l_3
            - D_p_ry_3*tangent_forward_t167 + D_p_rz_3*tangent_f_rz_l_3 - D_p_rz_3*tangent_forward_t173
            + D_p_x_3*tangent_f_x_l_3 + D_p_x_3*tangent_forward_t140 + D_p_y_3*tangent_f_y_l_3
            + D_p_y_3*tangent_forward_t149 + D_p_z_3*tangent_f_z_l_3 + D_p_z_3*tangent_forward_t155
            - along_12*d_3_y*t204 + along_122*((D_p_x_3*D_p_x_3) + (D_p_y_3*D_p_y_3) + (D_p_z_3*D_p_z_3))
            - along_13*d_3_z*t204 - d_3_x*t190*t203 + forward_31*t205*tangent_forward_t40
            + forward_t40*t205*tangent_forward_31 - g_x*t204*tangent_d_3_x - g_y*t204*tangent_d_3_y
            - g_z*t204*tangent_d_3_z + tangent_D_p_rx_3*(f_rx_l_3 - forward_t161)
            + tangent_D_p_ry_3*(f_ry_l_3 - forward_t167) + tangent_D_p_rz_3*(f_rz_l_3 - forward_t173)
            + tangent_D_p_x_3*(f_x_l_3 + forward_t140 + 2.0*forward_t242) + tangent_D_p_y_3*(f_y_l_3
            + forward_t149 + 2.0*forward_t243) + tangent_D_p_z_3*(f_z_l_3 + forward_t155 + 2.0*forward_t244)
            + tangent_k_3 + tangent_mu_3);
        stiffness_rate[33] = stiffness_rate[47] =
            LANES(D_p_rx_3*tangent_f_rx_l_4 - D_p_rx_4*tangent_forward_t161 + D_p_ry_3*tangent_f_ry_l_4
            - D_p_ry_4*tangent_forward_t167 + D_p_rz_3*tangent_f_rz_l_4 - D_p_rz_4*tangent_forward_t173
            + D_p_x_3*tangent_f_x_l_4 + D_p_x_4*tangent_forward_t140 + D_p_x_4*tangent_forward_t242
            + D_p_y_3*tangent_f_y_l_4 + D_p_y_4*tangent_forward_t149 + D_p_y_4*tangent_forward_t243
            + D_p_z_3*tangent_f_z_l_4 + D_p_z_4*tangent_forward_t155 + D_p_z_4*tangent_forward_t244
            + f_rx_l_4*tangent_D_p_rx_3 + f_ry_l_4*tangent_D_p_ry_3 + f_rz_l_4*tangent_D_p_rz_3
            + f_x_l_4*tangent_D_p_x_3 + f_y_l_4*tangent_D_p_y_3 + f_z_l_4*tangent_D_p_z_3
            - forward_t161*tangent_D_p_rx_4 - forward_t167*tangent_D_p_ry_4 - forward_t173*tangent_D_p_rz_4
            + t206*tangent_D_p_x_4 + t207*tangent_D_p_y_4 + t208*tangent_D_p_z_4);
        stiffness_rate[34] = stiffness_rate[62] =
            LANES(D_p_rx_3*tangent_f_rx_l_5 - D_p_rx_5*tangent_forward_t161 + D_p_ry_3*tangent_f_ry_l_5
            - D_p_ry_5*tangent_forward_t167 + D_p_rz_3*tangent_f_rz_l_5 - D_p_rz_5*tangent_forward_t173
            + D_p_x_3*tangent_f_x_l_5 + D_p_x_5*tangent_forward_t140 + D_p_x_5*tangent_forward_t242
            + D_p_y_3*tangent_f_y_l_5 + D_p_y_5*tangent_forward_t149 + D_p_y_5*tangent_forward_t243
            + D_p_z_3*tangent_f_z_l_5 + D_p_z_5*tangent_forward_t155 + D_p_z_5*tangent_forward_t244
            + f_rx_l_5*tangent_D_p_rx_3 + f_ry_l_5*tangent_D_p_ry_3 + f_rz_l_5*tangent_D_p_rz_3
            + f_x_l_5*tangent_D_p_x_3 + f_y_l_5*tangent_D_p_y_3 + f_z_l_5*tangent_D_p_z_3
            - forward_t161*tangent_D_p_rx_5 - forward_t167*tangent_D_p_ry_5 - forward_t173*tangent_D_p_rz_5
            + t206*tangent_D_p_x_5 + t207*tangent_D_p_y_5 + t208*tangent_D_p_z_5);
        stiffness_rate[35] = stiffness_rate[77] =
            LANES(D_p_rx_3*tangent_f_rx_l_6 - D_p_rx_6*tangent_forward_t161 + D_p_ry_3*tangent_f_ry_l_6
            - D_p_ry_6*tangent_forward_t167 + D_p_rz_3*tangent_f_rz_l_6 - D_p_rz_6*tangent_forward_t173
            + D_p_x_3*tangent_f_x_l_6 + D_p_x_6*tangent_forward_t140 + D_p_x_6*tangent_forward_t242
            + D_p_y_3*tangent_f_y_l_6 + D_p_y_6*tangent_forward_t149 + D_p_y_6*tangent_forward_t243
            + D_p_z_3*tangent_f_z_l_6 + D_p_z_6*tangent_forward_t155 + D_p_z_6*tangent_forward_t244
            + f_rx_l_6*tangent_D_p_rx_3 + f_ry_l_6*tangent_D_p_ry_3 + f_rz_l_6*tangent_D_p_rz_3
            + f_x_l_6*tangent_D_p_x_3 + f_y_l_6*tangent_D_p_y_3 + f_z_l_6*tangent_D_p_z_3
            - forward_t161*tangent_D_p_rx_6 - forward_t167*tangent_D_p_ry_6 - forward_t173*tangent_D_p_rz_6
            + t206*tangent_D_p_x_6 + t207*tangent_D_p_y_6 + t208*tangent_D_p_z_6);
        stiffness_rate[38] = stiffness_rate[122] = LANES(-tangent_k_3);
        stiffness_rate[42] = stiffness_rate[182] = LANES(tangent_forward_t242);
        stiffness_rate[43] = stiffness_rate[197] = LANES(tangent_forward_t243);
        stiffness_rate[44] = stiffness_rate[212] = LANES(tangent_forward_t244);
        stiffness_rate[48] =
            LANES(D_p_rx_4*tangent_f_rx_l_4 - D_p_rx_4*tangent_forward_t162 + D_p_ry_4*tangent_f_ry_l_4
            - D_p_ry_4*tangent_forward_t168 + D_p_rz_4*tangent_f_rz_l_4 - D_p_rz_4*tangent_forward_t174
            + D_p_x_4*tangent_f_x_l_4 + D_p_x_4*tangent_forward_t142 + D_p_y_4*tangent_f_y_l_4
            + D_p_y_4*tangent_forward_t150 + D_p_z_4*tangent_f_z_l_4 + D_p_z_4*tangent_forward_t156
            - along_12*d_4_y*t210 + along_122*((D_p_x_4*D_p_x_4) + (D_p_y_4*D_p_y_4) + (D_p_z_4*D_p_z_4))
            - along_13*d_4_z*t210 - d_4_x*t190*t209 + forward_32*t211*tangent_forward_t44
            + forward_t44*t211*tangent_forward_32 - g_x*t210*tangent_d_4_x - g_y*t210*tangent_d_4_y
            - g_z*t210*tangent_d_4_z + tangent_D_p_rx_4*(f_rx_l_4 - forward_t162)
            + tangent_D_p_ry_4*(f_ry_l_4 - forward_t168) + tangent_D_p_rz_4*(f_rz_l_4 - forward_t174)
            + tangent_D_p_x_4*(f_x_l_4 + forward_t142 + 2.0*forward_t245) + tangent_D_p_y_4*(f_y_l_4
            + forward_t150 + 2.0*forward_t246) + tangent_D_p_z_4*(f_z_l_4 + forward_t156 + 2.0*forward_t247)
            + tangent_k_4 + tangent_mu_4);
        stiffness_rate[49] = stiffness_rate[63] =
            LANES(D_p_rx_4*tangent_f_rx_l_5 - D_p_rx_5*tangent_forward_t162 + D_p_ry_4*tangent_f_ry_l_5
            - D_p_ry_5*tangent_forward_t168 + D_p_rz_4*tangent_f_rz_l_5 - D_p_rz_5*tangent_forward_t174
            + D_p_x_4*tangent_f_x_l_5 + D_p_x_5*tangent_forward_t142 + D_p_x_5*tangent_forward_t245
            + D_p_y_4*tangent_f_y_l_5 + D_p_y_5*tangent_forward_t150 + D_p_y_5*tangent_forward_t246
            + D_p_z_4*tangent_f_z_l_5 + D_p_z_5*tangent_forward_t156 + D_p_z_5*tangent_forward_t247
            + f_rx_l_5*tangent_D_p_rx_4 + f_ry_l_5*tangent_D_p_ry_4 + f_rz_l_5*tangent_D_p_rz_4
            + f_x_l_5*tangent_D_p_x_4 + f_y_l_5*tangent_D_p_y_4 + f_z_l_5*tangent_D_p_z_4
            - forward_t162*tangent_D_p_rx_5 - forward_t168*tangent_D_p_ry_5 - forward_t174*tangent_D_p_rz_5
            + t212*tangent_D_p_x_5 + t213*tangent_D_p_y_5 + t214*tangent_D_p_z_5);
        stiffness_rate[50] = stiffness_rate[78] =
            LANES(D_p_rx_4*tangent_f_rx_l_6 - D_p_rx_6*tangent_forward_t162 + D_p_ry_4*tangent_f_ry_l_6
            - D_p_ry_6*tangent_forward_t168 + D_p_rz_4*tangent_f_rz_l_6 - D_p_rz_6*tangent_forward_t174
            + D_p_x_4*tangent_f_x_l_6 + D_p_x_6*tangent_forward_t142 + D_p_x_6*tangent_forward_t245
            + D_p_y_4*tangent_f_y_l_6 + D_p_y_6*tangent_forward_t150 + D_p_y_6*tangent_forward_t246
            + D_p_z_4*tangent_f_z_l_6 + D_p_z_6*tangent_forward_t156 + D_p_z_6*tangent_forward_t247
            + f_rx_l_6*tangent_D_p_rx_4 + f_ry_l_6*tangent_D_p_ry_4 + f_rz_l_6*tangent_D_p_rz_4
            + f_x_l_6*tangent_D_p_x_4 + f_y_l_6*tangent_D_p_y_4 + f_z_l_6*tangent_D_p_z_4
            - forward_t162*tangent_D_p_rx_6 - forward_t168*tangent_D_p_ry_6 - forward_t174*tangent_D_p_rz_6
            + t212*tangent_D_p_x_6 + t213*tangent_D_p_y_6 + t214*tangent_D_p_z_6);
        stiffness_rate[54] = stiffness_rate[138] = LANES(-tangent_k_4);
        stiffness_rate[57] = stiffness_rate[183] = LANES(tangent_forward_t245);
        stiffness_rate[58] = stiffness_rate[198] = LANES(tangent_forward_t246);
        stiffness_rate[59] = stiffness_rate[213] = LANES(tangent_forward_t247);
        stiffness_rate[64] =
            LANES(D_p_rx_5*tangent_f_rx_l_5 - D_p_rx_5*tangent_forward_t163 + D_p_ry_5*tangent_f_ry_l_5
            - D_p_ry_5*tangent_forward_t169 + D_p_rz_5*tangent_f_rz_l_5 - D_p_rz_5*tangent_forward_t175
            + D_p_x_5*tangent_f_x_l_5 + D_p_x_5*tangent_forward_t144 + D_p_y_5*tangent_f_y_l_5
            + D_p_y_5*tangent_forward_t151 + D_p_z_5*tangent_f_z_l_5 + D_p_z_5*tangent_forward_t157
            - along_12*d_5_y*t216 + along_122*((D_p_x_5*D_p_x_5) + (D_p_y_5*D_p_y_5) + (D_p_z_5*D_p_z_5))
            - along_13*d_5_z*t216 - d_5_x*t190*t215 + forward_33*t217*tangent_forward_t48
            + forward_t48*t217*tangent_forward_33 - g_x*t216*tangent_d_5_x - g_y*t216*tangent_d_5_y
            - g_z*t216*tangent_d_5_z + tangent_D_p_rx_5*(f_rx_l_5 - forward_t163)
            + tangent_D_p_ry_5*(f_ry_l_5 - forward_t169) + tangent_D_p_rz_5*(f_rz_l_5 - forward_t175)
            + tangent_D_p_x_5*(f_x_l_5 + forward_t144 + 2.0*forward_t248) + tangent_D_p_y_5*(f_y_l_5
            + forward_t151 + 2.0*forward_t249) + tangent_D_p_z_5*(f_z_l_5 + forward_t157 + 2.0*forward_t250)
            + tangent_k_5 + tangent_mu_5);
        stiffness_rate[65] = stiffness_rate[79] =
            LANES(D_p_rx_5*tangent_f_rx_l_6 - D_p_rx_6*tangent_forward_t163 + D_p_ry_5*tangent_f_ry_l_6
            - D_p_ry_6*tangent_forward_t169 + D_p_rz_5*tangent_f_rz_l_6 - D_p_rz_6*tangent_forward_t175
            + D_p_x_5*tangent_f_x_l_6 + D_p_x_6*tangent_forward_t144 + D_p_x_6*tangent_forward_t248
            + D_p_y_5*tangent_f_y_l_6 + D_p_y_6*tangent_forward_t151 + D_p_y_6*tangent_forward_t249
            + D_p_z_5*tangent_f_z_l_6 + D_p_z_6*tangent_forward_t157 + D_p_z_6*tangent_forward_t250
            + f_rx_l_6*tangent_D_p_rx_5 + f_ry_l_6*tangent_D_p_ry_5 + f_rz_l_6*tangent_D_p_rz_5
            + f_x_l_6*tangent_D_p_x_5 + f_y_l_6*tangent_D_p_y_5 + f_z_l_6*tangent_D_p_z_5
            - forward_t163*tangent_D_p_rx_6 - forward_t169*tangent_D_p_ry_6 - forward_t175*tangent_D_p_rz_6
            + tangent_D_p_x_6*(forward_t144 + forward_t248) + tangent_D_p_y_6*(forward_t151 + forward_t249)
            + tangent_D_p_z_6*(forward_t157 + forward_t250));
        stiffness_rate[70] = stiffness_rate[154] = LANES(-tangent_k_5);
        stiffness_rate[72] = stiffness_rate[184] = LANES(tangent_forward_t248);
        stiffness_rate[73] = stiffness_rate[199] = LANES(tangent_forward_t249);
        stiffness_rate[74] = stiffness_rate[214] = LANES(tangent_forward_t250);
        stiffness_rate[80] =
            LANES(D_p_rx_6*tangent_f_rx_l_6 - D_p_rx_6*tangent_forward_t164 + D_p_ry_6*tangent_f_ry_l_6
            - D_p_ry_6*tangent_forward_t170 + D_p_rz_6*tangent_f_rz_l_6 - D_p_rz_6*tangent_forward_t176
            + D_p_x_6*tangent_f_x_l_6 + D_p_x_6*tangent_forward_t146 + D_p_y_6*tangent_f_y_l_6
            + D_p_y_6*tangent_forward_t152 + D_p_z_6*tangent_f_z_l_6 + D_p_z_6*tangent_forward_t158
            - along_12*d_6_y*t219 + along_122*((D_p_x_6*D_p_x_6) + (D_p_y_6*D_p_y_6) + (D_p_z_6*D_p_z_6))
            - along_13*d_6_z*t219 - d_6_x*t190*t218 + forward_34*t221*tangent_forward_t52
            + forward_t52*t221*tangent_forward_34 - g_x*t219*tangent_d_6_x - g_y*t219*tangent_d_6_y
            - g_z*t219*tangent_d_6_z + tangent_D_p_rx_6*(f_rx_l_6 - forward_t164)
            + tangent_D_p_ry_6*(f_ry_l_6 - forward_t170) + tangent_D_p_rz_6*(f_rz_l_6 - forward_t176)
            + tangent_D_p_x_6*(D_p_x_6*t220 + f_x_l_6 + forward_t146) + tangent_D_p_y_6*(D_p_y_6*t220
            + f_y_l_6 + forward_t152) + tangent_D_p_z_6*(D_p_z_6*t220 + f_z_l_6 + forward_t158) + tangent_k_6
            + tangent_mu_6);
        stiffness_rate[86] = stiffness_rate[170] = LANES(-tangent_k_6);
        stiffness_rate[87] = stiffness_rate[185] = LANES(D_p_x_6*along_122 + k_C*tangent_D_p_x_6);
        stiffness_rate[88] = stiffness_rate[200] = LANES(D_p_y_6*along_122 + k_C*tangent_D_p_y_6);
        stiffness_rate[89] = stiffness_rate[215] = LANES(D_p_z_6*along_122 + k_C*tangent_D_p_z_6);
        stiffness_rate[96] = LANES(along_129 + tangent_k_1);
        stiffness_rate[112] = LANES(along_129 + tangent_k_2);
        stiffness_rate[128] = LANES(along_129 + tangent_k_3);
        stiffness_rate[144] = LANES(along_129 + tangent_k_4);
        stiffness_rate[160] = LANES(along_129 + tangent_k_5);
        stiffness_rate[176] = LANES(along_129 + tangent_k_6);
        stiffness_rate[192] = LANES(along_122);
        stiffness_rate[208] = LANES(along_122);
        stiffness_rate[224] = LANES(along_122);
        lanes_clear(motion_rate, 90);
        motion_rate[0] = LANES(tangent_D_p_x_1);
        motion_rate[1] = LANES(tangent_D_p_x_2);
        motion_rate[2] = LANES(tangent_D_p_x_3);
        motion_rate[3] = LANES(tangent_D_p_x_4);
        motion_rate[4] = LANES(tangent_D_p_x_5);
        motion_rate[5] = LANES(tangent_D_p_x_6);
        motion_rate[15] = LANES(tangent_D_p_y_1);
        motion_rate[16] = LANES(tangent_D_p_y_2);
        motion_rate[17] = LANES(tangent_D_p_y_3);
        motion_rate[18] = LANES(tangent_D_p_y_4);
        motion_rate[19] = LANES(tangent_D_p_y_5);
        motion_rate[20] = LANES(tangent_D_p_y_6);
        motion_rate[30] = LANES(tangent_D_p_z_1);
        motion_rate[31] = LANES(tangent_D_p_z_2);
        motion_rate[32] = LANES(tangent_D_p_z_3);
        motion_rate[33] = LANES(tangent_D_p_z_4);
        motion_rate[34] = LANES(tangent_D_p_z_5);
        motion_rate[35] = LANES(tangent_D_p_z_6);
        motion_rate[45] = LANES(tangent_D_p_rx_1);
        motion_rate[46] = LANES(tangent_D_p_rx_2);
        motion_rate[47] = LANES(tangent_D_p_rx_3);
        motion_rate[48] = LANES(tangent_D_p_rx_4);
        motion_rate[49] = LANES(tangent_D_p_rx_5);
        motion_rate[50] = LANES(tangent_D_p_rx_6);
        motion_rate[60] = LANES(tangent_D_p_ry_1);
        motion_rate[61] = LANES(tangent_D_p_ry_2);
        motion_rate[62] = LANES(tangent_D_p_ry_3);
        motion_rate[63] = LANES(tangent_D_p_ry_4);
        motion_rate[64] = LANES(tangent_D_p_ry_5);
        motion_rate[65] = LANES(tangent_D_p_ry_6);
        motion_rate[75] = LANES(tangent_D_p_rz_1);
        motion_rate[76] = LANES(tangent_D_p_rz_2);
        motion_rate[77] = LANES(tangent_D_p_rz_3);
        motion_rate[78] = LANES(tangent_D_p_rz_4);
        motion_rate[79] = LANES(tangent_D_p_rz_5);
        motion_rate[80] = LANES(tangent_D_p_rz_6);
        lanes_take(paths, path, mass_rate, stiffness_rate, motion_rate);
    }
}
