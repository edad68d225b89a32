r"""CoreXY: a tool head on a gantry, pulled by two crossed belts with stationary motors.

The gantry runs along y and carries the tool head along x.  From the tool head each belt goes to its motor pulley on
either side: run 1 grows by :math:`g_i \cdot (\delta x, \delta y)`, run 2 shrinks by the same amount, and the pulley
pulls run 1 in by :math:`R\,\delta\vartheta_i`, so the strains of both runs are equal and opposite.
"""

from __future__ import annotations

from sympy import Integer

from pkmodes_derive.description import Requirement
from pkmodes_derive.functions import Output
from pkmodes_derive.gantry import belts, plane
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.mechanisms.corexy.picture import draw
from pkmodes_derive.mechanisms.corexy.sample import SAMPLE
from pkmodes_derive.parts import PointMass

__all__ = ["DIRECTIONS", "TITLE", "declare"]

TITLE = "tool head on a gantry, two crossed belts and motors"
DIRECTIONS = plane.DIRECTIONS


def declare(m: Machine) -> None:
    """Declare the CoreXY."""
    m.vocabulary.letters |= belts.LETTERS

    # The robot file -----------------------------------------------------------------------------------------
    (m_h,) = m.tables.single("toolhead", "the tool head").quantity(
        "mass", "m_h", "mass", "mass of the tool head", above=0.0
    )
    gantry = m.tables.single("gantry", "the beam with its rail, which moves along y only")
    (m_g,) = gantry.quantity("mass", "m_g", "mass", "mass of the gantry", at_least=0.0)
    m.add_gravity()
    path = m.tables.repeated("belt_path", 2, "one belt, from the tool head to its motor pulley and back")
    g = path.signs(
        "direction",
        "g",
        2,
        "run 1 of belt {j} grows (+1) or shrinks (-1) along component {k}",
        "g_{{{j},{k}}}",
    )
    belt = belts.declare(path, "free length of run {k} of belt {j} with the tool head at x = y = 0")
    travel = plane.travel(m, "the tool head")
    m.add_frame()

    # Coordinates; the first two are the pose -----------------------------------------------------------------
    x, y, *theta = plane.coordinates(
        m,
        "position of the tool head along x",
        "position of the tool head and gantry along y",
        "tool head in the base frame",
    )

    # Bodies ------------------------------------------------------------------------------------------------------
    zero = Integer(0)
    m.platform = (x, y, zero)
    m.moving_bodies = ("tool head", "tool head")
    m.points.append(PointMass(m_h, m.platform, "platform", "the tool head"))
    beam = PointMass(m_g, (zero, y, zero), "gantry", "the gantry")
    m.points.append(beam)
    m.add_beam(gantry, "workspace.x", beam, along=x, across=y)
    m.rail(x)
    m.rail(y)

    # Belts, pulleys and motors --------------------------------------------------------------------------------
    pulls = [{x: g_x, y: g_y} for g_x, g_y in g]
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
    plane.condition_of_runs(m, travel, belt, pulls, "lengths, direction and workspace")
    crossed = (g[0][0] * g[1][1] - g[0][1] * g[1][0]) ** 2 - 1
    m.extras.append(
        Extra(
            "crossing_margin",
            "Linear independence of the directions of the two belts.",
            "square of the determinant of the two directions, 0 or 4, minus 1",
            (Output("margin", (1,), (crossed,), "1", "positive for independent directions"),),
            arguments=(),
            definitions={},
        )
    )
    m.requirements += (
        Requirement(
            "crossing_margin",
            "above_zero",
            ("belt_path.2.direction",),
            "expected independent directions of the two belts, found the same or opposite directions",
            "write, for example, [1, -1] and [-1, -1]",
            "1",
        ),
    )
    m.scales = plane.scales(m, (0, 0))
    m.sample = SAMPLE
