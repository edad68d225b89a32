"""A machine at rest, seen from the still camera, with some of its bodies in colour: where to look."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import GREY, INK, PALETTE, WIDTH
from pkmodes.pages.view.projection import AREA_SHAPES, camera, outline
from pkmodes.pages.view.scene import Scene
from pkmodes_description import Element

Array = NDArray[Any]
#: Colours of marked bodies, the strongest first.
COLOURS = (PALETTE[1], *(colour for i, colour in enumerate(PALETTE) if i != 1))
#: Line widths of marked bodies and of the rest [pt].
BOLD, THIN = 3.0, 0.9
#: Length of an arrow relative to the size of the machine.
ARROW = 0.16
#: Largest ratio of height to width of the picture.
TALL = 0.9


class Marked(NamedTuple):
    """What is marked: its name, elements by their indices, and the base axis along which it acts, or none."""

    name: str
    elements: tuple[int, ...]
    along: str = ""


def places(scene: Scene, marks: Sequence[Marked]) -> Drawing:
    """Draw a machine at the pose shown first, with some of its elements marked."""
    view = camera(scene)
    view_points = scene.points[scene.chosen] @ view.T
    span = np.ptp(view_points[:, :2], axis=0)
    shape = float(np.clip(span[1] / max(span[0], 1e-12), 0.3, TALL))
    colours = {i: COLOURS[k % len(COLOURS)] for k, mark in enumerate(marks) for i in mark.elements}
    depths = [view_points[list(element.points), 2].mean() for element in scene.elements]

    def draw(sheet: Sheet) -> None:
        axes = sheet.panel(0.62 * WIDTH * shape + 0.5, 0.62 * WIDTH, shape=shape, frames=False).axes
        axes.set_aspect("equal")
        axes.axis("off")
        for i in np.argsort(depths, kind="stable"):
            _draw(axes, scene.elements[int(i)], view_points, colours.get(int(i), ""))
        for k, mark in enumerate(marks):
            axes.plot([], [], color=COLOURS[k % len(COLOURS)], linewidth=BOLD, label=mark.name)
            if mark.along:  # an arrow with two heads through the middle of the body
                middle = view_points[list(scene.elements[mark.elements[0]].points)].mean(axis=0)
                half_arrow = ARROW * scene.size * view[:, "xyz".index(mark.along)]
                start, end = (middle - half_arrow)[:2], (middle + half_arrow)[:2]
                heads = {"arrowstyle": "<->", "color": INK, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}
                axes.annotate("", xy=end, xytext=start, arrowprops=heads, zorder=4)
                axes.annotate(mark.along, end, textcoords="offset points", xytext=(4, 4), color=INK, zorder=4)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), frameon=False)

    return Drawing(draw)


def _draw(axes: Any, element: Element, points: Array, colour: str) -> None:
    width, depth = (BOLD, 3) if colour else (THIN, 2)
    colour, opacity = colour or GREY, 0.85 if colour else 0.25
    line = outline(element, points).T
    if element.shape in AREA_SHAPES:
        axes.fill(*line, facecolor=colour, edgecolor=colour, alpha=opacity, linewidth=width, zorder=depth)
    elif element.shape == "ball":
        axes.plot(*line, "o", markersize=7, color=colour, zorder=depth)
    elif element.shape == "block":
        axes.plot(*line, solid_capstyle="butt", color=colour, linewidth=3.0 * width, zorder=depth)
    else:
        axes.plot(*line, color=colour, linewidth=width, zorder=depth)
