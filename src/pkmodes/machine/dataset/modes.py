"""The dataset of modes at hand, with the names and attributes of a map."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.solve.fields import FIELDS, INDEPENDENT, LINEAR, MODE, Field, conditions_of, map_fields
from pkmodes.core.solve.results import Modes
from pkmodes.machine.dataset.attributes import attributes_of, imported, labels_of, meanings_of
from pkmodes.machine.dataset.table import table_of
from pkmodes.machine.dataset.variables import dims_of_poses, variables

if TYPE_CHECKING:
    import pandas
    import xarray


def to_dataset(modes: Modes) -> xarray.Dataset:
    """Return the vibration modes as a dataset, with the variables and attributes of a map.

    docs/reference/map-dataset.md describes them.

    - modes: of a robot at poses

    Its leading axes are those of the poses: ``pose``, or ``pose_1``, ``pose_2``, ... for several.  Rigid-body modes
    are left out, and so are fields that were not requested.
    Raises MissingExtraError if the libraries of the extra ``map`` are not installed.
    """
    xr = imported()
    robot, poses, drives = modes.robot, modes.poses, modes.drives
    mechanism = robot.mechanism
    names = ("valid", "reason", *(name for name in modes.requested if FIELDS[name].variable))
    arrays = {name: getattr(modes, name) for name in names}
    normal = mechanism.directions[2] if len(mechanism.directions) > 2 else None
    axes = poses.ndim - 1
    leading = dims_of_poses(axes)
    conditions = conditions_of([robot], "shapes" in arrays, drives)
    fields = [field for field in map_fields(conditions) if field.name in arrays]
    values = {field.name: arrays[field.name] for field in fields}
    vibrations: Any = (*[slice(None)] * axes, slice(modes.rigid_modes, None))
    for field in fields:
        if field.dims[:1] == (MODE,):
            values[field.name] = arrays[field.name][vibrations]
    # Further fields that follow from those available, such as the parts of the platform's motion.
    available = {**values, "directions": mechanism.directions, "normal": normal}
    for field in map_fields(conditions):
        if not field.in_modes and available.keys() >= {*field.needs}:
            fields.append(field)
            values[field.name] = field.function(*(available[name] for name in field.needs))
    shown = modes.coordinates if "shapes" in values else mechanism.independent
    named = {name: arrays[name] for name in ("valid", "reason")}
    named |= {field.variable: _along(field, values[field.name], mechanism, shown) for field in fields}
    data = {
        v.name: ((*leading, *v.dims), named[v.name], {**v.attributes, **meanings_of(robot, v.name)})
        for v in variables(mechanism, normal, conditions, False)
        if v.name in named
    }
    about = {c.name: {"units": c.unit, "long_name": c.description} for c in mechanism.pose}
    coords = {name: (leading, poses[..., i], about[name]) for i, name in enumerate(about)}
    number = next((values[field.name].shape[axes] for field in fields if field.dims[:1] == (MODE,)), 0)
    used = {dim for dims, _, _ in data.values() for dim in dims}
    labels = {name: value for name, value in labels_of(mechanism, number, shown).items() if name in used}
    dataset: xarray.Dataset = xr.Dataset(
        data, {**coords, **labels}, attributes_of(robot, modes.rigid_modes, drives)
    )
    return dataset


def to_table(modes: Modes) -> pandas.DataFrame:
    """Return the vibration modes as a table, which pandas writes as CSV or Parquet.

    - modes: of a robot at poses

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


def _along(field: Field, values: NDArray[Any], mechanism: Mechanism, shown: Sequence[str]) -> NDArray[Any]:
    """Return values along the axis that a map has, NaN at entries that the field does not have.

    These are coordinates that are not independent, and rotations.
    """
    if not {INDEPENDENT, LINEAR} & {*field.dims}:
        return values
    of_coordinates = INDEPENDENT in field.dims
    axis_names = shown if of_coordinates else mechanism.components
    field_names = mechanism.independent if of_coordinates else mechanism.directions
    spread = np.full((*values.shape[:-1], len(axis_names)), np.nan)
    spread[..., [axis_names.index(name) for name in field_names]] = values
    return spread
