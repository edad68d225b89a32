"""Regular poses of a robot, well inside its workspace, and a sample robot of each mechanism."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.poses import evaluate_margin
from pkmodes_description import Key

Array = NDArray[np.float64]
#: Condition number up to which a pose is regular.
MAX_REGULAR_CONDITION = 15.0
#: Smallest margin of a regular pose, as a fraction of the largest margin among all poses drawn.
MIN_RELATIVE_MARGIN = 0.02
#: Number of poses drawn in each round: a narrow workspace needs more.
DRAW_COUNTS = (500, 2_000, 8_000, 32_000, 128_000, 512_000)
SEED = 20220101
#: Range in which rotations of a pose are drawn [rad].
MAX_ROTATION = 0.5
#: Rounds that narrow the box of a platform that turns, poses drawn in each, and best poses that define the next box.
NARROWING_ROUNDS, POSES_PER_ROUND, BEST_POSES = 12, 2_000, 100
#: Margin on each side of the next box, as a fraction of its length, and fraction of valid poses that is enough.
BOX_PADDING, SUFFICIENT_FRACTION = 0.2, 0.1


def sample_parameters(mechanism: Mechanism) -> Any:
    """Return the parameters of an asymmetric robot: terms that vanish by symmetry in a real robot do not here."""
    values = {name: np.array(v) if isinstance(v, list) else v for name, v in mechanism.sample.items()}
    return mechanism.model.Parameters(**values)


@cache
def sample_pose(mechanism: Mechanism) -> Array:
    """Return a regular pose of the sample robot, (d,), independent of inertias and effects."""
    parameters = sample_parameters(mechanism)
    pose: Array = regular_poses(Generated(mechanism.model, parameters), mechanism, parameters, 1)[0]
    pose.setflags(write=False)
    return pose


def field_keys(mechanism: Mechanism) -> list[Key]:
    """Return the keys of the robot file whose values are fields of the generated parameters."""
    return [key for table in mechanism.tables for key in table.keys if key.field]


def travel_limits(mechanism: Mechanism, parameters: Any) -> Array:
    """Return the limits of the independent coordinates, (k, 2), from the pairs in the robot's tables, if any."""
    pairs = [np.empty((0, 2))]
    for key in field_keys(mechanism):
        if key.kind == "pair":
            index: tuple[Any, ...] = (..., *key.index, slice(None))
            pairs.append(np.asarray(getattr(parameters, key.field), dtype=float)[index])
    return np.concatenate([pair.reshape(-1, 2) for pair in pairs])[: len(mechanism.independent)]


def reach_bound(mechanism: Mechanism, parameters: Any) -> float:
    """Return an upper bound of the robot's reach [m]: the sum of its lengths."""
    lengths = {key.field for key in field_keys(mechanism) if key.dimension == "length"}
    return sum(float(np.max(np.abs(getattr(parameters, field)))) for field in lengths)


def regular_poses(generated: Generated, mechanism: Mechanism, parameters: Any, max_count: int = 4) -> Array:
    """Find poses well inside the workspace of a robot.

    - generated: functions for this robot
    - max_count: number of poses

    Returns (N, d): at most `max_count` poses; fewer if no more were found.
    """
    rng = np.random.default_rng(SEED)
    regular_parts: list[Array] = []
    with np.errstate(all="ignore"):
        for count in DRAW_COUNTS:
            p = draw_poses(generated, mechanism, parameters, rng, count)
            is_regular = np.isfinite(p).all(axis=-1)
            for margin in mechanism.margins:
                values = evaluate_margin(generated, margin, p).reshape(len(p), -1)
                if margin.rule == "at_most_limit":
                    is_regular &= (values < MAX_REGULAR_CONDITION).all(axis=-1)
                else:
                    is_regular &= (values > MIN_RELATIVE_MARGIN * np.nanmax(values, initial=0.0)).all(axis=-1)
            regular_parts.append(p[is_regular])
            if sum(map(len, regular_parts)) >= max_count:
                break
    return np.concatenate(regular_parts)[:max_count]


