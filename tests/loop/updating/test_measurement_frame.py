"""The measurement frame as a suspect: offset and yaw of all poses."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pkmodes import updating
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.candidates import suspects
from pkmodes.loop.updating.corrected_robot import corrections
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes_rig.measurements import measure
from pkmodes_rig.robots import POSES, read

ROBOT = "tower"
KIND = mechanism("linear_delta")
POINTS = np.array(POSES[ROBOT]["grid"])


def diagnosed(tmp_path: Path, shift: np.ndarray, yaw: float = 0.0):
    robot = read(ROBOT)
    c, s = np.cos(yaw), np.sin(yaw)
    wrong = POINTS @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]).T + shift
    text = measure(
        robot.parameters, POINTS, rng=np.random.default_rng(3), shapes=("x_1", "p_x", "p_y", "p_z")
    )
    lines = text.splitlines()
    labels = [f"P{i + 1}" for i in range(len(POINTS))]
    for k, line in enumerate(lines):
        cells = line.split(",")
        if cells[0] in labels:
            cells[1:4] = [f"{v:.9g}" for v in wrong[labels.index(cells[0])]]
            lines[k] = ",".join(cells)
    path = tmp_path / "modes.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return robot, updating.diagnose(robot, updating.read(path))


def test_poses_that_are_all_too_high_are_found_and_the_robot_is_unchanged(tmp_path: Path) -> None:
    robot, found = diagnosed(tmp_path, np.array([0.0, 0.0, 0.02]))
    assert [e.name for e in found.effects] == ["measurement:offset.z"]
    (value,) = found.effects[0].parameters
    assert value.value == pytest.approx(-0.02, abs=4 * value.sigma)
    assert "shifted along z" in found.reason
    assert not any(name.startswith("measurement") for name in corrections(robot, found))


def test_rotated_poses_are_found(tmp_path: Path) -> None:
    _, found = diagnosed(tmp_path, np.zeros(3), np.radians(-4.0))
    assert len(found.effects) == 1
    assert "measurement:yaw" in found.effects[0].members


@pytest.mark.parametrize("name", list(frame.parameters(KIND)))
def test_rates_with_respect_to_the_frame_agree_with_differences(name: str) -> None:
    robot = read(ROBOT)
    structure = RobotStructure(robot, POINTS[:4], *suspects(robot))
    names = [p.name for p in structure.parameters]
    values = np.array([p.value for p in structure.parameters])
    values[names.index("measurement.yaw")], values[names.index("measurement.offset.z")] = 0.02, -0.01
    i, step = names.index(name), 1e-6
    there, back = values.copy(), values.copy()
    there[i] += step
    back[i] -= step
    a, b = (structure.predict(v, ()).eigenvalues[:, 3:] for v in (there, back))
    found = structure.predict(values, (i,)).rates[:, 3:, 0]
    scale = np.abs(found).max()
    assert found / scale == pytest.approx((a - b) / (2 * step) / scale, abs=1e-6)


def test_poses_are_rotated_first_and_then_shifted() -> None:
    points = np.array([[1.0, 0.0, 0.5]])
    values = {"measurement.yaw": np.pi / 2, "measurement.offset.x": 0.1}
    assert frame.true_points(KIND, points, values) == pytest.approx(np.array([[0.1, 1.0, 0.5]]))
    assert frame.pose_rates(KIND, "measurement.yaw", points, values) == pytest.approx(
        np.array([[-1.0, 0.0, 0.0]])
    )


def test_a_component_of_gravity_that_is_zero_is_not_a_suspect() -> None:
    names = {candidate.name for candidate in suspects(read(ROBOT))[1]}
    assert "parameter:gravity.z" in names
    assert not {"parameter:gravity.x", "parameter:gravity.y"} & names
