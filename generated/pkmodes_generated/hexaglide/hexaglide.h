/* Generated from the derivation of hexaglide.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism hexaglide, for a robot given by its parameters.
 *
 * C99 without allocation; depends only on math.h and memset of the C library.  Matrices are row-major.
 * Numbers are of type double or, in a program compiled with PKMODES_FLOAT defined, of type float.
 * All quantities are in SI units and in the base frame; V is potential energy, forces are -dV/dq, and K
 * is positive for a restoring force.
 * Generalised coordinates, in the order of M and K:
 *   x_1 [m]
 *   x_2 [m]
 *   x_3 [m]
 *   x_4 [m]
 *   x_5 [m]
 *   x_6 [m]
 *   theta_1_1 [rad]
 *   theta_2_1 [rad]
 *   theta_3_1 [rad]
 *   theta_4_1 [rad]
 *   theta_5_1 [rad]
 *   theta_6_1 [rad]
 *   theta_1_2 [rad]
 *   theta_2_2 [rad]
 *   theta_3_2 [rad]
 *   theta_4_2 [rad]
 *   theta_5_2 [rad]
 *   theta_6_2 [rad]
 *
 * Whether a pose can be evaluated comes first:
 *
 *   pkmodes_real p[6] = {...}, f[18], phi[18][18], M[18][18], K[18][18];
 *   if (hexaglide_status(p, parameters) == 0) {
 *       hexaglide_modal_matrices(p, parameters, M, K);
 *       hexaglide_modes(p, parameters, f, phi);
 *   }
 */
#ifndef HEXAGLIDE_H
#define HEXAGLIDE_H

/* The type of every number, and its digits. */
#ifdef PKMODES_FLOAT
#if defined(PKMODES_REAL) && PKMODES_REAL != 24
#error "define PKMODES_FLOAT before the first header of a robot, or in none of them"
#elif !defined(PKMODES_REAL)
#define PKMODES_REAL 24
typedef float pkmodes_real;
#endif
#elif defined(PKMODES_REAL) && PKMODES_REAL != 53
#error "define PKMODES_FLOAT for all headers of robots in a file, or for none"
#elif !defined(PKMODES_REAL)
#define PKMODES_REAL 53
typedef double pkmodes_real;
#endif

