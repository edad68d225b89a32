"""The dataset of modes at hand, with the names and attributes of a map."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.dataset.attributes import attributes_of, imported, labels_of, meanings_of
from pkmodes.dataset.motion import parts_of
from pkmodes.dataset.variables import LIST, variables
from pkmodes.robot.robot import Robot

if TYPE_CHECKING:
    import xarray

#: Variables that begin with the axis of the modes.
PER_MODE = ("frequency", "platform_shape", "shape")


def dataset_of_modes(
    robot: Robot,
    rigid_modes: int,
    coordinates: tuple[str, ...],
    poses: NDArray[np.float64],
    arrays: Mapping[str, NDArray[Any]],
) -> xarray.Dataset:
    """Return modes as a dataset: see `pkmodes.Modes.to_dataset`.

    Parameters
    ----------
    robot : Robot
    rigid_modes : int
    coordinates : tuple of str
        Of the shapes.
    poses : ndarray, shape (..., d)
    arrays : mapping of str to ndarray
        ``valid``, ``reason``, and those of ``Modes.FIELDS`` that were requested.
    """
    xr = imported()
    mechanism = robot.mechanism
    normal = mechanism.directions[2] if len(mechanism.directions) > 2 else None
    axes = poses.ndim - 1
    leading = (LIST,) if axes == 1 else tuple(f"{LIST}_{i + 1}" for i in range(axes))
    fields: dict[str, Any] = {name: arrays[name] for name in ("valid", "reason")}
    if "frequencies" in arrays:
        fields["frequency"] = arrays["frequencies"][..., rigid_modes:]
    if "platform_shapes" in arrays:
        motion = fields["platform_shape"] = arrays["platform_shapes"][..., rigid_modes:, :]
        fields["in_plane"], fields["out_of_plane"] = parts_of(motion, mechanism.directions, normal)
    if "shapes" in arrays:
        fields["shape"] = arrays["shapes"][..., rigid_modes:, :]
    shown = coordinates if "shape" in fields else mechanism.independent
    if "joint_positions" in arrays:
        positions = fields["joint_position"] = np.full((*poses.shape[:-1], len(shown)), np.nan)
        positions[..., [shown.index(name) for name in mechanism.independent]] = arrays["joint_positions"]
    data = {
        v.name: ((*leading, *v.dims), fields[v.name], {**v.attributes, **meanings_of(robot, v.name)})
        for v in variables(mechanism, normal, "shape" in fields, False)
        if v.name in fields
    }
    about = {c.name: {"units": c.unit, "long_name": c.description} for c in mechanism.pose}
    coords = {name: (leading, poses[..., i], about[name]) for i, name in enumerate(about)}
    number = next((v.shape[axes] for name, v in fields.items() if name in PER_MODE), 0)
    used = {dim for dims, _, _ in data.values() for dim in dims}
    labels = {name: value for name, value in labels_of(mechanism, number, shown).items() if name in used}
    dataset: xarray.Dataset = xr.Dataset(data, {**coords, **labels}, attributes_of(robot, rigid_modes))
    return dataset
