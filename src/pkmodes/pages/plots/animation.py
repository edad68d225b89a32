"""A mode as an animated GIF, for pages and slides that cannot hold the interactive view."""

from __future__ import annotations

from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.extras import require
from pkmodes.pages.plots.style import INK, VERMILLION, figure, figure_style
from pkmodes.pages.view.camera import camera
from pkmodes.pages.view.projection import outline
from pkmodes.pages.view.scene import AMPLITUDE, Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pkmodes_description import Element

Array = NDArray[np.float64]
FRAME_COUNT, FRAME_MILLISECONDS = 24, 50
#: Width of the image, minimum and maximum height of the machine in it, and height of the title [inch]; then the
#: resolution, and the number of colours.
IMAGE_WIDTH, MIN_HEIGHT, MAX_HEIGHT, TITLE_HEIGHT = 7.2, 2.0, 5.2, 0.62
DOTS_PER_INCH, PALETTE_SIZE = 110, 64
#: Line widths by kind of element; then colours of elements that are not springs.
LINE_WIDTHS = {"rail": 2.5, "belt": 3.2, "link": 3.0, "arm": 6.0, "gantry": 6.0}
STEEL_GREY, PALE_GREY, DARK_GREY = "#6b7683", "#b9c0c8", "#2f3944"
#: Colour of the machine at rest, behind the moving one.
REST_COLOUR = "#e3e6ea"


def animation(scene: Scene, mode: int | None = None, amplitude: float = AMPLITUDE) -> bytes:
    """Return an animated GIF of a mode, at the pose of a scene that the view shows first.

    - mode: index among all modes, by default the first vibration mode
    - amplitude: largest displacement as a share of the robot's size

    The bytes are the same at every run.
    Raises MissingExtraError if matplotlib is not installed.
    """
    require("moving pictures", "plot", "matplotlib")
    from PIL import Image

    mode = scene.rigid_modes if mode is None else mode
    frames = scene.frames(mode=mode, count=FRAME_COUNT, amplitude=amplitude)
    view = camera(scene)
    view_frames = frames @ view.T
    plane_points = view_frames[..., :2].reshape(-1, 2)
    low, high = plane_points.min(axis=0), plane_points.max(axis=0)
    rotations = _element_rotations(scene, mode, amplitude)
    frequency = scene.frequencies[scene.chosen, mode]
    title = f"{scene.robot}, mode {mode - scene.rigid_modes + 1}: {frequency:.1f} Hz"
    rest_points = scene.points[scene.chosen] @ view.T
    margin = 0.04 * float(np.max(high - low))
    low, high = low - margin, high + margin
    machine_height = float(
        np.clip(IMAGE_WIDTH * (high[1] - low[1]) / (high[0] - low[0]), MIN_HEIGHT, MAX_HEIGHT)
    )
    images = []
    with figure_style():
        for frame, points in enumerate(view_frames):
            frame_figure = figure(machine_height + TITLE_HEIGHT, IMAGE_WIDTH)
            frame_figure.set_layout_engine("none")
            axes = frame_figure.add_axes((0.0, 0.0, 1.0, machine_height / (machine_height + TITLE_HEIGHT)))
            axes.set_axis_off()
            axes.set_aspect("equal")
            axes.set_xlim(low[0], high[0])
            axes.set_ylim(low[1], high[1])
            phase = np.sin(2.0 * np.pi * frame / FRAME_COUNT)
            _draw_at_rest(axes, scene, rest_points)
            _draw_elements(axes, scene, points, mode, phase * rotations)
            frame_figure.text(
                0.02, 1.0 - 0.28 / (machine_height + TITLE_HEIGHT), title, fontsize=14, fontweight="bold"
            )
            legend = "orange: the belts and other springs with most of the strain energy; pale: at rest"
            frame_figure.text(0.02, 1.0 - 0.52 / (machine_height + TITLE_HEIGHT), legend, fontsize=10.5)
            target = BytesIO()
            frame_figure.savefig(target, format="png", dpi=DOTS_PER_INCH, facecolor="white")
            images.append(Image.open(target).convert("RGB"))
    palette = images[0].quantize(PALETTE_SIZE, dither=Image.Dither.NONE)
    indexed_images = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    target = BytesIO()
    indexed_images[0].save(
        target,
        format="GIF",
        save_all=True,
        append_images=indexed_images[1:],
        duration=FRAME_MILLISECONDS,
        loop=0,
        optimize=True,
    )
    return target.getvalue()


def _element_rotations(scene: Scene, mode: int, amplitude: float) -> Array:
    """Return the rotation of each element about its axis at the largest displacement [rad]."""
    scale = scene.scale(scene.chosen, mode) * amplitude * scene.size
    shape = scene.shapes[scene.chosen, mode]
    return np.array(
        [
            scale * shape[scene.coordinates.index(element.turns)] if element.turns else 0.0
            for element in scene.elements
        ]
    )


def _draw_at_rest(axes: Axes, scene: Scene, points: Array) -> None:
    """Draw the lines of the machine at rest."""
    for element in scene.elements:
        line = outline(element, points).T
        if element.shape == "plate":
            axes.fill(*line, facecolor=REST_COLOUR, edgecolor=PALE_GREY, linewidth=0.8)
        elif element.shape not in ("wheel", "ball", "block"):
            axes.plot(
                *line, color=REST_COLOUR, linewidth=LINE_WIDTHS.get(element.kind, 2.5), solid_capstyle="round"
            )


def _draw_elements(axes: Axes, scene: Scene, points: Array, mode: int, rotations: Array) -> None:
    """Draw the elements from back to front."""
    shares = scene.shares[scene.chosen, mode]
    largest = float(np.nanmax(shares)) if np.isfinite(shares).any() else 1.0
    depths = [points[list(element.points), 2].mean() for element in scene.elements]
    for i in np.argsort(depths):
        element = scene.elements[int(i)]
        line = outline(element, points, rotations[i]).T
        if element.shape == "wheel":  # an ellipse with two spokes
            colour = _element_colour(element, shares, largest) if element.spring >= 0 else PALE_GREY
            axes.fill(*line, facecolor=colour, edgecolor=STEEL_GREY, linewidth=1.0)
            for corner in (0, 12) if line.shape[1] > 1 else ():
                axes.plot(*line[:, [corner, corner + 24]], color=STEEL_GREY, linewidth=0.8)
        elif element.shape == "plate":
            axes.fill(*line, facecolor=DARK_GREY, edgecolor=INK, linewidth=0.8, alpha=0.9)
        elif element.shape == "ball":
            axes.plot(*line, "o", color=DARK_GREY, markersize=7)
        elif element.shape == "block":
            axes.plot(*line, color=DARK_GREY, linewidth=9, solid_capstyle="butt")
        else:
            colour = _element_colour(element, shares, largest)
            axes.plot(
                *line, color=colour, linewidth=LINE_WIDTHS.get(element.kind, 2.5), solid_capstyle="round"
            )


def _element_colour(element: Element, shares: Array, largest: float) -> Any:
    if element.spring < 0:
        return STEEL_GREY
    from matplotlib.colors import LinearSegmentedColormap

    share = float(np.nan_to_num(shares[element.spring])) / largest if largest > 0.0 else 0.0
    return LinearSegmentedColormap.from_list("strain", [PALE_GREY, VERMILLION])(share)
