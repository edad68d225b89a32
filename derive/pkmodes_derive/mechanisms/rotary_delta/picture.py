"""The picture of the rotary delta.

The robot file does not give the sizes of motors, reducers and parallelograms: they follow from the length of the arm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Rational, Symbol

from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Reducer

#: As fractions of the length of the arm: half the distance of the rods of a linkage, radii of motor and reducer, and
#: the distance of the motor from the arm, along the axis.
HALF_WIDTH, MOTOR_RADIUS, REDUCER_RADIUS, MOTOR_DISTANCE = (
    Rational(1, 8),
    Rational(1, 8),
    Rational(1, 6),
    Rational(1, 4),
)


@dataclass(frozen=True)
class Axis:
    """What is drawn of an axis: the arm from `origin` to `end`, its angle, and that of the motor."""

    origin: Sequence[Symbol]
    axis: Sequence[Symbol]
    end: Sequence[Expr]
    arm_turns: Symbol
    motor_turns: Symbol
    arm: Symbol
    joint: Sequence[Symbol]
    reducer: Reducer


def draw(m: Machine, axes: Sequence[Axis]) -> None:
    """Declare base, motors, reducers, arms, linkages and platform."""
    corners = []
    m.draw.plate(
        "base", "base", *(_moved_along_axis(a.origin, a, sign * HALF_WIDTH) for a in axes for sign in (1, -1))
    )
    for j, a in enumerate(axes, start=1):
        motor = _moved_along_axis(a.origin, a, MOTOR_DISTANCE)
        m.draw.wheel("motor", f"motor {j}", motor, a.axis, MOTOR_RADIUS * a.arm, turns=a.motor_turns)
        m.draw.line("shaft", f"shaft {j}", motor, a.origin)
        m.draw.wheel(
            "reducer",
            f"reducer {j}",
            a.origin,
            a.axis,
            REDUCER_RADIUS * a.arm,
            turns=a.arm_turns,
            spring=a.reducer,
        )
        m.draw.line("arm", f"arm {j}", a.origin, a.end)
        elbow = [_moved_along_axis(a.end, a, sign * HALF_WIDTH) for sign in (1, -1)]
        m.draw.line("axle", f"elbow {j}", *elbow)
        ends = [
            _moved_along_axis([m.pose[i] + a.joint[i] for i in range(3)], a, sign * HALF_WIDTH)
            for sign in (1, -1)
        ]
        for foot, end in zip(elbow, ends, strict=True):
            m.draw.line("link", f"rod of linkage {j}", foot, end, place=f"link_{j}")
        corners += ends
    m.draw.plate("platform", "platform", *corners)


def _moved_along_axis(point: Sequence[Expr], a: Axis, fraction: Expr) -> tuple[Expr, ...]:
    """Return a point moved along the axis of an arm by a fraction of its length."""
    return tuple(point[i] + fraction * a.arm * a.axis[i] for i in range(3))
