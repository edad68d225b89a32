/* Generated from the derivation of hexapod.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism hexapod, for a robot given by its parameters.
 *
 * C99 without allocation; depends only on math.h and memset of the C library.  Matrices are row-major.
 * Numbers are of type double or, in a program compiled with PKMODES_FLOAT defined, of type float.
 * All quantities are in SI units and in the base frame; V is potential energy, forces are -dV/dq, and K
 * is positive for a restoring force.
 * Generalised coordinates, in the order of M and K:
 *   l_1 [m]
 *   l_2 [m]
 *   l_3 [m]
 *   l_4 [m]
 *   l_5 [m]
 *   l_6 [m]
 *   s_1 [m]
 *   s_2 [m]
 *   s_3 [m]
 *   s_4 [m]
 *   s_5 [m]
 *   s_6 [m]
 *
 * Whether a pose can be evaluated comes first:
 *
 *   pkmodes_real p[6] = {...}, f[12], phi[12][12], M[12][12], K[12][12];
 *   if (hexapod_status(p, parameters) == 0) {
 *       hexapod_modal_matrices(p, parameters, M, K);
 *       hexapod_modes(p, parameters, f, phi);
 *   }
 */
#ifndef HEXAPOD_H
#define HEXAPOD_H

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
#define hexapod_inverse_kinematics hexapod_inverse_kinematics_f
#define hexapod_inertia_margin hexapod_inertia_margin_f
#define hexapod_travel_margin hexapod_travel_margin_f
#define hexapod_rotation_margin hexapod_rotation_margin_f
#define hexapod_joint_line_margin hexapod_joint_line_margin_f
#define hexapod_base_line_margin hexapod_base_line_margin_f
#define hexapod_leg_margin hexapod_leg_margin_f
#define hexapod_crossing_margin hexapod_crossing_margin_f
#define hexapod_platform_joints hexapod_platform_joints_f
#define hexapod_constraint_jacobians hexapod_constraint_jacobians_f
#define hexapod_jacobian_condition hexapod_jacobian_condition_f
#define hexapod_platform_jacobian hexapod_platform_jacobian_f
#define hexapod_platform_jacobian_rate hexapod_platform_jacobian_rate_f
#define hexapod_platform_second_derivatives hexapod_platform_second_derivatives_f
#define hexapod_kinetic_energy hexapod_kinetic_energy_f
#define hexapod_mass_matrix hexapod_mass_matrix_f
#define hexapod_velocity_forces hexapod_velocity_forces_f
#define hexapod_gravity_potential hexapod_gravity_potential_f
#define hexapod_gravity_gradient hexapod_gravity_gradient_f
#define hexapod_gravity_hessian hexapod_gravity_hessian_f
#define hexapod_elastic_potential hexapod_elastic_potential_f
#define hexapod_elastic_gradient hexapod_elastic_gradient_f
#define hexapod_elastic_hessian hexapod_elastic_hessian_f
#define hexapod_static_equilibrium hexapod_static_equilibrium_f
#define hexapod_stiffness_matrix hexapod_stiffness_matrix_f
#define hexapod_modal_matrices hexapod_modal_matrices_f
#define hexapod_status hexapod_status_f
#define hexapod_natural_frequencies hexapod_natural_frequencies_f
#define hexapod_modes hexapod_modes_f
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* name of the mechanism */
#define HEXAPOD_NAME "hexapod"
/* version of the generator */
#define HEXAPOD_VERSION "0.1.0"
/* SHA-256 of the C source, first digits: other code has another */
#define HEXAPOD_HASH "8d8466db0867dcbe"
/* components of a pose */
#define HEXAPOD_POSE 6
/* coordinates, and modes */
#define HEXAPOD_COORDINATES 12
/* rigid-body modes, the first ones */
#define HEXAPOD_RIGID_MODES 6
/* largest condition number of a regular pose */
#ifdef PKMODES_FLOAT
#define HEXAPOD_MAX_CONDITION 1000.0f
#else
#define HEXAPOD_MAX_CONDITION 1000000.0
#endif
/* status: the eigenproblem has no solution, or rounding leaves it too few digits */
#define HEXAPOD_UNSOLVED (-1)
/* status: the pose is not finite */
#define HEXAPOD_NOT_FINITE 1
/* status: the platform turns by 90 degrees or more */
#define HEXAPOD_BEYOND_ROTATION 2
/* status: the pose is singular */
#define HEXAPOD_BEYOND_SINGULAR 3
/* status: a leg is outside its limits */
#define HEXAPOD_BEYOND_LIMITS 4

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
    /* [m] base joint j */
    pkmodes_real base[6][3];
    /* [m] platform joint j from the platform's origin in platform axes */
    pkmodes_real joint[6][3];
    /* [m] min(l_j), max(l_j) */
    pkmodes_real limits[6][2];
    /* [N/m] stiffness of the transmission of leg j */
    pkmodes_real leg_stiffness[6];
    /* [kg] mass of the part of leg j that turns about the base joint */
    pkmodes_real leg_base_mass[6];
    /* [m] centre of mass of the part of leg j that turns about the base joint, from the base joint */
    pkmodes_real leg_base_center[6];
    /* [kg m^2] moment of inertia of the part of leg j that turns about the base joint about its centre of mass, perpendicular to the leg */
    pkmodes_real leg_base_inertia[6];
    /* [kg] mass of the part of leg j that ends in the platform joint */
    pkmodes_real leg_rod_mass[6];
    /* [m] centre of mass of the part of leg j that ends in the platform joint, from the platform joint */
    pkmodes_real leg_rod_center[6];
    /* [kg m^2] moment of inertia of the part of leg j that ends in the platform joint about its centre of mass, perpendicular to the leg */
    pkmodes_real leg_rod_inertia[6];
    /* [kg m^2] moment of inertia of motor j */
    pkmodes_real motor_inertia[6];
    /* [m] change of the length of leg j per radian of its motor */
    pkmodes_real motor_travel[6];
} hexapod_parameters;

