"""Uncertainty of the declared robot's frequencies along one axis of a map, and over all of it."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection
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

    Of a sweep, the robots with the first and the last values count.

    - robot, dataset, max_condition: as for `spread_along`

    Returns (m,), in Hz.  None where the robot file states no standard deviations, and where the map has samples,
    which show the scatter themselves.
    """
    dims = [str(dim) for dim in dataset["valid"].dims]
    if not stated_sigmas(robot) or SAMPLE in dims:
        return None
    swept = {name: dataset[name].values for name in dims if "." in name}
    set_paths = paths_set_by_sweep(robot, swept)
    parts = []
    for ends in itertools.product(*(dict.fromkeys((0, len(values) - 1)) for values in swept.values())):
        values = {name: float(swept[name][i]) for name, i in zip(swept, ends, strict=True)}
        variant = robot.with_values(values) if values else robot
        of_robot = dataset.isel(dict(zip(swept, ends, strict=True)))
        parts.append(_spread_over_poses(Model(variant, max_condition), of_robot, set_paths))
    spread = [part for part in parts if part is not None]
    return np.asarray(np.nanmedian(np.vstack(spread), axis=0)) if spread else None


def _spread_over_poses(model: Model, dataset: xarray.Dataset, set_paths: Collection[str]) -> Array | None:
    """Return the standard deviations of the frequencies of one robot at some poses of its map, (N, m) [Hz].

    None where no pose can be evaluated, or no value that is not set has a standard deviation.
    """
    dims = [str(dim) for dim in dataset["valid"].dims]
    step = math.ceil((dataset["valid"].size / SPREAD_POSES) ** (1.0 / max(len(dims), 1)))
    thinned = dataset[["frequency", "valid"]].isel({dim: slice(None, None, step) for dim in dims}).load()
    is_valid = thinned["valid"].values.reshape(-1)
    if not is_valid.any():
        return None
    frequencies = thinned["frequency"].transpose(*dims, "mode").values.reshape(len(is_valid), -1)[is_valid]
    components = [component.name for component in model.mechanism.pose]
    columns = [thinned[name].broadcast_like(thinned["valid"]).values.reshape(-1) for name in components]
    points = np.stack(columns, axis=-1)[is_valid]
    spread = spread_of(model, points, str(dataset.attrs["drives"]), "nan", set_paths)
    if spread is None:
        return None
    ranks = np.argsort(np.argsort(frequencies, axis=1), axis=1)
    return np.take_along_axis(spread[:, -frequencies.shape[1] :], ranks, axis=1)
