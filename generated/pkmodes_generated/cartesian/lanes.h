/* Generated from the derivation of cartesian.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * The mechanism cartesian for the compiled evaluator.
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
#define LANES_GRADIENT 50
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
    const double travel_min_x = parameters[21];
    const double travel_max_x = parameters[22];
    const double travel_min_y = parameters[23];
    const double travel_max_y = parameters[24];
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
 * 33 operations; 79 with every named value expanded.
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
    const double m_b = parameters[1];
    const double l_0_1_1 = parameters[5];
    const double l_0_1_2 = parameters[6];
    const double l_0_2_1 = parameters[7];
    const double l_0_2_2 = parameters[8];
    const double k_sp_1 = parameters[9];
    const double k_sp_2 = parameters[10];
    const double w_b_1 = parameters[11];
    const double w_b_2 = parameters[12];
    const double R_p_1 = parameters[13];
    const double R_p_2 = parameters[14];
    const double I_p_1 = parameters[15];
    const double I_p_2 = parameters[16];
    const double I_m_1 = parameters[17];
    const double I_m_2 = parameters[18];
    const double i_g_1 = parameters[19];
    const double i_g_2 = parameters[20];
    const double I_1 = I_m_1*(i_g_1*i_g_1) + I_p_1;
    const double I_2 = I_m_2*(i_g_2*i_g_2) + I_p_2;
    const lane l_f_1_1 = l_0_1_1 + x;
    const double t1 = k_sp_1*w_b_1;
    const lane k_1_1 = t1/l_f_1_1;
    const lane l_f_1_2 = l_0_1_2 - x;
    const lane k_1_2 = t1/l_f_1_2;
    const lane l_f_2_1 = l_0_2_1 + y;
    const double t2 = k_sp_2*w_b_2;
    const lane k_2_1 = t2/l_f_2_1;
    const lane l_f_2_2 = l_0_2_2 - y;
    const lane k_2_2 = t2/l_f_2_2;
    const double t3 = (R_p_1*R_p_1);
    const double t4 = (R_p_2*R_p_2);
    lanes_clear(M, 16);
    M[0] = LANES(m_h);
    M[5] = LANES(m_b + m_h);
    M[10] = LANES(I_1);
    M[15] = LANES(I_2);
    lanes_clear(K, 16);
    K[0] = LANES(k_1_1 + k_1_2);
    K[2] = K[8] = LANES(R_p_1*k_1_1 + R_p_1*k_1_2);
    K[5] = LANES(k_2_1 + k_2_2);
    K[7] = K[13] = LANES(R_p_2*k_2_1 + R_p_2*k_2_2);
    K[10] = LANES(k_1_1*t3 + k_1_2*t3);
    K[15] = LANES(k_2_1*t4 + k_2_2*t4);
    lanes_clear(J_p, 8);
    J_p[0] = LANES(1.0);
    J_p[5] = LANES(1.0);
}

/* Mass and stiffness matrices with all released joints free, and the motion of the platform.
 *
 * Source: extended_matrices and extended_platform_motion.
 * 97 operations; 857 with every named value expanded.
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
    const double m_b = parameters[1];
    const double g_y = parameters[3];
    const double l_0_1_1 = parameters[5];
    const double l_0_1_2 = parameters[6];
    const double l_0_2_1 = parameters[7];
    const double l_0_2_2 = parameters[8];
    const double k_sp_1 = parameters[9];
    const double k_sp_2 = parameters[10];
    const double w_b_1 = parameters[11];
    const double w_b_2 = parameters[12];
    const double R_p_1 = parameters[13];
    const double R_p_2 = parameters[14];
    const double I_p_1 = parameters[15];
    const double I_p_2 = parameters[16];
    const double I_m_1 = parameters[17];
    const double I_m_2 = parameters[18];
    const double i_g_1 = parameters[19];
    const double i_g_2 = parameters[20];
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
    const lane l_f_1_1 = l_0_1_1 + x;
    const double t3 = F_T*c_T + 1.0;
    const double t4 = c_E*t3;
    const double t5 = k_sp_1*w_b_1*(a_B_1 + 1.0);
    const double t6 = t4*t5;
    const double t7 = t3*t5;
    const lane k_1_1 = t7/(l_f_1_1 + t6);
    const lane l_f_1_2 = l_0_1_2 - x;
    const lane k_1_2 = t7/(l_f_1_2 + t6);
    const lane l_f_2_1 = l_0_2_1 + y;
    const double t8 = k_sp_2*w_b_2*(a_B_2 + 1.0);
    const double t9 = t4*t8;
    const double t10 = t3*t8;
    const lane k_2_1 = t10/(l_f_2_1 + t9);
    const lane l_f_2_2 = l_0_2_2 - y;
    const lane k_2_2 = t10/(l_f_2_2 + t9);
    const double t11 = (1.0/3.0)*rho_b;
    const lane t12 = l_f_1_1*t11;
    const lane t13 = l_f_1_2*t11;
    const lane t14 = t12 + t13;
    const double t15 = m_L + m_h;
    const double t16 = (1.0/6.0)*rho_b;
    const double t17 = R_p_1*t16;
    const lane t18 = -l_f_1_1*t17 - l_f_1_2*t17;
    const lane t19 = l_f_2_1*t11;
    const lane t20 = l_f_2_2*t11;
    const lane t21 = t19 + t20;
    const double t22 = m_b + t15;
    const double t23 = R_p_2*t16;
    const lane t24 = -l_f_2_1*t23 - l_f_2_2*t23;
    const lane t25 = b*t15;
    const double t26 = (R_p_1*R_p_1);
    const double t27 = (R_p_2*R_p_2);
    const double t28 = m_F + t22;
    const lane t29 = (b*b);
    const lane t30 = k_1_1 + k_1_2;
    const lane t31 = R_p_1*k_1_1 + R_p_1*k_1_2;
    const lane t32 = k_2_1 + k_2_2;
    const lane t33 = R_p_2*k_2_1 + R_p_2*k_2_2;
    const lane t34 = b*k_C;
    lanes_clear(M, 121);
    M[0] = LANES(t14 + t15);
    M[2] = M[22] = LANES(t18);
    M[6] = M[66] = LANES(t14);
    M[8] = M[88] = LANES(t15);
    M[12] = LANES(t21 + t22);
    M[14] = M[34] = LANES(t24);
    M[18] = M[78] = LANES(t21);
    M[20] = M[100] = LANES(t22);
    M[21] = M[111] = LANES(t25);
    M[24] = LANES(I_1 + t12*t26 + t13*t26);
    M[26] = M[46] = LANES(t1);
    M[28] = M[68] = LANES(t18);
    M[36] = LANES(I_2 + t19*t27 + t20*t27);
    M[38] = M[58] = LANES(t2);
    M[40] = M[80] = LANES(t24);
    M[48] = LANES(t1);
    M[60] = LANES(t2);
    M[72] = LANES(t14);
    M[84] = LANES(t21);
    M[96] = LANES(t28);
    M[108] = LANES(t28);
    M[109] = M[119] = LANES(t25);
    M[120] = LANES(J_B + 2.0*t29*((1.0/2.0)*m_L + (1.0/2.0)*m_h));
    lanes_clear(K, 121);
    K[0] = LANES(k_C + t30);
    K[2] = K[22] = LANES(t31);
    K[6] = K[66] = LANES(t30);
    K[8] = K[88] = LANES(k_C);
    K[10] = K[110] = LANES(-g_y*t15);
    K[12] = LANES(k_C + t32);
    K[14] = K[34] = LANES(t33);
    K[18] = K[78] = LANES(t32);
    K[20] = K[100] = LANES(k_C);
    K[21] = K[111] = LANES(t34);
    K[24] = LANES(k_1_1*t26 + k_1_2*t26 + k_S);
    K[26] = K[46] = LANES(k_S);
    K[28] = K[68] = LANES(t31);
    K[36] = LANES(k_2_1*t27 + k_2_2*t27 + k_S);
    K[38] = K[58] = LANES(k_S);
    K[40] = K[80] = LANES(t33);
    K[48] = LANES(k_S);
    K[60] = LANES(k_S);
    K[72] = LANES(t30);
    K[84] = LANES(t32);
    K[96] = LANES(k_C);
    K[108] = LANES(k_C);
    K[109] = K[119] = LANES(t34);
    K[120] = LANES(k_C*t29);
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
 * 41 operations; 179 with every named value expanded.
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
    const double m_b = parameters[1];
    const double g_x = parameters[2];
    const double g_y = parameters[3];
    const double l_0_1_1 = parameters[5];
    const double l_0_1_2 = parameters[6];
    const double l_0_2_1 = parameters[7];
    const double l_0_2_2 = parameters[8];
    const double k_sp_1 = parameters[9];
    const double k_sp_2 = parameters[10];
    const double w_b_1 = parameters[11];
    const double w_b_2 = parameters[12];
    const double R_p_1 = parameters[13];
    const double R_p_2 = parameters[14];
    const lane l_f_1_1 = l_0_1_1 + x;
    const double t1 = k_sp_1*w_b_1;
    const lane k_1_1 = t1/l_f_1_1;
    const lane l_f_1_2 = l_0_1_2 - x;
    const lane k_1_2 = t1/l_f_1_2;
    const lane l_f_2_1 = l_0_2_1 + y;
    const double t2 = k_sp_2*w_b_2;
    const lane k_2_1 = t2/l_f_2_1;
    const lane l_f_2_2 = l_0_2_2 - y;
    const lane k_2_2 = t2/l_f_2_2;
    const double G_1 = -g_x*m_h;
    const double G_2 = -g_y*(m_b + m_h);
    const lane t3 = R_p_1*k_1_1 + R_p_1*k_1_2;
    const lane theta_1_st = -G_1/t3;
    const lane t4 = R_p_2*k_2_1 + R_p_2*k_2_2;
    const lane theta_2_st = -G_2/t4;
    const double t5 = (R_p_1*R_p_1);
    const lane t6 = k_1_1*t5;
    const lane t7 = k_1_2*t5;
    const lane tau_st_1 = t6*theta_1_st + t7*theta_1_st;
    const double t8 = (R_p_2*R_p_2);
    const lane t9 = k_2_1*t8;
    const lane t10 = k_2_2*t8;
    const lane tau_st_2 = t10*theta_2_st + t9*theta_2_st;
    lanes_clear(D_p, 4);
    D_p[0] = LANES(1.0);
    D_p[3] = LANES(1.0);
    tau_st[0] = LANES(tau_st_1);
    tau_st[1] = LANES(tau_st_2);
    theta_st[0] = LANES(theta_1_st);
    theta_st[1] = LANES(theta_2_st);
    lanes_clear(H_el, 16);
    H_el[0] = LANES(k_1_1 + k_1_2);
    H_el[2] = H_el[8] = LANES(t3);
    H_el[5] = LANES(k_2_1 + k_2_2);
    H_el[7] = H_el[13] = LANES(t4);
    H_el[10] = LANES(t6 + t7);
    H_el[15] = LANES(t10 + t9);
}

/* Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 51 operations; 321 with every named value expanded.
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
    const double m_b = parameters[1];
    const double g_x = parameters[2];
    const double g_y = parameters[3];
    const double l_0_1_1 = parameters[5];
    const double l_0_1_2 = parameters[6];
    const double l_0_2_1 = parameters[7];
    const double l_0_2_2 = parameters[8];
    const double k_sp_1 = parameters[9];
    const double k_sp_2 = parameters[10];
    const double w_b_1 = parameters[11];
    const double w_b_2 = parameters[12];
    const double R_p_1 = parameters[13];
    const double R_p_2 = parameters[14];
    const double a_B_1 = effects[0];
    const double a_B_2 = effects[1];
    const double c_E = effects[2];
    const double c_T = effects[5];
    const double F_T = effects[6];
    const double m_L = effects[10];
    const lane l_f_1_1 = l_0_1_1 + x;
    const double t1 = F_T*c_T + 1.0;
    const double t2 = c_E*t1;
    const double t3 = k_sp_1*w_b_1*(a_B_1 + 1.0);
    const double t4 = t2*t3;
    const double t5 = t1*t3;
    const lane k_1_1 = t5/(l_f_1_1 + t4);
    const lane l_f_1_2 = l_0_1_2 - x;
    const lane k_1_2 = t5/(l_f_1_2 + t4);
    const lane l_f_2_1 = l_0_2_1 + y;
    const double t6 = k_sp_2*w_b_2*(a_B_2 + 1.0);
    const double t7 = t2*t6;
    const double t8 = t1*t6;
    const lane k_2_1 = t8/(l_f_2_1 + t7);
    const lane l_f_2_2 = l_0_2_2 - y;
    const lane k_2_2 = t8/(l_f_2_2 + t7);
    const double t9 = m_L + m_h;
    const double G_1 = -g_x*t9;
    const double G_2 = -g_y*(m_b + t9);
    const lane theta_1_st = -G_1/(R_p_1*k_1_1 + R_p_1*k_1_2);
    const lane theta_2_st = -G_2/(R_p_2*k_2_1 + R_p_2*k_2_2);
    const lane t10 = (R_p_1*R_p_1)*theta_1_st;
    const lane tau_st_1 = k_1_1*t10 + k_1_2*t10;
    const lane t11 = (R_p_2*R_p_2)*theta_2_st;
    const lane tau_st_2 = k_2_1*t11 + k_2_2*t11;
    tau_st[0] = LANES(tau_st_1);
    tau_st[1] = LANES(tau_st_2);
    theta_st[0] = LANES(theta_1_st);
    theta_st[1] = LANES(theta_2_st);
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through base.
 * 91 operations; 323 with every named value expanded.
 */
