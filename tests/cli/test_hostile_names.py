"""Names that the user did not choose cannot control the terminal: those of files, and what files contain."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from helpers.robots.robot_text import PUBLISHED
from helpers.runs.processes import ROOT
from pkmodes.cli import run
from pkmodes.cli.printing import echo
from pkmodes.cli.terminal import Terminal
from pkmodes.pages.report.blocks import Cell, Column, Table

MODES = ROOT / "examples" / "closed_loop" / "measured.csv"
#: Clears the screen, sets the title of the window, turns the direction of writing; a single character for the first.
HOSTILE = "a\x1b[2J\x1b]0;b\x07\n\u202ec\x9b2J"


def harmless(text: str) -> bool:
    return all(line.isprintable() for line in text.split("\n"))


@pytest.mark.parametrize(
    "arguments",
    [
        ["modes", "{}.toml", "--pose", "0.6,0,-0.245"],
        ["modes", str(PUBLISHED), "--pose", "0.6,0,-0.245", "--json", "{}/x.json"],
        ["modes", str(PUBLISHED), "--pose", "{}"],
        ["compare", str(PUBLISHED), "{}.csv"],
        ["map", str(PUBLISHED), "--out", "{}.txt"],
        ["map", str(PUBLISHED), "--poses", "{}.csv"],
        ["generate", str(PUBLISHED), "--out", "{}/\0"],
        ["check", "{}"],
        ["show", str(PUBLISHED), "--out", "{}"],
        ["figures", "{}", "--out", "x"],
        ["sensitivities", "{}", "--pose", "0"],
        ["{}"],
        ["modes", "--{}"],
    ],
)
def test_names_cannot_control_the_terminal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], arguments: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run([argument.replace("{}", HOSTILE) for argument in arguments]) == 2
    printed = capsys.readouterr()
    assert harmless(printed.err)
    assert printed.err.count("\n") == 1
    assert harmless(printed.out)


@pytest.mark.usefixtures("no_drawing")
@pytest.mark.parametrize(
    "arguments",
    [
        ["generate", "{}.toml", "--out", "{}"],
        ["show", "{}.toml"],
        ["show", "{}.toml", "--out", "{}.html"],
        ["map", "{}.toml", "--grid", "x=0.6,y=0,z=-0.245", "--out", "{}.nc", "--report", "{}.html"],
        ["compare", "{}.toml", "{}.csv", "--report", "{}.html"],
    ],
)
def test_names_of_what_was_written_cannot_control_the_terminal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], arguments: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path(f"{HOSTILE}.toml").write_bytes(PUBLISHED.read_bytes())
    Path(f"{HOSTILE}.csv").write_bytes(MODES.read_bytes())
    result = [*[argument.replace("{}", HOSTILE) for argument in arguments], "--json", "result.json"]
    assert run(result) == 0
    printed = capsys.readouterr()
    assert harmless(printed.err)
    assert harmless(printed.out)
    assert "\\x1b[2J" in printed.out
    text = Path("result.json").read_text(encoding="utf-8")
    assert harmless(text)
    assert any(HOSTILE in str(value) for value in json.loads(text).values()) or arguments[0] == "compare"


def test_differences_of_a_received_folder_cannot_control_the_terminal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "model"
    assert run(["generate", str(PUBLISHED), "--out", str(folder)]) == 0
    file = folder / "linear_delta_2022.py"
    file.write_text(f"{file.read_text(encoding='utf-8')}\n# {HOSTILE}\n", encoding="utf-8")
    capsys.readouterr()
    assert run(["check", str(folder), "--diff"]) == 1
    printed = capsys.readouterr().out
    assert "\\x1b[2J" in printed
    assert harmless(printed)


def test_sentences_and_tables_cannot_control_the_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    terminal = Terminal()
    terminal.heading(HOSTILE)
    terminal.line(HOSTILE)
    terminal.block(Table("", [Column("name")], [[Cell(HOSTILE)]]))
    echo(f"\n{HOSTILE}")
    printed = capsys.readouterr().out
    assert harmless(printed)
    assert printed.count("\\x1b[2J") == 4
    assert printed.count("\n") == 6
