"""The consistency of generated code: small errors are found in every function, and correct code passes."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.generated.broken_module import Broken
from helpers.robots.sample_robots import random_robot
from pkmodes.codegen.checking.consistency import check_consistency
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.mechanism.regular import sample_parameters
from pkmodes_derive import mechanisms
from pkmodes_generated import linear_delta

KIND = mechanism("linear_delta")


@pytest.mark.parametrize("name", sorted(f.name for f in mechanisms.base("linear_delta").functions))
def test_consistency_finds_one_part_in_a_hundred_million(name: str) -> None:
    """A relative error of 1e-8 in any derived function fails some relation."""
    robot = sample_parameters(KIND)
    checks = check_consistency(Generated(Broken(name, 1 + 1e-8), robot), KIND, robot)
    assert not all(one.holds for one in checks)


@pytest.mark.parametrize("name", sorted(f.name for f in mechanisms.base("linear_delta").functions))
def test_consistency_finds_what_is_not_a_number(name: str) -> None:
    robot = sample_parameters(KIND)
    checks = check_consistency(Generated(Broken(name, np.nan), robot), KIND, robot)
    assert not all(one.holds for one in checks)


@pytest.mark.parametrize("seed", range(5000, 5040))
def test_consistency_raises_no_false_alarm(seed: int) -> None:
    robot, _ = random_robot(np.random.default_rng(seed))
    wrong = [one for one in check_consistency(Generated(linear_delta, robot), KIND, robot) if not one.holds]
    assert wrong == []


@pytest.mark.parametrize("scale", [0.01, 1.0, 100.0])
def test_consistency_does_not_depend_on_the_size_of_the_robot(scale: float) -> None:
    robot = sample_parameters(KIND)
    names = ("origin", "joint", "link_length", "carriage_length", "limits", "pulley_radius", "belt_width")
    scaled = robot._replace(**{name: scale * getattr(robot, name) for name in names})
    assert all(one.holds for one in check_consistency(Generated(linear_delta, scaled), KIND, scaled))


def test_consistency_needs_a_regular_pose() -> None:
    robot = sample_parameters(KIND)._replace(link_length=np.full(3, 0.01))
    assert [one.holds for one in check_consistency(Generated(linear_delta, robot), KIND, robot)] == [False]