static __attribute__((noinline)) void lanes_base_gradient(const lane *restrict pose,
    const double *restrict parameters, const double *restrict effects, int modes, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
    (void)effects;
    const lane x = pose[0];
    const lane y = pose[1];
    const double l_0_1_1 = parameters[5];
    const double l_0_1_2 = parameters[6];
    const double l_0_2_1 = parameters[7];
    const double l_0_2_2 = parameters[8];
    const double k_sp_1 = parameters[9];
    const double k_sp_2 = parameters[10];
    const double w_b_1 = parameters[11];
    const double w_b_2 = parameters[12];
    const double R_p_1 = parameters[13];
    const double R_p_2 = parameters[14];
    const double I_m_1 = parameters[17];
    const double I_m_2 = parameters[18];
    const double i_g_1 = parameters[19];
    const double i_g_2 = parameters[20];
    const lane l_f_1_1 = l_0_1_1 + x;
    const double forward_t1 = k_sp_1*w_b_1;
    const lane forward_0 = 1.0/l_f_1_1;
    const lane k_1_1 = forward_0*forward_t1;
    const lane l_f_1_2 = l_0_1_2 - x;
    const lane forward_1 = 1.0/l_f_1_2;
    const lane k_1_2 = forward_1*forward_t1;
    const lane l_f_2_1 = l_0_2_1 + y;
    const double forward_t2 = k_sp_2*w_b_2;
    const lane forward_2 = 1.0/l_f_2_1;
    const lane k_2_1 = forward_2*forward_t2;
    const lane l_f_2_2 = l_0_2_2 - y;
    const lane forward_3 = 1.0/l_f_2_2;
    const lane k_2_2 = forward_3*forward_t2;
    const double forward_t3 = (R_p_1*R_p_1);
    const double forward_t4 = (R_p_2*R_p_2);
    const lane t2 = k_2_1 + k_2_2;
    const lane t4 = k_1_1 + k_1_2;
    const double t6 = 2.0*R_p_2;
    const double t10 = 2.0*R_p_1;
    for (int mode = 0; mode < modes; mode++) {
        const lane *restrict shape = shapes + mode * 4;
        const lane eigenvalue = eigenvalues[mode];
        lane *restrict gradient = gradients + mode * stride;
        const lane shape_1 = shape[0];
        const lane shape_2 = shape[1];
        const lane shape_3 = shape[2];
        const lane shape_4 = shape[3];
        const lane t1 = (shape_4*shape_4);
        const lane adjoint_forward_t4 = t1*t2;
        const lane t3 = (shape_3*shape_3);
        const lane adjoint_forward_t3 = t3*t4;
        const lane t5 = (shape_2*shape_2);
        const lane t7 = shape_2*shape_4;
        const lane adjoint_k_2_2 = forward_t4*t1 + t5 + t6*t7;
        const lane adjoint_forward_3 = adjoint_k_2_2*forward_t2;
        const lane adjoint_l_f_2_2 = -adjoint_forward_3*(forward_3*forward_3);
        const lane adjoint_forward_2 = adjoint_k_2_2*forward_t2;
        const lane adjoint_forward_t2 = adjoint_k_2_2*forward_2 + adjoint_k_2_2*forward_3;
        const lane adjoint_l_f_2_1 = -adjoint_forward_2*(forward_2*forward_2);
        const lane t8 = shape_1*shape_3;
        const lane t9 = (shape_1*shape_1);
        const lane adjoint_k_1_2 = forward_t3*t3 + t10*t8 + t9;
        const lane adjoint_forward_1 = adjoint_k_1_2*forward_t1;
        const lane adjoint_l_f_1_2 = -adjoint_forward_1*(forward_1*forward_1);
        const lane adjoint_forward_0 = adjoint_k_1_2*forward_t1;
        const lane adjoint_forward_t1 = adjoint_k_1_2*forward_0 + adjoint_k_1_2*forward_1;
        const lane adjoint_l_f_1_1 = -adjoint_forward_0*(forward_0*forward_0);
        const lane adjoint_I_2 = -eigenvalue*t1;
        const lane adjoint_I_1 = -eigenvalue*t3;
        const lane t11 = eigenvalue*t5;
        lanes_clear(gradient, 50);
        gradient[0] = LANES(-eigenvalue*t9 - t11);
        gradient[1] = LANES(-t11);
        gradient[5] = LANES(adjoint_l_f_1_1);
        gradient[6] = LANES(adjoint_l_f_1_2);
        gradient[7] = LANES(adjoint_l_f_2_1);
        gradient[8] = LANES(adjoint_l_f_2_2);
        gradient[9] = LANES(adjoint_forward_t1*w_b_1);
        gradient[10] = LANES(adjoint_forward_t2*w_b_2);
        gradient[11] = LANES(adjoint_forward_t1*k_sp_1);
        gradient[12] = LANES(adjoint_forward_t2*k_sp_2);
        gradient[13] = LANES(adjoint_forward_t3*t10 + 2.0*t4*t8);
        gradient[14] = LANES(adjoint_forward_t4*t6 + 2.0*t2*t7);
        gradient[15] = LANES(adjoint_I_1);
        gradient[16] = LANES(adjoint_I_2);
        gradient[17] = LANES(adjoint_I_1*(i_g_1*i_g_1));
        gradient[18] = LANES(adjoint_I_2*(i_g_2*i_g_2));
        gradient[19] = LANES(2.0*I_m_1*adjoint_I_1*i_g_1);
        gradient[20] = LANES(2.0*I_m_2*adjoint_I_2*i_g_2);
        gradient[48] = LANES(adjoint_l_f_1_1 - adjoint_l_f_1_2);
        gradient[49] = LANES(adjoint_l_f_2_1 - adjoint_l_f_2_2);
    }
}

