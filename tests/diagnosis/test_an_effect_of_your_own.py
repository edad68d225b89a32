"""examples/loose_rail: one thing at one place that no catalogue has is found, saved, derived and gone."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses import loose_rail_example
from pkmodes import read_robot, updating
from pkmodes.cli import run
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.updating.saved_term import effect_text, robot_with_term

ROBOT, MEASURED = (loose_rail_example.FOLDER / name for name in ("robot.toml", "measured.csv"))


@pytest.fixture(scope="module")
def found() -> Diagnosis:
    robot = read_robot(ROBOT)
    return updating.diagnose(robot, updating.read(MEASURED, robot=robot))


def test_the_files_are_those_of_the_rig() -> None:
    assert ROBOT.read_text(encoding="utf-8") == loose_rail_example.robot_text()
    written = [
        line.split(",") for line in MEASURED.read_text(encoding="utf-8").splitlines() if line[0] == "P"
    ]
    again = [line.split(",") for line in loose_rail_example.measured_text().splitlines() if line[0] == "P"]
    assert [row[0] for row in written] == [row[0] for row in again]
    frequencies = np.array([[float(row[4]) for row in rows] for rows in (written, again)])
    np.testing.assert_allclose(frequencies[0], frequencies[1], rtol=1e-6)


def test_the_support_that_yields_is_named_with_its_value(found: Diagnosis) -> None:
    assert found.verdict == "unexplained"
    assert found.beyond is not None
    assert found.beyond.status == "found"
    (group,) = found.beyond.classes
    assert group.finding.members == (loose_rail_example.TERM,)
    (compliance,) = group.finding.parameters
    assert abs(compliance.value - loose_rail_example.COMPLIANCE) < 3.0 * compliance.sigma
    assert found.reason.startswith("Not in the catalogue: a support of carriage 2 that yields along y")


def test_what_was_found_is_an_effect_of_the_derivation(found: Diagnosis) -> None:
    namespace: dict[str, object] = {}
    exec(compile(effect_text(found), "loose_rail.py", "exec"), namespace)
    assert namespace["EFFECT"].name == "mount_carriage_2_y"  # type: ignore[attr-defined]
    text = robot_with_term(read_robot(ROBOT), found)
    assert "[effects.mount_carriage_2_y]" in text
    assert text.startswith(ROBOT.read_text(encoding="utf-8").splitlines()[0])


@pytest.mark.slow
def test_the_machine_with_its_effect_lacks_nothing(found: Diagnosis, tmp_path: Path) -> None:
    effect, worn, out = tmp_path / "loose_rail.py", tmp_path / "worn.toml", tmp_path / "worn"
    effect.write_text(effect_text(found), encoding="utf-8")
    worn.write_text(robot_with_term(read_robot(ROBOT), found), encoding="utf-8")
    assert run(["generate", str(worn), "--effect", str(effect), "--out", str(out)]) == 0
    assert run(["check", str(out / "linear_delta")]) == 0
    target = tmp_path / "again.json"
    folder = str(out / "linear_delta")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PKMODES_BACKEND", "numpy")
        words = ["diagnose", str(worn), str(MEASURED), "--mechanism", folder, "--json", str(target)]
        assert run(words) == 0
    assert json.loads(target.read_text(encoding="utf-8"))["verdict"] == "adequate"
    effect.write_text(effect.read_text(encoding="utf-8").replace('along="y"', 'along="z"'), encoding="utf-8")
    assert run(["check", folder]) == 1  # the file of the effect has changed since


def test_without_a_class_nothing_is_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "effect.py"
    loop = loose_rail_example.FOLDER.parent / "closed_loop"
    words = ["diagnose", str(loop / "robot.toml"), str(loop / "measured.csv"), "--save-effect", str(target)]
    assert run(words) == 2
    assert "there is nothing beyond the catalogue to write: terms were not tried" in capsys.readouterr().err
    assert not target.exists()
