"""``pkmodes modes``: standard deviations of the frequencies, where the robot file states any."""

from __future__ import annotations

import numpy as np

import pkmodes
from helpers.commands.answers import printed

POSE = ("--pose", "0.1,0.15", "--drives", "held")


def test_they_are_below_the_frequencies() -> None:
    """Against differences of the frequencies with respect to the three values with a sigma."""
    robot = "robots/corexy-printer.toml"
    model = pkmodes.load(robot)
    squares = np.zeros(2)
    for path, quantity in model.robot.quantities.items():
        if quantity.sigma:
            h = 1e-3 * quantity.sigma
            up, down = (
                model.with_values({path: quantity.value + step}).frequencies([0.1, 0.15], drives="held")
                for step in (h, -h)
            )
            squares += (quantity.sigma * (up - down) / (2.0 * h)) ** 2
    lines = printed("modes", robot, *POSE).splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("f [Hz]"))
    assert lines[at + 1].split() == ["+-", "[Hz]", *(f"{sigma:.2g}" for sigma in np.sqrt(squares))]


def test_rigid_modes_have_none() -> None:
    lines = printed("modes", "robots/corexy-printer.toml", "--pose", "0.1,0.15").splitlines()
    (row,) = (line for line in lines if line.startswith("+- [Hz]"))
    assert len(row.split()) == 4, "two of the four modes are rigid"
    (meaning,) = (line for line in lines if line.startswith("+-: "))
    assert "standard deviation" in meaning


def test_without_any_nothing_changes() -> None:
    robot = ("robots/linear-delta-2022.toml", "--pose", "0.6,0,-0.245")
    assert "+-" not in printed("modes", *robot)