/* Derivatives of the eigenvalue of a mode with respect to all quantities.
 *
 * Source: reverse accumulation through extended.
 * 286 operations; 2662 with every named value expanded.
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
    const double l_0_1_1 = parameters[5];
    const double l_0_1_2 = parameters[6];
    const double l_0_2_1 = parameters[7];
    const double l_0_2_2 = parameters[8];
    const double k_sp_1 = parameters[9];
    const double k_sp_2 = parameters[10];
    const double w_b_1 = parameters[11];
    const double w_b_2 = parameters[12];
    const double R_p_1 = parameters[13];
    const double R_p_2 = parameters[14];
    const double I_m_1 = parameters[17];
    const double I_m_2 = parameters[18];
    const double i_g_1 = parameters[19];
    const double i_g_2 = parameters[20];
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
    const lane l_f_1_1 = l_0_1_1 + x;
    const double forward_t3 = F_T*c_T + 1.0;
    const double forward_t4 = c_E*forward_t3;
    const double t1 = a_B_1 + 1.0;
    const double t2 = t1*w_b_1;
    const double forward_t5 = k_sp_1*t2;
    const double forward_t6 = forward_t4*forward_t5;
    const double forward_t7 = forward_t3*forward_t5;
    const lane t3 = forward_t6 + l_f_1_1;
    const lane forward_0 = 1.0/t3;
    const lane k_1_1 = forward_0*forward_t7;
    const lane l_f_1_2 = l_0_1_2 - x;
    const lane t4 = forward_t6 + l_f_1_2;
    const lane forward_1 = 1.0/t4;
    const lane k_1_2 = forward_1*forward_t7;
    const lane l_f_2_1 = l_0_2_1 + y;
    const double t5 = a_B_2 + 1.0;
    const double t6 = t5*w_b_2;
    const double forward_t8 = k_sp_2*t6;
    const double forward_t9 = forward_t4*forward_t8;
    const double forward_t10 = forward_t3*forward_t8;
    const lane t7 = forward_t9 + l_f_2_1;
    const lane forward_2 = 1.0/t7;
    const lane k_2_1 = forward_2*forward_t10;
    const lane l_f_2_2 = l_0_2_2 - y;
    const lane t8 = forward_t9 + l_f_2_2;
    const lane forward_3 = 1.0/t8;
    const lane k_2_2 = forward_3*forward_t10;
    const double forward_t11 = (1.0/3.0)*rho_b;
    const lane forward_t12 = forward_t11*l_f_1_1;
    const lane forward_t13 = forward_t11*l_f_1_2;
    const double forward_t15 = m_L + m_h;
    const double forward_t16 = (1.0/6.0)*rho_b;
    const double forward_t17 = R_p_1*forward_t16;
    const lane forward_t19 = forward_t11*l_f_2_1;
    const lane forward_t20 = forward_t11*l_f_2_2;
    const double forward_t23 = R_p_2*forward_t16;
    const double forward_t26 = (R_p_1*R_p_1);
    const double forward_t27 = (R_p_2*R_p_2);
    const lane forward_t29 = (b*b);
    const lane t31 = k_2_1 + k_2_2;
    const lane t34 = k_1_1 + k_1_2;
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
        const lane adjoint_forward_t34 = t10 + t11;
        const lane t12 = 2.0*shape_4;
        const lane t13 = shape_2*t12;
        const lane t14 = shape_8*t12;
        const lane adjoint_forward_t33 = t13 + t14;
        const lane t15 = (shape_2*shape_2);
        const lane t16 = (shape_8*shape_8);
        const lane t17 = 2.0*shape_2;
        const lane t18 = shape_8*t17;
        const lane adjoint_forward_t32 = t15 + t16 + t18;
        const lane t19 = 2.0*shape_3;
        const lane t20 = shape_1*t19;
        const lane t21 = shape_7*t19;
        const lane adjoint_forward_t31 = t20 + t21;
        const lane t22 = (shape_1*shape_1);
        const lane t23 = (shape_7*shape_7);
        const lane t24 = 2.0*shape_1;
        const lane t25 = shape_7*t24;
        const lane adjoint_forward_t30 = t22 + t23 + t25;
        const lane t26 = (shape_11*shape_11);
        const lane t27 = eigenvalue*t26;
        const lane adjoint_forward_t29 = -forward_t15*t27 + k_C*t26;
        const lane t28 = (shape_10*shape_10);
        const lane t29 = (shape_9*shape_9);
        const lane adjoint_forward_t28 = -eigenvalue*t28 - eigenvalue*t29;
        const lane t30 = (shape_4*shape_4);
        const lane t32 = eigenvalue*t30;
        const lane adjoint_forward_t27 = t30*t31 - t32*(forward_t19 + forward_t20);
        const lane t33 = (shape_3*shape_3);
        const lane t35 = eigenvalue*t33;
        const lane adjoint_forward_t26 = t33*t34 - t35*(forward_t12 + forward_t13);
        const lane adjoint_forward_t25 = -eigenvalue*t10 - eigenvalue*t11;
        const lane adjoint_forward_t24 = -eigenvalue*t13 - eigenvalue*t14;
        const lane adjoint_forward_t23 = adjoint_forward_t24*(-l_f_2_1 - l_f_2_2);
        const lane t36 = eigenvalue*t15;
        const lane t37 = shape_10*t17;
        const lane adjoint_forward_t22 = adjoint_forward_t28 - eigenvalue*t37 - t36;
        const lane adjoint_forward_t21 = -eigenvalue*t16 - eigenvalue*t18 - t36;
        const lane t38 = forward_t27*t30;
        const lane adjoint_forward_t20 = adjoint_forward_t21 - eigenvalue*t38;
        const lane adjoint_forward_t18 = -eigenvalue*t20 - eigenvalue*t21;
        const lane adjoint_forward_t17 = adjoint_forward_t18*(-l_f_1_1 - l_f_1_2);
        const lane adjoint_forward_t16 = R_p_1*adjoint_forward_t17 + R_p_2*adjoint_forward_t23;
        const lane t39 = eigenvalue*t22;
        const lane t40 = shape_9*t24;
        const lane t41 = shape_1*t9;
        const lane adjoint_forward_t15 =
            adjoint_forward_t22 + adjoint_forward_t25*b - eigenvalue*t40 - g_y*t41 - t39;
        const lane adjoint_forward_t14 = -eigenvalue*t23 - eigenvalue*t25 - t39;
        const lane t42 = forward_t26*t33;
        const lane adjoint_forward_t13 = adjoint_forward_t14 - eigenvalue*t42;
        const lane adjoint_forward_t11 =
            adjoint_forward_t13*l_f_1_1 + adjoint_forward_t13*l_f_1_2 + adjoint_forward_t20*l_f_2_1
            + adjoint_forward_t20*l_f_2_2;
        const lane adjoint_k_2_2 = R_p_2*adjoint_forward_t33 + adjoint_forward_t32 + t38;
        const lane adjoint_forward_3 = adjoint_k_2_2*forward_t10;
        const lane t43 = adjoint_forward_t24*forward_t23;
        const lane t44 = adjoint_forward_3/(t8*t8);
        const lane adjoint_l_f_2_2 = adjoint_forward_t20*forward_t11 - t43 - t44;
        const lane adjoint_forward_2 = adjoint_k_2_2*forward_t10;
        const lane adjoint_forward_t10 = adjoint_k_2_2*forward_2 + adjoint_k_2_2*forward_3;
        const lane t45 = adjoint_forward_2/(t7*t7);
        const lane adjoint_forward_t9 = -t44 - t45;
        const lane adjoint_forward_t8 = adjoint_forward_t10*forward_t3 + adjoint_forward_t9*forward_t4;
        const lane adjoint_l_f_2_1 = adjoint_forward_t20*forward_t11 - t43 - t45;
        const lane adjoint_k_1_2 = R_p_1*adjoint_forward_t31 + adjoint_forward_t30 + t42;
        const lane adjoint_forward_1 = adjoint_k_1_2*forward_t7;
        const lane t46 = adjoint_forward_t18*forward_t17;
        const lane t47 = adjoint_forward_1/(t4*t4);
        const lane adjoint_l_f_1_2 = adjoint_forward_t13*forward_t11 - t46 - t47;
        const lane adjoint_forward_0 = adjoint_k_1_2*forward_t7;
        const lane adjoint_forward_t7 = adjoint_k_1_2*forward_0 + adjoint_k_1_2*forward_1;
        const lane t48 = adjoint_forward_0/(t3*t3);
        const lane adjoint_forward_t6 = -t47 - t48;
        const lane adjoint_forward_t5 = adjoint_forward_t6*forward_t4 + adjoint_forward_t7*forward_t3;
        const lane adjoint_forward_t4 = adjoint_forward_t6*forward_t5 + adjoint_forward_t9*forward_t8;
        const lane adjoint_forward_t3 =
            adjoint_forward_t10*forward_t8 + adjoint_forward_t4*c_E + adjoint_forward_t7*forward_t5;
        const lane adjoint_l_f_1_1 = adjoint_forward_t13*forward_t11 - t46 - t48;
        const lane adjoint_I_2 = -t32;
        const lane t49 = (shape_6*shape_6);
        const lane t50 = shape_6*t12;
        const lane adjoint_forward_t2 = adjoint_I_2 - eigenvalue*t49 - eigenvalue*t50;
        const lane adjoint_I_1 = -t35;
        const lane t51 = (shape_5*shape_5);
        const lane t52 = shape_5*t19;
        const lane adjoint_forward_t1 = adjoint_I_1 - eigenvalue*t51 - eigenvalue*t52;
        const lane adjoint_b =
            adjoint_forward_t25*forward_t15 + 2.0*adjoint_forward_t29*b + adjoint_forward_t34*k_C;
        const lane t53 = forward_t29*t26;
        const lane t54 = adjoint_forward_t15 - eigenvalue*t53;
        const lane t55 = adjoint_forward_t5*k_sp_1;
        const lane t56 = adjoint_forward_t8*k_sp_2;
        lanes_clear(gradient, 50);
        gradient[0] = LANES(t54);
        gradient[1] = LANES(adjoint_forward_t22);
        gradient[3] = LANES(-forward_t15*t41);
        gradient[5] = LANES(adjoint_l_f_1_1);
        gradient[6] = LANES(adjoint_l_f_1_2);
        gradient[7] = LANES(adjoint_l_f_2_1);
        gradient[8] = LANES(adjoint_l_f_2_2);
        gradient[9] = LANES(adjoint_forward_t5*t2);
        gradient[10] = LANES(adjoint_forward_t8*t6);
        gradient[11] = LANES(t1*t55);
        gradient[12] = LANES(t5*t56);
        gradient[13] =
            LANES(2.0*R_p_1*adjoint_forward_t26 + adjoint_forward_t17*forward_t16 + adjoint_forward_t31*t34);
        gradient[14] =
            LANES(2.0*R_p_2*adjoint_forward_t27 + adjoint_forward_t23*forward_t16 + adjoint_forward_t33*t31);
        gradient[15] = LANES(adjoint_I_1);
        gradient[16] = LANES(adjoint_I_2);
        gradient[17] = LANES(adjoint_forward_t1*(i_g_1*i_g_1));
        gradient[18] = LANES(adjoint_forward_t2*(i_g_2*i_g_2));
        gradient[19] = LANES(2.0*I_m_1*adjoint_forward_t1*i_g_1);
        gradient[20] = LANES(2.0*I_m_2*adjoint_forward_t2*i_g_2);
        gradient[25] = LANES(t55*w_b_1);
        gradient[26] = LANES(t56*w_b_2);
        gradient[27] = LANES(adjoint_forward_t4*forward_t3);
        gradient[29] = LANES((1.0/3.0)*adjoint_forward_t11 + (1.0/6.0)*adjoint_forward_t16);
        gradient[30] = LANES(F_T*adjoint_forward_t3);
        gradient[31] = LANES(adjoint_forward_t3*c_T);
        gradient[32] = LANES(adjoint_forward_t34*b + t15 + t22 + t28 + t29 + t37 + t40 + t53);
        gradient[34] = LANES(adjoint_I_1 + adjoint_I_2);
        gradient[35] = LANES(t54);
        gradient[38] = LANES(t30 + t33 + t49 + t50 + t51 + t52);
        gradient[42] = LANES(adjoint_forward_t28);
        gradient[46] = LANES(-t27);
        gradient[47] = LANES(-adjoint_b);
        gradient[48] = LANES(adjoint_b + adjoint_l_f_1_1 - adjoint_l_f_1_2);
        gradient[49] = LANES(adjoint_l_f_2_1 - adjoint_l_f_2_2);
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
 * 239 operations; 4228 with every named value expanded.
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
    const double l_0_1_1 = parameters[5];
    const double l_0_1_2 = parameters[6];
    const double l_0_2_1 = parameters[7];
    const double l_0_2_2 = parameters[8];
    const double k_sp_1 = parameters[9];
    const double k_sp_2 = parameters[10];
    const double w_b_1 = parameters[11];
    const double w_b_2 = parameters[12];
    const double R_p_1 = parameters[13];
    const double R_p_2 = parameters[14];
    const double I_m_1 = parameters[17];
    const double I_m_2 = parameters[18];
    const double i_g_1 = parameters[19];
    const double i_g_2 = parameters[20];
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
    const lane l_f_1_1 = l_0_1_1 + x;
    const double forward_t3 = F_T*c_T + 1.0;
    const double forward_t4 = c_E*forward_t3;
    const double t1 = a_B_1 + 1.0;
    const double t2 = t1*w_b_1;
    const double forward_t5 = k_sp_1*t2;
    const double forward_t6 = forward_t4*forward_t5;
    const double forward_t7 = forward_t3*forward_t5;
    const lane t3 = forward_t6 + l_f_1_1;
    const lane forward_0 = 1.0/t3;
    const lane k_1_1 = forward_0*forward_t7;
    const lane l_f_1_2 = l_0_1_2 - x;
    const lane t4 = forward_t6 + l_f_1_2;
    const lane forward_1 = 1.0/t4;
    const lane k_1_2 = forward_1*forward_t7;
    const lane l_f_2_1 = l_0_2_1 + y;
    const double t5 = a_B_2 + 1.0;
    const double t6 = t5*w_b_2;
    const double forward_t8 = k_sp_2*t6;
    const double forward_t9 = forward_t4*forward_t8;
    const double forward_t10 = forward_t3*forward_t8;
    const lane t7 = forward_t9 + l_f_2_1;
    const lane forward_2 = 1.0/t7;
    const lane k_2_1 = forward_2*forward_t10;
    const lane l_f_2_2 = l_0_2_2 - y;
    const lane t8 = forward_t9 + l_f_2_2;
    const lane forward_3 = 1.0/t8;
    const lane k_2_2 = forward_3*forward_t10;
    const double forward_t11 = (1.0/3.0)*rho_b;
    const lane forward_t12 = forward_t11*l_f_1_1;
    const lane forward_t13 = forward_t11*l_f_1_2;
    const double forward_t15 = m_L + m_h;
    const double forward_t16 = (1.0/6.0)*rho_b;
    const double forward_t17 = R_p_1*forward_t16;
    const lane forward_t19 = forward_t11*l_f_2_1;
    const lane forward_t20 = forward_t11*l_f_2_2;
    const double forward_t23 = R_p_2*forward_t16;
    const double forward_t26 = (R_p_1*R_p_1);
    const double forward_t27 = (R_p_2*R_p_2);
    const lane forward_t29 = (b*b);
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
        const lane along_4 = direction[3];
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
        const lane along_26 = direction[25];
        const lane along_27 = direction[26];
        const lane along_28 = direction[27];
        const lane along_30 = direction[29];
        const lane along_31 = direction[30];
        const lane along_32 = direction[31];
        const lane along_33 = direction[32];
        const lane along_35 = direction[34];
        const lane along_36 = direction[35];
        const lane along_39 = direction[38];
        const lane along_43 = direction[42];
        const lane along_47 = direction[46];
        const lane along_48 = direction[47];
        const lane along_49 = direction[48];
        const lane along_50 = direction[49];
        const lane tangent_b = -along_48 + along_49;
        const lane tangent_forward_t1 = 2.0*I_m_1*along_20*i_g_1 + along_18*(i_g_1*i_g_1);
        const lane tangent_I_1 = along_16 + along_35 + tangent_forward_t1;
        const lane tangent_forward_t2 = 2.0*I_m_2*along_21*i_g_2 + along_19*(i_g_2*i_g_2);
        const lane tangent_I_2 = along_17 + along_35 + tangent_forward_t2;
        const lane tangent_l_f_1_1 = along_49 + along_6;
        const lane tangent_forward_t3 = F_T*along_31 + along_32*c_T;
        const lane tangent_forward_t4 = along_28*forward_t3 + c_E*tangent_forward_t3;
        const lane tangent_forward_t5 = along_10*t2 + along_12*k_sp_1*t1 + along_26*k_sp_1*w_b_1;
        const lane tangent_forward_t6 = forward_t4*tangent_forward_t5 + forward_t5*tangent_forward_t4;
        const lane tangent_forward_t7 = forward_t3*tangent_forward_t5 + forward_t5*tangent_forward_t3;
        const lane tangent_forward_0 = -t9*tangent_forward_t6 - t9*tangent_l_f_1_1;
        const lane tangent_k_1_1 = forward_0*tangent_forward_t7 + forward_t7*tangent_forward_0;
        const lane tangent_l_f_1_2 = -along_49 + along_7;
        const lane tangent_forward_1 = -t10*tangent_forward_t6 - t10*tangent_l_f_1_2;
        const lane tangent_k_1_2 = forward_1*tangent_forward_t7 + forward_t7*tangent_forward_1;
        const lane tangent_l_f_2_1 = along_50 + along_8;
        const lane tangent_forward_t8 = along_11*t6 + along_13*k_sp_2*t5 + along_27*k_sp_2*w_b_2;
        const lane tangent_forward_t9 = forward_t4*tangent_forward_t8 + forward_t8*tangent_forward_t4;
        const lane tangent_forward_t10 = forward_t3*tangent_forward_t8 + forward_t8*tangent_forward_t3;
        const lane tangent_forward_2 = -t11*tangent_forward_t9 - t11*tangent_l_f_2_1;
        const lane tangent_k_2_1 = forward_2*tangent_forward_t10 + forward_t10*tangent_forward_2;
        const lane tangent_l_f_2_2 = -along_50 + along_9;
        const lane tangent_forward_3 = -t12*tangent_forward_t9 - t12*tangent_l_f_2_2;
        const lane tangent_k_2_2 = forward_3*tangent_forward_t10 + forward_t10*tangent_forward_3;
        const lane tangent_forward_t11 = (1.0/3.0)*along_30;
        const lane tangent_forward_t12 = forward_t11*tangent_l_f_1_1 + l_f_1_1*tangent_forward_t11;
        const lane tangent_forward_t13 = forward_t11*tangent_l_f_1_2 + l_f_1_2*tangent_forward_t11;
        const lane tangent_forward_t14 = tangent_forward_t12 + tangent_forward_t13;
        const lane tangent_forward_t15 = along_1 + along_36;
        const lane tangent_forward_t16 = (1.0/6.0)*along_30;
        const lane tangent_forward_t17 = R_p_1*tangent_forward_t16 + along_14*forward_t16;
        const lane tangent_forward_t18 =
            -forward_t17*tangent_l_f_1_1 - forward_t17*tangent_l_f_1_2 + tangent_forward_t17*(-l_f_1_1
            - l_f_1_2);
        const lane tangent_forward_t19 = forward_t11*tangent_l_f_2_1 + l_f_2_1*tangent_forward_t11;
        const lane tangent_forward_t20 = forward_t11*tangent_l_f_2_2 + l_f_2_2*tangent_forward_t11;
        const lane tangent_forward_t21 = tangent_forward_t19 + tangent_forward_t20;
        const lane tangent_forward_t22 = along_2 + tangent_forward_t15;
        const lane tangent_forward_t23 = R_p_2*tangent_forward_t16 + along_15*forward_t16;
        const lane tangent_forward_t24 =
            -forward_t23*tangent_l_f_2_1 - forward_t23*tangent_l_f_2_2 + tangent_forward_t23*(-l_f_2_1
            - l_f_2_2);
        const lane tangent_forward_t25 = b*tangent_forward_t15 + forward_t15*tangent_b;
        const lane tangent_forward_t26 = 2.0*R_p_1*along_14;
        const lane tangent_forward_t27 = 2.0*R_p_2*along_15;
        const lane tangent_forward_t28 = along_43 + tangent_forward_t22;
        const lane tangent_forward_t29 = 2.0*b*tangent_b;
        const lane tangent_forward_t30 = tangent_k_1_1 + tangent_k_1_2;
        const lane tangent_forward_t31 = R_p_1*tangent_k_1_1 + R_p_1*tangent_k_1_2 + along_14*t13;
        const lane tangent_forward_t32 = tangent_k_2_1 + tangent_k_2_2;
        const lane tangent_forward_t33 = R_p_2*tangent_k_2_1 + R_p_2*tangent_k_2_2 + along_15*t14;
        const lane tangent_forward_t34 = along_33*b + k_C*tangent_b;
        lanes_clear(mass_rate, 121);
        mass_rate[0] = LANES(tangent_forward_t14 + tangent_forward_t15);
        mass_rate[2] = mass_rate[22] = LANES(tangent_forward_t18);
        mass_rate[6] = mass_rate[66] = LANES(tangent_forward_t14);
        mass_rate[8] = mass_rate[88] = LANES(tangent_forward_t15);
        mass_rate[12] = LANES(tangent_forward_t21 + tangent_forward_t22);
        mass_rate[14] = mass_rate[34] = LANES(tangent_forward_t24);
        mass_rate[18] = mass_rate[78] = LANES(tangent_forward_t21);
        mass_rate[20] = mass_rate[100] = LANES(tangent_forward_t22);
        mass_rate[21] = mass_rate[111] = LANES(tangent_forward_t25);
        mass_rate[24] =
            LANES(forward_t26*tangent_forward_t12 + forward_t26*tangent_forward_t13 + tangent_I_1
            + tangent_forward_t26*(forward_t12 + forward_t13));
        mass_rate[26] = mass_rate[46] = LANES(tangent_forward_t1);
        mass_rate[28] = mass_rate[68] = LANES(tangent_forward_t18);
        mass_rate[36] =
            LANES(forward_t27*tangent_forward_t19 + forward_t27*tangent_forward_t20 + tangent_I_2
            + tangent_forward_t27*(forward_t19 + forward_t20));
        mass_rate[38] = mass_rate[58] = LANES(tangent_forward_t2);
        mass_rate[40] = mass_rate[80] = LANES(tangent_forward_t24);
        mass_rate[48] = LANES(tangent_forward_t1);
        mass_rate[60] = LANES(tangent_forward_t2);
        mass_rate[72] = LANES(tangent_forward_t14);
        mass_rate[84] = LANES(tangent_forward_t21);
        mass_rate[96] = LANES(tangent_forward_t28);
        mass_rate[108] = LANES(tangent_forward_t28);
        mass_rate[109] = mass_rate[119] = LANES(tangent_forward_t25);
        mass_rate[120] =
            LANES(along_1*forward_t29 + along_36*forward_t29 + along_47 + forward_t15*tangent_forward_t29);
        lanes_clear(stiffness_rate, 121);
        stiffness_rate[0] = LANES(along_33 + tangent_forward_t30);
        stiffness_rate[2] = stiffness_rate[22] = LANES(tangent_forward_t31);
        stiffness_rate[6] = stiffness_rate[66] = LANES(tangent_forward_t30);
        stiffness_rate[8] = stiffness_rate[88] = LANES(along_33);
        stiffness_rate[10] = stiffness_rate[110] = LANES(-along_4*forward_t15 - g_y*tangent_forward_t15);
        stiffness_rate[12] = LANES(along_33 + tangent_forward_t32);
        stiffness_rate[14] = stiffness_rate[34] = LANES(tangent_forward_t33);
        stiffness_rate[18] = stiffness_rate[78] = LANES(tangent_forward_t32);
        stiffness_rate[20] = stiffness_rate[100] = LANES(along_33);
        stiffness_rate[21] = stiffness_rate[111] = LANES(tangent_forward_t34);
        stiffness_rate[24] =
            LANES(along_39 + forward_t26*tangent_k_1_1 + forward_t26*tangent_k_1_2 + t13*tangent_forward_t26);
        stiffness_rate[26] = stiffness_rate[46] = LANES(along_39);
        stiffness_rate[28] = stiffness_rate[68] = LANES(tangent_forward_t31);
        stiffness_rate[36] =
            LANES(along_39 + forward_t27*tangent_k_2_1 + forward_t27*tangent_k_2_2 + t14*tangent_forward_t27);
        stiffness_rate[38] = stiffness_rate[58] = LANES(along_39);
        stiffness_rate[40] = stiffness_rate[80] = LANES(tangent_forward_t33);
        stiffness_rate[48] = LANES(along_39);
        stiffness_rate[60] = LANES(along_39);
        stiffness_rate[72] = LANES(tangent_forward_t30);
        stiffness_rate[84] = LANES(tangent_forward_t32);
        stiffness_rate[96] = LANES(along_33);
        stiffness_rate[108] = LANES(along_33);
        stiffness_rate[109] = stiffness_rate[119] = LANES(tangent_forward_t34);
        stiffness_rate[120] = LANES(along_33*forward_t29 + k_C*tangent_forward_t29);
        lanes_clear(motion_rate, 22);
        motion_rate[21] = LANES(tangent_b);
        lanes_take(paths, path, mass_rate, stiffness_rate, motion_rate);
    }
}
