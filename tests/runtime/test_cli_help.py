"""The help of every command, in a terminal of 80 columns."""

from __future__ import annotations

import pytest

from pkmodes.cli import cli, run


@pytest.mark.parametrize("command", ["", *cli.commands])
def test_help_fits_80_columns_and_shows_an_example(
    command: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert run([*([command] if command else []), "--help"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    assert any(line.startswith("    pkmodes ") for line in lines)