/* In single precision the functions have other names: a program can have both, and calls none by mistake. */
#ifdef PKMODES_FLOAT
#define hexaglide_inverse_kinematics hexaglide_inverse_kinematics_f
#define hexaglide_inertia_margin hexaglide_inertia_margin_f
#define hexaglide_rotation_margin hexaglide_rotation_margin_f
#define hexaglide_joint_line_margin hexaglide_joint_line_margin_f
#define hexaglide_leg_margin hexaglide_leg_margin_f
#define hexaglide_reach_margin hexaglide_reach_margin_f
#define hexaglide_travel_margin hexaglide_travel_margin_f
#define hexaglide_belt_spans hexaglide_belt_spans_f
#define hexaglide_platform_joints hexaglide_platform_joints_f
#define hexaglide_constraint_jacobians hexaglide_constraint_jacobians_f
#define hexaglide_jacobian_condition hexaglide_jacobian_condition_f
#define hexaglide_platform_jacobian hexaglide_platform_jacobian_f
#define hexaglide_platform_jacobian_rate hexaglide_platform_jacobian_rate_f
#define hexaglide_platform_second_derivatives hexaglide_platform_second_derivatives_f
#define hexaglide_link_jacobians hexaglide_link_jacobians_f
#define hexaglide_kinetic_energy hexaglide_kinetic_energy_f
#define hexaglide_mass_matrix hexaglide_mass_matrix_f
#define hexaglide_velocity_forces hexaglide_velocity_forces_f
#define hexaglide_gravity_potential hexaglide_gravity_potential_f
#define hexaglide_gravity_gradient hexaglide_gravity_gradient_f
#define hexaglide_gravity_hessian hexaglide_gravity_hessian_f
#define hexaglide_belt_stiffness hexaglide_belt_stiffness_f
#define hexaglide_elastic_potential hexaglide_elastic_potential_f
#define hexaglide_elastic_gradient hexaglide_elastic_gradient_f
#define hexaglide_elastic_hessian hexaglide_elastic_hessian_f
#define hexaglide_static_equilibrium hexaglide_static_equilibrium_f
#define hexaglide_stiffness_matrix hexaglide_stiffness_matrix_f
#define hexaglide_modal_matrices hexaglide_modal_matrices_f
#define hexaglide_status hexaglide_status_f
#define hexaglide_natural_frequencies hexaglide_natural_frequencies_f
#define hexaglide_modes hexaglide_modes_f
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* name of the mechanism */
#define HEXAGLIDE_NAME "hexaglide"
/* version of the generator */
#define HEXAGLIDE_VERSION "0.1.0"
/* SHA-256 of the C source, first digits: other code has another */
#define HEXAGLIDE_HASH "c51710d26bfb9a18"
/* components of a pose */
#define HEXAGLIDE_POSE 6
/* coordinates, and modes */
#define HEXAGLIDE_COORDINATES 18
/* rigid-body modes, the first ones */
#define HEXAGLIDE_RIGID_MODES 6
/* largest condition number of a regular pose */
#ifdef PKMODES_FLOAT
#define HEXAGLIDE_MAX_CONDITION 1000.0f
#else
#define HEXAGLIDE_MAX_CONDITION 1000000.0
#endif
/* status: the eigenproblem has no solution, or rounding leaves it too few digits */
#define HEXAGLIDE_UNSOLVED (-1)
/* status: the pose is not finite */
#define HEXAGLIDE_NOT_FINITE 1
/* status: the platform turns by 90 degrees or more */
#define HEXAGLIDE_BEYOND_ROTATION 2
/* status: the pose is out of reach: a link is too short */
#define HEXAGLIDE_BEYOND_REACHABLE 3
/* status: the pose is singular */
#define HEXAGLIDE_BEYOND_SINGULAR 4
/* status: a carriage is beyond its limits: a belt span would not have a positive length */
#define HEXAGLIDE_BEYOND_LIMITS 5

typedef struct {
    /* [kg] platform mass */
    pkmodes_real platform_mass;
    /* [m] centre of mass of the platform from its origin in platform axes */
    pkmodes_real platform_center[3];
    /* [kg m^2] moment of inertia of the platform about its centre of mass in platform axes */
    pkmodes_real platform_inertia[3];
    /* [kg m^2] entry of the platform's inertia tensor about its centre of mass in platform axes */
    pkmodes_real platform_products[3];
    /* [m/s^2] gravitational acceleration g, base frame */
    pkmodes_real gravity[3];
    /* [m] point of rail j where x_j = 0 */
    pkmodes_real origin[6][3];
    /* [1] unit vector along rail j */
    pkmodes_real direction[6][3];
    /* [m] platform joint j from the platform's origin in platform axes */
    pkmodes_real joint[6][3];
    /* [m] length of rod j */
    pkmodes_real link_length[6];
    /* [kg] mass of rod j */
    pkmodes_real link_mass[6];
    /* [kg] mass of carriage j */
    pkmodes_real carriage_mass[6];
    /* [m] length of carriage j along its rail */
    pkmodes_real carriage_length[6];
    /* [N/m] specific stiffness of belt j: k = w_b k_sp / free length */
    pkmodes_real belt_specific_stiffness[6];
    /* [m] width of belt j */
    pkmodes_real belt_width[6];
    /* [m] radius of the pulleys of axis j */
    pkmodes_real pulley_radius[6];
    /* [kg m^2] moment of inertia of each pulley of axis j */
    pkmodes_real pulley_inertia[6];
    /* [kg m^2] moment of inertia of motor j at the motor shaft */
    pkmodes_real motor_inertia[6];
    /* [1] gear ratio of axis j, motor over driven pulley */
    pkmodes_real gear_ratio[6];
    /* [1] 1 if the motor drives pulley k of axis j, else 0 */
    pkmodes_real drive[6][2];
    /* [m] min(x_j), max(x_j): pulley 2 is at min, pulley 1 at max */
    pkmodes_real limits[6][2];
    /* [1] branch of axis j: +1 if the carriage is ahead of the platform joint along the rail, -1 if behind */
    pkmodes_real branch[6];
} hexaglide_parameters;

