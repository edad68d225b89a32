"""What docs/maps.md says about commands and marks; its blocks run with those of the other pages."""

from __future__ import annotations

import re
from pathlib import Path

from pkmodes.dataset.variables import EVENTS
from pkmodes.maps.tracking import CLEAR, SAME

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "maps.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE, re.DOTALL | re.MULTILINE)


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
