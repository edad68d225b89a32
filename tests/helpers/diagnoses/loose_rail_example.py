"""The machine behind examples/loose_rail: what its robot file declares, what it really is, and its measurement.

    python tests/helpers/diagnoses/loose_rail_example.py

writes the two files of the example from the virtual test rig (MuJoCo).  What holds carriage 2 yields sideways, as
where the screws of a rail are loose; no effect of the catalogue has that.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from helpers.diagnoses import closed_loop_example
from pkmodes_rig import identified, written
from pkmodes_rig.one_place import Fault, modes_of
from pkmodes_rig.robots import POSES, read

FOLDER = Path(__file__).resolve().parents[3] / "examples" / "loose_rail"
TERM, COMPLIANCE = "mount:carriage_2.y", 8.0e-7  # m/N
ERRORS = {"platform_mass": 0.995, "belt_specific_stiffness": 1.012, "motor_inertia": 1.01}
SHAPES = ("x_1", "x_2", "x_3", "p_x", "p_y", "p_z")
SEED = 2026


def robot_text() -> str:
    """Robot file as its owner would write it."""
    text = closed_loop_example.robot_text().split("format = 1", 1)[1]
    return (
        "# The published linear delta in its second year: the file declares it as it was built.\n"
        "# One thing at one place has changed since: docs/how-to/an-effect-of-your-own.md finds it.\n\nformat = 1"
        + text.replace('name = "workshop-delta"', 'name = "worn-delta"')
    )


def measured_text() -> str:
    """Ten poses, seven modes, 0.15 % noise, a tenth of the modes missing."""
    declared = read("published").parameters
    real = declared._replace(**{name: getattr(declared, name) * factor for name, factor in ERRORS.items()})
    fault = Fault("mount", ("carriage_2",), "y", {"compliance": COMPLIANCE})
    points = POSES["published"]["scattered"][:10]
    modes = [modes_of("linear_delta", real, p, [fault], frame=50.0) for p in points]
    rows = identified(
        modes,
        rng=np.random.default_rng(SEED),
        base_rigid=3,
        lever=0.0,
        sigma=0.0015,
        modes=(99, 99),
        shapes=SHAPES,
        band=(5.0, 200.0),
        shape_noise=0.02,
        sensors=SHAPES,
        missing=0.1,
    )
    text = written(rows, list(points), SHAPES, drives=["free"] * len(modes))
    return (
        "# Modes of the worn delta: virtual test rig, tests/helpers/diagnoses/loose_rail_example.py\n" + text
    )


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / "robot.toml").write_text(robot_text(), encoding="utf-8")
    (FOLDER / "measured.csv").write_text(measured_text(), encoding="utf-8")
    sys.stdout.write(f"wrote {FOLDER.name}/robot.toml and {FOLDER.name}/measured.csv\n")
