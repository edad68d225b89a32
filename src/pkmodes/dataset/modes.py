"""The dataset of modes at hand, with the names and attributes of a map."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.dataset.attributes import attributes_of, imported, labels_of, meanings_of
from pkmodes.dataset.fields import INDEPENDENT, MODE, Field, conditions_of, of_maps
from pkmodes.dataset.variables import dims_of_poses, variables
from pkmodes.mechanism.registry import Mechanism
from pkmodes.robot.robot import Robot

if TYPE_CHECKING:
    import xarray


def dataset_of_modes(
    robot: Robot,
    rigid_modes: int,
    coordinates: tuple[str, ...],
    poses: NDArray[np.float64],
    arrays: Mapping[str, NDArray[Any]],
    drives: str,
) -> xarray.Dataset:
    """Return modes as a dataset: see `pkmodes.Modes.to_dataset`.

    Parameters
    ----------
    coordinates : tuple of str
        Of the shapes.
    poses : ndarray, shape (..., d)
    arrays : mapping of str to ndarray
        ``valid``, ``reason``, and those of ``Modes.FIELDS`` that were requested.
    drives : str
        What the motors do.
    """
    xr = imported()
    mechanism = robot.mechanism
    normal = mechanism.directions[2] if len(mechanism.directions) > 2 else None
    axes = poses.ndim - 1
    leading = dims_of_poses(axes)
    conditions = conditions_of([robot], "shapes" in arrays, drives)
    fields = [field for field in of_maps(conditions) if field.name in arrays]
    values = {field.name: arrays[field.name] for field in fields}
    vibrations: Any = (*[slice(None)] * axes, slice(rigid_modes, None))
    for field in fields:
        if field.dims[:1] == (MODE,):
            values[field.name] = arrays[field.name][vibrations]
    # The others that follow from those at hand, such as the parts of the platform's motion.
    known = {**values, "directions": mechanism.directions, "normal": normal}
    for field in of_maps(conditions):
        if not field.in_modes and known.keys() >= {*field.needs}:
            fields.append(field)
            values[field.name] = field.of(*(known[name] for name in field.needs))
    shown = coordinates if "shapes" in values else mechanism.independent
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
        data, {**coords, **labels}, attributes_of(robot, rigid_modes, drives)
    )
    return dataset


def _along(field: Field, values: NDArray[Any], mechanism: Mechanism, shown: Sequence[str]) -> NDArray[Any]:
    """Return values along the axis of the coordinates that are shown, NaN at those that are not independent."""
    if INDEPENDENT not in field.dims:
        return values
    spread = np.full((*values.shape[:-1], len(shown)), np.nan)
    spread[..., [shown.index(name) for name in mechanism.independent]] = values
    return spread