/* Carriage positions at a pose.
 *
 * NaN if the pose is out of reach (see `reach_margin`).
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out x [m]: carriage positions x_1, x_2, x_3, x_4, x_5, x_6
 *
 * Source: equations 1 to 3.
 * 306 operations; 13632 with every named value expanded.
 */
void hexaglide_inverse_kinematics(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real x[6]);

/* Whether the platform's inertia is that of a body.
 *
 *   out margin [1]: none is negative for a body
 *
 * Source: principal minors of its second moments of mass, divided by powers of the trace.
 * 96 operations; 162 with every named value expanded.
 */
void hexaglide_inertia_margin(const hexaglide_parameters *parameters, pkmodes_real margin[7]);

/* By how much the rotation of the platform is less than 90 degrees.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out margin [rad]: positive for a rotation below 90 degrees
 *
 * Source: the norm of the rotation vector.
 * 9 operations; 9 with every named value expanded.
 */
void hexaglide_rotation_margin(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real *margin);

/* Whether the joints on the platform do not lie in a line.
 *
 *   out margin [m^4]: positive for points that span a plane
 *
 * Source: second invariant of their second moments about their mean.
 * 202 operations; 982 with every named value expanded.
 */
void hexaglide_joint_line_margin(const hexaglide_parameters *parameters, pkmodes_real *margin);

/* Whether no two legs coincide.
 *
 *   out margin [m^2]: positive for two legs that differ
 *
 * Source: sums of squared differences; numbers count times the rms distance of the platform joints.
 * 733 operations; 2280 with every named value expanded.
 */
void hexaglide_leg_margin(const hexaglide_parameters *parameters, pkmodes_real margin[15]);

/* Distance by which each platform joint could be farther from its rail.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out margin [m]: link length minus distance of the platform joint from its rail, for each axis
 *
 * Source: closure of equation 2; a pose is reachable if every margin is at least zero.
 * 288 operations; 10902 with every named value expanded.
 */
void hexaglide_reach_margin(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real margin[6]);

/* Sum of the lengths of the two belt spans at each carriage, the same at every pose.
 *
 *   out margin [m]: max - min - l_t for each axis; positive for a robot that can move
 *
 * Source: sum of equations 36 and 37.
 * 12 operations; 12 with every named value expanded.
 */
void hexaglide_travel_margin(const hexaglide_parameters *parameters, pkmodes_real margin[6]);

/* Free lengths of the belt spans.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out l_f [m]: free length l_f[j-1, s-1] of span s of belt j
 *
 * Source: equations 35 to 37; a pose is within the limits if all are positive.
 * 342 operations; 27306 with every named value expanded.
 */
void hexaglide_belt_spans(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real l_f[6][3]);

/* How the joints lie on the platform: a characteristic length, and their middle.
 *
 *   out length [m]: root mean square distance of the platform joints from the platform's origin
 *   out middle [m]: middle of the platform joints from that origin, platform axes
 *
 * Source: the condition number of D_l, in which the length makes rotations comparable with displacements.
 * 88 operations; 88 with every named value expanded.
 */
void hexaglide_platform_joints(const hexaglide_parameters *parameters, pkmodes_real *length,
    pkmodes_real middle[3]);

/* Constraint Jacobians D_l and D_r of D_l p_dot = D_r x_dot.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out D_l [m, m^2]: row j: linkage vector c_j - e_j in the base frame, and its moment about the platform's
 *     origin
 *   out D_r [m]: diagonal: component of linkage vector j along the motion of its joint
 *
 * Source: equations 14 and 15.
 * 426 operations; 179832 with every named value expanded.
 */
void hexaglide_constraint_jacobians(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real D_l[6][6], pkmodes_real D_r[6][6]);

/* Assembly branch and condition number of D_l in the Frobenius norm.
 *
 * Moments are divided by a characteristic length, the root mean square distance of the platform joints from
 * the platform's origin.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out determinant [m^9]: det D_l; its sign is the assembly branch
 *   out condition [1]: Frobenius condition number, at least 6
 *
 * Source: equation 15; |D_l| |D_l^-1|, one to six times the condition number in the 2-norm.
 * 1817 operations; 186565260 with every named value expanded.
 */
