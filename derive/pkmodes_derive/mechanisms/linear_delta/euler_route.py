r"""Rotation of the linkages: the direct route, and the paper's route through Euler angles.

The direct route needs no angles: a rod that turns about an axis perpendicular to itself has

.. math:: \omega_j = \frac{s_j \times \dot s_j}{l_{d,j}^2}, \qquad D_{\omega,j} = \frac{s_j \times U_j}{l_{d,j}^2}.

The paper's route (equations 5 to 8 and 18 to 23) describes the universal joint: angles alpha and beta in a
frame turned by phi_j about z, gamma = 0.  Its angular velocity differs from the direct one by a spin about
the rod, which carries no energy because a slender rod has no inertia about itself (equation 25).  The
direct route is emitted because it is short and regular everywhere; the other is a second route to the same
kinetic energy, and a test compares the two.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Integer, Matrix, Rational, Symbol, asin, atan2, cos, diff, rot_ccw_axis3, sin, sqrt

from pkmodes_derive.assembly.kinematics import Kinematics
from pkmodes_derive.functions import Relation
from pkmodes_derive.machine import Machine


@dataclass(frozen=True)
class EulerRoute:
    """Equations 5 to 8 and 18 to 25 for one linkage, in terms of the entries of s_j, U_j and u_j.

    Attributes
    ----------
    phi : sympy.Symbol
        Angle of the joint about z [rad].
    u : tuple of sympy.Symbol
        Components of u_j (equation 5) in the joint frame.
    u_of_s : sympy.Matrix
        Their expressions in the linkage vector and phi_j.
    alpha, beta : sympy.Expr
        Euler angles [rad] as functions of u (equations 6 and 7); gamma is 0 (equation 8).
    D_f : sympy.Matrix
        Derivatives of the three angles with respect to u (equation 18).
    Psi : sympy.Matrix
        Maps Euler rates to angular velocity in the joint frame (equation 21).
    D_omega : sympy.Matrix
        Maps the velocities of x to angular velocity in the base frame (equation 23).
    inertia : sympy.Matrix
        Inertia of the rods about their centre of mass in the base frame (equation 25, rotated).
    """

    phi: Symbol
    u: tuple[Symbol, Symbol, Symbol]
    u_of_s: Matrix
    alpha: Expr
    beta: Expr
    D_f: Matrix
    Psi: Matrix
    D_omega: Matrix
    inertia: Matrix


def euler_route(machine: Machine, kinematics: Kinematics, j: int) -> EulerRoute:
    """Derive the paper's route for linkage `j` (counted from 0), whose joint is turned by phi_j about z."""
    v, link = machine.vocabulary, machine.links[j]
    what = "angular position of universal joint {j} on the platform"
    phi = v.declare("phi_{j}", "rad", what, r"\varphi_{j}", j=j + 1)
    u = v.vector(
        "u_{j}", "m", "carriage {j} relative to its platform joint, in the joint frame", "u_{j}", j=j + 1
    )
    R_f = rot_ccw_axis3(phi)
    # atan2 instead of the printed arctan(-u_2/u_3): equal for u_3 > 0, and also correct for u_3 < 0.
    alpha, beta = atan2(-u[1], u[2]), asin(u[0] / sqrt(u[0] ** 2 + u[1] ** 2 + u[2] ** 2))
    D_f = Matrix([[diff(angle, component) for component in u] for angle in (alpha, beta, Integer(0))])
    Psi = Matrix(
        [
            [1, 0, sin(beta)],
            [0, cos(alpha), -cos(beta) * sin(alpha)],
            [0, sin(alpha), cos(beta) * cos(alpha)],
        ]
    )
    u_of_s = R_f.T * -Matrix(link.vector)
    values = dict(zip(u, u_of_s, strict=True))
    D_omega = R_f * (Psi * D_f).xreplace(values) * (R_f.T * -kinematics.U[j])
    direction = Matrix(link.vector) / link.length
    mass = machine.rods[j].mass
    inertia = mass * link.length**2 * Rational(1, 12) * (Matrix.eye(3) - direction * direction.T)
    return EulerRoute(phi, u, u_of_s, alpha, beta, D_f, Psi, D_omega, inertia)


def relations(machine: Machine, kinematics: Kinematics) -> tuple[Relation, ...]:
    """Return the paper's route for the documentation, for the first linkage (the others are analogous)."""
    route = euler_route(machine, kinematics, 0)
    return (
        Relation(
            "u_1", route.u_of_s, "Equation 5: carriage relative to the platform joint, in the joint frame."
        ),
        Relation(r"\alpha_1", route.alpha, "Equation 6, with the correct quadrant."),
        Relation(r"\beta_1", route.beta, "Equation 7; gamma is zero (equation 8)."),
        Relation(
            "(D_f)_1",
            route.D_f,
            "Equation 18: derivatives of the angles alpha, beta, gamma with respect to u.",
        ),
        Relation(r"\Psi_1", route.Psi, "Equation 21."),
        Relation(
            r"(R_f)_1",
            rot_ccw_axis3(route.phi),
            "The joint frame; D_omega = R_f Psi D_f D_u (equation 23).",
        ),
        Relation("I_{d,1}", route.inertia, "Equation 25 in the base frame."),
    )
