"""The numbers of a map, by other ways: pose by pose with NumPy, finite differences, by hand, the published tables."""

from __future__ import annotations

import csv
import itertools
from pathlib import Path

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.commands.adding_a_mechanism import COMMANDS, DECLARED, DEFINITION
from helpers.commands.adding_a_mechanism import ROBOT as FIVE_BAR
from pkmodes.cli import run
from pkmodes.core.mechanism import registry as mechanism
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.solve import mode_fields
from pkmodes.machine.maps.pose_file import read_poses

ROOT = Path(__file__).parents[3]
ROBOTS = ROOT / "robots"
TABLE = ROOT / "docs/studies/published_tables/published-modes.csv"
#: A grid for each mechanism, in part beyond its workspace, and effects that change every mode.
GRIDS = {
    "linear-delta-2022": {"x": [0.0, 0.4, 0.61], "y": [-0.04, 0.07], "z": [-0.31, -0.245]},
    "clavel-delta": {"x": [-0.1, 0.03, 2.0], "y": [0.0, 0.06], "z": [-0.75, -0.7, -0.6]},
    "corexy-printer": {"x": [0.02, 0.21], "y": [0.11, 0.2, 0.9]},
}
EFFECTS = {
    "none": {},
    "payload": {"effects.payload.mass": 0.2},
    "gearboxes and frame": {
        "effects.gearbox_compliance.compliance": 1e-3,
        "effects.frame_compliance.compliance": 1e-7,
    },
    "held": {"effects.servo_stiffness.stiffness": 900.0},
}


