"""What a pose of a machine whose platform turns costs, as multiples of one of the linear delta, in one run.

    PYTHONPATH=src:generated OMP_NUM_THREADS=1 python benchmarks/turning.py

Random poses around the middle of each workspace, calls in turn (`timing.py`), in the compiled evaluator.  Parts are
differences: what the frequencies take beyond M and K is the eigenproblem.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

import pkmodes
from peers import BLOCK
from timing import interleaved

ROBOTS = Path(__file__).parents[1] / "robots"
#: Robot by mechanism: its file, a pose in the middle, and how far the poses are from it.
MACHINES = {
    "linear_delta": ("linear-delta-2022", (0.56, 0.0, -0.245), (0.15, 0.06, 0.03)),
    "hexapod": ("hexapod", (0.0, 0.0, 0.25, 0.0, 0.0, 0.0), (0.02, 0.02, 0.01, 0.1, 0.1, 0.1)),
    "hexaglide": ("hexaglide", (0.0, 0.0, 0.25, 0.0, 0.0, 0.0), (0.05, 0.05, 0.03, 0.1, 0.1, 0.1)),
}
REFERENCE = "linear_delta"
POSES = 4 * BLOCK


def main() -> None:
    calls: dict[str, Callable[[], object]] = {}
    for name in MACHINES:
        calls |= {f"{name}: {what}": call for what, call in calls_of(name).items()}
    times = {name: 1e6 * time / POSES for name, time in interleaved(calls).items()}
    kinds = [name.partition(": ")[2] for name in times if name.startswith(REFERENCE)]
    print(f"| us per pose (ratio) | {' | '.join(MACHINES)} |\n| --- |{' --- |' * len(MACHINES)}")
    for kind in kinds:
        reference = times[f"{REFERENCE}: {kind}"]
        cells = [
            f"{times[f'{name}: {kind}']:.2f} ({times[f'{name}: {kind}'] / reference:.1f})"
            for name in MACHINES
        ]
        print(f"| {kind} | {' | '.join(cells)} |")


def machine(name: str, count: int) -> tuple[pkmodes.Model, np.ndarray]:
    """Return a machine of `MACHINES`, and poses of it, (count, d): always the same ones."""
    file, middle, around = MACHINES[name]
    model = pkmodes.load(ROBOTS / f"{file}.toml")
    drawn = np.random.default_rng(1).uniform(-1, 1, (count, len(middle)))
    poses = np.array(middle) + np.array(around) * drawn
    if not model.check(poses).valid.all():
        raise RuntimeError(f"{name}: some poses cannot be evaluated")
    return model, poses


def calls_of(name: str) -> dict[str, Callable[[], object]]:
    model, poses = machine(name, POSES)
    n = len(model.coordinates)
    evaluator = model.solver("compiled").evaluator
    frequencies, shapes = np.zeros((POSES, n)), np.zeros((POSES, n, n))
    matrices = {field: np.zeros((BLOCK, n, n)) for field in ("mass_matrix", "stiffness_matrix")}

    def both_matrices() -> None:  # into arrays that stay in the cache
        for start in range(0, POSES, BLOCK):
            evaluator.run(poses[start : start + BLOCK], matrices)

    return {
        "checked": partial(evaluator.run, poses, {}),
        "M and K": both_matrices,
        "frequencies": partial(evaluator.run, poses, {"frequencies": frequencies}),
        "with shapes": partial(evaluator.run, poses, {"frequencies": frequencies, "shapes": shapes}),
        "modes": partial(model.modes, poses, backend="compiled", threads=1),
        "modes, motors held": partial(model.modes, poses, drives="held", backend="compiled", threads=1),
    }


if __name__ == "__main__":
    main()
