"""Every value of every robot, replaced: the robot is that of the whole document, or refused with its problems."""

from __future__ import annotations

import contextlib
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.robot_text import PUBLISHED
from helpers.robots.same_robots import same_to_the_last_digit
from pkmodes.core.base.errors import RobotFileError
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.robot.layout import items_by_path, table_sources
from pkmodes.core.robot.parameter_groups import group_value, groups_by_path
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.core.robot.units import Quantity
from pkmodes.core.robot.variants import SOURCE_SUFFIX, document_of, raw_values

ROBOTS = sorted(PUBLISHED.parent.glob("*.toml"))


def document_of_robot(robot: pkmodes.Robot) -> dict[str, object]:
    """The document that declares a robot."""
    return document_of(
        robot.mechanism,
        robot.name,
        raw_values(robot),
        robot.usable,
        robot.report,
        robot.covariance,
        robot.drives,
    )


def with_effects(robot: pkmodes.Robot) -> pkmodes.Robot:
    """The robot with a small value of the first parameter of every effect that it can have with the others."""
    for effect in robot.mechanism.effects.values():
        with contextlib.suppress(RobotFileError):
            robot = robot.with_values({f"effects.{effect.name}.{effect.parameters[0].name}": 1e-6})
    return robot


def document_with(robot: pkmodes.Robot, path: str, raw: object) -> dict[str, object]:
    """The document of a robot whose file gives another value at a path."""
    declared, item = raw_values(robot), items_by_path(robot.mechanism).get(path)
    if item is not None and path != item.path:  # elements that the file does not give have their default
        declared = {number.path: item.key.default for number in item.numbers} | declared
    return document_of(
        robot.mechanism,
        robot.name,
        {**declared, path: raw},
        robot.usable,
        robot.report,
        robot.covariance,
        robot.drives,
    )


def change(robot: pkmodes.Robot, path: str, raw: object) -> pkmodes.Robot | list[tuple[str, ...]]:
    """The robot with a value, or the problems for which it is refused."""
    try:
        return robot.with_values({path: raw})
    except RobotFileError as error:
        return [(problem.what, problem.where, problem.remedy) for problem in error.problems]


def read_again(robot: pkmodes.Robot, path: str, raw: object) -> pkmodes.Robot | list[tuple[str, ...]]:
    """The robot of the whole document with that value, or the problems for which it is refused."""
    try:
        return robot_from_document(
            document_with(robot, path, raw), f"{robot.source.removesuffix(SOURCE_SUFFIX)}{SOURCE_SUFFIX}"
        )
    except RobotFileError as error:
        return [(problem.what, problem.where, problem.remedy) for problem in error.problems]


@pytest.mark.parametrize("declared", ["the file", "effects"])
@pytest.mark.parametrize("path", ROBOTS, ids=lambda path: path.stem)
def test_other_values_are_those_of_the_whole_document(path: Path, declared: str) -> None:
    robot = pkmodes.read_robot(path)
    robot = with_effects(robot) if declared == "effects" else robot
    same_to_the_last_digit(robot.with_values({}), robot_from_document(document_of_robot(robot), ""))
    lent_paths, wholes = table_sources(robot.mechanism), groups_by_path(robot.mechanism)
    accepted, refused, chain = 0, 0, robot
    for own in changeable_units(robot):
        if own in wholes:
            continue
        others = {name for name in robot.quantities if name.startswith(f"{own.rpartition('.')[0]}.")} - {own}
        table = lent_paths.get(own, own)  # for a parameter that an effect takes from a table
        place = table if table in robot.quantities or not others else own
        quantity = robot.quantities.get(own, Quantity(0.0, ""))
        sigma = {} if quantity.sigma is None else {"sigma": quantity.sigma}
        for value in (quantity.value * 1.0625, quantity.value + 1e-3, -1.0, "3 hr", {"value": 1, "sgima": 1}):
            raw = {"value": 1, **sigma, **value} if isinstance(value, dict) else value
            raw = {"value": value, **sigma} if sigma and not isinstance(value, dict) else raw
            found, expected = change(robot, own, value), read_again(robot, place, raw)
            if isinstance(expected, list):
                assert found == expected, (own, value)
                refused += 1
                continue
            assert isinstance(found, pkmodes.Robot), (own, value, found)
            same_to_the_last_digit(found, expected)
            assert not any(np.asarray(v).flags.writeable for v in found.parameters if np.ndim(v))
            accepted += 1
        with contextlib.suppress(pkmodes.PkmodesError):  # one change after the other
            chain = chain.with_values({own: quantity.value * 1.0625 or 1e-6})
    for whole in wholes:
        with contextlib.suppress(pkmodes.PkmodesError):
            chain = chain.with_values({whole: group_value(chain, wholes[whole]) * 1.0625})
    assert chain != robot
    same_to_the_last_digit(chain, robot_from_document(document_of_robot(chain), ""))
    assert accepted > len(changeable_units(robot))
    assert refused > len(changeable_units(robot))
