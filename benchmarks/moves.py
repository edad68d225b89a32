"""Time of a simulated move, beside the duration of the move itself.

    python benchmarks/moves.py

Moves of 0.5 s that are sampled at 1 kHz, on one core; a factor of 40 is forty times as fast as the machine.
"""

from __future__ import annotations

import numpy as np

import pkmodes
from pkmodes.core.support.threads import one_blas_thread
from timing import interleaved

TIME = np.arange(0.0, 0.5, 1e-3)
#: Robot, start and target of a move.
MOVES = {
    "linear-delta-2022-identified": ([0.42, -0.05, -0.22], [0.72, 0.05, -0.18]),
    "clavel-delta": ([-0.15, 0.05, -0.5], [0.15, -0.05, -0.45]),
    "corexy-printer": ([0.05, 0.05], [0.25, 0.2]),
}
DAMPING = {
    "ratio": {"damping.ratio": 0.01},
    "ratio, friction and losses": {
        "damping.ratio": 0.01,
        "effects.belt_loss.loss_factor": 0.02,
        "effects.reducer_loss.loss_factor": 0.02,
        "effects.rail_friction.viscous": 20.0,
    },
}


def main() -> None:
    print(f"{'robot':58s} {'ms':>7s} {'times as fast':>14s}")
    for name, (start, target) in MOVES.items():
        loaded = pkmodes.load(f"robots/{name}.toml")
        share = 0.5 - 0.5 * np.cos(np.pi * np.minimum(TIME / 0.3, 1.0))
        poses = np.array(start) + share[:, None] * (np.array(target) - np.array(start))
        for damping, values in DAMPING.items():
            known = {"damping", *(f"effects.{effect}" for effect in loaded.mechanism.effects)}
            model = loaded.with_values(
                {path: v for path, v in values.items() if path.rpartition(".")[0] in known}
            )
            with one_blas_thread():
                best = interleaved({"": lambda model=model, poses=poses: model.simulate(TIME, poses)})[""]
            print(f"{name + ', ' + damping:58s} {1e3 * best:7.2f} {TIME[-1] / best:14.0f}")


if __name__ == "__main__":
    main()
