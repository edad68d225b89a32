/* Generated from the derivation of bed_slinger.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism bed_slinger, for a robot given by its parameters.
 *
 * C99 without allocation; depends only on math.h and memset of the C library.  Matrices are row-major.
 * Numbers are of type double or, in a program compiled with PKMODES_FLOAT defined, of type float.
 * All quantities are in SI units and in the base frame; V is potential energy, forces are -dV/dq, and K
 * is positive for a restoring force.
 * Generalised coordinates, in the order of M and K:
 *   x [m]
 *   y [m]
 *   theta_1 [rad]
 *   theta_2 [rad]
 *
 * Whether a pose can be evaluated comes first:
 *
 *   pkmodes_real p[2] = {...}, f[4], phi[4][4], M[4][4], K[4][4];
 *   if (bed_slinger_status(p, parameters) == 0) {
 *       bed_slinger_modal_matrices(p, parameters, M, K);
 *       bed_slinger_modes(p, parameters, f, phi);
 *   }
 */
#ifndef BED_SLINGER_H
#define BED_SLINGER_H

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
#define bed_slinger_inverse_kinematics bed_slinger_inverse_kinematics_f
#define bed_slinger_travel_margin bed_slinger_travel_margin_f
#define bed_slinger_run_margin bed_slinger_run_margin_f
#define bed_slinger_belt_spans bed_slinger_belt_spans_f
#define bed_slinger_platform_jacobian bed_slinger_platform_jacobian_f
#define bed_slinger_platform_jacobian_rate bed_slinger_platform_jacobian_rate_f
#define bed_slinger_platform_second_derivatives bed_slinger_platform_second_derivatives_f
#define bed_slinger_kinetic_energy bed_slinger_kinetic_energy_f
#define bed_slinger_mass_matrix bed_slinger_mass_matrix_f
#define bed_slinger_velocity_forces bed_slinger_velocity_forces_f
#define bed_slinger_gravity_potential bed_slinger_gravity_potential_f
#define bed_slinger_gravity_gradient bed_slinger_gravity_gradient_f
#define bed_slinger_gravity_hessian bed_slinger_gravity_hessian_f
#define bed_slinger_belt_stiffness bed_slinger_belt_stiffness_f
#define bed_slinger_elastic_potential bed_slinger_elastic_potential_f
#define bed_slinger_elastic_gradient bed_slinger_elastic_gradient_f
#define bed_slinger_elastic_hessian bed_slinger_elastic_hessian_f
#define bed_slinger_static_equilibrium bed_slinger_static_equilibrium_f
#define bed_slinger_stiffness_matrix bed_slinger_stiffness_matrix_f
#define bed_slinger_modal_matrices bed_slinger_modal_matrices_f
#define bed_slinger_status bed_slinger_status_f
#define bed_slinger_natural_frequencies bed_slinger_natural_frequencies_f
#define bed_slinger_modes bed_slinger_modes_f
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* name of the mechanism */
#define BED_SLINGER_NAME "bed_slinger"
/* version of the generator */
#define BED_SLINGER_VERSION "0.1.0"
/* SHA-256 of the C source, first digits: other code has another */
#define BED_SLINGER_HASH "4e293a9aa064942b"
/* components of a pose */
#define BED_SLINGER_POSE 2
/* coordinates, and modes */
#define BED_SLINGER_COORDINATES 4
/* rigid-body modes, the first ones */
#define BED_SLINGER_RIGID_MODES 2
/* status: the eigenproblem has no solution, or rounding leaves it too few digits */
#define BED_SLINGER_UNSOLVED (-1)
/* status: the pose is not finite */
#define BED_SLINGER_NOT_FINITE 1
/* status: the tool head or the bed is beyond its travel */
#define BED_SLINGER_BEYOND_LIMITS 2

typedef struct {
    /* [kg] mass of the tool head */
    pkmodes_real toolhead_mass;
    /* [kg] mass of the bed */
    pkmodes_real bed_mass;
    /* [m/s^2] gravitational acceleration g, base frame */
    pkmodes_real gravity[3];
    /* [m] free length of run k of belt j with its slide at 0 */
    pkmodes_real axis_lengths[2][2];
    /* [N/m] specific stiffness of belt j: k = w_b k_sp / free length */
    pkmodes_real belt_specific_stiffness[2];
    /* [m] width of belt j */
    pkmodes_real belt_width[2];
    /* [m] radius of motor pulley j */
    pkmodes_real pulley_radius[2];
    /* [kg m^2] moment of inertia of motor pulley j */
    pkmodes_real pulley_inertia[2];
    /* [kg m^2] moment of inertia of motor j at its shaft */
    pkmodes_real motor_inertia[2];
    /* [1] gear ratio of motor j, motor over pulley */
    pkmodes_real gear_ratio[2];
    /* [m] travel of the tool head along x and of the bed along y */
    pkmodes_real workspace[2][2];
} bed_slinger_parameters;

