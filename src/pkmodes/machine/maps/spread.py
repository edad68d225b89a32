"""Uncertainty of the declared robot's frequencies along one axis of a map, and over all of it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.sensitivity.spread import spread_of, stated_sigmas
from pkmodes.machine.maps.variants import SAMPLE, paths_set_by_sweep

if TYPE_CHECKING:
    import xarray

Array = NDArray[np.float64]
#: Approximate number of poses of which a median of standard deviations is taken.
SPREAD_POSES = 2_000


def spread_along(robot: Robot, dataset: xarray.Dataset, dim: str, max_condition: float) -> Array | None:
    """Return the standard deviations of the frequencies of a map along one axis.

    - robot: as declared
    - dataset: a map of this robot
    - dim: the axis: ``pose``, a component of the pose, or a swept parameter, whose values are known
    - max_condition: as for `pkmodes.Model`

    Returns (values, m), in Hz, in the order of the map's modes.  None where the robot file states no standard
    deviations, where the map has further axes along which its frequencies vary, and where it has samples, which show
    the scatter themselves.
    """
    dims = [str(name) for name in dataset["frequency"].dims]
    other_dims = [name for name in dims if name not in (dim, "mode") and dataset.sizes[name] > 1]
    if other_dims or SAMPLE in dims or not stated_sigmas(robot):
        return None
    drives = str(dataset.attrs["drives"])
    frequencies = dataset["frequency"].transpose(dim, ..., "mode").values.reshape(dataset.sizes[dim], -1)
    components = [component.name for component in robot.mechanism.pose]
    points = np.stack(
        [np.broadcast_to(dataset[name].values.reshape(-1), len(frequencies)) for name in components], axis=-1
    )
    swept = {name: dataset[name].values for name in dims if "." in name}
    set_paths = paths_set_by_sweep(robot, swept)
    if dim in swept:
        robots = [
            robot.with_values(
                {name: float(values[i if name == dim else 0]) for name, values in swept.items()}
            )
            for i in range(len(frequencies))
        ]
        sigma_parts = [
            spread_of(Model(variant, max_condition), point, drives, "nan", set_paths)
            for variant, point in zip(robots, points, strict=True)
        ]
    else:
        variant = robot.with_values({name: float(v[0]) for name, v in swept.items()}) if swept else robot
        sigma_parts = [spread_of(Model(variant, max_condition), points, drives, "nan", set_paths)]
    if any(part is None for part in sigma_parts):
        return None
    sigmas = np.vstack([part for part in sigma_parts if part is not None])[:, -frequencies.shape[1] :]
    # A tracked map numbers its modes by shape, not by frequency.
    ranks = np.argsort(np.argsort(frequencies, axis=1), axis=1)
    return np.take_along_axis(sigmas, ranks, axis=1)


def typical_spread(robot: Robot, dataset: xarray.Dataset, max_condition: float) -> Array | None:
    """Return the median standard deviation of each frequency of a map, over some of its poses.

    - robot, dataset, max_condition: as for `spread_along`

    Returns (m,), in Hz.  None where the robot file states no standard deviations, and for a map of several robots,
    whose frequencies differ for other reasons.
    """
    components = [component.name for component in robot.mechanism.pose]
    dims = [str(dim) for dim in dataset["valid"].dims]
    if not stated_sigmas(robot) or not set(dims) <= {*components, "pose"}:
        return None
    step = math.ceil((dataset["valid"].size / SPREAD_POSES) ** (1.0 / max(len(dims), 1)))
    thinned = dataset[["frequency", "valid"]].isel({dim: slice(None, None, step) for dim in dims}).load()
    is_valid = thinned["valid"].values.reshape(-1)
    if not is_valid.any():
        return None
    frequencies = thinned["frequency"].transpose(*dims, "mode").values.reshape(len(is_valid), -1)[is_valid]
    columns = [thinned[name].broadcast_like(thinned["valid"]).values.reshape(-1) for name in components]
    points = np.stack(columns, axis=-1)[is_valid]
    spread = spread_of(Model(robot, max_condition), points, str(dataset.attrs["drives"]), "nan")
    if spread is None:
        return None
    ranks = np.argsort(np.argsort(frequencies, axis=1), axis=1)
    of_modes = np.take_along_axis(spread[:, -frequencies.shape[1] :], ranks, axis=1)
    return np.asarray(np.nanmedian(of_modes, axis=0))
