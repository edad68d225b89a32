"""Agreement of the compiled evaluator with NumPy for many random robots, effects and poses.

Some of the robots are out of proportion or nearly singular, where rounding costs LAPACK digits, too.  By default
there are 12,000 poses of each mechanism; `PKMODES_ROBOTS` sets the number of robots, of 500 poses each, so 2000
means a million.  With ``-s`` the errors are printed.
"""

from __future__ import annotations

import os

import numpy as np
import pytest

from helpers.references.lane_agreement import LIMITS, errors
from helpers.robots.lane_samples import EFFECTS, EXTREMES, NAMES, case

pytestmark = pytest.mark.compiler

ROBOTS = int(os.environ.get("PKMODES_ROBOTS", "24"))
POSES = 500
#: Share of poses that may exceed a limit, unless LAPACK exceeds it half as often, and the multiple of the limit that
#: none may exceed: with a condition number of M near 1e7, rounding alone costs a thousandfold.
SHARE, MOST = 2e-3, 1e3


@pytest.mark.parametrize("name", NAMES)
def test_random_robots_agree_with_numpy(name: str) -> None:
    rng = np.random.default_rng(20261122)
    compiled: dict[str, list[np.ndarray]] = {limit: [] for limit in LIMITS}
    numpy: dict[str, list[np.ndarray]] = {limit: [] for limit in LIMITS}
    for seed in rng.integers(2, 2**31, ROBOTS).tolist():  # the first two robots are not random
        effects = "none" if rng.random() < 0.5 else str(rng.choice(list(EFFECTS)))
        extreme = str(rng.choice(list(EXTREMES)))
        for all_errors, of_case in zip(
            (compiled, numpy), errors(case(name, seed, effects, extreme, POSES)), strict=True
        ):
            for limit, error in of_case.items():
                all_errors[limit].append(error)
    for limit, largest in LIMITS.items():
        own, reference = (np.concatenate(found[limit] or [np.zeros(1)]) for found in (compiled, numpy))
        beyond = np.mean(own > largest)
        lapack = f"; LAPACK {reference.max():.1e}, {np.mean(reference > largest):.1e}"
        print(
            f"{name:13} {limit:14} {len(own):8} poses: median {np.median(own):.1e}, largest {own.max():.1e}, "
            f"{beyond:.1e} of them above {largest:.0e}{lapack if reference.any() else ''}"
        )
        bad = max(SHARE, 2.0 * float(np.mean(reference > largest)))
        assert beyond <= bad, limit
        assert own.max() <= MOST * largest, limit
