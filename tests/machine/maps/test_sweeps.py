"""Parameters swept over ranges: each robot of a sweep has the numbers of that robot alone."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
import xarray

import pkmodes
from pkmodes.core.base.errors import PkmodesError

GRID = {"x": [0.45, 0.6], "y": [0.0, 0.05], "z": -0.245}
SERVO, GEARBOX = "effects.servo_stiffness.stiffness", "effects.gearbox_compliance.compliance"
CLAMP = "effects.clamp_compliance.compliance"


def alone(model: pkmodes.Model, values: dict[str, Any], **options: Any) -> xarray.Dataset:
    return model.with_values(values).map(GRID, **options)


def test_every_combination_is_that_robot_alone(model: pkmodes.Model) -> None:
    sweep = {"link.mass": [0.9, 0.5], "platform.mass": [1.0, 1.5, 2.0]}
    found = model.map(GRID, sweep=sweep)
    assert found["frequency"].dims == ("link.mass", "platform.mass", "z", "y", "x", "mode")
    assert found["link.mass"].values.tolist() == [0.9, 0.5], "in the order given"
    for link, platform in itertools.product(*sweep.values()):
        one = alone(model, {"link.mass": link, "platform.mass": platform})
        mine = found.sel({"link.mass": link, "platform.mass": platform})
        for name in one.data_vars:
            np.testing.assert_array_equal(mine[name].values, one[name].values, err_msg=name)


def test_a_task_may_begin_and_end_within_a_robot(
    model: pkmodes.Model, monkeypatch: pytest.MonkeyPatch
) -> None:
    sweep = {"platform.mass": [1.0, 1.5, 2.0]}
    whole = model.map(GRID, sweep=sweep)
    for rows in (1, 3, 5, 11):
        monkeypatch.setattr("pkmodes.machine.maps.mapping.TASK_ROWS", rows)
        # Poses are solved together in lanes, so that rounding depends on their number.
        xarray.testing.assert_allclose(whole, model.map(GRID, sweep=sweep), rtol=1e-10)


def test_a_whole_path_moves_all_its_elements(model: pkmodes.Model) -> None:
    found = model.map(GRID, sweep={"axis.span": [1.2, 1.4]})
    one = alone(model, {"axis.span": 1.4})
    np.testing.assert_array_equal(found["frequency"].sel({"axis.span": 1.4}), one["frequency"])
    assert (found["frequency"].sel({"axis.span": 1.2, "mode": 1}) > one["frequency"].sel(mode=1)).all()
    assert found["axis.span"].attrs["units"] == "m"


def test_an_effect_from_zero_adds_modes_and_coordinates(model: pkmodes.Model) -> None:
    """The declared robot has six vibration modes, that with compliant gearboxes nine."""
    found = model.map(GRID, sweep={GEARBOX: [0.0, 1e-4]}, shapes=True)
    without, has = found.sel({GEARBOX: 0.0}), found.sel({GEARBOX: 1e-4})
    assert found.sizes["mode"] == 9
    assert found.sizes["coordinate"] == 12
    assert np.isnan(without["frequency"].isel(mode=slice(6, None))).all()
    assert not np.isnan(has["frequency"]).any()
    np.testing.assert_array_equal(without["frequency"].isel(mode=slice(6)), alone(model, {})["frequency"])
    one = alone(model, {GEARBOX: 1e-4}, shapes=True)
    np.testing.assert_array_equal(has["frequency"], one["frequency"])
    np.testing.assert_array_equal(has["shape"], one["shape"])
    released = found["coordinate"].values[9:]
    still = without["shape"].sel(coordinate=released).isel(mode=slice(6))
    assert (still == 0.0).all(), "a joint that is locked does not move"
    assert np.isnan(without["shape"].isel(mode=slice(6, None))).all()


def test_modes_and_coordinates_do_not_depend_on_the_order_of_the_robots(model: pkmodes.Model) -> None:
    """The robot with the most modes may come first or last, and joints keep the order of the description."""
    poses = {**GRID, "x": [0.6, 9.0]}
    ways = {GEARBOX: [0.0, 1e-4], CLAMP: [0.0, 1e-7]}
    both = model.with_values({path: values[-1] for path, values in ways.items()})
    for paths in itertools.permutations(ways):
        found = model.map(poses, sweep={path: ways[path] for path in paths}, shapes=True)
        back = model.map(poses, sweep={path: ways[path][::-1] for path in paths}, shapes=True)
        assert found["coordinate"].values.tolist() == list(both.modes([0.6, 0.0, -0.245]).coordinates)
        xarray.testing.assert_allclose(found, back.isel({path: slice(None, None, -1) for path in paths}))
        assert np.isnan(found["shape"].sel(x=9.0)).all(), "nothing is known where a pose is out of reach"


def test_servos_that_hold_the_platform_leave_no_rigid_modes(model: pkmodes.Model) -> None:
    """Mode 1 is the first vibration mode of each robot; how many rigid ones are left out is said for each."""
    found = model.map(GRID, sweep={SERVO: [0.0, 900.0]})
    assert found.attrs["rigid_modes"] == 3, "of the robot as declared"
    assert found["rigid_modes"].dims == (SERVO,)
    assert found["rigid_modes"].values.tolist() == [3, 0]
    assert found["rigid_modes"].attrs["long_name"]
    held = model.with_values({SERVO: 900.0}).frequencies([0.45, 0.0, -0.245])
    np.testing.assert_allclose(
        found["frequency"].sel({SERVO: 900.0, "x": 0.45, "y": 0.0}).squeeze(), held, rtol=1e-10
    )
    free = found["frequency"].sel({SERVO: 0.0})
    assert np.isnan(free.isel(mode=slice(6, None))).all()
    assert "rigid_modes" not in model.map(GRID, sweep={"platform.mass": [1.0, 2.0]})


def test_poses_outside_the_workspace_of_one_robot_only(model: pkmodes.Model) -> None:
    found = model.map(GRID, sweep={"link.length": [0.2, 0.4]})
    assert not found["valid"].sel({"link.length": 0.2}).any()
    assert (found["reason"].sel({"link.length": 0.2}) == "reachable").all()
    assert found["valid"].sel({"link.length": 0.4}).all()


@pytest.mark.parametrize(
    ("sweep", "what", "where"),
    [
        ({"platform.mas": [1.0]}, 'unknown parameter path "platform.mas"', "linear-delta-2022.toml"),
        ({"platform.mass": []}, "expected at least one value", "sweep: platform.mass"),
        ({"platform.mass": [1.0, 2.0, 1.0]}, "the value 1 is repeated", "sweep: platform.mass"),
        ({"platform.mass": [3.0, 1.0, 2.0, 2.0]}, "the value 2 is repeated", "sweep: platform.mass"),
        ({"platform.mass": [1.0, float("nan")]}, "expected finite values", "sweep: platform.mass"),
        ({"platform.mass": ["1 kg"]}, "expected numbers in SI units", "sweep: platform.mass"),
        ({"platform.mass": [-1.0, 1.0]}, "-1", "platform.mass"),
        ({"platform.mass": None}, "expected a list", "sweep: platform.mass"),
        (["platform.mass"], "expected values by path", "sweep"),
        ({"axis.span": [1.2], "axis.1.limits.max": [1.3]}, "changed twice", "axis.1.limits.max"),
    ],
)
def test_bad_sweeps(model: pkmodes.Model, sweep: Any, what: str, where: str) -> None:
    with pytest.raises(PkmodesError) as error:
        model.map(GRID, sweep=sweep)
    assert what in error.value.what
    assert where in error.value.where
    assert "numpy.linspace(0.3" not in error.value.remedy, "an example of a grid"


def test_no_mode_is_tracked_across_robots_with_different_coordinates(model: pkmodes.Model) -> None:
    with pytest.raises(PkmodesError, match="cannot be tracked across robots with different coordinates"):
        model.map(GRID, sweep={GEARBOX: [0.0, 1e-4]}, tracked=True)