/* Leg lengths at a pose.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out l [m]: leg lengths l_1, l_2, l_3, l_4, l_5, l_6
 *
 * Source: equations 1 to 3.
 * 216 operations; 2724 with every named value expanded.
 */
void hexapod_inverse_kinematics(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real l[6]);

/* Whether the platform's inertia is that of a body.
 *
 *   out margin [1]: none is negative for a body
 *
 * Source: principal minors of its second moments of mass, divided by powers of the trace.
 * 96 operations; 162 with every named value expanded.
 */
void hexapod_inertia_margin(const hexapod_parameters *parameters, pkmodes_real margin[7]);

/* Distance of each leg's length from its limits.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out margin [m]: for each leg: above the least and below the greatest length
 *
 * Source: the limits of the robot file.
 * 228 operations; 5460 with every named value expanded.
 */
void hexapod_travel_margin(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real margin[6][2]);

/* By how much the rotation of the platform is less than 90 degrees.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out margin [rad]: positive for a rotation below 90 degrees
 *
 * Source: the norm of the rotation vector.
 * 9 operations; 9 with every named value expanded.
 */
void hexapod_rotation_margin(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real *margin);

/* Whether the joints on the platform do not lie in a line.
 *
 *   out margin [m^4]: positive for points that span a plane
 *
 * Source: second invariant of their second moments about their mean.
 * 202 operations; 982 with every named value expanded.
 */
void hexapod_joint_line_margin(const hexapod_parameters *parameters, pkmodes_real *margin);

/* Whether the joints on the base do not lie in a line.
 *
 *   out margin [m^4]: positive for points that span a plane
 *
 * Source: second invariant of their second moments about their mean.
 * 202 operations; 982 with every named value expanded.
 */
void hexapod_base_line_margin(const hexapod_parameters *parameters, pkmodes_real *margin);

/* Whether no two legs coincide.
 *
 *   out margin [m^2]: positive for two legs that differ
 *
 * Source: sums of squared differences; numbers count times the rms distance of the platform joints.
 * 323 operations; 1065 with every named value expanded.
 */
void hexapod_leg_margin(const hexapod_parameters *parameters, pkmodes_real margin[15]);

/* Whether no two legs cross while the platform is not turned.
 *
 *   out margin [m^2]: positive for two legs that do not cross
 *
 * Source: the differences of their joints at base and platform, which have opposite directions if they do.
 * 488 operations; 1320 with every named value expanded.
 */
void hexapod_crossing_margin(const hexapod_parameters *parameters, pkmodes_real margin[15]);

