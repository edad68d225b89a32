/* Generated from the derivation of linear_delta.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism linear_delta, for a robot given by its parameters.
 *
 * C99 without allocation; depends only on math.h and memset of the C library.  Matrices are row-major.
 * Numbers are of type double or, in a program compiled with PKMODES_FLOAT defined, of type float.
 * All quantities are in SI units and in the base frame; V is potential energy, forces are -dV/dq, and K
 * is positive for a restoring force.
 * Generalised coordinates, in the order of M and K:
 *   x_1 [m]
 *   x_2 [m]
 *   x_3 [m]
 *   theta_1_1 [rad]
 *   theta_2_1 [rad]
 *   theta_3_1 [rad]
 *   theta_1_2 [rad]
 *   theta_2_2 [rad]
 *   theta_3_2 [rad]
 *
 * Whether a pose can be evaluated comes first:
 *
 *   pkmodes_real p[3] = {...}, f[9], phi[9][9], M[9][9], K[9][9];
 *   if (linear_delta_status(p, parameters) == 0) {
 *       linear_delta_modal_matrices(p, parameters, M, K);
 *       linear_delta_modes(p, parameters, f, phi);
 *   }
 */
#ifndef LINEAR_DELTA_H
#define LINEAR_DELTA_H

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
#define linear_delta_inverse_kinematics linear_delta_inverse_kinematics_f
#define linear_delta_reach_margin linear_delta_reach_margin_f
#define linear_delta_travel_margin linear_delta_travel_margin_f
#define linear_delta_direct_kinematics linear_delta_direct_kinematics_f
#define linear_delta_belt_spans linear_delta_belt_spans_f
#define linear_delta_constraint_jacobians linear_delta_constraint_jacobians_f
#define linear_delta_jacobian_condition linear_delta_jacobian_condition_f
#define linear_delta_platform_jacobian linear_delta_platform_jacobian_f
#define linear_delta_platform_jacobian_rate linear_delta_platform_jacobian_rate_f
#define linear_delta_platform_second_derivatives linear_delta_platform_second_derivatives_f
#define linear_delta_link_jacobians linear_delta_link_jacobians_f
#define linear_delta_kinetic_energy linear_delta_kinetic_energy_f
#define linear_delta_mass_matrix linear_delta_mass_matrix_f
#define linear_delta_velocity_forces linear_delta_velocity_forces_f
#define linear_delta_gravity_potential linear_delta_gravity_potential_f
#define linear_delta_gravity_gradient linear_delta_gravity_gradient_f
#define linear_delta_gravity_hessian linear_delta_gravity_hessian_f
#define linear_delta_belt_stiffness linear_delta_belt_stiffness_f
#define linear_delta_elastic_potential linear_delta_elastic_potential_f
#define linear_delta_elastic_gradient linear_delta_elastic_gradient_f
#define linear_delta_elastic_hessian linear_delta_elastic_hessian_f
#define linear_delta_static_equilibrium linear_delta_static_equilibrium_f
#define linear_delta_stiffness_matrix linear_delta_stiffness_matrix_f
#define linear_delta_modal_matrices linear_delta_modal_matrices_f
#define linear_delta_status linear_delta_status_f
#define linear_delta_natural_frequencies linear_delta_natural_frequencies_f
#define linear_delta_modes linear_delta_modes_f
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* name of the mechanism */
#define LINEAR_DELTA_NAME "linear_delta"
/* version of the generator */
#define LINEAR_DELTA_VERSION "0.1.0"
/* SHA-256 of the C source, first digits: other code has another */
#define LINEAR_DELTA_HASH "d94b30b9518f8838"
/* components of a pose */
#define LINEAR_DELTA_POSE 3
/* coordinates, and modes */
#define LINEAR_DELTA_COORDINATES 9
/* rigid-body modes, the first ones */
#define LINEAR_DELTA_RIGID_MODES 3
/* largest condition number of a regular pose */
#ifdef PKMODES_FLOAT
#define LINEAR_DELTA_MAX_CONDITION 1000.0f
#else
#define LINEAR_DELTA_MAX_CONDITION 1000000.0
#endif
/* status: the eigenproblem has no solution, or rounding leaves it too few digits */
#define LINEAR_DELTA_UNSOLVED (-1)
/* status: the pose is not finite */
#define LINEAR_DELTA_NOT_FINITE 1
/* status: the pose is out of reach: a link is too short */
#define LINEAR_DELTA_BEYOND_REACHABLE 2
/* status: the pose is singular */
#define LINEAR_DELTA_BEYOND_SINGULAR 3
/* status: a carriage is beyond its limits: a belt span would not have a positive length */
#define LINEAR_DELTA_BEYOND_LIMITS 4

