"""Where a robot says that it is used, maps, pictures and proposed measurements stay."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import pkmodes
from pkmodes.core.base.errors import PoseError
from pkmodes.core.robot.usable import Radius, SingularAngle
from pkmodes.loop.updating.candidates import suspects
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes.machine.maps.workspace import box_of, grid_over_workspace, usable_box
from pkmodes.pages.figures.quantities import reachable_volume
from pkmodes.pages.figures.working_plane import working_plane
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.view import poses_around, typical_pose

ROBOTS = Path(__file__).parents[3] / "robots"
DELTA, CLAVEL, PRINTER = "linear-delta-2022", "clavel-delta", "corexy-printer"
Limits = Mapping[str, tuple]


@cache
def plain(name: str) -> pkmodes.Model:
    return pkmodes.load(ROBOTS / f"{name}.toml")


@cache
def box(name: str) -> tuple[np.ndarray, np.ndarray]:
    return box_of(plain(name))


@cache
def brute_force(name: str) -> np.ndarray:
    """All poses of a fine grid over the workspace that can be evaluated, on both sides of it."""
    model, (low, high) = plain(name), box(name)
    axes = [np.linspace(a - 0.1 * (b - a), b + 0.1 * (b - a), 41) for a, b in zip(low, high, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(axes))
    good = points[model.check(points).valid]
    if model.has_assemblies:
        middle = good[np.argmin(np.linalg.norm(good - (low + high) / 2, axis=1))]
        good = good[model.assembly(good) == model.assembly(middle)]
    return good


def used(name: str, limits: Limits) -> pkmodes.Model:
    return pkmodes.Model(replace(plain(name).robot, usable=dict(limits)))


def ends_of(name: str, limits: Limits) -> tuple[np.ndarray, np.ndarray]:
    names = [component.name for component in plain(name).mechanism.pose]
    low, high = np.array([limits.get(one, (-np.inf, np.inf)) for one in names]).T
    return low, high


def inside(name: str, limits: Limits, points: np.ndarray) -> bool:
    low, high = ends_of(name, limits)
    return bool(((points >= low) & (points <= high)).all())


@pytest.mark.parametrize("name", [DELTA, CLAVEL, PRINTER])
@settings(max_examples=2, deadline=None, derandomize=True)
@given(data=st.data())
def test_the_box_is_that_of_the_reachable_poses_within_the_limits(name: str, data: st.DataObject) -> None:
    low, high = box(name)
    limits = {}
    for component, a, b in zip(plain(name).mechanism.pose, low, high, strict=True):
        if data.draw(st.booleans()):
            ends = sorted(data.draw(st.tuples(*[st.floats(-0.2, 1.2)] * 2)))
            assume(ends[1] - ends[0] > 0.05)
            limits[component.name] = (a + ends[0] * (b - a), a + ends[1] * (b - a))
    least, most = ends_of(name, limits)
    good = brute_force(name)
    good = good[((good >= least) & (good <= most)).all(axis=1)]
    assume(len(good) > 30)
    grid = grid_over_workspace(used(name, limits))
    found = usable_box(used(name, limits))
    room = 0.03 * (high - low)  # a step of the grid
    assert (good.min(axis=0) >= found[0] - room).all()
    assert (good.max(axis=0) <= found[1] + room).all()
    assert inside(name, limits, np.array(found))
    assert inside(name, limits, np.stack(np.meshgrid(*grid.axes.values()), axis=-1))


def test_the_box_of_a_rectangle_is_its_intersection_with_the_limits() -> None:
    """The tool head of the printer travels over 300 mm by 300 mm."""
    np.testing.assert_allclose(
        usable_box(used(PRINTER, {"x": (0.05, 0.1), "y": (-1.0, 0.2)})), [[0.05, 0.0], [0.1, 0.2]], atol=1e-5
    )
    np.testing.assert_array_equal(usable_box(plain(PRINTER)), box(PRINTER))


def test_limits_choose_the_branch_that_they_contain() -> None:
    """The published robot may also hang above its rails, where it is mirrored."""
    above = usable_box(used(DELTA, {"z": (0.2, 0.3)}))
    below = usable_box(used(DELTA, {"z": (-0.3, -0.2)}))
    np.testing.assert_allclose(above[1][2], 0.3, rtol=1e-12)
    np.testing.assert_allclose(above[0][:2], below[0][:2], atol=0.01)


@pytest.mark.parametrize(
    ("search", "limits"),
    [
        (grid_over_workspace, {"z": (-3.0, -2.0)}),
        (working_plane, {"z": (-3.0, -2.0)}),
        (typical_pose, {"z": (-3.0, -2.0)}),
        (
            usable_box,
            {"y": (-0.05, 0.05), "z": (-0.36, -0.35)},
        ),  # in the box that is searched, but out of reach
    ],
)
def test_limits_without_a_reachable_pose_are_refused(
    search: Callable[[pkmodes.Model], object], limits: Limits
) -> None:
    with pytest.raises(PoseError) as error:
        search(used(DELTA, limits))
    assert "no pose within the usable limits can be reached: " in error.value.what
    assert error.value.where.endswith("linear-delta-2022.toml: usable")
    assert "the workspace lies within x from" in error.value.remedy


def test_a_small_usable_part_is_found() -> None:
    """One draw in a hundred million of the whole workspace would fall into it."""
    limits = {"x": (0.599, 0.601), "y": (-0.001, 0.001), "z": (-0.2452, -0.2448)}
    np.testing.assert_allclose(usable_box(used(DELTA, limits)), np.array(list(limits.values())).T, rtol=1e-12)


def test_a_map_without_a_grid_stays_inside_and_an_explicit_grid_does_not() -> None:
    model = used(PRINTER, {"x": (0.1, 0.12), "y": (0.2, 0.21)})
    dataset = model.map()
    assert (dataset.x.min(), dataset.x.max()) == (0.1, 0.12)
    assert (dataset.y.min(), dataset.y.max()) == (0.2, 0.21)
    assert dataset.valid.all()
    wished = model.map({"x": [0.05, 0.25], "y": 0.05})
    assert wished.valid.all()


def test_the_working_plane_and_the_volume_around_it_stay_inside() -> None:
    limits = {"z": (-0.3, -0.2), "x": (0.5, 0.7)}
    model = used(DELTA, limits)
    plane = working_plane(model)
    assert inside(DELTA, limits, np.stack(np.meshgrid(*plane.axes.values()), axis=-1))
    volume = reachable_volume(model, Plane.of(model.map(plane), ["x", "y", "z"]))
    assert volume is not None
    x, z = volume.ordinates if volume.ordinates.min() > 0.3 else volume.abscissas, volume.heights
    assert (z.min(), z.max()) == (-0.3, -0.2)
    assert volume.valid.any()
    outside = (x < 0.5) | (x > 0.7)
    assert outside.any()
    axis = 1 if x is volume.ordinates else 2
    assert not np.moveaxis(volume.valid, axis, 0)[outside].any()


def test_the_volume_around_a_plane_beyond_the_limits_is_all_that_can_be_reached() -> None:
    grid = {"x": np.linspace(0.5, 0.7, 9), "y": np.linspace(-0.05, 0.05, 5), "z": -0.1}
    volumes = [
        reachable_volume(model, Plane.of(model.map(grid), ["x", "y", "z"]))
        for model in (used(DELTA, {"z": (-0.3, -0.2)}), plain(DELTA))
    ]
    assert volumes[0] is not None
    assert volumes[1] is not None
    np.testing.assert_array_equal(volumes[0].valid, volumes[1].valid)


def test_a_page_stays_inside_unless_its_pose_is_beyond() -> None:
    limits = {"z": (-0.3, -0.2)}
    model = used(DELTA, limits)
    page = poses_around(model, typical_pose(model))
    assert inside(DELTA, limits, page.poses)
    assert page.workspace is not None
    assert np.abs(page.workspace.vertices[:, 2] + 0.25).max() < 0.0501
    beyond = poses_around(model, [0.6, 0.0, -0.1])
    free = poses_around(plain(DELTA), [0.6, 0.0, -0.1])
    np.testing.assert_array_equal(beyond.poses, free.poses)


def proposed(name: str, limits: Limits, measured: np.ndarray) -> np.ndarray:
    robot = used(name, limits).robot
    return RobotStructure(robot, measured, *suspects(robot, ("payload",))).elsewhere(80)[0]


@pytest.mark.parametrize(
    ("measured", "nearest"),
    [
        ([[0.6, 0.0, -0.245], [0.5, 0.05, -0.28]], (-0.3, -0.2)),  # inside the limits
        ([[0.6, 0.0, -0.19], [0.5, 0.05, -0.21]], (-0.24, -0.2)),  # on both sides of one
        ([[0.6, 0.0, -0.1], [0.5, 0.05, -0.1]], (-0.225, -0.2)),  # beyond it
    ],
)
def test_proposed_measurements_stay_inside(measured: list[list[float]], nearest: tuple[float, float]) -> None:
    """They are around the measured poses, at least 25 mm, as far as the limits allow."""
    points = proposed(DELTA, {"z": (-0.3, -0.2), "x": (0.55, 0.56)}, np.array(measured))
    assert len(points) > 20
    assert inside(DELTA, {"z": nearest, "x": (0.55, 0.56)}, points)
    assert np.ptp(points[:, 2]) > 0.02


def test_no_measurement_is_proposed_where_nothing_can_be_reached() -> None:
    assert not len(proposed(DELTA, {"z": (-3.0, -2.0)}, np.array([[0.6, 0.0, -0.245]])))


def test_without_limits_proposals_are_as_ever() -> None:
    points = np.array([[0.6, 0.0, -0.245], [0.5, 0.05, -0.28]])
    np.testing.assert_array_equal(proposed(DELTA, {}, points), proposed(DELTA, {"z": (-9.0, 9.0)}, points))


ROUND: Limits = {"radius": Radius(0.1, (0.6, 0.0)), "z": (-0.28, -0.2)}


def sines(points: np.ndarray) -> np.ndarray:
    """Sines of the angles of the published robot's rods to their singular directions.

    The closure |p + c - e|^2 = l^2 on a rail along x: the component of the rod along it, over its length.
    """
    robot = plain(DELTA).robot
    n, c, o = (np.asarray(getattr(robot.parameters, name)) for name in ("direction", "joint", "origin"))
    r = points[:, None] + c - o
    across = r - np.einsum("nji,ji->nj", r, n)[..., None] * n
    length = np.asarray(robot.parameters.link_length)
    return np.sqrt(1.0 - (across**2).sum(axis=-1) / length**2)


def test_a_map_without_a_grid_stays_inside_a_radius_and_an_angle() -> None:
    angle = np.radians(30.0)
    dataset = used(DELTA, {**ROUND, "singular_angle": SingularAngle(angle)}).map()
    points = np.stack(np.meshgrid(dataset.z, dataset.y, dataset.x, indexing="ij")[::-1], axis=-1)
    there = np.hypot(points[..., 0] - 0.6, points[..., 1]) <= 0.1
    with np.errstate(invalid="ignore"):
        there &= (sines(points.reshape(-1, 3)) >= np.sin(angle)).all(axis=1).reshape(there.shape)
    valid = dataset.valid.values
    np.testing.assert_array_equal(valid, there)
    assert 0.1 < valid.mean() < 0.8
    assert set(dataset.reason.values[~valid]) == {"usable"}
    assert (
        "at most 0.1 m from x = 0.6 m, y = 0 m, every rod at least 30 deg" in dataset.reason.attrs["usable"]
    )
    assert np.isnan(dataset.frequency.values[~valid]).all()
    wished = used(DELTA, ROUND).map({"x": [0.4, 0.8], "y": 0.0, "z": -0.245})
    assert wished.valid.all()


def test_every_grid_and_page_that_nobody_asked_for_stays_inside_a_radius() -> None:
    model = used(DELTA, ROUND)
    low, high = usable_box(model)
    np.testing.assert_allclose(low, [0.5, -0.1, -0.28], atol=0.005)
    np.testing.assert_allclose(high, [0.7, 0.1, -0.2], atol=0.005)
    plane = working_plane(model)
    drawn = model.map(plane)
    x, y = np.meshgrid(drawn.x, drawn.y)
    assert (np.hypot(x - 0.6, y)[drawn.valid.values.squeeze()] <= 0.1).all()
    assert drawn.valid.any()
    volume = reachable_volume(model, Plane.of(drawn, ["x", "y", "z"]))
    assert volume is not None
    assert (volume.heights.min(), volume.heights.max()) == (-0.28, -0.2)
    page = poses_around(model, typical_pose(model))
    assert (np.hypot(page.poses[:, 0] - 0.6, page.poses[:, 1]) <= 0.1).all()


def test_an_angle_that_no_reachable_pose_has_is_refused_in_words() -> None:
    with pytest.raises(PoseError, match="every rod at least 89 deg from its singular direction"):
        usable_box(used(DELTA, {"singular_angle": SingularAngle(np.radians(89.0))}))


@pytest.mark.parametrize("stated", [None, 25.0])
def test_no_measurement_is_proposed_with_a_rod_near_its_singular_direction(stated: float | None) -> None:
    """At y = 0.27 m the second rod of the published robot is nearly perpendicular to its rail."""
    limits = {} if stated is None else {"singular_angle": SingularAngle(np.radians(stated))}
    measured = np.array([[0.6, 0.0, -0.245], [0.6, 0.12, -0.3]])
    structure = RobotStructure(
        used(DELTA, limits).robot, measured, *suspects(plain(DELTA).robot, ("payload",))
    )
    points = structure.elsewhere(80)[0]
    assert len(points) > 20
    least = np.degrees(np.arcsin(sines(points))).min()
    expected = stated or 10.0
    assert expected <= least < expected + 5.0
    assert f"every rod at least {expected:g} deg from its singular direction" in structure.surroundings


def test_measurements_are_proposed_within_a_radius() -> None:
    points = proposed(DELTA, ROUND, np.array([[0.6, 0.0, -0.245], [0.5, 0.05, -0.28]]))
    assert len(points) > 20
    assert (np.hypot(points[:, 0] - 0.6, points[:, 1]) <= 0.1).all()
