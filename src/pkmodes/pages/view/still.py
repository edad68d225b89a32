"""A still of the machine as an SVG element: what remains without JavaScript, without WebGL, and on paper.

The mode that a page shows first at its largest displacement, with the robot at rest as thin lines.  Colours are those
of the viewer, in light and dark: style properties that `viewer.css` chooses from.
"""

from __future__ import annotations

from collections.abc import Callable
from html import escape

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.view.measured_data import measured_data
from pkmodes.pages.view.projection import camera, hull, rim
from pkmodes.pages.view.scene import AMPLITUDE, Scene
from pkmodes_description import Element

Array = NDArray[np.float64]
#: Width of the picture in its own units; limits of the height and the margin, as fractions of the width.
WIDTH, FLAT, TALL, ROOM = 800.0, 0.4, 0.9, 0.05
#: Line widths by kind of element, as fractions of the picture, then those of all others.
WIDTHS = {"rail": 0.006, "frame": 0.006, "belt": 0.0055, "arm": 0.012, "gantry": 0.012, "link": 0.006}
THIN, BLOCK, BALL, CORNERS = 0.005, 0.02, 0.009, 24
#: Colours of strain energy shares from 0 to 100 %, as in palette.js.
LIGHT = ("#c5cdd6", "#f0b340", "#d9570d", "#7d0d0d")
DARK = ("#4a5663", "#a34d12", "#f2902c", "#ffe89a")


def still(scene: Scene) -> str:
    """Return the picture of the pose and mode that are shown first.

    Returns an ``svg`` element.
    """
    pose, mode = scene.chosen, min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    factor = scene.scale(pose, mode) * AMPLITUDE * scene.size
    rest = scene.points[pose]
    moved = rest + factor * scene.displacements(pose, mode)
    view = camera(scene)
    reach = (moved - rest)[0]
    arrow = np.stack([rest[0] - reach, rest[0] + reach])
    flat = np.concatenate([rest, moved, arrow]) @ view.T
    low, high = flat[:, :2].min(axis=0), flat[:, :2].max(axis=0)
    scale = WIDTH * (1.0 - 2.0 * ROOM) / max(float(high[0] - low[0]), float(high[1] - low[1]) / TALL, 1e-12)
    height = max((high[1] - low[1]) * scale + 2.0 * ROOM * WIDTH, FLAT * WIDTH)
    middle = 0.5 * (low + high)

    def projected(points: Array) -> Array:
        turned = points @ view.T
        return np.stack(
            [
                0.5 * WIDTH + scale * (turned[..., 0] - middle[0]),
                0.5 * height - scale * (turned[..., 1] - middle[1]),
            ],
            axis=-1,
        )

    shares = np.nan_to_num(scene.shares[pose, mode])
    turns = {name: factor * scene.shapes[pose, mode, k] for k, name in enumerate(scene.coordinates)}
    drawn = [
        _line(projected(rest[list(e.points)]), "ghost", 0.0015) for e in scene.elements if e.shape == "line"
    ]
    depths = [float((moved[list(e.points)] @ view[2]).mean()) for e in scene.elements]
    for i in np.argsort(depths, kind="stable"):
        element = scene.elements[int(i)]
        at, colour = moved[list(element.points)], _colour(element, shares)
        if element.shape == "wheel":
            axis = at[1] - at[0]
            if axis.any():
                edge = projected(rim(at[0], axis, turns.get(element.turns, 0.0), CORNERS))
                drawn.append(_area(edge, "wheel", colour))
                half = CORNERS // 2
                drawn += [_line(edge[[k, k + half]], "spoke", 0.002) for k in (0, half // 2) if element.turns]
        elif element.shape == "plate":
            drawn.append(_area(hull(projected(at)), "plate", colour))
        elif element.shape == "ball":
            drawn.append(_dot(projected(at[:1])[0], "plate", BALL, colour))
        elif element.shape == "block":
            drawn.append(_line(projected(np.stack([2.0 * at[0] - at[1], at[1]])), "block", BLOCK))
        else:
            drawn.append(_line(projected(at), "line", WIDTHS.get(element.kind, THIN), colour))
    if reach.any():
        drawn.append(_line(projected(arrow), "trace", 0.003))
    drawn += _measured(scene, projected, pose, mode)
    number = mode - scene.rigid_modes + 1
    title = f"{scene.robot}, mode {number} at its largest displacement; thin lines: at rest"
    return (
        f'<svg class="pkview-svg" role="img" viewBox="0 0 {WIDTH:.0f} {height:.0f}" aria-label="{escape(title)}">'
        f"{''.join(drawn)}</svg>"
    )


def _measured(scene: Scene, projected: Callable[[Array], Array], pose: int, mode: int) -> list[str]:
    """Return marks of the measured components of a mode, none without them."""
    measured = measured_data(scene)
    drawn = []
    for entry in () if measured is None else measured["modes"]:
        if (entry["pose"], entry["mode"]) != (pose, mode):
            continue
        for point, *by in entry.get("arrows", ()):
            at, far = scene.points[pose, point], AMPLITUDE * scene.size * np.array(by)
            ends = projected(np.stack([at - far, at + far]))
            drawn += [_line(ends, "measured", 0.004), _dot(ends[1], "measured", 0.008)]
    return drawn


def _colour(element: Element, shares: Array) -> str:
    """Return the colours of a spring by its share, empty for an element that is none."""
    if element.spring < 0:
        return ""
    share = float(shares[element.spring])
    return f' style="--light:{on_scale(LIGHT, share)};--dark:{on_scale(DARK, share)}"'


def on_scale(scale: tuple[str, ...], share: float) -> str:
    """Return the colour of a share from 0 to 1 on a scale, as the viewer does."""
    at = min(max(share, 0.0), 1.0) * (len(scale) - 1)
    i = min(int(at), len(scale) - 2)
    ends = [[int(colour[k : k + 2], 16) for k in (1, 3, 5)] for colour in scale[i : i + 2]]
    mixed = (round(a + (at - i) * (b - a)) for a, b in zip(*ends, strict=True))
    return "#" + "".join(f"{value:02x}" for value in mixed)


def _points(at: Array) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in at)


def _line(at: Array, kind: str, width: float, colour: str = "") -> str:
    spring = " spring" if colour else ""
    return f'<polyline class="{kind}{spring}" points="{_points(at)}" stroke-width="{WIDTH * width:.1f}"{colour}/>'


def _area(at: Array, kind: str, colour: str = "") -> str:
    spring = " spring" if colour else ""
    return f'<polygon class="{kind}{spring}" points="{_points(at)}"{colour}/>'


def _dot(at: Array, kind: str, radius: float, colour: str = "") -> str:
    spring = " spring" if colour else ""
    return (
        f'<circle class="{kind}{spring}" cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{WIDTH * radius:.1f}"{colour}/>'
    )
