"""What a product states about itself in C and in Python, and the product of a robot without its effects."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.generated.generated_robots import Robot, imported
from pkmodes.codegen.generation import generate
from pkmodes_derive.emit.identity import literal


def macros(header: str, name: str) -> dict[str, str]:
    found = re.findall(rf"^#define {name.upper()}_(\w+) (.+)$", header, flags=re.MULTILINE)
    return {key: value for key, value in found if not value.endswith("f")}


def test_c_and_python_state_name_version_and_hash(robot: Robot) -> None:
    stated = macros(robot.header, robot.name)
    record = json.loads(robot.text("manifest.json"))
    assert stated["NAME"] == f'"{record["robot"]["name"]}"'
    assert stated["VERSION"] == f'"{record["generator"]["pkmodes_derive"]}"'
    source = robot.text(f"{robot.name}.c")
    code = source[source.index(f'#include "{robot.name}.h"') :]
    assert stated["HASH"] == f'"{hashlib.sha256(code.encode()).hexdigest()[:16]}"'
    for key in ("NAME", "VERSION", "HASH"):
        assert f'"{getattr(robot.module, key)}"' == stated[key]
        assert key in robot.module.__all__


def test_limits_are_those_of_the_robot_file(robot: Robot) -> None:
    stated = macros(robot.header, robot.name)
    declared = {
        path.upper().replace(".", "_"): q.value
        for path, q in robot.model.robot.quantities.items()
        if re.fullmatch(r"(axis\.\d\.limits|workspace\.\w)\.(min|max)", path)
    }
    assert len(declared) in (4, 6)
    found = {key: value for key, value in stated.items() if key.endswith(("_MIN", "_MAX"))}
    assert found.keys() == declared.keys()
    for key, value in declared.items():
        assert float(found[key].removeprefix("((pkmodes_real)").removesuffix(")")) == value
        assert getattr(robot.module, key) == value


def test_a_parametric_model_has_no_limits() -> None:
    folder = Path(pkmodes.__file__).parents[2] / "generated/pkmodes_generated"
    headers = list(folder.glob("*/*.h"))
    assert headers
    for header in headers:
        text = header.read_text(encoding="utf-8")
        assert not re.search(r"#define \w+_(MIN|MAX) ", text)
    stated = macros((folder / "corexy/corexy.h").read_text(encoding="utf-8"), "corexy")
    assert stated["NAME"] == '"corexy"'
    assert len(stated["HASH"]) == 18


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("plain")
    shutil.copy(Path(__file__).parents[2] / "robots/corexy-printer.toml", folder / "robot.toml")
    generate(folder / "robot.toml", folder / "out")
    return folder


def stated_hash(folder: Path) -> str:
    return macros((folder / "out/corexy_printer.h").read_text(encoding="utf-8"), "corexy_printer")["HASH"]


def test_the_hash_depends_on_the_numbers_only(plain: Path, tmp_path: Path) -> None:
    text = (plain / "robot.toml").read_text(encoding="utf-8")
    for i, (old, new, same) in enumerate(
        [
            ("format = 1", "# a remark\nformat = 1", True),
            ('value = "0.5 kg"', 'value = "500 g"', True),
            ('value = "0.5 kg"', 'value = "0.5000001 kg"', False),
            ('x = ["0 mm", "300 mm"]', 'x = ["0 mm", "301 mm"]', False),
        ]
    ):
        assert old in text
        folder = tmp_path / str(i)
        (folder / "deeper").mkdir(parents=True)
        (folder / "deeper/other.toml").write_text(text.replace(old, new), encoding="utf-8")
        generate(folder / "deeper/other.toml", folder / "out")
        assert (stated_hash(folder) == stated_hash(plain)) == same, new


@pytest.mark.parametrize(
    ("name", "expected"),
    [("linear-delta-2022", "linear-delta-2022"), ('a"; exit', "robot"), ("Möwe", "robot"), ("??/", "robot")],
)
def test_a_name_that_is_no_plain_literal_is_replaced(name: str, expected: str) -> None:
    assert literal(name, "robot") == expected


def test_without_effects_is_the_product_of_the_robot_file_without_them(robot: Robot, tmp_path: Path) -> None:
    beside = f"{robot.name}_without_effects"
    if not robot.effects:
        assert sorted(robot.written) == sorted(
            ["manifest.json", *(f"{robot.name}.{ending}" for ending in ("c", "h", "py"))]
        )
        return
    text = robot.file.read_text(encoding="utf-8")
    (tmp_path / robot.file.name).write_text(text[: text.index("\n[effects.")], encoding="utf-8")
    generate(tmp_path / robot.file.name, tmp_path / "out")
    for ending in ("c", "h", "py"):
        found = (
            robot.text(f"{beside}.{ending}")
            .replace(beside, robot.name)
            .replace(beside.upper(), robot.name.upper())
        )
        expected = (tmp_path / "out" / f"{robot.name}.{ending}").read_text(encoding="utf-8")
        found = found.replace(") without its effects, parameters", "), parameters")
        hashed = re.compile(r'(HASH(?: =)? )"\w+"')  # of the code, in which the names are others
        assert statements(hashed.sub("", found)) == statements(hashed.sub("", expected))


def statements(text: str) -> str:
    """Return code without its layout, in which names of different lengths break lines differently."""
    return "".join(text.replace(" *", "").split())


def test_both_can_be_used_side_by_side(robot: Robot) -> None:
    if not robot.effects:
        return
    other = imported(robot.out / f"{robot.name}_without_effects.py")
    (p,) = robot.valid(1)
    plain = pkmodes.Model(dataclasses.replace(robot.model.robot, effects={}))
    for module, model in ((robot.module, robot.model), (other, plain)):
        rigid = module.RIGID_MODES
        expected = model.frequencies(p)[rigid:]
        np.testing.assert_allclose(module.natural_frequencies(p)[rigid:], expected, rtol=1e-9)
    assert other.HASH != robot.module.HASH
    assert other.NAME == robot.module.NAME
