"""The dataset of modes at hand, with the names and attributes of a map."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.maps.dataset import attributes_of, imported, labels_of, meanings_of
from pkmodes.maps.places import LIST, parts_of
from pkmodes.maps.variables import variables
from pkmodes.results import JOINTS

if TYPE_CHECKING:
    import xarray

    from pkmodes.results import Modes

#: Variables that begin with the axis of the modes.
PER_MODE = ("frequency", "platform_shape", "shape")


def dataset_of_modes(modes: Modes) -> xarray.Dataset:
    """Return modes as a dataset: see `pkmodes.Modes.to_dataset`."""
    xr = imported()
    robot, rigid = modes.robot, modes.rigid_modes
    kind = robot.kind
    normal = kind.directions[2] if len(kind.directions) > 2 else None
    axes = modes.codes.ndim
    leading = (LIST,) if axes == 1 else tuple(f"{LIST}_{i + 1}" for i in range(axes))
    there = {name for name in modes.FIELDS if name in vars(modes)}
    fields: dict[str, Any] = {"valid": modes.valid, "reason": modes.reason}
    if "frequencies" in there:
        fields["frequency"] = modes.frequencies[..., rigid:]
    if "platform_shapes" in there:
        motion = fields["platform_shape"] = modes.platform_shapes[..., rigid:, :]
        fields["in_plane"], fields["out_of_plane"] = parts_of(motion, kind.directions, normal)
    if "shapes" in there:
        fields["shape"] = modes.shapes[..., rigid:, :]
    coordinates = modes.coordinates if "shape" in fields else kind.independent
    if JOINTS in there:
        positions = fields["joint_position"] = np.full((*modes.codes.shape, len(coordinates)), np.nan)
        positions[..., [coordinates.index(name) for name in kind.independent]] = modes.joint_positions
    data = {
        v.name: ((*leading, *v.dims), fields[v.name], {**v.attributes, **meanings_of(robot, v.name)})
        for v in variables(kind, normal, "shape" in fields, False)
        if v.name in fields
    }
    about = {c.name: {"units": c.unit, "long_name": c.description} for c in kind.pose}
    coords = {name: (leading, modes.poses[..., i], about[name]) for i, name in enumerate(about)}
    number = next((v.shape[axes] for name, v in fields.items() if name in PER_MODE), 0)
    used = {dim for dims, _, _ in data.values() for dim in dims}
    labels = {name: value for name, value in labels_of(kind, number, coordinates).items() if name in used}
    found: xarray.Dataset = xr.Dataset(
        data, {**coords, **labels}, {**attributes_of(robot), "rigid_modes": rigid}
    )
    return found
