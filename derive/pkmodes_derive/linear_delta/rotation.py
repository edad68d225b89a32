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

from pkmodes_derive.linear_delta.kinematics import Kinematics, cross
from pkmodes_derive.linear_delta.symbols import Symbols


def angular_jacobian(sy: Symbols, kinematics: Kinematics, j: int) -> Matrix:
    """D_omega,j = s_j x U_j / l_d^2, without spin about the rod."""
    U = kinematics.U[j]
    columns = [cross(kinematics.s[j], tuple(U[:, k])) for k in range(3)]
    return Matrix(3, 3, lambda m, k: columns[k][m] / sy.l_d[j] ** 2)


@dataclass(frozen=True)
class EulerRoute:
    """Equations 5 to 8 and 18 to 25 for one linkage; expressions in the entries of s_j, U_j and phi_j.

    Attributes
    ----------
    alpha, beta : sympy.Expr
        Euler angles [rad] (equations 6 and 7); gamma is 0 (equation 8).
    Psi : sympy.Matrix
        Euler rates to angular velocity, in the joint's frame (equation 21).
    D_omega : sympy.Matrix
        Angular velocity in the base frame by the velocities of x (equation 23).
    inertia : sympy.Matrix
        Inertia of the rods about their centre of mass, base frame (equation 25, turned).
    """

    alpha: Expr
    beta: Expr
    Psi: Matrix
    D_omega: Matrix
    inertia: Matrix


def euler_route(sy: Symbols, kinematics: Kinematics, j: int, phi: Symbol) -> EulerRoute:
    """Derive the paper's route for linkage `j` (counted from 0) whose joint is turned by `phi` about z."""
    R_f = rot_ccw_axis3(phi)
    u_symbols = Matrix(sy_u(j))
    length = sqrt(u_symbols.dot(u_symbols))
    # atan2 instead of the printed arctan(-u_2/u_3): equal for u_3 > 0 and right for u_3 < 0 as well.
    alpha_u, beta_u = atan2(-u_symbols[1], u_symbols[2]), asin(u_symbols[0] / length)
    D_f = Matrix([[diff(angle, u) for u in u_symbols] for angle in (alpha_u, beta_u, Integer(0))])
    u = R_f.T * -Matrix(kinematics.s[j])
    D_u = R_f.T * -kinematics.U[j]
    place = dict(zip(u_symbols, u, strict=True))
    alpha, beta = alpha_u.xreplace(place), beta_u.xreplace(place)
    Psi = Matrix(
        [
            [1, 0, sin(beta)],
            [0, cos(alpha), -cos(beta) * sin(alpha)],
            [0, sin(alpha), cos(beta) * cos(alpha)],
        ]
    )
    D_omega = R_f * Psi * D_f.xreplace(place) * D_u
    direction = Matrix(kinematics.s[j]) / sy.l_d[j]
    square_to_rod = Matrix.eye(3) - direction * direction.T
    inertia = sy.m_d[j] * sy.l_d[j] ** 2 * Rational(1, 12) * square_to_rod
    return EulerRoute(alpha, beta, Psi, D_omega, inertia)


def sy_u(j: int) -> tuple[Symbol, Symbol, Symbol]:
    """Components of u_j (equation 5) in the joint's own frame; local to the derivation."""
    first, second, third = (Symbol(f"u_{j + 1}_{m}", real=True) for m in (1, 2, 3))
    return first, second, third
