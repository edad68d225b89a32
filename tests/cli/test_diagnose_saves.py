"""The corrected robot that ``pkmodes diagnose`` saves."""

from __future__ import annotations

import difflib
import io
import tomllib
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.diagnose_command import (
    PUBLISHED,
    TOWER,
    UNEQUAL,
    WIND_UP,
    call,
    edited,
    files,
    measured,
)
from pkmodes.cli import run
from pkmodes.core.robot.reading import robot_from_document

pytestmark = pytest.mark.usefixtures("backend")


def wider(text: str) -> str:
    """The tower with joints that are 30 % farther from the centre."""
    places = {
        '["30 mm", "0 mm", "0 mm"]': '["39 mm", "0 mm", "0 mm"]',
        '["-15 mm", "25.980762 mm", "0 mm"]': '["-19.5 mm", "33.7749907 mm", "0 mm"]',
        '["-15 mm", "-25.980762 mm", "0 mm"]': '["-19.5 mm", "-33.7749907 mm", "0 mm"]',
    }
    return edited(text, *places.items())


LONGER = edited(PUBLISHED, ('length = "400 mm"', 'length = "404 mm"'))


SPREAD = PUBLISHED.replace('["0 m", "1.2 m"]', '["-0.025 m", "1.225 m"]')


NARROW = edited(PUBLISHED, ("branch = 1\n", 'branch = 1\n[axis.belt]\nwidth = "13 mm"\n'))


FRAME = {"frame_compliance.compliance": 2e-7, "frame_compliance.mass": 60.0}


FRAMED = PUBLISHED + '\n[frame]\nmass = "60 kg"  # weighed in the yard\n'


SAVED: dict[str, tuple[str, str, str, dict[str, float]]] = {
    "parameter:link.length": (PUBLISHED, LONGER, "published", {}),
    "parameter:axis.span": (PUBLISHED, SPREAD, "published", {}),
    "parameter:axis.joint_radius": (TOWER, wider(TOWER), "tower", {}),
    "parameter:axis.1.belt.width": (PUBLISHED, NARROW, "published", {}),
    "axis_belt_stiffness": (PUBLISHED, PUBLISHED, "published", UNEQUAL),
    "frame_compliance": (FRAMED, PUBLISHED, "published", FRAME),
    "gearbox_compliance": (PUBLISHED, PUBLISHED, "published", WIND_UP),
}


class Saved(NamedTuple):
    """A robot whose cause was found, before and after."""

    candidate: str
    declared: Path
    truth: Any
    saved: Path
    result: dict[str, Any]
    modes: Path


@pytest.fixture(scope="module", params=list(SAVED))
def corrected(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, backend: str
) -> Saved:
    declared, truth, name, effects = SAVED[request.param]
    folder = tmp_path_factory.mktemp("saved")
    robot, modes = files(folder, declared, measured(truth, name=name, effects=effects))
    saved = folder / "corrected robot.toml"
    answer = call(robot, modes, "--candidates", request.param, "--json", "-", "--save-robot", saved)
    assert answer.code == 0
    assert answer.json["verdict"] == "effect_found"
    assert f"next: pkmodes generate '{saved}' --out DIR" in answer.err
    parameters = robot_from_document(tomllib.loads(truth), "truth").parameters
    return Saved(request.param, robot, parameters, saved, answer.json, modes)


def declared_value(robot: pkmodes.Robot, path: str) -> tuple[float, float | None]:
    """Return a value of the robot file and its standard deviation; a whole has none."""
    if path == "axis.span":
        low, high = robot.parameters.limits[0]
        return float(high - low), None
    if path == "axis.joint_radius":
        return float(np.linalg.norm(robot.parameters.joint[0])), None
    quantity = robot.quantities[path]
    return quantity.value, quantity.sigma


def test_the_saved_robot_has_the_values_of_the_result(corrected: Saved) -> None:
    robot = pkmodes.read_robot(corrected.saved)
    expected = {path: (v["after"], v["saved_sigma"]) for path, v in corrected.result["refitted"].items()}
    (effect,) = corrected.result["effects"]
    for name, value in effect["parameters"].items():
        path = name if corrected.candidate.startswith("parameter:") else f"effects.{effect['name']}.{name}"
        expected[path] = value["value"], value["saved_sigma"]
    assert len(expected) > len(corrected.result["refitted"])
    for path, (value, sigma) in expected.items():
        found, found_sigma = declared_value(robot, path)
        assert found == pytest.approx(value, rel=1e-8), path
        if path.startswith("axis.") and path.count(".") == 1:
            assert f"sigma of {path} {sigma:.3g} m" in corrected.saved.read_text()
        else:
            assert found_sigma == pytest.approx(sigma, rel=1e-2), path


def test_the_saved_robot_keeps_comments_order_and_all_else(corrected: Saved) -> None:
    before, after = corrected.declared.read_text().splitlines(), corrected.saved.read_text().splitlines()
    changes = [line for line in difflib.ndiff(before, after) if line[0] in "+-"]
    removed = [line[2:] for line in changes if line[0] == "-"]
    added = "\n".join(line[2:] for line in changes if line[0] == "+")
    assert all(line.split(" = ")[0] in added for line in removed)
    assert len(removed) <= 3 + 3  # the uncertain values, and an element of each axis
    for line in before:
        comment = line.partition("#")[2]
        assert not comment or any(comment in other for other in after)
    assert added.count("refitted by pkmodes diagnose") + added.count("unchanged by pkmodes diagnose") == 3
    assert "found by pkmodes diagnose" in added
    if corrected.candidate.startswith("parameter:"):
        was = {"link": "was 0.4 m", "axis.s": "was 1.2 m", "axis.j": "was 0.03 m", "axis.1": "was 0.015 m"}
        (note,) = (note for part, note in was.items() if f":{part}" in corrected.candidate)
        assert f"{note}: found by pkmodes diagnose" in added


def test_the_saved_robot_is_adequate(corrected: Saved, tmp_path: Path) -> None:
    candidates = "servo_stiffness,parameter:pulley.radius"
    found = call(corrected.saved, corrected.modes, "--candidates", candidates, "--json", "-").json
    assert found["verdict"] == "adequate"
    after, before = corrected.result["error"]["after"], found["error"]["before"]
    assert before["rms_relative"] == pytest.approx(after["rms_relative"], rel=1e-4)
    truth = corrected.truth
    robot = pkmodes.read_robot(corrected.saved).parameters
    for field in ("link_length", "belt_width", "limits", "joint"):
        np.testing.assert_allclose(getattr(robot, field), getattr(truth, field), rtol=0.03, atol=0.004)


@pytest.mark.parametrize("corrected", ["frame_compliance", "parameter:axis.1.belt.width"], indirect=True)
def test_the_saved_robot_can_be_generated(corrected: Saved, tmp_path: Path) -> None:
    out = io.StringIO()
    with redirect_stdout(out), redirect_stderr(out):
        assert run(["generate", str(corrected.saved), "--out", str(tmp_path / "model")]) == 0, out.getvalue()
