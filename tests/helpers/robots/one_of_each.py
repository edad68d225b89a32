"""A supplied robot of each mechanism, and a pose without symmetry."""

from __future__ import annotations

from pathlib import Path

import numpy as np

ROBOTS = Path(__file__).resolve().parents[3] / "robots"
FILES = {
    "linear_delta": "linear-delta-2022-identified.toml",
    "rotary_delta": "clavel-delta.toml",
    "corexy": "corexy-printer.toml",
}
POSES = {
    "linear_delta": np.array([0.55, 0.06, -0.26]),
    "rotary_delta": np.array([0.1, 0.05, -0.5]),
    "corexy": np.array([0.1, 0.05]),
}