def expect_equal_to_single_poses(model: pkmodes.Model, found: xarray.Dataset, names: tuple[str, ...]) -> int:
    """Compare a map with `Model.modes`, `statics` and `condition` at each pose, with NumPy; return the valid ones."""
    axes = [found[name].values for name in names]
    valid = 0
    for point in itertools.product(*axes):
        one = found.sel(dict(zip(names, point, strict=True)))
        if not model.check(point).valid:
            assert not one["valid"]
            continue
        valid += 1
        modes = model.modes(point, backend="numpy", drives=found.attrs["drives"])
        vibration = slice(modes.rigid_modes, None)
        np.testing.assert_allclose(one["frequency"], modes.frequencies[vibration], rtol=1e-9)
        np.testing.assert_allclose(one["platform_shape"], modes.platform_shapes[vibration], atol=1e-6)
        np.testing.assert_allclose(
            one["joint_position"].sel(coordinate=list(model.mechanism.independent)),
            modes.joint_positions,
            rtol=1e-12,
        )
        np.testing.assert_allclose(one["static_torque"], model.statics(point).torques, rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(one["condition"], model.condition(point), rtol=1e-12)
        if "shape" in one:
            shapes = one["shape"].sel(coordinate=list(model.coordinates))
            np.testing.assert_allclose(shapes, modes.shapes[vibration], atol=2e-5)
    return valid


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("robot", GRIDS)
def test_each_pose_has_the_numbers_of_a_single_evaluation(robot: str, effects: str, drives: str) -> None:
    model = pkmodes.load(ROBOTS / f"{robot}.toml")
    known = changeable_units(model.robot)
    model = model.with_values({path: value for path, value in EFFECTS[effects].items() if path in known})
    found = model.map(GRIDS[robot], shapes=True, drives=drives)
    assert found.attrs["drives"] == drives
    assert expect_equal_to_single_poses(model, found, tuple(GRIDS[robot])) >= 4
    assert not found["valid"].values.all()


def test_back_ends_agree() -> None:
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    grid = GRIDS["linear-delta-2022"]
    here, numpy = model.map(grid), model.map(grid, backend="numpy")
    np.testing.assert_allclose(here["frequency"], numpy["frequency"], rtol=1e-10)
    assert (here["reason"] == numpy["reason"]).all()


def test_digits_do_not_depend_on_the_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    grid = {"x": [0.45, 0.5, 0.6, 9.0], "y": np.linspace(-0.05, 0.05, 5), "z": -0.245}
    whole = model.map(grid)
    monkeypatch.setattr(mode_fields, "CHUNK", 4)
    monkeypatch.setattr(mode_fields, "POSES_PER_THREAD", 10)
    parts = model.map(grid)
    assert whole["valid"].sum() == 15
    for name in whole.data_vars:
        if whole[name].dtype == float:
            np.testing.assert_allclose(parts[name], whole[name], rtol=1e-10, atol=1e-12, err_msg=name)


def test_a_map_has_the_published_frequencies() -> None:
    """Tables 1 and 2 of the paper, to the last digit, at the poses identified from them."""
    rows = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    model = pkmodes.load(ROBOTS / "linear-delta-2022-identified.toml")
    found = model.map(read_poses(TABLE, model.mechanism))
    compared = 0
    for row in csv.DictReader(rows):
        at = np.isclose(found["x"], float(row["x"])) & np.isclose(found["y"], float(row["y"]))
        values = found["frequency"].values[at, int(row["mode"]) - 1]
        assert {f"{value:.3f}" for value in values} == {row["frequency"]}
        compared += 1
    assert compared == 12


@pytest.mark.parametrize("robot", GRIDS)
def test_the_condition_number_is_that_of_finite_differences(robot: str) -> None:
    """The Jacobian of the inverse kinematics, by differences, has the same condition number as its inverse."""
    model = pkmodes.load(ROBOTS / f"{robot}.toml")
    found = model.map(GRIDS[robot])
    names = tuple(GRIDS[robot])
    step, compared = 1e-6, 0
    for point in itertools.product(*GRIDS[robot].values()):
        if not model.check(point).valid:
            continue
        moved = np.array(point) + step * np.concatenate([np.eye(len(point)), -np.eye(len(point))])
        ahead, behind = np.split(model.inverse_kinematics(moved), 2)
        inverse = (ahead - behind).T / (2 * step)
        value = found["condition"].sel(dict(zip(names, point, strict=True))).item()
        assert value == pytest.approx(np.linalg.cond(inverse), rel=1e-6)
        assert value >= 1.0
        compared += 1
    assert compared >= 4


def test_motion_is_split_into_the_plane_of_the_grid_and_the_rest() -> None:
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    axes = {"x": [0.4, 0.61], "y": [-0.04, 0.07], "z": [-0.27, -0.245]}
    for normal in (*axes, None):
        # None: three-dimensional, where the plane is xy.
        grid = {name: values[:1] if name == normal else values for name, values in axes.items()}
        found = model.map(grid)
        shape = found["platform_shape"]
        out = shape.sel(direction=normal or "z")
        plane = shape.sel(direction=[name for name in axes if name != (normal or "z")])
        np.testing.assert_allclose(found["out_of_plane"], abs(out), rtol=1e-12)
        np.testing.assert_allclose(found["in_plane"], np.sqrt((plane**2).sum("direction")), rtol=1e-12)
        within = " and ".join(name for name in axes if name != (normal or "z"))
        assert found["out_of_plane"].attrs["long_name"].endswith(f"magnitude in {normal or 'z'}")
        assert found["in_plane"].attrs["long_name"].endswith(f"magnitude in {within}")
        assert found["out_of_plane"].max() > 0.01


def test_a_mechanism_in_a_plane_moves_in_the_plane_only() -> None:
    found = pkmodes.load(ROBOTS / "corexy-printer.toml").map(GRIDS["corexy-printer"])
    size = np.sqrt((found["platform_shape"] ** 2).sum("direction", skipna=False))
    np.testing.assert_allclose(found["in_plane"], size, rtol=1e-12)
    assert (found["out_of_plane"].where(found["valid"], 0.0) == 0.0).all()
    assert np.isnan(found["out_of_plane"].values[~found["valid"].values]).all()


def test_a_mechanism_of_ones_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The five-bar of docs/how-to/adding-a-mechanism.md, against its equations by hand."""
    (tmp_path / "five_bar.py").write_text(DEFINITION, encoding="utf-8")
    (tmp_path / "robot.toml").write_text(FIVE_BAR, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(mechanism, "_package_by_name", {})
    assert run(COMMANDS[0]) == 0
    model = pkmodes.load("robot.toml")
    found = model.map({"x": [-0.1, 0.05], "y": [-0.42, -0.33]})
    assert found["frequency"].dims == ("y", "x", "mode")
    for x, y in itertools.product([-0.1, 0.05], [-0.42, -0.33]):
        frequencies, _ = DECLARED.modes(np.array([x, y]))
        np.testing.assert_allclose(found["frequency"].sel(x=x, y=y), frequencies[2:], rtol=1e-6)
    whole = model.map()
    assert 10_000 < whole["valid"].sum() < 100_000
