"""The reachable volume, coloured by the first frequency: from outside, and cut open."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.machine.maps.left_out import unstable_mask
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.panels import widened_limits
from pkmodes.pages.plots.plane import colour_limits
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import FIGURE_WIDTH
from pkmodes.pages.plots.workspace import AZIMUTH, ELEVATION, simplify_3d_axes

if TYPE_CHECKING:
    import xarray

Array = NDArray[Any]
#: Maximum number of cells along each axis: the eye can still tell them apart.
MAX_CELLS_PER_AXIS = 30
#: Fraction of an axis at each end without tick labels: those of two axes would collide there.
UNLABELLED_FRACTION = 0.1
#: Brightness of the cell faces normal to the three axes, which makes edges visible.
FACE_BRIGHTNESS = (0.82, 0.92, 1.0)


def volume(dataset: xarray.Dataset, component_names: Sequence[str]) -> Drawing:
    """Draw the first frequency in a volume.

    - dataset: a map with the axes `component_names` alone
    - component_names: the three components of the pose, to be drawn as x, y and z
    """
    thinned_map = (
        dataset.isel(_thinned_slices(dataset, component_names)).load().transpose(*component_names, ...)
    )
    stable = thinned_map["valid"].values & ~unstable_mask(thinned_map).values
    values = np.where(stable, thinned_map["frequency"].values[..., 0], np.nan)
    display_units = [DISPLAY_UNITS[thinned_map[name].attrs["units"]] for name in component_names]
    coordinates = [
        thinned_map[name].values * factor
        for name, (_, factor) in zip(component_names, display_units, strict=True)
    ]
    middle_index = thinned_map.sizes[component_names[1]] // 2
    cut = values.copy()
    cut[:, :middle_index] = np.nan  # remove the half that faces the viewer
    cut_position = typeset(f"{_edges(coordinates[1])[middle_index]:.4g}")
    cut_label = f"{component_names[1]} = {cut_position} {display_units[1][0]}"
    low, high = widened_limits(*colour_limits(values))

    def draw(sheet: Sheet) -> None:
        from matplotlib.cm import ScalarMappable
        from matplotlib.colors import Normalize

        colours = ScalarMappable(Normalize(low, high))
        sheet.figure.set_size_inches(FIGURE_WIDTH, 0.42 * FIGURE_WIDTH)
        both_axes = [sheet.figure.add_subplot(1, 2, i, projection="3d") for i in (1, 2)]
        for axes, cells, title in zip(
            both_axes, (values, cut), ("from outside", f"cut at {cut_label}"), strict=True
        ):
            _draw_outer_faces(
                axes, [_edges(axis_coordinates) for axis_coordinates in coordinates], cells, colours
            )
            axes.set_title(title, y=0.95)
            _style_axes(
                axes,
                coordinates,
                [f"{name} [{unit}]" for name, (unit, _) in zip(component_names, display_units, strict=True)],
            )
        sheet.figure.colorbar(
            colours, ax=both_axes, shrink=0.6, aspect=25, extend="both", pad=0.08, label="f [Hz], mode 1"
        )

    return Drawing(draw, narrow=False)


def _thinned_slices(dataset: xarray.Dataset, component_names: Sequence[str]) -> dict[str, slice]:
    """Return the slices of a map that hold its frequencies, thinned out where cells would be too small to see."""
    slices = {}
    for name in component_names:
        other_dims = [dim for dim in dataset["valid"].dims if dim != name]
        inside_indices = np.flatnonzero(dataset["valid"].any(other_dims).values)
        first, last = max(inside_indices[0] - 1, 0), min(inside_indices[-1] + 1, dataset.sizes[name] - 1)
        slices[name] = slice(int(first), int(last) + 1, -(-int(last - first + 1) // MAX_CELLS_PER_AXIS))
    return slices


def _edges(coordinates: Array) -> Array:
    """Return the cell boundaries for cell centres at these coordinates."""
    middles = 0.5 * (coordinates[1:] + coordinates[:-1])
    return np.concatenate(
        [
            [1.5 * coordinates[0] - 0.5 * coordinates[1]],
            middles,
            [1.5 * coordinates[-1] - 0.5 * coordinates[-2]],
        ]
    )


def _draw_outer_faces(axes: Any, edges: list[Array], values: Array, colours: Any) -> None:
    """Draw only the exposed faces: those between a cell with a value and one without."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    filled = np.pad(np.isfinite(values), 1)
    padded = np.pad(values, 1, constant_values=np.nan)
    quads, face_colours = [], []
    for axis in range(3):
        lower_slices, upper_slices = ([slice(None)] * 3 for _ in range(2))
        lower_slices[axis], upper_slices[axis] = slice(None, -1), slice(1, None)
        # Faces normal to this axis, between neighbours of which one has a value.
        boundary = np.argwhere(filled[tuple(lower_slices)] != filled[tuple(upper_slices)])
        lower_values, upper_values = (
            padded[tuple(side)][tuple(boundary.T)] for side in (lower_slices, upper_slices)
        )
        # The four corners of each face.
        corner_index = boundary - 1  # index without the padding
        corner_index[:, axis] += 1  # the boundary between both cells
        corners = np.repeat(corner_index[:, None], 4, axis=1)
        tangential = [index for index in range(3) if index != axis]
        corners[:, [1, 2], tangential[0]] += 1
        corners[:, [2, 3], tangential[1]] += 1
        quads.append(np.stack([edges[k][corners[..., k]] for k in range(3)], axis=-1))
        # The colour of the cell that has the value.
        colour = colours.to_rgba(np.where(np.isfinite(lower_values), lower_values, upper_values))
        colour[:, :3] *= FACE_BRIGHTNESS[axis]
        face_colours.append(colour)
    collection = Poly3DCollection(
        np.concatenate(quads), facecolors=np.concatenate(face_colours), edgecolors="none", rasterized=True
    )
    axes.add_collection3d(collection)


def _style_axes(axes: Any, coordinates: list[Array], labels: list[str]) -> None:
    ends = [_edges(axis_coordinates)[[0, -1]] for axis_coordinates in coordinates]
    axes.set(xlim=ends[0], ylim=ends[1], zlim=ends[2])
    for letter, label in zip("xyz", labels, strict=True):
        getattr(axes, f"set_{letter}label")(label, labelpad={"x": -2, "y": 2, "z": 2}[letter])
    axes.set_box_aspect([np.ptp(extent) for extent in ends], zoom=0.88)
    axes.view_init(ELEVATION, AZIMUTH)
    simplify_3d_axes(axes)
    for axis, (low, high) in zip((axes.xaxis, axes.yaxis, axes.zaxis), ends, strict=True):
        margin = UNLABELLED_FRACTION * (high - low)
        axis.set_ticks([tick for tick in axis.get_majorticklocs() if low + margin <= tick <= high - margin])
