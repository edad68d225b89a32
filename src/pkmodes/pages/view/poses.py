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
from pkmodes.loop.sensitivity.spread import spread_of
from pkmodes.machine.maps.workspace import (
    fixed_components,
    limits_test,
    poses_on_lower_branch,
    rotation_box,
    usable_box,
    usable_branch_test,
    usable_poses,
)
from pkmodes.pages.view.evaluating import scene
from pkmodes.pages.view.interpolation import SLIDER_STEPS, interpolation_errors
from pkmodes.pages.view.pairing import paired_modes
from pkmodes.pages.view.scene import Scene
from pkmodes.pages.view.workspace import workspace

Array = NDArray[np.float64]
#: Stops of a slider between two evaluated values of a component, as fractions of the way.
SLIDER_STOPS = tuple(k / SLIDER_STEPS for k in range(1, SLIDER_STEPS))


class ViewGrid(NamedTuple):
    """How densely a page covers the workspace.

    - levels: values of each component
    - checked: fractions of the way between two of them at which frequencies are computed for comparison
    - where: the same in words; empty if at all stops of the sliders
    """

    levels: int
    checked: tuple[float, ...] = SLIDER_STOPS
    where: str = ""


#: Grids by the number of pose components, then that for four and more: a page holds a few hundred poses.  With six
#: components the stops of all sliders are 16 million poses in a large workspace, which take five minutes.
GRIDS = {1: ViewGrid(41), 2: ViewGrid(11), 3: ViewGrid(7)}
GRID_BEYOND_THREE = ViewGrid(3, SLIDER_STOPS[1::3], "at three stops in nine of each slider")
#: Number of regular poses among which the typical pose is chosen.
SEED_COUNT = 200


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
    seeds = regular_poses(generated, model.mechanism, model.robot.parameters, SEED_COUNT)
    if model.robot.usable:
        seeds = seeds[limits_test(model)(seeds)] if len(seeds) else seeds
        seeds = seeds if len(seeds) else usable_poses(model)
    if not len(seeds):
        raise PoseError("found no pose well inside the workspace", model.robot.source, "give one with --pose")
    lower_poses = poses_on_lower_branch(model, seeds)
    heights = generated.gravity_potential(lower_poses)
    lower_half = lower_poses[heights <= np.median(heights)]
    central: Array = lower_half[np.argmin(np.linalg.norm(lower_half - lower_half.mean(axis=0), axis=-1))]
    unturned = central.copy()
    unturned[list(fixed_components(model))] = list(fixed_components(model).values())
    central = unturned if usable_branch_test(model, central)(unturned[None])[0] else central
    low, high = usable_box(model, central)
    digits = int(np.ceil(-np.log10(0.05 * (high - low).max())))
    for candidate in (0.5 * (low + high), central):
        rounded = candidate.round(digits) + 0.0
        if model.check(rounded).valid and limits_test(model)(rounded[None])[0]:
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
    shown_pose = np.asarray(pose, dtype=float)
    scene(model, shown_pose, drives=drives)  # so that an error names this pose, not one of the grid
    is_inside, (low, high) = usable_branch_test(model, shown_pose), usable_box(model, shown_pose)
    if rotations := list(fixed_components(model, shown_pose)):
        for end, rotation_end in zip((low, high), rotation_box(model, shown_pose), strict=True):
            end[rotations] = rotation_end[rotations]
    view_grid = GRIDS.get(len(shown_pose), GRID_BEYOND_THREE)
    levels = tuple(
        _levels_through(*ends, view_grid.levels) for ends in zip(low, high, shown_pose, strict=True)
    )
    grid = np.stack(np.meshgrid(*levels, indexing="ij"), axis=-1)
    valid = is_inside(grid.reshape(-1, len(shown_pose))).reshape(grid.shape[:-1])
    places = np.where(valid, np.cumsum(valid.ravel()).reshape(valid.shape) - 1, -1)
    shown_index = tuple(
        int(np.argmin(np.abs(values - value))) for values, value in zip(levels, shown_pose, strict=True)
    )
    grid_scene = scene(model, grid[valid], int(places[shown_index]), drives=drives)
    masses, _ = model.matrices(grid[valid])
    rigid = grid_scene.rigid_modes
    order = paired_modes(grid_scene.shapes, masses, places, rigid)
    return replace(
        grid_scene,
        sigmas=spread_of(model, grid[valid], drives, "nan"),
        levels=levels,
        places=places,
        workspace=workspace(model, shown_pose, (low, high), is_inside),
        order=order,
        deviations=interpolation_errors(
            grid_scene.frequencies[:, rigid:],
            order[:, rigid:] - rigid,
            places,
            levels,
            lambda points: model.frequencies(points, on_error="nan", drives=drives)[:, rigid:],
            view_grid.checked,
        ),
        checked=view_grid.where,
    )


def _levels_through(low: float, high: float, value: float, count: int) -> Array:
    """Return evenly spaced values in a range, the nearest one replaced by `value`; only `value` in an empty range."""
    if high <= low:
        return np.array([value])
    step = (high - low) / (count + 1)
    digits = int(np.ceil(-np.log10(0.02 * step)))
    levels = np.linspace(low + step, high - step, count).round(digits) + 0.0
    levels[np.argmin(np.abs(levels - value))] = value
    return np.unique(levels)
