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
from pkmodes.core.mechanism.regular import drawn_poses
from pkmodes.core.model import Model
from pkmodes.core.robot.usable import USABLE, Limits, is_box, limits_in_words
from pkmodes.core.robot.usable_poses import bounding_box, within_limits
from pkmodes.core.support.progress import say
from pkmodes.machine.maps.poses import PoseGrid

Array = NDArray[np.float64]
Inside = Callable[[Array], NDArray[np.bool_]]
#: Poses drawn in each round, the relative change of the box below which rounds end, and most rounds.
DRAWS, SETTLED, ROUNDS = 200_000, 0.01, 12
#: Fraction of its length by which the box is extended on each side before the next round.
BEYOND = 0.1
SEED = 20260105
#: Smallest offset of a platform's origin to one side of its joints, relative to the characteristic length.
BESIDE = 0.01
#: Number of usable poses from which the ends of the box around them are known well enough.
ENOUGH = 5_000
#: Approximate number of poses of the grid, and the most along one component.
POSES, LONGEST = 50_000, 1_000


def resting(model: Model, pose: Array | None = None) -> dict[int, float]:
    """Return the components of a pose that stay as they are in a workspace, by index: the rotations of the platform.

    - pose: a pose in it, (d,); by default rotations are 0, or the nearest value within the usable limits
    """
    mechanism = model.mechanism
    names = [component.name for component in mechanism.pose]
    still = [names.index(name) for name in mechanism.components[len(mechanism.directions) :]]
    low, high = bounding_box(mechanism, model.robot.usable)
    values = np.clip(0.0, low, high) if pose is None else pose
    return {i: float(values[i]) for i in still}


def box_of(
    model: Model, pose: Array | None = None, still: Mapping[int, float] | None = None
) -> tuple[Array, Array]:
    """Return the box around the poses that can be evaluated, on one assembly branch.

    - pose: a pose on the branch, (d,); by default the branch whose platform hangs lower
    - still: components that stay as they are, by index; by default the rotations of the platform, see `resting`

    Returns low and high, (d,).
    Raises PoseError if no pose was found.
    """
    rng = np.random.default_rng(SEED)
    still = resting(model, pose) if still is None else still
    reached = _drawn_and_reached(model, rng, still)
    if pose is None:
        pose = hanging(model, _checked_reached(model, reached))[0]
    of_branch = on_branch(model, pose)
    reached = np.vstack([pose, reached[of_branch(reached)]]) if len(reached) else pose[None]
    low, high = reached.min(axis=0), reached.max(axis=0)
    for _ in range(ROUNDS):
        size = np.where(high > low, high - low, 1e-3)
        drawn = rng.uniform(low - BEYOND * size, high + BEYOND * size, (DRAWS, len(low)))
        drawn[:, list(still)] = list(still.values())
        further = drawn[of_branch(drawn)]
        if not len(further):
            break
        wider = np.minimum(low, further.min(axis=0)), np.maximum(high, further.max(axis=0))
        moved = max(((low - wider[0]) / size).max(), ((wider[1] - high) / size).max())
        low, high = wider
        if moved <= SETTLED:
            break
    return low, high


def on_branch(model: Model, pose: Array) -> Inside:
    """Return the test whether poses, (N, d), can be evaluated and are on the assembly branch of a pose."""
    if not model.has_assemblies:
        return lambda points: model.check(points).valid
    branch = model.assembly(pose)
    return lambda points: model.check(points).valid & (model.assembly(points, "nan") == branch)


def hanging(model: Model, poses: Array) -> Array:
    """Return the poses of the assembly branch that hangs lower: with the lower mean potential of gravity.

    Where the platform turns and its origin lies to one side of its joints, it is on this side of the other branch;
    where it lies in their middle, legs that change their length carry the platform from below.

    - poses: that can be evaluated, (N, d)
    """
    if not model.has_assemblies:
        return poses
    sides, mechanism = model.assembly(poses), model.mechanism
    beside = np.zeros(len(mechanism.directions))  # from the middle of a platform's joints to its origin
    if mechanism.rotations:
        middle = middle_of_joints(mechanism, model.robot.parameters)
        beside = -middle[["xyz".index(axis) for axis in mechanism.directions]]
    if np.linalg.norm(beside) > BESIDE * model.characteristic_length:
        rank = -poses[:, : len(beside)] @ beside
    else:
        rank = Generated(mechanism.model, model.robot.parameters).gravity_potential(poses)
        if mechanism.rotations and mechanism.drives[0].unit == "N":
            rank = -rank
    chosen: Array = poses[sides == min(np.unique(sides), key=lambda side: float(rank[sides == side].mean()))]
    return chosen


