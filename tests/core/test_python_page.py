"""The Python page lists all fields and codes; tests/test_code_blocks.py runs its code."""

from __future__ import annotations

from pathlib import Path

import pkmodes

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "how-to/python.md").read_text(encoding="utf-8")


def test_the_page_lists_fields_and_codes() -> None:
    for name in (*pkmodes.Modes.FIELDS, *pkmodes.load(ROOT / "robots/linear-delta-2022.toml").reasons):
        assert f"`{name}`" in PAGE
