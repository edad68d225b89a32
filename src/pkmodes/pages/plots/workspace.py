"""The working plane inside the reachable volume, with the condition number (figure 7 of the paper)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.panels import draw_own_scale
from pkmodes.pages.plots.plane import Plane, colour_limits, is_uniform, plane_location
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import FIGURE_WIDTH, GREEN, INK

Array = NDArray[Any]
#: Viewing direction of the volume [deg].
ELEVATION, AZIMUTH = 20.0, -60.0
#: Fraction of the poses beyond each end of the colour scale: condition numbers grow without bound towards a
#: singularity.
SINGULAR_FRACTION = 0.1
#: Outlines that enclose less than this fraction of the largest area are left out: at the rim of a workspace, single
#: heights have small fragments.
MIN_OUTLINE_FRACTION = 0.03


@dataclass(frozen=True, eq=False)
class ReachableVolume:
    """Which poses around a plane can be evaluated.

    - heights, ordinates, abscissas: components of the pose perpendicular to the plane, and along its two axes [SI]
    - valid: (heights, rows, columns)
    """

    heights: Array
    ordinates: Array
    abscissas: Array
    valid: Array


def workspace(plane: Plane, volume: ReachableVolume | None) -> Drawing | str:
    """Draw the condition number of the platform Jacobian in a plane, and where the plane lies in the workspace.

    - volume: None for a mechanism that moves in a plane

    Returns a sentence for a mechanism that moves in a plane with the same condition number everywhere.
    """
    condition = plane.dataset["condition"].values
    low, high = colour_limits(condition, SINGULAR_FRACTION)
    if volume is None and is_uniform(condition):
        return f"The condition number of the platform Jacobian is {plain(np.nanmedian(condition), 3)} at every pose."

    # The median, because poses next to a singularity would dominate a mean.
    finite, median_text = condition[np.isfinite(condition)], ""
    if len(finite):
        area_text = (
            "" if plane.area is None else f"\nover {typeset(plain(plane.area, 2))} m\N{SUPERSCRIPT TWO}"
        )
        median_text = f"median {np.median(finite):.2f}{area_text}"

    def draw(sheet: Sheet) -> None:
        if volume is None:
            plane_panel = sheet.panel(
                FIGURE_WIDTH * 0.55,
                FIGURE_WIDTH * 0.7,
                height_to_width=plane.fixed_height_to_width,
                scales="own",
            )
        else:
            sheet.figure.set_size_inches(FIGURE_WIDTH, FIGURE_WIDTH * 0.5)
            parts: Any = sheet.figure.subfigures(1, 2, width_ratios=(1.5, 1.0))
            volume_figure, plane_figure = parts
            volume_axes = volume_figure.add_axes(
                (0.02, 0.02, 0.86, 0.96), projection="3d", computed_zorder=False
            )
            _draw_volume(volume_axes, plane, volume, low, high)
            plane_panel = sheet.add_panel(plane_figure.add_subplot())
        mesh = plane.draw(plane_panel, condition, vmin=low, vmax=high)
        plane.label_panel(plane_panel, median_text)
        label = "condition number [1]"
        if plane.is_tall:
            plane_panel.axes.set_anchor("E")  # next to its scale
            sheet.colour_scale(mesh, label, aspect=30, shrink=0.7, extend="both")
        else:
            draw_own_scale(plane, plane_panel, mesh, label)

    return Drawing(draw, narrow=volume is None)


def _outlines(x: Array, y: Array, valid: Array) -> list[list[Array]]:
    """Return the outlines at each height, closed lines of (x, y), without those of a negligible area."""
    from matplotlib.figure import Figure

    contour_axes = Figure().add_subplot()  # only to compute the contours
    outlines = [
        contour_axes.contour(x, y, valid_plane.astype(float), [0.5]).allsegs[0] if valid_plane.any() else []
        for valid_plane in valid
    ]
    min_area = MIN_OUTLINE_FRACTION * max(
        (_enclosed_area(line) for height_outlines in outlines for line in height_outlines), default=0.0
    )
    return [
        [line for line in height_outlines if _enclosed_area(line) >= min_area] for height_outlines in outlines
    ]


def _enclosed_area(line: Any) -> float:
    """Return the area that a closed line encloses."""
    x, y = line[:-1].T
    next_points = line[1:].T
    return float(abs(np.sum(x * next_points[1] - y * next_points[0])) / 2.0)


def _draw_volume(axes: Any, plane: Plane, volume: ReachableVolume, low: float, high: float) -> None:
    """Draw the outlines of the volume at several heights, and the plane between them."""
    from matplotlib import colormaps
    from matplotlib.colors import Normalize

    names = (plane.abscissa, plane.ordinate, str(plane.normal))
    factors = [plane.display_unit(name)[1] for name in names]
    x, y, heights = (
        values * factor
        for values, factor in zip((volume.abscissas, volume.ordinates, volume.heights), factors, strict=True)
    )
    plane_height = plane.normal_position * factors[2]
    outlines = _outlines(x, y, volume.valid)
    for is_above in (False, True):
        for height, height_outlines in zip(heights, outlines, strict=True):
            for line in height_outlines if (height > plane_height) == is_above else []:
                axes.plot(line[:, 0], line[:, 1], height, color=GREEN, linewidth=0.7, alpha=0.8)
        if not is_above:
            condition = plane.dataset["condition"].values
            colours = colormaps["cividis"](Normalize(low, high)(condition))
            surface = np.where(np.isfinite(condition), plane_height, np.nan)
            settings = {"shade": False, "linewidth": 0, "antialiased": False, "rasterized": True}
            X, Y = np.meshgrid(plane.display_values(plane.abscissa), plane.display_values(plane.ordinate))
            axes.plot_surface(X, Y, surface, facecolors=colours, rcount=80, ccount=80, **settings)
    axes.set_title(plane_location(plane), y=0.9)
    axes.view_init(ELEVATION, AZIMUTH)
    axes.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]), zlim=(heights[0], heights[-1]))
    for letter, name in zip("xyz", names, strict=True):
        getattr(axes, f"set_{letter}label")(
            plane.axis_label(name), labelpad={"x": -4, "y": 1, "z": 2}[letter]
        )
    axes.set_box_aspect([np.ptp(values) for values in (x, y, heights)], zoom=0.9)
    simplify_3d_axes(axes)


def simplify_3d_axes(axes: Any) -> None:
    """Reduce axes in three dimensions to thin lines and a few numbers."""
    axes.grid(visible=False)
    axes.tick_params(pad=-3, labelsize=7)
    axes.tick_params(axis="z", pad=0)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_pane_color((0, 0, 0, 0))
        axis.line.set_color(INK)
        axis.line.set_linewidth(0.5)
    axes.locator_params(nbins=4)
