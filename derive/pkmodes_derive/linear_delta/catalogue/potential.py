"""Gravity and belts of the linear delta: potential energies, their derivatives, equilibrium."""

from __future__ import annotations

from pkmodes_derive.functions import Function, Output
from pkmodes_derive.linear_delta.catalogue.collected import Collected, flat


def gravity(c: Collected) -> list[Function]:
    """Gravitational potential energy and its derivatives by the carriage positions."""
    return [
        c.function(
            "gravity_potential",
            "Gravitational potential energy V_g, the force function U_g with opposite sign.",
            "equation 26, for gravity in any direction; the carriages' weight included",
            [c.pose],
            Output("V_g", (), (c.energies.V_g,), "J", "zero at the origin of the base frame"),
            known=c.locked,
        ),
        c.function(
            "gravity_gradient",
            "Gradient of the gravitational potential energy by the carriage positions.",
            "equation 27",
            [c.pose],
            Output("G", (3,), tuple(c.equilibrium.gravity_gradient), "N", "dV_g/dx_k"),
        ),
        c.function(
            "gravity_hessian",
            "Hessian of the gravitational potential energy by the carriage positions.",
            "section 4 and equation 49",
            [c.pose],
            Output("H_g", (3, 3), c.K_g, "N/m", "d2V_g/dx_k dx_l, symmetric"),
        ),
    ]


def belts(c: Collected) -> list[Function]:
    """Belts: stiffness, elastic potential energy and static equilibrium."""
    return [
        c.function(
            "belt_stiffness",
            "Stiffnesses of the belt spans.",
            "equations 34 to 37",
            [c.pose],
            Output(
                "k",
                (3, 3),
                flat(c.machine.k),
                "N/m",
                "k[j-1, s-1], the spans in the order of `belt_spans`",
            ),
        ),
        c.function(
            "elastic_potential",
            "Elastic potential energy V_el of the belts, the force function U_el with opposite sign.",
            "equation 38, summed over the axes",
            [c.pose, c.delta_q],
            Output("V_el", (), (c.V_el,), "J", "zero in the reference configuration"),
        ),
        c.function(
            "elastic_gradient",
            "Gradient of the elastic potential energy.",
            "equation 38 differentiated",
            [c.pose, c.delta_q],
            Output(
                "E",
                (c.n,),
                c.elastic_gradient,
                "N, N m",
                "dV_el/dq",
            ),
        ),
        c.function(
            "elastic_hessian",
            "Hessian of the elastic potential energy.",
            "equation 38 differentiated twice",
            [c.pose],
            Output(
                "H_el",
                (c.n, c.n),
                c.K_el,
                "N/m, N, N m",
                f"d2V_el/dq2, symmetric, {'three' if c.rigid_modes else 'no'} zero eigenvalues",
            ),
        ),
        c.function(
            "static_equilibrium",
            "Torques and pulley rotations that hold the pose.",
            "equation 44, solved for the carriages fixed at the pose",
            [c.pose],
            Output(
                "tau_st",
                (3,),
                c.equilibrium.torques,
                "N m",
                "torques on the driven pulleys, positive with theta",
            ),
            Output(
                "theta_st",
                (6,),
                c.equilibrium.rotations,
                "rad",
                "rotations from the unstrained belts, in the order of the coordinates theta",
            ),
            details="Springs that effects add are relaxed at the pose, and released joints hold."
            if c.machine.effects
            else "",
        ),
    ]
