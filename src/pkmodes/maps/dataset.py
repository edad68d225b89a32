"""The dataset of a map, with CF attributes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import pkmodes
from pkmodes.evaluation import evaluation
from pkmodes.extras import require
from pkmodes.maps.evaluating import Layout
from pkmodes.maps.pairing import EVENTS
from pkmodes.maps.places import LIST, Grid, Places
from pkmodes.maps.storage import Stored
from pkmodes.maps.tracking import Tracked
from pkmodes.maps.variables import COORDINATE, DIRECTION, DRIVE, FIRST, MODE, variables
from pkmodes.maps.variants import SAMPLE, Variants
from pkmodes.mechanism import Mechanism
from pkmodes.poses import codes_of, reasons
from pkmodes.robot.corrections import changeable
from pkmodes.robot.robot import Robot
from pkmodes.robot.text import text_of

if TYPE_CHECKING:
    import xarray

Array = NDArray[Any]
CONVENTIONS = "CF-1.11"
#: Poses of a stored map that are read and written together.
CHUNK = 16_384


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
    places : Grid or Poses
    variants : Variants
    layout : Layout
    arrays : mapping of str to ndarray or Stored, shape (rows, ...)
        The fields of `pkmodes.maps.evaluating.tails`; stored ones become Dask arrays, so that the dataset can be
        written without having it in memory.
    tracked : Tracked, optional
        Modes by shape instead of by rank.

    Raises
    ------
    MissingExtraError
        If xarray is not installed.
    """
    kind = robot.kind
    normal = places.normal(kind.directions)
    leading = (*variants.dims, *places.dims)
    shape = (*variants.shape, *places.shape)
    coordinates = layout.coordinates if layout.shapes else kind.independent
    fields = {name: _spaced(arrays[name], shape) for name in arrays}
    codes = fields.pop("code")
    names = np.array(codes_of(kind))
    fields["valid"] = _each(lambda part: part == 0, np.dtype(bool), codes)
    fields["reason"] = _each(names.__getitem__, names.dtype, codes)
    if "shape" in arrays and not layout.shapes:  # they were needed for tracking only
        del fields["shape"]
        columns = [layout.coordinates.index(name) for name in coordinates]
        fields["joint_position"] = fields["joint_position"][..., columns]
    if tracked is not None:
        fields |= _tracked(fields, codes, tracked, shape)
    known = variables(kind, normal, layout.shapes, tracked is not None)
    data = {
        v.name: (
            (*leading, *v.dims),
            fields[v.name],
            {**v.attributes, **meanings_of(robot, v.name)},
        )
        for v in known
    }
    rigid = np.array([evaluation(one).rigid_modes for one in variants.robots]).reshape(variants.shape)
    if (rigid != rigid.flat[0]).any():
        about = {"units": "1", "long_name": "number of rigid-body modes of this robot, which are left out"}
        data["rigid_modes"] = (variants.dims, rigid, about)
    found: xarray.Dataset = imported().Dataset(
        data,
        coords={**_coordinates(robot, places, variants), **labels_of(kind, layout.modes, coordinates)},
        attrs=attributes_of(robot),
    )
    return found


def _spaced(values: Any, shape: tuple[int, ...]) -> Any:
    """Return a field with the leading axes of the map; a stored one as a Dask array."""
    whole = values.reshape(*shape, *values.shape[1:])
    if not isinstance(whole, Stored):
        return whole
    from dask.array import from_array

    return from_array(whole, chunks=chunks_of(whole.shape, len(shape)), name=False)


def chunks_of(shape: tuple[int, ...], leading: int) -> tuple[int, ...]:
    """Return the size of the parts of a field: all values at about `CHUNK` poses next to each other."""
    found, left = list(shape), CHUNK
    for axis in reversed(range(leading)):
        found[axis] = min(shape[axis], max(left, 1))
        left //= shape[axis]
    return tuple(found)


def _each(function: Callable[..., Array], dtype: np.dtype[Any], *fields: Any) -> Any:
    """Apply a function to fields, part by part if they are stored."""
    if isinstance(fields[0], np.ndarray):
        return function(*fields)
    from dask.array import map_blocks

    like = max(fields, key=lambda field: field.ndim)
    return map_blocks(
        function, *fields, dtype=dtype, chunks=like.chunks, meta=np.empty((0,) * like.ndim, dtype)
    )


