"""A machine at rest with some of its bodies in colour, to show where a cause is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import FIGURE_WIDTH, GREY, INK, PALETTE
from pkmodes.pages.view.camera import camera
from pkmodes.pages.view.projection import AREA_SHAPES, outline
from pkmodes.pages.view.scene import Scene
from pkmodes_description import Element

Array = NDArray[Any]
#: Colours of marked bodies in order, the most conspicuous first.
MARK_COLOURS = (PALETTE[1], *(colour for i, colour in enumerate(PALETTE) if i != 1))
#: Line widths of marked bodies and of the others [pt].
MARKED_LINE_WIDTH, LINE_WIDTH = 3.0, 0.9
#: Half the length of an arrow, relative to the size of the machine.
ARROW_HALF_LENGTH = 0.16
#: Maximum ratio of height to width of the picture.
MAX_HEIGHT_TO_WIDTH = 0.9


class MarkedBody(NamedTuple):
    """A marked body: its name, the indices of its elements, and the base axis along which it acts, or none."""

    name: str
    elements: tuple[int, ...]
    axis: str = ""


def marked_machine(scene: Scene, marks: Sequence[MarkedBody]) -> Drawing:
    """Draw a machine at the pose that the view shows first, with some of its elements marked."""
    view = camera(scene)
    view_points = scene.points[scene.chosen] @ view.T
    span = np.ptp(view_points[:, :2], axis=0)
    height_to_width = float(np.clip(span[1] / max(span[0], 1e-12), 0.3, MAX_HEIGHT_TO_WIDTH))
    colours = {
        index: MARK_COLOURS[k % len(MARK_COLOURS)] for k, mark in enumerate(marks) for index in mark.elements
    }
    depths = [view_points[list(element.points), 2].mean() for element in scene.elements]

    def draw(sheet: Sheet) -> None:
        axes = sheet.panel(
            0.62 * FIGURE_WIDTH * height_to_width + 0.5,
            0.62 * FIGURE_WIDTH,
            height_to_width=height_to_width,
            frames=False,
        ).axes
        axes.set_aspect("equal")
        axes.axis("off")
        for index in np.argsort(depths, kind="stable"):
            _draw_element(axes, scene.elements[int(index)], view_points, colours.get(int(index), ""))
        for k, mark in enumerate(marks):
            axes.plot(
                [],
                [],
                color=MARK_COLOURS[k % len(MARK_COLOURS)],
                linewidth=MARKED_LINE_WIDTH,
                label=mark.name,
            )
            if mark.axis:  # an arrow with two heads through the middle of the body
                middle = view_points[list(scene.elements[mark.elements[0]].points)].mean(axis=0)
                half_arrow = ARROW_HALF_LENGTH * scene.size * view[:, "xyz".index(mark.axis)]
                start, end = (middle - half_arrow)[:2], (middle + half_arrow)[:2]
                arrow_style = {
                    "arrowstyle": "<->",
                    "color": INK,
                    "linewidth": 1.2,
                    "shrinkA": 0,
                    "shrinkB": 0,
                }
                axes.annotate("", xy=end, xytext=start, arrowprops=arrow_style, zorder=4)
                axes.annotate(mark.axis, end, textcoords="offset points", xytext=(4, 4), color=INK, zorder=4)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), frameon=False)

    return Drawing(draw)


def _draw_element(axes: Any, element: Element, points: Array, colour: str) -> None:
    width, drawing_order = (MARKED_LINE_WIDTH, 3) if colour else (LINE_WIDTH, 2)
    colour, opacity = colour or GREY, 0.85 if colour else 0.25
    line = outline(element, points).T
    if element.shape in AREA_SHAPES:
        axes.fill(
            *line, facecolor=colour, edgecolor=colour, alpha=opacity, linewidth=width, zorder=drawing_order
        )
    elif element.shape == "ball":
        axes.plot(*line, "o", markersize=7, color=colour, zorder=drawing_order)
    elif element.shape == "block":
        axes.plot(*line, solid_capstyle="butt", color=colour, linewidth=3.0 * width, zorder=drawing_order)
    else:
        axes.plot(*line, color=colour, linewidth=width, zorder=drawing_order)
