"""``pkmodes diagnose``: its contract for scripts, rejected input, and the saved robot."""

from __future__ import annotations

import csv
import difflib
import io
import json
import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Mapping
from contextlib import redirect_stderr, redirect_stdout
from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import pkmodes
from pkmodes.cli import run
from pkmodes.diagnosis import Criteria
from pkmodes.robot.reading import robot_from_document
from pkmodes_rig.measurements import measure
from pkmodes_rig.robots import POSES, ROBOTS

ROOT = Path(__file__).parents[2]
PUBLISHED, TOWER = ROBOTS["published"], ROBOTS["tower"]
SHAPES = ("x_1", "x_2", "x_3", "p_x", "p_y", "p_z")
VERDICTS = ("adequate", "effect_found", "ambiguous", "unexplained", "insufficient_data")
#: Belts that are 10 % too soft on one axis, and 5 % too stiff on another.
UNEQUAL = {
    "axis_belt_stiffness.factor_1": -0.1,
    "axis_belt_stiffness.factor_2": 0.05,
    "axis_belt_stiffness.factor_3": 0.0,
}
WIND_UP = {"gearbox_compliance.compliance": 5e-4}


class Answer(NamedTuple):
    """Exit code and output of a command."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> dict[str, Any]:
        return json.loads(self.out)


def call(*arguments: object) -> Answer:
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run(["diagnose", *map(str, arguments)])
    return Answer(code, out.getvalue(), err.getvalue())


def edited(text: str, *changes: tuple[str, str]) -> str:
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return text


@cache
def _measured(robot: str, name: str, poses: int, effects: tuple[tuple[str, float], ...], **rest: Any) -> str:
    return measure(
        robot_from_document(tomllib.loads(robot), "truth").parameters,
        POSES[name]["scattered"][:poses],
        effects=dict(effects),
        rng=np.random.default_rng(4),
        **rest,
    )


def measured(
    robot: str = PUBLISHED,
    *,
    name: str = "published",
    poses: int = 4,
    effects: Mapping[str, float] = {},
    shapes: tuple[str, ...] = SHAPES,
    modes: int = 6,
) -> str:
    """Measurements on the virtual rig of a robot that is as declared except for some effects."""
    return _measured(robot, name, poses, tuple(effects.items()), shapes=shapes, modes=modes)


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def bare(rows: list[dict[str, str]]) -> list[dict[str, str]]:
    """The same rows without shapes."""
    return [{name: cell for name, cell in row.items() if not name.startswith("shape:")} for row in rows]


def csv_of(rows: list[dict[str, str]]) -> str:
    text = io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]))
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def write(folder: Path, text: str, name: str) -> Path:
    path = folder / name
    path.write_bytes(text.encode("utf-8"))
    return path


def files(folder: Path, robot: str = PUBLISHED, modes: str | None = None) -> tuple[Path, Path]:
    return write(folder, robot, "robot.toml"), write(folder, modes or measured(), "modes.csv")


class Verdict(NamedTuple):
    """A diagnosis with one of the verdicts."""

    answer: Answer
    saved: Path
    inputs: tuple[Path, Path]


@pytest.fixture(scope="module", params=VERDICTS)
def verdict(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Verdict:
    """Each verdict once, with its JSON on standard output and a saved robot."""
    modes, candidates = {
        "adequate": (measured(), "payload,belt_mass"),
        "effect_found": (measured(poses=7, effects=WIND_UP), "gearbox_compliance,payload"),
        "ambiguous": (
            measured(poses=3, shapes=(), effects={"gearbox_compliance.compliance": 1.5e-4}),
            "gearbox_compliance,clamp_compliance,belt_end_compliance",
        ),
        "unexplained": (measured(poses=2, effects=UNEQUAL), "payload"),
        "insufficient_data": (csv_of(bare(rows_of(measured())[:2])), "payload"),
    }[request.param]
    folder = tmp_path_factory.mktemp(request.param)
    inputs = files(folder, modes=modes)
    saved = write(folder, "what was here before", "saved.toml")
    with pytest.MonkeyPatch.context() as patch:
        if request.param == "ambiguous":  # nothing is one class: whatever survives is a rival
            patch.setattr("pkmodes.diagnosis.fit.fitter.Criteria", partial(Criteria, told_apart=0.0))
        answer = call(*inputs, "--candidates", candidates, "--json", "-", "--save-robot", saved)
    assert answer.json["verdict"] == request.param
    return Verdict(answer, saved, inputs)


def number(value: object) -> bool:
    return isinstance(value, float | int) and not isinstance(value, bool)


def names(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(name, str) and name for name in value)


def test_every_promised_key_is_there_with_its_type(verdict: Verdict) -> None:
    found = verdict.answer.json
    assert found["verdict"] in VERDICTS
    assert isinstance(found["reason"], str)
    assert found["reason"]
    assert "\n" not in found["reason"]
    assert isinstance(found["effects"], list)
    for effect in found["effects"]:
        assert isinstance(effect["name"], str)
        assert names(effect["class"])
        assert effect["name"] in effect["class"]
        assert 0.0 <= effect["p_value"] <= 1.0
        assert effect["parameters"]
        for value in effect["parameters"].values():
            assert number(value["value"])
            assert number(value["sigma"])
            assert isinstance(value["unit"], str)
    assert isinstance(found["survivors"], list)
    assert all(names(members) and members for members in found["survivors"])
    for value in found["refitted"].values():
        assert all(number(value[key]) for key in ("before", "after", "sigma"))
        assert isinstance(value["unit"], str)
    assert found["error"].keys() == {"before", "refit", "after"}
    for stage, error in found["error"].items():
        assert stage == "after" or error is not None
        if error is not None:
            assert error.keys() == {"rms_relative", "held_out_rms_relative", "chi2_per_dof"}
            assert number(error["rms_relative"])
            assert number(error["chi2_per_dof"])
    assert names(found["held_out_poses"])
    assert names(found["undetectable"])
    proposed = found["next_measurement"]
    if proposed is not None:
        assert len(proposed["pose"]) == 3
        assert all(map(number, proposed["pose"]))
        assert names(proposed["separates"])
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
        assert answer.code == 2
        assert answer.err == (
            f"error: there is no corrected robot to save: the verdict is {name} ({verdict.saved}); "
            "leave out --save-robot, or measure more\n"
        )
        assert verdict.saved.read_text() == "what was here before"
    assert sorted(p.name for p in verdict.saved.parent.iterdir()) == ["modes.csv", "robot.toml", "saved.toml"]


def test_a_verdict_is_no_failure_unless_a_robot_is_asked_for(tmp_path: Path) -> None:
    inputs = files(tmp_path, modes=csv_of(bare(rows_of(measured())[:2])))
    out = tmp_path / "result.json"
    answer = call(*inputs, "--candidates", "payload", "--json", out)
    assert answer.code == 0
    assert answer.err == ""
    assert json.loads(out.read_text())["verdict"] == "insufficient_data"
    assert "linear-delta-2022: insufficient_data" in answer.out
    assert "2 measured modes fitted" in answer.out


# Rejected input -----------------------------------------------------------------------------------------------

HEADER = "pose,x,y,z,frequency,sigma"
ROW = "A,0.6,0,-0.245,55.5,0.1"


def refusal(answer: Answer, *parts: str) -> None:
    assert answer.code == 2
    assert answer.out == ""
    assert answer.err.startswith("error: ")
    assert answer.err.count("\n") == 1
    assert re.search(r" \([^;]*\); \S", answer.err), "where or what to do is missing"
    for part in parts:
        assert part in answer.err


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
    ("header", "rows", "parts"),
    [
        (HEADER, [ROW, "far,9,9,9,50,0.1"], ['pose "far" at [9, 9, 9] m', "line 3, columns x, y and z"]),
        (f"{HEADER},shape:x1", [f"{ROW},1"], ['"shape:x1" is not a coordinate', 'did you mean "shape:x_1"?']),
        (HEADER, [ROW, ROW], ["the row repeats line 2", "line 3, column frequency"]),
        (
            HEADER,
            ["A,0.6,0,-0.245,55.5,0"],
            ["standard deviation above 0 Hz, found 0", "line 2, column sigma"],
        ),
        (HEADER, ["A,0.6,0,-0.245,55.5,-1"], ["found -1", "line 2, column sigma"]),
        (HEADER, ["A,0.6,0,-0.245,0,1"], ["a frequency above 0 Hz", "leave out rigid-body modes"]),
        (HEADER, [ROW, "A,0.61,0,-0.245,60,0.1"], ['pose "A" has two positions', "line 3, column x"]),
        (HEADER, ["A,0.6,0,-0.245,fast,0.1"], ['found "fast"', "line 2, column frequency"]),
        (HEADER, [], ["found only a header"]),
    ],
)
def test_bad_rows_are_refused_with_their_place(
    tmp_path: Path, header: str, rows: list[str], parts: list[str]
) -> None:
    inputs = files(tmp_path, modes="\n".join([header, *rows]) + "\n")
    refusal(call(*inputs), str(inputs[1]), *parts)


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


# Kinds of measurements ----------------------------------------------------------------------------------------


def diagnosed(folder: Path, robot: str, modes: str, *options: str) -> dict[str, Any]:
    answer = call(*files(folder, robot, modes), *options, "--json", "-")
    assert (answer.code, answer.err) == (0, "")
    return answer.json


def test_labels_ends_of_lines_and_comments_do_not_matter(tmp_path: Path) -> None:
    text = measured()
    labels = {"P1": 'a, "b" [/red] :car:', "P2": "Größe_模式", "P3": "[bold]x", "P4": "P 4"}
    rows = [{**row, "pose": labels[row["pose"]]} for row in rows_of(text)]
    windows = "\ufeff# made on Monday\r\n" + csv_of(rows)
    options = ("--candidates", "payload")
    plain = diagnosed(tmp_path, PUBLISHED, text, *options, "--holdout", "P1,P2")
    other = diagnosed(
        tmp_path, PUBLISHED, windows, *options, "--holdout", '"a, ""b"" [/red] :car:", Größe_模式'
    )
    assert set(other["held_out_poses"]) == {labels["P1"], labels["P2"]}
    assert other["error"] == plain["error"]
    assert other["refitted"] == plain["refitted"]
    answer = call(*files(tmp_path, PUBLISHED, windows), *options, "--holdout", "Größe_模式")
    assert answer.code == 0
    assert "18 measured modes fitted (held out: Größe_模式)" in answer.out
    refused = call(*files(tmp_path, PUBLISHED, windows), *options, "--holdout", "P1")
    refusal(refused, 'no pose is called "P1"')


def test_few_data_of_several_kinds(tmp_path: Path) -> None:
    rows = rows_of(measured())
    lowest = {}
    for row in sorted(rows, key=lambda row: -float(row["frequency"])):
        lowest[row["pose"]] = row
    for part, expected in (
        ([row for row in rows if row["pose"] == "P2"], "adequate"),
        (rows[:2], "insufficient_data"),
        (rows[:1], "insufficient_data"),
        (list(lowest.values()), "insufficient_data"),
    ):
        found = diagnosed(tmp_path, PUBLISHED, csv_of(bare(part)), "--candidates", "payload")
        assert found["verdict"] == expected
        assert found["held_out_poses"] == []
        if expected == "insufficient_data":
            assert "platform.mass" in found["reason"]
            assert found["undetectable"] == ["payload"]


def test_modes_that_the_model_lacks_are_not_noise(tmp_path: Path) -> None:
    rows = [f"P{i},0.6,{i / 100},-0.24,{5000 + i},1" for i in range(5)]
    inputs = files(tmp_path, PUBLISHED, "\n".join([HEADER, *rows]) + "\n")
    found = call(*inputs, "--candidates", "payload", "--json", "-").json
    assert found["verdict"] == "unexplained"
    assert [row["line"] for row in found["unpaired"]] == [2, 3, 4, 5, 6]
    out = call(*inputs, "--candidates", "payload").out
    assert "unmatched measured modes: line 2, pose P0, 5000 Hz; line 3, pose P1, 5001 Hz;\n" in out


def test_modes_that_were_rigid_may_be_measured(tmp_path: Path) -> None:
    modes = measured(poses=3, effects={"cable_stiffness.stiffness": 4e4})
    assert len(rows_of(modes)) == 27
    inputs = files(tmp_path, PUBLISHED, modes)
    saved = tmp_path / "saved.toml"
    answer = call(*inputs, "--candidates", "cable_stiffness,payload", "--json", "-", "--save-robot", saved)
    (effect,) = answer.json["effects"]
    assert effect["name"] == "cable_stiffness"
    assert answer.json["unpaired"] == []
    stiffness = effect["parameters"]["stiffness"]
    assert abs(stiffness["value"] - 4e4) < 5 * stiffness["sigma"]
    assert diagnosed(tmp_path, saved.read_text(), modes, "--candidates", "payload")["verdict"] == "adequate"


def test_the_uncertainty_of_the_poses_counts(tmp_path: Path) -> None:
    rng, rows, moved = np.random.default_rng(1), rows_of(measured()), {}
    for row in rows:
        offset = moved.setdefault(row["pose"], rng.normal(0.0, 0.003, 3))
        for name, change in zip("xyz", offset, strict=True):
            row[name] = f"{float(row[name]) + change:.9g}"
            row[f"sigma_{name}"] = "0.003"
    options = ("--candidates", "payload")
    assert diagnosed(tmp_path, PUBLISHED, csv_of(rows), *options)["verdict"] == "adequate"
    for row in rows:
        row.update(sigma_x="", sigma_y="", sigma_z="")
    assert diagnosed(tmp_path, PUBLISHED, csv_of(rows), *options)["verdict"] == "unexplained"


def test_a_thousand_rows(tmp_path: Path) -> None:
    rows = [
        {
            **row,
            "pose": f"{row['pose']} again {k}",
            "frequency": f"{float(row['frequency']) * (1 + 1e-5 * k)}",
        }
        for k in range(42)
        for row in rows_of(measured(shapes=()))
    ]
    assert len(rows) > 1000
    inputs = files(tmp_path, PUBLISHED, csv_of(rows))
    answer = call(*inputs, "--candidates", "payload", "--json", tmp_path / "out")
    assert answer.code == 0
    assert len(json.loads((tmp_path / "out").read_text())["rows"]) == len(rows)


# Kinds of robots ----------------------------------------------------------------------------------------------


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


# The saved robot ----------------------------------------------------------------------------------------------


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
def corrected(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Saved:
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
    expected = {path: (v["after"], v["sigma"]) for path, v in corrected.result["refitted"].items()}
    (effect,) = corrected.result["effects"]
    for name, value in effect["parameters"].items():
        path = name if corrected.candidate.startswith("parameter:") else f"effects.{effect['name']}.{name}"
        expected[path] = value["value"], value["sigma"]
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
    assert added.count("refitted by pkmodes diagnose") == 3
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


# Printed output -----------------------------------------------------------------------------------------------


def test_the_table_of_a_cause(tmp_path: Path) -> None:
    robot = (
        PUBLISHED + '\n[effects.belt_end_compliance]\ncompliance = { value = "1e-9 m/N", sigma = "20 %" }\n'
    )
    inputs = files(tmp_path, robot, measured(effects=WIND_UP))
    answer = call(*inputs, "--candidates", "gearbox_compliance,payload", "--holdout", "P3")
    assert (answer.code, answer.err) == (0, "")
    lines = answer.out.splitlines()
    assert max(map(len, lines)) <= 80
    assert "…" not in answer.out
    assert lines[0] == "linear-delta-2022: effect_found"
    assert lines[1].startswith("  the residual of the declared model is not noise (p = ")
    assert "18 measured modes fitted (held out: P3)" in lines
    cause = re.search(
        r"^  gearbox_compliance\.compliance = \((\d\.\d+) \+- 0\.\d\d\)e-04 rad/\(N\*m\)$", answer.out, re.M
    )
    assert cause is not None
    assert 4.0 < float(cause[1]) < 6.0
    for line in (
        "error                               rms [%]  held out [%]  chi2 per dof",
        "before: as declared ",
        "refit of the uncertain values only ",
        "after: with the cause ",
    ):
        assert any(found.startswith(line) for found in lines), line
    (start,) = (i for i, line in enumerate(lines) if line.startswith("uncertain value"))
    assert [line.split()[0] for line in lines[start + 1 : start + 5]] == [
        "platform.mass",
        "belt.specific_stiffness",
        "motor.inertia",
        "belt_end_compliance.compliance",
    ]
    for column in ("before", "after", "sigma"):  # right ends of the numbers
        end = lines[start].index(column) + len(column)
        assert all(line[end - 1] != " " and line[end] == " " for line in lines[start + 1 : start + 5])
    assert lines[start + 4].split()[-1] == "m/N"


def test_the_table_of_two_causes_and_of_causes_that_look_alike(tmp_path: Path) -> None:
    both = {**WIND_UP, "belt_mass.linear_density": 0.1}
    inputs = files(tmp_path, PUBLISHED, measured(poses=5, effects=both))
    out = call(*inputs, "--candidates", "belt_mass,gearbox_compliance").out
    assert out.count("\ncause: ") == 2
    assert "\nafter: with the causes " in out
    alike = {"gearbox_compliance.compliance": 1.5e-4}
    inputs = files(tmp_path, PUBLISHED, measured(poses=3, effects=alike, shapes=()))
    options = ("--candidates", "gearbox_compliance,clamp_compliance,belt_end_compliance")
    saved = tmp_path / "saved.toml"
    out, found = (
        call(*inputs, *options, "--save-robot", saved).out,
        call(*inputs, *options, "--json", "-").json,
    )
    (effect,) = found["effects"]
    assert len(effect["class"]) > 1
    name, *others = effect["class"]
    assert (
        f"wrote {saved} with {name}; to save it with {' or '.join(others)}: --candidates {others[0]}; next"
        in out
    )
    start = out.index("  these data cannot distinguish it from\n")
    for name in effect["class"][1:]:
        assert re.search(rf"^    {name}\.compliance = \(\S+ \+- \S+\)e-\d\d \S+$", out[start:], re.M)


def test_no_pose_is_held_out_on_request(tmp_path: Path) -> None:
    answer = call(*files(tmp_path), "--candidates", "payload", "--holdout", "none")
    assert "24 measured modes fitted\n" in answer.out
    assert "held out" not in answer.out


@pytest.mark.parametrize(
    "environment",
    [{"COLUMNS": "40"}, {"NO_COLOR": "1", "FORCE_COLOR": "1"}, {"PYTHONIOENCODING": "ascii"}],
)
def test_every_terminal_gets_whole_numbers(tmp_path: Path, environment: dict[str, str]) -> None:
    modes = csv_of([{**row, "pose": row["pose"].replace("P1", "Größe")} for row in rows_of(measured())])
    command = [sys.executable, "-m", "pkmodes", "diagnose", *map(str, files(tmp_path, PUBLISHED, modes))]
    path = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive"))
    found = subprocess.run(
        [*command, "--candidates", "payload", "--holdout", "Größe"],
        env={**os.environ, "PYTHONPATH": path, **environment},
        capture_output=True,
        check=True,
    )
    out = found.stdout.decode("ascii" if "PYTHONIOENCODING" in environment else "utf-8")
    assert re.search(rb"\x1b\[[0-9;]*[34][0-7]", found.stdout + found.stderr) is None  # no colours
    if "FORCE_COLOR" not in environment:  # which would show the progress too
        assert found.stderr == b""
    assert "\u2026" not in out
    assert re.search(r"motor\.inertia +1\.7e-05 +1\.\d+e-05 +\d\.?\d*e-0[78] +kg\*m\^2", out)
    label = "Gr\\xf6\\xdfe" if "PYTHONIOENCODING" in environment else "Größe"
    assert f"18 measured modes fitted (held out: {label})" in " ".join(out.split())
    if "COLUMNS" in environment:
        text = [line for line in out.splitlines() if "  " not in line.strip()]
        assert max(map(len, text)) <= 40


def test_help_shows_an_example_that_works(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    answer = call("--help")
    assert answer.code == 0
    example = answer.out.split("Example:\n")[1].replace("\\\n", " ").split()
    assert example[:2] == ["pkmodes", "diagnose"]
    assert all((ROOT / place).is_file() for place in example[2:4])
    # The measurements of the example, so that its options are tested too.
    monkeypatch.chdir(tmp_path)
    saved = example[example.index("--save-robot") + 1]
    found = call(*(ROOT / place for place in example[2:4]), *example[4:])
    assert found.code == 0
    assert pkmodes.read_robot(saved).name == "workshop-delta"
