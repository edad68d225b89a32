"""Tests with motors free, held, or each at every second pose: the cases of a suite in all three."""

from __future__ import annotations

from collections.abc import Iterable

#: What the motors do in a test: the same at all poses, or held at every second one.
DRIVES = ("free", "held", "mixed")
#: Causes at the motors.  Held motors do not move, so a test in which they are held shows nothing of these.
AT_MOTORS = ("gearbox_inertia", "servo_stiffness", "one_servo")
#: The edit of a file after which it says that motors were free where they were held, or held if they were free.
OTHER_DRIVES = "other drives"


def shows(drives: str, kinds: Iterable[str]) -> bool:
    """Return whether a test with these drives shows something of all these causes or wrong values."""
    return drives != "held" or not any(kind in AT_MOTORS or "motor." in kind for kind in kinds)


def words(drives: str) -> str:
    """Return what labels and titles add to say what the motors do; nothing for free ones."""
    return "" if drives == "free" else f", motors {drives}"
