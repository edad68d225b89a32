"""A still picture of the machine as an SVG element: shown without JavaScript, without WebGL, and on paper.

It shows the first mode of a page at its largest displacement, and the robot at rest as thin lines.  Colours are as
in the viewer, in light and dark: style properties that `viewer.css` chooses from.
"""

from __future__ import annotations

from collections.abc import Callable
from html import escape

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.view.camera import camera, hiding_plates
from pkmodes.pages.view.measured_data import measured_data
from pkmodes.pages.view.projection import hull, rim
from pkmodes.pages.view.scene import AMPLITUDE, Scene
from pkmodes_description import Element

Array = NDArray[np.float64]
#: Width of the picture in its own units; limits of its height, and its margin, as fractions of the width.
WIDTH, MIN_HEIGHT, MAX_HEIGHT, MARGIN = 800.0, 0.4, 0.9, 0.05
#: Line widths by kind of element, as fractions of the width of the picture; then the line width of other kinds, the
#: width of a block, the radius of a ball, and the number of corners of the rim of a wheel.
LINE_WIDTHS = {"rail": 0.006, "frame": 0.006, "belt": 0.0055, "arm": 0.012, "gantry": 0.012, "link": 0.006}
DEFAULT_LINE_WIDTH, BLOCK_WIDTH, BALL_RADIUS, RIM_CORNERS = 0.005, 0.02, 0.009, 24
#: Kinds of plates that do not move.
FIXED_PLATES = ("base", "frame")
#: Colours of strain energy shares from 0 to 100 %, as in palette.js.
LIGHT_SCALE = ("#c5cdd6", "#f0b340", "#d9570d", "#7d0d0d")
DARK_SCALE = ("#4a5663", "#a34d12", "#f2902c", "#ffe89a")


