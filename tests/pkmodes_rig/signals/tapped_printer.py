"""The printer of examples/tapped_printer: its tool head is tapped while RepRapFirmware records a LIS3DH.

    python -m pkmodes_rig.signals.tapped_printer examples/tapped_printer

One of its belts is softer than the other, which its robot file does not declare.  The folder has that file.
"""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from pkmodes.core.robot.reading import robot_from_document
from pkmodes_rig.signals.adxl345 import Chip, Recording, record
from pkmodes_rig.signals.excitation import half_sines
from pkmodes_rig.signals.integration import responses
from pkmodes_rig.signals.printer import SERVO, STEP, printer
from pkmodes_rig.signals.visits import Machine, Visit, Wander

SEED = 2024
#: How stiff the motors hold [N m/rad], of which the robot file is unsure; and what it does not say.
EFFECTS = {SERVO: 14.0, "axis_belt_stiffness.factor_1": -0.3}
#: Nozzle positions in the coordinates of the robot file [m].
POSES: Mapping[str, tuple[float, float]] = {
    "front left": (0.06, 0.06),
    "front right": (0.24, 0.06),
    "rear left": (0.06, 0.24),
    "rear right": (0.24, 0.24),
}
REPEATS = 2
#: A recording [s]; the time between taps [s]; what a knuckle does: largest force [N], and how long [s].
SECONDS, BETWEEN, KNUCKLE, CONTACT = 2.0, (0.15, 0.6), (4.0, 12.0), 0.006
#: Nominal rate [Hz], and by how much a chip is off; noise and steps [m/s^2] at +-2 g and 10 bits.
NOMINAL, OFF, NOISE, DIGIT = 1344.0, 0.02, 0.04, 0.0383
GRAVITY = 9.80665


def tapped(machine: Machine, visit: Visit, chip: Chip, rng: np.random.Generator) -> Recording:
    """Record the tool head while it is tapped in the plane, now here, now there."""
    count = round(SECONDS / STEP)
    starts = np.cumsum(rng.uniform(*BETWEEN, round(SECONDS / BETWEEN[0])))
    force = np.zeros((count, 2))
    for start in starts[starts < SECONDS]:
        angle, size = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(*KNUCKLE)
        blow = half_sines(STEP, count, [start], [size], CONTACT)
        force += np.outer(blow, [np.cos(angle), np.sin(angle)])
    still = machine.at(visit)
    head = still.rows(["p_x", "p_y"])
    motion = responses(still, STEP, force, head, head)
    return record(chip, STEP, np.column_stack([motion, np.zeros(count)]), rng)


def write_rows(path: Path, recording: Recording, rate: float) -> None:
    """Write what ``M956 X Y`` writes: rows of g without times, and the rate in the last line."""
    rows = (f"{i},{a[0]:.3f},{a[1]:.3f}" for i, a in enumerate(recording.accelerations / GRAVITY))
    lines = ["Sample,X,Y", *rows, f"Rate {round(rate)}, overflows 0"]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write(folder: Path) -> None:
    """Write the recordings, two at each place, for the robot file in the folder."""
    rng = np.random.default_rng(SEED)
    document = tomllib.loads((folder / "robot.toml").read_text(encoding="utf-8"))
    machine = printer(robot_from_document(document, "robot.toml").parameters, EFFECTS)
    chip = Chip(NOMINAL * (1.0 + rng.uniform(-OFF, OFF)), NOISE, DIGIT)
    visits = Wander(approach=0.001).visits(machine, np.array(list(POSES.values())), REPEATS, rng)
    for label, repeats in zip(POSES, visits, strict=True):
        for number, visit in enumerate(repeats, start=1):
            path = folder / f"{label.replace(' ', '_')}_{number}.csv"
            write_rows(path, tapped(machine, visit, chip, rng), chip.rate)


def main() -> None:
    """Write the measurements of the example."""
    parser = argparse.ArgumentParser(description="Write the measurements of a printer that is tapped.")
    parser.add_argument("folder", type=Path, help="has robot.toml")
    write(parser.parse_args().folder)


if __name__ == "__main__":
    main()
