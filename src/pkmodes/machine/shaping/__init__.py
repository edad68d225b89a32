"""Input shapers: commands split into a few delayed parts, so that the vibrations they excite cancel.

`shaper` designs one for a mode, or one for each mode of a batch; `residual` says how much vibration a shaper leaves;
`measured_shapers` compares them for measured modes.
"""

from pkmodes.machine.shaping.kinds import KINDS
from pkmodes.machine.shaping.measured_modes import measured_shapers
from pkmodes.machine.shaping.residual_vibration import residual
from pkmodes.machine.shaping.shapers import Shaper, shaper

__all__ = ["KINDS", "Shaper", "measured_shapers", "residual", "shaper"]
