"""Input shapers: commands split into a few delayed parts, so that the vibrations they excite cancel.

`shaper` designs one for a mode, or one for each mode of a batch; `residual` says how much vibration a shaper leaves.
"""

from pkmodes.shaping.kinds import KINDS
from pkmodes.shaping.residual_vibration import residual
from pkmodes.shaping.shapers import Shaper, shaper

__all__ = ["KINDS", "Shaper", "residual", "shaper"]
