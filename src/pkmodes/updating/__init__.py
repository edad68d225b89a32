"""Model updating of a robot: compare with measured modes, diagnose, update, and save the corrected robot file."""

from pkmodes.updating.loop import compare, diagnose, read, save_robot, update

__all__ = ["compare", "diagnose", "read", "save_robot", "update"]
