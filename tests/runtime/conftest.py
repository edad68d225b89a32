"""A generated model that several test files copy and corrupt."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from helpers.robots.robot_text import published
from helpers.runs.shared import Shared
from pkmodes.cli import run


@pytest.fixture(scope="session")
def pristine(shared: Shared) -> Path:
    """A robot file and its generated model, to be copied and corrupted."""

    def generate(folder: Path) -> None:
        (folder / "robot.toml").write_text(published(), encoding="utf-8")
        assert run(["generate", str(folder / "robot.toml"), "--out", str(folder / "model")]) == 0

    return shared.folder("pristine", generate)


@pytest.fixture
def copy(pristine: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(pristine, tmp_path / "copy"))
