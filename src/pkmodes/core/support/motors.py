"""What the motors of a robot do: by default in use, and in words, the title of everything that depends on it."""

from __future__ import annotations

from collections.abc import Iterable

from pkmodes.core.base.drives import FREE, HELD, checked_drives, motors_text
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.declaration import Declaration
from pkmodes.core.system.motors import motor_springs_among, springs_on_motors


def motors_in_words(
    robot: Declaration, drives: str | Iterable[str | None], causes: Iterable[str] = ()
) -> str:
    """Return what the motors of a robot do, in words: motors free, held, or on their servo stiffness.

    - drives: as for `pkmodes.Model.modes`.  A machine that is switched on has free motors with the effect of its
      position loop; they turn against it.
    - causes: effects that the robot has beside those of its file
    """
    words = motors_text([drives] if isinstance(drives, str) else drives)
    mechanism = robot.mechanism
    for name in (*springs_on_motors(mechanism, robot.effects), *motor_springs_among(mechanism, causes)):
        return words.replace(FREE, f"on their {name.replace('_', ' ')}")
    return words


def motors_give_way(robot: Declaration) -> bool:
    """Return whether a robot file has its motors on springs, such as a servo stiffness."""
    return bool(springs_on_motors(robot.mechanism, robot.effects))


def drives_in_use(robot: Declaration, drives: str | None = None) -> str:
    """Return what the motors do in a machine that follows commands: as requested, else as the robot file has them.

    - drives: "free" or "held"; by default motors that give way turn against their springs, "free", and others are
      held

    Raises PkmodesError if it is neither word, or motors that nothing holds are to be free: they follow no command.
    """
    if drives is None:
        return FREE if motors_give_way(robot) else HELD
    if checked_drives(drives) == FREE and not motors_give_way(robot):
        problem = (
            "motors that turn freely follow no command, and the robot file has no spring that holds them"
        )
        remedy = 'take drives="held", or give the stiffness of the motors as [effects.servo_stiffness]'
        raise PkmodesError(problem, "drives", remedy)
    return drives


def motors_of_both(first: Declaration, second: Declaration, drives: str) -> str:
    """Return what the motors of two robots do, each of them named where they differ."""
    first_motors, second_motors = motors_in_words(first, drives), motors_in_words(second, drives)
    return (
        first_motors
        if first_motors == second_motors
        else f"{first_motors} (first) and {second_motors.removeprefix('motors ')} (second)"
    )