typedef struct {
    /* [kg] platform mass */
    pkmodes_real platform_mass;
    /* [m/s^2] gravitational acceleration g, base frame */
    pkmodes_real gravity[3];
    /* [m] point of rail j where x_j = 0 */
    pkmodes_real origin[3][3];
    /* [1] unit vector along rail j */
    pkmodes_real direction[3][3];
    /* [m] platform joint j relative to the platform centre */
    pkmodes_real joint[3][3];
    /* [m] length of linkage j */
    pkmodes_real link_length[3];
    /* [kg] mass of linkage j, both rods together */
    pkmodes_real link_mass[3];
    /* [kg] mass of carriage j */
    pkmodes_real carriage_mass[3];
    /* [m] length of carriage j along its rail */
    pkmodes_real carriage_length[3];
    /* [N/m] specific stiffness of belt j: k = w_b k_sp / free length */
    pkmodes_real belt_specific_stiffness[3];
    /* [m] width of belt j */
    pkmodes_real belt_width[3];
    /* [m] radius of the pulleys of axis j */
    pkmodes_real pulley_radius[3];
    /* [kg m^2] moment of inertia of each pulley of axis j */
    pkmodes_real pulley_inertia[3];
    /* [kg m^2] moment of inertia of motor j at the motor shaft */
    pkmodes_real motor_inertia[3];
    /* [1] gear ratio of axis j, motor over driven pulley */
    pkmodes_real gear_ratio[3];
    /* [1] 1 if the motor drives pulley k of axis j, else 0 */
    pkmodes_real drive[3][2];
    /* [m] min(x_j), max(x_j): pulley 2 is at min, pulley 1 at max */
    pkmodes_real limits[3][2];
    /* [1] branch of axis j: +1 if the carriage is ahead of the platform joint along the rail, -1 if behind */
    pkmodes_real branch[3];
} linear_delta_parameters;

/* Carriage positions at a pose.
 *
 * NaN if the pose is out of reach (see `reach_margin`).
 *
 *   in  p [m]: platform centre in the base frame
 *   out x [m]: carriage positions x_1, x_2, x_3
 *
 * Source: equations 1 to 3.
 * 84 operations; 201 with every named value expanded.
 */
void linear_delta_inverse_kinematics(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real x[3]);

/* Distance by which each platform joint could be farther from its rail.
 *
 *   in  p [m]: platform centre in the base frame
 *   out margin [m]: link length minus distance of the platform joint from its rail, for each axis
 *
 * Source: closure of equation 2; a pose is reachable if every margin is at least zero.
 * 75 operations; 159 with every named value expanded.
 */
void linear_delta_reach_margin(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real margin[3]);

/* Sum of the lengths of the two belt spans at each carriage, the same at every pose.
 *
 *   out margin [m]: max - min - l_t for each axis; positive for a robot that can move
 *
 * Source: sum of equations 36 and 37.
 * 6 operations; 6 with every named value expanded.
 */
void linear_delta_travel_margin(const linear_delta_parameters *parameters, pkmodes_real margin[3]);

/* Platform centre in the base frame for given carriage positions.
 *
 * NaN if the three spheres do not intersect.
 *
 *   in  x [m]: carriage positions x_1, x_2, x_3
 *   in  assembly [1]: assembly branch, +1 or -1: the sign of det D_l at the desired platform centre
 *   out p [m]: platform centre in the base frame
 *
 * Source: equation 3: intersection of three spheres.
 * 123 operations; 4398 with every named value expanded.
 */
void linear_delta_direct_kinematics(const pkmodes_real x[3], pkmodes_real assembly,
    const linear_delta_parameters *parameters, pkmodes_real p[3]);

/* Free lengths of the belt spans.
 *
 *   in  p [m]: platform centre in the base frame
 *   out l_f [m]: free length l_f[j-1, s-1] of span s of belt j
 *
 * Source: equations 35 to 37; a pose is within the limits if all are positive.
 * 102 operations; 423 with every named value expanded.
 */
void linear_delta_belt_spans(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real l_f[3][3]);

