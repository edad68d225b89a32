"""``pkmodes diagnose``: the five verdicts, and the JSON of each."""

from __future__ import annotations

import json
from pathlib import Path
from typing import NamedTuple

import jsonschema
import pytest

import pkmodes
from helpers.commands.answers import Answer
from helpers.diagnoses.diagnose_command import (
    bare,
    call,
    csv_of,
    files,
    measured,
    rows_of,
    unwritable,
    write,
)
from helpers.diagnoses.verdict_examples import VERDICTS, given, judged
from helpers.runs.processes import ROOT

pytestmark = pytest.mark.usefixtures("backend")


class Verdict(NamedTuple):
    """A diagnosis with one of the verdicts."""

    answer: Answer
    saved: Path
    inputs: tuple[Path, Path]


@pytest.fixture(scope="module", params=VERDICTS)
def verdict(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, backend: str
) -> Verdict:
    """Each verdict once, with its JSON on standard output and a saved robot."""
    modes, candidates = given(request.param)
    folder = tmp_path_factory.mktemp(request.param)
    inputs = files(folder, modes=modes)
    saved = write(folder, "what was here before", "saved.toml")
    with judged(request.param):
        answer = call(*inputs, "--candidates", candidates, "--json", "-", "--save-robot", saved)
    assert answer.json["verdict"] == request.param
    return Verdict(answer, saved, inputs)


def test_what_is_claimed_and_proposed_is_whole(verdict: Verdict) -> None:
    found = verdict.answer.json
    described = json.loads((ROOT / "docs/schemas/diagnose.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(described).validate(found)
    assert "\n" not in found["reason"]
    for effect in found["effects"]:
        assert effect["name"] in effect["class"]
        assert 0.0 <= effect["p_value"] <= 1.0
        assert effect["parameters"]
    assert all(found["survivors"])
    assert found["error"]["before"] is not None
    assert found["error"]["refit"] is not None
    proposed, reason = found["next_measurement"], found["next_measurement_reason"]
    assert (proposed is None) == isinstance(reason, str)
    assert reason != ""
    if proposed is not None:
        assert proposed["drives"] in ("free", "held")
        assert len(proposed["pose"]) == 3
        assert len(proposed["separates"]) == 2


def test_a_verdict_has_what_belongs_to_it_and_nothing_else(verdict: Verdict) -> None:
    found = verdict.answer.json
    name, error = found["verdict"], found["error"]
    assert bool(found["effects"]) == (name == "effect_found")
    assert (error["after"] is not None) == (name == "effect_found")
    assert len(found["survivors"]) >= 2 if name == "ambiguous" else found["survivors"] == []
    assert found["refitted"].keys() == {"platform.mass", "belt.specific_stiffness", "motor.inertia"}
    assert error["refit"]["chi2_per_dof"] <= error["before"]["chi2_per_dof"]
    if name == "effect_found":
        (effect,) = found["effects"]
        compliance = effect["parameters"]["compliance"]
        assert effect["name"] == "gearbox_compliance"
        assert compliance["unit"] == "rad/(N*m)"
        assert abs(compliance["value"] - 5e-4) < 5 * compliance["sigma"]
        assert len(found["held_out_poses"]) == 1  # one in six
        assert error["after"]["held_out_rms_relative"] < error["refit"]["held_out_rms_relative"]
    else:
        assert error["before"]["held_out_rms_relative"] is None


def test_a_robot_is_saved_only_when_there_is_one(verdict: Verdict) -> None:
    answer, name = verdict.answer, verdict.answer.json["verdict"]
    if name in ("adequate", "effect_found"):
        assert answer.code == 0
        assert f"wrote {verdict.saved}; next: pkmodes generate {verdict.saved} --out DIR" in answer.err
        assert pkmodes.read_robot(verdict.saved).name == "linear-delta-2022"
    else:
        assert answer.code == 1
        assert answer.err == (
            f"pkmodes diagnose: {verdict.saved} is not written: the verdict is {name}, "
            "which leaves nothing to correct\n"
        )
        assert verdict.saved.read_text() == "what was here before"
    assert sorted(p.name for p in verdict.saved.parent.iterdir()) == ["modes.csv", "robot.toml", "saved.toml"]


def few() -> str:
    """Too few rows to decide anything."""
    return csv_of(bare(rows_of(measured())[:2]))


@pytest.mark.usefixtures("no_drawing")
def test_where_no_robot_can_be_saved_all_else_is_written(tmp_path: Path) -> None:
    """The input is good: exit code 1 says that what was asked for is not there."""
    inputs = files(tmp_path, modes=few())
    saved, page, out = tmp_path / "saved.toml", tmp_path / "page.html", tmp_path / "result.json"
    options = ("--candidates", "payload", "--save-robot", saved, "--report", page, "--json", out)
    answer = call(*inputs, *options)
    assert answer.code == 1
    assert "linear-delta-2022: insufficient_data" in answer.out
    assert answer.err.startswith(f"pkmodes diagnose: {saved} is not written: ")
    assert answer.err.count("\n") == 1
    assert json.loads(out.read_text())["verdict"] == "insufficient_data"
    assert "insufficient_data" in page.read_text(encoding="utf-8")
    assert not saved.exists()


@pytest.mark.usefixtures("no_drawing")
def test_a_report_that_cannot_be_written_does_not_hide_that_no_robot_is_saved(tmp_path: Path) -> None:
    inputs = files(tmp_path, modes=few())
    page, saved = unwritable(tmp_path, "page.html"), tmp_path / "saved.toml"
    answer = call(*inputs, "--candidates", "payload", "--save-robot", saved, "--report", page)
    assert answer.code == 2
    assert [line.partition(":")[0] for line in answer.err.splitlines()] == ["pkmodes diagnose", "error"]


def test_a_verdict_is_no_failure_unless_a_robot_is_asked_for(tmp_path: Path) -> None:
    inputs = files(tmp_path, modes=few())
    out = tmp_path / "result.json"
    answer = call(*inputs, "--candidates", "payload", "--json", out)
    assert answer.code == 0
    assert answer.err == ""
    assert json.loads(out.read_text())["verdict"] == "insufficient_data"
    assert "linear-delta-2022: insufficient_data" in answer.out
    assert "2 measured modes fitted" in answer.out
