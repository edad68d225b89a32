"""Parameters that act as one: those of which only the product enters, and no others."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from pkmodes.loop.sensitivity.alike import EquivalentParameters, equivalent_parameters
from pkmodes.loop.sensitivity.relative import equivalent_around, scalable_quantities

#: Poses on the planes of symmetry of the robots, where different axes act alike.
POSES = {
    "linear-delta-2022": [0.6, 0.0, -0.245],
    "linear-delta-2022-identified": [0.6, 0.0, -0.245],
    "clavel-delta": [0.0, 0.0, -0.8],
    "corexy-printer": [0.15, 0.15],
}
BELT = "belt.specific_stiffness, belt.width"
#: From docs/reference/robot-file.md: a belt's stiffness is the product of both; an arm's weight acts at its centre of
#: mass.
TOGETHER = {
    "linear-delta-2022": [BELT],
    "linear-delta-2022-identified": [BELT],
    "clavel-delta": ["arm.mass, arm.center"],
    "corexy-printer": [BELT],
}


def relative(*influences: list[float], poses: int = 5) -> np.ndarray:
    """Influences of parameters on two modes that change with the pose, (poses, T, 2)."""
    along = 1.0 + np.linspace(0.0, 0.3, poses)[:, None, None]
    return along * np.array(influences)[None]


def test_parameters_with_equal_or_opposite_influence_are_one() -> None:
    given = relative([0.5, 0.2], [0.1, 0.3], [0.5, 0.2], [-0.1, -0.3])
    given = given * (1.0 + 1e-14 * np.random.default_rng(1).standard_normal(given.shape))
    found = equivalent_parameters(given)
    assert found == [EquivalentParameters((0, 2), (1, 1)), EquivalentParameters((1, 3), (1, -1))]
    assert [one.name(["a", "b", "c", "d"]) for one in found] == ["a, c", "b, 1/d"]


def test_other_proportions_stay_apart() -> None:
    """A per cent of a gear ratio is worth two of the motor's inertia."""
    assert [one.members for one in equivalent_parameters(relative([0.5, 0.2], [0.25, 0.1]))] == [(0,), (1,)]


def test_what_is_equal_at_one_pose_only_is_not_one() -> None:
    given = relative([0.5, 0.2], [0.5, 0.2])
    given[3, 1, 0] += 1e-6
    assert [one.members for one in equivalent_parameters(given)] == [(0,), (1,)]
    given[3, 1, 0] = np.nan  # a pose that cannot be evaluated says nothing
    assert [one.members for one in equivalent_parameters(given)] == [(0, 1)]


def test_what_has_no_influence_is_like_no_other() -> None:
    assert [one.members for one in equivalent_parameters(relative([0.0, 0.0], [1e-16, 0.0]))] == [(0,), (1,)]


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("robot", POSES)
def test_of_the_robots_only_products_are_one_also_at_a_pose_of_symmetry(robot: str, drives: str) -> None:
    model = pkmodes.load(f"robots/{robot}.toml")
    paths = scalable_quantities(model.robot)
    found = equivalent_around(model, POSES[robot], paths, drives)
    assert [one.name(paths) for one in found if len(one.members) > 1] == TOGETHER[robot]
    # Of each pair, only the product enters: half of the one and twice the other change nothing.
    one, other = TOGETHER[robot][0].split(", ")
    values = model.robot.quantities
    exchanged = model.with_values({one: values[one].value * 0.5, other: values[other].value * 2.0})
    elsewhere = np.array(POSES[robot]) + 0.013
    rigid = 0 if drives == "held" else model.modes(elsewhere).rigid_modes
    np.testing.assert_allclose(
        exchanged.frequencies(elsewhere, drives=drives)[rigid:],
        model.frequencies(elsewhere, drives=drives)[rigid:],
        rtol=1e-11,
    )


def test_axes_of_a_symmetric_robot_are_different_parameters() -> None:
    """At y = 0 the second and third link of the linear delta act alike, elsewhere they do not."""
    model = pkmodes.load("robots/linear-delta-2022-identified.toml")
    paths = ["axis.2.link.mass", "axis.3.link.mass"]
    values = model.sensitivities([0.6, 0.0, -0.245], paths).frequencies[:, 3:]
    np.testing.assert_allclose(values[0], values[1], rtol=1e-9)
    assert len(equivalent_around(model, [0.6, 0.0, -0.245], paths, "free")) == 2
