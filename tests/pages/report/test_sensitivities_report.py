"""The report of sensitivities: its numbers are those of the JSON, and it is usable in a real browser."""

from __future__ import annotations

import json
import re
import tomllib
from html import unescape
from pathlib import Path

import pytest

import pkmodes
from helpers.pages.browser import opened
from helpers.pages.page_reading import at, read, shown
from pkmodes.cli import run
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.pages.report.sensitivities import sensitivities_report

ROBOT, POSE = "robots/corexy-printer.toml", "0.1,0.15"
FREE = ("--drives", "free")


def made(folder: Path, robot: str, pose: str, *more: str) -> tuple[Path, dict[str, object]]:
    files = ["--report", str(folder / "page.html"), "--json", str(folder / "page.json")]
    assert run(["sensitivities", robot, "--pose", pose, *files, *(more or FREE)]) == 0
    return folder / "page.html", json.loads((folder / "page.json").read_text())


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made(tmp_path_factory.mktemp("sensitivities"), ROBOT, POSE)[0]


def test_its_numbers_are_those_of_the_json(page: Path) -> None:
    content = json.loads((page.parent / "page.json").read_text())
    found = [
        one for one in read(page.read_text(encoding="utf-8")).all("data") if one.attributes.get("data-at")
    ]
    assert len(found) > 15
    for one in found:
        exact = at(content, one.attributes["data-at"])
        assert float(one.attributes["value"]) == exact
    rows = [one for one in found if one.attributes["data-at"].startswith("/relative_derivatives")]
    for one in rows:
        value, half = shown(one.text)
        assert abs(value - float(one.attributes["value"])) <= 1.01 * half


def test_frequencies_have_their_standard_deviations_in_the_head(page: Path) -> None:
    sigmas = pkmodes.load(ROBOT).frequency_sigmas([0.1, 0.15], drives="free")[-2:]
    head = read(page.read_text(encoding="utf-8")).by_id("summary")
    facts = dict(zip((one.text for one in head.all("dt")), (one.text for one in head.all("dd")), strict=True))
    assert facts["mode 1 [Hz]"] == f"106.3 \u00b1 {sigmas[0]:.1f}"
    assert facts["mode 2 [Hz]"] == f"124.9 \u00b1 {sigmas[1]:.1f}"


def test_parameters_that_act_as_one_are_one_row(page: Path) -> None:
    text = read(page.read_text(encoding="utf-8")).by_id("percent").text
    assert "belt.specific_stiffness, belt.width" in text
    assert "act as one" in text


def test_without_standard_deviations_it_says_how_to_state_them(tmp_path: Path) -> None:
    file, _ = made(tmp_path, "robots/linear-delta-2022.toml", "0.6,0,-0.245", "--drives", "held")
    text = unescape(file.read_text(encoding="utf-8"))
    assert "The robot file states no standard deviations." in text
    assert "motors held" in text
    assert "\u00b1" not in text


def test_it_has_the_largest_also_where_others_were_asked_for(tmp_path: Path) -> None:
    file, content = made(tmp_path, ROBOT, POSE, "--parameters", "gantry.mass", *FREE)
    assert content["parameters"] == ["gantry.mass"]
    assert "pulley.radius" in file.read_text(encoding="utf-8")


def test_the_same_input_gives_the_same_bytes(page: Path, tmp_path: Path) -> None:
    again, _ = made(tmp_path, ROBOT, POSE)
    assert again.read_bytes() == page.read_bytes()
    assert str(tmp_path) not in again.read_text(encoding="utf-8")


def test_further_modes_are_folded(tmp_path: Path) -> None:
    """Twelve modes make twelve panels, and two tables."""
    page, _ = made(tmp_path, "robots/hexaglide.toml", "0.01,0,0.2,0.05,-0.03,0.02")
    sections = {section.attributes["id"]: section for section in read(page.read_text("utf-8")).all("section")}
    assert [name for name, section in sections.items() if section.all("details")] == ["percent-further"]
    assert len(sections["percent"].all("table")) == len(sections["percent-further"].all("table")) == 1
    assert "mode 6" in sections["percent"].text
    assert "mode 7" not in sections["percent"].text


