"""The campaign of examples/roving_hammer: a hammer roves over a linear delta in front of one accelerometer, in time.

    python -m pkmodes_rig.signals.roving_hammer examples/roving_hammer

The machine stands on a frame that moves, which its robot file does not declare.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from pkmodes_rig.robots import POSES
from pkmodes_rig.signals import universal
from pkmodes_rig.signals.example import machine, robot_text
from pkmodes_rig.signals.modal_tests import RATE, ModalTest, recorded
from pkmodes_rig.signals.sensors import Room, Sensor
from pkmodes_rig.signals.visits import Wander

SEED = 31
#: What the robot file does not say [m/N].
EFFECTS = {"frame_compliance.compliance": 5e-8}
NAME = "roving-delta"
POSITIONS = np.round(np.array(POSES["published"]["scattered"][:4]), 3)
#: Where the hammer hits, against each direction: node and direction in the files.
POINTS = {
    "x_1": (1, -1),
    "x_2": (2, -1),
    "x_3": (3, -1),
    "p_x": (4, -1),
    "p_y": (4, -2),
    "p_z": (4, -3),
}
#: The accelerometer, glued askew to the platform so that it feels every mode; node and direction.
FIXED, FIXED_AT = Sensor("p_x", 1.003, {"p_y": 0.8, "p_z": 0.7}), (9, 3)
#: Largest force [N], length of a record [s], and blows in each.
SIZE, SECONDS, HITS = 40.0, 1.0, 2


def write(folder: Path) -> None:
    """Write the robot file and a file for each point at each pose."""
    rng = np.random.default_rng(SEED)
    (folder / "robot.toml").write_text(robot_text(NAME), encoding="utf-8")
    real, room = machine(EFFECTS), Room(2e-6, hum=0.02)
    for i, (visit,) in enumerate(Wander(approach=0.001, warming=0.0005).visits(real, POSITIONS, 1, rng)):
        still = real.at(visit)
        for point, place in POINTS.items():
            test = ModalTest("impact", (FIXED,), room, ({point: -1.0},), SIZE, SECONDS, hits=HITS)
            blows = recorded(test, {(i, 0): still}, rng)[i, 0]
            assert blows.force is not None
            assert blows.motion is not None
            _write(folder / f"P{i + 1}_{point}.uff", place, blows.force, blows.motion[:, 0])


def _write(path: Path, place: universal.Dof, force: np.ndarray, motion: np.ndarray) -> None:
    at, step = (0, 0), 1.0 / RATE
    signals = (
        universal.dataset(universal.TIME, place, place, 0.0, step, force, universal.FORCE, "N"),
        universal.dataset(universal.TIME, FIXED_AT, at, 0.0, step, motion),
    )
    path.write_bytes(b"".join(signals))


def main() -> None:
    """Write the measurements of the example."""
    parser = argparse.ArgumentParser(description="Write the measurements of a roving hammer.")
    parser.add_argument("folder", type=Path)
    write(parser.parse_args().folder)


if __name__ == "__main__":
    main()
