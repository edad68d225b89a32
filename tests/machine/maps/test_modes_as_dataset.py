"""`Modes.to_dataset`: the modes at hand with the names and attributes of a map."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.robots.one_of_each import load_free

ROBOTS = Path(__file__).parents[3] / "robots"
POSES = [[0.6, 0.0, -0.245], [0.5, 0.05, -0.245], [0.0, 0.0, -0.245]]


@pytest.mark.parametrize("robot", ["linear-delta-2022", "clavel-delta", "corexy-printer"])
def test_variables_and_attributes_are_those_of_a_map_of_the_same_poses(robot: str) -> None:
    model = load_free(f"{robot}.toml")
    poses = {
        "clavel-delta": [[0.0, 0.05, -0.7], [2.0, 0.0, -0.7]],
        "corexy-printer": [[0.1, 0.2], [0.2, 9.0]],
    }
    points = poses.get(robot, POSES)
    found = model.modes(points, "nan").to_dataset()
    whole = model.map(points, shapes=True)
    assert set(whole.data_vars) - set(found.data_vars) == {"static_torque", "condition"}
    for name in found.variables:
        assert found[name].dims == whole[name].dims, name
        assert found[name].attrs == whole[name].attrs, name
        if found[name].dtype.kind == "f":
            np.testing.assert_allclose(found[name], whole[name], atol=1e-9, err_msg=name)
        elif name != "pose":
            np.testing.assert_array_equal(found[name], whole[name], err_msg=name)
    assert found.attrs == whole.attrs


def test_leading_axes_are_those_of_the_poses(model: pkmodes.Model) -> None:
    one = model.modes(POSES[0]).to_dataset()
    assert one["frequency"].dims == ("mode",)
    assert float(one["x"]) == 0.6
    assert one["mode"].values.tolist() == [1, 2, 3, 4, 5, 6]
    several = model.modes(np.reshape(POSES[:2] * 2, (2, 2, 3)), fields=["frequencies"]).to_dataset()
    assert several["frequency"].dims == ("pose_1", "pose_2", "mode")
    assert several["y"].dims == ("pose_1", "pose_2")


def test_only_fields_that_were_asked_for(model: pkmodes.Model, tmp_path: Path) -> None:
    found = model.modes(POSES, "nan", fields=["joint_positions", "frequencies"]).to_dataset()
    assert set(found.data_vars) == {"frequency", "joint_position", "valid", "reason"}
    assert found["coordinate"].values.tolist() == ["x_1", "x_2", "x_3"]
    assert set(model.modes(POSES, "nan", fields=["mass_matrix"]).to_dataset().data_vars) == {
        "valid",
        "reason",
    }
    found.to_netcdf(tmp_path / "modes.nc")
    with xarray.open_dataset(tmp_path / "modes.nc") as again:
        xarray.testing.assert_identical(found, again.load())


def test_grounded_robots_have_no_rigid_modes(model: pkmodes.Model) -> None:
    held = model.with_values({"effects.servo_stiffness.stiffness": 900.0})
    found = held.modes(POSES[0]).to_dataset()
    assert found.attrs["rigid_modes"] == 0
    np.testing.assert_array_equal(found["frequency"], held.frequencies(POSES[0]))


def test_a_table_has_a_row_for_each_mode_at_each_pose(model: pkmodes.Model) -> None:
    modes = model.modes(POSES, "nan")
    found = modes.to_table()
    assert len(found) == 3 * 6
    for (pose, mode), rows in found.groupby(["pose", "mode"]):
        (row,) = rows.to_dict("records")
        assert [row["x"], row["y"], row["z"]] == POSES[pose]
        assert row["valid"] == modes.valid[pose]
        np.testing.assert_array_equal(row["frequency"], modes.frequencies[pose, 2 + mode])
        moved = [row[f"platform_shape:{name}"] for name in "xyz"]
        np.testing.assert_array_equal(moved, modes.platform_shapes[pose, 2 + mode])
        places = [row[f"joint_position:x_{j}"] for j in (1, 2, 3)]
        np.testing.assert_array_equal(places, modes.joint_positions[pose])


@pytest.mark.parametrize(("poses", "rows"), [(POSES[0], 1), (POSES[:2], 2)])
def test_a_table_without_modes_has_a_row_for_each_pose(
    model: pkmodes.Model, poses: list[float], rows: int
) -> None:
    found = model.modes(poses, fields=["joint_positions"]).to_table()
    assert len(found) == rows
    assert found["joint_position:x_1"].notna().all()
    assert "frequency" not in found
