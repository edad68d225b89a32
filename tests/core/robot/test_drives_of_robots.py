"""The key ``drives`` of a robot file: everything takes it where nothing else is stated."""

from __future__ import annotations

import json
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError, RobotFileError
from pkmodes.core.model import Model
from pkmodes.loop.measured.writing import as_csv
from pkmodes.loop.robot_files.differences import differences
from pkmodes.loop.updating.reading import read, read_any

POSE = [0.6, 0.0, -0.245]
MEASURED = "pose,x,y,z,frequency,sigma\nP,0.6,0,-0.245,36.2,0.1\n"


def robot_file(folder: Path, drives: str | None, further: str = "", name: str = "robot.toml") -> Path:
    """Write the published robot with what its motors do, and further tables."""
    stated = "" if drives is None else f"drives = {drives}\n"
    path = folder / name
    path.write_text(
        published().replace("format = 1\n", f"format = 1\n{stated}", 1) + further, encoding="utf-8"
    )
    return path


@pytest.fixture
def held(tmp_path: Path) -> Model:
    return pkmodes.load(robot_file(tmp_path, '"held"'))


@pytest.mark.parametrize(
    "evaluate",
    [
        lambda model, **drives: model.frequencies(POSE, **drives),
        lambda model, **drives: model.modes(POSE, **drives).shapes,
        lambda model, **drives: model.modes([POSE, POSE], fields=["frequencies"], **drives).frequencies,
        lambda model, **drives: model.poles(POSE, **drives),
        lambda model, **drives: model.frf(POSE, [20.0, 30.0], ["force_x"], ["p_x"], **drives).values,
        lambda model, **drives: model.state_space(POSE, ["force_x"], ["p_x"], **drives).A,
        lambda model, **drives: model.sensitivities(POSE, ["platform.mass"], **drives).frequencies,
        lambda model, **drives: model.map({"x": [0.6], "y": 0.0, "z": -0.245}, **drives).frequency.values,
        lambda model, **drives: model.with_values(
            {"platform.mass": {"value": 1.5, "sigma": 0.1}}
        ).frequency_sigmas(POSE, **drives),
    ],
    ids=["frequencies", "modes", "batch", "poles", "frf", "state_space", "sensitivities", "map", "sigmas"],
)
def test_every_method_takes_the_drives_of_the_robot_file(held: Model, evaluate: Callable[..., Any]) -> None:
    free = pkmodes.load(PUBLISHED)
    np.testing.assert_array_equal(evaluate(held), evaluate(free, drives="held"))
    np.testing.assert_array_equal(evaluate(held, drives="free"), evaluate(free))
    assert evaluate(held).shape != evaluate(free).shape or (evaluate(held) != evaluate(free)).any()


def test_results_name_the_state_of_the_motors(held: Model) -> None:
    modes = held.modes(POSE)
    assert (modes.drives, modes.rigid_modes, len(modes.frequencies)) == ("held", 0, 6)
    assert (held.modes(POSE, drives="free").drives, pkmodes.load(PUBLISHED).modes(POSE).drives) == (
        "free",
    ) * 2
    # Matrices are those of all coordinates, whatever the motors do.
    np.testing.assert_array_equal(modes.mass_matrix, pkmodes.load(PUBLISHED).modes(POSE).mass_matrix)


def test_robots_that_are_used_otherwise_differ(held: Model) -> None:
    robot, free = held.robot, pkmodes.load(PUBLISHED).robot
    assert (robot.drives, free.drives) == ("held", "free")
    assert robot != free
    heavier = robot.with_values({"platform.mass": 2.0})
    assert heavier.drives == pickle.loads(pickle.dumps(heavier)).drives == "held"
    # Values that a rule on several tables refuses are read as a document: drives survive that, too.
    assert robot.with_values({"axis.span": 0.9}).drives == "held"
    (choice,) = differences(free, robot).choices
    assert (choice.path, choice.first, choice.second) == ("drives", "free", "held")


@pytest.mark.parametrize("raw", ['"hold"', "1", "[]", '"Held"', "true"])
def test_other_words_are_refused(tmp_path: Path, raw: str) -> None:
    with pytest.raises(RobotFileError) as error:
        pkmodes.load(robot_file(tmp_path, raw))
    (problem,) = error.value.problems
    assert problem.what.startswith('expected "free" or "held", found ')
    assert str(problem.where).endswith("robot.toml: drives")


