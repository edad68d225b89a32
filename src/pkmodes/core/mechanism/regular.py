"""Regular poses of a robot, well inside its workspace, and a sample robot of each mechanism."""

from __future__ import annotations

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


def sample(mechanism: Mechanism) -> Any:
    """Return the parameters of an asymmetric robot: terms that vanish by symmetry in a real robot do not here."""
    values = {name: np.array(v) if isinstance(v, list) else v for name, v in mechanism.sample.items()}
    return mechanism.model.Parameters(**values)


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


def regular_poses(generated: Generated, mechanism: Mechanism, parameters: Any, wanted: int = 4) -> Array:
    """Find poses well inside the workspace of a robot.

    Parameters
    ----------
    generated : Generated
        Functions for this robot.
    wanted : int
        Number of poses.

    Returns
    -------
    ndarray, shape (N, d)
        At most `wanted` poses; fewer if no more were found.
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
            if sum(map(len, chosen)) >= wanted:
                break
    return np.concatenate(chosen)[:wanted]


def drawn_poses(
    generated: Generated, mechanism: Mechanism, parameters: Any, rng: np.random.Generator, count: int
) -> Array:
    """Draw poses: from the limits of the independent coordinates, or in a box that contains the workspace.

    Parameters
    ----------
    generated : Generated
        Functions for this robot.

    Returns
    -------
    ndarray, shape (count, d)
        NaN where links do not meet; not all of the others can be reached.
    """
    names = tuple(component.name for component in mechanism.pose)
    ends = travel(mechanism, parameters)
    given = len(ends) == len(mechanism.independent)
    if given and (generated.has("direct_kinematics") or names == mechanism.independent):
        low, high = ends.T
        q = rng.uniform(low, high, size=(count, len(low)))
        if names == mechanism.independent:
            return q
        assembly = np.where(np.arange(count) % 2, 1.0, -1.0)
        return np.asarray(generated.direct_kinematics(q, assembly))
    reach = extent(mechanism, parameters)
    size = np.array([reach if component.unit == "m" else TURNED for component in mechanism.pose])
    return rng.uniform(-size, size, size=(count, len(size)))
