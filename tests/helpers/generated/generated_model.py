"""Files of the model that ``pkmodes generate`` writes for the published robot, and edits of them."""

from __future__ import annotations

from pathlib import Path

MODULE = "linear_delta_2022.py"


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