/* Positions at a pose.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out xy [m]: positions x, y
 *
 * Source: the pose itself.
 * 0 operations; 0 with every named value expanded.
 */
void bed_slinger_inverse_kinematics(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real xy[2]);

/* Distance of tool head and bed from the ends of their travel.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out margin [m]: for x and y: above the lower end and below the upper end
 *
 * Source: both ends of the workspace.
 * 4 operations; 4 with every named value expanded.
 */
void bed_slinger_travel_margin(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real margin[2][2]);

/* Shortest free length of each run in the whole workspace.
 *
 *   out margin [m]: for runs 1 and 2 of each belt; must be positive
 *
 * Source: the lengths are linear in x and y, so the shortest is at a corner.
 * 4 operations; 4 with every named value expanded.
 */
void bed_slinger_run_margin(const bed_slinger_parameters *parameters, pkmodes_real margin[2][2]);

/* Free lengths of the belt spans.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out l_f [m]: free length l_f[j-1, s-1] of span s of belt j
 *
 * Source: equations 35 to 37; a pose is within the limits if all are positive.
 * 4 operations; 4 with every named value expanded.
 */
void bed_slinger_belt_spans(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real l_f[2][2]);

/* Platform Jacobian D_p.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out D_p [1]: dp_i/dq_k, base frame
 *
 * Source: equation 15.
 * 0 operations; 0 with every named value expanded.
 */
void bed_slinger_platform_jacobian(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real D_p[2][2]);

/* Time derivative of the platform Jacobian.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   in  xy_dot [m/s]: velocities
 *   out D_p_dot [1/s]: d(D_p)/dt at xy_dot
 *
 * Source: equation 17.
 * 0 operations; 0 with every named value expanded.
 */
void bed_slinger_platform_jacobian_rate(const pkmodes_real p[2], const pkmodes_real xy_dot[2],
    const bed_slinger_parameters *parameters, pkmodes_real D_p_dot[2][2]);

/* Second derivatives of the platform position with respect to the positions.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out P [1/m]: d2p_i/dq_k dq_l as P[i, k, l]
 *
 * Source: equation 49, by the implicit function theorem to second order.
 * 0 operations; 0 with every named value expanded.
 */
void bed_slinger_platform_second_derivatives(const pkmodes_real p[2],
    const bed_slinger_parameters *parameters, pkmodes_real P[2][2][2]);

/* Kinetic energies of the structure and of the transmissions.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   in  q_dot [m/s, rad/s]: rates of the four generalised coordinates
 *   out T_ss [J]: platform and the bodies that move it
 *   out T_t [J]: rotors and motors
 *
 * Source: equations 24 and 28.
 * 20 operations; 20 with every named value expanded.
 */
void bed_slinger_kinetic_energy(const pkmodes_real p[2], const pkmodes_real q_dot[4],
    const bed_slinger_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t);

/* Mass matrix M in the four generalised coordinates.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out M [kg, kg m^2]: symmetric
 *
 * Source: equations 24, 30 and 33.
 * 6 operations; 6 with every named value expanded.
 */
void bed_slinger_mass_matrix(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real M[4][4]);

/* Coriolis and centrifugal forces h of M_ss xy_ddot + h + grad V = Q.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   in  xy_dot [m/s]: velocities
 *   out h [N]: generalised forces conjugate to the positions
 *
 * Source: Lagrange's equations; equation 47 before linearisation.
 * 0 operations; 0 with every named value expanded.
 */
void bed_slinger_velocity_forces(const pkmodes_real p[2], const pkmodes_real xy_dot[2],
    const bed_slinger_parameters *parameters, pkmodes_real h[2]);

/* Gravitational potential energy V_g = -U_g, with the force function U_g.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out V_g [J]: zero at the origin of the base frame
 *
 * Source: equation 26, for gravity in any direction and all moving bodies.
 * 6 operations; 6 with every named value expanded.
 */
void bed_slinger_gravity_potential(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real *V_g);

/* Gradient of the gravitational potential energy with respect to the positions.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out G [N]: dV_g/dq_k
 *
 * Source: equation 27.
 * 4 operations; 4 with every named value expanded.
 */
