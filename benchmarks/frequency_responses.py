"""Time of 1,000 frequencies of the responses at a pose, beside linear systems that are solved for each of them.

    python benchmarks/frequency_responses.py

All begin with the matrices and modes of the pose.  NumPy solves the linear systems one by one, or in one batch, on
one core: two ratios.  The error is the largest difference between the two in parts of the peak of a channel.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

import pkmodes
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.machine.response.equations import EquationsOfMotion, equations
from pkmodes.machine.response.linearised import LinearisedRobot
from pkmodes.machine.response.ports import input_vectors, inputs_of, output_vectors, outputs_of, prescribed
from timing import interleaved

FREQUENCIES = np.linspace(0.5, 400.0, 1000)
ROBOTS = {
    "linear-delta-2022": [0.6, 0.05, -0.245],
    "clavel-delta": [0.03, 0.02, -0.45],
    "corexy-printer": [0.02, 0.05],
}
#: Of these, a robot gets the effects that its mechanism has.
EFFECTS = {
    "": {},
    "soft joints": {"gearbox_compliance.compliance": 2e-3, "link_compliance.compliance": 1e-7},
}
DAMPING = {
    "ratio": {},
    "ratio and losses": {
        "belt_loss.loss_factor": 0.02,
        "reducer_loss.loss_factor": 0.02,
        "rail_friction.viscous": 20.0,
    },
}


def equations_of(model: pkmodes.Model, pose: Sequence[float], drives: str) -> EquationsOfMotion:
    mechanism = model.mechanism
    drive = "motor_" if drives == "held" else "torque_"
    inputs = inputs_of(
        model, [f"{drive}{mechanism.drives[0].name}", f"force_{mechanism.directions[0]}"], drives
    )
    outputs = outputs_of(model, [*(f"p_{name}" for name in mechanism.directions), model.coordinates[0]])
    at = LinearisedRobot(model, np.array([pose]), drives, "auto")
    motors = prescribed(inputs, len(mechanism.drives))
    return equations(at, 0, input_vectors(at, inputs)[0], motors, output_vectors(at, outputs)[0])


def one_by_one(case: EquationsOfMotion, omega: np.ndarray) -> np.ndarray:
    """Solve a linear system for each frequency, as one would write it."""
    K, C, M, (constant, rate, inertia) = case.K, case.C + case.modal, case.M, case.forces
    found = []
    for w in omega:
        q = np.linalg.solve(K + 1j * w * C - w**2 * M, constant + 1j * w * rate - w**2 * inertia)
        found.append(case.motion @ q + case.prescribed)
    return np.array(found)


def main() -> None:
    omega = 2.0 * np.pi * FREQUENCIES
    print(f"{'robot':52s} {'motors':6s} {'size':>4s} {'ms':>7s} {'each':>6s} {'batch':>6s} {'error':>8s}")
    for name, pose in ROBOTS.items():
        loaded = pkmodes.load(f"robots/{name}.toml")
        for effect, values in EFFECTS.items():
            for damping, also in DAMPING.items():
                effects = {
                    f"effects.{path}": value
                    for path, value in {**values, **also}.items()
                    if path.partition(".")[0] in loaded.mechanism.effects
                }
                model = loaded.with_values({"damping.ratio": 0.02, **effects})
                for drives in ("free", "held"):
                    case = equations_of(model, pose, drives)
                    ways = {
                        "each": partial(one_by_one, case, omega),
                        "batch": partial(case.by_frequency, omega),
                        "ours": partial(case.response, omega),
                    }
                    _, expected, found = (way() for way in ways.values())
                    times = interleaved(ways)
                    ours = times["ours"]
                    peak = np.abs(expected).max(axis=0)
                    scale = np.maximum(peak, 1e-3 * peak.max(axis=0))
                    error = (np.abs(found - expected).max(axis=0) / scale).max()
                    what = ", ".join(filter(None, (name, effect, damping)))
                    figures = f"{len(case.M):4d} {1e3 * ours:7.2f} {times['each'] / ours:6.1f}"
                    print(f"{what:52s} {drives:6s} {figures} {times['batch'] / ours:6.1f} {error:8.0e}")


if __name__ == "__main__":
    with one_blas_thread():
        main()
