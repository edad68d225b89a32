"""What pages say besides their code blocks, which run as those of all pages do (test_code_blocks.py)."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

import pkmodes
from pkmodes import updating
from pkmodes.cli import cli
from studies import tables

ROOT = Path(__file__).parents[1]


def block(page: str, start: str) -> str:
    """Return the code block of a page that begins with some text."""
    text = (ROOT / page).read_text(encoding="utf-8")
    (found,) = (part for part in re.findall(r"```\w*\n(.*?)```", text, re.S) if part.startswith(start))
    return found


def test_the_readme_is_short() -> None:
    """Who reads it for five minutes knows whether pkmodes is for him."""
    assert len((ROOT / "README.md").read_text(encoding="utf-8").split()) <= 800


#: The mechanisms of the tables of measured rates, as the README calls them.
MEASURED = {
    "linear_delta": "linear delta",
    "hexapod": "hexapod",
    "rotary_delta": "rotary delta",
    "hexaglide": "hexaglide",
    "corexy": "CoreXY",
}


def test_the_rates_of_the_readme_are_those_measured_of_each_mechanism() -> None:
    measured = [
        row
        for suite in ("clear-causes", "six-legs")
        for row in tables.read(ROOT / "docs/results" / suite)["requirements"].records()
        if row["requirement"].startswith(("named", "confident and wrong"))
    ]
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    kept, missed = re.split("these do not:", readme)
    for name, words in MEASURED.items():
        rows = [row for of in ("one effect", "all") for row in measured if row["group"] == f"{name}, {of}"]
        named, wrong = (f"{row['number']} of {row['cases']}" for row in rows)
        met = all(row["met"] == "met" for row in rows)
        said = (
            rf"{words} meets both \({named} named, wrong in {wrong}\)"
            if met
            else rf"{words} \({named}, {wrong}\)"
        )
        assert re.search(said, kept if met else missed), words


def test_two_effects_move_the_first_mode_as_it_says() -> None:
    text = block("docs/reference/robot-file.md", "[effects.payload]")
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


def test_a_page_shows_a_measurement_file_that_can_be_read(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text(block("docs/reference/measurement-file.md", "pose,x,y,z,"))
    found, whole = updating.read(path), updating.read(ROOT / "examples/closed_loop/measured.csv")
    assert found.channels == whole.channels
    row = whole.pose[0]
    assert whole.labels[row] == found.labels[0]
    assert found.frequency[0] == pytest.approx(whole.frequency[0], rel=1e-5)
    assert found.shapes[0] == pytest.approx(whole.shapes[0], rel=1e-5)


def test_a_page_shows_every_command() -> None:
    shown = [
        line.split()[1] for line in block("docs/reference/command-line.md", "pkmodes examples").splitlines()
    ]
    assert sorted(shown) == sorted(cli.commands)
