"""The reachable workspace of a robot: its assembly branches, and the box around it, found by drawing poses."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.regular import drawn_poses
from pkmodes.core.model import Model
from pkmodes.core.robot.usable import Limits, in_words

Array = NDArray[np.float64]
Inside = Callable[[Array], NDArray[np.bool_]]
#: Poses drawn in each round; a round is the last if it moves no end of the box by more than this part of its length.
DRAWS, SETTLED, ROUNDS = 200_000, 0.01, 12
#: Part of the length of the box by which it is extended on each side before the next round.
BEYOND = 0.1
SEED = 20260105


def box_of(model: Model, pose: Array | None = None) -> tuple[Array, Array]:
    """Return the box around the poses that can be evaluated, on one assembly branch.

    Parameters
    ----------
    pose : ndarray, shape (d,), optional
        A pose on the branch; by default the branch whose platform hangs lower.

    Returns
    -------
    low, high : ndarray, shape (d,)

    Raises
    ------
    PoseError
        If no pose was found.
    """
    rng = np.random.default_rng(SEED)
    reached = drawn_and_reached(model, rng)
    if pose is None:
        pose = hanging(model, some(model, reached))[0]
    inside = on_branch(model, pose)
    reached = np.vstack([pose, reached[inside(reached)]]) if len(reached) else pose[None]
    low, high = reached.min(axis=0), reached.max(axis=0)
    for _ in range(ROUNDS):
        size = np.where(high > low, high - low, 1e-3)
        drawn = rng.uniform(low - BEYOND * size, high + BEYOND * size, (DRAWS, len(low)))
        more = drawn[inside(drawn)]
        if not len(more):
            break
        wider = np.minimum(low, more.min(axis=0)), np.maximum(high, more.max(axis=0))
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

    Parameters
    ----------
    poses : ndarray, shape (N, d)
        That can be evaluated.
    """
    if not model.has_assemblies:
        return poses
    sides = model.assembly(poses)
    potential = Generated(model.mechanism.model, model.robot.parameters).gravity_potential(poses)
    chosen: Array = poses[
        sides == min(np.unique(sides), key=lambda side: float(potential[sides == side].mean()))
    ]
    return chosen


def workspace_in_words(model: Model) -> str:
    """Return where the reachable workspace is."""
    low, high = box_of(model)
    names = [component.name for component in model.mechanism.pose]
    ends = map(Limits, low.tolist(), high.tolist())
    return in_words(model.mechanism, dict(zip(names, ends, strict=True)))


def drawn_and_reached(model: Model, rng: np.random.Generator) -> Array:
    """Draw poses, and return those that can be evaluated, (N, d), on any branch."""
    with np.errstate(all="ignore"):
        generated = Generated(model.mechanism.model, model.robot.parameters)
        drawn = drawn_poses(generated, model.mechanism, model.robot.parameters, rng, DRAWS)
    drawn = drawn[np.isfinite(drawn).all(axis=-1)]
    return drawn[model.check(drawn).valid] if len(drawn) else drawn


def some(model: Model, reached: Array) -> Array:
    """Refuse a robot that reaches no pose."""
    if not len(reached):
        what = f"none of {DRAWS:,} poses drawn can be reached"
        raise PoseError(what, model.robot.source, "check the robot file, or give a grid or poses")
    return reached
