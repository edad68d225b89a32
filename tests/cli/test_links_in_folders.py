"""Symbolic links in the folders of models and pictures."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.commands.answers import refused
from helpers.generated.generated_model import MODULE
from helpers.robots.robot_text import PUBLISHED
from pkmodes.cli import run
from pkmodes.codegen.product_folder import check_place
from pkmodes.core.base.errors import OutputError
from pkmodes.core.support import writing


@pytest.mark.parametrize("name", [MODULE, "linear_delta_2022.c", "manifest.json", ".pkmodes-generate.lock"])
def test_links_in_a_received_folder_are_not_followed(copy: Path, name: str) -> None:
    """Also one that leads to nothing yet."""
    outside, file = copy / "outside", copy / "model" / name
    outside.write_bytes(file.read_bytes() if file.exists() else b"mine")
    before = outside.read_bytes()
    file.unlink(missing_ok=True)
    file.symlink_to(outside)
    error = refused("generate", copy / "robot.toml", "--out", copy / "model")
    assert "symbolic link" in error
    assert outside.read_bytes() == before
    assert file.is_symlink()
    if name != "manifest.json":
        outside.unlink()
        assert "symbolic link" in refused("generate", copy / "robot.toml", "--out", copy / "model")
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
