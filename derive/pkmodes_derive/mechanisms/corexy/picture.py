"""The picture of the CoreXY: a schematic layout around the workspace.

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
LAYER_SPACING = Rational(3, 2)


def draw(m: Machine, travel: Travel, belts: Sequence[FastenedBelt]) -> None:
    """Declare rails, beams of the frame, gantry, tool head, motor pulleys, idlers and belts."""
    _, y = m.pose
    rectangle = picture.rectangle_around(travel, belts)
    picture.frame(m, rectangle)
    picture.beam(m, "gantry", rectangle, y)
    picture.tool_head(m, belts, *m.platform)
    for number, belt in enumerate(belts, start=1):
        height = (picture.LAYER_IN_RADII + (number - 1) * LAYER_SPACING) * belt.radius
        _draw_belt(m, number, belt, rectangle, height)


def _draw_belt(
    m: Machine, number: int, belt: FastenedBelt, rectangle: picture.Rectangle, height: Expr
) -> None:
    """Declare a belt in its own layer, with its motor pulley, two idlers at the front and two on the gantry.

    Seen from the tool head, run 1 leaves towards -g_x and then -g_y, run 2 towards g_x, then g_y.
    """
    (x, y), r = m.pose, belt.radius
    g_x, g_y = belt.pull[x], belt.pull[y]
    centre, half = rectangle.centre, rectangle.half
    motor_side, far_side = centre[0] - g_x * half[0], centre[0] + g_x * half[0]
    rear, front = centre[1] - g_y * half[1], centre[1] + g_y * half[1]

    def at(a: Expr, b: Expr) -> tuple[Expr, Expr, Expr]:
        return a, b, height

    axis = (0, 0, -g_x * g_y)  # a positive rotation pulls run 1 in
    pulley = f"pulley_{number}"
    m.draw.wheel(
        "pulley", f"motor pulley {number}", at(motor_side, rear), axis, r, turns=belt.turns, place=pulley
    )
    idlers = (
        (motor_side + 2 * g_x * r, y - g_y * r),
        (far_side, y + g_y * r),
        (far_side, front),
        (motor_side, front),
    )
    for idler_number, idler in enumerate(idlers, start=1):
        m.draw.wheel("idler", f"idler {idler_number} of belt {number}", at(*idler), (0, 0, 1), r)
    head = m.draw.fastened(at(x, y), belt.clamp, (g_x, 0, 0))
    inside = motor_side + g_x * r
    run_1_path = at(motor_side + 2 * g_x * r, y), at(inside, y - g_y * r), at(inside, rear)
    m.draw.line("belt", f"belt {number}", head, *run_1_path, spring=belt.runs[0])
    run_2_start = at(far_side, y), at(far_side + g_x * r, y + g_y * r), at(far_side + g_x * r, front)
    run_2_front = at(far_side, front + g_y * r), at(motor_side, front + g_y * r)
    run_2_end = at(motor_side - g_x * r, front), at(motor_side - g_x * r, rear)
    m.draw.line("belt", f"belt {number}", head, *run_2_start, *run_2_front, *run_2_end, spring=belt.runs[1])
