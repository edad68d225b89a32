"""``pkmodes examples``: what it writes is what the pages refer to, and nothing of the user's is lost."""

from __future__ import annotations

import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

from helpers.commands.answers import answer, printed, refused
from helpers.runs.processes import ROOT
from pkmodes import read_robot
from pkmodes.cli.examples import CATALOGUE
from pkmodes.loop.robot_files import supplied

ROBOT = Path("robots/corexy-printer.toml")


def contents(folder: Path) -> dict[str, bytes]:
    return {
        file.relative_to(folder).as_posix(): file.read_bytes()
        for file in sorted(folder.rglob("*"))
        if file.is_file() and "__pycache__" not in file.parts
    }


def committed() -> dict[str, bytes]:
    return {
        f"{place}/{name}": content
        for place in ("robots", "examples")
        for name, content in contents(ROOT / place).items()
    }


def test_every_example_is_listed_with_a_page_that_names_it() -> None:
    folders = {
        entry.stem for entry in (ROOT / "examples").iterdir() if not entry.name.startswith((".", "__"))
    }
    assert {one.name for one in CATALOGUE} == {"robots", *folders}
    said = printed("examples")
    for one in CATALOGUE:
        assert one.name in said
        page = (ROOT / one.page).read_text(encoding="utf-8")
        assert one.places[-1] in page, one.page
        for word in one.command.split():
            if word.startswith(("robots/", "examples/")):
                assert (ROOT / word).exists()
                assert any(word == place or word.startswith(f"{place}/") for place in one.places), one.name


def test_all_is_what_the_repository_has_and_one_is_a_part_of_it(tmp_path: Path) -> None:
    said = printed("examples", "all", "--out", tmp_path / "new" / "all")
    assert contents(tmp_path / "new" / "all") == committed()
    assert all(f"{tmp_path / 'new' / 'all' / name}\n" in said for name in committed())
    found = answer("examples", "closed_loop", "--out", tmp_path / "one", "--json", "-").json
    names = [name for name in committed() if name.startswith(("robots/", "examples/closed_loop/"))]
    assert sorted(contents(tmp_path / "one")) == sorted(found["written"]) == sorted(names)
    again = answer("examples", "closed_loop", "--out", tmp_path / "one", "--json", "-").json
    assert (again["written"], sorted(again["unchanged"])) == ([], sorted(names))


def test_a_file_that_was_changed_is_named_and_kept_and_nothing_is_written(tmp_path: Path) -> None:
    (tmp_path / "robots").mkdir()
    (tmp_path / ROBOT).write_text("mine", encoding="utf-8")
    error = refused("examples", "all", "--out", tmp_path)
    assert f"{tmp_path / ROBOT}: the file exists with another content" in error
    assert contents(tmp_path) == {ROBOT.as_posix(): b"mine"}
    printed("examples", "all", "--out", tmp_path, "--overwrite")
    assert contents(tmp_path) == committed()


def test_what_cannot_be_written_leaves_nothing_behind(tmp_path: Path) -> None:
    (tmp_path / "robots").write_text("a file where a folder should be", encoding="utf-8")
    refused("examples", "closed_loop", "--out", tmp_path)
    assert [entry.name for entry in tmp_path.iterdir()] == ["robots"]
    (tmp_path / "outside").mkdir()
    (tmp_path / "here").mkdir()
    (tmp_path / "here" / "robots").symlink_to(tmp_path / "outside")
    assert "is below a symbolic link that leads out" in refused(
        "examples", "robots", "--out", tmp_path / "here"
    )
    assert not list((tmp_path / "outside").iterdir())


def test_an_installed_program_has_them_beside_its_modules(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where hatch_build.py puts them; .ci/smoke.py asks a real wheel."""
    installed, here = tmp_path / "site-packages/pkmodes/supplied", tmp_path / "here"
    assert f'"pkmodes/{supplied.ROOTS[0].name}/' in (ROOT / "hatch_build.py").read_text(encoding="utf-8")
    monkeypatch.setattr(supplied, "ROOTS", (installed, tmp_path / "none"))
    assert "found no robot files and examples" in refused("examples", "robots", "--out", here)
    shutil.copytree(ROOT / "robots", installed / "robots")
    (installed / ROBOT).write_text("of the wheel", encoding="utf-8")
    (installed / "robots" / "__pycache__").mkdir()
    (installed / "robots" / "__pycache__" / "left.pyc").write_bytes(b"")
    printed("examples", "robots", "--out", here)
    assert (here / ROBOT).read_text(encoding="utf-8") == "of the wheel"
    assert not (here / "robots" / "__pycache__").exists()


def test_every_committed_file_is_one_that_is_written() -> None:
    """Files that git does not know would go into a wheel that is built here."""
    listed = subprocess.run(
        ["git", "ls-files", "robots", "examples"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if listed.returncode:
        pytest.skip("this is no clone")
    assert set(listed.stdout.split()) == committed().keys()


def test_the_motors_of_a_robot_do_in_use_what_they_did_in_its_test() -> None:
    """Except where the motors of its file are springs, which is a state of free motors."""
    campaigns = sorted((ROOT / "examples").glob("*/campaign.toml"))
    assert len(campaigns) >= 5
    for file in campaigns:
        campaign = tomllib.loads(file.read_text(encoding="utf-8"))
        robot = read_robot(file.parent / "robot.toml")
        has_springs = any(name.startswith("servo_stiffness.") for name in robot.effects)
        assert robot.drives == ("free" if has_springs else campaign.get("drives", "free")), file
