"""What the figures of a plane show besides its map, against loops and differences."""

from __future__ import annotations

import numpy as np
import pytest
import xarray

import pkmodes
from pkmodes.machine.maps.summary import summary_of
from pkmodes.pages.figures.quantities import (
    coarse_plane,
    motor_positions,
    plane_poses,
    reachable_volume,
    relative_sensitivities,
    smallest_mac,
)
from pkmodes.pages.figures.working_plane import working_plane
from pkmodes.pages.plots.maps import extremes
from pkmodes.pages.plots.plane import Plane

LINEAR = "robots/linear-delta-2022-identified.toml"
GRID = {"x": np.linspace(0.3, 1.2, 13), "y": np.linspace(-0.12, 0.12, 7), "z": -0.245}


@pytest.fixture(scope="module")
def model() -> pkmodes.Model:
    return pkmodes.load(LINEAR)


@pytest.fixture(scope="module")
def plane(model: pkmodes.Model) -> Plane:
    return Plane.of(model.map(GRID, shapes=True), ["x", "y", "z"])


def test_the_longer_side_of_a_plane_is_vertical(plane: Plane) -> None:
    assert (plane.abscissa, plane.ordinate, plane.normal, plane.normal_position) == ("y", "x", "z", -0.245)
    assert plane.dataset["frequency"].dims == ("x", "y", "mode")
    assert plane.height_to_width == pytest.approx(0.9 / 0.24)
    np.testing.assert_allclose(plane.display_values("x"), np.linspace(300.0, 1200.0, 13))
    assert plane.axis_label("x") == "x [mm]"


@pytest.mark.parametrize(
    "grid",
    [{**GRID, "z": [-0.25, -0.2]}, {**GRID, "y": 0.0}, [[0.6, 0.0, -0.245], [0.7, 0.0, -0.245]]],
    ids=["volume", "line", "list"],
)
def test_a_map_that_is_no_plane_is_refused(model: pkmodes.Model, grid: object) -> None:
    with pytest.raises(pkmodes.PkmodesError, match="expected a map over two components of the pose"):
        Plane.of(model.map(grid), ["x", "y", "z"])


def test_the_smallest_mac_is_that_of_a_loop_over_neighbours(model: pkmodes.Model, plane: Plane) -> None:
    found = smallest_mac(model, plane)
    shapes, valid = plane.dataset["shape"].values, plane.dataset["valid"].values
    points = plane_poses(model, plane)
    assert 0.5 < valid.mean() < 1.0
    for i, j in np.ndindex(valid.shape):
        near = [(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)]
        near = [
            (a, b) for a, b in near if 0 <= a < valid.shape[0] and 0 <= b < valid.shape[1] and valid[a, b]
        ]
        if not valid[i, j] or not near:
            assert np.isnan(found[i, j]).all()
            continue
        for mode in range(shapes.shape[2]):
            macs = []
            for a, b in near:
                first = min((i, j), (a, b))
                M = model.matrices(points[first])[0]
                phi, psi = shapes[i, j, mode], shapes[a, b, mode]
                macs.append((phi @ M @ psi) ** 2 / ((phi @ M @ phi) * (psi @ M @ psi)))
            assert found[i, j, mode] == pytest.approx(min(macs), rel=1e-9)


def test_relative_sensitivities_are_those_of_differences(model: pkmodes.Model, plane: Plane) -> None:
    names, relative = relative_sensitivities(model, plane, "free")
    assert {"axis.span", "axis.joint_radius", "link.length"} <= set(names)
    # Only the product of both enters: with a row for each, rounding would pick the larger one.
    belt = "belt.specific_stiffness, belt.width"
    assert [name for name in names if name.startswith("belt.")] == [belt]
    assert "axis.1.origin.x" not in names
    assert "carriage.length" not in names  # zero
    pose, step = [0.6, 0.04, -0.245], 1e-6
    few = coarse_plane(plane).dataset
    place = {
        "x": int(np.abs(few["x"].values - 0.6).argmin()),
        "y": int(np.abs(few["y"].values - 0.04).argmin()),
    }
    assert float(few["x"][place["x"]]) == pytest.approx(0.6)
    for name in ("belt.width", "axis.span", "platform.mass", "motor.gear_ratio"):
        value = 1.0 if name == "axis.span" else model.robot.quantities[name].value
        up, down = (
            model.with_values({name: value * (1 + sign * step)}).frequencies(pose)[3:] for sign in (1, -1)
        )
        expected = (np.log(up) - np.log(down)) / (2 * step)
        got = relative[place["x"], place["y"], names.index(belt if name == "belt.width" else name)]
        np.testing.assert_allclose(got, expected, atol=2e-7)


