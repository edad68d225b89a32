"""The part of K by gravity: from the library, from NumPy, and as what is lost where gravity is switched off."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helpers.robots.lane_samples import EFFECTS, NAMES, SIX_LEGGED, case, robot_of
from pkmodes.core.model import Model

#: Of the largest entry of what is compared.
EXACT = 1e-13


@pytest.mark.compiler
@pytest.mark.parametrize("backend", ["compiled", "numpy"])
@pytest.mark.parametrize("effects", ["none", "massless clamps and more", [*EFFECTS][-1]])
@pytest.mark.parametrize("name", [*NAMES, *SIX_LEGGED])
def test_it_is_what_a_machine_without_gravity_lacks(name: str, effects: str, backend: str) -> None:
    given = case(name, 3, effects, "hundredfold gravity", count=11)
    robot = replace(robot_of(given), effects=given.values)
    without = replace(robot, parameters=robot.parameters._replace(gravity=np.zeros(3)))
    K_g = Model(robot).gravitational_stiffness(given.poses, "nan", backend=backend)
    (_, K), (_, K_el) = (
        Model(machine).matrices(given.poses, "nan", backend="numpy") for machine in (robot, without)
    )
    assert np.isfinite(K_g).any()
    np.testing.assert_allclose(K_g, K - K_el, rtol=0, atol=EXACT * np.nanmax(np.abs(K)))
    assert not Model(without).gravitational_stiffness(given.poses[:1], backend=backend).any()


@pytest.mark.compiler
@pytest.mark.parametrize("effects", ["none", "massless clamps and more"])
@pytest.mark.parametrize("name", [*NAMES, *SIX_LEGGED])
def test_the_library_gives_it_by_itself_with_all_digits(name: str, effects: str) -> None:
    given = case(name, 3, effects, count=11)
    model = Model(replace(robot_of(given), effects=given.values))
    found, expected = (
        model.gravitational_stiffness(given.poses, "nan", backend=backend)
        for backend in ("compiled", "numpy")
    )
    assert (np.isnan(found) == np.isnan(expected)).all()
    np.testing.assert_allclose(found, expected, rtol=0, atol=EXACT * np.nanmax(np.abs(expected)))
    pose = given.poses[np.isfinite(found).all((1, 2))][0]
    np.testing.assert_allclose(
        model.gravitational_stiffness(pose), model.gravitational_stiffness(pose[None])[0], rtol=1e-13
    )


def test_a_pose_that_cannot_be_evaluated() -> None:
    given = case("linear_delta", 3, count=2)
    model = Model(robot_of(given))
    far = np.vstack([given.poses[:1], [[9.0, 9.0, 9.0]]])
    K_g = model.gravitational_stiffness(far, "nan")
    assert np.isfinite(K_g[0]).all()
    assert np.isnan(K_g[1]).all()