/* Constraint Jacobians D_l and D_r of D_l p_dot = D_r x_dot.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out D_l [m]: row j: linkage vector c_j - e_j in the base frame
 *   out D_r [m]: diagonal: component of linkage vector j along the motion of its joint
 *
 * Source: equations 14 and 15.
 * 117 operations; 1293 with every named value expanded.
 */
void linear_delta_constraint_jacobians(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real D_l[3][3], pkmodes_real D_r[3][3]);

/* Assembly branch and condition number of D_l in the Frobenius norm.
 *
 *   in  p [m]: platform centre in the base frame
 *   out determinant [m^3]: det D_l; its sign is the assembly branch
 *   out condition [1]: Frobenius condition number, at least 3
 *
 * Source: equation 15; |D_l| |D_l^-1|, one to three times the condition number in the 2-norm.
 * 184 operations; 14069 with every named value expanded.
 */
void linear_delta_jacobian_condition(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real *determinant, pkmodes_real *condition);

/* Platform Jacobian D_p = D_l^-1 D_r.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out D_p [1]: dp_i/dq_k, base frame
 *
 * Source: equation 15.
 * 162 operations; 14274 with every named value expanded.
 */
void linear_delta_platform_jacobian(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real D_p[3][3]);

/* Time derivative of the platform Jacobian.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  x_dot [m/s]: carriage velocities
 *   out D_p_dot [1/s]: d(D_p)/dt at x_dot
 *
 * Source: equation 17.
 * 330 operations; 660699 with every named value expanded.
 */
void linear_delta_platform_jacobian_rate(const pkmodes_real p[3], const pkmodes_real x_dot[3],
    const linear_delta_parameters *parameters, pkmodes_real D_p_dot[3][3]);

/* Second derivatives of the platform position with respect to the carriage positions.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out P [1/m]: d2p_i/dq_k dq_l as P[i, k, l]
 *
 * Source: equation 49, by the implicit function theorem to second order.
 * 369 operations; 695493 with every named value expanded.
 */
void linear_delta_platform_second_derivatives(const pkmodes_real p[3],
    const linear_delta_parameters *parameters, pkmodes_real P[3][3][3]);

/* Jacobians of the linkages: centre of mass and angular velocity.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out D_d [1]: D_d[j-1] x_dot is the velocity of the centre of mass of linkage j
 *   out D_omega [1/m]: D_omega[j-1] x_dot is the angular velocity of linkage j
 *
 * Source: equations 16 and 23; the angular velocity without spin about the rod, which carries no energy.
 * 309 operations; 132498 with every named value expanded.
 */
void linear_delta_link_jacobians(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real D_d[3][3][3], pkmodes_real D_omega[3][3][3]);

/* Kinetic energies of the structure and of the transmissions.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  q_dot [m/s, rad/s]: rates of the nine generalised coordinates
 *   out T_ss [J]: platform and the bodies that move it
 *   out T_t [J]: rotors and motors
 *
 * Source: equations 24 and 28.
 * 275 operations; 28717 with every named value expanded.
 */
void linear_delta_kinetic_energy(const pkmodes_real p[3], const pkmodes_real q_dot[9],
    const linear_delta_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t);

/* Mass matrix M in the nine generalised coordinates.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out M [kg, kg m^2]: symmetric; block diagonal: M_ss (3 by 3) and the diagonal M_t
 *
 * Source: equations 24, 30 and 33.
 * 288 operations; 128922 with every named value expanded.
 */
void linear_delta_mass_matrix(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real M[9][9]);

/* Coriolis and centrifugal forces h of M_ss x_ddot + h + grad V = Q.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  x_dot [m/s]: carriage velocities
 *   out h [N]: generalised forces conjugate to the carriage positions
 *
 * Source: Lagrange's equations; equation 47 before linearisation.
 * 711 operations; 3553737 with every named value expanded.
 */
void linear_delta_velocity_forces(const pkmodes_real p[3], const pkmodes_real x_dot[3],
    const linear_delta_parameters *parameters, pkmodes_real h[3]);

/* Gravitational potential energy V_g = -U_g, with the force function U_g.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out V_g [J]: zero at the origin of the base frame
 *
 * Source: equation 26, for gravity in any direction and all moving bodies.
 * 195 operations; 1368 with every named value expanded.
 */
void linear_delta_gravity_potential(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real *V_g);

/* Gradient of the gravitational potential energy with respect to the carriage positions.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out G [N]: dV_g/dq_k
 *
 * Source: equation 27.
 * 234 operations; 14409 with every named value expanded.
 */
void linear_delta_gravity_gradient(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real G[3]);

