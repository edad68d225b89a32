"""``pkmodes compare`` of two robot files: what it prints, writes, draws and refuses."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.answers import printed, refused
from helpers.commands.printed_tables import printed_table
from helpers.pages.page_reading import source_of
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.pages.plots.changes import colour_scale_limit

pytestmark = pytest.mark.usefixtures("eighty")

ROOT = Path(__file__).parents[2]
PRINTER = str(ROOT / "robots/corexy-printer.toml")
VORON = str(ROOT / "examples/voron/robot.toml")
GRID = ("--grid", "x=0.05:0.25:5,y=0.05:0.25:5")


@pytest.mark.parametrize(
    "pair",
    [
        (PRINTER, VORON),
        (str(PUBLISHED), str(ROOT / "robots/linear-delta-2022-identified.toml")),
        (str(ROOT / "robots/clavel-delta.toml"),) * 2,
    ],
)
@pytest.mark.parametrize("options", [(), ("--all", "--drives", "held")])
def test_it_prints_values_and_frequencies_within_80_columns(
    pair: tuple[str, str], options: tuple[str, ...]
) -> None:
    out = printed("compare", *pair, *options)
    lines = out.splitlines()
    assert [line.split(":")[0] for line in lines[:2]] == ["first", "second"]
    assert max(map(len, lines[2:])) <= 80
    assert f"motors {'held' if options else 'free'}" in " ".join(out.split())
    assert not re.search(r"[-+]0\.00\b", out)
    assert out.count("\nmode partner ") + out.count("\nmode  partner ") == 1


def test_the_numbers_are_those_of_the_two_models() -> None:
    """Held, a CoreXY has two modes whose order does not change between these machines."""
    found = json.loads(printed("compare", PRINTER, VORON, *GRID, "--drives", "held", "--json", "-"))
    axis = np.linspace(0.05, 0.25, 5)
    poses = np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2)
    f, g = (pkmodes.load(file).frequencies(poses, drives="held") for file in (PRINTER, VORON))
    assert found["poses"] == {"both": 25, "first_only": 0, "second_only": 0, "none": 0}
    out = printed("compare", PRINTER, VORON, *GRID, "--drives", "held")
    titles = ("mode", "partner", "2 %", "median", "98 %", "exchanged [%]", "MAC")
    shown = printed_table(out, *titles)
    for mode, cells in zip(found["modes"], shown, strict=True):
        relative = (g / f - 1.0)[:, mode["mode"] - 1]
        assert mode["median"] == pytest.approx(np.median(relative), rel=1e-9)
        assert (mode["low"], mode["high"]) == pytest.approx(
            tuple(np.quantile(relative, [0.02, 0.98])), rel=1e-9
        )
        assert (mode["partner"], mode["exchanged"]) == (mode["mode"], 0.0)
        quantiles = 100.0 * np.quantile(relative, [0.02, 0.5, 0.98])
        same = str(mode["mode"])
        assert cells == [same, same, *(f"{one:+.2f}" for one in quantiles), "0.0", f"{mode['mac']:.3f}"]
    assert (found["effects_added"], found["effects_removed"]) == (["servo_stiffness"], [])


def test_the_largest_values_come_first_and_all_of_them_if_asked() -> None:
    values = json.loads(printed("compare", PRINTER, VORON, *GRID, "--json", "-"))["values"]
    assert len(values) > 10
    titles = ("quantity", "first", "second", "difference [%]", "sigma, first", "sigma, second", "unit")
    short = printed("compare", PRINTER, VORON, *GRID)
    assert f"The 10 that differ most of {len(values)}; all: --all, --json or --report." in " ".join(
        short.split()
    )
    # What only one of them declares has no relative difference, and comes first.
    by_size = sorted(
        values, key=lambda value: -abs(np.inf if value["relative"] is None else value["relative"])
    )
    rows = printed_table(short, *titles)
    assert [row[0] for row in rows] == [value["path"] for value in by_size[:10]]
    for (_, first, second, difference, *_), value in zip(rows, by_size, strict=False):
        for cell, key in ((first, "first"), (second, "second")):
            assert cell == ("-" if value[key] is None else f"{value[key]:.6g}")
        assert difference == ("-" if value["relative"] is None else f"{100.0 * value['relative']:+.2f}")
    rows = printed_table(printed("compare", PRINTER, VORON, *GRID, "--all"), *titles)
    assert sorted(row[0] for row in rows) == sorted(value["path"] for value in values)


def test_the_same_robot_twice(tmp_path: Path) -> None:
    page = tmp_path / "same.html"
    out = printed("compare", PRINTER, PRINTER, *GRID, "--report", page)
    assert "  declared values that differ: 0 of 19\n" in out
    assert "note: The two files declare the same robot" in out
    text = source_of(page)
    assert "no frequency changes by more than 0.005 %" in text
    assert "No frequency changes" in text


def test_the_report_draws_the_difference_and_is_the_same_twice(tmp_path: Path) -> None:
    other = tmp_path / "other.toml"
    name = 'name = "<b>heavy</b>"'
    text = re.sub(r"(?m)^name = .*$", name, published()).replace('"1.5 kg"', '"1.9 kg"')
    other.write_text(text, encoding="utf-8")
    grid = ("--grid", "x=0.4:0.8:9,y=-0.05:0.05:5,z=-0.245")
    pages = []
    for i in range(2):
        page = tmp_path / f"{i}.html"
        assert run(["compare", str(PUBLISHED), str(other), *grid, "--report", str(page)]) == 0
        pages.append(page.read_bytes())
    assert pages[0] == pages[1]
    assert len(pages[0]) < 6_000_000
    html = pages[0].decode()
    assert "<b>heavy" not in html
    assert "&lt;b&gt;heavy" in html
    assert html.count("Difference of the frequencies") >= 1
    assert "+26.67" in html  # 1.9 over 1.5
    assert str(tmp_path) not in html


def test_the_colour_scale_is_symmetric_and_leaves_out_the_largest() -> None:
    values = np.array([*np.linspace(-0.1, 0.1, 99), 5.0, np.nan])
    assert colour_scale_limit(values) == pytest.approx(10.0, rel=0.05)
    assert colour_scale_limit(np.full(3, np.nan)) == 1.0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([str(PUBLISHED), PRINTER], "expected two robots of one mechanism, found linear_delta and corexy"),
        ([PRINTER, VORON, "--band", "10,400"], "--band is for measurements"),
        ([PRINTER, "modes.csv", "--grid", "x=0,y=0"], "--grid is for two robots"),
        ([PRINTER, "modes.csv", "--poses", "poses.csv"], "--poses is for two robots"),
        ([PRINTER, VORON, *GRID, "--poses", "poses.csv"], "exclude each other"),
        ([PRINTER, VORON, "--grid", "x=5:6:3,y=0.1"], "none among 3 (--grid)"),
        ([PRINTER, VORON, "--grid", "x=0:0.3:2000,y=0:0.3:2000"], "expected at most 1,000,000 poses"),
        ([PRINTER, "absent.toml"], "no such file"),
        ([PRINTER, VORON, "--json", VORON], "would replace its own input"),
    ],
)
def test_mistakes_are_one_line(arguments: list[str], message: str) -> None:
    assert message in refused("compare", *arguments)
