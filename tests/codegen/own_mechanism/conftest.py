"""The folder that a reader of docs/how-to/adding-a-mechanism.md has, and copies of it that may be changed."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

import pkmodes
from helpers.commands.adding_a_mechanism import COMMANDS, DEFINITION, MEASURING, ROBOT
from helpers.commands.own_folder import inside
from pkmodes.cli import run
from pkmodes.core.mechanism import registry as known


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files of the page, after its first command."""
    folder = tmp_path_factory.mktemp("own")
    (folder / "five_bar.py").write_text(DEFINITION, encoding="utf-8")
    (folder / "robot.toml").write_text(ROBOT, encoding="utf-8")
    with inside(folder):
        assert run(COMMANDS[0]) == 0
        exec(MEASURING, {})
    return folder


@pytest.fixture(scope="module")
def place(made: Path) -> Iterator[Path]:
    """The same folder, where commands run."""
    with inside(made):
        yield made


@pytest.fixture
def copy(place: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of it that may be changed."""
    shutil.copytree(place, tmp_path, dirs_exist_ok=True)
    monkeypatch.setattr(known, "_package_by_name", {})
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def model(place: Path) -> pkmodes.Model:
    known.add_folder(place / "build" / "five_bar")
    return pkmodes.load(place / "robot.toml")
