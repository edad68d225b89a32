"""A map in a plane, and the axes on which it is drawn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.pages.plots.labels import typeset

if TYPE_CHECKING:
    import xarray
    from matplotlib.collections import QuadMesh

    from pkmodes.pages.plots.panel import Panel

Array = NDArray[Any]
#: Fraction of the values beyond each end of the colour scale: the values at the edge of the workspace, where belts
#: become very short, would make all other differences invisible.
OUTLIER_FRACTION = 0.02
#: Ratio of the two extents of a plane above which the longer one is drawn vertically.
UPRIGHT_RATIO = 1.1
#: A quantity counts as uniform if its range is below this fraction of its colour scale or magnitude: the eye cannot
#: distinguish two such colours.
UNIFORM_FRACTION = 0.005
#: Ratio of height to width above which maps stand side by side in one row.
TALL_RATIO = 1.6


@dataclass(frozen=True, eq=False)
class Plane:
    """A map in a plane.

    - dataset: with two axes of poses, (rows, columns): the ordinate and the abscissa
    - abscissa, ordinate: names of the components of the pose on the horizontal and the vertical axis of the drawing;
      the longer one is vertical
    - normal: name of the component of the pose that is perpendicular to the plane, if any
    - normal_position: value of that component [SI]
    - constant_components: the other components of the pose, which do not vary [SI]
    """

    dataset: xarray.Dataset
    abscissa: str
    ordinate: str
    normal: str | None
    normal_position: float
    constant_components: Mapping[str, float] = field(default_factory=dict)

    @classmethod
    def of(cls, dataset: xarray.Dataset, components: Sequence[str]) -> Plane:
        """Return the plane of a map whose other axes have one value each.

        - dataset: a map
        - components: components of a pose; other axes are parameters

        Raises PkmodesError if it has not exactly two axes of poses with several values.
        """
        leading = [str(dim) for dim in dataset["frequency"].dims[:-1]]
        plane_dims = plane_axes({dim: dataset.sizes[dim] for dim in leading}, components, "map")
        constant_dims = [dim for dim in leading if dim not in plane_dims]
        constant_values = {dim: float(dataset[dim].values[0]) for dim in components if dim in constant_dims}
        is_linear = all(dataset[dim].attrs["units"] == "m" for dim in plane_dims)
        normal = next(
            (dim for dim in constant_values if is_linear and dataset[dim].attrs["units"] == "m"), None
        )
        abscissa, ordinate = abscissa_and_ordinate(
            {dim: dataset[dim].values for dim in plane_dims[::-1]},
            {dim: dataset[dim].attrs["units"] for dim in plane_dims},
        )
        # Loaded first: text that is still in a file cannot be transposed.
        plane_dataset = (
            dataset.isel(dict.fromkeys(constant_dims, 0)).load().transpose(ordinate, abscissa, ...)
        )
        return cls(
            plane_dataset,
            abscissa,
            ordinate,
            normal,
            constant_values.pop(normal, 0.0) if normal else 0.0,
            constant_values,
        )

    @property
    def is_tall(self) -> bool:
        """Whether the plane is much higher than wide."""
        return self.height_to_width > TALL_RATIO

    @property
    def is_linear(self) -> bool:
        """Whether both components are lengths, or neither is a rotation of the platform."""
        names = self.dataset["direction"].values.tolist() if "direction" in self.dataset.coords else []
        return all(
            self.dataset[name].attrs["units"] == "m" or name not in names
            for name in (self.ordinate, self.abscissa)
        )

    @property
    def height_to_width(self) -> float:
        """Height over width; 1 if the components have different units."""
        size = [np.ptp(self.dataset[name].values) for name in (self.ordinate, self.abscissa)]
        units = {self.dataset[name].attrs["units"] for name in (self.ordinate, self.abscissa)}
        return float(size[0] / size[1]) if len(units) == 1 and size[1] > 0 else 1.0

    @property
    def fixed_height_to_width(self) -> float:
        """Height over width that a panel keeps; 0 if the components have different units."""
        units = {self.dataset[name].attrs["units"] for name in (self.ordinate, self.abscissa)}
        return self.height_to_width if len(units) == 1 else 0.0

    @property
    def area(self) -> float | None:
        """Area that can be reached [m^2]; None unless both components are lengths."""
        axes = [self.dataset[name] for name in (self.ordinate, self.abscissa)]
        if any(axis.attrs["units"] != "m" for axis in axes):
            return None
        steps = [np.ptp(axis.values) / (len(axis) - 1) for axis in axes]
        return float(self.dataset["valid"].values.sum() * steps[0] * steps[1])

    def display_unit(self, name: str) -> tuple[str, float]:
        """Return the unit in which a component is drawn, and the factor from SI units."""
        return DISPLAY_UNITS[self.dataset[name].attrs["units"]]

    def display_values(self, name: str) -> Array:
        """Return the values of a component in the unit in which it is drawn."""
        values: Array = self.dataset[name].values * self.display_unit(name)[1]
        return values

    def axis_label(self, name: str) -> str:
        """Return the label of an axis."""
        return f"{name} [{self.display_unit(name)[0]}]"

    def draw(self, panel: Panel, values: Array, **settings: Any) -> QuadMesh:
        """Draw values as colours, with the poses that cannot be reached left blank.

        - values: (rows, columns)
        - settings: for `pkmodes.pages.plots.panel.Panel.cells`, such as the colour map
        """
        x, y, axes = self.display_values(self.abscissa), self.display_values(self.ordinate), panel.axes
        mesh = panel.cells(x, y, values, rasterized=True, **settings)
        if self.fixed_height_to_width:
            axes.set_aspect("equal")
        axes.set_xlim(*_outer_edges(x))
        axes.set_ylim(*_outer_edges(y))
        axes.grid(visible=False)
        axes.tick_params(length=2)
        axes.locator_params(axis="x", nbins=3)
        axes.locator_params(axis="y", nbins=6)
        return mesh

    def label_panel(self, panel: Panel, title: str, *, row: str = "", **settings: Any) -> None:
        """Label a panel as `Panel.label` does; an axis whose label is omitted has no numbers either."""
        x_label, y_label = self.axis_label(self.abscissa), self.axis_label(self.ordinate)
        panel.label(title, x=x_label, y=y_label, row=row, **settings)
        if not panel.narrow:
            panel.axes.tick_params(
                labelleft="y" not in panel.omitted_labels, labelbottom="x" not in panel.omitted_labels
            )


def abscissa_and_ordinate(axes: Mapping[str, Array], units: Mapping[str, str]) -> tuple[str, str]:
    """Return which of the two axes of a plane is drawn horizontally, and which vertically.

    - axes: the values of both, in the order of the components of the pose
    - units: their units
    """
    first, second = axes
    extent = {name: float(np.ptp(values)) for name, values in axes.items()}
    is_first_longer = units[first] == units[second] and extent[first] > UPRIGHT_RATIO * extent[second]
    return (second, first) if is_first_longer else (first, second)


def plane_axes(sizes: Mapping[str, int], components: Sequence[str], source: str) -> list[str]:
    """Return the two axes of a plane: they are components of the pose, and any other axis has one value.

    - sizes: number of values along each axis of poses and parameters
    - components: components of a pose
    - source: the source of the map, for the error message

    Raises PkmodesError if the axes do not make a plane.
    """
    plane_dims = [name for name, size in sizes.items() if size > 1]
    if len(plane_dims) != 2 or not set(plane_dims) <= set(components):
        lengths = ", ".join(f"{name}: {size}" for name, size in sizes.items())
        problem = f"expected a map over two components of the pose, found {lengths}"
        remedy = f"give several values for two of {', '.join(components)}, and one for everything else"
        raise PkmodesError(problem, source, remedy)
    return plane_dims


def plane_location(plane: Plane) -> str:
    """Return the location of a plane, such as ``z = -245 mm``, or its axes for a mechanism that moves in a plane.

    Rotations that are 0 are left out.
    """
    constant_values = {} if plane.normal is None else {plane.normal: plane.normal_position}
    other_values = {
        name: value
        for name, value in plane.constant_components.items()
        if value or plane.display_unit(name)[0] != "deg"
    }
    coordinates = []
    for name, value in (constant_values | other_values).items():
        unit, factor = plane.display_unit(name)
        coordinates.append(f"{name} = {typeset(f'{value * factor:.6g}')} {unit}")
    return ", ".join(coordinates) or f"{plane.abscissa} and {plane.ordinate}"


def colour_limits(values: Array, outlier_fraction: float = OUTLIER_FRACTION) -> tuple[float, float]:
    """Return the ends of a colour scale; `outlier_fraction` of the values lie beyond each of them."""
    finite = values[np.isfinite(values)]
    if not len(finite):
        return 0.0, 1.0
    low, high = np.quantile(finite, [outlier_fraction, 1.0 - outlier_fraction])
    return (float(low), float(high)) if high > low else (float(low) - 0.5, float(high) + 0.5)


def is_uniform(values: Array, axes: tuple[int, int] = (0, 1), scale: float | None = None) -> bool:
    """Return whether a picture of the values would have one colour: a range below `UNIFORM_FRACTION` of a scale.

    - values: NaN at poses without a value
    - axes: the two axes of the array that are those of the plane
    - scale: by default the largest magnitude of the values
    """
    values_by_pose = np.moveaxis(values, axes, (0, 1)).reshape(
        values.shape[axes[0]] * values.shape[axes[1]], -1
    )
    values_by_pose = values_by_pose[np.isfinite(values_by_pose).all(axis=1)]
    if not len(values_by_pose):
        return False
    scale = float(np.abs(values_by_pose).max()) if scale is None else scale
    return bool(np.ptp(values_by_pose, axis=0).max() <= UNIFORM_FRACTION * scale)


def _outer_edges(values: Array) -> tuple[float, float]:
    """Return the outer edges of the first and the last cell."""
    half_cell = (values[-1] - values[0]) / max(len(values) - 1, 1) / 2
    return float(values[0] - half_cell), float(values[-1] + half_cell)
