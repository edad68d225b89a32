"""What a picture of the Cartesian gantry shows: the belt of x along the beam, the belt of y beside the left rail."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes_derive.gantry import picture
from pkmodes_derive.gantry.belts import FastenedBelt
from pkmodes_derive.gantry.plane import Travel
from pkmodes_derive.machine import Machine


def draw(m: Machine, within: Travel, belts: Sequence[FastenedBelt]) -> None:
    """Declare rails, beams of the frame, the moving beam, tool head and belts."""
    x, y = m.pose
    room = picture.rectangle_around(within, belts)
    picture.frame(m, room)
    picture.beam(m, "beam", room, y)
    picture.tool_head(m, belts, *m.platform)
    height = picture.LAYER_IN_RADII * belts[0].radius
    picture.straight_belt(m, 1, room, belts[0], along=0, clamped=(x, y, height))
    picture.straight_belt(m, 2, room, belts[1], along=1, clamped=(room.sides[0], y, height))
