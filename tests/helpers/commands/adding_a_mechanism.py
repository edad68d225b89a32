"""What docs/how-to/adding-a-mechanism.md shows: its files, and measured modes of the machine that it tells of."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from helpers.references.five_bar_by_hand import FiveBar

PAGE = (Path(__file__).parents[3] / "docs" / "how-to/adding-a-mechanism.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w*)\n(.*?)```", PAGE, re.S)
DEFINITION, MEASURING, IN_PYTHON = (
    text for language, text in BLOCKS if language == "python" and "import" in text
)
ROBOT, _ = (text for language, text in BLOCKS if language == "toml")
SHOWN = [text for _, text in BLOCKS if text.startswith("pick-and-place")]
COMMANDS = [line.split()[1:] for line in PAGE.splitlines() if line.startswith("pkmodes ")]
#: Where its commands evaluate the robot.
POSE = np.array([0.03, -0.42])
#: The robot of the page, by hand.
DECLARED = FiveBar(
    tool=0.3,
    gravity=np.array([0.0, -9.81]),
    origins=np.array([[-0.08, 0.0], [0.08, 0.0]]),
    branches=(-1, 1),
    arm_length=0.22,
    arm_mass=0.25,
    link_length=0.33,
    link_mass=0.12,
    stiffness=(900.0, 900.0),
    inertia=0.02,
)
POSES = [(x, y) for y in (-0.45, -0.38, -0.3) for x in (-0.12, -0.04, 0.04, 0.12)]


def measured(machine: FiveBar, seed: int = 1) -> str:
    """Both vibration modes at twelve poses, with 0.2 % of noise, shapes with 1 %."""
    rng = np.random.default_rng(seed)
    rows = ["pose,x,y,frequency,sigma,shape:theta_1,shape:theta_2,shape:phi_1,shape:phi_2"]
    for number, (x, y) in enumerate(POSES, start=1):
        frequencies, shapes = machine.modes(np.array([x, y]))
        for f, shape in zip(frequencies[2:], shapes[2:], strict=True):
            noisy = f * (1.0 + 2e-3 * rng.standard_normal())
            seen = shape / np.abs(shape).max() + 0.01 * rng.standard_normal(4)
            rows.append(f"P{number},{x},{y},{noisy:.5g},{2e-3 * f:.3g},{','.join(f'{v:.4f}' for v in seen)}")
    return "\n".join(rows) + "\n"
