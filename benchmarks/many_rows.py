"""Time and memory of a diagnosis and a comparison of many rows, in one process on one core.

    python benchmarks/many_rows.py

The measurements are the model's modes with noise; the results are not evaluated.
"""

from __future__ import annotations

import resource
import time
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes import updating
from pkmodes.loop.diagnosis import Measurements

ROBOT = Path(__file__).resolve().parents[1] / "examples" / "closed_loop" / "robot.toml"
EFFECT = {"effects.gearbox_compliance.compliance": 2e-4}
CENTRE, REACH, SIGMA, MODES = np.array([0.6, 0.0, -0.245]), np.array([0.15, 0.05, 0.03]), 0.002, 6


def measured(robot: pkmodes.Robot, rows: int, *, shapes: bool) -> Measurements:
    """Return measurements with the given number of rows, six per pose."""
    rng, count = np.random.default_rng(0), rows // MODES
    model = pkmodes.Model(robot.with_values(EFFECT))
    points = CENTRE + rng.uniform(-1.0, 1.0, (3 * count, 3)) * REACH
    points = points[model.check(points).valid][:count]
    modes = model.modes(points, fields=("frequencies", "platform_shapes"))
    f = (modes.frequencies[:, 3:9] * np.exp(SIGMA * rng.standard_normal((count, MODES)))).ravel()
    seen = modes.platform_shapes[:, 3:9]
    seen = seen / np.abs(seen).max(axis=-1, keepdims=True) + 0.02 * rng.standard_normal(seen.shape)
    return Measurements.from_rows(
        np.repeat([f"P{i}" for i in range(count)], MODES).tolist(),
        f,
        SIGMA * f,
        points=np.repeat(points, MODES, axis=0),
        shapes={f"p_{c}": seen[..., i].ravel() for i, c in enumerate("xyz")} if shapes else None,
    )


def main() -> None:
    robot = pkmodes.read_robot(ROBOT)
    print("| what | rows | shapes | time | peak memory |\n|---|---|---|---|---|")
    for what, rows, shapes in (
        ("diagnose", 300, False),
        ("diagnose", 3_000, False),
        ("diagnose", 3_000, True),
        ("compare", 100_000, False),
    ):
        data = measured(robot, rows, shapes=shapes)
        start = time.perf_counter()
        (updating.diagnose if what == "diagnose" else updating.compare)(robot, data)
        seconds = time.perf_counter() - start
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(
            f"| {what} | {rows:,} | {'yes' if shapes else 'no'} | {seconds:.1f} s | {peak:.0f} MB |",
            flush=True,
        )


if __name__ == "__main__":
    main()
