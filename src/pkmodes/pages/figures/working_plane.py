"""The working plane: the plane of the workspace with the lowest mean condition number (section 4 of the paper)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pkmodes.core.base.errors import PkmodesError
from pkmodes.machine.maps.mapping import map_of
from pkmodes.machine.maps.poses import PoseGrid
from pkmodes.machine.maps.workspace import grid_over_workspace

if TYPE_CHECKING:
    import xarray

    from pkmodes.core.model import Model

#: Approximate number of poses in the plane, and in the volume in which it is chosen.
PLANE_POSES, VOLUME_POSES = 8_000, 40_000
#: Minimum area of the plane relative to the largest cross-section.
MIN_AREA_FRACTION = 0.5


def working_plane(model: Model) -> PoseGrid:
    """Choose the working plane of a robot.

    Parameters
    ----------
    model : Model
        The robot.

    Returns
    -------
    PoseGrid
        Perpendicular to the third direction of the platform's motion, among planes of at least half of the largest
        area; the whole workspace of a mechanism that moves in two directions.  A platform that can turn does not.

    Raises
    ------
    PoseError
        If no pose can be reached.
    PkmodesError
        If the workspace is too narrow for a plane.
    """
    names = [component.name for component in model.mechanism.pose]
    rotations = model.mechanism.components[len(model.mechanism.directions) :]
    if len(names) - len(rotations) <= 2:
        return grid_over_workspace(model, PLANE_POSES)
    volume = grid_over_workspace(model, VOLUME_POSES)
    normal = model.mechanism.directions[2]
    coarse_map = map_of(model, volume)
    in_plane = [name for name in names if name != normal and name not in rotations]
    best_value = best_conditioned(coarse_map, normal)
    inside = coarse_map["valid"].sel({normal: best_value})
    ends = {}
    for name in in_plane:
        reached_indices = np.flatnonzero(inside.any([dim for dim in inside.dims if dim != name]).values)
        ends[name] = volume.axes[name][reached_indices[0]], volume.axes[name][reached_indices[-1]]
    extents = {name: float(high - low) for name, (low, high) in ends.items()}
    for name, extent in extents.items():
        if extent == 0.0:
            problem = f"the workspace is too narrow along {name} to find a plane in it"
            raise PkmodesError(problem, model.robot.source, "give the plane as a grid")
    step = (np.prod(list(extents.values())) / PLANE_POSES) ** (1 / len(extents))
    # An odd number of values: one of them lies on the centre line.
    axes = {name: np.linspace(*ends[name], 2 * round(extents[name] / step / 2) + 1) for name in in_plane}
    axes |= {name: volume.axes[name] for name in rotations}
    return PoseGrid({name: axes.get(name, np.array([best_value])) for name in names}, volume.usable_only)


def best_conditioned(dataset: xarray.Dataset, normal: str) -> float:
    """Return the position along an axis of the plane with the lowest mean condition number.

    Planes with less than `MIN_AREA_FRACTION` of the largest area are not considered.
    """
    other_dims = [dim for dim in dataset["condition"].dims if dim != normal]
    area = dataset["valid"].sum(other_dims)
    mean_condition = dataset["condition"].mean(other_dims).where(area >= MIN_AREA_FRACTION * area.max())
    values = mean_condition.values
    index = np.nanargmin(values) if np.isfinite(values).any() else len(values) // 2
    return float(dataset[normal].values[index])