@pytest.mark.parametrize(
    ("robot", "sides", "step"),
    [
        ("clavel-delta", {"x": np.linspace(-0.6, 0.6, 61), "y": np.linspace(-0.6, 0.6, 61)}, 0.05),
        # The narrowest planes of this one, at the bottom, have the lowest condition numbers.
        (
            "linear-delta-2022-identified",
            {"x": np.linspace(0.0, 1.5, 76), "y": np.linspace(-0.2, 0.2, 41)},
            0.02,
        ),
    ],
)
def test_the_working_plane_has_the_lowest_mean_condition_number_of_the_wide_planes(
    robot: str, sides: dict[str, np.ndarray], step: float
) -> None:
    model = pkmodes.load(f"robots/{robot}.toml")
    grid = working_plane(model)
    assert grid.shape[0] == 1
    best = float(grid.axes["z"][0])
    heights = best + step * np.arange(-3, 4)
    found = model.map({**sides, "z": heights})
    area = found["valid"].sum(["x", "y"])
    mean = found["condition"].mean(["x", "y"]).where(area >= 0.5 * float(area.max()))
    assert abs(float(mean["z"][int(np.nanargmin(mean.values))]) - best) <= step
    inside = model.map(grid)["valid"]
    assert 0.5 < float(inside.mean()) <= 1.0
    for name in ("x", "y"):  # one of the values lies on the centre line
        values = grid.axes[name]
        assert len(values) % 2 == 1
        assert values[len(values) // 2] == pytest.approx((values[0] + values[-1]) / 2.0)


def test_sensitivities_need_about_two_thousand_poses_with_the_same_spacing_both_ways() -> None:
    """Of 91 x 61 = 5,551 poses every second one."""
    values = np.zeros((91, 61))
    x, y = np.linspace(0.0, 0.9, 91), np.linspace(-0.3, 0.3, 61)
    dataset = xarray.Dataset({"valid": (("x", "y"), values)}, {"x": x, "y": y})
    few = coarse_plane(Plane(dataset, "y", "x", "z", -0.2))
    np.testing.assert_array_equal(few.dataset["x"], x[::2])
    np.testing.assert_array_equal(few.dataset["y"], y[::2])
    assert (few.abscissa, few.ordinate, few.normal, few.normal_position) == ("y", "x", "z", -0.2)


def test_extremes_are_those_of_the_whole_plane(plane: Plane) -> None:
    """As in the table of a map: also at the edge; mirrored poses share an extreme but for rounding."""
    values = np.full(plane.dataset["valid"].shape, 50.0)
    values[0, 0] = np.nan
    values[12, 3] = 99.0
    values[4, 1], values[4, 5] = 40.0, 40.0 * (1.0 + 1e-12)
    assert extremes(values) == {"minimum": [(4, 1), (4, 5)], "maximum": [(12, 3)]}
    assert extremes(np.full((3, 5), np.nan)) == {"minimum": [], "maximum": []}
    assert extremes(np.full((3, 5), 7.0)) == {"minimum": [], "maximum": []}  # everywhere is no place


def test_the_triangles_of_the_picture_are_where_the_table_of_the_same_map_says(model: pkmodes.Model) -> None:
    found = model.map(GRID, shapes=True)
    drawn = Plane.of(found, ["x", "y", "z"])
    for mode, row in enumerate(summary_of(found, None).as_json()["modes"]):
        places = extremes(drawn.dataset["frequency"].values[..., mode])
        for name in ("minimum", "maximum"):
            at = {(float(drawn.dataset["x"][i]), float(drawn.dataset["y"][j])) for i, j in places[name]}
            assert (row[f"{name}_at"]["x"], row[f"{name}_at"]["y"]) in at, (mode, name)


def test_the_area_of_a_plane_is_that_of_the_poses_that_can_be_evaluated(plane: Plane) -> None:
    cell = (0.9 / 12) * (0.24 / 6)
    assert plane.area == pytest.approx(plane.dataset["valid"].values.sum() * cell)
    angles = plane.dataset.assign_coords(y=("y", plane.dataset["y"].values, {"units": "rad"}))
    assert Plane(angles, "y", "x", "z", -0.245).area is None


def test_the_volume_encloses_the_plane(model: pkmodes.Model, plane: Plane) -> None:
    volume = reachable_volume(model, plane)
    assert volume is not None
    for edge in (volume.valid[:, 0], volume.valid[:, -1], volume.valid[:, :, 0], volume.valid[:, :, -1]):
        assert not edge.any()
    assert volume.heights[0] < plane.normal_position < volume.heights[-1]
    middle = int(np.abs(volume.heights - plane.normal_position).argmin())
    reached = volume.ordinates[volume.valid[middle].any(axis=1)]
    valid = plane.dataset["x"].values[plane.dataset["valid"].values.any(axis=1)]
    assert reached[0] <= valid[0] + 0.02
    assert reached[-1] >= valid[-1] - 0.02


def test_motors_are_at_the_driven_pulleys_of_the_robot_file(model: pkmodes.Model, plane: Plane) -> None:
    """The file has driven pulley 1, at the upper limit, on rail 1, and pulley 2 on the others."""
    found = motor_positions(model, plane)
    robot = model.robot.quantities
    expected = []
    for axis, end in ((1, "max"), (2, "min"), (3, "min")):
        x = robot[f"axis.{axis}.origin.x"].value + robot[f"axis.{axis}.limits.{end}"].value
        expected.append([1e3 * robot[f"axis.{axis}.origin.y"].value, 1e3 * x])
    np.testing.assert_allclose(found, expected, atol=1e-9)
