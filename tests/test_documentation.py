"""The code and the commands of README run unchanged, and print the output shown."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

import pkmodes
from pkmodes import updating
from pkmodes.cli import run

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def block(text: str, start: str) -> str:
    """Return the code block that begins with some text."""
    (found,) = (part for part in re.findall(r"```\w*\n(.*?)```", text, re.S) if part.startswith(start))
    return found


def test_the_python_of_the_readme_prints_what_it_shows(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    names: dict[str, object] = {}
    blocks = re.findall(r"```python\n(.*?)```", README, re.S)
    for code in blocks[:2]:  # the third needs a generated module
        exec(code, names)
        shown = [line.removeprefix("# ") for line in code.splitlines() if line.startswith("# ")]
        assert capsys.readouterr().out.splitlines() == shown
    assert "import linear_delta_2022" in blocks[2]


def test_the_effects_of_the_readme_move_the_first_mode_as_it_says() -> None:
    text = block(README, "[effects.payload]")
    effects = {
        f"effects.{name}.{key}": value
        for name, table in tomllib.loads(text)["effects"].items()
        for key, value in table.items()
    }
    payload, gearbox = effects
    model = pkmodes.load(ROOT / "robots/linear-delta-2022.toml")

    def first(*names: str) -> str:
        changed = model.with_values({name: effects[name] for name in names})
        return f"{changed.frequencies([0.6, 0.0, -0.245])[3]:.3f}"

    assert f"at {first(payload)} Hz instead of {first()}" in text
    assert f"first at {first(gearbox)} Hz alone, at {first(payload, gearbox)} Hz with the payload" in text
    more = model.with_values({gearbox: effects[gearbox]})
    assert len(more.frequencies([0.6, 0.0, -0.245])) == len(model.frequencies([0.6, 0.0, -0.245])) + 3


def test_the_readme_shows_a_measurement_file_that_can_be_read(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text(block(README, "pose,x,y,z,"))
    found, whole = updating.read(path), updating.read(ROOT / "examples/closed_loop/measured.csv")
    assert found.channels == whole.channels
    row = whole.pose[0]
    assert whole.labels[row] == found.labels[0]
    assert found.frequency[0] == pytest.approx(whole.frequency[0], rel=1e-5)
    assert found.shapes[0] == pytest.approx(whole.shapes[0], rel=1e-5)


def test_the_commands_of_the_readme_work_in_a_clean_clone_and_print_what_it_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Folders do not exist unless a command creates them."""
    for name in ("robots", "examples"):
        (tmp_path / name).symlink_to(ROOT / name)
    monkeypatch.chdir(tmp_path)
    commands = [line.split("#")[0].split() for line in block(README, "pkmodes modes").splitlines()]
    assert [words[1] for words in commands] == [
        *["modes", "sensitivities", "map", "show", "figures", "generate", "check", "response"],
        *["shaper", "identify", "compare", "diagnose"],
    ]
    for words in commands:
        # tests/runtime/test_generate.py and test_check_out_of_date.py, tests/figures/test_files.py
        if words[1] in ("generate", "check", "figures"):
            continue
        assert run(words[1:]) == 0
        out = capsys.readouterr().out
    printed = " ".join(out.split())
    for line in block(README, "workshop-delta").splitlines():
        assert " ".join(line.split()) in printed
    assert (tmp_path / "corrected.toml").is_file()
