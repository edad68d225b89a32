"""The page of two measurements: its numbers are those of the JSON, and its picture shows what changed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from helpers.pages.browser import opened
from helpers.pages.page_reading import at, read
from pkmodes.cli import run
from pkmodes.loop.measured.compared import compare_measurements
from pkmodes.loop.updating.reading import read_any
from pkmodes.pages.plots.before_after import changes_of_modes

HEAD = "pose,x,y,z,frequency,sigma,mode\n"
#: The second mode at A fell by 10 %, by 25 standard deviations of the difference; the others stay within theirs.
BEFORE = HEAD + "A,0.6,0,-0.2,50,0.1,1\nA,0.6,0,-0.2,80,0.2,2\nB,0.5,0,-0.2,60,0.1,1\nB,0.5,0,-0.2,300,1,9\n"
AFTER = HEAD + "A,0.6,0,-0.2,50.05,0.1,1\nA,0.6,0,-0.2,72,0.25,2\nB,0.5,0,-0.2,60.02,0.1,1\n"


@pytest.fixture
def files(tmp_path: Path) -> tuple[Path, Path]:
    first, second = tmp_path / "before.csv", tmp_path / "after.csv"
    first.write_text(BEFORE)
    second.write_text(AFTER)
    return first, second


def test_two_measurements_have_a_page(files: tuple[Path, Path], tmp_path: Path) -> None:
    page, found = tmp_path / "page.html", tmp_path / "out.json"
    assert run(["compare", *map(str, files), "--report", str(page), "--json", str(found)]) == 0
    content, root = json.loads(found.read_text()), read(page.read_text(encoding="utf-8"))
    placed = [cell for cell in root.all("data") if cell.attributes.get("data-at")]
    assert len(placed) > 20
    for cell in placed:
        assert float(cell.attributes["value"]) == at(content, cell.attributes["data-at"])
    assert "80 Hz at A by \u221210 %" in root.by_id("summary").text
    assert "Only in before.csv: line 5." in root.by_id("alone").text
    assert str(tmp_path) not in page.read_text(encoding="utf-8")
    with opened(page, width=390) as browser:
        assert browser.findings() == []
        assert not browser.sideways
        assert browser.problems == []


def test_its_picture_has_every_change_with_its_error(files: tuple[Path, Path]) -> None:
    """Of 80 +- 0.2 and 72 +- 0.25 Hz: -10 %, and the root of the sum of squares, 0.320 Hz, is 0.400 % of 80 Hz."""
    columns = {
        column[0]: column[1:]
        for column in changes_of_modes(compare_measurements(*map(read_any, files))).table
    }
    points = [
        (series, float(f), float(change))
        for series, f, change in zip(
            columns["series"], columns["frequency in the first [Hz]"], columns["change [%]"], strict=True
        )
    ]
    assert [point[1:] for point in points if point[0] == "changed"] == [(80.0, pytest.approx(-10.0))]
    assert sorted(point[1] for point in points if point[0] == "within the errors") == [50.0, 60.0]
    ends = [change for series, f, change in points if f == 80.0 and series != "changed"]
    assert sorted(ends) == pytest.approx([-10.0 - 0.40020, -10.0 + 0.40020], abs=1e-4)
