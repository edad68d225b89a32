"""Every example of the repository, as its command is printed, with a page beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.commands.answers import answer
from helpers.pages.browser import opened
from helpers.runs.processes import ROOT
from pkmodes.cli.examples import CATALOGUE

#: Commands that write a page with `--report`.
WITH_PAGES = ("identify", "diagnose", "changed")
COMMANDS = {one.name: one.command.split()[1:] for one in CATALOGUE if one.command.split()[1] in WITH_PAGES}


def test_no_campaign_is_left_out() -> None:
    named = {word for words in COMMANDS.values() for word in words}
    assert {
        path.relative_to(ROOT).as_posix() for path in (ROOT / "examples").glob("*/campaign.toml")
    } <= named


@pytest.mark.slow
@pytest.mark.parametrize("name", COMMANDS)
def test_it_writes_its_page(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    words = [str(tmp_path / word) if word == "modes.csv" else word for word in COMMANDS[name]]
    page = tmp_path / "page.html"
    found = answer(*words, "--report", page, "--json", tmp_path / "result.json")
    assert found.code == 0, found.err
    assert str(page) in found.out + found.err
    text = page.read_text(encoding="utf-8")
    assert text.count("<svg") >= 1
    assert text.rstrip().endswith("</html>")
    with opened(page, width=1280, height=900) as view:  # as it opens, most sections are folded
        assert view.page.evaluate("document.documentElement.scrollHeight") <= 6 * 900
