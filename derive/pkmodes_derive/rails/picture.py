"""The picture of carriages on rails, with their links and the platform.

The robot file does not say in which plane a belt runs, how wide a parallelogram is, or how long a carriage looks:
these follow from the pulley radius and the length of the linkage.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Rational, Symbol

from pkmodes_derive.drawing import Place
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Clamp, Run
from pkmodes_derive.vectors import cross

HALF = Rational(1, 2)
#: Half the distance of the two rods of a linkage, as a fraction of their length.
HALF_WIDTH = Rational(1, 14)


@dataclass(frozen=True)
class Axis:
    """What is drawn of an axis; `ends` and `turns` are those of pulleys 1 and 2, `link` and `carriage` lengths."""

    origin: Sequence[Symbol]
    direction: Sequence[Symbol]
    position: Symbol
    ends: tuple[Symbol, Symbol]
    radius: Symbol
    turns: tuple[Symbol, Symbol]
    lever: Sequence[Symbol]
    link: Symbol
    carriage: Symbol
    runs: Sequence[Run]
    clamp: Clamp


def draw(m: Machine, axes: Sequence[Axis], *, parallelograms: bool) -> None:
    """Declare rails, carriages, links, platform, pulleys and belts; a link is a parallelogram, or one rod."""
    corners = []
    for j, a in enumerate(axes, start=1):
        up = m.draw.upright(a.direction, a.origin)
        side = cross(up, a.direction)

        def at(x: Expr, height: Expr, a: Axis = a, up: Sequence[Expr] = up) -> tuple[Expr, ...]:
            return tuple(a.origin[i] + x * a.direction[i] + height * up[i] for i in range(3))

        m.draw.line("rail", f"rail {j}", at(a.ends[1], 0), at(a.ends[0], 0))
        m.draw.block(
            "carriage", f"carriage {j}", at(a.position, 0), a.direction, a.radius + HALF * a.carriage
        )
        for sign in (1, -1) if parallelograms else (0,):
            offset = tuple(sign * HALF_WIDTH * a.link * side[i] for i in range(3))
            foot = tuple(c + d for c, d in zip(at(a.position, 0), offset, strict=True))
            corners.append(tuple(m.dependent[i] + a.lever[i] + offset[i] for i in range(3)))
            name = f"rod of linkage {j}" if parallelograms else f"rod {j}"
            m.draw.line("link", name, foot, corners[-1], place=f"link_{j}")
        for k, (end, rotation) in enumerate(zip(a.ends, a.turns, strict=True), start=1):
            m.draw.wheel("pulley", f"pulley {k} of axis {j}", at(end, 0), side, a.radius, turns=rotation)
        top, bottom = ([at(end, sign * a.radius) for end in a.ends] for sign in (1, -1))
        clamp_point = m.draw.fastened(at(a.position, a.radius), a.clamp, a.direction)
        spans: list[tuple[Place, Place]] = [
            (bottom[1], bottom[0]),
            (clamp_point, top[1]),
            (top[0], clamp_point),
        ]
        for run, span in zip(a.runs, spans, strict=True):
            m.draw.line("belt", f"belt {j}", *span, spring=run)
    m.draw.plate("platform", "platform", *corners)