def headline_of(folder: Path, robot: str, pose: str, *more: str) -> str:
    page, _ = made(folder, robot, pose, *more)
    (headline,) = read(page.read_text("utf-8")).by_id("summary").all("h2")
    return headline.text


def test_equal_changes_are_told_in_the_headline(tmp_path: Path) -> None:
    """f = sqrt(k / m) / (2 pi): one per cent of a mass, or of both stiffnesses, is half a per cent of f."""
    assert headline_of(tmp_path, "robots/bed-slinger.toml", "0.08,0.03", "--drives", "held") == (
        "Three quantities change a frequency most, and alike, for +1 % of each: mass of the tool head, \u22120.5 % "
        "of mode 2; mass of the bed, \u22120.5 % of mode 1; specific stiffness of each belt or width of each belt, "
        "+0.5 % of every frequency"
    )


def test_one_quantity_that_changes_all_frequencies_alike_is_told_of_all(tmp_path: Path) -> None:
    """The legs are the only springs of a hexapod: all frequencies go with the root of their stiffness."""
    assert headline_of(tmp_path, "robots/hexapod.toml", "0,0,0.26,0,0,0") == (
        "Every frequency depends most on the stiffness of the transmission of each leg (leg.stiffness): +0.5 % of "
        "the frequency for +1 %"
    )


def test_axes_that_symmetry_makes_equal_are_each_named(capsys: pytest.CaptureFixture[str]) -> None:
    """On its axis of symmetry, a delta vibrates sideways with 2/3 of the strain energy in one reducer at most.

    With the arms held only the reducers strain, and f goes with the root of the stiffness.
    """
    paths = ",".join(f"axis.{k}.reducer.stiffness" for k in (1, 2, 3))
    arguments = ["--pose", "0,0,-0.5", "--parameters", paths, "--drives", "held"]
    assert run(["sensitivities", "robots/clavel-delta.toml", *arguments]) == 0
    headline = " ".join(capsys.readouterr().out.split()).partition(" The largest change")[0]
    clauses = [f"torsional stiffness of reducer {k}, seen at the arm, +0.33 % of mode 2" for k in (1, 2, 3)]
    assert headline == (
        "clavel-delta, motors held: Of the chosen quantities, three change a frequency most, and alike, for +1 % of "
        f"each: {'; '.join(clauses)}"
    )


def test_modes_that_coincide_are_named(tmp_path: Path) -> None:
    file, _ = made(tmp_path, "robots/clavel-delta.toml", "0,0,-0.8")
    assert "Modes 1, 2 coincide" in file.read_text(encoding="utf-8")


def test_no_request_leaves_it_and_nothing_complains(page: Path) -> None:
    with opened(page) as found:
        assert found.problems == []
        assert found.outside == []
        assert found.page.locator("figure .wide svg").count() == 2
    assert page.stat().st_size < 6_000_000


def test_it_fits_a_phone_and_axe_has_no_grave_findings(page: Path) -> None:
    with opened(page, width=360) as found:
        assert not found.sideways
        found.page.set_viewport_size({"width": 1280, "height": 900})
        assert found.findings_in_light_and_dark() == []


def test_a_hostile_name_is_harmless() -> None:
    name = "</script><script>alert(1)</script><img src=x onerror=alert(2)>"
    text = re.sub(r"^name = .*$", f"name = '{name}'", Path(ROBOT).read_text(encoding="utf-8"), flags=re.M)
    model = pkmodes.Model(robot_from_document(tomllib.loads(text), "hostile.toml"))
    content = {
        "robot": model.robot.name,
        "pose": [0.1, 0.15],
        "drives": "free",
        "rigid_modes": 2,
        "groups": [0, 1, 2, 3],
        "parameters": [],
        "frequencies_hz": [0.0, 0.0, 106.3, 124.9],
    }
    page = sensitivities_report(model, content)
    assert "<img src=x" not in page
    assert "<script>alert" not in page
