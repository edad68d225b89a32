"""Dotted paths of values in words, from the description of the mechanism."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.robots.one_of_each import EVERY
from pkmodes import read_robot
from pkmodes.core.support.words import meaning_of
from pkmodes.loop.sensitivity.paths import paths

ROBOTS = Path(__file__).parents[3] / "robots"


@pytest.mark.parametrize(
    ("robot", "path", "words"),
    [
        ("linear-delta-2022", "link.length", "length of each linkage"),
        ("linear-delta-2022", "axis.2.link.length", "length of linkage 2"),
        ("linear-delta-2022", "axis.1.origin.z", "point of rail 1 where x_1 = 0 (z)"),
        ("linear-delta-2022", "belt.specific_stiffness", "specific stiffness of each belt"),
        ("linear-delta-2022", "axis.joint_radius", "distance of the platform joints from the centre"),
        (
            "linear-delta-2022",
            "effects.gearbox_compliance.compliance",
            "compliance of every gearbox, output side",
        ),
        ("linear-delta-2022", "gearbox_compliance.compliance", "compliance of every gearbox, output side"),
        ("linear-delta-2022", "axis.2.limits.max", "max(x_2)"),
        ("linear-delta-2022", "damping.ratio", "damping ratio of every mode"),
        ("linear-delta-2022", "measurement.yaw", ""),
        ("linear-delta-2022", "colour", ""),
        ("corexy-printer", "pulley.radius", "radius of each motor pulley"),
        (
            "corexy-printer",
            "belt_path.2.lengths.1",
            "free length of run 1 of belt 2 with the tool head at x = y = 0",
        ),
    ],
)
def test_the_words_of_a_path(robot: str, path: str, words: str) -> None:
    assert meaning_of(read_robot(ROBOTS / f"{robot}.toml").mechanism, path) == words


@pytest.mark.parametrize("robot", EVERY.values())
def test_every_path_of_a_robot_has_words_of_its_own(robot: str) -> None:
    declared = read_robot(ROBOTS / robot)
    words = {path: meaning_of(declared.mechanism, path) for path in paths(declared)}
    assert all(words.values())
    assert len(set(words.values())) == len(words)
    assert not any(" j" in f" {text} ".replace(" joint", "") or "_j" in text for text in words.values())
