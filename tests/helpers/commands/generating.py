"""What tests of generated models share: the contents of a folder, and a refused place."""

from __future__ import annotations

from pathlib import Path

import pytest

from pkmodes.cli import run


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def refused(robot: Path, out: str | Path, capsys: pytest.CaptureFixture[str]) -> str:
    assert run(["generate", str(robot), "--out", str(out)]) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert error.count("\n") == 1
    return error
