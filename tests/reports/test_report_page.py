"""docs/report.md: its code runs, and it lists the sections that a report has."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from helpers.pages.page_reading import read
from helpers.pages.report_examples import made_up
from pkmodes.cli import run
from pkmodes.report import report

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "report.md").read_text(encoding="utf-8")


def test_its_code_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.S)
    names: dict[str, str] = {}
    exec(code, names)
    assert names["html"].startswith("<!DOCTYPE html>")


@pytest.mark.usefixtures("no_drawing")
def test_its_commands_are_those_of_the_command_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (block,) = re.findall(r"```sh\n(pkmodes compare.*?)```", PAGE, re.S)
    first, second = block.strip().splitlines()
    monkeypatch.chdir(ROOT)
    arguments = first.split()[1:]
    assert run([*arguments[:-1], str(tmp_path / arguments[-1])]) == 0
    assert (tmp_path / "compared.html").is_file()
    assert second.split()[1] == "diagnose"
    assert second.split()[2:-1] == arguments[1:-1]


@pytest.mark.usefixtures("no_drawing")
def test_it_lists_the_sections() -> None:
    result, data = made_up(4, 3)
    titles = [title.text for title in read(report(result, data=data)).all("h2")][1:]
    table = re.findall(r"^\| ([^|]+?) \|", PAGE, re.M)[1:]
    listed = [part for cell in table for part in re.split(", or |, ", cell)]
    assert set(titles) <= set(listed)
    # the made-up result has neither rivals nor damping, and no robot to show
    missing = {"Remaining explanations", "Damping", "In three dimensions"}
    assert set(listed) - set(titles) == {"---", "Summary", *missing}
    assert [t for t in listed if t in titles] == titles
