"""Plausible values of a robot: how far a declared value may be wrong, by the kind of quantity.

A diagnosis searches for a wrong value between a third and three times the declared one, which is more than a person
would believe of a length.  A claimed value outside of the range here is marked as implausible, and does not lead a
class that has a plausible one; no verdict depends on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pkmodes.core.robot.layout import GRAVITY, Item
from pkmodes.loop.diagnosis.problem import Parameter
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating import frame

#: A wrong length belongs to another part, some millimetres off [m], or is measured to another point, some per cent
#: off.  One below some millimetres, such as the lead of a screw, is some per cent off.
LENGTH = (0.005, 0.05)
#: Teeth and threads can be counted.
RATIO = 0.05
#: A mass may lack its screws and cables, an inertia may be that of another rotor, a stiffness may come from a
#: catalogue: each may be wrong by this factor.
FACTOR = 2.0
BY_FACTOR = ("mass", "moment of inertia", "specific stiffness", "stiffness", "torsional stiffness")
#: A machine may stand in any orientation; gravity itself varies by less than one per cent on the ground.
ON_THE_GROUND = 1.01
#: Number of standard deviations of the stated pose errors by which all poses may be shifted together.
SIGMAS = 3.0


def usual(item: Item | None, value: float, unit: str, largest: float) -> tuple[float, float] | None:
    """Return the plausible range of a suspected value; None if it is unknown.

    - item: its key; None for a group of lengths such as ``axis.span``
    - value: as declared
    - largest: largest element of the vector that it belongs to
    """
    if item is not None and item.key is GRAVITY:
        return -ON_THE_GROUND * largest, ON_THE_GROUND * largest
    if item is not None and item.key.dimension in BY_FACTOR:
        return value / FACTOR, value * FACTOR
    if item is not None and item.key.dimension == "number":
        return value - RATIO * abs(value), value + RATIO * abs(value)
    if (item is None and unit == "m") or (item is not None and item.key.dimension == "length"):
        size = max(abs(value), largest)
        away = LENGTH[1] * size if 0.0 < size < LENGTH[0] else max(LENGTH[0], LENGTH[1] * size)
        return value - away, value + away
    return None


def usual_factor(value: float) -> tuple[float, float]:
    """Return the plausible range of a relative change of a stiffness, such as that of the belts of one axis.

    - value: as declared
    """
    return (1.0 + value) / FACTOR - 1.0, (1.0 + value) * FACTOR - 1.0


def of_frame(parameters: Sequence[Parameter], data: Measurements) -> list[Parameter]:
    """Return parameters with the plausible range of a common shift of all poses, by the pose errors stated in a file.

    Where it states none, it is some millimetres, as of a part.
    """
    sigma = data.point_sigma.max(axis=0, initial=0.0)
    stated = dict(zip(data.components, sigma.tolist(), strict=True))
    linear = [k for k, unit in enumerate(data.component_units) if unit == "m"]
    arm = float(np.linalg.norm(data.points[:, linear[:2]], axis=1).max(initial=0.0))
    plane = float(sigma[linear[:2]].max(initial=0.0))

    def with_range(p: Parameter) -> Parameter:
        if p.name == frame.YAW:
            bound = (SIGMAS * plane or LENGTH[0]) / arm if arm > 0.0 else np.inf
        elif p.name.startswith(frame.OF_MEASUREMENT):
            bound = SIGMAS * stated.get(p.name.rpartition(".")[2], 0.0) or LENGTH[0]
        else:
            return p
        return replace(p, usual=(-bound, bound))

    return [with_range(p) for p in parameters]
