"""Responses, moves, maps and measurements of a platform that turns."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from helpers.robots.six_legs import POSE, hexapod, motion
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.candidates import suspects
from pkmodes.loop.updating.channels import channels, sensors
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes.machine.maps.workspace import box_of, fixed_components
from pkmodes.pages.plots import maps
from pkmodes.pages.plots.plane import Plane, plane_location

#: A robot of which gravity and legs have no part in the equations.
LIGHT: dict[str, float | str] = {
    "gravity.z": 0.0,
    "leg.base_mass": 1e-9,
    "leg.base_inertia": 0.0,
    "leg.rod_mass": 1e-9,
    "leg.rod_inertia": 0.0,
    "platform.center.z": 0.0,
    "damping.ratio": 0.2,
}


def test_forces_and_moments_turn_the_platform_as_its_legs_give_way() -> None:
    model = hexapod({"gravity.z": 0.0})
    D = motion(model, POSE)
    expected = D @ D.T / 1.2e7
    np.testing.assert_allclose(model.compliance(POSE), expected, rtol=1e-9, atol=1e-16)
    found = model.frf(POSE, [0.0], ["force_x", "moment_y"], ["r_z", "p_x", {"up": [0, 0, 2]}], drives="held")
    np.testing.assert_allclose(
        found.values[0].real, expected[np.ix_([5, 0, 2], [0, 4])], rtol=1e-9, atol=1e-16
    )
    assert found.units == (("rad/N", "rad/(N m)"), ("m/N", "m/(N m)"), ("m/N", "m/(N m)"))
    driven = model.frf(POSE, [20.0], ["torque_1"], ["motor_1"])
    assert driven.units == (("m/N",),)
    with pytest.raises(PkmodesError, match=r'unknown name "moment_rx"'):
        model.frf(POSE, [20.0], ["moment_rx"], ["p_x"])


def test_a_platform_that_is_turned_lags_behind_by_its_moment_of_inertia() -> None:
    model, rate = hexapod(LIGHT), 4.0
    time = np.arange(0.0, 0.06, 1e-4)
    axis = np.array([0.6, -0.48, 0.64])
    turned = Rotation.from_rotvec(0.5 * rate * time[:, None] ** 2 * axis) * Rotation.from_rotvec(POSE[3:])
    poses = np.hstack([np.tile(POSE[:3], (len(time), 1)), turned.as_rotvec()])
    end = poses[-1]
    lag = model.simulate(time, poses).deviation[-1]
    # Of a vibration that has died away: -compliance times what accelerates the body, about base axes.
    inertia = turned[-1].as_matrix() @ np.diag([0.045, 0.045, 0.085]) @ turned[-1].as_matrix().T
    wrench = np.concatenate([np.zeros(3), inertia @ (rate * axis)])
    D = motion(model, end)
    np.testing.assert_allclose(lag, -D @ D.T / 1.2e7 @ wrench, atol=0.02 * np.abs(lag).max())


def test_maps_leave_rotations_as_they_are() -> None:
    model = hexapod()
    found = model.map({"x": [0.0, 0.02], "y": 0.0, "z": 0.26}, drives="held")
    assert {name: found.sizes[name] for name in ("x", "rx", "ry", "rz")} == {
        "x": 2,
        "rx": 1,
        "ry": 1,
        "rz": 1,
    }
    assert found["direction"].values.tolist() == ["x", "y", "z", "rx", "ry", "rz"]
    amplitude = found["vibration_amplitude"].squeeze()
    assert np.isfinite(amplitude.sel(direction=["x", "y", "z"])).all()
    assert np.isnan(amplitude.sel(direction=["rx", "ry", "rz"])).all()
    assert found["static_torque"].attrs == {
        "units": "N",
        "long_name": "force that holds the pose against gravity",
    }
    modes = model.modes([0.02, 0.0, 0.26, 0.0, 0.0, 0.0], drives="held")
    np.testing.assert_allclose(
        found["platform_shape"].sel(x=0.02).squeeze(), modes.platform_shapes, rtol=1e-9, atol=1e-12
    )
    with pytest.raises(PkmodesError, match="found none of y"):
        model.map({"x": 0.0, "z": 0.26})


def test_the_workspace_is_that_of_a_platform_that_stands_and_does_not_turn(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("pkmodes.machine.maps.workspace.DRAWS_PER_ROUND", 20_000)
    model = hexapod()
    low, high = box_of(model)
    assert low[2] > 0.15  # below the base is another assembly of the same legs
    np.testing.assert_array_equal([low[3:], high[3:]], 0.0)
    assert low[2] == pytest.approx(0.2, abs=0.01)
    assert fixed_components(model, POSE) == {3: POSE[3], 4: POSE[4], 5: POSE[5]}


def test_pictures_of_a_plane_of_rotations_draw_no_directions() -> None:
    tilt = np.radians([-2.0, 0.0, 2.0])
    dataset = hexapod().map({"x": 0.0, "y": 0.01, "z": 0.26, "rx": tilt, "ry": tilt})
    plane = Plane.of(dataset, [c.name for c in hexapod().mechanism.pose])
    assert (plane.normal, plane.is_linear, plane.area) == (None, False, None)
    assert plane_location(plane) == "x = 0 mm, y = 10 mm, z = 260 mm"
    assert maps.directions(plane) == maps.components(plane) == maps.NO_DIRECTIONS_SENTENCE


def test_measured_shapes_may_have_rotations_which_change_with_the_pose_as_differences_say() -> None:
    robot = hexapod().robot
    known = channels(robot.mechanism)
    assert {name: known[name] for name in ("p_x", "r_x", "l_1")} == {"p_x": "m", "r_x": "rad", "l_1": "m"}
    assert [one.channels for one in sensors(robot.mechanism)][:2] == [
        ("p_x", "p_y", "p_z"),
        ("r_x", "r_y", "r_z"),
    ]
    parameters, candidates, moves = suspects(robot, ["payload"], None)
    structure = RobotStructure(robot, POSE[None], parameters, candidates, moves)
    rates = structure.position_rates(np.array([p.value for p in parameters]), shape_rates=True)
    assert rates.shape_rates is not None
    columns = [structure.channels.index(name) for name in ("p_x", "r_x", "r_z")]
    h = 1e-6
    for i in (0, 3, 5):
        ends = []
        for sign in (1.0, -1.0):
            modes = hexapod().modes(POSE + sign * h * np.eye(6)[i])
            ends.append((modes.frequencies[6:], modes.platform_shapes[6:][:, [0, 3, 5]]))
        change = (ends[0][1] - ends[1][1]) / (2.0 * h)
        np.testing.assert_allclose(
            rates.shape_rates[0, 6:, columns, i].T, change, atol=2e-5 * np.abs(change).max()
        )


def test_a_frame_that_is_rotated_turns_the_platform() -> None:
    mechanism, h = hexapod().mechanism, 1e-6
    points = np.array([POSE, -POSE])
    true = frame.true_points(mechanism, points, {frame.YAW: 0.03})
    turn = Rotation.from_rotvec([0.0, 0.0, 0.03])
    np.testing.assert_allclose(true[:, :3], turn.apply(points[:, :3]), atol=1e-15)
    np.testing.assert_allclose(
        true[:, 3:], (turn * Rotation.from_rotvec(points[:, 3:])).as_rotvec(), atol=1e-15
    )
    ends = [frame.true_points(mechanism, points, {frame.YAW: 0.03 + sign * h}) for sign in (1.0, -1.0)]
    found = frame.pose_rates(mechanism, frame.YAW, points, {frame.YAW: 0.03})
    np.testing.assert_allclose(found, (ends[0] - ends[1]) / (2.0 * h), atol=1e-9)
