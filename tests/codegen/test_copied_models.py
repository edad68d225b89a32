"""Models copied without their robot file, and the robots that their manifests record."""

from __future__ import annotations

import json
import math
import shutil
from pathlib import Path

import numpy as np
import pytest

from helpers.commands.answers import refused
from helpers.generated.generated_model import MODULE
from helpers.robots.robot_text import published
from pkmodes.cli import run
from pkmodes.codegen.checking.products import recorded_robot
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.reading import read_robot
from pkmodes_rig.robots import ROBOTS

EFFECTS = '\n[effects.frame_compliance]\ncompliance = "1e-7 m/N"\n\n[effects.payload]\nmass = "0.35 kg"\n'


@pytest.fixture
def vendored(copy: Path) -> Path:
    """A copy of the model without the robot file."""
    return Path(shutil.move(copy / "model", copy.parent / "vendored"))


def test_a_copied_model_is_checked_without_its_robot_file(
    vendored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["check", str(vendored)]) == 0
    out = capsys.readouterr().out
    assert 'not checked: whether the robot file "../robot.toml" has changed' in out
    assert "57 relations agree with finite differences" in out
    assert f"pkmodes generate ROBOT.toml --out {vendored}" in out
    assert f"{vendored}: current\n" not in out


@pytest.mark.parametrize("name", [MODULE, "linear_delta_2022.c", "linear_delta_2022.h"])
def test_an_edit_of_a_copied_model_is_found(
    vendored: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    with (vendored / name).open("a", encoding="utf-8") as file:
        file.write("\n")
    assert run(["check", str(vendored)]) == 1
    out = capsys.readouterr().out
    assert f"{name} was edited by hand" in out
    assert f"fix with: pkmodes generate ROBOT.toml --out {vendored}" in out


def test_a_missing_output_and_another_derivation_of_a_copied_model_are_found(
    vendored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (vendored / MODULE).unlink()
    content = json.loads((vendored / "manifest.json").read_text(encoding="utf-8"))
    content["sources"]["chain.py"] = "0" * 64
    (vendored / "manifest.json").write_text(json.dumps(content), encoding="utf-8")
    assert run(["check", str(vendored)]) == 1
    out = capsys.readouterr().out
    assert f"{MODULE} is missing" in out
    assert "the derivation changed: chain.py is modified" in out


@pytest.mark.parametrize(
    ("path", "value"),
    [("platform.mass", 1.6), ("platform.mass", "x"), ("axis.1.direction", [0, 0, 0]), ("new.key", 1.0)],
)
def test_a_manifest_that_was_tampered_with_does_not_hold(
    vendored: Path, capsys: pytest.CaptureFixture[str], path: str, value: object
) -> None:
    """Hashes alone would not detect it: the code is derived again from the values in the manifest."""
    content = json.loads((vendored / "manifest.json").read_text(encoding="utf-8"))
    content["robot"]["values"][path] = value
    (vendored / "manifest.json").write_text(json.dumps(content), encoding="utf-8")
    assert run(["check", str(vendored)]) in (1, 2)
    captured = capsys.readouterr()
    assert (
        "differs from the current derivation" in captured.out or "does not record the robot" in captured.err
    )


def test_the_robot_file_of_a_copied_model_can_be_given_again(
    copy: Path, vendored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = copy / "other.toml"
    other.write_text(published().replace('name = "linear-delta-2022"', 'name = "other"'), encoding="utf-8")
    assert "already holds the model" in refused("generate", other, "--out", vendored)
    assert run(["generate", str(copy / "robot.toml"), "--out", str(vendored)]) == 0
    capsys.readouterr()
    assert run(["check", str(vendored)]) == 0
    assert "not checked" not in capsys.readouterr().out


@pytest.mark.parametrize("effects", ["", EFFECTS])
@pytest.mark.parametrize("frame", ["", '\n[frame]\nmass = "40 kg"\n'])
@pytest.mark.parametrize("name", sorted(ROBOTS))
def test_a_manifest_records_the_whole_robot(tmp_path: Path, name: str, frame: str, effects: str) -> None:
    """To the last bit, because the constants of the derivation follow from it."""
    head, mark, axes = ROBOTS[name].partition("[[axis]]")
    text = head + ("" if "[frame]" in head else frame) + effects + "\n" + mark + axes
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    robot = read_robot(tmp_path / "robot.toml")
    values = json.loads(json.dumps(robot.declared))
    content = {"mechanism": robot.mechanism_name, "robot": {"name": robot.name, "values": values}}
    found = recorded_robot(content, "manifest")
    assert found.effects == robot.effects
    for field, value in robot.parameters._asdict().items():
        np.testing.assert_array_equal(getattr(found.parameters, field), value, strict=True)


def test_a_recorded_direction_is_not_normalised_again(tmp_path: Path) -> None:
    """A unit vector of doubles is not exactly of length 1; normalising this one changes its last digit."""
    text = published().replace("direction = [1, 0, 0]", "direction = [0.9, 0.1, 0.6]", 1)
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    robot = read_robot(tmp_path / "robot.toml")
    direction = robot.parameters.direction[0]
    assert (direction / math.hypot(*direction) != direction).any()
    values = json.loads(json.dumps(robot.declared))
    content = {"mechanism": robot.mechanism_name, "robot": {"name": robot.name, "values": values}}
    np.testing.assert_array_equal(recorded_robot(content, "manifest").parameters.direction[0], direction)


@pytest.mark.parametrize(
    "content", [{}, {"robot": None}, {"mechanism": "x", "robot": {"name": 1, "values": []}}]
)
def test_a_manifest_without_a_robot_is_refused(content: dict[str, object]) -> None:
    with pytest.raises(PkmodesError, match="does not record the robot"):
        recorded_robot(content, "manifest")
