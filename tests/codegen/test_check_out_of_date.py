"""``pkmodes check`` finds what makes a generated model out of date, and names the command that mends it."""

from __future__ import annotations

import json
import shlex
import shutil
from pathlib import Path

import pytest

from helpers.generated.generated_model import MODULE, edit
from helpers.robots.robot_text import published
from pkmodes.cli import run
from pkmodes_derive import sources


def check(folder: Path, capsys: pytest.CaptureFixture[str], *options: str) -> tuple[int, str]:
    capsys.readouterr()
    code = run(["check", str(folder / "model"), *options])
    return code, capsys.readouterr().out


def test_a_fresh_model_is_current(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Also with a comment more in the robot file."""
    edit(copy / "robot.toml", "format = 1", "# a remark\nformat = 1")
    code, out = check(copy, capsys)
    assert code == 0
    assert "relations agree with finite differences" in out
    assert "mend" not in out


#: Lines that a module must not have, and that are not executed.
NEVER_RUN = ("import sys; sys.exit(0)", "raise RuntimeError", "print('hi')", "x =")
PYTHON, DERIVED = f"model/{MODULE}", "(derived now)"
#: What is edited in a file of the robot or its model, and what is said of it and shown of the difference.
CHANGES = [
    ("robot.toml", "1.5 kg", "1.6 kg", ["platform.mass is 1.6, the model was generated with 1.5", DERIVED]),
    (
        "robot.toml",
        "branch = 1\n",
        'branch = 1\nbelt.width = "2 cm"\n',
        ["axis.1.belt.width is 0.02", DERIVED],
    ),
    ("robot.toml", "driven_pulley = 1", "driven_pulley = 2", ["axis.1.driven_pulley is 2", DERIVED]),
    ("robot.toml", '"-200 mm"', '"-210 mm"', ["axis.2.origin.y is -0.21", DERIVED]),
    ("robot.toml", '"linear-delta-2022"', '"Linear-Delta-2022"', ['name is "Linear-Delta-2022"']),
    (
        PYTHON,
        "x_1 = p_x + np.",
        "x_1 = p_x - np.",
        ["", "-    x_1 = p_x - np.sqrt", "+    x_1 = p_x + np.sqrt"],
    ),
    *((PYTHON, "\nimport numpy", f"\n{line}\nimport numpy", ["", f"\n-{line}\n"]) for line in NEVER_RUN),
    *((f"model/{name}", "\n", "\n\n", [""]) for name in ("linear_delta_2022.c", "linear_delta_2022.h")),
    ("model/manifest.json", "\n", "\n\n", [""]),
]


def test_an_edit_is_found_and_named_with_what_mends_it(
    subtests: pytest.Subtests, pristine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for number, (name, old, new, (said, *shown)) in enumerate(CHANGES):
        with subtests.test(name=name, new=new):
            folder = Path(shutil.copytree(pristine, tmp_path / str(number)))
            edit(folder / name, old, new)
            code, reasons = check(folder, capsys)
            _, out = check(folder, capsys, "--diff")
            assert code == 1
            assert "@@" not in reasons, "the difference is shown on demand"
            assert ("what differs, line by line: --diff\n" in reasons) == ("@@" in out)
            assert out.startswith(reasons.replace("what differs, line by line: --diff\n", ""))
            assert reasons.splitlines()[-1].startswith("fix with: ")
            by_hand = f"{Path(name).name} was edited by hand"
            assert (f"the robot file changed: {said}" if said else by_hand) in out
            assert [part for part in shown if part not in out] == [], out
            assert f"fix with: pkmodes generate {folder / 'robot.toml'} --out {folder / 'model'}" in out
            assert "hi\n" not in out.replace("print('hi')", ""), "it was executed"


def test_a_brief_check_is_one_line_for_each_folder(
    copy: Path, pristine: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edit(copy / "robot.toml", "1.5 kg", "1.6 kg")
    capsys.readouterr()
    assert run(["check", "--brief", str(pristine / "model"), str(copy / "model")]) == 1
    assert capsys.readouterr().out.splitlines() == [
        f"{pristine / 'model'}: current",
        f"{copy / 'model'}: the robot file changed: platform.mass is 1.6, the model was generated with 1.5; "
        "and 3 more",  # the module, the C and its header
    ]


def test_missing_and_orphan_files_are_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (copy / "model" / MODULE).rename(copy / "model" / "other.py")
    code, out = check(copy, capsys)
    assert code == 1
    assert f"{MODULE} is missing" in out
    assert "other.py was generated but does not belong to this model: an orphan" in out


def test_other_line_endings_are_named(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = copy / "model" / MODULE
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    code, out = check(copy, capsys)
    assert code == 1
    assert "has different line endings than generated" in out


def change_manifest(folder: Path, table: str, key: str, value: object) -> None:
    path = folder / "model" / "manifest.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    content[table][key] = value
    path.write_text(json.dumps(content), encoding="utf-8")


def test_another_sympy_version_is_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change_manifest(copy, "generator", "sympy", "1.12")
    code, out = check(copy, capsys)
    assert code == 1
    assert "different SymPy version: generated with 1.12, installed is 1." in out


@pytest.mark.parametrize("source", ["chain.py", "emit/numpy/module.py.j2"])
def test_a_changed_derivation_or_template_is_found(
    copy: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, source: str
) -> None:
    digests = {**sources.source_digests(), source: "0" * 64}
    monkeypatch.setattr(sources, "source_digests", lambda: digests)
    code, out = check(copy, capsys)
    assert code == 1
    assert f"changed: {source} is modified" in out


def test_the_mending_command_mends(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copy / "robot.toml", 'mass = "1.5 kg"', 'mass = "1.6 kg"')
    edit(copy / "robot.toml", 'name = "linear-delta-2022"', 'name = "heavier"')
    code, out = check(copy, capsys)
    assert code == 1
    command = out.partition("fix with: ")[2].split()
    assert run(command[1:]) == 0
    assert check(copy, capsys)[0] == 0
    assert not (copy / "model" / MODULE).exists(), "the module under the former name is gone"


def test_the_mending_commands_can_be_pasted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "it's a folder"
    folder.mkdir()
    (folder / "my robot.toml").write_text(published(), encoding="utf-8")
    assert run(["generate", str(folder / "my robot.toml"), "--out", str(folder / "my model")]) == 0
    edit(folder / "my robot.toml", "1.5 kg", "1.6 kg")
    shutil.copy(folder / "my model" / MODULE, folder / "my model" / "a copy.py")
    assert run(["check", str(folder / "my model")]) == 1
    commands = capsys.readouterr().out.rpartition("fix with: ")[2].strip().split(" && ")
    remove, generate = (shlex.split(command) for command in commands)
    assert remove == ["rm", str(folder / "my model" / "a copy.py")]
    Path(remove[1]).unlink()
    assert run(generate[1:]) == 0
    assert run(["check", str(folder / "my model")]) == 0


def test_a_tampered_manifest_is_refused(
    subtests: pytest.Subtests, copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for reference in (7, None, "a\0b", "x" * 5000, "\ud800", "/", ""):
        with subtests.test(reference=reference):
            change_manifest(copy, "robot", "file", reference)
            assert run(["check", str(copy / "model")]) == 2
            assert capsys.readouterr().err.startswith("error: the ")


def test_folders_without_a_model_are_refused(
    tmp_path: Path, copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["check", str(tmp_path)]) == 2
    assert "found no manifest.json" in capsys.readouterr().err
    (copy / "model" / "manifest.json").write_text("{", encoding="utf-8")
    assert run(["check", str(copy / "model")]) == 2
    assert "the manifest cannot be read: it is not valid JSON" in capsys.readouterr().err
    (copy / "model" / "manifest.json").write_text("[]", encoding="utf-8")
    assert run(["check", str(copy / "model")]) == 2


def test_json_of_a_check(copy: Path, tmp_path: Path) -> None:
    edit(copy / "robot.toml", "1.5 kg", "1.6 kg")
    out = tmp_path / "check.json"
    assert run(["check", str(copy / "model"), "--json", str(out)]) == 1
    content = json.loads(out.read_text(encoding="utf-8"))
    (target,) = content["targets"]
    assert content["holds"] is False
    assert target["findings"][0]["subject"] == "platform.mass"
    assert target["mend"].startswith("pkmodes generate")
    assert target["consistency"]
    assert all(c["holds"] for c in target["consistency"])
