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
from pkmodes.pages.report.formatting import clean, unit

if TYPE_CHECKING:
    import xarray

    from pkmodes.core.model import Model

#: Most values along each side of the plane that is drawn.
FINEST = 150
#: Titles; below, how a plane was chosen.
WORKING, OF_MAP = "Over the working plane", "Over the plane of the map"
CHOSEN = (
    "with the lowest mean condition number, among those of at least half the largest area, on a coarse grid"
)


def swept_paths(dataset: xarray.Dataset) -> list[str]:
    """Return the paths of the parameters that have several values."""
    return [str(dim) for dim in dataset["frequency"].dims if "." in str(dim) and dataset.sizes[dim] > 1]


class MapSection(NamedTuple):
    """The plane of a map that its page draws.

    - places: None where there is none
    - where: which plane that is, for a sentence; or why there is none
    - title: of the figures
    """

    places: PoseGrid | None
    where: str
    title: str


def section_of(model: Model, dataset: xarray.Dataset) -> MapSection:
    """Choose the section of a map that its page draws; a mechanism with one component of the pose has none."""
    return (
        MapSection(*plane_of(model, dataset)) if len(model.mechanism.pose) > 1 else MapSection(None, "", "")
    )


def plane_of(model: Model, dataset: xarray.Dataset) -> tuple[PoseGrid | None, str, str]:
    """Choose the plane in which the report of a map draws the robot, and describe it.

    Returns, in this order:
    - the plane of the map, thinned out where it is finer than a picture; of a map over three components, one of its
      planes if parameters were swept, otherwise the working plane, if that lies in the map.  None where a sweep, or a
      map of one pose, has no plane.
    - which plane that is, for a sentence; or why there is none
    - a title
    """
    names = [component.name for component in model.mechanism.pose]
    several = [name for name in names if dataset.sizes.get(name, 1) > 1]
    listed = "pose" in dataset["frequency"].dims
    varied = bool(swept_paths(dataset))
    if len(several) == 2 and not listed:
        places = _thinned({name: dataset[name].values for name in names}, dataset)
        return places, "the plane of the map", OF_MAP
    linear = [name for name in several if name in model.mechanism.directions]
    if len(several) > 2 and not listed and len(linear) < 3:
        shown = linear if len(linear) == 2 else several[:2]
        axes = {name: dataset[name].values for name in names}
        axes |= {name: nearest_to_zero(values) for name, values in axes.items() if name not in shown}
        return _thinned(axes, dataset), f"the plane of {' and '.join(shown)} of the map", OF_MAP
    if len(several) > 2 and not listed:
        normal = model.mechanism.directions[2]
        plane = None if varied else working_plane(model)
        values = dataset[normal].values
        if plane is None or not values[0] <= plane.axes[normal][0] <= values[-1]:
            at = best_conditioned(dataset, normal)
            axes = {name: np.array([at]) if name == normal else dataset[name].values for name in names}
            axes |= {name: nearest_to_zero(dataset[name].values) for name in names if name not in linear}
            return _thinned(axes, dataset), f"the plane of the map {CHOSEN}", OF_MAP
        # A plane of the map itself, so that the figures and the map pose by pose show the same section.
        nearest = values[[np.argmin(np.abs(values - plane.axes[normal][0]))]]
        section = PoseGrid({**plane.axes, normal: nearest}, plane.usable_only)
        return section, f"the plane of the map nearest to that {CHOSEN} of the workspace", WORKING
    if not listed and (varied or not several):
        extent = f"along {clean(several[0])}" if several else "at one pose"
        return (
            None,
            f"The map is {extent}: it has no plane to draw. pkmodes figures draws the robot in a plane.",
            OF_MAP,
        )
    return working_plane(model), f"the plane {CHOSEN} of the workspace", WORKING


def nearest_to_zero(values: np.ndarray) -> np.ndarray:
    """Return the value of an axis that is nearest to 0, (1,)."""
    return values[[np.argmin(np.abs(values))]]


def _thinned(axes: dict[str, np.ndarray], dataset: xarray.Dataset) -> PoseGrid:
    used = bool((dataset["reason"] == USABLE).any())
    return PoseGrid({name: values[:: -(-len(values) // FINEST)] for name, values in axes.items()}, used)


def swept_pictures(
    model: Model, dataset: xarray.Dataset, plane: PoseGrid, units: dict[str, str]
) -> Iterator[Picture | Paragraph]:
    """Draw the frequencies in the plane of a sweep, at its first and its last values.

    - plane: from `plane_of`: poses of the map
    - units: units of parameters, by path
    """
    components = [component.name for component in model.mechanism.pose]
    paths = swept_paths(dataset)
    drawn = dataset[["frequency", "condition", "valid"]].sel(dict(plane.axes)).sortby(paths)
    if "sample" in drawn.dims:
        drawn = drawn.isel(sample=0)
    for end in (0, -1):
        at_end = drawn.isel({path: [end] for path in paths})
        shown = Plane.of(at_end, components)
        if not shown.dataset["valid"].values.any():
            continue
        values = ", ".join(value(path, float(at_end[path].values[0]), units) for path in paths)
        title = f"Natural frequencies at {values}"
        description = (
            f"{title}, in the plane {plane_location(shown)}: an end of the sweep. The picture has its own colour "
            "scales; triangles mark the lowest (down) and the highest (up) frequency in the plane."
        )
        drawing = maps.frequencies(shown)
        if isinstance(drawing, str):
            yield Paragraph(f"{title}: {drawing}")
        else:
            yield Picture.of(drawing, title, description, description, cropped=True)


def value(path: str, number: float, units: dict[str, str]) -> str:
    """Return a value of a parameter with its unit."""
    return f"{clean(path)} = {typeset(f'{number:.6g}')} {unit(units.get(path, '1'))}".rstrip()


def declared_values(model: Model, paths: Sequence[str], units: dict[str, str]) -> str:
    """Return what swept parameters are in the robot as declared, for a sentence; empty without any."""
    quantities = model.robot.quantities
    return ", ".join(value(path, quantities[path].value, units) for path in paths if path in quantities)
