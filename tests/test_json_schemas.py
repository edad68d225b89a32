"""The output of ``--json`` agrees with docs/json.md and docs/schemas for every command."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from types import MappingProxyType, SimpleNamespace
from typing import Any

import jsonschema
import numpy as np
import pytest
from msgspec import field

from helpers.robots.robot_text import PUBLISHED, edited, published
from pkmodes.cli import cli, run
from pkmodes.cli.schemas import schema_files
from pkmodes.support.documents import Document, schema_of
from pkmodes_rig.robots import ROBOTS

ROOT = Path(__file__).parents[1]
SCHEMAS = {
    path.name.split(".")[0]: path for path in sorted((ROOT / "docs" / "schemas").glob("*.schema.json"))
}
#: Keys of some mechanisms only, or of rows with settings: all others are always present.
OF_SOME = (
    *("carriage_positions", "set", "damping", "sigma_damping", "predicted_damping"),
    *("damping_before", "damping_after", "damping_used", "sigma_damping_used", "damping_remark"),
    "hidden_by",
)
#: What a command writes for other arguments.
OTHER = {"compare-robots"}
LOOP = [str(ROOT / "examples" / "closed_loop" / name) for name in ("robot.toml", "measured.csv")]
POSE = ["--pose", "0.6,0.03,-0.245"]


def schema(command: str) -> dict[str, Any]:
    return json.loads(SCHEMAS[command].read_text(encoding="utf-8"))


def result(capsys: pytest.CaptureFixture[str], *arguments: str, code: int = 0) -> dict[str, Any]:
    """Return the JSON of a command, read strictly: NaN and Infinity are not JSON."""
    capsys.readouterr()
    assert run([*arguments, "--json", "-"]) == code

    def refuse(name: str) -> None:
        pytest.fail(f"{name} is no JSON")

    return json.loads(capsys.readouterr().out, parse_constant=refuse)


def expect_described(command: str, content: Any) -> None:
    """Check that the result agrees with the schema and that all its keys are in the schema."""
    described = schema(command)
    jsonschema.Draft202012Validator(described).validate(content)
    closed = json.loads(json.dumps(described))
    for part in objects(closed):
        part.setdefault("additionalProperties", False)
    jsonschema.Draft202012Validator(closed).validate(content)


def objects(part: Any) -> Iterator[dict[str, Any]]:
    if isinstance(part, dict):
        if part.get("type") == "object":
            yield part
        for value in part.values():
            yield from objects(value)
    elif isinstance(part, list):
        for value in part:
            yield from objects(value)


def test_the_schemas_are_those_of_the_documents() -> None:
    committed = {path.name: path.read_text(encoding="utf-8") for path in SCHEMAS.values()}
    assert committed == schema_files(), "run: make schemas"


class Inner(Document, frozen=True, omit_defaults=True):
    sizes: list[float | None]
    load: dict[str, float] = field(name="set", default_factory=dict)


class Outer(Document, frozen=True):
    rows: list[Inner]
    count: int


def test_a_document_is_plain_json() -> None:
    """Tuples, arrays and read-only mappings of results become lists and objects, numbers that are not finite null."""
    loads = MappingProxyType({"mass": np.float64(0.3)}), {}
    rows = tuple(SimpleNamespace(sizes=(1.0, np.nan, -np.inf), load=load) for load in loads)
    content = Outer.of(SimpleNamespace(rows=(), count=np.int64(2)), rows=tuple(map(Inner.of, rows))).as_json()
    sizes = [1.0, None, None]
    assert content == {"rows": [{"sizes": sizes, "set": {"mass": 0.3}}, {"sizes": sizes}], "count": 2}
    assert [type(value) for value in (content["rows"], content["count"])] == [list, int]
    jsonschema.validate(content, schema_of(Outer, "a test"))


def test_every_command_has_a_schema_that_is_one_and_a_section_with_its_keys() -> None:
    assert SCHEMAS.keys() == {*cli.commands, *OTHER}
    text = (ROOT / "docs" / "json.md").read_text(encoding="utf-8")
    sections = dict(re.findall(r"^### ([\w-]+)\n(.*?)(?=^### |\Z)", text, flags=re.DOTALL | re.MULTILINE))
    assert sections.keys() == SCHEMAS.keys()
    for command in SCHEMAS:
        described = schema(command)
        jsonschema.Draft202012Validator.check_schema(described)
        for part in objects(described):
            missing = {key for key in part.get("properties", {}) if f"`{key}`" not in sections[command]}
            assert not missing, (command, missing)
            of_some = () if command == "identify" else OF_SOME  # there, null stands for what is not known
            of_some = [key for key in of_some if not (part is described and key == "damping")]
            always = [key for key in part.get("properties", {}) if key not in of_some]
            assert part.get("required", []) == always, "every key is always there"


def test_generate_and_check(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot, model = tmp_path / "robot.toml", str(tmp_path / "model")
    robot.write_text(published(), encoding="utf-8")
    expect_described("generate", result(capsys, "generate", str(robot), "--out", model))
    expect_described("check", result(capsys, "check", str(robot), model))
    robot.write_text(edited("1.5 kg", "1.6 kg"), encoding="utf-8")
    changed = result(capsys, "check", model, code=1)
    assert changed["targets"][0]["findings"]
    expect_described("check", changed)
    robot.unlink()
    copied = result(capsys, "check", model)
    assert copied["targets"][0]["unchecked"]
    expect_described("check", copied)


def test_a_robot_without_a_regular_pose(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The error of that check is infinite, which JSON cannot represent."""
    robot = tmp_path / "robot.toml"
    robot.write_text(published().replace('"400 mm"', '"1 mm"'), encoding="utf-8")
    found = result(capsys, "check", str(robot), code=1)
    assert [check["error"] for check in found["targets"][0]["consistency"]] == [None]
    expect_described("check", found)


