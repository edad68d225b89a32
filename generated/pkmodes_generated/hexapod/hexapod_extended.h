/* Generated from the derivation of hexapod and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism hexapod with effects: extended matrices and sensitivities.
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
 *   u_x [m]
 *   u_y [m]
 *   u_z [m]
 */
#ifndef HEXAPOD_EXTENDED_H
#define HEXAPOD_EXTENDED_H

#include "hexapod.h"

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
#define hexapod_extended_extended_matrices hexapod_extended_extended_matrices_f
#define hexapod_extended_extended_platform_motion hexapod_extended_extended_platform_motion_f
#define hexapod_extended_joint_stiffness hexapod_extended_joint_stiffness_f
#define hexapod_extended_extended_static_equilibrium hexapod_extended_extended_static_equilibrium_f
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    /* [1] relative change of the stiffness of leg 1 */
    pkmodes_real axis_leg_stiffness_factor_1;
    /* [1] relative change of the stiffness of leg 2 */
    pkmodes_real axis_leg_stiffness_factor_2;
    /* [1] relative change of the stiffness of leg 3 */
    pkmodes_real axis_leg_stiffness_factor_3;
    /* [1] relative change of the stiffness of leg 4 */
    pkmodes_real axis_leg_stiffness_factor_4;
    /* [1] relative change of the stiffness of leg 5 */
    pkmodes_real axis_leg_stiffness_factor_5;
    /* [1] relative change of the stiffness of leg 6 */
    pkmodes_real axis_leg_stiffness_factor_6;
    /* [N/m] isotropic stiffness from the platform centre to ground */
    pkmodes_real cable_stiffness_stiffness;
    /* [N s/m] viscous friction of every drive, along its leg */
    pkmodes_real drive_friction_viscous;
    /* [kg] extra mass that every drive moves along its leg */
    pkmodes_real gearbox_inertia_inertia;
    /* [kg] point mass at the platform centre */
    pkmodes_real payload_mass;
    /* [m] component x of the payload's place from the platform's origin, platform axes */
    pkmodes_real payload_offset_x;
    /* [m] component y of the payload's place from the platform's origin, platform axes */
    pkmodes_real payload_offset_y;
    /* [m] component z of the payload's place from the platform's origin, platform axes */
    pkmodes_real payload_offset_z;
    /* [N/m] stiffness to ground at every drive, along its leg */
    pkmodes_real servo_stiffness_stiffness;
    /* [m/N] isotropic compliance of the frame */
    pkmodes_real frame_compliance_compliance;
    /* [kg] mass of the frame */
    pkmodes_real frame_compliance_mass;
    /* [m/N] compliance of the frame along x */
    pkmodes_real frame_compliance_compliance_x;
    /* [m/N] compliance of the frame along y */
    pkmodes_real frame_compliance_compliance_y;
    /* [m/N] compliance of the frame along z */
    pkmodes_real frame_compliance_compliance_z;
} hexapod_effects;

/* Mass and stiffness matrices in the base and all released coordinates, with free joints.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out M [kg]: mass matrix; its leading block is that of the base model
 *   out K_el [N/m]: elastic stiffness with free joints
 *   out K_g [N/m]: Hessian of the gravitational potential energy
 *
 * Source: equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses.
 * 4426 operations; 9976887204 with every named value expanded.
 */
void hexapod_extended_extended_matrices(const pkmodes_real p[6], const hexapod_parameters *parameters,
    const hexapod_effects *effects, pkmodes_real M[15][15], pkmodes_real K_el[15][15],
    pkmodes_real K_g[15][15]);

/* Jacobian of the absolute motion of the platform centre.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out J_p [1, m]: dp_i/dq_k, base frame
 *
 * Source: equation 15, with the contributions of released joints and the frame.
 * 1478 operations; 17956152 with every named value expanded.
 */
void hexapod_extended_extended_platform_motion(const pkmodes_real p[6], const hexapod_parameters *parameters,
    pkmodes_real J_p[6][15]);

/* Stiffnesses of the released joints, to be added to the diagonal of K.
 *
 * Infinite for zero compliance (a locked joint).
 *
 *   out kappa [N/m, N m]: stiffness of each released coordinate, in order
 *   out kappa_c [N^2/m^2, N^2 m^2]: derivatives d(kappa)/d(compliance)
 *
 * Source: energy q^2 / (2 c) of each joint.
 * 15 operations; 18 with every named value expanded.
 */
void hexapod_extended_joint_stiffness(const hexapod_effects *effects, pkmodes_real kappa[3],
    pkmodes_real kappa_c[3]);

/* Drive forces and displacements that hold the pose, with the weights and stiffness changes of effects.
 *
 *   in  p [m, rad]: platform's origin in the base frame, then the platform's rotation vector
 *   out tau_st [N]: forces of the drives, positive in the direction of their coordinates
 *   out theta_st [m]: displacements relative to the unstrained transmissions
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 1846 operations; 36307794 with every named value expanded.
 */
void hexapod_extended_extended_static_equilibrium(const pkmodes_real p[6],
    const hexapod_parameters *parameters, const hexapod_effects *effects, pkmodes_real tau_st[6],
    pkmodes_real theta_st[6]);

#ifdef __cplusplus
}
#endif

#endif
