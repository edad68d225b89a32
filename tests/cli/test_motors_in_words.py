"""What the motors do, in words: those of a machine that is switched on are not free."""

from __future__ import annotations

import pytest

import pkmodes
from helpers.robots.one_of_each import EVERY, ROBOTS
from pkmodes.core.support.motors import drives_in_use, motors_in_words, motors_of_both


@pytest.mark.parametrize("name", list(EVERY.values()))
def test_motors_with_a_position_loop_are_not_called_free(name: str) -> None:
    """Not even in the title of measurements, of which some were made with motors held."""
    off = pkmodes.read_robot(ROBOTS / name)
    on = off.with_values({"effects.servo_stiffness.stiffness": 15.0})
    zero = off.with_values({"effects.servo_stiffness.stiffness": 0.0})
    assert motors_in_words(off, "free") == motors_in_words(zero, "free") == "motors free"
    assert motors_in_words(on, "free") == "motors on their servo stiffness"
    assert motors_in_words(on, "held") == motors_in_words(off, "held") == "motors held"
    assert motors_in_words(on, ["free", "held", "free"]) == "motors on their servo stiffness or held"
    assert motors_of_both(off, zero, "free") == "motors free"
    assert motors_of_both(off, on, "free") == "motors free (first) and on their servo stiffness (second)"
    assert motors_of_both(off, on, "held") == "motors held"
    assert [drives_in_use(robot) for robot in (off, zero, on)] == ["held", "held", "free"]
    assert [drives_in_use(on, drives) for drives in ("free", "held")] == ["free", "held"]


@pytest.mark.parametrize("name", list(EVERY.values()))
def test_neither_a_cable_nor_an_inertia_holds_a_motor(name: str) -> None:
    """A cable ties the platform to ground beside the drives, and an inertia is no spring."""
    off = pkmodes.read_robot(ROBOTS / name)
    values = {"effects.cable_stiffness.stiffness": 200.0, "effects.gearbox_inertia.inertia": 1e-5}
    for path, value in values.items():
        if path.split(".")[1] in off.mechanism.effects:
            more = off.with_values({path: value})
            assert motors_in_words(more, "free") == "motors free"
            assert drives_in_use(more) == "held"
