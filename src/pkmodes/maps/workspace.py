"""A grid over the workspace of a robot, and where the workspace is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.mechanism.poses import LARGE
from pkmodes.core.robot.usable import is_box, limits_of
from pkmodes.maps.poses import Grid
from pkmodes.maps.reached import workspace_in_words
from pkmodes.maps.usable import usable_box
from pkmodes.support.progress import say

if TYPE_CHECKING:
    from pkmodes.core.model import Model

Array = NDArray[np.float64]
#: Poses of the grid, about, and along one component at most, about.
POSES, LONGEST = 50_000, 1_000


def reachable(model: Model, poses: int = POSES) -> Grid:
    """Return a grid over the workspace of a robot, within its usable limits.

    Parameters
    ----------
    poses : int
        How many poses the grid has, within a factor of three because steps are round numbers, including those of
        its corners that cannot be reached; along one component at most some 1,000.

    Returns
    -------
    Grid
        Round values with the same step for all components of one unit.  Of several separate assemblies, such as the
        platform above and below the rails, the one that hangs lower is mapped.

    Raises
    ------
    PoseError
        If no pose was found.
    """
    return reachable_by([model], poses)


def reachable_by(models: Sequence[Model], poses: int = POSES) -> Grid:
    """Return a grid over the workspaces of several robots of one mechanism together: see `reachable`."""
    say("looking for the workspace")
    boxes = [usable_box(model) for model in models]
    low, high = np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)
    mechanism = models[0].mechanism
    every = [limits_of(mechanism, model.robot.usable) for model in models]
    limits = np.min([one[0] for one in every], axis=0), np.max([one[1] for one in every], axis=0)
    names = [component.name for component in mechanism.pose]
    units = [component.unit for component in mechanism.pose]
    size = np.where(high > low, high - low, 1e-3)
    # The same step for components of one unit; components of another unit are divided as finely.
    per_unit = {unit: max(size[[u == unit for u in units]]) for unit in units}
    relative = size / np.array([per_unit[unit] for unit in units])
    divisions = min((poses / np.prod(relative)) ** (1 / len(names)), LONGEST)
    axes = {}
    for i, name in enumerate(names):
        step = _round(per_unit[units[i]] / divisions)
        first, last = np.ceil(low[i] / step - 1e-9), np.floor(high[i] / step + 1e-9)
        if last < first:  # narrower than a step
            axes[name] = np.array([(low[i] + high[i]) / 2])
        else:
            values = np.round(np.arange(first, last + 1) * step, 12) + 0.0
            axes[name] = np.clip(values, limits[0][i], limits[1][i])
    return Grid(axes, used=not all(is_box(model.robot.usable) for model in models))


def bounds_of(model: Model, tried: Array, in_millimetres: str) -> str:
    """Return the remedy for poses that cannot be reached: where the workspace is.

    Parameters
    ----------
    tried : ndarray, shape (N, d)
        Poses that cannot be reached.
    in_millimetres : str
        How to give them in millimetres.
    """
    lengths = [component.unit == "m" for component in model.mechanism.pose]
    if np.abs(tried[:, lengths]).max(initial=0.0) >= LARGE:
        smaller = np.where(lengths, tried / 1e3, tried)
        if model.check(smaller).valid.any():
            return f"the numbers look like millimetres: {in_millimetres}"
    try:
        return f"the workspace lies within {workspace_in_words(model)}"
    except PoseError as error:
        return error.remedy


def _round(step: float) -> float:
    """Return the nearest round number: 1, 2, 2.5 or 5 times a power of ten."""
    power = 10.0 ** np.floor(np.log10(step))
    return float(min((m * power for m in (1.0, 2.0, 2.5, 5.0, 10.0)), key=lambda m: abs(np.log(m / step))))
