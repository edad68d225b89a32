"""Variables that only some maps have: damping, and what holds of held motors."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.commands.map_runs import done_in
from helpers.robots.one_of_each import load_free
from pkmodes.machine.maps import mapping, running
from pkmodes.machine.maps.evaluating import Task

ROBOTS = Path(__file__).parents[3] / "robots"
GRIDS = {
    "linear-delta-2022": {"x": [0.0, 0.4, 0.61], "y": [-0.04, 0.07], "z": -0.245},
    "clavel-delta": {"x": [-0.1, 0.03, 2.0], "y": [0.0, 0.06], "z": -0.7},
    "corexy-printer": {"x": [0.02, 0.21], "y": [0.11, 0.2, 0.9]},
}
DAMPING = {"damping.ratio": 0.02, "effects.drive_friction.viscous": 2e-3}
JOINTS = {"effects.frame_compliance.compliance": 1e-7, "effects.payload.mass": 0.2}
OF_DAMPING, OF_HELD = {"damping_ratio"}, {"vibration_amplitude", "softest_stiffness"}


def model_of(robot: str, values: dict[str, float] | None = None) -> pkmodes.Model:
    return load_free(f"{robot}.toml").with_values(values or {})


def points_of(found: xarray.Dataset, model: pkmodes.Model) -> np.ndarray:
    """The poses of a map on a grid, (poses, d)."""
    names = [component.name for component in model.mechanism.pose]
    leading = found["condition"].dims
    axes = np.meshgrid(*(found[name].values for name in leading), indexing="ij")
    return np.stack([axes[leading.index(name)].ravel() for name in names], axis=-1)


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("values", [DAMPING, JOINTS, DAMPING | JOINTS])
@pytest.mark.parametrize("robot", GRIDS)
def test_each_pose_has_the_numbers_of_a_single_evaluation(
    robot: str, values: dict[str, float], drives: str
) -> None:
    model = model_of(robot, values)
    found = model.map(GRIDS[robot], drives=drives)
    wanted = (OF_DAMPING if "damping.ratio" in values else set()) | (OF_HELD if drives == "held" else set())
    assert {*found} & (OF_DAMPING | OF_HELD) == wanted
    assert found.attrs["drives"] == drives
    count = 0
    for i, p in enumerate(points_of(found, model)):
        at = np.unravel_index(i, found["condition"].shape)
        one = found.isel(dict(zip(found["condition"].dims, at, strict=True)))
        if not one["valid"]:
            assert all(np.isnan(one[name]).all() for name in wanted)
            continue
        count += 1
        modes = model.modes(p, drives=drives, backend="numpy")
        rigid = modes.rigid_modes
        if "damping_ratio" in wanted:
            np.testing.assert_allclose(one["damping_ratio"], modes.damping_ratios[rigid:], rtol=1e-7)
            assert (one["damping_ratio"] >= 0.02 * (1.0 - 1e-12)).all()
        if drives == "held":
            amplitudes = modes.vibration_amplitudes[rigid:]
            np.testing.assert_allclose(
                one["vibration_amplitude"], amplitudes, rtol=1e-6, atol=1e-8 * amplitudes.max()
            )
            directions = model.mechanism.directions
            inputs, outputs = ([f"{kind}_{name}" for name in directions] for kind in ("force", "p"))
            response = model.with_values({path: 0.0 for path in values if path in DAMPING}).frf(
                p, [0.0], inputs, outputs, drives="held"
            )
            softest = np.linalg.eigvals(np.linalg.inv(response.values[0].real)).real.min()
            np.testing.assert_allclose(one["softest_stiffness"], softest, rtol=1e-8)
    assert count >= 4


def test_units_and_dimensions() -> None:
    found = model_of("linear-delta-2022", DAMPING).map(GRIDS["linear-delta-2022"], drives="held")
    assert found["damping_ratio"].dims == ("z", "y", "x", "mode")
    assert found["vibration_amplitude"].dims == ("z", "y", "x", "mode", "direction")
    assert found["softest_stiffness"].dims == ("z", "y", "x")
    units = {name: found[name].attrs["units"] for name in OF_DAMPING | OF_HELD}
    assert units == {"damping_ratio": "1", "vibration_amplitude": "s^2", "softest_stiffness": "N/m"}


@pytest.mark.parametrize("shapes", [False, True])
def test_a_map_of_a_robot_that_dissipates_nothing_with_free_motors_has_none(shapes: bool) -> None:
    found = model_of("linear-delta-2022").map(GRIDS["linear-delta-2022"], shapes=shapes)
    assert not {*found} & (OF_DAMPING | OF_HELD)


def test_a_sweep_has_damping_if_any_of_its_robots_dissipates() -> None:
    model, grid = model_of("corexy-printer"), GRIDS["corexy-printer"]
    swept = model.map(grid, sweep={"damping.ratio": [0.0, 0.01]})["damping_ratio"]
    valid = model.map(grid)["valid"]
    for ratio in (0.0, 0.01):
        wanted = np.where(valid, ratio, np.nan)[..., None].repeat(2, -1)
        np.testing.assert_allclose(swept.sel({"damping.ratio": ratio}), wanted, rtol=1e-12)
    assert "damping_ratio" not in model.map(grid, sweep={"toolhead.mass": [0.4, 0.5]})
    viscous = model.map(grid, sweep={"effects.drive_friction.viscous": [0.0, 1e-3]})["damping_ratio"]
    assert (viscous.isel({viscous.dims[0]: 1}).values[valid] > 0.0).all()


def test_samples_of_a_damping_ratio_have_their_own() -> None:
    model = model_of("corexy-printer").with_values({"damping.ratio": {"value": 0.02, "sigma": 0.002}})
    found = model.map({"x": 0.1, "y": 0.1}, samples=5, seed=3)
    np.testing.assert_allclose(
        found["damping_ratio"].squeeze(), found["damping.ratio"].values[:, None].repeat(2, 1), rtol=1e-12
    )
    assert np.ptp(found["damping.ratio"].values) > 0.0


@pytest.mark.parametrize("name", ["map.nc", "map.zarr", "map.csv", "map.parquet"])
@pytest.mark.parametrize("options", [{}, {"tracked": True}, {"shapes": True}])
def test_files_and_an_interrupted_map_hold_what_a_whole_one_does(
    name: str, options: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    model = model_of("linear-delta-2022", DAMPING)
    how: Any = {"grid": {"x": np.linspace(0.3, 0.8, 12), "y": [0.0, 0.05], "z": -0.245}, "drives": "held"}
    monkeypatch.setattr(mapping, "TASK_ROWS", 5)
    whole = model.map(**how, **options)
    honest, begun = running.evaluate, 0

    def stopping(task: Task) -> dict[str, np.ndarray]:
        nonlocal begun
        begun += 1
        if begun == 3:
            raise KeyboardInterrupt
        return honest(task)

    monkeypatch.setattr(running, "evaluate", stopping)
    with pytest.raises(KeyboardInterrupt):
        model.map(**how, **options, out=tmp_path / name, threads=1)
    assert done_in(tmp_path / name) >= 1
    with model.map(**how, **options, out=tmp_path / name, threads=1) as found:
        xarray.testing.assert_identical(found.load(), whole)
    assert not (tmp_path / f"{name}.partial").exists()
    assert begun < 3 + 5, "what was done is not done again"
    if name == "map.csv":
        columns = (tmp_path / name).read_text(encoding="utf-8").partition("\n")[0].split(",")
        assert {"damping_ratio", "vibration_amplitude:x", "softest_stiffness"} <= {*columns}


@pytest.mark.parametrize("name", [None, "map.nc"])
def test_tracked_amplitudes_follow_their_modes_and_stay_positive(name: str | None, tmp_path: Path) -> None:
    model, grid = (
        model_of("linear-delta-2022", DAMPING),
        {"x": np.linspace(0.3, 0.8, 40), "y": 0.0, "z": -0.245},
    )
    plain = model.map(grid, drives="held")
    with model.map(grid, drives="held", tracked=True, out=name and tmp_path / name) as tracked:
        rank = tracked["rank"].values.astype(int) - 1
        assert (rank != np.arange(6)).any()
        for variable in ("damping_ratio", "vibration_amplitude"):
            further = (..., *[None] * (plain[variable].ndim - rank.ndim))
            wanted = np.take_along_axis(plain[variable].values, rank[further], axis=rank.ndim - 1)
            np.testing.assert_array_equal(tracked[variable].values, wanted)
        assert (tracked["vibration_amplitude"].values >= 0.0).all()


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("values", [{}, DAMPING])
def test_modes_at_hand_have_the_variables_of_a_map(values: dict[str, float], drives: str) -> None:
    model, points = model_of("linear-delta-2022", values), [[0.6, 0.0, -0.245], [0.0, 0.0, 0.0]]
    found = model.modes(points, "nan", drives=drives).to_dataset()
    whole = model.map(points, shapes=True, drives=drives)
    assert {*whole} - {*found} == {"static_torque", "condition"} | ({*whole} & {"softest_stiffness"})
    assert {*found} <= {*whole}
    for name in {*found} & (OF_DAMPING | OF_HELD):
        assert found[name].attrs == whole[name].attrs
        np.testing.assert_allclose(found[name], whole[name], rtol=1e-9)
    table = model.modes(points, "nan", drives=drives).to_table()
    assert ("vibration_amplitude:z" in table) == (drives == "held")
    assert ("damping_ratio" in table) == bool(values)
