"""Plausible ranges of suspected values of a robot, by the kind of quantity.

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

#: Errors of a length: that of another part differs by some millimetres [m], one measured to another point by some per
#: cent.  A length below some millimetres, such as the lead of a screw, is wrong by some per cent.
LENGTH_ERRORS = (0.005, 0.05)
#: Teeth and threads can be counted.
COUNT_ERROR = 0.05
#: A mass may lack its screws and cables, an inertia may be that of another rotor, a stiffness may come from a
#: catalogue: each may be wrong by this factor.
VALUE_FACTOR = 2.0
FACTOR_DIMENSIONS = ("mass", "moment of inertia", "specific stiffness", "stiffness", "torsional stiffness")
#: A machine may stand in any orientation; gravity itself varies by less than one per cent on the ground.
GRAVITY_FACTOR = 1.01
#: Number of standard deviations of the stated pose errors by which all poses may be shifted together.
POSE_SIGMAS = 3.0


def plausible_range(item: Item | None, value: float, unit: str, largest: float) -> tuple[float, float] | None:
    """Return the plausible range of a suspected value; None if it is unknown.

    - item: its key; None for a group of lengths such as ``axis.span``
    - value: as declared
    - largest: largest element of the vector that it belongs to
    """
    if item is not None and item.key is GRAVITY:
        return -GRAVITY_FACTOR * largest, GRAVITY_FACTOR * largest
    if item is not None and item.key.dimension in FACTOR_DIMENSIONS:
        return value / VALUE_FACTOR, value * VALUE_FACTOR
    if item is not None and item.key.dimension == "number":
        return value - COUNT_ERROR * abs(value), value + COUNT_ERROR * abs(value)
    if (item is None and unit == "m") or (item is not None and item.key.dimension == "length"):
        size = max(abs(value), largest)
        deviation = (
            LENGTH_ERRORS[1] * size
            if 0.0 < size < LENGTH_ERRORS[0]
            else max(LENGTH_ERRORS[0], LENGTH_ERRORS[1] * size)
        )
        return value - deviation, value + deviation
    return None


def plausible_relative_change(value: float) -> tuple[float, float]:
    """Return the plausible range of a relative change of a stiffness, such as that of the belts of one axis.

    - value: as declared
    """
    return (1.0 + value) / VALUE_FACTOR - 1.0, (1.0 + value) * VALUE_FACTOR - 1.0


def with_frame_ranges(parameters: Sequence[Parameter], data: Measurements) -> list[Parameter]:
    """Return parameters with the plausible range of a common shift of all poses, by the pose errors stated in a file.

    Where it states none, it is some millimetres, as of a part.
    """
    sigma = data.point_sigma.max(axis=0, initial=0.0)
    stated_sigmas = dict(zip(data.components, sigma.tolist(), strict=True))
    linear = [k for k, unit in enumerate(data.component_units) if unit == "m"]
    radius = float(np.linalg.norm(data.points[:, linear[:2]], axis=1).max(initial=0.0))
    plane_sigma = float(sigma[linear[:2]].max(initial=0.0))

    def with_range(p: Parameter) -> Parameter:
        if p.name == frame.YAW:
            bound = (POSE_SIGMAS * plane_sigma or LENGTH_ERRORS[0]) / radius if radius > 0.0 else np.inf
        elif p.name.startswith(frame.OF_MEASUREMENT):
            bound = POSE_SIGMAS * stated_sigmas.get(p.name.rpartition(".")[2], 0.0) or LENGTH_ERRORS[0]
        else:
            return p
        return replace(p, usual=(-bound, bound))

    return [with_range(p) for p in parameters]
