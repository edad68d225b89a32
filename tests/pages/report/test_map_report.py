"""The report of a map: its numbers are those of the summary, and it is usable in a real browser."""

from __future__ import annotations

import json
import re
import tomllib
from html import unescape
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.pages.browser import opened
from helpers.pages.page_reading import Element, read, source_of
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.machine.maps.poses import PoseGrid
from pkmodes.pages.report.map import map_report
from pkmodes.pages.report.map_summary import _headline

PLANE = ["--grid", "x=0.3:0.9:13,y=-0.1:0.1:9,z=-0.245"]
ROBOT = "robots/linear-delta-2022.toml"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("map")
    options = [*PLANE, "--report", str(folder / "map.html"), "--json", str(folder / "map.json")]
    assert run(["map", ROBOT, *options, "--out", str(folder / "map.nc")]) == 0
    return folder / "map.html"


def test_its_frequencies_are_those_of_the_json(page: Path) -> None:
    content = json.loads((page.parent / "map.json").read_text())
    text = unescape(page.read_text(encoding="utf-8"))
    assert len(content["modes"]) == 6
    for mode in content["modes"]:
        for end in ("minimum_hz", "maximum_hz"):
            assert f"{mode[end]:.3f}" in text
    assert "map.nc" in text
    assert str(page.parent) not in text


def test_its_figures_are_folded_and_its_first_sections_are_not(page: Path) -> None:
    sections = {
        one.attributes["id"]: one.attributes.get("class", "")
        for one in read(page.read_text(encoding="utf-8")).all("section")[1:]
        if "id" in one.attributes
    }
    assert {name for name, kind in sections.items() if kind == "folded"} == {"figures", "origin"}


def test_captions_have_a_minus_sign_like_the_rest(page: Path) -> None:
    text = unescape(page.read_text(encoding="utf-8"))
    assert "z = \u2212245 mm" in text
    assert "z = -245" not in text


def test_the_view_begins_in_the_middle_of_the_map(page: Path) -> None:
    view = read(page.read_text(encoding="utf-8")).by_id("view").text
    assert "at x = 600.0 mm, y = 0.0 mm, z = \u2212245.0 mm" in view


def test_large_counts_have_the_same_separator_everywhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pkmodes.pages.report.map._figure_sections", lambda *_: [])
    model = pkmodes.load(ROBOT)
    found = model.map({"x": np.linspace(0.3, 0.9, 60), "y": np.linspace(0.0, 0.1, 20), "z": -0.245})
    summary = read(map_report(model, found)).by_id("summary").text
    assert "1\u202f200" in summary
    assert not re.search(r"\d,\d", summary)


@pytest.mark.parametrize("mishap", [PkmodesError("cannot write", "here", "do"), KeyboardInterrupt()])
def test_a_report_that_fails_is_not_announced_and_the_map_is_kept(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    mishap: BaseException,
) -> None:
    def fail(*_: object) -> None:
        raise mishap

    monkeypatch.setattr("pkmodes.pages.report.map.map_report", fail)
    old, out = tmp_path / "map.html", tmp_path / "map.nc"
    old.write_text("older")
    code = run(["map", ROBOT, *PLANE, "--out", str(out), "--report", str(old)])
    captured = capsys.readouterr()
    assert code == (130 if isinstance(mishap, KeyboardInterrupt) else 2)
    assert (old.read_text(), out.is_file()) == ("older", True)
    assert f"wrote {old}" not in captured.out + captured.err
    if isinstance(mishap, KeyboardInterrupt):
        assert "the map is written; for its report run the command again with --overwrite" in captured.err