def draw_poses(
    generated: Generated, mechanism: Mechanism, parameters: Any, rng: np.random.Generator, count: int
) -> Array:
    """Draw poses: from the limits of the independent coordinates, or in a box that contains the workspace.

    Where the platform turns, the box is narrowed to poses that nearly meet all conditions: in six dimensions hardly
    any pose in a wide box does.

    - generated: functions for this robot

    Returns (count, d); NaN where links do not meet; not all of the others can be reached.
    """
    names = tuple(component.name for component in mechanism.pose)
    limits = travel_limits(mechanism, parameters)
    has_limits = len(limits) == len(mechanism.independent)
    if has_limits and (generated.has("direct_kinematics") or names == mechanism.independent):
        low, high = limits.T
        if not (low <= high).all():
            problem = (
                f"the sample robot of {mechanism.name} has a travel whose lower end is above its upper end"
            )
            raise PkmodesError(problem, "description.json: sample", "restore the file, or generate it again")
        q = rng.uniform(low, high, size=(count, len(low)))
        if names == mechanism.independent:
            return q
        assembly = np.where(np.arange(count) % 2, 1.0, -1.0)
        return np.asarray(generated.direct_kinematics(q, assembly))
    reach = reach_bound(mechanism, parameters)
    half_size = np.array([reach if component.unit == "m" else MAX_ROTATION for component in mechanism.pose])
    low, high = (
        _narrowed_box(generated, mechanism, rng, half_size)
        if mechanism.rotations
        else (-half_size, half_size)
    )
    return rng.uniform(low, high, size=(count, len(half_size)))


def _narrowed_box(
    generated: Generated, mechanism: Mechanism, rng: np.random.Generator, half_size: Array
) -> tuple[Array, Array]:
    """Return the ends of a box, within that of a half size (d,), in which more poses meet all conditions.

    Round by round, it surrounds the poses closest to meeting them (the cross-entropy method; Rubinstein, 1999).
    """
    low, high = -half_size, half_size
    for _ in range(NARROWING_ROUNDS):
        p = rng.uniform(low, high, size=(POSES_PER_ROUND, len(half_size)))
        violations = _violations(generated, mechanism, p)
        valid_poses = p[violations == 0.0]
        if len(valid_poses) >= SUFFICIENT_FRACTION * POSES_PER_ROUND:
            break
        best_poses = (
            valid_poses
            if len(valid_poses) >= BEST_POSES
            else p[np.argsort(violations, kind="stable")[:BEST_POSES]]
        )
        bounds = best_poses.min(axis=0), best_poses.max(axis=0)
        padding = BOX_PADDING * (bounds[1] - bounds[0])
        low, high = np.maximum(low, bounds[0] - padding), np.minimum(high, bounds[1] + padding)
    return low, high


def _violations(generated: Generated, mechanism: Mechanism, p: Array) -> Array:
    """Return how far poses are from meeting all conditions, (N,): 0 where they meet them.

    A condition that is NaN, as where links do not meet, counts as worse than any other value of it; such poses are
    ranked by their other conditions.
    """
    violations = np.zeros(len(p))
    with np.errstate(all="ignore"):
        for margin in mechanism.margins:
            values = evaluate_margin(generated, margin, p).reshape(len(p), -1)
            excess = np.log(values / MAX_REGULAR_CONDITION) if margin.rule == "at_most_limit" else -values
            is_finite = np.isfinite(excess)
            scale = np.median(np.abs(excess[is_finite])) if is_finite.any() else 1.0
            scaled = np.maximum(excess / (scale or 1.0), 0.0)
            max_excess = scaled[is_finite].max(initial=0.0)
            violations += np.where(is_finite, scaled, 1.0 + max_excess).sum(axis=-1)
    return violations
