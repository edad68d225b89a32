/* Generated from the derivation of corexy.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * The mechanism corexy for the compiled evaluator.
 *
 * A part of the compiled evaluator, which includes it once for each instruction set: `lane` is a vector of
 * doubles, one for each pose.  Matrices are row-major; everything is in SI units.
 *
 * Names in the code.  Indices: belt j; run s of a belt.  t1, t2, ... are subexpressions shared by several
 * values.
 *   tau_st_j [N m]: static torque on motor pulley j
 *   I_j [kg m^2]: moment of inertia of motor pulley j, including the motor
 *   l_f_j_s [m]: free length of run s of belt j
 *   k_j_s [N/m]: stiffness of run s of belt j
 *   b [m]: distance of what slides along the beam from the beam's middle
 *   G_j [N]: gradient of the gravitational potential energy with respect to independent coordinate j
 *   det_j [N^2]: determinant of the equilibrium equations of axis j
 *   theta_j_st [rad]: static rotation of motor pulley j, relative to the unstrained transmissions
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#define LANES_POSE 2
#define LANES_INDEPENDENT 2
#define LANES_DIRECTIONS 2
#define LANES_LINEAR 2
#define LANES_DRIVES 2
#define LANES_DEPENDENT 2
#define LANES_BASE 4
#define LANES_ALL 11
#define LANES_GRADIENT 54
#define LANES_MARGINS 4

/* How many numbers each margin of a pose has, and how they must compare. */
static const struct lanes_rule LANES_RULES[] = {
    {4, LANES_AT_LEAST_ZERO},
};

/* Which of the base coordinates the pose determines, and which depend on these. */
static const int LANES_INDEPENDENT_INDICES[] = {0, 1};
static const int LANES_DEPENDENT_INDICES[] = {2, 3};

/* Positions at a pose, and the margins of a pose.
 *
 * Source: inverse_kinematics and travel_margin.
 * 4 operations; 4 with every named value expanded.
 */
static inline void lanes_position(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict q, lane *restrict margin)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double travel_min_x = parameters[25];
    const double travel_max_x = parameters[26];
    const double travel_min_y = parameters[27];
    const double travel_max_y = parameters[28];
    q[0] = LANES(x);
    q[1] = LANES(y);
    margin[0] = LANES(-travel_min_x + x);
    margin[1] = LANES(travel_max_x - x);
    margin[2] = LANES(-travel_min_y + y);
    margin[3] = LANES(travel_max_y - y);
}

/* Mass and stiffness matrices without effects, and the motion of the platform.
 *
 * Source: modal_matrices and platform_jacobian.
 * 74 operations; 317 with every named value expanded.
 */
static inline void lanes_base(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict M, lane *restrict K, lane *restrict J_p)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double m_h = parameters[0];
    const double m_g = parameters[1];
    const double g_1_1 = parameters[5];
    const double g_1_2 = parameters[6];
    const double g_2_1 = parameters[7];
    const double g_2_2 = parameters[8];
    const double l_0_1_1 = parameters[9];
    const double l_0_1_2 = parameters[10];
    const double l_0_2_1 = parameters[11];
    const double l_0_2_2 = parameters[12];
    const double k_sp_1 = parameters[13];
    const double k_sp_2 = parameters[14];
    const double w_b_1 = parameters[15];
    const double w_b_2 = parameters[16];
    const double R_p_1 = parameters[17];
    const double R_p_2 = parameters[18];
    const double I_p_1 = parameters[19];
    const double I_p_2 = parameters[20];
    const double I_m_1 = parameters[21];
    const double I_m_2 = parameters[22];
    const double i_g_1 = parameters[23];
    const double i_g_2 = parameters[24];
    const double I_1 = I_m_1*(i_g_1*i_g_1) + I_p_1;
    const double I_2 = I_m_2*(i_g_2*i_g_2) + I_p_2;
    const lane t1 = g_1_1*x + g_1_2*y;
    const lane l_f_1_1 = l_0_1_1 + t1;
    const double t2 = k_sp_1*w_b_1;
    const lane k_1_1 = t2/l_f_1_1;
    const lane l_f_1_2 = l_0_1_2 - t1;
    const lane k_1_2 = t2/l_f_1_2;
    const lane t3 = g_2_1*x + g_2_2*y;
    const lane l_f_2_1 = l_0_2_1 + t3;
    const double t4 = k_sp_2*w_b_2;
    const lane k_2_1 = t4/l_f_2_1;
    const lane l_f_2_2 = l_0_2_2 - t3;
    const lane k_2_2 = t4/l_f_2_2;
    const double t5 = (g_1_1*g_1_1);
    const double t6 = (g_2_1*g_2_1);
    const double t7 = g_1_1*g_1_2;
    const double t8 = g_2_1*g_2_2;
    const double t9 = R_p_1*g_1_1;
    const double t10 = R_p_2*g_2_1;
    const double t11 = (g_1_2*g_1_2);
    const double t12 = (g_2_2*g_2_2);
    const double t13 = R_p_1*g_1_2;
    const double t14 = R_p_2*g_2_2;
    const double t15 = (R_p_1*R_p_1);
    const double t16 = (R_p_2*R_p_2);
    lanes_clear(M, 16);
    M[0] = LANES(m_h);
    M[5] = LANES(m_g + m_h);
    M[10] = LANES(I_1);
    M[15] = LANES(I_2);
    lanes_clear(K, 16);
    K[0] = LANES(k_1_1*t5 + k_1_2*t5 + k_2_1*t6 + k_2_2*t6);
    K[1] = K[4] = LANES(k_1_1*t7 + k_1_2*t7 + k_2_1*t8 + k_2_2*t8);
    K[2] = K[8] = LANES(k_1_1*t9 + k_1_2*t9);
    K[3] = K[12] = LANES(k_2_1*t10 + k_2_2*t10);
    K[5] = LANES(k_1_1*t11 + k_1_2*t11 + k_2_1*t12 + k_2_2*t12);
    K[6] = K[9] = LANES(k_1_1*t13 + k_1_2*t13);
    K[7] = K[13] = LANES(k_2_1*t14 + k_2_2*t14);
    K[10] = LANES(k_1_1*t15 + k_1_2*t15);
    K[15] = LANES(k_2_1*t16 + k_2_2*t16);
    lanes_clear(J_p, 8);
    J_p[0] = LANES(1.0);
    J_p[5] = LANES(1.0);
}

/* Mass and stiffness matrices with all released joints free, and the motion of the platform.
 *
 * Source: extended_matrices and extended_platform_motion.
 * 273 operations; 3193 with every named value expanded.
 */
