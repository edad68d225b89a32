"""What the motors of a robot do, in words: the title of everything that depends on it."""

from __future__ import annotations

from collections.abc import Iterable

from pkmodes.base.drives import FREE, motors
from pkmodes.robot.declaration import Declaration

#: The effect by which position loops or stepper motors hold the motors like springs; no motor is free with it.
SERVO = "servo_stiffness"


def motors_in_words(robot: Declaration, drives: str | Iterable[str | None]) -> str:
    """Return what the motors of a robot do, as words: motors free, held, or on their servo stiffness.

    Parameters
    ----------
    drives : {"free", "held"}, or several
        As for `pkmodes.Model.modes`.  A machine that is switched on has free motors with the effect of its position
        loop; they turn against it.
    """
    words = motors([drives] if isinstance(drives, str) else drives)
    stiff = any(value and path.partition(".")[0] == SERVO for path, value in robot.effects.items())
    return words.replace(FREE, "on their servo stiffness") if stiff else words


def motors_of_both(first: Declaration, second: Declaration, drives: str) -> str:
    """Return what the motors of two robots do, each of them named where they differ."""
    ours, theirs = motors_in_words(first, drives), motors_in_words(second, drives)
    return ours if ours == theirs else f"{ours} (first) and {theirs.removeprefix('motors ')} (second)"
