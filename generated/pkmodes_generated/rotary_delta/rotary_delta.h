/* Generated from the derivation of rotary_delta.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism rotary_delta, for a robot given by its parameters.
 *
 * C99 without allocation; depends only on math.h and memset of the C library.  Matrices are row-major.
 * Numbers are of type double or, in a program compiled with PKMODES_FLOAT defined, of type float.
 * All quantities are in SI units and in the base frame; V is potential energy, forces are -dV/dq, and K
 * is positive for a restoring force.
 * Generalised coordinates, in the order of M and K:
 *   theta_1 [rad]
 *   theta_2 [rad]
 *   theta_3 [rad]
 *   phi_1 [rad]
 *   phi_2 [rad]
 *   phi_3 [rad]
 *
 * Whether a pose can be evaluated comes first:
 *
 *   pkmodes_real p[3] = {...}, f[6], phi[6][6], M[6][6], K[6][6];
 *   if (rotary_delta_status(p, parameters) == 0) {
 *       rotary_delta_modal_matrices(p, parameters, M, K);
 *       rotary_delta_modes(p, parameters, f, phi);
 *   }
 */
#ifndef ROTARY_DELTA_H
#define ROTARY_DELTA_H

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
#define rotary_delta_inverse_kinematics rotary_delta_inverse_kinematics_f
#define rotary_delta_reach_margin rotary_delta_reach_margin_f
#define rotary_delta_limit_margin rotary_delta_limit_margin_f
#define rotary_delta_perpendicular_margin rotary_delta_perpendicular_margin_f
#define rotary_delta_inertia_margin rotary_delta_inertia_margin_f
#define rotary_delta_direct_kinematics rotary_delta_direct_kinematics_f
#define rotary_delta_constraint_jacobians rotary_delta_constraint_jacobians_f
#define rotary_delta_jacobian_condition rotary_delta_jacobian_condition_f
#define rotary_delta_platform_jacobian rotary_delta_platform_jacobian_f
#define rotary_delta_platform_jacobian_rate rotary_delta_platform_jacobian_rate_f
#define rotary_delta_platform_second_derivatives rotary_delta_platform_second_derivatives_f
#define rotary_delta_link_jacobians rotary_delta_link_jacobians_f
#define rotary_delta_kinetic_energy rotary_delta_kinetic_energy_f
#define rotary_delta_mass_matrix rotary_delta_mass_matrix_f
#define rotary_delta_velocity_forces rotary_delta_velocity_forces_f
#define rotary_delta_gravity_potential rotary_delta_gravity_potential_f
#define rotary_delta_gravity_gradient rotary_delta_gravity_gradient_f
#define rotary_delta_gravity_hessian rotary_delta_gravity_hessian_f
#define rotary_delta_elastic_potential rotary_delta_elastic_potential_f
#define rotary_delta_elastic_gradient rotary_delta_elastic_gradient_f
#define rotary_delta_elastic_hessian rotary_delta_elastic_hessian_f
#define rotary_delta_static_equilibrium rotary_delta_static_equilibrium_f
#define rotary_delta_stiffness_matrix rotary_delta_stiffness_matrix_f
#define rotary_delta_modal_matrices rotary_delta_modal_matrices_f
#define rotary_delta_status rotary_delta_status_f
#define rotary_delta_natural_frequencies rotary_delta_natural_frequencies_f
#define rotary_delta_modes rotary_delta_modes_f
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* name of the mechanism */
#define ROTARY_DELTA_NAME "rotary_delta"
/* version of the generator */
#define ROTARY_DELTA_VERSION "0.1.0"
/* SHA-256 of the C source, first digits: other code has another */
#define ROTARY_DELTA_HASH "e1c4830f3868bce3"
/* components of a pose */
#define ROTARY_DELTA_POSE 3
/* coordinates, and modes */
#define ROTARY_DELTA_COORDINATES 6
/* rigid-body modes, the first ones */
#define ROTARY_DELTA_RIGID_MODES 3
/* largest condition number of a regular pose */
#ifdef PKMODES_FLOAT
#define ROTARY_DELTA_MAX_CONDITION 1000.0f
#else
#define ROTARY_DELTA_MAX_CONDITION 1000000.0
#endif
/* status: the eigenproblem has no solution, or rounding leaves it too few digits */
#define ROTARY_DELTA_UNSOLVED (-1)
/* status: the pose is not finite */
#define ROTARY_DELTA_NOT_FINITE 1
/* status: the pose is out of reach: an arm and its link do not reach the platform */
#define ROTARY_DELTA_BEYOND_REACHABLE 2
/* status: the pose is singular */
#define ROTARY_DELTA_BEYOND_SINGULAR 3
/* status: an arm is beyond its limits */
#define ROTARY_DELTA_BEYOND_LIMITS 4

