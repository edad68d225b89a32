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
POSES, VOLUME = 8_000, 40_000
#: Smallest area of the plane relative to the largest cross-section.
WIDE = 0.5


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
    turning = model.mechanism.components[len(model.mechanism.directions) :]
    if len(names) - len(turning) <= 2:
        return grid_over_workspace(model, POSES)
    volume = grid_over_workspace(model, VOLUME)
    normal = model.mechanism.directions[2]
    coarse = map_of(model, volume)
    in_plane = [name for name in names if name != normal and name not in turning]
    best = best_conditioned(coarse, normal)
    inside = coarse["valid"].sel({normal: best})
    ends = {}
    for name in in_plane:
        reached = np.flatnonzero(inside.any([dim for dim in inside.dims if dim != name]).values)
        ends[name] = volume.axes[name][reached[0]], volume.axes[name][reached[-1]]
    size = {name: float(high - low) for name, (low, high) in ends.items()}
    for name, extent in size.items():
        if extent == 0.0:
            problem = f"the workspace is too narrow along {name} to find a plane in it"
            raise PkmodesError(problem, model.robot.source, "give the plane as a grid")
    step = (np.prod(list(size.values())) / POSES) ** (1 / len(size))
    # An odd number of values: one of them lies on the centre line.
    axes = {name: np.linspace(*ends[name], 2 * round(size[name] / step / 2) + 1) for name in in_plane}
    axes |= {name: volume.axes[name] for name in turning}
    return PoseGrid({name: axes.get(name, np.array([best])) for name in names}, volume.usable_only)


def best_conditioned(dataset: xarray.Dataset, normal: str) -> float:
    """Return where along an axis the mean condition number is lowest, among planes of `WIDE` of the largest area."""
    other_dims = [dim for dim in dataset["condition"].dims if dim != normal]
    area = dataset["valid"].sum(other_dims)
    mean = dataset["condition"].mean(other_dims).where(area >= WIDE * area.max())
    values = mean.values
    place = np.nanargmin(values) if np.isfinite(values).any() else len(values) // 2
    return float(dataset[normal].values[place])
