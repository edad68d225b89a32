"""The table of figures: another figure is an entry and a function."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import pkmodes
from pkmodes.cli import run
from pkmodes.pages.figures.pictures import PICTURES, PictureKind, RobotPlane, pictures
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.sheet import Sheet

ROOT = Path(__file__).parents[3]
SVG = {"svg": "http://www.w3.org/2000/svg", "dc": "http://purl.org/dc/elements/1.1/"}


def test_every_figure_is_in_the_documentation() -> None:
    text = (ROOT / "docs" / "how-to/figures.md").read_text(encoding="utf-8")
    table = text.partition("| file | shows |")[2].partition("\n\n")[0]
    assert re.findall(r"^\| `(\w+)` \|", table, re.M) == [kind.name for kind in PICTURES]


def torques(robot: RobotPlane) -> Drawing:
    """Draw the largest static torque of each pose."""

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(2.0)
        mesh = robot.plane.draw(panel, np.abs(robot.plane.dataset["static_torque"].values).max(axis=-1))
        sheet.colour_scale(mesh, "largest static torque [N m]")

    return Drawing(draw)


def test_another_figure_is_an_entry_and_a_function(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    entry = PictureKind("torques", "Static torques", "What the motors hold at rest.", torques)
    monkeypatch.setattr(import_module("pkmodes.pages.figures.pictures"), "PICTURES", (PICTURES[2], entry))
    grid = "x=0.01:0.29:4,y=0.01:0.29:4"
    assert run(["figures", "robots/corexy-printer.toml", "--out", str(tmp_path), "--grid", grid]) == 0
    assert capsys.readouterr().out.split() == [str(tmp_path / f"{n}.svg") for n in ("directions", "torques")]
    drawn = ElementTree.parse(tmp_path / "torques.svg")
    assert drawn.findtext(".//dc:title", namespaces=SVG) == "Static torques"
    words = [text.text for text in drawn.iterfind(".//svg:text", SVG)]
    assert "largest static torque [N m]" in words


@pytest.mark.parametrize(
    ("robot", "grid", "said", "at"),
    [
        (
            "linear-delta-2022",
            {"x": np.linspace(0.5, 0.6, 3), "y": np.linspace(0.0, 0.05, 2), "z": -0.245},
            ["In three dimensions.", "Anywhere."],
            "linear-delta-2022, motors free, z = \N{MINUS SIGN}245 mm.",
        ),
        (
            "corexy-printer",
            {"x": np.linspace(0.1, 0.2, 3), "y": np.linspace(0.1, 0.2, 2)},
            ["In a plane.", "Anywhere."],
            "corexy-printer",
        ),
    ],
)
def test_a_robot_that_moves_in_a_plane_has_its_own_description_where_there_is_one(
    monkeypatch: pytest.MonkeyPatch, robot: str, grid: dict[str, object], said: list[str], at: str
) -> None:
    empty = Drawing(lambda sheet: None)
    entries = (
        PictureKind("one", "One", "In three dimensions.", lambda _: empty, planar="In a plane."),
        PictureKind("other", "Other", "Anywhere.", lambda _: empty),
    )
    monkeypatch.setattr(import_module("pkmodes.pages.figures.pictures"), "PICTURES", entries)
    found = [picture.description for picture in pictures(pkmodes.load(ROOT / f"robots/{robot}.toml"), grid)]
    assert [text.partition(f" {robot}")[0] for text in found] == said
    assert all(at in text for text in found), found
