"""What the dataset of a map promises: dimensions, coordinates, variables, units, attributes, reasons, files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray

import pkmodes
from pkmodes.core.robot.reading import read_robot

ROBOTS = Path(__file__).parents[3] / "robots"
PUBLISHED = ROBOTS / "linear-delta-2022.toml"
#: It leaves the workspace in two ways: beyond the limits for small x, out of reach for low z.
GRID = {"x": np.linspace(0.0, 0.8, 9), "y": np.linspace(-0.1, 0.1, 5), "z": [-0.5, -0.245]}
EVERY_WAY: dict[str, dict[str, Any]] = {
    "plain": {},
    "shapes": {"shapes": True},
    "tracked": {"tracked": True},
    "swept": {"sweep": {"platform.mass": [1.0, 2.0], "effects.servo_stiffness.stiffness": [0.0, 5e3]}},
    "swept shapes": {"sweep": {"effects.gearbox_compliance.compliance": [0.0, 1e-4]}, "shapes": True},
}


@pytest.fixture(scope="module")
def found(model: pkmodes.Model) -> xarray.Dataset:
    return model.map(GRID, sweep={"platform.mass": [1.0, 1.5]}, shapes=True)


def test_dimensions_are_those_of_the_grid_with_swept_parameters_first(found: xarray.Dataset) -> None:
    leading = ("platform.mass", "z", "y", "x")
    assert {name: value.dims for name, value in found.data_vars.items()} == {
        "frequency": (*leading, "mode"),
        "platform_shape": (*leading, "mode", "direction"),
        "in_plane": (*leading, "mode"),
        "out_of_plane": (*leading, "mode"),
        "joint_position": (*leading, "coordinate"),
        "static_torque": (*leading, "drive"),
        "condition": leading,
        "valid": leading,
        "reason": leading,
        "shape": (*leading, "mode", "coordinate"),
    }
    assert dict(found.sizes) == {
        **{"platform.mass": 2, "z": 2, "y": 5, "x": 9},
        **{"mode": 6, "direction": 3, "drive": 3, "coordinate": 9},
    }


def test_coordinates(found: xarray.Dataset, model: pkmodes.Model) -> None:
    for name, values in GRID.items():
        assert found[name].values.tolist() == list(values)
    assert found["platform.mass"].values.tolist() == [1.0, 1.5]
    assert found["mode"].values.tolist() == [1, 2, 3, 4, 5, 6]
    assert found["direction"].values.tolist() == ["x", "y", "z"]
    assert found["coordinate"].values.tolist() == list(model.coordinates)
    assert found["drive"].values.tolist() == ["1", "2", "3"]


def test_every_variable_has_a_unit_and_a_name_for_a_person(found: xarray.Dataset) -> None:
    for name, value in found.variables.items():
        assert value.attrs["units"], name
        assert len(value.attrs["long_name"]) > 3, name
    units = {name: found[name].attrs["units"] for name in found.variables}
    assert units["frequency"] == "Hz"
    assert units["static_torque"] == "N m"
    assert {units[name] for name in ("x", "y", "z", "joint_position")} == {"m"}
    assert units["platform.mass"] == "kg"


def test_attributes_hold_the_robot(found: xarray.Dataset, tmp_path: Path) -> None:
    attributes = found.attrs
    assert attributes["robot_file"] == PUBLISHED.read_text(encoding="utf-8")
    assert attributes["robot_file_name"] == PUBLISHED.name
    assert attributes["robot"] == "linear-delta-2022"
    assert attributes["version"] == pkmodes.__version__
    assert attributes["rigid_modes"] == 3
    assert attributes["Conventions"].startswith("CF-1.")


def test_the_text_of_a_changed_robot_declares_that_robot(model: pkmodes.Model, tmp_path: Path) -> None:
    changed = model.with_values({"platform.mass": 2.5, "effects.payload.mass": "350 g"})
    text = changed.map({"x": 0.6, "y": 0.0, "z": -0.245}).attrs["robot_file"]
    (tmp_path / "again.toml").write_text(text, encoding="utf-8")
    assert read_robot(tmp_path / "again.toml") == changed.robot


def test_a_pose_that_cannot_be_evaluated_is_nan_and_says_why(
    found: xarray.Dataset, model: pkmodes.Model
) -> None:
    said = set()
    for z in found["z"].values:
        for x in found["x"].values:
            one = found.sel(x=x, z=z, **{"platform.mass": 1.0}).isel(y=2)
            check = model.check([x, float(one["y"]), z])
            assert bool(one["valid"]) == bool(check.valid)
            assert one["reason"].item() == str(check.reason)
            said.add(one["reason"].item())
            for name in ("frequency", "platform_shape", "in_plane", "out_of_plane", "shape", "condition"):
                assert (np.isnan(one[name].values) == (not check.valid)).all(), name
            assert np.isnan(one["static_torque"].values).all() == (not check.valid)
    assert said == {"", "limits", "reachable"}
    for code, sentence in model.reasons.items():
        assert found["reason"].attrs[code] == sentence


@pytest.mark.parametrize("way", EVERY_WAY)
@pytest.mark.parametrize("suffix", [".nc", ".zarr"])
def test_a_file_opened_by_plain_xarray_is_the_dataset_in_memory(
    model: pkmodes.Model, tmp_path: Path, way: str, suffix: str
) -> None:
    kept = model.map(GRID, **EVERY_WAY[way])
    path = tmp_path / f"map{suffix}"
    with model.map(GRID, out=path, **EVERY_WAY[way]) as returned:
        xarray.testing.assert_identical(kept, returned.load())
    with xarray.open_dataset(path) as opened:
        xarray.testing.assert_identical(kept, opened.load())
        assert opened["valid"].dtype == bool
    assert [one.name for one in tmp_path.iterdir()] == [path.name]


def test_a_file_keeps_to_the_conventions_that_it_names(model: pkmodes.Model, tmp_path: Path) -> None:
    """What the CF checker found: coordinates without a fill value, text as characters, a history."""
    import netCDF4

    sweep = {"platform.mass": [1.0, 2.0]}
    model.map(GRID, sweep=sweep, shapes=True, tracked=True, out=tmp_path / "map.nc").close()
    with netCDF4.Dataset(tmp_path / "map.nc") as file:
        assert file.data_model == "NETCDF4"
        for name in file.dimensions:
            if name in file.variables:
                assert not hasattr(file[name], "_FillValue"), name
        assert file["reason"].dtype == np.dtype("S1")
        assert file.history
        assert file["tracking"].flag_masks.dtype == file["tracking"].dtype


def test_tables_hold_one_row_for_each_mode_and_pose(model: pkmodes.Model, tmp_path: Path) -> None:
    import pandas

    kept = model.map(GRID)
    for name in ("map.csv", "map.parquet"):
        returned = model.map(GRID, out=tmp_path / name)
        xarray.testing.assert_identical(kept, returned)
    text, binary = pandas.read_csv(tmp_path / "map.csv"), pandas.read_parquet(tmp_path / "map.parquet")
    pandas.testing.assert_frame_equal(
        text.assign(reason=text["reason"].fillna("")), binary, check_dtype=False, rtol=1e-15
    )
    assert len(text) == 2 * 5 * 9 * 6
    one = kept.isel(x=5, y=3, z=1, mode=1)
    (at,) = np.flatnonzero(
        np.logical_and.reduce([binary[name] == one[name].item() for name in [*GRID, "mode"]])
    )
    row = binary.iloc[at]
    assert row["frequency"] == one["frequency"].item()
    assert row["platform_shape:z"] == one["platform_shape"].sel(direction="z").item()
    assert row["joint_position:x_3"] == one["joint_position"].sel(coordinate="x_3").item()
    assert row["static_torque:1"] == one["static_torque"].sel(drive="1").item()
    assert bool(row["valid"])
    beyond = binary[(binary.x == 0.0) & (binary.z == -0.245)]
    assert set(beyond["reason"]) == {"limits"}
    assert beyond["frequency"].isna().all()


def test_a_list_of_poses_has_one_dimension_and_their_labels(model: pkmodes.Model) -> None:
    poses = [[0.6, 0.0, -0.245], [0.5, 0.05, -0.245], [0.0, 0.0, -0.245]]
    found = model.map(poses)
    assert found["frequency"].dims == ("pose", "mode")
    assert found["pose"].values.tolist() == [0, 1, 2]
    assert np.stack([found[name].values for name in "xyz"], -1).tolist() == poses
    assert all(found[name].dims == ("pose",) for name in "xyz")
    assert found["valid"].values.tolist() == [True, True, False]


def test_shapes_and_events_are_there_only_where_asked_for(model: pkmodes.Model) -> None:
    one = {"x": [0.5, 0.6], "y": 0.0, "z": -0.245}
    plain, tracked = model.map(one), model.map(one, tracked=True)
    assert "shape" not in plain
    assert "shape" not in tracked
    assert "rank" not in plain
    assert {"rank", "tracking"} <= set(tracked)
    assert plain["coordinate"].values.tolist() == ["x_1", "x_2", "x_3"]
    flags = tracked["tracking"].attrs
    assert flags["flag_meanings"].split() == ["crossing", "veering", "uncertain"]
    assert flags["flag_masks"].tolist() == [1, 2, 4]
    assert flags["flag_masks"].dtype == tracked["tracking"].dtype, "as CF asks"
