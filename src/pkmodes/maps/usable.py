"""The usable workspace of a robot: the part of the reachable one within the limits that its file declares."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.model import Model
from pkmodes.core.robot.usable import USABLE, in_words, inside, limits_of
from pkmodes.maps.reached import (
    BEYOND,
    DRAWS,
    ROUNDS,
    SEED,
    SETTLED,
    Inside,
    box_of,
    drawn_and_reached,
    hanging,
    on_branch,
    some,
    workspace_in_words,
)

Array = NDArray[np.float64]
#: Usable poses after which the ends of the box around them are known well enough.
ENOUGH = 5_000


def usable_box(model: Model, pose: Array | None = None) -> tuple[Array, Array]:
    """Return the box around the poses where the robot is used: those of `box_of` within its usable limits.

    Parameters
    ----------
    pose : ndarray, shape (d,), optional
        A pose on the branch; by default the branch, among those with usable poses, whose platform hangs lower.  A
        pose beyond the limits lifts them.

    Returns
    -------
    low, high : ndarray, shape (d,)

    Raises
    ------
    PoseError
        If no pose was found within the limits.
    """
    usable = within(model)
    if not model.robot.usable or not (pose is None or usable(pose[None])[0]):
        return box_of(model, pose)
    first = hanging(model, usable_poses(model))[0] if pose is None else pose
    low, high = _clipped(model, *box_of(model, first))
    of_branch, rng = used(model, first), np.random.default_rng(SEED)
    found, count = [first[None]], 1
    for _ in range(ROUNDS):
        drawn = rng.uniform(low, high, (DRAWS, len(low)))
        found.append(drawn[of_branch(drawn)])
        count += len(found[-1])
        if count >= ENOUGH:
            break
    reached = np.vstack(found)
    ends, most = (reached.min(axis=0), reached.max(axis=0)), SETTLED * (high - low)
    # An end that is reached is that of the box itself; draws only come near it.
    return np.where(ends[0] - low > most, ends[0], low), np.where(high - ends[1] > most, ends[1], high)


def usable_poses(model: Model) -> Array:
    """Return some poses, (N, d), of any branch, that can be evaluated and are within the usable limits.

    Raises
    ------
    PoseError
        If none was found.
    """
    rng, usable = np.random.default_rng(SEED), within(model)
    reached = some(model, drawn_and_reached(model, rng))
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
    limits = in_words(model.mechanism, model.robot.usable)
    what = f"no pose within the usable limits can be reached: {limits}"
    remedy = f"check the limits: the workspace lies within {workspace_in_words(model)}"
    raise PoseError(what, f"{model.robot.source}: {USABLE}", remedy)


def within(model: Model) -> Inside:
    """Return the test whether poses, (N, d), are within the usable limits of the robot."""
    return lambda points: inside(model.robot, np.asarray(points, dtype=float))


def used(model: Model, pose: Array) -> Inside:
    """Return the test of `on_branch`, also within the usable limits unless the pose itself is beyond them."""
    reached, usable = on_branch(model, pose), within(model)
    if not model.robot.usable or not usable(pose[None])[0]:
        return reached
    return lambda points: reached(points) & usable(points)


def _clipped(model: Model, low: Array, high: Array) -> tuple[Array, Array]:
    limits = limits_of(model.mechanism, model.robot.usable)
    return np.maximum(low, limits[0]), np.minimum(high, limits[1])
