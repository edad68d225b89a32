"""Model updating of a robot: compare with measured modes, diagnose, update, and save the corrected robot file."""

from pkmodes.updating.analyses import compare, diagnose, update
from pkmodes.updating.changes import changed
from pkmodes.updating.corrected_robot import save_robot
from pkmodes.updating.reading import read
from pkmodes.updating.saved_term import save_effect

__all__ = ["changed", "compare", "diagnose", "read", "save_effect", "save_robot", "update"]
