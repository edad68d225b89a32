"""The output of ``--json`` agrees with docs/reference/json.md and docs/schemas for every command."""

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

from helpers.commands.answers import answer, from_json
from helpers.robots.robot_text import PUBLISHED, edited, published
from pkmodes.cli import cli
from pkmodes.cli.schemas import schema_files
from pkmodes.core.support.documents import Document, schema_of
from pkmodes_rig.robots import ROBOTS

ROOT = Path(__file__).parents[2]
SCHEMAS = {
    path.name.split(".")[0]: path for path in sorted((ROOT / "docs" / "schemas").glob("*.schema.json"))
}
#: Keys of some mechanisms only, or of rows with settings or levels: all others are always present.
OF_SOME = (
    *("carriage_positions", "set", "damping", "sigma_damping", "predicted_damping"),
    *("damping_before", "damping_after", "damping_used", "sigma_damping_used", "damping_remark"),
    *("beyond_hz", "hidden_by", "level", "nearest", "nearest_hz", "nearest_mac"),
)
#: Writes a robot file, and no JSON.
NONE = {"new"}
#: What a command writes for other arguments.
OTHER = {"compare-robots", "compare-measurements", "shaper-measured"}
#: Which of these the golden outcomes have.
OF_CASE = {("compare", "robots"): "compare-robots", ("shaper", "measured"): "shaper-measured"}
GOLDEN = ROOT / "tests" / "golden"
POSE = ["--pose", "0.6,0.03,-0.245"]


def schema(command: str) -> dict[str, Any]:
    return json.loads(SCHEMAS[command].read_text(encoding="utf-8"))


def result(*arguments: str, code: int = 0) -> dict[str, Any]:
    """Return the JSON of a command."""
    found = answer(*arguments, "--json", "-")
    assert found.code == code
    return found.json


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


def test_every_command_has_a_schema_that_is_one_and_a_section_on_what_it_does_not_say() -> None:
    assert SCHEMAS.keys() == {*cli.commands, *OTHER} - NONE
    text = (ROOT / "docs" / "reference/json.md").read_text(encoding="utf-8")
    sections = dict(re.findall(r"^### ([\w-]+)\n(.*?)(?=^### |\Z)", text, flags=re.DOTALL | re.MULTILINE))
    assert sections.keys() == SCHEMAS.keys()
    for command in SCHEMAS:
        described = schema(command)
        jsonschema.Draft202012Validator.check_schema(described)
        keys = {key for part in objects(described) for key in part.get("properties", {})}
        rows = re.findall(r"^\| (`.*?) \|", sections[command], flags=re.MULTILINE)
        assert {key for row in rows for key in re.findall(r"`(\w+)`", row)} <= keys, command
        section = sections[command] + (sections["diagnose"] if command == "changed" else "")
        for part in objects(described):
            for key, value in part.get("properties", {}).items():
                assert "description" in value or f"`{key}`" in section, (command, key)
            of_some = () if command == "identify" else OF_SOME  # there, null stands for what is not known
            of_some = [
                key for key in of_some if not ("rows" in part.get("properties", {}) and key == "damping")
            ]
            always = [key for key in part.get("properties", {}) if key not in of_some]
            assert part.get("required", []) == always, "every key is always there"


def test_what_the_commands_wrote_agrees_with_their_schemas(subtests: pytest.Subtests) -> None:
    """The golden outcomes, which tests/golden holds the commands to: their words and keys are exact."""
    files = sorted(GOLDEN.glob("*/*/out.json"))
    assert {file.parent.parent.name for file in files} | {"check"} == cli.commands.keys() - NONE
    for file in files:
        command, case = file.parts[-3:-1]
        with subtests.test(f"{command}/{case}"):
            content = from_json(file.read_text(encoding="utf-8"))
            expect_described(OF_CASE.get((command, case), command), content)


def test_generate_and_check(tmp_path: Path) -> None:
    robot, model = tmp_path / "robot.toml", str(tmp_path / "model")
    robot.write_text(published(), encoding="utf-8")
    expect_described("generate", result("generate", str(robot), "--out", model))
    expect_described("check", result("check", str(robot), model))
    robot.write_text(edited("1.5 kg", "1.6 kg"), encoding="utf-8")
    changed = result("check", model, code=1)
    assert changed["targets"][0]["findings"]
    expect_described("check", changed)
    robot.unlink()
    copied = result("check", model)
    assert copied["targets"][0]["unchecked"]
    expect_described("check", copied)


