"""A complete robot file as text, and edits of it, for the tests of reading and of the command line."""

from __future__ import annotations

from pathlib import Path

PUBLISHED = Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml"


def published() -> str:
    """Text of the published robot's file."""
    return PUBLISHED.read_text(encoding="utf-8")


def edited(old: str, new: str, *, count: int = 1) -> str:
    """The published robot's file with a text replaced; the text must be there."""
    text = published()
    assert text.count(old) >= count, f"{old!r} is not in the robot file"
    return text.replace(old, new, count)
