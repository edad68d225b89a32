"""The former name of `pkmodes.updating`, kept for scripts that use it."""

import warnings

from pkmodes.updating import compare, diagnose, read, save_robot, update

__all__ = ["compare", "diagnose", "read", "save_robot", "update"]

warnings.warn("pkmodes.closing is now pkmodes.updating", DeprecationWarning, stacklevel=2)
