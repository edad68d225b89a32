"""The picture of the hexapod: base, legs in two parts, platform."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Rational, Symbol

from pkmodes_derive.machine import Machine

#: Where the two parts of a leg meet, from the base joint in lengths of the leg.
SLEEVE_FRACTION = Rational(1, 2)


def draw(m: Machine, base: Sequence[Sequence[Symbol]], lever: Sequence[Sequence[Symbol]]) -> None:
    """Declare the base and the platform as plates, and each leg as a sleeve with a rod."""
    position = m.dependent[:3]
    tops = [tuple(p + b for p, b in zip(position, arm, strict=True)) for arm in lever]
    m.draw.plate("frame", "base", *base)
    for j, (foot, top) in enumerate(zip(base, tops, strict=True), start=1):
        middle = tuple(a + SLEEVE_FRACTION * (c - a) for a, c in zip(foot, top, strict=True))
        m.draw.line("sleeve", f"base part of leg {j}", foot, middle)
        m.draw.line("link", f"rod of leg {j}", middle, top, spring=m.leg_springs[j - 1])
    m.draw.plate("platform", "platform", *tops)
