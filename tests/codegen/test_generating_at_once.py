"""Two processes that generate into one folder."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from helpers.commands.answers import refused
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.codegen import generation, product_folder
from pkmodes.core.base.errors import OutputError


@pytest.fixture
def other(tmp_path: Path) -> Path:
    """A robot file of another name."""
    file = tmp_path / "other.toml"
    file.write_text(published().replace('name = "linear-delta-2022"', 'name = "other"'), encoding="utf-8")
    return file


def while_deriving(monkeypatch: pytest.MonkeyPatch, happens: Callable[[], object]) -> None:
    """Let something happen once, while the next model is derived."""
    real = generation.derive_robot_model

    def derive_robot_model(specification: object) -> dict[str, str]:
        monkeypatch.setattr(generation, "derive_robot_model", real)
        happens()
        return real(specification)

    monkeypatch.setattr(generation, "derive_robot_model", derive_robot_model)


def test_two_robots_generated_at_once_are_not_mixed(
    tmp_path: Path, other: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "new" / "model"
    while_deriving(monkeypatch, lambda: generation.generate(other, out))
    error = refused("generate", PUBLISHED, "--out", out)
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
    monkeypatch.setattr(product_folder, "LOCK_TIMEOUT", 0.1)
    with product_folder.folder_lock(tmp_path / "model"):
        with pytest.raises(OutputError) as error, product_folder.folder_lock(tmp_path / "model"):
            pytest.fail("two at once")
        assert "another process has been generating into the folder" in error.value.what
    assert not (tmp_path / "model").exists(), "nothing was written"