def still_svg(scene: Scene) -> str:
    """Return the picture of the pose and mode that are shown first, an ``svg`` element."""
    pose, mode = scene.chosen, min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    factor = scene.scale(pose, mode) * AMPLITUDE * scene.size
    rest_points = scene.points[pose]
    displaced = rest_points + factor * scene.displacements(pose, mode)
    view, clear_plates = camera(scene), hiding_plates(scene)
    platform_motion = (displaced - rest_points)[0]
    arrow = np.stack([rest_points[0] - platform_motion, rest_points[0] + platform_motion])
    view_points = np.concatenate([rest_points, displaced, arrow]) @ view.T
    low, high = view_points[:, :2].min(axis=0), view_points[:, :2].max(axis=0)
    extent = max(float(high[0] - low[0]), float(high[1] - low[1]) / MAX_HEIGHT, 1e-12)
    scale = WIDTH * (1.0 - 2.0 * MARGIN) / extent
    height = max((high[1] - low[1]) * scale + 2.0 * MARGIN * WIDTH, MIN_HEIGHT * WIDTH)
    middle = 0.5 * (low + high)

    def project(points: Array) -> Array:
        rotated = points @ view.T
        return np.stack(
            [
                0.5 * WIDTH + scale * (rotated[..., 0] - middle[0]),
                0.5 * height - scale * (rotated[..., 1] - middle[1]),
            ],
            axis=-1,
        )

    shares = np.nan_to_num(scene.shares[pose, mode])
    rotations = {name: factor * scene.shapes[pose, mode, k] for k, name in enumerate(scene.coordinates)}
    svg_elements = [
        _line(project(rest_points[list(e.points)]), "ghost", 0.0015)
        for e in scene.elements
        if e.shape == "line"
    ]
    depths = [float((displaced[list(e.points)] @ view[2]).mean()) for e in scene.elements]
    for i in np.argsort(depths, kind="stable"):
        element = scene.elements[int(i)]
        positions, colour = displaced[list(element.points)], _share_style(element, shares)
        if element.shape == "wheel":
            axis = positions[1] - positions[0]
            if axis.any():
                rim_points = project(rim(positions[0], axis, rotations.get(element.turns, 0.0), RIM_CORNERS))
                svg_elements.append(_area(rim_points, "wheel", colour))
                half = RIM_CORNERS // 2
                svg_elements += [
                    _line(rim_points[[k, k + half]], "spoke", 0.002) for k in (0, half // 2) if element.turns
                ]
        elif element.shape == "plate":
            plate_kind = "plate clear" if i in clear_plates else "plate"
            plate_kind = "plate fixed" if element.kind in FIXED_PLATES else plate_kind
            svg_elements.append(_area(hull(project(positions)), plate_kind, colour))
        elif element.shape == "ball":
            svg_elements.append(_dot(project(positions[:1])[0], "plate", BALL_RADIUS, colour))
        elif element.shape == "block":
            svg_elements.append(
                _line(
                    project(np.stack([2.0 * positions[0] - positions[1], positions[1]])), "block", BLOCK_WIDTH
                )
            )
        else:
            svg_elements.append(
                _line(project(positions), "line", LINE_WIDTHS.get(element.kind, DEFAULT_LINE_WIDTH), colour)
            )
    if platform_motion.any():
        svg_elements.append(_line(project(arrow), "trace", 0.003))
    svg_elements += _measured_marks(scene, project, pose, mode)
    number = mode - scene.rigid_modes + 1
    title = f"{scene.robot}, mode {number} at its largest displacement; thin lines: at rest"
    return (
        f'<svg class="pkview-svg" role="img" viewBox="0 0 {WIDTH:.0f} {height:.0f}" aria-label="{escape(title)}">'
        f"{''.join(svg_elements)}</svg>"
    )


def _measured_marks(scene: Scene, project: Callable[[Array], Array], pose: int, mode: int) -> list[str]:
    """Return marks of the measured components of a mode, if there are any."""
    measured = measured_data(scene)
    svg_elements = []
    for entry in () if measured is None else measured["modes"]:
        if (entry["pose"], entry["mode"]) != (pose, mode):
            continue
        for point, *displacement in entry.get("arrows", ()):
            position, reach = scene.points[pose, point], AMPLITUDE * scene.size * np.array(displacement)
            ends = project(np.stack([position - reach, position + reach]))
            svg_elements += [_line(ends, "measured", 0.004), _dot(ends[1], "measured", 0.008)]
    return svg_elements


def _share_style(element: Element, shares: Array) -> str:
    """Return a style attribute with the colours of a spring by its share; empty for other elements."""
    if element.spring < 0:
        return ""
    share = float(shares[element.spring])
    return f' style="--light:{scale_colour(LIGHT_SCALE, share)};--dark:{scale_colour(DARK_SCALE, share)}"'


def scale_colour(scale: tuple[str, ...], share: float) -> str:
    """Return the colour of a share from 0 to 1 on a scale, as the viewer does."""
    position = min(max(share, 0.0), 1.0) * (len(scale) - 1)
    i = min(int(position), len(scale) - 2)
    ends = [[int(colour[k : k + 2], 16) for k in (1, 3, 5)] for colour in scale[i : i + 2]]
    mixed = (round(a + (position - i) * (b - a)) for a, b in zip(*ends, strict=True))
    return "#" + "".join(f"{value:02x}" for value in mixed)


def _points_attribute(positions: Array) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in positions)


def _line(positions: Array, kind: str, width: float, colour: str = "") -> str:
    spring = " spring" if colour else ""
    points = _points_attribute(positions)
    return f'<polyline class="{kind}{spring}" points="{points}" stroke-width="{WIDTH * width:.1f}"{colour}/>'


def _area(positions: Array, kind: str, colour: str = "") -> str:
    spring = " spring" if colour else ""
    return f'<polygon class="{kind}{spring}" points="{_points_attribute(positions)}"{colour}/>'


def _dot(centre: Array, kind: str, radius: float, colour: str = "") -> str:
    spring = " spring" if colour else ""
    return (
        f'<circle class="{kind}{spring}" cx="{centre[0]:.1f}" cy="{centre[1]:.1f}"'
        f' r="{WIDTH * radius:.1f}"{colour}/>'
    )
