"""Fixtures of several folders of tests: a terminal, the published robot, its generated model, and a diagnosis."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import pkmodes
from helpers.diagnoses.examples import example
from helpers.robots.robot_text import PUBLISHED, published
from helpers.runs.shared import Shared
from pkmodes import updating
from pkmodes.cli import run
from pkmodes.loop.diagnosis import Diagnosis


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


@pytest.fixture
def eighty(monkeypatch: pytest.MonkeyPatch) -> None:
    """A terminal of 80 columns."""
    monkeypatch.setenv("COLUMNS", "80")


@pytest.fixture(scope="session")
def model() -> pkmodes.Model:
    return pkmodes.load(PUBLISHED)


@pytest.fixture(scope="session")
def found(shared: Shared) -> Diagnosis:
    """What examples/closed_loop is diagnosed as, where the gearboxes alone are suspected."""
    return example(shared, "closed_loop", candidates=("gearbox_compliance",))


@pytest.fixture
def diagnosed(found: Diagnosis, monkeypatch: pytest.MonkeyPatch) -> Diagnosis:
    """The engine is tested elsewhere; here its result is given."""
    monkeypatch.setattr(updating, "diagnose", lambda *_, **__: found)
    return found