def _tracked(
    fields: Mapping[str, Any], codes: Any, tracked: Tracked, shape: tuple[int, ...]
) -> dict[str, Any]:
    """Return the fields of modes in the tracked order, and those that only a tracked map has."""

    def spaced(values: Array) -> Any:
        whole = values.reshape(*shape, -1)
        if isinstance(codes, np.ndarray):
            return whole
        from dask.array import from_array

        return from_array(whole, chunks=chunks_of(whole.shape, len(shape)), name=False)

    order, signs, events = (spaced(values) for values in (tracked.order, tracked.signs, tracked.events))
    found = {}
    for name in ("frequency", "in_plane", "out_of_plane"):
        found[name] = _each(_reordered, fields[name].dtype, fields[name], order)
    for name in ("platform_shape", "shape"):
        if name in fields:
            places, factors = order[..., None], signs[..., None]
            found[name] = _each(_reordered, fields[name].dtype, fields[name], places, factors)
    valid = codes[..., None] == 0
    found["rank"] = _each(
        lambda places, good: np.where(good, places + 1, 0).astype(np.int8), np.dtype(np.int8), order, valid
    )
    found["tracking"] = events
    return found


def _reordered(values: Array, places: Array, factors: Array | None = None) -> Array:
    """Return values of modes in another order; those along a further axis are multiplied by factors."""
    if factors is None:
        return np.take_along_axis(values, places, axis=-1)
    return np.take_along_axis(values, places, axis=-2) * factors


def imported() -> Any:
    """Import xarray.

    Raises
    ------
    MissingExtraError
    """
    require("maps", "map", "xarray", "pandas")
    import xarray

    return xarray


def meanings_of(robot: Robot, name: str) -> dict[str, Any]:
    """Return further attributes of a variable: what its codes mean."""
    if name == "reason":
        return dict(reasons(robot.kind))
    if name == "tracking":
        masks = np.array(list(EVENTS.values()), dtype=np.int8)
        return {"flag_masks": masks, "flag_meanings": " ".join(EVENTS)}
    return {}


def _coordinates(robot: Robot, places: Places, variants: Variants) -> dict[str, Any]:
    """Return the coordinates along the leading axes."""
    units = changeable(robot)
    found: dict[str, Any] = {
        path: (path, values, {"units": units.get(path, "1"), "long_name": f"parameter {path}"})
        for path, values in variants.swept.items()
    }
    if variants.samples is not None:
        numbers = np.arange(1, variants.samples + 1)
        found[SAMPLE] = (SAMPLE, numbers, {"units": "1", "long_name": "number of the sampled robot"})
        for path, values in variants.drawn.items():
            attributes = {"units": units.get(path, "1"), "long_name": f"parameter {path}, drawn"}
            found[path] = (SAMPLE, values, attributes)
    about = {c.name: {"units": c.unit, "long_name": c.description} for c in robot.kind.pose}
    if isinstance(places, Grid):
        found |= {name: (name, places.axes[name], about[name]) for name in places.dims}
    else:
        found |= {name: (LIST, places.table[:, i], about[name]) for i, name in enumerate(places.names)}
        labels = np.array(places.labels) if places.labels else np.arange(len(places.table))
        found[LIST] = (LIST, labels, {"units": "1", "long_name": "pose"})
    return found


def labels_of(kind: Mechanism, modes: int, coordinates: tuple[str, ...]) -> dict[str, Any]:
    """Return the coordinates along the axes after the poses."""
    numbers = np.arange(FIRST, FIRST + modes)
    return {
        MODE: (MODE, numbers, {"units": "1", "long_name": "vibration mode, rigid-body modes left out"}),
        DIRECTION: (DIRECTION, np.array(kind.directions), _named("direction of the platform's motion")),
        COORDINATE: (COORDINATE, np.array(coordinates), _named("generalised coordinate")),
        DRIVE: (DRIVE, np.array([d.name for d in kind.drives]), _named("drive")),
    }


def _named(what: str) -> dict[str, str]:
    return {"units": "1", "long_name": what}


def attributes_of(robot: Robot) -> dict[str, Any]:
    """Return the attributes of a dataset of a robot."""
    return {
        "Conventions": CONVENTIONS,
        "title": f"natural frequencies and mode shapes of {robot.name}",
        "source": f"pkmodes {pkmodes.__version__}",
        "history": f"computed by pkmodes {pkmodes.__version__}",
        "robot": robot.name,
        "mechanism": robot.mechanism,
        "robot_file": text_of(robot),
        "robot_file_name": Path(robot.source).name,
        "version": pkmodes.__version__,
        "rigid_modes": evaluation(robot).rigid_modes,
    }
