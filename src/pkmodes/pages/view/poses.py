"""The poses of a page: one to begin with, and a grid of poses around it that covers the workspace."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.regular import regular_poses
from pkmodes.core.model import Model
from pkmodes.machine.maps.workspace import (
    hanging,
    resting,
    turning_box,
    usable_box,
    usable_poses,
    used,
    within,
)
from pkmodes.pages.view.evaluating import scene
from pkmodes.pages.view.interpolation import FINE, interpolation_errors
from pkmodes.pages.view.pairing import paired_modes
from pkmodes.pages.view.scene import Scene
from pkmodes.pages.view.workspace import workspace

Array = NDArray[np.float64]
#: Every stop of a slider between two values of a component.
STOPS = tuple(k / FINE for k in range(1, FINE))


class ViewGrid(NamedTuple):
    """How densely a page covers the workspace.

    - levels: values of each component
    - checked: where between two of them frequencies are computed for comparison, and in words where that is not
      everywhere
    """

    levels: int
    checked: tuple[float, ...] = STOPS
    where: str = ""


#: Grids by the number of components: a page holds a few hundred poses.  At all stops of six components a large
#: workspace has 16 million poses, which take five minutes.
GRIDS = {1: ViewGrid(41), 2: ViewGrid(11), 3: ViewGrid(7)}
OF_MORE = ViewGrid(3, STOPS[1::3], "at three stops in nine of each slider")
#: Number of regular poses searched for.
SEEDS = 200


def typical_pose(model: Model) -> Array:
    """Return a pose well inside the workspace.

    Parameters
    ----------
    model : Model
        The robot.

    Returns
    -------
    ndarray, shape (d,)
        In the middle of the workspace or its lower half, on the assembly branch that hangs lower, and within the
        usable limits of the robot.

    Raises
    ------
    PoseError
        If no regular pose is found.
    """
    generated = Generated(model.mechanism.model, model.robot.parameters)
    seeds = regular_poses(generated, model.mechanism, model.robot.parameters, SEEDS)
    if model.robot.usable:
        seeds = seeds[within(model)(seeds)] if len(seeds) else seeds
        seeds = seeds if len(seeds) else usable_poses(model)
    if not len(seeds):
        raise PoseError("found no pose well inside the workspace", model.robot.source, "give one with --pose")
    lower = hanging(model, seeds)
    heights = generated.gravity_potential(lower)
    group = lower[heights <= np.median(heights)]
    central: Array = group[np.argmin(np.linalg.norm(group - group.mean(axis=0), axis=-1))]
    level = central.copy()
    level[list(resting(model))] = list(resting(model).values())
    central = level if used(model, central)(level[None])[0] else central
    low, high = usable_box(model, central)
    digits = int(np.ceil(-np.log10(0.05 * (high - low).max())))
    for middle in (0.5 * (low + high), central):
        rounded = middle.round(digits) + 0.0
        if model.check(rounded).valid and within(model)(rounded[None])[0]:
            return np.asarray(rounded)
    return central


def poses_around(model: Model, pose: ArrayLike, *, drives: str | None = None) -> Scene:
    """Return the scene of a page: a grid of poses that covers the workspace and contains the given one.

    The workspace is that within the usable limits of the robot, unless the pose itself is beyond them.

    Parameters
    ----------
    model : Model
        The robot.
    pose : array_like, shape (d,)
        The pose to show first.
    drives : {"free", "held"}, optional
        As for `pkmodes.Model.modes`.

    Returns
    -------
    Scene
        With its `levels`, `places` and `workspace`.

    Raises
    ------
    PoseError
        If the robot cannot be there.
    """
    drives = model.robot.resolve_drives(drives)
    first = np.asarray(pose, dtype=float)
    scene(model, first, drives=drives)  # its errors are those of this pose
    inside, (low, high) = used(model, first), usable_box(model, first)
    if turning := list(resting(model, first)):
        for end, of_rotations in zip((low, high), turning_box(model, first), strict=True):
            end[turning] = of_rotations[turning]
    dense = GRIDS.get(len(first), OF_MORE)
    levels = tuple(_levels(*ends, dense.levels) for ends in zip(low, high, first, strict=True))
    grid = np.stack(np.meshgrid(*levels, indexing="ij"), axis=-1)
    valid = inside(grid.reshape(-1, len(first))).reshape(grid.shape[:-1])
    places = np.where(valid, np.cumsum(valid.ravel()).reshape(valid.shape) - 1, -1)
    here = tuple(int(np.argmin(np.abs(values - value))) for values, value in zip(levels, first, strict=True))
    shown = scene(model, grid[valid], int(places[here]), drives=drives)
    masses, _ = model.matrices(grid[valid])
    order, rigid = paired_modes(shown.shapes, masses, places, shown.rigid_modes), shown.rigid_modes
    return replace(
        shown,
        levels=levels,
        places=places,
        workspace=workspace(model, first, (low, high), inside),
        order=order,
        deviations=interpolation_errors(
            shown.frequencies[:, rigid:],
            order[:, rigid:] - rigid,
            places,
            levels,
            lambda points: model.frequencies(points, on_error="nan", drives=drives)[:, rigid:],
            dense.checked,
        ),
        checked=dense.where,
    )


def _levels(low: float, high: float, value: float, count: int) -> Array:
    """Return evenly spaced values inside a range; the nearest is replaced by the given value, else the only one."""
    if high <= low:
        return np.array([value])
    step = (high - low) / (count + 1)
    digits = int(np.ceil(-np.log10(0.02 * step)))
    levels = np.linspace(low + step, high - step, count).round(digits) + 0.0
    levels[np.argmin(np.abs(levels - value))] = value
    return np.unique(levels)