def test_commands_take_and_name_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot, pose = str(robot_file(tmp_path, '"held"')), "0.6,0,-0.245"

    def printed(*arguments: str) -> dict[str, Any]:
        assert run([*arguments, "--json", "-"]) == 0
        return json.loads(capsys.readouterr().out)

    for arguments in (
        ["modes", robot, "--pose", pose],
        ["sensitivities", robot, "--pose", pose, "--parameters", "platform.mass"],
        [
            "response",
            robot,
            "--pose",
            pose,
            "--inputs",
            "force_x",
            "--outputs",
            "p_x",
            "--frequencies",
            "20:30:3",
        ],
        ["map", robot, "--grid", "x=0.6,y=0,z=-0.245"],
    ):
        assert printed(*arguments)["drives"] == "held", arguments
        assert printed(*arguments, "--drives", "free")["drives"] == "free", arguments
    assert run(["modes", robot, "--pose", pose]) == 0
    assert "motors held" in capsys.readouterr().out.splitlines()[0]


def test_measurements_are_of_the_machine_in_use_unless_they_state_it(held: Model, tmp_path: Path) -> None:
    plain, stated = tmp_path / "plain.csv", tmp_path / "stated.csv"
    plain.write_text(MEASURED, encoding="utf-8")
    stated.write_text("# drives: free\n" + MEASURED, encoding="utf-8")
    blank = tmp_path / "blank.csv"
    blank.write_text("pose,x,y,z,frequency,sigma,drives\nP,0.6,0,-0.245,36.2,0.1,\n", encoding="utf-8")
    assert read(plain, robot=held).drives == read(blank, robot=held).drives == ("held",)
    assert read(stated, robot=held).drives == read(plain, robot=held, drives="free").drives == ("free",)
    assert read(plain).drives == read_any(plain).drives == read(plain, robot=pkmodes.load(PUBLISHED)).drives
    # What is written states it, so that it is read as it was.
    assert "# drives: free" in as_csv(read(stated, robot=held))


def test_two_robots_that_are_used_otherwise_are_compared_in_one_state(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    held, grid = str(robot_file(tmp_path, '"held"')), ["--grid", "x=0.6,y=0,z=-0.245"]
    assert run(["compare", str(PUBLISHED), held, *grid, "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["drives"] == "free"
    note = "the motors are free in the first robot file and held in the second"
    assert [said for said in found["notes"] if said.startswith(note) and "--drives held" in said]
    assert run(["compare", str(PUBLISHED), held, *grid, "--drives", "held", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["drives"] == "held"
    assert run(["compare", held, held, *grid, "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["drives"] == "held"


def test_held_motors_are_not_on_the_springs_that_the_file_has(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    springs = "\n[effects.servo_stiffness]\nstiffness = 500\n"
    sprung = pkmodes.load(robot_file(tmp_path, '"held"', springs))
    np.testing.assert_array_equal(
        sprung.frequencies(POSE), pkmodes.load(PUBLISHED).frequencies(POSE, drives="held")
    )
    assert run(["modes", sprung.robot.source, "--pose", "0.6,0,-0.245"]) == 0
    assert "motors held" in capsys.readouterr().out.splitlines()[0]
    # A machine that follows commands has them on its springs, whatever else it is used for.
    assert sprung.shapers([POSE], ["zv"]).ringing.drives == "free"
    assert pkmodes.load(PUBLISHED).shapers([POSE], ["zv"]).ringing.drives == "held"


@pytest.mark.parametrize("name", ["corexy", "cartesian", "bed_slinger"])
def test_a_new_printer_is_used_with_held_motors(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "new.toml"
    assert run(["new", name, "--out", str(path)]) == 0
    lines = path.read_text(encoding="utf-8").splitlines()
    place = lines.index('drives = "held"')
    comment = " ".join(line.removeprefix("# ") for line in lines[place - 5 : place] if line)
    assert "[effects.servo_stiffness]" in comment
    assert pkmodes.load(path).robot.drives == "held"


def test_another_new_robot_shows_the_key_with_its_default(tmp_path: Path) -> None:
    path = tmp_path / "new.toml"
    assert run(["new", "linear_delta", "--out", str(path)]) == 0
    assert '#drives = "free"' in path.read_text(encoding="utf-8").splitlines()
    assert pkmodes.load(path).robot.drives == "free"


def test_the_state_of_the_motors_is_no_parameter(held: Model) -> None:
    assert "drives" not in held.robot.declared
    with pytest.raises(PkmodesError, match="unknown parameter path"):
        held.with_values({"drives": "free"})
