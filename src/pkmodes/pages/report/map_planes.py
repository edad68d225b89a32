"""The plane of a map in which its report draws the robot, and a sweep in that plane."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pkmodes.core.robot.usable import USABLE
from pkmodes.machine.maps.poses import PoseGrid
from pkmodes.pages.figures.working_plane import best_conditioned, working_plane
from pkmodes.pages.plots import maps
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.plane import Plane, plane_location
from pkmodes.pages.report.blocks import Paragraph, Picture
from pkmodes.pages.report.formatting import clean, unit_text

if TYPE_CHECKING:
    import xarray

    from pkmodes.core.model import Model

#: Maximum number of values along each side of the plane that is drawn.
MAX_VALUES_PER_SIDE = 150
#: Titles, and the criterion by which a plane is chosen.
WORKING_PLANE_TITLE, MAP_PLANE_TITLE = "Over the working plane", "Over the plane of the map"
PLANE_CRITERION = (
    "with the lowest mean condition number, among those of at least half the largest area, on a coarse grid"
)


def swept_paths(dataset: xarray.Dataset) -> list[str]:
    """Return the paths of the parameters that have several values."""
    return [str(dim) for dim in dataset["frequency"].dims if "." in str(dim) and dataset.sizes[dim] > 1]


class MapSection(NamedTuple):
    """The plane of a map that its page draws.

    - plane: None where there is none
    - description: which plane that is, for a sentence; or why there is none
    - title: of the figures
    """

    plane: PoseGrid | None
    description: str
    title: str


def section_of(model: Model, dataset: xarray.Dataset) -> MapSection:
    """Choose the section of a map that its page draws; a mechanism with one component of the pose has none."""
    return (
        MapSection(*choose_plane(model, dataset))
        if len(model.mechanism.pose) > 1
        else MapSection(None, "", "")
    )


def choose_plane(model: Model, dataset: xarray.Dataset) -> tuple[PoseGrid | None, str, str]:
    """Choose the plane in which the report of a map draws the robot, and describe it.

    Returns, in this order:
    - the plane of the map, thinned out where it is finer than a picture; of a map over three components, one of its
      planes if parameters were swept, otherwise the working plane, if that lies in the map.  None where a sweep, or a
      map of one pose, has no plane.
    - which plane that is, for a sentence; or why there is none
    - a title
    """
    names = [component.name for component in model.mechanism.pose]
    varying = [name for name in names if dataset.sizes.get(name, 1) > 1]
    is_list = "pose" in dataset["frequency"].dims
    is_swept = bool(swept_paths(dataset))
    if len(varying) == 2 and not is_list:
        map_plane = _thin({name: dataset[name].values for name in names}, dataset)
        return map_plane, "the plane of the map", MAP_PLANE_TITLE
    linear = [name for name in varying if name in model.mechanism.directions]
    if len(varying) > 2 and not is_list and len(linear) < 3:
        drawn_components = linear if len(linear) == 2 else varying[:2]
        axes = {name: dataset[name].values for name in names}
        axes |= {
            name: nearest_to_zero(values) for name, values in axes.items() if name not in drawn_components
        }
        return (
            _thin(axes, dataset),
            f"the plane of {' and '.join(drawn_components)} of the map",
            MAP_PLANE_TITLE,
        )
    if len(varying) > 2 and not is_list:
        normal = model.mechanism.directions[2]
        plane = None if is_swept else working_plane(model)
        values = dataset[normal].values
        if plane is None or not values[0] <= plane.axes[normal][0] <= values[-1]:
            normal_value = best_conditioned(dataset, normal)
            axes = {
                name: np.array([normal_value]) if name == normal else dataset[name].values for name in names
            }
            axes |= {name: nearest_to_zero(dataset[name].values) for name in names if name not in linear}
            return _thin(axes, dataset), f"the plane of the map {PLANE_CRITERION}", MAP_PLANE_TITLE
        # A plane of the map itself, so that the figures and the map pose by pose show the same section.
        nearest = values[[np.argmin(np.abs(values - plane.axes[normal][0]))]]
        nearest_plane = PoseGrid({**plane.axes, normal: nearest}, plane.usable_only)
        return (
            nearest_plane,
            f"the plane of the map nearest to that {PLANE_CRITERION} of the workspace",
            WORKING_PLANE_TITLE,
        )
    if not is_list and (is_swept or not varying):
        extent = f"along {clean(varying[0])}" if varying else "at one pose"
        return (
            None,
            f"The map is {extent}: it has no plane to draw. pkmodes figures draws the robot in a plane.",
            MAP_PLANE_TITLE,
        )
    return working_plane(model), f"the plane {PLANE_CRITERION} of the workspace", WORKING_PLANE_TITLE


def nearest_to_zero(values: np.ndarray) -> np.ndarray:
    """Return the value of an axis that is nearest to 0, (1,)."""
    return values[[np.argmin(np.abs(values))]]


def _thin(axes: dict[str, np.ndarray], dataset: xarray.Dataset) -> PoseGrid:
    usable_only = bool((dataset["reason"] == USABLE).any())
    return PoseGrid(
        {name: values[:: -(-len(values) // MAX_VALUES_PER_SIDE)] for name, values in axes.items()},
        usable_only,
    )


def swept_pictures(
    model: Model, dataset: xarray.Dataset, plane_grid: PoseGrid, units: dict[str, str]
) -> Iterator[Picture | Paragraph]:
    """Draw the frequencies in the plane of a sweep, at its first and its last values.

    - plane_grid: from `choose_plane`: poses of the map
    - units: units of parameters, by path
    """
    components = [component.name for component in model.mechanism.pose]
    paths = swept_paths(dataset)
    plane_dataset = dataset[["frequency", "condition", "valid"]].sel(dict(plane_grid.axes)).sortby(paths)
    if "sample" in plane_dataset.dims:
        plane_dataset = plane_dataset.isel(sample=0)
    for end in (0, -1):
        at_end = plane_dataset.isel({path: [end] for path in paths})
        end_plane = Plane.of(at_end, components)
        if not end_plane.dataset["valid"].values.any():
            continue
        end_values = ", ".join(value_in_words(path, float(at_end[path].values[0]), units) for path in paths)
        title = f"Natural frequencies at {end_values}"
        description = (
            f"{title}, in the plane {plane_location(end_plane)}: an end of the sweep. The picture has its own "
            "colour scales; triangles mark the lowest (down) and the highest (up) frequency in the plane."
        )
        drawing = maps.frequencies(end_plane)
        if isinstance(drawing, str):
            yield Paragraph(f"{title}: {drawing}")
        else:
            yield Picture.from_drawing(drawing, title, description, description, cropped=True)


def value_in_words(path: str, number: float, units: dict[str, str]) -> str:
    """Return a value of a parameter with its unit."""
    return f"{clean(path)} = {typeset(f'{number:.6g}')} {unit_text(units.get(path, '1'))}".rstrip()


def declared_values_in_words(model: Model, paths: Sequence[str], units: dict[str, str]) -> str:
    """Return the declared values of swept parameters, for a sentence; empty without any."""
    quantities = model.robot.quantities
    return ", ".join(
        value_in_words(path, quantities[path].value, units) for path in paths if path in quantities
    )
