"""The campaign of examples/campaign: a linear delta whose motors are on, tapped and shaken at six poses.

    python -m pkmodes_rig.signals.example examples/campaign

Its linkages stretch, which its robot file does not declare.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from pkmodes_rig.engine import true_modes
from pkmodes_rig.robots import POSES, ROBOTS, read
from pkmodes_rig.signals.campaigns import Made, Paper, make
from pkmodes_rig.signals.modal_tests import Flaws, ModalTest
from pkmodes_rig.signals.sensors import Room, Sensor
from pkmodes_rig.signals.small_motion import Losses
from pkmodes_rig.signals.visits import Machine, Wander

SEED = 24
#: The state of the motors follows the mechanism in the robot file.
MECHANISM_LINE = 'mechanism = "linear_delta"\n'
HELD_LINE = (
    'drives = "held"                     # as in use and in the tests: the controller holds the motors\n'
)
#: What the robot file does not say: how much each linkage stretches [m/N].
EFFECTS = {"link_compliance.compliance": 4e-7}
#: True over declared values.
ERRORS = {"platform_mass": 0.994, "belt_specific_stiffness": 1.012, "motor_inertia": 1.01}
RAILS = ("x_1", "x_2", "x_3")
CHANNELS = (*RAILS, "p_x", "p_y", "p_z")
REPEATS = 3


def machine(effects: Mapping[str, float] = EFFECTS) -> Machine:
    """Return the machine as it is, which has more than the robot file says."""
    declared = read("published").parameters
    real = declared._replace(**{name: getattr(declared, name) * factor for name, factor in ERRORS.items()})
    losses = Losses(0.004, dict.fromkeys(RAILS, 3.0), factor=0.006)
    return Machine(true_modes, real, effects, losses=losses, held=True)


def robot_text(name: str = "tapped-delta") -> str:
    """Return the robot file as its owner would write it, with the name of the robot."""
    text = ROBOTS["published"].split("format = 1", 1)[1]
    return (
        "# The published linear delta as a test engineer would declare it: four values have an uncertainty.\n"
        "# Something in it is more compliant than this file says, and something rubs: README.md.\n\nformat = 1"
        + text.replace('name = "linear-delta-2022"', f'name = "{name}"').replace(
            MECHANISM_LINE, MECHANISM_LINE + HELD_LINE
        )
        + '\n[damping]                    # of bolted joints, roughly\nratio = { value = "0.5 %", sigma = "50 %" }\n'
    )


def write(folder: Path) -> Made:
    """Write the robot file, the campaign file and the files of signals."""
    rng = np.random.default_rng(SEED)
    sensors = tuple(Sensor(name, gain=1.0 + 0.003 * rng.standard_normal()) for name in CHANNELS)
    room = Room(2e-6, hum=0.02)
    hammer = {"p_x": 0.6, "p_y": 0.5, "p_z": -0.624}
    # One blow of the second pose bounced.
    tapped = ModalTest("impact", sensors, room, (hammer,), 40.0, 3.0, flaws=Flaws(frozenset({(1, 2)})))
    shaken = replace(tapped, kind="frf", size=2.0, seconds=4.0, averages=5, flaws=Flaws())
    poses = np.array(POSES["published"]["scattered"][:6])
    return make(
        folder,
        machine(),
        robot_text(),
        np.round(poses, 3),
        REPEATS,
        Wander(approach=0.001, warming=0.0005),
        [tapped] * 4 + [shaken] * 2,
        Paper((15.0, 180.0), ("x", "y", "z"), "held", tones=(50.0,), force=tuple(hammer.values())),
        rng,
    )


def main() -> None:
    """Write the folder of the example."""
    parser = argparse.ArgumentParser(description="Write the stored campaign of the examples.")
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    folder.mkdir(exist_ok=True)
    write(folder)


if __name__ == "__main__":
    main()
