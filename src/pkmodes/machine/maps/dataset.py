"""The dataset of a map, with CF attributes, from the rows that were computed.

Its fields are in memory, or Dask arrays if the rows are stored.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from math import prod
from typing import TYPE_CHECKING, Any
from uuid import uuid4

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.fields import ALL_CONDITIONS, INDEPENDENT, MODE, map_fields
from pkmodes.core.system.evaluation import evaluation
from pkmodes.core.system.motors import solved_system
from pkmodes.machine.dataset.attributes import attributes_of, axis_coordinates, code_attributes, import_xarray
from pkmodes.machine.dataset.variables import POSE_AXIS, variables
from pkmodes.machine.maps.evaluating import MapLayout, code_reasons
from pkmodes.machine.maps.poses import MapPoses, PoseGrid
from pkmodes.machine.maps.tracking import Tracked
from pkmodes.machine.maps.variants import SAMPLE, Variants

if TYPE_CHECKING:
    import xarray

Array = NDArray[Any]
#: Poses of a stored map that are read and written at once.
CHUNK_POSES = 16_384


def dataset_of(
    robot: Robot,
    poses: MapPoses,
    variants: Variants,
    layout: MapLayout,
    arrays: Mapping[str, Any],
    tracked: Tracked | None = None,
) -> xarray.Dataset:
    """Return the dataset of a map.

    - robot: as declared
    - arrays: the fields of `pkmodes.machine.maps.evaluating.field_layouts`, each (rows, ...)
    - tracked: modes by shape instead of by rank

    Raises MissingExtraError if xarray is not installed.
    """
    mechanism = robot.mechanism
    normal = poses.normal(mechanism.directions)
    leading_dims = (*variants.dims, *poses.dims)
    shape = (*variants.shape, *poses.shape)
    coordinates = layout.coordinates if layout.shapes else mechanism.independent
    # Shapes may have been needed for tracking only.
    kept_variables = {field.variable for field in map_fields(layout.conditions)}
    array_names = [name for name in arrays if name in kept_variables or name == "code"]
    fields = _fields_of(
        {name: arrays[name] for name in array_names}, shape, np.array(code_reasons(mechanism)), tracked
    )
    if len(array_names) < len(arrays):
        columns = [layout.coordinates.index(name) for name in coordinates]
        for field in map_fields(layout.conditions):
            if INDEPENDENT in field.dims:
                fields[field.variable] = fields[field.variable][..., columns]
    descriptions = variables(mechanism, normal, layout.conditions, tracked is not None)
    data = {
        description.name: (
            (*leading_dims, *description.dims),
            fields[description.name],
            {**description.attributes, **code_attributes(robot, description.name)},
        )
        for description in descriptions
    }
    rigid_counts = [
        solved_system(evaluation(variant), layout.drives).rigid_modes for variant in variants.robots
    ]
    rigid_modes = np.array(rigid_counts).reshape(variants.shape)
    if (rigid_modes != rigid_modes.flat[0]).any():
        rigid_attributes = {
            "units": "1",
            "long_name": "number of rigid-body modes of this robot, which are left out",
        }
        data["rigid_modes"] = (variants.dims, rigid_modes, rigid_attributes)
    dataset: xarray.Dataset = import_xarray().Dataset(
        data,
        coords={
            **_coordinates(robot, poses, variants),
            **axis_coordinates(mechanism, layout.modes, coordinates),
        },
        attrs=attributes_of(
            robot, solved_system(evaluation(robot), layout.drives).rigid_modes, layout.drives
        ),
    )
    return dataset


def _coordinates(robot: Robot, poses: MapPoses, variants: Variants) -> dict[str, Any]:
    """Return the coordinates along the leading axes."""
    units = changeable_units(robot)
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
    pose_attributes = {c.name: {"units": c.unit, "long_name": c.description} for c in robot.mechanism.pose}
    if isinstance(poses, PoseGrid):
        coordinates |= {name: (name, poses.axes[name], pose_attributes[name]) for name in poses.dims}
    else:
        coordinates |= {
            name: (POSE_AXIS, poses.table[:, i], pose_attributes[name]) for i, name in enumerate(poses.names)
        }
        labels = np.array(poses.labels) if poses.labels else np.arange(len(poses.table))
        coordinates[POSE_AXIS] = (POSE_AXIS, labels, {"units": "1", "long_name": "pose"})
    return coordinates


def _fields_of(
    arrays: Mapping[str, Any], shape: tuple[int, ...], reasons: Array, tracked: Tracked | None = None
) -> dict[str, Any]:
    """Return the fields of a map.

    - arrays: the fields of `pkmodes.machine.maps.evaluating.field_layouts`, each (rows, ...); stored ones become Dask
      arrays, so that a map can be written without having it in memory
    - shape: shape of the map; rows are in C order
    - reasons: reasons by code
    - tracked: modes by shape instead of by rank
    """
    fields = {name: _reshape_to_map(arrays[name], shape) for name in arrays}
    code = fields.pop("code")
    fields["valid"] = _apply(lambda part: part == 0, np.dtype(bool), code)
    fields["reason"] = _apply(reasons.__getitem__, reasons.dtype, code)
    return fields if tracked is None else fields | _tracked_fields(fields, tracked, shape)


def chunks_of(shape: tuple[int, ...], leading: int) -> tuple[int, ...]:
    """Return the size of the parts of a field: all values at about `CHUNK_POSES` consecutive poses."""
    chunks, remaining = list(shape), CHUNK_POSES
    for axis in reversed(range(leading)):
        chunks[axis] = min(shape[axis], max(remaining, 1))
        remaining //= shape[axis]
    return tuple(chunks)


def _reshape_to_map(values: Any, shape: tuple[int, ...]) -> Any:
    """Return a field with the leading axes of the map."""
    map_shape = (*shape, *values.shape[1:])
    if isinstance(values, np.ndarray):
        return values.reshape(map_shape)
    from dask.array import map_blocks
    from dask.array.core import normalize_chunks

    dtype = np.dtype(values.dtype.str)  # without the byte order that Zarr states, which netCDF4 misreads

    def read_part(block_info: Any) -> Array:
        """Read the rows of a part, which are consecutive."""
        starts, sizes = zip(*[(a, b - a) for a, b in block_info[None]["array-location"]], strict=True)
        first, count = np.ravel_multi_index(starts[: len(shape)], shape), prod(sizes[: len(shape)])
        return np.asarray(values[first : first + count], dtype).reshape(sizes)

    chunks = normalize_chunks(chunks_of(map_shape, len(shape)), map_shape)
    meta = np.empty((0,) * len(map_shape), dtype)
    # Without a name, Dask would compute one from the values of all rows.
    return map_blocks(read_part, name=f"rows-{uuid4()}", chunks=chunks, dtype=dtype, meta=meta)


def _apply(function: Callable[..., Array], dtype: np.dtype[Any], *fields: Any) -> Any:
    """Apply a function to fields, part by part if they are stored."""
    if isinstance(fields[0], np.ndarray):
        return function(*fields)
    from dask.array import map_blocks

    template = max(fields, key=lambda field: field.ndim)
    return map_blocks(
        function, *fields, dtype=dtype, chunks=template.chunks, meta=np.empty((0,) * template.ndim, dtype)
    )


def _tracked_fields(fields: Mapping[str, Any], tracked: Tracked, shape: tuple[int, ...]) -> dict[str, Any]:
    """Return the fields of modes in the tracked order, and those that only a tracked map has."""
    valid = fields["valid"][..., None]
    order, signs, events = (
        values.reshape(*shape, -1) for values in (tracked.order, tracked.signs, tracked.events)
    )
    if not isinstance(valid, np.ndarray):
        from dask.array import from_array

        order, signs, events = (
            from_array(values, chunks=chunks_of(values.shape, len(shape)), name=False)
            for values in (order, signs, events)
        )
    reordered = {}
    for field in map_fields(ALL_CONDITIONS):
        values = fields.get(field.variable)
        if values is None or field.dims[:1] != (MODE,):
            continue
        broadcast = (..., *[None] * (len(field.dims) - 1))
        factors = (signs[broadcast],) if field.signed else ()
        reorder = partial(_reorder_modes, axis=-len(field.dims))
        reordered[field.variable] = _apply(reorder, values.dtype, values, order[broadcast], *factors)
    reordered["rank"] = _apply(
        lambda ranks, is_valid: np.where(is_valid, ranks + 1, 0).astype(np.int8),
        np.dtype(np.int8),
        order,
        valid,
    )
    reordered["tracking"] = events
    return reordered


def _reorder_modes(values: Array, ranks: Array, factors: Array | None = None, *, axis: int) -> Array:
    """Return values of modes in another order, multiplied by factors if there are any.

    - ranks, factors: of length 1 along axes after that of the modes
    - axis: axis of the modes
    """
    ordered = np.take_along_axis(values, ranks, axis=axis)
    return ordered if factors is None else ordered * factors
