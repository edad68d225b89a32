"""``pkmodes diagnose`` for all kinds of robots."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import pkmodes
from helpers.diagnoses.diagnose_command import PUBLISHED, TOWER, call, diagnosed, edited, files, measured

pytestmark = pytest.mark.usefixtures("backend")


@pytest.mark.parametrize(
    ("mass", "candidate", "refitted"),
    [
        ('"0.3 kg"', True, False),
        ('{ value = "0.3 kg", sigma = "10 %" }', False, True),
        ('{ value = "0.3 kg", sigma = "20 g" }', False, True),
        ('{ value = "0.3 kg", sigma = 0 }', False, False),
        ('"0 kg"', True, False),
        ('{ value = "0 kg", sigma = "0.5 kg" }', False, True),
        ('{ value = "0 kg", sigma = 0 }', False, False),
    ],
)
def test_a_declared_effect_is_suspected_refitted_or_known(
    tmp_path: Path, mass: str, candidate: bool, refitted: bool
) -> None:
    robot = f"{PUBLISHED}\n[effects.payload]\nmass = {mass}  # weighed\n"
    found = diagnosed(tmp_path, robot, measured(effects={"payload.mass": 0.3}), "--candidates", "effects")
    examined = {one["name"] for one in found["candidates"]}
    assert ("payload" in examined) == candidate
    assert ("effects.payload.mass" in found["refitted"]) == refitted


def test_a_value_that_every_axis_overrides_is_neither_uncertain_nor_suspected(tmp_path: Path) -> None:
    robot = re.sub(r"(branch = -?1\n)", r'\1\n[axis.belt]\nwidth = "15 mm"\n', PUBLISHED)
    for shared in ('"20 mm"', '{ value = "20 mm", sigma = "1 %" }', '{ value = "20 mm", sigma = 0 }'):
        text = edited(robot, ('width = "15 mm" ', f"width = {shared} "))
        found = diagnosed(tmp_path, text, measured(), "--candidates", "parameters")
        names = {one["name"] for one in found["candidates"]}
        assert "parameter:axis.3.belt.width" in names
        assert "parameter:belt.width" not in names
        assert "belt.width" not in found["refitted"]


def test_the_mass_of_the_frame_is_one_uncertain_value(tmp_path: Path) -> None:
    effects = {"frame_compliance.compliance": 2e-7, "frame_compliance.mass": 55.0}
    uncertain = '{ value = "55 kg", sigma = "5 kg" }'
    robots = {
        "frame.mass": f'[frame]\nmass = {uncertain}\n\n[effects.frame_compliance]\ncompliance = "2e-7 m/N"\n',
        "effects.frame_compliance.mass": f'[effects.frame_compliance]\ncompliance = "2e-7 m/N"\nmass = {uncertain}\n',
    }
    for path, tables in robots.items():
        inputs = files(tmp_path, f"{PUBLISHED}\n{tables}", measured(effects=effects))
        saved = tmp_path / "saved.toml"
        answer = call(*inputs, "--candidates", "payload", "--json", "-", "--save-robot", saved)
        assert answer.code == 0
        assert [name for name in answer.json["refitted"] if "mass" in name] == ["platform.mass", path]
        after = answer.json["refitted"][path]["after"]
        assert pkmodes.read_robot(saved).effects["frame_compliance.mass"] == pytest.approx(after, rel=1e-9)


def test_a_robot_without_uncertain_values_is_saved_as_it_is(tmp_path: Path) -> None:
    robot = re.sub(r'\{ value = ("[^"]*"), sigma = "[^"]*" \}', r"\1", PUBLISHED)
    saved = tmp_path / "saved.toml"
    answer = call(*files(tmp_path, robot), "--candidates", "payload", "--save-robot", saved)
    assert answer.code == 0
    assert answer.out.startswith("linear-delta-2022: adequate\n")
    assert "\nuncertain value" not in answer.out
    assert saved.read_text(encoding="utf-8") == robot


def test_what_may_be_suspected_depends_on_the_robot(tmp_path: Path) -> None:
    found = diagnosed(tmp_path, PUBLISHED, measured(), "--candidates", "parameters")
    examined = {one["name"] for one in found["candidates"]}
    assert {"parameter:axis.span", "parameter:link.length", "parameter:gravity.z"} <= examined
    assert "parameter:axis.joint_radius" not in examined  # the joints are at the centre
    assert "parameter:platform.mass" not in examined
    tower = diagnosed(tmp_path, TOWER, measured(TOWER, name="tower"), "--candidates", "parameters")
    assert "parameter:axis.joint_radius" in {one["name"] for one in tower["candidates"]}
