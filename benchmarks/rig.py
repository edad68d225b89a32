"""The virtual test rig of the tests, for scripts that run without pytest."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests"))

from rig_engine import TrueModes, true_modes
from rig_measurements import BASE_RIGID, measure_modes
from rig_robots import POSES, ROBOTS, read

__all__ = ["BASE_RIGID", "POSES", "ROBOTS", "TrueModes", "measure_modes", "read", "true_modes"]