void hexaglide_jacobian_condition(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real *determinant, pkmodes_real *condition);

/* Platform Jacobian D_p = D_l^-1 D_r.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out D_p [1, 1/m]: dp_i/dq_k, base frame
 *
 * Source: equation 15.
 * 1634 operations; 182257128 with every named value expanded.
 */
void hexaglide_platform_jacobian(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real D_p[6][6]);

/* Time derivative of the platform Jacobian.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  x_dot [m/s]: carriage velocities
 *   out D_p_dot [1/s, 1/(m s)]: d(D_p)/dt at x_dot
 *
 * Source: equation 17.
 * 4250 operations; 271189556208 with every named value expanded.
 */
void hexaglide_platform_jacobian_rate(const pkmodes_real p[6], const pkmodes_real x_dot[6],
    const hexaglide_parameters *parameters, pkmodes_real D_p_dot[6][6]);

/* Second derivatives of the platform position with respect to the carriage positions.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out P [1/m, 1/m^2]: d2p_i/dq_k dq_l as P[i, k, l], of rotations in the exponential chart at the pose
 *
 * Source: equation 49, by the implicit function theorem to second order.
 * 7766 operations; 324095706684 with every named value expanded.
 */
void hexaglide_platform_second_derivatives(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real P[6][6][6]);

/* Jacobians of the linkages: centre of mass and angular velocity.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out D_d [1]: D_d[j-1] x_dot is the velocity of the centre of mass of linkage j
 *   out D_omega [1/m]: D_omega[j-1] x_dot is the angular velocity of linkage j
 *
 * Source: equations 16 and 23; the angular velocity without spin about the rod, which carries no energy.
 * 3020 operations; 4904818992 with every named value expanded.
 */
void hexaglide_link_jacobians(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real D_d[6][3][6], pkmodes_real D_omega[6][3][6]);

/* Kinetic energies of the structure and of the transmissions.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  q_dot [m/s, rad/s]: rates of the 18 generalised coordinates
 *   out T_ss [J]: platform and the bodies that move it
 *   out T_t [J]: rotors and motors
 *
 * Source: equations 24 and 28.
 * 2411 operations; 6454344861 with every named value expanded.
 */
void hexaglide_kinetic_energy(const pkmodes_real p[6], const pkmodes_real q_dot[18],
    const hexaglide_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t);

/* Mass matrix M in the 18 generalised coordinates.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out M [kg, kg m^2]: symmetric; block diagonal: M_ss (6 by 6) and the diagonal M_t
 *
 * Source: equations 24, 30 and 33.
 * 2883 operations; 6551532102 with every named value expanded.
 */
void hexaglide_mass_matrix(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real M[18][18]);

/* Coriolis and centrifugal forces h of M_ss x_ddot + h + grad V = Q.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  x_dot [m/s]: carriage velocities
 *   out h [N]: generalised forces conjugate to the carriage positions
 *
 * Source: Lagrange's equations; equation 47 before linearisation.
 * 6739 operations; 8379579046728 with every named value expanded.
 */
void hexaglide_velocity_forces(const pkmodes_real p[6], const pkmodes_real x_dot[6],
    const hexaglide_parameters *parameters, pkmodes_real h[6]);

/* Gravitational potential energy V_g = -U_g, with the force function U_g.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out V_g [J]: zero at the origin of the base frame
 *
 * Source: equation 26, for gravity in any direction and all moving bodies.
 * 540 operations; 85200 with every named value expanded.
 */
void hexaglide_gravity_potential(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real *V_g);

/* Gradient of the gravitational potential energy with respect to the carriage positions.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out G [N]: dV_g/dq_k
 *
 * Source: equation 27.
 * 1951 operations; 182295552 with every named value expanded.
 */
void hexaglide_gravity_gradient(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real G[6]);

/* Hessian of the gravitational potential energy with respect to the carriage positions.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out H_g [N/m]: d2V_g/dq_k dq_l, symmetric
 *
 * Source: section 4 and equation 49.
 * 3125 operations; 96468736266 with every named value expanded.
 */
void hexaglide_gravity_hessian(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real H_g[6][6]);