void bed_slinger_gravity_gradient(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real G[2]);

/* Hessian of the gravitational potential energy with respect to the positions.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out H_g [N/m]: d2V_g/dq_k dq_l, symmetric
 *
 * Source: section 4 and equation 49.
 * 0 operations; 0 with every named value expanded.
 */
void bed_slinger_gravity_hessian(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real H_g[2][2]);

/* Stiffnesses of the belt spans.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out k [N/m]: k[j-1, s-1] of span s of belt j, as in `belt_spans`
 *
 * Source: equations 34 to 37.
 * 10 operations; 12 with every named value expanded.
 */
void bed_slinger_belt_stiffness(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real k[2][2]);

/* Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   in  delta_q [m, rad]: small displacements of the four generalised coordinates from the reference
 *     configuration at p
 *   out V_el [J]: zero in the reference configuration
 *
 * Source: equation 38, summed.
 * 25 operations; 35 with every named value expanded.
 */
void bed_slinger_elastic_potential(const pkmodes_real p[2], const pkmodes_real delta_q[4],
    const bed_slinger_parameters *parameters, pkmodes_real *V_el);

/* Gradient of the elastic potential energy.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   in  delta_q [m, rad]: small displacements of the four generalised coordinates from the reference
 *     configuration at p
 *   out E [N, N m]: dV_el/dq
 *
 * Source: equation 38 differentiated.
 * 30 operations; 68 with every named value expanded.
 */
void bed_slinger_elastic_gradient(const pkmodes_real p[2], const pkmodes_real delta_q[4],
    const bed_slinger_parameters *parameters, pkmodes_real E[4]);

/* Hessian of the elastic potential energy.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out H_el [N/m, N, N m]: d2V_el/dq2, symmetric, with two zero eigenvalues
 *
 * Source: equation 38 differentiated twice.
 * 26 operations; 72 with every named value expanded.
 */
void bed_slinger_elastic_hessian(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real H_el[4][4]);

/* Drive torques that hold the pose, and the corresponding rotations.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out tau_st [N m]: torques on the driven rotors, positive in the direction of their rotation
 *   out theta_st [rad]: rotations relative to the unstrained transmissions, in the order of the coordinates
 *
 * Source: equation 44, solved at the pose.
 * 34 operations; 104 with every named value expanded.
 */
void bed_slinger_static_equilibrium(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real tau_st[2], pkmodes_real theta_st[2]);

/* Stiffness matrix K in the four generalised coordinates.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out K [N/m, N, N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equations 46 and 48: K = -H_U.
 * 26 operations; 72 with every named value expanded.
 */
void bed_slinger_stiffness_matrix(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real K[4][4]);

/* Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.
 *
 * Common intermediate values are evaluated once: call this function for an eigenproblem.
 *
 * Call `bed_slinger_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: tool head (x) and bed (y) in the base frame
 *   out M [kg, kg m^2]: mass matrix
 *   out K [N/m, N, N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equation 48.
 * 32 operations; 78 with every named value expanded.
 */
void bed_slinger_modal_matrices(const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real M[4][4], pkmodes_real K[4][4]);

/* Why a pose cannot be evaluated: a status above, or 0 where it can.  The functions above do not check the
 * pose, and return NaN or numbers without meaning where this is not 0.
 */
int bed_slinger_status(const pkmodes_real p[2], const bed_slinger_parameters *parameters);

/* Natural frequencies sqrt(|lambda|)/(2 pi) with the sign of lambda [Hz], ascending, rigid-body modes first,
 * of motors that are free to turn.
 * Return 0; otherwise the status of the pose or BED_SLINGER_UNSOLVED, and f has no meaning.
 *
 * The error of lambda is rounding of the largest one.  So the relative error of a frequency f is some 1e-15,
 * in single precision 1e-6, times the square of (highest frequency / f), and larger near singular poses.
 * Where this leaves a vibration fewer than six digits, in single precision hardly two, the status is
 * BED_SLINGER_UNSOLVED.
 */
int bed_slinger_natural_frequencies(
    const pkmodes_real p[2], const bed_slinger_parameters *parameters, pkmodes_real f[4]);

/* The same with mode shapes: row i of phi is mode i, mass-normalised (phi^T M phi = 1).  phi may be NULL.
 * Return 0; otherwise a status as above, and f and phi have no meaning.
 */
int bed_slinger_modes(
    const pkmodes_real p[2], const bed_slinger_parameters *parameters,
    pkmodes_real f[4], pkmodes_real phi[4][4]);

#ifdef __cplusplus
}
#endif

#endif
