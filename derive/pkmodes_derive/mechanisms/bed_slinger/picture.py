"""The picture of the bed slinger: the bed on two rails, below a portal with the tool head.

The bed is as large as the workspace, and centred at its coordinate; the portal stands in the middle.
"""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes_derive.gantry import picture
from pkmodes_derive.gantry.belts import FastenedBelt
from pkmodes_derive.gantry.picture import HALF
from pkmodes_derive.gantry.plane import Travel
from pkmodes_derive.machine import Machine


def draw(m: Machine, travel: Travel, belts: Sequence[FastenedBelt]) -> None:
    """Declare rails, bed, portal, tool head and belts."""
    x, y = m.pose
    rectangle = picture.rectangle_around(travel, belts)
    (low_x, low_y), (high_x, high_y) = travel.low, travel.high
    middle_x, middle_y = rectangle.centre
    half_x, half_y = (HALF * (b - a) for a, b in zip(travel.low, travel.high, strict=True))
    layer, height = picture.LAYER_IN_RADII * belts[0].radius, half_x
    for name, rail_x in (("left", middle_x - HALF * half_x), ("right", middle_x + HALF * half_x)):
        ends = ((rail_x, end, -2 * layer) for end in (low_y - half_y, high_y + half_y))
        m.draw.line("rail", f"{name} rail of the bed", *ends)
    corners = ((low_x, -1), (high_x, -1), (high_x, 1), (low_x, 1))
    m.draw.plate("bed", "bed", *((end, y + side * half_y, -layer) for end, side in corners))
    for name, side in zip(("left", "right"), rectangle.sides, strict=True):
        m.draw.line("frame", f"{name} post", (side, middle_y, -2 * layer), (side, middle_y, height))
    m.draw.line("rail", "rail of the tool head", *((side, middle_y, height) for side in rectangle.sides))
    picture.tool_head(m, belts, x, middle_y, height)
    picture.straight_belt(m, 1, rectangle, belts[0], along=0, clamped=(x, middle_y, height + layer))
    picture.straight_belt(m, 2, rectangle, belts[1], along=1, clamped=(middle_x, y, -2 * layer))
