"""What a picture of the CoreXY shows: a schematic layout around the workspace.

Drawn are the idlers that the signs of `direction` ask for: run 1 leaves the tool head to the side from which it
grows, and goes along y to its motor; run 2 goes around the other way.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, Rational

from pkmodes_derive.gantry import picture
from pkmodes_derive.gantry.belts import FastenedBelt
from pkmodes_derive.gantry.plane import Travel
from pkmodes_derive.machine import Machine

#: Distance of the second belt from the first, in pulley radii.
LOOSE = Rational(3, 2)


def draw(m: Machine, within: Travel, belts: Sequence[FastenedBelt]) -> None:
    """Declare rails, beams of the frame, gantry, tool head, motor pulleys, idlers and belts."""
    _, y = m.pose
    room = picture.rectangle_around(within, belts)
    picture.frame(m, room)
    picture.beam(m, "gantry", room, y)
    picture.tool_head(m, belts, *m.platform)
    for number, belt in enumerate(belts, start=1):
        height = (picture.LAYER_IN_RADII + (number - 1) * LOOSE) * belt.radius
        _belt(m, number, belt, room, height)


def _belt(m: Machine, number: int, belt: FastenedBelt, room: picture.Rectangle, height: Expr) -> None:
    """Declare a belt in its own layer, with its motor pulley, two idlers at the front and two on the gantry.

    Seen from the tool head, run 1 leaves towards -g_x and then -g_y, run 2 towards g_x, then g_y.
    """
    (x, y), r = m.pose, belt.radius
    g_x, g_y = belt.pull[x], belt.pull[y]
    centre, half = room.centre, room.half
    own, other = centre[0] - g_x * half[0], centre[0] + g_x * half[0]
    rear, front = centre[1] - g_y * half[1], centre[1] + g_y * half[1]

    def at(a: Expr, b: Expr) -> tuple[Expr, Expr, Expr]:
        return a, b, height

    turning = (0, 0, -g_x * g_y)  # a positive rotation pulls run 1 in
    pulley = f"pulley_{number}"
    m.draw.wheel(
        "pulley", f"motor pulley {number}", at(own, rear), turning, r, turns=belt.turns, place=pulley
    )
    idlers = (own + 2 * g_x * r, y - g_y * r), (other, y + g_y * r), (other, front), (own, front)
    for place, idler in enumerate(idlers, start=1):
        m.draw.wheel("idler", f"idler {place} of belt {number}", at(*idler), (0, 0, 1), r)
    head = m.draw.fastened(at(x, y), belt.clamp, (g_x, 0, 0))
    inside = own + g_x * r
    first = at(own + 2 * g_x * r, y), at(inside, y - g_y * r), at(inside, rear)
    m.draw.line("belt", f"belt {number}", head, *first, spring=belt.runs[0])
    down = at(other, y), at(other + g_x * r, y + g_y * r), at(other + g_x * r, front)
    along = at(other, front + g_y * r), at(own, front + g_y * r)
    back = at(own - g_x * r, front), at(own - g_x * r, rear)
    m.draw.line("belt", f"belt {number}", head, *down, *along, *back, spring=belt.runs[1])
