"""One rule for what exists where a command writes, as docs/reference/command-line.md has it."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import pytest

from helpers.commands.answers import answer, printed, refused
from helpers.runs.processes import ROOT
from pkmodes import load
from pkmodes.core.base.errors import OutputError
from pkmodes.pages.figures.files import write_pictures
from pkmodes.pages.figures.pictures import PICTURES

PRINTER = ROOT / "robots" / "corexy-printer.toml"
POSE = ("--pose", "0.15,0.15")
GRID = ("--grid", "x=0.05:0.25:4,y=0.05:0.25:4")
CHANNELS = ("--inputs", "force_x", "--outputs", "p_x", "--frequencies", "5:50:9")
MINE = "something of the user"


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    "command",
    [
        ("modes", PRINTER, *POSE, "--json", "FILE.json"),
        ("sensitivities", PRINTER, *POSE, "--parameters", "belt.width", "--json", "FILE.json"),
        ("show", PRINTER, *POSE, "--out", "FILE.html"),
        (
            "response",
            PRINTER,
            *POSE,
            "--inputs",
            "force_x",
            "--outputs",
            "p_x",
            "--frequencies",
            "5:50:9",
            "--out",
            "FILE.csv",
        ),
    ],
    ids=lambda command: command[0],
)
def test_a_file_that_is_named_is_replaced(here: Path, command: tuple[object, ...]) -> None:
    target = here / str(command[-1])
    target.write_text(MINE)
    assert answer(*command).code == 0
    assert target.read_text() != MINE
    assert list(here.iterdir()) == [target]


def test_a_page_whose_name_nobody_gave_replaces_only_another_such_page(here: Path) -> None:
    page = here / "corexy-printer.html"
    page.write_text('<!DOCTYPE html>\n<html lang="en"><head><title>Diagnosis: corexy-printer</title>')
    before = page.read_bytes()
    error = refused("show", PRINTER, *POSE)
    assert "corexy-printer.html: the file exists, and is not a page of pkmodes show (--out)" in error
    assert "--out FILE.html" in error
    assert page.read_bytes() == before
    assert printed("show", PRINTER, *POSE, "--overwrite") == "corexy-printer.html\n"
    written = page.read_bytes()
    assert written != before
    assert printed("show", PRINTER, "--pose", "0.1,0.1") == "corexy-printer.html\n"
    assert page.read_bytes() != written


@pytest.mark.parametrize("form", ["svg", "png", "pdf"])
def test_pictures_replace_only_pictures_of_their_kind(
    here: Path, monkeypatch: pytest.MonkeyPatch, form: str
) -> None:
    monkeypatch.setattr("pkmodes.pages.figures.files.PICTURES", PICTURES[1:2])
    monkeypatch.setattr(import_module("pkmodes.pages.figures.pictures"), "PICTURES", PICTURES[1:2])
    command, folder = ("figures", PRINTER, *GRID, "--out", "pictures", "--format", form), here / "pictures"
    file = folder / f"{PICTURES[1].name}.{form}"
    folder.mkdir()
    file.write_text(MINE)
    error = refused(*command)
    assert f"pictures/{file.name}: the file exists, and is not such a figure (--out)" in error
    assert "--overwrite" in error
    assert file.read_text() == MINE
    with pytest.raises(OutputError, match="is not such a figure"):
        write_pictures(load(PRINTER), folder, formats=[form])
    assert answer(*command, "--overwrite").code == 0
    written = file.read_bytes()
    assert written != MINE.encode()
    assert answer(*command, "--drives", "free").code == 0, "those of another run"
    assert file.read_bytes() != written


def test_a_robot_file_that_was_edited_is_replaced_only_if_asked(here: Path) -> None:
    printed("new", "corexy", "--out", "mine.toml")
    new = (here / "mine.toml").read_text()
    printed("new", "corexy", "--out", "mine.toml")
    (here / "mine.toml").write_text(new + "# measured by me\n")
    assert "the file exists with another content" in refused("new", "corexy", "--out", "mine.toml")
    assert (here / "mine.toml").read_text().endswith("# measured by me\n")
    printed("new", "corexy", "--out", "mine.toml", "--overwrite")
    assert (here / "mine.toml").read_text() == new


def test_an_input_is_never_replaced(here: Path) -> None:
    robot = here / "page.html"
    robot.write_bytes(PRINTER.read_bytes())
    for options in (("--out", robot), ("--out", robot, "--overwrite"), ("--json", robot), ()):
        assert "would replace its own input" in refused("show", robot, *options)
    assert robot.read_bytes() == PRINTER.read_bytes()
