"""The working plane inside the reachable volume, with the condition number (figure 7 of the paper)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.maps import scale_beside
from pkmodes.plots.plane import Plane, limits_of, where
from pkmodes.plots.style import GREEN, INK, WIDTH, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Direction from which the volume is seen [deg].
ELEVATION, AZIMUTH = 20.0, -60.0
#: Share of the poses at each end of the colour scale: condition numbers grow without bound towards a singularity.
NEAR_SINGULAR = 0.1


@dataclass(frozen=True, eq=False)
class Volume:
    """Which poses around a plane can be evaluated.

    Attributes
    ----------
    heights, along, across : ndarray
        Values of the components of the pose, perpendicular to the plane and in it [SI].
    valid : ndarray of bool, shape (heights, along, across)
    """

    heights: Array
    along: Array
    across: Array
    valid: Array


def workspace(plane: Plane, volume: Volume | None) -> Figure:
    """Draw the condition number of the platform Jacobian in a plane, and where the plane lies in the workspace.

    Parameters
    ----------
    volume : Volume, optional
        None for a mechanism that moves in a plane.
    """
    condition = plane.dataset["condition"].values
    low, high = limits_of(condition, NEAR_SINGULAR)
    if volume is None:
        drawn = figure(WIDTH * 0.55, WIDTH * 0.7)
        flat = drawn.add_subplot()
    else:
        drawn = figure(WIDTH * 0.55)
        parts: Any = drawn.subfigures(1, 2, width_ratios=(1.5, 1.0))
        left, right = parts
        solid = left.add_axes((0.02, 0.0, 0.9, 1.0), projection="3d", computed_zorder=False)
        _volume(solid, plane, volume, low, high)
        flat = right.add_subplot()
    mesh = plane.draw(flat, condition, vmin=low, vmax=high)
    plane.label_axes(flat, left=True)
    finite = condition[np.isfinite(condition)]
    flat.set_title(f"mean {finite.mean():.2f}" if len(finite) else "")
    scale_beside(plane, flat, mesh, "condition number [1]")
    return drawn


def _volume(axes: Any, plane: Plane, volume: Volume, low: float, high: float) -> None:
    """Draw the outlines of the volume at several heights, and the plane between them."""
    from matplotlib import colormaps
    from matplotlib.colors import Normalize

    names = (plane.across, plane.along, str(plane.normal))
    factors = [plane.unit(name)[1] for name in names]
    x, y, heights = (
        v * f for v, f in zip((volume.across, volume.along, volume.heights), factors, strict=True)
    )
    at = plane.at * factors[2]
    line = {"colors": GREEN, "linewidths": 0.7, "alpha": 0.8}
    for above in (False, True):
        for height, inside in zip(heights, volume.valid, strict=True):
            if (height > at) == above and inside.any():
                axes.contour(x, y, inside.astype(float), [0.5], zdir="z", offset=height, **line)
        if not above:
            condition = plane.dataset["condition"].values
            colours = colormaps["cividis"](Normalize(low, high)(condition))
            surface = np.where(np.isfinite(condition), at, np.nan)
            settings = {"shade": False, "linewidth": 0, "antialiased": False, "rasterized": True}
            X, Y = np.meshgrid(plane.drawn(plane.across), plane.drawn(plane.along))
            axes.plot_surface(X, Y, surface, facecolors=colours, rcount=80, ccount=80, **settings)
    axes.set_title(where(plane), y=0.9)
    axes.view_init(ELEVATION, AZIMUTH)
    axes.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]), zlim=(heights[0], heights[-1]))
    for letter, name in zip("xyz", names, strict=True):
        getattr(axes, f"set_{letter}label")(plane.label(name), labelpad=2 if letter == "z" else -4)
    axes.set_box_aspect([np.ptp(values) for values in (x, y, heights)], zoom=0.95)
    axes.grid(visible=False)
    axes.tick_params(pad=-3, labelsize=7)
    axes.tick_params(axis="z", pad=1)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_pane_color((0, 0, 0, 0))
        axis.line.set_color(INK)
        axis.line.set_linewidth(0.5)
    axes.locator_params(nbins=4)
