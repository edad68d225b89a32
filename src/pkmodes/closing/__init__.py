"""The loop closed for a robot: compare with measured modes, diagnose, and save the corrected robot file."""

from pkmodes.closing.loop import compare, diagnose, read, save_robot, update

__all__ = ["compare", "diagnose", "read", "save_robot", "update"]
