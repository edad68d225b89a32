"""A machine at rest, seen from the still camera, with some of its bodies in colour: where to look."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.drawing import Drawing
from pkmodes.plots.sheet import Sheet
from pkmodes.plots.style import GREY, INK, PALETTE, WIDTH
from pkmodes.view.projection import camera, hull, rim
from pkmodes.view.scene import Scene
from pkmodes_description import Element

Array = NDArray[Any]
#: Colours of what is marked: the strongest first.
COLOURS = (PALETTE[1], *(colour for i, colour in enumerate(PALETTE) if i != 1))
#: Line widths of what is marked and of the rest [pt].
BOLD, THIN = 3.0, 0.9
#: Length of an arrow in sizes of the machine.
ARROW = 0.16
#: Height of the picture over its width at most.
TALL = 0.9


class Marked(NamedTuple):
    """What is marked: its name, elements by their indices, and the base axis along which it acts, or none."""

    name: str
    elements: tuple[int, ...]
    along: str = ""


def places(scene: Scene, marks: Sequence[Marked]) -> Drawing:
    """Draw a machine at the pose shown first, with some of its elements marked."""
    view = camera(scene)
    points = scene.points[scene.chosen]
    flat = points @ view.T
    span = np.ptp(flat[:, :2], axis=0)
    shape = float(np.clip(span[1] / max(span[0], 1e-12), 0.3, TALL))
    colours = {i: COLOURS[k % len(COLOURS)] for k, mark in enumerate(marks) for i in mark.elements}
    depths = [float((points[list(e.points)] @ view[2]).mean()) for e in scene.elements]

    def draw(sheet: Sheet) -> None:
        axes = sheet.panel(0.62 * WIDTH * shape + 0.5, 0.62 * WIDTH, shape=shape, frames=False).axes
        axes.set_aspect("equal")
        axes.axis("off")
        for i in np.argsort(depths, kind="stable"):
            _draw(axes, scene.elements[int(i)], points, view, colours.get(int(i), ""))
        for k, mark in enumerate(marks):
            axes.plot([], [], color=COLOURS[k % len(COLOURS)], linewidth=BOLD, label=mark.name)
            if mark.along:
                _arrow(axes, scene, points[list(scene.elements[mark.elements[0]].points)], view, mark.along)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), frameon=False)

    return Drawing(draw)


def _draw(axes: Any, element: Element, points: Array, view: Array, colour: str) -> None:
    at = points[list(element.points)]
    width, depth = (BOLD, 3) if colour else (THIN, 2)
    colour, opaque = colour or GREY, 0.85 if colour else 0.25
    area = {"facecolor": colour, "edgecolor": colour, "alpha": opaque, "linewidth": width, "zorder": depth}

    def seen(positions: Array) -> Array:
        return positions @ view[:2].T

    if element.shape == "wheel":
        axis = at[1] - at[0]
        if axis.any():
            axes.fill(*seen(rim(at[0], axis, 0.0)).T, **area)
    elif element.shape == "plate":
        axes.fill(*hull(seen(at)).T, **area)
    elif element.shape == "ball":
        axes.plot(*seen(at[:1]).T, "o", markersize=7, color=colour, zorder=depth)
    elif element.shape == "block":
        ends = seen(np.stack([2.0 * at[0] - at[1], at[1]]))
        axes.plot(*ends.T, solid_capstyle="butt", color=colour, linewidth=3.0 * width, zorder=depth)
    else:
        axes.plot(*seen(at).T, color=colour, linewidth=width, zorder=depth)


def _arrow(axes: Any, scene: Scene, at: Array, view: Array, along: str) -> None:
    """Draw an arrow with two heads through the middle of a body, along an axis of the base frame."""
    middle, reach = at.mean(axis=0), ARROW * scene.size * np.eye(3)["xyz".index(along)]
    start, end = (middle + sign * reach for sign in (-1.0, 1.0))
    axes.annotate(
        "",
        xy=end @ view[:2].T,
        xytext=start @ view[:2].T,
        arrowprops={"arrowstyle": "<->", "color": INK, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0},
        zorder=4,
    )
    axes.annotate(along, end @ view[:2].T, textcoords="offset points", xytext=(4, 4), color=INK, zorder=4)
