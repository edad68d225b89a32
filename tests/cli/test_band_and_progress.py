"""The band of a measurement on the command line, and progress where there is no terminal."""

from __future__ import annotations

import json
import sys
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.examples import example
from helpers.runs.shared import Shared
from pkmodes import updating
from pkmodes.cli import run
from pkmodes.core.base.errors import MeasurementError, PkmodesError
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating.measured_robot import MeasuredRobot

#: For tests that evaluate modes; bad input is refused before that.
both_back_ends = pytest.mark.usefixtures("backend")

LOOP = Path(__file__).resolve().parents[2] / "examples" / "closed_loop"
FILES = [str(LOOP / "robot.toml"), str(LOOP / "measured.csv")]


@pytest.fixture(scope="module")
def robot() -> Robot:
    return pkmodes.read_robot(FILES[0])


@pytest.fixture(scope="module")
def data() -> Measurements:
    return updating.read(FILES[1])


@both_back_ends
def test_a_band_is_taken_where_the_file_has_none(capsys: pytest.CaptureFixture[str]) -> None:
    for command in (["compare", *FILES], ["diagnose", *FILES, "--candidates", "payload"]):
        assert run([*command, "--band", "10, 400 Hz", "--json", "-"]) == 0
        assert json.loads(capsys.readouterr().out)["rows"]
    assert updating.read(FILES[1], (10.0, 400.0)).band == (10.0, 400.0)


@pytest.mark.parametrize(
    ("band", "what"),
    [
        ("400,10", "(--band)"),
        ("10", 'found "10" (--band); write --band 10,400'),
        ("ten,400", "(--band); write --band 10,400"),
        ("10,400 mm", "(--band); write --band 10,400"),
        ("10,60", "expected a frequency in the band from 10 Hz to 60 Hz"),
    ],
)
def test_a_band_that_is_none_or_that_rows_contradict_is_refused(
    band: str, what: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["compare", *FILES, "--band", band]) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert what in error


def test_a_band_other_than_the_files_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text("# band: 10 Hz, 400 Hz\n" + Path(FILES[1]).read_text(encoding="utf-8"), encoding="utf-8")
    assert updating.read(path).band == updating.read(path, (10.0, 400.0)).band == (10.0, 400.0)
    with pytest.raises(
        MeasurementError, match="the file states the band 10 Hz to 400 Hz, not 20 Hz to 400 Hz"
    ):
        updating.read(path, (20.0, 400.0))


def test_without_a_terminal_a_line_says_every_now_and_then_what_is_done(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.modules["pkmodes.cli.diagnosing"], "PROGRESS_INTERVAL", 0.0)
    assert run(["diagnose", *FILES, "--candidates", "gearbox_compliance,payload"]) == 0
    lines = capsys.readouterr().err.splitlines()
    assert "pkmodes diagnose: refitting the uncertain values" in lines
    assert any(line.endswith("refitting with gearbox_compliance") for line in lines)


def test_a_prior_of_a_candidate_enters_a_diagnosis_of_a_robot(
    shared: Shared, robot: Robot, data: Measurements
) -> None:
    name = "gearbox_compliance"
    free = example(shared, "closed_loop", candidates=(name,))
    held = updating.diagnose(robot, data, candidates=[name], priors={name: 1e-4})
    (a,), (b,) = (found.effects[0].parameters if found.effects else () for found in (free, held))
    assert b.value < a.value
    assert b.sigma < a.sigma
    with pytest.raises(PkmodesError, match='no candidate "gearbox"') as error:
        updating.diagnose(robot, data, priors={"gearbox": 1.0})
    assert "gearbox_" in error.value.remedy


def test_priors_may_have_units_as_other_values(robot: Robot, data: Measurements) -> None:
    given = {
        "parameter:link.length": "1 mm",
        "parameter:carriage.mass": "2 %",
        "parameter:motor.gear_ratio": 0.1,
        "parameter:link.mass": "20 g",
        "gearbox_compliance": "1e-6 deg/(N*cm)",
        "measurement:yaw": "1 deg",
    }
    found = {c.name: c.sigma for c in MeasuredRobot.of(robot, data).structure(None, given).candidates}
    expected = [1e-3, 0.02, 0.1, 0.02, 1e-4 * np.pi / 180.0, np.pi / 180.0]
    for name, sigma in zip(given, expected, strict=True):
        assert found[name] == (pytest.approx(sigma, rel=1e-12),), name


