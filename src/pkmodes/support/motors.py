"""What the motors of a robot do, in words: the title of everything that depends on it."""

from __future__ import annotations

from collections.abc import Iterable

from pkmodes.core.base.drives import FREE, motors
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot.declaration import Declaration

#: What the unit of a torsional stiffness ends with.
PER_ANGLE = "/rad"


def motors_in_words(robot: Declaration, drives: str | Iterable[str | None]) -> str:
    """Return what the motors of a robot do, as words: motors free, held, or on their servo stiffness.

    Parameters
    ----------
    drives : {"free", "held"}, or several
        As for `pkmodes.Model.modes`.  A machine that is switched on has free motors with the effect of its position
        loop; they turn against it.
    """
    words = motors([drives] if isinstance(drives, str) else drives)
    active = {path.partition(".")[0] for path, value in robot.effects.items() if value}
    for name in _holding(robot.mechanism):
        if name in active:
            return words.replace(FREE, f"on their {name.replace('_', ' ')}")
    return words


def _holding(mechanism: Mechanism) -> list[str]:
    """Return the effects that hold the motors like springs: torsional ones to ground."""
    return [
        name
        for name, effect in mechanism.effects.items()
        if effect.grounds and all(parameter.unit.endswith(PER_ANGLE) for parameter in effect.parameters)
    ]


def motors_of_both(first: Declaration, second: Declaration, drives: str) -> str:
    """Return what the motors of two robots do, each of them named where they differ."""
    ours, theirs = motors_in_words(first, drives), motors_in_words(second, drives)
    return ours if ours == theirs else f"{ours} (first) and {theirs.removeprefix('motors ')} (second)"