def test_each_frequency_stands_beside_where_it_is(page: Path) -> None:
    """Lowest and highest of each mode, and the place of each in mm."""
    content = json.loads((page.parent / "map.json").read_text())
    section = read(page.read_text(encoding="utf-8")).by_id("modes")
    groups, heads = section.all("thead")[0].all("tr")
    assert [cell.text for cell in groups.all("th")] == ["quantiles [Hz]", "lowest", "highest"]
    assert [cell.text for cell in heads.all("th")] == [
        *("mode", "2 %", "median", "98 %", "f [Hz]", "x [mm]", "y [mm]", "f [Hz]", "x [mm]", "y [mm]")
    ]
    for row, mode in zip(section.all("tbody")[0].all("tr"), content["modes"], strict=True):
        cells = [cell.text for cell in row.children if isinstance(cell, Element)]
        assert cells[0] == str(mode["mode"])
        assert cells[1:4] == [f"{mode[key]:.3f}" for key in ("quantile_2_hz", "median_hz", "quantile_98_hz")]
        for end, shown in (("minimum", cells[4:7]), ("maximum", cells[7:])):
            assert shown[0] == f"{mode[f'{end}_hz']:.3f}"
            place = [float(text.replace("\u2212", "-")) for text in shown[1:]]
            expected = [1e3 * mode[f"{end}_at"][name] for name in ("x", "y")]
            assert place == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        (
            {"counted": 50},
            "The lowest frequency of vibration lies between 42.000 and 58.000 Hz at 96 % of the poses",
        ),
        ({"counted": 49}, "The lowest frequency of vibration lies between 41.000 and 4000.000 Hz"),
        ({"counted": 500, "tracked": True}, "Mode 1 lies between 42.000 and 58.000 Hz at 96 % of the poses"),
        ({"counted": 1}, "The lowest frequency of vibration is 41.000 Hz"),
    ],
)
def test_the_headline_leaves_out_the_edge_where_there_are_enough_poses(
    changed: dict[str, object], expected: str
) -> None:
    first = {"minimum_hz": 41.0, "maximum_hz": 4000.0, "quantile_2_hz": 42.0, "quantile_98_hz": 58.0}
    content = {"modes": [first], "tracked": False, "ranges": {}, "dimensions": {}, **changed}
    assert _headline(content) == expected


def test_a_frequency_beyond_all_others_is_said_to_be_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pkmodes.pages.report.map._figure_sections", lambda *_: [])
    model = pkmodes.load("robots/linear-delta-2022-identified.toml")
    # At this x a belt span vanishes but for rounding (docs/how-to/maps.md).
    found = model.map({"x": [0.28, 0.6, 0.7, 0.8], "y": 0.0, "z": -0.32})
    page = read(map_report(model, found))
    assert float(found["frequency"].max()) > 1e7
    assert not re.search(r"\d{4}\.|\u200910[\u2070-\u209f\u00b9\u00b2\u00b3]", page.by_id("modes").text)
    assert "1 pose is near-singular and not in these numbers" in page.by_id("summary").text


def test_its_head_says_what_was_mapped(page: Path) -> None:
    content = json.loads((page.parent / "map.json").read_text())
    text = source_of(page)
    assert (
        "Mapped with motors free: x 300 to 900 mm (13 values), y \u2212100 to 100 mm (9 values), z \u2212245 mm."
        in text
    )
    low, high = content["modes"][0]["quantile_2_hz"], content["modes"][0]["quantile_98_hz"]
    assert f"lies between {low:.3f} and {high:.3f} Hz at 96 % of the poses" in text
    assert content["poses"] == 13 * 9
    assert content["valid"] == 110
    assert ">110 (94 %)<" in text
    assert "7 poses cannot be evaluated: a carriage is beyond its limits" in text


def test_no_request_leaves_it_and_nothing_complains(page: Path) -> None:
    with opened(page) as found:
        assert found.problems == []
        assert found.outside == []
        boxes = found.page.evaluate(
            "[...document.querySelectorAll('.plot > svg, .wide > svg')].map(s => [s.getBoundingClientRect().width, "
            "s.querySelectorAll('path, image').length])"
        )
        assert len(boxes) == 7
        assert all(width > 100 and drawn > 3 for width, drawn in boxes)
        assert found.page.locator(".pkview canvas").count() == 2
    assert page.stat().st_size < 6_000_000


def test_it_fits_a_phone_and_axe_has_no_grave_findings(page: Path) -> None:
    with opened(page, width=390) as found:
        assert not found.sideways
        found.page.set_viewport_size({"width": 1280, "height": 900})
        assert found.findings_in_light_and_dark() == []


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[PoseGrid]:
    """The planes in which the figures of the robot are drawn, instead of the figures."""
    planes: list[PoseGrid] = []

    def remember(model: pkmodes.Model, places: PoseGrid, **_: object) -> list[object]:
        planes.append(places)
        return []

    monkeypatch.setattr("pkmodes.pages.report.map.pictures", remember)
    return planes


