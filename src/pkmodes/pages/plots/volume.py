"""The reachable volume, coloured by the first frequency: from outside, and cut open."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.units import SHOWN
from pkmodes.machine.maps.left_out import unstable
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.panels import widened
from pkmodes.pages.plots.plane import limits_of
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import WIDTH
from pkmodes.pages.plots.workspace import AZIMUTH, ELEVATION, bare

if TYPE_CHECKING:
    import xarray

Array = NDArray[Any]
#: Most poses along each axis: cells that the eye can still tell apart.
FINEST = 30
#: Fraction of an axis at each end that has no numbers: those of two axes would collide there.
CORNER = 0.1
#: Brightness of the cell faces normal to the three axes, which makes edges visible.
LIGHT = (0.82, 0.92, 1.0)


def volume(dataset: xarray.Dataset, across: Sequence[str]) -> Drawing:
    """Draw the first frequency in a volume.

    - dataset: a map with the axes `across` alone
    - across: the three components of the pose, to be drawn as x, y and z
    """
    part = dataset.isel(_around(dataset, across)).load().transpose(*across, ...)
    evaluated = part["valid"].values & ~unstable(part).values
    values = np.where(evaluated, part["frequency"].values[..., 0], np.nan)
    shown = [SHOWN[part[name].attrs["units"]] for name in across]
    places = [part[name].values * factor for name, (_, factor) in zip(across, shown, strict=True)]
    half = part.sizes[across[1]] // 2
    cut = values.copy()
    cut[:, :half] = np.nan  # what is towards the viewer
    at = f"{across[1]} = {typeset(f'{_edges(places[1])[half]:.4g}')} {shown[1][0]}"
    low, high = widened(*limits_of(values))

    def draw(sheet: Sheet) -> None:
        from matplotlib.cm import ScalarMappable
        from matplotlib.colors import Normalize

        colours = ScalarMappable(Normalize(low, high))
        sheet.figure.set_size_inches(WIDTH, 0.42 * WIDTH)
        both_axes = [sheet.figure.add_subplot(1, 2, i, projection="3d") for i in (1, 2)]
        for axes, cells, title in zip(
            both_axes, (values, cut), ("from outside", f"cut at {at}"), strict=True
        ):
            _cells(axes, [_edges(axis_places) for axis_places in places], cells, colours)
            axes.set_title(title, y=0.95)
            _frame(axes, places, [f"{name} [{unit}]" for name, (unit, _) in zip(across, shown, strict=True)])
        sheet.figure.colorbar(
            colours, ax=both_axes, shrink=0.6, aspect=25, extend="both", pad=0.08, label="f [Hz], mode 1"
        )

    return Drawing(draw, narrow=False)


def _around(dataset: xarray.Dataset, across: Sequence[str]) -> dict[str, slice]:
    """Return the part of a map that has frequencies, thinned out where it is finer than a picture."""
    chosen = {}
    for name in across:
        other_dims = [dim for dim in dataset["valid"].dims if dim != name]
        inside = np.flatnonzero(dataset["valid"].any(other_dims).values)
        first, last = max(inside[0] - 1, 0), min(inside[-1] + 1, dataset.sizes[name] - 1)
        chosen[name] = slice(int(first), int(last) + 1, -(-int(last - first + 1) // FINEST))
    return chosen


def _edges(places: Array) -> Array:
    """Return the ends of the cells around places."""
    middles = 0.5 * (places[1:] + places[:-1])
    return np.concatenate(
        [[1.5 * places[0] - 0.5 * places[1]], middles, [1.5 * places[-1] - 0.5 * places[-2]]]
    )


def _cells(axes: Any, edges: list[Array], values: Array, colours: Any) -> None:
    """Draw the sides of cells with a value that no other such cell touches."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    filled = np.pad(np.isfinite(values), 1)
    padded = np.pad(values, 1, constant_values=np.nan)
    sides, faces = [], []
    for axis in range(3):
        low, high = ([slice(None)] * 3 for _ in range(2))
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        boundary = np.argwhere(filled[tuple(low)] != filled[tuple(high)])
        below, above = (padded[tuple(side)][tuple(boundary.T)] for side in (low, high))
        at = boundary - 1  # of the cells, which have a border
        at[:, axis] += 1  # the edge between both
        corners = np.repeat(at[:, None], 4, axis=1)
        tangential = [index for index in range(3) if index != axis]
        corners[:, [1, 2], tangential[0]] += 1
        corners[:, [2, 3], tangential[1]] += 1
        sides.append(np.stack([edges[k][corners[..., k]] for k in range(3)], axis=-1))
        colour = colours.to_rgba(np.where(np.isfinite(below), below, above))
        colour[:, :3] *= LIGHT[axis]
        faces.append(colour)
    quads = Poly3DCollection(
        np.concatenate(sides), facecolors=np.concatenate(faces), edgecolors="none", rasterized=True
    )
    axes.add_collection3d(quads)


def _frame(axes: Any, places: list[Array], labels: list[str]) -> None:
    ends = [_edges(axis_places)[[0, -1]] for axis_places in places]
    axes.set(xlim=ends[0], ylim=ends[1], zlim=ends[2])
    for letter, label in zip("xyz", labels, strict=True):
        getattr(axes, f"set_{letter}label")(label, labelpad={"x": -2, "y": 2, "z": 2}[letter])
    axes.set_box_aspect([np.ptp(extent) for extent in ends], zoom=0.88)
    axes.view_init(ELEVATION, AZIMUTH)
    bare(axes)
    for axis, (low, high) in zip((axes.xaxis, axes.yaxis, axes.zaxis), ends, strict=True):
        beside = CORNER * (high - low)
        axis.set_ticks([at for at in axis.get_majorticklocs() if low + beside <= at <= high - beside])
