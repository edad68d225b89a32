"""The virtual test rig of the tests, for scripts that run without pytest."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests"))

from rig_engine import TrueModes, true_modes
from rig_laboratory import SENSORS, Laboratory
from rig_measurements import BASE_RIGID, Identified, exact, identified, measure_modes, written
from rig_mechanisms import corexy
from rig_mistakes import MISTAKES, joined, mistaken, parsed
from rig_robots import POSES, ROBOTS, read
from rig_rotary_delta import rotary_delta
from rig_storeys import channels, storey_modes

__all__ = [
    "BASE_RIGID",
    "MISTAKES",
    "POSES",
    "ROBOTS",
    "SENSORS",
    "Identified",
    "Laboratory",
    "TrueModes",
    "channels",
    "corexy",
    "exact",
    "identified",
    "joined",
    "measure_modes",
    "mistaken",
    "parsed",
    "read",
    "rotary_delta",
    "storey_modes",
    "true_modes",
    "written",
]
