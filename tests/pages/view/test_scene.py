"""Scenes: springs of effects, frames of an animation, poses and workspaces."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.core.base.errors import PoseError
from pkmodes.machine.maps.workspace import box_of
from pkmodes.pages.view import page, poses_around, scene, typical_pose
from pkmodes.pages.view.robot_drawing import upright
from pkmodes.pages.view.workspace import workspace

ROBOTS = Path(__file__).parents[3] / "robots"
PUBLISHED = ROBOTS / "linear-delta-2022.toml"
POSE = [0.6, 0.0, -0.245]


def test_only_springs_that_the_robot_has_are_listed() -> None:
    plain = pkmodes.load(PUBLISHED)
    assert len(scene(plain, POSE).springs) == 9
    held = plain.with_values(
        {"effects.servo_stiffness.stiffness": 900.0, "effects.gearbox_compliance.compliance": 1e-4}
    )
    names = [spring.name for spring in scene(held, POSE).springs]
    assert names[9:] == [
        "servo stiffness: rotation of pulley 1 of axis 1",
        "servo stiffness: rotation of pulley 2 of axis 2",
        "servo stiffness: rotation of pulley 2 of axis 3",
        *(f"wind-up of gearbox {j}" for j in (1, 2, 3)),
    ]


def test_belts_are_the_elements_of_their_springs() -> None:
    shown = scene(pkmodes.load(PUBLISHED), POSE)
    belts = {e.spring: e.name for e in shown.elements if e.spring >= 0}
    assert {shown.springs[i].name.split(" of ")[1] for i in belts} == {"belt 1", "belt 2", "belt 3"}
    assert all(shown.springs[i].name.endswith(name) for i, name in belts.items())


def test_frames_begin_at_rest_and_swing_by_the_amplitude() -> None:
    shown = scene(pkmodes.load(PUBLISHED), [POSE, [0.5, 0.0, -0.245]], chosen=1)
    frames = shown.frames(count=8, amplitude=0.1)
    assert frames.shape == (8, shown.points.shape[1], 3)
    np.testing.assert_array_equal(frames[0], shown.points[1])
    np.testing.assert_allclose(frames[2] + frames[6], 2 * shown.points[1], atol=1e-12)
    moved = np.linalg.norm(frames[2] - shown.points[1], axis=-1)
    rims = 0.035 * np.abs(shown.shapes[1, 3, 3:]).max() * shown.scale(1, 3)
    assert max(moved.max() / (0.1 * shown.size), rims) == pytest.approx(1.0)
    direction = (frames[2] - frames[0])[0]
    np.testing.assert_allclose(
        np.abs(direction @ shown.platform_shapes[1, 3]),
        np.linalg.norm(direction) * np.linalg.norm(shown.platform_shapes[1, 3]),
    )


def test_an_open_direction_is_upright_and_perpendicular() -> None:
    z = np.array([0.0, 0.0, 1.0])
    level = upright(np.array([[1.0, 0.0, 0.0], [0.6, 0.8, 0.0]]), np.zeros((2, 3)), z)
    np.testing.assert_allclose(level, [z, z])
    places = np.array([[np.cos(a), np.sin(a), 0.0] for a in (0.0, 2.0, 4.0)])
    np.testing.assert_allclose(
        upright(np.tile(z, (3, 1)), places, z), (places - places.mean(0)) / _norms(places - places.mean(0))
    )
    rng = np.random.default_rng(1)
    directions = rng.normal(size=(20, 3))
    directions /= _norms(directions)
    found = upright(directions, rng.normal(size=(20, 3)), z)
    np.testing.assert_allclose(np.sum(found * directions, axis=1), 0.0, atol=1e-14)
    np.testing.assert_allclose(_norms(found), 1.0)


def _norms(vectors: np.ndarray) -> np.ndarray:
    return np.linalg.norm(vectors, axis=1, keepdims=True)


def test_a_grid_holds_valid_poses_and_the_given_one() -> None:
    model = pkmodes.load(PUBLISHED)
    shown = poses_around(model, POSE)
    np.testing.assert_array_equal(shown.poses[shown.chosen], POSE)
    assert model.check(shown.poses).valid.all()
    assert shown.levels is not None
    assert shown.places is not None
    for place in np.argwhere(shown.places >= 0):
        values = [levels[i] for levels, i in zip(shown.levels, place, strict=True)]
        np.testing.assert_array_equal(shown.poses[shown.places[tuple(place)]], values)
    outside = np.argwhere(shown.places < 0)
    values = np.stack([levels[i] for levels, i in zip(shown.levels, outside.T, strict=True)], axis=-1)
    same_branch = model.check(values).valid & (model.assembly(values, "nan") == model.assembly(POSE))
    assert not same_branch.any()


def test_a_pose_that_cannot_be_reached_is_refused_as_elsewhere() -> None:
    model = pkmodes.load(PUBLISHED)
    with pytest.raises(PoseError, match="out of reach"):
        poses_around(model, [0.6, 0.0, -0.9])


@pytest.mark.parametrize("name", ["linear-delta-2022", "clavel-delta", "corexy-printer"])
def test_the_typical_pose_is_valid_and_hangs_below(name: str) -> None:
    model = pkmodes.load(ROBOTS / f"{name}.toml")
    pose = typical_pose(model)
    assert model.check(pose).valid
    if len(pose) == 3:
        assert pose[2] < 0  # gravity is along -z, and rails and motors are at z = 0


def test_the_outline_of_a_plane_workspace_is_its_rectangle() -> None:
    model = pkmodes.load(ROBOTS / "corexy-printer.toml")
    pose = np.array([0.1, 0.2])
    found = workspace(model, pose, box_of(model, pose))
    assert found is not None
    np.testing.assert_allclose(found.vertices.min(axis=0), 0.0, atol=2e-3)
    np.testing.assert_allclose(found.vertices.max(axis=0), 0.3, atol=2e-3)
    assert _closed(found.faces)
    edge = np.abs(found.vertices - 0.15).max(axis=1)
    assert np.abs(edge - 0.15).max() < 0.3 / 48  # rounded corners lose less than a cell


def test_the_surface_of_a_workspace_is_closed_and_lies_on_the_boundary() -> None:
    model = pkmodes.load(PUBLISHED)
    pose = np.array(POSE)
    found = workspace(model, pose, box_of(model, pose))
    assert found is not None
    assert _closed(found.faces)
    cell = np.ptp(found.vertices, axis=0) / 25
    middle = found.vertices.mean(axis=0)
    lower = found.vertices[:, 2] < middle[2]
    # Rails at y = 0 and +-0.2 m, links of 0.4 m: the lowest point is at y = 0, at -sqrt(0.4^2 - 0.2^2).
    assert found.vertices[lower, 2].min() == pytest.approx(-np.sqrt(0.12), abs=2 * cell[2])
    assert np.abs(found.vertices[:, 1]).max() == pytest.approx(0.2, abs=2 * cell[1])


def _closed(faces: np.ndarray) -> bool:
    """Whether every edge of quadrilaterals, or every end of segments, belongs to an even number of them."""
    if faces.shape[1] == 2:
        return bool((np.unique(faces, return_counts=True)[1] % 2 == 0).all())
    edges = np.concatenate([faces[:, [i - 1, i]] for i in range(4)])
    return bool((np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)[1] % 2 == 0).all())


def test_with_held_motors_the_springs_hold_their_energy_and_the_page_says_so() -> None:
    """The strain energies of a mode sum to lambda / 2, without the share of gravity, which is small here."""
    model = pkmodes.load(ROBOTS / "corexy-printer.toml")
    shown = scene(model, [0.1, 0.12], drives="held")
    modes = model.modes([0.1, 0.12], drives="held")
    np.testing.assert_array_equal(shown.frequencies[0], modes.frequencies)
    assert shown.rigid_modes == 0
    energy = 0.5 * (2 * np.pi * modes.frequencies) ** 2
    np.testing.assert_allclose(shown.energies[0].sum(axis=1), energy, rtol=1e-9)
    text = page(shown)
    assert "; motors held</p>" in text
    assert "Modes with motors held:" in text
    assert "; motors free</p>" in page(scene(model, [0.1, 0.12], drives="free"))