/* Hessian of the gravitational potential energy with respect to the carriage positions.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out H_g [N/m]: d2V_g/dq_k dq_l, symmetric
 *
 * Source: section 4 and equation 49.
 * 345 operations; 373806 with every named value expanded.
 */
void linear_delta_gravity_hessian(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real H_g[3][3]);

/* Stiffnesses of the belt spans.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out k [N/m]: k[j-1, s-1] of span s of belt j, as in `belt_spans`
 *
 * Source: equations 34 to 37.
 * 114 operations; 441 with every named value expanded.
 */
void linear_delta_belt_stiffness(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real k[3][3]);

/* Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  delta_q [m, rad]: small displacements of the nine generalised coordinates from the reference
 *     configuration at p
 *   out V_el [J]: zero in the reference configuration
 *
 * Source: equation 38, summed.
 * 164 operations; 497 with every named value expanded.
 */
void linear_delta_elastic_potential(const pkmodes_real p[3], const pkmodes_real delta_q[9],
    const linear_delta_parameters *parameters, pkmodes_real *V_el);

/* Gradient of the elastic potential energy.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  delta_q [m, rad]: small displacements of the nine generalised coordinates from the reference
 *     configuration at p
 *   out E [N, N m]: dV_el/dq
 *
 * Source: equation 38 differentiated.
 * 192 operations; 981 with every named value expanded.
 */
void linear_delta_elastic_gradient(const pkmodes_real p[3], const pkmodes_real delta_q[9],
    const linear_delta_parameters *parameters, pkmodes_real E[9]);

/* Hessian of the elastic potential energy.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out H_el [N/m, N, N m]: d2V_el/dq2, symmetric, with three zero eigenvalues
 *
 * Source: equation 38 differentiated twice.
 * 150 operations; 1839 with every named value expanded.
 */
void linear_delta_elastic_hessian(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real H_el[9][9]);

/* Drive torques that hold the pose, and the corresponding rotations.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out tau_st [N m]: torques on the driven rotors, positive in the direction of their rotation
 *   out theta_st [rad]: rotations relative to the unstrained transmissions, in the order of the coordinates
 *
 * Source: equation 44, solved at the pose.
 * 363 operations; 125757 with every named value expanded.
 */
void linear_delta_static_equilibrium(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real tau_st[3], pkmodes_real theta_st[6]);

/* Stiffness matrix K in the nine generalised coordinates.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out K [N/m, N, N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equations 46 and 48: K = -H_U.
 * 411 operations; 375645 with every named value expanded.
 */
void linear_delta_stiffness_matrix(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real K[9][9]);

/* Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.
 *
 * Common intermediate values are evaluated once: call this function for an eigenproblem.
 *
 * Call `linear_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out M [kg, kg m^2]: mass matrix
 *   out K [N/m, N, N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equation 48.
 * 537 operations; 504567 with every named value expanded.
 */
void linear_delta_modal_matrices(const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real M[9][9], pkmodes_real K[9][9]);

/* Why a pose cannot be evaluated: a status above, or 0 where it can.  The functions above do not check the
 * pose, and return NaN or numbers without meaning where this is not 0.
 */
int linear_delta_status(const pkmodes_real p[3], const linear_delta_parameters *parameters);

/* Natural frequencies sqrt(|lambda|)/(2 pi) with the sign of lambda [Hz], ascending, rigid-body modes first,
 * of motors that are free to turn.
 * Return 0; otherwise the status of the pose or LINEAR_DELTA_UNSOLVED, and f has no meaning.
 *
 * The error of lambda is rounding of the largest one.  So the relative error of a frequency f is some 1e-15,
 * in single precision 1e-6, times the square of (highest frequency / f), and larger near singular poses.
 * Where this leaves a vibration fewer than six digits, in single precision hardly two, the status is
 * LINEAR_DELTA_UNSOLVED.
 */
int linear_delta_natural_frequencies(
    const pkmodes_real p[3], const linear_delta_parameters *parameters, pkmodes_real f[9]);

/* The same with mode shapes: row i of phi is mode i, mass-normalised (phi^T M phi = 1).  phi may be NULL.
 * Return 0; otherwise a status as above, and f and phi have no meaning.
 */
int linear_delta_modes(
    const pkmodes_real p[3], const linear_delta_parameters *parameters,
    pkmodes_real f[9], pkmodes_real phi[9][9]);

#ifdef __cplusplus
}
#endif

#endif
