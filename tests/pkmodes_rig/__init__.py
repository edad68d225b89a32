"""The virtual test rig: robots measured in a simulated laboratory that shares no code with the model."""

from __future__ import annotations

from pkmodes_rig.corexy import corexy
from pkmodes_rig.engine import TrueModes, true_modes
from pkmodes_rig.laboratory import SENSORS, Laboratory
from pkmodes_rig.measurements import (
    BASE_RIGID,
    Identified,
    drives_of,
    exact,
    held_at,
    identified,
    measure_modes,
    written,
)
from pkmodes_rig.mistakes import ASKEW, MISTAKES, ORDERS, followed, joined, mistaken, parsed
from pkmodes_rig.robots import POSES, ROBOTS, drawn_values, read
from pkmodes_rig.rotary_delta import rotary_delta
from pkmodes_rig.six_legged import hexaglide, hexapod
from pkmodes_rig.storeys import channels, storey_modes

__all__ = [
    "ASKEW",
    "BASE_RIGID",
    "MISTAKES",
    "ORDERS",
    "POSES",
    "ROBOTS",
    "SENSORS",
    "Identified",
    "Laboratory",
    "TrueModes",
    "channels",
    "corexy",
    "drawn_values",
    "drives_of",
    "exact",
    "followed",
    "held_at",
    "hexaglide",
    "hexapod",
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