PRIORS = [
    ({"parameter:link.length": "1"}, "expected a standard deviation in m: .*is not a number with a unit"),
    ({"parameter:link.length": "1 kg"}, '"1 kg" has the wrong dimension'),
    ({"parameter:link.length": "far"}, '"far" is not a number with a unit'),
    ({"parameter:link.length": None}, "expected a standard deviation, found None"),
    ({"parameter:link.length": "-1 mm"}, "standard deviation above 0"),
    ({"parameter:link.length": 0.0}, "standard deviation above 0"),
    ({"gearbox_compliance": "2 %"}, "standard deviation above 0"),  # of nothing
    ("parameter:link.length", "expected a mapping of names to values"),
    ({"parameter:platform.mass": 0.01}, "platform.mass is not a candidate: .* refitted anyway"),
    ({"platform.mass": 0.01}, "platform.mass is not a candidate: .* refitted anyway"),
    ({3: 0.01}, "no candidate 3"),
]


def test_priors_that_are_none_are_refused(
    subtests: pytest.Subtests, robot: Robot, data: Measurements
) -> None:
    for priors, what in PRIORS:
        with subtests.test(priors), pytest.raises(PkmodesError, match=what):
            updating.diagnose(robot, data, priors=priors)


def test_a_model_may_stand_for_its_robot(tmp_path: Path, robot: Robot, data: Measurements) -> None:
    model = pkmodes.load(FILES[0])
    assert updating.compare(model, data) == updating.compare(robot, data)
    assert updating.update(model, data).values == updating.update(robot, data).values
    found = updating.diagnose(model, data, candidates=["gearbox_compliance"])
    updating.save_robot(model, found, tmp_path / "saved.toml")
    assert pkmodes.read_robot(tmp_path / "saved.toml").effects


@both_back_ends
def test_uncertain_values_of_a_robot_are_updated_together(robot: Robot, data: Measurements) -> None:
    found = updating.update(robot, data)
    assert {p.name for p in found.parameters} == {n for n, q in robot.quantities.items() if q.sigma}
    assert found.before.rms_relative > found.after.rms_relative
    assert any("something else is missing" in note for note in found.notes)  # the gearboxes wind up
    changed = robot.with_values(
        {"effects.gearbox_compliance.compliance": {"value": "1e-4 rad/(N*m)", "sigma": "50 %"}}
    )
    better = updating.update(changed, data)
    assert better.values["effects.gearbox_compliance.compliance"] == pytest.approx(1.88e-4, rel=0.15)
    assert not any("something else is missing" in note for note in better.notes)


def test_the_word_all_stands_for_every_candidate(robot: Robot, data: Measurements) -> None:
    every, said = (MeasuredRobot.of(robot, data).structure(names) for names in (None, "all"))
    assert [one.name for one in said.candidates] == [one.name for one in every.candidates]
    assert {"payload", "belt_mass"} <= {one.name for one in said.candidates}


def test_a_text_where_something_else_is_meant_is_refused(
    subtests: pytest.Subtests, robot: Robot, data: Measurements
) -> None:
    diagnose, compare, update = updating.diagnose, updating.compare, updating.update
    table = [
        (partial(updating.read, 3), "expected a path, found 3"),
        (partial(diagnose, robot, data, holdout="P1"), 'list of labels to hold out, found "P1"'),
        (partial(diagnose, robot, data, candidates="payload"), "expected a list of names"),
        (partial(update, robot, data, "platform.mass"), "expected a list of names"),
        (partial(updating.save_robot, None, None, "x"), "expected a robot or a model, found None"),
    ]
    for call in (diagnose, compare, update):
        table.append((partial(call, robot, "mine.csv"), 'measurements, found "mine.csv" .*updating.read'))
        table.append((partial(call, "R.toml", data), r'read_robot\("R.toml"\)'))
    for call, what in table:
        with subtests.test(what), pytest.raises(PkmodesError, match=what):
            call()


def test_a_robot_that_no_file_has_is_not_saved_as_a_file(
    tmp_path: Path, robot: Robot, shared: Shared
) -> None:
    changed = robot.with_values({"platform.mass": robot.quantities["platform.mass"].value})
    found = example(shared, "closed_loop", candidates=("gearbox_compliance",))
    with pytest.raises(PkmodesError, match="expected a robot read from a file"):
        updating.save_robot(changed, found, tmp_path / "out.toml")
    assert not list(tmp_path.iterdir())
