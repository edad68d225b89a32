"""Where a model may be written, and which of the files there are the user's."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from helpers.commands.answers import refused
from helpers.generated.generated_model import MODULE
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.codegen import generation
from pkmodes.core.base.errors import OutputError
from pkmodes.core.support import writing


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_files_of_the_user_are_no_concern_of_check_and_survive_generate(
    copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model = copy / "model"
    own = {"README.md": "mine", "main.c": '#include "linear_delta_2022.h"\n', "notes/todo.txt": "", "a.o": ""}
    (model / "notes").mkdir()
    for name, text in own.items():
        (model / name).write_text(text, encoding="utf-8")
    (model / "current.py").symlink_to(model / MODULE)
    assert run(["check", str(model)]) == 0
    out = capsys.readouterr().out
    assert "rm " not in out
    assert not any(name in out for name in (*own, "current.py"))
    (copy / "robot.toml").write_text(published().replace('name = "linear-delta-2022"', 'name = "new"'))
    assert run(["generate", str(copy / "robot.toml"), "--out", str(model)]) == 0
    assert {name: (model / name).read_text(encoding="utf-8") for name in own} == own
    assert not (model / MODULE).exists()
    assert (model / "new.py").exists()


def test_only_what_the_generator_wrote_is_an_orphan(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = copy / "model"
    for name in (MODULE, "linear_delta_2022.c", "linear_delta_2022.h"):
        shutil.copy(model / name, model / f"old_{name}")
    (model / "main.c").write_text("int main(void) { return 0; }\n", encoding="utf-8")
    assert run(["check", str(model), "--json", "-"]) == 1
    (target,) = json.loads(capsys.readouterr().out)["targets"]
    orphans = [finding["subject"] for finding in target["findings"]]
    assert orphans == ["old_linear_delta_2022.c", "old_linear_delta_2022.h", f"old_{MODULE}"]
    subprocess.run(target["mend"], shell=True, check=True)
    assert run(["check", str(model)]) == 0
    assert (model / "main.c").exists()


def test_a_name_that_a_file_of_the_user_has_is_refused(
    copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (copy / "model" / "helper.c").write_text("mine", encoding="utf-8")
    (copy / "robot.toml").write_text(published().replace('name = "linear-delta-2022"', 'name = "helper"'))
    before = contents(copy / "model")
    assert run(["generate", str(copy / "robot.toml"), "--out", str(copy / "model")]) == 2
    assert "helper.c would be replaced, but it was not generated" in capsys.readouterr().err
    assert contents(copy / "model") == before


def test_roots_home_and_repositories_are_no_place_for_a_model(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    home, repository, worktree = (tmp_path / name for name in ("home", "repository", "worktree"))
    for folder in (home, repository / ".git", worktree):
        folder.mkdir(parents=True)
    (worktree / ".git").write_text("gitdir: elsewhere", encoding="utf-8")
    (tmp_path / "link").symlink_to(home)
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.setattr(generation, "write_files", lambda *_: pytest.fail("something would be written"))
    monkeypatch.chdir(repository)
    assert "the root of the file system (/)" in refused("generate", PUBLISHED, "--out", "/")
    assert "the root of the file system (/..)" in refused("generate", PUBLISHED, "--out", "/..")
    assert "the home folder" in refused("generate", PUBLISHED, "--out", home)
    assert "the home folder" in refused("generate", PUBLISHED, "--out", tmp_path / "link")
    for out in (repository, ".", worktree):
        assert "the root of a repository" in refused("generate", PUBLISHED, "--out", out)
    assert "an empty name" in refused("generate", PUBLISHED, "--out", "")


@pytest.mark.parametrize("name", ["chapter.tex", MODULE])
def test_a_folder_with_other_things_is_left_as_it_was(tmp_path: Path, name: str) -> None:
    """Also with a file that has the name of a generated one."""
    (tmp_path / "thesis").mkdir()
    (tmp_path / "thesis" / name).write_text("years of work", encoding="utf-8")
    before = contents(tmp_path)
    error = refused("generate", PUBLISHED, "--out", tmp_path / "thesis")
    assert f"the folder contains other files ({name}) and no manifest of a generated model" in error
    assert "; name a new or empty folder, such as --out " in error
    assert contents(tmp_path) == before


def test_an_empty_folder_and_one_with_the_robot_file_alone_are_welcome(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / ".gitkeep").touch()
    (tmp_path / "robot.toml").write_text(published(), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert run(["generate", "robot.toml", "--out", "."]) == 0
    assert run(["check", "."]) == 0


@pytest.mark.parametrize("name", ["x" * 300, "a\0b"])
def test_a_name_that_cannot_be_one_is_refused(tmp_path: Path, name: str) -> None:
    assert "cannot write: " in refused("generate", PUBLISHED, "--out", tmp_path / name)


def test_a_folder_whose_name_is_not_utf_8_can_hold_a_robot(tmp_path: Path) -> None:
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    try:
        folder.mkdir()
    except OSError:
        pytest.skip("this file system has UTF-8 names only")
    (folder / "robot.toml").write_text(published(), encoding="utf-8")
    assert run(["generate", str(folder / "robot.toml"), "--out", str(tmp_path / "model")]) == 0
    assert run(["check", str(tmp_path / "model")]) == 0


@pytest.fixture
def without_space(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", full)
        yield


@pytest.mark.usefixtures("without_space")
def test_folders_made_for_a_failed_output_are_removed(tmp_path: Path) -> None:
    with pytest.raises(OutputError):
        writing.write_files(tmp_path / "a" / "b", {"c": ""})
    assert list(tmp_path.iterdir()) == []
