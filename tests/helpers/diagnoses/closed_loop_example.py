"""The machine behind examples/closed_loop: what its robot file declares, what it really is, and its measurement.

    python tests/helpers/diagnoses/closed_loop_example.py

writes the two files of the example from the virtual test rig (MuJoCo).  The gearboxes wind up, which the file does
not declare, and the three values that it calls uncertain are off by about their uncertainty.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from pkmodes_rig.measurements import measure
from pkmodes_rig.robots import POSES, ROBOTS, read

FOLDER = Path(__file__).resolve().parents[3] / "examples" / "closed_loop"
COMPLIANCE = 2.0e-4  # rad/(N m), of every gearbox
ERRORS = {"platform_mass": 1.006, "belt_specific_stiffness": 1.013, "motor_inertia": 0.985}
SEED = 2022


def robot_text() -> str:
    """Robot file as its owner would write it."""
    text = ROBOTS["published"].split("format = 1", 1)[1]
    return (
        "# The published linear delta as a test engineer would declare it: three values have an uncertainty.\n"
        "# Its gearboxes are compliant, which the file does not declare: run `make demo`.\n\nformat = 1"
        + text.replace('name = "linear-delta-2022"', 'name = "workshop-delta"')
    )


def measured_text() -> str:
    """Nine poses, six modes, 0.2 % noise, a tenth of the modes missing."""
    declared = read("published").parameters
    real = declared._replace(**{name: getattr(declared, name) * factor for name, factor in ERRORS.items()})
    text = measure(
        real,
        POSES["published"]["scattered"][:9],
        effects={"gearbox_compliance.compliance": COMPLIANCE},
        rng=np.random.default_rng(SEED),
        missing=0.1,
        shapes=("x_1", "x_2", "x_3", "p_x", "p_y", "p_z"),
    )
    return (
        "# Modes of the workshop delta: virtual test rig, tests/helpers/diagnoses/closed_loop_example.py\n"
        + text
    )


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / "robot.toml").write_text(robot_text(), encoding="utf-8")
    (FOLDER / "measured.csv").write_text(measured_text(), encoding="utf-8")
    sys.stdout.write(f"wrote {FOLDER.name}/robot.toml and {FOLDER.name}/measured.csv\n")
