"""The dataset of a map, with CF attributes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.declaration import changeable
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.fields import INDEPENDENT, of_maps
from pkmodes.core.system.evaluation import evaluation
from pkmodes.core.system.motors import solved_system
from pkmodes.dataset.attributes import attributes_of, imported, labels_of, meanings_of
from pkmodes.dataset.variables import LIST, variables
from pkmodes.maps.evaluating import codes
from pkmodes.maps.fields import fields_of
from pkmodes.maps.layout import Layout
from pkmodes.maps.poses import Grid, Places
from pkmodes.maps.tracking import Tracked
from pkmodes.maps.variants import SAMPLE, Variants

if TYPE_CHECKING:
    import xarray

Array = NDArray[Any]


def dataset_of(
    robot: Robot,
    places: Places,
    variants: Variants,
    layout: Layout,
    arrays: Mapping[str, Any],
    tracked: Tracked | None = None,
) -> xarray.Dataset:
    """Return the dataset of a map.

    Parameters
    ----------
    robot : Robot
        As declared.
    arrays : mapping of str to ndarray or zarr.Array, shape (rows, ...)
        The fields of `pkmodes.maps.layout.tails`.
    tracked : Tracked, optional
        Modes by shape instead of by rank.

    Raises
    ------
    MissingExtraError
        If xarray is not installed.
    """
    mechanism = robot.mechanism
    normal = places.normal(mechanism.directions)
    leading = (*variants.dims, *places.dims)
    shape = (*variants.shape, *places.shape)
    coordinates = layout.coordinates if layout.shapes else mechanism.independent
    # Shapes may have been needed for tracking only.
    kept = {field.variable for field in of_maps(layout.conditions)}
    shown = [name for name in arrays if name in kept or name == "code"]
    fields = fields_of({name: arrays[name] for name in shown}, shape, np.array(codes(mechanism)), tracked)
    if len(shown) < len(arrays):
        columns = [layout.coordinates.index(name) for name in coordinates]
        for field in of_maps(layout.conditions):
            if INDEPENDENT in field.dims:
                fields[field.variable] = fields[field.variable][..., columns]
    known = variables(mechanism, normal, layout.conditions, tracked is not None)
    data = {
        v.name: (
            (*leading, *v.dims),
            fields[v.name],
            {**v.attributes, **meanings_of(robot, v.name)},
        )
        for v in known
    }
    each = [solved_system(evaluation(one), layout.drives).rigid_modes for one in variants.robots]
    rigid = np.array(each).reshape(variants.shape)
    if (rigid != rigid.flat[0]).any():
        about = {"units": "1", "long_name": "number of rigid-body modes of this robot, which are left out"}
        data["rigid_modes"] = (variants.dims, rigid, about)
    dataset: xarray.Dataset = imported().Dataset(
        data,
        coords={**_coordinates(robot, places, variants), **labels_of(mechanism, layout.modes, coordinates)},
        attrs=attributes_of(
            robot, solved_system(evaluation(robot), layout.drives).rigid_modes, layout.drives
        ),
    )
    return dataset


def _coordinates(robot: Robot, places: Places, variants: Variants) -> dict[str, Any]:
    """Return the coordinates along the leading axes."""
    units = changeable(robot)
    coordinates: dict[str, Any] = {
        path: (path, values, {"units": units.get(path, "1"), "long_name": f"parameter {path}"})
        for path, values in variants.swept.items()
    }
    if variants.samples is not None:
        numbers = np.arange(1, variants.samples + 1)
        coordinates[SAMPLE] = (SAMPLE, numbers, {"units": "1", "long_name": "number of the sampled robot"})
        for path, values in variants.drawn.items():
            attributes = {"units": units.get(path, "1"), "long_name": f"parameter {path}, drawn"}
            coordinates[path] = (SAMPLE, values, attributes)
    about = {c.name: {"units": c.unit, "long_name": c.description} for c in robot.mechanism.pose}
    if isinstance(places, Grid):
        coordinates |= {name: (name, places.axes[name], about[name]) for name in places.dims}
    else:
        coordinates |= {name: (LIST, places.table[:, i], about[name]) for i, name in enumerate(places.names)}
        labels = np.array(places.labels) if places.labels else np.arange(len(places.table))
        coordinates[LIST] = (LIST, labels, {"units": "1", "long_name": "pose"})
    return coordinates
