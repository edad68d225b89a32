"""Former name of `pkmodes.updating`, kept for existing scripts."""

import warnings

from pkmodes.updating import compare, diagnose, read, save_robot, update

__all__ = ["compare", "diagnose", "read", "save_robot", "update"]

warnings.warn("pkmodes.closing is now pkmodes.updating", DeprecationWarning, stacklevel=2)
