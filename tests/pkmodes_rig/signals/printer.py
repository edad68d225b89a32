"""A CoreXY printer on the rig in a resonance test: Klipper's sweep of an axis, and an ADXL345 on the tool head.

The motors follow the command like springs (`servo_stiffness`).  In coordinates relative to the rigid motion r that is
commanded with acceleration a, the machine moves under the forces -M r a.

    python -m pkmodes_rig.signals.printer examples/printer

writes the folder of the example.
"""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.core.robot.reading import robot_from_document
from pkmodes_rig.corexy import corexy
from pkmodes_rig.signals.adxl345 import Chip, Recording, record, write_spectrum
from pkmodes_rig.signals.excitation import fan, sweep
from pkmodes_rig.signals.integration import responses
from pkmodes_rig.signals.small_motion import Losses
from pkmodes_rig.signals.visits import Machine, Visit, Wander

SEED = 2024
#: Integration step [s]; the sweep [Hz, Hz/s, m/s^2/Hz], as Klipper's default.
STEP = 1.0 / 6400.0
LOWEST, HIGHEST, HERTZ_A_SECOND, PER_HERTZ = 5.0, 130.0, 1.0, 0.075
#: A part fan on the tool head [Hz, m/s^2].
FAN = (107.0, 0.4)
AXES = ("x", "y")
#: Nozzle positions in the coordinates of the robot file [m], and what the owner calls them.
POSES: Mapping[str, tuple[float, float]] = {
    "front left": (0.06, 0.06),
    "centre": (0.15, 0.15),
    "rear right": (0.24, 0.24),
}
REPEATS = 2
SERVO = "servo_stiffness.stiffness"
#: What is not in the robot file of the example: clamps of the belts yield [m/N].
EFFECTS = {SERVO: 15.0, "clamp_compliance.compliance": 2e-6}


@dataclass(frozen=True)
class ResonanceTest:
    """A resonance test: the axis that is moved, and the tone of a fan [Hz, m/s^2] that runs meanwhile."""

    axis: str
    fan: tuple[float, float] = FAN


def printer(parameters: Any, effects: Mapping[str, float] = EFFECTS) -> Machine:
    """Return a printer with some parameters as it is: friction of the rails, losses in the belts."""
    losses = Losses(0.01, {"x": 6.0, "y": 8.0}, factor=0.02)
    return Machine(corexy, parameters, effects, losses=losses)


def swept(
    machine: Machine, visit: Visit, test: ResonanceTest, chip: Chip, rng: np.random.Generator
) -> Recording:
    """Record the tool head during a sweep of the motors."""
    still, modes = machine.at(visit), machine.modes(visit.pose, visit.stiffer)
    commanded = sweep(STEP, LOWEST, HIGHEST, HERTZ_A_SECOND, PER_HERTZ)
    # The rigid motion is a sum of modes, r = Phi c, so that Phi^T M r = c.
    Phi = np.array([modes.shapes[name] for name in modes.coordinates])
    rigid = _rigid(machine, visit, test.axis, modes.coordinates)
    into = -np.linalg.lstsq(Phi, rigid, rcond=None)[0][None, :]
    relative = responses(still, STEP, commanded[:, None], into, still.rows(["p_x", "p_y"]))
    motion = np.column_stack([relative, np.zeros(len(relative))])
    motion[:, AXES.index(test.axis)] += commanded
    t = STEP * np.arange(len(motion))
    frequency, size = test.fan
    for column, share in enumerate((0.6, 1.0, 0.8)):
        motion[:, column] += fan(t, rng, share * size, frequency)
    return record(chip, STEP, motion, rng)


def _rigid(machine: Machine, visit: Visit, axis: str, names: tuple[str, ...]) -> np.ndarray:
    """Return the motion of all coordinates that strains no belt while the head moves by a unit along an axis."""
    free = replace(machine, effects={k: v for k, v in machine.effects.items() if k != SERVO})
    modes = free.modes(visit.pose, visit.stiffer)
    moved = np.array([modes.shapes[f"p_{one}"][: modes.rigid] for one in AXES])
    parts = np.linalg.lstsq(moved, np.array([float(one == axis) for one in AXES]), rcond=None)[0]
    return np.array([modes.shapes[name][: modes.rigid] @ parts for name in names])


def write(folder: Path) -> None:
    """Write the spectra of both axes, measured twice at each pose, for the robot file in the folder."""
    rng = np.random.default_rng(SEED)
    document = tomllib.loads((folder / "robot.toml").read_text(encoding="utf-8"))
    machine, chip = printer(robot_from_document(document, "robot.toml").parameters), Chip.drawn(rng)
    poses = np.array(list(POSES.values()))
    visits = Wander(approach=0.001).visits(machine, poses, REPEATS, rng)
    for label, repeats in zip(POSES, visits, strict=True):
        for number, visit in enumerate(repeats, start=1):
            for axis in AXES:
                name = f"{label.replace(' ', '_')}_{axis}_{number}.csv"
                write_spectrum(folder / name, swept(machine, visit, ResonanceTest(axis), chip, rng))


def main() -> None:
    """Write the measurements of the example."""
    parser = argparse.ArgumentParser(description="Write the measurements of a printer.")
    parser.add_argument("folder", type=Path, help="has robot.toml")
    write(parser.parse_args().folder)


if __name__ == "__main__":
    main()
