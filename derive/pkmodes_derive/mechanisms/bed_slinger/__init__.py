r"""Bed slinger: a tool head that slides along x on a fixed beam, a bed that slides along y; a belt for each.

Run 1 of a belt grows with the coordinate of its slide, run 2 shrinks by as much.

The platform is the pair of both bodies: `p_x` is the absolute motion of the tool head along x, `p_y` that of the bed
along y.  With a moving frame every body moves with it, and along its own slide relative to it: the tool head has the
velocity :math:`(\dot x + \dot u_x, \dot u_y)`, the bed, with the print on it, :math:`(\dot u_x, \dot y + \dot u_y)`.
A cable acts on the platform as in other machines: on each body along its slide, with the energy
:math:`\tfrac12 k_C \left((\delta x + u_x)^2 + (\delta y + u_y)^2\right)`.
"""

from __future__ import annotations

from sympy import Integer

from pkmodes_derive.gantry import belts, plane
from pkmodes_derive.machine import Machine
from pkmodes_derive.mechanisms.bed_slinger.picture import draw
from pkmodes_derive.mechanisms.bed_slinger.sample import SAMPLE
from pkmodes_derive.parts import Carrier, PointMass

__all__ = ["DIRECTIONS", "TITLE", "declare"]

TITLE = "tool head along x, bed along y, a belt each"
DIRECTIONS = plane.DIRECTIONS


def declare(m: Machine) -> None:
    """Declare the bed slinger."""
    m.vocabulary.letters |= belts.LETTERS

    # The robot file -----------------------------------------------------------------------------------------
    (m_h,) = m.tables.single("toolhead", "the tool head, which moves along x alone").quantity(
        "mass", "m_h", "mass", "mass of the tool head", above=0.0
    )
    (m_b,) = m.tables.single("bed", "the bed with its plate, which moves along y alone").quantity(
        "mass", "m_b", "mass", "mass of the bed", above=0.0
    )
    m.add_gravity()
    axis = m.tables.repeated("axis", 2, "one slide with its belt: x, then y")
    belt = belts.declare(axis, "free length of run {k} of belt {j} with its slide at 0")
    travel = plane.travel(m, "the tool head along x and of the bed along y")
    m.add_frame()

    # Coordinates; the first two are the pose -----------------------------------------------------------------
    x, y, *theta = plane.coordinates(
        m,
        "position of the tool head along x",
        "position of the bed along y",
        "tool head (x) and bed (y) in the base frame",
    )

    # Bodies ------------------------------------------------------------------------------------------------------
    zero = Integer(0)
    head, bed = (x, zero, zero), (zero, y, zero)
    m.platform = (x, y, zero)
    m.moving_bodies = ("tool head", "bed")
    m.points.append(PointMass(m_h, head, "toolhead", "the tool head"))
    m.points.append(PointMass(m_b, bed, "bed", "the bed"))
    m.carrier = Carrier("the bed", "on the bed", bed)
    m.rail(x)
    m.rail(y)

    # Belts, pulleys and motors --------------------------------------------------------------------------------
    pulls = ({x: Integer(1)}, {y: Integer(1)})
    draw(m, travel, belts.fasten(m, belt, theta, pulls))

    # Conditions on a pose and on a robot ---------------------------------------------------------------------
    plane.condition_of_travel(
        m,
        travel,
        "Distance of tool head and bed from the ends of their travel.",
        "the tool head or the bed is beyond its travel",
        "{0} is beyond the {1} end of its travel by {missing}",
        ("the tool head", "the bed"),
    )
    plane.condition_of_runs(m, travel, belt, pulls, "lengths and workspace")
    m.scales = plane.scales(m, (0, 1))
    m.sample = SAMPLE
