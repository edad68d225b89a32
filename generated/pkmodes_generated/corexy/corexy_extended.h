/* Generated from the derivation of corexy and the catalogue of effects.
 * By pkmodes_derive 0.1.0 with SymPy 1.14.0.
 * Do not edit: regenerate with `python -m pkmodes_derive generate`.
 *
 * Dynamics of the mechanism corexy with effects: extended matrices and sensitivities.
 *
 * C99 without allocation; depends only on math.h and memset of the C library.  Matrices are row-major.
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
 */
#ifndef COREXY_EXTENDED_H
#define COREXY_EXTENDED_H

#include "corexy.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    /* [1] relative change of the stiffness of belt 1 */
    double axis_belt_stiffness_factor_1;
    /* [1] relative change of the stiffness of belt 2 */
    double axis_belt_stiffness_factor_2;
    /* [m/N] compliance in series with every free span */
    double belt_end_compliance_compliance;
    /* [kg/m] mass of a belt per unit length */
    double belt_mass_linear_density;
    /* [1/N] relative change of the belt stiffness with tension */
    double belt_tension_stiffness_coefficient;
    /* [N] measured tension of every belt */
    double belt_tension_stiffness_tension;
    /* [N/m] isotropic stiffness from the platform centre to ground */
    double cable_stiffness_stiffness;
    /* [kg m^2] extra inertia on every driven pulley */
    double gearbox_inertia_inertia;
    /* [kg] point mass at the platform centre */
    double payload_mass;
    /* [N m/rad] torsional stiffness to ground at every driven pulley */
    double servo_stiffness_stiffness;
    /* [rad/(N m)] compliance of every gearbox, output side */
    double gearbox_compliance_compliance;
    /* [m/N] compliance of every belt clamp */
    double clamp_compliance_compliance;
    /* [m/N] isotropic compliance of the frame */
    double frame_compliance_compliance;
    /* [kg] mass of the frame */
    double frame_compliance_mass;
} corexy_effects;

/* Mass and stiffness matrices in the base and all released coordinates, with free joints.
 *
 *   in  p [m]: tool head in the base frame
 *   out M [kg, kg m, kg m^2]: mass matrix; its leading block is that of the base model
 *   out K_el [N/m, N, N m]: elastic stiffness with free joints
 *   out K_g [N/m, N, N m]: Hessian of the gravitational potential energy
 *
 * Source: equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses.
 * 188 operations; 1919 with every named value expanded.
 */
void corexy_extended_extended_matrices(const double p[2], const corexy_parameters *parameters,
    const corexy_effects *effects, double M[10][10], double K_el[10][10], double K_g[10][10]);

/* Jacobian of the absolute motion of the platform centre.
 *
 *   in  p [m]: tool head in the base frame
 *   out J_p [1, m]: dp_i/dq_k, base frame
 *
 * Source: equation 15, with the contributions of released joints and the frame.
 * 0 operations; 0 with every named value expanded.
 */
void corexy_extended_extended_platform_motion(const double p[2], const corexy_parameters *parameters,
    double J_p[2][10]);

/* Stiffnesses of the released joints, to be added to the diagonal of K.
 *
 * Infinite for zero compliance (a locked joint).
 *
 *   out kappa [N/m, N m]: stiffness of each released coordinate, in order
 *   out kappa_c [N^2/m^2, N^2 m^2]: derivatives d(kappa)/d(compliance)
 *
 * Source: energy q^2 / (2 c) of each joint.
 * 12 operations; 24 with every named value expanded.
 */
void corexy_extended_joint_stiffness(const corexy_effects *effects, double kappa[6], double kappa_c[6]);

/* Drive torques and rotations that hold the pose, with the weights and stiffness changes of effects.
 *
 *   in  p [m]: tool head in the base frame
 *   out tau_st [N m]: torques on the driven rotors
 *   out theta_st [rad]: rotations relative to the unstrained transmissions
 *
 * Source: equation 44; springs added by effects are relaxed at the pose, and released joints are locked.
 * 75 operations; 1722 with every named value expanded.
 */
void corexy_extended_extended_static_equilibrium(const double p[2], const corexy_parameters *parameters,
    const corexy_effects *effects, double tau_st[2], double theta_st[2]);

#ifdef __cplusplus
}
#endif

#endif
