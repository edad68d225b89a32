"""What the motors do: they turn freely, or position loops far stiffer than the machine hold them."""

from __future__ import annotations

from pkmodes.base.errors import PkmodesError, shown

FREE, HELD = DRIVES = "free", "held"


def checked_drives(drives: object) -> str:
    """Check what the caller says of the motors.

    Raises
    ------
    PkmodesError
        If it is neither "free" nor "held".
    """
    if isinstance(drives, str) and drives in DRIVES:
        return drives
    what = f'expected "{FREE}" or "{HELD}", found {shown(drives)}'
    raise PkmodesError(what, "drives", "say whether the motors turn freely or a position loop holds them")