def test_figures_and_show(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot, plane = str(ROOT / "robots" / "corexy-printer.toml"), "x=0.1:0.2:3,y=0.1:0.2:3"
    found = result(capsys, "figures", robot, "--out", str(tmp_path / "figures"), "--grid", plane)
    expect_described("figures", found)
    assert {path.name for path in (tmp_path / "figures").iterdir()} == set(found["files"])
    page = str(tmp_path / "robot.html")
    found = result(capsys, "show", robot, "--pose", "0.15,0.1", "--out", page)
    expect_described("show", found)
    assert (found["out"], found["pose"]) == (page, [0.15, 0.1])


@pytest.mark.parametrize("effects", ["", '\n[effects.frame_compliance]\ncompliance = "1e-7 m/N"\n'])
def test_modes_and_sensitivities(tmp_path: Path, capsys: pytest.CaptureFixture[str], effects: str) -> None:
    robot = tmp_path / "robot.toml"
    robot.write_text(published() + effects, encoding="utf-8")
    expect_described("modes", result(capsys, "modes", str(robot), *POSE))
    expect_described("sensitivities", result(capsys, "sensitivities", str(robot), *POSE))


@pytest.mark.parametrize(
    "options",
    [
        ["--grid", "x=0:0.8:9,y=0,z=-0.245"],
        ["--grid", "x=0.6,y=0,z=-0.245", "--set", "effects.servo_stiffness.stiffness=0:900:2"],
        ["--poses", str(ROOT / "examples" / "closed_loop" / "measured.csv"), "--out", "map.nc"],
    ],
)
def test_map(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], options: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    found = result(capsys, "map", str(PUBLISHED), *options)
    expect_described("map", found)
    assert found["file"] == ("map.nc" if "--out" in options else None)


def test_compare(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    expect_described("compare", result(capsys, "compare", *LOOP))
    lonely = tmp_path / "lonely.csv"
    lonely.write_text("pose,x,y,z,frequency,sigma\nA,0.6,0,-0.245,9000,1\n", encoding="utf-8")
    alone = result(capsys, "compare", str(PUBLISHED), str(lonely))
    assert alone["p_value"] is None
    assert alone["rows"][0]["partner"] is None
    expect_described("compare", alone)


def test_compare_of_two_robots(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    grid = ["--grid", "x=0.5:0.7:3,y=0:0.02:2,z=-0.245"]
    other = tmp_path / "other.toml"
    text = edited("1.5 kg", "1.6 kg") + '\n[effects.servo_stiffness]\nstiffness = "300 N*m/rad"\n'
    other.write_text(text, encoding="utf-8")
    for files in ([str(PUBLISHED), str(other)], [str(other), str(PUBLISHED)]):
        found = result(capsys, "compare", *files, *grid)
        assert found["values"]
        expect_described("compare-robots", found)


def test_what_is_set_is_described(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    header = "pose,x,y,z,frequency,sigma,set:effects.payload.mass"
    rows = "A,0.6,0,-0.245,55.6,0.1,", "B,0.6,0,-0.245,50,0.1,0.3"
    (tmp_path / "modes.csv").write_text("\n".join([header, *rows, ""]), encoding="utf-8")
    files = [str(PUBLISHED), str(tmp_path / "modes.csv")]
    for command in ("compare", "diagnose"):
        found = result(capsys, command, *files)
        assert [row.get("set") for row in found["rows"]] == [None, {"effects.payload.mass": 0.3}]
        expect_described(command, found)


def diagnoses(folder: Path) -> dict[str, list[str]]:
    """Arguments that give a cause, no cause because of too few data, and no cause among the candidates."""
    few = folder / "few.csv"
    few.write_text(
        "pose,x,y,z,frequency,sigma\nA,0.6,0,-0.245,55.6,0.1\nA,0.6,0,-0.245,9000,1\n", encoding="utf-8"
    )
    robot = folder / "robot.toml"
    robot.write_text(ROBOTS["published"], encoding="utf-8")
    return {
        "effect_found": [*LOOP, "--candidates", "gearbox_compliance"],
        "insufficient_data": [str(robot), str(few), "--candidates", "payload"],
        "unexplained": [*LOOP, "--candidates", "payload"],
    }


@pytest.mark.parametrize("verdict", ["effect_found", "insufficient_data", "unexplained"])
def test_diagnose_but_for_the_keys_to_come(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], verdict: str
) -> None:
    found = result(capsys, "diagnose", *diagnoses(tmp_path)[verdict])
    assert found["verdict"] == verdict
    expect_described("diagnose", found)


def test_diagnose(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    expect_described("diagnose", result(capsys, "diagnose", *diagnoses(tmp_path)["effect_found"]))


def test_a_result_that_lacks_a_key_or_has_a_wrong_type_is_seen(capsys: pytest.CaptureFixture[str]) -> None:
    """The checks above can fail."""
    found = result(capsys, "modes", str(PUBLISHED), *POSE)
    for wrong in (
        {key: value for key, value in found.items() if key != "pose"},
        {**found, "rigid_modes": None},
        {**found, "frequencies_hz": [None]},
        {**found, "surprise": 1},
    ):
        with pytest.raises(jsonschema.ValidationError):
            expect_described("modes", wrong)
