"""The contract of the command line, JSON keys, error lines and exit codes, and ``pkmodes modes``."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

import pkmodes
from helpers.commands.answers import refused
from helpers.robots.one_of_each import ROBOTS
from helpers.robots.robot_text import PUBLISHED, edited
from helpers.runs.processes import ROOT, environment
from pkmodes.cli import run

pytestmark = pytest.mark.usefixtures("backend")

ROBOT = str(PUBLISHED)
POSE = "0.6,0.03,-0.245"
SPRINGS = '\n[effects.servo_stiffness]\nstiffness = "{} N*m/rad"\n'


@pytest.mark.parametrize("drives", ["free", "held"])
def test_json_holds_the_numbers_of_the_model(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], drives: str
) -> None:
    """Its keys and what is printed are frozen in tests/golden/modes."""
    out = tmp_path / "modes.json"
    arguments = ["modes", ROBOT, "--pose", POSE, "--drives", drives, "--json"]
    assert run([*arguments, str(out)]) == 0
    printed = capsys.readouterr().out
    assert printed.startswith(f"linear-delta-2022 at [0.6, 0.03, -0.245] m, motors {drives}\n")
    assert ("rigid" in printed) == (drives == "free")
    content = json.loads(out.read_text(encoding="utf-8"))
    model, pose = pkmodes.load(ROBOT), [0.6, 0.03, -0.245]
    result = model.modes(pose, drives=drives)
    assert (content["robot"], content["pose"], content["drives"]) == ("linear-delta-2022", pose, drives)
    assert content["rigid_modes"] == (3 if drives == "free" else 0)
    joints = ["x_1", "x_2", "x_3"]
    assert content["coordinates"] == joints + [f"theta_{j}_{k}" for k in (1, 2) for j in (1, 2, 3)]
    np.testing.assert_array_equal(content["frequencies_hz"], result.frequencies)
    for name in ("shapes", "platform_shapes", "mass_matrix", "stiffness_matrix"):
        np.testing.assert_array_equal(content[name], getattr(result, name))
    np.testing.assert_array_equal(content["static_torques"], model.statics(pose).torques)
    np.testing.assert_array_equal(content["carriage_positions"], result.joint_positions)
    assert content["joint_positions"] == dict(zip(joints, content["carriage_positions"], strict=True))
    assert run([*arguments, "-"]) == 0
    assert capsys.readouterr() == (json.dumps(content, indent=1) + "\n", "")


def test_the_table_shows_every_mode_and_coordinate(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["modes", ROBOT, "--pose", POSE]) == 0
    out = capsys.readouterr().out
    frequencies = pkmodes.load(ROBOT).modes([0.6, 0.03, -0.245]).frequencies
    assert all(f"{f:.3f}" in out for f in frequencies[3:])
    for label in ("rigid", "x_1/R_p", "theta_3_2", "p_z", "static torques [N m]", "carriage positions [m]"):
        assert label in out
    assert max(map(len, out.splitlines())) <= 80


def test_a_dataset_of_modes_says_what_the_motors_do() -> None:
    modes = pkmodes.load(ROBOT).modes([0.6, 0.03, -0.245], drives="held")
    dataset = modes.to_dataset()
    assert dataset.attrs["drives"] == "held"
    assert dataset.sizes["mode"] == 6


def test_a_pose_may_be_given_with_units(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["modes", ROBOT, "--pose", "600 mm, 30 mm, -245 mm", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["pose"] == [0.6, 0.03, -0.245]


MISTAKES = [
    (["modes", ROBOT, "--pose", "0.6,0"], "expected 3 components X,Y,Z, found 2 (--pose)"),
    (
        ["modes", ROBOT, "--pose", "0.6,0,zero"],
        'found "zero", which does not begin with a number (--pose)',
    ),
    (["modes", ROBOT, "--pose", "0.6,0,1 kg"], "which is a mass (--pose)"),
    (["modes", ROBOT, "--pose", "nan,0,0"], "expected finite coordinates"),
    (["modes", ROBOT, "--pose", "9,9,9"], "the pose is out of reach: link"),
    (["modes", ROBOT, "--pose", "0,1e200,0"], "the pose is out of reach: link 1 is far too short"),
    (["modes", ROBOT, "--pose", "1e200,0,0"], "the pose is singular"),
    (
        ["modes", ROBOT, "--pose", "-1e308,1e308,1e308"],
        "the pose is out of reach: link 1 is far too short",
    ),
    (
        ["modes", ROBOT, "--pose", "0.6,0,0"],
        "the condition number of D_l is inf (pose 0 at [0.6, 0, 0] m)",
    ),
    (
        ["modes", ROBOT, "--pose", "600, 0,-2.45e2"],
        '(--pose); the numbers look like millimetres: write --pose "600 mm,0 mm,-2.45e2 mm"',
    ),
    (["sensitivities", ROBOT, "--pose", "600,0,-245"], 'write --pose "600 mm,0 mm,-245 mm"'),
    (
        ["modes", str(ROOT / "robots/corexy-printer.toml"), "--pose", "250,200"],
        'write --pose "250 mm,200 mm"',
    ),
    (
        ["modes", str(ROOT / "robots/corexy-printer.toml"), "--pose", "0.31,0.2"],
        "beyond the upper end of its travel along x by 0.01 m (pose 0 at [0.31, 0.2] m)",
    ),
    (["modes", ROBOT, "--pose", "600 m,0,-245"], "the pose is out of reach: link"),
    (["modes", ROBOT, "--pose", "0.1,0,-0.245"], "carriage 2 is beyond its limits"),
    (["modes", "absent.toml", "--pose", POSE], "cannot read the robot file: no such file"),
    (["modes", ROBOT], "missing option '--pose' (pkmodes modes)"),
    (["modes", "--pose", POSE], "missing argument 'ROBOT.toml' (pkmodes modes)"),
    (
        ["modes", ROBOT, "--pose", POSE, "--pose=9,9,9"],
        "option '--pose' is given more than once (pkmodes modes)",
    ),
    (["modes", "--pose", POSE, ROBOT, "--pose", POSE], "option '--pose' is given more than once"),
    (["generate", ROBOT, "--out", "a", "--out", "b"], "option '--out' is given more than once"),
    (["modes", ROBOT, "--pose", POSE, "--zzz"], "no such option"),
    (["modes", ROBOT, "--pose", POSE, "--drives", "off"], "'free', 'held'"),
    (["modez"], "no such command 'modez'"),
    (
        ["modes", ROBOT, "--pose", POSE, "--json", "/dev/null/x.json"],
        "/dev/null is not a folder (--json",
    ),
    (["generate", ROBOT], "missing option '--out' (pkmodes generate)"),
    (["generate", "absent.toml", "--out", "x"], "cannot read the robot file"),
    (["check", "absent"], "no such file or folder (absent)"),
]


def test_mistakes_are_one_error_line_and_exit_code_2(subtests: pytest.Subtests) -> None:
    for arguments, message in MISTAKES:
        with subtests.test(arguments=arguments):
            assert message in refused(*arguments)


def test_a_wrong_robot_file_gives_one_error_line_for_each_problem(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "robot.toml"
    path.write_text(edited("driven_pulley = 1", "driven_puley = 1"), encoding="utf-8")
    assert run(["modes", str(path), "--pose", POSE]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 2  # one key is missing, and another is unknown
    assert all(line.startswith("error: ") and str(path) in line for line in lines)
    assert any('did you mean "driven_pulley"?' in line for line in lines)


def test_nothing_is_written_when_the_pose_is_bad(tmp_path: Path) -> None:
    out = tmp_path / "modes.json"
    out.write_text("before", encoding="utf-8")
    assert run(["modes", ROBOT, "--pose", "9,9,9", "--json", str(out)]) == 2
    assert out.read_text(encoding="utf-8") == "before"
    assert list(tmp_path.iterdir()) == [out]


def test_help_and_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["--help"]) == 0
    assert "modes" in capsys.readouterr().out
    assert run(["--version"]) == 0
    assert capsys.readouterr().out.strip() == f"pkmodes {pkmodes.__version__}"
    assert run([]) == 2


def test_a_closed_pipe_is_no_error() -> None:
    command = [sys.executable, "-m", "pkmodes", "modes", ROBOT, "--pose", POSE, "--json", "-"]
    with subprocess.Popen(
        command, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == b""


def test_under_the_table_stands_which_motors_it_is_of(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By hand: the bed of 1 kg at y = 0.1 m on its two runs, and its rotor; x is stiffer."""
    k = 6e-3 * 2.6e6 * (1.0 / 0.18 + 1.0 / 0.56)
    radius, inertia, servo = 5.09e-3, 5.5e-6, 12.0
    M = np.diag([1.0, inertia])
    K = k * np.array([[1.0, radius], [radius, radius**2]])
    held = np.sqrt(k) / (2.0 * np.pi)
    free, springs = (
        np.sqrt(eigh(K + np.diag([0.0, stiffness]), M, eigvals_only=True)[i]) / (2.0 * np.pi)
        for stiffness, i in ((0.0, 1), (servo, 0))
    )
    text, first = (
        (ROBOTS / "bed-slinger.toml").read_text(encoding="utf-8"),
        "the first mode of vibration is at",
    )
    for more, drives, said in (
        ("", "free", f"motors free; with their shafts held {first} {held:.4g} Hz"),
        ("", "held", f"motors held; turning freely {first} {free:.4g} Hz"),
        (
            SPRINGS.format(servo),
            "free",
            f"motors on their servo stiffness; with their shafts held {first} {held:.4g} Hz",
        ),
        (
            SPRINGS.format(servo),
            "held",
            f"motors held; on their servo stiffness {first} {springs:.4g} Hz",
        ),
    ):
        (tmp_path / "robot.toml").write_text(text + more, encoding="utf-8")
        assert run(["modes", str(tmp_path / "robot.toml"), "--pose", "0.1,0.1", "--drives", drives]) == 0
        _, _, under = capsys.readouterr().out.partition("\n\n")[2].partition("\n\n")
        assert " ".join(under.split()).startswith(f"{said} p: direction")