def _workspace_in_words(model: Model) -> str:
    """Return where the reachable workspace is."""
    low, high = box_of(model)
    names = [component.name for component in model.mechanism.pose]
    ends = map(Limits, low.tolist(), high.tolist())
    return limits_in_words(model.mechanism, dict(zip(names, ends, strict=True)))


def _drawn_and_reached(model: Model, rng: np.random.Generator, still: Mapping[int, float]) -> Array:
    """Draw poses with some components fixed, and return those that can be evaluated, (N, d)."""
    with np.errstate(all="ignore"):
        generated = Generated(model.mechanism.model, model.robot.parameters)
        drawn = drawn_poses(generated, model.mechanism, model.robot.parameters, rng, DRAWS)
    drawn = drawn[np.isfinite(drawn).all(axis=-1)]
    drawn[:, list(still)] = list(still.values())
    return drawn[model.check(drawn).valid] if len(drawn) else drawn


def _checked_reached(model: Model, reached: Array) -> Array:
    """Refuse a robot that reaches no pose."""
    if not len(reached):
        problem = f"none of {DRAWS:,} poses drawn can be reached"
        raise PoseError(problem, model.robot.source, "check the robot file, or give a grid or poses")
    return reached


def usable_box(model: Model, pose: Array | None = None) -> tuple[Array, Array]:
    """Return the box around the poses where the robot is used: those of `box_of` within its usable limits.

    - pose: a pose on the branch, (d,); by default the branch, among those with usable poses, whose platform hangs
      lower.  A pose beyond the limits lifts them.

    Returns low and high, (d,).
    Raises PoseError if no pose was found within the limits.
    """
    usable = within(model)
    if not model.robot.usable or not (pose is None or usable(pose[None])[0]):
        return box_of(model, pose)
    first = hanging(model, usable_poses(model))[0] if pose is None else pose
    low, high = _clipped(model, *box_of(model, first))
    of_branch, rng = used(model, first), np.random.default_rng(SEED)
    batches, count = [first[None]], 1
    for _ in range(ROUNDS):
        drawn = rng.uniform(low, high, (DRAWS, len(low)))
        batches.append(drawn[of_branch(drawn)])
        count += len(batches[-1])
        if count >= ENOUGH:
            break
    reached = np.vstack(batches)
    ends, tolerance = (reached.min(axis=0), reached.max(axis=0)), SETTLED * (high - low)
    # An end that is reached is that of the box itself; draws only come near it.
    return np.where(ends[0] - low > tolerance, ends[0], low), np.where(
        high - ends[1] > tolerance, ends[1], high
    )


def turning_box(model: Model, pose: Array) -> tuple[Array, Array]:
    """Return the box around the rotations that a platform can have where it is, within the usable limits.

    - pose: that can be evaluated, (d,)

    Returns low and high, (d,): the other components are those of the pose.
    """
    turning = resting(model, pose)
    still = {i: float(value) for i, value in enumerate(pose) if i not in turning}
    return _clipped(model, *box_of(model, pose, still))


def usable_poses(model: Model) -> Array:
    """Return some poses, (N, d), of any branch, that can be evaluated and are within the usable limits.

    Raises PoseError if none was found.
    """
    rng, usable = np.random.default_rng(SEED), within(model)
    reached = _checked_reached(model, _drawn_and_reached(model, rng, resting(model)))
    if usable(reached).any():
        return reached[usable(reached)]
    ends = reached.min(axis=0), reached.max(axis=0)
    room = BEYOND * (ends[1] - ends[0])
    low, high = _clipped(model, ends[0] - room, ends[1] + room)
    for _ in range(ROUNDS if (low <= high).all() else 0):
        drawn = rng.uniform(low, high, (DRAWS, len(low)))
        drawn = drawn[model.check(drawn).valid]
        if (good := usable(drawn)).any():
            return drawn[good]
    limits = limits_in_words(model.mechanism, model.robot.usable)
    problem = f"no pose within the usable limits can be reached: {limits}"
    remedy = f"check the limits: the workspace lies within {_workspace_in_words(model)}"
    raise PoseError(problem, f"{model.robot.source}: {USABLE}", remedy)


