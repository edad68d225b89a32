"""Modes at poses as a dataset or a table, with the names and attributes of a map."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.solve.fields import FIELDS, INDEPENDENT, LINEAR, MODE, Field, conditions_of, map_fields
from pkmodes.core.solve.results import Modes
from pkmodes.machine.dataset.attributes import attributes_of, axis_coordinates, code_attributes, import_xarray
from pkmodes.machine.dataset.table import table_of
from pkmodes.machine.dataset.variables import dims_of_poses, variables

if TYPE_CHECKING:
    import pandas
    import xarray


def to_dataset(modes: Modes) -> xarray.Dataset:
    """Return the vibration modes as a dataset, with the variables and attributes of a map.

    docs/reference/map-dataset.md describes them.

    - modes: modes of a robot at poses

    Its leading axes are those of the poses: ``pose``, or ``pose_1``, ``pose_2``, ... for several.  Rigid-body modes
    are left out, and so are fields that were not requested.
    Raises MissingExtraError if the libraries of the extra ``map`` are not installed.
    """
    xr = import_xarray()
    robot, poses, drives = modes.robot, modes.poses, modes.drives
    mechanism = robot.mechanism
    names = ("valid", "reason", *(name for name in modes.requested if FIELDS[name].variable))
    arrays = {name: getattr(modes, name) for name in names}
    normal = mechanism.directions[2] if len(mechanism.directions) > 2 else None
    pose_axis_count = poses.ndim - 1
    pose_dims = dims_of_poses(pose_axis_count)
    conditions = conditions_of([robot], "shapes" in arrays, drives)
    fields = [field for field in map_fields(conditions) if field.name in arrays]
    values = {field.name: arrays[field.name] for field in fields}
    vibration_index: Any = (*[slice(None)] * pose_axis_count, slice(modes.rigid_modes, None))
    for field in fields:
        if field.dims[:1] == (MODE,):
            values[field.name] = arrays[field.name][vibration_index]
    # Fields that are computed from those available, such as the parts of the platform's motion.
    available = {**values, "directions": mechanism.directions, "normal": normal}
    for field in map_fields(conditions):
        if not field.in_modes and available.keys() >= {*field.needs}:
            fields.append(field)
            values[field.name] = field.function(*(available[name] for name in field.needs))
    coordinate_names = modes.coordinates if "shapes" in values else mechanism.independent
    variable_values = {name: arrays[name] for name in ("valid", "reason")}
    variable_values |= {
        field.variable: _fill_map_axis(field, values[field.name], mechanism, coordinate_names)
        for field in fields
    }
    data = {
        variable.name: (
            (*pose_dims, *variable.dims),
            variable_values[variable.name],
            {**variable.attributes, **code_attributes(robot, variable.name)},
        )
        for variable in variables(mechanism, normal, conditions, False)
        if variable.name in variable_values
    }
    pose_attributes = {c.name: {"units": c.unit, "long_name": c.description} for c in mechanism.pose}
    coords = {
        name: (pose_dims, poses[..., i], pose_attributes[name]) for i, name in enumerate(pose_attributes)
    }
    mode_count = next(
        (values[field.name].shape[pose_axis_count] for field in fields if field.dims[:1] == (MODE,)), 0
    )
    used_dims = {dim for dims, _, _ in data.values() for dim in dims}
    labels = {
        name: value
        for name, value in axis_coordinates(mechanism, mode_count, coordinate_names).items()
        if name in used_dims
    }
    dataset: xarray.Dataset = xr.Dataset(
        data, {**coords, **labels}, attributes_of(robot, modes.rigid_modes, drives)
    )
    return dataset


def to_table(modes: Modes) -> pandas.DataFrame:
    """Return the vibration modes as a table, which pandas writes as CSV or Parquet.

    - modes: modes of a robot at poses

    Returns one row for each mode at each pose, with the columns of a map in a table (docs/reference/map-dataset.md).
    Raises MissingExtraError if the libraries of the extra ``map`` are not installed.

    Examples
    --------
    >>> import pkmodes
    >>> modes = pkmodes.load("robots/linear-delta-2022.toml").modes([0.6, 0.0, -0.245], fields=["frequencies"])
    >>> modes.to_table()[["mode", "frequency"]].round(3).head(2)
       mode  frequency
    0     1     55.559
    1     2     60.316
    """
    return table_of(to_dataset(modes))


def _fill_map_axis(
    field: Field, values: NDArray[Any], mechanism: Mechanism, coordinate_names: Sequence[str]
) -> NDArray[Any]:
    """Return values along the axis of a map, NaN at entries that the field lacks.

    It lacks coordinates that are not independent, and rotations.
    """
    if not {INDEPENDENT, LINEAR} & {*field.dims}:
        return values
    of_coordinates = INDEPENDENT in field.dims
    axis_names = coordinate_names if of_coordinates else mechanism.components
    field_names = mechanism.independent if of_coordinates else mechanism.directions
    filled = np.full((*values.shape[:-1], len(axis_names)), np.nan)
    filled[..., [axis_names.index(name) for name in field_names]] = values
    return filled
