"""``pkmodes new``: a robot file with every key, which is valid as it is and with all that is optional."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

import pkmodes
from helpers.commands.answers import answer, printed, refused
from helpers.robots.one_of_each import EVERY
from helpers.robots.robot_text import edited
from helpers.runs.processes import ROOT
from pkmodes.core.mechanism import registry as known
from pkmodes.loop.robot_files.measuring import BY_DIMENSION, BY_PATH, measuring_method
from pkmodes.loop.robot_files.template import template
from pkmodes_description import UNITS, Key, Table

#: The mechanisms with the example that the file starts from.
SUPPLIED = EVERY
OWN = "planar_pair"
#: Estimated, and used by an effect only.
FRAME = "frame.mass"
#: What every robot file may have besides the tables of its mechanism: docs/reference/robot-file.md.
COMMON = {
    *("format", "name", "mechanism", "drives", "gravity", "damping.ratio"),
    *(f"report.{key}" for key in ("customer", "machine", "serial", "operator")),
    *(f"covariance.{key}" for key in ("paths", "correlation", "sigma")),
}


@pytest.fixture(autouse=True)
def _one_of_your_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(known, "_package_by_name", {})
    known.add(OWN)


def description(name: str) -> dict[str, Any]:
    folder = ROOT / ("tests" if name == OWN else "generated/pkmodes_generated")
    content: dict[str, Any] = json.loads((folder / name / "description.json").read_text(encoding="utf-8"))
    return content


def accepted(name: str) -> set[str]:
    """Return the keys of a mechanism by the file that describes it, entries of repeated tables without a number."""
    found = description(name)
    tables = {table["name"]: [key["name"] for key in table["keys"]] for table in found["tables"]}
    paths = {f"{table}.{key}" for table, keys in tables.items() for key in keys}
    for table in found["tables"]:
        if table["shared_by"]:
            paths |= {f"{table['shared_by']}.{table['name']}.{key}" for key in tables[table["name"]]}
    lent = {key["effect"] for table in found["tables"] for key in table["keys"]}
    every = [(effect["name"], p) for effect in found["effects"] for p in effect["parameters"]]
    # One that stands in place of another is named beside that.
    parameters = {f"{effect}.{p['name']}" for effect, p in every if not p.get("in_place_of")}
    paths |= {f"effects.{parameter}" for parameter in parameters - lent}
    limits = {component["name"] for component in found["pose"]} | {"radius"}
    kinds = {element["kind"] for element in found["drawing"]["elements"]}
    if "link" in kinds and not kinds.isdisjoint({"carriage", "arm"}):
        limits.add("singular_angle")
    return paths | COMMON | {f"usable.{limit}" for limit in limits}


def keys(document: Any, path: str = "") -> Iterator[str]:
    """Yield the paths of the values of a parsed file, entries of repeated tables without a number."""
    if isinstance(document, dict) and not {*document} <= {"value", "sigma"}:
        for name, value in document.items():
            yield from keys(value, f"{path}.{name}".lstrip("."))
    elif isinstance(document, list) and document and isinstance(document[0], dict):
        for entry in document:
            yield from keys(entry, path)
    else:
        yield path


def with_everything(text: str) -> str:
    """Return a file whose optional lines are part of it: as its head says, those with a # and no space."""
    return re.sub(r"^#(?=\S)", "", text, flags=re.MULTILINE)


