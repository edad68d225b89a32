"""Model updating of a robot: compare with measured modes, diagnose, update, and save the corrected robot file."""

from pkmodes.loop.updating.analyses import compare, diagnose, update
from pkmodes.loop.updating.changes import changed
from pkmodes.loop.updating.corrected_robot import save_robot
from pkmodes.loop.updating.reading import read
from pkmodes.loop.updating.saved_term import save_effect

__all__ = ["changed", "compare", "diagnose", "read", "save_effect", "save_robot", "update"]