typedef struct {
    /* [kg] platform mass */
    pkmodes_real platform_mass;
    /* [m/s^2] gravitational acceleration g, base frame */
    pkmodes_real gravity[3];
    /* [m] point of the axis of arm j where the arm starts */
    pkmodes_real origin[3][3];
    /* [1] unit vector of rotation of arm j */
    pkmodes_real axis[3][3];
    /* [1] direction of arm j at theta_j = 0 */
    pkmodes_real zero[3][3];
    /* [m] platform joint j relative to the platform centre */
    pkmodes_real joint[3][3];
    /* [m] length of arm j, to the joint of the linkage */
    pkmodes_real arm_length[3];
    /* [kg] mass of arm j */
    pkmodes_real arm_mass[3];
    /* [m] distance of the centre of mass of arm j from its axis, along the arm */
    pkmodes_real arm_center[3];
    /* [kg m^2] moment of inertia of arm j about its axis */
    pkmodes_real arm_inertia[3];
    /* [m] length of linkage j */
    pkmodes_real link_length[3];
    /* [kg] mass of linkage j, both rods together */
    pkmodes_real link_mass[3];
    /* [N m/rad] torsional stiffness of reducer j, seen at the arm */
    pkmodes_real reducer_stiffness[3];
    /* [kg m^2] moment of inertia of motor j at its shaft */
    pkmodes_real motor_inertia[3];
    /* [1] gear ratio of axis j, motor over arm */
    pkmodes_real gear_ratio[3];
    /* [rad] min(theta_j), max(theta_j) */
    pkmodes_real limits[3][2];
    /* [1] branch of axis j: +1 or -1, the side to which the arm bends */
    pkmodes_real branch[3];
} rotary_delta_parameters;

/* Arm angles at a pose.
 *
 * NaN if the pose is out of reach (see `reach_margin`).
 *
 *   in  p [m]: platform centre in the base frame
 *   out theta [rad]: arm angles theta_1, theta_2, theta_3
 *
 * Source: equations 1 to 3.
 * 162 operations; 855 with every named value expanded.
 */
void rotary_delta_inverse_kinematics(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real theta[3]);

/* Margins of the length of each linkage above its minimum and below its maximum.
 *
 *   in  p [m]: platform centre in the base frame
 *   out margin [m]: for each axis; at least zero if satisfied
 *
 * Source: distance of the platform joint from the nearest and the farthest point of the arm's circle.
 * 141 operations; 330 with every named value expanded.
 */
void rotary_delta_reach_margin(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real margin[3][2]);

/* Distance of each arm from its limits.
 *
 *   in  p [m]: platform centre in the base frame
 *   out margin [rad]: for each axis; at least zero if satisfied
 *
 * Source: both ends of the limits.
 * 168 operations; 1716 with every named value expanded.
 */
void rotary_delta_limit_margin(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real margin[3][2]);

/* Margin for the zero direction of each arm to be perpendicular to its axis.
 *
 *   out margin [1]: at least zero for perpendicular directions
 *
 * Source: |a_j . z_j| is at most 1e-6: (1e-6)^2 - (a_j . z_j)^2.
 * 24 operations; 24 with every named value expanded.
 */
void rotary_delta_perpendicular_margin(const rotary_delta_parameters *parameters, pkmodes_real margin[3]);

/* Moment of inertia of each arm minus that of a point mass at its centre of mass.
 *
 *   out margin [kg m^2]: at least zero for a physical body
 *
 * Source: the parallel axis theorem.
 * 9 operations; 9 with every named value expanded.
 */
void rotary_delta_inertia_margin(const rotary_delta_parameters *parameters, pkmodes_real margin[3]);

/* Platform centre in the base frame for given arm angles.
 *
 * NaN if the three spheres do not intersect.
 *
 *   in  theta [rad]: arm angles theta_1, theta_2, theta_3
 *   in  assembly [1]: assembly branch, +1 or -1: the sign of det D_l at the desired platform centre
 *   out p [m]: platform centre in the base frame
 *
 * Source: equation 3: intersection of three spheres.
 * 183 operations; 12486 with every named value expanded.
 */