def test_a_robot_without_a_regular_pose(tmp_path: Path) -> None:
    """The error of that check is infinite, which JSON cannot represent."""
    robot = tmp_path / "robot.toml"
    robot.write_text(published().replace('"400 mm"', '"1 mm"'), encoding="utf-8")
    found = result("check", str(robot), code=1)
    assert [check["error"] for check in found["targets"][0]["consistency"]] == [None]
    expect_described("check", found)


def test_compare_with_a_mode_that_no_mode_of_the_model_is_near(tmp_path: Path) -> None:
    lonely = tmp_path / "lonely.csv"
    lonely.write_text("pose,x,y,z,frequency,sigma\nA,0.6,0,-0.245,9000,1\n", encoding="utf-8")
    alone = result("compare", str(PUBLISHED), str(lonely))
    assert alone["p_value"] is None
    assert alone["rows"][0]["partner"] is None
    expect_described("compare", alone)


def test_compare_of_two_robots_of_which_one_has_an_effect(tmp_path: Path) -> None:
    grid = ["--grid", "x=0.5:0.7:3,y=0:0.02:2,z=-0.245"]
    other = tmp_path / "other.toml"
    text = edited("1.5 kg", "1.6 kg") + '\n[effects.servo_stiffness]\nstiffness = "300 N*m/rad"\n'
    other.write_text(text, encoding="utf-8")
    for files in ([str(PUBLISHED), str(other)], [str(other), str(PUBLISHED)]):
        found = result("compare", *files, *grid)
        assert found["values"]
        expect_described("compare-robots", found)


def test_compare_of_two_measurements(tmp_path: Path) -> None:
    for name, frequencies in {"a": (50.0, 80.0), "b": (50.1, 200.0)}.items():
        rows = "".join(f"A,0.6,0,-0.245,{f},0.1\n" for f in frequencies)
        (tmp_path / f"{name}.csv").write_text(f"pose,x,y,z,frequency,sigma\n{rows}", encoding="utf-8")
    found = result("compare", str(tmp_path / "a.csv"), str(tmp_path / "b.csv"))
    assert (len(found["pairs"]), found["first_unpaired"], found["second_unpaired"]) == (1, [3], [3])
    expect_described("compare-measurements", found)


def test_what_is_set_is_described(tmp_path: Path) -> None:
    header = "pose,x,y,z,frequency,sigma,set:effects.payload.mass"
    rows = "A,0.6,0,-0.245,55.6,0.1,", "B,0.6,0,-0.245,50,0.1,0.3"
    (tmp_path / "modes.csv").write_text("\n".join([header, *rows, ""]), encoding="utf-8")
    files = [str(PUBLISHED), str(tmp_path / "modes.csv")]
    for command in ("compare", "diagnose"):
        found = result(command, *files)
        assert [row.get("set") for row in found["rows"]] == [None, {"effects.payload.mass": 0.3}]
        expect_described(command, found)


def test_a_diagnosis_of_too_few_data(tmp_path: Path) -> None:
    few, robot = tmp_path / "few.csv", tmp_path / "robot.toml"
    few.write_text(
        "pose,x,y,z,frequency,sigma\nA,0.6,0,-0.245,55.6,0.1\nA,0.6,0,-0.245,9000,1\n", encoding="utf-8"
    )
    robot.write_text(ROBOTS["published"], encoding="utf-8")
    found = result("diagnose", str(robot), str(few), "--candidates", "payload")
    assert found["verdict"] == "insufficient_data"
    expect_described("diagnose", found)


def test_a_result_that_lacks_a_key_or_has_a_wrong_type_is_seen() -> None:
    """The checks above can fail."""
    found = result("modes", str(PUBLISHED), *POSE)
    for wrong in (
        {key: value for key, value in found.items() if key != "pose"},
        {**found, "rigid_modes": None},
        {**found, "frequencies_hz": [None]},
        {**found, "surprise": 1},
    ):
        with pytest.raises(jsonschema.ValidationError):
            expect_described("modes", wrong)
