"""Positions of the linear delta, and the limits of its workspace."""

from __future__ import annotations

from sympy import Add, sqrt

from pkmodes_derive.functions import Argument, Function, Output
from pkmodes_derive.linear_delta import kinematics
from pkmodes_derive.linear_delta.catalogue.collected import Collected
from pkmodes_derive.linear_delta.symbols import Symbols


def travel(sy: Symbols) -> Function:
    """What is left of the travel of each carriage."""
    margin = tuple(high - low - length for high, low, length in zip(sy.x_max, sy.x_min, sy.l_t, strict=True))
    return Function(
        "travel_margin",
        "Room for the two belt spans of each carriage, whatever the pose.",
        "equations 36 and 37, added",
        (),
        (
            Output(
                "margin",
                (3,),
                margin,
                "m",
                "max - min - l_t for each axis; positive for a robot that can move",
            ),
        ),
        {},
    )


def position(c: Collected) -> list[Function]:
    """Positions and the limits of the workspace."""
    sy, kin = c.sy, c.kin
    definitions, p = kinematics.direct(sy)
    # Entry by entry, because SymPy would write the root of det^2 as |det|, which has no complex step.
    inverse_norm2 = Add(*((entry / kin.determinant) ** 2 for entry in kin.adjugate))
    jacobian_norm2 = Add(*(entry**2 for entry in kin.D_l))
    return [
        c.function(
            "inverse_kinematics",
            "Carriage positions that put the platform centre at p.",
            "equations 1 to 3: rail j meets the sphere of radius l_d around platform joint j",
            [c.pose],
            Output("x", (3,), sy.x, "m", "carriage positions x_1, x_2, x_3"),
            details="Not a number where a platform joint is farther from its rail than the link is long "
            "(see `reach_margin`).",
        ),
        Function(
            "direct_kinematics",
            "Platform centre for given carriage positions.",
            "equation 3: intersection of three spheres",
            (
                c.carriages,
                Argument(
                    "assembly",
                    (sy.assembly,),
                    "1",
                    "assembly branch, +1 or -1: the sign of det D_l at the wanted platform centre",
                    scalar=True,
                ),
            ),
            (Output("p", (3,), p, "m", "platform centre in the base frame"),),
            definitions,
            "Not a number where the three spheres do not meet.",
        ),
        c.function(
            "reach_margin",
            "How much farther each platform joint could be from its rail.",
            "closure of equation 2: a pose is reachable where every margin is at least zero",
            [c.pose],
            Output(
                "margin",
                (3,),
                tuple(length - sqrt(w2) for length, w2 in zip(sy.l_d, kin.rail_distance, strict=True)),
                "m",
                "link length minus distance of the platform joint from its rail, for each axis",
            ),
        ),
        c.function(
            "belt_spans",
            "Free lengths of the belt spans.",
            "equations 35 to 37; a carriage is within its limits where its two spans are positive",
            [c.pose],
            Output(
                "l_f",
                (3, 3),
                tuple(span for axis in c.machine.l_f for span in axis),
                "m",
                "free length l_f[j-1, s-1]: s = 1 between the pulleys, 2 carriage to pulley 2, "
                "3 carriage to pulley 1",
            ),
        ),
        c.function(
            "constraint_jacobians",
            "Constraint Jacobians D_l and D_r of D_l p_dot = D_r x_dot.",
            "equations 14 and 15",
            [c.pose],
            Output("D_l", (3, 3), tuple(kin.D_l), "m", "row j: linkage vector c_j - e_j in the base frame"),
            Output(
                "D_r",
                (3, 3),
                tuple(kin.D_r),
                "m",
                "diagonal: component of the linkage vector along rail j",
            ),
        ),
        c.function(
            "jacobian_condition",
            "Assembly branch and condition number of D_l in the Frobenius norm.",
            "equation 15; |D_l| |D_l^-1|, between once and three times the condition number in the 2-norm",
            [c.pose],
            Output("determinant", (), (kin.determinant,), "m^3", "det D_l; its sign is the assembly branch"),
            Output(
                "condition",
                (),
                (sqrt(jacobian_norm2 * inverse_norm2),),
                "1",
                "Frobenius condition number, at least 3",
            ),
        ),
    ]