void rotary_delta_direct_kinematics(const pkmodes_real theta[3], pkmodes_real assembly,
    const rotary_delta_parameters *parameters, pkmodes_real p[3]);

/* Constraint Jacobians D_l and D_r of D_l p_dot = D_r theta_dot.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out D_l [m]: row j: linkage vector c_j - e_j in the base frame
 *   out D_r [m^2]: diagonal: component of linkage vector j along the motion of its joint
 *
 * Source: equations 14 and 15.
 * 255 operations; 7926 with every named value expanded.
 */
void rotary_delta_constraint_jacobians(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real D_l[3][3], pkmodes_real D_r[3][3]);

/* Assembly branch and condition number of D_l in the Frobenius norm.
 *
 *   in  p [m]: platform centre in the base frame
 *   out determinant [m^3]: det D_l; its sign is the assembly branch
 *   out condition [1]: Frobenius condition number, at least 3
 *
 * Source: equation 15; |D_l| |D_l^-1|, one to three times the condition number in the 2-norm.
 * 286 operations; 57554 with every named value expanded.
 */
void rotary_delta_jacobian_condition(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real *determinant, pkmodes_real *condition);

/* Platform Jacobian D_p = D_l^-1 D_r.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out D_p [m]: dp_i/dq_k, base frame
 *
 * Source: equation 15.
 * 300 operations; 66285 with every named value expanded.
 */
void rotary_delta_platform_jacobian(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real D_p[3][3]);

/* Time derivative of the platform Jacobian.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  theta_dot [rad/s]: arm velocities
 *   out D_p_dot [m/s]: d(D_p)/dt at theta_dot
 *
 * Source: equation 17.
 * 492 operations; 3110535 with every named value expanded.
 */
void rotary_delta_platform_jacobian_rate(const pkmodes_real p[3], const pkmodes_real theta_dot[3],
    const rotary_delta_parameters *parameters, pkmodes_real D_p_dot[3][3]);

/* Second derivatives of the platform position with respect to the arm angles.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out P [m]: d2p_i/dq_k dq_l as P[i, k, l]
 *
 * Source: equation 49, by the implicit function theorem to second order.
 * 525 operations; 3253689 with every named value expanded.
 */
void rotary_delta_platform_second_derivatives(const pkmodes_real p[3],
    const rotary_delta_parameters *parameters, pkmodes_real P[3][3][3]);

/* Jacobians of the linkages: centre of mass and angular velocity.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out D_d [m]: D_d[j-1] theta_dot is the velocity of the centre of mass of linkage j
 *   out D_omega [1]: D_omega[j-1] theta_dot is the angular velocity of linkage j
 *
 * Source: equations 16 and 23; the angular velocity without spin about the rod, which carries no energy.
 * 447 operations; 620496 with every named value expanded.
 */
void rotary_delta_link_jacobians(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real D_d[3][3][3], pkmodes_real D_omega[3][3][3]);

/* Kinetic energies of the structure and of the transmissions.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  q_dot [rad/s]: rates of the six generalised coordinates
 *   out T_ss [J]: platform and the bodies that move it
 *   out T_t [J]: rotors and motors
 *
 * Source: equations 24 and 28.
 * 392 operations; 135334 with every named value expanded.
 */
void rotary_delta_kinetic_energy(const pkmodes_real p[3], const pkmodes_real q_dot[6],
    const rotary_delta_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t);

/* Mass matrix M in the six generalised coordinates.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out M [kg m^2]: symmetric
 *
 * Source: equations 24, 30 and 33.
 * 417 operations; 612723 with every named value expanded.
 */
void rotary_delta_mass_matrix(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real M[6][6]);

/* Coriolis and centrifugal forces h of M_ss theta_ddot + h + grad V = Q.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  theta_dot [rad/s]: arm velocities
 *   out h [N m]: generalised forces conjugate to the arm angles
 *
 * Source: Lagrange's equations; equation 47 before linearisation.
 * 987 operations; 17338074 with every named value expanded.
 */
void rotary_delta_velocity_forces(const pkmodes_real p[3], const pkmodes_real theta_dot[3],
    const rotary_delta_parameters *parameters, pkmodes_real h[3]);

/* Gravitational potential energy V_g = -U_g, with the force function U_g.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out V_g [J]: zero at the origin of the base frame
 *
 * Source: equation 26, for gravity in any direction and all moving bodies.
 * 297 operations; 5382 with every named value expanded.
 */
