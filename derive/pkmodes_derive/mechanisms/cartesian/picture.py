"""The picture of the Cartesian gantry: the belt of x along the beam, the belt of y beside the left rail."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes_derive.gantry import picture
from pkmodes_derive.gantry.belts import FastenedBelt
from pkmodes_derive.gantry.plane import Travel
from pkmodes_derive.machine import Machine


def draw(m: Machine, travel: Travel, belts: Sequence[FastenedBelt]) -> None:
    """Declare rails, beams of the frame, the moving beam, tool head and belts."""
    x, y = m.pose
    rectangle = picture.rectangle_around(travel, belts)
    picture.frame(m, rectangle)
    picture.beam(m, "beam", rectangle, y)
    picture.tool_head(m, belts, *m.platform)
    height = picture.LAYER_IN_RADII * belts[0].radius
    picture.straight_belt(m, 1, rectangle, belts[0], along=0, clamped=(x, y, height))
    picture.straight_belt(m, 2, rectangle, belts[1], along=1, clamped=(rectangle.sides[0], y, height))
