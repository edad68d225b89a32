"""The code on the Python page prints the output shown, and the page lists all fields and codes."""

from __future__ import annotations

from pathlib import Path

import pytest

import pkmodes

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")


def test_the_page_prints_what_it_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("robots", "build"):
        (tmp_path / name).mkdir()
    robot = "robots/linear-delta-2022.toml"
    (tmp_path / robot).write_bytes((ROOT / robot).read_bytes())
    monkeypatch.chdir(tmp_path)
    namespace: dict[str, object] = {"__name__": "page"}  # starts no processes
    for block in PAGE.split("```python\n")[1:]:
        code, rest = block.split("```", 1)
        exec(code, namespace)
        printed = rest.split("```")[1].removeprefix("\n") if rest.startswith("\n\n```\n") else ""
        assert capsys.readouterr().out == printed
    assert (tmp_path / "build/frequencies.npy").stat().st_size == 128 + 8 * 3 * 5 * 9


def test_the_page_lists_fields_and_codes() -> None:
    for name in (*pkmodes.Modes.FIELDS, *pkmodes.load(ROOT / "robots/linear-delta-2022.toml").reasons):
        assert f"`{name}`" in PAGE