def test_motions_at_rest_are_not_the_first_mode_of_vibration(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of a hexapod without weight a cable holds three motions of free motors; three are at 0 Hz, to rounding."""
    text = (ROBOTS / "hexapod.toml").read_text(encoding="utf-8")
    assert text.count('"-9.81 m/s^2"') == 1
    cable = '\n[effects.cable_stiffness]\nstiffness = "20000 N/m"\n'
    (tmp_path / "robot.toml").write_text(text.replace('"-9.81 m/s^2"', "0") + cable, encoding="utf-8")
    pose = "0.01,0,0.24,0.05,-0.01,0.05"
    assert run(["modes", str(tmp_path / "robot.toml"), f"--pose={pose}", "--drives", "held"]) == 0
    said = capsys.readouterr().out.partition("turning freely the first mode of vibration is at ")[2]
    assert 0.3 < float(said.split()[0]) < 2.0


def test_nothing_stands_there_where_the_motors_make_no_difference(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Springs so stiff that they hold the motors."""
    text = (ROBOTS / "bed-slinger.toml").read_text(encoding="utf-8")
    (tmp_path / "robot.toml").write_text(text + SPRINGS.format(1e5), encoding="utf-8")
    assert run(["modes", str(tmp_path / "robot.toml"), "--pose", "0.1,0.1"]) == 0
    assert "shafts" not in capsys.readouterr().out