void rotary_delta_gravity_potential(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real *V_g);

/* Gradient of the gravitational potential energy with respect to the arm angles.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out G [N m]: dV_g/dq_k
 *
 * Source: equation 27.
 * 363 operations; 69039 with every named value expanded.
 */
void rotary_delta_gravity_gradient(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real G[3]);

/* Hessian of the gravitational potential energy with respect to the arm angles.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out H_g [N m]: d2V_g/dq_k dq_l, symmetric
 *
 * Source: section 4 and equation 49.
 * 543 operations; 1734630 with every named value expanded.
 */
void rotary_delta_gravity_hessian(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real H_g[3][3]);

/* Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  delta_q [rad]: small displacements of the six generalised coordinates from the reference
 *     configuration at p
 *   out V_el [J]: zero in the reference configuration
 *
 * Source: equation 38, summed.
 * 14 operations; 14 with every named value expanded.
 */
void rotary_delta_elastic_potential(const pkmodes_real p[3], const pkmodes_real delta_q[6],
    const rotary_delta_parameters *parameters, pkmodes_real *V_el);

/* Gradient of the elastic potential energy.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   in  delta_q [rad]: small displacements of the six generalised coordinates from the reference
 *     configuration at p
 *   out E [N m]: dV_el/dq
 *
 * Source: equation 38 differentiated.
 * 21 operations; 30 with every named value expanded.
 */
void rotary_delta_elastic_gradient(const pkmodes_real p[3], const pkmodes_real delta_q[6],
    const rotary_delta_parameters *parameters, pkmodes_real E[6]);

/* Hessian of the elastic potential energy.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out H_el [N m]: d2V_el/dq2, symmetric, with three zero eigenvalues
 *
 * Source: equation 38 differentiated twice.
 * 3 operations; 6 with every named value expanded.
 */
void rotary_delta_elastic_hessian(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real H_el[6][6]);

/* Drive torques that hold the pose, and the corresponding rotations.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out tau_st [N m]: torques on the driven rotors, positive in the direction of their rotation
 *   out theta_st [rad]: rotations relative to the unstrained transmissions, in the order of the coordinates
 *
 * Source: equation 44, solved at the pose.
 * 369 operations; 138087 with every named value expanded.
 */
void rotary_delta_static_equilibrium(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real tau_st[3], pkmodes_real theta_st[3]);

/* Stiffness matrix K in the six generalised coordinates.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out K [N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equations 46 and 48: K = -H_U.
 * 549 operations; 1734639 with every named value expanded.
 */
void rotary_delta_stiffness_matrix(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real K[6][6]);

/* Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.
 *
 * Common intermediate values are evaluated once: call this function for an eigenproblem.
 *
 * Call `rotary_delta_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m]: platform centre in the base frame
 *   out M [kg m^2]: mass matrix
 *   out K [N m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equation 48.
 * 666 operations; 2347362 with every named value expanded.
 */
void rotary_delta_modal_matrices(const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real M[6][6], pkmodes_real K[6][6]);

/* Why a pose cannot be evaluated: a status above, or 0 where it can.  The functions above do not check the
 * pose, and return NaN or numbers without meaning where this is not 0.
 */
int rotary_delta_status(const pkmodes_real p[3], const rotary_delta_parameters *parameters);

/* Natural frequencies sqrt(|lambda|)/(2 pi) with the sign of lambda [Hz], ascending, rigid-body modes first,
 * of motors that are free to turn.
 * Return 0; otherwise the status of the pose or ROTARY_DELTA_UNSOLVED, and f has no meaning.
 *
 * The error of lambda is rounding of the largest one.  So the relative error of a frequency f is some 1e-15,
 * in single precision 1e-6, times the square of (highest frequency / f), and larger near singular poses.
 * Where this leaves a vibration fewer than six digits, in single precision hardly two, the status is
 * ROTARY_DELTA_UNSOLVED.
 */
int rotary_delta_natural_frequencies(
    const pkmodes_real p[3], const rotary_delta_parameters *parameters, pkmodes_real f[6]);

/* The same with mode shapes: row i of phi is mode i, mass-normalised (phi^T M phi = 1).  phi may be NULL.
 * Return 0; otherwise a status as above, and f and phi have no meaning.
 */
int rotary_delta_modes(
    const pkmodes_real p[3], const rotary_delta_parameters *parameters,
    pkmodes_real f[6], pkmodes_real phi[6][6]);

#ifdef __cplusplus
}
#endif

#endif
