"""What ``pkmodes diagnose`` rejects, and how it says so."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.diagnoses.diagnose_command import PUBLISHED, call, edited, files, refusal


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    robot, modes = files(tmp_path)
    absent = tmp_path / "absent"
    refusal(call(absent, modes), "cannot read the robot file: no such file", f"({absent})")
    refusal(call(robot, absent), "cannot read the measurements: no such file", f"({absent})")
    refusal(call(modes, robot), f"the robot file comes first: pkmodes diagnose {robot} {modes}")
    refusal(call(robot, robot), "expected the names of the columns", f"({robot}: line ")
    refusal(call(modes, modes), "not valid TOML")
    refusal(call(tmp_path, modes), "it is a folder")
    refusal(call(robot, tmp_path), "it is a folder")
    refusal(call(robot), "missing argument 'MODES.csv' (pkmodes diagnose)")


@pytest.mark.parametrize(
    ("candidates", "parts"),
    [
        ("paylod", ['unknown candidate "paylod" (--candidates)', 'did you mean "payload"?']),
        ("effects.payload", ['did you mean "payload"?']),
        ("effects.payload.mass", ['did you mean "payload"?']),
        ("axis.span", ['did you mean "parameter:axis.span"?']),
        ("payload,parameter:axis.spn", ['did you mean "parameter:axis.span"?']),
        ("parameter:axis.4.belt.width", ['did you mean "parameter:axis.']),
        ("parameter:platform.mass", ["platform.mass is refitted already: the robot file gives a sigma"]),
        ("parameter:link.mass", ["link.mass is known exactly: the robot file gives a sigma"]),
        ("parameter:axis.2.link.mass", ["link.mass is known exactly"]),
        ("parameter:axis.span", ["axis.span is known exactly"]),
        ("cable_stiffness", ["the effect cable_stiffness is known exactly"]),
        ("servo_stiffness", ["the effect servo_stiffness is refitted already"]),
        ("parameter:effects.servo_stiffness.stiffness", ["is refitted already"]),
        ("parameter:axis.joint_radius", ["a joint that is zero has no direction", "axis.1.joint.x"]),
        ("", ['expected names separated by commas, found "" (--candidates)']),
        (" , ", ["expected names separated by commas", "(--candidates)"]),
    ],
)
def test_candidates_that_cannot_be(tmp_path: Path, candidates: str, parts: list[str]) -> None:
    robot = edited(
        PUBLISHED,
        ('mass = "0.7 kg" ', 'mass = { value = "0.7 kg", sigma = 0 } '),
        ('limits = ["0 m", "1.2 m"]', 'limits = ["0 m", { value = "1.2 m", sigma = 0 }]'),
    )
    robot += '\n[effects.cable_stiffness]\nstiffness = { value = "0 N/m", sigma = 0 }\n'
    robot += '\n[effects.servo_stiffness]\nstiffness = { value = "0 N*m/rad", sigma = "1 N*m/rad" }\n'
    refusal(call(*files(tmp_path, robot), "--candidates", candidates), *parts)


@pytest.mark.parametrize(
    ("holdout", "parts"),
    [
        ("P99", ['no pose is called "P99" (--holdout); labels are: P']),
        ("P1,P99", ['no pose is called "P99"']),
        ("P1,P2,P3,P4", ["every pose is held out"]),
        ("", ['expected names separated by commas, found "" (--holdout)']),
        ('"P1', ["expected names separated by commas", "(--holdout)"]),
    ],
)
def test_poses_that_cannot_be_held_out(tmp_path: Path, holdout: str, parts: list[str]) -> None:
    refusal(call(*files(tmp_path), "--candidates", "payload", "--holdout", holdout), *parts)


@pytest.mark.parametrize("option", ["--json", "--save-robot"])
def test_targets_that_cannot_be_written(tmp_path: Path, option: str) -> None:
    robot, modes = files(tmp_path)
    (tmp_path / "link.toml").symlink_to(robot)
    before = robot.read_bytes(), modes.read_bytes()
    for target in (robot, modes, tmp_path / "link.toml"):
        refusal(call(robot, modes, option, target), "would replace its own input", str(target))
    for target, what in {
        tmp_path: "expected a file, found a folder",
        tmp_path / "absent" / "result": f"the folder {tmp_path / 'absent'} does not exist (",
        "/dev/null/result": "/dev/null is not a folder",
        "": "expected the name of a file",
    }.items():
        refusal(call(robot, modes, option, target), what, f"({option} ")
    assert (robot.read_bytes(), modes.read_bytes()) == before


def test_two_results_do_not_share_a_file(tmp_path: Path) -> None:
    robot, modes = files(tmp_path)
    out = tmp_path / "out"
    answer = call(robot, modes, "--json", out, "--save-robot", tmp_path / "." / "out")
    refusal(answer, "the result and the corrected robot would be the same file")
    refusal(call(robot, modes, "--save-robot", "-"), "expected the name of a file")
    assert not out.exists()
