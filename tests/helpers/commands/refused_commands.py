"""Commands that end with an error of the user."""

from __future__ import annotations

import pytest

from pkmodes.cli import run


def refused(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    """Return the error of a command that fails."""
    capsys.readouterr()
    assert run(arguments) == 2
    return capsys.readouterr().err
