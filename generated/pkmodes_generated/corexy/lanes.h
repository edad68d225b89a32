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
 *   I_j [kg m^2]: moment of inertia of motor pulley j, including the motor
 *   l_f_j_s [m]: free length of run s of belt j
 *   k_j_s [N/m]: stiffness of run s of belt j
 */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "-ffast-math, -Ofast and -ffinite-math-only hide NaN, the mark of bad poses: compile without them"
#endif

#define LANES_POSE 2
#define LANES_INDEPENDENT 2
#define LANES_DIRECTIONS 2
#define LANES_BASE 4
#define LANES_ALL 10
#define LANES_GRADIENT 49
#define LANES_MARGINS 4

/* How many numbers each margin of a pose has, and how they must compare. */
static const struct lanes_rule LANES_RULES[] = {
    {4, LANES_AT_LEAST_ZERO},
};

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
 * 188 operations; 1919 with every named value expanded.
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
    const lane t22 = g_1_1*t16;
    const lane t23 = g_2_1*t18;
    const lane t24 = g_2_1*t19;
    const double t25 = (1.0/6.0)*rho_b;
    const double t26 = R_p_1*t25;
    const lane t27 = l_f_1_1*t26;
    const lane t28 = l_f_1_2*t26;
    const double t29 = R_p_2*t25;
    const lane t30 = l_f_2_1*t29;
    const lane t31 = l_f_2_2*t29;
    const double t32 = (g_1_2*g_1_2);
    const double t33 = (g_2_2*g_2_2);
    const double t34 = m_g + t20;
    const double t35 = (R_p_1*R_p_1);
    const double t36 = (R_p_2*R_p_2);
    const double t37 = m_F + t34;
    const lane t38 = g_1_1*k_1_1;
    const lane t39 = g_1_1*k_1_2;
    const lane t40 = g_2_1*k_2_1;
    const lane t41 = g_2_1*k_2_2;
    const lane t42 = g_1_2*k_1_1;
    const lane t43 = g_1_2*k_1_2;
    const lane t44 = g_2_2*k_2_1;
    const lane t45 = g_2_2*k_2_2;
    lanes_clear(M, 100);
    M[0] = LANES(t13*t15 + t13*t16 + t17*t18 + t17*t19 + t20);
    M[1] = M[10] = LANES(g_1_2*t21 + g_1_2*t22 + g_2_2*t23 + g_2_2*t24);
    M[2] = M[20] = LANES(-g_1_1*t27 - g_1_1*t28);
    M[3] = M[30] = LANES(-g_2_1*t30 - g_2_1*t31);
    M[6] = M[60] = LANES(t21 + t22);
    M[7] = M[70] = LANES(t23 + t24);
    M[8] = M[80] = LANES(t20);
    M[11] = LANES(t15*t32 + t16*t32 + t18*t33 + t19*t33 + t34);
    M[12] = M[21] = LANES(-g_1_2*t27 - g_1_2*t28);
    M[13] = M[31] = LANES(-g_2_2*t30 - g_2_2*t31);
    M[16] = M[61] = LANES(g_1_2*t15 + g_1_2*t16);
    M[17] = M[71] = LANES(g_2_2*t18 + g_2_2*t19);
    M[19] = M[91] = LANES(t34);
    M[22] = LANES(I_1 + t15*t35 + t16*t35);
    M[24] = M[42] = LANES(t1);
    M[26] = M[62] = LANES(-t27 - t28);
    M[33] = LANES(I_2 + t18*t36 + t19*t36);
    M[35] = M[53] = LANES(t2);
    M[37] = M[73] = LANES(-t30 - t31);
    M[44] = LANES(t1);
    M[55] = LANES(t2);
    M[66] = LANES(t15 + t16);
    M[77] = LANES(t18 + t19);
    M[88] = LANES(t37);
    M[99] = LANES(t37);
    lanes_clear(K, 100);
    K[0] = LANES(k_1_1*t13 + k_1_2*t13 + k_2_1*t17 + k_2_2*t17 + k_C);
    K[1] = K[10] = LANES(g_1_2*t38 + g_1_2*t39 + g_2_2*t40 + g_2_2*t41);
    K[2] = K[20] = LANES(R_p_1*t38 + R_p_1*t39);
    K[3] = K[30] = LANES(R_p_2*t40 + R_p_2*t41);
    K[6] = K[60] = LANES(t38 + t39);
    K[7] = K[70] = LANES(t40 + t41);
    K[8] = K[80] = LANES(k_C);
    K[11] = LANES(k_1_1*t32 + k_1_2*t32 + k_2_1*t33 + k_2_2*t33 + k_C);
    K[12] = K[21] = LANES(R_p_1*t42 + R_p_1*t43);
    K[13] = K[31] = LANES(R_p_2*t44 + R_p_2*t45);
    K[16] = K[61] = LANES(t42 + t43);
    K[17] = K[71] = LANES(t44 + t45);
    K[19] = K[91] = LANES(k_C);
    K[22] = LANES(k_1_1*t35 + k_1_2*t35 + k_S);
    K[24] = K[42] = LANES(k_S);
    K[26] = K[62] = LANES(R_p_1*k_1_1 + R_p_1*k_1_2);
    K[33] = LANES(k_2_1*t36 + k_2_2*t36 + k_S);
    K[35] = K[53] = LANES(k_S);
    K[37] = K[73] = LANES(R_p_2*k_2_1 + R_p_2*k_2_2);
    K[44] = LANES(k_S);
    K[55] = LANES(k_S);
    K[66] = LANES(k_1_1 + k_1_2);
    K[77] = LANES(k_2_1 + k_2_2);
    K[88] = LANES(k_C);
    K[99] = LANES(k_C);
    lanes_clear(J_p, 20);
    J_p[0] = LANES(1.0);
    J_p[8] = LANES(1.0);
    J_p[11] = LANES(1.0);
    J_p[19] = LANES(1.0);
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
        lanes_clear(gradient, 49);
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
        gradient[47] = LANES(adjoint_forward_t1*g_1_1 + adjoint_forward_t3*g_2_1);
        gradient[48] = LANES(adjoint_forward_t1*g_1_2 + adjoint_forward_t3*g_2_2);
    }
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through extended.
 * 351 operations; 4771 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_gradient(const lane *restrict pose,
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
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double c_E = effects[2];
    const double rho_b = effects[4];
    const double c_T = effects[5];
    const double F_T = effects[6];
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
    const double forward_t25 = (1.0/6.0)*rho_b;
    const double forward_t26 = R_p_1*forward_t25;
    const double forward_t29 = R_p_2*forward_t25;
    const double forward_t32 = (g_1_2*g_1_2);
    const double forward_t33 = (g_2_2*g_2_2);
    const double forward_t35 = (R_p_1*R_p_1);
    const double forward_t36 = (R_p_2*R_p_2);
    const lane forward_t38 = g_1_1*k_1_1;
    const lane forward_t39 = g_1_1*k_1_2;
    const lane forward_t40 = g_2_1*k_2_1;
    const lane forward_t41 = g_2_1*k_2_2;
    const lane forward_t42 = g_1_2*k_1_1;
    const lane forward_t43 = g_1_2*k_1_2;
    const lane forward_t44 = g_2_2*k_2_1;
    const lane forward_t45 = g_2_2*k_2_2;
    const lane t23 = k_2_1 + k_2_2;
    const lane t26 = k_1_1 + k_1_2;
    const double t50 = 2.0*R_p_2;
    const double t54 = 2.0*R_p_1;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 10;
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
        const lane t9 = R_p_2*shape_4;
        const lane t10 = 2.0*shape_2;
        const lane t11 = shape_8*t10;
        const lane adjoint_forward_t45 = t10*t9 + t11;
        const lane t12 = shape_7*t10;
        const lane t13 = R_p_1*shape_3;
        const lane adjoint_forward_t43 = t10*t13 + t12;
        const lane t14 = 2.0*shape_1;
        const lane t15 = shape_8*t14;
        const lane t16 = shape_1*t10;
        const lane t17 = g_2_2*t16;
        const lane adjoint_forward_t41 = t14*t9 + t15 + t17;
        const lane t18 = shape_7*t14;
        const lane t19 = g_1_2*t16;
        const lane adjoint_forward_t39 = t13*t14 + t18 + t19;
        const lane t20 = (shape_10*shape_10);
        const lane t21 = (shape_9*shape_9);
        const lane adjoint_forward_t37 = -eigenvalue*t20 - eigenvalue*t21;
        const lane t22 = (shape_4*shape_4);
        const lane t24 = eigenvalue*t22;
        const lane adjoint_forward_t36 = t22*t23 - t24*(forward_t18 + forward_t19);
        const lane t25 = (shape_3*shape_3);
        const lane t27 = eigenvalue*t25;
        const lane adjoint_forward_t35 = t25*t26 - t27*(forward_t15 + forward_t16);
        const lane t28 = (shape_2*shape_2);
        const lane t29 = eigenvalue*t28;
        const lane t30 = shape_10*t10;
        const lane adjoint_forward_t34 = adjoint_forward_t37 - eigenvalue*t30 - t29;
        const lane t31 = 2.0*shape_4;
        const lane t32 = shape_8*t31;
        const lane t33 = shape_4*t14;
        const lane t34 = shape_4*t10;
        const lane t35 = eigenvalue*g_2_2;
        const lane adjoint_forward_t31 = eigenvalue*g_2_1*t33 + eigenvalue*t32 + t34*t35;
        const lane adjoint_forward_t29 = adjoint_forward_t31*l_f_2_1 + adjoint_forward_t31*l_f_2_2;
        const lane t36 = 2.0*shape_3;
        const lane t37 = shape_7*t36;
        const lane t38 = shape_3*t14;
        const lane t39 = shape_3*t10;
        const lane t40 = eigenvalue*g_1_2;
        const lane adjoint_forward_t28 = eigenvalue*g_1_1*t38 + eigenvalue*t37 + t39*t40;
        const lane adjoint_forward_t26 = adjoint_forward_t28*l_f_1_1 + adjoint_forward_t28*l_f_1_2;
        const lane adjoint_forward_t25 = R_p_1*adjoint_forward_t26 + R_p_2*adjoint_forward_t29;
        const lane adjoint_forward_t24 = -eigenvalue*t15 - eigenvalue*t17;
        const lane adjoint_forward_t22 = -eigenvalue*t18 - eigenvalue*t19;
        const lane t41 = (shape_1*shape_1);
        const lane t42 = eigenvalue*t41;
        const lane t43 = shape_9*t14;
        const lane adjoint_forward_t20 = adjoint_forward_t34 - eigenvalue*t43 - t42;
        const lane t44 = (shape_8*shape_8);
        const lane t45 = forward_t36*t22;
        const lane t46 = eigenvalue*t44 + eigenvalue*t45 + forward_t17*t42 + forward_t33*t29 + t11*t35;
        const lane adjoint_forward_t19 = adjoint_forward_t24*g_2_1 - t46;
        const lane adjoint_forward_t18 = adjoint_forward_t24*g_2_1 - t46;
        const lane t47 = (shape_7*shape_7);
        const lane t48 = forward_t35*t25;
        const lane t49 = eigenvalue*t47 + eigenvalue*t48 + forward_t13*t42 + forward_t32*t29 + t12*t40;
        const lane adjoint_forward_t16 = adjoint_forward_t22*g_1_1 - t49;
        const lane adjoint_forward_t15 = adjoint_forward_t22*g_1_1 - t49;
        const lane adjoint_forward_t14 =
            adjoint_forward_t15*l_f_1_1 + adjoint_forward_t16*l_f_1_2 + adjoint_forward_t18*l_f_2_1
            + adjoint_forward_t19*l_f_2_2;
        const lane t51 = forward_t17*t41 + forward_t33*t28 + shape_4*shape_8*t50 + t44 + t45;
        const lane adjoint_k_2_2 = adjoint_forward_t41*g_2_1 + adjoint_forward_t45*g_2_2 + t51;
        const lane adjoint_forward_3 = adjoint_k_2_2*forward_t12;
        const lane t52 = adjoint_forward_3/(t8*t8);
        const lane adjoint_l_f_2_2 = adjoint_forward_t19*forward_t14 + adjoint_forward_t31*forward_t29 - t52;
        const lane adjoint_k_2_1 = adjoint_forward_t41*g_2_1 + adjoint_forward_t45*g_2_2 + t51;
        const lane adjoint_forward_2 = adjoint_k_2_1*forward_t12;
        const lane adjoint_forward_t12 = adjoint_k_2_1*forward_2 + adjoint_k_2_2*forward_3;
        const lane t53 = adjoint_forward_2/(t7*t7);
        const lane adjoint_forward_t11 = -t52 - t53;
        const lane adjoint_forward_t10 = adjoint_forward_t11*forward_t5 + adjoint_forward_t12*forward_t4;
        const lane adjoint_l_f_2_1 = adjoint_forward_t18*forward_t14 + adjoint_forward_t31*forward_t29 - t53;
        const lane adjoint_forward_t9 = adjoint_l_f_2_1 - adjoint_l_f_2_2;
        const lane t55 = forward_t13*t41 + forward_t32*t28 + shape_3*shape_7*t54 + t47 + t48;
        const lane adjoint_k_1_2 = adjoint_forward_t39*g_1_1 + adjoint_forward_t43*g_1_2 + t55;
        const lane adjoint_forward_1 = adjoint_k_1_2*forward_t8;
        const lane t56 = adjoint_forward_1/(t4*t4);
        const lane adjoint_l_f_1_2 = adjoint_forward_t16*forward_t14 + adjoint_forward_t28*forward_t26 - t56;
        const lane adjoint_k_1_1 = adjoint_forward_t39*g_1_1 + adjoint_forward_t43*g_1_2 + t55;
        const lane adjoint_forward_0 = adjoint_k_1_1*forward_t8;
        const lane adjoint_forward_t8 = adjoint_k_1_1*forward_0 + adjoint_k_1_2*forward_1;
        const lane t57 = adjoint_forward_0/(t3*t3);
        const lane adjoint_forward_t7 = -t56 - t57;
        const lane adjoint_forward_t6 = adjoint_forward_t7*forward_t5 + adjoint_forward_t8*forward_t4;
        const lane adjoint_forward_t5 = adjoint_forward_t11*forward_t10 + adjoint_forward_t7*forward_t6;
        const lane adjoint_forward_t4 =
            adjoint_forward_t12*forward_t10 + adjoint_forward_t5*c_E + adjoint_forward_t8*forward_t6;
        const lane adjoint_l_f_1_1 = adjoint_forward_t15*forward_t14 + adjoint_forward_t28*forward_t26 - t57;
        const lane adjoint_forward_t3 = adjoint_l_f_1_1 - adjoint_l_f_1_2;
        const lane adjoint_I_2 = -t24;
        const lane t58 = (shape_6*shape_6);
        const lane t59 = shape_6*t31;
        const lane adjoint_forward_t2 = adjoint_I_2 - eigenvalue*t58 - eigenvalue*t59;
        const lane adjoint_I_1 = -t27;
        const lane t60 = (shape_5*shape_5);
        const lane t61 = shape_5*t36;
        const lane adjoint_forward_t1 = adjoint_I_1 - eigenvalue*t60 - eigenvalue*t61;
        const lane t62 = adjoint_forward_t6*k_sp_1;
        const lane t63 = adjoint_forward_t10*k_sp_2;
        lanes_clear(gradient, 49);
        gradient[0] = LANES(adjoint_forward_t20);
        gradient[1] = LANES(adjoint_forward_t34);
        gradient[9] = LANES(adjoint_l_f_1_1);
        gradient[10] = LANES(adjoint_l_f_1_2);
        gradient[11] = LANES(adjoint_l_f_2_1);
        gradient[12] = LANES(adjoint_l_f_2_2);
        gradient[13] = LANES(adjoint_forward_t6*t2);
        gradient[14] = LANES(adjoint_forward_t10*t6);
        gradient[15] = LANES(t1*t62);
        gradient[16] = LANES(t5*t63);
        gradient[17] =
            LANES(adjoint_forward_t26*forward_t25 + adjoint_forward_t35*t54 + t26*t37 + t38*(forward_t38
            + forward_t39) + t39*(forward_t42 + forward_t43));
        gradient[18] =
            LANES(adjoint_forward_t29*forward_t25 + adjoint_forward_t36*t50 + t23*t32 + t33*(forward_t40
            + forward_t41) + t34*(forward_t44 + forward_t45));
        gradient[19] = LANES(adjoint_I_1);
        gradient[20] = LANES(adjoint_I_2);
        gradient[21] = LANES(adjoint_forward_t1*(i_g_1*i_g_1));
        gradient[22] = LANES(adjoint_forward_t2*(i_g_2*i_g_2));
        gradient[23] = LANES(2.0*I_m_1*adjoint_forward_t1*i_g_1);
        gradient[24] = LANES(2.0*I_m_2*adjoint_forward_t2*i_g_2);
        gradient[29] = LANES(t62*w_b_1);
        gradient[30] = LANES(t63*w_b_2);
        gradient[31] = LANES(adjoint_forward_t5*forward_t4);
        gradient[33] = LANES((1.0/3.0)*adjoint_forward_t14 + (1.0/6.0)*adjoint_forward_t25);
        gradient[34] = LANES(F_T*adjoint_forward_t4);
        gradient[35] = LANES(adjoint_forward_t4*c_T);
        gradient[36] = LANES(t20 + t21 + t28 + t30 + t41 + t43);
        gradient[38] = LANES(adjoint_I_1 + adjoint_I_2);
        gradient[39] = LANES(adjoint_forward_t20);
        gradient[42] = LANES(t22 + t25 + t58 + t59 + t60 + t61);
        gradient[46] = LANES(adjoint_forward_t37);
        gradient[47] = LANES(adjoint_forward_t3*g_1_1 + adjoint_forward_t9*g_2_1);
        gradient[48] = LANES(adjoint_forward_t3*g_1_2 + adjoint_forward_t9*g_2_2);
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
 * 346 operations; 8591 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_extended_tangent(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int count,
    const struct lanes_paths *paths)
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
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double c_E = effects[2];
    const double rho_b = effects[4];
    const double c_T = effects[5];
    const double F_T = effects[6];
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
    const double forward_t25 = (1.0/6.0)*rho_b;
    const double forward_t26 = R_p_1*forward_t25;
    const double forward_t29 = R_p_2*forward_t25;
    const double forward_t32 = (g_1_2*g_1_2);
    const double forward_t33 = (g_2_2*g_2_2);
    const double forward_t35 = (R_p_1*R_p_1);
    const double forward_t36 = (R_p_2*R_p_2);
    const lane forward_t38 = g_1_1*k_1_1;
    const lane forward_t39 = g_1_1*k_1_2;
    const lane forward_t40 = g_2_1*k_2_1;
    const lane forward_t41 = g_2_1*k_2_2;
    const lane forward_t42 = g_1_2*k_1_1;
    const lane forward_t43 = g_1_2*k_1_2;
    const lane forward_t44 = g_2_2*k_2_1;
    const lane forward_t45 = g_2_2*k_2_2;
    const lane t9 = 1.0/((t3*t3));
    const lane t10 = 1.0/((t4*t4));
    const lane t11 = 1.0/((t7*t7));
    const lane t12 = 1.0/((t8*t8));
    const lane t13 = k_1_1 + k_1_2;
    const lane t14 = k_2_1 + k_2_2;
    for (int path = 0; path < count; path++) {
        lane direction[LANES_GRADIENT], motion_rate[LANES_DIRECTIONS * LANES_ALL];
        lane mass_rate[LANES_ALL * LANES_ALL], stiffness_rate[LANES_ALL * LANES_ALL];
        lanes_direction(paths, path, direction);
        const lane along_1 = direction[0];
        const lane along_2 = direction[1];
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
        const lane along_48 = direction[47];
        const lane along_49 = direction[48];
        const lane tangent_forward_t1 = 2.0*I_m_1*along_24*i_g_1 + along_22*(i_g_1*i_g_1);
        const lane tangent_I_1 = along_20 + along_39 + tangent_forward_t1;
        const lane tangent_forward_t2 = 2.0*I_m_2*along_25*i_g_2 + along_23*(i_g_2*i_g_2);
        const lane tangent_I_2 = along_21 + along_39 + tangent_forward_t2;
        const lane tangent_forward_t3 = along_48*g_1_1 + along_49*g_1_2;
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
        const lane tangent_forward_t9 = along_48*g_2_1 + along_49*g_2_2;
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
        const lane tangent_forward_t22 = g_1_1*tangent_forward_t16;
        const lane tangent_forward_t23 = g_2_1*tangent_forward_t18;
        const lane tangent_forward_t24 = g_2_1*tangent_forward_t19;
        const lane tangent_forward_t25 = (1.0/6.0)*along_34;
        const lane tangent_forward_t26 = R_p_1*tangent_forward_t25 + along_18*forward_t25;
        const lane tangent_forward_t27 = forward_t26*tangent_l_f_1_1 + l_f_1_1*tangent_forward_t26;
        const lane tangent_forward_t28 = forward_t26*tangent_l_f_1_2 + l_f_1_2*tangent_forward_t26;
        const lane tangent_forward_t29 = R_p_2*tangent_forward_t25 + along_19*forward_t25;
        const lane tangent_forward_t30 = forward_t29*tangent_l_f_2_1 + l_f_2_1*tangent_forward_t29;
        const lane tangent_forward_t31 = forward_t29*tangent_l_f_2_2 + l_f_2_2*tangent_forward_t29;
        const lane tangent_forward_t34 = along_2 + tangent_forward_t20;
        const lane tangent_forward_t35 = 2.0*R_p_1*along_18;
        const lane tangent_forward_t36 = 2.0*R_p_2*along_19;
        const lane tangent_forward_t37 = along_47 + tangent_forward_t34;
        const lane tangent_forward_t38 = g_1_1*tangent_k_1_1;
        const lane tangent_forward_t39 = g_1_1*tangent_k_1_2;
        const lane tangent_forward_t40 = g_2_1*tangent_k_2_1;
        const lane tangent_forward_t41 = g_2_1*tangent_k_2_2;
        const lane tangent_forward_t42 = g_1_2*tangent_k_1_1;
        const lane tangent_forward_t43 = g_1_2*tangent_k_1_2;
        const lane tangent_forward_t44 = g_2_2*tangent_k_2_1;
        const lane tangent_forward_t45 = g_2_2*tangent_k_2_2;
        lanes_clear(mass_rate, 100);
        mass_rate[0] =
            LANES(forward_t13*tangent_forward_t15 + forward_t13*tangent_forward_t16
            + forward_t17*tangent_forward_t18 + forward_t17*tangent_forward_t19 + tangent_forward_t20);
        mass_rate[1] = mass_rate[10] =
            LANES(g_1_2*tangent_forward_t21 + g_1_2*tangent_forward_t22 + g_2_2*tangent_forward_t23
            + g_2_2*tangent_forward_t24);
        mass_rate[2] = mass_rate[20] = LANES(-g_1_1*tangent_forward_t27 - g_1_1*tangent_forward_t28);
        mass_rate[3] = mass_rate[30] = LANES(-g_2_1*tangent_forward_t30 - g_2_1*tangent_forward_t31);
        mass_rate[6] = mass_rate[60] = LANES(tangent_forward_t21 + tangent_forward_t22);
        mass_rate[7] = mass_rate[70] = LANES(tangent_forward_t23 + tangent_forward_t24);
        mass_rate[8] = mass_rate[80] = LANES(tangent_forward_t20);
        mass_rate[11] =
            LANES(forward_t32*tangent_forward_t15 + forward_t32*tangent_forward_t16
            + forward_t33*tangent_forward_t18 + forward_t33*tangent_forward_t19 + tangent_forward_t34);
        mass_rate[12] = mass_rate[21] = LANES(-g_1_2*tangent_forward_t27 - g_1_2*tangent_forward_t28);
        mass_rate[13] = mass_rate[31] = LANES(-g_2_2*tangent_forward_t30 - g_2_2*tangent_forward_t31);
        mass_rate[16] = mass_rate[61] = LANES(g_1_2*tangent_forward_t15 + g_1_2*tangent_forward_t16);
        mass_rate[17] = mass_rate[71] = LANES(g_2_2*tangent_forward_t18 + g_2_2*tangent_forward_t19);
        mass_rate[19] = mass_rate[91] = LANES(tangent_forward_t34);
        mass_rate[22] =
            LANES(forward_t35*tangent_forward_t15 + forward_t35*tangent_forward_t16 + tangent_I_1
            + tangent_forward_t35*(forward_t15 + forward_t16));
        mass_rate[24] = mass_rate[42] = LANES(tangent_forward_t1);
        mass_rate[26] = mass_rate[62] = LANES(-tangent_forward_t27 - tangent_forward_t28);
        mass_rate[33] =
            LANES(forward_t36*tangent_forward_t18 + forward_t36*tangent_forward_t19 + tangent_I_2
            + tangent_forward_t36*(forward_t18 + forward_t19));
        mass_rate[35] = mass_rate[53] = LANES(tangent_forward_t2);
        mass_rate[37] = mass_rate[73] = LANES(-tangent_forward_t30 - tangent_forward_t31);
        mass_rate[44] = LANES(tangent_forward_t1);
        mass_rate[55] = LANES(tangent_forward_t2);
        mass_rate[66] = LANES(tangent_forward_t15 + tangent_forward_t16);
        mass_rate[77] = LANES(tangent_forward_t18 + tangent_forward_t19);
        mass_rate[88] = LANES(tangent_forward_t37);
        mass_rate[99] = LANES(tangent_forward_t37);
        lanes_clear(stiffness_rate, 100);
        stiffness_rate[0] =
            LANES(along_37 + forward_t13*tangent_k_1_1 + forward_t13*tangent_k_1_2
            + forward_t17*tangent_k_2_1 + forward_t17*tangent_k_2_2);
        stiffness_rate[1] = stiffness_rate[10] =
            LANES(g_1_2*tangent_forward_t38 + g_1_2*tangent_forward_t39 + g_2_2*tangent_forward_t40
            + g_2_2*tangent_forward_t41);
        stiffness_rate[2] = stiffness_rate[20] =
            LANES(R_p_1*tangent_forward_t38 + R_p_1*tangent_forward_t39 + along_18*(forward_t38
            + forward_t39));
        stiffness_rate[3] = stiffness_rate[30] =
            LANES(R_p_2*tangent_forward_t40 + R_p_2*tangent_forward_t41 + along_19*(forward_t40
            + forward_t41));
        stiffness_rate[6] = stiffness_rate[60] = LANES(tangent_forward_t38 + tangent_forward_t39);
        stiffness_rate[7] = stiffness_rate[70] = LANES(tangent_forward_t40 + tangent_forward_t41);
        stiffness_rate[8] = stiffness_rate[80] = LANES(along_37);
        stiffness_rate[11] =
            LANES(along_37 + forward_t32*tangent_k_1_1 + forward_t32*tangent_k_1_2
            + forward_t33*tangent_k_2_1 + forward_t33*tangent_k_2_2);
        stiffness_rate[12] = stiffness_rate[21] =
            LANES(R_p_1*tangent_forward_t42 + R_p_1*tangent_forward_t43 + along_18*(forward_t42
            + forward_t43));
        stiffness_rate[13] = stiffness_rate[31] =
            LANES(R_p_2*tangent_forward_t44 + R_p_2*tangent_forward_t45 + along_19*(forward_t44
            + forward_t45));
        stiffness_rate[16] = stiffness_rate[61] = LANES(tangent_forward_t42 + tangent_forward_t43);
        stiffness_rate[17] = stiffness_rate[71] = LANES(tangent_forward_t44 + tangent_forward_t45);
        stiffness_rate[19] = stiffness_rate[91] = LANES(along_37);
        stiffness_rate[22] =
            LANES(along_43 + forward_t35*tangent_k_1_1 + forward_t35*tangent_k_1_2 + t13*tangent_forward_t35);
        stiffness_rate[24] = stiffness_rate[42] = LANES(along_43);
        stiffness_rate[26] = stiffness_rate[62] =
            LANES(R_p_1*tangent_k_1_1 + R_p_1*tangent_k_1_2 + along_18*t13);
        stiffness_rate[33] =
            LANES(along_43 + forward_t36*tangent_k_2_1 + forward_t36*tangent_k_2_2 + t14*tangent_forward_t36);
        stiffness_rate[35] = stiffness_rate[53] = LANES(along_43);
        stiffness_rate[37] = stiffness_rate[73] =
            LANES(R_p_2*tangent_k_2_1 + R_p_2*tangent_k_2_2 + along_19*t14);
        stiffness_rate[44] = LANES(along_43);
        stiffness_rate[55] = LANES(along_43);
        stiffness_rate[66] = LANES(tangent_k_1_1 + tangent_k_1_2);
        stiffness_rate[77] = LANES(tangent_k_2_1 + tangent_k_2_2);
        stiffness_rate[88] = LANES(along_37);
        stiffness_rate[99] = LANES(along_37);
        lanes_clear(motion_rate, 20);
        lanes_take(paths, path, mass_rate, stiffness_rate, motion_rate);
    }
}
