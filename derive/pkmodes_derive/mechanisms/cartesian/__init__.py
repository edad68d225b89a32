r"""Cartesian gantry: a tool head that slides along a beam, which moves along y; a belt for each.

Run 1 of a belt grows with the coordinate of its slide, run 2 shrinks by as much.  The mass of a motor that the beam
carries is the beam's.
"""

from __future__ import annotations

from sympy import Integer

from pkmodes_derive.gantry import belts, plane
from pkmodes_derive.machine import Machine
from pkmodes_derive.mechanisms.cartesian.picture import draw
from pkmodes_derive.mechanisms.cartesian.sample import SAMPLE
from pkmodes_derive.parts import PointMass

__all__ = ["DIRECTIONS", "TITLE", "declare"]

TITLE = "tool head along a beam, the beam along y, a belt each"
DIRECTIONS = plane.DIRECTIONS


def declare(m: Machine) -> None:
    """Declare the Cartesian gantry."""
    m.vocabulary.letters |= belts.LETTERS

    # The robot file -----------------------------------------------------------------------------------------
    (m_h,) = m.tables.single("toolhead", "the tool head").quantity(
        "mass", "m_h", "mass", "mass of the tool head", above=0.0
    )
    table = m.tables.single("beam", "the beam, which moves along y and carries the tool head")
    (m_b,) = table.quantity("mass", "m_b", "mass", "mass of the beam", at_least=0.0)
    m.add_gravity()
    axis = m.tables.repeated("axis", 2, "one slide with its belt: x, then y")
    belt = belts.declare(axis, "free length of run {k} of belt {j} with its slide at 0")
    travel = plane.travel(m, "the tool head")
    m.add_frame()

    # Coordinates; the first two are the pose -----------------------------------------------------------------
    x, y, *theta = plane.coordinates(
        m,
        "position of the tool head along x",
        "position of the tool head and beam along y",
        "tool head in the base frame",
    )

    # Bodies ------------------------------------------------------------------------------------------------------
    zero = Integer(0)
    m.platform = (x, y, zero)
    m.moving_bodies = ("tool head", "tool head")
    m.points.append(PointMass(m_h, m.platform, "platform", "the tool head"))
    beam = PointMass(m_b, (zero, y, zero), "beam", "the beam")
    m.points.append(beam)
    m.add_beam(table, "workspace.x", beam, along=x, across=y)
    m.rail(x)
    m.rail(y)

    # Belts, pulleys and motors --------------------------------------------------------------------------------
    pulls = ({x: Integer(1)}, {y: Integer(1)})
    draw(m, travel, belts.fasten(m, belt, theta, pulls))

    # Conditions on a pose and on a robot ---------------------------------------------------------------------
    plane.condition_of_travel(
        m,
        travel,
        "Distance of the tool head from the ends of its travel.",
        "the tool head is beyond its travel",
        "the tool head is beyond the {1} end of its travel along {0} by {missing}",
        DIRECTIONS,
    )
    plane.condition_of_runs(m, travel, belt, pulls, "lengths and workspace")
    m.scales = plane.scales(m, (0, 1))
    m.sample = SAMPLE
