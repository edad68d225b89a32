"""Standard deviations of the declared frequencies at the places of measurement, against differences."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import pkmodes
from pkmodes import updating
from pkmodes.loop.updating.declared_spread import declared_spread

PRINTER = "robots/corexy-printer.toml"


def test_a_setup_has_the_motors_and_known_values_that_it_states(tmp_path: Path) -> None:
    """The second setup weighed the tool head: its sigma no longer counts.  The third held the motors."""
    file = tmp_path / "measured.csv"
    file.write_text(
        "pose,x,y,frequency,sigma,set:toolhead.mass,drives\n"
        "A,0.1,0.15,106,0.2,0.5,free\nB,0.2,0.1,107,0.2,0.6,free\nC,0.1,0.15,61,0.2,0.5,held\n",
        encoding="utf-8",
    )
    robot = pkmodes.read_robot(PRINTER)
    found = declared_spread(robot, updating.read(file, robot=robot))
    assert found is not None
    assert found.shape == (3, 2)
    cases = [([0.1, 0.15], "free", 0.5), ([0.2, 0.1], "free", 0.6), ([0.1, 0.15], "held", 0.5)]
    for row, (pose, drives, mass) in zip(found, cases, strict=True):
        squares = np.zeros(2)
        for path in ("gantry.mass", "belt.specific_stiffness"):
            quantity = robot.quantities[path]
            assert quantity.sigma
            h = 1e-3 * quantity.sigma
            robots = (robot.with_values({"toolhead.mass": mass, path: quantity.value + d}) for d in (h, -h))
            up, down = (pkmodes.Model(one).frequencies(pose, drives=drives)[-2:] for one in robots)
            squares += (quantity.sigma * (up - down) / (2.0 * h)) ** 2
        np.testing.assert_allclose(row, np.sqrt(squares), rtol=1e-5)


def test_without_standard_deviations_there_is_none() -> None:
    robot = pkmodes.read_robot("robots/linear-delta-2022.toml")
    data = updating.read("examples/closed_loop/measured.csv", robot=robot)
    assert declared_spread(robot, data) is None