/* Stiffnesses of the belt spans.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out k [N/m]: k[j-1, s-1] of span s of belt j, as in `belt_spans`
 *
 * Source: equations 34 to 37.
 * 366 operations; 27342 with every named value expanded.
 */
void hexaglide_belt_stiffness(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real k[6][3]);

/* Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  delta_q [m, rad]: small displacements of the 18 generalised coordinates from the reference
 *     configuration at p
 *   out V_el [J]: zero in the reference configuration
 *
 * Source: equation 38, summed.
 * 467 operations; 27455 with every named value expanded.
 */
void hexaglide_elastic_potential(const pkmodes_real p[6], const pkmodes_real delta_q[18],
    const hexaglide_parameters *parameters, pkmodes_real *V_el);

/* Gradient of the elastic potential energy.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  delta_q [m, rad]: small displacements of the 18 generalised coordinates from the reference
 *     configuration at p
 *   out E [N, N m]: dV_el/dq
 *
 * Source: equation 38 differentiated.
 * 522 operations; 54882 with every named value expanded.
 */
void hexaglide_elastic_gradient(const pkmodes_real p[6], const pkmodes_real delta_q[18],
    const hexaglide_parameters *parameters, pkmodes_real E[18]);

/* Hessian of the elastic potential energy.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out H_el [N/m, N, N m]: d2V_el/dq2, symmetric, with six zero eigenvalues
 *
 * Source: equation 38 differentiated twice.
 * 438 operations; 109518 with every named value expanded.
 */
void hexaglide_elastic_hessian(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real H_el[18][18]);

/* Drive torques that hold the pose, and the corresponding rotations.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out tau_st [N m]: torques on the driven rotors, positive in the direction of their rotation
 *   out theta_st [rad]: rotations relative to the unstrained transmissions, in the order of the coordinates
 *
 * Source: equation 44, solved at the pose.
 * 2209 operations; 1458941046 with every named value expanded.
 */
void hexaglide_static_equilibrium(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real tau_st[6], pkmodes_real theta_st[12]);

/* Stiffness matrix K in the 18 generalised coordinates.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out K [N/m, N, N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equations 46 and 48: K = -H_U.
 * 3263 operations; 96468845790 with every named value expanded.
 */
void hexaglide_stiffness_matrix(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real K[18][18]);

/* Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.
 *
 * Common intermediate values are evaluated once: call this function for an eigenproblem.
 *
 * Call `hexaglide_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out M [kg, kg m^2]: mass matrix
 *   out K [N/m, N, N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equation 48.
 * 4479 operations; 103020377892 with every named value expanded.
 */
void hexaglide_modal_matrices(const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real M[18][18], pkmodes_real K[18][18]);

/* Why a pose cannot be evaluated: a status above, or 0 where it can.  The functions above do not check the
 * pose, and return NaN or numbers without meaning where this is not 0.
 */
int hexaglide_status(const pkmodes_real p[6], const hexaglide_parameters *parameters);

/* Natural frequencies sqrt(|lambda|)/(2 pi) with the sign of lambda [Hz], ascending, rigid-body modes first,
 * of motors that are free to turn.
 * Return 0; otherwise the status of the pose or HEXAGLIDE_UNSOLVED, and f has no meaning.
 *
 * The error of lambda is rounding of the largest one.  So the relative error of a frequency f is some 1e-15,
 * in single precision 1e-6, times the square of (highest frequency / f), and larger near singular poses.
 * Where this leaves a vibration fewer than six digits, in single precision hardly two, the status is
 * HEXAGLIDE_UNSOLVED.
 */
int hexaglide_natural_frequencies(
    const pkmodes_real p[6], const hexaglide_parameters *parameters, pkmodes_real f[18]);

/* The same with mode shapes: row i of phi is mode i, mass-normalised (phi^T M phi = 1).  phi may be NULL.
 * Return 0; otherwise a status as above, and f and phi have no meaning.
 */
int hexaglide_modes(
    const pkmodes_real p[6], const hexaglide_parameters *parameters,
    pkmodes_real f[18], pkmodes_real phi[18][18]);

#ifdef __cplusplus
}
#endif

#endif
