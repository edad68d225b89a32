"""The workspace of a robot: the poses that it can reach, those where it is used, and a grid over them.

The reachable workspace is that of one assembly branch; the box around it is found by drawing poses.  The usable
workspace is the part of it within the limits that the robot's file declares.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.length import middle_of_joints
from pkmodes.core.mechanism.poses import LARGE_LENGTH
from pkmodes.core.mechanism.regular import draw_poses
from pkmodes.core.model import Model
from pkmodes.core.robot.usable import USABLE, Limits, is_box, limits_in_words
from pkmodes.core.robot.usable_poses import bounding_box, within_limits
from pkmodes.core.support.progress import report_progress
from pkmodes.machine.maps.poses import PoseGrid

Array = NDArray[np.float64]
PoseTest = Callable[[Array], NDArray[np.bool_]]
#: Poses drawn in each round, the relative change of the box below which rounds end, and their maximum number.
DRAWS_PER_ROUND, SETTLED_CHANGE, MAX_ROUNDS = 200_000, 0.01, 12
#: Fraction of its length by which the box is extended on each side before the next round.
EXTENSION = 0.1
SEED = 20260105
#: Smallest offset of a platform's origin to one side of its joints, relative to the characteristic length.
MIN_OFFSET = 0.01
#: Number of usable poses that define the box around them well enough.
ENOUGH_POSES = 5_000
#: Approximate number of poses of the grid, and the maximum along one component.
DEFAULT_POSES, MAX_POSES_PER_AXIS = 50_000, 1_000


def fixed_components(model: Model, pose: Array | None = None) -> dict[int, float]:
    """Return the components of a pose that are constant over a workspace, by index: the rotations of the platform.

    - pose: a pose in it, (d,); by default rotations are 0, or the nearest value within the usable limits
    """
    mechanism = model.mechanism
    names = [component.name for component in mechanism.pose]
    fixed = [names.index(name) for name in mechanism.components[len(mechanism.directions) :]]
    low, high = bounding_box(mechanism, model.robot.usable)
    values = np.clip(0.0, low, high) if pose is None else pose
    return {i: float(values[i]) for i in fixed}


def box_of(
    model: Model, pose: Array | None = None, fixed: Mapping[int, float] | None = None
) -> tuple[Array, Array]:
    """Return the box around the poses that can be evaluated, on one assembly branch.

    - pose: a pose on the branch, (d,); by default the branch whose platform hangs lower
    - fixed: components that are constant, by index; by default the rotations of the platform
      (`fixed_components`)

    Returns low and high, (d,).
    Raises PoseError if no pose was found.
    """
    rng = np.random.default_rng(SEED)
    fixed = fixed_components(model, pose) if fixed is None else fixed
    reachable_poses = _draw_reachable(model, rng, fixed)
    if pose is None:
        pose = poses_on_lower_branch(model, _require_reachable(model, reachable_poses))[0]
    on_branch = branch_test(model, pose)
    reachable_poses = (
        np.vstack([pose, reachable_poses[on_branch(reachable_poses)]]) if len(reachable_poses) else pose[None]
    )
    low, high = reachable_poses.min(axis=0), reachable_poses.max(axis=0)
    for _ in range(MAX_ROUNDS):
        size = np.where(high > low, high - low, 1e-3)
        samples = rng.uniform(low - EXTENSION * size, high + EXTENSION * size, (DRAWS_PER_ROUND, len(low)))
        samples[:, list(fixed)] = list(fixed.values())
        new_poses = samples[on_branch(samples)]
        if not len(new_poses):
            break
        extended = np.minimum(low, new_poses.min(axis=0)), np.maximum(high, new_poses.max(axis=0))
        change = max(((low - extended[0]) / size).max(), ((extended[1] - high) / size).max())
        low, high = extended
        if change <= SETTLED_CHANGE:
            break
    return low, high


def branch_test(model: Model, pose: Array) -> PoseTest:
    """Return a function that tests whether poses, (N, d), can be evaluated and are on the branch of a pose."""
    if not model.has_assemblies:
        return lambda points: model.check(points).valid
    branch = model.assembly(pose)
    return lambda points: model.check(points).valid & (model.assembly(points, "nan") == branch)


def poses_on_lower_branch(model: Model, poses: Array) -> Array:
    """Return the poses of the assembly branch that hangs lower: with the lower mean potential of gravity.

    Where the platform turns and its origin lies to one side of its joints, this branch is the one on that side; where
    the origin lies in their middle, legs that change their length carry the platform from below.

    - poses: poses that can be evaluated, (N, d)
    """
    if not model.has_assemblies:
        return poses
    branches, mechanism = model.assembly(poses), model.mechanism
    offset = np.zeros(len(mechanism.directions))  # from the middle of a platform's joints to its origin
    if mechanism.rotations:
        joint_centre = middle_of_joints(mechanism, model.robot.parameters)
        offset = -joint_centre[["xyz".index(axis) for axis in mechanism.directions]]
    if np.linalg.norm(offset) > MIN_OFFSET * model.characteristic_length:
        height = -poses[:, : len(offset)] @ offset
    else:
        height = Generated(mechanism.model, model.robot.parameters).gravity_potential(poses)
        if mechanism.rotations and mechanism.drives[0].unit == "N":
            height = -height
    lower_branch_poses: Array = poses[
        branches == min(np.unique(branches), key=lambda branch: float(height[branches == branch].mean()))
    ]
    return lower_branch_poses


def _workspace_in_words(model: Model) -> str:
    """Return where the reachable workspace is."""
    low, high = box_of(model)
    names = [component.name for component in model.mechanism.pose]
    ends = map(Limits, low.tolist(), high.tolist())
    return limits_in_words(model.mechanism, dict(zip(names, ends, strict=True)))


def _draw_reachable(model: Model, rng: np.random.Generator, fixed: Mapping[int, float]) -> Array:
    """Draw poses with some components fixed, and return those that can be evaluated, (N, d)."""
    with np.errstate(all="ignore"):
        generated = Generated(model.mechanism.model, model.robot.parameters)
        samples = draw_poses(generated, model.mechanism, model.robot.parameters, rng, DRAWS_PER_ROUND)
    samples = samples[np.isfinite(samples).all(axis=-1)]
    samples[:, list(fixed)] = list(fixed.values())
    return samples[model.check(samples).valid] if len(samples) else samples


def _require_reachable(model: Model, reachable_poses: Array) -> Array:
    """Refuse a robot that reaches no pose."""
    if not len(reachable_poses):
        problem = f"none of {DRAWS_PER_ROUND:,} poses drawn can be reached"
        raise PoseError(problem, model.robot.source, "check the robot file, or give a grid or poses")
    return reachable_poses


def usable_box(model: Model, pose: Array | None = None) -> tuple[Array, Array]:
    """Return the box around the poses where the robot is used: those of `box_of` within its usable limits.

    - pose: a pose on the branch, (d,); by default the branch, among those with usable poses, whose platform hangs
      lower.  A pose beyond the limits lifts them.

    Returns low and high, (d,).
    Raises PoseError if no pose was found within the limits.
    """
    within_limits = limits_test(model)
    if not model.robot.usable or not (pose is None or within_limits(pose[None])[0]):
        return box_of(model, pose)
    branch_pose = poses_on_lower_branch(model, usable_poses(model))[0] if pose is None else pose
    low, high = _clip_to_limits(model, *box_of(model, branch_pose))
    usable_on_branch, rng = usable_branch_test(model, branch_pose), np.random.default_rng(SEED)
    batches, count = [branch_pose[None]], 1
    for _ in range(MAX_ROUNDS):
        samples = rng.uniform(low, high, (DRAWS_PER_ROUND, len(low)))
        batches.append(samples[usable_on_branch(samples)])
        count += len(batches[-1])
        if count >= ENOUGH_POSES:
            break
    usable_points = np.vstack(batches)
    ends, tolerance = (usable_points.min(axis=0), usable_points.max(axis=0)), SETTLED_CHANGE * (high - low)
    # Random poses only come near an end of the box that can be reached: the end of the box itself is then returned.
    return np.where(ends[0] - low > tolerance, ends[0], low), np.where(
        high - ends[1] > tolerance, ends[1], high
    )


def rotation_box(model: Model, pose: Array) -> tuple[Array, Array]:
    """Return the box around the rotations that a platform can have where it is, within the usable limits.

    - pose: pose that can be evaluated, (d,)

    Returns low and high, (d,): the other components are those of the pose.
    """
    rotations = fixed_components(model, pose)
    fixed = {i: float(value) for i, value in enumerate(pose) if i not in rotations}
    return _clip_to_limits(model, *box_of(model, pose, fixed))


def usable_poses(model: Model) -> Array:
    """Return random poses, (N, d), of any branch, that can be evaluated and are within the usable limits.

    Raises PoseError if none was found.
    """
    rng, within_limits = np.random.default_rng(SEED), limits_test(model)
    reachable_poses = _require_reachable(model, _draw_reachable(model, rng, fixed_components(model)))
    if within_limits(reachable_poses).any():
        return reachable_poses[within_limits(reachable_poses)]
    ends = reachable_poses.min(axis=0), reachable_poses.max(axis=0)
    margin = EXTENSION * (ends[1] - ends[0])
    low, high = _clip_to_limits(model, ends[0] - margin, ends[1] + margin)
    for _ in range(MAX_ROUNDS if (low <= high).all() else 0):
        samples = rng.uniform(low, high, (DRAWS_PER_ROUND, len(low)))
        samples = samples[model.check(samples).valid]
        if (usable := within_limits(samples)).any():
            return samples[usable]
    limits = limits_in_words(model.mechanism, model.robot.usable)
    problem = f"no pose within the usable limits can be reached: {limits}"
    remedy = f"check the limits: the workspace lies within {_workspace_in_words(model)}"
    raise PoseError(problem, f"{model.robot.source}: {USABLE}", remedy)


def limits_test(model: Model) -> PoseTest:
    """Return a function that tests whether poses, (N, d), are within the usable limits of the robot."""
    return lambda points: within_limits(model.robot, np.asarray(points, dtype=float))


def usable_branch_test(model: Model, pose: Array) -> PoseTest:
    """Return the test of `branch_test`, also within the usable limits unless the pose itself is beyond them."""
    on_branch, within_limits = branch_test(model, pose), limits_test(model)
    if not model.robot.usable or not within_limits(pose[None])[0]:
        return on_branch
    return lambda points: on_branch(points) & within_limits(points)


def _clip_to_limits(model: Model, low: Array, high: Array) -> tuple[Array, Array]:
    limits = bounding_box(model.mechanism, model.robot.usable)
    return np.maximum(low, limits[0]), np.minimum(high, limits[1])


def grid_over_workspace(model: Model, poses: int = DEFAULT_POSES) -> PoseGrid:
    """Return a grid over the workspace of a robot, within its usable limits.

    - poses: how many poses the grid has, within a factor of three because steps are round numbers, including those of
      its corners that cannot be reached; along one component at most some 1,000

    Returns round values with the same step for all components of one unit.  Of several separate assemblies, such as
    the platform above and below the rails, the one that hangs lower is mapped.  The platform does not turn: see
    `fixed_components`.
    Raises PoseError if no pose was found.
    """
    return grid_over_workspaces([model], poses)


def grid_over_workspaces(models: Sequence[Model], poses: int = DEFAULT_POSES) -> PoseGrid:
    """Return a grid over the workspaces of several robots of one mechanism together: see `grid_over_workspace`."""
    report_progress("looking for the workspace")
    boxes = [usable_box(model) for model in models]
    low, high = np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)
    mechanism = models[0].mechanism
    bounds = [bounding_box(mechanism, model.robot.usable) for model in models]
    limits = np.min([bound[0] for bound in bounds], axis=0), np.max([bound[1] for bound in bounds], axis=0)
    names = [component.name for component in mechanism.pose]
    units = [component.unit for component in mechanism.pose]
    size, fixed = np.where(high > low, high - low, 1e-3), fixed_components(models[0])
    # The same step for components of one unit; components of another unit are divided as finely.
    per_unit = {unit: max(size[[u == unit for u in units]]) for unit in units}
    relative = np.delete(size / np.array([per_unit[unit] for unit in units]), list(fixed))
    divisions = min((poses / np.prod(relative)) ** (1 / len(relative)), MAX_POSES_PER_AXIS)
    axes = {}
    for i, name in enumerate(names):
        if i in fixed:
            axes[name] = np.array([fixed[i]])
            continue
        step = _nearest_round_number(per_unit[units[i]] / divisions)
        first_multiple, last_multiple = np.ceil(low[i] / step - 1e-9), np.floor(high[i] / step + 1e-9)
        if last_multiple < first_multiple:  # narrower than a step
            axes[name] = np.array([(low[i] + high[i]) / 2])
        else:
            values = np.round(np.arange(first_multiple, last_multiple + 1) * step, 12) + 0.0
            axes[name] = np.clip(values, limits[0][i], limits[1][i])
    return PoseGrid(axes, usable_only=not all(is_box(model.robot.usable) for model in models))


def workspace_remedy(model: Model, unreachable: Array, in_millimetres: str) -> str:
    """Return the remedy for poses that cannot be reached: where the workspace is.

    - unreachable: poses that cannot be reached, (N, d)
    - in_millimetres: how to give them in millimetres
    """
    lengths = [component.unit == "m" for component in model.mechanism.pose]
    if np.abs(unreachable[:, lengths]).max(initial=0.0) >= LARGE_LENGTH:
        in_metres = np.where(lengths, unreachable / 1e3, unreachable)
        if model.check(in_metres).valid.any():
            return f"the numbers look like millimetres: {in_millimetres}"
    try:
        return f"the workspace lies within {_workspace_in_words(model)}"
    except PoseError as error:
        return error.remedy


def _nearest_round_number(step: float) -> float:
    """Return the nearest round number: 1, 2, 2.5 or 5 times a power of ten."""
    power = 10.0 ** np.floor(np.log10(step))
    return float(min((m * power for m in (1.0, 2.0, 2.5, 5.0, 10.0)), key=lambda m: abs(np.log(m / step))))
