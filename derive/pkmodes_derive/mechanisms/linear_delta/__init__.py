r"""The linear delta: three carriages on rails in any position, parallelogram linkages, timing belts.

Carriage j is at :math:`e_j = o_j + x_j n_j`, the platform joint at :math:`c_j = p + b_j`, and the linkage between
them, :math:`s_j = c_j - e_j`, keeps its length (equations 1 to 3 of the paper).  Each carriage is pulled by a belt
over two pulleys, one of which is driven by a motor (equations 28 to 41).
"""

from __future__ import annotations

from sympy import Expr

from pkmodes_derive.machine import Machine
from pkmodes_derive.mechanisms.linear_delta.euler_route import relations
from pkmodes_derive.mechanisms.linear_delta.sample import SAMPLE
from pkmodes_derive.parts import PointMass
from pkmodes_derive.rails import axes as rails
from pkmodes_derive.rails.picture import draw
from pkmodes_derive.trilateration import spheres
from pkmodes_derive.vocabulary import AXES

__all__ = ["DIRECTIONS", "TITLE", "declare", "relations"]

TITLE = "three carriages on rails, parallelogram linkages, timing belts"
DIRECTIONS = AXES
WORDS = rails.Words(
    link="one distal linkage: both rods of the parallelogram together",
    length="length of linkage {j}",
    mass="mass of linkage {j}, both rods together",
    joint="platform joint {j} relative to the platform centre",
)


def declare(m: Machine) -> None:
    """Declare the linear delta."""
    m_p = m.tables.single("platform", "the moving platform").quantity(
        "mass", "m_p", "mass", "platform mass", above=0.0
    )[0]
    m.add_gravity()
    axes = rails.declare_axes(m, 3, WORDS)
    m.add_frame()

    p = m.platform_pose("p", "platform centre in the base frame", "p")
    x, theta = rails.coordinates(m, 3)
    distance2 = rails.close(m, axes, x, p, axes.b)
    m.differences["origin"] = "joint"  # o_j occurs only in r_j

    m.platform = p
    m.points.append(PointMass(m_p, p, "platform", "the platform"))
    rails.bodies(m, axes, x, p, axes.b)
    draw(m, rails.belts(m, axes, x, theta, axes.b), parallelograms=True)

    rails.conditions(m, axes, distance2, "distance of the platform joints from the centre")
    m.extras.append(spheres(m, [_centre(axes, x, j) for j in axes.indices], axes.l_d))
    m.sample = SAMPLE


def _centre(axes: rails.Axes, x: tuple[Expr, ...], j: int) -> tuple[Expr, ...]:
    """Return where the platform centre would be if the link had no length."""
    return tuple(axes.o[j][i] + x[j] * axes.n[j][i] - axes.b[j][i] for i in range(3))
