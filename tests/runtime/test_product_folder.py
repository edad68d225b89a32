"""The folder of a generated model: where it may be written, which files belong to the user, and copied models."""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from helpers.generated.generated_model import MODULE
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.base import writing
from pkmodes.base.errors import OutputError, PkmodesError
from pkmodes.cli import run
from pkmodes.codegen import alone, generation
from pkmodes.codegen.checking.recorded import recorded_robot
from pkmodes.codegen.product_folder import check_place
from pkmodes.robot.reading import read_robot
from pkmodes_derive.emit.provenance import pasteable
from pkmodes_rig.robots import ROBOTS

EFFECTS = '\n[effects.frame_compliance]\ncompliance = "1e-7 m/N"\n\n[effects.payload]\nmass = "0.35 kg"\n'


@pytest.fixture
def vendored(copy: Path) -> Path:
    """A copy of the model without the robot file."""
    return Path(shutil.move(copy / "model", copy.parent / "vendored"))


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


# The user's files.


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


# Where a model may be written.


def refused(robot: Path, out: str | Path, capsys: pytest.CaptureFixture[str]) -> str:
    assert run(["generate", str(robot), "--out", str(out)]) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert error.count("\n") == 1
    return error


def test_roots_home_and_repositories_are_no_place_for_a_model(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    home, repository, worktree = (tmp_path / name for name in ("home", "repository", "worktree"))
    for folder in (home, repository / ".git", worktree):
        folder.mkdir(parents=True)
    (worktree / ".git").write_text("gitdir: elsewhere", encoding="utf-8")
    (tmp_path / "link").symlink_to(home)
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.setattr(generation, "write_files", lambda *_: pytest.fail("something would be written"))
    monkeypatch.chdir(repository)
    assert "the root of the file system (/)" in refused(PUBLISHED, "/", capsys)
    assert "the root of the file system (/..)" in refused(PUBLISHED, "/..", capsys)
    assert "the home folder" in refused(PUBLISHED, home, capsys)
    assert "the home folder" in refused(PUBLISHED, tmp_path / "link", capsys)
    for out in (repository, ".", worktree):
        assert "the root of a repository" in refused(PUBLISHED, out, capsys)
    assert "an empty name" in refused(PUBLISHED, "", capsys)


def test_a_folder_with_other_things_is_left_as_it_was(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "thesis").mkdir()
    (tmp_path / "thesis" / "chapter.tex").write_text("years of work", encoding="utf-8")
    before = contents(tmp_path)
    error = refused(PUBLISHED, tmp_path / "thesis", capsys)
    assert "the folder contains other files (chapter.tex) and no manifest of a generated model" in error
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
def test_a_name_that_cannot_be_one_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    assert "cannot write: " in refused(PUBLISHED, tmp_path / name, capsys)


# Two at once.


@pytest.fixture
def other(tmp_path: Path) -> Path:
    """A robot file of another name."""
    file = tmp_path / "other.toml"
    file.write_text(published().replace('name = "linear-delta-2022"', 'name = "other"'), encoding="utf-8")
    return file


def while_deriving(monkeypatch: pytest.MonkeyPatch, happens: Callable[[], object]) -> None:
    """Let something happen once, while the next model is derived."""
    real = generation.specialised

    def specialised(specification: object) -> dict[str, str]:
        monkeypatch.setattr(generation, "specialised", real)
        happens()
        return real(specification)

    monkeypatch.setattr(generation, "specialised", specialised)


def test_two_robots_generated_at_once_are_not_mixed(
    tmp_path: Path, other: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "new" / "model"
    while_deriving(monkeypatch, lambda: generation.generate(other, out))
    error = refused(PUBLISHED, out, capsys)
    assert "another process has generated into the folder meanwhile" in error
    assert json.loads((out / "manifest.json").read_text(encoding="utf-8"))["robot"]["name"] == "other"
    assert {file.stem.removesuffix("_without_effects") for file in out.iterdir()} == {"manifest", "other"}
    assert run(["check", str(out)]) == 0


def test_one_robot_generated_twice_at_once_is_welcome(
    tmp_path: Path, other: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "new" / "model"
    while_deriving(monkeypatch, lambda: generation.generate(other, out))
    assert run(["generate", str(other), "--out", str(out)]) == 0


def test_a_folder_into_which_another_process_writes_is_waited_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(alone, "PATIENCE", 0.1)
    with alone.alone(tmp_path / "model"):
        with pytest.raises(OutputError) as error, alone.alone(tmp_path / "model"):
            pytest.fail("two at once")
        assert "another process has been generating into the folder" in error.value.what
    assert not (tmp_path / "model").exists(), "nothing was written"


# Links in a received folder.


@pytest.mark.parametrize("name", [MODULE, "linear_delta_2022.c", "manifest.json", ".pkmodes-generate.lock"])
def test_links_in_a_received_folder_are_not_followed(
    copy: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    """Also one that leads to nothing yet."""
    outside, file = copy / "outside", copy / "model" / name
    outside.write_bytes(file.read_bytes() if file.exists() else b"mine")
    before = outside.read_bytes()
    file.unlink(missing_ok=True)
    file.symlink_to(outside)
    error = refused(copy / "robot.toml", copy / "model", capsys)
    assert "symbolic link" in error
    assert outside.read_bytes() == before
    assert file.is_symlink()
    if name != "manifest.json":
        outside.unlink()
        assert "symbolic link" in refused(copy / "robot.toml", copy / "model", capsys)
        assert not outside.exists()


def test_the_folder_of_a_mechanism_may_not_be_a_link(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "outside").mkdir()
    (tmp_path / "model").mkdir()
    (tmp_path / "model" / "mine").symlink_to(tmp_path / "outside")
    (tmp_path / "mine.py").write_text("TITLE = 'x'", encoding="utf-8")
    command = ["generate", str(PUBLISHED), "--out", str(tmp_path / "model")]
    assert run([*command, "--mechanism", str(tmp_path / "mine.py")]) == 2
    assert 'found that "mine" is a symbolic link' in capsys.readouterr().err
    assert not list((tmp_path / "outside").iterdir())


def test_the_robot_file_in_the_folder_may_be_a_link(tmp_path: Path) -> None:
    (tmp_path / "model").mkdir()
    (tmp_path / "model" / "robot.toml").symlink_to(PUBLISHED)
    check_place(tmp_path / "model", [PUBLISHED], None)


def test_a_folder_of_pictures_is_not_left_by_a_link(tmp_path: Path) -> None:
    (tmp_path / "outside").mkdir()
    (tmp_path / "figures").mkdir()
    (tmp_path / "figures" / "a.svg").symlink_to(tmp_path / "outside" / "a.svg")
    (tmp_path / "figures" / "b.svg").symlink_to("c.svg")
    with pytest.raises(OutputError, match=r"a\.svg is a symbolic link that leads out of the folder"):
        writing.write_files(tmp_path / "figures", {"a.svg": "x"})
    assert not list((tmp_path / "outside").iterdir())
    writing.write_files(tmp_path / "figures", {"b.svg": "x"})
    assert (tmp_path / "figures" / "b.svg").is_symlink()
    assert (tmp_path / "figures" / "c.svg").read_text() == "x"


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


# Printed commands.


@pytest.mark.parametrize("place", ["plain", "it's a folder", 'q"uote', "star*", "-dash", "a*/b", "$HOME`x`"])
def test_the_command_in_the_header_works_where_it_is_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    folder = tmp_path / place
    folder.mkdir(parents=True)
    (folder / "-my robot.toml").write_text(published(), encoding="utf-8")
    assert run(["generate", str(folder / "-my robot.toml"), "--out", str(tmp_path / "model")]) == 0
    programs = tmp_path / "programs"
    programs.mkdir()
    (programs / "pkmodes").write_text(f'#!/bin/sh\nexec "{sys.executable}" -m pkmodes "$@"\n')
    (programs / "pkmodes").chmod(0o755)
    root = Path(__file__).parents[2]
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(str(root / p) for p in ("src", "generated", "derive")))
    monkeypatch.setenv("PATH", f"{programs}{os.pathsep}{os.environ['PATH']}")
    for name in (MODULE, "linear_delta_2022.c", "linear_delta_2022.h"):
        header = (tmp_path / "model" / name).read_text(encoding="utf-8").split("\n")[2]
        before, _, rest = header.partition("regenerate with `")
        command, _, where = rest.rpartition("`")
        assert before.endswith("Do not edit: ")
        assert where == ", run in this folder."
        assert "*/" not in command
    (tmp_path / "model" / MODULE).unlink()
    done = subprocess.run(
        ["/bin/sh", "-c", command], cwd=tmp_path / "model", capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "model" / MODULE).exists()


def test_a_robot_file_that_cannot_be_printed_is_not_named_in_the_header() -> None:
    for name in ("two\nlines.toml", "bell\a.toml", "\udcff.toml"):
        assert pasteable(name) == "ROBOT.toml"


def test_a_folder_whose_name_is_not_utf_8_can_hold_a_robot(tmp_path: Path) -> None:
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    try:
        folder.mkdir()
    except OSError:
        pytest.skip("this file system has UTF-8 names only")
    (folder / "robot.toml").write_text(published(), encoding="utf-8")
    assert run(["generate", str(folder / "robot.toml"), "--out", str(tmp_path / "model")]) == 0
    assert run(["check", str(tmp_path / "model")]) == 0


# Models copied without their robot file.


def test_a_copied_model_is_checked_without_its_robot_file(
    vendored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["check", str(vendored)]) == 0
    out = capsys.readouterr().out
    assert 'not checked: whether the robot file "../robot.toml" has changed' in out
    assert "57 relations agree with finite differences" in out
    assert f"pkmodes generate ROBOT.toml --out {vendored}" in out
    assert f"{vendored}: current\n" not in out


@pytest.mark.parametrize("name", [MODULE, "linear_delta_2022.c", "linear_delta_2022.h"])
def test_an_edit_of_a_copied_model_is_found(
    vendored: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    with (vendored / name).open("a", encoding="utf-8") as file:
        file.write("\n")
    assert run(["check", str(vendored)]) == 1
    out = capsys.readouterr().out
    assert f"{name} was edited by hand" in out
    assert f"fix with: pkmodes generate ROBOT.toml --out {vendored}" in out


def test_a_missing_output_and_another_derivation_of_a_copied_model_are_found(
    vendored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (vendored / MODULE).unlink()
    content = json.loads((vendored / "manifest.json").read_text(encoding="utf-8"))
    content["sources"]["chain.py"] = "0" * 64
    (vendored / "manifest.json").write_text(json.dumps(content), encoding="utf-8")
    assert run(["check", str(vendored)]) == 1
    out = capsys.readouterr().out
    assert f"{MODULE} is missing" in out
    assert "the derivation changed: chain.py is modified" in out


@pytest.mark.parametrize(
    ("path", "value"),
    [("platform.mass", 1.6), ("platform.mass", "x"), ("axis.1.direction", [0, 0, 0]), ("new.key", 1.0)],
)
def test_a_manifest_that_was_tampered_with_does_not_hold(
    vendored: Path, capsys: pytest.CaptureFixture[str], path: str, value: object
) -> None:
    """Hashes alone would not detect it: the code is derived again from the values in the manifest."""
    content = json.loads((vendored / "manifest.json").read_text(encoding="utf-8"))
    content["robot"]["values"][path] = value
    (vendored / "manifest.json").write_text(json.dumps(content), encoding="utf-8")
    assert run(["check", str(vendored)]) in (1, 2)
    captured = capsys.readouterr()
    assert (
        "differs from the current derivation" in captured.out or "does not record the robot" in captured.err
    )


def test_the_robot_file_of_a_copied_model_can_be_given_again(
    copy: Path, vendored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = copy / "other.toml"
    other.write_text(published().replace('name = "linear-delta-2022"', 'name = "other"'), encoding="utf-8")
    assert "already holds the model" in refused(other, vendored, capsys)
    assert run(["generate", str(copy / "robot.toml"), "--out", str(vendored)]) == 0
    capsys.readouterr()
    assert run(["check", str(vendored)]) == 0
    assert "not checked" not in capsys.readouterr().out


@pytest.mark.parametrize("effects", ["", EFFECTS])
@pytest.mark.parametrize("frame", ["", '\n[frame]\nmass = "40 kg"\n'])
@pytest.mark.parametrize("name", sorted(ROBOTS))
def test_a_manifest_records_the_whole_robot(tmp_path: Path, name: str, frame: str, effects: str) -> None:
    """To the last bit, because the constants of the derivation follow from it."""
    head, mark, axes = ROBOTS[name].partition("[[axis]]")
    text = head + ("" if "[frame]" in head else frame) + effects + "\n" + mark + axes
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    robot = read_robot(tmp_path / "robot.toml")
    values = json.loads(json.dumps(robot.declared))
    content = {"mechanism": robot.mechanism_name, "robot": {"name": robot.name, "values": values}}
    found = recorded_robot(content, "manifest")
    assert found.effects == robot.effects
    for field, value in robot.parameters._asdict().items():
        np.testing.assert_array_equal(getattr(found.parameters, field), value, strict=True)


def test_a_recorded_direction_is_not_normalised_again(tmp_path: Path) -> None:
    """A unit vector of doubles is not exactly of length 1; normalising this one changes its last digit."""
    text = published().replace("direction = [1, 0, 0]", "direction = [0.9, 0.1, 0.6]", 1)
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    robot = read_robot(tmp_path / "robot.toml")
    direction = robot.parameters.direction[0]
    assert (direction / math.hypot(*direction) != direction).any()
    values = json.loads(json.dumps(robot.declared))
    content = {"mechanism": robot.mechanism_name, "robot": {"name": robot.name, "values": values}}
    np.testing.assert_array_equal(recorded_robot(content, "manifest").parameters.direction[0], direction)


@pytest.mark.parametrize(
    "content", [{}, {"robot": None}, {"mechanism": "x", "robot": {"name": 1, "values": []}}]
)
def test_a_manifest_without_a_robot_is_refused(content: dict[str, object]) -> None:
    with pytest.raises(PkmodesError, match="does not record the robot"):
        recorded_robot(content, "manifest")