static inline void lanes_extended(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict M, lane *restrict K, lane *restrict J_p)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double m_h = parameters[0];
    const double m_g = parameters[1];
    const double g_y = parameters[3];
    const double g_1_1 = parameters[5];
    const double g_1_2 = parameters[6];
    const double g_2_1 = parameters[7];
    const double g_2_2 = parameters[8];
    const double l_0_1_1 = parameters[9];
    const double l_0_1_2 = parameters[10];
    const double l_0_2_1 = parameters[11];
    const double l_0_2_2 = parameters[12];
    const double k_sp_1 = parameters[13];
    const double k_sp_2 = parameters[14];
    const double w_b_1 = parameters[15];
    const double w_b_2 = parameters[16];
    const double R_p_1 = parameters[17];
    const double R_p_2 = parameters[18];
    const double I_p_1 = parameters[19];
    const double I_p_2 = parameters[20];
    const double I_m_1 = parameters[21];
    const double I_m_2 = parameters[22];
    const double i_g_1 = parameters[23];
    const double i_g_2 = parameters[24];
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double c_E = effects[2];
    const double rho_b = effects[4];
    const double c_T = effects[5];
    const double F_T = effects[6];
    const double k_C = effects[7];
    const double I_G = effects[9];
    const double m_L = effects[10];
    const double k_S = effects[13];
    const double m_F = effects[17];
    const double J_B = effects[21];
    const double x_B = effects[22];
    const lane b = x - x_B;
    const double t1 = I_m_1*(i_g_1*i_g_1);
    const double I_1 = I_G + I_p_1 + t1;
    const double t2 = I_m_2*(i_g_2*i_g_2);
    const double I_2 = I_G + I_p_2 + t2;
    const lane t3 = g_1_1*x + g_1_2*y;
    const lane l_f_1_1 = l_0_1_1 + t3;
    const double t4 = F_T*c_T + 1.0;
    const double t5 = c_E*t4;
    const double t6 = k_sp_1*w_b_1*(a_B_1 + 1.0);
    const double t7 = t5*t6;
    const double t8 = t4*t6;
    const lane k_1_1 = t8/(l_f_1_1 + t7);
    const lane l_f_1_2 = l_0_1_2 - t3;
    const lane k_1_2 = t8/(l_f_1_2 + t7);
    const lane t9 = g_2_1*x + g_2_2*y;
    const lane l_f_2_1 = l_0_2_1 + t9;
    const double t10 = k_sp_2*w_b_2*(a_B_2 + 1.0);
    const double t11 = t10*t5;
    const double t12 = t10*t4;
    const lane k_2_1 = t12/(l_f_2_1 + t11);
    const lane l_f_2_2 = l_0_2_2 - t9;
    const lane k_2_2 = t12/(l_f_2_2 + t11);
    const double t13 = (g_1_1*g_1_1);
    const double t14 = (1.0/3.0)*rho_b;
    const lane t15 = l_f_1_1*t14;
    const lane t16 = l_f_1_2*t14;
    const double t17 = (g_2_1*g_2_1);
    const lane t18 = l_f_2_1*t14;
    const lane t19 = l_f_2_2*t14;
    const double t20 = m_L + m_h;
    const lane t21 = g_1_1*t15;
    const lane t22 = g_1_2*t21;
    const lane t23 = g_1_1*t16;
    const lane t24 = g_1_2*t23;
    const lane t25 = g_2_1*t18;
    const lane t26 = g_2_2*t25;
    const lane t27 = g_2_1*t19;
    const lane t28 = g_2_2*t27;
    const double t29 = (1.0/6.0)*rho_b;
    const double t30 = R_p_1*t29;
    const lane t31 = l_f_1_1*t30;
    const lane t32 = l_f_1_2*t30;
    const double t33 = R_p_2*t29;
    const lane t34 = l_f_2_1*t33;
    const lane t35 = l_f_2_2*t33;
    const double t36 = (g_1_2*g_1_2);
    const lane t37 = t15*t36;
    const lane t38 = t16*t36;
    const double t39 = (g_2_2*g_2_2);
    const lane t40 = t18*t39;
    const lane t41 = t19*t39;
    const double t42 = m_g + t20;
    const lane t43 = g_1_2*t31;
    const lane t44 = g_1_2*t32;
    const lane t45 = g_2_2*t34;
    const lane t46 = g_2_2*t35;
    const lane t47 = g_1_2*t15;
    const lane t48 = g_1_2*t16;
    const lane t49 = g_2_2*t18;
    const lane t50 = g_2_2*t19;
    const lane t51 = b*t20;
    const double t52 = (R_p_1*R_p_1);
    const double t53 = (R_p_2*R_p_2);
    const double t54 = m_F + t42;
    const lane t55 = (b*b);
    const lane t56 = g_1_1*k_1_1;
    const lane t57 = g_1_2*t56;
    const lane t58 = g_1_1*k_1_2;
    const lane t59 = g_1_2*t58;
    const lane t60 = g_2_1*k_2_1;
    const lane t61 = g_2_2*t60;
    const lane t62 = g_2_1*k_2_2;
    const lane t63 = g_2_2*t62;
    const lane t64 = k_1_1*t36;
    const lane t65 = k_1_2*t36;
    const lane t66 = k_2_1*t39;
    const lane t67 = k_2_2*t39;
    const lane t68 = g_1_2*k_1_1;
    const lane t69 = R_p_1*t68;
    const lane t70 = g_1_2*k_1_2;
    const lane t71 = R_p_1*t70;
    const lane t72 = g_2_2*k_2_1;
    const lane t73 = R_p_2*t72;
    const lane t74 = g_2_2*k_2_2;
    const lane t75 = R_p_2*t74;
    const lane t76 = b*k_C;
    lanes_clear(M, 121);
    M[0] = LANES(t13*t15 + t13*t16 + t17*t18 + t17*t19 + t20);
    M[1] = M[11] = LANES(t22 + t24 + t26 + t28);
    M[2] = M[22] = LANES(-g_1_1*t31 - g_1_1*t32);
    M[3] = M[33] = LANES(-g_2_1*t34 - g_2_1*t35);
    M[6] = M[66] = LANES(t21 + t23);
    M[7] = M[77] = LANES(t25 + t27);
    M[8] = M[88] = LANES(t20);
    M[10] = M[110] = LANES(b*t22 + b*t24 + b*t26 + b*t28);
    M[12] = LANES(t37 + t38 + t40 + t41 + t42);
    M[13] = M[23] = LANES(-t43 - t44);
    M[14] = M[34] = LANES(-t45 - t46);
    M[17] = M[67] = LANES(t47 + t48);
    M[18] = M[78] = LANES(t49 + t50);
    M[20] = M[100] = LANES(t42);
    M[21] = M[111] = LANES(b*t37 + b*t38 + b*t40 + b*t41 + t51);
    M[24] = LANES(I_1 + t15*t52 + t16*t52);
    M[26] = M[46] = LANES(t1);
    M[28] = M[68] = LANES(-t31 - t32);
    M[32] = M[112] = LANES(-b*t43 - b*t44);
    M[36] = LANES(I_2 + t18*t53 + t19*t53);
    M[38] = M[58] = LANES(t2);
    M[40] = M[80] = LANES(-t34 - t35);
    M[43] = M[113] = LANES(-b*t45 - b*t46);
    M[48] = LANES(t1);
    M[60] = LANES(t2);
    M[72] = LANES(t15 + t16);
    M[76] = M[116] = LANES(b*t47 + b*t48);
    M[84] = LANES(t18 + t19);
    M[87] = M[117] = LANES(b*t49 + b*t50);
    M[96] = LANES(t54);
    M[108] = LANES(t54);
    M[109] = M[119] = LANES(t51);
    M[120] = LANES(J_B + t37*t55 + t38*t55 + t40*t55 + t41*t55 + 2.0*t55*((1.0/2.0)*m_L + (1.0/2.0)*m_h));
    lanes_clear(K, 121);
    K[0] = LANES(k_1_1*t13 + k_1_2*t13 + k_2_1*t17 + k_2_2*t17 + k_C);
    K[1] = K[11] = LANES(t57 + t59 + t61 + t63);
    K[2] = K[22] = LANES(R_p_1*t56 + R_p_1*t58);
    K[3] = K[33] = LANES(R_p_2*t60 + R_p_2*t62);
    K[6] = K[66] = LANES(t56 + t58);
    K[7] = K[77] = LANES(t60 + t62);
    K[8] = K[88] = LANES(k_C);
    K[10] = K[110] = LANES(b*t57 + b*t59 + b*t61 + b*t63 - g_y*t20);
    K[12] = LANES(k_C + t64 + t65 + t66 + t67);
    K[13] = K[23] = LANES(t69 + t71);
    K[14] = K[34] = LANES(t73 + t75);
    K[17] = K[67] = LANES(t68 + t70);
    K[18] = K[78] = LANES(t72 + t74);
    K[20] = K[100] = LANES(k_C);
    K[21] = K[111] = LANES(b*t64 + b*t65 + b*t66 + b*t67 + t76);
    K[24] = LANES(k_1_1*t52 + k_1_2*t52 + k_S);
    K[26] = K[46] = LANES(k_S);
    K[28] = K[68] = LANES(R_p_1*k_1_1 + R_p_1*k_1_2);
    K[32] = K[112] = LANES(b*t69 + b*t71);
    K[36] = LANES(k_2_1*t53 + k_2_2*t53 + k_S);
    K[38] = K[58] = LANES(k_S);
    K[40] = K[80] = LANES(R_p_2*k_2_1 + R_p_2*k_2_2);
    K[43] = K[113] = LANES(b*t73 + b*t75);
    K[48] = LANES(k_S);
    K[60] = LANES(k_S);
    K[72] = LANES(k_1_1 + k_1_2);
    K[76] = K[116] = LANES(b*t68 + b*t70);
    K[84] = LANES(k_2_1 + k_2_2);
    K[87] = K[117] = LANES(b*t72 + b*t74);
    K[96] = LANES(k_C);
    K[108] = LANES(k_C);
    K[109] = K[119] = LANES(t76);
    K[120] = LANES(k_C*t55 + t55*t64 + t55*t65 + t55*t66 + t55*t67);
    lanes_clear(J_p, 22);
    J_p[0] = LANES(1.0);
    J_p[8] = LANES(1.0);
    J_p[12] = LANES(1.0);
    J_p[20] = LANES(1.0);
    J_p[21] = LANES(b);
}

/* Platform Jacobian, static equilibrium and elastic stiffness without effects.
 *
 * Source: platform_jacobian, static_equilibrium, elastic_hessian.
 * 90 operations; 1032 with every named value expanded.
 */
static inline void lanes_statics(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict D_p, lane *restrict tau_st, lane *restrict theta_st,
    lane *restrict H_el)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double m_h = parameters[0];
    const double m_g = parameters[1];
    const double g_x = parameters[2];
    const double g_y = parameters[3];
    const double g_1_1 = parameters[5];
    const double g_1_2 = parameters[6];
    const double g_2_1 = parameters[7];
    const double g_2_2 = parameters[8];
    const double l_0_1_1 = parameters[9];
    const double l_0_1_2 = parameters[10];
    const double l_0_2_1 = parameters[11];
    const double l_0_2_2 = parameters[12];
    const double k_sp_1 = parameters[13];
    const double k_sp_2 = parameters[14];
    const double w_b_1 = parameters[15];
    const double w_b_2 = parameters[16];
    const double R_p_1 = parameters[17];
    const double R_p_2 = parameters[18];
    const lane t1 = g_1_1*x + g_1_2*y;
    const lane l_f_1_1 = l_0_1_1 + t1;
    const double t2 = k_sp_1*w_b_1;
    const lane k_1_1 = t2/l_f_1_1;
    const lane l_f_1_2 = l_0_1_2 - t1;
    const lane k_1_2 = t2/l_f_1_2;
    const lane t3 = g_2_1*x + g_2_2*y;
    const lane l_f_2_1 = l_0_2_1 + t3;
    const double t4 = k_sp_2*w_b_2;
    const lane k_2_1 = t4/l_f_2_1;
    const lane l_f_2_2 = l_0_2_2 - t3;
    const lane k_2_2 = t4/l_f_2_2;
    const double G_1 = -g_x*m_h;
    const double G_2 = -g_y*(m_g + m_h);
    const double t5 = R_p_2*g_2_1;
    const lane t6 = k_2_1*t5 + k_2_2*t5;
    const double t7 = R_p_1*g_1_1;
    const lane t8 = k_1_1*t7 + k_1_2*t7;
    const double t9 = R_p_2*g_2_2;
    const lane t10 = k_2_1*t9 + k_2_2*t9;
    const double t11 = R_p_1*g_1_2;
    const lane t12 = k_1_1*t11 + k_1_2*t11;
    const lane det_1 = t10*t8 - t12*t6;
    const lane t13 = 1.0/det_1;
    const lane theta_1_st = t13*(-G_1*t10 + G_2*t6);
    const lane theta_2_st = t13*(G_1*t12 - G_2*t8);
    const double t14 = (R_p_1*R_p_1);
    const lane t15 = k_1_1*t14;
    const lane t16 = k_1_2*t14;
    const lane tau_st_1 = t15*theta_1_st + t16*theta_1_st;
    const double t17 = (R_p_2*R_p_2);
    const lane t18 = k_2_1*t17;
    const lane t19 = k_2_2*t17;
    const lane tau_st_2 = t18*theta_2_st + t19*theta_2_st;
    const double t20 = (g_1_1*g_1_1);
    const double t21 = (g_2_1*g_2_1);
    const double t22 = g_1_1*g_1_2;
    const double t23 = g_2_1*g_2_2;
    const double t24 = (g_1_2*g_1_2);
    const double t25 = (g_2_2*g_2_2);
    lanes_clear(D_p, 4);
    D_p[0] = LANES(1.0);
    D_p[3] = LANES(1.0);
    tau_st[0] = LANES(tau_st_1);
    tau_st[1] = LANES(tau_st_2);
    theta_st[0] = LANES(theta_1_st);
    theta_st[1] = LANES(theta_2_st);
    lanes_clear(H_el, 16);
    H_el[0] = LANES(k_1_1*t20 + k_1_2*t20 + k_2_1*t21 + k_2_2*t21);
    H_el[1] = H_el[4] = LANES(k_1_1*t22 + k_1_2*t22 + k_2_1*t23 + k_2_2*t23);
    H_el[2] = H_el[8] = LANES(t8);
    H_el[3] = H_el[12] = LANES(t6);
    H_el[5] = LANES(k_1_1*t24 + k_1_2*t24 + k_2_1*t25 + k_2_2*t25);
    H_el[6] = H_el[9] = LANES(t12);
    H_el[7] = H_el[13] = LANES(t10);
    H_el[10] = LANES(t15 + t16);
    H_el[15] = LANES(t18 + t19);
}

/* Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 75 operations; 1722 with every named value expanded.
 */
static inline void lanes_extended_statics(const lane *restrict pose, const double *restrict parameters,
    const double *restrict effects, lane *restrict tau_st, lane *restrict theta_st)
{
    (void)pose;
    (void)parameters;
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double m_h = parameters[0];
    const double m_g = parameters[1];
    const double g_x = parameters[2];
    const double g_y = parameters[3];
    const double g_1_1 = parameters[5];
    const double g_1_2 = parameters[6];
    const double g_2_1 = parameters[7];
    const double g_2_2 = parameters[8];
    const double l_0_1_1 = parameters[9];
    const double l_0_1_2 = parameters[10];
    const double l_0_2_1 = parameters[11];
    const double l_0_2_2 = parameters[12];
    const double k_sp_1 = parameters[13];
    const double k_sp_2 = parameters[14];
    const double w_b_1 = parameters[15];
    const double w_b_2 = parameters[16];
    const double R_p_1 = parameters[17];
    const double R_p_2 = parameters[18];
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double c_E = effects[2];
    const double c_T = effects[5];
    const double F_T = effects[6];
    const double m_L = effects[10];
    const lane t1 = g_1_1*x + g_1_2*y;
    const lane l_f_1_1 = l_0_1_1 + t1;
    const double t2 = F_T*c_T + 1.0;
    const double t3 = c_E*t2;
    const double t4 = k_sp_1*w_b_1*(a_B_1 + 1.0);
    const double t5 = t3*t4;
    const double t6 = t2*t4;
    const lane k_1_1 = t6/(l_f_1_1 + t5);
    const lane l_f_1_2 = l_0_1_2 - t1;
    const lane k_1_2 = t6/(l_f_1_2 + t5);
    const lane t7 = g_2_1*x + g_2_2*y;
    const lane l_f_2_1 = l_0_2_1 + t7;
    const double t8 = k_sp_2*w_b_2*(a_B_2 + 1.0);
    const double t9 = t3*t8;
    const double t10 = t2*t8;
    const lane k_2_1 = t10/(l_f_2_1 + t9);
    const lane l_f_2_2 = l_0_2_2 - t7;
    const lane k_2_2 = t10/(l_f_2_2 + t9);
    const double t11 = m_L + m_h;
    const double G_1 = -g_x*t11;
    const double G_2 = -g_y*(m_g + t11);
    const double t12 = R_p_1*g_1_1;
    const lane t13 = k_1_1*t12 + k_1_2*t12;
    const double t14 = R_p_2*g_2_2;
    const lane t15 = k_2_1*t14 + k_2_2*t14;
    const double t16 = R_p_1*g_1_2;
    const lane t17 = k_1_1*t16 + k_1_2*t16;
    const double t18 = R_p_2*g_2_1;
    const lane t19 = k_2_1*t18 + k_2_2*t18;
    const lane det_1 = t13*t15 - t17*t19;
    const lane t20 = 1.0/det_1;
    const lane theta_1_st = t20*(-G_1*t15 + G_2*t19);
    const lane theta_2_st = t20*(G_1*t17 - G_2*t13);
    const lane t21 = (R_p_1*R_p_1)*theta_1_st;
    const lane tau_st_1 = k_1_1*t21 + k_1_2*t21;
    const lane t22 = (R_p_2*R_p_2)*theta_2_st;
    const lane tau_st_2 = k_2_1*t22 + k_2_2*t22;
    tau_st[0] = LANES(tau_st_1);
    tau_st[1] = LANES(tau_st_2);
    theta_st[0] = LANES(theta_1_st);
    theta_st[1] = LANES(theta_2_st);
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through base.
 * 140 operations; 861 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_base_gradient(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int modes, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double g_1_1 = parameters[5];
    const double g_1_2 = parameters[6];
    const double g_2_1 = parameters[7];
    const double g_2_2 = parameters[8];
    const double l_0_1_1 = parameters[9];
    const double l_0_1_2 = parameters[10];
    const double l_0_2_1 = parameters[11];
    const double l_0_2_2 = parameters[12];
    const double k_sp_1 = parameters[13];
    const double k_sp_2 = parameters[14];
    const double w_b_1 = parameters[15];
    const double w_b_2 = parameters[16];
    const double R_p_1 = parameters[17];
    const double R_p_2 = parameters[18];
    const double I_m_1 = parameters[21];
    const double I_m_2 = parameters[22];
    const double i_g_1 = parameters[23];
    const double i_g_2 = parameters[24];
    const lane forward_t1 = g_1_1*x + g_1_2*y;
    const lane l_f_1_1 = forward_t1 + l_0_1_1;
    const double forward_t2 = k_sp_1*w_b_1;
    const lane forward_0 = 1.0/l_f_1_1;
    const lane k_1_1 = forward_0*forward_t2;
    const lane l_f_1_2 = -forward_t1 + l_0_1_2;
    const lane forward_1 = 1.0/l_f_1_2;
    const lane k_1_2 = forward_1*forward_t2;
    const lane forward_t3 = g_2_1*x + g_2_2*y;
    const lane l_f_2_1 = forward_t3 + l_0_2_1;
    const double forward_t4 = k_sp_2*w_b_2;
    const lane forward_2 = 1.0/l_f_2_1;
    const lane k_2_1 = forward_2*forward_t4;
    const lane l_f_2_2 = -forward_t3 + l_0_2_2;
    const lane forward_3 = 1.0/l_f_2_2;
    const lane k_2_2 = forward_3*forward_t4;
    const double forward_t5 = (g_1_1*g_1_1);
    const double forward_t6 = (g_2_1*g_2_1);
    const double forward_t7 = g_1_1*g_1_2;
    const double forward_t8 = g_2_1*g_2_2;
    const double forward_t9 = R_p_1*g_1_1;
    const double forward_t10 = R_p_2*g_2_1;
    const double forward_t11 = (g_1_2*g_1_2);
    const double forward_t12 = (g_2_2*g_2_2);
    const double forward_t13 = R_p_1*g_1_2;
    const double forward_t14 = R_p_2*g_2_2;
    const double forward_t15 = (R_p_1*R_p_1);
    const double forward_t16 = (R_p_2*R_p_2);
    const lane t2 = k_2_1 + k_2_2;
    const lane t4 = k_1_1 + k_1_2;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 4;
        const lane eigenvalue = eigenvalues[mode];
        lane *restrict gradient = gradients + mode * stride;
        const lane shape_1 = shape[0];
        const lane shape_2 = shape[1];
        const lane shape_3 = shape[2];
        const lane shape_4 = shape[3];
        const lane t1 = (shape_4*shape_4);
        const lane adjoint_forward_t16 = t1*t2;
        const lane t3 = (shape_3*shape_3);
        const lane adjoint_forward_t15 = t3*t4;
        const lane t5 = 2.0*shape_2;
        const lane t6 = shape_4*t2;
        const lane adjoint_forward_t14 = t5*t6;
        const lane t7 = shape_3*t4;
        const lane adjoint_forward_t13 = t5*t7;
        const lane t8 = 2.0*shape_1;
        const lane adjoint_forward_t10 = t6*t8;
        const lane adjoint_forward_t9 = t7*t8;
        const lane t9 = shape_1*t5;
        const lane t10 = (shape_2*shape_2);
        const lane t11 = (shape_1*shape_1);
        const lane adjoint_k_2_2 =
            forward_t10*shape_4*t8 + forward_t12*t10 + forward_t14*shape_4*t5 + forward_t16*t1
            + forward_t6*t11 + forward_t8*t9;
        const lane adjoint_forward_3 = adjoint_k_2_2*forward_t4;
        const lane adjoint_l_f_2_2 = -adjoint_forward_3*(forward_3*forward_3);
        const lane adjoint_forward_2 = adjoint_k_2_2*forward_t4;
        const lane adjoint_forward_t4 = adjoint_k_2_2*forward_2 + adjoint_k_2_2*forward_3;
        const lane adjoint_l_f_2_1 = -adjoint_forward_2*(forward_2*forward_2);
        const lane adjoint_forward_t3 = adjoint_l_f_2_1 - adjoint_l_f_2_2;
        const lane adjoint_k_1_2 =
            forward_t11*t10 + forward_t13*shape_3*t5 + forward_t15*t3 + forward_t5*t11 + forward_t7*t9
            + forward_t9*shape_3*t8;
        const lane adjoint_forward_1 = adjoint_k_1_2*forward_t2;
        const lane adjoint_l_f_1_2 = -adjoint_forward_1*(forward_1*forward_1);
        const lane adjoint_forward_0 = adjoint_k_1_2*forward_t2;
        const lane adjoint_forward_t2 = adjoint_k_1_2*forward_0 + adjoint_k_1_2*forward_1;
        const lane adjoint_l_f_1_1 = -adjoint_forward_0*(forward_0*forward_0);
        const lane adjoint_forward_t1 = adjoint_l_f_1_1 - adjoint_l_f_1_2;
        const lane adjoint_I_2 = -eigenvalue*t1;
        const lane adjoint_I_1 = -eigenvalue*t3;
        const lane t12 = eigenvalue*t10;
        lanes_clear(gradient, 54);
        gradient[0] = LANES(-eigenvalue*t11 - t12);
        gradient[1] = LANES(-t12);
        gradient[9] = LANES(adjoint_l_f_1_1);
        gradient[10] = LANES(adjoint_l_f_1_2);
        gradient[11] = LANES(adjoint_l_f_2_1);
        gradient[12] = LANES(adjoint_l_f_2_2);
        gradient[13] = LANES(adjoint_forward_t2*w_b_1);
        gradient[14] = LANES(adjoint_forward_t4*w_b_2);
        gradient[15] = LANES(adjoint_forward_t2*k_sp_1);
        gradient[16] = LANES(adjoint_forward_t4*k_sp_2);
        gradient[17] =
            LANES(2.0*R_p_1*adjoint_forward_t15 + adjoint_forward_t13*g_1_2 + adjoint_forward_t9*g_1_1);
        gradient[18] =
            LANES(2.0*R_p_2*adjoint_forward_t16 + adjoint_forward_t10*g_2_1 + adjoint_forward_t14*g_2_2);
        gradient[19] = LANES(adjoint_I_1);
        gradient[20] = LANES(adjoint_I_2);
        gradient[21] = LANES(adjoint_I_1*(i_g_1*i_g_1));
        gradient[22] = LANES(adjoint_I_2*(i_g_2*i_g_2));
        gradient[23] = LANES(2.0*I_m_1*adjoint_I_1*i_g_1);
        gradient[24] = LANES(2.0*I_m_2*adjoint_I_2*i_g_2);
        gradient[52] = LANES(adjoint_forward_t1*g_1_1 + adjoint_forward_t3*g_2_1);
        gradient[53] = LANES(adjoint_forward_t1*g_1_2 + adjoint_forward_t3*g_2_2);
    }
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through extended.
 * 545 operations; 8206 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_gradient(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int modes, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double m_h = parameters[0];
    const double g_y = parameters[3];
    const double g_1_1 = parameters[5];
    const double g_1_2 = parameters[6];
    const double g_2_1 = parameters[7];
    const double g_2_2 = parameters[8];
    const double l_0_1_1 = parameters[9];
    const double l_0_1_2 = parameters[10];
    const double l_0_2_1 = parameters[11];
    const double l_0_2_2 = parameters[12];
    const double k_sp_1 = parameters[13];
    const double k_sp_2 = parameters[14];
    const double w_b_1 = parameters[15];
    const double w_b_2 = parameters[16];
    const double R_p_1 = parameters[17];
    const double R_p_2 = parameters[18];
    const double I_m_1 = parameters[21];
    const double I_m_2 = parameters[22];
    const double i_g_1 = parameters[23];
    const double i_g_2 = parameters[24];
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double c_E = effects[2];
    const double rho_b = effects[4];
    const double c_T = effects[5];
    const double F_T = effects[6];
    const double k_C = effects[7];
    const double m_L = effects[10];
    const double x_B = effects[22];
    const lane b = x - x_B;
    const lane forward_t3 = g_1_1*x + g_1_2*y;
    const lane l_f_1_1 = forward_t3 + l_0_1_1;
    const double forward_t4 = F_T*c_T + 1.0;
    const double forward_t5 = c_E*forward_t4;
    const double t1 = a_B_1 + 1.0;
    const double t2 = t1*w_b_1;
    const double forward_t6 = k_sp_1*t2;
    const double forward_t7 = forward_t5*forward_t6;
    const double forward_t8 = forward_t4*forward_t6;
    const lane t3 = forward_t7 + l_f_1_1;
    const lane forward_0 = 1.0/t3;
    const lane k_1_1 = forward_0*forward_t8;
    const lane l_f_1_2 = -forward_t3 + l_0_1_2;
    const lane t4 = forward_t7 + l_f_1_2;
    const lane forward_1 = 1.0/t4;
    const lane k_1_2 = forward_1*forward_t8;
    const lane forward_t9 = g_2_1*x + g_2_2*y;
    const lane l_f_2_1 = forward_t9 + l_0_2_1;
    const double t5 = a_B_2 + 1.0;
    const double t6 = t5*w_b_2;
    const double forward_t10 = k_sp_2*t6;
    const double forward_t11 = forward_t10*forward_t5;
    const double forward_t12 = forward_t10*forward_t4;
    const lane t7 = forward_t11 + l_f_2_1;
    const lane forward_2 = 1.0/t7;
    const lane k_2_1 = forward_2*forward_t12;
    const lane l_f_2_2 = -forward_t9 + l_0_2_2;
    const lane t8 = forward_t11 + l_f_2_2;
    const lane forward_3 = 1.0/t8;
    const lane k_2_2 = forward_3*forward_t12;
    const double forward_t13 = (g_1_1*g_1_1);
    const double forward_t14 = (1.0/3.0)*rho_b;
    const lane forward_t15 = forward_t14*l_f_1_1;
    const lane forward_t16 = forward_t14*l_f_1_2;
    const double forward_t17 = (g_2_1*g_2_1);
    const lane forward_t18 = forward_t14*l_f_2_1;
    const lane forward_t19 = forward_t14*l_f_2_2;
    const double forward_t20 = m_L + m_h;
    const lane forward_t21 = forward_t15*g_1_1;
    const lane forward_t22 = forward_t21*g_1_2;
    const lane forward_t23 = forward_t16*g_1_1;
    const lane forward_t24 = forward_t23*g_1_2;
    const lane forward_t25 = forward_t18*g_2_1;
    const lane forward_t26 = forward_t25*g_2_2;
    const lane forward_t27 = forward_t19*g_2_1;
    const lane forward_t28 = forward_t27*g_2_2;
    const double forward_t29 = (1.0/6.0)*rho_b;
    const double forward_t30 = R_p_1*forward_t29;
    const lane forward_t31 = forward_t30*l_f_1_1;
    const lane forward_t32 = forward_t30*l_f_1_2;
    const double forward_t33 = R_p_2*forward_t29;
    const lane forward_t34 = forward_t33*l_f_2_1;
    const lane forward_t35 = forward_t33*l_f_2_2;
    const double forward_t36 = (g_1_2*g_1_2);
    const lane forward_t37 = forward_t15*forward_t36;
    const lane forward_t38 = forward_t16*forward_t36;
    const double forward_t39 = (g_2_2*g_2_2);
    const lane forward_t40 = forward_t18*forward_t39;
    const lane forward_t41 = forward_t19*forward_t39;
    const lane forward_t43 = forward_t31*g_1_2;
    const lane forward_t44 = forward_t32*g_1_2;
    const lane forward_t45 = forward_t34*g_2_2;
    const lane forward_t46 = forward_t35*g_2_2;
    const lane forward_t47 = forward_t15*g_1_2;
    const lane forward_t48 = forward_t16*g_1_2;
    const lane forward_t49 = forward_t18*g_2_2;
    const lane forward_t50 = forward_t19*g_2_2;
    const double forward_t52 = (R_p_1*R_p_1);
    const double forward_t53 = (R_p_2*R_p_2);
    const lane forward_t55 = (b*b);
    const lane forward_t56 = g_1_1*k_1_1;
    const lane forward_t57 = forward_t56*g_1_2;
    const lane forward_t58 = g_1_1*k_1_2;
    const lane forward_t59 = forward_t58*g_1_2;
    const lane forward_t60 = g_2_1*k_2_1;
    const lane forward_t61 = forward_t60*g_2_2;
    const lane forward_t62 = g_2_1*k_2_2;
    const lane forward_t63 = forward_t62*g_2_2;
    const lane forward_t64 = forward_t36*k_1_1;
    const lane forward_t65 = forward_t36*k_1_2;
    const lane forward_t66 = forward_t39*k_2_1;
    const lane forward_t67 = forward_t39*k_2_2;
    const lane forward_t68 = g_1_2*k_1_1;
    const lane forward_t69 = R_p_1*forward_t68;
    const lane forward_t70 = g_1_2*k_1_2;
    const lane forward_t71 = R_p_1*forward_t70;
    const lane forward_t72 = g_2_2*k_2_1;
    const lane forward_t73 = R_p_2*forward_t72;
    const lane forward_t74 = g_2_2*k_2_2;
    const lane forward_t75 = R_p_2*forward_t74;
    const lane t38 = forward_t64 + forward_t65 + forward_t66 + forward_t67;
    const lane t39 = forward_t37 + forward_t38 + forward_t40 + forward_t41;
    const lane t44 = k_2_1 + k_2_2;
    const lane t47 = k_1_1 + k_1_2;
    const double t71 = 2.0*R_p_2;
    const double t75 = 2.0*R_p_1;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 11;
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
        const lane t9 = 2.0*shape_11;
        const lane t10 = shape_10*t9;
        const lane t11 = shape_2*t9;
        const lane adjoint_forward_t76 = t10 + t11;
        const lane t12 = 2.0*shape_2;
        const lane t13 = shape_4*t12;
        const lane t14 = b*t9;
        const lane t15 = shape_4*t14;
        const lane adjoint_forward_t75 = t13 + t15;
        const lane t16 = shape_8*t12;
        const lane t17 = shape_8*t14;
        const lane t18 = t16 + t17;
        const lane adjoint_forward_t74 = R_p_2*adjoint_forward_t75 + t18;
        const lane adjoint_forward_t72 = R_p_2*adjoint_forward_t75 + t18;
        const lane t19 = shape_3*t12;
        const lane t20 = shape_3*t14;
        const lane adjoint_forward_t71 = t19 + t20;
        const lane t21 = shape_7*t12;
        const lane t22 = shape_7*t14;
        const lane t23 = t21 + t22;
        const lane adjoint_forward_t70 = R_p_1*adjoint_forward_t71 + t23;
        const lane adjoint_forward_t68 = R_p_1*adjoint_forward_t71 + t23;
        const lane t24 = b*t11;
        const lane t25 = (shape_2*shape_2);
        const lane t26 = (shape_11*shape_11);
        const lane t27 = forward_t55*t26;
        const lane t28 = t25 + t27;
        const lane adjoint_forward_t67 = t24 + t28;
        const lane t29 = shape_1*t12;
        const lane t30 = shape_1*t14;
        const lane adjoint_forward_t63 = t29 + t30;
        const lane t31 = 2.0*shape_1;
        const lane t32 = shape_8*t31;
        const lane t33 = shape_4*t31;
        const lane t34 = R_p_2*t33 + t32;
        const lane adjoint_forward_t62 = adjoint_forward_t63*g_2_2 + t34;
        const lane adjoint_forward_t60 = adjoint_forward_t63*g_2_2 + t34;
        const lane t35 = shape_7*t31;
        const lane t36 = shape_3*t31;
        const lane t37 = R_p_1*t36 + t35;
        const lane adjoint_forward_t58 = adjoint_forward_t63*g_1_2 + t37;
        const lane adjoint_forward_t56 = adjoint_forward_t63*g_1_2 + t37;
        const lane t40 = eigenvalue*t26;
        const lane adjoint_forward_t55 = t26*(k_C + t38) - t40*(forward_t20 + t39);
        const lane t41 = (shape_10*shape_10);
        const lane t42 = (shape_9*shape_9);
        const lane adjoint_forward_t54 = -eigenvalue*t41 - eigenvalue*t42;
        const lane t43 = (shape_4*shape_4);
        const lane t45 = eigenvalue*t43;
        const lane adjoint_forward_t53 = t43*t44 - t45*(forward_t18 + forward_t19);
        const lane t46 = (shape_3*shape_3);
        const lane t48 = eigenvalue*t46;
        const lane adjoint_forward_t52 = t46*t47 - t48*(forward_t15 + forward_t16);
        const lane t49 = eigenvalue*t11;
        const lane adjoint_forward_t51 = -eigenvalue*t10 - t49;
        const lane adjoint_forward_t50 = -eigenvalue*t16 - eigenvalue*t17;
        const lane adjoint_forward_t48 = -eigenvalue*t21 - eigenvalue*t22;
        const lane adjoint_forward_t46 = eigenvalue*t13 + eigenvalue*t15;
        const lane adjoint_forward_t44 = eigenvalue*t19 + eigenvalue*t20;
        const lane t50 = eigenvalue*t25;
        const lane t51 = shape_10*t12;
        const lane adjoint_forward_t42 = adjoint_forward_t54 - eigenvalue*t51 - t50;
        const lane t52 = eigenvalue*t27;
        const lane adjoint_forward_t41 = -eigenvalue*t24 - t50 - t52;
        const lane t53 = 2.0*shape_4;
        const lane t54 = shape_8*t53;
        const lane t55 = eigenvalue*g_2_1*t33 + eigenvalue*t54;
        const lane adjoint_forward_t35 = adjoint_forward_t46*g_2_2 + t55;
        const lane adjoint_forward_t34 = adjoint_forward_t46*g_2_2 + t55;
        const lane adjoint_forward_t33 = adjoint_forward_t34*l_f_2_1 + adjoint_forward_t35*l_f_2_2;
        const lane t56 = 2.0*shape_3;
        const lane t57 = shape_7*t56;
        const lane t58 = eigenvalue*g_1_1*t36 + eigenvalue*t57;
        const lane adjoint_forward_t32 = adjoint_forward_t44*g_1_2 + t58;
        const lane adjoint_forward_t31 = adjoint_forward_t44*g_1_2 + t58;
        const lane adjoint_forward_t30 = adjoint_forward_t31*l_f_1_1 + adjoint_forward_t32*l_f_1_2;
        const lane adjoint_forward_t29 = R_p_1*adjoint_forward_t30 + R_p_2*adjoint_forward_t33;
        const lane adjoint_forward_t28 = -eigenvalue*t29 - eigenvalue*t30;
        const lane t59 = -eigenvalue*t32;
        const lane adjoint_forward_t27 = adjoint_forward_t28*g_2_2 + t59;
        const lane adjoint_forward_t25 = adjoint_forward_t28*g_2_2 + t59;
        const lane t60 = -eigenvalue*t35;
        const lane adjoint_forward_t23 = adjoint_forward_t28*g_1_2 + t60;
        const lane adjoint_forward_t21 = adjoint_forward_t28*g_1_2 + t60;
        const lane t61 = (shape_1*shape_1);
        const lane t62 = eigenvalue*t61;
        const lane t63 = shape_9*t31;
        const lane t64 = shape_1*t9;
        const lane adjoint_forward_t20 =
            adjoint_forward_t42 + adjoint_forward_t51*b - eigenvalue*t63 - g_y*t64 - t62;
        const lane t65 = (shape_8*shape_8);
        const lane t66 = forward_t53*t43;
        const lane t67 = -eigenvalue*t65 - eigenvalue*t66 - forward_t17*t62;
        const lane adjoint_forward_t19 =
            adjoint_forward_t27*g_2_1 + adjoint_forward_t41*forward_t39 + adjoint_forward_t50*g_2_2 + t67;
        const lane adjoint_forward_t18 =
            adjoint_forward_t25*g_2_1 + adjoint_forward_t41*forward_t39 + adjoint_forward_t50*g_2_2 + t67;
        const lane t68 = (shape_7*shape_7);
        const lane t69 = forward_t52*t46;
        const lane t70 = -eigenvalue*t68 - eigenvalue*t69 - forward_t13*t62;
        const lane adjoint_forward_t16 =
            adjoint_forward_t23*g_1_1 + adjoint_forward_t41*forward_t36 + adjoint_forward_t48*g_1_2 + t70;
        const lane adjoint_forward_t15 =
            adjoint_forward_t21*g_1_1 + adjoint_forward_t41*forward_t36 + adjoint_forward_t48*g_1_2 + t70;
        const lane adjoint_forward_t14 =
            adjoint_forward_t15*l_f_1_1 + adjoint_forward_t16*l_f_1_2 + adjoint_forward_t18*l_f_2_1
            + adjoint_forward_t19*l_f_2_2;
        const lane t72 = forward_t17*t61 + shape_4*shape_8*t71 + t65 + t66;
        const lane adjoint_k_2_2 =
            adjoint_forward_t62*g_2_1 + adjoint_forward_t67*forward_t39 + adjoint_forward_t74*g_2_2 + t72;
        const lane adjoint_forward_3 = adjoint_k_2_2*forward_t12;
        const lane t73 = adjoint_forward_3/(t8*t8);
        const lane adjoint_l_f_2_2 = adjoint_forward_t19*forward_t14 + adjoint_forward_t35*forward_t33 - t73;
        const lane adjoint_k_2_1 =
            adjoint_forward_t60*g_2_1 + adjoint_forward_t67*forward_t39 + adjoint_forward_t72*g_2_2 + t72;
        const lane adjoint_forward_2 = adjoint_k_2_1*forward_t12;
        const lane adjoint_forward_t12 = adjoint_k_2_1*forward_2 + adjoint_k_2_2*forward_3;
        const lane t74 = adjoint_forward_2/(t7*t7);
        const lane adjoint_forward_t11 = -t73 - t74;
        const lane adjoint_forward_t10 = adjoint_forward_t11*forward_t5 + adjoint_forward_t12*forward_t4;
        const lane adjoint_l_f_2_1 = adjoint_forward_t18*forward_t14 + adjoint_forward_t34*forward_t33 - t74;
        const lane adjoint_forward_t9 = adjoint_l_f_2_1 - adjoint_l_f_2_2;
        const lane t76 = forward_t13*t61 + shape_3*shape_7*t75 + t68 + t69;
        const lane adjoint_k_1_2 =
            adjoint_forward_t58*g_1_1 + adjoint_forward_t67*forward_t36 + adjoint_forward_t70*g_1_2 + t76;
        const lane adjoint_forward_1 = adjoint_k_1_2*forward_t8;
        const lane t77 = adjoint_forward_1/(t4*t4);
        const lane adjoint_l_f_1_2 = adjoint_forward_t16*forward_t14 + adjoint_forward_t32*forward_t30 - t77;
        const lane adjoint_k_1_1 =
            adjoint_forward_t56*g_1_1 + adjoint_forward_t67*forward_t36 + adjoint_forward_t68*g_1_2 + t76;
        const lane adjoint_forward_0 = adjoint_k_1_1*forward_t8;
        const lane adjoint_forward_t8 = adjoint_k_1_1*forward_0 + adjoint_k_1_2*forward_1;
        const lane t78 = adjoint_forward_0/(t3*t3);
        const lane adjoint_forward_t7 = -t77 - t78;
        const lane adjoint_forward_t6 = adjoint_forward_t7*forward_t5 + adjoint_forward_t8*forward_t4;
        const lane adjoint_forward_t5 = adjoint_forward_t11*forward_t10 + adjoint_forward_t7*forward_t6;
        const lane adjoint_forward_t4 =
            adjoint_forward_t12*forward_t10 + adjoint_forward_t5*c_E + adjoint_forward_t8*forward_t6;
        const lane adjoint_l_f_1_1 = adjoint_forward_t15*forward_t14 + adjoint_forward_t31*forward_t30 - t78;
        const lane adjoint_forward_t3 = adjoint_l_f_1_1 - adjoint_l_f_1_2;
        const lane adjoint_I_2 = -t45;
        const lane t79 = (shape_6*shape_6);
        const lane t80 = shape_6*t53;
        const lane adjoint_forward_t2 = adjoint_I_2 - eigenvalue*t79 - eigenvalue*t80;
        const lane adjoint_I_1 = -t48;
        const lane t81 = (shape_5*shape_5);
        const lane t82 = shape_5*t56;
        const lane adjoint_forward_t1 = adjoint_I_1 - eigenvalue*t81 - eigenvalue*t82;
        const lane t83 = shape_3*t9;
        const lane t84 = shape_4*t9;
        const lane t85 = shape_7*t9;
        const lane t86 = shape_8*t9;
        const lane adjoint_b =
            adjoint_forward_t51*forward_t20 + 2.0*adjoint_forward_t55*b + adjoint_forward_t76*k_C
            - eigenvalue*t64*(forward_t22 + forward_t24 + forward_t26 + forward_t28)
            - eigenvalue*t83*(-forward_t43 - forward_t44) - eigenvalue*t84*(-forward_t45 - forward_t46)
            - eigenvalue*t85*(forward_t47 + forward_t48) - eigenvalue*t86*(forward_t49 + forward_t50)
            + t11*t38 - t39*t49 + t64*(forward_t57 + forward_t59 + forward_t61 + forward_t63)
            + t83*(forward_t69 + forward_t71) + t84*(forward_t73 + forward_t75) + t85*(forward_t68
            + forward_t70) + t86*(forward_t72 + forward_t74);
        const lane t87 = adjoint_forward_t20 - t52;
        const lane t88 = adjoint_forward_t6*k_sp_1;
        const lane t89 = adjoint_forward_t10*k_sp_2;
        lanes_clear(gradient, 54);
        gradient[0] = LANES(t87);
        gradient[1] = LANES(adjoint_forward_t42);
        gradient[3] = LANES(-forward_t20*t64);
        gradient[9] = LANES(adjoint_l_f_1_1);
        gradient[10] = LANES(adjoint_l_f_1_2);
        gradient[11] = LANES(adjoint_l_f_2_1);
        gradient[12] = LANES(adjoint_l_f_2_2);
        gradient[13] = LANES(adjoint_forward_t6*t2);
        gradient[14] = LANES(adjoint_forward_t10*t6);
        gradient[15] = LANES(t1*t88);
        gradient[16] = LANES(t5*t89);
        gradient[17] =
            LANES(adjoint_forward_t30*forward_t29 + adjoint_forward_t52*t75 + adjoint_forward_t71*forward_t68
            + adjoint_forward_t71*forward_t70 + t36*(forward_t56 + forward_t58) + t47*t57);
        gradient[18] =
            LANES(adjoint_forward_t33*forward_t29 + adjoint_forward_t53*t71 + adjoint_forward_t75*forward_t72
            + adjoint_forward_t75*forward_t74 + t33*(forward_t60 + forward_t62) + t44*t54);
        gradient[19] = LANES(adjoint_I_1);
        gradient[20] = LANES(adjoint_I_2);
        gradient[21] = LANES(adjoint_forward_t1*(i_g_1*i_g_1));
        gradient[22] = LANES(adjoint_forward_t2*(i_g_2*i_g_2));
        gradient[23] = LANES(2.0*I_m_1*adjoint_forward_t1*i_g_1);
        gradient[24] = LANES(2.0*I_m_2*adjoint_forward_t2*i_g_2);
        gradient[29] = LANES(t88*w_b_1);
        gradient[30] = LANES(t89*w_b_2);
        gradient[31] = LANES(adjoint_forward_t5*forward_t4);
        gradient[33] = LANES((1.0/3.0)*adjoint_forward_t14 + (1.0/6.0)*adjoint_forward_t29);
        gradient[34] = LANES(F_T*adjoint_forward_t4);
        gradient[35] = LANES(adjoint_forward_t4*c_T);
        gradient[36] = LANES(adjoint_forward_t76*b + t28 + t41 + t42 + t51 + t61 + t63);
        gradient[38] = LANES(adjoint_I_1 + adjoint_I_2);
        gradient[39] = LANES(t87);
        gradient[42] = LANES(t43 + t46 + t79 + t80 + t81 + t82);
        gradient[46] = LANES(adjoint_forward_t54);
        gradient[50] = LANES(-t40);
        gradient[51] = LANES(-adjoint_b);
        gradient[52] = LANES(adjoint_b + adjoint_forward_t3*g_1_1 + adjoint_forward_t9*g_2_1);
        gradient[53] = LANES(adjoint_forward_t3*g_1_2 + adjoint_forward_t9*g_2_2);
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
 * 527 operations; 14628 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_tangent(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int count,
    const struct lanes_paths *paths)
{
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double m_h = parameters[0];
    const double g_y = parameters[3];
    const double g_1_1 = parameters[5];
    const double g_1_2 = parameters[6];
    const double g_2_1 = parameters[7];
    const double g_2_2 = parameters[8];
    const double l_0_1_1 = parameters[9];
    const double l_0_1_2 = parameters[10];
    const double l_0_2_1 = parameters[11];
    const double l_0_2_2 = parameters[12];
    const double k_sp_1 = parameters[13];
    const double k_sp_2 = parameters[14];
    const double w_b_1 = parameters[15];
    const double w_b_2 = parameters[16];
    const double R_p_1 = parameters[17];
    const double R_p_2 = parameters[18];
    const double I_m_1 = parameters[21];
    const double I_m_2 = parameters[22];
    const double i_g_1 = parameters[23];
    const double i_g_2 = parameters[24];
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double c_E = effects[2];
    const double rho_b = effects[4];
    const double c_T = effects[5];
    const double F_T = effects[6];
    const double k_C = effects[7];
    const double m_L = effects[10];
    const double x_B = effects[22];
    const lane b = x - x_B;
    const lane forward_t3 = g_1_1*x + g_1_2*y;
    const lane l_f_1_1 = forward_t3 + l_0_1_1;
    const double forward_t4 = F_T*c_T + 1.0;
    const double forward_t5 = c_E*forward_t4;
    const double t1 = a_B_1 + 1.0;
    const double t2 = t1*w_b_1;
    const double forward_t6 = k_sp_1*t2;
    const double forward_t7 = forward_t5*forward_t6;
    const double forward_t8 = forward_t4*forward_t6;
    const lane t3 = forward_t7 + l_f_1_1;
    const lane forward_0 = 1.0/t3;
    const lane k_1_1 = forward_0*forward_t8;
    const lane l_f_1_2 = -forward_t3 + l_0_1_2;
    const lane t4 = forward_t7 + l_f_1_2;
    const lane forward_1 = 1.0/t4;
    const lane k_1_2 = forward_1*forward_t8;
    const lane forward_t9 = g_2_1*x + g_2_2*y;
    const lane l_f_2_1 = forward_t9 + l_0_2_1;
    const double t5 = a_B_2 + 1.0;
    const double t6 = t5*w_b_2;
    const double forward_t10 = k_sp_2*t6;
    const double forward_t11 = forward_t10*forward_t5;
    const double forward_t12 = forward_t10*forward_t4;
    const lane t7 = forward_t11 + l_f_2_1;
    const lane forward_2 = 1.0/t7;
    const lane k_2_1 = forward_2*forward_t12;
    const lane l_f_2_2 = -forward_t9 + l_0_2_2;
    const lane t8 = forward_t11 + l_f_2_2;
    const lane forward_3 = 1.0/t8;
    const lane k_2_2 = forward_3*forward_t12;
    const double forward_t13 = (g_1_1*g_1_1);
    const double forward_t14 = (1.0/3.0)*rho_b;
    const lane forward_t15 = forward_t14*l_f_1_1;
    const lane forward_t16 = forward_t14*l_f_1_2;
    const double forward_t17 = (g_2_1*g_2_1);
    const lane forward_t18 = forward_t14*l_f_2_1;
    const lane forward_t19 = forward_t14*l_f_2_2;
    const double forward_t20 = m_L + m_h;
    const lane forward_t21 = forward_t15*g_1_1;
    const lane forward_t22 = forward_t21*g_1_2;
    const lane forward_t23 = forward_t16*g_1_1;
    const lane forward_t24 = forward_t23*g_1_2;
    const lane forward_t25 = forward_t18*g_2_1;
    const lane forward_t26 = forward_t25*g_2_2;
    const lane forward_t27 = forward_t19*g_2_1;
    const lane forward_t28 = forward_t27*g_2_2;
    const double forward_t29 = (1.0/6.0)*rho_b;
    const double forward_t30 = R_p_1*forward_t29;
    const lane forward_t31 = forward_t30*l_f_1_1;
    const lane forward_t32 = forward_t30*l_f_1_2;
    const double forward_t33 = R_p_2*forward_t29;
    const lane forward_t34 = forward_t33*l_f_2_1;
    const lane forward_t35 = forward_t33*l_f_2_2;
    const double forward_t36 = (g_1_2*g_1_2);
    const lane forward_t37 = forward_t15*forward_t36;
    const lane forward_t38 = forward_t16*forward_t36;
    const double forward_t39 = (g_2_2*g_2_2);
    const lane forward_t40 = forward_t18*forward_t39;
    const lane forward_t41 = forward_t19*forward_t39;
    const lane forward_t43 = forward_t31*g_1_2;
    const lane forward_t44 = forward_t32*g_1_2;
    const lane forward_t45 = forward_t34*g_2_2;
    const lane forward_t46 = forward_t35*g_2_2;
    const lane forward_t47 = forward_t15*g_1_2;
    const lane forward_t48 = forward_t16*g_1_2;
    const lane forward_t49 = forward_t18*g_2_2;
    const lane forward_t50 = forward_t19*g_2_2;
    const double forward_t52 = (R_p_1*R_p_1);
    const double forward_t53 = (R_p_2*R_p_2);
    const lane forward_t55 = (b*b);
    const lane forward_t56 = g_1_1*k_1_1;
    const lane forward_t57 = forward_t56*g_1_2;
    const lane forward_t58 = g_1_1*k_1_2;
    const lane forward_t59 = forward_t58*g_1_2;
    const lane forward_t60 = g_2_1*k_2_1;
    const lane forward_t61 = forward_t60*g_2_2;
    const lane forward_t62 = g_2_1*k_2_2;
    const lane forward_t63 = forward_t62*g_2_2;
    const lane forward_t64 = forward_t36*k_1_1;
    const lane forward_t65 = forward_t36*k_1_2;
    const lane forward_t66 = forward_t39*k_2_1;
    const lane forward_t67 = forward_t39*k_2_2;
    const lane forward_t68 = g_1_2*k_1_1;
    const lane forward_t69 = R_p_1*forward_t68;
    const lane forward_t70 = g_1_2*k_1_2;
    const lane forward_t71 = R_p_1*forward_t70;
    const lane forward_t72 = g_2_2*k_2_1;
    const lane forward_t73 = R_p_2*forward_t72;
    const lane forward_t74 = g_2_2*k_2_2;
    const lane forward_t75 = R_p_2*forward_t74;
    const lane t9 = 1.0/((t3*t3));
    const lane t10 = 1.0/((t4*t4));
    const lane t11 = 1.0/((t7*t7));
    const lane t12 = 1.0/((t8*t8));
    const lane t13 = forward_t37 + forward_t38 + forward_t40 + forward_t41;
    const lane t14 = forward_t64 + forward_t65 + forward_t66 + forward_t67;
    const lane t15 = k_1_1 + k_1_2;
    const lane t16 = k_2_1 + k_2_2;
    for (int path = 0; path < count; path++) {
        lane direction[LANES_GRADIENT], motion_rate[LANES_DIRECTIONS * LANES_ALL];
        lane mass_rate[LANES_ALL * LANES_ALL], stiffness_rate[LANES_ALL * LANES_ALL];
        lanes_direction(paths, path, direction);
        const lane along_1 = direction[0];
        const lane along_2 = direction[1];
        const lane along_4 = direction[3];
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
        const lane along_30 = direction[29];
        const lane along_31 = direction[30];
        const lane along_32 = direction[31];
        const lane along_34 = direction[33];
        const lane along_35 = direction[34];
        const lane along_36 = direction[35];
        const lane along_37 = direction[36];
        const lane along_39 = direction[38];
        const lane along_40 = direction[39];
        const lane along_43 = direction[42];
        const lane along_47 = direction[46];
        const lane along_51 = direction[50];
        const lane along_52 = direction[51];
        const lane along_53 = direction[52];
        const lane along_54 = direction[53];
        const lane tangent_b = -along_52 + along_53;
        const lane tangent_forward_t1 = 2.0*I_m_1*along_24*i_g_1 + along_22*(i_g_1*i_g_1);
        const lane tangent_I_1 = along_20 + along_39 + tangent_forward_t1;
        const lane tangent_forward_t2 = 2.0*I_m_2*along_25*i_g_2 + along_23*(i_g_2*i_g_2);
        const lane tangent_I_2 = along_21 + along_39 + tangent_forward_t2;
        const lane tangent_forward_t3 = along_53*g_1_1 + along_54*g_1_2;
        const lane tangent_l_f_1_1 = along_10 + tangent_forward_t3;
        const lane tangent_forward_t4 = F_T*along_35 + along_36*c_T;
        const lane tangent_forward_t5 = along_32*forward_t4 + c_E*tangent_forward_t4;
        const lane tangent_forward_t6 = along_14*t2 + along_16*k_sp_1*t1 + along_30*k_sp_1*w_b_1;
        const lane tangent_forward_t7 = forward_t5*tangent_forward_t6 + forward_t6*tangent_forward_t5;
        const lane tangent_forward_t8 = forward_t4*tangent_forward_t6 + forward_t6*tangent_forward_t4;
        const lane tangent_forward_0 = -t9*tangent_forward_t7 - t9*tangent_l_f_1_1;
        const lane tangent_k_1_1 = forward_0*tangent_forward_t8 + forward_t8*tangent_forward_0;
        const lane tangent_l_f_1_2 = along_11 - tangent_forward_t3;
        const lane tangent_forward_1 = -t10*tangent_forward_t7 - t10*tangent_l_f_1_2;
        const lane tangent_k_1_2 = forward_1*tangent_forward_t8 + forward_t8*tangent_forward_1;
        const lane tangent_forward_t9 = along_53*g_2_1 + along_54*g_2_2;
        const lane tangent_l_f_2_1 = along_12 + tangent_forward_t9;
        const lane tangent_forward_t10 = along_15*t6 + along_17*k_sp_2*t5 + along_31*k_sp_2*w_b_2;
        const lane tangent_forward_t11 = forward_t10*tangent_forward_t5 + forward_t5*tangent_forward_t10;
        const lane tangent_forward_t12 = forward_t10*tangent_forward_t4 + forward_t4*tangent_forward_t10;
        const lane tangent_forward_2 = -t11*tangent_forward_t11 - t11*tangent_l_f_2_1;
        const lane tangent_k_2_1 = forward_2*tangent_forward_t12 + forward_t12*tangent_forward_2;
        const lane tangent_l_f_2_2 = along_13 - tangent_forward_t9;
        const lane tangent_forward_3 = -t12*tangent_forward_t11 - t12*tangent_l_f_2_2;
        const lane tangent_k_2_2 = forward_3*tangent_forward_t12 + forward_t12*tangent_forward_3;
        const lane tangent_forward_t14 = (1.0/3.0)*along_34;
        const lane tangent_forward_t15 = forward_t14*tangent_l_f_1_1 + l_f_1_1*tangent_forward_t14;
        const lane tangent_forward_t16 = forward_t14*tangent_l_f_1_2 + l_f_1_2*tangent_forward_t14;
        const lane tangent_forward_t18 = forward_t14*tangent_l_f_2_1 + l_f_2_1*tangent_forward_t14;
        const lane tangent_forward_t19 = forward_t14*tangent_l_f_2_2 + l_f_2_2*tangent_forward_t14;
        const lane tangent_forward_t20 = along_1 + along_40;
        const lane tangent_forward_t21 = g_1_1*tangent_forward_t15;
        const lane tangent_forward_t22 = g_1_2*tangent_forward_t21;
        const lane tangent_forward_t23 = g_1_1*tangent_forward_t16;
        const lane tangent_forward_t24 = g_1_2*tangent_forward_t23;
        const lane tangent_forward_t25 = g_2_1*tangent_forward_t18;
        const lane tangent_forward_t26 = g_2_2*tangent_forward_t25;
        const lane tangent_forward_t27 = g_2_1*tangent_forward_t19;
        const lane tangent_forward_t28 = g_2_2*tangent_forward_t27;
        const lane tangent_forward_t29 = (1.0/6.0)*along_34;
        const lane tangent_forward_t30 = R_p_1*tangent_forward_t29 + along_18*forward_t29;
        const lane tangent_forward_t31 = forward_t30*tangent_l_f_1_1 + l_f_1_1*tangent_forward_t30;
        const lane tangent_forward_t32 = forward_t30*tangent_l_f_1_2 + l_f_1_2*tangent_forward_t30;
        const lane tangent_forward_t33 = R_p_2*tangent_forward_t29 + along_19*forward_t29;
        const lane tangent_forward_t34 = forward_t33*tangent_l_f_2_1 + l_f_2_1*tangent_forward_t33;
        const lane tangent_forward_t35 = forward_t33*tangent_l_f_2_2 + l_f_2_2*tangent_forward_t33;
        const lane tangent_forward_t37 = forward_t36*tangent_forward_t15;
        const lane tangent_forward_t38 = forward_t36*tangent_forward_t16;
        const lane tangent_forward_t40 = forward_t39*tangent_forward_t18;
        const lane tangent_forward_t41 = forward_t39*tangent_forward_t19;
        const lane tangent_forward_t42 = along_2 + tangent_forward_t20;
        const lane tangent_forward_t43 = g_1_2*tangent_forward_t31;
        const lane tangent_forward_t44 = g_1_2*tangent_forward_t32;
        const lane tangent_forward_t45 = g_2_2*tangent_forward_t34;
        const lane tangent_forward_t46 = g_2_2*tangent_forward_t35;
        const lane tangent_forward_t47 = g_1_2*tangent_forward_t15;
        const lane tangent_forward_t48 = g_1_2*tangent_forward_t16;
        const lane tangent_forward_t49 = g_2_2*tangent_forward_t18;
        const lane tangent_forward_t50 = g_2_2*tangent_forward_t19;
        const lane tangent_forward_t51 = b*tangent_forward_t20 + forward_t20*tangent_b;
        const lane tangent_forward_t52 = 2.0*R_p_1*along_18;
        const lane tangent_forward_t53 = 2.0*R_p_2*along_19;
        const lane tangent_forward_t54 = along_47 + tangent_forward_t42;
        const lane tangent_forward_t55 = 2.0*b*tangent_b;
        const lane tangent_forward_t56 = g_1_1*tangent_k_1_1;
        const lane tangent_forward_t57 = g_1_2*tangent_forward_t56;
        const lane tangent_forward_t58 = g_1_1*tangent_k_1_2;
        const lane tangent_forward_t59 = g_1_2*tangent_forward_t58;
        const lane tangent_forward_t60 = g_2_1*tangent_k_2_1;
        const lane tangent_forward_t61 = g_2_2*tangent_forward_t60;
        const lane tangent_forward_t62 = g_2_1*tangent_k_2_2;
        const lane tangent_forward_t63 = g_2_2*tangent_forward_t62;
        const lane tangent_forward_t64 = forward_t36*tangent_k_1_1;
        const lane tangent_forward_t65 = forward_t36*tangent_k_1_2;
        const lane tangent_forward_t66 = forward_t39*tangent_k_2_1;
        const lane tangent_forward_t67 = forward_t39*tangent_k_2_2;
        const lane tangent_forward_t68 = g_1_2*tangent_k_1_1;
        const lane tangent_forward_t69 = R_p_1*tangent_forward_t68 + along_18*forward_t68;
        const lane tangent_forward_t70 = g_1_2*tangent_k_1_2;
        const lane tangent_forward_t71 = R_p_1*tangent_forward_t70 + along_18*forward_t70;
        const lane tangent_forward_t72 = g_2_2*tangent_k_2_1;
        const lane tangent_forward_t73 = R_p_2*tangent_forward_t72 + along_19*forward_t72;
        const lane tangent_forward_t74 = g_2_2*tangent_k_2_2;
        const lane tangent_forward_t75 = R_p_2*tangent_forward_t74 + along_19*forward_t74;
        const lane tangent_forward_t76 = along_37*b + k_C*tangent_b;
        lanes_clear(mass_rate, 121);
        mass_rate[0] =
            LANES(forward_t13*tangent_forward_t15 + forward_t13*tangent_forward_t16
            + forward_t17*tangent_forward_t18 + forward_t17*tangent_forward_t19 + tangent_forward_t20);
        mass_rate[1] = mass_rate[11] =
            LANES(tangent_forward_t22 + tangent_forward_t24 + tangent_forward_t26 + tangent_forward_t28);
        mass_rate[2] = mass_rate[22] = LANES(-g_1_1*tangent_forward_t31 - g_1_1*tangent_forward_t32);
        mass_rate[3] = mass_rate[33] = LANES(-g_2_1*tangent_forward_t34 - g_2_1*tangent_forward_t35);
        mass_rate[6] = mass_rate[66] = LANES(tangent_forward_t21 + tangent_forward_t23);
        mass_rate[7] = mass_rate[77] = LANES(tangent_forward_t25 + tangent_forward_t27);
        mass_rate[8] = mass_rate[88] = LANES(tangent_forward_t20);
        mass_rate[10] = mass_rate[110] =
            LANES(b*tangent_forward_t22 + b*tangent_forward_t24 + b*tangent_forward_t26
            + b*tangent_forward_t28 + tangent_b*(forward_t22 + forward_t24 + forward_t26 + forward_t28));
        mass_rate[12] =
            LANES(tangent_forward_t37 + tangent_forward_t38 + tangent_forward_t40 + tangent_forward_t41
            + tangent_forward_t42);
        mass_rate[13] = mass_rate[23] = LANES(-tangent_forward_t43 - tangent_forward_t44);
        mass_rate[14] = mass_rate[34] = LANES(-tangent_forward_t45 - tangent_forward_t46);
        mass_rate[17] = mass_rate[67] = LANES(tangent_forward_t47 + tangent_forward_t48);
        mass_rate[18] = mass_rate[78] = LANES(tangent_forward_t49 + tangent_forward_t50);
        mass_rate[20] = mass_rate[100] = LANES(tangent_forward_t42);
        mass_rate[21] = mass_rate[111] =
            LANES(b*tangent_forward_t37 + b*tangent_forward_t38 + b*tangent_forward_t40
            + b*tangent_forward_t41 + t13*tangent_b + tangent_forward_t51);
        mass_rate[24] =
            LANES(forward_t52*tangent_forward_t15 + forward_t52*tangent_forward_t16 + tangent_I_1
            + tangent_forward_t52*(forward_t15 + forward_t16));
        mass_rate[26] = mass_rate[46] = LANES(tangent_forward_t1);
        mass_rate[28] = mass_rate[68] = LANES(-tangent_forward_t31 - tangent_forward_t32);
        mass_rate[32] = mass_rate[112] =
            LANES(-b*tangent_forward_t43 - b*tangent_forward_t44 + tangent_b*(-forward_t43 - forward_t44));
        mass_rate[36] =
            LANES(forward_t53*tangent_forward_t18 + forward_t53*tangent_forward_t19 + tangent_I_2
            + tangent_forward_t53*(forward_t18 + forward_t19));
        mass_rate[38] = mass_rate[58] = LANES(tangent_forward_t2);
        mass_rate[40] = mass_rate[80] = LANES(-tangent_forward_t34 - tangent_forward_t35);
        mass_rate[43] = mass_rate[113] =
            LANES(-b*tangent_forward_t45 - b*tangent_forward_t46 + tangent_b*(-forward_t45 - forward_t46));
        mass_rate[48] = LANES(tangent_forward_t1);
        mass_rate[60] = LANES(tangent_forward_t2);
        mass_rate[72] = LANES(tangent_forward_t15 + tangent_forward_t16);
        mass_rate[76] = mass_rate[116] =
            LANES(b*tangent_forward_t47 + b*tangent_forward_t48 + tangent_b*(forward_t47 + forward_t48));
        mass_rate[84] = LANES(tangent_forward_t18 + tangent_forward_t19);
        mass_rate[87] = mass_rate[117] =
            LANES(b*tangent_forward_t49 + b*tangent_forward_t50 + tangent_b*(forward_t49 + forward_t50));
        mass_rate[96] = LANES(tangent_forward_t54);
        mass_rate[108] = LANES(tangent_forward_t54);
        mass_rate[109] = mass_rate[119] = LANES(tangent_forward_t51);
        mass_rate[120] =
            LANES(along_1*forward_t55 + along_40*forward_t55 + along_51 + forward_t55*tangent_forward_t37
            + forward_t55*tangent_forward_t38 + forward_t55*tangent_forward_t40
            + forward_t55*tangent_forward_t41 + tangent_forward_t55*(forward_t20 + t13));
        lanes_clear(stiffness_rate, 121);
        stiffness_rate[0] =
            LANES(along_37 + forward_t13*tangent_k_1_1 + forward_t13*tangent_k_1_2
            + forward_t17*tangent_k_2_1 + forward_t17*tangent_k_2_2);
        stiffness_rate[1] = stiffness_rate[11] =
            LANES(tangent_forward_t57 + tangent_forward_t59 + tangent_forward_t61 + tangent_forward_t63);
        stiffness_rate[2] = stiffness_rate[22] =
            LANES(R_p_1*tangent_forward_t56 + R_p_1*tangent_forward_t58 + along_18*(forward_t56
            + forward_t58));
        stiffness_rate[3] = stiffness_rate[33] =
            LANES(R_p_2*tangent_forward_t60 + R_p_2*tangent_forward_t62 + along_19*(forward_t60
            + forward_t62));
        stiffness_rate[6] = stiffness_rate[66] = LANES(tangent_forward_t56 + tangent_forward_t58);
        stiffness_rate[7] = stiffness_rate[77] = LANES(tangent_forward_t60 + tangent_forward_t62);
        stiffness_rate[8] = stiffness_rate[88] = LANES(along_37);
        stiffness_rate[10] = stiffness_rate[110] =
            LANES(-along_4*forward_t20 + b*tangent_forward_t57 + b*tangent_forward_t59
            + b*tangent_forward_t61 + b*tangent_forward_t63 - g_y*tangent_forward_t20
            + tangent_b*(forward_t57 + forward_t59 + forward_t61 + forward_t63));
        stiffness_rate[12] =
            LANES(along_37 + tangent_forward_t64 + tangent_forward_t65 + tangent_forward_t66
            + tangent_forward_t67);
        stiffness_rate[13] = stiffness_rate[23] = LANES(tangent_forward_t69 + tangent_forward_t71);
        stiffness_rate[14] = stiffness_rate[34] = LANES(tangent_forward_t73 + tangent_forward_t75);
        stiffness_rate[17] = stiffness_rate[67] = LANES(tangent_forward_t68 + tangent_forward_t70);
        stiffness_rate[18] = stiffness_rate[78] = LANES(tangent_forward_t72 + tangent_forward_t74);
        stiffness_rate[20] = stiffness_rate[100] = LANES(along_37);
        stiffness_rate[21] = stiffness_rate[111] =
            LANES(b*tangent_forward_t64 + b*tangent_forward_t65 + b*tangent_forward_t66
            + b*tangent_forward_t67 + t14*tangent_b + tangent_forward_t76);
        stiffness_rate[24] =
            LANES(along_43 + forward_t52*tangent_k_1_1 + forward_t52*tangent_k_1_2 + t15*tangent_forward_t52);
        stiffness_rate[26] = stiffness_rate[46] = LANES(along_43);
        stiffness_rate[28] = stiffness_rate[68] =
            LANES(R_p_1*tangent_k_1_1 + R_p_1*tangent_k_1_2 + along_18*t15);
        stiffness_rate[32] = stiffness_rate[112] =
            LANES(b*tangent_forward_t69 + b*tangent_forward_t71 + tangent_b*(forward_t69 + forward_t71));
        stiffness_rate[36] =
            LANES(along_43 + forward_t53*tangent_k_2_1 + forward_t53*tangent_k_2_2 + t16*tangent_forward_t53);
        stiffness_rate[38] = stiffness_rate[58] = LANES(along_43);
        stiffness_rate[40] = stiffness_rate[80] =
            LANES(R_p_2*tangent_k_2_1 + R_p_2*tangent_k_2_2 + along_19*t16);
        stiffness_rate[43] = stiffness_rate[113] =
            LANES(b*tangent_forward_t73 + b*tangent_forward_t75 + tangent_b*(forward_t73 + forward_t75));
        stiffness_rate[48] = LANES(along_43);
        stiffness_rate[60] = LANES(along_43);
        stiffness_rate[72] = LANES(tangent_k_1_1 + tangent_k_1_2);
        stiffness_rate[76] = stiffness_rate[116] =
            LANES(b*tangent_forward_t68 + b*tangent_forward_t70 + tangent_b*(forward_t68 + forward_t70));
        stiffness_rate[84] = LANES(tangent_k_2_1 + tangent_k_2_2);
        stiffness_rate[87] = stiffness_rate[117] =
            LANES(b*tangent_forward_t72 + b*tangent_forward_t74 + tangent_b*(forward_t72 + forward_t74));
        stiffness_rate[96] = LANES(along_37);
        stiffness_rate[108] = LANES(along_37);
        stiffness_rate[109] = stiffness_rate[119] = LANES(tangent_forward_t76);
        stiffness_rate[120] =
            LANES(along_37*forward_t55 + forward_t55*tangent_forward_t64 + forward_t55*tangent_forward_t65
            + forward_t55*tangent_forward_t66 + forward_t55*tangent_forward_t67 + tangent_forward_t55*(k_C
            + t14));
        lanes_clear(motion_rate, 22);
        motion_rate[21] = LANES(tangent_b);
        lanes_take(paths, path, mass_rate, stiffness_rate, motion_rate);
    }
}
