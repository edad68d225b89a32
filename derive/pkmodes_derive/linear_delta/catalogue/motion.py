"""Velocities, accelerations and kinetic energy of the linear delta."""

from __future__ import annotations

from sympy import Integer, Matrix, Rational

from pkmodes_derive import lagrangian
from pkmodes_derive.functions import Function, Output
from pkmodes_derive.linear_delta import kinematics, rotation
from pkmodes_derive.linear_delta.catalogue.collected import Collected, flat
from pkmodes_derive.linear_delta.symbols import Symbols


def motion(c: Collected) -> list[Function]:
    """Velocities, accelerations and kinetic energy."""
    sy, kin, energies = c.sy, c.kin, c.energies
    D_d = [_midpoint_jacobian(sy, kin, j) for j in range(3)]
    D_omega = [rotation.angular_jacobian(sy, kin, j) for j in range(3)]
    return [
        c.function(
            "platform_jacobian",
            "Platform Jacobian D_p = D_l^-1 D_r.",
            "equation 15",
            [c.pose],
            Output("D_p", (3, 3), tuple(kin.D_p), "1", "dp_i/dx_k, base frame"),
        ),
        c.function(
            "platform_jacobian_rate",
            "Time derivative of the platform Jacobian.",
            "equation 17",
            [c.pose, c.x_dot],
            Output("D_p_dot", (3, 3), flat(energies.D_p_dot), "1/s", "d(D_p)/dt while the carriages move"),
        ),
        c.function(
            "platform_second_derivatives",
            "Second derivatives of the platform centre by the carriage positions.",
            "equation 49, by the implicit function theorem to second order",
            [c.pose],
            Output("P", (3, 3, 3), flat(map(tuple, kin.P)), "1/m", "d2p_i/dx_k dx_l as P[i, k, l]"),
        ),
        c.function(
            "link_jacobians",
            "Jacobians of the linkages: centre of mass and angular velocity.",
            "equations 16 and 23; the angular velocity without spin about the rod, which carries no energy",
            [c.pose],
            Output(
                "D_d",
                (3, 3, 3),
                flat(map(tuple, D_d)),
                "1",
                "velocity of the centre of linkage j by x_dot",
            ),
            Output(
                "D_omega",
                (3, 3, 3),
                flat(map(tuple, D_omega)),
                "1/m",
                "angular velocity of linkage j by x_dot",
            ),
        ),
        c.function(
            "kinetic_energy",
            "Kinetic energies of the structure and of the transmissions.",
            "equations 24 and 28",
            [c.pose, c.q_dot],
            Output("T_ss", (), (energies.T_ss,), "J", "carriages, linkages and platform"),
            Output("T_t", (), (energies.T_t,), "J", "pulleys and motors"),
        ),
        c.function(
            "mass_matrix",
            f"Mass matrix M in the {c.count} generalised coordinates.",
            "equations 24, 30 and 33",
            [c.pose],
            Output(
                "M",
                (c.n, c.n),
                c.M,
                c.units_M,
                "symmetric" if c.machine.effects else "symmetric; M_ss (3 by 3) and the diagonal M_t",
            ),
        ),
        c.function(
            "velocity_forces",
            "Coriolis and centrifugal forces h of M_ss x_ddot + h + grad V = Q.",
            "Lagrange's equations, equation 47 without its linearisation",
            [c.pose, c.x_dot],
            Output(
                "h",
                (3,),
                tuple(lagrangian.velocity_forces(c.moving_energy, sy.x, sy.velocities[:3], kin.chain)),
                "N",
                "generalised forces on the carriages; the pulleys have none",
            ),
            details="While released joints hold and the pulleys turn with the carriages."
            if c.machine.effects
            else "",
            known=c.locked,
        ),
    ]


def _midpoint_jacobian(sy: Symbols, kin: kinematics.Kinematics, j: int) -> Matrix:
    """Equation 16 with W_c = W_t: the centre of mass is midway."""
    return Matrix(
        3, 3, lambda m, k: (kin.D_p[m, k] + (sy.n[j][m] if j == k else Integer(0))) * Rational(1, 2)
    )
