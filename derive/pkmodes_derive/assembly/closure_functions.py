"""The functions of closures: their Jacobians, and how near a pose is to a singular one."""

from __future__ import annotations

from sympy import Add, Expr, Integer, sqrt

from pkmodes_derive.assembly.condensed import NUMBER_WORDS, Condensed
from pkmodes_derive.functions import Function, Output
from pkmodes_derive.vectors import mean_square


def closures(c: Condensed) -> list[Function]:
    """Return the functions for D_l and D_r, and for the condition of D_l."""
    kin, n = c.kin, len(c.machine.independent)
    assert kin.solver is not None
    # Entry by entry, because SymPy would write the root of det^2 as |det|, which rules out a complex step.
    length = _characteristic_length(c)
    inverse_norm2 = Add(
        *(
            (kin.solver.adjugate[m, j] * length[m] / kin.solver.determinant) ** 2
            for m in range(n)
            for j in range(n)
        )
    )
    jacobian_norm2 = Add(*((kin.D_l[j, m] / length[m]) ** 2 for j in range(n) for m in range(n)))
    q, turns = c.machine.argument, bool(c.machine.rotations)
    return [
        *([_joints_function(c)] if turns else []),
        c.function(
            "constraint_jacobians",
            f"Constraint Jacobians D_l and D_r of D_l p_dot = D_r {q}_dot.",
            "equations 14 and 15",
            [c.pose],
            Output(
                "D_l",
                (n, n),
                tuple(kin.D_l),
                "m, m^2" if turns else "m",
                "row j: linkage vector c_j - e_j in the base frame"
                + (", and its moment about the platform's origin" if turns else ""),
            ),
            Output(
                "D_r",
                (n, n),
                tuple(kin.D_r),
                c.machine.unit_by(c.machine.independent[0], "m", "m^2"),
                "diagonal: component of linkage vector j along the motion of its joint",
            ),
        ),
        c.function(
            "jacobian_condition",
            "Assembly branch and condition number of D_l in the Frobenius norm.",
            f"equation 15; |D_l| |D_l^-1|, one to {NUMBER_WORDS.get(n, n)} times the condition number in the 2-norm",
            [c.pose],
            Output(
                "determinant",
                (),
                (kin.solver.determinant,),
                c.machine.vocabulary[kin.solver.determinant].unit,
                "det D_l; its sign is the assembly branch",
            ),
            Output(
                "condition",
                (),
                (sqrt(jacobian_norm2 * inverse_norm2),),
                "1",
                f"Frobenius condition number, at least {n}",
            ),
            details="Moments are divided by a characteristic length, the root mean square distance of the platform "
            "joints from the platform's origin."
            if turns
            else "",
        ),
    ]


def _characteristic_length(c: Condensed) -> list[Expr]:
    """Return what the columns of D_l are divided by: 1 for displacements, a length for rotations."""
    m = c.machine
    if m.turning is None:
        return [Integer(1)] * len(m.components)
    levers = [link.lever for link in m.links]
    return [Integer(1)] * len(m.directions) + [sqrt(mean_square(levers))] * len(m.rotations)


def _joints_function(c: Condensed) -> Function:
    """Return the function for how the joints lie on a platform that turns."""
    turning, links = c.machine.turning, c.machine.links
    assert turning is not None
    joints = [turning.given[link.lever] for link in links]
    centre = tuple(Add(*component) / len(links) for component in zip(*joints, strict=True))
    return c.function(
        "platform_joints",
        "How the joints lie on the platform: a characteristic length, and their middle.",
        "the condition number of D_l, in which the length makes rotations comparable with displacements",
        [],
        Output(
            "length",
            (),
            (sqrt(mean_square(joints)),),
            "m",
            "root mean square distance of the platform joints from the platform's origin",
        ),
        Output("middle", (3,), centre, "m", "middle of the platform joints from that origin, platform axes"),
    )
