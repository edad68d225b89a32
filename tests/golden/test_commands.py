"""What every command says and writes on the robots and examples of the repository is frozen.

A change that is meant is written by ``pytest tests/golden --update-golden``, and reviewed as a diff of these files.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from helpers.golden.agreement import CALCULATED, FITTED, differences
from helpers.golden.outcomes import commands, golden, outcome, update
from helpers.pages.numbers_of_summaries import without_place
from helpers.pages.page_reading import read

COMMANDS = commands()
#: Of the commands whose numbers are not calculated alone.
TOLERANCES = {"identify": FITTED, "diagnose": FITTED, "changed": FITTED}


@pytest.mark.compiler
@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_says_and_writes_what_it_did(
    name: str, tmp_path: Path, pytestconfig: pytest.Config
) -> None:
    found, frozen = outcome(COMMANDS[name], tmp_path), golden(name)
    if pytestconfig.getoption("update_golden"):
        update(name, found)
        return
    assert found.keys() == frozen.keys()
    tolerance = TOLERANCES.get(name.partition("/")[0], CALCULATED)
    wrong = [place for file in frozen for place in differences(file, frozen[file], found[file], tolerance)]
    assert not wrong, "\n".join(wrong)
    page, document = tmp_path / "page.html", tmp_path / "out.json"
    if page.exists() and document.exists() and not name.startswith("show/"):
        content = json.loads(document.read_text(encoding="utf-8"))
        invented = without_place(read(page.read_text(encoding="utf-8")), content)
        assert not invented, "\n".join(invented)
