"""The files of a mechanism: changes are found and mended, and other files are left alone."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from helpers.commands.adding_a_mechanism import DEFINITION
from helpers.commands.answers import refused
from pkmodes.cli import run
from pkmodes.core.mechanism import registry as known


def test_a_changed_definition_is_found_and_mended(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    changed = DEFINITION.replace("m_a[j], (base, elbow)", "2 * m_a[j], (base, elbow)")
    assert changed != DEFINITION
    (copy / "five_bar.py").write_text(changed)
    assert run(["check", "build", "build/five_bar"]) == 1
    out = capsys.readouterr().out
    assert out.count("the definition changed: five_bar.py differs from the file this was derived from") == 2
    mend = "pkmodes generate --mechanism five_bar.py robot.toml --out build"
    assert f"fix with: {mend}\n" in out
    assert run(mend.split()[1:]) == 0
    assert run(["check", "--mechanism", "build/five_bar", "build", "build/five_bar"]) == 0


def test_what_was_edited_by_hand_is_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("model.py", "definition.py"):
        file = copy / "build/five_bar" / name
        text = file.read_text()
        file.write_text(text.replace("sqrt(", "sqrt(1.0 * ", 1))
        assert run(["check", "build/five_bar"]) == 1
        assert f"{name} was edited by hand" in capsys.readouterr().out
        file.write_text(text)


def test_a_folder_that_was_handed_on_alone_is_checked(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    moved = shutil.move(copy / "build/five_bar", copy / "elsewhere")
    (copy / "five_bar.py").unlink()
    assert run(["check", "--mechanism", moved]) == 0
    assert 'not checked: whether the definition "../../five_bar.py" has changed' in capsys.readouterr().out
    assert run(["generate", "--mechanism", moved, "robot.toml", "--out", "other"]) == 0
    assert sorted(path.name for path in (copy / "other").iterdir()) == [
        "manifest.json",
        *(f"pick_and_place.{end}" for end in ("c", "h", "py")),
    ]
    assert run(["check", "--mechanism", moved, "other"]) == 0
    known._package_by_name.clear()
    assert "--mechanism DIR/<mechanism>" in refused("check", "build")


def test_other_files_in_the_place_of_the_mechanism_are_left_alone(copy: Path) -> None:
    (copy / "new" / "five_bar").mkdir(parents=True)
    (copy / "new" / "five_bar" / "notes.txt").write_text("mine")
    arguments = ["generate", "--mechanism", "five_bar.py", "robot.toml", "--out", "new"]
    assert "the folder contains other files (notes.txt)" in refused(*arguments)
    (copy / "new" / "five_bar" / "notes.txt").unlink()
    assert run(arguments) == 0
    shutil.copytree(copy / "build", copy / "third" / "five_bar")
    arguments[-1] = "third"
    assert "the folder holds generated files other than the code" in refused(*arguments)
