"""The picture of a machine that moves in a plane: a schematic layout around its workspace.

The robot file gives the lengths of the belt runs, not where their pulleys and idlers are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Integer, Rational

from pkmodes_derive.gantry.belts import FastenedBelt
from pkmodes_derive.gantry.plane import Travel
from pkmodes_derive.machine import Machine

HALF, ZERO = Rational(1, 2), Integer(0)
#: Distance of the pulleys from the workspace, and of the first belt from the plane of the machine, in pulley radii;
#: half length of the tool head.
MARGIN_IN_RADII, LAYER_IN_RADII, HEAD_IN_RADII = 8, 2, 4


@dataclass(frozen=True)
class Rectangle:
    """The rectangle in which pulleys and rails lie: centre and half size, with a margin around the workspace [m]."""

    centre: tuple[Expr, ...]
    half: tuple[Expr, ...]

    @property
    def sides(self) -> tuple[Expr, ...]:
        """The ends along x, left then right [m]."""
        return tuple(self.centre[0] + sign * self.half[0] for sign in (-1, 1))


def rectangle_around(travel: Travel, belts: Sequence[FastenedBelt]) -> Rectangle:
    """Return the rectangle around the workspace."""
    margin = MARGIN_IN_RADII * belts[0].radius
    ends = list(zip(travel.low, travel.high, strict=True))
    return Rectangle(tuple(HALF * (a + b) for a, b in ends), tuple(HALF * (b - a) + margin for a, b in ends))


def frame(m: Machine, rectangle: Rectangle) -> None:
    """Draw two rails along y, with the beams of the frame between their ends."""
    (_, centre), (_, half) = rectangle.centre, rectangle.half
    for name, side in zip(("left", "right"), rectangle.sides, strict=True):
        m.draw.line("rail", f"{name} rail", (side, centre - half, ZERO), (side, centre + half, ZERO))
    for name, end in (("front", -half), ("rear", half)):
        m.draw.line("frame", f"{name} beam", *((side, centre + end, ZERO) for side in rectangle.sides))


def beam(m: Machine, name: str, rectangle: Rectangle, y: Expr, height: Expr = ZERO) -> None:
    """Draw a beam from side to side, which carries the tool head."""
    m.draw.line("gantry", name, *((side, y, height) for side in rectangle.sides))


def tool_head(m: Machine, belts: Sequence[FastenedBelt], *position: Expr) -> None:
    """Draw the tool head."""
    m.draw.block("toolhead", "tool head", position, (1, 0, 0), HEAD_IN_RADII * belts[0].radius)


def straight_belt(
    m: Machine, number: int, rectangle: Rectangle, belt: FastenedBelt, along: int, clamped: Sequence[Expr]
) -> None:
    """Draw a belt between two pulleys on one line along x (0) or y (1), the motor's at the lower end.

    Run 1 leaves the clamped point for the motor pulley, run 2 for the idler and back below to the motor pulley.
    """
    r, side = belt.radius, 1 - along
    # On this side of run 1 is the axis of a pulley that pulls it in with a positive rotation.
    side_sign = 2 * along - 1

    def at(coordinate: Expr, radii: int) -> tuple[Expr, ...]:
        point = list(clamped)
        point[along], point[side] = coordinate, clamped[side] + radii * side_sign * r
        return tuple(point)

    low, high = (rectangle.centre[along] + sign * rectangle.half[along] for sign in (-1, 1))
    direction = tuple(Integer(i == along) for i in range(3))
    name, place = f"motor pulley {number}", f"pulley_{number}"
    m.draw.wheel("pulley", name, at(low, 1), (0, 0, 1), r, turns=belt.turns, place=place)
    m.draw.wheel("idler", f"idler of belt {number}", at(high, 1), (0, 0, 1), r)
    head = m.draw.fastened(clamped, belt.clamp, direction)
    m.draw.line("belt", f"belt {number}", head, at(low, 0), spring=belt.runs[0])
    return_path = at(high, 0), at(high + r, 1), at(high, 2), at(low, 2)
    m.draw.line("belt", f"belt {number}", head, *return_path, spring=belt.runs[1])