@pytest.mark.parametrize("name", SUPPLIED)
def test_the_file_is_the_example_with_a_sigma_of_what_is_measured(name: str, tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text(printed("new", name), encoding="utf-8")
    robot = pkmodes.load(tmp_path / "robot.toml").robot
    example = pkmodes.load(ROOT / "robots" / SUPPLIED[name]).robot
    values = {path: quantity.value for path, quantity in example.quantities.items()}
    assert {path: quantity.value for path, quantity in robot.quantities.items()} == values
    for path, quantity in example.quantities.items():
        if quantity.sigma is not None:
            assert robot.quantities[path].sigma == quantity.sigma
    assert not robot.effects
    assert not robot.usable
    weighed = [path for path in values if path.endswith(".mass") and values[path] > 0 and path != FRAME]
    assert weighed
    assert all(robot.quantities[path].sigma for path in weighed)


@pytest.mark.parametrize("name", [*SUPPLIED, OWN])
def test_every_key_that_the_reader_accepts_is_there(name: str, tmp_path: Path) -> None:
    text = with_everything(printed("new", name))
    assert set(keys(tomllib.loads(text))) == accepted(name)
    parameters = [p for effect in description(name)["effects"] for p in effect["parameters"]]
    assert all(p["name"] in text for p in parameters if p.get("in_place_of"))
    path = tmp_path / "robot.toml"
    path.write_text(text, encoding="utf-8")
    model = pkmodes.load(path)
    names = {effect["name"] for effect in description(name)["effects"]}
    assert {effect.partition(".")[0] for effect in model.robot.effects} == names
    lent = {key["effect"] for table in description(name)["tables"] for key in table["keys"]}
    rest = {value for path, value in model.robot.effects.items() if path not in lent}
    assert rest == {0.0}, "no effect has a value but what another table lends it"


@pytest.mark.parametrize("name", SUPPLIED)
def test_the_command_in_its_head_works_with_the_file(name: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.toml"
    assert answer("new", name, "--out", path).code == 0
    (command,) = re.findall(
        r"^#   pkmodes (modes FILE --pose .*)$", path.read_text(encoding="utf-8"), re.MULTILINE
    )
    said = printed(*(str(path) if word == "FILE" else word for word in command.split()))
    assert said.startswith(f"my-{name.replace('_', '-')} at [")


@pytest.mark.parametrize("name", [*SUPPLIED, OWN])
def test_a_comment_above_each_key_says_its_unit_and_how_to_find_it(name: str) -> None:
    text = printed("new", name)
    for table in description(name)["tables"]:
        head = rf"^#?\[+{table['name']}\]+  # {re.escape(table['description'])}.*\n"
        section = re.split(head, text, maxsplit=1, flags=re.MULTILINE)[1]
        for key in table["keys"]:
            comment, line, section = re.split(
                rf"^(#?{key['name']} = .*)\n", section, maxsplit=1, flags=re.MULTILINE
            )
            assert all(one.startswith("# ") or one.startswith("#  ") for one in comment.splitlines()), line
            words = " ".join(comment.replace("#", "").split())
            if key["kind"] in ("quantity", "vector", "pair"):
                unit = UNITS[key["dimension"]]
                assert re.search(rf"\[[^]]*{re.escape('a number' if unit == '1' else unit)}[^]]*\]", words), (
                    line
                )
                assert (
                    measuring_method(f"{table['name']}.{key['name']}", key["dimension"]).instruction in words
                )
                assert measuring_method(f"{table['name']}.{key['name']}", key["dimension"]).instruction, line


def test_the_ways_to_find_values_are_of_dimensions_and_keys_that_exist() -> None:
    assert BY_DIMENSION.keys() == UNITS.keys()
    assert BY_PATH.keys() <= {"gravity", "damping.ratio"}.union(*map(accepted, [*SUPPLIED, OWN]))


def test_a_file_of_a_mechanism_without_an_example_has_the_sample_of_its_checks(tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text(printed("new", OWN), encoding="utf-8")
    parameters = pkmodes.load(tmp_path / "robot.toml").robot.parameters
    for field, value in description(OWN)["sample"].items():
        np.testing.assert_allclose(getattr(parameters, field), value, rtol=1e-15)


def test_a_value_of_zero_has_no_sigma_in_per_cent(monkeypatch: pytest.MonkeyPatch) -> None:
    example = tomllib.loads(edited('mass = "1 kg"', 'mass = "0 kg"'))
    monkeypatch.setattr("pkmodes.loop.robot_files.template.robot_of", lambda name: example)
    found = tomllib.loads(printed("new", "linear_delta"))
    assert found["carriage"]["mass"] == "0 kg"
    assert found["platform"]["mass"] == {"value": "1.5 kg", "sigma": "2 %"}


def test_a_table_of_the_mechanism_stands_there_instead_of_one_of_all_robots() -> None:
    own = Table(
        "report", "what it reports", (Key("rate", "quantity", "", "number", "its rate", default=2.0),)
    )
    found = known.mechanism(OWN)
    text = template(msgspec.structs.replace(found, tables=(*found.tables, own)))
    assert re.findall(r"\[report\].*", text) == ["[report]  # what it reports"]


def test_without_a_name_the_mechanisms_are_listed_and_an_unknown_one_is_refused() -> None:
    listed = dict(line.split(": ", 1) for line in printed("new").splitlines())
    assert listed == {name: description(name)["title"] for name in [*SUPPLIED, OWN]}
    assert 'unknown mechanism "corexi"' in refused("new", "corexi")


def test_a_file_with_another_content_is_replaced_only_where_asked(tmp_path: Path) -> None:
    path = tmp_path / "robot.toml"
    written = printed("new", "corexy", "--out", path)
    assert written.startswith(f"wrote {path}; next: pkmodes show ")
    text = path.read_text(encoding="utf-8")
    assert text == printed("new", "corexy")
    before = path.stat().st_mtime_ns
    assert answer("new", "corexy", "--out", path).code == 0
    assert path.stat().st_mtime_ns == before
    path.write_text("mine", encoding="utf-8")
    assert f"{path}: the file exists with another content" in refused("new", "corexy", "--out", path)
    assert path.read_text(encoding="utf-8") == "mine"
    assert answer("new", "corexy", "--out", path, "--overwrite").code == 0
    assert path.read_text(encoding="utf-8") == text
    assert "ends in .toml" in refused("new", "corexy", "--out", tmp_path / "robot.txt")
