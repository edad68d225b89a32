"""Motors that did something else than the measurements say: noticed before any cause, and not where they did it.

The measurements are those of the rigs, which share no code with the model.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from helpers.commands.answers import printed
from helpers.commands.printed_tables import printed_table
from pkmodes import updating
from pkmodes.loop.diagnosis import Diagnosis
from pkmodes_rig import MISTAKES
from pkmodes_rig.robots import with_free_motors
from studies.mechanism_cases import MechanismCase, measured
from studies.motors import OTHER_DRIVES
from studies.specimens import ROBOTS, Specimen, measurements_of, robot_of

MACHINES = ("rotary_delta", "corexy")
SIZES = {
    "rotary_delta": {"link_compliance.compliance": 3e-7},
    "corexy": {"belt_end_compliance.compliance": 1e-6},
}


def text_of(specimen: Specimen, number: int = 2, edit: str = "") -> str:
    case = MechanismCase("tested", number, specimen, realistic=True, edit=edit)
    return measured(case)[1]


def diagnosed(specimen: Specimen, text: str) -> Diagnosis:
    robot = robot_of(specimen.machine)
    return updating.diagnose(robot, measurements_of(text, robot), terms=False)


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("machine", MACHINES)
def test_the_wrong_word_is_noticed_before_any_cause(machine: str, drives: str) -> None:
    specimen = Specimen(machine, drives=drives)
    assert diagnosed(specimen, text_of(specimen)).verdict == "adequate"
    found = diagnosed(specimen, text_of(specimen, edit=OTHER_DRIVES))
    said = "held" if drives == "free" else "free"
    assert found.verdict == "unexplained"
    assert found.effects == ()
    assert (
        f"are explained by the declared model with motors {drives}, not with motors {said}: " in found.reason
    )
    assert f"if they were {drives}, write # drives: {drives}, or --drives {drives}" in found.reason
    assert found.notes[0] == found.reason
    assert {row.drives for row in found.rows} == {said}


@pytest.mark.parametrize("machine", MACHINES)
def test_some_poses_may_have_the_wrong_word(machine: str) -> None:
    specimen = Specimen(machine, drives="mixed")
    text = text_of(specimen)
    assert diagnosed(specimen, text).verdict == "adequate"
    found = diagnosed(specimen, text_of(specimen, edit=OTHER_DRIVES))
    assert found.verdict == "unexplained"
    assert "with motors held, not with motors free: " in found.reason
    assert "write held in the column drives" in found.reason
    named = found.reason.partition(" at ")[2].partition(" are ")[0].partition(" and ")[0].split(", ")
    assert named
    assert all(int(label[1:]) % 2 == 0 for label in named)  # those at which they were held


def test_words_that_are_exchanged_are_noticed() -> None:
    specimen = Specimen("corexy", drives="mixed")
    text = text_of(specimen)
    header, *rows = [line for line in text.splitlines() if not line.startswith("#")]
    swap = {"free": "held", "held": "free"}
    place = header.split(",").index("drives")
    exchanged = [
        ",".join(swap.get(c, c) if i == place else c for i, c in enumerate(r.split(","))) for r in rows
    ]
    found = diagnosed(specimen, "\n".join([header, *exchanged]))
    assert found.verdict == "unexplained"
    assert "are explained by the declared model with free and held exchanged: " in found.reason


@pytest.mark.parametrize("drives", ["free", "held", "mixed"])
@pytest.mark.parametrize("machine", MACHINES)
def test_a_cause_is_found_whatever_the_motors_do(machine: str, drives: str) -> None:
    specimen = Specimen(machine, SIZES[machine], drives=drives)
    found = diagnosed(specimen, text_of(specimen))
    assert found.verdict == "effect_found", found.reason
    ((effect,),) = [found.effects]
    assert next(iter(SIZES[machine])).split(".")[0] in effect.members


def test_a_soft_position_loop_is_a_cause_and_no_wrong_word() -> None:
    """A stepper motor or a servo that gives way is declared with free motors, and may hold them almost still."""
    for stiffness in (5.0, 20.0, 60.0):
        specimen = Specimen("corexy", {"servo_stiffness.stiffness": stiffness})
        found = diagnosed(specimen, text_of(specimen, number=3))
        assert found.verdict == "effect_found", found.reason
        assert "servo_stiffness" in found.effects[0].members


def test_with_a_cause_beside_it_the_word_is_told_by_how_much_nearer_the_frequencies_are() -> None:
    specimen = Specimen("corexy", {"axis_belt_stiffness.factor_1": 0.15}, drives="held")
    found = diagnosed(specimen, text_of(specimen, edit=OTHER_DRIVES))
    assert found.verdict == "unexplained"
    assert "fit the declared model far better with motors held than with motors free (" in found.reason


def test_few_rows_and_a_comparison_have_a_note() -> None:
    robot, specimen = robot_of("corexy"), Specimen("corexy", drives="held")
    data = measurements_of(text_of(specimen, edit=OTHER_DRIVES), robot)
    (note,) = updating.compare(robot, data).notes
    assert "far better with motors held than with motors free" in note
    few = replace(data.at([0]), channels=(), shapes=np.empty((int((data.pose == 0).sum()), 0)))
    found = updating.diagnose(robot, few, terms=False)
    assert found.verdict == "insufficient_data"
    assert any("far better with motors held" in note for note in found.notes)
    right = replace(data, drives=("held",) * len(data.labels))
    assert updating.compare(robot, right).notes == ()


def test_another_unit_is_told_first() -> None:
    specimen = Specimen("corexy", drives="held")
    lines = text_of(specimen).splitlines()
    header = next(line for line in lines if line.startswith("pose")).split(",")
    rows = [dict(zip(header, line.split(","), strict=True)) for line in lines if line[:1] == "P"]
    MISTAKES["rad/s for Hz"](rows, np.random.default_rng(0))
    text = "\n".join(["# drives: held", ",".join(header), *(",".join(row.values()) for row in rows)])
    assert "write frequency [rad/s]" in diagnosed(specimen, text).reason


def test_the_commands_take_the_word(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from pkmodes.cli import run

    specimen = Specimen("corexy", drives="held")
    path, robot = tmp_path / "modes.csv", tmp_path / "robot.toml"
    robot.write_text(with_free_motors(ROBOTS / "corexy-printer.toml"), encoding="utf-8")
    path.write_text(text_of(specimen).replace("# drives: held\n", ""), encoding="utf-8")
    assert run(["compare", str(robot), str(path), "--drives", "held"]) == 0
    assert "corexy-printer, motors held: " in " ".join(capsys.readouterr().out.split())
    assert run(["diagnose", str(robot), str(path), "--drives", "held", "--fail-on", "any"]) == 0
    assert "modes fitted, motors held" in capsys.readouterr().out
    assert run(["diagnose", str(robot), str(path), "--fail-on", "unexplained"]) == 1
    assert "--drives held" in " ".join(capsys.readouterr().out.split())
    path.write_text(text_of(Specimen("corexy", drives="mixed")), encoding="utf-8")
    assert run(["compare", str(robot), str(path)]) == 0
    out = capsys.readouterr().out
    assert "corexy-printer, motors free or held: " in " ".join(out.split())
    columns = ("line", "own", "mode", "f [Hz]", "sigma [Hz]", "f [Hz]", "diff. [%]", "diff. [sigma]", "MAC")
    rows = printed_table(printed("compare", robot, path, "--all"), "pose", "motors", *columns)
    # The rig holds the motors at every other pose.
    assert len(rows) == 22
    assert all(drives == ("free" if int(pose[1:]) % 2 else "held") for pose, drives, *_ in rows)
    assert run(["diagnose", str(robot), str(path)]) == 0
    assert "motors held: poses " in capsys.readouterr().out
    assert run(["compare", str(robot), str(path), "--drives", "locked"]) == 2
