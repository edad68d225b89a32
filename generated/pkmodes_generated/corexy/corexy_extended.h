/* Generated from the derivation of corexy and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism corexy with effects: extended matrices and sensitivities.
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
 *   psi_1 [rad]
 *   psi_2 [rad]
 *   eps_1 [m]
 *   eps_2 [m]
 *   u_x [m]
 *   u_y [m]
 *   psi_b [rad]
 */
#ifndef COREXY_EXTENDED_H
#define COREXY_EXTENDED_H

#include "corexy.h"

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
#define corexy_extended_extended_matrices corexy_extended_extended_matrices_f
#define corexy_extended_extended_platform_motion corexy_extended_extended_platform_motion_f
#define corexy_extended_joint_stiffness corexy_extended_joint_stiffness_f
#define corexy_extended_extended_static_equilibrium corexy_extended_extended_static_equilibrium_f
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    /* [1] relative change of the stiffness of belt 1 */
    pkmodes_real axis_belt_stiffness_factor_1;
    /* [1] relative change of the stiffness of belt 2 */
    pkmodes_real axis_belt_stiffness_factor_2;
    /* [m/N] compliance in series with every free span */
    pkmodes_real belt_end_compliance_compliance;
    /* [1] loss factor of every free span */
    pkmodes_real belt_loss_loss_factor;
    /* [kg/m] mass of a belt per unit length */
    pkmodes_real belt_mass_linear_density;
    /* [1/N] relative change of the belt stiffness with tension */
    pkmodes_real belt_tension_stiffness_coefficient;
    /* [N] measured tension of every belt */
    pkmodes_real belt_tension_stiffness_tension;
    /* [N/m] isotropic stiffness from the platform centre to ground */
    pkmodes_real cable_stiffness_stiffness;
    /* [N m s/rad] viscous friction of every motor, seen at the driven rotor */
    pkmodes_real drive_friction_viscous;
    /* [kg m^2] extra inertia on every driven pulley */
    pkmodes_real gearbox_inertia_inertia;
    /* [kg] point mass at the platform centre */
    pkmodes_real payload_mass;
    /* [N s/m] viscous friction of every body along its rail */
    pkmodes_real rail_friction_viscous;
    /* [1] loss factor of every reducer, or gearbox that winds up */
    pkmodes_real reducer_loss_loss_factor;
    /* [N m/rad] torsional stiffness to ground at every motor, seen at the driven rotor */
    pkmodes_real servo_stiffness_stiffness;
    /* [rad/(N m)] compliance of every gearbox, output side */
    pkmodes_real gearbox_compliance_compliance;
    /* [m/N] compliance of every belt clamp */
    pkmodes_real clamp_compliance_compliance;
    /* [m/N] isotropic compliance of the frame */
    pkmodes_real frame_compliance_compliance;
    /* [kg] mass of the frame */
    pkmodes_real frame_compliance_mass;
    /* [m/N] compliance of the frame along x */
    pkmodes_real frame_compliance_compliance_x;
    /* [m/N] compliance of the frame along y */
    pkmodes_real frame_compliance_compliance_y;
    /* [rad/(N m)] compliance of the beam's guides in rotation */
    pkmodes_real gantry_racking_compliance;
    /* [kg m^2] moment of inertia of the beam about its middle */
    pkmodes_real gantry_racking_inertia;
    /* [m] position of the beam's middle along it */
    pkmodes_real gantry_racking_center;
} corexy_effects;

/* Mass and stiffness matrices in the base and all released coordinates, with free joints.
 *
 *   in  p [m]: tool head in the base frame
 *   out M [kg, kg m, kg m^2]: mass matrix; its leading block is that of the base model
 *   out K_el [N/m, N, N m]: elastic stiffness with free joints
 *   out K_g [N/m, N, N m]: Hessian of the gravitational potential energy
 *
 * Source: equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses.
 * 273 operations; 3192 with every named value expanded.
 */
void corexy_extended_extended_matrices(const pkmodes_real p[2], const corexy_parameters *parameters,
    const corexy_effects *effects, pkmodes_real M[11][11], pkmodes_real K_el[11][11],
    pkmodes_real K_g[11][11]);

/* Jacobian of the absolute motion of the platform centre.
 *
 *   in  p [m]: tool head in the base frame
 *   out J_p [1, m]: dp_i/dq_k, base frame
 *
 * Source: equation 15, with the contributions of released joints and the frame.
 * 1 operations; 1 with every named value expanded.
 */
void corexy_extended_extended_platform_motion(const pkmodes_real p[2], const corexy_parameters *parameters,
    const corexy_effects *effects, pkmodes_real J_p[2][11]);

/* Stiffnesses of the released joints, to be added to the diagonal of K.
 *
 * Infinite for zero compliance (a locked joint).
 *
 *   out kappa [N/m, N m]: stiffness of each released coordinate, in order
 *   out kappa_c [N^2/m^2, N^2 m^2]: derivatives d(kappa)/d(compliance)
 *
 * Source: energy q^2 / (2 c) of each joint.
 * 22 operations; 32 with every named value expanded.
 */
void corexy_extended_joint_stiffness(const corexy_effects *effects, pkmodes_real kappa[7],
    pkmodes_real kappa_c[7]);

/* Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.
 *
 *   in  p [m]: tool head in the base frame
 *   out tau_st [N m]: torques on the driven rotors, positive in the direction of their rotation
 *   out theta_st [rad]: rotations relative to the unstrained transmissions
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 75 operations; 1722 with every named value expanded.
 */
void corexy_extended_extended_static_equilibrium(const pkmodes_real p[2],
    const corexy_parameters *parameters, const corexy_effects *effects, pkmodes_real tau_st[2],
    pkmodes_real theta_st[2]);

#ifdef __cplusplus
}
#endif

#endif