/* How the joints lie on the platform: a characteristic length, and their middle.
 *
 *   out length [m]: root mean square distance of the platform joints from the platform's origin
 *   out middle [m]: middle of the platform joints from that origin, platform axes
 *
 * Source: the condition number of D_l, in which the length makes rotations comparable with displacements.
 * 88 operations; 88 with every named value expanded.
 */
void hexapod_platform_joints(const hexapod_parameters *parameters, pkmodes_real *length,
    pkmodes_real middle[3]);

/* Constraint Jacobians D_l and D_r of D_l p_dot = D_r l_dot.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out D_l [m, m^2]: row j: linkage vector c_j - e_j in the base frame, and its moment about the platform's
 *     origin
 *   out D_r [m]: diagonal: component of linkage vector j along the motion of its joint
 *
 * Source: equations 14 and 15.
 * 270 operations; 16116 with every named value expanded.
 */
void hexapod_constraint_jacobians(const pkmodes_real p[6], const hexapod_parameters *parameters,
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
 * 1649 operations; 18478002 with every named value expanded.
 */
void hexapod_jacobian_condition(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real *determinant, pkmodes_real *condition);

/* Platform Jacobian D_p = D_l^-1 D_r.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out D_p [1, 1/m]: dp_i/dq_k, base frame
 *
 * Source: equation 15.
 * 1478 operations; 17956152 with every named value expanded.
 */
void hexapod_platform_jacobian(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real D_p[6][6]);

/* Time derivative of the platform Jacobian.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  l_dot [m/s]: leg velocities
 *   out D_p_dot [1/s, 1/(m s)]: d(D_p)/dt at l_dot
 *
 * Source: equation 17.
 * 4070 operations; 25665058188 with every named value expanded.
 */
void hexapod_platform_jacobian_rate(const pkmodes_real p[6], const pkmodes_real l_dot[6],
    const hexapod_parameters *parameters, pkmodes_real D_p_dot[6][6]);

/* Second derivatives of the platform position with respect to the leg lengths.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out P [1/m, 1/m^2]: d2p_i/dq_k dq_l as P[i, k, l], of rotations in the exponential chart at the pose
 *
 * Source: equation 49, by the implicit function theorem to second order.
 * 7580 operations; 31766693832 with every named value expanded.
 */
void hexapod_platform_second_derivatives(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real P[6][6][6]);

/* Kinetic energies of the structure and of the transmissions.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  q_dot [m/s]: rates of the 12 generalised coordinates
 *   out T_ss [J]: platform and the bodies that move it
 *   out T_t [J]: rotors and motors
 *
 * Source: equations 24 and 28.
 * 2129 operations; 527160399 with every named value expanded.
 */
void hexapod_kinetic_energy(const pkmodes_real p[6], const pkmodes_real q_dot[12],
    const hexapod_parameters *parameters, pkmodes_real *T_ss, pkmodes_real *T_t);

/* Mass matrix M in the 12 generalised coordinates.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out M [kg]: symmetric; block diagonal: M_ss (6 by 6) and the diagonal M_t
 *
 * Source: equations 24, 30 and 33.
 * 2403 operations; 547725198 with every named value expanded.
 */
void hexapod_mass_matrix(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real M[12][12]);

/* Coriolis and centrifugal forces h of M_ss l_ddot + h + grad V = Q.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  l_dot [m/s]: leg velocities
 *   out h [N]: generalised forces conjugate to the leg lengths
 *
 * Source: Lagrange's equations; equation 47 before linearisation.
 * 6765 operations; 641399025012 with every named value expanded.
 */
void hexapod_velocity_forces(const pkmodes_real p[6], const pkmodes_real l_dot[6],
    const hexapod_parameters *parameters, pkmodes_real h[6]);

/* Gravitational potential energy V_g = -U_g, with the force function U_g.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out V_g [J]: zero at the origin of the base frame
 *
 * Source: equation 26, for gravity in any direction and all moving bodies.
 * 384 operations; 11508 with every named value expanded.
 */
void hexapod_gravity_potential(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real *V_g);

/* Gradient of the gravitational potential energy with respect to the leg lengths.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out G [N]: dV_g/dq_k
 *
 * Source: equation 27.
 * 1786 operations; 18148452 with every named value expanded.
 */
void hexapod_gravity_gradient(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real G[6]);

/* Hessian of the gravitational potential energy with respect to the leg lengths.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out H_g [N/m]: d2V_g/dq_k dq_l, symmetric
 *
 * Source: section 4 and equation 49.
 * 3020 operations; 9244803996 with every named value expanded.
 */
void hexapod_gravity_hessian(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real H_g[6][6]);

/* Elastic potential energy V_el = -U_el of the transmissions, with the force function U_el.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  delta_q [m]: small displacements of the 12 generalised coordinates from the reference configuration
 *     at p
 *   out V_el [J]: zero in the reference configuration
 *
 * Source: equation 38, summed.
 * 29 operations; 29 with every named value expanded.
 */
void hexapod_elastic_potential(const pkmodes_real p[6], const pkmodes_real delta_q[12],
    const hexapod_parameters *parameters, pkmodes_real *V_el);

/* Gradient of the elastic potential energy.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   in  delta_q [m]: small displacements of the 12 generalised coordinates from the reference configuration
 *     at p
 *   out E [N]: dV_el/dq
 *
 * Source: equation 38 differentiated.
 * 42 operations; 60 with every named value expanded.
 */
void hexapod_elastic_gradient(const pkmodes_real p[6], const pkmodes_real delta_q[12],
    const hexapod_parameters *parameters, pkmodes_real E[12]);

/* Hessian of the elastic potential energy.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out H_el [N/m]: d2V_el/dq2, symmetric, with six zero eigenvalues
 *
 * Source: equation 38 differentiated twice.
 * 6 operations; 12 with every named value expanded.
 */
void hexapod_elastic_hessian(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real H_el[12][12]);

/* Drive forces that hold the pose, and the corresponding displacements.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out tau_st [N]: forces of the drives, positive in the direction of their coordinates
 *   out theta_st [m]: displacements relative to the unstrained transmissions, in the order of the coordinates
 *
 * Source: equation 44, solved at the pose.
 * 1798 operations; 36296922 with every named value expanded.
 */
void hexapod_static_equilibrium(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real tau_st[6], pkmodes_real theta_st[6]);

/* Stiffness matrix K in the 12 generalised coordinates.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out K [N/m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equations 46 and 48: K = -H_U.
 * 3032 operations; 9244804014 with every named value expanded.
 */
void hexapod_stiffness_matrix(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real K[12][12]);

/* Mass and stiffness matrices of M q_ddot + K q = 0, evaluated together.
 *
 * Common intermediate values are evaluated once: call this function for an eigenproblem.
 *
 * Call `hexapod_status` first: where it is not 0, the results are NaN or have no meaning.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out M [kg]: mass matrix
 *   out K [N/m]: symmetric; Hessian of V_el + V_g, positive for a restoring force
 *
 * Source: equation 48.
 * 3924 operations; 9792529212 with every named value expanded.
 */
void hexapod_modal_matrices(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real M[12][12], pkmodes_real K[12][12]);

/* Why a pose cannot be evaluated: a status above, or 0 where it can.  The functions above do not check the
 * pose, and return NaN or numbers without meaning where this is not 0.
 */
int hexapod_status(const pkmodes_real p[6], const hexapod_parameters *parameters);

/* Natural frequencies sqrt(|lambda|)/(2 pi) with the sign of lambda [Hz], ascending, rigid-body modes first,
 * of motors that are free to turn.
 * Return 0; otherwise the status of the pose or HEXAPOD_UNSOLVED, and f has no meaning.
 *
 * The error of lambda is rounding of the largest one.  So the relative error of a frequency f is some 1e-15,
 * in single precision 1e-6, times the square of (highest frequency / f), and larger near singular poses.
 * Where this leaves a vibration fewer than six digits, in single precision hardly two, the status is
 * HEXAPOD_UNSOLVED.
 */
int hexapod_natural_frequencies(
    const pkmodes_real p[6], const hexapod_parameters *parameters, pkmodes_real f[12]);

/* The same with mode shapes: row i of phi is mode i, mass-normalised (phi^T M phi = 1).  phi may be NULL.
 * Return 0; otherwise a status as above, and f and phi have no meaning.
 */
int hexapod_modes(
    const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real f[12], pkmodes_real phi[12][12]);

#ifdef __cplusplus
}
#endif

#endif