def within(model: Model) -> Inside:
    """Return the test whether poses, (N, d), are within the usable limits of the robot."""
    return lambda points: within_limits(model.robot, np.asarray(points, dtype=float))


def used(model: Model, pose: Array) -> Inside:
    """Return the test of `on_branch`, also within the usable limits unless the pose itself is beyond them."""
    reached, usable = on_branch(model, pose), within(model)
    if not model.robot.usable or not usable(pose[None])[0]:
        return reached
    return lambda points: reached(points) & usable(points)


def _clipped(model: Model, low: Array, high: Array) -> tuple[Array, Array]:
    limits = bounding_box(model.mechanism, model.robot.usable)
    return np.maximum(low, limits[0]), np.minimum(high, limits[1])


def reachable(model: Model, poses: int = POSES) -> PoseGrid:
    """Return a grid over the workspace of a robot, within its usable limits.

    - poses: how many poses the grid has, within a factor of three because steps are round numbers, including those of
      its corners that cannot be reached; along one component at most some 1,000

    Returns round values with the same step for all components of one unit.  Of several separate assemblies, such as
    the platform above and below the rails, the one that hangs lower is mapped.  A platform that can turn does not:
    see `resting`.
    Raises PoseError if no pose was found.
    """
    return reachable_by([model], poses)


def reachable_by(models: Sequence[Model], poses: int = POSES) -> PoseGrid:
    """Return a grid over the workspaces of several robots of one mechanism together: see `reachable`."""
    say("looking for the workspace")
    boxes = [usable_box(model) for model in models]
    low, high = np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)
    mechanism = models[0].mechanism
    bounds = [bounding_box(mechanism, model.robot.usable) for model in models]
    limits = np.min([bound[0] for bound in bounds], axis=0), np.max([bound[1] for bound in bounds], axis=0)
    names = [component.name for component in mechanism.pose]
    units = [component.unit for component in mechanism.pose]
    size, still = np.where(high > low, high - low, 1e-3), resting(models[0])
    # The same step for components of one unit; components of another unit are divided as finely.
    per_unit = {unit: max(size[[u == unit for u in units]]) for unit in units}
    relative = np.delete(size / np.array([per_unit[unit] for unit in units]), list(still))
    divisions = min((poses / np.prod(relative)) ** (1 / len(relative)), LONGEST)
    axes = {}
    for i, name in enumerate(names):
        if i in still:
            axes[name] = np.array([still[i]])
            continue
        step = _round(per_unit[units[i]] / divisions)
        first, last = np.ceil(low[i] / step - 1e-9), np.floor(high[i] / step + 1e-9)
        if last < first:  # narrower than a step
            axes[name] = np.array([(low[i] + high[i]) / 2])
        else:
            values = np.round(np.arange(first, last + 1) * step, 12) + 0.0
            axes[name] = np.clip(values, limits[0][i], limits[1][i])
    return PoseGrid(axes, used=not all(is_box(model.robot.usable) for model in models))


def bounds_of(model: Model, tried: Array, in_millimetres: str) -> str:
    """Return the remedy for poses that cannot be reached: where the workspace is.

    - tried: poses that cannot be reached, (N, d)
    - in_millimetres: how to give them in millimetres
    """
    lengths = [component.unit == "m" for component in model.mechanism.pose]
    if np.abs(tried[:, lengths]).max(initial=0.0) >= LARGE_LENGTH:
        smaller = np.where(lengths, tried / 1e3, tried)
        if model.check(smaller).valid.any():
            return f"the numbers look like millimetres: {in_millimetres}"
    try:
        return f"the workspace lies within {_workspace_in_words(model)}"
    except PoseError as error:
        return error.remedy


def _round(step: float) -> float:
    """Return the nearest round number: 1, 2, 2.5 or 5 times a power of ten."""
    power = 10.0 ** np.floor(np.log10(step))
    return float(min((m * power for m in (1.0, 2.0, 2.5, 5.0, 10.0)), key=lambda m: abs(np.log(m / step))))
