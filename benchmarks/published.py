"""The published robot, and poses in its workspace, for benchmarks."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

import pkmodes

ROBOT = Path(__file__).parents[1] / "robots" / "linear-delta-2022.toml"


@cache
def published() -> pkmodes.Model:
    return pkmodes.load(ROBOT)


def valid_poses(count: int) -> np.ndarray:
    """Draw poses that can be evaluated, (count, 3): always the same ones."""
    drawn = np.random.default_rng(1).uniform(-1, 1, (3 * count + 100, 3)) * [0.2, 0.08, 0.05]
    drawn += [0.56, 0.0, -0.245]
    found = drawn[published().check(drawn).valid][:count]
    if len(found) < count:
        raise RuntimeError(f"{len(found)} of {len(drawn)} poses are valid; {count} are needed")
    return found


@cache
def rigid_modes() -> int:
    return published().modes([0.6, 0.0, -0.245]).rigid_modes
