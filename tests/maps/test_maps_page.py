"""The commands and the code of docs/maps.md run unchanged, and print the output shown."""

from __future__ import annotations

import re
from pathlib import Path

import matplotlib as mpl
import pytest

from pkmodes.cli import run
from pkmodes.maps.pairing import CLEAR, EVENTS, SAME

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "maps.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE, re.DOTALL | re.MULTILINE)


def test_the_page_prints_what_it_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "build").mkdir()
    (tmp_path / "robots").symlink_to(ROOT / "robots")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "110")
    mpl.use("Agg")
    names: dict[str, object] = {}
    checked, printed = 0, ""
    for language, text in BLOCKS:
        if language == "python":
            assert printed == ""
            exec(text, names)
            printed = capsys.readouterr().out
        elif text.startswith("pkmodes map "):
            assert run(text.split()[1:]) == 0
            printed = capsys.readouterr().out
        elif not text.startswith("dask scheduler"):
            assert text == printed
            checked, printed = checked + 1, ""
    assert printed == ""
    assert checked == 7
    assert (tmp_path / "build/map.nc").is_file()


def test_the_commands_for_other_machines_are_those_that_are_tested() -> None:
    (text,) = (text for _, text in BLOCKS if text.startswith("dask scheduler"))
    words = text.splitlines()[-1].split()
    assert words[:2] == ["pkmodes", "map"]
    assert words[3] == "--scheduler"


def test_marks_are_those_of_the_code() -> None:
    for name, bit in EVENTS.items():
        assert f"| `{name}` | {bit} |" in PAGE
    assert f"at least {CLEAR:g} |" in PAGE
    assert f"below {SAME:g}, but" in PAGE