@pytest.mark.usefixtures("drawn")
def test_sweeps_samples_and_poses_have_their_sections() -> None:
    """The same at every run; the figures of the robot are those of the page of a map without a sweep."""
    model = pkmodes.load("examples/closed_loop/robot.toml")
    poses = np.array([[0.6, 0.0, -0.245], [0.5, 0.02, -0.245], [0.7, 0.0, -0.24]])
    dataset = model.map(poses, sweep={"carriage.mass": [1.0, 1.5]}, samples=4)
    text = map_report(model, dataset)
    for section in ("Swept parameters", "Sampled robots", "Along the poses", "Over the working plane"):
        assert f">{section}</h2>" in text, section
    assert "platform.mass" in text
    assert text == map_report(model, dataset)


@pytest.mark.usefixtures("no_drawing")
def test_a_sweep_is_drawn_in_the_plane_that_was_swept(drawn: list[PoseGrid]) -> None:
    model = pkmodes.load(ROBOT)
    plane = {"x": np.linspace(0.4, 0.8, 9), "y": np.linspace(-0.1, 0.1, 7), "z": -0.2}
    sweep = {"platform.mass": [2.0, 1.0], "belt.width": [0.01, 0.02]}
    section = read(map_report(model, model.map(plane, sweep=sweep))).by_id("figures")
    titles = [figure.all("title")[0].text for figure in section.all("figure")]
    assert titles == [
        "Natural frequencies at platform.mass = 1 kg, belt.width = 0.01 m",
        "Natural frequencies at platform.mass = 2 kg, belt.width = 0.02 m",
    ]
    assert "in the plane z = \u2212200 mm" in section.text
    assert (
        "The robot as declared with platform.mass = 1.5 kg, belt.width = 0.015 m, its motors free"
        in section.text
    )
    assert drawn[0].axes["z"] == [-0.2]


@pytest.mark.usefixtures("no_drawing")
def test_a_volume_that_was_swept_is_drawn_in_a_plane_of_its_own(drawn: list[PoseGrid]) -> None:
    model = pkmodes.load(ROBOT)
    axes = {"x": np.linspace(0.4, 0.8, 5), "y": np.linspace(-0.1, 0.1, 4), "z": np.linspace(-0.3, -0.2, 3)}
    found = model.map(axes, sweep={"platform.mass": [1.0, 2.0]})
    section = read(map_report(model, found)).by_id("figures")
    mean = [np.nanmean(found["condition"].sel(z=z).values) for z in found["z"].values]
    best = float(found["z"].values[np.argmin(mean)])
    assert drawn[0].axes["z"] == [best]
    assert f"in the plane z = \u2212{-1e3 * best:.6g} mm" in section.text
    assert len(section.all("figure")) == 2


@pytest.mark.usefixtures("no_drawing")
@pytest.mark.parametrize("x", [0.6, np.linspace(0.5, 0.7, 3)])
def test_a_sweep_without_a_plane_says_so(drawn: list[PoseGrid], x: object) -> None:
    model = pkmodes.load(ROBOT)
    found = model.map({"x": x, "y": 0.0, "z": -0.245}, sweep={"platform.mass": [1.0, 2.0]})
    section = read(map_report(model, found)).by_id("figures")
    where = "at one pose" if isinstance(x, float) else "along x"
    assert f"The map is {where}: it has no plane to draw." in section.text
    assert drawn == []


def test_a_hostile_name_is_harmless() -> None:
    name = "</script><script>alert(1)</script><img src=x onerror=alert(2)>"
    text = Path("robots/corexy-printer.toml").read_text(encoding="utf-8")
    text = re.sub(r"^name = .*$", f"name = '{name}'", text, flags=re.M)
    model = pkmodes.Model(robot_from_document(tomllib.loads(text), "hostile.toml"))
    page = map_report(model, model.map({"x": [0.1, 0.2], "y": [0.1, 0.2]}))
    assert "<img src=x" not in page
    assert "<script>alert" not in page
