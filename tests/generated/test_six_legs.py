"""A platform that turns, in every result of a pose: against its legs, written by hand."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from helpers.robots.six_legs import FILE, POSE, hexapod, lengths, motion
from pkmodes.cli import run
from pkmodes.core.base.errors import PoseError
from pkmodes.core.system.motors import _without_influence
from pkmodes.core.system.strain_free import strain_free_motions


def test_the_platform_moves_and_turns_about_base_axes() -> None:
    model, h = hexapod(), 1e-6
    D_p = model.platform_jacobian(POSE)
    for i, axis in enumerate(np.eye(3)):
        for row, shift, turn in ((i, axis, 0.0 * axis), (3 + i, 0.0 * axis, axis)):
            ends = [
                lengths(
                    model,
                    POSE[:3] + sign * h * shift,
                    Rotation.from_rotvec(sign * h * turn) * Rotation.from_rotvec(POSE[3:]),
                )
                for sign in (1.0, -1.0)
            ]
            found = D_p @ ((ends[0] - ends[1]) / (2.0 * h))
            np.testing.assert_allclose(found, np.eye(6)[row], atol=1e-8)


def test_rotations_count_times_the_distance_of_the_joints_from_the_origin() -> None:
    model = hexapod()
    length = np.sqrt((model.robot.parameters.joint**2).sum(axis=1).mean())
    assert model.characteristic_length == pytest.approx(length, rel=1e-12)
    alike = motion(model, POSE) * np.array([1.0, 1.0, 1.0, length, length, length])[:, None]
    assert model.condition(POSE) == pytest.approx(np.linalg.cond(alike), rel=1e-9)


@pytest.mark.parametrize("drives", ["free", "held"])
def test_shapes_of_the_platform_follow_from_the_legs(drives: str) -> None:
    modes = hexapod().modes(POSE, drives=drives)
    np.testing.assert_allclose(
        modes.platform_shapes, modes.shapes[:, :6] @ motion(hexapod(), POSE).T, rtol=1e-9, atol=1e-12
    )


def test_the_inertia_of_held_motors_and_servos_has_no_influence() -> None:
    inert = _without_influence(hexapod().mechanism)
    assert inert.parameters == ("motor_inertia",)
    assert set(inert.effects) == {"gearbox_inertia.", "servo_stiffness."}


def test_amplitudes_are_those_of_displacements_without_a_rotation() -> None:
    model = hexapod()
    modes = model.modes(POSE, drives="held", fields=("frequencies", "shapes", "vibration_amplitudes"))
    # Without strain the motors move as the legs do, and these as the platform shifts without turning.
    shift = np.linalg.inv(motion(model, POSE))[:, :3]
    rigid = np.vstack([shift, shift])
    np.testing.assert_allclose(
        strain_free_motions(model.system, POSE[None])[0, :, :3], rigid, rtol=1e-9, atol=1e-12
    )
    mass, _ = model.matrices(POSE)
    moved = np.linalg.norm(modes.shapes[:, :6] @ motion(model, POSE)[:3].T, axis=1)
    expected = (
        moved[:, None] * np.abs(modes.shapes @ mass @ rigid) / (2.0 * np.pi * modes.frequencies[:, None]) ** 2
    )
    assert modes.vibration_amplitudes.shape == (6, 3)
    np.testing.assert_allclose(modes.vibration_amplitudes, expected, rtol=1e-9)


def test_poses_of_the_command_line_have_units(capsys: pytest.CaptureFixture[str]) -> None:
    pose = "12 mm, -20 mm, 255 mm, 0.11, -0.06, 8.59436692696235 deg"
    assert run(["modes", str(FILE), "--pose", pose, "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)
    np.testing.assert_allclose(found["pose"], POSE, rtol=1e-14)
    assert np.shape(found["platform_shapes"]) == (12, 6)
    assert found["frequencies_hz"] == pytest.approx(hexapod().frequencies(POSE).tolist(), abs=1e-6)


def test_the_table_scales_rotations_to_a_unit_vector_and_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["modes", str(FILE), "--pose", "0,0,0.26,0,0,0", "--drives", "held"]) == 0
    text = capsys.readouterr().out
    rows = {line.split()[0]: line.split()[1:] for line in text.splitlines() if line[:2] in ("p_", "r_")}
    assert list(rows) == ["p_x", "p_y", "p_z", "r_x*L", "r_y*L", "r_z*L"]
    columns = np.array([[float(value) for value in row] for row in rows.values()])
    np.testing.assert_allclose((columns**2).sum(axis=0), 1.0, atol=3e-3)
    assert f"L = {hexapod().characteristic_length:.4g} m" in " ".join(text.split())
    assert "static forces [N]" in text


@pytest.mark.parametrize(
    ("pose", "what"),
    [
        ("0,0,0.25,100 deg,0,0", "90 degrees or more, 0.1745 rad too far"),
        ("0,0,0.25,5,0,0", 'look like degrees: write --pose "0,0,0.25,5 deg,0 deg,0 deg"'),
        ("0,0,250,5,0,0", "look like millimetres and degrees"),
        ("0,0,0.25", "expected 6 components X,Y,Z,RX,RY,RZ, found 3"),
        ("0,0,0.25,5 mm,0,0", "which is a length"),
    ],
)
def test_a_wrong_rotation_is_refused(pose: str, what: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["modes", str(FILE), "--pose", pose]) == 2
    assert what in " ".join(capsys.readouterr().err.split())


def test_a_pose_is_written_with_both_units() -> None:
    with pytest.raises(PoseError, match=r"at \[0, 0, 0.25\] m, \[0, 1.6, 0\] rad"):
        hexapod().modes([0.0, 0.0, 0.25, 0.0, 1.6, 0.0])
