"""What a picture of the CoreXY shows: a schematic layout around the workspace.

The robot file gives the lengths of the belt runs, not where their idlers are.  Drawn are the idlers that the signs of
`direction` ask for: run 1 leaves the tool head to the side from which it grows, and goes along y to its motor; run 2
goes around the other way.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Integer, Rational, Symbol

from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Clamp, Run

HALF = Rational(1, 2)
#: Distance of the idlers from the workspace, and of the belts from the plane of the tool head, in pulley radii.
MARGIN, LAYER, LOOSE = 8, 2, Rational(3, 2)


@dataclass(frozen=True)
class Path:
    """What is drawn of a belt: its directions, motor pulley, both runs, and the clamp on the tool head."""

    direction: Sequence[Symbol]
    radius: Symbol
    turns: Symbol
    runs: Sequence[Run]
    clamp: Clamp


def draw(m: Machine, workspace: tuple[Sequence[Symbol], Sequence[Symbol]], paths: Sequence[Path]) -> None:
    """Declare rails, beams of the frame, gantry, tool head, motor pulleys, idlers and belts."""
    x, y = m.pose
    low, high = workspace
    room = MARGIN * paths[0].radius
    centre = tuple(HALF * (a + b) for a, b in zip(low, high, strict=True))
    half = tuple(HALF * (b - a) + room for a, b in zip(low, high, strict=True))
    zero = Integer(0)
    sides = [centre[0] + sign * half[0] for sign in (-1, 1)]
    for name, side in zip(("left", "right"), sides, strict=True):
        m.draw.line(
            "rail", f"{name} rail", (side, centre[1] - half[1], zero), (side, centre[1] + half[1], zero)
        )
    for name, end in (("front", -half[1]), ("rear", half[1])):
        m.draw.line("frame", f"{name} beam", *((side, centre[1] + end, zero) for side in sides))
    m.draw.line("gantry", "gantry", *((side, y, zero) for side in sides))
    m.draw.block("toolhead", "tool head", (x, y, zero), (1, 0, 0), 4 * paths[0].radius)
    for number, path in enumerate(paths, start=1):
        height = (LAYER + (number - 1) * LOOSE) * path.radius
        _belt(m, number, path, centre, half, height)


def _belt(
    m: Machine, number: int, path: Path, centre: Sequence[Expr], half: Sequence[Expr], height: Expr
) -> None:
    """Declare a belt in its own layer, with its motor pulley, two idlers at the front and two on the gantry.

    Seen from the tool head, run 1 leaves towards -g_x and then -g_y, run 2 towards g_x, then g_y.
    """
    (x, y), (g_x, g_y), r = m.pose, path.direction, path.radius
    own, other = centre[0] - g_x * half[0], centre[0] + g_x * half[0]
    rear, front = centre[1] - g_y * half[1], centre[1] + g_y * half[1]

    def at(a: Expr, b: Expr) -> tuple[Expr, Expr, Expr]:
        return a, b, height

    turning = (0, 0, -g_x * g_y)  # a positive rotation pulls run 1 in
    m.draw.wheel("pulley", f"motor pulley {number}", at(own, rear), turning, r, turns=path.turns)
    idlers = (own + 2 * g_x * r, y - g_y * r), (other, y + g_y * r), (other, front), (own, front)
    for place, idler in enumerate(idlers, start=1):
        m.draw.wheel("idler", f"idler {place} of belt {number}", at(*idler), (0, 0, 1), r)
    head = m.draw.fastened(at(x, y), path.clamp, (g_x, 0, 0))
    inside = own + g_x * r
    first = at(own + 2 * g_x * r, y), at(inside, y - g_y * r), at(inside, rear)
    m.draw.line("belt", f"belt {number}", head, *first, spring=path.runs[0])
    down = at(other, y), at(other + g_x * r, y + g_y * r), at(other + g_x * r, front)
    along = at(other, front + g_y * r), at(own, front + g_y * r)
    back = at(own - g_x * r, front), at(own - g_x * r, rear)
    m.draw.line("belt", f"belt {number}", head, *down, *along, *back, spring=path.runs[1])
