"""The still: the robot where the scene has it, in the viewer's colours, for paper and browsers without the viewer."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import pkmodes
from helpers.pages.browser import opened
from pkmodes.pages.view import page, scene
from pkmodes.pages.view.camera import camera
from pkmodes.pages.view.projection import rim
from pkmodes.pages.view.still import DARK_SCALE, LIGHT_SCALE, WIDTH, scale_colour, still_svg

ROBOTS = Path(__file__).parents[3] / "robots"
POSES = {
    "linear-delta-2022": [0.6, 0.0, -0.245],
    "clavel-delta": [0.0, 0.0, -0.55],
    "corexy-printer": [0.1, 0.2],
}


@pytest.mark.parametrize("name", POSES)
def test_every_element_is_drawn_inside_the_picture(name: str) -> None:
    shown = scene(pkmodes.load(ROBOTS / f"{name}.toml"), POSES[name])
    drawn = ElementTree.fromstring(still_svg(shown))
    _, _, width, height = (float(v) for v in drawn.attrib["viewBox"].split())
    assert width == WIDTH
    lines = [e for e in shown.elements if e.shape == "line"]
    found = [one for one in drawn.iter("polyline") if one.attrib["class"].startswith("line")]
    assert len(found) == len(lines)
    assert sum("spring" in one.attrib["class"] for one in found) == sum(e.spring >= 0 for e in lines)
    at = np.array(
        [[float(v) for v in pair.split(",")] for one in drawn for pair in one.get("points", "").split()]
    )
    assert (at > 0).all()
    assert (at < [width, height]).all()
    assert max(np.ptp(at, axis=0) / [width, height]) > 0.7, "the robot fills the picture"


def test_points_are_where_an_orthographic_camera_sees_them() -> None:
    """Lengths of lines in the picture have the ratios of their projections on the plane of the camera."""
    shown = scene(pkmodes.load(ROBOTS / "linear-delta-2022.toml"), POSES["linear-delta-2022"])
    view = camera(shown)
    np.testing.assert_allclose(view @ view.T, np.eye(3), atol=1e-15)
    lines = [e for e in shown.elements if e.shape == "line"]
    ghosts = [one for one in ElementTree.fromstring(still_svg(shown)) if one.get("class") == "ghost"]
    ratios = []
    for element, ghost in zip(lines, ghosts, strict=True):
        ends = shown.points[0, [element.points[0], element.points[-1]]]
        along = ends[1] - ends[0]
        length = np.sqrt(along @ along - (along @ view[2]) ** 2)
        pairs = [[float(v) for v in pair.split(",")] for pair in ghost.attrib["points"].split()]
        if length > 0.05:
            ratios.append(np.hypot(*np.subtract(pairs[-1], pairs[0])) / length)
    np.testing.assert_allclose(ratios, ratios[0], rtol=5e-3)  # coordinates have one decimal


def test_the_colours_are_those_of_the_viewer() -> None:
    palette = (files("pkmodes.pages.view") / "browser" / "palette.js").read_text(encoding="utf-8")
    scales = [tuple(re.findall(r'"(#\w+)"', one)) for one in re.findall(r"scale: \[(.*?)\]", palette)]
    assert scales == [LIGHT_SCALE, DARK_SCALE]
    assert [scale_colour(LIGHT_SCALE, share) for share in (-1.0, 0.0, 1.0, 2.0)] == [LIGHT_SCALE[0]] * 2 + [
        LIGHT_SCALE[-1]
    ] * 2
    assert scale_colour(("#000000", "#ffffff"), 0.2) == "#333333"


def test_a_rim_is_a_circle_about_the_axis_turned_by_the_angle() -> None:
    centre, axis = np.array([1.0, 2.0, 3.0]), np.array([0.0, 0.03, 0.04])
    still_rim, turned = rim(centre, axis, 0.0), rim(centre, axis, np.pi / 2)
    np.testing.assert_allclose(np.linalg.norm(still_rim - centre, axis=1), 0.05)
    np.testing.assert_allclose((still_rim - centre) @ axis, 0.0, atol=1e-16)
    unit = axis / 0.05
    np.testing.assert_allclose(turned[0] - centre, np.cross(unit, still_rim[0] - centre), atol=1e-15)


def test_a_page_opened_on_paper_has_the_still_and_its_title(tmp_path: Path) -> None:
    model = pkmodes.load(ROBOTS / "clavel-delta.toml")
    file = tmp_path / "page.html"
    file.write_text(page(scene(model, POSES["clavel-delta"])), encoding="utf-8")
    hertz = model.frequencies(POSES["clavel-delta"])[3]
    for script in (True, False):
        with opened(file, media="print", scheme="dark", java_script_enabled=script) as seen:
            assert seen.page.locator(".pkview-svg").is_visible()
            assert seen.page.locator('[data-part="title"]').inner_text() == f"Mode 1: {hertz:.2f} Hz"
            line = seen.page.locator(".pkview-svg .line").first
            assert line.evaluate("(one) => getComputedStyle(one).stroke") == "rgb(107, 122, 138)", "light"
            assert not seen.page.locator(".pkview-panel").is_visible()
