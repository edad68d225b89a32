r"""Rotation of the linkages: the direct route, and the paper's through Euler angles.

The direct route needs no angles: a rod that turns about an axis square to itself has

.. math:: \omega_j = \frac{s_j \times \dot s_j}{l_{d,j}^2}, \qquad D_{\omega,j} = \frac{s_j \times U_j}{l_{d,j}^2}.

The paper's route (equations 5 to 8 and 18 to 23) describes the universal joint: angles alpha and beta in a
frame turned by phi_j about z, gamma = 0.  Its angular velocity differs from the direct one by a spin about
the rod, which carries no energy because a slender rod has no inertia about itself (equation 25).  The
direct route is emitted, as it is short and regular everywhere; the other is the second path to the same
kinetic energy, and a test holds the two equal.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, Integer, Matrix, Rational, Symbol, asin, atan2, cos, diff, rot_ccw_axis3, sin, sqrt

from pkmodes_derive.functions import Relation
from pkmodes_derive.linear_delta.kinematics import Kinematics
from pkmodes_derive.linear_delta.symbols import Symbols
from pkmodes_derive.vectors import cross


def angular_jacobian(sy: Symbols, kinematics: Kinematics, j: int) -> Matrix:
    """D_omega,j = s_j x U_j / l_d^2, without spin about the rod."""
    U = kinematics.U[j]
    columns = [cross(kinematics.s[j], tuple(U[:, k])) for k in range(3)]
    return Matrix(3, 3, lambda m, k: columns[k][m] / sy.l_d[j] ** 2)


@dataclass(frozen=True)
class EulerRoute:
    """Equations 5 to 8 and 18 to 25 for one linkage, in the entries of s_j, U_j and of u_j.

    Attributes
    ----------
    u : tuple of sympy.Symbol
        Components of u_j (equation 5) in the joint's own frame.
    u_of_s : sympy.Matrix
        Their expressions in the linkage vector and phi_j.
    alpha, beta : sympy.Expr
        Euler angles [rad] as functions of u (equations 6 and 7); gamma is 0 (equation 8).
    D_f : sympy.Matrix
        Derivatives of the three angles by u (equation 18).
    Psi : sympy.Matrix
        Euler rates to angular velocity, in the joint's frame (equation 21).
    D_omega : sympy.Matrix
        Angular velocity in the base frame by the velocities of x (equation 23).
    inertia : sympy.Matrix
        Inertia of the rods about their centre of mass, base frame (equation 25, turned).
    """

    u: tuple[Symbol, Symbol, Symbol]
    u_of_s: Matrix
    alpha: Expr
    beta: Expr
    D_f: Matrix
    Psi: Matrix
    D_omega: Matrix
    inertia: Matrix


def euler_route(sy: Symbols, kinematics: Kinematics, j: int) -> EulerRoute:
    """Derive the paper's route for linkage `j` (counted from 0) whose joint is turned by phi_j about z."""
    u = sy.u[j]
    R_f = rot_ccw_axis3(sy.phi[j])
    # atan2 instead of the printed arctan(-u_2/u_3): equal for u_3 > 0 and right for u_3 < 0 as well.
    alpha, beta = atan2(-u[1], u[2]), asin(u[0] / sqrt(u[0] ** 2 + u[1] ** 2 + u[2] ** 2))
    D_f = Matrix([[diff(angle, component) for component in u] for angle in (alpha, beta, Integer(0))])
    Psi = Matrix(
        [
            [1, 0, sin(beta)],
            [0, cos(alpha), -cos(beta) * sin(alpha)],
            [0, sin(alpha), cos(beta) * cos(alpha)],
        ]
    )
    u_of_s = R_f.T * -Matrix(kinematics.s[j])
    place = dict(zip(u, u_of_s, strict=True))
    D_omega = R_f * (Psi * D_f).xreplace(place) * (R_f.T * -kinematics.U[j])
    direction = Matrix(kinematics.s[j]) / sy.l_d[j]
    inertia = sy.m_d[j] * sy.l_d[j] ** 2 * Rational(1, 12) * (Matrix.eye(3) - direction * direction.T)
    return EulerRoute(u, u_of_s, alpha, beta, D_f, Psi, D_omega, inertia)


def euler_relations(sy: Symbols, kinematics: Kinematics) -> tuple[Relation, ...]:
    """The paper's route as it is shown in the documentation, for the first linkage (the others are alike)."""
    route = euler_route(sy, kinematics, 0)
    return (
        Relation(
            "u_1", route.u_of_s, "Equation 5: carriage seen from the platform joint, in the joint's frame."
        ),
        Relation(r"\alpha_1", route.alpha, "Equation 6, with the quadrant."),
        Relation(r"\beta_1", route.beta, "Equation 7; gamma is zero (equation 8)."),
        Relation("(D_f)_1", route.D_f, "Equation 18: derivatives of the angles alpha, beta, gamma by u."),
        Relation(r"\Psi_1", route.Psi, "Equation 21."),
        Relation(
            r"(R_f)_1",
            rot_ccw_axis3(sy.phi[0]),
            "The joint's frame; D_omega = R_f Psi D_f D_u (equation 23).",
        ),
        Relation("I_{d,1}", route.inertia, "Equation 25 in the base frame."),
    )
