"""Values that the figures of a plane need in addition to its map: sensitivities, the volume around it, MAC."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.mac import mass_weighted_mac
from pkmodes.loop.sensitivity.alike import equivalent_parameters
from pkmodes.loop.sensitivity.relative import scalable_quantities
from pkmodes.loop.sensitivity.sensitivities import sensitivities_at
from pkmodes.loop.sensitivity.spread import spread_of
from pkmodes.machine.maps.workspace import box_of, limits_test, usable_box
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.plots.workspace import ReachableVolume
from pkmodes.pages.view.robot_drawing import RobotDrawing

if TYPE_CHECKING:
    from pkmodes.core.model import Model

Array = NDArray[Any]
#: Approximate number of poses in a map of sensitivities.
SENSITIVITY_POSES = 2_000
#: Heights at which the volume around a plane is outlined, and poses along each side of an outline.
OUTLINE_HEIGHTS, OUTLINE_POSES = 16, 160


def relative_sensitivities(model: Model, plane: Plane, drives: str) -> tuple[list[str], Array]:
    """Return the relative sensitivities of the frequencies of vibration on a coarser grid of the plane.

    Returns, in this order:
    - names: quantities of the robot (`scalable_quantities`); those with the same effect at all these poses have a
      common name, such as ``belt.specific_stiffness, belt.width``
    - relative_rates: d ln f / d ln p, (rows, columns, parameters, modes)
    """
    paths = scalable_quantities(model.robot)
    coarse = coarse_plane(plane)
    poses = plane_poses(model, coarse)
    sensitivities = sensitivities_at(
        model, poses, paths, fields=["frequencies"], on_error="nan", drives=drives
    )
    modes = plane.dataset.sizes["mode"]
    rates = sensitivities.frequencies[..., -modes:]
    frequency = coarse.dataset["frequency"].values
    relative_rates = rates * sensitivities.values[:, None] / frequency[..., None, :]
    groups = equivalent_parameters(relative_rates)
    return [group.name(paths) for group in groups], relative_rates[
        ..., [group.members[0] for group in groups], :
    ]


def median_spread(model: Model, plane: Plane, drives: str) -> Array | None:
    """Return the median standard deviation of each frequency of vibration over a coarser grid of the plane.

    Returns (modes,) [Hz], propagated from the standard deviations in the robot file; None if it has none.
    """
    coarse = coarse_plane(plane)
    poses = plane_poses(model, coarse)[coarse.dataset["valid"].values]
    spread = spread_of(model, poses, drives, "nan")
    if spread is None:
        return None
    median: Array = np.nanmedian(spread[:, -plane.dataset.sizes["mode"] :], axis=0)
    return median


def coarse_plane(plane: Plane) -> Plane:
    """Return the plane with fewer poses, so that sensitivities take little time."""
    step = max(1, int(np.ceil(np.sqrt(plane.dataset["valid"].size / SENSITIVITY_POSES))))
    dataset = plane.dataset.isel(
        {plane.ordinate: slice(None, None, step), plane.abscissa: slice(None, None, step)}
    )
    return replace(plane, dataset=dataset)


def plane_poses(model: Model, plane: Plane) -> Array:
    """Return the poses of a plane, (rows, columns, d)."""
    ordinates, abscissas = np.meshgrid(
        plane.dataset[plane.ordinate].values, plane.dataset[plane.abscissa].values, indexing="ij"
    )
    values = {plane.ordinate: ordinates, plane.abscissa: abscissas}
    constant = (
        plane.constant_components
        if plane.normal is None
        else {plane.normal: plane.normal_position, **plane.constant_components}
    )
    values |= {name: np.full(ordinates.shape, value) for name, value in constant.items()}
    return np.stack([values[component.name] for component in model.mechanism.pose], axis=-1)


def reachable_volume(model: Model, plane: Plane) -> ReachableVolume | None:
    """Return the volume around a plane: within the limits of use, or all that is reachable if the plane exceeds them.

    Returns None for a mechanism that moves in two directions, and for a plane in which the platform turns.
    """
    if plane.normal is None:
        return None
    is_usable, poses_in_plane = limits_test(model), plane_poses(model, plane)[plane.dataset["valid"].values]
    is_limited = bool(is_usable(poses_in_plane).all())
    pose = (
        poses_in_plane[len(poses_in_plane) // 2]
        if plane.constant_components and len(poses_in_plane)
        else None
    )
    low, high = usable_box(model, pose) if is_limited else box_of(model, pose)
    names = [component.name for component in model.mechanism.pose]
    counts = {plane.normal: OUTLINE_HEIGHTS, plane.ordinate: OUTLINE_POSES, plane.abscissa: OUTLINE_POSES}
    axes = {}
    for i, name in enumerate(names):
        if name in counts:
            margin = 0.03 * (high[i] - low[i]) if name != plane.normal else 0.0  # so that outlines are closed
            axes[name] = np.linspace(low[i] - margin, high[i] + margin, counts[name])
    axis_order = (plane.normal, plane.ordinate, plane.abscissa)
    grid = dict(
        zip(axis_order, np.meshgrid(*(axes[name] for name in axis_order), indexing="ij"), strict=True)
    )
    grid |= {
        name: np.full(grid[plane.ordinate].shape, value) for name, value in plane.constant_components.items()
    }
    poses = np.stack([grid[name] for name in names], axis=-1)
    valid = model.check(poses).valid
    valid = valid & is_usable(poses) if is_limited else valid
    return ReachableVolume(axes[plane.normal], axes[plane.ordinate], axes[plane.abscissa], valid)


def motor_positions(model: Model, plane: Plane) -> Array | None:
    """Return the positions of the motors, (N, 2): abscissa and ordinate in display units.

    Returns None if an axis of the plane is not a length.
    """
    poses = plane_poses(model, plane)[plane.dataset["valid"].values]
    names = ["x", "y", "z"]
    if not len(poses) or not {plane.abscissa, plane.ordinate} <= set(names):
        return None
    motors = RobotDrawing(model.robot).motors(poses[:1])[0]
    factors = [plane.display_unit(name)[1] for name in (plane.abscissa, plane.ordinate)]
    return np.asarray(motors[:, [names.index(plane.abscissa), names.index(plane.ordinate)]] * factors)


def smallest_mac(model: Model, plane: Plane) -> Array:
    """Return the smallest mass-weighted MAC of each mode with the mode of the same number at the four neighbours.

    - plane: with mode shapes

    Returns (rows, columns, modes); NaN where a pose or all of its neighbours cannot be evaluated.
    """
    shapes = plane.dataset["shape"].values
    masses, _ = model.matrices(plane_poses(model, plane), "nan")
    smallest = np.full(shapes.shape[:3], np.inf)
    for axis in (0, 1):
        ahead = tuple(slice(1, None) if i == axis else slice(None) for i in (0, 1))
        behind = tuple(slice(None, -1) if i == axis else slice(None) for i in (0, 1))
        phi, psi, M = shapes[behind], shapes[ahead], masses[behind]
        product = ((phi @ M) * psi).sum(axis=-1)
        mac = mass_weighted_mac(product[..., None, :], psi, M)[..., 0, :]
        mac = np.nan_to_num(mac, nan=np.inf)
        smallest[behind] = np.minimum(smallest[behind], mac)
        smallest[ahead] = np.minimum(smallest[ahead], mac)
    smallest[~np.isfinite(smallest) | ~np.isfinite(shapes[..., 0])] = np.nan
    return smallest
