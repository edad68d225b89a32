"""Regular poses of a robot, well inside its workspace, and a sample robot of each mechanism."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.poses import margin_of
from pkmodes_description import Key

Array = NDArray[np.float64]
#: Condition number up to which a pose is regular.
REGULAR = 15.0
#: Smallest margin of a regular pose, as a fraction of the largest margin among all poses drawn.
INSIDE = 0.02
#: Number of poses drawn in each round: a narrow workspace needs more.
DRAWS = (500, 2_000, 8_000, 32_000, 128_000, 512_000)
SEED = 20220101
#: Range in which rotations of a pose are drawn [rad].
TURNED = 0.5
#: Rounds that narrow the box of a platform that turns, poses drawn in each, and best poses that define the next box.
ROUNDS, TRIED, BEST = 12, 2_000, 100
#: Margin on each side of the next box, as a fraction of its length, and fraction of valid poses that is enough.
ROOM, ENOUGH = 0.2, 0.1


def sample(mechanism: Mechanism) -> Any:
    """Return the parameters of an asymmetric robot: terms that vanish by symmetry in a real robot do not here."""
    values = {name: np.array(v) if isinstance(v, list) else v for name, v in mechanism.sample.items()}
    return mechanism.model.Parameters(**values)


@cache
def sample_pose(mechanism: Mechanism) -> Array:
    """Return a regular pose of the sample robot, (d,), which no inertia and no effect changes."""
    plain = sample(mechanism)
    pose: Array = regular_poses(Generated(mechanism.model, plain), mechanism, plain, 1)[0]
    pose.setflags(write=False)
    return pose


def declared(mechanism: Mechanism) -> list[Key]:
    """Return the keys of the robot file whose values are fields of the generated parameters."""
    return [key for table in mechanism.tables for key in table.keys if key.field]


def travel(mechanism: Mechanism, parameters: Any) -> Array:
    """Return the limits of the independent coordinates, (k, 2), from the pairs in the robot's tables, if any."""
    pairs = [np.empty((0, 2))]
    for key in declared(mechanism):
        if key.kind == "pair":
            place: tuple[Any, ...] = (..., *key.index, slice(None))
            pairs.append(np.asarray(getattr(parameters, key.field), dtype=float)[place])
    return np.concatenate([pair.reshape(-1, 2) for pair in pairs])[: len(mechanism.independent)]


def extent(mechanism: Mechanism, parameters: Any) -> float:
    """Return an upper bound of the robot's reach [m]: the sum of its lengths."""
    lengths = {key.field for key in declared(mechanism) if key.dimension == "length"}
    return sum(float(np.max(np.abs(getattr(parameters, field)))) for field in lengths)


def regular_poses(generated: Generated, mechanism: Mechanism, parameters: Any, count: int = 4) -> Array:
    """Find poses well inside the workspace of a robot.

    - generated: functions for this robot
    - count: number of poses

    Returns (N, d): at most `count` poses; fewer if no more were found.
    """
    rng = np.random.default_rng(SEED)
    chosen: list[Array] = []
    with np.errstate(all="ignore"):
        for draws in DRAWS:
            p = drawn_poses(generated, mechanism, parameters, rng, draws)
            good = np.isfinite(p).all(axis=-1)
            for margin in mechanism.margins:
                values = margin_of(generated, margin, p).reshape(len(p), -1)
                if margin.rule == "at_most_limit":
                    good &= (values < REGULAR).all(axis=-1)
                else:
                    good &= (values > INSIDE * np.nanmax(values, initial=0.0)).all(axis=-1)
            chosen.append(p[good])
            if sum(map(len, chosen)) >= count:
                break
    return np.concatenate(chosen)[:count]


def drawn_poses(
    generated: Generated, mechanism: Mechanism, parameters: Any, rng: np.random.Generator, count: int
) -> Array:
    """Draw poses: from the limits of the independent coordinates, or in a box that contains the workspace.

    Where the platform turns, the box is narrowed to poses that nearly meet all conditions: in six dimensions hardly
    any pose of a wide one does.

    - generated: functions for this robot

    Returns (count, d); NaN where links do not meet; not all of the others can be reached.
    """
    names = tuple(component.name for component in mechanism.pose)
    ends = travel(mechanism, parameters)
    has_limits = len(ends) == len(mechanism.independent)
    if has_limits and (generated.has("direct_kinematics") or names == mechanism.independent):
        low, high = ends.T
        q = rng.uniform(low, high, size=(count, len(low)))
        if names == mechanism.independent:
            return q
        assembly = np.where(np.arange(count) % 2, 1.0, -1.0)
        return np.asarray(generated.direct_kinematics(q, assembly))
    reach = extent(mechanism, parameters)
    size = np.array([reach if component.unit == "m" else TURNED for component in mechanism.pose])
    low, high = _narrowed(generated, mechanism, rng, size) if mechanism.rotations else (-size, size)
    return rng.uniform(low, high, size=(count, len(size)))


def _narrowed(
    generated: Generated, mechanism: Mechanism, rng: np.random.Generator, size: Array
) -> tuple[Array, Array]:
    """Return the ends of a box, within that of a half size (d,), in which more poses meet all conditions.

    Round by round, it surrounds the poses closest to meeting them (the cross-entropy method; Rubinstein, 1999).
    """
    low, high = -size, size
    for _ in range(ROUNDS):
        p = rng.uniform(low, high, size=(TRIED, len(size)))
        lacking = _lacking(generated, mechanism, p)
        good = p[lacking == 0.0]
        if len(good) >= ENOUGH * TRIED:
            break
        best = good if len(good) >= BEST else p[np.argsort(lacking, kind="stable")[:BEST]]
        ends = best.min(axis=0), best.max(axis=0)
        room = ROOM * (ends[1] - ends[0])
        low, high = np.maximum(low, ends[0] - room), np.minimum(high, ends[1] + room)
    return low, high


def _lacking(generated: Generated, mechanism: Mechanism, p: Array) -> Array:
    """Return how far poses are from meeting all conditions, (N,): 0 where they meet them.

    A condition that is NaN, as where links do not meet, counts as worse than any other: the rest order such poses.
    """
    lacking = np.zeros(len(p))
    with np.errstate(all="ignore"):
        for margin in mechanism.margins:
            values = margin_of(generated, margin, p).reshape(len(p), -1)
            short = np.log(values / REGULAR) if margin.rule == "at_most_limit" else -values
            finite = np.isfinite(short)
            scale = np.median(np.abs(short[finite])) if finite.any() else 1.0
            part = np.maximum(short / (scale or 1.0), 0.0)
            worst = part[finite].max(initial=0.0)
            lacking += np.where(finite, part, 1.0 + worst).sum(axis=-1)
    return lacking
